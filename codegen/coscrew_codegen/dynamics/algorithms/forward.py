"""Forward dynamics of a scene, explicit or implicit.

An implicit step solves (M + m) a = tau - c v, where the inertia m and the torque c v represent the
damping and stiffness of the effects within the step.  For effects at joints these are diagonal, for
forces on a point they are point masses, with another mass along one direction, and for forces
between two bodies and effects on sums of coordinates they are terms m e e^T of rows e^T, whose
rates are e^T v, so that a common motion of both bodies is not damped.
"""

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction

from coscrew_codegen.algebra.recording.numbers import Number, add, dot, subtract
from coscrew_codegen.dynamics.algorithms import aba, crba, rnea
from coscrew_codegen.dynamics.algorithms.aba import Articulated, Joint
from coscrew_codegen.dynamics.algorithms.bodies import Rigid
from coscrew_codegen.dynamics.algorithms.linear_systems import factored, product
from coscrew_codegen.dynamics.algorithms.motion import Motion
from coscrew_codegen.dynamics.algorithms.rnea import Wrench
from coscrew_codegen.dynamics.forces.applied_effects import AppliedEffects
from coscrew_codegen.dynamics.forces.linearization import JointEffect
from coscrew_codegen.dynamics.forces.own_inertias import OwnInertias
from coscrew_codegen.dynamics.forces.resisted_bodies import LinkRow, resisted, with_slopes
from coscrew_codegen.dynamics.forces.rotors import Eliminated, eliminated
from coscrew_codegen.dynamics.forces.soft_rows import (
    Inverse,
    SoftRow,
    SoftRows,
    Weights,
    axes_about,
)
from coscrew_codegen.scene.effect import Slopes, required

Solve = Callable[[Joint, Sequence[Wrench]], list[Number]]


@dataclass(frozen=True)
class Implicit:
    """a, for each velocity the inertia that its damping acts on and their quotient, (M + m)⁻¹."""

    a: list[Number]
    rates: list[Number]
    inertias: list[Number]
    inverse: Inverse
    rotors: Mapping[int, Eliminated]  # by velocity


def accelerations(motion: Motion, acting: AppliedEffects, rigids: Sequence[Rigid],
                  inertias: OwnInertias, tau: Sequence[Number]) -> list[Number]:
    """a with M a + bias = tau."""
    own = _own(motion, inertias)
    torques = acting.with_sums(add(tau, _gathered(
        motion, {n: acting.torque(n) for n in sorted(acting.torques)})))
    torques = _without_own_bias(motion, inertias, torques)
    return _solver(motion, inertias, rigids)(lambda k, _: (torques[k], own[k]),
                                             rnea.net_wrenches(motion, rigids, acting))


def implicit(motion: Motion, acting: AppliedEffects, rigids: Sequence[Rigid],
             inertias: OwnInertias, weights: Weights, tau: Sequence[Number],
             slopes: AppliedEffects | None = None) -> Implicit:
    """a with (M + m) a = tau - bias - c v.

    Damping and stiffness are those of `slopes`, the effects on a motion with the same q and the
    initial velocities of the step; forces are then linear about these velocities."""
    start, own = slopes or acting, _own(motion, inertias)
    apart = acting.without_rows()
    before = apart if start is acting else start.without_rows()
    torques = _without_own_bias(motion, inertias, _torques(apart, before, tau))
    damping, stiffness = slopes_at_joints(start)
    rates, moved = list(damping), list(own)
    geared = {motion.tree.links[n].v.start: (x, start.rotors[n]) for n, x in acting.rotors.items()}
    rotors: dict[int, Eliminated] = {}

    def at_joint(k: int, inertia: Number) -> tuple[Number, Number]:
        moved[k] = inertia + own[k]
        rates[k] = damping[k] / moved[k]
        mass, c = weights(damping[k], stiffness[k], rates[k])
        torque, more = torques[k] - c * start.motion.v[k], own[k] + mass
        if k in geared:
            now, before = geared[k]
            rotors[k] = eliminated(now, before, weights, moved[k])
            push, beside = rotors[k].on_joint
            torque, more = torque + (push - required(now.gear.torque.torque)), more + beside
        return torque, more

    joint: Joint = at_joint
    solve = _solver(motion, inertias, *(
        resisted(motion, start, rigids, weights) if start.forces else (rigids,)))
    wrenches = rnea.net_wrenches(motion, rigids, apart)
    if start.forces:
        wrenches = with_slopes(motion, wrenches, acting, start, rigids, weights)
    a = solve(joint, wrenches)

    def inverse(e: Sequence[Number]) -> list[Number]:
        return solve(lambda k, inertia: (e[k], joint(k, inertia)[1]), _still(motion))

    with motion.recorder.part("rows", heading="forces between bodies and on sums of coordinates"):
        rows = list(_soft_rows(motion, start, acting))
        if not rows:
            return Implicit(a, rates, moved, inverse, rotors)
        coupled = SoftRows(rows, weights, inverse)
        return Implicit(coupled.with_forces(a), rates, moved,
                        lambda e: coupled.resisting(inverse(e)), rotors)


