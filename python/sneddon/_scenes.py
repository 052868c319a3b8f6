"""Scenes: a profile with materials and loads, solved, given on a grid, and compared with a solver's data."""

from __future__ import annotations

import io
import json
import os
from collections.abc import Iterator
from typing import Any

import numpy as np

from . import _sneddon
from ._arrays import real
from ._errors import SneddonError, missing_key


def text_of(scene: Any) -> tuple[str, str]:
    """Return the TOML text of a scene, and the directory from which its files count."""
    if isinstance(scene, dict):
        return _toml(scene), "."
    if isinstance(scene, os.PathLike) or (isinstance(scene, str) and "\n" not in scene and "[" not in scene):
        try:
            with open(scene, encoding="utf-8") as file:
                return file.read(), os.path.dirname(os.fspath(scene)) or "."
        except UnicodeDecodeError:
            raise SneddonError(f"the scene {os.fspath(scene)} is not UTF-8 text") from None
        except OSError as error:
            raise SneddonError(f"cannot read the scene {os.fspath(scene)}: {error.strerror}") from None
    if isinstance(scene, str):
        return scene, "."
    raise TypeError(f"a {type(scene).__name__} is not a scene; a path, TOML text or a dict is accepted")


def _toml(table: dict[str, Any]) -> str:
    lines: list[str] = []
    for name, value in table.items():
        if not isinstance(value, dict):
            raise SneddonError(f"{name} is not a table", f"scene, {name}", "tables such as profile, material and load are accepted")
        lines.append(f"[{_key(name)}]")
        lines += [f"{_key(key)} = {_value(key, own)}" for key, own in value.items()]
    return "\n".join(lines) + "\n"


def _key(name: Any) -> str:
    if not isinstance(name, str):
        raise TypeError(f"{name!r} is not the name of a key")
    return json.dumps(name) if not name.replace("_", "").replace("-", "").isalnum() or not name.isascii() else name


def _value(name: str, value: Any) -> str:
    if isinstance(value, np.ndarray) and value.shape == ():
        value = value.item()
    if isinstance(value, bool):
        return "true" if value else "false"
    if isinstance(value, str):
        return json.dumps(value, ensure_ascii=False).replace("\x7f", "\\u007f")
    if isinstance(value, (int, np.integer)):
        return str(int(value))
    if isinstance(value, (float, np.floating)):
        number = float(value)
        if not np.isfinite(number):
            raise SneddonError(f"{name} = {number} is not finite", f"scene, {name}")
        return repr(number)
    if isinstance(value, dict):
        return "{ " + ", ".join(f"{_key(key)} = {_value(key, own)}" for key, own in value.items()) + " }"
    if isinstance(value, (list, tuple, np.ndarray)):
        return "[" + ", ".join(_value(name, own) for own in value) + "]"
    raise TypeError(f"{name} is a {type(value).__name__}; numbers, texts, lists and tables are accepted")


class Solution:
    """The solved loads of a scene.

    Attributes
    ----------
    document : dict
        The document that ``sneddon solve --json`` prints.
    rows : list of dict
        One row per load.
    """

    def __init__(self, document: str) -> None:
        self.document: dict[str, Any] = json.loads(document)
        self.rows: list[dict[str, Any]] = self.document["rows"]

    @property
    def valid(self) -> bool:
        """Whether every row is a valid contact."""
        return all(row["valid"] for row in self.rows)

    @property
    def verdict(self) -> str:
        """``"valid"``, ``"valid at N radii"`` where no proof was found, or ``"not valid"``."""
        found: str = self.document["validity"]["verdict"]
        return found

    @property
    def why(self) -> str | None:
        """Why rows are not valid or the answer is incomplete; None for a complete valid answer."""
        if "why" in self.document:
            return str(self.document["why"])
        if self.valid:
            return None
        findings = [own["message"] for own in self.document["validity"]["findings"] if own["severity"] == "error"]
        return next(iter([*findings, *(row["why"] for row in self.rows if "why" in row)]), "a row is not valid")

    @property
    def curves(self) -> list[dict[str, Any]]:
        """The curves of ``[outputs]``, as in the document: ``quantity``, ``d``, ``row``, and ``points`` with ``at`` and ``value``."""
        found: list[dict[str, Any]] = self.document["curves"]
        return found

    @property
    def units(self) -> dict[str, str] | None:
        """The units of the answers; None for bare numbers."""
        found: dict[str, str] | None = self.document.get("units")
        return found

    def __len__(self) -> int:
        return len(self.rows)

    def __iter__(self) -> Iterator[dict[str, Any]]:
        """Iterate over the rows."""
        return iter(self.rows)

    def __contains__(self, name: object) -> bool:
        """Whether the rows have a column of that name."""
        return name in self._names()

    def __getitem__(self, name: str) -> np.ndarray:
        """Return a column of numbers, NaN where a row has none; a name that no row has is a KeyError.

        ``"F_bound"`` are the error bounds of ``"F"``, and ``"F_ground"`` says what each rests on: "proven", "estimated", or "".
        """
        names = self._names()
        if name not in names:
            raise missing_key("the table of rows", name, names)
        quantity, _, kind = name.rpartition("_")
        if kind == "ground":
            return np.array([row.get("bounds", {}).get(quantity, "") for row in self.rows], dtype="U9")
        if kind == "bound":
            return np.array([_number(row.get("error_estimates", {}).get(quantity)) for row in self.rows])
        return np.array([_number(row.get(name)) for row in self.rows])

    def _names(self) -> list[str]:
        names: dict[str, None] = {}
        for row in self.rows:
            names.update({key: None for key, own in row.items() if own is None or (isinstance(own, (int, float)) and not isinstance(own, bool))})
        bounded = {key: None for row in self.rows for key in row.get("bounds", {})}
        return [*names, *(f"{key}_{kind}" for key in bounded for kind in ("bound", "ground"))]

    def to_numpy(self) -> np.ndarray:
        """Return a structured array: a field per number, NaN where a row has none, its error bound, what that rests on, and ``valid``."""
        columns = {name: self[name] for name in self._names()}
        array = np.empty(len(self.rows), dtype=[*((name, own.dtype) for name, own in columns.items()), ("valid", np.bool_)])
        for name, own in columns.items():
            array[name] = own
        array["valid"] = [row["valid"] for row in self.rows]
        return array

    def to_pandas(self) -> Any:
        """Return a DataFrame; units are in its ``attrs``."""
        import pandas

        frame = pandas.DataFrame(self.to_numpy())
        frame.attrs["units"] = self.units
        return frame

    def to_xarray(self) -> Any:
        """Return a Dataset over ``row``; units are in its ``attrs``."""
        import xarray

        table = self.to_numpy()
        found = xarray.Dataset({name: ("row", table[name]) for name in table.dtype.names or ()})
        found.attrs["units"] = self.units
        return found

    def __repr__(self) -> str:
        return f"<Solution of {len(self.rows)} loads, {'valid' if self.valid else 'not valid'}>"


