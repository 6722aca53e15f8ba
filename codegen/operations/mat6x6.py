"""6×6 operators on screws and coscrews, as [Ad], [Ad]*, [ad] and [ad]* return them, and symmetric
ones from screws to coscrews: articulated inertias."""

import sympy as sp

from coscrew_codegen.algebra import CoAd, blocks, rotation, skew, translation
from coscrew_codegen.operations.norm import Let
from coscrew_codegen.operations.operation import Operation
from coscrew_codegen.quantity import MAT6X6, SE3, Argument

FAMILY = "mat6x6"

_M, _self, _Mo = (Argument(name, MAT6X6) for name in ("M", "self", "Mo"))
_D = Argument("D", SE3)


def _symmetric(let: Let, name: str, S: sp.Matrix) -> sp.Matrix:
    """S, its upper triangle bound."""
    x = let(name, sp.Matrix([S[i, j] for i in range(S.rows) for j in range(i, S.rows)]))
    place = {(i, j): n for n, (i, j) in enumerate(
        (i, j) for i in range(S.rows) for j in range(i, S.rows))}
    return sp.Matrix(*S.shape, lambda i, j: x[place[min(i, j), max(i, j)]])


def _transformed(let: Let, D: sp.Matrix, M: sp.Matrix) -> sp.Matrix:
    """Of M = [[M, H^T], [H, I]]: M' = R M R^T, G = R H R^T + t~ M',
    I' = R I R^T + t~ (R H R^T)^T - G t~; then [[M', G^T], [G, I']]."""
    R, t = rotation(D), skew(translation(D))
    M = sp.Matrix(6, 6, lambda i, j: M[max(i, j), min(i, j)])
    linear = _symmetric(let, "linear", let("RM", R * M[:3, :3]) * R.T)
    H = let("coupling", let("RH", R * M[3:, :3]) * R.T)
    angular = _symmetric(let, "angular", let("RI", R * M[3:, 3:]) * R.T)
    G = let("G", H + t * linear)
    moved = _symmetric(let, "moved", angular + t * H.T - G * t)
    return blocks(linear, G.T, G, moved)


OPERATIONS = (
    Operation("mat6x6_copy", FAMILY, "Mo = M", (_M,), (_Mo,), lambda M: M),
    Operation("mat6x6_setIdentity", FAMILY, "self = I", (_self,), (_self,), lambda M: sp.eye(6)),
    Operation("mat6x6_transposed", FAMILY, "Mo = M^T", (_M,), (_Mo,), lambda M: M.T),
    Operation("mat6x6_transformed", FAMILY, "Mo = [Ad]*(D) M [Ad]^-1(D), M symmetric, of which the "
              "lower triangle is read: an articulated inertia in the frame D takes its own to",
              (_D, _M), (_Mo,),
              lambda D, M: CoAd(D) * sp.Matrix(6, 6, lambda i, j: M[max(i, j), min(i, j)])
              * CoAd(D).T, _transformed),
)
