"""Bounds of the rounding errors of a Program's results, for all arguments up to given sizes.

For every value, with x exact and x̂ computed, |x| <= size and |x̂ - x| <= error.  A rounding of a
number z up to m errs by at most u times the largest power of two up to m.

    a ± b        size a + size b; error a + error b, and a rounding
    a b          size a size b; size a error b + size b error a + error a error b, and a rounding
    sin a, cos a min(1, size a), or 1; error a and the function's own
    s x ± c y    where s and c are sine and cosine of the same number: at most √(x² + y²), and by
                 errors of x and y at most √(error x² + error y²); so rotations enlarge nothing

Constants are the exact decimals.  Each of these bounds is rounded up."""

from collections.abc import Callable, Sequence
from fractions import Fraction
from functools import partial
from math import frexp, inf, ldexp, nextafter, sqrt
from typing import NamedTuple

from coscrew_codegen.program import Constant, Instruction, NotANumber, Op, Operand, Program, scales
from coscrew_codegen.program.interpreter import Arithmetic, evaluate
from coscrew_codegen.program.roundoff import Upward, product_error
from coscrew_codegen.program.values.formats import Precision

_CIRCULAR = {Op.SIN, Op.COS}
FOLLOWED = frozenset({Op.ADD, Op.SUB, Op.MUL, Op.NEG, *_CIRCULAR})
"""Operations that the analysis knows."""


class RoundedRange(NamedTuple):
    """Bounds |x| <= size, |x̂ - x| <= error; and the argument, if the value is a sine or cosine or
    a multiple of one."""

    size: Upward
    error: Upward = Upward(0)
    circular: tuple[Op, Operand] | None = None
    factor: "RoundedRange | None" = None  # of a multiple: the other factor
    rest: Upward = Upward(0)  # of a multiple: error less that of the other factor


def moved(program: Program, precision: Precision, sizes: Sequence[Sequence[float]],
          of_sine: float) -> tuple[RoundedRange, ...] | None:
    """Every component of the results, for all arguments whose components are up to these sizes;
    None if the program has operations that the analysis does not know.  A sine or cosine errs by at
    most `of_sine` ulps of the exact one."""
    if not program.counts.keys() <= FOLLOWED or NotANumber() in program.results:
        return None
    follow = _Follow(precision, of_sine)
    given = [[RoundedRange(Upward(size)) for size in parts] for parts in sizes]
    return tuple(evaluate(program, given, Arithmetic(follow.constant, follow.operation)))


def _length(a: Upward, b: Upward) -> Upward:
    return Upward(nextafter(sqrt(a * a + b * b), inf))


class _Follow:
    """The rules in a precision."""

    def __init__(self, precision: Precision, of_sine: float) -> None:
        self._precision, self._of_sine = precision, Upward(of_sine)
        self._u, self._eta = Upward(precision.u), Upward(precision.eta)
        self._most = float(precision.limit("max"))

    def constant(self, x: Constant) -> RoundedRange:
        value = self._precision.value(x)
        error = abs(value - Fraction(float(self._precision.rounded(value))))
        return RoundedRange(_above(abs(value)), _above(error) if error else Upward(0))

    def operation(self, step: Instruction, number: int) -> Callable[..., RoundedRange]:
        if step.op in _CIRCULAR:
            return partial(self._function, (step.op, step.operands[0]))
        if step.op is Op.MUL:
            return partial(self._multiple, scales(step))
        return self._total if step.op in (Op.ADD, Op.SUB) else lambda x: x

    def _rounding(self, size: float) -> Upward:
        """Bound of the rounding error of a number up to this size."""
        if not size or size > self._most:
            return Upward(inf if size else 0)
        return max(Upward(ldexp(self._u, frexp(size)[1] - 1)), self._eta)

    def _total(self, a: RoundedRange, b: RoundedRange) -> RoundedRange:
        size, error = a.size + b.size, a.error + b.error
        if _turn(a, b):
            assert a.factor and b.factor
            size = min(size, _length(a.factor.size, b.factor.size))
            error = min(error, _length(a.factor.error, b.factor.error) + a.rest + b.rest)
        return RoundedRange(size, error + self._rounding(size + error))

    def _multiple(self, exact: bool, a: RoundedRange, b: RoundedRange) -> RoundedRange:
        size, error = a.size * b.size, product_error(a.size, a.error, b.size, b.error)
        last = self._eta if exact else self._rounding(size + error)
        result = RoundedRange(size, error + last)
        for x, y in ((a, b), (b, a)):
            if x.circular and not x.factor:
                rest = x.error * y.size + a.error * b.error + last
                return result._replace(circular=x.circular, factor=y, rest=rest)
        return result

    def _function(self, of: tuple[Op, Operand], x: RoundedRange) -> RoundedRange:
        """The range of a sine or cosine: of size s, its ulp is at most 2 u s, and at most u."""
        size = min(Upward(1), x.size) if of[0] is Op.SIN else Upward(1)
        own = max(self._u * min(1.0, 2 * (size + x.error)), Upward(2 * self._eta))
        return RoundedRange(size, x.error + self._of_sine * own, of)


def _above(x: Fraction) -> Upward:
    return Upward(nextafter(float(x), inf))


def _turn(a: RoundedRange, b: RoundedRange) -> bool:
    """Returns whether these are multiples of a sine and a cosine of the same number."""
    return (a.circular is not None and b.circular is not None and None not in (a.factor, b.factor)
            and a.circular[0] is not b.circular[0] and a.circular[1] == b.circular[1])
