#!/usr/bin/env python3
"""Writes special.csv: 50-digit reference values of the functions in crates/sneddon-num/src.

Run:  python3 tests/oracle/special.py            (needs mpmath 1.3; a few minutes; deterministic)

Each row: function, arguments separated by ';' (exact doubles, as repr prints them), value with 30 digits.
Values come from the definition (an integral or a series of mpmath), not from the formula that the code uses; where
the definition is out of reach at an extreme argument, a different closed form at raised precision stands in.
"""
import math
import random
import sys
from pathlib import Path

from mpmath import mp, mpf

mp.dps = 50
rng = random.Random(20261121)
rows = []
INF = float("inf")


def uniform(a, b):
    return rng.uniform(a, b)


def log_uniform(a, b):
    return math.exp(rng.uniform(math.log(a), math.log(b)))


def add(name, args, value):
    """One row; results outside the normal range of doubles are left out."""
    if value is None or not mp.isfinite(value):
        return
    size = abs(value)
    if size != 0 and not mpf("1e-306") < size < mpf("1.7e308"):
        return
    text = ";".join("inf" if a == INF else repr(a) for a in args)
    rows.append(f"{name},{text},{mp.nstr(value, 30, min_fixed=0, max_fixed=0) if value else '0'}")


def digits(extra):
    """A context with more digits."""
    return mp.workdps(50 + extra)


def gauss(f, points):
    """Integral of a function that is smooth inside, perhaps singular at the ends of the pieces."""
    return mp.quad(f, points)


# --- kappa ------------------------------------------------------------------------------------------------------
def kappa(n):
    n = mpf(n)
    if n > 1e5:
        # Gamma ratio by its asymptotic series, far below 50 digits' error: ln kappa, Euler numbers
        s = 2 * n + 1
        total = mp.log(mp.pi * s / 4) / 2
        for k in range(1, 12):
            total += (-1) ** (k + 1) * abs(mp.eulernum(2 * k)) / (4 * k * s ** (2 * k))
        return mp.exp(total)
    with digits(30):
        return mp.sqrt(mp.pi) * mp.gamma(n / 2 + 1) / mp.gamma(n / 2 + mpf(1) / 2)


def do_kappa():
    points = [1e-300, 1e-16, 1e-8, 0.5, 1.0, 2.0, 3.0, 10.0, 23.9, 24.0, 100.0, 255.795, 341.0, 342.0, 1e3, 1e6, 1e9, 2e9, 1e15,
              1e99, 1e101, 1e300, -0.5, -0.999999, -1e-10, -1 + 2.0**-52]
    points += [log_uniform(1e-8, 1e10) for _ in range(90)] + [uniform(0, 30) for _ in range(40)]
    points += [uniform(-1, 0) for _ in range(20)] + [log_uniform(1e10, 1e300) for _ in range(20)]
    for n in points:
        add("kappa", (n,), kappa(n))


# --- segments ---------------------------------------------------------------------------------------------------
def segment(k, b, c, x, square):
    """∫_b^min(c,x) (r-b)^k r^(2 square)/sqrt(x^2-r^2) dr, in r = x - (x-b) t^2: smooth."""
    b, x = mpf(b), mpf(x)
    c = x if c >= x else mpf(c)
    if c <= b:
        return mpf(0)
    t0 = mp.sqrt((x - c) / (x - b))
    length = (c - b) / (x - b) / (1 + t0)  # 1 - t0, all digits

    def f(s):
        t = t0 + length * s
        q = (1 - s) * (1 + t) / (1 + t0)  # (r - b)/(c - b)
        r = b + (c - b) * q
        return q**k * (r / c) ** (2 * square) / mp.sqrt((x + r) / x)

    # large k lives near s = 0; over [0, 1] the absolute tolerance of mp.quad is a relative one
    cuts = [0, 0.05, 0.12, 0.25, 0.5, 1] if k > 8 else [0, 1]
    value, error = mp.quad(f, cuts, error=True, method="gauss-legendre")
    assert error < value * mpf("1e-22"), (k, b, c, x, mp.nstr(value, 5), mp.nstr(error, 5))
    return 2 * length * value * mp.sqrt((x - b) / x) * (c - b) ** k * c ** (2 * square)


