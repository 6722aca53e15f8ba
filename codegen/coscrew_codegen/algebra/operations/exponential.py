"""Exponentials and logarithms of rotations and displacements, their Jacobians, interpolation.

A rotation vector v = θ a rotates by the angle θ about the unit axis a; exp s of a screw s = (v; ω)
is the displacement by a motion with the twist s for unit time.
"""

from functools import partial

import sympy as sp

from coscrew_codegen.algebra.matrices import (
    I3,
    O3,
    ang,
    blocks,
    compose,
    displacement,
    lin,
    rotation,
    skew,
    stack,
    translation,
)
from coscrew_codegen.algebra.operations.family import Family
from coscrew_codegen.algebra.operations.formulas import special
from coscrew_codegen.algebra.operations.formulas.half_angle import HalfAngle, angle_of
from coscrew_codegen.algebra.operations.formulas.norm import Let, prefixed, unnamed
from coscrew_codegen.algebra.operations.formulas.rotation import (
    quaternion_of,
    rodrigues,
    rotation_vector,
    upper,
)
from coscrew_codegen.algebra.operations.formulas.series import Angle
from coscrew_codegen.algebra.operations.formulas.special import b, g, vector
from coscrew_codegen.algebra.operations.operation import WITHIN, Normwise, Operation
from coscrew_codegen.algebra.operations.quaternion import PRINCIPAL, axis_and_angle, axis_angle
from coscrew_codegen.program.values.quantity import (
    ANGLE,
    FRACTION,
    HALF_TURN,
    MAT3X3,
    MAT6X6,
    NEAR_ROTATION,
    ROTATION,
    SCALAR,
    SCREW,
    SE3,
    TURN,
    UNIT_VECTOR,
    VEC3,
    Argument,
)

_NAME = "exponential"

_v, _small_v, _vo = Argument("v", VEC3, TURN), Argument("v", VEC3, HALF_TURN), Argument("vo", VEC3)
_axis, _axis_out = Argument("axis", VEC3, UNIT_VECTOR), Argument("axis", VEC3)
_R, _Ro = Argument("R", MAT3X3, ROTATION), Argument("Ro", MAT3X3)
_near, _self = (Argument(name, MAT3X3, NEAR_ROTATION) for name in ("R", "self"))
_D, _D1, _D2 = (Argument(name, SE3) for name in ("D", "D1", "D2"))
_s, _small_s = Argument("s", SCREW, TURN), Argument("s", SCREW, HALF_TURN)
_so = Argument("so", SCREW)
_Do, _M = Argument("Do", SE3), Argument("M", MAT6X6)
_angle, _k = Argument("angle", SCALAR, ANGLE), Argument("k", SCALAR, FRACTION)
_op = partial(Operation, _NAME, accurate=WITHIN)


# Rotations.  `sign` is 1 for left Jacobians, -1 for right ones: J_r(v) = J_l(-v).


def _matrix(v: sp.Matrix, alpha: sp.Expr, beta: sp.Expr) -> sp.Matrix:
    return I3 + alpha * skew(v) + beta * skew(v)**2


def _exp(v: sp.Matrix) -> sp.Matrix:
    return _matrix(v, g(1, v.dot(v)), g(2, v.dot(v)))


def _bound_exp(let: Let, v: sp.Matrix) -> sp.Matrix:
    if let.fine:
        angle = HalfAngle.of_any(let, let("halved", v / 2))
        return rodrigues(let, let("turning", angle.k * v), angle.c, sp.Rational(1, 2))
    across, g1, g2 = angle_of(let, v).g(0, 1, 2)
    return rodrigues(let, v, g1, g2, across)


def _log(let: Let, R: sp.Matrix) -> tuple[sp.Matrix, Angle | HalfAngle]:
    return rotation_vector(let, upper(let, quaternion_of(let, R)))


def _log_of(R: sp.Matrix) -> sp.Matrix:
    return vector(special.quaternion_log, 3, *vector(special.quaternion_of, 4, *R))


def _jacobian(sign: int, v: sp.Matrix) -> sp.Matrix:
    return _matrix(v, sign * g(2, v.dot(v)), g(3, v.dot(v)))


