# Made by `coscrew generate`; changes are overwritten.
# SPDX-License-Identifier: MIT
# coscrew 0.2.0.  Copyright (c) 2026 The coscrew authors.
"""6×6 operators on screws and coscrews: [Ad], [Ad]*, [ad], [ad]*, and articulated inertias.

In single precision, accurate tier.
"""

from coscrew._kernel import wide_kernel as kernel


@kernel("(3,3),(6,6)->(6,6)")
def mat6x6_rotated(R, M):
    """Mo = [Ad]*(R) M [Ad]^-1(R), the articulated inertia M rotated by R; M is symmetric, only its
    lower triangle is read.

    (3,3),(6,6)->(6,6).  R: rotation or other 3×3 matrix; M, Mo: 6×6 operator.
    144 mul, 96 add.  Error <= u |result| + 3/16 u^2 S, S the sum of the |terms| of the expanded
    formula; barring over- and underflow.
    """
    R_00, R_01, R_02, R_10, R_11, R_12, R_20, R_21, R_22 = R
    (M_00, M_01, M_02, M_03, M_04, M_05, M_10, M_11, M_12, M_13, M_14, M_15, M_20, M_21, M_22, M_23,
        M_24, M_25, M_30, M_31, M_32, M_33, M_34, M_35, M_40, M_41, M_42, M_43, M_44, M_45, M_50,
        M_51, M_52, M_53, M_54, M_55) = M
    RM_0 = R_00 * M_00 + R_01 * M_10 + R_02 * M_20
    RM_1 = R_00 * M_10 + R_01 * M_11 + R_02 * M_21
    RM_2 = R_00 * M_20 + R_01 * M_21 + R_02 * M_22
    RM_3 = R_10 * M_00 + R_11 * M_10 + R_12 * M_20
    RM_4 = R_10 * M_10 + R_11 * M_11 + R_12 * M_21
    RM_5 = R_10 * M_20 + R_11 * M_21 + R_12 * M_22
    RM_6 = R_20 * M_00 + R_21 * M_10 + R_22 * M_20
    RM_7 = R_20 * M_10 + R_21 * M_11 + R_22 * M_21
    RM_8 = R_20 * M_20 + R_21 * M_21 + R_22 * M_22
    linear_0 = R_00 * RM_0 + R_01 * RM_1 + R_02 * RM_2
    linear_1 = R_00 * RM_3 + R_01 * RM_4 + R_02 * RM_5
    linear_2 = R_10 * RM_3 + R_11 * RM_4 + R_12 * RM_5
    linear_3 = R_00 * RM_6 + R_01 * RM_7 + R_02 * RM_8
    linear_4 = R_10 * RM_6 + R_11 * RM_7 + R_12 * RM_8
    linear_5 = R_20 * RM_6 + R_21 * RM_7 + R_22 * RM_8
    RH_0 = R_00 * M_30 + R_01 * M_40 + R_02 * M_50
    RH_1 = R_00 * M_31 + R_01 * M_41 + R_02 * M_51
    RH_2 = R_00 * M_32 + R_01 * M_42 + R_02 * M_52
    RH_3 = R_10 * M_30 + R_11 * M_40 + R_12 * M_50
    RH_4 = R_10 * M_31 + R_11 * M_41 + R_12 * M_51
    RH_5 = R_10 * M_32 + R_11 * M_42 + R_12 * M_52
    RH_6 = R_20 * M_30 + R_21 * M_40 + R_22 * M_50
    RH_7 = R_20 * M_31 + R_21 * M_41 + R_22 * M_51
    RH_8 = R_20 * M_32 + R_21 * M_42 + R_22 * M_52
    coupling_0 = R_00 * RH_0 + R_01 * RH_1 + R_02 * RH_2
    coupling_1 = R_10 * RH_0 + R_11 * RH_1 + R_12 * RH_2
    coupling_2 = R_20 * RH_0 + R_21 * RH_1 + R_22 * RH_2
    coupling_3 = R_00 * RH_3 + R_01 * RH_4 + R_02 * RH_5
    coupling_4 = R_10 * RH_3 + R_11 * RH_4 + R_12 * RH_5
    coupling_5 = R_20 * RH_3 + R_21 * RH_4 + R_22 * RH_5
    coupling_6 = R_00 * RH_6 + R_01 * RH_7 + R_02 * RH_8
    coupling_7 = R_10 * RH_6 + R_11 * RH_7 + R_12 * RH_8
    coupling_8 = R_20 * RH_6 + R_21 * RH_7 + R_22 * RH_8
    RI_0 = R_00 * M_33 + R_01 * M_43 + R_02 * M_53
    RI_1 = R_00 * M_43 + R_01 * M_44 + R_02 * M_54
    RI_2 = R_00 * M_53 + R_01 * M_54 + R_02 * M_55
    RI_3 = R_10 * M_33 + R_11 * M_43 + R_12 * M_53
    RI_4 = R_10 * M_43 + R_11 * M_44 + R_12 * M_54
    RI_5 = R_10 * M_53 + R_11 * M_54 + R_12 * M_55
    RI_6 = R_20 * M_33 + R_21 * M_43 + R_22 * M_53
    RI_7 = R_20 * M_43 + R_21 * M_44 + R_22 * M_54
    RI_8 = R_20 * M_53 + R_21 * M_54 + R_22 * M_55
    angular_0 = R_00 * RI_0 + R_01 * RI_1 + R_02 * RI_2
    angular_1 = R_00 * RI_3 + R_01 * RI_4 + R_02 * RI_5
    angular_2 = R_10 * RI_3 + R_11 * RI_4 + R_12 * RI_5
    angular_3 = R_00 * RI_6 + R_01 * RI_7 + R_02 * RI_8
    angular_4 = R_10 * RI_6 + R_11 * RI_7 + R_12 * RI_8
    angular_5 = R_20 * RI_6 + R_21 * RI_7 + R_22 * RI_8
    return (linear_0, linear_1, linear_3, coupling_0, coupling_3, coupling_6, linear_1, linear_2,
        linear_4, coupling_1, coupling_4, coupling_7, linear_3, linear_4, linear_5, coupling_2,
        coupling_5, coupling_8, coupling_0, coupling_1, coupling_2, angular_0, angular_1, angular_3,
        coupling_3, coupling_4, coupling_5, angular_1, angular_2, angular_4, coupling_6, coupling_7,
        coupling_8, angular_3, angular_4, angular_5)


