"""Compares typed profiles with themselves in other units: python3 units.py PROGRAM FIRST COUNT.

The quantities g, F, U, p, … of s f(r/s) at s x must equal those of f at x times powers of s, with s from 2^-1000 to 2^900.
"""
import json
import random
import re
import sys
from fractions import Fraction

import shapes
from attack import run

# The power of s that each quantity has.
POWERS = {"f": 1, "g": 1, "F": 2, "G": 2, "U": 3, "p_mean": 0, "p": 0, "u": 1, "sigma_zz": 0}
SCALES = [-1000, -990, -960, -900, -700, -520, -500, -330, -100, -60, -40, -30, -20, 40, 100, 330, 400, 500, 520, 700, 900]


def points(program, text, quantity, at, radius, sets):
    """Return the points that `sneddon eval --json` prints, an empty list if the program refuses all of them."""
    command = [program, "eval", text, "--quantity", quantity, "--at", ",".join(map(repr, at)), "--json", *sets]
    if radius is not None:
        command += ["--radius", repr(radius)]
    code, out, err, _ = run(command)
    if code not in (0, 1, 2):
        print("crash", command, err[:200], flush=True)
    return json.loads(out).get("points", []) if out.strip() else []


def main():
    program, first, count = sys.argv[1], int(sys.argv[2]), int(sys.argv[3])
    compared = wrong = refused = 0
    for seed in range(first, first + count):
        profile, chance = shapes.typed(seed), random.Random(seed)
        sets = shapes.settings(profile)
        a = max(profile.places)
        radii = [0.0, a * chance.uniform(0.02, 0.98), a * chance.uniform(0.9, 1.0)]
        power = chance.choice(SCALES)
        scale = 2.0**power
        scaled = f"(2^({power}))*(" + re.sub(r"\br\b", f"(r/(2^({power})))", profile.text) + ")"
        places = {"p": radii, "u": [1.1 * a, 1.7 * a], "sigma_zz": [0.1 * a, 2.0 * a]}
        for quantity, by in POWERS.items():
            at, radius = places.get(quantity, profile.places), a if quantity in places else None
            usual = points(program, profile.text, quantity, at, radius, sets)
            other = points(program, scaled, quantity, [x * scale for x in at], radius and radius * scale, sets)
            refused += len(usual) if not other else 0
            for one, two in zip(usual, other):
                if one["value"] is None or two["value"] is None:
                    refused += one["value"] is not None
                    continue
                compared += 1
                factor = Fraction(scale) ** by
                off = abs(Fraction(one["value"]) * factor - Fraction(two["value"]))
                if off > Fraction(one["error_estimate"]) * factor + Fraction(two["error_estimate"]):
                    wrong += 1
                    print("differs", seed, power, quantity, one, two, scaled, sets, flush=True)
    print(f"units {first}+{count}: {compared} numbers compared, {wrong} differ by more than their bounds, {refused} refused in other units")


if __name__ == "__main__":
    main()
