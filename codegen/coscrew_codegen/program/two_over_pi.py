"""The digits of 2/π that matter to a large number.

2/π is the sum of chunks of half the digits of a format, rounded to nearest, so that their products
with halves of numbers are exact.  A number x of d digits and exponent e uses the chunks from
`index(e)` on: its lower half times earlier chunks, and its upper half times that chunk, too, are
multiples of 4, whole turns.  Chunks are scaled so that none is subnormal."""

from dataclasses import dataclass
from fractions import Fraction
from functools import cache
from itertools import pairwise
from typing import Any

EXTRA = 9
"""Number of chunks after the first one that the largest exponent uses."""


@dataclass(frozen=True)
class Chunks:
    """chunk n = 2^scale times a multiple of 2^-bits(n - 1), at most half of 2^-bits(n - 2)."""

    bits: int
    scale: int
    values: tuple[Fraction, ...]
    offset: int

    def index(self, exponent: int) -> int:
        """Index of the first chunk that a number of this exponent, more than `offset`, uses."""
        return (exponent - self.offset) // self.bits


@cache
def pi(bits: int) -> Fraction:
    """π, to 2^-bits.  Source: Machin, 16 arccot 5 - 4 arccot 239."""
    one = 2**(bits + 16)  # fewer than 2^10 terms, each too small by less than 2

    def arccot(n: int) -> int:
        total, power, k = 0, one // n, 1
        while power:
            total += (2 - k % 4) * (power // k)
            power, k = power // n**2, k + 2
        return total

    return Fraction(16 * arccot(5) - 4 * arccot(239), one)


@cache
def chunks(digits: int) -> Chunks:
    """The chunks for binary64 (53 digits) or binary32 (24)."""
    bits, largest = digits // 2, {53: 1024, 24: 128}[digits]
    offset = digits - 2 * bits + 1
    last = (largest - offset) // bits + EXTRA
    quotient = 2 / pi(bits * (last + 2))
    units = [Fraction(2)**(-bits * (n - 1)) for n in range(last + 1)]
    sums = [round(quotient / unit) * unit for unit in units]
    scale = largest * 3 // 4
    return Chunks(bits, scale, tuple((b - a) * 2**scale for a, b in pairwise((Fraction(0), *sums))),
                  offset)


def chunk(x: Any, number: Any, digits: Any) -> Fraction:
    """2^scale times the chunk `number` places after the first one that x uses."""
    some, size = chunks(int(digits)), abs(Fraction(x))
    exponent = size.numerator.bit_length() - size.denominator.bit_length()
    if Fraction(2)**exponent > size:
        exponent -= 1
    return some.values[some.index(exponent) + int(number)]
