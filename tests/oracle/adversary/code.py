"""Compares generated code with the program: python3 code.py PROGRAM typed FIRST COUNT PLACES, or python3 code.py PROGRAM catalogue PLACES.

The functions for g, F, p, d(a), a(d) and F(d) that `sneddon code` writes are compiled and called, those of typed profiles and those of the
catalogue, at random places over the whole range of their claim, whose logarithms are uniform, in C and in those of rust, fortran, python
and octave that `--lang` lists after it.
With `--scale 1e-6` the catalogue is in metres, with tips of micrometres.
A value is a fault if it is not a number, or if it differs from that of `sneddon eval` by more than its claim, times the condition number
1 + sum |v df/dv|/|f| where the claim says so, and the bound of `eval`.
Needs cc and the GNU Scientific Library, and the compilers and interpreters of the other languages.
"""
import argparse
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
SECONDS = 600
PROFILES = pathlib.Path(__file__).parents[2] / "data" / "profiles.json"
# The most places in one call of `eval`, whose list of places is one argument.
MOST = 2000
# Contact radii of a pressure.
RADII = 20

C = """
#include <stdio.h>
int main(void)
{
    double v[WIDTH];
    for (;;) {
        for (int i = 0; i < WIDTH; i++) {
            if (scanf("%lf", &v[i]) != 1) { return 0; }
        }
        printf("%.17g\\n", sneddon_NAME(ARGUMENTS));
    }
}
"""
RUST = """
fn main() {
    for line in std::io::stdin().lines() {
        let v: Vec<f64> = line.unwrap().split(' ').map(|own| own.parse().unwrap()).collect();
        println!("{:?}", sneddon_NAME(ARGUMENTS).unwrap_or(f64::NAN));
    }
}
"""
FORTRAN = """
program main
    use sneddon
    implicit none
    double precision :: v(WIDTH)
    integer :: state
    do
        read (*, *, iostat=state) v
        if (state /= 0) exit
        print '(es26.17e3)', sneddon_NAME(ARGUMENTS)
    end do
end program main
"""
PYTHON = """
import sys
for line in sys.stdin:
    try:
        print(repr(NAME(*map(float, line.split()))))
    except ValueError:
        print("nan")
"""
OCTAVE = """
v = load("places.txt");
for i = 1:rows(v)
    printf("%.17g\\n", sneddon_NAME(ARGUMENTS));
end
"""
# Name for `--lang`; ending; what follows the functions; compiler, if any; what runs it; the first argument and what separates them.
LANGUAGES = {
    "c": ("c", C, "cc -O1 -ffp-contract=off own.c -lgsl -lgslcblas -lm -o own", "./own", "v[{}]", 0),
    "rust": ("rs", RUST, "rustc -O --cap-lints allow own.rs -o own", "./own", "v[{}]", 0),
    "fortran": ("f90", FORTRAN, "gfortran -O1 -ffp-contract=off own.f90 -o own", "./own", "v({})", 1),
    "python": ("py", PYTHON, None, f"{sys.executable} own.py", None, 0),
    "octave": ("m", OCTAVE, None, "octave --quiet own.m", "v(i, {})", 1),
}


def written(program, profile, quantity, language):
    """Return the text in a language and its claim: ulps, whether they count times the condition number, first and last radius."""
    name = "matlab" if language == "octave" else language
    done = subprocess.run([program, "code", profile.text, "--lang", name, "--quantity", quantity], capture_output=True, text=True)
    if done.returncode != 0:
        return None, None
    line = re.sub(r"\n *(?://+|#|!|%)+ *", " ", done.stdout)
    ulps, times, first, last = re.findall(r"at most ([\d.e+]+) ulp( times)?[^.]* from ([\d.e+-]+) to ([\d.e+-]*)", line)[-1]
    return done.stdout, (float(ulps), bool(times), float(first), float(last) if last else None)


def evaluated(program, profile, quantity, places, radius):
    """Return what `eval` says of the places."""
    more = ["--radius", repr(radius)] if quantity == "p" else []
    found = []
    for first in range(0, len(places), MOST):
        at = ",".join(map(repr, places[first:first + MOST]))
        command = [program, "eval", profile.text, "--quantity", quantity, "--at", at, "--json", *more]
        out = subprocess.run(command + shapes.settings(profile), capture_output=True, text=True).stdout
        found += json.loads(out).get("points", []) if out.strip() else []
    return [{**own, "radius": radius} for own in found if own.get("value") is not None]


