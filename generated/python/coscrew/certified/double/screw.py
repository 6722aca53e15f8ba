# Made by `coscrew generate`; changes are overwritten.
# SPDX-License-Identifier: MIT
# coscrew 0.2.0.  Copyright (c) 2026 The coscrew authors.
"""Screws: twists, spatial velocities and accelerations, s = (v; ω).

In double precision, certified tier.
"""

from numpy import absolute
from coscrew._kernel import double_kernel as kernel
from numpy import errstate


@kernel("(6),()->(6),(6)")
@errstate(all="ignore")
def screw_scale(self, a, *, c1=2.004168360008973e-292, c2=1.1102230246251568e-16):
    """self = a self; |error of self| <= self_bound unless inf or NaN.

    (6),()->(6),(6).  self, self_bound: screw (v in m/s; ω in rad/s); a: number.
    12 mul, 6 add, 6 abs.
    """
    self_0, self_1, self_2, self_3, self_4, self_5 = self
    self_0_new = self_0 * a
    self_1_new = self_1 * a
    self_2_new = self_2 * a
    self_3_new = self_3 * a
    self_4_new = self_4 * a
    self_5_new = self_5 * a
    self_0_new_bound = c2 * (absolute(self_0_new) + c1)
    self_1_new_bound = c2 * (absolute(self_1_new) + c1)
    self_2_new_bound = c2 * (absolute(self_2_new) + c1)
    self_3_new_bound = c2 * (absolute(self_3_new) + c1)
    self_4_new_bound = c2 * (absolute(self_4_new) + c1)
    self_5_new_bound = c2 * (absolute(self_5_new) + c1)
    return (self_0_new, self_1_new, self_2_new, self_3_new, self_4_new, self_5_new,
        self_0_new_bound, self_1_new_bound, self_2_new_bound, self_3_new_bound, self_4_new_bound,
        self_5_new_bound)


@kernel("(),(6),(6)->(6),(6)")
@errstate(all="ignore")
def axpy_ss(a, x, y, *, c1=2.004168360008973e-292, c2=2.2204460492503136e-16):
    """y = a x + y; |error of y| <= y_bound unless inf or NaN.

    (),(6),(6)->(6),(6).  a: number; x, y, y_bound: screw (v in m/s; ω in rad/s).
    12 mul, 18 add, 12 abs.
    """
    x_0, x_1, x_2, x_3, x_4, x_5 = x
    y_0, y_1, y_2, y_3, y_4, y_5 = y
    y_0_new_a = a * x_0
    y_0_new = y_0_new_a + y_0
    y_1_new_a = a * x_1
    y_1_new = y_1_new_a + y_1
    y_2_new_a = a * x_2
    y_2_new = y_2_new_a + y_2
    y_3_new_a = a * x_3
    y_3_new = y_3_new_a + y_3
    y_4_new_a = a * x_4
    y_4_new = y_4_new_a + y_4
    y_5_new_a = a * x_5
    y_5_new = y_5_new_a + y_5
    y_0_new_size = absolute(y_0_new_a) + absolute(y_0)
    y_1_new_size = absolute(y_1_new_a) + absolute(y_1)
    y_2_new_size = absolute(y_2_new_a) + absolute(y_2)
    y_3_new_size = absolute(y_3_new_a) + absolute(y_3)
    y_4_new_size = absolute(y_4_new_a) + absolute(y_4)
    y_5_new_size = absolute(y_5_new_a) + absolute(y_5)
    y_0_new_bound = c2 * (y_0_new_size + c1)
    y_1_new_bound = c2 * (y_1_new_size + c1)
    y_2_new_bound = c2 * (y_2_new_size + c1)
    y_3_new_bound = c2 * (y_3_new_size + c1)
    y_4_new_bound = c2 * (y_4_new_size + c1)
    y_5_new_bound = c2 * (y_5_new_size + c1)
    return (y_0_new, y_1_new, y_2_new, y_3_new, y_4_new, y_5_new, y_0_new_bound, y_1_new_bound,
        y_2_new_bound, y_3_new_bound, y_4_new_bound, y_5_new_bound)


@kernel("(6),(6)->(6),(6)")
@errstate(all="ignore")
def xpy_ss(x, y, *, c1=1.1102230246251568e-16):
    """y = x + y; |error of y| <= y_bound unless inf or NaN.

    (6),(6)->(6),(6).  x, y, y_bound: screw (v in m/s; ω in rad/s).
    6 mul, 6 add, 6 abs.
    """
    x_0, x_1, x_2, x_3, x_4, x_5 = x
    y_0, y_1, y_2, y_3, y_4, y_5 = y
    y_0_new = x_0 + y_0
    y_1_new = x_1 + y_1
    y_2_new = x_2 + y_2
    y_3_new = x_3 + y_3
    y_4_new = x_4 + y_4
    y_5_new = x_5 + y_5
    y_0_new_bound = c1 * absolute(y_0_new)
    y_1_new_bound = c1 * absolute(y_1_new)
    y_2_new_bound = c1 * absolute(y_2_new)
    y_3_new_bound = c1 * absolute(y_3_new)
    y_4_new_bound = c1 * absolute(y_4_new)
    y_5_new_bound = c1 * absolute(y_5_new)
    return (y_0_new, y_1_new, y_2_new, y_3_new, y_4_new, y_5_new, y_0_new_bound, y_1_new_bound,
        y_2_new_bound, y_3_new_bound, y_4_new_bound, y_5_new_bound)


@kernel("(6),(6)->(6),(6)")
@errstate(all="ignore")
def nxpy_ss(x, y, *, c1=1.1102230246251568e-16):
    """y = -x + y; |error of y| <= y_bound unless inf or NaN.

    (6),(6)->(6),(6).  x, y, y_bound: screw (v in m/s; ω in rad/s).
    6 mul, 6 add, 6 abs.
    """
    x_0, x_1, x_2, x_3, x_4, x_5 = x
    y_0, y_1, y_2, y_3, y_4, y_5 = y
    y_0_new = y_0 - x_0
    y_1_new = y_1 - x_1
    y_2_new = y_2 - x_2
    y_3_new = y_3 - x_3
    y_4_new = y_4 - x_4
    y_5_new = y_5 - x_5
    y_0_new_bound = c1 * absolute(y_0_new)
    y_1_new_bound = c1 * absolute(y_1_new)
    y_2_new_bound = c1 * absolute(y_2_new)
    y_3_new_bound = c1 * absolute(y_3_new)
    y_4_new_bound = c1 * absolute(y_4_new)
    y_5_new_bound = c1 * absolute(y_5_new)
    return (y_0_new, y_1_new, y_2_new, y_3_new, y_4_new, y_5_new, y_0_new_bound, y_1_new_bound,
        y_2_new_bound, y_3_new_bound, y_4_new_bound, y_5_new_bound)


@kernel("(),(6)->(6),(6)")
@errstate(all="ignore")
def product_as(a, si, *, c1=2.004168360008973e-292, c2=1.1102230246251568e-16):
    """so = a si; |error of so| <= so_bound unless inf or NaN.

    (),(6)->(6),(6).  a: number; si, so, so_bound: screw (v in m/s; ω in rad/s).
    12 mul, 6 add, 6 abs.
    """
    si_0, si_1, si_2, si_3, si_4, si_5 = si
    so_0 = a * si_0
    so_1 = a * si_1
    so_2 = a * si_2
    so_3 = a * si_3
    so_4 = a * si_4
    so_5 = a * si_5
    so_0_bound = c2 * (absolute(so_0) + c1)
    so_1_bound = c2 * (absolute(so_1) + c1)
    so_2_bound = c2 * (absolute(so_2) + c1)
    so_3_bound = c2 * (absolute(so_3) + c1)
    so_4_bound = c2 * (absolute(so_4) + c1)
    so_5_bound = c2 * (absolute(so_5) + c1)
    return (so_0, so_1, so_2, so_3, so_4, so_5, so_0_bound, so_1_bound, so_2_bound, so_3_bound,
        so_4_bound, so_5_bound)


