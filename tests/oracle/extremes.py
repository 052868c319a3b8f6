#!/usr/bin/env python3
"""Writes extremes.csv: every rule's quantities in the corners of their domain, from its stated formulas at 50 digits or more.

Run:  cargo run --release -- rules --json | python3 tests/oracle/extremes.py [RULE …] > tests/oracle/extremes.csv
      (needs mpmath 1.3; deterministic; an hour)

The corners come from the rule's own data: breakpoints from its pattern, the limit R, lengths, wave numbers, exponents.
g, F and p are the stated formulas, which tests/oracle/statements.py holds against their definitions; G = a g − F/(2E);
u = (2/π) ∫ (g(a) − g(r sin t)) dt and U = E ∫ (g(a) − g)² dx are quadratures of the stated g, and so is p where none is stated.
Digits are added until two precisions agree to 28 digits.
Each row: rule; corner; quantity; arguments (name=value, exact doubles as repr prints them); value, 25 digits, `inf` and 0 beyond 1e±400;
condition number: the sum of |v ∂ ln|value|/∂v| over all arguments but E.
"""
import io
import json
import math
import re
import signal
import sys
from contextlib import redirect_stdout

from mpmath import mp, mpf, asin, acosh, cosh, sin, quad

ONLY = sys.argv[1:]
with redirect_stdout(io.StringIO()):
    # The formulas' reader is that of the random places; its own run needs an empty list of rules.
    saved, sys.stdin, sys.argv = sys.stdin, io.StringIO('{"rules": []}'), sys.argv[:1]
    sys.path.insert(0, __file__.rsplit("/", 1)[0])
    from statements import Formula
    sys.stdin = saved

PATIENCE = 4
DIGITS = mpf(10) ** -28
# The corners of quadratures over special functions, which take long.
FEW = ("r/a = 1e-08", "r/a = 0.5", "r/a = 1 - 1e-08", "a/s = 1e-08", "r/a = 1 + 1e-8", "r/a = 1.25", "a/s = 1e-8", "middle", "a/b = 1 + 1e-08",
       "r = b/2", "a/b = 1 + 1e-8")
# Few precisions, because mpmath keeps the coefficients of each.
LADDER = (80, 200, 460, 900, 1500, 3000, 6000)
UP = lambda x: math.nextafter(x, math.inf)
DOWN = lambda x: math.nextafter(x, -math.inf)
sys.set_int_max_str_digits(0)


class Slow(Exception):
    pass


def alarm(*_):
    raise Slow


signal.signal(signal.SIGVTALRM, alarm)


def patience(seconds):
    """Processor time, so that a busy machine leaves nothing more out."""
    signal.setitimer(signal.ITIMER_VIRTUAL, seconds)


def exact(values):
    return {name: mpf(value) for name, value in values.items()}


def span_of(values):
    """How many digits lie between the lengths; a wave number is the inverse of one, up to a square."""
    sizes = [math.log10(v) for name, v in values.items() if name in "abcwRr"]
    sizes += [-math.log10(v) for name, v in values.items() if name in "kq"]
    return max(sizes) - min(sizes) if sizes else 0


def at(formula, values):
    try:
        return formula(values)
    except ZeroDivisionError as error:
        raise ValueError from error


def sure(evaluate, values):
    """The value at the first precision that the next one confirms, and that precision."""
    before = None
    for digits in LADDER:
        with mp.workdps(digits):
            try:
                now = evaluate(exact(values))
            except ValueError:
                now = None
            if now is not None and before is not None and now != 0 and abs(before / now - 1) < DIGITS:
                return now, digits
        before = now
    raise ValueError("no digits")


def condition(evaluate, values, digits):
    """Differences with a step far below every distance between the arguments."""
    total = mpf(0)
    with mp.workdps(next((d for d in LADDER if d >= digits + 100), 9000)):
        own = evaluate(exact(values))
        step = mpf(10) ** -60
        for name, value in values.items():
            if name == "E" or value == 0:
                continue
            try:
                near = evaluate(exact(values) | {name: mpf(value) * (1 + step)})
            except ValueError:
                near = evaluate(exact(values) | {name: mpf(value) * (1 - step)})
            total += abs((near - own) / (step * own))
    return total


