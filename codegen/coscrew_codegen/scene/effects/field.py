"""Field: the gravity of a distant sphere, with the torque of its gravity gradient."""

from fractions import Fraction

from coscrew_codegen.algebra.recording.numbers import dot, sqrt, subtract
from coscrew_codegen.scene.effect import BodyState, Effect, Force, ParameterOf, Place, Values


def _force(state: BodyState, values: Values) -> Force:
    """The energy by MacCullagh's formula, accurate to second order in the body's size over r; force
    and moment are derived from it."""
    offset = subtract(state.world_position(state.centre_of_mass), values.vector("centre"))
    square = dot(offset, offset)
    xx, yy, zz, xy, xz, yz = state.inertia
    x, y, z = r = state.own_direction(offset)
    I_r = (xx * x + xy * y + xz * z, xy * x + yy * y + yz * z, xz * x + yz * y + zz * z)
    shape = (xx + yy + zz) - dot(r, I_r) * 3 / square
    return Force(energy=-(values["mu"] * (state.mass + shape / (square * 2)) / sqrt(square)))


EFFECT = Effect(
    "field", "gravity of a distant sphere: attracts a body with a mass, and turns its long axis "
    "towards it",
    "V = -mu m/r - mu (J - 3 j)/(2 r^3), with J = tr I and j = e·(I e); r e points from the "
    "centre to the centre of mass", Place.BODY,
    (ParameterOf("mu", "m^3/s^2", "gravitational parameter G M of the sphere", nonnegative=True),
     ParameterOf("centre", "m", "centre of the sphere, in the world's frame", "vector",
                 (Fraction(0),) * 3)),
    body_force=_force, stores_energy=True, massive=True)
