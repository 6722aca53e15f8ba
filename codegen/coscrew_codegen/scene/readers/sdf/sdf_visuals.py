"""Visuals of SDF's links: what is seen, with colours.  Meshes are named by files, and not read."""

from coscrew_codegen.scene.mechanism.visual import MESH, Visual, from_rotation, sized, unseen
from coscrew_codegen.scene.readers.model_reader import ModelSource
from coscrew_codegen.scene.readers.packages import file_of
from coscrew_codegen.scene.readers.scene_error import SceneError, shown
from coscrew_codegen.scene.readers.sdf.sdf_frames import SdfFrames
from coscrew_codegen.scene.readers.urdf.xml import Element

SIZES = {"box": ("size",), "sphere": ("radius",), "cylinder": ("radius", "length"),
          "capsule": ("radius", "length"), "ellipsoid": ("radii",)}
"""The elements with the sizes of each shape."""
THREE = ("size", "radii")
"""Elements of sizes that have three numbers."""
_COLOURS = ("diffuse", "ambient")


def visuals(reader: SdfFrames, link: Element, source: ModelSource) -> tuple[Visual, ...]:
    """The visuals of a link, in its order.  A fault is kept as the problem of its visual."""
    return tuple(_visual(reader, x, source) for x in link.all("visual"))


def _visual(reader: SdfFrames, visual: Element, source: ModelSource) -> Visual:
    try:
        geometry = reader.only(visual, "geometry")
        if geometry is None or len(geometry.children) != 1:
            reader.refuse(visual, "has no <geometry> with one shape")
        pose = reader.pose(visual)
        place = (*map(float, pose.t), *from_rotation([float(x) for x in pose.R]))
        shape, colour = geometry.children[0], _colour(reader, visual)
        if shape.tag in SIZES:
            size = [float(x) for tag in SIZES[shape.tag]
                    for x in reader.numbers(shape, tag, 3 if tag in THREE else 1)]
            return sized(shape.tag, size, place, colour)
        if shape.tag != MESH:
            reader.refuse(shape, f"<{shape.tag[:60]}> is not drawn")
        return _mesh(reader, shape, place, colour, source)
    except SceneError as error:
        return unseen(f"{error.where}: {error.problem}")


def _mesh(reader: SdfFrames, shape: Element, place: tuple[float, ...], colour: tuple[float, ...],
          source: ModelSource) -> Visual:
    uri = reader.text(shape, "uri")
    file = file_of(uri, source)
    if file is None:
        reader.refuse(shape, f"no file {shown(uri)}")
    return Visual(MESH, (), place, colour, file,
                  tuple(float(x) for x in reader.numbers(shape, "scale", 3, "1 1 1")))


def _colour(reader: SdfFrames, visual: Element) -> tuple[float, ...]:
    """The colour of the material; () if it gives none."""
    for material in visual.all("material"):
        for tag in (x for x in _COLOURS if material.all(x)):
            words = reader.text(material, tag).split()
            numbers = reader.numbers(material, tag, len(words))
            if len(numbers) in (3, 4):
                return tuple(min(max(float(x), 0.0), 1.0) for x in numbers)
    return ()
