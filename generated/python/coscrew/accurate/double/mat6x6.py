# Made by `coscrew generate`; changes are overwritten.
# SPDX-License-Identifier: MIT
# coscrew 0.2.0.  Copyright (c) 2026 The coscrew authors.
"""6×6 operators on screws and coscrews: [Ad], [Ad]*, [ad], [ad]*, and articulated inertias.

In double precision, accurate tier.
"""

from coscrew._exact import product_rest
from coscrew._kernel import double_kernel as kernel


@kernel("(3,3),(6,6)->(6,6)")
def mat6x6_rotated(R, M):
    """Mo = [Ad]*(R) M [Ad]^-1(R), the articulated inertia M rotated by R; M is symmetric, only its
    lower triangle is read.

    (3,3),(6,6)->(6,6).  R: rotation or other 3×3 matrix; M, Mo: 6×6 operator.
    207 mul, 564 add, 144 product rest.  Error <= u |result| + 37 u^2 S, S the sum of the
    |terms| of the expanded formula; barring over- and underflow.
    """
    R_00, R_01, R_02, R_10, R_11, R_12, R_20, R_21, R_22 = R
    (M_00, M_01, M_02, M_03, M_04, M_05, M_10, M_11, M_12, M_13, M_14, M_15, M_20, M_21, M_22, M_23,
        M_24, M_25, M_30, M_31, M_32, M_33, M_34, M_35, M_40, M_41, M_42, M_43, M_44, M_45, M_50,
        M_51, M_52, M_53, M_54, M_55) = M
    RM_0a = R_00 * M_00
    RM_0b = R_01 * M_10
    RM_0c = RM_0a + RM_0b
    RM_0c_right = RM_0c - RM_0a
    RM_0d = R_02 * M_20
    RM_0 = RM_0c + RM_0d
    RM_0_right = RM_0 - RM_0c
    RM_0c_lo = (product_rest(R_00, M_00, RM_0a, RM_0c - RM_0c_right)
        + product_rest(R_01, M_10, RM_0b, RM_0c_right))
    RM_1a = R_00 * M_10
    RM_1b = R_01 * M_11
    RM_1c = RM_1a + RM_1b
    RM_1c_right = RM_1c - RM_1a
    RM_1d = R_02 * M_21
    RM_1 = RM_1c + RM_1d
    RM_1_right = RM_1 - RM_1c
    RM_1c_lo = (product_rest(R_00, M_10, RM_1a, RM_1c - RM_1c_right)
        + product_rest(R_01, M_11, RM_1b, RM_1c_right))
    RM_2a = R_00 * M_20
    RM_2b = R_01 * M_21
    RM_2c = RM_2a + RM_2b
    RM_2c_right = RM_2c - RM_2a
    RM_2d = R_02 * M_22
    RM_2 = RM_2c + RM_2d
    RM_2_right = RM_2 - RM_2c
    RM_2c_lo = (product_rest(R_00, M_20, RM_2a, RM_2c - RM_2c_right)
        + product_rest(R_01, M_21, RM_2b, RM_2c_right))
    RM_3a = R_10 * M_00
    RM_3b = R_11 * M_10
    RM_3c = RM_3a + RM_3b
    RM_3c_right = RM_3c - RM_3a
    RM_3d = R_12 * M_20
    RM_3 = RM_3c + RM_3d
    RM_3_right = RM_3 - RM_3c
    RM_3c_lo = (product_rest(R_10, M_00, RM_3a, RM_3c - RM_3c_right)
        + product_rest(R_11, M_10, RM_3b, RM_3c_right))
    RM_3_lo = RM_3c - (RM_3 - RM_3_right) + product_rest(R_12, M_20, RM_3d, RM_3_right) + RM_3c_lo
    RM_4a = R_10 * M_10
    RM_4b = R_11 * M_11
    RM_4c = RM_4a + RM_4b
    RM_4c_right = RM_4c - RM_4a
    RM_4d = R_12 * M_21
    RM_4 = RM_4c + RM_4d
    RM_4_right = RM_4 - RM_4c
    RM_4c_lo = (product_rest(R_10, M_10, RM_4a, RM_4c - RM_4c_right)
        + product_rest(R_11, M_11, RM_4b, RM_4c_right))
    RM_4_lo = RM_4c - (RM_4 - RM_4_right) + product_rest(R_12, M_21, RM_4d, RM_4_right) + RM_4c_lo
    RM_5a = R_10 * M_20
    RM_5b = R_11 * M_21
    RM_5c = RM_5a + RM_5b
    RM_5c_right = RM_5c - RM_5a
    RM_5d = R_12 * M_22
    RM_5 = RM_5c + RM_5d
    RM_5_right = RM_5 - RM_5c
    RM_5c_lo = (product_rest(R_10, M_20, RM_5a, RM_5c - RM_5c_right)
        + product_rest(R_11, M_21, RM_5b, RM_5c_right))
    RM_5_lo = RM_5c - (RM_5 - RM_5_right) + product_rest(R_12, M_22, RM_5d, RM_5_right) + RM_5c_lo
    RM_6a = R_20 * M_00
    RM_6b = R_21 * M_10
    RM_6c = RM_6a + RM_6b
    RM_6c_right = RM_6c - RM_6a
    RM_6d = R_22 * M_20
    RM_6 = RM_6c + RM_6d
    RM_6_right = RM_6 - RM_6c
    RM_6c_lo = (product_rest(R_20, M_00, RM_6a, RM_6c - RM_6c_right)
        + product_rest(R_21, M_10, RM_6b, RM_6c_right))
    RM_6_lo = RM_6c - (RM_6 - RM_6_right) + product_rest(R_22, M_20, RM_6d, RM_6_right) + RM_6c_lo
    RM_7a = R_20 * M_10
    RM_7b = R_21 * M_11
    RM_7c = RM_7a + RM_7b
    RM_7c_right = RM_7c - RM_7a
    RM_7d = R_22 * M_21
    RM_7 = RM_7c + RM_7d
    RM_7_right = RM_7 - RM_7c
    RM_7c_lo = (product_rest(R_20, M_10, RM_7a, RM_7c - RM_7c_right)
        + product_rest(R_21, M_11, RM_7b, RM_7c_right))
    RM_7_lo = RM_7c - (RM_7 - RM_7_right) + product_rest(R_22, M_21, RM_7d, RM_7_right) + RM_7c_lo
    RM_8a = R_20 * M_20
    RM_8b = R_21 * M_21
    RM_8c = RM_8a + RM_8b
    RM_8c_right = RM_8c - RM_8a
    RM_8d = R_22 * M_22
    RM_8 = RM_8c + RM_8d
    RM_8_right = RM_8 - RM_8c
    RM_8c_lo = (product_rest(R_20, M_20, RM_8a, RM_8c - RM_8c_right)
        + product_rest(R_21, M_21, RM_8b, RM_8c_right))
    RM_8_lo = RM_8c - (RM_8 - RM_8_right) + product_rest(R_22, M_22, RM_8d, RM_8_right) + RM_8c_lo
    linear_0a = R_00 * RM_0
    linear_0b = R_01 * RM_1
    linear_0c = linear_0a + linear_0b
    linear_0c_right = linear_0c - linear_0a
    linear_0a_cross2 = (R_00
        * (RM_0c - (RM_0 - RM_0_right) + product_rest(R_02, M_20, RM_0d, RM_0_right) + RM_0c_lo))
    linear_0c_lo1 = (product_rest(R_00, RM_0, linear_0a, linear_0c - linear_0c_right)
        + product_rest(R_01, RM_1, linear_0b, linear_0c_right))
    linear_0d = R_02 * RM_2
    linear_0 = linear_0c + linear_0d
    linear_0_right = linear_0 - linear_0c
    linear_0_lo1 = (linear_0c - (linear_0 - linear_0_right)
        + product_rest(R_02, RM_2, linear_0d, linear_0_right))
    linear_0c_lo = (linear_0c_lo1
        + (linear_0a_cross2 + R_01
        * (RM_1c - (RM_1 - RM_1_right) + product_rest(R_02, M_21, RM_1d, RM_1_right) + RM_1c_lo)))
    linear_1a = R_00 * RM_3
    linear_1b = R_01 * RM_4
    linear_1c = linear_1a + linear_1b
    linear_1c_right = linear_1c - linear_1a
    linear_1c_lo1 = (product_rest(R_00, RM_3, linear_1a, linear_1c - linear_1c_right)
        + product_rest(R_01, RM_4, linear_1b, linear_1c_right))
    linear_1d = R_02 * RM_5
    linear_1 = linear_1c + linear_1d
    linear_1_right = linear_1 - linear_1c
    linear_1_lo2 = (linear_1c - (linear_1 - linear_1_right)
        + product_rest(R_02, RM_5, linear_1d, linear_1_right) + R_02 * RM_5_lo)
    linear_2a = R_10 * RM_3
    linear_2b = R_11 * RM_4
    linear_2c = linear_2a + linear_2b
    linear_2c_right = linear_2c - linear_2a
    linear_2c_lo1 = (product_rest(R_10, RM_3, linear_2a, linear_2c - linear_2c_right)
        + product_rest(R_11, RM_4, linear_2b, linear_2c_right))
    linear_2d = R_12 * RM_5
    linear_2 = linear_2c + linear_2d
    linear_2_right = linear_2 - linear_2c
    linear_2_lo2 = (linear_2c - (linear_2 - linear_2_right)
        + product_rest(R_12, RM_5, linear_2d, linear_2_right) + R_12 * RM_5_lo)
    linear_3a = R_00 * RM_6
    linear_3b = R_01 * RM_7
    linear_3c = linear_3a + linear_3b
    linear_3c_right = linear_3c - linear_3a
    linear_3c_lo1 = (product_rest(R_00, RM_6, linear_3a, linear_3c - linear_3c_right)
        + product_rest(R_01, RM_7, linear_3b, linear_3c_right))
    linear_3d = R_02 * RM_8
    linear_3 = linear_3c + linear_3d
    linear_3_right = linear_3 - linear_3c
    linear_3_lo2 = (linear_3c - (linear_3 - linear_3_right)
        + product_rest(R_02, RM_8, linear_3d, linear_3_right) + R_02 * RM_8_lo)
    linear_4a = R_10 * RM_6
    linear_4b = R_11 * RM_7
    linear_4c = linear_4a + linear_4b
    linear_4c_right = linear_4c - linear_4a
    linear_4c_lo1 = (product_rest(R_10, RM_6, linear_4a, linear_4c - linear_4c_right)
        + product_rest(R_11, RM_7, linear_4b, linear_4c_right))
    linear_4d = R_12 * RM_8
    linear_4 = linear_4c + linear_4d
    linear_4_right = linear_4 - linear_4c
    linear_4_lo2 = (linear_4c - (linear_4 - linear_4_right)
        + product_rest(R_12, RM_8, linear_4d, linear_4_right) + R_12 * RM_8_lo)
    linear_5a = R_20 * RM_6
    linear_5b = R_21 * RM_7
    linear_5c = linear_5a + linear_5b
    linear_5c_right = linear_5c - linear_5a
    linear_5c_lo1 = (product_rest(R_20, RM_6, linear_5a, linear_5c - linear_5c_right)
        + product_rest(R_21, RM_7, linear_5b, linear_5c_right))
    linear_5d = R_22 * RM_8
    linear_5 = linear_5c + linear_5d
    linear_5_right = linear_5 - linear_5c
    linear_5_lo2 = (linear_5c - (linear_5 - linear_5_right)
        + product_rest(R_22, RM_8, linear_5d, linear_5_right) + R_22 * RM_8_lo)
    RH_0a = R_00 * M_30
    RH_0b = R_01 * M_40
    RH_0c = RH_0a + RH_0b
    RH_0c_right = RH_0c - RH_0a
    RH_0d = R_02 * M_50
    RH_0 = RH_0c + RH_0d
    RH_0_right = RH_0 - RH_0c
    RH_0c_lo = (product_rest(R_00, M_30, RH_0a, RH_0c - RH_0c_right)
        + product_rest(R_01, M_40, RH_0b, RH_0c_right))
    RH_0_lo = RH_0c - (RH_0 - RH_0_right) + product_rest(R_02, M_50, RH_0d, RH_0_right) + RH_0c_lo
    RH_1a = R_00 * M_31
    RH_1b = R_01 * M_41
    RH_1c = RH_1a + RH_1b
    RH_1c_right = RH_1c - RH_1a
    RH_1d = R_02 * M_51
    RH_1 = RH_1c + RH_1d
    RH_1_right = RH_1 - RH_1c
    RH_1c_lo = (product_rest(R_00, M_31, RH_1a, RH_1c - RH_1c_right)
        + product_rest(R_01, M_41, RH_1b, RH_1c_right))
    RH_1_lo = RH_1c - (RH_1 - RH_1_right) + product_rest(R_02, M_51, RH_1d, RH_1_right) + RH_1c_lo
    RH_2a = R_00 * M_32
    RH_2b = R_01 * M_42
    RH_2c = RH_2a + RH_2b
    RH_2c_right = RH_2c - RH_2a
    RH_2d = R_02 * M_52
    RH_2 = RH_2c + RH_2d
    RH_2_right = RH_2 - RH_2c
    RH_2c_lo = (product_rest(R_00, M_32, RH_2a, RH_2c - RH_2c_right)
        + product_rest(R_01, M_42, RH_2b, RH_2c_right))
    RH_2_lo = RH_2c - (RH_2 - RH_2_right) + product_rest(R_02, M_52, RH_2d, RH_2_right) + RH_2c_lo
    RH_3a = R_10 * M_30
    RH_3b = R_11 * M_40
    RH_3c = RH_3a + RH_3b
    RH_3c_right = RH_3c - RH_3a
    RH_3d = R_12 * M_50
    RH_3 = RH_3c + RH_3d
    RH_3_right = RH_3 - RH_3c
    RH_3c_lo = (product_rest(R_10, M_30, RH_3a, RH_3c - RH_3c_right)
        + product_rest(R_11, M_40, RH_3b, RH_3c_right))
    RH_3_lo = RH_3c - (RH_3 - RH_3_right) + product_rest(R_12, M_50, RH_3d, RH_3_right) + RH_3c_lo
    RH_4a = R_10 * M_31
    RH_4b = R_11 * M_41
    RH_4c = RH_4a + RH_4b
    RH_4c_right = RH_4c - RH_4a
    RH_4d = R_12 * M_51
    RH_4 = RH_4c + RH_4d
    RH_4_right = RH_4 - RH_4c
    RH_4c_lo = (product_rest(R_10, M_31, RH_4a, RH_4c - RH_4c_right)
        + product_rest(R_11, M_41, RH_4b, RH_4c_right))
    RH_4_lo = RH_4c - (RH_4 - RH_4_right) + product_rest(R_12, M_51, RH_4d, RH_4_right) + RH_4c_lo
    RH_5a = R_10 * M_32
    RH_5b = R_11 * M_42
    RH_5c = RH_5a + RH_5b
    RH_5c_right = RH_5c - RH_5a
    RH_5d = R_12 * M_52
    RH_5 = RH_5c + RH_5d
    RH_5_right = RH_5 - RH_5c
    RH_5c_lo = (product_rest(R_10, M_32, RH_5a, RH_5c - RH_5c_right)
        + product_rest(R_11, M_42, RH_5b, RH_5c_right))
    RH_5_lo = RH_5c - (RH_5 - RH_5_right) + product_rest(R_12, M_52, RH_5d, RH_5_right) + RH_5c_lo
    RH_6a = R_20 * M_30
    RH_6b = R_21 * M_40
    RH_6c = RH_6a + RH_6b
    RH_6c_right = RH_6c - RH_6a
    RH_6d = R_22 * M_50
    RH_6 = RH_6c + RH_6d
    RH_6_right = RH_6 - RH_6c
    RH_6c_lo = (product_rest(R_20, M_30, RH_6a, RH_6c - RH_6c_right)
        + product_rest(R_21, M_40, RH_6b, RH_6c_right))
    RH_6_lo = RH_6c - (RH_6 - RH_6_right) + product_rest(R_22, M_50, RH_6d, RH_6_right) + RH_6c_lo
    RH_7a = R_20 * M_31
    RH_7b = R_21 * M_41
    RH_7c = RH_7a + RH_7b
    RH_7c_right = RH_7c - RH_7a
    RH_7d = R_22 * M_51
    RH_7 = RH_7c + RH_7d
    RH_7_right = RH_7 - RH_7c
    RH_7c_lo = (product_rest(R_20, M_31, RH_7a, RH_7c - RH_7c_right)
        + product_rest(R_21, M_41, RH_7b, RH_7c_right))
    RH_7_lo = RH_7c - (RH_7 - RH_7_right) + product_rest(R_22, M_51, RH_7d, RH_7_right) + RH_7c_lo
    RH_8a = R_20 * M_32
    RH_8b = R_21 * M_42
    RH_8c = RH_8a + RH_8b
    RH_8c_right = RH_8c - RH_8a
    RH_8d = R_22 * M_52
    RH_8 = RH_8c + RH_8d
    RH_8_right = RH_8 - RH_8c
    RH_8c_lo = (product_rest(R_20, M_32, RH_8a, RH_8c - RH_8c_right)
        + product_rest(R_21, M_42, RH_8b, RH_8c_right))
    RH_8_lo = RH_8c - (RH_8 - RH_8_right) + product_rest(R_22, M_52, RH_8d, RH_8_right) + RH_8c_lo
    coupling_0a = R_00 * RH_0
    coupling_0b = R_01 * RH_1
    coupling_0c = coupling_0a + coupling_0b
    coupling_0c_right = coupling_0c - coupling_0a
    coupling_0c_lo1 = (product_rest(R_00, RH_0, coupling_0a, coupling_0c - coupling_0c_right)
        + product_rest(R_01, RH_1, coupling_0b, coupling_0c_right))
    coupling_0d = R_02 * RH_2
    coupling_0 = coupling_0c + coupling_0d
    coupling_0_right = coupling_0 - coupling_0c
    coupling_0_lo2 = (coupling_0c - (coupling_0 - coupling_0_right)
        + product_rest(R_02, RH_2, coupling_0d, coupling_0_right) + R_02 * RH_2_lo)
    coupling_1a = R_10 * RH_0
    coupling_1b = R_11 * RH_1
    coupling_1c = coupling_1a + coupling_1b
    coupling_1c_right = coupling_1c - coupling_1a
    coupling_1c_lo1 = (product_rest(R_10, RH_0, coupling_1a, coupling_1c - coupling_1c_right)
        + product_rest(R_11, RH_1, coupling_1b, coupling_1c_right))
    coupling_1d = R_12 * RH_2
    coupling_1 = coupling_1c + coupling_1d
    coupling_1_right = coupling_1 - coupling_1c
    coupling_1_lo2 = (coupling_1c - (coupling_1 - coupling_1_right)
        + product_rest(R_12, RH_2, coupling_1d, coupling_1_right) + R_12 * RH_2_lo)
    coupling_2a = R_20 * RH_0
    coupling_2b = R_21 * RH_1
    coupling_2c = coupling_2a + coupling_2b
    coupling_2c_right = coupling_2c - coupling_2a
    coupling_2c_lo1 = (product_rest(R_20, RH_0, coupling_2a, coupling_2c - coupling_2c_right)
        + product_rest(R_21, RH_1, coupling_2b, coupling_2c_right))
    coupling_2d = R_22 * RH_2
    coupling_2 = coupling_2c + coupling_2d
    coupling_2_right = coupling_2 - coupling_2c
    coupling_2_lo2 = (coupling_2c - (coupling_2 - coupling_2_right)
        + product_rest(R_22, RH_2, coupling_2d, coupling_2_right) + R_22 * RH_2_lo)
    coupling_3a = R_00 * RH_3
    coupling_3b = R_01 * RH_4
    coupling_3c = coupling_3a + coupling_3b
    coupling_3c_right = coupling_3c - coupling_3a
    coupling_3c_lo1 = (product_rest(R_00, RH_3, coupling_3a, coupling_3c - coupling_3c_right)
        + product_rest(R_01, RH_4, coupling_3b, coupling_3c_right))
    coupling_3d = R_02 * RH_5
    coupling_3 = coupling_3c + coupling_3d
    coupling_3_right = coupling_3 - coupling_3c
    coupling_3_lo2 = (coupling_3c - (coupling_3 - coupling_3_right)
        + product_rest(R_02, RH_5, coupling_3d, coupling_3_right) + R_02 * RH_5_lo)
    coupling_4a = R_10 * RH_3
    coupling_4b = R_11 * RH_4
    coupling_4c = coupling_4a + coupling_4b
    coupling_4c_right = coupling_4c - coupling_4a
    coupling_4c_lo1 = (product_rest(R_10, RH_3, coupling_4a, coupling_4c - coupling_4c_right)
        + product_rest(R_11, RH_4, coupling_4b, coupling_4c_right))
    coupling_4d = R_12 * RH_5
    coupling_4 = coupling_4c + coupling_4d
    coupling_4_right = coupling_4 - coupling_4c
    coupling_4_lo2 = (coupling_4c - (coupling_4 - coupling_4_right)
        + product_rest(R_12, RH_5, coupling_4d, coupling_4_right) + R_12 * RH_5_lo)
    coupling_5a = R_20 * RH_3
    coupling_5b = R_21 * RH_4
    coupling_5c = coupling_5a + coupling_5b
    coupling_5c_right = coupling_5c - coupling_5a
    coupling_5c_lo1 = (product_rest(R_20, RH_3, coupling_5a, coupling_5c - coupling_5c_right)
        + product_rest(R_21, RH_4, coupling_5b, coupling_5c_right))
    coupling_5d = R_22 * RH_5
    coupling_5 = coupling_5c + coupling_5d
    coupling_5_right = coupling_5 - coupling_5c
    coupling_5_lo2 = (coupling_5c - (coupling_5 - coupling_5_right)
        + product_rest(R_22, RH_5, coupling_5d, coupling_5_right) + R_22 * RH_5_lo)
    coupling_6a = R_00 * RH_6
    coupling_6b = R_01 * RH_7
    coupling_6c = coupling_6a + coupling_6b
    coupling_6c_right = coupling_6c - coupling_6a
    coupling_6c_lo1 = (product_rest(R_00, RH_6, coupling_6a, coupling_6c - coupling_6c_right)
        + product_rest(R_01, RH_7, coupling_6b, coupling_6c_right))
    coupling_6d = R_02 * RH_8
    coupling_6 = coupling_6c + coupling_6d
    coupling_6_right = coupling_6 - coupling_6c
    coupling_6_lo2 = (coupling_6c - (coupling_6 - coupling_6_right)
        + product_rest(R_02, RH_8, coupling_6d, coupling_6_right) + R_02 * RH_8_lo)
    coupling_7a = R_10 * RH_6
    coupling_7b = R_11 * RH_7
    coupling_7c = coupling_7a + coupling_7b
    coupling_7c_right = coupling_7c - coupling_7a
    coupling_7c_lo1 = (product_rest(R_10, RH_6, coupling_7a, coupling_7c - coupling_7c_right)
        + product_rest(R_11, RH_7, coupling_7b, coupling_7c_right))
    coupling_7d = R_12 * RH_8
    coupling_7 = coupling_7c + coupling_7d
    coupling_7_right = coupling_7 - coupling_7c
    coupling_7_lo2 = (coupling_7c - (coupling_7 - coupling_7_right)
        + product_rest(R_12, RH_8, coupling_7d, coupling_7_right) + R_12 * RH_8_lo)
    coupling_8a = R_20 * RH_6
    coupling_8b = R_21 * RH_7
    coupling_8c = coupling_8a + coupling_8b
    coupling_8c_right = coupling_8c - coupling_8a
    coupling_8c_lo1 = (product_rest(R_20, RH_6, coupling_8a, coupling_8c - coupling_8c_right)
        + product_rest(R_21, RH_7, coupling_8b, coupling_8c_right))
    coupling_8d = R_22 * RH_8
    coupling_8 = coupling_8c + coupling_8d
    coupling_8_right = coupling_8 - coupling_8c
    coupling_8_lo2 = (coupling_8c - (coupling_8 - coupling_8_right)
        + product_rest(R_22, RH_8, coupling_8d, coupling_8_right) + R_22 * RH_8_lo)
    RI_0a = R_00 * M_33
    RI_0b = R_01 * M_43
    RI_0c = RI_0a + RI_0b
    RI_0c_right = RI_0c - RI_0a
    RI_0d = R_02 * M_53
    RI_0 = RI_0c + RI_0d
    RI_0_right = RI_0 - RI_0c
    RI_0c_lo = (product_rest(R_00, M_33, RI_0a, RI_0c - RI_0c_right)
        + product_rest(R_01, M_43, RI_0b, RI_0c_right))
    RI_1a = R_00 * M_43
    RI_1b = R_01 * M_44
    RI_1c = RI_1a + RI_1b
    RI_1c_right = RI_1c - RI_1a
    RI_1d = R_02 * M_54
    RI_1 = RI_1c + RI_1d
    RI_1_right = RI_1 - RI_1c
    RI_1c_lo = (product_rest(R_00, M_43, RI_1a, RI_1c - RI_1c_right)
        + product_rest(R_01, M_44, RI_1b, RI_1c_right))
    RI_2a = R_00 * M_53
    RI_2b = R_01 * M_54
    RI_2c = RI_2a + RI_2b
    RI_2c_right = RI_2c - RI_2a
    RI_2d = R_02 * M_55
    RI_2 = RI_2c + RI_2d
    RI_2_right = RI_2 - RI_2c
    RI_2c_lo = (product_rest(R_00, M_53, RI_2a, RI_2c - RI_2c_right)
        + product_rest(R_01, M_54, RI_2b, RI_2c_right))
    RI_3a = R_10 * M_33
    RI_3b = R_11 * M_43
    RI_3c = RI_3a + RI_3b
    RI_3c_right = RI_3c - RI_3a
    RI_3d = R_12 * M_53
    RI_3 = RI_3c + RI_3d
    RI_3_right = RI_3 - RI_3c
    RI_3c_lo = (product_rest(R_10, M_33, RI_3a, RI_3c - RI_3c_right)
        + product_rest(R_11, M_43, RI_3b, RI_3c_right))
    RI_3_lo = RI_3c - (RI_3 - RI_3_right) + product_rest(R_12, M_53, RI_3d, RI_3_right) + RI_3c_lo
    RI_4a = R_10 * M_43
    RI_4b = R_11 * M_44
    RI_4c = RI_4a + RI_4b
    RI_4c_right = RI_4c - RI_4a
    RI_4d = R_12 * M_54
    RI_4 = RI_4c + RI_4d
    RI_4_right = RI_4 - RI_4c
    RI_4c_lo = (product_rest(R_10, M_43, RI_4a, RI_4c - RI_4c_right)
        + product_rest(R_11, M_44, RI_4b, RI_4c_right))
    RI_4_lo = RI_4c - (RI_4 - RI_4_right) + product_rest(R_12, M_54, RI_4d, RI_4_right) + RI_4c_lo
    RI_5a = R_10 * M_53
    RI_5b = R_11 * M_54
    RI_5c = RI_5a + RI_5b
    RI_5c_right = RI_5c - RI_5a
    RI_5d = R_12 * M_55
    RI_5 = RI_5c + RI_5d
    RI_5_right = RI_5 - RI_5c
    RI_5c_lo = (product_rest(R_10, M_53, RI_5a, RI_5c - RI_5c_right)
        + product_rest(R_11, M_54, RI_5b, RI_5c_right))
    RI_5_lo = RI_5c - (RI_5 - RI_5_right) + product_rest(R_12, M_55, RI_5d, RI_5_right) + RI_5c_lo
    RI_6a = R_20 * M_33
    RI_6b = R_21 * M_43
    RI_6c = RI_6a + RI_6b
    RI_6c_right = RI_6c - RI_6a
    RI_6d = R_22 * M_53
    RI_6 = RI_6c + RI_6d
    RI_6_right = RI_6 - RI_6c
    RI_6c_lo = (product_rest(R_20, M_33, RI_6a, RI_6c - RI_6c_right)
        + product_rest(R_21, M_43, RI_6b, RI_6c_right))
    RI_6_lo = RI_6c - (RI_6 - RI_6_right) + product_rest(R_22, M_53, RI_6d, RI_6_right) + RI_6c_lo
    RI_7a = R_20 * M_43
    RI_7b = R_21 * M_44
    RI_7c = RI_7a + RI_7b
    RI_7c_right = RI_7c - RI_7a
    RI_7d = R_22 * M_54
    RI_7 = RI_7c + RI_7d
    RI_7_right = RI_7 - RI_7c
    RI_7c_lo = (product_rest(R_20, M_43, RI_7a, RI_7c - RI_7c_right)
        + product_rest(R_21, M_44, RI_7b, RI_7c_right))
    RI_7_lo = RI_7c - (RI_7 - RI_7_right) + product_rest(R_22, M_54, RI_7d, RI_7_right) + RI_7c_lo
    RI_8a = R_20 * M_53
    RI_8b = R_21 * M_54
    RI_8c = RI_8a + RI_8b
    RI_8c_right = RI_8c - RI_8a
    RI_8d = R_22 * M_55
    RI_8 = RI_8c + RI_8d
    RI_8_right = RI_8 - RI_8c
    RI_8c_lo = (product_rest(R_20, M_53, RI_8a, RI_8c - RI_8c_right)
        + product_rest(R_21, M_54, RI_8b, RI_8c_right))
    RI_8_lo = RI_8c - (RI_8 - RI_8_right) + product_rest(R_22, M_55, RI_8d, RI_8_right) + RI_8c_lo
    angular_0a = R_00 * RI_0
    angular_0b = R_01 * RI_1
    angular_0c = angular_0a + angular_0b
    angular_0c_right = angular_0c - angular_0a
    angular_0a_cross2 = (R_00
        * (RI_0c - (RI_0 - RI_0_right) + product_rest(R_02, M_53, RI_0d, RI_0_right) + RI_0c_lo))
    angular_0c_lo1 = (product_rest(R_00, RI_0, angular_0a, angular_0c - angular_0c_right)
        + product_rest(R_01, RI_1, angular_0b, angular_0c_right))
    angular_0d = R_02 * RI_2
    angular_0 = angular_0c + angular_0d
    angular_0_right = angular_0 - angular_0c
    angular_0_lo1 = (angular_0c - (angular_0 - angular_0_right)
        + product_rest(R_02, RI_2, angular_0d, angular_0_right))
    angular_0c_lo = (angular_0c_lo1
        + (angular_0a_cross2 + R_01
        * (RI_1c - (RI_1 - RI_1_right) + product_rest(R_02, M_54, RI_1d, RI_1_right) + RI_1c_lo)))
    angular_1a = R_00 * RI_3
    angular_1b = R_01 * RI_4
    angular_1c = angular_1a + angular_1b
    angular_1c_right = angular_1c - angular_1a
    angular_1c_lo1 = (product_rest(R_00, RI_3, angular_1a, angular_1c - angular_1c_right)
        + product_rest(R_01, RI_4, angular_1b, angular_1c_right))
    angular_1d = R_02 * RI_5
    angular_1 = angular_1c + angular_1d
    angular_1_right = angular_1 - angular_1c
    angular_1_lo2 = (angular_1c - (angular_1 - angular_1_right)
        + product_rest(R_02, RI_5, angular_1d, angular_1_right) + R_02 * RI_5_lo)
    angular_2a = R_10 * RI_3
    angular_2b = R_11 * RI_4
    angular_2c = angular_2a + angular_2b
    angular_2c_right = angular_2c - angular_2a
    angular_2c_lo1 = (product_rest(R_10, RI_3, angular_2a, angular_2c - angular_2c_right)
        + product_rest(R_11, RI_4, angular_2b, angular_2c_right))
    angular_2d = R_12 * RI_5
    angular_2 = angular_2c + angular_2d
    angular_2_right = angular_2 - angular_2c
    angular_2_lo2 = (angular_2c - (angular_2 - angular_2_right)
        + product_rest(R_12, RI_5, angular_2d, angular_2_right) + R_12 * RI_5_lo)
    angular_3a = R_00 * RI_6
    angular_3b = R_01 * RI_7
    angular_3c = angular_3a + angular_3b
    angular_3c_right = angular_3c - angular_3a
    angular_3c_lo1 = (product_rest(R_00, RI_6, angular_3a, angular_3c - angular_3c_right)
        + product_rest(R_01, RI_7, angular_3b, angular_3c_right))
    angular_3d = R_02 * RI_8
    angular_3 = angular_3c + angular_3d
    angular_3_right = angular_3 - angular_3c
    angular_3_lo2 = (angular_3c - (angular_3 - angular_3_right)
        + product_rest(R_02, RI_8, angular_3d, angular_3_right) + R_02 * RI_8_lo)
    angular_4a = R_10 * RI_6
    angular_4b = R_11 * RI_7
    angular_4c = angular_4a + angular_4b
    angular_4c_right = angular_4c - angular_4a
    angular_4c_lo1 = (product_rest(R_10, RI_6, angular_4a, angular_4c - angular_4c_right)
        + product_rest(R_11, RI_7, angular_4b, angular_4c_right))
    angular_4d = R_12 * RI_8
    angular_4 = angular_4c + angular_4d
    angular_4_right = angular_4 - angular_4c
    angular_4_lo2 = (angular_4c - (angular_4 - angular_4_right)
        + product_rest(R_12, RI_8, angular_4d, angular_4_right) + R_12 * RI_8_lo)
    angular_5a = R_20 * RI_6
    angular_5b = R_21 * RI_7
    angular_5c = angular_5a + angular_5b
    angular_5c_right = angular_5c - angular_5a
    angular_5c_lo1 = (product_rest(R_20, RI_6, angular_5a, angular_5c - angular_5c_right)
        + product_rest(R_21, RI_7, angular_5b, angular_5c_right))
    angular_5d = R_22 * RI_8
    angular_5 = angular_5c + angular_5d
    angular_5_right = angular_5 - angular_5c
    angular_5_lo2 = (angular_5c - (angular_5 - angular_5_right)
        + product_rest(R_22, RI_8, angular_5d, angular_5_right) + R_22 * RI_8_lo)
    linear_0_lo = (linear_0_lo1 + R_02
        * (RM_2c - (RM_2 - RM_2_right) + product_rest(R_02, M_22, RM_2d, RM_2_right) + RM_2c_lo)
        + linear_0c_lo)
    linear_0_rounded = linear_0 + linear_0_lo
    linear_1_rounded = (linear_1
        + (linear_1_lo2 + (linear_1c_lo1 + (R_00 * RM_3_lo + R_01 * RM_4_lo))))
    linear_3_rounded = (linear_3
        + (linear_3_lo2 + (linear_3c_lo1 + (R_00 * RM_6_lo + R_01 * RM_7_lo))))
    coupling_0_rounded = (coupling_0
        + (coupling_0_lo2 + (coupling_0c_lo1 + (R_00 * RH_0_lo + R_01 * RH_1_lo))))
    coupling_3_rounded = (coupling_3
        + (coupling_3_lo2 + (coupling_3c_lo1 + (R_00 * RH_3_lo + R_01 * RH_4_lo))))
    coupling_6_rounded = (coupling_6
        + (coupling_6_lo2 + (coupling_6c_lo1 + (R_00 * RH_6_lo + R_01 * RH_7_lo))))
    linear_2_rounded = (linear_2
        + (linear_2_lo2 + (linear_2c_lo1 + (R_10 * RM_3_lo + R_11 * RM_4_lo))))
    linear_4_rounded = (linear_4
        + (linear_4_lo2 + (linear_4c_lo1 + (R_10 * RM_6_lo + R_11 * RM_7_lo))))
    coupling_1_rounded = (coupling_1
        + (coupling_1_lo2 + (coupling_1c_lo1 + (R_10 * RH_0_lo + R_11 * RH_1_lo))))
    coupling_4_rounded = (coupling_4
        + (coupling_4_lo2 + (coupling_4c_lo1 + (R_10 * RH_3_lo + R_11 * RH_4_lo))))
    coupling_7_rounded = (coupling_7
        + (coupling_7_lo2 + (coupling_7c_lo1 + (R_10 * RH_6_lo + R_11 * RH_7_lo))))
    linear_5_rounded = (linear_5
        + (linear_5_lo2 + (linear_5c_lo1 + (R_20 * RM_6_lo + R_21 * RM_7_lo))))
    coupling_2_rounded = (coupling_2
        + (coupling_2_lo2 + (coupling_2c_lo1 + (R_20 * RH_0_lo + R_21 * RH_1_lo))))
    coupling_5_rounded = (coupling_5
        + (coupling_5_lo2 + (coupling_5c_lo1 + (R_20 * RH_3_lo + R_21 * RH_4_lo))))
    coupling_8_rounded = (coupling_8
        + (coupling_8_lo2 + (coupling_8c_lo1 + (R_20 * RH_6_lo + R_21 * RH_7_lo))))
    angular_0_lo = (angular_0_lo1 + R_02
        * (RI_2c - (RI_2 - RI_2_right) + product_rest(R_02, M_55, RI_2d, RI_2_right) + RI_2c_lo)
        + angular_0c_lo)
    angular_0_rounded = angular_0 + angular_0_lo
    angular_1_rounded = (angular_1
        + (angular_1_lo2 + (angular_1c_lo1 + (R_00 * RI_3_lo + R_01 * RI_4_lo))))
    angular_3_rounded = (angular_3
        + (angular_3_lo2 + (angular_3c_lo1 + (R_00 * RI_6_lo + R_01 * RI_7_lo))))
    angular_2_rounded = (angular_2
        + (angular_2_lo2 + (angular_2c_lo1 + (R_10 * RI_3_lo + R_11 * RI_4_lo))))
    angular_4_rounded = (angular_4
        + (angular_4_lo2 + (angular_4c_lo1 + (R_10 * RI_6_lo + R_11 * RI_7_lo))))
    angular_5_rounded = (angular_5
        + (angular_5_lo2 + (angular_5c_lo1 + (R_20 * RI_6_lo + R_21 * RI_7_lo))))
    return (linear_0_rounded, linear_1_rounded, linear_3_rounded, coupling_0_rounded,
        coupling_3_rounded, coupling_6_rounded, linear_1_rounded, linear_2_rounded,
        linear_4_rounded, coupling_1_rounded, coupling_4_rounded, coupling_7_rounded,
        linear_3_rounded, linear_4_rounded, linear_5_rounded, coupling_2_rounded,
        coupling_5_rounded, coupling_8_rounded, coupling_0_rounded, coupling_1_rounded,
        coupling_2_rounded, angular_0_rounded, angular_1_rounded, angular_3_rounded,
        coupling_3_rounded, coupling_4_rounded, coupling_5_rounded, angular_1_rounded,
        angular_2_rounded, angular_4_rounded, coupling_6_rounded, coupling_7_rounded,
        coupling_8_rounded, angular_3_rounded, angular_4_rounded, angular_5_rounded)