def _number(value: Any) -> float:
    return float(value) if isinstance(value, (int, float)) else float("nan")


def solve(scene: Any, *, force: bool = False) -> Solution:
    """Solve a scene: a path, TOML text, or a dict of the same keys.

    Parameters
    ----------
    scene : path, str or dict
        The scene, units included.
    force : bool
        Whether rows that are not valid have numbers as well.
    """
    text, directory = text_of(scene)
    return Solution(_sneddon.solve(text, directory, force))


class Field:
    """Exact values on a solver's grid, in the units of the scene's answers.

    Attributes
    ----------
    p, u : ndarray
        Pressure and displacement of the surface.
    p_bound, u_bound : ndarray
        Bounds of their errors.
    p_ground, u_ground : str
        What the bounds rest on: "proven" if all of them are, else "estimated".
    """

    def __init__(self, p: np.ndarray, p_bound: np.ndarray, p_ground: str, u: np.ndarray, u_bound: np.ndarray, u_ground: str) -> None:
        self.p, self.p_bound, self.p_ground = p, p_bound, p_ground
        self.u, self.u_bound, self.u_ground = u, u_bound, u_ground

    def __repr__(self) -> str:
        return f"<Field of the shape {self.p.shape}>"


def reference(scene: Any, x: Any, y: Any = 0.0, *, cells: bool = False, load: int = 0) -> Field:
    """Return p and u at the places of a solver.

    Parameters
    ----------
    scene : path, str or dict
        The scene; ``load`` counts its loads from 0.
    x, y : array_like
        Coordinates from the axis in the unit of length of the scene's answers; they broadcast.
    cells : bool
        Whether pressures are means over square cells around the places, which are then those of a square grid about the axis,
        rows along y, as ``np.meshgrid(x, x)`` makes it.
    """
    text, directory = text_of(scene)
    xs, ys = np.broadcast_arrays(real("x", x), real("y", y))
    if not (np.isfinite(xs).all() and np.isfinite(ys).all()):
        raise SneddonError("a coordinate is not finite", "x, y")
    square = _square(xs, ys) if cells else None
    flat = np.ascontiguousarray(xs).reshape(-1), np.ascontiguousarray(ys).reshape(-1)
    (p, p_bound, p_ground), (u, u_bound, u_ground) = _sneddon.reference(text, directory, load, *flat, square)
    p, p_bound, u, u_bound = (own.reshape(xs.shape) for own in (p, p_bound, u, u_bound))
    return Field(p, p_bound, p_ground, u, u_bound, u_ground)


