"""Errors of motions, part by part, and the sizes that they are compared with.

The parts are a joint's angles, positions and rotations; for a floating base, its position relative
to the centre of mass of its tree, and that centre of mass.  The size of a part is the largest
distance from its start.  For centres of mass, and for positions along the world, it is the largest
distance from the straight line on which they start, if that is less, but at least so large that the
rounding of the way along that line is no error; for centres of mass it is also at least the way
that the tree's radius of gyration turns, up to 1 rad.  So the speed, place and direction of a whole
scene do not matter, nor do heavy neighbours.
"""

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from enum import Enum
from functools import cached_property

import numpy as np

from coscrew_codegen.program.scene_functions import Coordinate
from coscrew_codegen.program.values.formats import Precision
from coscrew_codegen.scene.joints import KIND_NAMED
from coscrew_codegen.scene.mechanism.model import Model
from coscrew_codegen.scene.scene import Scene
from coscrew_codegen.simulation.check.error_limits import ALLOWED
from coscrew_codegen.simulation.system import System

REST = 1e-3
"""Least size of a part, in rad or m, or in m REST/100 of a scene's largest length if that is less:
the invisible trembling of a resting robot is no error."""

Places = tuple[np.ndarray, ...]
"""Place of each part, (…, k): k = 1 for a coordinate, 3 for a position, 4 for a rotation."""


class PartKind(Enum):
    """Kinds of parts of a joint's motion, and how messages name them."""

    OWN = "joint {}"  # its coordinate or rotation
    CENTRE = "centre of mass of {}"  # of the tree that a free joint carries
    OFFSET = "position of {}"  # of a free joint relative to that centre


@dataclass(frozen=True)
class StatePart:
    """A part of a scene's motion."""

    kind: PartKind
    coordinate: Coordinate
    least: float  # least size
    q: slice  # its places in the joint's q and v
    v: slice
    name: str  # in messages: "joint elbow", "centre of mass of base"
    along_world: bool = False  # whether it is a position in a frame that does not turn

    @property
    def joint(self) -> str:
        """The joint's name."""
        return self.coordinate.joint


@dataclass(frozen=True)
class StateParts:
    """The parts of a system's motion."""

    system: System

    @cached_property
    def parts(self) -> tuple[StatePart, ...]:
        """One or more for each joint that moves."""
        model, laden = self.system.scene.model, _laden(self.system.scene)
        length, steady = REST * min(1.0, 10 * model.length or 1.0), _steady(model)
        return tuple(x for c in self.system.functions.coordinates for x in _parts_of(
            c, length, c.joint in steady, c.joint in laden))

    @property
    def least(self) -> np.ndarray:
        """The sizes that count as rest.  (k)."""
        return np.array([x.least for x in self.parts])

    @cached_property
    def turning(self) -> tuple[tuple[int, int], ...]:
        """(centre of mass, rotation of the same joint): numbers of parts."""
        own = {x.joint: k for k, x in enumerate(self.parts) if x.kind is PartKind.OWN}
        return tuple((k, own[x.joint]) for k, x in enumerate(self.parts)
                     if x.kind is PartKind.CENTRE)

    def radii(self, q: np.ndarray) -> np.ndarray:
        """The radii of gyration of floating trees about their centres of mass, and zeros for all
        other parts, in m.  (…, k)."""
        M, result = self._mass_matrix(q), np.zeros((*q.shape[:-1], len(self.parts)))
        if M is None:
            return result
        for k, _ in self.turning:
            c, i = self.parts[k].coordinate, self.parts[k].coordinate.v.start
            with np.errstate(all="ignore"):
                about_origin = np.trace(M[..., i + 3:i + 6, i + 3:i + 6], axis1=-2, axis2=-1)
                square = about_origin / 2 / _mass(c, M) - np.sum(_com(c, M)**2, -1)
                result[..., k] = np.sqrt(np.where(square > 0, square, 0.0))
        return result

    def places(self, q: np.ndarray) -> Places:
        """Returns the places of the parts, in double.  (…, nq)."""
        M = self._mass_matrix(q)
        centres = {x.joint: _centre(x.coordinate, q, M) for x in self.parts
                   if x.kind is PartKind.CENTRE}
        return tuple(_place(part, q, centres) for part in self.parts)

    def velocities(self, q: np.ndarray, v: np.ndarray) -> Places:
        """The velocities of centres of mass and of positions along the world, and zeros for all
        other parts."""
        M = self._mass_matrix(q)
        return tuple(
            _velocity(x.coordinate, q, v, M) if x.kind is PartKind.CENTRE else
            v[..., x.coordinate.v][..., x.v].astype(float) if x.along_world else
            np.zeros(3 if x.kind is PartKind.OFFSET else 1) for x in self.parts)

    def distances(self, x: Places, y: Places) -> np.ndarray:
        """Returns the distances of parts at x from parts at y, in rad or m; infinite if either is
        not finite.  (…, k)."""
        with np.errstate(all="ignore"):
            each = [_angle(a, b) if a.shape[-1] == 4 else np.linalg.norm(a - b, axis=-1)
                    for a, b in zip(x, y, strict=True)]
        if not each:
            return np.zeros((*self._lead(x), 0))
        result = np.stack(np.broadcast_arrays(*each), -1)
        return np.where(np.isnan(result), np.inf, result)

    def kinetic(self, q: np.ndarray, v: np.ndarray, line: Places) -> np.ndarray:
        """The kinetic energy in frames that move with the trees' centres of mass as `line` says:
        Σ T - m V·u + m V²/2, in J.  (…)."""
        result: np.ndarray = self.system.energies(0.0, q, v)[0]
        M = self._mass_matrix(q)
        for part, V in zip(self.parts, line, strict=True):
            if part.kind is PartKind.CENTRE and M is not None and V.any():
                m, u = _mass(part.coordinate, M), _velocity(part.coordinate, q, v, M)
                result = result + m * np.sum(V * (V / 2 - u), -1)
        positive: np.ndarray = np.maximum(result, 0)
        return positive

    def _lead(self, x: Places) -> tuple[int, ...]:
        return x[0].shape[:-1] if x else ()

    def _mass_matrix(self, q: np.ndarray) -> np.ndarray | None:
        """M if a tree floats; None if none does, or if the scene has no mass matrix because of many
        joints.  (…, nv, nv)."""
        if all(x.kind is PartKind.OWN for x in self.parts) or not self.system.has("mass_matrix"):
            return None
        return np.asarray(self.system.call("mass_matrix", q=q), float)


