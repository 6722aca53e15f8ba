"""States with the momenta that floating trees keep."""

from coscrew_codegen.scene.functions.steps.free_momentum import BY_DEFAULT
from coscrew_codegen.scene.scene_function import Q, SceneFunction, V
from coscrew_codegen.scene.situation import FLOATING

FUNCTION = SceneFunction(
    "with_free_momentum", 180, "q and v, with the position and the velocity of each floating base "
    "corrected so that its tree's centre of mass is x + p t/m + g t^2/2 and its momentum "
    "(p + m g t; L), c = (p; L; x) after t seconds of gravity: after each step it removes the "
    "errors of integration and rounding", "t q v c", (Q, V), lambda x: x.with_floating_momenta(),
    default=BY_DEFAULT, divides=True, needs=FLOATING)
