"""Accelerations that are implicit in damping and stiffness."""

from dataclasses import replace

from coscrew_codegen.scene.scene import Scene
from coscrew_codegen.scene.scene_function import A, Depends, SceneFunction


def _members(own: SceneFunction, scene: Scene) -> tuple[SceneFunction, ...]:
    """At tau = 0, and with torques of joints."""
    return own, replace(
        own, name=f"{own.name}_tau", place=own.place + 2, inputs=f"{own.inputs} tau",
        words=own.words.replace("-bias_torques", "tau -bias_torques"))


FUNCTION = SceneFunction(
    "implicit_acceleration", 150, "a with (M + h d + h^2 k) a = -bias_torques(q, v) - h k v, where "
    "d, k are the damping and stiffness of the effects", "h q v", (A,),
    lambda x: [x.implicit_accelerations()], Depends.EFFECTS, divides=True, internal=True,
    members=_members)
