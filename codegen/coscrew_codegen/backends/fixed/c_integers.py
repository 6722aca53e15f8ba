"""Programs of integers as C: bodies of functions on int32_t.

Products of 64 bits are used once, so they are nested and never declared.  Shifts to the left are
products with powers of two, which C defines for negative numbers, too."""

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass

from coscrew_codegen.backends.c.c_nested import declarations
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
from coscrew_codegen.program.values.formats import Precision

_SPELLING = {Op.ADD: ("{} + {}", SUM), Op.SUB: ("{} - {}", SUM), Op.NEG: ("-{}", SIGN),
             Op.MUL: ("{} * {}", PRODUCT),
             **{op: (pattern, CALL) for op, pattern in OF_INTEGERS.items()}}


@dataclass(frozen=True)
class _Integers(Precision):
    """32-bit integers as the numbers of declarations."""

    @property
    def called(self) -> str:
        return "_fixed"


INTEGERS = _Integers(31, 0, "fixed", "int32_t", "", "int32", 4)
"""The type of values, and the ending of the names of functions on them."""


def body(program: Program, access: Callable[[Input], str], targets: Sequence[str],
         headings: Mapping[int, str], width: int) -> str:
    """The lines of a body: declarations at most `width` wide, then the stores, indented."""
    nesting = nested(program, language(wide_steps(program)), access, headings, width)
    rows = [*_unused(program), *declarations(nesting.assigned, INTEGERS, WIDTH - 2),
            *_stores(program, access, targets, nesting.results)]
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
        if step.op is Op.ROUNDED_SHIFT and isinstance(step.operands[0], Ref) \
                and step.operands[0].name in wide:
            return ("ksl_narrow({}, {})" if integer(step.operands[1]) else "(int32_t)({})"), CALL
        if step.op in (Op.SIN, Op.COS):
            return f"ksl_{step.op.value}_fixed({{}}, {{}})", CALL
        return _SPELLING[step.op]

    return Language(spelling, lambda x: str(integer(x)), "", "", "{arguments}")


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
            results: Sequence[str]) -> Iterator[str]:
    """The stores, after all inputs that are results have been read: outputs may overlap inputs."""
    texts = list(results)
    for n, x in enumerate(program.results):
        if isinstance(x, Input):
            texts[n] = f"kept_{n}"
            yield f"const int32_t kept_{n} = {access(x)};"
    yield from (f"{target} = {text};" for target, text in zip(targets, texts, strict=True))
