"""Collision: a shape of a body that may touch others, as read from a file.  Frozen data, in SI
units.

Numbers are exact, as in a model.  Nothing uses them until an effect of contact does: they change no
motion and no hash of a scene."""

from dataclasses import dataclass
from fractions import Fraction
from pathlib import Path

from coscrew_codegen.scene.mechanism.rotations import IDENTITY, Entries
from coscrew_codegen.scene.mechanism.visual import MESH, Triangles

PLANE = "plane"
_ZERO, _ONE = Fraction(0), Fraction(1)


@dataclass(frozen=True)
class Friction:
    """Coefficients of friction: along the first direction of the surface and across it; moments
    about the normal and about directions in the surface, relative to the normal force, in m."""

    sliding: Fraction
    across: Fraction
    torsional: Fraction = _ZERO
    rolling: Fraction = _ZERO


@dataclass(frozen=True)
class Collision:
    """A shape at a place of its body, which may be the world."""

    name: str  # in the file; "" if it has none
    body: str
    shape: str  # box, sphere, cylinder, capsule, ellipsoid, PLANE, whose normal is z, or MESH
    size: tuple[Fraction, ...] = ()  # edges of a box; radius, and length along z, of a cylinder
    # and of a capsule between its half balls; half axes of an ellipsoid
    t: tuple[Fraction, ...] = (_ZERO,) * 3
    R: Entries = IDENTITY
    friction: Friction | None = None  # None: the file gives none
    mesh: Path | Triangles | None = None
    scale: tuple[Fraction, ...] = (_ONE,) * 3  # of the mesh
    groups: tuple[int, int] | None = None  # bits: two shapes may touch where the first number of
    # one has a bit of the second of the other; None: the file says nothing of it
    problem: str = ""  # why it cannot be used; "" if it can

    def may_touch(self, other: "Collision") -> bool:
        """Returns whether the groups of two shapes let them touch."""
        if self.groups is None or other.groups is None:
            return True
        (a, to_a), (b, to_b) = self.groups, other.groups
        return bool(a & to_b or b & to_a)


def unusable(name: str, body: str, problem: str) -> Collision:
    """A shape that cannot be used."""
    return Collision(name, body, MESH, problem=problem)


def checked(shape: Collision) -> Collision:
    """The shape, or one that cannot be used if its sizes are not positive.  Raises ValueError for
    negative friction."""
    of = shape.friction
    if of and min(of.sliding, of.across, of.torsional, of.rolling) < 0:
        raise ValueError("negative friction; wanted 0 or more")
    if min(shape.size, default=_ONE) > 0:
        return shape
    sizes = ", ".join(f"{float(x):g}" for x in shape.size)
    return unusable(shape.name, shape.body,
                    f"a {shape.shape} of the sizes {sizes}; wanted positive ones")
