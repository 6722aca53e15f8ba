"""Scenes and kernels with the functions that a test needs: more than the default ones, or fewer."""

from dataclasses import replace
from pathlib import Path

from coscrew_codegen.program.values.formats import named
from coscrew_codegen.runtime.load import Kernels, kernels_for
from coscrew_codegen.runtime.request import BOTH
from coscrew_codegen.scene.function_selection import DEFAULT, together
from coscrew_codegen.scene.functions.bodies import jacobian
from coscrew_codegen.scene.integrators import EMITTED
from coscrew_codegen.scene.readers.toml.toml_scene import read_scene
from coscrew_codegen.scene.scene import Scene
from coscrew_codegen.simulation import required_functions

STEPPED = (DEFAULT, *(x.step_name for x in EMITTED))
"""The default functions, and every emitted integrator."""


def jacobians(scene: Scene) -> dict[str, str]:
    """Bodies by the names of their Jacobians: jacobian_hand."""
    return {x.name: x.target for x in jacobian.FUNCTION.of(scene)}


def with_jacobians(scene: Scene) -> Scene:
    """The scene with the default functions, all Jacobians, every emitted integrator."""
    return replace(scene, functions=(*STEPPED, *jacobians(scene)))


def checked(scene: Scene | Path, *integrators: str | None, others: tuple[str, ...] = (),
            precisions: tuple[str, ...] = BOTH) -> Kernels:
    """The kernels that `coscrew check` has for these integrators (None: the scene's), and other
    functions; in these precisions."""
    read = read_scene(scene) if isinstance(scene, Path) else scene
    wanted = (required_functions.of_check(read, x) for x in integrators or (None,))
    return kernels_for(read, together(*wanted, others), precisions)


class OneByOne:
    """A scene's functions of one precision, each derived and compiled when it is first used."""

    def __init__(self, scene: Scene, precision: str):
        self._scene, self._precision = scene, precision
        self.kind = named((precision,))[0].numpy_type

    def __getattr__(self, name: str) -> object:
        kernels = kernels_for(self._scene, (name,), (self._precision,))
        setattr(self, name, result := getattr(getattr(kernels, self._precision), name))
        return result
