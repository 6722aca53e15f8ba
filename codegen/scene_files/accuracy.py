"""The table [accuracy] of a scene file."""

from collections.abc import Collection, Iterator

from coscrew_codegen.scene.scene import Scene, Tolerance
from coscrew_codegen.scene.selected import names
from coscrew_codegen.scene_files.tables import Table


def read_accuracy(file: Table, scene: Scene, selected: Collection[str]) -> tuple[Tolerance, ...]:
    """What is asked of functions, which are to be selected; steps have no tier."""
    table = file.table("accuracy")
    functions = [name for name in names(scene) if not name.startswith("step_")]
    for name in table.values:
        table.known(name, name, "function", functions)
        if name not in selected:
            table.refuse(name, "the function is not selected; wanted one of the scene's functions")
    return tuple(x for name in table.values for x in _of(table, name))


def _of(table: Table, function: str) -> Iterator[Tolerance]:
    if not isinstance(table.values[function], dict):
        yield Tolerance(function, "", _positive(table, function))
        return
    inner = table.table(function)
    if not inner.values:
        table.refuse(function, "an empty table; wanted a number, or numbers by output")
    for output in inner.values:
        yield Tolerance(function, output, _positive(inner, output))


def _positive(table: Table, key: str) -> float:
    number = float(table.number(key))
    if number <= 0:
        table.refuse(key, f"{number:g}; wanted a positive number")
    return number