class Rule:
    """A rule with its formulas and what its data tell of corners."""

    def __init__(self, entry):
        self.id, self.pattern = entry["id"], entry["pattern"]
        self.slope, self.force = (Formula(entry["result"][q]) for q in "gF")
        self.stress = Formula(entry["result"]["p"]) if entry["result"]["p"] else None
        self.base = {}
        for p in entry["parameters"]:
            self.base[p["name"]] = round(math.sqrt(p["lowest"] * p["highest"]) * 64) / 64
        found = re.search(r"r<([a-z])\b", self.pattern)
        self.end = found[1] if found else None
        self.limit = "R" if "R" in self.base else None
        self.waves = [name for name in self.base if name in "kq"]
        self.exponent = next((name for name in self.base if name in "np"), None)
        self.lengths = [name for name in self.base if name in "bcwR"]
        self.scaled = next((name for name in self.lengths if name != self.end), None)
        self.power = 2 if re.search(r"k\*r\^2", self.pattern) else 1
        self.rough = False
        stated = " ".join(filter(None, entry["result"].values()))
        self.slow = re.search(r"bessel|struve|hyp|erf|dawson|fresnel|gamma|beta|ellip|polylog|clsin", stated) is not None
        self.oscillates = bool(self.waves)

    def scale(self, v):
        """The length with which radii are compared."""
        if self.scaled:
            return v[self.scaled]
        if self.waves:
            return v[self.waves[0]] ** (-1 / self.power)
        return v[self.end] if self.end else 1.0

    def stretched(self, factor):
        """Every length and wave number in other units."""
        v = dict(self.base)
        for name in self.lengths:
            v[name] *= factor
        for name in self.waves:
            # A square of the factor that is no double leaves a wave number that row() passes over.
            v[name] = v[name] / factor if self.power == 1 else v[name] / factor / factor
        return v

    def radii(self):
        """(corner, parameters, radius) for g, F and G."""
        v, s = self.base, self.scale(self.base)
        if self.end is None:
            for part in (1e-300, 1e-200, 1e-100, 1e-30, 1e-16, 1e-12, 1e-8, 1e-4, 0.01, 0.5):
                yield f"x/s = {part:g}", v, part * s
            if self.limit:
                yield "x/R = 0.9", v, 0.9 * s
                for gap in (1e-3, 1e-6, 1e-12):
                    yield f"x/R = 1 - {gap:g}", v, s * (1 - gap)
                yield "x/R = 1 - 1e-16", v, DOWN(s)
            else:
                for part in (2.0, 30.0, 1e3, 1e6) + (() if self.oscillates else (1e8, 1e16, 1e100, 1e300)):
                    yield f"x/s = {part:g}", v, part * s
        else:
            yield from self.beyond()
        if self.exponent:
            for n in (1e-300, 1e-12, 1e-3, 30.5, 341.0, 342.0, 341.7, 1e4):
                own, radius = v | {self.exponent: n}, self.middle(v)
                yield f"{self.exponent} = {n:g}", own, radius
                yield f"{self.exponent} = {n:g} and x/s small", own, (v[self.end] * (1 + 1e-8) if self.end else 1e-3 * s)
        for factor in (1e-200, 1e200):
            own = self.stretched(factor)
            yield f"lengths {factor:g}", own, self.middle(v) * factor

    def middle(self, v):
        return 1.5 * v[self.end] if self.end else 0.5 * self.scale(v)

    def beyond(self):
        """Corners next to a breakpoint, and of its place among the other lengths."""
        v, s, end = self.base, self.scale(self.base), self.end
        b = v[end]
        yield "x -> b", v, UP(b)
        for gap in (1e-15, 1e-12, 1e-8, 1e-4, 0.01, 0.5):
            yield f"x/b = 1 + {gap:g}", v, b * (1 + gap)
        if self.limit:
            yield "x/R = 1 - 1e-16", v, DOWN(s)
            for gap in (1e-8, 1e-3):
                yield f"x/R = 1 - {gap:g}", v, s * (1 - gap)
            for gap in (1e-3, 1e-8, 1e-15):
                own = v | {end: s * (1 - gap)}
                yield f"b/R = 1 - {gap:g} and x -> R", own, DOWN(s)
                yield f"b/R = 1 - {gap:g} and x between", own, own[end] + (s - own[end]) / 2
                yield f"b/R = 1 - {gap:g} and x -> b", own, UP(own[end])
        else:
            for part in (30.0, 1e3) + (() if self.oscillates or "exp" in self.pattern else (1e8, 1e16, 1e100, 1e300)):
                yield f"x/b = {part:g}", v, b * part
            if self.scaled:
                for gap in (1e-15, -1e-15):
                    yield f"b/s = 1 {'+-'[gap < 0]} 1e-15", v | {end: s * (1 + gap)}, 1.5 * s
                for part in (1e8, 1e100):
                    if "exp" not in self.pattern:
                        yield f"b/s = {part:g}", v | {end: s * part}, 1.5 * s * part
                        yield f"b/s = {part:g} and x -> b", v | {end: s * part}, s * part * (1 + 1e-8)
        for part in (1e-300, 1e-100, 1e-16, 1e-8):
            own = v | {end: s * part}
            yield f"b/s = {part:g}", own, 0.5 * s
            yield f"b/s = {part:g} and x = 1.5 b", own, 1.5 * s * part
            yield f"b/s = {part:g} and x -> b", own, UP(s * part)
            if self.limit:
                yield f"b/R = {part:g} and x/R = 1 - 1e-8", own, s * (1 - 1e-8)

    def pairs(self):
        """(corner, parameters, r, a) for p."""
        v, s = self.base, self.scale(self.base)
        few = self.stress is None
        a = self.middle(v)
        if self.end is None:
            for part in (1e-30, 1e-16, 1e-8, 0.5) if few else (1e-300, 1e-100, 1e-16, 1e-8, 0.5):
                yield f"r/a = {part:g}", v, part * a, a
            for gap in (1e-4, 1e-8):
                yield f"r/a = 1 - {gap:g}", v, a * (1 - gap), a
            yield "r/a = 1 - 1e-16", v, DOWN(a), a
            for part in (1e-300, 1e-100, 1e-8) + (() if self.limit else (30.0,) if self.oscillates else (30.0, 1e8, 1e100)):
                if few and (part > 1e5 or part < 1e-200):
                    continue
                yield f"a/s = {part:g}", v, 0.5 * part * s, part * s
                if not few:
                    yield f"a/s = {part:g} and r -> 0", v, 1e-8 * part * s, part * s
                    yield f"a/s = {part:g} and r -> a", v, part * s * (1 - 1e-8), part * s
            if self.limit:
                for gap in (1e-6, 1e-12):
                    yield f"a/R = 1 - {gap:g}", v, 0.5 * s, s * (1 - gap)
                    yield f"a/R = 1 - {gap:g} and r -> a", v, s * (1 - 2 * gap), s * (1 - gap)
        else:
            b = v[self.end]
            for name, r in (("r -> b from below", DOWN(b)), ("r -> b from above", UP(b)), ("r/b = 1 - 1e-8", b * (1 - 1e-8)),
                            ("r/b = 1 + 1e-8", b * (1 + 1e-8)), ("r = b/2", b / 2), ("r/b = 1e-30", 1e-30 * b), ("r/a = 1 - 1e-8", a * (1 - 1e-8))):
                yield name, v, r, a
            near = b * (1 + 1e-8)
            yield "a/b = 1 + 1e-8", v, b / 2, near
            yield "a/b = 1 + 1e-8 and r between", v, b + (near - b) / 2, near
            own = v | {self.end: 1e-8 * s}
            yield "b/s = 1e-8", own, 0.25 * s, 0.5 * s
        if self.exponent:
            for n in (1e-12, 1e-3, 341.0, 342.0, 1e4):
                yield f"{self.exponent} = {n:g}", v | {self.exponent: n}, 0.5 * a, a
        for factor in (1e-200, 1e200):
            yield f"lengths {factor:g}", self.stretched(factor), 0.75 * a * factor, a * factor

    def outside(self):
        """(corner, parameters, r, a) for u."""
        v, s, a = self.base, self.scale(self.base), self.middle(self.base)
        yield "r -> a", v, UP(a), a
        yield "r/a = 1 + 1e-8", v, a * (1 + 1e-8), a
        yield "r/a = 1.25", v, 1.25 * a, a
        if not self.limit:
            yield "r/a = 1e8", v, 1e8 * a, a
            yield "r/a = 1e200", v, 1e200 * a, a
        if self.end:
            near = v[self.end] * (1 + 1e-8)
            yield "a/b = 1 + 1e-8", v, 1.25 * near, near
        else:
            yield "a/s = 1e-8", v, 1.25e-8 * s, 1e-8 * s
            yield "a/s = 1e-100", v, 1.25e-100 * s, 1e-100 * s
        for factor in (1e-200, 1e200):
            yield f"lengths {factor:g}", self.stretched(factor), 1.25 * a * factor, a * factor

    def energies(self):
        v, s, a = self.base, self.scale(self.base), self.middle(self.base)
        yield "middle", v, a
        if self.end:
            for gap in (1e-8, 1e-12):
                yield f"a/b = 1 + {gap:g}", v, v[self.end] * (1 + gap)
        else:
            for part in (1e-100, 1e-16, 1e-8):
                yield f"a/s = {part:g}", v, part * s
        if self.limit:
            yield "a/R = 1 - 1e-6", v, s * (1 - 1e-6)
        for factor in (1e-100, 1e100):
            yield f"lengths {factor:g}", self.stretched(factor), a * factor

    def g(self, values, x):
        return at(self.slope, values | {"x": x})

    def pressure_by_quadrature(self, values):
        r, a = values["r"], values["a"]
        b = values[self.end] if self.end else None
        outer = mp.dps

        def rising(u):
            with mp.workdps(outer + 20):
                x = r * cosh(u)
                # The step is small beside the distance to the breakpoint and to the pole of the slope.
                room = min([x] + [abs(x - values[name]) for name in (self.end, self.limit) if name])
                if room == 0 or (b is not None and x < b):
                    return mpf(0)
            with mp.workdps(outer + 30):
                step = room * mpf(10) ** -20
                return (self.g(values, x + step) - self.g(values, x - step)) / (2 * step)
        start = acosh(b / r) if b is not None and r < b else mpf(0)
        stop = acosh(a / r)
        places = [start, (start + stop) / 2, stop]
        if self.end is None and stop > 8:
            places = [start, stop - 6, stop - 2, stop]
        return values["E"] / mp.pi * self.quadrature(rising, places, values)

    def quadrature(self, f, places, values):
        """Panel by panel on the unit interval, of an integrand that has as many digits as it needs."""
        outer, wanted = mp.dps, 16 if self.rough else 32
        total, doubt = mpf(0), mpf(0)
        for start, stop in zip(places, places[1:]):
            def inside(t):
                with mp.workdps(outer):
                    # t², which tames 1/√(x − b) at the start.
                    return 2 * t * f(start + (stop - start) * t * t) / size
            with mp.workdps(outer):
                size = mpf(1)
                size = abs(inside(mpf(1) / 3)) or mpf(1)
            with mp.workdps(wanted):
                value, error = quad(inside, [0, 1], maxdegree=8, error=True)
                total += (stop - start) * size * value
                doubt += (stop - start) * size * abs(error)
        if doubt > mpf(10) ** (5 - wanted) * abs(total):
            raise ValueError("the quadrature does not settle")
        return total

    def displacement(self, values):
        r, a = values["r"], values["a"]
        top = self.g(values, a)
        places = [mpf(0)] + ([asin(values[self.end] / r)] if self.end else []) + [asin(a / r)]
        if self.end is None:
            places.insert(1, places[-1] / 2)
        return 2 / mp.pi * self.quadrature(lambda t: top - self.g(values, r * sin(t)) if t else top, places, values)

    def energy(self, values):
        a = values["a"]
        top = self.g(values, a)
        places = [mpf(0), values[self.end] if self.end else a / 2, a]
        return values["E"] * self.quadrature(lambda x: (top - self.g(values, x) if x else top) ** 2, places, values)