def _bound_jacobian(sign: int, let: Let, v: sp.Matrix) -> sp.Matrix:
    g1, g2, g3 = angle_of(let, v).g(1, 2, 3)
    return rodrigues(let, v, sign * g2, g3, g1)


def _jacobian_inverse(sign: int, v: sp.Matrix) -> sp.Matrix:
    return _matrix(v, -sign * sp.Rational(1, 2), b(v.dot(v)))


def _bound_jacobian_inverse(sign: int, let: Let, v: sp.Matrix) -> sp.Matrix:
    return rodrigues(let, v, -sign * sp.Rational(1, 2), *angle_of(let, v).b())


def _bound_turn(let: Let, axis: sp.Matrix, angle: sp.Expr) -> sp.Matrix:
    half_sine, cosine = let("h", sp.sin(let("half", angle / 2))), let("cosine", sp.cos(angle))
    versine = let("versine", sp.Piecewise((1 - cosine, cosine < 0), (2 * half_sine**2, True)))
    return rodrigues(let, axis, let("sine", sp.sin(angle)), versine)


def _newton(let: Let, R: sp.Matrix) -> sp.Matrix:
    """R + R (I - R^T R) / 2."""
    defect = I3 - R.T * R
    upper_half = ((0, 0), (1, 1), (2, 2), (0, 1), (0, 2), (1, 2))
    d = let("defect", sp.Matrix([defect[i, j] for i, j in upper_half]))
    x, y, z, xy, xz, yz = let("correction", d / 2)
    return R + R * sp.Matrix([[x, xy, xz], [xy, y, yz], [xz, yz, z]])


_NEWTON = "R + R (I - R^T R)/2, closer to a rotation: a defect d of R becomes 3/4 d^2"

_ROTATIONS = (
    _op("SO3_exp", "R = exp v~ = I + sin θ/θ v~ + (1 - cos θ)/θ^2 v~^2, θ = |v|", (_v,), (_R,),
        _exp, _bound_exp, (Normwise("R", 6, per_angle=200),)),
    _op("SO3_log", "vo with exp vo~ = R, |vo| <= π; if R is not quite a rotation, its defect "
        "carries over to vo", (_R,), (_vo,), _log_of,
        lambda let, R: _log(let, R)[0], (Normwise("vo", 7),)),
    *(_op(f"SO3_{side}Jacobian", f"R = J_{side[0]}(v) = I {'+-'[sign < 0]} (1 - cos θ)/θ^2 v~ + "
          "(θ - sin θ)/θ^3 v~^2, θ = |v|", (_v,), (_R,), partial(_jacobian, sign),
          partial(_bound_jacobian, sign), (Normwise("R", 7, per_angle=200),))
      for side, sign in (("left", 1), ("right", -1))),
    *(_op(f"SO3_{side}JacobianInverse", f"R = J_{side[0]}(v)^-1 = I {'-+'[sign < 0]} v~/2 + "
          "(1 - θ/2 cot θ/2)/θ^2 v~^2, θ = |v|; singular at multiples of 2π except 0",
          (_small_v,), (_R,), partial(_jacobian_inverse, sign),
          partial(_bound_jacobian_inverse, sign), (Normwise("R", 6),))
      for side, sign in (("left", 1), ("right", -1))),
    Operation("mat3x3", "mat3x3_from_axis_angle",
              "R = I + sin(angle) axis~ + (1 - cos(angle)) axis~^2, for an axis of length 1; "
              "otherwise R is not a rotation",
              (_axis, _angle), (_R,), lambda a, t: _matrix(a, sp.sin(t), 1 - sp.cos(t)),
              _bound_turn, (Normwise("R", 9),), accurate=WITHIN),
    Operation("mat3x3", "axis_angle_from_mat3x3",
              f"angle and axis of the rotation R; {PRINCIPAL}", (_R,),
              (_angle, _axis_out), lambda R: axis_and_angle(_log_of(R)),
              lambda let, R: axis_angle(let, quaternion_of(let, R)),
              (Normwise("angle", 8), Normwise("axis", 5)), accurate=WITHIN),
    _op("mat3x3_orthonormalize", f"self = {_NEWTON}", (_self,), (_self,),
        lambda R: _newton(unnamed, R), _newton),
    _op("mat3x3_orthonormalized", f"Ro = {_NEWTON}", (_near,), (_Ro,),
        lambda R: _newton(unnamed, R), _newton),
)


