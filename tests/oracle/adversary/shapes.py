"""Profiles as people type them: seeded random trees with the text in one of its many spellings."""
import random
from fractions import Fraction

R = ("r",)


def num(text):
    return ("num", Fraction(str(text)))


class Typed:
    """A profile: tree, text, values of parameters, how far it reaches, and what its reference must be told."""

    def __init__(self, tree, text, values, end, singular=False, removable=False, marks=()):
        self.tree, self.text, self.values, self.end = tree, text, values, end
        self.singular, self.removable, self.marks = singular, removable, list(marks)


class Maker:
    def __init__(self, seed):
        self.random = random.Random(seed)
        self.values, self.singular, self.removable, self.end = {}, False, False, self.pick([0.5, 1, 1, 1, 1.5, 2, 3])
        self.symbolic = self.random.random() < 0.35

    def pick(self, items):
        return self.random.choice(items)

    def number(self, low=0.1, high=3.0):
        """A number as people type it."""
        kind = self.random.random()
        if kind < 0.3:
            values = [v for v in (1, 2, 3, 4, 5) if low <= v <= high] or [high]
            return num(self.pick(values))
        if kind < 0.45:
            p, q = self.random.randint(1, 7), self.random.randint(2, 9)
            value = Fraction(p, q)
            if low <= value <= high and value.denominator > 1:
                return ("/", num(value.numerator), num(value.denominator))
        digits = self.pick([1, 2, 2, 3, 5])
        value = round(self.random.uniform(low, high), digits)
        if value < low:
            value = low
        return num(repr(value))

    def length(self, name, low=0.2, high=3.0):
        """A number or, now and then, a parameter with a value."""
        if self.symbolic and self.random.random() < 0.7 and len(self.values) < 3:
            if name in self.values:
                return ("par", name) if low <= self.values[name] <= high else self.number(low, high)
            self.values[name] = round(self.random.uniform(low, high), self.pick([1, 2, 3]))
            if self.values[name] < low:
                self.values[name] = low
            return ("par", name)
        return self.number(low, high)

    def scaled(self, tree, name="h"):
        """The tree, perhaps with a factor."""
        kind = self.random.random()
        if kind < 0.4:
            return tree
        if kind < 0.85:
            return ("*", self.length(name), tree)
        return ("/", tree, self.length(name, 0.5))

    def ratio(self, name="w", low=0.3, high=3.0):
        """r over a length, or a wave number times r."""
        kind = self.random.random()
        if kind < 0.3:
            return R
        if kind < 0.7:
            return ("/", R, self.length(name, low, high))
        return ("*", self.length("k", 0.3, 2.5), R)

    def power(self):
        n = self.pick([1, 2, 2, 2, 3, 4, 4, 5, 6, 8, 10])
        if self.random.random() < 0.25:
            self.singular = True
            text = self.pick(["1.5", "2.5", "1.3", "3.5", "0.5", "1.2", "0.7"])
            power = num(text) if self.random.random() < 0.6 else ("/", num(Fraction(text).numerator), num(Fraction(text).denominator))
            return ("^", R, power)
        return R if n == 1 else ("^", R, num(n))

    def sphere(self):
        radius = self.length("R", 1.1, 5.0)
        value = float(self.values[radius[1]]) if radius[0] == "par" else float(number_of(radius))
        self.end = min(self.end, value * self.pick([0.5, 0.9, 0.99]))
        two = num(2)
        if self.random.random() < 0.6:
            return ("-", radius, ("fn", "sqrt", ("-", ("^", radius, two), ("^", R, two))))
        return ("*", radius, ("-", num(1), ("fn", "sqrt", ("-", num(1), ("^", ("/", R, radius), two)))))

    def ended(self):
        """Functions with the end of their domain at R."""
        radius = self.length("R", 1.1, 5.0)
        value = float(self.values[radius[1]]) if radius[0] == "par" else float(number_of(radius))
        self.end = min(self.end, value * self.pick([0.5, 0.9, 0.99]))
        u = ("/", R, radius)
        kind = self.random.randrange(6)
        if kind == 0:
            return ("fn", "atanh", self.pick([u, ("^", u, num(2))]))
        if kind == 1:
            return ("fn", "asin", u)
        if kind == 2:
            return ("fn", "ln", ("/", radius, ("-", radius, R)))
        if kind == 3:
            return ("-", ("/", ("pi",), num(2)), ("fn", "acos", u))
        if kind == 4:
            return ("-", num(1), ("^", ("-", num(1), ("^", u, num(2))), self.pick([num("0.3"), ("/", num(1), num(3)), num("1.5"), ("/", num(3), num(4))])))
        return ("neg", ("fn", "ln", ("-", num(1), ("^", u, num(2)))))

    def named(self):
        u = self.ratio()
        u2 = ("^", u, num(2))
        one = num(1)
        return self.pick([
            lambda: ("-", ("fn", "sqrt", ("+", ("^", R, num(2)), ("^", (w := self.length("w")), num(2)))), w),
            lambda: ("*", R, ("fn", "tan", self.angle())),
            lambda: ("/", ("^", R, num(2)), ("*", num(2), self.length("R"))),
            lambda: ("-", one, ("fn", "cos", u)),
            lambda: ("-", one, ("fn", "exp", ("neg", u2))),
            lambda: ("-", one, ("fn", "exp", ("neg", u))),
            lambda: ("fn", "ln", ("+", one, u)),
            lambda: ("fn", "ln", ("+", one, u2)),
            lambda: ("fn", "ln", ("fn", "cosh", u)),
            lambda: ("fn", self.pick(["tanh", "atan", "asinh", "sinh", "sin", "erf"]), u),
            lambda: ("*", R, ("fn", self.pick(["tanh", "atan", "asinh", "sinh", "sin", "erf", "exp"]), u)),
            lambda: ("-", ("fn", "cosh", u), one),
            lambda: ("-", ("fn", "exp", u), one),
            lambda: ("/", u2, ("+", one, u2)),
            lambda: ("/", R, ("+", self.length("w"), R)),
            lambda: ("-", one, ("/", one, ("+", one, u2))),
            lambda: ("^", ("fn", self.pick(["sin", "tanh", "atan"]), u), num(2)),
            lambda: ("-", one, ("bessel", "j", 0, u)),
            lambda: ("bessel", self.pick("ji"), self.pick([1, 2]), u),
            lambda: ("*", R, ("bessel", self.pick("ji"), 1, u)),
            lambda: ("-", ("bessel", "i", 0, u), one),
            lambda: ("-", ("fn", "exp", u), ("+", one, u)),
            lambda: ("-", u, ("fn", "ln", ("+", one, u))),
            lambda: ("-", u, ("fn", "sin", u)),
            lambda: self.removed(u),
        ])()

    def removed(self, u):
        """Quotients with a removable 0/0 at the axis."""
        self.removable = self.singular = True
        return self.pick([
            ("-", num(1), ("/", ("fn", "sin", u), u)),
            ("/", ("^", ("fn", "sin", u), num(2)), R),
            ("/", ("-", num(1), ("fn", "cos", u)), R),
            ("/", R, ("fn", "tanh", u)),
            ("/", ("-", num(1), ("fn", "exp", ("neg", u))), R),
            ("*", ("^", R, num(2)), ("fn", "ln", R)),
        ])

    def root(self):
        """Roots of what vanishes at the axis like a power of r: even in r as they are typed, and often not even as they continue."""
        self.removable = self.singular = True
        u, one, two = self.ratio(), num(1), num(2)
        inner = self.pick([
            ("-", one, ("fn", "cos", u)),
            ("-", ("fn", "cosh", u), one),
            ("-", ("fn", "sqrt", ("+", one, ("^", u, two))), one),
            ("-", one, ("fn", "exp", ("neg", ("^", u, two)))),
            ("fn", "ln", ("+", one, ("^", u, two))),
            ("+", ("^", u, two), ("^", u, num(4))),
            ("-", u, ("fn", "sin", u)),
            ("*", u, ("fn", self.pick(["sin", "tanh", "atan"]), u)),
            ("-", ("bessel", "i", 0, u), one),
            ("/", ("^", u, two), ("+", one, ("^", u, two))),
        ])
        if self.random.random() < 0.6:
            return ("fn", "sqrt", inner)
        return ("^", inner, self.pick([num("0.5"), num("1.5"), num("2.5"), ("/", num(3), two), num("0.75"), ("/", num(1), num(3))]))

    def rooted(self):
        """Such a root alone, beside or inside other shapes."""
        own, kind = self.scaled(self.root()), self.random.randrange(6)
        if kind == 0:
            return own
        if kind == 1:
            return (self.pick("++-"), own, self.atom())
        if kind == 2:
            return ("*", own, self.atom())
        if kind == 3:
            return ("/", own, ("+", self.number(1, 3), self.pick([R, ("^", R, num(2)), ("^", self.atom(), num(2))])))
        if kind == 4:
            return ("*", ("^", R, num(self.pick([1, 2]))), own)
        return self.outer(own)

    def angle(self):
        if self.symbolic and "theta" not in self.values and len(self.values) < 3:
            self.values["theta"] = round(self.random.uniform(0.1, 1.3), 2)
            return ("par", "theta")
        return self.pick([num("0.3"), num("0.7"), ("/", ("pi",), num(6)), ("/", ("pi",), num(4)), num("0.15")])

    def atom(self):
        kind = self.random.random()
        if kind < 0.3:
            return self.scaled(self.power())
        if kind < 0.42:
            return self.scaled(self.sphere(), "c")
        if kind < 0.52:
            return self.scaled(self.ended())
        return self.scaled(self.named())

    def outer(self, u):
        """A function of a shape."""
        one = num(1)
        return self.pick([
            lambda: ("-", ("fn", "sqrt", ("+", one, u if self.nonnegative else ("^", u, num(2)))), one),
            lambda: ("fn", "ln", ("+", one, ("^", u, num(2)))),
            lambda: ("-", one, ("fn", "exp", ("neg", ("^", u, num(2))))),
            lambda: ("fn", self.pick(["tanh", "atan", "sin", "asinh", "erf"]), u),
            lambda: ("^", u, num(self.pick([2, 2, 3, 4]))),
            lambda: ("-", ("fn", "exp", u), one),
            lambda: ("-", one, ("fn", "cos", u)),
            lambda: ("/", u, ("+", one, ("^", u, num(2)))),
        ])()

    nonnegative = False

    def smooth(self, depth=0):
        kind = self.random.random()
        if depth > 1 or kind < 0.3:
            return self.atom()
        if kind < 0.5:
            return (self.pick("++-"), self.smooth(depth + 1), self.atom())
        if kind < 0.7:
            return ("*", self.smooth(depth + 1), self.atom())
        if kind < 0.8:
            return ("/", self.atom(), ("+", self.number(1, 3), self.pick([R, ("^", R, num(2)), ("^", self.atom(), num(2))])))
        return self.outer(self.smooth(depth + 1))

    def kinked(self):
        b = self.length("b", 0.2, 0.9)
        u, kind = self.atom(), self.random.randrange(11)
        shift = ("-", R, b)
        if kind == 0:
            return ("+", u, self.scaled(("abs", shift)))
        if kind == 1:
            n = self.pick([1, 2, 2, 3, 4])
            bend = self.pick([("max", num(0), shift), ("max", shift, num(0))])
            return ("+", u, self.scaled(bend if n == 1 else ("^", bend, num(n))))
        if kind == 2:
            return ("min", u, self.number(0.1, 0.5))
        if kind == 3:
            return (self.pick(["min", "max"]), u, self.atom())
        if kind == 4:
            return ("abs", ("-", u, self.number(0.1, 0.5)))
        if kind == 5:
            return ("pw", num(0), b, self.scaled(("^", shift, num(self.pick([1, 2, 2, 3])))))
        if kind == 6:
            c = self.number(0.2, 2)
            return ("pw", ("^", R, num(2)), b, ("+", ("^", b, num(2)), ("*", c, shift)))
        if kind == 7:
            return ("pw", ("^", R, num(2)), b, ("-", ("*", ("*", num(2), b), R), ("^", b, num(2))))
        if kind == 8:
            return ("*", u, ("+", num(1), ("abs", shift)))
        if kind == 9:
            return ("-", ("fn", "sqrt", ("+", num(1), ("^", ("abs", shift), num(self.pick([1, 2, 3]))))), num(1))
        return ("+", u, ("pw", num(0), b, ("*", self.number(), ("^", shift, num(2)))))

    def typed(self):
        return self.spelled(self.kinked() if self.random.random() < 0.28 else self.smooth())

    def spelled(self, tree):
        used = names(tree)
        values = {k: v for k, v in self.values.items() if k in used}
        return Typed(tree, Speller(self.random).profile(tree), values, self.end, self.singular, self.removable)


