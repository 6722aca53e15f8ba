"""Writes a Program as C with nested expressions; named values are declared.

For files in which compilers do not contract within an expression.  A product that a sum uses, in
the same or another statement, is RN(a * b), rounded on its own even by compilers that contract in
spite of every pragma.
"""

from collections import Counter
from collections.abc import Callable, Iterator, Mapping, Sequence
from functools import cache
from itertools import groupby

from coscrew_codegen.backends.c.c_statements import (
    ELEMENTARY,
    chunk_of_two_over_pi,
    sine_and_cosine,
)
from coscrew_codegen.backends.c.c_together import Together
from coscrew_codegen.backends.c.tables import c_tables
from coscrew_codegen.backends.nesting import (
    CALL,
    CHOICE,
    COMPARISON,
    CONSTANTS,
    PRODUCT,
    SIGN,
    SUM,
    Assignment,
    Language,
    wrapped,
)
from coscrew_codegen.program import Constant, Input, Instruction, Op, Operand, Program, Ref
from coscrew_codegen.program.kept_results import kept_with
from coscrew_codegen.program.ops import COMPARISONS, OF_TABLES
from coscrew_codegen.program.values.formats import BY_NAME, Precision

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
EACH = "ksl_each{f}({})"
"""A vector with this number for each state."""
_ON_LANES = {
    **_SPELLING, Op.ABS: ("ksl_abs%s({})", CALL), Op.SQRT: ("ksl_sqrt%s({})", CALL),
    Op.COPYSIGN: ("ksl_copysign%s({}, {})", CALL), Op.SELECT: ("ksl_choice%s({}, {}, {})", CALL),
    Op.LESS: ("ksl_less%s({}, {})", CALL), Op.EQUAL: ("ksl_equal%s({}, {})", CALL)}
_ON_DEVICE = {**_SPELLING, **{op: _ON_LANES[op] for op in (Op.ABS, Op.SQRT, Op.COPYSIGN)}}
_SUMS = frozenset({Op.ADD, Op.SUB, Op.EXACT_ADD, Op.EXACT_SUB, Op.PRODUCT_ERROR, Op.PRODUCT_REST})
_PRODUCTS = frozenset({Op.MUL, Op.SCALE})
_MUL = Op.MUL
_TWO = 2
_TRANSPARENT = frozenset({Op.NEG, Op.ABS, Op.SELECT})
"""Operations through which a sum still has a product as operand."""


def language(program: Program, precision: Precision) -> Language:
    """C in a precision, of this program."""
    precision = precision.computing(program.wide)
    rounded = frozenset() if precision.device else summed_products(program)
    spellings, each = _spellings(precision), EACH.format("{}", f=precision.called)

    def spelling(step: Instruction) -> tuple[str, int]:
        if step.name in rounded:
            return _ROUNDED
        if step.op not in spellings:
            return (c_tables.spelled(step, precision), CALL) if step.op in OF_TABLES \
                else spelled(step, precision)
        pattern, binding = spellings[step.op]
        if precision.lanes and (binding == CALL or not any(map(_varies, step.operands))):
            pattern = pattern.format(*("{}" if _varies(x) else each for x in step.operands))
        elif precision.device and step.op is Op.SELECT and not any(map(_varies, step.operands[1:])):
            pattern = f"{{}} ? {precision.c_type}({{}}) : {{}}"
        return pattern, binding

    def constant(x: Constant) -> str:
        return precision.literal(x) + precision.suffix

    return Language(spelling, constant, f"({BY_NAME[precision.name].c_type})NAN", "", "{arguments}")


@cache
def _spellings(precision: Precision) -> Mapping[Op, tuple[str, int]]:
    """Patterns of operations on the precision's values, and their precedences."""
    patterns = _ON_LANES if precision.lanes else _ON_DEVICE if precision.device else _SPELLING
    return {op: (pattern.replace("%s", precision.called), binding)
            for op, (pattern, binding) in patterns.items()}


def spelled(step: Instruction, precision: Precision) -> tuple[str, int]:
    """A pattern of the operation on numbers, and its precedence."""
    pattern, binding = _SPELLING.get(step.op) or (chunk_of_two_over_pi(step), CALL)
    return pattern.replace("%s", precision.called).replace("{f}", precision.called), binding


def _varies(x: Operand) -> bool:
    """Returns whether it differs from state to state."""
    return isinstance(x, (Input, Ref))


@kept_with
def summed_products(program: Program) -> frozenset[str]:
    """The products that a compiler could fuse into a sum of the program, or of a caller that uses
    its results.  A product with 2 counts as a sum, since compilers replace it by one."""
    seen = {x.name for x in program.results if isinstance(x, Ref)}
    products = []
    for step in reversed(program.instructions):
        name, op, operands, _ = step
        if op in _PRODUCTS and name in seen:
            products.append(name)
        if op in _SUMS or op in _TRANSPARENT and name in seen or \
                op is _MUL and any(map(_is_two, operands)):
            seen.update([x.name for x in operands if isinstance(x, Ref)])
    return frozenset(products)


def _is_two(x: Operand) -> bool:
    return isinstance(x, Constant) and abs(x.double) == _TWO


def declarations(assigned: Sequence[Assignment | Together | str], precision: Precision, width: int,
                 quantity: Callable[[str], str] = lambda component: component) -> Iterator[str]:
    """Declarations and headings; declarations of the same component are one statement, and those of
    components of the same `quantity` that have one each."""
    several = Counter(x.step.component for x in assigned if isinstance(x, Assignment))

    def kind(x: Assignment | Together | str) -> tuple[str, str]:
        if isinstance(x, str):
            return "", f"/* {x} */"
        if isinstance(x, Together):
            return "", x.statements(precision, width)
        if x.cosine:
            return "", sine_and_cosine(x.step, x.cosine, x.expression, precision)
        return _c_type(x.step, precision), (
            x.step.component if several[x.step.component] > 1 else quantity(x.step.component))

    for (c_type, words), group in groupby(assigned, kind):
        if not c_type:
            yield words
        else:
            items = [f"{x.step.name} = {x.expression}" for x in group if isinstance(x, Assignment)]
            yield _declared(f"const {c_type} ", items, width)


def _c_type(step: Instruction, precision: Precision) -> str:
    """The type of an instruction's result."""
    if step.op in COMPARISONS:
        return f"ksl_tests{precision.suffix}" if precision.lanes else "int"
    if step.component == CONSTANTS and not precision.device:
        return BY_NAME[precision.name].c_type
    return precision.c_type


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
