"""Formulas: text, LaTeX, SymPy there and back, and values by keyword."""

from __future__ import annotations

import json
import pathlib
import pickle

import mpmath
import numpy as np
import pytest
import sympy

import sneddon

PROFILES = json.loads((pathlib.Path(__file__).parents[2] / "tests/data/profiles.json").read_text())


def values(entry):
    return {name: float(sympy.Rational(text)) if "/" in text else float(text) for name, text in entry["params"].items()}


def test_a_derivation_has_every_formula():
    found = sneddon.Profile("r^2/(2*R)").derive()
    assert (found.g.text, found.g.status, found.g.rules) == ("x^2/R", "exact", ["heß-power"])
    assert found.F_of_d is not None and found.a_of_d.text == "sqrt(R*d)"
    assert found.conditions == ["smooth edge: d = g(a)"]
    assert found.check["passed"] is True
    assert found.g._repr_latex_().startswith("$\\displaystyle g(x) = ")
    assert "align*" in found._repr_latex_()


def test_numbers_of_parameters_are_exact():
    assert sneddon.Profile("r^2/(2*R)", R=0.1).derive().g.text == "10*x^2"
    assert sneddon.Profile("r^2/(2*R)", R="1/3").derive().g.text == "3*x^2"


def test_a_punch_has_the_force_of_its_rim():
    assert sneddon.Profile("0").derive(depth="d").F.text == "2*E*a*d"


@pytest.mark.parametrize("entry", PROFILES, ids=[own["id"] for own in PROFILES])
def test_sympy_gives_the_same_numbers(entry):
    """Every exact g and F as an expression of SymPy, evaluated with 30 digits."""
    found = sneddon.Profile(entry["f"]).derive()
    known = values(entry)
    for formula, coordinate in ((found.g, "x"), (found.F, "a")):
        if formula.status != "exact":
            continue
        try:
            expression = formula.sympy()
        except sneddon.SneddonError as error:
            assert "SymPy has no function" in str(error)
            continue
        # Not next to a kink, where the last digit of a parameter decides.
        at = 0.31 * min([own for name, own in known.items() if name in ("R", "c")], default=1.0)
        numbers = {sympy.Symbol(name, positive=True): sympy.Float(value, 40) for name, value in known.items()}
        numbers |= {sympy.Symbol(coordinate, positive=True): sympy.Float(at, 40), sympy.Symbol("E", positive=True): sympy.Integer(1)}
        truth = sympy.N(expression.subs(numbers), 30)
        assert truth.is_real or abs(sympy.im(truth)) < 1e-20, (entry["id"], truth)
        value, bound = formula(at, with_bound=True, **known)
        assert abs(float(sympy.re(truth)) - value) <= bound + 4e-16 * abs(value), (entry["id"], formula.text)


def test_expressions_of_sympy_become_profiles():
    r, R, b = sympy.symbols("r R b", positive=True)
    assert sneddon.Profile(R - sympy.sqrt(R**2 - r**2)).derive().g.text == "x*atanh(x/R)"
    worn = sympy.Piecewise((0, r < b), ((r**2 - b**2) / (2 * R), True))
    assert sneddon.Profile(worn).derive().g.status == "exact"
    assert sneddon.Profile(sympy.Max(0, r - b)).derive().g.status == "exact"
    with pytest.raises(sneddon.SneddonError, match="not a function of profiles"):
        sneddon.Profile(sympy.airyai(r))


def test_formulas_are_functions_of_arrays():
    formula = sneddon.Profile("C*r^n").derive().F
    a = np.array([[0.5, 1.0], [1.5, 2.0]])
    found = formula(a, C=0.7, n=2.5, E=3.0)
    assert found.shape == a.shape
    # F = 2E∫r²f′/√(a²−r²)dr by mpmath.
    for value, own in zip(found.flat, a.flat):
        truth = 2 * 3.0 * mpmath.quad(lambda t: (own * mpmath.sin(t)) ** 2 * 0.7 * 2.5 * (own * mpmath.sin(t)) ** 1.5, [0, mpmath.pi / 2])
        assert abs(value - truth) < 1e-13 * truth
    assert formula(a=1.0, C=0.7, n=2.5, E=3.0) == found[0, 1]
    pressure = sneddon.Profile("r^2/(2*R)").derive().p
    assert pressure(np.zeros(3), 1.0, R=1.0) == pytest.approx([2 / np.pi] * 3, rel=1e-15)


def test_bad_formulas_say_where():
    with pytest.raises(sneddon.SneddonError) as found:
        sneddon.Profile("r^2/(2*R")
    assert "column" in found.value.place and found.value.help
    with pytest.raises(sneddon.SneddonError, match="no parameter Q"):
        sneddon.Profile("r^2/R", Q=1.0)
    with pytest.raises(sneddon.SneddonError, match="not positive"):
        sneddon.Contact("r^2/R", R=-1.0, E_star=1.0)
    with pytest.raises(sneddon.SneddonError, match="has no value"):
        sneddon.Contact("r^2/R", E_star=1.0)
    for bad in (None, 3, b"r^2", [1, 2, 3], object()):
        with pytest.raises(TypeError):
            sneddon.Profile(bad)
    with pytest.raises(TypeError):
        sneddon.Profile("r^2/R", R=[1.0])


