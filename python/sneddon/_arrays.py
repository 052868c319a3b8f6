"""Arguments as arrays of 64-bit floats."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, Literal, Union

import numpy as np


def real(name: str, value: Any) -> np.ndarray:
    """Return a number or array of numbers as an array of native 64-bit floats; a contiguous one is not copied."""
    if isinstance(value, np.ma.MaskedArray):
        raise TypeError(f"{name} is a masked array; its values are accepted as {name}.filled(...) or {name}.compressed()")
    try:
        array = np.asarray(value)
    except ValueError as error:
        raise TypeError(f"{name} is not an array of numbers: {error}") from None
    if array.dtype.kind not in "fiu":
        raise TypeError(f"{name} has the type {array.dtype}; real numbers are accepted")
    with np.errstate(over="ignore"):
        return np.require(array, np.float64, ["ALIGNED"])


# Arrays of at most so many entries have bit for bit the values of a loop; without bounds longer ones are computed in
# blocks, whose last digits differ and are as good.
EQUAL = 4096


# What may be asked for beside values: nothing, bounds of their errors, or bounds and what these rest on.
WithBound = Union[bool, Literal["ground"]]


def check_with_bound(with_bound: Any) -> WithBound:
    """Return what ``with_bound`` asks for; anything but True, False and "ground" is a TypeError."""
    if with_bound is True or with_bound is False or with_bound == "ground":
        return with_bound  # type: ignore[no-any-return]
    raise TypeError(f'with_bound is {with_bound!r}; True, False or "ground" is accepted')


def ground_of(proven: Any) -> Any:
    """Return "proven" or "estimated" for a bool, or an array of these words."""
    return np.where(proven, "proven", "estimated") if np.ndim(proven) else ("proven" if proven else "estimated")


def map_over(
    one: Callable[..., tuple[float, float, bool]],
    many: Callable[..., None],
    key: str,
    arguments: dict[str, Any],
    with_bound: WithBound,
) -> Any:
    """Evaluate a quantity over broadcast arguments: floats for scalars, else arrays of the broadcast shape."""
    values = list(arguments.values())
    scalars = all(type(own) is float or type(own) is int for own in values)
    arrays = [] if scalars else np.broadcast_arrays(*(real(name, value) for name, value in arguments.items()))
    if scalars or arrays[0].shape == ():
        value, bound, proven = one(key, *(values if scalars else [float(own) for own in arrays]))
        if check_with_bound(with_bound) is False:
            return value
        return (value, bound) if with_bound is True else (value, bound, ground_of(proven))
    shape = arrays[0].shape
    flat = [np.ascontiguousarray(own).reshape(-1) for own in arrays]
    size = flat[0].size
    result = np.empty(size)
    bounds = np.empty(size) if check_with_bound(with_bound) or size <= EQUAL else None
    grounds = np.empty(size, dtype=np.bool_) if with_bound == "ground" else None
    many(key, flat[0], flat[1] if len(flat) > 1 else None, result, bounds, grounds)
    if bounds is None or with_bound is False:
        return result.reshape(shape)
    if grounds is None:
        return result.reshape(shape), bounds.reshape(shape)
    return result.reshape(shape), bounds.reshape(shape), ground_of(grounds).reshape(shape)
