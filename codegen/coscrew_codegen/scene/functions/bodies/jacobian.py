"""Jacobians of bodies."""

from coscrew_codegen.scene import units
from coscrew_codegen.scene.scene_function import (
    Array,
    AxisLength,
    Depends,
    Frame,
    Of,
    SceneFunction,
)

FUNCTION = SceneFunction(
    "jacobian_BODY", 110, "J with J v = (v; w) of BODY in the frame of the body, at its origin",
    "q", (Array("J", (6, AxisLength.NV), units.jacobian, "screws of the velocities"),),
    lambda x: [x.jacobian(x.target, Frame.BODY)], Depends.GEOMETRY, targets=Of.BODY)
