"""Sets derivations with pdfLaTeX and Typst: errors, and boxes that are wider than the column."""
import argparse
import json
import pathlib
import re
import subprocess
import tempfile

import shapes

ROOT = pathlib.Path(__file__).parents[3]


def profiles(count):
    """The catalogue, and random profiles as people type them."""
    for own in json.loads((ROOT / "tests/data/profiles.json").read_text()):
        yield own["f"]
    for seed in range(count):
        yield shapes.typed(seed).text


def widest(log):
    """By how many points the widest box is too wide."""
    return max((float(own) for own in re.findall(r"Overfull \\hbox \(([0-9.]+)pt", log)), default=0.0)


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("program")
    parser.add_argument("--random", type=int, default=100)
    asked = parser.parse_args()
    try:
        import typst
    except ImportError:
        typst = None
    set_, refused, faults = 0, 0, []
    with tempfile.TemporaryDirectory() as place:
        place = pathlib.Path(place)
        for text in profiles(asked.random):
            def derive(form, name):
                done = subprocess.run(
                    [asked.program, "derive", text, "--format", form, "--standalone", "-o", place / name],
                    capture_output=True, text=True, check=False)
                return (place / name).exists() and done.returncode in (0, 1)

            for old in place.glob("page.*"):
                old.unlink()
            if not derive("latex", "page.tex"):
                refused += 1
                continue
            subprocess.run(["pdflatex", "-interaction=batchmode", "page.tex"], cwd=place, capture_output=True, check=False)
            log = (place / "page.log").read_text(errors="replace")
            set_ += 1
            if re.search(r"^!", log, re.MULTILINE):
                faults.append((text, "LaTeX: " + re.search(r"^!.*", log, re.MULTILINE).group()))
            if widest(log) > 0:
                faults.append((text, f"LaTeX: {widest(log):.0f} pt too wide"))
            if typst and derive("typst", "page.typ"):
                try:
                    typst.compile(place / "page.typ", output=place / "typst.pdf")
                except Exception as error:
                    faults.append((text, f"Typst: {str(error)[:200]}"))
    for text, fault in faults:
        print(f"{fault}: {text}")
    print(f"{set_} documents, {refused} profiles refused, {len(faults)} faults" + ("" if typst else "; Typst was not found"))
    raise SystemExit(1 if faults else 0)


if __name__ == "__main__":
    main()
