"""Rigorous values of g, F and p of a profile given as a tree, by ball arithmetic (python-flint).

A tree is a nested tuple: ("num", Fraction), ("par", name), ("r",), ("+", a, b), ("-", a, b), ("*", a, b), ("/", a, b), ("^", a, b), ("neg", a),
("fn", name, a), ("bessel", "j" or "i", order, a), ("abs", a), ("min", a, b), ("max", a, b), ("pw", u, b, v).
f' and f'' are compiled from it; acb.integral encloses every integral, so that no feature can fall between nodes.
"""
from fractions import Fraction
import flint
from flint import acb, arb, fmpq

NAN = acb(arb("nan"), arb("nan"))


class NoTruth(Exception):
    """The enclosure did not become narrow enough, or the profile is not smooth where it should be."""


def ball(number):
    if isinstance(number, Fraction):
        return arb(fmpq(number.numerator, number.denominator))
    return arb(number)


def cut(z, analytic, place):
    """z, or nothing where an analytic value is wanted and a branch cut may be touched."""
    if not analytic:
        return z
    if place == "i" and not (z.real > 0 or z.real < 0 or abs(z.imag) < 1):
        return NAN
    if place == "1" and not (z.imag > 0 or z.imag < 0 or abs(z.real) < 1):
        return NAN
    if place == "above" and not (z.imag > 0 or z.imag < 0 or z.real > 1):
        return NAN
    return z


def root(z, analytic):
    return z.sqrt(analytic=analytic)


# name: (cut, value, first derivative from (z, value), second derivative)
FUNCTIONS = {
    "exp": (None, "{z}.exp()", "{v}", "{v}"),
    "sin": (None, "{z}.sin()", "{z}.cos()", "-{v}"),
    "cos": (None, "{z}.cos()", "-{z}.sin()", "-{v}"),
    "tan": (None, "{z}.tan()", "(1+{v}*{v})", "2*{v}*(1+{v}*{v})"),
    "sinh": (None, "{z}.sinh()", "{z}.cosh()", "{v}"),
    "cosh": (None, "{z}.cosh()", "{z}.sinh()", "{v}"),
    "tanh": (None, "{z}.tanh()", "{z}.sech()**2", "-2*{v}*{z}.sech()**2"),
    "erf": (None, "{z}.erf()", "(-{z}*{z}).exp()*TWOPI", "-2*{z}*(-{z}*{z}).exp()*TWOPI"),
    "sqrt": (None, "root({z},an)", "1/(2*{v})", "-1/(4*{z}*{v})"),
    "ln": (None, "{z}.log(analytic=an)", "1/{z}", "-1/({z}*{z})"),
    "atan": ("i", "{z}.atan()", "1/(1+{z}*{z})", "-2*{z}/(1+{z}*{z})**2"),
    "asinh": ("i", "{z}.asinh()", "1/root(1+{z}*{z},an)", "-{z}/(root(1+{z}*{z},an)*(1+{z}*{z}))"),
    "asin": ("1", "{z}.asin()", "1/root(1-{z}*{z},an)", "{z}/(root(1-{z}*{z},an)*(1-{z}*{z}))"),
    "acos": ("1", "{z}.acos()", "-1/root(1-{z}*{z},an)", "-{z}/(root(1-{z}*{z},an)*(1-{z}*{z}))"),
    "atanh": ("1", "{z}.atanh()", "1/(1-{z}*{z})", "2*{z}/(1-{z}*{z})**2"),
}


