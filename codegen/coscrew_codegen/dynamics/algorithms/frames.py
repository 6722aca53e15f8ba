"""Poses, twists and Jacobians of bodies, in their own frames."""

from collections.abc import Sequence

from coscrew_codegen.algebra.recording.numbers import Number, add, displacement, scaled
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
            column, place = x.recorder.call("product_Adinvs", D, screw), link.v.start + freedom
            if link.driver:
                place = x.tree.links[link.driver.link].v.start
                column = scaled(column[0].like(link.driver.multiplier), column)
            columns[place] = add(columns[place], column)
        D = x.recorder.call("product_dd", motion.frame(number), D)
        number = link.parent
    return columns


def twist(x: FunctionRecording, motion: Motion, body: str) -> tuple[Number, ...]:
    """[Ad]^-1 s: the link's twist in the body's frame."""
    number, D = _link_and_pose(x, body)
    return x.recorder.call("product_Adinvs", D, motion.twist(number))
