"""The one family of errors."""

from __future__ import annotations


class SneddonError(ValueError):
    """An input that has no answer.

    Attributes
    ----------
    place : str or None
        Where it is: a parameter, a column of a text, an index of an array.
    help : str or None
        What is accepted instead.
    """

    def __init__(self, message: str, place: str | None = None, help: str | None = None) -> None:
        super().__init__(message)
        self.message = message
        self.place = place
        self.help = help

    def __str__(self) -> str:
        where = f" ({self.place})" if self.place else ""
        what = f"; {self.help}" if self.help else ""
        return f"{self.message}{where}{what}"

    def __reduce__(self) -> tuple[object, ...]:
        return (SneddonError, (self.message, self.place, self.help))
