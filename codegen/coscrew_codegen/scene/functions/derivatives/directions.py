"""Arguments of derivatives: directions of inputs and weights of results."""

from coscrew_codegen.scene import units
from coscrew_codegen.scene.effect_quantities import states_of
from coscrew_codegen.scene.scene import Scene
from coscrew_codegen.scene.scene_function import COUNT, Array, AxisLength, SceneFunction


def differentiable(function: SceneFunction, scene: Scene) -> bool:
    """Returns whether a scene can have the function's derivatives: it has results that change
    continuously, and is no step that also moves states of effects."""
    return not (function.internal or function.differentiates or COUNT in function.outputs
                or (function.step and states_of(scene)))


def derivative(x: Array, prefix: str) -> Array:
    """The derivative of an argument, with its name after a prefix; of coordinates, velocities."""
    return (Array(f"{prefix}{x.name}", (AxisLength.NV,), units.displacements)
            if x.is_coordinates else Array(f"{prefix}{x.name}", x.shape, x.units))


def gradient(x: Array) -> Array:
    """The derivatives of a number with respect to an argument."""
    own = derivative(x, "g_")
    return Array(own.name, own.shape, units.reciprocals(own.units))
