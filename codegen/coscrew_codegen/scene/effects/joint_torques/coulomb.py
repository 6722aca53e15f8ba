"""Coulomb friction, regularised: a constant torque against the motion, fading near rest."""

from coscrew_codegen.algebra.recording.numbers import tanh
from coscrew_codegen.scene.effect import CoordinateState, Effect, ParameterOf, Place, Torque, Values


def _torque(state: CoordinateState, values: Values) -> Torque:
    """-tau_c tanh(v/eps)."""
    return Torque(-(values["tau_c"] * tanh(state.v * (1 / values["eps"]))))


EFFECT = Effect(
    "coulomb", "dry friction: holds up to tau_c, except for a creep of eps artanh(tau/tau_c)",
    "tau = -tau_c tanh(v/eps)", Place.JOINT,
    (ParameterOf("tau_c", "N m or N", "friction while it slides", model="friction",
                 nonnegative=True),
     ParameterOf("eps", "rad/s or m/s", "speed at which friction has 76 % of its value",
                 positive=True, example="0.01")),
    joint_torque=_torque, each=True, resists=True)
