"""Contact radius and force of every named shape at extreme sizes and depths, from closed forms with 25 digits; writes scene_extremes.csv.

The numbers of a row are exact doubles; E* = 1 and lengths in metres unless the row says otherwise. The condition number is
the sum of the logarithmic derivatives of F by the depth and every parameter.
"""

import sys
from pathlib import Path

from mpmath import acos, atan, findroot, gamma, log, mp, mpf, nstr, pi, sin, sqrt, tan

mp.dps = 70


def tail(m, b, x):
    """J_m = int_b^x r^m/sqrt(x^2 - r^2) dr."""
    if x <= b:
        return mpf(0)
    w, t = sqrt((x - b) * (x + b)), acos(b / x)
    return [t, w, (x * x * t + b * w) / 2, w * (2 * x * x + b * b) / 3][m]


def numbers(terms):
    """g and F/(2E*) of f' = sum of c r^m from b on."""
    g = lambda x: x * sum(c * tail(m, b, x) for c, m, b in terms)
    return g, lambda a: sum(c * tail(m + 2, b, a) for c, m, b in terms)


def cap(R, c):
    """The same of f' = r/sqrt(R^2 - r^2) up to c."""

    def part(x):
        end = min(c, x)
        return log((R + x) / (sqrt((R - end) * (R + end)) + sqrt((x - end) * (x + end))))

    def force(a):
        end = min(c, a)
        product = sqrt((R - end) * (R + end)) * sqrt((a - end) * (a + end))
        return (product - R * a) / 2 + (R * R + a * a) / 2 * part(a)

    return (lambda x: x * part(x)), force


def added(one, other):
    return (lambda x: one[0](x) + other[0](x)), (lambda a: one[1](a) + other[1](a))


def kappa(n):
    return sqrt(pi) * gamma(n / 2 + 1) / gamma((n + 1) / 2)


def shapes(p):
    """name: parameters -> (g, F/(2E*), the radius of the flat part)."""
    zero = mpf(0)
    name = p["shape"]
    if name == "power":
        C, n = p["C"], p["n"]
        return (lambda x: C * kappa(n) * x**n), (lambda a: C * kappa(n) * n / (n + 1) * a ** (n + 1)), zero
    if name == "cone":
        t = tan(p["theta"])
        return (lambda x: pi / 2 * t * x), (lambda a: pi / 4 * t * a * a), zero
    if name == "paraboloid":
        R = p["R"]
        return (lambda x: x * x / R), (lambda a: 2 * a**3 / (3 * R)), zero
    if name == "sphere":
        R = p["R"]
        return *cap(R, R), zero
    if name == "ellipsoid":
        b, c = p["b"], p["c"]
        g, F = cap(c, c)
        return (lambda x: b / c * g(x)), (lambda a: b / c * F(a)), zero
    if name == "hyperboloid":
        h, b = p["h"], p["b"]
        force = lambda u: h * b / 2 * ((u * u - 1) * atan(u) + u)
        return (lambda x: h * (x / b) * atan(x / b)), (lambda a: force(a / b)), zero
    if name == "truncated-cone":
        b, t = p["b"], tan(p["theta"])
        return *numbers([(t, 0, b)]), b
    if name == "truncated-paraboloid":
        b, R = p["b"], p["R"]
        return *numbers([(1 / R, 1, b)]), b
    if name == "flat-with-rounded-edge":
        b, R = p["b"], p["R"]
        return *numbers([(1 / R, 1, b), (-b / R, 0, b)]), b
    if name == "cone-with-spherical-cap":
        R, th = p["R"], p["theta"]
        return *added(cap(R, R * sin(th)), numbers([(tan(th), 0, R * sin(th))])), zero
    if name == "cone-with-parabolic-cap":
        b, t = p["b"], tan(p["theta"])
        return *numbers([(t / b, 1, zero), (-t / b, 1, b), (t, 0, b)]), zero
    if name == "paraboloid-with-parabolic-cap":
        P, b, R = p["P"], p["b"], p["R"]
        return *numbers([(1 / P, 1, zero), (1 / R - 1 / P, 1, b)]), zero
    raise ValueError(name)


