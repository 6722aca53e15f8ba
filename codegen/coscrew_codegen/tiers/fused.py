"""The fused tier: the plain order; each product that is used once, in a sum, is fused into it.

fma rounds once where plain rounds twice, so c1 is smaller.  Bits differ from the plain tier, and
antisymmetric products of equal arguments are no longer exactly zero.  C only.
"""

from collections import Counter
from dataclasses import replace

from coscrew_codegen.program import Instruction, Op, Program, Ref
from coscrew_codegen.tiers.negation import negating_terms
from coscrew_codegen.tiers.tier import Tier


def fused(program: Program) -> Program:
    """The plain program with fused multiply-adds."""
    program = negating_terms(program)
    uses = Counter(x.name for step in program.instructions for x in step.operands
                   if isinstance(x, Ref))
    uses.update(x.name for x in program.results if isinstance(x, Ref))
    products = {step.name: step for step in program.instructions
                if step.op is Op.MUL and uses[step.name] == 1}
    steps = [_fused(step, products) for step in program.instructions]
    absorbed = {x.name for step in program.instructions for x in step.operands
                if isinstance(x, Ref)} - {x.name for step in steps for x in step.operands
                                          if isinstance(x, Ref)}
    return replace(program, instructions=tuple(s for s in steps if s.name not in absorbed))


def _fused(step: Instruction, products: dict[str, Instruction]) -> Instruction:
    """a b + c, c + a b, a b - c or c - a b as one instruction; the right product first."""
    if step.op not in (Op.ADD, Op.SUB):
        return step
    left, right = step.operands
    if isinstance(right, Ref) and right.name in products:
        op = Op.FMA if step.op is Op.ADD else Op.FNMA
        return replace(step, op=op, operands=(*products[right.name].operands, left))
    if isinstance(left, Ref) and left.name in products:
        op = Op.FMA if step.op is Op.ADD else Op.FMS
        return replace(step, op=op, operands=(*products[left.name].operands, right))
    return step


TIER = Tier("fused", 1, "Fused tier: products fused into sums.", ("#0072b2", "#56b4e9"),
            make=lambda program, precision: fused(program))
