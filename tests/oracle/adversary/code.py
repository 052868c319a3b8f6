"""Compares generated C with the program: python3 code.py PROGRAM typed FIRST COUNT, or python3 code.py PROGRAM catalogue PLACES.

The functions for g, F, p, a(d) and F(d) that `sneddon code --lang c` writes are compiled and called: those of typed profiles at a dozen
radii over nine decades, those of the catalogue at random places over the whole range of their claim.
A value is a fault if it is not a number, or if it differs from that of `sneddon eval` by more than its claim, times the condition number
1 + sum |v df/dv|/|f| where the claim says so, and the bound of `eval`.
Needs cc and the GNU Scientific Library.
"""
import json
import math
import pathlib
import random
import re
import subprocess
import sys
import tempfile
from collections import Counter
from types import SimpleNamespace

import shapes

# At large radii waves are shorter than the first step; the last one leads to the next double.
STEPS = (1e-6, 1e-9, 1e-13, 2.0**-52)
SECONDS = 60
FACTORS = (1e-9, 1e-6, 1e-3, 0.03, 0.1, 0.3, 0.5, 0.77, 0.93, 1.0)
PROFILES = pathlib.Path(__file__).parents[2] / "data" / "profiles.json"
# The most places in one call of `eval`, whose list of places is one argument.
MOST = 2000


def evaluated(program, profile, quantity, places, radius):
    """Return what `eval` says of the places."""
    more = ["--radius", repr(radius)] if quantity == "p" else []
    found = []
    for first in range(0, len(places), MOST):
        at = ",".join(map(repr, places[first:first + MOST]))
        command = [program, "eval", profile.text, "--quantity", quantity, "--at", at, "--json", *more]
        out = subprocess.run(command + shapes.settings(profile), capture_output=True, text=True).stdout
        found += json.loads(out).get("points", []) if out.strip() else []
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
        moved = [[*base[:i], base[i] * (1 + sign * step), *base[i + 1:]] for i in range(len(base)) for step in STEPS for sign in (1, -1)]
        yield [base, *moved]


def values_of(folder, text, quantity, groups):
    """Return what the compiled function gives for the arguments, or None if it does not end."""
    source, numbers = folder / "own.c", [own for group in groups for own in group]
    if not numbers:
        return iter(())
    width = len(numbers[0])
    (folder / "places.txt").write_text("\n".join(" ".join(map(repr, own)) for own in numbers))
    arguments = ", ".join(f"v[{i}]" for i in range(width))
    source.write_text(text + f"""
#include <stdio.h>
int main(void)
{{
    double v[{width}];
    for (;;) {{
        for (int i = 0; i < {width}; i++) {{
            if (scanf("%lf", &v[i]) != 1) {{ return 0; }}
        }}
        printf("%.17g\\n", sneddon_{quantity}({arguments}));
    }}
}}
""")
    compiler = ["cc", "-O1", "-ffp-contract=off", source, "-lgsl", "-lgslcblas", "-lm", "-o", folder / "own"]
    subprocess.run(compiler, check=True, capture_output=True)
    try:
        with (folder / "places.txt").open() as places:
            out = subprocess.run([folder / "own"], stdin=places, capture_output=True, text=True, timeout=SECONDS).stdout
    except subprocess.TimeoutExpired:
        return None
    return iter(map(float, out.split()))


def condition_number(own, moved):
    """Return 1 + sum |v df/dv|/|f| from the values next to `own`: at the crest of a wave those on both sides are equal."""
    pairs = list(zip(moved[::2], moved[1::2]))
    slopes = [max(abs(more - own), abs(less - own)) / step for step, (more, less) in zip(STEPS * (len(pairs) // len(STEPS)), pairs)]
    largest = [max(slopes[i:i + len(STEPS)]) for i in range(0, len(slopes), len(STEPS))]
    return 1 + sum(largest) / abs(own) if own else 1


def attack(program, profile, folder, count, radii_of):
    """Compare the functions of one profile; `radii_of` gives the radii from the range of the claim."""
    for quantity in ("g", "F", "p", "a", "F_of_d"):
        command = [program, "code", profile.text, "--lang", "c", "--quantity", quantity]
        written = subprocess.run(command, capture_output=True, text=True)
        if written.returncode != 0:
            count["refused"] += 1
            continue
        text = written.stdout
        claim = re.findall(r"at most ([\d.e+]+) ulp( times)?[^.]* from ([\d.e+-]+) to ([\d.e+-]*)", re.sub(r"\n// ", " ", text))[-1]
        radii, radius = radii_of(float(claim[2]), float(claim[3]) if claim[3] else None)
        places = radii if quantity in "gF" else [own for own in radii if own < radius]
        if quantity in ("a", "F_of_d"):
            places = [own["value"] for own in evaluated(program, profile, "g", radii, radius) if own["value"] > 0]
        found = evaluated(program, profile, quantity, places, radius) if places else []
        groups = list(calls(text, profile, quantity, found, radius))
        count["functions"] += 1
        values = values_of(folder, text, quantity, groups)

        def fault(what):
            count["faults"] += 1
            print(f"{what}: {quantity} of {profile.text} {profile.values}", flush=True)

        if values is None:
            fault("no end")
            continue
        for point, group in zip(found, groups):
            own, *moved = [next(values) for _ in group]
            true = point["value"]
            if true == 0:
                continue
            count["values"] += 1
            condition = condition_number(own, moved)
            allowed = float(claim[0]) * (1.01 * condition if claim[1] else 1) * math.ulp(true) + point["error_estimate"]
            # Next to the greatest depth that a profile reaches, its neighbour has no radius.
            if math.isnan(allowed):
                count["without a condition number"] += 1
            elif not abs(own - true) <= allowed:
                fault(f"{own!r} at {point['at']!r}, not {true!r} within {allowed:.1e}")


def typed(program, first, number, folder, count):
    """Attack typed profiles."""
    for seed in range(first, first + number):
        profile = shapes.typed(seed)
        radius = max(profile.places)
        attack(program, profile, folder, count, lambda *_: ([radius * own for own in FACTORS] + profile.places, radius))


def catalogue(program, number, folder, count):
    """Attack the catalogue at many places, whose logarithms are uniform; the pressures at the middle of the range."""
    for entry in json.loads(PROFILES.read_text()):
        profile = SimpleNamespace(text=entry["f"], values={name: float(own) for name, own in entry["params"].items()}, places=[])
        chance = random.Random(entry["id"])

        def radii(least, most):
            end = most or 1e12 * least
            places = [least * (end / least) ** chance.random() for _ in range(number)]
            return places, math.sqrt(least * end)

        attack(program, profile, folder, count, radii)


def main():
    program, what, *numbers = sys.argv[1:]
    count = Counter()
    with tempfile.TemporaryDirectory() as folder:
        {"typed": typed, "catalogue": catalogue}[what](program, *map(int, numbers), pathlib.Path(folder), count)
    print(f"{what} {' '.join(numbers)}: {dict(sorted(count.items()))}")


if __name__ == "__main__":
    main()
