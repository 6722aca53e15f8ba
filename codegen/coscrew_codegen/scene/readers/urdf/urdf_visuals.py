"""Visuals of URDF's links: what is seen, with colours.  Meshes are named by files, and not read.

A fault in a visual changes no motion: it is kept as the problem of that visual."""

from collections.abc import Mapping

from coscrew_codegen.scene.mechanism.visual import (
    HERE,
    MESH,
    Visual,
    from_rpy,
    sized,
    unit,
    unseen,
)
from coscrew_codegen.scene.readers.model_reader import ModelSource
from coscrew_codegen.scene.readers.packages import file_of
from coscrew_codegen.scene.readers.scene_error import shown
from coscrew_codegen.scene.readers.urdf.urdf_schema import QUATERNION
from coscrew_codegen.scene.readers.urdf.xml import Element

SIZES = {"box": ("size",), "sphere": ("radius",), "cylinder": ("radius", "length"),
          "capsule": ("radius", "length")}
"""The attributes with the sizes of each shape."""

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
        shapes = [x for geometry in visual.all("geometry") for x in geometry.children]
        if len(shapes) != 1:
            raise ValueError(f"<visual> has {len(shapes)} shapes; wanted one")
        material = next(iter(visual.all("material")), None)
        colour = () if material is None else (
            _colour(material) or colours.get(material.attributes.get("name", ""), ()))
        return _shaped(shapes[0], _place(visual), colour, source)
    except ValueError as error:
        return unseen(f"line {visual.line}: {error}")


def _shaped(shape: Element, place: tuple[float, ...], colour: tuple[float, ...],
            source: ModelSource) -> Visual:
    if shape.tag in SIZES:
        size = [x for name in SIZES[shape.tag]
                for x in _floats(shape, name, 3 if shape.tag == "box" else 1)]
        return sized(shape.tag, size, place, colour)
    if shape.tag != MESH:
        raise ValueError(f"<{shape.tag[:60]}> is no shape; wanted one of "
                         f"{', '.join((*SIZES, MESH))}")
    uri = shape.attributes.get("filename", "")
    file = file_of(uri, source) if uri else None
    if file is None:
        raise ValueError(f"no file {shown(uri)}")
    return Visual(MESH, (), place, colour, file, _floats(shape, "scale", 3, (1.0, 1.0, 1.0)))


def _place(visual: Element) -> tuple[float, ...]:
    origin = next(iter(visual.all("origin")), None)
    if origin is None:
        return HERE
    turn = unit(_floats(origin, QUATERNION, 4)) if QUATERNION in origin.attributes else from_rpy(
        *_floats(origin, "rpy", 3, HERE[:3]))
    return (*_floats(origin, "xyz", 3, HERE[:3]), *turn)


def _colour(material: Element) -> tuple[float, ...]:
    """The colour that a material gives; () if it gives none, or numbers that are none."""
    for colour in material.all("color"):
        try:
            red, green, blue, opacity = _floats(colour, "rgba", 4)
        except ValueError:
            return ()
        return tuple(min(max(x, 0.0), 1.0) for x in (red, green, blue, opacity))
    return ()


def _floats(owner: Element, name: str, count: int, default: tuple[float, ...] = ()
            ) -> tuple[float, ...]:
    """The finite numbers of an attribute.  Raises ValueError."""
    text = owner.attributes.get(name, "")
    if not text.strip() and default:
        return default
    try:
        numbers = tuple(map(float, text.split()))
    except ValueError:
        numbers = ()
    if len(numbers) != count or not all(abs(x) < float("inf") for x in numbers):
        raise ValueError(f"{name!r} of <{owner.tag}> is {shown(text)}; wanted {count} "
                         f"number{'s' * (count > 1)}")
    return numbers
