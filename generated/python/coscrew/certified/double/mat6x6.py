# Made by `coscrew generate`; changes are overwritten.
# SPDX-License-Identifier: MIT
# coscrew 0.2.0.  Copyright (c) 2026 The coscrew authors.
"""6×6 operators on screws and coscrews: [Ad], [Ad]*, [ad], [ad]*, and articulated inertias.

In double precision, certified tier.
"""

from numpy import absolute
from coscrew._kernel import double_kernel as kernel
from numpy import errstate


@kernel("(3,3),(6,6)->(6,6),(6,6)")
@errstate(all="ignore")
def mat6x6_rotated(R, M, *, c1=2.004168360008973e-292, c2=6.661338147750942e-16):
    """Mo = [Ad]*(R) M [Ad]^-1(R), the articulated inertia M rotated by R; M is symmetric, only its
    lower triangle is read; |error of Mo| <= Mo_bound unless inf or NaN.

    (3,3),(6,6)->(6,6),(6,6).  R: rotation or other 3×3 matrix; M, Mo, Mo_bound: 6×6 operator.
    228 mul, 240 add, 90 abs.
    """
    R_00, R_01, R_02, R_10, R_11, R_12, R_20, R_21, R_22 = R
    (M_00, M_01, M_02, M_03, M_04, M_05, M_10, M_11, M_12, M_13, M_14, M_15, M_20, M_21, M_22, M_23,
        M_24, M_25, M_30, M_31, M_32, M_33, M_34, M_35, M_40, M_41, M_42, M_43, M_44, M_45, M_50,
        M_51, M_52, M_53, M_54, M_55) = M
    RM_0a = R_00 * M_00
    RM_0b = R_01 * M_10
    RM_0d = R_02 * M_20
    RM_0 = RM_0a + RM_0b + RM_0d
    RM_1a = R_00 * M_10
    RM_1b = R_01 * M_11
    RM_1d = R_02 * M_21
    RM_1 = RM_1a + RM_1b + RM_1d
    RM_2a = R_00 * M_20
    RM_2b = R_01 * M_21
    RM_2d = R_02 * M_22
    RM_2 = RM_2a + RM_2b + RM_2d
    RM_3a = R_10 * M_00
    RM_3b = R_11 * M_10
    RM_3d = R_12 * M_20
    RM_3 = RM_3a + RM_3b + RM_3d
    RM_4a = R_10 * M_10
    RM_4b = R_11 * M_11
    RM_4d = R_12 * M_21
    RM_4 = RM_4a + RM_4b + RM_4d
    RM_5a = R_10 * M_20
    RM_5b = R_11 * M_21
    RM_5d = R_12 * M_22
    RM_5 = RM_5a + RM_5b + RM_5d
    RM_6a = R_20 * M_00
    RM_6b = R_21 * M_10
    RM_6d = R_22 * M_20
    RM_6 = RM_6a + RM_6b + RM_6d
    RM_7a = R_20 * M_10
    RM_7b = R_21 * M_11
    RM_7d = R_22 * M_21
    RM_7 = RM_7a + RM_7b + RM_7d
    RM_8a = R_20 * M_20
    RM_8b = R_21 * M_21
    RM_8d = R_22 * M_22
    RM_8 = RM_8a + RM_8b + RM_8d
    linear_0 = R_00 * RM_0 + R_01 * RM_1 + R_02 * RM_2
    linear_1 = R_00 * RM_3 + R_01 * RM_4 + R_02 * RM_5
    linear_2 = R_10 * RM_3 + R_11 * RM_4 + R_12 * RM_5
    linear_3 = R_00 * RM_6 + R_01 * RM_7 + R_02 * RM_8
    linear_4 = R_10 * RM_6 + R_11 * RM_7 + R_12 * RM_8
    linear_5 = R_20 * RM_6 + R_21 * RM_7 + R_22 * RM_8
    RH_0a = R_00 * M_30
    RH_0b = R_01 * M_40
    RH_0d = R_02 * M_50
    RH_0 = RH_0a + RH_0b + RH_0d
    RH_1a = R_00 * M_31
    RH_1b = R_01 * M_41
    RH_1d = R_02 * M_51
    RH_1 = RH_1a + RH_1b + RH_1d
    RH_2a = R_00 * M_32
    RH_2b = R_01 * M_42
    RH_2d = R_02 * M_52
    RH_2 = RH_2a + RH_2b + RH_2d
    RH_3a = R_10 * M_30
    RH_3b = R_11 * M_40
    RH_3d = R_12 * M_50
    RH_3 = RH_3a + RH_3b + RH_3d
    RH_4a = R_10 * M_31
    RH_4b = R_11 * M_41
    RH_4d = R_12 * M_51
    RH_4 = RH_4a + RH_4b + RH_4d
    RH_5a = R_10 * M_32
    RH_5b = R_11 * M_42
    RH_5d = R_12 * M_52
    RH_5 = RH_5a + RH_5b + RH_5d
    RH_6a = R_20 * M_30
    RH_6b = R_21 * M_40
    RH_6d = R_22 * M_50
    RH_6 = RH_6a + RH_6b + RH_6d
    RH_7a = R_20 * M_31
    RH_7b = R_21 * M_41
    RH_7d = R_22 * M_51
    RH_7 = RH_7a + RH_7b + RH_7d
    RH_8a = R_20 * M_32
    RH_8b = R_21 * M_42
    RH_8d = R_22 * M_52
    RH_8 = RH_8a + RH_8b + RH_8d
    coupling_0 = R_00 * RH_0 + R_01 * RH_1 + R_02 * RH_2
    coupling_1 = R_10 * RH_0 + R_11 * RH_1 + R_12 * RH_2
    coupling_2 = R_20 * RH_0 + R_21 * RH_1 + R_22 * RH_2
    coupling_3 = R_00 * RH_3 + R_01 * RH_4 + R_02 * RH_5
    coupling_4 = R_10 * RH_3 + R_11 * RH_4 + R_12 * RH_5
    coupling_5 = R_20 * RH_3 + R_21 * RH_4 + R_22 * RH_5
    coupling_6 = R_00 * RH_6 + R_01 * RH_7 + R_02 * RH_8
    coupling_7 = R_10 * RH_6 + R_11 * RH_7 + R_12 * RH_8
    coupling_8 = R_20 * RH_6 + R_21 * RH_7 + R_22 * RH_8
    RI_0a = R_00 * M_33
    RI_0b = R_01 * M_43
    RI_0d = R_02 * M_53
    RI_0 = RI_0a + RI_0b + RI_0d
    RI_1a = R_00 * M_43
    RI_1b = R_01 * M_44
    RI_1d = R_02 * M_54
    RI_1 = RI_1a + RI_1b + RI_1d
    RI_2a = R_00 * M_53
    RI_2b = R_01 * M_54
    RI_2d = R_02 * M_55
    RI_2 = RI_2a + RI_2b + RI_2d
    RI_3a = R_10 * M_33
    RI_3b = R_11 * M_43
    RI_3d = R_12 * M_53
    RI_3 = RI_3a + RI_3b + RI_3d
    RI_4a = R_10 * M_43
    RI_4b = R_11 * M_44
    RI_4d = R_12 * M_54
    RI_4 = RI_4a + RI_4b + RI_4d
    RI_5a = R_10 * M_53
    RI_5b = R_11 * M_54
    RI_5d = R_12 * M_55
    RI_5 = RI_5a + RI_5b + RI_5d
    RI_6a = R_20 * M_33
    RI_6b = R_21 * M_43
    RI_6d = R_22 * M_53
    RI_6 = RI_6a + RI_6b + RI_6d
    RI_7a = R_20 * M_43
    RI_7b = R_21 * M_44
    RI_7d = R_22 * M_54
    RI_7 = RI_7a + RI_7b + RI_7d
    RI_8a = R_20 * M_53
    RI_8b = R_21 * M_54
    RI_8d = R_22 * M_55
    RI_8 = RI_8a + RI_8b + RI_8d
    angular_0 = R_00 * RI_0 + R_01 * RI_1 + R_02 * RI_2
    angular_1 = R_00 * RI_3 + R_01 * RI_4 + R_02 * RI_5
    angular_2 = R_10 * RI_3 + R_11 * RI_4 + R_12 * RI_5
    angular_3 = R_00 * RI_6 + R_01 * RI_7 + R_02 * RI_8
    angular_4 = R_10 * RI_6 + R_11 * RI_7 + R_12 * RI_8
    angular_5 = R_20 * RI_6 + R_21 * RI_7 + R_22 * RI_8
    RM_0_size = absolute(RM_0a) + absolute(RM_0b) + absolute(RM_0d)
    RM_1_size = absolute(RM_1a) + absolute(RM_1b) + absolute(RM_1d)
    RM_2_size = absolute(RM_2a) + absolute(RM_2b) + absolute(RM_2d)
    RM_3_size = absolute(RM_3a) + absolute(RM_3b) + absolute(RM_3d)
    RM_4_size = absolute(RM_4a) + absolute(RM_4b) + absolute(RM_4d)
    RM_5_size = absolute(RM_5a) + absolute(RM_5b) + absolute(RM_5d)
    RM_6_size = absolute(RM_6a) + absolute(RM_6b) + absolute(RM_6d)
    RM_7_size = absolute(RM_7a) + absolute(RM_7b) + absolute(RM_7d)
    RM_8_size = absolute(RM_8a) + absolute(RM_8b) + absolute(RM_8d)
    R_00_abs = absolute(R_00)
    R_01_abs = absolute(R_01)
    R_02_abs = absolute(R_02)
    linear_0_size = (R_00_abs * (RM_0_size + c1) + R_01_abs * (RM_1_size + c1) + R_02_abs
        * (RM_2_size + c1))
    RM_3_padded = RM_3_size + c1
    RM_4_padded = RM_4_size + c1
    RM_5_padded = RM_5_size + c1
    linear_1_size = R_00_abs * RM_3_padded + R_01_abs * RM_4_padded + R_02_abs * RM_5_padded
    R_10_abs = absolute(R_10)
    R_11_abs = absolute(R_11)
    R_12_abs = absolute(R_12)
    linear_2_size = R_10_abs * RM_3_padded + R_11_abs * RM_4_padded + R_12_abs * RM_5_padded
    RM_6_padded = RM_6_size + c1
    RM_7_padded = RM_7_size + c1
    RM_8_padded = RM_8_size + c1
    linear_3_size = R_00_abs * RM_6_padded + R_01_abs * RM_7_padded + R_02_abs * RM_8_padded
    linear_4_size = R_10_abs * RM_6_padded + R_11_abs * RM_7_padded + R_12_abs * RM_8_padded
    R_20_abs = absolute(R_20)
    R_21_abs = absolute(R_21)
    R_22_abs = absolute(R_22)
    linear_5_size = R_20_abs * RM_6_padded + R_21_abs * RM_7_padded + R_22_abs * RM_8_padded
    RH_0_size = absolute(RH_0a) + absolute(RH_0b) + absolute(RH_0d)
    RH_1_size = absolute(RH_1a) + absolute(RH_1b) + absolute(RH_1d)
    RH_2_size = absolute(RH_2a) + absolute(RH_2b) + absolute(RH_2d)
    RH_3_size = absolute(RH_3a) + absolute(RH_3b) + absolute(RH_3d)
    RH_4_size = absolute(RH_4a) + absolute(RH_4b) + absolute(RH_4d)
    RH_5_size = absolute(RH_5a) + absolute(RH_5b) + absolute(RH_5d)
    RH_6_size = absolute(RH_6a) + absolute(RH_6b) + absolute(RH_6d)
    RH_7_size = absolute(RH_7a) + absolute(RH_7b) + absolute(RH_7d)
    RH_8_size = absolute(RH_8a) + absolute(RH_8b) + absolute(RH_8d)
    RH_0_padded = RH_0_size + c1
    RH_1_padded = RH_1_size + c1
    RH_2_padded = RH_2_size + c1
    coupling_0_size = R_00_abs * RH_0_padded + R_01_abs * RH_1_padded + R_02_abs * RH_2_padded
    coupling_1_size = R_10_abs * RH_0_padded + R_11_abs * RH_1_padded + R_12_abs * RH_2_padded
    coupling_2_size = R_20_abs * RH_0_padded + R_21_abs * RH_1_padded + R_22_abs * RH_2_padded
    RH_3_padded = RH_3_size + c1
    RH_4_padded = RH_4_size + c1
    RH_5_padded = RH_5_size + c1
    coupling_3_size = R_00_abs * RH_3_padded + R_01_abs * RH_4_padded + R_02_abs * RH_5_padded
    coupling_4_size = R_10_abs * RH_3_padded + R_11_abs * RH_4_padded + R_12_abs * RH_5_padded
    coupling_5_size = R_20_abs * RH_3_padded + R_21_abs * RH_4_padded + R_22_abs * RH_5_padded
    RH_6_padded = RH_6_size + c1
    RH_7_padded = RH_7_size + c1
    RH_8_padded = RH_8_size + c1
    coupling_6_size = R_00_abs * RH_6_padded + R_01_abs * RH_7_padded + R_02_abs * RH_8_padded
    coupling_7_size = R_10_abs * RH_6_padded + R_11_abs * RH_7_padded + R_12_abs * RH_8_padded
    coupling_8_size = R_20_abs * RH_6_padded + R_21_abs * RH_7_padded + R_22_abs * RH_8_padded
    RI_0_size = absolute(RI_0a) + absolute(RI_0b) + absolute(RI_0d)
    RI_1_size = absolute(RI_1a) + absolute(RI_1b) + absolute(RI_1d)
    RI_2_size = absolute(RI_2a) + absolute(RI_2b) + absolute(RI_2d)
    RI_3_size = absolute(RI_3a) + absolute(RI_3b) + absolute(RI_3d)
    RI_4_size = absolute(RI_4a) + absolute(RI_4b) + absolute(RI_4d)
    RI_5_size = absolute(RI_5a) + absolute(RI_5b) + absolute(RI_5d)
    RI_6_size = absolute(RI_6a) + absolute(RI_6b) + absolute(RI_6d)
    RI_7_size = absolute(RI_7a) + absolute(RI_7b) + absolute(RI_7d)
    RI_8_size = absolute(RI_8a) + absolute(RI_8b) + absolute(RI_8d)
    angular_0_size = (R_00_abs * (RI_0_size + c1) + R_01_abs * (RI_1_size + c1) + R_02_abs
        * (RI_2_size + c1))
    RI_3_padded = RI_3_size + c1
    RI_4_padded = RI_4_size + c1
    RI_5_padded = RI_5_size + c1
    angular_1_size = R_00_abs * RI_3_padded + R_01_abs * RI_4_padded + R_02_abs * RI_5_padded
    angular_2_size = R_10_abs * RI_3_padded + R_11_abs * RI_4_padded + R_12_abs * RI_5_padded
    RI_6_padded = RI_6_size + c1
    RI_7_padded = RI_7_size + c1
    RI_8_padded = RI_8_size + c1
    angular_3_size = R_00_abs * RI_6_padded + R_01_abs * RI_7_padded + R_02_abs * RI_8_padded
    angular_4_size = R_10_abs * RI_6_padded + R_11_abs * RI_7_padded + R_12_abs * RI_8_padded
    angular_5_size = R_20_abs * RI_6_padded + R_21_abs * RI_7_padded + R_22_abs * RI_8_padded
    linear_0_bound = c2 * (linear_0_size + c1)
    linear_1_bound = c2 * (linear_1_size + c1)
    linear_3_bound = c2 * (linear_3_size + c1)
    coupling_0_bound = c2 * (coupling_0_size + c1)
    coupling_3_bound = c2 * (coupling_3_size + c1)
    coupling_6_bound = c2 * (coupling_6_size + c1)
    linear_2_bound = c2 * (linear_2_size + c1)
    linear_4_bound = c2 * (linear_4_size + c1)
    coupling_1_bound = c2 * (coupling_1_size + c1)
    coupling_4_bound = c2 * (coupling_4_size + c1)
    coupling_7_bound = c2 * (coupling_7_size + c1)
    linear_5_bound = c2 * (linear_5_size + c1)
    coupling_2_bound = c2 * (coupling_2_size + c1)
    coupling_5_bound = c2 * (coupling_5_size + c1)
    coupling_8_bound = c2 * (coupling_8_size + c1)
    angular_0_bound = c2 * (angular_0_size + c1)
    angular_1_bound = c2 * (angular_1_size + c1)
    angular_3_bound = c2 * (angular_3_size + c1)
    angular_2_bound = c2 * (angular_2_size + c1)
    angular_4_bound = c2 * (angular_4_size + c1)
    angular_5_bound = c2 * (angular_5_size + c1)
    return (linear_0, linear_1, linear_3, coupling_0, coupling_3, coupling_6, linear_1, linear_2,
        linear_4, coupling_1, coupling_4, coupling_7, linear_3, linear_4, linear_5, coupling_2,
        coupling_5, coupling_8, coupling_0, coupling_1, coupling_2, angular_0, angular_1, angular_3,
        coupling_3, coupling_4, coupling_5, angular_1, angular_2, angular_4, coupling_6, coupling_7,
        coupling_8, angular_3, angular_4, angular_5, linear_0_bound, linear_1_bound, linear_3_bound,
        coupling_0_bound, coupling_3_bound, coupling_6_bound, linear_1_bound, linear_2_bound,
        linear_4_bound, coupling_1_bound, coupling_4_bound, coupling_7_bound, linear_3_bound,
        linear_4_bound, linear_5_bound, coupling_2_bound, coupling_5_bound, coupling_8_bound,
        coupling_0_bound, coupling_1_bound, coupling_2_bound, angular_0_bound, angular_1_bound,
        angular_3_bound, coupling_3_bound, coupling_4_bound, coupling_5_bound, angular_1_bound,
        angular_2_bound, angular_4_bound, coupling_6_bound, coupling_7_bound, coupling_8_bound,
        angular_3_bound, angular_4_bound, angular_5_bound)


