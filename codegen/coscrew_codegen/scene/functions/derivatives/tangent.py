"""Derivatives along one direction."""

from dataclasses import replace

from coscrew_codegen.scene.functions.derivatives.directions import derivative, differentiable
from coscrew_codegen.scene.scene import Scene
from coscrew_codegen.scene.scene_function import Depends, Of, SceneFunction


def _of(own: SceneFunction, function: SceneFunction, scene: Scene) -> SceneFunction | None:
    """The function's tangent."""
    if not differentiable(function, scene):
        return None
    results = function.outputs_in(scene)
    return replace(
        function, name=f"{function.name}_tangent", place=own.place, differentiates=function,
        words=own.words.replace("FUNCTION", function.name), words_in=None, recorded=(),
        more=tuple(derivative(x, "d_", scene) for x in function.inputs_in(scene)), step=None,
        shown=False, outputs=(*results, *(derivative(x, "d_", scene) for x in results)),
        default=own.default,
        compute=lambda x: x.tangent(function), judged=False, members=None, targets=Of.SCENE)


FUNCTION = SceneFunction(
    "FUNCTION_tangent", 300, "The results of FUNCTION, and their derivatives d_ along the "
    "direction in which each input x changes by d_x; of coordinates along velocities, d_q of "
    "q ⊕ d_q", "", (), None, Depends.EFFECTS, each=_of)
