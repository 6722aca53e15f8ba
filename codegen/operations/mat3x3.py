"""3×3 matrices: rotations, and matrices in general."""

import sympy as sp

from coscrew_codegen.algebra import skew
from coscrew_codegen.operations.operation import Operation
from coscrew_codegen.quantity import MAT3X3, SCALAR, VEC3, Argument

FAMILY = "mat3x3"

_R, _self, _Ro = (Argument(name, MAT3X3) for name in ("R", "self", "Ro"))
_v = Argument("v", VEC3)
_x, _y, _z = (Argument(name, VEC3) for name in "xyz")
_det = Argument("det", SCALAR)


def _op(name, statement, inputs, outputs, formula, derivation=None, order=()):
    return Operation(name, FAMILY, statement, inputs, outputs, formula, derivation, order)


OPERATIONS = (
    _op("mat3x3_copy", "Ro = R", (_R,), (_Ro,), lambda R: R),
    _op("mat3x3_setIdentity", "self = I", (_self,), (_self,), lambda R: sp.eye(3)),
    _op("mat3x3_setFromVectors", "R = [x y z], the columns", (_x, _y, _z), (_R,),
        lambda x, y, z: sp.Matrix.hstack(x, y, z), order=("R", "x", "y", "z")),
    _op("skew", "Ro = v~, the matrix with v~ y = v × y", (_v,), (_Ro,), skew),
    _op("mat3x3_transpose", "self = self^T, the inverse of a rotation", (_self,), (_self,),
        lambda R: R.T),
    _op("mat3x3_transposed", "Ro = R^T, the inverse of a rotation", (_R,), (_Ro,), lambda R: R.T),
    _op("mat3x3_determinant", "det R", (_R,), (_det,), lambda R: R.det(),
        lambda let, R: R[:, 0].dot(let("n", R[:, 1].cross(R[:, 2])))),
)
