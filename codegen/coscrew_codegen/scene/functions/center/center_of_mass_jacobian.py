"""The Jacobian of the centre of mass."""

from coscrew_codegen.scene import units
from coscrew_codegen.scene.scene_function import Array, AxisLength, SceneFunction

FUNCTION = SceneFunction(
    "center_of_mass_jacobian", 88, "J with J v = center_of_mass_velocity(q, v)", "q",
    (Array("J", (3, AxisLength.NV), units.point_jacobian, "velocities of the velocities"),),
    lambda x: [x.centre_of_mass_jacobian()])