def row(motion: Motion, weights: Mapping[int, Number | Fraction]) -> list[Number]:
    """The weights of all velocities."""
    given = (weights.get(k, Fraction(0)) for k in range(motion.tree.nv))
    return [motion.recorder.number(x) if isinstance(x, Fraction) else x for x in given]


def _soft_rows(motion: Motion, start: AppliedEffects, acting: AppliedEffects
               ) -> Iterator[SoftRow]:
    """The rows of pairs, of sums of several coordinates, and of contacts of two bodies."""
    moved, zero = start is not acting, motion.zero[0]
    for pair, its in zip(start.pairs, acting.pairs, strict=True):
        n, *across = axes_about(pair.direction)
        yield _row_of(_along_velocities(motion, pair.unit_wrenches(n)), pair.along, its.along)
        if not pair.along.slopes.stiffness.is_zero:
            for x in across:
                yield SoftRow(_along_velocities(motion, pair.unit_wrenches(x)),
                              Slopes(zero, pair.geometric_stiffness), dot(x, pair.u), zero)
    for total, sums in zip(start.sums, acting.sums, strict=True):
        if len(total.weights) > 1:
            yield _row_of(row(motion, total.weights), total.along, sums.along)
    for touch, now in zip(start.touches, acting.touches, strict=True):
        between, law = touch.between, touch.between.law
        for x, slopes in zip(axes_about(between.n), (law.along, law.across, law.across),
                             strict=True):
            rate = dot(x, between.u)
            yield SoftRow(_along_velocities(motion, touch.unit_wrenches(x)), slopes, rate,
                          dot(x, now.between.law.force),
                          dot(x, now.between.u) - rate if moved else None, contact=True)


def _row_of(e: list[Number], along: JointEffect, now: JointEffect) -> SoftRow:
    """The row of a torque along a coordinate."""
    return SoftRow(e, along.slopes, along.at.v, required(now.torque.torque),
                   None if now is along else now.at.v - along.at.v)


def slopes_at_joints(acting: AppliedEffects) -> tuple[list[Number], list[Number]]:
    """The damping and the stiffness along each velocity, of torques at joints and on sums of one
    term."""
    motion = acting.motion
    damping = _gathered(motion, {n: acting.damping(n) for n in sorted(acting.torques)}, 2)
    stiffness = _gathered(motion, {n: acting.stiffness(n) for n in sorted(acting.torques)}, 2)
    for x in acting.sums:
        if len(x.weights) == 1:
            (place, weight), = x.weights.items()
            square = weight * weight
            damping[place] = damping[place] + x.along.slopes.damping * square
            stiffness[place] = stiffness[place] + x.along.slopes.stiffness * square
    return damping, stiffness


def inverse_inertia(motion: Motion, rigids: Sequence[Rigid], inertias: OwnInertias,
                    unit: Sequence[Number]) -> Number:
    """e·M⁻¹ e of a row e, the acceleration along it by a torque of 1 along it."""
    return product(unit, inverse(motion, rigids, inertias)(unit))


def inverse(motion: Motion, rigids: Sequence[Rigid], inertias: OwnInertias) -> Inverse:
    """M⁻¹, without slopes of effects."""
    own, solve = _own(motion, inertias), _solver(motion, inertias, rigids)
    return lambda e: solve(lambda k, _: (e[k], own[k]), _still(motion))


def _still(motion: Motion) -> list[Wrench]:
    """No wrench on any link."""
    return [(*motion.zero, *motion.zero)] * len(motion.tree.links)


def dense(motion: Motion, inertias: OwnInertias) -> bool:
    """Returns whether the mass matrix is factored as a whole: joints follow others, or inertias
    couple them; otherwise articulated bodies are eliminated."""
    return motion.tree.follows or bool(inertias.coupling.sums)


def _own(motion: Motion, inertias: OwnInertias) -> list[Number]:
    """The joints' own inertias, by velocity, with those of sums of one term."""
    own = _gathered(motion, {n: [inertias[link.joint.name]] * max(1, len(link.v))
                             for n, link in enumerate(motion.tree.links)
                             if link.joint.name in inertias}, 2)
    for x in inertias.alone:
        (place, weight), = x.weights.items()
        own[place] = own[place] + x.inertia * (weight * weight)
    return own


