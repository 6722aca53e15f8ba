# Made by `coscrew generate`; changes are overwritten.
# SPDX-License-Identifier: MIT
# coscrew 0.2.0.  Copyright (c) 2026 The coscrew authors.
"""Inertias of rigid bodies: mass, mass times centre of mass, moments about the centre of mass.

In double precision, certified tier.
"""

from numpy import absolute
from coscrew._kernel import double_kernel as kernel
from numpy import errstate


@kernel("(),(3),(),(),(),(),(),()->(10),(10)")
@errstate(all="ignore")
def inertia(m, t, Ixx, Iyy, Izz, Ixy, Iyz, Izx, *, c1=2.004168360008973e-292,
        c2=1.1102230246251568e-16):
    """J = (m; m t; Ixx, Iyy, Izz, Ixy, Iyz, Izx): mass, centre of mass t in m, entries of the
    moments' matrix about it in kg m^2, Ixy = -∫ x y dm; |error of J| <= J_bound unless inf or
    NaN.

    (),(3),(),(),(),(),(),()->(10),(10).  m, Ixx, Iyy, Izz, Ixy, Iyz, Izx: number; t: vector; J,
    J_bound: inertia (m in kg; mt = m c in kg m; I about the centre of mass c, xx, yy, zz, xy,
    yz, zx in kg m^2).
    6 mul, 3 add, 3 abs.
    """
    t_0, t_1, t_2 = t
    J_1 = m * t_0
    J_2 = m * t_1
    J_3 = m * t_2
    J_1_bound = c2 * (absolute(J_1) + c1)
    J_2_bound = c2 * (absolute(J_2) + c1)
    J_3_bound = c2 * (absolute(J_3) + c1)
    return (m, J_1, J_2, J_3, Ixx, Iyy, Izz, Ixy, Iyz, Izx, 0, J_1_bound, J_2_bound, J_3_bound, 0,
        0, 0, 0, 0, 0)


