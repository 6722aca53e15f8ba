"""Derivatives of one weighted sum of results."""

from dataclasses import replace

from coscrew_codegen.scene.functions.derivatives.directions import (
    derivative,
    differentiable,
    gradient,
)
from coscrew_codegen.scene.scene import Scene
from coscrew_codegen.scene.scene_function import Depends, Of, SceneFunction


def _of(own: SceneFunction, function: SceneFunction, scene: Scene) -> SceneFunction | None:
    """The function's adjoint."""
    if not differentiable(function, scene):
        return None
    results = function.outputs_in(scene)
    return replace(
        function, name=f"{function.name}_adjoint", place=own.place, differentiates=function,
        words=own.words.replace("FUNCTION", function.name), words_in=None, recorded=(),
        more=tuple(derivative(x, "w_", scene) for x in results), step=None, shown=False,
        outputs=(*results, *(gradient(x, scene) for x in function.inputs_in(scene))),
        default=own.default,
        compute=lambda x: x.adjoint(function), judged=False, members=None, targets=Of.SCENE)


FUNCTION = SceneFunction(
    "FUNCTION_adjoint", 310, "The results of FUNCTION, and the derivatives g_x of their sum with "
    "weights w_ with respect to each input x; of coordinates along velocities, g_q of q ⊕ phi at "
    "phi = 0", "", (), None, Depends.EFFECTS, each=_of)