@kernel("(6),(6)->(6),(6)")
@errstate(all="ignore")
def add_ss(s1, s2, *, c1=1.1102230246251568e-16):
    """so = s1 + s2; |error of so| <= so_bound unless inf or NaN.

    (6),(6)->(6),(6).  s1, s2, so, so_bound: screw (v in m/s; ω in rad/s).
    6 mul, 6 add, 6 abs.
    """
    s1_0, s1_1, s1_2, s1_3, s1_4, s1_5 = s1
    s2_0, s2_1, s2_2, s2_3, s2_4, s2_5 = s2
    so_0 = s1_0 + s2_0
    so_1 = s1_1 + s2_1
    so_2 = s1_2 + s2_2
    so_3 = s1_3 + s2_3
    so_4 = s1_4 + s2_4
    so_5 = s1_5 + s2_5
    so_0_bound = c1 * absolute(so_0)
    so_1_bound = c1 * absolute(so_1)
    so_2_bound = c1 * absolute(so_2)
    so_3_bound = c1 * absolute(so_3)
    so_4_bound = c1 * absolute(so_4)
    so_5_bound = c1 * absolute(so_5)
    return (so_0, so_1, so_2, so_3, so_4, so_5, so_0_bound, so_1_bound, so_2_bound, so_3_bound,
        so_4_bound, so_5_bound)


@kernel("(6),(6)->(6),(6)")
@errstate(all="ignore")
def subtract_ss(s1, s2, *, c1=1.1102230246251568e-16):
    """so = s1 - s2; |error of so| <= so_bound unless inf or NaN.

    (6),(6)->(6),(6).  s1, s2, so, so_bound: screw (v in m/s; ω in rad/s).
    6 mul, 6 add, 6 abs.
    """
    s1_0, s1_1, s1_2, s1_3, s1_4, s1_5 = s1
    s2_0, s2_1, s2_2, s2_3, s2_4, s2_5 = s2
    so_0 = s1_0 - s2_0
    so_1 = s1_1 - s2_1
    so_2 = s1_2 - s2_2
    so_3 = s1_3 - s2_3
    so_4 = s1_4 - s2_4
    so_5 = s1_5 - s2_5
    so_0_bound = c1 * absolute(so_0)
    so_1_bound = c1 * absolute(so_1)
    so_2_bound = c1 * absolute(so_2)
    so_3_bound = c1 * absolute(so_3)
    so_4_bound = c1 * absolute(so_4)
    so_5_bound = c1 * absolute(so_5)
    return (so_0, so_1, so_2, so_3, so_4, so_5, so_0_bound, so_1_bound, so_2_bound, so_3_bound,
        so_4_bound, so_5_bound)


@kernel("(6),(6)->(6),(6)")
@errstate(all="ignore")
def add_sst(s1, s2, *, c1=1.1102230246251568e-16):
    """so = (s1.lin + s2.lin ; s1.ang); |error of so| <= so_bound unless inf or NaN.

    (6),(6)->(6),(6).  s1, s2, so, so_bound: screw (v in m/s; ω in rad/s).
    3 mul, 3 add, 3 abs.
    """
    s1_0, s1_1, s1_2, s1_3, s1_4, s1_5 = s1
    s2_0, s2_1, s2_2, s2_3, s2_4, s2_5 = s2
    so_0 = s1_0 + s2_0
    so_1 = s1_1 + s2_1
    so_2 = s1_2 + s2_2
    so_0_bound = c1 * absolute(so_0)
    so_1_bound = c1 * absolute(so_1)
    so_2_bound = c1 * absolute(so_2)
    return (so_0, so_1, so_2, s1_3, s1_4, s1_5, so_0_bound, so_1_bound, so_2_bound, 0, 0, 0)


@kernel("(3),(6)->(6),(6)")
@errstate(all="ignore")
def product_Adts(t, si, *, c1=2.004168360008973e-292, c2=3.3306690738754706e-16):
    """so = [Ad](t) si; |error of so| <= so_bound unless inf or NaN.

    (3),(6)->(6),(6).  t: vector; si, so, so_bound: screw (v in m/s; ω in rad/s).
    9 mul, 15 add, 9 abs.
    """
    t_0, t_1, t_2 = t
    si_0, si_1, si_2, si_3, si_4, si_5 = si
    so_0a = t_1 * si_5
    so_0b = t_2 * si_4
    so_0 = so_0a - so_0b + si_0
    so_1a = t_2 * si_3
    so_1b = t_0 * si_5
    so_1 = so_1a - so_1b + si_1
    so_2a = t_0 * si_4
    so_2b = t_1 * si_3
    so_2 = so_2a - so_2b + si_2
    so_0_size = absolute(so_0a) + absolute(so_0b) + absolute(si_0)
    so_1_size = absolute(so_1a) + absolute(so_1b) + absolute(si_1)
    so_2_size = absolute(so_2a) + absolute(so_2b) + absolute(si_2)
    so_0_bound = c2 * (so_0_size + c1)
    so_1_bound = c2 * (so_1_size + c1)
    so_2_bound = c2 * (so_2_size + c1)
    return (so_0, so_1, so_2, si_3, si_4, si_5, so_0_bound, so_1_bound, so_2_bound, 0, 0, 0)


@kernel("(3),(6)->(6),(6)")
@errstate(all="ignore")
def product_Adtinvs(t, si, *, c1=2.004168360008973e-292, c2=3.3306690738754706e-16):
    """so = [Ad](t)^-1 si; |error of so| <= so_bound unless inf or NaN.

    (3),(6)->(6),(6).  t: vector; si, so, so_bound: screw (v in m/s; ω in rad/s).
    9 mul, 15 add, 9 abs.
    """
    t_0, t_1, t_2 = t
    si_0, si_1, si_2, si_3, si_4, si_5 = si
    so_0a = t_2 * si_4
    so_0b = t_1 * si_5
    so_0 = so_0a - so_0b + si_0
    so_1a = t_0 * si_5
    so_1b = t_2 * si_3
    so_1 = so_1a - so_1b + si_1
    so_2a = t_1 * si_3
    so_2b = t_0 * si_4
    so_2 = so_2a - so_2b + si_2
    so_0_size = absolute(so_0a) + absolute(so_0b) + absolute(si_0)
    so_1_size = absolute(so_1a) + absolute(so_1b) + absolute(si_1)
    so_2_size = absolute(so_2a) + absolute(so_2b) + absolute(si_2)
    so_0_bound = c2 * (so_0_size + c1)
    so_1_bound = c2 * (so_1_size + c1)
    so_2_bound = c2 * (so_2_size + c1)
    return (so_0, so_1, so_2, si_3, si_4, si_5, so_0_bound, so_1_bound, so_2_bound, 0, 0, 0)


