# Made by `coscrew generate`; changes are overwritten.
# SPDX-License-Identifier: MIT
# coscrew 0.2.0.  Copyright (c) 2026 The coscrew authors.
"""Inertias of rigid bodies: mass, mass times centre of mass, moments about the centre of mass.

In double precision, accurate tier.
"""

from numpy import where
from coscrew._exact import product_error, product_rest
from coscrew._kernel import double_kernel as kernel


@kernel("(),(3),(),(),(),(),(),()->(10)")
def inertia(m, t, Ixx, Iyy, Izz, Ixy, Iyz, Izx):
    """J = (m; m t; Ixx, Iyy, Izz, Ixy, Iyz, Izx): mass, centre of mass t in m, entries of the
    moments' matrix about it in kg m^2, Ixy = -∫ x y dm.

    (),(3),(),(),(),(),(),()->(10).  m, Ixx, Iyy, Izz, Ixy, Iyz, Izx: number; t: vector; J:
    inertia (m in kg; mt = m c in kg m; I about the centre of mass c, xx, yy, zz, xy, yz, zx in
    kg m^2).
    3 mul, 3 add, 3 product error.  Error <= u |result|, barring over- and underflow.
    """
    t_0, t_1, t_2 = t
    J_1 = m * t_0
    J_2 = m * t_1
    J_3 = m * t_2
    J_1_rounded = J_1 + product_error(m, t_0, J_1)
    J_2_rounded = J_2 + product_error(m, t_1, J_2)
    J_3_rounded = J_3 + product_error(m, t_2, J_3)
    return (m, J_1_rounded, J_2_rounded, J_3_rounded, Ixx, Iyy, Izz, Ixy, Iyz, Izx)


@kernel("(10),(3,3)->(10)")
def inertia_rotated(Ji, R):
    """Jo = Ji rotated by R: m, R mt, R I R^T.

    (10),(3,3)->(10).  Ji, Jo: inertia (m in kg; mt = m c in kg m; I about the centre of mass c,
    xx, yy, zz, xy, yz, zx in kg m^2); R: rotation or other 3×3 matrix.
    72 mul, 207 add, 54 product rest.  Error <= u |result| + (m: 0, mt: 11, I: 37) u^2 S, S the
    sum of the |terms| of the expanded formula; barring over- and underflow.
    """
    Ji_0, Ji_1, Ji_2, Ji_3, Ji_4, Ji_5, Ji_6, Ji_7, Ji_8, Ji_9 = Ji
    R_00, R_01, R_02, R_10, R_11, R_12, R_20, R_21, R_22 = R
    RI_0a = Ji_4 * R_00
    RI_0b = Ji_7 * R_01
    RI_0c = RI_0a + RI_0b
    RI_0c_right = RI_0c - RI_0a
    RI_0d = Ji_9 * R_02
    RI_0 = RI_0c + RI_0d
    RI_0_right = RI_0 - RI_0c
    RI_0c_lo = (product_rest(Ji_4, R_00, RI_0a, RI_0c - RI_0c_right)
        + product_rest(Ji_7, R_01, RI_0b, RI_0c_right))
    RI_0_lo = RI_0c - (RI_0 - RI_0_right) + product_rest(Ji_9, R_02, RI_0d, RI_0_right) + RI_0c_lo
    RI_1a = Ji_5 * R_01
    RI_1b = Ji_7 * R_00
    RI_1c = RI_1a + RI_1b
    RI_1c_right = RI_1c - RI_1a
    RI_1d = Ji_8 * R_02
    RI_1 = RI_1c + RI_1d
    RI_1_right = RI_1 - RI_1c
    RI_1c_lo = (product_rest(Ji_5, R_01, RI_1a, RI_1c - RI_1c_right)
        + product_rest(Ji_7, R_00, RI_1b, RI_1c_right))
    RI_1_lo = RI_1c - (RI_1 - RI_1_right) + product_rest(Ji_8, R_02, RI_1d, RI_1_right) + RI_1c_lo
    RI_2a = Ji_6 * R_02
    RI_2b = Ji_8 * R_01
    RI_2c = RI_2a + RI_2b
    RI_2c_right = RI_2c - RI_2a
    RI_2d = Ji_9 * R_00
    RI_2 = RI_2c + RI_2d
    RI_2_right = RI_2 - RI_2c
    RI_2c_lo = (product_rest(Ji_6, R_02, RI_2a, RI_2c - RI_2c_right)
        + product_rest(Ji_8, R_01, RI_2b, RI_2c_right))
    RI_2_lo = RI_2c - (RI_2 - RI_2_right) + product_rest(Ji_9, R_00, RI_2d, RI_2_right) + RI_2c_lo
    RI_3a = Ji_4 * R_10
    RI_3b = Ji_7 * R_11
    RI_3c = RI_3a + RI_3b
    RI_3c_right = RI_3c - RI_3a
    RI_3d = Ji_9 * R_12
    RI_3 = RI_3c + RI_3d
    RI_3_right = RI_3 - RI_3c
    RI_3c_lo = (product_rest(Ji_4, R_10, RI_3a, RI_3c - RI_3c_right)
        + product_rest(Ji_7, R_11, RI_3b, RI_3c_right))
    RI_3_lo = RI_3c - (RI_3 - RI_3_right) + product_rest(Ji_9, R_12, RI_3d, RI_3_right) + RI_3c_lo
    RI_4a = Ji_5 * R_11
    RI_4b = Ji_7 * R_10
    RI_4c = RI_4a + RI_4b
    RI_4c_right = RI_4c - RI_4a
    RI_4d = Ji_8 * R_12
    RI_4 = RI_4c + RI_4d
    RI_4_right = RI_4 - RI_4c
    RI_4c_lo = (product_rest(Ji_5, R_11, RI_4a, RI_4c - RI_4c_right)
        + product_rest(Ji_7, R_10, RI_4b, RI_4c_right))
    RI_4_lo = RI_4c - (RI_4 - RI_4_right) + product_rest(Ji_8, R_12, RI_4d, RI_4_right) + RI_4c_lo
    RI_5a = Ji_6 * R_12
    RI_5b = Ji_8 * R_11
    RI_5c = RI_5a + RI_5b
    RI_5c_right = RI_5c - RI_5a
    RI_5d = Ji_9 * R_10
    RI_5 = RI_5c + RI_5d
    RI_5_right = RI_5 - RI_5c
    RI_5c_lo = (product_rest(Ji_6, R_12, RI_5a, RI_5c - RI_5c_right)
        + product_rest(Ji_8, R_11, RI_5b, RI_5c_right))
    RI_5_lo = RI_5c - (RI_5 - RI_5_right) + product_rest(Ji_9, R_10, RI_5d, RI_5_right) + RI_5c_lo
    RI_6a = Ji_4 * R_20
    RI_6b = Ji_7 * R_21
    RI_6c = RI_6a + RI_6b
    RI_6c_right = RI_6c - RI_6a
    RI_6d = Ji_9 * R_22
    RI_6 = RI_6c + RI_6d
    RI_6_right = RI_6 - RI_6c
    RI_6c_lo = (product_rest(Ji_4, R_20, RI_6a, RI_6c - RI_6c_right)
        + product_rest(Ji_7, R_21, RI_6b, RI_6c_right))
    RI_7a = Ji_5 * R_21
    RI_7b = Ji_7 * R_20
    RI_7c = RI_7a + RI_7b
    RI_7c_right = RI_7c - RI_7a
    RI_7d = Ji_8 * R_22
    RI_7 = RI_7c + RI_7d
    RI_7_right = RI_7 - RI_7c
    RI_7c_lo = (product_rest(Ji_5, R_21, RI_7a, RI_7c - RI_7c_right)
        + product_rest(Ji_7, R_20, RI_7b, RI_7c_right))
    RI_8a = Ji_6 * R_22
    RI_8b = Ji_8 * R_21
    RI_8c = RI_8a + RI_8b
    RI_8c_right = RI_8c - RI_8a
    RI_8d = Ji_9 * R_20
    RI_8 = RI_8c + RI_8d
    RI_8_right = RI_8 - RI_8c
    RI_8c_lo = (product_rest(Ji_6, R_22, RI_8a, RI_8c - RI_8c_right)
        + product_rest(Ji_8, R_21, RI_8b, RI_8c_right))
    Jo_1a = Ji_1 * R_00
    Jo_1b = Ji_2 * R_01
    Jo_1c = Jo_1a + Jo_1b
    Jo_1c_right = Jo_1c - Jo_1a
    Jo_1d = Ji_3 * R_02
    Jo_1 = Jo_1c + Jo_1d
    Jo_1_right = Jo_1 - Jo_1c
    Jo_1c_lo = (product_rest(Ji_1, R_00, Jo_1a, Jo_1c - Jo_1c_right)
        + product_rest(Ji_2, R_01, Jo_1b, Jo_1c_right))
    Jo_2a = Ji_1 * R_10
    Jo_2b = Ji_2 * R_11
    Jo_2c = Jo_2a + Jo_2b
    Jo_2c_right = Jo_2c - Jo_2a
    Jo_2d = Ji_3 * R_12
    Jo_2 = Jo_2c + Jo_2d
    Jo_2_right = Jo_2 - Jo_2c
    Jo_2c_lo = (product_rest(Ji_1, R_10, Jo_2a, Jo_2c - Jo_2c_right)
        + product_rest(Ji_2, R_11, Jo_2b, Jo_2c_right))
    Jo_3a = Ji_1 * R_20
    Jo_3b = Ji_2 * R_21
    Jo_3c = Jo_3a + Jo_3b
    Jo_3c_right = Jo_3c - Jo_3a
    Jo_3d = Ji_3 * R_22
    Jo_3 = Jo_3c + Jo_3d
    Jo_3_right = Jo_3 - Jo_3c
    Jo_3c_lo = (product_rest(Ji_1, R_20, Jo_3a, Jo_3c - Jo_3c_right)
        + product_rest(Ji_2, R_21, Jo_3b, Jo_3c_right))
    Jo_4a = R_00 * RI_0
    Jo_4b = R_01 * RI_1
    Jo_4c = Jo_4a + Jo_4b
    Jo_4c_right = Jo_4c - Jo_4a
    Jo_4d = R_02 * RI_2
    Jo_4 = Jo_4c + Jo_4d
    Jo_4_right = Jo_4 - Jo_4c
    Jo_4c_lo = (product_rest(R_00, RI_0, Jo_4a, Jo_4c - Jo_4c_right)
        + product_rest(R_01, RI_1, Jo_4b, Jo_4c_right) + (R_00 * RI_0_lo + R_01 * RI_1_lo))
    Jo_5a = R_10 * RI_3
    Jo_5b = R_11 * RI_4
    Jo_5c = Jo_5a + Jo_5b
    Jo_5c_right = Jo_5c - Jo_5a
    Jo_5d = R_12 * RI_5
    Jo_5 = Jo_5c + Jo_5d
    Jo_5_right = Jo_5 - Jo_5c
    Jo_5c_lo = (product_rest(R_10, RI_3, Jo_5a, Jo_5c - Jo_5c_right)
        + product_rest(R_11, RI_4, Jo_5b, Jo_5c_right) + (R_10 * RI_3_lo + R_11 * RI_4_lo))
    Jo_6a = R_20 * RI_6
    Jo_6b = R_21 * RI_7
    Jo_6c = Jo_6a + Jo_6b
    Jo_6c_right = Jo_6c - Jo_6a
    Jo_6a_cross2 = (R_20
        * (RI_6c - (RI_6 - RI_6_right) + product_rest(Ji_9, R_22, RI_6d, RI_6_right) + RI_6c_lo))
    Jo_6c_cross = (Jo_6a_cross2 + R_21
        * (RI_7c - (RI_7 - RI_7_right) + product_rest(Ji_8, R_22, RI_7d, RI_7_right) + RI_7c_lo))
    Jo_6d = R_22 * RI_8
    Jo_6 = Jo_6c + Jo_6d
    Jo_6_right = Jo_6 - Jo_6c
    Jo_6d_cross2 = (R_22
        * (RI_8c - (RI_8 - RI_8_right) + product_rest(Ji_9, R_20, RI_8d, RI_8_right) + RI_8c_lo))
    Jo_6c_lo = (product_rest(R_20, RI_6, Jo_6a, Jo_6c - Jo_6c_right)
        + product_rest(R_21, RI_7, Jo_6b, Jo_6c_right) + Jo_6c_cross)
    Jo_7a = R_10 * RI_0
    Jo_7b = R_11 * RI_1
    Jo_7c = Jo_7a + Jo_7b
    Jo_7c_right = Jo_7c - Jo_7a
    Jo_7d = R_12 * RI_2
    Jo_7 = Jo_7c + Jo_7d
    Jo_7_right = Jo_7 - Jo_7c
    Jo_7c_lo = (product_rest(R_10, RI_0, Jo_7a, Jo_7c - Jo_7c_right)
        + product_rest(R_11, RI_1, Jo_7b, Jo_7c_right) + (R_10 * RI_0_lo + R_11 * RI_1_lo))
    Jo_8a = R_20 * RI_3
    Jo_8b = R_21 * RI_4
    Jo_8c = Jo_8a + Jo_8b
    Jo_8c_right = Jo_8c - Jo_8a
    Jo_8d = R_22 * RI_5
    Jo_8 = Jo_8c + Jo_8d
    Jo_8_right = Jo_8 - Jo_8c
    Jo_8c_lo = (product_rest(R_20, RI_3, Jo_8a, Jo_8c - Jo_8c_right)
        + product_rest(R_21, RI_4, Jo_8b, Jo_8c_right) + (R_20 * RI_3_lo + R_21 * RI_4_lo))
    Jo_9a = R_20 * RI_0
    Jo_9b = R_21 * RI_1
    Jo_9c = Jo_9a + Jo_9b
    Jo_9c_right = Jo_9c - Jo_9a
    Jo_9d = R_22 * RI_2
    Jo_9 = Jo_9c + Jo_9d
    Jo_9_right = Jo_9 - Jo_9c
    Jo_9c_lo = (product_rest(R_20, RI_0, Jo_9a, Jo_9c - Jo_9c_right)
        + product_rest(R_21, RI_1, Jo_9b, Jo_9c_right) + (R_20 * RI_0_lo + R_21 * RI_1_lo))
    Jo_1_rounded = (Jo_1
        + (Jo_1c - (Jo_1 - Jo_1_right) + product_rest(Ji_3, R_02, Jo_1d, Jo_1_right) + Jo_1c_lo))
    Jo_2_rounded = (Jo_2
        + (Jo_2c - (Jo_2 - Jo_2_right) + product_rest(Ji_3, R_12, Jo_2d, Jo_2_right) + Jo_2c_lo))
    Jo_3_rounded = (Jo_3
        + (Jo_3c - (Jo_3 - Jo_3_right) + product_rest(Ji_3, R_22, Jo_3d, Jo_3_right) + Jo_3c_lo))
    Jo_4_rounded = (Jo_4
        + (Jo_4c - (Jo_4 - Jo_4_right) + product_rest(R_02, RI_2, Jo_4d, Jo_4_right) + R_02
        * RI_2_lo + Jo_4c_lo))
    Jo_5_rounded = (Jo_5
        + (Jo_5c - (Jo_5 - Jo_5_right) + product_rest(R_12, RI_5, Jo_5d, Jo_5_right) + R_12
        * RI_5_lo + Jo_5c_lo))
    Jo_6_rounded = (Jo_6
        + (Jo_6c - (Jo_6 - Jo_6_right) + product_rest(R_22, RI_8, Jo_6d, Jo_6_right) + Jo_6d_cross2
        + Jo_6c_lo))
    Jo_7_rounded = (Jo_7
        + (Jo_7c - (Jo_7 - Jo_7_right) + product_rest(R_12, RI_2, Jo_7d, Jo_7_right) + R_12
        * RI_2_lo + Jo_7c_lo))
    Jo_8_rounded = (Jo_8
        + (Jo_8c - (Jo_8 - Jo_8_right) + product_rest(R_22, RI_5, Jo_8d, Jo_8_right) + R_22
        * RI_5_lo + Jo_8c_lo))
    Jo_9_rounded = (Jo_9
        + (Jo_9c - (Jo_9 - Jo_9_right) + product_rest(R_22, RI_2, Jo_9d, Jo_9_right) + R_22
        * RI_2_lo + Jo_9c_lo))
    return (Ji_0, Jo_1_rounded, Jo_2_rounded, Jo_3_rounded, Jo_4_rounded, Jo_5_rounded,
        Jo_6_rounded, Jo_7_rounded, Jo_8_rounded, Jo_9_rounded)


