"""Bounds of the size and of the rounding error of every value of a Program, for all arguments up to
given sizes; how a format rounds is a rule that callers choose.

The rules of `program/roundoff.py`, those of turns in `vector_lengths.py`, and two of quaternions:

    xᵢ² ± xⱼ² …  of components of one quaternion: at most the largest |q|², and at least the least
                 if all are added; xᵢ xⱼ ± … at most half of that"""

from collections.abc import Iterator, Sequence
from fractions import Fraction
from math import inf, nextafter
from typing import NamedTuple, Protocol

from coscrew_codegen.accuracy.vector_lengths import Length, VectorLengths
from coscrew_codegen.algebra.recording.gc_pause import uncollected
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
from coscrew_codegen.program.roundoff import FOLLOWED, UNKNOWN, RoundedRange, Upward, combined

SQUARE = (Fraction(999, 1000), Fraction(1001, 1000))
"""The limits of |quaternion|² in stated ranges."""


class Quadratic(NamedTuple):
    """A sum ± of squares of components of a quaternion, or of products of two, each once."""

    components: frozenset[Input]
    squares: bool
    added: bool = True  # whether no sign is minus


class RoundingRule(Protocol):
    """A format: the errors of its constants, roundings and functions."""

    turns: bool
    """Whether lengths of vectors that are turned are followed; operands are then as they are."""

    def constant(self, x: Constant) -> RoundedRange:
        """Bounds of a constant as it is stored."""
        ...

    def operand(self, step: Instruction, place: int, x: RoundedRange) -> RoundedRange:
        """Bounds of an operand as the instruction takes it."""
        ...

    def rounded(self, step: Instruction, before: RoundedRange, operands: Sequence[RoundedRange]
                ) -> RoundedRange:
        """Bounds of the result of a sum, product, quotient, sine or cosine, from those before the
        rounding or the function's own error; infinite where the format says nothing."""
        ...

    def result(self, x: RoundedRange) -> RoundedRange:
        """Bounds of a result as it is returned."""
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
        self._quadratics: dict[Operand, Quadratic] = {}
        self._other: dict[Operand, RoundedRange] = {}
        self.lengths = VectorLengths(self.of) if rule.turns else None
        self._turned: dict[str, Length] = {}  # where lengths make bounds sharper
        self.by_name: dict[str, RoundedRange] = {}
        with uncollected():  # it took 0.4 of the time
            for step in program.instructions:
                self.by_name[step.name] = self._applied(step)
        self.results = tuple(rule.result(self.of(x)) for x in program.results)

    def of(self, x: Operand) -> RoundedRange:
        """The bounds of an operand."""
        if isinstance(x, Ref):
            return self.by_name[x.name]
        if x not in self._other:
            self._other[x] = self._leaf(x)
        return self._other[x]

    def proof(self, step: Instruction) -> Iterator[Length]:
        """The lengths of vectors on which the bounds of an instruction's result rest."""
        if self.lengths and step.name in self._turned:
            yield from self.lengths.proof(self._turned[step.name])

    def _leaf(self, x: Operand) -> RoundedRange:
        if isinstance(x, Input):
            size = Upward(self._sizes[x.argument][x.index])
            return RoundedRange(size, computed=size)
        if isinstance(x, Constant):
            return self._rule.constant(x)
        assert isinstance(x, NotANumber)
        return UNKNOWN

    def _applied(self, step: Instruction) -> RoundedRange:
        operands = [self._rule.operand(step, n, self.of(x)) for n, x in enumerate(step.operands)]
        before = combined(step, operands)
        turned = self.lengths.turned(step) if self.lengths else None
        if turned and (turned.size < before.size or turned.error < before.error):
            before = before._replace(size=min(before.size, turned.size),
                                     error=min(before.error, turned.error))
            self._turned[step.name] = turned
        if step.op is Op.NEG or step.op not in FOLLOWED:
            return before
        form = self._quadratic(step)
        if form:
            self._quadratics[Ref(step.name)] = form
            before = before._replace(size=min(before.size, _largest(form)))
        result = self._rule.rounded(step, before, operands)
        return result._replace(least=self._least(form)) if form else result

    def _quadratic(self, step: Instruction) -> Quadratic | None:
        if step.op is Op.MUL:
            a, b = step.operands
            if isinstance(a, Input) and isinstance(b, Input) and b in self._quaternion.get(a, ()):
                return Quadratic(frozenset((a, b)), a == b)
        if step.op in (Op.ADD, Op.SUB):
            return self._joined(step, *map(self._quadratics.get, step.operands))
        return None

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
