"""Vectors of three components."""

from functools import partial

import sympy as sp

from coscrew_codegen.algebra.matrices import unit
from coscrew_codegen.algebra.operations.family import Family
from coscrew_codegen.algebra.operations.formulas.linear_formulas import linear_space
from coscrew_codegen.algebra.operations.formulas.norm import (
    Let,
    divided,
    l2,
    moderate,
    nonzero,
    safe_norm,
    safe_normalized,
)
from coscrew_codegen.algebra.operations.operation import WITHIN, Operation
from coscrew_codegen.program.values.quantity import ANY, SCALAR, VEC3, Argument

_NAME = "vec3"

_v, _self, _vo = (Argument(name, VEC3, ANY) for name in ("v", "self", "vo"))
_v1, _v2 = Argument("v1", VEC3, ANY), Argument("v2", VEC3, ANY)
_k = Argument("k", SCALAR, ANY)
_norm, _dot, _angle = (Argument(name, SCALAR) for name in ("norm", "dot", "angle"))
_op = partial(Operation, _NAME)


def _normalized(let: Let, v: sp.Matrix) -> sp.Matrix:
    return safe_normalized(let, v, v)


def _angle_between(let: Let, a: sp.Matrix, b: sp.Matrix) -> sp.Expr:
    """The angle between both vectors, scaled by powers of two, which does not change it."""
    a, b = moderate(let, "s1", a), moderate(let, "s2", b)
    return sp.atan2(let("cross", safe_norm(let, let("c", a.cross(b)))), let("dot_", a.dot(b)))

_PRODUCTS = (
    _op("vec3_scaled", "vo = k v", (_v, _k), (_vo,), lambda v, k: k * v),
    _op("vec3_swap", "v1, v2 = v2, v1", (_v1, _v2), (_v1, _v2), lambda v1, v2: (v2, v1)),
    _op("vec3_l2norm", "|v| = sqrt(v·v)", (_v,), (_norm,), l2, safe_norm),
    _op("vec3_normalize", "self = self / |self|; the zero vector stays zero", (_self,), (_self,),
        lambda v: divided(v, nonzero(l2(v))), _normalized),
    _op("vec3_normalized", "vo = v / |v|; the zero vector stays zero", (_v,), (_vo,),
        lambda v: divided(v, nonzero(l2(v))), _normalized),
    _op("angle_vv", "angle = atan2(|v1 × v2|, v1·v2), in [0, π]", (_v1, _v2), (_angle,),
        lambda a, b: sp.atan2(l2(a.cross(b)), a.dot(b)), _angle_between, accurate=WITHIN),
    _op("dot_vv", "v1·v2", (_v1, _v2), (_dot,), lambda v1, v2: v1.dot(v2)),
    _op("product_avinv", "vo = k (-v)", (_k, _v), (_vo,), lambda k, v: -k * v),
    _op("product_ainvv", "vo = v / k", (_k, _v), (_vo,), lambda k, v: v / k),
    _op("cross_vv", "vo = v1 × v2", (_v1, _v2), (_vo,),
              lambda v1, v2: v1.cross(v2),
              remark="Exactly zero for v1 = v2, unless products overflow."),
    _op("cross_vvinv", "vo = v1 × (-v2)", (_v1, _v2), (_vo,), lambda v1, v2: v1.cross(-v2)),
)


def _shift(axis: int, sign: int) -> Operation:
    letter = "xyz"[axis]
    name = f"add_vv{letter}" + ("inv" if sign < 0 else "")
    statement = f"vo = v {'-' if sign < 0 else '+'} k e_{letter}"
    return _op(name, statement, (_v, _k), (_vo,), lambda v, k: v + sign * k * sp.Matrix(unit(axis)))


OPERATIONS = (*linear_space(_NAME, VEC3, "v"), *_PRODUCTS,
              *(_shift(axis, sign) for axis in range(3) for sign in (1, -1)))

FAMILY = Family(_NAME, 10, __doc__, OPERATIONS)
