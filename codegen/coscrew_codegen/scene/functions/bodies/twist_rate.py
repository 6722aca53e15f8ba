"""Rates of the twists of bodies, in the bodies' axes."""

from coscrew_codegen.scene.functions.bodies.body_acceleration import UNITS
from coscrew_codegen.scene.scene_function import Array, Depends, Frame, Of, SceneFunction

FUNCTION = SceneFunction(
    "twist_rate_BODY", 117,
    "The spatial acceleration J a + J' v of BODY, the rate of its twist "
    "(v; w) in its own axes; J of jacobian_BODY",
    "q v a", (Array("A", (6,), UNITS, "in m/s^2, rad/s^2"),),
    lambda x: [x.twist_rate(x.target, Frame.BODY)], Depends.GEOMETRY, targets=Of.BODY)
