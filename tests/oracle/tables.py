#!/usr/bin/env python3
"""Writes tables.csv: 50-digit values of g, F/(2E*), G, p*pi/E* and u for profiles of many cubic pieces.

Run:  python3 tests/oracle/tables.py            (needs mpmath 1.3; minutes; deterministic)

The pieces are made by the same little generator as in tests/values/tables.rs; their numbers are dyadic, hence exact in doubles.
g, F and G are sums of the closed segment integrals J_m, formed with 80 digits so that nothing of their cancellation
shows; p and u are integrals over g' as their definitions say. Each row: table, quantity, r (0 where there is none), a, value.
"""
from pathlib import Path

from mpmath import acosh, asin, cosh, mp, mpf, pi, quad, sqrt

mp.dps = 80


def pieces(count, fine, kink):
    """Lists lower, upper, c1, c2, c3 of f = ... + c1 d + c2 d^2 + c3 d^3."""
    state, lower, slope, out = 12345, mpf(0), mpf(0), []
    for index in range(count):
        state = (1103515245 * state + 12345) % 2**31
        width = mpf(2) ** (-fine - (state >> 16) % 3)
        rise = mpf((state >> 10) % 64 - 12) / 256 * width * 8
        bump = mpf((state >> 20) % 16 - 8) / 64
        if index == kink:
            slope += mpf(1) / 4
        out.append((lower, lower + width, slope, rise / (2 * width) + 3 * bump * width / 2, -bump))
        lower, slope = lower + width, slope + rise
    return out


TABLES = {"few": (24, 2, -1), "kinked": (24, 2, 11), "hundred": (100, 4, -1), "many": (10000, 10, -1)}


def polynomial(piece):
    b, _, c1, c2, c3 = piece
    # f' = c1 + 2 c2 (r-b) + 3 c3 (r-b)^2 in powers of r
    return [c1 - 2 * c2 * b + 3 * c3 * b * b, 2 * c2 - 6 * c3 * b, 3 * c3]


def moments(b, c, x):
    """J_0 .. J_4 on [b, c] with weight 1/sqrt(x^2-r^2)."""
    wb, wc = sqrt((x - b) * (x + b)), sqrt((x - c) * (x + c))
    j = [asin(c / x) - asin(b / x), wb - wc]
    for m in (2, 3, 4):
        j.append(((m - 1) * x * x * j[m - 2] + b ** (m - 1) * wb - c ** (m - 1) * wc) / m)
    return j


def sums(table, x):
    slope = force = mpf(0)
    for piece in table:
        if piece[0] >= x:
            break
        j = moments(piece[0], min(piece[1], x), x)
        q = polynomial(piece)
        slope += sum(q[m] * j[m] for m in range(3))
        force += sum(q[m] * j[m + 2] for m in range(3))
    return x * slope, force, x * x * slope - force


def gprime(table, x):
    """g' = (1/x) T[r f'] with kinks: int (r f')'/sqrt(x^2-r^2) dr + sum b jump / sqrt(x^2-b^2)."""
    total, end = mpf(0), None
    for piece in table:
        b, c, c1, c2, c3 = piece
        if b >= x:
            break
        q = polynomial(piece)
        j = moments(b, min(c, x), x)
        total += sum((m + 1) * q[m] * j[m] for m in range(3))
        if end is not None and c1 != end:
            total += b * (c1 - end) / sqrt((x - b) * (x + b))
        d = c - b
        end = c1 + 2 * c2 * d + 3 * c3 * d * d
    return total


def from_roots(f, ends):
    """The integral over all intervals, each in v with x = lower end + v^2: f may have an inverse root there."""
    total = mpf(0)
    for lower, upper in zip(ends, ends[1:]):
        total += quad(lambda v: 2 * v * f(lower + v * v), [0, sqrt(upper - lower)])
    return total


rows = []
for name, (count, fine, kink) in TABLES.items():
    mp.dps = 80
    table = pieces(count, fine, kink)
    last = table[-1][1]
    knots = [table[int(count * part)][0] for part in (0.1, 0.5, 0.9)]
    places = [float(table[0][1]) / 1024, float(table[0][1]), float(last)]
    for knot in knots:
        places += [float(knot), float(knot) * (1 + 2.0**-40), float(knot) * (1 + 2.0**-13)]
    places += [float(last) * part for part in (0.333251953125, 0.70703125, 0.9990234375)]
    for x in places:
        for quantity, value in zip("gFG", sums(table, mpf(x))):
            rows.append((name, quantity, 0.0, x, value))
    if count > 24:
        continue
    mp.dps = 30
    for part in (0.40625, 0.9375):
        a = mpf(float(last) * part)
        inner = [piece[0] for piece in table if 0 < piece[0] < a]
        for share in (0.1875, 0.84375):
            s = a * share
            ends = [mpf(0)] + [acosh(b / s) for b in inner if b > s] + [acosh(a / s)]
            rows.append((name, "p", float(s), float(a), from_roots(lambda u: gprime(table, s * cosh(u)), ends)))
        r = a * mpf(1.125)
        value = 2 / pi * from_roots(lambda x: gprime(table, x) * asin(x / r), [mpf(0)] + inner + [a])
        rows.append((name, "u", float(r), float(a), value))

text = "table,quantity,r,a,value\n"
for n, q, r, a, v in rows:
    mp.dps = 30
    text += f"{n},{q},{r!r},{a!r},{mp.nstr(v, 20 if q in 'pu' else 25)}\n"
Path(__file__).with_suffix(".csv").write_text(text)
