"""Quaternions q = (v; w), the scalar last: products, rotations, conversions, interpolation.

Unit quaternions are rotations; q and -q are the same rotation.
"""

from functools import partial

import sympy as sp

from coscrew_codegen.algebra.operations.family import Family
from coscrew_codegen.algebra.operations.formulas import special
from coscrew_codegen.algebra.operations.formulas.linear_formulas import linear_space
from coscrew_codegen.algebra.operations.formulas.norm import (
    Let,
    divided,
    inverse_power,
    l2,
    moderate,
    nonzero,
    power_of_two,
    prefixed,
    safe_norm,
    safe_normalized,
    unnamed,
)
from coscrew_codegen.algebra.operations.formulas.quaternion_products import PRODUCTS
from coscrew_codegen.algebra.operations.formulas.rotation import (
    SmoothAngle,
    conjugate,
    half_angle,
    quaternion,
    quaternion_of,
    quaternion_product,
    rotation_vector,
    scalar_part,
    upper,
    vector_part,
    versor,
)
from coscrew_codegen.algebra.operations.formulas.special import vector
from coscrew_codegen.algebra.operations.operation import WITHIN, Normwise, Operation, scaled
from coscrew_codegen.program.values.quantity import (
    ANGLE,
    ANY,
    FRACTION,
    MAT3X3,
    NONZERO,
    ORDINARY,
    QUATERNION,
    ROTATION,
    SCALAR,
    TURN,
    UNIT_VECTOR,
    VEC3,
    Argument,
)

_NAME = "quaternion"

_any, _self = Argument("q", QUATERNION, ANY), Argument("self", QUATERNION, ANY)
_q, _qo = Argument("q", QUATERNION), Argument("qo", QUATERNION)
_nonzero = Argument("q", QUATERNION, NONZERO)
_unit1, _unit2 = Argument("q1", QUATERNION), Argument("q2", QUATERNION)
_v, _vo, _turn = Argument("v", VEC3, ANY), Argument("vo", VEC3), Argument("v", VEC3, TURN)
_axis, _axis_out = Argument("axis", VEC3, UNIT_VECTOR), Argument("axis", VEC3)
_angle, _norm = Argument("angle", SCALAR, ANGLE), Argument("norm", SCALAR)
_defect = Argument("defect", SCALAR)
_k = Argument("k", SCALAR, FRACTION)
_R, _R_out = Argument("R", MAT3X3, ROTATION), Argument("R", MAT3X3)
_ordinary = Argument("q", QUATERNION, ORDINARY)

PRINCIPAL = "0 <= angle <= π; the axis is (1, 0, 0) if the angle is 0"
_op = partial(Operation, _NAME, accurate=WITHIN)  # polynomials have better bounds


def _normalized(q: sp.Matrix) -> sp.Matrix:
    return divided(q, nonzero(l2(q)))


def _bound_normalized(let: Let, q: sp.Matrix) -> sp.Matrix:
    return safe_normalized(let, q, q)


def _nearest_unit(q: sp.Matrix) -> sp.Matrix:
    n = l2(q)
    return divided(q, n).applyfunc(lambda x: sp.Piecewise((sp.nan, sp.Eq(n, 0)), (x, True)))


def _bound_nearest_unit(let: Let, q: sp.Matrix) -> sp.Matrix:
    """Scaled by a power of two, which changes no direction."""
    y = moderate(let, "s", q)
    n = let("n", l2(y))
    unit = let("unit", divided(y, let("divisor", nonzero(n))))
    return unit.applyfunc(lambda x: sp.Piecewise((sp.nan, sp.Eq(n, 0)), (x, True)))


def _rotated(let: Let, q: sp.Matrix, v: sp.Matrix) -> sp.Matrix:
    """v + 2 w u × v + 2 u × (u × v)."""
    u, w = vector_part(q), scalar_part(q)
    t = let("t", 2 * let("c", u.cross(v)))
    return v + let("turn", w * t + u.cross(t))


