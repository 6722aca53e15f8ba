"""Cuts Programs into parts that are short enough to compile; values that several Programs compute
are in shared parts.

Programs share a value if it is the same operation on the same operands, whatever its name.  The
values that exactly the same programs use form a group: its parts compute them in the order of the
first of these programs.  A program that uses a value also uses its operands, so the groups of more
programs come first.

    program a:  x y z      group 1 (a, b): x z      a calls the parts of groups 1 and 2
    program b:  x z w      group 2 (a): y           b calls the parts of groups 1 and 3
                           group 3 (b): w

A group from which other groups read most values saves little text and costs the time to store and
load them: it is merged into the groups that read it.  For the same reason a program shares nothing
with much longer ones.  Comparisons are not stored: each part that needs one compares again.  Knows
no language and no mechanics."""

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from fractions import Fraction
from itertools import groupby
from typing import NamedTuple

from coscrew_codegen.program.ops import COMPARISONS, Op
from coscrew_codegen.program.program import (
    Constant,
    Input,
    Instruction,
    NotANumber,
    Operand,
    Program,
    Ref,
)
from coscrew_codegen.program.splitting.columns import FEWEST, form, is_marked
from coscrew_codegen.program.tables import TableColumn
from coscrew_codegen.program.values.quantity import Argument, Quantity

MOST_KEPT = Fraction(1, 4)
"""Largest fraction of a group's values that other groups may read.  Without merging, inverse
dynamics of 35 joints compiled by clang took 20 % longer than as one function, with it 2 %."""
LONGER = 3
"""Programs share values if the longest of them is at most so many times as long as the shortest.
Where inverse dynamics and the mass matrix of 35 joints shared values with their derivatives, which
read most of them, they took 1.3 and 1.5 times as long, and the derivatives 1.16 times."""


@dataclass(frozen=True)
class Group:
    """Values that exactly these programs compute: parts, in order, and the names of the values
    `kept` for other parts.  Parts read inputs of the programs, and groups as further inputs with an
    element for each kept value; their results are the kept values that they add."""

    name: str
    users: tuple[str, ...]  # names of the programs
    kept: tuple[str, ...]
    parts: tuple[Program, ...]


@dataclass(frozen=True)
class Cut:
    """A program in parts: those of its groups, in order, and then `last`, which has no steps: its
    results are values of groups, inputs and constants."""

    groups: tuple[Group, ...]
    last: Program


def cut(programs: Sequence[Program], longest: int, name: str = "shared", columns: bool = False
        ) -> dict[str, Cut]:
    """The programs in parts of at most `longest` steps (not counting comparisons), by name. A group
    has the name of its program, or if it has several, `name` and a number.  With `columns`, those
    that are alike are a part, of any length."""
    cuts: dict[str, Cut] = {}
    shared = 0
    for some in _of_similar_length(programs):
        values = _Values(some)
        cutting = _Cutting(some, values, _groups(values), longest, (name, shared), columns)
        cuts |= cutting.cuts()
        shared = cutting.shared
    return cuts


def _of_similar_length(programs: Sequence[Program]) -> Iterator[Sequence[Program]]:
    """The programs that share values with each other, in their order; the shortest ones first."""
    left = list(programs)
    while left:
        most = LONGER * min(len(x.instructions) for x in left)
        yield [x for x in left if len(x.instructions) <= most]
        left = [x for x in left if len(x.instructions) > most]


class _Given(NamedTuple):
    """An element of an input, by the input's name."""

    name: str
    place: int


_Operand = int | _Given | Constant | NotANumber | TableColumn
_Users = int
"""Programs: bit k stands for the program k."""


