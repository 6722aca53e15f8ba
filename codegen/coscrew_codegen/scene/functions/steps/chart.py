"""Rates of coordinates as a matrix."""

from coscrew_codegen.scene import units
from coscrew_codegen.scene.scene_function import Array, AxisLength, Depends, SceneFunction

FUNCTION = SceneFunction(
    "chart", 142, "N with q' = N v: the derivative of q ⊕ phi with respect to phi at phi = 0, "
    "which turns derivatives by coordinates into derivatives along velocities", "q",
    (Array("N", (AxisLength.NQ, AxisLength.NV), units.coordinates_by_displacements),),
    lambda x: [x.chart()], Depends.GEOMETRY)
