"""The operations of instructions with their arity and rounding: the only table of them.

A target knows how its language spells them, an Arithmetic how its numbers compute them.
"""

from collections.abc import Callable
from dataclasses import dataclass
from enum import Enum
from typing import Any, Protocol


class Rounding(Enum):
    """Ways in which a result is rounded, barring overflow and underflow."""

    EXACT = "exact"
    ONCE = "rounded once"  # by at most u of the result
    FUNCTION = "within an ulp"  # elementary functions of our own, whose errors are proved
    REST = "to twice the digits"  # the errors of these, with a small error relative to the function


class DerivativeFunctions(Protocol):
    """The functions that partial derivatives need, on some kind of numbers with + - * /."""

    def sin(self, x: Any, /) -> Any: ...
    def cos(self, x: Any, /) -> Any: ...
    def less(self, a: Any, b: Any, /) -> Any: ...
    def where(self, test: Any, a: Any, b: Any, /) -> Any: ...


Slopes = Callable[..., tuple[Any, ...]]
"""From Functions, the operands and the result to the partial derivative by each operand."""


@dataclass(frozen=True)
class Meaning:
    """Number of operands of an operation, how its result is rounded, and its partial derivatives:
    None if it has none (comparisons, tables; a choice has those of its options)."""

    arity: int
    rounding: Rounding
    slopes: Slopes | None
    commutes: bool = False


_EXACT, _ONCE, _FUNCTION, _REST = Rounding


class Op(Enum):
    """Operations of instructions on their operands."""

    ADD = "add"
    SUB = "sub"
    MUL = "mul"
    DIV = "div"
    NEG = "neg"
    ABS = "abs"
    SQRT = "sqrt"
    SIN = "sin"
    COS = "cos"
    ATAN2 = "atan2"
    EXP = "exp"
    TANH = "tanh"
    SIN_ERROR = "sine error"  # sin a - b, b what SIN returns
    COS_ERROR = "cosine error"  # cos a - b, b what COS returns
    ATAN2_ERROR = "atan2 error"  # atan2(a, b) - c, c what ATAN2 returns
    EXP_ERROR = "exp error"  # exp a - b, b what EXP returns
    TANH_ERROR = "tanh error"  # tanh a - b, b what TANH returns
    COPYSIGN = "copysign"  # abs(a) with the sign of b, even where b is zero
    POWER = "power of two"  # 2^(a - b) by its bits; b = 1.5 · 2^(digits - 1), a - b an integer
    TWO_OVER_PI = "digits of 2/π"  # the chunk (two_over_pi.py) b after a's first; c digits of a
    SCALE = "scale"  # a b, b a power of two: exact unless the result over- or underflows
    EXACT_ADD = "exact add"  # a + b where that is a number of the precision
    EXACT_SUB = "exact sub"  # a - b where that is a number of the precision
    PRODUCT_ERROR = "product error"  # a b - p exactly, p the rounded product
    PRODUCT_REST = "product rest"  # a b - h rounded once, where p - h is exact, p as above
    LESS = "less"  # a < b
    EQUAL = "equal"  # a == b
    SELECT = "select"  # a ? b : c
    INDEX = "index"  # the integer part of a, within 0 … b - 1; 0 if a is NaN
    GATHER = "gather"  # a's number in the row b of its table; b is brought to an index as above
    HIGH_PRODUCT = "high product"  # integers of 32 bits: a b / 2^32 to nearest, ties upward
    WIDE_PRODUCT = "wide product"  # a b in 64 bits, times 2^c, rounded down
    ROUNDED_SHIFT = "rounded shift"  # a / 2^b in 32 bits to nearest, ties upward; a is of any width

    __hash__ = object.__hash__  # each of them exists once; an Enum hashes its name, in Python

    @property
    def meaning(self) -> Meaning:
        """Its entry in the table of meanings."""
        return _MEANINGS[self]

    @property
    def rounds(self) -> bool:
        """True if the result may differ from the exact one."""
        return self.meaning.rounding is not Rounding.EXACT


def _sum(*signs: int) -> Slopes:
    return lambda f, *x: signs


def _product(*more: int) -> Slopes:
    """Returns the partial derivatives of a b and further terms."""
    return lambda f, a, b, *x: (b, a, *more)


