"""Attacks the program with generated profiles: python3 attack.py PROGRAM typed|hidden|kinks|roots FIRST COUNT [--out FILE] [--no-formulas] [--table CSV] [--references FILE].

Every number of g, d, F and p at three places is compared with an enclosure of the true value; printed formulas are evaluated by mpmath.
Faults are written as JSON lines; the summary is printed at the end and every 200 profiles.
References take most of the time: with --references they are stored, and later runs of the same profiles read them.
Use a new file after a change of shapes.py or truth.py.
"""
import argparse
import json
import os
import pickle
import random
import resource
import sqlite3
import subprocess
import sys
import time
import traceback
from collections import Counter
import flint
import formulas
import mpmath
import shapes
from truth import NoTruth, Truth, acb, arb

# The largest number of digits with which a printed formula is evaluated; terms that are larger than their sum by more lose all of them.
MOST_DIGITS = 120
# Seconds of processor time after which a profile counts as one without a reference.
PATIENCE = 60


def run(command, limit=12):
    """Runs a command that may take `limit` seconds of processor time."""
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    try:
        lid = lambda: resource.setrlimit(resource.RLIMIT_CPU, (limit, limit))
        done = subprocess.run(command, capture_output=True, text=True, timeout=30 * limit, preexec_fn=lid)
        code, out, err = done.returncode, done.stdout, done.stderr
        if code in (-24, -9):
            code, err = None, "hang"
    except subprocess.TimeoutExpired:
        code, out, err = None, "", "hang"
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    return code, out, err, after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime


class References:
    """True values of profiles, stored in a file for later runs."""

    def __init__(self, path):
        self.path = path
        with sqlite3.connect(path) as file:
            file.execute("CREATE TABLE IF NOT EXISTS known (profile TEXT PRIMARY KEY, found BLOB)")

    def of(self, profile, seed, find):
        """Return the stored references of a profile, or compute and store them with `find`; None if there are none."""
        key = repr((seed, profile.text, profile.values, profile.places))
        with sqlite3.connect(self.path, timeout=600) as file:
            row = file.execute("SELECT found FROM known WHERE profile = ?", (key,)).fetchone()
        if row is not None:
            kept = pickle.loads(row[0])
            return kept and (kept[0], kept[1], {name: arb(middle, radius) for name, (middle, radius) in kept[2].items()})
        found = find()
        # 80 digits are more than any reference has; the cut is part of the radius.
        text = lambda own: (own.mid().str(80, radius=False), (own.rad() + abs(own) * arb("1e-78")).upper().str(8, radius=False))
        kept = found and (found[0], found[1], {name: text(own) for name, own in found[2].items()})
        with sqlite3.connect(self.path, timeout=600) as file:
            file.execute("INSERT OR REPLACE INTO known VALUES (?, ?)", (key, pickle.dumps(kept)))
        return found


