"""Writes columns that are alike as a loop, which compilers vectorize.

What differs between columns stands in an array, a row for each value, where other parts store it.
"""

from collections.abc import Callable, Iterable, Iterator, Mapping
from dataclasses import dataclass
from functools import cached_property

from coscrew_codegen.backends.c.c_nested import declarations, language
from coscrew_codegen.backends.c.c_statements import WIDTH
from coscrew_codegen.backends.c.c_stores import in_lines
from coscrew_codegen.backends.nesting import NestingPlan, planned
from coscrew_codegen.backends.scene.scene_text import VALUE_WIDTH, access
from coscrew_codegen.program import Constant, Input, Operand, Program, Ref
from coscrew_codegen.program.splitting.columns import AlikeColumns, columns
from coscrew_codegen.program.splitting.parts import Group
from coscrew_codegen.program.values.formats import DOUBLE, Precision

ABOVE, ALIGNED = "COSCREW_COLUMNS", "COSCREW_ALIGNED"
"""Macros: above a loop, with which clang vectorizes it at every level of optimization; before an
array whose rows loops read and write."""
_BLOCK = 4
"""Arrays have a multiple of so many columns: the rest of a loop would not be vectorized."""
_MADE = "made"  # the array of results


@dataclass(frozen=True)
class ColumnLoop:
    """The part of a group that consists of columns; `array` is the member with what differs, except
    the values that `elsewhere` names: arrays of earlier loops hold them."""

    group: Group
    part: Program
    columns: AlikeColumns
    array: str
    elsewhere: frozenset[str]

    @cached_property
    def slots(self) -> Mapping[str, str]:
        """The elements of the array that hold kept values of the group, by the values' names."""
        slots: dict[str, str] = {}
        for place, x in self._given():
            if (name := self._kept(x)) and name not in self.elsewhere:
                slots.setdefault(name, place)
        return slots

    def declared(self, precision: Precision) -> str:
        """The declaration of the array."""
        return (f"{ALIGNED} {precision.c_type} {self.array}[{len(self.columns.given)}]"
                f"[{self._size}];")

    @property
    def cleared(self) -> list[str]:
        """The statement that clears an array with more columns than are computed."""
        name = f"{self.group.name}.{self.array}"
        return [f"memset({name}, 0, sizeof {name});"] \
            if self._size > len(self.columns.results[0]) else []

    def lines(self, precision: Precision, read: Callable[[Input], str],
              stored: Callable[[str, str], Iterable[tuple[str, str]]]) -> Iterator[str]:
        """Statements that copy into the array what no other part stores there, the loop, and
        statements that store its results.  `read` gives the text of an element of the part's
        inputs, `stored` the targets of a value, by its name, and texts, by its own."""
        program = self.plan.program
        own = f"{self.group.name}->{self.array}"
        yield from in_lines(
            [(f"{self.group.name}->{place}", _operand(x, precision, read))
             for place, x in self._given() if self.slots.get(self._kept(x)) != place],
            WIDTH - 2)
        yield f"{ALIGNED} {precision.c_type} {_MADE}[{len(self.columns.results)}][{self._size}];"
        yield ABOVE
        yield f"for (int c = 0; c < {self._size}; ++c) {{"
        nesting = self.plan.printed(language(program, precision), lambda x: (
            f"{own}[{x.index}][c]" if x.argument == len(program.inputs) - 1 else read(x)), {})
        for row in declarations(nesting.assigned, precision, WIDTH - 4):
            yield "\n".join(f"  {line}" for line in row.split("\n"))
        yield from (f"  {line}" for line in in_lines(
            [(f"{_MADE}[{n}][c]", text) for n, text in enumerate(nesting.results)], WIDTH - 4))
        yield "}"
        yield from in_lines([store for n, row in enumerate(self.columns.results)
                             for k, name in enumerate(row)
                             for store in stored(name, f"{_MADE}[{n}][{k}]")], WIDTH - 2)

    @cached_property
    def plan(self) -> NestingPlan:
        """The plan of the program of one column."""
        program = self.columns.program
        return planned(program, language(program, DOUBLE), access(program), VALUE_WIDTH,
                       [x.name for x in program.results if isinstance(x, Ref)])

    @property
    def _size(self) -> int:
        return -(-len(self.columns.results[0]) // _BLOCK) * _BLOCK

    def _given(self) -> Iterator[tuple[str, Operand]]:
        for n, row in enumerate(self.columns.given):
            yield from ((f"{self.array}[{n}][{k}]", x) for k, x in enumerate(row))

    def _kept(self, x: Operand) -> str:
        """The name of a kept value of the group; "" of others."""
        own = isinstance(x, Input) and self.part.inputs[x.argument].name == self.group.name
        return self.group.kept[x.index] if isinstance(x, Input) and own else ""


def column_loops(groups: Iterable[Group]) -> Iterator[ColumnLoop]:
    """The parts that consist of columns."""
    for group in groups:
        loops = list[ColumnLoop]()
        for part in group.parts:
            if of := columns(part, "given"):
                name = f"columns_{len(loops) + 1}"
                while name in group.kept:
                    name += "_"
                loops.append(ColumnLoop(group, part, of, name,
                                        frozenset().union(*(x.slots for x in loops))))
        yield from loops


def _operand(x: Operand, precision: Precision, read: Callable[[Input], str]) -> str:
    if isinstance(x, Constant):
        return precision.literal(x) + precision.suffix
    assert isinstance(x, Input)  # a part reads values of others as inputs
    return read(x)
