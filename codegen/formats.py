"""The two precisions: names, suffixes, literals."""

from collections.abc import Collection
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

    def limit(self, name: str) -> Fraction:
        """A limit as NumPy calls it: max, smallest_normal, smallest_subnormal."""
        return Fraction(float(getattr(np.finfo(self.numpy_type), name)))

    @cache
    def literal(self, constant: Constant) -> str:
        """The shortest decimal that rounds to the constant in this precision.

        Raises ValueError for a constant that would become infinite or, not being it, zero."""
        value = self.value(constant)
        if abs(value) <= self.limit("max"):
            number = self.rounded(value)
            if number or not value:
                return str(number)
        raise ValueError(f"a constant is outside {self.name} precision's range")

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


def named(names: Collection[str]) -> tuple[Precision, ...]:
    """The precisions of these names, double first."""
    return tuple(precision for precision in PRECISIONS if precision.name in names)
