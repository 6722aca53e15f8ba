"""Scenes that select more functions than the default ones."""

from dataclasses import replace

from coscrew_codegen.integrators import EMITTED
from coscrew_codegen.scene.scene import Scene
from coscrew_codegen.scene.selected import DEFAULT, jacobians

STEPPED = (DEFAULT, *(x.step_name for x in EMITTED))
"""The default functions, and every emitted integrator."""


def with_jacobians(scene: Scene) -> Scene:
    """The scene with the default functions, all Jacobians, every emitted integrator."""
    return replace(scene, functions=(*STEPPED, *jacobians(scene)))
