"""Exponentials, logarithms, Jacobians and quaternions in mpmath's precision.

Written from their definitions (power series of exp, of Σ ad^k / (k+1)!, matrix inversion, the
eigenvector of Bar-Itzhack's matrix), not from the closed forms the kernels evaluate.  Arguments and
results are mpmath matrices, columns for vectors, and numbers.
"""

from collections.abc import Callable
from typing import TypeAlias

import gmpy2  # the series are summed in its numbers, ten times as fast as in mpmath's
import mpmath as mp
import numpy as np

Matrix: TypeAlias = mp.matrix
Truth: TypeAlias = Matrix | mp.mpf | tuple[mp.mpf, Matrix]
DIGITS = 60  # enough for angles and their differences from π down to 1e-30


def skew(x: Matrix) -> Matrix:
    """x~ with x~ y = x × y."""
    return mp.matrix([[0, -x[2], x[1]], [x[2], 0, -x[0]], [-x[1], x[0], 0]])


def norm(x: Matrix) -> mp.mpf:
    """sqrt(x·x)."""
    return mp.sqrt(mp.fsum(c * c for c in x))


def exponential_series(A: Matrix, first: int = 0) -> Matrix:
    """Σ A^k / (k + first)!: exp A for first = 0, the left Jacobian J for first = 1.  For a large A
    from A / 2^n by J(2 A) = J(A) (exp A + 1) / 2, exp 2 A = (exp A)²."""
    halvings = max(0, mp.frexp(mp.mnorm(A, mp.inf))[1] - 7)
    if not halvings:
        return _series(A, first)
    with mp.extradps(halvings):
        exp, J = (_series(A / 2**halvings, n) for n in (0, first))
        for _ in range(halvings):
            J = J * (exp + mp.eye(A.rows)) / 2
            exp = exp * exp
    return J if first else exp


def _series(A: Matrix, first: int) -> Matrix:
    cancelling = 400  # bits: more than the largest term has for angles up to 200
    with gmpy2.context(precision=mp.mp.prec + cancelling):
        a = np.array([[to_mpfr(x) for x in row] for row in A.tolist()])
        total = term = np.array(np.eye(A.rows), dtype=object) / gmpy2.mpfr(gmpy2.fac(first))
        k, small = 0, gmpy2.exp2(-mp.mp.prec - 8)
        while k < 3 or k % 8 or np.abs(term).max() > small * np.abs(total).max():
            k += 1
            term = term @ a / (k + first)
            total = total + term
    return mp.matrix([list(map(to_mpf, row)) for row in total])


def to_mpf(x: gmpy2.mpfr) -> mp.mpf:
    """The number, in mpmath's precision."""
    if not gmpy2.is_finite(x):
        return mp.mpf(float(x))
    mantissa, exponent = x.as_mantissa_exp()
    return mp.mpf(int(mantissa)) * mp.mpf(2)**int(exponent)


def to_mpfr(x: mp.mpf) -> gmpy2.mpfr:
    """The number, in the context's precision."""
    sign, mantissa, exponent, _ = mp.mpf(x)._mpf_
    return gmpy2.mul_2exp(gmpy2.mpfr((-1)**sign * mantissa), exponent) if exponent >= 0 else \
        gmpy2.div_2exp(gmpy2.mpfr((-1)**sign * mantissa), -exponent)


def ad(s: Matrix) -> Matrix:
    """[[ω~, v~], [0, ω~]]."""
    return _blocks(skew(s[3:6]), skew(s[0:3]), skew(s[3:6]))


def _blocks(upper: Matrix, corner: Matrix, lower: Matrix) -> Matrix:
    A = mp.zeros(6)
    for i in range(3):
        for j in range(3):
            A[i, j], A[i, j + 3], A[i + 3, j + 3] = upper[i, j], corner[i, j], lower[i, j]
    return A


