"""The mass matrix."""

from coscrew_codegen.scene import units
from coscrew_codegen.scene.mechanism.inertia_checks import why_singular
from coscrew_codegen.scene.scene import Scene
from coscrew_codegen.scene.scene_function import (
    Array,
    AxisLength,
    Default,
    SceneFunction,
    Situation,
)

MANY = 100
"""Velocities (NV) above which the mass matrix is not a default function: its text grows with their
square, that of the others linearly."""


def speeds(scene: Scene) -> int:
    """The number of velocities of the joints, including followers."""
    return sum(joint.kind.nv for joint in scene.model.joints)


def _words(its: Situation) -> str:
    return _WORDS.replace("definite", "semidefinite") if why_singular(its.scene) else _WORDS


_WORDS = "M(q), row by row; symmetric, positive definite"
FUNCTION = SceneFunction(
    "mass_matrix", 30, _WORDS, "q",
    (Array("M", (AxisLength.NV, AxisLength.NV), units.masses, "masses in kg, kg m, kg m^2"),),
    lambda x: [x.mass_matrix()], words_in=_words, shown=True,
    default=Default(f"by default, for up to {MANY} velocities",
                    lambda scene, target: speeds(scene) <= MANY))
