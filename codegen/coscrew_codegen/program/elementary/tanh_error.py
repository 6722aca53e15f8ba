"""tanh x - y, y being what `tanh` returns: (m - y d) / d, with m = e^2|x| - 1 and d = m + 2, both
as pairs."""

from dataclasses import replace
from fractions import Fraction
from functools import cache

from coscrew_codegen.program import Op, Program
from coscrew_codegen.program.elementary import exp, exp_error, tanh
from coscrew_codegen.program.elementary.elementary_function import Elementary
from coscrew_codegen.program.elementary.evaluation.double_words import Pair, Pairs, power_of_two
from coscrew_codegen.program.elementary.evaluation.polynomial import integer_shift
from coscrew_codegen.program.elementary.evaluation.step_writer import StepValue, StepWriter
from coscrew_codegen.program.values.formats import Precision
from coscrew_codegen.program.values.quantity import SCALAR, Argument

INPUTS = *tanh.INPUTS, *tanh.OUTPUTS
OUTPUTS = (Argument("y_error", SCALAR),)


def end(precision: Precision) -> int:
    """The argument from which on tanh is 1 to more than twice the digits."""
    return 2 * tanh.DATA[precision].one


@cache
def kernel(precision: Precision) -> Program:
    """(x, y) -> tanh x - y"""
    steps, pairs = StepWriter(*INPUTS), Pairs(precision)
    x, y = steps.inputs()
    size = steps.named("size", abs(x))
    tiny = steps.named("tiny", size < pairs.tiny)
    beyond = steps.named("beyond", size > end(precision))
    within = steps.named("within", beyond.where(end(precision), tiny.where(1, size)))
    result = steps.named("result", tiny.where(1, abs(y)))
    shifted, _, r = exp_error.reduced(steps.named("twice", within + within), precision)
    power = steps.named("power", steps.do(Op.POWER, shifted, integer_shift(precision)))
    one, minus_one = (Pair(steps.constant(n), None, Fraction(1)) for n in (1, -1))
    whole = pairs.sum("whole", Pair(power, None, Fraction(1)), minus_one, ordered=True)
    growth = exp_error.growth(r, precision)
    m, d = _sums(whole, replace(
        growth, high=steps.named("more", steps.do(Op.SCALE, growth.high, power)),
        low=steps.named("more_low", _scaled(growth.low, power))), one, precision)
    assert m.low is not None and d.low is not None
    product = steps.named("product", result * d.high)
    exact = steps.named("product_rest", steps.do(Op.PRODUCT_ERROR, result, d.high, product))
    rest = ((m.high - product) - exact) + (m.low - result * d.low)
    error = steps.named("error", rest / d.high)
    error = steps.named("known", tiny.where(0, beyond.where(0, error)))
    return steps.program("tanh_error", OUTPUTS, [
        steps.named("y_error", error * steps.do(Op.COPYSIGN, 1, x))])


def _scaled(x: StepValue | None, power: StepValue) -> StepValue:
    assert x is not None
    return x.steps.do(Op.SCALE, x, power)


def _sums(whole: Pair, more: Pair, one: Pair, precision: Precision) -> tuple[Pair, Pair]:
    """m = whole + more = 2^k - 1 + 2^k (e^r - 1), and d = m + 2; bounds in the unit of 2^k.  Low
    parts are at most u of m and d."""
    pairs, two = Pairs(precision), one.high.steps.constant(2)
    m = pairs.normal("m", pairs.sum("m_sum", whole, more))
    return m, pairs.normal("d", pairs.sum("d_sum", Pair(two, None, 2 * one.size), m))


@cache
def error(precision: Precision) -> Fraction:
    """A proved bound of |y + y_error - tanh x| / |tanh x|."""
    x, _ = StepWriter(*INPUTS).inputs()
    _, _, r = exp_error.reduced(x, precision)
    growth, u, size = exp_error.growth(r, precision), precision.u, exp.INTERVAL[1]
    least = 1 - size + size**2 / 2 - size**3 / 6  # of e^r
    results = [_near_zero(r, precision)]
    for k, whole in ((1, Pair(x, None, Fraction(1, 2))), (2, Pair(x, x, Fraction(1), u))):
        one = Fraction(1, 2**k)  # in the unit of 2^k; for k > 2, m and d are larger
        m, d = _sums(whole, growth, Pair(x, None, one), precision)
        results.append((m.scaled(m.size / (least - one)), d.scaled(d.size / least)))
    return max(_quotient(m, d, precision) for m, d in results)


def _near_zero(r: Pair, precision: Precision) -> tuple[Pair, Pair]:
    """m and d for k = 0, in units of their least sizes: r, which is exact, and 2."""
    pairs, growth = Pairs(precision), exp_error.growth(r, precision, relative=True)
    m = pairs.sum("m", Pair(r.high, None, Fraction(0)), growth)
    d = pairs.sum("d", Pair(r.high, None, Fraction(2)), m.scaled(m.size * exp.INTERVAL[1]))
    return m, d.scaled(d.size / 2)


def _quotient(m: Pair, d: Pair, precision: Precision) -> Fraction:
    """A bound of the relative error of y + (m - y d) / d, y being within an ulp of m / d: with m
    and y d as unit.

    m_high - y d_high is exact, since both are close, and so is the error of that product."""
    u, second = precision.u, m.error + d.error  # y d is m to 2 u
    low = u * (1 + 2 * u)  # relative: those of m and d
    left = 2 * u + 2 * low  # of the high parts, with the product's error: m - y d and low parts
    roundings = u * left + u * low + u * 2 * low + u * (2 * u + second)
    division = (2 * u + second) * (u + low)
    return (second + roundings + division) * (1 + 8 * u)


def comment(precision: Precision) -> str:
    return (f"m / d = (e^2|x| - 1) / (e^2|x| + 1), m and d as pairs; y + y_error is within "
            f"{power_of_two(error(precision))} of tanh x, relative to it (proved); 0 for |x| below "
            f"{power_of_two(Pairs(precision).tiny)} and above {end(precision)}.")


ERROR = Elementary("tanh_error", "y_error = tanh x - y, y as tanh has it", INPUTS, OUTPUTS, kernel,
                   error, comment)
