"""Kinds of joints: a joint's coordinates, and the motion of its child as a function of them.

A kind's file knows no tree, no algorithm and no language: it gets the joint's axes, its coordinates
and its velocities as numbers, recorded ones or others, and returns a displacement and screws.
Screws are (v; ω) of the child's origin relative to the parent, in the child's frame:

    s = S(q) v,   s' = S(q) a + S'(q, v) v"""

from abc import ABC, abstractmethod
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property

from coscrew_codegen.algebra.recording.numbers import (
    Number,
    Vector,
    dot,
    equal,
    scaled,
    sqrt,
    where,
)

Numbers = Sequence[Number]
Screw = tuple[Number, ...]  # six: linear, angular
Displacement = tuple[Number, ...]  # twelve: [R | t], row by row
Direction = tuple[Fraction, ...]  # three, of norm 1

_FREE_MOTION = 6
"""The most velocities that a joint can have."""


@dataclass(frozen=True)
class CoordinatePart:
    """Coordinates that belong together: numbers of one unit, or a unit quaternion.

    Numbers have as many velocities, a quaternion has three: the angular velocity."""

    words: str  # "position", "rotation"
    unit: str  # m or rad; 1 of a quaternion
    count: int = 1
    quaternion: bool = False

    @property
    def neutral(self) -> tuple[float, ...]:
        """The coordinates at which the displacement is the identity."""
        return (0.0, 0.0, 0.0, 1.0) if self.quaternion else (0.0,) * self.count

    @property
    def speeds(self) -> int:
        """The number of velocities."""
        return 3 if self.quaternion else self.count

    @property
    def turns(self) -> bool:
        """True if its velocities are angular."""
        return self.quaternion or self.unit == "rad"


def numbers(words: str, unit: str, count: int = 1) -> CoordinatePart:
    """Coordinates of one unit: a position of three lengths, an angle."""
    return CoordinatePart(words, unit, count)


ROTATION = CoordinatePart("rotation", "1", 4, quaternion=True)
"""A unit quaternion (x, y, z, w)."""


@dataclass(frozen=True)
class JointState(ABC):
    """A joint at its coordinates q, and the operations on its numbers.

    `axes` are those of the kind's `frame`, in the child's frame at the neutral q, which is then the
    joint's.  Rotations R are nine numbers, row by row."""

    axes: tuple[Vector, ...]
    q: tuple[Number, ...]

    @abstractmethod
    def numbers(self, values: Sequence[int]) -> tuple[Number, ...]:
        """Constants."""

    @property
    def zero(self) -> Vector:
        """Three zeros."""
        return self.numbers((0, 0, 0))

    @abstractmethod
    def rotation(self, axis: Vector, angle: Number) -> tuple[Number, ...]:
        """R of a rotation by an angle about an axis of norm 1."""

    @abstractmethod
    def quaternion_rotation(self, q: Numbers) -> tuple[Number, ...]:
        """R of a quaternion (x, y, z, w) of norm 1."""

    @abstractmethod
    def composed(self, first: Displacement, second: Displacement) -> Displacement:
        """D₁ D₂."""

    @abstractmethod
    def turned(self, first: Displacement, R: Numbers) -> Displacement:
        """D [R | 0]."""

    @abstractmethod
    def rotated(self, R: Numbers, a: Vector) -> Vector:
        """R a."""

    @abstractmethod
    def rotated_back(self, R: Numbers, a: Vector) -> Vector:
        """R^T a."""

    @abstractmethod
    def quaternion_product(self, a: Numbers, b: Numbers) -> tuple[Number, ...]:
        """a b."""

    @abstractmethod
    def quaternion_rotated(self, q: Numbers, a: Vector) -> Vector:
        """R(q) a."""

    @abstractmethod
    def cross(self, a: Vector, b: Vector) -> Vector:
        """a × b."""


