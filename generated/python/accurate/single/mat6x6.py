# Made by `coscrew generate`; changes are overwritten.
# SPDX-License-Identifier: MIT
# coscrew 0.2.0.  Copyright (c) 2026 The coscrew authors.
"""6×6 operators on screws and coscrews, as [Ad], [Ad]*, [ad] and [ad]* return them, and symmetric

In single precision, accurate tier.
"""

from coscrew._kernel import wide_kernel as kernel


@kernel("(3,4),(6,6)->(6,6)")
def mat6x6_transformed(D, M):
    """Mo = [Ad]*(D) M [Ad]^-1(D), M symmetric, of which the lower triangle is read: an articulated
    inertia in the frame D takes its own to.

    (3,4),(6,6)->(6,6).  D: displacement [R | t], R rotation, t in m; M, Mo: 6×6 operator.
    183 mul, 138 add.  Error <= u |result| + 13/32 u^2 S, S the sum of the |terms| of the
    expanded formula; barring over- and underflow.
    """
    D_00, D_01, D_02, D_03, D_10, D_11, D_12, D_13, D_20, D_21, D_22, D_23 = D
    (M_00, M_01, M_02, M_03, M_04, M_05, M_10, M_11, M_12, M_13, M_14, M_15, M_20, M_21, M_22, M_23,
        M_24, M_25, M_30, M_31, M_32, M_33, M_34, M_35, M_40, M_41, M_42, M_43, M_44, M_45, M_50,
        M_51, M_52, M_53, M_54, M_55) = M
    RM_0 = D_00 * M_00 + D_01 * M_10 + D_02 * M_20
    RM_1 = D_00 * M_10 + D_01 * M_11 + D_02 * M_21
    RM_2 = D_00 * M_20 + D_01 * M_21 + D_02 * M_22
    RM_3 = D_10 * M_00 + D_11 * M_10 + D_12 * M_20
    RM_4 = D_10 * M_10 + D_11 * M_11 + D_12 * M_21
    RM_5 = D_10 * M_20 + D_11 * M_21 + D_12 * M_22
    RM_6 = D_20 * M_00 + D_21 * M_10 + D_22 * M_20
    RM_7 = D_20 * M_10 + D_21 * M_11 + D_22 * M_21
    RM_8 = D_20 * M_20 + D_21 * M_21 + D_22 * M_22
    linear_0 = D_00 * RM_0 + D_01 * RM_1 + D_02 * RM_2
    linear_1 = D_10 * RM_0 + D_11 * RM_1 + D_12 * RM_2
    linear_2 = D_20 * RM_0 + D_21 * RM_1 + D_22 * RM_2
    linear_3 = D_10 * RM_3 + D_11 * RM_4 + D_12 * RM_5
    linear_4 = D_20 * RM_3 + D_21 * RM_4 + D_22 * RM_5
    linear_5 = D_20 * RM_6 + D_21 * RM_7 + D_22 * RM_8
    RH_0 = D_00 * M_30 + D_01 * M_40 + D_02 * M_50
    RH_1 = D_00 * M_31 + D_01 * M_41 + D_02 * M_51
    RH_2 = D_00 * M_32 + D_01 * M_42 + D_02 * M_52
    RH_3 = D_10 * M_30 + D_11 * M_40 + D_12 * M_50
    RH_4 = D_10 * M_31 + D_11 * M_41 + D_12 * M_51
    RH_5 = D_10 * M_32 + D_11 * M_42 + D_12 * M_52
    RH_6 = D_20 * M_30 + D_21 * M_40 + D_22 * M_50
    RH_7 = D_20 * M_31 + D_21 * M_41 + D_22 * M_51
    RH_8 = D_20 * M_32 + D_21 * M_42 + D_22 * M_52
    coupling_0 = D_00 * RH_0 + D_01 * RH_1 + D_02 * RH_2
    coupling_1 = D_10 * RH_0 + D_11 * RH_1 + D_12 * RH_2
    coupling_2 = D_20 * RH_0 + D_21 * RH_1 + D_22 * RH_2
    coupling_3 = D_00 * RH_3 + D_01 * RH_4 + D_02 * RH_5
    coupling_4 = D_10 * RH_3 + D_11 * RH_4 + D_12 * RH_5
    coupling_5 = D_20 * RH_3 + D_21 * RH_4 + D_22 * RH_5
    coupling_6 = D_00 * RH_6 + D_01 * RH_7 + D_02 * RH_8
    coupling_7 = D_10 * RH_6 + D_11 * RH_7 + D_12 * RH_8
    coupling_8 = D_20 * RH_6 + D_21 * RH_7 + D_22 * RH_8
    RI_0 = D_00 * M_33 + D_01 * M_43 + D_02 * M_53
    RI_1 = D_00 * M_43 + D_01 * M_44 + D_02 * M_54
    RI_2 = D_00 * M_53 + D_01 * M_54 + D_02 * M_55
    RI_3 = D_10 * M_33 + D_11 * M_43 + D_12 * M_53
    RI_4 = D_10 * M_43 + D_11 * M_44 + D_12 * M_54
    RI_5 = D_10 * M_53 + D_11 * M_54 + D_12 * M_55
    RI_6 = D_20 * M_33 + D_21 * M_43 + D_22 * M_53
    RI_7 = D_20 * M_43 + D_21 * M_44 + D_22 * M_54
    RI_8 = D_20 * M_53 + D_21 * M_54 + D_22 * M_55
    angular_0 = D_00 * RI_0 + D_01 * RI_1 + D_02 * RI_2
    angular_1 = D_10 * RI_0 + D_11 * RI_1 + D_12 * RI_2
    angular_2 = D_20 * RI_0 + D_21 * RI_1 + D_22 * RI_2
    angular_3 = D_10 * RI_3 + D_11 * RI_4 + D_12 * RI_5
    angular_4 = D_20 * RI_3 + D_21 * RI_4 + D_22 * RI_5
    angular_5 = D_20 * RI_6 + D_21 * RI_7 + D_22 * RI_8
    G_0a = D_13 * linear_2
    G_0b = D_23 * linear_1
    G_0 = G_0a - G_0b + coupling_0
    G_1 = D_13 * linear_4 - D_23 * linear_3 + coupling_1
    G_2 = D_13 * linear_5 - D_23 * linear_4 + coupling_2
    G_3 = D_23 * linear_0 - D_03 * linear_2 + coupling_3
    G_4a = D_03 * linear_4
    G_4 = G_0b - G_4a + coupling_4
    G_5 = D_23 * linear_2 - D_03 * linear_5 + coupling_5
    G_6 = D_03 * linear_1 - D_13 * linear_0 + coupling_6
    G_7 = D_03 * linear_3 - D_13 * linear_1 + coupling_7
    G_8 = G_4a - G_0a + coupling_8
    moved_0 = D_13 * coupling_2 - D_23 * coupling_1 + (D_13 * G_2 - D_23 * G_1) + angular_0
    moved_1 = D_23 * G_0 - D_03 * G_2 + (D_13 * coupling_5 - D_23 * coupling_4) + angular_1
    moved_2 = D_03 * G_1 - D_13 * G_0 + (D_13 * coupling_8 - D_23 * coupling_7) + angular_2
    moved_3 = D_23 * coupling_3 - D_03 * coupling_5 + (D_23 * G_3 - D_03 * G_5) + angular_3
    moved_4 = D_23 * coupling_6 - D_03 * coupling_8 + (D_03 * G_4 - D_13 * G_3) + angular_4
    moved_5 = D_03 * coupling_7 - D_13 * coupling_6 + (D_03 * G_7 - D_13 * G_6) + angular_5
    return (linear_0, linear_1, linear_2, G_0, G_3, G_6, linear_1, linear_3, linear_4, G_1, G_4,
        G_7, linear_2, linear_4, linear_5, G_2, G_5, G_8, G_0, G_1, G_2, moved_0, moved_1, moved_2,
        G_3, G_4, G_5, moved_1, moved_3, moved_4, G_6, G_7, G_8, moved_2, moved_4, moved_5)
