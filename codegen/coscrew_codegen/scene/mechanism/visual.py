"""Visual: a shape of a body to be seen, as read from a file.  It changes no motion.

Lengths in m; numbers are floats, since nothing but a picture is made of them."""

from collections.abc import Sequence
from dataclasses import dataclass
from math import sqrt
from pathlib import Path
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    import numpy as np

MESH = "mesh"
HERE = (0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0)


@dataclass(frozen=True, eq=False)
class Triangles:
    """A mesh that the reader has read."""

    vertices: "np.ndarray"  # (n, 3), m
    faces: "np.ndarray"  # (m, 3) indices of vertices, counterclockwise from outside


@dataclass(frozen=True)
class Visual:
    """A shape at a place of its body."""

    shape: str  # box, sphere, cylinder, capsule, ellipsoid, or MESH
    size: tuple[float, ...] = ()  # edges of a box; radius, and length along z, of a cylinder and of
    # a capsule between its half balls; half axes of an ellipsoid
    place: tuple[float, ...] = HERE  # position, and unit quaternion x, y, z, w
    colour: tuple[float, ...] = ()  # red, green, blue, opacity, 0 to 1; (): none is given
    mesh: Path | Triangles | None = None
    scale: tuple[float, ...] = (1.0, 1.0, 1.0)  # of the mesh
    problem: str = ""  # why it cannot be shown; "" if it can


def unseen(problem: str) -> Visual:
    """A visual that cannot be shown."""
    return Visual(MESH, problem=problem)


def sized(shape: str, size: Sequence[float], place: tuple[float, ...], colour: tuple[float, ...]
          ) -> Visual:
    """A shape with its sizes, which must be positive."""
    if not all(0 < x < float("inf") for x in size):
        return unseen(f"a {shape} of the sizes {', '.join(f'{x:g}' for x in size)}; wanted "
                      "positive ones")
    return Visual(shape, tuple(size), place, colour)


def from_rotation(R: Sequence[float]) -> tuple[float, ...]:
    """The quaternion x, y, z, w of a rotation, row by row, by its largest component."""
    squares = [1 + R[0] - R[4] - R[8], 1 - R[0] + R[4] - R[8], 1 - R[0] - R[4] + R[8],
               1 + R[0] + R[4] + R[8]]  # 4 x², 4 y², 4 z², 4 w²
    xy, xz, yz = R[1] + R[3], R[2] + R[6], R[5] + R[7]
    xw, yw, zw = R[7] - R[5], R[2] - R[6], R[3] - R[1]
    rows = ((squares[0], xy, xz, xw), (xy, squares[1], yz, yw), (xz, yz, squares[2], zw),
            (xw, yw, zw, squares[3]))
    return unit(rows[squares.index(max(squares))])


def unit(quaternion: Sequence[float]) -> tuple[float, ...]:
    """The quaternion of norm 1 in this direction.  Raises ValueError for zero."""
    norm = sqrt(sum(x * x for x in quaternion))
    if not 0 < norm < float("inf"):
        raise ValueError("a quaternion that is zero")
    return tuple(x / norm for x in quaternion)
