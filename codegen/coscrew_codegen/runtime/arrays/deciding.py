"""Finds numbers of a Program that decide its choices, and depend on the rounding of sums of
products."""

from coscrew_codegen.program import Instruction, Op, Operand, Program, Ref
from coscrew_codegen.program.ops import COMPARISONS, OF_TABLES

_ELEMENTARY = frozenset({Op.SIN, Op.COS, Op.EXP, Op.TANH, Op.ATAN2})
"""They have sums of products within."""


def deciding(program: Program) -> frozenset[str]:
    """Names of the sums of products, and values of elementary functions, that determine the
    operands of comparisons by operations with only one way of rounding.  If these are fixed, every
    comparison has one result."""
    steps = {step.name: step for step in program.instructions}
    open_ = [x for step in program.instructions if step.op in COMPARISONS | OF_TABLES
             for x in step.operands]
    seen: set[Operand] = set()
    deciders = set()
    while open_:
        x = open_.pop()
        if not isinstance(x, Ref) or x in seen:
            continue
        seen.add(x)
        step = steps[x.name]
        if _has_ways(step, steps):
            deciders.add(step.name)
        else:
            open_.extend(step.operands)
    return frozenset(deciders)


def _has_ways(step: Instruction, steps: dict[str, Instruction]) -> bool:
    """Returns whether the step may be rounded in several ways: a product may be contracted into it.
    """
    return step.op in _ELEMENTARY or (step.op in (Op.ADD, Op.SUB) and any(
        isinstance(x, Ref) and steps[x.name].op in (Op.MUL, Op.NEG) for x in step.operands))
