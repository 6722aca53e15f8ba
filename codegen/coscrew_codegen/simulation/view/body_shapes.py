"""Parts of a picture: the visuals of the bodies, or boxes of their mass and inertia.

A body without visuals that can be shown is a box, unless the model has visuals and the body hardly
any mass: such bodies are frames in most files.  Beside a box, or in its place where they hold the
centre of mass, are the shapes with which the body touches the ground."""

from collections.abc import Iterator, Set
from dataclasses import dataclass, field

import numpy as np

import coscrew
from coscrew_codegen.scene.mechanism.model import WORLD, Body, Inertia, Joint
from coscrew_codegen.scene.mechanism.visual import HERE, MESH, Visual
from coscrew_codegen.simulation.system import System
from coscrew_codegen.simulation.view.collada_axes import has_y_up, means_it, upright
from coscrew_codegen.simulation.view.contact_shapes import Shape, touching
from coscrew_codegen.simulation.view.mesh_files import Piece, Pieces, identity, installed, meshes
from coscrew_codegen.simulation.view.part_places import along, number_of, numbers_of

_THIN = 0.06  # least side of a box, relative to its longest or, for a point mass, the model's size
_HARDLY = 0.02  # of the model's mass
_ROD = 0.012  # radius of the rods between joints, in sizes of the model
UNPAINTED = (0.72, 0.75, 0.80, 1.0)
_LINKAGE = (0.47, 0.51, 0.57, 1.0)
_COLOURS = ((0.26, 0.47, 0.78), (0.90, 0.49, 0.16), (0.30, 0.62, 0.42), (0.66, 0.40, 0.68),
            (0.83, 0.66, 0.22), (0.30, 0.60, 0.68), (0.78, 0.33, 0.33), (0.50, 0.52, 0.30))
"""Of boxes, in turn."""


@dataclass(frozen=True)
class DrawnPart:
    """A shape fixed to a body (-1: the world), at a place in its frame."""

    body: int
    shape: str  # of visuals
    size: tuple[float, ...]
    place: tuple[float, ...]
    colour: tuple[float, ...]
    piece: Piece | None = None


@dataclass
class RobotDrawing:
    """The parts, and a sentence for each visual that is not among them."""

    parts: list[DrawnPart] = field(default_factory=list)
    notes: list[str] = field(default_factory=list)
    unread: int = 0  # meshes that are boxes since no package reads them
    pieces: dict[str, Pieces] = field(default_factory=dict)  # of the meshes, by identity
    touching: list[DrawnPart] = field(default_factory=list)  # collision shapes
    inertias: list[DrawnPart] = field(default_factory=list)  # boxes of bodies drawn otherwise


def drawn(system: System) -> RobotDrawing:
    """The drawing of the scene's model."""
    model, drawing = system.scene.model, RobotDrawing()
    numbers = {body.name: n for n, body in enumerate(model.bodies)}
    shown = set(_add_visuals(drawing, model.bodies, numbers))
    any_visual = any(body.visuals for body in model.bodies)
    shown |= {*_add_contacts(system, drawing, shown, {WORLD: -1, **numbers})}
    inertias = {x.name: x.inertia for x in model.bodies if x.inertia}
    least = _HARDLY * sum(number_of(system, x.mass) for x in inertias.values()) if any_visual else 0
    for name, inertia in inertias.items():
        box = _box(system, inertia, numbers[name])
        if name in shown:
            drawing.inertias.append(box)
        elif number_of(system, inertia.mass) >= least:
            drawing.parts.append(box)
            if not any_visual:
                _add_rod(drawing, box.body, np.array(box.place[:3]), _ROD / 2 * _size(system))
    if not any_visual:
        for joint in model.joints:
            _add_linkage(system, drawing, joint, {WORLD: -1, **numbers})
        for end in (x for loop in model.loops for x in (loop.first, loop.second)):
            if end.body != WORLD:
                point = np.array([*map(float, end.point)])
                _add_rod(drawing, numbers[end.body], point, _ROD * _size(system))
    return drawing


def _add_visuals(drawing: RobotDrawing, bodies: tuple[Body, ...], numbers: dict[str, int]
                 ) -> Iterator[str]:
    """Add the visuals that can be shown; yields the names of their bodies."""
    every = [(body, x) for body in bodies for x in body.visuals]
    wanted = [(body, x) for body, x in every if readable(x)]
    results = meshes([x for _, x in wanted]) if wanted else []
    drawing.pieces = {identity(x): result for (_, x), result in zip(wanted, results, strict=True)
                      if not isinstance(result, str)}
    turns = means_it((body, x, result) for (body, x), result in zip(wanted, results, strict=True)
                     if not isinstance(result, str))
    pieces = iter(results)
    for body, visual in ((body.name, x) for body, x in every):
        if visual.problem:
            drawing.notes.append(f"{body}: {visual.problem}")
        elif visual.shape != MESH:
            drawing.parts.append(DrawnPart(numbers[body], visual.shape, visual.size, visual.place,
                                      visual.colour or UNPAINTED))
            yield body
        elif not readable(visual):
            drawing.unread += 1
        elif isinstance(result := next(pieces), str):
            drawing.notes.append(f"{body}: {visual.mesh}: {result}")
        else:
            place = upright(visual.place) if turns and has_y_up(visual) else visual.place
            drawing.parts += [DrawnPart(numbers[body], MESH, (), place, x.colour or visual.colour or
                                   UNPAINTED, x) for x in result]
            yield body


