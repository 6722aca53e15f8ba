"""sin r and cos r as pairs, by their series."""

from dataclasses import dataclass
from fractions import Fraction

from coscrew_codegen.program.elementary.evaluation.double_words import Pair, Pairs, Series
from coscrew_codegen.program.elementary.evaluation.reduction import to_integer
from coscrew_codegen.program.elementary.evaluation.reduction_pairs import REDUCED, Spread
from coscrew_codegen.program.elementary.evaluation.step_writer import StepValue, StepWriter
from coscrew_codegen.program.values.formats import Precision

ANGLE = Fraction(78704, 100000)
"""A bound of |r|, from `sincos`."""
SINES = Series(ANGLE, 3, 2, -1)  # sin r = r + r (…)
COSINES = Series(ANGLE, 2, 2, -1)  # cos r = 1 + …


@dataclass(frozen=True)
class Computed:
    """The sine and cosine of r: the sine relative to r."""

    sine: Pair
    cosine: Pair


def computed(r: StepValue, r_low: StepValue, spread: Spread, precision: Precision) -> Computed:
    """The steps from r, whose spread is proved, to its sine and cosine."""
    steps, pairs = r.steps, Pairs(precision)
    one = Pair(r, r_low, spread.high, spread.low, spread.error)
    angle = one.scaled(ANGLE)
    angle = Pair(pairs.vanishing("argument", angle), r_low, ANGLE, angle.rest, angle.error)
    z = pairs.product("z", angle, angle)
    sines, cosines = SINES.terms(precision), COSINES.terms(precision)
    sine = pairs.grown("sin_r", one, pairs.series(
        "sin", sines, z).less(SINES.left_out(len(sines)) + pairs.tiny**2))
    cosine = pairs.sum("cos_r", pairs.constant(steps, Fraction(1)), pairs.series(
        "cos", cosines, z).less(COSINES.left_out(len(cosines)) + pairs.tiny**2), ordered=True)
    return Computed(sine, cosine)


def relative(spread: Spread, precision: Precision) -> tuple[Pair, Pair]:
    """sin r and cos r in units of their least sizes, with proved bounds of the relative errors."""
    _, r, r_low = StepWriter(*REDUCED).inputs()
    result = computed(r, r_low, spread, precision)
    least = 1 - ANGLE**2 / 6, 1 - ANGLE**2 / 2
    return (result.sine.scaled(result.sine.size / least[0]),
            result.cosine.scaled(result.cosine.size / least[1]))


def turn(k: StepValue, precision: Precision) -> tuple[StepValue, StepValue]:
    """cos(k π/2) and -sin(k π/2): 0 and ±1."""
    steps = k.steps
    q = steps.named("q", to_integer(steps, k, precision, 4) - k)
    a = steps.named("cos_k", 1 - abs(q))
    return a, steps.named("minus_sin_k", q * (1 + a))
