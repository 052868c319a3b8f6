"""The one family of errors."""

from __future__ import annotations

from collections.abc import Iterable

# The longest text of an error, of its message and of its place, in characters; the attributes are whole.
_MOST, _MESSAGE, _PLACE = 300, 190, 100
# The help text is omitted if fewer characters than this remain for it.
_ROOM = 40


def _without_middle(text: str, most: int) -> str:
    """Return a text of at most ``most`` characters that begins and ends as the given one."""
    end = most // 3
    return text if len(text) <= most else f"{text[: most - end - 5].rstrip()} ... {text[len(text) - end :].lstrip()}"


def missing_key(of: str, key: object, known: Iterable[str]) -> KeyError:
    """Return a KeyError that lists the keys of a mapping."""
    names = _without_middle(", ".join(known), _PLACE)
    return KeyError(f"{of} has no {_without_middle(repr(key), _PLACE)}; it has {names or 'nothing'}")


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
        where = f" ({_without_middle(self.place, _PLACE)})" if self.place else ""
        first = _without_middle(self.message, _MESSAGE) + where
        room = _MOST - len(first) - 2
        return f"{first}; {_without_middle(self.help, room)}" if self.help and room >= min(_ROOM, len(self.help)) else first

    def __reduce__(self) -> tuple[object, ...]:
        return (SneddonError, (self.message, self.place, self.help))
