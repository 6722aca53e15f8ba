"""Bounds of operations on rotations: infinite where a matrix is no rotation.

Such an operation's formula is one of many for the same function of rotations, and is meaningless
for other matrices.  A polynomial's formula, in contrast, is its definition, also for reflections.
"""

from dataclasses import replace
from fractions import Fraction

from coscrew_codegen.program import (
    ZERO,
    Constant,
    Input,
    Instruction,
    Op,
    Operand,
    Program,
    Ref,
    constant,
)
from coscrew_codegen.program.values.quantity import DISPLACEMENT, ROTATION, TOLERANCE

_WITHIN = constant(TOLERANCE)
_LARGE = Constant(Fraction(2)**1000, Fraction(2)**100)
"""A number whose square overflows."""
ROTATIONS = (ROTATION, DISPLACEMENT)
"""The domains of arguments with a rotation."""
DEFECT = "mat3x3_rotation_defect"
"""The operation that says whether a matrix is a rotation."""


def infinite_unless_rotations(program: Program, plain: Program) -> Program:
    """The program with bounds that are infinite where a matrix that is to be a rotation has a
    larger mat3x3_rotation_defect than TOLERANCE, or one that is NaN; `plain` has the outputs
    without bounds."""
    steps, count = list(program.instructions), len(plain.results)
    bounds = program.results[count:]
    for number, a in enumerate(program.inputs):
        if a.domain in ROTATIONS:
            added, excess = _excess(number, a.name, a.quantity.shape[1])
            sums = [_step(f"{excess.name}_{k}", Op.ADD, bound, excess)
                    for k, bound in enumerate(bounds)]
            steps += [*added, *sums]
            bounds = tuple(Ref(step.name) for step in sums)
    return replace(program, instructions=tuple(steps),
                   results=(*program.results[:count], *bounds))


def _step(name: str, op: Op, *operands: Operand) -> Instruction:
    return Instruction(name, op, operands, name)


def _excess(number: int, name: str, columns: int) -> tuple[list[Instruction], Ref]:
    """0 for a rotation, else infinite: where the defect is NaN, it is neither less than TOLERANCE
    nor equal.  The defect is that of the first three columns, by the operation's own instructions.
    """
    def moved(x: Operand) -> Operand:
        if isinstance(x, Input):
            row, column = divmod(x.index, 3)
            return Input(number, columns * row + column)
        return Ref(f"{name}_{x.name}") if isinstance(x, Ref) else x

    from coscrew_codegen.algebra.lowering.programs import library_program  # imports SymPy

    program = library_program(DEFECT)
    steps = [Instruction(f"{name}_{step.name}", step.op, tuple(map(moved, step.operands)),
                         f"{name}_{step.component}") for step in program.instructions]
    defect = moved(program.results[0])
    less, same, others, chosen, excess = (Ref(f"{name}_{word}") for word in (
        "is_less", "is_equal", "unless_equal", "unless_rotation", "excess"))
    return [*steps, _step(less.name, Op.LESS, defect, _WITHIN),
            _step(same.name, Op.EQUAL, defect, _WITHIN),
            _step(others.name, Op.SELECT, same, ZERO, _LARGE),
            _step(chosen.name, Op.SELECT, less, ZERO, others),
            _step(excess.name, Op.MUL, chosen, _LARGE)], excess
