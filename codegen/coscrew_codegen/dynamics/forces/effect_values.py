"""Forces and torques of single effects, their power and their energy."""

from collections.abc import Callable, Mapping, Sequence

from coscrew_codegen.algebra.recording.numbers import Number, add, cross, dot
from coscrew_codegen.dynamics.algorithms import energies
from coscrew_codegen.dynamics.algorithms.motion import Motion
from coscrew_codegen.dynamics.forces.applied_effects import AppliedEffects, AppliedForce, alone
from coscrew_codegen.dynamics.forces.effect_parameters import settings
from coscrew_codegen.dynamics.forces.linearization import JointEffect
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
    acting = AppliedEffects(alone(x.scene, applied), motion).act()
    if effect.joint_torque:
        ((along,),) = acting.torques.values()
        return _of_joint(along)
    if effect.pair_force:
        (pair,) = acting.pairs
        return _of_pair(pair.along)
    ((force,),) = acting.forces.values()
    return _of_body(force)


def _kinetic(x: FunctionRecording, motion: Motion, applied: Applied) -> Number:
    """I v²/2 of a joint's own inertia."""
    v = motion.speeds(x.tree.links.index(x.tree.link_of(applied.on)))[0]
    values = settings(x.recorder, applied.values, x.recorder.number(0))
    return required(applied.effect.joint_inertia)(values) * (v * v) / 2


def _of_joint(along: JointEffect) -> Values:
    torque = required(along.torque.torque)
    return {TORQUE: lambda: [torque], POWER: lambda: [torque * along.at.v],
            ENERGY: lambda: [required(along.torque.energy)], SATURATED: lambda: [along.saturated]}


def _of_pair(along: JointEffect) -> Values:
    push = required(along.torque.torque)
    return {FORCE: lambda: [-push], POWER: lambda: [push * along.at.v],
            ENERGY: lambda: [required(along.torque.energy)]}


def _of_body(applied: AppliedForce) -> Values:
    state, force, moment = applied.state, applied.wrench[:3], applied.wrench[3:]
    point = required(applied.force.point)
    return {FORCE: lambda: state.world_direction(force),
            TORQUE: lambda: state.world_direction(add(moment, cross(point, force))),
            POWER: lambda: [applied.power()],
            ENERGY: lambda: [required(applied.force.energy)]}
