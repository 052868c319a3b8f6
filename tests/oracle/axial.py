"""Reference values of the stress on the axis, from its definition by g', with 50 digits; writes axial.csv."""

from pathlib import Path

from mpmath import acos, asinh, atanh, besselj, diff, gamma, inf, mp, mpf, nstr, pi, quad, sqrt

mp.dps = 50


def stress(slope, breaks, a, excess, z):
    """-(1/pi)(int_0^a g' W dx + (d - g(a)) W(a)), W = x(x^2+3z^2)/(x^2+z^2)^2."""
    weight = lambda x: x * (x * x + 3 * z * z) / (x * x + z * z) ** 2
    places = {mpf(0), a}
    places.update(b for b in breaks if b < a)
    at = z / 16
    while at < a:
        places.add(at)
        at *= 4
    places = sorted(places)
    total = sum(quad(lambda x: slope(x) * weight(x), [low, high]) for low, high in zip(places, places[1:]))
    return -(total + excess * weight(a)) / pi


def kappa(n):
    return sqrt(pi) * gamma(mpf(n) / 2 + 1) / gamma((mpf(n) + 1) / 2)


b = mpf(1) / 2
CASES = [
    # text of f, g', breakpoints of g, g(a) as a function
    ("r^2/4", lambda x: x, [], lambda x: x * x / 2),
    ("r/5", lambda x: pi / 10, [], lambda x: pi / 10 * x),
    ("2-sqrt(4-r^2)", lambda x: atanh(x / 2) + 2 * x / (4 - x * x), [], lambda x: x * atanh(x / 2)),
    ("r^(1/2)", lambda x: kappa(0.5) / 2 / sqrt(x), [], lambda x: kappa(0.5) * sqrt(x)),
    ("r^7", lambda x: kappa(7) * 7 * x**6, [], lambda x: kappa(7) * x**7),
    ("piecewise(0, r<1/2, (r-1/2)/3)", lambda x: (acos(b / x) + b / sqrt(x * x - b * b)) / 3 if x > b else mpf(0), [b], lambda x: x * acos(b / x) / 3),
    ("1-besselj(0,r)", lambda x: mp.sin(x), [], lambda x: 1 - mp.cos(x)),
]

rows = ["profile;a;d;z;stress"]
for text, slope, breaks, g in CASES:
    for a in (mpf(3) / 4, mpf(1.75)):
        # A smooth edge, and a rim that is pressed deeper by 1/8 of g.
        for excess in (mpf(0), mpf(g(a)) / 8):
            depth = "" if excess == 0 else repr(float(g(a) + excess))
            more = mpf(0) if excess == 0 else mpf(float(depth)) - g(a)
            for z in ("1e-9", "1e-3", "0.1", "0.5", "1.25", "8", "1e5"):
                value = stress(slope, breaks, a, more, mpf(float(z)))
                rows.append(f"{text};{float(a)!r};{depth};{z};{nstr(value, 40)}")
Path(__file__).with_name("axial.csv").write_text("\n".join(rows) + "\n")
