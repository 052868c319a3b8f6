#!/usr/bin/env python3
"""Writes force_of_depth.csv: F(d)/E* and a(d) of powers f = C r^n, 25 digits.

Run:  python3 tests/oracle/force_of_depth.py > tests/oracle/force_of_depth.csv      (needs mpmath 1.3; deterministic)

Each row: profile with C in place; d; F/E*; a.
"""
import random

from mpmath import gamma, mp, mpf, nstr, sqrt, pi

mp.dps = 40
chance = random.Random(24)
print("# profile; d; F/E*; a")
for n in ("289/3", "101/2", "22/7", "7/5", "17/10", "1001/1000", "2", "3", "76", "7/10"):
    p, _, q = n.partition("/")
    power = mpf(p) / mpf(q or 1)
    c = sqrt(pi) * power / 2 * gamma(power / 2) / gamma(power / 2 + mpf(1) / 2)
    for factor in ("3/1024", "3", "1000000"):
        numerator, _, denominator = factor.partition("/")
        scale = c * mpf(numerator) / mpf(denominator or 1)
        depth = 10 ** chance.uniform(-6, 3)
        a = (mpf(depth) / scale) ** (1 / power)
        force = 2 * power / (power + 1) * mpf(depth) * a
        print(f"{factor}*r^({n});{depth!r};{nstr(force, 25)};{nstr(a, 25)}")