def written(value):
    if abs(value) > mpf("1e400"):
        return "inf" if value > 0 else "-inf"
    if abs(value) < mpf("1e-400"):
        return "0"
    return mp.nstr(value, 25)


def row(rule, corner, quantity, values, evaluate, fallback=None):
    if not all(math.isfinite(v) and (v != 0 or name in "r") for name, v in values.items()):
        return
    try:
        patience(PATIENCE)
        value, digits = sure(evaluate, values)
        worth = condition(evaluate, values, digits)
        patience(0)
    except (Slow, ValueError, ZeroDivisionError, mp.NoConvergence, OverflowError, NotImplementedError) as why:
        patience(0)
        if fallback:
            integrals(rule, corner, quantity, values, fallback)
        else:
            left_out(rule, corner, quantity, values, why)
        return
    put(rule, corner, quantity, values, value, worth)


def left_out(rule, corner, quantity, values, why):
    print(f"left out: {rule.id} {quantity} {corner} {values}: {why!r}"[:300], file=sys.stderr)


def put(rule, corner, quantity, values, value, worth):
    arguments = " ".join(f"{k}={v!r}" for k, v in values.items() if not (k == "E" and v == 1.0))
    print(f"{rule.id},{corner},{quantity},{arguments},{written(value)},{mp.nstr(worth, 3)}", flush=True)


