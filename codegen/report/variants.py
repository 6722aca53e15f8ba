"""The variants of an operation: plain and every tier that makes something else of it."""

import functools

from coscrew_codegen.layout import program_of
from coscrew_codegen.operations import Operation
from coscrew_codegen.program import Op, Program
from coscrew_codegen.report.c_text import Variant
from coscrew_codegen.targets.precision import Precision
from coscrew_codegen.tiers.table import TIERS, has_tiers

# An fma is two; what is left of an exact sum's error, once the sum is there, five.
_FLOPS = {Op.NEG: 0, Op.ABS: 0, Op.LESS: 0, Op.EQUAL: 0, Op.SELECT: 0, Op.FMA: 2, Op.FMS: 2,
          Op.FNMA: 2, Op.PRODUCT_ERROR: 2, Op.SUM_ERROR: 5, Op.DIFFERENCE_ERROR: 5}

_plain_program = functools.cache(program_of)


@functools.cache
def variants_of(operation: Operation, precision: Precision) -> tuple[Variant, ...]:
    """Plain first, then the tiers in their table's order."""
    plain = _plain_program(operation)
    tiers = TIERS if has_tiers(plain) else ()
    return (Variant(operation, precision, "plain", plain), *(
        Variant(_operation(tier, operation), precision, tier.name,
                tier.program(plain, precision.name)) for tier in tiers))


def flops(program: Program) -> int:
    """Floating-point operations: additions, multiplications, divisions, roots, functions."""
    return sum(_FLOPS.get(op, 1) * count for op, count in program.counts.items())


def _operation(tier, operation: Operation) -> Operation:
    """The operation as the tier has it: a tier may add outputs."""
    return tier.operation(operation) if hasattr(tier, "operation") else operation
