"""Cuts long functions of a scene's C into parts, each a function of its own; parts that several
functions use are written once.

The time of compilers grows faster than a function's length, so no part is long.  Parts pass values
to each other in structures on the stack of the function that calls them.  Where a function has many
results, its parts store them, and read copies of its arguments, since outputs may overlap inputs.
"""

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import replace
from itertools import groupby
from textwrap import dedent

from coscrew_codegen.algebra.recording.recorder import headings
from coscrew_codegen.backends.c.c_function import CFunction, FunctionBody, Stored, read_by
from coscrew_codegen.backends.c.c_nested import declarations, language
from coscrew_codegen.backends.c.c_statements import WIDTH, comment_of, listed
from coscrew_codegen.backends.c.c_stores import Layout, in_lines, row_of
from coscrew_codegen.backends.c.c_together import together
from coscrew_codegen.backends.c_early_stores import has_many_results
from coscrew_codegen.backends.nesting import Assignment, Nesting, NestingPlan, named_constants
from coscrew_codegen.backends.scene import scene_c_arguments as arguments
from coscrew_codegen.backends.scene.scene_c_columns import ColumnLoop, column_loops
from coscrew_codegen.backends.scene.scene_text import (
    VALUE_WIDTH,
    access,
    c_name,
    outputs,
    printable,
    rows,
    size,
)
from coscrew_codegen.program import Constant, Input, Instruction, Op, Operand, Program, Ref
from coscrew_codegen.program.scene_functions import FunctionProgram, SceneFunctions
from coscrew_codegen.program.splitting.columns import LEAST, has_columns
from coscrew_codegen.program.splitting.parts import Cut, Group, cut
from coscrew_codegen.program.values.formats import DOUBLE, Precision
from coscrew_codegen.program.values.quantity import Argument

LONG = 4000
"""A function with at most so many instructions is not cut: those of arms with seven joints are
shorter, and would be slower in parts."""
LONGEST = 600
"""Largest number of instructions of a part: those of a few links."""
_OF_CONSTANTS = Program("constants", (), (), (), ())
_OF_ANGLES = {Op.SIN, Op.COS, Op.SIN_ERROR, Op.COS_ERROR}


def _cuts(plans: Sequence[NestingPlan], loops: bool) -> dict[str, Cut]:
    """The long functions, which are cut, by name; short ones only where a loop over columns is."""
    programs = [plan.program for plan in plans]
    long = [x for x in programs if len(x.instructions) > LONG]
    result = cut([_angles_first(x) for x in long], LONGEST, columns=loops) if long else {}
    for x in programs if loops else ():
        if x.name not in result and len(x.instructions) >= LEAST and has_columns(x):
            result |= cut([_angles_first(x)], LONG, columns=True)
    return result


def _angles_first(program: Program) -> Program:
    """Moves instructions for several angles at once to the front, so that one part has them all."""
    first: dict[Ref, Instruction] = {}
    for step in program.instructions:
        x, *others = step.operands
        if step.op in _OF_ANGLES and isinstance(x, Input) and first.keys() >= set(others):
            first[Ref(step.name)] = step
    rest = (step for step in program.instructions if Ref(step.name) not in first)
    return replace(program, instructions=(*first.values(), *rest))


