"""Ground: the plane that contacts stand on."""

from fractions import Fraction

from coscrew_codegen.algebra.recording.numbers import Number, Vector, dot, scaled, sqrt
from coscrew_codegen.scene.effect import Effect, ParameterOf, Place, Values


def _ground(values: Values, point: Vector) -> tuple[Number, Vector]:
    """n·x - offset, and n."""
    normal = values.vector("normal")
    n = scaled(1 / sqrt(dot(normal, normal)), normal)
    return dot(n, point) - values["offset"], n


EFFECT = Effect(
    "ground", "the plane that contacts stand on; without it, z = 0", "n·x = offset, |n| = 1",
    Place.SCENE,
    (ParameterOf("normal", "1", "direction out of the ground, in the world's frame", "vector",
                 (Fraction(0), Fraction(0), Fraction(1))),
     ParameterOf("offset", "m", "the plane's distance from the origin, along the normal",
                 default=0)),
    ground=_ground)
