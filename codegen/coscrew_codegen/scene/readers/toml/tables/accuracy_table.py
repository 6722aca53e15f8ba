"""The table [accuracy] of a scene file."""

from collections.abc import Collection, Iterator

from coscrew_codegen.scene.function_selection import all_names
from coscrew_codegen.scene.functions import functions_of
from coscrew_codegen.scene.mechanism.assembly import followers
from coscrew_codegen.scene.readers.scene_error import SceneError
from coscrew_codegen.scene.readers.toml.toml_tables import Decimals, TomlTable
from coscrew_codegen.scene.scene import Scene, Tolerance


def read_accuracy(file: TomlTable, scene: Scene, selected: Collection[str]) -> tuple[Tolerance,
                                                                                     ...]:
    """Reads the accuracies requested of functions, which must be selected; steps have no tier."""
    table = file.table("accuracy")
    steps = {x.name for x in functions_of(scene) if x.step}
    functions = [name for name in all_names(scene) if name not in steps]
    for name in table.values:
        if name in steps:
            table.refuse(name, "steps have no tier; wanted functions that they call")
        table.known(name, name, "function", functions)
        if name not in selected:
            table.refuse(name, "the function is not selected; wanted one of the scene's functions")
    return tuple(x for name in table.values for x in _of(table, name))


def limits_used(scene: Scene, accuracy: Collection[Tolerance]) -> set[tuple[str, str]]:
    """The limits of joints, as (joint, field), between which states are drawn for these."""
    fields = {"lower", "upper"}
    of = {x.function for x in accuracy}
    for takes in (x.takes for x in functions_of(scene, of) if x.name in of):
        if not {*takes} <= {"q"}:
            fields.add("velocity")
        if "tau" in takes:
            fields.add("effort")
    return {(joint.name, field) for joint in scene.model.joints for field in fields
            if joint.kind.moves and joint.name not in followers(scene)}


def refuse_faults(file: TomlTable, scene: Scene, used: Collection[tuple[str, str]]) -> None:
    """Refuse limits, as (joint, field), that are given and cannot be used."""
    for joint in scene.model.joints:
        for fault in joint.faults:
            if (joint.name, fault.field) in used:
                file.refuse("accuracy", f"states are drawn between limits, and joint "
                            f"{joint.name!r} has no {fault.field} that can be used: "
                            f"{fault}")


def _of(table: TomlTable, function: str) -> Iterator[Tolerance]:
    if not isinstance(table.values[function], dict):
        yield Tolerance(function, "", _positive(table, function))
        return
    inner = table.table(function)
    if not inner.values:
        table.refuse(function, "an empty table; wanted a number, or numbers by output")
    for output in inner.values:
        yield Tolerance(function, output, _positive(inner, output))


def _positive(table: TomlTable, key: str) -> float:
    try:
        number = float(table.number(key))
    except SceneError as error:
        if not isinstance(table.values[key], str) or isinstance(table.values[key], Decimals):
            raise
        table.refuse(key, f"{error.problem.partition(';')[0]}; wanted a number, in the unit of the "
                          "results")
    if number <= 0:
        table.refuse(key, f"{number:g}; wanted a positive number")
    return number
