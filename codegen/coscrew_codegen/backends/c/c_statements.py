"""Writes a Program's instructions as C, and C comments; shared by all targets that emit C.

One operation per statement (or declarator), so that a compiler that contracts within expressions
cannot fuse a product into a sum.  A rounded product is KSL_MUL(a, b), which compilers that contract
across statements leave alone.  Products of two single-precision numbers in double are exact: they
are written inside the sum that uses them, as an fma where the machine has one.
Knows no operation, no scene, and not how arguments are stored.
"""

import textwrap
from collections import Counter
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property
from itertools import groupby

from coscrew_codegen.program import (
    Constant,
    Input,
    Instruction,
    NotANumber,
    Op,
    Operand,
    Program,
    Ref,
    operands_of_pair,
    sine_cosine_pairs,
)
from coscrew_codegen.program.elementary.elementary_calls import FUNCTION_OF
from coscrew_codegen.program.ops import COMPARISONS
from coscrew_codegen.program.values.formats import SINGLE, Precision

WIDTH = 100

ELEMENTARY = {
    Op.SIN: "ksl_sin{f}({})", Op.COS: "ksl_cos{f}({})", Op.ATAN2: "ksl_atan2{f}({}, {})",
    Op.EXP: "ksl_exp{f}({})", Op.TANH: "ksl_tanh{f}({})",
    Op.SIN_ERROR: "ksl_sin_error{f}({}, {})", Op.COS_ERROR: "ksl_cos_error{f}({}, {})",
    Op.ATAN2_ERROR: "ksl_atan2_error{f}({}, {}, {})", Op.EXP_ERROR: "ksl_exp_error{f}({}, {})",
    Op.TANH_ERROR: "ksl_tanh_error{f}({}, {})", Op.POWER: "ksl_power{f}({})"}
"""Calls of functions of our own, which are the same in all C."""

_SPELLING = {
    Op.ADD: "{} + {}", Op.SUB: "{} - {}", Op.DIV: "{} / {}", Op.NEG: "-{}",
    Op.MUL: "KSL_MUL{F}({}, {})", Op.SCALE: "KSL_MUL{F}({}, {})",
    Op.EXACT_ADD: "{} + {}", Op.EXACT_SUB: "{} - {}",
    Op.PRODUCT_ERROR: "ksl_product_error{f}({}, {}, {})",
    Op.PRODUCT_REST: "ksl_product_rest{f}({}, {}, {}, {})",
    Op.ABS: "fabs{f}({})", Op.SQRT: "sqrt{f}({})", Op.COPYSIGN: "copysign{f}({}, {})",
    Op.LESS: "{} < {}", Op.EQUAL: "{} == {}", Op.SELECT: "{} ? {} : {}", **ELEMENTARY,
}


def product(precision: Precision, a: str, b: str) -> str:
    """a b in text that is not made from a Program: rounded on its own, never fused into a sum."""
    return _SPELLING[Op.MUL].format(a, b, F=precision.suffix.upper())


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


def _negated(text: str) -> str:
    return text[1:] if text.startswith("-") else f"-{text}"


