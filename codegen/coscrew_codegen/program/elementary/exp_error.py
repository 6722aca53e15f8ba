"""exp x - y, y being what `exp` returns: 2^k (e^r - y / 2^k), e^r being computed as a pair."""

from collections.abc import Sequence
from dataclasses import dataclass, replace
from fractions import Fraction
from functools import cache

from coscrew_codegen.program import Op, Program
from coscrew_codegen.program.elementary import exp
from coscrew_codegen.program.elementary.elementary_function import Elementary
from coscrew_codegen.program.elementary.evaluation.double_words import (
    Pair,
    Pairs,
    Series,
    power_of_two,
    upward,
)
from coscrew_codegen.program.elementary.evaluation.polynomial import integer_shift
from coscrew_codegen.program.elementary.evaluation.reduction import nearest
from coscrew_codegen.program.elementary.evaluation.step_writer import StepValue, StepWriter
from coscrew_codegen.program.elementary.proofs.minimax import ln2
from coscrew_codegen.program.elementary.proofs.reduction_proof import exponent_of
from coscrew_codegen.program.values.formats import Precision
from coscrew_codegen.program.values.quantity import SCALAR, Argument

INPUTS = *exp.INPUTS, *exp.OUTPUTS
OUTPUTS = (Argument("y_error", SCALAR),)
GROWTH = Series(exp.INTERVAL[1], 2, 1, 1)  # e^r - 1 = r + r (…)


@dataclass(frozen=True)
class ExpParts:
    """ln 2 in parts whose products with any k are exact, and a rounded rest."""

    first: Fraction
    second: Fraction
    rest: Fraction
    missing: Fraction
    most: int  # |k|


@cache
def parts(precision: Precision) -> ExpParts:
    """The leading part of `exp`'s split, and one more."""
    low, high = ln2()
    most = 3 * max(map(abs, exp.DATA[precision].limits)) // 2 + 1
    first = exp.DATA[precision].ln2[0]
    unit = Fraction(2)**(exponent_of(low - first) + 1 + most.bit_length() - precision.digits)
    second = (low - first) // unit * unit
    rest = nearest(low - first - second, precision)
    missing = upward(max(abs(x - first - second - rest) for x in (low, high)))
    return ExpParts(first, second, rest, missing, most)


def reduced(x: StepValue, precision: Precision) -> tuple[StepValue, StepValue, Pair]:
    """k plus the integers' shift, k, and r as a pair, for x within the limits of `exp`."""
    steps, data, pairs = x.steps, parts(precision), Pairs(precision)
    shift = integer_shift(precision)
    shifted = steps.named("shifted", x * exp.DATA[precision].to_binary + shift)
    k = steps.named("k", shifted - shift)
    high = Pair(steps.named("high", x - k * data.first), None,
                upward(exp.INTERVAL[1] + data.most * (ln2()[1] - data.first)))
    second, rest = (steps.named(name, k * -part) for name, part in (
        ("second", data.second), ("rest", data.rest)))
    size = data.most * data.rest
    low = Pair(second, rest, data.most * data.second, size + pairs.rounding(size),
               pairs.rounding(size) + data.most * data.missing)
    r = pairs.sum("r", high, low)
    size = exp.INTERVAL[1] * (1 + 2 * precision.u)
    return shifted, k, replace(r, size=min(r.size, size))


def growth(r: Pair, precision: Precision, relative: bool = False) -> Pair:
    """e^r - 1; relative: in units of |r|, for an r that is exact and not tiny."""
    pairs = Pairs(precision)
    argument = replace(r, high=pairs.vanishing("argument", r))
    terms = GROWTH.terms(precision)
    wrong = GROWTH.left_out(len(terms))
    if relative:
        argument, r = replace(argument, rest=Fraction(0), error=Fraction(0)), Pair(
            r.high, r.low, Fraction(1))
    grown = pairs.grown("grown", r, pairs.series("term", terms, argument).less(wrong))
    return grown if relative else grown.less(pairs.tiny**2)


@cache
def kernel(precision: Precision) -> Program:
    """(x, y) -> exp x - y"""
    data, shift = exp.DATA[precision], integer_shift(precision)
    steps = StepWriter(*INPUTS)
    x, y = steps.inputs()
    least, largest = data.limits
    x = (x > largest).where(largest, x)
    x = steps.named("within", (x < least).where(least, x))
    _, k, e_r = power(x, precision)
    first = steps.named("first_shifted", k * Fraction(1, 2) + shift)
    half = steps.named("k_first", first - shift)
    rest = steps.named("k_second", k - half)
    down = [steps.named(f"down{n}", steps.do(Op.POWER, shift - z, shift))
            for n, z in enumerate((half, rest))]
    up = [steps.named(f"up{n}", steps.do(Op.POWER, shift + z, shift))
          for n, z in enumerate((half, rest))]
    scaled = steps.named("y_scaled", _times(y, down))
    assert e_r.low is not None
    error = steps.named("error", (e_r.high - scaled) + e_r.low)
    error = steps.named("scaled", _times(error, up))
    error = (y > precision.limit("max")).where(0, error)
    return steps.program("exp_error", OUTPUTS, [
        steps.named("y_error", y.equals(0).where(0, error))])


def power(x: StepValue, precision: Precision) -> tuple[StepValue, StepValue, Pair]:
    """k plus the integers' shift, k, and e^r."""
    shifted, k, r = reduced(x, precision)
    pairs = Pairs(precision)
    e_r = pairs.sum("e_r", pairs.constant(x.steps, Fraction(1)), growth(r, precision),
                    ordered=True)
    return shifted, k, e_r


def _times(x: StepValue, powers: Sequence[StepValue]) -> StepValue:
    for factor in powers:
        x = x.steps.do(Op.SCALE, x, factor)
    return x


@cache
def error(precision: Precision) -> Fraction:
    """A proved bound of |y + y_error - exp x| / exp x, where y_error is not subnormal.

    e_r - y / 2^k is exact, both being close; its sum with e_r's low part is rounded."""
    x, _ = StepWriter(*INPUTS).inputs()
    *_, e_r = power(x, precision)
    least = 1 + exp.INTERVAL[0]
    return (e_r.error + precision.u * e_r.rest) / least + 3 * precision.u**2


def comment(precision: Precision) -> str:
    return (f"x = k ln 2 + r, r as a pair; a Taylor polynomial of degree "
            f"{len(GROWTH.terms(precision)) + 1} in pairs; y + y_error is within "
            f"{power_of_two(error(precision))} of exp x, relative to it (proved), and 0.51 of the "
            "least subnormal number; 0 where y is 0 or infinite.")


ERROR = Elementary("exp_error", "y_error = exp x - y, y as exp has it", INPUTS, OUTPUTS, kernel,
                   error, comment)
