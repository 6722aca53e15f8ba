"""How many floating-point operations a Program counts as."""

from coscrew_codegen.program.ops import Op
from coscrew_codegen.program.program import Program

# An fma counts as two, also where it computes the error of a product.
_FLOPS = {Op.NEG: 0, Op.ABS: 0, Op.LESS: 0, Op.EQUAL: 0, Op.SELECT: 0, Op.FMA: 2, Op.FMS: 2,
          Op.FNMA: 2, Op.PRODUCT_ERROR: 2, Op.PRODUCT_REST: 2}


def flops(program: Program) -> int:
    """Floating-point operations: additions, multiplications, divisions, roots, functions."""
    return sum(_FLOPS.get(op, 1) * count for op, count in program.counts.items())
