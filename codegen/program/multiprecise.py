"""Programs on mpmath's numbers, of as many digits as its context has."""

import mpmath
from mpmath import mpf

from coscrew_codegen.program.interpreter import by_operation, exactly

MULTIPRECISE = by_operation(lambda x: mpf(x.double.numerator) / x.double.denominator,
                             exactly(mpmath), mpf("nan"))
"""Operations of mpmath; constants are the exact ones, rounded to its digits."""
