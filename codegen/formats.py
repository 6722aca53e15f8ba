"""The two precisions, the only place that knows them: digits, limits, names in languages."""

from collections.abc import Collection
from dataclasses import dataclass
from fractions import Fraction
from functools import cache
from math import ceil

import numpy as np

from coscrew_codegen.program import Constant


@dataclass(frozen=True)
class Format:
    """A binary floating-point format."""

    digits: int  # significant bits
    least_exponent: int  # of the least normal number

    @property
    def u(self) -> Fraction:
        """The unit roundoff: half the distance from 1 to the next number."""
        return Fraction(1, 2**self.digits)

    @property
    def eta(self) -> Fraction:
        """Half the least subnormal number: what underflow loses, at most."""
        return self.smallest_normal * self.u

    @property
    def smallest_normal(self) -> Fraction:
        """The least number with all digits."""
        return Fraction(2)**self.least_exponent

    def rounded_up(self, x: Fraction) -> Fraction:
        """The least number with this many digits, of any exponent, that is not below x >= 0."""
        exponent = x.numerator.bit_length() - x.denominator.bit_length() - self.digits - 1
        unit = Fraction(2)**exponent  # too small by 1 bit, or 2
        while x / unit > 2**self.digits:
            unit *= 2
        return ceil(x / unit) * unit


@dataclass(frozen=True)
class Precision(Format):
    """A format that languages have, and what they call it."""

    name: str  # double, single
    c_type: str
    suffix: str  # of C types, functions and literals
    numpy_type: str
    buffer_format: str  # as Python's buffer protocol writes it
    bytes: int

    def value(self, constant: Constant) -> Fraction:
        """The constant's exact value in this precision, before rounding."""
        return {"double": constant.double, "single": constant.single}[self.name]

    def limit(self, name: str) -> Fraction:
        """A limit as NumPy calls it: max, smallest_normal, smallest_subnormal."""
        return Fraction(float(getattr(np.finfo(self.numpy_type), name)))

    def literal(self, constant: Constant) -> str:
        """The shortest decimal that rounds to the constant in this precision.

        Raises ValueError for a constant that would become infinite or, not being it, zero."""
        return _literal(self, self.value(constant))

    def rounded(self, value: Fraction) -> np.floating:
        """The number of this precision nearest to `value`; of two, the even one."""
        number = getattr(np, self.numpy_type)
        near = number(value.numerator / value.denominator)
        with np.errstate(over="ignore"):
            around = [near, *(np.nextafter(near, number(x)) for x in (-np.inf, np.inf))]
        return min((x for x in around if np.isfinite(x)), key=lambda x: (
            abs(Fraction(float(x)) - value), int(x.view(f"u{self.bytes}")) & 1))


@cache
def _literal(precision: Precision, value: Fraction) -> str:
    if abs(value) <= precision.limit("max"):
        number = precision.rounded(value)
        if number or not value:
            return str(number)
    raise ValueError(f"a constant is outside {precision.name} precision's range")


DOUBLE = Precision(53, -1022, "double", "double", "", "float64", "d", 8)
SINGLE = Precision(24, -126, "single", "float", "f", "float32", "f", 4)
PRECISIONS = (DOUBLE, SINGLE)
BY_NAME = {precision.name: precision for precision in PRECISIONS}


def named(names: Collection[str]) -> tuple[Precision, ...]:
    """The precisions of these names, double first."""
    return tuple(precision for precision in PRECISIONS if precision.name in names)
