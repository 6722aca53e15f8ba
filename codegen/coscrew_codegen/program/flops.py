"""Number of floating-point operations that a Program counts as."""

from collections.abc import Mapping

from coscrew_codegen.program.ops import Op
from coscrew_codegen.program.program import Program

# The fma that computes the error of a product counts as two.
_FLOPS = {Op.NEG: 0, Op.ABS: 0, Op.LESS: 0, Op.EQUAL: 0, Op.SELECT: 0, Op.INDEX: 0,
          Op.GATHER: 0, Op.PRODUCT_ERROR: 2, Op.PRODUCT_REST: 2}


def flops(program: Program) -> int:
    """Floating-point operations: additions, multiplications, divisions, roots, functions."""
    return flops_of(program.counts)


def flops_of(counts: Mapping[Op, int]) -> int:
    """Floating-point operations of counts."""
    return sum(_FLOPS.get(op, 1) * count for op, count in counts.items())
