"""Contact mechanics from the shape of an indenter: formulas, and numbers with error bounds.

A profile is a formula for the shape f(r), such as ``r^2/(2*R)``; other names than r are positive parameters.

>>> import sneddon
>>> tip = sneddon.Profile("R - sqrt(R^2 - r^2)")
>>> print(tip.derive().g)
x*atanh(x/R)
>>> contact = sneddon.Contact(tip, R=2.0, E_star=1.5)
>>> contact.force(radius=0.5)
0.12598...
"""

from . import nanite, testing
from ._comparison import Comparison, compare
from ._contact import Contact
from ._errors import SneddonError
from ._formulas import Derivation, Formula
from ._inversion import Inversion, invert
from ._profile import Profile
from ._scenes import Field, Solution, Validation, reference, solve, validate
from ._sneddon import __version__
from ._sweep import sweep
from ._rules import rules

__all__ = [
    "Comparison",
    "Contact",
    "Derivation",
    "Field",
    "Formula",
    "Inversion",
    "Profile",
    "SneddonError",
    "Solution",
    "Validation",
    "__version__",
    "compare",
    "invert",
    "nanite",
    "reference",
    "rules",
    "solve",
    "sweep",
    "testing",
    "validate",
]
