"""What an operation is: one entry of the table everything else iterates over."""

from collections.abc import Callable
from dataclasses import dataclass
from typing import TypeAlias

import sympy as sp

from coscrew_codegen.quantity import Argument

Value: TypeAlias = sp.Matrix | sp.Expr

# Below it every component counts as zero when a norm chooses between linear and angular part.
NORM_THRESHOLD = sp.Symbol("norm_threshold", positive=True)

# Powers of two bring vectors' largest component between MODEST and LARGE: squares do not overflow,
# and what is divided by the vector's length has all its digits wherever the quotient has.  Only
# where all is below TINY times 2^-498 (single 2^-57) it stays smaller; then components are
# multiples of one number that is not.
TINY, MODEST, LARGE = sp.symbols("tiny modest large", positive=True)
ENLARGING, RAISING, REDUCING = sp.symbols("enlarging raising reducing", positive=True)

# Of numbers s and x with |x| <= s, (x + GRID s) - GRID s is x rounded so that squares of such
# numbers, and sums of three, are exact.
GRID = sp.Symbol("grid", positive=True)

# 1 - 50 u: A whose diagonal entries, times this, leave it positive definite is regular to rounding.
REGULAR = sp.Symbol("regular", positive=True)

# 16 u: vectors of length 1 that leave less than this beside others depend on them to rounding.
DEPENDENT = sp.Symbol("dependent", positive=True)

# 8 u, and the part of the largest entry's third power that no underflow spoils: what a determinant
# is held to.
INDISTINCT, SPOILED = sp.symbols("indistinct spoiled", positive=True)

# Steps between powers of two that bring a matrix' largest entry between 1 and the first, so that
# products of three entries do not overflow, and underflow only where they do not matter.
STEPS = sp.symbols("step step2 step3", positive=True)

PER_PRECISION: dict[sp.Symbol, tuple[sp.Rational, sp.Rational]] = {
    NORM_THRESHOLD: (sp.Rational(1, 10**9), sp.Rational(1, 10**6)),
    TINY: (sp.Rational(1, 2**494), sp.Rational(1, 2**46)),
    MODEST: (sp.Integer(2**8), sp.Integer(2**8)),
    LARGE: (sp.Integer(2**511), sp.Integer(2**62)),
    ENLARGING: (sp.Integer(2**502), sp.Integer(2**54)),
    RAISING: (sp.Integer(2**1000), sp.Integer(2**108)),
    REDUCING: (sp.Rational(1, 2**513), sp.Rational(1, 2**65)),
    REGULAR: (1 - sp.Rational(50, 2**53), 1 - sp.Rational(50, 2**24)),
    DEPENDENT: (sp.Rational(16, 2**53), sp.Rational(16, 2**24)),
    INDISTINCT: (sp.Rational(8, 2**53), sp.Rational(8, 2**24)),
    SPOILED: (sp.Rational(1, 2**760), sp.Rational(1, 2**96)),
    **{step: (sp.Integer(2**(300 * n)), sp.Integer(2**(40 * n)))
       for n, step in enumerate(STEPS, 1)},
    GRID: (sp.Integer(2**28), sp.Integer(2**13)),
}
"""The constants that differ between double and single precision."""


class scaled(sp.Function):
    """scaled(x, s) = x s, where s is a power of two: a product that rounds nothing unless the
    result over- or underflows."""

    nargs = 2


@dataclass(frozen=True)
class Normwise:
    """Each component of `part` of the result, or of the output of that name, is off by at most
    (k + θ / `per_angle`) u of the largest of them, or of the inputs' parts `beside` them, where
    that is larger; θ the angle of the input turned by.  Found by search, not proved."""

    part: str
    k: int
    beside: tuple[str, ...] = ()  # "s.lin": argument and part
    per_angle: int = 0  # 0: whatever the angle

    def k_at(self, angle: float) -> float:
        """k, with what the angle adds."""
        return self.k + angle / self.per_angle if self.per_angle else self.k

    @property
    def in_words(self) -> str:
        """'t: 8 u', '(5 + θ/500) u'."""
        k = f"({self.k} + θ/{self.per_angle})" if self.per_angle else self.k
        return f"{self.part}: {k} u"


@dataclass(frozen=True)
class Operation:
    """A pure function from inputs to outputs.

    `formula` says what the outputs are, as plain mathematics.  `derivation`, where given, says the
    same through intermediate results bound by its first argument, `let(name, value)`, so that a
    product of operators costs a product of sparse operators.  Both take the inputs' values and
    return one value per output (a tuple when there are several).

    An output that carries an input's name is updated in place in C.  `order` is the order of C
    parameters where it is not inputs, then outputs.
    """

    family: str
    name: str
    statement: str
    inputs: tuple[Argument, ...]
    outputs: tuple[Argument, ...]
    formula: Callable[..., Value | tuple[Value, ...]]
    derivation: Callable[..., Value | tuple[Value, ...]] | None = None
    normwise: tuple[Normwise, ...] = ()
    order: tuple[str, ...] = ()
    by_value: bool = False  # in C, arguments and result are passed by value
    remark: str = ""  # what unfused arithmetic makes true besides
    rounding: str = ""  # what else bounds the errors, in words

    def __post_init__(self) -> None:
        for a in self.inputs:
            if not a.says_its_domain:
                raise ValueError(
                    f"operation {self.name}: {a.name}, a {a.quantity.name}, says no domain; give "
                    "Argument one of quantity.py's, ANY if any numbers will do")

    @property
    def signature(self) -> str:
        """The gufunc signature: '(3,4),(6)->(6)'."""
        inputs = ",".join(a.quantity.core for a in self.inputs)
        return f"{inputs}->{','.join(a.quantity.core for a in self.outputs)}"

    @property
    def tested_bounds(self) -> str:
        """`normwise` in words, with what inputs it is for, and what else there is, if anything."""
        if not self.normwise:
            return self.rounding
        parts = ", ".join(bound.in_words for bound in self.normwise)
        beside = [name for bound in self.normwise for name in bound.beside]
        also = f", or of {' or '.join(beside)} if that is larger" if beside else ""
        where = [a.domain_in_words for a in self.inputs if a.domain.restricts]
        given = f" for {' and '.join(where)}" if where else ""
        besides = f"  {self.rounding}" if self.rounding else ""
        return (f"Error <= {parts} of its largest component{also}{given}; searched, not proved."
                f"{besides}")

    def truth(self) -> tuple[sp.Expr, ...]:
        """`formula` on the inputs' symbols: every component of every output, row by row."""
        return components(self.formula(*(a.value for a in self.inputs)))


def components(values: Value | tuple[Value, ...]) -> tuple[sp.Expr, ...]:
    """All components of one or several values, row by row."""
    result: list[sp.Expr] = []
    for value in values if isinstance(values, tuple) else (values,):
        result.extend(value if isinstance(value, sp.MatrixBase) else (sp.sympify(value),))
    return tuple(result)
