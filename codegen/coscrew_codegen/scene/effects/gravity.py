"""Gravity: the base accelerates against it."""

from fractions import Fraction

from coscrew_codegen.scene.effect import Effect, ParameterOf, Place

EFFECT = Effect(
    "gravity", "every body falls with g", "a_0 = -g", Place.SCENE,
    (ParameterOf("g", "m/s^2", "acceleration of free fall, in the world's frame", "vector",
                 (Fraction(0), Fraction(0), Fraction(-981, 100))),),
    gravity=lambda values: values.vector("g"), stores_energy=True, alone=True)
