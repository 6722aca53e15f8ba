"""Forward dynamics."""

from coscrew_codegen.scene.scene_function import ALWAYS, A, Depends, SceneFunction

FUNCTION = SceneFunction(
    "forward_dynamics", 20, "a with M(q) a + bias_torques(q, v) = tau", "q v tau", (A,),
    lambda x: [x.accelerations()], Depends.EFFECTS, ALWAYS, divides=True, shown=True,
    judged=True)
