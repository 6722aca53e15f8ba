"""Nearest rotations by singular values, with as many digits as mpmath works with."""

import mpmath
import numpy as np
from mpmath import mpf


def nearest(A: np.ndarray) -> tuple[mpmath.matrix, mpf]:
    """The rotation, and (s2 ± s3) / s1."""
    U, s, V = mpmath.svd_r(mpmath.matrix(A.tolist()))
    sign = mpmath.sign(mpmath.det(U) * mpmath.det(V))
    return U * mpmath.diag([1, 1, sign]) * V, (s[1] + sign * s[2]) / s[0]


def off_orthonormal(R: np.ndarray) -> mpf:
    exact = mpmath.matrix(R.tolist())
    assert mpmath.det(exact) > 0.9
    return max(map(abs, exact.T * exact - mpmath.eye(3)))
