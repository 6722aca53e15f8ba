"""The model of a scene file: of the file that its `model` names, or of its own tables."""

from collections.abc import Mapping
from pathlib import Path

from coscrew_codegen.scene.mechanism.model import Model
from coscrew_codegen.scene.readers.model_formats import reader_of, unknown
from coscrew_codegen.scene.readers.model_reader import ModelSource
from coscrew_codegen.scene.readers.scene_error import shown
from coscrew_codegen.scene.readers.toml.keys import BASES
from coscrew_codegen.scene.readers.toml.toml_model import read_model
from coscrew_codegen.scene.readers.toml.toml_tables import TomlTable

_OF_PROGRAMS = ("packages", "arguments")


def model_of(file: TomlTable, name: str, implausible: str, packages: Mapping[str, Path],
             arguments: Mapping[str, str], leave_out: tuple[str, ...]) -> Model:
    """The model; `packages`, `arguments` and `leave_out` are those given besides the scene's own.
    """
    base = BASES[file.choice("base", tuple(BASES))] if "base" in file else None
    own = [key for key in ("bodies", "joints") if key in file]
    if "model" not in file:
        for key, given in zip(_OF_PROGRAMS, (packages, arguments), strict=True):
            if key in file or given:
                file.refuse(key, "is for a `model` that is a file of xacro; wanted none")
        if "leave_out" in file or leave_out:
            file.refuse("leave_out", "is for a `model` that is a file of MuJoCo; wanted none")
        if not own:
            file.missing("model", "a model's file, or tables [bodies.NAME] and [joints.NAME]")
        return read_model(file, name, base, implausible)
    if own:
        file.refuse(own[0], "the model comes from the file that `model` names; wanted one of both")
    named = Path(file.text("model"))
    path = file.file.parent / named
    reader = reader_of(path)
    if reader is None:
        file.refuse("model", f"{shown(str(named))} {unknown(path)}")
    if not path.exists():
        file.refuse("model", f"{shown(str(named))}: there is no such file; it is looked for in the "
                             "folder of the scene")
    folders = {x: file.file.parent / y for x, y in _words(file, "packages").items()}
    return reader.read(ModelSource(path, base, implausible, {**folders, **packages},
                                   {**_words(file, "arguments"), **arguments},
                                   (*file.texts("leave_out", ()), *leave_out)))


def _words(file: TomlTable, key: str) -> dict[str, str]:
    """The texts in a table, by name."""
    table = file.table(key)
    return {name: table.text(name) for name in table.values}
