"""Closed loops: the tables [loops.NAME]."""

from fractions import Fraction

from coscrew_codegen.scene.mechanism.joint_kind import Direction
from coscrew_codegen.scene.mechanism.loop import (
    HINGE,
    LAW,
    LOOP_KINDS,
    ROD,
    ClosedLoop,
    LoopEnd,
)
from coscrew_codegen.scene.mechanism.model import WORLD, Model
from coscrew_codegen.scene.mechanism.rotations import unit
from coscrew_codegen.scene.readers.laws import law
from coscrew_codegen.scene.readers.toml.keys import LOOP
from coscrew_codegen.scene.readers.toml.sum_terms import read_terms
from coscrew_codegen.scene.readers.toml.toml_tables import TomlTable, described

_ZERO = (Fraction(0),) * 3
_OF_HINGES = ("axis", "axis2")
_OF_LAWS = ("joints", "leaders", "polynomial")
_MOST = 10  # coefficients


def read_loops(file: TomlTable, model: Model) -> tuple[ClosedLoop, ...]:
    """The loops of the model, then those of the scene's tables.  Raises SceneError."""
    result = list(model.loops)
    for name, table in file.tables("loops"):
        loop = _loop(name, table, model)
        if any(x.name == name for x in result):
            table.refuse("", "the model has a loop of this name already; wanted another name")
        result.append(loop)
    return tuple(result)


def _loop(name: str, table: TomlTable, model: Model) -> ClosedLoop:
    table.only(*LOOP.names)
    kind = LOOP_KINDS[table.choice("kind", tuple(LOOP_KINDS))]
    for key, of in (*((x, HINGE) for x in _OF_HINGES), ("length", ROD),
                    *((x, LAW) for x in _OF_LAWS)):
        if key in table and kind is not of:
            table.refuse(key, f"is for loops of kind {of.name}; this one is of kind {kind.name}")
    if kind is LAW:
        return _law(name, table, model)
    bodies = _bodies(table, model)
    points = [table.numbers(key, (3,), _ZERO) for key in ("first", "second")]
    if kind is not HINGE:
        first, second = (LoopEnd(*x) for x in zip(bodies, points, strict=True))
        length = table.positive("length") if kind is ROD else Fraction(0)
        return ClosedLoop(name, kind, first, second, length)
    axis = _axis(table, "axis")
    axes = axis, _axis(table, "axis2") if "axis2" in table else axis
    first, second = (LoopEnd(body, point, axis=own)
                     for body, point, own in zip(bodies, points, axes, strict=True))
    return ClosedLoop(name, kind, first, second)


def _law(name: str, table: TomlTable, model: Model) -> ClosedLoop:
    if wrong := [x for x in ("bodies", "first", "second") if x in table]:
        table.refuse(wrong[0], f"is for other loops; a law has {', '.join(_OF_LAWS)}")
    if "joints" not in table:
        table.missing("joints", "weights by joint, as { elbow = 1 }")
    joints = read_terms(table.table("joints"), model)
    leaders = read_terms(table.table("leaders"), model) if "leaders" in table else ()
    return law(name, model.joints, joints, leaders, _polynomial(table, bool(leaders)))


def _polynomial(table: TomlTable, of_leaders: bool) -> tuple[Fraction, ...]:
    wanted = f"1 to {_MOST} numbers, [c0, c1, …]" if of_leaders else "one number, [c0], or leaders"
    given = table.value("polynomial", wanted)
    if not isinstance(given, list) or not 1 <= len(given) <= (_MOST if of_leaders else 1):
        table.refuse("polynomial", f"{described(given)}; wanted {wanted}")
    return table.as_numbers("polynomial", given, (len(given),))


def _axis(table: TomlTable, key: str) -> Direction:
    vector = table.numbers(key, (3,))
    if not any(vector):
        table.refuse(key, "is zero; wanted a direction")
    return unit(vector)


def _bodies(table: TomlTable, model: Model) -> tuple[str, ...]:
    """Two bodies that joints can move against each other."""
    if "bodies" not in table:
        table.missing("bodies", "a list of two bodies")
    bodies = table.texts("bodies")
    if len(bodies) != 2:
        table.refuse("bodies", f"a list of {len(bodies)}; wanted two bodies")
    links = model.links()
    first, second = (table.known("bodies", body, "body", links) for body in bodies)
    if links[first] == links[second]:
        of = "the world" if links[first] == WORLD else repr(links[first])
        table.refuse("bodies", f"fixed joints connect {first!r} and {second!r}, both to {of}; "
                     "wanted bodies that can move against each other")
    return first, second
