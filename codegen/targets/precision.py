"""The two precisions: names, suffixes, literals."""

from dataclasses import dataclass
from fractions import Fraction
from functools import cache

import numpy as np

from coscrew_codegen.program import Constant


@dataclass(frozen=True)
class Precision:
    """A floating-point format as the languages call it."""

    name: str  # double, single
    c_type: str
    suffix: str  # of C types, functions and literals
    numpy_type: str
    bytes: int

    def value(self, constant: Constant) -> Fraction:
        """The constant's exact value in this precision, before rounding."""
        return {"double": constant.double, "single": constant.single}[self.name]

    @cache
    def literal(self, constant: Constant) -> str:
        """The shortest decimal that rounds to the constant in this precision."""
        return str(self.rounded(self.value(constant)))

    def rounded(self, value: Fraction) -> np.floating:
        """The number of this precision nearest to `value`; of two, the even one."""
        number = getattr(np, self.numpy_type)
        near = number(value.numerator / value.denominator)
        with np.errstate(over="ignore"):
            around = [near, *(np.nextafter(near, number(x)) for x in (-np.inf, np.inf))]
        return min((x for x in around if np.isfinite(x)), key=lambda x: (
            abs(Fraction(float(x)) - value), int(x.view(f"u{self.bytes}")) & 1))


DOUBLE = Precision("double", "double", "", "float64", 8)
SINGLE = Precision("single", "float", "f", "float32", 4)
PRECISIONS = (DOUBLE, SINGLE)
