"""Functions of single effects: force and torque of each, its power and its energy."""

from collections.abc import Mapping
from dataclasses import replace

from coscrew_codegen.scene.effect import Place
from coscrew_codegen.scene.effect_quantities import (
    FORCE,
    SATURATED,
    TORQUE,
    functions_of_effects,
    units_of,
)
from coscrew_codegen.scene.scene import Applied, Scene
from coscrew_codegen.scene.scene_function import (
    Array,
    Default,
    Depends,
    Dynamics,
    Results,
    SceneFunction,
)


def _members(own: SceneFunction, scene: Scene) -> tuple[SceneFunction, ...]:
    """The family's members: one for each place of each effect that exerts a force or torque."""
    return tuple(_member(own, name, applied, units_of(applied, scene))
                 for name, applied in functions_of_effects(scene).items())


def _member(own: SceneFunction, name: str, applied: Applied, wanted: Mapping[str, tuple[str, ...]]
            ) -> SceneFunction:
    def compute(x: Dynamics) -> Results:
        known = x.of_effect(applied)
        return [known[quantity]() for quantity in wanted]

    return replace(
        own, name=name, words=f"{_in_words(applied, wanted)} of {applied.name}", compute=compute,
        outputs=tuple(Array(quantity, () if len(units) == 1 else (len(units),), units,
                            f"in {units[0]}") for quantity, units in wanted.items()),
        target=applied.name)


def _in_words(applied: Applied, wanted: Mapping[str, tuple[str, ...]]) -> str:
    """force in N, torque in N m about the body's origin, both in the world's axes, power in W."""
    places = {FORCE: "", TORQUE: " about the body's origin, both in the world's axes"} \
        if applied.effect.place is Place.BODY else {}
    return ", ".join(f"{quantity} (1 while the limit takes some of the torque, else 0)"
                     if quantity == SATURATED else
                     f"{quantity} in {units[0]}{places.get(quantity, '')}"
                     for quantity, units in wanted.items())


FUNCTION = SceneFunction(
    "effect_EFFECT_WHERE", 130, "what the effect exerts there, its power and energy, each an "
    "output: the quantities that it has, in that order", "q v", (), None, Depends.EFFECTS,
    Default("by default, for effects that are recorded or expected", lambda scene, target: False),
    members=_members)
