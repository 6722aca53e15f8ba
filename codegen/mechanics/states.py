"""What effects see of the motion where they act."""

from dataclasses import dataclass

from coscrew_codegen.mechanics.motion import Motion, Rotation
from coscrew_codegen.recording.numbers import (
    Number,
    Vector,
    add,
    cross,
    rotated,
    rotated_back,
    subtract,
)
from coscrew_codegen.scene.effect import BodyState


@dataclass(frozen=True)
class BodyOfLink(BodyState):
    """A body as part of a link, which tells where it is and how it moves."""

    motion: Motion
    link: int
    place: tuple[Rotation, Vector]  # of the body in its link
    t: Number

    @property
    def gravity(self) -> Vector:
        """The scene's acceleration of free fall, in the world's frame; zero without gravity."""
        return self.motion.gravity

    def world_direction(self, vector: Vector) -> Vector:
        """R x: a vector of the body as the world sees it."""
        return rotated(self.motion.pose(self.link)[0], rotated(self.place[0], vector))

    def own_direction(self, vector: Vector) -> Vector:
        """R^T x: a vector of the world as the body sees it."""
        return rotated_back(self.place[0], rotated_back(self.motion.pose(self.link)[0], vector))

    def world_position(self, point: Vector) -> Vector:
        """R x + t: where a point of the body is."""
        R, t = self.motion.pose(self.link)
        return add(t, rotated(R, self.in_link(point)))

    def velocity(self, point: Vector) -> Vector:
        """v + ω × x of a point of the body."""
        link = self.link
        moved = add(self.motion.velocity(link), cross(self.turning_of_link, self.in_link(point)))
        return rotated_back(self.place[0], moved)

    @property
    def turning(self) -> Vector:
        """ω."""
        return rotated_back(self.place[0], self.turning_of_link)

    @property
    def turning_of_link(self) -> Vector:
        """ω in the link's frame."""
        return self.motion.turning(self.link)

    def in_link(self, point: Vector) -> Vector:
        """A point of the body in its link's frame."""
        return add(self.place[1], rotated(self.place[0], point))

    def apart(self, point: Vector, other: "BodyOfLink", other_point: Vector) -> Vector:
        """From a point of this body to one of another, in the world's frame.

        Where both hang on common links only what lies between counts: far from the origin nothing
        cancels."""
        chains = [_ancestors(self.motion, state.link) for state in (self, other)]
        shared = next(link for link in chains[0] if link in chains[1])
        ends = [_position_in(self.motion, shared, state.link, state.in_link(x))
                for state, x in ((self, point), (other, other_point))]
        return rotated(self.motion.pose(shared)[0], subtract(ends[1], ends[0]))


def _ancestors(motion: Motion, link: int) -> list[int]:
    """The link, its parent, … the world."""
    found = [link]
    while link >= 0:
        link = motion.tree.links[link].parent
        found.append(link)
    return found


def _position_in(motion: Motion, base: int, link: int, point: Vector) -> Vector:
    while link != base:
        R, t = motion.frame(link)
        point, link = add(t, rotated(R, point)), motion.tree.links[link].parent
    return point