@kernel("(10),(3,3)->(10)")
def inertia_rotate(self, R):
    """self = self rotated by R: m, R mt, R I R^T.

    (10),(3,3)->(10).  self: inertia (m in kg; mt = m c in kg m; I about the centre of mass c,
    xx, yy, zz, xy, yz, zx in kg m^2); R: rotation or other 3×3 matrix.
    72 mul, 207 add, 54 product rest.  Error <= u |result| + (m: 0, mt: 11, I: 37) u^2 S, S the
    sum of the |terms| of the expanded formula; barring over- and underflow.
    """
    self_0, self_1, self_2, self_3, self_4, self_5, self_6, self_7, self_8, self_9 = self
    R_00, R_01, R_02, R_10, R_11, R_12, R_20, R_21, R_22 = R
    RI_0a = self_4 * R_00
    RI_0b = self_7 * R_01
    RI_0c = RI_0a + RI_0b
    RI_0c_right = RI_0c - RI_0a
    RI_0d = self_9 * R_02
    RI_0 = RI_0c + RI_0d
    RI_0_right = RI_0 - RI_0c
    RI_0c_lo = (product_rest(self_4, R_00, RI_0a, RI_0c - RI_0c_right)
        + product_rest(self_7, R_01, RI_0b, RI_0c_right))
    RI_0_lo = RI_0c - (RI_0 - RI_0_right) + product_rest(self_9, R_02, RI_0d, RI_0_right) + RI_0c_lo
    RI_1a = self_5 * R_01
    RI_1b = self_7 * R_00
    RI_1c = RI_1a + RI_1b
    RI_1c_right = RI_1c - RI_1a
    RI_1d = self_8 * R_02
    RI_1 = RI_1c + RI_1d
    RI_1_right = RI_1 - RI_1c
    RI_1c_lo = (product_rest(self_5, R_01, RI_1a, RI_1c - RI_1c_right)
        + product_rest(self_7, R_00, RI_1b, RI_1c_right))
    RI_1_lo = RI_1c - (RI_1 - RI_1_right) + product_rest(self_8, R_02, RI_1d, RI_1_right) + RI_1c_lo
    RI_2a = self_6 * R_02
    RI_2b = self_8 * R_01
    RI_2c = RI_2a + RI_2b
    RI_2c_right = RI_2c - RI_2a
    RI_2d = self_9 * R_00
    RI_2 = RI_2c + RI_2d
    RI_2_right = RI_2 - RI_2c
    RI_2c_lo = (product_rest(self_6, R_02, RI_2a, RI_2c - RI_2c_right)
        + product_rest(self_8, R_01, RI_2b, RI_2c_right))
    RI_2_lo = RI_2c - (RI_2 - RI_2_right) + product_rest(self_9, R_00, RI_2d, RI_2_right) + RI_2c_lo
    RI_3a = self_4 * R_10
    RI_3b = self_7 * R_11
    RI_3c = RI_3a + RI_3b
    RI_3c_right = RI_3c - RI_3a
    RI_3d = self_9 * R_12
    RI_3 = RI_3c + RI_3d
    RI_3_right = RI_3 - RI_3c
    RI_3c_lo = (product_rest(self_4, R_10, RI_3a, RI_3c - RI_3c_right)
        + product_rest(self_7, R_11, RI_3b, RI_3c_right))
    RI_3_lo = RI_3c - (RI_3 - RI_3_right) + product_rest(self_9, R_12, RI_3d, RI_3_right) + RI_3c_lo
    RI_4a = self_5 * R_11
    RI_4b = self_7 * R_10
    RI_4c = RI_4a + RI_4b
    RI_4c_right = RI_4c - RI_4a
    RI_4d = self_8 * R_12
    RI_4 = RI_4c + RI_4d
    RI_4_right = RI_4 - RI_4c
    RI_4c_lo = (product_rest(self_5, R_11, RI_4a, RI_4c - RI_4c_right)
        + product_rest(self_7, R_10, RI_4b, RI_4c_right))
    RI_4_lo = RI_4c - (RI_4 - RI_4_right) + product_rest(self_8, R_12, RI_4d, RI_4_right) + RI_4c_lo
    RI_5a = self_6 * R_12
    RI_5b = self_8 * R_11
    RI_5c = RI_5a + RI_5b
    RI_5c_right = RI_5c - RI_5a
    RI_5d = self_9 * R_10
    RI_5 = RI_5c + RI_5d
    RI_5_right = RI_5 - RI_5c
    RI_5c_lo = (product_rest(self_6, R_12, RI_5a, RI_5c - RI_5c_right)
        + product_rest(self_8, R_11, RI_5b, RI_5c_right))
    RI_5_lo = RI_5c - (RI_5 - RI_5_right) + product_rest(self_9, R_10, RI_5d, RI_5_right) + RI_5c_lo
    RI_6a = self_4 * R_20
    RI_6b = self_7 * R_21
    RI_6c = RI_6a + RI_6b
    RI_6c_right = RI_6c - RI_6a
    RI_6d = self_9 * R_22
    RI_6 = RI_6c + RI_6d
    RI_6_right = RI_6 - RI_6c
    RI_6c_lo = (product_rest(self_4, R_20, RI_6a, RI_6c - RI_6c_right)
        + product_rest(self_7, R_21, RI_6b, RI_6c_right))
    RI_7a = self_5 * R_21
    RI_7b = self_7 * R_20
    RI_7c = RI_7a + RI_7b
    RI_7c_right = RI_7c - RI_7a
    RI_7d = self_8 * R_22
    RI_7 = RI_7c + RI_7d
    RI_7_right = RI_7 - RI_7c
    RI_7c_lo = (product_rest(self_5, R_21, RI_7a, RI_7c - RI_7c_right)
        + product_rest(self_7, R_20, RI_7b, RI_7c_right))
    RI_8a = self_6 * R_22
    RI_8b = self_8 * R_21
    RI_8c = RI_8a + RI_8b
    RI_8c_right = RI_8c - RI_8a
    RI_8d = self_9 * R_20
    RI_8 = RI_8c + RI_8d
    RI_8_right = RI_8 - RI_8c
    RI_8c_lo = (product_rest(self_6, R_22, RI_8a, RI_8c - RI_8c_right)
        + product_rest(self_8, R_21, RI_8b, RI_8c_right))
    self_1_new_a = self_1 * R_00
    self_1_new_b = self_2 * R_01
    self_1_new_c = self_1_new_a + self_1_new_b
    self_1_new_c_right = self_1_new_c - self_1_new_a
    self_1_new_c_left_rest = product_rest(self_1, R_00, self_1_new_a,
        self_1_new_c - self_1_new_c_right)
    self_1_new_d = self_3 * R_02
    self_1_new = self_1_new_c + self_1_new_d
    self_1_new_right = self_1_new - self_1_new_c
    self_1_new_lo1 = (self_1_new_c - (self_1_new - self_1_new_right)
        + product_rest(self_3, R_02, self_1_new_d, self_1_new_right))
    self_2_new_a = self_1 * R_10
    self_2_new_b = self_2 * R_11
    self_2_new_c = self_2_new_a + self_2_new_b
    self_2_new_c_right = self_2_new_c - self_2_new_a
    self_2_new_c_left_rest = product_rest(self_1, R_10, self_2_new_a,
        self_2_new_c - self_2_new_c_right)
    self_2_new_d = self_3 * R_12
    self_2_new = self_2_new_c + self_2_new_d
    self_2_new_right = self_2_new - self_2_new_c
    self_2_new_lo1 = (self_2_new_c - (self_2_new - self_2_new_right)
        + product_rest(self_3, R_12, self_2_new_d, self_2_new_right))
    self_3_new_a = self_1 * R_20
    self_3_new_b = self_2 * R_21
    self_3_new_c = self_3_new_a + self_3_new_b
    self_3_new_c_right = self_3_new_c - self_3_new_a
    self_3_new_c_left_rest = product_rest(self_1, R_20, self_3_new_a,
        self_3_new_c - self_3_new_c_right)
    self_3_new_d = self_3 * R_22
    self_3_new = self_3_new_c + self_3_new_d
    self_3_new_right = self_3_new - self_3_new_c
    self_3_new_lo1 = (self_3_new_c - (self_3_new - self_3_new_right)
        + product_rest(self_3, R_22, self_3_new_d, self_3_new_right))
    self_4_new_a = R_00 * RI_0
    self_4_new_b = R_01 * RI_1
    self_4_new_c = self_4_new_a + self_4_new_b
    self_4_new_c_right = self_4_new_c - self_4_new_a
    self_4_new_c_left_rest = product_rest(R_00, RI_0, self_4_new_a,
        self_4_new_c - self_4_new_c_right)
    self_4_new_d = R_02 * RI_2
    self_4_new = self_4_new_c + self_4_new_d
    self_4_new_right = self_4_new - self_4_new_c
    self_4_new_lo2 = (self_4_new_c - (self_4_new - self_4_new_right)
        + product_rest(R_02, RI_2, self_4_new_d, self_4_new_right) + R_02 * RI_2_lo)
    self_4_new_c_lo = (self_4_new_c_left_rest
        + product_rest(R_01, RI_1, self_4_new_b, self_4_new_c_right)
        + (R_00 * RI_0_lo + R_01 * RI_1_lo))
    self_5_new_a = R_10 * RI_3
    self_5_new_b = R_11 * RI_4
    self_5_new_c = self_5_new_a + self_5_new_b
    self_5_new_c_right = self_5_new_c - self_5_new_a
    self_5_new_c_left_rest = product_rest(R_10, RI_3, self_5_new_a,
        self_5_new_c - self_5_new_c_right)
    self_5_new_d = R_12 * RI_5
    self_5_new = self_5_new_c + self_5_new_d
    self_5_new_right = self_5_new - self_5_new_c
    self_5_new_lo2 = (self_5_new_c - (self_5_new - self_5_new_right)
        + product_rest(R_12, RI_5, self_5_new_d, self_5_new_right) + R_12 * RI_5_lo)
    self_5_new_c_lo = (self_5_new_c_left_rest
        + product_rest(R_11, RI_4, self_5_new_b, self_5_new_c_right)
        + (R_10 * RI_3_lo + R_11 * RI_4_lo))
    self_6_new_a = R_20 * RI_6
    self_6_new_b = R_21 * RI_7
    self_6_new_c = self_6_new_a + self_6_new_b
    self_6_new_c_right = self_6_new_c - self_6_new_a
    self_6_new_a_cross2 = (R_20
        * (RI_6c - (RI_6 - RI_6_right) + product_rest(self_9, R_22, RI_6d, RI_6_right) + RI_6c_lo))
    self_6_new_c_left_rest = product_rest(R_20, RI_6, self_6_new_a,
        self_6_new_c - self_6_new_c_right)
    self_6_new_c_cross = (self_6_new_a_cross2 + R_21
        * (RI_7c - (RI_7 - RI_7_right) + product_rest(self_8, R_22, RI_7d, RI_7_right) + RI_7c_lo))
    self_6_new_d = R_22 * RI_8
    self_6_new = self_6_new_c + self_6_new_d
    self_6_new_right = self_6_new - self_6_new_c
    self_6_new_lo1 = (self_6_new_c - (self_6_new - self_6_new_right)
        + product_rest(R_22, RI_8, self_6_new_d, self_6_new_right))
    self_6_new_lo2 = (self_6_new_lo1 + R_22
        * (RI_8c - (RI_8 - RI_8_right) + product_rest(self_9, R_20, RI_8d, RI_8_right) + RI_8c_lo))
    self_7_new_a = R_10 * RI_0
    self_7_new_b = R_11 * RI_1
    self_7_new_c = self_7_new_a + self_7_new_b
    self_7_new_c_right = self_7_new_c - self_7_new_a
    self_7_new_c_left_rest = product_rest(R_10, RI_0, self_7_new_a,
        self_7_new_c - self_7_new_c_right)
    self_7_new_d = R_12 * RI_2
    self_7_new = self_7_new_c + self_7_new_d
    self_7_new_right = self_7_new - self_7_new_c
    self_7_new_lo2 = (self_7_new_c - (self_7_new - self_7_new_right)
        + product_rest(R_12, RI_2, self_7_new_d, self_7_new_right) + R_12 * RI_2_lo)
    self_7_new_c_lo = (self_7_new_c_left_rest
        + product_rest(R_11, RI_1, self_7_new_b, self_7_new_c_right)
        + (R_10 * RI_0_lo + R_11 * RI_1_lo))
    self_8_new_a = R_20 * RI_3
    self_8_new_b = R_21 * RI_4
    self_8_new_c = self_8_new_a + self_8_new_b
    self_8_new_c_right = self_8_new_c - self_8_new_a
    self_8_new_c_left_rest = product_rest(R_20, RI_3, self_8_new_a,
        self_8_new_c - self_8_new_c_right)
    self_8_new_d = R_22 * RI_5
    self_8_new = self_8_new_c + self_8_new_d
    self_8_new_right = self_8_new - self_8_new_c
    self_8_new_lo2 = (self_8_new_c - (self_8_new - self_8_new_right)
        + product_rest(R_22, RI_5, self_8_new_d, self_8_new_right) + R_22 * RI_5_lo)
    self_8_new_c_lo = (self_8_new_c_left_rest
        + product_rest(R_21, RI_4, self_8_new_b, self_8_new_c_right)
        + (R_20 * RI_3_lo + R_21 * RI_4_lo))
    self_9_new_a = R_20 * RI_0
    self_9_new_b = R_21 * RI_1
    self_9_new_c = self_9_new_a + self_9_new_b
    self_9_new_c_right = self_9_new_c - self_9_new_a
    self_9_new_c_left_rest = product_rest(R_20, RI_0, self_9_new_a,
        self_9_new_c - self_9_new_c_right)
    self_9_new_d = R_22 * RI_2
    self_9_new = self_9_new_c + self_9_new_d
    self_9_new_right = self_9_new - self_9_new_c
    self_9_new_lo2 = (self_9_new_c - (self_9_new - self_9_new_right)
        + product_rest(R_22, RI_2, self_9_new_d, self_9_new_right) + R_22 * RI_2_lo)
    self_9_new_c_lo = (self_9_new_c_left_rest
        + product_rest(R_21, RI_1, self_9_new_b, self_9_new_c_right)
        + (R_20 * RI_0_lo + R_21 * RI_1_lo))
    self_1_new_rounded = (self_1_new
        + (self_1_new_lo1
        + (self_1_new_c_left_rest + product_rest(self_2, R_01, self_1_new_b, self_1_new_c_right))))
    self_2_new_rounded = (self_2_new
        + (self_2_new_lo1
        + (self_2_new_c_left_rest + product_rest(self_2, R_11, self_2_new_b, self_2_new_c_right))))
    self_3_new_rounded = (self_3_new
        + (self_3_new_lo1
        + (self_3_new_c_left_rest + product_rest(self_2, R_21, self_3_new_b, self_3_new_c_right))))
    self_4_new_rounded = self_4_new + (self_4_new_lo2 + self_4_new_c_lo)
    self_5_new_rounded = self_5_new + (self_5_new_lo2 + self_5_new_c_lo)
    self_6_new_lo = (self_6_new_lo2
        + (self_6_new_c_left_rest + product_rest(R_21, RI_7, self_6_new_b, self_6_new_c_right)
        + self_6_new_c_cross))
    self_6_new_rounded = self_6_new + self_6_new_lo
    self_7_new_rounded = self_7_new + (self_7_new_lo2 + self_7_new_c_lo)
    self_8_new_rounded = self_8_new + (self_8_new_lo2 + self_8_new_c_lo)
    self_9_new_rounded = self_9_new + (self_9_new_lo2 + self_9_new_c_lo)
    return (self_0, self_1_new_rounded, self_2_new_rounded, self_3_new_rounded, self_4_new_rounded,
        self_5_new_rounded, self_6_new_rounded, self_7_new_rounded, self_8_new_rounded,
        self_9_new_rounded)


