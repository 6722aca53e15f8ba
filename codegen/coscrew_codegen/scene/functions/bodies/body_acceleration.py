"""Accelerations of bodies."""

from coscrew_codegen.scene.scene_function import Array, Depends, Of, SceneFunction

UNITS = ("m/s^2",) * 3 + ("rad/s^2",) * 3
FUNCTION = SceneFunction(
    "acceleration_BODY", 116, "(v'; w') of BODY in the axes of the body: the acceleration of its "
    "origin, and its angular acceleration", "q v a",
    (Array("A", (6,), UNITS, "in m/s^2, rad/s^2"),),
    lambda x: [x.acceleration(x.target)], Depends.GEOMETRY, targets=Of.BODY)
