"""Products between rotations, displacements and vectors.

Names: `d` displacement, `dr` rotation, `v` vector; `rx ry rz` a rotation about an axis given by
dc = (sin θ, cos θ); `tx ty tz` a translation along an axis; `inv` after a factor inverts it (the
inverse of a vector is its negative).
"""

from functools import partial

import sympy as sp

from coscrew_codegen.algebra.matrices import (
    compose,
    displacement,
    inverse,
    rotation,
    rotation_about,
    shifted,
    translation,
    turned,
    unit,
)
from coscrew_codegen.algebra.operations.family import Family
from coscrew_codegen.algebra.operations.formulas.norm import Let
from coscrew_codegen.algebra.operations.operation import Operation
from coscrew_codegen.program.values.quantity import (
    ANY,
    DC,
    MAT3X3,
    ROTATION,
    SCALAR,
    SE3,
    VEC3,
    Argument,
)

_NAME = "matrix"

_R, _R1, _R2, _Ro = (Argument(name, MAT3X3, ROTATION) for name in ("R", "R1", "R2", "Ro"))
_D, _D1, _D2, _Do = (Argument(name, SE3) for name in ("D", "D1", "D2", "Do"))
_v, _t, _vo = (Argument(name, VEC3, ANY) for name in ("v", "t", "vo"))
_k, _dc = Argument("k", SCALAR, ANY), Argument("dc", DC)
_op = partial(Operation, _NAME)

_VECTORS = (
    _op("product_drv", "vo = R v", (_R, _v), (_vo,), lambda R, v: R * v),
    _op("product_drvinv", "vo = R (-v)", (_R, _v), (_vo,), lambda R, v: -R * v),
    _op("product_drinvv", "vo = R^T v", (_R, _v), (_vo,), lambda R, v: R.T * v),
    _op("product_drinvvinv", "vo = R^T (-v)", (_R, _v), (_vo,), lambda R, v: -R.T * v),
    _op("product_dv", "vo = R v + t", (_D, _v), (_vo,),
        lambda D, v: rotation(D) * v + translation(D)),
    _op("product_dinvv", "vo = R^T (v - t)", (_D, _v), (_vo,),
        lambda D, v: rotation(D).T * (v - translation(D)),
        lambda let, D, v: rotation(D).T * let("p", v - translation(D))),
)

_ROTATIONS = (
    _op("product_drdr", "Ro = R1 R2", (_R1, _R2), (_Ro,), lambda R1, R2: R1 * R2),
    _op("product_drdrinv", "Ro = R1 R2^T", (_R1, _R2), (_Ro,), lambda R1, R2: R1 * R2.T),
    _op("product_drinvdr", "Ro = R1^T R2", (_R1, _R2), (_Ro,), lambda R1, R2: R1.T * R2),
)


def _d_dinv(let: Let, D1: sp.Matrix, D2: sp.Matrix) -> sp.Matrix:
    R = let("R", rotation(D1) * rotation(D2).T)
    return displacement(R, translation(D1) - R * translation(D2))


def _dinv_d(let: Let, D1: sp.Matrix, D2: sp.Matrix) -> sp.Matrix:
    Rt = rotation(D1).T
    return displacement(Rt * rotation(D2), Rt * let("p", translation(D2) - translation(D1)))


_DISPLACEMENTS = (
    _op("product_dd", "Do = D1 D2 = [R1 R2 | R1 t2 + t1]", (_D1, _D2), (_Do,), compose),
    _op("product_ddinv", "Do = D1 D2^-1 = [R | t1 - R t2], R = R1 R2^T", (_D1, _D2), (_Do,),
        lambda D1, D2: compose(D1, inverse(D2)), _d_dinv),
    _op("product_dinvd", "Do = D1^-1 D2 = [R1^T R2 | R1^T (t2 - t1)]", (_D1, _D2), (_Do,),
        lambda D1, D2: compose(inverse(D1), D2), _dinv_d),
    _op("product_ddr", "Do = D [R | 0]", (_D, _R), (_Do,), lambda D, R: compose(D, turned(R))),
    _op("product_ddrinv", "Do = D [R^T | 0]", (_D, _R), (_Do,),
        lambda D, R: compose(D, turned(R.T))),
    _op("product_ddt", "Do = D [I | t]", (_D, _t), (_Do,), lambda D, t: compose(D, shifted(t))),
    _op("product_ddtinv", "Do = D [I | -t]", (_D, _t), (_Do,),
        lambda D, t: compose(D, shifted(-t))),
    _op("product_dinvdt", "Do = D^-1 [I | t] = [R^T | R^T (t - t_D)]", (_D, _t), (_Do,),
        lambda D, t: compose(inverse(D), shifted(t)),
        lambda let, D, t: displacement(rotation(D).T,
                                       rotation(D).T * let("p", t - translation(D)))),
)


def _about_axis(axis: int, inverted: bool) -> tuple[Operation, ...]:
    """Products with a rotation about, or a translation along, one axis."""
    letter, suffix, sign = "xyz"[axis], "inv" if inverted else "", -1 if inverted else 1
    turn, step = (f"R_{letter}(-θ)", "-k") if inverted else (f"R_{letter}(θ)", "k")

    def about(dc: sp.Matrix) -> sp.Matrix:
        return rotation_about(axis, sign * dc[0], dc[1])

    def along(k: sp.Expr) -> sp.Matrix:
        return sign * k * unit(axis)

    return (
        _op(f"product_drvt{letter}{suffix}", f"vo = R ({step} e_{letter})", (_R, _k), (_vo,),
            lambda R, k: R * along(k)),
        _op(f"product_drdr{letter}{suffix}", f"Ro = R {turn}, dc = (sin θ, cos θ)", (_R, _dc),
            (_Ro,), lambda R, dc: R * about(dc)),
        _op(f"product_ddr{letter}{suffix}", f"Do = D [{turn} | 0], dc = (sin θ, cos θ)",
            (_D, _dc), (_Do,), lambda D, dc: compose(D, turned(about(dc)))),
        _op(f"product_ddt{letter}{suffix}", f"Do = D [I | {step} e_{letter}]", (_D, _k), (_Do,),
            lambda D, k: compose(D, shifted(along(k)))),
    )


OPERATIONS = (*_VECTORS, *_ROTATIONS, *_DISPLACEMENTS,
              *(op for axis in range(3) for inv in (False, True) for op in _about_axis(axis, inv)))

FAMILY = Family(_NAME, 70, __doc__, OPERATIONS, includes=("SE3", "trig"))
