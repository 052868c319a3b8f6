"""Means of the pressure over square cells, with 20 digits, by nested quadrature in x and y; writes cells.csv."""

from pathlib import Path

from mpmath import acosh, mp, mpf, nstr, pi, quad, sqrt

mp.dps = 24
A = mpf(1)

PRESSURES = {
    # profile; depth of a rim; p(r) for E* = 1, a = 1
    "r^2/2": ("", lambda r: 2 / pi * sqrt(A * A - r * r)),
    "r": ("", lambda r: acosh(A / r) / 2),
    "0": ("1", lambda r: 1 / (pi * sqrt(A * A - r * r))),
}


def mean(p, x0, x1, y0, y1):
    """The part of the rectangle inside the circle; cells on an axis come as their halves."""

    def column(x):
        if x >= A:
            return mpf(0)
        top = min(y1, sqrt(A * A - x * x))
        return quad(lambda y: p(sqrt(x * x + y * y)), [y0, top]) if top > y0 else mpf(0)

    places = {x0, min(x1, A)}
    for y in (y0, y1):
        if y < A and x0 < sqrt(A * A - y * y) < x1:
            places.add(sqrt(A * A - y * y))
    return quad(column, sorted(places)) / ((x1 - x0) * (y1 - y0))


rows = ["profile;depth;side;count;row;column;mean"]
side, count = mpf("2.5"), 20
step = side / count
for profile, (depth, p) in PRESSURES.items():
    for i, j in ((0, 0), (1, 0), (1, 1), (5, 2), (7, 4), (8, 0), (6, 5)):
        half = lambda k: (max(mpf(k) - mpf(1) / 2, mpf(0)) * step, (k + mpf(1) / 2) * step)
        value = mean(p, *half(i), *half(j))
        rows.append(f"{profile};{depth};{side};{count};{count // 2 + j};{count // 2 + i};{nstr(value, 16)}")
Path(__file__).with_name("cells.csv").write_text("\n".join(rows) + "\n")
