"""Spatial accelerations of bodies at the world's origin."""

from coscrew_codegen.scene.functions.bodies.body_acceleration import UNITS
from coscrew_codegen.scene.scene_function import Array, Depends, Frame, Of, SceneFunction

FUNCTION = SceneFunction(
    "world_twist_rate_BODY", 119,
    "The spatial acceleration J a + J' v of BODY in the world's axes, at "
    "the world's origin; J of world_jacobian_BODY",
    "q v a", (Array("A", (6,), UNITS, "in m/s^2, rad/s^2"),),
    lambda x: [x.twist_rate(x.target, Frame.WORLD)], Depends.GEOMETRY, targets=Of.BODY)
