#!/usr/bin/env python3
"""Writes waves.csv: 45-digit values of Bessel and Struve functions, error functions, Dawson's and Fresnel's integrals.

Run:  python3 tests/oracle/waves.py          (needs mpmath 1.3; under a minute; deterministic)

Each row: function, arguments separated by ';', value. An argument is an exact double as repr prints it, or the sum of
two, `hi:lo`. Values are mpmath's at raised precision; Struve functions of arguments above 200, where its series would
need hundreds of digits, are Bessel functions and the asymptotic series instead.
"""
import math
import random
import sys
from pathlib import Path

from mpmath import mp, mpf
import mpmath

mp.dps = 60
rng = random.Random(20261122)
rows = []


def log_uniform(a, b):
    return math.exp(rng.uniform(math.log(a), math.log(b)))


def exact(argument):
    return sum(mpf(part) for part in argument) if isinstance(argument, tuple) else mpf(argument)


def text(argument):
    return ":".join(repr(part) for part in argument) if isinstance(argument, tuple) else repr(argument)


def add(name, function, *arguments):
    points = [exact(a) for a in arguments]
    # mpmath's own working precision does not follow very large arguments.
    extra = max(0, int(mpmath.log10(abs(points[-1]) + 1))) + (80 if abs(points[-1]) > 20 else 20)
    with mp.workdps(60 + extra):
        value = function(*points)
    size = abs(value)
    if not mpmath.isfinite(value) or size > mpf("1.7e308") or (size != 0 and size < mpf("1e-306")):
        return
    rows.append(f"{name},{';'.join(text(a) for a in arguments)},{mp.nstr(value, 45, min_fixed=0, max_fixed=0) if value else '0'}")


def words(x):
    """A double and half an ulp's worth of rest."""
    return (x, x * rng.uniform(-1, 1) * 2.0**-54)


def tail(n, z, s):
    """H_n − Y_n (s = 1) or I_n − L_n (s = −1) for large z."""
    total, k, last = mpf(0), 0, None
    while k < 2000:
        term = (-s) ** k * (-1) ** k * mpmath.gamma(k + mpf(1) / 2) * (z / 2) ** (n - 2 * k - 1) * mpmath.rgamma(n + mpf(1) / 2 - k) / mp.pi
        if last is not None and abs(term) >= abs(last):
            break
        total += term
        if abs(term) < abs(total) * mpf(10) ** -(mp.dps + 2):
            break
        last, k = term, k + 1
    return total


def struveh(n, z):
    if abs(z) < 200:
        return mpmath.struveh(n, z)
    size = abs(z)
    value = mpmath.bessely(n, size) + tail(n, size, 1)
    return value if z > 0 or int(n) % 2 else -value


def difference(n, z):
    if abs(z) < 200:
        with mp.workdps(mp.dps + int(z) + 10):
            return mpmath.besseli(abs(n), z) - mpmath.struvel(n, z)
    return tail(n, z, -1)


def struvel(n, z):
    return mpmath.struvel(n, z) if abs(z) < 1000 else mpmath.inf


def scaled(n, z):
    # mpmath's asymptotic series of I needs no exponentials of its own here.
    if z < 2000:
        return mpmath.exp(-z) * mpmath.besseli(n, z)
    total, term, k = mpf(1), mpf(1), 1
    while abs(term) > mpf(10) ** -(mp.dps + 5) and k < 3000:
        term *= ((2 * k - 1) ** 2 - 4 * n * n) / (8 * k * z)
        total += term
        k += 1
    return total / mpmath.sqrt(2 * mp.pi * z)


def near_zero(function, n, index):
    """Doubles next to a zero of the function."""
    guess = (index + n / 2 - 0.25) * math.pi if function is mpmath.besselj else (index + n / 2 + 0.25) * math.pi
    try:
        zero = float(mpmath.findroot(lambda z: function(n, z), guess, tol=1e-30))
    except ValueError:
        return []
    return [zero, math.nextafter(zero, 0.0), zero * (1 + 1e-9)]


EDGES = [1e-300, 1e-160, 1e-20, 1e-8, 0.01, 0.5, 1.0, 1.999, 2.0, 2.1, 3.999, 4.0, 5.999, 6.0, 9.0, 39.9, 40.0, 40.1, 81.9, 82.0, 82.1, 1e3, 1e6]


