"""Tiers: a description, a transformation of plain programs, and the programs that it can transform.
"""

from collections.abc import Callable
from dataclasses import dataclass
from functools import cache
from typing import TYPE_CHECKING

from coscrew_codegen.program import Op, Program
from coscrew_codegen.program.ops import POLYNOMIAL
from coscrew_codegen.program.program import has_rounded_constants
from coscrew_codegen.program.values.formats import PRECISIONS, Precision
from coscrew_codegen.program.values.quantity import Argument

if TYPE_CHECKING:  # with it comes SymPy, for which `coscrew simulate` need not wait
    from coscrew_codegen.accuracy.range_proofs import ResultBounds
    from coscrew_codegen.algebra.operations import Operation
    from coscrew_codegen.program.scene_functions import FunctionProgram


def is_polynomial(program: Program) -> bool:
    """Returns whether the program rounds, by sums and products only, and all its constants are
    exact."""
    return rounds_by(POLYNOMIAL, program) and not has_rounded_constants(program)


def rounds_by(ops: frozenset[Op], program: Program) -> bool:
    """Returns whether the program rounds, by these operations only."""
    held = program.counts.keys()
    return any(op.rounds for op in held) and held <= ops


def bounds_of_outputs(outputs: tuple[Argument, ...]) -> tuple[Argument, ...]:
    """The outputs that hold the bounds: `co_bound` for `co`."""
    return tuple(Argument(f"{a.name}_bound", a.quantity) for a in outputs)


@dataclass(frozen=True, eq=False)
class Tier:
    """A way to compute a plain program's results: more accurate, faster, or with an error bound.

    A module of this package that assigns one to `TIER` adds it to headers, packages, the extension,
    the report and the tests."""

    name: str  # accurate: in C ksl_dot_cs_accurate, in Python coscrew.accurate
    order: int  # sorts the tiers, the cheapest first
    title: str  # in the first line of its headers, after the family's title
    colours: tuple[str, str]  # in plots, on a light and on a dark background
    make: Callable[[Program, Precision], Program] | None  # plain program → the tier's; None:
    # operations do not have the tier
    has: Callable[[Program], bool] = is_polynomial  # whether a plain program has this tier
    operation: Callable[["Operation"], "Operation"] = lambda plain: plain  # may add outputs
    scene: Callable[[Program, Precision], Program] | None = None  # plain program of a scene's
    # function → the tier's, which may have more outputs; None: scenes do not have the tier
    bounds: bool = False  # whether operations return bounds, where inf and NaN make no statement
    on_request: bool = False  # whether only scenes' functions with a requested accuracy have it
    fixed: bool = False  # whether scenes' values are integers in fixed point, for stated ranges
    proof: "Callable[[FunctionProgram, Precision], ResultBounds | None] | None" = None
    # bounds of a scene's function over its stated ranges; None: without proof
    precisions: tuple[Precision, ...] = PRECISIONS  # that it has in scenes
    pairs: tuple[Precision, ...] = ()  # in which scenes' values are pairs hi + lo
    widened: tuple[Precision, ...] = ()  # in which scenes compute in double, and round at the end
    header: str = "ksl_types"  # that its C functions need; ksl_exact computes rounding errors
    promise: str = ""  # what results of scenes' functions are, and when, in words
    in_words: str = ""  # docstring of its Python package
    marked: bool = True  # whether names of its functions end in the tier's name

    @cache  # noqa: B019  called for every language; tiers live as long as the process
    def program(self, plain: Program, precision: Precision) -> Program:
        """The tier's program for a plain program of an operation, in this precision."""
        if self.make is None:
            raise ValueError(f"operations do not have the {self.name} tier")
        return self.make(plain, precision)

    @property
    def mark(self) -> str:
        """The suffix of names, without its underscore: "accurate"; "" for plain."""
        return self.name if self.marked else ""

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
        """True if its C computes rounding errors, for which fma needs one instruction."""
        return self.header == "ksl_exact"
