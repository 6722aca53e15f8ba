# Made by `coscrew generate`; changes are overwritten.
# SPDX-License-Identifier: MIT
# coscrew 0.2.0.  Copyright (c) 2026 The coscrew authors.
"""Spatial inertias of rigid bodies: mass, first moment, second moments about the origin.

In single precision, accurate tier.
"""

from numpy import where
from coscrew._kernel import wide_kernel as kernel


@kernel("(10),()->(10)")
def spatial_inertia_scale(self, a):
    """self = a self.

    (10),()->(10).  self: spatial inertia (m in kg; h = m c in kg m; I about the origin, xx, yy,
    zz, xy, xz, yz in kg m^2); a: number.
    10 mul.  Error <= u |result| + 1/32 u^2 S, S the sum of the |terms| of the expanded formula;
    barring over- and underflow.
    """
    self_0, self_1, self_2, self_3, self_4, self_5, self_6, self_7, self_8, self_9 = self
    self_0_new = self_0 * a
    self_1_new = self_1 * a
    self_2_new = self_2 * a
    self_3_new = self_3 * a
    self_4_new = self_4 * a
    self_5_new = self_5 * a
    self_6_new = self_6 * a
    self_7_new = self_7 * a
    self_8_new = self_8 * a
    self_9_new = self_9 * a
    return (self_0_new, self_1_new, self_2_new, self_3_new, self_4_new, self_5_new, self_6_new,
        self_7_new, self_8_new, self_9_new)


@kernel("(10),(10)->(10)")
def add_BB(B1, B2):
    """Bo = B1 + B2.

    (10),(10)->(10).  B1, B2, Bo: spatial inertia (m in kg; h = m c in kg m; I about the origin,
    xx, yy, zz, xy, xz, yz in kg m^2).
    10 add.  Error <= u |result| + 1/32 u^2 S, S the sum of the |terms| of the expanded formula;
    barring over- and underflow.
    """
    B1_0, B1_1, B1_2, B1_3, B1_4, B1_5, B1_6, B1_7, B1_8, B1_9 = B1
    B2_0, B2_1, B2_2, B2_3, B2_4, B2_5, B2_6, B2_7, B2_8, B2_9 = B2
    Bo_0 = B1_0 + B2_0
    Bo_1 = B1_1 + B2_1
    Bo_2 = B1_2 + B2_2
    Bo_3 = B1_3 + B2_3
    Bo_4 = B1_4 + B2_4
    Bo_5 = B1_5 + B2_5
    Bo_6 = B1_6 + B2_6
    Bo_7 = B1_7 + B2_7
    Bo_8 = B1_8 + B2_8
    Bo_9 = B1_9 + B2_9
    return (Bo_0, Bo_1, Bo_2, Bo_3, Bo_4, Bo_5, Bo_6, Bo_7, Bo_8, Bo_9)


@kernel("(10),(10)->(10)")
def subtract_BB(B1, B2):
    """Bo = B1 - B2.

    (10),(10)->(10).  B1, B2, Bo: spatial inertia (m in kg; h = m c in kg m; I about the origin,
    xx, yy, zz, xy, xz, yz in kg m^2).
    10 add.  Error <= u |result| + 1/32 u^2 S, S the sum of the |terms| of the expanded formula;
    barring over- and underflow.
    """
    B1_0, B1_1, B1_2, B1_3, B1_4, B1_5, B1_6, B1_7, B1_8, B1_9 = B1
    B2_0, B2_1, B2_2, B2_3, B2_4, B2_5, B2_6, B2_7, B2_8, B2_9 = B2
    Bo_0 = B1_0 - B2_0
    Bo_1 = B1_1 - B2_1
    Bo_2 = B1_2 - B2_2
    Bo_3 = B1_3 - B2_3
    Bo_4 = B1_4 - B2_4
    Bo_5 = B1_5 - B2_5
    Bo_6 = B1_6 - B2_6
    Bo_7 = B1_7 - B2_7
    Bo_8 = B1_8 - B2_8
    Bo_9 = B1_9 - B2_9
    return (Bo_0, Bo_1, Bo_2, Bo_3, Bo_4, Bo_5, Bo_6, Bo_7, Bo_8, Bo_9)


