# Made by `coscrew generate`; changes are overwritten.
# SPDX-License-Identifier: MIT
# coscrew 0.2.0.  Copyright (c) 2026 The coscrew authors.
"""Screws: twists, spatial velocities and accelerations, s = (v; ω).

In double precision, plain tier.
"""

from numpy import absolute, float64 as real, sqrt, where
from coscrew._kernel import double_kernel as kernel


@kernel("(6)->(6)")
def screw_copy(si):
    """so = si.

    (6)->(6).  si, so: screw (v in m/s; ω in rad/s).
    No arithmetic.  Exact.
    """
    si_0, si_1, si_2, si_3, si_4, si_5 = si
    return (si_0, si_1, si_2, si_3, si_4, si_5)


@kernel("(6),()->(6)")
def screw_scale(self, a):
    """self = a self.

    (6),()->(6).  self: screw (v in m/s; ω in rad/s); a: number.
    6 mul.  Error <= u |result|, barring over- and underflow.
    """
    self_0, self_1, self_2, self_3, self_4, self_5 = self
    self_0_new = self_0 * a
    self_1_new = self_1 * a
    self_2_new = self_2 * a
    self_3_new = self_3 * a
    self_4_new = self_4 * a
    self_5_new = self_5 * a
    return (self_0_new, self_1_new, self_2_new, self_3_new, self_4_new, self_5_new)


@kernel("(6)->(6)")
def screw_inverted(si):
    """so = -si.

    (6)->(6).  si, so: screw (v in m/s; ω in rad/s).
    6 neg.  Exact.
    """
    si_0, si_1, si_2, si_3, si_4, si_5 = si
    so_0 = -si_0
    so_1 = -si_1
    so_2 = -si_2
    so_3 = -si_3
    so_4 = -si_4
    so_5 = -si_5
    return (so_0, so_1, so_2, so_3, so_4, so_5)


@kernel("(6)->(6)")
def screw_invert(self):
    """self = -self.

    (6)->(6).  self: screw (v in m/s; ω in rad/s).
    6 neg.  Exact.
    """
    self_0, self_1, self_2, self_3, self_4, self_5 = self
    self_0_new = -self_0
    self_1_new = -self_1
    self_2_new = -self_2
    self_3_new = -self_3
    self_4_new = -self_4
    self_5_new = -self_5
    return (self_0_new, self_1_new, self_2_new, self_3_new, self_4_new, self_5_new)


@kernel("(),(6),(6)->(6)")
def axpy_ss(a, x, y):
    """y = a x + y.

    (),(6),(6)->(6).  a: number; x, y: screw (v in m/s; ω in rad/s).
    6 mul, 6 add.  Error <= u |result| + 1 u S, S the sum of the |terms| of the expanded
    formula; barring over- and underflow.
    """
    x_0, x_1, x_2, x_3, x_4, x_5 = x
    y_0, y_1, y_2, y_3, y_4, y_5 = y
    y_0_new = a * x_0 + y_0
    y_1_new = a * x_1 + y_1
    y_2_new = a * x_2 + y_2
    y_3_new = a * x_3 + y_3
    y_4_new = a * x_4 + y_4
    y_5_new = a * x_5 + y_5
    return (y_0_new, y_1_new, y_2_new, y_3_new, y_4_new, y_5_new)


@kernel("(6),(6)->(6)")
def xpy_ss(x, y):
    """y = x + y.

    (6),(6)->(6).  x, y: screw (v in m/s; ω in rad/s).
    6 add.  Error <= u |result|, barring over- and underflow.
    """
    x_0, x_1, x_2, x_3, x_4, x_5 = x
    y_0, y_1, y_2, y_3, y_4, y_5 = y
    y_0_new = x_0 + y_0
    y_1_new = x_1 + y_1
    y_2_new = x_2 + y_2
    y_3_new = x_3 + y_3
    y_4_new = x_4 + y_4
    y_5_new = x_5 + y_5
    return (y_0_new, y_1_new, y_2_new, y_3_new, y_4_new, y_5_new)


@kernel("(6),(6)->(6)")
def nxpy_ss(x, y):
    """y = -x + y.

    (6),(6)->(6).  x, y: screw (v in m/s; ω in rad/s).
    6 add.  Error <= u |result|, barring over- and underflow.
    """
    x_0, x_1, x_2, x_3, x_4, x_5 = x
    y_0, y_1, y_2, y_3, y_4, y_5 = y
    y_0_new = y_0 - x_0
    y_1_new = y_1 - x_1
    y_2_new = y_2 - x_2
    y_3_new = y_3 - x_3
    y_4_new = y_4 - x_4
    y_5_new = y_5 - x_5
    return (y_0_new, y_1_new, y_2_new, y_3_new, y_4_new, y_5_new)


@kernel("(),(6)->(6)")
def product_as(a, si):
    """so = a si.

    (),(6)->(6).  a: number; si, so: screw (v in m/s; ω in rad/s).
    6 mul.  Error <= u |result|, barring over- and underflow.
    """
    si_0, si_1, si_2, si_3, si_4, si_5 = si
    so_0 = a * si_0
    so_1 = a * si_1
    so_2 = a * si_2
    so_3 = a * si_3
    so_4 = a * si_4
    so_5 = a * si_5
    return (so_0, so_1, so_2, so_3, so_4, so_5)


@kernel("(6),(6)->(6)")
def add_ss(s1, s2):
    """so = s1 + s2.

    (6),(6)->(6).  s1, s2, so: screw (v in m/s; ω in rad/s).
    6 add.  Error <= u |result|, barring over- and underflow.
    """
    s1_0, s1_1, s1_2, s1_3, s1_4, s1_5 = s1
    s2_0, s2_1, s2_2, s2_3, s2_4, s2_5 = s2
    so_0 = s1_0 + s2_0
    so_1 = s1_1 + s2_1
    so_2 = s1_2 + s2_2
    so_3 = s1_3 + s2_3
    so_4 = s1_4 + s2_4
    so_5 = s1_5 + s2_5
    return (so_0, so_1, so_2, so_3, so_4, so_5)


