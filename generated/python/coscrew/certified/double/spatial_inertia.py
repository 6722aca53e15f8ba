# Made by `coscrew generate`; changes are overwritten.
# SPDX-License-Identifier: MIT
# coscrew 0.2.0.  Copyright (c) 2026 The coscrew authors.
"""Spatial inertias of rigid bodies: mass, first moment, second moments about the origin.

In double precision, certified tier.
"""

from numpy import absolute
from coscrew._kernel import double_kernel as kernel
from numpy import errstate


@kernel("(10),()->(10),(10)")
@errstate(all="ignore")
def spatial_inertia_scale(self, a, *, c1=2.004168360008973e-292, c2=1.1102230246251568e-16):
    """self = a self; |error of self| <= self_bound unless inf or NaN.

    (10),()->(10),(10).  self, self_bound: spatial inertia (m in kg; h = m c in kg m; I about
    the origin, xx, yy, zz, xy, xz, yz in kg m^2); a: number.
    20 mul, 10 add, 10 abs.
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
    self_0_new_bound = c2 * (absolute(self_0_new) + c1)
    self_1_new_bound = c2 * (absolute(self_1_new) + c1)
    self_2_new_bound = c2 * (absolute(self_2_new) + c1)
    self_3_new_bound = c2 * (absolute(self_3_new) + c1)
    self_4_new_bound = c2 * (absolute(self_4_new) + c1)
    self_5_new_bound = c2 * (absolute(self_5_new) + c1)
    self_6_new_bound = c2 * (absolute(self_6_new) + c1)
    self_7_new_bound = c2 * (absolute(self_7_new) + c1)
    self_8_new_bound = c2 * (absolute(self_8_new) + c1)
    self_9_new_bound = c2 * (absolute(self_9_new) + c1)
    return (self_0_new, self_1_new, self_2_new, self_3_new, self_4_new, self_5_new, self_6_new,
        self_7_new, self_8_new, self_9_new, self_0_new_bound, self_1_new_bound, self_2_new_bound,
        self_3_new_bound, self_4_new_bound, self_5_new_bound, self_6_new_bound, self_7_new_bound,
        self_8_new_bound, self_9_new_bound)


@kernel("(10),(10)->(10),(10)")
@errstate(all="ignore")
def add_BB(B1, B2, *, c1=1.1102230246251568e-16):
    """Bo = B1 + B2; |error of Bo| <= Bo_bound unless inf or NaN.

    (10),(10)->(10),(10).  B1, B2, Bo, Bo_bound: spatial inertia (m in kg; h = m c in kg m; I
    about the origin, xx, yy, zz, xy, xz, yz in kg m^2).
    10 mul, 10 add, 10 abs.
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
    Bo_0_bound = c1 * absolute(Bo_0)
    Bo_1_bound = c1 * absolute(Bo_1)
    Bo_2_bound = c1 * absolute(Bo_2)
    Bo_3_bound = c1 * absolute(Bo_3)
    Bo_4_bound = c1 * absolute(Bo_4)
    Bo_5_bound = c1 * absolute(Bo_5)
    Bo_6_bound = c1 * absolute(Bo_6)
    Bo_7_bound = c1 * absolute(Bo_7)
    Bo_8_bound = c1 * absolute(Bo_8)
    Bo_9_bound = c1 * absolute(Bo_9)
    return (Bo_0, Bo_1, Bo_2, Bo_3, Bo_4, Bo_5, Bo_6, Bo_7, Bo_8, Bo_9, Bo_0_bound, Bo_1_bound,
        Bo_2_bound, Bo_3_bound, Bo_4_bound, Bo_5_bound, Bo_6_bound, Bo_7_bound, Bo_8_bound,
        Bo_9_bound)