class Program:
    """Straight-line code for the value and the derivatives of a tree without kinks."""

    def __init__(self, tree, values, order):
        self.lines, self.values, self.order, self.consts = [], values, order, {}
        self.seen = {}
        out = self.node(tree)
        body = "\n ".join(self.lines) or "pass"
        names = ", ".join(part if part is not None else "acb(0)" for part in out[: order + 1])
        text = f"def compute(s, an):\n {body}\n return ({names},)"
        scope = {"acb": acb, "root": root, "cut": cut, "TWOPI": 2 / arb.pi().sqrt(), **self.consts}
        exec(text, scope)
        self.compute = scope["compute"]

    def name(self, text):
        name = f"t{len(self.lines)}"
        self.lines.append(f"{name} = {text}")
        return name

    def const(self, value):
        name = f"c{len(self.consts)}"
        self.consts[name] = acb(value)
        return name

    def node(self, tree):
        if tree not in self.seen:
            self.seen[tree] = self.make(tree)
        return self.seen[tree]

    def chain(self, value, first, second, inner):
        """The derivatives of h(u) from h' and h''."""
        _, u1, u2 = inner
        if u1 is None:
            return value, None, None
        d1 = self.name(f"({first})*{u1}")
        d2 = None
        if self.order > 1:
            tail = f" + ({first})*{u2}" if u2 is not None else ""
            d2 = self.name(f"({second})*{u1}*{u1}{tail}")
        return value, d1, d2

    def total(self, a, b, sign):
        if a is None and b is None:
            return None
        if b is None:
            return a
        return self.name(f"{a} {sign} {b}" if a is not None else (f"-{b}" if sign == "-" else b))

    def product(self, u, v):
        value = self.name(f"{u[0]}*{v[0]}")
        first = [f"{u[1]}*{v[0]}"] * (u[1] is not None) + [f"{u[0]}*{v[1]}"] * (v[1] is not None)
        d1 = self.name(" + ".join(first)) if first else None
        d2 = None
        if self.order > 1:
            second = [f"{u[2]}*{v[0]}"] * (u[2] is not None) + [f"{u[0]}*{v[2]}"] * (v[2] is not None)
            if u[1] is not None and v[1] is not None:
                second.append(f"2*{u[1]}*{v[1]}")
            d2 = self.name(" + ".join(second)) if second else None
        return value, d1, d2

    def make(self, tree):
        kind = tree[0]
        if kind == "num":
            return self.const(ball(tree[1])), None, None
        if kind == "pi":
            return self.const(arb.pi()), None, None
        if kind == "par":
            return self.const(ball(self.values[tree[1]])), None, None
        if kind == "r":
            return "s", "1", None
        if kind in "+-":
            u, v = self.node(tree[1]), self.node(tree[2])
            return self.name(f"{u[0]} {kind} {v[0]}"), self.total(u[1], v[1], kind), self.total(u[2], v[2], kind)
        if kind == "neg":
            u = self.node(tree[1])
            return tuple(None if part is None else self.name(f"-{part}") for part in u)
        if kind == "*":
            return self.product(self.node(tree[1]), self.node(tree[2]))
        if kind == "/":
            v = self.node(tree[2])
            if tree[2][:2] == ("fn", "cosh"):  # the quotient itself says nothing on a ball that is higher than a period
                w = self.node(tree[2][2])
                value = self.name(f"{w[0]}.sech()")
                inverse = self.chain(value, f"-{value}*{w[0]}.tanh()", f"{value}*(1-2*{value}**2)", w)
                return self.product(self.node(tree[1]), inverse)
            value = self.name(f"1/{v[0]}")
            return self.product(self.node(tree[1]), self.chain(value, f"-{value}*{value}", f"2*{value}**3", v))
        if kind == "^":
            base, power = self.node(tree[1]), self.node(tree[2])
            exponent = constant(tree[2], self.values)
            if exponent is None:
                log = self.name(f"{base[0]}.log(analytic=an)")
                log = self.chain(log, f"1/{base[0]}", f"-1/({base[0]}*{base[0]})", base)
                z = self.product(log, power)
                value = self.name(f"{z[0]}.exp()")
                return self.chain(value, value, value, z)
            if isinstance(exponent, Fraction) and exponent.denominator == 1:
                n = exponent.numerator
                power = lambda k: "1" if k == 0 else f"{base[0]}**({k})"
                zero = lambda c: c == 0
                first = "acb(0)" if n == 0 else f"{n}*{power(n - 1)}"
                second = "acb(0)" if zero(n * (n - 1)) else f"{n * (n - 1)}*{power(n - 2)}"
                return self.chain(self.name(power(n) + "+acb(0)"), first, second, base)
            if isinstance(exponent, Fraction) and exponent.denominator == 2:
                n = exponent.numerator  # v^(n/2): the root is sharper than a general power
                half = self.name(f"root({base[0]}, an)")
                c = self.const(ball(exponent))
                c2 = self.const(ball(exponent * (exponent - 1)))
                return self.chain(self.name(f"{half}**({n})"), f"{c}*{half}**({n - 2})", f"{c2}*{half}**({n - 4})", base)
            c = self.const(ball(exponent))
            value = self.name(f"{base[0]}.pow({c}, analytic=an)")
            return self.chain(value, f"{c}*{value}/{base[0]}", f"{c}*({c}-1)*{value}/({base[0]}*{base[0]})", base)
        if kind == "fn":
            u = self.node(tree[2])
            where, value, first, second = FUNCTIONS[tree[1]]
            z = u[0] if where is None else self.name(f"cut({u[0]}, an, '{where}')")
            v = self.name(value.format(z=z))
            # The derivatives of what has a cut have their own, or none.
            return self.chain(v, first.format(z=u[0], v=v), second.format(z=u[0], v=v), u)
        if kind == "bessel":
            u, n, k = self.node(tree[3]), tree[2], tree[1]
            sign = "-" if k == "j" else "+"
            at = lambda m: f"{u[0]}.bessel_{k}({abs(m)})" if m >= 0 or k == "i" or m % 2 == 0 else f"(-{u[0]}.bessel_{k}({abs(m)}))"
            v = self.name(at(n))
            first = f"({at(n - 1)} {sign} {at(n + 1)})/2"
            second = f"({at(n - 2)} {sign} 2*{v} + {at(n + 2)})/4"
            return self.chain(v, first, second, u)
        raise NoTruth(f"{kind} was not resolved")


