#!/usr/bin/env python3
"""Writes energy.csv: the strain energy U/E* = ∫₀^a (d − g)² dx of smooth edges and of rims, 20 digits.

Run:  python3 tests/oracle/energy.py > tests/oracle/energy.csv      (needs mpmath 1.3; deterministic; 2 minutes)

Each row: profile; depth of a rim or nothing; a; U/E*.
f′ is written out by hand here; g is a quadrature over the angle, piece by piece, and U one over g between the breakpoints.
"""
from functools import lru_cache

from mpmath import asin, besselj, cos, exp, log, mp, mpf, nstr, pi, quad, sin, sqrt, struveh, tanh

mp.dps = 30
# Profile; pieces of f′ as (begin, end, f′); contact radii, and a depth where the edge is a rim.
ALL = None
CASES = [
    ("r^2/2", [(0, ALL, lambda r: r)], ("1e-6", "1", "300"), None),
    ("2*r", [(0, ALL, lambda r: mpf(2))], ("0.7",), None),
    ("r^1.5", [(0, ALL, lambda r: mpf(3) / 2 * sqrt(r))], ("0.01", "1"), None),
    ("sqrt(r)", [(0, ALL, lambda r: 1 / (2 * sqrt(r)))], ("1",), None),
    ("r^2.5+r^2", [(0, ALL, lambda r: mpf(5) / 2 * r ** mpf("1.5") + 2 * r)], ("1e-6", "0.5", "30"), None),
    ("r^2*ln(1+1/r)", [(0, ALL, lambda r: 2 * r * log(1 + 1 / r) - r / (1 + r))], ("0.5",), None),
    ("sqrt(1+r^2.5)-1", [(0, ALL, lambda r: mpf("1.25") * r ** mpf("1.5") / sqrt(1 + r ** mpf("2.5")))], ("0.5",), None),
    ("r^2/(1+sqrt(r))", [(0, ALL, lambda r: r * (2 + mpf("1.5") * sqrt(r)) / (1 + sqrt(r)) ** 2)], ("0.5",), None),
    ("r^2.3", [(0, ALL, lambda r: mpf(23) / 10 * r ** (mpf(13) / 10))], ("2",), None),
    ("ln(cosh(r))", [(0, ALL, tanh)], ("0.5", "1", "20"), None),
    ("1-sqrt(1-r^2)", [(0, ALL, lambda r: r / sqrt(1 - r * r))], ("0.5", "0.999"), None),
    ("1-exp(-r^2)", [(0, ALL, lambda r: 2 * r * exp(-r * r))], ("0.3", "0.9"), None),
    ("atan(r)", [(0, ALL, lambda r: 1 / (1 + r * r))], ("2",), None),
    ("r^2*besselj(0,r)", [(0, ALL, lambda r: 2 * r * besselj(0, r) - r * r * besselj(1, r))], ("1",), None),
    ("struveh(0,r)*r", [(0, ALL, lambda r: struveh(0, r) + r * (2 / pi - struveh(1, r)))], ("1",), None),
    ("r^2/2+0.01*sin(20*r)^2", [(0, ALL, lambda r: r + mpf("0.4") * sin(20 * r) * cos(20 * r))], ("1",), None),
    ("max(0,r-0.5)", [(mpf("0.5"), ALL, lambda r: mpf(1))], ("0.50001", "1", "40"), None),
    ("piecewise(0,r<0.7,(r^2-0.49)/2)", [(mpf("0.7"), ALL, lambda r: r)], ("0.7001", "1.3"), None),
    ("piecewise(r,r<0.8,2*r-0.8)", [(0, mpf("0.8"), lambda r: mpf(1)), (mpf("0.8"), ALL, lambda r: mpf(2))], ("0.5", "0.9", "3"), None),
    ("piecewise(r^2/2,r<0.3,0.045)", [(0, mpf("0.3"), lambda r: r)], ("0.4",), "0.2"),
    ("r^2/2", [(0, ALL, lambda r: r)], ("1",), "2.5"),
    ("-r^2/8", [(0, ALL, lambda r: -r / 4)], ("1",), "0.1"),
    ("0", [], ("1.5",), "0.25"),
]


def equivalent(pieces, x):
    total = mpf(0)
    for begin, end, slope in pieces:
        if x <= begin:
            continue
        low = asin(mpf(begin) / x)
        high = pi / 2 if end is ALL or end >= x else asin(end / x)
        # r = b + … has a root at b for √r, and the sphere one next to its end.
        total += quad(lambda s: slope(x * sin(low + (high - low) * s * s)) * 2 * s * (high - low), [0, 0.5, 1])
    return x * total


print("# profile; depth of a rim; a; U/E*")
for text, pieces, radii, depth in CASES:
    for radius in radii:
        a = mpf(float(radius))
        g = lru_cache(None)(lambda x: equivalent(pieces, x))
        d = g(a) if depth is None else mpf(float(depth))
        ends = sorted({mpf(0), a, *(b for piece in pieces for b in piece[:2] if b is not ALL and 0 < b < a)})
        total = mpf(0)
        for low, high in zip(ends, ends[1:]):
            # Beyond a breakpoint g starts like a root, on the axis like a power.
            total += d**2 * quad(lambda s: (1 - g(low + (high - low) * s**4) / d) ** 2 * 4 * s**3 * (high - low), [0, 0.4, 0.8, 1])
        print(f"{text};{depth or ''};{float(radius)!r};{nstr(total, 20)}", flush=True)
