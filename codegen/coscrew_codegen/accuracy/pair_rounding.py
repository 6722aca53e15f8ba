"""Rule by which pairs hi + lo round, for the bounds of a plain Program's values where all or some
instructions are carried in pairs (tiers pairs, accurate in double precision, mixed).

Of each pair hi + lo bounds of |hi| and |lo| are known; lo = 0 for arguments.  An operand that has
a lo may be normalized: then |hi| grows by at most |lo|, |lo| by half, the error of rounding a
number of this size, and hi + lo changes by at most 2 u |lo|.  T and L are the bounds with this, and

    cross = La + Lb of a sum; Ta Lb + La Tb + La Lb of a product; (La + Ta Lb / d) / d of a
            quotient, where the divisor's hi is at least d = least - error - Lb

bounds what the lo of operands contribute.  For hi rounded with the error half, of a number up to m
= Ta + Tb, Ta Tb or Ta / d:

    in pairs  L = 3 half + 2 u m + cross: the rests of both operands of a sum are at most half +
              u (Tb + half) each.  lo is the sum of few terms, each computed with one rounding: 8
              u L.  Left out are a_lo b_lo of a product: La Lb, and lo times b_lo / b of a quotient
    single    hi plus the operands' contributions, rounded again: half of their sum, 8 u cross, and
              what is left out; just half if no operand has a lo
    sine      in pairs, of an exact argument: L is its error in ulps, and the pair's error relative.
              Of hi + lo: s c_lo + c s_lo in pairs, s and c those of hi: L <= 24 u, an error of
              at most 400 u², and 8 times the relative error

An operand that an instruction does not take as hi + lo is rounded before: half."""

from collections.abc import Sequence
from fractions import Fraction

from coscrew_codegen.accuracy.float_rounding import FloatRounding
from coscrew_codegen.accuracy.rounding_rules import above, below
from coscrew_codegen.accuracy.tiers.compensated import rest_of, rounded_constant
from coscrew_codegen.accuracy.tiers.mixed import Mixture
from coscrew_codegen.program import Constant, Instruction, Op
from coscrew_codegen.program.elementary.sincos_error import ERROR as SINCOS_ERROR
from coscrew_codegen.program.program import scales
from coscrew_codegen.program.roundoff import CIRCULAR, NONE, RoundedRange, Upward, down
from coscrew_codegen.program.values.formats import Precision

_MORE = Upward(1 + 2.0**-10)  # above (1 + u)^k for all k here


class PairRounding(FloatRounding):
    """The rule of a precision for a program whose instructions are all carried in pairs or, with a
    mixture, those that it names."""

    def __init__(self, precision: Precision, mixture: Mixture | None = None) -> None:
        super().__init__(precision)
        self._mixture, self.turns = mixture, False
        self._relative = above(SINCOS_ERROR.error(precision))

    def constant(self, x: Constant) -> RoundedRange:
        """A constant as hi + lo."""
        value, hi = self.precision.value(x), rounded_constant(x, self.precision).double
        rest = rest_of(x, self.precision)
        lo = rest.double if rest else Fraction(0)
        return RoundedRange(above(abs(value)), above(abs(value - hi - lo)), above(abs(hi)),
                            below(abs(value)), above(abs(lo)))

    def operand(self, step: Instruction, place: int, x: RoundedRange) -> RoundedRange:
        """The operand as hi + lo, or rounded."""
        if not x.low or self.carries(step) or (step.name, place) in self._kept:
            return x
        of = step.operands[place]
        return super().constant(of) if isinstance(of, Constant) else self.result(x)

    def rounded(self, step: Instruction, before: RoundedRange, operands: Sequence[RoundedRange]
                ) -> RoundedRange:
        """A result that is a pair, or a single number."""
        if step.op in CIRCULAR:
            return self._sine_or_cosine(step, before, *operands)
        (a, p), (b, q) = map(self._factor, operands)
        left = down(operands[1].least, operands[1].error, q)
        if step.op is Op.MUL:
            most, cross = a * b, a * q + p * b + p * q
        elif step.op is Op.DIV:
            most, cross = a / left, (p + a * q / left) / left
        else:
            most, cross = a + b, p + q
        half, stored = self.nearest(min(before.size + before.error + cross, most), scales(step))
        rests = half if step.op in (Op.MUL, Op.DIV) else Upward(2) * (half + self.u * b)
        low = (rests + cross) * _MORE + self.eta
        lost = p * q if step.op is Op.MUL else low * q / left if step.op is Op.DIV else NONE
        tiny = self.eta + self.eta / left if step.op is Op.DIV else self.eta
        if self.carries(step):
            own = lost + Upward(8) * (self.u * low + tiny)
            result = before.rounded(own, stored, low)
            return result._replace(computed=min(stored, result.size + result.error + low))
        if cross:
            again, stored = self.nearest((stored + cross) * _MORE)
            half = half + again + lost + Upward(8) * (self.u * cross + tiny)
        return before.rounded(half, stored)

    def result(self, x: RoundedRange) -> RoundedRange:
        """hi + lo rounded."""
        return x.rounded(*self.nearest(x.size + x.error)) if x.low else x

    def carries(self, step: Instruction) -> bool:
        """Returns whether the instruction's result is a pair."""
        return self._mixture is None or step.name in self._mixture.paired

    @property
    def _kept(self) -> frozenset[tuple[str, int]]:
        return self._mixture.kept if self._mixture else frozenset()

    def _factor(self, x: RoundedRange) -> tuple[Upward, Upward]:
        """Bounds of hi and lo of an operand that may have been normalized."""
        if not x.low:
            return x.computed, x.low
        hi = (x.computed + x.low) * _MORE
        return hi, max(x.low, self.nearest(hi)[0] + Upward(2) * self.u * x.low)

    def _sine_or_cosine(self, step: Instruction, before: RoundedRange, x: RoundedRange
                        ) -> RoundedRange:
        one, ulps = Upward(1), self.of_circular(before.size, x)
        if not self.carries(step):
            return before.rounded(ulps, one)
        if not x.low:
            size = min(one, before.size + before.error)
            return before.rounded(self._relative * size + self.eta + self.eta, one, ulps * _MORE)
        moved = Upward(2) * self.u * self._factor(x)[1]
        own = Upward(400) * self.u * self.u + moved + Upward(8) * (self._relative + self.eta)
        return before.rounded(own, one, Upward(24) * self.u)