def constant(tree, values):
    """The exact value of a constant tree, as a Fraction where it is rational, else as a ball; None where r occurs."""
    kind = tree[0]
    if kind == "num":
        return tree[1]
    if kind == "par":
        return Fraction(values[tree[1]])
    if kind == "pi":
        return arb.pi()
    if kind == "neg":
        inner = constant(tree[1], values)
        return None if inner is None else -inner
    if kind in "+-*/":
        a, b = constant(tree[1], values), constant(tree[2], values)
        if a is None or b is None:
            return None
        if not (isinstance(a, Fraction) and isinstance(b, Fraction)):
            a, b = ball(a), ball(b)
        return {"+": lambda: a + b, "-": lambda: a - b, "*": lambda: a * b, "/": lambda: a / b}[kind]()
    return None


def kinks(tree):
    """Every node that is smooth only piece by piece."""
    found = []
    for part in tree[1:]:
        if isinstance(part, tuple):
            found += kinks(part)
    if tree[0] in ("abs", "min", "max", "pw"):
        found.append(tree)
    return found


def resolve(tree, values, middle):
    """The tree on the piece around `middle`."""
    parts = tuple(resolve(part, values, middle) if isinstance(part, tuple) else part for part in tree)
    if tree[0] in ("abs", "min", "max"):
        u = evaluate(parts[1], values, middle)
        v = evaluate(parts[2], values, middle) if tree[0] != "abs" else arb(0)
        if not (u < v or u > v):
            raise NoTruth("a kink at the middle of a piece")
        if tree[0] == "abs":
            return parts[1] if u > v else ("neg", parts[1])
        return parts[1] if (u < v) == (tree[0] == "min") else parts[2]
    if tree[0] == "pw":
        return parts[1] if middle < ball(constant(tree[2], values)) else parts[3]
    return parts


def evaluate(tree, values, at):
    out = Program(tree, values, 0).compute(acb(at), False)[0]
    if not out.is_finite() or not out.imag.contains(0):
        raise NoTruth("the profile has no value")
    return out.real


