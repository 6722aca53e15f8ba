"""Jacobians of bodies in the world's axes, at their origins."""

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
    "aligned_jacobian_BODY", 112, "J with J v = (v; w) of BODY in the world's axes, at its origin",
    "q", (Array("J", (6, AxisLength.NV), units.jacobian, "screws of the velocities"),),
    lambda x: [x.jacobian(x.target, Frame.ALIGNED)], Depends.GEOMETRY, targets=Of.BODY)
