"""Many scenes that differ in some values, on one core or over a Dask cluster."""

from __future__ import annotations

import copy
import itertools
from collections.abc import Sequence
from typing import Any

import numpy as np

from ._errors import SneddonError
from ._scenes import solve
from ._sneddon import quantities

# Quantities that every sweep returns.
_ALWAYS = ("d", "F", "a", "k")
# Quantities with one value per load.
_PER_LOAD = [key for key, kind, _, _ in quantities() if kind == "number"]
# Scenes that one task solves.
_BLOCK = 200


def sweep(scene: dict[str, Any], over: dict[str, Any] | Sequence[dict[str, Any]], client: Any = None) -> Any:
    """Solve a scene for every combination of values, or for a list of points.

    Parameters
    ----------
    scene : dict
        The scene, with one load.
    over : dict, or list of dict
        Values by the dotted name of a key, such as ``{"profile.parameters.R": [...], "load.depth": [...]}`` for every combination;
        or a dict for each scene, such as ``[{"profile.parameters.R": 1.0, "load.depth": 0.1}, ...]``, all with the same names.
    client : dask.distributed.Client, optional
        Where the scenes are solved, in blocks; without it here.

    Returns
    -------
    xarray.Dataset
        ``d``, ``F``, ``a``, ``k`` and the quantities with one value per load in ``[outputs] quantities`` of the scene, such as ``U``,
        over the names of ``over``, or over ``point`` for a list; for each a bound on its error, as ``F_error``, and whether that is proven, as ``F_proven``; ``valid``; and ``error``. A scene that cannot be solved has NaN
        and its reason in ``error``.
    """
    import xarray

    if not isinstance(scene, dict):
        raise TypeError("a sweep takes the scene as a dict")
    scene, numbers = _with_outputs(scene)
    if isinstance(over, dict):
        names = list(over)
        values = [list(np.atleast_1d(own)) if not isinstance(own, (list, tuple)) else list(own) for own in over.values()]
        points = list(itertools.product(*values))
        dimensions = names
        coordinates: dict[str, Any] = dict(zip(names, values))
        shape = tuple(len(own) for own in values)
    else:
        scenes = list(over)
        for index, own in enumerate(scenes):
            if not isinstance(own, dict):
                raise TypeError(f"over[{index}] is a {type(own).__name__}; a dict of values by dotted names is accepted")
            if own.keys() != scenes[0].keys():
                raise SneddonError(f"the names {', '.join(map(str, own))} differ from those of the first point", f"over[{index}]")
        names = list(scenes[0]) if scenes else []
        points = [tuple(own[name] for name in names) for own in scenes]
        dimensions, shape = ["point"], (len(points),)
        coordinates = {name: ("point", _column([point[index] for point in points])) for index, name in enumerate(names)}
    for name in names:
        if not isinstance(name, str):
            raise TypeError(f"{name!r} is not the dotted name of a key")
        if name in (*(key + own for key in numbers for own in ("", "_error", "_proven")), "valid", "error"):
            raise SneddonError(f"{name} is a result of the sweep", f"over, {name}", "a dotted name such as load.depth is accepted")
        _changed(scene, [(name, None)])
    blocks = [points[start : start + _BLOCK] for start in range(0, len(points), _BLOCK)]
    if client is None:
        found = [_solved(scene, names, block) for block in blocks]
    else:
        found = client.gather(client.map(_solved, *zip(*((scene, names, block) for block in blocks)), pure=False))
    rows = [row for block in found for row in block]

    def values_of(kind: str, key: str, missing: Any, dtype: type) -> tuple[list[str], np.ndarray]:
        return dimensions, np.array([row[kind].get(key, missing) for row in rows], dtype=dtype).reshape(shape)

    data: dict[str, Any] = {}
    for key in numbers:
        data[key] = values_of("numbers", key, np.nan, float)
    for key in numbers:
        data[f"{key}_error"] = values_of("errors", key, np.nan, float)
        data[f"{key}_proven"] = values_of("proven", key, False, bool)
    data["valid"] = (dimensions, np.array([row["valid"] for row in rows], dtype=bool).reshape(shape))
    data["error"] = (dimensions, np.array([row["why"] for row in rows], dtype=object).reshape(shape))
    return xarray.Dataset(data, coords=coordinates)


def _with_outputs(scene: dict[str, Any]) -> tuple[dict[str, Any], list[str]]:
    """Return the scene with the quantities of the sweep among its outputs, and the keys of those quantities."""
    outputs = scene.get("outputs")
    asked = outputs.get("quantities") if isinstance(outputs, dict) else None
    if not isinstance(outputs, dict) or not isinstance(asked, (list, tuple)):
        return scene, list(_ALWAYS)
    # d is in every row.
    wanted = [*asked, *(key for key in _ALWAYS[1:] if key not in asked)]
    return {**scene, "outputs": {**outputs, "quantities": wanted}}, [key for key in _PER_LOAD if key in _ALWAYS or key in asked]


def _column(values: list[Any]) -> np.ndarray:
    """Return values as a coordinate; lists and tables stay as they are."""
    if all(np.ndim(own) == 0 and not isinstance(own, dict) for own in values):
        return np.array(values)
    column = np.empty(len(values), dtype=object)
    column[:] = [tuple(own) if isinstance(own, (list, np.ndarray)) else own for own in values]
    return column


def _changed(scene: dict[str, Any], changes: list[tuple[str, Any]]) -> dict[str, Any]:
    """Return a copy of the scene with some values replaced."""
    own = copy.deepcopy(scene)
    for name, value in changes:
        table = own
        *path, last = name.split(".")
        for key in path:
            if not isinstance(table.get(key), dict):
                raise SneddonError(f"the scene has no table {key}", f"over, {name}", "a dotted name such as load.depth is accepted")
            table = table[key]
        table[last] = value
    return own


def _solved(scene: dict[str, Any], names: list[str], points: list[tuple[Any, ...]]) -> list[dict[str, Any]]:
    return [_one(_changed(scene, list(zip(names, point)))) for point in points]


def _one(scene: dict[str, Any]) -> dict[str, Any]:
    """Return the numbers of a scene, the bounds on their errors, whether these are proven, and why there are none."""
    nothing: dict[str, Any] = {"numbers": {}, "errors": {}, "proven": {}, "valid": False}
    try:
        found = solve(scene)
    except (SneddonError, TypeError) as error:
        return {**nothing, "why": str(error)}
    if len(found.rows) != 1:
        return {**nothing, "why": f"the scene has {len(found.rows)} loads; a sweep takes one"}
    row = found.rows[0]
    return {
        "numbers": {key: row[key] for key in _PER_LOAD if isinstance(row.get(key), (int, float))},
        "errors": row.get("error_estimates", {}),
        "proven": {key: ground == "proven" for key, ground in row.get("bounds", {}).items()},
        "valid": row["valid"],
        "why": "" if row["valid"] else found.why,
    }
