"""Expressions of SymPy from formulas in text, and back."""

from __future__ import annotations

import re
from typing import Any

from ._errors import SneddonError

_TOKEN = re.compile(r"\s*(?:(\d+\.?\d*(?:[eE][+-]?\d+)?|\.\d+(?:[eE][+-]?\d+)?)|([^\W\d]\w*)|(<=|>=|[-+*/^()\[\],<>=]))")


def _sympy() -> Any:
    try:
        import sympy
    except ImportError:
        raise ImportError("expressions need SymPy: pip install sympy") from None
    return sympy


def expression_of(text: str) -> Any:
    """Return an equal expression of SymPy for a formula in text; symbols are positive."""
    return _Reader(text).formula()


# Functions that have the same name and arguments in SymPy.
_EQUAL = set(
    "sqrt exp sin cos tan sinh cosh tanh sec csc cot asin acos atan asinh acosh atanh gamma digamma polygamma erf erfc erfi "
    "polylog besselj besseli bessely besselk fresnelc fresnels hyper betainc".split()
)


class _Reader:
    """A formula in text, read by recursive descent."""

    def __init__(self, text: str) -> None:
        self.sympy = _sympy()
        self.tokens: list[str] = []
        place = 0
        while place < len(text.rstrip()):
            found = _TOKEN.match(text, place)
            if found is None:
                raise SneddonError(f"the formula has an unknown character {text[place:].strip()[:1]!r}", f"column {place + 1}")
            self.tokens.append(found.group(0).strip())
            place = found.end()
        self.place = 0

    def formula(self) -> Any:
        value = self.sum()
        if self.place != len(self.tokens):
            raise SneddonError(f"{self.tokens[self.place]!r} is not expected in the formula")
        return value

    def peek(self) -> str:
        return self.tokens[self.place] if self.place < len(self.tokens) else ""

    def take(self, *wanted: str) -> str:
        token = self.peek()
        if wanted and token not in wanted:
            raise SneddonError(f"the formula has {token!r} where {' or '.join(wanted)} is expected")
        self.place += 1
        return token

    def sum(self) -> Any:
        value = self.product()
        while self.peek() in ("+", "-"):
            value = value + self.product() if self.take() == "+" else value - self.product()
        return value

    def product(self) -> Any:
        value = self.signed()
        while self.peek() in ("*", "/"):
            value = value * self.signed() if self.take() == "*" else value / self.signed()
        return value

    def signed(self) -> Any:
        if self.peek() == "-":
            self.take()
            return -self.signed()
        if self.peek() == "+":
            self.take()
            return self.signed()
        base = self.atom()
        if self.peek() == "^":
            self.take()
            return base ** self.signed()
        return base

    def atom(self) -> Any:
        token = self.take()
        if token == "(":
            value = self.sum()
            self.take(")")
            return value
        if token == "[":
            return self.rest("]")
        if token[:1].isdigit() or token[:1] == ".":
            return self.sympy.Rational(token)
        if not (token[:1].isalpha() or token[:1] == "_"):
            raise SneddonError(f"the formula has {token!r} where a number or a name is expected")
        if self.peek() != "(":
            return self.sympy.pi if token == "pi" else self.sympy.Symbol(token, positive=True)
        self.take("(")
        return self.call(token, self.rest(")"))

    def rest(self, end: str) -> list[Any]:
        values: list[Any] = []
        while self.peek() != end:
            values.append(self.relation())
            if self.peek() != end:
                self.take(",")
        self.take(end)
        return values

    def relation(self) -> Any:
        left = self.sum()
        if self.peek() not in ("<", ">", "<=", ">=", "="):
            return left
        kinds = {"<": self.sympy.Lt, ">": self.sympy.Gt, "<=": self.sympy.Le, ">=": self.sympy.Ge, "=": self.sympy.Eq}
        return kinds[self.take()](left, self.sum())

    def call(self, name: str, values: list[Any]) -> Any:
        s = self.sympy
        if name in _EQUAL:
            return getattr(s, name)(*values)
        other = {
            "ln": s.log,
            "log": s.log,
            "abs": s.Abs,
            "min": s.Min,
            "max": s.Max,
            "sign": s.sign,
            "ellipk": s.elliptic_k,
            "ellipe": s.elliptic_e,
            "ellipf": s.elliptic_f,
            "hyp2f1": lambda a, b, c, z: s.hyper([a, b], [c], z),
            "hyp1f1": lambda a, b, z: s.hyper([a], [b], z),
            "dawson": lambda z: s.sqrt(s.pi) / 2 * s.exp(-(z**2)) * s.erfi(z),
            "integral": lambda f, r, lower, upper: s.Integral(f, (r, lower, upper)),
            # DLMF 11.2.1 and 11.2.2, with 1F2 for the series.
            "struveh": lambda n, z: (z / 2) ** (n + 1) / (s.gamma(s.Rational(3, 2)) * s.gamma(n + s.Rational(3, 2)))
            * s.hyper([1], [s.Rational(3, 2), n + s.Rational(3, 2)], -(z**2) / 4),
            "struvel": lambda n, z: (z / 2) ** (n + 1) / (s.gamma(s.Rational(3, 2)) * s.gamma(n + s.Rational(3, 2)))
            * s.hyper([1], [s.Rational(3, 2), n + s.Rational(3, 2)], z**2 / 4),
        }
        if name == "piecewise":
            pairs = [(values[i], values[i + 1]) for i in range(0, len(values) - 1, 2)]
            return s.Piecewise(*pairs, *([(values[-1], True)] if len(values) % 2 else []))
        made = other.get(name)
        if made is None:
            raise SneddonError(f"SymPy has no function {name}", help="the text or LaTeX of the formula is accepted elsewhere; mpmath may have it")
        return made(*values)


