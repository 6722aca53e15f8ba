"""Wrenches that close loops."""

from coscrew_codegen.scene.scene_function import (
    IF_SELECTED,
    Array,
    Depends,
    Of,
    SceneFunction,
    SceneQuantity,
)
from coscrew_codegen.scene.units import WRENCH

FUNCTION = SceneFunction(
    "closing_LOOP", 125, "f = (force; moment) that the closure of LOOP exerts on its first body, "
    "in the frame of the body, at the loop's point, under torques tau; the opposite acts on the "
    "second body; of least norm where closures repeat each other", "q v tau",
    (Array("f", (6,), WRENCH, "coscrew in N, N m"),), lambda x: x.closings(x.target)[1:],
    Depends.EFFECTS, IF_SELECTED,
    (SceneQuantity("closing", Of.LOOP),), divides=True, targets=Of.LOOP)
