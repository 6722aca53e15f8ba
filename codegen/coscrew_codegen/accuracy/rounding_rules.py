"""Bounds of the size and of the rounding error of every value of a Program, for all arguments up to
given sizes; how a format rounds is a rule that callers choose.

For every value, with x exact and x̂ computed, |x| <= size, |x̂ - x| <= error, |x̂| <= computed.

    a ± b        size a + size b; error a + error b, and a rounding
    a b          size a size b; size a error b + size b error a + error a error b, and a rounding
    a / b        for |b| >= low: size a / low; (error a + size error b) / (low - error b), and a
                 rounding
    sin a, cos a min(1, size a), or 1; error a and the function's own
    s x ± c y    where s and c are sine and cosine of the same number: at most √(x² + y²), and by
                 errors of x and y at most √(error x² + error y²); so rotations enlarge nothing
    xᵢ² ± xⱼ² …  of components of one quaternion: at most the largest |q|², and at least the least
                 if all are added; xᵢ xⱼ ± … at most half of that

Constants are the exact decimals.  Each of these bounds is rounded up."""

from collections.abc import Callable, Mapping, Sequence
from fractions import Fraction
from math import inf, nextafter
from typing import NamedTuple, Protocol

from coscrew_codegen.program import (
    Constant,
    Input,
    Instruction,
    NotANumber,
    Op,
    Operand,
    Program,
    Ref,
)
from coscrew_codegen.program.roundoff import Upward, length, product_error

_CIRCULAR = {Op.SIN, Op.COS}
SQUARE = (Fraction(999, 1000), Fraction(1001, 1000))
"""The limits of |quaternion|² in stated ranges."""


class Quadratic(NamedTuple):
    """A sum ± of squares of components of a quaternion, or of products of two, each once."""

    components: frozenset[Input]
    squares: bool
    added: bool = True  # whether no sign is minus


class RoundedRange(NamedTuple):
    """Bounds of a value, and what further rules need to know of it."""

    size: Upward
    error: Upward = Upward(0)
    computed: Upward = Upward(inf)
    low: Upward = Upward(0)  # bound of its size from below
    circular: tuple[Op, Operand] | None = None  # of a sine or cosine, or a multiple: the argument
    factor: "RoundedRange | None" = None  # of a multiple: the other factor
    rest: Upward = Upward(0)  # of a multiple: error less that of the other factor
    quadratic: Quadratic | None = None
    own: Upward = Upward(0)  # error of its own rounding or function


FOLLOWED = frozenset({Op.ADD, Op.SUB, Op.MUL, Op.DIV, Op.NEG, *_CIRCULAR})
"""Operations that the rules know."""
UNKNOWN = RoundedRange(Upward(inf), Upward(inf))


class RoundingRule(Protocol):
    """A format: the errors of its constants, roundings and functions."""

    def constant(self, x: Constant) -> RoundedRange:
        """Bounds of a constant as it is stored."""
        ...

    def rounding(self, step: Instruction, before: Upward, operands: Sequence[RoundedRange]
                 ) -> tuple[Upward, Upward]:
        """Bounds the rounding error of a sum, product or quotient up to `before`, and the size
        after rounding; inf where the format says nothing of that."""
        ...

    def function(self, step: Instruction, x: RoundedRange, size: Upward) -> tuple[Upward, Upward]:
        """Bounds the error and the size of a computed sine or cosine of x̂; the exact one of x is
        up to `size`."""
        ...


def followed(program: Program) -> bool:
    """Returns whether the rules know all of a program's operations."""
    return program.counts.keys() <= FOLLOWED and NotANumber() not in program.results


