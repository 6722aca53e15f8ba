"""Limits of a joint: contact by Hunt and Crossley's law, which pushes and never pulls."""

from coscrew_codegen.algebra.recording.numbers import absolute, less, maximum, minimum, sqrt, where
from coscrew_codegen.scene.contacts.closeness import Contact
from coscrew_codegen.scene.effect import CoordinateState, Effect, ParameterOf, Place, Torque, Values


def _torque(state: CoordinateState, values: Values) -> Torque:
    """Returns the torque, from the distance x of q beyond its range, x < 0 below it, and δ = |x|:

    torque -k x √δ (1 + 1.5 alpha δ'), zero where it would pull; energy 0.4 k δ^2.5; the power of
    the torque beyond -k x √δ is dissipated.  Powers of δ are products with √δ: no slope at δ = 0.
    """
    q, v, k = state.q, state.v, values["k"]
    within = q
    lower, upper = values.get("lower"), values.get("upper")
    if lower is not None:
        within = maximum(within, lower)
    if upper is not None:
        within = minimum(within, upper)
    x = q - within
    depth = absolute(x)
    root = k * sqrt(depth)
    steepness = values["alpha"] * 3 / 2
    push = maximum(steepness * where(less(x, 0), -v, v) + 1, 0)
    elastic = root * x
    torque = -(elastic * push)
    return Torque(torque, damping=where(less(x.like(0), push), steepness * (root * depth), 0),
                  stiffness=root * push * 3 / 2, energy=elastic * x * 2 / 5,
                  power=(torque + elastic) * v, contact=None if k.is_zero else Contact(k, depth))


_RANGE = "end of the joint's range; none if the model has none"

EFFECT = Effect(
    "limit", "ends of a joint's range, elastic and damped by Hunt and Crossley's law",
    "tau = ±max(k δ^1.5 (1 + 1.5 alpha δ'), 0), δ = lower - q or q - upper where that is above 0",
    Place.JOINT,
    (ParameterOf("lower", "rad or m", f"lower {_RANGE}", default="model", required=False,
                 model="lower"),
     ParameterOf("upper", "rad or m", f"upper {_RANGE}; of a spherical joint the largest angle",
                 default="model", required=False, model="upper"),
     ParameterOf("k", "N m/rad^1.5 or N/m^1.5", "stiffness", nonnegative=True, example="1e4"),
     ParameterOf("alpha", "s/rad or s/m", "damping: a bounce at the speed v keeps about "
                 "1/(1 + alpha v) of it", default=0, nonnegative=True)),
    any_of=("lower", "upper"), ascending=("lower", "upper"), joint_torque=_torque,
    stores_energy=True, by_angle=True)
