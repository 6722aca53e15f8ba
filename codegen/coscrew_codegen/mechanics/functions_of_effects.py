"""Functions of single effects: what each exerts, its power and its energy."""

from collections.abc import Callable, Mapping, Sequence
from functools import partial

from coscrew_codegen.mechanics import energies
from coscrew_codegen.mechanics.acting import Acting, AppliedForce, alone
from coscrew_codegen.mechanics.derivation import Derivation, Makers
from coscrew_codegen.mechanics.motion import Motion
from coscrew_codegen.mechanics.recorded import Recording, Results
from coscrew_codegen.mechanics.settings import settings
from coscrew_codegen.mechanics.slopes import Along
from coscrew_codegen.recording.numbers import Number, add, cross, dot
from coscrew_codegen.recording.recorder import array
from coscrew_codegen.scene.effect import Place, required
from coscrew_codegen.scene.effect_quantities import (
    ENERGY,
    FORCE,
    POWER,
    SATURATED,
    TORQUE,
    functions_of_effects,
    units_of,
)
from coscrew_codegen.scene.scene import Applied
from coscrew_codegen.scene_functions import Function

_Found = Mapping[str, Callable[[], Sequence[Number]]]
"""The components of each quantity, computed where they are wanted."""


class EffectFunctions(Derivation):
    """The functions of the torque, force, power and energy of each effect where it acts."""

    def _of_effects(self) -> Makers:
        return {name: partial(self._effect, name, applied)
                for name, applied in functions_of_effects(self.scene).items()}

    def _effect(self, name: str, applied: Applied) -> Function:
        wanted = units_of(applied, self.scene)

        def compute(x: Recording) -> Results:
            motion = x.motion(accelerating=False)
            found = _quantities(x, motion, applied)
            return [found[quantity]() for quantity in wanted]

        return self._function(
            name, f"{_in_words(applied, wanted)} of {applied.name}", "q v",
            [array(quantity, () if len(units) == 1 else (len(units),), f"in {units[0]}")
             for quantity, units in wanted.items()], compute, acted=True)


def _in_words(applied: Applied, wanted: Mapping[str, tuple[str, ...]]) -> str:
    """force in N, torque in N m about the body's origin, both in the world's axes, power in W."""
    places = {FORCE: "", TORQUE: " about the body's origin, both in the world's axes"} \
        if applied.effect.place is Place.BODY else {}
    return ", ".join(f"{quantity} (1 while the limit takes some of the torque, else 0)"
                     if quantity == SATURATED else
                     f"{quantity} in {units[0]}{places.get(quantity, '')}"
                     for quantity, units in wanted.items())


def _quantities(x: Recording, motion: Motion, applied: Applied) -> _Found:
    effect = applied.effect
    if effect.gravity:
        return {POWER: lambda: [dot(motion.gravity, energies.momentum(x, motion)[:3])],
                ENERGY: lambda: [energies.potential(x, motion)]}
    if effect.joint_inertia:
        return {ENERGY: lambda: [_kinetic(x, motion, applied)]}
    acting = Acting(alone(x.scene, applied), motion).act()
    if effect.joint_torque:
        ((along,),) = acting.torques.values()
        return _of_joint(along)
    if effect.pair_force:
        (pair,) = acting.pairs
        return _of_pair(pair.along)
    ((force,),) = acting.forces.values()
    return _of_body(force)


def _kinetic(x: Recording, motion: Motion, applied: Applied) -> Number:
    """I v²/2 of a joint's own inertia."""
    v = motion.speeds(x.tree.links.index(x.tree.link_of(applied.on)))[0]
    values = settings(x.recorder, applied.values, x.recorder.number(0))
    return required(applied.effect.joint_inertia)(values) * (v * v) / 2


def _of_joint(along: Along) -> _Found:
    torque = required(along.torque.torque)
    return {TORQUE: lambda: [torque], POWER: lambda: [torque * along.at.v],
            ENERGY: lambda: [required(along.torque.energy)], SATURATED: lambda: [along.saturated]}


def _of_pair(along: Along) -> _Found:
    push = required(along.torque.torque)
    return {FORCE: lambda: [-push], POWER: lambda: [push * along.at.v],
            ENERGY: lambda: [required(along.torque.energy)]}


def _of_body(applied: AppliedForce) -> _Found:
    state, force, moment = applied.state, applied.wrench[:3], applied.wrench[3:]
    point = required(applied.force.point)
    return {FORCE: lambda: state.world_direction(force),
            TORQUE: lambda: state.world_direction(add(moment, cross(point, force))),
            POWER: lambda: [applied.power()],
            ENERGY: lambda: [required(applied.force.energy)]}
