"""The writer of C functions, for any Program and any way to store its arguments.

Results are stored last, after everything has been read: outputs may overlap inputs.
"""

import re
from collections.abc import Callable, Collection, Iterator, Sequence
from dataclasses import dataclass

from coscrew_codegen.formats import DOUBLE, Precision
from coscrew_codegen.program import Input, Instruction, Operand, Program
from coscrew_codegen.targets.c_statements import WIDTH, Statements, broken, comment_of


@dataclass(frozen=True)
class CFunction:
    """The text of one function: comment, head without storage class, lines of the body."""

    name: str
    comment: str
    head: str
    body: str
    internal: bool = False


@dataclass(frozen=True)
class Stored:
    """How a function stores its arguments.

    `access` returns the expression that reads a component of an input, `targets` holds the lvalue
    of each result, `written` the names of arguments that are written to."""

    access: Callable[[Input], str]
    targets: Sequence[str]
    written: Collection[str]
    returned: str = ""  # what the function returns: this variable, or the first result
    declared: str = ""  # type of that variable; "" if the first result is returned


@dataclass(frozen=True)
class Body:
    """The body of a function in a precision: the instructions as declarations, in sections below
    their headings; then the stores."""

    program: Program
    precision: Precision
    stored: Stored
    headings: Sequence[tuple[int, str]] = ()  # (number of an instruction, words above it)

    def text(self) -> str:
        """All lines, indented."""
        rows = (row for line in self._lines() for row in line.split("\n"))
        return "\n".join(f"  {row}" for row in rows)

    @property
    def _statements(self) -> Statements:
        working = DOUBLE if self.program.wide else self.precision
        return Statements(self.program, working, self.stored.access)

    def _lines(self) -> Iterator[str]:
        statements, used = self._statements, {x.argument for x in self.program.used_inputs()}
        yield from (f"(void){a.name};" for n, a in enumerate(self.program.inputs)
                    if n not in used and a.name not in self.stored.written)
        for heading, steps in _sections(self.program.instructions, dict(self.headings)):
            if heading:
                yield f"/* {heading} */"
            if text := statements.declared(steps, WIDTH - 2):
                yield broken(text, WIDTH - 2) if self.headings else text
        yield from self._stores(statements)

    def _stores(self, statements: Statements) -> Iterator[str]:
        results = [self._result(statements, x) for x in self.program.results]
        pairs = list(zip(self.stored.targets, results, strict=True))
        last = ""
        if self.stored.declared:
            yield f"{self.stored.declared} {self.stored.returned};"
            last = f"return {self.stored.returned};"
        elif self.stored.returned:
            last = f"return {pairs.pop(0)[1]};"
        saved = self._saved(pairs)
        yield from (f"const {self.precision.c_type} {name} = {source};"
                    for source, name in saved.items())
        yield from (f"{target} = {saved.get(x, x)};" for target, x in pairs if target != x)
        if last:
            yield last

    def _result(self, statements: Statements, operand: Operand) -> str:
        """A result in the precision of the arguments.  A result that is an input is not cast."""
        if isinstance(operand, Input):
            return self.stored.access(operand)
        narrowed = f"({self.precision.c_type})" if self.program.wide else ""
        return narrowed + statements.operand(operand)

    def _saved(self, pairs: Sequence[tuple[str, str]]) -> dict[str, str]:
        """Inputs that are copied to an output are read before anything is written, since the output
        may be the same object: input → the local variable that holds it."""
        if len(self.stored.targets) == 1 or self.stored.returned:
            return {}
        names, saved = {step.name for step in self.program.instructions}, {}
        for target, source in pairs:
            if target != source and source not in saved and ("->" in source or "[" in source):
                saved[source] = _local_name(source, names)
        return saved


def documented(name: str, paragraphs: Sequence[str], head: str, body: Body,
               internal: bool = False) -> CFunction:
    """The function below its comment."""
    return CFunction(name, comment_of(paragraphs), head, body.text(), internal)


def _local_name(access: str, taken: Collection[str]) -> str:
    """D->m03 → D_m03, dc[1] → dc_1."""
    name = re.sub(r"->|\[|\.", "_", access.replace("][", "")).rstrip("]")
    while name in taken:
        name += "_"
    return name


def _sections(instructions: Sequence[Instruction], headings: dict[int, str]
              ) -> Iterator[tuple[str, list[Instruction]]]:
    """(heading or "", consecutive instructions of one component); a heading starts a new section.
    """
    steps: list[Instruction] = []
    above = ""
    for number, step in enumerate(instructions):
        if steps and (number in headings or step.component != steps[-1].component):
            yield above, steps
            above, steps = "", []
        above = headings.get(number, above)
        steps.append(step)
    if steps:
        yield above, steps