def _arctangent(f: DerivativeFunctions, y: Any, x: Any, angle: Any, *rest: Any) -> tuple[Any, ...]:
    square = x * x + y * y
    return x / square, -(y / square), *(-1 for _ in rest)


_MEANINGS = {
    Op.ADD: Meaning(2, _ONCE, _sum(1, 1), commutes=True),
    Op.SUB: Meaning(2, _ONCE, _sum(1, -1)),
    Op.MUL: Meaning(2, _ONCE, _product(), commutes=True),
    Op.DIV: Meaning(2, _ONCE, lambda f, a, b, y: (1 / b, -(y / b))),
    Op.NEG: Meaning(1, _EXACT, _sum(-1)),
    Op.ABS: Meaning(1, _EXACT, lambda f, x, y: (f.where(f.less(x, 0), -1, 1),)),
    Op.SQRT: Meaning(1, _ONCE, lambda f, x, y: (1 / (2 * y),)),
    Op.SIN: Meaning(1, _FUNCTION, lambda f, x, y: (f.cos(x),)),
    Op.COS: Meaning(1, _FUNCTION, lambda f, x, y: (-f.sin(x),)),
    Op.ATAN2: Meaning(2, _FUNCTION, _arctangent),
    Op.EXP: Meaning(1, _FUNCTION, lambda f, x, y: (y,)),
    Op.TANH: Meaning(1, _FUNCTION, lambda f, x, y: (1 - y * y,)),
    Op.SIN_ERROR: Meaning(2, _REST, lambda f, x, s, e: (f.cos(x), -1)),
    Op.COS_ERROR: Meaning(2, _REST, lambda f, x, c, e: (-f.sin(x), -1)),
    Op.ATAN2_ERROR: Meaning(3, _REST, _arctangent),
    Op.EXP_ERROR: Meaning(2, _REST, lambda f, x, y, e: (y + e, -1)),
    Op.TANH_ERROR: Meaning(2, _REST, lambda f, x, y, e: (1 - (y + e) * (y + e), -1)),
    Op.COPYSIGN: Meaning(2, _EXACT, None),
    Op.POWER: Meaning(2, _EXACT, None),
    Op.TWO_OVER_PI: Meaning(3, _EXACT, None),
    Op.SCALE: Meaning(2, _EXACT, _product()),
    Op.EXACT_ADD: Meaning(2, _EXACT, _sum(1, 1)),
    Op.EXACT_SUB: Meaning(2, _EXACT, _sum(1, -1)),
    Op.PRODUCT_ERROR: Meaning(3, _EXACT, _product(-1)),
    Op.PRODUCT_REST: Meaning(4, _ONCE, _product(0, -1)),
    Op.LESS: Meaning(2, _EXACT, None),
    Op.EQUAL: Meaning(2, _EXACT, None, commutes=True),
    Op.SELECT: Meaning(3, _EXACT, None),
    Op.INDEX: Meaning(2, _EXACT, None),
    Op.GATHER: Meaning(2, _EXACT, None),
    Op.HIGH_PRODUCT: Meaning(2, _ONCE, None, commutes=True),
    Op.WIDE_PRODUCT: Meaning(3, _ONCE, None),
    Op.ROUNDED_SHIFT: Meaning(2, _ONCE, None)}

OF_TABLES = frozenset({Op.INDEX, Op.GATHER})
"""The operations that read tables, and find the index at which they do."""
COMPARISONS = frozenset({Op.LESS, Op.EQUAL})
"""The operations whose results are truth values, for SELECT."""
ERROR_OF = {Op.SIN: Op.SIN_ERROR, Op.COS: Op.COS_ERROR, Op.ATAN2: Op.ATAN2_ERROR,
            Op.EXP: Op.EXP_ERROR, Op.TANH: Op.TANH_ERROR}
"""From an elementary function to the operation that computes its error, from its operands and
result."""
OF_INTEGERS = frozenset({Op.HIGH_PRODUCT, Op.WIDE_PRODUCT, Op.ROUNDED_SHIFT})
"""The operations that only integers have."""
POLYNOMIAL = frozenset({Op.ADD, Op.SUB, Op.MUL, Op.NEG})
"""The operations of polynomials."""
