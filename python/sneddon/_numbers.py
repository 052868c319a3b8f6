"""Numbers as text that reads back exactly, and as floats."""

from __future__ import annotations

import decimal
import fractions
import numbers
from collections.abc import Mapping
from typing import Any

import numpy as np

from ._errors import SneddonError


def is_sympy(value: Any) -> bool:
    """Return whether a value is an expression of SymPy, without importing SymPy."""
    return str(type(value).__module__).partition(".")[0] == "sympy" or hasattr(value, "_sympy_")


def text_of_number(name: str, value: Any) -> str:
    """Write a number so that it reads back exactly."""
    if isinstance(value, str):
        return value
    if isinstance(value, bool):
        raise TypeError(f"{name} is a bool; a number is accepted")
    if isinstance(value, (numbers.Integral, fractions.Fraction)):
        return str(value)
    if isinstance(value, decimal.Decimal):
        return str(value)
    if isinstance(value, (numbers.Real, np.floating)) or (isinstance(value, np.ndarray) and value.shape == ()):
        return repr(float(value))
    raise TypeError(f"{name} is a {type(value).__name__}; a number, or text such as '1/3', is accepted")


def float_of_number(name: str, value: Any) -> float:
    """Convert a parameter to a float."""
    text_of_number(name, value)
    try:
        return float(fractions.Fraction(value) if isinstance(value, str) else value)
    except (ValueError, ZeroDivisionError):
        raise TypeError(f"{name} is {value!r}; a number such as 1.5 or '3/2' is accepted where numbers are computed") from None
    except OverflowError:
        raise SneddonError(f"{name} is larger than a 64-bit float", name) from None


def merged(parameters: Mapping[str, Any] | None, values: dict[str, Any]) -> dict[str, Any]:
    """Merge values given as a mapping with values given by keyword.

    Raises
    ------
    TypeError
        If a parameter is in both.
    """
    both = sorted(set(parameters or ()) & set(values))
    if both:
        raise TypeError(f"{both[0]} has two values, one by keyword and one in parameters")
    return {**(parameters or {}), **values}
