"""Finite values of profiles that are 0/0, inf/inf or of infinite curvature somewhere in double precision.

Writes finite.csv: profile; parameters; quantity; contact radius (for p); place; value with 30 digits, for E* = 1:
g(x) = x int_0^(pi/2) f'(x sin t) dt, F(a) = 2 a^2 int_0^(pi/2) f'(a sin t) sin^2 t dt, and
p(s) = (1/pi) int_0^a (r f')' K(r, s) dr with K by Carlson's R_F, by double exponential rules with many digits.
Run: python3 tests/oracle/finite.py
"""
import os

import mpmath as mp
import sympy as sp

r = sp.Symbol("r", positive=True)
Q = sp.Rational
PLACES = [Q(1, 2), Q(6, 5)]
TINY = ["1e-8", "1e-150"]
# Text, parameters, f.
REMOVABLE = [
    ("(1-exp(-r))/r", "", (1 - sp.exp(-r)) / r),
    ("(1-cos(2*r))/r", "", (1 - sp.cos(2 * r)) / r),
    ("(1-cos(k*r))/r", "k=1.5", (1 - sp.cos(Q(3, 2) * r)) / r),
    ("sin(r)^2/r", "", sp.sin(r) ** 2 / r),
    ("r/(exp(r)-1)", "", r / (sp.exp(r) - 1)),
    ("r/tanh(r/2)", "", r / sp.tanh(r / 2)),
    ("r/tanh(r/w)", "w=0.75", r / sp.tanh(r / Q(3, 4))),
    ("sin(2*r)/(2*r)", "", sp.sin(2 * r) / (2 * r)),
    ("sin(k*r)/(k*r)", "k=1.25", sp.sin(Q(5, 4) * r) / (Q(5, 4) * r)),
    ("ln(1+r)/r", "", sp.log(1 + r) / r),
    ("atan(2*r)/r+r^2", "", sp.atan(2 * r) / r + r**2),
    ("(exp(r^2)-1)/r", "", (sp.exp(r**2) - 1) / r),
    ("(cosh(2/3.0*r)-1+1.243*(exp(r)-(1+r)))*((1-exp(-r))/r)", "",
     (sp.cosh(2 * r / 3) - 1 + Q(1243, 1000) * (sp.exp(r) - 1 - r)) * (1 - sp.exp(-r)) / r),
    ("h*((1-cos(r))/r)/(1+(h*((1-cos(r))/r))^2)+(I0(r/3)-1)/h", "h=2.5",
     Q(5, 2) * (1 - sp.cos(r)) / r / (1 + (Q(5, 2) * (1 - sp.cos(r)) / r) ** 2) + (sp.besseli(0, r / 3) - 1) / Q(5, 2)),
    ("(1.8*r^(13/10)+(1-cos(1.2*r))/r)*(exp(r/(1/2))-1)", "",
     (Q(9, 5) * r ** Q(13, 10) + (1 - sp.cos(Q(6, 5) * r)) / r) * (sp.exp(2 * r) - 1)),
    ("(1-e^(-(1540e-3*r)))/r/1.18/(2+((1)*(r*r))^(2))+r^1.5/(7*3^(-1))", "",
     (1 - sp.exp(-Q(154, 100) * r)) / r / Q(118, 100) / (2 + r**4) + r ** Q(3, 2) * Q(3, 7)),
    ("(sqrt(1+r^2)-1)^0.75", "", (sp.sqrt(1 + r**2) - 1) ** Q(3, 4)),
    ("(sqrt(1.21+r^2)-1.1)^0.7", "", (sp.sqrt(Q(121, 100) + r**2) - Q(11, 10)) ** Q(7, 10)),
    ("(1-cos(r))^0.6", "", (1 - sp.cos(r)) ** Q(3, 5)),
    # What is 0/0 stands within a power or a root, and constants cancel there.
    ("1/(3-sin(r)/r)", "", 1 / (3 - sp.sin(r) / r)),
    ("r^2+1/(2+(1-sin(r)/r)^2)", "", r**2 + 1 / (2 + (1 - sp.sin(r) / r) ** 2)),
    ("sqrt(1+((1-exp(-r))/r-1)^2)+h*r", "h=0.5", sp.sqrt(1 + ((1 - sp.exp(-r)) / r - 1) ** 2) + r / 2),
    # Beside what is 0/0 stands what has no power series.
    ("(1-cos(r))/r+r^1.2", "", (1 - sp.cos(r)) / r + r ** Q(6, 5)),
    ("r^2.5/(1+r^1.5)+(1-exp(-r/2))/r", "", r ** Q(5, 2) / (1 + r ** Q(3, 2)) + (1 - sp.exp(-r / 2)) / r),
    ("1.8*(cosh(r)-1)/(2.45+(r^2*ln(r))^2)-(1-cos(r))/r", "",
     Q(9, 5) * (sp.cosh(r) - 1) / (Q(245, 100) + (r**2 * sp.log(r)) ** 2) - (1 - sp.cos(r)) / r),
    # An even expression that continues to a function that is not even.
    ("sqrt(1-cos(r))", "", sp.sqrt(1 - sp.cos(r))),
    ("r*sqrt(ln(1+r^2))", "", r * sp.sqrt(sp.log(1 + r**2))),
    ("sqrt(1-exp(-(r/w)^2))+r^2", "w=1.5", sp.sqrt(1 - sp.exp(-(r * Q(2, 3)) ** 2)) + r**2),
    ("(sqrt(1+r^2)-1)^1.5", "", (sp.sqrt(1 + r**2) - 1) ** Q(3, 2)),
]
# Text, f, where it is narrow, places.
OVERFLOWING = [
    ("1/(1+exp(-1e4*(r-1)))", 1 / (1 + sp.exp(-10000 * (r - 1))), 1, Q(1, 10000), [Q(6, 5), 3]),
    ("0.01/cosh(1e3*(r-1))", Q(1, 100) / sp.cosh(1000 * (r - 1)), 1, Q(1, 1000), [Q(1, 2), Q(6, 5)]),
    ("r^2/(1+exp(-2e3*(r-1)))", r**2 / (1 + sp.exp(-2000 * (r - 1))), 1, Q(1, 2000), [Q(1, 2), Q(6, 5)]),
    ("r^2/2+0.01/cosh(800*(r-2))^2", r**2 / 2 + Q(1, 100) / sp.cosh(800 * (r - 2)) ** 2, 2, Q(1, 800), [Q(1, 2), Q(5, 2)]),
]
# Text, f below b, f beyond b, b.
CURVED = [
    ("abs(r-1)^1.5", (1 - r) ** Q(3, 2), (r - 1) ** Q(3, 2)),
    ("max(0,r-1)^1.5", sp.Integer(0), (r - 1) ** Q(3, 2)),
    ("max(0,1-r)^1.4+r^2", (1 - r) ** Q(7, 5) + r**2, r**2),
    ("r^2*abs(r-1)^1.3", r**2 * (1 - r) ** Q(13, 10), r**2 * (r - 1) ** Q(13, 10)),
    ("r^2+abs(r-1)^1.2", r**2 + (1 - r) ** Q(6, 5), r**2 + (r - 1) ** Q(6, 5)),
]


