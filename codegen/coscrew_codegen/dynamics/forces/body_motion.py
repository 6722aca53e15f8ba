"""Motion of a body, in the form that effects receive."""

from collections.abc import Callable
from dataclasses import dataclass

from coscrew_codegen.algebra.recording.numbers import (
    Number,
    Vector,
    angular,
    displacement,
    linear,
    rotated,
    rotated_back,
    rotation,
    subtract,
)
from coscrew_codegen.dynamics.algorithms.motion import Displacement, Motion, Twist
from coscrew_codegen.scene.effect import BodyState, required
from coscrew_codegen.scene.mechanism.model import Inertia

Ground = Callable[[Vector], tuple[Number, Vector]]
"""A position's distance from the ground, and the ground's normal there, in the world's frame."""


@dataclass(frozen=True)
class BodyInWorld(BodyState):
    """A body whose pose in the world is known."""

    own: Inertia | None
    t: Number

    @property
    def x(self) -> Vector:
        """The effect's states."""
        raise TypeError("an energy from which a force follows depends on no state of an effect")

    @property
    def pose(self) -> Displacement:
        """D of the body in the world."""
        raise TypeError("a body has a pose")

    @property
    def mass(self) -> Number:
        """In kg; zero if the model gives none."""
        return self.t.recorder.number(self.own.mass if self.own else 0)

    @property
    def centre_of_mass(self) -> Vector:
        """In m."""
        return self.t.recorder.numbers(self.own.com if self.own else (0,) * 3)

    @property
    def inertia(self) -> tuple[Number, ...]:
        """Moments xx, yy, zz, xy, xz, yz about the centre of mass, in kg m²."""
        return self.t.recorder.numbers(self.own.moments if self.own else (0,) * 6)

    def world_direction(self, vector: Vector) -> Vector:
        """R x: a vector in the body's frame expressed in the world's."""
        return rotated(rotation(self.pose), vector)

    def own_direction(self, vector: Vector) -> Vector:
        """R^T x: a vector in the world's frame expressed in the body's."""
        return rotated_back(rotation(self.pose), vector)

    def world_position(self, point: Vector) -> Vector:
        """R x + t: the position of a point of the body."""
        return _at(self.pose, point)


@dataclass(frozen=True)
class BodyOfLink(BodyInWorld):
    """A body as part of a link, whose motion determines its pose and velocities."""

    motion: Motion
    link: int
    place: Displacement  # of the body in its link
    wind: Vector | None = None  # in the world's frame
    x: Vector = ()  # the effect's states
    ground: Ground | None = None

    @property
    def pose(self) -> Displacement:
        """D of the body in the world."""
        return self.t.recorder.call("product_dd", self.motion.pose(self.link), self.place)

    @property
    def gravity(self) -> Vector:
        """The scene's acceleration of free fall, in the world's frame; zero without gravity."""
        return self.motion.gravity

    def world_direction(self, vector: Vector) -> Vector:
        """R x, by way of the link."""
        return rotated(rotation(self.motion.pose(self.link)), rotated(rotation(self.place), vector))

    def own_direction(self, vector: Vector) -> Vector:
        """R^T x, by way of the link."""
        in_link = rotated_back(rotation(self.motion.pose(self.link)), vector)
        return rotated_back(rotation(self.place), in_link)

    def world_position(self, point: Vector) -> Vector:
        """R x + t, by way of the link."""
        return _at(self.motion.pose(self.link), self.in_link(point))

    def velocity(self, point: Vector) -> Vector:
        """v + ω × x: the velocity of a point of the body."""
        return linear(self.twist(point))

    def velocity_in_fluid(self, point: Vector) -> Vector:
        """The velocity of a point of the body less that of the wind."""
        u = self.velocity(point)
        return u if self.wind is None else subtract(u, self.own_direction(self.wind))

    def above_ground(self, position: Vector) -> tuple[Number, Vector]:
        """The distance of a position from the ground, and the ground's normal."""
        return required(self.ground)(position)

    @property
    def angular_velocity(self) -> Vector:
        """ω."""
        return angular(self.twist(self.motion.zero))

    def twist(self, point: Vector) -> Twist:
        """[Ad]^-1 s: (v; ω) at a point of the body."""
        return self.motion.recorder.call("product_Adinvs", self.frame(point),
                                         self.motion.twist(self.link))

    def frame(self, point: Vector) -> Displacement:
        """The displacement from the link's frame to the body's axes at one of the body's points."""
        return displacement(rotation(self.place), self.in_link(point))

    def in_link(self, point: Vector) -> Vector:
        """A point of the body in its link's frame."""
        return _at(self.place, point)

    def line_to(self, point: Vector, other: "BodyOfLink", other_point: Vector) -> Vector:
        """The vector from a point of this body to one of another, in the world's frame.

        It is computed in the frame of their last common link, so that nothing cancels far from the
        origin."""
        chains = [_ancestors(self.motion, state.link) for state in (self, other)]
        shared = next(link for link in chains[0] if link in chains[1])
        ends = [_position_in(self.motion, shared, state.link, state.in_link(x))
                for state, x in ((self, point), (other, other_point))]
        return rotated(rotation(self.motion.pose(shared)), subtract(ends[1], ends[0]))


def _at(D: Displacement, point: Vector) -> Vector:
    return D[0].recorder.call("product_dv", D, point)


def _ancestors(motion: Motion, link: int) -> list[int]:
    """The link, its parent, …, the world."""
    results = [link]
    while link >= 0:
        link = motion.tree.links[link].parent
        results.append(link)
    return results


def _position_in(motion: Motion, base: int, link: int, point: Vector) -> Vector:
    while link != base:
        point, link = _at(motion.frame(link), point), motion.tree.links[link].parent
    return point