@kernel("(6),(6)->(6)")
def subtract_ss(s1, s2):
    """so = s1 - s2.

    (6),(6)->(6).  s1, s2, so: screw (v in m/s; ω in rad/s).
    6 add.  Error <= u |result|, barring over- and underflow.
    """
    s1_0, s1_1, s1_2, s1_3, s1_4, s1_5 = s1
    s2_0, s2_1, s2_2, s2_3, s2_4, s2_5 = s2
    so_0 = s1_0 - s2_0
    so_1 = s1_1 - s2_1
    so_2 = s1_2 - s2_2
    so_3 = s1_3 - s2_3
    so_4 = s1_4 - s2_4
    so_5 = s1_5 - s2_5
    return (so_0, so_1, so_2, so_3, so_4, so_5)


@kernel("(6)->()")
def screw_norm(si):
    """|si|: |ω|, or |v| where every |ω_i| is below 1e-9 (single: 1e-6).

    (6)->().  si: screw (v in m/s; ω in rad/s); norm: number.
    7 mul, 2 add, 1 sqrt, 6 abs, 11 less, 1 equal, 14 select.
    """
    si_0, si_1, si_2, si_3, si_4, si_5 = si
    small = where(absolute(si_3) < 1e-09, where(absolute(si_4) < 1e-09,
        where(absolute(si_5) < 1e-09, real(1), real(0)), 0), 0)
    p_0a = small == 1
    p_0 = where(p_0a, si_0, si_3)
    p_1 = where(p_0a, si_1, si_4)
    p_2 = where(p_0a, si_2, si_5)
    s_size_0 = absolute(p_0)
    s_size_1 = absolute(p_1)
    s_size_2 = absolute(p_2)
    s_largest1 = where(s_size_0 < s_size_1, s_size_1, s_size_0)
    s_largest2 = where(s_largest1 < s_size_2, s_size_2, s_largest1)
    s_d = where(s_largest2 < 256, 1.3093562431584567e+151,
        where(6.703903964971299e+153 < s_largest2, real(3.7291703656001034e-155), real(1)))
    s = where(s_largest2 < 1.955159272639747e-149, 1.0715086071862673e+301, s_d)
    y_0 = p_0 * s
    y_1 = p_1 * s
    y_2 = p_2 * s
    n = sqrt(y_0 * y_0 + y_1 * y_1 + y_2 * y_2)
    r_d = where(1 < s, 7.637340908749012e-152, where(s < 1, real(2.6815615859885194e+154), real(1)))
    r = where(1.3093562431584567e+151 < s, 9.332636185032189e-302, r_d)
    norm = n * r
    return norm


@kernel("(6)->(6)")
def screw_normalize(self):
    """self = self / |self|, with screw_norm; the zero screw stays zero.

    (6)->(6).  self: screw (v in m/s; ω in rad/s).
    18 mul, 2 add, 6 div, 1 sqrt, 9 abs, 16 less, 2 equal, 26 select.
    """
    self_0, self_1, self_2, self_3, self_4, self_5 = self
    small_a = absolute(self_5)
    small_d = absolute(self_4)
    small_g = absolute(self_3)
    small = where(small_g < 1e-09, where(small_d < 1e-09, where(small_a < 1e-09, real(1), real(0)),
        0), 0)
    p_0a = small == 1
    p_0 = where(p_0a, self_0, self_3)
    p_1 = where(p_0a, self_1, self_4)
    p_2 = where(p_0a, self_2, self_5)
    s_size_0 = absolute(p_0)
    s_size_1 = absolute(p_1)
    s_size_2 = absolute(p_2)
    s_largest1 = where(s_size_0 < s_size_1, s_size_1, s_size_0)
    s_largest2 = where(s_largest1 < s_size_2, s_size_2, s_largest1)
    s_d = where(s_largest2 < 256, 1.3093562431584567e+151,
        where(6.703903964971299e+153 < s_largest2, real(3.7291703656001034e-155), real(1)))
    s = where(s_largest2 < 1.955159272639747e-149, 1.0715086071862673e+301, s_d)
    y_0 = p_0 * s
    y_1 = p_1 * s
    y_2 = p_2 * s
    up = where(1 < s, s, 1)
    down = where(s < 1, s, 1)
    n = sqrt(y_0 * y_0 + y_1 * y_1 + y_2 * y_2)
    divisor = where(n == 0, up, n)
    size_0 = absolute(self_0)
    size_1 = absolute(self_1)
    size_2 = absolute(self_2)
    before_0a = size_0 < 256
    before_0 = where(before_0a, up, down)
    before_1a = size_1 < 256
    before_1 = where(before_1a, up, down)
    before_2a = size_2 < 256
    before_2 = where(before_2a, up, down)
    before_3a = small_g < 256
    before_3 = where(before_3a, up, down)
    before_4a = small_d < 256
    before_4 = where(before_4a, up, down)
    before_5a = small_a < 256
    before_5 = where(before_5a, up, down)
    after_0 = where(before_0a, down, up)
    after_1 = where(before_1a, down, up)
    after_2 = where(before_2a, down, up)
    after_3 = where(before_3a, down, up)
    after_4 = where(before_4a, down, up)
    after_5 = where(before_5a, down, up)
    sized_0 = self_0 * before_0
    sized_1 = self_1 * before_1
    sized_2 = self_2 * before_2
    sized_3 = self_3 * before_3
    sized_4 = self_4 * before_4
    sized_5 = self_5 * before_5
    quotient_0 = sized_0 / divisor
    quotient_1 = sized_1 / divisor
    quotient_2 = sized_2 / divisor
    quotient_3 = sized_3 / divisor
    quotient_4 = sized_4 / divisor
    quotient_5 = sized_5 / divisor
    self_0_new = quotient_0 * after_0
    self_1_new = quotient_1 * after_1
    self_2_new = quotient_2 * after_2
    self_3_new = quotient_3 * after_3
    self_4_new = quotient_4 * after_4
    self_5_new = quotient_5 * after_5
    return (self_0_new, self_1_new, self_2_new, self_3_new, self_4_new, self_5_new)


