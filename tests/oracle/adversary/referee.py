"""Holds `validate` to runs of the solver in solver.py, good ones and ones with a fault: python3 referee.py PROGRAM [--seed SEED] [--runs RUNS].

Every run has another shape, box and place of the axis, on 64 or 128 pixels along a side.
Good data must pass as fields and as loads, with a grid and without; data with a fault must not, and the fault should be named.
"""
import argparse
import json
import os
import random
import subprocess
import tempfile
from collections import Counter
import numpy as np
from solver import Solver

# Name, f(r), the same as text, parameters; the contact radius at the largest load is about 1.
SHAPES = [
    ("paraboloid", lambda r: r**2 / 20, "r^2/(2*R)", "R = 10"),
    ("cone", lambda r: 0.2 * r, "s*r", "s = 0.2"),
    ("sphere", lambda r: 2.5 - np.sqrt(np.maximum(6.25 - r**2, 0)), "R-sqrt(R^2-r^2)", "R = 2.5"),
    ("truncated cone", lambda r: np.maximum(0, 0.2 * (r - 0.4)), "max(0,s*(r-b))", "b = 0.4, s = 0.2"),
    ("wide truncated cone", lambda r: np.maximum(0, 0.2 * (r - 0.6)), "max(0,s*(r-b))", "b = 0.6, s = 0.2"),
    ("worn paraboloid", lambda r: np.maximum(0, (r**2 - 0.16) / 20), "max(0,(r^2-b^2)/(2*R))", "b = 0.4, R = 10"),
    ("capped cone", lambda r: np.where(r < 0.4, r**2 / 8, 0.02 + 0.1 * (r - 0.4)), "piecewise(r^2/(2*R),r<b,b^2/(2*R)+(r-b)*b/R)", "b = 0.4, R = 4"),
    ("quartic", lambda r: 0.05 * r**4, "C*r^4", "C = 0.05"),
    ("Gaussian", lambda r: 0.1 * (1 - np.exp(-(r**2) / 4)), "h*(1-exp(-r^2/w^2))", "h = 0.1, w = 2"),
    ("waves", lambda r: r**2 / 20 + 0.001 * (1 - np.cos(5 * r)), "r^2/(2*R)+h*(1-cos(k*r))", "R = 10, h = 0.001, k = 5"),
    ("rounded punch", lambda r: np.maximum(0, r - 0.5) ** 2 / 4, "max(0,r-b)^2/(2*R)", "b = 0.5, R = 2"),
    ("flat punch", lambda r: np.where(r <= 1, 0, np.inf), None, ""),
]


def scene(text, parameters):
    """Returns a scene without a load; E* = 1."""
    profile = 'f = "0"\nradius = 1\n' if text is None else f'f = "{text}"\nparameters = {{ {parameters} }}\n'
    return f"[profile]\n{profile}[material]\nE = 1\nnu = 0\n"


def field_faults(p, r, h):
    """Yields names and fields with one fault each."""
    lone = p.copy()
    lone[tuple(np.argwhere((r > 0.65) & (r < 0.75))[3])] *= 1.3
    for factor in (1.05, 1.02, 1.01):
        yield f"p times {factor}", factor * p
    yield "p shifted by a pixel", np.roll(p, 1, 1)
    yield "p shifted by two pixels", np.roll(p, (2, 1), (0, 1))
    yield "sign of p", -p
    yield "half of p", p / 2
    yield "p in other units", 1e3 * p
    yield "one pixel", lone
    yield "p cut off", np.minimum(p, 0.97 * np.quantile(p[r < 0.9], 0.9))
    yield "order of a Fourier transform", np.fft.fftshift(p)
    yield "force per pixel", p * h * h
    yield "p lost at the edge", np.where(r > 1 - 2.5 * h, 0, p)


