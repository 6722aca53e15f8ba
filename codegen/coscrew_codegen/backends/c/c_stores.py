"""Statements that store a function's results: loops where neighbours are alike, else a row of a
matrix on a line.

Works on text: expressions are alike if they differ in indices alone, and each index is the same in
all of them or grows by one.
"""

import re
from collections import Counter
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from itertools import groupby

from coscrew_codegen.backends.c.c_statements import listed
from coscrew_codegen.backends.c.c_together import UNROLLED, Together, without_empty_sections
from coscrew_codegen.backends.nesting import Assignment
from coscrew_codegen.program import Constant, Input, Operand, Program, Ref
from coscrew_codegen.program.values.formats import Precision

_INDEX = re.compile(r"\[(\d+)\]")
_ELEMENT = re.compile(r"(\w+)\[(\d+)\]")
_FEWEST = {True: 3, False: 6}
"""Least numbers of alike results that a loop stores: of computed values, and of constants and
inputs."""


@dataclass(frozen=True)
class Layout:
    """The way in which results are stored: the length of each output's rows; whether an output is
    an input of the same shape (v and vo) or apart from all, as arguments of internal functions are.
    Outputs of others may overlap inputs in any way."""

    rows: Mapping[str, int]
    in_place: bool


@dataclass(frozen=True)
class _StoreRun:
    """A run of results that are alike: where they begin in an output, how many they are, the first
    one's expression with its indices, those that grow, and the instructions that it replaces."""

    output: str
    first: int
    count: int
    expression: str
    growing: tuple[bool, ...]
    replaced: tuple[str, ...]
    reads: bool  # whether it reads arguments

    @property
    def first_target(self) -> str:
        """The place of the first one."""
        return f"{self.output}[{self.first}]"

    @property
    def loop(self) -> str:
        """Stores them."""
        return self._loop(self.output, self.first)

    def array(self, real: str) -> str:
        """Computes them into an array of their own."""
        return f"{real} {self.name}[{self.count}];\n{UNROLLED}\n{self._loop(self.name, 0)}"

    @property
    def name(self) -> str:
        """The array that holds them until all inputs have been read."""
        return f"{self.output}_{self.first}_to_{self.first + self.count - 1}"

    @property
    def copied(self) -> str:
        """Stores what that array holds."""
        return f"memcpy(&{self.output}[{self.first}], {self.name}, sizeof {self.name});"

    def _loop(self, array: str, begin: int) -> str:
        """for (…) { array[i] = expression; }"""
        growing = iter(self.growing)

        def index(match: re.Match[str]) -> str:
            place = int(match[1])
            if not next(growing):
                return f"[{place}]"
            more = place - begin
            return f"[i {'-' if more < 0 else '+'} {abs(more)}]" if more else "[i]"

        return "\n".join((f"for (int i = {begin}; i < {begin + self.count}; ++i) {{",
                          f"  {array}[i] = {_INDEX.sub(index, self.expression)};", "}"))


