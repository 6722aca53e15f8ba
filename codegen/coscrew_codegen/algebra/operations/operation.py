"""Operations: entries of the table from which everything is generated."""

from collections.abc import Callable
from dataclasses import dataclass
from typing import TypeAlias

import sympy as sp

from coscrew_codegen.program.values.quantity import Argument

Value: TypeAlias = sp.Matrix | sp.Expr

# A part whose components are all below it counts as zero when a norm chooses between the parts.
NORM_THRESHOLD = sp.Symbol("norm_threshold", positive=True)

# A power of two brings a vector's largest component between MODEST and LARGE.  Then squares do not
# overflow, and no component has fewer digits than its quotient by the length.  The component stays
# smaller only below TINY times 2^-498 (single 2^-57), where it is a multiple of the least subnormal
# number.
TINY, MODEST, LARGE = sp.symbols("tiny modest large", positive=True)
ENLARGING, RAISING, REDUCING = sp.symbols("enlarging raising reducing", positive=True)

# The same for derivatives, which contain squares and cubes of numbers in the results: most numbers
# stay unchanged, others are brought between 2^-263 and 2^202 (single 2^-35 and 2^62).
CALM_TINY, CALM_MODEST, CALM_LARGE = sp.symbols("calm_tiny calm_modest calm_large", positive=True)

# (x + GRID s) - GRID s, for |x| <= s, is x rounded to so few digits that squares of such numbers,
# and sums of three squares, are exact.
GRID = sp.Symbol("grid", positive=True)

# 1 - 50 u: A is regular to rounding if it is positive definite with its diagonal times this.
REGULAR = sp.Symbol("regular", positive=True)

# 16 u: a unit vector that is closer than this to the span of others is dependent to rounding.
DEPENDENT = sp.Symbol("dependent", positive=True)

# A determinant counts as zero below INDISTINCT (8 u) times the sum of its |terms|, plus SPOILED
# times the cube of the largest entry, which exceeds all errors by underflow.
INDISTINCT, SPOILED = sp.symbols("indistinct spoiled", positive=True)

# Powers of two by which a matrix is scaled, such that its largest entry is between 1 and the first
# of them: products of three entries do not overflow, and underflow only where they are negligible.
STEPS = sp.symbols("step step2 step3", positive=True)

# The root of the first of STEPS: where derivatives are taken, the largest entry is between its
# inverse and it, so that the square of a determinant does not overflow.
HALF_STEP = sp.Symbol("half_step", positive=True)

PER_PRECISION: dict[sp.Symbol, tuple[sp.Rational, sp.Rational]] = {
    NORM_THRESHOLD: (sp.Rational(1, 10**9), sp.Rational(1, 10**6)),
    TINY: (sp.Rational(1, 2**494), sp.Rational(1, 2**46)),
    MODEST: (sp.Integer(2**8), sp.Integer(2**8)),
    LARGE: (sp.Integer(2**511), sp.Integer(2**62)),
    ENLARGING: (sp.Integer(2**502), sp.Integer(2**54)),
    RAISING: (sp.Integer(2**1000), sp.Integer(2**108)),
    REDUCING: (sp.Rational(1, 2**513), sp.Rational(1, 2**65)),
    CALM_TINY: (sp.Rational(1, 2**800), sp.Rational(1, 2**80)),
    CALM_MODEST: (sp.Rational(1, 2**300), sp.Rational(1, 2**30)),
    CALM_LARGE: (sp.Integer(2**250), sp.Integer(2**30)),
    HALF_STEP: (sp.Integer(2**150), sp.Integer(2**20)),
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
    """scaled(x, s) = x s for a power of two s: exact unless the result over- or underflows."""

    nargs = 2


class truncated(sp.Function):
    """truncated(c, tail) = c, the last coefficient of a series: with c + δ for some |δ| <= tail in
    its place nothing is left out."""

    nargs = 2


WITHIN = ("Each component is within 1 ulp as long as its condition is below 1e13; in single "
          "precision it is the nearest number, except near ties, as long as that is below 1e5; "
          "searched, not proved.")
"""Promise of the accurate tier for conversions of angles and rotations."""


@dataclass(frozen=True)
class Normwise:
    """|error| <= (k + θ / per_angle) u M for each component of `part`, a part of the result or an
    output.  Found by search, not proved.

    M is the largest |component| of that part, or of the inputs' parts `beside` if that is larger;
    θ is the angle of the input's rotation vector."""

    part: str
    k: int
    beside: tuple[str, ...] = ()  # "s.lin": argument and part
    per_angle: int = 0  # 0: the bound does not depend on the angle

    @property
    def in_words(self) -> str:
        """'t: 8 u', '(5 + θ/500) u'."""
        k = f"({self.k} + θ/{self.per_angle})" if self.per_angle else self.k
        return f"{self.part}: {k} u"


@dataclass(frozen=True)
class Operation:
    """A pure function from inputs to outputs.

    `formula` defines the outputs in plain mathematics.  `derivation`, if given, computes the same
    through intermediate results, which it binds by its first argument, `let(name, value)`; so a
    product of operators costs no more than products of sparse operators.  Both take the inputs'
    values and return one value per output (a tuple if there are several).

    An output with the name of an input is updated in place in C.  `order` is the order of C
    parameters, if it is not inputs, then outputs.
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
    remark: str = ""  # a further property
    rounding: str = ""  # further error bounds, in words
    accurate: str = ""  # replacements in the accurate tier

    def __post_init__(self) -> None:
        for a in self.inputs:
            if not a.says_its_domain:
                raise ValueError(
                    f"operation {self.name}: {a.name}, a {a.quantity.name}, has no domain; give "
                    "Argument one of quantity.py's, or ANY for all numbers")

    @property
    def signature(self) -> str:
        """The gufunc signature: '(3,4),(6)->(6)'."""
        inputs = ",".join(a.quantity.core for a in self.inputs)
        return f"{inputs}->{','.join(a.quantity.core for a in self.outputs)}"

    @property
    def tested_bounds(self) -> str:
        """The bounds in words: `normwise` with the inputs that it holds for, and `rounding`."""
        if not self.normwise:
            return self.rounding
        parts = ", ".join(bound.in_words for bound in self.normwise)
        beside = [name for bound in self.normwise for name in bound.beside]
        also = f", or of {' or '.join(beside)} if that is larger" if beside else ""
        where = [a.domain_in_words for a in self.inputs if a.domain.restricts]
        given = f"{',' if also else ''} for {' and '.join(where)}" if where else ""
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
