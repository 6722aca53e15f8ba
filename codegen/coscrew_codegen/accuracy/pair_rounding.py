"""Rule by which pairs hi + lo round, for the bounds of a plain Program's values where all or some
instructions are carried in pairs (tiers pairs, accurate in double precision, mixed).

For each pair a bound L of |lo| is known: 0 for arguments.  All lo are sums of few terms, each
computed with one rounding, which errs by at most u times the sum of their sizes.

    sum      the rests of both operands are at most r + u (B + r) each, for r the rounding of hi and
             B the second operand's size; L is the sum of these and of the operands' L.  At most
             four additions and two rests are rounded: 8 u L
    product  operands are normalized first, if at all: that changes a pair by at most 2 u L, and
             leaves L = rounding of hi + 2 u L.  lo is the product's own rounding r and a_lo b + a
             b_lo; a_lo b_lo is left out: La Lb + 4 u L
    sine     of an exact argument: L is its error in ulps, and the pair's error relative

An instruction that is not carried has L = 0.  Operands that don't take part as hi + lo are rounded;
others add a_lo b + a b_lo, or a_lo and b_lo, to the rounded result, which is rounded again."""

from collections.abc import Sequence
from math import frexp, inf, ldexp

from coscrew_codegen.accuracy.rounding_rules import RoundedRange, above, below
from coscrew_codegen.accuracy.tiers.compensated import rest_of, rounded_constant
from coscrew_codegen.accuracy.tiers.mixed import Mixture
from coscrew_codegen.program import Constant, Input, Instruction, Op, Operand, Program, Ref
from coscrew_codegen.program.elementary.sincos import FUNCTION as SINCOS
from coscrew_codegen.program.elementary.sincos_error import ERROR as SINCOS_ERROR
from coscrew_codegen.program.roundoff import Upward
from coscrew_codegen.program.values.formats import Precision

_MORE = Upward(1 + 2.0**-10)  # above (1 + u)^k for all k here


