#!/usr/bin/env python3
"""Regenerates every file that depends on one rule.

Run:  just rule ID      (or python3 tests/oracle/rule.py ID; needs mpmath 1.3)

It replaces the rule's rows in tests/oracle/statements.csv and tests/oracle/extremes.csv and writes docs/rules.md and docs/stability.md.
A row of extremes.csv that takes too long on this machine keeps its value, and standard error says so; with gmpy2 mpmath is faster.
The rows of other rules and the random scenes at the end of docs/stability.md are not changed.
"""
import json
import os
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
ORACLE = ROOT / "tests" / "oracle"


def output(*command, text=None):
    return subprocess.run(command, input=text, cwd=ROOT, check=True, capture_output=True, text=True).stdout


def merged(old, new, order, identifier):
    """Returns the old rows with those of one rule replaced, in the order of the catalogue; rows of shapes stay first."""
    header, *rows = old.splitlines()
    fresh = new.splitlines()[1:]
    if header.split(",")[1] == "corner":
        fresh = with_slow_rows(rows, fresh, identifier)
    rows = [row for row in rows if row.split(",")[0] != identifier] + fresh
    place = {own: index for index, own in enumerate(order)}
    rows.sort(key=lambda row: place.get(row.split(",")[0], -1))
    return "\n".join([header, *rows]) + "\n"


def with_slow_rows(rows, fresh, identifier):
    """Returns the fresh rows of a rule and, in their old positions, the old rows of cells that this run left out."""
    cell = lambda row: row.split(",")[:4]
    computed = {tuple(cell(row)): row for row in fresh}
    old = [row for row in rows if row.split(",")[0] == identifier]
    kept = [row for row in old if tuple(cell(row)) not in computed]
    if kept:
        print(f"extremes.csv: {len(kept)} rows took longer than their patience and keep their values", file=sys.stderr)
    known = [computed.pop(tuple(cell(row)), row) for row in old]
    return known + list(computed.values())


def main():
    if len(sys.argv) != 2:
        sys.exit("usage: tests/oracle/rule.py ID")
    identifier = sys.argv[1]
    subprocess.run(["cargo", "build", "--release", "--locked", "-p", "sneddon", "-p", "sneddon-runs", "--bin", "sneddon", "--bin", "stability"], cwd=ROOT, check=True)
    built = Path(os.environ.get("CARGO_TARGET_DIR", ROOT / "target")) / "release"
    program = str(built / "sneddon")
    catalogue = json.loads(output(program, "rules", "--json"))
    order = [rule["id"] for rule in catalogue["rules"]]
    if identifier not in order:
        sys.exit(f"unknown rule {identifier}; expected one of: {', '.join(order)}")
    own = json.dumps({"rules": [rule for rule in catalogue["rules"] if rule["id"] == identifier]})
    for name, arguments in (("statements", []), ("extremes", [identifier])):
        new = output(sys.executable, str(ORACLE / f"{name}.py"), *arguments, text=own)
        table = ORACLE / f"{name}.csv"
        table.write_text(merged(table.read_text(), new, order, identifier))
    (ROOT / "docs" / "rules.md").write_text(output(program, "rules", "--format", "markdown"))
    page = ROOT / "docs" / "stability.md"
    scenes = page.read_text().partition("\n## Random scenes")
    # The program reads the table that has just been written.
    page.write_text(output(str(built / "stability")).rstrip("\n") + "\n" + "".join(scenes[1:]))


main()