@kernel("(10),(3,3)->(10),(10)")
@errstate(all="ignore")
def inertia_rotated(Ji, R, *, c1=2.004168360008973e-292, c2=3.3306690738754706e-16,
        c3=6.661338147750942e-16):
    """Jo = Ji rotated by R: m, R mt, R I R^T; |error of Jo| <= Jo_bound unless inf or NaN.

    (10),(3,3)->(10),(10).  Ji, Jo, Jo_bound: inertia (m in kg; mt = m c in kg m; I about the
    centre of mass c, xx, yy, zz, xy, yz, zx in kg m^2); R: rotation or other 3×3 matrix.
    81 mul, 90 add, 45 abs.
    """
    Ji_0, Ji_1, Ji_2, Ji_3, Ji_4, Ji_5, Ji_6, Ji_7, Ji_8, Ji_9 = Ji
    R_00, R_01, R_02, R_10, R_11, R_12, R_20, R_21, R_22 = R
    RI_0a = Ji_4 * R_00
    RI_0b = Ji_7 * R_01
    RI_0d = Ji_9 * R_02
    RI_0 = RI_0a + RI_0b + RI_0d
    RI_1a = Ji_5 * R_01
    RI_1b = Ji_7 * R_00
    RI_1d = Ji_8 * R_02
    RI_1 = RI_1a + RI_1b + RI_1d
    RI_2a = Ji_6 * R_02
    RI_2b = Ji_8 * R_01
    RI_2d = Ji_9 * R_00
    RI_2 = RI_2a + RI_2b + RI_2d
    RI_3a = Ji_4 * R_10
    RI_3b = Ji_7 * R_11
    RI_3d = Ji_9 * R_12
    RI_3 = RI_3a + RI_3b + RI_3d
    RI_4a = Ji_5 * R_11
    RI_4b = Ji_7 * R_10
    RI_4d = Ji_8 * R_12
    RI_4 = RI_4a + RI_4b + RI_4d
    RI_5a = Ji_6 * R_12
    RI_5b = Ji_8 * R_11
    RI_5d = Ji_9 * R_10
    RI_5 = RI_5a + RI_5b + RI_5d
    RI_6a = Ji_4 * R_20
    RI_6b = Ji_7 * R_21
    RI_6d = Ji_9 * R_22
    RI_6 = RI_6a + RI_6b + RI_6d
    RI_7a = Ji_5 * R_21
    RI_7b = Ji_7 * R_20
    RI_7d = Ji_8 * R_22
    RI_7 = RI_7a + RI_7b + RI_7d
    RI_8a = Ji_6 * R_22
    RI_8b = Ji_8 * R_21
    RI_8d = Ji_9 * R_20
    RI_8 = RI_8a + RI_8b + RI_8d
    Jo_1a = Ji_1 * R_00
    Jo_1b = Ji_2 * R_01
    Jo_1d = Ji_3 * R_02
    Jo_1 = Jo_1a + Jo_1b + Jo_1d
    Jo_2a = Ji_1 * R_10
    Jo_2b = Ji_2 * R_11
    Jo_2d = Ji_3 * R_12
    Jo_2 = Jo_2a + Jo_2b + Jo_2d
    Jo_3a = Ji_1 * R_20
    Jo_3b = Ji_2 * R_21
    Jo_3d = Ji_3 * R_22
    Jo_3 = Jo_3a + Jo_3b + Jo_3d
    Jo_4 = R_00 * RI_0 + R_01 * RI_1 + R_02 * RI_2
    Jo_5 = R_10 * RI_3 + R_11 * RI_4 + R_12 * RI_5
    Jo_6 = R_20 * RI_6 + R_21 * RI_7 + R_22 * RI_8
    Jo_7 = R_10 * RI_0 + R_11 * RI_1 + R_12 * RI_2
    Jo_8 = R_20 * RI_3 + R_21 * RI_4 + R_22 * RI_5
    Jo_9 = R_20 * RI_0 + R_21 * RI_1 + R_22 * RI_2
    RI_0_size = absolute(RI_0a) + absolute(RI_0b) + absolute(RI_0d)
    RI_1_size = absolute(RI_1a) + absolute(RI_1b) + absolute(RI_1d)
    RI_2_size = absolute(RI_2a) + absolute(RI_2b) + absolute(RI_2d)
    RI_3_size = absolute(RI_3a) + absolute(RI_3b) + absolute(RI_3d)
    RI_4_size = absolute(RI_4a) + absolute(RI_4b) + absolute(RI_4d)
    RI_5_size = absolute(RI_5a) + absolute(RI_5b) + absolute(RI_5d)
    RI_6_size = absolute(RI_6a) + absolute(RI_6b) + absolute(RI_6d)
    RI_7_size = absolute(RI_7a) + absolute(RI_7b) + absolute(RI_7d)
    RI_8_size = absolute(RI_8a) + absolute(RI_8b) + absolute(RI_8d)
    Jo_1_size = absolute(Jo_1a) + absolute(Jo_1b) + absolute(Jo_1d)
    Jo_2_size = absolute(Jo_2a) + absolute(Jo_2b) + absolute(Jo_2d)
    Jo_3_size = absolute(Jo_3a) + absolute(Jo_3b) + absolute(Jo_3d)
    RI_0_padded = RI_0_size + c1
    RI_1_padded = RI_1_size + c1
    RI_2_padded = RI_2_size + c1
    Jo_4_size = (absolute(R_00) * RI_0_padded + absolute(R_01) * RI_1_padded + absolute(R_02)
        * RI_2_padded)
    RI_3_padded = RI_3_size + c1
    R_10_abs = absolute(R_10)
    RI_4_padded = RI_4_size + c1
    R_11_abs = absolute(R_11)
    RI_5_padded = RI_5_size + c1
    R_12_abs = absolute(R_12)
    Jo_5_size = R_10_abs * RI_3_padded + R_11_abs * RI_4_padded + R_12_abs * RI_5_padded
    R_20_abs = absolute(R_20)
    R_21_abs = absolute(R_21)
    R_22_abs = absolute(R_22)
    Jo_6_size = (R_20_abs * (RI_6_size + c1) + R_21_abs * (RI_7_size + c1) + R_22_abs
        * (RI_8_size + c1))
    Jo_7_size = R_10_abs * RI_0_padded + R_11_abs * RI_1_padded + R_12_abs * RI_2_padded
    Jo_8_size = R_20_abs * RI_3_padded + R_21_abs * RI_4_padded + R_22_abs * RI_5_padded
    Jo_9_size = R_20_abs * RI_0_padded + R_21_abs * RI_1_padded + R_22_abs * RI_2_padded
    Jo_1_bound = c2 * (Jo_1_size + c1)
    Jo_2_bound = c2 * (Jo_2_size + c1)
    Jo_3_bound = c2 * (Jo_3_size + c1)
    Jo_4_bound = c3 * (Jo_4_size + c1)
    Jo_5_bound = c3 * (Jo_5_size + c1)
    Jo_6_bound = c3 * (Jo_6_size + c1)
    Jo_7_bound = c3 * (Jo_7_size + c1)
    Jo_8_bound = c3 * (Jo_8_size + c1)
    Jo_9_bound = c3 * (Jo_9_size + c1)
    return (Ji_0, Jo_1, Jo_2, Jo_3, Jo_4, Jo_5, Jo_6, Jo_7, Jo_8, Jo_9, 0, Jo_1_bound, Jo_2_bound,
        Jo_3_bound, Jo_4_bound, Jo_5_bound, Jo_6_bound, Jo_7_bound, Jo_8_bound, Jo_9_bound)


