# Made by `coscrew generate`; changes are overwritten.
# SPDX-License-Identifier: MIT
# coscrew 0.2.0.  Copyright (c) 2026 The coscrew authors.
"""Screws: twists, spatial velocities and accelerations, s = (v; ω).

In double precision, accurate tier.
"""

from numpy import absolute, float64 as real, sqrt, where
from coscrew._exact import product_error, product_rest
from coscrew._kernel import double_kernel as kernel


@kernel("(6),()->(6)")
def screw_scale(self, a):
    """self = a self.

    (6),()->(6).  self: screw (v in m/s; ω in rad/s); a: number.
    6 mul, 6 add, 6 product error.  Error <= u |result|, barring over- and underflow.
    """
    self_0, self_1, self_2, self_3, self_4, self_5 = self
    self_0_new = self_0 * a
    self_1_new = self_1 * a
    self_2_new = self_2 * a
    self_3_new = self_3 * a
    self_4_new = self_4 * a
    self_5_new = self_5 * a
    self_0_new_rounded = self_0_new + product_error(self_0, a, self_0_new)
    self_1_new_rounded = self_1_new + product_error(self_1, a, self_1_new)
    self_2_new_rounded = self_2_new + product_error(self_2, a, self_2_new)
    self_3_new_rounded = self_3_new + product_error(self_3, a, self_3_new)
    self_4_new_rounded = self_4_new + product_error(self_4, a, self_4_new)
    self_5_new_rounded = self_5_new + product_error(self_5, a, self_5_new)
    return (self_0_new_rounded, self_1_new_rounded, self_2_new_rounded, self_3_new_rounded,
        self_4_new_rounded, self_5_new_rounded)


@kernel("(),(6),(6)->(6)")
def axpy_ss(a, x, y):
    """y = a x + y.

    (),(6),(6)->(6).  a: number; x, y: screw (v in m/s; ω in rad/s).
    6 mul, 36 add, 6 product rest.  Error <= u |result| + 3 u^2 S, S the sum of the |terms| of
    the expanded formula; barring over- and underflow.
    """
    x_0, x_1, x_2, x_3, x_4, x_5 = x
    y_0, y_1, y_2, y_3, y_4, y_5 = y
    y_0_new_a = a * x_0
    y_0_new = y_0_new_a + y_0
    y_0_new_right = y_0_new - y_0_new_a
    y_1_new_a = a * x_1
    y_1_new = y_1_new_a + y_1
    y_1_new_right = y_1_new - y_1_new_a
    y_2_new_a = a * x_2
    y_2_new = y_2_new_a + y_2
    y_2_new_right = y_2_new - y_2_new_a
    y_3_new_a = a * x_3
    y_3_new = y_3_new_a + y_3
    y_3_new_right = y_3_new - y_3_new_a
    y_4_new_a = a * x_4
    y_4_new = y_4_new_a + y_4
    y_4_new_right = y_4_new - y_4_new_a
    y_5_new_a = a * x_5
    y_5_new = y_5_new_a + y_5
    y_5_new_right = y_5_new - y_5_new_a
    y_0_new_rounded = (y_0_new
        + (product_rest(a, x_0, y_0_new_a, y_0_new - y_0_new_right) + (y_0 - y_0_new_right)))
    y_1_new_rounded = (y_1_new
        + (product_rest(a, x_1, y_1_new_a, y_1_new - y_1_new_right) + (y_1 - y_1_new_right)))
    y_2_new_rounded = (y_2_new
        + (product_rest(a, x_2, y_2_new_a, y_2_new - y_2_new_right) + (y_2 - y_2_new_right)))
    y_3_new_rounded = (y_3_new
        + (product_rest(a, x_3, y_3_new_a, y_3_new - y_3_new_right) + (y_3 - y_3_new_right)))
    y_4_new_rounded = (y_4_new
        + (product_rest(a, x_4, y_4_new_a, y_4_new - y_4_new_right) + (y_4 - y_4_new_right)))
    y_5_new_rounded = (y_5_new
        + (product_rest(a, x_5, y_5_new_a, y_5_new - y_5_new_right) + (y_5 - y_5_new_right)))
    return (y_0_new_rounded, y_1_new_rounded, y_2_new_rounded, y_3_new_rounded, y_4_new_rounded,
        y_5_new_rounded)


@kernel("(6),(6)->(6)")
def xpy_ss(x, y):
    """y = x + y.

    (6),(6)->(6).  x, y: screw (v in m/s; ω in rad/s).
    42 add.  Error <= u |result|, barring over- and underflow.
    """
    x_0, x_1, x_2, x_3, x_4, x_5 = x
    y_0, y_1, y_2, y_3, y_4, y_5 = y
    y_0_new = x_0 + y_0
    y_0_new_right = y_0_new - x_0
    y_1_new = x_1 + y_1
    y_1_new_right = y_1_new - x_1
    y_2_new = x_2 + y_2
    y_2_new_right = y_2_new - x_2
    y_3_new = x_3 + y_3
    y_3_new_right = y_3_new - x_3
    y_4_new = x_4 + y_4
    y_4_new_right = y_4_new - x_4
    y_5_new = x_5 + y_5
    y_5_new_right = y_5_new - x_5
    y_0_new_rounded = y_0_new + (x_0 - (y_0_new - y_0_new_right) + (y_0 - y_0_new_right))
    y_1_new_rounded = y_1_new + (x_1 - (y_1_new - y_1_new_right) + (y_1 - y_1_new_right))
    y_2_new_rounded = y_2_new + (x_2 - (y_2_new - y_2_new_right) + (y_2 - y_2_new_right))
    y_3_new_rounded = y_3_new + (x_3 - (y_3_new - y_3_new_right) + (y_3 - y_3_new_right))
    y_4_new_rounded = y_4_new + (x_4 - (y_4_new - y_4_new_right) + (y_4 - y_4_new_right))
    y_5_new_rounded = y_5_new + (x_5 - (y_5_new - y_5_new_right) + (y_5 - y_5_new_right))
    return (y_0_new_rounded, y_1_new_rounded, y_2_new_rounded, y_3_new_rounded, y_4_new_rounded,
        y_5_new_rounded)


@kernel("(6),(6)->(6)")
def nxpy_ss(x, y):
    """y = -x + y.

    (6),(6)->(6).  x, y: screw (v in m/s; ω in rad/s).
    42 add.  Error <= u |result|, barring over- and underflow.
    """
    x_0, x_1, x_2, x_3, x_4, x_5 = x
    y_0, y_1, y_2, y_3, y_4, y_5 = y
    y_0_new = y_0 - x_0
    y_0_new_right = y_0 - y_0_new
    y_1_new = y_1 - x_1
    y_1_new_right = y_1 - y_1_new
    y_2_new = y_2 - x_2
    y_2_new_right = y_2 - y_2_new
    y_3_new = y_3 - x_3
    y_3_new_right = y_3 - y_3_new
    y_4_new = y_4 - x_4
    y_4_new_right = y_4 - y_4_new
    y_5_new = y_5 - x_5
    y_5_new_right = y_5 - y_5_new
    y_0_new_rounded = y_0_new + (y_0 - (y_0_new + y_0_new_right) - (x_0 - y_0_new_right))
    y_1_new_rounded = y_1_new + (y_1 - (y_1_new + y_1_new_right) - (x_1 - y_1_new_right))
    y_2_new_rounded = y_2_new + (y_2 - (y_2_new + y_2_new_right) - (x_2 - y_2_new_right))
    y_3_new_rounded = y_3_new + (y_3 - (y_3_new + y_3_new_right) - (x_3 - y_3_new_right))
    y_4_new_rounded = y_4_new + (y_4 - (y_4_new + y_4_new_right) - (x_4 - y_4_new_right))
    y_5_new_rounded = y_5_new + (y_5 - (y_5_new + y_5_new_right) - (x_5 - y_5_new_right))
    return (y_0_new_rounded, y_1_new_rounded, y_2_new_rounded, y_3_new_rounded, y_4_new_rounded,
        y_5_new_rounded)


@kernel("(),(6)->(6)")
def product_as(a, si):
    """so = a si.

    (),(6)->(6).  a: number; si, so: screw (v in m/s; ω in rad/s).
    6 mul, 6 add, 6 product error.  Error <= u |result|, barring over- and underflow.
    """
    si_0, si_1, si_2, si_3, si_4, si_5 = si
    so_0 = a * si_0
    so_1 = a * si_1
    so_2 = a * si_2
    so_3 = a * si_3
    so_4 = a * si_4
    so_5 = a * si_5
    so_0_rounded = so_0 + product_error(a, si_0, so_0)
    so_1_rounded = so_1 + product_error(a, si_1, so_1)
    so_2_rounded = so_2 + product_error(a, si_2, so_2)
    so_3_rounded = so_3 + product_error(a, si_3, so_3)
    so_4_rounded = so_4 + product_error(a, si_4, so_4)
    so_5_rounded = so_5 + product_error(a, si_5, so_5)
    return (so_0_rounded, so_1_rounded, so_2_rounded, so_3_rounded, so_4_rounded, so_5_rounded)


@kernel("(6),(6)->(6)")
def add_ss(s1, s2):
    """so = s1 + s2.

    (6),(6)->(6).  s1, s2, so: screw (v in m/s; ω in rad/s).
    42 add.  Error <= u |result|, barring over- and underflow.
    """
    s1_0, s1_1, s1_2, s1_3, s1_4, s1_5 = s1
    s2_0, s2_1, s2_2, s2_3, s2_4, s2_5 = s2
    so_0 = s1_0 + s2_0
    so_0_right = so_0 - s1_0
    so_1 = s1_1 + s2_1
    so_1_right = so_1 - s1_1
    so_2 = s1_2 + s2_2
    so_2_right = so_2 - s1_2
    so_3 = s1_3 + s2_3
    so_3_right = so_3 - s1_3
    so_4 = s1_4 + s2_4
    so_4_right = so_4 - s1_4
    so_5 = s1_5 + s2_5
    so_5_right = so_5 - s1_5
    so_0_rounded = so_0 + (s1_0 - (so_0 - so_0_right) + (s2_0 - so_0_right))
    so_1_rounded = so_1 + (s1_1 - (so_1 - so_1_right) + (s2_1 - so_1_right))
    so_2_rounded = so_2 + (s1_2 - (so_2 - so_2_right) + (s2_2 - so_2_right))
    so_3_rounded = so_3 + (s1_3 - (so_3 - so_3_right) + (s2_3 - so_3_right))
    so_4_rounded = so_4 + (s1_4 - (so_4 - so_4_right) + (s2_4 - so_4_right))
    so_5_rounded = so_5 + (s1_5 - (so_5 - so_5_right) + (s2_5 - so_5_right))
    return (so_0_rounded, so_1_rounded, so_2_rounded, so_3_rounded, so_4_rounded, so_5_rounded)


@kernel("(6),(6)->(6)")
def subtract_ss(s1, s2):
    """so = s1 - s2.

    (6),(6)->(6).  s1, s2, so: screw (v in m/s; ω in rad/s).
    42 add.  Error <= u |result|, barring over- and underflow.
    """
    s1_0, s1_1, s1_2, s1_3, s1_4, s1_5 = s1
    s2_0, s2_1, s2_2, s2_3, s2_4, s2_5 = s2
    so_0 = s1_0 - s2_0
    so_0_right = s1_0 - so_0
    so_1 = s1_1 - s2_1
    so_1_right = s1_1 - so_1
    so_2 = s1_2 - s2_2
    so_2_right = s1_2 - so_2
    so_3 = s1_3 - s2_3
    so_3_right = s1_3 - so_3
    so_4 = s1_4 - s2_4
    so_4_right = s1_4 - so_4
    so_5 = s1_5 - s2_5
    so_5_right = s1_5 - so_5
    so_0_rounded = so_0 + (s1_0 - (so_0 + so_0_right) - (s2_0 - so_0_right))
    so_1_rounded = so_1 + (s1_1 - (so_1 + so_1_right) - (s2_1 - so_1_right))
    so_2_rounded = so_2 + (s1_2 - (so_2 + so_2_right) - (s2_2 - so_2_right))
    so_3_rounded = so_3 + (s1_3 - (so_3 + so_3_right) - (s2_3 - so_3_right))
    so_4_rounded = so_4 + (s1_4 - (so_4 + so_4_right) - (s2_4 - so_4_right))
    so_5_rounded = so_5 + (s1_5 - (so_5 + so_5_right) - (s2_5 - so_5_right))
    return (so_0_rounded, so_1_rounded, so_2_rounded, so_3_rounded, so_4_rounded, so_5_rounded)