def SE3_exp(s: Matrix) -> Matrix:
    """[exp ω~ | Σ ω~^k v / (k+1)!]."""
    W = skew(s[3:6])
    return hstack(exponential_series(W), exponential_series(W, 1) * s[0:3])


def hstack(R: Matrix, t: Matrix) -> Matrix:
    """[R | t]."""
    return mp.matrix([[*(R[i, j] for j in range(3)), t[i]] for i in range(3)])


def nearest_quaternion(R: Matrix) -> Matrix:
    """The quaternion of the rotation nearest to R: the eigenvector of the largest eigenvalue of
    Bar-Itzhack's symmetric matrix.  Source: I. Y. Bar-Itzhack, J. Guidance 23 (2000) 1085."""
    K = mp.matrix([
        [R[0, 0] - R[1, 1] - R[2, 2], R[1, 0] + R[0, 1], R[0, 2] + R[2, 0], R[2, 1] - R[1, 2]],
        [R[1, 0] + R[0, 1], R[1, 1] - R[0, 0] - R[2, 2], R[2, 1] + R[1, 2], R[0, 2] - R[2, 0]],
        [R[0, 2] + R[2, 0], R[2, 1] + R[1, 2], R[2, 2] - R[0, 0] - R[1, 1], R[1, 0] - R[0, 1]],
        [R[2, 1] - R[1, 2], R[0, 2] - R[2, 0], R[1, 0] - R[0, 1], R[0, 0] + R[1, 1] + R[2, 2]]])
    values, vectors = mp.eigsy(K)
    best = max(range(4), key=lambda i: values[i])
    q = vectors[:, best]
    return q if q[3] >= 0 else -q


def vector_of(q: Matrix) -> Matrix:
    """θ v / |v| with θ = 2 atan2(|v|, |w|), any multiple of a quaternion."""
    if q[3] < 0:
        q = -q
    v = q[0:3]
    n = norm(v)
    return v * (2 * mp.atan2(n, q[3]) / n) if n else mp.zeros(3, 1)


def product(p: Matrix, q: Matrix) -> Matrix:
    """The product of quaternions (v; w)."""
    v = p[3] * q[0:3] + q[3] * p[0:3] + skew(p[0:3]) * q[0:3]
    w = p[3] * q[3] - mp.fsum(x * y for x, y in zip(p[0:3], q[0:3], strict=True))
    return mp.matrix([*v, w])


def conjugate(q: Matrix) -> Matrix:
    return mp.matrix([-q[0], -q[1], -q[2], q[3]])


def quaternion_exp(v: Matrix) -> Matrix:
    """(v/θ sin θ/2; cos θ/2)."""
    n = norm(v)
    return mp.matrix([*(v * (mp.sin(n / 2) / n) if n else v / 2), mp.cos(n / 2)])


def matrix_of(q: Matrix) -> Matrix:
    """(w + v~)² + v v^T, over q·q."""
    W = q[3] * mp.eye(3) + skew(q[0:3])
    return (W * W + q[0:3] * q[0:3].T) / mp.fsum(c * c for c in q)


def SE3_log(D: Matrix) -> Matrix:
    """(J_l^-1(ω) t; ω), J_l by its series."""
    w = vector_of(nearest_quaternion(D[0:3, 0:3]))
    v = mp.lu_solve(exponential_series(skew(w), 1), D[0:3, 3])
    return mp.matrix([*v, *w])


def compose(D1: Matrix, D2: Matrix) -> Matrix:
    """[R1 R2 | R1 t2 + t1]."""
    return hstack(D1[0:3, 0:3] * D2[0:3, 0:3], D1[0:3, 0:3] * D2[0:3, 3] + D1[0:3, 3])


def inverse(D: Matrix) -> Matrix:
    """[R^T | -R^T t]."""
    return hstack(D[0:3, 0:3].T, -(D[0:3, 0:3].T * D[0:3, 3]))


