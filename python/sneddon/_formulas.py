"""Derived formulas."""

from __future__ import annotations

import json
import re
from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

from ._arrays import WithBound, map_over
from ._errors import SneddonError, missing_key
from ._numbers import float_of_number, merged

if TYPE_CHECKING:
    from ._profile import Profile

_LEFT = {"g": "g(x)", "d": "d(a)", "F": "F(a)", "p": "p(r)", "k": "k(a)", "a_of_d": "a(d)", "F_of_d": "F(d)"}
_ARGUMENTS = {"g": ("x",), "d": ("a",), "F": ("a",), "p": ("r", "a"), "k": ("a",), "a_of_d": ("d",), "F_of_d": ("d",)}
# Quantities in proportion to the effective modulus.
_WITH_MODULUS = {"F", "p", "k", "F_of_d"}


class Formula:
    """One formula, as text, LaTeX, an expression of SymPy, and a function of arrays.

    Attributes
    ----------
    text, latex : str
        The formula; the text reads back.
    status : str
        ``exact`` where the whole formula is closed, ``partial`` where some terms are integrals, ``numeric`` where all are.
    rules, sources : list of str
        The rules that closed it, and where they are stated.
    compared : bool
        Whether every closed form in it agreed with quadrature when it was derived.
    conditions : list of str
        Where it holds.
    """

    def __init__(self, key: str, entry: dict[str, Any], conditions: list[str], profile: Profile, rim: str | None = None) -> None:
        self.key = key
        self.compared: bool = entry["compared"]
        self._rim = rim
        self.text: str = entry["text"]
        self.latex: str = entry["latex"]
        self.status: str = entry["status"]
        self.rules: list[str] = entry["rules"]
        self.sources: list[str] = entry["reference"]
        self.conditions = conditions
        self._profile = profile
        self._engines: dict[tuple[Any, ...], Any] = {}

    def __getstate__(self) -> dict[str, Any]:
        return {**self.__dict__, "_engines": {}}

    def __str__(self) -> str:
        return self.text

    def __repr__(self) -> str:
        return f"<{_LEFT[self.key]} = {self.text}>"

    def _repr_latex_(self) -> str:
        return f"$\\displaystyle {_LEFT[self.key]} = {self.latex}$"

    def sympy(self) -> Any:
        """Return an equal expression of SymPy; parameters and coordinates are positive symbols.

        Raises
        ------
        SneddonError
            For a function that SymPy does not have; it is named.
        """
        from ._sympy import expression_of

        return expression_of(self.text)

    def __call__(
        self, /, *coordinates: Any, with_bound: WithBound = False, E: float = 1.0, parameters: Mapping[str, Any] | None = None, **values: Any
    ) -> Any:
        """Evaluate the formula, as it is printed, over arrays.

        Parameters
        ----------
        *coordinates : array_like
            x for g, a for d, F and k, r and a for p, d for a(d) and F(d); F(d) of a punch with a rim takes d, a number, and a.
            They may be given by these names instead.
        with_bound : bool or "ground"
            Whether to return the error bounds beside the values, and what these rest on.
        d : float
            The depth of a punch with a rim whose depth was left open, ``depth="d"``.
        E : float
            The effective modulus.
        parameters : mapping, optional
            Values of parameters by name; needed for names that are also arguments.
        **values : float
            The parameters that the profile leaves open; those that the formula lacks may be left out.
        """
        values = merged(parameters, values)
        # Under a rim the contact radius does not change, and F(a) is the answer for every depth.
        of_depth = self._rim is not None and self.key == "F_of_d"
        asked, names = ("F", ("d", "a")) if of_depth else (self.key, _ARGUMENTS[self.key])
        given = dict(zip(names, coordinates))
        if len(coordinates) > len(names):
            raise TypeError(f"{_LEFT[self.key]} has {len(names)} coordinates, {', '.join(names)}; {len(coordinates)} were given")
        if of_depth:
            if "d" in given and "d" in values:
                raise TypeError(f"{_LEFT[self.key]} has two values of d")
            if "d" in given:
                values["d"] = given.pop("d")
            names = ("a",)
        for name in names:
            if name not in given:
                if name not in values:
                    raise TypeError(f"{_LEFT[self.key]} needs {name}")
                given[name] = values.pop(name)
        modulus = float(E) if self.key in _WITH_MODULUS else 1.0
        if not (modulus > 0.0 and modulus < float("inf")):
            raise SneddonError(f"E = {modulus} is not positive and finite", "E", "the effective modulus is accepted")
        depth = None if self._rim is None else self._depth(values)
        profile = self._profile
        missing = self._missing(values)
        if self.key in ("d", "k") and missing and not missing & self._written():
            # The formula lacks the parameters of the profile, and any other profile has the same one.
            profile, values = type(profile)("r^2"), {}
        known = {name: float_of_number(name, value) for name, value in values.items()}
        key = (*sorted(known.items()), ("E*", modulus), ("d", depth))
        engine = self._engines.get(key)
        if engine is None:
            if len(self._engines) > 64:
                self._engines.clear()
            engine = self._engines[key] = profile.engine(values, modulus, "auto", 1e-13, depth, exact=True)
        return map_over(engine.one, engine.many, asked, given, with_bound)

    def _depth(self, parameters: dict[str, Any]) -> float:
        """Return the depth of the rim as a number, and take it out of the parameters where it was left open."""
        given = parameters.pop("d", None) if self._rim == "d" or self.key == "F_of_d" else None
        if self._rim != "d":
            assert self._rim is not None
            depth = float_of_number("depth", self._rim)
            if given is not None and float_of_number("d", given) != depth:
                raise SneddonError(f"d = {given} is not the depth of this punch, {depth}", "d", 'derive(depth="d") leaves the depth open')
            return depth
        if given is None and "d" not in self._written():
            # g and k are the same at every depth.
            return 0.0
        if given is None:
            raise TypeError(f"{_LEFT[self.key]} needs d, the depth of the punch")
        return float_of_number("d", given)

    def _written(self) -> set[str]:
        """Return the names in the formula."""
        return set(re.findall(r"[^\W\d]\w*", self.text))

    def _missing(self, parameters: dict[str, Any]) -> set[str]:
        """Return the open parameters of the profile that have no value; a value for any other name is an error."""
        open_names = self._profile.open_names()
        for name in parameters:
            if name not in open_names:
                is_set = name in self._profile.numbers({})
                help = f"{name} was set when the profile was made; leave it open there" if is_set else None
                raise SneddonError(f"{_LEFT[self.key]} has no parameter {name}", f"parameter {name}", help)
        return open_names - parameters.keys()