@kernel("(6)->()")
def screw_norm(si):
    """|si|: |ω|, or |v| where every |ω_i| is below 1e-9 (single: 1e-6).

    (6)->().  si: screw (v in m/s; ω in rad/s); norm: number.
    10 mul, 29 add, 1 product error, 3 product rest, 2 div, 1 sqrt, 6 abs, 11 less, 3 equal, 16
    select.
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
    n_a = y_0 * y_0
    n_b = y_1 * y_1
    n_c = n_a + n_b
    n_c_right = n_c - n_a
    n_d = y_2 * y_2
    n_e = n_c + n_d
    n_e_right = n_e - n_c
    n_c_lo = product_rest(y_0, y_0, n_a, n_c - n_c_right) + product_rest(y_1, y_1, n_b, n_c_right)
    n_e_lo = n_c - (n_e - n_e_right) + product_rest(y_2, y_2, n_d, n_e_right) + n_c_lo
    n_e_sum = n_e + n_e_lo
    n_e_sum_right = n_e_sum - n_e
    n = sqrt(n_e_sum)
    n_product = n * n
    n_lo = ((n_e_sum - n_product - product_error(n, n, n_product)
        + (n_e - (n_e_sum - n_e_sum_right) + (n_e_lo - n_e_sum_right))) / where(n == 0, 1, n + n))
    r_d = where(1 < s, 7.637340908749012e-152, where(s < 1, real(2.6815615859885194e+154), real(1)))
    r = where(1.3093562431584567e+151 < s, 9.332636185032189e-302, r_d)
    n_sum = n + n_lo
    n_sum_right = n_sum - n
    norm = n_sum * r
    norm_rounded = (norm
        + (n_sum - norm * (1 / r) + (n - (n_sum - n_sum_right) + (n_lo - n_sum_right))) * r)
    norm_final = where(norm_rounded == norm_rounded, norm_rounded, norm)
    return norm_final


@kernel("(6)->(6)")
def screw_normalize(self):
    """self = self / |self|, with screw_norm; the zero screw stays zero.

    (6)->(6).  self: screw (v in m/s; ω in rad/s).
    43 mul, 104 add, 7 product error, 3 product rest, 19 div, 1 sqrt, 9 abs, 16 less, 9 equal,
    34 select.
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
    n_a = y_0 * y_0
    n_b = y_1 * y_1
    n_c = n_a + n_b
    n_c_right = n_c - n_a
    n_d = y_2 * y_2
    n_e = n_c + n_d
    n_e_right = n_e - n_c
    n_c_lo = product_rest(y_0, y_0, n_a, n_c - n_c_right) + product_rest(y_1, y_1, n_b, n_c_right)
    n_e_lo = n_c - (n_e - n_e_right) + product_rest(y_2, y_2, n_d, n_e_right) + n_c_lo
    n_e_sum = n_e + n_e_lo
    n_e_sum_right = n_e_sum - n_e
    n = sqrt(n_e_sum)
    n_product = n * n
    n_lo = ((n_e_sum - n_product - product_error(n, n, n_product)
        + (n_e - (n_e_sum - n_e_sum_right) + (n_e_lo - n_e_sum_right))) / where(n == 0, 1, n + n))
    n_sum = n + n_lo
    n_sum_right = n_sum - n
    divisor_a = n_sum == 0
    divisor = where(divisor_a, up, n_sum)
    divisor_lo = where(divisor_a, 0, n - (n_sum - n_sum_right) + (n_lo - n_sum_right))
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
    divisor_sum = divisor + divisor_lo
    divisor_sum_right = divisor_sum - divisor
    divisor_sum_lo = divisor - (divisor_sum - divisor_sum_right) + (divisor_lo - divisor_sum_right)
    quotient_0 = sized_0 / divisor_sum
    quotient_0_product = quotient_0 * divisor_sum
    quotient_0_residual = (sized_0 - quotient_0_product
        - product_error(quotient_0, divisor_sum, quotient_0_product) - quotient_0 * divisor_sum_lo)
    quotient_0_lo = quotient_0_residual / divisor_sum
    quotient_1 = sized_1 / divisor_sum
    quotient_1_product = quotient_1 * divisor_sum
    quotient_1_residual = (sized_1 - quotient_1_product
        - product_error(quotient_1, divisor_sum, quotient_1_product) - quotient_1 * divisor_sum_lo)
    quotient_1_lo = quotient_1_residual / divisor_sum
    quotient_2 = sized_2 / divisor_sum
    quotient_2_product = quotient_2 * divisor_sum
    quotient_2_residual = (sized_2 - quotient_2_product
        - product_error(quotient_2, divisor_sum, quotient_2_product) - quotient_2 * divisor_sum_lo)
    quotient_2_lo = quotient_2_residual / divisor_sum
    quotient_3 = sized_3 / divisor_sum
    quotient_3_product = quotient_3 * divisor_sum
    quotient_3_residual = (sized_3 - quotient_3_product
        - product_error(quotient_3, divisor_sum, quotient_3_product) - quotient_3 * divisor_sum_lo)
    quotient_3_lo = quotient_3_residual / divisor_sum
    quotient_4 = sized_4 / divisor_sum
    quotient_4_product = quotient_4 * divisor_sum
    quotient_4_residual = (sized_4 - quotient_4_product
        - product_error(quotient_4, divisor_sum, quotient_4_product) - quotient_4 * divisor_sum_lo)
    quotient_4_lo = quotient_4_residual / divisor_sum
    quotient_5 = sized_5 / divisor_sum
    quotient_5_product = quotient_5 * divisor_sum
    quotient_5_residual = (sized_5 - quotient_5_product
        - product_error(quotient_5, divisor_sum, quotient_5_product) - quotient_5 * divisor_sum_lo)
    quotient_5_lo = quotient_5_residual / divisor_sum
    quotient_0_sum = quotient_0 + quotient_0_lo
    quotient_0_sum_right = quotient_0_sum - quotient_0
    self_0_new = quotient_0_sum * after_0
    quotient_0_sum_lo = (quotient_0 - (quotient_0_sum - quotient_0_sum_right)
        + (quotient_0_lo - quotient_0_sum_right))
    quotient_1_sum = quotient_1 + quotient_1_lo
    quotient_1_sum_right = quotient_1_sum - quotient_1
    self_1_new = quotient_1_sum * after_1
    quotient_1_sum_lo = (quotient_1 - (quotient_1_sum - quotient_1_sum_right)
        + (quotient_1_lo - quotient_1_sum_right))
    quotient_2_sum = quotient_2 + quotient_2_lo
    quotient_2_sum_right = quotient_2_sum - quotient_2
    self_2_new = quotient_2_sum * after_2
    quotient_2_sum_lo = (quotient_2 - (quotient_2_sum - quotient_2_sum_right)
        + (quotient_2_lo - quotient_2_sum_right))
    quotient_3_sum = quotient_3 + quotient_3_lo
    quotient_3_sum_right = quotient_3_sum - quotient_3
    self_3_new = quotient_3_sum * after_3
    quotient_3_sum_lo = (quotient_3 - (quotient_3_sum - quotient_3_sum_right)
        + (quotient_3_lo - quotient_3_sum_right))
    quotient_4_sum = quotient_4 + quotient_4_lo
    quotient_4_sum_right = quotient_4_sum - quotient_4
    self_4_new = quotient_4_sum * after_4
    quotient_4_sum_lo = (quotient_4 - (quotient_4_sum - quotient_4_sum_right)
        + (quotient_4_lo - quotient_4_sum_right))
    quotient_5_sum = quotient_5 + quotient_5_lo
    quotient_5_sum_right = quotient_5_sum - quotient_5
    self_5_new = quotient_5_sum * after_5
    quotient_5_sum_lo = (quotient_5 - (quotient_5_sum - quotient_5_sum_right)
        + (quotient_5_lo - quotient_5_sum_right))
    self_0_new_rounded = (self_0_new
        + (quotient_0_sum - self_0_new * (1 / after_0) + quotient_0_sum_lo) * after_0)
    self_1_new_rounded = (self_1_new
        + (quotient_1_sum - self_1_new * (1 / after_1) + quotient_1_sum_lo) * after_1)
    self_2_new_rounded = (self_2_new
        + (quotient_2_sum - self_2_new * (1 / after_2) + quotient_2_sum_lo) * after_2)
    self_3_new_rounded = (self_3_new
        + (quotient_3_sum - self_3_new * (1 / after_3) + quotient_3_sum_lo) * after_3)
    self_4_new_rounded = (self_4_new
        + (quotient_4_sum - self_4_new * (1 / after_4) + quotient_4_sum_lo) * after_4)
    self_5_new_rounded = (self_5_new
        + (quotient_5_sum - self_5_new * (1 / after_5) + quotient_5_sum_lo) * after_5)
    self_0_new_final = where(self_0_new_rounded == self_0_new_rounded, self_0_new_rounded,
        self_0_new)
    self_1_new_final = where(self_1_new_rounded == self_1_new_rounded, self_1_new_rounded,
        self_1_new)
    self_2_new_final = where(self_2_new_rounded == self_2_new_rounded, self_2_new_rounded,
        self_2_new)
    self_3_new_final = where(self_3_new_rounded == self_3_new_rounded, self_3_new_rounded,
        self_3_new)
    self_4_new_final = where(self_4_new_rounded == self_4_new_rounded, self_4_new_rounded,
        self_4_new)
    self_5_new_final = where(self_5_new_rounded == self_5_new_rounded, self_5_new_rounded,
        self_5_new)
    return (self_0_new_final, self_1_new_final, self_2_new_final, self_3_new_final,
        self_4_new_final, self_5_new_final)


