"""Vectors of four components: three dimensions and a homogeneous coordinate."""

from functools import partial

import sympy as sp

from coscrew_codegen.algebra.operations.family import Family
from coscrew_codegen.algebra.operations.formulas.linear_formulas import linear_space
from coscrew_codegen.algebra.operations.formulas.norm import (
    Let,
    divided,
    l2,
    nonzero,
    safe_norm,
    safe_normalized,
)
from coscrew_codegen.algebra.operations.operation import Operation
from coscrew_codegen.program.values.quantity import ANY, SCALAR, VEC4, Argument

_NAME = "vec4"

_v, _self, _vo = (Argument(name, VEC4) for name in ("v", "self", "vo"))
_v1, _v2 = Argument("v1", VEC4), Argument("v2", VEC4)
_k, _norm = Argument("k", SCALAR, ANY), Argument("norm", SCALAR)
_op = partial(Operation, _NAME)


def _normalized(v: sp.Matrix) -> sp.Matrix:
    return divided(v, nonzero(l2(v)))


def _bound_normalized(let: Let, v: sp.Matrix) -> sp.Matrix:
    return safe_normalized(let, v, v)


OPERATIONS = (
    *(op for op in linear_space(_NAME, VEC4, "v") if op.name.startswith(_NAME)),
    _op("vec4_scaled", "vo = k v", (_v, _k), (_vo,), lambda v, k: k * v),
    _op("vec4_swap", "v1, v2 = v2, v1", (_v1, _v2), (_v1, _v2), lambda v1, v2: (v2, v1)),
    _op("vec4_l2norm", "|v| = sqrt(v·v), all four components", (_v,), (_norm,), l2, safe_norm),
    _op("vec4_normalize", "self = self / |self|; the zero vector stays zero", (_self,), (_self,),
        _normalized, _bound_normalized),
    _op("vec4_normalized", "vo = v / |v|; the zero vector stays zero", (_v,), (_vo,),
        _normalized, _bound_normalized),
)

FAMILY = Family(_NAME, 20, __doc__, OPERATIONS)