@kernel("(6)->(6)")
def screw_normalized(si):
    """so = si / |si|, with screw_norm; the zero screw stays zero.

    (6)->(6).  si, so: screw (v in m/s; ω in rad/s).
    18 mul, 2 add, 6 div, 1 sqrt, 9 abs, 16 less, 2 equal, 26 select.
    """
    si_0, si_1, si_2, si_3, si_4, si_5 = si
    small_a = absolute(si_5)
    small_d = absolute(si_4)
    small_g = absolute(si_3)
    small = where(small_g < 1e-09, where(small_d < 1e-09, where(small_a < 1e-09, real(1), real(0)),
        0), 0)
    p_0a = small == 1
    p_0 = where(p_0a, si_0, si_3)
    p_1 = where(p_0a, si_1, si_4)
    p_2 = where(p_0a, si_2, si_5)
    s_size_0 = absolute(p_0)
    s_size_1 = absolute(p_1)
    s_size_2 = absolute(p_2)
    s_largest1 = where(s_size_0 < s_size_1, s_size_1, s_size_0)
    s_largest2 = where(s_largest1 < s_size_2, s_size_2, s_largest1)
    s_d = where(s_largest2 < 256, 1.3093562431584567e+151,
        where(6.703903964971299e+153 < s_largest2, real(3.7291703656001034e-155), real(1)))
    s = where(s_largest2 < 1.955159272639747e-149, 1.0715086071862673e+301, s_d)
    y_0 = p_0 * s
    y_1 = p_1 * s
    y_2 = p_2 * s
    up = where(1 < s, s, 1)
    down = where(s < 1, s, 1)
    n = sqrt(y_0 * y_0 + y_1 * y_1 + y_2 * y_2)
    divisor = where(n == 0, up, n)
    size_0 = absolute(si_0)
    size_1 = absolute(si_1)
    size_2 = absolute(si_2)
    before_0a = size_0 < 256
    before_0 = where(before_0a, up, down)
    before_1a = size_1 < 256
    before_1 = where(before_1a, up, down)
    before_2a = size_2 < 256
    before_2 = where(before_2a, up, down)
    before_3a = small_g < 256
    before_3 = where(before_3a, up, down)
    before_4a = small_d < 256
    before_4 = where(before_4a, up, down)
    before_5a = small_a < 256
    before_5 = where(before_5a, up, down)
    after_0 = where(before_0a, down, up)
    after_1 = where(before_1a, down, up)
    after_2 = where(before_2a, down, up)
    after_3 = where(before_3a, down, up)
    after_4 = where(before_4a, down, up)
    after_5 = where(before_5a, down, up)
    sized_0 = si_0 * before_0
    sized_1 = si_1 * before_1
    sized_2 = si_2 * before_2
    sized_3 = si_3 * before_3
    sized_4 = si_4 * before_4
    sized_5 = si_5 * before_5
    quotient_0 = sized_0 / divisor
    quotient_1 = sized_1 / divisor
    quotient_2 = sized_2 / divisor
    quotient_3 = sized_3 / divisor
    quotient_4 = sized_4 / divisor
    quotient_5 = sized_5 / divisor
    so_0 = quotient_0 * after_0
    so_1 = quotient_1 * after_1
    so_2 = quotient_2 * after_2
    so_3 = quotient_3 * after_3
    so_4 = quotient_4 * after_4
    so_5 = quotient_5 * after_5
    return (so_0, so_1, so_2, so_3, so_4, so_5)


@kernel("(3),(3)->(6)")
def screw_from_lin_ang(lin, ang):
    """so = (lin; ang).

    (3),(3)->(6).  lin, ang: vector; so: screw (v in m/s; ω in rad/s).
    No arithmetic.  Exact.
    """
    lin_0, lin_1, lin_2 = lin
    ang_0, ang_1, ang_2 = ang
    return (lin_0, lin_1, lin_2, ang_0, ang_1, ang_2)


@kernel("(6)->(6)")
def screw_to_angular_first(si):
    """x = (ang; lin) of si.

    (6)->(6).  si: screw (v in m/s; ω in rad/s); x: six components with the angular part on top.
    No arithmetic.  Exact.
    """
    si_0, si_1, si_2, si_3, si_4, si_5 = si
    return (si_3, si_4, si_5, si_0, si_1, si_2)


@kernel("(6)->(6)")
def screw_from_angular_first(x):
    """so = (lin; ang) of x = (ang; lin).

    (6)->(6).  x: six components with the angular part on top; so: screw (v in m/s; ω in rad/s).
    No arithmetic.  Exact.
    """
    x_0, x_1, x_2, x_3, x_4, x_5 = x
    return (x_3, x_4, x_5, x_0, x_1, x_2)


@kernel("(6),(6)->(6)")
def add_sst(s1, s2):
    """so = (s1.lin + s2.lin ; s1.ang).

    (6),(6)->(6).  s1, s2, so: screw (v in m/s; ω in rad/s).
    3 add.  Error <= u |result|, barring over- and underflow.
    """
    s1_0, s1_1, s1_2, s1_3, s1_4, s1_5 = s1
    s2_0, s2_1, s2_2, s2_3, s2_4, s2_5 = s2
    so_0 = s1_0 + s2_0
    so_1 = s1_1 + s2_1
    so_2 = s1_2 + s2_2
    return (so_0, so_1, so_2, s1_3, s1_4, s1_5)


