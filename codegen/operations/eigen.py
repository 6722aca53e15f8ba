"""Eigenvectors of symmetric 3×3 matrices: Jacobi's rotations, one cycle of three at a time."""

import sympy as sp

from coscrew_codegen.operations import special
from coscrew_codegen.operations.norm import Let, nonzero, prefixed
from coscrew_codegen.operations.operation import Operation
from coscrew_codegen.quantity import MAT3X3, Argument

_A, _V = Argument("A", MAT3X3), Argument("V", MAT3X3)


def _rotation(let: Let, A: sp.Matrix, p: int, q: int) -> tuple[sp.Expr, sp.Expr, sp.Expr]:
    """Tangent, sine and cosine of the smaller angle that makes A_pq zero: with θ = cot 2φ,
    t = sign θ / (|θ| + sqrt(θ² + 1)).  No square is of A's own size, so that none over- or
    underflows; where θ² does, t is as good as zero."""
    double = let("double", 2 * A[p, q])
    theta = let("theta", let("apart", A[q, q] - A[p, p]) / let("divisor", nonzero(double)))
    size = let("size", let("absolute", sp.Abs(theta)) + sp.sqrt(theta**2 + 1))
    signed = let("signed", sp.Piecewise((-size, theta < 0), (size, True)))
    t = let("t", sp.Piecewise((0, sp.Eq(double, 0)), (1 / signed, True)))
    c = let("c", 1 / let("secant", sp.sqrt(t**2 + 1)))
    return t, let("s", t * c), c


def _turned(let: Let, name: str, p: sp.Matrix, q: sp.Matrix, s: sp.Expr,
            c: sp.Expr) -> tuple[sp.Matrix, sp.Matrix]:
    """c p - s q, s p + c q."""
    return let(f"{name}p", c * p - s * q), let(f"{name}q", s * p + c * q)


def cycle(let: Let, A: sp.Matrix, V: sp.Matrix) -> tuple[sp.Matrix, sp.Matrix]:
    """A ← J^T A J, V ← V J for rotations J in the planes xy, xz, yz."""
    A, V = sp.Matrix(3, 3, lambda i, j: A[max(i, j), min(i, j)]), V.copy()
    for p, q in ((0, 1), (0, 2), (1, 2)):
        named, r = prefixed(let, f"r{p}{q}"), 3 - p - q
        t, s, c = _rotation(named, A, p, q)
        change = named("change", t * A[p, q])
        A[p, p], A[q, q] = named("App", A[p, p] - change), named("Aqq", A[q, q] + change)
        A[p, q] = A[q, p] = sp.Integer(0)
        one, other = _turned(named, "A", sp.Matrix([A[r, p]]), sp.Matrix([A[r, q]]), s, c)
        A[r, p] = A[p, r] = one[0]
        A[r, q] = A[q, r] = other[0]
        V[:, p], V[:, q] = _turned(named, "V", V[:, p], V[:, q], s, c)
    return A, V


OPERATIONS = (
    Operation("mat3x3_jacobi", "mat3x3", "A = J^T A J, V = V J: one cycle of Jacobi's rotations J in "
              "the planes xy, xz, yz, each by the smaller angle that makes its off-diagonal entry of "
              "A zero; A symmetric, its lower triangle is read.  From V = I, cycles end in "
              "A = V diag(eigenvalues) V^T", (_A, _V), (_A, _V),
              lambda A, V: tuple(sp.Matrix(3, 3, lambda i, j, k=k: special.jacobi(k, i, j, *A, *V))
                                 for k in range(2)), cycle,
              rounding="|V A V^T - the same before| <= 20 u max |A|; measured, not proved."),
)