def names_of(text, quantity):
    """Return the arguments of the C function as symbols of the formula."""
    names = re.search(rf"^double sneddon_{quantity}\(([^)]*)\)", text, re.M).group(1).replace("double ", "").split(", ")
    renamed = re.search(r"^// Names: (.*)\.$", text, re.M)
    symbols = dict(own.split(" is ") for own in renamed.group(1).split(", ")) if renamed else {}
    return [symbols.get(own, own) for own in names]


def arguments(names, profile, quantity, point):
    """Return the arguments of the call at a point."""
    known = {"E": 1.0, "a": point["radius"]} if quantity == "p" else {"E": 1.0}
    return [point["at"] if i == 0 else known.get(own) or float(profile.values[own]) for i, own in enumerate(names)]


def neighbours(base):
    """Return the arguments next to `base`."""
    return [[*base[:i], base[i] * (1 + sign * step), *base[i + 1:]] for i in range(len(base)) for step in STEPS for sign in (1, -1)]


def values_of(folder, language, text, quantity, calls):
    """Return what the function gives for the arguments of each call, or None if it does not end."""
    ending, after, compiler, run, argument, first = LANGUAGES[language]
    if not calls:
        return []
    width = len(calls[0])
    (folder / "places.txt").write_text("\n".join(" ".join(map(repr, own)) for own in calls) + "\n")
    listed = ", ".join(argument.format(i + first) for i in range(width)) if argument else ""
    after = after.replace("WIDTH", str(width)).replace("NAME", quantity).replace("ARGUMENTS", listed)
    # A file of Octave that begins with a function is called by the name of that function.
    (folder / f"own.{ending}").write_text(("1;\n" if language == "octave" else "") + text + after)
    if compiler:
        subprocess.run(compiler.split(), check=True, capture_output=True, cwd=folder)
    try:
        with (folder / "places.txt").open() as places:
            done = subprocess.run(run.split(), stdin=places, capture_output=True, text=True, timeout=SECONDS, cwd=folder)
    except subprocess.TimeoutExpired:
        return None
    values = list(map(float, done.stdout.split()))
    if len(values) != len(calls):
        raise RuntimeError(f"{language}: {len(values)} values of {len(calls)}: {done.stderr}")
    return values


