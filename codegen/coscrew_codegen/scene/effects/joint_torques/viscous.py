"""Viscous friction: proportional to the velocity and opposite to it."""

from coscrew_codegen.scene.effect import CoordinateState, Effect, ParameterOf, Place, Torque, Values


def _torque(state: CoordinateState, values: Values) -> Torque:
    """-d v."""
    return Torque(-(values["d"] * state.v))


EFFECT = Effect(
    "viscous", "friction proportional to the velocity", "tau = -d v", Place.JOINT,
    (ParameterOf("d", "N m s/rad or N s/m", "damping", model="damping", nonnegative=True),),
    joint_torque=_torque, alone=True, each=True, resists=True)
