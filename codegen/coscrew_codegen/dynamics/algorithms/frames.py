"""Poses, twists and Jacobians of bodies, in their own frames."""

from collections.abc import Sequence

from coscrew_codegen.algebra.recording.numbers import (
    Number,
    add,
    angular,
    cross,
    displacement,
    linear,
    rotated,
    rotated_back,
    rotation,
    scaled,
    subtract,
    translation,
)
from coscrew_codegen.dynamics.algorithms.motion import Displacement, Motion
from coscrew_codegen.dynamics.function_recording import FunctionRecording


def _link_and_pose(x: FunctionRecording, body: str) -> tuple[int, Displacement]:
    """The link that a body belongs to, and the body's D in it."""
    number, placed = x.tree.link_and_body(body)
    R, t = x.recorder.numbers(placed.placement.R), x.recorder.numbers(placed.placement.t)
    return number, displacement(R, t)


def pose(x: FunctionRecording, motion: Motion, body: str) -> Displacement:
    """D of a body in the world."""
    number, own = _link_and_pose(x, body)
    D = motion.pose(number)
    with motion.part(number, "Rw"):
        return x.recorder.call("product_dd", D, own)


def jacobian(x: FunctionRecording, motion: Motion, body: str) -> list[Sequence[Number]]:
    """J by columns, one per velocity: the joint's screw in the body's frame."""
    number, D = _link_and_pose(x, body)
    columns: list[Sequence[Number]] = [(*motion.zero, *motion.zero)] * x.tree.nv
    while number >= 0:
        link = x.tree.links[number]
        for freedom, screw in enumerate(motion.subspace(number)):
            _enter(x, number, freedom, x.recorder.call("product_Adinvs", D, screw), columns)
        D = x.recorder.call("product_dd", motion.frame(number), D)
        number = link.parent
    return columns


def jacobian_in_world(x: FunctionRecording, motion: Motion, body: str, at_body: bool
                      ) -> list[Sequence[Number]]:
    """J by columns, in the world's axes: of the body's origin, or of the point of the body that is
    at the world's origin.  A freedom (l; e) at o moves a point r by l + e × (r - o)."""
    number, _ = _link_and_pose(x, body)
    point = translation(pose(x, motion, body)) if at_body else motion.zero
    columns: list[Sequence[Number]] = [(*motion.zero, *motion.zero)] * x.tree.nv
    while number >= 0:
        link, D = x.tree.links[number], motion.pose(number)
        for freedom, screw in enumerate(motion.subspace(number)):
            l, e = (rotated(rotation(D), part) for part in (linear(screw), angular(screw)))
            column = (*add(l, cross(e, subtract(point, translation(D)))), *e)
            _enter(x, number, freedom, column, columns)
        number = link.parent
    return columns


def _enter(x: FunctionRecording, number: int, freedom: int, column: Sequence[Number],
           columns: list[Sequence[Number]]) -> None:
    """Add a freedom's column to that of the velocity that it depends on."""
    link = x.tree.links[number]
    place = link.v.start + freedom
    if link.driver:
        place = x.tree.links[link.driver.link].v.start
        column = scaled(column[0].like(link.driver.multiplier), column)
    columns[place] = add(columns[place], column)


def acceleration(x: FunctionRecording, motion: Motion, body: str) -> tuple[Number, ...]:
    """The acceleration of the body's origin, and its angular acceleration, in its frame."""
    number, D = _link_and_pose(x, body)
    R, t = rotation(D), translation(D)
    linear_part = add(motion.acceleration(number), rotated(motion.acceleration_tensor(number), t))
    return (*rotated_back(R, linear_part), *rotated_back(R, motion.angular_acceleration(number)))


def twist(x: FunctionRecording, motion: Motion, body: str) -> tuple[Number, ...]:
    """[Ad]^-1 s: the link's twist in the body's frame."""
    number, D = _link_and_pose(x, body)
    return x.recorder.call("product_Adinvs", D, motion.twist(number))
