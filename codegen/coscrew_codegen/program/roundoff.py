"""Shared parts of rounding-error analyses: floats that round up, and the bounds of sums, products,
quotients, sines and cosines of numbers that have errors.

For every value, with x exact and x̂ computed, |x| <= size, |x̂ - x| <= error.  How a format rounds
adds to this, by its own rule:

    a ± b        size a + size b; error a + error b
    a b          size a size b; size a error b + size b error a + error a error b
    a / b        for |b| >= least: size a / least; (error a + size error b) / (least - error b)
    sin a, cos a min(1, size a), or 1; error a
    s x ± c y    where s and c are sine and cosine of the same number: at most √(x² + y²), and by
                 errors of x and y at most √(error x² + error y²); so rotations enlarge nothing

Constants are the exact decimals.  Each of these bounds is rounded up."""

from collections.abc import Callable, Mapping, Sequence
from math import frexp, inf, nextafter, sqrt
from typing import NamedTuple, Protocol, TypeVar

from coscrew_codegen.program import Instruction, Op, Operand

_HALF = 0.5  # frexp's mantissa of powers of two
CIRCULAR = frozenset({Op.SIN, Op.COS})


class Upward(float):
    """A nonnegative bound whose sums, products and quotients are rounded up unless they are known
    to be exact: sums that lose no digit, products with 0 or a power of two."""

    def __add__(self, other: float) -> "Upward":
        total = float(self) + other
        part = total - self
        lost = (self - (total - part)) + (other - part)  # exact (Knuth); NaN if infinite
        return Upward(total if lost <= 0 else nextafter(total, inf))

    def __mul__(self, other: float) -> "Upward":
        if not self or not other:
            return Upward(0)
        product = float(self) * other
        if product > _NORMAL and (frexp(self)[0] == _HALF or frexp(other)[0] == _HALF):
            return Upward(product)
        return Upward(nextafter(product, inf))

    def __truediv__(self, other: float) -> "Upward":
        """The quotient; infinite if the divisor is not positive."""
        if other <= 0:
            return Upward(inf)
        return Upward(nextafter(float(self) / other, inf) if self else 0)


_NORMAL = 2.0**-1021
NONE, UNBOUNDED = Upward(0), Upward(inf)


class RoundedRange(NamedTuple):
    """Bounds of a value, and what further rules need to know of it."""

    size: Upward
    error: Upward = NONE
    computed: Upward = UNBOUNDED  # bound of the computed value; of hi of a pair hi + lo
    least: Upward = NONE  # bound of its size from below
    low: Upward = NONE  # of a pair hi + lo: bound of lo
    circular: tuple[Op, Operand] | None = None  # of a sine or cosine, or a multiple: the argument
    factor: "RoundedRange | None" = None  # of a multiple: the other factor
    rest: Upward = NONE  # of a multiple: error less that of the other factor
    own: Upward = NONE  # error of its own rounding or function

    def rounded(self, own: Upward, computed: Upward = UNBOUNDED, low: Upward = NONE
                ) -> "RoundedRange":
        """The bounds after a rounding with this error."""
        return self._replace(error=self.error + own, rest=self.rest + own, computed=computed,
                             low=low, own=own)


UNKNOWN = RoundedRange(UNBOUNDED, UNBOUNDED)


def combined(step: Instruction, operands: Sequence[RoundedRange]) -> RoundedRange:
    """The bounds of an instruction's result before it is rounded, from those of its operands;
    infinite for operations without a rule."""
    rule = _RULES.get(step.op)
    return rule(step, *operands) if rule else UNKNOWN


def total(a: RoundedRange, b: RoundedRange) -> RoundedRange:
    """The bounds of a ± b."""
    size, error = a.size + b.size, a.error + b.error
    if a.circular and b.circular and a.factor and b.factor and \
            a.circular[0] is not b.circular[0] and a.circular[1] == b.circular[1]:
        size = min(size, length(a.factor.size, b.factor.size))
        error = min(error, length(a.factor.error, b.factor.error) + a.rest + b.rest)
    return RoundedRange(size, error, a.computed + b.computed)


def product(a: RoundedRange, b: RoundedRange) -> RoundedRange:
    """The bounds of a b."""
    result = RoundedRange(a.size * b.size, product_error(a.size, a.error, b.size, b.error),
                          a.computed * b.computed)
    for x, y in ((a, b), (b, a)):
        if x.circular and not x.factor:
            rest = x.error * y.size + a.error * b.error
            return result._replace(circular=x.circular, factor=y, rest=rest)
    return result


def _quotient(a: RoundedRange, b: RoundedRange) -> RoundedRange:
    size, left = a.size / b.least, down(b.least, b.error)
    return RoundedRange(size, (a.error + size * b.error) / left, a.computed / left)


def sine_or_cosine(step: Instruction, x: RoundedRange) -> RoundedRange:
    """The bounds of the sine or the cosine of x̂."""
    size = min(Upward(1), x.size) if step.op is Op.SIN else Upward(1)
    return RoundedRange(size, x.error, circular=(step.op, step.operands[0]))


_RULES: Mapping[Op, Callable[..., RoundedRange]] = {
    Op.ADD: lambda _, a, b: total(a, b), Op.SUB: lambda _, a, b: total(a, b),
    Op.MUL: lambda _, a, b: product(a, b), Op.DIV: lambda _, a, b: _quotient(a, b),
    Op.NEG: lambda _, a: a._replace(own=NONE, least=NONE),
    Op.SIN: sine_or_cosine, Op.COS: sine_or_cosine}
FOLLOWED = frozenset(_RULES)
"""Operations that have a rule."""


def down(a: float, *others: float) -> Upward:
    """Bounds the difference of a and these numbers from below; 0 if that is negative."""
    for b in others:
        a = max(0.0, nextafter(a - b, 0) if b else a)
    return Upward(a)


def length(a: Upward, b: Upward) -> Upward:
    """Bounds √(a² + b²)."""
    if not a or not b:
        return max(a, b)
    return Upward(nextafter(sqrt(a * a + b * b), inf))


class Ring(Protocol):
    """A kind of numbers with sums and products."""

    def __add__(self: "N", other: "N", /) -> "N": ...
    def __mul__(self: "N", other: "N", /) -> "N": ...


N = TypeVar("N", bound=Ring)


def product_error(a: N, error_a: N, b: N, error_b: N) -> N:
    """Bounds the error of a product, given the sizes and the errors of its factors."""
    return a * error_b + error_a * b + error_a * error_b
