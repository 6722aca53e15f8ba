"""Ground: the plane or the heights that contacts stand on."""

from coscrew_codegen.algebra.recording.numbers import Number, Vector, dot, scaled, sqrt
from coscrew_codegen.scene.contacts.closeness import Resting
from coscrew_codegen.scene.effect import Effect, Given, ParameterOf, Place, Values


def _ground(values: Values, point: Vector) -> tuple[Number, Vector]:
    """n·x - offset, and n; or (z - H)/|(-∇H, 1)|, and (-∇H, 1)/|(-∇H, 1)| of heights H(x, y)."""
    if (surface := values.surface("height")) is not None:
        height, along_x, along_y = surface(point[0], point[1])
        length = sqrt(along_x * along_x + along_y * along_y + 1)
        n = scaled(1 / length, (-along_x, -along_y, along_x.like(1)))
        return (point[2] - height) / length, n
    normal, offset = values.optional_vector("normal"), values.get("offset")
    if normal is None:
        n = tuple(point[0].like(x) for x in (0, 0, 1))
    else:
        n = scaled(1 / sqrt(dot(normal, normal)), normal)
    distance = dot(n, point)
    return distance if offset is None else distance - offset, n


def _completed(values: Given, _: Resting) -> Given:
    """The values.  Raises ValueError for a plane and heights at once."""
    plane = [name for name in ("normal", "offset") if values[name] is not None]
    if values["height"] is not None and plane:
        raise ValueError(f"height and {' and '.join(plane)} are given; wanted heights or a plane")
    return values


EFFECT = Effect(
    "ground", "the plane, or the heights, that contacts stand on; without it, z = 0",
    "n·x = offset, |n| = 1; or z = height(x, y)", Place.SCENE,
    (ParameterOf("normal", "1", "direction out of the ground, in the world's frame; z if not given",
                 "vector", required=False),
     ParameterOf("offset", "m", "the plane's distance from the origin, along the normal; 0 if not "
                 "given", required=False),
     ParameterOf("height", "m", "function of x and y", "height", required=False,
                 example='"0.03*sin(6*x)*cos(6*y)"')),
    ground=_ground, completed=_completed)
