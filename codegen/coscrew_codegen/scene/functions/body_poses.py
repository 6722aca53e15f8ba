"""Poses of all bodies."""

from coscrew_codegen.scene.function import (
    ALWAYS,
    Array,
    Depends,
    Of,
    Quantity,
    SceneFunction,
    Size,
)
from coscrew_codegen.scene.units import POSE

FUNCTION = SceneFunction(
    "body_poses", 90, "D[i] = [R | t] of each body in the world, row by row", "q",
    (Array("D", (Size.BODIES, 3, 4), POSE, "displacements, t in m"),),
    lambda x: [[entry for body in x.scene.model.bodies for entry in x.pose(body.name)]],
    Depends.GEOMETRY, ALWAYS,
    (Quantity("pose", Of.BODY), Quantity("position", Of.BODY, places=((3,), (7,), (11,)))))
