"""Collision shapes of SDF's links, with friction.  Meshes are named by files, and not read.

A fault in a shape changes no motion: it is kept as the problem of that shape."""

from fractions import Fraction

from coscrew_codegen.scene.mechanism.collision import (
    PLANE,
    Collision,
    Friction,
    checked,
    unusable,
)
from coscrew_codegen.scene.mechanism.model import HERE, Placement
from coscrew_codegen.scene.mechanism.rotations import from_quaternion, unit
from coscrew_codegen.scene.mechanism.tree import composed
from coscrew_codegen.scene.mechanism.visual import MESH
from coscrew_codegen.scene.readers.model_reader import ModelSource
from coscrew_codegen.scene.readers.packages import file_of
from coscrew_codegen.scene.readers.scene_error import shown
from coscrew_codegen.scene.readers.sdf.sdf_frames import SdfFrames
from coscrew_codegen.scene.readers.sdf.sdf_visuals import SIZES, THREE
from coscrew_codegen.scene.readers.urdf.xml import Element


def collisions(reader: SdfFrames, link: Element, full: str, source: ModelSource
               ) -> tuple[Collision, ...]:
    """The collision shapes of a link, in its order."""
    return tuple(_collision(reader, x, full, source) for x in link.all("collision"))


def _collision(reader: SdfFrames, collision: Element, body: str, source: ModelSource) -> Collision:
    name = collision.attributes.get("name", "")
    try:
        geometry = reader.only(collision, "geometry")
        if geometry is None or len(geometry.children) != 1:
            reader.refuse(collision, "has no <geometry> with one shape")
        shape, at = geometry.children[0], reader.pose(collision)
        size: tuple[Fraction, ...] = ()
        mesh, scale = None, reader.numbers(shape, "scale", 3, "1 1 1")
        if shape.tag in SIZES:
            size = tuple(x for tag in SIZES[shape.tag]
                         for x in reader.numbers(shape, tag, 3 if tag in THREE else 1))
        elif shape.tag == PLANE:
            at = composed(at, _to(reader, shape))
        elif shape.tag == MESH:
            uri = reader.text(shape, "uri")
            if (mesh := file_of(uri, source)) is None:
                reader.refuse(shape, f"no file {shown(uri)}")
        else:
            reader.refuse(shape, f"<{shape.tag[:60]}> is no shape that is kept")
        return checked(Collision(name, body, shape.tag, size, at.t, at.R,
                                 _friction(reader, collision), mesh, scale))
    except ValueError as error:
        return unusable(name, body, str(error))


def _to(reader: SdfFrames, plane: Element) -> Placement:
    """The frame whose z is the normal of a plane."""
    x, y, z = unit(reader.numbers(plane, "normal", 3, "0 0 1"))
    turn = (-y, x, Fraction(0), 1 + z) if z > -1 else (Fraction(1), *HERE.t)
    return Placement(from_quaternion(turn), HERE.t)


def _friction(reader: SdfFrames, collision: Element) -> Friction | None:
    """The coefficients that ODE and others take, mu and mu2."""
    for surface in collision.all("surface"):
        for friction in surface.all("friction"):
            for of in friction.all("ode"):
                mu = reader.number(of, "mu", "1")
                return Friction(mu, reader.number(of, "mu2", "1"))
    return None