class FunctionParts:
    """The functions of a scene that are cut into parts, as C; with `loops` over columns that are
    alike: on vectors of states, and on devices, these are slower than straight lines."""

    def __init__(self, scene: SceneFunctions, plans: Sequence[NestingPlan], loops: bool = True):
        self.scene, self.cuts = scene, _cuts(plans, loops)
        self.wide = any(plan.program.wide for plan in plans)
        assigned = {plan.program.name: plan.assigned for plan in plans}
        self._groups = {group.name: group for cut in self.cuts.values() for group in cut.groups}
        self._loops = {x.part.name: x for x in column_loops(self._groups.values())} \
            if loops and self._groups else {}
        self._slots: dict[str, dict[str, str]] = {name: {} for name in self._groups}
        for loop in self._loops.values():
            self._slots[loop.group.name] |= loop.slots
        self._plans = {part.name: self._planned(part, assigned[group.users[0]])
                       for group in self._groups.values() for part in group.parts
                       if part.name not in self._loops}
        self._words = {f.program.instructions[place].component.rpartition(":")[0]: printable(words)
                       for f in scene.functions if f.name in self.cuts
                       for place, words in f.headings}
        self._inputs = {a.name: a for f in scene.functions for a in f.program.inputs}
        self._read_of = self._values_read()
        self._stored = {f.name: stored for f in scene.functions if f.name in self.cuts
                        and (stored := self._stored_by_parts(f))}
        self._beside = {name: self._constants_beside(scene.named(name)) for name in self._stored}

    def _loops_of(self, group: Group) -> list[ColumnLoop]:
        return [x for x in self._loops.values() if x.group is group]

    def _values_read(self) -> dict[str, set[str]]:
        """The values of each group that parts read."""
        read: dict[str, set[str]] = {name: set() for name in self._groups}
        for part in (part for group in self._groups.values() for part in group.parts):
            for x in part.used_inputs():
                name = part.inputs[x.argument].name
                if name in read:
                    read[name].add(self._groups[name].kept[x.index])
        return read

    def above(self, function: FunctionProgram, precision: Precision) -> Iterator[CFunction]:
        """The parts that no earlier function calls."""
        for group in self.cuts[function.name].groups:
            if group.users[0] == function.name:
                yield from self._parts(group, precision)

    def body(self, function: FunctionProgram, precision: Precision) -> str:
        """The body of a function: calls of its parts, and its results."""
        cut, copies = self.cuts[function.name], self._copies(function, precision)
        declared = [*(f"{precision.c_type} {copy}[{size(self._inputs[x])}];\n"
                      f"memcpy({copy}, {x}, sizeof {copy});" for x, copy in copies.items()),
                    *(f"{self._struct(group, precision)} {group.name};"
                      for group in cut.groups),
                    *(line for group in cut.groups for loop in self._loops_of(group)
                      for line in loop.cleared)]
        calls = [self._call(group, part, precision, copies)
                 for group in cut.groups for part in group.parts]
        own = cut.groups[-1]
        stored = {x for targets in (*self._stores(own, precision).values(),
                                    *self._constants(own, precision).values()) for x in targets}
        rest = self._results(function, cut.last, precision, {
            target: x for target, x in self._targets(function) if target not in stored})
        return f"{_indented((*declared, *calls))}\n{rest}"

    def _results(self, function: FunctionProgram, last: Program, precision: Precision,
                 results: Mapping[str, Operand]) -> str:
        """The text that stores these results, which are given by their targets."""
        last = replace(last, results=tuple(results.values()))
        return FunctionBody(last, precision, Stored(
            self._returned(last, precision, self._copies(function, precision)), [*results],
            [a.name for a in outputs(function)]),
            layout=None if precision.device else Layout(
                rows(outputs(function)), function.internal)).text()

    def _targets(self, function: FunctionProgram) -> Iterator[tuple[str, Operand]]:
        """(target, result) of each of a function's results."""
        return zip(arguments.targets(outputs(function)), self.cuts[function.name].last.results,
                   strict=True)

    def _parts(self, group: Group, precision: Precision) -> Iterator[CFunction]:
        *others, last = group.users
        users = f"{', '.join(others)} and {last}" if others else last
        members = listed(f"{self._working(precision).c_type} ", [
            x for x in group.kept if not self._only_stored(group, x, precision)
            and x not in self._slots[group.name]], ";", WIDTH - 2)
        arrays = [x.declared(self._working(precision)) for x in self._loops_of(group)]
        struct = "\n".join((comment_of([f"The values that parts of {users} share."]),
                            f"{self._struct(group, precision)} {{",
                            _indented([members, *arrays]), "};"))
        for number, part in enumerate(group.parts):
            links = dict.fromkeys(self._words.get(words, printable(words)).partition(":")[0]
                                  for _, words in headings(part))
            comment = comment_of([f"Of {', '.join(links)}."])
            yield CFunction(
                part.name, comment if number else f"{struct}\n\n{comment}",
                arguments.head(c_name(self.scene, part.name, precision),
                               [*(self._parameter(x, group, precision)
                                  for x in self._taken(group, part, precision)),
                                *(arguments.written(x, precision)
                                  for x in self._outputs(group, part, precision))],
                               "KSL_PART_DEVICE" if precision.device
                               else f"{self.scene.name.upper()}_PART"),
                _indented(self._lines(group, part, precision)), internal=True)

    def _lines(self, group: Group, part: Program, precision: Precision) -> Iterator[str]:
        """Declarations; kept values are stored as soon as they are computed, since values that are
        stored at the end occupy registers until then."""
        kept, stores = _computed(part), self._stores(group, precision)
        beside = self._constants(group, precision)
        if part.name in self._loops:
            yield from self._loops[part.name].lines(
                self._working(precision), self._read(part, precision), lambda name, text: (
                    *([(self._member(group, name, "->"), text)] if name in kept
                      and not self._only_stored(group, name, precision) else []),
                    *((target, self._narrowed(precision) + text)
                      for target in stores.get(name, ()))))
            return
        above = {place: self._words.get(words, printable(words)) for place, words in headings(part)}
        nesting = self._plans[part.name].printed(
            language(part, precision), self._read(part, precision), above)
        for _, run in groupby(together(nesting.assigned, self._working(precision)),
                              lambda x: x if isinstance(x, str) else x.step.component):
            assigned = list(run)
            yield from declarations(assigned, self._working(precision), WIDTH - 2)
            names = [name for x in assigned if not isinstance(x, str) for name in x.names]
            yield from (f"{self._member(group, x, '->')} = {x};" for x in names
                        if x in kept and not self._only_stored(group, x, precision))
            yield from in_lines([(target, self._narrowed(precision) + x) for x in names
                                 for target in stores.get(x, ())], WIDTH - 2)
            if constants := {k: v for x in names for k, v in beside.get(x, {}).items()}:
                function = self.scene.named(group.users[0])
                yield dedent(self._results(function, _OF_CONSTANTS, precision, constants))

    def _planned(self, part: Program, named: frozenset[str]) -> NestingPlan:
        """The part's plan: values that are `named` in the whole function, or kept, are assigned."""
        kept = named.union(x.name for x in part.results if isinstance(x, Ref))
        constants = named_constants(part)
        nesting = Nesting(part, language(part, DOUBLE), self._access(part, "->"), VALUE_WIDTH,
                          named=lambda step: step.name in kept, constants=constants)
        assigned = frozenset(name for x in nesting.assigned if isinstance(x, Assignment)
                             for name in x.names)
        return NestingPlan(part, assigned - constants.keys(), constants)

    def _parameter(self, name: str, own: Group, precision: Precision) -> str:
        if name in self._groups:
            const = "" if name == own.name else "const "
            return f"{const}{self._struct(self._groups[name], precision)} *{name}"
        return arguments.read(self._inputs[name], precision)

    def _call(self, group: Group, part: Program, precision: Precision, copies: Mapping[str, str]
              ) -> str:
        taken = [f"&{x}" if x in self._groups else copies.get(x, x)
                 for x in self._taken(group, part, precision)]
        written = [x.name for x in self._outputs(group, part, precision)]
        return listed(f"{c_name(self.scene, part.name, precision)}(", [*taken, *written], ");",
                      WIDTH - 2)

    def _taken(self, group: Group, part: Program, precision: Precision) -> list[str]:
        """The names of a part's arguments: the inputs and groups that it reads, and the group in
        which it keeps values."""
        names = [a.name for a in part.inputs]
        keeps = any(not self._only_stored(group, x, precision) for x in _computed(part))
        own = [group.name] if keeps or group.name in names else []
        return [*(x for x in names if x != group.name), *own]

    # results that parts store

    def _stored_by_parts(self, function: FunctionProgram) -> dict[str, list[str]]:
        """The targets of values of the function's own group, by value."""
        cut = self.cuts[function.name]
        own, stored = cut.groups[-1], dict[str, list[str]]()
        if own.users != (function.name,) or not has_many_results(function.program):
            return {}
        for target, x in self._targets(function):
            if isinstance(x, Input) and cut.last.inputs[x.argument].name == own.name:
                stored.setdefault(own.kept[x.index], []).append(target)
        return stored if any(self._shared(own, x) for x in own.kept) else {}

    def _constants_beside(self, function: FunctionProgram) -> dict[str, dict[str, Operand]]:
        """Maps the first value that a part stores in each row of a result to the row's constants,
        by their targets.  Stored after all parts, zeros of sparse matrices come faster than caches
        take them."""
        of_row: dict[tuple[str, int], dict[str, Operand]] = {}
        beside: dict[str, dict[str, Operand]] = {}
        length = rows(outputs(function))
        for target, x in self._targets(function):
            if isinstance(x, Constant):
                of_row.setdefault(row_of(target, length), {})[target] = x
        for part in self.cuts[function.name].groups[-1].parts:
            for value in _computed(part) if part.name not in self._loops else ():
                for target in self._stored[function.name].get(value, ()):
                    if constants := of_row.pop(row_of(target, length), {}):
                        beside.setdefault(value, {}).update(constants)
        return beside

    def _constants(self, group: Group, precision: Precision) -> Mapping[str, Mapping[str, Operand]]:
        """The constants that the group's parts store, likewise."""
        return self._beside[group.users[0]] if self._stores(group, precision) else {}

    def _shared(self, group: Group, value: str) -> bool:
        """Returns whether a part reads the value from the group's structure."""
        return value in self._read_of[group.name]

    def _stores(self, group: Group, precision: Precision) -> Mapping[str, list[str]]:
        """Targets by the values that the group's parts store."""
        of = self._stored.get(group.users[0], {}) if len(group.users) == 1 else {}
        return {} if precision.device else of

    def _only_stored(self, group: Group, value: str, precision: Precision) -> bool:
        return value in self._stores(group, precision) and not self._shared(group, value)

    def _outputs(self, group: Group, part: Program, precision: Precision) -> list[Argument]:
        """The outputs that a part stores."""
        stores = self._stores(group, precision)
        names = {target.partition("[")[0].lstrip("*") for x in _computed(part)
                 for target in stores.get(x, ())}
        return [a for a in outputs(self.scene.named(group.users[0])) if a.name in names] \
            if names else []

    def _copies(self, function: FunctionProgram, precision: Precision) -> dict[str, str]:
        """Names of copies of arguments, where parts store results."""
        if precision.device or function.name not in self._stored:
            return {}
        return {a.name: f"{a.name}_given" for a in function.inputs if a.quantity.shape}

    def _narrowed(self, precision: Precision) -> str:
        return f"({precision.c_type})" if self.wide else ""

    def _struct(self, group: Group, precision: Precision) -> str:
        return f"struct {c_name(self.scene, f'{group.name}_values', precision)}"

    def _working(self, precision: Precision) -> Precision:
        return precision.computing(self.wide)

    def _read(self, part: Program, precision: Precision) -> Callable[[Input], str]:
        """The text with which a part reads arguments and groups; a wide one converts arguments."""
        plain = self._access(part, "->")
        converted = read_by(part, precision, plain)
        return lambda x: (plain if part.inputs[x.argument].name in self._groups else converted)(x)

    def _member(self, group: Group, value: str, member: str) -> str:
        """The text of a value that a group keeps."""
        return f"{group.name}{member}{self._slots[group.name].get(value, value)}"

    def _returned(self, last: Program, precision: Precision, copies: Mapping[str, str]
                  ) -> Callable[[Input], str]:
        """The text of a result that a group or an argument holds, in this precision."""
        plain, narrowed = self._access(last, "."), self._narrowed(precision)

        def text(x: Input) -> str:
            name = last.inputs[x.argument].name
            if name in copies:
                return plain(x).replace(name, copies[name], 1)
            return narrowed + plain(x) if name in self._groups else plain(x)
        return text

    def _access(self, program: Program, member: str) -> Callable[[Input], str]:
        plain = access(program)

        def operand_text(operand: Input) -> str:
            name = program.inputs[operand.argument].name
            if name in self._groups:
                group = self._groups[name]
                return self._member(group, group.kept[operand.index], member)
            return plain(operand)
        return operand_text


def _computed(part: Program) -> tuple[str, ...]:
    """The values that a part gives, in order."""
    return tuple(dict.fromkeys(x.name for x in part.results if isinstance(x, Ref)))


def _indented(lines: Iterable[str]) -> str:
    return "\n".join(f"  {row}" for line in lines for row in line.split("\n"))