@kernel("(6)->(6)")
def screw_normalized(si):
    """so = si / |si|, with screw_norm; the zero screw stays zero.

    (6)->(6).  si, so: screw (v in m/s; ω in rad/s).
    43 mul, 104 add, 7 product error, 3 product rest, 19 div, 1 sqrt, 9 abs, 16 less, 9 equal,
    34 select.
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
    n_a = y_0 * y_0
    n_b = y_1 * y_1
    n_c = n_a + n_b
    n_c_right = n_c - n_a
    n_d = y_2 * y_2
    n_e = n_c + n_d
    n_e_right = n_e - n_c
    n_c_lo = product_rest(y_0, y_0, n_a, n_c - n_c_right) + product_rest(y_1, y_1, n_b, n_c_right)
    n_e_lo = n_c - (n_e - n_e_right) + product_rest(y_2, y_2, n_d, n_e_right) + n_c_lo
    n_e_sum = n_e + n_e_lo
    n_e_sum_right = n_e_sum - n_e
    n = sqrt(n_e_sum)
    n_product = n * n
    n_lo = ((n_e_sum - n_product - product_error(n, n, n_product)
        + (n_e - (n_e_sum - n_e_sum_right) + (n_e_lo - n_e_sum_right))) / where(n == 0, 1, n + n))
    n_sum = n + n_lo
    n_sum_right = n_sum - n
    divisor_a = n_sum == 0
    divisor = where(divisor_a, up, n_sum)
    divisor_lo = where(divisor_a, 0, n - (n_sum - n_sum_right) + (n_lo - n_sum_right))
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
    divisor_sum = divisor + divisor_lo
    divisor_sum_right = divisor_sum - divisor
    divisor_sum_lo = divisor - (divisor_sum - divisor_sum_right) + (divisor_lo - divisor_sum_right)
    quotient_0 = sized_0 / divisor_sum
    quotient_0_product = quotient_0 * divisor_sum
    quotient_0_residual = (sized_0 - quotient_0_product
        - product_error(quotient_0, divisor_sum, quotient_0_product) - quotient_0 * divisor_sum_lo)
    quotient_0_lo = quotient_0_residual / divisor_sum
    quotient_1 = sized_1 / divisor_sum
    quotient_1_product = quotient_1 * divisor_sum
    quotient_1_residual = (sized_1 - quotient_1_product
        - product_error(quotient_1, divisor_sum, quotient_1_product) - quotient_1 * divisor_sum_lo)
    quotient_1_lo = quotient_1_residual / divisor_sum
    quotient_2 = sized_2 / divisor_sum
    quotient_2_product = quotient_2 * divisor_sum
    quotient_2_residual = (sized_2 - quotient_2_product
        - product_error(quotient_2, divisor_sum, quotient_2_product) - quotient_2 * divisor_sum_lo)
    quotient_2_lo = quotient_2_residual / divisor_sum
    quotient_3 = sized_3 / divisor_sum
    quotient_3_product = quotient_3 * divisor_sum
    quotient_3_residual = (sized_3 - quotient_3_product
        - product_error(quotient_3, divisor_sum, quotient_3_product) - quotient_3 * divisor_sum_lo)
    quotient_3_lo = quotient_3_residual / divisor_sum
    quotient_4 = sized_4 / divisor_sum
    quotient_4_product = quotient_4 * divisor_sum
    quotient_4_residual = (sized_4 - quotient_4_product
        - product_error(quotient_4, divisor_sum, quotient_4_product) - quotient_4 * divisor_sum_lo)
    quotient_4_lo = quotient_4_residual / divisor_sum
    quotient_5 = sized_5 / divisor_sum
    quotient_5_product = quotient_5 * divisor_sum
    quotient_5_residual = (sized_5 - quotient_5_product
        - product_error(quotient_5, divisor_sum, quotient_5_product) - quotient_5 * divisor_sum_lo)
    quotient_5_lo = quotient_5_residual / divisor_sum
    quotient_0_sum = quotient_0 + quotient_0_lo
    quotient_0_sum_right = quotient_0_sum - quotient_0
    so_0 = quotient_0_sum * after_0
    so_0_rest = (quotient_0_sum - so_0 * (1 / after_0)
        + (quotient_0 - (quotient_0_sum - quotient_0_sum_right)
        + (quotient_0_lo - quotient_0_sum_right)))
    quotient_1_sum = quotient_1 + quotient_1_lo
    quotient_1_sum_right = quotient_1_sum - quotient_1
    so_1 = quotient_1_sum * after_1
    so_1_rest = (quotient_1_sum - so_1 * (1 / after_1)
        + (quotient_1 - (quotient_1_sum - quotient_1_sum_right)
        + (quotient_1_lo - quotient_1_sum_right)))
    quotient_2_sum = quotient_2 + quotient_2_lo
    quotient_2_sum_right = quotient_2_sum - quotient_2
    so_2 = quotient_2_sum * after_2
    so_2_rest = (quotient_2_sum - so_2 * (1 / after_2)
        + (quotient_2 - (quotient_2_sum - quotient_2_sum_right)
        + (quotient_2_lo - quotient_2_sum_right)))
    quotient_3_sum = quotient_3 + quotient_3_lo
    quotient_3_sum_right = quotient_3_sum - quotient_3
    so_3 = quotient_3_sum * after_3
    so_3_rest = (quotient_3_sum - so_3 * (1 / after_3)
        + (quotient_3 - (quotient_3_sum - quotient_3_sum_right)
        + (quotient_3_lo - quotient_3_sum_right)))
    quotient_4_sum = quotient_4 + quotient_4_lo
    quotient_4_sum_right = quotient_4_sum - quotient_4
    so_4 = quotient_4_sum * after_4
    so_4_rest = (quotient_4_sum - so_4 * (1 / after_4)
        + (quotient_4 - (quotient_4_sum - quotient_4_sum_right)
        + (quotient_4_lo - quotient_4_sum_right)))
    quotient_5_sum = quotient_5 + quotient_5_lo
    quotient_5_sum_right = quotient_5_sum - quotient_5
    so_5 = quotient_5_sum * after_5
    so_5_rest = (quotient_5_sum - so_5 * (1 / after_5)
        + (quotient_5 - (quotient_5_sum - quotient_5_sum_right)
        + (quotient_5_lo - quotient_5_sum_right)))
    so_0_rounded = so_0 + so_0_rest * after_0
    so_1_rounded = so_1 + so_1_rest * after_1
    so_2_rounded = so_2 + so_2_rest * after_2
    so_3_rounded = so_3 + so_3_rest * after_3
    so_4_rounded = so_4 + so_4_rest * after_4
    so_5_rounded = so_5 + so_5_rest * after_5
    so_0_final = where(so_0_rounded == so_0_rounded, so_0_rounded, so_0)
    so_1_final = where(so_1_rounded == so_1_rounded, so_1_rounded, so_1)
    so_2_final = where(so_2_rounded == so_2_rounded, so_2_rounded, so_2)
    so_3_final = where(so_3_rounded == so_3_rounded, so_3_rounded, so_3)
    so_4_final = where(so_4_rounded == so_4_rounded, so_4_rounded, so_4)
    so_5_final = where(so_5_rounded == so_5_rounded, so_5_rounded, so_5)
    return (so_0_final, so_1_final, so_2_final, so_3_final, so_4_final, so_5_final)


@kernel("(6),(6)->(6)")
def add_sst(s1, s2):
    """so = (s1.lin + s2.lin ; s1.ang).

    (6),(6)->(6).  s1, s2, so: screw (v in m/s; ω in rad/s).
    21 add.  Error <= u |result|, barring over- and underflow.
    """
    s1_0, s1_1, s1_2, s1_3, s1_4, s1_5 = s1
    s2_0, s2_1, s2_2, s2_3, s2_4, s2_5 = s2
    so_0 = s1_0 + s2_0
    so_0_right = so_0 - s1_0
    so_1 = s1_1 + s2_1
    so_1_right = so_1 - s1_1
    so_2 = s1_2 + s2_2
    so_2_right = so_2 - s1_2
    so_0_rounded = so_0 + (s1_0 - (so_0 - so_0_right) + (s2_0 - so_0_right))
    so_1_rounded = so_1 + (s1_1 - (so_1 - so_1_right) + (s2_1 - so_1_right))
    so_2_rounded = so_2 + (s1_2 - (so_2 - so_2_right) + (s2_2 - so_2_right))
    return (so_0_rounded, so_1_rounded, so_2_rounded, s1_3, s1_4, s1_5)


@kernel("(3),(6)->(6)")
def product_Adts(t, si):
    """so = [Ad](t) si.

    (3),(6)->(6).  t: vector; si, so: screw (v in m/s; ω in rad/s).
    6 mul, 36 add, 6 product rest.  Error <= u |result| + (lin: 9, ang: 0) u^2 S, S the sum of
    the |terms| of the expanded formula; barring over- and underflow.
    """
    t_0, t_1, t_2 = t
    si_0, si_1, si_2, si_3, si_4, si_5 = si
    so_0a = t_1 * si_5
    so_0b = t_2 * si_4
    so_0c = so_0a - so_0b
    so_0c_right = so_0a - so_0c
    so_0 = so_0c + si_0
    so_0_right = so_0 - so_0c
    so_0c_lo = (product_rest(t_1, si_5, so_0a, so_0c + so_0c_right)
        - product_rest(t_2, si_4, so_0b, so_0c_right))
    so_1a = t_2 * si_3
    so_1b = t_0 * si_5
    so_1c = so_1a - so_1b
    so_1c_right = so_1a - so_1c
    so_1 = so_1c + si_1
    so_1_right = so_1 - so_1c
    so_1c_lo = (product_rest(t_2, si_3, so_1a, so_1c + so_1c_right)
        - product_rest(t_0, si_5, so_1b, so_1c_right))
    so_2a = t_0 * si_4
    so_2b = t_1 * si_3
    so_2c = so_2a - so_2b
    so_2c_right = so_2a - so_2c
    so_2 = so_2c + si_2
    so_2_right = so_2 - so_2c
    so_2c_lo = (product_rest(t_0, si_4, so_2a, so_2c + so_2c_right)
        - product_rest(t_1, si_3, so_2b, so_2c_right))
    so_0_rounded = so_0 + (so_0c - (so_0 - so_0_right) + (si_0 - so_0_right) + so_0c_lo)
    so_1_rounded = so_1 + (so_1c - (so_1 - so_1_right) + (si_1 - so_1_right) + so_1c_lo)
    so_2_rounded = so_2 + (so_2c - (so_2 - so_2_right) + (si_2 - so_2_right) + so_2c_lo)
    return (so_0_rounded, so_1_rounded, so_2_rounded, si_3, si_4, si_5)


@kernel("(3),(6)->(6)")
def product_Adtinvs(t, si):
    """so = [Ad](t)^-1 si.

    (3),(6)->(6).  t: vector; si, so: screw (v in m/s; ω in rad/s).
    6 mul, 36 add, 6 product rest.  Error <= u |result| + (lin: 9, ang: 0) u^2 S, S the sum of
    the |terms| of the expanded formula; barring over- and underflow.
    """
    t_0, t_1, t_2 = t
    si_0, si_1, si_2, si_3, si_4, si_5 = si
    so_0a = t_2 * si_4
    so_0b = t_1 * si_5
    so_0c = so_0a - so_0b
    so_0c_right = so_0a - so_0c
    so_0 = so_0c + si_0
    so_0_right = so_0 - so_0c
    so_0c_lo = (product_rest(t_2, si_4, so_0a, so_0c + so_0c_right)
        - product_rest(t_1, si_5, so_0b, so_0c_right))
    so_1a = t_0 * si_5
    so_1b = t_2 * si_3
    so_1c = so_1a - so_1b
    so_1c_right = so_1a - so_1c
    so_1 = so_1c + si_1
    so_1_right = so_1 - so_1c
    so_1c_lo = (product_rest(t_0, si_5, so_1a, so_1c + so_1c_right)
        - product_rest(t_2, si_3, so_1b, so_1c_right))
    so_2a = t_1 * si_3
    so_2b = t_0 * si_4
    so_2c = so_2a - so_2b
    so_2c_right = so_2a - so_2c
    so_2 = so_2c + si_2
    so_2_right = so_2 - so_2c
    so_2c_lo = (product_rest(t_1, si_3, so_2a, so_2c + so_2c_right)
        - product_rest(t_0, si_4, so_2b, so_2c_right))
    so_0_rounded = so_0 + (so_0c - (so_0 - so_0_right) + (si_0 - so_0_right) + so_0c_lo)
    so_1_rounded = so_1 + (so_1c - (so_1 - so_1_right) + (si_1 - so_1_right) + so_1c_lo)
    so_2_rounded = so_2 + (so_2c - (so_2 - so_2_right) + (si_2 - so_2_right) + so_2c_lo)
    return (so_0_rounded, so_1_rounded, so_2_rounded, si_3, si_4, si_5)


@kernel("(3),(6)->(6)")
def product_Adtsinv(t, si):
    """so = [Ad](t) (-si).

    (3),(6)->(6).  t: vector; si, so: screw (v in m/s; ω in rad/s).
    6 mul, 36 add, 6 product rest, 3 neg.  Error <= u |result| + (lin: 9, ang: 0) u^2 S, S the
    sum of the |terms| of the expanded formula; barring over- and underflow.
    """
    t_0, t_1, t_2 = t
    si_0, si_1, si_2, si_3, si_4, si_5 = si
    so_0a = t_2 * si_4
    so_0b = t_1 * si_5
    so_0c = so_0a - so_0b
    so_0c_right = so_0a - so_0c
    so_0 = so_0c - si_0
    so_0_right = so_0c - so_0
    so_0c_lo = (product_rest(t_2, si_4, so_0a, so_0c + so_0c_right)
        - product_rest(t_1, si_5, so_0b, so_0c_right))
    so_1a = t_0 * si_5
    so_1b = t_2 * si_3
    so_1c = so_1a - so_1b
    so_1c_right = so_1a - so_1c
    so_1 = so_1c - si_1
    so_1_right = so_1c - so_1
    so_1c_lo = (product_rest(t_0, si_5, so_1a, so_1c + so_1c_right)
        - product_rest(t_2, si_3, so_1b, so_1c_right))
    so_2a = t_1 * si_3
    so_2b = t_0 * si_4
    so_2c = so_2a - so_2b
    so_2c_right = so_2a - so_2c
    so_2 = so_2c - si_2
    so_2_right = so_2c - so_2
    so_2c_lo = (product_rest(t_1, si_3, so_2a, so_2c + so_2c_right)
        - product_rest(t_0, si_4, so_2b, so_2c_right))
    so_3 = -si_3
    so_4 = -si_4
    so_5 = -si_5
    so_0_rounded = so_0 + (so_0c - (so_0 + so_0_right) - (si_0 - so_0_right) + so_0c_lo)
    so_1_rounded = so_1 + (so_1c - (so_1 + so_1_right) - (si_1 - so_1_right) + so_1c_lo)
    so_2_rounded = so_2 + (so_2c - (so_2 + so_2_right) - (si_2 - so_2_right) + so_2c_lo)
    return (so_0_rounded, so_1_rounded, so_2_rounded, so_3, so_4, so_5)


@kernel("(3,3),(6)->(6)")
def product_Adrs(R, si):
    """so = [Ad](R) si.

    (3,3),(6)->(6).  R: rotation or other 3×3 matrix; si, so: screw (v in m/s; ω in rad/s).
    18 mul, 66 add, 18 product rest.  Error <= u |result| + 11 u^2 S, S the sum of the |terms|
    of the expanded formula; barring over- and underflow.
    """
    R_00, R_01, R_02, R_10, R_11, R_12, R_20, R_21, R_22 = R
    si_0, si_1, si_2, si_3, si_4, si_5 = si
    so_0a = R_00 * si_0
    so_0b = R_01 * si_1
    so_0c = so_0a + so_0b
    so_0c_right = so_0c - so_0a
    so_0d = R_02 * si_2
    so_0 = so_0c + so_0d
    so_0_right = so_0 - so_0c
    so_0c_lo = (product_rest(R_00, si_0, so_0a, so_0c - so_0c_right)
        + product_rest(R_01, si_1, so_0b, so_0c_right))
    so_1a = R_10 * si_0
    so_1b = R_11 * si_1
    so_1c = so_1a + so_1b
    so_1c_right = so_1c - so_1a
    so_1d = R_12 * si_2
    so_1 = so_1c + so_1d
    so_1_right = so_1 - so_1c
    so_1c_lo = (product_rest(R_10, si_0, so_1a, so_1c - so_1c_right)
        + product_rest(R_11, si_1, so_1b, so_1c_right))
    so_2a = R_20 * si_0
    so_2b = R_21 * si_1
    so_2c = so_2a + so_2b
    so_2c_right = so_2c - so_2a
    so_2d = R_22 * si_2
    so_2 = so_2c + so_2d
    so_2_right = so_2 - so_2c
    so_2c_lo = (product_rest(R_20, si_0, so_2a, so_2c - so_2c_right)
        + product_rest(R_21, si_1, so_2b, so_2c_right))
    so_3a = R_00 * si_3
    so_3b = R_01 * si_4
    so_3c = so_3a + so_3b
    so_3c_right = so_3c - so_3a
    so_3d = R_02 * si_5
    so_3 = so_3c + so_3d
    so_3_right = so_3 - so_3c
    so_3c_lo = (product_rest(R_00, si_3, so_3a, so_3c - so_3c_right)
        + product_rest(R_01, si_4, so_3b, so_3c_right))
    so_4a = R_10 * si_3
    so_4b = R_11 * si_4
    so_4c = so_4a + so_4b
    so_4c_right = so_4c - so_4a
    so_4d = R_12 * si_5
    so_4 = so_4c + so_4d
    so_4_right = so_4 - so_4c
    so_4c_lo = (product_rest(R_10, si_3, so_4a, so_4c - so_4c_right)
        + product_rest(R_11, si_4, so_4b, so_4c_right))
    so_5a = R_20 * si_3
    so_5b = R_21 * si_4
    so_5c = so_5a + so_5b
    so_5c_right = so_5c - so_5a
    so_5d = R_22 * si_5
    so_5 = so_5c + so_5d
    so_5_right = so_5 - so_5c
    so_5c_lo = (product_rest(R_20, si_3, so_5a, so_5c - so_5c_right)
        + product_rest(R_21, si_4, so_5b, so_5c_right))
    so_0_rounded = (so_0
        + (so_0c - (so_0 - so_0_right) + product_rest(R_02, si_2, so_0d, so_0_right) + so_0c_lo))
    so_1_rounded = (so_1
        + (so_1c - (so_1 - so_1_right) + product_rest(R_12, si_2, so_1d, so_1_right) + so_1c_lo))
    so_2_rounded = (so_2
        + (so_2c - (so_2 - so_2_right) + product_rest(R_22, si_2, so_2d, so_2_right) + so_2c_lo))
    so_3_rounded = (so_3
        + (so_3c - (so_3 - so_3_right) + product_rest(R_02, si_5, so_3d, so_3_right) + so_3c_lo))
    so_4_rounded = (so_4
        + (so_4c - (so_4 - so_4_right) + product_rest(R_12, si_5, so_4d, so_4_right) + so_4c_lo))
    so_5_rounded = (so_5
        + (so_5c - (so_5 - so_5_right) + product_rest(R_22, si_5, so_5d, so_5_right) + so_5c_lo))
    return (so_0_rounded, so_1_rounded, so_2_rounded, so_3_rounded, so_4_rounded, so_5_rounded)


@kernel("(3,3),(6)->(6)")
def product_Adrinvs(R, si):
    """so = [Ad](R)^-1 si.

    (3,3),(6)->(6).  R: rotation or other 3×3 matrix; si, so: screw (v in m/s; ω in rad/s).
    18 mul, 66 add, 18 product rest.  Error <= u |result| + 11 u^2 S, S the sum of the |terms|
    of the expanded formula; barring over- and underflow.
    """
    R_00, R_01, R_02, R_10, R_11, R_12, R_20, R_21, R_22 = R
    si_0, si_1, si_2, si_3, si_4, si_5 = si
    so_0a = R_00 * si_0
    so_0b = R_10 * si_1
    so_0c = so_0a + so_0b
    so_0c_right = so_0c - so_0a
    so_0d = R_20 * si_2
    so_0 = so_0c + so_0d
    so_0_right = so_0 - so_0c
    so_0c_lo = (product_rest(R_00, si_0, so_0a, so_0c - so_0c_right)
        + product_rest(R_10, si_1, so_0b, so_0c_right))
    so_1a = R_01 * si_0
    so_1b = R_11 * si_1
    so_1c = so_1a + so_1b
    so_1c_right = so_1c - so_1a
    so_1d = R_21 * si_2
    so_1 = so_1c + so_1d
    so_1_right = so_1 - so_1c
    so_1c_lo = (product_rest(R_01, si_0, so_1a, so_1c - so_1c_right)
        + product_rest(R_11, si_1, so_1b, so_1c_right))
    so_2a = R_02 * si_0
    so_2b = R_12 * si_1
    so_2c = so_2a + so_2b
    so_2c_right = so_2c - so_2a
    so_2d = R_22 * si_2
    so_2 = so_2c + so_2d
    so_2_right = so_2 - so_2c
    so_2c_lo = (product_rest(R_02, si_0, so_2a, so_2c - so_2c_right)
        + product_rest(R_12, si_1, so_2b, so_2c_right))
    so_3a = R_00 * si_3
    so_3b = R_10 * si_4
    so_3c = so_3a + so_3b
    so_3c_right = so_3c - so_3a
    so_3d = R_20 * si_5
    so_3 = so_3c + so_3d
    so_3_right = so_3 - so_3c
    so_3c_lo = (product_rest(R_00, si_3, so_3a, so_3c - so_3c_right)
        + product_rest(R_10, si_4, so_3b, so_3c_right))
    so_4a = R_01 * si_3
    so_4b = R_11 * si_4
    so_4c = so_4a + so_4b
    so_4c_right = so_4c - so_4a
    so_4d = R_21 * si_5
    so_4 = so_4c + so_4d
    so_4_right = so_4 - so_4c
    so_4c_lo = (product_rest(R_01, si_3, so_4a, so_4c - so_4c_right)
        + product_rest(R_11, si_4, so_4b, so_4c_right))
    so_5a = R_02 * si_3
    so_5b = R_12 * si_4
    so_5c = so_5a + so_5b
    so_5c_right = so_5c - so_5a
    so_5d = R_22 * si_5
    so_5 = so_5c + so_5d
    so_5_right = so_5 - so_5c
    so_5c_lo = (product_rest(R_02, si_3, so_5a, so_5c - so_5c_right)
        + product_rest(R_12, si_4, so_5b, so_5c_right))
    so_0_rounded = (so_0
        + (so_0c - (so_0 - so_0_right) + product_rest(R_20, si_2, so_0d, so_0_right) + so_0c_lo))
    so_1_rounded = (so_1
        + (so_1c - (so_1 - so_1_right) + product_rest(R_21, si_2, so_1d, so_1_right) + so_1c_lo))
    so_2_rounded = (so_2
        + (so_2c - (so_2 - so_2_right) + product_rest(R_22, si_2, so_2d, so_2_right) + so_2c_lo))
    so_3_rounded = (so_3
        + (so_3c - (so_3 - so_3_right) + product_rest(R_20, si_5, so_3d, so_3_right) + so_3c_lo))
    so_4_rounded = (so_4
        + (so_4c - (so_4 - so_4_right) + product_rest(R_21, si_5, so_4d, so_4_right) + so_4c_lo))
    so_5_rounded = (so_5
        + (so_5c - (so_5 - so_5_right) + product_rest(R_22, si_5, so_5d, so_5_right) + so_5c_lo))
    return (so_0_rounded, so_1_rounded, so_2_rounded, so_3_rounded, so_4_rounded, so_5_rounded)


@kernel("(3,3),(6)->(6)")
def product_Adrsinv(R, si):
    """so = [Ad](R) (-si).

    (3,3),(6)->(6).  R: rotation or other 3×3 matrix; si, so: screw (v in m/s; ω in rad/s).
    18 mul, 66 add, 18 product rest, 12 neg.  Error <= u |result| + 11 u^2 S, S the sum of the
    |terms| of the expanded formula; barring over- and underflow.
    """
    R_00, R_01, R_02, R_10, R_11, R_12, R_20, R_21, R_22 = R
    si_0, si_1, si_2, si_3, si_4, si_5 = si
    so_0a = R_00 * si_0
    so_0b = R_01 * si_1
    so_0c = so_0a + so_0b
    so_0c_right = so_0c - so_0a
    so_0d = R_02 * si_2
    so_0e = so_0c + so_0d
    so_0e_right = so_0e - so_0c
    so_0c_lo = (product_rest(R_00, si_0, so_0a, so_0c - so_0c_right)
        + product_rest(R_01, si_1, so_0b, so_0c_right))
    so_0 = -so_0e
    so_1a = R_10 * si_0
    so_1b = R_11 * si_1
    so_1c = so_1a + so_1b
    so_1c_right = so_1c - so_1a
    so_1d = R_12 * si_2
    so_1e = so_1c + so_1d
    so_1e_right = so_1e - so_1c
    so_1c_lo = (product_rest(R_10, si_0, so_1a, so_1c - so_1c_right)
        + product_rest(R_11, si_1, so_1b, so_1c_right))
    so_1 = -so_1e
    so_2a = R_20 * si_0
    so_2b = R_21 * si_1
    so_2c = so_2a + so_2b
    so_2c_right = so_2c - so_2a
    so_2d = R_22 * si_2
    so_2e = so_2c + so_2d
    so_2e_right = so_2e - so_2c
    so_2c_lo = (product_rest(R_20, si_0, so_2a, so_2c - so_2c_right)
        + product_rest(R_21, si_1, so_2b, so_2c_right))
    so_2 = -so_2e
    so_3a = R_00 * si_3
    so_3b = R_01 * si_4
    so_3c = so_3a + so_3b
    so_3c_right = so_3c - so_3a
    so_3d = R_02 * si_5
    so_3e = so_3c + so_3d
    so_3e_right = so_3e - so_3c
    so_3c_lo = (product_rest(R_00, si_3, so_3a, so_3c - so_3c_right)
        + product_rest(R_01, si_4, so_3b, so_3c_right))
    so_3 = -so_3e
    so_4a = R_10 * si_3
    so_4b = R_11 * si_4
    so_4c = so_4a + so_4b
    so_4c_right = so_4c - so_4a
    so_4d = R_12 * si_5
    so_4e = so_4c + so_4d
    so_4e_right = so_4e - so_4c
    so_4c_lo = (product_rest(R_10, si_3, so_4a, so_4c - so_4c_right)
        + product_rest(R_11, si_4, so_4b, so_4c_right))
    so_4 = -so_4e
    so_5a = R_20 * si_3
    so_5b = R_21 * si_4
    so_5c = so_5a + so_5b
    so_5c_right = so_5c - so_5a
    so_5d = R_22 * si_5
    so_5e = so_5c + so_5d
    so_5e_right = so_5e - so_5c
    so_5c_lo = (product_rest(R_20, si_3, so_5a, so_5c - so_5c_right)
        + product_rest(R_21, si_4, so_5b, so_5c_right))
    so_5 = -so_5e
    so_0_rounded = (so_0 +
        -(so_0c - (so_0e - so_0e_right) + product_rest(R_02, si_2, so_0d, so_0e_right) + so_0c_lo))
    so_1_rounded = (so_1 +
        -(so_1c - (so_1e - so_1e_right) + product_rest(R_12, si_2, so_1d, so_1e_right) + so_1c_lo))
    so_2_rounded = (so_2 +
        -(so_2c - (so_2e - so_2e_right) + product_rest(R_22, si_2, so_2d, so_2e_right) + so_2c_lo))
    so_3_rounded = (so_3 +
        -(so_3c - (so_3e - so_3e_right) + product_rest(R_02, si_5, so_3d, so_3e_right) + so_3c_lo))
    so_4_rounded = (so_4 +
        -(so_4c - (so_4e - so_4e_right) + product_rest(R_12, si_5, so_4d, so_4e_right) + so_4c_lo))
    so_5_rounded = (so_5 +
        -(so_5c - (so_5e - so_5e_right) + product_rest(R_22, si_5, so_5d, so_5e_right) + so_5c_lo))
    return (so_0_rounded, so_1_rounded, so_2_rounded, so_3_rounded, so_4_rounded, so_5_rounded)


@kernel("(3,4),(6)->(6)")
def product_Ads(D, si):
    """so = [Ad](D) si = [Ad](t) [Ad](R) si.

    (3,4),(6)->(6).  D: displacement [R | t], R rotation, t in m; si, so: screw (v in m/s; ω in
    rad/s).
    30 mul, 108 add, 24 product rest.  Error <= u |result| + (lin: 35, ang: 11) u^2 S, S the sum
    of the |terms| of the expanded formula; barring over- and underflow.
    """
    D_00, D_01, D_02, D_03, D_10, D_11, D_12, D_13, D_20, D_21, D_22, D_23 = D
    si_0, si_1, si_2, si_3, si_4, si_5 = si
    w_0a = D_00 * si_0
    w_0b = D_01 * si_1
    w_0c = w_0a + w_0b
    w_0c_right = w_0c - w_0a
    w_0d = D_02 * si_2
    w_0 = w_0c + w_0d
    w_0_right = w_0 - w_0c
    w_0c_lo = (product_rest(D_00, si_0, w_0a, w_0c - w_0c_right)
        + product_rest(D_01, si_1, w_0b, w_0c_right))
    w_1a = D_10 * si_0
    w_1b = D_11 * si_1
    w_1c = w_1a + w_1b
    w_1c_right = w_1c - w_1a
    w_1d = D_12 * si_2
    w_1 = w_1c + w_1d
    w_1_right = w_1 - w_1c
    w_1c_lo = (product_rest(D_10, si_0, w_1a, w_1c - w_1c_right)
        + product_rest(D_11, si_1, w_1b, w_1c_right))
    w_2a = D_20 * si_0
    w_2b = D_21 * si_1
    w_2c = w_2a + w_2b
    w_2c_right = w_2c - w_2a
    w_2d = D_22 * si_2
    w_2 = w_2c + w_2d
    w_2_right = w_2 - w_2c
    w_2c_lo = (product_rest(D_20, si_0, w_2a, w_2c - w_2c_right)
        + product_rest(D_21, si_1, w_2b, w_2c_right))
    w_3a = D_00 * si_3
    w_3b = D_01 * si_4
    w_3c = w_3a + w_3b
    w_3c_right = w_3c - w_3a
    w_3d = D_02 * si_5
    w_3 = w_3c + w_3d
    w_3_right = w_3 - w_3c
    w_3c_lo = (product_rest(D_00, si_3, w_3a, w_3c - w_3c_right)
        + product_rest(D_01, si_4, w_3b, w_3c_right))
    w_3_lo = w_3c - (w_3 - w_3_right) + product_rest(D_02, si_5, w_3d, w_3_right) + w_3c_lo
    w_4a = D_10 * si_3
    w_4b = D_11 * si_4
    w_4c = w_4a + w_4b
    w_4c_right = w_4c - w_4a
    w_4d = D_12 * si_5
    w_4 = w_4c + w_4d
    w_4_right = w_4 - w_4c
    w_4c_lo = (product_rest(D_10, si_3, w_4a, w_4c - w_4c_right)
        + product_rest(D_11, si_4, w_4b, w_4c_right))
    w_4_lo = w_4c - (w_4 - w_4_right) + product_rest(D_12, si_5, w_4d, w_4_right) + w_4c_lo
    w_5a = D_20 * si_3
    w_5b = D_21 * si_4
    w_5c = w_5a + w_5b
    w_5c_right = w_5c - w_5a
    w_5d = D_22 * si_5
    w_5 = w_5c + w_5d
    w_5_right = w_5 - w_5c
    w_5c_lo = (product_rest(D_20, si_3, w_5a, w_5c - w_5c_right)
        + product_rest(D_21, si_4, w_5b, w_5c_right))
    w_5_lo = w_5c - (w_5 - w_5_right) + product_rest(D_22, si_5, w_5d, w_5_right) + w_5c_lo
    so_0a = D_13 * w_5
    so_0b = D_23 * w_4
    so_0c = so_0a - so_0b
    so_0c_right = so_0a - so_0c
    so_0 = so_0c + w_0
    so_0_right = so_0 - so_0c
    so_0_lo2 = (so_0c - (so_0 - so_0_right) + (w_0 - so_0_right)
        + (w_0c - (w_0 - w_0_right) + product_rest(D_02, si_2, w_0d, w_0_right) + w_0c_lo))
    so_0c_lo = (product_rest(D_13, w_5, so_0a, so_0c + so_0c_right)
        - product_rest(D_23, w_4, so_0b, so_0c_right) + (D_13 * w_5_lo - D_23 * w_4_lo))
    so_1a = D_23 * w_3
    so_1b = D_03 * w_5
    so_1c = so_1a - so_1b
    so_1c_right = so_1a - so_1c
    so_1 = so_1c + w_1
    so_1_right = so_1 - so_1c
    so_1_lo2 = (so_1c - (so_1 - so_1_right) + (w_1 - so_1_right)
        + (w_1c - (w_1 - w_1_right) + product_rest(D_12, si_2, w_1d, w_1_right) + w_1c_lo))
    so_1c_lo = (product_rest(D_23, w_3, so_1a, so_1c + so_1c_right)
        - product_rest(D_03, w_5, so_1b, so_1c_right) + (D_23 * w_3_lo - D_03 * w_5_lo))
    so_2a = D_03 * w_4
    so_2b = D_13 * w_3
    so_2c = so_2a - so_2b
    so_2c_right = so_2a - so_2c
    so_2 = so_2c + w_2
    so_2_right = so_2 - so_2c
    so_2_lo2 = (so_2c - (so_2 - so_2_right) + (w_2 - so_2_right)
        + (w_2c - (w_2 - w_2_right) + product_rest(D_22, si_2, w_2d, w_2_right) + w_2c_lo))
    so_2c_lo = (product_rest(D_03, w_4, so_2a, so_2c + so_2c_right)
        - product_rest(D_13, w_3, so_2b, so_2c_right) + (D_03 * w_4_lo - D_13 * w_3_lo))
    so_0_rounded = so_0 + (so_0_lo2 + so_0c_lo)
    so_1_rounded = so_1 + (so_1_lo2 + so_1c_lo)
    so_2_rounded = so_2 + (so_2_lo2 + so_2c_lo)
    w_3_rounded = w_3 + w_3_lo
    w_4_rounded = w_4 + w_4_lo
    w_5_rounded = w_5 + w_5_lo
    return (so_0_rounded, so_1_rounded, so_2_rounded, w_3_rounded, w_4_rounded, w_5_rounded)


@kernel("(3,4),(6)->(6)")
def product_Adinvs(D, si):
    """so = [Ad](D)^-1 si = [Ad](R^T) [Ad](-t) si.

    (3,4),(6)->(6).  D: displacement [R | t], R rotation, t in m; si, so: screw (v in m/s; ω in
    rad/s).
    33 mul, 108 add, 24 product rest.  Error <= u |result| + (lin: 35, ang: 11) u^2 S, S the sum
    of the |terms| of the expanded formula; barring over- and underflow.
    """
    D_00, D_01, D_02, D_03, D_10, D_11, D_12, D_13, D_20, D_21, D_22, D_23 = D
    si_0, si_1, si_2, si_3, si_4, si_5 = si
    w_0a = D_23 * si_4
    w_0b = D_13 * si_5
    w_0c = w_0a - w_0b
    w_0c_right = w_0a - w_0c
    w_0 = w_0c + si_0
    w_0_right = w_0 - w_0c
    w_0c_lo = (product_rest(D_23, si_4, w_0a, w_0c + w_0c_right)
        - product_rest(D_13, si_5, w_0b, w_0c_right))
    w_0_lo = w_0c - (w_0 - w_0_right) + (si_0 - w_0_right) + w_0c_lo
    w_1a = D_03 * si_5
    w_1b = D_23 * si_3
    w_1c = w_1a - w_1b
    w_1c_right = w_1a - w_1c
    w_1 = w_1c + si_1
    w_1_right = w_1 - w_1c
    w_1c_lo = (product_rest(D_03, si_5, w_1a, w_1c + w_1c_right)
        - product_rest(D_23, si_3, w_1b, w_1c_right))
    w_1_lo = w_1c - (w_1 - w_1_right) + (si_1 - w_1_right) + w_1c_lo
    w_2a = D_13 * si_3
    w_2b = D_03 * si_4
    w_2c = w_2a - w_2b
    w_2c_right = w_2a - w_2c
    w_2 = w_2c + si_2
    w_2_right = w_2 - w_2c
    w_2c_lo = (product_rest(D_13, si_3, w_2a, w_2c + w_2c_right)
        - product_rest(D_03, si_4, w_2b, w_2c_right))
    w_2_lo = w_2c - (w_2 - w_2_right) + (si_2 - w_2_right) + w_2c_lo
    so_0a = D_00 * w_0
    so_0b = D_10 * w_1
    so_0c = so_0a + so_0b
    so_0c_right = so_0c - so_0a
    so_0d = D_20 * w_2
    so_0 = so_0c + so_0d
    so_0_right = so_0 - so_0c
    so_0c_lo = (product_rest(D_00, w_0, so_0a, so_0c - so_0c_right)
        + product_rest(D_10, w_1, so_0b, so_0c_right) + (D_00 * w_0_lo + D_10 * w_1_lo))
    so_1a = D_01 * w_0
    so_1b = D_11 * w_1
    so_1c = so_1a + so_1b
    so_1c_right = so_1c - so_1a
    so_1d = D_21 * w_2
    so_1 = so_1c + so_1d
    so_1_right = so_1 - so_1c
    so_1c_lo = (product_rest(D_01, w_0, so_1a, so_1c - so_1c_right)
        + product_rest(D_11, w_1, so_1b, so_1c_right) + (D_01 * w_0_lo + D_11 * w_1_lo))
    so_2a = D_02 * w_0
    so_2b = D_12 * w_1
    so_2c = so_2a + so_2b
    so_2c_right = so_2c - so_2a
    so_2d = D_22 * w_2
    so_2 = so_2c + so_2d
    so_2_right = so_2 - so_2c
    so_2c_lo = (product_rest(D_02, w_0, so_2a, so_2c - so_2c_right)
        + product_rest(D_12, w_1, so_2b, so_2c_right) + (D_02 * w_0_lo + D_12 * w_1_lo))
    so_3a = D_00 * si_3
    so_3b = D_10 * si_4
    so_3c = so_3a + so_3b
    so_3c_right = so_3c - so_3a
    so_3d = D_20 * si_5
    so_3 = so_3c + so_3d
    so_3_right = so_3 - so_3c
    so_3c_lo = (product_rest(D_00, si_3, so_3a, so_3c - so_3c_right)
        + product_rest(D_10, si_4, so_3b, so_3c_right))
    so_4a = D_01 * si_3
    so_4b = D_11 * si_4
    so_4c = so_4a + so_4b
    so_4c_right = so_4c - so_4a
    so_4d = D_21 * si_5
    so_4 = so_4c + so_4d
    so_4_right = so_4 - so_4c
    so_4c_lo = (product_rest(D_01, si_3, so_4a, so_4c - so_4c_right)
        + product_rest(D_11, si_4, so_4b, so_4c_right))
    so_5a = D_02 * si_3
    so_5b = D_12 * si_4
    so_5c = so_5a + so_5b
    so_5c_right = so_5c - so_5a
    so_5d = D_22 * si_5
    so_5 = so_5c + so_5d
    so_5_right = so_5 - so_5c
    so_5c_lo = (product_rest(D_02, si_3, so_5a, so_5c - so_5c_right)
        + product_rest(D_12, si_4, so_5b, so_5c_right))
    so_0_rounded = (so_0
        + (so_0c - (so_0 - so_0_right) + product_rest(D_20, w_2, so_0d, so_0_right) + D_20 * w_2_lo
        + so_0c_lo))
    so_1_rounded = (so_1
        + (so_1c - (so_1 - so_1_right) + product_rest(D_21, w_2, so_1d, so_1_right) + D_21 * w_2_lo
        + so_1c_lo))
    so_2_rounded = (so_2
        + (so_2c - (so_2 - so_2_right) + product_rest(D_22, w_2, so_2d, so_2_right) + D_22 * w_2_lo
        + so_2c_lo))
    so_3_rounded = (so_3
        + (so_3c - (so_3 - so_3_right) + product_rest(D_20, si_5, so_3d, so_3_right) + so_3c_lo))
    so_4_rounded = (so_4
        + (so_4c - (so_4 - so_4_right) + product_rest(D_21, si_5, so_4d, so_4_right) + so_4c_lo))
    so_5_rounded = (so_5
        + (so_5c - (so_5 - so_5_right) + product_rest(D_22, si_5, so_5d, so_5_right) + so_5c_lo))
    return (so_0_rounded, so_1_rounded, so_2_rounded, so_3_rounded, so_4_rounded, so_5_rounded)


@kernel("(3,4),(6)->(6)")
def product_Adsinv(D, si):
    """so = [Ad](D) (-si).

    (3,4),(6)->(6).  D: displacement [R | t], R rotation, t in m; si, so: screw (v in m/s; ω in
    rad/s).
    30 mul, 108 add, 24 product rest, 12 neg.  Error <= u |result| + (lin: 35, ang: 11) u^2 S, S
    the sum of the |terms| of the expanded formula; barring over- and underflow.
    """
    D_00, D_01, D_02, D_03, D_10, D_11, D_12, D_13, D_20, D_21, D_22, D_23 = D
    si_0, si_1, si_2, si_3, si_4, si_5 = si
    w_0a = D_00 * si_0
    w_0b = D_01 * si_1
    w_0c = w_0a + w_0b
    w_0c_right = w_0c - w_0a
    w_0d = D_02 * si_2
    w_0e = w_0c + w_0d
    w_0e_right = w_0e - w_0c
    w_0c_lo = (product_rest(D_00, si_0, w_0a, w_0c - w_0c_right)
        + product_rest(D_01, si_1, w_0b, w_0c_right))
    w_0 = -w_0e
    w_1a = D_10 * si_0
    w_1b = D_11 * si_1
    w_1c = w_1a + w_1b
    w_1c_right = w_1c - w_1a
    w_1d = D_12 * si_2
    w_1e = w_1c + w_1d
    w_1e_right = w_1e - w_1c
    w_1c_lo = (product_rest(D_10, si_0, w_1a, w_1c - w_1c_right)
        + product_rest(D_11, si_1, w_1b, w_1c_right))
    w_1 = -w_1e
    w_2a = D_20 * si_0
    w_2b = D_21 * si_1
    w_2c = w_2a + w_2b
    w_2c_right = w_2c - w_2a
    w_2d = D_22 * si_2
    w_2e = w_2c + w_2d
    w_2e_right = w_2e - w_2c
    w_2c_lo = (product_rest(D_20, si_0, w_2a, w_2c - w_2c_right)
        + product_rest(D_21, si_1, w_2b, w_2c_right))
    w_2 = -w_2e
    w_3a = D_00 * si_3
    w_3b = D_01 * si_4
    w_3c = w_3a + w_3b
    w_3c_right = w_3c - w_3a
    w_3d = D_02 * si_5
    w_3e = w_3c + w_3d
    w_3e_right = w_3e - w_3c
    w_3c_lo = (product_rest(D_00, si_3, w_3a, w_3c - w_3c_right)
        + product_rest(D_01, si_4, w_3b, w_3c_right))
    w_3 = -w_3e
    w_3_lo = -(w_3c - (w_3e - w_3e_right) + product_rest(D_02, si_5, w_3d, w_3e_right) + w_3c_lo)
    w_4a = D_10 * si_3
    w_4b = D_11 * si_4
    w_4c = w_4a + w_4b
    w_4c_right = w_4c - w_4a
    w_4d = D_12 * si_5
    w_4e = w_4c + w_4d
    w_4e_right = w_4e - w_4c
    w_4c_lo = (product_rest(D_10, si_3, w_4a, w_4c - w_4c_right)
        + product_rest(D_11, si_4, w_4b, w_4c_right))
    w_4 = -w_4e
    w_4_lo = -(w_4c - (w_4e - w_4e_right) + product_rest(D_12, si_5, w_4d, w_4e_right) + w_4c_lo)
    w_5a = D_20 * si_3
    w_5b = D_21 * si_4
    w_5c = w_5a + w_5b
    w_5c_right = w_5c - w_5a
    w_5d = D_22 * si_5
    w_5e = w_5c + w_5d
    w_5e_right = w_5e - w_5c
    w_5c_lo = (product_rest(D_20, si_3, w_5a, w_5c - w_5c_right)
        + product_rest(D_21, si_4, w_5b, w_5c_right))
    w_5 = -w_5e
    w_5_lo = -(w_5c - (w_5e - w_5e_right) + product_rest(D_22, si_5, w_5d, w_5e_right) + w_5c_lo)
    so_0a = D_13 * w_5
    so_0b = D_23 * w_4
    so_0c = so_0a - so_0b
    so_0c_right = so_0a - so_0c
    so_0 = so_0c + w_0
    so_0_right = so_0 - so_0c
    so_0_lo2 = (so_0c - (so_0 - so_0_right) + (w_0 - so_0_right) +
        -(w_0c - (w_0e - w_0e_right) + product_rest(D_02, si_2, w_0d, w_0e_right) + w_0c_lo))
    so_0c_lo = (product_rest(D_13, w_5, so_0a, so_0c + so_0c_right)
        - product_rest(D_23, w_4, so_0b, so_0c_right) + (D_13 * w_5_lo - D_23 * w_4_lo))
    so_1a = D_23 * w_3
    so_1b = D_03 * w_5
    so_1c = so_1a - so_1b
    so_1c_right = so_1a - so_1c
    so_1 = so_1c + w_1
    so_1_right = so_1 - so_1c
    so_1_lo2 = (so_1c - (so_1 - so_1_right) + (w_1 - so_1_right) +
        -(w_1c - (w_1e - w_1e_right) + product_rest(D_12, si_2, w_1d, w_1e_right) + w_1c_lo))
    so_1c_lo = (product_rest(D_23, w_3, so_1a, so_1c + so_1c_right)
        - product_rest(D_03, w_5, so_1b, so_1c_right) + (D_23 * w_3_lo - D_03 * w_5_lo))
    so_2a = D_03 * w_4
    so_2b = D_13 * w_3
    so_2c = so_2a - so_2b
    so_2c_right = so_2a - so_2c
    so_2 = so_2c + w_2
    so_2_right = so_2 - so_2c
    so_2_lo2 = (so_2c - (so_2 - so_2_right) + (w_2 - so_2_right) +
        -(w_2c - (w_2e - w_2e_right) + product_rest(D_22, si_2, w_2d, w_2e_right) + w_2c_lo))
    so_2c_lo = (product_rest(D_03, w_4, so_2a, so_2c + so_2c_right)
        - product_rest(D_13, w_3, so_2b, so_2c_right) + (D_03 * w_4_lo - D_13 * w_3_lo))
    so_0_rounded = so_0 + (so_0_lo2 + so_0c_lo)
    so_1_rounded = so_1 + (so_1_lo2 + so_1c_lo)
    so_2_rounded = so_2 + (so_2_lo2 + so_2c_lo)
    w_3_rounded = w_3 + w_3_lo
    w_4_rounded = w_4 + w_4_lo
    w_5_rounded = w_5 + w_5_lo
    return (so_0_rounded, so_1_rounded, so_2_rounded, w_3_rounded, w_4_rounded, w_5_rounded)


@kernel("(3,4)->(6)")
def hsrx(D):
    """so = h_rx: column 3 of [Ad](D).

    (3,4)->(6).  D: displacement [R | t], R rotation, t in m; so: screw (v in m/s; ω in rad/s).
    6 mul, 15 add, 6 product rest.  Error <= u |result| + (lin: 6, ang: 0) u^2 S, S the sum of
    the |terms| of the expanded formula; barring over- and underflow.
    """
    D_00, D_01, D_02, D_03, D_10, D_11, D_12, D_13, D_20, D_21, D_22, D_23 = D
    so_0a = D_20 * D_13
    so_0b = D_10 * D_23
    so_0 = so_0a - so_0b
    so_0_right = so_0a - so_0
    so_1a = D_00 * D_23
    so_1b = D_20 * D_03
    so_1 = so_1a - so_1b
    so_1_right = so_1a - so_1
    so_2a = D_10 * D_03
    so_2b = D_00 * D_13
    so_2 = so_2a - so_2b
    so_2_right = so_2a - so_2
    so_0_rounded = (so_0
        + (product_rest(D_20, D_13, so_0a, so_0 + so_0_right)
        - product_rest(D_10, D_23, so_0b, so_0_right)))
    so_1_rounded = (so_1
        + (product_rest(D_00, D_23, so_1a, so_1 + so_1_right)
        - product_rest(D_20, D_03, so_1b, so_1_right)))
    so_2_rounded = (so_2
        + (product_rest(D_10, D_03, so_2a, so_2 + so_2_right)
        - product_rest(D_00, D_13, so_2b, so_2_right)))
    return (so_0_rounded, so_1_rounded, so_2_rounded, D_00, D_10, D_20)


@kernel("(3,4)->(6)")
def hsry(D):
    """so = h_ry: column 4 of [Ad](D).

    (3,4)->(6).  D: displacement [R | t], R rotation, t in m; so: screw (v in m/s; ω in rad/s).
    6 mul, 15 add, 6 product rest.  Error <= u |result| + (lin: 6, ang: 0) u^2 S, S the sum of
    the |terms| of the expanded formula; barring over- and underflow.
    """
    D_00, D_01, D_02, D_03, D_10, D_11, D_12, D_13, D_20, D_21, D_22, D_23 = D
    so_0a = D_21 * D_13
    so_0b = D_11 * D_23
    so_0 = so_0a - so_0b
    so_0_right = so_0a - so_0
    so_1a = D_01 * D_23
    so_1b = D_21 * D_03
    so_1 = so_1a - so_1b
    so_1_right = so_1a - so_1
    so_2a = D_11 * D_03
    so_2b = D_01 * D_13
    so_2 = so_2a - so_2b
    so_2_right = so_2a - so_2
    so_0_rounded = (so_0
        + (product_rest(D_21, D_13, so_0a, so_0 + so_0_right)
        - product_rest(D_11, D_23, so_0b, so_0_right)))
    so_1_rounded = (so_1
        + (product_rest(D_01, D_23, so_1a, so_1 + so_1_right)
        - product_rest(D_21, D_03, so_1b, so_1_right)))
    so_2_rounded = (so_2
        + (product_rest(D_11, D_03, so_2a, so_2 + so_2_right)
        - product_rest(D_01, D_13, so_2b, so_2_right)))
    return (so_0_rounded, so_1_rounded, so_2_rounded, D_01, D_11, D_21)


@kernel("(3,4)->(6)")
def hsrz(D):
    """so = h_rz: column 5 of [Ad](D).

    (3,4)->(6).  D: displacement [R | t], R rotation, t in m; so: screw (v in m/s; ω in rad/s).
    6 mul, 15 add, 6 product rest.  Error <= u |result| + (lin: 6, ang: 0) u^2 S, S the sum of
    the |terms| of the expanded formula; barring over- and underflow.
    """
    D_00, D_01, D_02, D_03, D_10, D_11, D_12, D_13, D_20, D_21, D_22, D_23 = D
    so_0a = D_22 * D_13
    so_0b = D_12 * D_23
    so_0 = so_0a - so_0b
    so_0_right = so_0a - so_0
    so_1a = D_02 * D_23
    so_1b = D_22 * D_03
    so_1 = so_1a - so_1b
    so_1_right = so_1a - so_1
    so_2a = D_12 * D_03
    so_2b = D_02 * D_13
    so_2 = so_2a - so_2b
    so_2_right = so_2a - so_2
    so_0_rounded = (so_0
        + (product_rest(D_22, D_13, so_0a, so_0 + so_0_right)
        - product_rest(D_12, D_23, so_0b, so_0_right)))
    so_1_rounded = (so_1
        + (product_rest(D_02, D_23, so_1a, so_1 + so_1_right)
        - product_rest(D_22, D_03, so_1b, so_1_right)))
    so_2_rounded = (so_2
        + (product_rest(D_12, D_03, so_2a, so_2 + so_2_right)
        - product_rest(D_02, D_13, so_2b, so_2_right)))
    return (so_0_rounded, so_1_rounded, so_2_rounded, D_02, D_12, D_22)


@kernel("(3,4)->(6)")
def hsrxinv(D):
    """so = -h_rx: -column 3 of [Ad](D).

    (3,4)->(6).  D: displacement [R | t], R rotation, t in m; so: screw (v in m/s; ω in rad/s).
    6 mul, 15 add, 6 product rest, 3 neg.  Error <= u |result| + (lin: 6, ang: 0) u^2 S, S the
    sum of the |terms| of the expanded formula; barring over- and underflow.
    """
    D_00, D_01, D_02, D_03, D_10, D_11, D_12, D_13, D_20, D_21, D_22, D_23 = D
    so_0a = D_10 * D_23
    so_0b = D_20 * D_13
    so_0 = so_0a - so_0b
    so_0_right = so_0a - so_0
    so_1a = D_20 * D_03
    so_1b = D_00 * D_23
    so_1 = so_1a - so_1b
    so_1_right = so_1a - so_1
    so_2a = D_00 * D_13
    so_2b = D_10 * D_03
    so_2 = so_2a - so_2b
    so_2_right = so_2a - so_2
    so_3 = -D_00
    so_4 = -D_10
    so_5 = -D_20
    so_0_rounded = (so_0
        + (product_rest(D_10, D_23, so_0a, so_0 + so_0_right)
        - product_rest(D_20, D_13, so_0b, so_0_right)))
    so_1_rounded = (so_1
        + (product_rest(D_20, D_03, so_1a, so_1 + so_1_right)
        - product_rest(D_00, D_23, so_1b, so_1_right)))
    so_2_rounded = (so_2
        + (product_rest(D_00, D_13, so_2a, so_2 + so_2_right)
        - product_rest(D_10, D_03, so_2b, so_2_right)))
    return (so_0_rounded, so_1_rounded, so_2_rounded, so_3, so_4, so_5)


@kernel("(3,4)->(6)")
def hsryinv(D):
    """so = -h_ry: -column 4 of [Ad](D).

    (3,4)->(6).  D: displacement [R | t], R rotation, t in m; so: screw (v in m/s; ω in rad/s).
    6 mul, 15 add, 6 product rest, 3 neg.  Error <= u |result| + (lin: 6, ang: 0) u^2 S, S the
    sum of the |terms| of the expanded formula; barring over- and underflow.
    """
    D_00, D_01, D_02, D_03, D_10, D_11, D_12, D_13, D_20, D_21, D_22, D_23 = D
    so_0a = D_11 * D_23
    so_0b = D_21 * D_13
    so_0 = so_0a - so_0b
    so_0_right = so_0a - so_0
    so_1a = D_21 * D_03
    so_1b = D_01 * D_23
    so_1 = so_1a - so_1b
    so_1_right = so_1a - so_1
    so_2a = D_01 * D_13
    so_2b = D_11 * D_03
    so_2 = so_2a - so_2b
    so_2_right = so_2a - so_2
    so_3 = -D_01
    so_4 = -D_11
    so_5 = -D_21
    so_0_rounded = (so_0
        + (product_rest(D_11, D_23, so_0a, so_0 + so_0_right)
        - product_rest(D_21, D_13, so_0b, so_0_right)))
    so_1_rounded = (so_1
        + (product_rest(D_21, D_03, so_1a, so_1 + so_1_right)
        - product_rest(D_01, D_23, so_1b, so_1_right)))
    so_2_rounded = (so_2
        + (product_rest(D_01, D_13, so_2a, so_2 + so_2_right)
        - product_rest(D_11, D_03, so_2b, so_2_right)))
    return (so_0_rounded, so_1_rounded, so_2_rounded, so_3, so_4, so_5)


@kernel("(3,4)->(6)")
def hsrzinv(D):
    """so = -h_rz: -column 5 of [Ad](D).

    (3,4)->(6).  D: displacement [R | t], R rotation, t in m; so: screw (v in m/s; ω in rad/s).
    6 mul, 15 add, 6 product rest, 3 neg.  Error <= u |result| + (lin: 6, ang: 0) u^2 S, S the
    sum of the |terms| of the expanded formula; barring over- and underflow.
    """
    D_00, D_01, D_02, D_03, D_10, D_11, D_12, D_13, D_20, D_21, D_22, D_23 = D
    so_0a = D_12 * D_23
    so_0b = D_22 * D_13
    so_0 = so_0a - so_0b
    so_0_right = so_0a - so_0
    so_1a = D_22 * D_03
    so_1b = D_02 * D_23
    so_1 = so_1a - so_1b
    so_1_right = so_1a - so_1
    so_2a = D_02 * D_13
    so_2b = D_12 * D_03
    so_2 = so_2a - so_2b
    so_2_right = so_2a - so_2
    so_3 = -D_02
    so_4 = -D_12
    so_5 = -D_22
    so_0_rounded = (so_0
        + (product_rest(D_12, D_23, so_0a, so_0 + so_0_right)
        - product_rest(D_22, D_13, so_0b, so_0_right)))
    so_1_rounded = (so_1
        + (product_rest(D_22, D_03, so_1a, so_1 + so_1_right)
        - product_rest(D_02, D_23, so_1b, so_1_right)))
    so_2_rounded = (so_2
        + (product_rest(D_02, D_13, so_2a, so_2 + so_2_right)
        - product_rest(D_12, D_03, so_2b, so_2_right)))
    return (so_0_rounded, so_1_rounded, so_2_rounded, so_3, so_4, so_5)


@kernel("(3,4)->(6,6)")
def Ad(D):
    """M = [Ad](D).

    (3,4)->(6,6).  D: displacement [R | t], R rotation, t in m; M: 6×6 operator.
    18 mul, 45 add, 18 product rest.  Error <= u |result| + 6 u^2 S, S the sum of the |terms| of
    the expanded formula; barring over- and underflow.
    """
    D_00, D_01, D_02, D_03, D_10, D_11, D_12, D_13, D_20, D_21, D_22, D_23 = D
    M_03a = D_20 * D_13
    M_03b = D_10 * D_23
    M_03 = M_03a - M_03b
    M_03_right = M_03a - M_03
    M_04a = D_21 * D_13
    M_04b = D_11 * D_23
    M_04 = M_04a - M_04b
    M_04_right = M_04a - M_04
    M_05a = D_22 * D_13
    M_05b = D_12 * D_23
    M_05 = M_05a - M_05b
    M_05_right = M_05a - M_05
    M_13a = D_00 * D_23
    M_13b = D_20 * D_03
    M_13 = M_13a - M_13b
    M_13_right = M_13a - M_13
    M_14a = D_01 * D_23
    M_14b = D_21 * D_03
    M_14 = M_14a - M_14b
    M_14_right = M_14a - M_14
    M_15a = D_02 * D_23
    M_15b = D_22 * D_03
    M_15 = M_15a - M_15b
    M_15_right = M_15a - M_15
    M_23a = D_10 * D_03
    M_23b = D_00 * D_13
    M_23 = M_23a - M_23b
    M_23_right = M_23a - M_23
    M_24a = D_11 * D_03
    M_24b = D_01 * D_13
    M_24 = M_24a - M_24b
    M_24_right = M_24a - M_24
    M_25a = D_12 * D_03
    M_25b = D_02 * D_13
    M_25 = M_25a - M_25b
    M_25_right = M_25a - M_25
    M_03_rounded = (M_03
        + (product_rest(D_20, D_13, M_03a, M_03 + M_03_right)
        - product_rest(D_10, D_23, M_03b, M_03_right)))
    M_04_rounded = (M_04
        + (product_rest(D_21, D_13, M_04a, M_04 + M_04_right)
        - product_rest(D_11, D_23, M_04b, M_04_right)))
    M_05_rounded = (M_05
        + (product_rest(D_22, D_13, M_05a, M_05 + M_05_right)
        - product_rest(D_12, D_23, M_05b, M_05_right)))
    M_13_rounded = (M_13
        + (product_rest(D_00, D_23, M_13a, M_13 + M_13_right)
        - product_rest(D_20, D_03, M_13b, M_13_right)))
    M_14_rounded = (M_14
        + (product_rest(D_01, D_23, M_14a, M_14 + M_14_right)
        - product_rest(D_21, D_03, M_14b, M_14_right)))
    M_15_rounded = (M_15
        + (product_rest(D_02, D_23, M_15a, M_15 + M_15_right)
        - product_rest(D_22, D_03, M_15b, M_15_right)))
    M_23_rounded = (M_23
        + (product_rest(D_10, D_03, M_23a, M_23 + M_23_right)
        - product_rest(D_00, D_13, M_23b, M_23_right)))
    M_24_rounded = (M_24
        + (product_rest(D_11, D_03, M_24a, M_24 + M_24_right)
        - product_rest(D_01, D_13, M_24b, M_24_right)))
    M_25_rounded = (M_25
        + (product_rest(D_12, D_03, M_25a, M_25 + M_25_right)
        - product_rest(D_02, D_13, M_25b, M_25_right)))
    return (D_00, D_01, D_02, M_03_rounded, M_04_rounded, M_05_rounded, D_10, D_11, D_12,
        M_13_rounded, M_14_rounded, M_15_rounded, D_20, D_21, D_22, M_23_rounded, M_24_rounded,
        M_25_rounded, 0, 0, 0, D_00, D_01, D_02, 0, 0, 0, D_10, D_11, D_12, 0, 0, 0, D_20, D_21,
        D_22)


@kernel("(6),(6)->()")
def dot_cs(c, s):
    """power = f·v + τ·ω, in W.

    (6),(6)->().  c: coscrew (f in N; τ in N m); s: screw (v in m/s; ω in rad/s); power: number.
    6 mul, 29 add, 6 product rest.  Error <= u |result| + 19 u^2 S, S the sum of the |terms| of
    the expanded formula; barring over- and underflow.
    """
    c_0, c_1, c_2, c_3, c_4, c_5 = c
    s_0, s_1, s_2, s_3, s_4, s_5 = s
    power_a = c_0 * s_0
    power_b = c_1 * s_1
    power_c = power_a + power_b
    power_c_right = power_c - power_a
    power_d = c_2 * s_2
    power_e = power_c + power_d
    power_e_right = power_e - power_c
    power_c_lo = (product_rest(c_0, s_0, power_a, power_c - power_c_right)
        + product_rest(c_1, s_1, power_b, power_c_right))
    power_f = c_3 * s_3
    power_g = c_4 * s_4
    power_h = power_f + power_g
    power_h_right = power_h - power_f
    power_i = c_5 * s_5
    power_j = power_h + power_i
    power_j_right = power_j - power_h
    power_h_lo = (product_rest(c_3, s_3, power_f, power_h - power_h_right)
        + product_rest(c_4, s_4, power_g, power_h_right))
    power = power_e + power_j
    power_right = power - power_e
    power_j_lo = (power_h - (power_j - power_j_right)
        + product_rest(c_5, s_5, power_i, power_j_right) + power_h_lo)
    power_e_lo = (power_c - (power_e - power_e_right)
        + product_rest(c_2, s_2, power_d, power_e_right) + power_c_lo)
    power_rounded = (power
        + (power_e - (power - power_right) + (power_j - power_right) + power_j_lo + power_e_lo))
    return power_rounded


@kernel("(6),(6)->(6)")
def cross_ss(s1, s2):
    """so = [ad](s1) s2 = (ω1×v2 + v1×ω2 ; ω1×ω2).  Exactly zero for s1 = s2, unless products
    overflow.

    (6),(6)->(6).  s1, s2, so: screw (v in m/s; ω in rad/s).
    18 mul, 66 add, 18 product rest.  Error <= u |result| + (lin: 12, ang: 6) u^2 S, S the sum
    of the |terms| of the expanded formula; barring over- and underflow.
    """
    s1_0, s1_1, s1_2, s1_3, s1_4, s1_5 = s1
    s2_0, s2_1, s2_2, s2_3, s2_4, s2_5 = s2
    so_0a = s1_1 * s2_5
    so_0b = s1_5 * s2_1
    so_0c = so_0a - so_0b
    so_0c_right = so_0a - so_0c
    so_0d = s1_4 * s2_2
    so_0e = s1_2 * s2_4
    so_0f = so_0d - so_0e
    so_0f_right = so_0d - so_0f
    so_0 = so_0c + so_0f
    so_0_right = so_0 - so_0c
    so_0f_lo = (product_rest(s1_4, s2_2, so_0d, so_0f + so_0f_right)
        - product_rest(s1_2, s2_4, so_0e, so_0f_right))
    so_0c_lo = (product_rest(s1_1, s2_5, so_0a, so_0c + so_0c_right)
        - product_rest(s1_5, s2_1, so_0b, so_0c_right))
    so_1a = s1_5 * s2_0
    so_1b = s1_0 * s2_5
    so_1c = so_1a - so_1b
    so_1c_right = so_1a - so_1c
    so_1d = s1_2 * s2_3
    so_1e = s1_3 * s2_2
    so_1f = so_1d - so_1e
    so_1f_right = so_1d - so_1f
    so_1 = so_1c + so_1f
    so_1_right = so_1 - so_1c
    so_1f_lo = (product_rest(s1_2, s2_3, so_1d, so_1f + so_1f_right)
        - product_rest(s1_3, s2_2, so_1e, so_1f_right))
    so_1c_lo = (product_rest(s1_5, s2_0, so_1a, so_1c + so_1c_right)
        - product_rest(s1_0, s2_5, so_1b, so_1c_right))
    so_2a = s1_0 * s2_4
    so_2b = s1_4 * s2_0
    so_2c = so_2a - so_2b
    so_2c_right = so_2a - so_2c
    so_2d = s1_3 * s2_1
    so_2e = s1_1 * s2_3
    so_2f = so_2d - so_2e
    so_2f_right = so_2d - so_2f
    so_2 = so_2c + so_2f
    so_2_right = so_2 - so_2c
    so_2f_lo = (product_rest(s1_3, s2_1, so_2d, so_2f + so_2f_right)
        - product_rest(s1_1, s2_3, so_2e, so_2f_right))
    so_2c_lo = (product_rest(s1_0, s2_4, so_2a, so_2c + so_2c_right)
        - product_rest(s1_4, s2_0, so_2b, so_2c_right))
    so_3a = s1_4 * s2_5
    so_3b = s1_5 * s2_4
    so_3 = so_3a - so_3b
    so_3_right = so_3a - so_3
    so_4a = s1_5 * s2_3
    so_4b = s1_3 * s2_5
    so_4 = so_4a - so_4b
    so_4_right = so_4a - so_4
    so_5a = s1_3 * s2_4
    so_5b = s1_4 * s2_3
    so_5 = so_5a - so_5b
    so_5_right = so_5a - so_5
    so_0_rounded = so_0 + (so_0c - (so_0 - so_0_right) + (so_0f - so_0_right) + so_0f_lo + so_0c_lo)
    so_1_rounded = so_1 + (so_1c - (so_1 - so_1_right) + (so_1f - so_1_right) + so_1f_lo + so_1c_lo)
    so_2_rounded = so_2 + (so_2c - (so_2 - so_2_right) + (so_2f - so_2_right) + so_2f_lo + so_2c_lo)
    so_3_rounded = (so_3
        + (product_rest(s1_4, s2_5, so_3a, so_3 + so_3_right)
        - product_rest(s1_5, s2_4, so_3b, so_3_right)))
    so_4_rounded = (so_4
        + (product_rest(s1_5, s2_3, so_4a, so_4 + so_4_right)
        - product_rest(s1_3, s2_5, so_4b, so_4_right)))
    so_5_rounded = (so_5
        + (product_rest(s1_3, s2_4, so_5a, so_5 + so_5_right)
        - product_rest(s1_4, s2_3, so_5b, so_5_right)))
    return (so_0_rounded, so_1_rounded, so_2_rounded, so_3_rounded, so_4_rounded, so_5_rounded)


@kernel("(6),(6)->(6)")
def cross_sst(s1, s2):
    """so = (ω1×v2 ; 0).

    (6),(6)->(6).  s1, s2, so: screw (v in m/s; ω in rad/s).
    6 mul, 15 add, 6 product rest.  Error <= u |result| + (lin: 6, ang: 0) u^2 S, S the sum of
    the |terms| of the expanded formula; barring over- and underflow.
    """
    s1_0, s1_1, s1_2, s1_3, s1_4, s1_5 = s1
    s2_0, s2_1, s2_2, s2_3, s2_4, s2_5 = s2
    so_0a = s1_4 * s2_2
    so_0b = s1_5 * s2_1
    so_0 = so_0a - so_0b
    so_0_right = so_0a - so_0
    so_1a = s1_5 * s2_0
    so_1b = s1_3 * s2_2
    so_1 = so_1a - so_1b
    so_1_right = so_1a - so_1
    so_2a = s1_3 * s2_1
    so_2b = s1_4 * s2_0
    so_2 = so_2a - so_2b
    so_2_right = so_2a - so_2
    so_0_rounded = (so_0
        + (product_rest(s1_4, s2_2, so_0a, so_0 + so_0_right)
        - product_rest(s1_5, s2_1, so_0b, so_0_right)))
    so_1_rounded = (so_1
        + (product_rest(s1_5, s2_0, so_1a, so_1 + so_1_right)
        - product_rest(s1_3, s2_2, so_1b, so_1_right)))
    so_2_rounded = (so_2
        + (product_rest(s1_3, s2_1, so_2a, so_2 + so_2_right)
        - product_rest(s1_4, s2_0, so_2b, so_2_right)))
    return (so_0_rounded, so_1_rounded, so_2_rounded, 0, 0, 0)


@kernel("(3,4),(3)->(6)")
def hsra(D, axis):
    """so = (t×R a ; R a), a = axis in the body's frame.

    (3,4),(3)->(6).  D: displacement [R | t], R rotation, t in m; axis: vector; so: screw (v in
    m/s; ω in rad/s).
    21 mul, 54 add, 15 product rest.  Error <= u |result| + (lin: 28, ang: 11) u^2 S, S the sum
    of the |terms| of the expanded formula; barring over- and underflow.
    """
    D_00, D_01, D_02, D_03, D_10, D_11, D_12, D_13, D_20, D_21, D_22, D_23 = D
    axis_0, axis_1, axis_2 = axis
    a_0a = D_00 * axis_0
    a_0b = D_01 * axis_1
    a_0c = a_0a + a_0b
    a_0c_right = a_0c - a_0a
    a_0d = D_02 * axis_2
    a_0 = a_0c + a_0d
    a_0_right = a_0 - a_0c
    a_0c_lo = (product_rest(D_00, axis_0, a_0a, a_0c - a_0c_right)
        + product_rest(D_01, axis_1, a_0b, a_0c_right))
    a_0_lo = a_0c - (a_0 - a_0_right) + product_rest(D_02, axis_2, a_0d, a_0_right) + a_0c_lo
    a_1a = D_10 * axis_0
    a_1b = D_11 * axis_1
    a_1c = a_1a + a_1b
    a_1c_right = a_1c - a_1a
    a_1d = D_12 * axis_2
    a_1 = a_1c + a_1d
    a_1_right = a_1 - a_1c
    a_1c_lo = (product_rest(D_10, axis_0, a_1a, a_1c - a_1c_right)
        + product_rest(D_11, axis_1, a_1b, a_1c_right))
    a_1_lo = a_1c - (a_1 - a_1_right) + product_rest(D_12, axis_2, a_1d, a_1_right) + a_1c_lo
    a_2a = D_20 * axis_0
    a_2b = D_21 * axis_1
    a_2c = a_2a + a_2b
    a_2c_right = a_2c - a_2a
    a_2d = D_22 * axis_2
    a_2 = a_2c + a_2d
    a_2_right = a_2 - a_2c
    a_2c_lo = (product_rest(D_20, axis_0, a_2a, a_2c - a_2c_right)
        + product_rest(D_21, axis_1, a_2b, a_2c_right))
    a_2_lo = a_2c - (a_2 - a_2_right) + product_rest(D_22, axis_2, a_2d, a_2_right) + a_2c_lo
    so_0a = D_13 * a_2
    so_0b = D_23 * a_1
    so_0 = so_0a - so_0b
    so_0_right = so_0a - so_0
    so_1a = D_23 * a_0
    so_1b = D_03 * a_2
    so_1 = so_1a - so_1b
    so_1_right = so_1a - so_1
    so_2a = D_03 * a_1
    so_2b = D_13 * a_0
    so_2 = so_2a - so_2b
    so_2_right = so_2a - so_2
    so_0_lo = (product_rest(D_13, a_2, so_0a, so_0 + so_0_right)
        - product_rest(D_23, a_1, so_0b, so_0_right) + (D_13 * a_2_lo - D_23 * a_1_lo))
    so_0_rounded = so_0 + so_0_lo
    so_1_lo = (product_rest(D_23, a_0, so_1a, so_1 + so_1_right)
        - product_rest(D_03, a_2, so_1b, so_1_right) + (D_23 * a_0_lo - D_03 * a_2_lo))
    so_1_rounded = so_1 + so_1_lo
    so_2_lo = (product_rest(D_03, a_1, so_2a, so_2 + so_2_right)
        - product_rest(D_13, a_0, so_2b, so_2_right) + (D_03 * a_1_lo - D_13 * a_0_lo))
    so_2_rounded = so_2 + so_2_lo
    a_0_rounded = a_0 + a_0_lo
    a_1_rounded = a_1 + a_1_lo
    a_2_rounded = a_2 + a_2_lo
    return (so_0_rounded, so_1_rounded, so_2_rounded, a_0_rounded, a_1_rounded, a_2_rounded)


@kernel("(3,4),(3)->(6)")
def hsta(D, axis):
    """so = (R a ; 0), a = axis in the body's frame.

    (3,4),(3)->(6).  D: displacement [R | t], R rotation, t in m; axis: vector; so: screw (v in
    m/s; ω in rad/s).
    9 mul, 33 add, 9 product rest.  Error <= u |result| + (lin: 11, ang: 0) u^2 S, S the sum of
    the |terms| of the expanded formula; barring over- and underflow.
    """
    D_00, D_01, D_02, D_03, D_10, D_11, D_12, D_13, D_20, D_21, D_22, D_23 = D
    axis_0, axis_1, axis_2 = axis
    so_0a = D_00 * axis_0
    so_0b = D_01 * axis_1
    so_0c = so_0a + so_0b
    so_0c_right = so_0c - so_0a
    so_0d = D_02 * axis_2
    so_0 = so_0c + so_0d
    so_0_right = so_0 - so_0c
    so_0c_lo = (product_rest(D_00, axis_0, so_0a, so_0c - so_0c_right)
        + product_rest(D_01, axis_1, so_0b, so_0c_right))
    so_1a = D_10 * axis_0
    so_1b = D_11 * axis_1
    so_1c = so_1a + so_1b
    so_1c_right = so_1c - so_1a
    so_1d = D_12 * axis_2
    so_1 = so_1c + so_1d
    so_1_right = so_1 - so_1c
    so_1c_lo = (product_rest(D_10, axis_0, so_1a, so_1c - so_1c_right)
        + product_rest(D_11, axis_1, so_1b, so_1c_right))
    so_2a = D_20 * axis_0
    so_2b = D_21 * axis_1
    so_2c = so_2a + so_2b
    so_2c_right = so_2c - so_2a
    so_2d = D_22 * axis_2
    so_2 = so_2c + so_2d
    so_2_right = so_2 - so_2c
    so_2c_lo = (product_rest(D_20, axis_0, so_2a, so_2c - so_2c_right)
        + product_rest(D_21, axis_1, so_2b, so_2c_right))
    so_0_rounded = (so_0
        + (so_0c - (so_0 - so_0_right) + product_rest(D_02, axis_2, so_0d, so_0_right) + so_0c_lo))
    so_1_rounded = (so_1
        + (so_1c - (so_1 - so_1_right) + product_rest(D_12, axis_2, so_1d, so_1_right) + so_1c_lo))
    so_2_rounded = (so_2
        + (so_2c - (so_2 - so_2_right) + product_rest(D_22, axis_2, so_2d, so_2_right) + so_2c_lo))
    return (so_0_rounded, so_1_rounded, so_2_rounded, 0, 0, 0)


@kernel("(3,4),(3)->(6)")
def hsrainv(D, axis):
    """so = -(t×R a ; R a), a = axis in the body's frame.

    (3,4),(3)->(6).  D: displacement [R | t], R rotation, t in m; axis: vector; so: screw (v in
    m/s; ω in rad/s).
    21 mul, 54 add, 15 product rest, 6 neg.  Error <= u |result| + (lin: 28, ang: 11) u^2 S, S
    the sum of the |terms| of the expanded formula; barring over- and underflow.
    """
    D_00, D_01, D_02, D_03, D_10, D_11, D_12, D_13, D_20, D_21, D_22, D_23 = D
    axis_0, axis_1, axis_2 = axis
    a_0a = D_00 * axis_0
    a_0b = D_01 * axis_1
    a_0c = a_0a + a_0b
    a_0c_right = a_0c - a_0a
    a_0d = D_02 * axis_2
    a_0e = a_0c + a_0d
    a_0e_right = a_0e - a_0c
    a_0c_lo = (product_rest(D_00, axis_0, a_0a, a_0c - a_0c_right)
        + product_rest(D_01, axis_1, a_0b, a_0c_right))
    a_0 = -a_0e
    a_0_lo = -(a_0c - (a_0e - a_0e_right) + product_rest(D_02, axis_2, a_0d, a_0e_right) + a_0c_lo)
    a_1a = D_10 * axis_0
    a_1b = D_11 * axis_1
    a_1c = a_1a + a_1b
    a_1c_right = a_1c - a_1a
    a_1d = D_12 * axis_2
    a_1e = a_1c + a_1d
    a_1e_right = a_1e - a_1c
    a_1c_lo = (product_rest(D_10, axis_0, a_1a, a_1c - a_1c_right)
        + product_rest(D_11, axis_1, a_1b, a_1c_right))
    a_1 = -a_1e
    a_1_lo = -(a_1c - (a_1e - a_1e_right) + product_rest(D_12, axis_2, a_1d, a_1e_right) + a_1c_lo)
    a_2a = D_20 * axis_0
    a_2b = D_21 * axis_1
    a_2c = a_2a + a_2b
    a_2c_right = a_2c - a_2a
    a_2d = D_22 * axis_2
    a_2e = a_2c + a_2d
    a_2e_right = a_2e - a_2c
    a_2c_lo = (product_rest(D_20, axis_0, a_2a, a_2c - a_2c_right)
        + product_rest(D_21, axis_1, a_2b, a_2c_right))
    a_2 = -a_2e
    a_2_lo = -(a_2c - (a_2e - a_2e_right) + product_rest(D_22, axis_2, a_2d, a_2e_right) + a_2c_lo)
    so_0a = D_13 * a_2
    so_0b = D_23 * a_1
    so_0 = so_0a - so_0b
    so_0_right = so_0a - so_0
    so_1a = D_23 * a_0
    so_1b = D_03 * a_2
    so_1 = so_1a - so_1b
    so_1_right = so_1a - so_1
    so_2a = D_03 * a_1
    so_2b = D_13 * a_0
    so_2 = so_2a - so_2b
    so_2_right = so_2a - so_2
    so_0_lo = (product_rest(D_13, a_2, so_0a, so_0 + so_0_right)
        - product_rest(D_23, a_1, so_0b, so_0_right) + (D_13 * a_2_lo - D_23 * a_1_lo))
    so_0_rounded = so_0 + so_0_lo
    so_1_lo = (product_rest(D_23, a_0, so_1a, so_1 + so_1_right)
        - product_rest(D_03, a_2, so_1b, so_1_right) + (D_23 * a_0_lo - D_03 * a_2_lo))
    so_1_rounded = so_1 + so_1_lo
    so_2_lo = (product_rest(D_03, a_1, so_2a, so_2 + so_2_right)
        - product_rest(D_13, a_0, so_2b, so_2_right) + (D_03 * a_1_lo - D_13 * a_0_lo))
    so_2_rounded = so_2 + so_2_lo
    a_0_rounded = a_0 + a_0_lo
    a_1_rounded = a_1 + a_1_lo
    a_2_rounded = a_2 + a_2_lo
    return (so_0_rounded, so_1_rounded, so_2_rounded, a_0_rounded, a_1_rounded, a_2_rounded)


@kernel("(3,4),(3)->(6)")
def hstainv(D, axis):
    """so = -(R a ; 0), a = axis in the body's frame.

    (3,4),(3)->(6).  D: displacement [R | t], R rotation, t in m; axis: vector; so: screw (v in
    m/s; ω in rad/s).
    9 mul, 33 add, 9 product rest, 6 neg.  Error <= u |result| + (lin: 11, ang: 0) u^2 S, S the
    sum of the |terms| of the expanded formula; barring over- and underflow.
    """
    D_00, D_01, D_02, D_03, D_10, D_11, D_12, D_13, D_20, D_21, D_22, D_23 = D
    axis_0, axis_1, axis_2 = axis
    so_0a = D_00 * axis_0
    so_0b = D_01 * axis_1
    so_0c = so_0a + so_0b
    so_0c_right = so_0c - so_0a
    so_0d = D_02 * axis_2
    so_0e = so_0c + so_0d
    so_0e_right = so_0e - so_0c
    so_0c_lo = (product_rest(D_00, axis_0, so_0a, so_0c - so_0c_right)
        + product_rest(D_01, axis_1, so_0b, so_0c_right))
    so_0 = -so_0e
    so_1a = D_10 * axis_0
    so_1b = D_11 * axis_1
    so_1c = so_1a + so_1b
    so_1c_right = so_1c - so_1a
    so_1d = D_12 * axis_2
    so_1e = so_1c + so_1d
    so_1e_right = so_1e - so_1c
    so_1c_lo = (product_rest(D_10, axis_0, so_1a, so_1c - so_1c_right)
        + product_rest(D_11, axis_1, so_1b, so_1c_right))
    so_1 = -so_1e
    so_2a = D_20 * axis_0
    so_2b = D_21 * axis_1
    so_2c = so_2a + so_2b
    so_2c_right = so_2c - so_2a
    so_2d = D_22 * axis_2
    so_2e = so_2c + so_2d
    so_2e_right = so_2e - so_2c
    so_2c_lo = (product_rest(D_20, axis_0, so_2a, so_2c - so_2c_right)
        + product_rest(D_21, axis_1, so_2b, so_2c_right))
    so_2 = -so_2e
    so_0_rounded = (so_0 +
        -(so_0c - (so_0e - so_0e_right) + product_rest(D_02, axis_2, so_0d, so_0e_right)
        + so_0c_lo))
    so_1_rounded = (so_1 +
        -(so_1c - (so_1e - so_1e_right) + product_rest(D_12, axis_2, so_1d, so_1e_right)
        + so_1c_lo))
    so_2_rounded = (so_2 +
        -(so_2c - (so_2e - so_2e_right) + product_rest(D_22, axis_2, so_2d, so_2e_right)
        + so_2c_lo))
    return (so_0_rounded, so_1_rounded, so_2_rounded, 0, 0, 0)
