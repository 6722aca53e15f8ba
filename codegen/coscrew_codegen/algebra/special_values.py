"""The functions of `algebra/operations/formulas/special.py` in mpmath's precision, by their names
in formulas.

Formulas use the components of a result one by one; `_once` computes the whole result once.
"""

from collections.abc import Callable
from functools import lru_cache, wraps
from math import isqrt
from typing import TypeAlias, TypeVar

import mpmath
from gmpy2 import mpq
from mpmath import matrix

Number: TypeAlias = mpmath.mpf
V = TypeVar("V")


def _once(function: Callable[..., V]) -> Callable[..., V]:
    """The function with its last results cached: the components of a row are used in turn."""
    @lru_cache(maxsize=64)
    def kept(precision: int, *numbers: Number) -> V:
        return function(*numbers)

    return wraps(function)(lambda *numbers: kept(mpmath.mp.prec, *numbers))


@_once
def g(k: Number, x: Number) -> Number:
    """Σ (-x)^j / (2j + k)!, with extra digits for the cancellation of its alternating terms; for a
    large x by g(k + 2) = (1/k! - g(k)) / x from cos and sin, which loses no digits."""
    if x > 10**4:
        root, k = mpmath.sqrt(x), int(k)
        result = mpmath.sin(root) / root if k % 2 else mpmath.cos(root)
        for n in range(k % 2, k, 2):
            result = (1 / mpmath.factorial(n) - result) / x
        return result
    with mpmath.workdps(mpmath.mp.dps + int(mpmath.sqrt(x)) + 10):
        term, total, j = 1 / mpmath.factorial(k), mpmath.mpf(0), 0
        while abs(term) > mpmath.eps or (2 * j)**2 < x:
            total += term
            j += 1
            term *= -x / ((2 * j + k - 1) * (2 * j + k))
        return total


def b(x: Number) -> Number:
    """(1 - θ/2 cot θ/2) / θ² = (g3 - 2 g4) / 2 g2 with θ² = x."""
    return (g(3, x) - 2 * g(4, x)) / (2 * g(2, x))


# rotations


def _skew(v: matrix) -> matrix:
    return matrix([[0, -v[2], v[1]], [v[2], 0, -v[0]], [-v[1], v[0], 0]])


def _series(v: matrix, first: int) -> matrix:
    """Σ v~^k / (k + first)!: the exponential, or the left Jacobian."""
    x, W = mpmath.fdot(v, v), _skew(v)
    return mpmath.eye(3) / mpmath.factorial(first) + g(first + 1, x) * W + g(first + 2, x) * W * W


def _quaternion(R: matrix) -> matrix:
    """The eigenvector to the largest eigenvalue of the matrix with quadratic form tr R(q)^T R."""
    trace = R[0, 0] + R[1, 1] + R[2, 2]
    K = mpmath.zeros(4)
    K[3, 3] = trace
    for i in range(3):
        j, k = (i + 1) % 3, (i + 2) % 3
        K[3, i] = K[i, 3] = R[k, j] - R[j, k]
        K[i, i] = 2 * R[i, i] - trace
        K[i, j] = K[j, i] = R[i, j] + R[j, i]
    values, vectors = mpmath.eigsy(K)
    q = vectors[:, max(range(4), key=lambda i: values[i])]
    return -q if q[3] < 0 else q


def _log(q: matrix) -> matrix:
    q = -q if q[3] < 0 else q
    n = mpmath.norm(q[:3])
    return q[:3] * (2 * mpmath.atan2(n, q[3]) / n if n else 2 / q[3])


def _product(p: matrix, q: matrix) -> matrix:
    v = p[3] * q[:3] + q[3] * p[:3] + _skew(p[:3]) * q[:3]
    return matrix([*v, p[3] * q[3] - mpmath.fdot(p[:3], q[:3])])


@_once
def _of_matrix(*R: Number) -> matrix:
    return _quaternion(matrix([R[:3], R[3:6], R[6:]]))


