"""Polynomials and constants of a format, as elementary functions use them."""

from collections.abc import Sequence
from fractions import Fraction

from coscrew_codegen.program.elementary.evaluation.step_writer import StepValue
from coscrew_codegen.program.values.formats import Format


def numbers(text: str) -> tuple[Fraction, ...]:
    """Hexadecimal numbers of a format, exactly."""
    return tuple(Fraction(float.fromhex(word)) for word in text.split())


def integer_shift(precision: Format) -> Fraction:
    """1.5 · 2^(digits - 1): (x + it) - it is the integer nearest to x, for |x| < 2^(digits - 2)."""
    return Fraction(3 * 2**(precision.digits - 2))


def estrin(coefficients: Sequence[Fraction], x: StepValue) -> StepValue:
    """Σ c_i x^i, neighbours first and then pairs of pairs, so that few steps wait for others.  The
    first term, the largest, is added last, so that the sum is rounded once to its digits."""
    first, *terms = coefficients
    values: list[StepValue | Fraction] = list(terms)
    power = x
    while len(values) > 1:
        pairs = [(values[i], values[i + 1:i + 2]) for i in range(0, len(values), 2)]
        values = [power * above[0] + here if above else here for here, above in pairs]
        if len(values) > 1:
            power = power * power
    return x * values[0] + first


def horner(coefficients: Sequence[Fraction], x: StepValue) -> StepValue:
    """Σ c_i x^i with the fewest steps, each waiting for the last."""
    *rest, last = coefficients
    value = x * last + rest.pop()
    while rest:
        value = value * x + rest.pop()
    return value
