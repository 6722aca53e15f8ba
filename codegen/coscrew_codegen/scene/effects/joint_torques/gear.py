"""Gear: elasticity between a motor's rotor and its joint."""

from fractions import Fraction
from typing import TYPE_CHECKING

from coscrew_codegen.algebra.recording.numbers import sqrt
from coscrew_codegen.scene.effect import (
    CoordinateState,
    Effect,
    Elastic,
    ParameterOf,
    Place,
    StateOf,
    Torque,
    Values,
)

if TYPE_CHECKING:
    from coscrew_codegen.algebra.recording.numbers import Number

_SHARE = Fraction(1, 10)
"""Damping in place of d: of sqrt(k J), a twentieth of the critical one with the joint held."""


def _torque(state: CoordinateState, values: Values) -> Torque:
    """k (θ - q) + d (θ' - v); the energy is that of the spring and of the rotor."""
    (angle, speed), k, inertia = state.x, values["k"], _inertia(values)
    d = values.get("d")
    if d is None:
        d = sqrt(k * inertia) * _SHARE
    twist, rate = angle - state.q, speed - state.v
    return Torque(k * twist + d * rate, energy=(k * twist * twist + inertia * speed * speed) / 2,
                  power=-(d * rate * rate), damping=k.like(0), stiffness=k.like(0),
                  elastic=Elastic(inertia, k, d))


def _inertia(values: Values) -> "Number":
    """inertia + gear^2 rotor, without the terms that are not given."""
    inertia, ratio, rotor = values.get("inertia"), values["gear"], values.get("rotor")
    if rotor is None:
        return values["inertia"]
    reflected = ratio * ratio * rotor
    return reflected if inertia is None else inertia + reflected


EFFECT = Effect(
    "gear", "elastic gear between a joint and its rotor, on which the joint's actuators act",
    "tau = k (theta - q) + d (theta' - v); J theta'' = u - tau, J = inertia + gear^2 rotor, u of "
    "the actuators at theta, theta'", Place.JOINT,
    (ParameterOf("k", "N m/rad or N/m", "stiffness", positive=True),
     ParameterOf("d", "N m s/rad or N s/m", "damping; 0.1 sqrt(k J) if not given", required=False,
                 nonnegative=True),
     ParameterOf("inertia", "kg m^2 or kg", "of the rotor, reflected to the joint", required=False,
                 positive=True),
     ParameterOf("rotor", "kg m^2", "inertia of the rotor", required=False, positive=True),
     ParameterOf("gear", "1, or rad/m", "turns of the rotor for one of the joint", default=1)),
    any_of=("inertia", "rotor"), joint_torque=_torque, stores_energy=True, elastic=True,
    states=(StateOf("angle", "rad or m", "of the rotor over the gear", starts="q"),
            StateOf("speed", "rad/s or m/s", "of the rotor over the gear", starts="v")))