def _parts_of(c: Coordinate, length: float, steady: bool, laden: bool) -> Iterator[StatePart]:
    """The parts of a joint's motion.  Positions and centres of mass count as no smaller than this
    length; what carries the joint is `steady` if nothing turns it.  A free joint that is `laden`
    has a position of its own: the mass matrix gives no centre of mass."""
    kind = KIND_NAMED[c.kind]
    apart = kind.floats and not laden
    own = [x for x in kind.q_parts if x[0].turns or not apart]
    for part, q, v in own:
        name = PartKind.OWN.value.format(c.joint)
        yield StatePart(PartKind.OWN, c, REST if part.turns else length, q, v,
                        f"{name} ({part.words})" if len(own) > 1 else name,
                        steady and not part.turns and kind.manifold is None)
    for of_tree in (PartKind.CENTRE, PartKind.OFFSET) if apart else ():
        yield StatePart(of_tree, c, length, slice(3), slice(3), of_tree.value.format(c.joint))


def _laden(scene: Scene) -> frozenset[str]:
    """The joints that carry bodies to which effects add inertia."""
    mover = {joint.child: joint for joint in scene.model.joints}
    results = set()
    for applied in scene.effects:
        body = applied.on if applied.effect.body_inertia else ""
        while body in mover:
            results.add(mover[body].name)
            body = mover[body].parent
    return frozenset(results)


def _place(part: StatePart, q: np.ndarray, centres: Mapping[str, np.ndarray]) -> np.ndarray:
    """Returns the place of a part; `centres` are the centres of mass of what free joints carry."""
    c = part.coordinate
    own: np.ndarray = q[..., c.q].astype(float)
    if part.kind is PartKind.OWN:
        return own[..., part.q]
    centre = centres[part.joint]
    return centre if part.kind is PartKind.CENTRE else own[..., :3] - centre


def _mass(c: Coordinate, M: np.ndarray) -> np.ndarray:
    """The mass of the tree that a free joint carries, from the mass matrix."""
    result: np.ndarray = M[..., c.v.start, c.v.start]
    return result


def _centre(c: Coordinate, q: np.ndarray, M: np.ndarray | None) -> np.ndarray:
    """The centre of mass of the tree that a free joint carries; without a mass matrix the joint's
    own position.  (…, 3)."""
    own: np.ndarray = q[..., c.q].astype(float)
    if M is None:
        return own[..., :3]
    with np.errstate(all="ignore"):
        com = _com(c, M)
        return own[..., :3] + np.where(np.isfinite(com), rotated(own[..., 3:], com), 0.0)


def _com(c: Coordinate, M: np.ndarray) -> np.ndarray:
    """The centre of mass of the tree that a free joint carries, in its body's frame.  (…, 3)."""
    i = c.v.start
    first: np.ndarray = np.stack((M[..., i + 1, i + 5], M[..., i + 2, i + 3], M[..., i, i + 4]), -1)
    result: np.ndarray = first / _mass(c, M)[..., None]
    return result


