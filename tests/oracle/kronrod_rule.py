"""The quadrature of generated code: python3 kronrod_rule.py > src/code/quadrature.txt.

The Gauss-Kronrod rule of 61 points over [0, 1] and its Gauss rule of 30 points. Needs mpmath; everything at 80 digits.
"""
from gauss_kronrod import legendre_coefficients, roots, stieltjes, weights


def table(name, comment, values):
    text = [repr(float(own)) for own in values]
    lines = [", ".join(text[i:i + 4]) for i in range(0, len(text), 4)]
    listed = ",\n    ".join(lines)
    print(f"// {comment}\nfn {name}(i) {{\n  table t = {listed};\n  return t[i];\n}}")


def main():
    gauss = roots(legendre_coefficients(30))
    nodes = sorted(gauss + roots(stieltjes(30)))
    own, own_gauss = weights(nodes), weights(gauss)
    table("kronrod_place", "The places in (0, 1) of the Gauss-Kronrod rule of 61 points.", [(1 + node) / 2 for node in nodes])
    table("kronrod_weight", "The weights of the Gauss-Kronrod rule of 61 points.", [weight / 2 for weight in own])
    table("kronrod_gauss", "The weights of the Gauss rule of 30 points at every second place.", [weight / 2 for weight in own_gauss])


if __name__ == "__main__":
    main()
