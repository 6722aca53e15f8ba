# Made by `coscrew generate`; changes are overwritten.
# SPDX-License-Identifier: MIT
# coscrew 0.2.0.  Copyright (c) 2026 The coscrew authors.
"""Inertias of rigid bodies: mass, mass times centre of mass, moments about the centre of mass.

In single precision, accurate tier.
"""

from coscrew._kernel import wide_kernel as kernel


@kernel("(),(3),(),(),(),(),(),()->(10)")
def inertia(m, t, Ixx, Iyy, Izz, Ixy, Iyz, Izx):
    """J = (m; m t; Ixx, Iyy, Izz, Ixy, Iyz, Izx): mass, centre of mass t in m, entries of the
    moments' matrix about it in kg m^2, Ixy = -∫ x y dm.

    (),(3),(),(),(),(),(),()->(10).  m, Ixx, Iyy, Izz, Ixy, Iyz, Izx: number; t: vector; J:
    inertia (m in kg; mt = m c in kg m; I about the centre of mass c, xx, yy, zz, xy, yz, zx in
    kg m^2).
    3 mul.  Error <= u |result| + (m: 0, mt: 1/32, I: 0) u^2 S, S the sum of the |terms| of the
    expanded formula; barring over- and underflow.
    """
    t_0, t_1, t_2 = t
    J_1 = m * t_0
    J_2 = m * t_1
    J_3 = m * t_2
    return (m, J_1, J_2, J_3, Ixx, Iyy, Izz, Ixy, Iyz, Izx)


@kernel("(10),(3,3)->(10)")
def inertia_rotated(Ji, R):
    """Jo = Ji rotated by R: m, R mt, R I R^T.

    (10),(3,3)->(10).  Ji, Jo: inertia (m in kg; mt = m c in kg m; I about the centre of mass c,
    xx, yy, zz, xy, yz, zx in kg m^2); R: rotation or other 3×3 matrix.
    54 mul, 36 add.  Error <= u |result| + (m: 0, mt: 3/32, I: 3/16) u^2 S, S the sum of the
    |terms| of the expanded formula; barring over- and underflow.
    """
    Ji_0, Ji_1, Ji_2, Ji_3, Ji_4, Ji_5, Ji_6, Ji_7, Ji_8, Ji_9 = Ji
    R_00, R_01, R_02, R_10, R_11, R_12, R_20, R_21, R_22 = R
    RI_0 = Ji_4 * R_00 + Ji_7 * R_01 + Ji_9 * R_02
    RI_1 = Ji_5 * R_01 + Ji_7 * R_00 + Ji_8 * R_02
    RI_2 = Ji_6 * R_02 + Ji_8 * R_01 + Ji_9 * R_00
    RI_3 = Ji_4 * R_10 + Ji_7 * R_11 + Ji_9 * R_12
    RI_4 = Ji_5 * R_11 + Ji_7 * R_10 + Ji_8 * R_12
    RI_5 = Ji_6 * R_12 + Ji_8 * R_11 + Ji_9 * R_10
    RI_6 = Ji_4 * R_20 + Ji_7 * R_21 + Ji_9 * R_22
    RI_7 = Ji_5 * R_21 + Ji_7 * R_20 + Ji_8 * R_22
    RI_8 = Ji_6 * R_22 + Ji_8 * R_21 + Ji_9 * R_20
    Jo_1 = Ji_1 * R_00 + Ji_2 * R_01 + Ji_3 * R_02
    Jo_2 = Ji_1 * R_10 + Ji_2 * R_11 + Ji_3 * R_12
    Jo_3 = Ji_1 * R_20 + Ji_2 * R_21 + Ji_3 * R_22
    Jo_4 = R_00 * RI_0 + R_01 * RI_1 + R_02 * RI_2
    Jo_5 = R_10 * RI_3 + R_11 * RI_4 + R_12 * RI_5
    Jo_6 = R_20 * RI_6 + R_21 * RI_7 + R_22 * RI_8
    Jo_7 = R_10 * RI_0 + R_11 * RI_1 + R_12 * RI_2
    Jo_8 = R_20 * RI_3 + R_21 * RI_4 + R_22 * RI_5
    Jo_9 = R_20 * RI_0 + R_21 * RI_1 + R_22 * RI_2
    return (Ji_0, Jo_1, Jo_2, Jo_3, Jo_4, Jo_5, Jo_6, Jo_7, Jo_8, Jo_9)


