"""Rule by which floating-point formats round, for the bounds of a Program's values.

Rounding a number z up to m errs by at most u times the largest power of two below m.  Rounding is
monotonic, so that the rounded number is at most m rounded up."""

from collections.abc import Sequence
from fractions import Fraction
from math import ceil, frexp, inf, isfinite, ldexp

from coscrew_codegen.accuracy.rounding_rules import above, below
from coscrew_codegen.program import Constant, Instruction
from coscrew_codegen.program.elementary.sincos import FUNCTION as SINCOS
from coscrew_codegen.program.program import scales
from coscrew_codegen.program.roundoff import CIRCULAR, RoundedRange, Upward
from coscrew_codegen.program.values.formats import Precision


class FloatRounding:
    """The rule of a precision.  One that is `plain` bounds roundings by exact values alone, as
    statements without stated ranges do."""

    def __init__(self, precision: Precision, plain: bool = False) -> None:
        self.precision, self._plain, self.turns = precision, plain, not plain
        self.u, self.eta = Upward(precision.u), above(precision.eta)
        self._most = float(precision.limit("max"))
        self._normal = float(precision.smallest_normal)
        self._of_sine = above(SINCOS.error(precision))

    def constant(self, x: Constant) -> RoundedRange:
        """The exact decimal, and its error and size when rounded."""
        value = self.precision.value(x)
        near = abs(float(self.precision.rounded(value)))
        return RoundedRange(above(abs(value)), above(abs(abs(value) - Fraction(near))),
                            self._known(near), below(abs(value)))

    def operand(self, step: Instruction, place: int, x: RoundedRange) -> RoundedRange:
        """The operand as it is."""
        return x

    def rounded(self, step: Instruction, before: RoundedRange, operands: Sequence[RoundedRange]
                ) -> RoundedRange:
        """A sum, product or quotient rounded to nearest, or a sine or cosine."""
        if step.op in CIRCULAR:
            return before.rounded(self.of_circular(before.size, operands[0]), self._known(1.0))
        return before.rounded(*self.nearest(
            min(before.size + before.error, before.computed), scales(step)))

    def result(self, x: RoundedRange) -> RoundedRange:
        """The result as it is."""
        return x

    def nearest(self, top: Upward, exact: bool = False) -> tuple[Upward, Upward]:
        """Bounds the error of rounding a number up to `top`, and the rounded number; a product with
        a power of two is `exact` barring underflow."""
        if exact:
            return self.eta, self._known(self._up(top) if isfinite(top) else inf)
        if not top or top > self._most:
            return Upward(inf if top else 0), top
        mantissa, exponent = frexp(top)
        binade = exponent - 1 - (mantissa == 0.5 and not self._plain)
        return max(Upward(ldexp(self.u, binade)), self.eta), self._known(self._up(top))

    def of_circular(self, size: Upward, x: RoundedRange) -> Upward:
        """Bounds the own error of a sine or cosine up to `size` of x̂: up to s, its ulp is at most
        2 u s, and at most u."""
        return self._of_sine * max(self.u * min(1.0, 2 * (size + x.error)), 2 * self.eta)

    def _known(self, size: float) -> Upward:
        return Upward(inf if self._plain else size)

    def _up(self, x: Upward) -> float:
        """The least number of the precision that is not below, subnormal ones apart."""
        if x < self._normal:
            return x + 2 * self.eta
        mantissa, exponent = frexp(x)
        digits = self.precision.digits
        return ldexp(ceil(ldexp(mantissa, digits)), exponent - digits)
