"""sin x and cos x, computed together.

With x = k π/2 + r - e, sin(r - e) = sin r - e cos r and cos(r - e) = cos r + e sin r to more than
twice the digits.  They are combined with the sine and cosine of k π/2, which are 0 and ±1."""

from collections.abc import Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import cache

from coscrew_codegen.program import Program
from coscrew_codegen.program.elementary.elementary_function import Elementary
from coscrew_codegen.program.elementary.evaluation import reduction
from coscrew_codegen.program.elementary.evaluation.polynomial import numbers
from coscrew_codegen.program.elementary.evaluation.reduction import REDUCED, X, to_integer
from coscrew_codegen.program.elementary.evaluation.step_writer import StepValue, StepWriter
from coscrew_codegen.program.values.formats import DOUBLE, SINGLE, Precision
from coscrew_codegen.program.values.quantity import SCALAR, Argument

SIN_COS = (Argument("s", SCALAR), Argument("c", SCALAR))
SQUARES = Fraction(0), Fraction(6194, 10000)
"""The interval of r^2: (π/4)^2, and the rounding of x 2/π."""


@dataclass(frozen=True)
class SincosCoefficients:
    """Numbers that differ between the formats."""

    sine: tuple[Fraction, ...]  # sin r = r - r^3 (a0 + a1 r^2 + …)
    cosine: tuple[Fraction, ...]  # cos r = 1 - r^2/2 + r^4 (a0 + a1 r^2 + …)
    approximation: Fraction  # proved: log2 of the relative error of either, roundings apart
    error: Fraction  # proved, with the roundings and the reduction, in ulps of the result


DATA = {
    DOUBLE: SincosCoefficients(
        numbers("""
        0x1.5555555555548p-3 -0x1.111111110f730p-7 0x1.a01a019be91f9p-13 -0x1.71de3555272cbp-19
        0x1.ae5e4b7e74d67p-26 -0x1.5d8b53613f01cp-33"""),
        numbers("""
        0x1.555555555554ap-5 -0x1.6c16c16c14e00p-10 0x1.a01a019c5c378p-16 -0x1.27e4f7cd2f00ap-22
        0x1.1ee9c332d6017p-29 -0x1.8f99c9b4c8ee7p-37"""), Fraction("-57.8"), Fraction("0.824")),
    SINGLE: SincosCoefficients(
        numbers("0x1.5555440000000p-3 -0x1.1106c60000000p-7 0x1.991c260000000p-13"),
        numbers("0x1.55554a0000000p-5 -0x1.6c0c260000000p-10 0x1.99e7120000000p-16"),
        Fraction("-27.8"), Fraction("0.850"))}


def polynomial(a: Sequence[Fraction], z: StepValue, z2: StepValue) -> StepValue:
    """a0 + a1 z + a2 z^2 + …: two terms at a time (Estrin), but a0, the largest, last."""
    return a[0] + (z * a[1] + z2 * (pairs(a[2:], z, z2) if len(a) > 3 else a[2]))


def pairs(a: Sequence[Fraction], z: StepValue, z2: StepValue) -> StepValue:
    """Evaluates a polynomial with an even number of terms, in the order with the shortest chain of
    dependent steps."""
    pair = a[0] + z * a[1]
    return pair + z2 * pairs(a[2:], z, z2) if len(a) > 2 else pair


@cache
def kernel(precision: Precision) -> Program:
    """(quadrant, r, r_excess) -> (sin x, cos x)"""
    data, steps = DATA[precision], StepWriter(*REDUCED)
    k, r, excess = steps.inputs()
    z = steps.named("z", r * r)
    z2 = steps.named("z2", z * z)
    half = steps.named("half_z", z * Fraction(1, 2))
    w = steps.named("w", 1 - half)
    sine = steps.named("sin_r", r - (z * r * polynomial(data.sine, z, z2) + excess * w))
    cosine = steps.named("cos_r", w + (((1 - w) - half) + (
        z2 * polynomial(data.cosine, z, z2) + r * excess)))
    q = steps.named("q", to_integer(steps, k, precision, 4) - k)
    a = steps.named("cos_k", 1 - abs(q))
    b = steps.named("minus_sin_k", q * (1 + a))  # +0, not -0, for k = 0
    s = steps.named("s", sine * a - cosine * b)
    c = steps.named("c", cosine * a + sine * b)
    return steps.program("kernel", SIN_COS, (s, c))