@kernel("(10),(3)->(10)")
def inertia_translated(Ji, t):
    """Jo = Ji translated by t: m, mt + m t, I.

    (10),(3)->(10).  Ji, Jo: inertia (m in kg; mt = m c in kg m; I about the centre of mass c,
    xx, yy, zz, xy, yz, zx in kg m^2); t: vector.
    3 mul, 18 add, 3 product rest.  Error <= u |result| + (m: 0, mt: 3, I: 0) u^2 S, S the sum
    of the |terms| of the expanded formula; barring over- and underflow.
    """
    Ji_0, Ji_1, Ji_2, Ji_3, Ji_4, Ji_5, Ji_6, Ji_7, Ji_8, Ji_9 = Ji
    t_0, t_1, t_2 = t
    Jo_1a = Ji_0 * t_0
    Jo_1 = Jo_1a + Ji_1
    Jo_1_right = Jo_1 - Jo_1a
    Jo_2a = Ji_0 * t_1
    Jo_2 = Jo_2a + Ji_2
    Jo_2_right = Jo_2 - Jo_2a
    Jo_3a = Ji_0 * t_2
    Jo_3 = Jo_3a + Ji_3
    Jo_3_right = Jo_3 - Jo_3a
    Jo_1_rounded = Jo_1 + (product_rest(Ji_0, t_0, Jo_1a, Jo_1 - Jo_1_right) + (Ji_1 - Jo_1_right))
    Jo_2_rounded = Jo_2 + (product_rest(Ji_0, t_1, Jo_2a, Jo_2 - Jo_2_right) + (Ji_2 - Jo_2_right))
    Jo_3_rounded = Jo_3 + (product_rest(Ji_0, t_2, Jo_3a, Jo_3 - Jo_3_right) + (Ji_3 - Jo_3_right))
    return (Ji_0, Jo_1_rounded, Jo_2_rounded, Jo_3_rounded, Ji_4, Ji_5, Ji_6, Ji_7, Ji_8, Ji_9)


@kernel("(10),(3)->(10)")
def inertia_translate(self, t):
    """self = self translated by t: m, mt + m t, I.

    (10),(3)->(10).  self: inertia (m in kg; mt = m c in kg m; I about the centre of mass c, xx,
    yy, zz, xy, yz, zx in kg m^2); t: vector.
    3 mul, 18 add, 3 product rest.  Error <= u |result| + (m: 0, mt: 3, I: 0) u^2 S, S the sum
    of the |terms| of the expanded formula; barring over- and underflow.
    """
    self_0, self_1, self_2, self_3, self_4, self_5, self_6, self_7, self_8, self_9 = self
    t_0, t_1, t_2 = t
    self_1_new_a = self_0 * t_0
    self_1_new = self_1_new_a + self_1
    self_1_new_right = self_1_new - self_1_new_a
    self_2_new_a = self_0 * t_1
    self_2_new = self_2_new_a + self_2
    self_2_new_right = self_2_new - self_2_new_a
    self_3_new_a = self_0 * t_2
    self_3_new = self_3_new_a + self_3
    self_3_new_right = self_3_new - self_3_new_a
    self_1_new_rounded = (self_1_new
        + (product_rest(self_0, t_0, self_1_new_a, self_1_new - self_1_new_right)
        + (self_1 - self_1_new_right)))
    self_2_new_rounded = (self_2_new
        + (product_rest(self_0, t_1, self_2_new_a, self_2_new - self_2_new_right)
        + (self_2 - self_2_new_right)))
    self_3_new_rounded = (self_3_new
        + (product_rest(self_0, t_2, self_3_new_a, self_3_new - self_3_new_right)
        + (self_3 - self_3_new_right)))
    return (self_0, self_1_new_rounded, self_2_new_rounded, self_3_new_rounded, self_4, self_5,
        self_6, self_7, self_8, self_9)


