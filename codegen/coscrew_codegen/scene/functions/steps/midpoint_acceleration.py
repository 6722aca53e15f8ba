"""Accelerations of the default integrator's kicks."""

from dataclasses import replace

from coscrew_codegen.scene.effect_quantities import states_of
from coscrew_codegen.scene.scene import Scene
from coscrew_codegen.scene.scene_function import A, Depends, Q, SceneFunction


def _members(own: SceneFunction, scene: Scene) -> tuple[SceneFunction, ...]:
    """At tau = 0, and with torques of joints; with q, whose end the states of effects are, if the
    scene has some."""
    if states_of(scene):
        own = replace(own, outputs=(A, Q), compute=lambda x: x.kicked(), words=own.words +
                      "; and q with the states of effects after the kick")
    return own, replace(
        own, name=f"{own.name}_tau", place=own.place + 2, inputs=f"{own.inputs} tau",
        words=own.words.replace("-bias_torques", "tau -bias_torques"))


FUNCTION = SceneFunction(
    "midpoint_acceleration", 151, "a with M(q) a = -bias_torques(q, v + h/2 a) as the default "
    "integrator solves it, in two passes, implicit in damping and stiffness of the effects",
    "h q v", (A,), lambda x: [x.midpoint_accelerations()], Depends.EFFECTS, divides=True,
    internal=True, members=_members)
