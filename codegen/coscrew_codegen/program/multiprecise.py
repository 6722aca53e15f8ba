"""Programs on MPFR's numbers with any number of digits: elementary functions are rounded once, and
results without a finite value are infinite or NaN, as in C."""

import math

import gmpy2
from gmpy2 import mpfr, mpq

from coscrew_codegen.program.interpreter import Arithmetic, by_operation, exactly
from coscrew_codegen.program.program import Constant
from coscrew_codegen.program.values.formats import DOUBLE, Precision


def precise(digits: int) -> "gmpy2.context":
    """The context, to be entered, of numbers with so many decimal digits."""
    return gmpy2.context(precision=math.ceil((digits + 1) * math.log2(10)))


def multiprecise(precision: Precision) -> Arithmetic[mpfr]:
    """Operations of gmpy2; constants are the exact ones of the precision, rounded to the context's
    digits."""
    def constant(x: Constant) -> mpfr:
        value = getattr(x, precision.name)
        return mpfr(mpq(value.numerator, value.denominator))

    return by_operation(constant, exactly(gmpy2), mpfr("nan"))


MULTIPRECISE = multiprecise(DOUBLE)
"""The model's: that of double precision."""
