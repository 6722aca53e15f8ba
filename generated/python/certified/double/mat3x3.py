# Made by `coscrew generate`; changes are overwritten.
# SPDX-License-Identifier: MIT
# coscrew 0.1.0.  Copyright (c) 2026 The coscrew authors.
"""3×3 matrices: rotations, and matrices in general.

In double precision, certified tier.
"""

from numpy import absolute
from coscrew._kernel import double_kernel as kernel


@kernel("(3,3)->(),()")
def mat3x3_determinant(R):
    """det R; |error of det| <= det_bound unless inf or NaN.

    (3,3)->(),().  R: rotation or other 3×3 matrix; det, det_bound: number.
    13 mul, 14 add, 9 abs.
    """
    R_00, R_01, R_02, R_10, R_11, R_12, R_20, R_21, R_22 = R
    n_0a = R_11 * R_22
    n_0b = R_12 * R_21
    n_0 = n_0a - n_0b
    n_1a = R_02 * R_21
    n_1b = R_01 * R_22
    n_1 = n_1a - n_1b
    n_2a = R_01 * R_12
    n_2b = R_02 * R_11
    n_2 = n_2a - n_2b
    det = R_00 * n_0 + R_10 * n_1 + R_20 * n_2
    n_0_size = absolute(n_0a) + absolute(n_0b)
    n_1_size = absolute(n_1a) + absolute(n_1b)
    n_2_size = absolute(n_2a) + absolute(n_2b)
    det_a_size = absolute(R_00) * (n_0_size + 2.004168360008973e-292)
    det_c_size = det_a_size + absolute(R_10) * (n_1_size + 2.004168360008973e-292)
    det_size = det_c_size + absolute(R_20) * (n_2_size + 2.004168360008973e-292)
    det_error_bound = 5.551115123125785e-16 * (det_size + 2.004168360008973e-292)
    return (det, det_error_bound)
