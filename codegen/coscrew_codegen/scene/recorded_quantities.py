"""Quantities of a simulation, and their names in `record` and `expect`.

    q, v, a                   of all joints;  q.JOINT of one,  q.JOINT.2 one component
    x                         of all effects with states;  x.EFFECT.WHERE of one
    QUANTITY                  of the whole scene, as a function's file says: energy, momentum
    QUANTITY.BODY             of a body: pose.BODY, position.BODY, twist.BODY
    QUANTITY.JOINT            of a joint: reaction.JOINT
    EFFECT.WHERE.torque       and others of each effect: see `effect_quantities`

Components are called by names, as energy.kinetic, or by numbers, as pose.BODY.3; position.BODY.x is
position.BODY.0.
"""

from collections.abc import Iterable, Sequence
from dataclasses import dataclass

from coscrew_codegen.scene.effect_quantities import lacks, quantities_by_name, states_of, units_of
from coscrew_codegen.scene.functions import QUANTITIES as OF_FUNCTIONS
from coscrew_codegen.scene.mechanism.assembly import followers
from coscrew_codegen.scene.mechanism.model import Joint
from coscrew_codegen.scene.names import did_you_mean, nearest, or_mean
from coscrew_codegen.scene.patterns import is_pattern, matching
from coscrew_codegen.scene.scene import Scene
from coscrew_codegen.scene.scene_function import Of, SceneFunction, SceneQuantity
from coscrew_codegen.scene.units import UNITS

XYZ = ("x", "y", "z")
"""Alternative names of the components 0, 1 and 2 of vectors of three."""
STATES = "x"
"""The quantity of effects' states."""
QUANTITIES = (*UNITS, STATES, *OF_FUNCTIONS)
_ACCELERATIONS = "forward_dynamics"
"""The function that computes the accelerations for recordings and for other functions."""


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
    function: str = ""  # that computes it; "" for states
    sums: tuple[tuple[int, ...], ...] = ()  # of each place, the function's results that are added
    takes_a: bool = False  # whether the function takes accelerations: they are those at tau = 0
    of_effect: bool = False

    @property
    def functions(self) -> tuple[str, ...]:
        """The functions that are called for it."""
        return (*([_ACCELERATIONS] if self.takes_a else []),
                *([self.function] if self.function else []))


def recorded(text: str, scene: Scene) -> Recorded:
    """The quantity with a name such as "q.elbow".  Raises QuantityError with the nearest name."""
    quantity, _, rest = text.partition(".")
    if quantity == STATES:
        return _of_states(text, rest, scene)
    if quantity in UNITS:
        return _of_joints(text, quantity, rest, scene)
    if quantity in OF_FUNCTIONS:
        return _of_function(text, quantity, rest, scene)
    return _of_effect(text, scene)


def expected(text: str, scene: Scene) -> Recorded:
    """The one component that an expectation refers to; "energy" is the total."""
    component = OF_FUNCTIONS[text][1].expected if text in OF_FUNCTIONS else ""
    named = recorded(f"{text}.{component}" if component else text, scene)
    if len(named.places) != 1:
        last = named.names[-1]
        raise QuantityError(f"{text!r} has {len(named.places)} components; wanted one, as {last!r}")
    return named


def recorded_functions(scene: Scene) -> set[str]:
    """The functions that the scene's records and expectations need."""
    wanted = (*(recorded(text, scene) for text in scene.record),
              *(expected(x.quantity, scene) for x in scene.expectations))
    return {name for x in wanted for name in x.functions}


def coordinates(scene: Scene) -> tuple[tuple[Joint, range, range], ...]:
    """Joints with coordinates of their own, without fixed joints and followers, and their places in
    q and v."""
    result, q, v = [], 0, 0
    follow = followers(scene)
    for joint in scene.model.joints:
        if joint.kind.moves and joint.name not in follow:
            nq, nv = joint.kind.nq, joint.kind.nv
            result.append((joint, range(q, q + nq), range(v, v + nv)))
            q, v = q + nq, v + nv
    return tuple(result)


def _of_joints(text: str, quantity: str, rest: str, scene: Scene) -> Recorded:
    """Components of q, v or a: of all joints, of one joint, or a single one."""
    joints = coordinates(scene)
    follow = followers(scene)
    names = (*(joint.name for joint, _, _ in joints), *follow)
    target, index = ("", "") if text == quantity else _target(text, rest, "joint", names)
    if target in follow:
        raise QuantityError(f"{text!r}: joint {target!r} follows another; it has no coordinates")
    places, columns, units, owners = [], [], [], dict[str, str]()
    for joint, q, v in joints:
        all_units = joint.kind.units(quantity)
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
    function = _ACCELERATIONS if quantity == "a" else ""
    return Recorded(text, quantity, target, tuple(places), tuple(columns), tuple(units), function,
                    tuple((i,) for i in places))


def _of_states(text: str, rest: str, scene: Scene) -> Recorded:
    """Components of x: of all effects, of one, or a single one."""
    states = states_of(scene)
    if not states:
        raise QuantityError(f"{text!r}: no effect of the scene has states; wanted q or v")
    target, index = ("", "") if text == STATES else _target(
        text, rest, "effect", tuple(x.name for x in states))
    first = coordinates(scene)[-1][1].stop
    own = [x for x in states if target in ("", x.name)]
    picked = [(x, i) for x in own for i in _picked(text, index, len(x.units), ())]
    places = tuple(first + x.places[i] for x, i in picked)
    return Recorded(text, STATES, target, places, tuple(x.columns[i] for x, i in picked),
                    tuple(x.units[i] for x, i in picked), "", tuple((i,) for i in places))


