# Made by `coscrew generate`; changes are overwritten.
# SPDX-License-Identifier: MIT
# coscrew 0.2.0.  Copyright (c) 2026 The coscrew authors.
"""Displacements D = [R | t].

In single precision, plain tier.
"""

from coscrew._kernel import single_kernel as kernel


@kernel("(3,3),(3)->(3,4)")
def SE3_fromRt(R, t):
    """D = [R | t].

    (3,3),(3)->(3,4).  R: rotation or other 3×3 matrix; t: vector; D: displacement [R | t], R
    rotation, t in m.
    No arithmetic.  Exact.
    """
    R_00, R_01, R_02, R_10, R_11, R_12, R_20, R_21, R_22 = R
    t_0, t_1, t_2 = t
    return (R_00, R_01, R_02, t_0, R_10, R_11, R_12, t_1, R_20, R_21, R_22, t_2)


@kernel("(3,4)->(3,4)")
def SE3_copy(D):
    """Do = D.

    (3,4)->(3,4).  D, Do: displacement [R | t], R rotation, t in m.
    No arithmetic.  Exact.
    """
    D_00, D_01, D_02, D_03, D_10, D_11, D_12, D_13, D_20, D_21, D_22, D_23 = D
    return (D_00, D_01, D_02, D_03, D_10, D_11, D_12, D_13, D_20, D_21, D_22, D_23)


@kernel("(3,4)->(3,4)")
def SE3_setIdentity(self):
    """self = [I | 0].

    (3,4)->(3,4).  self: displacement [R | t], R rotation, t in m.
    No arithmetic.  Exact.
    """
    return (1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0)


@kernel("(3,4)->(3)")
def SE3_getTranslation(D):
    """t of D = [R | t].

    (3,4)->(3).  D: displacement [R | t], R rotation, t in m; t: vector.
    No arithmetic.  Exact.
    """
    D_00, D_01, D_02, D_03, D_10, D_11, D_12, D_13, D_20, D_21, D_22, D_23 = D
    return (D_03, D_13, D_23)


@kernel("(3,4)->(3,3)")
def SE3_getRotation(D):
    """R of D = [R | t].

    (3,4)->(3,3).  D: displacement [R | t], R rotation, t in m; R: rotation or other 3×3 matrix.
    No arithmetic.  Exact.
    """
    D_00, D_01, D_02, D_03, D_10, D_11, D_12, D_13, D_20, D_21, D_22, D_23 = D
    return (D_00, D_01, D_02, D_10, D_11, D_12, D_20, D_21, D_22)


@kernel("(3,4)->(3,4)")
def SE3_invert(self):
    """self = self^-1 = [R^T | -R^T t].

    (3,4)->(3,4).  self: displacement [R | t], R rotation, t in m.
    9 mul, 6 add, 3 neg.  Error <= u |result| + (R: 0, t: 2) u S, S the sum of the |terms| of
    the expanded formula; barring over- and underflow.
    """
    (self_00, self_01, self_02, self_03, self_10, self_11, self_12, self_13, self_20, self_21,
        self_22, self_23) = self
    self_03_new = -(self_00 * self_03 + self_10 * self_13 + self_20 * self_23)
    self_13_new = -(self_01 * self_03 + self_11 * self_13 + self_21 * self_23)
    self_23_new = -(self_02 * self_03 + self_12 * self_13 + self_22 * self_23)
    return (self_00, self_10, self_20, self_03_new, self_01, self_11, self_21, self_13_new, self_02,
        self_12, self_22, self_23_new)


@kernel("(3,4)->(4,4)")
def SE3_toMat4x4(D):
    """M = [[R, t], [0, 1]] of D = [R | t].

    (3,4)->(4,4).  D: displacement [R | t], R rotation, t in m; M: 4×4 matrix.
    No arithmetic.  Exact.
    """
    D_00, D_01, D_02, D_03, D_10, D_11, D_12, D_13, D_20, D_21, D_22, D_23 = D
    return (D_00, D_01, D_02, D_03, D_10, D_11, D_12, D_13, D_20, D_21, D_22, D_23, 0, 0, 0, 1)


@kernel("(3,4)->(3,4)")
def SE3_inverted(D):
    """Do = D^-1 = [R^T | -R^T t].

    (3,4)->(3,4).  D, Do: displacement [R | t], R rotation, t in m.
    9 mul, 6 add, 3 neg.  Error <= u |result| + (R: 0, t: 2) u S, S the sum of the |terms| of
    the expanded formula; barring over- and underflow.
    """
    D_00, D_01, D_02, D_03, D_10, D_11, D_12, D_13, D_20, D_21, D_22, D_23 = D
    Do_03 = -(D_00 * D_03 + D_10 * D_13 + D_20 * D_23)
    Do_13 = -(D_01 * D_03 + D_11 * D_13 + D_21 * D_23)
    Do_23 = -(D_02 * D_03 + D_12 * D_13 + D_22 * D_23)
    return (D_00, D_10, D_20, Do_03, D_01, D_11, D_21, Do_13, D_02, D_12, D_22, Do_23)
