"""Bounds of operations on rotations: infinite where a matrix is no rotation.

Such an operation's formula is one of many for the same function of rotations, and means nothing for
other matrices; that of a polynomial is its definition, also for reflections.
"""

from collections.abc import Sequence
from dataclasses import replace
from fractions import Fraction

from coscrew_codegen.program import Constant, Input, Instruction, Op, Operand, Program, Ref
from coscrew_codegen.quantity import DISPLACEMENT, ROTATION, TOLERANCE
from coscrew_codegen.tiers.errors import constant

_ONE, _ZERO, _WITHIN = constant(Fraction(1)), constant(Fraction(0)), constant(TOLERANCE)
_LARGE = Constant(Fraction(2)**1000, Fraction(2)**100)
"""Its square overflows."""


def infinite_unless_rotations(program: Program, plain: Program) -> Program:
    """The program with bounds that are infinite where a matrix that is to be a rotation has a
    larger defect than TOLERANCE, or one that is NaN; `plain` has the outputs without bounds."""
    writer = _Writer()
    excesses = [writer.excess(number, a.name, a.quantity.shape[1])
                for number, a in enumerate(program.inputs)
                if a.domain in (ROTATION, DISPLACEMENT)]
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
        """0 for a rotation, else infinite.  The determinant comes first: it is NaN where any entry
        is, and stays so."""
        rows = [[Input(number, columns * i + j) for j in range(3)] for i in range(3)]
        largest = self._defect(f"{name}_det", self._determinant(f"{name}_det", rows), _ONE)
        for i, j in ((0, 0), (1, 1), (2, 2), (0, 1), (0, 2), (1, 2)):
            called = f"{name}_column_{i}{j}"
            product = self._dot(called, [(row[i], row[j]) for row in rows])
            size = self._defect(called, product, _ONE if i == j else _ZERO)
            more = self.issue(f"{called}_is_more", Op.LESS, largest, size)
            largest = self.issue(f"{called}_largest", Op.SELECT, more, size, largest)
        right = self.issue(f"{name}_is_rotation", Op.LESS, largest, _WITHIN)
        chosen = self.issue(f"{name}_unless_rotation", Op.SELECT, right, _ZERO, _LARGE)
        return self.issue(f"{name}_excess", Op.MUL, chosen, _LARGE)

    def _defect(self, name: str, x: Operand, wanted: Constant) -> Ref:
        """|x - wanted|."""
        return self.issue(f"{name}_size", Op.ABS, self.issue(f"{name}_off", Op.SUB, x, wanted))

    def _dot(self, name: str, pairs: Sequence[tuple[Operand, Operand]]) -> Ref:
        """The sum of the products."""
        first, *others = (self.issue(f"{name}_product_{n}", Op.MUL, *pair)
                          for n, pair in enumerate(pairs))
        for n, product in enumerate(others):
            first = self.issue(f"{name}_sum_{n}", Op.ADD, first, product)
        return first

    def _determinant(self, name: str, rows: Sequence[Sequence[Operand]]) -> Ref:
        """By cofactors of the first row."""
        cofactors = []
        for j in range(3):
            k, m = (j + 1) % 3, (j + 2) % 3
            above = self.issue(f"{name}_above_{j}", Op.MUL, rows[1][k], rows[2][m])
            below = self.issue(f"{name}_below_{j}", Op.MUL, rows[1][m], rows[2][k])
            cofactors.append(self.issue(f"{name}_cofactor_{j}", Op.SUB, above, below))
        return self._dot(name, list(zip(rows[0], cofactors, strict=True)))
