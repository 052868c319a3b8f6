#!/usr/bin/env python3
"""Writes second.csv: 60-digit values of random expressions, many of which cancel, for the bounds of the second pass.

Run:  python3 tests/oracle/second.py            (needs mpmath 1.3; a minute; deterministic)

Each row: expression in x and y, x, y (exact doubles as repr prints them), value.
"""
import math
import random
from fractions import Fraction
from pathlib import Path

from mpmath import mp, mpf

mp.dps = 120
rng = random.Random(4711)
rows = []

UNARY = {
    "exp": mp.exp, "ln": mp.log, "sin": mp.sin, "cos": mp.cos, "tan": mp.tan, "asin": mp.asin, "acos": mp.acos, "atan": mp.atan,
    "sinh": mp.sinh, "cosh": mp.cosh, "tanh": mp.tanh, "asinh": mp.asinh, "acosh": mp.acosh, "atanh": mp.atanh, "sqrt": mp.sqrt,
    "abs": abs,
}
BINARY = {"+": lambda a, b: a + b, "-": lambda a, b: a - b, "*": lambda a, b: a * b, "/": lambda a, b: a / b}


class Outside(Exception):
    pass


def real(value):
    if isinstance(value, mp.mpc) or not mp.isfinite(value) or (value != 0 and not mpf("1e-200") < abs(value) < mpf("1e200")):
        raise Outside
    return value


def leaf(point):
    kind = rng.random()
    if kind < 0.35:
        return "x", point[0]
    if kind < 0.6:
        return "y", point[1]
    if kind < 0.85:
        p, q = rng.randint(1, 40), rng.randint(1, 12)
        return f"({p}/{q})", mpf(p) / q
    if kind < 0.93:
        p = rng.randint(1, 10**6)
        return f"{p}e-5", mpf(p) / 10**5
    return rng.choice([("pi", mp.pi), ("e", mp.e)])


def tree(point, depth):
    """A random expression: its text and its value."""
    kind = rng.random()
    if depth == 0 or kind < 0.1:
        text, value = leaf(point)
        return text, +value
    if kind < 0.5:
        (a, u), (b, v) = tree(point, depth - 1), tree(point, depth - 1)
        sign = rng.choice("+-*/")
        if sign == "/" and v == 0:
            raise Outside
        return f"({a}{sign}{b})", real(BINARY[sign](u, v))
    a, u = tree(point, depth - 1)
    if kind < 0.62:
        power = rng.choice([2, 3, 4, 7, -1, -2, -5, Fraction(1, 2), Fraction(3, 2), Fraction(-1, 2), Fraction(5, 2), Fraction(7, 10), Fraction(-4, 3)])
        if u <= 0:
            raise Outside
        return f"({a})^({power})", real(u ** (mpf(power.numerator) / power.denominator))
    if kind < 0.65:
        b, v = tree(point, depth - 1)
        if rng.random() < 0.5:
            return f"max({a},{b})", max(u, v)
        return f"min({a},{b})", min(u, v)
    name = rng.choice(list(UNARY))
    if name in ("ln", "sqrt") and u <= 0 or name in ("asin", "acos", "atanh") and abs(u) >= 1 or name == "acosh" and u <= 1:
        raise Outside
    if name in ("exp", "sinh", "cosh") and abs(u) > 200:
        raise Outside
    return f"{name}({a})", real(UNARY[name](u))


def cancelled(point):
    """An expression that mostly cancels here: less its own value to a few digits, or a difference of neighbours."""
    a, u = tree(point, rng.randint(1, 4))
    if u == 0:
        raise Outside
    digits = rng.randint(3, 22)
    near = mp.nstr(abs(u), digits, strip_zeros=False, min_fixed=0, max_fixed=0)
    value = u - mpf(near) if u > 0 else u + mpf(near)
    text = f"{a}-{near}" if u > 0 else f"{a}+{near}"
    return f"({text})", value


def neighbours(point):
    """f(u + h) - f(u) - f'(u) h of a function with simple parts, h tiny."""
    h = f"1e-{rng.randint(3, 12)}"
    step = mpf(h)
    u, name = point[0], rng.choice(["exp", "sin", "cos", "ln", "atan", "asinh", "sqrt", "cosh", "sinh"])
    f = UNARY[name]
    if rng.random() < 0.5:
        return f"({name}(x+{h})-{name}(x))", f(u + step) - f(u)
    return f"({name}(x+{h})+{name}(x)-2*{name}(x+{h}/2))", f(u + step) + f(u) - 2 * f(u + step / 2)


