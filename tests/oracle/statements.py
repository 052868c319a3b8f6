#!/usr/bin/env python3
"""Writes statements.csv: what the rules' stated formulas are worth, to 30 digits, at random places.

Run:  cargo run --release -- rules --json | python3 tests/oracle/statements.py [COUNT] > tests/oracle/statements.csv
      (needs mpmath 1.3; deterministic; COUNT places per rule and quantity, 24 unless told)

Every stated g and F is first held against the quadrature of the definition, with f′ by differences of the pattern at
many digits, and every stated p against the quadrature of the stated g; a rule that fails stops the program. The
stated formulas then give the values, each at two precisions that must agree.
Each row: rule; quantity; arguments (name=value, exact doubles as repr prints them); value; condition number, which is
the sum of |v ∂ ln|value|/∂v| over all arguments v.
"""
import json
import math
import random
import re
import sys

from mpmath import mp, mpf, quad, sqrt, cos, sin, tan, asin, acos, atan, sinh, cosh, tanh, asinh, acosh, atanh, exp, ln
from mpmath import gamma, erf, erfi, besselj, besseli, struveh, struvel, ellipk, ellipe, ellipf, hyp1f1, hyp2f1, hyper
from mpmath import elliprc, elliprf, elliprd, elliprj, clsin, betainc, polylog, digamma, polygamma, fresnelc, fresnels

log = ln
COUNT = int(sys.argv[1]) if len(sys.argv) > 1 else 24
CHECKED = 2
END = 3.1


def dawson(z):
    return sqrt(mp.pi) / 2 * exp(-z * z) * erfi(z)


def piecewise(*parts):
    """Values and conditions in turn, the value beyond the last condition at the end; none is evaluated in vain."""
    for value, condition in zip(parts[::2], parts[1::2]):
        if condition():
            return value()
    return parts[-1]()


NAMES = {k: v for k, v in globals().items() if callable(v)}
NAMES |= {"arcsin": asin, "arctan": atan, "artanh": atanh, "abs": abs, "max": max, "min": min}


def arguments_of(text, start):
    """The top-level arguments of the call whose parenthesis opens at start, and the place behind it."""
    depth, parts, begin = 0, [], start + 1
    for place in range(start, len(text)):
        character = text[place]
        depth += character in "([" 
        depth -= character in ")]"
        if depth == 1 and character == ",":
            parts.append(text[begin:place])
            begin = place + 1
        if depth == 0:
            parts.append(text[begin:place])
            return parts, place + 1
    raise ValueError(text)


def translated(text):
    """The program's grammar as Python."""
    at = text.find("piecewise(")
    if at >= 0:
        parts, behind = arguments_of(text, at + len("piecewise"))
        lazy = ",".join(f"lambda: ({translated(part)})" for part in parts)
        return translated_plain(text[:at]) + f"piecewise({lazy})" + translated(text[behind:])
    return translated_plain(text)


def translated_plain(text):
    text = re.sub(r"(?<![A-Za-z_0-9.])(\d+\.?\d*(?:e[+-]?\d+)?)", r"mpf('\1')", text)
    text = text.replace("^", "**")
    return re.sub(r"\be\*\*", "mp.e**", re.sub(r"\bpi\b", "mp.pi", text))


