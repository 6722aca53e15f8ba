"""The table [ranges] of a scene file."""

from collections.abc import Mapping, Sequence
from fractions import Fraction

from coscrew_codegen.scene.mechanism.assembly import followers
from coscrew_codegen.scene.mechanism.model import Joint
from coscrew_codegen.scene.mechanism.ranges import (
    ARGUMENTS,
    LIMITS,
    Interval,
    Intervals,
    Ranges,
    interval,
    limits,
    ranges_of_model,
    symmetric,
)
from coscrew_codegen.scene.mechanism.tree import tree_of
from coscrew_codegen.scene.names import toml_key
from coscrew_codegen.scene.readers.toml.keys import ENDS, RANGES
from coscrew_codegen.scene.readers.toml.toml_tables import Decimals, TomlTable, described
from coscrew_codegen.scene.scene import Scene

_LIMITS = "limits"
_WORDS = {"lower": "limits of its range", "velocity": "limit of its velocity",
          "effort": "limit of its effort"}
_ONE = "a number, its largest size, or { lower = …, upper = … }"


def read_ranges(file: TomlTable, scene: Scene) -> Ranges:
    """Reads the ranges of arguments; positions that the table leaves out lie between the limits of
    joints, and so do velocities, if joints have limits.  Raises SceneError."""
    table = file.table("ranges")
    table.only(*RANGES.names)
    joints = _joints(scene)
    for argument in ("q", "v"):
        if argument not in table:
            for joint in joints.values():
                _refuse_faults(table, argument, joint)
    ranges = ranges_of_model(tree_of(scene.model, bool(followers(scene))), scene.parameters)
    stated: dict[str, Intervals] = {}
    for argument in (x for x in ARGUMENTS if x in table):
        if argument == "t":
            stated[argument] = (_interval(table, "t", table.values["t"], from_zero=True),)
        elif argument == "p":
            stated[argument] = _parameters(table, scene, ranges.p)
        else:
            stated[argument] = _Coordinates(table, argument, ranges, joints).read()
    return ranges.stating(stated)


def limits_in_ranges(file: TomlTable, scene: Scene) -> set[tuple[str, str]]:
    """The limits of joints, as (joint, field), that the table takes."""
    table, used = file.table("ranges"), set[tuple[str, str]]()
    for argument, fields in LIMITS.items():
        given = table.values.get(argument, _LIMITS if argument != "tau" else ())
        for number, name in enumerate(_joints(scene)):
            own: object = given
            if isinstance(given, dict):
                own = given.get(name, _LIMITS if argument != "tau" else ())
            elif isinstance(given, list):
                own = given[number] if number < len(given) else ()
            if own == _LIMITS:
                used |= {(name, field) for field in fields}
    return used


def _joints(scene: Scene) -> Mapping[str, Joint]:
    """The joints with coordinates of their own, in order."""
    following = followers(scene)
    return {x.name: x for x in scene.model.joints if x.kind.moves and x.name not in following}


class _Coordinates:
    """Reads the ranges of q, v, a or tau: for all joints, by joint in a table, or in a list."""

    def __init__(self, table: TomlTable, argument: str, default: Ranges,
                 joints: Mapping[str, Joint]) -> None:
        self._table, self._argument, self._joints = table, argument, joints
        self._default = iter(default.by_name[argument])

    def read(self) -> Intervals:
        """The interval of each component."""
        table, key, given = self._table, self._argument, self._table.values[self._argument]
        if isinstance(given, dict):
            inner = table.table(key)
            for name in inner.values:
                inner.known(name, name, "joint with coordinates of its own", self._joints)
            each = [(inner, name, given.get(name)) for name in self._joints]
        elif isinstance(given, list):
            if len(given) != len(self._joints):
                table.refuse(key, f"a list of {len(given)}; wanted an entry for each of the "
                                  f"{len(self._joints)} joints: {', '.join(self._joints)}")
            each = [(table, key, value) for value in given]
        else:
            each = [(table, key, given)] * len(self._joints)
        return tuple(x for joint, (within, name, value) in zip(
            self._joints.values(), each, strict=True) for x in self._of(joint, within, name, value))

    def _of(self, joint: Joint, table: TomlTable, key: str, given: object) -> Sequence[Interval]:
        """The intervals of a joint's components; None leaves those of the model."""
        count = joint.kind.nq if self._argument == "q" else joint.kind.nv
        default = [next(self._default) for _ in range(count)]
        quaternions = joint.kind.quaternions if self._argument == "q" else ()
        free = [k for k in range(count) if not any(p.start <= k < p.stop for p in quaternions)]
        if given is None:
            _refuse_faults(table, self._argument, joint)
            return default
        if given == _LIMITS:
            return self._limits(joint, table, key) if free else default
        if isinstance(given, list):
            if len(given) != len(free):
                rest = ", quaternions left out" if quaternions else ""
                table.refuse(key, f"a list of {len(given)} for joint {joint.name!r}; wanted "
                                  f"{len(free)} entries{rest}")
            values = given
        elif not free and given is not self._table.values[self._argument]:
            table.refuse(key, f"joint {joint.name!r} has only a quaternion, of norm 1; wanted no "
                              "range, in a list of all joints []")
        else:
            values = [given] * len(free)
        for k, value in zip(free, values, strict=True):
            default[k] = _interval(table, key, value)
        return default

    def _limits(self, joint: Joint, table: TomlTable, key: str) -> Sequence[Interval]:
        """The interval between the limits of a joint, which must have them."""
        if self._argument not in LIMITS:
            table.refuse(key, f'"{_LIMITS}": a model has no limits of {self._argument}; wanted '
                              f"{_ONE}")
        _refuse_faults(table, self._argument, joint)
        between = limits(joint, self._argument)
        if between is None:
            what = _WORDS[LIMITS[self._argument][0]]
            table.refuse(key, f'"{_LIMITS}": joint {joint.name!r} has no {what}; wanted '
                              f"{self._argument} = {{ {toml_key(joint.name)} = … }} with {_ONE}")
        return [between]


def _refuse_faults(table: TomlTable, argument: str, joint: Joint) -> None:
    """Refuse limits that the model's file gives and that cannot be used."""
    for field in LIMITS.get(argument, ()):
        if fault := joint.fault(field):
            table.refuse(argument, f"joint {joint.name!r} has no {field} that can be used: {fault}")


def _parameters(table: TomlTable, scene: Scene, default: Intervals) -> Intervals:
    """The intervals of run-time parameters, by name; the others keep theirs."""
    inner = table.table("p")
    names = {x.name: x.index for x in scene.parameters}
    intervals = list(default)
    for name, value in inner.values.items():
        inner.known(name, name, "run-time parameter", names)
        intervals[names[name]] = _interval(inner, name, value)
    return tuple(intervals)


def _interval(table: TomlTable, key: str, given: object, from_zero: bool = False) -> Interval:
    """A number, the largest size (with `from_zero` the upper end), or a table of both ends."""
    if isinstance(given, dict):
        inner = TomlTable(table.file, table.key(key), given)
        inner.only(*ENDS.names)
        lower, upper = inner.number("lower"), inner.number("upper")
        if lower > upper:
            inner.refuse("lower", f"{float(lower):g} is above upper, {float(upper):g}")
        return interval(lower, upper)
    if not isinstance(given, Decimals | int | str) or isinstance(given, bool):
        table.refuse(key, f"{described(given)}; wanted {_ONE}")
    size = table.as_number(key, given)
    if size < 0:
        table.refuse(key, f"{float(size):g}; wanted 0 or more: {_ONE}")
    return interval(Fraction(0), size) if from_zero else symmetric(size)