def condition_number(own, moved):
    """Return 1 + sum |v df/dv|/|f| from the values next to `own`: at the crest of a wave those on both sides are equal."""
    pairs = list(zip(moved[::2], moved[1::2]))
    slopes = [max(abs(more - own), abs(less - own)) / step for step, (more, less) in zip(STEPS * (len(pairs) // len(STEPS)), pairs)]
    largest = [max(slopes[i:i + len(STEPS)]) for i in range(0, len(slopes), len(STEPS))]
    return 1 + sum(largest) / abs(own) if own else 1


def points_of(program, profile, quantity, number, claim, chance, scale):
    """Return what `eval` says at random places in the range of a claim."""
    _, _, first, last = claim
    first, last = scale * first, scale * (last or 1e12 * first)

    def drawn(number, most=last):
        return [first * (most / first) ** chance.random() for _ in range(number)]

    if quantity == "p":
        groups = [(radius, drawn(-(-number // RADII), radius)) for radius in drawn(min(RADII, number))]
        return [own for radius, places in groups for own in evaluated(program, profile, "p", places, radius)]
    places = drawn(number)
    if quantity in ("a", "F_of_d"):
        places = [own["value"] for own in evaluated(program, profile, "g", places, None) if own["value"] > 0]
    return evaluated(program, profile, "g" if quantity == "d" else quantity, places, None)


def attack(program, profile, folder, options, count, chance):
    """Compare the functions of one profile."""
    for quantity in ("g", "F", "p", "d", "a", "F_of_d"):
        text, claim = written(program, profile, quantity, "c")
        if text is None:
            count["refused"] += 1
            continue
        found = points_of(program, profile, quantity, options.places, claim, chance, options.scale)
        names = names_of(text, quantity)
        calls = [arguments(names, profile, quantity, point) for point in found]
        conditions = None
        for language in ["c", *options.lang]:
            text, claim = written(program, profile, quantity, language)
            if text is None:
                count[f"{language}: refused"] += 1
                continue

            def fault(what):
                count[f"{language}: faults"] += 1
                print(f"{language}: {what}: {quantity} of {profile.text} {profile.values}", flush=True)

            count[f"{language}: functions"] += 1
            values = values_of(folder, language, text, quantity, calls)
            if values is None:
                fault("no end")
                continue
            if conditions is None:
                near = values_of(folder, "c", text, quantity, [own for base in calls for own in neighbours(base)])
                width = len(near) // len(values) if values else 0
                conditions = [condition_number(own, near[width * i:width * (i + 1)]) for i, own in enumerate(values)]
            judge(values, found, conditions, claim, fault, count, language)


def in_unit(program, profile, scale):
    """Return the profile with its lengths in a unit that is `scale` long, or None if a model for nanite has no units for them."""
    model = subprocess.run([program, "code", profile.text, "--lang", "nanite"], capture_output=True, text=True).stdout
    found = {name: re.search(rf"^parameter_{name} = (.*)$", model, re.M) for name in ("keys", "units")}
    if not all(found.values()):
        return None
    units = dict(zip(*(json.loads(own.group(1)) for own in found.values())))
    if any(units.get(name, "SI") == "SI" for name in profile.values):
        return None
    exponents = {name: {"": 0.0, "rad": 0.0, "m": 1.0}.get(units[name]) for name in profile.values}
    exponents = {name: float(units[name][2:]) if own is None else own for name, own in exponents.items()}
    return SimpleNamespace(text=profile.text, values={name: own * scale ** exponents[name] for name, own in profile.values.items()})


def judge(values, found, conditions, claim, fault, count, language):
    """Compare the values of a function with those of `eval`."""
    ulps, times, *_ = claim
    largest = 0.0
    for own, point, condition in zip(values, found, conditions):
        true = point["value"]
        if true == 0:
            continue
        count[f"{language}: values"] += 1
        claimed = ulps * (1.01 * condition if times else 1) * math.ulp(true)
        # Next to the greatest depth that a profile reaches, its neighbour has no radius.
        if math.isnan(claimed):
            count["without a condition number"] += 1
        elif not abs(own - true) <= claimed + point["error_estimate"]:
            fault(f"{own!r} at {point['at']!r}, not {true!r} within {claimed + point['error_estimate']:.1e}")
        else:
            largest = max(largest, (abs(own - true) - point["error_estimate"]) / claimed)
    count[f"{language}: functions with an error above a quarter of the claim"] += largest > 0.25


def main():
    parser = argparse.ArgumentParser(usage="code.py PROGRAM catalogue PLACES | typed FIRST COUNT PLACES  [--lang LANGUAGES] [--scale LENGTH]")
    parser.add_argument("program")
    parser.add_argument("what", choices=["typed", "catalogue"])
    parser.add_argument("numbers", type=int, nargs="+")
    parser.add_argument("--lang", type=lambda own: own.split(","), default=[])
    parser.add_argument("--scale", type=float, default=1.0)
    options = parser.parse_intermixed_args()
    options.places = options.numbers[-1]
    if options.what == "typed":
        first, number, _ = options.numbers
        profiles = [shapes.typed(seed) for seed in range(first, first + number)]
    else:
        entries = json.loads(PROFILES.read_text())
        profiles = [SimpleNamespace(text=own["f"], values={name: float(v) for name, v in own["params"].items()}) for own in entries]
        if options.scale != 1.0:
            profiles = [own for own in (in_unit(options.program, profile, options.scale) for profile in profiles) if own]
    count = Counter()
    with tempfile.TemporaryDirectory() as folder:
        for profile in profiles:
            chance = random.Random(profile.text)
            attack(options.program, profile, pathlib.Path(folder), options, count, chance)
    print(f"{options.what} {' '.join(map(str, options.numbers))}: {dict(sorted(count.items()))}")


if __name__ == "__main__":
    main()
