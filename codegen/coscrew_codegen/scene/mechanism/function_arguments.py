"""Inputs and outputs of the functions of a mechanism: names, shapes and units."""

from collections.abc import Callable
from dataclasses import dataclass, replace
from enum import Enum
from math import prod

from coscrew_codegen.scene import units
from coscrew_codegen.scene.units import Kinds, Units


class AxisLength(Enum):
    """The length of an axis that depends on the scene."""

    NQ = "coordinates"
    NV = "velocities"
    DISPLACEMENTS = "displacements and states of effects"
    STATE = "displacements, states of effects and velocities"
    BODIES = "bodies"
    PARAMETERS = "run-time parameters"
    FLOATING = "floating trees"
    LINEAR = "parameters on which torques depend linearly"
    BASE = "base parameters"
    LOOPS = "closed loops"
    ROWS = "rows of closed loops"
    CONTACTS = "contacts of bodies"
    EFFECT_STATES = "states of effects"
    SWITCHES = "numbers that switch effects with states"


@dataclass(frozen=True)
class Array:
    """An input or output: shape, the unit of each component, and words for comments."""

    name: str
    shape: tuple[int | AxisLength, ...]
    units: Units
    words: str = ""

    def sized(self, size: Callable[[AxisLength], int]) -> tuple[int, ...]:
        """The shape in a scene."""
        return tuple(size(x) if isinstance(x, AxisLength) else x for x in self.shape)

    @property
    def is_coordinates(self) -> bool:
        """True if its derivatives are along velocities."""
        return self.units is units.coordinates

    @property
    def each(self) -> int:
        """The number of components of each body, joint, … along the first axis."""
        return prod(x for x in self.shape[1:] if isinstance(x, int))

    def units_of(self, shape: tuple[int, ...], kinds: Kinds) -> tuple[str, ...]:
        """The unit of each component.  Raises ValueError if they do not fit the shape."""
        given = self.units(kinds) if callable(self.units) else self.units
        count = prod(shape)
        if count and (not given or count % len(given)):
            raise ValueError(f"{self.name} has {count} components and {len(given)} units; wanted "
                             "a unit for each, or units that are repeated")
        return given * (count // len(given)) if given else ()


Q = Array("q", (AxisLength.NQ,), units.coordinates,
          "coordinates: positions in m, angles in rad, unit quaternions (x, y, z, w)")
V = Array("v", (AxisLength.NV,), units.velocities, "velocities in m/s, rad/s")
A = Array("a", (AxisLength.NV,), units.accelerations, "accelerations in m/s^2, rad/s^2")
TAU = Array("tau", (AxisLength.NV,), units.torques, "forces and torques of joints in N, N m")
MOMENTA = Array("c", (AxisLength.FLOATING, 9), (*units.MOMENTUM, "m", "m", "m"),
                "in kg m/s, kg m^2/s, m")
COUNT = Array("count", (), ("1",))
INPUTS = {x.name: x for x in (
    Array("t", (), ("s",), "time in s"), Array("h", (), ("s",), "step in s"),
    Array("p", (AxisLength.PARAMETERS,), ("1",), "parameters"), Q, V, A, TAU,
    Array("phi", (AxisLength.NV,), units.displacements,
          "displacements along the velocities, in m, rad"), MOMENTA,
    Array("r", (3,), ("m",), "a point in the frame of the body, in m"),
    replace(Q, name="q1", words="other coordinates"))}
"""Inputs of functions, by name."""


class Frame(Enum):
    """Axes of a body's velocity (v; ω), and the point of the body that moves with v."""

    BODY = "in the body's axes, at its origin"
    ALIGNED = "in the world's axes, at the body's origin"
    WORLD = "in the world's axes, at the world's origin"


class Of(Enum):
    """Owner of a recorded quantity, or target of a function."""

    SCENE = ""
    BODY = "body"
    JOINT = "joint"
    LOOP = "loop"


@dataclass(frozen=True)
class SceneQuantity:
    """Quantity recorded from a function's results: `name`, or `name.BODY`, `name.JOINT`.

    Each component is the sum of the results at its `places`; without places, every result is a
    component.  For a function of all bodies, places count from the body's own results."""

    name: str
    of: Of = Of.SCENE
    components: tuple[str, ...] = ()  # names in place of numbers
    places: tuple[tuple[int, ...], ...] = ()
    expected: str = ""  # the component that an expectation without one refers to

    @property
    def written(self) -> str:
        """pose.BODY."""
        return f"{self.name}.{self.of.value.upper()}" if self.of.value else self.name