def solved(p, d):
    """a and F/(2E*) at a depth, by a bracketed root."""
    g, F, flat = shapes(p)
    low, high = (flat, None) if flat else (mpf(0), None)
    limit = p.get("c") if p["shape"] == "ellipsoid" else p.get("R") if p["shape"] == "sphere" else None
    # From the logarithm of a - b, or of a/(R - a), by bisection and then by secants.
    place = lambda u: limit / (1 + mp.exp(-u)) if limit else flat + mp.exp(u)
    miss = lambda u: log(g(place(u)) / d)
    low, high = log(p["start"]) - 1, log(p["start"]) + 1
    while miss(low) > 0:
        low -= 3
    while miss(high) < 0:
        high += 3
    a = place(findroot(miss, (low, high), solver="anderson", tol=mpf(10) ** -110, maxsteps=200, verify=False))
    return a, F(a)


def cases():
    for scale in ("1e-9", "1", "1e6"):
        L = mpf(float(scale))
        f = lambda x: mpf(float(x * L))
        for share in ("1e-14", "1e-8", "1e-3", "0.3"):
            x = mpf(share)
            yield {"shape": "cone", "theta": mpf(0.2)}, f(x), x * L
            yield {"shape": "paraboloid", "R": f(1)}, f(x), sqrt(x) * L
            yield {"shape": "sphere", "R": f(1)}, f(x), sqrt(x)
            yield {"shape": "ellipsoid", "b": f(mpf(2)), "c": f(mpf(0.5))}, f(x), sqrt(x)
            yield {"shape": "hyperboloid", "h": f(mpf(0.25)), "b": f(mpf(1.5))}, f(x), sqrt(x) * L
            yield {"shape": "truncated-cone", "b": f(mpf(0.5)), "theta": mpf(0.2)}, f(x), x * x * L + mpf(10) ** -30 * L
            yield {"shape": "truncated-paraboloid", "b": f(mpf(0.5)), "R": f(1)}, f(x), x * x * L + mpf(10) ** -30 * L
            yield {"shape": "flat-with-rounded-edge", "b": f(mpf(0.5)), "R": f(1)}, f(x), x ** (mpf(2) / 3) * L
            yield {"shape": "cone-with-spherical-cap", "R": f(mpf(0.25)), "theta": mpf(0.2)}, f(x), sqrt(x) * L
            yield {"shape": "cone-with-parabolic-cap", "b": f(mpf(0.125)), "theta": mpf(0.2)}, f(x), sqrt(x) * L
            yield {"shape": "paraboloid-with-parabolic-cap", "P": f(4), "b": f(mpf(0.125)), "R": f(1)}, f(x), sqrt(x) * L
            for n in ("1e-3", "0.5", "1.5", "3", "341", "342", "1e4"):
                own = mpf(float(n))
                # C = L^(1 - n) would leave the range of doubles: lengths of order 1 there.
                if scale == "1" or own <= 3:
                    yield {"shape": "power", "C": mpf(float(L ** (1 - own))), "n": own}, f(x), L * (x / kappa(own)) ** (1 / own)
    for depth in ("0.99", "0.999"):
        # Shares of the radius of the sphere: g grows without bound, so d/R may exceed 1.
        yield {"shape": "sphere", "R": mpf(1)}, mpf(float(mpf(depth) * mp.atanh(mpf(depth)))), mpf(20)


rows = ["shape;parameters;d;a;F;condition"]
for p, d, start in cases():
    p["start"] = start
    a, F = solved(p, d)
    logs = []
    for key in [k for k in p if k not in ("shape", "start")] + ["d"]:
        e = mpf(10) ** -20
        q, dd = dict(p), d
        if key == "d":
            dd = d * (1 + e)
        else:
            q[key] = p[key] * (1 + e)
        logs.append(abs(solved(q, dd)[1] / F - 1) / e)
    text = ", ".join(f"{k} = {float(v)!r}" for k, v in p.items() if k not in ("shape", "start"))
    rows.append(f"{p['shape']};{text};{float(d)!r};{nstr(a, 25)};{nstr(2 * F, 25)};{nstr(sum(logs), 4)}")
    print(rows[-1], file=sys.stderr)
Path(__file__).with_name("scene_extremes.csv").write_text("\n".join(rows) + "\n")
