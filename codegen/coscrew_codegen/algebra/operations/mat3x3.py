"""3×3 matrices: rotations, and matrices in general."""

from functools import partial

import sympy as sp

from coscrew_codegen.algebra.matrices import I3, skew
from coscrew_codegen.algebra.operations.family import Family
from coscrew_codegen.algebra.operations.formulas import eigen, euler, nearest, special
from coscrew_codegen.algebra.operations.formulas.norm import (
    Let,
    calm,
    divided,
    l2,
    largest_size,
    nonzero,
    prefixed,
    safe_normalized,
    stepwise_power,
)
from coscrew_codegen.algebra.operations.operation import (
    DEPENDENT,
    INDISTINCT,
    SPOILED,
    STEPS,
    Operation,
    scaled,
)
from coscrew_codegen.program.values.quantity import (
    ANY,
    DC,
    MAT3X3,
    NEAR_ROTATION,
    REGULAR,
    ROTATION,
    SCALAR,
    UNIT_VECTOR,
    VEC3,
    Argument,
)

_NAME = "mat3x3"

_R, _self, _Ro = (Argument(name, MAT3X3, ROTATION) for name in ("R", "self", "Ro"))
_near, _own_near = (Argument(name, MAT3X3, NEAR_ROTATION) for name in ("R", "self"))
_v, _dc = Argument("v", VEC3, ANY), Argument("dc", DC)
_axis, _regular = Argument("axis", VEC3, UNIT_VECTOR), Argument("R", MAT3X3, REGULAR)
_x, _y, _z = (Argument(name, VEC3, ANY) for name in "xyz")
_w, _dw = Argument("w", VEC3, ANY), Argument("dw", VEC3, ANY)
_det = Argument("det", SCALAR)
_op = partial(Operation, _NAME)


def _entries(function: type[sp.Function], R: sp.Matrix) -> sp.Matrix:
    return sp.Matrix(3, 3, lambda i, j: function(i, j, *R))


def _about(axis: sp.Matrix, dc: sp.Matrix) -> sp.Matrix:
    return dc[1] * I3 + dc[0] * skew(axis) + (1 - dc[1]) * axis * axis.T


def _bound_about(let: Let, axis: sp.Matrix, dc: sp.Matrix) -> sp.Matrix:
    x, y, z = let("versine_axis", let("versine", 1 - dc[1]) * axis)
    xx, yy, zz, xy, xz, yz = let("m", sp.Matrix([
        x * axis[0], y * axis[1], z * axis[2], x * axis[1], x * axis[2], y * axis[2]]))
    symmetric = sp.Matrix([[dc[1] + xx, xy, xz], [xy, dc[1] + yy, yz], [xz, yz, dc[1] + zz]])
    return symmetric + skew(let("sine_axis", dc[0] * axis))


def products_of(let: Let, w: sp.Matrix) -> sp.Matrix:
    """ω ω^T: xx, yy, zz, xy, xz, yz."""
    x, y, z = w
    return let("ww", sp.Matrix([x * x, y * y, z * z, x * y, x * z, y * z]))


def acceleration_tensor(ww: sp.Matrix, dw: sp.Matrix) -> sp.Matrix:
    """ω'~ + ω~ ω~, from the six products of ω with itself."""
    xx, yy, zz, xy, xz, yz = ww
    return sp.Matrix([[-(yy + zz), xy, xz], [xy, -(xx + zz), yz], [xz, yz, -(xx + yy)]]) + skew(dw)


def _inverse(let: Let, R: sp.Matrix) -> tuple[sp.Expr, sp.Matrix]:
    """det R and adj R / det R, from A = s R, where s is a power of two such that the largest entry
    a of A is between 1 and 2^40 (double 2^300).

    The error of det A is below 4 u times the sum of the absolute values of its terms; a det A below
    twice that may be zero.  Underflow adds at most 2^-147 a^3 (2^-1072 a^3), far less than u det A
    unless det A is below 2^-96 a^3 (2^-760 a^3)."""
    largest = largest_size(let, "R", tuple(R))
    chooses = calm(let, largest)
    s = stepwise_power(let, "s", chooses)
    A = let("A", R.applyfunc(lambda x: scaled(x, s)))
    columns = [A[:, j] for j in range(3)]
    cofactors = [let(f"n{j}", columns[(j + 1) % 3].cross(columns[(j + 2) % 3])) for j in range(3)]
    det = let("d", columns[0].dot(cofactors[0]))
    a, b, c = (let(f"size{j}", column.applyfunc(sp.Abs)) for j, column in enumerate(columns))
    permanent = let("permanent", sum(a[i] * (b[(i + 1) % 3] * c[(i + 2) % 3]
                                             + b[(i + 2) % 3] * c[(i + 1) % 3]) for i in range(3)))
    top = let("top", scaled(largest, s))
    least = let("least", INDISTINCT * permanent + let("spoiled", scaled(top, SPOILED)) * top * top)
    regular = sp.Eq(let("regular", sp.Piecewise((1, least < sp.Abs(det)), (0, True))), 1)
    divisor = let("divisor", sp.Piecewise((det, regular), (1, True)))
    quotients = let("quotient", sp.Matrix.hstack(*cofactors).T / divisor)
    inverse = let("inverse", quotients.applyfunc(lambda x: scaled(x, s)))
    return sp.Piecewise((_unscaled(let, det, chooses), regular), (0, True)), inverse.applyfunc(
        lambda x: sp.Piecewise((x, regular), (sp.nan, True)))


