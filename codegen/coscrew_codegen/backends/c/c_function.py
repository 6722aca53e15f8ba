"""The writer of C functions, for any Program and any way to store its arguments.

Results are stored last, after everything has been read: outputs may overlap inputs.
"""

import re
from collections.abc import Callable, Collection, Iterator, Sequence
from dataclasses import dataclass
from functools import partial

from coscrew_codegen.backends import c_early_stores
from coscrew_codegen.backends.c.c_library import nested, quantity
from coscrew_codegen.backends.c.c_nested import EACH, declarations, language
from coscrew_codegen.backends.c.c_statements import WIDTH, broken, comment_of
from coscrew_codegen.backends.c.c_stores import Layout, Stores
from coscrew_codegen.backends.c.c_together import (
    AngleArrays,
    Together,
    angle_arrays,
    in_arrays,
    together,
)
from coscrew_codegen.backends.nesting import Assignment, Nesting, NestingPlan
from coscrew_codegen.program import Input, Operand, Program, Ref
from coscrew_codegen.program.values.formats import Precision


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
    """Places where a function stores its results.

    `access` returns the expression that reads a component of an input, `targets` holds the lvalue
    of each result, `written` the names of arguments that are written to."""

    access: Callable[[Input], str]
    targets: Sequence[str]
    written: Collection[str]
    returned: str = ""  # what the function returns: this variable, or the first result
    declared: str = ""  # type of that variable; "" if the first result is returned


@dataclass(frozen=True)
class FunctionBody:
    """The body of a function in a precision: declarations, as the library's or nested as planned;
    then the stores."""

    program: Program
    precision: Precision
    stored: Stored
    plan: NestingPlan | None = None  # of the program, if it is nested
    headings: Sequence[tuple[int, str]] = ()  # then: (number of an instruction, words above it)
    apart: bool = False  # whether each angle on vectors has its own call
    layout: Layout | None = None  # if results are stored in loops and rows

    def text(self) -> str:
        """All lines, indented."""
        rows = (row for line in self._lines() for row in line.split("\n"))
        return "\n".join(f"  {row}" for row in rows)

    def _lines(self) -> Iterator[str]:
        used = {x.argument for x in self.program.used_inputs()}
        yield from (f"(void){a.name};" for n, a in enumerate(self.program.inputs)
                    if n not in used and a.name not in self.stored.written)
        if self.layout:
            yield from self._laid_out(self.layout)
            return
        lines, results = self._nested(self.plan) if self.plan else self._of_library()
        yield from lines
        yield from self._stores(results)

    def _laid_out(self, layout: Layout) -> Iterator[str]:
        """Declarations, and stores in loops and rows."""
        working = self.precision.computing(self.program.wide)
        assigned: Sequence[Assignment | Together | str] = ()
        if self.plan:
            arrays = None if self.precision.lanes else angle_arrays(self.plan.program)
            plan = in_arrays(self.plan, arrays) if arrays else self.plan
            nesting, results = self._printed(plan)
            own = [x for x in nesting.assigned
                   if not (arrays and isinstance(x, Assignment) and arrays.hold(x.step.name))]
            assigned = together(own, working, self.apart)
            if arrays:
                yield from arrays.statements(working, self._angle(plan.program, arrays))
        else:
            lines, results = self._of_library()
            yield from lines
        stores = Stores(plan.program if self.plan else self.program, assigned, results,
                        self.stored.targets, layout, self.precision)
        saved = self._saved(stores.single())
        if c_early_stores.pays(stores):
            yield from c_early_stores.statements(
                stores, saved, partial(declarations, precision=working, width=WIDTH - 2), WIDTH - 2)
            return
        yield from declarations(stores.declared(), working, WIDTH - 2)
        yield from stores.statements(saved, WIDTH - 2)

    def _angle(self, program: Program, arrays: AngleArrays) -> Callable[[int], str]:
        """The text of an angle in arrays, by its index."""
        read = read_by(program, self.precision, self.stored.access)
        argument = [a.name for a in program.inputs].index(arrays.argument)
        return lambda n: read(Input(argument, n))

    def _printed(self, plan: NestingPlan) -> tuple[Nesting, list[str]]:
        """The plan's text, and that of its results."""
        program = plan.program
        nesting = plan.printed(language(program, self.precision), read_by(program, self.precision,
                               self.stored.access), dict(self.headings))
        return nesting, [self._narrowed(x, text)
                         for x, text in zip(program.results, nesting.results, strict=True)]

    def _of_library(self) -> tuple[Iterator[str], list[str]]:
        """Declarations of a Program of the library, and results."""
        working = self.precision.computing(self.program.wide)
        text = nested(self.program, working, read_by(self.program, self.precision,
                                                     self.stored.access))
        texts = declarations(text.assigned, working, WIDTH - 2, quantity)
        return ((broken(x, WIDTH - 2) for x in texts),
                [self._narrowed(*x) for x in zip(self.program.results, text.results, strict=True)])

    def _nested(self, plan: NestingPlan) -> tuple[Iterator[str], list[str]]:
        """Declarations in which expressions nest, and results."""
        nesting, results = self._printed(plan)
        working = self.precision.computing(plan.program.wide)
        return declarations(
            together(nesting.assigned, working, self.apart), working, WIDTH - 2), results

    def _stores(self, results: Sequence[str]) -> Iterator[str]:
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

    def _narrowed(self, operand: Operand, text: str) -> str:
        """A result in the precision of the arguments.  A result that is an input is not cast."""
        if isinstance(operand, Input):
            return self.stored.access(operand)
        if self.precision.lanes and not isinstance(operand, Ref):
            return EACH.format(text, f=self.precision.called)
        if not self.program.wide:
            return text
        if self.precision.device and not isinstance(operand, Ref):  # a literal of double
            text = f"({self.precision.computing(True).c_type}){text}"
        return f"({self.precision.c_type}){text}"

    def _saved(self, pairs: Sequence[tuple[str, str]]) -> dict[str, str]:
        """Inputs that are copied to an output are read before anything is written, since the output
        may be the same object: input → the local variable that holds it."""
        if len(self.stored.targets) == 1 or self.stored.returned:
            return {}
        names, saved = {step.name for step in self.program.instructions}, {}
        inputs = {self.stored.access(x) for x in self.program.results if isinstance(x, Input)}
        for target, source in pairs:
            if target != source and source not in saved and source in inputs \
                    and ("->" in source or "[" in source):
                saved[source] = _local_name(source, names)
        return saved


def read_by(program: Program, precision: Precision, access: Callable[[Input], str]
            ) -> Callable[[Input], str]:
    """The text with which a program reads an input: a wide one converts it."""
    working = precision.computing(program.wide)
    return access if precision == working else lambda x: f"({working.c_type}){access(x)}"


def documented(name: str, paragraphs: Sequence[str], head: str, body: FunctionBody,
               internal: bool = False) -> CFunction:
    """The function below its comment."""
    return CFunction(name, comment_of(paragraphs), head, body.text(), internal)


def _local_name(access: str, taken: Collection[str]) -> str:
    """D->m03 → D_m03, dc[1] → dc_1."""
    name = re.sub(r"->|\[|\.", "_", access.replace("][", "")).rstrip("]")
    while name in taken:
        name += "_"
    return name
