"""tanh x = x + x³ p(x²) / q(x²) up to 5/8, beyond it 1 - 2 / (e^2x + 1).

Both are a number and a quotient, so that one division serves both.  The rounding error of the sum
2^k + 2^k s + 1 corrects the quotient: 2 / (d + low) = 2/d - low (2/d)²/2."""

from dataclasses import dataclass
from fractions import Fraction
from functools import cache

from coscrew_codegen.program import Op, Program
from coscrew_codegen.program.elementary import exp
from coscrew_codegen.program.elementary.elementary_function import Elementary
from coscrew_codegen.program.elementary.evaluation.polynomial import horner, integer_shift, numbers
from coscrew_codegen.program.elementary.evaluation.step_writer import StepWriter
from coscrew_codegen.program.values.formats import DOUBLE, SINGLE, Precision
from coscrew_codegen.program.values.quantity import ANY, SCALAR, Argument

INPUTS, OUTPUTS = (Argument("x", SCALAR, ANY),), (Argument("y", SCALAR),)
SMALL = Fraction(5, 8)
INTERVAL = Fraction(0), SMALL**2


@dataclass(frozen=True)
class TanhCoefficients:
    """Numbers that differ between the formats."""

    p: tuple[Fraction, ...]
    q: tuple[Fraction, ...]
    one: int  # tanh of it and beyond is 1
    approximation: Fraction  # proved: log2 of the relative error up to 5/8, roundings apart
    error: Fraction  # proved, with the roundings, in ulps of the result


DATA = {
    DOUBLE: TanhCoefficients(
        numbers("-0x1.5555555555554p-2 -0x1.4fd1c07c63da2p-6 -0x1.a1850b52c3c45p-13"),
        numbers("0x1p0 0x1.d890edb0ec424p-2 0x1.7d8fab86de962p-6 0x1.b0eeb565aa7f8p-13"),
        20, Fraction("-59.3"), Fraction("0.979")),
    SINGLE: TanhCoefficients(
        numbers("-0x1.5555560000000p-2 -0x1.c70a7a0000000p-10 0x1.f3f4ca0000000p-15"),
        numbers("0x1.0000000000000p+0 0x1.9eeec40000000p-2"),
        10, Fraction("-31.2"), Fraction("0.967"))}


@cache
def kernel(precision: Precision) -> Program:
    """x -> tanh(x)"""
    data, shift = DATA[precision], integer_shift(precision)
    steps = StepWriter(*INPUTS)
    x, = steps.inputs()
    size = steps.named("size", abs(x))
    small = steps.named("small", size < SMALL)
    z = steps.named("z", size * size)
    above = steps.named("above", (size * z) * horner(data.p, z))
    below = steps.named("below", horner(data.q, z))

    twice = size + size
    twice = steps.named("twice", (twice > 2 * data.one).where(2 * data.one, twice))
    parts = exp.reduced(twice, precision)
    power = steps.named("power", steps.do(Op.POWER, parts.shifted, shift))
    most = power + 1
    s = steps.named("s", parts.high + parts.low)
    rest = steps.named("rest_of_e", steps.do(Op.SCALE, s, power))
    total = steps.named("total", most + rest)
    low = steps.named("low_of_total", (most - total) + rest)

    quotient = steps.named("quotient", small.where(above, -2) / small.where(below, total))
    correction = (quotient * low) * (quotient * Fraction(1, 2))
    correction = steps.named("correction", small.where(0, correction))
    start = steps.named("start", small.where(size, 1))
    y = start + quotient
    y = steps.named("sum", y + (((start - y) + quotient) + correction))
    return steps.program("tanh", OUTPUTS, [
        steps.named("y", steps.do(Op.COPYSIGN, y, x))])


def derived(precision: Precision) -> tuple[tuple[Fraction, ...], tuple[Fraction, ...]]:
    """p and q, fitted so that the relative error of x + x³ p/q is least."""
    import mpmath

    from coscrew_codegen.program.elementary.proofs.minimax import fitted, fitted_denominator

    def function(z: mpmath.mpf) -> mpmath.mpf:
        x = mpmath.sqrt(z)
        return (mpmath.tanh(x) / x - 1) / z

    def weight(z: mpmath.mpf) -> mpmath.mpf:
        x = mpmath.sqrt(z)
        return z * x / mpmath.tanh(x)

    def denominator(z: mpmath.mpf) -> mpmath.mpf:
        return sum(mpmath.mpf(c.numerator) / c.denominator * z**i for i, c in enumerate(q))

    degrees = len(DATA[precision].p) - 1, len(DATA[precision].q) - 1
    q = fitted_denominator(function, weight, INTERVAL, degrees, precision.digits)
    p = fitted(lambda z: function(z) * denominator(z), lambda z: weight(z) / denominator(z),
               INTERVAL, degrees[0], precision.digits)
    return p, q


