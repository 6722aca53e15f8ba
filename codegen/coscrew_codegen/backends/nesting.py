"""The nesting printer: writes a Program as assignments; instructions used once are nested.

For languages that round every operation of an expression once; parentheses keep the Program's
order.  Takes time proportional to the Program's length.
"""

import re
from collections import Counter
from collections.abc import Callable, Collection, Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from functools import cache

from coscrew_codegen.program import (
    Constant,
    Input,
    Instruction,
    NotANumber,
    Op,
    Operand,
    Program,
    Ref,
    operands_of_pair,
    renamed,
    sine_cosine_pairs,
)
from coscrew_codegen.program.elementary.elementary_calls import FUNCTION_OF
from coscrew_codegen.program.program import name_of

CHOICE, COMPARISON, SUM, PRODUCT, SIGN, CALL = range(6)
"""Precedences; the last: of function calls and names."""
CONSTANTS = "constants"
"""The component of constants that are assigned."""


@dataclass(frozen=True)
class Language:
    """A language's spelling of an instruction, a pattern and its precedence; a constant; NaN; a
    comment; sine and cosine of the same operand, or the errors of both, computed together by a
    function from arguments."""

    spelling: Callable[[Instruction], tuple[str, int]]
    constant: Callable[[Constant], str]
    not_a_number: str
    comment: str
    sine_and_cosine: str


@dataclass(frozen=True)
class Assignment:
    """An instruction that is not nested, and its expression; or a sine with its cosine."""

    step: Instruction
    expression: str
    cosine: Instruction | None = None

    @property
    def names(self) -> tuple[str, ...]:
        """Names that are assigned: one, or those of a sine and its cosine."""
        return (self.step.name, *([self.cosine.name] if self.cosine else []))


@dataclass
class Nesting:
    """The text of a Program.

    `access` returns the expression that reads an input; `named` says which instructions are
    assigned even if they are used once, `inlined` which never are, of those; `name = expression` is
    at most `width` wide, unless what is inlined is longer."""

    program: Program
    language: Language
    access: Callable[[Input], str]
    width: int
    headings: Mapping[int, str] = field(default_factory=dict)
    named: Callable[[Instruction], bool] = lambda step: False
    constants: Mapping[str, Constant] = field(default_factory=dict)  # assigned by these names
    inlined: Callable[[Instruction], bool] = lambda step: False

    def __post_init__(self) -> None:
        self.assigned: list[Assignment | str] = []  # and headings
        self._waiting: dict[str, tuple[Instruction, str, int]] = {}  # name → expression, precedence
        self._unassigned = dict(self.constants)
        self._section = 0  # where the section below the last heading begins
        pairs = sine_cosine_pairs(self.program)
        self._taken: set[str] = set()  # of pairs
        for number, step in enumerate(self.program.instructions):
            if number in self.headings:
                self._heading(self.headings[number])
            if step.name in pairs:
                self._take_pair(*pairs[step.name])
            else:
                self._take(step)
        self.results = [self._result(x) for x in self.program.results]

    @property
    def lines(self) -> list[str]:
        """Assignments and comments."""
        return [f"{self.language.comment}{x}" if isinstance(x, str) else
                f"{', '.join(x.names)} = {x.expression}" for x in self.assigned]

    def _take(self, step: Instruction) -> None:
        """Keep the instruction's expression for its only use, or assign it.  Operands are nested
        while the line is short enough; the longest are assigned first."""
        inner = [x.name for x in step.operands
                 if isinstance(x, Ref) and x.name in self._waiting]
        expression, precedence = self._expression(step)
        room = self.width - len(step.name) - len(" = ")
        if inner and len(expression) > room:
            free = [name for name in inner if not self.inlined(self._waiting[name][0])]
            while free and len(expression) > room:
                longest = max(free, key=lambda name: len(self._waiting[name][1]))
                free.remove(longest)
                inner.remove(longest)
                self._assign(*self._waiting.pop(longest)[:2])
                expression, precedence = self._expression(step)
        for name in inner:
            del self._waiting[name]
        if self.program.uses[step.name] == 1 and not self.named(step):
            self._waiting[step.name] = step, expression, precedence
        else:
            self._assign(step, expression)

    def _take_pair(self, sine: Instruction, cosine: Instruction) -> None:
        """Assign both, where the first of them is; their operands have two uses, or are inputs or
        assigned already."""
        if cosine.name not in self._taken:
            self._taken |= {sine.name, cosine.name}
            arguments = [self._operand(x, CHOICE) for x in operands_of_pair(sine, cosine)]
            expression = self.language.sine_and_cosine.format(
                function=FUNCTION_OF[sine.op], arguments=", ".join(arguments))
            self.assigned.append(Assignment(sine, expression, cosine))

    def _heading(self, words: str) -> None:
        """A comment; it replaces one with nothing below it."""
        if self.assigned and isinstance(self.assigned[-1], str):
            self.assigned.pop()
        self.assigned.append(words)
        self._section = len(self.assigned)

    def _assign(self, step: Instruction, expression: str) -> None:
        """An assignment; its constants are assigned where its section begins."""
        for word in _WORD.findall(expression) if self._unassigned else ():
            if (constant := self._unassigned.pop(word, None)) is not None:
                own = Assignment(Instruction(word, Op.ADD, (constant,), CONSTANTS),
                                 self.language.constant(constant))
                self.assigned.insert(self._section, own)
                self._section += 1
        self.assigned.append(Assignment(step, expression))

    def _result(self, operand: Operand) -> str:
        if isinstance(operand, Ref) and operand.name in self._waiting:
            self._assign(*self._waiting.pop(operand.name)[:2])
        return self._operand(operand, CHOICE)

    def _expression(self, step: Instruction) -> tuple[str, int]:
        spelling, precedence = self.language.spelling(step)
        waiting, operand = self._waiting, self._operand
        return spelling.format(*[
            x.name if isinstance(x, Ref) and x.name not in waiting else operand(x, n)
            for x, n in zip(step.operands, _needed(step.op, spelling, precedence), strict=False)
        ]), precedence

    def _operand(self, operand: Operand, needed: int) -> str:
        """The operand's text, in parentheses if its precedence is below `needed`."""
        if isinstance(operand, Ref):
            if operand.name not in self._waiting:
                return operand.name
            _, text, precedence = self._waiting[operand.name]
            return text if precedence >= needed else f"({text})"
        if isinstance(operand, Input):
            return self.access(operand)
        if isinstance(operand, Constant):
            if self.constants.get(operand.name) == operand:
                return operand.name
            text = self.language.constant(operand)
            return f"({text})" if text.startswith("-") and needed > SIGN else text
        if isinstance(operand, NotANumber):
            return self.language.not_a_number
        return ""  # a table's column, which the spelling names


