"""Collision shapes of URDF's links.  Meshes are named by files, and not read.

A fault in a shape changes no motion: it is kept as the problem of that shape."""

from fractions import Fraction

from coscrew_codegen.scene.mechanism import rotations
from coscrew_codegen.scene.mechanism.collision import Collision, checked, unusable
from coscrew_codegen.scene.mechanism.visual import MESH
from coscrew_codegen.scene.readers.decimals import decimal
from coscrew_codegen.scene.readers.model_reader import ModelSource
from coscrew_codegen.scene.readers.packages import file_of
from coscrew_codegen.scene.readers.scene_error import shown
from coscrew_codegen.scene.readers.urdf.urdf_schema import QUATERNION
from coscrew_codegen.scene.readers.urdf.urdf_visuals import SIZES
from coscrew_codegen.scene.readers.urdf.xml import Element

_ZERO, _ONE = (Fraction(0),) * 3, (Fraction(1),) * 3


def collisions(link: Element, source: ModelSource) -> tuple[Collision, ...]:
    """The collision shapes of a link, in its order."""
    return tuple(_collision(x, link.attributes.get("name", ""), source)
                 for x in link.all("collision"))


def _collision(collision: Element, body: str, source: ModelSource) -> Collision:
    name = collision.attributes.get("name", "")
    try:
        shapes = [x for geometry in collision.all("geometry") for x in geometry.children]
        if len(shapes) != 1:
            raise ValueError(f"<collision> has {len(shapes)} shapes; wanted one")
        (shape,), (t, R) = shapes, _place(collision)
        if shape.tag in SIZES:
            size = [x for key in SIZES[shape.tag]
                    for x in _numbers(shape, key, 3 if shape.tag == "box" else 1)]
            return checked(Collision(name, body, shape.tag, tuple(size), t, R))
        if shape.tag != MESH:
            raise ValueError(f"<{shape.tag[:60]}> is no shape; wanted one of "
                             f"{', '.join((*SIZES, MESH))}")
        uri = shape.attributes.get("filename", "")
        file = file_of(uri, source) if uri else None
        if file is None:
            raise ValueError(f"no file {shown(uri)}")
        return Collision(name, body, MESH, (), t, R, mesh=file,
                         scale=_numbers(shape, "scale", 3, _ONE))
    except ValueError as error:
        return unusable(name, body, f"line {collision.line}: {error}")


def _place(collision: Element) -> tuple[tuple[Fraction, ...], rotations.Entries]:
    origin = next(iter(collision.all("origin")), None)
    if origin is None:
        return _ZERO, rotations.IDENTITY
    R = rotations.from_quaternion(_numbers(origin, QUATERNION, 4)) \
        if QUATERNION in origin.attributes else rotations.from_rpy(
            *_numbers(origin, "rpy", 3, _ZERO))
    return _numbers(origin, "xyz", 3, _ZERO), R


def _numbers(owner: Element, name: str, count: int, default: tuple[Fraction, ...] = ()
             ) -> tuple[Fraction, ...]:
    """The numbers of an attribute.  Raises ValueError."""
    text = owner.attributes.get(name, "")
    if not text.strip() and default:
        return default
    numbers = tuple(map(decimal, text.split()))
    if len(numbers) != count:
        raise ValueError(f"{name!r} of <{owner.tag}> is {shown(text)}; wanted {count} "
                         f"number{'s' * (count > 1)}")
    return numbers
