"""The shape of an indenter."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from typing import TYPE_CHECKING, Any

import numpy as np

from . import _sneddon
from ._arrays import real
from ._errors import SneddonError
from ._formulas import Derivation
from ._numbers import float_of_number, is_sympy, merged, text_of_number

if TYPE_CHECKING:
    from ._contact import Contact


class Profile:
    """The shape f(r) of an axisymmetric indenter.

    Parameters
    ----------
    shape : str, SymPy expression, callable, or two arrays
        A formula of r, such as ``"r^2/(2*R)"``; an expression of SymPy in a symbol r; a function of one float
        (with ``kinks``); or a pair of arrays, radii and heights of a measured tip.
    kinks : sequence of float, optional
        The radii at which a callable has a kink.
    end : float, optional
        The radius at which a callable ends.
    parameters : mapping, optional
        Values of parameters by name; needed for names that are also arguments, such as ``end``.
    **values : number or str
        Values of parameters of a formula; those that are left out stay symbolic.

    Raises
    ------
    SneddonError
        For a formula that cannot be read, with ``place`` and ``help``.
    TypeError
        For something that is not a shape.

    Examples
    --------
    >>> Profile("r^2/(2*R)", R=2).derive().g.text
    'x^2/2'
    """

    def __init__(
        self,
        /,
        shape: Any,
        heights: Any = None,
        *,
        kinks: Sequence[float] = (),
        end: float | None = None,
        parameters: Mapping[str, Any] | None = None,
        **values: Any,
    ) -> None:
        values = merged(parameters, values)
        self._text: str | None = None
        self._points: tuple[np.ndarray, np.ndarray] | None = None
        self._values: dict[str, Any] = {}
        self._function: Callable[[float], float] | None = None
        self._kinks = [float(own) for own in kinks]
        self._end = end
        if heights is None and isinstance(shape, (tuple, list)) and len(shape) == 2:
            shape, heights = shape
        if isinstance(shape, str):
            self._text = shape
        elif heights is not None:
            r, z = real("radii", shape), real("heights", heights)
            if r.ndim != 1 or r.shape != z.shape:
                raise SneddonError(
                    f"radii have the shape {r.shape} and heights {z.shape}", "points", "two arrays of one dimension and length are accepted"
                )
            self._points = np.array(r, order="C"), np.array(z, order="C")
        elif is_sympy(shape):
            from ._sympy import text_of

            self._text = text_of(shape)
        elif isinstance(shape, Profile):
            self._text, self._points, self._function = shape._text, shape._points, shape._function
            self._kinks, self._end = self._kinks or shape._kinks, shape._end if end is None else end
            values = {**shape._values, **values}
        elif callable(shape):
            self._function = shape
        else:
            raise TypeError(f"a {type(shape).__name__} is not a profile; text, a SymPy expression, a callable or two arrays are accepted")
        if self._function is None and (self._kinks or self._end is not None):
            raise SneddonError(
                "kinks and end apply to callables only",
                "kinks" if self._kinks else "end",
                "omit them for formulas and points; a parameter with one of these names is set by parameters={...}",
            )
        _check_ends(self._kinks, self._end)
        self._values = values
        self._texts = {name: text_of_number(name, value) for name, value in values.items()}
        if self._text is None:
            if values:
                raise SneddonError(f"the profile has no parameter {next(iter(values))}", help="only formulas have parameters")
            return
        self._names = _sneddon.parameters(self._text)
        for name in self._texts:
            if name not in self._names:
                known = ", ".join(self._names) or "none"
                raise SneddonError(f"the profile has no parameter {name}; it has {known}", f"parameter {name}")

    @property
    def text(self) -> str | None:
        """The formula as it was typed; None for a measured tip or a callable."""
        return self._text

    @property
    def parameters(self) -> list[str]:
        """The names of the parameters that have no value."""
        return [] if self._text is None else [own for own in self._names if own not in self._texts]

    def derive(self, depth: str | float | None = None) -> Derivation:
        """Derive g, d, F, p and k, and a(d) and F(d) where they are explicit, as formulas.

        Parameters
        ----------
        depth : str or float, optional
            The depth of a punch with a rim at the contact radius: a number, or ``"d"``.
        """
        if self._text is None:
            raise SneddonError("formulas are derived from formulas", help="a profile of text or of SymPy is accepted; Contact gives numbers")
        rim = None if depth is None else text_of_number("depth", depth)
        document = _sneddon.derive(self._text, *self.texts(), rim)
        return Derivation(document, self, rim)

    def texts(self) -> tuple[list[str], list[str]]:
        """Return the names of the parameters that have values, and the values as texts that read back exactly."""
        return list(self._texts), list(self._texts.values())

    def contact(self, **arguments: Any) -> Contact:
        """Return ``Contact(self, **arguments)``."""
        from ._contact import Contact

        return Contact(self, **arguments)

    def open_names(self) -> set[str]:
        """Return the names of the parameters that have no value yet."""
        return set(self.parameters)

    def numbers(self, values: dict[str, Any]) -> dict[str, float]:
        """Return the values of all parameters as floats; ``values`` are those of the parameters that the profile leaves open."""
        return {name: float_of_number(name, value) for name, value in {**self._values, **values}.items()}

    def engine(
        self,
        values: dict[str, Any],
        e_star: float,
        method: str,
        tolerance: float,
        depth: float | None = None,
        exact: bool = False,
    ) -> _sneddon.Engine:
        """Return what computes numbers.

        ``values`` are the parameters that the profile leaves open, and ``depth`` is that of a punch with a rim at the contact radius.
        Parameters set on the profile are rounded to floats, or kept exact, as they are printed, if ``exact`` is true.
        """
        if self._points is not None:
            return _sneddon.Engine.points(*self._points, e_star, tolerance)
        if self._function is not None:
            return _sneddon.Engine.function(self._function, self._kinks, self._end, e_star, tolerance)
        assert self._text is not None
        numbers = self.numbers(values)
        printed = self.texts() if exact else ([], [])
        return _sneddon.Engine.formula(self._text, list(numbers), list(numbers.values()), printed, e_star, method, tolerance, depth)

    def __repr__(self) -> str:
        given = "".join(f", {name}={value!r}" for name, value in self._values.items())
        if self._points is not None:
            return f"Profile(<{self._points[0].size} points>)"
        return f"Profile({self._function if self._text is None else self._text!r}{given})"

    def _repr_latex_(self) -> str | None:
        return None if self._text is None else f"$\\displaystyle f(r) = {self.derive().latex}$"


def _check_ends(kinks: list[float], end: float | None) -> None:
    """Refuse an end that is not above 0, and kinks that do not rise between 0 and the end."""
    if end is not None and not end > 0:
        raise SneddonError(f"the profile ends at {end}", "end", "expected a radius greater than 0")
    last = 0.0
    for index, kink in enumerate(kinks):
        if not last < kink < (math.inf if end is None else end):
            message = f"the kink {kink} is not between {last} and {'infinity' if end is None else end}"
            raise SneddonError(message, f"kinks[{index}]", "expected strictly increasing radii between 0 and the end of the profile")
        last = kink
