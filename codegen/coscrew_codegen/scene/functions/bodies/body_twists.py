"""Twists of all bodies."""

from coscrew_codegen.scene.scene_function import (
    ALWAYS,
    Array,
    AxisLength,
    Depends,
    Of,
    SceneFunction,
    SceneQuantity,
)
from coscrew_codegen.scene.units import SCREW

FUNCTION = SceneFunction(
    "body_twists", 100, "s[i] = (v; w) of each body in the frame of the body, at its origin", "q v",
    (Array("s", (AxisLength.BODIES, 6), SCREW, "screws in m/s, rad/s"),),
    lambda x: [[entry for body in x.scene.model.bodies for entry in x.twist(body.name)]],
    Depends.GEOMETRY, ALWAYS, (SceneQuantity("twist", Of.BODY),))