def segment_points():
    out = [(0.0, INF, 1.0), (0.0, 0.5, 1.0), (0.0, 1.0, 1.0), (3.0, INF, 5.0), (3.0, 4.0, 5.0), (0.0, 1e-10, 1.0),
           (0.6, 0.6000000000006007, 6013.9005053217), (1.0, 1.0 + 2.0**-52, 3.0), (1.0, INF, 1.0 + 2.0**-52),
           (1.0, 1.0 + 2.0**-51, 1.0 + 2.0**-50), (1.0, 3.0 - 2.0**-51, 3.0), (0.5, 1.0 - 2.0**-53, 1.0),
           (1e-30, 1e-10, 1.0), (0.0, 1e-300, 1e-290), (1e299, 2e299, 3e299), (3e-200, 4e-200, 5e-200),
           (3e200, INF, 5e200), (1e-300, 1e-299, 1.0), (1e-100, INF, 1e100)]
    for _ in range(25):
        x = log_uniform(1e-3, 1e3)
        b = x * uniform(0, 1)
        c = rng.choice([INF, b + (x - b) * uniform(0, 1), b + (x - b) * log_uniform(1e-14, 1), x * (1 - log_uniform(1e-15, 1e-2))])
        if b < c:
            out.append((b, c, x))
    for _ in range(12):
        b = log_uniform(1e-2, 1e2)
        x = b * (1 + log_uniform(1e-15, 1e-3))
        c = rng.choice([INF, b + (x - b) * uniform(0, 1)])
        if b < c:
            out.append((b, c, x))
    return out


def do_segment():
    for b, c, x in segment_points():
        add("angle_between", (b, c, x), segment(0, b, c, x, 0))
        for k in rng.sample([1, 2, 3, 4], 2) + rng.sample([5, 6, 9, 15, 30, 60, 100, 150, 200], 2):
            add("shifted_power", (k, b, c, x), segment(k, b, c, x, 0))
        for k in [0] + rng.sample([1, 2, 3, 4, 5, 8, 20, 77, 200], 2):
            add("shifted_power_force", (k, b, c, x), segment(k, b, c, x, 1))
    for k in (400, 1000):
        for b, c, x in ((0.1, INF, 1.0), (0.5, 0.9, 1.1)):
            add("shifted_power", (k, b, c, x), segment(k, b, c, x, 0))


# --- pressure of a power ------------------------------------------------------------------------------------------
def pressure_power(n, s, a):
    """S_n = a^n S_n(s/a, 1); by Euler's 2F1 with raised precision, or quadrature for large n."""
    n, s, a = mpf(n), mpf(s), mpf(a)
    with digits(30):
        q = s / a
        u = (a - s) / a
        if n > 50 or q > 0.02:
            # x = q + u y^2
            lo = mpf(0)
            if n > 50:
                depth = -mp.expm1(-mpf(150) / n) / u
                lo = mp.sqrt(1 - depth) if depth < 1 else mpf(0)
            f = lambda y: (q + u * y * y) ** n / mp.sqrt(2 * q + u * y * y)
            value, error = mp.quad(f, mp.linspace(lo, 1, 4), error=True, method="gauss-legendre", maxdegree=7)
            assert error < abs(value) * mpf("1e-25"), (n, s, a)
            value *= 2 * mp.sqrt(u)
        else:
            # x = q cosh v: entire, but long; split into unit pieces
            top = mp.acosh(1 / q)
            if top < 40:
                f = lambda v: (q * mp.cosh(v)) ** n
                value = mp.quad(f, mp.linspace(0, top, 2 + int(top)), method="gauss-legendre")
            else:
                # the complete part to infinity, or the value at q = 0, plus a hypergeometric rest (MDR small-s form)
                if n == 0:
                    value = top
                elif n == 1:
                    value = mp.sqrt((1 - q) * (1 + q))
                elif n / 2 == mp.floor(n / 2):
                    # even n: finite recurrence in 80 digits
                    w = mp.sqrt((1 - q) * (1 + q))
                    value, m = top, mpf(0)
                    while m < n:
                        m += 2
                        value = (w + (m - 1) * q * q * value) / m
                else:
                    value = mp.hyp2f1(0.5, -n / 2, 1 - n / 2, q * q) / n + q**n * mp.sqrt(mp.pi) * mp.gamma(-n / 2) * mp.rgamma((1 - n) / 2) / 2
        return value * a**n