@kernel("(3),(6)->(6),(6)")
@errstate(all="ignore")
def product_Adtsinv(t, si, *, c1=2.004168360008973e-292, c2=3.3306690738754706e-16):
    """so = [Ad](t) (-si); |error of so| <= so_bound unless inf or NaN.

    (3),(6)->(6),(6).  t: vector; si, so, so_bound: screw (v in m/s; ω in rad/s).
    9 mul, 15 add, 3 neg, 9 abs.
    """
    t_0, t_1, t_2 = t
    si_0, si_1, si_2, si_3, si_4, si_5 = si
    so_0a = t_2 * si_4
    so_0b = t_1 * si_5
    so_0 = so_0a - so_0b - si_0
    so_1a = t_0 * si_5
    so_1b = t_2 * si_3
    so_1 = so_1a - so_1b - si_1
    so_2a = t_1 * si_3
    so_2b = t_0 * si_4
    so_2 = so_2a - so_2b - si_2
    so_3 = -si_3
    so_4 = -si_4
    so_5 = -si_5
    so_0_size = absolute(so_0a) + absolute(so_0b) + absolute(si_0)
    so_1_size = absolute(so_1a) + absolute(so_1b) + absolute(si_1)
    so_2_size = absolute(so_2a) + absolute(so_2b) + absolute(si_2)
    so_0_bound = c2 * (so_0_size + c1)
    so_1_bound = c2 * (so_1_size + c1)
    so_2_bound = c2 * (so_2_size + c1)
    return (so_0, so_1, so_2, so_3, so_4, so_5, so_0_bound, so_1_bound, so_2_bound, 0, 0, 0)


@kernel("(3,3),(6)->(6),(6)")
@errstate(all="ignore")
def product_Adrs(R, si, *, c1=2.004168360008973e-292, c2=3.3306690738754706e-16):
    """so = [Ad](R) si; |error of so| <= so_bound unless inf or NaN.

    (3,3),(6)->(6),(6).  R: rotation or other 3×3 matrix; si, so, so_bound: screw (v in m/s; ω
    in rad/s).
    24 mul, 30 add, 18 abs.
    """
    R_00, R_01, R_02, R_10, R_11, R_12, R_20, R_21, R_22 = R
    si_0, si_1, si_2, si_3, si_4, si_5 = si
    so_0a = R_00 * si_0
    so_0b = R_01 * si_1
    so_0d = R_02 * si_2
    so_0 = so_0a + so_0b + so_0d
    so_1a = R_10 * si_0
    so_1b = R_11 * si_1
    so_1d = R_12 * si_2
    so_1 = so_1a + so_1b + so_1d
    so_2a = R_20 * si_0
    so_2b = R_21 * si_1
    so_2d = R_22 * si_2
    so_2 = so_2a + so_2b + so_2d
    so_3a = R_00 * si_3
    so_3b = R_01 * si_4
    so_3d = R_02 * si_5
    so_3 = so_3a + so_3b + so_3d
    so_4a = R_10 * si_3
    so_4b = R_11 * si_4
    so_4d = R_12 * si_5
    so_4 = so_4a + so_4b + so_4d
    so_5a = R_20 * si_3
    so_5b = R_21 * si_4
    so_5d = R_22 * si_5
    so_5 = so_5a + so_5b + so_5d
    so_0_size = absolute(so_0a) + absolute(so_0b) + absolute(so_0d)
    so_1_size = absolute(so_1a) + absolute(so_1b) + absolute(so_1d)
    so_2_size = absolute(so_2a) + absolute(so_2b) + absolute(so_2d)
    so_3_size = absolute(so_3a) + absolute(so_3b) + absolute(so_3d)
    so_4_size = absolute(so_4a) + absolute(so_4b) + absolute(so_4d)
    so_5_size = absolute(so_5a) + absolute(so_5b) + absolute(so_5d)
    so_0_bound = c2 * (so_0_size + c1)
    so_1_bound = c2 * (so_1_size + c1)
    so_2_bound = c2 * (so_2_size + c1)
    so_3_bound = c2 * (so_3_size + c1)
    so_4_bound = c2 * (so_4_size + c1)
    so_5_bound = c2 * (so_5_size + c1)
    return (so_0, so_1, so_2, so_3, so_4, so_5, so_0_bound, so_1_bound, so_2_bound, so_3_bound,
        so_4_bound, so_5_bound)


@kernel("(3,3),(6)->(6),(6)")
@errstate(all="ignore")
def product_Adrinvs(R, si, *, c1=2.004168360008973e-292, c2=3.3306690738754706e-16):
    """so = [Ad](R)^-1 si; |error of so| <= so_bound unless inf or NaN.

    (3,3),(6)->(6),(6).  R: rotation or other 3×3 matrix; si, so, so_bound: screw (v in m/s; ω
    in rad/s).
    24 mul, 30 add, 18 abs.
    """
    R_00, R_01, R_02, R_10, R_11, R_12, R_20, R_21, R_22 = R
    si_0, si_1, si_2, si_3, si_4, si_5 = si
    so_0a = R_00 * si_0
    so_0b = R_10 * si_1
    so_0d = R_20 * si_2
    so_0 = so_0a + so_0b + so_0d
    so_1a = R_01 * si_0
    so_1b = R_11 * si_1
    so_1d = R_21 * si_2
    so_1 = so_1a + so_1b + so_1d
    so_2a = R_02 * si_0
    so_2b = R_12 * si_1
    so_2d = R_22 * si_2
    so_2 = so_2a + so_2b + so_2d
    so_3a = R_00 * si_3
    so_3b = R_10 * si_4
    so_3d = R_20 * si_5
    so_3 = so_3a + so_3b + so_3d
    so_4a = R_01 * si_3
    so_4b = R_11 * si_4
    so_4d = R_21 * si_5
    so_4 = so_4a + so_4b + so_4d
    so_5a = R_02 * si_3
    so_5b = R_12 * si_4
    so_5d = R_22 * si_5
    so_5 = so_5a + so_5b + so_5d
    so_0_size = absolute(so_0a) + absolute(so_0b) + absolute(so_0d)
    so_1_size = absolute(so_1a) + absolute(so_1b) + absolute(so_1d)
    so_2_size = absolute(so_2a) + absolute(so_2b) + absolute(so_2d)
    so_3_size = absolute(so_3a) + absolute(so_3b) + absolute(so_3d)
    so_4_size = absolute(so_4a) + absolute(so_4b) + absolute(so_4d)
    so_5_size = absolute(so_5a) + absolute(so_5b) + absolute(so_5d)
    so_0_bound = c2 * (so_0_size + c1)
    so_1_bound = c2 * (so_1_size + c1)
    so_2_bound = c2 * (so_2_size + c1)
    so_3_bound = c2 * (so_3_size + c1)
    so_4_bound = c2 * (so_4_size + c1)
    so_5_bound = c2 * (so_5_size + c1)
    return (so_0, so_1, so_2, so_3, so_4, so_5, so_0_bound, so_1_bound, so_2_bound, so_3_bound,
        so_4_bound, so_5_bound)


@kernel("(3,3),(6)->(6),(6)")
@errstate(all="ignore")
def product_Adrsinv(R, si, *, c1=2.004168360008973e-292, c2=3.3306690738754706e-16):
    """so = [Ad](R) (-si); |error of so| <= so_bound unless inf or NaN.

    (3,3),(6)->(6),(6).  R: rotation or other 3×3 matrix; si, so, so_bound: screw (v in m/s; ω
    in rad/s).
    24 mul, 30 add, 6 neg, 18 abs.
    """
    R_00, R_01, R_02, R_10, R_11, R_12, R_20, R_21, R_22 = R
    si_0, si_1, si_2, si_3, si_4, si_5 = si
    so_0a = R_00 * si_0
    so_0b = R_01 * si_1
    so_0d = R_02 * si_2
    so_0 = -(so_0a + so_0b + so_0d)
    so_1a = R_10 * si_0
    so_1b = R_11 * si_1
    so_1d = R_12 * si_2
    so_1 = -(so_1a + so_1b + so_1d)
    so_2a = R_20 * si_0
    so_2b = R_21 * si_1
    so_2d = R_22 * si_2
    so_2 = -(so_2a + so_2b + so_2d)
    so_3a = R_00 * si_3
    so_3b = R_01 * si_4
    so_3d = R_02 * si_5
    so_3 = -(so_3a + so_3b + so_3d)
    so_4a = R_10 * si_3
    so_4b = R_11 * si_4
    so_4d = R_12 * si_5
    so_4 = -(so_4a + so_4b + so_4d)
    so_5a = R_20 * si_3
    so_5b = R_21 * si_4
    so_5d = R_22 * si_5
    so_5 = -(so_5a + so_5b + so_5d)
    so_0e_bound = c2 * (absolute(so_0a) + absolute(so_0b) + absolute(so_0d) + c1)
    so_1e_bound = c2 * (absolute(so_1a) + absolute(so_1b) + absolute(so_1d) + c1)
    so_2e_bound = c2 * (absolute(so_2a) + absolute(so_2b) + absolute(so_2d) + c1)
    so_3e_bound = c2 * (absolute(so_3a) + absolute(so_3b) + absolute(so_3d) + c1)
    so_4e_bound = c2 * (absolute(so_4a) + absolute(so_4b) + absolute(so_4d) + c1)
    so_5e_bound = c2 * (absolute(so_5a) + absolute(so_5b) + absolute(so_5d) + c1)
    return (so_0, so_1, so_2, so_3, so_4, so_5, so_0e_bound, so_1e_bound, so_2e_bound, so_3e_bound,
        so_4e_bound, so_5e_bound)


