"""Buoyancy: the weight of displaced fluid, upwards."""

from fractions import Fraction

from coscrew_codegen.algebra.recording.numbers import dot, negative, scaled
from coscrew_codegen.scene.effect import BodyState, Effect, Force, ParameterOf, Place, Values


def _force(state: BodyState, values: Values) -> Force:
    """-rho V g at the centre x, with the energy rho V g·x; g is the scene's gravity or zero."""
    centre, displaced = values.vector("centre"), values["rho"] * values["V"]
    weight = scaled(displaced, state.gravity)
    return Force(centre, state.own_direction(negative(weight)),
                 energy=dot(weight, state.world_position(centre)))


EFFECT = Effect(
    "buoyancy", "lift of a body in a fluid, in the scene's gravity; nothing without gravity",
    "f = -rho V g at the centre", Place.BODY,
    (ParameterOf("rho", "kg/m^3", "density of the fluid", nonnegative=True),
     ParameterOf("V", "m^3", "volume of the body", nonnegative=True),
     ParameterOf("centre", "m", "centre of the volume, in the body's frame", "vector",
                 (Fraction(0),) * 3)),
    body_force=_force, stores_energy=True)