def do_pressure_power():
    orders = [-0.999, -0.9, -0.5, -0.1, -1e-10, 0.0, 1e-10, 0.1, 0.5, 1.0, 1.0000001, 1.5, 2.0, 2.0000000001, 2.5, 3.0, 4.0, 5.5, 7.0,
              10.0, 17.3, 33.3, 59.9, 60.0, 100.0, 333.3, 1000.0, 9999.5]
    ratios = [1e-300, 1e-100, 1e-30, 1e-17, 1e-10, 1e-5, 1e-3, 0.0156, 0.0157, 0.1, 0.4, 0.5, 0.9, 0.999, 1 - 1e-8, 1 - 1e-12, 1 - 1e-15]
    for n in orders:
        for ratio in rng.sample(ratios, 7):
            a = 1.0 if n > 80 or rng.random() < 0.5 else log_uniform(0.1, 10)
            add("pressure_power", (n, ratio * a, a), pressure_power(n, ratio * a, a))
    for _ in range(120):
        n = rng.choice([uniform(-1, 3), uniform(0, 60), float(rng.randint(0, 12)), log_uniform(60, 1e4)])
        a = log_uniform(1e-2, 1e2) if n < 60 else uniform(0.99, 1.01)
        s = a * rng.choice([uniform(0, 1), log_uniform(1e-6, 1), 1 - log_uniform(1e-14, 1)])
        if 0 < s < a:
            add("pressure_power", (n, s, a), pressure_power(n, s, a))
    for n, s, a in [(2.0, 3e150, 5e150), (-0.5, 3e-300, 5e300), (3.5, 1e-80, 3e-80), (0.0, 1e-300, 1e300), (1.0, 1e200, 3e200),
                    (-0.7, 1e-300, 1e-10), (1.9, 1e-160, 1e-150)]:
        add("pressure_power", (n, s, a), pressure_power(n, s, a))


# --- roots: sphere and hyperboloid --------------------------------------------------------------------------------
def root_ratio_points():
    ys = [1e-200, 1e-20, 1e-9, 1.1e-9, 1e-8, 1e-5, 1e-3, 0.1, 0.3, 0.5, 0.7, 0.75, 0.77, 0.78, 0.8, 0.9, 0.99, 0.999999, 1 - 2.0**-40, 1 - 2.0**-53]
    out = [(y, 1.0) for y in ys]
    for _ in range(60):
        r = log_uniform(1e-3, 1e3)
        out.append((r * rng.choice([uniform(0, 1), log_uniform(1e-12, 1), 1 - log_uniform(1e-15, 1)]), r))
    out += [(3e-80, 1e-79), (2.9e149, 3e149), (1e-20, 1e150), (1.5e-100, 1.6e-100)]
    return [(a, r) for a, r in out if 0 < a < r]


def do_root_family():
    for a, r in root_ratio_points():
        A, R = mpf(a), mpf(r)
        with digits(450):
            at = mp.atanh(A / R)
            add("artanh_ratio", (a, r), +at)
            add("sphere_force", (a, r), ((R * R + A * A) * at - A * R) / 2)
            add("sphere_integral", (a, r), ((A * A - R * R) * at + A * R) / 2)
        for x, b in ((a, r), (r, a)):
            X, B = mpf(x), mpf(b)
            with digits(450):
                at = mp.atan(X / B)
                add("hyperboloid_force", (x, b), ((X * X - B * B) * at + X * B) / 2)
                add("hyperboloid_integral", (x, b), ((X * X + B * B) * at - X * B) / 2)


