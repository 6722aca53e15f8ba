"""atan2(y, x) = m π/4 ± arctan(n/d), n/d = a/b or, above 1/2, (a - b)/(a + b); a <= b are |x|, |y|.

a - b is exact, a + b carries its rounding error.  The quotient is h + c: h, half the digits of n
(1/d), has exact products with both halves of d, so that c = (n - h d)/d hardly errs.  arctan(h + c)
= h + (c + q³ p(q²)), q the quotient rounded.  Both numbers are scaled so that products neither
overflow nor, wherever the result is normal, underflow."""

from dataclasses import dataclass
from fractions import Fraction
from functools import cache

from coscrew_codegen.program import Op, Program
from coscrew_codegen.program.elementary.elementary_function import Elementary
from coscrew_codegen.program.elementary.evaluation.polynomial import estrin, numbers
from coscrew_codegen.program.elementary.evaluation.step_writer import StepValue, StepWriter
from coscrew_codegen.program.values.formats import DOUBLE, SINGLE, Precision
from coscrew_codegen.program.values.quantity import ANY, SCALAR, Argument

INPUTS = Argument("y", SCALAR, ANY), Argument("x", SCALAR, ANY)
OUTPUTS = (Argument("angle", SCALAR),)
INTERVAL = Fraction(0), Fraction(1, 4)  # of q²


@dataclass(frozen=True)
class Atan2Coefficients:
    """Numbers that differ between the formats."""

    p: tuple[Fraction, ...]
    quarter: tuple[Fraction, ...]  # π/4: its leading bits, so that 3 times it is exact; the rest
    least: tuple[int, int]  # exponents: b below 2^first is scaled by 2^second
    largest: tuple[int, int]  # b above 2^first is scaled by 2^second
    approximation: Fraction  # proved: log2 of the relative error up to 1/2, roundings apart
    error: Fraction  # proved, with the roundings, in ulps of the result


DATA = {
    DOUBLE: Atan2Coefficients(numbers("""
        -0x1.5555555555516p-2 0x1.999999999113cp-3 -0x1.249249215db3cp-3
        0x1.c71c7090d5997p-4 -0x1.745cf4c91ec46p-4 0x1.3b113d9dbf0e5p-4
        -0x1.10f31d9cc61e3p-4 0x1.dfe9627a054e2p-5 -0x1.a39802a564522p-5
        0x1.56f4a3e94a12fp-5 -0x1.c17c0e38c5411p-6 0x1.4b7ea0b1417fep-7"""),
        numbers("0x1.921fb54442d18p-1 0x1.1a62633145c07p-55"),
        (60, 930), (990, -40), Fraction("-57.7"), Fraction("0.934")),
    SINGLE: Atan2Coefficients(numbers("""
        -0x1.5555520000000p-2 0x1.9997440000000p-3 -0x1.2450300000000p-3
        0x1.c072680000000p-4 -0x1.480d400000000p-4 0x1.3fd5540000000p-5"""),
        numbers("0x1.921fb80000000p-1 -0x1.5dde980000000p-24"),
        (28, 82), (110, -20), Fraction("-31.7"), Fraction("0.896"))}