class _Values:
    """The values of programs, numbered, each once, with their operations and operands."""

    def __init__(self, programs: Sequence[Program]):
        self.steps: list[tuple[Op, tuple[_Operand, ...]]] = []
        self.compares: list[bool] = []
        self.users: list[_Users] = []
        self.names: list[dict[int, str]] = []  # by program: the names of its values, in order
        self.components: list[str] = []
        self._numbers: dict[tuple[Op, tuple[_Operand, ...]], int] = {}
        self.results = [self._program(k, program) for k, program in enumerate(programs)]

    def _program(self, place: int, program: Program) -> list[_Operand]:
        numbers: dict[str, int] = {}

        def known(x: Operand) -> _Operand:
            if isinstance(x, Ref):
                return numbers[x.name]
            if isinstance(x, Input):
                return _Given(program.inputs[x.argument].name, x.index)
            return x

        for step in program.instructions:
            number = self._number(step, tuple(map(known, step.operands)))
            self.users[number] |= 1 << place
            numbers[step.name] = number
        names: dict[int, str] = {}
        for name, number in numbers.items():
            names.setdefault(number, name)
        self.names.append(names)
        return [known(x) for x in program.results]

    def _number(self, step: Instruction, operands: tuple[_Operand, ...]) -> int:
        """The number of the value, a new one if it is new."""
        result = self._numbers.get((step.op, operands))
        if result is None and step.op.meaning.commutes:
            result = self._numbers.get((step.op, operands[::-1]))
        if result is None:
            result = len(self.steps)
            self._numbers[step.op, operands] = result
            self.steps.append((step.op, operands))
            self.compares.append(step.op in COMPARISONS)
            self.users.append(0)
            self.components.append(step.component)
        return result

    def called(self, users: _Users) -> dict[int, str]:
        """The names of values in the first of these programs, in its order."""
        return self.names[(users & -users).bit_length() - 1]

    def ordered(self, numbers: Sequence[int], users: _Users) -> list[int]:
        """The values in the order of the first of these programs."""
        wanted = set(numbers)
        return [x for x in self.called(users) if x in wanted]

    def read(self, operands: Sequence[_Operand]) -> Iterator[int]:
        """The values among the operands, and the operands of comparisons among them."""
        for x in operands:
            if isinstance(x, int):
                if self.compares[x]:
                    yield from self.read(self.steps[x][1])
                else:
                    yield x


def _groups(values: _Values) -> dict[_Users, list[int]]:
    """The values other than comparisons, by the programs that use them, those of most programs
    first; values of a merged group are in several groups, of disjoint programs."""
    groups: dict[_Users, list[int]] = {}
    homes: list[list[_Users]] = [[] if values.compares[x] else [users]
                                 for x, users in enumerate(values.users)]
    readers: dict[int, list[int]] = {}
    for number, group_users in enumerate(homes):
        for users in group_users:
            groups.setdefault(users, []).append(number)
            for x in values.read(values.steps[number][1]):
                readers.setdefault(x, []).append(number)
    for size in range(max(map(int.bit_count, groups), default=0), 1, -1):
        for users in sorted(x for x in groups if x.bit_count() == size):
            reading = [{home for reader in readers.get(x, ()) for home in homes[reader]
                        if home & users and home != users} for x in groups[users]]
            merged_into = _disjoint(users, set().union(*reading))
            if len(merged_into) > 1 and sum(map(bool, reading)) > MOST_KEPT * len(reading):
                members = groups.pop(users)
                for home in merged_into:
                    groups.setdefault(home, []).extend(members)
                for x in members:
                    homes[x] = [*(home for home in homes[x] if home != users), *merged_into]
    order = sorted(groups, key=lambda users: (-users.bit_count(), min(groups[users])))
    return {users: values.ordered(groups[users], users) for users in order}


def _disjoint(users: _Users, readers: Iterable[_Users]) -> list[_Users]:
    """The programs in sets such that the programs of each reader are in one set."""
    results: list[_Users] = []
    for reader in (*sorted(readers), *(1 << k for k in range(users.bit_length()))):
        if reader & users:
            touched = [x for x in results if x & reader]
            results = [*(x for x in results if x not in touched), sum(touched) | reader]
    return results


