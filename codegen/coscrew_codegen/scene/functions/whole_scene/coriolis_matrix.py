"""The Coriolis matrix."""

from coscrew_codegen.scene import units
from coscrew_codegen.scene.scene_function import Array, AxisLength, SceneFunction

FUNCTION = SceneFunction(
    "coriolis_matrix", 32, "C(q, v), row by row: C v are the torques of Coriolis and centrifugal "
    "forces of bodies, and the rate of M(q) less 2 C is skew-symmetric", "q v",
    (Array("C", (AxisLength.NV, AxisLength.NV), units.torques_by_velocities),),
    lambda x: [x.coriolis_matrix()])
