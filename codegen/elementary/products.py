"""Errors of products in steps that every language has."""

from collections.abc import Iterator
from dataclasses import replace
from fractions import Fraction

from coscrew_codegen.formats import Format
from coscrew_codegen.program import Constant, Instruction, Op, Operand, Program, Ref


def with_split_products(program: Program, form: Format) -> Program:
    """The Program with errors of products computed from halves of the factors.

    Exact as long as neither a factor times 2^(half the digits) overflows nor a product of lower
    halves underflows.  Source: T. J. Dekker, Numer. Math. 18 (1971) 224."""
    steps = (x for step in program.instructions for x in (
        _split(step, form) if step.op is Op.PRODUCT_ERROR else (step,)))
    return replace(program, instructions=tuple(steps))


def _split(step: Instruction, form: Format) -> Iterator[Instruction]:
    """The steps towards a b - p."""
    a, b, p = step.operands
    value = Fraction(2)**(-(-form.digits // 2)) + 1
    splitter = Constant(value, value)

    def do(suffix: str, op: Op, *operands: Operand) -> tuple[Instruction, Ref]:
        name = f"{step.name}_{suffix}" if suffix else step.name
        return Instruction(name, op, operands, step.component), Ref(name)

    def halves(x: Operand, name: str) -> Iterator[tuple[Instruction, Ref]]:
        yield (wide := do(f"wide_{name}", Op.MUL, splitter, x))
        yield (more := do(f"more_{name}", Op.SUB, wide[1], x))
        yield (high := do(f"high_{name}", Op.SUB, wide[1], more[1]))
        yield do(f"low_{name}", Op.SUB, x, high[1])

    of_a, of_b = list(halves(a, "a")), list(halves(b, "b"))
    yield from (instruction for instruction, _ in (*of_a, *of_b))
    (high_a, low_a), (high_b, low_b) = ((of[2][1], of[3][1]) for of in (of_a, of_b))
    first, product = do("product1", Op.MUL, high_a, high_b)
    yield first
    instruction, rest = do("rest1", Op.SUB, product, p)
    yield instruction
    pairs = ((high_a, low_b), (low_a, high_b), (low_a, low_b))
    for number, factors in enumerate(pairs, 2):
        instruction, product = do(f"product{number}", Op.MUL, *factors)
        yield instruction
        instruction, rest = do("" if number == 4 else f"rest{number}", Op.ADD, rest, product)
        yield instruction
