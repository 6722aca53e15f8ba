"""Tables [attach.NAME] and [frames.NAME]: bodies and frames fixed to those of a model."""

from collections.abc import Collection
from dataclasses import replace

from coscrew_codegen.scene.joints.fixed import JOINT as FIXED
from coscrew_codegen.scene.mechanism.assembly import ModelError, parents_first
from coscrew_codegen.scene.mechanism.inertia_checks import WARN, judged
from coscrew_codegen.scene.mechanism.model import HERE, WORLD, Body, Joint, Model
from coscrew_codegen.scene.mechanism.roundoff_cleanup import without_residues
from coscrew_codegen.scene.readers.scene_error import SceneError, shown
from coscrew_codegen.scene.readers.toml.keys import ATTACH, BODY, FRAME, PLACE
from coscrew_codegen.scene.readers.toml.toml_model import body, placement
from coscrew_codegen.scene.readers.toml.toml_tables import TomlTable

_KINDS = {"attach": ATTACH, "frames": FRAME}


def with_attached(file: TomlTable, model: Model, implausible: str) -> Model:
    """The model with the bodies of [attach] and the frames of [frames], by fixed joints.

    The same as if its file had these links and joints at its end.  With `implausible` "warn",
    impossible and massless inertias are accepted and listed in the model.  Raises SceneError."""
    tables = [(kind, *named) for kind in _KINDS for named in file.tables(kind)]
    if not tables:
        return model
    own = {x.name for x in model.bodies}
    _refuse_taken(tables, own)
    known = (WORLD, *own, *(name for _, name, _ in tables))
    massless: list[str] | None = [] if implausible == WARN else None
    bodies = {name: _body(kind, name, table, massless) for kind, name, table in tables}
    joints = tuple(_joint(kind, name, table, known, {x.name for x in model.joints})
                   for kind, name, table in tables)
    try:
        ordered = parents_first((*model.joints, *joints))
    except ModelError as error:
        where = {f"joint {joint.name!r}": table.where
                 for joint, (_, _, table) in zip(joints, tables, strict=True)}
        raise SceneError(file.file, where[error.element], error.problem) from None
    by_name = {x.name: x for x in model.bodies} | bodies
    attached = without_residues(replace(
        model, joints=ordered, bodies=tuple(by_name[joint.child] for joint in ordered),
        implausible=()))
    try:
        lines = (*model.implausible, *(massless or ()), *judged(attached, implausible).implausible)
    except ModelError as error:
        raise SceneError(file.file, error.element, error.problem) from None
    return replace(attached, implausible=tuple(dict.fromkeys(lines)))


def _refuse_taken(tables: list[tuple[str, str, TomlTable]], own: Collection[str]) -> None:
    """Refuse names of the model's bodies, and names that occur twice."""
    seen: dict[str, str] = {}
    for _, name, table in tables:
        if name == WORLD:
            table.refuse("", "this name is the world's; wanted another one")
        if name in own:
            table.refuse("", f"the model has a body {shown(name)} already; wanted another name")
        if name in seen:
            table.refuse("", f"[{seen[name]}] has this name already; wanted another one")
        if not name or not name.isprintable():
            table.refuse("", f"name {shown(name)}; wanted one line of text")
        seen[name] = table.where


def _body(kind: str, name: str, table: TomlTable, massless: list[str] | None) -> Body:
    table.only(*_KINDS[kind].names)
    if kind == "frames":
        return Body(name)
    if "mass" not in table:
        table.missing("mass", f"the mass in kg; a frame without mass is [frames.{name}]")
    of_body = {key: x for key, x in table.values.items() if key in BODY.names}
    return body(name, TomlTable(table.file, table.where, of_body), massless)


def _joint(kind: str, name: str, table: TomlTable, known: tuple[str, ...], taken: Collection[str]
           ) -> Joint:
    """The fixed joint, called attach.payload or frames.tool unless that name is taken."""
    on = table.known("body", table.text("body"), "body", [x for x in known if x != name])
    at = table
    if kind == "attach":
        at = table.table("place")
        at.only(*PLACE.names)
    called = f"{kind}.{name}"
    while called in taken:
        called += "_"
    return Joint(called, FIXED, on, name, placement(at) if at.values else HERE)