@kernel("(10),(3,4)->(10)")
def inertia_transformed(Ji, D):
    """Jo = Ji displaced by D = [R | t]: m, R mt + m t, R I R^T.

    (10),(3,4)->(10).  Ji, Jo: inertia (m in kg; mt = m c in kg m; I about the centre of mass c,
    xx, yy, zz, xy, yz, zx in kg m^2); D: displacement [R | t], R rotation, t in m.
    75 mul, 225 add, 57 product rest.  Error <= u |result| + (m: 0, mt: 17, I: 37) u^2 S, S the
    sum of the |terms| of the expanded formula; barring over- and underflow.
    """
    Ji_0, Ji_1, Ji_2, Ji_3, Ji_4, Ji_5, Ji_6, Ji_7, Ji_8, Ji_9 = Ji
    D_00, D_01, D_02, D_03, D_10, D_11, D_12, D_13, D_20, D_21, D_22, D_23 = D
    RI_0a = Ji_4 * D_00
    RI_0b = Ji_7 * D_01
    RI_0c = RI_0a + RI_0b
    RI_0c_right = RI_0c - RI_0a
    RI_0d = Ji_9 * D_02
    RI_0 = RI_0c + RI_0d
    RI_0_right = RI_0 - RI_0c
    RI_0c_lo = (product_rest(Ji_4, D_00, RI_0a, RI_0c - RI_0c_right)
        + product_rest(Ji_7, D_01, RI_0b, RI_0c_right))
    RI_0_lo = RI_0c - (RI_0 - RI_0_right) + product_rest(Ji_9, D_02, RI_0d, RI_0_right) + RI_0c_lo
    RI_1a = Ji_5 * D_01
    RI_1b = Ji_7 * D_00
    RI_1c = RI_1a + RI_1b
    RI_1c_right = RI_1c - RI_1a
    RI_1d = Ji_8 * D_02
    RI_1 = RI_1c + RI_1d
    RI_1_right = RI_1 - RI_1c
    RI_1c_lo = (product_rest(Ji_5, D_01, RI_1a, RI_1c - RI_1c_right)
        + product_rest(Ji_7, D_00, RI_1b, RI_1c_right))
    RI_1_lo = RI_1c - (RI_1 - RI_1_right) + product_rest(Ji_8, D_02, RI_1d, RI_1_right) + RI_1c_lo
    RI_2a = Ji_6 * D_02
    RI_2b = Ji_8 * D_01
    RI_2c = RI_2a + RI_2b
    RI_2c_right = RI_2c - RI_2a
    RI_2d = Ji_9 * D_00
    RI_2 = RI_2c + RI_2d
    RI_2_right = RI_2 - RI_2c
    RI_2c_lo = (product_rest(Ji_6, D_02, RI_2a, RI_2c - RI_2c_right)
        + product_rest(Ji_8, D_01, RI_2b, RI_2c_right))
    RI_2_lo = RI_2c - (RI_2 - RI_2_right) + product_rest(Ji_9, D_00, RI_2d, RI_2_right) + RI_2c_lo
    RI_3a = Ji_4 * D_10
    RI_3b = Ji_7 * D_11
    RI_3c = RI_3a + RI_3b
    RI_3c_right = RI_3c - RI_3a
    RI_3d = Ji_9 * D_12
    RI_3 = RI_3c + RI_3d
    RI_3_right = RI_3 - RI_3c
    RI_3c_lo = (product_rest(Ji_4, D_10, RI_3a, RI_3c - RI_3c_right)
        + product_rest(Ji_7, D_11, RI_3b, RI_3c_right))
    RI_3_lo = RI_3c - (RI_3 - RI_3_right) + product_rest(Ji_9, D_12, RI_3d, RI_3_right) + RI_3c_lo
    RI_4a = Ji_5 * D_11
    RI_4b = Ji_7 * D_10
    RI_4c = RI_4a + RI_4b
    RI_4c_right = RI_4c - RI_4a
    RI_4d = Ji_8 * D_12
    RI_4 = RI_4c + RI_4d
    RI_4_right = RI_4 - RI_4c
    RI_4c_lo = (product_rest(Ji_5, D_11, RI_4a, RI_4c - RI_4c_right)
        + product_rest(Ji_7, D_10, RI_4b, RI_4c_right))
    RI_4_lo = RI_4c - (RI_4 - RI_4_right) + product_rest(Ji_8, D_12, RI_4d, RI_4_right) + RI_4c_lo
    RI_5a = Ji_6 * D_12
    RI_5b = Ji_8 * D_11
    RI_5c = RI_5a + RI_5b
    RI_5c_right = RI_5c - RI_5a
    RI_5d = Ji_9 * D_10
    RI_5 = RI_5c + RI_5d
    RI_5_right = RI_5 - RI_5c
    RI_5c_lo = (product_rest(Ji_6, D_12, RI_5a, RI_5c - RI_5c_right)
        + product_rest(Ji_8, D_11, RI_5b, RI_5c_right))
    RI_5_lo = RI_5c - (RI_5 - RI_5_right) + product_rest(Ji_9, D_10, RI_5d, RI_5_right) + RI_5c_lo
    RI_6a = Ji_4 * D_20
    RI_6b = Ji_7 * D_21
    RI_6c = RI_6a + RI_6b
    RI_6c_right = RI_6c - RI_6a
    RI_6d = Ji_9 * D_22
    RI_6 = RI_6c + RI_6d
    RI_6_right = RI_6 - RI_6c
    RI_6c_lo = (product_rest(Ji_4, D_20, RI_6a, RI_6c - RI_6c_right)
        + product_rest(Ji_7, D_21, RI_6b, RI_6c_right))
    RI_7a = Ji_5 * D_21
    RI_7b = Ji_7 * D_20
    RI_7c = RI_7a + RI_7b
    RI_7c_right = RI_7c - RI_7a
    RI_7d = Ji_8 * D_22
    RI_7 = RI_7c + RI_7d
    RI_7_right = RI_7 - RI_7c
    RI_7c_lo = (product_rest(Ji_5, D_21, RI_7a, RI_7c - RI_7c_right)
        + product_rest(Ji_7, D_20, RI_7b, RI_7c_right))
    RI_8a = Ji_6 * D_22
    RI_8b = Ji_8 * D_21
    RI_8c = RI_8a + RI_8b
    RI_8c_right = RI_8c - RI_8a
    RI_8d = Ji_9 * D_20
    RI_8 = RI_8c + RI_8d
    RI_8_right = RI_8 - RI_8c
    RI_8c_lo = (product_rest(Ji_6, D_22, RI_8a, RI_8c - RI_8c_right)
        + product_rest(Ji_8, D_21, RI_8b, RI_8c_right))
    Jo_1a = Ji_0 * D_03
    Jo_1b = Ji_1 * D_00
    Jo_1c = Ji_2 * D_01
    Jo_1d = Jo_1b + Jo_1c
    Jo_1d_right = Jo_1d - Jo_1b
    Jo_1e = Ji_3 * D_02
    Jo_1f = Jo_1d + Jo_1e
    Jo_1f_right = Jo_1f - Jo_1d
    Jo_1d_lo = (product_rest(Ji_1, D_00, Jo_1b, Jo_1d - Jo_1d_right)
        + product_rest(Ji_2, D_01, Jo_1c, Jo_1d_right))
    Jo_1 = Jo_1a + Jo_1f
    Jo_1_right = Jo_1 - Jo_1a
    Jo_1f_lo = (Jo_1d - (Jo_1f - Jo_1f_right) + product_rest(Ji_3, D_02, Jo_1e, Jo_1f_right)
        + Jo_1d_lo)
    Jo_2a = Ji_0 * D_13
    Jo_2b = Ji_1 * D_10
    Jo_2c = Ji_2 * D_11
    Jo_2d = Jo_2b + Jo_2c
    Jo_2d_right = Jo_2d - Jo_2b
    Jo_2e = Ji_3 * D_12
    Jo_2f = Jo_2d + Jo_2e
    Jo_2f_right = Jo_2f - Jo_2d
    Jo_2d_lo = (product_rest(Ji_1, D_10, Jo_2b, Jo_2d - Jo_2d_right)
        + product_rest(Ji_2, D_11, Jo_2c, Jo_2d_right))
    Jo_2 = Jo_2a + Jo_2f
    Jo_2_right = Jo_2 - Jo_2a
    Jo_2f_lo = (Jo_2d - (Jo_2f - Jo_2f_right) + product_rest(Ji_3, D_12, Jo_2e, Jo_2f_right)
        + Jo_2d_lo)
    Jo_3a = Ji_0 * D_23
    Jo_3b = Ji_1 * D_20
    Jo_3c = Ji_2 * D_21
    Jo_3d = Jo_3b + Jo_3c
    Jo_3d_right = Jo_3d - Jo_3b
    Jo_3e = Ji_3 * D_22
    Jo_3f = Jo_3d + Jo_3e
    Jo_3f_right = Jo_3f - Jo_3d
    Jo_3d_lo = (product_rest(Ji_1, D_20, Jo_3b, Jo_3d - Jo_3d_right)
        + product_rest(Ji_2, D_21, Jo_3c, Jo_3d_right))
    Jo_3 = Jo_3a + Jo_3f
    Jo_3_right = Jo_3 - Jo_3a
    Jo_3f_lo = (Jo_3d - (Jo_3f - Jo_3f_right) + product_rest(Ji_3, D_22, Jo_3e, Jo_3f_right)
        + Jo_3d_lo)
    Jo_4a = D_00 * RI_0
    Jo_4b = D_01 * RI_1
    Jo_4c = Jo_4a + Jo_4b
    Jo_4c_right = Jo_4c - Jo_4a
    Jo_4d = D_02 * RI_2
    Jo_4 = Jo_4c + Jo_4d
    Jo_4_right = Jo_4 - Jo_4c
    Jo_4c_lo = (product_rest(D_00, RI_0, Jo_4a, Jo_4c - Jo_4c_right)
        + product_rest(D_01, RI_1, Jo_4b, Jo_4c_right) + (D_00 * RI_0_lo + D_01 * RI_1_lo))
    Jo_5a = D_10 * RI_3
    Jo_5b = D_11 * RI_4
    Jo_5c = Jo_5a + Jo_5b
    Jo_5c_right = Jo_5c - Jo_5a
    Jo_5d = D_12 * RI_5
    Jo_5 = Jo_5c + Jo_5d
    Jo_5_right = Jo_5 - Jo_5c
    Jo_5c_lo = (product_rest(D_10, RI_3, Jo_5a, Jo_5c - Jo_5c_right)
        + product_rest(D_11, RI_4, Jo_5b, Jo_5c_right) + (D_10 * RI_3_lo + D_11 * RI_4_lo))
    Jo_6a = D_20 * RI_6
    Jo_6b = D_21 * RI_7
    Jo_6c = Jo_6a + Jo_6b
    Jo_6c_right = Jo_6c - Jo_6a
    Jo_6a_cross2 = (D_20
        * (RI_6c - (RI_6 - RI_6_right) + product_rest(Ji_9, D_22, RI_6d, RI_6_right) + RI_6c_lo))
    Jo_6c_cross = (Jo_6a_cross2 + D_21
        * (RI_7c - (RI_7 - RI_7_right) + product_rest(Ji_8, D_22, RI_7d, RI_7_right) + RI_7c_lo))
    Jo_6d = D_22 * RI_8
    Jo_6 = Jo_6c + Jo_6d
    Jo_6_right = Jo_6 - Jo_6c
    Jo_6d_cross2 = (D_22
        * (RI_8c - (RI_8 - RI_8_right) + product_rest(Ji_9, D_20, RI_8d, RI_8_right) + RI_8c_lo))
    Jo_6c_lo = (product_rest(D_20, RI_6, Jo_6a, Jo_6c - Jo_6c_right)
        + product_rest(D_21, RI_7, Jo_6b, Jo_6c_right) + Jo_6c_cross)
    Jo_7a = D_10 * RI_0
    Jo_7b = D_11 * RI_1
    Jo_7c = Jo_7a + Jo_7b
    Jo_7c_right = Jo_7c - Jo_7a
    Jo_7d = D_12 * RI_2
    Jo_7 = Jo_7c + Jo_7d
    Jo_7_right = Jo_7 - Jo_7c
    Jo_7c_lo = (product_rest(D_10, RI_0, Jo_7a, Jo_7c - Jo_7c_right)
        + product_rest(D_11, RI_1, Jo_7b, Jo_7c_right) + (D_10 * RI_0_lo + D_11 * RI_1_lo))
    Jo_8a = D_20 * RI_3
    Jo_8b = D_21 * RI_4
    Jo_8c = Jo_8a + Jo_8b
    Jo_8c_right = Jo_8c - Jo_8a
    Jo_8d = D_22 * RI_5
    Jo_8 = Jo_8c + Jo_8d
    Jo_8_right = Jo_8 - Jo_8c
    Jo_8c_lo = (product_rest(D_20, RI_3, Jo_8a, Jo_8c - Jo_8c_right)
        + product_rest(D_21, RI_4, Jo_8b, Jo_8c_right) + (D_20 * RI_3_lo + D_21 * RI_4_lo))
    Jo_9a = D_20 * RI_0
    Jo_9b = D_21 * RI_1
    Jo_9c = Jo_9a + Jo_9b
    Jo_9c_right = Jo_9c - Jo_9a
    Jo_9d = D_22 * RI_2
    Jo_9 = Jo_9c + Jo_9d
    Jo_9_right = Jo_9 - Jo_9c
    Jo_9c_lo = (product_rest(D_20, RI_0, Jo_9a, Jo_9c - Jo_9c_right)
        + product_rest(D_21, RI_1, Jo_9b, Jo_9c_right) + (D_20 * RI_0_lo + D_21 * RI_1_lo))
    Jo_1_rounded = (Jo_1
        + (product_rest(Ji_0, D_03, Jo_1a, Jo_1 - Jo_1_right) + (Jo_1f - Jo_1_right) + Jo_1f_lo))
    Jo_2_rounded = (Jo_2
        + (product_rest(Ji_0, D_13, Jo_2a, Jo_2 - Jo_2_right) + (Jo_2f - Jo_2_right) + Jo_2f_lo))
    Jo_3_rounded = (Jo_3
        + (product_rest(Ji_0, D_23, Jo_3a, Jo_3 - Jo_3_right) + (Jo_3f - Jo_3_right) + Jo_3f_lo))
    Jo_4_rounded = (Jo_4
        + (Jo_4c - (Jo_4 - Jo_4_right) + product_rest(D_02, RI_2, Jo_4d, Jo_4_right) + D_02
        * RI_2_lo + Jo_4c_lo))
    Jo_5_rounded = (Jo_5
        + (Jo_5c - (Jo_5 - Jo_5_right) + product_rest(D_12, RI_5, Jo_5d, Jo_5_right) + D_12
        * RI_5_lo + Jo_5c_lo))
    Jo_6_rounded = (Jo_6
        + (Jo_6c - (Jo_6 - Jo_6_right) + product_rest(D_22, RI_8, Jo_6d, Jo_6_right) + Jo_6d_cross2
        + Jo_6c_lo))
    Jo_7_rounded = (Jo_7
        + (Jo_7c - (Jo_7 - Jo_7_right) + product_rest(D_12, RI_2, Jo_7d, Jo_7_right) + D_12
        * RI_2_lo + Jo_7c_lo))
    Jo_8_rounded = (Jo_8
        + (Jo_8c - (Jo_8 - Jo_8_right) + product_rest(D_22, RI_5, Jo_8d, Jo_8_right) + D_22
        * RI_5_lo + Jo_8c_lo))
    Jo_9_rounded = (Jo_9
        + (Jo_9c - (Jo_9 - Jo_9_right) + product_rest(D_22, RI_2, Jo_9d, Jo_9_right) + D_22
        * RI_2_lo + Jo_9c_lo))
    return (Ji_0, Jo_1_rounded, Jo_2_rounded, Jo_3_rounded, Jo_4_rounded, Jo_5_rounded,
        Jo_6_rounded, Jo_7_rounded, Jo_8_rounded, Jo_9_rounded)


