"""Half a drift of bases that touch the ground."""

from coscrew_codegen.scene.scene_function import Depends, Q, SceneFunction, V
from coscrew_codegen.scene.situation import TOUCHING_BASE

FUNCTION = SceneFunction(
    "carried_half_drift", 148, "q, v: the coordinates after h/2, and the velocities: those of a "
    "free base stay the same in the world and turn in its frame, so that it moves straight on",
    "h q v", (Q, V), lambda x: x.carried(), Depends.GEOMETRY, internal=True, needs=TOUCHING_BASE)
