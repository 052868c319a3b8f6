"""Contacts with narrow features: where the gap outside closes, or the pressure inside turns, by mpmath.

A paraboloid r^2/2 has a ring or a groove of width w somewhere. Outside the contact
    gap(r) = f(r) - g(a) + u(r),   u(r) = (2/pi)(g(a) asin(a/r) - int_0^a f'(s) atan(sqrt((a^2 - s^2)/(r^2 - a^2))) ds),
inside it pi p(r)/E* = int_0^a (s f')' K(r, s) ds, K = F(phi | m^2/M^2)/M, sin^2 phi = (a^2 - M^2)/(a^2 - m^2), where m
and M are the smaller and the larger of r and s.
Integrals are cut next to the feature. The first radius at which gap or pressure turns negative is bisected; a case is
written only where the least gap or pressure near the feature is clearly positive or clearly negative.
Writes verdicts.csv: profile, contact radius, "valid" or the rule, first radius.
"""

import csv
import random

from mpmath import asin, atan, ellipf, exp, mp, mpf, pi, quad, sqrt, tanh

mp.dps = 18

# Each with its first and second derivative.
KINDS = {
    "{s}{h}/(1+((r-{c})/{w})^2)": (
        lambda z: 1 / (1 + z * z),
        lambda z: -2 * z / (1 + z * z) ** 2,
        lambda z: (6 * z * z - 2) / (1 + z * z) ** 3,
    ),
    "{s}{h}*exp(-((r-{c})/{w})^2)": (
        lambda z: exp(-z * z),
        lambda z: -2 * z * exp(-z * z),
        lambda z: (4 * z * z - 2) * exp(-z * z),
    ),
    "{s}{h}*(1-tanh((r-{c})/{w})^2)": (
        lambda z: 1 - tanh(z) ** 2,
        lambda z: -2 * tanh(z) * (1 - tanh(z) ** 2),
        lambda z: (6 * tanh(z) ** 2 - 2) * (1 - tanh(z) ** 2),
    ),
}
CUTS = [-400, -100, -30, -10, -5, -2.5, -1, 0, 1, 2.5, 5, 10, 30, 100, 400]


class Profile:
    def __init__(self, kind, c, w, h):
        self.c, self.w, self.h, self.shape = mpf(c), mpf(w), mpf(h), KINDS[kind]
        sign = "+" if self.h > 0 else ""
        self.text = "r^2/2" + kind.format(s=sign, c=c, w=w, h=h)

    def f(self, r):
        return r * r / 2 + self.h * (self.shape[0]((r - self.c) / self.w) - self.shape[0](-self.c / self.w))

    def slope(self, r):
        return r + self.h / self.w * self.shape[1]((r - self.c) / self.w)

    def bend(self, r):
        z = (r - self.c) / self.w
        return 2 * r + self.h / self.w * self.shape[1](z) + r * self.h / self.w**2 * self.shape[2](z)

    def cuts(self, low, high):
        inner = [self.c + k * self.w for k in CUTS]
        return [low] + [x for x in inner if low < x < high] + [high]

    def g(self, x):
        ends = [asin(r / x) for r in self.cuts(mpf(0), x)]
        return x * quad(lambda t: self.slope(x * mp.sin(t)), ends)

    def gap(self, r, a, d):
        ends = [asin(s / a) for s in self.cuts(mpf(0), a)]
        kernel = lambda t: self.slope(a * mp.sin(t)) * atan(a * mp.cos(t) / sqrt(r * r - a * a)) * a * mp.cos(t)
        return self.f(r) - d + 2 / pi * (d * asin(a / r) - quad(kernel, ends))

    def pressure(self, r, a):
        def kernel(s):
            low, high = min(r, s), max(r, s)
            angle = asin(sqrt((a * a - high * high) / (a * a - low * low)))
            return self.bend(s) * ellipf(angle, (low / high) ** 2) / high

        ends = sorted({*self.cuts(mpf(0), a), r})
        return quad(kernel, ends)


def first_negative(function, places):
    """The first place of a sign change to negative values, bisected; and the least value seen."""
    values = [function(r) for r in places]
    for (low, high), (before, value) in zip(zip(places, places[1:]), zip(values, values[1:])):
        if before >= 0 > value:
            while high - low > mpf(10) ** -11 * high:
                middle = (low + high) / 2
                low, high = (low, middle) if function(middle) < 0 else (middle, high)
            return high, min(values)
    return None, min(values)


def outside(random_numbers, rows):
    kind = random_numbers.choice(list(KINDS))
    a = random_numbers.choice(["0.5", "0.9", "1.1", "2"])
    w = random_numbers.choice(["0.03", "0.01", "0.002", "0.0003"])
    c = str(round(float(a) * random_numbers.uniform(1.3, 5), 3))
    plain = Profile(kind, c, w, "1")
    plain.h = mpf(0)
    free = plain.gap(mpf(c), mpf(a), mpf(a) ** 2)
    h = str(-float(mp.nstr(free * random_numbers.choice([0.3, 0.8, 0.95, 1.05, 1.5, 3]), 4)))
    own = Profile(kind, c, w, h)
    d = own.g(mpf(a))
    places = [mpf(a) + (own.c - mpf(a)) * k / 16 for k in range(1, 16)] + [own.c + own.w * k / 4 for k in range(-32, 33)]
    at, least = first_negative(lambda r: own.gap(r, mpf(a), d), sorted(r for r in places if r > mpf(a)))
    if abs(least) > mpf("1e-4") * d:
        rows.append([own.text, a, "valid" if at is None else "outside_gap", "" if at is None else mp.nstr(at, 11)])


def inside(random_numbers, rows):
    kind = list(KINDS)[1]
    a = random_numbers.choice(["0.9", "1.4"])
    w = random_numbers.choice(["0.05", "0.02"])
    c = str(round(float(a) * random_numbers.uniform(0.2, 0.8), 3))
    h = f"{float(w) * random_numbers.choice([-3, -1.5, 0.7, 1.5, 2, 3]):.2g}"
    own = Profile(kind, c, w, h)
    places = [own.c * k / 8 for k in range(1, 8)] + [own.c + own.w * mpf(k) / 4 for k in range(-10, 11)]
    at, least = first_negative(lambda r: own.pressure(r, mpf(a)), sorted(r for r in places if 0 <= r < mpf(a)))
    if abs(least) > mpf("1e-2"):
        rows.append([own.text, a, "valid" if at is None else "tension_inside", "" if at is None else mp.nstr(at, 11)])


def main():
    random_numbers = random.Random(17)
    rows = []
    while len(rows) < 36:
        outside(random_numbers, rows)
    while len(rows) < 48:
        inside(random_numbers, rows)
    with open(__file__.replace(".py", ".csv"), "w", newline="") as file:
        csv.writer(file, lineterminator="\n").writerows([["profile", "contact_radius", "verdict", "at"], *rows])


if __name__ == "__main__":
    main()