@kernel("(10),(3,3)->(10)")
def inertia_rotate(self, R):
    """self = self rotated by R: m, R mt, R I R^T.

    (10),(3,3)->(10).  self: inertia (m in kg; mt = m c in kg m; I about the centre of mass c,
    xx, yy, zz, xy, yz, zx in kg m^2); R: rotation or other 3×3 matrix.
    54 mul, 36 add.  Error <= u |result| + (m: 0, mt: 3/32, I: 3/16) u^2 S, S the sum of the
    |terms| of the expanded formula; barring over- and underflow.
    """
    self_0, self_1, self_2, self_3, self_4, self_5, self_6, self_7, self_8, self_9 = self
    R_00, R_01, R_02, R_10, R_11, R_12, R_20, R_21, R_22 = R
    RI_0 = self_4 * R_00 + self_7 * R_01 + self_9 * R_02
    RI_1 = self_5 * R_01 + self_7 * R_00 + self_8 * R_02
    RI_2 = self_6 * R_02 + self_8 * R_01 + self_9 * R_00
    RI_3 = self_4 * R_10 + self_7 * R_11 + self_9 * R_12
    RI_4 = self_5 * R_11 + self_7 * R_10 + self_8 * R_12
    RI_5 = self_6 * R_12 + self_8 * R_11 + self_9 * R_10
    RI_6 = self_4 * R_20 + self_7 * R_21 + self_9 * R_22
    RI_7 = self_5 * R_21 + self_7 * R_20 + self_8 * R_22
    RI_8 = self_6 * R_22 + self_8 * R_21 + self_9 * R_20
    self_1_new = self_1 * R_00 + self_2 * R_01 + self_3 * R_02
    self_2_new = self_1 * R_10 + self_2 * R_11 + self_3 * R_12
    self_3_new = self_1 * R_20 + self_2 * R_21 + self_3 * R_22
    self_4_new = R_00 * RI_0 + R_01 * RI_1 + R_02 * RI_2
    self_5_new = R_10 * RI_3 + R_11 * RI_4 + R_12 * RI_5
    self_6_new = R_20 * RI_6 + R_21 * RI_7 + R_22 * RI_8
    self_7_new = R_10 * RI_0 + R_11 * RI_1 + R_12 * RI_2
    self_8_new = R_20 * RI_3 + R_21 * RI_4 + R_22 * RI_5
    self_9_new = R_20 * RI_0 + R_21 * RI_1 + R_22 * RI_2
    return (self_0, self_1_new, self_2_new, self_3_new, self_4_new, self_5_new, self_6_new,
        self_7_new, self_8_new, self_9_new)


@kernel("(10),(3)->(10)")
def inertia_translated(Ji, t):
    """Jo = Ji translated by t: m, mt + m t, I.

    (10),(3)->(10).  Ji, Jo: inertia (m in kg; mt = m c in kg m; I about the centre of mass c,
    xx, yy, zz, xy, yz, zx in kg m^2); t: vector.
    3 mul, 3 add.  Error <= u |result| + (m: 0, mt: 1/16, I: 0) u^2 S, S the sum of the |terms|
    of the expanded formula; barring over- and underflow.
    """
    Ji_0, Ji_1, Ji_2, Ji_3, Ji_4, Ji_5, Ji_6, Ji_7, Ji_8, Ji_9 = Ji
    t_0, t_1, t_2 = t
    Jo_1 = Ji_0 * t_0 + Ji_1
    Jo_2 = Ji_0 * t_1 + Ji_2
    Jo_3 = Ji_0 * t_2 + Ji_3
    return (Ji_0, Jo_1, Jo_2, Jo_3, Ji_4, Ji_5, Ji_6, Ji_7, Ji_8, Ji_9)