class _Cutting:
    """Groups of values, cut into parts."""

    def __init__(self, programs: Sequence[Program], values: _Values,
                 groups: Mapping[_Users, Sequence[int]], longest: int, name: tuple[str, int],
                 columns: bool):
        self.programs, self.values, self.longest = programs, values, longest
        self.with_columns = columns
        self.wide = any(program.wide for program in programs)
        self.pieces = {users: list(self._pieces(members)) for users, members in groups.items()}
        self.names, self.shared = self._names(*name)
        self.homes: dict[int, dict[_Users, int]] = {}  # of values: groups, and in which part
        for users, pieces in self.pieces.items():
            for part, piece in enumerate(pieces):
                for x in piece:
                    self.homes.setdefault(x, {})[users] = part
        kept = self._kept()
        self.kept = {users: [x for x in members if (users, x) in kept]
                     for users, members in groups.items()}
        self.places = {(users, x): k for users, result in self.kept.items()
                       for k, x in enumerate(result)}
        given = {a.name: a for program in programs for a in program.inputs}
        self.inputs = (*given.values(), *(_array(self.names[users], len(result))
                                          for users, result in self.kept.items()))

    def cuts(self) -> dict[str, Cut]:
        """Returns the cut of each program, by name."""
        groups = {users: self._group(users) for users in self.pieces}
        return {program.name: self._cut(program, tuple(
            group for users, group in groups.items() if users >> place & 1), place)
            for place, program in enumerate(self.programs)}

    def _cut(self, program: Program, groups: tuple[Group, ...], place: int) -> Cut:
        last = _Reader(self, 1 << place, {}).program(
            program.name, program.outputs, self.values.results[place])
        read = {a.name for group in groups for part in group.parts for a in part.inputs}
        unread = tuple(a for a in program.inputs if a.name not in read and a not in last.inputs)
        return Cut(groups, replace(last, inputs=(*last.inputs, *unread)))

    def _names(self, name: str, several: int) -> tuple[dict[_Users, str], int]:
        """Names of the groups that no program's steps, inputs and outputs have, and the last number
        in one of them; groups of several programs are numbered from `several` + 1 on."""
        taken = {name for program in self.programs for name in (
            *(a.name for a in (*program.inputs, *program.outputs)),
            *(step.name for step in program.instructions))}
        result = {}
        for users in self.pieces:
            several += users.bit_count() > 1
            of = (f"{name}_{several}" if users.bit_count() > 1
                  else self.programs[users.bit_length() - 1].name)
            while of in taken:
                of += "_"
            result[users] = of
        return result, several

    def _pieces(self, numbers: Sequence[int]) -> Iterator[list[int]]:
        """The values in parts, cut where headings change if possible, else where components change;
        columns that are alike are parts of their own."""
        piece: list[int] = []
        for block, alone in self._arranged(numbers):
            if piece and (alone or len(piece) + len(block) > self.longest):
                yield piece
                piece = []
            piece += block
            if alone:
                yield piece
                piece = []
        if piece:
            yield piece

    def _arranged(self, numbers: Sequence[int]) -> Iterator[tuple[Sequence[int], bool]]:
        """Blocks of values; True with all columns that are alike, which stand where the first is.
        """
        moved = self._columns(numbers) if self.with_columns else {}
        later = {x for runs in moved.values() for run in runs for x in run}
        place = 0
        while place < len(numbers):
            if runs := moved.get(numbers[place]):
                yield [x for run in runs for x in run], True
                place += len(runs[0])
                continue
            end = next((n for n in range(place, len(numbers)) if numbers[n] in moved),
                       len(numbers))
            yield from ((block, False) for block in self._blocks(
                [x for x in numbers[place:end] if x not in later]))
            place = end

    def _columns(self, numbers: Sequence[int]) -> dict[int, list[list[int]]]:
        """Columns that are alike and read nothing behind the first of them, by its first value."""
        places = {x: n for n, x in enumerate(numbers)}
        alike: dict[object, list[list[int]]] = {}
        for component, run in groupby(numbers, self.values.components.__getitem__):
            steps = list(run)
            if is_marked(component) and (of := form({x: self.values.steps[x] for x in steps})):
                runs = alike.setdefault(of, [steps])
                begin, own = places[runs[0][0]], set(steps)
                if steps is not runs[0] and all(
                        places.get(x, -1) < begin or x in own for step in steps
                        for x in self.values.read(self.values.steps[step][1])):
                    runs.append(steps)
        return {runs[0][0]: runs for runs in alike.values() if len(runs) >= FEWEST}

    def _blocks(self, numbers: Sequence[int]) -> Iterator[Sequence[int]]:
        """The values in pieces that are not too long; a piece is not cut."""
        components, longest = self.values.components, self.longest
        for _, below in groupby(numbers, lambda x: components[x].rpartition(":")[0]):
            block = list(below)
            if len(block) <= longest:
                yield block
                continue
            for _, towards in groupby(block, components.__getitem__):
                steps = list(towards)
                yield from (steps[k:k + longest] for k in range(0, len(steps), longest))

    def home(self, x: int, reader: _Users) -> _Users:
        """The group from which these programs read the value."""
        return next(users for users in self.homes[x] if users & reader)

    def _kept(self) -> set[tuple[_Users, int]]:
        """The values that are read outside their part, with their groups."""
        values = {(self.home(x, 1 << place), x) for place, results in enumerate(self.values.results)
                  for x in self.values.read(results)}
        for number, homes in self.homes.items():
            for x in self.values.read(self.values.steps[number][1]):
                for users, part in homes.items():
                    if self.homes[x].get(users) != part:
                        values.add((self.home(x, users), x))
        return values

    def _group(self, users: _Users) -> Group:
        name, names = self.names[users], self.values.called(users)
        parts = []
        for k, piece in enumerate(self.pieces[users], 1):
            reader = _Reader(self, users, {x: names[x] for x in piece})
            kept = [x for x in piece if (users, x) in self.places]
            parts.append(reader.program(f"part_{k}_of_{name}", (_array(name, len(kept)),), kept))
        return Group(name, tuple(p.name for k, p in enumerate(self.programs) if users >> k & 1),
                     tuple(names[x] for x in self.kept[users]), tuple(parts))


