"""Gauss-Kronrod rules of 15, 21, 31 and 61 points with their decay rules, as Rust source.

Run with mpmath; prints the body of crates/sneddon-num/src/quadrature/rules.rs from its first `pub(super) static`.
Nodes: Gauss nodes are the roots of P_n, the others those of the Stieltjes polynomial E_(n+1), which
is orthogonal to P_n times everything of degree <= n. Weights solve the moment equations in the
Legendre basis. Everything at 80 digits; exactness on monomials is asserted to 1e-40.
Decay rows: the discrete orthonormal polynomials of the six highest degrees on the rule's own
nodes and weights, times the weight: sum(row * f) is the f's coefficient of that degree.
"""
from fractions import Fraction
from mpmath import mp, mpf, matrix, lu_solve, polyroots, legendre, sqrt, fsum

mp.dps = 80


def legendre_coefficients(n):
    """Exact coefficients of P_n, constant first."""
    p, q = [Fraction(1)], [Fraction(0), Fraction(1)]
    if n == 0:
        return p
    for k in range(1, n):
        nxt = [Fraction(0)] + [Fraction(2 * k + 1, k + 1) * c for c in q]
        for i, c in enumerate(p):
            nxt[i] -= Fraction(k, k + 1) * c
        p, q = q, nxt
    return q


def moment(c):
    """Integral over [-1, 1] of a polynomial."""
    return sum(2 * v / (i + 1) for i, v in enumerate(c) if i % 2 == 0)


def product(a, b):
    out = [Fraction(0)] * (len(a) + len(b) - 1)
    for i, x in enumerate(a):
        for j, y in enumerate(b):
            out[i + j] += x * y
    return out


def real(f):
    return mpf(f.numerator) / mpf(f.denominator)


def roots(c):
    found = polyroots([real(v) for v in reversed(c)] if isinstance(c[0], Fraction) else list(reversed(c)),
                      maxsteps=500, extraprec=400)
    return sorted(r.real for r in found)


def stieltjes(n):
    """Coefficients of E_(n+1), monic, constant first: only its own parity appears."""
    p = legendre_coefficients(n)
    powers = list(range((n + 1) % 2, n + 1, 2))
    tests = [k for k in range(n + 1) if (n + n + 1 + k) % 2 == 0]
    rows = [[moment(product(p, [Fraction(0)] * (k + j) + [Fraction(1)])) for j in powers] for k in tests]
    right = [-moment(product(p, [Fraction(0)] * (k + n + 1) + [Fraction(1)])) for k in tests]
    keep = [i for i, r in enumerate(rows) if any(r)]
    assert len(keep) == len(powers), (len(keep), len(powers))
    a = matrix([[real(v) for v in rows[i]] for i in keep])
    x = lu_solve(a, matrix([real(right[i]) for i in keep]))
    out = [mpf(0)] * (n + 2)
    out[n + 1] = mpf(1)
    for j, v in zip(powers, x):
        out[j] = v
    return out


def weights(nodes):
    n = len(nodes)
    a = matrix([[legendre(k, x) for x in nodes] for k in range(n)])
    return list(lu_solve(a, matrix([2] + [0] * (n - 1))))


def decay_rows(nodes, w):
    """Discrete orthonormal polynomials of the six highest degrees, times the weights."""
    basis = []
    previous = [mpf(1)] * len(nodes)
    for degree in range(len(nodes)):
        v = list(previous) if degree == 0 else [x * y for x, y in zip(nodes, basis[-1])]
        for _ in range(2):
            for b in basis:
                d = fsum(wi * x * y for wi, x, y in zip(w, v, b))
                v = [x - d * y for x, y in zip(v, b)]
        size = sqrt(fsum(wi * x * x for wi, x in zip(w, v)))
        basis.append([x / size for x in v])
    return [[wi * x for wi, x in zip(w, b)] for b in basis[-6:]]


def literals(values):
    text = [repr(float(v)) for v in values]
    lines = [", ".join(text[i:i + 4]) for i in range(0, len(text), 4)]
    return "[\n        " + ",\n        ".join(lines) + ",\n    ]"


def rule(n):
    gauss = roots(legendre_coefficients(n))
    nodes = sorted(gauss + roots(stieltjes(n)))
    w = weights(nodes)
    w_gauss = weights(gauss)
    degree = 3 * n + 1 + n % 2
    for k in range(degree + 1):
        exact = mpf(2) / (k + 1) if k % 2 == 0 else mpf(0)
        assert abs(fsum(wi * x ** k for wi, x in zip(w, nodes)) - exact) < mpf(10) ** -40, (n, k)
    for k in range(2 * n):
        exact = mpf(2) / (k + 1) if k % 2 == 0 else mpf(0)
        assert abs(fsum(wi * x ** k for wi, x in zip(w_gauss, gauss)) - exact) < mpf(10) ** -40, (n, k)
    assert min(w) > 0
    half = n + 1
    upper = list(reversed(nodes))[:half]           # from the end inwards, the centre last
    at_gauss = {mp.nstr(x, 30): v for x, v in zip(gauss, w_gauss)}
    on_gauss = [at_gauss.get(mp.nstr(x, 30), mpf(0)) for x in upper]
    on_gauss[-1] = on_gauss[-1] if n % 2 else mpf(0)
    if n % 2:
        on_gauss[-1] = w_gauss[n // 2]
    back = lambda row: list(reversed(row))[:half]
    rows = decay_rows(nodes, w)
    points = 2 * n + 1
    print(f"/// {points} points; exact up to degree {degree}, its Gauss rule of {n} points up to {2 * n - 1}.")
    print("#[rustfmt::skip]")
    print(f"pub(super) static KRONROD_{points}: Rule<{half}> = Rule {{")
    print(f"    distance: {literals([(1 - x) / 2 for x in upper])},")
    print(f"    kronrod: {literals(back(w))},")
    print(f"    gauss: {literals(on_gauss)},")
    print("    decay: [")
    for row in rows:
        print(f"    {literals(back(row))},")
    print("    ],")
    print("};\n")


if __name__ == "__main__":
    for n in (7, 10, 15, 30):
        rule(n)
