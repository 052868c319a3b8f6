#!/usr/bin/env python3
"""Writes forms.csv: 40-digit values of the rows that stand for stable forms and have no place in the other tables.

Run:  python3 tests/oracle/forms.py          (needs mpmath 1.3; seconds; deterministic)

Each row: function, arguments separated by spaces (exact doubles as repr prints them), value. Every value is computed at
400 and at 600 digits, which must agree. Results stay inside the normal doubles.
"""
import math
import random
from pathlib import Path

import mpmath
from mpmath import mp, mpf, nstr

rng = random.Random(1771)
rows = []


def logu(low, high):
    return math.exp(rng.uniform(math.log(low), math.log(high)))


def above(x):
    """A number beyond x: next to it, of its size, or far out."""
    return x * (1 + rng.choice([logu(1e-15, 1e-3), rng.uniform(0.01, 3), logu(1, 1e6)]))


def add(name, arguments, function, count):
    found = 0
    while found < count:
        point = arguments()
        if point is None:
            continue
        values = []
        for digits in (400, 600):
            mp.dps = digits
            values.append(function(*map(mpf, point)))
        mp.dps = 60
        if not 2.3e-308 < abs(values[0]) < 1.79e308:
            continue
        assert abs(values[0] - values[1]) <= abs(values[1]) * mpf(10) ** -45, (name, point)
        rows.append(f"{name},{' '.join(map(repr, point))},{nstr(values[1], 40)}")
        found += 1


def near_one():
    """u and 1 + u: either small, where u has the digits, or so large that 1 + u has them."""
    u = rng.choice([logu(1e-300, 0.5), logu(0.5, 1e300), -logu(1e-300, 0.5), -rng.uniform(0.5, 1 - 1e-9)])
    return u, 1.0 + u


def leg(long, short):
    return mpmath.sqrt((long - short) * (long + short))


def capped_sphere_force(b, a, big):
    w, c = leg(a, b), leg(big, b)
    return ((big**2 + a**2) * mpmath.log((big + a) / (c + w)) - big * a + w * c) / 2


def outside_power(n, a, r):
    hyper = mpmath.hyp2f1(mpf(1) / 2, (n + 1) / 2, (n + 3) / 2, (a / r) ** 2)
    return a**n * mpmath.asin(a / r) - a ** (n + 1) / ((n + 1) * r) * hyper


def scaled(count):
    """An increasing sequence of lengths."""
    lengths = [logu(1e-30, 1e30)]
    while len(lengths) < count:
        lengths.append(above(lengths[-1]))
    return lengths if all(low < high for low, high in zip(lengths, lengths[1:])) else None


def of_a_power():
    pair = scaled(2)
    return pair and (rng.choice([rng.uniform(0.05, 3), float(rng.randint(1, 60)), logu(1e-3, 300)]), *pair)


add("ln_near_one", near_one, lambda u, v: mpmath.log(1 + u) if abs(u) < 0.5 else mpmath.log(v), 120)
add("power_near_one", lambda: (near_one()[0], logu(1e-3, 1e6)), lambda u, p: (1 + u) ** p, 120)
add("angle_from", lambda: scaled(2), lambda b, x: mpmath.acos(b / x), 120)
add("capped_sphere_force", lambda: scaled(3), capped_sphere_force, 120)
add("outside_power", of_a_power, outside_power, 120)
Path(__file__).with_name("forms.csv").write_text("function,arguments,value\n" + "\n".join(rows) + "\n")
print(f"{len(rows)} rows")
