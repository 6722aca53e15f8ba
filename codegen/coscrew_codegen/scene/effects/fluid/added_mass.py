"""Added mass: the inertia of the fluid that a body sets in motion."""

from fractions import Fraction

from coscrew_codegen.scene.effect import BodyInertia, Effect, ParameterOf, Place, Values


def _inertia(values: Values) -> BodyInertia:
    """M = diag(mass, inertia) + matrix, at the point, in the body's axes."""
    point, zero = values.vector("point"), values.vector("point")[0].like(0)
    rows = [[zero] * 6 for _ in range(6)]
    diagonal = [values.optional_vector(name) or (zero,) * 3 for name in ("mass", "inertia")]
    for k, x in enumerate((*diagonal[0], *diagonal[1])):
        rows[k][k] = x
    lower = [(i, j) for i in range(6) for j in range(i + 1)]
    for (i, j), x in zip(lower, values.optional_vector("matrix") or (zero,) * 21, strict=True):
        rows[i][j] = rows[i][j] + x
    return BodyInertia(point, tuple(rows[max(i, j)][min(i, j)] for i in range(6)
                                    for j in range(6)))


EFFECT = Effect(
    "added_mass", "inertia of the fluid that a body sets in motion",
    "(f; τ) = -(M V' + [ad]*(V) M V) at the point, V = (u; ω) the body's motion in the fluid",
    Place.BODY,
    (ParameterOf("mass", "kg", "added masses along the body's axes, as Fossen's -X_u', -Y_v', "
                 "-Z_w'", "vector", required=False, nonnegative=True),
     ParameterOf("inertia", "kg m^2", "added moments of inertia about the body's axes, as Fossen's "
                 "-K_p', -M_q', -N_r'", "vector", (Fraction(0),) * 3, nonnegative=True),
     ParameterOf("matrix", "kg", "symmetric 6 x 6 matrix for (u; ω), with kg m beside and kg m^2 "
                 "below the masses; added to these", "matrix", required=False),
     ParameterOf("point", "m", "where these numbers hold, in the body's frame", "vector",
                 (Fraction(0),) * 3)),
    any_of=("mass", "matrix"), body_inertia=_inertia, stores_energy=True, in_fluid=True)
