"""Poses of all bodies."""

from coscrew_codegen.scene.scene_function import (
    ALWAYS,
    Array,
    AxisLength,
    Depends,
    Of,
    SceneFunction,
    SceneQuantity,
)
from coscrew_codegen.scene.units import POSE

FUNCTION = SceneFunction(
    "body_poses", 90, "D[i] = [R | t] of each body in the world, row by row", "q",
    (Array("D", (AxisLength.BODIES, 3, 4), POSE, "displacements, t in m"),),
    lambda x: [[entry for body in x.scene.model.bodies for entry in x.pose(body.name)]],
    Depends.GEOMETRY, ALWAYS,
    (SceneQuantity("pose", Of.BODY),
     SceneQuantity("position", Of.BODY, places=((3,), (7,), (11,)))))