_PRODUCTS = (
    _op("quaternion_setIdentity", "self = (0; 1)", (_self,), (_self,),
        lambda q: quaternion(sp.zeros(3, 1), 1)),
    _op("quaternion_conjugated", "qo = (-v; w), the inverse of q if |q| = 1", (_q,), (_qo,),
        conjugate),
    _op("quaternion_norm", "|q| = sqrt(v·v + w^2)", (_any,), (_norm,), l2, safe_norm),
    _op("quaternion_normalize", "self = self / |self|; zero stays zero", (_self,), (_self,),
        _normalized, _bound_normalized),
    _op("quaternion_normalized", "qo = q / |q|; zero stays zero", (_any,), (_qo,), _normalized,
        _bound_normalized),
    _op("quaternion_unit_defect", "|q| - 1: 0 for a unit quaternion, negative for a shorter one",
        (_any,), (_defect,), lambda q: l2(q) - 1,
        lambda let, q: let("length", safe_norm(let, q)) - 1),
    _op("quaternion_nearest_unit", "qo = q / |q|, the unit quaternion nearest to q; NaN for zero, "
        "which has none", (_nonzero,), (_qo,), _nearest_unit, _bound_nearest_unit),
    _op("rotate_qv", "vo = R(q) v, |q| = 1", (_q, _v), (_vo,),
        lambda q, v: _rotated(unnamed, q, v), _rotated),
    _op("rotate_qconjv", "vo = R(q)^T v, |q| = 1", (_q, _v), (_vo,),
        lambda q, v: _rotated(unnamed, conjugate(q), v),
        lambda let, q, v: _rotated(let, conjugate(q), v)),
)


def _matrix_of(let: Let, q: sp.Matrix) -> sp.Matrix:
    """The diagonal's entries and q·q are computed from the same squares a, b, c, d, so that their
    rounding errors cancel where an entry is near 1."""
    x, y, z, w = q
    a, b, c, d = let("squares", sp.Matrix([w * w, x * x, y * y, z * z]))
    pairs = let("pairs", sp.Matrix([a + b, c + d, a + c, b + d, a + d, b + c]))
    factor = let("factor", 1 / let("square", pairs[0] + pairs[1]))
    diagonal = [factor * let(f"d{i}", pairs[2 * i] - pairs[2 * i + 1]) for i in range(3)]
    twice = let("twice", 2 * factor)
    xy, xz, yz, yx, zx, zy = twice * let("m", sp.Matrix([
        x * y - w * z, x * z + w * y, y * z - w * x, x * y + w * z, x * z - w * y, y * z + w * x]))
    return sp.Matrix([[diagonal[0], xy, xz], [yx, diagonal[1], yz], [zx, zy, diagonal[2]]])


def _of_matrix(let: Let, R: sp.Matrix) -> sp.Matrix:
    q = upper(let, quaternion_of(let, R))
    return divided(q, let("length", l2(q)))


def _of_axis_angle(let: Let, axis: sp.Matrix, angle: sp.Expr) -> sp.Matrix:
    half = let("half", angle / 2)
    return quaternion(let("sine", sp.sin(half)) * axis, sp.cos(half))


def axis_angle(let: Let, q: sp.Matrix, reduced: bool = False) -> tuple[sp.Expr, sp.Matrix]:
    """(2 atan2(|v|, w), v / |v|) of any positive multiple of a quaternion.

    v and |v| are scaled by a power of two before the division: a subnormal |v| has too few digits
    for a direction."""
    q = upper(let, q)
    of_v, w = prefixed(let, "v"), scalar_part(q)
    s = power_of_two(of_v, "s", tuple(vector_part(q)), reduced)
    v = of_v("y", vector_part(q).applyfunc(lambda component: scaled(component, s)))
    n = of_v("n", l2(v))
    half = let("half", sp.atan2(let("n", scaled(n, inverse_power(of_v, "r", s, reduced))), w))
    x, y, z = let("unit", divided(v, let("divisor", nonzero(n))))
    return 2 * half, sp.Matrix([sp.Piecewise((1, sp.Eq(n, 0)), (x, True)), y, z])


