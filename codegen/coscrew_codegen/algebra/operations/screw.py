"""Screws: twists, spatial velocities and accelerations, s = (v; ω)."""

import sympy as sp

from coscrew_codegen.algebra.matrices import Ad, ad, ang, lin, rotation, stack, translation
from coscrew_codegen.algebra.operations.family import Family
from coscrew_codegen.algebra.operations.formulas.norm import Let
from coscrew_codegen.algebra.operations.formulas.spatial import Space, space_operations
from coscrew_codegen.algebra.operations.operation import Operation
from coscrew_codegen.program.values.quantity import (
    COSCREW,
    MAT6X6,
    SCALAR,
    SCREW,
    SE3,
    UNIT_VECTOR,
    VEC3,
    Argument,
)

_NAME = "screw"

_SPACE = Space(SCREW, "s", Ad, "Ad", "[Ad]", ang, lin,
               "|ω|, or |v| where every |ω_i| is below 1e-9 (single: 1e-6)")
_s, _s1, _s2, _so = (Argument(name, SCREW) for name in ("s", "s1", "s2", "so"))
_c, _D, _axis = Argument("c", COSCREW), Argument("D", SE3), Argument("axis", VEC3, UNIT_VECTOR)
_power, _M = Argument("power", SCALAR), Argument("M", MAT6X6)


def _about(let: Let, D: sp.Matrix, axis: sp.Matrix) -> sp.Matrix:
    a = let("a", rotation(D) * axis)
    return stack(translation(D).cross(a), a)


OPERATIONS = (
    *space_operations(_SPACE),
    _SPACE.op("dot_cs", "power = f·v + τ·ω, in W", (_c, _s), (_power,), lambda c, s: c.dot(s)),
    Operation(_NAME, "cross_ss", "so = [ad](s1) s2 = (ω1×v2 + v1×ω2 ; ω1×ω2)", (_s1, _s2), (_so,),
              lambda s1, s2: ad(s1) * s2,
              remark="Exactly zero for s1 = s2, unless products overflow."),
    _SPACE.op("cross_sst", "so = (ω1×v2 ; 0)", (_s1, _s2), (_so,),
              lambda s1, s2: stack(ang(s1).cross(lin(s2)), sp.zeros(3, 1))),
    _SPACE.op("hsra", "so = (t×R a ; R a), a = axis in the body's frame", (_D, _axis), (_so,),
              lambda D, axis: Ad(D) * stack(sp.zeros(3, 1), axis), _about),
    _SPACE.op("hsta", "so = (R a ; 0), a = axis in the body's frame", (_D, _axis), (_so,),
              lambda D, axis: Ad(D) * stack(axis, sp.zeros(3, 1))),
    _SPACE.op("hsrainv", "so = -(t×R a ; R a), a = axis in the body's frame", (_D, _axis), (_so,),
              lambda D, axis: -Ad(D) * stack(sp.zeros(3, 1), axis),
              lambda let, D, axis: _about(let, D, -axis)),
    _SPACE.op("hstainv", "so = -(R a ; 0), a = axis in the body's frame", (_D, _axis), (_so,),
              lambda D, axis: -Ad(D) * stack(axis, sp.zeros(3, 1))),
    _SPACE.op("ad", "M = [ad](s) = [Ad]' [Ad]^-1 = [[ω~, v~], [0, ω~]]", (_s,), (_M,), ad),
)

FAMILY = Family(_NAME, 90, __doc__, OPERATIONS, includes=("matrix", "mat6x6"))
