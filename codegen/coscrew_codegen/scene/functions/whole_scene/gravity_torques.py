"""Torques of gravity."""

from coscrew_codegen.scene.scene_function import ALWAYS, TAU, SceneFunction

FUNCTION = SceneFunction(
    "gravity_torques", 50, "tau that holds the model still against gravity alone", "q", (TAU,),
    lambda x: [x.torques(effects=False)], default=ALWAYS)
