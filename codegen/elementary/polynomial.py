"""Polynomials and constants of a format, as elementary functions use them."""

from collections.abc import Sequence
from fractions import Fraction

from coscrew_codegen.elementary.steps import Value
from coscrew_codegen.formats import Format


def numbers(text: str) -> tuple[Fraction, ...]:
    """Hexadecimal numbers of a format, exactly."""
    return tuple(Fraction(float.fromhex(word)) for word in text.split())


def hexadecimal(values: Sequence[Fraction]) -> str:
    """The text of numbers of a format."""
    return " ".join(float(value).hex() for value in values)


def integer_shift(precision: Format) -> Fraction:
    """1.5 · 2^(digits - 1): (x + it) - it is the integer nearest to x, for |x| < 2^(digits - 2)."""
    return Fraction(3 * 2**(precision.digits - 2))


def estrin(coefficients: Sequence[Fraction], x: Value) -> Value:
    """Σ c_i x^i, neighbours first and then pairs of pairs, so that few steps wait for others."""
    terms: list[Value | Fraction] = list(coefficients)
    power = x
    while len(terms) > 1:
        pairs = [(terms[i], terms[i + 1:i + 2]) for i in range(0, len(terms), 2)]
        terms = [power * above[0] + first if above else first for first, above in pairs]
        if len(terms) > 1:
            power = power * power
    if not isinstance(terms[0], Value):
        raise ValueError("the polynomial is a constant")
    return terms[0]


def horner(coefficients: Sequence[Fraction], x: Value) -> Value:
    """Σ c_i x^i with the fewest steps, each waiting for the last."""
    *rest, last = coefficients
    value = x * last + rest.pop()
    while rest:
        value = value * x + rest.pop()
    return value