@cache
def kernel(precision: Precision) -> Program:
    """(y, x) -> atan2(y, x)"""
    data = DATA[precision]
    steps = StepWriter(*INPUTS)
    y, x = steps.inputs()
    height, width = steps.named("height", abs(y)), steps.named("width", abs(x))
    steep = steps.named("steep", width < height)
    a, b = _scaled(steep.where(width, height), steep.where(height, width), precision)
    above = steps.named("above", b < a + a)

    side = steps.named("side", steps.do(Op.COPYSIGN, 1, x))
    sign = steps.named("sign", steep.where(-side, side))
    quarters = steps.named("quarters", steep.where(2, 2 - (side + side)) + above.where(sign, 0))
    base = steps.named("base", quarters * data.quarter[0])

    total = steps.named("total", a + b)
    n = steps.named("n", sign * above.where(a - b, a))
    rest = steps.named("rest_of_d", above.where((b - total) + a, 0))
    d = steps.named("d", above.where(total, b))
    inverse = steps.named("inverse", 1 / d)
    high = steps.named("q_high", _leading_half(n * inverse, precision))
    d_high = steps.named("d_high", _leading_half(d, precision))
    d_low = steps.named("d_low", d - d_high)
    c = steps.named("but_high", n - high * d_high)
    c = steps.named("but_low", c - high * d_low)
    c = steps.named("c", (c - high * rest) * inverse)
    q = steps.named("q", high + c)
    z = steps.named("z", q * q)
    tail = ((q * z) * estrin(data.p, z) + c) + quarters * data.quarter[1]
    tail = steps.named("tail", tail)
    sum_ = steps.named("sum", base + high)
    angle = steps.named("positive", sum_ + (((base - sum_) + high) + tail))
    return steps.program("atan2", OUTPUTS, [
        steps.named("angle", steps.do(Op.COPYSIGN, angle, y))])


def _leading_half(x: StepValue, precision: Precision) -> StepValue:
    """x rounded to half its digits.  Source: Veltkamp."""
    wide = x * Fraction(2**(precision.digits - precision.digits // 2) + 1)
    return wide - (wide - x)


def _scaled(a: StepValue, b: StepValue, precision: Precision) -> tuple[StepValue, StepValue]:
    """a and b times a power of two.  If b is infinite, the results only tell whether a is infinite,
    too; b = 0, with a = 0, becomes another number."""
    data, steps = DATA[precision], a.steps
    (least, up), (most, down) = ((Fraction(2)**x for x in pair)
                                 for pair in (data.least, data.largest))
    largest = precision.limit("max")
    a, b = steps.named("a", a), steps.named("b", b)
    infinite = steps.named("infinite", b > largest)
    scale = (b < least).where(up, (b > most).where(down, 1))
    scale = steps.named("scale", infinite.where(0, scale))
    a = steps.named("scaled_a", (a > largest).where(1, a * scale))
    b = infinite.where(1, b * scale)
    return a, steps.named("scaled_b", b.equals(0).where(1, b))


def derived(precision: Precision) -> tuple[Fraction, ...]:
    """p, fitted so that the relative error of q + q³ p(q²) is least."""
    import mpmath

    from coscrew_codegen.program.elementary.proofs.minimax import fitted

    def function(z: mpmath.mpf) -> mpmath.mpf:
        q = mpmath.sqrt(z)
        return (mpmath.atan(q) / q - 1) / z

    def weight(z: mpmath.mpf) -> mpmath.mpf:
        q = mpmath.sqrt(z)
        return z * q / mpmath.atan(q)

    return fitted(function, weight, INTERVAL, len(DATA[precision].p) - 1, precision.digits)


def approximation(precision: Precision) -> Fraction:
    """A proved bound of the relative error of q + q³ p(q²) for |q| <= 1/2: Taylor's series of
    arctan q / q alternates in z = q²."""
    from coscrew_codegen.program.elementary.proofs.minimax import difference, supremum

    taylor = [Fraction((-1)**i, 2 * i + 1) for i in range(50)]
    rest = INTERVAL[1]**50 / 101
    least = [Fraction(1), Fraction(-1, 3)]  # of the series
    error = difference([Fraction(1), *DATA[precision].p], taylor)
    return supremum(error, least, INTERVAL) + 2 * rest


def comment(precision: Precision) -> str:
    data = DATA[precision]
    return ("arctan(a/b), and pi/4 + arctan((a - b)/(a + b)) above 1/2, a <= b being |x| and |y|; "
            f"arctan q = q + q^3 p(q^2), p of degree {len(data.p) - 1}, to "
            f"2^{float(data.approximation):g}; the quotient to more than its digits; with all "
            f"roundings within {float(data.error):g} ulp (both proved), results below the normal "
            "range within 0.51 of the least subnormal number.")


FUNCTION = Elementary("atan2", "angle = atan2(y, x)", INPUTS, OUTPUTS, kernel,
                      lambda precision: DATA[precision].error, comment)