def worn_triples():
    out = [(0.5, 0.7, 1.0), (0.0, 0.5, 1.0), (1e-10, 0.3, 1.0), (0.3, 0.3 + 1e-15, 1.0), (0.999, 1 - 1e-9, 1.0), (1.0, 1.0 + 1e-12, 1.0 + 2e-12),
           (1e-12, 2e-12, 1.0), (3e-100, 4e-100, 5e-100), (0.5, 1.0, 1e150), (3e99, 4e99, 5e100)]
    for _ in range(70):
        r = log_uniform(1e-3, 1e3)
        a = r * rng.choice([uniform(0, 1), log_uniform(1e-6, 1), 1 - log_uniform(1e-13, 1)])
        b = a * rng.choice([uniform(0, 1), log_uniform(1e-6, 1), 1 - log_uniform(1e-13, 1)])
        out.append((b, a, r))
    return [(b, a, r) for b, a, r in out if 0 <= b < a < r]


def do_worn_root():
    for b, a, r in worn_triples():
        B, A, R = mpf(b), mpf(a), mpf(r)
        with digits(350):
            w, C = mp.sqrt(A * A - B * B), mp.sqrt(R * R - B * B)
            at = mp.atanh(w / C)
            add("worn_sphere_slope", (b, a, r), +at)
            add("worn_sphere_force", (b, a, r), ((R * R + A * A) * at - w * C) / 2)
        for scale in (r, rng.choice([log_uniform(1e-3, 1), log_uniform(1, 1e3)]) * a):
            S = mpf(scale)
            with digits(350):
                w, C = mp.sqrt(A * A - B * B), mp.sqrt(S * S + B * B)
                at = mp.atan(w / C)
                add("worn_hyperboloid_slope", (b, a, scale), +at)
                add("worn_hyperboloid_force", (b, a, scale), ((w * w - C * C + 2 * B * B) * at + w * C) / 2)


def do_root_pressure():
    """p = ∫_0^acosh(a/s) g'(s cosh u) du; at s << a by the dilogarithm at raised precision, g' = artanh y/R + R x/(R^2-x^2)."""
    triples = worn_triples() + [(0.0, 0.5, 1.0), (1e-300, 0.5, 1.0), (0.0, 0.99999, 1.0), (0.009999999998998822, 0.01, 2.0)]
    for s, a, r in triples:
        S, A, R = mpf(s), mpf(a), mpf(r)
        with digits(350):
            w, c = mp.sqrt((A - S) * (A + S)), mp.sqrt((R - S) * (R + S))
            chi = lambda y: (mp.polylog(2, y) - mp.polylog(2, -y)) / 2 if y else mpf(0)
        with digits(120):
            high, low = (A + w) / (R + c), S * S / ((A + w) * (R + c))
            value = chi(high) - chi(low) + R / c * mp.atanh(w / c) if a > 1e-90 else None
        add("sphere_pressure", (s, a, r), value)
        for b in (r, rng.choice([log_uniform(1e-3, 1), log_uniform(1, 1e3)]) * a):
            B = mpf(b)
            with digits(120):
                c = mp.sqrt(B * B + S * S)
                high, low = (A + w) / (B + c), S * S / ((A + w) * (B + c))
                value = ti2(high) - ti2(low) + B / c * mp.atan(w / c) if a > 1e-90 else None
            add("hyperboloid_pressure", (s, a, b), value)
    # The definition itself, at ordinary points: the closed form above must agree with it.
    for s, a, r in [(0.3, 0.7, 1.0), (0.1, 2.0, 2.5), (1.0, 1.01, 3.0)]:
        S, A, R = mpf(s), mpf(a), mpf(r)
        top = mp.acosh(A / S)
        x = lambda u: S * mp.cosh(u)
        value = mp.quad(lambda u: mp.atanh(x(u) / R) + R * x(u) / (R * R - x(u) ** 2), [0, top])
        add("sphere_pressure", (s, a, r), value)
        value = mp.quad(lambda u: mp.atan(x(u) / R) + R * x(u) / (R * R + x(u) ** 2), [0, top])
        add("hyperboloid_pressure", (s, a, r), value)