@kernel("(10),(10)->(10),(10)")
@errstate(all="ignore")
def subtract_BB(B1, B2, *, c1=1.1102230246251568e-16):
    """Bo = B1 - B2; |error of Bo| <= Bo_bound unless inf or NaN.

    (10),(10)->(10),(10).  B1, B2, Bo, Bo_bound: spatial inertia (m in kg; h = m c in kg m; I
    about the origin, xx, yy, zz, xy, xz, yz in kg m^2).
    10 mul, 10 add, 10 abs.
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
    Bo_0_bound = c1 * absolute(Bo_0)
    Bo_1_bound = c1 * absolute(Bo_1)
    Bo_2_bound = c1 * absolute(Bo_2)
    Bo_3_bound = c1 * absolute(Bo_3)
    Bo_4_bound = c1 * absolute(Bo_4)
    Bo_5_bound = c1 * absolute(Bo_5)
    Bo_6_bound = c1 * absolute(Bo_6)
    Bo_7_bound = c1 * absolute(Bo_7)
    Bo_8_bound = c1 * absolute(Bo_8)
    Bo_9_bound = c1 * absolute(Bo_9)
    return (Bo_0, Bo_1, Bo_2, Bo_3, Bo_4, Bo_5, Bo_6, Bo_7, Bo_8, Bo_9, Bo_0_bound, Bo_1_bound,
        Bo_2_bound, Bo_3_bound, Bo_4_bound, Bo_5_bound, Bo_6_bound, Bo_7_bound, Bo_8_bound,
        Bo_9_bound)


@kernel("(),(3),(3,3)->(10),(10)")
@errstate(all="ignore")
def spatial_inertia_from_com(m, com, Ic, *, c1=2.004168360008973e-292, c2=1.1102230246251568e-16,
        c3=4.440892098500628e-16, c4=3.3306690738754706e-16):
    """Bo: mass m, centre of mass com, second moments Ic about it (kg m^2; only the upper triangle
    is read): h = m com, I = Ic - m com~ com~; |error of Bo| <= Bo_bound unless inf or NaN.

    (),(3),(3,3)->(10),(10).  m: number; com: vector; Ic: rotation or other 3×3 matrix; Bo,
    Bo_bound: spatial inertia (m in kg; h = m c in kg m; I about the origin, xx, yy, zz, xy, xz,
    yz in kg m^2).
    24 mul, 27 add, 12 abs.
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
    h_0_padded = absolute(h_0) + c1
    squares_0_size = absolute(com_0) * h_0_padded
    h_1_padded = absolute(h_1) + c1
    com_1_abs = absolute(com_1)
    squares_1_size = com_1_abs * h_1_padded
    h_2_padded = absolute(h_2) + c1
    com_2_abs = absolute(com_2)
    squares_2_size = com_2_abs * h_2_padded
    Bo_4_size = absolute(Ic_00) + (squares_1_size + squares_2_size)
    Bo_5_size = absolute(Ic_11) + (squares_0_size + squares_2_size)
    Bo_6_size = absolute(Ic_22) + (squares_0_size + squares_1_size)
    Bo_7_size = absolute(Ic_01) + com_1_abs * h_0_padded
    Bo_8_size = absolute(Ic_02) + com_2_abs * h_0_padded
    Bo_9_size = absolute(Ic_12) + com_2_abs * h_1_padded
    h_0_bound = c2 * h_0_padded
    h_1_bound = c2 * h_1_padded
    h_2_bound = c2 * h_2_padded
    Bo_4_bound = c3 * (Bo_4_size + c1)
    Bo_5_bound = c3 * (Bo_5_size + c1)
    Bo_6_bound = c3 * (Bo_6_size + c1)
    Bo_7_bound = c4 * (Bo_7_size + c1)
    Bo_8_bound = c4 * (Bo_8_size + c1)
    Bo_9_bound = c4 * (Bo_9_size + c1)
    return (m, h_0, h_1, h_2, Bo_4, Bo_5, Bo_6, Bo_7, Bo_8, Bo_9, 0, h_0_bound, h_1_bound,
        h_2_bound, Bo_4_bound, Bo_5_bound, Bo_6_bound, Bo_7_bound, Bo_8_bound, Bo_9_bound)


