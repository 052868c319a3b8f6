"""Hertz contact and the flat punch of ContactMechanics' tests, judged by `sneddon validate`.

    python hertz.py run             # solves everything, writes runs/
    python hertz.py judge           # validates it, exit code 1 if a verdict is wrong (-v: with reasons)

The program is taken from the variable SNEDDON, or else from the PATH.
Parameters are those of test_hertz.py and test_flat_punch.py; eleven mutants change
the input or the output of the solver as a bug would.
"""

import json
import os
import subprocess
import sys
from pathlib import Path

import numpy as np

RUNS = Path("runs")
GRIDS = [64, 128, 256]
KINDS = {"forces": "forces.csv", "field": "p.npy"}
TIGHT = {"pentol": 1e-8, "forcetol": 1e-8}  # solver's error well below that of the grid


class Sphere:
    name, radius, modulus, side = "sphere", 20.0, 102.0, 5.0
    depths = np.linspace(0.03, 0.1, 8)

    @staticmethod
    def surface(n, radius):
        from SurfaceTopography import make_sphere

        return make_sphere(radius, (n, n), (Sphere.side, Sphere.side))


class Punch:
    name, radius, modulus, side = "punch", 20.0, 3.56, 50.0
    depths = np.array([0.025, 0.05, 0.075, 0.1])

    @staticmethod
    def surface(n, radius):
        from SurfaceTopography import Topography

        x = (np.arange(n) - n // 2) * (Punch.side / n)
        outside = x[:, None] ** 2 + x**2 > radius**2
        return Topography(np.ma.masked_where(outside, np.zeros((n, n))), (Punch.side, Punch.side))


CONTACTS = [Sphere, Punch]


def same(value):
    return value


def shift(p):
    return np.roll(p, 1, axis=1)


def clip(p):
    return np.minimum(p, 0.98 * p.max())


def one_pixel(p):
    p = p.copy()
    n = len(p)
    p[n // 2, n // 2 + n // 8] *= 1.02  # about halfway to the edge
    return p


# Factor of E, factor of R, periodic box, change of F, change of p.
MUTANTS = {
    "good": (1, 1, False, same, same),
    "E 1 %": (1.01, 1, False, same, same),
    "E 0.5 %": (1.005, 1, False, same, same),
    "E 0.1 %": (1.001, 1, False, same, same),
    "R 1 %": (1, 1.01, False, same, same),
    "R 0.2 %": (1, 1.002, False, same, same),
    "F 0.5 %": (1, 1, False, lambda f: 1.005 * f, same),
    "shift": (1, 1, False, same, shift),
    "periodic": (1, 1, True, same, same),
    "clipped": (1, 1, False, same, clip),
    "one pixel": (1, 1, False, same, one_pixel),
    "p 0.3 %": (1, 1, False, same, lambda p: 1.003 * p),
}


def solve(contact, n, depth, modulus, radius, periodic):
    """Pressures on n by n pixels at a depth."""
    from ContactMechanics import FreeFFTElasticHalfSpace, PeriodicFFTElasticHalfSpace
    from ContactMechanics.Systems import NonSmoothContactSystem

    half_space = PeriodicFFTElasticHalfSpace if periodic else FreeFFTElasticHalfSpace
    substrate = half_space((n, n), modulus, (contact.side, contact.side))
    system = NonSmoothContactSystem(substrate, contact.surface(n, radius))
    result = system.minimize_proxy(offset=depth, **TIGHT)
    assert result.success, (contact.name, n, depth)
    return np.asarray(result.jac)[:n, :n] * (n / contact.side) ** 2


def folder(mutant):
    return RUNS / mutant.replace(" %", "").replace(" ", "_")


def run():
    """Solves every mutant on every grid; writes tables of forces, and the field at the largest depth."""
    for contact in CONTACTS:
        for n in GRIDS:
            pixel = (contact.side / n) ** 2
            solved = {}
            for mutant, (e, r, periodic, of_force, of_pressure) in MUTANTS.items():
                folder(mutant).mkdir(parents=True, exist_ok=True)
                if (e, r, periodic) not in solved:
                    solved[e, r, periodic] = [
                        solve(contact, n, d, e * contact.modulus, r * contact.radius, periodic)
                        for d in contact.depths
                    ]
                # A field that is changed changes the forces that are summed from it.
                fields = [of_pressure(p) for p in solved[e, r, periodic]]
                rows = [
                    (d, of_force(p.sum() * pixel), (p > 0).sum() * pixel)
                    for d, p in zip(contact.depths, fields)
                ]
                name = f"{contact.name}_{n}"
                table = folder(mutant) / f"{name}_forces.csv"
                np.savetxt(table, rows, delimiter=",", header="d,F,A", comments="")
                np.save(folder(mutant) / f"{name}_p.npy", fields[-1])
            print(contact.name, n, flush=True)


def validate(contact, files, grids):
    """Exit code, name of the suspicion and first line."""
    program = os.environ.get("SNEDDON", "sneddon")
    command = [program, "validate", f"{contact.name}.toml", *map(str, files), "--json"]
    command += ["--grid", ",".join(map(str, grids))]
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    if done.returncode == 2:
        raise SystemExit(done.stderr)
    report = json.loads(done.stdout)
    details = report.get("suspicion_details") or {}
    return done.returncode, details.get("id", "no name"), report["reason"]


def judge(verbose):
    """Validates forces, fields and both; the good runs must pass and the mutants of the sphere fail."""
    sets = [(kind, grids) for kind in KINDS for grids in [[n] for n in GRIDS] + [GRIDS]]
    sets.append(("both", GRIDS))
    wrong = 0
    for contact in CONTACTS:
        print(f"\n{contact.name:10}" + "".join(f"{k} {'+'.join(map(str, g)):15}" for k, g in sets))
        for mutant in MUTANTS:
            line, code = f"{mutant:10}", 0
            for kind, grids in sets:
                kinds = KINDS.values() if kind == "both" else [KINDS[kind]]
                files = [folder(mutant) / f"{contact.name}_{n}_{end}" for end in kinds for n in grids]
                code, name, reason = validate(contact, files, grids)
                line += f"{name if code else '.':{len(kind) + 16}}"
                if verbose:
                    print(f"{mutant}, {kind} {grids}: {name}: {reason}")
            print(line)
            # The last set has everything.
            wrong += contact is Sphere and code != (mutant != "good") or mutant == "good" and code
    return wrong


if __name__ == "__main__":
    if "run" in sys.argv:
        run()
    if "judge" in sys.argv:
        sys.exit(1 if judge("-v" in sys.argv) else 0)