class ValueBounds:
    """The bounds of a program's values, for all arguments whose components are up to these sizes;
    `quaternions` are components of unit quaternions, four each."""

    def __init__(self, program: Program, sizes: Sequence[Sequence[float]], rule: RoundingRule,
                 quaternions: Sequence[Sequence[Input]] = ()) -> None:
        self._sizes, self._rule = sizes, rule
        self._quaternion = {x: frozenset(each) for each in quaternions for x in each}
        self._other: dict[Operand, RoundedRange] = {}
        self.by_name: dict[str, RoundedRange] = {}
        rules: Mapping[Op, Callable[[Instruction, Sequence[RoundedRange]], RoundedRange]] = {
            Op.ADD: self._total, Op.SUB: self._total, Op.MUL: self._product,
            Op.DIV: self._quotient, Op.SIN: self._circular, Op.COS: self._circular,
            Op.NEG: lambda _, x: x[0]._replace(own=Upward(0), low=Upward(0), quadratic=None)}
        for step in program.instructions:
            apply = rules.get(step.op)
            self.by_name[step.name] = UNKNOWN if apply is None else apply(
                step, [self.of(x) for x in step.operands])
        self.results = tuple(self.of(x) for x in program.results)

    def of(self, x: Operand) -> RoundedRange:
        """The bounds of an operand."""
        if isinstance(x, Ref):
            return self.by_name[x.name]
        if x not in self._other:
            self._other[x] = self._leaf(x)
        return self._other[x]

    def _leaf(self, x: Operand) -> RoundedRange:
        if isinstance(x, Input):
            size = Upward(self._sizes[x.argument][x.index])
            return RoundedRange(size, computed=size)
        if isinstance(x, Constant):
            return self._rule.constant(x)
        assert isinstance(x, NotANumber)
        return UNKNOWN

    def _rounded(self, step: Instruction, operands: Sequence[RoundedRange], size: Upward,
                 error: Upward, computed: Upward) -> RoundedRange:
        """The bounds of a result, given those before rounding."""
        own, stored = self._rule.rounding(step, min(size + error, computed), operands)
        return RoundedRange(size, error + own, stored, own=own)

    def _total(self, step: Instruction, operands: Sequence[RoundedRange]) -> RoundedRange:
        a, b = operands
        size, error = a.size + b.size, a.error + b.error
        if _turn(a, b):
            assert a.factor and b.factor
            size = min(size, length(a.factor.size, b.factor.size))
            error = min(error, length(a.factor.error, b.factor.error) + a.rest + b.rest)
        quadratic = self._joined(step, a.quadratic, b.quadratic)
        if quadratic:
            size = min(size, _largest(quadratic))
        result = self._rounded(step, operands, size, error, a.computed + b.computed)
        return result._replace(low=self._least(quadratic), quadratic=quadratic) if quadratic \
            else result

    def _joined(self, step: Instruction, a: Quadratic | None, b: Quadratic | None
                ) -> Quadratic | None:
        if not a or not b or a.squares != b.squares or a.components & b.components:
            return None
        components = a.components | b.components
        if not components <= self._quaternion[next(iter(components))]:
            return None
        return Quadratic(components, a.squares, step.op is Op.ADD and a.added and b.added)

    def _least(self, x: Quadratic) -> Upward:
        whole = x.squares and x.added and x.components == self._quaternion[
            next(iter(x.components))]
        return below(SQUARE[0]) if whole else Upward(0)

    def _product(self, step: Instruction, operands: Sequence[RoundedRange]) -> RoundedRange:
        a, b = operands
        size, error = a.size * b.size, product_error(a.size, a.error, b.size, b.error)
        quadratic = self._square(*step.operands)
        if quadratic:
            size = min(size, _largest(quadratic))
        result = self._rounded(step, operands, size, error, a.computed * b.computed)
        for x, y in ((a, b), (b, a)):
            if x.circular and not x.factor:
                rest = x.error * y.size + a.error * b.error + result.own
                return result._replace(circular=x.circular, factor=y, rest=rest)
        return result._replace(quadratic=quadratic) if quadratic else result

    def _square(self, a: Operand, b: Operand) -> Quadratic | None:
        """The product of two components of a quaternion."""
        if not isinstance(a, Input) or not isinstance(b, Input) or (
                b not in self._quaternion.get(a, ())):
            return None
        return Quadratic(frozenset((a, b)), a == b)

    def _quotient(self, step: Instruction, operands: Sequence[RoundedRange]) -> RoundedRange:
        a, b = operands
        size = a.size / b.low
        left = Upward(max(0.0, nextafter(b.low - b.error, 0)))
        return self._rounded(step, operands, size, (a.error + size * b.error) / left,
                             Upward(inf))

    def _circular(self, step: Instruction, operands: Sequence[RoundedRange]) -> RoundedRange:
        x, = operands
        size = min(Upward(1), x.size) if step.op is Op.SIN else Upward(1)
        own, stored = self._rule.function(step, x, size)
        return RoundedRange(size, x.error + own, stored, circular=(step.op, step.operands[0]),
                            own=own)


def above(x: Fraction) -> Upward:
    """The number as a float, rounded up."""
    near = float(x)
    return Upward(near if near >= x else nextafter(near, inf))


def below(x: Fraction) -> Upward:
    """The number as a float, rounded down."""
    near = float(x)
    return Upward(near if near <= x else nextafter(near, 0))


def _largest(x: Quadratic) -> Upward:
    return above(SQUARE[1] if x.squares else SQUARE[1] / 2)


def _turn(a: RoundedRange, b: RoundedRange) -> bool:
    """Returns whether these are multiples of a sine and a cosine of the same number."""
    return (a.circular is not None and b.circular is not None and None not in (a.factor, b.factor)
            and a.circular[0] is not b.circular[0] and a.circular[1] == b.circular[1])