@kernel("(),(3),(3,3)->(10)")
def spatial_inertia_from_com(m, com, Ic):
    """Bo: mass m, centre of mass com, second moments Ic about it (kg m^2; only the upper triangle
    is read): h = m com, I = Ic - m com~ com~.

    (),(3),(3,3)->(10).  m: number; com: vector; Ic: rotation or other 3×3 matrix; Bo: spatial
    inertia (m in kg; h = m c in kg m; I about the origin, xx, yy, zz, xy, xz, yz in kg m^2).
    9 mul, 9 add.  Error <= u |result| + (m: 0, h: 1/32, I: 1/8) u^2 S, S the sum of the |terms|
    of the expanded formula; barring over- and underflow.
    """
    com_0, com_1, com_2 = com
    Ic_00, Ic_01, Ic_02, Ic_10, Ic_11, Ic_12, Ic_20, Ic_21, Ic_22 = Ic
    h_0 = m * com_0
    h_1 = m * com_1
    h_2 = m * com_2
    squares_0 = com_0 * h_0
    squares_1 = com_1 * h_1
    squares_2 = com_2 * h_2
    Bo_4 = Ic_00 + (squares_1 + squares_2)
    Bo_5 = Ic_11 + (squares_0 + squares_2)
    Bo_6 = Ic_22 + (squares_0 + squares_1)
    Bo_7 = Ic_01 - com_1 * h_0
    Bo_8 = Ic_02 - com_2 * h_0
    Bo_9 = Ic_12 - com_2 * h_1
    return (m, h_0, h_1, h_2, Bo_4, Bo_5, Bo_6, Bo_7, Bo_8, Bo_9)


@kernel("(10)->(10)")
def spatial_inertia_from_inertia(J):
    """Bo = (m, mt, I - mt~ mt~ / m) from the inertia J, whose moments are about the centre of
    mass; NaN where m = 0.

    (10)->(10).  J: inertia (m in kg; mt = m c in kg m; I about the centre of mass c, xx, yy,
    zz, xy, yz, zx in kg m^2); Bo: spatial inertia (m in kg; h = m c in kg m; I about the
    origin, xx, yy, zz, xy, xz, yz in kg m^2).
    6 mul, 9 add, 3 div.  Error of a moment <= 4 u times the sum of its |terms|, barring over-
    and underflow.
    """
    J_0, J_1, J_2, J_3, J_4, J_5, J_6, J_7, J_8, J_9 = J
    c_0 = J_1 / J_0
    c_1 = J_2 / J_0
    c_2 = J_3 / J_0
    squares_0 = J_1 * c_0
    squares_1 = J_2 * c_1
    squares_2 = J_3 * c_2
    Bo_4 = J_4 + (squares_1 + squares_2)
    Bo_5 = J_5 + (squares_0 + squares_2)
    Bo_6 = J_6 + (squares_0 + squares_1)
    Bo_7 = J_7 - J_1 * c_1
    Bo_8 = J_9 - J_1 * c_2
    Bo_9 = J_8 - J_2 * c_2
    return (J_0, J_1, J_2, J_3, Bo_4, Bo_5, Bo_6, Bo_7, Bo_8, Bo_9)


@kernel("(10)->(10)")
def inertia_from_spatial_inertia(B):
    """Jo = (m, h, I + h~ h~ / m) from the spatial inertia B, with moments about the centre of
    mass; NaN where m = 0.

    (10)->(10).  B: spatial inertia (m in kg; h = m c in kg m; I about the origin, xx, yy, zz,
    xy, xz, yz in kg m^2); Jo: inertia (m in kg; mt = m c in kg m; I about the centre of mass c,
    xx, yy, zz, xy, yz, zx in kg m^2).
    6 mul, 9 add, 3 div.  Error of a moment <= 4 u times the sum of its |terms|, barring over-
    and underflow.
    """
    B_0, B_1, B_2, B_3, B_4, B_5, B_6, B_7, B_8, B_9 = B
    c_0 = B_1 / B_0
    c_1 = B_2 / B_0
    c_2 = B_3 / B_0
    squares_0 = B_1 * c_0
    squares_1 = B_2 * c_1
    squares_2 = B_3 * c_2
    Jo_4 = B_4 - (squares_1 + squares_2)
    Jo_5 = B_5 - (squares_0 + squares_2)
    Jo_6 = B_6 - (squares_0 + squares_1)
    Jo_7 = B_1 * c_1 + B_7
    Jo_8 = B_2 * c_2 + B_9
    Jo_9 = B_1 * c_2 + B_8
    return (B_0, B_1, B_2, B_3, Jo_4, Jo_5, Jo_6, Jo_7, Jo_8, Jo_9)


