"""Symmetric positive definite 3×3 and 6×6 matrices: A = L D L^T, solutions of A x = b.

Of A the lower triangle is read.  A pivot is given as a part of its diagonal entry: 1 in a diagonal
matrix, small in a nearly singular one, zero or negative if A is not positive definite.
"""

from functools import partial

import sympy as sp

from coscrew_codegen.operations.family import Family
from coscrew_codegen.operations.norm import Let, prefixed, unnamed
from coscrew_codegen.operations.operation import REGULAR, Operation
from coscrew_codegen.operations.special import factor, smallest_pivot, solution, vector
from coscrew_codegen.quantity import (
    ANY,
    COSCREW,
    LDL_FACTOR,
    MAT3X3,
    MAT6X6,
    POSITIVE_DEFINITE,
    SCALAR,
    SCREW,
    VEC3,
    Argument,
    Quantity,
)

_NAME = "symmetric"


def lower_triangle(A: sp.Matrix) -> list[sp.Expr]:
    """a00, a10, a11, a20, …."""
    return [A[i, j] for i in range(A.rows) for j in range(i + 1)]


def factored(let: Let, A: sp.Matrix) -> tuple[sp.Matrix, list[sp.Expr]]:
    """Unit lower triangular L and the diagonal of D.  Where a pivot is not positive, 1 divides in
    its place: what follows from it means nothing."""
    n, D = A.rows, []
    L, U = sp.eye(n), sp.zeros(n, n)  # U = L D
    for j in range(n):
        column = let(f"u{j}", sp.Matrix([A[i, j] - sum(U[i, k] * L[j, k] for k in range(j))
                                         for i in range(j, n)]))
        below = sp.Matrix([column]) if n - j == 1 else column
        U[j:, j] = below
        D.append(below[0])
        divisor = let(f"divisor{j}", sp.Piecewise((below[0], below[0] > 0), (1, True)))
        if j < n - 1:
            L[j + 1:, j] = let(f"l{j}", below[1:, :] / divisor)
    return L, D


def bound_smallest_pivot(let: Let, A: sp.Matrix, D: list[sp.Expr]) -> sp.Expr:
    """min d_i / a_ii; a diagonal entry that is not positive stands for itself."""
    smallest = None
    for i, d in enumerate(D):
        positive = A[i, i] > 0
        own = let(f"own{i}", sp.Piecewise((A[i, i], positive), (1, True)))
        part = let(f"part{i}", sp.Piecewise((d / own, positive), (A[i, i], True)))
        smallest = part if smallest is None else \
            let(f"smallest{i}", sp.Piecewise((smallest, smallest < part), (part, True)))
    return smallest


def substituted(let: Let, L: sp.Matrix, D: list[sp.Expr], b: sp.Matrix) -> sp.Matrix:
    """L^-T D^-1 L^-1 b."""
    n = L.rows
    y: list[sp.Expr] = []
    for i in range(n):
        y.append(let(f"y{i}", b[i] - sum(L[i, k] * y[k] for k in range(i))))
    x = [let(f"z{i}", y[i] / D[i]) for i in range(n)]
    for i in reversed(range(n)):
        x[i] = let(f"x{i}", x[i] - sum(L[k, i] * x[k] for k in range(i + 1, n)))
    return sp.Matrix(x)


def _is_regular(let: Let, A: sp.Matrix) -> sp.Basic:
    """Whether A - 50 u diag A has positive pivots.  Rounding changes a factored matrix by less than
    (min(i, j) + 2) u sqrt(a_ii a_jj) in row i, column j, counted from 0, so, its diagonal scaled to
    1, by less than 25 u in all directions together: with positive pivots A has no eigenvalue below
    25 u, so that its own are positive, too; without them it has one below 75 u.  A threshold of A's
    own smallest pivot would have to be above what rounding makes of a zero there: a thousand u, for
    some 6×6 matrices."""
    less = let("less", sp.Matrix([REGULAR * A[i, i] for i in range(A.rows)]))
    diminished = sp.Matrix(*A.shape, lambda i, j: less[i] if i == j else A[i, j])
    _, D = factored(prefixed(let, "less"), diminished)
    return sp.And(*(d > 0 for d in D))


