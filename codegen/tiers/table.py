"""The table of tiers behind plain: what each makes of a plain program, per precision."""

from collections.abc import Callable
from dataclasses import dataclass, replace
from functools import partial

from coscrew_codegen.operations import Operation
from coscrew_codegen.program import Op, Program
from coscrew_codegen.tiers.accurate import accurate
from coscrew_codegen.tiers.certified import DOUBLE, SINGLE, certified, certified_operation
from coscrew_codegen.tiers.fused import fused

_POLYNOMIAL = {Op.ADD, Op.SUB, Op.MUL, Op.NEG}


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

    @property
    def in_python(self) -> bool:
        """Whether Python has the tier."""
        return bool(self.in_words)

    def program(self, plain: Program, precision: str) -> Program:
        """What the tier makes of a plain program, in "double" or "single" precision."""
        return {"double": self.double, "single": self.single}[precision](plain)


def widened(program: Program) -> Program:
    """The plain program computed in the wider precision."""
    return replace(program, wide=True)


def has_tiers(program: Program) -> bool:
    """Polynomial, and rounded at all: elsewhere every tier would be plain again."""
    ops = set(program.counts)
    return ops <= _POLYNOMIAL and bool(ops - {Op.NEG})


FUSED = Tier("fused", "Fused tier: products fused into sums.", "ksl_types", fused, fused)
ACCURATE = Tier("accurate", "Accurate tier: double compensated, single computed in double.",
                "ksl_exact", accurate, widened, in_words="""\
The accurate tier: float64 compensated, intermediate results carried as hi + lo; float32 computed in
float64 and rounded once.  The same bits as the C kernels while nothing over- or underflows.""")
CERTIFIED = Tier("certified", "Certified tier: plain results, and bounds of their errors that hold.",
                 "ksl_types", partial(certified, number=DOUBLE), partial(certified, number=SINGLE),
                 certified_operation, """\
The certified tier: every operation returns the plain result, bit for bit, and a bound of each
component's error, whatever the numbers are, under- and overflow included: (result, bound).  Where the
bound is infinite or NaN, something overflowed, and it says nothing.""")
TIERS = (FUSED, ACCURATE, CERTIFIED)