@kernel("(10),(3,3)->(10),(10)")
@errstate(all="ignore")
def inertia_rotate(self, R, *, c1=2.004168360008973e-292, c2=3.3306690738754706e-16,
        c3=6.661338147750942e-16):
    """self = self rotated by R: m, R mt, R I R^T; |error of self| <= self_bound unless inf or NaN.

    (10),(3,3)->(10),(10).  self, self_bound: inertia (m in kg; mt = m c in kg m; I about the
    centre of mass c, xx, yy, zz, xy, yz, zx in kg m^2); R: rotation or other 3×3 matrix.
    81 mul, 90 add, 45 abs.
    """
    self_0, self_1, self_2, self_3, self_4, self_5, self_6, self_7, self_8, self_9 = self
    R_00, R_01, R_02, R_10, R_11, R_12, R_20, R_21, R_22 = R
    RI_0a = self_4 * R_00
    RI_0b = self_7 * R_01
    RI_0d = self_9 * R_02
    RI_0 = RI_0a + RI_0b + RI_0d
    RI_1a = self_5 * R_01
    RI_1b = self_7 * R_00
    RI_1d = self_8 * R_02
    RI_1 = RI_1a + RI_1b + RI_1d
    RI_2a = self_6 * R_02
    RI_2b = self_8 * R_01
    RI_2d = self_9 * R_00
    RI_2 = RI_2a + RI_2b + RI_2d
    RI_3a = self_4 * R_10
    RI_3b = self_7 * R_11
    RI_3d = self_9 * R_12
    RI_3 = RI_3a + RI_3b + RI_3d
    RI_4a = self_5 * R_11
    RI_4b = self_7 * R_10
    RI_4d = self_8 * R_12
    RI_4 = RI_4a + RI_4b + RI_4d
    RI_5a = self_6 * R_12
    RI_5b = self_8 * R_11
    RI_5d = self_9 * R_10
    RI_5 = RI_5a + RI_5b + RI_5d
    RI_6a = self_4 * R_20
    RI_6b = self_7 * R_21
    RI_6d = self_9 * R_22
    RI_6 = RI_6a + RI_6b + RI_6d
    RI_7a = self_5 * R_21
    RI_7b = self_7 * R_20
    RI_7d = self_8 * R_22
    RI_7 = RI_7a + RI_7b + RI_7d
    RI_8a = self_6 * R_22
    RI_8b = self_8 * R_21
    RI_8d = self_9 * R_20
    RI_8 = RI_8a + RI_8b + RI_8d
    self_1_new_a = self_1 * R_00
    self_1_new_b = self_2 * R_01
    self_1_new_d = self_3 * R_02
    self_1_new = self_1_new_a + self_1_new_b + self_1_new_d
    self_2_new_a = self_1 * R_10
    self_2_new_b = self_2 * R_11
    self_2_new_d = self_3 * R_12
    self_2_new = self_2_new_a + self_2_new_b + self_2_new_d
    self_3_new_a = self_1 * R_20
    self_3_new_b = self_2 * R_21
    self_3_new_d = self_3 * R_22
    self_3_new = self_3_new_a + self_3_new_b + self_3_new_d
    self_4_new = R_00 * RI_0 + R_01 * RI_1 + R_02 * RI_2
    self_5_new = R_10 * RI_3 + R_11 * RI_4 + R_12 * RI_5
    self_6_new = R_20 * RI_6 + R_21 * RI_7 + R_22 * RI_8
    self_7_new = R_10 * RI_0 + R_11 * RI_1 + R_12 * RI_2
    self_8_new = R_20 * RI_3 + R_21 * RI_4 + R_22 * RI_5
    self_9_new = R_20 * RI_0 + R_21 * RI_1 + R_22 * RI_2
    RI_0_size = absolute(RI_0a) + absolute(RI_0b) + absolute(RI_0d)
    RI_1_size = absolute(RI_1a) + absolute(RI_1b) + absolute(RI_1d)
    RI_2_size = absolute(RI_2a) + absolute(RI_2b) + absolute(RI_2d)
    RI_3_size = absolute(RI_3a) + absolute(RI_3b) + absolute(RI_3d)
    RI_4_size = absolute(RI_4a) + absolute(RI_4b) + absolute(RI_4d)
    RI_5_size = absolute(RI_5a) + absolute(RI_5b) + absolute(RI_5d)
    RI_6_size = absolute(RI_6a) + absolute(RI_6b) + absolute(RI_6d)
    RI_7_size = absolute(RI_7a) + absolute(RI_7b) + absolute(RI_7d)
    RI_8_size = absolute(RI_8a) + absolute(RI_8b) + absolute(RI_8d)
    self_1_new_size = absolute(self_1_new_a) + absolute(self_1_new_b) + absolute(self_1_new_d)
    self_2_new_size = absolute(self_2_new_a) + absolute(self_2_new_b) + absolute(self_2_new_d)
    self_3_new_size = absolute(self_3_new_a) + absolute(self_3_new_b) + absolute(self_3_new_d)
    RI_0_padded = RI_0_size + c1
    RI_1_padded = RI_1_size + c1
    RI_2_padded = RI_2_size + c1
    self_4_new_size = (absolute(R_00) * RI_0_padded + absolute(R_01) * RI_1_padded + absolute(R_02)
        * RI_2_padded)
    RI_3_padded = RI_3_size + c1
    R_10_abs = absolute(R_10)
    RI_4_padded = RI_4_size + c1
    R_11_abs = absolute(R_11)
    RI_5_padded = RI_5_size + c1
    R_12_abs = absolute(R_12)
    self_5_new_size = R_10_abs * RI_3_padded + R_11_abs * RI_4_padded + R_12_abs * RI_5_padded
    R_20_abs = absolute(R_20)
    R_21_abs = absolute(R_21)
    R_22_abs = absolute(R_22)
    self_6_new_size = (R_20_abs * (RI_6_size + c1) + R_21_abs * (RI_7_size + c1) + R_22_abs
        * (RI_8_size + c1))
    self_7_new_size = R_10_abs * RI_0_padded + R_11_abs * RI_1_padded + R_12_abs * RI_2_padded
    self_8_new_size = R_20_abs * RI_3_padded + R_21_abs * RI_4_padded + R_22_abs * RI_5_padded
    self_9_new_size = R_20_abs * RI_0_padded + R_21_abs * RI_1_padded + R_22_abs * RI_2_padded
    self_1_new_bound = c2 * (self_1_new_size + c1)
    self_2_new_bound = c2 * (self_2_new_size + c1)
    self_3_new_bound = c2 * (self_3_new_size + c1)
    self_4_new_bound = c3 * (self_4_new_size + c1)
    self_5_new_bound = c3 * (self_5_new_size + c1)
    self_6_new_bound = c3 * (self_6_new_size + c1)
    self_7_new_bound = c3 * (self_7_new_size + c1)
    self_8_new_bound = c3 * (self_8_new_size + c1)
    self_9_new_bound = c3 * (self_9_new_size + c1)
    return (self_0, self_1_new, self_2_new, self_3_new, self_4_new, self_5_new, self_6_new,
        self_7_new, self_8_new, self_9_new, 0, self_1_new_bound, self_2_new_bound, self_3_new_bound,
        self_4_new_bound, self_5_new_bound, self_6_new_bound, self_7_new_bound, self_8_new_bound,
        self_9_new_bound)