@dataclass(frozen=True)
class Stores:
    """The results of a function: the program, what is assigned, their texts, and where they go."""

    program: Program
    assigned: Sequence[Assignment | Together | str]
    results: Sequence[str]
    targets: Sequence[str]
    layout: Layout
    precision: Precision

    def declared(self) -> Sequence[Assignment | Together | str]:
        """The values that are assigned before the stores: all that stand in no loop."""
        inside = {name for x in self.alike for name in x.replaced}
        return without_empty_sections([
            x for x in self.assigned if isinstance(x, str) or x.step.name not in inside])

    def single(self) -> list[tuple[str, str]]:
        """The results outside of loops, with their targets."""
        inside = {f"{x.output}[{n}]" for x in self.alike for n in range(x.first, x.first + x.count)}
        return [x for x in zip(self.targets, self.results, strict=True) if x[0] not in inside]

    def statements(self, saved: Mapping[str, str], width: int) -> Iterator[str]:
        """Arrays and declarations of the values that are read before any store, and the stores;
        `saved` has the variables of inputs that are results."""
        yield from (x.array(self.precision.c_type) for x in self._apart)
        yield from self.copies(saved, width)
        yield from self.of_targets(self.targets, saved, width)

    def copies(self, saved: Mapping[str, str], width: int) -> Iterator[str]:
        """Declarations of variables that hold inputs."""
        if saved:
            yield listed(f"const {self.precision.c_type} ",
                         [f"{name} = {x}" for x, name in saved.items()], ";", width)

    def of_targets(self, targets: Sequence[str], saved: Mapping[str, str], width: int
                   ) -> Iterator[str]:
        """The stores to these targets."""
        first = {x.first_target: x for x in self.alike}
        waiting: list[tuple[str, str]] = []
        single = dict(self.single())
        for target in targets:
            if target in single:
                text = single[target]
                waiting += [(target, saved.get(text, text))] if target != text else []
            elif target in first:
                yield from in_rows(waiting, self.layout.rows, width)
                waiting = []
                run = first[target]
                yield run.copied if run in self._apart else run.loop
        yield from in_rows(waiting, self.layout.rows, width)

    @cached_property
    def _apart(self) -> list[_StoreRun]:
        """The loops that fill arrays, since outputs may overlap what they read."""
        return [x for x in self.alike if x.reads and not self.layout.in_place]

    @cached_property
    def alike(self) -> list[_StoreRun]:
        """The runs that are loops."""
        runs, place = [], 0
        while place < len(self.targets):
            count, run = self._run(place)
            if run and count >= _FEWEST[isinstance(self.program.results[place], Ref)]:
                runs.append(run)
                place += count
            else:
                place += 1
        return runs

    def _run(self, start: int) -> tuple[int, _StoreRun | None]:
        """The longest run that begins with this result."""
        target, expression = _ELEMENT.fullmatch(self.targets[start]), self._expression(start)
        if not (target and expression):
            return 0, None
        indices, count = [int(x) for x in _INDEX.findall(expression)], 1
        steps: list[int] | None = None
        while self._follows(start, count, target, expression):
            now = [int(x) for x in _INDEX.findall(self._expression(start + count))]
            grown = [b - a for a, b in zip(indices, now, strict=True)]
            if count == 1 and {*grown} <= {0, 1}:
                steps = grown
            if steps is None or grown != [x * count for x in steps]:
                break
            count += 1
        if steps is None or not self._may_be_a_loop(target, expression, steps):
            return count, None
        names = tuple(x.name for x in self.program.results[start:start + count]
                      if isinstance(x, Ref))
        return count, _StoreRun(target[1], int(target[2]), count, expression,
                             tuple(map(bool, steps)), names, bool(self._read(expression)))

    def _follows(self, start: int, count: int, first: re.Match[str], expression: str) -> bool:
        """True if a result continues a run, apart from its indices."""
        place = start + count
        if place == len(self.targets):
            return False
        target, other = _ELEMENT.fullmatch(self.targets[place]), self._expression(place)
        return bool(target and other and target[1] == first[1]
                    and int(target[2]) == int(first[2]) + count
                    and _INDEX.sub("[]", other) == _INDEX.sub("[]", expression))

    def _expression(self, place: int) -> str:
        """The expression of a result that nothing else uses, a constant, an input; "" of others."""
        x, text = self.program.results[place], self.results[place]
        if not isinstance(x, Ref):
            return text if isinstance(x, (Constant, Input)) else ""
        return self._own.get(x.name, "") if text == x.name else ""

    @cached_property
    def _own(self) -> dict[str, str]:
        """Expressions that are assigned for one result alone, by name."""
        return {x.step.name: x.expression for x in self.assigned
                if isinstance(x, Assignment) and not x.cosine and self._uses[x.step.name] == 1}

    @cached_property
    def _uses(self) -> Counter[str]:
        operands: list[Operand] = [x for step in self.program.instructions for x in step.operands]
        return Counter(x.name for x in (*operands, *self.program.results) if isinstance(x, Ref))

    def _read(self, expression: str) -> list[tuple[str, int]]:
        """The arguments that an expression reads, each with the number of its index."""
        names = {a.name for a in self.program.inputs}
        return [(x[1], n) for n, x in enumerate(_ELEMENT.finditer(expression)) if x[1] in names]

    def _may_be_a_loop(self, target: re.Match[str], expression: str, steps: Sequence[int]) -> bool:
        """True if a loop reads every input before it is overwritten."""
        own, indices = target[1].removesuffix("o"), _INDEX.findall(expression)
        return not self.layout.in_place or all(
            steps[n] and indices[n] == target[2] for x, n in self._read(expression) if x == own)


def in_rows(stores: Sequence[tuple[str, str]], rows: Mapping[str, int], width: int
            ) -> Iterator[str]:
    """The assignments of these texts to these targets: a row of a matrix is a line, or several."""
    for _, group in groupby(stores, lambda store: row_of(store[0], rows)):
        yield from in_lines(list(group), width)


def row_of(target: str, rows: Mapping[str, int]) -> tuple[str, int]:
    """The output that a target belongs to, and its row, by the length of each output's rows."""
    match = _ELEMENT.fullmatch(target)
    return (match[1], int(match[2]) // rows.get(match[1], 1)) if match else (target, 0)


def in_lines(stores: Sequence[tuple[str, str]], width: int) -> Iterator[str]:
    """The assignments of these texts to these targets, as many on a line as it holds."""
    line = ""
    for target, text in stores:
        statement = f"{target} = {text};"
        if line and len(line) + 1 + len(statement) > width:
            yield line
            line = ""
        line = f"{line} {statement}" if line else statement
    if line:
        yield line