def number_of(tree):
    if tree[0] == "num":
        return tree[1]
    return number_of(tree[1]) / number_of(tree[2])


def names(tree):
    out = {tree[1]} if tree[0] == "par" else set()
    for part in tree[1:]:
        if isinstance(part, tuple):
            out |= names(part)
    return out


class Speller:
    """Text of a tree, with spaces, signs, powers and names of functions as it happens."""

    def __init__(self, chance):
        self.random = chance
        self.spaces = chance.choice(["", "", " "])
        self.unicode = chance.random() < 0.1

    def profile(self, tree):
        text = self.write(tree)[0]
        return text

    def number(self, value):
        if value.denominator == 1:
            text = str(value)
            return text + (".0" if self.random.random() < 0.05 else "")
        digits = decimal(value)
        kind = self.random.random()
        if value < Fraction(1, 1000) and kind > 0.4:
            power = 1
            while value * 10 ** power < 1:
                power += 1
            return f"{decimal(value * 10 ** power)}e-{power}"
        if kind < 0.05:
            return digits + "0"
        if kind < 0.1:
            return decimal(value * 1000) + "e-3"
        return digits

    def join(self, left, sign, right):
        return f"{left}{self.spaces}{sign}{self.spaces}{right}"

    def bracket(self, text):
        return f"({text})"

    def write(self, tree):
        """Text and binding strength: 1 sum, 2 product, 3 sign, 4 power, 5 closed."""
        text, level = self.plain(tree)
        if level < 5 and self.random.random() < 0.03 or level == 5 and self.random.random() < 0.01:
            return self.bracket(text), 5
        return text, level

    def at(self, tree, least):
        text, level = self.write(tree)
        return text if level >= least else self.bracket(text)

    def plain(self, tree):
        kind, chance = tree[0], self.random.random()
        if kind == "num":
            return (self.number(tree[1]), 5) if tree[1] >= 0 else (f"-{self.number(-tree[1])}", 3)
        if kind == "pi":
            return ("π" if self.unicode else "pi"), 5
        if kind == "par":
            return ("θ" if self.unicode and tree[1] == "theta" else tree[1]), 5
        if kind == "r":
            return "r", 5
        if kind in "+-":
            sign = "−" if kind == "-" and self.unicode else kind
            if kind == "+" and chance < 0.2:
                return self.join(self.at(tree[2], 1), "+", self.at(tree[1], 2)), 1
            if kind == "-" and chance < 0.1:
                return f"-{self.at(tree[2], 4)}{self.spaces}+{self.spaces}{self.at(tree[1], 2)}", 1
            return self.join(self.at(tree[1], 1), sign, self.at(tree[2], 2)), 1
        if kind == "neg":
            return f"-{self.at(tree[1], 4)}", 1
        if kind == "*":
            sign = "·" if self.unicode and chance < 0.5 else "*"
            first, second = (tree[2], tree[1]) if chance > 0.85 else (tree[1], tree[2])
            return f"{self.at(first, 2)}{sign}{self.at(second, 3)}", 2
        if kind == "/":
            if chance < 0.06:
                return f"{self.at(tree[1], 2)}*{self.at(tree[2], 5)}^(-1)", 2
            return f"{self.at(tree[1], 2)}/{self.at(tree[2], 4)}", 2
        if kind == "^":
            base, power = self.at(tree[1], 5), tree[2]
            if power == num(2) and tree[1] == R and chance < 0.08:
                return "r*r", 2
            if power == num("0.5") and chance < 0.5:
                return f"sqrt({self.write(tree[1])[0]})", 5
            return f"{base}^{self.at(power, 5)}", 4
        if kind == "fn":
            name, inner = tree[1], self.write(tree[2])[0]
            other = {"ln": "log", "atan": "arctan", "asin": "arcsin", "acos": "arccos", "atanh": "artanh", "asinh": "arsinh"}
            if name == "sqrt":
                if chance < 0.15:
                    return f"({inner})^{self.random.choice(['(1/2)', '0.5'])}", 4
            if name == "exp" and chance < 0.25:
                return f"e^({inner})", 4
            if name in other and chance < 0.25:
                name = other[name]
            return f"{name}({inner})", 5
        if kind == "bessel":
            inner = self.write(tree[3])[0]
            letter = tree[1].upper()
            if tree[2] < 2 and chance < 0.5:
                return f"{letter}{tree[2]}({inner})", 5
            return f"bessel{tree[1]}({tree[2]},{self.spaces}{inner})", 5
        if kind == "abs":
            return f"abs({self.write(tree[1])[0]})", 5
        if kind in ("min", "max"):
            return f"{kind}({self.write(tree[1])[0]},{self.spaces}{self.write(tree[2])[0]})", 5
        if kind == "pw":
            limit = self.write(tree[2])[0]
            test = f"r<{limit}" if chance < 0.7 else f"r <= {limit}"
            return f"piecewise({self.write(tree[1])[0]}, {test}, {self.write(tree[3])[0]})", 5
        raise ValueError(kind)


