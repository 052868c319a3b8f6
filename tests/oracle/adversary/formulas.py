"""A printed formula as a number, by mpmath, whose spelling and definitions of functions the program shares."""
import ast
import re
import mpmath
from mpmath import mp, mpf

SUPERSCRIPT = {"²": "^2", "³": "^3"}


class NoNumber(Exception):
    """A formula that this small reader does not know."""


def integral(arguments, scope):
    integrand, name, low, high = arguments
    low, high = value(low, scope), value(high, scope)
    if low == high:
        return mpf(0)

    # Terms of an integrand that cancel next to the axis leave nothing of the digits of its nodes.
    for extra in (0, 400):
        def at(t):
            with mpmath.extradps(extra):
                return value(integrand, {**scope, name.id: t})
        found, error = mpmath.quad(at, mpmath.linspace(low, high, 3), error=True, maxdegree=8)
        if error <= mpf(10) ** -18 * (1 + abs(found)) and abs(found) < mpf(10) ** 30:
            return found
    raise NoNumber("the quadrature of a printed integral does not settle")


FUNCTIONS = {
    "ln": mpmath.log, "log": mpmath.log, "abs": abs, "min": min, "max": max,
    "dawson": lambda z: mpmath.sqrt(mpmath.pi) / 2 * mpmath.exp(-z * z) * mpmath.erfi(z),
    "hyper": lambda a, b, z: mpmath.hyper(a, b, z),
    "polygamma": lambda m, z: mpmath.psi(int(m), z), "digamma": mpmath.digamma,
}


def lookup(name):
    if name in FUNCTIONS:
        return FUNCTIONS[name]
    found = getattr(mpmath, name, None)
    if found is None:
        raise NoNumber(f"mpmath has no {name}")
    return found


def value(node, scope):
    if isinstance(node, ast.Expression):
        return value(node.body, scope)
    if isinstance(node, ast.Call):
        name = node.func.id
        if name == "integral":
            return integral(node.args, scope)
        if name == "piecewise":
            parts = node.args
            for k in range(0, len(parts) - 1, 2):
                if value(parts[k + 1], scope):
                    return value(parts[k], scope)
            return value(parts[-1], scope)
        if name == "N":
            return mpf(node.args[0].value)
        return lookup(name)(*[value(part, scope) for part in node.args])
    if isinstance(node, ast.BinOp):
        a, b = value(node.left, scope), value(node.right, scope)
        kind = type(node.op)
        if kind is ast.Pow and b == int(mpmath.re(b)):
            return a ** int(mpmath.re(b))
        return {ast.Add: lambda: a + b, ast.Sub: lambda: a - b, ast.Mult: lambda: a * b, ast.Div: lambda: a / b, ast.Pow: lambda: a ** b}[kind]()
    if isinstance(node, ast.UnaryOp):
        inner = value(node.operand, scope)
        return -inner if isinstance(node.op, ast.USub) else inner
    if isinstance(node, ast.Compare):
        a, b = value(node.left, scope), value(node.comparators[0], scope)
        return a < b if isinstance(node.ops[0], ast.Lt) else a <= b if isinstance(node.ops[0], ast.LtE) else a > b if isinstance(node.ops[0], ast.Gt) else a >= b
    if isinstance(node, ast.List):
        return [value(part, scope) for part in node.elts]
    if isinstance(node, ast.Name):
        if node.id in scope:
            return scope[node.id]
        if node.id == "pi":
            return +mpmath.pi
        if node.id == "e":
            return +mpmath.e
        raise NoNumber(f"no value for {node.id}")
    raise NoNumber(ast.dump(node)[:60])


def number(text, scope, digits=40):
    """The value of a printed formula at `scope`."""
    for name, other in SUPERSCRIPT.items():
        text = text.replace(name, other)
    text = re.sub(r"(?<![A-Za-z_\d.])(\d+\.?\d*(?:[eE][+-]?\d+)?)", r'N("\1")', text).replace("^", "**")
    tree = ast.parse(text.replace("lambda", "lambda_"), mode="eval")
    with mp.workdps(digits):
        return value(tree, {k: (v if not isinstance(v, float) else mpf(v)) for k, v in scope.items()})