def quaternion_of(i: Number, *R: Number) -> Number:
    """Component i of the quaternion of the rotation nearest to R.

    Source: I. Y. Bar-Itzhack, J. Guidance 23 (2000) 1085."""
    return _of_matrix(*R)[int(i)]


@_once
def _vector(*q: Number) -> matrix:
    return _log(matrix(q))


def quaternion_log(i: Number, *q: Number) -> Number:
    """Component i of 2 atan2(|v|, |w|) ±v / |v|."""
    return _vector(*q)[int(i)]


@_once
def _slerp(*numbers: Number) -> matrix:
    p, q, k = matrix(numbers[:4]), matrix(numbers[4:8]), numbers[8]
    half = k * _log(_product(matrix([*-p[:3], p[3]]), q)) / 2
    x = mpmath.fdot(half, half)
    return _product(p, matrix([*(g(1, x) * half), g(0, x)]))


def slerp(i: Number, *numbers: Number) -> Number:
    """Component i of p (p* q)^k."""
    return _slerp(*numbers)[int(i)]


@_once
def _interpolated(*numbers: Number) -> tuple[matrix, matrix]:
    (R1, t1), (R2, t2), k = _parts(numbers[:12]), _parts(numbers[12:24]), numbers[24]
    w = _log(_quaternion(R1.T * R2))
    v = mpmath.lu_solve(_series(w, 1), R1.T * (t2 - t1))
    return R1 * _series(k * w, 0), R1 * (_series(k * w, 1) * (k * v)) + t1


def interpolated(row: Number, column: Number, *numbers: Number) -> Number:
    """An entry of D1 exp(k log(D1^-1 D2))."""
    R, t = _interpolated(*numbers)
    return R[int(row), int(column)] if column < 3 else t[int(row)]


def _parts(D: tuple[Number, ...]) -> tuple[matrix, matrix]:
    rows = D[:4], D[4:8], D[8:]
    return matrix([row[:3] for row in rows]), matrix([row[3] for row in rows])


# symmetric matrices, in rationals


Rows = tuple[tuple[mpq, ...], ...]


