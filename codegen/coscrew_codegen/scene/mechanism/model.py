"""Model: bodies joined into a tree by joints, as read from a file.  Frozen data, in SI units.

Numbers are exact: 0.1 in a file is 1/10 until it is emitted.  Knows nothing of files, effects, the
order of coordinates or arithmetic in kernels.
"""

from dataclasses import dataclass, field
from fractions import Fraction

from coscrew_codegen.program.values.parameter import Parameter, Scalar
from coscrew_codegen.scene.mechanism.collision import Collision
from coscrew_codegen.scene.mechanism.joint_kind import Direction, JointKind
from coscrew_codegen.scene.mechanism.loop import ClosedLoop
from coscrew_codegen.scene.mechanism.notices import Notice
from coscrew_codegen.scene.mechanism.visual import Visual

Vector = tuple[Scalar, ...]  # of three

WORLD = "world"
"""The name of the fixed reference; bodies have other names."""

UNHASHED_IF_EMPTY = {"unhashed if empty": True}
"""Of fields that leave the hashes of a scene unchanged while they are empty: recordings made before
a field was added remain those of their scene."""


def value(x: Scalar) -> Fraction:
    """The number, or the parameter's default value."""
    return x.value if isinstance(x, Parameter) else x


@dataclass(frozen=True)
class Placement:
    """A frame's rotation, row by row, and origin, in m, in another frame."""

    R: tuple[Fraction, ...]
    t: tuple[Fraction, ...]


HERE = Placement(tuple(Fraction(i % 4 == 0) for i in range(9)), (Fraction(0),) * 3)


@dataclass(frozen=True)
class Inertia:
    """Mass in kg, its centre in m, moments xx, yy, zz, xy, xz, yz about the centre in kg m²: all in
    the body's frame."""

    mass: Scalar
    com: Vector
    moments: tuple[Scalar, ...]

    @property
    def changes(self) -> bool:
        """True if any of its numbers is a parameter."""
        return any(isinstance(x, Parameter) for x in (self.mass, *self.com, *self.moments))


@dataclass(frozen=True)
class Body:
    """A rigid body; without inertia it is only a frame."""

    name: str
    inertia: Inertia | None = None
    visuals: tuple[Visual, ...] = field(default=(), compare=False, repr=False)  # to be seen


@dataclass(frozen=True)
class Mimic:
    """q = multiplier · q of another joint + offset."""

    joint: str
    multiplier: Fraction
    offset: Fraction


Limits = tuple[Fraction | None, Fraction | None, Fraction | None, Fraction | None]
"""lower, upper, effort, velocity of a joint, as far as they are given."""


@dataclass(frozen=True)
class Fault:
    """The reason why a number of a joint cannot be used: an effect that takes it is refused."""

    field: str  # of Joint: "upper", "mimic"
    problem: str  # "'upper' of <limit>: inf is not finite; wanted a number"
    place: str  # "arm.urdf, line 7"

    def __str__(self) -> str:
        return f"{self.place}: {self.problem}"


@dataclass(frozen=True)
class Joint:
    """Lets the body `child` move in the body `parent` (or WORLD).

    `placement` is the child's frame in the parent's when all coordinates are zero.  Limits, damping
    and friction are data from the file, which effects may use.
    """

    name: str
    kind: JointKind
    parent: str
    child: str
    placement: Placement = HERE
    axis: Direction = (Fraction(0), Fraction(0), Fraction(1))  # of norm 1
    lower: Fraction | None = None
    upper: Fraction | None = None
    effort: Fraction | None = None
    velocity: Fraction | None = None
    damping: Fraction | None = None
    friction: Fraction | None = None
    mimic: Mimic | None = None
    axis2: Direction | None = None  # of kinds with two axes
    faults: tuple[Fault, ...] = field(default=(), compare=False)  # of numbers that are None

    def __post_init__(self) -> None:
        if len(self.kind.axes) > 1 and self.axis2 is None:
            raise ValueError(f"joint {self.name!r} is {self.kind.name}; wanted its axis2")

    def fault(self, of: str) -> Fault | None:
        """Says why the number `of` cannot be used, if the file gives one."""
        return next((x for x in self.faults if x.field == of), None)

    @property
    def in_words(self) -> str:
        """The joint's motion: "elbow turns about y", "slide moves along -z"."""
        return f"{self.name} {self.kind.in_words([*map(_direction, self.axes)])}"

    @property
    def axes(self) -> tuple[Direction, ...]:
        """The axes that its kind has, in the joint's frame."""
        both = (self.axis, *([self.axis2] if self.axis2 else []))
        return both[:len(self.kind.axes)]

    @property
    def directions(self) -> tuple[Direction, ...]:
        """The directions by which its kind moves, in the joint's frame."""
        return self.kind.frame(self.axes)


def _direction(axis: Direction) -> str:
    """x, -y, (0.6, 0, 0.8)."""
    for letter, x in zip("xyz", axis, strict=True):
        if abs(x) == 1:
            return f"-{letter}" if x < 0 else letter
    return f"({', '.join(f'{float(x):.6g}' for x in axis)})"


@dataclass(frozen=True)
class Model:
    """Bodies and joints; every body is the child of exactly one joint, and the joints of parents
    come first."""

    name: str
    bodies: tuple[Body, ...]
    joints: tuple[Joint, ...]
    implausible: tuple[str, ...] = ()  # impossible inertias that were accepted, a line each
    notices: tuple[Notice, ...] = field(default=(), compare=False)  # read, but not used
    collisions: tuple[Collision, ...] = field(default=(), compare=False, repr=False)  # likewise
    loops: tuple[ClosedLoop, ...] = field(default=(), metadata=UNHASHED_IF_EMPTY)

    def links(self) -> dict[str, str]:
        """Maps each body, and WORLD, to the body to which fixed joints connect it: one that a joint
        moves, or WORLD."""
        links_of = {WORLD: WORLD}
        for joint in self.joints:
            links_of[joint.child] = joint.child if joint.kind.moves else links_of[joint.parent]
        return links_of

    @property
    def length(self) -> float:
        """The largest length: from a joint to the next or to a centre of mass, or a radius of
        gyration, in m."""
        lengths = [abs(value(x)) for joint in self.joints for x in joint.placement.t]
        for body in self.bodies:
            if body.inertia:
                lengths += [abs(value(x)) for x in body.inertia.com]
                mass = value(body.inertia.mass)
                moments = sum((abs(value(x)) for x in body.inertia.moments[:3]), Fraction(0))
                lengths += [Fraction(float(moments / mass / 2)**0.5)] if mass else []
        return float(max(lengths, default=Fraction(0)))
