"""Contact of a body with the ground, by the law of contacts."""

from fractions import Fraction

from coscrew_codegen.algebra.recording.numbers import (
    Number,
    Vector,
    dot,
    maximum,
    scaled,
    sqrt,
    subtract,
)
from coscrew_codegen.program import Constant
from coscrew_codegen.scene.contacts.contact_law import (
    COMMON,
    MOMENTS,
    STATES,
    SWITCHES,
    Meeting,
    completed,
    contact_law,
    resists_turning,
)
from coscrew_codegen.scene.contacts.touching_parts import parts, parts_of
from coscrew_codegen.scene.effect import (
    BodyState,
    Effect,
    Force,
    ParameterOf,
    Place,
    PointSlopes,
    Values,
)

_FLAT = Fraction(1, 10**6)
"""Smallest sine of the angle between a disc and the ground: of one that lies flat the rim has no
lowest point."""


def _surface(state: BodyState, values: Values) -> tuple[Number, Vector, Vector]:
    """The gap to the ground, the ground's normal, in the world's frame, and the point of the
    undeformed surface that is the closest to the ground, in the body's.

    Over heights they are those of the plane that is tangent where the surface would touch the plane
    under its centre: once more than that plane itself, which is off by the heights' bend within a
    radius."""
    centre = values.vector("point")
    position = state.world_position(centre)
    distance, n = state.above_ground(position)
    if values.get("radius") is None:
        return distance, n, centre
    reach, offset = _reach(state, values, n)
    if not all(isinstance(x.operand, Constant) for x in n):
        away = state.world_direction(offset)
        nearer, n = state.above_ground(subtract(position, away))
        distance = nearer + dot(away, n)
        reach, offset = _reach(state, values, n)
    return distance - reach, n, subtract(centre, offset)


def _reach(state: BodyState, values: Values, n: Vector) -> tuple[Number, Vector]:
    """The reach of the surface from its centre against a normal, and the way there, backwards,
    in the body's frame."""
    radius, up = values["radius"], state.own_direction(n)
    if values.word("shape") != "disc":
        return radius, scaled(radius, up)
    axis = values.vector("axis")
    axis = scaled(1 / sqrt(dot(axis, axis)), axis)
    along = dot(axis, up)
    sine = sqrt(maximum(1 - along * along, _FLAT * _FLAT))
    reach, up = radius * sine, scaled(1 / sine, subtract(up, scaled(along, axis)))
    return reach, scaled(reach / sine, up)


def _force(state: BodyState, values: Values) -> Force:
    """The law's force at the point of the undeformed surface that is the closest to the ground."""
    gap, n, point = _surface(state, values)
    w = state.world_direction(state.angular_velocity) if resists_turning(values) else ()
    law = contact_law(Meeting(gap, n, state.world_direction(state.velocity(point)), state.x, w),
                      values)
    up = state.own_direction(n)
    turning = None if law.rolling is None or law.torsional is None else PointSlopes(
        law.rolling, law.torsional, up)
    return Force(
        point, state.own_direction(law.force),
        state.own_direction(law.moment) if turning else None, law.energy, law.power,
        slopes=PointSlopes(law.across, law.along, up), turning=turning,
        rates=law.rates, bounded=law.bounded, share=law.share, switches=law.switches,
        stored=law.stored, contact=law.contact)


EFFECT = Effect(
    "contact", "contact of a body with the ground: elastic, damped, with dry friction that holds",
    "N = k δ^1.5 max(1 - 1.5 alpha u_n, 0); T = -(k_t z + d_t u_t), at most mu N; z' = u_t until "
    "k_t |z| is mu N; M = -torsional N w_n/|w_n| - rolling N w_t/|w_t|", Place.BODY,
    (ParameterOf("shape", "", "of the body where it touches: a box has eight corners, a capsule "
                 "two ends, a disc a sharp rim", "choice", "point",
                 choices=("point", "sphere", "capsule", "box", "disc")),
     ParameterOf("point", "m", "centre of the shape, in the body's frame", "vector",
                 (Fraction(0),) * 3),
     ParameterOf("radius", "m", "radius", of=("sphere", "capsule", "disc"), positive=True),
     ParameterOf("axis", "1", "direction of a capsule, or a disc's axis, in the body's frame",
                 "vector", (Fraction(0), Fraction(0), Fraction(1)), of=("capsule", "disc")),
     ParameterOf("length", "m", "distance between the centres of a capsule's ends",
                 of=("capsule",), positive=True),
     ParameterOf("size", "m", "edges of a box", "vector", of=("box",), positive=True),
     *COMMON, *MOMENTS),
    body_force=_force, stores_energy=True, chosen_by="shape", parts=parts, parts_of=parts_of,
    completed=completed, states=STATES, switches=SWITCHES)