@kernel("(10),(3,4)->(10)")
def inertia_transform(self, D):
    """self = self displaced by D = [R | t]: m, R mt + m t, R I R^T.

    (10),(3,4)->(10).  self: inertia (m in kg; mt = m c in kg m; I about the centre of mass c,
    xx, yy, zz, xy, yz, zx in kg m^2); D: displacement [R | t], R rotation, t in m.
    75 mul, 225 add, 57 product rest.  Error <= u |result| + (m: 0, mt: 17, I: 37) u^2 S, S the
    sum of the |terms| of the expanded formula; barring over- and underflow.
    """
    self_0, self_1, self_2, self_3, self_4, self_5, self_6, self_7, self_8, self_9 = self
    D_00, D_01, D_02, D_03, D_10, D_11, D_12, D_13, D_20, D_21, D_22, D_23 = D
    RI_0a = self_4 * D_00
    RI_0b = self_7 * D_01
    RI_0c = RI_0a + RI_0b
    RI_0c_right = RI_0c - RI_0a
    RI_0d = self_9 * D_02
    RI_0 = RI_0c + RI_0d
    RI_0_right = RI_0 - RI_0c
    RI_0c_lo = (product_rest(self_4, D_00, RI_0a, RI_0c - RI_0c_right)
        + product_rest(self_7, D_01, RI_0b, RI_0c_right))
    RI_0_lo = RI_0c - (RI_0 - RI_0_right) + product_rest(self_9, D_02, RI_0d, RI_0_right) + RI_0c_lo
    RI_1a = self_5 * D_01
    RI_1b = self_7 * D_00
    RI_1c = RI_1a + RI_1b
    RI_1c_right = RI_1c - RI_1a
    RI_1d = self_8 * D_02
    RI_1 = RI_1c + RI_1d
    RI_1_right = RI_1 - RI_1c
    RI_1c_lo = (product_rest(self_5, D_01, RI_1a, RI_1c - RI_1c_right)
        + product_rest(self_7, D_00, RI_1b, RI_1c_right))
    RI_1_lo = RI_1c - (RI_1 - RI_1_right) + product_rest(self_8, D_02, RI_1d, RI_1_right) + RI_1c_lo
    RI_2a = self_6 * D_02
    RI_2b = self_8 * D_01
    RI_2c = RI_2a + RI_2b
    RI_2c_right = RI_2c - RI_2a
    RI_2d = self_9 * D_00
    RI_2 = RI_2c + RI_2d
    RI_2_right = RI_2 - RI_2c
    RI_2c_lo = (product_rest(self_6, D_02, RI_2a, RI_2c - RI_2c_right)
        + product_rest(self_8, D_01, RI_2b, RI_2c_right))
    RI_2_lo = RI_2c - (RI_2 - RI_2_right) + product_rest(self_9, D_00, RI_2d, RI_2_right) + RI_2c_lo
    RI_3a = self_4 * D_10
    RI_3b = self_7 * D_11
    RI_3c = RI_3a + RI_3b
    RI_3c_right = RI_3c - RI_3a
    RI_3d = self_9 * D_12
    RI_3 = RI_3c + RI_3d
    RI_3_right = RI_3 - RI_3c
    RI_3c_lo = (product_rest(self_4, D_10, RI_3a, RI_3c - RI_3c_right)
        + product_rest(self_7, D_11, RI_3b, RI_3c_right))
    RI_3_lo = RI_3c - (RI_3 - RI_3_right) + product_rest(self_9, D_12, RI_3d, RI_3_right) + RI_3c_lo
    RI_4a = self_5 * D_11
    RI_4b = self_7 * D_10
    RI_4c = RI_4a + RI_4b
    RI_4c_right = RI_4c - RI_4a
    RI_4d = self_8 * D_12
    RI_4 = RI_4c + RI_4d
    RI_4_right = RI_4 - RI_4c
    RI_4c_lo = (product_rest(self_5, D_11, RI_4a, RI_4c - RI_4c_right)
        + product_rest(self_7, D_10, RI_4b, RI_4c_right))
    RI_4_lo = RI_4c - (RI_4 - RI_4_right) + product_rest(self_8, D_12, RI_4d, RI_4_right) + RI_4c_lo
    RI_5a = self_6 * D_12
    RI_5b = self_8 * D_11
    RI_5c = RI_5a + RI_5b
    RI_5c_right = RI_5c - RI_5a
    RI_5d = self_9 * D_10
    RI_5 = RI_5c + RI_5d
    RI_5_right = RI_5 - RI_5c
    RI_5c_lo = (product_rest(self_6, D_12, RI_5a, RI_5c - RI_5c_right)
        + product_rest(self_8, D_11, RI_5b, RI_5c_right))
    RI_5_lo = RI_5c - (RI_5 - RI_5_right) + product_rest(self_9, D_10, RI_5d, RI_5_right) + RI_5c_lo
    RI_6a = self_4 * D_20
    RI_6b = self_7 * D_21
    RI_6c = RI_6a + RI_6b
    RI_6c_right = RI_6c - RI_6a
    RI_6d = self_9 * D_22
    RI_6 = RI_6c + RI_6d
    RI_6_right = RI_6 - RI_6c
    RI_6c_lo = (product_rest(self_4, D_20, RI_6a, RI_6c - RI_6c_right)
        + product_rest(self_7, D_21, RI_6b, RI_6c_right))
    RI_7a = self_5 * D_21
    RI_7b = self_7 * D_20
    RI_7c = RI_7a + RI_7b
    RI_7c_right = RI_7c - RI_7a
    RI_7d = self_8 * D_22
    RI_7 = RI_7c + RI_7d
    RI_7_right = RI_7 - RI_7c
    RI_7c_lo = (product_rest(self_5, D_21, RI_7a, RI_7c - RI_7c_right)
        + product_rest(self_7, D_20, RI_7b, RI_7c_right))
    RI_8a = self_6 * D_22
    RI_8b = self_8 * D_21
    RI_8c = RI_8a + RI_8b
    RI_8c_right = RI_8c - RI_8a
    RI_8d = self_9 * D_20
    RI_8 = RI_8c + RI_8d
    RI_8_right = RI_8 - RI_8c
    RI_8c_lo = (product_rest(self_6, D_22, RI_8a, RI_8c - RI_8c_right)
        + product_rest(self_8, D_21, RI_8b, RI_8c_right))
    self_1_new_a = self_0 * D_03
    self_1_new_b = self_1 * D_00
    self_1_new_c = self_2 * D_01
    self_1_new_d = self_1_new_b + self_1_new_c
    self_1_new_d_right = self_1_new_d - self_1_new_b
    self_1_new_d_left_rest = product_rest(self_1, D_00, self_1_new_b,
        self_1_new_d - self_1_new_d_right)
    self_1_new_e = self_3 * D_02
    self_1_new_f = self_1_new_d + self_1_new_e
    self_1_new_f_right = self_1_new_f - self_1_new_d
    self_1_new_f_lo1 = (self_1_new_d - (self_1_new_f - self_1_new_f_right)
        + product_rest(self_3, D_02, self_1_new_e, self_1_new_f_right))
    self_1_new = self_1_new_a + self_1_new_f
    self_1_new_right = self_1_new - self_1_new_a
    self_1_new_lo1 = (product_rest(self_0, D_03, self_1_new_a, self_1_new - self_1_new_right)
        + (self_1_new_f - self_1_new_right))
    self_2_new_a = self_0 * D_13
    self_2_new_b = self_1 * D_10
    self_2_new_c = self_2 * D_11
    self_2_new_d = self_2_new_b + self_2_new_c
    self_2_new_d_right = self_2_new_d - self_2_new_b
    self_2_new_d_left_rest = product_rest(self_1, D_10, self_2_new_b,
        self_2_new_d - self_2_new_d_right)
    self_2_new_e = self_3 * D_12
    self_2_new_f = self_2_new_d + self_2_new_e
    self_2_new_f_right = self_2_new_f - self_2_new_d
    self_2_new_f_lo1 = (self_2_new_d - (self_2_new_f - self_2_new_f_right)
        + product_rest(self_3, D_12, self_2_new_e, self_2_new_f_right))
    self_2_new = self_2_new_a + self_2_new_f
    self_2_new_right = self_2_new - self_2_new_a
    self_2_new_lo1 = (product_rest(self_0, D_13, self_2_new_a, self_2_new - self_2_new_right)
        + (self_2_new_f - self_2_new_right))
    self_3_new_a = self_0 * D_23
    self_3_new_b = self_1 * D_20
    self_3_new_c = self_2 * D_21
    self_3_new_d = self_3_new_b + self_3_new_c
    self_3_new_d_right = self_3_new_d - self_3_new_b
    self_3_new_d_left_rest = product_rest(self_1, D_20, self_3_new_b,
        self_3_new_d - self_3_new_d_right)
    self_3_new_e = self_3 * D_22
    self_3_new_f = self_3_new_d + self_3_new_e
    self_3_new_f_right = self_3_new_f - self_3_new_d
    self_3_new_f_lo1 = (self_3_new_d - (self_3_new_f - self_3_new_f_right)
        + product_rest(self_3, D_22, self_3_new_e, self_3_new_f_right))
    self_3_new = self_3_new_a + self_3_new_f
    self_3_new_right = self_3_new - self_3_new_a
    self_3_new_lo1 = (product_rest(self_0, D_23, self_3_new_a, self_3_new - self_3_new_right)
        + (self_3_new_f - self_3_new_right))
    self_4_new_a = D_00 * RI_0
    self_4_new_b = D_01 * RI_1
    self_4_new_c = self_4_new_a + self_4_new_b
    self_4_new_c_right = self_4_new_c - self_4_new_a
    self_4_new_c_left_rest = product_rest(D_00, RI_0, self_4_new_a,
        self_4_new_c - self_4_new_c_right)
    self_4_new_d = D_02 * RI_2
    self_4_new = self_4_new_c + self_4_new_d
    self_4_new_right = self_4_new - self_4_new_c
    self_4_new_lo2 = (self_4_new_c - (self_4_new - self_4_new_right)
        + product_rest(D_02, RI_2, self_4_new_d, self_4_new_right) + D_02 * RI_2_lo)
    self_4_new_c_lo = (self_4_new_c_left_rest
        + product_rest(D_01, RI_1, self_4_new_b, self_4_new_c_right)
        + (D_00 * RI_0_lo + D_01 * RI_1_lo))
    self_5_new_a = D_10 * RI_3
    self_5_new_b = D_11 * RI_4
    self_5_new_c = self_5_new_a + self_5_new_b
    self_5_new_c_right = self_5_new_c - self_5_new_a
    self_5_new_c_left_rest = product_rest(D_10, RI_3, self_5_new_a,
        self_5_new_c - self_5_new_c_right)
    self_5_new_d = D_12 * RI_5
    self_5_new = self_5_new_c + self_5_new_d
    self_5_new_right = self_5_new - self_5_new_c
    self_5_new_lo2 = (self_5_new_c - (self_5_new - self_5_new_right)
        + product_rest(D_12, RI_5, self_5_new_d, self_5_new_right) + D_12 * RI_5_lo)
    self_5_new_c_lo = (self_5_new_c_left_rest
        + product_rest(D_11, RI_4, self_5_new_b, self_5_new_c_right)
        + (D_10 * RI_3_lo + D_11 * RI_4_lo))
    self_6_new_a = D_20 * RI_6
    self_6_new_b = D_21 * RI_7
    self_6_new_c = self_6_new_a + self_6_new_b
    self_6_new_c_right = self_6_new_c - self_6_new_a
    self_6_new_a_cross2 = (D_20
        * (RI_6c - (RI_6 - RI_6_right) + product_rest(self_9, D_22, RI_6d, RI_6_right) + RI_6c_lo))
    self_6_new_c_left_rest = product_rest(D_20, RI_6, self_6_new_a,
        self_6_new_c - self_6_new_c_right)
    self_6_new_c_cross = (self_6_new_a_cross2 + D_21
        * (RI_7c - (RI_7 - RI_7_right) + product_rest(self_8, D_22, RI_7d, RI_7_right) + RI_7c_lo))
    self_6_new_d = D_22 * RI_8
    self_6_new = self_6_new_c + self_6_new_d
    self_6_new_right = self_6_new - self_6_new_c
    self_6_new_lo1 = (self_6_new_c - (self_6_new - self_6_new_right)
        + product_rest(D_22, RI_8, self_6_new_d, self_6_new_right))
    self_6_new_lo2 = (self_6_new_lo1 + D_22
        * (RI_8c - (RI_8 - RI_8_right) + product_rest(self_9, D_20, RI_8d, RI_8_right) + RI_8c_lo))
    self_7_new_a = D_10 * RI_0
    self_7_new_b = D_11 * RI_1
    self_7_new_c = self_7_new_a + self_7_new_b
    self_7_new_c_right = self_7_new_c - self_7_new_a
    self_7_new_c_left_rest = product_rest(D_10, RI_0, self_7_new_a,
        self_7_new_c - self_7_new_c_right)
    self_7_new_d = D_12 * RI_2
    self_7_new = self_7_new_c + self_7_new_d
    self_7_new_right = self_7_new - self_7_new_c
    self_7_new_lo2 = (self_7_new_c - (self_7_new - self_7_new_right)
        + product_rest(D_12, RI_2, self_7_new_d, self_7_new_right) + D_12 * RI_2_lo)
    self_7_new_c_lo = (self_7_new_c_left_rest
        + product_rest(D_11, RI_1, self_7_new_b, self_7_new_c_right)
        + (D_10 * RI_0_lo + D_11 * RI_1_lo))
    self_8_new_a = D_20 * RI_3
    self_8_new_b = D_21 * RI_4
    self_8_new_c = self_8_new_a + self_8_new_b
    self_8_new_c_right = self_8_new_c - self_8_new_a
    self_8_new_c_left_rest = product_rest(D_20, RI_3, self_8_new_a,
        self_8_new_c - self_8_new_c_right)
    self_8_new_d = D_22 * RI_5
    self_8_new = self_8_new_c + self_8_new_d
    self_8_new_right = self_8_new - self_8_new_c
    self_8_new_lo2 = (self_8_new_c - (self_8_new - self_8_new_right)
        + product_rest(D_22, RI_5, self_8_new_d, self_8_new_right) + D_22 * RI_5_lo)
    self_8_new_c_lo = (self_8_new_c_left_rest
        + product_rest(D_21, RI_4, self_8_new_b, self_8_new_c_right)
        + (D_20 * RI_3_lo + D_21 * RI_4_lo))
    self_9_new_a = D_20 * RI_0
    self_9_new_b = D_21 * RI_1
    self_9_new_c = self_9_new_a + self_9_new_b
    self_9_new_c_right = self_9_new_c - self_9_new_a
    self_9_new_c_left_rest = product_rest(D_20, RI_0, self_9_new_a,
        self_9_new_c - self_9_new_c_right)
    self_9_new_d = D_22 * RI_2
    self_9_new = self_9_new_c + self_9_new_d
    self_9_new_right = self_9_new - self_9_new_c
    self_9_new_lo2 = (self_9_new_c - (self_9_new - self_9_new_right)
        + product_rest(D_22, RI_2, self_9_new_d, self_9_new_right) + D_22 * RI_2_lo)
    self_9_new_c_lo = (self_9_new_c_left_rest
        + product_rest(D_21, RI_1, self_9_new_b, self_9_new_c_right)
        + (D_20 * RI_0_lo + D_21 * RI_1_lo))
    self_1_new_lo = (self_1_new_lo1
        + (self_1_new_f_lo1
        + (self_1_new_d_left_rest + product_rest(self_2, D_01, self_1_new_c, self_1_new_d_right))))
    self_1_new_rounded = self_1_new + self_1_new_lo
    self_2_new_lo = (self_2_new_lo1
        + (self_2_new_f_lo1
        + (self_2_new_d_left_rest + product_rest(self_2, D_11, self_2_new_c, self_2_new_d_right))))
    self_2_new_rounded = self_2_new + self_2_new_lo
    self_3_new_lo = (self_3_new_lo1
        + (self_3_new_f_lo1
        + (self_3_new_d_left_rest + product_rest(self_2, D_21, self_3_new_c, self_3_new_d_right))))
    self_3_new_rounded = self_3_new + self_3_new_lo
    self_4_new_rounded = self_4_new + (self_4_new_lo2 + self_4_new_c_lo)
    self_5_new_rounded = self_5_new + (self_5_new_lo2 + self_5_new_c_lo)
    self_6_new_lo = (self_6_new_lo2
        + (self_6_new_c_left_rest + product_rest(D_21, RI_7, self_6_new_b, self_6_new_c_right)
        + self_6_new_c_cross))
    self_6_new_rounded = self_6_new + self_6_new_lo
    self_7_new_rounded = self_7_new + (self_7_new_lo2 + self_7_new_c_lo)
    self_8_new_rounded = self_8_new + (self_8_new_lo2 + self_8_new_c_lo)
    self_9_new_rounded = self_9_new + (self_9_new_lo2 + self_9_new_c_lo)
    return (self_0, self_1_new_rounded, self_2_new_rounded, self_3_new_rounded, self_4_new_rounded,
        self_5_new_rounded, self_6_new_rounded, self_7_new_rounded, self_8_new_rounded,
        self_9_new_rounded)