@kernel("(10),(3)->(10),(10)")
@errstate(all="ignore")
def inertia_translated(Ji, t, *, c1=2.004168360008973e-292, c2=2.2204460492503136e-16):
    """Jo = Ji translated by t: m, mt + m t, I; |error of Jo| <= Jo_bound unless inf or NaN.

    (10),(3)->(10),(10).  Ji, Jo, Jo_bound: inertia (m in kg; mt = m c in kg m; I about the
    centre of mass c, xx, yy, zz, xy, yz, zx in kg m^2); t: vector.
    6 mul, 9 add, 6 abs.
    """
    Ji_0, Ji_1, Ji_2, Ji_3, Ji_4, Ji_5, Ji_6, Ji_7, Ji_8, Ji_9 = Ji
    t_0, t_1, t_2 = t
    Jo_1a = Ji_0 * t_0
    Jo_1 = Jo_1a + Ji_1
    Jo_2a = Ji_0 * t_1
    Jo_2 = Jo_2a + Ji_2
    Jo_3a = Ji_0 * t_2
    Jo_3 = Jo_3a + Ji_3
    Jo_1_size = absolute(Jo_1a) + absolute(Ji_1)
    Jo_2_size = absolute(Jo_2a) + absolute(Ji_2)
    Jo_3_size = absolute(Jo_3a) + absolute(Ji_3)
    Jo_1_bound = c2 * (Jo_1_size + c1)
    Jo_2_bound = c2 * (Jo_2_size + c1)
    Jo_3_bound = c2 * (Jo_3_size + c1)
    return (Ji_0, Jo_1, Jo_2, Jo_3, Ji_4, Ji_5, Ji_6, Ji_7, Ji_8, Ji_9, 0, Jo_1_bound, Jo_2_bound,
        Jo_3_bound, 0, 0, 0, 0, 0, 0)


