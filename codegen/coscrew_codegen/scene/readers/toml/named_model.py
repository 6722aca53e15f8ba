"""The model of a scene file: of the file that its `model` names, or of its own tables."""

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, replace
from pathlib import Path

from coscrew_codegen.scene.joints.fixed import JOINT as FIXED
from coscrew_codegen.scene.mechanism.joint_kind import JointKind
from coscrew_codegen.scene.mechanism.model import HERE, WORLD, Joint, Model
from coscrew_codegen.scene.readers.attached_parts import attached
from coscrew_codegen.scene.readers.declared_effects import Effects
from coscrew_codegen.scene.readers.described_robots import SCHEME, robot_source
from coscrew_codegen.scene.readers.model_formats import reader_of, unknown
from coscrew_codegen.scene.readers.model_reader import ModelReader, ModelSource, Parts
from coscrew_codegen.scene.readers.scene_error import shown
from coscrew_codegen.scene.readers.toml.keys import ATTACH, BASES, BODY, FRAME, OF_MODEL, PLACE
from coscrew_codegen.scene.readers.toml.toml_model import body, joint, parts_of_tables, placement
from coscrew_codegen.scene.readers.toml.toml_tables import TomlTable


@dataclass(frozen=True)
class _Beside:
    """Parts that a table adds to a model; `to` is the body to which it fixes them."""

    table: TomlTable
    parts: Parts
    to: str = ""

    @property
    def names(self) -> tuple[tuple[str, str], ...]:
        """Its bodies and joints."""
        return (*(("body", x.name) for x in self.parts.bodies),
                *(("joint", x.name) for x in self.parts.joints))


def with_tables(file: TomlTable, main: Parts, source: ModelSource) -> Parts:
    """The parts of a model, with those of the tables beside it: the same as if its file had them at
    its end.  Raises SceneError, naming the table, for names that are there already."""
    own = list(_own(file, source)) if "model" in file else []
    joints = {x.name for y in (main, *(z.parts for z in own)) for x in y.joints}
    tables = [*own, *(_attached(name, table, source, joints)
                      for name, table in file.tables("attach")),
              *(_frame(name, table, joints) for name, table in file.tables("frames"))]
    if not tables:
        return main
    _refuse_taken(main, tables)
    _refuse_unknown(main, tables)
    _refuse_unmoved(main, own)
    return _joined(main, source, [x.parts for x in tables])


def _own(file: TomlTable, source: ModelSource) -> Iterator[_Beside]:
    for name, table in file.tables("bodies"):
        yield _Beside(table, _of_body(name, table, source))
    for name, table in file.tables("joints"):
        yield _Beside(table, Parts("", (), (joint(name, table),), elsewhere={
            f"joint {name!r}": (table.file, table.where)}))


def _of_body(name: str, table: TomlTable, source: ModelSource) -> Parts:
    if not name or not name.isprintable():
        table.refuse("", f"name {shown(name)}; wanted one line of text")
    massless: list[str] | None = [] if source.lenient else None
    own = body(name, table, massless)
    return Parts("", (own,), (), elsewhere={f"body {name!r}": (table.file, table.where)},
                 implausible=tuple(massless or ()))


def _attached(name: str, table: TomlTable, source: ModelSource, joints: set[str]) -> _Beside:
    """The body or the model, and the fixed joint attach.NAME."""
    table.only(*ATTACH.names)
    of_body = {key: x for key, x in table.values.items() if key in BODY.names}
    to = table.text("to")
    at = table.table("place")
    at.only(*PLACE.names)
    place = placement(at)
    if "model" not in table:
        for word in (x.name for x in OF_MODEL if x.name in table):
            table.refuse(word, "is for a `model`; wanted none")
        if "mass" not in table:
            table.missing("mass", "the mass in kg, or `model`, a file; a frame without mass is "
                          f"[frames.{name}]")
        parts = _of_body(name, TomlTable(table.file, table.where, of_body), source)
        return _fixed(name, table, parts, Joint(_free("attach", name, joints), FIXED, to, name,
                                                place))
    for key in of_body:
        table.refuse(key, "the model that `model` names has masses; wanted one of both")
    prefix = table.text("prefix", f"{name}_")
    if not prefix.isprintable():
        table.refuse("prefix", f"{shown(prefix)}; wanted text on one line")
    reader, of_file = source_of(table, source.implausible)
    parts = attached(reader.parts_of(of_file), of_file, to, place, prefix,
                     _free("attach", name, joints))
    return _Beside(table, parts, to)


