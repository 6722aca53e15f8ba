"""Spring: a torque proportional to the deviation from rest."""

from coscrew_codegen.scene.effect import CoordinateState, Effect, ParameterOf, Place, Torque, Values


def _torque(state: CoordinateState, values: Values) -> Torque:
    """-k (q - q0), of energy k (q - q0)^2 / 2."""
    k, away = values["k"], state.q - values["q0"]
    return Torque(-(k * away), energy=k / 2 * (away * away))


EFFECT = Effect(
    "spring", "elastic torque towards q0", "tau = -k (q - q0); for a quaternion -k log(q0* q), for "
    "the position of a free joint -k R^T (x - x0)", Place.JOINT,
    (ParameterOf("k", "N m/rad or N/m", "stiffness", nonnegative=True),
     ParameterOf("q0", "rad or m", "position of rest; of a joint with several coordinates all of "
                 "them, by default neutral", default=0)),
    joint_torque=_torque, stores_energy=True, each=True, rest="q0")
