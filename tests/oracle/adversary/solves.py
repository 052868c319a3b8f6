"""Solves one load of each typed profile: python3 solves.py PROGRAM FIRST COUNT.

The depth is g at the second of the profile's places, so that this place is a contact radius where it is the first one of that depth.
Loads without an answer, other radii, calls above one second of processor time and their verdicts are printed, and counted at the end.
"""
import argparse
import json
import os
import tempfile
from collections import Counter

import shapes
from attack import run


def scene(profile, depth, reach):
    parameters = ", ".join(f"{name} = {value!r}" for name, value in profile.values.items())
    return f"""[profile]
f = {json.dumps(profile.text)}
parameters = {{ {parameters} }}
[material]
effective_modulus = 1.0
[load]
depth = {depth!r}
[outputs]
quantities = ["d", "F", "a", "p", "u"]
at = {{ start = 0.0, stop = {reach!r}, count = 7 }}
"""


def main():
    reader = argparse.ArgumentParser()
    reader.add_argument("program")
    reader.add_argument("first", type=int)
    reader.add_argument("count", type=int)
    given = reader.parse_args()
    counts = Counter()
    path = os.path.join(tempfile.mkdtemp(), "scene.toml")
    for seed in range(given.first, given.first + given.count):
        profile = shapes.typed(seed)
        place = sorted(profile.places)[1]
        sets = shapes.settings(profile)
        _, out, _, _ = run([given.program, "eval", profile.text, "--quantity", "g", "--at", repr(place), "--json", *sets])
        depth = json.loads(out)["points"][0].get("value") if out.strip() else None
        if not depth or depth <= 0:
            counts["no depth at the place"] += 1
            continue
        with open(path, "w", encoding="utf-8") as file:
            file.write(scene(profile, depth, 1.5 * place))
        code, out, err, seconds = run([given.program, "solve", path, "--json"])
        answer = json.loads(out) if out.strip() else {"why": err.strip()[:120] or "no end"}
        row = answer.get("rows", [answer])[0]
        counts["profiles"] += 1
        if row.get("a") is None:
            unfinished = code is None or "budget" in row.get("why", "")
            kind = "unfinished" if unfinished else "not valid"
        else:
            kind = "valid" if abs(row["a"] - place) <= 1e-6 * place else "another radius"
        counts[kind] += 1
        counts["above 1 s"] += seconds > 1
        counts["above 5 s"] += seconds > 5
        if seconds > 1 or kind in ("unfinished", "another radius"):
            print(f"{seed}: {kind}, {seconds:.2f} s, {profile.text!r} {profile.values} d = {depth!r}: {row.get('a')} {row.get('why') or ''}", flush=True)
    print(dict(counts))


if __name__ == "__main__":
    main()
