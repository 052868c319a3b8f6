"""The quadrature of generated code: python3 clustered_rule.py > src/code/quadrature.txt.

The Gauss-Kronrod rule of 61 points over [0, 1] and its Gauss rule of 30 points, and the same in s with t = s^4 (5 - 4 s), where the points
t lie densely at both ends. Needs mpmath; everything at 80 digits.
"""
from mpmath import fsum, mpf

from gauss_kronrod import legendre_coefficients, roots, stieltjes, weights


def table(name, comment, values):
    text = [repr(float(own)) for own in values]
    lines = [", ".join(text[i:i + 4]) for i in range(0, len(text), 4)]
    listed = ",\n    ".join(lines)
    print(f"// {comment}\nfn {name}(i) {{\n  table t = {listed};\n  return t[i];\n}}")


def clustered(nodes, own):
    """The places t in (0, 1) and the weights for dt."""
    s = [(1 + node) / 2 for node in nodes]
    places = [own ** 4 * (5 - 4 * own) for own in s]
    found = [weight / 2 * 20 * own ** 3 * (1 - own) for own, weight in zip(s, own)]
    # The integrals of 1 and of t^(-1/4).
    assert abs(fsum(found) - 1) < mpf(10) ** -40
    assert abs(fsum(weight * place ** mpf(-0.25) for weight, place in zip(found, places)) - mpf(4) / 3) < mpf(10) ** -20
    return places, found


def plain(nodes, own):
    """The places in (0, 1) and their weights."""
    return [(1 + node) / 2 for node in nodes], [weight / 2 for weight in own]


def main():
    gauss = roots(legendre_coefficients(30))
    nodes = sorted(gauss + roots(stieltjes(30)))
    own, own_gauss = weights(nodes), weights(gauss)
    for name, rule, what in [("kronrod", plain, ""), ("clustered", clustered, ", densely at both ends")]:
        places, found = rule(nodes, own)
        table(f"{name}_place", f"The places in (0, 1) of the Gauss-Kronrod rule of 61 points{what}.", places)
        table(f"{name}_weight", f"The weights of the Gauss-Kronrod rule of 61 points{what}.", found)
        table(f"{name}_gauss", f"The weights of the Gauss rule of 30 points at every second place{what}.", rule(gauss, own_gauss)[1])


if __name__ == "__main__":
    main()
