"""Numbers whose arithmetic is recorded, for the equations of scenes; and vectors of three."""

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from fractions import Fraction
from typing import TYPE_CHECKING

from coscrew_codegen.program import Constant, Op, Operand
from coscrew_codegen.program.tables import TableColumn

if TYPE_CHECKING:
    from coscrew_codegen.algebra.recording.recorder import Recorder

Vector = tuple["Number", ...]  # of three
_ADD, _SUB, _MUL, _DIV, _NEG = Op.ADD, Op.SUB, Op.MUL, Op.DIV, Op.NEG
"""Names of this module are looked up five times as fast as members of an Enum."""


@dataclass(slots=True, unsafe_hash=True)  # a frozen one takes twice as long to make
class Number:
    """An operand and its recorder.  Arithmetic on it is recorded."""

    recorder: "Recorder"
    operand: Operand

    def _with(self, op: Op, *others: "Like") -> "Number":
        operands = tuple([(x if isinstance(x, Number) else self.like(x)).operand for x in others])
        return Number(self.recorder, self.recorder.issue(op, operands))

    def like(self, x: "Like") -> "Number":
        """x as a Number of the same recording."""
        return x if isinstance(x, Number) else self.recorder.number(x)

    @property
    def constant(self) -> Fraction | None:
        """Its value if it is a constant that is the same in both precisions, else None."""
        x = self.operand
        return x.double if isinstance(x, Constant) and x.double == x.single else None

    @property
    def is_zero(self) -> bool:
        """True if it is the constant zero."""
        return self.constant == 0

    def __add__(self, other: "Like") -> "Number": return self._with(_ADD, self, other)
    def __radd__(self, other: "Like") -> "Number": return self._with(_ADD, other, self)
    def __sub__(self, other: "Like") -> "Number": return self._with(_SUB, self, other)
    def __rsub__(self, other: "Like") -> "Number": return self._with(_SUB, other, self)
    def __mul__(self, other: "Like") -> "Number": return self._with(_MUL, self, other)
    def __rmul__(self, other: "Like") -> "Number": return self._with(_MUL, other, self)
    def __truediv__(self, other: "Like") -> "Number": return self._with(_DIV, self, other)
    def __rtruediv__(self, other: "Like") -> "Number": return self._with(_DIV, other, self)
    def __neg__(self) -> "Number": return self._with(_NEG, self)


Like = Number | Fraction | int


def _function(op: Op) -> Callable[[Number], Number]:
    def apply(x: Number) -> Number:
        return x._with(op, x)
    apply.__doc__ = f"{op.value} x."
    return apply


sin, cos, sqrt, exp, tanh, absolute = map(
    _function, (Op.SIN, Op.COS, Op.SQRT, Op.EXP, Op.TANH, Op.ABS))


def less(a: Number, b: "Like") -> Number:
    """a < b, for `where`."""
    return a._with(Op.LESS, a, b)


def equal(a: Number, b: "Like") -> Number:
    """a == b, for `where`."""
    return a._with(Op.EQUAL, a, b)


def where(test: Number, a: "Like", b: "Like") -> Number:
    """a if the test holds, else b."""
    return test._with(Op.SELECT, test, a, b)


def index(x: Number, count: int) -> Number:
    """The integer part of x, within 0 … count - 1."""
    return x._with(Op.INDEX, x, count)


def gather(column: TableColumn, at: Number) -> Number:
    """The column's number in the row `at`."""
    return Number(at.recorder, at.recorder.issue(Op.GATHER, (column, at.operand)))


def maximum(a: Number, b: "Like") -> Number:
    """max(a, b)."""
    return where(less(a, b), b, a)


def minimum(a: Number, b: "Like") -> Number:
    """min(a, b)."""
    return where(less(a.like(b), a), b, a)


# Vectors: the library's operations on three Numbers.


def cross(a: Vector, b: Vector) -> Vector:
    """a × b."""
    return a[0].recorder.call("cross_vv", a, b)


def dot(a: Vector, b: Vector) -> Number:
    """a·b."""
    return a[0].recorder.call("dot_vv", a, b)[0]


def add(a: Sequence[Number], b: Sequence[Number]) -> tuple[Number, ...]:
    """a + b."""
    return tuple(x + y for x, y in zip(a, b, strict=True))


def subtract(a: Sequence[Number], b: Sequence[Number]) -> tuple[Number, ...]:
    """a - b."""
    return tuple(x - y for x, y in zip(a, b, strict=True))


def scaled(k: Number, a: Sequence[Number]) -> tuple[Number, ...]:
    """k a."""
    return tuple(k * x for x in a)


def negative(a: Sequence[Number]) -> tuple[Number, ...]:
    """-a."""
    return tuple(-x for x in a)


def displacement(R: Sequence[Number], t: Sequence[Number]) -> tuple[Number, ...]:
    """D = [R | t], row by row, as an argument of the library's operations."""
    return (*R[:3], t[0], *R[3:6], t[1], *R[6:], t[2])


def rotation(D: Sequence[Number]) -> tuple[Number, ...]:
    """R of D = [R | t]."""
    return (*D[:3], *D[4:7], *D[8:11])


def translation(D: Sequence[Number]) -> Vector:
    """t of D = [R | t]."""
    return D[3], D[7], D[11]


def linear(s: Sequence[Number]) -> Vector:
    """v of a screw (v; ω), f of a coscrew (f; τ)."""
    return tuple(s[:3])


def angular(s: Sequence[Number]) -> Vector:
    """ω of a screw (v; ω), τ of a coscrew (f; τ)."""
    return tuple(s[3:])


def rotated(R: Sequence[Number], a: Vector) -> Vector:
    """R a."""
    return a[0].recorder.call("product_drv", R, a)


def rotated_back(R: Sequence[Number], a: Vector) -> Vector:
    """R^T a."""
    return a[0].recorder.call("product_drinvv", R, a)
