"""The rate of the centroidal momentum."""

from coscrew_codegen.scene.scene_function import Array, SceneFunction
from coscrew_codegen.scene.units import WRENCH

FUNCTION = SceneFunction(
    "centroidal_momentum_rate", 83, "A a + A' v of the centroidal momentum matrix A: force, and "
    "moment about the centre of mass, that move all bodies, in the world's axes; at a = 0 the rate "
    "of A times v", "q v a", (Array("f", (6,), WRENCH, "coscrew in N, N m"),),
    lambda x: [x.centroidal_momentum_rate()])