@kernel("(10)->(3)")
def spatial_inertia_com(B):
    """vo = h / m, the centre of mass in m.

    (10)->(3).  B: spatial inertia (m in kg; h = m c in kg m; I about the origin, xx, yy, zz,
    xy, xz, yz in kg m^2); vo: vector.
    3 div.  Error <= u |result|, barring over- and underflow.
    """
    B_0, B_1, B_2, B_3, B_4, B_5, B_6, B_7, B_8, B_9 = B
    vo_0 = B_1 / B_0
    vo_1 = B_2 / B_0
    vo_2 = B_3 / B_0
    return (vo_0, vo_1, vo_2)


@kernel("(10)->(3,3)")
def spatial_inertia_about_com(B):
    """Ro = I + h~ h~ / m, the second moments about the centre of mass.

    (10)->(3,3).  B: spatial inertia (m in kg; h = m c in kg m; I about the origin, xx, yy, zz,
    xy, xz, yz in kg m^2); Ro: rotation or other 3×3 matrix.
    6 mul, 9 add, 3 div.
    """
    B_0, B_1, B_2, B_3, B_4, B_5, B_6, B_7, B_8, B_9 = B
    c_0 = B_1 / B_0
    c_1 = B_2 / B_0
    c_2 = B_3 / B_0
    squares_0 = B_1 * c_0
    squares_1 = B_2 * c_1
    squares_2 = B_3 * c_2
    about_0 = B_4 - (squares_1 + squares_2)
    about_1 = B_5 - (squares_0 + squares_2)
    about_2 = B_6 - (squares_0 + squares_1)
    about_3 = B_1 * c_1 + B_7
    about_4 = B_1 * c_2 + B_8
    about_5 = B_2 * c_2 + B_9
    return (about_0, about_3, about_4, about_3, about_1, about_5, about_4, about_5, about_2)


@kernel("(10),(6)->(6)")
def product_Bs(B, s):
    """co = B s = (m v - h × ω; h × v + I ω), the momentum of a body that moves with s.

    (10),(6)->(6).  B: spatial inertia (m in kg; h = m c in kg m; I about the origin, xx, yy,
    zz, xy, xz, yz in kg m^2); s: screw (v in m/s; ω in rad/s); co: coscrew (f in N; τ in N m).
    24 mul, 18 add.  Error <= u |result| + (lin: 3/32, ang: 1/8) u^2 S, S the sum of the |terms|
    of the expanded formula; barring over- and underflow.
    """
    B_0, B_1, B_2, B_3, B_4, B_5, B_6, B_7, B_8, B_9 = B
    s_0, s_1, s_2, s_3, s_4, s_5 = s
    co_0 = B_0 * s_0 + (B_3 * s_4 - B_2 * s_5)
    co_1 = B_0 * s_1 + (B_1 * s_5 - B_3 * s_3)
    co_2 = B_0 * s_2 + (B_2 * s_3 - B_1 * s_4)
    co_3 = B_2 * s_2 - B_3 * s_1 + (B_4 * s_3 + B_7 * s_4 + B_8 * s_5)
    co_4 = B_3 * s_0 - B_1 * s_2 + (B_5 * s_4 + B_7 * s_3 + B_9 * s_5)
    co_5 = B_1 * s_1 - B_2 * s_0 + (B_6 * s_5 + B_8 * s_3 + B_9 * s_4)
    return (co_0, co_1, co_2, co_3, co_4, co_5)


