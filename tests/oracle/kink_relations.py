#!/usr/bin/env python3
"""Looks for a closed form of J(b, r, a) = ∫ arccos(b/x)/√(x²−r²) dx from max(b, r) to a, the open part of the pressure of a kink.

Run:  python3 tests/oracle/kink_relations.py          (needs mpmath 1.3; six minutes; deterministic)

For three triples of rational b, r and a, PSLQ with 150 digits looks for integers up to 100 that combine J, elliptic integrals,
logarithms, arcs, some of their products, and dilogarithms to 0; it prints the relation, or "none".
"""
from mpmath import acos, acosh, asin, asinh, atan, atan2, clsin, cosh, ellipe, ellipf, ellipk, log, mp, mpf, pi, polylog, pslq, quad, sinh
from mpmath import sqrt, tanh

mp.dps = 150
TRIPLES = [("1/3", "1/5", 1), ("1/5", "1/3", 1), ("2/3", "1/2", "3/2")]
PRODUCTS = [(0, 3), (0, 4), (0, 5), (1, 3), (1, 4), (0, 10), (1, 10), (3, 5), (4, 5), (10, 5), (3, 3), (4, 4), (10, 10), (0, 0), (0, 1),
            (0, 2), (3, 10), (4, 10)]


def rational(text):
    above, _, below = str(text).partition("/")
    return mpf(above) / mpf(below or 1)


def arc_integral(b, r, a, big, small):
    sine = sqrt((big - small) * (big + small)) / big
    epsilon = atan2(sine, small / big)
    top = asinh(acosh(a / big) / epsilon)
    if b < r:
        height = lambda u: atan2(sqrt(sinh(u) ** 2 + sine**2), small / big)
    else:
        height = lambda u: 2 * atan(tanh(u / 2)) / sqrt(1 + (sine / sinh(u)) ** 2)
    count = 2 * int(top) + 2
    pieces = [top * i / count for i in range(count + 1)]
    return quad(lambda t: height(epsilon * sinh(t)) * epsilon * cosh(t) if t > 0 else mpf(0), pieces)


for b, r, a in (map(rational, triple) for triple in TRIPLES):
    big, small = max(b, r), min(b, r)
    phi, m = asin(sqrt((a - big) * (a + big) / ((a - small) * (a + small)))), (small / big) ** 2
    plain = [ellipf(phi, m), ellipk(m), ellipk(1 - m), pi, acos(b / a), acosh(a / r), log(b), log(2), ellipe(phi, m), ellipe(m),
             acos(small / big)]
    dilogarithms = [clsin(2, 2 * acos(b / a)), clsin(2, 2 * acos(small / big))]
    dilogarithms += [polylog(2, z) for z in (small / big, m, big / a, (small / a) ** 2, (big / a) ** 2)]
    basis = [arc_integral(b, r, a, big, small), *plain, *(plain[i] * plain[j] for i, j in PRODUCTS), *dilogarithms, mpf(1)]
    print(len(basis), "numbers:", pslq(basis, maxcoeff=100, maxsteps=200_000) or "none", flush=True)