@kernel("(3),(6)->(6)")
def product_Adts(t, si):
    """so = [Ad](t) si.

    (3),(6)->(6).  t: vector; si, so: screw (v in m/s; ω in rad/s).
    6 mul, 6 add.  Error <= u |result| + (lin: 2, ang: 0) u S, S the sum of the |terms| of the
    expanded formula; barring over- and underflow.
    """
    t_0, t_1, t_2 = t
    si_0, si_1, si_2, si_3, si_4, si_5 = si
    so_0 = t_1 * si_5 - t_2 * si_4 + si_0
    so_1 = t_2 * si_3 - t_0 * si_5 + si_1
    so_2 = t_0 * si_4 - t_1 * si_3 + si_2
    return (so_0, so_1, so_2, si_3, si_4, si_5)


@kernel("(3),(6)->(6)")
def product_Adtinvs(t, si):
    """so = [Ad](t)^-1 si.

    (3),(6)->(6).  t: vector; si, so: screw (v in m/s; ω in rad/s).
    6 mul, 6 add.  Error <= u |result| + (lin: 2, ang: 0) u S, S the sum of the |terms| of the
    expanded formula; barring over- and underflow.
    """
    t_0, t_1, t_2 = t
    si_0, si_1, si_2, si_3, si_4, si_5 = si
    so_0 = t_2 * si_4 - t_1 * si_5 + si_0
    so_1 = t_0 * si_5 - t_2 * si_3 + si_1
    so_2 = t_1 * si_3 - t_0 * si_4 + si_2
    return (so_0, so_1, so_2, si_3, si_4, si_5)


@kernel("(3),(6)->(6)")
def product_Adtsinv(t, si):
    """so = [Ad](t) (-si).

    (3),(6)->(6).  t: vector; si, so: screw (v in m/s; ω in rad/s).
    6 mul, 6 add, 3 neg.  Error <= u |result| + (lin: 2, ang: 0) u S, S the sum of the |terms|
    of the expanded formula; barring over- and underflow.
    """
    t_0, t_1, t_2 = t
    si_0, si_1, si_2, si_3, si_4, si_5 = si
    so_0 = t_2 * si_4 - t_1 * si_5 - si_0
    so_1 = t_0 * si_5 - t_2 * si_3 - si_1
    so_2 = t_1 * si_3 - t_0 * si_4 - si_2
    so_3 = -si_3
    so_4 = -si_4
    so_5 = -si_5
    return (so_0, so_1, so_2, so_3, so_4, so_5)


@kernel("(3,3),(6)->(6)")
def product_Adrs(R, si):
    """so = [Ad](R) si.

    (3,3),(6)->(6).  R: rotation or other 3×3 matrix; si, so: screw (v in m/s; ω in rad/s).
    18 mul, 12 add.  Error <= u |result| + 2 u S, S the sum of the |terms| of the expanded
    formula; barring over- and underflow.
    """
    R_00, R_01, R_02, R_10, R_11, R_12, R_20, R_21, R_22 = R
    si_0, si_1, si_2, si_3, si_4, si_5 = si
    so_0 = R_00 * si_0 + R_01 * si_1 + R_02 * si_2
    so_1 = R_10 * si_0 + R_11 * si_1 + R_12 * si_2
    so_2 = R_20 * si_0 + R_21 * si_1 + R_22 * si_2
    so_3 = R_00 * si_3 + R_01 * si_4 + R_02 * si_5
    so_4 = R_10 * si_3 + R_11 * si_4 + R_12 * si_5
    so_5 = R_20 * si_3 + R_21 * si_4 + R_22 * si_5
    return (so_0, so_1, so_2, so_3, so_4, so_5)


@kernel("(3,3),(6)->(6)")
def product_Adrinvs(R, si):
    """so = [Ad](R)^-1 si.

    (3,3),(6)->(6).  R: rotation or other 3×3 matrix; si, so: screw (v in m/s; ω in rad/s).
    18 mul, 12 add.  Error <= u |result| + 2 u S, S the sum of the |terms| of the expanded
    formula; barring over- and underflow.
    """
    R_00, R_01, R_02, R_10, R_11, R_12, R_20, R_21, R_22 = R
    si_0, si_1, si_2, si_3, si_4, si_5 = si
    so_0 = R_00 * si_0 + R_10 * si_1 + R_20 * si_2
    so_1 = R_01 * si_0 + R_11 * si_1 + R_21 * si_2
    so_2 = R_02 * si_0 + R_12 * si_1 + R_22 * si_2
    so_3 = R_00 * si_3 + R_10 * si_4 + R_20 * si_5
    so_4 = R_01 * si_3 + R_11 * si_4 + R_21 * si_5
    so_5 = R_02 * si_3 + R_12 * si_4 + R_22 * si_5
    return (so_0, so_1, so_2, so_3, so_4, so_5)


@kernel("(3,3),(6)->(6)")
def product_Adrsinv(R, si):
    """so = [Ad](R) (-si).

    (3,3),(6)->(6).  R: rotation or other 3×3 matrix; si, so: screw (v in m/s; ω in rad/s).
    18 mul, 12 add, 6 neg.  Error <= u |result| + 2 u S, S the sum of the |terms| of the
    expanded formula; barring over- and underflow.
    """
    R_00, R_01, R_02, R_10, R_11, R_12, R_20, R_21, R_22 = R
    si_0, si_1, si_2, si_3, si_4, si_5 = si
    so_0 = -(R_00 * si_0 + R_01 * si_1 + R_02 * si_2)
    so_1 = -(R_10 * si_0 + R_11 * si_1 + R_12 * si_2)
    so_2 = -(R_20 * si_0 + R_21 * si_1 + R_22 * si_2)
    so_3 = -(R_00 * si_3 + R_01 * si_4 + R_02 * si_5)
    so_4 = -(R_10 * si_3 + R_11 * si_4 + R_12 * si_5)
    so_5 = -(R_20 * si_3 + R_21 * si_4 + R_22 * si_5)
    return (so_0, so_1, so_2, so_3, so_4, so_5)


