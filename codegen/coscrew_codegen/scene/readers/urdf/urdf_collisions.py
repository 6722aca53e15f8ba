"""Collision shapes of URDF's links.  Meshes are named by files, and not read.

A fault in a shape changes no motion: it is kept as the problem of that shape."""

from coscrew_codegen.scene.mechanism.collision import Collision, checked, unusable
from coscrew_codegen.scene.mechanism.visual import MESH
from coscrew_codegen.scene.readers.model_reader import ModelSource
from coscrew_codegen.scene.readers.urdf.urdf_shapes import (
    mesh_of,
    place_of,
    scale_of,
    shape_of,
    sizes,
)
from coscrew_codegen.scene.readers.urdf.xml import Element


def collisions(link: Element, source: ModelSource) -> tuple[Collision, ...]:
    """The collision shapes of a link, in its order."""
    return tuple(_collision(x, link.attributes.get("name", ""), source)
                 for x in link.all("collision"))


def _collision(collision: Element, body: str, source: ModelSource) -> Collision:
    name = collision.attributes.get("name", "")
    try:
        shape, at = shape_of(collision), place_of(collision)
        if shape.tag == MESH:
            return Collision(name, body, MESH, (), at.t, at.R, mesh=mesh_of(shape, source),
                             scale=scale_of(shape))
        return checked(Collision(name, body, shape.tag, sizes(shape), at.t, at.R))
    except ValueError as error:
        return unusable(name, body, f"line {collision.line}: {error}")