def _solve(let: Let, A: sp.Matrix, b: sp.Matrix) -> tuple[sp.Expr, sp.Matrix]:
    """x and one step of refinement: x + A^-1 (b - A x)."""
    n = A.rows
    L, D = factored(let, A)
    part = let("pivot_part", bound_smallest_pivot(let, A, D))
    regular = sp.Eq(let("regular", sp.Piecewise((1, _is_regular(let, A)), (0, True))), 1)
    least = let("least", sp.Piecewise((part, part < 0), (0, True)))
    safe = [let(f"safe{i}", sp.Piecewise((d, d > 0), (1, True))) for i, d in enumerate(D)]
    x = substituted(let, L, safe, b)
    residual = let("residual", sp.Matrix([
        b[i] - sum(A[max(i, j), min(i, j)] * x[j] for j in range(n)) for i in range(n)]))
    step = substituted(prefixed(let, "refined"), L, safe, residual)
    found = let("found", x + step)
    pivot = sp.Piecewise((part, regular), (least, True))
    return pivot, found.applyfunc(lambda c: sp.Piecewise((c, regular), (sp.nan, True)))


def _operations(matrix: Quantity, right: Quantity, left: Quantity) -> tuple[Operation, ...]:
    n = matrix.shape[0]
    A, L = Argument("A", matrix, POSITIVE_DEFINITE), Argument("L", matrix, LDL_FACTOR)
    b, x = Argument("b", right, ANY), Argument("x", left)
    pivot = Argument("pivot", SCALAR)

    def entry(i, j, triangle):
        return factor(i, j, *triangle) if j <= i else sp.Integer(0)

    def ldl(A):
        triangle = lower_triangle(A)
        return smallest_pivot(*triangle), sp.Matrix(n, n, lambda i, j: entry(i, j, triangle))

    def bound_ldl(let, A):
        L, D = factored(let, A)
        return bound_smallest_pivot(let, A, D), L - sp.eye(n) + sp.diag(*D)

    def solved(A, b):
        triangle = lower_triangle(A)
        return smallest_pivot(*triangle), vector(solution, n, *b, *triangle)

    def by_factor(let, L, b):
        unit = sp.Matrix(n, n, lambda i, j: 1 if i == j else L[i, j] if j < i else 0)
        return substituted(let, unit, [L[i, i] for i in range(n)], b)

    op = partial(Operation, family=_NAME)
    return (
        op(name=f"{matrix.name}_ldl", statement="L, D with L D L^T = A, of which the lower "
           "triangle is read: unit lower triangular L, D on its diagonal; returns the smallest "
           "pivot d_i / a_ii: where it is not positive, A is not positive definite, and L means "
           "nothing", inputs=(A,), outputs=(pivot, L),
           formula=ldl, derivation=bound_ldl,
           rounding=f"|L D L^T - A|_ij <= {FACTOR[n]} u sqrt(a_ii a_jj) where the pivot is "
           "positive, barring over- and underflow."),
        op(name=f"{matrix.name}_ldl_solve", statement=f"x = A^-1 b, L of {matrix.name}_ldl with a "
           "positive pivot", inputs=(L, b), outputs=(x,), formula=partial(by_factor, unnamed),
           derivation=by_factor, rounding=_backward("of A = L D L^T")),
        op(name=f"{matrix.name}_solve", statement="x = A^-1 b with one step of refinement, A "
           "symmetric, its lower triangle is read; returns the smallest pivot d_i / a_ii: where A "
           "is singular to rounding or indefinite (A - 50 u diag A is not positive definite), it "
           "is not positive, and x not a number",
           inputs=(A, b), outputs=(pivot, x), formula=solved, derivation=_solve,
           rounding=_backward("of A")),
    )


# In u: by the number of rows, what a factor is off at most, counted along its roundings; and what
# residuals of solutions were at most, and half as much again.
FACTOR, BACKWARD = {3: 4, 6: 7}, 4


def _backward(matrix: str) -> str:
    return (f"Backward error, {matrix}: |b - A x|_i <= {BACKWARD} u Σ_j sqrt(a_ii a_jj) |x_j|; "
            "measured, not proved; barring over- and underflow.")


OPERATIONS = (*_operations(MAT3X3, VEC3, VEC3), *_operations(MAT6X6, COSCREW, SCREW))

FAMILY = Family(_NAME, 130, __doc__, OPERATIONS, includes=("mat6x6", "screw", "coscrew"))
