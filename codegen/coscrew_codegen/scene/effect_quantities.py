"""Quantities and states of a scene's effects, each where it acts, and the functions that compute
them.

    EFFECT.JOINT.torque       what it exerts on the joint's coordinate, after it is limited; on a
                              joint with several velocities a number for each
    EFFECT.JOINT.saturated    1 where its limit takes some of it, else 0
    EFFECT.BODY.force         in the world's axes;  EFFECT.BODY.force.x one component
    EFFECT.BODY.torque        about the body's origin, in the world's axes
    EFFECT.LABEL.force        between two bodies, positive if it pulls them together; of a contact
                              on the first, in the world's axes
    EFFECT.WHERE.power        torque · v, f·v + τ·ω: what it delivers, also out of its own energy
    EFFECT.WHERE.energy       potential energy; of an armature kinetic energy

An effect under a label has the label in place of the body or joint, one on the whole scene only its
name.
"""

from collections.abc import Mapping, Set
from dataclasses import dataclass

from coscrew_codegen.scene.effect import Place
from coscrew_codegen.scene.identifiers import identifiers
from coscrew_codegen.scene.mechanism.joint_kind import JointKind
from coscrew_codegen.scene.scene import Applied, Scene

TORQUE, FORCE, POWER, ENERGY, SATURATED = "torque", "force", "power", "energy", "saturated"
EFFECT_QUANTITIES = (TORQUE, FORCE, POWER, ENERGY, SATURATED)


def units_of(applied: Applied, scene: Scene) -> dict[str, tuple[str, ...]]:
    """The quantities that an effect has where it is applied, with their components' units."""
    return _units(applied, _kinds(scene))


def _kinds(scene: Scene) -> Mapping[str, JointKind]:
    return {x.name: x.kind for x in scene.model.joints}


def acted_units(applied: Applied, kinds: Mapping[str, JointKind]) -> Set[str]:
    """The units, N or N m, of the torques of an effect at a joint or on a sum; of others none."""
    at_joint = applied.terms or applied.on in kinds
    return set(_along(applied, kinds)) if at_joint else set()


def _along(applied: Applied, kinds: Mapping[str, JointKind]) -> tuple[str, ...]:
    """The units of an effect's torques along the velocities of its joint, or along a sum.  A sum is
    a length if one of its coordinates is."""
    if applied.terms:
        lengths = any(kinds[x.joint].units("q")[x.coordinate] == "m" for x in applied.terms)
        return ("N",) if lengths else ("N m",)
    if applied.effect.by_angle and kinds[applied.on].by_angle:
        return ("N m",)
    return tuple("N m" if unit == "rad/s" else "N" for unit in kinds[applied.on].units("v"))


def _units(applied: Applied, kinds: Mapping[str, JointKind]) -> dict[str, tuple[str, ...]]:
    effect = applied.effect
    results: dict[str, tuple[str, ...]] = {}
    if effect.joint_torque:
        results[TORQUE] = _along(applied, kinds)
    if effect.body_force:
        results |= {FORCE: ("N",) * 3, TORQUE: ("N m",) * 3}
    if effect.pair_force:
        results[FORCE] = ("N",)
    if effect.bodies_force:
        results[FORCE] = ("N",) * 3
    if results or effect.gravity:
        results[POWER] = ("W",)
    if effect.stores_energy:
        results[ENERGY] = ("J",)
    if effect.limited_by and applied.values[effect.limited_by] is not None:
        results[SATURATED] = ("1",)
    return results


def functions_of_effects(scene: Scene) -> dict[str, Applied]:
    """The effects that have quantities, by the names of their functions: effect_spring_elbow."""
    kinds = _kinds(scene)
    there = [x for x in scene.effects if _units(x, kinds)]
    return {f"effect_{name}": x
            for name, x in zip(identifiers([x.name for x in there]), there, strict=True)}


def quantities_by_name(scene: Scene) -> Mapping[str, tuple[str, Applied, str]]:
    """(function, effect, quantity) by the quantity's name in `record`: spring.elbow.torque."""
    kinds = _kinds(scene)
    return {f"{applied.name}.{quantity}": (function, applied, quantity)
            for function, applied in functions_of_effects(scene).items()
            for quantity in _units(applied, kinds)}


def lacks(text: str, scene: Scene) -> str:
    """Says why an effect of the scene has no quantity of this name, and lists its quantities; "" if
    the text does not consist of an effect of the scene and a quantity of effects."""
    name, _, quantity = text.rpartition(".")
    for applied in scene.effects:
        if applied.name == name and quantity in EFFECT_QUANTITIES:
            there = ", ".join(f"{name}.{x}" for x in units_of(applied, scene)) or "nothing"
            return f"{applied.name} {_reason(applied, quantity)}; wanted {there}"
    return ""


def _reason(applied: Applied, quantity: str) -> str:
    if quantity == ENERGY:
        return "stores no energy"
    if quantity == SATURATED:
        return "has no limit that could saturate"
    if applied.effect.place is Place.PAIR:
        return "acts between two bodies, by a force"
    return f"has no {quantity}"


@dataclass(frozen=True)
class EffectStates:
    """The states x of an effect where it is applied: they stand in q behind the coordinates of
    joints, in the order of the scene's effects."""

    applied: Applied
    components: tuple[str, ...]
    units: tuple[str, ...]
    places: range  # in x

    @property
    def name(self) -> str:
        """The name of the effect: stiction.elbow."""
        return self.applied.name

    @property
    def columns(self) -> tuple[str, ...]:
        """Their names in recordings: x.stiction.elbow, x.contact.foot.0."""
        own = f"x.{self.name}"
        return (own,) if len(self.units) == 1 else tuple(
            f"{own}.{i}" for i in range(len(self.units)))


def states_of(scene: Scene) -> tuple[EffectStates, ...]:
    """The states of a scene's effects."""
    kinds = {x.name: x.kind for x in scene.model.joints}
    results: list[EffectStates] = []
    for applied in scene.effects:
        if own := applied.states:
            first = count_of(results)
            lengths = "N" in acted_units(applied, kinds)
            units = tuple(x.unit.split(" or ")[-1 if lengths else 0] for x in own)
            results.append(EffectStates(applied, tuple(x.name for x in own), units,
                                        range(first, first + len(own))))
    return tuple(results)


def count_of(states: list[EffectStates] | tuple[EffectStates, ...]) -> int:
    """The number of states."""
    return states[-1].places.stop if states else 0


def places_of(scene: Scene) -> Mapping[str, range]:
    """The places in x of each effect's states, by the effect's name."""
    return {x.name: x.places for x in states_of(scene)}
