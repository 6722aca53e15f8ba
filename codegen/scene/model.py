"""Model: bodies joined into a tree by joints, as read from a file.  Frozen data, in SI units.

Numbers are exact: what a file writes as 0.1 is 1/10 until it is emitted.  Knows nothing of files,
effects, coordinates' order or arithmetic in kernels.
"""

from dataclasses import dataclass
from enum import Enum
from fractions import Fraction

from coscrew_codegen.parameter import Parameter, Scalar

Vector = tuple[Scalar, ...]  # of three

WORLD = "world"
"""The name of what does not move; bodies have other names."""


def value(x: Scalar) -> Fraction:
    """The number, or the value of the parameter where nothing else is given."""
    return x.value if isinstance(x, Parameter) else x


class Kind(Enum):
    """How a joint moves; its value is the word files use."""

    REVOLUTE = "revolute"
    PRISMATIC = "prismatic"
    SPHERICAL = "spherical"
    FREE = "free"
    FIXED = "fixed"

    @property
    def nq(self) -> int:
        """How many coordinates: an angle, a length, a quaternion, position and quaternion."""
        return {"revolute": 1, "prismatic": 1, "spherical": 4, "free": 7, "fixed": 0}[self.value]

    @property
    def nv(self) -> int:
        """How many speeds."""
        return {"revolute": 1, "prismatic": 1, "spherical": 3, "free": 6, "fixed": 0}[self.value]


@dataclass(frozen=True)
class Placement:
    """Where a frame is in another: rotation, row by row, and origin in m."""

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


@dataclass(frozen=True)
class Body:
    """A rigid body; without inertia it only carries others."""

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
class Joint:
    """Lets the body `child` move in the body `parent` (or WORLD).

    `placement` is the child's frame in the parent's while all coordinates are zero.  Limits,
    damping and friction are what the file says of them: effects may take them over.
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

    @property
    def in_words(self) -> str:
        """How it moves: "elbow turns about y", "slide moves along -z"."""
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
    """Bodies and joints; every body is the child of just one joint, parents' joints come first."""

    name: str
    bodies: tuple[Body, ...]
    joints: tuple[Joint, ...]
    implausible: tuple[str, ...] = ()  # what no real body has and was let through, one a line
