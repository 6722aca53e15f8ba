"""The two precisions: digits, limits, names in each language, look in plots.  No other module knows
these."""

from collections.abc import Collection
from dataclasses import dataclass, replace
from fractions import Fraction
from functools import cache
from math import ceil, log10
from typing import TYPE_CHECKING

from coscrew_codegen.program import Constant

if TYPE_CHECKING:  # readers of scene files, which only name precisions, start without it
    import numpy as np


@dataclass(frozen=True)
class Format:
    """A binary floating-point format."""

    digits: int  # significant bits
    least_exponent: int  # exponent of the least normal number

    @property
    def u(self) -> Fraction:
        """The unit roundoff: half the distance from 1 to the next number."""
        return Fraction(1, 2**self.digits)

    @property
    def stored_bits(self) -> int:
        """Bits of a number's significand that its encoding stores: all but the first."""
        return self.digits - 1

    @property
    def bias(self) -> int:
        """Number that is added to exponents of normal numbers in their encoding."""
        return 1 - self.least_exponent

    @property
    def decimals(self) -> int:
        """Significant decimals that tell any two numbers apart: 17, 9."""
        return ceil(self.digits * log10(2)) + 1

    @property
    def eta(self) -> Fraction:
        """Half the least subnormal number: the largest error by underflow."""
        return self.smallest_normal * self.u

    @property
    def smallest_normal(self) -> Fraction:
        """The least positive number with all digits."""
        return Fraction(2)**self.least_exponent

    def rounded_up(self, x: Fraction) -> Fraction:
        """x >= 0 rounded up to this many digits, with no limit to the exponent."""
        top, bottom = x.as_integer_ratio()
        exponent = top.bit_length() - bottom.bit_length() - self.digits - 1
        if exponent >= 0:  # 2^exponent is the unit, too small by 1 or 2 bits
            bottom <<= exponent
        else:
            top <<= -exponent
        while top > bottom << self.digits:
            bottom, exponent = bottom << 1, exponent + 1
        count = -(-top // bottom)
        return Fraction(count << exponent) if exponent >= 0 else Fraction(count, 1 << -exponent)


@dataclass(frozen=True)
class Precision(Format):
    """A floating-point format and its names in each language."""

    name: str  # double, single
    c_type: str
    suffix: str  # "f" or "": ends the names of C types and functions, and C literals
    numpy_type: str
    bytes: int
    colour: str = ""  # in plots whose colours do not stand for tiers or integrators
    dash: str = ""  # of lines in plots
    marker: str = ""
    lanes: str = ""  # "_lanes" if C's values are vectors with a number of each of several states
    device: str = ""  # "_device" if they are a class's, whose operations no flag of CUDA changes

    @property
    def called(self) -> str:
        """Ending of the names of C functions on its values: "f", "_lanesf"."""
        return f"{self.lanes}{self.device}{self.suffix}"

    def computing(self, wide: bool) -> "Precision":
        """The precision in which programs compute: this one or, if they are wide, double."""
        return self if not wide else on_device(DOUBLE) if self.device else DOUBLE

    @property
    def encoding(self) -> str:
        """The unsigned integers of this size: uint64, uint32."""
        return f"uint{8 * self.bytes}"

    def value(self, constant: Constant) -> Fraction:
        """The constant's value for this precision, exact and not yet rounded."""
        return {"double": constant.double, "single": constant.single}[self.name]

    def limit(self, name: str) -> Fraction:
        """A limit by NumPy's name: max, smallest_normal, smallest_subnormal."""
        return _limits(self)[name]

    def literal(self, constant: Constant) -> str:
        """The shortest decimal that rounds to the constant in this precision.

        Raises ValueError for a constant that overflows, or a nonzero one that underflows to 0."""
        return _literal(self, self.value(constant))

    def rounded(self, value: Fraction) -> "np.floating":
        """`value` rounded to nearest, ties to even."""
        return _rounded(self, value)


@cache
def _limits(precision: Precision) -> dict[str, Fraction]:
    normal = precision.smallest_normal
    return {"max": (2 - 2 * precision.u) * Fraction(2)**(1 - precision.least_exponent),
            "smallest_normal": normal, "smallest_subnormal": normal * 2 * precision.u}


@cache
def _rounded(precision: Precision, value: Fraction) -> "np.floating":
    import numpy as np

    number = getattr(np, precision.numpy_type)
    near = number(value.numerator / value.denominator)
    with np.errstate(over="ignore"):
        around = [near, *(np.nextafter(near, number(x)) for x in (-np.inf, np.inf))]
    return min((x for x in around if np.isfinite(x)), key=lambda x: (
        abs(Fraction(float(x)) - value), int(x.view(f"u{precision.bytes}")) & 1))


@cache
def _literal(precision: Precision, value: Fraction) -> str:
    if abs(value) <= precision.limit("max"):
        number = precision.rounded(value)
        if number or not value:
            return str(number)
    raise ValueError(f"a constant is outside {precision.name} precision's range")


DOUBLE = Precision(53, -1022, "double", "double", "", "float64", 8, "#0072b2", "-", "o")
SINGLE = Precision(24, -126, "single", "float", "f", "float32", 4, "#f5a04d", "--", "s")
PRECISIONS = (DOUBLE, SINGLE)


def in_lanes(precision: Precision) -> Precision:
    """The precision, with vectors as C's values."""
    return replace(precision, c_type=f"ksl_states{precision.suffix}", lanes="_lanes")


def on_device(precision: Precision) -> Precision:
    """The precision, with numbers of a class as C's values."""
    return replace(precision, c_type=f"ksl_number{precision.suffix}", device="_device")


BY_NAME = {precision.name: precision for precision in PRECISIONS}
CHOICES = (*BY_NAME, "both")
"""Names of precisions in options and scene files, with the precisions that each means."""


def named(names: Collection[str]) -> tuple[Precision, ...]:
    """The precisions of these names, double first."""
    return tuple(precision for precision in PRECISIONS if precision.name in names)