def slerp(p: Matrix, q: Matrix, k: mp.mpf) -> Matrix:
    """p (p* q)^k along the shorter arc."""
    return product(p, quaternion_exp(k * vector_of(product(conjugate(p), q))))


TRUTHS: dict[str, Callable[..., Truth]] = {
    "SO3_exp": lambda v: exponential_series(skew(v)),
    "SO3_log": lambda R: vector_of(nearest_quaternion(R)),
    "SO3_leftJacobian": lambda v: exponential_series(skew(v), 1),
    "SO3_rightJacobian": lambda v: exponential_series(-skew(v), 1),
    "SO3_leftJacobianInverse": lambda v: exponential_series(skew(v), 1) ** -1,
    "SO3_rightJacobianInverse": lambda v: exponential_series(-skew(v), 1) ** -1,
    "mat3x3_from_axis_angle": lambda a, angle: (
        mp.eye(3) + mp.sin(angle) * skew(a) + (1 - mp.cos(angle)) * skew(a)**2),
    "SE3_exp": SE3_exp,
    "SE3_log": SE3_log,
    "SE3_leftJacobian": lambda s: exponential_series(ad(s), 1),
    "SE3_rightJacobian": lambda s: exponential_series(-ad(s), 1),
    "SE3_leftJacobianInverse": lambda s: exponential_series(ad(s), 1) ** -1,
    "SE3_rightJacobianInverse": lambda s: exponential_series(-ad(s), 1) ** -1,
    "SE3_interpolated": lambda D1, D2, k: compose(
        D1, SE3_exp(k * SE3_log(compose(inverse(D1), D2)))),
    "mat3x3_from_quaternion": matrix_of,
    "quaternion_from_mat3x3": nearest_quaternion,
    "quaternion_from_axis_angle": lambda a, angle: mp.matrix(
        [*(mp.sin(angle / 2) * a), mp.cos(angle / 2)]),
    "quaternion_exp": quaternion_exp,
    "quaternion_log": vector_of,
    "quaternion_interpolated": slerp,
    "axis_angle_from_quaternion": lambda q: _axis_angle(vector_of(q)),
    "axis_angle_from_mat3x3": lambda R: _axis_angle(vector_of(nearest_quaternion(R))),
}


def _axis_angle(v: Matrix) -> tuple[mp.mpf, Matrix]:
    n = norm(v)
    return n, v / n if n else mp.matrix([1, 0, 0])


# A rotation by π has two equally valid rotation vectors, axes and quaternions.


def the_long_way(v: Matrix) -> Matrix:
    """The rotation vector of length 2π - θ of the same rotation."""
    return v * (1 - 2 * mp.pi / norm(v))


def _screw_the_long_way(s: Matrix) -> Matrix:
    w = the_long_way(s[3:6])
    t = SE3_exp(s)[0:3, 3]
    return mp.matrix([*mp.lu_solve(exponential_series(skew(w), 1), t), *w])


OTHERS: dict[str, tuple[Callable[..., mp.mpf], Callable[..., Truth]]] = {
    **dict.fromkeys(("SO3_log", "quaternion_log"), (norm, the_long_way)),
    "SE3_log": (lambda s: norm(s[3:6]), _screw_the_long_way),
    "quaternion_from_mat3x3": (lambda q: 2 * mp.acos(q[3]), lambda q: -q),
    **dict.fromkeys(("axis_angle_from_quaternion", "axis_angle_from_mat3x3"),
                    (lambda pair: pair[0], lambda pair: (2 * mp.pi - pair[0], -pair[1]))),
}
"""The angle of a truth; the other truth if that angle is π."""


def alternatives(name: str, truth: Truth, rounding: mp.mpf) -> list[Truth]:
    """The exact result; if the angle is π to within this rounding, also the other one."""
    if name in OTHERS:
        angle, other = OTHERS[name]
        if angle(truth) > mp.pi - rounding:
            return [truth, other(truth)]
    return [truth]
