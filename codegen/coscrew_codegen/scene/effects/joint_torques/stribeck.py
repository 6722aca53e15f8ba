"""Stribeck friction, regularised: dry friction that is larger at rest than in motion."""

from coscrew_codegen.algebra.recording.numbers import exp, tanh
from coscrew_codegen.scene.effect import CoordinateState, Effect, ParameterOf, Place, Torque, Values


def _torque(state: CoordinateState, values: Values) -> Torque:
    """-[tau_c + (tau_s - tau_c) exp(-(v/v_s)^2)] tanh(v/eps)."""
    v, tau_c = state.v, values["tau_c"]
    ratio = v * (1 / values["v_s"])
    level = tau_c + (values["tau_s"] - tau_c) * exp(-(ratio * ratio))
    return Torque(-(level * tanh(v * (1 / values["eps"]))))


EFFECT = Effect(
    "stribeck", "dry friction that falls from tau_s near rest to tau_c; creeps at rest as coulomb",
    "tau = -[tau_c + (tau_s - tau_c) exp(-(v/v_s)^2)] tanh(v/eps)", Place.JOINT,
    (ParameterOf("tau_c", "N m or N", "friction at high speed", model="friction", nonnegative=True),
     ParameterOf("tau_s", "N m or N", "friction at break-away", nonnegative=True),
     ParameterOf("v_s", "rad/s or m/s", "speed over which friction falls", positive=True),
     ParameterOf("eps", "rad/s or m/s", "speed at which friction has 76 % of its value; well below "
                 "v_s", positive=True)),
    joint_torque=_torque, each=True, resists=True)