def number(expr, extra=0):
    own = sp.lambdify(r, expr, "mpmath")

    def with_more_digits(x):
        # Double exponential rules come so close to the axis that all digits cancel there.
        with mp.extradps(extra):
            return own(x)

    return with_more_digits if extra else own


def cut(x, at, width):
    """Angles about a narrow place."""
    if at is None or at > x:
        return [mp.pi / 2 * i / 16 for i in range(17)] if at is not None else [0, mp.pi / 2]
    places = [at * (1 + s * k * width / at) for k in (0, 1, 4, 16, 60) for s in (-1, 1)]
    return sorted({mp.asin(mp.mpf(p) / x) for p in places if 0 < p < x} | {mp.mpf(0), mp.pi / 2})


def quad(f, places, smooth=False):
    # mpmath stops at an absolute error.
    low, high = places[0], places[-1]
    size = max(abs(f(low + (high - low) * mp.mpf(i) / 16)) for i in range(1, 17)) or mp.mpf(1)
    return size * mp.quad(lambda t: f(t) / size, places, method="gauss-legendre" if smooth else "tanh-sinh")


def g(slope, x, at=None, width=0, smooth=False):
    return x * quad(lambda t: slope(x * mp.sin(t)), cut(x, at, width), smooth)


def force(slope, a, at=None, width=0, smooth=False):
    return 2 * a**2 * quad(lambda t: slope(a * mp.sin(t)) * mp.sin(t) ** 2, cut(a, at, width), smooth)