# --- elliptic moments ---------------------------------------------------------------------------------------------
def elliptic_moment(k, b, s, a):
    """x^2 = M^2 + w^2 y^2 ... by y = d sinh v, d^2 = (M^2-m^2)/w^2: the near pole d becomes smooth."""
    unit = mpf(a)
    large, small, a = mpf(max(b, s)) / unit, mpf(min(b, s)) / unit, mpf(1)
    w2, gap2 = (a - large) * (a + large), (large - small) * (large + small)
    d = mp.sqrt(gap2)
    top = mp.asinh(mp.sqrt(w2) / d)
    # ρ = sqrt(x^2-M^2) = d sinh v; dx = ρ dρ/x; integrand x^(2k-1) dρ/sqrt(ρ^2+d^2) = x^(2k-1) dv
    f = lambda v: mp.sqrt(large**2 + gap2 * mp.sinh(v) ** 2) ** (2 * k - 1)
    pieces = 1 + int(min(top, 200) / 1.5)
    value, error = mp.quad(f, mp.linspace(0, top, pieces + 1), error=True, method="gauss-legendre")
    assert error < abs(value) * mpf("1e-22"), (k, b, s, a)
    return value * unit ** (2 * k - 1)


def with_random(triples, count):
    """The places (b, s, a), and `count` more: close to each other, to the edge and far apart."""
    for _ in range(count):
        a = log_uniform(1e-2, 1e2)
        b = a * rng.choice([uniform(0, 1), log_uniform(1e-4, 1), 1 - log_uniform(1e-12, 1)])
        s = rng.choice([a * uniform(0, 1), a * (1 - log_uniform(1e-12, 1)), b * (1 + log_uniform(1e-14, 1)), b * (1 - log_uniform(1e-14, 1))])
        triples.append((b, s, a))
    return [(b, s, a) for b, s, a in triples if 0 <= s < a and 0 <= b < a and s != b]


def do_worn_pressure():
    triples = [(0.5, 0.2, 1.0), (0.2, 0.5, 1.0), (0.0, 0.5, 1.0), (0.5, 0.0, 1.0), (0.6000005999999998, 0.6, 0.6000005999999999),
               (0.5, 0.5 + 2.0**-52, 1.0), (0.5, 0.25, 0.5 + 2.0**-50), (1e-6, 0.0, 1.0), (1e-10, 1e-3, 1.0), (3e100, 4e100, 5e100),
               (3e-100, 4e-100, 5e-99)]
    for b, s, a in with_random(triples, 60):
        for k in [0, 1] + rng.sample([2, 3, 4, 5, 8], 1):
            add("elliptic_moment", (k, b, s, a), elliptic_moment(k, b, s, a))


# --- Carlson, Legendre ---------------------------------------------------------------------------------------------
def do_carlson():
    def sizes(low, high):
        return rng.choice([lambda: uniform(0, 2), lambda: log_uniform(1e-3, 1e3), lambda: log_uniform(low, high)])()

    for _ in range(100):
        x, y, z = (sizes(1e-300, 1e300) for _ in range(3))
        if rng.random() < 0.2:
            x = 0.0
        if rng.random() < 0.2:
            y = z * (1 + log_uniform(1e-15, 1e-1))
        add("rf", (x, y, z), mp.elliprf(x, y, z))
        x, y, z = (sizes(1e-100, 1e100) for _ in range(3))
        if rng.random() < 0.2:
            x = 0.0
        if rng.random() < 0.2:
            y = z * (1 + log_uniform(1e-15, 1e-1))
        add("rd", (x, y, z), mp.elliprd(x, y, z))
    for x, y, z in [(1e-300, 1e-300, 1e300), (1e300, 1e300, 1e-300), (0.0, 1e-300, 1e300), (1e-300, 1e-300, 2e-300), (1e300, 2e300, 3e300), (1.0, 2.0, 3.0)]:
        add("rf", (x, y, z), mp.elliprf(x, y, z))
    for x, y in [(0.0, 1.0), (0.0, 1e-300), (1e300, 1e-300), (1e-300, 1e300), (1.0, 1 + 2.0**-52), (1 + 2.0**-52, 1.0), (2.0, 2.0)]:
        add("rc", (x, y), rc(x, y))
    for _ in range(100):
        x, y = sizes(1e-300, 1e300), sizes(1e-300, 1e300)
        if rng.random() < 0.4:
            y = x * (1 + rng.choice([-1, 1]) * log_uniform(1e-15, 0.5))
        add("rc", (x, y), rc(x, y))


