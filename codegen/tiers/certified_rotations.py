"""Bounds of operations on rotations: infinite where a matrix is no rotation.

Such an operation's formula is one of many for the same function of rotations, and means nothing for
other matrices; that of a polynomial is its definition, also for reflections.
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
from coscrew_codegen.quantity import DISPLACEMENT, ROTATION, TOLERANCE

_WITHIN = constant(TOLERANCE)
_LARGE = Constant(Fraction(2)**1000, Fraction(2)**100)
"""Its square overflows."""
ROTATIONS = (ROTATION, DISPLACEMENT)
"""The domains of arguments with a rotation."""
DEFECT = "mat3x3_rotation_defect"
"""The operation that tells whether it is one."""


def infinite_unless_rotations(program: Program, plain: Program) -> Program:
    """The program with bounds that are infinite where a matrix that is to be a rotation has a
    larger mat3x3_rotation_defect than TOLERANCE, or one that is NaN; `plain` has the outputs
    without bounds."""
    writer = _Writer()
    excesses = [writer.excess(number, a.name, a.quantity.shape[1])
                for number, a in enumerate(program.inputs)
                if a.domain in ROTATIONS]
    count = len(plain.results)
    bounds = list(program.results[count:])
    for excess in excesses:
        bounds = [writer.issue(f"{excess.name}_{k}", Op.ADD, bound, excess)
                  for k, bound in enumerate(bounds)]
    return replace(program, instructions=(*program.instructions, *writer.steps),
                   results=(*program.results[:count], *bounds))


class _Writer:
    """Issues instructions."""

    def __init__(self) -> None:
        self.steps: list[Instruction] = []

    def issue(self, name: str, op: Op, *operands: Operand) -> Ref:
        self.steps.append(Instruction(name, op, operands, name))
        return Ref(name)

    def excess(self, number: int, name: str, columns: int) -> Ref:
        """0 for a rotation, else infinite: where the defect is NaN, it is neither less than
        TOLERANCE nor equal."""
        defect = self._defect(number, name, columns)
        less = self.issue(f"{name}_is_less", Op.LESS, defect, _WITHIN)
        same = self.issue(f"{name}_is_equal", Op.EQUAL, defect, _WITHIN)
        others = self.issue(f"{name}_unless_equal", Op.SELECT, same, ZERO, _LARGE)
        chosen = self.issue(f"{name}_unless_rotation", Op.SELECT, less, ZERO, others)
        return self.issue(f"{name}_excess", Op.MUL, chosen, _LARGE)

    def _defect(self, number: int, name: str, columns: int) -> Operand:
        """mat3x3_rotation_defect of the first three columns, by the operation's own instructions.
        """
        def moved(x: Operand) -> Operand:
            if isinstance(x, Input):
                row, column = divmod(x.index, 3)
                return Input(number, columns * row + column)
            return Ref(f"{name}_{x.name}") if isinstance(x, Ref) else x

        from coscrew_codegen.programs import library_program  # imports SymPy

        program = library_program(DEFECT)
        self.steps += [Instruction(f"{name}_{step.name}", step.op, tuple(map(moved, step.operands)),
                                   f"{name}_{step.component}") for step in program.instructions]
        return moved(program.results[0])
