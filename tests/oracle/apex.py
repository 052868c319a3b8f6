"""Pressures at the axis and at joints where they are finite although parts of the profile are conical.

Writes apex.csv: profile; a; r; p for E* = 1, with 25 digits from 60-digit quadrature:
p(0) = (1/pi) [int_0^a (r f')' acos(r/a)/r dr + jump of f' at b times acos(b/a)], and at a joint b
p(b) = (1/pi) int_b^a g'(x)/sqrt(x^2-b^2) dx with g'(x) = int_0^(pi/2) [(r f')'](x sin t) dt, split where f' has its joint.
Run: python3 tests/oracle/apex.py
"""
import os

import mpmath as mp
import sympy as sp

mp.mp.dps = 60
r = sp.Symbol("r", positive=True)
SMOOTH = [
    ("r^2*ln(1+r)", r**2 * sp.log(1 + r)),
    ("r-ln(1+r)", r - sp.log(1 + r)),
    ("exp(r)-1-r", sp.exp(r) - 1 - r),
    ("r-sin(r)", r - sp.sin(r)),
    ("r^2/(1+r)", r**2 / (1 + r)),
    ("r-atan(r)", r - sp.atan(r)),
    ("r-tanh(r)", r - sp.tanh(r)),
    ("r-asinh(r)", r - sp.asinh(r)),
    ("sinh(r)-r", sp.sinh(r) - r),
    ("(1+r)*ln(1+r)-r", (1 + r) * sp.log(1 + r) - r),
    ("3/10*(r/2-ln(1+r/2))", sp.Rational(3, 10) * (r / 2 - sp.log(1 + r / 2))),
    ("r^2*exp(-r)", r**2 * sp.exp(-r)),
    ("r^2/(3+2*r)", r**2 / (3 + 2 * r)),
    ("r^(3/2)+r-sin(r)", r ** sp.Rational(3, 2) + r - sp.sin(r)),
    ("r^(11/10)*ln(1+r)", r ** sp.Rational(11, 10) * sp.log(1 + r)),
    ("sqrt(1+2*r)-1-r", sp.sqrt(1 + 2 * r) - 1 - r),
]
JOINTS = [
    ("piecewise(r^2,r<1,2*r-1)", r**2, 2 * r - 1, 1),
    ("piecewise(r^2/2,r<1,r-1/2)", r**2 / 2, r - sp.Rational(1, 2), 1),
    ("piecewise(0,r<1,(r-1)^2*(2+r))", sp.Integer(0), (r - 1) ** 2 * (2 + r), 1),
    ("piecewise(1-cos(r),r<2,1-cos(2)+(r-2)*sin(2))", 1 - sp.cos(r), 1 - sp.cos(2) + (r - 2) * sp.sin(2), 2),
]
# Sums whose slopes at the axis cancel, with a kink at b.
KINKS = [
    ("abs(r-0.5)+r", sp.Rational(1, 2), 2 * r - sp.Rational(1, 2), sp.Rational(1, 2)),
    ("r/2+abs(r-0.3)/2", sp.Rational(3, 20), r - sp.Rational(3, 20), sp.Rational(3, 10)),
    ("abs(exp(r)-1.5)+sin(r)", sp.Rational(3, 2) - sp.exp(r) + sp.sin(r), sp.exp(r) - sp.Rational(3, 2) + sp.sin(r), sp.log(sp.Rational(3, 2))),
]


def bend(f):
    return sp.lambdify(r, sp.diff(r * sp.diff(f, r), r), "mpmath")


def at_axis(f, a):
    h = bend(f)
    # Far below the working precision what the slope takes from itself leaves nothing; there the weight is a constant over r.
    with mp.workdps(140):
        return mp.quad(lambda t: h(a * mp.sin(t)) * (mp.pi / 2 - t) / mp.tan(t), [0, mp.mpf(1) / 10, mp.pi / 4, mp.pi / 2]) / mp.pi


def at_joint(inner, outer, b, a):
    below, beyond = bend(inner), bend(outer)

    def slope(x):
        at = mp.asin(b / x)
        part = mp.quad(lambda t: below(x * mp.sin(t)), [0, at]) if inner != 0 else 0
        return part + mp.quad(lambda t: beyond(x * mp.sin(t)), [at, mp.pi / 2])

    with mp.workdps(30):
        return mp.quad(lambda u: slope(b * mp.cosh(u)), [0, mp.acosh(mp.mpf(a) / b)]) / mp.pi


def at_axis_with_kink(inner, outer, b, a):
    below, beyond = bend(inner), bend(outer)
    jump = sp.diff(outer - inner, r).subs(r, b)
    with mp.workdps(140):
        b, jump = mp.mpf(sp.N(b, 140)), mp.mpf(sp.N(jump, 140))
        at = mp.asin(b / a)
        part = lambda h, places: mp.quad(lambda t: h(a * mp.sin(t)) * (mp.pi / 2 - t) / mp.tan(t), places)
        inside = part(below, [0, at / 8, at]) if sp.diff(inner, r) != 0 else 0
        return (inside + part(beyond, [at, mp.pi / 2]) + jump * mp.acos(b / a)) / mp.pi


rows = ["profile;a;r;p"]
for text, f in SMOOTH:
    for a in ("0.5", "1", "3"):
        rows.append(f"{text};{a};0;{mp.nstr(at_axis(f, mp.mpf(a)), 25)}")
for text, inner, outer, b in KINKS:
    for a in ("1", "3"):
        rows.append(f"{text};{a};0;{mp.nstr(at_axis_with_kink(inner, outer, b, mp.mpf(a)), 25)}")
for text, inner, outer, b in JOINTS:
    for factor in ("1.25", "2"):
        a = mp.mpf(factor) * b
        rows.append(f"{text};{mp.nstr(a, 10)};{b};{mp.nstr(at_joint(inner, outer, b, a), 22)}")
with open(os.path.join(os.path.dirname(__file__), "apex.csv"), "w") as out:
    out.write("\n".join(rows) + "\n")