def integrals(rule, corner, quantity, values, evaluate):
    """The same for a quadrature, which is confirmed by itself; its condition comes from two-sided differences in 15 digits."""
    if not all(math.isfinite(v) and v != 0 for v in values.values()):
        return
    digits = 70 + int(2 * min(span_of(values), 350))
    try:
        patience(3 * PATIENCE)
        with mp.workdps(digits):
            value = evaluate(exact(values))
            rule.rough = True
            near_value = evaluate(exact(values))
            worth = mpf(0)
            step = mpf(10) ** -5
            for name, own in values.items():
                if name == "E":
                    continue
                with mp.workdps(digits + 20):
                    room = min([abs(mpf(own) / mpf(v) - 1) for k, v in values.items() if k != name and k in "abcwRr" and v != own] + [mpf(1)])
                    moved = step * room
                    if name not in "abcwRr":
                        moved = step
                    near = evaluate(exact(values) | {name: mpf(own) * (1 + moved)})
                    worth += abs((near - near_value) / (moved * value))
        patience(0)
    except (Slow, ValueError, ZeroDivisionError, mp.NoConvergence, OverflowError, NotImplementedError) as why:
        patience(0)
        rule.rough = False
        left_out(rule, corner, quantity, values, why)
        return
    rule.rough = False
    put(rule, corner, quantity, values, value, worth)


