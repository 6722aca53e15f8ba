"""Effects: catalogue entries, and the slots of the dynamics that they fill.

An effect's file knows no other effect and no algorithm: it gets the state at its joint or body as
Numbers, and returns accelerations, forces and inertias.  Slots it leaves None cost nothing."""

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from enum import Enum
from fractions import Fraction
from typing import Protocol, TypeVar

from coscrew_codegen.algebra.recording.numbers import Number, Vector
from coscrew_codegen.program.values.parameter import Sign
from coscrew_codegen.scene.contacts.closeness import BodyContact, Contact, Resting
from coscrew_codegen.scene.mechanism.collision import Collision

K = TypeVar("K")
Given = Mapping[str, object]
"""Values of parameters, by name."""


Surface = Callable[[Number, Number], tuple[Number, Number, Number]]
"""(x, y) -> a function of them, and its slopes by both."""


@dataclass(frozen=True)
class Values:
    """Values that a scene gives for an effect's parameters; formulas are evaluated at the current
    time."""

    given: Mapping[str, object]

    def __getitem__(self, name: str) -> Number:
        """A number."""
        return self._of(Number, name)

    def get(self, name: str) -> Number | None:
        """A number, if there is one."""
        return None if self.given[name] is None else self[name]

    def vector(self, name: str) -> Vector:
        """Three numbers."""
        return self._of(tuple, name)

    def optional_vector(self, name: str) -> Vector | None:
        """Three numbers, if there are any."""
        return None if self.given[name] is None else self.vector(name)

    def surface(self, name: str) -> Surface | None:
        """A function of a place, if there is one."""
        value = self.given[name]
        return value if callable(value) else None

    def word(self, name: str) -> str:
        """A choice."""
        return self._of(str, name)

    def _of(self, kind: type[K], name: str) -> K:
        value = self.given.get(name)
        if not isinstance(value, kind):
            raise TypeError(f"parameter {name!r} is {type(value).__name__}; wanted {kind.__name__}")
        return value


class Place(Enum):
    """Kinds of things that an effect acts on."""

    SCENE = "the whole scene"
    JOINT = "a joint with one coordinate, a weighted sum of coordinates, or a joint's velocities"
    BODY = "a body"
    PAIR = "two bodies, named by the value `bodies`"


@dataclass(frozen=True)
class ParameterOf:
    """A parameter of an effect, as scene files write it."""

    name: str
    unit: str
    words: str
    kind: str = "number"  # number, vector (three numbers), matrix (symmetric, 6×6), formula (number
    # or function of t), formulas (three of them), height (function of x and y),
    # choice, body, flag (true or false)
    default: Fraction | int | str | tuple[Fraction, ...] | None = None  # None: there is none
    required: bool = True  # without default; if not, the value may stay None, also where the model
    # has no such number
    model: str = ""  # the joint's field that "model" stands for: damping, friction, effort, …
    choices: tuple[str, ...] = ()
    of: tuple[str, ...] = ()  # choices of the effect's `kind` it belongs to; with others it may not
    # be given, and its value is None; (): to all
    optional_of: tuple[str, ...] = ()  # the choices among these with which it may be left out
    positive: bool = False  # refused if zero or below
    nonnegative: bool = False
    rate_of: str = ""  # the parameter whose rate is its default, where that is a trajectory
    needs: str = ""  # the parameter without which it may not be given
    example: str = "1"  # in TOML, for messages that propose the effect

    @property
    def sign(self) -> Sign | None:
        """The sign that its numbers must have, if any."""
        return (Sign.POSITIVE if self.positive else
                Sign.NONNEGATIVE if self.nonnegative else None)


@dataclass(frozen=True)
class StateOf:
    """A number x that an effect carries from step to step, from 0 at the start."""

    name: str
    unit: str  # on a joint that turns; its metres stand behind "or", as those of parameters
    words: str
    of: str = ""  # the parameter without which the effect does not have it
    starts: str = ""  # q or v: the number of the joint from which it starts instead


@dataclass(frozen=True)
class CoordinateState:
    """State of the coordinate along which a torque or force acts: a joint's, a weighted sum of
    several, or the distance between two points.  Of an effect along each velocity of a joint with
    several, q is the coordinate that has the velocity for its rate, or the deviation from rest.

    Its value q in rad or m, its rate v = q', the time t in s; for effects that compensate gravity
    also the torque that holds the joint against it; for effects with states these, x."""

    q: Number
    v: Number
    t: Number
    holding: Number | None = None
    x: Vector = ()


