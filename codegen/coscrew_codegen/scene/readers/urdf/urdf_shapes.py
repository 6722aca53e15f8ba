"""Shapes of visuals and collisions of a URDF: geometry, place, sizes, file of a mesh."""

from fractions import Fraction
from pathlib import Path

from coscrew_codegen.scene.mechanism import rotations
from coscrew_codegen.scene.mechanism.model import HERE, Placement
from coscrew_codegen.scene.mechanism.visual import MESH
from coscrew_codegen.scene.readers.decimals import decimal
from coscrew_codegen.scene.readers.model_reader import ModelSource
from coscrew_codegen.scene.readers.packages import file_of
from coscrew_codegen.scene.readers.scene_error import shown
from coscrew_codegen.scene.readers.urdf.urdf_schema import QUATERNION
from coscrew_codegen.scene.readers.urdf.xml import Element

_SIZES = {"box": ("size",), "sphere": ("radius",), "cylinder": ("radius", "length"),
          "capsule": ("radius", "length")}
"""The attributes with the sizes of each shape."""
_ONE = (Fraction(1),) * 3


def shape_of(owner: Element) -> Element:
    """The one shape of a visual or collision.  Raises ValueError, as all functions here do."""
    shapes = [x for geometry in owner.all("geometry") for x in geometry.children]
    if len(shapes) != 1:
        raise ValueError(f"<{owner.tag}> has {len(shapes)} shapes; wanted one")
    shape, = shapes
    if shape.tag not in (*_SIZES, MESH):
        raise ValueError(f"<{shape.tag[:60]}> is no shape; wanted one of "
                         f"{', '.join((*_SIZES, MESH))}")
    return shape


def place_of(owner: Element) -> Placement:
    """The place of a visual or collision in its link."""
    origin = next(iter(owner.all("origin")), None)
    if origin is None:
        return HERE
    R = rotations.from_quaternion(numbers(origin, QUATERNION, 4)) \
        if QUATERNION in origin.attributes else rotations.from_rpy(
            *numbers(origin, "rpy", 3, HERE.t))
    return Placement(R, numbers(origin, "xyz", 3, HERE.t))


def sizes(shape: Element) -> tuple[Fraction, ...]:
    """The sizes of a shape; () of a mesh."""
    return tuple(x for key in _SIZES.get(shape.tag, ())
                 for x in numbers(shape, key, 3 if shape.tag == "box" else 1))


def mesh_of(shape: Element, source: ModelSource) -> Path:
    """The file of a mesh."""
    uri = shape.attributes.get("filename", "")
    file = file_of(uri, source) if uri else None
    if file is None:
        raise ValueError(f"no file {shown(uri)}")
    return file


def scale_of(shape: Element) -> tuple[Fraction, ...]:
    """The scale of a mesh along its axes."""
    return numbers(shape, "scale", 3, _ONE)


def numbers(owner: Element, name: str, count: int, default: tuple[Fraction, ...] = ()
            ) -> tuple[Fraction, ...]:
    """The numbers of an attribute."""
    text = owner.attributes.get(name, "")
    if not text.strip() and default:
        return default
    try:
        given = tuple(map(decimal, text.split()))
    except ValueError:
        given = ()
    if len(given) != count:
        raise ValueError(f"{name!r} of <{owner.tag}> is {shown(text)}; wanted {count} "
                         f"number{'s' * (count > 1)}")
    return given
