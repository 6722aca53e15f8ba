"""Places and colours of the shapes of a URDF."""

from collections.abc import Mapping

from coscrew_codegen.scene.mechanism import rotations
from coscrew_codegen.scene.mechanism.model import HERE, Placement
from coscrew_codegen.scene.readers.model_reader import ModelSource
from coscrew_codegen.scene.readers.urdf.urdf_schema import QUATERNION
from coscrew_codegen.scene.readers.xml_files.xml import Element
from coscrew_codegen.scene.readers.xml_files.xml_shapes import SIZES, Shapes, colour, numbers


def shapes_of(root: Element, source: ModelSource) -> Shapes:
    """Reads the shapes of a robot.  A material has its colour where it is defined: in the robot, or
    in a visual."""
    materials = [*root.all("material"), *(x for link in root.all("link")
                                          for visual in link.all("visual")
                                          for x in visual.all("material"))]
    named = {x.attributes.get("name", ""): _colour(x) for x in reversed(materials) if _colour(x)}
    return Shapes(source, SIZES, "filename", _place, lambda visual: _colour_of(visual, named))


def _place(owner: Element) -> Placement:
    """The place of a visual or collision in its link.  Raises ValueError."""
    origin = next(iter(owner.all("origin")), None)
    if origin is None:
        return HERE
    R = rotations.from_quaternion(numbers(origin, QUATERNION, 4)) \
        if QUATERNION in origin.attributes else rotations.from_rpy(
            *numbers(origin, "rpy", 3, HERE.t))
    return Placement(R, numbers(origin, "xyz", 3, HERE.t))


def _colour_of(visual: Element, named: Mapping[str, tuple[float, ...]]) -> tuple[float, ...]:
    material = next(iter(visual.all("material")), None)
    return () if material is None else (
        _colour(material) or named.get(material.attributes.get("name", ""), ()))


def _colour(material: Element) -> tuple[float, ...]:
    """The colour that a material gives; () if it gives none."""
    return next((colour(x, "rgba") for x in material.all("color")), ())
