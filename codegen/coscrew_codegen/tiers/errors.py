"""The errors of a plain program's values, computed beside them: each value's d ~ true - plain.

This is the accurate tier's compensated program, except that hi stays the plain value, bit for bit:
nothing is normalized, and comparisons are those of the plain program.  Constants are the model's
decimals, hi + lo in the given precision.
"""

from fractions import Fraction

from coscrew_codegen.formats import Precision
from coscrew_codegen.program import Constant, Instruction, Op, Operand, Program
from coscrew_codegen.tiers.accurate_scene import OfScene


def constant(value: Fraction) -> Constant:
    """A number that is the same in both precisions."""
    return Constant(value, value)


ZERO, ONE = constant(Fraction(0)), constant(Fraction(1))


class Errors(OfScene):
    """Issues the plain instructions and d of each result; `low` returns it."""

    last = "bounds of the errors:"

    def __init__(self, program: Program, precision: Precision) -> None:
        super().__init__(program, precision)
        self.circular = {(step.op, step.operands): step for step in program.instructions
                         if step.op in (Op.SIN, Op.COS)}

    def compensate(self, step: Instruction) -> None:
        """Issue a plain instruction, unless it has been, and d of its result."""
        super(OfScene, self).compensate(step)

    def nearest(self, x: Constant) -> Constant:
        """The constant in this precision."""
        return constant(Fraction(float(self.precision.rounded(self.precision.value(x)))))

    def _normalized(self, step: Instruction, operand: Operand) -> Operand:
        """Itself: hi is the plain value."""
        return operand
