"""States of effects after a step of the Euler methods."""

from dataclasses import replace

from coscrew_codegen.scene.scene_function import Depends, Q, SceneFunction
from coscrew_codegen.scene.situation import STATES

FUNCTION = SceneFunction(
    "moved_states", 153, "qo = q with the states x of effects after h at the velocities v, within "
    "their bounds", "h q v", (replace(Q, name="qo"),), lambda x: [x.moved_states()],
    Depends.EFFECTS, internal=True, needs=STATES)
