"""Quantities of a simulation, and their names in `record` and `expect`.

    q, v, a                   of all joints;  q.JOINT of one,  q.JOINT.2 one component
    energy                    kinetic, potential, total, in J;  energy.kinetic one of them
    momentum, momentum.2      linear and angular, about the world's origin
    power                     of the effects without potential energy, in W
    pose.BODY                 its 12 numbers [R | t], row by row;  pose.BODY.3 one of them
    position.BODY             its origin in the world;  position.BODY.x is position.BODY.0
    twist.BODY                velocity and angular velocity in its own frame
    reaction.JOINT            force and moment it transmits, in its child's frame
    EFFECT.WHERE.torque       and others of each effect: see `effect_quantities`
"""

from collections.abc import Iterable, Mapping
from dataclasses import dataclass

from coscrew_codegen.scene.effect_quantities import lacks, quantities_by_name, units_of
from coscrew_codegen.scene.model import Joint, Kind, Mimic
from coscrew_codegen.scene.names import did_you_mean, nearest, or_mean
from coscrew_codegen.scene.scene import Scene

ENERGIES = ("kinetic", "potential", "total")
XYZ = ("x", "y", "z")
"""Alternative names of the components 0, 1 and 2 of vectors of three."""

UNITS = {"q": {"revolute": ("rad",), "prismatic": ("m",), "spherical": ("1",) * 4,
               "free": ("m",) * 3 + ("1",) * 4},
         "v": {"revolute": ("rad/s",), "prismatic": ("m/s",), "spherical": ("rad/s",) * 3,
               "free": ("m/s",) * 3 + ("rad/s",) * 3},
         "a": {"revolute": ("rad/s^2",), "prismatic": ("m/s^2",), "spherical": ("rad/s^2",) * 3,
               "free": ("m/s^2",) * 3 + ("rad/s^2",) * 3}}
"""Units of the components of q, v and a, by the joint's kind."""
OF_BODY = {"pose": (("1",) * 3 + ("m",)) * 3, "position": ("m",) * 3,
            "twist": ("m/s",) * 3 + ("rad/s",) * 3}
OF_JOINT = {"reaction": ("N",) * 3 + ("N m",) * 3}
OF_SCENE = {"energy": ("J",) * 3, "momentum": ("N s",) * 3 + ("N m s",) * 3, "power": ("W",)}
QUANTITIES = (*UNITS, *OF_SCENE, *OF_BODY, *OF_JOINT)


class QuantityError(ValueError):
    """The text does not name a quantity of the scene."""


@dataclass(frozen=True)
class Recorded:
    """A quantity, or components of it: columns of a recording."""

    text: str  # in the scene
    quantity: str  # one of QUANTITIES or EFFECT_QUANTITIES
    target: str  # joint or body, or the name of an effect; "" for the whole scene
    places: tuple[int, ...]  # indices in the scene's q, v or a, or in the quantity itself
    names: tuple[str, ...]  # of the columns: "q.elbow", "pose.hand.3", "energy.kinetic"
    units: tuple[str, ...]  # of the columns
    function: str = ""  # of an effect: the one that computes it


def recorded(text: str, scene: Scene) -> Recorded:
    """The quantity with a name such as "q.elbow".  Raises QuantityError with the nearest name."""
    quantity, _, rest = text.partition(".")
    if quantity in UNITS:
        return _of_joints(text, quantity, rest, scene)
    if quantity in OF_SCENE:
        units = OF_SCENE[quantity]
        words = ENERGIES if quantity == "energy" else ()
        picked = _picked(text, rest, len(units), words)
        return _columns(text, quantity, "", picked, units, words)
    if quantity in OF_BODY:
        names = tuple(body.name for body in scene.model.bodies)
        return _of_target(text, quantity, rest, "body", names, OF_BODY[quantity])
    if quantity in OF_JOINT:
        names = tuple(j.name for j in scene.model.joints if j.kind is not Kind.FIXED)
        return _of_target(text, quantity, rest, "joint", names, OF_JOINT[quantity])
    return _of_effect(text, scene)


def expected(text: str, scene: Scene) -> Recorded:
    """The one component that an expectation is about; "energy" is the total."""
    found = recorded("energy.total" if text == "energy" else text, scene)
    if len(found.places) != 1:
        last = found.names[-1]
        raise QuantityError(f"{text!r} has {len(found.places)} components; wanted one, as {last!r}")
    return found


def recorded_functions(scene: Scene) -> set[str]:
    """The functions of effects that the scene's records and expectations need."""
    found = {recorded(text, scene).function for text in scene.record}
    return (found | {expected(x.quantity, scene).function for x in scene.expectations}) - {""}


def coordinates(scene: Scene) -> tuple[tuple[Joint, range, range], ...]:
    """Joints with coordinates of their own, and their places in q and v: neither fixed ones, nor
    those that follow others."""
    found, q, v = [], 0, 0
    follow = followers(scene)
    for joint in scene.model.joints:
        if joint.kind is not Kind.FIXED and joint.name not in follow:
            nq, nv = joint.kind.nq, joint.kind.nv
            found.append((joint, range(q, q + nq), range(v, v + nv)))
            q, v = q + nq, v + nv
    return tuple(found)


