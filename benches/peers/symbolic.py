#!/usr/bin/env python3
"""How many equivalent profiles of the catalogue SymPy and this program find in closed form.

Both are given the thirty profiles of tests/data/profiles.json with symbolic positive parameters. SymPy integrates, piece by piece,
x f'(x sin t) over t and, if that fails, x f'(r)/sqrt(x^2 - r^2) over r; an answer counts if it contains no integral and its value at
a catalogue point agrees with the 40-digit reference to 1e-10.

Usage: benches/peers/symbolic.py PROGRAM [SECONDS for each integral, default 25]
"""
import json
import multiprocessing
import pathlib
import queue
import subprocess
import sys
import time

import sympy

DATA = pathlib.Path(__file__).resolve().parents[2] / "tests" / "data"
NAMES = {"ln": sympy.log}


def pieces(text, names):
    """Returns the pieces of a profile as expressions with their lower ends."""
    if not text.startswith("piecewise("):
        return [(sympy.sympify(text.replace("^", "**"), locals=names), sympy.Integer(0))]
    parts = [part.strip() for part in split(text[len("piecewise(") : -1])]
    values, ends = parts[0::2], ["0", *(part.split("<")[1] for part in parts[1::2])]
    return [(sympy.sympify(value.replace("^", "**"), locals=names), sympy.sympify(end, locals=names)) for value, end in zip(values, ends)]


def split(text):
    """Splits a text at its outermost commas."""
    depth, start = 0, 0
    for place, letter in enumerate(text):
        depth += (letter == "(") - (letter == ")")
        if letter == "," and depth == 0:
            yield text[start:place]
            start = place + 1
    yield text[start:]


def by_sympy(case, form, answers):
    """Puts the value of g at the last point of a case, or "open" if an integral is left."""
    x, t = sympy.symbols("x t", positive=True)
    names = {name: sympy.Symbol(name, positive=True) for name in [*case["params"], "r"]}
    r = names["r"]
    parts = pieces(case["f"], {**NAMES, **names})
    g = 0
    for (f, low), (_, high) in zip(parts, [*parts[1:], (None, x)]):
        slope = sympy.diff(f, r)
        if slope == 0:
            continue
        if form == "angle":
            low, high = sympy.asin(low / x), (sympy.pi / 2 if high == x else sympy.asin(high / x))
            g += sympy.integrate(x * slope.subs(r, x * sympy.sin(t)), (t, low, high))
        else:
            g += sympy.integrate(x * slope / sympy.sqrt(x**2 - r**2), (r, low, high))
    if g.has(sympy.Integral):
        answers.put("open")
        return
    values = {names[name]: sympy.Rational(value) for name, value in case["params"].items()}
    at = case["x"][-1]
    answers.put(complex(sympy.N(g.subs(values).subs(x, sympy.Rational(at)), 30)))


def in_time(case, form, seconds):
    answers = multiprocessing.Queue()
    process = multiprocessing.Process(target=by_sympy, args=(case, form, answers))
    start = time.time()
    process.start()
    try:
        outcome = answers.get(timeout=seconds)
    except queue.Empty:
        outcome = "no answer"
    process.kill()
    process.join()
    return outcome, time.time() - start


def main():
    program, seconds = sys.argv[1], float(sys.argv[2]) if len(sys.argv) > 2 else 25.0
    truth = json.loads((DATA / "truth.json").read_text())
    counts = {"sympy": 0, "sneddon": 0}
    print(f"SymPy {sympy.__version__}, at most {seconds:g} s for each integral")
    for case in json.loads((DATA / "profiles.json").read_text()):
        reference = float(truth[case["id"]]["g"][case["x"][-1]])
        for form in ["angle", "radius"]:
            outcome, took = in_time(case, form, seconds)
            if isinstance(outcome, complex):
                outcome = "closed" if abs(outcome - reference) < 1e-10 * abs(reference) else f"wrong: {outcome}"
            if outcome == "closed":
                break
        counts["sympy"] += outcome == "closed"
        start = time.time()
        answer = subprocess.run([program, "derive", case["f"], "--quantity", "g", "--json"], capture_output=True, text=True, check=True)
        status = json.loads(answer.stdout)["g"]["status"]
        counts["sneddon"] += status == "exact"
        print(f"{case['id']:28} SymPy {outcome[:40]:40} {took:6.1f} s   sneddon {status:8} {time.time() - start:6.2f} s", flush=True)
    print(counts)


if __name__ == "__main__":
    main()
