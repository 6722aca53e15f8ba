"""How far roundings can move a Program's results, for all arguments up to given sizes.

Of every value, with x exact and x̂ computed, |x| <= size and |x̂ - x| <= error.  A rounding of a
number z up to m errs by at most u times the largest power of two up to m.

    a ± b        size a + size b; error a + error b, and a rounding
    a b          size a size b; size a error b + size b error a + error a error b, and a rounding
    sin a, cos a min(1, size a), or 1; error a and the function's own
    s x ± c y    where s and c are sine and cosine of the same number: at most √(x² + y²), and by
                 errors of x and y at most √(error x² + error y²); so rotations enlarge nothing

Constants are the exact decimals.  Each of these bounds is rounded up.
"""

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import partial
from math import frexp, inf, ldexp, nextafter, sqrt
from typing import NamedTuple

from coscrew_codegen.formats import Precision
from coscrew_codegen.program import (
    Constant,
    Instruction,
    NotANumber,
    Op,
    Operand,
    Program,
    scales,
)
from coscrew_codegen.program.interpreter import Arithmetic, evaluate

_CIRCULAR = {Op.SIN, Op.COS}
FOLLOWED = frozenset({Op.ADD, Op.SUB, Op.MUL, Op.NEG, *_CIRCULAR})
"""The operations that are followed."""


class Rounded(NamedTuple):
    """|x| <= size, |x̂ - x| <= error; what it is a sine or cosine of, or a multiple of such."""

    size: float
    error: float = 0.0
    circular: tuple[Op, Operand] | None = None
    factor: "Rounded | None" = None  # of a multiple: the other factor
    rest: float = 0.0  # of a multiple: error less that of the other factor


def moved(program: Program, precision: Precision, sizes: Sequence[Sequence[float]],
          of_sine: float) -> tuple[Rounded, ...] | None:
    """Every component of the results, for all arguments whose components are up to these sizes;
    None if the program has operations that are not followed.  A sine or cosine errs by at most
    `of_sine` ulps of the exact one."""
    if not program.counts.keys() <= FOLLOWED or NotANumber() in program.results:
        return None
    follow = _Follow(precision, of_sine)
    given = [[Rounded(size) for size in parts] for parts in sizes]
    return tuple(evaluate(program, given, Arithmetic(follow.constant, follow.operation)))


def _up(x: float) -> float:
    return nextafter(x, inf)


def _sum(*terms: float) -> float:
    total = terms[0]
    for x in terms[1:]:
        total = _up(total + x) if x else total
    return total


def _product(a: float, b: float) -> float:
    return _up(a * b) if a and b else 0.0


def _length(a: float, b: float) -> float:
    return _up(sqrt(_sum(_product(a, a), _product(b, b))))


@dataclass
class _Follow:
    """The rules in a precision."""

    precision: Precision
    of_sine: float

    def __post_init__(self) -> None:
        self._u, self._eta = float(self.precision.u), float(self.precision.eta)
        self._most = float(self.precision.limit("max"))

    def constant(self, x: Constant) -> Rounded:
        value = self.precision.value(x)
        near = self.precision.rounded(value)
        error = abs(value - type(value)(float(near)))
        return Rounded(_up(float(abs(value))), _up(float(error)) if error else 0.0)

    def operation(self, step: Instruction, number: int) -> Callable[..., Rounded]:
        if step.op in _CIRCULAR:
            return partial(self._function, (step.op, step.operands[0]))
        if step.op is Op.MUL:
            return partial(self._multiple, scales(step))
        return self._total if step.op in (Op.ADD, Op.SUB) else lambda x: x

    def _rounding(self, size: float) -> float:
        """What rounding a number up to this size errs by."""
        if not size:
            return 0.0
        if size > self._most:
            return inf
        return max(ldexp(self._u, frexp(size)[1] - 1), self._eta)

    def _total(self, a: Rounded, b: Rounded) -> Rounded:
        size, error = _sum(a.size, b.size), _sum(a.error, b.error)
        if _turn(a, b):
            assert a.factor and b.factor
            size = min(size, _length(a.factor.size, b.factor.size))
            error = min(error, _sum(_length(a.factor.error, b.factor.error), a.rest, b.rest))
        return Rounded(size, _sum(error, self._rounding(_sum(size, error))))

    def _multiple(self, exact: bool, a: Rounded, b: Rounded) -> Rounded:
        size, both = _product(a.size, b.size), _product(a.error, b.error)
        error = _sum(_product(a.size, b.error), _product(a.error, b.size), both)
        last = self._eta if exact else self._rounding(_sum(size, error))
        found = Rounded(size, _sum(error, last))
        for x, y in ((a, b), (b, a)):
            if x.circular and not x.factor:
                rest = _sum(_product(x.error, y.size), both, last)
                return found._replace(circular=x.circular, factor=y, rest=rest)
        return found

    def _function(self, of: tuple[Op, Operand], x: Rounded) -> Rounded:
        """Its ulp is at most u, and 2 u s if the computed one is up to s."""
        size = min(1.0, x.size) if of[0] is Op.SIN else 1.0
        own = max(_product(self._u, min(1.0, 2 * _sum(size, x.error))), 2 * self._eta)
        return Rounded(size, _sum(x.error, _product(self.of_sine, own)), of)


def _turn(a: Rounded, b: Rounded) -> bool:
    """Whether these are multiples of a sine and a cosine of the same number."""
    return (a.circular is not None and b.circular is not None and None not in (a.factor, b.factor)
            and a.circular[0] is not b.circular[0] and a.circular[1] == b.circular[1])