def breakpoints(tree, values, end):
    """Where the pieces of the tree meet below `end`, with some hundred digits' bits."""
    places = []
    for node in kinks(tree):
        if node[0] == "pw":
            places.append(ball(constant(node[2], values)))
            continue
        base = node[1] if node[0] == "abs" else ("-", node[1], node[2])
        if kinks(base):
            inner = breakpoints(base, values, end)
        else:
            inner = []
        marks = [arb(0)] + inner + [arb(end)]
        for low, high in zip(marks, marks[1:]):
            low, high = low.mid(), high.mid()
            piece = resolve(base, values, (low + high) / 2)
            program = Program(piece, values, 0)
            value = lambda t: program.compute(acb(t), False)[0].real
            count = 48
            grid = [low + (high - low) * (arb(k) + arb(1) / 7) / (count + 1) for k in range(count + 1)] + [high]
            if low == 0:
                # Powers and functions that grow as the same power meet anywhere next to the axis.
                grid = [grid[0] * arb(2) ** -k for k in range(200, 0, -1)] + grid
            signs = [1 if value(t) > 0 else -1 if value(t) < 0 else 0 for t in grid]
            for (t0, s0), (t1, s1) in zip(zip(grid, signs), zip(grid[1:], signs[1:])):
                if s0 * s1 >= 0:
                    continue
                for _ in range(flint.ctx.prec + 4):
                    middle = ((t0 + t1) / 2).mid()
                    now = value(middle)
                    if not (now > 0 or now < 0):
                        t0 = t1 = middle
                        break
                    t0, t1 = (middle, t1) if (now > 0) == (s0 > 0) else (t0, middle)
                places.append(((t0 + t1) / 2).mid())
    places = [b for b in places if b > 0 and b < end]
    places.sort(key=lambda b: float(b))
    merged = []
    for b in places:
        if not merged or abs(b - merged[-1]) > arb(2) ** (-flint.ctx.prec // 2):
            merged.append(b.mid() if not b.is_exact() else b)
    return merged


class Truth:
    """g, F and p of one profile on [0, end]; `marks` are places of narrow features."""

    def __init__(self, tree, values, end, marks=(), singular=False, bits=140):
        flint.ctx.prec = bits
        self.bits, self.singular = bits, singular
        self.tolerance = arb(2) ** -92
        end = arb(end)
        self.breaks = breakpoints(tree, values, end)
        edges = [arb(0)] + self.breaks + [end]
        self.pieces = []
        for low, high in zip(edges, edges[1:]):
            piece = resolve(tree, values, (low + high) / 2)
            self.pieces.append((low, high, Program(piece, values, 0).compute, Program(piece, values, 1).compute, Program(piece, values, 2).compute))
        self.jumps = []
        for k, b in enumerate(self.breaks):
            left, right = self.pieces[k], self.pieces[k + 1]
            step = (right[2](acb(b), False)[0] - left[2](acb(b), False)[0]).real
            if not abs(step) < arb(2) ** (-bits // 2):
                raise NoTruth("the profile jumps")
            change = (right[3](acb(b), False)[1] - left[3](acb(b), False)[1]).real
            self.jumps.append((b, change))
        self.marks = sorted((arb(m) for m in marks if 0 < m < float(end)), key=float)

    def parts(self, low, high):
        """The pieces of [low, high], split at the marks too."""
        out = []
        for start, stop, _, first, second in self.pieces:
            a = start if start > low else low
            b = stop if stop < high else high
            if not a < b:
                continue
            inner = [m for m in self.marks if m > a and m < b]
            edges = [a] + inner + [b]
            out += [(x, y, first, second) for x, y in zip(edges, edges[1:])]
        return out

    def integral(self, function, low, high):
        out = acb.integral(function, low, high, rel_tol=self.tolerance, abs_tol=self.tolerance * arb(2) ** -20, eval_limit=60000, depth_limit=400)
        if not out.is_finite():
            raise NoTruth("the integral has no enclosure")
        return out.real

    def weighed(self, x, weight):
        """∫ f'(x sin t) weight(t) dt over the quarter circle."""
        x, total = arb(x), arb(0)
        angle = lambda s: arb.pi() / 2 if not s < x else (s / ((x - s) * (x + s)).sqrt()).atan()
        for low, high, first, _ in self.parts(arb(0), x):
            low, high = (arb(0) if low == 0 else angle(low)), angle(high)
            if self.singular and low == 0:
                # t = high e^(-w): the axis is never touched; what is left out is 2^-115 of it.
                def integrand(w, an):
                    t = high * (-w).exp()
                    return first(x * t.sin(), an)[1] * weight(t) * t
                total += self.integral(integrand, arb(0), arb(self.bits))
            elif low == 0:
                total += self.integral(lambda t, an: first(x * t.sin(), an)[1] * weight(t), low, high)
            else:
                # From the other end: a ball around it stays as small as the square of its radius.
                quarter = arb.pi() / 2
                total += self.integral(lambda u, an: first(x * (1 - 2 * (u / 2).sin() ** 2), an)[1] * weight(quarter - u), quarter - high, quarter - low)
        return total

    def g(self, x):
        return arb(x) * self.weighed(x, lambda t: acb(1))

    def force(self, a):
        return 2 * arb(a) ** 2 * self.weighed(a, lambda t: t.sin() ** 2)

    def pressure(self, r, a):
        """(1/π) ∫ K(s) d(s f'(s)), K the integral of dx / √((x²-s²)(x²-r²)) from the larger of s and r to a.

        By double exponential rules on every panel, halved until two steps agree to 16 digits; the error of the finer one is about
        the square of that.
        """
        r, a = arb(r), arb(a)
        # Whether the larger or the smaller of s and r is squared away from zero, the differences come from the panel's end.
        def inside(s, gap):
            gap2 = gap * (s + r)
            return (a * a - r * r).sqrt() * acb.elliptic_rf(r * r * gap2, a * a * gap2, r * r * (a - s) * (a + s)).real

        def beyond(s, gap, rest):
            gap2 = gap * (s + r)
            return (rest * (a + s)).sqrt() * acb.elliptic_rf(s * s * gap2, a * a * gap2, s * s * (a * a - r * r)).real

        def density(second, s):
            v = second(acb(s), False)
            return (v[1] + s * v[2]).real

        total = arb(0)
        for low, high, _, second in self.parts(arb(0), r):
            last = high == r
            total += panel(lambda s, left, right: density(second, s) * inside(s, right if last else r - s), low, high)
        for low, high, _, second in self.parts(r, a):
            first, last = low == r, high == a
            total += panel(lambda s, left, right: density(second, s) * beyond(s, left if first else s - r, right if last else a - s), low, high)
        for b, change in self.jumps:
            if b < r:
                total += b * change * inside(b, r - b)
            elif b < a:
                total += b * change * beyond(b, b - r, a - b)
        return total / arb.pi()


NODES = {}


def nodes(level, bits):
    """Of step 2^-level: distances from both ends of [0, 1] and weights; at levels above 3 only the new ones."""
    if (level, bits) not in NODES:
        out, step, reach = [], arb(2) ** -level, 4
        for k in range(-reach * 2 ** level, reach * 2 ** level + 1):
            if level > 3 and k % 2 == 0:
                continue
            t = k * step
            e = (arb.pi() * t.sinh()).exp()
            out.append((e / (1 + e), 1 / (1 + e), arb.pi() * t.cosh() * e / (1 + e) ** 2))
        NODES[level, bits] = out
    return NODES[level, bits]


def panel(function, low, high, depth=0):
    width, total, scale, before = high - low, arb(0), arb(0), None
    for level in range(3, 8 if depth > 3 else 7):
        part = arb(0)
        for left, right, weight in nodes(level, flint.ctx.prec):
            left, right = width * left, width * right
            s = low + left if left < right else high - right
            value = function(s.mid(), left, right) * weight
            if not value.is_finite():
                raise NoTruth("the profile has no slope inside a panel")
            part += value.mid()
            scale += abs(value.mid())
        total += part
        now = width * total * arb(2) ** -level
        if before is not None and abs(now - before) <= width * scale * arb(2) ** -level * arb("1e-16"):
            return now
        before = now
    if depth > 5:
        raise NoTruth("the double exponential rule does not settle")
    middle = ((low + high) / 2).mid()
    # The ends of the halves are not the ends of the panel: the distances start from there.
    lower = panel(lambda s, left, right: function(s, left, high - s), low, middle, depth + 1)
    upper = panel(lambda s, left, right: function(s, s - low, right), middle, high, depth + 1)
    return lower + upper
