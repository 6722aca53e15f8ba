"""The accurate tier.  In single precision: computed in double, rounded once.

In double precision: the plain program with every intermediate result carried as hi + lo; the sum
hi + lo is rounded at the end.  First-order errors cancel; the rest is of order u² S.

Where a polynomial's bound would be too large to prove one ulp up to condition 1e14, sums are made
non-overlapping before they are multiplied, too.  Then hi has a single rounding error, so that fewer
products of two errors remain.
"""

from dataclasses import replace
from fractions import Fraction
from typing import TYPE_CHECKING

from coscrew_codegen.accuracy.bounds import bounds_of
from coscrew_codegen.accuracy.range_proofs import of_accurate
from coscrew_codegen.accuracy.tiers.accurate_scene import in_pairs, rounded
from coscrew_codegen.accuracy.tiers.compensated import (
    Carrier,
    Carrying,
    carried,
    suffixed,
    total,
    two_sum,
)
from coscrew_codegen.accuracy.tiers.negation import negating_terms
from coscrew_codegen.accuracy.tiers.nonlinear import RULES
from coscrew_codegen.accuracy.tiers.tier import Tier, rounds_by
from coscrew_codegen.program import Constant, Instruction, Op, Program, constant, with_constants
from coscrew_codegen.program.values.formats import DOUBLE, SINGLE, Precision

if TYPE_CHECKING:
    from coscrew_codegen.algebra.operations import Operation

LARGEST_C2 = 45
"""The largest c2 of any polynomial program: 1 / (2 c2 u) is just above 1e14."""

LARGEST = 1000
"""The longest plain program, in instructions, that has an accurate version, which is six times as
long.  Iterations such as `mat3x3_nearest_rotation` are longer, and backward stable without."""


def _overlapping(c: Carrier, step: Instruction) -> None:
    """A sum that is made non-overlapping before it is multiplied."""
    c.overlapping.add(step.name)
    total(c, step)


QUICK = Carrying(RULES, suffixed, two_sum)
CAREFUL = replace(QUICK, rules={**RULES, Op.ADD: _overlapping, Op.SUB: _overlapping})


def accurate(program: Program) -> Program:
    """The plain program compensated; c2 <= LARGEST_C2 if it is a polynomial."""
    quick = carried(program, DOUBLE, QUICK)
    bounds = bounds_of(quick)
    if bounds is None or all(bound.c2 <= LARGEST_C2 for bound in bounds):
        return quick
    return carried(program, DOUBLE, CAREFUL)


def widened(program: Program) -> Program:
    """The plain program computed in double, with the thresholds of single precision."""
    def narrow(x: Constant) -> Constant:
        same = x.double == x.single
        return constant(Fraction(float(x.double if same else SINGLE.rounded(x.single))))

    program = negating_terms(program)  # C may fuse exact products into sums
    return replace(with_constants(program, narrow), wide=True, fine=None)


def _made(program: Program, precision: Precision) -> Program:
    program = program.fine or program
    return rounded(accurate(program), DOUBLE) if precision == DOUBLE else widened(program)


def of_scene(program: Program, precision: Precision) -> Program:
    """The plain program of a scene's function, whose constants are decimals: hi + lo in double; in
    single precision doubles."""
    if precision == DOUBLE:
        return in_pairs(program, DOUBLE)
    return replace(rounded(program.fine or program, DOUBLE), wide=True)


def accurate_operation(operation: "Operation") -> "Operation":
    """The operation with the bounds of this tier."""
    if not operation.normwise:
        return replace(operation, rounding=operation.accurate or operation.rounding)
    within = tuple(replace(bound, k=1, per_angle=0) for bound in operation.normwise)
    words = f"{operation.accurate}  {operation.rounding}".strip()
    return replace(operation, normwise=within, rounding=words)


def _has(program: Program) -> bool:
    return rounds_by(frozenset(RULES), program) and len(program.instructions) <= LARGEST


TIER = Tier(
    "accurate", 2, "Accurate tier: double compensated, single computed in double.",
    ("#c2570c", "#f5a04d"), _made, has=_has, operation=accurate_operation, scene=of_scene,
    header="ksl_exact", proof=of_accurate, pairs=(DOUBLE,), widened=(SINGLE,),
    promise="""\
A component is within one unit of its last digit as long as its condition is below 1e13; in single
precision it is the nearest number, except near ties, as long as that is below 1e5.  Measured, not
proved.  The condition counts the model's decimals among the rounded results.  Nothing is promised
where something overflows or a product falls below 2^-968.""",
    in_words="""\
The accurate tier: float64 compensated, intermediate results carried as hi + lo; float32 computed in
float64 and rounded once.  The same bits as the C kernels, with fma or without.""")