class BodyState(Protocol):
    """State of a body: inertia, pose and motion; time t in s.

    Points and vectors are in the body's frame unless a name says `world`."""

    t: Number

    @property
    def x(self) -> Vector:
        """The effect's states."""

    @property
    def mass(self) -> Number:
        """Mass in kg; zero if the model gives none."""

    @property
    def centre_of_mass(self) -> Vector:
        """Centre of mass in the body's frame, in m."""

    @property
    def inertia(self) -> tuple[Number, ...]:
        """Moments xx, yy, zz, xy, xz, yz about the centre of mass, in kg m²."""

    @property
    def gravity(self) -> Vector:
        """The scene's acceleration of free fall, in the world's frame; zero without gravity."""

    @property
    def angular_velocity(self) -> Vector:
        """ω."""

    def world_direction(self, vector: Vector) -> Vector:
        """R x: a vector in the body's frame expressed in the world's."""

    def own_direction(self, vector: Vector) -> Vector:
        """R^T x: a vector in the world's frame expressed in the body's."""

    def world_position(self, point: Vector) -> Vector:
        """R x + t: the position of a point of the body."""

    def velocity(self, point: Vector) -> Vector:
        """v + ω × x: the velocity of a point of the body."""

    def velocity_in_fluid(self, point: Vector) -> Vector:
        """The velocity of a point of the body less that of the fluid around it."""

    def above_ground(self, position: Vector) -> tuple[Number, Vector]:
        """The distance of a position from the ground, and the ground's normal there, both in the
        world's frame."""


@dataclass(frozen=True)
class Elastic:
    """Numbers of an elastic gear: the rotor's inertia, the stiffness and the damping between rotor
    and joint."""

    inertia: Number
    stiffness: Number
    damping: Number


@dataclass(frozen=True)
class Torque:
    """Torque along a joint's coordinate, or a force that pushes two points apart.

    Without a `torque`, it is -∂energy/∂q.  `limit`: it acts as max(-limit, min(torque, limit)).
    `no_load`: the speed to which the limit of a torque that drives falls, linearly, to zero.
    `energy`: its potential energy, if it has one.  `power`: the power of the part without potential
    energy; by default the torque's whole power if there is no energy, else zero.

    Implicit steps take -∂torque/∂v and -∂torque/∂q from the torque itself
    (`dynamics/forces/linearization.py` says how they are bounded). `damping`, `stiffness`: these,
    at least 0, from an effect that has a shorter form of them.

    `rates` are x' of the effect's states.  With a `share`, `bounded` are the states and share times
    these are those within their bounds: a step moves x by its rates, and then puts it there.
    `switches`: numbers that change their signs where another part of the law begins.  `stored`: the
    energy of bristles, which `power` counts as spent.

    With a `lag` the torque within its limit is what is demanded, and x the torque that acts: x' =
    (demand - x)/lag.  With `elastic` x are the angle and the speed of a rotor."""

    torque: Number | None = None
    limit: Number | None = None
    no_load: Number | None = None
    energy: Number | None = None
    power: Number | None = None
    contact: Contact | None = None
    damping: Number | None = None
    stiffness: Number | None = None
    rates: Vector = ()
    bounded: Vector = ()
    share: Number | None = None
    switches: Vector = ()
    stored: Number | None = None
    lag: Number | None = None
    elastic: Elastic | None = None
    ahead: bool = False  # implicit steps take its damping also from the middle of the step, where
    # that is larger: it starts at once, at some speed


@dataclass(frozen=True)
class Slopes:
    """-∂force/∂v and -∂force/∂q along a coordinate, in N s/m and N/m (a joint's: N m s and N m), or
    bounds of them; at least 0."""

    damping: Number
    stiffness: Number


@dataclass(frozen=True)
class PointSlopes:
    """The slopes of a force along a direction of length 1, in the body's frame, and across it."""

    across: Slopes
    along: Slopes
    direction: Vector


@dataclass(frozen=True)
class Force:
    """Force on a body at a point of it and a moment, in the body's frame; energy and power as in
    Torque.

    Without point, force and moment they follow from the energy: -∂energy/∂(position, rotation).
    Such an energy may depend on the body's pose and on time, not on its motion.

    `slopes` are -∂force/∂ of the point's velocity and position: implicit steps take them in as
    inertias at the point.  `rates`, `bounded`, `share`, `switches`, `stored` as in Torque."""

    point: Vector | None = None
    force: Vector | None = None
    moment: Vector | None = None
    energy: Number | None = None
    power: Number | None = None
    slopes: Slopes | PointSlopes | None = None  # Slopes: the same in all directions
    turning: PointSlopes | None = None  # likewise -∂moment/∂ of the angular velocity, with `slopes`
    contact: BodyContact | None = None
    rates: Vector = ()
    bounded: Vector = ()
    share: Number | None = None
    switches: Vector = ()
    stored: Number | None = None


@dataclass(frozen=True)
class ContactForce:
    """The force on the first surface, in the world's frame, and what steps need of it."""

    force: Vector
    energy: Number
    power: Number
    across: Slopes
    along: Slopes
    rates: Vector
    bounded: Vector
    share: Number
    switches: Vector
    stored: Number
    contact: BodyContact
    moment: Vector = ()
    rolling: Slopes | None = None  # -∂moment/∂w across the normal
    torsional: Slopes | None = None  # and about it


