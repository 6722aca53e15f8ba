"""Linear and angular momentum."""

from coscrew_codegen.scene.scene_function import ALWAYS, Array, SceneFunction, SceneQuantity
from coscrew_codegen.scene.units import MOMENTUM

FUNCTION = SceneFunction(
    "momentum", 80, "c = (p; L): linear momentum, angular momentum about the world's origin, in "
    "the world's frame", "q v", (Array("c", (6,), MOMENTUM, "in kg m/s, kg m^2/s"),),
    lambda x: [x.momentum()], default=ALWAYS, recorded=(SceneQuantity("momentum"),))