@kernel("(3,4),(6)->(6),(6)")
@errstate(all="ignore")
def product_Ads(D, si, *, c1=2.004168360008973e-292, c2=6.661338147750942e-16,
        c3=3.3306690738754706e-16):
    """so = [Ad](D) si = [Ad](t) [Ad](R) si; |error of so| <= so_bound unless inf or NaN.

    (3,4),(6)->(6),(6).  D: displacement [R | t], R rotation, t in m; si, so, so_bound: screw (v
    in m/s; ω in rad/s).
    36 mul, 42 add, 21 abs.
    """
    D_00, D_01, D_02, D_03, D_10, D_11, D_12, D_13, D_20, D_21, D_22, D_23 = D
    si_0, si_1, si_2, si_3, si_4, si_5 = si
    w_0a = D_00 * si_0
    w_0b = D_01 * si_1
    w_0d = D_02 * si_2
    w_0 = w_0a + w_0b + w_0d
    w_1a = D_10 * si_0
    w_1b = D_11 * si_1
    w_1d = D_12 * si_2
    w_1 = w_1a + w_1b + w_1d
    w_2a = D_20 * si_0
    w_2b = D_21 * si_1
    w_2d = D_22 * si_2
    w_2 = w_2a + w_2b + w_2d
    w_3a = D_00 * si_3
    w_3b = D_01 * si_4
    w_3d = D_02 * si_5
    w_3 = w_3a + w_3b + w_3d
    w_4a = D_10 * si_3
    w_4b = D_11 * si_4
    w_4d = D_12 * si_5
    w_4 = w_4a + w_4b + w_4d
    w_5a = D_20 * si_3
    w_5b = D_21 * si_4
    w_5d = D_22 * si_5
    w_5 = w_5a + w_5b + w_5d
    so_0 = D_13 * w_5 - D_23 * w_4 + w_0
    so_1 = D_23 * w_3 - D_03 * w_5 + w_1
    so_2 = D_03 * w_4 - D_13 * w_3 + w_2
    w_0_size = absolute(w_0a) + absolute(w_0b) + absolute(w_0d)
    w_1_size = absolute(w_1a) + absolute(w_1b) + absolute(w_1d)
    w_2_size = absolute(w_2a) + absolute(w_2b) + absolute(w_2d)
    w_3_size = absolute(w_3a) + absolute(w_3b) + absolute(w_3d)
    w_4_size = absolute(w_4a) + absolute(w_4b) + absolute(w_4d)
    w_5_size = absolute(w_5a) + absolute(w_5b) + absolute(w_5d)
    w_5_padded = w_5_size + c1
    D_13_abs = absolute(D_13)
    w_4_padded = w_4_size + c1
    D_23_abs = absolute(D_23)
    so_0_size = D_13_abs * w_5_padded + D_23_abs * w_4_padded + w_0_size
    w_3_padded = w_3_size + c1
    D_03_abs = absolute(D_03)
    so_1_size = D_23_abs * w_3_padded + D_03_abs * w_5_padded + w_1_size
    so_2_size = D_03_abs * w_4_padded + D_13_abs * w_3_padded + w_2_size
    so_0_bound = c2 * (so_0_size + c1)
    so_1_bound = c2 * (so_1_size + c1)
    so_2_bound = c2 * (so_2_size + c1)
    w_3_bound = c3 * w_3_padded
    w_4_bound = c3 * w_4_padded
    w_5_bound = c3 * w_5_padded
    return (so_0, so_1, so_2, w_3, w_4, w_5, so_0_bound, so_1_bound, so_2_bound, w_3_bound,
        w_4_bound, w_5_bound)


@kernel("(3,4),(6)->(6),(6)")
@errstate(all="ignore")
def product_Adinvs(D, si, *, c1=2.004168360008973e-292, c2=6.661338147750942e-16,
        c3=3.3306690738754706e-16):
    """so = [Ad](D)^-1 si = [Ad](R^T) [Ad](-t) si; |error of so| <= so_bound unless inf or NaN.

    (3,4),(6)->(6),(6).  D: displacement [R | t], R rotation, t in m; si, so, so_bound: screw (v
    in m/s; ω in rad/s).
    39 mul, 45 add, 27 abs.
    """
    D_00, D_01, D_02, D_03, D_10, D_11, D_12, D_13, D_20, D_21, D_22, D_23 = D
    si_0, si_1, si_2, si_3, si_4, si_5 = si
    w_0a = D_23 * si_4
    w_0b = D_13 * si_5
    w_0 = w_0a - w_0b + si_0
    w_1a = D_03 * si_5
    w_1b = D_23 * si_3
    w_1 = w_1a - w_1b + si_1
    w_2a = D_13 * si_3
    w_2b = D_03 * si_4
    w_2 = w_2a - w_2b + si_2
    so_0 = D_00 * w_0 + D_10 * w_1 + D_20 * w_2
    so_1 = D_01 * w_0 + D_11 * w_1 + D_21 * w_2
    so_2 = D_02 * w_0 + D_12 * w_1 + D_22 * w_2
    so_3a = D_00 * si_3
    so_3b = D_10 * si_4
    so_3d = D_20 * si_5
    so_3 = so_3a + so_3b + so_3d
    so_4a = D_01 * si_3
    so_4b = D_11 * si_4
    so_4d = D_21 * si_5
    so_4 = so_4a + so_4b + so_4d
    so_5a = D_02 * si_3
    so_5b = D_12 * si_4
    so_5d = D_22 * si_5
    so_5 = so_5a + so_5b + so_5d
    w_0_size = absolute(w_0a) + absolute(w_0b) + absolute(si_0)
    w_1_size = absolute(w_1a) + absolute(w_1b) + absolute(si_1)
    w_2_size = absolute(w_2a) + absolute(w_2b) + absolute(si_2)
    w_0_padded = w_0_size + c1
    w_1_padded = w_1_size + c1
    w_2_padded = w_2_size + c1
    so_0_size = (absolute(D_00) * w_0_padded + absolute(D_10) * w_1_padded + absolute(D_20)
        * w_2_padded)
    so_1_size = (absolute(D_01) * w_0_padded + absolute(D_11) * w_1_padded + absolute(D_21)
        * w_2_padded)
    so_2_size = (absolute(D_02) * w_0_padded + absolute(D_12) * w_1_padded + absolute(D_22)
        * w_2_padded)
    so_3_size = absolute(so_3a) + absolute(so_3b) + absolute(so_3d)
    so_4_size = absolute(so_4a) + absolute(so_4b) + absolute(so_4d)
    so_5_size = absolute(so_5a) + absolute(so_5b) + absolute(so_5d)
    so_0_bound = c2 * (so_0_size + c1)
    so_1_bound = c2 * (so_1_size + c1)
    so_2_bound = c2 * (so_2_size + c1)
    so_3_bound = c3 * (so_3_size + c1)
    so_4_bound = c3 * (so_4_size + c1)
    so_5_bound = c3 * (so_5_size + c1)
    return (so_0, so_1, so_2, so_3, so_4, so_5, so_0_bound, so_1_bound, so_2_bound, so_3_bound,
        so_4_bound, so_5_bound)


