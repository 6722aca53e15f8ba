"""x = k π/2 + r - r_excess, with k an integer and |r| up to little more than π/4.

The sign of r_excess is such that for r = x results computed from both keep the sign of zero."""

from dataclasses import dataclass
from fractions import Fraction
from functools import cache
from itertools import pairwise

from coscrew_codegen.program import Op, Program
from coscrew_codegen.program.elementary.evaluation.polynomial import integer_shift
from coscrew_codegen.program.elementary.evaluation.step_writer import StepValue, StepWriter
from coscrew_codegen.program.two_over_pi import chunks, pi
from coscrew_codegen.program.values.formats import DOUBLE, Precision
from coscrew_codegen.program.values.quantity import ANGLE, SCALAR, Argument

X = Argument("x", SCALAR, ANGLE)
REDUCED = (Argument("quadrant", SCALAR), Argument("r", SCALAR), Argument("r_excess", SCALAR))

HALF_PI = pi(2400) / 2
"""π/2, to 2^-2400."""


@dataclass(frozen=True)
class PiSplit:
    """π/2 in parts whose products with any |k| <= 2^k_bits are exact, and a rounded rest.

    k parts[0] and the differences x - k parts[0] and that minus k parts[1] are exact as well: x,
    which is at least 1/2 unless k = 0, and both products are multiples of 2^-digits, and the
    differences are below 1. All parts are positive, so that zeros have the right sign."""

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
def split(precision: Precision) -> PiSplit:
    """The split for |k| <= 2^22 (single precision 2^10); up to there k times the rest is at most
    1/32 of |x - k π/2|."""
    k_bits = 22 if precision.digits == DOUBLE.digits else 10
    last_bits: list[int] = []
    parts: list[Fraction] = []
    for finest in (precision.digits, precision.digits, 4 * precision.digits):
        rest = HALF_PI - sum(parts)
        last_bits.append(min(finest, int(2**(precision.digits - k_bits) / rest).bit_length() - 1))
        parts.append(Fraction(int(rest * 2**last_bits[-1]), 2**last_bits[-1]))
    return PiSplit(k_bits, tuple(last_bits), tuple(parts), nearest(HALF_PI - sum(parts), precision))


def limit(precision: Precision) -> Fraction:
    """The largest integer for which |k| <= 2^k_bits is proved."""
    k = 2**split(precision).k_bits - Fraction(1, 2)
    return Fraction(int(k * HALF_PI))


@cache
def near(precision: Precision) -> Program:
    """The reduction by Cody and Waite, for |x| <= limit."""
    steps, parts = StepWriter(X), split(precision)
    x, = steps.inputs()
    k = steps.named("quadrant", to_integer(steps, x * nearest(1 / HALF_PI, precision), precision))
    first, second, third = parts.parts
    high = steps.named("high", (x - k * first) - k * second)  # exact
    low = steps.named("low", k * third)
    r = steps.named("r", high - low)
    excess = steps.named("r_excess", ((r - high) + low) + k * parts.rest)
    return steps.program("near", REDUCED, (k, r, excess))


def to_integer(steps: StepWriter, x: StepValue, precision: Precision, unit: int = 1) -> StepValue:
    """x rounded to a multiple of the unit, a power of two; |x| up to 2^(digits - 2) units."""
    name = f"shift{unit}" if unit > 1 else "shift"
    shift = steps.constant(unit * integer_shift(precision), name)
    return (x + shift) - shift


LEVELS = {53: 7, 24: 8}
"""Number of sums of products with chunks of 2/π, by digits.  The last only matter where the others
nearly cancel."""
EXACT_LEVELS = {53: 5, 24: 6}
"""Number of these sums that are added without error."""


@cache
def far(precision: Precision) -> Program:
    """The reduction by the digits of 2/π, for |x| from the limit up.  Source: Payne and Hanek."""
    steps = StepWriter(X)
    x, = steps.inputs()
    t = levels(steps, x, precision, LEVELS[precision.digits])
    return steps.program("far", REDUCED, reduced(t, precision))