def kernel(q, s, a):
    big, small = max(q, s), min(q, s)
    gap = big**2 - small**2
    return mp.sqrt(a**2 - big**2) * mp.elliprf(big**2 * gap, a**2 * gap, big**2 * (a**2 - small**2))


def part(bend, low, high, s, a, smooth):
    """One piece; both of its ends, and s, may be singular, but for a smooth lower end."""
    own = lambda q: bend(q) * kernel(q, s, a)
    first = (low + min(s, high)) / 2 if low < s else low
    places = sorted({mp.mpf(first), mp.mpf(high)} | ({mp.mpf(s)} if low < s < high else set()))
    return mp.quad(own, places) + (quad(own, [low, first], smooth) if first > low else 0)


def beside(bend, sign, length, s, a):
    """The piece that begins or ends at 1, over the distance to it: there (r f')' may be infinite."""

    def own(t):
        if t == 0:
            return mp.mpf(0)
        # Powers above -9/10 become smooth.
        delta = t**10
        q = 1 + sign * delta
        big, small = max(q, s), min(q, s)
        gap = (delta if s == 1 else big - small) * (big + small)
        return 10 * t**9 * bend(delta) * mp.sqrt(a**2 - big**2) * mp.elliprf(big**2 * gap, a**2 * gap, big**2 * (a**2 - small**2))

    at = sign * (s - 1)
    root = lambda value: mp.root(value, 10)
    return mp.quad(own, [0, root(at), root(length)] if 0 < at < length else [0, root(length)])


def pressure(pieces, s, a, smooth=False):
    total = mp.mpf(0)
    for bend, low, high in pieces:
        if bend is not None and low < a:
            total += part(bend, low, min(high, a), s, a, smooth)
    return total / mp.pi


def lines():
    for text, parameters, f in REMOVABLE:
        smooth = all(power.exp.is_integer for power in f.atoms(sp.Pow) if r in power.free_symbols) and not f.has(sp.log(r))
        slope = number(sp.diff(f, r), 0 if smooth else 250)
        for at in PLACES:
            with mp.workdps(50):
                x = mp.mpf(at.p) / at.q
                yield text, parameters, "g", "", float(at), g(slope, x, smooth=smooth)
                yield text, parameters, "F", "", float(at), force(slope, x, smooth=smooth)
        for at in TINY:
            tiny = number(sp.diff(f, r), (100 if at == "1e-8" else 700) + (0 if smooth else 250))
            with mp.workdps(40):
                yield text, parameters, "g", "", at, g(tiny, mp.mpf(float(at)), smooth=smooth)
        bend = number(sp.diff(r * sp.diff(f, r), r), 0 if smooth else 250)
        with mp.workdps(40):
            yield text, parameters, "p", 1.25, 0.5, pressure([(bend, mp.mpf(0), mp.inf)], mp.mpf(1) / 2, mp.mpf(5) / 4, smooth)
    for text, f, at, width, places in OVERFLOWING:
        slope = number(sp.diff(f, r))
        for x in places:
            with mp.workdps(60):
                own = mp.mpf(float(x))
                args = (own, mp.mpf(at), mp.mpf(width.p) / width.q)
                yield text, "", "g", "", float(x), g(slope, *args)
                yield text, "", "F", "", float(x), force(slope, *args)
    for text, below, beyond in CURVED:
        bends = []
        for sign, f in ((-1, below), (1, beyond)):
            bend = sp.diff(r * sp.diff(f, r), r)
            bends.append(number(sp.powsimp(bend.subs(r, 1 + sign * r))) if f != 0 else lambda delta: mp.mpf(0))
        with mp.workdps(45):
            for s in [0.25, 0.5, 1.0, 1.5]:
                yield text, "", "p", 2.0, s, (beside(bends[0], -1, 1, mp.mpf(s), mp.mpf(2)) + beside(bends[1], 1, 1, mp.mpf(s), mp.mpf(2))) / mp.pi


def main():
    path = os.path.join(os.path.dirname(os.path.abspath(__file__)), "finite.csv")
    with open(path, "w", encoding="utf-8") as out:
        out.write("# profile;parameters;quantity;contact radius (for p);place;value with 30 digits: python3 tests/oracle/finite.py\n")
        for text, parameters, quantity, radius, at, value in lines():
            out.write(f"{text};{parameters};{quantity};{radius};{at};{mp.nstr(value, 30, strip_zeros=False)}\n")
            out.flush()


main()