def derived(precision: Precision) -> tuple[tuple[Fraction, ...], tuple[Fraction, ...]]:
    """Both polynomials, fitted so that the relative errors are least."""
    from mpmath import cos, sin, sqrt

    from coscrew_codegen.program.elementary.proofs.minimax import fitted

    data = DATA[precision]
    return (fitted(lambda z: (1 - sin(sqrt(z)) / sqrt(z)) / z, lambda z: sqrt(z)**3 / sin(sqrt(z)),
                   SQUARES, len(data.sine) - 1, precision.digits),
            fitted(lambda z: (cos(sqrt(z)) - 1 + z / 2) / z**2, lambda z: z**2 / cos(sqrt(z)),
                   SQUARES, len(data.cosine) - 1, precision.digits))


def approximations(precision: Precision) -> tuple[Fraction, Fraction]:
    """Proved bounds of the relative errors of r - r^3 a(r^2) and 1 - r^2/2 + r^4 a(r^2)."""
    from coscrew_codegen.program.elementary.proofs.minimax import difference, supremum

    data, one, last = DATA[precision], Fraction(1), 12
    terms = [one]
    for i in range(1, 2 * last + 2):
        terms.append(-terms[-1] / i if i % 2 == 0 else terms[-1] / i)
    cosine, sine = terms[:2 * last:2], terms[1:2 * last:2]  # of r^2; sine divided by r
    rest = SQUARES[1]**last * abs(terms[2 * last])  # the series alternate and decrease
    least = min(sum(SQUARES[1]**i * c for i, c in enumerate(x[:2])) for x in (cosine, sine))
    results = [supremum(difference(p, series), series[:2], SQUARES) + rest / least
               for p, series in (([one, *(-x for x in data.sine)], sine),
                                 ([one, -one / 2, *data.cosine], cosine))]
    return results[0], results[1]


def roundings(precision: Precision) -> Fraction:
    """A proved bound of the errors in ulps, for r > 0; r < 0 differs by signs alone.

    Where |r| is below the last piece, k = 0: there sin x = x and cos x = 1 to half an ulp."""
    from coscrew_codegen.program.elementary.proofs.reduction_proof import (
        exponent_of,
        far_is_proved,
        near_is_proved,
    )
    from coscrew_codegen.program.elementary.proofs.roundings import Roundings, pieces

    reductions = near_is_proved(precision), far_is_proved(precision)
    sine, cosine = approximations(precision)
    largest, worst = max(x.largest for x in reductions), []
    powers = [Fraction(1, 2**n) for n in range(4, 2 * precision.digits)]
    assert largest**2 <= SQUARES[1]
    assert all(powers[-1] < b.least for x in reductions for b in x.binades)
    for low, high in (*pieces(Fraction(1, 16), largest, 32, (Fraction(1, 8), Fraction(1, 4),
                      Fraction(1, 2))), *((x / 2, x) for x in powers)):
        half_ulp = precision.u * Fraction(2)**exponent_of(low)
        e = half_ulp + max(x.excess(2 * high) for x in reductions)
        analysis = Roundings(precision)
        s, c = analysis.results(kernel(precision), ["sin_r", "cos_r"], [
            analysis.constant(0), analysis.within(low, high), analysis.within(-e, e)], {})
        assert e <= low / 4
        relative, more = max(x.error(low - e) for x in reductions), low / (low - e)
        # |sin r| <= more |sin (r - e)|. Absolute: terms of second order in e, and the effect of the
        # reduction's error on the cosine.
        orders = e * high**4 / 24 + e**2 * high, e * high**3 / 6 + e**2
        worst += [analysis.ulps(s, more * sine + relative, orders[0]),
                  analysis.ulps(c, more * cosine, orders[1] + relative * (high + e)**2)]
    return max(worst)


def comment(precision: Precision) -> str:
    data = DATA[precision]
    bits = ", ".join(f"2^-{n}" for n in reduction.split(precision).last_bits)
    return (f"x = k pi/2 + r - r_excess, |r| <= pi/4 and little more; pi/2 in parts to {bits} and "
            f"a rest, beyond the limit by the digits of 2/pi; polynomials of degrees "
            f"{2 * len(data.sine) + 1} and {2 * len(data.cosine) + 2} in r, to "
            f"2^{float(data.approximation):g}; with all roundings within {float(data.error):g} ulp "
            "(both proved), for every finite x.")


FUNCTION = Elementary(
    "sincos", "(s, c) = (sin x, cos x)", (X,), SIN_COS, kernel,
    lambda precision: DATA[precision].error, comment, near=reduction.near, far=reduction.far,
    limit=reduction.limit)