@kernel("(3),(6,6)->(6,6),(6,6)")
@errstate(all="ignore")
def mat6x6_shifted(t, M, *, c1=2.004168360008973e-292, c2=3.3306690738754706e-16,
        c3=7.7715611723761e-16):
    """Mo = [Ad]*(t) M [Ad]^-1(t), the articulated inertia M shifted by t; M is symmetric, only its
    lower triangle is read; |error of Mo| <= Mo_bound unless inf or NaN.

    (3),(6,6)->(6,6),(6,6).  t: vector; M, Mo, Mo_bound: 6×6 operator.
    66 mul, 99 add, 45 abs.
    """
    t_0, t_1, t_2 = t
    (M_00, M_01, M_02, M_03, M_04, M_05, M_10, M_11, M_12, M_13, M_14, M_15, M_20, M_21, M_22, M_23,
        M_24, M_25, M_30, M_31, M_32, M_33, M_34, M_35, M_40, M_41, M_42, M_43, M_44, M_45, M_50,
        M_51, M_52, M_53, M_54, M_55) = M
    G_0a = t_1 * M_20
    G_0b = t_2 * M_10
    G_0 = G_0a - G_0b + M_30
    G_1a = t_1 * M_21
    G_1b = t_2 * M_11
    G_1 = G_1a - G_1b + M_31
    G_2a = t_1 * M_22
    G_2b = t_2 * M_21
    G_2 = G_2a - G_2b + M_32
    G_3a = t_2 * M_00
    G_3b = t_0 * M_20
    G_3 = G_3a - G_3b + M_40
    G_4a = t_0 * M_21
    G_4 = G_0b - G_4a + M_41
    G_5a = t_2 * M_20
    G_5b = t_0 * M_22
    G_5 = G_5a - G_5b + M_42
    G_6a = t_0 * M_10
    G_6b = t_1 * M_00
    G_6 = G_6a - G_6b + M_50
    G_7a = t_0 * M_11
    G_7b = t_1 * M_10
    G_7 = G_7a - G_7b + M_51
    G_8 = G_4a - G_0a + M_52
    moved_0a = t_1 * M_32
    moved_0b = t_2 * M_31
    moved_0 = moved_0a - moved_0b + (t_1 * G_2 - t_2 * G_1) + M_33
    moved_1a = t_2 * M_30
    moved_1b = t_0 * M_32
    moved_1 = moved_1a - moved_1b + (t_1 * G_5 - t_2 * G_4) + M_43
    moved_2a = t_2 * M_40
    moved_2b = t_0 * M_42
    moved_2 = moved_2a - moved_2b + (t_2 * G_3 - t_0 * G_5) + M_44
    moved_3a = t_0 * M_31
    moved_3b = t_1 * M_30
    moved_3 = moved_3a - moved_3b + (t_1 * G_8 - t_2 * G_7) + M_53
    moved_4a = t_0 * M_41
    moved_4b = t_1 * M_40
    moved_4 = moved_4a - moved_4b + (t_2 * G_6 - t_0 * G_8) + M_54
    moved_5a = t_0 * M_51
    moved_5b = t_1 * M_50
    moved_5 = moved_5a - moved_5b + (t_0 * G_7 - t_1 * G_6) + M_55
    G_0a_abs = absolute(G_0a)
    G_0b_abs = absolute(G_0b)
    G_0_size = G_0a_abs + G_0b_abs + absolute(M_30)
    G_1_size = absolute(G_1a) + absolute(G_1b) + absolute(M_31)
    G_2_size = absolute(G_2a) + absolute(G_2b) + absolute(M_32)
    G_3_size = absolute(G_3a) + absolute(G_3b) + absolute(M_40)
    G_4a_abs = absolute(G_4a)
    G_4_size = G_0b_abs + G_4a_abs + absolute(M_41)
    G_5_size = absolute(G_5a) + absolute(G_5b) + absolute(M_42)
    G_6_size = absolute(G_6a) + absolute(G_6b) + absolute(M_50)
    G_7_size = absolute(G_7a) + absolute(G_7b) + absolute(M_51)
    G_8_size = G_4a_abs + G_0a_abs + absolute(M_52)
    G_2_padded = G_2_size + c1
    t_1_abs = absolute(t_1)
    G_1_padded = G_1_size + c1
    t_2_abs = absolute(t_2)
    moved_0_size = (absolute(moved_0a) + absolute(moved_0b)
        + (t_1_abs * G_2_padded + t_2_abs * G_1_padded) + absolute(M_33))
    G_5_padded = G_5_size + c1
    G_4_padded = G_4_size + c1
    moved_1_size = (absolute(moved_1a) + absolute(moved_1b)
        + (t_1_abs * G_5_padded + t_2_abs * G_4_padded) + absolute(M_43))
    G_3_padded = G_3_size + c1
    t_0_abs = absolute(t_0)
    moved_2_size = (absolute(moved_2a) + absolute(moved_2b)
        + (t_2_abs * G_3_padded + t_0_abs * G_5_padded) + absolute(M_44))
    G_8_padded = G_8_size + c1
    G_7_padded = G_7_size + c1
    moved_3_size = (absolute(moved_3a) + absolute(moved_3b)
        + (t_1_abs * G_8_padded + t_2_abs * G_7_padded) + absolute(M_53))
    G_6_padded = G_6_size + c1
    moved_4_size = (absolute(moved_4a) + absolute(moved_4b)
        + (t_2_abs * G_6_padded + t_0_abs * G_8_padded) + absolute(M_54))
    moved_5_size = (absolute(moved_5a) + absolute(moved_5b)
        + (t_0_abs * G_7_padded + t_1_abs * G_6_padded) + absolute(M_55))
    G_0_bound = c2 * (G_0_size + c1)
    G_3_bound = c2 * G_3_padded
    G_6_bound = c2 * G_6_padded
    G_1_bound = c2 * G_1_padded
    G_4_bound = c2 * G_4_padded
    G_7_bound = c2 * G_7_padded
    G_2_bound = c2 * G_2_padded
    G_5_bound = c2 * G_5_padded
    G_8_bound = c2 * G_8_padded
    moved_0_bound = c3 * (moved_0_size + c1)
    moved_1_bound = c3 * (moved_1_size + c1)
    moved_3_bound = c3 * (moved_3_size + c1)
    moved_2_bound = c3 * (moved_2_size + c1)
    moved_4_bound = c3 * (moved_4_size + c1)
    moved_5_bound = c3 * (moved_5_size + c1)
    return (M_00, M_10, M_20, G_0, G_3, G_6, M_10, M_11, M_21, G_1, G_4, G_7, M_20, M_21, M_22, G_2,
        G_5, G_8, G_0, G_1, G_2, moved_0, moved_1, moved_3, G_3, G_4, G_5, moved_1, moved_2,
        moved_4, G_6, G_7, G_8, moved_3, moved_4, moved_5, 0, 0, 0, G_0_bound, G_3_bound, G_6_bound,
        0, 0, 0, G_1_bound, G_4_bound, G_7_bound, 0, 0, 0, G_2_bound, G_5_bound, G_8_bound,
        G_0_bound, G_1_bound, G_2_bound, moved_0_bound, moved_1_bound, moved_3_bound, G_3_bound,
        G_4_bound, G_5_bound, moved_1_bound, moved_2_bound, moved_4_bound, G_6_bound, G_7_bound,
        G_8_bound, moved_3_bound, moved_4_bound, moved_5_bound)
