"""Values in fixed point: integers times 2^-f, with bounds of their size and error.

The exact value x and the computed integer X satisfy |x| <= size and |X 2^-f - x| <= error, so that
|X| <= (size + error) 2^f, which is at most 2^31 - 2."""

from dataclasses import dataclass
from fractions import Fraction
from math import frexp, inf, ldexp, nextafter, sqrt
from typing import NamedTuple

from coscrew_codegen.program import Constant, Op, Operand
from coscrew_codegen.program.roundoff import Upward

NONE = Upward(0)
LARGEST = 2**31 - 2
"""Largest size of an integer: 2^31 - 1 would overflow by half of the last bit of a shift."""
MOST_BITS = 62
"""Largest f; 2^-63 is below every bound of use."""
OF_ANGLES = 30
"""Largest f of an angle: the reduction by multiples of π/2 has 31 bits."""


class FixedValue(NamedTuple):
    """The operand that has a value, its f, and its bounds; and the argument, if the value is a sine
    or cosine or a multiple of one."""

    operand: Operand
    bits: int  # f
    size: Upward
    error: Upward = NONE
    circular: tuple[Op, Operand] | None = None
    factor: "FixedValue | None" = None  # of a multiple: the other factor
    rest: Upward = NONE  # of a multiple: error less that of the other factor

    @property
    def reach(self) -> Upward:
        """The largest size of the computed value."""
        return self.size + self.error

    @property
    def largest(self) -> float:
        """The largest size of the integer."""
        return ldexp(self.reach, self.bits)


def bits_for(size: float) -> int:
    """The largest f, up to MOST_BITS, for which numbers up to this size are 32-bit integers; 30
    for 0."""
    significand, exponent = frexp(size)
    fits = ldexp(significand, 31) <= LARGEST
    return min(31 - exponent - (not fits), MOST_BITS) if size else OF_ANGLES


def fits(size: float, bits: int) -> bool:
    """Returns whether numbers up to this size are 32-bit integers with this f."""
    return ldexp(size, bits) <= LARGEST


def half_unit(bits: int) -> Upward:
    """Half of the last bit."""
    return Upward(ldexp(1, -bits - 1))


def above(x: Fraction) -> Upward:
    """|x| rounded up."""
    near = float(abs(x))
    return Upward(near if Fraction(near) >= abs(x) else nextafter(near, inf))


def quantized(x: Fraction, bits: int) -> FixedValue:
    """The constant as an integer with this f."""
    integer = round(x * Fraction(2)**bits)
    return FixedValue(of_integer(integer), bits, above(x),
                      above(integer / Fraction(2)**bits - x))


def of_integer(integer: int) -> Constant:
    """An operand that is this integer."""
    return Constant(Fraction(integer), Fraction(integer))


@dataclass(frozen=True)
class AlignedTerm:
    """Shifts to the right, or to the left if negative, that give a term the f of its sum; their
    error; and the constant that replaces the operand, if one does."""

    shifts: tuple[int, ...]
    error: Upward
    operand: Operand | None = None


def shifts(x: FixedValue, bits: int) -> AlignedTerm:
    """The term of a value that is no constant.  Where half of the last bit could overflow, the
    shift is made in two."""
    shift = x.bits - bits
    if x.largest > LARGEST:  # of 64 bits
        return AlignedTerm((shift,), half_unit(bits))
    if shift <= 0:
        return AlignedTerm((shift,) if shift else (), NONE)
    if shift > 31:  # below half of the last bit
        return AlignedTerm((), half_unit(bits), of_integer(0))
    if x.largest + 2.0**(shift - 1) <= LARGEST:
        return AlignedTerm((shift,), half_unit(bits))
    return AlignedTerm((1, shift - 1), half_unit(bits) + half_unit(x.bits - 1))


def sum_of(a: FixedValue, b: FixedValue) -> FixedValue:
    """The bounds of a sum or difference, roundings apart."""
    size, error = a.size + b.size, a.error + b.error
    if a.factor and b.factor and a.circular and b.circular and \
            a.circular[0] is not b.circular[0] and a.circular[1] == b.circular[1]:
        size = min(size, _length(a.factor.size, b.factor.size))
        error = min(error, _length(a.factor.error, b.factor.error) + a.rest + b.rest)
    return FixedValue(a.operand, 0, size, error)


def rounded(x: FixedValue, operand: Operand, bits: int, rounding: Upward) -> FixedValue:
    """The value with another f, after a rounding with this error."""
    return x._replace(operand=operand, bits=bits, error=x.error + rounding,
                      rest=x.rest + rounding)


def _length(a: Upward, b: Upward) -> Upward:
    return Upward(nextafter(sqrt(a * a + b * b), inf))
