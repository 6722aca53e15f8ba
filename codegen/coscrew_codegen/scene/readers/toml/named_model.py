"""The model of a scene file: of the file that its `model` names, or of its own tables."""

from collections.abc import Mapping
from dataclasses import replace
from pathlib import Path

from coscrew_codegen.scene.mechanism.model import Model
from coscrew_codegen.scene.readers.model_reader import ModelSource, Parts
from coscrew_codegen.scene.readers.toml.attached import with_tables
from coscrew_codegen.scene.readers.toml.named_source import base_of, source_of
from coscrew_codegen.scene.readers.toml.toml_model import parts_of_tables
from coscrew_codegen.scene.readers.toml.toml_tables import TomlTable

_OF_PROGRAMS = ("packages", "arguments")


def model_of(file: TomlTable, name: str, implausible: str, packages: Mapping[str, Path],
             arguments: Mapping[str, str], leave_out: tuple[str, ...]) -> Model:
    """The model, with what the scene's tables add to it; `packages`, `arguments` and `leave_out`
    are those given besides the scene's own.  Raises SceneError."""
    if "model" not in file:
        main, source = _of_tables(file, name, implausible, packages, arguments, leave_out)
    else:
        reader, given = source_of(file, implausible)
        source = replace(given, packages={**given.packages, **packages},
                         arguments={**given.arguments, **arguments},
                         leave_out=(*given.leave_out, *leave_out))
        main = reader.parts_of(source)
    whole = with_tables(file, main, source)
    return whole.model(source if whole is main else replace(source, base=None))


def _of_tables(file: TomlTable, name: str, implausible: str, packages: Mapping[str, Path],
               arguments: Mapping[str, str], leave_out: tuple[str, ...]
               ) -> tuple[Parts, ModelSource]:
    for key, given in zip(_OF_PROGRAMS, (packages, arguments), strict=True):
        if key in file or given:
            file.refuse(key, "is for a `model` that is a file of xacro; wanted none")
    if "leave_out" in file or leave_out:
        file.refuse("leave_out", "is for a `model` that is a file of MuJoCo; wanted none")
    if "bodies" not in file and "joints" not in file:
        if "attach" not in file:
            file.missing("model", "a model's file, or tables [bodies.NAME] and [joints.NAME]")
        if "base" in file:
            file.refuse("base", "no model here has a root of its own; wanted it in [attach.NAME]")
    source = ModelSource(file.file, base_of(file), implausible)
    return parts_of_tables(file, name, source), source
