"""p·π/E* of profiles with one narrow feature, to 17 digits: one integral of (r f')' with the kernel by Carlson's R_F of mpmath, which is
told where the feature is.

Writes feature_pressures.csv: profile, radius, contact, value.  Run: python3 feature_pressures.py
"""

import csv
import pathlib
import random

from mpmath import cosh, diff, elliprf, exp, mp, mpf, pi, quad, sqrt

from features import BACKGROUNDS, FEATURES

mp.dps = 30
random.seed(61_803)


def kernel(r, s, a):
    """∫_M^a dx/√((x²−r²)(x²−s²)), M the larger of r and s."""
    big, small = max(r, s), min(r, s)
    spread = (big - small) * (big + small)
    edge = (a - big) * (a + big)
    return sqrt(edge) * elliprf(big**2 * spread, a**2 * spread, big**2 * (a - small) * (a + small))


def check_of_the_kernel():
    """The same from its definition, with x² = M² + t²."""
    r, s, a = mpf("0.3"), mpf("0.7"), mpf(1)
    plain = quad(lambda t: 1 / sqrt((s * s + t * t - r * r) * (s * s + t * t)), [0, sqrt(a * a - s * s)])
    assert abs(plain / kernel(r, s, a) - 1) < mpf(10) ** -25


def pressure(bend, c, k, s, a):
    cuts = {mpf(0), s, a}
    for centre, unit in ((c, 1 / k), (s, mpf(1)), (a, mpf(1))):
        for power in range(-56 if centre != c else -2, 45, 2):
            for side in (-1, 1):
                r = centre + side * mpf(2) ** power * unit
                if 0 < r < a:
                    cuts.add(r)
    if c < a:
        cuts.add(c)
    value, error = quad(lambda r: bend(r) * kernel(r, s, a), sorted(cuts), method="gauss-legendre", maxdegree=5, error=True)
    assert error < mpf(10) ** -19 * (1 + abs(value)), (value, error)
    return value


if __name__ == "__main__":
    check_of_the_kernel()
    with (pathlib.Path(__file__).parent / "feature_pressures.csv").open("w", newline="") as out:
        rows = csv.writer(out)
        rows.writerow(["profile", "radius", "contact", "value"])
        for case in range(20):
            text, background = BACKGROUNDS[case % len(BACKGROUNDS)]
            feature, bump = FEATURES[random.randrange(len(FEATURES))]
            a = mpf(random.choice([0.5, 1.1, 1.7]))
            k = mpf(10) ** random.randint(1, 6)
            c = mp.nint(a * mpf(random.uniform(0.05, 1.0)) * 10**13) / mpf(10) ** 13
            s = mpf(float(a) * random.choice([0.125, 0.5, 0.875]))
            name = mp.nstr(c, 14)
            c = mpf(name)

            def slope(r):
                return r * (background(r) + bump(r, c, k))

            value = pressure(lambda r: diff(slope, r, h=mpf(10) ** -11 / k), c, k, s, a)
            rows.writerow([f"{text}+{feature}".replace("K", str(int(k))).replace("C", name), repr(float(s)), repr(float(a)), mp.nstr(value, 17)])
