#!/usr/bin/env python3
"""Writes hypergeometric.csv: 45-digit values of the functions of hypergeometric type, and of gamma and elliptic ones.

Run:  python3 tests/oracle/hypergeometric.py     (needs mpmath 1.3; some minutes; deterministic)

Each row: function, arguments separated by spaces, value. An argument is a double as repr prints it, or two joined by a
colon: the nearest double and the double nearest to the rest, for tests with 30 digits. Values come from mpmath at
raised precision, or from the definition by quadrature where mpmath's method loses digits.
"""
import math
import random
import sys
from pathlib import Path

from mpmath import mp, mpf, nstr
import mpmath

mp.dps = 80
rng = random.Random(20261122)
rows = []


def uni(a, b):
    return rng.uniform(a, b)


def logu(a, b):
    return math.exp(rng.uniform(math.log(a), math.log(b)))


def sg(x):
    return x if rng.random() < 0.5 else -x


class Pair:
    """A number of two doubles."""

    def __init__(self, value):
        value = mpf(value)
        self.hi = float(value)
        self.lo = float(value - mpf(self.hi))

    def __float__(self):
        return self.hi


def exact(a):
    return mpf(a.hi) + mpf(a.lo) if isinstance(a, Pair) else mpf(a)


def text(a):
    return f"{a.hi!r}:{a.lo!r}" if isinstance(a, Pair) else repr(float(a))


def add(name, args, value):
    value = value(*[exact(a) for a in args]) if callable(value) else value
    if isinstance(value, mpmath.mpc):
        assert abs(value.imag) < 1e-60 * abs(value.real), (name, args, value)
        value = value.real
    if not mp.isfinite(value) or not (value == 0 or mpf("1e-290") < abs(value) < mpf("1e290")):
        return
    rows.append(f"{name},{' '.join(text(a) for a in args)},{nstr(value, 45, min_fixed=0, max_fixed=0) if value else '0'}")


def beta_interval(a, b, u, v):
    """From the definition, in the logit variable: smooth, whatever the ends."""
    if u == v:
        return mpf(0)
    with mp.workdps(100):
        if u > 0 and v < 1 and (v - u) < mpf(1) / 4 * min(u, 1 - v):
            return mp.quad(lambda t: t ** (a - 1) * (1 - t) ** (b - 1), [u, v])
        return mpmath.betainc(a, b, u, v)


def many_parameters():
    """Six and more upper parameters far out on the negative axis, as for r/(c + r^12): products of many gamma functions."""
    own = random.Random(20261123)
    for n in (6, 7, 8, 9, 12, 15):
        upper = [(1 + 2 * k) / (2 * n) for k in range(n)]
        lower = [k / n for k in range(1, n)]
        for _ in range(4):
            z = -math.exp(own.uniform(math.log(31), math.log(1e12)))
            add(f"hyper {n} {n - 1}", (*upper, *lower, z), lambda *a, n=n: mpmath.hyper(a[:n], a[n:-1], a[-1]))
        bent = [p + own.uniform(-0.02, 0.02) for p in upper]
        z = -math.exp(own.uniform(math.log(31), math.log(1e6)))
        add(f"hyper {n} {n - 1}", (*bent, *lower, z), lambda *a, n=n: mpmath.hyper(a[:n], a[n:-1], a[-1]))