def _add_contacts(system: System, drawing: RobotDrawing, shown: Set[str], numbers: dict[str, int]
                  ) -> Iterator[str]:
    """Add the shapes of contacts: hidden ones of bodies that are shown; yields the names of others
    whose shape holds their centre of mass."""
    inertias = {WORLD: None, **{x.name: x.inertia for x in system.scene.model.bodies}}
    point = 2 * _ROD * _size(system)
    for name, shape in touching(system, point):
        kind, size, place = shape
        colour = UNPAINTED if name == WORLD else _colour(numbers[name])
        part = DrawnPart(numbers[name], kind, size, place, colour)
        inertia = inertias[name]
        if name in shown:
            drawing.touching.append(part)
            continue
        drawing.parts.append(part)
        if inertia and size != (point,) and _holds(shape, numbers_of(system, inertia.com)):
            yield name


def _holds(shape: Shape, point: np.ndarray) -> bool:
    """Returns whether a point lies in the shape."""
    kind, size, place = shape
    local = coscrew.double.mat3x3_from_quaternion(np.array(place[3:])).T @ (point - place[:3])
    if kind == "box":
        return bool((np.abs(local) <= np.array(size) / 2).all())
    if kind == "sphere":
        return float(np.linalg.norm(local)) <= size[0]
    return float(np.hypot(*local[:2])) <= size[0] and abs(local[2]) <= size[1] / 2


def _colour(body: int) -> tuple[float, ...]:
    return (*_COLOURS[body % len(_COLOURS)], 1.0)


def readable(visual: Visual) -> bool:
    """Returns whether a visual has a mesh that the packages that are here can read."""
    return visual.mesh is not None and (installed() or not hasattr(visual.mesh, "suffix"))


def _add_linkage(system: System, drawing: RobotDrawing, joint: Joint, numbers: dict[str, int]
                 ) -> None:
    """Add the rod from the parent's origin to the joint, and a ball where the joint moves."""
    if joint.kind.floats:
        return
    body, size = numbers[joint.parent], _size(system)
    at = numbers_of(system, joint.placement.t)
    _add_rod(drawing, body, at, _ROD * size)
    if joint.kind.moves:
        place = (*at.tolist(), *HERE[3:])
        drawing.parts.append(DrawnPart(body, "sphere", (2 * _ROD * size,), place, _LINKAGE))


def _add_rod(drawing: RobotDrawing, body: int, to: np.ndarray, radius: float) -> None:
    """Add a rod from the body's origin."""
    length = float(np.linalg.norm(to))
    if length < 3 * radius:
        return
    drawing.parts.append(DrawnPart(body, "cylinder", (radius, length), along(to / 2, to),
                                   _LINKAGE))


def _box(system: System, inertia: Inertia, body: int) -> DrawnPart:
    """The uniform box of the body's mass and inertia."""
    half, axes = box_of(*(numbers_of(system, x) for x in ((inertia.mass,), inertia.moments)))
    half = np.maximum(half, _THIN * (max(half) if max(half) > 0 else _size(system)))
    centre = numbers_of(system, inertia.com)
    place = (*centre.tolist(), *coscrew.double.quaternion_from_mat3x3(axes).tolist())
    return DrawnPart(body, "box", tuple((2 * half).tolist()), place, _colour(body))


def box_of(mass: np.ndarray, moments: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Half sides and axes (columns) of the uniform box of this mass and these moments of inertia
    xx, yy, zz, xy, xz, yz about its centre: (2 a)² = 6 (tr I - 2 I_aa) / m along each axis."""
    xx, yy, zz, xy, xz, yz = moments
    if np.any(moments[3:]):
        values, axes = np.linalg.eigh([[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]])
        axes[:, 2] *= np.sign(np.linalg.det(axes))
    else:
        values, axes = moments[:3], np.eye(3)
    squares = 6 * (values.sum() - 2 * values) / mass if mass > 0 else np.zeros(3)
    return np.sqrt(np.maximum(squares, 0)) / 2, axes


def _size(system: System) -> float:
    """The approximate size of the model: the largest distance from a joint to the next joint or a
    centre of mass; 0.1 m if that is zero."""
    model = system.scene.model
    offsets = [np.linalg.norm(numbers_of(system, j.placement.t)) for j in model.joints]
    centres = [np.linalg.norm(numbers_of(system, b.inertia.com))
               for b in model.bodies if b.inertia]
    return float(max((*offsets, *centres), default=0)) or 0.1

