"""Accelerations of bodies in the world's axes."""

from coscrew_codegen.scene.functions.bodies.body_acceleration import UNITS
from coscrew_codegen.scene.scene_function import Array, Depends, Frame, Of, SceneFunction

FUNCTION = SceneFunction(
    "aligned_twist_rate_BODY", 118,
    "J a + J' v of BODY, J of aligned_jacobian_BODY: the acceleration "
    "of its origin, and its angular acceleration, in the world's axes",
    "q v a", (Array("A", (6,), UNITS, "in m/s^2, rad/s^2"),),
    lambda x: [x.twist_rate(x.target, Frame.ALIGNED)], Depends.GEOMETRY, targets=Of.BODY)
