"""Values in fixed point: integers times 2^-f, with bounds of their size and error.

The exact value x and the computed integer X satisfy |x| <= size and |X 2^-f - x| <= error, so that
|X| <= (size + error) 2^f, which is at most 2^31 - 2."""

from fractions import Fraction
from math import frexp, inf, ldexp, nextafter
from typing import NamedTuple

from coscrew_codegen.program import Constant, Operand
from coscrew_codegen.program.roundoff import NONE, RoundedRange, Upward

LARGEST = 2**31 - 2
"""Largest size of an integer: 2^31 - 1 would overflow by half of the last bit of a shift."""
MOST_BITS = 62
"""Largest f; 2^-63 is below every bound of use."""
OF_ANGLES = 30
"""Largest f of an angle: the reduction by multiples of π/2 has 31 bits."""


class FixedValue(NamedTuple):
    """The operand that has a value, its f, and its bounds."""

    operand: Operand
    bits: int  # f
    bounds: RoundedRange
    stands_for: str = ""  # of an integer: the decimal, or the name of the value that it replaces

    @property
    def size(self) -> Upward:
        """The bound of the exact value."""
        return self.bounds.size

    @property
    def error(self) -> Upward:
        """The bound of the error."""
        return self.bounds.error

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
    return FixedValue(of_integer(integer), bits, RoundedRange(above(x), above(
        integer / Fraction(2)**bits - x)), str(x))


def of_integer(integer: int) -> Constant:
    """An operand that is this integer."""
    return Constant(Fraction(integer), Fraction(integer))


def vanishes(x: FixedValue, bits: int) -> bool:
    """Returns whether a value of 32 bits is below half of the last bit with this f."""
    return x.largest <= LARGEST and x.bits - bits > 31


def shifts(x: FixedValue, bits: int) -> tuple[int, ...]:
    """The shifts to the right that give a value this f.  Where half of the last bit could overflow,
    the shift is made in two; but not with 64 bits."""
    shift = x.bits - bits
    if x.largest > LARGEST or x.largest + 2.0**(shift - 1) <= LARGEST:
        return (shift,) if shift else ()
    return (1, shift - 1) if shift > 1 else (shift,)


def shift_error(x: FixedValue, bits: int) -> Upward:
    """Bounds the error of giving a value this f."""
    if bits >= x.bits:
        return NONE
    if vanishes(x, bits):
        return half_unit(bits)
    error, at = NONE, x.bits
    for shift in shifts(x, bits):
        at -= shift
        error = error + half_unit(at)
    return error
