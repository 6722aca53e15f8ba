"""Pieces of C text that all targets share: calls, products, comments, lists, long lines.

Knows no operation, no scene, and not how arguments are stored.
"""

import textwrap
from collections.abc import Sequence

from coscrew_codegen.program import Constant, Instruction, Op
from coscrew_codegen.program.elementary.elementary_calls import FUNCTION_OF
from coscrew_codegen.program.values.formats import PRECISIONS, Precision

WIDTH = 100

ELEMENTARY = {
    Op.SIN: "ksl_sin{f}({})", Op.COS: "ksl_cos{f}({})", Op.ATAN2: "ksl_atan2{f}({}, {})",
    Op.EXP: "ksl_exp{f}({})", Op.TANH: "ksl_tanh{f}({})",
    Op.SIN_ERROR: "ksl_sin_error{f}({}, {})", Op.COS_ERROR: "ksl_cos_error{f}({}, {})",
    Op.ATAN2_ERROR: "ksl_atan2_error{f}({}, {}, {})", Op.EXP_ERROR: "ksl_exp_error{f}({}, {})",
    Op.TANH_ERROR: "ksl_tanh_error{f}({}, {})", Op.POWER: "ksl_power{f}({})"}
"""Calls of functions of our own, which are the same in all C."""

OF_INTEGERS = {Op.HIGH_PRODUCT: "ksl_high_product({}, {})",
               Op.WIDE_PRODUCT: "ksl_wide_product({}, {})",
               Op.ROUNDED_SHIFT: "ksl_rounded_shift({}, {})"}
"""Calls of operations on integers of 32 bits; a rounded shift of 64 bits calls ksl_narrow."""

PRODUCT_OF = {x.name: f"KSL_MUL{x.suffix.upper()}({{}}, {{}})" for x in PRECISIONS}
"""A product that is rounded on its own, never fused into a sum, by precision."""


def product(precision: Precision, a: str, b: str) -> str:
    """a b in text that is not made from a Program."""
    return PRODUCT_OF[precision.name].format(a, b)


def chunk_of_two_over_pi(step: Instruction) -> str:
    """The call that reads a chunk of 2/π, whose index is an integer."""
    assert isinstance(step.operands[1], Constant)
    return f"ksl_two_over_pi{{f}}({{}}, {int(step.operands[1].double)})"


def sine_and_cosine(sine: Instruction, cosine: Instruction, arguments: str, precision: Precision
                    ) -> str:
    """The statement that declares and computes both, or the errors of both."""
    real, function = precision.c_type, f"ksl_{FUNCTION_OF[sine.op]}{precision.called}"
    return (f"{real} {cosine.name}; const {real} {sine.name} = {function}({arguments}, "
            f"&{cosine.name});")


def comment_of(lines: Sequence[str]) -> str:
    """A C comment of these paragraphs, wrapped."""
    wrapped = [row for line in lines
               for row in textwrap.wrap(line, WIDTH - 6, subsequent_indent="  ")]
    return "/* " + "\n   ".join(wrapped) + " */"


def listed(before: str, items: Sequence[str], after: str, width: int = WIDTH) -> str:
    """`before`, the items separated by commas, `after`; broken between items, indented by four."""
    lines = [before]
    for number, item in enumerate(items):
        piece = item + (after if number == len(items) - 1 else ",")
        glue = "" if number == 0 else " "
        if number and len(lines[-1]) + len(glue) + len(piece) > width:
            lines.append(f"    {piece}")
        else:
            lines[-1] += glue + piece
    return "\n".join(lines) if items else before + after


def broken(text: str, width: int) -> str:
    """The statement, with long lines broken at blanks."""
    rows = []
    for row in text.split("\n"):
        indent = row[:len(row) - len(row.lstrip())]
        rows += [row] if len(row) <= width else textwrap.wrap(
            row, width, subsequent_indent=indent + "    ", break_long_words=False,
            break_on_hyphens=False)
    return "\n".join(rows)
