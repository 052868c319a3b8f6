"""The compiled part of the package."""

import numpy as np
from numpy.typing import NDArray

__version__: str

class Engine:
    @staticmethod
    def formula(
        text: str,
        names: list[str],
        values: list[float],
        exact: tuple[list[str], list[str]],
        effective_modulus: float,
        method: str,
        tolerance: float,
        depth: float | None = None,
    ) -> Engine: ...
    @staticmethod
    def points(r: NDArray[np.float64], z: NDArray[np.float64], effective_modulus: float, tolerance: float) -> Engine: ...
    @staticmethod
    def function(f: object, kinks: list[float], end: float | None, effective_modulus: float, tolerance: float) -> Engine: ...
    def one(self, key: str, at: float, radius: float | None = None) -> tuple[float, float, bool]: ...
    def valid(self, name: str, at: NDArray[np.float64]) -> list[bool]: ...
    def many(
        self,
        key: str,
        at: NDArray[np.float64],
        radius: NDArray[np.float64] | None,
        values: NDArray[np.float64],
        bounds: NDArray[np.float64] | None,
        grounds: NDArray[np.bool_] | None,
    ) -> None: ...

def derive(text: str, names: list[str], values: list[str], depth: str | None) -> str: ...
def compare(
    text: str, names: list[str], values: list[str], radius: float | None, depth: float | None, tolerance: float | None
) -> str: ...
def invert(text: str, pressure: bool) -> str: ...
def inverted(
    text: str, pressure: bool, names: list[str], values: list[float], radii: NDArray[np.float64]
) -> tuple[NDArray[np.float64], NDArray[np.float64], list[bool]]: ...
def parameters(text: str) -> list[str]: ...
def rules() -> str: ...
def quantities() -> list[tuple[str, str, str, str]]: ...
def solve(text: str, directory: str, force: bool) -> str: ...
def reference(
    text: str,
    directory: str,
    load: int,
    x: NDArray[np.float64],
    y: NDArray[np.float64],
    cells: tuple[float, int, bool] | None = None,
) -> tuple[tuple[NDArray[np.float64], NDArray[np.float64], str], tuple[NDArray[np.float64], NDArray[np.float64], str]]: ...
def validate(
    text: str,
    directory: str,
    files: list[tuple[str, bytes]],
    tolerance: float | None,
    grid: list[float],
    map: list[tuple[str, str]],
    side: str | None,
    origin: str | None,
    load: str | None,
    cells: bool | None,
) -> str: ...
