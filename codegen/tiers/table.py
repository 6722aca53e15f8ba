"""The table of tiers behind plain: what each makes of a plain program, per precision."""

from collections.abc import Callable
from dataclasses import dataclass, replace
from fractions import Fraction
from functools import cache, partial

from coscrew_codegen.formats import DOUBLE, SINGLE
from coscrew_codegen.operations import Operation
from coscrew_codegen.program import Constant, Op, Operand, Program
from coscrew_codegen.program.ops import POLYNOMIAL
from coscrew_codegen.tiers.accurate import COMPENSATED, accurate
from coscrew_codegen.tiers.certified import certified, certified_operation
from coscrew_codegen.tiers.fused import fused
from coscrew_codegen.tiers.negation import negating_terms


@dataclass(frozen=True)
class Tier:
    """A tier behind plain: its name, its words, what it does in each precision, and what becomes of
    the operation's arguments."""

    name: str
    title: str
    header: str  # what its C functions need
    double: Callable[[Program], Program]
    single: Callable[[Program], Program]
    operation: Callable[[Operation], Operation] = lambda plain: plain
    in_words: str = ""  # of the Python package; none where there is no such package
    operations: frozenset[Op] = POLYNOMIAL  # what a program may hold

    @property
    def in_python(self) -> bool:
        """Whether Python has the tier."""
        return bool(self.in_words)

    @property
    def exact(self) -> bool:
        """Whether its C computes rounding errors, which is one instruction by fma."""
        return self.header == "ksl_exact"

    def has(self, program: Program) -> bool:
        """Whether the tier makes anything else of a plain program than it is."""
        ops = set(program.counts)
        return any(op.rounds for op in ops) and ops <= self.operations and not any(
            _is_rounded(x) for step in program.instructions if step.op.rounds
            for x in step.operands)

    @cache  # every language asks again
    def program(self, plain: Program, precision: str) -> Program:
        """What the tier makes of a plain program, in "double" or "single" precision."""
        return {"double": self.double, "single": self.single}[precision](plain)


def widened(program: Program) -> Program:
    """The plain program computed in the wider precision, with single's constants."""
    def narrow(x: Operand) -> Operand:
        if not isinstance(x, Constant):
            return x
        value = Fraction(float(SINGLE.rounded(x.single)))
        return Constant(value, value)

    program = negating_terms(program)  # C fuses exact products into sums
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
    return ops <= POLYNOMIAL and bool(ops - {Op.NEG})


FUSED = Tier("fused", "Fused tier: products fused into sums.", "ksl_types", fused, fused)
ACCURATE = Tier("accurate", "Accurate tier: double compensated, single computed in double.",
                "ksl_exact", accurate, widened, in_words="""\
The accurate tier: float64 compensated, intermediate results carried as hi + lo; float32 computed in
float64 and rounded once.  The same bits as the C kernels, with fma or without.""",
                operations=COMPENSATED)
CERTIFIED = Tier("certified",
                 "Certified tier: plain results, and bounds of their errors that hold.",
                 "ksl_types", partial(certified, precision=DOUBLE),
                 partial(certified, precision=SINGLE),
                 certified_operation, """\
The certified tier: every operation returns the plain result, bit for bit, and a bound of each
component's error, whatever the numbers are, under- and overflow included: (result, bound).  \
Where the
bound is infinite or NaN, something overflowed, and it says nothing.""")
TIERS = (FUSED, ACCURATE, CERTIFIED)
