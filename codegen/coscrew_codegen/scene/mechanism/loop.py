"""Closed loops: pairs of bodies that a closure holds together besides the joints of the tree, and
laws by which joints move together."""

from collections.abc import Mapping
from dataclasses import dataclass
from fractions import Fraction

from coscrew_codegen.scene.mechanism.joint_kind import Direction
from coscrew_codegen.scene.mechanism.rotations import IDENTITY, Entries, unit

Point = tuple[Fraction, ...]  # of three, in m


@dataclass(frozen=True)
class LoopKind:
    """A kind of closure: the numbers of its rows in m and in rad."""

    name: str
    words: str
    lengths: int
    angles: int

    @property
    def count(self) -> int:
        """The number of its rows."""
        return self.lengths + self.angles

    @property
    def units(self) -> tuple[str, ...]:
        """The unit of each row's closure."""
        return ("m",) * self.lengths + ("rad",) * self.angles


POINT = LoopKind("point", "both points coincide, as in a ball joint", 3, 0)
FRAME = LoopKind("frame", "both frames coincide, as if welded", 3, 3)
HINGE = LoopKind("hinge", "both points coincide, and so do the axes through them", 3, 2)
ROD = LoopKind("rod", "both points keep a distance, as if joined by a rod without mass", 1, 0)
LAW = LoopKind("law", "a sum of joints' coordinates is a polynomial of another sum", 0, 1)
LAW_OF_LENGTHS = LoopKind("law", LAW.words, 1, 0)
"""A law whose first sum is a length."""
LOOP_KINDS: Mapping[str, LoopKind] = {x.name: x for x in (POINT, FRAME, HINGE, ROD, LAW)}


@dataclass(frozen=True)
class LoopEnd:
    """The point of a body at which a loop is closed, and the axes of its frame there."""

    body: str
    point: Point = (Fraction(0),) * 3
    R: Entries = IDENTITY  # of a frame
    axis: Direction = (Fraction(0), Fraction(0), Fraction(1))  # of a hinge, of norm 1


@dataclass(frozen=True)
class WeightedCoordinate:
    """A coordinate of a joint, times a weight: a term of a sum."""

    joint: str
    coordinate: int  # its number among those of the joint
    weight: Fraction


@dataclass(frozen=True)
class Law:
    """The sum of some joints' coordinates is c0 + c1 r + c2 r² + …, r the sum of their leaders'."""

    joints: tuple[WeightedCoordinate, ...]
    leaders: tuple[WeightedCoordinate, ...]
    polynomial: tuple[Fraction, ...]
    bodies: tuple[str, ...]  # which these joints move

    @property
    def terms(self) -> tuple[WeightedCoordinate, ...]:
        """All coordinates."""
        return self.joints + self.leaders


@dataclass(frozen=True)
class ClosedLoop:
    """A closure between points of two bodies, or of a body and the world; or a law of joints, whose
    first joint connects both bodies."""

    name: str
    kind: LoopKind
    first: LoopEnd
    second: LoopEnd
    length: Fraction = Fraction(0)  # of a rod, in m
    law: Law | None = None

    @property
    def bodies(self) -> tuple[str, ...]:
        """The names of both bodies; of a law also of the others that its joints move."""
        return (self.first.body, self.second.body, *(self.law.bodies if self.law else ()))


def across(axis: Direction) -> tuple[Direction, Direction]:
    """Two directions that with the axis form a right-handed frame, after the component of the axis
    that is smallest."""
    least = min(range(3), key=lambda k: abs(axis[k]))
    first = unit(_cross(axis, tuple(Fraction(k == least) for k in range(3))))
    return first, _cross(axis, first)


def _cross(a: Direction, b: Direction) -> Direction:
    return tuple(a[i - 2] * b[i - 1] - a[i - 1] * b[i - 2] for i in range(3))
