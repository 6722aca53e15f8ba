"""Shapes of links in files of XML: what is seen, with colours, and what touches, with friction.
Meshes are named by files, and not read.

A fault in a shape changes no motion: it is kept as the problem of that shape."""

from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace
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
from coscrew_codegen.scene.mechanism.visual import MESH, Visual, from_rotation, sized, unseen
from coscrew_codegen.scene.readers.decimals import numbers_in
from coscrew_codegen.scene.readers.model_reader import ModelSource
from coscrew_codegen.scene.readers.packages import file_of
from coscrew_codegen.scene.readers.scene_error import SceneError, shown
from coscrew_codegen.scene.readers.xml_files.xml import Element

SIZES: Mapping[str, tuple[str, ...]] = {
    "box": ("size",), "sphere": ("radius",), "cylinder": ("radius", "length"),
    "capsule": ("radius", "length")}
"""The attributes with the sizes of each shape."""
_THREE = ("size", "radii")
_ONE = (Fraction(1),) * 3
_Z = (Fraction(0), Fraction(0), Fraction(1))
_COLOURS = (3, 4)  # numbers of a colour: opacity may be left out


@dataclass(frozen=True)
class Shapes:
    """Reads the shapes of one file's links, as its format writes them."""

    source: ModelSource
    sizes: Mapping[str, tuple[str, ...]]
    mesh: str  # the attribute with the file of a mesh
    place: Callable[[Element], Placement]  # of a visual or collision in its link
    colour: Callable[[Element], tuple[float, ...]]  # of a visual; () if it gives none
    friction: Callable[[Element], Friction | None] = lambda _: None  # of a collision

    def visuals(self, link: Element) -> tuple[Visual, ...]:
        """The visuals of a link, in its order."""
        return tuple(map(self._visual, link.all("visual")))

    def collisions(self, link: Element, body: str) -> tuple[Collision, ...]:
        """The collision shapes of a link, in its order."""
        return tuple(self._collision(x, body) for x in link.all("collision"))

    def _visual(self, visual: Element) -> Visual:
        try:
            x, colour = self._shape(visual), self.colour(visual)
            if x.shape == PLANE:
                raise ValueError(f"<{PLANE}> is not drawn")
            place = (*map(float, x.t), *from_rotation([float(y) for y in x.R]))
            seen = sized(x.shape, [*map(float, x.size)], place, colour)
            return replace(seen, mesh=x.mesh, scale=tuple(map(float, x.scale)))
        except ValueError as error:
            return unseen(_problem(visual, error))

    def _collision(self, collision: Element, body: str) -> Collision:
        name = collision.attributes.get("name", "")
        try:
            return checked(replace(self._shape(collision), name=name, body=body,
                                   friction=self.friction(collision)))
        except ValueError as error:
            return unusable(name, body, _problem(collision, error))

    def _shape(self, owner: Element) -> Collision:
        """The one shape of a visual or collision.  Raises ValueError."""
        shapes = [x for geometry in owner.all("geometry") for x in geometry.children]
        if len(shapes) != 1:
            raise ValueError(f"<{owner.tag}> has {len(shapes)} shapes; wanted one")
        shape, at = shapes[0], self.place(owner)
        if shape.tag not in (*self.sizes, MESH):
            raise ValueError(f"<{shape.tag[:60]}> is no shape; wanted one of "
                             f"{', '.join((*self.sizes, MESH))}")
        if shape.tag == MESH:
            uri = shape.attributes.get(self.mesh, "")
            if (file := file_of(uri, self.source) if uri else None) is None:
                raise ValueError(f"no file {shown(uri)}")
            return Collision("", "", MESH, (), at.t, at.R, mesh=file,
                             scale=numbers(shape, "scale", 3, _ONE))
        if shape.tag == PLANE:
            at = composed(at, _turned_to(numbers(shape, "normal", 3, _Z)))
        size = (x for key in self.sizes[shape.tag]
                for x in numbers(shape, key, 3 if key in _THREE else 1))
        return Collision("", "", shape.tag, tuple(size), at.t, at.R)


def numbers(owner: Element, name: str, count: int, default: tuple[Fraction, ...] | None = None
            ) -> tuple[Fraction, ...]:
    """The numbers of an attribute.  Raises ValueError."""
    text = owner.attributes.get(name, "")
    if not text.strip() and default is not None:
        return default
    try:
        return numbers_in(text, count)
    except ValueError as error:
        raise ValueError(f"{name!r} of <{owner.tag}>: {error}") from None


def colour(owner: Element, *names: str) -> tuple[float, ...]:
    """The colour in the first of these attributes that is one, from 0 to 1; () if none is."""
    for text in (owner.attributes.get(name, "") for name in names):
        try:
            given = numbers_in(text, len(text.split()))
        except ValueError:
            continue
        if len(given) in _COLOURS:
            return tuple(min(max(float(x), 0.0), 1.0) for x in given)
    return ()


def _turned_to(normal: tuple[Fraction, ...]) -> Placement:
    """The frame whose z is a plane's normal.  Raises ValueError for zero."""
    x, y, z = unit(normal)
    turn = (-y, x, Fraction(0), 1 + z) if z > -1 else (Fraction(1), *HERE.t)
    return Placement(from_quaternion(turn), HERE.t)


def _problem(owner: Element, error: ValueError) -> str:
    if isinstance(error, SceneError):
        return f"{error.where}: {error.problem}"
    return f"line {owner.line}: {error}"
