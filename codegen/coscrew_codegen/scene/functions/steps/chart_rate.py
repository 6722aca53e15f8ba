"""Rates of displacements along the velocities."""

from coscrew_codegen.scene import units
from coscrew_codegen.scene.scene_function import Array, AxisLength, Depends, SceneFunction
from coscrew_codegen.scene.situation import QUATERNIONS

FUNCTION = SceneFunction(
    "chart_rate", 160, "u = phi' while q = integrated(q0, phi) moves with v: v + [phi, v]/2 + "
    "[phi, [phi, v]]/12, accurate to fourth order", "v phi",
    (Array("u", (AxisLength.NV,), units.velocities, "in m/s, rad/s"),), lambda x: [x.chart_rate()],
    Depends.GEOMETRY, needs=QUATERNIONS, internal=True)
