#!/usr/bin/env python3
"""Writes closures.csv: 40-digit values of g, F/(2E*), G, p*pi/E* and u for profiles without closed forms.

Run:  python3 tests/oracle/closures.py            (needs mpmath 1.3; a minute or two; deterministic)

By the definitions, nested where they are nested: p from g'(x) = int_0^(pi/2) (f' + r f'') dt, never from the single
integral that the program uses. Each row: profile, quantity, r (0 where there is none), a, value.
"""
from pathlib import Path

from mpmath import acosh, asin, cos, mp, mpf, pi, quad, sin, sqrt, tanh, cosh

mp.dps = 40

# name: pieces (lower end, f', f''), upper limit
PROFILES = {
    "ln_cosh": [(mpf(0), lambda r: tanh(r), lambda r: 1 / cosh(r) ** 2)],
    "saturating": [(mpf(0), lambda r: r * (2 + r) / (1 + r) ** 2, lambda r: 2 / (1 + r) ** 3)],
    "sphere": [(mpf(0), lambda r: r / sqrt((2 - r) * (2 + r)), lambda r: 4 / ((2 - r) * (2 + r)) ** mpf(1.5))],
    "steep": [(mpf(0), lambda r: mpf(1.5) * sqrt(r) + 3 * r**2 * cos(r**3), lambda r: mpf("0.75") / sqrt(r) + 6 * r * cos(r**3) - 9 * r**4 * sin(r**3))],
    # A rounded tip that goes over into a steeper, wavy flank at r = 1/2: f' jumps by 3/4.
    "kinked": [
        (mpf(0), lambda r: r, lambda r: mpf(1)),
        (mpf(1) / 2, lambda r: mpf(5) / 4 + sin(3 * (r - mpf(1) / 2)) / 4, lambda r: 3 * cos(3 * (r - mpf(1) / 2)) / 4),
    ],
}
PLACES = {"ln_cosh": [0.3, 1, 4.5], "saturating": [0.01, 1, 20], "sphere": [0.25, 1.5, 1.96875], "steep": [0.125, 1.25], "kinked": [0.53125, 0.75, 2.5]}


def pieces(name, end):
    list_ = PROFILES[name]
    for index, (lower, slope, second) in enumerate(list_):
        upper = list_[index + 1][0] if index + 1 < len(list_) else None
        if lower < end:
            yield lower, (end if upper is None else min(upper, end)), slope, second


def over_angle(name, x, weight):
    total = mpf(0)
    for lower, upper, slope, second in pieces(name, x):
        # r = x sin t, and t = t1 - v^2 ... the ends are regular or algebraic: tanh-sinh deals with both.
        total += quad(lambda t: weight(x * sin(t), t, slope, second), [asin(lower / x), asin(upper / x)])
    return total


def g(name, x):
    return x * over_angle(name, x, lambda r, t, slope, second: slope(r))


def gprime(name, x):
    total = over_angle(name, x, lambda r, t, slope, second: slope(r) + r * second(r))
    list_ = PROFILES[name]
    for (_, before, _), (b, after, _) in zip(list_, list_[1:]):
        if b < x:
            # The angle acos(b/x) of the jump is already in the integral over f' beyond b.
            total += (after(b) - before(b)) * b / sqrt((x - b) * (x + b))
    return total


def force(name, a):
    return over_angle(name, a, lambda r, t, slope, second: r**2 * slope(r))


def integral(name, a):
    return a**2 * over_angle(name, a, lambda r, t, slope, second: cos(t) ** 2 * slope(r))


def from_roots(f, ends):
    """The integral over all intervals, each in v with x = lower end + v^2: f may have an inverse root there."""
    total = mpf(0)
    for lower, upper in zip(ends, ends[1:]):
        total += quad(lambda v: 2 * v * f(lower + v * v), [0, sqrt(upper - lower)])
    return total


def pressure(name, s, a):
    # x = s cosh u; g' has inverse roots beyond kinks.
    ends = [mpf(0)]
    for lower, *_ in PROFILES[name]:
        if s < lower < a:
            ends.append(acosh(lower / s))
    ends.append(acosh(a / s))
    return from_roots(lambda u: gprime(name, s * cosh(u)), ends)


def outside(name, r, a):
    # By parts, u = (2/pi) int_0^a g'(x) asin(x/r) dx.
    ends = [mpf(0)] + [lower for lower, *_ in PROFILES[name] if 0 < lower < a] + [a]
    return 2 / pi * from_roots(lambda x: gprime(name, x) * asin(x / r), ends)


rows = []
for name, places in PLACES.items():
    for place in places:
        a = mpf(place)
        for quantity, value in (("g", g(name, a)), ("F", force(name, a)), ("G", integral(name, a))):
            rows.append((name, quantity, 0, place, value))
        mp.dps = 24
        for part in (0.25, 0.875):
            s = place * part
            rows.append((name, "p", s, place, pressure(name, mpf(s), a)))
        r = place * 1.25
        rows.append((name, "u", r, place, outside(name, mpf(r), a)))
        mp.dps = 40

text = "profile,quantity,r,a,value\n" + "".join(f"{n},{q},{r!r},{a!r},{mp.nstr(v, 22)}\n" for n, q, r, a, v in rows)
Path(__file__).with_suffix(".csv").write_text(text)
