"""Model: bodies joined into a tree by joints, as read from a file.  Frozen data, in SI units.

Numbers are exact: 0.1 in a file is 1/10 until it is emitted.  Knows nothing of files, effects, the
order of coordinates or arithmetic in kernels.
"""

from dataclasses import dataclass, field
from enum import Enum
from fractions import Fraction

from coscrew_codegen.program.values.parameter import Parameter, Scalar
from coscrew_codegen.scene.mechanism.notices import Notice

Vector = tuple[Scalar, ...]  # of three

WORLD = "world"
"""The name of the fixed reference; bodies have other names."""


def value(x: Scalar) -> Fraction:
    """The number, or the parameter's default value."""
    return x.value if isinstance(x, Parameter) else x


class Kind(Enum):
    """Kinds of joints; the value is the word in files."""

    REVOLUTE = "revolute"
    PRISMATIC = "prismatic"
    SPHERICAL = "spherical"
    FREE = "free"
    FIXED = "fixed"

    @property
    def nq(self) -> int:
        """The number of coordinates: an angle, a length, a quaternion, or position and quaternion.
        """
        return {"revolute": 1, "prismatic": 1, "spherical": 4, "free": 7, "fixed": 0}[self.value]

    @property
    def nv(self) -> int:
        """The number of velocities."""
        return {"revolute": 1, "prismatic": 1, "spherical": 3, "free": 6, "fixed": 0}[self.value]


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
    kind: Kind
    parent: str
    child: str
    placement: Placement = HERE
    axis: tuple[Fraction, ...] = (Fraction(0), Fraction(0), Fraction(1))  # of norm 1
    lower: Fraction | None = None
    upper: Fraction | None = None
    effort: Fraction | None = None
    velocity: Fraction | None = None
    damping: Fraction | None = None
    friction: Fraction | None = None
    mimic: Mimic | None = None
    faults: tuple[Fault, ...] = field(default=(), compare=False)  # of numbers that are None

    def fault(self, of: str) -> Fault | None:
        """Why the number `of` cannot be used, if the file gives one."""
        return next((x for x in self.faults if x.field == of), None)

    @property
    def in_words(self) -> str:
        """The joint's motion: "elbow turns about y", "slide moves along -z"."""
        moves = {Kind.REVOLUTE: f"turns about {self._axis}",
                 Kind.PRISMATIC: f"moves along {self._axis}", Kind.SPHERICAL: "turns freely",
                 Kind.FREE: "moves freely", Kind.FIXED: "is fixed"}
        return f"{self.name} {moves[self.kind]}"

    @property
    def _axis(self) -> str:
        """x, -y, (0.6, 0, 0.8)."""
        for letter, x in zip("xyz", self.axis, strict=True):
            if abs(x) == 1:
                return f"-{letter}" if x < 0 else letter
        return f"({', '.join(f'{float(x):.6g}' for x in self.axis)})"


@dataclass(frozen=True)
class Model:
    """Bodies and joints; every body is the child of exactly one joint, and the joints of parents
    come first."""

    name: str
    bodies: tuple[Body, ...]
    joints: tuple[Joint, ...]
    implausible: tuple[str, ...] = ()  # impossible inertias that were accepted, a line each
    notices: tuple[Notice, ...] = field(default=(), compare=False)  # what was read and is not used

    def links(self) -> dict[str, str]:
        """Maps each body, and WORLD, to the body to which fixed joints connect it: one that a joint
        moves, or WORLD."""
        found = {WORLD: WORLD}
        for joint in self.joints:
            fixed = joint.kind is Kind.FIXED
            found[joint.child] = found[joint.parent] if fixed else joint.child
        return found