def _square(x: np.ndarray, y: np.ndarray) -> tuple[float, int, bool]:
    """Return side, count and whether the axis lies between points of a square grid."""
    fault = SneddonError("the places are not a square grid about the axis", "x, y", "np.meshgrid(x, x) with even steps is accepted for cells")
    if x.ndim != 2 or x.shape[0] != x.shape[1] or x.shape[0] < 2:
        raise fault
    count = x.shape[0]
    step = float(x[0, 1] - x[0, 0])
    if not step > 0.0:
        raise fault
    for between in (False, True):
        along = (np.arange(count) - count // 2 + (0.5 if between else 0.0)) * step
        if np.allclose(x, along[None, :], rtol=0.0, atol=1e-6 * step) and np.allclose(y, along[:, None], rtol=0.0, atol=1e-6 * step):
            return count * step, count, between
    raise fault


class Validation:
    """What a comparison of a solver's data with the exact solution found.

    Attributes
    ----------
    passed : bool
        The verdict.
    verdict : str
        Why, in one sentence.
    suspicion : str or None
        The fault that explains the data, where one does.
    suspicion_id : str or None
        Its name.
    orders : dict
        Orders of convergence by column.
    document : dict
        The document that ``sneddon validate --json`` prints.
    """

    def __init__(self, document: str) -> None:
        self.document: dict[str, Any] = json.loads(document)
        self.passed: bool = self.document["passed"]
        self.verdict: str = self.document["reason"]
        self.suspicion: str | None = self.document["suspicion"]
        self.suspicion_id: str | None = (self.document["suspicion_details"] or {}).get("id")
        self.orders: dict[str, Any] = self.document["order"] or {}
        self.columns: dict[str, Any] = self.document["columns"]

    def __bool__(self) -> bool:
        return self.passed

    def __str__(self) -> str:
        lines = [f"{'passed' if self.passed else 'failed'}: {self.verdict}"]
        lines += [f"suspicion: {self.suspicion}"] if self.suspicion else []
        return "\n".join(lines)

    def __repr__(self) -> str:
        return f"<Validation {self}>"

    def _repr_html_(self) -> str:
        import html

        rows = "".join(
            f"<tr><td>{html.escape(name)}</td><td>{own['l2']:.3e}</td><td>{own['max']:.3e}</td></tr>" for name, own in self.columns.items()
        )
        head = "<tr><th>column</th><th>L2 error</th><th>largest error</th></tr>"
        return f"<p>{html.escape(str(self))}</p><table>{head}{rows}</table>"


def validate(
    scene: Any,
    data: Any,
    *,
    tolerance: float | None = None,
    grid: Any = (),
    map: dict[str, str] | None = None,
    box: str | float | None = None,
    origin: str | None = None,
    load: str | None = None,
    cells: bool | None = None,
) -> Validation:
    """Compare a solver's data with the exact solution of a scene.

    Parameters
    ----------
    scene : path, str or dict
        The scene.
    data : dict of arrays, structured array, DataFrame, Dataset, path, or a list of these
        Columns such as ``d_um`` and ``F_mN``, or ``x``, ``y`` and ``p``; several of them are several resolutions.
    tolerance : float, optional
        The relative L2 error that is accepted, instead of that of the grid.
    grid : sequence of float
        Pixels along a side of the domain, per resolution.
    map : dict
        Names of columns by symbol, such as ``{"p": "press"}``.
    box, origin, load
        As ``--box``, ``--origin`` and ``--load`` of the program.
    cells : bool, optional
        Whether pressures are means over pixels, instead of what the file or ``[data]`` of the scene says.
    """
    text, directory = text_of(scene)
    runs = data if isinstance(data, (list, tuple)) else [data]
    files = [_file(own, f"data[{index}]" if len(runs) > 1 else "data") for index, own in enumerate(runs)]
    side = None if box is None else str(box)
    numbers = [float(own) for own in (grid if np.ndim(grid) else [grid])]
    pairs = list((map or {}).items())
    return Validation(_sneddon.validate(text, directory, files, tolerance, numbers, pairs, side, origin, load, cells))


def _file(data: Any, name: str) -> tuple[str, bytes]:
    """Return the bytes of a file with the columns of one resolution."""
    if isinstance(data, (str, os.PathLike)):
        try:
            with open(data, "rb") as file:
                return os.fspath(data), file.read()
        except OSError as error:
            raise SneddonError(f"cannot read the data {os.fspath(data)}: {error.strerror}") from None
    if isinstance(data, np.ndarray) and data.dtype.names:
        columns = {own: data[own] for own in data.dtype.names}
    elif hasattr(data, "data_vars"):
        columns = {str(own): data[own].values for own in [*data.data_vars, *(own for own in data.coords if own not in data.data_vars)]}
    elif hasattr(data, "columns") and hasattr(data, "to_numpy"):
        columns = {str(own): data[own].to_numpy() for own in data.columns}
    elif isinstance(data, dict):
        columns = data
    else:
        raise TypeError(f"{name} is a {type(data).__name__}; a dict of arrays, a structured array, a DataFrame or a path is accepted")
    if not columns:
        raise SneddonError(f"{name} has no columns", help="columns such as d and F, or x, y and p, are accepted")
    arrays = {str(key): real(str(key), own) for key, own in columns.items()}
    buffer = io.BytesIO()
    np.savez(buffer, **arrays)  # type: ignore[arg-type]
    return name, buffer.getvalue()