@dataclass(frozen=True)
class Statements:
    """The instructions of `program` as C, computed in the precision `working`.

    `access` returns the expression that reads an input.  Comparisons are written inside the choices
    that use them."""

    program: Program
    working: Precision
    access: Callable[[Input], str]

    @cached_property
    def inlined(self) -> dict[str, Instruction]:
        """The comparisons, by name."""
        return {step.name: step for step in self.program.instructions
                if step.op in COMPARISONS}

    @cached_property
    def pairs(self) -> dict[str, tuple[Instruction, Instruction]]:
        """Sines and cosines that are computed together, by the names of both."""
        return sine_cosine_pairs(self.program)

    @cached_property
    def first_of_pairs(self) -> set[str]:
        """The names of those that come first in their pair."""
        met: dict[str, str] = {}
        for step in self.program.instructions:
            if step.name in self.pairs:
                met.setdefault(self.pairs[step.name][0].name, step.name)
        return set(met.values())

    @cached_property
    def absorbed(self) -> dict[str, Instruction]:
        """The products that are written inside a sum, by the name of the sum: exact products that
        are used once, at most one per sum."""
        found: dict[str, Instruction] = {}
        uses = Counter(x.name for x in (*self.program.results, *(
            x for step in self.program.instructions for x in step.operands)) if isinstance(x, Ref))
        products = {step.name: step for step in self.program.instructions
                    if self._exact(step) and uses[step.name] == 1}
        for step in self.program.instructions:
            if step.op in (Op.ADD, Op.SUB):
                last = [x.name for x in step.operands if isinstance(x, Ref) and x.name in products]
                if last:
                    found[step.name] = products[last[-1]]
        return found

    def declarators(self, steps: Sequence[Instruction]) -> list[str]:
        """`name = expression` for each instruction that is declared."""
        absent = self.inlined.keys() | {product.name for product in self.absorbed.values()}
        return [f"{step.name} = {self.expression(step)}" for step in steps
                if step.name not in absent]

    def declared(self, steps: Sequence[Instruction], width: int) -> str:
        """const double x = …, y = …; for the instructions of a component, empty if there are none.
        A sine and a cosine of the same operand are computed together, by a statement of their own.
        """
        texts = []
        for pair, group in groupby(steps, key=lambda step: self.pairs.get(step.name)):
            if pair is None:
                items = self.declarators(list(group))
                texts += [listed(f"const {self.working.c_type} ", items, ";", width)] * bool(items)
            elif next(group).name in self.first_of_pairs:
                sine, cosine = pair
                arguments = ", ".join(map(self.operand, operands_of_pair(sine, cosine)))
                texts.append(sine_and_cosine(sine, cosine, arguments, self.working))
        return "\n".join(texts)

    def expression(self, step: Instruction) -> str:
        """The right-hand side of an instruction."""
        if step.name in self.absorbed:
            return self._product_sum(step, self.absorbed[step.name])
        operands = [self.operand(x) for x in step.operands]
        if step.op is Op.NEG and operands[0].startswith("-"):
            operands = [f"({operands[0]})"]  # C reads -- as one operator
        spelling = ("{} * {}" if self._exact(step) else chunk_of_two_over_pi(step)
                    if step.op is Op.TWO_OVER_PI else _SPELLING[step.op])
        suffix = self.working.suffix
        return spelling.format(*operands, f=suffix, F=suffix.upper())

    def _product_sum(self, step: Instruction, product: Instruction) -> str:
        """The sum or difference of an exact product and another operand."""
        a, b = map(self.operand, product.operands)
        first, second = step.operands
        subtrahend = second if step.op is Op.SUB else None
        other = first if second == Ref(product.name) else second
        c = self.operand(other)
        if subtrahend == other:
            c = _negated(c)
        elif subtrahend is not None:
            a = _negated(a)
        return f"ksl_product_sum({a}, {b}, {c})"

    def _exact(self, step: Instruction) -> bool:
        """Returns whether this is a product, in double, of two single-precision numbers."""
        return self.program.wide and step.op is Op.MUL and all(map(self._single, step.operands))

    def _single(self, operand: Operand) -> bool:
        if isinstance(operand, Constant):
            value = self.working.value(operand)
            return Fraction(float(SINGLE.rounded(value))) == value
        return isinstance(operand, Input)

    def operand(self, operand: Operand) -> str:
        """The text of an operand, in the working precision."""
        if isinstance(operand, Input):
            widened = f"({self.working.c_type})" if self.program.wide else ""
            return widened + self.access(operand)
        if isinstance(operand, Constant):
            return self.working.literal(operand) + self.working.suffix
        if isinstance(operand, NotANumber):
            return f"({self.working.c_type})NAN"
        return (self.expression(self.inlined[operand.name]) if operand.name in self.inlined
                else operand.name)