class PairRounding:
    """The rule of a precision for a program whose instructions are all carried in pairs or, with a
    mixture, those that it names."""

    def __init__(self, program: Program, precision: Precision, mixture: Mixture | None = None
                 ) -> None:
        self._precision, self._mixture = precision, mixture
        self._u, self._eta = above(precision.u), above(precision.eta)
        self._most = float(precision.limit("max"))
        self._ulps = above(SINCOS.error(precision))
        self._relative = above(SINCOS_ERROR.error(precision))
        self._negated = {step.name: step.operands[0] for step in program.instructions
                         if step.op is Op.NEG}
        self._lows: dict[str, Upward] = {}

    def low(self, x: Operand) -> Upward:
        """L of an operand."""
        if isinstance(x, Constant):
            rest = rest_of(x, self._precision)
            return above(abs(rest.double)) if rest else Upward(0)
        if isinstance(x, Ref):
            other = self._negated.get(x.name)
            return self._lows[x.name] if other is None else self.low(other)
        return Upward(0)

    def final(self, x: Operand, bounds: RoundedRange) -> Upward:
        """The error of a result, hi + lo rounded."""
        return bounds.error + self._half(bounds.size + bounds.error) if self.low(x) \
            else bounds.error

    def constant(self, x: Constant) -> RoundedRange:
        """A constant as hi + lo."""
        value = self._precision.value(x)
        rest = rest_of(x, self._precision)
        kept = rounded_constant(x, self._precision).double + (rest.double if rest else 0)
        return RoundedRange(above(abs(value)), above(abs(value - kept)), low=below(abs(value)))

    def rounding(self, step: Instruction, before: Upward, operands: Sequence[RoundedRange]
                 ) -> tuple[Upward, Upward]:
        """Bounds the error that a carried or single sum or product adds."""
        if step.op is Op.DIV or before > self._most:
            self._lows[step.name] = Upward(inf)
            return Upward(inf), Upward(inf)
        sizes = [x.size + x.error + self.low(y)
                 for x, y in zip(operands, step.operands, strict=True)]
        if self._carried(step):
            of = self._product if step.op is Op.MUL else self._sum
            own, self._lows[step.name] = of(step, sizes)
        else:
            own, self._lows[step.name] = self._single(step, sizes), Upward(0)
        return own, Upward(inf)

    def function(self, step: Instruction, x: RoundedRange, size: Upward) -> tuple[Upward, Upward]:
        """Bounds the error of a sine or cosine of an argument, or of a single one of any value."""
        known = isinstance(step.operands[0], Input)
        ulps = self._ulps * max(self._u * min(1.0, 2 * (size + x.error)), self._eta + self._eta)
        if not self._carried(step):
            self._lows[step.name] = Upward(0)
            turned = Upward(0) if known else self._half(x.size + x.error + self.low(
                step.operands[0]))
            return ulps + turned, Upward(inf)
        self._lows[step.name] = ulps * _MORE if known else Upward(inf)
        return (self._relative * size + self._eta + self._eta if known else Upward(inf)), Upward(
            inf)

    def _carried(self, step: Instruction) -> bool:
        return self._mixture is None or step.name in self._mixture.paired

    def _half(self, size: Upward) -> Upward:
        """Bounds the rounding error of a number up to this size."""
        if not size or size > self._most:
            return Upward(inf if size else 0)
        return max(Upward(ldexp(self._u, frexp(size)[1] - 1)), self._eta)

    def _sum(self, step: Instruction, sizes: Sequence[Upward]) -> tuple[Upward, Upward]:
        a, b = sizes
        own = self._half(a + b)
        rest = own + self._u * (b + own)
        low = (rest + rest + self.low(step.operands[0]) + self.low(step.operands[1])) * _MORE
        return Upward(8) * (self._u * low + self._eta), low

    def _product(self, step: Instruction, sizes: Sequence[Upward]) -> tuple[Upward, Upward]:
        moved, (a, b) = self._normalized(step, sizes)
        cross = (a * sizes[1] + sizes[0] * b) * _MORE
        own = self._half(sizes[0] * sizes[1] * _MORE)
        low = (own + cross) * _MORE + self._eta
        return moved + a * b + Upward(4) * (self._u * low) + Upward(8) * self._eta, low

    def _normalized(self, step: Instruction, sizes: Sequence[Upward]
                    ) -> tuple[Upward, list[Upward]]:
        """Bounds the change of a product by the normalization of its operands, and their L after
        it or without it."""
        moves, lows = [], []
        for x, size in zip(step.operands, sizes, strict=True):
            low = self.low(x)
            moves.append(Upward(2) * self._u * low)
            lows.append(max(low, self._half(size * _MORE) + moves[-1]) if low else low)
        (a, b), (p, q) = sizes, moves
        return p * b * _MORE + a * q * _MORE, lows

    def _single(self, step: Instruction, sizes: Sequence[Upward]) -> Upward:
        """The error that is added by an instruction with one result."""
        assert self._mixture
        kept = [(step.name, place) in self._mixture.kept for place in range(2)]
        rounded = [Upward(0) if whole else self._dropped(x, size)
                   for whole, x, size in zip(kept, step.operands, sizes, strict=True)]
        (a, b), (p, q) = sizes, rounded
        if step.op is Op.MUL:
            moved, lows = self._normalized(step, sizes)
            lows = [low if whole else Upward(0) for low, whole in zip(lows, kept, strict=True)]
            own, cross = p * b + a * q + p * q, (lows[0] * b + a * lows[1]) * _MORE
            size, more = a * b, moved + lows[0] * lows[1]
        else:
            lows = [self.low(x) if whole else Upward(0)
                    for x, whole in zip(step.operands, kept, strict=True)]
            own, cross, size, more = p + q, (lows[0] + lows[1]) * _MORE, a + b, Upward(0)
        last = self._half((size + own) * _MORE)
        if any(lows):
            again = self._half((size + own + last + cross) * _MORE)
            own += more + again + Upward(4) * (self._u * cross + self._eta)
        return own + last

    def _dropped(self, x: Operand, size: Upward) -> Upward:
        """Bounds the error of an operand that is rounded to a single number."""
        low = self.low(x)
        return low if isinstance(x, Constant) or not low else self._half(size)
