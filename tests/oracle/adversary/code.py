"""Compares generated C with the program for typed profiles: python3 code.py PROGRAM FIRST COUNT.

The functions for g, F, p, a(d) and F(d) that `sneddon code --lang c` writes are compiled and called over nine decades of the radius.
A value is a fault if it is not a number, or if it differs from that of `sneddon eval` by more than its claim, times the condition number
1 + sum |v df/dv|/|f| where the claim says so, and the bound of `eval`.
Needs cc and the GNU Scientific Library.
"""
import json
import math
import pathlib
import re
import subprocess
import sys
import tempfile
from collections import Counter

import shapes

STEP = 1e-6
SECONDS = 10
FACTORS = (1e-9, 1e-6, 1e-3, 0.03, 0.1, 0.3, 0.5, 0.77, 0.93, 1.0)


def points(program, profile, quantity, places, radius):
    """Return what `eval` says of the places."""
    more = ["--radius", repr(radius)] if quantity == "p" else []
    command = [program, "eval", profile.text, "--quantity", quantity, "--at", ",".join(map(repr, places)), "--json", *more]
    out = subprocess.run(command + shapes.settings(profile), capture_output=True, text=True).stdout
    found = json.loads(out).get("points", []) if out.strip() else []
    return [own for own in found if own.get("value") is not None]


def calls(text, profile, quantity, found, radius):
    """Return the arguments of every call, those of the point first and then those of its neighbours."""
    names = re.search(rf"^double sneddon_{quantity}\(([^)]*)\)", text, re.M).group(1).replace("double ", "").split(", ")
    renamed = re.search(r"^// Names: (.*)\.$", text, re.M)
    symbols = dict(own.split(" is ") for own in renamed.group(1).split(", ")) if renamed else {}
    known = {"E": 1.0, "a": radius} if quantity == "p" else {"E": 1.0}
    for point in found:
        coordinate = names[0]
        base = [point["at"] if own == coordinate else known.get(own) or float(profile.values[symbols.get(own, own)]) for own in names]
        moved = [[*base[:i], base[i] * (1 + sign * STEP), *base[i + 1:]] for i in range(len(base)) for sign in (1, -1)]
        yield [base, *moved]


def attack(program, seed, folder, count):
    """Compare the functions of one profile."""
    profile = shapes.typed(seed)
    radius = max(profile.places)
    radii = [radius * own for own in FACTORS] + profile.places
    for quantity in ("g", "F", "p", "a", "F_of_d"):
        places = radii if quantity in "gF" else [own for own in radii if own < radius]
        if quantity in ("a", "F_of_d"):
            places = [own["value"] for own in points(program, profile, "g", radii, radius) if own["value"] > 0]
        source = folder / "own.c"
        written = subprocess.run([program, "code", profile.text, "--lang", "c", "--quantity", quantity, "-o", source], capture_output=True)
        if written.returncode != 0:
            count["refused"] += 1
            continue
        found = points(program, profile, quantity, places, radius) if places else []
        text = source.read_text()
        groups = list(calls(text, profile, quantity, found, radius))
        lines = [f'    printf("%.17g\\n", sneddon_{quantity}({", ".join(map(repr, own))}));' for group in groups for own in group]
        source.write_text(text + "\n#include <stdio.h>\nint main(void)\n{\n" + "\n".join(lines) + "\n    return 0;\n}\n")
        compiler = ["cc", "-O1", "-ffp-contract=off", source, "-lgsl", "-lgslcblas", "-lm", "-o", folder / "own"]
        subprocess.run(compiler, check=True, capture_output=True)
        fault = lambda what: print(f"{what}: seed {seed}, {quantity} of {profile.text} {profile.values}", flush=True)
        count["functions"] += 1
        try:
            out = subprocess.run([folder / "own"], capture_output=True, text=True, timeout=SECONDS).stdout
        except subprocess.TimeoutExpired:
            count["faults"] += 1
            fault("no end")
            continue
        values = iter(map(float, out.split()))
        claims = re.findall(r"at most ([\d.e+]+) ulp( times)?", text)
        if not claims:
            count["without a claim"] += 1
            continue
        for point, group in zip(found, groups):
            own, *moved = [next(values) for _ in group]
            true = point["value"]
            if true == 0:
                continue
            count["values"] += 1
            shares = [abs((more - less) / (2 * STEP * own)) for more, less in zip(moved[::2], moved[1::2])] if own else []
            condition = 1 + sum(shares)
            ulps, times = claims[-1]
            allowed = float(ulps) * (1.01 * condition if times else 1) * math.ulp(true) + point["error_estimate"]
            # Next to the greatest depth that a profile reaches, its neighbour has no radius.
            if math.isnan(allowed):
                count["without a condition number"] += 1
            elif not abs(own - true) <= allowed:
                count["faults"] += 1
                fault(f"{own!r} at {point['at']!r}, not {true!r} within {allowed:.1e}")


def main():
    program, first, number = sys.argv[1], int(sys.argv[2]), int(sys.argv[3])
    count = Counter()
    with tempfile.TemporaryDirectory() as folder:
        for seed in range(first, first + number):
            attack(program, seed, pathlib.Path(folder), count)
    print(f"{number} profiles from {first}: {dict(sorted(count.items()))}")


if __name__ == "__main__":
    main()
