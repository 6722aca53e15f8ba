"""Switches of effects with states."""

from coscrew_codegen.scene.scene_function import Array, AxisLength, Depends, SceneFunction
from coscrew_codegen.scene.situation import SWITCHES

FUNCTION = SceneFunction(
    "law_switches", 154, "s: numbers that change their signs where another part of the law of an "
    "effect with states begins; of a contact its gap, and by how much friction and bristles are "
    "below their bounds; of stiction the last two", "q v",
    (Array("s", (AxisLength.SWITCHES,), ("1",), "of different units"),), lambda x: [x.switches()],
    Depends.EFFECTS, needs=SWITCHES)
