"""Motion of coordinates."""

from dataclasses import replace

from coscrew_codegen.scene.scene_function import ALWAYS, Depends, Q, SceneFunction

FUNCTION = SceneFunction(
    "integrated", 140, "qo = q ⊕ phi: by exponentials for quaternions, which come out of length 1, "
    "else q + phi", "q phi", (replace(Q, name="qo", words="coordinates"),),
    lambda x: [x.integrated()], Depends.GEOMETRY, ALWAYS)
