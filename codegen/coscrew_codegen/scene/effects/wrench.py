"""Wrench: a force at a point of a body and a torque, constant, functions of time or at run time."""

from fractions import Fraction

from coscrew_codegen.scene.effect import BodyState, Effect, Force, ParameterOf, Place, Values


def _force(state: BodyState, values: Values) -> Force:
    """The force and the torque in the body's frame."""
    force, torque = (x and state.own_direction(x) if values.word("frame") == "world" else x
                     for x in map(values.optional_vector, ("force", "torque")))
    point = values.vector("point")
    zero = point[0].like(0)
    return Force(point, force or (zero, zero, zero), torque)


EFFECT = Effect(
    "wrench", "force at a point of a body, and a torque", "(force; torque + point × force)",
    Place.BODY,
    (ParameterOf("force", "N", "functions of t", "formulas", required=False),
     ParameterOf("torque", "N m", "functions of t", "formulas", required=False),
     ParameterOf("point", "m", "where the force acts, in the body's frame", "vector",
                 (Fraction(0),) * 3),
     ParameterOf("frame", "", "in which force and torque are given", "choice", "world",
                 choices=("world", "body"))),
    any_of=("force", "torque"), body_force=_force)
