"""exp(x) = 2^k e^r, x = k ln 2 + r, |r| <= ln 2 / 2.

r = high - rest, high exact and rest small: e^r = 1 + high + (r² q(r) - rest); the rounding error of
1 + high is added to the bracket.  The least results are scaled twice and rounded once more only."""

from dataclasses import dataclass
from fractions import Fraction
from functools import cache

from coscrew_codegen.program import Op, Program
from coscrew_codegen.program.elementary.elementary_function import Elementary
from coscrew_codegen.program.elementary.evaluation.polynomial import estrin, integer_shift, numbers
from coscrew_codegen.program.elementary.evaluation.step_writer import StepValue, StepWriter
from coscrew_codegen.program.values.formats import DOUBLE, SINGLE, Precision
from coscrew_codegen.program.values.quantity import ANY, SCALAR, Argument

INPUTS, OUTPUTS = (Argument("x", SCALAR, ANY),), (Argument("y", SCALAR),)
INTERVAL = Fraction(-3467, 10000), Fraction(3467, 10000)
"""Interval of r: ln 2 / 2, plus the shift by the rounding of x / ln 2."""
_SMALL = 64  # the exponent that is scaled by at last if the result may be subnormal


@dataclass(frozen=True)
class ExpCoefficients:
    """Numbers that differ between the formats."""

    q: tuple[Fraction, ...]
    to_binary: Fraction  # 1 / ln 2
    ln2: tuple[Fraction, ...]  # its leading bits: times k exact; the rest
    limits: tuple[int, int]  # results underflow to 0 below, overflow above
    small: int  # results below its exponential are scaled twice
    approximation: Fraction  # proved: log2 of the relative error, roundings apart
    error: Fraction  # proved, with the roundings, in ulps of the result


DATA = {
    DOUBLE: ExpCoefficients(numbers("""
        0x1.0000000000000p-1 0x1.5555555555501p-3 0x1.55555555531f4p-5 0x1.111111112897dp-7
        0x1.6c16c17cc9f96p-10 0x1.a01a011bd5745p-13 0x1.a019ab158c8c2p-16 0x1.71df55cfa5232p-19
        0x1.289fa481977b0p-22 0x1.ad1f6f8169222p-26"""),
        numbers("0x1.71547652b82fep+0")[0],
        numbers("0x1.62e42fefa3800p-1 0x1.ef35793c76730p-45"), (-746, 710), -700,
        Fraction("-57.3"), Fraction("0.755")),
    SINGLE: ExpCoefficients(numbers("""
        0x1.0000000000000p-1 0x1.5554a40000000p-3 0x1.55568a0000000p-5 0x1.122f260000000p-7
        0x1.6b6bf00000000p-10"""),
        numbers("0x1.7154760000000p+0")[0],
        numbers("0x1.62e4000000000p-1 0x1.7f7d1c0000000p-20"), (-104, 89), -80,
        Fraction("-27.9"), Fraction("0.757"))}


@dataclass(frozen=True)
class Reduced:
    """e^x = 2^k (1 + high + low), high exact; shifted is k plus the integers' shift."""

    shifted: StepValue
    high: StepValue
    low: StepValue


def reduced(x: StepValue, precision: Precision) -> Reduced:
    """The steps that the exponential's functions share, for x within its limits."""
    data, shift = DATA[precision], integer_shift(precision)
    steps = x.steps
    shifted = steps.named("shifted", x * data.to_binary + shift)
    k = steps.named("k", shifted - shift)
    high = steps.named("high", x - k * data.ln2[0])
    rest = steps.named("rest", k * data.ln2[1])
    r = steps.named("r", high - rest)
    low = steps.named("low", (r * r) * estrin(data.q, r) - rest)
    return Reduced(shifted, high, low)


@cache
def kernel(precision: Precision) -> Program:
    """x -> exp(x)"""
    data, shift = DATA[precision], integer_shift(precision)
    steps = StepWriter(*INPUTS)
    x, = steps.inputs()
    least, largest = data.limits
    x = (x > largest).where(largest, x)
    x = steps.named("within", (x < least).where(least, x))
    parts = reduced(x, precision)
    small = steps.named("small", x < data.small)
    start = steps.named("start", parts.high + 1)
    e_r = steps.named("e_r", start + (((1 - start) + parts.high) + parts.low))
    power = steps.do(Op.POWER, parts.shifted + small.where(_SMALL, -1), shift)
    scaled = steps.named("scaled", steps.do(Op.SCALE, e_r, power))
    last = small.where(Fraction(1, 2**_SMALL), 2)
    return steps.program("exp", OUTPUTS, [
        steps.named("y", steps.do(Op.SCALE, scaled, last))])