def followers(scene: Scene) -> Mapping[str, Mimic]:
    """The joints that follow others, by name: where a mimic effect lets them, all."""
    if not any(applied.effect.mimic for applied in scene.effects):
        return {}
    return {joint.name: joint.mimic for joint in scene.model.joints if joint.mimic}


def _of_joints(text: str, quantity: str, rest: str, scene: Scene) -> Recorded:
    """Components of q, v or a: of all joints, of one, or one of its."""
    joints = coordinates(scene)
    follow = followers(scene)
    names = (*(joint.name for joint, _, _ in joints), *follow)
    target, index = ("", "") if text == quantity else _target(text, rest, "joint", names)
    if target in follow:
        raise QuantityError(f"{text!r}: joint {target!r} follows another; it has no coordinates")
    places, columns, units, owners = [], [], [], dict[str, str]()
    for joint, q, v in joints:
        all_units = UNITS[quantity][joint.kind.value]
        all_columns = [f"{quantity}.{joint.name}" + ("" if len(all_units) == 1 else f".{i}")
                       for i in range(len(all_units))]
        for column in all_columns:
            if owners.setdefault(column, joint.name) != joint.name:
                raise QuantityError(f"{column!r} is a component of the joint {owners[column]!r} or "
                                    f"of the joint {joint.name!r}; rename one")
        if target in ("", joint.name):
            picked = _picked(text, index, len(all_units), ())
            places += [(q if quantity == "q" else v)[i] for i in picked]
            units += [all_units[i] for i in picked]
            columns += [all_columns[i] for i in picked]
    return Recorded(text, quantity, target, tuple(places), tuple(columns), tuple(units))


def _of_target(text: str, quantity: str, rest: str, what: str, names: tuple[str, ...],
               units: tuple[str, ...]) -> Recorded:
    target, index = _target(text, rest, what, names)
    return _columns(text, quantity, target, _picked(text, index, len(units), ()), units, ())


def _of_effect(text: str, scene: Scene) -> Recorded:
    """A quantity of one of the scene's effects.  Its places are those among all components of the
    results of its function."""
    known = quantities_by_name(scene)
    whole, _, last = text.rpartition(".")
    name, index = (whole, last) if whole in known and text not in known else (text, "")
    if name not in known:
        near = lacks(text, scene) or lacks(whole, scene) or _unknown(text, known)
        raise QuantityError(f"{text!r} is no quantity; {near}")
    function, applied, quantity = known[name]
    every = [(x, unit) for x, units in units_of(applied, scene).items() for unit in units]
    own = [i for i, (x, _) in enumerate(every) if x == quantity]
    picked = _picked(text, index, len(own), ())
    names = tuple(name if len(own) == 1 else f"{name}.{i}" for i in picked)
    places = tuple(own[i] for i in picked)
    return Recorded(text, quantity, applied.name, places, names,
                    tuple(every[i][1] for i in places), function)


def _unknown(text: str, known: Iterable[str]) -> str:
    """The nearest of the scene's quantities, or all kinds of them."""
    effects = tuple(known)
    quantity = text.partition(".")[0]
    owners = {name.partition(".")[0] for name in effects}
    if near := nearest(text, effects) if quantity in owners or "." in text else None:
        return f"did you mean {near!r}?"
    more = f", or of an effect, as {effects[0]}" if effects else ""
    return f"wanted one of {', '.join(QUANTITIES)}{more}{or_mean(quantity, QUANTITIES)}"


def _columns(text: str, quantity: str, target: str, picked: tuple[int, ...], units: tuple[str, ...],
             words: tuple[str, ...]) -> Recorded:
    stem = f"{quantity}.{target}" if target else quantity
    names = tuple(stem if len(units) == 1 else f"{stem}.{words[i] if words else i}" for i in picked)
    return Recorded(text, quantity, target, picked, names, tuple(units[i] for i in picked))


def _target(text: str, rest: str, what: str, names: tuple[str, ...]) -> tuple[str, str]:
    """Name and component: names may hold dots themselves."""
    if rest in names:
        return rest, ""
    name, _, index = rest.rpartition(".")
    if name in names:
        return name, index
    near = did_you_mean(name if index.isdecimal() or index in XYZ else rest, names)
    if not rest:
        raise QuantityError(f"{text!r} lacks its {what}; wanted {text.rstrip('.')}.{what.upper()}; "
                            f"{near}")
    raise QuantityError(f"{text!r}: no {what} {rest!r} that has it; {near}")


def _picked(text: str, index: str, count: int, words: tuple[str, ...]) -> tuple[int, ...]:
    if not index and not text.endswith("."):
        return tuple(range(count))
    if index in words:
        return (words.index(index),)
    if count == 3 and not words and index in XYZ:
        return (XYZ.index(index),)
    if len(index) < 4 and index.isascii() and index.isdecimal() and int(index) < count:
        return (int(index),)
    wanted = f"one of {', '.join(words)}" if words else _numbered(count)
    raise QuantityError(f"{text!r}: no component {index!r}; wanted {wanted}")


def _numbered(count: int) -> str:
    """The components there are, by number."""
    if count == 1:
        return "none"
    return f"0 to {count - 1}" + (f", or {', '.join(XYZ)}" if count == 3 else "")
