"""Programs: kernels in their order of evaluation; error bounds, constant folding, interpreter."""

from coscrew_codegen.program.ops import Op
from coscrew_codegen.program.program import (
           ONE,
           ZERO,
           Constant,
           Input,
           Instruction,
           NotANumber,
           Operand,
           Program,
           Ref,
           by_component,
           constant,
           counts_in_words,
           operands_of_pair,
           renamed,
           scales,
           sine_cosine_pairs,
           with_constants,
           without_dead_steps,
)

__all__ = ["ONE", "ZERO", "Constant", "Input", "Instruction", "NotANumber", "Op", "Operand",
           "Program", "Ref", "by_component", "constant", "counts_in_words", "operands_of_pair",
           "renamed", "scales", "sine_cosine_pairs", "with_constants", "without_dead_steps"]
