"""Stiction: dry friction of bristles, which hold a joint in place for ever."""

from fractions import Fraction

from coscrew_codegen.algebra.recording.numbers import absolute, exp, maximum, minimum
from coscrew_codegen.scene.contacts.closeness import Resting
from coscrew_codegen.scene.effect import (
    CoordinateState,
    Effect,
    Given,
    ParameterOf,
    Place,
    StateOf,
    Torque,
    Values,
)

_LEAST = Fraction(1, 10**30)
"""N m: instead of a level or a pull of zero, so that there is no 0/0."""


def _torque(state: CoordinateState, values: Values) -> Torque:
    """-(k z + d v), at most the level; bristles that would pull by more than it slip."""
    v, (z,), tau_c, tau_s = state.v, state.x, values["tau_c"], values.get("tau_s")
    level = tau_c
    if tau_s is not None:
        ratio = v * (1 / values["v_s"])
        level = tau_c + (tau_s - tau_c) * exp(-(ratio * ratio))
    k = values["k"]
    bent = k * absolute(z)
    share, held = minimum(level / maximum(bent, _LEAST), 1), minimum(bent, level)
    pull = k * z + values["d"] * v
    return Torque(-pull, limit=level, rates=(v,), bounded=(z,), share=share,
                  switches=(level - absolute(pull), level - bent), stored=held * held / (2 * k))


def _completed(values: Given, _: Resting) -> Given:
    """The values with defaults for k and d."""
    level = max((x for name in ("tau_c", "tau_s") if isinstance(x := values[name], Fraction)),
                default=Fraction(0))
    k = values["k"] if isinstance(values["k"], Fraction) else level * 1000 or Fraction(1)
    return {**values, "k": k, "d": k / 100 if values["d"] is None else values["d"]}


EFFECT = Effect(
    "stiction", "dry friction of elastic bristles: holds a joint at rest for ever, where coulomb "
    "creeps",
    "tau = -(k z + d v), at most tau_c + (tau_s - tau_c) exp(-(v/v_s)^2); z' = v until k |z| is "
    "that", Place.JOINT,
    (ParameterOf("tau_c", "N m or N", "friction at high speed", model="friction",
                 nonnegative=True),
     ParameterOf("tau_s", "N m or N", "friction at break-away; that at high speed if not given",
                 required=False, nonnegative=True),
     ParameterOf("v_s", "rad/s or m/s", "speed over which friction falls from tau_s to tau_c",
                 default=Fraction(1, 100), positive=True),
     ParameterOf("k", "N m/rad or N/m", "stiffness of the bristles: at rest the joint yields by "
                 "torque/k; the friction at break-away over 1 mrad, or 1 mm, if not given",
                 required=False, positive=True),
     ParameterOf("d", "N m s/rad or N s/m", "damping of the bristles; k times 10 ms if not given",
                 required=False, nonnegative=True)),
    joint_torque=_torque, completed=_completed,
    states=(StateOf("z", "rad or m", "deflection of the bristles"),), switches=2)