@kernel("(3,4),(6)->(6),(6)")
@errstate(all="ignore")
def product_Adsinv(D, si, *, c1=2.004168360008973e-292, c2=6.661338147750942e-16,
        c3=3.3306690738754706e-16):
    """so = [Ad](D) (-si); |error of so| <= so_bound unless inf or NaN.

    (3,4),(6)->(6),(6).  D: displacement [R | t], R rotation, t in m; si, so, so_bound: screw (v
    in m/s; ω in rad/s).
    36 mul, 42 add, 6 neg, 21 abs.
    """
    D_00, D_01, D_02, D_03, D_10, D_11, D_12, D_13, D_20, D_21, D_22, D_23 = D
    si_0, si_1, si_2, si_3, si_4, si_5 = si
    w_0a = D_00 * si_0
    w_0b = D_01 * si_1
    w_0d = D_02 * si_2
    w_0 = -(w_0a + w_0b + w_0d)
    w_1a = D_10 * si_0
    w_1b = D_11 * si_1
    w_1d = D_12 * si_2
    w_1 = -(w_1a + w_1b + w_1d)
    w_2a = D_20 * si_0
    w_2b = D_21 * si_1
    w_2d = D_22 * si_2
    w_2 = -(w_2a + w_2b + w_2d)
    w_3a = D_00 * si_3
    w_3b = D_01 * si_4
    w_3d = D_02 * si_5
    w_3 = -(w_3a + w_3b + w_3d)
    w_4a = D_10 * si_3
    w_4b = D_11 * si_4
    w_4d = D_12 * si_5
    w_4 = -(w_4a + w_4b + w_4d)
    w_5a = D_20 * si_3
    w_5b = D_21 * si_4
    w_5d = D_22 * si_5
    w_5 = -(w_5a + w_5b + w_5d)
    so_0 = D_13 * w_5 - D_23 * w_4 + w_0
    so_1 = D_23 * w_3 - D_03 * w_5 + w_1
    so_2 = D_03 * w_4 - D_13 * w_3 + w_2
    w_5e_padded = absolute(w_5a) + absolute(w_5b) + absolute(w_5d) + c1
    D_13_abs = absolute(D_13)
    w_4e_padded = absolute(w_4a) + absolute(w_4b) + absolute(w_4d) + c1
    D_23_abs = absolute(D_23)
    so_0_size = (D_13_abs * w_5e_padded + D_23_abs * w_4e_padded
        + (absolute(w_0a) + absolute(w_0b) + absolute(w_0d)))
    w_3e_padded = absolute(w_3a) + absolute(w_3b) + absolute(w_3d) + c1
    D_03_abs = absolute(D_03)
    so_1_size = (D_23_abs * w_3e_padded + D_03_abs * w_5e_padded
        + (absolute(w_1a) + absolute(w_1b) + absolute(w_1d)))
    so_2_size = (D_03_abs * w_4e_padded + D_13_abs * w_3e_padded
        + (absolute(w_2a) + absolute(w_2b) + absolute(w_2d)))
    so_0_bound = c2 * (so_0_size + c1)
    so_1_bound = c2 * (so_1_size + c1)
    so_2_bound = c2 * (so_2_size + c1)
    w_3e_bound = c3 * w_3e_padded
    w_4e_bound = c3 * w_4e_padded
    w_5e_bound = c3 * w_5e_padded
    return (so_0, so_1, so_2, w_3, w_4, w_5, so_0_bound, so_1_bound, so_2_bound, w_3e_bound,
        w_4e_bound, w_5e_bound)


@kernel("(3,4)->(6),(6)")
@errstate(all="ignore")
def hsrx(D, *, c1=2.004168360008973e-292, c2=2.2204460492503136e-16):
    """so = h_rx: column 3 of [Ad](D); |error of so| <= so_bound unless inf or NaN.

    (3,4)->(6),(6).  D: displacement [R | t], R rotation, t in m; so, so_bound: screw (v in m/s;
    ω in rad/s).
    9 mul, 9 add, 6 abs.
    """
    D_00, D_01, D_02, D_03, D_10, D_11, D_12, D_13, D_20, D_21, D_22, D_23 = D
    so_0a = D_20 * D_13
    so_0b = D_10 * D_23
    so_0 = so_0a - so_0b
    so_1a = D_00 * D_23
    so_1b = D_20 * D_03
    so_1 = so_1a - so_1b
    so_2a = D_10 * D_03
    so_2b = D_00 * D_13
    so_2 = so_2a - so_2b
    so_0_size = absolute(so_0a) + absolute(so_0b)
    so_1_size = absolute(so_1a) + absolute(so_1b)
    so_2_size = absolute(so_2a) + absolute(so_2b)
    so_0_bound = c2 * (so_0_size + c1)
    so_1_bound = c2 * (so_1_size + c1)
    so_2_bound = c2 * (so_2_size + c1)
    return (so_0, so_1, so_2, D_00, D_10, D_20, so_0_bound, so_1_bound, so_2_bound, 0, 0, 0)


@kernel("(3,4)->(6),(6)")
@errstate(all="ignore")
def hsry(D, *, c1=2.004168360008973e-292, c2=2.2204460492503136e-16):
    """so = h_ry: column 4 of [Ad](D); |error of so| <= so_bound unless inf or NaN.

    (3,4)->(6),(6).  D: displacement [R | t], R rotation, t in m; so, so_bound: screw (v in m/s;
    ω in rad/s).
    9 mul, 9 add, 6 abs.
    """
    D_00, D_01, D_02, D_03, D_10, D_11, D_12, D_13, D_20, D_21, D_22, D_23 = D
    so_0a = D_21 * D_13
    so_0b = D_11 * D_23
    so_0 = so_0a - so_0b
    so_1a = D_01 * D_23
    so_1b = D_21 * D_03
    so_1 = so_1a - so_1b
    so_2a = D_11 * D_03
    so_2b = D_01 * D_13
    so_2 = so_2a - so_2b
    so_0_size = absolute(so_0a) + absolute(so_0b)
    so_1_size = absolute(so_1a) + absolute(so_1b)
    so_2_size = absolute(so_2a) + absolute(so_2b)
    so_0_bound = c2 * (so_0_size + c1)
    so_1_bound = c2 * (so_1_size + c1)
    so_2_bound = c2 * (so_2_size + c1)
    return (so_0, so_1, so_2, D_01, D_11, D_21, so_0_bound, so_1_bound, so_2_bound, 0, 0, 0)


@kernel("(3,4)->(6),(6)")
@errstate(all="ignore")
def hsrz(D, *, c1=2.004168360008973e-292, c2=2.2204460492503136e-16):
    """so = h_rz: column 5 of [Ad](D); |error of so| <= so_bound unless inf or NaN.

    (3,4)->(6),(6).  D: displacement [R | t], R rotation, t in m; so, so_bound: screw (v in m/s;
    ω in rad/s).
    9 mul, 9 add, 6 abs.
    """
    D_00, D_01, D_02, D_03, D_10, D_11, D_12, D_13, D_20, D_21, D_22, D_23 = D
    so_0a = D_22 * D_13
    so_0b = D_12 * D_23
    so_0 = so_0a - so_0b
    so_1a = D_02 * D_23
    so_1b = D_22 * D_03
    so_1 = so_1a - so_1b
    so_2a = D_12 * D_03
    so_2b = D_02 * D_13
    so_2 = so_2a - so_2b
    so_0_size = absolute(so_0a) + absolute(so_0b)
    so_1_size = absolute(so_1a) + absolute(so_1b)
    so_2_size = absolute(so_2a) + absolute(so_2b)
    so_0_bound = c2 * (so_0_size + c1)
    so_1_bound = c2 * (so_1_size + c1)
    so_2_bound = c2 * (so_2_size + c1)
    return (so_0, so_1, so_2, D_02, D_12, D_22, so_0_bound, so_1_bound, so_2_bound, 0, 0, 0)


