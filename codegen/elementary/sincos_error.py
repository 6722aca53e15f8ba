"""sin x - s and cos x - c, s and c being what `sincos` returns: both are computed as pairs."""

from dataclasses import dataclass
from fractions import Fraction
from functools import cache

from coscrew_codegen.elementary import reduction, reduction_pairs, sincos
from coscrew_codegen.elementary.function import Elementary
from coscrew_codegen.elementary.pairs import Pair, Pairs
from coscrew_codegen.elementary.reduction import X, to_integer
from coscrew_codegen.elementary.reduction_pairs import REDUCED
from coscrew_codegen.elementary.steps import Steps, Value
from coscrew_codegen.formats import Precision
from coscrew_codegen.program import Program
from coscrew_codegen.quantity import SCALAR, Argument

OUTPUTS = Argument("s_error", SCALAR), Argument("c_error", SCALAR)
ANGLE = Fraction(78704, 100000)
"""More than any |r|: that of `sincos`."""


@dataclass(frozen=True)
class Computed:
    """The sine and cosine of r: the sine relative to r."""

    sine: Pair
    cosine: Pair


def series(precision: Precision, size: Fraction, first: int, step: int, sign: int
           ) -> tuple[Fraction, ...]:
    """x^n / n! for n = first, first + step, …, signs alternating if `sign` is negative, divided by
    x^(first - step): as many as matter to twice the digits for |x| <= size."""
    found, term, power = list[Fraction](), Fraction(1), 1
    for n in range(1, 99):
        term /= n
        if n >= first and (n - first) % step == 0:
            power *= sign
            found.append(power * term)
        if found and term * size**n < precision.u**2 / 64:
            return tuple(found)
    raise ValueError("no series of these terms is this long")


def left_out(precision: Precision, size: Fraction, count: int, first: int, step: int) -> Fraction:
    """A bound of the terms after the first `count` of such a series, size < 1."""
    n, term = first + step * count, Fraction(1)
    for i in range(1, n + 1):
        term /= i
    return 2 * term * size**(n - first + step)


def computed(r: Value, r_low: Value, precision: Precision) -> Computed:
    """The steps from r to its sine and cosine."""
    steps, pairs, spread = r.steps, Pairs(precision), reduction_pairs.spread(precision)
    one = Pair(r, r_low, spread.high, spread.low, spread.error)
    angle = one.scaled(ANGLE)
    angle = Pair(pairs.vanishing("angle", angle), r_low, ANGLE, angle.rest, angle.error)
    z = pairs.product("z", angle, angle)
    size = z.size
    sines = series(precision, ANGLE, 3, 2, -1)
    cosines = series(precision, ANGLE, 2, 2, -1)
    sine = pairs.grown("sin_r", one, _with(
        pairs.series("sin", sines, z), left_out(precision, size, len(sines), 3, 2) + pairs.tiny**2))
    cosine = pairs.sum("cos_r", pairs.constant(steps, Fraction(1)), _with(
        pairs.series("cos", cosines, z),
        left_out(precision, size, len(cosines), 2, 2) + pairs.tiny**2), ordered=True)
    return Computed(sine, cosine)


def _with(x: Pair, error: Fraction) -> Pair:
    return Pair(x.high, x.low, x.size, x.rest, x.error + error)


@cache
def kernel(precision: Precision) -> Program:
    """(quadrant, r, r_low, s, c) -> (sin x - s, cos x - c)"""
    results = sincos.SIN_COS
    steps = Steps(*REDUCED, *results)
    k, r, r_low, s, c = steps.inputs()
    return steps.program("kernel", OUTPUTS, _errors(k, computed(r, r_low, precision), s, c,
                                                    precision))


def turned(k: Value, of: Computed, precision: Precision
           ) -> tuple[tuple[Value, Value], tuple[Value, Value]]:
    """The sine and cosine of k π/2 + r, each as high and low."""
    steps = k.steps
    q = steps.named("q", to_integer(steps, k, precision, 4) - k)
    a = steps.named("cos_k", 1 - abs(q))
    b = steps.named("minus_sin_k", q * (1 + a))
    lows = of.sine.low, of.cosine.low
    assert lows[0] is not None and lows[1] is not None
    sines = [steps.named(name, x * a - y * b) for name, x, y in (
        ("sin_x", of.sine.high, of.cosine.high), ("sin_x_low", *lows))]
    cosines = [steps.named(name, y * a + x * b) for name, x, y in (
        ("cos_x", of.sine.high, of.cosine.high), ("cos_x_low", *lows))]
    return (sines[0], sines[1]), (cosines[0], cosines[1])


def _errors(k: Value, of: Computed, s: Value, c: Value, precision: Precision
            ) -> tuple[Value, Value]:
    sine, cosine = turned(k, of, precision)
    return (k.steps.named("s_error", (sine[0] - s) + sine[1]),
            k.steps.named("c_error", (cosine[0] - c) + cosine[1]))


@cache
def relative(precision: Precision) -> tuple[Fraction, Fraction]:
    """Bounds, proved, of the relative errors of the pairs for sin r and cos r."""
    steps = Steps(*REDUCED)
    _, r, r_low = steps.inputs()
    found = computed(r, r_low, precision)
    most = ANGLE**2
    return found.sine.error / (1 - most / 6), found.cosine.error / (1 - most / 2)


@cache
def error(precision: Precision) -> Fraction:
    """A bound, proved: |s + s_error - sin x| / |sin x|, and the same of the cosine.

    sin_x - s is exact, both being close; its sum with sin_x_low, at most 3 ulps, is rounded."""
    return max(relative(precision)) + 8 * precision.u**2


def comment(precision: Precision) -> str:
    from math import log2
    count = len(series(precision, ANGLE, 3, 2, -1))
    stated = -log2(error(precision))
    return (f"x = k pi/2 + r, r as a pair; Taylor polynomials of degrees {2 * count + 1} and "
            f"{2 * len(series(precision, ANGLE, 2, 2, -1))} in pairs; s + s_error and c + c_error "
            f"are within 2^-{int(stated * 10) / 10:g} of sin x and cos x, relative to these "
            "(proved), for every finite x.")


ERROR = Elementary(
    "sincos_error", "(s_error, c_error) = (sin x - s, cos x - c), (s, c) as sincos has them",
    (X, *sincos.SIN_COS), OUTPUTS, kernel, error, comment, near=reduction_pairs.near,
    far=reduction_pairs.far, limit=reduction.limit)
