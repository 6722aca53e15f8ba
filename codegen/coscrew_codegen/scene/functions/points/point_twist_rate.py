"""Rates of the twists of bodies at given points, in the bodies' axes."""

from coscrew_codegen.scene.functions.bodies.body_acceleration import UNITS
from coscrew_codegen.scene.scene_function import Array, Depends, Frame, Of, SceneFunction

FUNCTION = SceneFunction(
    "point_twist_rate_BODY", 117,
    "The spatial acceleration J a + J' v of BODY at its point r; J of "
    "point_jacobian_BODY",
    "q v a r", (Array("A", (6,), UNITS, "in m/s^2, rad/s^2"),),
    lambda x: [x.twist_rate(x.target, Frame.BODY, x.argument("r"))], Depends.GEOMETRY,
    targets=Of.BODY)
