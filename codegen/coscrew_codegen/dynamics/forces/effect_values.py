"""Forces and torques of single effects, their power and their energy."""

from collections.abc import Callable, Mapping, Sequence

from coscrew_codegen.algebra.recording.numbers import Number, add, cross, dot
from coscrew_codegen.dynamics.algorithms import energies
from coscrew_codegen.dynamics.algorithms.motion import Motion
from coscrew_codegen.dynamics.forces.acted_coordinates import link_of, weights_of
from coscrew_codegen.dynamics.forces.added_inertia import inertia_in_link
from coscrew_codegen.dynamics.forces.applied_effects import AppliedEffects, alone
from coscrew_codegen.dynamics.forces.effect_parameters import settings
from coscrew_codegen.dynamics.forces.exerted_forces import AppliedForce, Touch
from coscrew_codegen.dynamics.forces.linearization import JointEffect
from coscrew_codegen.dynamics.forces.own_inertias import SummedInertia
from coscrew_codegen.dynamics.function_recording import FunctionRecording
from coscrew_codegen.scene.effect import required
from coscrew_codegen.scene.effect_quantities import ENERGY, FORCE, POWER, SATURATED, TORQUE
from coscrew_codegen.scene.scene import Applied

Values = Mapping[str, Callable[[], Sequence[Number]]]
"""Functions that compute the components of each quantity when they are needed."""


def values_of(x: FunctionRecording, motion: Motion, applied: Applied) -> Values:
    """Force, torque, power and energy of an effect at one of its places, by quantity."""
    effect = applied.effect
    if effect.gravity:
        return {POWER: lambda: [dot(motion.gravity, energies.momentum(x, motion)[:3])],
                ENERGY: lambda: [energies.potential(x, motion)]}
    if effect.joint_inertia:
        return {ENERGY: lambda: [_kinetic(x, motion, applied)]}
    if effect.body_inertia:
        link, inertia = inertia_in_link(applied, x.recorder, x.tree)
        return {ENERGY: lambda: [energies.of_inertia(inertia, motion.twist(link))]}
    acting = AppliedEffects(alone(x.scene, applied), motion).act()
    if effect.drives and acting.rotors:
        return _of_joint([x for rotor in acting.rotors.values() for x in rotor.motors])
    if effect.joint_torque:
        return _of_joint([*(x for several in acting.torques.values() for x in several),
                          *(x.along for x in acting.sums)])
    if effect.pair_force:
        (pair,) = acting.pairs
        return _of_pair(pair.along)
    if effect.bodies_force:
        (touch,) = acting.touches
        return _of_touch(touch)
    ((force,),) = acting.forces.values()
    return _of_body(force)


def _kinetic(x: FunctionRecording, motion: Motion, applied: Applied) -> Number:
    """I v²/2 of the own inertia of a joint or of a sum."""
    values = settings(x.recorder, applied.values, x.recorder.number(0))
    inertia = required(applied.effect.joint_inertia)(values)
    if applied.terms:
        rate = SummedInertia(weights_of(x.tree, applied.terms), inertia).along(motion.v)
        return inertia * (rate * rate) / 2
    return _sum([inertia * (v * v) / 2 for v in motion.speeds(link_of(motion, applied.on))])


def _of_joint(along: Sequence[JointEffect]) -> Values:
    """Quantities along a joint's velocities, or a sum; only those along one coordinate saturate."""
    torques = [required(x.torque.torque) for x in along]
    return {TORQUE: lambda: torques,
            POWER: lambda: [_sum([u * x.at.v for u, x in zip(torques, along, strict=True)])],
            ENERGY: lambda: [_sum([required(x.torque.energy) for x in along])],
            SATURATED: lambda: [along[0].saturated]}


def _sum(terms: Sequence[Number]) -> Number:
    first, *others = terms
    for x in others:
        first = first + x
    return first


def _of_pair(along: JointEffect) -> Values:
    push = required(along.torque.torque)
    return {FORCE: lambda: [-push], POWER: lambda: [push * along.at.v],
            ENERGY: lambda: [required(along.torque.energy)]}


def _of_touch(touch: Touch) -> Values:
    law = touch.between.law
    return {FORCE: lambda: law.force, POWER: lambda: [dot(law.force, touch.between.u)],
            ENERGY: lambda: [law.energy]}


def _of_body(applied: AppliedForce) -> Values:
    state, force, moment = applied.state, applied.wrench[:3], applied.wrench[3:]
    point = required(applied.force.point)
    return {FORCE: lambda: state.world_direction(force),
            TORQUE: lambda: state.world_direction(add(moment, cross(point, force))),
            POWER: lambda: [applied.power()],
            ENERGY: lambda: [required(applied.force.energy)]}