@dataclass(frozen=True)
class TwoBodies:
    """The states of two bodies, of the effect between them, and the vector from a point of the
    second to one of the first, in the world's frame."""

    first: BodyState
    second: BodyState
    x: Vector
    apart: Callable[[Vector, Vector], Vector]


@dataclass(frozen=True)
class Between:
    """A contact of two bodies: the same place in the frame of each, the normal towards the first,
    and its velocity there relative to the second, both in the world's frame."""

    places: tuple[Vector, Vector]
    n: Vector
    u: Vector
    law: ContactForce


@dataclass(frozen=True)
class BodyInertia:
    """Inertia that an effect adds to a body at a point of it: 36 numbers of a symmetric matrix, row
    by row, for the point's velocity and the angular velocity, in the body's axes."""

    point: Vector
    matrix: tuple[Number, ...]


def required(x: K | None) -> K:
    """Returns a value that an effect gives.  Raises TypeError if it gives neither this value nor an
    energy from which it follows."""
    if x is None:
        raise TypeError("an effect gives a torque, or a force and its point, or an energy; this "
                        "one gives none")
    return x


FIRST, SECOND = "first", "second"
POINTS = tuple(ParameterOf(name, "m", f"where it is fixed to the {name} body, in its frame",
                           "vector", (Fraction(0),) * 3) for name in (FIRST, SECOND))
"""The parameters of an effect on two bodies that give the points between which it acts."""


@dataclass(frozen=True)
class Effect:
    """One entry of the catalogue."""

    name: str
    words: str  # one line
    equation: str
    place: Place
    parameters: tuple[ParameterOf, ...]
    any_of: tuple[str, ...] = ()  # one of these parameters, at least, must have a value
    ascending: tuple[str, str] | None = None  # the ends of the range it keeps a
    # joint in; the first must not exceed the second
    gravity: Callable[[Values], Vector] | None = None  # in the world's frame
    wind: Callable[[Values], Vector] | None = None  # the fluid's velocity, in the world's frame
    ground: Callable[[Values, Vector], tuple[Number, Vector]] | None = None  # of a position: its
    # distance from the ground, and the ground's normal there, in the world's frame
    joint_torque: Callable[[CoordinateState, Values], Torque] | None = None
    joint_inertia: Callable[[Values], Number] | None = None
    body_force: Callable[[BodyState, Values], Force] | None = None
    body_inertia: Callable[[Values], BodyInertia] | None = None  # of the fluid around a body
    pair_force: Callable[[CoordinateState, Values], Torque] | None = None  # between its POINTS
    bodies_force: Callable[[TwoBodies, Values], Between] | None = None  # contact of two bodies
    states: tuple[StateOf, ...] = ()  # with rates, a lag or a gear among the results of its law
    switches: int = 0  # the number of those among the results of its law
    chosen_by: str = "kind"  # the choice that decides which parameters it has
    parts: Callable[[Given], Sequence[Given]] | None = None  # of its values: those of each of the
    # parts of a body on which it acts; its tables have labels
    parts_of: Callable[[Given, Collision], Sequence[Given]] | None = None  # of its values and a
    # shape of the model's file
    side_of: Callable[[str, Collision], Given] | None = None  # of FIRST or SECOND and such a shape:
    # the values of that side; none of shapes on which it does not act
    completed: Callable[[Given, Resting], Given] | None = None  # its values, with defaults that
    # depend on the scene; raises ValueError for what is missing
    each: bool = False  # on a joint with several velocities, it acts along each of them
    by_angle: bool = False  # on a joint that turns about a point, it acts on the angle from rest
    rest: str = ""  # the parameter with the coordinates at which such a joint is at rest; without
    # one, an effect along each velocity does not depend on q
    stores_energy: bool = False  # it has an energy, which can be recorded
    limited_by: str = ""  # the parameter that limits its torque, if given
    drives: bool = False  # it acts on the rotor of a joint that has an elastic gear
    elastic: bool = False  # it is an elastic gear
    compensates: str = ""  # the flag with which its torque includes `holding` of CoordinateState
    massive: bool = False  # acts on a body by its mass and inertia: only on bodies that have them
    in_fluid: bool = False  # its force depends on the fluid's motion
    resists: bool = False  # it only resists motion (in a fluid, relative to it): it holds nothing
    reaction: bool = False  # selects the joint's reaction function
    mimic: bool = False  # makes followers follow
    alone: bool = False  # acts, with the model's numbers, where a model's file is taken alone

    @property
    def on_sums(self) -> bool:
        """True if it can act on a weighted sum of joints' coordinates."""
        acts = self.joint_torque is not None or self.joint_inertia is not None
        return acts and not self.elastic
