"""Elementary functions that Programs call."""

from collections.abc import Collection

from coscrew_codegen.program import Op, Program
from coscrew_codegen.program.ops import ERROR_OF

FUNCTION_OF = {Op.SIN: "sincos", Op.COS: "sincos", Op.EXP: "exp", Op.TANH: "tanh",
               Op.ATAN2: "atan2"}
FUNCTION_OF |= {ERROR_OF[op]: f"{name}_error" for op, name in FUNCTION_OF.items()}
"""The name of the function that computes an operation."""


def called(programs: Collection[Program]) -> tuple[str, ...]:
    """The names of the elementary functions that these Programs call, in alphabetical order."""
    return tuple(sorted({FUNCTION_OF[op] for program in programs for op in program.counts
                         if op in FUNCTION_OF}))
