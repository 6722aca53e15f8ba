"""The parts of a model that is attached to a body of another: renamed, and rooted there."""

from collections.abc import Collection, Mapping
from dataclasses import replace
from pathlib import Path

from coscrew_codegen.scene.joints.fixed import JOINT as FIXED
from coscrew_codegen.scene.joints.free import JOINT as FREE
from coscrew_codegen.scene.mechanism.collision import Collision
from coscrew_codegen.scene.mechanism.loop import ClosedLoop, Law
from coscrew_codegen.scene.mechanism.model import WORLD, Joint, Placement
from coscrew_codegen.scene.mechanism.notices import Notice
from coscrew_codegen.scene.mechanism.rotations import turned
from coscrew_codegen.scene.mechanism.tree import composed
from coscrew_codegen.scene.readers.declared_effects import Effects
from coscrew_codegen.scene.readers.model_reader import ModelSource, Parts
from coscrew_codegen.scene.readers.scene_error import SceneError

_OF_BODIES, _OF_JOINTS = ("body", "bodies"), ("joint", "joints")
"""Keys of effects under which names of bodies and joints stand."""


def attached(parts: Parts, source: ModelSource, to: str, at: Placement, prefix: str, joint: str
             ) -> Parts:
    """The parts with the model's world at the place `at` of the body `to`, names that begin with
    the prefix, and the `joint` that fixes its root to that body.

    Raises SceneError for anything but one tree, a root that the file lets float, unless `to` is the
    world, and a mass of the world."""
    base = source.base or FIXED
    tree = parts.tree(replace(source, base=base))
    own = {x.name for x in parts.joints}
    for x in tree.joints:
        if x.parent == WORLD and x.kind is FREE and to != WORLD:
            problem = f'joint {x.name!r} lets its root float, and {to!r} is to hold it; wanted '
            raise SceneError(source.path, parts.where(f"joint {x.name!r}", source)[1], problem + (
                'a file without this joint, or to = "world"' if x.name in own else
                'base = "fixed", or to = "world"'))
    for body in parts.bodies:
        if body.name == WORLD and body.inertia:
            raise SceneError(*parts.where(f"body {WORLD!r}", source), "has a mass, and stands for "
                             f"{to!r} here; wanted another name")
    joints = tuple(_joint(x, to, at, prefix, joint if x.name not in own else f"{prefix}{x.name}")
                   for x in tree.joints)
    bodies = tuple(replace(x, name=f"{prefix}{x.name}") for x in tree.bodies)
    shapes = tuple(_shape(x, to, at, prefix) for x in parts.collisions)
    return _renamed(replace(parts, bodies=bodies, joints=joints, collisions=shapes,
                            loops=tuple(_loop(x, to, at, prefix) for x in parts.loops)), parts,
                    source, prefix)


def _joint(joint: Joint, to: str, at: Placement, prefix: str, name: str) -> Joint:
    """The joint by its new name; those at the model's world are at the body that it is attached
    to."""
    held = joint.parent == WORLD
    mimic = joint.mimic and replace(joint.mimic, joint=f"{prefix}{joint.mimic.joint}")
    return replace(joint, name=name, child=f"{prefix}{joint.child}", mimic=mimic,
                   parent=to if held else f"{prefix}{joint.parent}",
                   placement=composed(at, joint.placement) if held else joint.placement)


def _shape(shape: Collision, to: str, at: Placement, prefix: str) -> Collision:
    """The collision shape by its body's new name; those of the model's world are at the body that
    it is attached to."""
    if shape.body != WORLD:
        return replace(shape, body=f"{prefix}{shape.body}")
    place = composed(at, Placement(shape.R, shape.t))
    return replace(shape, body=to, t=place.t, R=place.R)


def _loop(loop: ClosedLoop, to: str, at: Placement, prefix: str) -> ClosedLoop:
    """The loop by its new name, and those of its bodies; points of the model's world are of the
    body that it is attached to."""
    first, second = (
        replace(x, body=f"{prefix}{x.body}") if x.body != WORLD else
        replace(x, body=to, point=composed(at, Placement(x.R, x.point)).t,
                R=composed(at, Placement(x.R, x.point)).R,
                axis=turned(at.R, x.axis))
        for x in (loop.first, loop.second))
    return replace(loop, name=f"{prefix}{loop.name}", first=first, second=second,
                   law=loop.law and _law(loop.law, prefix))


def _law(law: Law, prefix: str) -> Law:
    """The law by the new names of its joints and bodies."""
    joints, leaders = (tuple(replace(x, joint=f"{prefix}{x.joint}") for x in of)
                       for of in (law.joints, law.leaders))
    return replace(law, joints=joints, leaders=leaders,
                   bodies=tuple(f"{prefix}{x}" for x in law.bodies))


def _renamed(parts: Parts, old: Parts, source: ModelSource, prefix: str) -> Parts:
    """The parts with places, effects and notices under the new names."""
    elsewhere: dict[str, tuple[Path, str]] = {}
    for what, names in (("body", (x.name for x in old.bodies)),
                        ("joint", (x.name for x in old.joints))):
        elsewhere |= {f"{what} {f'{prefix}{x}'!r}": old.where(f"{what} {x!r}", source)
                      for x in names}
    mimics = {f"{prefix}{x}": place for x, place in old.mimics_by_file(source).items()}
    lines = tuple(f"{source.path.name}: {x}" for x in old.implausible)
    return replace(parts, places={}, mimic_places=mimics, elsewhere=elsewhere, roots={}, start={},
                   base=FIXED, implausible=lines, inputs=(),
                   effects=_effects(old, old.effects, prefix),
                   offered=_effects(old, old.offered, prefix),
                   notices=tuple(_notice(x, source, prefix) for x in old.notices))


def _notice(notice: Notice, source: ModelSource, prefix: str) -> Notice:
    """The notice of an element that has another name now."""
    word, _, name = notice.of.partition(" ")
    of = f"{word} {prefix}{name}" if name else notice.of
    text = notice.text.removeprefix(f"{notice.of}: ")
    return replace(notice, of=of, text=f"{of}: {text}" if text != notice.text else
                   f"{source.path.name}: {text}")


def _effects(parts: Parts, effects: Effects, prefix: str) -> Effects:
    """The effects on joints and bodies by their new names; those of the whole scene, as gravity,
    are the scene's own."""
    bodies, joints = ({x.name for x in of} for of in (parts.bodies, parts.joints))
    tables: dict[str, Mapping[str, object]] = {}
    for name, table in effects.items():
        if table and all(isinstance(x, Mapping) for x in table.values()):
            tables[name] = {f"{prefix}{on}": {key: _value(
                x, prefix, bodies if key in _OF_BODIES else joints if key in _OF_JOINTS else ())
                for key, x in values.items()}
                for on, values in table.items() if isinstance(values, Mapping)}
    return tables


def _value(value: object, prefix: str, names: Collection[str]) -> object:
    """A value of an effect, with the prefix before those of these names that stand in it."""
    if isinstance(value, str):
        return f"{prefix}{value}" if value in names else value
    if isinstance(value, Mapping):
        return {_value(key, prefix, names): x for key, x in value.items()}
    return [_value(x, prefix, names) for x in value] if isinstance(value, list | tuple) else value
