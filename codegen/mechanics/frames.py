"""Poses, twists and Jacobians of bodies, wherever they sit in their links."""

from collections.abc import Sequence

from coscrew_codegen.mechanics import articulated
from coscrew_codegen.mechanics.motion import Motion, Rotation
from coscrew_codegen.mechanics.recorded import Recording
from coscrew_codegen.recording.numbers import Number, Vector, add, rotated, row_by_row, scaled


def pose(x: Recording, motion: Motion, body: str) -> tuple[Rotation, Vector]:
    """R and t of a body in the world."""
    number, placement = x.tree.seat_of(body)
    R, t = motion.pose(number)
    with x.recorder.part(f"{x.names[number] if number >= 0 else 'world'}_seat", body):
        own = x.recorder.numbers(placement.R), x.recorder.numbers(placement.t)
        return x.recorder.call("product_drdr", R, own[0]), add(t, rotated(R, own[1]))


def jacobian(x: Recording, motion: Motion, body: str) -> list[Sequence[Number]]:
    """A column a speed: the joint's screw as the body sees it."""
    number, placement = x.tree.seat_of(body)
    R, t = x.recorder.numbers(placement.R), x.recorder.numbers(placement.t)
    columns: list[Sequence[Number]] = [(*motion.zero, *motion.zero)] * x.tree.nv
    while number >= 0:
        link = x.tree.links[number]
        D = row_by_row(R, t)
        for freedom, screw in enumerate(articulated.freedoms(motion, number)):
            column, place = x.recorder.call("product_Adinvs", D, screw), link.v.start + freedom
            if link.driver:
                place = x.tree.links[link.driver.link].v.start
                column = scaled(column[0].like(link.driver.multiplier), column)
            columns[place] = add(columns[place], column)
        own = motion.frame(number)
        R, t = x.recorder.call("product_drdr", own[0], R), add(own[1], rotated(own[0], t))
        number = link.parent
    return columns


def twist(x: Recording, motion: Motion, body: str) -> tuple[Number, ...]:
    """[Ad]^-1 s: the link's screw as the body sees it."""
    number, placement = x.tree.seat_of(body)
    screw = (*motion.velocity(number), *motion.turning(number))
    D = row_by_row(x.recorder.numbers(placement.R), x.recorder.numbers(placement.t))
    return x.recorder.call("product_Adinvs", D, screw)