class Formula:
    """A stated formula as a function of named values."""

    def __init__(self, text):
        self.text = text
        self.code = compile(translated(text), text, "eval")

    def __call__(self, values):
        found = eval(self.code, NAMES | {"mp": mp, "mpf": mpf} | values)
        found = mp.mpmathify(found)
        if isinstance(found, mp.mpc):
            if abs(found.imag) > mpf(10) ** (-mp.dps // 2) * abs(found.real):
                raise ValueError(f"{self.text} is complex at {values}")
            found = found.real
        if not mp.isfinite(found):
            raise ValueError(f"{self.text} is not finite at {values}")
        return found


def breakpoints(text, values):
    ends = [piece.split(",")[0] for piece in re.split(r"r\s*<=?", text)[1:]]
    return sorted(Formula(end)(values) for end in ends)


def integral(f, points):
    with mp.workdps(mp.dps + 10):
        return quad(f, points, maxdegree=9)


def slope_of(pattern):
    def slope(r, values):
        with mp.workdps(3 * mp.dps):
            return mp.diff(lambda s: pattern(values | {"r": s}), r, relative=True)
    return slope


def moment(pattern, values, x, power):
    slope = slope_of(pattern)
    inner = [b for b in breakpoints(pattern.text, values) if 0 < b < x]
    # r = x sin t, and t = u² at the near end, which tames powers of r.
    points = [mpf(0)] + [asin(b / x) for b in inner] + [mp.pi / 2]
    return integral(lambda t: (x * sin(t)) ** power * slope(x * sin(t), values), points)


def pressure(slope, pattern, values, r, a):
    """Over u, x = r cosh u, and above a kink over the root of the distance to it, at which g' may be infinite."""
    def rising(x):
        return mp.diff(lambda y: slope(values | {"x": y}), x, relative=True)
    with mp.workdps(8 * mp.dps):
        ends = [mpf(0)] + [acosh(b / r) for b in breakpoints(pattern.text, values) if r < b < a] + [acosh(a / r)]
    total = mpf(0)
    for begin, end in zip(ends, ends[1:]):
        def f(v):
            # Differences of the distance to the kink must be far below it.
            with mp.workdps(8 * mp.dps):
                return 2 * v * rising(r * cosh(begin + v * v))
        with mp.workdps(8 * mp.dps):
            width = sqrt(end - begin)
        total += integral(f, [mpf(0), width])
    return values["E"] / mp.pi * total


def is_reached(pattern, values, x):
    """True where f is real and finite up to x."""
    try:
        return all(mp.isfinite(pattern(values | {"r": mpf(x) * s})) for s in (mpf("0.3"), mpf("0.7"), mpf("0.99"), 1))
    except (ValueError, ZeroDivisionError):
        return False


def place(rng, lowest, last):
    """A radius: ordinary, tiny, large, or close above the last breakpoint."""
    kind = rng.random()
    if kind < 0.7:
        return rng.uniform(lowest + 0.02 * (END - lowest), END)
    if kind < 0.8:
        return lowest + math.exp(rng.uniform(math.log(1e-8), math.log(0.1)))
    if kind < 0.9:
        return math.exp(rng.uniform(math.log(END), math.log(60.0)))
    return last * (1 + math.exp(rng.uniform(math.log(1e-6), math.log(0.1)))) if last > 0 else rng.uniform(lowest, END)


def condition(formula, values):
    total = mpf(0)
    own = formula(values)
    for name, value in values.items():
        if name == "E" or value == 0:
            continue
        step = mpf(10) ** -18
        try:
            near = formula(values | {name: value * (1 + step)})
        except (ValueError, ZeroDivisionError):
            near = formula(values | {name: value * (1 - step)})
        total += abs((near - own) / (step * own))
    return total


def exact(values):
    return {name: mpf(value) for name, value in values.items()}


def rows_of(rule):
    rng = random.Random(rule["id"])
    mp.dps = 30
    pattern, slope, force = (Formula(t) for t in (rule["pattern"], rule["result"]["g"], rule["result"]["F"]))
    stress = Formula(rule["result"]["p"]) if rule["result"]["p"] else None
    quantities = [("g", slope), ("F", force)] + ([("p", stress)] if stress else [])
    for quantity, formula in quantities:
        done = tried = 0
        while done < COUNT and tried < 40 * COUNT:
            tried += 1
            drawn = {}
            for p in rule["parameters"]:
                drawn[p["name"]] = round(rng.uniform(p["lowest"], p["highest"]) * 1024) / 1024
            ends = [float(b) for b in breakpoints(rule["pattern"], exact(drawn))]
            x = place(rng, ends[0] if ends else 0.0, ends[-1] if ends else 0.0)
            checked = done < CHECKED
            if checked:
                x = rng.uniform((ends[-1] if ends else 0) * 1.1 + 0.2, END)
            if x in ends or not is_reached(pattern, exact(drawn), x):
                continue
            if quantity == "p":
                drawn |= {"r": x * rng.choice([rng.uniform(0.02, 0.98), rng.uniform(0.98, 1.0), rng.uniform(1e-3, 0.02)]), "a": x}
                if checked:
                    drawn["r"] = x * rng.uniform(0.2, 0.9)
            else:
                drawn["x" if quantity == "g" else "a"] = x
            values = exact(drawn) | {"E": mpf(1)}
            try:
                mp.dps = 50
                value = formula(values)
                mp.dps = 75
                again = formula(values)
                mp.dps = 40
                worth = condition(formula, values)
            except (ValueError, ZeroDivisionError):
                continue
            finally:
                mp.dps = 30
            if again == 0 or abs(value / again - 1) > mpf(10) ** -30 or not mpf("1e-290") < abs(again) < mpf("1e290"):
                continue
            if checked:
                mp.dps = 18
                held = exact(drawn) | {"E": mpf(1)}
                if quantity == "g":
                    other = values["x"] * moment(pattern, held, values["x"], 0)
                elif quantity == "F":
                    other = 2 * moment(pattern, held, values["a"], 2)
                else:
                    other = pressure(slope, pattern, held, values["r"], values["a"])
                size = abs(again)
                if abs(other - again) > mpf(10) ** -13 * size:
                    sys.exit(f"{rule['id']}: stated {quantity} is {again}, quadrature {other} at {drawn}")
                mp.dps = 30
            arguments = " ".join(f"{k}={v!r}" for k, v in drawn.items())
            yield f"{rule['id']},{quantity},{arguments},{mp.nstr(again, 30, strip_zeros=False)},{mp.nstr(worth, 3)}"
            done += 1


ONLY = sys.argv[2:]
print("rule,quantity,arguments,value,condition")
for entry in json.load(sys.stdin)["rules"]:
    if ONLY and entry["id"] not in ONLY:
        continue
    for line in rows_of(entry):
        print(line, flush=True)
    print(entry["id"], file=sys.stderr)
