"""Shapes with which bodies touch the ground and each other, as the contacts of a scene give them,
whole."""

from collections.abc import Iterator, Sequence
from itertools import groupby

import numpy as np

from coscrew_codegen.scene.effect import POINTS
from coscrew_codegen.scene.mechanism.visual import HERE
from coscrew_codegen.scene.scene import Applied
from coscrew_codegen.simulation.system import System
from coscrew_codegen.simulation.view.part_places import along, numbers_of, value_of

_FLAT = 0.1  # thickness of a disc, in radii
_CORNERS = 8

Shape = tuple[str, tuple[float, ...], tuple[float, ...]]
"""Kind, size and place in the body, as those of visuals."""


def contacts(system: System) -> list[Applied]:
    """The contacts with the ground."""
    return [x for x in system.scene.effects if x.effect.name == "contact" and x.on]


def touching(system: System, point: float) -> Iterator[tuple[str, Shape]]:
    """The shapes, each once, with the names of their bodies; points are balls of this radius."""
    yield from dict.fromkeys((*_on_ground(system, point), *_of_pairs(system)))


def _on_ground(system: System, point: float) -> Iterator[tuple[str, Shape]]:
    for (body, _), several in groupby(contacts(system), key=lambda x: (x.on, _stem(x))):
        for shape in _joined([*several], system, point):
            yield body, shape


def _of_pairs(system: System) -> Iterator[tuple[str, Shape]]:
    """The spheres and capsules with which two bodies touch; one of them may be the world."""
    for x in (x for x in system.scene.effects if x.effect.bodies_force):
        for body, end in zip(x.bodies, (x.name for x in POINTS), strict=True):
            start = numbers_of(system, x.vector(end))
            stop = numbers_of(system, x.vector(f"{end}_end"))
            yield body, _round(start, stop, value_of(system, x, f"{end}_radius"))


def _round(start: np.ndarray, stop: np.ndarray, radius: float) -> Shape:
    """The capsule from a point to another, or the sphere about the first, if there is no other."""
    if not stop.size:
        return "sphere", (radius,), (*start.tolist(), *HERE[3:])
    length = float(np.linalg.norm(stop - start))
    return "capsule", (radius, length), along((start + stop) / 2, stop - start)


def _stem(contact: Applied) -> str:
    """The label, without the number of a part."""
    stem, _, number = contact.label.rpartition(".")
    return stem if number.isdecimal() else contact.label


def _joined(parts: Sequence[Applied], system: System, point: float) -> Iterator[Shape]:
    """The shape of these parts: eight corners are a box, two ends a capsule, two rims about an
    axis a cylinder."""
    places = np.array([numbers_of(system, x.vector("point")) for x in parts])
    singles = [_single(x, place, system, point) for x, place in zip(parts, places, strict=True)]
    kinds, sizes = {str(x.values["shape"]) for x in parts}, {size for _, size, _ in singles}
    low, high = places.min(0), places.max(0)
    if kinds == {"point"} and len({*map(tuple, places.tolist())}) == _CORNERS and all(
            len({*column}) == 2 for column in places.T.tolist()):
        yield "box", tuple((high - low).tolist()), (*((low + high) / 2).tolist(), *HERE[3:])
    elif kinds == {"sphere"} and len(parts) == 2 and len(sizes) == 1:
        yield _round(*places, *singles[0][1])
    elif kinds == {"disc"} and len(parts) == 2 and len(sizes) == 1 and _on_axis(parts, system):
        length = float(np.linalg.norm(places[1] - places[0]))
        yield "cylinder", (singles[0][1][0], length), along(places.mean(0), places[1] - places[0])
    else:
        yield from singles


def _on_axis(discs: Sequence[Applied], system: System) -> bool:
    """Returns whether the line between two discs is the axis of both."""
    first, second = (numbers_of(system, x.vector("point")) for x in discs)
    line = second - first
    axes = [numbers_of(system, x.vector("axis")) for x in discs]
    return bool(np.any(line)) and all(
        np.linalg.norm(np.cross(line, x)) < 1e-9 * np.linalg.norm(line) * np.linalg.norm(x)
        for x in axes)


def _single(contact: Applied, place: np.ndarray, system: System, point: float) -> Shape:
    radius = value_of(system, contact, "radius") or point
    if contact.values["shape"] == "disc":
        axis = numbers_of(system, contact.vector("axis"))
        return "cylinder", (radius, _FLAT * radius), along(place, axis)
    return _round(place, np.empty(0), radius)
