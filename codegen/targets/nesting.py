"""The nesting printer: writes a Program as assignments; instructions used once are nested.

For languages that round every operation of an expression once; parentheses keep the Program's
order.  Takes time proportional to the Program's length.
"""

from collections import Counter
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field

from coscrew_codegen.program import (
    Constant,
    Input,
    Instruction,
    NotANumber,
    Op,
    Operand,
    Program,
    Ref,
)

CALLS = 4
"""The precedence of a function call."""


@dataclass(frozen=True)
class Language:
    """How a language writes instructions: a pattern and its precedence for each operation; a
    constant; a choice between constants, which may need a type; NaN; a comment."""

    spelling: Mapping[Op, tuple[str, int]]
    constant: Callable[[Constant], str]
    choice_of_constants: str
    not_a_number: str
    comment: str


@dataclass
class Nesting:
    """The text of a Program.

    `access` returns the expression that reads an input; `named` says which instructions are
    assigned even if they are used once; a line is at most `width` wide."""

    program: Program
    language: Language
    access: Callable[[Input], str]
    width: int
    headings: Mapping[int, str] = field(default_factory=dict)
    named: Callable[[Instruction], bool] = lambda step: False
    result_width: int = 0  # longest result that is not assigned to a name

    def __post_init__(self) -> None:
        self.lines: list[str] = []  # assignments and comments
        self._waiting: dict[str, tuple[str, int]] = {}  # name → expression, its precedence
        self._uses = Counter(x.name for x in self._operands() if isinstance(x, Ref))
        for number, step in enumerate(self.program.instructions):
            if number in self.headings:
                self._heading(self.headings[number])
            self._take(step)
        self.results = [self._result(x) for x in self.program.results]

    def _operands(self) -> Iterator[Operand]:
        for step in self.program.instructions:
            yield from step.operands
        yield from self.program.results

    def _take(self, step: Instruction) -> None:
        """Keep the instruction's expression for its only use, or assign it.  Operands are nested
        while the line is short enough; the longest are assigned first."""
        inner = [x.name for x in step.operands
                 if isinstance(x, Ref) and x.name in self._waiting]
        expression = self._expression(step)
        while inner and len(step.name) + len(" = ") + len(expression[0]) > self.width:
            longest = max(inner, key=lambda name: len(self._waiting[name][0]))
            inner.remove(longest)
            self._assign(longest, self._waiting.pop(longest)[0])
            expression = self._expression(step)
        for name in inner:
            del self._waiting[name]
        if self._uses[step.name] == 1 and not self.named(step):
            self._waiting[step.name] = expression
        else:
            self._assign(step.name, expression[0])

    def _heading(self, words: str) -> None:
        """A comment; it replaces one with nothing below it."""
        if self.lines and self.lines[-1].startswith(self.language.comment):
            self.lines.pop()
        self.lines.append(f"{self.language.comment}{words}")

    def _assign(self, name: str, expression: str) -> None:
        self.lines.append(f"{name} = {expression}")

    def _result(self, operand: Operand) -> str:
        if isinstance(operand, Ref) and operand.name in self._waiting:
            text, _ = self._waiting.pop(operand.name)
            if len(text) <= self.result_width:
                return text
            self._assign(operand.name, text)
        return self._operand(operand, 0)

    def _expression(self, step: Instruction) -> tuple[str, int]:
        spelling, binding = self.language.spelling[step.op]
        if is_choice_of_constants(step):
            spelling = self.language.choice_of_constants
        needed: Sequence[int] = [0] * 4 if binding == CALLS else [binding, binding + 1]
        operands = [self._operand(x, n) for x, n in zip(step.operands, needed, strict=False)]
        return spelling.format(*operands), binding

    def _operand(self, operand: Operand, needed: int) -> str:
        """The operand's text, in parentheses if its precedence is below `needed`."""
        if isinstance(operand, Input):
            return self.access(operand)
        if isinstance(operand, Constant):
            return self.language.constant(operand)
        if isinstance(operand, NotANumber):
            return self.language.not_a_number
        text, binding = self._waiting.get(operand.name, (operand.name, CALLS))
        return text if binding >= needed else f"({text})"


def is_choice_of_constants(step: Instruction) -> bool:
    """Whether this is a choice between constants, which have no type of their own."""
    return step.op is Op.SELECT and all(isinstance(x, Constant) for x in step.operands[1:])