@kernel("(10),(6)->(6),(6)")
@errstate(all="ignore")
def product_Bs(B, s, *, c1=2.004168360008973e-292, c2=3.3306690738754706e-16,
        c3=4.440892098500628e-16):
    """co = B s = (m v - h × ω; h × v + I ω), the momentum of a body that moves with s; |error of
    co| <= co_bound unless inf or NaN.

    (10),(6)->(6),(6).  B: spatial inertia (m in kg; h = m c in kg m; I about the origin, xx,
    yy, zz, xy, xz, yz in kg m^2); s: screw (v in m/s; ω in rad/s); co, co_bound: coscrew (f in
    N; τ in N m).
    30 mul, 42 add, 24 abs.
    """
    B_0, B_1, B_2, B_3, B_4, B_5, B_6, B_7, B_8, B_9 = B
    s_0, s_1, s_2, s_3, s_4, s_5 = s
    co_0a = B_0 * s_0
    co_0b = B_3 * s_4
    co_0c = B_2 * s_5
    co_0 = co_0a + (co_0b - co_0c)
    co_1a = B_0 * s_1
    co_1b = B_1 * s_5
    co_1c = B_3 * s_3
    co_1 = co_1a + (co_1b - co_1c)
    co_2a = B_0 * s_2
    co_2b = B_2 * s_3
    co_2c = B_1 * s_4
    co_2 = co_2a + (co_2b - co_2c)
    co_3a = B_2 * s_2
    co_3b = B_3 * s_1
    co_3d = B_4 * s_3
    co_3e = B_7 * s_4
    co_3g = B_8 * s_5
    co_3 = co_3a - co_3b + (co_3d + co_3e + co_3g)
    co_4a = B_3 * s_0
    co_4b = B_1 * s_2
    co_4d = B_5 * s_4
    co_4e = B_7 * s_3
    co_4g = B_9 * s_5
    co_4 = co_4a - co_4b + (co_4d + co_4e + co_4g)
    co_5a = B_1 * s_1
    co_5b = B_2 * s_0
    co_5d = B_6 * s_5
    co_5e = B_8 * s_3
    co_5g = B_9 * s_4
    co_5 = co_5a - co_5b + (co_5d + co_5e + co_5g)
    co_0_size = absolute(co_0a) + (absolute(co_0b) + absolute(co_0c))
    co_1_size = absolute(co_1a) + (absolute(co_1b) + absolute(co_1c))
    co_2_size = absolute(co_2a) + (absolute(co_2b) + absolute(co_2c))
    co_3_size = (absolute(co_3a) + absolute(co_3b)
        + (absolute(co_3d) + absolute(co_3e) + absolute(co_3g)))
    co_4_size = (absolute(co_4a) + absolute(co_4b)
        + (absolute(co_4d) + absolute(co_4e) + absolute(co_4g)))
    co_5_size = (absolute(co_5a) + absolute(co_5b)
        + (absolute(co_5d) + absolute(co_5e) + absolute(co_5g)))
    co_0_bound = c2 * (co_0_size + c1)
    co_1_bound = c2 * (co_1_size + c1)
    co_2_bound = c2 * (co_2_size + c1)
    co_3_bound = c3 * (co_3_size + c1)
    co_4_bound = c3 * (co_4_size + c1)
    co_5_bound = c3 * (co_5_size + c1)
    return (co_0, co_1, co_2, co_3, co_4, co_5, co_0_bound, co_1_bound, co_2_bound, co_3_bound,
        co_4_bound, co_5_bound)


