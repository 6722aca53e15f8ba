"""Programs on MPFR's numbers with any number of digits: elementary functions are rounded once, and
results without a finite value are infinite or NaN, as in C."""

import math

import gmpy2
from gmpy2 import mpfr, mpq

from coscrew_codegen.program.interpreter import by_operation, exactly


def precise(digits: int) -> "gmpy2.context":
    """The context, to be entered, of numbers with so many decimal digits."""
    return gmpy2.context(precision=math.ceil((digits + 1) * math.log2(10)))


MULTIPRECISE = by_operation(
    lambda x: mpfr(mpq(x.double.numerator, x.double.denominator)), exactly(gmpy2), mpfr("nan"))
"""Operations of gmpy2; constants are the exact ones, rounded to the context's digits."""
