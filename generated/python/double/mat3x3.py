# Made by `coscrew generate`; changes are overwritten.
# SPDX-License-Identifier: MIT
# coscrew 0.1.0.  Copyright (c) 2026 The coscrew authors.
"""3×3 matrices: rotations, and matrices in general.

In double precision, plain tier.
"""

from coscrew._kernel import double_kernel as kernel


@kernel("(3,3)->(3,3)")
def mat3x3_copy(R):
    """Ro = R.

    (3,3)->(3,3).  R, Ro: rotation or other 3×3 matrix.
    No arithmetic.  Exact.
    """
    R_00, R_01, R_02, R_10, R_11, R_12, R_20, R_21, R_22 = R
    return (R_00, R_01, R_02, R_10, R_11, R_12, R_20, R_21, R_22)


@kernel("(3,3)->(3,3)")
def mat3x3_setIdentity(self):
    """self = I.

    (3,3)->(3,3).  self: rotation or other 3×3 matrix.
    No arithmetic.  Exact.
    """
    return (1, 0, 0, 0, 1, 0, 0, 0, 1)


@kernel("(3),(3),(3)->(3,3)")
def mat3x3_setFromVectors(x, y, z):
    """R = [x y z], the columns.

    (3),(3),(3)->(3,3).  x, y, z: vector; R: rotation or other 3×3 matrix.
    No arithmetic.  Exact.
    """
    x_0, x_1, x_2 = x
    y_0, y_1, y_2 = y
    z_0, z_1, z_2 = z
    return (x_0, y_0, z_0, x_1, y_1, z_1, x_2, y_2, z_2)


@kernel("(3)->(3,3)")
def skew(v):
    """Ro = v~, the matrix with v~ y = v × y.

    (3)->(3,3).  v: vector; Ro: rotation or other 3×3 matrix.
    3 neg.  Exact.
    """
    v_0, v_1, v_2 = v
    Ro_01 = -v_2
    Ro_12 = -v_0
    Ro_20 = -v_1
    return (0, Ro_01, v_1, v_2, 0, Ro_12, Ro_20, v_0, 0)


@kernel("(3,3)->(3,3)")
def mat3x3_transpose(self):
    """self = self^T, the inverse of a rotation.

    (3,3)->(3,3).  self: rotation or other 3×3 matrix.
    No arithmetic.  Exact.
    """
    self_00, self_01, self_02, self_10, self_11, self_12, self_20, self_21, self_22 = self
    return (self_00, self_10, self_20, self_01, self_11, self_21, self_02, self_12, self_22)


@kernel("(3,3)->(3,3)")
def mat3x3_transposed(R):
    """Ro = R^T, the inverse of a rotation.

    (3,3)->(3,3).  R, Ro: rotation or other 3×3 matrix.
    No arithmetic.  Exact.
    """
    R_00, R_01, R_02, R_10, R_11, R_12, R_20, R_21, R_22 = R
    return (R_00, R_10, R_20, R_01, R_11, R_21, R_02, R_12, R_22)


@kernel("(3,3)->()")
def mat3x3_determinant(R):
    """det R.

    (3,3)->().  R: rotation or other 3×3 matrix; det: number.
    9 mul, 5 add.  Error <= u |result| + 4 u S, S the sum of the |terms| of the expanded
    formula; barring over- and underflow.
    """
    R_00, R_01, R_02, R_10, R_11, R_12, R_20, R_21, R_22 = R
    n_0 = R_11 * R_22 - R_12 * R_21
    n_1 = R_02 * R_21 - R_01 * R_22
    n_2 = R_01 * R_12 - R_02 * R_11
    det = R_00 * n_0 + R_10 * n_1 + R_20 * n_2
    return det
