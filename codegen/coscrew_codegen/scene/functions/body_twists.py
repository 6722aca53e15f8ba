"""Twists of all bodies."""

from coscrew_codegen.scene.function import (
    ALWAYS,
    Array,
    Depends,
    Of,
    Quantity,
    SceneFunction,
    Size,
)
from coscrew_codegen.scene.units import SCREW

FUNCTION = SceneFunction(
    "body_twists", 100, "s[i] = (v; w) of each body in the frame of the body, at its origin", "q v",
    (Array("s", (Size.BODIES, 6), SCREW, "screws in m/s, rad/s"),),
    lambda x: [[entry for body in x.scene.model.bodies for entry in x.twist(body.name)]],
    Depends.GEOMETRY, ALWAYS, (Quantity("twist", Of.BODY),))
