#!/usr/bin/env python3
"""Writes precise.csv: 40-digit values of the elementary functions at arguments of two doubles.

Run:  python3 tests/oracle/precise.py            (needs mpmath 1.3; under a minute; deterministic)

Each row: function, arguments separated by ';' as high:low, value with 40 digits.
"""
import math
import random
from pathlib import Path

from mpmath import mp, mpf

mp.dps = 80
rng = random.Random(20261121)
rows = []


def two(value):
    """A value as two doubles: a random low word where a plain double comes in, else the nearest pair."""
    if isinstance(value, tuple):
        return value
    if isinstance(value, mpf):
        high = float(value)
        return high, float(value - mpf(high))
    if value == 0 or rng.random() < 0.15:
        return float(value), 0.0
    return float(value), rng.uniform(-0.49, 0.49) * math.ulp(value)


def add(name, f, *arguments):
    pairs = [two(a) for a in arguments]
    if any(abs(low) < 1e-290 and low != 0 for _, low in pairs):
        pairs = [(high, low if abs(low) > 1e-290 else 0.0) for high, low in pairs]
    exact = [mpf(high) + mpf(low) for high, low in pairs]
    with mp.workdps(400 if name in ("sin", "cos", "tan", "ln1p") else 120):
        value = f(*exact)
    # What is below 1e-280 has a subnormal low word; no relative promise is made there.
    if isinstance(value, mp.mpc) or not mp.isfinite(value) or not (value == 0 or mpf("1e-280") < abs(value) < mpf("1.7e308")):
        return
    text = ";".join(f"{high!r}:{low!r}" for high, low in pairs)
    rows.append(f"{name},{text},{mp.nstr(value, 40, min_fixed=0, max_fixed=0) if value else '0'}")


def log_uniform(a, b):
    return math.exp(rng.uniform(math.log(a), math.log(b)))


def signed(value):
    return value if rng.random() < 0.5 else -value


def spread(low, high, count):
    return [signed(log_uniform(low, high)) for _ in range(count)]


near_one = lambda: mpf(1) - mpf(2) ** -rng.uniform(1, 100)

for x in spread(1e-40, 700, 60) + [rng.uniform(-2, 2) for _ in range(40)] + [0.0, 1.0, 709.7, -640.0, 0.346, -0.347, 0.35, -0.35]:
    add("exp", mp.exp, x)
    add("expm1", mp.expm1, x)
    add("sinh", mp.sinh, x)
    add("cosh", mp.cosh, x)
    add("tanh", mp.tanh, x)
for x in spread(1e-270, 1e-20, 15):
    for name, f in (("expm1", mp.expm1), ("sinh", mp.sinh), ("tanh", mp.tanh), ("sin", mp.sin), ("tan", mp.tan), ("atan", mp.atan),
                    ("asin", mp.asin), ("asinh", mp.asinh), ("atanh", mp.atanh), ("ln1p", lambda z: mp.log(1 + z) if abs(z) > mpf("1e-100") else z - z * z / 2)):
        add(name, f, x)
add("sinh", mp.sinh, 710.4)
add("cosh", mp.cosh, -710.4)
for _ in range(80):
    add("ln", mp.log, log_uniform(1e-300, 1e300))
    add("ln", mp.log, rng.uniform(0.3, 3))
    add("ln", mp.log, 1 + signed(1) * mpf(2) ** -rng.uniform(1, 100))
    add("ln1p", mp.log1p, signed(log_uniform(1e-40, 0.999)))
    add("ln1p", mp.log1p, log_uniform(0.3, 1e300))
    add("ln1p", mp.log1p, -near_one())
for _ in range(60):
    for name, f in (("sin", mp.sin), ("cos", mp.cos), ("tan", mp.tan)):
        add(name, f, signed(log_uniform(1e-30, 10)))
        add(name, f, signed(log_uniform(1, 1e15)))
        # next to a multiple of pi/2, down to the last bit of the pair
        quarter = mp.pi / 2 * rng.choice([rng.randint(1, 20), rng.randint(1, 10**6), rng.randint(1, 10**14)])
        add(name, f, signed(1) * (quarter * (1 + rng.choice([0, mpf(2) ** -rng.uniform(20, 106)]))))
for _ in range(60):
    for name, f in (("asin", mp.asin), ("acos", mp.acos), ("atanh", mp.atanh)):
        add(name, f, rng.uniform(-1, 1))
        add(name, f, signed(log_uniform(1e-40, 1)))
        add(name, f, signed(1) * near_one())
    add("atan", mp.atan, rng.uniform(-3, 3))
    add("atan", mp.atan, signed(log_uniform(1e-40, 1e40)))
    add("asinh", mp.asinh, rng.uniform(-3, 3))
    add("asinh", mp.asinh, signed(log_uniform(1e-40, 1e300)))
    add("acosh", mp.acosh, log_uniform(1, 1e300))
    add("acosh", mp.acosh, 1 + log_uniform(1e-15, 10))
    add("acosh", mp.acosh, 1 + mpf(2) ** -rng.uniform(1, 100))
    add("atan2", mp.atan2, rng.uniform(-2, 2), rng.uniform(-2, 2))
    add("atan2", mp.atan2, signed(log_uniform(1e-150, 1e150)), signed(log_uniform(1e-150, 1e150)))
    add("atan2", mp.atan2, signed(log_uniform(1e-280, 1e-250)), signed(log_uniform(1e-280, 1e-250)))
    add("atan2", mp.atan2, signed(log_uniform(1e290, 1e307)), signed(log_uniform(1e290, 1e307)))
    add("sqrt", mp.sqrt, log_uniform(1e-270, 1e307))
    add("sqrt", mp.sqrt, rng.uniform(0, 4))
    # the error of a power grows with the logarithm of its value: small ones here, large ones below
    add("pow", lambda x, y: x**y, log_uniform(0.3, 4), rng.uniform(-4, 4))
    add("pow", lambda x, y: x**y, log_uniform(1e-3, 1e3), rng.choice([0.5, 1.5, -0.5, 2.5, -1.5]))
    add("pow large", lambda x, y: x**y, log_uniform(1e-30, 1e30), rng.uniform(-9, 9))
    add("pow large", lambda x, y: x**y, log_uniform(0.5, 2), rng.uniform(-600, 600))
    add("powi", lambda x, y: x**y, signed(log_uniform(0.1, 9)), (float(rng.randint(-12, 12)), 0.0))
    add("powi large", lambda x, y: x**y, signed(log_uniform(1e-9, 1e9)), (float(rng.randint(-60, 60)), 0.0))

Path(__file__).with_name("precise.csv").write_text("function,arguments,value\n" + "\n".join(rows) + "\n")
