"""Typed profiles as Python functions, against their formulas: python3 functions.py FIRST COUNT, where the package `sneddon` is installed.

Both go into `sneddon.Contact`; d, F and p of the function must agree with those of the formula within both bounds.
"""
import math
import re
import sys
import time
from collections import Counter
import shapes
import sneddon

# The places of kinks are not told, as nobody tells them who writes a function.
NAMES = {
    "ln": math.log, "log": math.log, "abs": abs, "min": min, "max": max, "pi": math.pi, "e": math.e,
    "sech": lambda z: 1 / math.cosh(z), "coth": lambda z: 1 / math.tanh(z),
    "arsinh": math.asinh, "artanh": math.atanh, "arcosh": math.acosh, "arctan": math.atan, "arcsin": math.asin, "arccos": math.acos,
}


def function_of(text, values):
    """Return a Python function of r for a formula, or None for a formula with something that Python lacks."""
    spelled = re.sub(r"(?<=\d)²|²", "**2", text).replace("³", "**3").replace("·", "*").replace("^", "**").replace("π", "pi")
    scope = {**{own: getattr(math, own) for own in dir(math) if not own.startswith("_")}, **NAMES, **{key: float(own) for key, own in values.items()}}
    try:
        function = eval(f"lambda r: {spelled}", scope)
        for r in (0.1, 0.3):
            float(function(r))
    except Exception:
        return None
    return function


def main():
    first, count = int(sys.argv[1]), int(sys.argv[2])
    tally, slowest = Counter(), (0.0, "")
    for seed in range(first, first + count):
        profile = shapes.typed(seed)
        function = function_of(profile.text, profile.values)
        if function is None:
            tally["without a function"] += 1
            continue
        try:
            truth = sneddon.Contact(sneddon.Profile(profile.text), E_star=1.0, **{key: float(own) for key, own in profile.values.items()})
        except sneddon.SneddonError:
            tally["refused formulas"] += 1
            continue
        began = time.process_time()

        def attempt(call, what):
            """Return the result of a call, or None after counting its exception."""
            try:
                return call()
            except Exception as error:
                kind = "refused" if isinstance(error, sneddon.SneddonError) else "raised"
                tally[kind] += 1
                print(f"{kind} {what} {seed} {profile.text} {profile.values}: {error!r}")

        own = attempt(lambda: sneddon.Contact(sneddon.Profile(function), E_star=1.0), "function")
        if own is None:
            continue
        for a in (0.05, 0.3, 1.0):
            for key, call in (("d", lambda it: it.depth(radius=a, with_bound=True)), ("F", lambda it: it.force(radius=a, with_bound=True)),
                              ("p", lambda it: it.pressure(0.6 * a, radius=a, with_bound=True))):
                try:
                    expected, bound = call(truth)
                except sneddon.SneddonError:
                    tally["without a reference"] += 1
                    continue
                found = attempt(lambda: call(own), f"{key}({a})")
                if found is None:
                    continue
                value, own_bound = found
                tally["values"] += 1
                if math.isinf(expected) or math.isinf(value):
                    tally["infinite"] += 1
                elif value == 0 and abs(expected) < 1e-16:
                    tally["below the rounding of the function"] += 1
                elif abs(value - expected) > bound + own_bound:
                    tally["beyond"] += 1
                    print(f"beyond {key}({a}) {seed} {profile.text} {profile.values}: {value} ± {own_bound}, the formula has {expected} ± {bound}")
                elif own_bound > 1e-6 * abs(expected):
                    tally["bound above 1e-6"] += 1
        spent = time.process_time() - began
        slowest = max(slowest, (spent, f"{seed} {profile.text}"))
        if (seed - first + 1) % 100 == 0:
            print(f"functions {first}+{seed - first + 1}: {dict(sorted(tally.items()))}; slowest {slowest[0]:.2f} s: {slowest[1]}", flush=True)
    print(f"functions {first}+{count}: {dict(sorted(tally.items()))}; slowest {slowest[0]:.2f} s: {slowest[1]}", flush=True)


if __name__ == "__main__":
    main()