@kernel("(3,4),(6)->(6)")
def product_Ads(D, si):
    """so = [Ad](D) si = [Ad](t) [Ad](R) si.

    (3,4),(6)->(6).  D: displacement [R | t], R rotation, t in m; si, so: screw (v in m/s; ω in
    rad/s).
    24 mul, 18 add.  Error <= u |result| + (lin: 5, ang: 2) u S, S the sum of the |terms| of the
    expanded formula; barring over- and underflow.
    """
    D_00, D_01, D_02, D_03, D_10, D_11, D_12, D_13, D_20, D_21, D_22, D_23 = D
    si_0, si_1, si_2, si_3, si_4, si_5 = si
    w_0 = D_00 * si_0 + D_01 * si_1 + D_02 * si_2
    w_1 = D_10 * si_0 + D_11 * si_1 + D_12 * si_2
    w_2 = D_20 * si_0 + D_21 * si_1 + D_22 * si_2
    w_3 = D_00 * si_3 + D_01 * si_4 + D_02 * si_5
    w_4 = D_10 * si_3 + D_11 * si_4 + D_12 * si_5
    w_5 = D_20 * si_3 + D_21 * si_4 + D_22 * si_5
    so_0 = D_13 * w_5 - D_23 * w_4 + w_0
    so_1 = D_23 * w_3 - D_03 * w_5 + w_1
    so_2 = D_03 * w_4 - D_13 * w_3 + w_2
    return (so_0, so_1, so_2, w_3, w_4, w_5)


@kernel("(3,4),(6)->(6)")
def product_Adinvs(D, si):
    """so = [Ad](D)^-1 si = [Ad](R^T) [Ad](-t) si.

    (3,4),(6)->(6).  D: displacement [R | t], R rotation, t in m; si, so: screw (v in m/s; ω in
    rad/s).
    24 mul, 18 add.  Error <= u |result| + (lin: 5, ang: 2) u S, S the sum of the |terms| of the
    expanded formula; barring over- and underflow.
    """
    D_00, D_01, D_02, D_03, D_10, D_11, D_12, D_13, D_20, D_21, D_22, D_23 = D
    si_0, si_1, si_2, si_3, si_4, si_5 = si
    w_0 = D_23 * si_4 - D_13 * si_5 + si_0
    w_1 = D_03 * si_5 - D_23 * si_3 + si_1
    w_2 = D_13 * si_3 - D_03 * si_4 + si_2
    so_0 = D_00 * w_0 + D_10 * w_1 + D_20 * w_2
    so_1 = D_01 * w_0 + D_11 * w_1 + D_21 * w_2
    so_2 = D_02 * w_0 + D_12 * w_1 + D_22 * w_2
    so_3 = D_00 * si_3 + D_10 * si_4 + D_20 * si_5
    so_4 = D_01 * si_3 + D_11 * si_4 + D_21 * si_5
    so_5 = D_02 * si_3 + D_12 * si_4 + D_22 * si_5
    return (so_0, so_1, so_2, so_3, so_4, so_5)


@kernel("(3,4),(6)->(6)")
def product_Adsinv(D, si):
    """so = [Ad](D) (-si).

    (3,4),(6)->(6).  D: displacement [R | t], R rotation, t in m; si, so: screw (v in m/s; ω in
    rad/s).
    24 mul, 18 add, 6 neg.  Error <= u |result| + (lin: 5, ang: 2) u S, S the sum of the |terms|
    of the expanded formula; barring over- and underflow.
    """
    D_00, D_01, D_02, D_03, D_10, D_11, D_12, D_13, D_20, D_21, D_22, D_23 = D
    si_0, si_1, si_2, si_3, si_4, si_5 = si
    w_0 = -(D_00 * si_0 + D_01 * si_1 + D_02 * si_2)
    w_1 = -(D_10 * si_0 + D_11 * si_1 + D_12 * si_2)
    w_2 = -(D_20 * si_0 + D_21 * si_1 + D_22 * si_2)
    w_3 = -(D_00 * si_3 + D_01 * si_4 + D_02 * si_5)
    w_4 = -(D_10 * si_3 + D_11 * si_4 + D_12 * si_5)
    w_5 = -(D_20 * si_3 + D_21 * si_4 + D_22 * si_5)
    so_0 = D_13 * w_5 - D_23 * w_4 + w_0
    so_1 = D_23 * w_3 - D_03 * w_5 + w_1
    so_2 = D_03 * w_4 - D_13 * w_3 + w_2
    return (so_0, so_1, so_2, w_3, w_4, w_5)


@kernel("(3,4)->(6)")
def hstx(D):
    """so = h_tx: column 0 of [Ad](D).

    (3,4)->(6).  D: displacement [R | t], R rotation, t in m; so: screw (v in m/s; ω in rad/s).
    No arithmetic.  Exact.
    """
    D_00, D_01, D_02, D_03, D_10, D_11, D_12, D_13, D_20, D_21, D_22, D_23 = D
    return (D_00, D_10, D_20, 0, 0, 0)


