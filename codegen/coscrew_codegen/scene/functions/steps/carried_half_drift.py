"""Half a drift of bases that touch the ground."""

from coscrew_codegen.scene.mechanism.model import WORLD
from coscrew_codegen.scene.scene import Scene
from coscrew_codegen.scene.scene_function import Depends, Q, SceneFunction, Situation, V


def lacks(its: Situation) -> str:
    """Says why a scene has no such drift."""
    return "" if carries(its.scene) else "no free base touches anything"


def carries(scene: Scene) -> bool:
    """Returns whether the velocities of free bases stay the same in the world while they drift."""
    return any(x.effect.parts or x.effect.bodies_force for x in scene.effects) and any(
        x.kind.floats and x.parent == WORLD for x in scene.model.joints)


FUNCTION = SceneFunction(
    "carried_half_drift", 148, "q, v: the coordinates after h/2, and the velocities: those of a "
    "free base stay the same in the world and turn in its frame, so that it moves straight on",
    "h q v", (Q, V), lambda x: x.carried(), Depends.GEOMETRY, internal=True, lacks=lacks)
