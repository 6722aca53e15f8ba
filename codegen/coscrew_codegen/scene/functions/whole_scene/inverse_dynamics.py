"""Inverse dynamics."""

from coscrew_codegen.scene.scene_function import ALWAYS, TAU, Depends, SceneFunction

FUNCTION = SceneFunction(
    "inverse_dynamics", 10, "tau = M(q) a + bias_torques(q, v): what the joints must supply for "
    "the accelerations a, besides the effects", "q v a", (TAU,), lambda x: [x.torques()],
    Depends.EFFECTS, ALWAYS, shown=True, judged=True)