@_once
def _symmetric(*lower_triangle: Number) -> Rows:
    n, entries = isqrt(2 * len(lower_triangle)), list(map(rational, lower_triangle))
    return tuple(tuple(entries[max(i, j) * (max(i, j) + 1) // 2 + min(i, j)] for j in range(n))
                 for i in range(n))


@lru_cache(maxsize=64)
def _determinant(A: Rows) -> mpq:
    """det A by elimination; rows are exchanged where a pivot is zero."""
    rest, product = [list(row) for row in A], mpq(1)
    while rest:
        place = next((i for i, row in enumerate(rest) if row[0]), None)
        if place is None:
            return mpq(0)
        first = rest.pop(place)
        product *= first[0] * (-1)**place
        rest = [[x - row[0] * y / first[0] for x, y in zip(row[1:], first[1:], strict=True)]
                for row in rest]
    return product


def _leading(A: Rows, n: int) -> mpq:
    return _determinant(tuple(row[:n] for row in A[:n]))


def factor(i: Number, j: Number, *lower_triangle: Number) -> Number:
    """Entry (i, j) of L, or of D on the diagonal, as a quotient of minors.

    d_j is the leading minor of order j + 1 over that of order j; l_ij the leading minor of order
    j + 1 with row i in place of row j over that minor itself."""
    return _number(_entry(_symmetric(*lower_triangle), int(i), int(j)))


def _entry(A: Rows, i: int, j: int) -> mpq:
    minor = _determinant(tuple(A[row][:j + 1] for row in (*range(j), i)))
    return minor / (_leading(A, j) if i == j else _leading(A, j + 1))


def smallest_pivot(*lower_triangle: Number) -> Number:
    """min d_i / a_ii."""
    A = _symmetric(*lower_triangle)
    return _number(min(_entry(A, i, i) / A[i][i] for i in range(len(A))))


def solution(i: Number, *numbers: Number) -> Number:
    """Component i of A^-1 b by Cramer's rule: b, then A's lower triangle."""
    n = next(n for n in (3, 6) if len(numbers) == n + n * (n + 1) // 2)
    b, A = map(rational, numbers[:n]), _symmetric(*numbers[n:])
    replaced = tuple((*row[:int(i)], x, *row[int(i) + 1:]) for x, row in zip(b, A, strict=True))
    return _number(_determinant(replaced) / _determinant(A))


def inverse(i: Number, j: Number, *R: Number) -> Number:
    """Entry (i, j) of R^-1: a cofactor over the determinant."""
    rows = tuple(tuple(map(rational, R[n:n + 3])) for n in (0, 3, 6))
    minor = tuple(tuple(x for m, x in enumerate(row) if m != int(i))
                  for n, row in enumerate(rows) if n != int(j))
    return _number(_determinant(minor) * (-1)**int(i + j) / _determinant(rows))


@_once
def _orthonormal_rows(*R: Number) -> matrix:
    rows = [matrix(R[n:n + 3]) for n in (0, 3, 6)]
    for i, row in enumerate(rows):
        for other in rows[:i]:
            row = row - mpmath.fdot(other, row) * other
        rows[i] = row / mpmath.norm(row)
    return matrix([list(row) for row in rows])


def orthonormal_rows(i: Number, j: Number, *R: Number) -> Number:
    """Entry (i, j) of the Gram–Schmidt rows: each less its projections on earlier ones, over its
    length."""
    return _orthonormal_rows(*R)[int(i), int(j)]


@_once
def _jacobi(*numbers: Number) -> tuple[matrix, matrix]:
    A, V = (matrix([numbers[i:i + 3] for i in range(start, start + 9, 3)]) for start in (0, 9))
    A = matrix([[A[max(i, j), min(i, j)] for j in range(3)] for i in range(3)])
    angle = mpmath.atan2(2 * A[0, 1], A[1, 1] - A[0, 0]) / 2
    if abs(angle) > mpmath.pi / 4 or angle == -mpmath.pi / 4:
        angle -= mpmath.sign(angle) * mpmath.pi / 2
    s, c = mpmath.sin(angle), mpmath.cos(angle)
    J = matrix([[s, 0, c], [c, 0, -s], [0, 1, 0]])  # its columns: y, z, x
    return J.T * A * J, V * J


def jacobi(k: Number, i: Number, j: Number, *numbers: Number) -> Number:
    """An entry of J^T A J (k = 0) or V J (k = 1); J rotates by half the angle of the vector
    (A_yy - A_xx, 2 A_xy), by at most π/4, and permutes the axes."""
    return _jacobi(*numbers)[int(k)][int(i), int(j)]


@_once
def _nearest(*A: Number) -> matrix:
    U, s, V = mpmath.svd_r(matrix([A[:3], A[3:6], A[6:]]))
    return U * mpmath.diag([1, 1, mpmath.sign(mpmath.det(U) * mpmath.det(V))]) * V


def nearest_rotation(i: Number, j: Number, *A: Number) -> Number:
    """An entry of the rotation nearest to A, by singular values; NaN for A = 0."""
    return _nearest(*A)[int(i), int(j)] if any(A) else mpmath.nan


def largest(*numbers: Number) -> Number:
    """The largest absolute value."""
    return max(map(abs, numbers))


def rational(x: Number) -> mpq:
    """x as a rational, exactly: mpmath's numbers are binary fractions."""
    return mpq(*mpmath.libmp.to_rational(x._mpf_))


def _number(x: mpq) -> Number:
    return mpmath.mpf(int(x.numerator)) / int(x.denominator)


SPECIAL: dict[str, Callable[..., Number]] = {
    f.__name__: f for f in (g, b, quaternion_of, quaternion_log, slerp, interpolated, factor,
                            smallest_pivot, solution, inverse, orthonormal_rows,
                            jacobi, nearest_rotation, largest)}
