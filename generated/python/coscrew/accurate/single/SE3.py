# Made by `coscrew generate`; changes are overwritten.
# SPDX-License-Identifier: MIT
# coscrew 0.2.0.  Copyright (c) 2026 The coscrew authors.
"""Displacements D = [R | t].

In single precision, accurate tier.
"""

from coscrew._kernel import wide_kernel as kernel


@kernel("(3,4)->(3,4)")
def SE3_invert(self):
    """self = self^-1 = [R^T | -R^T t].

    (3,4)->(3,4).  self: displacement [R | t], R rotation, t in m.
    9 mul, 6 add, 3 neg.  Error <= u |result| + (R: 0, t: 3/32) u^2 S, S the sum of the |terms|
    of the expanded formula; barring over- and underflow.
    """
    (self_00, self_01, self_02, self_03, self_10, self_11, self_12, self_13, self_20, self_21,
        self_22, self_23) = self
    self_03_new = -(self_00 * self_03) - self_10 * self_13 - self_20 * self_23
    self_13_new = -(self_01 * self_03) - self_11 * self_13 - self_21 * self_23
    self_23_new = -(self_02 * self_03) - self_12 * self_13 - self_22 * self_23
    return (self_00, self_10, self_20, self_03_new, self_01, self_11, self_21, self_13_new, self_02,
        self_12, self_22, self_23_new)


@kernel("(3,4)->(3,4)")
def SE3_inverted(D):
    """Do = D^-1 = [R^T | -R^T t].

    (3,4)->(3,4).  D, Do: displacement [R | t], R rotation, t in m.
    9 mul, 6 add, 3 neg.  Error <= u |result| + (R: 0, t: 3/32) u^2 S, S the sum of the |terms|
    of the expanded formula; barring over- and underflow.
    """
    D_00, D_01, D_02, D_03, D_10, D_11, D_12, D_13, D_20, D_21, D_22, D_23 = D
    Do_03 = -(D_00 * D_03) - D_10 * D_13 - D_20 * D_23
    Do_13 = -(D_01 * D_03) - D_11 * D_13 - D_21 * D_23
    Do_23 = -(D_02 * D_03) - D_12 * D_13 - D_22 * D_23
    return (D_00, D_10, D_20, Do_03, D_01, D_11, D_21, Do_13, D_02, D_12, D_22, Do_23)