@kernel("(10),(3)->(10),(10)")
@errstate(all="ignore")
def inertia_translate(self, t, *, c1=2.004168360008973e-292, c2=2.2204460492503136e-16):
    """self = self translated by t: m, mt + m t, I; |error of self| <= self_bound unless inf or
    NaN.

    (10),(3)->(10),(10).  self, self_bound: inertia (m in kg; mt = m c in kg m; I about the
    centre of mass c, xx, yy, zz, xy, yz, zx in kg m^2); t: vector.
    6 mul, 9 add, 6 abs.
    """
    self_0, self_1, self_2, self_3, self_4, self_5, self_6, self_7, self_8, self_9 = self
    t_0, t_1, t_2 = t
    self_1_new_a = self_0 * t_0
    self_1_new = self_1_new_a + self_1
    self_2_new_a = self_0 * t_1
    self_2_new = self_2_new_a + self_2
    self_3_new_a = self_0 * t_2
    self_3_new = self_3_new_a + self_3
    self_1_new_size = absolute(self_1_new_a) + absolute(self_1)
    self_2_new_size = absolute(self_2_new_a) + absolute(self_2)
    self_3_new_size = absolute(self_3_new_a) + absolute(self_3)
    self_1_new_bound = c2 * (self_1_new_size + c1)
    self_2_new_bound = c2 * (self_2_new_size + c1)
    self_3_new_bound = c2 * (self_3_new_size + c1)
    return (self_0, self_1_new, self_2_new, self_3_new, self_4, self_5, self_6, self_7, self_8,
        self_9, 0, self_1_new_bound, self_2_new_bound, self_3_new_bound, 0, 0, 0, 0, 0, 0)