@kernel("(3,4)->(6),(6)")
@errstate(all="ignore")
def hsrxinv(D, *, c1=2.004168360008973e-292, c2=2.2204460492503136e-16):
    """so = -h_rx: -column 3 of [Ad](D); |error of so| <= so_bound unless inf or NaN.

    (3,4)->(6),(6).  D: displacement [R | t], R rotation, t in m; so, so_bound: screw (v in m/s;
    ω in rad/s).
    9 mul, 9 add, 3 neg, 6 abs.
    """
    D_00, D_01, D_02, D_03, D_10, D_11, D_12, D_13, D_20, D_21, D_22, D_23 = D
    so_0a = D_10 * D_23
    so_0b = D_20 * D_13
    so_0 = so_0a - so_0b
    so_1a = D_20 * D_03
    so_1b = D_00 * D_23
    so_1 = so_1a - so_1b
    so_2a = D_00 * D_13
    so_2b = D_10 * D_03
    so_2 = so_2a - so_2b
    so_3 = -D_00
    so_4 = -D_10
    so_5 = -D_20
    so_0_size = absolute(so_0a) + absolute(so_0b)
    so_1_size = absolute(so_1a) + absolute(so_1b)
    so_2_size = absolute(so_2a) + absolute(so_2b)
    so_0_bound = c2 * (so_0_size + c1)
    so_1_bound = c2 * (so_1_size + c1)
    so_2_bound = c2 * (so_2_size + c1)
    return (so_0, so_1, so_2, so_3, so_4, so_5, so_0_bound, so_1_bound, so_2_bound, 0, 0, 0)


@kernel("(3,4)->(6),(6)")
@errstate(all="ignore")
def hsryinv(D, *, c1=2.004168360008973e-292, c2=2.2204460492503136e-16):
    """so = -h_ry: -column 4 of [Ad](D); |error of so| <= so_bound unless inf or NaN.

    (3,4)->(6),(6).  D: displacement [R | t], R rotation, t in m; so, so_bound: screw (v in m/s;
    ω in rad/s).
    9 mul, 9 add, 3 neg, 6 abs.
    """
    D_00, D_01, D_02, D_03, D_10, D_11, D_12, D_13, D_20, D_21, D_22, D_23 = D
    so_0a = D_11 * D_23
    so_0b = D_21 * D_13
    so_0 = so_0a - so_0b
    so_1a = D_21 * D_03
    so_1b = D_01 * D_23
    so_1 = so_1a - so_1b
    so_2a = D_01 * D_13
    so_2b = D_11 * D_03
    so_2 = so_2a - so_2b
    so_3 = -D_01
    so_4 = -D_11
    so_5 = -D_21
    so_0_size = absolute(so_0a) + absolute(so_0b)
    so_1_size = absolute(so_1a) + absolute(so_1b)
    so_2_size = absolute(so_2a) + absolute(so_2b)
    so_0_bound = c2 * (so_0_size + c1)
    so_1_bound = c2 * (so_1_size + c1)
    so_2_bound = c2 * (so_2_size + c1)
    return (so_0, so_1, so_2, so_3, so_4, so_5, so_0_bound, so_1_bound, so_2_bound, 0, 0, 0)


@kernel("(3,4)->(6),(6)")
@errstate(all="ignore")
def hsrzinv(D, *, c1=2.004168360008973e-292, c2=2.2204460492503136e-16):
    """so = -h_rz: -column 5 of [Ad](D); |error of so| <= so_bound unless inf or NaN.

    (3,4)->(6),(6).  D: displacement [R | t], R rotation, t in m; so, so_bound: screw (v in m/s;
    ω in rad/s).
    9 mul, 9 add, 3 neg, 6 abs.
    """
    D_00, D_01, D_02, D_03, D_10, D_11, D_12, D_13, D_20, D_21, D_22, D_23 = D
    so_0a = D_12 * D_23
    so_0b = D_22 * D_13
    so_0 = so_0a - so_0b
    so_1a = D_22 * D_03
    so_1b = D_02 * D_23
    so_1 = so_1a - so_1b
    so_2a = D_02 * D_13
    so_2b = D_12 * D_03
    so_2 = so_2a - so_2b
    so_3 = -D_02
    so_4 = -D_12
    so_5 = -D_22
    so_0_size = absolute(so_0a) + absolute(so_0b)
    so_1_size = absolute(so_1a) + absolute(so_1b)
    so_2_size = absolute(so_2a) + absolute(so_2b)
    so_0_bound = c2 * (so_0_size + c1)
    so_1_bound = c2 * (so_1_size + c1)
    so_2_bound = c2 * (so_2_size + c1)
    return (so_0, so_1, so_2, so_3, so_4, so_5, so_0_bound, so_1_bound, so_2_bound, 0, 0, 0)


@kernel("(3,4)->(6,6),(6,6)")
@errstate(all="ignore")
def Ad(D, *, c1=2.004168360008973e-292, c2=2.2204460492503136e-16):
    """M = [Ad](D); |error of M| <= M_bound unless inf or NaN.

    (3,4)->(6,6),(6,6).  D: displacement [R | t], R rotation, t in m; M, M_bound: 6×6 operator.
    27 mul, 27 add, 18 abs.
    """
    D_00, D_01, D_02, D_03, D_10, D_11, D_12, D_13, D_20, D_21, D_22, D_23 = D
    M_03a = D_20 * D_13
    M_03b = D_10 * D_23
    M_03 = M_03a - M_03b
    M_04a = D_21 * D_13
    M_04b = D_11 * D_23
    M_04 = M_04a - M_04b
    M_05a = D_22 * D_13
    M_05b = D_12 * D_23
    M_05 = M_05a - M_05b
    M_13a = D_00 * D_23
    M_13b = D_20 * D_03
    M_13 = M_13a - M_13b
    M_14a = D_01 * D_23
    M_14b = D_21 * D_03
    M_14 = M_14a - M_14b
    M_15a = D_02 * D_23
    M_15b = D_22 * D_03
    M_15 = M_15a - M_15b
    M_23a = D_10 * D_03
    M_23b = D_00 * D_13
    M_23 = M_23a - M_23b
    M_24a = D_11 * D_03
    M_24b = D_01 * D_13
    M_24 = M_24a - M_24b
    M_25a = D_12 * D_03
    M_25b = D_02 * D_13
    M_25 = M_25a - M_25b
    M_03_size = absolute(M_03a) + absolute(M_03b)
    M_04_size = absolute(M_04a) + absolute(M_04b)
    M_05_size = absolute(M_05a) + absolute(M_05b)
    M_13_size = absolute(M_13a) + absolute(M_13b)
    M_14_size = absolute(M_14a) + absolute(M_14b)
    M_15_size = absolute(M_15a) + absolute(M_15b)
    M_23_size = absolute(M_23a) + absolute(M_23b)
    M_24_size = absolute(M_24a) + absolute(M_24b)
    M_25_size = absolute(M_25a) + absolute(M_25b)
    M_03_bound = c2 * (M_03_size + c1)
    M_04_bound = c2 * (M_04_size + c1)
    M_05_bound = c2 * (M_05_size + c1)
    M_13_bound = c2 * (M_13_size + c1)
    M_14_bound = c2 * (M_14_size + c1)
    M_15_bound = c2 * (M_15_size + c1)
    M_23_bound = c2 * (M_23_size + c1)
    M_24_bound = c2 * (M_24_size + c1)
    M_25_bound = c2 * (M_25_size + c1)
    return (D_00, D_01, D_02, M_03, M_04, M_05, D_10, D_11, D_12, M_13, M_14, M_15, D_20, D_21,
        D_22, M_23, M_24, M_25, 0, 0, 0, D_00, D_01, D_02, 0, 0, 0, D_10, D_11, D_12, 0, 0, 0, D_20,
        D_21, D_22, 0, 0, 0, M_03_bound, M_04_bound, M_05_bound, 0, 0, 0, M_13_bound, M_14_bound,
        M_15_bound, 0, 0, 0, M_23_bound, M_24_bound, M_25_bound, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0,
        0, 0, 0, 0, 0, 0)


