"""Actuator: a torque as a function of time, a PD controller or a DC motor; all may saturate, the
first two by a line of torque over speed; and all may follow their demand with a lag."""

from typing import TYPE_CHECKING

from coscrew_codegen.scene.effect import (
    CoordinateState,
    Effect,
    ParameterOf,
    Place,
    StateOf,
    Torque,
    Values,
)

if TYPE_CHECKING:
    from coscrew_codegen.algebra.recording.numbers import Number


def _torque(state: CoordinateState, values: Values) -> Torque:
    """sat(u) = max(-limit, min(u, limit)), less where it drives a joint that moves fast."""
    return Torque(_demanded(state, values), limit=values.get("limit"),
                  no_load=values.get("speed"), lag=values.get("lag"))


def _demanded(state: CoordinateState, values: Values) -> "Number":
    """The torque u before saturation."""
    if values.word("kind") == "dc":
        return _motor(state, values)
    parts = []
    if values.word("kind") == "pd":
        parts = [values["kp"] * (values["target"] - state.q)
                 + values["kd"] * (values["target_v"] - state.v)]
    parts += [x for x in (values.get("torque"), state.holding) if x is not None]
    first, *others = parts
    for x in others:
        first = first + x
    return first


def _motor(state: CoordinateState, values: Values) -> "Number":
    """The torque of a DC motor."""
    strength = values["gear"] * values["kt"] / values["R"]
    return strength * (values["voltage"] - values["ke"] * values["gear"] * state.v)


EFFECT = Effect(
    "actuator", "drives a joint: with a torque, to a target, or by the voltage of a DC motor",
    "tau = sat(u); torque: u = torque(t) + g; pd: u = kp (target(t) - q) + kd (target_v(t) - v) + "
    "torque(t) + g; dc: u = (gear kt/R) (voltage(t) - ke gear v); g = gravity_torques(q) of the "
    "joint if compensated, else 0; |sat(u)| <= limit, and <= limit max(1 - |v|/speed, 0) if it "
    "drives; with a lag tau' = (sat(u) - tau)/lag, from tau = 0", Place.JOINT,
    (ParameterOf("kind", "", "kind of actuator", "choice", choices=("torque", "pd", "dc")),
     ParameterOf("torque", "N m or N", "torque or force; of pd fed forward", "formula",
                 of=("torque", "pd"), optional_of=("pd",)),
     ParameterOf("gravity_compensation", "", "whether it also supplies what holds the joint "
                 "against the weight of the scene's bodies", "flag", required=False,
                 of=("torque", "pd")),
     ParameterOf("target", "rad or m", "target of q", "formula", of=("pd",)),
     ParameterOf("target_v", "rad/s or m/s", "target of v; of a trajectory its rate, if left out",
                 "formula", 0, of=("pd",), rate_of="target"),
     ParameterOf("kp", "N m/rad or N/m", "torque by error", of=("pd",), nonnegative=True),
     ParameterOf("kd", "N m s/rad or N s/m", "torque by error of speed", default=0, of=("pd",),
                 nonnegative=True),
     ParameterOf("voltage", "V", "voltage of the motor", "formula", of=("dc",)),
     ParameterOf("gear", "1, or rad/m", "turns of the rotor for one of the joint", default=1,
                 of=("dc",)),
     ParameterOf("kt", "N m/A", "torque constant", of=("dc",), nonnegative=True),
     ParameterOf("ke", "V s/rad", "speed constant", of=("dc",), nonnegative=True),
     ParameterOf("R", "Ohm", "resistance", of=("dc",), positive=True),
     ParameterOf("limit", "N m or N", "largest torque; none if left out", required=False,
                 model="effort", positive=True),
     ParameterOf("speed", "rad/s or m/s", "speed without load, at which it drives no more; none if "
                 "left out", required=False, model="velocity", positive=True, needs="limit",
                 of=("torque", "pd"), optional_of=("torque", "pd")),
     ParameterOf("lag", "s", "time constant with which the torque follows its demand; none if left "
                 "out", required=False, positive=True)),
    joint_torque=_torque, limited_by="limit", compensates="gravity_compensation", drives=True,
    states=(StateOf("delivered", "N m or N", "torque that acts", of="lag"),))