@kernel("(10),(3)->(10)")
def inertia_translate(self, t):
    """self = self translated by t: m, mt + m t, I.

    (10),(3)->(10).  self: inertia (m in kg; mt = m c in kg m; I about the centre of mass c, xx,
    yy, zz, xy, yz, zx in kg m^2); t: vector.
    3 mul, 3 add.  Error <= u |result| + (m: 0, mt: 1/16, I: 0) u^2 S, S the sum of the |terms|
    of the expanded formula; barring over- and underflow.
    """
    self_0, self_1, self_2, self_3, self_4, self_5, self_6, self_7, self_8, self_9 = self
    t_0, t_1, t_2 = t
    self_1_new = self_0 * t_0 + self_1
    self_2_new = self_0 * t_1 + self_2
    self_3_new = self_0 * t_2 + self_3
    return (self_0, self_1_new, self_2_new, self_3_new, self_4, self_5, self_6, self_7, self_8,
        self_9)


@kernel("(10),(3,4)->(10)")
def inertia_transformed(Ji, D):
    """Jo = Ji displaced by D = [R | t]: m, R mt + m t, R I R^T.

    (10),(3,4)->(10).  Ji, Jo: inertia (m in kg; mt = m c in kg m; I about the centre of mass c,
    xx, yy, zz, xy, yz, zx in kg m^2); D: displacement [R | t], R rotation, t in m.
    57 mul, 39 add.  Error <= u |result| + (m: 0, mt: 1/8, I: 3/16) u^2 S, S the sum of the
    |terms| of the expanded formula; barring over- and underflow.
    """
    Ji_0, Ji_1, Ji_2, Ji_3, Ji_4, Ji_5, Ji_6, Ji_7, Ji_8, Ji_9 = Ji
    D_00, D_01, D_02, D_03, D_10, D_11, D_12, D_13, D_20, D_21, D_22, D_23 = D
    RI_0 = Ji_4 * D_00 + Ji_7 * D_01 + Ji_9 * D_02
    RI_1 = Ji_5 * D_01 + Ji_7 * D_00 + Ji_8 * D_02
    RI_2 = Ji_6 * D_02 + Ji_8 * D_01 + Ji_9 * D_00
    RI_3 = Ji_4 * D_10 + Ji_7 * D_11 + Ji_9 * D_12
    RI_4 = Ji_5 * D_11 + Ji_7 * D_10 + Ji_8 * D_12
    RI_5 = Ji_6 * D_12 + Ji_8 * D_11 + Ji_9 * D_10
    RI_6 = Ji_4 * D_20 + Ji_7 * D_21 + Ji_9 * D_22
    RI_7 = Ji_5 * D_21 + Ji_7 * D_20 + Ji_8 * D_22
    RI_8 = Ji_6 * D_22 + Ji_8 * D_21 + Ji_9 * D_20
    Jo_1 = Ji_0 * D_03 + (Ji_1 * D_00 + Ji_2 * D_01 + Ji_3 * D_02)
    Jo_2 = Ji_0 * D_13 + (Ji_1 * D_10 + Ji_2 * D_11 + Ji_3 * D_12)
    Jo_3 = Ji_0 * D_23 + (Ji_1 * D_20 + Ji_2 * D_21 + Ji_3 * D_22)
    Jo_4 = D_00 * RI_0 + D_01 * RI_1 + D_02 * RI_2
    Jo_5 = D_10 * RI_3 + D_11 * RI_4 + D_12 * RI_5
    Jo_6 = D_20 * RI_6 + D_21 * RI_7 + D_22 * RI_8
    Jo_7 = D_10 * RI_0 + D_11 * RI_1 + D_12 * RI_2
    Jo_8 = D_20 * RI_3 + D_21 * RI_4 + D_22 * RI_5
    Jo_9 = D_20 * RI_0 + D_21 * RI_1 + D_22 * RI_2
    return (Ji_0, Jo_1, Jo_2, Jo_3, Jo_4, Jo_5, Jo_6, Jo_7, Jo_8, Jo_9)


