"""Programs: kernels in their order of evaluation; error bounds, constant folding, interpreter."""

from coscrew_codegen.program.ops import Op
from coscrew_codegen.program.program import (
    Constant,
    Input,
    Instruction,
    NotANumber,
    Operand,
    Program,
    Ref,
    by_component,
    counts_in_words,
    operands_of_pair,
    renamed,
    scales,
    sine_cosine_pairs,
    without_dead_steps,
)

__all__ = ["Constant", "Input", "Instruction", "NotANumber", "Op", "Operand", "Program", "Ref",
           "by_component", "counts_in_words", "operands_of_pair", "renamed", "scales",
           "sine_cosine_pairs", "without_dead_steps"]
