"""Linear and angular momentum."""

from coscrew_codegen.scene.function import ALWAYS, Array, Quantity, SceneFunction
from coscrew_codegen.scene.units import MOMENTUM

FUNCTION = SceneFunction(
    "momentum", 80, "c = (p; L): linear momentum, angular momentum about the world's origin, in "
    "the world's frame", "q v", (Array("c", (6,), MOMENTUM, "in kg m/s, kg m^2/s"),),
    lambda x: [x.momentum()], default=ALWAYS, recorded=(Quantity("momentum"),))
