"""Numbers in few digits."""

from decimal import ROUND_UP, Context
from math import isfinite

_TWO = Context(prec=2, rounding=ROUND_UP)


def two_digits_up(x: float) -> str:
    """A number that is not negative in two digits, rounded up: 2.1e-15."""
    if not x or not isfinite(x):
        return f"{x:g}"
    mantissa, exponent = f"{_TWO.create_decimal(x):.1e}".split("e")
    return f"{mantissa}e{int(exponent)}"


def three_digits(x: float) -> str:
    """Three digits: 1.25, 1450, 1e-9."""
    digits, _, exponent = f"{float(f'{x:.2e}'):g}".partition("e")
    return f"{digits}e{int(exponent)}" if exponent else digits