def test_rules_are_listed():
    assert {"heß-power", "sphere"} <= {own["id"] for own in sneddon.rules()}


@pytest.mark.parametrize("text", ["r^2/(2*R)", "R-sqrt(R^2-r^2)", "r*tan(theta)", "C*r^n"])
def test_inverting_the_equivalent_profile_gives_the_profile_back(text):
    """A law: f from g from f is f."""
    values = {"R": 2.0, "theta": 0.3, "C": 0.7, "n": 3.5}
    profile = sneddon.Profile(text)
    own = {name: values[name] for name in profile.parameters}
    g = profile.derive().g
    assert g.status == "exact"
    r = np.array([0.1, 0.5, 1.0])
    found, bounds, grounds = sneddon.invert(g.text)(r, with_bound="ground", **own)
    expected, own_bounds = sneddon.Contact(profile, E_star=1.0, **own).shape(r, with_bound=True)
    assert (abs(found - expected) <= bounds + own_bounds).all() and (bounds <= 1e-10 * abs(expected)).all()
    assert set(grounds) <= {"proven", "estimated"}


def test_inversions_have_every_formula():
    found = sneddon.invert("x^2/R + x")
    assert (found.text, found.status, found.check["verdict"]) == ("r^2/(2*R) + 2/pi*r", "exact", "passed")
    assert found.sympy().free_symbols == {sympy.Symbol("r", positive=True), sympy.Symbol("R", positive=True)}
    assert found(0.5, R=2.0) == pytest.approx(0.0625 + 1 / np.pi, rel=1e-15)
    assert sneddon.invert(sympy.Symbol("x") ** 2).text == "r^2/2"
    # The pressure of Hertz: F = (2/3) π p_0 a².
    hertz = sneddon.invert("p_0*sqrt(1-r^2/a^2)", pressure=True)
    assert sympy.sympify(hertz.F, {"E": sympy.Symbol("E")}).equals(sympy.sympify("2*pi*p_0*a**2/3"))
    assert hertz(0.5, a=1.0, p_0=1.0, E=2.0) == pytest.approx(np.pi / 32, rel=1e-15)
    for call, told in ((lambda: found(0.5), "the parameter R has no value"), (lambda: found(0.5, R=1.0, Q=2.0), "no parameter Q"),
                       (lambda: found(0.5, R=-1.0), "R = -1"), (lambda: found(-0.5, R=1.0), "r = -0.5"),
                       (lambda: sneddon.invert("x^2/"), "unexpected end"), (lambda: sneddon.invert("1/x"), "no finite value at x = 0")):
        with pytest.raises(sneddon.SneddonError, match=told):
            call()
    # a cancels on the way to g, and was typed.
    flat = sneddon.invert("1/sqrt(a^2-r^2)", pressure=True)
    assert flat(0.5, a=1.0, E=1.0) == flat(0.2, a=1.0, E=1.0)
    with pytest.raises(TypeError):
        sneddon.invert(3)
    with pytest.raises(TypeError, match="pressure is 'yes'"):
        sneddon.invert("x^2", pressure="yes")


def test_comparisons_have_verdicts():
    found = sneddon.compare("R-sqrt(R^2-r^2)")
    assert found and found["F"]["verdict"] == "passed" and found["g"]["points"] == 64
    nothing = sneddon.compare("ln(cosh(r))")
    assert not nothing.passed and {nothing[key]["verdict"] for key in nothing} == {"not compared"}
    assert "no closed form" in nothing.why and found.why is None and dict(found)["F"] == found["F"]
    with pytest.raises(TypeError, match="radius is '1 um'"):
        sneddon.compare("r^2", radius="1 um")
    with pytest.raises(sneddon.SneddonError, match="radius is larger"):
        sneddon.compare("r^2", radius=10**400)
    assert sneddon.compare("0", depth=0.1, radius=2.0).passed
    for call, told in ((lambda: sneddon.compare("0"), "flat"), (lambda: sneddon.compare("r^2", radius=-1.0), "radius = -1"),
                       (lambda: sneddon.compare(lambda r: r), "belong to formulas")):
        with pytest.raises(sneddon.SneddonError, match=told):
            call()


def test_formulas_and_derivations_pickle():
    found = sneddon.Profile("r^2/(2*R)").derive()
    value = found.F(0.5, R=2.0)
    again = pickle.loads(pickle.dumps(found))
    assert again.F(0.5, R=2.0) == value and str(again) == str(found)
    assert pickle.loads(pickle.dumps(found.F)).sympy() == found.F.sympy()
