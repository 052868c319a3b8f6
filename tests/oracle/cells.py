"""Means of the pressure over square cells, with 20 digits, by quadrature in x of integrals along y; writes cells.csv."""

from pathlib import Path

from mpmath import acosh, asin, mp, mpf, nstr, pi, quad, sqrt

mp.dps = 20
A = mpf(1)

def arcsine(y, c):
    return asin(min(y / c, mpf(1)))


# profile: depth of a rim, and the integral of p from the axis y = 0 to y along a line x, c² = 1 - x², for E* = 1 and a = 1
PRESSURES = {
    "r^2/2": ("", lambda x, c, y: (y * sqrt(max(c * c - y * y, 0)) + c * c * arcsine(y, c)) / pi),
    "r": ("", lambda x, c, y: quad(lambda t: acosh(max(A / sqrt(x * x + t * t), 1)) / 2, [0, y]) if y > 0 else mpf(0)),
    "0": ("1", lambda x, c, y: arcsine(y, c) / pi),
}


def mean(column, x0, x1, y0, y1):
    """The part of the rectangle inside the circle; cells on an axis come as their halves."""

    def along(x):
        if x >= A:
            return mpf(0)
        c = sqrt(A * A - x * x)
        top = min(y1, c)
        return column(x, c, top) - column(x, c, y0) if top > y0 else mpf(0)

    places = {x0, min(x1, A)}
    for y in (y0, y1):
        if y < A and x0 < sqrt(A * A - y * y) < x1:
            places.add(sqrt(A * A - y * y))
    return quad(along, sorted(places)) / ((x1 - x0) * (y1 - y0))


rows = ["profile;depth;side;count;row;column;mean"]
side, count = mpf("2.5"), 20
step = side / count
for profile, (depth, p) in PRESSURES.items():
    for i, j in ((0, 0), (1, 0), (1, 1), (5, 2), (7, 4), (8, 0), (6, 5)):
        half = lambda k: (max(mpf(k) - mpf(1) / 2, mpf(0)) * step, (k + mpf(1) / 2) * step)
        value = mean(p, *half(i), *half(j))
        rows.append(f"{profile};{depth};{side};{count};{count // 2 + j};{count // 2 + i};{nstr(value, 16)}")
Path(__file__).with_name("cells.csv").write_text("\n".join(rows) + "\n")
