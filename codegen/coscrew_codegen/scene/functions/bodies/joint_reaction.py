"""Reactions of joints: the wrenches that they transmit.

Where loops are closed, accelerations do not determine them: torques do, since closures share the
load."""

from dataclasses import replace

from coscrew_codegen.scene.scene import Scene
from coscrew_codegen.scene.scene_function import (
    Array,
    Default,
    Depends,
    Of,
    SceneFunction,
    SceneQuantity,
)
from coscrew_codegen.scene.units import WRENCH


def _wanted(scene: Scene, joint: str) -> bool:
    return any(x.effect.reaction and x.on == joint for x in scene.effects)


_OF_TREE = SceneFunction(
    "reaction_JOINT", 120, "f = (force; moment) that JOINT exerts on its child, in the frame of "
    "the body, at its origin, while it accelerates with a", "q v a",
    (Array("f", (6,), WRENCH, "coscrew in N, N m"),), lambda x: [x.transmitted(x.target)],
    Depends.EFFECTS, Default("by default, for joints with the effect reaction, and those whose "
                             "reaction is recorded", _wanted),
    (SceneQuantity("reaction", Of.JOINT),), targets=Of.JOINT)
FUNCTION = replace(_OF_TREE, closed=replace(
    _OF_TREE, inputs="q v tau", divides=True, words=_OF_TREE.words.replace(
        "while it accelerates with a", "under torques tau, with its loops closed")))
