# Made by `coscrew generate`; changes are overwritten.
# SPDX-License-Identifier: MIT
# coscrew 0.1.0.  Copyright (c) 2026 The coscrew authors.
"""3×3 matrices: rotations, and matrices in general.

In double precision, accurate tier.
"""

from coscrew._exact import product_rest
from coscrew._kernel import double_kernel as kernel


@kernel("(3,3)->()")
def mat3x3_determinant(R):
    """det R.

    (3,3)->().  R: rotation or other 3×3 matrix; det: number.
    12 mul, 26 add, 9 product rest.  Error <= u |result| + 28 u^2 S, S the sum of the |terms| of
    the expanded formula; barring over- and underflow.
    """
    R_00, R_01, R_02, R_10, R_11, R_12, R_20, R_21, R_22 = R
    n_0a = R_11 * R_22
    n_0b = R_12 * R_21
    n_0 = n_0a - n_0b
    n_0_right = n_0a - n_0
    n_0_left_rest = product_rest(R_11, R_22, n_0a, n_0 + n_0_right)
    n_0_lo = n_0_left_rest - product_rest(R_12, R_21, n_0b, n_0_right)
    n_1a = R_02 * R_21
    n_1b = R_01 * R_22
    n_1 = n_1a - n_1b
    n_1_right = n_1a - n_1
    n_1_left_rest = product_rest(R_02, R_21, n_1a, n_1 + n_1_right)
    n_1_lo = n_1_left_rest - product_rest(R_01, R_22, n_1b, n_1_right)
    n_2a = R_01 * R_12
    n_2b = R_02 * R_11
    n_2 = n_2a - n_2b
    n_2_right = n_2a - n_2
    n_2_left_rest = product_rest(R_01, R_12, n_2a, n_2 + n_2_right)
    n_2_lo = n_2_left_rest - product_rest(R_02, R_11, n_2b, n_2_right)
    det_a = R_00 * n_0
    det_a_cross2 = R_00 * n_0_lo
    det_b = R_10 * n_1
    det_b_cross2 = R_10 * n_1_lo
    det_c = det_a + det_b
    det_c_right = det_c - det_a
    det_c_left_rest = product_rest(R_00, n_0, det_a, det_c - det_c_right)
    det_c_cross = det_a_cross2 + det_b_cross2
    det_c_lo1 = det_c_left_rest + product_rest(R_10, n_1, det_b, det_c_right)
    det_c_lo = det_c_lo1 + det_c_cross
    det_d = R_20 * n_2
    det_d_cross2 = R_20 * n_2_lo
    det = det_c + det_d
    det_right = det - det_c
    det_lo1 = det_c - (det - det_right) + product_rest(R_20, n_2, det_d, det_right)
    det_lo2 = det_lo1 + det_d_cross2
    det_lo = det_lo2 + det_c_lo
    det_rounded = det + det_lo
    return det_rounded
