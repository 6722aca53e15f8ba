"""Inputs and outputs of a function in a scene."""

from dataclasses import replace

from coscrew_codegen.scene.scene import Scene
from coscrew_codegen.scene.scene_function import INPUTS, Array, Depends, SceneFunction


def inputs_of(function: SceneFunction, scene: Scene) -> tuple[Array, ...]:
    """The inputs: with p if the function depends on masses, and t if on effects."""
    takes = {*function.takes}
    if function.depends is Depends.EFFECTS and scene.timed:
        takes.add("t")
    if function.depends is not Depends.GEOMETRY and scene.parameters:
        takes.add("p")
    return (*(x for name, x in INPUTS.items() if name in takes), *function.more)


def outputs_of(function: SceneFunction, scene: Scene) -> tuple[Array, ...]:
    """The outputs; those with an input's name get the suffix o."""
    taken = {x.name for x in inputs_of(function, scene)}
    return tuple(replace(x, name=f"{x.name}o") if x.name in taken else x for x in function.outputs)