@kernel("(10),(3,4)->(10),(10)")
@errstate(all="ignore")
def inertia_transformed(Ji, D, *, c1=2.004168360008973e-292, c2=4.440892098500628e-16,
        c3=6.661338147750942e-16):
    """Jo = Ji displaced by D = [R | t]: m, R mt + m t, R I R^T; |error of Jo| <= Jo_bound unless
    inf or NaN.

    (10),(3,4)->(10),(10).  Ji, Jo, Jo_bound: inertia (m in kg; mt = m c in kg m; I about the
    centre of mass c, xx, yy, zz, xy, yz, zx in kg m^2); D: displacement [R | t], R rotation, t
    in m.
    84 mul, 96 add, 48 abs.
    """
    Ji_0, Ji_1, Ji_2, Ji_3, Ji_4, Ji_5, Ji_6, Ji_7, Ji_8, Ji_9 = Ji
    D_00, D_01, D_02, D_03, D_10, D_11, D_12, D_13, D_20, D_21, D_22, D_23 = D
    RI_0a = Ji_4 * D_00
    RI_0b = Ji_7 * D_01
    RI_0d = Ji_9 * D_02
    RI_0 = RI_0a + RI_0b + RI_0d
    RI_1a = Ji_5 * D_01
    RI_1b = Ji_7 * D_00
    RI_1d = Ji_8 * D_02
    RI_1 = RI_1a + RI_1b + RI_1d
    RI_2a = Ji_6 * D_02
    RI_2b = Ji_8 * D_01
    RI_2d = Ji_9 * D_00
    RI_2 = RI_2a + RI_2b + RI_2d
    RI_3a = Ji_4 * D_10
    RI_3b = Ji_7 * D_11
    RI_3d = Ji_9 * D_12
    RI_3 = RI_3a + RI_3b + RI_3d
    RI_4a = Ji_5 * D_11
    RI_4b = Ji_7 * D_10
    RI_4d = Ji_8 * D_12
    RI_4 = RI_4a + RI_4b + RI_4d
    RI_5a = Ji_6 * D_12
    RI_5b = Ji_8 * D_11
    RI_5d = Ji_9 * D_10
    RI_5 = RI_5a + RI_5b + RI_5d
    RI_6a = Ji_4 * D_20
    RI_6b = Ji_7 * D_21
    RI_6d = Ji_9 * D_22
    RI_6 = RI_6a + RI_6b + RI_6d
    RI_7a = Ji_5 * D_21
    RI_7b = Ji_7 * D_20
    RI_7d = Ji_8 * D_22
    RI_7 = RI_7a + RI_7b + RI_7d
    RI_8a = Ji_6 * D_22
    RI_8b = Ji_8 * D_21
    RI_8d = Ji_9 * D_20
    RI_8 = RI_8a + RI_8b + RI_8d
    Jo_1a = Ji_0 * D_03
    Jo_1b = Ji_1 * D_00
    Jo_1c = Ji_2 * D_01
    Jo_1e = Ji_3 * D_02
    Jo_1 = Jo_1a + (Jo_1b + Jo_1c + Jo_1e)
    Jo_2a = Ji_0 * D_13
    Jo_2b = Ji_1 * D_10
    Jo_2c = Ji_2 * D_11
    Jo_2e = Ji_3 * D_12
    Jo_2 = Jo_2a + (Jo_2b + Jo_2c + Jo_2e)
    Jo_3a = Ji_0 * D_23
    Jo_3b = Ji_1 * D_20
    Jo_3c = Ji_2 * D_21
    Jo_3e = Ji_3 * D_22
    Jo_3 = Jo_3a + (Jo_3b + Jo_3c + Jo_3e)
    Jo_4 = D_00 * RI_0 + D_01 * RI_1 + D_02 * RI_2
    Jo_5 = D_10 * RI_3 + D_11 * RI_4 + D_12 * RI_5
    Jo_6 = D_20 * RI_6 + D_21 * RI_7 + D_22 * RI_8
    Jo_7 = D_10 * RI_0 + D_11 * RI_1 + D_12 * RI_2
    Jo_8 = D_20 * RI_3 + D_21 * RI_4 + D_22 * RI_5
    Jo_9 = D_20 * RI_0 + D_21 * RI_1 + D_22 * RI_2
    RI_0_size = absolute(RI_0a) + absolute(RI_0b) + absolute(RI_0d)
    RI_1_size = absolute(RI_1a) + absolute(RI_1b) + absolute(RI_1d)
    RI_2_size = absolute(RI_2a) + absolute(RI_2b) + absolute(RI_2d)
    RI_3_size = absolute(RI_3a) + absolute(RI_3b) + absolute(RI_3d)
    RI_4_size = absolute(RI_4a) + absolute(RI_4b) + absolute(RI_4d)
    RI_5_size = absolute(RI_5a) + absolute(RI_5b) + absolute(RI_5d)
    RI_6_size = absolute(RI_6a) + absolute(RI_6b) + absolute(RI_6d)
    RI_7_size = absolute(RI_7a) + absolute(RI_7b) + absolute(RI_7d)
    RI_8_size = absolute(RI_8a) + absolute(RI_8b) + absolute(RI_8d)
    Jo_1_size = absolute(Jo_1a) + (absolute(Jo_1b) + absolute(Jo_1c) + absolute(Jo_1e))
    Jo_2_size = absolute(Jo_2a) + (absolute(Jo_2b) + absolute(Jo_2c) + absolute(Jo_2e))
    Jo_3_size = absolute(Jo_3a) + (absolute(Jo_3b) + absolute(Jo_3c) + absolute(Jo_3e))
    RI_0_padded = RI_0_size + c1
    RI_1_padded = RI_1_size + c1
    RI_2_padded = RI_2_size + c1
    Jo_4_size = (absolute(D_00) * RI_0_padded + absolute(D_01) * RI_1_padded + absolute(D_02)
        * RI_2_padded)
    RI_3_padded = RI_3_size + c1
    D_10_abs = absolute(D_10)
    RI_4_padded = RI_4_size + c1
    D_11_abs = absolute(D_11)
    RI_5_padded = RI_5_size + c1
    D_12_abs = absolute(D_12)
    Jo_5_size = D_10_abs * RI_3_padded + D_11_abs * RI_4_padded + D_12_abs * RI_5_padded
    D_20_abs = absolute(D_20)
    D_21_abs = absolute(D_21)
    D_22_abs = absolute(D_22)
    Jo_6_size = (D_20_abs * (RI_6_size + c1) + D_21_abs * (RI_7_size + c1) + D_22_abs
        * (RI_8_size + c1))
    Jo_7_size = D_10_abs * RI_0_padded + D_11_abs * RI_1_padded + D_12_abs * RI_2_padded
    Jo_8_size = D_20_abs * RI_3_padded + D_21_abs * RI_4_padded + D_22_abs * RI_5_padded
    Jo_9_size = D_20_abs * RI_0_padded + D_21_abs * RI_1_padded + D_22_abs * RI_2_padded
    Jo_1_bound = c2 * (Jo_1_size + c1)
    Jo_2_bound = c2 * (Jo_2_size + c1)
    Jo_3_bound = c2 * (Jo_3_size + c1)
    Jo_4_bound = c3 * (Jo_4_size + c1)
    Jo_5_bound = c3 * (Jo_5_size + c1)
    Jo_6_bound = c3 * (Jo_6_size + c1)
    Jo_7_bound = c3 * (Jo_7_size + c1)
    Jo_8_bound = c3 * (Jo_8_size + c1)
    Jo_9_bound = c3 * (Jo_9_size + c1)
    return (Ji_0, Jo_1, Jo_2, Jo_3, Jo_4, Jo_5, Jo_6, Jo_7, Jo_8, Jo_9, 0, Jo_1_bound, Jo_2_bound,
        Jo_3_bound, Jo_4_bound, Jo_5_bound, Jo_6_bound, Jo_7_bound, Jo_8_bound, Jo_9_bound)


