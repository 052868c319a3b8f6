#!/usr/bin/env python3
"""Writes decades.csv: g(x) and F(a)/(2E*) of profiles of the catalogue over 24 decades of the radius.

Run:  python3 tests/oracle/decades.py          (needs mpmath 1.3 and sympy 1.12; six minutes; deterministic)

Each row: profile, quantity, radius (an exact double as repr prints it), value with 25 digits. The values are integrals over the angle,
g = x ∫₀^(π/2) f′(x sin θ) dθ and F/(2E*) = a² ∫₀^(π/2) sin²θ f′(a sin θ) dθ, split at powers of ten of θ, at 60 and at 80 digits,
which must agree. No closed form is used.
"""
import json
from pathlib import Path

import sympy
from mpmath import mp, mpf, nstr, pi, quad, sin

here = Path(__file__).parent
WANTED = """cone paraboloid quartic sqrt power_n cone_paraboloid poly10 power_log r2_log_r sphere ellipsoid hyperboloid lorentzian gaussian
log_quadratic r_arctan log_linear erf r2_gauss exp_growth""".split()
# Beyond this multiple of the length the profile ends, or its values leave the doubles.
ENDS = {"sphere": 1, "ellipsoid": 1, "exp_growth": 200}
DECADES = [-12, -9, -6, -4.3, -3, -2, -1, -0.5, -0.2, 0.3, 0.8, 1.3, 2, 3.1, 4, 6, 9, 12]


def integral(slope, x, weight):
    ends = [mpf(0)] + [mpf(10) ** k for k in range(-16, 0)] + [mpf(j) / 10 for j in (2, 3, 5, 8, 11, 14)] + [pi / 2]
    return quad(lambda t: weight(t) * slope(x * sin(t)), ends, maxdegree=9)


rows = []
for entry in json.loads((here / "../data/profiles.json").read_text()):
    if entry["id"] not in WANTED:
        continue
    r = sympy.Symbol("r", positive=True)
    names = {name: sympy.Symbol(name, positive=True) for name in entry["params"]}
    formula = sympy.sympify(entry["f"].replace("^", "**").replace("ln(", "log("), {"r": r, **names})
    # Parameters are the doubles next to the typed numbers, as the compiled code takes them.
    numbers = {names[name]: sympy.Rational(*float(value).as_integer_ratio()) for name, value in entry["params"].items()}
    slope = sympy.lambdify(r, sympy.diff(formula, r).subs(numbers), "mpmath")
    length = float(next((entry["params"][name] for name in ("R", "w", "b", "c") if name in entry["params"]), 1))
    for decade in DECADES:
        x = length * 10.0**decade
        if decade > 0 and 10.0**decade >= ENDS.get(entry["id"], 1e300):
            continue
        for quantity, front, weight in (("g", lambda x: x, lambda t: mpf(1)), ("F", lambda x: x * x, lambda t: sin(t) ** 2)):
            values = []
            for digits in (60, 80):
                mp.dps = digits
                values.append(front(mpf(x)) * integral(slope, mpf(x), weight))
            assert abs(values[0] - values[1]) <= abs(values[1]) * mpf(10) ** -22, (entry["id"], quantity, x, values)
            rows.append(f"{entry['id']},{quantity},{x!r},{nstr(values[1], 25)}")
(here / "decades.csv").write_text("profile,quantity,radius,value\n" + "\n".join(rows) + "\n")
