# Made by `coscrew generate`; changes are overwritten.
# SPDX-License-Identifier: MIT
# coscrew 0.2.0.  Copyright (c) 2026 The coscrew authors.
"""4×4 matrices: displacements [[R, t], [0, 1]] and other maps of homogeneous coordinates.

In single precision, plain tier.
"""

from coscrew._kernel import single_kernel as kernel


@kernel("(3,4)->(4,4)")
def mat4x4_fromSE3(D):
    """M = [[R, t], [0, 1]] of D = [R | t].

    (3,4)->(4,4).  D: displacement [R | t], R rotation, t in m; M: 4×4 matrix.
    No arithmetic.  Exact.
    """
    D_00, D_01, D_02, D_03, D_10, D_11, D_12, D_13, D_20, D_21, D_22, D_23 = D
    return (D_00, D_01, D_02, D_03, D_10, D_11, D_12, D_13, D_20, D_21, D_22, D_23, 0, 0, 0, 1)


@kernel("(3,3),(3)->(4,4)")
def mat4x4_fromRt(R, t):
    """M = [[R, t], [0, 1]].

    (3,3),(3)->(4,4).  R: rotation or other 3×3 matrix; t: vector; M: 4×4 matrix.
    No arithmetic.  Exact.
    """
    R_00, R_01, R_02, R_10, R_11, R_12, R_20, R_21, R_22 = R
    t_0, t_1, t_2 = t
    return (R_00, R_01, R_02, t_0, R_10, R_11, R_12, t_1, R_20, R_21, R_22, t_2, 0, 0, 0, 1)


@kernel("(4,4)->(3,4)")
def mat4x4_toSE3(M):
    """D = [R | t], the first three rows of M.

    (4,4)->(3,4).  M: 4×4 matrix; D: displacement [R | t], R rotation, t in m.
    No arithmetic.  Exact.
    """
    (M_00, M_01, M_02, M_03, M_10, M_11, M_12, M_13, M_20, M_21, M_22, M_23, M_30, M_31, M_32,
        M_33) = M
    return (M_00, M_01, M_02, M_03, M_10, M_11, M_12, M_13, M_20, M_21, M_22, M_23)


@kernel("(4,4)->(4,4)")
def mat4x4_setIdentity(self):
    """self = I.

    (4,4)->(4,4).  self: 4×4 matrix.
    No arithmetic.  Exact.
    """
    return (1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1)


@kernel("(4,4)->(3)")
def mat4x4_getTranslation(M):
    """t, the first three entries of the last column of M.

    (4,4)->(3).  M: 4×4 matrix; t: vector.
    No arithmetic.  Exact.
    """
    (M_00, M_01, M_02, M_03, M_10, M_11, M_12, M_13, M_20, M_21, M_22, M_23, M_30, M_31, M_32,
        M_33) = M
    return (M_03, M_13, M_23)