def points(count, top):
    return EDGES + [log_uniform(1e-6, top) for _ in range(count)] + [rng.uniform(0, 45) for _ in range(count)] + \
        [rng.uniform(0, 120) for _ in range(count // 2)] + [words(rng.uniform(0.1, 100)) for _ in range(count // 2)]


for n in [0.0, 1.0, 2.0, 3.0, 7.0, 20.0, -1.0]:
    few = 24 if n < 2 else 8
    for z in points(few, 1e5) + ([1e12, 1e15, 1e20, 1e300] if n >= 0 else []):
        add("besselj", mpmath.besselj, n, z)
    if n >= 0:
        for z in points(few, 700.0) + [650.0, 700.0, 712.0, -3.5]:
            add("besseli", mpmath.besseli, n, z)
        for z in points(few, 1e5) + [1e12, 1e300]:
            add("besseli_scaled", scaled, n, z)
for n in [0.5, 1.5, 2.5, 0.25, 3.3, -0.5, -0.3, 10.75]:
    for z in points(6, 1e4):
        add("besselj", mpmath.besselj, n, z)
        add("besselj", mpmath.besselj, words(n), z)
    for z in points(6, 700.0):
        add("besseli", mpmath.besseli, n, z)
        add("besseli", mpmath.besseli, words(n), z)
for n, z in [(100.0, 3.0), (100.0, 99.0), (100.0, 101.0), (100.0, 500.0), (1000.0, 900.0), (1000.0, 1500.0), (50.0, 45.0), (60.0, 61.0), (30.0, 1e4)]:
    add("besselj", mpmath.besselj, n, z)
    add("besseli", mpmath.besseli, n, z)
for n in [-1.0, 0.0, 1.0, 2.0, 3.0, 6.0, 15.0]:
    few = 24 if n < 2 else 8
    for z in points(few, 1e5) + [-2.5, -50.0, 1e12]:
        add("struveh", struveh, n, z)
    for z in points(few, 700.0) + [700.0, 712.0, -2.5]:
        add("struvel", struvel, n, z)
    for z in points(few, 1e5) + ([4.49, 5.6, 8.7, 13.4, 17.0, 21.4, 26.9, 33.4, 41.4, 51.4, 63.9] if n < 2 else []) + [1e12]:
        add("bessel_struve", difference, n, z)
for n, z in [(40.0, 30.0), (40.0, 50.0), (40.0, 100.0), (9.0, 100.0), (9.0, 1e3)]:
    add("struveh", struveh, n, z)
    add("struvel", struvel, n, z)
    add("bessel_struve", difference, n, z)
for index in [1, 2, 3, 5, 6, 9, 13, 18, 20, 27, 33, 100, 1000]:
    for n in [0, 1, 2]:
        for z in near_zero(mpmath.besselj, n, index):
            add("besselj", mpmath.besselj, float(n), z)
    if index < 60:
        for z in near_zero(mpmath.struveh, 0, index) + near_zero(mpmath.struveh, -1, index):
            add("struveh", struveh, 0.0, z)
            add("struveh", struveh, -1.0, z)
for index in [10**4, 10**5, 10**8]:
    z = float((index - mpf(1) / 4) * mp.pi + 1 / (8 * index * mp.pi))
    add("besselj", mpmath.besselj, 0.0, z)

dawson = lambda z: mpmath.sqrt(mp.pi) / 2 * mpmath.exp(-z * z) * mpmath.erfi(z) if abs(z) < 60 else None
LINE = EDGES[:-2] + [8.999, 9.001, 12.0, 26.0, -1.5] + [log_uniform(1e-6, 9) for _ in range(60)] + [rng.uniform(0, 27) for _ in range(60)] + \
    [words(rng.uniform(0.1, 26)) for _ in range(30)]


def dawson(z):
    if abs(z) < 100:
        with mp.workdps(mp.dps + int(abs(z) ** 2)):
            return mpmath.sqrt(mp.pi) / 2 * mpmath.exp(-z * z) * mpmath.erfi(z)
    total, term, k = mpf(1), mpf(1), 1
    while abs(term) > mpf(10) ** -(mp.dps + 5):
        term *= (2 * k - 1) / (2 * z * z)
        total += term
        k += 1
    return total / (2 * z)


for z in LINE:
    add("erf", mpmath.erf, z)
    add("erfi", mpmath.erfi, z)
for z in LINE + [1e3, 1e6, 1e15, 1e300, -1e6] + [rng.uniform(8, 12) for _ in range(20)]:
    add("dawson", dawson, z)
for z in EDGES[:-1] + [0.797, 0.799, 7.22, 7.23, 1e4, -0.5] + [log_uniform(1e-6, 50) for _ in range(80)] + [rng.uniform(0, 9) for _ in range(80)] + \
        [words(rng.uniform(0.1, 20)) for _ in range(40)]:
    add("fresnelc", mpmath.fresnelc, z)
    add("fresnels", mpmath.fresnels, z)
for z in [1e6, 123456789.125, 1e15]:
    for name, sign in [("fresnelc", 1), ("fresnels", -1)]:
        def large(z, sign=sign):
            with mp.workdps(150):
                w, u = 1 / (mp.pi * z * z), mp.pi * z * z / 2
                f = (1 - 3 * w**2 + 105 * w**4 - 10395 * w**6 + 2027025 * w**8) / (mp.pi * z)
                g = (1 - 15 * w**2 + 945 * w**4 - 135135 * w**6) / (mp.pi**2 * z**3)
                s, c = mpmath.sin(u), mpmath.cos(u)
                return mpf(1) / 2 + (f * s - g * c if sign > 0 else -f * c - g * s)
        add(name, large, z)

target = Path(__file__).with_name("waves.csv")
target.write_text("function,arguments,value\n" + "\n".join(rows) + "\n")
print(f"{len(rows)} rows", file=sys.stderr)