def rc(x, y):
    with digits(700):
        x, y = mpf(x), mpf(y)
        if x == y:
            return 1 / mp.sqrt(x)
        if x < y:
            return mp.atan(mp.sqrt((y - x) / x)) / mp.sqrt(y - x) if x else mp.pi / 2 / mp.sqrt(y)
        return mp.asinh(mp.sqrt((x - y) / y)) / mp.sqrt(x - y)


def do_elliptic():
    ms = [0.0, 0.5, 0.9, 0.999, 1 - 1e-8, 1 - 2.0**-53, -1.0, -10.0, -1e5, -1e15, 1e-300, 1e-10]
    ms += [uniform(-2, 1) for _ in range(60)] + [-log_uniform(1e-3, 1e12) for _ in range(30)] + [1 - log_uniform(1e-15, 1) for _ in range(30)]
    for m in ms + [-1e100, -1e300]:
        with digits(330):
            M = mpf(m)
            add("ellipk", (m,), mp.ellipk(M))
            add("ellipe", (m,), mp.ellipe(M))
    for m in ms + [1.0]:
        for phi in [rng.choice([0.1, 0.7, 1.5, math.pi / 2, 1e-5, 1e-12, uniform(0, 1.57), uniform(0, 1.57), uniform(0, 1.57)])]:
            if m == 1.0 and phi > 1.57:
                continue
            with digits(30):
                add("ellipf", (phi, m), mp.ellipf(phi, m))
                add("ellipe_inc", (phi, m), mp.ellipe(phi, m))


# --- dilogarithms --------------------------------------------------------------------------------------------------
def ti2(z):
    return mp.im(mp.polylog(2, mp.mpc(0, z))) if z else mpf(0)


def do_dilogarithm():
    zs = [1e-300, 1e-20, 1e-9, 1e-3, 0.03, 0.03162, 0.0317, 0.2236, 0.224, 0.41421, 0.5, 0.7, 0.7000001, 0.8, 0.9, 0.999, 1 - 1e-10, 1 - 2.0**-53, 1.0]
    zs += [uniform(0, 1) for _ in range(70)] + [1 - log_uniform(1e-15, 1) for _ in range(20)]
    for z in zs:
        with digits(20):
            if z < 1e-15:
                value = mpf(z)
            else:
                value = (mp.polylog(2, z) - mp.polylog(2, -mpf(z))) / 2
            add("legendre_chi2", (z,), mp.re(value))
    for z in zs + [1.0000001, 2.0, 1e5, 1e300] + [log_uniform(0.1, 1e4) for _ in range(80)]:
        with digits(20):
            add("inverse_tangent_integral", (z,), ti2(mpf(z)) if 1e-15 < z < 1e15 else mpf(z) if z < 1 else mp.pi / 2 * mp.log(z) + 1 / mpf(z))
    for z in [z for z in zs] + [-z for z in zs] + [-log_uniform(0.5, 1e8) for _ in range(80)] + [-4.0, -4.0000001, -1e300, 0.79, 0.81]:
        with digits(20):
            Z = mpf(z)
            value = Z if abs(z) < 1e-30 else mp.re(mp.polylog(2, Z)) if z > -1e15 else -(mp.pi**2 / 6 + mp.log(-Z) ** 2 / 2)
            add("polylog2", (z,), value)


