"""g and F of profiles with one narrow feature, to 25 digits: quadrature that is told where the feature is.

Writes features.csv: profile, quantity, place, value.  Run: python3 features.py
"""

import csv
import pathlib
import random

from mpmath import asin, cosh, exp, log, mp, mpf, pi, quad, sin, sqrt, tanh

mp.dps = 40

# Text and derivative.
BACKGROUNDS = [
    ("tanh(r)", lambda r: 1 / cosh(r) ** 2),
    ("ln(cosh(r))", tanh),
    ("exp(sin(r))-1", lambda r: exp(sin(r)) * mp.cos(r)),
    ("r^2/2", lambda r: r),
    ("sqrt(1+r^2)*tanh(r)", lambda r: r * tanh(r) / sqrt(1 + r * r) + sqrt(1 + r * r) / cosh(r) ** 2),
    ("r*exp(-r)", lambda r: (1 - r) * exp(-r)),
    ("tanh(r^2)", lambda r: 2 * r / cosh(r * r) ** 2),
    ("ln(1+r+r^3)", lambda r: (1 + 3 * r * r) / (1 + r + r**3)),
    ("atan(r+r^2)", lambda r: (1 + 2 * r) / (1 + (r + r * r) ** 2)),
    ("cosh(sin(r))-1", lambda r: mp.sinh(sin(r)) * mp.cos(r)),
]

# Text with c (place) and k (1/width), and derivative.
FEATURES = [
    ("0.01*exp(-(K*(r-C))^2)", lambda r, c, k: -2 * k * k * (r - c) * exp(-((k * (r - c)) ** 2)) / 100),
    ("0.01*erf(K*(r-C))", lambda r, c, k: k * 2 / sqrt(pi) * exp(-((k * (r - c)) ** 2)) / 100),
    ("0.01*tanh(K*(r-C))", lambda r, c, k: k / cosh(k * (r - c)) ** 2 / 100),
    ("0.01/(1+(K*(r-C))^2)", lambda r, c, k: -2 * k * k * (r - c) / (1 + (k * (r - c)) ** 2) ** 2 / 100),
    ("0.01*atan(K*(r-C))", lambda r, c, k: k / (1 + (k * (r - c)) ** 2) / 100),
]

# Quotients and products of what overflows or underflows everywhere but at the feature.
EXTREME = [
    ("0.01/cosh(K*(r-C))", lambda r, c, k: -k * mp.sinh(k * (r - c)) / cosh(k * (r - c)) ** 2 / 100),
    ("0.01/(1+exp(-K*(r-C)))", lambda r, c, k: k / (4 * cosh(k * (r - c) / 2) ** 2) / 100),
    (
        "0.01*sin(K*(r-C))*exp(-(K*(r-C)/4)^2)",
        lambda r, c, k: k * exp(-((k * (r - c) / 4) ** 2)) * (mp.cos(k * (r - c)) - k * (r - c) / 8 * sin(k * (r - c))) / 100,
    ),
    ("0.01*exp(-(K*(r-C))^2)/cosh(K*(r-C))", lambda r, c, k: quotient_slope(k * (r - c)) * k / 100),
    ("0.01*K*(r-C)/cosh(K*(r-C))", lambda r, c, k: k * (1 - k * (r - c) * tanh(k * (r - c))) / cosh(k * (r - c)) / 100),
]


def quotient_slope(u):
    """The derivative of exp(-u^2)/cosh(u)."""
    return -exp(-u * u) / cosh(u) * (2 * u + tanh(u))


def integral(slope, c, k, x, weight):
    """The integral over the angle with cuts around the feature, ever wider."""
    cuts = {mpf(0), pi / 2}
    for power in range(-2, 45):
        for side in (-1, 1):
            r = c + side * mpf(2) ** power / k
            if 0 < r < x:
                cuts.add(asin(r / x))
    if c < x:
        cuts.add(asin(c / x))
    # What oscillates or decays like e^-u does so over some forty widths.
    for step in range(-200, 201):
        r = c + step / k / 2
        if 0 < r < x:
            cuts.add(asin(r / x))
    # Next to the rim the angle turns a distance into its root.
    cuts.update(pi / 2 - mpf(2) ** -power for power in range(1, 24))
    cuts.update([pi / 8, pi / 4])
    return quad(lambda t: slope(x * sin(t)) * weight(x, t), sorted(cuts))


if __name__ == "__main__":
    random.seed(20_917)
    with (pathlib.Path(__file__).parent / "features.csv").open("w", newline="") as out:
        rows = csv.writer(out)
        rows.writerow(["profile", "quantity", "place", "value"])
        for case in range(130):
            text, background = BACKGROUNDS[case % len(BACKGROUNDS)]
            if case < 80:
                feature, bump = FEATURES[random.randrange(len(FEATURES))]
            else:
                feature, bump = EXTREME[random.randrange(len(EXTREME))]
            digits = random.randrange(1, 11)
            scale = 10**digits
            x = random.choice([0.5, 0.9, 1.1, 1.7])
            # Half of the features lie next to the rim.
            place = x * random.uniform(0.05, 0.95) if case % 2 else x - random.choice([-1, 1]) * random.uniform(0.5, 4) / scale
            place = f"{place:.13f}"
            c, k = mpf(place), mpf(scale)
            profile = text + "+" + feature.replace("K", str(scale)).replace("C", place)
            mean = lambda r: background(r) + bump(r, c, k)
            own = mpf(x)
            if case % 3:
                rows.writerow([profile, "g", repr(x), mp.nstr(own * integral(mean, c, k, own, lambda x, t: 1), 25)])
            else:
                value = 2 * integral(mean, c, k, own, lambda x, t: (x * sin(t)) ** 2)
                rows.writerow([profile, "F", repr(x), mp.nstr(value, 25)])