@kernel("(3),(6,6)->(6,6)")
def mat6x6_shifted(t, M):
    """Mo = [Ad]*(t) M [Ad]^-1(t), the articulated inertia M shifted by t; M is symmetric, only its
    lower triangle is read.

    (3),(6,6)->(6,6).  t: vector; M, Mo: 6×6 operator.
    51 mul, 264 add, 42 product rest.  Error <= u |result| + 45 u^2 S, S the sum of the |terms|
    of the expanded formula; barring over- and underflow.
    """
    t_0, t_1, t_2 = t
    (M_00, M_01, M_02, M_03, M_04, M_05, M_10, M_11, M_12, M_13, M_14, M_15, M_20, M_21, M_22, M_23,
        M_24, M_25, M_30, M_31, M_32, M_33, M_34, M_35, M_40, M_41, M_42, M_43, M_44, M_45, M_50,
        M_51, M_52, M_53, M_54, M_55) = M
    G_0a = t_1 * M_20
    G_0b = t_2 * M_10
    G_0c = G_0a - G_0b
    G_0c_right = G_0a - G_0c
    G_0 = G_0c + M_30
    G_0_right = G_0 - G_0c
    G_0c_lo = (product_rest(t_1, M_20, G_0a, G_0c + G_0c_right)
        - product_rest(t_2, M_10, G_0b, G_0c_right))
    G_1a = t_1 * M_21
    G_1b = t_2 * M_11
    G_1c = G_1a - G_1b
    G_1c_right = G_1a - G_1c
    G_1 = G_1c + M_31
    G_1_right = G_1 - G_1c
    G_1c_lo = (product_rest(t_1, M_21, G_1a, G_1c + G_1c_right)
        - product_rest(t_2, M_11, G_1b, G_1c_right))
    G_1_lo = G_1c - (G_1 - G_1_right) + (M_31 - G_1_right) + G_1c_lo
    G_2a = t_1 * M_22
    G_2b = t_2 * M_21
    G_2c = G_2a - G_2b
    G_2c_right = G_2a - G_2c
    G_2 = G_2c + M_32
    G_2_right = G_2 - G_2c
    G_2c_lo = (product_rest(t_1, M_22, G_2a, G_2c + G_2c_right)
        - product_rest(t_2, M_21, G_2b, G_2c_right))
    G_2_lo = G_2c - (G_2 - G_2_right) + (M_32 - G_2_right) + G_2c_lo
    G_3a = t_2 * M_00
    G_3b = t_0 * M_20
    G_3c = G_3a - G_3b
    G_3c_right = G_3a - G_3c
    G_3 = G_3c + M_40
    G_3_right = G_3 - G_3c
    G_3c_lo = (product_rest(t_2, M_00, G_3a, G_3c + G_3c_right)
        - product_rest(t_0, M_20, G_3b, G_3c_right))
    G_3_lo = G_3c - (G_3 - G_3_right) + (M_40 - G_3_right) + G_3c_lo
    G_4a = t_0 * M_21
    G_4b = G_0b - G_4a
    G_4b_right = G_0b - G_4b
    G_4 = G_4b + M_41
    G_4_right = G_4 - G_4b
    G_4b_lo = (product_rest(t_2, M_10, G_0b, G_4b + G_4b_right)
        - product_rest(t_0, M_21, G_4a, G_4b_right))
    G_4_lo = G_4b - (G_4 - G_4_right) + (M_41 - G_4_right) + G_4b_lo
    G_5a = t_2 * M_20
    G_5b = t_0 * M_22
    G_5c = G_5a - G_5b
    G_5c_right = G_5a - G_5c
    G_5 = G_5c + M_42
    G_5_right = G_5 - G_5c
    G_5c_lo = (product_rest(t_2, M_20, G_5a, G_5c + G_5c_right)
        - product_rest(t_0, M_22, G_5b, G_5c_right))
    G_5_lo = G_5c - (G_5 - G_5_right) + (M_42 - G_5_right) + G_5c_lo
    G_6a = t_0 * M_10
    G_6b = t_1 * M_00
    G_6c = G_6a - G_6b
    G_6c_right = G_6a - G_6c
    G_6 = G_6c + M_50
    G_6_right = G_6 - G_6c
    G_6c_lo = (product_rest(t_0, M_10, G_6a, G_6c + G_6c_right)
        - product_rest(t_1, M_00, G_6b, G_6c_right))
    G_6_lo = G_6c - (G_6 - G_6_right) + (M_50 - G_6_right) + G_6c_lo
    G_7a = t_0 * M_11
    G_7b = t_1 * M_10
    G_7c = G_7a - G_7b
    G_7c_right = G_7a - G_7c
    G_7 = G_7c + M_51
    G_7_right = G_7 - G_7c
    G_7c_lo = (product_rest(t_0, M_11, G_7a, G_7c + G_7c_right)
        - product_rest(t_1, M_10, G_7b, G_7c_right))
    G_7_lo = G_7c - (G_7 - G_7_right) + (M_51 - G_7_right) + G_7c_lo
    G_8a = G_4a - G_0a
    G_8a_right = G_4a - G_8a
    G_8 = G_8a + M_52
    G_8_right = G_8 - G_8a
    G_8a_lo = (product_rest(t_0, M_21, G_4a, G_8a + G_8a_right)
        - product_rest(t_1, M_20, G_0a, G_8a_right))
    G_8_lo = G_8a - (G_8 - G_8_right) + (M_52 - G_8_right) + G_8a_lo
    moved_0a = t_1 * M_32
    moved_0b = t_2 * M_31
    moved_0c = moved_0a - moved_0b
    moved_0c_right = moved_0a - moved_0c
    moved_0d = t_1 * G_2
    moved_0e = t_2 * G_1
    moved_0f = moved_0d - moved_0e
    moved_0f_right = moved_0d - moved_0f
    moved_0f_lo1 = (product_rest(t_1, G_2, moved_0d, moved_0f + moved_0f_right)
        - product_rest(t_2, G_1, moved_0e, moved_0f_right))
    moved_0g = moved_0c + moved_0f
    moved_0g_right = moved_0g - moved_0c
    moved_0g_lo2 = (moved_0c - (moved_0g - moved_0g_right) + (moved_0f - moved_0g_right)
        + (moved_0f_lo1 + (t_1 * G_2_lo - t_2 * G_1_lo)))
    moved_0 = moved_0g + M_33
    moved_0_right = moved_0 - moved_0g
    moved_0g_lo = (moved_0g_lo2
        + (product_rest(t_1, M_32, moved_0a, moved_0c + moved_0c_right)
        - product_rest(t_2, M_31, moved_0b, moved_0c_right)))
    moved_1a = t_2 * M_30
    moved_1b = t_0 * M_32
    moved_1c = moved_1a - moved_1b
    moved_1c_right = moved_1a - moved_1c
    moved_1d = t_1 * G_5
    moved_1e = t_2 * G_4
    moved_1f = moved_1d - moved_1e
    moved_1f_right = moved_1d - moved_1f
    moved_1f_lo1 = (product_rest(t_1, G_5, moved_1d, moved_1f + moved_1f_right)
        - product_rest(t_2, G_4, moved_1e, moved_1f_right))
    moved_1g = moved_1c + moved_1f
    moved_1g_right = moved_1g - moved_1c
    moved_1g_lo2 = (moved_1c - (moved_1g - moved_1g_right) + (moved_1f - moved_1g_right)
        + (moved_1f_lo1 + (t_1 * G_5_lo - t_2 * G_4_lo)))
    moved_1 = moved_1g + M_43
    moved_1_right = moved_1 - moved_1g
    moved_1g_lo = (moved_1g_lo2
        + (product_rest(t_2, M_30, moved_1a, moved_1c + moved_1c_right)
        - product_rest(t_0, M_32, moved_1b, moved_1c_right)))
    moved_2a = t_2 * M_40
    moved_2b = t_0 * M_42
    moved_2c = moved_2a - moved_2b
    moved_2c_right = moved_2a - moved_2c
    moved_2d = t_2 * G_3
    moved_2e = t_0 * G_5
    moved_2f = moved_2d - moved_2e
    moved_2f_right = moved_2d - moved_2f
    moved_2f_lo1 = (product_rest(t_2, G_3, moved_2d, moved_2f + moved_2f_right)
        - product_rest(t_0, G_5, moved_2e, moved_2f_right))
    moved_2g = moved_2c + moved_2f
    moved_2g_right = moved_2g - moved_2c
    moved_2g_lo2 = (moved_2c - (moved_2g - moved_2g_right) + (moved_2f - moved_2g_right)
        + (moved_2f_lo1 + (t_2 * G_3_lo - t_0 * G_5_lo)))
    moved_2 = moved_2g + M_44
    moved_2_right = moved_2 - moved_2g
    moved_2g_lo = (moved_2g_lo2
        + (product_rest(t_2, M_40, moved_2a, moved_2c + moved_2c_right)
        - product_rest(t_0, M_42, moved_2b, moved_2c_right)))
    moved_3a = t_0 * M_31
    moved_3b = t_1 * M_30
    moved_3c = moved_3a - moved_3b
    moved_3c_right = moved_3a - moved_3c
    moved_3d = t_1 * G_8
    moved_3e = t_2 * G_7
    moved_3f = moved_3d - moved_3e
    moved_3f_right = moved_3d - moved_3f
    moved_3f_lo1 = (product_rest(t_1, G_8, moved_3d, moved_3f + moved_3f_right)
        - product_rest(t_2, G_7, moved_3e, moved_3f_right))
    moved_3g = moved_3c + moved_3f
    moved_3g_right = moved_3g - moved_3c
    moved_3g_lo2 = (moved_3c - (moved_3g - moved_3g_right) + (moved_3f - moved_3g_right)
        + (moved_3f_lo1 + (t_1 * G_8_lo - t_2 * G_7_lo)))
    moved_3 = moved_3g + M_53
    moved_3_right = moved_3 - moved_3g
    moved_3g_lo = (moved_3g_lo2
        + (product_rest(t_0, M_31, moved_3a, moved_3c + moved_3c_right)
        - product_rest(t_1, M_30, moved_3b, moved_3c_right)))
    moved_4a = t_0 * M_41
    moved_4b = t_1 * M_40
    moved_4c = moved_4a - moved_4b
    moved_4c_right = moved_4a - moved_4c
    moved_4d = t_2 * G_6
    moved_4e = t_0 * G_8
    moved_4f = moved_4d - moved_4e
    moved_4f_right = moved_4d - moved_4f
    moved_4f_lo1 = (product_rest(t_2, G_6, moved_4d, moved_4f + moved_4f_right)
        - product_rest(t_0, G_8, moved_4e, moved_4f_right))
    moved_4g = moved_4c + moved_4f
    moved_4g_right = moved_4g - moved_4c
    moved_4g_lo2 = (moved_4c - (moved_4g - moved_4g_right) + (moved_4f - moved_4g_right)
        + (moved_4f_lo1 + (t_2 * G_6_lo - t_0 * G_8_lo)))
    moved_4 = moved_4g + M_54
    moved_4_right = moved_4 - moved_4g
    moved_4g_lo = (moved_4g_lo2
        + (product_rest(t_0, M_41, moved_4a, moved_4c + moved_4c_right)
        - product_rest(t_1, M_40, moved_4b, moved_4c_right)))
    moved_5a = t_0 * M_51
    moved_5b = t_1 * M_50
    moved_5c = moved_5a - moved_5b
    moved_5c_right = moved_5a - moved_5c
    moved_5d = t_0 * G_7
    moved_5e = t_1 * G_6
    moved_5f = moved_5d - moved_5e
    moved_5f_right = moved_5d - moved_5f
    moved_5f_lo1 = (product_rest(t_0, G_7, moved_5d, moved_5f + moved_5f_right)
        - product_rest(t_1, G_6, moved_5e, moved_5f_right))
    moved_5g = moved_5c + moved_5f
    moved_5g_right = moved_5g - moved_5c
    moved_5g_lo2 = (moved_5c - (moved_5g - moved_5g_right) + (moved_5f - moved_5g_right)
        + (moved_5f_lo1 + (t_0 * G_7_lo - t_1 * G_6_lo)))
    moved_5 = moved_5g + M_55
    moved_5_right = moved_5 - moved_5g
    moved_5g_lo = (moved_5g_lo2
        + (product_rest(t_0, M_51, moved_5a, moved_5c + moved_5c_right)
        - product_rest(t_1, M_50, moved_5b, moved_5c_right)))
    G_0_rounded = G_0 + (G_0c - (G_0 - G_0_right) + (M_30 - G_0_right) + G_0c_lo)
    G_3_rounded = G_3 + G_3_lo
    G_6_rounded = G_6 + G_6_lo
    G_1_rounded = G_1 + G_1_lo
    G_4_rounded = G_4 + G_4_lo
    G_7_rounded = G_7 + G_7_lo
    G_2_rounded = G_2 + G_2_lo
    G_5_rounded = G_5 + G_5_lo
    G_8_rounded = G_8 + G_8_lo
    moved_0_rounded = (moved_0
        + (moved_0g - (moved_0 - moved_0_right) + (M_33 - moved_0_right) + moved_0g_lo))
    moved_1_rounded = (moved_1
        + (moved_1g - (moved_1 - moved_1_right) + (M_43 - moved_1_right) + moved_1g_lo))
    moved_3_rounded = (moved_3
        + (moved_3g - (moved_3 - moved_3_right) + (M_53 - moved_3_right) + moved_3g_lo))
    moved_2_rounded = (moved_2
        + (moved_2g - (moved_2 - moved_2_right) + (M_44 - moved_2_right) + moved_2g_lo))
    moved_4_rounded = (moved_4
        + (moved_4g - (moved_4 - moved_4_right) + (M_54 - moved_4_right) + moved_4g_lo))
    moved_5_rounded = (moved_5
        + (moved_5g - (moved_5 - moved_5_right) + (M_55 - moved_5_right) + moved_5g_lo))
    return (M_00, M_10, M_20, G_0_rounded, G_3_rounded, G_6_rounded, M_10, M_11, M_21, G_1_rounded,
        G_4_rounded, G_7_rounded, M_20, M_21, M_22, G_2_rounded, G_5_rounded, G_8_rounded,
        G_0_rounded, G_1_rounded, G_2_rounded, moved_0_rounded, moved_1_rounded, moved_3_rounded,
        G_3_rounded, G_4_rounded, G_5_rounded, moved_1_rounded, moved_2_rounded, moved_4_rounded,
        G_6_rounded, G_7_rounded, G_8_rounded, moved_3_rounded, moved_4_rounded, moved_5_rounded)