W = "sqrt((x-b)*(x+b))"
# Named shapes: parameters, the radius of the flat or capped part, g and F/E over x; beyond that part unless it is 0.
SHAPES = [
    ("cone", {"theta": 0.25}, None, "pi/2*x*tan(theta)", "pi/2*x^2*tan(theta)"),
    ("paraboloid", {"R": 1.5}, None, "x^2/R", "4/3*x^3/R"),
    ("sphere", {"R": 1.5}, None, "x*atanh(x/R)", "(x^2+R^2)*atanh(x/R)-R*x"),
    ("ellipsoid", {"b": 0.75, "c": 1.5}, None, "b/c*x*atanh(x/c)", "b/c*((x^2+c^2)*atanh(x/c)-c*x)"),
    ("hyperboloid", {"h": 0.5, "b": 0.75}, None, "h/b*x*atan(x/b)", "h/b*((x^2-b^2)*atan(x/b)+x*b)"),
    ("power", {"C": 0.5, "n": 2.75}, None, "C*sqrt(pi)*gamma(n/2+1)/gamma(n/2+1/2)*x^n",
     "2*C*sqrt(pi)*gamma(n/2+1)/gamma(n/2+1/2)*n/(n+1)*x^(n+1)"),
    ("truncated-cone", {"b": 0.75, "theta": 0.25}, "b", "tan(theta)*x*acos(b/x)", f"tan(theta)*(x^2*acos(b/x)+b*{W})"),
    ("truncated-paraboloid", {"b": 0.75, "R": 1.5}, "b", f"x*{W}/R", f"2/3*(2*x^2+b^2)*{W}/R"),
    ("cone-with-spherical-cap", {"R": 1.5, "theta": 0.25}, "R*sin(theta)",
     "x*ln((R+x)/(R*cos(theta)+sqrt(x^2-R^2*sin(theta)^2)))+tan(theta)*x*acos(R*sin(theta)/x)",
     "R*cos(theta)*sqrt(x^2-R^2*sin(theta)^2)-R*x+(R^2+x^2)*ln((R+x)/(R*cos(theta)+sqrt(x^2-R^2*sin(theta)^2)))"
     "+tan(theta)*(x^2*acos(R*sin(theta)/x)+R*sin(theta)*sqrt(x^2-R^2*sin(theta)^2))"),
    ("cone-with-parabolic-cap", {"b": 0.75, "theta": 0.25}, "b", f"tan(theta)*(x/b*(x-{W})+x*acos(b/x))",
     f"tan(theta)*(2/(3*b)*(2*x^3-(2*x^2+b^2)*{W})+x^2*acos(b/x)+b*{W})"),
    ("paraboloid-with-parabolic-cap", {"P": 3.0, "b": 0.75, "R": 1.5}, "b", f"x^2/P+(1/R-1/P)*x*{W}",
     f"4/3*x^3/P+(1/R-1/P)*2/3*(2*x^2+b^2)*{W}"),
    ("flat-with-rounded-edge", {"b": 0.75, "R": 1.5}, "b", f"x*({W}-b*acos(b/x))/R",
     f"(2/3*(2*x^2+b^2)*{W}-b*(x^2*acos(b/x)+b*{W}))/R"),
    ("wavy-paraboloid", {"R": 1.5, "h": 0.001, "k": 3.0}, None, "x^2/R+h*pi/2*k*x*struveh(0,k*x)",
     "4/3*x^3/R+h*pi*x*(k*x*struveh(0,k*x)-struveh(1,k*x))"),
]
FLAT = ("truncated-cone", "truncated-paraboloid", "flat-with-rounded-edge")