@kernel("(10),(6)->()")
def spatial_inertia_energy(B, s):
    """s·B s / 2, the kinetic energy in J of a body that moves with s.

    (10),(6)->().  B: spatial inertia (m in kg; h = m c in kg m; I about the origin, xx, yy, zz,
    xy, xz, yz in kg m^2); s: screw (v in m/s; ω in rad/s); energy: number.
    26 mul, 17 add.  Error <= u |result| + 1/4 u^2 S, S the sum of the |terms| of the expanded
    formula; barring over- and underflow.
    """
    B_0, B_1, B_2, B_3, B_4, B_5, B_6, B_7, B_8, B_9 = B
    s_0, s_1, s_2, s_3, s_4, s_5 = s
    square = s_0 * s_0 + s_1 * s_1 + s_2 * s_2
    L_0 = B_4 * s_3 + B_7 * s_4 + B_8 * s_5
    L_1 = B_5 * s_4 + B_7 * s_3 + B_9 * s_5
    L_2 = B_6 * s_5 + B_8 * s_3 + B_9 * s_4
    twice = B_0 * square + (s_3 * L_0 + s_4 * L_1 + s_5 * L_2)
    across_0 = B_3 * s_4 - B_2 * s_5
    across_1 = B_1 * s_5 - B_3 * s_3
    across_2 = B_2 * s_3 - B_1 * s_4
    energy = s_0 * across_0 + s_1 * across_1 + s_2 * across_2 + 0.5 * twice
    return energy


@kernel("(10),(3),(6)->(6)")
def spatial_inertia_net_wrench(B, w, ds):
    """co = B ds + (w × (w × h); w × I w): the net wrench, about the origin, of a body with angular
    velocity w and acceleration ds = (a; w'), where a is that of the point now at the origin; if
    a is less gravity's, so is the wrench.

    (10),(3),(6)->(6).  B: spatial inertia (m in kg; h = m c in kg m; I about the origin, xx,
    yy, zz, xy, xz, yz in kg m^2); w: vector; ds: screw (v in m/s; ω in rad/s); co: coscrew (f
    in N; τ in N m).
    39 mul, 42 add, 3 neg.  Error <= u |result| + (lin: 3/16, ang: 7/32) u^2 S, S the sum of the
    |terms| of the expanded formula; barring over- and underflow.
    """
    B_0, B_1, B_2, B_3, B_4, B_5, B_6, B_7, B_8, B_9 = B
    w_0, w_1, w_2 = w
    ds_0, ds_1, ds_2, ds_3, ds_4, ds_5 = ds
    ww_0 = w_0 * w_0
    ww_1 = w_1 * w_1
    ww_2 = w_2 * w_2
    ww_3 = w_0 * w_1
    ww_4 = w_0 * w_2
    ww_5 = w_1 * w_2
    U_0 = -ww_1 - ww_2
    U_1 = ww_3 - ds_5
    U_2 = ds_4 + ww_4
    U_3 = ds_5 + ww_3
    U_4 = -ww_0 - ww_2
    U_5 = ww_5 - ds_3
    U_6 = ww_4 - ds_4
    U_7 = ds_3 + ww_5
    U_8 = -ww_0 - ww_1
    others_0 = B_6 - B_5
    others_1 = B_4 - B_6
    others_2 = B_5 - B_4
    squares_0 = ww_1 - ww_2
    squares_1 = ww_2 - ww_0
    squares_2 = ww_0 - ww_1
    own_0 = B_4 * ds_3 + ww_5 * others_0
    own_1 = B_5 * ds_4 + ww_4 * others_1
    own_2 = B_6 * ds_5 + ww_3 * others_2
    N_0 = B_8 * U_3 - B_7 * U_6 + B_9 * squares_0 + own_0
    N_1 = B_7 * U_7 - B_9 * U_1 + B_8 * squares_1 + own_1
    N_2 = B_7 * squares_2 + (B_9 * U_2 - B_8 * U_5) + own_2
    co_0 = B_0 * ds_0 + (B_1 * U_0 + B_2 * U_1 + B_3 * U_2)
    co_1 = B_0 * ds_1 + (B_1 * U_3 + B_2 * U_4 + B_3 * U_5)
    co_2 = B_0 * ds_2 + (B_1 * U_6 + B_2 * U_7 + B_3 * U_8)
    co_3 = B_2 * ds_2 - B_3 * ds_1 + N_0
    co_4 = B_3 * ds_0 - B_1 * ds_2 + N_1
    co_5 = B_1 * ds_1 - B_2 * ds_0 + N_2
    return (co_0, co_1, co_2, co_3, co_4, co_5)


