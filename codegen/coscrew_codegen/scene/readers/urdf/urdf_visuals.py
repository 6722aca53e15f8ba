"""Visuals of URDF's links: what is seen, with colours.  Meshes are named by files, and not read.

A fault in a visual changes no motion: it is kept as the problem of that visual."""

from collections.abc import Mapping

from coscrew_codegen.scene.mechanism.visual import MESH, Visual, from_rotation, sized, unseen
from coscrew_codegen.scene.readers.model_reader import ModelSource
from coscrew_codegen.scene.readers.urdf.urdf_shapes import (
    mesh_of,
    numbers,
    place_of,
    scale_of,
    shape_of,
    sizes,
)
from coscrew_codegen.scene.readers.urdf.xml import Element

Colours = Mapping[str, tuple[float, ...]]
"""Of the robot's materials, by name."""


def colours_of(root: Element) -> Colours:
    """The colours of the materials that the robot, or a visual in it, defines."""
    materials = [*root.all("material"), *(x for link in root.all("link")
                                          for visual in link.all("visual")
                                          for x in visual.all("material"))]
    return {x.attributes.get("name", ""): _colour(x) for x in reversed(materials) if _colour(x)}


def visuals(link: Element, colours: Colours, source: ModelSource) -> tuple[Visual, ...]:
    """The visuals of a link, in its order."""
    return tuple(_visual(x, colours, source) for x in link.all("visual"))


def _visual(visual: Element, colours: Colours, source: ModelSource) -> Visual:
    try:
        shape, at = shape_of(visual), place_of(visual)
        place = (*map(float, at.t), *from_rotation([float(x) for x in at.R]))
        material = next(iter(visual.all("material")), None)
        colour = () if material is None else (
            _colour(material) or colours.get(material.attributes.get("name", ""), ()))
        if shape.tag == MESH:
            return Visual(MESH, (), place, colour, mesh_of(shape, source),
                          tuple(map(float, scale_of(shape))))
        return sized(shape.tag, [*map(float, sizes(shape))], place, colour)
    except ValueError as error:
        return unseen(f"line {visual.line}: {error}")


def _colour(material: Element) -> tuple[float, ...]:
    """The colour that a material gives; () if it gives none, or numbers that are none."""
    for colour in material.all("color"):
        try:
            red, green, blue, opacity = numbers(colour, "rgba", 4)
        except ValueError:
            return ()
        return tuple(min(max(float(x), 0.0), 1.0) for x in (red, green, blue, opacity))
    return ()
