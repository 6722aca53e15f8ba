"""Accelerations and the wrenches that close all loops, at once."""

from coscrew_codegen.scene.scene_function import A, Array, AxisLength, Depends, SceneFunction
from coscrew_codegen.scene.situation import LOOPS
from coscrew_codegen.scene.units import WRENCH

FUNCTION = SceneFunction(
    "closings", 126, "a of forward_dynamics, and f = (force; moment) of every closing_LOOP, in the "
    "order of the scene's loops, from one solution", "q v tau",
    (A, Array("f", (AxisLength.LOOPS, 6), WRENCH, "coscrews in N, N m")),
    lambda x: x.closings(*(y.name for y in x.scene.model.loops)), Depends.EFFECTS, divides=True,
    needs=LOOPS)
