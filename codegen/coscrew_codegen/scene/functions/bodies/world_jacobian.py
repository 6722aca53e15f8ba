"""Jacobians of bodies in the world's axes, at the world's origin."""

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
    "world_jacobian_BODY", 114, "J with J v = (v; w) of BODY in the world's axes, of the point of "
    "the body that is at the world's origin",
    "q", (Array("J", (6, AxisLength.NV), units.jacobian, "screws of the velocities"),),
    lambda x: [x.jacobian(x.target, Frame.WORLD)], Depends.GEOMETRY, targets=Of.BODY)
