"""4×4 matrices: displacements [[R, t], [0, 1]] and other maps of homogeneous coordinates."""

from functools import partial

import sympy as sp

from coscrew_codegen.algebra.matrices import displacement, homogeneous
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

_NAME = "mat4x4"

_M, _self = Argument("M", MAT4X4, ANY), Argument("self", MAT4X4, ANY)
_D, _R, _t = Argument("D", SE3), Argument("R", MAT3X3, ROTATION), Argument("t", VEC3, ANY)
_op = partial(Operation, _NAME)

OPERATIONS = (
    _op("mat4x4_fromSE3", "M = [[R, t], [0, 1]] of D = [R | t]", (_D,), (_M,), homogeneous,
        by_value=True),
    _op("mat4x4_fromRt", "M = [[R, t], [0, 1]]", (_R, _t), (_M,),
        lambda R, t: homogeneous(displacement(R, t)), by_value=True),
    _op("mat4x4_toSE3", "D = [R | t], the first three rows of M", (_M,), (_D,),
        lambda M: M[:3, :]),
    _op("mat4x4_setIdentity", "self = I", (_self,), (_self,), lambda M: sp.eye(4)),
    _op("mat4x4_getTranslation", "t, the first three entries of the last column of M", (_M,),
        (_t,), lambda M: M[:3, 3]),
)

FAMILY = Family(_NAME, 50, __doc__, OPERATIONS, includes=("SE3", "vec4"))