def _frame(name: str, table: TomlTable, joints: set[str]) -> _Beside:
    """A body without mass, and the fixed joint frames.NAME."""
    table.only(*FRAME.names)
    of_body = TomlTable(table.file, table.where, {})
    at = TomlTable(table.file, table.where, {
        key: x for key, x in table.values.items() if key in PLACE.names})
    parts = _of_body(name, of_body, ModelSource(table.file))
    return _fixed(name, table, parts, Joint(_free("frames", name, joints), FIXED, table.text("to"),
                                            name, placement(at) if at.values else HERE))


def _fixed(name: str, table: TomlTable, parts: Parts, by: Joint) -> _Beside:
    places = parts.elsewhere[f"body {name!r}"]
    return _Beside(table, replace(parts, joints=(by,), elsewhere={
        **parts.elsewhere, f"joint {by.name!r}": places}), by.parent)


def _free(kind: str, name: str, joints: set[str]) -> str:
    """A name for the fixed joint, attach.payload unless a joint has it."""
    called = f"{kind}.{name}"
    while called in joints:
        called += "_"
    joints.add(called)
    return called


def _refuse_taken(main: Parts, tables: list[_Beside]) -> None:
    """Refuse names that the model has, and names that occur twice."""
    seen = {(what, x.name): "" for what, of in (("body", main.bodies), ("joint", main.joints))
            for x in of}
    for beside in tables:
        for what, name in beside.names:
            if (what, name) in seen:
                _refuse_name(beside.table, what, name, seen[what, name])
            seen[what, name] = beside.table.where


def _refuse_name(table: TomlTable, what: str, name: str, where: str) -> None:
    there = f"[{where}] has this name" if where and "model" not in table else \
        f"[{where}] has a {what} {shown(name)}" if where else \
        f"the model has a {what} {shown(name)}"
    if "model" in table:
        table.refuse("prefix", f"{there} already, and so has {shown(table.text('model'))} with "
                     "this prefix; wanted another one")
    table.refuse("", f"{there} already; wanted another name")


def _refuse_unknown(main: Parts, tables: list[_Beside]) -> None:
    """Refuse `to` of bodies that are not there, or are fixed by it."""
    names = [WORLD, *(x.name for of in (main, *(y.parts for y in tables)) for x in of.bodies)]
    for beside in tables:
        if beside.to:
            own = {name for what, name in beside.names if what == "body"}
            beside.table.known("to", beside.to, "body", [x for x in names if x not in own])


def _refuse_unmoved(main: Parts, own: list[_Beside]) -> None:
    """Refuse bodies of tables that no joint moves, and joints of bodies that have one."""
    movers = {x.child: x.name for x in main.joints}
    moved = {x.child for y in own for x in y.parts.joints}
    for beside in own:
        for x in beside.parts.joints:
            if x.child in movers:
                beside.table.refuse("child", f"{shown(x.child)} is moved by joint "
                                    f"{shown(movers[x.child])} already; wanted another body")
        for y in beside.parts.bodies:
            if y.name not in moved:
                beside.table.refuse("", "no joint moves it; wanted [joints.NAME] with child = "
                                    f"{shown(y.name)}, or [attach.{y.name}] with `to`, which "
                                    "fixes it to a body")


def _joined(main: Parts, source: ModelSource, others: list[Parts]) -> Parts:
    """The parts of all, the model's first; its root has a joint to the world, unless one of the
    others moves it."""
    empty = Model(main.name, (), ())  # all models are attached, to the world
    tree, every = main.tree(source) if main.bodies or main.joints else empty, (main, *others)
    moved = {x.child for y in others for x in y.joints}
    own = {x.name for x in main.joints}
    kept = [x for x in tree.joints if x.name in own or x.child not in moved]
    return replace(
        main, bodies=(*tree.bodies, *(x for y in others for x in y.bodies)),
        joints=(*kept, *(x for y in others for x in y.joints)), base=FIXED, roots={},
        effects=_merged([x.effects for x in every]), offered=_merged([x.offered for x in every]),
        mimic_places={key: x for y in every for key, x in y.mimic_places.items()},
        elsewhere={key: x for y in others for key, x in y.elsewhere.items()},
        implausible=tuple(x for y in every for x in y.implausible),
        notices=tuple(x for y in every for x in y.notices),
        collisions=tuple(x for y in every for x in y.collisions),
        loops=tuple(x for y in every for x in y.loops))


def _merged(tables: list[Effects]) -> Effects:
    """The tables of all, by effect."""
    whole: dict[str, Mapping[str, object]] = {}
    for name, table in ((x, y) for effects in tables for x, y in effects.items()):
        whole[name] = {**whole.get(name, {}), **table}
    return whole


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
