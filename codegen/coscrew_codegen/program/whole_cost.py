"""Costs of Programs with the elementary functions that they call."""

from collections import Counter
from collections.abc import Mapping

from coscrew_codegen.program import Op, Program
from coscrew_codegen.program.elementary import ELEMENTARY, ERRORS, Elementary
from coscrew_codegen.program.elementary.elementary_calls import FUNCTION_OF
from coscrew_codegen.program.program import in_words
from coscrew_codegen.program.values.formats import DOUBLE, Precision

_FUNCTIONS = {function.name: function for function in (*ELEMENTARY, *ERRORS)}


def whole_counts(program: Program, precision: Precision) -> Mapping[Op, int]:
    """Counts operations of each kind, including those of called functions.  Sine and cosine of an
    angle are one call; the reduction of angles is that of small ones."""
    working = DOUBLE if program.wide else precision
    total = Counter({op: count for op, count in program.counts.items() if op not in FUNCTION_OF})
    calls = {(function.name, step.operands[:_arguments(function)]): function
             for step in program.instructions if step.op in FUNCTION_OF
             for function in [_FUNCTIONS[FUNCTION_OF[step.op]]]}
    for function in calls.values():
        total += counts_of(function, working)
    return total


def counts_of(function: Elementary, precision: Precision) -> Counter[Op]:
    """The operations of a call, with the reduction of small angles."""
    near = function.near(precision).counts if function.near else {}
    return Counter(function.kernel(precision).counts) + Counter(near)


def whole_cost(program: Program, precision: Precision) -> str:
    """'24 mul, 18 add': these counts in words."""
    return in_words(whole_counts(program, precision))


def _arguments(function: Elementary) -> int:
    """Returns the number of arguments of the true function."""
    return 2 if function.name.startswith("atan2") else 1
