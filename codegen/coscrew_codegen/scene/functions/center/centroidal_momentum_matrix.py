"""The centroidal momentum matrix."""

from coscrew_codegen.scene import units
from coscrew_codegen.scene.scene_function import Array, AxisLength, SceneFunction

FUNCTION = SceneFunction(
    "centroidal_momentum_matrix", 82, "A with A v = (p; L): linear momentum, angular momentum "
    "about the centre of mass, in the world's axes", "q",
    (Array("A", (6, AxisLength.NV), units.centroidal, "momenta of the velocities"),),
    lambda x: [x.centroidal_momentum_matrix()])