def _unscaled(let: Let, det: sp.Expr, largest: sp.Expr) -> sp.Expr:
    """det / s^3, s the power of two for this largest entry.  Only the last product may overflow.
    Regular matrices with s below 1 / step have an infinite determinant."""
    first, second, third = STEPS
    infinite = sp.Piecewise((-third, det < 0), (third, True))
    once = let("once", scaled(let("start", sp.Piecewise((det, largest < second), (infinite, True))),
                              _where(let, "r2", largest < 1 / first, 1 / third)))
    twice = let("twice", scaled(once, _where(let, "r3", largest < 1 / second, 1 / third)))
    last = sp.Piecewise((1 / third, largest < 1), (1, largest < first), (third, True))
    return let("det_R", scaled(twice, let("r", last)))


def _where(let: Let, name: str, condition: sp.Basic, power: sp.Expr) -> sp.Expr:
    return let(name, sp.Piecewise((power, condition), (1, True)))


def _orthonormal_rows(let: Let, R: sp.Matrix) -> sp.Matrix:
    """Gram–Schmidt.  The first row's component is removed from the second row twice, so that they
    are perpendicular to rounding; the third is the normal to both on the side of R's third row."""
    first, second = (let(name, safe_normalized(prefixed(let, name), R[i, :].T, R[i, :].T))
                     for i, name in enumerate(("q0", "u1")))
    once = let("once", second - let("along", first.dot(second)) * first)
    twice = let("twice", once - let("rest", first.dot(once)) * first)
    n = let("n", l2(twice))
    other = let("q1", divided(twice, let("divisor", nonzero(n))))
    normal = let("normal", first.cross(other))
    u2 = let("u2", safe_normalized(prefixed(let, "u2"), R[2, :].T, R[2, :].T))
    side = let("side", normal.dot(u2))
    third = let("q2", normal.applyfunc(lambda x: sp.Piecewise((-x, side < 0), (x, True))))
    size = let("size", sp.Abs(side))
    less = let("less", sp.Piecewise((n, n < size), (size, True)))
    dependent = sp.Eq(let("dependent", sp.Piecewise((1, less < DEPENDENT), (0, True))), 1)
    rows = sp.Matrix.hstack(first, other, third).T
    return rows.applyfunc(lambda x: sp.Piecewise((sp.nan, dependent), (x, True)))


_GRAM_SCHMIDT = ("orthonormal rows by Gram–Schmidt: the first keeps its direction, the second stays"
                 " on its side of the first, the third on its side of both; NaN where the rows are "
                 "linearly dependent to rounding")
ORTHONORMAL = 8
"""In u: the largest difference of R R^T from I, entry by entry; searched."""
_ROWS = f"|R R^T - I|_ij <= {ORTHONORMAL} u for the result R; searched, not proved."


OPERATIONS = (
    _op("mat3x3_copy", "Ro = R", (_R,), (_Ro,), lambda R: R),
    _op("mat3x3_setIdentity", "self = I", (_self,), (_self,), lambda R: sp.eye(3)),
    _op("mat3x3_setFromVectors", "R = [x y z], the columns", (_x, _y, _z), (_R,),
        lambda x, y, z: sp.Matrix.hstack(x, y, z), order=("R", "x", "y", "z")),
    _op("skew", "Ro = v~, the matrix with v~ y = v × y", (_v,), (_Ro,), skew),
    _op("acceleration_tensor", "Ro = w'~ + w~ w~ of a body with angular velocity w and angular "
        "acceleration w' = dw: the acceleration of its point x, less that of its origin, is Ro x",
        (_w, _dw), (_Ro,), lambda w, dw: skew(dw) + skew(w)**2,
        lambda let, w, dw: acceleration_tensor(products_of(let, w), dw)),
    _op("mat3x3_transpose", "self = self^T, the inverse of a rotation", (_self,), (_self,),
        lambda R: R.T),
    _op("mat3x3_transposed", "Ro = R^T, the inverse of a rotation", (_R,), (_Ro,), lambda R: R.T),
    _op("mat3x3_determinant", "det R", (_R,), (_det,), lambda R: R.det(),
        lambda let, R: R[:, 0].dot(let("n", R[:, 1].cross(R[:, 2])))),
    _op("mat3x3_inverse", "Ro = R^-1 = adj R / det R; returns det R, which is 0 or infinite where "
        "it under- or overflows.  Returns 0, with Ro = NaN, where R may be singular: |det R| <= "
        "8 u p + 1e-29 m^3 (double 1e-229 m^3), p the sum of the |terms| of det R, m the largest "
        "|entry|", (_regular,),
        (_det, _Ro), lambda R: (R.det(), _entries(special.inverse, R)), _inverse,
        rounding="Error of Ro_ij <= 2 u m_ji / |det R| + 6 u |Ro_ij| p / |det R|, m_ji the sum of "
        "the |terms| of the cofactor, or 2^-80 m^2 (double 2^-700 m^2) if that is more; barring "
        "over- and underflow of Ro_ij itself."),
    _op("mat3x3_normalize", f"self = {_GRAM_SCHMIDT}", (_own_near,), (_own_near,),
        lambda R: _entries(special.orthonormal_rows, R), _orthonormal_rows, rounding=_ROWS),
    _op("mat3x3_normalized", f"Ro = {_GRAM_SCHMIDT}", (_near,), (_Ro,),
        lambda R: _entries(special.orthonormal_rows, R), _orthonormal_rows, rounding=_ROWS),
    _op("mat3x3_setFromAxisDC", "R = cos θ I + sin θ a~ + (1 - cos θ) a a^T, a = axis of length 1 "
        "(else R is not a rotation), dc = (sin θ, cos θ)", (_axis, _dc), (_R,), _about,
        _bound_about, order=("R", "axis", "dc")),
    *euler.OPERATIONS, *eigen.OPERATIONS, *nearest.OPERATIONS,
)

FAMILY = Family(_NAME, 30, __doc__, OPERATIONS, includes=("vec3",))
