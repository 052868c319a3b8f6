#!/usr/bin/env python3
"""Writes chapter3.csv: 40-digit values of the results of the source's chapter 3.

Run:  python3 tests/oracle/chapter3.py          (needs mpmath 1.3; half a minute; deterministic)

Each row: profile, quantity, arguments (name=value, separated by spaces; exact doubles as repr prints them), value.
g is the quadrature of (3.27) and F that of (3.23), not their closed forms; p is the quadrature of (3.37) with its
edge term; depths and radii solve g(a) = d. E is 1 where it is not given.
"""
import random
import sys
from pathlib import Path

from mpmath import mp, mpf, mpc, quad, sqrt, pi, sin, cos, tan, findroot, diff, asin, cosh, acosh, nstr

mp.dps = 60
rng = random.Random(31)
rows = []

# name -> (parameters with intervals, f', breakpoint, largest a)
PROFILES = {
    "cone": ({"theta": (0.05, 1.2)}, lambda r, v: tan(v["theta"]), None, None),
    "paraboloid": ({"R": (0.3, 5.0)}, lambda r, v: r / v["R"], None, None),
    "power": ({"C": (0.2, 3.0), "n": (0.3, 7.0)}, lambda r, v: v["C"] * v["n"] * r ** (v["n"] - 1), None, None),
    "cone_paraboloid": (
        {"theta": (0.05, 1.2), "R": (0.3, 5.0)}, lambda r, v: tan(v["theta"]) + r / v["R"], None, None),
    "worn_paraboloid": ({"R": (0.3, 5.0), "b": (0.1, 2.0)}, lambda r, v: r / v["R"], "b", None),
    "sphere": ({"R": (0.3, 5.0)}, lambda r, v: r / sqrt((v["R"] - r) * (v["R"] + r)), None, "R"),
}


def slope(name, v, x):
    _, prime, start, _ = PROFILES[name]
    b = v[start] if start else mpf(0)
    if "n" in v:  # t = u^(1/n) removes the power at the tip
        k = 1 / v["n"]
        return x * quad(lambda u: prime(x * sin(u ** k), v) * k * u ** (k - 1), [0, (pi / 2) ** v["n"]])
    return x * quad(lambda t: prime(x * sin(t), v), [asin(b / x), pi / 2])


def force(name, v, a):
    _, prime, start, _ = PROFILES[name]
    b = v[start] if start else mpf(0)
    return 2 * quad(lambda t: (a * sin(t)) ** 2 * prime(a * sin(t), v), [asin(b / a), pi / 2])


def slope_prime(name, v, x):
    """g' of the chapter's closed g."""
    if name == "cone":
        return pi / 2 * tan(v["theta"])
    if name == "paraboloid":
        return 2 * x / v["R"]
    if name == "power":
        n = v["n"]
        return v["C"] * sqrt(pi) / 2 * n * mp.gamma(n / 2) / mp.gamma(n / 2 + mpf(1) / 2) * n * x ** (n - 1)
    if name == "cone_paraboloid":
        return pi / 2 * tan(v["theta"]) + 2 * x / v["R"]
    if name == "worn_paraboloid":
        w = sqrt((x - v["b"]) * (x + v["b"]))
        return (w + x * x / w) / v["R"]
    return mp.atanh(x / v["R"]) + x * v["R"] / ((v["R"] - x) * (v["R"] + x))


def pressure(name, v, r, a):
    start = PROFILES[name][2]
    low = max(r, v[start]) if start else r
    if low == r:
        return quad(lambda u: slope_prime(name, v, r * cosh(u)), [0, acosh(a / r)]) / pi
    # x = b cosh u: g' dx = (w^2 + x^2)/R du, without the root of g' at b
    def inside(u):
        x, w = low * cosh(u), low * mp.sinh(u)
        return (w * w + x * x) / v["R"] / sqrt((x - r) * (x + r))
    return quad(inside, [0, acosh(a / low)]) / pi


def draw(name):
    return {key: rng.uniform(*ends) for key, ends in PROFILES[name][0].items()}


