"""The mixed tier: single precision, with pairs where the requested accuracy needs them.

A Mixture's instructions in pairs are those of the pairs tier.  The others have one rounded result.
Their operands that are pairs take part as hi + lo where that matters, so the result is hi plus the
contributions of the lo; else as hi + lo rounded."""

from dataclasses import dataclass

from coscrew_codegen.accuracy.tiers.accurate_scene import SCENES, compared_exactly, rounded
from coscrew_codegen.accuracy.tiers.compensated import Carrier, CarrierFactory, cross_terms
from coscrew_codegen.accuracy.tiers.tier import Tier
from coscrew_codegen.program import Constant, Instruction, Op, Operand, Program
from coscrew_codegen.program.program import name_of
from coscrew_codegen.program.values.formats import SINGLE

CARRYING = frozenset({Op.ADD, Op.SUB, Op.MUL})
"""The operations to which lo of operands may contribute though the result is a single number."""


@dataclass(frozen=True)
class Mixture:
    """Names of the instructions of a plain program that are carried in pairs; and for the others,
    the operands that take part as hi + lo: pairs (instruction, place of the operand)."""

    paired: frozenset[str]
    kept: frozenset[tuple[str, int]]


def mixed(program: Program, mixture: Mixture, carrier: CarrierFactory = Carrier) -> Program:
    """The plain program in single precision with this mixture."""
    program = compared_exactly(program, SINGLE)
    pairs = carrier(program, SINGLE, SCENES)
    return rounded(pairs.of(program, _Mixed(pairs, mixture).carry), SINGLE)


@dataclass(frozen=True)
class _Mixed:
    """Issues instructions: those in pairs as `pairs` carries them, the others with one result."""

    pairs: Carrier
    mixture: Mixture

    def carry(self, step: Instruction) -> None:
        """Issues the instruction as the mixture says; operations that do not round pass lo on."""
        pairs, kept = self.pairs, self.mixture.kept
        if not step.op.rounds or step.name in self.mixture.paired:
            pairs.carry(step)
            return
        known = tuple(pairs.hi(x) for x in step.operands)
        if step.op is Op.MUL and kept.issuperset((step.name, n) for n in range(2)):
            known = tuple(pairs.factor(step, x) for x in known)
        low = [self.pairs.low(step, x) if (step.name, place) in kept else None
               for place, x in enumerate(known)]
        operands = tuple(x if more is not None else self._single(step, x)
                         for x, more in zip(known, low, strict=True))
        step = step._replace(operands=operands)
        more = self._contributed(step, low)
        if more is None:
            self.pairs.steps.append(step)
        else:
            high = self.pairs.issue(step, step.op, operands, "high")
            self.pairs.steps.append(step._replace(op=Op.ADD, operands=(high, more)))

    def _contributed(self, step: Instruction, low: list[Operand | None]) -> Operand | None:
        """Returns the contribution of the lo parts to a sum, a difference or a product."""
        a_lo, b_lo = low if len(low) == 2 else (None, None)
        if step.op is Op.MUL:
            return cross_terms(self.pairs, step, a_lo, b_lo)
        if a_lo is None and b_lo is not None and step.op is Op.SUB:
            return self.pairs.issue(step, Op.NEG, (b_lo,), "cross")
        if a_lo is None or b_lo is None:
            return a_lo or b_lo
        return self.pairs.issue(step, step.op, (a_lo, b_lo), "cross")

    def _single(self, step: Instruction, x: Operand) -> Operand:
        """hi + lo of an operand rounded, computed once."""
        if isinstance(x, Constant) or self.pairs.is_exact(x):
            return x
        low = self.pairs.low(step, x)
        assert low is not None
        at = step._replace(name=name_of(x))
        return self.pairs.once("single", x, lambda: (
            self.pairs.issue(at, Op.ADD, (x, low), "near"),))[0]


TIER = Tier(
    "mixed", 4, "Mixed tier: single precision; what the asked accuracy needs, in pairs of floats.",
    ("#0f766e", "#5eead4"), make=None, on_request=True, precisions=(SINGLE,), header="ksl_exact",
    in_words="The mixed tier: float32, as much of it in pairs hi + lo as the asked accuracy needs.")
