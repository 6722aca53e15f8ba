"""x = k π/2 + r - r_excess, with k an integer and |r| up to little more than π/4.

r_excess is so signed that r = x keeps the sign of zero in what is computed from both."""

from dataclasses import dataclass
from fractions import Fraction
from functools import cache
from itertools import pairwise

from coscrew_codegen.elementary.polynomial import integer_shift
from coscrew_codegen.elementary.steps import Steps, Value
from coscrew_codegen.formats import DOUBLE, Precision
from coscrew_codegen.program import Op, Program
from coscrew_codegen.program.two_over_pi import chunks, pi
from coscrew_codegen.quantity import ANGLE, SCALAR, Argument

X = Argument("x", SCALAR, ANGLE)
REDUCED = (Argument("quadrant", SCALAR), Argument("r", SCALAR), Argument("r_excess", SCALAR))

HALF_PI = pi(1400) / 2
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


def nearest(x: Fraction, precision: Precision) -> Fraction:
    """The number of the precision that is nearest to x."""
    return Fraction(float(precision.rounded(x)))


def to_multiple(x: Fraction, unit: Fraction) -> Fraction:
    """x rounded to a multiple of the unit."""
    return round(x / unit) * unit


@cache
def split(precision: Precision) -> Split:
    """The split for |k| <= 2^25, in single precision 2^13."""
    k_bits = 25 if precision.digits == DOUBLE.digits else 13
    last_bits: list[int] = []
    parts: list[Fraction] = []
    for finest in (precision.digits, precision.digits, 4 * precision.digits):
        rest = HALF_PI - sum(parts)
        last_bits.append(min(finest, int(2**(precision.digits - k_bits) / rest).bit_length() - 1))
        parts.append(Fraction(int(rest * 2**last_bits[-1]), 2**last_bits[-1]))
    return Split(k_bits, tuple(last_bits), tuple(parts), nearest(HALF_PI - sum(parts), precision))


def limit(precision: Precision) -> Fraction:
    """The largest integer of which it is proved that |k| <= 2^k_bits."""
    k = 2**split(precision).k_bits - Fraction(1, 2)
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


def to_integer(steps: Steps, x: Value, precision: Precision, unit: int = 1) -> Value:
    """x rounded to a multiple of the unit, a power of two; |x| up to 2^(digits - 2) units."""
    shift = steps.constant(unit * integer_shift(precision), "shift")
    return (x + shift) - shift


LEVELS = {53: 7, 24: 8}
"""How many sums of products with chunks of 2/π are taken: the last ones only matter where the
others nearly cancel."""


def far(precision: Precision) -> Program:
    """The reduction by the digits of 2/π, for |x| from the limit up.  Source: Payne and Hanek."""
    steps, digits = Steps(X), precision.digits
    x, = steps.inputs()
    t = levels(steps, x, precision)
    t0 = t[0] - to_integer(steps, t[0], precision, 8)  # 4 does not reach its largest value
    t0 = t0 - to_integer(steps, t0, precision, 4)
    turns = to_integer(steps, t[1], precision)
    s, e2 = two_sum(t0 + (t[1] - turns), t[2])
    n = to_integer(steps, s, precision)
    k = steps.named("quadrant", turns + n)
    f, e3 = two_sum(s - n, t[3])
    low, tail = e2 + e3, t[-1] + t[-2]  # low is exact
    errors = []
    for level in t[4:-2]:
        low, e = two_sum(low, level)
        errors.append(e)
    f, low = two_sum(steps.named("f", f), low)
    for e in reversed(errors):
        tail = tail + e
    f_low = steps.named("f_low", low + tail)
    high, rest = halves(f, digits)
    pi_high, pi_rest = exact_halves(nearest(HALF_PI, precision), digits)
    pi_low = nearest(HALF_PI - pi_high - pi_rest, precision)
    r = steps.named("r", f * (pi_high + pi_rest))
    exact = ((r - high * pi_high) - high * pi_rest) - rest * pi_high
    excess = (exact - rest * pi_rest) - (f * pi_low + f_low * (pi_high + pi_rest))
    return steps.program("far", REDUCED, (k, r, steps.named("r_excess", excess)))


def levels(steps: Steps, x: Value, precision: Precision) -> list[Value]:
    """Exact numbers, each about 2^-digits/2 of the one before, whose sum is x 2/π except whole
    turns and what is beyond the last."""
    scaled = x * Fraction(1, 2**chunks(precision.digits).scale)
    high, low = halves(scaled, precision.digits)
    at = [steps.do(Op.TWO_OVER_PI, x, n, precision.digits)
          for n in range(LEVELS[precision.digits] + 1)]
    return [steps.named(f"t{n}", low * here + high * beyond)
            for n, (here, beyond) in enumerate(pairwise(at))]


def two_sum(a: Value, b: Value) -> tuple[Value, Value]:
    """a + b rounded, and what that misses.  Source: Knuth."""
    s = a + b
    c = s - a
    return s, (a - (s - c)) + (b - c)


def halves(x: Value, digits: int) -> tuple[Value, Value]:
    """x = high + low, of half the digits each.  Source: Veltkamp."""
    c = x * (2**(digits - digits // 2) + 1)
    high = c - (c - x)
    return high, x - high


def exact_halves(x: Fraction, digits: int) -> tuple[Fraction, Fraction]:
    """x, between 1 and 2, likewise."""
    high = to_multiple(x, Fraction(2, 2**(digits // 2)))
    return high, x - high
