"""Eigenvectors of symmetric 3×3 matrices: Jacobi's rotations, one at a time."""

import sympy as sp

from coscrew_codegen.algebra.operations.formulas import special
from coscrew_codegen.algebra.operations.formulas.norm import Let, nonzero
from coscrew_codegen.algebra.operations.operation import Operation
from coscrew_codegen.program.values.quantity import MAT3X3, ROTATION, SYMMETRIC, Argument

_A, _V = Argument("A", MAT3X3, SYMMETRIC), Argument("V", MAT3X3, ROTATION)

BACKWARD = 28
"""In u: the largest change of V A V^T by one rotation, relative to its largest entry."""


def _rotation(let: Let, A: sp.Matrix) -> tuple[sp.Expr, sp.Expr, sp.Expr]:
    """Tangent t, sine and cosine of the smaller angle φ that makes A_xy zero: with θ = cot 2φ,
    t = sign θ / (|θ| + sqrt(θ² + 1)).  No entry of A is squared, so that A may be large or small;
    where θ² overflows, t is practically zero."""
    twice = let("twice", 2 * A[1, 0])
    theta = let("theta", let("apart", A[1, 1] - A[0, 0]) / let("divisor", nonzero(twice)))
    size = let("size", let("magnitude", sp.Abs(theta)) + sp.sqrt(theta**2 + 1))
    along = let("along", sp.Piecewise((-size, theta < 0), (size, True)))
    t = let("t", sp.Piecewise((0, sp.Eq(twice, 0)), (1 / along, True)))
    c = let("c", 1 / let("secant", sp.sqrt(t**2 + 1)))
    return t, let("s", t * c), c


def _turned(let: Let, name: str, p: sp.Matrix, q: sp.Matrix, s: sp.Expr,
            c: sp.Expr) -> tuple[sp.Matrix, sp.Matrix]:
    """c p - s q, s p + c q."""
    return let(f"{name}p", c * p - s * q), let(f"{name}q", s * p + c * q)


def step(let: Let, A: sp.Matrix, V: sp.Matrix) -> tuple[sp.Matrix, sp.Matrix]:
    """J^T A J and V J, J a rotation in the xy plane; then y, z, x are renamed x, y, z."""
    p, q, r = 0, 1, 2
    t, s, c = _rotation(let, A)
    change = let("change", t * A[q, p])
    zp, zq = _turned(let, "z", sp.Matrix([A[r, p]]), sp.Matrix([A[r, q]]), s, c)
    B = sp.zeros(3, 3)
    B[p, p], B[q, q], B[r, r] = A[p, p] - change, A[q, q] + change, A[r, r]
    B[r, p] = B[p, r] = zp[0]
    B[r, q] = B[q, r] = zq[0]
    Vp, Vq = _turned(let, "v", V[:, p], V[:, q], s, c)
    order = [q, r, p]
    return B.extract(order, order), sp.Matrix.hstack(Vp, Vq, V[:, r])[:, order]


OPERATIONS = (
    Operation("mat3x3", "mat3x3_jacobi", "A = J^T A J, V = V J: Jacobi's rotation J in the xy "
              "plane, by the smaller angle that makes A_xy zero; then y, z, x become x, y, z.  A "
              "is symmetric, only its lower triangle is read.  Repeated from V = I, it converges "
              "to A = diag(eigenvalues); V A V^T does not change", (_A, _V), (_A, _V),
              lambda A, V: tuple(sp.Matrix(3, 3, lambda i, j, k=k: special.jacobi(k, i, j, *A, *V))
                                 for k in range(2)), step,
              rounding=f"V A V^T changes by at most {BACKWARD} u max |A| for orthonormal V; "
              "searched, not proved."),
)