@kernel("(3),(10)->(10)")
def spatial_inertia_shifted(t, B):
    """Bo = B moved by t: m, h + m t, I - t~ (h + m t)~ - h~ t~.

    (3),(10)->(10).  t: vector; B, Bo: spatial inertia (m in kg; h = m c in kg m; I about the
    origin, xx, yy, zz, xy, xz, yz in kg m^2).
    18 mul, 18 add.  Error <= u |result| + (m: 0, h: 1/16, I: 5/32) u^2 S, S the sum of the
    |terms| of the expanded formula; barring over- and underflow.
    """
    t_0, t_1, t_2 = t
    B_0, B_1, B_2, B_3, B_4, B_5, B_6, B_7, B_8, B_9 = B
    mt_0 = t_0 * B_0
    mt_1 = t_1 * B_0
    mt_2 = t_2 * B_0
    half_0 = 0.5 * mt_0
    half_1 = 0.5 * mt_1
    half_2 = 0.5 * mt_2
    n_0 = B_1 + half_0
    n_1 = B_2 + half_1
    n_2 = B_3 + half_2
    tn0 = t_0 * n_0
    tn1 = t_1 * n_1
    tn2 = t_2 * n_2
    own_0 = 2 * tn0
    own_1 = 2 * tn1
    own_2 = 2 * tn2
    pairs_0 = own_1 + own_2
    pairs_1 = own_0 + own_2
    pairs_2 = own_0 + own_1
    pairs_3 = t_0 * n_1 + t_1 * n_0
    pairs_4 = t_0 * n_2 + t_2 * n_0
    pairs_5 = t_1 * n_2 + t_2 * n_1
    moved_0 = B_1 + mt_0
    moved_1 = B_2 + mt_1
    moved_2 = B_3 + mt_2
    Bo_4 = B_4 + pairs_0
    Bo_5 = B_5 + pairs_1
    Bo_6 = B_6 + pairs_2
    Bo_7 = B_7 - pairs_3
    Bo_8 = B_8 - pairs_4
    Bo_9 = B_9 - pairs_5
    return (B_0, moved_0, moved_1, moved_2, Bo_4, Bo_5, Bo_6, Bo_7, Bo_8, Bo_9)


@kernel("(3,4),(10)->(10)")
def spatial_inertia_transformed(D, B):
    """Bo = [Ad]*(D) B [Ad]^-1(D): B, given in the frame at D, in the reference frame.

    (3,4),(10)->(10).  D: displacement [R | t], R rotation, t in m; B, Bo: spatial inertia (m in
    kg; h = m c in kg m; I about the origin, xx, yy, zz, xy, xz, yz in kg m^2).
    72 mul, 54 add.  Error <= u |result| + (m: 0, h: 1/8, I: 7/32) u^2 S, S the sum of the
    |terms| of the expanded formula; barring over- and underflow.
    """
    D_00, D_01, D_02, D_03, D_10, D_11, D_12, D_13, D_20, D_21, D_22, D_23 = D
    B_0, B_1, B_2, B_3, B_4, B_5, B_6, B_7, B_8, B_9 = B
    RI_0 = D_00 * B_4 + D_01 * B_7 + D_02 * B_8
    RI_1 = D_00 * B_7 + D_01 * B_5 + D_02 * B_9
    RI_2 = D_00 * B_8 + D_01 * B_9 + D_02 * B_6
    RI_3 = D_10 * B_4 + D_11 * B_7 + D_12 * B_8
    RI_4 = D_10 * B_7 + D_11 * B_5 + D_12 * B_9
    RI_5 = D_10 * B_8 + D_11 * B_9 + D_12 * B_6
    RI_6 = D_20 * B_4 + D_21 * B_7 + D_22 * B_8
    RI_7 = D_20 * B_7 + D_21 * B_5 + D_22 * B_9
    RI_8 = D_20 * B_8 + D_21 * B_9 + D_22 * B_6
    turned_1 = D_00 * B_1 + D_01 * B_2 + D_02 * B_3
    turned_2 = D_10 * B_1 + D_11 * B_2 + D_12 * B_3
    turned_3 = D_20 * B_1 + D_21 * B_2 + D_22 * B_3
    turned_4 = D_00 * RI_0 + D_01 * RI_1 + D_02 * RI_2
    turned_5 = D_10 * RI_3 + D_11 * RI_4 + D_12 * RI_5
    turned_6 = D_20 * RI_6 + D_21 * RI_7 + D_22 * RI_8
    turned_7 = D_10 * RI_0 + D_11 * RI_1 + D_12 * RI_2
    turned_8 = D_20 * RI_0 + D_21 * RI_1 + D_22 * RI_2
    turned_9 = D_20 * RI_3 + D_21 * RI_4 + D_22 * RI_5
    mt_0 = D_03 * B_0
    mt_1 = D_13 * B_0
    mt_2 = D_23 * B_0
    half_0 = 0.5 * mt_0
    half_1 = 0.5 * mt_1
    half_2 = 0.5 * mt_2
    n_0 = turned_1 + half_0
    n_1 = turned_2 + half_1
    n_2 = turned_3 + half_2
    tn0 = D_03 * n_0
    tn1 = D_13 * n_1
    tn2 = D_23 * n_2
    own_0 = 2 * tn0
    own_1 = 2 * tn1
    own_2 = 2 * tn2
    pairs_0 = own_1 + own_2
    pairs_1 = own_0 + own_2
    pairs_2 = own_0 + own_1
    pairs_3 = D_03 * n_1 + D_13 * n_0
    pairs_4 = D_03 * n_2 + D_23 * n_0
    pairs_5 = D_13 * n_2 + D_23 * n_1
    moved_0 = turned_1 + mt_0
    moved_1 = turned_2 + mt_1
    moved_2 = turned_3 + mt_2
    Bo_4 = turned_4 + pairs_0
    Bo_5 = turned_5 + pairs_1
    Bo_6 = turned_6 + pairs_2
    Bo_7 = turned_7 - pairs_3
    Bo_8 = turned_8 - pairs_4
    Bo_9 = turned_9 - pairs_5
    return (B_0, moved_0, moved_1, moved_2, Bo_4, Bo_5, Bo_6, Bo_7, Bo_8, Bo_9)


