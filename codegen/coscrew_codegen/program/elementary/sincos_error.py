"""sin x - s and cos x - c, s and c being what `sincos` returns.

With x = k π/2 + r + r_low, s and c turned back by k right angles are S and C, near the sine and
cosine of r + r_low; C is the larger.  S errs by E = sin r - S + r_low C, where the sine is r + r³
(…), a series in pairs.  Then C errs by ((1 - C² - S²)/2 - S E) / C, since the squares of the exact
sine and cosine add to 1: no second series is needed."""

from dataclasses import dataclass, replace
from fractions import Fraction
from functools import cache

from coscrew_codegen.program import Op, Program
from coscrew_codegen.program.elementary import sincos
from coscrew_codegen.program.elementary.elementary_function import Elementary
from coscrew_codegen.program.elementary.evaluation import reduction, reduction_pairs
from coscrew_codegen.program.elementary.evaluation.double_words import Pair, Pairs, power_of_two
from coscrew_codegen.program.elementary.evaluation.reduction import X
from coscrew_codegen.program.elementary.evaluation.reduction_pairs import REDUCED, Spread
from coscrew_codegen.program.elementary.evaluation.sincos_pairs import ANGLE, SINES, turn
from coscrew_codegen.program.elementary.evaluation.step_writer import StepValue, StepWriter
from coscrew_codegen.program.values.formats import Precision
from coscrew_codegen.program.values.quantity import SCALAR, Argument

OUTPUTS = Argument("s_error", SCALAR), Argument("c_error", SCALAR)
NEGLIGIBLE = Fraction(4)
"""Terms of the series up to so many u, relative to r, have no low parts."""


@dataclass(frozen=True)
class Beyond:
    """sin r - r = more + last, in the unit of the angle that r is near; 0 for tiny r."""

    angle: StepValue  # r, or 0 if it is tiny
    more: Pair
    last: StepValue  # computed last; its rounding is counted in more's error
    size: Fraction  # of last


def beyond_r(r: StepValue, spread: Spread, precision: Precision) -> Beyond:
    """The steps from r to its sine."""
    pairs = Pairs(precision)
    angle = Pair(pairs.vanishing("argument", Pair(r, None, ANGLE)), None, ANGLE)
    z, terms = pairs.product("z", angle, angle), SINES.terms(precision)
    cube = pairs.product("cube", Pair(angle.high, None, spread.high), z)
    left_out = (SINES.left_out(len(terms)) + pairs.tiny**2) / z.size
    series = pairs.horner("sin", terms, z, NEGLIGIBLE).less(left_out)
    assert series.low is not None
    more = pairs.product("more", cube, replace(series, low=None, rest=Fraction(0)))
    size = cube.size * series.rest
    missed = (cube.rest + cube.error) * series.rest + pairs.rounding(size)
    return Beyond(angle.high, more.less(missed), cube.high * series.low,
                  size + pairs.rounding(size))


@cache
def kernel(precision: Precision) -> Program:
    """(quadrant, r, r_low, s, c) -> (sin x - s, cos x - c)"""
    steps = StepWriter(*REDUCED, *sincos.SIN_COS)
    k, r, r_low, s, c = steps.inputs()
    a, b = turn(k, precision)
    sine, cosine = steps.named("sin_r", s * a + c * b), steps.named("cos_r", c * a - s * b)
    beyond = beyond_r(r, reduction_pairs.spread(precision), precision)
    more, last = beyond.more, steps.named("last", beyond.last)
    assert more.low is not None
    difference = steps.named("difference", r - sine)  # exact
    known = steps.named("known_sin_r", beyond.angle - difference)
    error = steps.named("sin_r_error", (
        (difference + more.high) + (more.low + r_low * cosine)) + last)
    other = _other_error(known, error, cosine)
    return steps.program("kernel", OUTPUTS, (steps.named("s_error", error * a - other * b),
                                             steps.named("c_error", other * a + error * b)))