def _velocity(c: Coordinate, q: np.ndarray, v: np.ndarray, M: np.ndarray | None) -> np.ndarray:
    """The velocity of that centre of mass.  (…, 3)."""
    velocity = v[..., c.v.start:c.v.start + 3].astype(float)
    if M is not None:
        with np.errstate(all="ignore"):
            rows = M[..., c.v.start:c.v.start + 3, :]
            velocity = np.einsum("...ij,...j->...i", rows, v.astype(float)) / _mass(
                c, M)[..., None]
    return rotated(q[..., c.q][..., 3:].astype(float), velocity)


def rotated(q: np.ndarray, v: np.ndarray) -> np.ndarray:
    """R(q) v.  (…, 4), (…, 3)->(…, 3)."""
    import coscrew  # takes as long to import as short runs, and only floating trees need it

    result: np.ndarray = coscrew.rotate_qv(q, v)
    return result


def turned(x: np.ndarray, y: np.ndarray) -> np.ndarray:
    """The rotation vector from one rotation to another, in the frame of the first.  (…, 4),
    (…, 4)->(…, 3)."""
    import coscrew

    to: np.ndarray = coscrew.quaternion_product_qq(x * np.array([-1, -1, -1, 1]), y)
    result: np.ndarray = coscrew.quaternion_log(to)
    return result


def _angle(x: np.ndarray, y: np.ndarray) -> np.ndarray:
    """The angle between two rotations, from the chord of their quaternions."""
    chord = np.minimum(np.linalg.norm(x - y, axis=-1), np.linalg.norm(x + y, axis=-1))
    result: np.ndarray = 4 * np.arcsin(np.minimum(chord / 2, 1))
    return result


def _steady(model: Model) -> frozenset[str]:
    """The joints of whose ancestors none rotates: their positions are along the world."""
    turned: set[str] = set()  # bodies
    results = set()
    for joint in model.joints:
        if joint.parent not in turned:
            results.add(joint.name)
        if joint.parent in turned or any(x.turns for x in joint.kind.parts):
            turned.add(joint.child)
    return frozenset(results)


@dataclass
class Extent:
    """Distances of parts from their starts, and from their lines of start, since a run in this
    precision and in steps of h began."""

    parts: StateParts
    precision: Precision
    h: float
    start: Places
    line: Places
    radii: np.ndarray  # of gyration
    way: np.ndarray  # from the starts, (…, k)
    off: np.ndarray  # from the lines
    rounded: np.ndarray  # rounding of the ways along the lines: at most u a step

    @staticmethod
    def since(parts: StateParts, precision: Precision, h: float, q: np.ndarray, v: np.ndarray
              ) -> "Extent":
        """The extent of a run which starts at q and v."""
        none = np.zeros((*q.shape[:-1], len(parts.parts)))
        return Extent(parts, precision, h, parts.places(q), parts.velocities(q, v),
                      parts.radii(q), none, none, none)

    def add(self, after: float | np.ndarray, places: Places) -> None:
        """Notes the places of the parts after so many seconds; arrays of times and places have an
        axis of samples before the last one."""
        times = np.asarray(after, float)[..., None]
        start, line = ([x[..., None, :] if times.ndim > 1 and x.ndim > 1 else x for x in of]
                       for of in (self.start, self.line))
        gone = [times * u for u in line]
        self.way = self._largest(self.way, self.parts.distances(places, tuple(start)))
        if not any(u.any() for u in line):
            self.off = self.way
            return
        ends = tuple(x + u for x, u in zip(start, gone, strict=True))
        self.off = self._largest(self.off, self.parts.distances(places, ends))
        ways = np.stack(np.broadcast_arrays(*(np.linalg.norm(u, axis=-1) for u in gone)), -1)
        ways = np.minimum(ways, self.way[..., None, :] if times.ndim > 1 else self.way)
        self.rounded = self._largest(self.rounded, ways * times * (
            float(self.precision.u) / self.h))

    def _largest(self, so_far: np.ndarray, now: np.ndarray) -> np.ndarray:
        """The largest of the distances so far and now, which may have an axis of samples."""
        if now.ndim > so_far.ndim:
            now = np.max(now, axis=-2)
        result: np.ndarray = np.fmax(so_far, np.where(np.isfinite(now), now, 0))
        return result

    @property
    def sizes(self) -> np.ndarray:
        """The sizes of the parts, none below that of rest.  (…, k)."""
        result: np.ndarray = np.maximum(np.minimum(self.way, self.off), self.parts.least)
        result[...] = np.maximum(result, self.rounded / ALLOWED)
        for k, turn in self.parts.turning:
            arc = self.radii[..., k] * np.minimum(self.way[..., turn], 1.0)
            result[..., k] = np.maximum(result[..., k], arc)
        return result
