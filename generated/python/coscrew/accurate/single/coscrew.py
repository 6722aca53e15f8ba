# Made by `coscrew generate`; changes are overwritten.
# SPDX-License-Identifier: MIT
# coscrew 0.2.0.  Copyright (c) 2026 The coscrew authors.
"""Coscrews: wrenches and momenta, c = (f; τ).

In single precision, accurate tier.
"""

from numpy import absolute, float64 as real, sqrt, where
from coscrew._kernel import wide_kernel as kernel


@kernel("(6),()->(6)")
def coscrew_scale(self, a):
    """self = a self.

    (6),()->(6).  self: coscrew (f in N; τ in N m); a: number.
    6 mul.  Error <= u |result| + 1/32 u^2 S, S the sum of the |terms| of the expanded formula;
    barring over- and underflow.
    """
    self_0, self_1, self_2, self_3, self_4, self_5 = self
    self_0_new = self_0 * a
    self_1_new = self_1 * a
    self_2_new = self_2 * a
    self_3_new = self_3 * a
    self_4_new = self_4 * a
    self_5_new = self_5 * a
    return (self_0_new, self_1_new, self_2_new, self_3_new, self_4_new, self_5_new)


@kernel("(),(6),(6)->(6)")
def axpy_cc(a, x, y):
    """y = a x + y.

    (),(6),(6)->(6).  a: number; x, y: coscrew (f in N; τ in N m).
    6 mul, 6 add.  Error <= u |result| + 1/16 u^2 S, S the sum of the |terms| of the expanded
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
def xpy_cc(x, y):
    """y = x + y.

    (6),(6)->(6).  x, y: coscrew (f in N; τ in N m).
    6 add.  Error <= u |result| + 1/32 u^2 S, S the sum of the |terms| of the expanded formula;
    barring over- and underflow.
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
def nxpy_cc(x, y):
    """y = -x + y.

    (6),(6)->(6).  x, y: coscrew (f in N; τ in N m).
    6 add.  Error <= u |result| + 1/32 u^2 S, S the sum of the |terms| of the expanded formula;
    barring over- and underflow.
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
def product_ac(a, ci):
    """co = a ci.

    (),(6)->(6).  a: number; ci, co: coscrew (f in N; τ in N m).
    6 mul.  Error <= u |result| + 1/32 u^2 S, S the sum of the |terms| of the expanded formula;
    barring over- and underflow.
    """
    ci_0, ci_1, ci_2, ci_3, ci_4, ci_5 = ci
    co_0 = a * ci_0
    co_1 = a * ci_1
    co_2 = a * ci_2
    co_3 = a * ci_3
    co_4 = a * ci_4
    co_5 = a * ci_5
    return (co_0, co_1, co_2, co_3, co_4, co_5)


@kernel("(6),(6)->(6)")
def add_cc(c1, c2):
    """co = c1 + c2.

    (6),(6)->(6).  c1, c2, co: coscrew (f in N; τ in N m).
    6 add.  Error <= u |result| + 1/32 u^2 S, S the sum of the |terms| of the expanded formula;
    barring over- and underflow.
    """
    c1_0, c1_1, c1_2, c1_3, c1_4, c1_5 = c1
    c2_0, c2_1, c2_2, c2_3, c2_4, c2_5 = c2
    co_0 = c1_0 + c2_0
    co_1 = c1_1 + c2_1
    co_2 = c1_2 + c2_2
    co_3 = c1_3 + c2_3
    co_4 = c1_4 + c2_4
    co_5 = c1_5 + c2_5
    return (co_0, co_1, co_2, co_3, co_4, co_5)


@kernel("(6),(6)->(6)")
def subtract_cc(c1, c2):
    """co = c1 - c2.

    (6),(6)->(6).  c1, c2, co: coscrew (f in N; τ in N m).
    6 add.  Error <= u |result| + 1/32 u^2 S, S the sum of the |terms| of the expanded formula;
    barring over- and underflow.
    """
    c1_0, c1_1, c1_2, c1_3, c1_4, c1_5 = c1
    c2_0, c2_1, c2_2, c2_3, c2_4, c2_5 = c2
    co_0 = c1_0 - c2_0
    co_1 = c1_1 - c2_1
    co_2 = c1_2 - c2_2
    co_3 = c1_3 - c2_3
    co_4 = c1_4 - c2_4
    co_5 = c1_5 - c2_5
    return (co_0, co_1, co_2, co_3, co_4, co_5)


@kernel("(6)->()")
def coscrew_norm(ci):
    """|ci|: |f|, or |τ| where every |f_i| is below 1e-9 (single: 1e-6).

    (6)->().  ci: coscrew (f in N; τ in N m); norm: number.
    7 mul, 2 add, 1 sqrt, 6 abs, 11 less, 1 equal, 14 select.
    """
    ci_0, ci_1, ci_2, ci_3, ci_4, ci_5 = ci
    small_f = where(absolute(ci_1) < 9.999999974752427e-07,
        where(absolute(ci_2) < 9.999999974752427e-07, real(1), real(0)), 0)
    small = where(absolute(ci_0) < 9.999999974752427e-07, small_f, 0)
    p_0a = small == 1
    p_0 = where(p_0a, ci_3, ci_0)
    p_1 = where(p_0a, ci_4, ci_1)
    p_2 = where(p_0a, ci_5, ci_2)
    s_size_0 = absolute(p_0)
    s_size_1 = absolute(p_1)
    s_size_2 = absolute(p_2)
    s_largest1 = where(s_size_0 < s_size_1, s_size_1, s_size_0)
    s_largest2 = where(s_largest1 < s_size_2, s_size_2, s_largest1)
    s_d = where(s_largest2 < 256, 1.8014398509481984e+16, where(4.611686018427388e+18 < s_largest2,
        real(2.710505431213761e-20), real(1)))
    s = where(s_largest2 < 1.4210854715202004e-14, 3.2451855365842673e+32, s_d)
    y_0 = p_0 * s
    y_1 = p_1 * s
    y_2 = p_2 * s
    n = sqrt(y_0 * y_0 + y_1 * y_1 + y_2 * y_2)
    r_d = where(1 < s, 5.551115123125783e-17, where(s < 1, real(3.6893488147419103e+19), real(1)))
    r = where(1.8014398509481984e+16 < s, 3.0814879110195774e-33, r_d)
    norm = n * r
    return norm


@kernel("(6)->(6)")
def coscrew_normalize(self):
    """self = self / |self|, with coscrew_norm; the zero coscrew stays zero.

    (6)->(6).  self: coscrew (f in N; τ in N m).
    18 mul, 2 add, 6 div, 1 sqrt, 9 abs, 16 less, 2 equal, 26 select.
    """
    self_0, self_1, self_2, self_3, self_4, self_5 = self
    small_a = absolute(self_2)
    small_d = absolute(self_1)
    small_g = absolute(self_0)
    small = where(small_g < 9.999999974752427e-07, where(small_d < 9.999999974752427e-07,
        where(small_a < 9.999999974752427e-07, real(1), real(0)), 0), 0)
    p_0a = small == 1
    p_0 = where(p_0a, self_3, self_0)
    p_1 = where(p_0a, self_4, self_1)
    p_2 = where(p_0a, self_5, self_2)
    s_size_0 = absolute(p_0)
    s_size_1 = absolute(p_1)
    s_size_2 = absolute(p_2)
    s_largest1 = where(s_size_0 < s_size_1, s_size_1, s_size_0)
    s_largest2 = where(s_largest1 < s_size_2, s_size_2, s_largest1)
    s_d = where(s_largest2 < 256, 1.8014398509481984e+16, where(4.611686018427388e+18 < s_largest2,
        real(2.710505431213761e-20), real(1)))
    s = where(s_largest2 < 1.4210854715202004e-14, 3.2451855365842673e+32, s_d)
    y_0 = p_0 * s
    y_1 = p_1 * s
    y_2 = p_2 * s
    up = where(1 < s, s, 1)
    down = where(s < 1, s, 1)
    n = sqrt(y_0 * y_0 + y_1 * y_1 + y_2 * y_2)
    divisor = where(n == 0, up, n)
    size_3 = absolute(self_3)
    size_4 = absolute(self_4)
    size_5 = absolute(self_5)
    before_0a = small_g < 256
    before_0 = where(before_0a, up, down)
    before_1a = small_d < 256
    before_1 = where(before_1a, up, down)
    before_2a = small_a < 256
    before_2 = where(before_2a, up, down)
    before_3a = size_3 < 256
    before_3 = where(before_3a, up, down)
    before_4a = size_4 < 256
    before_4 = where(before_4a, up, down)
    before_5a = size_5 < 256
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
def coscrew_normalized(ci):
    """co = ci / |ci|, with coscrew_norm; the zero coscrew stays zero.

    (6)->(6).  ci, co: coscrew (f in N; τ in N m).
    18 mul, 2 add, 6 div, 1 sqrt, 9 abs, 16 less, 2 equal, 26 select.
    """
    ci_0, ci_1, ci_2, ci_3, ci_4, ci_5 = ci
    small_a = absolute(ci_2)
    small_d = absolute(ci_1)
    small_g = absolute(ci_0)
    small = where(small_g < 9.999999974752427e-07, where(small_d < 9.999999974752427e-07,
        where(small_a < 9.999999974752427e-07, real(1), real(0)), 0), 0)
    p_0a = small == 1
    p_0 = where(p_0a, ci_3, ci_0)
    p_1 = where(p_0a, ci_4, ci_1)
    p_2 = where(p_0a, ci_5, ci_2)
    s_size_0 = absolute(p_0)
    s_size_1 = absolute(p_1)
    s_size_2 = absolute(p_2)
    s_largest1 = where(s_size_0 < s_size_1, s_size_1, s_size_0)
    s_largest2 = where(s_largest1 < s_size_2, s_size_2, s_largest1)
    s_d = where(s_largest2 < 256, 1.8014398509481984e+16, where(4.611686018427388e+18 < s_largest2,
        real(2.710505431213761e-20), real(1)))
    s = where(s_largest2 < 1.4210854715202004e-14, 3.2451855365842673e+32, s_d)
    y_0 = p_0 * s
    y_1 = p_1 * s
    y_2 = p_2 * s
    up = where(1 < s, s, 1)
    down = where(s < 1, s, 1)
    n = sqrt(y_0 * y_0 + y_1 * y_1 + y_2 * y_2)
    divisor = where(n == 0, up, n)
    size_3 = absolute(ci_3)
    size_4 = absolute(ci_4)
    size_5 = absolute(ci_5)
    before_0a = small_g < 256
    before_0 = where(before_0a, up, down)
    before_1a = small_d < 256
    before_1 = where(before_1a, up, down)
    before_2a = small_a < 256
    before_2 = where(before_2a, up, down)
    before_3a = size_3 < 256
    before_3 = where(before_3a, up, down)
    before_4a = size_4 < 256
    before_4 = where(before_4a, up, down)
    before_5a = size_5 < 256
    before_5 = where(before_5a, up, down)
    after_0 = where(before_0a, down, up)
    after_1 = where(before_1a, down, up)
    after_2 = where(before_2a, down, up)
    after_3 = where(before_3a, down, up)
    after_4 = where(before_4a, down, up)
    after_5 = where(before_5a, down, up)
    sized_0 = ci_0 * before_0
    sized_1 = ci_1 * before_1
    sized_2 = ci_2 * before_2
    sized_3 = ci_3 * before_3
    sized_4 = ci_4 * before_4
    sized_5 = ci_5 * before_5
    quotient_0 = sized_0 / divisor
    quotient_1 = sized_1 / divisor
    quotient_2 = sized_2 / divisor
    quotient_3 = sized_3 / divisor
    quotient_4 = sized_4 / divisor
    quotient_5 = sized_5 / divisor
    co_0 = quotient_0 * after_0
    co_1 = quotient_1 * after_1
    co_2 = quotient_2 * after_2
    co_3 = quotient_3 * after_3
    co_4 = quotient_4 * after_4
    co_5 = quotient_5 * after_5
    return (co_0, co_1, co_2, co_3, co_4, co_5)


@kernel("(6),(6)->(6)")
def add_cct(c1, c2):
    """co = (c1.lin + c2.lin ; c1.ang).

    (6),(6)->(6).  c1, c2, co: coscrew (f in N; τ in N m).
    3 add.  Error <= u |result| + (lin: 1/32, ang: 0) u^2 S, S the sum of the |terms| of the
    expanded formula; barring over- and underflow.
    """
    c1_0, c1_1, c1_2, c1_3, c1_4, c1_5 = c1
    c2_0, c2_1, c2_2, c2_3, c2_4, c2_5 = c2
    co_0 = c1_0 + c2_0
    co_1 = c1_1 + c2_1
    co_2 = c1_2 + c2_2
    return (co_0, co_1, co_2, c1_3, c1_4, c1_5)


@kernel("(3),(6)->(6)")
def product_CoAdtc(t, ci):
    """co = [Ad]*(t) ci.

    (3),(6)->(6).  t: vector; ci, co: coscrew (f in N; τ in N m).
    6 mul, 6 add.  Error <= u |result| + (lin: 0, ang: 3/32) u^2 S, S the sum of the |terms| of
    the expanded formula; barring over- and underflow.
    """
    t_0, t_1, t_2 = t
    ci_0, ci_1, ci_2, ci_3, ci_4, ci_5 = ci
    co_3 = t_1 * ci_2 - t_2 * ci_1 + ci_3
    co_4 = t_2 * ci_0 - t_0 * ci_2 + ci_4
    co_5 = t_0 * ci_1 - t_1 * ci_0 + ci_5
    return (ci_0, ci_1, ci_2, co_3, co_4, co_5)


@kernel("(3),(6)->(6)")
def product_CoAdtinvc(t, ci):
    """co = [Ad]*(t)^-1 ci.

    (3),(6)->(6).  t: vector; ci, co: coscrew (f in N; τ in N m).
    6 mul, 6 add.  Error <= u |result| + (lin: 0, ang: 3/32) u^2 S, S the sum of the |terms| of
    the expanded formula; barring over- and underflow.
    """
    t_0, t_1, t_2 = t
    ci_0, ci_1, ci_2, ci_3, ci_4, ci_5 = ci
    co_3 = t_2 * ci_1 - t_1 * ci_2 + ci_3
    co_4 = t_0 * ci_2 - t_2 * ci_0 + ci_4
    co_5 = t_1 * ci_0 - t_0 * ci_1 + ci_5
    return (ci_0, ci_1, ci_2, co_3, co_4, co_5)


@kernel("(3),(6)->(6)")
def product_CoAdtcinv(t, ci):
    """co = [Ad]*(t) (-ci).

    (3),(6)->(6).  t: vector; ci, co: coscrew (f in N; τ in N m).
    6 mul, 6 add, 3 neg.  Error <= u |result| + (lin: 0, ang: 3/32) u^2 S, S the sum of the
    |terms| of the expanded formula; barring over- and underflow.
    """
    t_0, t_1, t_2 = t
    ci_0, ci_1, ci_2, ci_3, ci_4, ci_5 = ci
    co_0 = -ci_0
    co_1 = -ci_1
    co_2 = -ci_2
    co_3 = t_2 * ci_1 - t_1 * ci_2 - ci_3
    co_4 = t_0 * ci_2 - t_2 * ci_0 - ci_4
    co_5 = t_1 * ci_0 - t_0 * ci_1 - ci_5
    return (co_0, co_1, co_2, co_3, co_4, co_5)


@kernel("(3,3),(6)->(6)")
def product_CoAdrc(R, ci):
    """co = [Ad]*(R) ci.

    (3,3),(6)->(6).  R: rotation or other 3×3 matrix; ci, co: coscrew (f in N; τ in N m).
    18 mul, 12 add.  Error <= u |result| + 3/32 u^2 S, S the sum of the |terms| of the expanded
    formula; barring over- and underflow.
    """
    R_00, R_01, R_02, R_10, R_11, R_12, R_20, R_21, R_22 = R
    ci_0, ci_1, ci_2, ci_3, ci_4, ci_5 = ci
    co_0 = R_00 * ci_0 + R_01 * ci_1 + R_02 * ci_2
    co_1 = R_10 * ci_0 + R_11 * ci_1 + R_12 * ci_2
    co_2 = R_20 * ci_0 + R_21 * ci_1 + R_22 * ci_2
    co_3 = R_00 * ci_3 + R_01 * ci_4 + R_02 * ci_5
    co_4 = R_10 * ci_3 + R_11 * ci_4 + R_12 * ci_5
    co_5 = R_20 * ci_3 + R_21 * ci_4 + R_22 * ci_5
    return (co_0, co_1, co_2, co_3, co_4, co_5)


@kernel("(3,3),(6)->(6)")
def product_CoAdrinvc(R, ci):
    """co = [Ad]*(R)^-1 ci.

    (3,3),(6)->(6).  R: rotation or other 3×3 matrix; ci, co: coscrew (f in N; τ in N m).
    18 mul, 12 add.  Error <= u |result| + 3/32 u^2 S, S the sum of the |terms| of the expanded
    formula; barring over- and underflow.
    """
    R_00, R_01, R_02, R_10, R_11, R_12, R_20, R_21, R_22 = R
    ci_0, ci_1, ci_2, ci_3, ci_4, ci_5 = ci
    co_0 = R_00 * ci_0 + R_10 * ci_1 + R_20 * ci_2
    co_1 = R_01 * ci_0 + R_11 * ci_1 + R_21 * ci_2
    co_2 = R_02 * ci_0 + R_12 * ci_1 + R_22 * ci_2
    co_3 = R_00 * ci_3 + R_10 * ci_4 + R_20 * ci_5
    co_4 = R_01 * ci_3 + R_11 * ci_4 + R_21 * ci_5
    co_5 = R_02 * ci_3 + R_12 * ci_4 + R_22 * ci_5
    return (co_0, co_1, co_2, co_3, co_4, co_5)


@kernel("(3,3),(6)->(6)")
def product_CoAdrcinv(R, ci):
    """co = [Ad]*(R) (-ci).

    (3,3),(6)->(6).  R: rotation or other 3×3 matrix; ci, co: coscrew (f in N; τ in N m).
    18 mul, 12 add, 6 neg.  Error <= u |result| + 3/32 u^2 S, S the sum of the |terms| of the
    expanded formula; barring over- and underflow.
    """
    R_00, R_01, R_02, R_10, R_11, R_12, R_20, R_21, R_22 = R
    ci_0, ci_1, ci_2, ci_3, ci_4, ci_5 = ci
    co_0 = -(R_00 * ci_0) - R_01 * ci_1 - R_02 * ci_2
    co_1 = -(R_10 * ci_0) - R_11 * ci_1 - R_12 * ci_2
    co_2 = -(R_20 * ci_0) - R_21 * ci_1 - R_22 * ci_2
    co_3 = -(R_00 * ci_3) - R_01 * ci_4 - R_02 * ci_5
    co_4 = -(R_10 * ci_3) - R_11 * ci_4 - R_12 * ci_5
    co_5 = -(R_20 * ci_3) - R_21 * ci_4 - R_22 * ci_5
    return (co_0, co_1, co_2, co_3, co_4, co_5)


@kernel("(3,4),(6)->(6)")
def product_CoAdc(D, ci):
    """co = [Ad]*(D) ci = [Ad]*(t) [Ad]*(R) ci.

    (3,4),(6)->(6).  D: displacement [R | t], R rotation, t in m; ci, co: coscrew (f in N; τ in
    N m).
    24 mul, 18 add.  Error <= u |result| + (lin: 3/32, ang: 3/16) u^2 S, S the sum of the
    |terms| of the expanded formula; barring over- and underflow.
    """
    D_00, D_01, D_02, D_03, D_10, D_11, D_12, D_13, D_20, D_21, D_22, D_23 = D
    ci_0, ci_1, ci_2, ci_3, ci_4, ci_5 = ci
    w_0 = D_00 * ci_0 + D_01 * ci_1 + D_02 * ci_2
    w_1 = D_10 * ci_0 + D_11 * ci_1 + D_12 * ci_2
    w_2 = D_20 * ci_0 + D_21 * ci_1 + D_22 * ci_2
    w_3 = D_00 * ci_3 + D_01 * ci_4 + D_02 * ci_5
    w_4 = D_10 * ci_3 + D_11 * ci_4 + D_12 * ci_5
    w_5 = D_20 * ci_3 + D_21 * ci_4 + D_22 * ci_5
    co_3 = D_13 * w_2 - D_23 * w_1 + w_3
    co_4 = D_23 * w_0 - D_03 * w_2 + w_4
    co_5 = D_03 * w_1 - D_13 * w_0 + w_5
    return (w_0, w_1, w_2, co_3, co_4, co_5)


@kernel("(3,4),(6)->(6)")
def product_CoAdinvc(D, ci):
    """co = [Ad]*(D)^-1 ci = [Ad]*(R^T) [Ad]*(-t) ci.

    (3,4),(6)->(6).  D: displacement [R | t], R rotation, t in m; ci, co: coscrew (f in N; τ in
    N m).
    24 mul, 18 add.  Error <= u |result| + (lin: 3/32, ang: 3/16) u^2 S, S the sum of the
    |terms| of the expanded formula; barring over- and underflow.
    """
    D_00, D_01, D_02, D_03, D_10, D_11, D_12, D_13, D_20, D_21, D_22, D_23 = D
    ci_0, ci_1, ci_2, ci_3, ci_4, ci_5 = ci
    w_3 = D_23 * ci_1 - D_13 * ci_2 + ci_3
    w_4 = D_03 * ci_2 - D_23 * ci_0 + ci_4
    w_5 = D_13 * ci_0 - D_03 * ci_1 + ci_5
    co_0 = D_00 * ci_0 + D_10 * ci_1 + D_20 * ci_2
    co_1 = D_01 * ci_0 + D_11 * ci_1 + D_21 * ci_2
    co_2 = D_02 * ci_0 + D_12 * ci_1 + D_22 * ci_2
    co_3 = D_00 * w_3 + D_10 * w_4 + D_20 * w_5
    co_4 = D_01 * w_3 + D_11 * w_4 + D_21 * w_5
    co_5 = D_02 * w_3 + D_12 * w_4 + D_22 * w_5
    return (co_0, co_1, co_2, co_3, co_4, co_5)


@kernel("(3,4),(6)->(6)")
def product_CoAdcinv(D, ci):
    """co = [Ad]*(D) (-ci).

    (3,4),(6)->(6).  D: displacement [R | t], R rotation, t in m; ci, co: coscrew (f in N; τ in
    N m).
    24 mul, 18 add, 6 neg.  Error <= u |result| + (lin: 3/32, ang: 3/16) u^2 S, S the sum of the
    |terms| of the expanded formula; barring over- and underflow.
    """
    D_00, D_01, D_02, D_03, D_10, D_11, D_12, D_13, D_20, D_21, D_22, D_23 = D
    ci_0, ci_1, ci_2, ci_3, ci_4, ci_5 = ci
    w_0 = -(D_00 * ci_0) - D_01 * ci_1 - D_02 * ci_2
    w_1 = -(D_10 * ci_0) - D_11 * ci_1 - D_12 * ci_2
    w_2 = -(D_20 * ci_0) - D_21 * ci_1 - D_22 * ci_2
    w_3 = -(D_00 * ci_3) - D_01 * ci_4 - D_02 * ci_5
    w_4 = -(D_10 * ci_3) - D_11 * ci_4 - D_12 * ci_5
    w_5 = -(D_20 * ci_3) - D_21 * ci_4 - D_22 * ci_5
    co_3 = D_13 * w_2 - D_23 * w_1 + w_3
    co_4 = D_23 * w_0 - D_03 * w_2 + w_4
    co_5 = D_03 * w_1 - D_13 * w_0 + w_5
    return (w_0, w_1, w_2, co_3, co_4, co_5)


@kernel("(3,4)->(6)")
def hctx(D):
    """co = h_tx: column 0 of [Ad]*(D).

    (3,4)->(6).  D: displacement [R | t], R rotation, t in m; co: coscrew (f in N; τ in N m).
    6 mul, 3 add.  Error <= u |result| + (lin: 0, ang: 1/16) u^2 S, S the sum of the |terms| of
    the expanded formula; barring over- and underflow.
    """
    D_00, D_01, D_02, D_03, D_10, D_11, D_12, D_13, D_20, D_21, D_22, D_23 = D
    co_3 = D_20 * D_13 - D_10 * D_23
    co_4 = D_00 * D_23 - D_20 * D_03
    co_5 = D_10 * D_03 - D_00 * D_13
    return (D_00, D_10, D_20, co_3, co_4, co_5)


@kernel("(3,4)->(6)")
def hcty(D):
    """co = h_ty: column 1 of [Ad]*(D).

    (3,4)->(6).  D: displacement [R | t], R rotation, t in m; co: coscrew (f in N; τ in N m).
    6 mul, 3 add.  Error <= u |result| + (lin: 0, ang: 1/16) u^2 S, S the sum of the |terms| of
    the expanded formula; barring over- and underflow.
    """
    D_00, D_01, D_02, D_03, D_10, D_11, D_12, D_13, D_20, D_21, D_22, D_23 = D
    co_3 = D_21 * D_13 - D_11 * D_23
    co_4 = D_01 * D_23 - D_21 * D_03
    co_5 = D_11 * D_03 - D_01 * D_13
    return (D_01, D_11, D_21, co_3, co_4, co_5)


@kernel("(3,4)->(6)")
def hctz(D):
    """co = h_tz: column 2 of [Ad]*(D).

    (3,4)->(6).  D: displacement [R | t], R rotation, t in m; co: coscrew (f in N; τ in N m).
    6 mul, 3 add.  Error <= u |result| + (lin: 0, ang: 1/16) u^2 S, S the sum of the |terms| of
    the expanded formula; barring over- and underflow.
    """
    D_00, D_01, D_02, D_03, D_10, D_11, D_12, D_13, D_20, D_21, D_22, D_23 = D
    co_3 = D_22 * D_13 - D_12 * D_23
    co_4 = D_02 * D_23 - D_22 * D_03
    co_5 = D_12 * D_03 - D_02 * D_13
    return (D_02, D_12, D_22, co_3, co_4, co_5)


@kernel("(3,4)->(6)")
def hctxinv(D):
    """co = -h_tx: -column 0 of [Ad]*(D).

    (3,4)->(6).  D: displacement [R | t], R rotation, t in m; co: coscrew (f in N; τ in N m).
    6 mul, 3 add, 3 neg.  Error <= u |result| + (lin: 0, ang: 1/16) u^2 S, S the sum of the
    |terms| of the expanded formula; barring over- and underflow.
    """
    D_00, D_01, D_02, D_03, D_10, D_11, D_12, D_13, D_20, D_21, D_22, D_23 = D
    co_0 = -D_00
    co_1 = -D_10
    co_2 = -D_20
    co_3 = D_10 * D_23 - D_20 * D_13
    co_4 = D_20 * D_03 - D_00 * D_23
    co_5 = D_00 * D_13 - D_10 * D_03
    return (co_0, co_1, co_2, co_3, co_4, co_5)


@kernel("(3,4)->(6)")
def hctyinv(D):
    """co = -h_ty: -column 1 of [Ad]*(D).

    (3,4)->(6).  D: displacement [R | t], R rotation, t in m; co: coscrew (f in N; τ in N m).
    6 mul, 3 add, 3 neg.  Error <= u |result| + (lin: 0, ang: 1/16) u^2 S, S the sum of the
    |terms| of the expanded formula; barring over- and underflow.
    """
    D_00, D_01, D_02, D_03, D_10, D_11, D_12, D_13, D_20, D_21, D_22, D_23 = D
    co_0 = -D_01
    co_1 = -D_11
    co_2 = -D_21
    co_3 = D_11 * D_23 - D_21 * D_13
    co_4 = D_21 * D_03 - D_01 * D_23
    co_5 = D_01 * D_13 - D_11 * D_03
    return (co_0, co_1, co_2, co_3, co_4, co_5)


@kernel("(3,4)->(6)")
def hctzinv(D):
    """co = -h_tz: -column 2 of [Ad]*(D).

    (3,4)->(6).  D: displacement [R | t], R rotation, t in m; co: coscrew (f in N; τ in N m).
    6 mul, 3 add, 3 neg.  Error <= u |result| + (lin: 0, ang: 1/16) u^2 S, S the sum of the
    |terms| of the expanded formula; barring over- and underflow.
    """
    D_00, D_01, D_02, D_03, D_10, D_11, D_12, D_13, D_20, D_21, D_22, D_23 = D
    co_0 = -D_02
    co_1 = -D_12
    co_2 = -D_22
    co_3 = D_12 * D_23 - D_22 * D_13
    co_4 = D_22 * D_03 - D_02 * D_23
    co_5 = D_02 * D_13 - D_12 * D_03
    return (co_0, co_1, co_2, co_3, co_4, co_5)


@kernel("(3,4)->(6,6)")
def CoAd(D):
    """M = [Ad]*(D).

    (3,4)->(6,6).  D: displacement [R | t], R rotation, t in m; M: 6×6 operator.
    18 mul, 9 add.  Error <= u |result| + 1/16 u^2 S, S the sum of the |terms| of the expanded
    formula; barring over- and underflow.
    """
    D_00, D_01, D_02, D_03, D_10, D_11, D_12, D_13, D_20, D_21, D_22, D_23 = D
    M_30 = D_20 * D_13 - D_10 * D_23
    M_31 = D_21 * D_13 - D_11 * D_23
    M_32 = D_22 * D_13 - D_12 * D_23
    M_40 = D_00 * D_23 - D_20 * D_03
    M_41 = D_01 * D_23 - D_21 * D_03
    M_42 = D_02 * D_23 - D_22 * D_03
    M_50 = D_10 * D_03 - D_00 * D_13
    M_51 = D_11 * D_03 - D_01 * D_13
    M_52 = D_12 * D_03 - D_02 * D_13
    return (D_00, D_01, D_02, 0, 0, 0, D_10, D_11, D_12, 0, 0, 0, D_20, D_21, D_22, 0, 0, 0, M_30,
        M_31, M_32, D_00, D_01, D_02, M_40, M_41, M_42, D_10, D_11, D_12, M_50, M_51, M_52, D_20,
        D_21, D_22)


@kernel("(6),(6)->()")
def reciprocal_product(c, x):
    """power = W ⊙ $ = f·v + τ·ω, W = c = (f; τ), $ = x = (ω; v).

    (6),(6)->().  c: coscrew (f in N; τ in N m); x: six components with the angular part on top;
    power: number.
    6 mul, 5 add.  Error <= u |result| + 1/8 u^2 S, S the sum of the |terms| of the expanded
    formula; barring over- and underflow.
    """
    c_0, c_1, c_2, c_3, c_4, c_5 = c
    x_0, x_1, x_2, x_3, x_4, x_5 = x
    power = c_0 * x_3 + c_1 * x_4 + c_2 * x_5 + (c_3 * x_0 + c_4 * x_1 + c_5 * x_2)
    return power


@kernel("(6),(6)->(6)")
def cross_sc(s, c):
    """co = [ad]*(s) c = (ω×f ; v×f + ω×τ).

    (6),(6)->(6).  s: screw (v in m/s; ω in rad/s); c, co: coscrew (f in N; τ in N m).
    18 mul, 12 add.  Error <= u |result| + (lin: 1/16, ang: 3/32) u^2 S, S the sum of the
    |terms| of the expanded formula; barring over- and underflow.
    """
    s_0, s_1, s_2, s_3, s_4, s_5 = s
    c_0, c_1, c_2, c_3, c_4, c_5 = c
    co_0 = s_4 * c_2 - s_5 * c_1
    co_1 = s_5 * c_0 - s_3 * c_2
    co_2 = s_3 * c_1 - s_4 * c_0
    co_3 = s_1 * c_2 - s_2 * c_1 + (s_4 * c_5 - s_5 * c_4)
    co_4 = s_2 * c_0 - s_0 * c_2 + (s_5 * c_3 - s_3 * c_5)
    co_5 = s_0 * c_1 - s_1 * c_0 + (s_3 * c_4 - s_4 * c_3)
    return (co_0, co_1, co_2, co_3, co_4, co_5)


@kernel("(6),(6)->(6)")
def cross_sca(s, c):
    """co = (0 ; ω×τ).

    (6),(6)->(6).  s: screw (v in m/s; ω in rad/s); c, co: coscrew (f in N; τ in N m).
    6 mul, 3 add.  Error <= u |result| + (lin: 0, ang: 1/16) u^2 S, S the sum of the |terms| of
    the expanded formula; barring over- and underflow.
    """
    s_0, s_1, s_2, s_3, s_4, s_5 = s
    c_0, c_1, c_2, c_3, c_4, c_5 = c
    co_3 = s_4 * c_5 - s_5 * c_4
    co_4 = s_5 * c_3 - s_3 * c_5
    co_5 = s_3 * c_4 - s_4 * c_3
    return (0, 0, 0, co_3, co_4, co_5)


@kernel("(3,4),(6)->(6)")
def constraint_ctx(D, c):
    """co = H̄* c = [Ad]*(D) P c; P clears component 0 of c, given in the frame of a tx joint at D.

    (3,4),(6)->(6).  D: displacement [R | t], R rotation, t in m; c, co: coscrew (f in N; τ in N
    m).
    21 mul, 15 add.  Error <= u |result| + (lin: 1/16, ang: 5/32) u^2 S, S the sum of the
    |terms| of the expanded formula; barring over- and underflow.
    """
    D_00, D_01, D_02, D_03, D_10, D_11, D_12, D_13, D_20, D_21, D_22, D_23 = D
    c_0, c_1, c_2, c_3, c_4, c_5 = c
    w_0 = D_01 * c_1 + D_02 * c_2
    w_1 = D_11 * c_1 + D_12 * c_2
    w_2 = D_21 * c_1 + D_22 * c_2
    w_3 = D_00 * c_3 + D_01 * c_4 + D_02 * c_5
    w_4 = D_10 * c_3 + D_11 * c_4 + D_12 * c_5
    w_5 = D_20 * c_3 + D_21 * c_4 + D_22 * c_5
    co_3 = D_13 * w_2 - D_23 * w_1 + w_3
    co_4 = D_23 * w_0 - D_03 * w_2 + w_4
    co_5 = D_03 * w_1 - D_13 * w_0 + w_5
    return (w_0, w_1, w_2, co_3, co_4, co_5)


@kernel("(3,4),(6)->(6)")
def constraint_cty(D, c):
    """co = H̄* c = [Ad]*(D) P c; P clears component 1 of c, given in the frame of a ty joint at D.

    (3,4),(6)->(6).  D: displacement [R | t], R rotation, t in m; c, co: coscrew (f in N; τ in N
    m).
    21 mul, 15 add.  Error <= u |result| + (lin: 1/16, ang: 5/32) u^2 S, S the sum of the
    |terms| of the expanded formula; barring over- and underflow.
    """
    D_00, D_01, D_02, D_03, D_10, D_11, D_12, D_13, D_20, D_21, D_22, D_23 = D
    c_0, c_1, c_2, c_3, c_4, c_5 = c
    w_0 = D_00 * c_0 + D_02 * c_2
    w_1 = D_10 * c_0 + D_12 * c_2
    w_2 = D_20 * c_0 + D_22 * c_2
    w_3 = D_00 * c_3 + D_01 * c_4 + D_02 * c_5
    w_4 = D_10 * c_3 + D_11 * c_4 + D_12 * c_5
    w_5 = D_20 * c_3 + D_21 * c_4 + D_22 * c_5
    co_3 = D_13 * w_2 - D_23 * w_1 + w_3
    co_4 = D_23 * w_0 - D_03 * w_2 + w_4
    co_5 = D_03 * w_1 - D_13 * w_0 + w_5
    return (w_0, w_1, w_2, co_3, co_4, co_5)


@kernel("(3,4),(6)->(6)")
def constraint_ctz(D, c):
    """co = H̄* c = [Ad]*(D) P c; P clears component 2 of c, given in the frame of a tz joint at D.

    (3,4),(6)->(6).  D: displacement [R | t], R rotation, t in m; c, co: coscrew (f in N; τ in N
    m).
    21 mul, 15 add.  Error <= u |result| + (lin: 1/16, ang: 5/32) u^2 S, S the sum of the
    |terms| of the expanded formula; barring over- and underflow.
    """
    D_00, D_01, D_02, D_03, D_10, D_11, D_12, D_13, D_20, D_21, D_22, D_23 = D
    c_0, c_1, c_2, c_3, c_4, c_5 = c
    w_0 = D_00 * c_0 + D_01 * c_1
    w_1 = D_10 * c_0 + D_11 * c_1
    w_2 = D_20 * c_0 + D_21 * c_1
    w_3 = D_00 * c_3 + D_01 * c_4 + D_02 * c_5
    w_4 = D_10 * c_3 + D_11 * c_4 + D_12 * c_5
    w_5 = D_20 * c_3 + D_21 * c_4 + D_22 * c_5
    co_3 = D_13 * w_2 - D_23 * w_1 + w_3
    co_4 = D_23 * w_0 - D_03 * w_2 + w_4
    co_5 = D_03 * w_1 - D_13 * w_0 + w_5
    return (w_0, w_1, w_2, co_3, co_4, co_5)


@kernel("(3,4),(6)->(6)")
def constraint_crx(D, c):
    """co = H̄* c = [Ad]*(D) P c; P clears component 3 of c, given in the frame of a rx joint at D.

    (3,4),(6)->(6).  D: displacement [R | t], R rotation, t in m; c, co: coscrew (f in N; τ in N
    m).
    21 mul, 15 add.  Error <= u |result| + (lin: 3/32, ang: 3/16) u^2 S, S the sum of the
    |terms| of the expanded formula; barring over- and underflow.
    """
    D_00, D_01, D_02, D_03, D_10, D_11, D_12, D_13, D_20, D_21, D_22, D_23 = D
    c_0, c_1, c_2, c_3, c_4, c_5 = c
    w_0 = D_00 * c_0 + D_01 * c_1 + D_02 * c_2
    w_1 = D_10 * c_0 + D_11 * c_1 + D_12 * c_2
    w_2 = D_20 * c_0 + D_21 * c_1 + D_22 * c_2
    w_3 = D_01 * c_4 + D_02 * c_5
    w_4 = D_11 * c_4 + D_12 * c_5
    w_5 = D_21 * c_4 + D_22 * c_5
    co_3 = D_13 * w_2 - D_23 * w_1 + w_3
    co_4 = D_23 * w_0 - D_03 * w_2 + w_4
    co_5 = D_03 * w_1 - D_13 * w_0 + w_5
    return (w_0, w_1, w_2, co_3, co_4, co_5)


@kernel("(3,4),(6)->(6)")
def constraint_cry(D, c):
    """co = H̄* c = [Ad]*(D) P c; P clears component 4 of c, given in the frame of a ry joint at D.

    (3,4),(6)->(6).  D: displacement [R | t], R rotation, t in m; c, co: coscrew (f in N; τ in N
    m).
    21 mul, 15 add.  Error <= u |result| + (lin: 3/32, ang: 3/16) u^2 S, S the sum of the
    |terms| of the expanded formula; barring over- and underflow.
    """
    D_00, D_01, D_02, D_03, D_10, D_11, D_12, D_13, D_20, D_21, D_22, D_23 = D
    c_0, c_1, c_2, c_3, c_4, c_5 = c
    w_0 = D_00 * c_0 + D_01 * c_1 + D_02 * c_2
    w_1 = D_10 * c_0 + D_11 * c_1 + D_12 * c_2
    w_2 = D_20 * c_0 + D_21 * c_1 + D_22 * c_2
    w_3 = D_00 * c_3 + D_02 * c_5
    w_4 = D_10 * c_3 + D_12 * c_5
    w_5 = D_20 * c_3 + D_22 * c_5
    co_3 = D_13 * w_2 - D_23 * w_1 + w_3
    co_4 = D_23 * w_0 - D_03 * w_2 + w_4
    co_5 = D_03 * w_1 - D_13 * w_0 + w_5
    return (w_0, w_1, w_2, co_3, co_4, co_5)


@kernel("(3,4),(6)->(6)")
def constraint_crz(D, c):
    """co = H̄* c = [Ad]*(D) P c; P clears component 5 of c, given in the frame of a rz joint at D.

    (3,4),(6)->(6).  D: displacement [R | t], R rotation, t in m; c, co: coscrew (f in N; τ in N
    m).
    21 mul, 15 add.  Error <= u |result| + (lin: 3/32, ang: 3/16) u^2 S, S the sum of the
    |terms| of the expanded formula; barring over- and underflow.
    """
    D_00, D_01, D_02, D_03, D_10, D_11, D_12, D_13, D_20, D_21, D_22, D_23 = D
    c_0, c_1, c_2, c_3, c_4, c_5 = c
    w_0 = D_00 * c_0 + D_01 * c_1 + D_02 * c_2
    w_1 = D_10 * c_0 + D_11 * c_1 + D_12 * c_2
    w_2 = D_20 * c_0 + D_21 * c_1 + D_22 * c_2
    w_3 = D_00 * c_3 + D_01 * c_4
    w_4 = D_10 * c_3 + D_11 * c_4
    w_5 = D_20 * c_3 + D_21 * c_4
    co_3 = D_13 * w_2 - D_23 * w_1 + w_3
    co_4 = D_23 * w_0 - D_03 * w_2 + w_4
    co_5 = D_03 * w_1 - D_13 * w_0 + w_5
    return (w_0, w_1, w_2, co_3, co_4, co_5)


@kernel("(3,4),(6)->(6)")
def working_ctx(D, c):
    """co = h̄* c = [Ad]*(D) P c; P keeps component 0 of c, given in the frame of a tx joint at D.

    (3,4),(6)->(6).  D: displacement [R | t], R rotation, t in m; c, co: coscrew (f in N; τ in N
    m).
    9 mul, 3 add.  Error <= u |result| + (lin: 1/32, ang: 3/32) u^2 S, S the sum of the |terms|
    of the expanded formula; barring over- and underflow.
    """
    D_00, D_01, D_02, D_03, D_10, D_11, D_12, D_13, D_20, D_21, D_22, D_23 = D
    c_0, c_1, c_2, c_3, c_4, c_5 = c
    w_0 = D_00 * c_0
    w_1 = D_10 * c_0
    w_2 = D_20 * c_0
    co_3 = D_13 * w_2 - D_23 * w_1
    co_4 = D_23 * w_0 - D_03 * w_2
    co_5 = D_03 * w_1 - D_13 * w_0
    return (w_0, w_1, w_2, co_3, co_4, co_5)


@kernel("(3,4),(6)->(6)")
def working_cty(D, c):
    """co = h̄* c = [Ad]*(D) P c; P keeps component 1 of c, given in the frame of a ty joint at D.

    (3,4),(6)->(6).  D: displacement [R | t], R rotation, t in m; c, co: coscrew (f in N; τ in N
    m).
    9 mul, 3 add.  Error <= u |result| + (lin: 1/32, ang: 3/32) u^2 S, S the sum of the |terms|
    of the expanded formula; barring over- and underflow.
    """
    D_00, D_01, D_02, D_03, D_10, D_11, D_12, D_13, D_20, D_21, D_22, D_23 = D
    c_0, c_1, c_2, c_3, c_4, c_5 = c
    w_0 = D_01 * c_1
    w_1 = D_11 * c_1
    w_2 = D_21 * c_1
    co_3 = D_13 * w_2 - D_23 * w_1
    co_4 = D_23 * w_0 - D_03 * w_2
    co_5 = D_03 * w_1 - D_13 * w_0
    return (w_0, w_1, w_2, co_3, co_4, co_5)


@kernel("(3,4),(6)->(6)")
def working_ctz(D, c):
    """co = h̄* c = [Ad]*(D) P c; P keeps component 2 of c, given in the frame of a tz joint at D.

    (3,4),(6)->(6).  D: displacement [R | t], R rotation, t in m; c, co: coscrew (f in N; τ in N
    m).
    9 mul, 3 add.  Error <= u |result| + (lin: 1/32, ang: 3/32) u^2 S, S the sum of the |terms|
    of the expanded formula; barring over- and underflow.
    """
    D_00, D_01, D_02, D_03, D_10, D_11, D_12, D_13, D_20, D_21, D_22, D_23 = D
    c_0, c_1, c_2, c_3, c_4, c_5 = c
    w_0 = D_02 * c_2
    w_1 = D_12 * c_2
    w_2 = D_22 * c_2
    co_3 = D_13 * w_2 - D_23 * w_1
    co_4 = D_23 * w_0 - D_03 * w_2
    co_5 = D_03 * w_1 - D_13 * w_0
    return (w_0, w_1, w_2, co_3, co_4, co_5)


@kernel("(3,4),(6)->(6)")
def working_crx(D, c):
    """co = h̄* c = [Ad]*(D) P c; P keeps component 3 of c, given in the frame of a rx joint at D.

    (3,4),(6)->(6).  D: displacement [R | t], R rotation, t in m; c, co: coscrew (f in N; τ in N
    m).
    3 mul.  Error <= u |result| + (lin: 0, ang: 1/32) u^2 S, S the sum of the |terms| of the
    expanded formula; barring over- and underflow.
    """
    D_00, D_01, D_02, D_03, D_10, D_11, D_12, D_13, D_20, D_21, D_22, D_23 = D
    c_0, c_1, c_2, c_3, c_4, c_5 = c
    w_3 = D_00 * c_3
    w_4 = D_10 * c_3
    w_5 = D_20 * c_3
    return (0, 0, 0, w_3, w_4, w_5)


@kernel("(3,4),(6)->(6)")
def working_cry(D, c):
    """co = h̄* c = [Ad]*(D) P c; P keeps component 4 of c, given in the frame of a ry joint at D.

    (3,4),(6)->(6).  D: displacement [R | t], R rotation, t in m; c, co: coscrew (f in N; τ in N
    m).
    3 mul.  Error <= u |result| + (lin: 0, ang: 1/32) u^2 S, S the sum of the |terms| of the
    expanded formula; barring over- and underflow.
    """
    D_00, D_01, D_02, D_03, D_10, D_11, D_12, D_13, D_20, D_21, D_22, D_23 = D
    c_0, c_1, c_2, c_3, c_4, c_5 = c
    w_3 = D_01 * c_4
    w_4 = D_11 * c_4
    w_5 = D_21 * c_4
    return (0, 0, 0, w_3, w_4, w_5)


@kernel("(3,4),(6)->(6)")
def working_crz(D, c):
    """co = h̄* c = [Ad]*(D) P c; P keeps component 5 of c, given in the frame of a rz joint at D.

    (3,4),(6)->(6).  D: displacement [R | t], R rotation, t in m; c, co: coscrew (f in N; τ in N
    m).
    3 mul.  Error <= u |result| + (lin: 0, ang: 1/32) u^2 S, S the sum of the |terms| of the
    expanded formula; barring over- and underflow.
    """
    D_00, D_01, D_02, D_03, D_10, D_11, D_12, D_13, D_20, D_21, D_22, D_23 = D
    c_0, c_1, c_2, c_3, c_4, c_5 = c
    w_3 = D_02 * c_5
    w_4 = D_12 * c_5
    w_5 = D_22 * c_5
    return (0, 0, 0, w_3, w_4, w_5)