@kernel("(3,4)->(6)")
def hsty(D):
    """so = h_ty: column 1 of [Ad](D).

    (3,4)->(6).  D: displacement [R | t], R rotation, t in m; so: screw (v in m/s; ω in rad/s).
    No arithmetic.  Exact.
    """
    D_00, D_01, D_02, D_03, D_10, D_11, D_12, D_13, D_20, D_21, D_22, D_23 = D
    return (D_01, D_11, D_21, 0, 0, 0)


@kernel("(3,4)->(6)")
def hstz(D):
    """so = h_tz: column 2 of [Ad](D).

    (3,4)->(6).  D: displacement [R | t], R rotation, t in m; so: screw (v in m/s; ω in rad/s).
    No arithmetic.  Exact.
    """
    D_00, D_01, D_02, D_03, D_10, D_11, D_12, D_13, D_20, D_21, D_22, D_23 = D
    return (D_02, D_12, D_22, 0, 0, 0)


@kernel("(3,4)->(6)")
def hsrx(D):
    """so = h_rx: column 3 of [Ad](D).

    (3,4)->(6).  D: displacement [R | t], R rotation, t in m; so: screw (v in m/s; ω in rad/s).
    6 mul, 3 add.  Error <= u |result| + (lin: 1, ang: 0) u S, S the sum of the |terms| of the
    expanded formula; barring over- and underflow.
    """
    D_00, D_01, D_02, D_03, D_10, D_11, D_12, D_13, D_20, D_21, D_22, D_23 = D
    so_0 = D_20 * D_13 - D_10 * D_23
    so_1 = D_00 * D_23 - D_20 * D_03
    so_2 = D_10 * D_03 - D_00 * D_13
    return (so_0, so_1, so_2, D_00, D_10, D_20)


@kernel("(3,4)->(6)")
def hsry(D):
    """so = h_ry: column 4 of [Ad](D).

    (3,4)->(6).  D: displacement [R | t], R rotation, t in m; so: screw (v in m/s; ω in rad/s).
    6 mul, 3 add.  Error <= u |result| + (lin: 1, ang: 0) u S, S the sum of the |terms| of the
    expanded formula; barring over- and underflow.
    """
    D_00, D_01, D_02, D_03, D_10, D_11, D_12, D_13, D_20, D_21, D_22, D_23 = D
    so_0 = D_21 * D_13 - D_11 * D_23
    so_1 = D_01 * D_23 - D_21 * D_03
    so_2 = D_11 * D_03 - D_01 * D_13
    return (so_0, so_1, so_2, D_01, D_11, D_21)


@kernel("(3,4)->(6)")
def hsrz(D):
    """so = h_rz: column 5 of [Ad](D).

    (3,4)->(6).  D: displacement [R | t], R rotation, t in m; so: screw (v in m/s; ω in rad/s).
    6 mul, 3 add.  Error <= u |result| + (lin: 1, ang: 0) u S, S the sum of the |terms| of the
    expanded formula; barring over- and underflow.
    """
    D_00, D_01, D_02, D_03, D_10, D_11, D_12, D_13, D_20, D_21, D_22, D_23 = D
    so_0 = D_22 * D_13 - D_12 * D_23
    so_1 = D_02 * D_23 - D_22 * D_03
    so_2 = D_12 * D_03 - D_02 * D_13
    return (so_0, so_1, so_2, D_02, D_12, D_22)


@kernel("(3,4)->(6)")
def hstxinv(D):
    """so = -h_tx: -column 0 of [Ad](D).

    (3,4)->(6).  D: displacement [R | t], R rotation, t in m; so: screw (v in m/s; ω in rad/s).
    3 neg.  Exact.
    """
    D_00, D_01, D_02, D_03, D_10, D_11, D_12, D_13, D_20, D_21, D_22, D_23 = D
    so_0 = -D_00
    so_1 = -D_10
    so_2 = -D_20
    return (so_0, so_1, so_2, 0, 0, 0)


@kernel("(3,4)->(6)")
def hstyinv(D):
    """so = -h_ty: -column 1 of [Ad](D).

    (3,4)->(6).  D: displacement [R | t], R rotation, t in m; so: screw (v in m/s; ω in rad/s).
    3 neg.  Exact.
    """
    D_00, D_01, D_02, D_03, D_10, D_11, D_12, D_13, D_20, D_21, D_22, D_23 = D
    so_0 = -D_01
    so_1 = -D_11
    so_2 = -D_21
    return (so_0, so_1, so_2, 0, 0, 0)


@kernel("(3,4)->(6)")
def hstzinv(D):
    """so = -h_tz: -column 2 of [Ad](D).

    (3,4)->(6).  D: displacement [R | t], R rotation, t in m; so: screw (v in m/s; ω in rad/s).
    3 neg.  Exact.
    """
    D_00, D_01, D_02, D_03, D_10, D_11, D_12, D_13, D_20, D_21, D_22, D_23 = D
    so_0 = -D_02
    so_1 = -D_12
    so_2 = -D_22
    return (so_0, so_1, so_2, 0, 0, 0)


@kernel("(3,4)->(6)")
def hsrxinv(D):
    """so = -h_rx: -column 3 of [Ad](D).

    (3,4)->(6).  D: displacement [R | t], R rotation, t in m; so: screw (v in m/s; ω in rad/s).
    6 mul, 3 add, 3 neg.  Error <= u |result| + (lin: 1, ang: 0) u S, S the sum of the |terms|
    of the expanded formula; barring over- and underflow.
    """
    D_00, D_01, D_02, D_03, D_10, D_11, D_12, D_13, D_20, D_21, D_22, D_23 = D
    so_0 = D_10 * D_23 - D_20 * D_13
    so_1 = D_20 * D_03 - D_00 * D_23
    so_2 = D_00 * D_13 - D_10 * D_03
    so_3 = -D_00
    so_4 = -D_10
    so_5 = -D_20
    return (so_0, so_1, so_2, so_3, so_4, so_5)


