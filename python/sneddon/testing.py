"""Assertions for the tests of a contact solver."""

from __future__ import annotations

from typing import Any

from ._scenes import validate


def assert_matches(scene: Any, tolerance: float | None = None, **columns: Any) -> None:
    """Fail unless the columns of one run match the exact solution of a scene.

    Parameters
    ----------
    scene : path, str or dict
        The scene.
    tolerance : float, optional
        The relative L2 error that is accepted, instead of that of the grid.
    **columns : array_like
        Columns such as ``d`` and ``F``, or ``x``, ``y`` and ``p``.

    Raises
    ------
    AssertionError
        With the verdict, and the fault that explains the data where one does.
    """
    __tracebackhide__ = True
    found = validate(scene, columns, tolerance=tolerance)
    if not found.passed:
        raise AssertionError(str(found))


def assert_converges(scene: Any, runs: Any, *, grid: Any = (), tolerance: float | None = None) -> None:
    """Fail unless several resolutions converge to the exact solution of a scene.

    Parameters
    ----------
    scene : path, str or dict
        The scene.
    runs : list
        One dict of columns, DataFrame or file per resolution.
    grid : sequence of float
        Pixels along a side of the domain, per resolution.
    """
    __tracebackhide__ = True
    if not isinstance(runs, (list, tuple)) or len(runs) < 2:
        raise TypeError("assert_converges needs a list of at least two resolutions")
    found = validate(scene, list(runs), grid=grid, tolerance=tolerance)
    if not found.passed:
        raise AssertionError(str(found))
