"""Profiles from equivalent profiles, and from pressures."""

from __future__ import annotations

import json
from typing import Any

import numpy as np

from . import _sneddon
from ._arrays import WithBound, check_with_bound, ground_of, real
from ._numbers import float_of_number, is_sympy


class Inversion:
    """The profile f(r) that has a given equivalent profile, or that presses with a given pressure.

    Attributes
    ----------
    text, latex : str
        f(r); the text reads back.
    status : str
        ``exact`` where the whole formula is closed, ``partial`` where some terms are integrals, ``numeric`` where all are.
    rules, sources : list of str
        The rules that closed it, and where they are stated.
    conditions, notes : list of str
        Where it holds, and what a reader must know of it.
    g : str
        The equivalent profile g(x).
    d, F : str or None
        The indentation depth and the normal force of a given pressure.
    check : dict
        The comparison of the closed forms with quadrature of g as typed.
    document : dict
        The document that ``sneddon invert --json`` prints.
    """

    def __init__(self, text: str, pressure: bool) -> None:
        self._asked = text, pressure
        self.document: dict[str, Any] = json.loads(_sneddon.invert(text, pressure))
        found = self.document["f"]
        self.text: str = found["text"]
        self.latex: str = found["latex"]
        self.status: str = found["status"]
        self.rules: list[str] = found["rules"]
        self.sources: list[str] = found["reference"]
        self.conditions: list[str] = self.document["conditions"]
        self.notes: list[str] = self.document["notes"]
        self.check: dict[str, Any] = self.document["check"]
        self.g: str = self.document["g"]["text"]
        self.d, self.F = (own and own["text"] for own in (self.document.get("d"), self.document.get("F")))

    def __call__(self, r: Any, *, with_bound: WithBound = False, **parameters: Any) -> Any:
        """Evaluate f over arrays of radii, at values of the parameters."""
        check_with_bound(with_bound)
        numbers = [float_of_number(name, value) for name, value in parameters.items()]
        radii = real("r", r)
        flat = np.ascontiguousarray(radii).reshape(-1)
        found, bounds, proven = _sneddon.inverted(*self._asked, list(parameters), numbers, flat)
        grounds = ground_of(np.array(proven, dtype=np.bool_))
        answer = [own.reshape(radii.shape) if radii.shape else own[0].item() for own in (found, bounds, grounds)]
        if with_bound is False:
            return answer[0]
        return tuple(answer) if with_bound == "ground" else tuple(answer[:2])

    def sympy(self) -> Any:
        """Return an equal expression of SymPy; r and the parameters are positive symbols."""
        from ._sympy import expression_of

        return expression_of(self.text)

    def __str__(self) -> str:
        return self.text

    def __repr__(self) -> str:
        return f"<f(r) = {self.text}>"

    def _repr_latex_(self) -> str:
        return f"$\\displaystyle f(r) = {self.latex}$"


def invert(text: Any, pressure: bool = False) -> Inversion:
    """Find f(r) from g(x), or with ``pressure=True`` from a wanted pressure p(r).

    Parameters
    ----------
    text : str, or SymPy expression
        g as a formula of x, such as ``"x^2/R"``; or p as a formula of r, with the contact radius a and the effective modulus E.
    pressure : bool
        Whether the formula is a pressure.

    Examples
    --------
    >>> invert("x^2/R").text
    'r^2/(2*R)'
    >>> invert("p_0*sqrt(1-r^2/a^2)", pressure=True).F
    '2*pi/3*a^2*p_0'
    """
    if is_sympy(text):
        from ._sympy import text_of

        text = text_of(text)
    if not isinstance(text, str):
        raise TypeError(f"a {type(text).__name__} is not a formula; text or an expression of SymPy is accepted")
    if not isinstance(pressure, bool):
        raise TypeError(f"pressure is {pressure!r}; True or False is accepted")
    return Inversion(text, pressure)