@kernel("(10),(6)->(),()")
@errstate(all="ignore")
def spatial_inertia_energy(B, s, *, c1=2.004168360008973e-292, c2=9.992007221626415e-16):
    """s·B s / 2, the kinetic energy in J of a body that moves with s; |error of energy| <=
    energy_bound unless inf or NaN.

    (10),(6)->(),().  B: spatial inertia (m in kg; h = m c in kg m; I about the origin, xx, yy,
    zz, xy, xz, yz in kg m^2); s: screw (v in m/s; ω in rad/s); energy, energy_bound: number.
    35 mul, 43 add, 25 abs.
    """
    B_0, B_1, B_2, B_3, B_4, B_5, B_6, B_7, B_8, B_9 = B
    s_0, s_1, s_2, s_3, s_4, s_5 = s
    square_a = s_0 * s_0
    square_b = s_1 * s_1
    square_d = s_2 * s_2
    square = square_a + square_b + square_d
    L_0a = B_4 * s_3
    L_0b = B_7 * s_4
    L_0d = B_8 * s_5
    L_0 = L_0a + L_0b + L_0d
    L_1a = B_5 * s_4
    L_1b = B_7 * s_3
    L_1d = B_9 * s_5
    L_1 = L_1a + L_1b + L_1d
    L_2a = B_6 * s_5
    L_2b = B_8 * s_3
    L_2d = B_9 * s_4
    L_2 = L_2a + L_2b + L_2d
    twice = B_0 * square + (s_3 * L_0 + s_4 * L_1 + s_5 * L_2)
    across_0a = B_3 * s_4
    across_0b = B_2 * s_5
    across_0 = across_0a - across_0b
    across_1a = B_1 * s_5
    across_1b = B_3 * s_3
    across_1 = across_1a - across_1b
    across_2a = B_2 * s_3
    across_2b = B_1 * s_4
    across_2 = across_2a - across_2b
    energy = s_0 * across_0 + s_1 * across_1 + s_2 * across_2 + 0.5 * twice
    square_size = absolute(square_a) + absolute(square_b) + absolute(square_d)
    L_0_size = absolute(L_0a) + absolute(L_0b) + absolute(L_0d)
    L_1_size = absolute(L_1a) + absolute(L_1b) + absolute(L_1d)
    L_2_size = absolute(L_2a) + absolute(L_2b) + absolute(L_2d)
    twice_f_size = (absolute(s_3) * (L_0_size + c1) + absolute(s_4) * (L_1_size + c1)
        + absolute(s_5) * (L_2_size + c1))
    twice_size = absolute(B_0) * (square_size + c1) + twice_f_size
    across_0_size = absolute(across_0a) + absolute(across_0b)
    across_1_size = absolute(across_1a) + absolute(across_1b)
    across_2_size = absolute(across_2a) + absolute(across_2b)
    energy_e_size = (absolute(s_0) * (across_0_size + c1) + absolute(s_1) * (across_1_size + c1)
        + absolute(s_2) * (across_2_size + c1))
    energy_size = energy_e_size + 0.5 * (twice_size + c1)
    energy_bound = c2 * (energy_size + c1)
    return (energy, energy_bound)


