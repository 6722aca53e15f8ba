"""Replaces negated sums by sums of negated terms, for tiers that fuse products into sums.

gcc may use an instruction that negates a fused sum before rounding; the sign of an exact zero then
depends on the processor.  So no fused sum is negated, or subtracted from a product that is fused.
"""

from dataclasses import replace

from coscrew_codegen.program import Instruction, Op, Program, Ref
from coscrew_codegen.program.program import name_of

_OTHER = {Op.ADD: Op.SUB, Op.SUB: Op.ADD}


def negating_terms(program: Program) -> Program:
    """The program with -(a ± b) as (-a) ∓ b, and c d - (a ± b) as ((-a) ∓ b) + c d, where the sum
    is used only there; if a is such a sum itself, it is treated in the same way."""
    once = {step.name: step.op for step in program.instructions if program.uses[step.name] == 1}
    rewriting = _Rewriting(once)
    for step in reversed(program.instructions):
        rewriting.mark(step)
    steps = [new for step in program.instructions for new in rewriting.of(step)]
    return replace(program, instructions=tuple(steps))


class _Rewriting:
    """Rewrites instructions; those that use a result must be marked before the one that makes it.

    `once` maps the names of results that are used once to their operations."""

    def __init__(self, once: dict[str, Op]) -> None:
        self._sums = {name for name, op in once.items() if op in _OTHER}
        self._products = {name for name, op in once.items() if op is Op.MUL}
        self._negated: dict[str, Instruction | None] = {}  # sum → the negation it replaces, if any
        self._exchanged: set[str] = set()  # c d - sum

    def mark(self, step: Instruction) -> None:
        """Notes the operands of this instruction that have to be negated."""
        names = [name_of(x) for x in step.operands]
        if step.op is Op.NEG and names[0] in self._sums:
            self._negated[names[0]] = step
        elif step.name in self._negated and names[0] in self._sums:
            self._negated[names[0]] = None
        elif step.op is Op.SUB and names[0] in self._products and names[1] in self._sums:
            self._negated[names[1]] = None
            self._exchanged.add(step.name)

    def of(self, step: Instruction) -> list[Instruction]:
        """The instructions that replace this one."""
        if step.op is Op.NEG and name_of(step.operands[0]) in self._negated:
            return []
        if step.name in self._exchanged:
            return [step._replace(op=Op.ADD, operands=step.operands[::-1])]
        if step.name not in self._negated:
            return [step]
        stood_for, (a, b), steps = self._negated[step.name], step.operands, []
        if name_of(a) not in self._negated:
            steps = [step._replace(name=f"{step.name}_lead", op=Op.NEG, operands=(a,))]
            a = Ref(steps[0].name)
        new = step._replace(op=_OTHER[step.op], operands=(a, b))
        if stood_for is not None:
            new = new._replace(name=stood_for.name, component=stood_for.component)
        return [*steps, new]
