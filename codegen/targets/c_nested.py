"""Writes a Program as C with nested expressions; named values are declared.

For files in which compilers do not contract within an expression.  A product that a sum uses, in
the same or another statement, is RN(a * b), rounded on its own even by compilers that contract in
spite of every pragma.
"""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from itertools import groupby, pairwise

from coscrew_codegen.formats import DOUBLE, Precision
from coscrew_codegen.program import Constant, Input, Instruction, Op, Program, Ref
from coscrew_codegen.program.ops import COMPARISONS
from coscrew_codegen.targets.c_statements import (
    ELEMENTARY,
    chunk_of_two_over_pi,
    listed,
    sine_and_cosine,
)
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
    Op.PRODUCT_REST: ("ksl_product_rest%s({}, {}, {}, {})", CALL),
    **{op: (pattern.replace("{f}", "%s"), CALL) for op, pattern in ELEMENTARY.items()},
}
_ROUNDED = "RN({} * {})", CALL
LANES = 4  # angles whose sines and cosines are computed at once
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


@dataclass(frozen=True)
class Together:
    """Sines and cosines that are computed by one call."""

    pairs: Sequence[Assignment]

    @property
    def step(self) -> Instruction:
        """The first of them."""
        return self.pairs[0].step

    @property
    def names(self) -> tuple[str, ...]:
        """All that is assigned."""
        return tuple(name for pair in self.pairs for name in pair.names)

    def statements(self, precision: Precision, width: int) -> str:
        """The call, and declarations of what it stores in arrays."""
        real, arrays = precision.c_type, [f"{x}_of_{self.names[0]}" for x in ("sines", "cosines")]
        angles = [pair.expression for pair in self.pairs]
        call = listed(f"ksl_sincos_{len(angles)}{precision.suffix}(", [*angles, *arrays], ");",
                      width)
        values = (f"{array}[{n}]" for n in range(len(angles)) for array in arrays)
        return "\n".join((
            f"{real} {', '.join(f'{x}[{LANES}]' for x in arrays)};", call,
            listed(f"const {real} ", [f"{name} = {value}" for name, value in zip(
                self.names, values, strict=True)], ";", width)))


def together(assigned: Sequence[Assignment | str]) -> list[Assignment | Together | str]:
    """With the sines and cosines of inputs first, several together; headings below which nothing is
    left are left out."""
    pairs = [x for x in assigned if isinstance(x, Assignment) and x.cosine
             and x.step.op is Op.SIN and isinstance(x.step.operands[0], Input)]
    groups = [pairs[n:n + LANES] for n in range(0, len(pairs), LANES)]
    moved = {x.step.name for group in groups if len(group) > 1 for x in group}
    rest = [x for x in assigned if isinstance(x, str) or x.step.name not in moved]
    kept = [x for x, following in pairwise((*rest, ""))
            if not (isinstance(x, str) and isinstance(following, str))]
    return [*(Together(group) for group in groups if len(group) > 1), *kept]


def declarations(assigned: Sequence[Assignment | Together | str], precision: Precision,
                 width: int) -> Iterator[str]:
    """Declarations and headings; declarations of the same component are one statement."""
    def kind(x: Assignment | Together | str) -> tuple[str, str]:
        if isinstance(x, str):
            return "", f"/* {x} */"
        if isinstance(x, Together):
            return "", x.statements(precision, width)
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