@kernel("(10),(3),(6)->(6),(6)")
@errstate(all="ignore")
def spatial_inertia_net_wrench(B, w, ds, *, c1=2.004168360008973e-292, c2=6.661338147750942e-16,
        c3=7.7715611723761e-16):
    """co = B ds + (w × (w × h); w × I w): the net wrench, about the origin, of a body with angular
    velocity w and acceleration ds = (a; w'), where a is that of the point now at the origin; if
    a is less gravity's, so is the wrench; |error of co| <= co_bound unless inf or NaN.

    (10),(3),(6)->(6),(6).  B: spatial inertia (m in kg; h = m c in kg m; I about the origin,
    xx, yy, zz, xy, xz, yz in kg m^2); w: vector; ds: screw (v in m/s; ω in rad/s); co,
    co_bound: coscrew (f in N; τ in N m).
    66 mul, 102 add, 3 neg, 30 abs.
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
    U_0 = -(ww_1 + ww_2)
    U_1 = ww_3 - ds_5
    U_2 = ds_4 + ww_4
    U_3 = ds_5 + ww_3
    U_4 = -(ww_0 + ww_2)
    U_5 = ww_5 - ds_3
    U_6 = ww_4 - ds_4
    U_7 = ds_3 + ww_5
    U_8 = -(ww_0 + ww_1)
    others_0 = B_6 - B_5
    others_1 = B_4 - B_6
    others_2 = B_5 - B_4
    squares_0 = ww_1 - ww_2
    squares_1 = ww_2 - ww_0
    squares_2 = ww_0 - ww_1
    own_0a = B_4 * ds_3
    own_0 = own_0a + ww_5 * others_0
    own_1a = B_5 * ds_4
    own_1 = own_1a + ww_4 * others_1
    own_2a = B_6 * ds_5
    own_2 = own_2a + ww_3 * others_2
    N_0 = B_8 * U_3 - B_7 * U_6 + B_9 * squares_0 + own_0
    N_1 = B_7 * U_7 - B_9 * U_1 + B_8 * squares_1 + own_1
    N_2 = B_7 * squares_2 + (B_9 * U_2 - B_8 * U_5) + own_2
    co_0a = B_0 * ds_0
    co_0 = co_0a + (B_1 * U_0 + B_2 * U_1 + B_3 * U_2)
    co_1a = B_0 * ds_1
    co_1 = co_1a + (B_1 * U_3 + B_2 * U_4 + B_3 * U_5)
    co_2a = B_0 * ds_2
    co_2 = co_2a + (B_1 * U_6 + B_2 * U_7 + B_3 * U_8)
    co_3a = B_2 * ds_2
    co_3b = B_3 * ds_1
    co_3 = co_3a - co_3b + N_0
    co_4a = B_3 * ds_0
    co_4b = B_1 * ds_2
    co_4 = co_4a - co_4b + N_1
    co_5a = B_1 * ds_1
    co_5b = B_2 * ds_0
    co_5 = co_5a - co_5b + N_2
    ww_1_abs = absolute(ww_1)
    ww_2_abs = absolute(ww_2)
    ww_3_abs = absolute(ww_3)
    ds_5_abs = absolute(ds_5)
    U_1_size = ww_3_abs + ds_5_abs
    ds_4_abs = absolute(ds_4)
    ww_4_abs = absolute(ww_4)
    U_2_size = ds_4_abs + ww_4_abs
    U_3_size = ds_5_abs + ww_3_abs
    ww_0_abs = absolute(ww_0)
    ww_5_abs = absolute(ww_5)
    ds_3_abs = absolute(ds_3)
    U_5_size = ww_5_abs + ds_3_abs
    U_6_size = ww_4_abs + ds_4_abs
    U_7_size = ds_3_abs + ww_5_abs
    squares_0_size = ww_1_abs + ww_2_abs
    squares_1_size = ww_2_abs + ww_0_abs
    squares_2_size = ww_0_abs + ww_1_abs
    own_0_size = absolute(own_0a) + (ww_5_abs + c1) * absolute(others_0)
    own_1_size = absolute(own_1a) + (ww_4_abs + c1) * absolute(others_1)
    own_2_size = absolute(own_2a) + (ww_3_abs + c1) * absolute(others_2)
    U_3_padded = U_3_size + c1
    B_8_abs = absolute(B_8)
    U_6_padded = U_6_size + c1
    B_7_abs = absolute(B_7)
    B_9_abs = absolute(B_9)
    N_0_size = (B_8_abs * U_3_padded + B_7_abs * U_6_padded + B_9_abs * (squares_0_size + c1)
        + own_0_size)
    U_7_padded = U_7_size + c1
    U_1_padded = U_1_size + c1
    N_1_size = (B_7_abs * U_7_padded + B_9_abs * U_1_padded + B_8_abs * (squares_1_size + c1)
        + own_1_size)
    U_2_padded = U_2_size + c1
    U_5_padded = U_5_size + c1
    N_2_size = (B_7_abs * (squares_2_size + c1) + (B_9_abs * U_2_padded + B_8_abs * U_5_padded)
        + own_2_size)
    B_1_abs = absolute(B_1)
    B_2_abs = absolute(B_2)
    B_3_abs = absolute(B_3)
    co_0_size = (absolute(co_0a)
        + (B_1_abs * (ww_1_abs + ww_2_abs + c1) + B_2_abs * U_1_padded + B_3_abs * U_2_padded))
    co_1_size = (absolute(co_1a)
        + (B_1_abs * U_3_padded + B_2_abs * (ww_0_abs + ww_2_abs + c1) + B_3_abs * U_5_padded))
    co_2_size = (absolute(co_2a)
        + (B_1_abs * U_6_padded + B_2_abs * U_7_padded + B_3_abs * (ww_0_abs + ww_1_abs + c1)))
    co_3_size = absolute(co_3a) + absolute(co_3b) + N_0_size
    co_4_size = absolute(co_4a) + absolute(co_4b) + N_1_size
    co_5_size = absolute(co_5a) + absolute(co_5b) + N_2_size
    co_0_bound = c2 * (co_0_size + c1)
    co_1_bound = c2 * (co_1_size + c1)
    co_2_bound = c2 * (co_2_size + c1)
    co_3_bound = c3 * (co_3_size + c1)
    co_4_bound = c3 * (co_4_size + c1)
    co_5_bound = c3 * (co_5_size + c1)
    return (co_0, co_1, co_2, co_3, co_4, co_5, co_0_bound, co_1_bound, co_2_bound, co_3_bound,
        co_4_bound, co_5_bound)


@kernel("(3),(10)->(10),(10)")
@errstate(all="ignore")
def spatial_inertia_shifted(t, B, *, c1=2.004168360008973e-292, c2=2.2204460492503136e-16,
        c3=7.7715611723761e-16, c4=6.661338147750942e-16):
    """Bo = B moved by t: m, h + m t, I - t~ (h + m t)~ - h~ t~; |error of Bo| <= Bo_bound unless
    inf or NaN.

    (3),(10)->(10),(10).  t: vector; B, Bo, Bo_bound: spatial inertia (m in kg; h = m c in kg m;
    I about the origin, xx, yy, zz, xy, xz, yz in kg m^2).
    42 mul, 54 add, 15 abs.
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
    mt_0_abs = absolute(mt_0)
    half_0_size = 0.5 * (mt_0_abs + c1)
    mt_1_abs = absolute(mt_1)
    half_1_size = 0.5 * (mt_1_abs + c1)
    mt_2_abs = absolute(mt_2)
    half_2_size = 0.5 * (mt_2_abs + c1)
    B_1_abs = absolute(B_1)
    n_0_size = B_1_abs + half_0_size
    B_2_abs = absolute(B_2)
    n_1_size = B_2_abs + half_1_size
    B_3_abs = absolute(B_3)
    n_2_size = B_3_abs + half_2_size
    n_0_padded = n_0_size + c1
    t_0_abs = absolute(t_0)
    tn0_size = t_0_abs * n_0_padded
    n_1_padded = n_1_size + c1
    t_1_abs = absolute(t_1)
    tn1_size = t_1_abs * n_1_padded
    n_2_padded = n_2_size + c1
    t_2_abs = absolute(t_2)
    tn2_size = t_2_abs * n_2_padded
    own_0_size = 2 * (tn0_size + c1)
    own_1_size = 2 * (tn1_size + c1)
    own_2_size = 2 * (tn2_size + c1)
    pairs_0_size = own_1_size + own_2_size
    pairs_1_size = own_0_size + own_2_size
    pairs_2_size = own_0_size + own_1_size
    pairs_3_size = t_0_abs * n_1_padded + t_1_abs * n_0_padded
    pairs_4_size = t_0_abs * n_2_padded + t_2_abs * n_0_padded
    pairs_5_size = t_1_abs * n_2_padded + t_2_abs * n_1_padded
    moved_0_size = B_1_abs + mt_0_abs
    moved_1_size = B_2_abs + mt_1_abs
    moved_2_size = B_3_abs + mt_2_abs
    Bo_4_size = absolute(B_4) + pairs_0_size
    Bo_5_size = absolute(B_5) + pairs_1_size
    Bo_6_size = absolute(B_6) + pairs_2_size
    Bo_7_size = absolute(B_7) + pairs_3_size
    Bo_8_size = absolute(B_8) + pairs_4_size
    Bo_9_size = absolute(B_9) + pairs_5_size
    moved_0_bound = c2 * (moved_0_size + c1)
    moved_1_bound = c2 * (moved_1_size + c1)
    moved_2_bound = c2 * (moved_2_size + c1)
    Bo_4_bound = c3 * (Bo_4_size + c1)
    Bo_5_bound = c3 * (Bo_5_size + c1)
    Bo_6_bound = c3 * (Bo_6_size + c1)
    Bo_7_bound = c4 * (Bo_7_size + c1)
    Bo_8_bound = c4 * (Bo_8_size + c1)
    Bo_9_bound = c4 * (Bo_9_size + c1)
    return (B_0, moved_0, moved_1, moved_2, Bo_4, Bo_5, Bo_6, Bo_7, Bo_8, Bo_9, 0, moved_0_bound,
        moved_1_bound, moved_2_bound, Bo_4_bound, Bo_5_bound, Bo_6_bound, Bo_7_bound, Bo_8_bound,
        Bo_9_bound)