def load_faults(rows):
    """Yields names and rows d, F, a with one fault each."""
    def times(column, factor, row=slice(None)):
        changed = rows.copy()
        changed[row, column] *= factor
        return changed

    for factor in (1.05, 1.02, 1.005, 0.91):
        yield f"F times {factor}", times(1, factor)
    yield "one F times 1.5", times(1, 1.5, 3)
    yield "one F times 1.05", times(1, 1.05, 6)
    yield "first F times 1.3", times(1, 1.3, 0)
    yield "diameters", times(2, 2)
    yield "sign of F", times(1, -1)
    yield "depths too large", rows + [0.03 * rows[-1, 0], 0, 0]
    yield "rows one load off", np.column_stack([rows[:-1, 0], rows[1:, 1:]])
    yield "columns exchanged", rows[:, [1, 0, 2]]


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("program")
    parser.add_argument("--seed", type=int, default=0)
    parser.add_argument("--runs", type=int, default=36)
    given = parser.parse_args()
    program, random_number = os.path.abspath(given.program), random.Random(given.seed)
    os.chdir(tempfile.mkdtemp())
    good, alarms, faults, passed, named = 0, [], Counter(), [], Counter()

    def validate(kind, *data):
        done = subprocess.run([program, "validate", f"{kind}.toml", *data, "--json"], capture_output=True, text=True)
        if done.returncode > 1:
            raise RuntimeError(done.stderr)
        return done.returncode == 0, json.loads(done.stdout)

    for run in range(given.runs):
        name, shape, text, parameters = SHAPES[run % len(SHAPES)]
        n, side, axis = 64 if run % 3 else 128, random_number.uniform(2.4, 3.6), random_number.choice([0.0, 0.5])
        solver = Solver(n, side, axis)
        own = scene(text, parameters)
        depth = 0.05
        if text is not None:
            with open("known.toml", "w") as file:
                file.write(own + "[load]\ncontact_radius = 1\n")
            answer = subprocess.run([program, "solve", "known.toml", "--json"], capture_output=True, text=True, check=True)
            depth = json.loads(answer.stdout)["rows"][0]["d"]
        rows, p = [], None
        for d in depth * np.geomspace(0.05, 1, 10):
            p = solver.pressures(shape(solver.r), d, p)
            rows.append([d, p.sum() * solver.h**2, np.sqrt((p > 0).sum() * solver.h**2 / np.pi)])
        rows = np.array(rows)
        with open("field.toml", "w") as file:
            file.write(own + f"[load]\ndepth = {float(rows[-1, 0])!r}\n")
        with open("loads.toml", "w") as file:
            file.write(own)
        grid = ["--grid", str(n), "--box", repr(side)]

        def judged(fault, kind, values, arguments):
            if kind == "field":
                np.savez("field.npz", p=values, x=solver.x, y=solver.x)
                return validate(kind, "field.npz", *arguments)
            np.savetxt("loads.csv", values, delimiter=",", header="d,F,a", comments="", fmt="%.17g")
            return validate(kind, "loads.csv", *arguments)

        for kind, values in (("field", p), ("loads", rows)):
            for arguments in (grid, []):
                good += 1
                fine, document = judged(None, kind, values, arguments)
                if not fine:
                    alarms.append(f"{name}, {n}, {kind}, {arguments}: {document['reason']}")
                    print(alarms[-1])
        for kind, cases in (("field", field_faults(p, solver.r, solver.h)), ("loads", load_faults(rows))):
            for fault, values in cases:
                faults[fault] += 1
                fine, document = judged(fault, kind, values, grid)
                if fine:
                    passed.append(f"{name}, {n}: {fault}")
                named[fault] += document["suspicion"] is not None
        print(f"{run + 1} runs: {len(alarms)} of {good} good data failed, {len(passed)} of {sum(faults.values())} faults passed, {sum(named.values())} named", flush=True)
    for fault, count in faults.items():
        print(f"{fault}: {named[fault]} of {count} named")
    print(*passed, sep="\n")


main()
