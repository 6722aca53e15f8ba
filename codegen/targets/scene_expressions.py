"""A Program's instructions as Python assignments, each nested where it is used once.

NumPy rounds every operation once and contracts nothing, so that nesting changes no bit; parentheses
keep the Program's order.  Takes time in proportion to the Program's length.
"""

from collections import Counter

from coscrew_codegen.formats import Precision
from coscrew_codegen.program import Constant, Input, Instruction, NotANumber, Operand, Ref
from coscrew_codegen.scene_functions import Function
from coscrew_codegen.targets import scene_text
from coscrew_codegen.targets.c_statements import WIDTH
from coscrew_codegen.targets.numpy import CALLS, SPELLING, is_choice_of_constants

_LINE = WIDTH - 4
_RESULT = 40  # characters of a result that is no line of its own


class Expressions:
    """`lines`: assignments and comments; `results`: an expression for each result."""

    def __init__(self, function: Function, precision: Precision):
        self.program, self.precision = function.program, precision
        self.lines: list[str] = []
        self._waiting: dict[str, tuple[str, int]] = {}  # name → expression, how tightly it binds
        operands = [x for step in self.program.instructions for x in step.operands]
        uses = Counter(x.name for x in (*operands, *self.program.results) if isinstance(x, Ref))
        headings = dict(function.headings)
        for number, step in enumerate(self.program.instructions):
            if number in headings:
                self._heading(headings[number])
            self._take(step, uses[step.name] == 1)
        self.results = [self._result(x) for x in self.program.results]

    def _take(self, step: Instruction, once: bool) -> None:
        """Keep the step's expression if it is used once, else assign it; operands nest while the
        line is short enough, the longest get lines of their own first."""
        inner = [x.name for x in step.operands
                 if isinstance(x, Ref) and x.name in self._waiting]
        expression = self._expression(step)
        while inner and len(step.name) + 3 + len(expression[0]) > _LINE:
            longest = max(inner, key=lambda name: len(self._waiting[name][0]))
            inner.remove(longest)
            self._assign(longest, self._waiting.pop(longest)[0])
            expression = self._expression(step)
        for name in inner:
            del self._waiting[name]
        if once:
            self._waiting[step.name] = expression
        else:
            self._assign(step.name, expression[0])

    def _heading(self, words: str) -> None:
        """A comment, in place of one that nothing stands under."""
        if self.lines and self.lines[-1].startswith("#"):
            self.lines.pop()
        self.lines.append(f"# {scene_text.printable(words)}")

    def _assign(self, name: str, expression: str) -> None:
        self.lines.append(f"{name} = {expression}")

    def _result(self, operand: Operand) -> str:
        if isinstance(operand, Ref) and operand.name in self._waiting:
            text, _ = self._waiting.pop(operand.name)
            if len(text) <= _RESULT:
                return text
            self._assign(operand.name, text)
        return self._operand(operand, 0)

    def _expression(self, step: Instruction) -> tuple[str, int]:
        spelling, binding = SPELLING[step.op]
        if is_choice_of_constants(step):
            test, *values = (self._operand(x, 0) for x in step.operands)
            kind = self.precision.numpy_type
            return spelling.format(test, *(f"{kind}({x})" for x in values)), binding
        needed = [0] * 4 if binding == CALLS else [binding, binding + 1]
        operands = [self._operand(x, n) for x, n in zip(step.operands, needed, strict=False)]
        return spelling.format(*operands), binding

    def _operand(self, operand: Operand, needed: int) -> str:
        """The operand's text, in parentheses where it binds less tightly than needed."""
        if isinstance(operand, Input):
            argument = self.program.inputs[operand.argument]
            return f"{argument.name}[{operand.index}]" if argument.quantity.shape else argument.name
        if isinstance(operand, Constant):
            return self.precision.literal(operand)
        if isinstance(operand, NotANumber):
            return "nan"
        text, binding = self._waiting.get(operand.name, (operand.name, CALLS))
        return text if binding >= needed else f"({text})"
