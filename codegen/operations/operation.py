"""What an operation is: one entry of the table everything else iterates over."""

from collections.abc import Callable
from dataclasses import dataclass

import sympy as sp

from coscrew_codegen.quantity import Argument

Value = sp.Matrix | sp.Expr

# Below it every component counts as zero when a norm chooses between linear and angular part.
NORM_THRESHOLD = sp.Symbol("norm_threshold", positive=True)

# Between these, squares neither over- nor underflow; beyond them powers of two bring numbers back.
SMALL, LARGE, ENLARGING, REDUCING = sp.symbols("small large enlarging reducing", positive=True)

# x + GRID - GRID is x rounded so that squares of such numbers below 8, and their sums, are exact.
GRID = sp.Symbol("grid", positive=True)

# 1 - 50 u: A whose diagonal entries, times this, leave it positive definite is regular to rounding.
REGULAR = sp.Symbol("regular", positive=True)

# 16 u: vectors of length 1 that leave less than this beside others depend on them to rounding.
DEPENDENT = sp.Symbol("dependent", positive=True)

# 8 u, and the least size of terms that no underflow has spoiled: what a determinant is held to.
INDISTINCT, SPOILED = sp.symbols("indistinct spoiled", positive=True)

PER_PRECISION: dict[sp.Symbol, tuple[sp.Rational, sp.Rational]] = {
    NORM_THRESHOLD: (sp.Rational(1, 10**9), sp.Rational(1, 10**6)),
    SMALL: (sp.Rational(1, 2**450), sp.Rational(1, 2**50)),
    LARGE: (sp.Integer(2**511), sp.Integer(2**62)),
    ENLARGING: (sp.Integer(2**600), sp.Integer(2**100)),
    REDUCING: (sp.Rational(1, 2**513), sp.Rational(1, 2**65)),
    REGULAR: (1 - sp.Rational(50, 2**53), 1 - sp.Rational(50, 2**24)),
    DEPENDENT: (sp.Rational(16, 2**53), sp.Rational(16, 2**24)),
    INDISTINCT: (sp.Rational(8, 2**53), sp.Rational(8, 2**24)),
    SPOILED: (sp.Rational(1, 2**960), sp.Rational(1, 2**96)),
    GRID: (sp.Integer(3 * 2**29), sp.Integer(3 * 2**14)),
}
"""The constants that differ between double and single precision."""


class scaled(sp.Function):
    """scaled(x, s) = x s, where s is a power of two: a product that rounds nothing unless the
    result over- or underflows."""

    nargs = 2


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

    name: str
    family: str
    statement: str
    inputs: tuple[Argument, ...]
    outputs: tuple[Argument, ...]
    formula: Callable[..., Value | tuple[Value, ...]]
    derivation: Callable[..., Value | tuple[Value, ...]] | None = None
    order: tuple[str, ...] = ()
    by_value: bool = False  # in C, arguments and result are passed by value
    remark: str = ""  # what unfused arithmetic makes true besides
    normwise: tuple[tuple[str, int], ...] = ()  # (part or output, k): the error of each component
    # is at most k u of that part's largest component, in it or an input of its kind; found by
    # search, not proved
    rounding: str = ""  # what else bounds the errors, in words

    @property
    def signature(self) -> str:
        """The gufunc signature: '(3,4),(6)->(6)'."""
        inputs = ",".join(a.quantity.core for a in self.inputs)
        return f"{inputs}->{','.join(a.quantity.core for a in self.outputs)}"

    @property
    def tested_bounds(self) -> str:
        """`normwise` in words, or what else there is; empty where there is nothing."""
        parts = ", ".join(f"{name}: {k} u" for name, k in self.normwise)
        return f"Error <= {parts} of its largest component; searched, not proved." if parts else \
            self.rounding

    def truth(self) -> tuple[sp.Expr, ...]:
        """`formula` on the inputs' symbols: every component of every output, row by row."""
        return components(self.formula(*(a.value for a in self.inputs)))


def components(values: Value | tuple[Value, ...]) -> tuple[sp.Expr, ...]:
    """All components of one or several values, row by row."""
    result: list[sp.Expr] = []
    for value in values if isinstance(values, tuple) else (values,):
        result.extend(value if isinstance(value, sp.MatrixBase) else (sp.sympify(value),))
    return tuple(result)
