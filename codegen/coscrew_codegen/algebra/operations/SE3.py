"""Displacements D = [R | t]."""

from functools import partial

import sympy as sp

from coscrew_codegen.algebra.matrices import (
    I3,
    displacement,
    homogeneous,
    inverse,
    rotation,
    translation,
)
from coscrew_codegen.algebra.operations.family import Family
from coscrew_codegen.algebra.operations.operation import Operation
from coscrew_codegen.program.values.quantity import (
    ANY,
    MAT3X3,
    MAT4X4,
    ROTATION,
    SE3,
    VEC3,
    Argument,
)

_NAME = "SE3"

_D, _self, _Do = (Argument(name, SE3) for name in ("D", "self", "Do"))
_R, _t = Argument("R", MAT3X3, ROTATION), Argument("t", VEC3, ANY)
_M = Argument("M", MAT4X4)
_op = partial(Operation, _NAME)

OPERATIONS = (
    _op("SE3_fromRt", "D = [R | t]", (_R, _t), (_D,), displacement, by_value=True),
    _op("SE3_copy", "Do = D", (_D,), (_Do,), lambda D: D),
    _op("SE3_setIdentity", "self = [I | 0]", (_self,), (_self,),
        lambda D: displacement(I3, sp.zeros(3, 1))),
    _op("SE3_getTranslation", "t of D = [R | t]", (_D,), (_t,), translation),
    _op("SE3_getRotation", "R of D = [R | t]", (_D,), (_R,), rotation),
    _op("SE3_invert", "self = self^-1 = [R^T | -R^T t]", (_self,), (_self,), inverse),
    _op("SE3_toMat4x4", "M = [[R, t], [0, 1]] of D = [R | t]", (_D,), (_M,), homogeneous),
    _op("SE3_inverted", "Do = D^-1 = [R^T | -R^T t]", (_D,), (_Do,), inverse),
)

FAMILY = Family(_NAME, 40, __doc__, OPERATIONS, includes=("mat3x3",))
