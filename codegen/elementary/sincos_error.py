"""sin x - s and cos x - c, s and c being what `sincos` returns: both are computed as pairs."""

from dataclasses import dataclass
from fractions import Fraction
from functools import cache

from coscrew_codegen.elementary import reduction, reduction_pairs, sincos
from coscrew_codegen.elementary.function import Elementary
from coscrew_codegen.elementary.pairs import Pair, Pairs, Series, power_of_two
from coscrew_codegen.elementary.reduction import X, to_integer
from coscrew_codegen.elementary.reduction_pairs import REDUCED, Spread
from coscrew_codegen.elementary.steps import Steps, Value
from coscrew_codegen.formats import Precision
from coscrew_codegen.program import Program
from coscrew_codegen.quantity import SCALAR, Argument

OUTPUTS = Argument("s_error", SCALAR), Argument("c_error", SCALAR)
ANGLE = Fraction(78704, 100000)
"""More than any |r|: that of `sincos`."""
SINES = Series(ANGLE, 3, 2, -1)  # sin r = r + r (…)
COSINES = Series(ANGLE, 2, 2, -1)  # cos r = 1 + …


@dataclass(frozen=True)
class Computed:
    """The sine and cosine of r: the sine relative to r."""

    sine: Pair
    cosine: Pair


def computed(r: Value, r_low: Value, spread: Spread, precision: Precision) -> Computed:
    """The steps from r, of which the spread is proved, to its sine and cosine."""
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


@cache
def kernel(precision: Precision) -> Program:
    """(quadrant, r, r_low, s, c) -> (sin x - s, cos x - c)"""
    results = sincos.SIN_COS
    steps = Steps(*REDUCED, *results)
    k, r, r_low, s, c = steps.inputs()
    found = computed(r, r_low, reduction_pairs.spread(precision), precision)
    sine, cosine = turned(k, found, precision)
    return steps.program("kernel", OUTPUTS, (
        steps.named("s_error", (sine[0] - s) + sine[1]),
        steps.named("c_error", (cosine[0] - c) + cosine[1])))


def turned(k: Value, of: Computed, precision: Precision
           ) -> tuple[tuple[Value, Value], tuple[Value, Value]]:
    """The sine and cosine of k π/2 + r, each as high and low."""
    steps = k.steps
    q = steps.named("q", to_integer(steps, k, precision, 4) - k)
    a = steps.named("cos_k", 1 - abs(q))
    b = steps.named("minus_sin_k", q * (1 + a))
    low = of.sine.low, of.cosine.low
    assert low[0] is not None and low[1] is not None
    lows = low[0], low[1]
    sines = [steps.named(name, x * a - y * b) for name, x, y in (
        ("sin_x", of.sine.high, of.cosine.high), ("sin_x_low", *lows))]
    cosines = [steps.named(name, y * a + x * b) for name, x, y in (
        ("cos_x", of.sine.high, of.cosine.high), ("cos_x_low", *lows))]
    return (sines[0], sines[1]), (cosines[0], cosines[1])


def relative(spread: Spread, precision: Precision) -> tuple[Pair, Pair]:
    """sin r and cos r in units of what they are at least: with bounds, proved, of the relative
    errors."""
    _, r, r_low = Steps(*REDUCED).inputs()
    found = computed(r, r_low, spread, precision)
    least = 1 - ANGLE**2 / 6, 1 - ANGLE**2 / 2
    return (found.sine.scaled(found.sine.size / least[0]),
            found.cosine.scaled(found.cosine.size / least[1]))


@cache
def error(precision: Precision) -> Fraction:
    """A bound, proved: |s + s_error - sin x| / |sin x|, and the same of the cosine.

    sin_x - s, at most an ulp and what sin_x errs by, is exact, both being close; its sum with
    sin_x_low is rounded."""
    u, spread = precision.u, reduction_pairs.spread(precision)
    return max(x.error + u * (3 * u + x.rest) for x in relative(spread, precision))


def comment(precision: Precision) -> str:
    degrees = 2 * len(SINES.terms(precision)) + 1, 2 * len(COSINES.terms(precision))
    return (f"x = k pi/2 + r, r as a pair; Taylor polynomials of degrees {degrees[0]} and "
            f"{degrees[1]} in pairs; s + s_error and c + c_error are within "
            f"{power_of_two(error(precision))} of sin x and cos x, relative to these (proved), for "
            "every finite x.")


ERROR = Elementary(
    "sincos_error", "(s_error, c_error) = (sin x - s, cos x - c), (s, c) as sincos has them",
    (X, *sincos.SIN_COS), OUTPUTS, kernel, error, comment, near=reduction_pairs.near,
    far=reduction_pairs.far, limit=reduction.limit)