class _Reader:
    """A part of some of the programs while it is built: it computes the values with the given
    names."""

    def __init__(self, cutting: _Cutting, users: _Users, names: Mapping[int, str]):
        self.cutting, self.values, self.users = cutting, cutting.values, users
        self.names = names
        self.steps: list[tuple[str, Op, tuple[Operand | _Given, ...], str]] = []
        self._compared: dict[int, str] = {}
        for x in names:
            self._issue(x, names[x])

    def program(self, name: str, outputs: tuple[Argument, ...], results: Sequence[_Operand]
                ) -> Program:
        """The part with these results; it has the inputs that it reads."""
        read = tuple(map(self._read, results))
        used = {x.name for x in (*read, *(x for _, _, operands, _ in self.steps for x in operands))
                if isinstance(x, _Given)}
        inputs = tuple(a for a in self.cutting.inputs if a.name in used)
        numbers = {a.name: n for n, a in enumerate(inputs)}

        def operand(x: Operand | _Given) -> Operand:
            return Input(numbers[x.name], x.place) if isinstance(x, _Given) else x

        return Program(name, inputs, outputs, tuple(
            Instruction(of, op, tuple(map(operand, operands)), component)
            for of, op, operands, component in self.steps), tuple(map(operand, read)),
            self.cutting.wide)

    def _issue(self, x: int, name: str) -> None:
        op, operands = self.values.steps[x]
        read = tuple(map(self._read, operands))
        self.steps.append((name, op, read, self.values.components[x]))

    def _read(self, x: _Operand) -> Operand | _Given:
        if not isinstance(x, int):
            return x
        if x in self.names:
            return Ref(self.names[x])
        if not self.values.compares[x]:
            home = self.cutting.home(x, self.users)
            return _Given(self.cutting.names[home], self.cutting.places[home, x])
        if x not in self._compared:
            self._compared[x] = self.values.called(self.users)[x]
            self._issue(x, self._compared[x])
        return Ref(self._compared[x])


def _array(name: str, size: int) -> Argument:
    return Argument(name, Quantity(name, (size,), (), ""))
