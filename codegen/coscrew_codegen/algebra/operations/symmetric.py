"""Symmetric positive definite 3×3 and 6×6 matrices: A = L D L^T, solutions of A x = b.

Only the lower triangle of A is read.  Pivots are returned divided by their diagonal entries: 1 for
a diagonal matrix, small for a nearly singular one, zero or negative if A is not positive definite.
"""

from collections.abc import Sequence
from functools import partial

import sympy as sp

from coscrew_codegen.algebra.operations.family import Family
from coscrew_codegen.algebra.operations.formulas.norm import Let, prefixed, unnamed
from coscrew_codegen.algebra.operations.formulas.special import (
    factor,
    smallest_pivot,
    solution,
    vector,
)
from coscrew_codegen.algebra.operations.operation import REGULAR, Operation
from coscrew_codegen.program.values.quantity import (
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
    """Unit lower triangular L and the diagonal of D.  A pivot that is not positive is replaced by 1
    as a divisor; the results that follow are meaningless."""
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
    """min d_i / a_ii, where a diagonal entry a_ii that is not positive replaces the quotient."""
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
    """Returns whether A - 50 u diag A has positive pivots.

    The factorization is exact for a matrix that differs from A by less than
    (min(i, j) + 2) u sqrt(a_ii a_jj) in row i, column j, counted from 0: with the diagonal scaled
    to 1, by less than 25 u in the 2-norm.  So if the pivots are positive, A has no eigenvalue below
    25 u and its own pivots are positive; if not, A has an eigenvalue below 75 u.  A threshold for
    the smallest pivot of A itself would have to exceed the rounding error of a zero pivot, which is
    a thousand u for some 6×6 matrices."""
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
    result = let("found", x + step)
    pivot = sp.Piecewise((part, regular), (least, True))
    return pivot, result.applyfunc(lambda c: sp.Piecewise((c, regular), (sp.nan, True)))


def _operations(matrix: Quantity, right: Quantity, left: Quantity) -> tuple[Operation, ...]:
    n = matrix.shape[0]
    A, L = Argument("A", matrix, POSITIVE_DEFINITE), Argument("L", matrix, LDL_FACTOR)
    b, x = Argument("b", right, ANY), Argument("x", left)
    pivot = Argument("pivot", SCALAR)

    def entry(i: int, j: int, triangle: Sequence[sp.Expr]) -> sp.Expr:
        return factor(i, j, *triangle) if j <= i else sp.Integer(0)

    def ldl(A: sp.Matrix) -> tuple[sp.Expr, sp.Matrix]:
        triangle = lower_triangle(A)
        return smallest_pivot(*triangle), sp.Matrix(n, n, lambda i, j: entry(i, j, triangle))

    def bound_ldl(let: Let, A: sp.Matrix) -> tuple[sp.Expr, sp.Matrix]:
        L, D = factored(let, A)
        return bound_smallest_pivot(let, A, D), L - sp.eye(n) + sp.diag(*D)

    def solved(A: sp.Matrix, b: sp.Matrix) -> tuple[sp.Expr, sp.Matrix]:
        triangle = lower_triangle(A)
        return smallest_pivot(*triangle), vector(solution, n, *b, *triangle)

    def by_factor(let: Let, L: sp.Matrix, b: sp.Matrix) -> sp.Matrix:
        unit = sp.Matrix(n, n, lambda i, j: 1 if i == j else L[i, j] if j < i else 0)
        return substituted(let, unit, [L[i, i] for i in range(n)], b)

    op = partial(Operation, _NAME)
    return (
        op(name=f"{matrix.name}_ldl", statement="L, D with L D L^T = A: unit lower triangular L, "
           "with D on its diagonal; only the lower triangle of A is read.  Returns the smallest "
           "pivot d_i / a_ii: if it is not positive, A is not positive definite, and L is "
           "meaningless", inputs=(A,), outputs=(pivot, L),
           formula=ldl, derivation=bound_ldl,
           rounding=f"|L D L^T - A|_ij <= {FACTOR[n]} u sqrt(a_ii a_jj) where the pivot is "
           "positive, barring over- and underflow."),
        op(name=f"{matrix.name}_ldl_solve", statement=f"x = A^-1 b, L of {matrix.name}_ldl with a "
           "positive pivot", inputs=(L, b), outputs=(x,), formula=partial(by_factor, unnamed),
           derivation=by_factor, rounding=_backward("of A = L D L^T")),
        op(name=f"{matrix.name}_solve", statement="x = A^-1 b with one step of refinement; A is "
           "symmetric, only its lower triangle is read.  Returns the smallest pivot d_i / a_ii: it "
           "is not positive, and x is NaN, if A is singular to rounding or indefinite "
           "(A - 50 u diag A is not positive definite)",
           inputs=(A, b), outputs=(pivot, x), formula=solved, derivation=_solve,
           rounding=_backward("of A")),
    )


# In u: the error bound of a factorization by the number of rows, from a count of roundings; and 1.5
# times the largest measured residual of solutions.
FACTOR, BACKWARD = {3: 4, 6: 7}, 4


def _backward(matrix: str) -> str:
    return (f"Backward error, {matrix}: |b - A x|_i <= {BACKWARD} u Σ_j sqrt(a_ii a_jj) |x_j|; "
            "measured, not proved; barring over- and underflow.")


OPERATIONS = (*_operations(MAT3X3, VEC3, VEC3), *_operations(MAT6X6, COSCREW, SCREW))

FAMILY = Family(_NAME, 130, __doc__, OPERATIONS, includes=("mat6x6", "screw", "coscrew"))