@kernel("(10),(3,4)->(10),(10)")
@errstate(all="ignore")
def inertia_transform(self, D, *, c1=2.004168360008973e-292, c2=4.440892098500628e-16,
        c3=6.661338147750942e-16):
    """self = self displaced by D = [R | t]: m, R mt + m t, R I R^T; |error of self| <= self_bound
    unless inf or NaN.

    (10),(3,4)->(10),(10).  self, self_bound: inertia (m in kg; mt = m c in kg m; I about the
    centre of mass c, xx, yy, zz, xy, yz, zx in kg m^2); D: displacement [R | t], R rotation, t
    in m.
    84 mul, 96 add, 48 abs.
    """
    self_0, self_1, self_2, self_3, self_4, self_5, self_6, self_7, self_8, self_9 = self
    D_00, D_01, D_02, D_03, D_10, D_11, D_12, D_13, D_20, D_21, D_22, D_23 = D
    RI_0a = self_4 * D_00
    RI_0b = self_7 * D_01
    RI_0d = self_9 * D_02
    RI_0 = RI_0a + RI_0b + RI_0d
    RI_1a = self_5 * D_01
    RI_1b = self_7 * D_00
    RI_1d = self_8 * D_02
    RI_1 = RI_1a + RI_1b + RI_1d
    RI_2a = self_6 * D_02
    RI_2b = self_8 * D_01
    RI_2d = self_9 * D_00
    RI_2 = RI_2a + RI_2b + RI_2d
    RI_3a = self_4 * D_10
    RI_3b = self_7 * D_11
    RI_3d = self_9 * D_12
    RI_3 = RI_3a + RI_3b + RI_3d
    RI_4a = self_5 * D_11
    RI_4b = self_7 * D_10
    RI_4d = self_8 * D_12
    RI_4 = RI_4a + RI_4b + RI_4d
    RI_5a = self_6 * D_12
    RI_5b = self_8 * D_11
    RI_5d = self_9 * D_10
    RI_5 = RI_5a + RI_5b + RI_5d
    RI_6a = self_4 * D_20
    RI_6b = self_7 * D_21
    RI_6d = self_9 * D_22
    RI_6 = RI_6a + RI_6b + RI_6d
    RI_7a = self_5 * D_21
    RI_7b = self_7 * D_20
    RI_7d = self_8 * D_22
    RI_7 = RI_7a + RI_7b + RI_7d
    RI_8a = self_6 * D_22
    RI_8b = self_8 * D_21
    RI_8d = self_9 * D_20
    RI_8 = RI_8a + RI_8b + RI_8d
    self_1_new_a = self_0 * D_03
    self_1_new_b = self_1 * D_00
    self_1_new_c = self_2 * D_01
    self_1_new_e = self_3 * D_02
    self_1_new = self_1_new_a + (self_1_new_b + self_1_new_c + self_1_new_e)
    self_2_new_a = self_0 * D_13
    self_2_new_b = self_1 * D_10
    self_2_new_c = self_2 * D_11
    self_2_new_e = self_3 * D_12
    self_2_new = self_2_new_a + (self_2_new_b + self_2_new_c + self_2_new_e)
    self_3_new_a = self_0 * D_23
    self_3_new_b = self_1 * D_20
    self_3_new_c = self_2 * D_21
    self_3_new_e = self_3 * D_22
    self_3_new = self_3_new_a + (self_3_new_b + self_3_new_c + self_3_new_e)
    self_4_new = D_00 * RI_0 + D_01 * RI_1 + D_02 * RI_2
    self_5_new = D_10 * RI_3 + D_11 * RI_4 + D_12 * RI_5
    self_6_new = D_20 * RI_6 + D_21 * RI_7 + D_22 * RI_8
    self_7_new = D_10 * RI_0 + D_11 * RI_1 + D_12 * RI_2
    self_8_new = D_20 * RI_3 + D_21 * RI_4 + D_22 * RI_5
    self_9_new = D_20 * RI_0 + D_21 * RI_1 + D_22 * RI_2
    RI_0_size = absolute(RI_0a) + absolute(RI_0b) + absolute(RI_0d)
    RI_1_size = absolute(RI_1a) + absolute(RI_1b) + absolute(RI_1d)
    RI_2_size = absolute(RI_2a) + absolute(RI_2b) + absolute(RI_2d)
    RI_3_size = absolute(RI_3a) + absolute(RI_3b) + absolute(RI_3d)
    RI_4_size = absolute(RI_4a) + absolute(RI_4b) + absolute(RI_4d)
    RI_5_size = absolute(RI_5a) + absolute(RI_5b) + absolute(RI_5d)
    RI_6_size = absolute(RI_6a) + absolute(RI_6b) + absolute(RI_6d)
    RI_7_size = absolute(RI_7a) + absolute(RI_7b) + absolute(RI_7d)
    RI_8_size = absolute(RI_8a) + absolute(RI_8b) + absolute(RI_8d)
    self_1_new_size = (absolute(self_1_new_a)
        + (absolute(self_1_new_b) + absolute(self_1_new_c) + absolute(self_1_new_e)))
    self_2_new_size = (absolute(self_2_new_a)
        + (absolute(self_2_new_b) + absolute(self_2_new_c) + absolute(self_2_new_e)))
    self_3_new_size = (absolute(self_3_new_a)
        + (absolute(self_3_new_b) + absolute(self_3_new_c) + absolute(self_3_new_e)))
    RI_0_padded = RI_0_size + c1
    RI_1_padded = RI_1_size + c1
    RI_2_padded = RI_2_size + c1
    self_4_new_size = (absolute(D_00) * RI_0_padded + absolute(D_01) * RI_1_padded + absolute(D_02)
        * RI_2_padded)
    RI_3_padded = RI_3_size + c1
    D_10_abs = absolute(D_10)
    RI_4_padded = RI_4_size + c1
    D_11_abs = absolute(D_11)
    RI_5_padded = RI_5_size + c1
    D_12_abs = absolute(D_12)
    self_5_new_size = D_10_abs * RI_3_padded + D_11_abs * RI_4_padded + D_12_abs * RI_5_padded
    D_20_abs = absolute(D_20)
    D_21_abs = absolute(D_21)
    D_22_abs = absolute(D_22)
    self_6_new_size = (D_20_abs * (RI_6_size + c1) + D_21_abs * (RI_7_size + c1) + D_22_abs
        * (RI_8_size + c1))
    self_7_new_size = D_10_abs * RI_0_padded + D_11_abs * RI_1_padded + D_12_abs * RI_2_padded
    self_8_new_size = D_20_abs * RI_3_padded + D_21_abs * RI_4_padded + D_22_abs * RI_5_padded
    self_9_new_size = D_20_abs * RI_0_padded + D_21_abs * RI_1_padded + D_22_abs * RI_2_padded
    self_1_new_bound = c2 * (self_1_new_size + c1)
    self_2_new_bound = c2 * (self_2_new_size + c1)
    self_3_new_bound = c2 * (self_3_new_size + c1)
    self_4_new_bound = c3 * (self_4_new_size + c1)
    self_5_new_bound = c3 * (self_5_new_size + c1)
    self_6_new_bound = c3 * (self_6_new_size + c1)
    self_7_new_bound = c3 * (self_7_new_size + c1)
    self_8_new_bound = c3 * (self_8_new_size + c1)
    self_9_new_bound = c3 * (self_9_new_size + c1)
    return (self_0, self_1_new, self_2_new, self_3_new, self_4_new, self_5_new, self_6_new,
        self_7_new, self_8_new, self_9_new, 0, self_1_new_bound, self_2_new_bound, self_3_new_bound,
        self_4_new_bound, self_5_new_bound, self_6_new_bound, self_7_new_bound, self_8_new_bound,
        self_9_new_bound)