@kernel("(10),(3,4)->(10)")
def inertia_transform(self, D):
    """self = self displaced by D = [R | t]: m, R mt + m t, R I R^T.

    (10),(3,4)->(10).  self: inertia (m in kg; mt = m c in kg m; I about the centre of mass c,
    xx, yy, zz, xy, yz, zx in kg m^2); D: displacement [R | t], R rotation, t in m.
    57 mul, 39 add.  Error <= u |result| + (m: 0, mt: 1/8, I: 3/16) u^2 S, S the sum of the
    |terms| of the expanded formula; barring over- and underflow.
    """
    self_0, self_1, self_2, self_3, self_4, self_5, self_6, self_7, self_8, self_9 = self
    D_00, D_01, D_02, D_03, D_10, D_11, D_12, D_13, D_20, D_21, D_22, D_23 = D
    RI_0 = self_4 * D_00 + self_7 * D_01 + self_9 * D_02
    RI_1 = self_5 * D_01 + self_7 * D_00 + self_8 * D_02
    RI_2 = self_6 * D_02 + self_8 * D_01 + self_9 * D_00
    RI_3 = self_4 * D_10 + self_7 * D_11 + self_9 * D_12
    RI_4 = self_5 * D_11 + self_7 * D_10 + self_8 * D_12
    RI_5 = self_6 * D_12 + self_8 * D_11 + self_9 * D_10
    RI_6 = self_4 * D_20 + self_7 * D_21 + self_9 * D_22
    RI_7 = self_5 * D_21 + self_7 * D_20 + self_8 * D_22
    RI_8 = self_6 * D_22 + self_8 * D_21 + self_9 * D_20
    self_1_new = self_0 * D_03 + (self_1 * D_00 + self_2 * D_01 + self_3 * D_02)
    self_2_new = self_0 * D_13 + (self_1 * D_10 + self_2 * D_11 + self_3 * D_12)
    self_3_new = self_0 * D_23 + (self_1 * D_20 + self_2 * D_21 + self_3 * D_22)
    self_4_new = D_00 * RI_0 + D_01 * RI_1 + D_02 * RI_2
    self_5_new = D_10 * RI_3 + D_11 * RI_4 + D_12 * RI_5
    self_6_new = D_20 * RI_6 + D_21 * RI_7 + D_22 * RI_8
    self_7_new = D_10 * RI_0 + D_11 * RI_1 + D_12 * RI_2
    self_8_new = D_20 * RI_3 + D_21 * RI_4 + D_22 * RI_5
    self_9_new = D_20 * RI_0 + D_21 * RI_1 + D_22 * RI_2
    return (self_0, self_1_new, self_2_new, self_3_new, self_4_new, self_5_new, self_6_new,
        self_7_new, self_8_new, self_9_new)


