"""The momenta of floating trees."""

from coscrew_codegen.scene.scene_function import MOMENTA, Default, SceneFunction
from coscrew_codegen.scene.situation import FLOATING

BY_DEFAULT = Default("by default, for floating bases on which gravity is the only external force",
                     lambda scene, target: True)
_WORDS = ("c = (p; L; x) of each floating tree (BASES, and all bodies on it): linear momentum, "
          "angular momentum about its centre of mass, and the centre of mass, in the world's axes")

FUNCTION = SceneFunction(
    "free_momentum", 170, _WORDS.replace("BASES", "its base"), "q v", (MOMENTA,),
    lambda x: [x.floating_momenta()], default=BY_DEFAULT, divides=True, needs=FLOATING,
    words_in=lambda its: _WORDS.replace("BASES", ", ".join(its.floating)))
