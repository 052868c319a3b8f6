"""Patterson's nested rules of 7 to 511 points for even integrands, as Rust source.

Run with mpmath; prints the body of crates/sneddon-num/src/quadrature/even/patterson.rs from its first `static`.
From the Gauss rule of 3 points on, each rule keeps the nodes of the one before and adds n + 1: the roots of
E, orthogonal to the old nodal polynomial times everything of degree <= n (T. N. L. Patterson, Math. Comp. 22, 1968).
Only the half z >= 0 is printed, the centre first; in that half the old nodes are the even positions.
Weights are for the sum over the half, 1 for the constant: the mean of an even function over [-1, 1].
Decay rows: for 15 points the discrete orthonormal polynomials of the four highest even degrees, times the weight; for more
Legendre polynomials of even degrees around half the degree of exactness.
"""
import sys
from mpmath import mp, mpf, matrix, lu_solve, sqrt, fsum, cos, pi, legendre

mp.dps = 110
LARGEST = int(sys.argv[1]) if len(sys.argv) > 1 else 511


def gauss(n):
    """Gauss-Legendre nodes and weights, positive half (n even)."""
    out = []
    for k in range(1, n // 2 + 1):
        x = cos(pi * (k - mpf(1) / 4) / (n + mpf(1) / 2))
        for _ in range(100):
            p0, p1 = mpf(1), x
            for m in range(2, n + 1):
                p0, p1 = p1, ((2 * m - 1) * x * p1 - (m - 1) * p0) / m
            d = n * (x * p1 - p0) / (x * x - 1)
            step = p1 / d
            x -= step
            if abs(step) < mpf(10) ** (-mp.dps + 8):
                break
        out.append((x, 2 / ((1 - x * x) * d * d)))
    return out


def legendre_row(x, top):
    row = [mpf(1), x]
    for m in range(2, top + 1):
        row.append(((2 * m - 1) * x * row[-1] - (m - 1) * row[-2]) / m)
    return row


def nodal(nodes, x):
    """prod (x^2 - z^2) * x, scaled."""
    p = x
    for z in nodes[1:]:
        p *= (x * x - z * z) * 4
    return p


def extend(nodes):
    """New positive nodes for a rule with this half of nodes (centre first)."""
    n = 2 * len(nodes) - 1
    half = (n + 1) // 2
    quad = gauss(2 * ((3 * n + 4) // 4) + 2)
    a, b = matrix(half, half), matrix(half, 1)
    rows = []
    for x, w in quad:
        leg = legendre_row(x, n + 1)
        rows.append((w * nodal(nodes, x), leg))
    for i in range(half):
        k = 2 * i + 1
        weighted = [wp * leg[k] for wp, leg in rows]
        for j in range(half):
            a[i, j] = fsum(u * leg[2 * j] for u, (_, leg) in zip(weighted, rows))
        b[i] = -fsum(u * leg[n + 1] for u, (_, leg) in zip(weighted, rows))
    e = list(lu_solve(a, b)) + [mpf(1)]

    def value(x):
        leg = legendre_row(x, n + 1)
        return fsum(c * leg[2 * j] for j, c in enumerate(e))

    ends = nodes + [mpf(1)]
    found = []
    for lo, hi in zip(ends, ends[1:]):
        flo, fhi = value(lo), value(hi)
        assert flo * fhi < 0
        for _ in range(40):
            mid = (lo + hi) / 2
            fm = value(mid)
            if fm * flo > 0:
                lo, flo = mid, fm
            else:
                hi, fhi = mid, fm
        x0, x1, f0, f1 = lo, hi, flo, fhi
        for _ in range(12):
            if f1 == f0:
                break
            x2 = x1 - f1 * (x1 - x0) / (f1 - f0)
            x0, f0, x1, f1 = x1, f1, x2, value(x2)
            if abs(x1 - x0) < mpf(10) ** (-mp.dps + 12):
                break
        found.append(x1)
    merged = []
    for old, new in zip(nodes, found):
        merged += [old, new]
    return merged


def weights(nodes):
    """Weights over the half with sum 1: interpolatory, by barycentric moments in Gauss points."""
    n = 2 * len(nodes) - 1
    quad = gauss(2 * ((n + 4) // 4) + 2)
    out = []
    for i, z in enumerate(nodes):
        # Lagrange basis of the pair +-z: even part, degree n - 1.
        def basis(x):
            p = mpf(1)
            for j, y in enumerate(nodes):
                if j != i:
                    p *= (x * x - y * y) / (z * z - y * y)
            return p
        out.append(fsum(w * basis(x) for x, w in quad))
    return out


def decay_rows(nodes, w):
    y = [z * z for z in nodes]
    dot = lambda a, b: fsum(wi * p * q for wi, p, q in zip(w, a, b))
    before, now = [mpf(0)] * len(y), [mpf(1)] * len(y)
    size = sqrt(dot(now, now))
    now = [v / size for v in now]
    basis, beta = [now], mpf(0)
    for _ in range(len(y) - 1):
        alpha = dot([v * t for v, t in zip(now, y)], now)
        nxt = [(t - alpha) * v - beta * u for t, v, u in zip(y, now, before)]
        beta = sqrt(dot(nxt, nxt))
        before, now = now, [v / beta for v in nxt]
        basis.append(now)
    assert abs(dot(basis[-1], basis[0])) < mpf(10) ** -30, abs(dot(basis[-1], basis[0]))
    return [[wi * v for wi, v in zip(w, b)] for b in basis[-4:]]


def legendre_rows(nodes, w, top):
    """The four highest even Legendre degrees up to top: beyond half the degree of exactness no rule tells them apart."""
    table = [legendre_row(z, top) for z in nodes]
    return [[wi * sqrt(mpf(2 * k + 1)) * row[k] for wi, row in zip(w, table)] for k in (top - 6, top - 4, top - 2, top)]


def literals(values, indent):
    text = [repr(float(v)) for v in values]
    pad = " " * indent
    lines = [", ".join(text[i:i + 8]) for i in range(0, len(text), 8)]
    return "[\n" + "".join(f"{pad}    {line},\n" for line in lines) + pad + "]"


def main():
    nodes = [mpf(0), sqrt(mpf(3) / 5)]
    levels = []
    while 2 * len(nodes) - 1 < LARGEST:
        nodes = extend(nodes)
        n = len(nodes)
        w = weights(nodes)
        assert abs(fsum(w) - 1) < mpf(10) ** -40
        points = 2 * n - 1
        degree = 3 * n - 1
        top = degree - degree % 2
        for k in (2, top // 2, top):
            exact = mpf(1) / (k // 2 * 2 + 1)
            got = fsum(wi * z ** (k // 2 * 2) for wi, z in zip(w, nodes))
            assert abs(got - exact) < mpf(10) ** -40, (points, k, got - exact)
        assert min(w) > 0
        # The smallest rule tells more apart than it integrates: its own discrete orthonormal polynomials serve.
        half_degree = (top + 1) // 2 + 1
        rows = decay_rows(nodes, w) if points <= 15 else legendre_rows(nodes, w, half_degree - half_degree % 2)
        levels.append((points, top + 1, w, rows))
        print(points, file=sys.stderr)
    n = len(nodes)
    print("/// z of every node of the largest rule, from the centre outwards; a smaller rule has every second, fourth, … of them.")
    print("#[rustfmt::skip]")
    print(f"pub(super) static NODES: [f64; {n}] = {literals(nodes, 0)};\n")
    print("/// √(1 − z²) of the same nodes.")
    print("#[rustfmt::skip]")
    cosines = [sqrt((1 - z) * (1 + z)) for z in nodes]
    print(f"pub(super) static COSINES: [f64; {n}] = {literals(cosines, 0)};\n")
    print("/// What the doubles leave of them.")
    print("#[rustfmt::skip]")
    print(f"pub(super) static COSINE_RESTS: [f64; {n}] = {literals([c - mpf(float(c)) for c in cosines], 0)};\n")
    for points, degree, w, rows in levels:
        half = len(w)
        print(f"/// {points} points, {half} of them in the half; exact up to degree {degree}.")
        print("#[rustfmt::skip]")
        print(f"pub(super) static PATTERSON_{points}: EvenRule<{half}> = EvenRule {{")
        print(f"    weights: {literals(w, 4)},")
        if points > 7:
            print("    decay: [")
            for row in rows:
                print(f"        {literals(row, 8)},")
            print("    ],")
        else:
            print(f"    decay: [[0.0; {half}]; 4],")
        print("};\n")


if __name__ == "__main__":
    main()
