"""Accelerations of the default integrator's kicks."""

from dataclasses import replace

from coscrew_codegen.scene.effect_quantities import states_of
from coscrew_codegen.scene.scene import Scene
from coscrew_codegen.scene.scene_function import A, Depends, Q, SceneFunction


def _members(own: SceneFunction, scene: Scene) -> tuple[SceneFunction, ...]:
    """With q, whose end the states of effects are, if the scene has some."""
    if states_of(scene):
        own = replace(own, outputs=(A, Q), compute=lambda x: x.kicked(), words=own.words +
                      "; and q with the states of effects after the kick")
    return (own,)


FUNCTION = SceneFunction(
    "midpoint_acceleration", 151, "a with M(q) a = -bias_torques(q, v + h/2 a) as the default "
    "integrator solves it, in two passes, implicit in damping and stiffness of the effects",
    "h q v", (A,), lambda x: [x.midpoint_accelerations()], Depends.EFFECTS, divides=True,
    internal=True, with_tau=True, members=_members)
