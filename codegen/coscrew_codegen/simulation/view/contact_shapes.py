"""Shapes with which bodies touch, as the contacts of a scene give them, whole."""

from collections.abc import Iterator, Sequence
from itertools import groupby

import numpy as np

from coscrew_codegen.program.values.parameter import Scalar
from coscrew_codegen.scene.mechanism.visual import HERE
from coscrew_codegen.scene.scene import Applied
from coscrew_codegen.simulation.system import System
from coscrew_codegen.simulation.view.part_places import along, number_of, numbers_of

_FLAT = 0.1  # thickness of a disc, in radii
_CORNERS = 8

Shape = tuple[str, tuple[float, ...], tuple[float, ...]]
"""Kind, size and place in the body, as those of visuals."""


def contacts(system: System) -> list[Applied]:
    """The contacts of the scene."""
    return [x for x in system.scene.effects if x.effect.name == "contact" and x.on]


def touching(system: System, point: float) -> Iterator[tuple[str, Shape]]:
    """The shapes, with the names of their bodies; points are balls of this radius."""
    for (body, _), several in groupby(contacts(system), key=lambda x: (x.on, _stem(x))):
        for shape in _joined([*several], system, point):
            yield body, shape


def _stem(contact: Applied) -> str:
    """The label, without the number of a part."""
    stem, _, number = contact.label.rpartition(".")
    return stem if number.isdecimal() else contact.label


def _joined(parts: Sequence[Applied], system: System, point: float) -> Iterator[Shape]:
    """The shape of these parts: eight corners are a box, two ends a capsule."""
    places = np.array([numbers_of(system, x.vector("point")) for x in parts])
    singles = [_single(x, place, system, point) for x, place in zip(parts, places, strict=True)]
    kinds, sizes = {str(x.values["shape"]) for x in parts}, {size for _, size, _ in singles}
    low, high = places.min(0), places.max(0)
    if kinds == {"point"} and len({*map(tuple, places.tolist())}) == _CORNERS and all(
            len({*column}) == 2 for column in places.T.tolist()):
        yield "box", tuple((high - low).tolist()), (*((low + high) / 2).tolist(), *HERE[3:])
    elif kinds == {"sphere"} and len(parts) == 2 and len(sizes) == 1:
        ends = places[1] - places[0]
        yield "capsule", (*singles[0][1], float(np.linalg.norm(ends))), along(places.mean(0), ends)
    else:
        yield from singles


def _single(contact: Applied, place: np.ndarray, system: System, point: float) -> Shape:
    radius = radius_of(contact, system) or point
    if contact.values["shape"] == "disc":
        axis = numbers_of(system, contact.vector("axis"))
        return "cylinder", (radius, _FLAT * radius), along(place, axis)
    return "sphere", (radius,), (*place.tolist(), *HERE[3:])


def radius_of(contact: Applied, system: System) -> float:
    """The radius of a contact's shape; 0 of a point."""
    radius = contact.values["radius"]
    return number_of(system, radius) if isinstance(radius, Scalar) else 0.0