def levels(steps: StepWriter, x: StepValue, precision: Precision, count: int) -> list[StepValue]:
    """Exact numbers, each about 2^-digits/2 of the one before, whose sum is x 2/π less whole turns
    and a tail beyond the last."""
    scaled = steps.named("scaled", x * Fraction(1, 2**chunks(precision.digits).scale))
    high, low = halves("x", scaled, precision)
    at = [steps.named(f"chunk{n}", steps.do(Op.TWO_OVER_PI, x, n, precision.digits))
          for n in range(count + 1)]
    return [steps.named(f"t{n}", low * here + high * beyond)
            for n, (here, beyond) in enumerate(pairwise(at))]


def reduced(t: list[StepValue], precision: Precision) -> tuple[StepValue, StepValue, StepValue]:
    """The quadrant, r and r_excess, from the levels of x 2/π.

    Half of them are added without error: the rounding error of each sum is kept, and added to
    `low`. The first sum of `low` is exact, since its terms are multiples of a small number."""
    steps, exact = t[0].steps, EXACT_LEVELS[precision.digits]
    k1, k2, f, low = fraction(t, precision)
    f, error = two_sum("sum3", f, t[3])
    low = steps.named("low3", low + error)
    tail = t[-1]
    for level in reversed(t[exact:-1]):
        tail = tail + level
    tail = steps.named("tail", tail)
    for n, level in enumerate(t[4:exact], 4):
        low, error = two_sum(f"low{n}", low, level)
        tail = steps.named(f"tail{n}", tail + error)
    f, low = two_sum("f", f, low)
    low = steps.named("f_low", low + tail)
    r, excess = times_half_pi(steps, f, low, precision)
    return steps.named("quadrant", k1 + k2), r, excess


def fraction(t: list[StepValue], precision: Precision) -> tuple[StepValue, StepValue, StepValue,
                                                                StepValue]:
    """k1, k2, f and low: the first three levels are k1 + k2 + f + low and whole turns, |f| at most
    1/2."""
    steps = t[0].steps
    rest = steps.named("rest0", t[0] - to_integer(steps, t[0], precision, 8))  # 4 is out of reach
    rest = steps.named("rest4", rest - to_integer(steps, rest, precision, 4))
    k1 = steps.named("k1", to_integer(steps, t[1], precision))
    s, low = two_sum("sum2", rest + (t[1] - k1), t[2])
    k2 = steps.named("k2", to_integer(steps, s, precision))
    return k1, k2, steps.named("sum2_rest", s - k2), low


def times_half_pi(steps: StepWriter, f: StepValue, low: StepValue,
                  precision: Precision) -> tuple[StepValue, StepValue]:
    """(f + low) π/2 = r - excess, with |excess| at most half an ulp of r."""
    f_high, f_rest = halves("f_part", f, precision)
    pi = nearest(HALF_PI, precision)
    pi_high = to_multiple(pi, Fraction(2, 2**(precision.digits // 2)))
    pi_rest, pi_low = pi - pi_high, nearest(HALF_PI - pi, precision)
    product = steps.named("product", f * pi)
    error = steps.named("product_excess", (  # exact
        (product - f_high * pi_high) - f_high * pi_rest - f_rest * pi_high) - f_rest * pi_rest)
    rest = steps.named("rest", error - (f * pi_low + low * pi))
    r = steps.named("r", product - rest)
    return r, steps.named("r_excess", (r - product) + rest)


def two_sum(name: str, a: StepValue, b: StepValue) -> tuple[StepValue, StepValue]:
    """a + b rounded, and the rounding error.  Source: Knuth."""
    steps = a.steps
    s = steps.named(name, a + b)
    c = s - a
    return s, steps.named(f"{name}_error", (a - (s - c)) + (b - c))


def ordered_sum(name: str, a: StepValue, b: StepValue) -> tuple[StepValue, StepValue]:
    """a + b rounded, and the rounding error, for |a| >= |b|. Source: Dekker."""
    s = a.steps.named(name, a + b)
    return s, a.steps.named(f"{name}_error", b - (s - a))


def halves(name: str, x: StepValue, precision: Precision) -> tuple[StepValue, StepValue]:
    """x = high + low, of half the digits each.  Source: Veltkamp."""
    steps, digits = x.steps, precision.digits
    c = x * (2**(digits - digits // 2) + 1)
    high = steps.named(f"{name}_high", c - (c - x))
    return high, steps.named(f"{name}_low", x - high)
