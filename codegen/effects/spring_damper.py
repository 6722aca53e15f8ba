"""Spring and damper along the line between a point of one body and a point of another."""

from fractions import Fraction

from coscrew_codegen.recording.numbers import dot, maximum, negative, scaled, sqrt, subtract
from coscrew_codegen.scene.effect import Effect, Force, Line, ParameterOf, Place, Values

CLOSEST = Fraction(1, 10**12)
"""Below this distance, in m, the direction of the line fades to zero: where points meet is none."""


def _forces(first, second, values: Values) -> tuple[Force, Force, Line]:
    """±[k (l - length) + d l'] e, e = x / max(l, CLOSEST) x from the first point to the second."""
    a, b = values["first"], values["second"]
    x = first.line_to(a, second, b)
    length = sqrt(dot(x, x))
    k, d = (length.like(0) if values[name] is None else values[name] for name in ("k", "d"))
    e = scaled(1 / maximum(length, CLOSEST), x)
    rate = dot(e, subtract(second.world_direction(second.velocity(b)),
                           first.world_direction(first.velocity(a))))
    longer = length - values["length"]
    pull = scaled(k * longer + d * rate, e)
    zero = rate.like(0)
    return (Force(a, first.own_direction(pull), energy=k / 2 * (longer * longer),
                  power=-(d * (rate * rate))),
            Force(b, second.own_direction(negative(pull)), power=zero),
            Line(e, rate, d, k))


EFFECT = Effect(
    "spring_damper", "spring and damper between points of two bodies; no force where they meet",
    "f = [k (l - length) + d l'] x/l on the first, -f on the second", Place.PAIR,
    (ParameterOf("first", "m", "where it is fixed to the first body, in its frame", "vector",
                 (Fraction(0),) * 3),
     ParameterOf("second", "m", "where it is fixed to the second body, in its frame", "vector",
                 (Fraction(0),) * 3),
     ParameterOf("k", "N/m", "stiffness", required=False, nonnegative=True),
     ParameterOf("d", "N s/m", "damping", required=False, nonnegative=True),
     ParameterOf("length", "m", "at which the spring is at rest", default=0, nonnegative=True)),
    any_of=("k", "d"), pair_force=_forces)
