"""Tree: a model for the algorithms of mechanics, with bodies merged across fixed joints into links
and coordinates numbered.

Links are numbered so that parents come first; link -1 is the world.  The bodies of a link have one
inertia together.  Residues of arithmetic in files, lengths and moments that are meant to be zero,
are removed before and after frames are composed.
"""

from collections.abc import Sequence
from dataclasses import dataclass, replace
from fractions import Fraction
from functools import lru_cache

from coscrew_codegen.program.scene_functions import Coordinate
from coscrew_codegen.scene.mechanism.loop import ClosedLoop
from coscrew_codegen.scene.mechanism.model import (
    HERE,
    WORLD,
    Body,
    Inertia,
    Joint,
    Model,
    Placement,
    value,
)
from coscrew_codegen.scene.mechanism.rotations import rotated, snapped, turned, unit

_ZERO = Fraction(0)
_FINEST = 2**200
"""The largest denominator of numbers in composed frames, beyond 60 digits."""


@dataclass(frozen=True)
class Driver:
    """The coordinate of a link's joint is multiplier · (the coordinate of `link`'s joint) + offset.
    """

    link: int
    multiplier: Fraction = Fraction(1)
    offset: Fraction = Fraction(0)


@dataclass(frozen=True)
class PlacedBody:
    """A body as part of a link: its frame in the link's."""

    body: Body
    placement: Placement


@dataclass(frozen=True)
class Link:
    """Bodies that move as one, beyond a joint that is not fixed."""

    joint: Joint
    parent: int
    placement: Placement  # of the joint's frame in the parent link's
    bodies: tuple[PlacedBody, ...]
    q: range
    v: range
    driver: Driver | None  # set if the joint follows another; else it has its own coordinates

    @property
    def name(self) -> str:
        """The name of the joint's child."""
        return self.joint.child

    @property
    def heading(self) -> str:
        """Heading of its instructions; differs from those of joints, effects and sums, whatever its
        name."""
        return heading_of_body(self.name)


@dataclass(frozen=True)
class Tree:
    """The links, the bodies fixed to the world, and the numbers of coordinates and velocities."""

    links: tuple[Link, ...]
    ground: tuple[PlacedBody, ...]
    nq: int
    nv: int

    @property
    def coordinates(self) -> tuple[Coordinate, ...]:
        """The joints that do not follow others, in order."""
        return tuple(Coordinate(link.joint.name, link.joint.kind.name, link.q, link.v)
                     for link in self.links if link.driver is None)

    @property
    def follows(self) -> bool:
        """True if any joint follows another."""
        return any(link.driver for link in self.links)

    def link_of(self, joint: str) -> Link:
        """The link that the joint of this name moves."""
        return next(link for link in self.links if link.joint.name == joint)

    def link_and_body(self, body: str) -> tuple[int, PlacedBody]:
        """The link a body belongs to (-1: the world, a body here as well), and the body in it."""
        if body == WORLD:
            return -1, PlacedBody(Body(WORLD), HERE)
        for number, bodies in enumerate((self.ground, *(link.bodies for link in self.links)), -1):
            for placed in bodies:
                if placed.body.name == body:
                    return number, placed
        raise KeyError(body)


def heading_of_body(name: str) -> str:
    """body 'forearm'."""
    return f"body {name!r}"


def composed(outer: Placement, inner: Placement) -> Placement:
    """D1 D2: the frame `inner` of the frame `outer`, to 60 digits after the point."""
    if HERE in (outer, inner):
        return inner if outer == HERE else outer
    R, t, rows = outer.R, outer.t, range(3)
    return Placement(
        tuple(_product(R[3 * i:3 * i + 3], inner.R[j::3], _ZERO) for i in rows for j in rows),
        tuple(_product(R[3 * i:3 * i + 3], inner.t, t[i]) for i in rows))


