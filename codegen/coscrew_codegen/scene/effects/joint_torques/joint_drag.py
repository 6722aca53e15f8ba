"""Drag of a joint: resistance that grows with the square of the speed, as with a propeller."""

from coscrew_codegen.algebra.recording.numbers import absolute
from coscrew_codegen.scene.effect import CoordinateState, Effect, ParameterOf, Place, Torque, Values


def _torque(state: CoordinateState, values: Values) -> Torque:
    """-c |v| v."""
    return Torque(-(values["c"] * (absolute(state.v) * state.v)))


EFFECT = Effect(
    "joint_drag", "resistance that grows with the square of the joint's speed", "tau = -c |v| v",
    Place.JOINT,
    (ParameterOf("c", "N m s^2/rad^2 or N s^2/m^2", "resistance by the square of the speed",
                 nonnegative=True),),
    joint_torque=_torque, each=True, resists=True)
