"""Coscrews: wrenches and momenta, c = (f; τ)."""

from collections.abc import Callable

import sympy as sp

from coscrew_codegen.algebra.matrices import (
    CoAd,
    ang,
    coad,
    constraint_projector,
    lin,
    rotation,
    shifted,
    stack,
    translation,
    turned,
    working_projector,
)
from coscrew_codegen.algebra.operations.family import Family
from coscrew_codegen.algebra.operations.formulas.norm import Let
from coscrew_codegen.algebra.operations.formulas.spatial import JOINTS, Space, space_operations
from coscrew_codegen.algebra.operations.operation import Operation
from coscrew_codegen.program.values.quantity import (
    ANGULAR_FIRST,
    COSCREW,
    MAT6X6,
    SCALAR,
    SCREW,
    SE3,
    Argument,
)

_NAME = "coscrew"

_SPACE = Space(COSCREW, "c", CoAd, "CoAd", "[Ad]*", lin, ang,
               "|f|, or |τ| where every |f_i| is below 1e-9 (single: 1e-6)")
_s, _c, _co = Argument("s", SCREW), Argument("c", COSCREW), Argument("co", COSCREW)
_D, _M = Argument("D", SE3), Argument("M", MAT6X6)
_x, _power = Argument("x", ANGULAR_FIRST), Argument("power", SCALAR)


def _projected(joint: int, words: str, projector: Callable[[int], sp.Matrix]) -> Operation:
    P = projector(joint)

    def derivation(let: Let, D: sp.Matrix, c: sp.Matrix) -> sp.Matrix:
        moved = let("w", CoAd(turned(rotation(D))) * P * c)
        return CoAd(shifted(translation(D))) * moved

    return _SPACE.op(f"{words}_c{JOINTS[joint]}", f"co = {'h̄*' if words == 'working' else 'H̄*'} c"
                     f" = [Ad]*(D) P c; P {'keeps' if words == 'working' else 'clears'} component "
                     f"{joint} of c, given in the frame of a {JOINTS[joint]} joint at D",
                     (_D, _c), (_co,), lambda D, c: CoAd(D) * P * c, derivation)


OPERATIONS = (
    *space_operations(_SPACE),
    _SPACE.op("reciprocal_product", "power = W ⊙ $ = f·v + τ·ω, W = c = (f; τ), $ = x = (ω; v)",
              (_c, _x), (_power,), lambda c, x: lin(c).dot(ang(x)) + ang(c).dot(lin(x))),
    _SPACE.op("cross_sc", "co = [ad]*(s) c = (ω×f ; v×f + ω×τ)", (_s, _c), (_co,),
              lambda s, c: coad(s) * c),
    _SPACE.op("cross_sca", "co = (0 ; ω×τ)", (_s, _c), (_co,),
              lambda s, c: stack(sp.zeros(3, 1), ang(s).cross(ang(c)))),
    *(_projected(joint, "constraint", constraint_projector) for joint in range(6)),
    *(_projected(joint, "working", working_projector) for joint in range(6)),
    _SPACE.op("coad", "M = [ad]*(s) = [Ad]*' [Ad]*^-1 = [[ω~, 0], [v~, ω~]]", (_s,), (_M,), coad),
)

FAMILY = Family(_NAME, 100, __doc__, OPERATIONS, includes=("screw",))
