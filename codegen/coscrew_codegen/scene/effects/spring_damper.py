"""Spring and damper along the line between a point of one body and a point of another."""

from coscrew_codegen.scene.effect import (
    POINTS,
    CoordinateState,
    Effect,
    ParameterOf,
    Place,
    Torque,
    Values,
)


def _force(state: CoordinateState, values: Values) -> Torque:
    """-[k (l - length) + d l'], l the distance of the points."""
    length, rate = state.q, state.v
    k, d = (length.like(0) if x is None else x for x in map(values.get, ("k", "d")))
    longer = length - values["length"]
    return Torque(-(k * longer + d * rate), energy=k / 2 * (longer * longer),
                  power=-(d * (rate * rate)))


EFFECT = Effect(
    "spring_damper", "spring and damper between points of two bodies; no force where they meet",
    "f = [k (l - length) + d l'] x/l on the first, -f on the second", Place.PAIR,
    (*POINTS,
     ParameterOf("k", "N/m", "stiffness", required=False, nonnegative=True),
     ParameterOf("d", "N s/m", "damping", required=False, nonnegative=True),
     ParameterOf("length", "m", "length of the spring at rest", default=0, nonnegative=True)),
    any_of=("k", "d"), pair_force=_force, stores_energy=True)
