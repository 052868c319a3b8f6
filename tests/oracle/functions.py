#!/usr/bin/env python3
"""Writes functions.csv: 40-digit values of the elementary and special functions of the table.

Run:  python3 tests/oracle/functions.py          (needs mpmath 1.3; seconds; deterministic)

Each row: function, arguments separated by spaces (exact doubles as repr prints them), value. Rows that special.csv
holds already are left out. Results stay inside the normal doubles.
"""
import math
import random
import sys
from pathlib import Path

from mpmath import mp, mpf, nstr
import mpmath

mp.dps = 60
rng = random.Random(99)
rows = []


def logu(low, high):
    return math.exp(rng.uniform(math.log(low), math.log(high)))


def signed(x):
    return x if rng.random() < 0.5 else -x


def near(x):
    return x * (1 + signed(logu(1e-15, 1e-3)))


wide = lambda: signed(logu(1e-300, 1e300))
small = lambda: signed(logu(1e-300, 1.0))
unit = lambda: rng.choice([small(), rng.uniform(-1, 1), signed(1 - logu(1e-15, 1e-2))])
ANY = {
    "exp": (mpmath.exp, lambda: rng.choice([rng.uniform(-700, 700), small()])),
    "ln": (mpmath.log, lambda: rng.choice([logu(1e-300, 1e300), near(1.0)])),
    "sin": (mpmath.sin, lambda: rng.choice([small(), rng.uniform(-30, 30), signed(logu(1, 1e15)), near(math.pi)])),
    "cos": (mpmath.cos, lambda: rng.choice([rng.uniform(-30, 30), signed(logu(1, 1e15)), near(math.pi / 2)])),
    "tan": (mpmath.tan, lambda: rng.choice([small(), rng.uniform(-30, 30), near(math.pi / 2), near(math.pi)])),
    "asin": (mpmath.asin, unit),
    "acos": (mpmath.acos, unit),
    "atan": (mpmath.atan, wide),
    "sinh": (mpmath.sinh, lambda: rng.choice([small(), rng.uniform(-700, 700), rng.uniform(-1, 1)])),
    "cosh": (mpmath.cosh, lambda: rng.choice([small(), rng.uniform(-700, 700)])),
    "tanh": (mpmath.tanh, lambda: rng.choice([small(), rng.uniform(-20, 20), rng.uniform(-1, 1)])),
    "asinh": (mpmath.asinh, lambda: rng.choice([wide(), rng.uniform(-3, 3)])),
    "acosh": (mpmath.acosh, lambda: rng.choice([1 + logu(1e-15, 1.0), logu(1, 1e300)])),
    "atanh": (mpmath.atanh, unit),
    "erf": (mpmath.erf, lambda: rng.choice([small(), rng.uniform(-6, 6)])),
    "gamma": (mpmath.gamma, lambda: rng.choice([rng.uniform(0.05, 5), rng.uniform(5, 170), logu(1e-300, 1)])),
}
for name, (function, draw) in ANY.items():
    count = 0
    while count < 60:
        x = draw()
        value = function(mpf(x))
        if mpmath.isinf(value) or not 2.3e-308 < abs(value) < 1.79e308:
            continue
        rows.append(f"{name},{x!r},{nstr(value, 40)}")
        count += 1
for _ in range(60):
    y, x = signed(logu(1e-20, 1e20)), signed(logu(1e-20, 1e20))
    rows.append(f"atan2,{y!r} {x!r},{nstr(mpmath.atan2(mpf(y), mpf(x)), 40)}")

target = Path(__file__).with_name("functions.csv")
target.write_text("function,arguments,value\n" + "\n".join(rows) + "\n")
print(f"{len(rows)} rows", file=sys.stderr)
