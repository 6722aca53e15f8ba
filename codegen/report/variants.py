"""The variants of an operation: plain and every tier that makes something else of it."""

import functools

from coscrew_codegen.formats import Precision
from coscrew_codegen.operations import Operation
from coscrew_codegen.program import Op, Program
from coscrew_codegen.programs import program_of
from coscrew_codegen.report.c_text import Variant
from coscrew_codegen.tiers.table import TIERS

# An fma is two, also where it takes the rounded product off the exact one.
_FLOPS = {Op.NEG: 0, Op.ABS: 0, Op.LESS: 0, Op.EQUAL: 0, Op.SELECT: 0, Op.FMA: 2, Op.FMS: 2,
          Op.FNMA: 2, Op.PRODUCT_ERROR: 2, Op.PRODUCT_REST: 2}


@functools.cache
def variants_of(operation: Operation, precision: Precision) -> tuple[Variant, ...]:
    """Plain first, then the tiers in their table's order."""
    plain = program_of(operation)
    return (Variant(operation, precision, "plain", plain), *(
        Variant(tier.operation(operation), precision, tier.name,
                tier.program(plain, precision.name)) for tier in TIERS if tier.has(plain)))


def flops(program: Program) -> int:
    """Floating-point operations: additions, multiplications, divisions, roots, functions."""
    return sum(_FLOPS.get(op, 1) * count for op, count in program.counts.items())