def approximation(precision: Precision) -> Fraction:
    """A proved bound of the relative error of x + x³ p/q for 0 <= x <= 5/8: of (x + x³ p/q) q cosh
    x - q sinh x over q sinh x, each over x, as series in z = x²."""
    from coscrew_codegen.program.elementary.proofs.minimax import difference, product, supremum

    data = DATA[precision]
    cosh, sinh = [Fraction(1)], [Fraction(1)]  # cosh x, sinh x / x
    for i in range(1, 13):
        cosh.append(cosh[-1] / ((2 * i - 1) * 2 * i))
        sinh.append(sinh[-1] / (2 * i * (2 * i + 1)))
    rest = 2 * INTERVAL[1]**13 * cosh[-1] / (25 * 26)  # of cosh, and more than of sinh
    above = difference(data.q, [Fraction(0), *(-c for c in data.p)])  # q + z p
    largest = supremum(above, [Fraction(1)], INTERVAL) + supremum(data.q, [Fraction(1)], INTERVAL)
    error = difference(product(above, cosh), product(data.q, sinh))
    below = product(data.q, [Fraction(1), Fraction(1, 6)])  # q (1 + z/6) < q sinh x / x
    return supremum(error, below, INTERVAL) + rest * largest  # q >= 1


def roundings(precision: Precision) -> Fraction:
    """A proved bound of the error in ulps of a result in the normal range."""
    return max(_small_roundings(precision), _large_roundings(precision))


def _small_roundings(precision: Precision) -> Fraction:
    """Bounds roundings up to 5/8. Below 2^-8 the quotient is so small that ranges may be wide."""
    from coscrew_codegen.program.elementary.proofs.roundings import Roundings, given, pieces

    ranges = [piece for n in range(8) for piece in pieces(SMALL / 2**(n + 1), SMALL / 2**n, 32)]
    low = SMALL / 2**8
    while low > precision.smallest_normal:
        ranges.append((max(low / 2**8, precision.smallest_normal), low))
        low /= 2**8
    relative, worst = approximation(precision), Fraction(0)
    for low, high in ranges:
        analysis = Roundings(precision, 320 if low > Fraction(1, 2**60) else 2400)
        y, = analysis.results(kernel(precision), ["sum"], [analysis.within(low, high)],
                              given({"small": True}))
        worst = max(worst, analysis.ulps(y, relative))
    return worst


def _large_roundings(precision: Precision) -> Fraction:
    """Bounds roundings from 5/8 on, for every k that exp's reduction leads to.  A relative error of
    e^2x is halved at least; beyond `one` the result is 1, and tanh 1 less at most 2^-54, in single
    precision 2^-27."""
    from coscrew_codegen.program.elementary.proofs.minimax import ln2
    from coscrew_codegen.program.elementary.proofs.roundings import Roundings, given, pieces

    data, shift = exp.DATA[precision], integer_shift(precision)
    absolute, worst = exp.approximation(precision) / 2, Fraction(0)
    for k in range(2, 3 * DATA[precision].one):
        low, high = (x + k * data.ln2[1] for x in exp.INTERVAL)
        low = max(low, 2 * SMALL - k * ln2()[1] + k * data.ln2[1])
        for piece in pieces(low, high, 64 if k < 8 else 4):
            analysis = Roundings(precision)
            x, number = analysis.within(SMALL, DATA[precision].one), analysis.constant
            known = {"shifted": number(shift + k), "k": number(k), "high": analysis.within(*piece)}
            y, = analysis.results(kernel(precision), ["sum"], [x], given(known))
            worst = max(worst, analysis.ulps(y, absolute=absolute))
    return worst


def comment(precision: Precision) -> str:
    data = DATA[precision]
    return (f"|x| < 5/8: x + x^3 p/q, of degrees {len(data.p) - 1} and {len(data.q) - 1} in x^2, "
            f"to 2^{float(data.approximation):g}; beyond: 1 - 2 / (e^2|x| + 1), e^2|x| as exp has "
            f"it; with all roundings within {float(data.error):g} ulp (both proved).")


FUNCTION = Elementary("tanh", "y = tanh x", INPUTS, OUTPUTS, kernel,
                      lambda precision: DATA[precision].error, comment)
