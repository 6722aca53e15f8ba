"""Tree: a model for the algorithms of mechanics, with bodies merged across fixed joints into links
and coordinates numbered.

Links are numbered so that parents come first; link -1 is the world.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import lru_cache

from coscrew_codegen.program.scene_functions import Coordinate
from coscrew_codegen.scene.mechanism.model import HERE, WORLD, Body, Joint, Model, Placement
from coscrew_codegen.scene.mechanism.rotations import turned
from coscrew_codegen.scene.mechanism.roundoff_cleanup import without_residue

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