def _without_own_bias(motion: Motion, inertias: OwnInertias, torques: Sequence[Number]
                      ) -> list[Number]:
    """The torques less those that joints' own inertias take at a = 0."""
    results = list(torques)
    for number, link in enumerate(motion.tree.links):
        if link.joint.name in inertias:
            with motion.part(number, "own"):
                own = rnea.own_bias(motion, number, inertias[link.joint.name])
                for k, torque in zip(link.v, own, strict=bool(own)):
                    results[k] = results[k] - torque
    return results


def _torques(acting: AppliedEffects, start: AppliedEffects, tau: Sequence[Number]) -> list[Number]:
    """Torques by velocity: tau, then those of effects; if linear about the initial velocities, also
    d (v - v_start). tau is summed in the place that an actuator's torque would have."""
    motion, others, result = acting.motion, list(tau), dict[int, list[Number]]()
    for number in sorted(acting.torques):
        link, torques = motion.tree.links[number], acting.torque(number)
        for k in link.v:
            torques[k - link.v.start] = tau[k] + torques[k - link.v.start]
            others[k] = motion.zero[0]
        if start is not acting:
            faster = subtract(motion.speeds(number), start.motion.speeds(number))
            torques = [torque + d * x for torque, d, x in zip(
                torques, start.damping(number), faster, strict=True)]
        result[number] = torques
    return _with_slopes_of_sums(acting, start, acting.with_sums(
        add(others, _gathered(motion, result))))


def _with_slopes_of_sums(acting: AppliedEffects, start: AppliedEffects, torques: Sequence[Number]
                         ) -> list[Number]:
    """Torques, with d (v - v_start) added for sums of one term."""
    results = list(torques)
    for x, now in zip(start.sums, acting.sums, strict=True):
        if start is not acting and len(x.weights) == 1:
            (place, weight), = x.weights.items()
            faster = x.along.slopes.damping * (now.along.at.v - x.along.at.v)
            results[place] = results[place] + faster * weight
    return results


def _gathered(motion: Motion, of_links: Mapping[int, Sequence[Number]], power: int = 1
              ) -> list[Number]:
    """Sums by velocity over joints; a follower's value, times its multiplier to this power, is
    added to its leader's."""
    result = [motion.zero[0]] * motion.tree.nv
    for number, values in of_links.items():
        link = motion.tree.links[number]
        with motion.part(number, "own"):
            if power == 2 and link.driver:
                values = [value * link.driver.multiplier for value in values]
            rnea.gather(motion, number, values, result)
    return result


def _solver(motion: Motion, inertias: OwnInertias, rigids: Sequence[Rigid],
            rows: Sequence[LinkRow] = ()) -> Solve:
    """The function from torques at the joints and wrenches of links at a = 0 to a.  Instructions
    that depend on neither are issued once."""
    if not dense(motion, inertias):
        bodies = [Articulated.of(body) for body in rigids]
        for row in rows:
            with motion.part(row.link, "B"):
                bodies[row.link] = bodies[row.link].with_row(row.mass, row.e)
        eliminated = aba.Elimination(motion, bodies)
        return lambda joint, wrenches: eliminated.accelerations(wrenches, joint)
    M = crba.mass_matrix(motion, rigids, inertias.coupling)
    for row in rows:
        with motion.recorder.part("solution", heading="M a = tau"):
            e = _along_velocities(motion, [(row.link, row.e)])
            M = [[x + row.mass * (a * b) for x, b in zip(A, e, strict=True)]
                 for A, a in zip(M, e, strict=True)]

    def solve(joint: Joint, wrenches: Sequence[Wrench]) -> list[Number]:
        bias = rnea.joint_torques(motion, rnea.transmitted(motion, wrenches), None,
                                  OwnInertias())
        with motion.recorder.part("solution", heading="M a = tau"):
            torques, A = [], [list(row) for row in M]
            for k, row in enumerate(A):
                torque, own = joint(k, row[k])
                torques.append(torque)
                row[k] = row[k] + own
            return factored(A).solve(subtract(torques, bias))

    return solve


def _along_velocities(motion: Motion, wrenches: Iterable[tuple[int, Wrench]]) -> list[Number]:
    """The torques that joints need against wrenches on links, by velocity."""
    total = [(*motion.zero, *motion.zero)] * len(motion.tree.links)
    for link, wrench in wrenches:
        if link >= 0:
            total[link] = add(total[link], wrench)
    return list(rnea.joint_torques(motion, rnea.transmitted(motion, total), None,
                                   OwnInertias()))
