"""The variants of an operation: every tier that it has."""

import functools

from coscrew_codegen.formats import Precision
from coscrew_codegen.operations import Operation
from coscrew_codegen.program import Op, Program
from coscrew_codegen.programs import program_of
from coscrew_codegen.report.c_text import Variant
from coscrew_codegen.tiers import TIERS

# An fma counts as two, also where it computes the error of a product.
_FLOPS = {Op.NEG: 0, Op.ABS: 0, Op.LESS: 0, Op.EQUAL: 0, Op.SELECT: 0, Op.FMA: 2, Op.FMS: 2,
          Op.FNMA: 2, Op.PRODUCT_ERROR: 2, Op.PRODUCT_REST: 2}


@functools.cache
def variants_of(operation: Operation, precision: Precision) -> tuple[Variant, ...]:
    """Plain first, then the tiers in their order."""
    plain = program_of(operation)
    return tuple(Variant(tier.operation(operation), precision, tier.name,
                         tier.program(plain, precision)) for tier in TIERS if tier.has(plain))


def flops(program: Program) -> int:
    """Floating-point operations: additions, multiplications, divisions, roots, functions."""
    return sum(_FLOPS.get(op, 1) * count for op, count in program.counts.items())
