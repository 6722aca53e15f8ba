"""Viscous friction: against the speed and proportional to it."""

from coscrew_codegen.scene.effect import CoordinateState, Effect, ParameterOf, Place, Torque, Values


def _torque(state: CoordinateState, values: Values) -> Torque:
    """-d v."""
    return Torque(-(values["d"] * state.v))


EFFECT = Effect(
    "viscous", "friction proportional to the speed", "tau = -d v", Place.JOINT,
    (ParameterOf("d", "N m s/rad or N s/m", "damping", model="damping", nonnegative=True),),
    joint_torque=_torque)
