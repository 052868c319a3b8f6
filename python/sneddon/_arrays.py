"""Arguments as arrays of 64-bit floats."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

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


def map_over(
    one: Callable[..., tuple[float, float]],
    many: Callable[..., None],
    key: str,
    arguments: dict[str, Any],
    with_bound: bool,
) -> Any:
    """Evaluate a quantity over broadcast arguments: floats for scalars, else arrays of the broadcast shape."""
    values = list(arguments.values())
    if all(type(own) is float or type(own) is int for own in values):
        found = one(key, *values)
        return found if with_bound else found[0]
    arrays = np.broadcast_arrays(*(real(name, value) for name, value in arguments.items()))
    shape = arrays[0].shape
    if shape == ():
        found = one(key, *(float(own) for own in arrays))
        return found if with_bound else found[0]
    flat = [np.ascontiguousarray(own).reshape(-1) for own in arrays]
    result = np.empty(flat[0].size)
    bound = np.empty(flat[0].size) if with_bound or flat[0].size <= EQUAL else None
    many(key, flat[0], flat[1] if len(flat) > 1 else None, result, bound)
    if bound is None or not with_bound:
        return result.reshape(shape)
    return result.reshape(shape), bound.reshape(shape)