def inverse(frame: Placement) -> Placement:
    """D^-1 = (R^T, -R^T t)."""
    back = tuple(frame.R[3 * j + i] for i in range(3) for j in range(3))
    return Placement(back, tuple(-x for x in turned(back, frame.t)))


def _product(a: Sequence[Fraction], b: Sequence[Fraction], c: Fraction) -> Fraction:
    """a·b + c, rounded only if it has more than 60 digits: without rounding, the numbers of a
    chain of frames would grow with its length, and time with the cube of it."""
    exact = sum((x * y for x, y in zip(a, b, strict=True) if x and y), c)
    return exact if exact.denominator <= _FINEST else Fraction(round(exact * _FINEST), _FINEST)


@lru_cache(maxsize=8)  # each reader and each selection of functions asks for it again
def tree_of(model: Model, mimics: bool) -> Tree:
    """The model's tree; with `mimics`, joints that mimic others have no coordinates of their own.

    Leaders must not follow other joints (see `without_chains`)."""
    bodies = {body.name: body for body in model.bodies}
    where: dict[str, tuple[int, Placement]] = {WORLD: (-1, HERE)}
    placed: dict[int, list[PlacedBody]] = {-1: []}
    moving: list[tuple[Joint, int, Placement]] = []
    for joint in model.joints:
        parent, placement = where[joint.parent]
        placement = composed(placement, joint.placement)
        if joint.kind.moves:
            moving.append((joint, parent, without_residue(placement)))
            where[joint.child] = len(moving) - 1, HERE
        else:
            where[joint.child] = parent, placement
        link, in_link = where[joint.child]
        placed.setdefault(link, []).append(
            PlacedBody(bodies[joint.child], without_residue(in_link)))
    return _numbered(moving, placed, mimics)


def _numbered(moving: list[tuple[Joint, int, Placement]],
              bodies: dict[int, list[PlacedBody]], mimics: bool) -> Tree:
    names = {joint.name: number for number, (joint, _, _) in enumerate(moving)}
    links: list[Link] = []
    nq = nv = 0
    for number, (joint, parent, placement) in enumerate(moving):
        driver, wide_q, wide_v = None, joint.kind.nq, joint.kind.nv
        if mimics and joint.mimic:
            driver = Driver(names[joint.mimic.joint], joint.mimic.multiplier, joint.mimic.offset)
            wide_q = wide_v = 0
        links.append(Link(joint, parent, placement, tuple(bodies[number]), range(nq, nq + wide_q),
                          range(nv, nv + wide_v), driver))
        nq, nv = nq + wide_q, nv + wide_v
    return Tree(tuple(links), tuple(bodies[-1]), nq, nv)


Six = tuple[Fraction, ...]  # xx, yy, zz, xy, xz, yz

_ROUNDED = Fraction(1, 10**40)
"""Products of inertia up to this times the trace are zero, and moments that differ by as little are
equal: the residue of rotating equal moments with entries of 50 digits."""


@dataclass(frozen=True)
class LumpedInertia:
    """Mass, first moment, second moments about the origin; parameters have their default values."""

    mass: Fraction
    first: tuple[Fraction, ...]
    moments: Six

    @property
    def numbers(self) -> tuple[Fraction, ...]:
        """The mass, first moments and moments of inertia."""
        return (self.mass, *self.first, *self.moments)

    @property
    def about_com(self) -> Six:
        """The second moments about the centre of mass, if there is a mass."""
        return tuple(a - b / self.mass
                     for a, b in zip(self.moments, steiner(self.first), strict=True))


def lumped_inertia(bodies: Sequence[PlacedBody]) -> LumpedInertia:
    """The inertia of all the bodies, about their link's origin in its frame."""
    return _lumped(tuple(placed for placed in bodies if placed.body.inertia))


