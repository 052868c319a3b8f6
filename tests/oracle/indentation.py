"""Contact radius and force of indentations at given depths, to 40 digits: roots of g(a) = d and F(a) of Popov & Heß and their like.

Run in this directory: python3 indentation.py > indentation.csv
The depth is the nearest double of what is written; E* = 1.
"""

from mpmath import acos, atan, atanh, gamma, mp, mpf, nstr, pi, sqrt

mp.dps = 120


def root(g, d, low, high):
    """The root of a rising g by bisection: slow and sure."""
    for _ in range(380):
        middle = (low + high) / 2
        if g(middle) < d:
            low = middle
        else:
            high = middle
    return high


def kappa(n):
    return sqrt(pi) * gamma(n / 2 + 1) / gamma(n / 2 + mpf(1) / 2)


def w(x, b):
    return sqrt((x - b) * (x + b))


def shapes():
    """Name, profile, g, F, the range of a, the depths."""
    depths = ["1e-16", "1e-8", "1e-3", "0.3", "1", "5"]
    one = mpf(1)
    yield "1-sqrt(1-r^2)", lambda x: x * atanh(x), lambda a: (1 + a * a) * atanh(a) - a, mpf(0), one, depths
    yield "sqrt(1+r^2)-1", lambda x: x * atan(x), lambda a: (a * a - 1) * atan(a) + a, mpf(0), mpf(100), depths
    yield "piecewise(0, r<1, r-1)", lambda x: x * acos(1 / x), lambda a: a * a * acos(1 / a) + w(a, 1), one, mpf(100), depths
    yield "piecewise(0, r<1, (r^2-1)/2)", lambda x: x * w(x, 1), lambda a: 2 * (2 * a * a + 1) * w(a, 1) / 3, one, mpf(100), depths
    yield (
        "piecewise(0, r<1, (r-1)^2/2)",
        lambda x: x * (w(x, 1) - acos(1 / x)),
        lambda a: 2 * (w(a, 1) * (4 * a * a - 1) / 6 - a * a / 2 * acos(1 / a)),
        one,
        mpf(100),
        depths,
    )

    # A paraboloid of radius 1 up to b, then its tangent cone: the kernel of the cap less that of the rounded edge.
    def capped_g(x):
        return x * x if x <= one / 4 else x * x - x * (w(x, one / 4) - acos(1 / (4 * x)) / 4)

    def capped_force(a):
        b = one / 4
        whole = 4 * a**3 / 3
        return whole if a <= b else whole - 2 * (w(a, b) * (4 * a * a - b * b) / 6 - b * a * a / 2 * acos(b / a))

    yield "piecewise(r^2/2, r<1/4, r/4-1/32)", capped_g, capped_force, mpf(0), mpf(100), ["1e-16", "1e-8", "1e-3", "0.0625", "0.3", "5"]
    for n in ["0.001", "0.5", "1.5", "17.3", "1000", "10000"]:
        exponent = mpf(n)
        k = kappa(exponent)
        g = lambda x, k=k, e=exponent: k * x**e
        force = lambda a, k=k, e=exponent: 2 * k * e / (e + 1) * a ** (e + 1)
        few = ["1", "1.5"] if n == "0.001" else ["1e-16", "1e-3", "0.3", "5"]
        for d in few:
            a = (mpf(float(d)) / k) ** (1 / exponent)
            yield f"r^({n})", None, force, a, a, [d]


print("profile;d;a;F")
for profile, g, force, low, high, depths in shapes():
    for d in depths:
        a = low if g is None else root(g, mpf(float(d)), low, high)
        print(";".join([profile, d, nstr(a, 40), nstr(force(a), 40)]))
