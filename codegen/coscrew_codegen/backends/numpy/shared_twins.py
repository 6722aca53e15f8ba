"""Kernels of single precision that share the text of double: with constants of their own.

The text is shared where both Programs are the same except for constants.  A constant is a
literal if NumPy rounds the literal of double to that of single precision, else a parameter with a
default.
"""

from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass, replace
from fractions import Fraction

from coscrew_codegen.program import Constant, Instruction, Operand, Program
from coscrew_codegen.program.values.formats import DOUBLE, SINGLE, Precision


@dataclass(frozen=True)
class SharedProgram:
    """A Program with the constants of both precisions, and the names of those that are parameters.
    """

    program: Program
    names: Mapping[Constant, str]

    def parameters(self, literal: Callable[[Constant], str]) -> list[str]:
        """`name=literal` for each parameter."""
        return [f"{name}={literal(x)}" for x, name in self.names.items()]


def shared(double: Program, single: Program) -> SharedProgram | None:
    """The Program that is both of these, None if they differ in more than constants."""
    if double.wide or single.wide or len(double.instructions) != len(single.instructions):
        return None
    steps = [_both(a, b) for a, b in zip(double.instructions, single.instructions, strict=True)]
    results = [_operand(a, b) for a, b in zip(double.results, single.results, strict=True)]
    if not all((*steps, *results)):
        return None
    program = replace(double, instructions=tuple(filter(None, steps)),
                      results=tuple(filter(None, results)))
    return SharedProgram(program, _names(program))


def _both(a: Instruction, b: Instruction) -> Instruction | None:
    operands = [_operand(x, y) for x, y in zip(a.operands, b.operands, strict=False)]
    same = a._replace(operands=()) == b._replace(operands=())
    if not same or len(a.operands) != len(b.operands) or not all(operands):
        return None
    return a._replace(operands=tuple(filter(None, operands)))


def _operand(a: Operand, b: Operand) -> Operand | None:
    if isinstance(a, Constant) and isinstance(b, Constant):
        return Constant(a.double, b.single)
    return a if a == b else None


def _names(program: Program) -> dict[Constant, str]:
    taken = {*(step.name for step in program.instructions), *(
        name for a in program.inputs for name in (a.name, *(str(x) for x in a.symbols)))}
    free = (name for name in map("c{}".format, range(1, 10**6)) if name not in taken)
    return {x: next(free) for x in dict.fromkeys(_constants(program)) if not _rounds(x)}


def _constants(program: Program) -> Iterator[Constant]:
    for step in program.instructions:
        yield from (x for x in step.operands if isinstance(x, Constant))
    yield from (x for x in program.results if isinstance(x, Constant))


def _rounds(x: Constant) -> bool:
    """True if the number of double, rounded to single precision, is the number of single."""
    if x.double == x.single and x.double.denominator == 1:
        return True
    if abs(x.double) > SINGLE.limit("max"):
        return False
    return _rounded(_rounded(x.double, DOUBLE), SINGLE) == _rounded(x.single, SINGLE)


def _rounded(value: Fraction, precision: Precision) -> Fraction:
    return Fraction(float(precision.rounded(value)))
