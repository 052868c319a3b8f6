#!/usr/bin/env python3
"""Writes rules.csv: 28-digit values of what the rules answer, at ordinary and at extreme arguments.

Run:  python3 tests/oracle/rules.py            (needs mpmath 1.3; a few minutes; deterministic)

Each row: case, quantity, arguments (name=value, separated by spaces; exact doubles as repr prints them), value.
Every value is the quadrature of the definition, with r = x cos(s) or x = r cosh(u), which leave no root at an end:
g(x) = x int f'(r)/sqrt(x^2-r^2) dr, F(a) = 2 int r^2 f'(r)/sqrt(a^2-r^2) dr, p(r) = (1/pi) int g'(x)/sqrt(x^2-r^2) dx, E = 1.
A second quadrature of a higher degree must agree to 28 digits, or the program stops.
"""
import math
import random
import sys
from pathlib import Path

from mpmath import mp, mpf, quad, sqrt, pi, cos, cosh, atan, atanh, gamma, nstr

mp.dps = 42
rng = random.Random(77)
rows = []


def sure(f, start, end):
    """The quadrature, with panels that shrink towards both ends, in two different partitions."""
    values = []
    # mpmath stops at an absolute error: the integrand is brought to the size of 1 first.
    size = quad(f, [start, (start + end) / 2, end], maxdegree=5)
    for steps in ([1e-2, 1e-5], [2e-3]):
        span = end - start
        points = [start] + [start + span * mpf(s) for s in reversed(steps)] + [end - span * mpf(s) for s in steps] + [end]
        values.append(size * quad(lambda y: f(y) / size, points, maxdegree=9))
    assert abs(values[0] - values[1]) <= mpf(10) ** -28 * abs(values[0]), (values, start, end)
    return values[0]


def moment(over_r, b, c, x, power):
    """int_b^min(c,x) r^power f'(r)/sqrt(x^2-r^2) dr from f'(r)/r, with r = x cos(s)."""
    def angle(end):
        return mp.atan2(sqrt((x - end) * (x + end)), end)
    low = mpf(0) if c is None or c >= x else angle(c)
    return sure(lambda s: over_r(x * cos(s)) * (x * cos(s)) ** (power + 1), low, angle(b))


def row(case, quantity, v, value):
    rows.append(f"{case},{quantity},{' '.join(f'{k}={x!r}' for k, x in v.items())},{nstr(value, 30, strip_zeros=False)}")


def logu(low, high):
    return math.exp(rng.uniform(math.log(low), math.log(high)))


def both(case, v, over_r, b, c, x):
    """g and F at one place."""
    row(case, "g", v | {"x": x}, mpf(x) * moment(over_r, b, c, mpf(x), 0))
    row(case, "F", v | {"a": x}, 2 * moment(over_r, b, c, mpf(x), 2))


def pressure(prime, r, a):
    """For a smooth g, with x = r cosh(u)."""
    return sure(lambda u: prime(r * cosh(u)), mpf(0), mp.acosh(a / r)) / pi


def fraction():
    """A part of 1, near 0, near 1, or between."""
    return rng.choice([logu(1e-8, 1e-1), rng.uniform(0.05, 0.95), 1 - logu(1e-12, 1e-1)])


COUNT = 24

for _ in range(COUNT):  # C r^n, n from 0.01 to 300
    n, C = rng.choice([logu(0.01, 1), rng.uniform(1, 12), float(rng.randint(1, 40)), logu(10, 300)]), rng.uniform(0.1, 4)
    x = logu(1e-8, 1e8) ** min(1.0, 12 / n)
    v, N = {"C": C, "n": n}, mpf(n)
    # 1 - y^2 = sin(phi)^n removes the power at the tip: n sin^(n-1) cos dphi = -2 y dy
    unit = sure(lambda y: 2 / sqrt(2 - y * y) if n == 1 else
                2 * y / sqrt(-mp.expm1(2 / N * mp.log1p(-y * y))), mpf(0), mpf(1))
    unit2 = sure(lambda y: 2 * y * (1 - y * y) ** (2 / N) / sqrt(-mp.expm1(2 / N * mp.log1p(-y * y))), mpf(0), mpf(1))
    if n == 1:
        unit, unit2 = pi / 2, pi / 4
    row("power", "g", v | {"x": x}, mpf(C) * mpf(x) ** N * unit)
    row("power", "F", v | {"a": x}, 2 * mpf(C) * mpf(x) ** (N + 1) * unit2)
    r = x * fraction()
    kappa = sqrt(pi) * gamma(N / 2 + 1) / gamma(N / 2 + mpf(1) / 2)
    row("power", "p", v | {"r": r, "a": x}, pressure(lambda z: mpf(C) * N * kappa * z ** (N - 1), mpf(r), mpf(x)))

