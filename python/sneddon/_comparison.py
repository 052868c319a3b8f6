"""Closed forms against quadrature."""

from __future__ import annotations

import json
from collections.abc import Iterator, Mapping
from typing import Any

from . import _sneddon
from ._errors import SneddonError, missing_key
from ._numbers import float_of_number
from ._profile import Profile


class Comparison(Mapping[str, dict[str, Any]]):
    """Closed forms of a profile compared with quadrature of the profile as typed, one comparison for each quantity.

    ``comparison["F"]`` has the keys ``verdict`` ("passed", "failed" or "not compared"), ``passed``, ``points``,
    ``max_relative_difference`` and ``at``.

    Attributes
    ----------
    passed : bool
        Whether something was compared and nothing failed.
    why : str or None
        Why the comparison is incomplete, or why nothing was compared.
    document : dict
        The document that ``sneddon compare --json`` prints.
    """

    def __init__(self, document: str) -> None:
        self.document: dict[str, Any] = json.loads(document)
        self._quantities: dict[str, dict[str, Any]] = {key: own for key, own in self.document.items() if isinstance(own, dict)}
        verdicts = {own["verdict"] for own in self._quantities.values()}
        cut = self.document.get("why")
        reasons = [own.get("why") for own in self._quantities.values()] if verdicts == {"not compared"} else []
        self.why: str | None = cut or next(iter(reasons), None)
        self.passed: bool = cut is None and "passed" in verdicts and "failed" not in verdicts

    def __getitem__(self, quantity: str) -> dict[str, Any]:
        try:
            return self._quantities[quantity]
        except KeyError:
            raise missing_key("the comparison", quantity, self._quantities) from None

    def __iter__(self) -> Iterator[str]:
        """Iterate over the keys of the quantities."""
        return iter(self._quantities)

    def __len__(self) -> int:
        return len(self._quantities)

    def __bool__(self) -> bool:
        return self.passed

    def __repr__(self) -> str:
        verdicts = (f"{key}: {own['verdict']}" for key, own in self._quantities.items())
        return f"<Comparison {', '.join(verdicts)}>"


def compare(
    profile: Any, *, radius: float | None = None, depth: float | None = None, tolerance: float | None = None, **parameters: Any
) -> Comparison:
    """Compare the closed forms of a profile with quadrature, at up to 64 places for each quantity.

    Parameters
    ----------
    profile : Profile, or a formula
        Parameters without a value get random ones that meet the conditions.
    radius : float, optional
        The contact radius; without it the places spread over the reach of the profile.
    depth : float, optional
        The depth of a punch with a rim at the contact radius.
    tolerance : float, optional
        The largest relative difference that may stand; without it, differences must stay within the error bounds.
    **parameters : number or str
        Values of parameters of the formula.

    Examples
    --------
    >>> compare("R - sqrt(R^2 - r^2)").passed
    True
    """
    own = Profile(profile, **parameters)
    if own.text is None:
        raise SneddonError("closed forms belong to formulas", help="a profile of text or of SymPy is accepted")
    asked = {"radius": radius, "depth": depth, "tolerance": tolerance}
    numbers = [None if value is None else float_of_number(name, value) for name, value in asked.items()]
    return Comparison(_sneddon.compare(own.text, *own.texts(), *numbers))
