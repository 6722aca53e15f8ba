"""Writes a Program as C with nested expressions; named values are declared.

For files in which compilers do not contract within an expression.  A product that a sum uses, in
the same or another statement, is RN(a * b), rounded on its own even by compilers that contract in
spite of every pragma.
"""

from collections.abc import Iterator, Sequence
from itertools import groupby

from coscrew_codegen.formats import DOUBLE, Precision
from coscrew_codegen.program import Constant, Instruction, Op, Program, Ref
from coscrew_codegen.program.ops import COMPARISONS
from coscrew_codegen.targets.c_statements import ELEMENTARY, chunk_of_two_over_pi, sine_and_cosine
from coscrew_codegen.targets.nesting import (
    CALL,
    CHOICE,
    COMPARISON,
    PRODUCT,
    SIGN,
    SUM,
    Assignment,
    Language,
    wrapped,
)

_SPELLING = {
    Op.ADD: ("{} + {}", SUM), Op.SUB: ("{} - {}", SUM), Op.MUL: ("{} * {}", PRODUCT),
    Op.DIV: ("{} / {}", PRODUCT), Op.NEG: ("-{}", SIGN), Op.ABS: ("fabs%s({})", CALL),
    Op.SCALE: ("{} * {}", PRODUCT), Op.SQRT: ("sqrt%s({})", CALL),
    Op.COPYSIGN: ("copysign%s({}, {})", CALL),
    Op.LESS: ("{} < {}", COMPARISON), Op.EQUAL: ("{} == {}", COMPARISON),
    Op.SELECT: ("{} ? {} : {}", CHOICE),
    Op.EXACT_ADD: ("{} + {}", SUM), Op.EXACT_SUB: ("{} - {}", SUM),
    Op.PRODUCT_ERROR: ("ksl_product_error%s({}, {}, {})", CALL),
    Op.PRODUCT_REST: ("ksl_product_rest({}, {}, {}, {})", CALL),
    **{op: (pattern.replace("{f}", "%s"), CALL) for op, pattern in ELEMENTARY.items()},
}
_ROUNDED = "RN({} * {})", CALL
_SUMS = frozenset({Op.ADD, Op.SUB, Op.EXACT_ADD, Op.EXACT_SUB, Op.PRODUCT_ERROR, Op.PRODUCT_REST})
_TRANSPARENT = frozenset({Op.NEG, Op.ABS, Op.SELECT})
"""Operations through which a sum still has a product as operand."""


def language(program: Program, precision: Precision) -> Language:
    """C in a precision, of this program."""
    precision = DOUBLE if program.wide else precision
    rounded, suffix = summed_products(program), precision.suffix

    def spelling(step: Instruction) -> tuple[str, int]:
        if step.name in rounded:
            return _ROUNDED
        if step.op is Op.TWO_OVER_PI:
            return chunk_of_two_over_pi(step).replace("{f}", suffix), CALL
        pattern, binding = _SPELLING[step.op]
        return pattern.replace("%s", suffix), binding

    def constant(x: Constant) -> str:
        return precision.literal(x) + suffix

    return Language(spelling, constant, f"({precision.c_type})NAN", "", "{arguments}")


def summed_products(program: Program) -> frozenset[str]:
    """The products that a compiler could fuse into a sum of the program, or of a caller that uses
    its results.  A product with 2 counts as a sum, since compilers replace it by one."""
    seen = {x.name for x in program.results if isinstance(x, Ref)}
    found = []
    for step in reversed(program.instructions):
        if step.op in _SUMS or _doubles(step) or step.op in _TRANSPARENT and step.name in seen:
            seen |= {x.name for x in step.operands if isinstance(x, Ref)}
        if step.op in (Op.MUL, Op.SCALE) and step.name in seen:
            found.append(step.name)
    return frozenset(found)


def _doubles(step: Instruction) -> bool:
    return step.op is Op.MUL and any(
        isinstance(x, Constant) and abs(x.double) == 2 for x in step.operands)


def declarations(assigned: Sequence[Assignment | str], precision: Precision,
                 width: int) -> Iterator[str]:
    """Declarations and headings; declarations of the same component are one statement."""
    def kind(x: Assignment | str) -> tuple[str, str]:
        if isinstance(x, str):
            return "", f"/* {x} */"
        if x.cosine:
            return "", sine_and_cosine(x.step, x.cosine, x.expression, precision)
        return ("int" if x.step.op in COMPARISONS else precision.c_type), x.step.component

    for (c_type, words), group in groupby(assigned, kind):
        if not c_type:
            yield words
        else:
            items = [f"{x.step.name} = {x.expression}" for x in group if isinstance(x, Assignment)]
            yield _declared(f"const {c_type} ", items, width)


def _declared(head: str, items: Sequence[str], width: int) -> str:
    """One statement of these declarators: short ones several to a line, long ones broken."""
    lines = [head]
    for number, item in enumerate(items):
        text = item + (";" if number == len(items) - 1 else ",")
        glue = " " if number else ""
        if number and len(lines[-1]) + len(glue) + len(text) > width:
            lines.append("    ")
            glue = ""
        first, *others = wrapped(lines.pop() + glue + text, width, 8)
        lines += [first, *(f"        {row}" for row in others)]
    return "\n".join(lines)
