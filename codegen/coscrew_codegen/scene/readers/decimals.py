"""Reads the decimal numbers of files exactly."""

import re
from decimal import Decimal
from fractions import Fraction

from coscrew_codegen.scene.readers.scene_error import shown

LARGEST = Fraction(10)**300
"""Larger numbers, or nonzero ones below its inverse, would overflow in computations."""

_DECIMAL = re.compile(r"[+-]?(?:[0-9]+\.?[0-9]*|\.[0-9]+)(?:[eE][+-]?[0-9]{1,4})?")
_NOT_FINITE = re.compile(r"[+-]?(?:nan|inf|infinity)", re.IGNORECASE)
_LENGTH = 100


def decimal(text: str) -> Fraction:
    """The number in a text such as "-1.5e-3".  Raises ValueError with what came and was wanted."""
    if _NOT_FINITE.fullmatch(text):
        raise ValueError(f"{text} is not finite; wanted a number")
    if len(text) > _LENGTH or not _DECIMAL.fullmatch(text):
        raise ValueError(f"{shown(text)} is no number; wanted a decimal number such as 1.5e-3")
    return bounded(Fraction(Decimal(text)), text)


def numbers_in(text: str, count: int) -> tuple[Fraction, ...]:
    """The numbers in a text, `count` between blanks.  Raises ValueError as `decimal`."""
    words = text.split()
    if len(words) != count:
        raise ValueError(f"{shown(text)}; wanted {count} number{'s' * (count > 1)}")
    return tuple(map(decimal, words))


def bounded(number: Fraction, text: str) -> Fraction:
    """The number, if it is within range; raises ValueError if not."""
    if number and not 1 / LARGEST <= abs(number) <= LARGEST:
        raise ValueError(f"{shown(text)} is out of range; wanted 0, or 1e-300 to 1e300 in size")
    return number
