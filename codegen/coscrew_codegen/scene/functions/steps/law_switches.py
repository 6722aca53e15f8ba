"""Switches of effects with states."""

from coscrew_codegen.scene.scene import Scene
from coscrew_codegen.scene.scene_function import (
    Array,
    AxisLength,
    Depends,
    SceneFunction,
    Situation,
)


def switches(scene: Scene) -> bool:
    """Returns whether an effect of the scene has switches."""
    return any(x.effect.switches for x in scene.effects)


def lacks(its: Situation) -> str:
    """Says why a scene has no switches."""
    return "" if switches(its.scene) else "no effect has switches"


FUNCTION = SceneFunction(
    "law_switches", 154, "s: numbers that change their signs where another part of the law of an "
    "effect with states begins; of a contact its gap, and by how much friction and bristles are "
    "below their bounds; of stiction the last two", "q v",
    (Array("s", (AxisLength.SWITCHES,), ("1",), "of different units"),), lambda x: [x.switches()],
    Depends.EFFECTS, lacks=lacks)
