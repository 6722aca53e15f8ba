"""Sine and cosine of angles in fixed point, within 32 bits.

The angle is the integer q times 2^-f.  With k = round(q 2/π), r = q - k π/2 in 2^-31, modulo 2^32,
and z = r² in 2^-31, sin r = r - r z P(z) and cos r = 1 - z Q(z); results are in 2^-30."""

from dataclasses import replace
from fractions import Fraction
from functools import cache
from math import floor, inf, nextafter, sqrt

from coscrew_codegen.program import Input, Instruction, Op, Program, Ref
from coscrew_codegen.program.elementary.evaluation.polynomial import numbers
from coscrew_codegen.program.elementary.evaluation.step_writer import StepValue, StepWriter
from coscrew_codegen.program.fixed.fixed_value import FixedValue, above, half_unit, of_integer
from coscrew_codegen.program.roundoff import RoundedRange, Upward
from coscrew_codegen.program.values.quantity import SCALAR, Argument

BITS = 30
"""f of the results."""
LEAST_BITS = 18
"""Least f of an angle, which is then below 8192: so r is little larger than π/4."""
HALF_PI = 3373259426  # in 2^-31, to nearest
TWO_OVER_PI = 1367130551  # in 2^-31, to nearest
REDUCED = Fraction(78542, 100000)
"""Largest size of r: π/4, the rounding of q 2/π, and that of k π/2."""
SQUARES = Fraction(0), REDUCED**2
"""The interval of z."""
SINE = numbers("0x1.55555548p-3 -0x1.11110618p-7 0x1.a00e07c8p-13 -0x1.6c881130p-19")
COSINE = numbers("0x1.ffffffd0p-2 -0x1.55553dc8p-5 0x1.6c086128p-10 -0x1.992d2090p-16")
"""P and Q, fitted so that the errors of sine and cosine are least."""
APPROXIMATION = Fraction("2.4e-12"), Fraction("5.5e-11")
"""Proved: bounds of the errors of r - r z P(z) and 1 - z Q(z), roundings apart."""
OUTPUTS = (Argument("s", SCALAR), Argument("c", SCALAR))


def error(bits: int, reach: float) -> Upward | None:
    """A bound of the errors of sine and cosine of angles up to this size with this f; None if the
    angles are too large."""
    if bits < LEAST_BITS or reach == inf:
        return None
    whole, quarter = errors()
    return above(_quarters(reach) * quarter + whole)


def errors() -> tuple[Fraction, Fraction]:
    """Bounds of the errors of sine and cosine, and of the error more for each quarter turn."""
    return Fraction(_kernel()[1]), Fraction(above(_half_pi_error()))


def _quarters(reach: float) -> int:
    """The largest |k|."""
    return floor(Fraction(reach) * Fraction(6366198, 10**7) + Fraction(51, 100))


def _half_pi_error() -> Fraction:
    from coscrew_codegen.program.elementary.proofs.minimax import pi

    return max(abs(x / 2 - Fraction(HALF_PI, 2**31)) for x in pi())


def kernel() -> Program:
    """r in 2^-31 -> sin r, cos r in 2^-30, on integers."""
    return _kernel()[0]


@cache
def _kernel() -> tuple[Program, Upward]:
    """The kernel, and a bound of its errors as sine and cosine of r."""
    from coscrew_codegen.program.fixed.fixed_program import Products, in_fixed_point

    r, z = (FixedValue(Input(n, 0), 31, RoundedRange(above(size), error)) for n, (size, error) in
            enumerate(((REDUCED, Upward(0)), (REDUCED**2, half_unit(31)))))
    made = in_fixed_point(_plain(), ((r,), (z,)), Products.HIGH)
    r_, z_ = r.operand, Ref("z")
    steps = [Instruction("z_1", Op.WIDE_PRODUCT, (r_, r_, of_integer(0)), "z"),
             Instruction("z", Op.ROUNDED_SHIFT, (Ref("z_1"), of_integer(31)), "z"),
             *(step._replace(operands=tuple(z_ if x == z.operand else x for x in step.operands))
               for step in made.program.instructions)]
    errors, results = [], []
    for name, x, approximation in zip("sc", made.results, APPROXIMATION, strict=True):
        more = Upward(0)
        if x.bits > BITS:
            steps.append(Instruction(f"{name}_out", Op.ROUNDED_SHIFT,
                                     (x.operand, of_integer(x.bits - BITS)), name))
            x, more = x._replace(operand=Ref(f"{name}_out")), half_unit(BITS)
        results.append(x.operand)
        errors.append(x.error + more + above(approximation))
    return replace(made.program, inputs=made.program.inputs[:1], instructions=tuple(steps),
                   results=tuple(results)), max(errors)


def derived() -> tuple[tuple[Fraction, ...], tuple[Fraction, ...]]:
    """P and Q, fitted."""
    from mpmath import cos, sin, sqrt

    from coscrew_codegen.program.elementary.proofs.minimax import fitted

    return (fitted(lambda z: (1 - sin(sqrt(z)) / sqrt(z)) / z, lambda z: sqrt(z)**3, SQUARES,
                   len(SINE) - 1, 30),
            fitted(lambda z: (1 - cos(sqrt(z))) / z, lambda z: z, SQUARES, len(COSINE) - 1, 30))


def approximations() -> tuple[float, float]:
    """Proved bounds of the errors of r - r z P(z) and 1 - z Q(z)."""
    from coscrew_codegen.program.elementary.proofs.minimax import difference, product, supremum

    last, factorials = 12, [Fraction(1)]
    for i in range(1, 2 * last + 2):
        factorials.append(factorials[-1] / i)
    signs = [(-1)**i for i in range(last)]
    cosine = [x * s for x, s in zip(factorials[0:2 * last:2], signs, strict=True)]
    sine = [x * s for x, s in zip(factorials[1:2 * last:2], signs, strict=True)]  # divided by r
    rest = REDUCED**(2 * last) * factorials[2 * last]  # the series alternate and decrease
    of_sine = difference([Fraction(1), *(-x for x in SINE)], sine)
    squared = product(product(of_sine, of_sine), [Fraction(0), Fraction(1)])
    of_cosine = difference([Fraction(1), *(-x for x in COSINE)], cosine)
    one = [Fraction(1)]
    return (nextafter(sqrt(above(supremum(squared, one, SQUARES))), inf) + above(rest),
            float(above(supremum(of_cosine, one, SQUARES) + rest)))


def _plain() -> Program:
    steps = StepWriter(Argument("r", SCALAR), Argument("z", SCALAR))
    r, z = steps.inputs()
    sine = steps.named("sin_r", r - r * (z * _horner(SINE, z)))
    cosine = steps.named("cos_r", 1 - z * _horner(COSINE, z))
    return steps.program("kernel", OUTPUTS, (sine, cosine))


def _horner(coefficients: tuple[Fraction, ...], z: StepValue) -> StepValue:
    """The polynomial by Horner's rule."""
    total: StepValue | Fraction = coefficients[-1]
    for c in reversed(coefficients[:-1]):
        total = c + total * z
    assert isinstance(total, StepValue)
    return total
