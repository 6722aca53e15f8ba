"""Forces that effects exert on bodies and between them, and torques on sums of coordinates."""

from collections.abc import Mapping
from dataclasses import dataclass
from fractions import Fraction

from coscrew_codegen.algebra.recording.numbers import Number, Vector, maximum, negative, scaled
from coscrew_codegen.dynamics.forces.body_motion import BodyOfLink
from coscrew_codegen.dynamics.forces.linearization import JointEffect, own_power
from coscrew_codegen.scene.effect import Between, Force, PointSlopes, Slopes, required

UnitWrench = tuple[int, tuple[Number, ...]]
"""(link, wrench on it)."""


@dataclass(frozen=True)
class AppliedForce:
    """A force on a body."""

    state: BodyOfLink
    force: Force
    mutual: bool = False  # the opposite force acts on another body

    @property
    def wrench(self) -> tuple[Number, ...]:
        """(f; τ) at the point, in the body's frame."""
        return (*required(self.force.force), *(self.force.moment or self.state.motion.zero))

    @property
    def on_link(self) -> tuple[Number, ...]:
        """[Ad]* c: force and moment about the link's origin, in its frame."""
        frame = self.state.frame(required(self.force.point))
        return self.state.t.recorder.call("product_CoAdc", frame, self.wrench)

    @property
    def point_in_link(self) -> Vector:
        """The point at which it acts, in the link's frame."""
        return self.state.in_link(required(self.force.point))

    @property
    def across(self) -> Slopes:
        """Its slopes across their direction, or in all directions if they have none."""
        slopes = self.force.slopes
        return slopes.across if isinstance(slopes, PointSlopes) else required(slopes)

    @property
    def along(self) -> tuple[Slopes, tuple[Number, ...]] | None:
        """Its slopes along a direction, and the wrench on the link of 1 N along it; None if they
        are the same in all directions."""
        slopes = self.force.slopes
        if not isinstance(slopes, PointSlopes):
            return None
        unit = Force(self.force.point, slopes.direction)
        return slopes.along, AppliedForce(self.state, unit).on_link

    @property
    def normal(self) -> Vector | None:
        """The direction along which it has slopes of their own, in the body's frame."""
        slopes = self.force.slopes
        return slopes.direction if isinstance(slopes, PointSlopes) else None

    @property
    def turning(self) -> tuple[PointSlopes, tuple[Number, ...]] | None:
        """The slopes of its moment, and the wrench on the link of 1 N m along their direction."""
        slopes = self.force.turning
        if slopes is None:
            return None
        unit = Force(required(self.force.point), self.state.motion.zero, slopes.direction)
        return slopes, AppliedForce(self.state, unit).on_link

    def power(self) -> Number:
        """f·v + τ·ω."""
        return self.state.t.recorder.call("dot_cs", self.wrench,
                                          self.state.twist(required(self.force.point)))[0]


CLOSEST = Fraction(1, 10**12)
"""m: where two points are closer, the direction from one to the other fades to zero."""


@dataclass(frozen=True)
class Paired:
    """A force between two points, along the line from the first to the second."""

    states: tuple[BodyOfLink, BodyOfLink]
    points: tuple[Vector, Vector]
    direction: Vector  # of length 1, in the world's frame
    u: Vector  # the velocity of the second point relative to the first, in the world's frame
    along: JointEffect

    @property
    def forces(self) -> tuple[Force, Force]:
        """The forces on both bodies; energy and power are counted with the first."""
        torque = self.along.torque
        size = required(torque.torque)
        pull = scaled(-size, self.direction)
        first, second = self.states
        power = own_power(torque, lambda: size * self.along.at.v)
        zero = pull[0].like(0)
        return (Force(self.points[0], first.own_direction(pull), energy=torque.energy,
                      power=zero.like(power)),
                Force(self.points[1], second.own_direction(negative(pull)), power=zero))

    @property
    def geometric_stiffness(self) -> Number:
        """The stiffness across the line, in N/m: the tension over the distance, 0 if they push."""
        pull = maximum(-required(self.along.torque.torque), 0)
        return pull * (1 / maximum(self.along.at.q, CLOSEST))

    def unit_wrenches(self, direction: Vector) -> list[UnitWrench]:
        """(link, wrench on it) for forces of 1 N against a direction on the first, along it on the
        second."""
        return _opposite(self.states, self.points, negative(direction))


@dataclass(frozen=True)
class Touch:
    """A contact of two bodies."""

    states: tuple[BodyOfLink, BodyOfLink]
    between: Between

    @property
    def forces(self) -> tuple[Force, Force]:
        """The forces on both bodies; energy and power are counted with the first."""
        (here, there), law = self.between.places, self.between.law
        first, second = self.states
        return (Force(here, first.own_direction(law.force), energy=law.energy, power=law.power),
                Force(there, second.own_direction(negative(law.force)), power=law.power.like(0)))

    def unit_wrenches(self, direction: Vector) -> list[UnitWrench]:
        """(link, wrench on it) for forces of 1 N along a direction on the first, against it on the
        second."""
        return _opposite(self.states, self.between.places, direction)


def _opposite(states: tuple[BodyOfLink, BodyOfLink], points: tuple[Vector, Vector],
              direction: Vector) -> list[UnitWrench]:
    return [(state.link, AppliedForce(state, Force(point, state.own_direction(x))).on_link)
            for state, point, x in zip(states, points, (direction, negative(direction)),
                                       strict=True)]


@dataclass(frozen=True)
class Summed:
    """An effect on a weighted sum of coordinates, or on an angle; its torque acts on each velocity
    by the weight."""

    weights: Mapping[int, Number | Fraction]  # by velocity
    along: JointEffect