def main():
    third, fifth = Pair(mpf(1) / 3), Pair(mpf(1) / 5)
    # gamma and its kin
    for x in [1e-150, 1e-30, 0.5, 1.0, 1.5, 2.0, 31.9, 32.0, 32.1, 100.25, 160.5, -0.5, -1.5, -2.0000000001, -7.3, -30.7, third]:
        add("gamma", (x,), mpmath.gamma)
        if float(x) > 0:
            add("digamma", (x,), lambda z: mpmath.psi(0, z))
    for _ in range(60):
        add("gamma", (rng.choice([uni(0.01, 5), uni(5, 165), -uni(0, 20)]),), mpmath.gamma)
        add("digamma", (rng.choice([logu(1e-100, 1), uni(0.1, 5), logu(5, 1e100), 1.4616321449683622 + sg(logu(1e-15, 1e-2))]),), lambda z: mpmath.psi(0, z))
    add("digamma", (1.4616321449683622,), lambda z: mpmath.psi(0, z))
    for m in [1, 2, 3, 4, 5, 7, 10, 20, 40, 80, 150]:
        for x in [1e-20, 1e-3, 0.3, 1.0, 2.5, 10.0, 33.0, 100.0, 1e4, 1e10, logu(0.1, 50), logu(0.1, 50)]:
            add("polygamma", (float(m), x), lambda m, z: mpmath.psi(int(m), z))
    for n in [-0.999, -0.5, -1e-10, 1e-200, 1e-16, 0.5, 1.0, 2.0, 3.0, 39.5, 40.0, 41.0, 100.3, 255.795, 1e4, 1e6, 1e9, 2e9, 1e15, 1e60, third, uni(0, 3), uni(0, 30), uni(-1, 0)]:
        def kappa(n):
            s = 2 * n + 1
            if n > 1e4:
                return mp.exp(mp.log(mp.pi * s / 4) / 2 + sum((-1) ** (k + 1) * abs(mp.eulernum(2 * k)) / (4 * k * s ** (2 * k)) for k in range(1, 12)))
            return mp.sqrt(mp.pi) * mp.gamma(n / 2 + 1) / mp.gamma(n / 2 + mpf(1) / 2)
        add("kappa", (n,), kappa)
    # incomplete beta
    for _ in range(130):
        a, b = rng.choice([(uni(0.1, 4), uni(0.1, 4)), (uni(0.1, 30), uni(0.1, 30)), (0.5, uni(-3, 3)), (uni(-3, 3), 0.5), (uni(-4, 0), uni(-4, 0)), (float(rng.randint(-4, 5)), rng.randint(-8, 9) / 2)])
        z1 = rng.choice([0.0, 0.0, logu(1e-30, 0.5), uni(0, 1), 1 - logu(1e-12, 0.5)])
        z2 = rng.choice([1.0, uni(0, 1), z1 * (1 + logu(1e-15, 0.5)), 1 - logu(1e-15, 0.5), logu(1e-20, 1)])
        if z1 > z2:
            z1, z2 = z2, z1
        if z2 > 1 or z1 == z2 or (z1 == 0 and a <= 0) or (z2 == 1 and b <= 0):
            continue
        add("betainc", (a, b, z1, z2), beta_interval)
    add("betainc", (third, fifth, third, Pair(mpf(2) / 3)), beta_interval)
    # confluent
    for _ in range(140):
        a = rng.choice([uni(0.1, 5), uni(-5, 5), rng.randint(-6, 9) / 2])
        b = rng.choice([uni(0.2, 6), rng.randint(1, 9) / 2, a + rng.randint(-3, 5), uni(-4, -0.1)])
        z = rng.choice([uni(-5, 5), -logu(1e-3, 1e4), logu(1e-3, 300), uni(-120, -60), -logu(1, 1e12)])
        if b <= 0 and b == int(b):
            continue
        with mp.workdps(130 + int(abs(z)) if abs(z) < 2000 else 150):
            add("hyp1f1", (a, b, z), mpmath.hyp1f1)
    # Gauss
    def gauss(a, b, c, z):
        with mp.workdps(140):
            return mpmath.hyp2f1(a, b, c, z)
    for _ in range(420):
        a, b, c = rng.choice([
            (uni(-3, 3), 1.0, 0.5), (uni(-3, 3), 1.0, 1.5), (uni(-3, 3), 2.0, 2.5), (uni(-2, 2), uni(0.5, 3), uni(0.5, 4)),
            (rng.randint(-9, 9) / 2, rng.randint(-9, 9) / 2, rng.randint(1, 9) / 2), (uni(-4, 4), uni(-4, 4), uni(-3, 6)),
            (1.0, 1 - uni(0.1, 60), 1.5), (float(rng.randint(1, 5)), float(rng.randint(1, 5)), float(rng.randint(1, 9))),
            (uni(-2, 2), uni(-2, 2), None), (0.5, 0.5, uni(1, 8)), (uni(-30, 30), uni(-30, 30), uni(1, 30)),
        ])
        if c is None:
            c = a + b + rng.randint(-2, 3)
        z = rng.choice([uni(-1, 1), uni(-3, 0), -logu(1e-12, 1e12), 1 - logu(1e-14, 1), logu(1e-10, 1), -logu(1, 1e4)])
        if (c <= 0 and c == int(c)) or z >= 1:
            continue
        add("hyp2f1", (a, b, c, z), gauss)
    for _ in range(60):
        # Next to whole differences.
        gap = rng.randint(-3, 3) + sg(logu(1e-16, 1e-7))
        a, c = uni(-2, 2), uni(0.5, 3)
        if rng.random() < 0.5:
            add("hyp2f1", (a, a + gap, c, -logu(1.5, 1e9)), gauss)
        else:
            b = uni(-2, 2)
            add("hyp2f1", (a, b, a + b + gap, 1 - logu(1e-12, 0.4)), gauss)
    for p in [third, Pair(-mpf(2) / 3), Pair(mpf(1) / 10)]:
        for z in [-1e-4, -0.3, -1.0, -2.7, -50.0, -1e6]:
            add("hyp2f1", (p, 1.0, 0.5, z), gauss)
    for a, b, c in [(0.5, 0.5, 1.5), (0.3, 0.2, 1.7), (-2.0, 3.0, 0.7), (1.0, -0.5, 1.5)]:
        add("hyp2f1", (a, b, c, 1.0), gauss)
    # pFq
    def general(p):
        def value(*args):
            with mp.workdps(120):
                return mpmath.hyper(args[:p], args[p:-1], args[-1])
        return value
    for _ in range(90):
        z = rng.choice([uni(-5, 5), -logu(1e-3, 400), logu(1e-3, 400)])
        a = [uni(0.2, 4) if rng.random() < 0.5 else rng.randint(1, 8) / 2 for _ in range(3)]
        b = [uni(0.2, 4) if rng.random() < 0.5 else rng.randint(1, 9) / 2 for _ in range(3)]
        kind = rng.choice(["0f1", "1f2", "2f2", "2f3", "3f2", "4f3"])
        if kind == "0f1":
            add("hyper 0 1", (b[0], z), general(0))
        elif kind == "1f2":
            add("hyper 1 2", (a[0], b[0], b[1], z), general(1))
        elif kind == "2f2":
            add("hyper 2 2", (a[0], a[1], b[0], b[1], max(z, -40.0)), general(2))
        elif kind == "2f3":
            add("hyper 2 3", (a[0], a[1], b[0], b[1], b[2], z), general(2))
        elif kind == "3f2":
            add("hyper 3 2", (a[0], a[1], -a[2] / 3, b[0], b[1], uni(-0.98, 0.98)), general(3))
        else:
            add("hyper 4 3", (a[0], a[1], -a[2] / 3, 1.0, b[0], b[1], b[2], uni(-0.95, 0.95)), general(4))
    for p in [0.25, -0.25, 0.5, 1.5, -0.5, -1.0, 1.3, -2.0, uni(-2, 2), uni(-2, 2)]:
        for z in [-0.5, -0.99, -1.0, -1.7, -5.0, -29.0, -31.0, -400.0, -1e6]:
            add("hyper 3 2", (-p, 0.5, 1.0, 0.25, 0.75, z), general(3))
            if z > -1000:
                add("hyper 3 2", (-p, 1.0, 1.5, 0.75, 1.25, z), general(3))
    for z in [-0.3, -0.9, -1.0, -3.0, -20.0, -100.0, -1e5, 0.3, 0.9, 0.99, 0.999, 1.0]:
        h = mpf(1) / 2
        y = mp.sqrt(abs(mpf(z)))
        chi = (mpmath.polylog(2, y) - mpmath.polylog(2, -y)) / 2 if z > 0 else mp.im(mpmath.polylog(2, mp.mpc(0, y)))
        add("hyper 3 2", (0.5, 0.5, 1.0, 1.5, 1.5, z), mp.re(chi) / y)
    for _ in range(40):
        # Like the transforms of exp(-r^4), and any others, far out.
        a, b = rng.choice([((1.0, 0.5), (0.25, 0.75)), ((0.5, 1.0), (0.75, 1.25)), ((1.0, 1.5), (1.25, 1.75)), ((uni(0.2, 3), uni(0.2, 3)), (uni(0.2, 4), uni(0.2, 4)))])
        z = -logu(1, 800)
        with mp.workdps(120 + int(abs(z))):
            add("hyper 2 2", (*a, *b, z), mpmath.hyper([mpf(v) for v in a], [mpf(v) for v in b], mpf(z), maxprec=40000, maxterms=10**6))
    # elliptic
    def inside():
        return rng.choice([uni(0, 1), 1 - logu(1e-15, 1), logu(1e-12, 1), -logu(1e-3, 1e3), -logu(1, 1e12)])
    for _ in range(60):
        m = inside()
        add("ellipk", (m,), mpmath.ellipk)
        add("ellipe", (m,), mpmath.ellipe)
    add("ellipk", (third,), mpmath.ellipk)
    add("ellipe", (third,), mpmath.ellipe)
    for _ in range(110):
        m = inside()
        phi = rng.choice([uni(0, math.pi / 2), logu(1e-12, 1.5), math.pi / 2 - logu(1e-12, 1)])
        s, c = mp.sin(mpf(phi)), mp.cos(mpf(phi))
        d = 1 - mpf(m) * s * s
        add("ellipf", (phi, m), s * mpmath.elliprf(c * c, d, 1))
        add("ellipe", (phi, m), s * mpmath.elliprf(c * c, d, 1) - mpf(m) * s ** 3 / 3 * mpmath.elliprd(c * c, d, 1))
    for _ in range(90):
        x, y, z = (rng.choice([uni(0.1, 3), logu(1e-12, 1e12), logu(1e-100, 1e90)]) for _ in range(3))
        if rng.random() < 0.3:
            y = x * (1 + sg(logu(1e-15, 0.1)))
        if rng.random() < 0.2:
            x = 0.0
        add("elliprf", (x, y, z), mpmath.elliprf)
        add("elliprd", (x, y, z), mpmath.elliprd)
        add("elliprc", (x, y), mpmath.elliprc)
    # dilogarithms
    for _ in range(60):
        z = rng.choice([uni(-1, 1), -logu(1e-3, 1e10), sg(logu(1e-20, 1)), 1 - logu(1e-15, 0.3)])
        add("polylog", (2.0, z), lambda s, z: mp.re(mpmath.polylog(2, z)))
        if abs(z) <= 1:
            add("legendre_chi2", (z,), lambda z: mp.re(mpmath.polylog(2, z) - mpmath.polylog(2, -z)) / 2)
        y = rng.choice([uni(0, 2), logu(1e-10, 1e10), 1 + sg(logu(1e-10, 0.5))])
        add("inverse_tangent_integral", (y,), lambda z: mp.im(mpmath.polylog(2, mp.mpc(0, z))))
        t = rng.choice([uni(0, 2 * math.pi), logu(1e-20, 1), math.pi + sg(logu(1e-12, 1)), 2 * math.pi - logu(1e-10, 1), uni(-30, 30)])
        add("clsin", (2.0, t), lambda s, t: mpmath.clsin(2, t))
    many_parameters()
    target = Path(__file__).with_name("hypergeometric.csv")
    target.write_text("function,arguments,value\n" + "\n".join(rows) + "\n")
    print(f"{len(rows)} rows", file=sys.stderr)


main()