# --- hypergeometric ------------------------------------------------------------------------------------------------
def do_hypergeometric():
    for n in [1e-3, 0.3, 0.5, 1.0, 1.5, 2.0, 2.2, 3.0, 4.0, 5.0, 7.7, 10.0, 20.0, 33.0, 59.9, 61.0, 61.5, 100.0, 150.5, 199.9, 200.0]:
        b = 1 - n / 2
        zs = [uniform(0, 1), log_uniform(1e-10, 1), 1 - log_uniform(1e-14, 1e-1), rng.choice([0.5, 0.9, 0.99, 1 - 2.0**-53, 1e-20, 0.9997, 0.9998])]
        if n > 1:
            zs.append(1.0)
        for z in zs:
            with digits(60):
                # Euler's integral in the variable of the slope, all positive
                B, Z = mpf(b), mpf(z)
                value = mp.hyp2f1(1, B, 1.5, Z) if z < 1 else 1 / (1 - 2 * B)
            add("hyp2f1 slope", (1.0, b, 1.5, z), value)
    for _ in range(150):
        a, b = (rng.choice([uniform(-3, 3), rng.choice([0.5, 1.0, 1.5, 2.0, -0.5, -1.5, -2.0, -3.0])]) for _ in range(2))
        c = rng.choice([uniform(0.2, 4), rng.choice([0.5, 1.0, 1.5, 2.0, 2.5, 3.0])])
        z = rng.choice([uniform(-1, 1), -log_uniform(1, 1e4), 1 - log_uniform(1e-8, 1), uniform(0.5, 1)])
        value = mp.hyp2f1(a, b, c, z)
        if abs(value) > 1e-8:
            add("hyp2f1", (a, b, c, z), value)
    for y in [1e-5, 0.1, 0.5, 0.8, 0.9, 0.99, 1.0] + [uniform(0, 1) for _ in range(15)]:
        z = y * y
        with digits(20):
            Y = mp.sqrt(mpf(z))
            add("hyper dilogarithm", (z,), mp.re(mp.polylog(2, Y) - mp.polylog(2, -Y)) / 2 / Y)
            add("hyper dilogarithm", (-z,), ti2(Y) / Y)
    for _ in range(40):
        z = uniform(-0.7, 0.95)
        a, b = [uniform(0.2, 2) for _ in range(3)], [uniform(0.5, 3) for _ in range(2)]
        add("hyper 3f2", (*a, *b, z), mp.hyper(a, b, z))
        z = uniform(-5, 10)
        add("hyper 1f2", (a[0], *b, z), mp.hyper(a[:1], b, z))


# --- Bessel, digamma -----------------------------------------------------------------------------------------------
def do_bessel():
    for _ in range(120):
        n = float(rng.choice([0, 1, 2, 3, 5, 10, 30]))
        z = rng.choice([uniform(0, 20), log_uniform(1e-3, 20)])
        value = mp.besselj(n, z)
        if abs(value) > 0.05 * abs(mp.besselj(n, z, derivative=1)):
            add("besselj integer", (n, z), value)
        n = uniform(0, 12)
        value = mp.besselj(n, z)
        if z * z / 4 < 30 + n and abs(value) > 0.05 * abs(mp.besselj(n, z, derivative=1)):
            add("besselj real", (n, z), value)
        n = rng.choice([0.0, 1.0, 2.0, 7.0, uniform(0, 8), float(rng.randint(8, 40))])
        z = rng.choice([uniform(0, 60), log_uniform(1e-3, 700), uniform(60, 700)])
        if z < 63 or z > n * n:
            add("besseli", (n, z), mp.besseli(n, z))


def do_digamma():
    zero = 1.4616321449683622
    xs = [1e-300, 1e-10, 0.5, 1.0, zero, zero + 1e-10, zero - 1e-5, 0.861, 0.862, 2.061, 2.062, 2.0, 9.99, 10.0, 1e300]
    xs += [log_uniform(1e-3, 1e4) for _ in range(60)] + [uniform(0.5, 3) for _ in range(50)]
    for x in xs:
        with digits(20):
            add("digamma", (x,), mp.digamma(mpf(x)))


# --- definitions -----------------------------------------------------------------------------------------------------
def do_definitions():
    """The integrals themselves at ordinary points, for the rows above that stand on closed forms at raised precision."""
    half_turn = mp.pi / 2
    for _ in range(4):
        a = log_uniform(0.1, 10)
        b, r = a * uniform(0.05, 0.95), a * uniform(1.05, 3)
        B, A, R = mpf(b), mpf(a), mpf(r)
        w = mp.sqrt(A * A - B * B)
        at = lambda u: mp.sqrt(B * B + (w * mp.sin(u)) ** 2)  # radius; r dr / sqrt(a^2 - r^2) = w sin u du
        whole = lambda u: A * mp.sin(u)
        sphere = lambda p: 1 / mp.sqrt(R * R - p * p)
        hyperboloid = lambda p: 1 / mp.sqrt(R * R + p * p)
        for root, name in ((sphere, "sphere"), (hyperboloid, "hyperboloid")):
            add(f"worn_{name}_slope", (b, a, r), mp.quad(lambda u: w * mp.sin(u) * root(at(u)), [0, half_turn]))
            add(f"worn_{name}_force", (b, a, r), mp.quad(lambda u: w * mp.sin(u) * at(u) ** 2 * root(at(u)), [0, half_turn]))
            add(f"{name}_force", (a, r), mp.quad(lambda u: whole(u) ** 3 * root(whole(u)), [0, half_turn]))
        add("sphere_integral", (a, r), mp.quad(lambda x: x * mp.atanh(x / R), [0, A]))
        add("hyperboloid_integral", (a, r), mp.quad(lambda x: x * mp.atan(x / R), [0, A]))
        add("artanh_ratio", (a, r), mp.quad(lambda u: whole(u) * sphere(whole(u)), [0, half_turn]))


