"""The operations of instructions with their arity and rounding: the only table of them.

A target knows how its language spells them, an Arithmetic how its numbers compute them.
"""

from dataclasses import dataclass
from enum import Enum


class Rounding(Enum):
    """How a result is rounded, barring overflow and underflow."""

    EXACT = "exact"
    ONCE = "rounded once"  # by at most u of the result
    LIBRARY = "as the language's library rounds it"


@dataclass(frozen=True)
class Meaning:
    """How many operands an operation has, and how its result is rounded."""

    arity: int
    rounding: Rounding
    commutes: bool = False


_EXACT, _ONCE, _LIBRARY = Rounding


class Op(Enum):
    """What an instruction does with its operands."""

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
    SCALE = "scale"  # a b, b a power of two: exact unless the result over- or underflows
    FMA = "fma"  # a b + c, rounded once
    FMS = "fms"  # a b - c, rounded once
    FNMA = "fnma"  # c - a b, rounded once
    EXACT_ADD = "exact add"  # a + b where that is a number of the precision
    EXACT_SUB = "exact sub"  # a - b where that is a number of the precision
    PRODUCT_ERROR = "product error"  # a b - p exactly, p the rounded product
    PRODUCT_REST = "product rest"  # a b - h rounded once, where p - h is exact, p as above
    LESS = "less"  # a < b
    EQUAL = "equal"  # a == b
    SELECT = "select"  # a ? b : c

    @property
    def meaning(self) -> Meaning:
        """Its entry in the table of meanings."""
        return _MEANINGS[self]

    @property
    def rounds(self) -> bool:
        """Whether the result may differ from the exact one."""
        return self.meaning.rounding is not Rounding.EXACT


_MEANINGS = {
    Op.ADD: Meaning(2, _ONCE, commutes=True), Op.SUB: Meaning(2, _ONCE),
    Op.MUL: Meaning(2, _ONCE, commutes=True), Op.DIV: Meaning(2, _ONCE),
    Op.NEG: Meaning(1, _EXACT), Op.ABS: Meaning(1, _EXACT), Op.SQRT: Meaning(1, _ONCE),
    Op.SIN: Meaning(1, _LIBRARY), Op.COS: Meaning(1, _LIBRARY), Op.ATAN2: Meaning(2, _LIBRARY),
    Op.EXP: Meaning(1, _LIBRARY), Op.TANH: Meaning(1, _LIBRARY), Op.SCALE: Meaning(2, _EXACT),
    Op.FMA: Meaning(3, _ONCE), Op.FMS: Meaning(3, _ONCE), Op.FNMA: Meaning(3, _ONCE),
    Op.EXACT_ADD: Meaning(2, _EXACT), Op.EXACT_SUB: Meaning(2, _EXACT),
    Op.PRODUCT_ERROR: Meaning(3, _EXACT), Op.PRODUCT_REST: Meaning(4, _ONCE),
    Op.LESS: Meaning(2, _EXACT), Op.EQUAL: Meaning(2, _EXACT, commutes=True),
    Op.SELECT: Meaning(3, _EXACT)}

COMPARISONS = frozenset({Op.LESS, Op.EQUAL})
"""The operations whose results are truth values, for SELECT."""
POLYNOMIAL = frozenset({Op.ADD, Op.SUB, Op.MUL, Op.NEG})
"""The operations of polynomials."""
