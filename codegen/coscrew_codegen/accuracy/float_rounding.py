"""Rule by which floating-point formats round, for the bounds of a Program's values.

Rounding a number z up to m errs by at most u times the largest power of two below m.  Rounding is
monotonic, so that the rounded number is at most m rounded up."""

from collections.abc import Sequence
from fractions import Fraction
from math import ceil, frexp, inf, isfinite, ldexp

from coscrew_codegen.accuracy.rounding_rules import RoundedRange, above, below
from coscrew_codegen.program import Constant, Instruction
from coscrew_codegen.program.elementary.sincos import FUNCTION as SINCOS
from coscrew_codegen.program.program import scales
from coscrew_codegen.program.roundoff import Upward
from coscrew_codegen.program.values.formats import Precision


class FloatRounding:
    """The rule of a precision.  One that is `plain` bounds roundings by exact values alone, as
    statements without stated ranges do."""

    def __init__(self, precision: Precision, plain: bool = False) -> None:
        self._precision, self._plain = precision, plain
        self._u, self._eta = Upward(precision.u), above(precision.eta)
        self._most = float(precision.limit("max"))
        self._normal = float(precision.smallest_normal)
        self._of_sine = above(SINCOS.error(precision))

    def constant(self, x: Constant) -> RoundedRange:
        """The exact decimal, and its error and size when rounded."""
        value = self._precision.value(x)
        near = abs(float(self._precision.rounded(value)))
        return RoundedRange(above(abs(value)), above(abs(abs(value) - Fraction(near))),
                            self._known(near), below(abs(value)))

    def rounding(self, step: Instruction, before: Upward, operands: Sequence[RoundedRange] = ()
                 ) -> tuple[Upward, Upward]:
        """Bounds the error of rounding a number up to `before`, and the rounded number."""
        if scales(step):
            return self._eta, self._known(self._up(before) if isfinite(before) else inf)
        if not before or before > self._most:
            return Upward(inf if before else 0), before
        mantissa, exponent = frexp(before)
        binade = exponent - 1 - (mantissa == 0.5 and not self._plain)
        return max(Upward(ldexp(self._u, binade)), self._eta), self._known(self._up(before))

    def function(self, step: Instruction, x: RoundedRange, size: Upward) -> tuple[Upward, Upward]:
        """Bounds a sine's or cosine's own error and size: up to s, its ulp is at most 2 u s, and at
        most u; none exceeds 1."""
        own = max(self._u * min(1.0, 2 * (size + x.error)), Upward(2 * self._eta))
        return self._of_sine * own, self._known(1.0)

    def _known(self, size: float) -> Upward:
        return Upward(inf if self._plain else size)

    def _up(self, x: Upward) -> float:
        """The least number of the precision that is not below, subnormal ones apart."""
        if x < self._normal:
            return x + 2 * self._eta
        mantissa, exponent = frexp(x)
        digits = self._precision.digits
        return ldexp(ceil(ldexp(mantissa, digits)), exponent - digits)