def _other_error(sine: StepValue, error: StepValue, cosine: StepValue) -> StepValue:
    """Returns the error of the cosine from the sine and its error: 1 - C² - S² is 2 h - S² - h²
    with h = 1 - C. Only a product and a sum wait for the sine's error."""
    steps = sine.steps
    h, inverse = steps.named("h", 1 - cosine), steps.named("inverse", 1 / cosine)
    squares, rests = [], []
    for name, x in (("square", sine), ("h_square", h)):
        squares.append(steps.named(name, x * x))
        rests.append(steps.named(f"{name}_error", steps.do(Op.PRODUCT_ERROR, x, x, squares[-1])))
    excess = steps.named("excess", ((h + h) - squares[0] - squares[1]) - (rests[0] + rests[1]))
    slope = steps.named("tangent", sine * inverse)
    return steps.named("cos_r_error", excess * (inverse * Fraction(1, 2)) - slope * error)


def errors(precision: Precision) -> tuple[Fraction, Fraction]:
    """Proved bounds of |S + its error - sin R|, in units of the exact R = r + r_low, and of |C +
    its error - cos R|.

    S and C err by σ ulps at most.  r - S is exact (Sterbenz), R and S being close."""
    u, rounding = precision.u, Pairs(precision).rounding
    spread, (_, r, _) = reduction_pairs.spread(precision), StepWriter(*REDUCED).inputs()
    beyond = beyond_r(r, spread, precision)
    ulps = sincos.DATA[precision].error * u  # of numbers in [1/2, 1); relative at most twice that
    low = spread.low * (1 + u)
    lows = beyond.more.rest + low
    first = 2 * ulps + beyond.size + u / 8  # without `last`; u / 8 is more than all errors
    roundings = map(rounding, (low, lows, first + lows, first, 2 * ulps + u / 8))
    beside = spread.error + spread.low**2 + ulps * low  # r_low C
    sine = beyond.more.error + beside + sum(roundings)
    return sine, _of_cosine(sine, ulps, precision)


def _of_cosine(sine: Fraction, ulps: Fraction, precision: Precision) -> Fraction:
    """Bounds the error of the cosine's error, given the bound of the sine's.

    2 h - S² is exact (Sterbenz) if R² is at least 16 ulps, else at most 2 ulps and little; 1 - C²
    - S² is at most 2 (C + S) ulps, so 3.  The squares of both errors are neglected, as is S² for
    tiny R."""
    u, tiny, largest = precision.u, Pairs(precision).tiny, ANGLE**2
    assert 1 + 8 * u <= 2 * (1 - largest / 12 - Fraction(1, 8))
    assert 1 + Fraction(1, 8) <= 2 * (1 - largest / 3) * (1 - 8 * u)
    square = largest**2 / 4 * (1 + 16 * u)  # h²
    rests = u * (largest + square)
    excess = u * (2 * ulps + u / 8 + (3 * ulps + rests) + rests + 3 * ulps) + tiny**2
    cosine = 1 - largest / 2 - ulps  # at least
    lost = excess / 2 + largest * sine + ulps**2 + tiny**2
    lost += 4 * u * (3 * ulps / 2 + ANGLE * ulps)  # of the inverse, products and their difference
    return lost / cosine


@cache
def error(precision: Precision) -> Fraction:
    """A proved bound of |s + s_error - sin x| / |sin x|, and of the same for the cosine."""
    sine, cosine = errors(precision)
    return max(sine / (1 - ANGLE**2 / 6), cosine / (1 - ANGLE**2 / 2)) * (1 + 16 * precision.u)


def comment(precision: Precision) -> str:
    degree = 2 * len(SINES.terms(precision)) + 1
    return (f"x = k pi/2 + r, r as a pair; Taylor's polynomial of degree {degree} in pairs for "
            "sin r, whose error gives that of cos r, as their squares are 1 together; s + s_error "
            f"and c + c_error are within {power_of_two(error(precision))} of sin x and cos x, "
            "relative to these (proved), for every finite x.")


ERROR = Elementary(
    "sincos_error", "(s_error, c_error) = (sin x - s, cos x - c), (s, c) as sincos has them",
    (X, *sincos.SIN_COS), OUTPUTS, kernel, error, comment, near=reduction_pairs.near,
    far=reduction_pairs.far, limit=reduction.limit)
