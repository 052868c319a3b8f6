"""Places of the comparison and their values with 50 digits: writes points.csv. Constants and places are the doubles that the programs see."""
from mpmath import mp, mpf, atanh, sqrt, pi, gamma, struveh, tanh, exp, erfi, acos, quad, sin, linspace, acosh, cosh, asinh

mp.dps = 50


def kappa(n):
    return sqrt(pi) / 2 * n * gamma(n / 2) / gamma((n + 1) / 2)


def dawson(z):
    return sqrt(pi) / 2 * exp(-z * z) * erfi(z)


def smooth(slope, x):
    """x times the integral of slope(x sin t) over a quarter turn."""
    return x * quad(lambda t: slope(x * sin(t)), linspace(0, pi / 2, 9))


b, w2 = mpf(0.6), mpf(1.69)
G = {
    "sphere": lambda x: x * atanh(x / 2),
    "power": lambda x: mpf(2.7) / (1 + mpf(1.7)) * kappa(1 + mpf(1.7)) * x ** (1 + mpf(1.7)),
    "worn": lambda x: x / 2 * sqrt(x * x - b * b),
    "cosine": lambda x: mpf(0.88) * x * pi / 2 * struveh(0, mpf(2.2) * x),
    "root": lambda x: mpf(0.35) * 2 * kappa(mpf(1) / 2) * sqrt(x),
    "ln_cosh": lambda x: smooth(tanh, x),
    "gaussian": lambda x: 2 * mpf(0.4) * x / sqrt(w2) * dawson(x / sqrt(w2)),
    "kink": lambda x: mpf(0.3) * x * acos(b / x),
}
PLACES = {
    "sphere": [0.01, 0.5, 1.9, 1.999999],
    "power": [0.5, 3.0],
    "worn": [0.6001, 0.7, 3.0],
    "cosine": [0.5, 3.0, 100.0],
    "root": [0.5],
    "ln_cosh": [0.5, 3.0],
    "gaussian": [0.5, 3.0],
    "kink": [3.0],
}


def line(work, profile, x, value):
    high = float(value)
    return f"{work},{profile},{x!r},{high!r},{float(value - mpf(high))!r}"


def main():
    rows = ["work,profile,x,value,rest"]
    for profile, places in PLACES.items():
        rows += [line(f"{profile}@{x:.7g}", profile, x, G[profile](mpf(x))) for x in places]
    # F/E* of ln cosh at a = 3, and p π/E* at s = 1.5: each straight from the definition.
    a, s = mpf(3), mpf(1.5)
    force = 2 * quad(lambda t: (a * sin(t)) ** 2 * tanh(a * sin(t)), linspace(0, pi / 2, 9))
    bend = lambda r: tanh(r) + r * (1 - tanh(r) ** 2)
    rise = lambda x: quad(lambda t: bend(x * sin(t)), linspace(0, pi / 2, 5))
    pressure = quad(lambda y: rise(s * cosh(y)), linspace(0, acosh(a / s), 5))
    rows.append(line("force@3", "ln_cosh", 3.0, force))
    rows.append(line("pressure@1.5", "ln_cosh", 1.5, pressure))
    print("\n".join(rows))


if __name__ == "__main__":
    main()
