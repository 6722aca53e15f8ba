"""Accelerations that are implicit in damping and stiffness."""

from coscrew_codegen.scene.scene_function import A, Depends, SceneFunction

FUNCTION = SceneFunction(
    "implicit_acceleration", 150, "a with (M + h d + h^2 k) a = -bias_torques(q, v) - h k v, where "
    "d, k are the damping and stiffness of the effects", "h q v", (A,),
    lambda x: [x.implicit_accelerations()], Depends.EFFECTS, divides=True, internal=True,
    with_tau=True)