def row(name, quantity, v, value):
    rows.append(f"{name},{quantity},{' '.join(f'{k}={x!r}' for k, x in v.items())},{nstr(value, 40, strip_zeros=False)}")


def exact(v):
    return {k: mpf(x) for k, x in v.items()}


for name, (_, _, start, end) in PROFILES.items():
    for _ in range(12):
        v = draw(name)
        big = exact(v)
        if end:
            a = v[end] * rng.uniform(0.05, 0.98)
        elif start:
            a = v[start] * (1 + rng.choice([1e-9, 1e-3, 0.3, 3.0]) * rng.uniform(0.5, 2))
        else:
            a = rng.uniform(0.05, 4.0)
        row(name, "g", v | {"x": a}, slope(name, big, mpf(a)))
        row(name, "F", v | {"a": a}, force(name, big, mpf(a)))
        r = a * rng.uniform(0.02, 0.98)
        row(name, "p", v | {"r": r, "a": a}, pressure(name, big, mpf(r), mpf(a)))
        d = float(slope(name, big, mpf(a)))
        if start:
            square = big["b"] ** 2
            radius = sqrt((square + sqrt(square ** 2 + (2 * big["R"] * mpf(d)) ** 2)) / 2)
        else:
            radius = findroot(lambda z: (slope(name, big, z) - mpf(d)).real, (mpf(a), mpf(a) * (1 + mpf(10) ** -20)),
                              tol=mpf(10) ** -100, verify=False)
        assert abs(slope(name, big, radius) / mpf(d) - 1) < mpf(10) ** -42, (name, v, a)
        row(name, "a(d)", v | {"d": d}, radius)
        row(name, "F(d)", v | {"d": d}, force(name, big, radius))

# Table 3.1, (3.16)
for n in [0.5, 1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0, 8.0, 9.0, 10.0]:
    row("table", "kappa", {"n": n}, mp.quad(lambda t: mpf(n) * sin(t) ** (mpf(n) - 1), [0, pi / 2]) if n >= 1 else
        sqrt(pi) / 2 * mpf(n) * mp.gamma(mpf(n) / 2) / mp.gamma(mpf(n) / 2 + mpf(1) / 2))
# (3.2)
for _ in range(12):
    v = {"E1": rng.uniform(1, 300), "nu1": rng.uniform(-0.9, 0.5), "E2": rng.uniform(1, 300), "nu2": rng.uniform(-0.9, 0.5)}
    b = exact(v)
    row("two bodies", "E", v, 1 / ((1 - b["nu1"] ** 2) / b["E1"] + (1 - b["nu2"] ** 2) / b["E2"]))
# (3.65) with (3.66)-(3.69), complex where I0 < 0
count = {True: 0, False: 0}
while min(count.values()) < 10:
    v = {"c11": rng.uniform(1, 5), "c12": rng.uniform(0, 0.9), "c13": rng.uniform(-0.5, 0.9), "c33": rng.uniform(1, 5), "c44": rng.uniform(0.1, 3)}
    b = exact(v)
    if (b["c11"] + b["c12"]) * b["c33"] <= 2 * b["c13"] ** 2:
        continue
    mean = sqrt(b["c11"] * b["c33"])
    i0 = mean - b["c13"] - 2 * b["c44"]
    if count[i0 < 0] >= 10:
        continue
    count[i0 < 0] += 1
    under = 4 * b["c33"] * b["c44"]
    one = sqrt(mpc((mean - b["c13"]) * (2 * mean - i0) / under))
    two = sqrt(mpc((mean + b["c13"]) * i0 / under))
    value = 2 * (mean ** 2 - b["c13"] ** 2) / (mean * ((one + two) + (one - two)))
    assert abs(value.imag) < mpf(10) ** -45
    row("transverse", "E", v, value.real)

target = Path(__file__).with_name("chapter3.csv")
target.write_text("profile,quantity,arguments,value\n" + "\n".join(rows) + "\n")
print(f"{len(rows)} rows", file=sys.stderr)
