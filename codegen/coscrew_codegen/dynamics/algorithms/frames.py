"""Poses, twists, accelerations and Jacobians of bodies."""

from collections.abc import Callable, Sequence

from coscrew_codegen.algebra.recording.numbers import (
    Number,
    Vector,
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
from coscrew_codegen.scene.mechanism.tree import Tree
from coscrew_codegen.scene.scene_function import Frame


def _link_and_pose(x: FunctionRecording, body: str, point: Sequence[Number] = ()
                   ) -> tuple[int, Displacement]:
    """The link that a body belongs to, and the body's D in it, or that of its axes at a point."""
    number, placed = x.tree.link_and_body(body)
    R, t = x.recorder.numbers(placed.placement.R), x.recorder.numbers(placed.placement.t)
    return number, displacement(R, add(rotated(R, tuple(point)), t) if point else t)


def pose(x: FunctionRecording, motion: Motion, body: str) -> Displacement:
    """D of a body in the world."""
    number, own = _link_and_pose(x, body)
    D = motion.pose(number)
    with motion.part(number, "Rw"):
        return x.recorder.call("product_dd", D, own)


def jacobian(x: FunctionRecording, motion: Motion, body: str, frame: Frame = Frame.BODY,
             point: Sequence[Number] = ()) -> list[Sequence[Number]]:
    """J by columns, one per velocity; at the body's origin, or at a point of it."""
    number, D = _link_and_pose(x, body, point)
    columns: list[Sequence[Number]] = [(*motion.zero, *motion.zero)] * x.tree.nv
    while number >= 0:
        for freedom, screw in enumerate(motion.subspace(number)):
            enter(x.tree, number, freedom, _moved(motion, number, frame, D, screw), columns)
        D = x.recorder.call("product_dd", motion.frame(number), D)
        number = x.tree.links[number].parent
    return columns


def _moved(motion: Motion, number: int, frame: Frame, D: Displacement, screw: Sequence[Number]
           ) -> Sequence[Number]:
    """The screw of a link's freedom in a frame: (l; e) moves a point r by l + e × r."""
    if frame is Frame.BODY:
        return motion.recorder.call("product_Adinvs", D, screw)
    pose = motion.pose(number)
    R = rotation(pose)
    if frame is Frame.ALIGNED:
        l = add(linear(screw), cross(angular(screw), translation(D)))
        return (*rotated(R, l), *rotated(R, angular(screw)))
    l, e = rotated(R, linear(screw)), rotated(R, angular(screw))
    return (*add(l, cross(translation(pose), e)), *e)


def enter(tree: Tree, number: int, freedom: int, column: Sequence[Number],
          columns: list[Sequence[Number]]) -> None:
    """Add a freedom's column to that of the velocity that it depends on."""
    link = tree.links[number]
    place = link.v.start + freedom
    if link.driver:
        place = tree.links[link.driver.link].v.start
        column = scaled(column[0].like(link.driver.multiplier), column)
    columns[place] = add(columns[place], column)


def acceleration(x: FunctionRecording, motion: Motion, body: str) -> tuple[Number, ...]:
    """The acceleration of the body's origin, and its angular acceleration, in its axes."""
    number, D = _link_and_pose(x, body)
    return _turned(rotated_back, rotation(D), _acceleration(motion, number, translation(D)))


def twist_rate(x: FunctionRecording, motion: Motion, body: str, frame: Frame,
               point: Sequence[Number] = ()) -> tuple[Number, ...]:
    """J a + J' v of `jacobian`: the rate of the components of (v; ω).

    In the world's axes, at a point of the body: v' is the acceleration a of the point.  In the
    body's axes, which turn, and at the world's origin, which one point of the body after another
    passes, the screw's rate is (a - ω × v; ω') of the link's origin, moved as a screw is."""
    number, D = _link_and_pose(x, body, point)
    if frame is Frame.ALIGNED:
        return _turned(rotated, rotation(motion.pose(number)),
                       _acceleration(motion, number, translation(D)))
    turning = cross(motion.angular_velocity(number), motion.velocity(number))
    rate = (*subtract(motion.acceleration(number), turning), *motion.angular_acceleration(number))
    if frame is Frame.BODY:
        return x.recorder.call("product_Adinvs", D, rate)
    return x.recorder.call("product_Ads", motion.pose(number), rate)


def _acceleration(motion: Motion, number: int, point: Vector) -> tuple[Number, ...]:
    """The acceleration of a link's point, and its angular acceleration, in its axes."""
    at_point = add(motion.acceleration(number),
                   rotated(motion.acceleration_tensor(number), point))
    return (*at_point, *motion.angular_acceleration(number))


def _turned(turn: Callable[[Sequence[Number], Vector], Vector], R: Sequence[Number],
            s: Sequence[Number]) -> tuple[Number, ...]:
    """Both parts of s, turned."""
    return (*turn(R, linear(s)), *turn(R, angular(s)))


def twist(x: FunctionRecording, motion: Motion, body: str) -> tuple[Number, ...]:
    """[Ad]^-1 s: the link's twist in the body's frame."""
    number, D = _link_and_pose(x, body)
    return x.recorder.call("product_Adinvs", D, motion.twist(number))
