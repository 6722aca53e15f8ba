"""The errors of a plain program's values, computed beside them: each value's d ~ true - plain.

This is the accurate tier's compensated program, except that hi stays the plain value, bit for bit:
nothing is normalized, and comparisons are those of the plain program.  Constants are the model's
decimals, hi + lo in the given precision; elementary functions contribute what they err by.
"""

from collections.abc import Callable
from fractions import Fraction

from coscrew_codegen.formats import Precision
from coscrew_codegen.program import Constant, Instruction, Op, Operand, Program, Ref
from coscrew_codegen.program.ops import ERROR_OF
from coscrew_codegen.tiers.accurate import OfScene


def constant(value: Fraction) -> Constant:
    """A number that is the same in both precisions."""
    return Constant(value, value)


ZERO, ONE = constant(Fraction(0)), constant(Fraction(1))


class Errors(OfScene):
    """Issues the plain instructions and d of each result; `low` returns it."""

    last = "bounds of the errors:"

    def __init__(self, program: Program, precision: Precision) -> None:
        super().__init__(program)
        self.precision = precision
        self._functions = {(step.op, step.operands): Ref(step.name)
                           for step in program.instructions if step.op in ERROR_OF}
        self._computed: set[str] = set()  # plain values, some earlier than in the plain program
        self._rules |= {Op.SIN: self._sine, Op.COS: self._cosine, Op.TANH: self._tangent,
                        Op.EXP: self._exponential}

    def compensate(self, step: Instruction) -> None:
        """Issue a plain instruction, unless it has been, and d of its result."""
        if step.op not in self._rules:
            super(OfScene, self).compensate(step)
            return
        low = [self.low(step, x) for x in step.operands]
        if step.name not in self._computed:
            self.steps.append(step)
            self._computed.add(step.name)
        total = self._rules[step.op](step, low)
        if total is not None:
            self._low[step.name] = total

    def nearest(self, x: Constant) -> Constant:
        """The constant in this precision."""
        return constant(Fraction(float(self.precision.rounded(self.precision.value(x)))))

    def _known(self, x: Operand) -> Operand | None:
        if not isinstance(x, Constant):
            return super()._known(x)
        rest = self.nearest(constant(self.precision.value(x) - self.nearest(x).double))
        return rest if rest.double else None

    def _normalized(self, step: Instruction, operand: Operand) -> Operand:
        """Itself: hi is the plain value."""
        return operand

    def _sine(self, step: Instruction, low: list[Operand | None]) -> Operand:
        return self._function(step, low, lambda: self._other(step, Op.COS))

    def _cosine(self, step: Instruction, low: list[Operand | None]) -> Operand:
        return self._function(step, low, lambda: self.issue(
            step, Op.NEG, (self._other(step, Op.SIN),), "slope"))

    def _exponential(self, step: Instruction, low: list[Operand | None]) -> Operand:
        return self._function(step, low, lambda: Ref(step.name))

    def _tangent(self, step: Instruction, low: list[Operand | None]) -> Operand:
        def slope() -> Ref:
            square = self.issue(step, Op.MUL, (Ref(step.name), Ref(step.name)), "square")
            return self.issue(step, Op.SUB, (ONE, square), "slope")

        return self._function(step, low, slope)

    def _function(self, step: Instruction, low: list[Operand | None],
                  slope: Callable[[], Operand]) -> Operand:
        """d of y = f(x): f(x) - y, and the slope times d of x."""
        (x,), (x_low,) = step.operands, low
        error = self.issue(step, ERROR_OF[step.op], (x, Ref(step.name)), "error")
        if x_low is None:
            return error
        moved = self.issue(step, Op.MUL, (slope(), x_low), "moved")
        return self.issue(step, Op.ADD, (error, moved), "lo")

    def _other(self, step: Instruction, op: Op) -> Ref:
        """The plain value of another function of the same operand."""
        at = (op, step.operands)
        if at not in self._functions:
            self._functions[at] = self.issue(step, *at, "other")
        elif self._functions[at].name not in self._computed:
            name = self._functions[at].name
            self.steps.append(Instruction(name, *at, step.component))
            self._computed.add(name)
        return self._functions[at]
