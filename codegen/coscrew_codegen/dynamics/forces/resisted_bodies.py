"""Bodies on which forces with slopes act, in an implicit step: point masses, moments of inertia and
rows stand for the damping and the stiffness of the forces."""

from collections.abc import Sequence
from dataclasses import dataclass, replace
from fractions import Fraction

from coscrew_codegen.algebra.recording.numbers import (
    Number,
    Vector,
    add,
    dot,
    linear,
    maximum,
    scaled,
    subtract,
)
from coscrew_codegen.dynamics.algorithms.bodies import Rigid, rigid_of
from coscrew_codegen.dynamics.algorithms.motion import Motion
from coscrew_codegen.dynamics.algorithms.rnea import Wrench
from coscrew_codegen.dynamics.forces.applied_effects import AppliedEffects
from coscrew_codegen.dynamics.forces.exerted_forces import AppliedForce
from coscrew_codegen.dynamics.forces.soft_rows import Weights
from coscrew_codegen.scene.effect import Force, PointSlopes, Slopes, required

_LEAST = Fraction(1, 10**30)
"""kg: used instead of a mass of zero."""


@dataclass(frozen=True)
class LinkRow:
    """The term mass e e^T of a link's articulated inertia; e a wrench on the link."""

    link: int
    mass: Number
    e: Wrench


def resisted(motion: Motion, acting: AppliedEffects, rigids: Sequence[Rigid], weights: Weights
              ) -> tuple[list[Rigid], list[LinkRow]]:
    """The links' inertias with point masses m for the forces on points of them, and rows for the
    directions in which these have other slopes."""
    bodies, rows = list(rigids), []
    for number, body in enumerate(rigids):
        with motion.part(number, "B"):
            for force in acting.resisting(number):
                represented = _of_contact if force.force.contact else _represented
                across, _ = represented(force.across, body, weights)
                bodies[number] = _with_mass(bodies[number], across, force.point_in_link)
                if force.along:
                    slopes, e = force.along
                    along, _ = represented(slopes, body, weights)
                    rows.append(LinkRow(number, along - across, e))
                if force.turning:
                    turning, e = force.turning
                    across, about = (_about_axis(x, body, weights) for x in (
                        turning.across, turning.along))
                    bodies[number] = _with_moments(bodies[number], across)
                    rows.append(LinkRow(number, about - across, e))
    return bodies, rows


def _about_axis(slopes: Slopes, body: Rigid, weights: Weights) -> Number:
    """m for the damping of a moment; z is that over the body's mean moment of inertia."""
    mean = maximum((body.I[0] + body.I[1] + body.I[2]) / 3, _LEAST)
    return weights(slopes.damping, slopes.stiffness, slopes.damping / mean)[0]


def _represented(slopes: Slopes, body: Rigid, weights: Weights) -> tuple[Number, Number]:
    """(m, c) for the slopes of a force on a point of a body."""
    m = maximum(body.m, _LEAST)
    return weights(slopes.damping, slopes.stiffness, slopes.damping / m, slopes.stiffness / m)


def _of_contact(slopes: Slopes, body: Rigid, weights: Weights) -> tuple[Number, Number]:
    """Likewise of a contact, in one division."""
    d, k = slopes.damping, slopes.stiffness
    return weights(d, k, d, k, maximum(body.m, _LEAST))


def with_slopes(motion: Motion, wrenches: Sequence[Wrench], acting: AppliedEffects,
                start: AppliedEffects, rigids: Sequence[Rigid], weights: Weights) -> list[Wrench]:
    """The wrenches that links need, with D (u - u_start) - c u_start added to the forces with
    slopes D, u the velocity of their point."""
    results = list(wrenches)
    for number, body in enumerate(rigids):
        with motion.part(number, "f"):
            for force, now in zip(start.resisting(number), acting.resisting(number), strict=True):
                before, along = start.motion.twist(number), force.along
                faster = None if start is acting else subtract(motion.twist(number), before)
                if force.force.contact:
                    results[number] = subtract(results[number], _held(force, now, body, weights))
                else:
                    if faster:
                        results[number] = subtract(results[number], _push(
                            force, faster, force.across.damping, along and along[0].damping))
                    _, c = _represented(force.across, body, weights)
                    c_along = along and _represented(along[0], body, weights)[1]
                    if not c.is_zero or c_along and not c_along.is_zero:
                        results[number] = add(results[number], _push(force, before, c, c_along))
                if faster and force.turning:
                    results[number] = subtract(results[number], _turn(*force.turning, faster))
    return results


def _held(force: AppliedForce, now: AppliedForce, body: Rigid, weights: Weights) -> Wrench:
    """The wrench on a link of a contact's D (u - u_start) - c u_start, at its point."""
    point, (along, _) = required(force.force.point), required(force.along)
    start, n = force.state.velocity(point), required(force.normal)
    faster, d = subtract(now.state.velocity(point), start), force.across.damping
    c, c_along = (_of_contact(x, body, weights)[1] for x in (force.across, along))
    push = subtract(scaled(d, faster), scaled(c, start))
    more = (along.damping - d) * dot(n, faster) - (c_along - c) * dot(n, start)
    return AppliedForce(force.state, Force(point, add(push, scaled(more, n)))).on_link


def _push(force: AppliedForce, twist: Wrench, across: Number, along: Number | None) -> Wrench:
    """The wrench on a link of the force `across` u, with another factor along the force's
    direction, u the velocity of its point."""
    point, call = force.point_in_link, across.recorder.call
    push = scaled(across, linear(call("product_Adtinvs", point, twist)))
    wrench: Wrench = call("product_CoAdtc", point, (*push, *(across.like(0),) * 3))
    if along is None:
        return wrench
    _, e = required(force.along)
    return add(wrench, scaled((along - across) * call("dot_cs", e, twist)[0], e))


def _turn(slopes: PointSlopes, e: Wrench, twist: Wrench) -> Wrench:
    """The moment on a link of the slopes' damping at the angular velocity of a twist."""
    across, along = slopes.across.damping, slopes.along.damping
    turn = (*e[:3], *scaled(across, twist[3:]))
    return add(turn, scaled((along - across) * dot(e[3:], twist[3:]), e))


def _with_mass(body: Rigid, mass: Number, point: Vector) -> Rigid:
    """The body with a point mass."""
    zero = mass.like(0)
    return replace(rigid_of(add(body.numbers, mass.recorder.call(
        "spatial_inertia_from_com", mass, point, [zero] * 9))), added=body.added)


def _with_moments(body: Rigid, inertia: Number) -> Rigid:
    """The body with a moment of inertia about each axis."""
    return replace(body, I=(*(x + inertia for x in body.I[:3]), *body.I[3:]))
