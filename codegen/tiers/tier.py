"""What a tier is: how it describes itself, what it makes of a plain program, which it takes."""

from collections.abc import Callable
from dataclasses import dataclass
from functools import cache

from coscrew_codegen.formats import Precision
from coscrew_codegen.operations import Operation
from coscrew_codegen.program import Constant, Op, Operand, Program
from coscrew_codegen.program.ops import POLYNOMIAL


def is_polynomial(program: Program) -> bool:
    """Whether it rounds, sums and products alone, and holds no constant that is rounded."""
    return rounds_by(POLYNOMIAL, program)


def rounds_by(ops: frozenset[Op], program: Program) -> bool:
    """Whether it rounds, by these alone, and computes with no constant that is rounded: no tier
    can make up for that."""
    held = program.counts.keys()
    return any(op.rounds for op in held) and held <= ops and not any(
        _is_rounded(x) for step in program.instructions if step.op.rounds
        for x in step.operands)


def _is_rounded(operand: Operand) -> bool:
    """Whether it is a constant and no binary fraction."""
    denominator = operand.double.denominator if isinstance(operand, Constant) else 1
    return bool(denominator & (denominator - 1))


@dataclass(frozen=True, eq=False)
class Tier:
    """A way to compute what a plain program says: more accurate, faster, or with a bound.

    A file of this folder that calls one `TIER` has added it: headers, packages, the extension,
    the report and the tests find it there."""

    name: str  # accurate: in C ksl_dot_cs_accurate, in Python coscrew.accurate
    order: int  # where it stands among the others, the cheapest first
    title: str  # first line of its headers, behind the family's
    colours: tuple[str, str]  # in plots, on light and on dark ground
    make: Callable[[Program, Precision], Program]  # of a plain program
    has: Callable[[Program], bool] = is_polynomial  # what it needs of a plain program
    operation: Callable[[Operation], Operation] = lambda plain: plain  # with further outputs
    header: str = "ksl_types"  # what its C functions need; ksl_exact computes rounding errors
    in_words: str = ""  # of its Python package; none where C alone has the tier
    marked: bool = True  # whether its names tell it

    @cache  # noqa: B019  every language asks again; tiers live as long as the process
    def program(self, plain: Program, precision: Precision) -> Program:
        """What the tier makes of a plain program, in this precision."""
        return self.make(plain, precision)

    @property
    def mark(self) -> str:
        """What names have of it: accurate; of plain, nothing."""
        return self.name if self.marked else ""

    @property
    def in_python(self) -> bool:
        """Whether Python has the tier."""
        return bool(self.in_words)

    @property
    def package(self) -> str:
        """The Python package: coscrew, coscrew.accurate."""
        return ".".join(filter(None, ("coscrew", self.mark)))

    @property
    def umbrella(self) -> str:
        """The header that includes all others: ksl, ksl_accurate."""
        return "_".join(filter(None, ("ksl", self.mark)))

    @property
    def exact(self) -> bool:
        """Whether its C computes rounding errors, which is one instruction by fma."""
        return self.header == "ksl_exact"