class Derivation:
    """What follows from a profile: formulas ``g d F p k a_of_d F_of_d``; None where no form is known.

    Attributes
    ----------
    text, latex : str
        f(r) as it was typed, with set parameters in place.
    conditions, notes : list of str
        Where the formulas hold, and what a reader must know of them.
    check : dict
        The comparison of the closed forms with quadrature of f as typed.
    """

    def __init__(self, document: str, profile: Profile, rim: str | None = None) -> None:
        found = json.loads(document)
        self.text: str = found["profile"]["text"]
        self.latex: str = found["profile"]["latex"]
        self.conditions: list[str] = found["conditions"]
        self.notes: list[str] = found["notes"]
        self.check: dict[str, Any] = found["check"]
        self._formulas = {
            key: None if found.get(key) is None else Formula(key, found[key], self.conditions, profile, rim) for key in _LEFT
        }

    def __getitem__(self, key: str) -> Formula | None:
        try:
            return self._formulas[key]
        except KeyError:
            raise missing_key("the derivation", key, self._formulas) from None

    @property
    def g(self) -> Formula:
        """The equivalent profile g(x)."""
        return self._known("g")

    @property
    def d(self) -> Formula:
        """The indentation depth d(a)."""
        return self._known("d")

    @property
    def F(self) -> Formula:  # noqa: N802
        """The normal force F(a)."""
        return self._known("F")

    @property
    def p(self) -> Formula | None:
        """The pressure p(r) under a contact of radius a."""
        return self._formulas["p"]

    @property
    def k(self) -> Formula:
        """The stiffness k(a) = 2Ea."""
        return self._known("k")

    @property
    def a_of_d(self) -> Formula | None:
        """The contact radius a(d)."""
        return self._formulas["a_of_d"]

    @property
    def F_of_d(self) -> Formula | None:  # noqa: N802
        """The force F(d)."""
        return self._formulas["F_of_d"]

    def _known(self, key: str) -> Formula:
        formula = self._formulas[key]
        if formula is None:
            raise SneddonError(f"there is no formula of {key}")
        return formula

    def __str__(self) -> str:
        lines = [f"f(r) = {self.text}"]
        lines += [f"{_LEFT[key]} = {own.text}" for key, own in self._formulas.items() if own is not None]
        return "\n".join(lines)

    def __repr__(self) -> str:
        return f"<Derivation of f(r) = {self.text}>"

    def _repr_latex_(self) -> str:
        lines = [f"f(r) &= {self.latex}"]
        lines += [f"{_LEFT[key]} &= {own.latex}" for key, own in self._formulas.items() if own is not None]
        return "$$\\begin{align*}" + " \\\\ ".join(lines) + "\\end{align*}$$"
