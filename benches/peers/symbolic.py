#!/usr/bin/env python3
"""How many equivalent profiles of the catalogue SymPy and this program find in closed form.

Both are given the thirty profiles of tests/data/profiles.json with symbolic positive parameters. SymPy integrates x f'(x sin t)
over t from 0 to pi/2, which it does better than x f'(r)/sqrt(x^2 - r^2) over r; an answer counts if it contains no integral
and its value at a catalogue point agrees with the 40-digit reference to 1e-10.

Usage: benches/peers/symbolic.py PROGRAM [SECONDS per profile, default 25]
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
NAMES = {"ln": sympy.log, "abs": sympy.Abs, "max": sympy.Max, "min": sympy.Min, "besselj": sympy.besselj}


def by_sympy(case, answers):
    """Puts the value of g at the last point of a case, or "open" if an integral is left."""
    x, t = sympy.symbols("x t", positive=True)
    names = {name: sympy.Symbol(name, positive=True) for name in [*case["params"], "r"]}

    def piecewise(*pieces):
        pairs = [(pieces[i], pieces[i + 1]) for i in range(0, len(pieces) - 1, 2)]
        return sympy.Piecewise(*pairs, (pieces[-1], True)) if len(pieces) % 2 else sympy.Piecewise(*pairs)

    f = sympy.sympify(case["f"].replace("^", "**"), locals={**NAMES, **names, "piecewise": piecewise})
    slope = sympy.diff(f, names["r"]).subs(names["r"], x * sympy.sin(t))
    g = sympy.integrate(x * slope, (t, 0, sympy.pi / 2))
    if g.has(sympy.Integral):
        answers.put("open")
        return
    values = {names[name]: sympy.Rational(value) for name, value in case["params"].items()}
    at = case["x"][-1]
    answers.put(complex(sympy.N(g.subs(values).subs(x, sympy.Rational(at)), 30)))


def in_time(case, seconds):
    answers = multiprocessing.Queue()
    process = multiprocessing.Process(target=by_sympy, args=(case, answers))
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
    print(f"SymPy {sympy.__version__}, at most {seconds:g} s for each profile")
    for case in json.loads((DATA / "profiles.json").read_text()):
        outcome, took = in_time(case, seconds)
        reference = float(truth[case["id"]]["g"][case["x"][-1]])
        if isinstance(outcome, complex):
            outcome = "closed" if abs(outcome - reference) < 1e-10 * abs(reference) else f"wrong: {outcome}"
        counts["sympy"] += outcome == "closed"
        start = time.time()
        answer = subprocess.run([program, "derive", case["f"], "--quantity", "g", "--json"], capture_output=True, text=True, check=True)
        status = json.loads(answer.stdout)["g"]["status"]
        counts["sneddon"] += status == "exact"
        print(f"{case['id']:28} SymPy {outcome[:40]:40} {took:6.1f} s   sneddon {status:8} {time.time() - start:6.2f} s", flush=True)
    print(counts)


if __name__ == "__main__":
    main()