for _ in range(COUNT):  # A (r-b) + C (r^2-b^2) beyond b
    b, A, C = rng.uniform(0.1, 3), rng.uniform(0.1, 2), rng.uniform(0.1, 2)
    x = rng.choice([b * (1 + logu(1e-13, 1e-2)), b * rng.uniform(1.01, 4), b * logu(4, 1e7)])
    both("segment", {"A": A, "C": C, "b": b}, lambda r: A / r + 2 * mpf(C), mpf(b), None, x)

for k in [1, 2, 3, 5, 8]:  # (r-b)^k beyond b
    for _ in range(6):
        b = rng.uniform(0.1, 3)
        x = rng.choice([b * (1 + logu(1e-13, 1e-2)), b * rng.uniform(1.01, 4), b * logu(4, 1e7)])
        both("shifted", {"k": float(k), "b": b}, lambda r: k * (r - mpf(b)) ** (k - 1) / r, mpf(b), None, x)

for k in [1, 2, 3, 4, 7, 12]:  # r^k between b and c
    for _ in range(6):
        b = rng.uniform(0.1, 3)
        c = rng.choice([b * (1 + logu(1e-10, 1e-1)), b * rng.uniform(1.1, 4), b * logu(4, 1e3)])
        x = rng.choice([c * (1 + logu(1e-12, 1e-1)), c * rng.uniform(1.1, 4), c * logu(4, 1e5), b + (c - b) * rng.uniform(0.01, 0.99)])
        if x > b:
            both("between", {"k": float(k), "b": b, "c": c}, lambda r: k * r ** (k - 2), mpf(b), mpf(c), x)

for _ in range(COUNT):  # C (r^2-b^2) beyond b: the closed pressure
    b, C = rng.uniform(0.1, 3), rng.uniform(0.1, 2)
    a = rng.choice([b * (1 + logu(1e-10, 1e-2)), b * rng.uniform(1.01, 4), b * logu(4, 1e5)])
    r = rng.choice([b * fraction(), b + (a - b) * fraction()])
    B, A, R = mpf(b), mpf(a), mpf(r)
    M = max(B, R)

    def inside(u):  # x = M cosh(u)
        x = M * cosh(u)
        if R < B:
            w = B * mp.sinh(u)
            return 2 * mpf(C) * (w * w + x * x) / sqrt((x - R) * (x + R))
        w = sqrt((x - B) * (x + B))
        return 2 * mpf(C) * (w + x * x / w)
    row("worn", "p", {"C": C, "b": b, "r": r, "a": a}, sure(inside, mpf(0), mp.acosh(A / M)) / pi)

for sign, case in ((-1, "sphere"), (1, "hyperboloid")):
    for _ in range(COUNT):
        h, R = rng.uniform(0.1, 4), logu(0.1, 10)
        x = R * (fraction() if sign < 0 else logu(1e-8, 1e8))
        H, B = mpf(h), mpf(R)

        def over_r(r):
            root = (B - r) * (B + r) if sign < 0 else B * B + r * r
            return H / B / sqrt(root)
        name = "R" if sign < 0 else "b"
        both(case, {"h": h, name: R}, over_r, mpf(0), None, x)
        r = x * fraction()
        if sign < 0:
            prime = lambda z: H / B * (atanh(z / B) + z * B / ((B - z) * (B + z)))
        else:
            prime = lambda z: H / B * (atan(z / B) + z * B / (B * B + z * z))
        row(case, "p", {"h": h, name: R, "r": r, "a": x}, pressure(prime, mpf(r), mpf(x)))

for _ in range(COUNT):  # h (sqrt(R^2-b^2) - sqrt(R^2-r^2)) beyond b
    h, R = rng.uniform(0.1, 4), rng.uniform(0.5, 6)
    b = R * fraction()
    x = b + (R - b) * rng.choice([logu(1e-10, 1e-2), rng.uniform(0.01, 0.99), 1 - logu(1e-9, 1e-2)])
    if b < x < R:
        H, B = mpf(h), mpf(R)
        both("worn_sphere", {"h": h, "R": R, "b": b}, lambda r: H / sqrt((B - r) * (B + r)), mpf(b), None, x)

for _ in range(COUNT):  # h (sqrt(b^2+r^2) - sqrt(b^2+c^2)) beyond c
    h, b, c = rng.uniform(0.1, 4), logu(1e-3, 1e3), rng.uniform(0.2, 2)
    x = rng.choice([c * (1 + logu(1e-12, 1e-2)), c * rng.uniform(1.01, 4), c * logu(4, 1e7)])
    H, B = mpf(h), mpf(b)
    both("worn_hyperboloid", {"h": h, "b": b, "c": c}, lambda r: H / sqrt(B * B + r * r), mpf(c), None, x)

target = Path(__file__).with_name("rules.csv")
target.write_text("case,quantity,arguments,value\n" + "\n".join(rows) + "\n")
print(f"{len(rows)} rows", file=sys.stderr)
