"""Actuator: a torque as a function of time, a PD controller or a DC motor; all may saturate."""

from typing import TYPE_CHECKING

from coscrew_codegen.recording.numbers import absolute, maximum, minimum
from coscrew_codegen.scene.effect import Effect, ParameterOf, Place, Torque, Values

if TYPE_CHECKING:
    from coscrew_codegen.recording.numbers import Number


def _torque(state, values: Values) -> Torque:
    """sat(u) = max(-limit, min(u, limit)); u's slopes times limit / max(|u|, limit): beyond the
    limit they bound the slope, which is zero."""
    limit = values["limit"]
    u, damping, stiffness = _demanded(state, values)
    if limit is None:
        return Torque(u, damping, stiffness)
    share = limit / maximum(absolute(u), limit)
    return Torque(maximum(minimum(u, limit), -limit), damping and damping * share,
                  stiffness and stiffness * share)


def _demanded(state, values: Values) -> "tuple[Number, Number | None, Number | None]":
    """u and its slopes -∂u/∂v, -∂u/∂q."""
    kind = values["kind"]
    if kind == "torque":
        return values["torque"], None, None
    if kind == "pd":
        kp, kd = values["kp"], values["kd"]
        return (kp * (values["target"] - state.q) + kd * (values["target_v"] - state.v), kd, kp)
    strength = values["gear"] * values["kt"] / values["R"]
    back = values["ke"] * values["gear"]
    return strength * (values["voltage"] - back * state.v), strength * back, None


EFFECT = Effect(
    "actuator", "drives a joint: with a torque, to a target, or by the voltage of a DC motor",
    "tau = sat(u); torque: u = torque(t); pd: u = kp (target(t) - q) + kd (target_v(t) - v); "
    "dc: u = (gear kt/R) (voltage(t) - ke gear v)", Place.JOINT,
    (ParameterOf("kind", "", "what drives", "choice", choices=("torque", "pd", "dc")),
     ParameterOf("torque", "N m or N", "what it supplies", "formula", of=("torque",)),
     ParameterOf("target", "rad or m", "where it drives to", "formula", of=("pd",)),
     ParameterOf("target_v", "rad/s or m/s", "how fast the target moves", "formula", 0, of=("pd",)),
     ParameterOf("kp", "N m/rad or N/m", "torque by error", of=("pd",), nonnegative=True),
     ParameterOf("kd", "N m s/rad or N s/m", "torque by error of speed", default=0, of=("pd",),
                 nonnegative=True),
     ParameterOf("voltage", "V", "at the motor", "formula", of=("dc",)),
     ParameterOf("gear", "1, or rad/m", "turns of the rotor for one of the joint", default=1,
                 of=("dc",)),
     ParameterOf("kt", "N m/A", "torque constant", of=("dc",), nonnegative=True),
     ParameterOf("ke", "V s/rad", "speed constant", of=("dc",), nonnegative=True),
     ParameterOf("R", "Ohm", "resistance", of=("dc",), positive=True),
     ParameterOf("limit", "N m or N", "largest torque; none if left out", required=False,
                 model="effort", positive=True)),
    joint_torque=_torque)
