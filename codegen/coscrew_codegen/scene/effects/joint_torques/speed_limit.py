"""Speed limit: a joint that moves faster is braked in proportion to the excess."""

from coscrew_codegen.algebra.recording.numbers import maximum, minimum
from coscrew_codegen.scene.effect import CoordinateState, Effect, ParameterOf, Place, Torque, Values


def _torque(state: CoordinateState, values: Values) -> Torque:
    """-d (v - max(-speed, min(v, speed)))."""
    v, speed = state.v, values["speed"]
    return Torque(-(values["d"] * (v - maximum(minimum(v, speed), -speed))), ahead=True)


EFFECT = Effect(
    "speed_limit", "brake of a joint that moves faster than its largest speed",
    "tau = -d max(|v| - speed, 0) sgn v", Place.JOINT,
    (ParameterOf("speed", "rad/s or m/s", "largest speed", model="velocity", positive=True),
     ParameterOf("d", "N m s/rad or N s/m", "torque by the excess of speed", nonnegative=True,
                 example="1e2")),
    joint_torque=_torque, resists=True)
