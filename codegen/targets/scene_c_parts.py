"""Long functions of a scene in C: in parts, each a function of its own, those that several of the
functions need written once.

Compilers take time that grows faster than a function's length, so no part is long.  What parts hand
on to each other stands in structures on the stack of the function that calls them.
"""

from collections.abc import Callable, Collection, Iterator, Mapping, Sequence
from itertools import groupby

from coscrew_codegen.formats import DOUBLE, Precision
from coscrew_codegen.program import Input, Program, Ref
from coscrew_codegen.program.parts import Cut, Group, cut
from coscrew_codegen.recording.recorder import headings
from coscrew_codegen.scene_functions import Function, SceneFunctions
from coscrew_codegen.targets import scene_c_arguments as arguments
from coscrew_codegen.targets.c_function import Body, CFunction, Stored
from coscrew_codegen.targets.c_nested import declarations, language
from coscrew_codegen.targets.c_statements import WIDTH, comment_of, listed
from coscrew_codegen.targets.nesting import Assignment, Nesting, Plan
from coscrew_codegen.targets.scene_text import VALUE_WIDTH, access, c_name, outputs, printable

LONG = 4000
"""Instructions of a scene's longest function up to which all are written whole: those of arms with
seven joints are shorter, and would be slower in parts."""
LONGEST = 600
"""Instructions of a part, at most: those of a few links."""


def cuts(plans: Sequence[Plan]) -> dict[str, Cut]:
    """Functions in parts, by name: if one of the scene's is long, those longer than a part."""
    programs = [plan.program for plan in plans]
    if max((len(x.instructions) for x in programs), default=0) <= LONG:
        return {}
    return cut([x for x in programs if len(x.instructions) > LONGEST], LONGEST)


class Parts:
    """The functions of a scene that are cut, in a precision."""

    def __init__(self, scene: SceneFunctions, plans: Sequence[Plan], cuts: Mapping[str, Cut],
                 precision: Precision):
        self.scene, self.cuts, self.precision = scene, cuts, precision
        self._assigned = {plan.program.name: plan.assigned for plan in plans}
        self._groups = {group.name: group for found in cuts.values() for group in found.groups}
        self._words = {f.program.instructions[place].component.rpartition(":")[0]: printable(words)
                       for f in scene.functions if f.name in cuts for place, words in f.headings}
        self._inputs = {a.name: a for f in scene.functions for a in f.program.inputs}
        self._written: set[str] = set()

    def above(self, function: Function) -> Iterator[CFunction]:
        """The parts that the function calls, but those that stand above another already."""
        for group in self.cuts[function.name].groups:
            if group.name not in self._written:
                self._written.add(group.name)
                yield from self._parts(group)

    def body(self, function: Function) -> str:
        """Calls of the function's parts, and the results."""
        found = self.cuts[function.name]
        declared = [f"{self._struct(group)} {group.name};" for group in found.groups]
        calls = [self._call(group, part) for group in found.groups for part in group.parts]
        rest = Body(found.last, self.precision, Stored(
            self._access(found.last, "."), arguments.targets(outputs(function)),
            [a.name for a in outputs(function)])).text()
        return "\n".join(f"  {row}" for line in (*declared, *calls)
                         for row in line.split("\n")) + "\n" + rest

    def _parts(self, group: Group) -> Iterator[CFunction]:
        *others, last = group.users
        of = f"{', '.join(others)} and {last}" if others else last
        struct = "\n".join((
            comment_of([f"What parts of {of} hand on."]), f"{self._struct(group)} {{",
            "  " + listed(f"{self.precision.c_type} ", group.kept, ";", WIDTH - 2)
            .replace("\n", "\n  "), "};", "", ""))
        for part in group.parts:
            yield self._part(group, part, struct)
            struct = ""

    def _part(self, group: Group, part: Program, above: str) -> CFunction:
        names = ", ".join(dict.fromkeys(printable(words) for _, words in headings(part)))
        rows = (row for line in self._lines(group, part) for row in line.split("\n"))
        return CFunction(
            part.name, above + comment_of([f"Of {names}."]),
            arguments.head(c_name(self.scene, part.name, self.precision),
                           [self._parameter(x, group) for x in self._taken(group, part)],
                           f"{self.scene.name.upper()}_PART"),
            "\n".join(f"  {row}" for row in rows), internal=True)

    def _lines(self, group: Group, part: Program) -> Iterator[str]:
        """Declarations, and stores of what is kept as soon as it is known: nothing else reads the
        group yet, and what waits for the end takes registers."""
        kept = {x.name for x in part.results if isinstance(x, Ref)}
        above = {place: self._words.get(words, printable(words)) for place, words in headings(part)}
        plan = _planned(part, self._assigned[group.users[0]] | kept, self._access(part, "->"))
        nesting = plan.printed(language(part, self.precision), self._access(part, "->"), above)
        for _, run in groupby(nesting.assigned, lambda x: x if isinstance(x, str)
                              else x.step.component):
            lines = list(run)
            yield from declarations(lines, self.precision, WIDTH - 2)
            names = [x.step.name for x in lines if isinstance(x, Assignment)]
            yield from (f"{group.name}->{x} = {x};" for x in names if x in kept)

    def _taken(self, group: Group, part: Program) -> list[str]:
        """Names of what a part takes: what it reads, and its group."""
        return [a.name for a in part.inputs if a.name != group.name] + [group.name]

    def _parameter(self, name: str, own: Group) -> str:
        if name in self._groups:
            const = "" if name == own.name else "const "
            return f"{const}{self._struct(self._groups[name])} *{name}"
        return arguments.read(self._inputs[name], self.precision)

    def _call(self, group: Group, part: Program) -> str:
        taken = [f"&{x}" if x in self._groups else x for x in self._taken(group, part)]
        return listed(f"{c_name(self.scene, part.name, self.precision)}(", taken, ");", WIDTH - 2)

    def _struct(self, group: Group) -> str:
        return f"struct {c_name(self.scene, f'{group.name}_values', self.precision)}"

    def _access(self, program: Program, member: str) -> Callable[[Input], str]:
        plain = access(program)

        def found(operand: Input) -> str:
            name = program.inputs[operand.argument].name
            if name in self._groups:
                return f"{name}{member}{self._groups[name].kept[operand.index]}"
            return plain(operand)
        return found


def _planned(part: Program, named: Collection[str], access: Callable[[Input], str]) -> Plan:
    """The part's plan; what plans of functions have `named` is called so."""
    found = Nesting(part, language(part, DOUBLE), access, VALUE_WIDTH,
                    named=lambda step: step.name in named)
    return Plan(part, frozenset(x.step.name for x in found.assigned if isinstance(x, Assignment)))