@kernel("(10),(3),(10),(3),(3,4)->(10)")
def inertia_merge(Ji, t_ic, Jj, t_jc, D_ij):
    """Ji = the inertia of two joined bodies: Ji, and Jj displaced by D_ij = [R | t]: m_i + m_j,
    mt_i + m_j c, I_i + R I_j R^T + m_i m_j/(m_i + m_j) (d·d 1 - d d^T) with c = R t_jc + t, d =
    c - t_ic; t_ic = mt_i / m_i and t_jc = mt_j / m_j are the centres of mass, each in its own
    frame; NaN where m_i + m_j = 0.

    (10),(3),(10),(3),(3,4)->(10).  Ji, Jj: inertia (m in kg; mt = m c in kg m; I about the
    centre of mass c, xx, yy, zz, xy, yz, zx in kg m^2); t_ic, t_jc: vector; D_ij: displacement
    [R | t], R rotation, t in m.
    67 mul, 61 add, 1 div.  Error <= 18 u times the sum of the absolute values of all terms, for
    masses that are not negative, barring over- and underflow.
    """
    Ji_0, Ji_1, Ji_2, Ji_3, Ji_4, Ji_5, Ji_6, Ji_7, Ji_8, Ji_9 = Ji
    t_ic_0, t_ic_1, t_ic_2 = t_ic
    Jj_0, Jj_1, Jj_2, Jj_3, Jj_4, Jj_5, Jj_6, Jj_7, Jj_8, Jj_9 = Jj
    t_jc_0, t_jc_1, t_jc_2 = t_jc
    (D_ij_00, D_ij_01, D_ij_02, D_ij_03, D_ij_10, D_ij_11, D_ij_12, D_ij_13, D_ij_20, D_ij_21,
        D_ij_22, D_ij_23) = D_ij
    m = Ji_0 + Jj_0
    c_0 = t_jc_0 * D_ij_00 + t_jc_1 * D_ij_01 + t_jc_2 * D_ij_02 + D_ij_03
    c_1 = t_jc_0 * D_ij_10 + t_jc_1 * D_ij_11 + t_jc_2 * D_ij_12 + D_ij_13
    c_2 = t_jc_0 * D_ij_20 + t_jc_1 * D_ij_21 + t_jc_2 * D_ij_22 + D_ij_23
    d_0 = c_0 - t_ic_0
    d_1 = c_1 - t_ic_1
    d_2 = c_2 - t_ic_2
    part = Jj_0 / m
    reduced = Ji_0 * part
    p_0 = d_0 * reduced
    p_1 = d_1 * reduced
    p_2 = d_2 * reduced
    squares_0 = d_0 * p_0
    squares_1 = d_1 * p_1
    squares_2 = d_2 * p_2
    RI_0 = Jj_4 * D_ij_00 + Jj_7 * D_ij_01 + Jj_9 * D_ij_02
    RI_1 = Jj_5 * D_ij_01 + Jj_7 * D_ij_00 + Jj_8 * D_ij_02
    RI_2 = Jj_6 * D_ij_02 + Jj_8 * D_ij_01 + Jj_9 * D_ij_00
    RI_3 = Jj_4 * D_ij_10 + Jj_7 * D_ij_11 + Jj_9 * D_ij_12
    RI_4 = Jj_5 * D_ij_11 + Jj_7 * D_ij_10 + Jj_8 * D_ij_12
    RI_5 = Jj_6 * D_ij_12 + Jj_8 * D_ij_11 + Jj_9 * D_ij_10
    RI_6 = Jj_4 * D_ij_20 + Jj_7 * D_ij_21 + Jj_9 * D_ij_22
    RI_7 = Jj_5 * D_ij_21 + Jj_7 * D_ij_20 + Jj_8 * D_ij_22
    RI_8 = Jj_6 * D_ij_22 + Jj_8 * D_ij_21 + Jj_9 * D_ij_20
    Ji_1_new = Ji_1 + Jj_0 * c_0
    Ji_2_new = Ji_2 + Jj_0 * c_1
    Ji_3_new = Ji_3 + Jj_0 * c_2
    Ji_4_new = Ji_4 + (D_ij_00 * RI_0 + D_ij_01 * RI_1 + D_ij_02 * RI_2) + (squares_1 + squares_2)
    Ji_5_new = Ji_5 + (D_ij_10 * RI_3 + D_ij_11 * RI_4 + D_ij_12 * RI_5) + (squares_0 + squares_2)
    Ji_6_new = Ji_6 + (D_ij_20 * RI_6 + D_ij_21 * RI_7 + D_ij_22 * RI_8) + (squares_0 + squares_1)
    Ji_7_new = Ji_7 + (D_ij_10 * RI_0 + D_ij_11 * RI_1 + D_ij_12 * RI_2) - d_1 * p_0
    Ji_8_new = Ji_8 + (D_ij_20 * RI_3 + D_ij_21 * RI_4 + D_ij_22 * RI_5) - d_2 * p_1
    Ji_9_new = Ji_9 + (D_ij_20 * RI_0 + D_ij_21 * RI_1 + D_ij_22 * RI_2) - d_2 * p_0
    return (m, Ji_1_new, Ji_2_new, Ji_3_new, Ji_4_new, Ji_5_new, Ji_6_new, Ji_7_new, Ji_8_new,
        Ji_9_new)
