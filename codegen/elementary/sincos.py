"""sin x and cos x, computed together.

With x = k π/2 + r - e, sin(r - e) = sin r - e cos r and cos(r - e) = cos r + e sin r to more than
twice the digits.  They are combined with the sine and cosine of k π/2, which are 0 and ±1."""

from fractions import Fraction

from coscrew_codegen.elementary import reduction
from coscrew_codegen.elementary.function import Elementary
from coscrew_codegen.elementary.polynomial import numbers
from coscrew_codegen.elementary.reduction import REDUCED, X, to_integer
from coscrew_codegen.elementary.steps import Steps, Value
from coscrew_codegen.formats import DOUBLE, SINGLE, Precision
from coscrew_codegen.program import Program
from coscrew_codegen.quantity import SCALAR, Argument

SIN_COS = (Argument("s", SCALAR), Argument("c", SCALAR))

SINE = {
    DOUBLE: numbers("""
        0x1.5555555555548p-3 -0x1.111111110f730p-7 0x1.a01a019be9211p-13 -0x1.71de35552ab65p-19
        0x1.ae5e4b833b99dp-26 -0x1.5d8b5558a0a8cp-33"""),
    SINGLE: numbers("0x1.555546p-3 -0x1.110776p-7 0x1.9952fap-13")}
"""sin r = r - r^3 (S0 + S1 r^2 + …)"""
COSINE = {
    DOUBLE: numbers("""
        0x1.555555555554bp-5 -0x1.6c16c16c1500dp-10 0x1.a01a019c8dd22p-16 -0x1.27e4f7f0508e6p-22
        0x1.1ee9dacbfea79p-29 -0x1.8fa5ecd75ed7cp-37"""),
    SINGLE: numbers("0x1.55554ap-5 -0x1.6c0c28p-10 0x1.99e80cp-16")}
"""cos r = 1 - r^2/2 + r^4 (C0 + C1 r^2 + …)"""


def polynomial(a: tuple[Fraction, ...], z: Value, z2: Value) -> Value:
    """a0 + a1 z + a2 z^2 + …: two terms at a time (Estrin), but a0, the largest, last."""
    return a[0] + (z * a[1] + z2 * (estrin(a[2:], z, z2) if len(a) > 3 else a[2]))


def estrin(a: tuple[Fraction, ...], z: Value, z2: Value) -> Value:
    """The same for an even number of terms, in the order in which it waits least."""
    pair = a[0] + z * a[1]
    return pair + z2 * estrin(a[2:], z, z2) if len(a) > 2 else pair


def kernel(precision: Precision) -> Program:
    """(quadrant, r, r_excess) to (sin x, cos x)."""
    steps = Steps(*REDUCED)
    k, r, excess = steps.inputs()
    z = steps.named("z", r * r)
    z2 = steps.named("z2", z * z)
    w = steps.named("w", 1 - z * Fraction(1, 2))
    sine = steps.named("sin_r", r - (z * r * polynomial(
        SINE[precision], z, z2) + excess * w))
    cosine = steps.named("cos_r", w + (((1 - w) - z * Fraction(1, 2)) + (z2 * polynomial(
        COSINE[precision], z, z2) + r * excess)))
    q = steps.named("q", to_integer(steps, k, precision, 4) - k)
    a = steps.named("cos_k", 1 - abs(q))
    b = steps.named("minus_sin_k", q * (1 + a))  # +0, not -0, for k = 0
    s = steps.named("s", sine * a - cosine * b)
    c = steps.named("c", cosine * a + sine * b)
    return steps.program("kernel", SIN_COS, (s, c))


def error(precision: Precision) -> Fraction:
    """In ulps of the result."""
    return Fraction(1)


def comment(precision: Precision) -> str:
    """What is said above the function."""
    terms = len(SINE[precision])
    bits = ", ".join(map(str, reduction.split(precision).last_bits))
    return (f"x = k pi/2 + r - r_excess, |r| <= pi/4 and a little, pi/2 in parts to 2^-({bits}) "
            f"and a rest; polynomials of degrees {2 * terms + 1} and {2 * terms + 2}.")


FUNCTION = Elementary("sincos", "(s, c) = (sin x, cos x)", (X,), SIN_COS, kernel, error, comment,
                      near=reduction.near, far=reduction.far,
                      limit=reduction.limit)
