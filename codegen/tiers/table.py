"""The table of tiers behind plain: what each makes of a plain program, per precision."""

from collections.abc import Callable
from dataclasses import dataclass, replace
from fractions import Fraction

import numpy as np

from coscrew_codegen.program import Constant, Op, Operand, Program
from coscrew_codegen.tiers.accurate import COMPENSATED, accurate
from coscrew_codegen.tiers.fused import fused

_POLYNOMIAL = {Op.ADD, Op.SUB, Op.MUL, Op.NEG}
_UNROUNDED = {Op.NEG, Op.ABS, Op.SELECT, Op.LESS, Op.EQUAL, Op.SCALE}


@dataclass(frozen=True)
class Tier:
    """A tier behind plain: its name, its words, and what it does in each precision."""

    name: str
    title: str
    header: str  # what its C functions need
    operations: frozenset[Op]  # what a program may hold
    double: Callable[[Program], Program]
    single: Callable[[Program], Program]

    def has(self, program: Program) -> bool:
        """Whether the tier makes anything else of a plain program than it is."""
        ops = set(program.counts)
        return bool(ops - _UNROUNDED) and ops <= self.operations and not any(
            _is_rounded(x) for step in program.instructions if step.op not in _UNROUNDED
            for x in step.operands)

    def program(self, plain: Program, precision: str) -> Program:
        """What the tier makes of a plain program, in "double" or "single" precision."""
        return {"double": self.double, "single": self.single}[precision](plain)


def widened(program: Program) -> Program:
    """The plain program computed in the wider precision, with single's constants."""
    def narrow(x: Operand) -> Operand:
        if not isinstance(x, Constant):
            return x
        value = Fraction(float(np.float32(x.single.numerator / x.single.denominator)))
        return Constant(value, value)

    steps = tuple(replace(step, operands=tuple(map(narrow, step.operands)))
                  for step in program.instructions)
    return replace(program, instructions=steps, wide=True)


def _is_rounded(operand: Operand) -> bool:
    """Whether a constant is no binary fraction, so that no tier can make up for its rounding."""
    denominator = operand.double.denominator if isinstance(operand, Constant) else 1
    return bool(denominator & (denominator - 1))


def has_tiers(program: Program) -> bool:
    """Polynomial, and rounded at all: what every tier has, and error bounds are proved for."""
    ops = set(program.counts)
    return ops <= _POLYNOMIAL and bool(ops - {Op.NEG})


FUSED = Tier("fused", "Fused tier: products fused into sums.", "ksl_types",
             frozenset(_POLYNOMIAL), fused, fused)
ACCURATE = Tier("accurate", "Accurate tier: double compensated, single computed in double.",
                "ksl_exact", frozenset(COMPENSATED), accurate, widened)
TIERS = (FUSED, ACCURATE)