# displacements


def _move(s: sp.Matrix) -> sp.Matrix:
    return displacement(_exp(ang(s)), _jacobian(1, ang(s)) * lin(s))


def _bound_move(let: Let, s: sp.Matrix) -> sp.Matrix:
    v, w = lin(s), ang(s)
    across, g1, g2, g3 = angle_of(let, w).g(0, 1, 2, 3)
    turned = let("turned", g2 * let("u", w.cross(v)))
    along = let("along", let("pitch", g3 * let("wv", w.dot(v))) * w)
    return displacement(rodrigues(let, w, g1, g2, across),
                        g1 * v + let("across_axis", turned + along))


def _screw_of(D: sp.Matrix) -> sp.Matrix:
    w = _log_of(rotation(D))
    return stack(_jacobian_inverse(1, w) * translation(D), w)


def _bound_screw_of(let: Let, D: sp.Matrix) -> sp.Matrix:
    t = translation(D)
    w, angle = _log(let, rotation(D))
    b, across = angle.b()
    along = let("along", let("pitch", b * let("wt", w.dot(t))) * w)
    turned = let("turned", let("u", w.cross(t)) / 2)
    return stack(across * t + let("across_axis", along - turned), w)


def _rate(let: Let, s: sp.Matrix, alpha: sp.Expr, alpha_rate: sp.Expr, beta: sp.Expr,
          beta_rate: sp.Expr) -> sp.Matrix:
    """The rate of I + α ω~ + β ω~² for ω' = v, with d = v·ω and the rates α' d of α, β' d of β:
    α v~ + α' d ω~ + β (v ω^T + ω v^T - 2 d I) + β' d ω~².

    Since ad(s) is ω~ + ε v~ with ε² = 0, it is the upper right block of the same series in ad(s).
    """
    v, w = lin(s), ang(s)
    d = let("vw", v.dot(w))
    turn, bend = let("turn", alpha_rate * d), let("bend", -beta_rate * d)
    q, y, z = let("q", alpha * v + turn * w), let("beta_v", beta * v), let("bend_w", bend * w)
    xy, xz, yz = let("symmetric", sp.Matrix([y[i] * w[j] + y[j] * w[i] - z[i] * w[j]
                                             for i, j in ((0, 1), (0, 2), (1, 2))]))
    x, y, z = let("diagonal", sp.Matrix([z[i] * w[i] + z[j] * w[j] - 2 * (y[i] * w[i] + y[j] * w[j])
                                         for i, j in ((1, 2), (0, 2), (0, 1))]))
    return sp.Matrix([[x, xy, xz], [xy, y, yz], [xz, yz, z]]) + skew(q)


def _motion_jacobian(sign: int, s: sp.Matrix) -> sp.Matrix:
    J = _jacobian(sign, ang(s))
    return blocks(J, _coupling(sign * s), O3, J)


def _coupling(s: sp.Matrix) -> sp.Matrix:
    """The upper right block of J_l(s): the rate of J_l(ω) for ω' = v."""
    g2, g3, g4, g5 = (g(k, ang(s).dot(ang(s))) for k in (2, 3, 4, 5))
    return _rate(unnamed, s, g2, 2 * g4 - g3, g3, 3 * g5 - g4)


def _bound_motion_jacobian(sign: int, let: Let, s: sp.Matrix) -> sp.Matrix:
    angle = angle_of(let, ang(s))
    g1, g2, g3 = angle.g(1, 2, 3)
    rate2, rate3 = angle.g_rates(g1, g2, g3)
    J = let("J", rodrigues(let, ang(s), sign * g2, g3, g1))
    return blocks(J, _rate(prefixed(let, "rate"), sign * s, g2, rate2, g3, rate3), O3, J)