@kernel("(3),(6,6)->(6,6)")
def mat6x6_shifted(t, M):
    """Mo = [Ad]*(t) M [Ad]^-1(t), the articulated inertia M shifted by t; M is symmetric, only its
    lower triangle is read.

    (3),(6,6)->(6,6).  t: vector; M, Mo: 6×6 operator.
    39 mul, 42 add.  Error <= u |result| + 7/32 u^2 S, S the sum of the |terms| of the expanded
    formula; barring over- and underflow.
    """
    t_0, t_1, t_2 = t
    (M_00, M_01, M_02, M_03, M_04, M_05, M_10, M_11, M_12, M_13, M_14, M_15, M_20, M_21, M_22, M_23,
        M_24, M_25, M_30, M_31, M_32, M_33, M_34, M_35, M_40, M_41, M_42, M_43, M_44, M_45, M_50,
        M_51, M_52, M_53, M_54, M_55) = M
    G_0a = t_1 * M_20
    G_0b = t_2 * M_10
    G_0 = G_0a - G_0b + M_30
    G_1 = t_1 * M_21 - t_2 * M_11 + M_31
    G_2 = t_1 * M_22 - t_2 * M_21 + M_32
    G_3 = t_2 * M_00 - t_0 * M_20 + M_40
    G_4a = t_0 * M_21
    G_4 = G_0b - G_4a + M_41
    G_5 = t_2 * M_20 - t_0 * M_22 + M_42
    G_6 = t_0 * M_10 - t_1 * M_00 + M_50
    G_7 = t_0 * M_11 - t_1 * M_10 + M_51
    G_8 = G_4a - G_0a + M_52
    moved_0 = t_1 * M_32 - t_2 * M_31 + (t_1 * G_2 - t_2 * G_1) + M_33
    moved_1 = t_2 * M_30 - t_0 * M_32 + (t_1 * G_5 - t_2 * G_4) + M_43
    moved_2 = t_2 * M_40 - t_0 * M_42 + (t_2 * G_3 - t_0 * G_5) + M_44
    moved_3 = t_0 * M_31 - t_1 * M_30 + (t_1 * G_8 - t_2 * G_7) + M_53
    moved_4 = t_0 * M_41 - t_1 * M_40 + (t_2 * G_6 - t_0 * G_8) + M_54
    moved_5 = t_0 * M_51 - t_1 * M_50 + (t_0 * G_7 - t_1 * G_6) + M_55
    return (M_00, M_10, M_20, G_0, G_3, G_6, M_10, M_11, M_21, G_1, G_4, G_7, M_20, M_21, M_22, G_2,
        G_5, G_8, G_0, G_1, G_2, moved_0, moved_1, moved_3, G_3, G_4, G_5, moved_1, moved_2,
        moved_4, G_6, G_7, G_8, moved_3, moved_4, moved_5)