@dataclass(frozen=True)
class Manifold:
    """Motion of coordinates whose rates are not the velocities.

    q ⊕ phi moves by the velocities phi for a time of 1, from q; `difference` is the shortest such
    phi between two q; `bracket` is [phi, v], the rate at which velocities of the kind's group turn
    each other.  They take recorded numbers."""

    integrated: Callable[[Numbers, Numbers], Numbers]  # (q, phi) -> q ⊕ phi
    difference: Callable[[Numbers, Numbers], Numbers]  # (q1, q0) -> phi with q0 ⊕ phi = q1
    bracket: Callable[[Numbers, Numbers], Numbers]  # (phi, v) -> [phi, v]
    rates: Callable[[JointState, Numbers, Numbers], Numbers]  # (state, r, v) -> r', where r is the
    # state's q before quaternions were normalized: r' is linear in each quaternion of r
    velocities: Callable[[Numbers, Numbers], Numbers]  # (q, q') -> v, the inverse of rates; linear
    # in q', and zero for a q' along a quaternion of norm 1
    deviation: Callable[[Numbers, Numbers], Numbers] | None = None  # (q, q0) -> e, a component for
    # each velocity, by which springs act: |e|²/2 is an energy, and e its slope along the velocities
    inertial: Callable[[Numbers], Numbers] | None = None  # v -> the torques at a = 0 of the kinetic
    # energy v·v/2, unless they are zero


@dataclass(frozen=True, eq=False)
class JointKind:
    """A kind of joint: its name in files, its coordinates, and the motion of its child.

    Limits and `mimic` are for kinds with one coordinate whose rate is its velocity, and so are
    effects at joints, unless they act along each velocity."""

    name: str  # in scenes
    place: int  # among the kinds
    motion: str  # after a joint's name; {0} is its axis: "turns about {0}"
    parts: tuple[CoordinatePart, ...]
    q_words: str  # "in rad", "position in m, then …": after "q" in headers and documents
    v_words: str
    displacement: Callable[[JointState, Displacement], Displacement]  # of the child in what carries
    # it, given the placement of the joint's frame
    subspace: Callable[[JointState], Sequence[Screw]]  # S: a screw for each velocity
    subspace_rate: Callable[[JointState, Numbers], Screw] | None = None  # S' v, unless zero
    manifold: Manifold | None = None  # None: q' = v
    axes: tuple[str, ...] = ()  # what each axis that files give is: "axis of rotation"
    perpendicular: bool = False  # whether the axes must be
    frame: Callable[[tuple[Direction, ...]], tuple[Direction, ...]] = lambda axes: axes  # the
    # directions by which it moves, from the axes in files
    unlimited: tuple[str, ...] = ()  # further names in scenes and URDF, of joints without a range
    urdf: str = ""  # URDF's name; "" if it has none
    without_urdf: str = ""  # joints of URDF that move alike
    synonyms: tuple[str, ...] = ()  # other tools' names
    base: bool = False  # whether a scene's `base` can be of this kind
    floats: bool = False  # whether its velocities are the child's twist, and its first coordinates
    # the child's position: then steps keep the momentum of what floats

    def __post_init__(self) -> None:
        if self.nv > _FREE_MOTION:
            raise ValueError(f"a kind of joint is called {self.name!r} and has {self.nv} "
                             f"velocities; wanted at most {_FREE_MOTION}")
        if self.quaternions and not self.manifold:
            raise ValueError(f"a kind of joint is called {self.name!r} and has a quaternion; "
                             "wanted a manifold, which moves it")

    @cached_property
    def nq(self) -> int:
        """The number of coordinates."""
        return sum(x.count for x in self.parts)

    @cached_property
    def nv(self) -> int:
        """The number of velocities."""
        return sum(x.speeds for x in self.parts)

    @property
    def moves(self) -> bool:
        """True if the child moves at all."""
        return self.nv > 0

    @property
    def one_coordinate(self) -> bool:
        """True if it has one coordinate, whose rate is the velocity."""
        return self.nq == 1 and self.manifold is None

    @property
    def has_rest(self) -> bool:
        """True if springs can act on its joints."""
        return self.moves and (self.manifold is None or self.manifold.deviation is not None)

    @property
    def by_angle(self) -> bool:
        """True if it turns about a point: its rotation has an angle."""
        return self.nv == 3 and self.manifold is not None and self.manifold.deviation is not None

    @property
    def slides(self) -> bool:
        """True if it has one coordinate, which is a length."""
        return self.one_coordinate and not self.parts[0].turns

    @property
    def neutral(self) -> tuple[float, ...]:
        """The q at which the displacement is the identity."""
        return tuple(number for x in self.parts for number in x.neutral)

    @cached_property
    def q_parts(self) -> tuple[tuple[CoordinatePart, slice, slice], ...]:
        """Each part with its places in the joint's q and v."""
        parts, q, v = [], 0, 0
        for x in self.parts:
            parts.append((x, slice(q, q + x.count), slice(v, v + x.speeds)))
            q, v = q + x.count, v + x.speeds
        return tuple(parts)

    @property
    def quaternions(self) -> tuple[slice, ...]:
        """The places of quaternions in the joint's q."""
        return tuple(q for x, q, _ in self.q_parts if x.quaternion)

    def units(self, of: str) -> tuple[str, ...]:
        """Units of the joint's q, v or a."""
        if of == "q":
            return tuple(x.unit for x in self.parts for _ in range(x.count))
        per = {"v": "s", "a": "s^2"}[of]
        return tuple(f"{'rad' if x.turns else x.unit}/{per}"
                     for x in self.parts for _ in range(x.speeds))

    @property
    def state_in_words(self) -> str:
        """q and v: "q in rad; v in rad/s"."""
        return "; ".join(f"{name}{' ' if words.startswith('in ') else ': '}{words}"
                         for name, words in (("q", self.q_words), ("v", self.v_words)))

    def in_words(self, axes: Sequence[str]) -> str:
        """The motion, with these words for the axes: "turns about -z"."""
        return self.motion.format(*axes)