@kernel("(3,4)->(6)")
def hsryinv(D):
    """so = -h_ry: -column 4 of [Ad](D).

    (3,4)->(6).  D: displacement [R | t], R rotation, t in m; so: screw (v in m/s; ω in rad/s).
    6 mul, 3 add, 3 neg.  Error <= u |result| + (lin: 1, ang: 0) u S, S the sum of the |terms|
    of the expanded formula; barring over- and underflow.
    """
    D_00, D_01, D_02, D_03, D_10, D_11, D_12, D_13, D_20, D_21, D_22, D_23 = D
    so_0 = D_11 * D_23 - D_21 * D_13
    so_1 = D_21 * D_03 - D_01 * D_23
    so_2 = D_01 * D_13 - D_11 * D_03
    so_3 = -D_01
    so_4 = -D_11
    so_5 = -D_21
    return (so_0, so_1, so_2, so_3, so_4, so_5)


@kernel("(3,4)->(6)")
def hsrzinv(D):
    """so = -h_rz: -column 5 of [Ad](D).

    (3,4)->(6).  D: displacement [R | t], R rotation, t in m; so: screw (v in m/s; ω in rad/s).
    6 mul, 3 add, 3 neg.  Error <= u |result| + (lin: 1, ang: 0) u S, S the sum of the |terms|
    of the expanded formula; barring over- and underflow.
    """
    D_00, D_01, D_02, D_03, D_10, D_11, D_12, D_13, D_20, D_21, D_22, D_23 = D
    so_0 = D_12 * D_23 - D_22 * D_13
    so_1 = D_22 * D_03 - D_02 * D_23
    so_2 = D_02 * D_13 - D_12 * D_03
    so_3 = -D_02
    so_4 = -D_12
    so_5 = -D_22
    return (so_0, so_1, so_2, so_3, so_4, so_5)


@kernel("(3,4)->(6,6)")
def Ad(D):
    """M = [Ad](D).

    (3,4)->(6,6).  D: displacement [R | t], R rotation, t in m; M: 6×6 operator.
    18 mul, 9 add.  Error <= u |result| + 1 u S, S the sum of the |terms| of the expanded
    formula; barring over- and underflow.
    """
    D_00, D_01, D_02, D_03, D_10, D_11, D_12, D_13, D_20, D_21, D_22, D_23 = D
    M_03 = D_20 * D_13 - D_10 * D_23
    M_04 = D_21 * D_13 - D_11 * D_23
    M_05 = D_22 * D_13 - D_12 * D_23
    M_13 = D_00 * D_23 - D_20 * D_03
    M_14 = D_01 * D_23 - D_21 * D_03
    M_15 = D_02 * D_23 - D_22 * D_03
    M_23 = D_10 * D_03 - D_00 * D_13
    M_24 = D_11 * D_03 - D_01 * D_13
    M_25 = D_12 * D_03 - D_02 * D_13
    return (D_00, D_01, D_02, M_03, M_04, M_05, D_10, D_11, D_12, M_13, M_14, M_15, D_20, D_21,
        D_22, M_23, M_24, M_25, 0, 0, 0, D_00, D_01, D_02, 0, 0, 0, D_10, D_11, D_12, 0, 0, 0, D_20,
        D_21, D_22)


@kernel("(6),(6)->()")
def dot_cs(c, s):
    """power = f·v + τ·ω, in W.

    (6),(6)->().  c: coscrew (f in N; τ in N m); s: screw (v in m/s; ω in rad/s); power: number.
    6 mul, 5 add.  Error <= u |result| + 3 u S, S the sum of the |terms| of the expanded
    formula; barring over- and underflow.
    """
    c_0, c_1, c_2, c_3, c_4, c_5 = c
    s_0, s_1, s_2, s_3, s_4, s_5 = s
    power = c_0 * s_0 + c_1 * s_1 + c_2 * s_2 + (c_3 * s_3 + c_4 * s_4 + c_5 * s_5)
    return power


@kernel("(6),(6)->(6)")
def cross_ss(s1, s2):
    """so = [ad](s1) s2 = (ω1×v2 + v1×ω2 ; ω1×ω2).  Exactly zero for s1 = s2, unless products
    overflow.

    (6),(6)->(6).  s1, s2, so: screw (v in m/s; ω in rad/s).
    18 mul, 12 add.  Error <= u |result| + (lin: 2, ang: 1) u S, S the sum of the |terms| of the
    expanded formula; barring over- and underflow.
    """
    s1_0, s1_1, s1_2, s1_3, s1_4, s1_5 = s1
    s2_0, s2_1, s2_2, s2_3, s2_4, s2_5 = s2
    so_0 = s1_1 * s2_5 - s1_5 * s2_1 + (s1_4 * s2_2 - s1_2 * s2_4)
    so_1 = s1_5 * s2_0 - s1_0 * s2_5 + (s1_2 * s2_3 - s1_3 * s2_2)
    so_2 = s1_0 * s2_4 - s1_4 * s2_0 + (s1_3 * s2_1 - s1_1 * s2_3)
    so_3 = s1_4 * s2_5 - s1_5 * s2_4
    so_4 = s1_5 * s2_3 - s1_3 * s2_5
    so_5 = s1_3 * s2_4 - s1_4 * s2_3
    return (so_0, so_1, so_2, so_3, so_4, so_5)


