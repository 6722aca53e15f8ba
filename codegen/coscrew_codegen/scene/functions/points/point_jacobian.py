"""Jacobians of given points of bodies, in the bodies' axes."""

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
    "point_jacobian_BODY", 111,
    "J with J v = (v; w) of BODY in the frame of the body, at its point r", "q r",
    (Array("J", (6, AxisLength.NV), units.jacobian, "screws of the velocities"),),
    lambda x: [x.jacobian(x.target, Frame.BODY, x.argument("r"))], Depends.GEOMETRY,
    targets=Of.BODY)