def do_inverse_moment():
    """E_(-1), also at r = 0 and far inside."""
    triples = [(0.5, 0.0, 1.0), (0.5, 1e-8, 1.0), (1e-8, 0.5, 1.0), (0.0, 0.5, 1.0), (6.25e-9, 0.15625, 0.3125), (3e-50, 4e-50, 5e-49), (3e50, 4e50, 5e50)]
    for b, s, a in with_random(triples, 40):
        add("elliptic_moment", (-1, b, s, a), elliptic_moment(-1, b, s, a))


def elliptic_pole(sign, w, b, s, a):
    """As `elliptic_moment`, with 1/(x^2 ± w^2); next to a pole at the edge the pieces become shorter."""
    unit = mpf(a)
    large, small, a, w = mpf(max(b, s)) / unit, mpf(min(b, s)) / unit, mpf(1), mpf(w) / unit
    d = mp.sqrt((large - small) * (large + small))
    top = mp.asinh(mp.sqrt((a - large) * (a + large)) / d)
    square = lambda v: large**2 + (d * mp.sinh(v)) ** 2
    f = lambda v: 1 / (mp.sqrt(square(v)) * (square(v) + sign * w * w))
    ends = set(mp.linspace(0, top, 2 + int(min(top, 200) / 0.7)))
    if sign < 0:
        ends |= {top - top * mpf(2) ** -k for k in range(1, 60)}
    value, error = mp.quad(f, sorted(ends), error=True, method="gauss-legendre")
    assert error < abs(value) * mpf("1e-22"), (sign, w, b, s, a)
    return value / unit**3


def do_third_kind():
    """R_J, for which mpmath needs far more digits than it returns where p is tiny, and the integral with a pole."""
    def size():
        return rng.choice([uniform(0.1, 3), log_uniform(1e-12, 1e12), log_uniform(1e-90, 1e90)])

    for _ in range(90):
        x, y, z, p = (size() for _ in range(4))
        if rng.random() < 0.2:
            x = 0.0
        if rng.random() < 0.3:
            p = y * (1 + rng.choice([-1, 1]) * log_uniform(1e-15, 0.1))
        with mp.workdps(250):
            value = mp.elliprj(mpf(x), mpf(y), mpf(z), mpf(p))
        add("elliprj", (x, y, z, p), value)
    for b, s, a in with_random([(0.5, 0.0, 1.0), (0.5, 0.2, 1.0), (0.2, 0.5, 1.0)], 45):
        w = a * rng.choice([log_uniform(1e-3, 1e3), uniform(0.1, 3)])
        add("elliptic_pole", (1.0, w, b, s, a), elliptic_pole(1, w, b, s, a))
        w = a * (1 + log_uniform(1e-12, 10))
        add("elliptic_pole", (-1.0, w, b, s, a), elliptic_pole(-1, w, b, s, a))


PARTS = [do_kappa, do_segment, do_pressure_power, do_root_family, do_worn_root, do_root_pressure, do_worn_pressure, do_carlson, do_elliptic,
         do_dilogarithm, do_hypergeometric, do_bessel, do_digamma, do_definitions, do_inverse_moment, do_third_kind]


def main():
    import time
    for part in PARTS:
        start = time.time()
        rng.seed(part.__name__)
        part()
        print(f"{part.__name__}: {len(rows)} rows so far, {time.time() - start:.1f} s", file=sys.stderr)
    path = Path(__file__).with_name("special.csv")
    path.write_text("function,arguments,value\n" + "\n".join(rows) + "\n", encoding="ascii")


if __name__ == "__main__":
    main()
