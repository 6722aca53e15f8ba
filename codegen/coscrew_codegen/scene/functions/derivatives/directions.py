"""Arguments of derivatives: directions of inputs and weights of results.

Coordinates change along velocities; the states of effects, which stand behind them, along
themselves."""

from coscrew_codegen.scene import units
from coscrew_codegen.scene.effect_quantities import states_of
from coscrew_codegen.scene.scene import Scene
from coscrew_codegen.scene.scene_function import COUNT, Array, AxisLength, SceneFunction
from coscrew_codegen.scene.units import Kinds, Units


def differentiable(function: SceneFunction, scene: Scene) -> bool:
    """Returns whether a function can have derivatives: it has inputs, and results that change
    continuously."""
    return bool(function.inputs_in(scene)) and not (
        function.internal or function.differentiates or COUNT in function.outputs)


def displacements(scene: Scene) -> Units:
    """Units of displacements, then of states of effects."""
    def of_kinds(kinds: Kinds) -> tuple[str, ...]:
        return (*units.displacements(kinds), *(
            unit for own in states_of(scene) for unit in own.units))
    return of_kinds


def derivative(x: Array, prefix: str, scene: Scene) -> Array:
    """The derivative of an argument, with its name after a prefix; of coordinates, velocities and
    rates of effects' states."""
    return (Array(f"{prefix}{x.name}", (AxisLength.DISPLACEMENTS,), displacements(scene))
            if x.is_coordinates else Array(f"{prefix}{x.name}", x.shape, x.units))


def gradient(x: Array, scene: Scene) -> Array:
    """The derivatives of a number with respect to an argument."""
    own = derivative(x, "g_", scene)
    return Array(own.name, own.shape, units.reciprocals(own.units))