_NAMES = {
    "log": "ln",
    "Abs": "abs",
    "Min": "min",
    "Max": "max",
    "elliptic_k": "ellipk",
    "elliptic_e": "ellipe",
    "elliptic_f": "ellipf",
}
_SAME = set(
    "exp sin cos tan sinh cosh tanh asin acos atan asinh acosh atanh sec csc cot gamma erf erfc erfi besselj besseli sign".split()
)


def text_of(expression: Any) -> str:
    """Return an expression of SymPy in the grammar of profiles."""
    s = _sympy()
    expression = s.sympify(expression)

    def wrapped(own: Any) -> str:
        return f"({written(own)})"

    def written(own: Any) -> str:
        if own.is_Symbol:
            return str(own.name)
        if own is s.pi:
            return "pi"
        if own is s.E:
            return "exp(1)"
        if own.is_Integer or own.is_Rational:
            return f"({own})" if own.is_negative or not own.is_Integer else str(own)
        if own.is_Float:
            return f"({float(own)!r})"
        if own.is_Add:
            return " + ".join(wrapped(part) for part in own.args)
        if own.is_Mul:
            return "*".join(wrapped(part) for part in own.args)
        if own.is_Pow:
            return f"sqrt({written(own.base)})" if own.exp == s.Rational(1, 2) else f"{wrapped(own.base)}^{wrapped(own.exp)}"
        if isinstance(own, s.Piecewise):
            parts = []
            for value, condition in own.args:
                if condition == True:  # noqa: E712, a condition of SymPy
                    parts.append(written(value))
                    break
                parts += [written(value), relation(condition)]
            return f"piecewise({', '.join(parts)})"
        name = type(own).__name__
        if name in _NAMES or name in _SAME:
            return f"{_NAMES.get(name, name)}({', '.join(written(part) for part in own.args)})"
        raise SneddonError(f"{name} of SymPy is not a function of profiles", help="elementary functions, Piecewise, Min, Max and Abs are accepted")

    def relation(own: Any) -> str:
        if own.is_Relational and own.rel_op in ("<", "<=", ">", ">="):
            return f"{written(own.lhs)} {own.rel_op} {written(own.rhs)}"
        raise SneddonError(f"the condition {own} is not a comparison of r with a number", help="conditions such as r < b are accepted")

    return written(expression)