def axis_and_angle(v: sp.Matrix) -> tuple[sp.Expr, sp.Matrix]:
    """(|v|, v / |v|) of a rotation vector; (0, (1, 0, 0)) for zero."""
    angle, still = l2(v), sp.Eq(l2(v), 0)
    return angle, sp.Matrix([sp.Piecewise((int(i == 0), still), (x / angle, True))
                             for i, x in enumerate(v)])


def _exp(v: sp.Matrix) -> sp.Matrix:
    x = v.dot(v) / 4
    return quaternion(special.g(1, x) * v / 2, special.g(0, x))


def _log(let: Let, q: sp.Matrix) -> sp.Matrix:
    return rotation_vector(let, upper(let, moderate(let, "s", q)), reduced=True)[0]


def _slerp(let: Let, q1: sp.Matrix, q2: sp.Matrix, k: sp.Expr) -> sp.Matrix:
    between = upper(let, let("between", quaternion_product(conjugate(q1), q2)))
    if let.smooth:
        rate = SmoothAngle.of(let, between).rate
    else:
        half, _, divisor = half_angle(let, between)
        rate = let("rate", half / divisor)
    step = let("step", rate * let("kv", k * vector_part(between)))
    return quaternion_product(q1, let("power", versor(prefixed(let, "exp"), step)))


_CONVERSIONS = (
    _op("mat3x3_from_quaternion", "R = I + 2 (w v~ + v~^2) / q·q, for any nonzero q whose square "
        "neither over- nor underflows", (_ordinary,), (_R_out,),
        lambda q: _matrix_of(unnamed, q), _matrix_of, (Normwise("R", 8),)),
    _op("quaternion_from_mat3x3", "qo with R(qo) = R and w >= 0; if R is not quite a rotation, its "
        "defect carries over to qo", (_R,), (_qo,),
        lambda R: vector(special.quaternion_of, 4, *R), _of_matrix, (Normwise("qo", 6),)),
    _op("quaternion_from_axis_angle", "qo = (axis sin angle/2; cos angle/2); axis of length 1: "
        "with another |qo| is not 1, and its rotation is by another angle",
        (_axis, _angle), (_qo,), lambda a, angle: _of_axis_angle(unnamed, a, angle),
        _of_axis_angle, (Normwise("qo", 3),)),
    _op("axis_angle_from_quaternion", f"angle = 2 atan2(|v|, |w|), axis = ±v / |v|; {PRINCIPAL}; "
        "any multiple of a quaternion", (_nonzero,), (_angle, _axis_out),
        lambda q: axis_and_angle(vector(special.quaternion_log, 3, *q)),
        lambda let, q: axis_angle(let, moderate(let, "s", q), reduced=True),
        (Normwise("angle", 6), Normwise("axis", 4))),
    _op("quaternion_exp", "qo = exp (v/2; 0) = (v/θ sin θ/2; cos θ/2), θ = |v|: turns by the "
        "rotation vector v", (_turn,), (_qo,), _exp,
        lambda let, v: versor(let, let("h", v / 2)), (Normwise("qo", 7, per_angle=200),)),
    _op("quaternion_log", "vo = θ v/|v|, θ = 2 atan2(|v|, |w|) <= π: the rotation vector of q, or "
        "of any multiple of it", (_nonzero,), (_vo,),
        lambda q: vector(special.quaternion_log, 3, *q), _log, (Normwise("vo", 6),)),
    _op("quaternion_interpolated", "qo = q1 (q1* q2)^k along the shorter arc: q1 at k = 0, "
        "±q2 at k = 1; |q1| = |q2| = 1", (_unit1, _unit2, _k), (_qo,),
        lambda p, q, k: vector(special.slerp, 4, *p, *q, k),
        _slerp, (Normwise("qo", 16),)),
)

OPERATIONS = (*(op for op in linear_space(_NAME, QUATERNION, "q")
                if op.name in ("quaternion_copy", "quaternion_scale", "axpy_qq")),
              *_PRODUCTS, *PRODUCTS, *_CONVERSIONS)

FAMILY = Family(_NAME, 110, __doc__, OPERATIONS, includes=("mat3x3",))