class Attack:
    def __init__(self, program, out):
        self.program, self.out, self.count, self.slowest = program, out, Counter(), (0.0, None)
        self.refusals, self.table, self.references, self.start = Counter(), None, None, time.time()

    def report(self, kind, seed, profile, **more):
        self.count[kind] += 1
        self.out.write(json.dumps({"kind": kind, "seed": seed, "profile": profile.text, "set": profile.values, **more}) + "\n")
        self.out.flush()

    def call(self, seed, profile, command):
        code, out, err, seconds = run(command)
        shown = " ".join(f"'{part}'" if set(part) & set("()^* ") else part for part in ["sneddon", *command[1:]])
        if seconds > self.slowest[0]:
            self.slowest = (seconds, shown)
        if code is None or seconds > 5:
            self.report("slow", seed, profile, command=shown, seconds=seconds)
        if code not in (None, 0, 1, 2) or "panicked" in err:
            self.report("crash", seed, profile, command=shown, code=code, stderr=err[:400])
        return code, out, err, shown

    def apart(self, seed, profile, printed):
        """Attacks with one profile in a process of its own, because an enclosure may take hours and listens to no signal."""
        reading, writing = os.pipe()
        self.out.flush()
        child = os.fork()
        if child == 0:
            resource.setrlimit(resource.RLIMIT_CPU, (PATIENCE, PATIENCE))
            self.count, self.refusals = Counter(), Counter()
            try:
                self.profile(seed, profile, printed)
                self.out.flush()
                if self.table is not None:
                    self.table.flush()
                with os.fdopen(writing, "wb") as pipe:
                    pickle.dump((self.count, self.refusals, self.slowest), pipe)
                os._exit(0)
            finally:
                # A fault of the attack itself.
                traceback.print_exc()
                os._exit(1)
        os.close(writing)
        with os.fdopen(reading, "rb") as pipe:
            found = pipe.read()
        _, status = os.waitpid(child, 0)
        if not found:
            # What such a profile reported before it ended is in the file, and not counted.
            ended = "ended for lack of time" if os.WIFSIGNALED(status) else "faults of the attack"
            self.count.update({"profiles": 1, ended: 1})
            return
        count, refusals, slowest = pickle.loads(found)
        self.count.update(count)
        self.refusals.update(refusals)
        self.slowest = max(self.slowest, slowest, key=lambda own: own[0])

    def profile(self, seed, profile, printed):
        self.count["profiles"] += 1
        bits = 700 if profile.removable else 240 if profile.marks else 140
        # References that are read from a file are as sharp as those that are computed.
        flint.ctx.prec = bits
        find = lambda: self.reference(seed, profile, bits)
        found = self.references.of(profile, seed, find) if self.references else find()
        if found is None:
            self.count["without a reference"] += 1
            return
        a, radii, values = found
        places = profile.places
        deeper = lambda key: self.again(profile, bits, key, a)
        sets = shapes.settings(profile)
        for quantity in "gdFp":
            at = radii if quantity == "p" else places
            command = [self.program, "eval", profile.text, "--quantity", quantity, "--at", ",".join(map(repr, at)), "--json", *sets]
            if quantity == "p":
                command += ["--radius", repr(a)]
            code, out, err, shown = self.call(seed, profile, command)
            if code != 0 and not out.strip():
                self.count["refused calls"] += 1
                self.refusals[err.strip().split("\n")[0][:90]] += 1
                if self.refusals.total() < 400:
                    self.out.write(json.dumps({"kind": "refused", "seed": seed, "command": shown, "why": err.strip()[:300]}) + "\n")
                continue
            for point in json.loads(out).get("points", [{"at": own, "why": "cut"} for own in at]):
                self.number(seed, profile, quantity, point, values[quantity, point["at"]], deeper, shown)
        if printed:
            self.printed(seed, profile, values, a, sets)

    def reference(self, seed, profile, bits):
        """Return the contact radius, the radii of the pressures and the true values, or None if they cannot be enclosed."""
        try:
            truth = Truth(profile.tree, profile.values, profile.end, profile.marks, profile.singular, bits)
            places = profile.places
            values = {("g", x): truth.g(x) for x in places}
            values.update({("F", x): truth.force(x) for x in places})
            for x in places:
                values["d", x] = values["g", x]
            a, chance = max(places), random.Random(seed)
            radii = sorted(a * chance.uniform(0.02, 0.98) for _ in places)
            if getattr(profile, "feature", None) and profile.places[0] < a:
                radii[0] = profile.places[0]
            radii = sorted(r for r in getattr(profile, "radii", radii) if 0 < r < a) or radii
            for r in radii:
                values["p", r] = truth.pressure(r, a)
            return a, radii, values
        except (NoTruth, ZeroDivisionError, ValueError, OverflowError, IndexError):
            return None

    def again(self, profile, bits, key, a):
        """The value once more, with twice the digits and other panels."""
        truth = Truth(profile.tree, profile.values, profile.end, profile.marks + [profile.end * 0.37], profile.singular, 2 * bits)
        quantity, at = key
        return truth.pressure(at, a) if quantity == "p" else truth.force(at) if quantity == "F" else truth.g(at)

    def number(self, seed, profile, quantity, point, true, deeper, shown):
        if point.get("value") is None:
            self.count["null"] += 1
            self.out.write(json.dumps({"kind": "null", "seed": seed, "at": point["at"], "command": shown, "why": point.get("why")}) + "\n")
            return
        self.count["numbers"] += 1
        self.count[point.get("bound", "bound not told")] += 1
        value, bound = arb(point["value"]), arb(point["error_estimate"])
        if not abs(value - true) <= bound:
            try:
                true = deeper((quantity, point["at"]))
            except NoTruth:
                self.count["without a reference"] += 1
                return
            error = abs(value - true)
            if error > bound:
                wrong = error > abs(true) * arb("1e-9")
                self.report("wrong" if wrong else "beyond bound", seed, profile, quantity=quantity, at=point["at"], printed=point["value"],
                            bound=point["error_estimate"], says=point.get("bound"), truth=true.mid().str(30, radius=False), method=point.get("method"), command=shown)
            elif not error <= bound:
                self.count["undecided"] += 1
        if not bound <= abs(true) * arb("1e-6") + arb("1e-300"):
            self.count["bound above 1e-6"] += 1
        if self.table is not None:
            radius = shown.split("--radius ")[1].split()[0] if quantity == "p" else ""
            sets = " ".join(f"{k}={v!r}" for k, v in profile.values.items())
            self.table.write(f"{profile.text};{sets};{quantity};{radius};{point['at']!r};{true.mid().str(30, radius=False)}\n")

    def printed(self, seed, profile, values, a, sets):
        code, out, err, shown = self.call(seed, profile, [self.program, "derive", profile.text, "--json"])
        if not out.strip():
            code, out, err, shown = self.call(seed, profile, [self.program, "derive", profile.text, "--json", *sets])
        if not out.strip():
            self.count["refused derivations"] += 1
            self.out.write(json.dumps({"kind": "refused", "seed": seed, "command": shown, "why": err.strip()[:300]}) + "\n")
            return
        record = json.loads(out)
        check = record.get("check") or {}
        if record.get("complete") is False:
            self.report("cut check", seed, profile, command=shown, check=check)
        elif check.get("passed") is False or code == 1:
            self.report("failed check", seed, profile, command=shown, check=check)
        self.count["check " + str(check.get("verdict", check.get("passed")))] += 1
        for quantity in "gFp":
            # A derivation that was cut short has no formulas, and a pressure may have none.
            if not record.get(quantity):
                continue
            if record[quantity]["status"] != "exact" and (quantity != "g" or seed % 8):
                continue
            for (name, at), true in values.items():
                # An enclosure without digits is no reference.
                if name != quantity or not arb(true.rad()) <= abs(true) * arb("1e-14"):
                    continue
                scope = {**profile.values, "E": 1.0, "x": at, "a": a if name == "p" else at, "r": at}
                try:
                    found = formulas.number(record[quantity]["text"], scope)
                except (formulas.NoNumber, ZeroDivisionError, ValueError, TypeError, mpmath.libmp.libhyper.NoConvergence, AttributeError, SyntaxError) as error:
                    self.count["formulas not read"] += 1
                    self.out.write(json.dumps({"kind": "not read", "seed": seed, "command": shown, "text": record[quantity]["text"], "why": f"{error}"[:100]}) + "\n")
                    continue
                self.count["formulas"] += 1
                reference = mpmath.mpf(true.mid().str(30, radius=False))
                loose = 1e-17 if "integral(" in record[quantity]["text"] else 1e-22
                wrong = lambda number: not abs(number - reference) <= 1e-13 * abs(reference) + loose
                digits = 40
                while wrong(found) and digits < MOST_DIGITS:
                    # A formula whose terms cancel needs more digits than the reader takes at first.
                    digits *= 3
                    before = found
                    try:
                        found = formulas.number(record[quantity]["text"], scope, digits)
                    except formulas.NoNumber:
                        break
                if wrong(found) and abs(found - before) > 1e-10 * abs(found):
                    self.count["formulas without digits"] += 1
                    self.out.write(json.dumps({"kind": "no digits", "seed": seed, "command": shown, "text": record[quantity]["text"], "at": at}) + "\n")
                elif wrong(found):
                    self.report("wrong formula", seed, profile, quantity=quantity, at=at, radius=a, text=record[quantity]["text"],
                                gives=mpmath.nstr(found, 20), truth=mpmath.nstr(reference, 20), command=shown)

    def summary(self, mode, first, count):
        count = dict(sorted(self.count.items()))
        proven, told = count.get("proven", 0), count.get("proven", 0) + count.get("estimated", 0)
        share = f"{100 * proven / told:.3f} %" if told else "not told"
        print(f"{mode} {first}+{self.count['profiles']}: {count}; proven {share}; slowest call {self.slowest[0]:.2f} s: {self.slowest[1]}; {time.time() - self.start:.0f} s", flush=True)
        for why, times in self.refusals.most_common(8):
            print(f"    refused {times}: {why}", flush=True)


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("program")
    parser.add_argument("mode", choices=["typed", "hidden", "kinks", "roots"])
    parser.add_argument("first", type=int)
    parser.add_argument("count", type=int)
    parser.add_argument("--out", default="/dev/null")
    parser.add_argument("--no-formulas", action="store_true")
    parser.add_argument("--table")
    parser.add_argument("--references")
    own = parser.parse_args()
    with open(own.out, "w") as out:
        attack = Attack(own.program, out)
        if own.table:
            attack.table = open(own.table, "w")
        if own.references:
            attack.references = References(own.references)
        for seed in range(own.first, own.first + own.count):
            profile = getattr(shapes, own.mode)(seed)
            attack.apart(seed, profile, own.mode in ("typed", "roots") and not own.no_formulas)
            if attack.count["profiles"] % 200 == 0:
                attack.summary(own.mode, own.first, own.count)
        attack.summary(own.mode, own.first, own.count)


if __name__ == "__main__":
    main()