def _motion_jacobian_inverse(sign: int, s: sp.Matrix) -> sp.Matrix:
    J = _jacobian_inverse(sign, ang(s))
    return blocks(J, -J * _coupling(sign * s) * J, O3, J)


def _bound_motion_jacobian_inverse(sign: int, let: Let, s: sp.Matrix) -> sp.Matrix:
    """Its upper right block is the rate of J^-1, which needs no products of blocks as
    -J^-1 Q J^-1 does."""
    angle, half = angle_of(let, ang(s)), sp.Rational(1, 2)
    b_, across = angle.b()
    J = let("J", rodrigues(let, ang(s), -sign * half, b_, across))
    rate = _rate(prefixed(let, "rate"), sign * s, -half, sp.Integer(0), b_, angle.b_rate())
    return blocks(J, rate, O3, J)


def _interpolated(D1: sp.Matrix, D2: sp.Matrix, k: sp.Expr) -> sp.Matrix:
    return sp.Matrix(3, 4, lambda i, j: special.interpolated(i, j, *D1, *D2, k))


def _bound_interpolated(let: Let, D1: sp.Matrix, D2: sp.Matrix, k: sp.Expr) -> sp.Matrix:
    R1 = rotation(D1)
    apart = let("apart", translation(D2) - translation(D1))
    between = let("between", displacement(R1.T * rotation(D2), R1.T * apart))
    s = let("screw", k * let("whole", _bound_screw_of(prefixed(let, "log"), between)))
    return compose(D1, let("step", _bound_move(prefixed(let, "exp"), s)))


FAR = ("2e306", "5e36")  # double, single
"""1/64 of the largest number; 1/17 would do.  Interpolation: the translation between both is up to
2 |t|, its screw π/2 times that, and the moment about the axis up to π times that."""
_FAR = f"is above {FAR[0]}, in single precision {FAR[1]}"
_OF_VELOCITY = f"Intermediate sums may overflow where |v| {_FAR}."

_DISPLACEMENTS = (
    _op("SE3_exp", "D = exp s = [exp ω~ | J_l(ω) v]", (_s,), (_D,), _move, _bound_move,
        (Normwise("R", 6, per_angle=200), Normwise("t", 14, ("s.lin",), 200)),
        rounding=f"Intermediate sums may overflow where |v|, or |ω| |v|, {_FAR}."),
    _op("SE3_log", "so with exp so = D, |ω| <= π: (J_l(ω)^-1 t; ω), ω = log R", (_D,), (_so,),
        _screw_of, _bound_screw_of, (Normwise("lin", 18), Normwise("ang", 8)),
        rounding=f"Intermediate sums may overflow where |t| {_FAR}."),
    *(_op(f"SE3_{side}Jacobian", f"M = J_{side[0]}(s) = Σ ({'-' * (sign < 0)}[ad](s))^k / (k+1)!",
          (_small_s,), (_M,), partial(_motion_jacobian, sign),
          partial(_bound_motion_jacobian, sign),
          (Normwise("M", 20),), rounding=_OF_VELOCITY)
      for side, sign in (("left", 1), ("right", -1))),
    *(_op(f"SE3_{side}JacobianInverse", f"M = J_{side[0]}(s)^-1; singular where |ω| is a multiple "
          "of 2π except 0", (_small_s,), (_M,), partial(_motion_jacobian_inverse, sign),
          partial(_bound_motion_jacobian_inverse, sign), (Normwise("M", 14),),
          rounding=_OF_VELOCITY)
      for side, sign in (("left", 1), ("right", -1))),
    _op("SE3_interpolated", "Do = D1 exp(k log(D1^-1 D2)), the screw motion from D1 at k = 0 to D2 "
        "at k = 1", (_D1, _D2, _k), (_Do,), _interpolated, _bound_interpolated,
        (Normwise("R", 22), Normwise("t", 60, ("D1.t", "D2.t"))),
        rounding=f"Intermediate sums may overflow where |t| of D1 or D2 {_FAR}."),
)

OPERATIONS = (*_ROTATIONS, *_DISPLACEMENTS)

FAMILY = Family(_NAME, 120, __doc__, OPERATIONS, includes=("quaternion", "SE3", "screw"))