def radius_of(slope, start, values):
    """a(d), sought in ln(a − b), which keeps the distance to the flat part."""
    b = start(values) if start else mpf(0)
    # g rises at least like the square root of the distance to the flat part, and like any power from 0.
    low, high = 2.2 * mp.log(min(values["d"], 1)) - 40 if start else mpf(-4000), mpf(60)
    limit = next((values[name] for name in "cR" if name in values and "atanh" in slope.text), None)
    if limit is not None:
        # The distance to the equator instead, in the same logarithm.
        place = lambda t: limit / (1 + mp.exp(-t))
    else:
        place = lambda t: b + mp.exp(t)

    def lack(t):
        found = at(slope, values | {"x": place(t)})
        if found <= 0:
            raise ValueError("no digits")
        return mp.log(found / values["d"])
    for _ in range(22):
        middle = (low + high) / 2
        low, high = (low, middle) if lack(middle) > 0 else (middle, high)
    before, here = low, high
    left, own = lack(before), lack(here)
    for _ in range(40):
        step = own * (here - before) / (own - left) if own != left else 0
        before, left, here = here, own, here - step
        if abs(step) < mpf(10) ** (-mp.dps // 2):
            return place(here)
        own = lack(here)
    raise ValueError("no root")


def shapes():
    for name, base, start, slope, force in SHAPES:
        slope, force = Formula(slope), Formula(force)
        start = Formula(start) if start else None
        rule = type("Named", (), {"id": "shape " + name, "rough": False})()
        length = base.get("R") or base.get("c") or base.get("b") or 1.0
        own = [(f"d/s = {part:g}", base, part * length) for part in (1e-300, 1e-200, 1e-100, 1e-30, 1e-16, 1e-12, 1e-8, 1e-4, 0.01, 0.5)]
        for small in (1e-100, 1e-8, 1e-3):
            if start and "b" in base:
                own += [(f"b/s = {small:g} and d/s = {part:g}", base | {"b": small * base["b"]}, part * length) for part in (1e-16, 1e-4, 0.5)]
            if "theta" in base:
                own += [(f"theta = {small:g} and d/s = {part:g}", base | {"theta": small}, part * length) for part in (1e-16, 1e-4)]
        if name == "power":
            own += [(f"n = {n:g}", base | {"n": n}, 0.5) for n in (1e-3, 0.5, 341.0, 342.0, 1e4)]
        for corner, values, d in own:
            values = values | {"d": d}
            with mp.workdps(80):
                cap = start(exact(values)) if start else 0
                inside = start and name not in FLAT and at(slope, exact(values) | {"x": cap}) >= d
            if inside:
                continue
            root = lambda v: radius_of(slope, start, v)
            row(rule, corner, "a(d)", values, root)
            row(rule, corner, "F(d)", values, lambda v: at(force, v | {"x": root(v)}))
        print(rule.id, file=sys.stderr)


def rims():
    """Cylinders with a flat and a hollow end: a = c, F = 2E ∫₀ᶜ (d − g) dx; the hollow one is in full contact from d = 2h on."""
    flat, hollow = Formula("2*c*d"), Formula("2*c*(d+2*h/3)")
    own = [("flat", flat, f"d/s = {part:g}", {"c": 0.75, "d": part}) for part in (1e-300, 1e-100, 1e-16, 1e-4, 0.5)]
    own += [("flat", flat, f"lengths {size:g}", {"c": 0.75 * size, "d": 0.1 * size}) for size in (1e-150, 1e150)]
    for h in (1e-300, 1e-16, 0.01):
        own += [("concave-paraboloid", hollow, f"h/s = {h:g} and d/h = {2 * part:g}", {"h": h, "c": 0.75, "d": 2 * h * part}) for part in (1.0625, 64.0)]
        own.append(("concave-paraboloid", hollow, f"h/s = {h:g} and d/s = 0.5", {"h": h, "c": 0.75, "d": 0.5}))
    own += [("concave-paraboloid", hollow, f"lengths {size:g}", {"h": 0.01 * size, "c": 0.75 * size, "d": 0.1 * size}) for size in (1e-150, 1e150)]
    for name, force, corner, values in own:
        rule = type("Named", (), {"id": "shape " + name, "rough": False})()
        row(rule, corner, "a(d)", values, lambda v: v["c"])
        row(rule, corner, "F(d)", values, lambda v: at(force, v))


def main():
    print("rule,corner,quantity,arguments,value,condition")
    if not ONLY or "shapes" in ONLY:
        shapes()
    if not ONLY or "rims" in ONLY:
        rims()
    for entry in json.load(sys.stdin)["rules"]:
        rule = Rule(entry)
        if ONLY and rule.id not in ONLY:
            continue
        force = lambda v: at(rule.force, v)
        for corner, v, x in rule.radii():
            if rule.limit and x >= v[rule.limit] or rule.end and x <= v[rule.end]:
                continue
            row(rule, corner, "g", v | {"x": x}, lambda v: at(rule.slope, v))
            row(rule, corner, "F", v | {"a": x, "E": 1.0}, force)
            row(rule, corner, "G", v | {"a": x, "E": 1.0}, lambda v: v["a"] * rule.g(v, v["a"]) - force(v) / 2)
        for modulus in (1e-300, 1e300):
            row(rule, f"E* = {modulus:g}", "F", rule.base | {"a": rule.middle(rule.base), "E": modulus}, force)
        for corner, v, r, a in rule.pairs():
            if rule.slow and not rule.stress and corner not in FEW:
                continue
            if rule.limit and a >= v[rule.limit] or r >= a or r in (v.get(rule.end), 0.0):
                continue
            if rule.stress:
                row(rule, corner, "p", v | {"r": r, "a": a, "E": 1.0}, lambda v: at(rule.stress, v), rule.pressure_by_quadrature)
            else:
                integrals(rule, corner, "p", v | {"r": r, "a": a, "E": 1.0}, rule.pressure_by_quadrature)
        for corner, v, r, a in rule.outside():
            if rule.slow and corner not in FEW:
                continue
            integrals(rule, corner, "u", v | {"r": r, "a": a, "E": 1.0}, rule.displacement)
        for corner, v, a in rule.energies():
            if rule.slow and corner not in FEW:
                continue
            integrals(rule, corner, "U", v | {"a": a, "E": 1.0}, rule.energy)
        print(rule.id, file=sys.stderr)


if __name__ == "__main__":
    main()
