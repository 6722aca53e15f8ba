"""6×6 operators on screws and coscrews: [Ad], [Ad]*, [ad], [ad]*, and articulated inertias."""

from collections.abc import Callable

import sympy as sp

from coscrew_codegen.algebra.matrices import CoAd, blocks, shifted, skew, turned
from coscrew_codegen.algebra.operations.family import Family
from coscrew_codegen.algebra.operations.formulas.norm import Let
from coscrew_codegen.algebra.operations.operation import Operation
from coscrew_codegen.program.values.quantity import (
    ANY,
    MAT3X3,
    MAT6X6,
    ROTATION,
    SYMMETRIC,
    VEC3,
    Argument,
)

_NAME = "mat6x6"

_M, _self, _Mo = (Argument(name, MAT6X6, ANY) for name in ("M", "self", "Mo"))
_articulated = Argument("M", MAT6X6, SYMMETRIC)
_R, _t = Argument("R", MAT3X3, ROTATION), Argument("t", VEC3, ANY)


def _symmetric(M: sp.Matrix) -> sp.Matrix:
    """The matrix with this lower triangle."""
    return sp.Matrix(*M.shape, lambda i, j: M[max(i, j), min(i, j)])


def _bound(let: Let, name: str, S: sp.Matrix) -> sp.Matrix:
    """The symmetric matrix S with each entry bound once."""
    places = [(i, j) for i in range(S.rows) for j in range(i + 1)]
    x = let(name, sp.Matrix([S[place] for place in places]))
    return sp.Matrix(*S.shape, lambda i, j: x[places.index((max(i, j), min(i, j)))])


def _rotated(let: Let, R: sp.Matrix, M: sp.Matrix) -> sp.Matrix:
    """[[R M R^T, R H^T R^T], [R H R^T, R I R^T]] for [[M, H^T], [H, I]]."""
    M = _symmetric(M)
    linear = _bound(let, "linear", let("RM", R * M[:3, :3]) * R.T)
    H = let("coupling", let("RH", R * M[3:, :3]) * R.T)
    return blocks(linear, H.T, H, _bound(let, "angular", let("RI", R * M[3:, 3:]) * R.T))


def _shifted(let: Let, t: sp.Matrix, M: sp.Matrix) -> sp.Matrix:
    """[[M, G^T], [G, I + t~ H^T - G t~]] with G = H + t~ M, for [[M, H^T], [H, I]]."""
    M, t = _symmetric(M), skew(t)
    linear, H = M[:3, :3], M[3:, :3]
    G = let("G", H + t * linear)
    return blocks(linear, G.T, G, _bound(let, "moved", M[3:, 3:] + t * H.T - G * t))


def _moved(name: str, of: Argument, displacement: Callable[[sp.Matrix], sp.Matrix],
           derivation: Callable[..., sp.Matrix]) -> Operation:
    x = of.name
    return Operation(
        _NAME, f"mat6x6_{name}", f"Mo = [Ad]*({x}) M [Ad]^-1({x}), the articulated inertia M "
        f"{name} by {x}; M is symmetric, only its lower triangle is read",
        (of, _articulated), (_Mo,),
        lambda x, M: CoAd(displacement(x)) * _symmetric(M) * CoAd(displacement(x)).T, derivation)


OPERATIONS = (
    Operation(_NAME, "mat6x6_copy", "Mo = M", (_M,), (_Mo,), lambda M: M),
    Operation(_NAME, "mat6x6_setIdentity", "self = I", (_self,), (_self,), lambda M: sp.eye(6)),
    Operation(_NAME, "mat6x6_transposed", "Mo = M^T", (_M,), (_Mo,), lambda M: M.T),
    _moved("rotated", _R, turned, _rotated),
    _moved("shifted", _t, shifted, _shifted),
)

FAMILY = Family(_NAME, 60, __doc__, OPERATIONS)