@kernel("(6),(6)->(),()")
@errstate(all="ignore")
def dot_cs(c, s, *, c1=2.004168360008973e-292, c2=4.440892098500628e-16):
    """power = f·v + τ·ω, in W; |error of power| <= power_bound unless inf or NaN.

    (6),(6)->(),().  c: coscrew (f in N; τ in N m); s: screw (v in m/s; ω in rad/s); power,
    power_bound: number.
    7 mul, 11 add, 6 abs.
    """
    c_0, c_1, c_2, c_3, c_4, c_5 = c
    s_0, s_1, s_2, s_3, s_4, s_5 = s
    power_a = c_0 * s_0
    power_b = c_1 * s_1
    power_d = c_2 * s_2
    power_f = c_3 * s_3
    power_g = c_4 * s_4
    power_i = c_5 * s_5
    power = power_a + power_b + power_d + (power_f + power_g + power_i)
    power_size = (absolute(power_a) + absolute(power_b) + absolute(power_d)
        + (absolute(power_f) + absolute(power_g) + absolute(power_i)))
    power_bound = c2 * (power_size + c1)
    return (power, power_bound)


@kernel("(6),(6)->(6),(6)")
@errstate(all="ignore")
def cross_ss(s1, s2, *, c1=2.004168360008973e-292, c2=3.3306690738754706e-16,
        c3=2.2204460492503136e-16):
    """so = [ad](s1) s2 = (ω1×v2 + v1×ω2 ; ω1×ω2); |error of so| <= so_bound unless inf or NaN.
    Exactly zero for s1 = s2, unless products overflow.

    (6),(6)->(6),(6).  s1, s2, so, so_bound: screw (v in m/s; ω in rad/s).
    24 mul, 30 add, 18 abs.
    """
    s1_0, s1_1, s1_2, s1_3, s1_4, s1_5 = s1
    s2_0, s2_1, s2_2, s2_3, s2_4, s2_5 = s2
    so_0a = s1_1 * s2_5
    so_0b = s1_5 * s2_1
    so_0d = s1_4 * s2_2
    so_0e = s1_2 * s2_4
    so_0 = so_0a - so_0b + (so_0d - so_0e)
    so_1a = s1_5 * s2_0
    so_1b = s1_0 * s2_5
    so_1d = s1_2 * s2_3
    so_1e = s1_3 * s2_2
    so_1 = so_1a - so_1b + (so_1d - so_1e)
    so_2a = s1_0 * s2_4
    so_2b = s1_4 * s2_0
    so_2d = s1_3 * s2_1
    so_2e = s1_1 * s2_3
    so_2 = so_2a - so_2b + (so_2d - so_2e)
    so_3a = s1_4 * s2_5
    so_3b = s1_5 * s2_4
    so_3 = so_3a - so_3b
    so_4a = s1_5 * s2_3
    so_4b = s1_3 * s2_5
    so_4 = so_4a - so_4b
    so_5a = s1_3 * s2_4
    so_5b = s1_4 * s2_3
    so_5 = so_5a - so_5b
    so_0_size = absolute(so_0a) + absolute(so_0b) + (absolute(so_0d) + absolute(so_0e))
    so_1_size = absolute(so_1a) + absolute(so_1b) + (absolute(so_1d) + absolute(so_1e))
    so_2_size = absolute(so_2a) + absolute(so_2b) + (absolute(so_2d) + absolute(so_2e))
    so_3_size = absolute(so_3a) + absolute(so_3b)
    so_4_size = absolute(so_4a) + absolute(so_4b)
    so_5_size = absolute(so_5a) + absolute(so_5b)
    so_0_bound = c2 * (so_0_size + c1)
    so_1_bound = c2 * (so_1_size + c1)
    so_2_bound = c2 * (so_2_size + c1)
    so_3_bound = c3 * (so_3_size + c1)
    so_4_bound = c3 * (so_4_size + c1)
    so_5_bound = c3 * (so_5_size + c1)
    return (so_0, so_1, so_2, so_3, so_4, so_5, so_0_bound, so_1_bound, so_2_bound, so_3_bound,
        so_4_bound, so_5_bound)


@kernel("(6),(6)->(6),(6)")
@errstate(all="ignore")
def cross_sst(s1, s2, *, c1=2.004168360008973e-292, c2=2.2204460492503136e-16):
    """so = (ω1×v2 ; 0); |error of so| <= so_bound unless inf or NaN.

    (6),(6)->(6),(6).  s1, s2, so, so_bound: screw (v in m/s; ω in rad/s).
    9 mul, 9 add, 6 abs.
    """
    s1_0, s1_1, s1_2, s1_3, s1_4, s1_5 = s1
    s2_0, s2_1, s2_2, s2_3, s2_4, s2_5 = s2
    so_0a = s1_4 * s2_2
    so_0b = s1_5 * s2_1
    so_0 = so_0a - so_0b
    so_1a = s1_5 * s2_0
    so_1b = s1_3 * s2_2
    so_1 = so_1a - so_1b
    so_2a = s1_3 * s2_1
    so_2b = s1_4 * s2_0
    so_2 = so_2a - so_2b
    so_0_size = absolute(so_0a) + absolute(so_0b)
    so_1_size = absolute(so_1a) + absolute(so_1b)
    so_2_size = absolute(so_2a) + absolute(so_2b)
    so_0_bound = c2 * (so_0_size + c1)
    so_1_bound = c2 * (so_1_size + c1)
    so_2_bound = c2 * (so_2_size + c1)
    return (so_0, so_1, so_2, 0, 0, 0, so_0_bound, so_1_bound, so_2_bound, 0, 0, 0)


