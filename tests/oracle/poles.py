#!/usr/bin/env python3
"""Writes poles.csv: g of profiles with a pole or an end, from the middle of the domain to a part 1e-10 before the end.

Run:  python3 tests/oracle/poles.py > tests/oracle/poles.csv      (needs mpmath 1.3; deterministic; 10 seconds)

Each row: profile; the end of the domain, 25 digits; x, an exact double; g(x) = x ∫₀^x f′(r)/√(x² − r²) dr, 25 digits.
f′ is written out by hand here, and the ends are solved by hand or found by mpmath.
"""
from mpmath import acosh, atanh, besselj, besseljzero, cos, cosh, digamma, exp, gamma, log, mp, mpf, nstr, pi, quad, sech, sin, sinh, sqrt, tan

mp.dps = 50
HALF, C = mpf(1) / 2, mpf("1.4")
CASES = [
    ("tan(r)", lambda r: 1 + tan(r) ** 2, pi / 2),
    ("tan(r/3)", lambda r: (1 + tan(r / 3) ** 2) / 3, 3 * pi / 2),
    ("1/cos(r)-1", lambda r: sin(r) / cos(r) ** 2, pi / 2),
    ("-ln(cos(r))", lambda r: tan(r), pi / 2),
    ("1/(2-exp(r))-1", lambda r: exp(r) / (2 - exp(r)) ** 2, log(2)),
    ("1/(3-cosh(2*r))", lambda r: 2 * sinh(2 * r) / (3 - cosh(2 * r)) ** 2, acosh(3) / 2),
    ("1/sin(1+r)", lambda r: -cos(1 + r) / sin(1 + r) ** 2, pi - 1),
    ("r^2/(1-1.4*tanh(r))", lambda r: 2 * r / (1 - C * tanh_(r)) + r * r * C * sech(r) ** 2 / (1 - C * tanh_(r)) ** 2, atanh(1 / C)),
    ("r^2/besselj(0,r)", lambda r: 2 * r / besselj(0, r) + r * r * besselj(1, r) / besselj(0, r) ** 2, besseljzero(0, 1)),
    ("gamma(2-r)", lambda r: -gamma(2 - r) * digamma(2 - r), mpf(2)),
    ("acos(1-r)-sqrt(2*r-r^2)", lambda r: 1 / sqrt(2 * r - r * r) - (1 - r) / sqrt(2 * r - r * r), mpf(2)),
    ("1-sqrt(1-(r-1/2)^2)", lambda r: (r - HALF) / sqrt(1 - (r - HALF) ** 2), mpf("1.5")),
    ("ln(1+r^2-r^4)", lambda r: (2 * r - 4 * r**3) / (1 + r * r - r**4), sqrt((1 + sqrt(5)) / 2)),
]


def tanh_(r):
    return sinh(r) / cosh(r)


print("# profile; end; x; g")
for text, slope, end in CASES:
    for gap in ("0.5", "1e-2", "1e-4", "1e-7", "1e-10"):
        x = float(end * (1 - mpf(gap)))
        places = [0] + [pi / 2 - mpf(10) ** -k for k in range(14)] + [pi / 2]
        found = mpf(x) * quad(lambda t: slope(mpf(x) * sin(t)), places)
        print(f"{text};{nstr(end, 25)};{x!r};{nstr(found, 25)}")