@kernel("(6),(6)->(6)")
def cross_sst(s1, s2):
    """so = (ω1×v2 ; 0).

    (6),(6)->(6).  s1, s2, so: screw (v in m/s; ω in rad/s).
    6 mul, 3 add.  Error <= u |result| + (lin: 1, ang: 0) u S, S the sum of the |terms| of the
    expanded formula; barring over- and underflow.
    """
    s1_0, s1_1, s1_2, s1_3, s1_4, s1_5 = s1
    s2_0, s2_1, s2_2, s2_3, s2_4, s2_5 = s2
    so_0 = s1_4 * s2_2 - s1_5 * s2_1
    so_1 = s1_5 * s2_0 - s1_3 * s2_2
    so_2 = s1_3 * s2_1 - s1_4 * s2_0
    return (so_0, so_1, so_2, 0, 0, 0)


@kernel("(3,4),(3)->(6)")
def hsra(D, axis):
    """so = (t×R a ; R a), a = axis in the body's frame.

    (3,4),(3)->(6).  D: displacement [R | t], R rotation, t in m; axis: vector; so: screw (v in
    m/s; ω in rad/s).
    15 mul, 9 add.  Error <= u |result| + (lin: 4, ang: 2) u S, S the sum of the |terms| of the
    expanded formula; barring over- and underflow.
    """
    D_00, D_01, D_02, D_03, D_10, D_11, D_12, D_13, D_20, D_21, D_22, D_23 = D
    axis_0, axis_1, axis_2 = axis
    a_0 = D_00 * axis_0 + D_01 * axis_1 + D_02 * axis_2
    a_1 = D_10 * axis_0 + D_11 * axis_1 + D_12 * axis_2
    a_2 = D_20 * axis_0 + D_21 * axis_1 + D_22 * axis_2
    so_0 = D_13 * a_2 - D_23 * a_1
    so_1 = D_23 * a_0 - D_03 * a_2
    so_2 = D_03 * a_1 - D_13 * a_0
    return (so_0, so_1, so_2, a_0, a_1, a_2)


@kernel("(3,4),(3)->(6)")
def hsta(D, axis):
    """so = (R a ; 0), a = axis in the body's frame.

    (3,4),(3)->(6).  D: displacement [R | t], R rotation, t in m; axis: vector; so: screw (v in
    m/s; ω in rad/s).
    9 mul, 6 add.  Error <= u |result| + (lin: 2, ang: 0) u S, S the sum of the |terms| of the
    expanded formula; barring over- and underflow.
    """
    D_00, D_01, D_02, D_03, D_10, D_11, D_12, D_13, D_20, D_21, D_22, D_23 = D
    axis_0, axis_1, axis_2 = axis
    so_0 = D_00 * axis_0 + D_01 * axis_1 + D_02 * axis_2
    so_1 = D_10 * axis_0 + D_11 * axis_1 + D_12 * axis_2
    so_2 = D_20 * axis_0 + D_21 * axis_1 + D_22 * axis_2
    return (so_0, so_1, so_2, 0, 0, 0)


@kernel("(3,4),(3)->(6)")
def hsrainv(D, axis):
    """so = -(t×R a ; R a), a = axis in the body's frame.

    (3,4),(3)->(6).  D: displacement [R | t], R rotation, t in m; axis: vector; so: screw (v in
    m/s; ω in rad/s).
    15 mul, 9 add, 3 neg.  Error <= u |result| + (lin: 4, ang: 2) u S, S the sum of the |terms|
    of the expanded formula; barring over- and underflow.
    """
    D_00, D_01, D_02, D_03, D_10, D_11, D_12, D_13, D_20, D_21, D_22, D_23 = D
    axis_0, axis_1, axis_2 = axis
    a_0 = -(D_00 * axis_0 + D_01 * axis_1 + D_02 * axis_2)
    a_1 = -(D_10 * axis_0 + D_11 * axis_1 + D_12 * axis_2)
    a_2 = -(D_20 * axis_0 + D_21 * axis_1 + D_22 * axis_2)
    so_0 = D_13 * a_2 - D_23 * a_1
    so_1 = D_23 * a_0 - D_03 * a_2
    so_2 = D_03 * a_1 - D_13 * a_0
    return (so_0, so_1, so_2, a_0, a_1, a_2)


@kernel("(3,4),(3)->(6)")
def hstainv(D, axis):
    """so = -(R a ; 0), a = axis in the body's frame.

    (3,4),(3)->(6).  D: displacement [R | t], R rotation, t in m; axis: vector; so: screw (v in
    m/s; ω in rad/s).
    9 mul, 6 add, 3 neg.  Error <= u |result| + (lin: 2, ang: 0) u S, S the sum of the |terms|
    of the expanded formula; barring over- and underflow.
    """
    D_00, D_01, D_02, D_03, D_10, D_11, D_12, D_13, D_20, D_21, D_22, D_23 = D
    axis_0, axis_1, axis_2 = axis
    so_0 = -(D_00 * axis_0 + D_01 * axis_1 + D_02 * axis_2)
    so_1 = -(D_10 * axis_0 + D_11 * axis_1 + D_12 * axis_2)
    so_2 = -(D_20 * axis_0 + D_21 * axis_1 + D_22 * axis_2)
    return (so_0, so_1, so_2, 0, 0, 0)


@kernel("(6)->(6,6)")
def ad(s):
    """M = [ad](s) = [Ad]' [Ad]^-1 = [[ω~, v~], [0, ω~]].

    (6)->(6,6).  s: screw (v in m/s; ω in rad/s); M: 6×6 operator.
    6 neg.  Exact.
    """
    s_0, s_1, s_2, s_3, s_4, s_5 = s
    M_01 = -s_5
    M_04 = -s_2
    M_12 = -s_3
    M_15 = -s_0
    M_20 = -s_4
    M_23 = -s_1
    return (0, M_01, s_4, 0, M_04, s_1, s_5, 0, M_12, s_2, 0, M_15, M_20, s_3, 0, M_23, s_0, 0, 0,
        0, 0, 0, M_01, s_4, 0, 0, 0, s_5, 0, M_12, 0, 0, 0, M_20, s_3, 0)