@kernel("(3,4),(3)->(6),(6)")
@errstate(all="ignore")
def hsra(D, axis, *, c1=2.004168360008973e-292, c2=5.551115123125785e-16,
        c3=3.3306690738754706e-16):
    """so = (t×R a ; R a), a = axis in the body's frame; |error of so| <= so_bound unless inf or
    NaN.

    (3,4),(3)->(6),(6).  D: displacement [R | t], R rotation, t in m; axis: vector; so,
    so_bound: screw (v in m/s; ω in rad/s).
    27 mul, 24 add, 12 abs.
    """
    D_00, D_01, D_02, D_03, D_10, D_11, D_12, D_13, D_20, D_21, D_22, D_23 = D
    axis_0, axis_1, axis_2 = axis
    a_0a = D_00 * axis_0
    a_0b = D_01 * axis_1
    a_0d = D_02 * axis_2
    a_0 = a_0a + a_0b + a_0d
    a_1a = D_10 * axis_0
    a_1b = D_11 * axis_1
    a_1d = D_12 * axis_2
    a_1 = a_1a + a_1b + a_1d
    a_2a = D_20 * axis_0
    a_2b = D_21 * axis_1
    a_2d = D_22 * axis_2
    a_2 = a_2a + a_2b + a_2d
    so_0 = D_13 * a_2 - D_23 * a_1
    so_1 = D_23 * a_0 - D_03 * a_2
    so_2 = D_03 * a_1 - D_13 * a_0
    a_0_size = absolute(a_0a) + absolute(a_0b) + absolute(a_0d)
    a_1_size = absolute(a_1a) + absolute(a_1b) + absolute(a_1d)
    a_2_size = absolute(a_2a) + absolute(a_2b) + absolute(a_2d)
    a_2_padded = a_2_size + c1
    D_13_abs = absolute(D_13)
    a_1_padded = a_1_size + c1
    D_23_abs = absolute(D_23)
    so_0_size = D_13_abs * a_2_padded + D_23_abs * a_1_padded
    a_0_padded = a_0_size + c1
    D_03_abs = absolute(D_03)
    so_1_size = D_23_abs * a_0_padded + D_03_abs * a_2_padded
    so_2_size = D_03_abs * a_1_padded + D_13_abs * a_0_padded
    so_0_bound = c2 * (so_0_size + c1)
    so_1_bound = c2 * (so_1_size + c1)
    so_2_bound = c2 * (so_2_size + c1)
    a_0_bound = c3 * a_0_padded
    a_1_bound = c3 * a_1_padded
    a_2_bound = c3 * a_2_padded
    return (so_0, so_1, so_2, a_0, a_1, a_2, so_0_bound, so_1_bound, so_2_bound, a_0_bound,
        a_1_bound, a_2_bound)


@kernel("(3,4),(3)->(6),(6)")
@errstate(all="ignore")
def hsta(D, axis, *, c1=2.004168360008973e-292, c2=3.3306690738754706e-16):
    """so = (R a ; 0), a = axis in the body's frame; |error of so| <= so_bound unless inf or NaN.

    (3,4),(3)->(6),(6).  D: displacement [R | t], R rotation, t in m; axis: vector; so,
    so_bound: screw (v in m/s; ω in rad/s).
    12 mul, 15 add, 9 abs.
    """
    D_00, D_01, D_02, D_03, D_10, D_11, D_12, D_13, D_20, D_21, D_22, D_23 = D
    axis_0, axis_1, axis_2 = axis
    so_0a = D_00 * axis_0
    so_0b = D_01 * axis_1
    so_0d = D_02 * axis_2
    so_0 = so_0a + so_0b + so_0d
    so_1a = D_10 * axis_0
    so_1b = D_11 * axis_1
    so_1d = D_12 * axis_2
    so_1 = so_1a + so_1b + so_1d
    so_2a = D_20 * axis_0
    so_2b = D_21 * axis_1
    so_2d = D_22 * axis_2
    so_2 = so_2a + so_2b + so_2d
    so_0_size = absolute(so_0a) + absolute(so_0b) + absolute(so_0d)
    so_1_size = absolute(so_1a) + absolute(so_1b) + absolute(so_1d)
    so_2_size = absolute(so_2a) + absolute(so_2b) + absolute(so_2d)
    so_0_bound = c2 * (so_0_size + c1)
    so_1_bound = c2 * (so_1_size + c1)
    so_2_bound = c2 * (so_2_size + c1)
    return (so_0, so_1, so_2, 0, 0, 0, so_0_bound, so_1_bound, so_2_bound, 0, 0, 0)


@kernel("(3,4),(3)->(6),(6)")
@errstate(all="ignore")
def hsrainv(D, axis, *, c1=2.004168360008973e-292, c2=5.551115123125785e-16,
        c3=3.3306690738754706e-16):
    """so = -(t×R a ; R a), a = axis in the body's frame; |error of so| <= so_bound unless inf or
    NaN.

    (3,4),(3)->(6),(6).  D: displacement [R | t], R rotation, t in m; axis: vector; so,
    so_bound: screw (v in m/s; ω in rad/s).
    27 mul, 24 add, 3 neg, 12 abs.
    """
    D_00, D_01, D_02, D_03, D_10, D_11, D_12, D_13, D_20, D_21, D_22, D_23 = D
    axis_0, axis_1, axis_2 = axis
    a_0a = D_00 * axis_0
    a_0b = D_01 * axis_1
    a_0d = D_02 * axis_2
    a_0 = -(a_0a + a_0b + a_0d)
    a_1a = D_10 * axis_0
    a_1b = D_11 * axis_1
    a_1d = D_12 * axis_2
    a_1 = -(a_1a + a_1b + a_1d)
    a_2a = D_20 * axis_0
    a_2b = D_21 * axis_1
    a_2d = D_22 * axis_2
    a_2 = -(a_2a + a_2b + a_2d)
    so_0 = D_13 * a_2 - D_23 * a_1
    so_1 = D_23 * a_0 - D_03 * a_2
    so_2 = D_03 * a_1 - D_13 * a_0
    a_2e_padded = absolute(a_2a) + absolute(a_2b) + absolute(a_2d) + c1
    D_13_abs = absolute(D_13)
    a_1e_padded = absolute(a_1a) + absolute(a_1b) + absolute(a_1d) + c1
    D_23_abs = absolute(D_23)
    so_0_size = D_13_abs * a_2e_padded + D_23_abs * a_1e_padded
    a_0e_padded = absolute(a_0a) + absolute(a_0b) + absolute(a_0d) + c1
    D_03_abs = absolute(D_03)
    so_1_size = D_23_abs * a_0e_padded + D_03_abs * a_2e_padded
    so_2_size = D_03_abs * a_1e_padded + D_13_abs * a_0e_padded
    so_0_bound = c2 * (so_0_size + c1)
    so_1_bound = c2 * (so_1_size + c1)
    so_2_bound = c2 * (so_2_size + c1)
    a_0e_bound = c3 * a_0e_padded
    a_1e_bound = c3 * a_1e_padded
    a_2e_bound = c3 * a_2e_padded
    return (so_0, so_1, so_2, a_0, a_1, a_2, so_0_bound, so_1_bound, so_2_bound, a_0e_bound,
        a_1e_bound, a_2e_bound)


@kernel("(3,4),(3)->(6),(6)")
@errstate(all="ignore")
def hstainv(D, axis, *, c1=2.004168360008973e-292, c2=3.3306690738754706e-16):
    """so = -(R a ; 0), a = axis in the body's frame; |error of so| <= so_bound unless inf or NaN.

    (3,4),(3)->(6),(6).  D: displacement [R | t], R rotation, t in m; axis: vector; so,
    so_bound: screw (v in m/s; ω in rad/s).
    12 mul, 15 add, 3 neg, 9 abs.
    """
    D_00, D_01, D_02, D_03, D_10, D_11, D_12, D_13, D_20, D_21, D_22, D_23 = D
    axis_0, axis_1, axis_2 = axis
    so_0a = D_00 * axis_0
    so_0b = D_01 * axis_1
    so_0d = D_02 * axis_2
    so_0 = -(so_0a + so_0b + so_0d)
    so_1a = D_10 * axis_0
    so_1b = D_11 * axis_1
    so_1d = D_12 * axis_2
    so_1 = -(so_1a + so_1b + so_1d)
    so_2a = D_20 * axis_0
    so_2b = D_21 * axis_1
    so_2d = D_22 * axis_2
    so_2 = -(so_2a + so_2b + so_2d)
    so_0e_bound = c2 * (absolute(so_0a) + absolute(so_0b) + absolute(so_0d) + c1)
    so_1e_bound = c2 * (absolute(so_1a) + absolute(so_1b) + absolute(so_1d) + c1)
    so_2e_bound = c2 * (absolute(so_2a) + absolute(so_2b) + absolute(so_2d) + c1)
    return (so_0, so_1, so_2, 0, 0, 0, so_0e_bound, so_1e_bound, so_2e_bound, 0, 0, 0)
