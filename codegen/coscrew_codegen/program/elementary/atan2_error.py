"""atan2(y, x) - a, a being what `atan2` returns: (y cos a - x sin a) / (x cos a + y sin a) is the
tangent of the difference, and so small that it equals the difference."""

from fractions import Fraction
from functools import cache

from coscrew_codegen.program import Op, Program
from coscrew_codegen.program.elementary import atan2
from coscrew_codegen.program.elementary.elementary_function import Elementary
from coscrew_codegen.program.elementary.evaluation import reduction_pairs, sincos_pairs
from coscrew_codegen.program.elementary.evaluation.double_words import Pairs, power_of_two
from coscrew_codegen.program.elementary.evaluation.sincos_pairs import Computed
from coscrew_codegen.program.elementary.evaluation.step_writer import StepValue, StepWriter
from coscrew_codegen.program.values.formats import Precision
from coscrew_codegen.program.values.quantity import SCALAR, Argument

INPUTS = *atan2.INPUTS, *atan2.OUTPUTS
OUTPUTS = (Argument("angle_error", SCALAR),)
LARGEST = Fraction(355, 113)
"""The largest angle."""


@cache
def kernel(precision: Precision) -> Program:
    """(y, x, angle) -> atan2(y, x) - angle"""
    steps = StepWriter(*INPUTS)
    y, x, angle = steps.inputs()
    k, r, r_low = reduction_pairs.reduced_near(angle, precision)
    result = _normal(sincos_pairs.computed(r, r_low, _spread(precision), precision), precision)
    (s, s_low), (c, c_low) = _turned(k, result, precision)
    y, x = _scaled(y, x, precision)
    upward, across = steps.named("upward", y * c), steps.named("across", x * s)
    rests = [steps.named(f"{name}_rest", steps.do(Op.PRODUCT_ERROR, a, b, product))
             for name, a, b, product in (("upward", y, c, upward), ("across", x, s, across))]
    low = steps.named("low", (rests[0] - rests[1]) + (y * c_low - x * s_low))
    turn = steps.named("turn", ((upward - across) + low) / (x * c + y * s))
    return steps.program("atan2_error", OUTPUTS, [
        steps.named("angle_error", angle.equals(0).where(0, turn))])


def _turned(k: StepValue, of: Computed, precision: Precision
            ) -> tuple[tuple[StepValue, StepValue], tuple[StepValue, StepValue]]:
    """The sine and cosine of k π/2 + r, each as high and low."""
    steps, (a, b) = k.steps, sincos_pairs.turn(k, precision)
    low = of.sine.low, of.cosine.low
    assert low[0] is not None and low[1] is not None
    lows = low[0], low[1]
    sines = [steps.named(name, x * a - y * b) for name, x, y in (
        ("sin_x", of.sine.high, of.cosine.high), ("sin_x_low", *lows))]
    cosines = [steps.named(name, y * a + x * b) for name, x, y in (
        ("cos_x", of.sine.high, of.cosine.high), ("cos_x_low", *lows))]
    return (sines[0], sines[1]), (cosines[0], cosines[1])


def _spread(precision: Precision) -> reduction_pairs.Spread:
    return reduction_pairs.near_spread(precision, LARGEST)


def _normal(of: Computed, precision: Precision) -> Computed:
    """The pairs with each low part at most u of the whole."""
    pairs = Pairs(precision)
    return Computed(pairs.normal("sine", of.sine), pairs.normal("cosine", of.cosine))


def _scaled(y: StepValue, x: StepValue, precision: Precision) -> tuple[StepValue, StepValue]:
    """y and x times a power of two, so that products neither overflow nor underflow where they
    matter.  Infinities become numbers of the same sign; x = 0 with y = 0 becomes ±1."""
    data, steps, largest = atan2.DATA[precision], y.steps, precision.limit("max")
    (least, up), (most, down) = ((Fraction(2)**z for z in pair)
                                 for pair in (data.least, data.largest))
    sizes = abs(y), abs(x)
    size = steps.named("size", (sizes[0] < sizes[1]).where(sizes[1], sizes[0]))
    scale = (size < least).where(up, (size > most).where(down, 1))
    scale = steps.named("scale", (size > largest).where(0, scale))
    signs = [steps.do(Op.COPYSIGN, 1, z) for z in (y, x)]
    y = steps.named("scaled_y", (abs(y) > largest).where(signs[0], y * scale))
    x = (abs(x) > largest).where(signs[1], x * scale)
    return y, steps.named("scaled_x", size.equals(0).where(signs[1], x))


@cache
def error(precision: Precision) -> Fraction:
    """A proved bound of |angle + angle_error - atan2(y, x)| / |atan2(y, x)|, where angle_error is
    not subnormal.

    In units of the angle times √(x² + y²), y cos a and x sin a exceed 1 by little at most; they
    differ by at most 2 u and the errors of their pairs.  Their high parts' products differ by 8 u
    at most, so that their difference is exact (Sterbenz), unless they are below 16 u: then all
    errors are, except u 8 u of that difference.  Neither is the tangent's cube, nor what
    underflows, as large as u³."""
    u = precision.u
    sine, cosine = sincos_pairs.relative(_spread(precision), precision)
    rest, missed = 2 * u * (1 + 4 * u), sine.error + cosine.error
    turn = 2 * u + missed
    low = 3 * u + rest  # two errors of products, and two products, a difference, a sum: rounded
    numerator = u * (2 * u + 2 * rest + low) + u * turn
    denominator = 3 * u + rest  # relative: its terms have the same sign
    return (missed + numerator + turn * (u + denominator)) * (1 + 9 * u) + u**2 / 8


def comment(precision: Precision) -> str:
    return ("(y c - x s) / (x c + y s), s and c the angle's sine and cosine as pairs; angle + "
            f"angle_error is within {power_of_two(error(precision))} of atan2(y, x), relative to "
            "it (proved), and 0.51 of the least subnormal number; 0 where the angle is 0.")


ERROR = Elementary("atan2_error", "angle_error = atan2(y, x) - angle, angle as atan2 has it",
                   INPUTS, OUTPUTS, kernel, error, comment)