def derived(precision: Precision) -> tuple[Fraction, ...]:
    """q, fitted so that the relative error of 1 + r + r² q is least."""
    import mpmath

    from coscrew_codegen.program.elementary.proofs.minimax import fitted

    return fitted(lambda r: (mpmath.expm1(r) - r) / r**2, lambda r: r**2 / mpmath.exp(r), INTERVAL,
                  len(DATA[precision].q) - 1, precision.digits, (Fraction(1, 2),))


def approximation(precision: Precision) -> Fraction:
    """A proved bound of the relative error of 2^k (1 + r + r² q(r)) without roundings."""
    from coscrew_codegen.program.elementary.proofs.minimax import difference, ln2, supremum

    data = DATA[precision]
    taylor = [Fraction(1)]
    for i in range(1, 24):
        taylor.append(taylor[-1] / i)
    rest = 2 * INTERVAL[1]**24 * taylor[-1] / 24  # of the series, INTERVAL[1] being larger
    error = difference([Fraction(1), Fraction(1), *data.q], taylor)
    polynomial = supremum(error, taylor[:4], INTERVAL)
    largest_k = 2 - 2 * min(data.limits)
    split = largest_k * max(abs(x - sum(data.ln2)) for x in ln2())
    return polynomial + 2 * rest + 2 * split


def reduction(precision: Precision) -> None:
    """Proves that x - k ln2[0] is exact, and that r without roundings is in INTERVAL."""
    from coscrew_codegen.program.elementary.proofs.roundings import Roundings, given

    analysis = Roundings(precision)
    least, largest = DATA[precision].limits
    binades = [(Fraction(-1, 8), Fraction(1, 8))]
    binades += [(Fraction(2)**n, min(2 * Fraction(2)**n, Fraction(largest))) for n in range(-3, 10)]
    binades += [(max(-2 * Fraction(2)**n, Fraction(least)), -Fraction(2)**n) for n in range(-3, 10)]
    for low, high in binades:
        if low < high:
            x = analysis.within(low, high)
            exact, r = analysis.results(kernel(precision), ["high", "r"], [x], {
                **given({"within": x}), "k": analysis.chosen})
            assert not exact.error.radius
            assert INTERVAL[0] <= analysis.number(r.exact.range[0])
            assert analysis.number(r.exact.range[1]) <= INTERVAL[1]


def roundings(precision: Precision) -> Fraction:
    """A proved bound of the error in ulps of a result in the normal range.

    `reduction` gives the range of high, which is cut into pieces.  The scaling of e^r is exact."""
    from coscrew_codegen.program.elementary.proofs.roundings import Roundings, given, pieces

    data, relative, worst = DATA[precision], approximation(precision), Fraction(0)
    first, last = (3 * x // 2 + 1 for x in (data.limits[0] - 2, data.limits[1]))  # k
    rests, near_zero = (first * data.ln2[1], last * data.ln2[1]), Fraction(1, 2**12)
    for low, high in pieces(INTERVAL[0] + min(rests), INTERVAL[1] + max(rests), 64,
                            (-near_zero, near_zero)):
        analysis = Roundings(precision)
        result, = analysis.results(
            kernel(precision), ["e_r"], [analysis.within(*data.limits)],
            given({"k": analysis.within(first, last, 0), "high": analysis.within(low, high)}))
        worst = max(worst, analysis.ulps(result, relative))
    return worst


def comment(precision: Precision) -> str:
    data = DATA[precision]
    return ("x = k ln 2 + r, |r| <= ln 2 / 2, ln 2 as a sum of two numbers; e^r = 1 + r + "
            f"r^2 q(r), q of degree {len(data.q) - 1}, to 2^{float(data.approximation):g}; with "
            f"all roundings within {float(data.error):g} ulp (both proved), results below the "
            f"normal range within {float(1 + data.error) / 2:.2f} of the least subnormal number.")


FUNCTION = Elementary("exp", "y = exp x", INPUTS, OUTPUTS, kernel,
                      lambda precision: DATA[precision].error, comment)
