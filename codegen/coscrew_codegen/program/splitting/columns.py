"""Finds columns: runs of instructions that do the same with other values, as solutions of a system
for several right-hand sides do.

A run has the instructions of one component, which is marked by the name of its value.  Runs are
alike if they have the same operations in the same order, on results of their own in the same
places.  Knows no language and no mechanics."""

from collections import Counter
from collections.abc import Hashable, Mapping, Sequence
from dataclasses import dataclass, replace

from coscrew_codegen.program.ops import Op
from coscrew_codegen.program.program import (
    Input,
    Instruction,
    Operand,
    Program,
    Ref,
    by_component,
)
from coscrew_codegen.program.values.quantity import Argument, Quantity

FEWEST = 4
"""Least number of columns for which a loop pays: as many as a vector of AVX2 holds."""
SHORTEST = 32
"""Least number of instructions of a column."""
LEAST = FEWEST * SHORTEST
"""Least number of instructions of a program whose columns can be a loop that pays."""
_MARK = "column_"
_APART = frozenset({Op.SELECT, Op.SIN, Op.COS, Op.SIN_ERROR, Op.COS_ERROR})
"""Operations that are written beside others: choices with their comparisons, sines with cosines."""


def marked(name: str) -> str:
    """The name of a value whose instructions may be a column."""
    return f"{_MARK}{name}"


def is_marked(component: str) -> bool:
    """Returns whether a component has such a name."""
    return component.rpartition(":")[2].startswith(_MARK)


def form(run: Mapping[Hashable, tuple[Op, Sequence[Hashable]]]) -> tuple[object, ...]:
    """Returns what alike runs have in common, empty if the run cannot be a column; `run` maps names
    of values to operations and operands."""
    if len(run) < SHORTEST or any(op in _APART for op, _ in run.values()):
        return ()
    own = {name: place for place, name in enumerate(run)}
    return tuple((op, *(own.get(x, "") for x in operands)) for op, operands in run.values())


@dataclass(frozen=True)
class AlikeColumns:
    """Runs that are alike, as a program of one of them.

    Its last input has the values from elsewhere that differ between columns: a row of `given` for
    each, with the operand of each column.  Its results are the values that are used elsewhere:
    `results` has their names, a row for each, with the name of each column's."""

    program: Program
    given: tuple[tuple[Operand, ...], ...]
    results: tuple[tuple[str, ...], ...]


def has_columns(program: Program) -> bool:
    """Returns whether a loop pays for some of the program's columns."""
    forms = Counter(form({Ref(x.name): (x.op, x.operands) for x in run})
                    for run in by_component(program) if is_marked(run[0].component))
    return any(count >= FEWEST for of, count in forms.items() if of)


def columns(program: Program, given: str) -> AlikeColumns | None:
    """The columns, if a program consists of columns; `given` names the additional input."""
    runs = list(by_component(program))
    forms = {form({Ref(x.name): (x.op, x.operands) for x in run}) for run in runs}
    if len(runs) < FEWEST or len(forms) > 1 or () in forms:
        return None
    names = {Ref(step.name): marked(str(n)) for n, step in enumerate(runs[0], 1)}
    differing: dict[tuple[Operand, ...], int] = {}

    def operand(of: tuple[Operand, ...]) -> Operand:
        if of[0] in names:
            return Ref(names[of[0]])
        return of[0] if len({*of}) == 1 else Input(
            len(program.inputs), differing.setdefault(of, len(differing)))

    steps, results, used = [], [], {x.name for x in program.results if isinstance(x, Ref)}
    for alike in zip(*runs, strict=True):
        first, row = alike[0], tuple(step.name for step in alike)
        operands = zip(*(step.operands for step in alike), strict=True)
        steps.append(Instruction(names[Ref(first.name)], first.op, tuple(map(operand, operands)),
                                 first.component))
        if used.intersection(row):
            results.append(row)
    rows = Argument(given, Quantity(given, (len(differing),), (), ""))
    return AlikeColumns(replace(
        program, inputs=(*program.inputs, rows), instructions=tuple(steps),
        results=tuple(Ref(names[Ref(row[0])]) for row in results)),
        tuple(differing), tuple(results))