def profile_like(point):
    """What closed forms of the transform look like near a kink or near the axis: u tiny."""
    x, y = point
    u = f"1e-{rng.randint(2, 9)}"
    t = mpf(u) * x
    b = y
    return rng.choice([
        (f"(({u}*x)^2-y^2)*atan({u}*x/y)+{u}*x*y", (t**2 - b**2) * mp.atan(t / b) + t * b),
        (f"(({u}*x)^2+y^2)*atanh({u}*x/y)-{u}*x*y", (t**2 + b**2) * mp.atanh(t / b) - t * b),
        (f"(y+{u}*x)*acos(y/(y+{u}*x))-sqrt((y+{u}*x)^2-y^2)", (b + t) * mp.acos(b / (b + t)) - mp.sqrt((b + t) ** 2 - b**2)),
        (f"y*(sqrt(1+({u}*x/y)^2)-1)-({u}*x)^2/(2*y)", b * (mp.sqrt(1 + (t / b) ** 2) - 1) - t**2 / (2 * b)),
        (f"{u}*x*ln(1+{u}*x/y)-({u}*x)^2/y+({u}*x)^3/(2*y^2)", t * mp.log(1 + t / b) - t**2 / b + t**3 / (2 * b**2)),
    ])


SPECIAL = [
    ("gamma({})", mp.gamma, 0.1, 20), ("digamma({})", mp.digamma, 0.1, 20), ("erf({})", mp.erf, 0.01, 5), ("erfi({})", mp.erfi, 0.01, 4),
    ("ellipk({})", mp.ellipk, 0.01, 0.99), ("ellipe({})", mp.ellipe, 0.01, 0.99), ("besselj(0,{})", lambda u: mp.besselj(0, u), 0.01, 30),
    ("besselj(1,{})", lambda u: mp.besselj(1, u), 0.01, 30), ("besseli(0,{})", lambda u: mp.besseli(0, u), 0.01, 20),
    ("polylog(2,{})", lambda u: mp.polylog(2, u), 0.01, 0.9),
]


def special(point):
    """A special function of an inexact argument, alone or with what cancels it."""
    a, u = tree(point, rng.randint(1, 3))
    form, f, low, high = rng.choice(SPECIAL)
    if not low < u < high:
        raise Outside
    value, text = f(u), form.format(a)
    if rng.random() < 0.5 or value == 0:
        return text, value
    near = mp.nstr(abs(value), rng.randint(3, 16), strip_zeros=False, min_fixed=0, max_fixed=0)
    return f"({text}-{near})" if value > 0 else f"({text}+{near})", value - mpf(near) if value > 0 else value + mpf(near)


def main():
    kinds = [(special, 500), (lambda p: tree(p, rng.randint(2, 5)), 900), (cancelled, 900), (neighbours, 300), (profile_like, 300)]
    for make, count in kinds:
        done = 0
        while done < count:
            x = rng.choice([rng.uniform(0.05, 3), math.exp(rng.uniform(-8, 8)), rng.randint(1, 64) / 8])
            y = rng.choice([rng.uniform(0.05, 3), math.exp(rng.uniform(-5, 5))])
            point = mpf(x), mpf(y)
            try:
                text, value = make(point)
                if isinstance(value, mp.mpc) or not mp.isfinite(value) or len(text) > 300:
                    continue
                # Not a large number: tan π is 0.
                if "/tan(pi)" in text or "/sin(pi)" in text:
                    continue
                # What cancels beyond 60 digits is not known here.
                if value != 0 and not mpf("1e-45") < abs(value) < mpf("1e150"):
                    continue
            except (Outside, OverflowError, ZeroDivisionError, ValueError):
                continue
            if "x" not in text.replace("exp", "").replace("max", ""):
                continue
            rows.append(f"{text};{x!r};{y!r};{mp.nstr(value, 60, min_fixed=0, max_fixed=0) if value else '0'}")
            done += 1
    Path(__file__).with_name("second.csv").write_text("\n".join(rows) + "\n")


main()