@cache
def _needed(op: Op, spelling: str, precedence: int) -> Sequence[int]:
    """The precedence that each operand of an instruction of this spelling and precedence needs."""
    if " * " in spelling:
        return PRODUCT, PRODUCT + 1  # also within a call
    if precedence == CALL:
        return [CHOICE] * 4
    if op is Op.SELECT:
        return [COMPARISON] * 3
    return [precedence + 1] if op is Op.NEG else [precedence, precedence + 1]


@dataclass(frozen=True)
class NestingPlan:
    """Instructions of a Program that are assigned to variables; those without names of their own
    are numbered without gaps."""

    program: Program
    assigned: frozenset[str]
    constants: Mapping[str, Constant] = field(default_factory=dict)  # by name

    def printed(self, language: Language, access: Callable[[Input], str],
                headings: Mapping[int, str]) -> Nesting:
        """Its text in a language, expressions of any length."""
        return Nesting(self.program, language, access, 1 << 30, headings,
                       lambda step: step.name in self.assigned, self.constants)


_WORD = re.compile(r"\w+")
_BREAK = re.compile(r"[()\[\]]| (?=[-+*/?:<])")  # a bracket, or the space before an operator
_NUMBERED = re.compile(r"(.+)_([0-9]+)")  # an instruction without a name of its own


def numbered(name: str) -> bool:
    """Returns whether an instruction has no name of its own."""
    return bool(_NUMBERED.fullmatch(name))


def planned(program: Program, language: Language, access: Callable[[Input], str], width: int,
            named: Collection[str] = ()) -> NestingPlan:
    """A plan that assigns what has a name of its own, is `named` or is used several times, and
    keeps assignments at most `width` wide in this language."""
    constants = named_constants(program)
    nesting = Nesting(program, language, access, width, constants=constants, named=lambda step: (
        step.name in named or not numbered(step.name)))
    chosen = {name for x in nesting.assigned if isinstance(x, Assignment) for name in x.names}
    assigned = [step.name for step in program.instructions if step.name in chosen]
    names = _numbered(program, assigned, constants)
    return NestingPlan(renamed(program, names), frozenset(names[x] for x in assigned), constants)


def named_constants(program: Program) -> dict[str, Constant]:
    """The program's constants that have names, each of its own, by name."""
    constants: dict[str, Constant] = {}
    for step in program.instructions:
        for x in step.operands:
            if isinstance(x, Constant) and x.name:
                constants.setdefault(x.name, x)
    taken = _names(program) if constants else ()
    return {name: x for name, x in constants.items() if name not in taken}


def _names(program: Program) -> set[str]:
    """Returns the names of instructions and arguments."""
    arguments = [a.name for a in (*program.inputs, *program.outputs)]
    return {*(step.name for step in program.instructions), *arguments,
            *(f"{x}o" for x in arguments)}


def _numbered(program: Program, assigned: Sequence[str], constants: Collection[str]
              ) -> dict[str, str]:
    """New names by old: assigned instructions are numbered first, then the others; a result that
    is the only one of its stem loses its number."""
    stems = {step.name: match[1] for step in program.instructions
             if (match := _NUMBERED.fullmatch(step.name))}
    taken = {*_names(program), *constants}
    names: dict[str, str] = {}
    numbers: Counter[str] = Counter()
    for name in dict.fromkeys((*assigned, *(step.name for step in program.instructions))):
        if stem := stems.get(name):
            numbers[stem] += 1
        names[name] = f"{stem}_{numbers[stem]}" if stem else name
    alone = Counter(stems[x] for x in assigned if x in stems)
    for x in program.results:
        stem = stems.get(name_of(x))
        if stem and alone[stem] == 1 and stem not in taken:
            names[name_of(x)] = stem
    return names


def wrapped(text: str, width: int, indent: int) -> Iterator[str]:
    """Rows of the text: the first at most `width` wide, the others `indent` less.  Breaks outermost
    operators first, as late as possible."""
    while len(text) > width:
        depth, best, least = 0, -1, len(text)
        for match in _BREAK.finditer(text, 0, width + 1):
            letter, place = match[0], match.start()
            if place == width:
                break
            depth += (letter in "([") - (letter in ")]")
            if letter == " " and depth <= least:
                best, least = place, depth
        if best < 0:
            break
        yield text[:best]
        text, width = text[best + 1:], width - indent
        indent = 0
    yield text
