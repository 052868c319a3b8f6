#!/usr/bin/env python3
"""Writes cancelling.csv: 40-digit values of profiles whose closed forms cancel, within a term, between terms, and between chains.

Run:  python3 tests/oracle/cancelling.py            (needs mpmath 1.3; seconds; deterministic)

Each row: profile, quantity, place (x, a, or r and a, exact doubles as repr prints them), value. F is F/(2E*), p is p pi/E*.
"""
from pathlib import Path

from mpmath import mp, mpf

mp.dps = 80
rows = []


def row(profile, quantity, place, value):
    text = ",".join(repr(float(p)) for p in place)
    rows.append(f"{profile};{quantity};{text};{mp.nstr(value, 40, min_fixed=0, max_fixed=0)}")


def kappa(n):
    return mp.sqrt(mp.pi) * mp.gamma(mpf(n) / 2 + 1) / mp.gamma(mpf(n) / 2 + mpf(1) / 2)


# A cone taken from a paraboloid: next to the zeros of g, F, p and G.
A, B = mpf(7) / 10, mpf(3) / 10
text = "0.7*r^2-0.3*r"
g = lambda x: A * 2 * x**2 - B * mp.pi / 2 * x
force = lambda a: A * 4 * a**3 / 3 - B * mp.pi / 4 * a**2
area = lambda a: A * 2 * a**3 / 3 - B * mp.pi / 4 * a**2
for k in range(2, 16):
    for quantity, f, zero in (("g", g, B * mp.pi / (4 * A)), ("F", force, 3 * B * mp.pi / (16 * A)), ("G", area, 3 * B * mp.pi / (8 * A))):
        for side in (1, -1):
            at = mpf(float(zero * (1 + side * mpf(10) ** -k)))
            row(text, quantity, (at,), f(at))
    r = mpf(1) / 2
    p = lambda a: A * 4 * mp.sqrt(a**2 - r**2) - B * mp.pi / 2 * mp.acosh(a / r)
    # For p the parameter is tuned instead of the place.
    a = mpf("0.75")
    C = mpf(mp.nstr(A * 4 * mp.sqrt(a**2 - r**2) / (mp.pi / 2 * mp.acosh(a / r)), k))
    row(f"0.7*r^2-{mp.nstr(C, k, strip_zeros=False)}*r", "p", (r, a), A * 4 * mp.sqrt(a**2 - r**2) - C * mp.pi / 2 * mp.acosh(a / r))

# Segments next to their kink: r = b + (x - b) t, smooth after t = 1 - u^2.
for b in ("1", "0.7"):
    b = mpf(b)
    for exponent in (2, 3):
        for k in range(1, 13):
            x = mpf(float(b * (1 + mpf(10) ** -k)))
            h = x - b

            def moment(weight):
                def inner(u):
                    t = 1 - u * u
                    r = b + h * t
                    # f'(r) dr / sqrt(x^2 - r^2), dr = -2 h u du, x - r = h u^2
                    return weight(r) * exponent * (h * t) ** (exponent - 1) * 2 * mp.sqrt(h) / mp.sqrt(x + r)
                return mp.quad(inner, [0, 1])

            profile = f"piecewise(0, r<{mp.nstr(b, 3)}, (r-{mp.nstr(b, 3)})^{exponent})"
            row(profile, "g", (x,), x * moment(lambda r: 1))
            row(profile, "F", (x,), moment(lambda r: r * r))

# The hyperboloid at small a, and what is left of it when its paraboloid is taken away: between terms.
for k in range(0, 10):
    a = mpf(float(mpf(10) ** -k * mpf("0.77")))
    profile = "sqrt(1+r^2)-1"
    row(profile, "h", (a,), mp.sqrt(1 + a * a) - 1)
    row(profile, "g", (a,), a * mp.atan(a))
    row(profile, "F", (a,), ((a * a - 1) * mp.atan(a) + a) / 2)
    row(profile, "G", (a,), ((a * a + 1) * mp.atan(a) - a) / 2)
    if k < 5:
        profile = "r^2/2+1-sqrt(1+r^2)"
        row(profile, "h", (a,), a * a / 2 + 1 - mp.sqrt(1 + a * a))
        row(profile, "g", (a,), a * a - a * mp.atan(a))
        row(profile, "F", (a,), 2 * a**3 / 3 - ((a * a - 1) * mp.atan(a) + a) / 2)
        if k < 4:  # what is left of 30 digits beyond that is no double
            row(profile, "G", (a,), a**3 / 3 - ((a * a + 1) * mp.atan(a) - a) / 2)

# The heights of profiles that start flat.
for k in range(0, 9):
    r = mpf(float(mpf(10) ** -k * mpf("1.3")))
    row("cosh(r)-1", "h", (r,), mp.cosh(r) - 1)
    row("2-cos(r)", "h", (r,), 1 - mp.cos(r))
    row("exp(r)-r", "h", (r,), mp.exp(r) - 1 - r)
    row("r-atan(r)+pi", "h", (r,), r - mp.atan(r))

# Chains that cancel: a worn paraboloid against a paraboloid, next to the zero of g.
b, c = mpf("0.8"), mpf("0.9")
g = lambda x: x * mp.sqrt(x * x - b * b) - c * x * x / 2
zero = mp.findroot(g, mpf("0.9"))
for k in range(2, 14):
    x = mpf(float(zero * (1 + mpf(10) ** -k)))
    row("piecewise(0, r<0.8, (r^2-0.64)/2)-0.225*r^2", "g", (x,), g(x))

Path(__file__).with_name("cancelling.csv").write_text("\n".join(rows) + "\n")
