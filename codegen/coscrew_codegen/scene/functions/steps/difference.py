"""Displacements between coordinates."""

from coscrew_codegen.scene import units
from coscrew_codegen.scene.scene_function import Array, AxisLength, Depends, SceneFunction

FUNCTION = SceneFunction(
    "difference", 141, "phi = q1 ⊖ q, the shortest with q ⊕ phi = q1: by logarithms for "
    "quaternions, else q1 - q", "q q1",
    (Array("phi", (AxisLength.NV,), units.displacements, "along the velocities, in m, rad"),),
    lambda x: [x.difference()], Depends.GEOMETRY)