@kernel("(10)->()")
def spatial_inertia_consistency(B):
    """the smallest pivot of [[m, h^T], [h, tr(I)/2 1 - I]], each divided by its diagonal entry:
    positive exactly if a body of positive density has this inertia.

    (10)->().  B: spatial inertia (m in kg; h = m c in kg m; I about the origin, xx, yy, zz, xy,
    xz, yz in kg m^2); pivot: number.
    11 mul, 15 add, 10 div, 3 neg, 9 less, 13 select.
    """
    B_0, B_1, B_2, B_3, B_4, B_5, B_6, B_7, B_8, B_9 = B
    twice_trace = B_4 + B_5 + B_6
    trace = 0.5 * twice_trace
    sigma_0 = trace - B_4
    sigma_1 = trace - B_5
    sigma_2 = trace - B_6
    divisor0a = 0 < B_0
    divisor0 = where(divisor0a, B_0, 1)
    l0_0 = B_1 / divisor0
    l0_1 = B_2 / divisor0
    l0_2 = B_3 / divisor0
    u1_0 = sigma_0 - B_1 * l0_0
    u1_1 = -(B_2 * l0_0) - B_7
    u1_2 = -(B_3 * l0_0) - B_8
    divisor1 = where(0 < u1_0, u1_0, 1)
    l1_0 = u1_1 / divisor1
    l1_1 = u1_2 / divisor1
    u2_0 = sigma_1 - B_2 * l0_1 - u1_1 * l1_0
    u2_1 = -(B_3 * l0_1) - B_9 - u1_2 * l1_0
    divisor2 = where(0 < u2_0, u2_0, 1)
    l2 = u2_1 / divisor2
    u3 = sigma_2 - B_3 * l0_2 - u1_2 * l1_1 - u2_1 * l2
    part0 = where(divisor0a, B_0 / divisor0, B_0)
    own1a = 0 < sigma_0
    own1 = where(own1a, sigma_0, 1)
    part1 = where(own1a, u1_0 / own1, sigma_0)
    smallest1 = where(part0 < part1, part0, part1)
    own2a = 0 < sigma_1
    own2 = where(own2a, sigma_1, 1)
    part2 = where(own2a, u2_0 / own2, sigma_1)
    smallest2 = where(smallest1 < part2, smallest1, part2)
    own3a = 0 < sigma_2
    own3 = where(own3a, sigma_2, 1)
    part3 = where(own3a, u3 / own3, sigma_2)
    smallest3 = where(smallest2 < part3, smallest2, part3)
    return smallest3