@lru_cache(maxsize=1024)  # of each link; every function of a scene needs it
def _lumped(bodies: tuple[PlacedBody, ...]) -> LumpedInertia:
    mass = Fraction(0)
    first: tuple[Fraction, ...] = (Fraction(0),) * 3
    moments: Six = (Fraction(0),) * 6
    for placed in bodies:
        if inertia := placed.body.inertia:
            m, R = value(inertia.mass), placed.placement.R
            com = tuple(map(value, inertia.com))
            moved = (sum((x * y for x, y in zip(R[3 * i:3 * i + 3], com, strict=True)), t)
                     for i, t in enumerate(placed.placement.t))
            at = tuple(map(_cleaned_length, moved))
            own = rotated(R, tuple(map(value, inertia.moments)))
            mass += m
            first = tuple(a + m * b for a, b in zip(first, at, strict=True))
            moments = tuple(a + b + m * c
                            for a, b, c in zip(moments, own, steiner(at), strict=True))
    return LumpedInertia(mass, first, without_turned(moments, _ROUNDED))


def steiner(at: tuple[Fraction, ...]) -> Six:
    """-c~²: the second moments of a unit mass at c about the origin."""
    x, y, z = at
    return (y * y + z * z, x * x + z * z, x * x + y * y, -x * y, -x * z, -y * z)


LENGTH = Fraction(1, 10**18)
"""Coordinates of origins and centres of mass, in m, up to which they count as zero.  Files contain
2.7e-51 m for zero, and products of two such numbers leave single precision's range.  For a robot of
a metre, 1e-18 m is 1 % of the rounding error in double precision."""

TURNED = Fraction(1, 10**15)
"""A product of inertia xy up to this times √(xx yy) counts as zero, and moments that differ by up
to this times xx as equal: residues of rotating equal moments in double precision."""


def without_residues(model: Model) -> Model:
    """The model with zero in place of its residues."""
    return replace(model, bodies=tuple(map(_cleaned_body, model.bodies)),
                   joints=tuple(map(_cleaned_joint, model.joints)),
                   loops=tuple(map(_cleaned_loop, model.loops)))


def without_residue(placement: Placement) -> Placement:
    """A frame composed of frames, rounded as theirs are: right angles that their rotations add up
    to are exact, and coordinates that cancel are zero."""
    return Placement(snapped(placement.R), tuple(map(_cleaned_length, placement.t)))


def _cleaned_length(x: Fraction) -> Fraction:
    """A coordinate, or zero up to LENGTH."""
    return Fraction(0) if abs(x) <= LENGTH else x


def _cleaned_joint(joint: Joint) -> Joint:
    at = joint.placement
    return replace(joint, placement=replace(at, t=tuple(map(_cleaned_length, at.t))))


def _cleaned_loop(loop: ClosedLoop) -> ClosedLoop:
    first, second = (replace(x, point=tuple(map(_cleaned_length, x.point)), R=snapped(x.R),
                             axis=unit(x.axis))
                     for x in (loop.first, loop.second))
    return replace(loop, first=first, second=second)


def _cleaned_body(body: Body) -> Body:
    if body.inertia is None:
        return body
    inertia = body.inertia
    return replace(body, inertia=Inertia(
        inertia.mass, tuple(_cleaned_length(value(x)) for x in inertia.com),
        without_turned(tuple(map(value, inertia.moments)), TURNED)))


def without_turned(moments: Sequence[Fraction], within: Fraction) -> tuple[Fraction, ...]:
    """Moments xx, yy, zz, xy, xz, yz without the residues of turning equal ones: products xy up to
    `within` √(xx yy) become zero, and moments that differ by up to `within` xx equal."""
    def product(xy: Fraction, xx: Fraction, yy: Fraction) -> Fraction:
        return Fraction(0) if xy * xy <= within**2 * abs(xx * yy) else xy

    def moment(yy: Fraction, xx: Fraction) -> Fraction:
        return xx if abs(yy - xx) <= within * abs(xx) else yy

    xx, yy, zz, xy, xz, yz = moments
    yy = moment(yy, xx)
    zz = moment(moment(zz, xx), yy)
    return xx, yy, zz, product(xy, xx, yy), product(xz, xx, zz), product(yz, yy, zz)
