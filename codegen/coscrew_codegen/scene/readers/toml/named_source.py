"""The file that `model` names, of a scene or of a table [attach.NAME], and how it is read."""

from coscrew_codegen.scene.mechanism.joint_kind import JointKind
from coscrew_codegen.scene.readers.described_robots import SCHEME, robot_source
from coscrew_codegen.scene.readers.model_formats import reader_of, unknown
from coscrew_codegen.scene.readers.model_reader import ModelReader, ModelSource
from coscrew_codegen.scene.readers.scene_error import shown
from coscrew_codegen.scene.readers.toml.keys import BASES
from coscrew_codegen.scene.readers.toml.toml_tables import TomlTable


def source_of(table: TomlTable, implausible: str) -> tuple[ModelReader, ModelSource]:
    """The reader and the source that the keys `model`, `base`, `packages`, `arguments` and
    `leave_out` give.  Raises SceneError for a file that is not there, or that no reader reads."""
    named, folder = table.text("model"), table.file.parent
    source = ModelSource(
        folder / named, base_of(table), implausible,
        {x: folder / y for x, y in _words(table, "packages").items()},
        _words(table, "arguments"), table.texts("leave_out", ()))
    if named.startswith(SCHEME):
        try:
            source = robot_source(named, source)
        except ValueError as error:
            table.refuse("model", f"{shown(named)} {error}")
    reader = reader_of(source.path)
    if reader is None:
        table.refuse("model", f"{shown(named)} {unknown(source.path)}")
    if not source.path.exists():
        table.refuse("model", f"{shown(named)}: there is no such file; it is looked for in the "
                              "folder of the scene")
    return reader, source


def base_of(table: TomlTable) -> JointKind | None:
    """The kind of joint between the world and the root; None if the table names none."""
    return BASES[table.choice("base", tuple(BASES))] if "base" in table else None


def _words(table: TomlTable, key: str) -> dict[str, str]:
    """The texts in a table, by name."""
    inner = table.table(key)
    return {name: inner.text(name) for name in inner.values}