def call(operation: str, *arguments: Numbers) -> tuple[Number, ...]:
    """The results of an operation of the library on recorded numbers."""
    return arguments[0][0].recorder.call(operation, *arguments)


def quaternion_integrated(q: Numbers, step: Numbers) -> tuple[Number, ...]:
    """q exp(step/2) / |q exp(step/2)|: of norm 1 to rounding for any q whose square neither over-
    nor underflows, so rounding errors do not add up, and a wrong norm does not last."""
    turned = call("quaternion_product_qq", q, call("quaternion_exp", step))
    (square,) = call("dot_qq", turned, turned)
    return scaled(1 / sqrt(square), turned)


def quaternion_rate(x: JointState, q: Numbers, omega: Numbers) -> tuple[Number, ...]:
    """q (ω; 0) / 2."""
    return x.quaternion_product(q, (*(w / 2 for w in omega), *x.numbers((0,))))


def quaternion_difference(q1: Numbers, q0: Numbers) -> tuple[Number, ...]:
    """The rotation vector of q0* q1.  That of a quaternion (v; w) near ±1 is 2 w v: there the
    length of v, by which the logarithm divides, has no derivative."""
    between = call("quaternion_product_qq", _conjugated(q0), q1)
    v, w = tuple(between[:3]), between[3]
    near, turn = equal(dot(v, v), 0), call("quaternion_log", between)
    return tuple(where(near, 2 * w * x, y) for x, y in zip(v, turn, strict=True))


def quaternion_velocity(q: Numbers, rate: Numbers) -> tuple[Number, ...]:
    """ω = 2 vec(q* q'), of a quaternion of norm 1."""
    product = call("quaternion_product_qq", _conjugated(q), rate)
    return tuple(2 * x for x in product[:3])


def _conjugated(q: Numbers) -> tuple[Number, ...]:
    return call("quaternion_conjugated", q)
