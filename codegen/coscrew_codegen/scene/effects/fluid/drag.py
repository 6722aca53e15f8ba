"""Drag: the resistance of the fluid to a point of a body, quadratic or linear in its speed."""

from fractions import Fraction

from coscrew_codegen.algebra.recording.numbers import dot, maximum, negative, scaled, sqrt
from coscrew_codegen.scene.effect import (
    BodyState,
    Effect,
    Force,
    ParameterOf,
    Place,
    PointSlopes,
    Slopes,
    Values,
)

_AT_REST = Fraction(1, 10**15)
"""m/s: the smallest divisor |u| in u/|u|; where it is larger than |u|, the slopes vanish.  Its
square is in single precision's range, for derivatives."""


def _force(state: BodyState, values: Values) -> Force:
    """-½ rho area |u| u, whose slope is rho area |u| along u and half of it across; or -b u."""
    point = values.vector("point")
    u, zero = state.velocity_in_fluid(point), state.t.like(0)
    if values.word("kind") == "stokes":
        return Force(point, negative(scaled(values["b"], u)), slopes=Slopes(values["b"], zero))
    speed = sqrt(dot(u, u))
    slope = values["rho"] * values["area"] * speed
    return Force(point, negative(scaled(slope / 2, u)), slopes=PointSlopes(
        Slopes(slope / 2, zero), Slopes(slope, zero), scaled(1 / maximum(speed, _AT_REST), u)))


EFFECT = Effect(
    "drag", "resistance of the fluid at a point of a body",
    "quadratic: f = -rho area |u| u / 2; stokes: f = -b u; u the point's velocity in the fluid",
    Place.BODY,
    (ParameterOf("kind", "", "law of resistance", "choice", "quadratic",
                 choices=("quadratic", "stokes")),
     ParameterOf("rho", "kg/m^3", "density of the fluid", of=("quadratic",), nonnegative=True),
     ParameterOf("area", "m^2", "drag area: coefficient of drag times area", of=("quadratic",),
                 nonnegative=True),
     ParameterOf("b", "N s/m", "resistance by speed", of=("stokes",), nonnegative=True),
     ParameterOf("point", "m", "where it acts, in the body's frame", "vector", (Fraction(0),) * 3)),
    body_force=_force, in_fluid=True, resists=True)