def targets(function: SceneFunction, kind: SceneQuantity, scene: Scene) -> tuple[str, ...]:
    """The names of the bodies or joints that a quantity belongs to; () of the whole scene."""
    if function.targets is kind.of:
        return tuple(function.names(scene))
    return tuple(body.name for body in scene.model.bodies)


def _of_function(text: str, quantity: str, rest: str, scene: Scene) -> Recorded:
    """Components of a function's results."""
    function, kind = OF_FUNCTIONS[quantity]
    if not function.recorded_in(scene):
        raise QuantityError(f"{text!r}: no effect of the scene has {quantity}")
    all_components = function.components_of(kind)
    count, names = len(all_components), targets(function, kind, scene)
    target, index = _target(text, rest, kind.of.value, names) if kind.of.value else ("", rest)
    picked = _picked(text, index, count, kind.components)
    each = function.outputs[0].each if target and function.targets is Of.SCENE else 0
    first = names.index(target) * each if each else 0
    stem = f"{quantity}.{target}" if target else quantity
    words = kind.components or tuple(map(str, range(count)))
    columns = tuple(stem if count == 1 else f"{stem}.{words[i]}" for i in picked)
    units, places = zip(*(all_components[i] for i in picked), strict=True)
    return Recorded(text, quantity, target, picked, columns, units,
                    function.names(scene).get(target, function.name),
                    tuple(tuple(first + place for place in several) for several in places),
                    "a" in function.within(scene).takes)


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
                    tuple(every[i][1] for i in places), function, tuple((i,) for i in places),
                    of_effect=True)


def _unknown(text: str, known: Iterable[str]) -> str:
    """Names the nearest of the scene's quantities, or all kinds of them."""
    effects = tuple(known)
    quantity = text.partition(".")[0]
    owners = {name.partition(".")[0] for name in effects}
    if near := nearest(text, effects) if quantity in owners or "." in text else None:
        return f"did you mean {near!r}?"
    more = f", or of an effect, as {effects[0]}" if effects else ""
    return f"wanted one of {', '.join(QUANTITIES)}{more}{or_mean(quantity, QUANTITIES)}"


def _target(text: str, rest: str, what: str, names: tuple[str, ...]) -> tuple[str, str]:
    """Splits a text into name and component; names may hold dots themselves."""
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
    """Lists the existing components by number."""
    if count == 1:
        return "none"
    return f"0 to {count - 1}" + (f", or {', '.join(XYZ)}" if count == 3 else "")


_POSITIONS = tuple(name for name, (function, x) in OF_FUNCTIONS.items()
                   if [unit for unit, _ in function.components_of(x)] == ["m"] * 3)
"""Quantities whose components are called x, y and z, too."""


def recordable(scene: Scene) -> tuple[str, ...]:
    """The names of all quantities, each whole: q.elbow, energy, position.hand."""
    own = [joint.name for joint, _, _ in coordinates(scene)]
    return (*(name for name, (function, x) in OF_FUNCTIONS.items()
              if x.of is Of.SCENE and function.recorded_in(scene)),
            *(f"{quantity}.{joint}" for quantity in UNITS for joint in own),
            *(f"{STATES}.{x.name}" for x in states_of(scene)),
            *(f"{name}.{target}" for name, (function, x) in OF_FUNCTIONS.items()
              for target in targets(function, x, scene)),
            *quantities_by_name(scene))


def components(names: Sequence[str], scene: Scene) -> tuple[str, ...]:
    """The names of the quantities' columns: energy.kinetic, position.hand.2."""
    return tuple(column for name in names for column in recorded(name, scene).names)


def quantities_of(texts: Sequence[str], scene: Scene) -> tuple[str, ...]:
    """The quantities that texts name; patterns are replaced by all whole quantities that they
    match, or else by components.  Raises QuantityError for each text that names none."""
    result, errors = list[str](), []
    for text in texts:
        try:
            recorded(text, scene)
            names: tuple[str, ...] = (text,)
        except QuantityError as error:
            names = _matching(text, scene) if is_pattern(text) else ()
            if not names:
                errors.append(_unmatched(text, scene) if is_pattern(text) else str(error))
        result += [x for x in names if x == text or not (x in result or x in texts)]
    if errors:
        raise QuantityError("; ".join(errors))
    return tuple(result)


def _matching(pattern: str, scene: Scene) -> tuple[str, ...]:
    """The quantities that a pattern matches: whole ones, or else components, by number, or else
    x, y and z of positions."""
    whole = recordable(scene)
    parts = components(whole, scene)
    lettered = tuple(f"{name[:-1]}{XYZ[int(name[-1])]}" for name in parts
                     if name.partition(".")[0] in _POSITIONS)
    return matching(pattern, whole, parts, lettered)


def _unmatched(pattern: str, scene: Scene) -> str:
    whole = recordable(scene)
    return (f"{pattern!r} matches no quantity; "
            f"{did_you_mean(pattern, (*whole, *components(whole, scene)))}")
