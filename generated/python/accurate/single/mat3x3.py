# Made by `coscrew generate`; changes are overwritten.
# SPDX-License-Identifier: MIT
# coscrew 0.1.0.  Copyright (c) 2026 The coscrew authors.
"""3×3 matrices: rotations, and matrices in general.

In single precision, accurate tier.
"""

from coscrew._kernel import wide_kernel as kernel


@kernel("(3,3)->()")
def mat3x3_determinant(R):
    """det R.

    (3,3)->().  R: rotation or other 3×3 matrix; det: number.
    9 mul, 5 add.  Error <= u |result| + 5/32 u^2 S, S the sum of the |terms| of the expanded
    formula; barring over- and underflow.
    """
    R_00, R_01, R_02, R_10, R_11, R_12, R_20, R_21, R_22 = R
    n_0 = R_11 * R_22 - R_12 * R_21
    n_1 = R_02 * R_21 - R_01 * R_22
    n_2 = R_01 * R_12 - R_02 * R_11
    det = R_00 * n_0 + R_10 * n_1 + R_20 * n_2
    return det
