"""x = k π/2 + r - r_excess, with k an integer and |r| up to little more than π/4.

r_excess is so signed that r = x keeps the sign of zero in what is computed from both."""

from collections.abc import Iterator
from dataclasses import dataclass
from fractions import Fraction
from functools import cache

from mpmath import libmp

from coscrew_codegen.elementary.steps import Steps, Value
from coscrew_codegen.formats import DOUBLE, Format, Precision
from coscrew_codegen.program import Program
from coscrew_codegen.quantity import ANGLE, SCALAR, Argument

X = Argument("x", SCALAR, ANGLE)
REDUCED = (Argument("quadrant", SCALAR), Argument("r", SCALAR), Argument("r_excess", SCALAR))

PI_DIGITS = 1400
HALF_PI = Fraction(int(libmp.pi_fixed(PI_DIGITS)), 2**(PI_DIGITS + 1))
"""π/2, to 2^-1400."""


@dataclass(frozen=True)
class Split:
    """π/2 in parts whose products with any |k| <= 2^k_bits are exact, and a rounded rest.

    k parts[0] and the differences x - k parts[0] and that minus k parts[1] are exact as well: x,
    at least 1/2 unless k = 0, and both products are multiples of 2^-digits, the differences below
    1.  All are positive, for the sake of signed zeros."""

    k_bits: int
    last_bits: tuple[int, ...]  # of the parts: 2^-n
    parts: tuple[Fraction, ...]
    rest: Fraction


def to_multiple(x: Fraction, unit: Fraction) -> Fraction:
    """x rounded to a multiple of the unit."""
    return round(x / unit) * unit


def nearest(x: Fraction, form: Format) -> Fraction:
    """x rounded to the format, with no limit to the exponent."""
    exponent = abs(x.numerator).bit_length() - x.denominator.bit_length()
    unit = Fraction(2)**(exponent - form.digits)
    while abs(x / unit) > 2**form.digits:
        unit *= 2
    return to_multiple(x, unit)


@cache
def split(form: Format) -> Split:
    """The split for |k| <= 2^25, in single precision 2^13."""
    k_bits = 25 if form.digits == DOUBLE.digits else 13
    last_bits: list[int] = []
    parts: list[Fraction] = []
    for finest in (form.digits, form.digits, 4 * form.digits):
        rest = HALF_PI - sum(parts)
        last_bits.append(min(finest, int(2**(form.digits - k_bits) / rest).bit_length() - 1))
        parts.append(Fraction(int(rest * 2**last_bits[-1]), 2**last_bits[-1]))
    return Split(k_bits, tuple(last_bits), tuple(parts), nearest(HALF_PI - sum(parts), form))


def limit(form: Format) -> Fraction:
    """The largest integer of which it is proved that |k| <= 2^k_bits."""
    k = 2**split(form).k_bits - Fraction(1, 2)
    return Fraction(int(k * HALF_PI))


def near(precision: Precision) -> Program:
    """The reduction by Cody and Waite, for |x| <= limit."""
    steps, parts = Steps(X), split(precision)
    x, = steps.inputs()
    k = steps.named("quadrant", to_integer(steps, x * nearest(1 / HALF_PI, precision), precision))
    first, second, third = parts.parts
    high = steps.named("high", (x - k * first) - k * second)  # exact
    low = steps.named("low", k * third)
    r = steps.named("r", high - low)
    excess = steps.named("r_excess", ((r - high) + low) + k * parts.rest)
    return steps.program("near", REDUCED, (k, r, excess))


def to_integer(steps: Steps, x: Value, form: Format, unit: int = 1) -> Value:
    """x rounded to a multiple of the unit, a power of two; |x| up to 2^(digits - 2) units."""
    shift = steps.constant(Fraction(3 * unit * 2**(form.digits - 2)), "shift")
    return (x + shift) - shift
