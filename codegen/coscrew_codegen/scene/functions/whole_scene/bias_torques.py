"""Bias torques."""

from coscrew_codegen.scene.scene_function import ALWAYS, TAU, Depends, SceneFunction

FUNCTION = SceneFunction(
    "bias_torques", 40, "tau = inverse_dynamics(q, v, 0): Coriolis, centrifugal, gravity and all "
    "effects' torques", "q v", (TAU,), lambda x: [x.torques()], Depends.EFFECTS, ALWAYS)
