"""Parts of bodies that touch: a capsule's ends, a box's corners, a cylinder's rims; of shapes that
scenes give, and of those of a model's file."""

from collections.abc import Sequence
from fractions import Fraction
from itertools import product
from math import isqrt
from math import sqrt as root_of

from coscrew_codegen.scene.effect import Given
from coscrew_codegen.scene.mechanism.collision import PLANE, Collision
from coscrew_codegen.scene.mechanism.model import Model
from coscrew_codegen.scene.mechanism.rotations import turned

SHAPE_KEYS = ("shape", "point", "radius", "axis", "length", "size")
"""The values that say what touches; a contact without any of them takes its body's shapes from the
model's file."""
SHAPES = ("sphere", "capsule", "box", "cylinder")
"""Shapes of a model's file that can touch the ground."""
BALLS = ("sphere", "capsule")
"""Shapes that can touch other bodies as well as the ground."""
_SIGNS = (-1, 1)
_Z = (Fraction(0), Fraction(0), Fraction(1))
_Offsets = list[tuple[Fraction, ...]]


def touches(shape: Collision, model: Model) -> bool:
    """Returns whether a shape of a model's file can touch the ground."""
    return shape.shape in SHAPES and not shape.problem and meets_planes(shape, model)


def meets_planes(shape: Collision, model: Model) -> bool:
    """Returns whether the groups of a shape let it touch a plane of the file, if it has planes."""
    planes = [x for x in model.collisions if x.shape == PLANE]
    return not planes or any(map(shape.may_touch, planes))


def parts(values: Given) -> Sequence[Given]:
    """The contacts of a shape: a capsule's ends, a box's corners."""
    centre = _numbers(values["point"])
    if values["shape"] == "box":
        return _moved(values, {"shape": "point", "size": None}, centre,
                      _corners(_numbers(values["size"])))
    if values["shape"] == "capsule":
        axis, half = _numbers(values["axis"]), Fraction(str(values["length"])) / 2
        long = root(sum((x * x for x in axis), Fraction(0)))
        return _moved(values, {"shape": "sphere", "axis": None, "length": None}, centre,
                      [tuple(sign * half * x / long for x in axis) for sign in _SIGNS])
    return (values,)


def parts_of(values: Given, shape: Collision) -> Sequence[Given]:
    """The contacts of a shape of the model's file, one of SHAPES: as for shapes that are given; of
    a cylinder two discs."""
    if shape.shape == "sphere":
        return _moved(values, {"shape": "sphere", "radius": shape.size[0]}, shape.t, [(0, 0, 0)])
    if shape.shape == "box":
        return _moved(values, {}, shape.t, [turned(shape.R, x) for x in _corners(shape.size)])
    own: Given = {"shape": "sphere", "radius": shape.size[0]}
    if shape.shape == "cylinder":
        own = {"shape": "disc", "radius": shape.size[0], "axis": turned(shape.R, _Z)}
    return _moved(values, own, shape.t, _ends(shape))


def side_of(side: str, shape: Collision) -> Given:
    """The values of one side of a pair, `first` or `second`, by a shape of the model's file; none
    of a shape that touches no other body."""
    if shape.shape not in BALLS or shape.problem:
        return {}
    own: Given = {side: shape.t, f"{side}_end": None, f"{side}_radius": shape.size[0]}
    if shape.shape == "capsule":
        ends = (tuple(a + b for a, b in zip(shape.t, x, strict=True)) for x in _ends(shape))
        own = {**own, **dict(zip((side, f"{side}_end"), ends, strict=True))}
    return own


def _ends(shape: Collision) -> _Offsets:
    """The ends of the axis of a capsule or cylinder from its centre."""
    axis, half = turned(shape.R, _Z), shape.size[1] / 2
    return [tuple(sign * half * x for x in axis) for sign in _SIGNS]


def _moved(values: Given, own: Given, centre: Sequence[Fraction],
           offsets: Sequence[Sequence[Fraction | int]]) -> list[Given]:
    """The values with their own of one part at each place."""
    return [{**values, **own, "point": tuple(a + b for a, b in zip(centre, x, strict=True))}
            for x in offsets]


def _corners(size: Sequence[Fraction]) -> _Offsets:
    """The corners of a box of these edges about its centre."""
    return [tuple(sign * edge / 2 for sign, edge in zip(signs, size, strict=True))
            for signs in product(_SIGNS, repeat=3)]


def _numbers(given: object) -> tuple[Fraction, ...]:
    """The numbers of a vector."""
    return tuple(x for x in given if isinstance(x, Fraction)) if isinstance(given, tuple) else ()


def root(square: Fraction) -> Fraction:
    """Its square root: exact if it is a fraction's square."""
    above, below = isqrt(square.numerator), isqrt(square.denominator)
    exact = Fraction(above, below)
    return exact if exact * exact == square else Fraction(repr(root_of(float(square))))
