"""The upward axis of Collada files: y, say many, and only some mean it.

Gazebo turns such a mesh, RViz does not, and robots were drawn for either.  Meshes are turned where
they are then nearer to their bodies' centres of mass, all those of a model together."""

from collections.abc import Iterable
from math import sqrt
from pathlib import Path

import numpy as np

from coscrew_codegen.scene.mechanism.model import Body, value
from coscrew_codegen.scene.mechanism.visual import Visual
from coscrew_codegen.simulation.view.mesh_files import Pieces

_BEGINNING = 8192  # bytes of a file in which it declares its axis
_HALF = sqrt(0.5)
_UPRIGHT = np.array([[1.0, 0, 0], [0, 0, -1], [0, 1, 0]])  # brings y to z


def has_y_up(visual: Visual) -> bool:
    """Returns whether the visual's file says that y is its upward axis."""
    if not isinstance(visual.mesh, Path) or visual.mesh.suffix.lower() != ".dae":
        return False
    with visual.mesh.open("rb") as file:
        return b"Y_UP" in file.read(_BEGINNING)


def means_it(meshes: Iterable[tuple[Body, Visual, Pieces]]) -> bool:
    """Returns whether the meshes that say that y is up are nearer to centres of mass if it is."""
    plain = upright = 0.0
    for body, visual, pieces in meshes:
        if body.inertia and has_y_up(visual):
            every = np.concatenate([x.vertices for x in pieces])
            centre = (every.min(0) + every.max(0)) / 2
            com = np.array([float(value(x)) for x in body.inertia.com])
            plain += float(np.linalg.norm(_placed(visual.place, centre) - com))
            upright += float(np.linalg.norm(_placed(visual.place, _UPRIGHT @ centre) - com))
    return upright < plain


def upright(place: tuple[float, ...]) -> tuple[float, ...]:
    """The place with the mesh's y turned to z: its quaternion times that of a quarter about x."""
    x, y, z, w = place[3:]
    return (*place[:3], _HALF * (x + w), _HALF * (y + z), _HALF * (z - y), _HALF * (w - x))


def _placed(place: tuple[float, ...], point: np.ndarray) -> np.ndarray:
    """R(q) p + t."""
    axis, w = np.array(place[3:6]), place[6]
    twice = 2 * np.cross(axis, point)
    return np.asarray(point + w * twice + np.cross(axis, twice) + place[:3])
