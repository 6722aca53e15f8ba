"""The power of effects that dissipate or drive."""

from coscrew_codegen.scene.scene_function import (
    ALWAYS,
    Array,
    Depends,
    SceneFunction,
    SceneQuantity,
)

FUNCTION = SceneFunction(
    "power", 70, "P, the power of the effects without potential energy; negative if they dissipate",
    "q v", (Array("P", (), ("W",), "power in W"),), lambda x: [[x.power()]], Depends.EFFECTS,
    ALWAYS, (SceneQuantity("power"),))