@kernel("(3,4),(10)->(10),(10)")
@errstate(all="ignore")
def spatial_inertia_transformed(D, B, *, c1=2.004168360008973e-292, c2=4.440892098500628e-16,
        c3=8.881784197001258e-16, c4=7.7715611723761e-16):
    """Bo = [Ad]*(D) B [Ad]^-1(D): B, given in the frame at D, in the reference frame; |error of
    Bo| <= Bo_bound unless inf or NaN.

    (3,4),(10)->(10),(10).  D: displacement [R | t], R rotation, t in m; B, Bo, Bo_bound:
    spatial inertia (m in kg; h = m c in kg m; I about the origin, xx, yy, zz, xy, xz, yz in kg
    m^2).
    114 mul, 135 add, 51 abs.
    """
    D_00, D_01, D_02, D_03, D_10, D_11, D_12, D_13, D_20, D_21, D_22, D_23 = D
    B_0, B_1, B_2, B_3, B_4, B_5, B_6, B_7, B_8, B_9 = B
    RI_0a = D_00 * B_4
    RI_0b = D_01 * B_7
    RI_0d = D_02 * B_8
    RI_0 = RI_0a + RI_0b + RI_0d
    RI_1a = D_00 * B_7
    RI_1b = D_01 * B_5
    RI_1d = D_02 * B_9
    RI_1 = RI_1a + RI_1b + RI_1d
    RI_2a = D_00 * B_8
    RI_2b = D_01 * B_9
    RI_2d = D_02 * B_6
    RI_2 = RI_2a + RI_2b + RI_2d
    RI_3a = D_10 * B_4
    RI_3b = D_11 * B_7
    RI_3d = D_12 * B_8
    RI_3 = RI_3a + RI_3b + RI_3d
    RI_4a = D_10 * B_7
    RI_4b = D_11 * B_5
    RI_4d = D_12 * B_9
    RI_4 = RI_4a + RI_4b + RI_4d
    RI_5a = D_10 * B_8
    RI_5b = D_11 * B_9
    RI_5d = D_12 * B_6
    RI_5 = RI_5a + RI_5b + RI_5d
    RI_6a = D_20 * B_4
    RI_6b = D_21 * B_7
    RI_6d = D_22 * B_8
    RI_6 = RI_6a + RI_6b + RI_6d
    RI_7a = D_20 * B_7
    RI_7b = D_21 * B_5
    RI_7d = D_22 * B_9
    RI_7 = RI_7a + RI_7b + RI_7d
    RI_8a = D_20 * B_8
    RI_8b = D_21 * B_9
    RI_8d = D_22 * B_6
    RI_8 = RI_8a + RI_8b + RI_8d
    turned_1a = D_00 * B_1
    turned_1b = D_01 * B_2
    turned_1d = D_02 * B_3
    turned_1 = turned_1a + turned_1b + turned_1d
    turned_2a = D_10 * B_1
    turned_2b = D_11 * B_2
    turned_2d = D_12 * B_3
    turned_2 = turned_2a + turned_2b + turned_2d
    turned_3a = D_20 * B_1
    turned_3b = D_21 * B_2
    turned_3d = D_22 * B_3
    turned_3 = turned_3a + turned_3b + turned_3d
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
    RI_0_size = absolute(RI_0a) + absolute(RI_0b) + absolute(RI_0d)
    RI_1_size = absolute(RI_1a) + absolute(RI_1b) + absolute(RI_1d)
    RI_2_size = absolute(RI_2a) + absolute(RI_2b) + absolute(RI_2d)
    RI_3_size = absolute(RI_3a) + absolute(RI_3b) + absolute(RI_3d)
    RI_4_size = absolute(RI_4a) + absolute(RI_4b) + absolute(RI_4d)
    RI_5_size = absolute(RI_5a) + absolute(RI_5b) + absolute(RI_5d)
    RI_6_size = absolute(RI_6a) + absolute(RI_6b) + absolute(RI_6d)
    RI_7_size = absolute(RI_7a) + absolute(RI_7b) + absolute(RI_7d)
    RI_8_size = absolute(RI_8a) + absolute(RI_8b) + absolute(RI_8d)
    turned_1_size = absolute(turned_1a) + absolute(turned_1b) + absolute(turned_1d)
    turned_2_size = absolute(turned_2a) + absolute(turned_2b) + absolute(turned_2d)
    turned_3_size = absolute(turned_3a) + absolute(turned_3b) + absolute(turned_3d)
    RI_0_padded = RI_0_size + c1
    RI_1_padded = RI_1_size + c1
    RI_2_padded = RI_2_size + c1
    turned_4_size = (absolute(D_00) * RI_0_padded + absolute(D_01) * RI_1_padded + absolute(D_02)
        * RI_2_padded)
    RI_3_padded = RI_3_size + c1
    D_10_abs = absolute(D_10)
    RI_4_padded = RI_4_size + c1
    D_11_abs = absolute(D_11)
    RI_5_padded = RI_5_size + c1
    D_12_abs = absolute(D_12)
    turned_5_size = D_10_abs * RI_3_padded + D_11_abs * RI_4_padded + D_12_abs * RI_5_padded
    D_20_abs = absolute(D_20)
    D_21_abs = absolute(D_21)
    D_22_abs = absolute(D_22)
    turned_6_size = (D_20_abs * (RI_6_size + c1) + D_21_abs * (RI_7_size + c1) + D_22_abs
        * (RI_8_size + c1))
    turned_7_size = D_10_abs * RI_0_padded + D_11_abs * RI_1_padded + D_12_abs * RI_2_padded
    turned_8_size = D_20_abs * RI_0_padded + D_21_abs * RI_1_padded + D_22_abs * RI_2_padded
    turned_9_size = D_20_abs * RI_3_padded + D_21_abs * RI_4_padded + D_22_abs * RI_5_padded
    mt_0_abs = absolute(mt_0)
    half_0_size = 0.5 * (mt_0_abs + c1)
    mt_1_abs = absolute(mt_1)
    half_1_size = 0.5 * (mt_1_abs + c1)
    mt_2_abs = absolute(mt_2)
    half_2_size = 0.5 * (mt_2_abs + c1)
    n_0_size = turned_1_size + half_0_size
    n_1_size = turned_2_size + half_1_size
    n_2_size = turned_3_size + half_2_size
    n_0_padded = n_0_size + c1
    D_03_abs = absolute(D_03)
    tn0_size = D_03_abs * n_0_padded
    n_1_padded = n_1_size + c1
    D_13_abs = absolute(D_13)
    tn1_size = D_13_abs * n_1_padded
    n_2_padded = n_2_size + c1
    D_23_abs = absolute(D_23)
    tn2_size = D_23_abs * n_2_padded
    own_0_size = 2 * (tn0_size + c1)
    own_1_size = 2 * (tn1_size + c1)
    own_2_size = 2 * (tn2_size + c1)
    pairs_0_size = own_1_size + own_2_size
    pairs_1_size = own_0_size + own_2_size
    pairs_2_size = own_0_size + own_1_size
    pairs_3_size = D_03_abs * n_1_padded + D_13_abs * n_0_padded
    pairs_4_size = D_03_abs * n_2_padded + D_23_abs * n_0_padded
    pairs_5_size = D_13_abs * n_2_padded + D_23_abs * n_1_padded
    moved_0_size = turned_1_size + mt_0_abs
    moved_1_size = turned_2_size + mt_1_abs
    moved_2_size = turned_3_size + mt_2_abs
    Bo_4_size = turned_4_size + pairs_0_size
    Bo_5_size = turned_5_size + pairs_1_size
    Bo_6_size = turned_6_size + pairs_2_size
    Bo_7_size = turned_7_size + pairs_3_size
    Bo_8_size = turned_8_size + pairs_4_size
    Bo_9_size = turned_9_size + pairs_5_size
    moved_0_bound = c2 * (moved_0_size + c1)
    moved_1_bound = c2 * (moved_1_size + c1)
    moved_2_bound = c2 * (moved_2_size + c1)
    Bo_4_bound = c3 * (Bo_4_size + c1)
    Bo_5_bound = c3 * (Bo_5_size + c1)
    Bo_6_bound = c3 * (Bo_6_size + c1)
    Bo_7_bound = c4 * (Bo_7_size + c1)
    Bo_8_bound = c4 * (Bo_8_size + c1)
    Bo_9_bound = c4 * (Bo_9_size + c1)
    return (B_0, moved_0, moved_1, moved_2, Bo_4, Bo_5, Bo_6, Bo_7, Bo_8, Bo_9, 0, moved_0_bound,
        moved_1_bound, moved_2_bound, Bo_4_bound, Bo_5_bound, Bo_6_bound, Bo_7_bound, Bo_8_bound,
        Bo_9_bound)
