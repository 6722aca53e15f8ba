"""Bounds and errors in few digits, which what is said of them must not make too small."""

from decimal import ROUND_UP, Context
from math import isfinite

_TWO = Context(prec=2, rounding=ROUND_UP)


def two_digits_up(x: float) -> str:
    """A number that is not negative in two digits, rounded up: 2.1e-15."""
    if not x or not isfinite(x):
        return f"{x:g}"
    mantissa, exponent = f"{_TWO.create_decimal(x):.1e}".split("e")
    return f"{mantissa}e{int(exponent)}"
