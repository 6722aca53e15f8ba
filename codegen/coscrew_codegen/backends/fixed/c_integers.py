"""Programs of integers as C: bodies of functions on int32_t.

Products of 64 bits are used once, so they are nested and never declared.  Shifts to the left are
products with powers of two, which C defines for negative numbers, too."""

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace

from coscrew_codegen.backends.c.c_nested import EACH, declarations
from coscrew_codegen.backends.c.c_statements import OF_INTEGERS, WIDTH
from coscrew_codegen.backends.nesting import (
    CALL,
    PRODUCT,
    SIGN,
    SUM,
    Language,
    Nesting,
    numbered,
)
from coscrew_codegen.program import Constant, Input, Instruction, Op, Program, Ref
from coscrew_codegen.program.roundoff import CIRCULAR
from coscrew_codegen.program.values.formats import Precision

_SPELLING = {Op.ADD: ("{} + {}", SUM), Op.SUB: ("{} - {}", SUM), Op.NEG: ("-{}", SIGN),
             Op.MUL: ("{} * {}", PRODUCT),
             **{op: (pattern, CALL) for op, pattern in OF_INTEGERS.items()}}
_WIDE_LANES = {Op.ADD: "ksl_wide_sum_lanes({}, {})", Op.SUB: "ksl_wide_difference_lanes({}, {})",
               Op.WIDE_PRODUCT: "ksl_wide_product_lanes({}, {}"}


@dataclass(frozen=True)
class _Integers(Precision):
    """32-bit integers as the numbers of declarations."""

    @property
    def called(self) -> str:
        return f"{self.lanes}_fixed"


INTEGERS = _Integers(31, 0, "fixed", "int32_t", "", "int32", 4)
"""The type of values, and the ending of the names of functions on them."""
IN_LANES = replace(INTEGERS, c_type="ksl_states_fixed", lanes="_lanes")
"""Integers of several states in one vector."""


def body(program: Program, access: Callable[[Input], str], targets: Sequence[str],
         headings: Mapping[int, str], width: int, integers: Precision = INTEGERS) -> str:
    """The lines of a body: declarations at most `width` wide, then the stores, indented."""
    wide = wide_steps(program)
    spelled = lanes_language(wide) if integers.lanes else language(wide)
    nesting = nested(program, spelled, access, headings, width)
    results = [_each(x) if integers.lanes and isinstance(of, Constant) else x
               for x, of in zip(nesting.results, program.results, strict=True)]
    rows = [*_unused(program), *declarations(nesting.assigned, integers, WIDTH - 2),
            *_stores(program, access, targets, results, integers)]
    return "\n".join(f"  {line}" for row in rows for line in row.split("\n"))


def nested(program: Program, language: Language, access: Callable[[Input], str],
           headings: Mapping[int, str], width: int) -> Nesting:
    """The program's text in a language of integers."""
    wide = wide_steps(program)
    return Nesting(program, language, access, width, headings,
                   lambda step: step.name not in wide and not numbered(step.name),
                   inlined=lambda step: step.name in wide)


def wide_steps(program: Program) -> frozenset[str]:
    """The names of the values that have 64 bits."""
    wide: set[str] = set()
    for step in program.instructions:
        if step.op is Op.WIDE_PRODUCT or step.op is not Op.ROUNDED_SHIFT and any(
                isinstance(x, Ref) and x.name in wide for x in step.operands):
            wide.add(step.name)
    return frozenset(wide)


def language(wide: frozenset[str]) -> Language:
    """C of integers, for a program whose values of these names have 64 bits."""
    def spelling(step: Instruction) -> tuple[str, int]:
        if step.op is Op.WIDE_PRODUCT:
            return aligned(step, OF_INTEGERS[Op.WIDE_PRODUCT])
        if narrows(step, wide):
            return ("ksl_narrow({}, {})" if integer(step.operands[1]) else "(int32_t)({})"), CALL
        if step.op in CIRCULAR:
            return f"ksl_{step.op.value}{INTEGERS.called}({{}}, {{}})", CALL
        return _SPELLING[step.op]

    return Language(spelling, lambda x: str(integer(x)), "", "", "{arguments}")


def narrows(step: Instruction, wide: frozenset[str]) -> bool:
    """Returns whether the instruction shifts a value of 64 bits to one of 32."""
    of = step.operands[0]
    return step.op is Op.ROUNDED_SHIFT and isinstance(of, Ref) and of.name in wide


def lanes_language(wide: frozenset[str]) -> Language:
    """C of vectors of integers; a value of 64 bits is a pair of them, which has no operators."""
    def spelling(step: Instruction) -> tuple[str, int]:
        if step.op is Op.ROUNDED_SHIFT:
            name = "narrowed" if narrows(step, wide) else "rounded_shift"
            return f"ksl_{name}_lanes({{}}, {integer(step.operands[1])})", CALL
        if step.op in CIRCULAR:
            return f"ksl_{step.op.value}{IN_LANES.called}({{}}, {integer(step.operands[1])})", CALL
        if step.op is Op.WIDE_PRODUCT:
            pattern, binding = f"{_WIDE_LANES[step.op]}, {integer(step.operands[2])})", CALL
        elif step.name in wide:
            return _WIDE_LANES[step.op], CALL
        else:
            pattern, binding = _SPELLING[step.op]
            pattern = pattern.replace("product(", "product_lanes(")
        if binding == CALL:
            pattern = pattern.format(*(_each("{}") if isinstance(x, Constant) else "{}"
                                       for x in step.operands[:2]))
        return pattern, binding

    return replace(language(wide), spelling=spelling)


def _each(x: str) -> str:
    """A vector with this integer for each state."""
    return EACH.format(x, f=IN_LANES.called)


def aligned(step: Instruction, text: str, long: str = "INT64_C({})") -> tuple[str, int]:
    """The pattern of a product of 64 bits, spelled so, times a power of two."""
    shift = integer(step.operands[2])
    if shift < 0:
        return f"({text} >> {-shift})", CALL
    factor = 2**shift if shift <= 30 else long.format(2**shift)
    return (f"{text} * {factor}", PRODUCT) if shift else (text, CALL)


def integer(x: object) -> int:
    """The integer that is an operand."""
    assert isinstance(x, Constant)
    return int(x.double)


def _unused(program: Program) -> Iterator[str]:
    used = {x.argument for x in program.used_inputs()}
    return (f"(void){a.name};" for n, a in enumerate(program.inputs) if n not in used)


def _stores(program: Program, access: Callable[[Input], str], targets: Sequence[str],
            results: Sequence[str], integers: Precision) -> Iterator[str]:
    """The stores, after all inputs that are results have been read: outputs may overlap inputs."""
    texts = list(results)
    for n, x in enumerate(program.results):
        if isinstance(x, Input):
            texts[n] = f"kept_{n}"
            yield f"const {integers.c_type} kept_{n} = {access(x)};"
    yield from (f"{target} = {text};" for target, text in zip(targets, texts, strict=True))