def decimal(value):
    """A fraction with a finite decimal expansion, or the quotient in parentheses."""
    n, d, k = value.numerator, value.denominator, 0
    while d % 2 == 0 or d % 5 == 0:
        if 10 ** k % d == 0:
            break
        k += 1
        if k > 60:
            break
    if 10 ** k % d:
        return f"({n}/{d})"
    digits = str(n * 10 ** k // d).rjust(k + 1, "0")
    return digits if k == 0 else f"{digits[:-k]}.{digits[-k:]}"


BACKGROUNDS = ["tanh", "lncosh", "parabola", "hyperbola", "saturating", "gauss", "cosh", "atan", "cone", "ball"]


def hidden(seed):
    """A narrow spike, step or ripple on one of ten backgrounds; half of them beside a kink, a rim or the end of the domain."""
    chance = random.Random(seed)
    two, one = num(2), num(1)
    name, end = chance.choice(BACKGROUNDS), chance.choice([1.0, 1.5, 2.0])
    r2 = ("^", R, two)
    background = {
        "tanh": ("fn", "tanh", R), "lncosh": ("fn", "ln", ("fn", "cosh", R)), "parabola": ("/", r2, two),
        "hyperbola": ("-", ("fn", "sqrt", ("+", one, r2)), one), "saturating": ("/", r2, ("+", one, r2)),
        "gauss": ("-", one, ("fn", "exp", ("neg", r2))), "cosh": ("-", ("fn", "cosh", R), one), "atan": ("*", R, ("fn", "atan", R)),
        "cone": ("*", num("0.7"), R), "ball": ("-", two, ("fn", "sqrt", ("-", num(4), r2))),
    }[name]
    width = 10 ** chance.uniform(-10, -1)
    w = Fraction(f"{width:.2e}")
    near = chance.random() < 0.5
    c = Fraction(f"{chance.uniform(0.1, 0.9) * end:.12f}")
    if near:
        offset = Fraction(f"{width * chance.uniform(-3, 3):.3e}")
        where = chance.choice(["kink", "rim", "domain"])
        if where == "kink":
            b = Fraction(f"{chance.uniform(0.2, 0.8) * end:.3f}")
            background = ("+", background, ("*", num("0.3"), chance.choice([("max", num(0), ("-", R, ("num", b))), ("abs", ("-", R, ("num", b)))])))
            c = b + offset
        elif where == "rim":
            c = Fraction(str(end)) - abs(offset)
        else:
            background, end = ("-", two, ("fn", "sqrt", ("-", num(4), r2))), 2 - 1e-9
            c = 2 - abs(offset) - Fraction(1, 10 ** 8)
    if c <= 0:
        c = w
    u = ("/", ("-", R, ("num", c)), ("num", w))
    if chance.random() < 0.3:
        inverse = Fraction(f"{1 / width:.3e}")
        w = 1 / inverse
        u = ("*", ("num", inverse), ("-", R, ("num", c)))
    kind = chance.randrange(9)
    gauss = ("fn", "exp", ("neg", ("^", u, two)))
    feature = [
        lambda: gauss, lambda: ("/", one, ("+", one, ("^", u, two))), lambda: ("fn", "erf", u), lambda: ("fn", "tanh", u),
        lambda: ("fn", "atan", u), lambda: ("*", ("fn", "sin", u), ("fn", "exp", ("neg", ("^", ("/", u, num(4)), two)))),
        lambda: ("/", one, ("fn", "cosh", u)), lambda: ("fn", "sqrt", ("+", one, ("^", u, two))), lambda: ("*", u, gauss),
    ][kind]()
    height = Fraction(f"{10 ** chance.uniform(-6, -1):.2e}")
    if kind == 7:
        height = Fraction(f"{width:.1e}")
    tree = ("+", background, ("*", ("num", height), feature))
    marks = [float(c)]
    for k in (1, 4, 16, 64, 256):
        marks += [float(c) - k * float(w), float(c) + k * float(w)]
    profile = Typed(tree, Speller(chance).profile(tree), {}, end, marks=marks)
    spots = [float(c) + float(w) * chance.choice([-1, 1]) * 10 ** chance.uniform(-1, 1.5), chance.uniform(0.05, 1) * end, chance.uniform(float(c), end)]
    profile.places = [s if 0 < s <= end else chance.uniform(0.3, 1) * end for s in spots]
    profile.feature = (kind, float(w), "near" if near else "free", name)
    return profile


def kinks(seed):
    """One or two kinks at decimals that no double holds, on one of four backgrounds; places from a tenth to 1e-13 of the kink beside it."""
    chance = random.Random(seed)
    end = chance.choice([0.5, 1.0, 3.0, 40.0])
    ends = ("/", R, ("num", Fraction(str(end))))
    tree = chance.choice([
        ("*", num("0.3"), ("^", ends, num(2))), ("fn", "tanh", ends), ("-", ("fn", "cosh", ends), num(1)), ("*", num("0.2"), ("^", ends, num(10))),
    ])
    marks = []
    for _ in range(chance.choice([1, 1, 2])):
        b = Fraction(f"{chance.uniform(0.02, 0.95) * end:.{chance.choice([2, 3, 7])}f}")
        if b <= 0 or b in marks:
            continue
        apart = ("-", R, ("num", b))
        inside = ("max", num(0), apart)
        width = Fraction(f"{10 ** chance.uniform(-9, 0):.2e}")
        step = chance.choice([
            lambda: inside, lambda: ("abs", apart), lambda: ("^", inside, num(2)), lambda: ("^", inside, num("1.5")),
            lambda: ("fn", "tanh", ("/", inside, ("num", width))), lambda: ("fn", "ln", ("+", num(1), ("/", inside, ("num", width)))),
            lambda: ("min", R, ("num", b)), lambda: ("max", R, ("num", b)),
        ])()
        tree = ("+", tree, ("*", num(chance.choice(["0.7", "1.55", "0.013"])), step))
        marks.append(b)
    profile = Typed(tree, Speller(chance).profile(tree), {}, end, marks=[float(b) for b in marks])
    beside = lambda: float(chance.choice(marks)) * (1 + chance.choice([1, 1, -1]) * 10 ** chance.uniform(-13, -1))
    profile.places = [x if 0 < x < end else 0.77 * end for x in (beside(), beside())] + [chance.uniform(0.3, 1) * end]
    profile.radii = [beside() for _ in range(3)]
    return profile


def typed(seed):
    maker = Maker(seed)
    return placed(maker.typed(), maker.random)


def roots(seed):
    maker = Maker(seed)
    return placed(maker.spelled(maker.rooted()), maker.random)


def placed(profile, chance):
    """The profile with the places at which it is asked."""
    profile.places = [profile.end * chance.uniform(0.03, 1) for _ in range(3)]
    return profile


def settings(profile):
    """Return the options `--set` that give the parameters their values."""
    return [part for name, value in profile.values.items() for part in ("--set", f"{name}={value!r}")]