@kernel("(10),(3),(10),(3),(3,4)->(10)")
def inertia_merge(Ji, t_ic, Jj, t_jc, D_ij):
    """Ji = the inertia of two joined bodies: Ji, and Jj displaced by D_ij = [R | t]: m_i + m_j,
    mt_i + m_j c, I_i + R I_j R^T + m_i m_j/(m_i + m_j) (d·d 1 - d d^T) with c = R t_jc + t, d =
    c - t_ic; t_ic = mt_i / m_i and t_jc = mt_j / m_j are the centres of mass, each in its own
    frame; NaN where m_i + m_j = 0.

    (10),(3),(10),(3),(3,4)->(10).  Ji, Jj: inertia (m in kg; mt = m c in kg m; I about the
    centre of mass c, xx, yy, zz, xy, yz, zx in kg m^2); t_ic, t_jc: vector; D_ij: displacement
    [R | t], R rotation, t in m.
    109 mul, 401 add, 5 product error, 66 product rest, 2 div, 10 equal, 10 select.  Error <= 18
    u times the sum of the absolute values of all terms, for masses that are not negative,
    barring over- and underflow.
    """
    Ji_0, Ji_1, Ji_2, Ji_3, Ji_4, Ji_5, Ji_6, Ji_7, Ji_8, Ji_9 = Ji
    t_ic_0, t_ic_1, t_ic_2 = t_ic
    Jj_0, Jj_1, Jj_2, Jj_3, Jj_4, Jj_5, Jj_6, Jj_7, Jj_8, Jj_9 = Jj
    t_jc_0, t_jc_1, t_jc_2 = t_jc
    (D_ij_00, D_ij_01, D_ij_02, D_ij_03, D_ij_10, D_ij_11, D_ij_12, D_ij_13, D_ij_20, D_ij_21,
        D_ij_22, D_ij_23) = D_ij
    m = Ji_0 + Jj_0
    m_right = m - Ji_0
    m_lo = Ji_0 - (m - m_right) + (Jj_0 - m_right)
    c_0a = t_jc_0 * D_ij_00
    c_0b = t_jc_1 * D_ij_01
    c_0c = c_0a + c_0b
    c_0c_right = c_0c - c_0a
    c_0d = t_jc_2 * D_ij_02
    c_0e = c_0c + c_0d
    c_0e_right = c_0e - c_0c
    c_0c_lo = (product_rest(t_jc_0, D_ij_00, c_0a, c_0c - c_0c_right)
        + product_rest(t_jc_1, D_ij_01, c_0b, c_0c_right))
    c_0 = c_0e + D_ij_03
    c_0_right = c_0 - c_0e
    c_0_lo = (c_0e - (c_0 - c_0_right) + (D_ij_03 - c_0_right)
        + (c_0c - (c_0e - c_0e_right) + product_rest(t_jc_2, D_ij_02, c_0d, c_0e_right) + c_0c_lo))
    c_1a = t_jc_0 * D_ij_10
    c_1b = t_jc_1 * D_ij_11
    c_1c = c_1a + c_1b
    c_1c_right = c_1c - c_1a
    c_1d = t_jc_2 * D_ij_12
    c_1e = c_1c + c_1d
    c_1e_right = c_1e - c_1c
    c_1c_lo = (product_rest(t_jc_0, D_ij_10, c_1a, c_1c - c_1c_right)
        + product_rest(t_jc_1, D_ij_11, c_1b, c_1c_right))
    c_1 = c_1e + D_ij_13
    c_1_right = c_1 - c_1e
    c_1_lo = (c_1e - (c_1 - c_1_right) + (D_ij_13 - c_1_right)
        + (c_1c - (c_1e - c_1e_right) + product_rest(t_jc_2, D_ij_12, c_1d, c_1e_right) + c_1c_lo))
    c_2a = t_jc_0 * D_ij_20
    c_2b = t_jc_1 * D_ij_21
    c_2c = c_2a + c_2b
    c_2c_right = c_2c - c_2a
    c_2d = t_jc_2 * D_ij_22
    c_2e = c_2c + c_2d
    c_2e_right = c_2e - c_2c
    c_2c_lo = (product_rest(t_jc_0, D_ij_20, c_2a, c_2c - c_2c_right)
        + product_rest(t_jc_1, D_ij_21, c_2b, c_2c_right))
    c_2 = c_2e + D_ij_23
    c_2_right = c_2 - c_2e
    c_2_lo = (c_2e - (c_2 - c_2_right) + (D_ij_23 - c_2_right)
        + (c_2c - (c_2e - c_2e_right) + product_rest(t_jc_2, D_ij_22, c_2d, c_2e_right) + c_2c_lo))
    d_0 = c_0 - t_ic_0
    d_0_right = c_0 - d_0
    d_0_lo = c_0 - (d_0 + d_0_right) - (t_ic_0 - d_0_right) + c_0_lo
    d_1 = c_1 - t_ic_1
    d_1_right = c_1 - d_1
    d_1_lo = c_1 - (d_1 + d_1_right) - (t_ic_1 - d_1_right) + c_1_lo
    d_2 = c_2 - t_ic_2
    d_2_right = c_2 - d_2
    d_2_lo = c_2 - (d_2 + d_2_right) - (t_ic_2 - d_2_right) + c_2_lo
    m_sum = m + m_lo
    m_sum_right = m_sum - m
    part = Jj_0 / m_sum
    part_product = part * m_sum
    reduced = Ji_0 * part
    part_lo = ((Jj_0 - part_product - product_error(part, m_sum, part_product) - part
        * (m - (m_sum - m_sum_right) + (m_lo - m_sum_right))) / m_sum)
    reduced_lo = product_error(Ji_0, part, reduced) + Ji_0 * part_lo
    p_0 = d_0 * reduced
    p_1 = d_1 * reduced
    p_2 = d_2 * reduced
    p_0_lo = product_error(d_0, reduced, p_0) + (d_0_lo * reduced + d_0 * reduced_lo)
    squares_0 = d_0 * p_0
    squares_0_cross = d_0_lo * p_0 + d_0 * p_0_lo
    p_1_lo = product_error(d_1, reduced, p_1) + (d_1_lo * reduced + d_1 * reduced_lo)
    squares_1 = d_1 * p_1
    squares_1_cross = d_1_lo * p_1 + d_1 * p_1_lo
    squares_2 = d_2 * p_2
    squares_2_cross = (d_2_lo * p_2 + d_2
        * (product_error(d_2, reduced, p_2) + (d_2_lo * reduced + d_2 * reduced_lo)))
    RI_0a = Jj_4 * D_ij_00
    RI_0b = Jj_7 * D_ij_01
    RI_0c = RI_0a + RI_0b
    RI_0c_right = RI_0c - RI_0a
    RI_0d = Jj_9 * D_ij_02
    RI_0 = RI_0c + RI_0d
    RI_0_right = RI_0 - RI_0c
    RI_0c_lo = (product_rest(Jj_4, D_ij_00, RI_0a, RI_0c - RI_0c_right)
        + product_rest(Jj_7, D_ij_01, RI_0b, RI_0c_right))
    RI_0_lo = (RI_0c - (RI_0 - RI_0_right) + product_rest(Jj_9, D_ij_02, RI_0d, RI_0_right)
        + RI_0c_lo)
    RI_1a = Jj_5 * D_ij_01
    RI_1b = Jj_7 * D_ij_00
    RI_1c = RI_1a + RI_1b
    RI_1c_right = RI_1c - RI_1a
    RI_1d = Jj_8 * D_ij_02
    RI_1 = RI_1c + RI_1d
    RI_1_right = RI_1 - RI_1c
    RI_1c_lo = (product_rest(Jj_5, D_ij_01, RI_1a, RI_1c - RI_1c_right)
        + product_rest(Jj_7, D_ij_00, RI_1b, RI_1c_right))
    RI_1_lo = (RI_1c - (RI_1 - RI_1_right) + product_rest(Jj_8, D_ij_02, RI_1d, RI_1_right)
        + RI_1c_lo)
    RI_2a = Jj_6 * D_ij_02
    RI_2b = Jj_8 * D_ij_01
    RI_2c = RI_2a + RI_2b
    RI_2c_right = RI_2c - RI_2a
    RI_2d = Jj_9 * D_ij_00
    RI_2 = RI_2c + RI_2d
    RI_2_right = RI_2 - RI_2c
    RI_2c_lo = (product_rest(Jj_6, D_ij_02, RI_2a, RI_2c - RI_2c_right)
        + product_rest(Jj_8, D_ij_01, RI_2b, RI_2c_right))
    RI_2_lo = (RI_2c - (RI_2 - RI_2_right) + product_rest(Jj_9, D_ij_00, RI_2d, RI_2_right)
        + RI_2c_lo)
    RI_3a = Jj_4 * D_ij_10
    RI_3b = Jj_7 * D_ij_11
    RI_3c = RI_3a + RI_3b
    RI_3c_right = RI_3c - RI_3a
    RI_3d = Jj_9 * D_ij_12
    RI_3 = RI_3c + RI_3d
    RI_3_right = RI_3 - RI_3c
    RI_3c_lo = (product_rest(Jj_4, D_ij_10, RI_3a, RI_3c - RI_3c_right)
        + product_rest(Jj_7, D_ij_11, RI_3b, RI_3c_right))
    RI_3_lo = (RI_3c - (RI_3 - RI_3_right) + product_rest(Jj_9, D_ij_12, RI_3d, RI_3_right)
        + RI_3c_lo)
    RI_4a = Jj_5 * D_ij_11
    RI_4b = Jj_7 * D_ij_10
    RI_4c = RI_4a + RI_4b
    RI_4c_right = RI_4c - RI_4a
    RI_4d = Jj_8 * D_ij_12
    RI_4 = RI_4c + RI_4d
    RI_4_right = RI_4 - RI_4c
    RI_4c_lo = (product_rest(Jj_5, D_ij_11, RI_4a, RI_4c - RI_4c_right)
        + product_rest(Jj_7, D_ij_10, RI_4b, RI_4c_right))
    RI_4_lo = (RI_4c - (RI_4 - RI_4_right) + product_rest(Jj_8, D_ij_12, RI_4d, RI_4_right)
        + RI_4c_lo)
    RI_5a = Jj_6 * D_ij_12
    RI_5b = Jj_8 * D_ij_11
    RI_5c = RI_5a + RI_5b
    RI_5c_right = RI_5c - RI_5a
    RI_5d = Jj_9 * D_ij_10
    RI_5 = RI_5c + RI_5d
    RI_5_right = RI_5 - RI_5c
    RI_5c_lo = (product_rest(Jj_6, D_ij_12, RI_5a, RI_5c - RI_5c_right)
        + product_rest(Jj_8, D_ij_11, RI_5b, RI_5c_right))
    RI_5_lo = (RI_5c - (RI_5 - RI_5_right) + product_rest(Jj_9, D_ij_10, RI_5d, RI_5_right)
        + RI_5c_lo)
    RI_6a = Jj_4 * D_ij_20
    RI_6b = Jj_7 * D_ij_21
    RI_6c = RI_6a + RI_6b
    RI_6c_right = RI_6c - RI_6a
    RI_6d = Jj_9 * D_ij_22
    RI_6 = RI_6c + RI_6d
    RI_6_right = RI_6 - RI_6c
    RI_6c_lo = (product_rest(Jj_4, D_ij_20, RI_6a, RI_6c - RI_6c_right)
        + product_rest(Jj_7, D_ij_21, RI_6b, RI_6c_right))
    RI_7a = Jj_5 * D_ij_21
    RI_7b = Jj_7 * D_ij_20
    RI_7c = RI_7a + RI_7b
    RI_7c_right = RI_7c - RI_7a
    RI_7d = Jj_8 * D_ij_22
    RI_7 = RI_7c + RI_7d
    RI_7_right = RI_7 - RI_7c
    RI_7c_lo = (product_rest(Jj_5, D_ij_21, RI_7a, RI_7c - RI_7c_right)
        + product_rest(Jj_7, D_ij_20, RI_7b, RI_7c_right))
    RI_8a = Jj_6 * D_ij_22
    RI_8b = Jj_8 * D_ij_21
    RI_8c = RI_8a + RI_8b
    RI_8c_right = RI_8c - RI_8a
    RI_8d = Jj_9 * D_ij_20
    RI_8 = RI_8c + RI_8d
    RI_8_right = RI_8 - RI_8c
    RI_8c_lo = (product_rest(Jj_6, D_ij_22, RI_8a, RI_8c - RI_8c_right)
        + product_rest(Jj_8, D_ij_21, RI_8b, RI_8c_right))
    Ji_1_new_a = Jj_0 * c_0
    Ji_1_new = Ji_1 + Ji_1_new_a
    Ji_1_new_right = Ji_1_new - Ji_1
    Ji_2_new_a = Jj_0 * c_1
    Ji_2_new = Ji_2 + Ji_2_new_a
    Ji_2_new_right = Ji_2_new - Ji_2
    Ji_3_new_a = Jj_0 * c_2
    Ji_3_new = Ji_3 + Ji_3_new_a
    Ji_3_new_right = Ji_3_new - Ji_3
    Ji_4_new_a = D_ij_00 * RI_0
    Ji_4_new_b = D_ij_01 * RI_1
    Ji_4_new_c = Ji_4_new_a + Ji_4_new_b
    Ji_4_new_c_right = Ji_4_new_c - Ji_4_new_a
    Ji_4_new_c_lo1 = (product_rest(D_ij_00, RI_0, Ji_4_new_a, Ji_4_new_c - Ji_4_new_c_right)
        + product_rest(D_ij_01, RI_1, Ji_4_new_b, Ji_4_new_c_right))
    Ji_4_new_d = D_ij_02 * RI_2
    Ji_4_new_e = Ji_4_new_c + Ji_4_new_d
    Ji_4_new_e_right = Ji_4_new_e - Ji_4_new_c
    Ji_4_new_e_lo2 = (Ji_4_new_c - (Ji_4_new_e - Ji_4_new_e_right)
        + product_rest(D_ij_02, RI_2, Ji_4_new_d, Ji_4_new_e_right) + D_ij_02 * RI_2_lo)
    Ji_4_new_f = Ji_4 + Ji_4_new_e
    Ji_4_new_f_right = Ji_4_new_f - Ji_4
    Ji_4_new_e_lo = Ji_4_new_e_lo2 + (Ji_4_new_c_lo1 + (D_ij_00 * RI_0_lo + D_ij_01 * RI_1_lo))
    Ji_4_new_g = squares_1 + squares_2
    Ji_4_new_g_right = Ji_4_new_g - squares_1
    Ji_4_new_g_lo1 = (product_rest(d_1, p_1, squares_1, Ji_4_new_g - Ji_4_new_g_right)
        + product_rest(d_2, p_2, squares_2, Ji_4_new_g_right))
    Ji_4_new = Ji_4_new_f + Ji_4_new_g
    Ji_4_new_right = Ji_4_new - Ji_4_new_f
    Ji_4_new_lo2 = (Ji_4_new_f - (Ji_4_new - Ji_4_new_right) + (Ji_4_new_g - Ji_4_new_right)
        + (Ji_4_new_g_lo1 + (squares_1_cross + squares_2_cross)))
    Ji_5_new_a = D_ij_10 * RI_3
    Ji_5_new_b = D_ij_11 * RI_4
    Ji_5_new_c = Ji_5_new_a + Ji_5_new_b
    Ji_5_new_c_right = Ji_5_new_c - Ji_5_new_a
    Ji_5_new_c_lo1 = (product_rest(D_ij_10, RI_3, Ji_5_new_a, Ji_5_new_c - Ji_5_new_c_right)
        + product_rest(D_ij_11, RI_4, Ji_5_new_b, Ji_5_new_c_right))
    Ji_5_new_d = D_ij_12 * RI_5
    Ji_5_new_e = Ji_5_new_c + Ji_5_new_d
    Ji_5_new_e_right = Ji_5_new_e - Ji_5_new_c
    Ji_5_new_e_lo2 = (Ji_5_new_c - (Ji_5_new_e - Ji_5_new_e_right)
        + product_rest(D_ij_12, RI_5, Ji_5_new_d, Ji_5_new_e_right) + D_ij_12 * RI_5_lo)
    Ji_5_new_f = Ji_5 + Ji_5_new_e
    Ji_5_new_f_right = Ji_5_new_f - Ji_5
    Ji_5_new_e_lo = Ji_5_new_e_lo2 + (Ji_5_new_c_lo1 + (D_ij_10 * RI_3_lo + D_ij_11 * RI_4_lo))
    Ji_5_new_g = squares_0 + squares_2
    Ji_5_new_g_right = Ji_5_new_g - squares_0
    Ji_5_new_g_lo1 = (product_rest(d_0, p_0, squares_0, Ji_5_new_g - Ji_5_new_g_right)
        + product_rest(d_2, p_2, squares_2, Ji_5_new_g_right))
    Ji_5_new = Ji_5_new_f + Ji_5_new_g
    Ji_5_new_right = Ji_5_new - Ji_5_new_f
    Ji_5_new_lo2 = (Ji_5_new_f - (Ji_5_new - Ji_5_new_right) + (Ji_5_new_g - Ji_5_new_right)
        + (Ji_5_new_g_lo1 + (squares_0_cross + squares_2_cross)))
    Ji_6_new_a = D_ij_20 * RI_6
    Ji_6_new_b = D_ij_21 * RI_7
    Ji_6_new_c = Ji_6_new_a + Ji_6_new_b
    Ji_6_new_c_right = Ji_6_new_c - Ji_6_new_a
    Ji_6_new_a_cross2 = (D_ij_20
        * (RI_6c - (RI_6 - RI_6_right) + product_rest(Jj_9, D_ij_22, RI_6d, RI_6_right) + RI_6c_lo))
    Ji_6_new_c_lo1 = (product_rest(D_ij_20, RI_6, Ji_6_new_a, Ji_6_new_c - Ji_6_new_c_right)
        + product_rest(D_ij_21, RI_7, Ji_6_new_b, Ji_6_new_c_right))
    Ji_6_new_c_cross = (Ji_6_new_a_cross2 + D_ij_21
        * (RI_7c - (RI_7 - RI_7_right) + product_rest(Jj_8, D_ij_22, RI_7d, RI_7_right) + RI_7c_lo))
    Ji_6_new_d = D_ij_22 * RI_8
    Ji_6_new_e = Ji_6_new_c + Ji_6_new_d
    Ji_6_new_e_right = Ji_6_new_e - Ji_6_new_c
    Ji_6_new_e_lo1 = (Ji_6_new_c - (Ji_6_new_e - Ji_6_new_e_right)
        + product_rest(D_ij_22, RI_8, Ji_6_new_d, Ji_6_new_e_right))
    Ji_6_new_e_lo2 = (Ji_6_new_e_lo1 + D_ij_22
        * (RI_8c - (RI_8 - RI_8_right) + product_rest(Jj_9, D_ij_20, RI_8d, RI_8_right) + RI_8c_lo))
    Ji_6_new_f = Ji_6 + Ji_6_new_e
    Ji_6_new_f_right = Ji_6_new_f - Ji_6
    Ji_6_new_g = squares_0 + squares_1
    Ji_6_new_g_right = Ji_6_new_g - squares_0
    Ji_6_new_g_lo1 = (product_rest(d_0, p_0, squares_0, Ji_6_new_g - Ji_6_new_g_right)
        + product_rest(d_1, p_1, squares_1, Ji_6_new_g_right))
    Ji_6_new = Ji_6_new_f + Ji_6_new_g
    Ji_6_new_right = Ji_6_new - Ji_6_new_f
    Ji_6_new_lo2 = (Ji_6_new_f - (Ji_6_new - Ji_6_new_right) + (Ji_6_new_g - Ji_6_new_right)
        + (Ji_6_new_g_lo1 + (squares_0_cross + squares_1_cross)))
    Ji_6_new_f_lo = (Ji_6 - (Ji_6_new_f - Ji_6_new_f_right) + (Ji_6_new_e - Ji_6_new_f_right)
        + (Ji_6_new_e_lo2 + (Ji_6_new_c_lo1 + Ji_6_new_c_cross)))
    Ji_7_new_a = D_ij_10 * RI_0
    Ji_7_new_b = D_ij_11 * RI_1
    Ji_7_new_c = Ji_7_new_a + Ji_7_new_b
    Ji_7_new_c_right = Ji_7_new_c - Ji_7_new_a
    Ji_7_new_c_lo1 = (product_rest(D_ij_10, RI_0, Ji_7_new_a, Ji_7_new_c - Ji_7_new_c_right)
        + product_rest(D_ij_11, RI_1, Ji_7_new_b, Ji_7_new_c_right))
    Ji_7_new_d = D_ij_12 * RI_2
    Ji_7_new_e = Ji_7_new_c + Ji_7_new_d
    Ji_7_new_e_right = Ji_7_new_e - Ji_7_new_c
    Ji_7_new_e_lo2 = (Ji_7_new_c - (Ji_7_new_e - Ji_7_new_e_right)
        + product_rest(D_ij_12, RI_2, Ji_7_new_d, Ji_7_new_e_right) + D_ij_12 * RI_2_lo)
    Ji_7_new_f = Ji_7 + Ji_7_new_e
    Ji_7_new_f_right = Ji_7_new_f - Ji_7
    Ji_7_new_e_lo = Ji_7_new_e_lo2 + (Ji_7_new_c_lo1 + (D_ij_10 * RI_0_lo + D_ij_11 * RI_1_lo))
    Ji_7_new_g = d_1 * p_0
    Ji_7_new = Ji_7_new_f - Ji_7_new_g
    Ji_7_new_right = Ji_7_new_f - Ji_7_new
    Ji_7_new_lo2 = (Ji_7_new_f - (Ji_7_new + Ji_7_new_right)
        - product_rest(d_1, p_0, Ji_7_new_g, Ji_7_new_right) - (d_1_lo * p_0 + d_1 * p_0_lo))
    Ji_8_new_a = D_ij_20 * RI_3
    Ji_8_new_b = D_ij_21 * RI_4
    Ji_8_new_c = Ji_8_new_a + Ji_8_new_b
    Ji_8_new_c_right = Ji_8_new_c - Ji_8_new_a
    Ji_8_new_c_lo1 = (product_rest(D_ij_20, RI_3, Ji_8_new_a, Ji_8_new_c - Ji_8_new_c_right)
        + product_rest(D_ij_21, RI_4, Ji_8_new_b, Ji_8_new_c_right))
    Ji_8_new_d = D_ij_22 * RI_5
    Ji_8_new_e = Ji_8_new_c + Ji_8_new_d
    Ji_8_new_e_right = Ji_8_new_e - Ji_8_new_c
    Ji_8_new_e_lo2 = (Ji_8_new_c - (Ji_8_new_e - Ji_8_new_e_right)
        + product_rest(D_ij_22, RI_5, Ji_8_new_d, Ji_8_new_e_right) + D_ij_22 * RI_5_lo)
    Ji_8_new_f = Ji_8 + Ji_8_new_e
    Ji_8_new_f_right = Ji_8_new_f - Ji_8
    Ji_8_new_e_lo = Ji_8_new_e_lo2 + (Ji_8_new_c_lo1 + (D_ij_20 * RI_3_lo + D_ij_21 * RI_4_lo))
    Ji_8_new_g = d_2 * p_1
    Ji_8_new = Ji_8_new_f - Ji_8_new_g
    Ji_8_new_right = Ji_8_new_f - Ji_8_new
    Ji_8_new_lo2 = (Ji_8_new_f - (Ji_8_new + Ji_8_new_right)
        - product_rest(d_2, p_1, Ji_8_new_g, Ji_8_new_right) - (d_2_lo * p_1 + d_2 * p_1_lo))
    Ji_9_new_a = D_ij_20 * RI_0
    Ji_9_new_b = D_ij_21 * RI_1
    Ji_9_new_c = Ji_9_new_a + Ji_9_new_b
    Ji_9_new_c_right = Ji_9_new_c - Ji_9_new_a
    Ji_9_new_c_lo1 = (product_rest(D_ij_20, RI_0, Ji_9_new_a, Ji_9_new_c - Ji_9_new_c_right)
        + product_rest(D_ij_21, RI_1, Ji_9_new_b, Ji_9_new_c_right))
    Ji_9_new_d = D_ij_22 * RI_2
    Ji_9_new_e = Ji_9_new_c + Ji_9_new_d
    Ji_9_new_e_right = Ji_9_new_e - Ji_9_new_c
    Ji_9_new_e_lo2 = (Ji_9_new_c - (Ji_9_new_e - Ji_9_new_e_right)
        + product_rest(D_ij_22, RI_2, Ji_9_new_d, Ji_9_new_e_right) + D_ij_22 * RI_2_lo)
    Ji_9_new_f = Ji_9 + Ji_9_new_e
    Ji_9_new_f_right = Ji_9_new_f - Ji_9
    Ji_9_new_e_lo = Ji_9_new_e_lo2 + (Ji_9_new_c_lo1 + (D_ij_20 * RI_0_lo + D_ij_21 * RI_1_lo))
    Ji_9_new_g = d_2 * p_0
    Ji_9_new = Ji_9_new_f - Ji_9_new_g
    Ji_9_new_right = Ji_9_new_f - Ji_9_new
    Ji_9_new_lo2 = (Ji_9_new_f - (Ji_9_new + Ji_9_new_right)
        - product_rest(d_2, p_0, Ji_9_new_g, Ji_9_new_right) - (d_2_lo * p_0 + d_2 * p_0_lo))
    m_rounded = m + m_lo
    Ji_1_new_rounded = (Ji_1_new
        + (Ji_1 - (Ji_1_new - Ji_1_new_right) + product_rest(Jj_0, c_0, Ji_1_new_a, Ji_1_new_right)
        + Jj_0 * c_0_lo))
    Ji_2_new_rounded = (Ji_2_new
        + (Ji_2 - (Ji_2_new - Ji_2_new_right) + product_rest(Jj_0, c_1, Ji_2_new_a, Ji_2_new_right)
        + Jj_0 * c_1_lo))
    Ji_3_new_rounded = (Ji_3_new
        + (Ji_3 - (Ji_3_new - Ji_3_new_right) + product_rest(Jj_0, c_2, Ji_3_new_a, Ji_3_new_right)
        + Jj_0 * c_2_lo))
    Ji_4_new_rounded = (Ji_4_new
        + (Ji_4_new_lo2
        + (Ji_4 - (Ji_4_new_f - Ji_4_new_f_right) + (Ji_4_new_e - Ji_4_new_f_right)
        + Ji_4_new_e_lo)))
    Ji_5_new_rounded = (Ji_5_new
        + (Ji_5_new_lo2
        + (Ji_5 - (Ji_5_new_f - Ji_5_new_f_right) + (Ji_5_new_e - Ji_5_new_f_right)
        + Ji_5_new_e_lo)))
    Ji_6_new_rounded = Ji_6_new + (Ji_6_new_lo2 + Ji_6_new_f_lo)
    Ji_7_new_rounded = (Ji_7_new
        + (Ji_7_new_lo2
        + (Ji_7 - (Ji_7_new_f - Ji_7_new_f_right) + (Ji_7_new_e - Ji_7_new_f_right)
        + Ji_7_new_e_lo)))
    Ji_8_new_rounded = (Ji_8_new
        + (Ji_8_new_lo2
        + (Ji_8 - (Ji_8_new_f - Ji_8_new_f_right) + (Ji_8_new_e - Ji_8_new_f_right)
        + Ji_8_new_e_lo)))
    Ji_9_new_rounded = (Ji_9_new
        + (Ji_9_new_lo2
        + (Ji_9 - (Ji_9_new_f - Ji_9_new_f_right) + (Ji_9_new_e - Ji_9_new_f_right)
        + Ji_9_new_e_lo)))
    m_final = where(m_rounded == m_rounded, m_rounded, m)
    Ji_1_new_final = where(Ji_1_new_rounded == Ji_1_new_rounded, Ji_1_new_rounded, Ji_1_new)
    Ji_2_new_final = where(Ji_2_new_rounded == Ji_2_new_rounded, Ji_2_new_rounded, Ji_2_new)
    Ji_3_new_final = where(Ji_3_new_rounded == Ji_3_new_rounded, Ji_3_new_rounded, Ji_3_new)
    Ji_4_new_final = where(Ji_4_new_rounded == Ji_4_new_rounded, Ji_4_new_rounded, Ji_4_new)
    Ji_5_new_final = where(Ji_5_new_rounded == Ji_5_new_rounded, Ji_5_new_rounded, Ji_5_new)
    Ji_6_new_final = where(Ji_6_new_rounded == Ji_6_new_rounded, Ji_6_new_rounded, Ji_6_new)
    Ji_7_new_final = where(Ji_7_new_rounded == Ji_7_new_rounded, Ji_7_new_rounded, Ji_7_new)
    Ji_8_new_final = where(Ji_8_new_rounded == Ji_8_new_rounded, Ji_8_new_rounded, Ji_8_new)
    Ji_9_new_final = where(Ji_9_new_rounded == Ji_9_new_rounded, Ji_9_new_rounded, Ji_9_new)
    return (m_final, Ji_1_new_final, Ji_2_new_final, Ji_3_new_final, Ji_4_new_final, Ji_5_new_final,
        Ji_6_new_final, Ji_7_new_final, Ji_8_new_final, Ji_9_new_final)
