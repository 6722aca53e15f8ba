# Made by `coscrew generate`; changes are overwritten.
# SPDX-License-Identifier: MIT
# coscrew 0.2.0.  Copyright (c) 2026 The coscrew authors.
"""Coscrews: wrenches and momenta, c = (f; τ).

In double precision, accurate tier.
"""

from numpy import absolute, float64 as real, sqrt, where
from coscrew._exact import product_error, product_rest
from coscrew._kernel import double_kernel as kernel


@kernel("(6),()->(6)")
def coscrew_scale(self, a):
    """self = a self.

    (6),()->(6).  self: coscrew (f in N; τ in N m); a: number.
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
def axpy_cc(a, x, y):
    """y = a x + y.

    (),(6),(6)->(6).  a: number; x, y: coscrew (f in N; τ in N m).
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
def xpy_cc(x, y):
    """y = x + y.

    (6),(6)->(6).  x, y: coscrew (f in N; τ in N m).
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
def nxpy_cc(x, y):
    """y = -x + y.

    (6),(6)->(6).  x, y: coscrew (f in N; τ in N m).
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
def product_ac(a, ci):
    """co = a ci.

    (),(6)->(6).  a: number; ci, co: coscrew (f in N; τ in N m).
    6 mul, 6 add, 6 product error.  Error <= u |result|, barring over- and underflow.
    """
    ci_0, ci_1, ci_2, ci_3, ci_4, ci_5 = ci
    co_0 = a * ci_0
    co_1 = a * ci_1
    co_2 = a * ci_2
    co_3 = a * ci_3
    co_4 = a * ci_4
    co_5 = a * ci_5
    co_0_rounded = co_0 + product_error(a, ci_0, co_0)
    co_1_rounded = co_1 + product_error(a, ci_1, co_1)
    co_2_rounded = co_2 + product_error(a, ci_2, co_2)
    co_3_rounded = co_3 + product_error(a, ci_3, co_3)
    co_4_rounded = co_4 + product_error(a, ci_4, co_4)
    co_5_rounded = co_5 + product_error(a, ci_5, co_5)
    return (co_0_rounded, co_1_rounded, co_2_rounded, co_3_rounded, co_4_rounded, co_5_rounded)


@kernel("(6),(6)->(6)")
def add_cc(c1, c2):
    """co = c1 + c2.

    (6),(6)->(6).  c1, c2, co: coscrew (f in N; τ in N m).
    42 add.  Error <= u |result|, barring over- and underflow.
    """
    c1_0, c1_1, c1_2, c1_3, c1_4, c1_5 = c1
    c2_0, c2_1, c2_2, c2_3, c2_4, c2_5 = c2
    co_0 = c1_0 + c2_0
    co_0_right = co_0 - c1_0
    co_1 = c1_1 + c2_1
    co_1_right = co_1 - c1_1
    co_2 = c1_2 + c2_2
    co_2_right = co_2 - c1_2
    co_3 = c1_3 + c2_3
    co_3_right = co_3 - c1_3
    co_4 = c1_4 + c2_4
    co_4_right = co_4 - c1_4
    co_5 = c1_5 + c2_5
    co_5_right = co_5 - c1_5
    co_0_rounded = co_0 + (c1_0 - (co_0 - co_0_right) + (c2_0 - co_0_right))
    co_1_rounded = co_1 + (c1_1 - (co_1 - co_1_right) + (c2_1 - co_1_right))
    co_2_rounded = co_2 + (c1_2 - (co_2 - co_2_right) + (c2_2 - co_2_right))
    co_3_rounded = co_3 + (c1_3 - (co_3 - co_3_right) + (c2_3 - co_3_right))
    co_4_rounded = co_4 + (c1_4 - (co_4 - co_4_right) + (c2_4 - co_4_right))
    co_5_rounded = co_5 + (c1_5 - (co_5 - co_5_right) + (c2_5 - co_5_right))
    return (co_0_rounded, co_1_rounded, co_2_rounded, co_3_rounded, co_4_rounded, co_5_rounded)


@kernel("(6),(6)->(6)")
def subtract_cc(c1, c2):
    """co = c1 - c2.

    (6),(6)->(6).  c1, c2, co: coscrew (f in N; τ in N m).
    42 add.  Error <= u |result|, barring over- and underflow.
    """
    c1_0, c1_1, c1_2, c1_3, c1_4, c1_5 = c1
    c2_0, c2_1, c2_2, c2_3, c2_4, c2_5 = c2
    co_0 = c1_0 - c2_0
    co_0_right = c1_0 - co_0
    co_1 = c1_1 - c2_1
    co_1_right = c1_1 - co_1
    co_2 = c1_2 - c2_2
    co_2_right = c1_2 - co_2
    co_3 = c1_3 - c2_3
    co_3_right = c1_3 - co_3
    co_4 = c1_4 - c2_4
    co_4_right = c1_4 - co_4
    co_5 = c1_5 - c2_5
    co_5_right = c1_5 - co_5
    co_0_rounded = co_0 + (c1_0 - (co_0 + co_0_right) - (c2_0 - co_0_right))
    co_1_rounded = co_1 + (c1_1 - (co_1 + co_1_right) - (c2_1 - co_1_right))
    co_2_rounded = co_2 + (c1_2 - (co_2 + co_2_right) - (c2_2 - co_2_right))
    co_3_rounded = co_3 + (c1_3 - (co_3 + co_3_right) - (c2_3 - co_3_right))
    co_4_rounded = co_4 + (c1_4 - (co_4 + co_4_right) - (c2_4 - co_4_right))
    co_5_rounded = co_5 + (c1_5 - (co_5 + co_5_right) - (c2_5 - co_5_right))
    return (co_0_rounded, co_1_rounded, co_2_rounded, co_3_rounded, co_4_rounded, co_5_rounded)


@kernel("(6)->()")
def coscrew_norm(ci):
    """|ci|: |f|, or |τ| where every |f_i| is below 1e-9 (single: 1e-6).

    (6)->().  ci: coscrew (f in N; τ in N m); norm: number.
    10 mul, 29 add, 1 product error, 3 product rest, 2 div, 1 sqrt, 6 abs, 11 less, 3 equal, 16
    select.
    """
    ci_0, ci_1, ci_2, ci_3, ci_4, ci_5 = ci
    small = where(absolute(ci_0) < 1e-09, where(absolute(ci_1) < 1e-09,
        where(absolute(ci_2) < 1e-09, real(1), real(0)), 0), 0)
    p_0a = small == 1
    p_0 = where(p_0a, ci_3, ci_0)
    p_1 = where(p_0a, ci_4, ci_1)
    p_2 = where(p_0a, ci_5, ci_2)
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
def coscrew_normalize(self):
    """self = self / |self|, with coscrew_norm; the zero coscrew stays zero.

    (6)->(6).  self: coscrew (f in N; τ in N m).
    43 mul, 104 add, 7 product error, 3 product rest, 19 div, 1 sqrt, 9 abs, 16 less, 9 equal,
    34 select.
    """
    self_0, self_1, self_2, self_3, self_4, self_5 = self
    small_a = absolute(self_2)
    small_d = absolute(self_1)
    small_g = absolute(self_0)
    small = where(small_g < 1e-09, where(small_d < 1e-09, where(small_a < 1e-09, real(1), real(0)),
        0), 0)
    p_0a = small == 1
    p_0 = where(p_0a, self_3, self_0)
    p_1 = where(p_0a, self_4, self_1)
    p_2 = where(p_0a, self_5, self_2)
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
def coscrew_normalized(ci):
    """co = ci / |ci|, with coscrew_norm; the zero coscrew stays zero.

    (6)->(6).  ci, co: coscrew (f in N; τ in N m).
    43 mul, 104 add, 7 product error, 3 product rest, 19 div, 1 sqrt, 9 abs, 16 less, 9 equal,
    34 select.
    """
    ci_0, ci_1, ci_2, ci_3, ci_4, ci_5 = ci
    small_a = absolute(ci_2)
    small_d = absolute(ci_1)
    small_g = absolute(ci_0)
    small = where(small_g < 1e-09, where(small_d < 1e-09, where(small_a < 1e-09, real(1), real(0)),
        0), 0)
    p_0a = small == 1
    p_0 = where(p_0a, ci_3, ci_0)
    p_1 = where(p_0a, ci_4, ci_1)
    p_2 = where(p_0a, ci_5, ci_2)
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
    co_0 = quotient_0_sum * after_0
    co_0_rest = (quotient_0_sum - co_0 * (1 / after_0)
        + (quotient_0 - (quotient_0_sum - quotient_0_sum_right)
        + (quotient_0_lo - quotient_0_sum_right)))
    quotient_1_sum = quotient_1 + quotient_1_lo
    quotient_1_sum_right = quotient_1_sum - quotient_1
    co_1 = quotient_1_sum * after_1
    co_1_rest = (quotient_1_sum - co_1 * (1 / after_1)
        + (quotient_1 - (quotient_1_sum - quotient_1_sum_right)
        + (quotient_1_lo - quotient_1_sum_right)))
    quotient_2_sum = quotient_2 + quotient_2_lo
    quotient_2_sum_right = quotient_2_sum - quotient_2
    co_2 = quotient_2_sum * after_2
    co_2_rest = (quotient_2_sum - co_2 * (1 / after_2)
        + (quotient_2 - (quotient_2_sum - quotient_2_sum_right)
        + (quotient_2_lo - quotient_2_sum_right)))
    quotient_3_sum = quotient_3 + quotient_3_lo
    quotient_3_sum_right = quotient_3_sum - quotient_3
    co_3 = quotient_3_sum * after_3
    co_3_rest = (quotient_3_sum - co_3 * (1 / after_3)
        + (quotient_3 - (quotient_3_sum - quotient_3_sum_right)
        + (quotient_3_lo - quotient_3_sum_right)))
    quotient_4_sum = quotient_4 + quotient_4_lo
    quotient_4_sum_right = quotient_4_sum - quotient_4
    co_4 = quotient_4_sum * after_4
    co_4_rest = (quotient_4_sum - co_4 * (1 / after_4)
        + (quotient_4 - (quotient_4_sum - quotient_4_sum_right)
        + (quotient_4_lo - quotient_4_sum_right)))
    quotient_5_sum = quotient_5 + quotient_5_lo
    quotient_5_sum_right = quotient_5_sum - quotient_5
    co_5 = quotient_5_sum * after_5
    co_5_rest = (quotient_5_sum - co_5 * (1 / after_5)
        + (quotient_5 - (quotient_5_sum - quotient_5_sum_right)
        + (quotient_5_lo - quotient_5_sum_right)))
    co_0_rounded = co_0 + co_0_rest * after_0
    co_1_rounded = co_1 + co_1_rest * after_1
    co_2_rounded = co_2 + co_2_rest * after_2
    co_3_rounded = co_3 + co_3_rest * after_3
    co_4_rounded = co_4 + co_4_rest * after_4
    co_5_rounded = co_5 + co_5_rest * after_5
    co_0_final = where(co_0_rounded == co_0_rounded, co_0_rounded, co_0)
    co_1_final = where(co_1_rounded == co_1_rounded, co_1_rounded, co_1)
    co_2_final = where(co_2_rounded == co_2_rounded, co_2_rounded, co_2)
    co_3_final = where(co_3_rounded == co_3_rounded, co_3_rounded, co_3)
    co_4_final = where(co_4_rounded == co_4_rounded, co_4_rounded, co_4)
    co_5_final = where(co_5_rounded == co_5_rounded, co_5_rounded, co_5)
    return (co_0_final, co_1_final, co_2_final, co_3_final, co_4_final, co_5_final)


@kernel("(6),(6)->(6)")
def add_cct(c1, c2):
    """co = (c1.lin + c2.lin ; c1.ang).

    (6),(6)->(6).  c1, c2, co: coscrew (f in N; τ in N m).
    21 add.  Error <= u |result|, barring over- and underflow.
    """
    c1_0, c1_1, c1_2, c1_3, c1_4, c1_5 = c1
    c2_0, c2_1, c2_2, c2_3, c2_4, c2_5 = c2
    co_0 = c1_0 + c2_0
    co_0_right = co_0 - c1_0
    co_1 = c1_1 + c2_1
    co_1_right = co_1 - c1_1
    co_2 = c1_2 + c2_2
    co_2_right = co_2 - c1_2
    co_0_rounded = co_0 + (c1_0 - (co_0 - co_0_right) + (c2_0 - co_0_right))
    co_1_rounded = co_1 + (c1_1 - (co_1 - co_1_right) + (c2_1 - co_1_right))
    co_2_rounded = co_2 + (c1_2 - (co_2 - co_2_right) + (c2_2 - co_2_right))
    return (co_0_rounded, co_1_rounded, co_2_rounded, c1_3, c1_4, c1_5)


@kernel("(3),(6)->(6)")
def product_CoAdtc(t, ci):
    """co = [Ad]*(t) ci.

    (3),(6)->(6).  t: vector; ci, co: coscrew (f in N; τ in N m).
    6 mul, 36 add, 6 product rest.  Error <= u |result| + (lin: 0, ang: 9) u^2 S, S the sum of
    the |terms| of the expanded formula; barring over- and underflow.
    """
    t_0, t_1, t_2 = t
    ci_0, ci_1, ci_2, ci_3, ci_4, ci_5 = ci
    co_3a = t_1 * ci_2
    co_3b = t_2 * ci_1
    co_3c = co_3a - co_3b
    co_3c_right = co_3a - co_3c
    co_3 = co_3c + ci_3
    co_3_right = co_3 - co_3c
    co_3c_lo = (product_rest(t_1, ci_2, co_3a, co_3c + co_3c_right)
        - product_rest(t_2, ci_1, co_3b, co_3c_right))
    co_4a = t_2 * ci_0
    co_4b = t_0 * ci_2
    co_4c = co_4a - co_4b
    co_4c_right = co_4a - co_4c
    co_4 = co_4c + ci_4
    co_4_right = co_4 - co_4c
    co_4c_lo = (product_rest(t_2, ci_0, co_4a, co_4c + co_4c_right)
        - product_rest(t_0, ci_2, co_4b, co_4c_right))
    co_5a = t_0 * ci_1
    co_5b = t_1 * ci_0
    co_5c = co_5a - co_5b
    co_5c_right = co_5a - co_5c
    co_5 = co_5c + ci_5
    co_5_right = co_5 - co_5c
    co_5c_lo = (product_rest(t_0, ci_1, co_5a, co_5c + co_5c_right)
        - product_rest(t_1, ci_0, co_5b, co_5c_right))
    co_3_rounded = co_3 + (co_3c - (co_3 - co_3_right) + (ci_3 - co_3_right) + co_3c_lo)
    co_4_rounded = co_4 + (co_4c - (co_4 - co_4_right) + (ci_4 - co_4_right) + co_4c_lo)
    co_5_rounded = co_5 + (co_5c - (co_5 - co_5_right) + (ci_5 - co_5_right) + co_5c_lo)
    return (ci_0, ci_1, ci_2, co_3_rounded, co_4_rounded, co_5_rounded)


@kernel("(3),(6)->(6)")
def product_CoAdtinvc(t, ci):
    """co = [Ad]*(t)^-1 ci.

    (3),(6)->(6).  t: vector; ci, co: coscrew (f in N; τ in N m).
    6 mul, 36 add, 6 product rest.  Error <= u |result| + (lin: 0, ang: 9) u^2 S, S the sum of
    the |terms| of the expanded formula; barring over- and underflow.
    """
    t_0, t_1, t_2 = t
    ci_0, ci_1, ci_2, ci_3, ci_4, ci_5 = ci
    co_3a = t_2 * ci_1
    co_3b = t_1 * ci_2
    co_3c = co_3a - co_3b
    co_3c_right = co_3a - co_3c
    co_3 = co_3c + ci_3
    co_3_right = co_3 - co_3c
    co_3c_lo = (product_rest(t_2, ci_1, co_3a, co_3c + co_3c_right)
        - product_rest(t_1, ci_2, co_3b, co_3c_right))
    co_4a = t_0 * ci_2
    co_4b = t_2 * ci_0
    co_4c = co_4a - co_4b
    co_4c_right = co_4a - co_4c
    co_4 = co_4c + ci_4
    co_4_right = co_4 - co_4c
    co_4c_lo = (product_rest(t_0, ci_2, co_4a, co_4c + co_4c_right)
        - product_rest(t_2, ci_0, co_4b, co_4c_right))
    co_5a = t_1 * ci_0
    co_5b = t_0 * ci_1
    co_5c = co_5a - co_5b
    co_5c_right = co_5a - co_5c
    co_5 = co_5c + ci_5
    co_5_right = co_5 - co_5c
    co_5c_lo = (product_rest(t_1, ci_0, co_5a, co_5c + co_5c_right)
        - product_rest(t_0, ci_1, co_5b, co_5c_right))
    co_3_rounded = co_3 + (co_3c - (co_3 - co_3_right) + (ci_3 - co_3_right) + co_3c_lo)
    co_4_rounded = co_4 + (co_4c - (co_4 - co_4_right) + (ci_4 - co_4_right) + co_4c_lo)
    co_5_rounded = co_5 + (co_5c - (co_5 - co_5_right) + (ci_5 - co_5_right) + co_5c_lo)
    return (ci_0, ci_1, ci_2, co_3_rounded, co_4_rounded, co_5_rounded)


@kernel("(3),(6)->(6)")
def product_CoAdtcinv(t, ci):
    """co = [Ad]*(t) (-ci).

    (3),(6)->(6).  t: vector; ci, co: coscrew (f in N; τ in N m).
    6 mul, 36 add, 6 product rest, 3 neg.  Error <= u |result| + (lin: 0, ang: 9) u^2 S, S the
    sum of the |terms| of the expanded formula; barring over- and underflow.
    """
    t_0, t_1, t_2 = t
    ci_0, ci_1, ci_2, ci_3, ci_4, ci_5 = ci
    co_0 = -ci_0
    co_1 = -ci_1
    co_2 = -ci_2
    co_3a = t_2 * ci_1
    co_3b = t_1 * ci_2
    co_3c = co_3a - co_3b
    co_3c_right = co_3a - co_3c
    co_3 = co_3c - ci_3
    co_3_right = co_3c - co_3
    co_3c_lo = (product_rest(t_2, ci_1, co_3a, co_3c + co_3c_right)
        - product_rest(t_1, ci_2, co_3b, co_3c_right))
    co_4a = t_0 * ci_2
    co_4b = t_2 * ci_0
    co_4c = co_4a - co_4b
    co_4c_right = co_4a - co_4c
    co_4 = co_4c - ci_4
    co_4_right = co_4c - co_4
    co_4c_lo = (product_rest(t_0, ci_2, co_4a, co_4c + co_4c_right)
        - product_rest(t_2, ci_0, co_4b, co_4c_right))
    co_5a = t_1 * ci_0
    co_5b = t_0 * ci_1
    co_5c = co_5a - co_5b
    co_5c_right = co_5a - co_5c
    co_5 = co_5c - ci_5
    co_5_right = co_5c - co_5
    co_5c_lo = (product_rest(t_1, ci_0, co_5a, co_5c + co_5c_right)
        - product_rest(t_0, ci_1, co_5b, co_5c_right))
    co_3_rounded = co_3 + (co_3c - (co_3 + co_3_right) - (ci_3 - co_3_right) + co_3c_lo)
    co_4_rounded = co_4 + (co_4c - (co_4 + co_4_right) - (ci_4 - co_4_right) + co_4c_lo)
    co_5_rounded = co_5 + (co_5c - (co_5 + co_5_right) - (ci_5 - co_5_right) + co_5c_lo)
    return (co_0, co_1, co_2, co_3_rounded, co_4_rounded, co_5_rounded)


@kernel("(3,3),(6)->(6)")
def product_CoAdrc(R, ci):
    """co = [Ad]*(R) ci.

    (3,3),(6)->(6).  R: rotation or other 3×3 matrix; ci, co: coscrew (f in N; τ in N m).
    18 mul, 66 add, 18 product rest.  Error <= u |result| + 11 u^2 S, S the sum of the |terms|
    of the expanded formula; barring over- and underflow.
    """
    R_00, R_01, R_02, R_10, R_11, R_12, R_20, R_21, R_22 = R
    ci_0, ci_1, ci_2, ci_3, ci_4, ci_5 = ci
    co_0a = R_00 * ci_0
    co_0b = R_01 * ci_1
    co_0c = co_0a + co_0b
    co_0c_right = co_0c - co_0a
    co_0d = R_02 * ci_2
    co_0 = co_0c + co_0d
    co_0_right = co_0 - co_0c
    co_0c_lo = (product_rest(R_00, ci_0, co_0a, co_0c - co_0c_right)
        + product_rest(R_01, ci_1, co_0b, co_0c_right))
    co_1a = R_10 * ci_0
    co_1b = R_11 * ci_1
    co_1c = co_1a + co_1b
    co_1c_right = co_1c - co_1a
    co_1d = R_12 * ci_2
    co_1 = co_1c + co_1d
    co_1_right = co_1 - co_1c
    co_1c_lo = (product_rest(R_10, ci_0, co_1a, co_1c - co_1c_right)
        + product_rest(R_11, ci_1, co_1b, co_1c_right))
    co_2a = R_20 * ci_0
    co_2b = R_21 * ci_1
    co_2c = co_2a + co_2b
    co_2c_right = co_2c - co_2a
    co_2d = R_22 * ci_2
    co_2 = co_2c + co_2d
    co_2_right = co_2 - co_2c
    co_2c_lo = (product_rest(R_20, ci_0, co_2a, co_2c - co_2c_right)
        + product_rest(R_21, ci_1, co_2b, co_2c_right))
    co_3a = R_00 * ci_3
    co_3b = R_01 * ci_4
    co_3c = co_3a + co_3b
    co_3c_right = co_3c - co_3a
    co_3d = R_02 * ci_5
    co_3 = co_3c + co_3d
    co_3_right = co_3 - co_3c
    co_3c_lo = (product_rest(R_00, ci_3, co_3a, co_3c - co_3c_right)
        + product_rest(R_01, ci_4, co_3b, co_3c_right))
    co_4a = R_10 * ci_3
    co_4b = R_11 * ci_4
    co_4c = co_4a + co_4b
    co_4c_right = co_4c - co_4a
    co_4d = R_12 * ci_5
    co_4 = co_4c + co_4d
    co_4_right = co_4 - co_4c
    co_4c_lo = (product_rest(R_10, ci_3, co_4a, co_4c - co_4c_right)
        + product_rest(R_11, ci_4, co_4b, co_4c_right))
    co_5a = R_20 * ci_3
    co_5b = R_21 * ci_4
    co_5c = co_5a + co_5b
    co_5c_right = co_5c - co_5a
    co_5d = R_22 * ci_5
    co_5 = co_5c + co_5d
    co_5_right = co_5 - co_5c
    co_5c_lo = (product_rest(R_20, ci_3, co_5a, co_5c - co_5c_right)
        + product_rest(R_21, ci_4, co_5b, co_5c_right))
    co_0_rounded = (co_0
        + (co_0c - (co_0 - co_0_right) + product_rest(R_02, ci_2, co_0d, co_0_right) + co_0c_lo))
    co_1_rounded = (co_1
        + (co_1c - (co_1 - co_1_right) + product_rest(R_12, ci_2, co_1d, co_1_right) + co_1c_lo))
    co_2_rounded = (co_2
        + (co_2c - (co_2 - co_2_right) + product_rest(R_22, ci_2, co_2d, co_2_right) + co_2c_lo))
    co_3_rounded = (co_3
        + (co_3c - (co_3 - co_3_right) + product_rest(R_02, ci_5, co_3d, co_3_right) + co_3c_lo))
    co_4_rounded = (co_4
        + (co_4c - (co_4 - co_4_right) + product_rest(R_12, ci_5, co_4d, co_4_right) + co_4c_lo))
    co_5_rounded = (co_5
        + (co_5c - (co_5 - co_5_right) + product_rest(R_22, ci_5, co_5d, co_5_right) + co_5c_lo))
    return (co_0_rounded, co_1_rounded, co_2_rounded, co_3_rounded, co_4_rounded, co_5_rounded)


@kernel("(3,3),(6)->(6)")
def product_CoAdrinvc(R, ci):
    """co = [Ad]*(R)^-1 ci.

    (3,3),(6)->(6).  R: rotation or other 3×3 matrix; ci, co: coscrew (f in N; τ in N m).
    18 mul, 66 add, 18 product rest.  Error <= u |result| + 11 u^2 S, S the sum of the |terms|
    of the expanded formula; barring over- and underflow.
    """
    R_00, R_01, R_02, R_10, R_11, R_12, R_20, R_21, R_22 = R
    ci_0, ci_1, ci_2, ci_3, ci_4, ci_5 = ci
    co_0a = R_00 * ci_0
    co_0b = R_10 * ci_1
    co_0c = co_0a + co_0b
    co_0c_right = co_0c - co_0a
    co_0d = R_20 * ci_2
    co_0 = co_0c + co_0d
    co_0_right = co_0 - co_0c
    co_0c_lo = (product_rest(R_00, ci_0, co_0a, co_0c - co_0c_right)
        + product_rest(R_10, ci_1, co_0b, co_0c_right))
    co_1a = R_01 * ci_0
    co_1b = R_11 * ci_1
    co_1c = co_1a + co_1b
    co_1c_right = co_1c - co_1a
    co_1d = R_21 * ci_2
    co_1 = co_1c + co_1d
    co_1_right = co_1 - co_1c
    co_1c_lo = (product_rest(R_01, ci_0, co_1a, co_1c - co_1c_right)
        + product_rest(R_11, ci_1, co_1b, co_1c_right))
    co_2a = R_02 * ci_0
    co_2b = R_12 * ci_1
    co_2c = co_2a + co_2b
    co_2c_right = co_2c - co_2a
    co_2d = R_22 * ci_2
    co_2 = co_2c + co_2d
    co_2_right = co_2 - co_2c
    co_2c_lo = (product_rest(R_02, ci_0, co_2a, co_2c - co_2c_right)
        + product_rest(R_12, ci_1, co_2b, co_2c_right))
    co_3a = R_00 * ci_3
    co_3b = R_10 * ci_4
    co_3c = co_3a + co_3b
    co_3c_right = co_3c - co_3a
    co_3d = R_20 * ci_5
    co_3 = co_3c + co_3d
    co_3_right = co_3 - co_3c
    co_3c_lo = (product_rest(R_00, ci_3, co_3a, co_3c - co_3c_right)
        + product_rest(R_10, ci_4, co_3b, co_3c_right))
    co_4a = R_01 * ci_3
    co_4b = R_11 * ci_4
    co_4c = co_4a + co_4b
    co_4c_right = co_4c - co_4a
    co_4d = R_21 * ci_5
    co_4 = co_4c + co_4d
    co_4_right = co_4 - co_4c
    co_4c_lo = (product_rest(R_01, ci_3, co_4a, co_4c - co_4c_right)
        + product_rest(R_11, ci_4, co_4b, co_4c_right))
    co_5a = R_02 * ci_3
    co_5b = R_12 * ci_4
    co_5c = co_5a + co_5b
    co_5c_right = co_5c - co_5a
    co_5d = R_22 * ci_5
    co_5 = co_5c + co_5d
    co_5_right = co_5 - co_5c
    co_5c_lo = (product_rest(R_02, ci_3, co_5a, co_5c - co_5c_right)
        + product_rest(R_12, ci_4, co_5b, co_5c_right))
    co_0_rounded = (co_0
        + (co_0c - (co_0 - co_0_right) + product_rest(R_20, ci_2, co_0d, co_0_right) + co_0c_lo))
    co_1_rounded = (co_1
        + (co_1c - (co_1 - co_1_right) + product_rest(R_21, ci_2, co_1d, co_1_right) + co_1c_lo))
    co_2_rounded = (co_2
        + (co_2c - (co_2 - co_2_right) + product_rest(R_22, ci_2, co_2d, co_2_right) + co_2c_lo))
    co_3_rounded = (co_3
        + (co_3c - (co_3 - co_3_right) + product_rest(R_20, ci_5, co_3d, co_3_right) + co_3c_lo))
    co_4_rounded = (co_4
        + (co_4c - (co_4 - co_4_right) + product_rest(R_21, ci_5, co_4d, co_4_right) + co_4c_lo))
    co_5_rounded = (co_5
        + (co_5c - (co_5 - co_5_right) + product_rest(R_22, ci_5, co_5d, co_5_right) + co_5c_lo))
    return (co_0_rounded, co_1_rounded, co_2_rounded, co_3_rounded, co_4_rounded, co_5_rounded)


@kernel("(3,3),(6)->(6)")
def product_CoAdrcinv(R, ci):
    """co = [Ad]*(R) (-ci).

    (3,3),(6)->(6).  R: rotation or other 3×3 matrix; ci, co: coscrew (f in N; τ in N m).
    18 mul, 66 add, 18 product rest, 12 neg.  Error <= u |result| + 11 u^2 S, S the sum of the
    |terms| of the expanded formula; barring over- and underflow.
    """
    R_00, R_01, R_02, R_10, R_11, R_12, R_20, R_21, R_22 = R
    ci_0, ci_1, ci_2, ci_3, ci_4, ci_5 = ci
    co_0a = R_00 * ci_0
    co_0b = R_01 * ci_1
    co_0c = co_0a + co_0b
    co_0c_right = co_0c - co_0a
    co_0d = R_02 * ci_2
    co_0e = co_0c + co_0d
    co_0e_right = co_0e - co_0c
    co_0c_lo = (product_rest(R_00, ci_0, co_0a, co_0c - co_0c_right)
        + product_rest(R_01, ci_1, co_0b, co_0c_right))
    co_0 = -co_0e
    co_1a = R_10 * ci_0
    co_1b = R_11 * ci_1
    co_1c = co_1a + co_1b
    co_1c_right = co_1c - co_1a
    co_1d = R_12 * ci_2
    co_1e = co_1c + co_1d
    co_1e_right = co_1e - co_1c
    co_1c_lo = (product_rest(R_10, ci_0, co_1a, co_1c - co_1c_right)
        + product_rest(R_11, ci_1, co_1b, co_1c_right))
    co_1 = -co_1e
    co_2a = R_20 * ci_0
    co_2b = R_21 * ci_1
    co_2c = co_2a + co_2b
    co_2c_right = co_2c - co_2a
    co_2d = R_22 * ci_2
    co_2e = co_2c + co_2d
    co_2e_right = co_2e - co_2c
    co_2c_lo = (product_rest(R_20, ci_0, co_2a, co_2c - co_2c_right)
        + product_rest(R_21, ci_1, co_2b, co_2c_right))
    co_2 = -co_2e
    co_3a = R_00 * ci_3
    co_3b = R_01 * ci_4
    co_3c = co_3a + co_3b
    co_3c_right = co_3c - co_3a
    co_3d = R_02 * ci_5
    co_3e = co_3c + co_3d
    co_3e_right = co_3e - co_3c
    co_3c_lo = (product_rest(R_00, ci_3, co_3a, co_3c - co_3c_right)
        + product_rest(R_01, ci_4, co_3b, co_3c_right))
    co_3 = -co_3e
    co_4a = R_10 * ci_3
    co_4b = R_11 * ci_4
    co_4c = co_4a + co_4b
    co_4c_right = co_4c - co_4a
    co_4d = R_12 * ci_5
    co_4e = co_4c + co_4d
    co_4e_right = co_4e - co_4c
    co_4c_lo = (product_rest(R_10, ci_3, co_4a, co_4c - co_4c_right)
        + product_rest(R_11, ci_4, co_4b, co_4c_right))
    co_4 = -co_4e
    co_5a = R_20 * ci_3
    co_5b = R_21 * ci_4
    co_5c = co_5a + co_5b
    co_5c_right = co_5c - co_5a
    co_5d = R_22 * ci_5
    co_5e = co_5c + co_5d
    co_5e_right = co_5e - co_5c
    co_5c_lo = (product_rest(R_20, ci_3, co_5a, co_5c - co_5c_right)
        + product_rest(R_21, ci_4, co_5b, co_5c_right))
    co_5 = -co_5e
    co_0_rounded = (co_0 +
        -(co_0c - (co_0e - co_0e_right) + product_rest(R_02, ci_2, co_0d, co_0e_right) + co_0c_lo))
    co_1_rounded = (co_1 +
        -(co_1c - (co_1e - co_1e_right) + product_rest(R_12, ci_2, co_1d, co_1e_right) + co_1c_lo))
    co_2_rounded = (co_2 +
        -(co_2c - (co_2e - co_2e_right) + product_rest(R_22, ci_2, co_2d, co_2e_right) + co_2c_lo))
    co_3_rounded = (co_3 +
        -(co_3c - (co_3e - co_3e_right) + product_rest(R_02, ci_5, co_3d, co_3e_right) + co_3c_lo))
    co_4_rounded = (co_4 +
        -(co_4c - (co_4e - co_4e_right) + product_rest(R_12, ci_5, co_4d, co_4e_right) + co_4c_lo))
    co_5_rounded = (co_5 +
        -(co_5c - (co_5e - co_5e_right) + product_rest(R_22, ci_5, co_5d, co_5e_right) + co_5c_lo))
    return (co_0_rounded, co_1_rounded, co_2_rounded, co_3_rounded, co_4_rounded, co_5_rounded)


@kernel("(3,4),(6)->(6)")
def product_CoAdc(D, ci):
    """co = [Ad]*(D) ci = [Ad]*(t) [Ad]*(R) ci.

    (3,4),(6)->(6).  D: displacement [R | t], R rotation, t in m; ci, co: coscrew (f in N; τ in
    N m).
    30 mul, 108 add, 24 product rest.  Error <= u |result| + (lin: 11, ang: 35) u^2 S, S the sum
    of the |terms| of the expanded formula; barring over- and underflow.
    """
    D_00, D_01, D_02, D_03, D_10, D_11, D_12, D_13, D_20, D_21, D_22, D_23 = D
    ci_0, ci_1, ci_2, ci_3, ci_4, ci_5 = ci
    w_0a = D_00 * ci_0
    w_0b = D_01 * ci_1
    w_0c = w_0a + w_0b
    w_0c_right = w_0c - w_0a
    w_0d = D_02 * ci_2
    w_0 = w_0c + w_0d
    w_0_right = w_0 - w_0c
    w_0c_lo = (product_rest(D_00, ci_0, w_0a, w_0c - w_0c_right)
        + product_rest(D_01, ci_1, w_0b, w_0c_right))
    w_0_lo = w_0c - (w_0 - w_0_right) + product_rest(D_02, ci_2, w_0d, w_0_right) + w_0c_lo
    w_1a = D_10 * ci_0
    w_1b = D_11 * ci_1
    w_1c = w_1a + w_1b
    w_1c_right = w_1c - w_1a
    w_1d = D_12 * ci_2
    w_1 = w_1c + w_1d
    w_1_right = w_1 - w_1c
    w_1c_lo = (product_rest(D_10, ci_0, w_1a, w_1c - w_1c_right)
        + product_rest(D_11, ci_1, w_1b, w_1c_right))
    w_1_lo = w_1c - (w_1 - w_1_right) + product_rest(D_12, ci_2, w_1d, w_1_right) + w_1c_lo
    w_2a = D_20 * ci_0
    w_2b = D_21 * ci_1
    w_2c = w_2a + w_2b
    w_2c_right = w_2c - w_2a
    w_2d = D_22 * ci_2
    w_2 = w_2c + w_2d
    w_2_right = w_2 - w_2c
    w_2c_lo = (product_rest(D_20, ci_0, w_2a, w_2c - w_2c_right)
        + product_rest(D_21, ci_1, w_2b, w_2c_right))
    w_2_lo = w_2c - (w_2 - w_2_right) + product_rest(D_22, ci_2, w_2d, w_2_right) + w_2c_lo
    w_3a = D_00 * ci_3
    w_3b = D_01 * ci_4
    w_3c = w_3a + w_3b
    w_3c_right = w_3c - w_3a
    w_3d = D_02 * ci_5
    w_3 = w_3c + w_3d
    w_3_right = w_3 - w_3c
    w_3c_lo = (product_rest(D_00, ci_3, w_3a, w_3c - w_3c_right)
        + product_rest(D_01, ci_4, w_3b, w_3c_right))
    w_4a = D_10 * ci_3
    w_4b = D_11 * ci_4
    w_4c = w_4a + w_4b
    w_4c_right = w_4c - w_4a
    w_4d = D_12 * ci_5
    w_4 = w_4c + w_4d
    w_4_right = w_4 - w_4c
    w_4c_lo = (product_rest(D_10, ci_3, w_4a, w_4c - w_4c_right)
        + product_rest(D_11, ci_4, w_4b, w_4c_right))
    w_5a = D_20 * ci_3
    w_5b = D_21 * ci_4
    w_5c = w_5a + w_5b
    w_5c_right = w_5c - w_5a
    w_5d = D_22 * ci_5
    w_5 = w_5c + w_5d
    w_5_right = w_5 - w_5c
    w_5c_lo = (product_rest(D_20, ci_3, w_5a, w_5c - w_5c_right)
        + product_rest(D_21, ci_4, w_5b, w_5c_right))
    co_3a = D_13 * w_2
    co_3b = D_23 * w_1
    co_3c = co_3a - co_3b
    co_3c_right = co_3a - co_3c
    co_3 = co_3c + w_3
    co_3_right = co_3 - co_3c
    co_3_lo2 = (co_3c - (co_3 - co_3_right) + (w_3 - co_3_right)
        + (w_3c - (w_3 - w_3_right) + product_rest(D_02, ci_5, w_3d, w_3_right) + w_3c_lo))
    co_3c_lo = (product_rest(D_13, w_2, co_3a, co_3c + co_3c_right)
        - product_rest(D_23, w_1, co_3b, co_3c_right) + (D_13 * w_2_lo - D_23 * w_1_lo))
    co_4a = D_23 * w_0
    co_4b = D_03 * w_2
    co_4c = co_4a - co_4b
    co_4c_right = co_4a - co_4c
    co_4 = co_4c + w_4
    co_4_right = co_4 - co_4c
    co_4_lo2 = (co_4c - (co_4 - co_4_right) + (w_4 - co_4_right)
        + (w_4c - (w_4 - w_4_right) + product_rest(D_12, ci_5, w_4d, w_4_right) + w_4c_lo))
    co_4c_lo = (product_rest(D_23, w_0, co_4a, co_4c + co_4c_right)
        - product_rest(D_03, w_2, co_4b, co_4c_right) + (D_23 * w_0_lo - D_03 * w_2_lo))
    co_5a = D_03 * w_1
    co_5b = D_13 * w_0
    co_5c = co_5a - co_5b
    co_5c_right = co_5a - co_5c
    co_5 = co_5c + w_5
    co_5_right = co_5 - co_5c
    co_5_lo2 = (co_5c - (co_5 - co_5_right) + (w_5 - co_5_right)
        + (w_5c - (w_5 - w_5_right) + product_rest(D_22, ci_5, w_5d, w_5_right) + w_5c_lo))
    co_5c_lo = (product_rest(D_03, w_1, co_5a, co_5c + co_5c_right)
        - product_rest(D_13, w_0, co_5b, co_5c_right) + (D_03 * w_1_lo - D_13 * w_0_lo))
    w_0_rounded = w_0 + w_0_lo
    w_1_rounded = w_1 + w_1_lo
    w_2_rounded = w_2 + w_2_lo
    co_3_rounded = co_3 + (co_3_lo2 + co_3c_lo)
    co_4_rounded = co_4 + (co_4_lo2 + co_4c_lo)
    co_5_rounded = co_5 + (co_5_lo2 + co_5c_lo)
    return (w_0_rounded, w_1_rounded, w_2_rounded, co_3_rounded, co_4_rounded, co_5_rounded)


@kernel("(3,4),(6)->(6)")
def product_CoAdinvc(D, ci):
    """co = [Ad]*(D)^-1 ci = [Ad]*(R^T) [Ad]*(-t) ci.

    (3,4),(6)->(6).  D: displacement [R | t], R rotation, t in m; ci, co: coscrew (f in N; τ in
    N m).
    33 mul, 108 add, 24 product rest.  Error <= u |result| + (lin: 11, ang: 35) u^2 S, S the sum
    of the |terms| of the expanded formula; barring over- and underflow.
    """
    D_00, D_01, D_02, D_03, D_10, D_11, D_12, D_13, D_20, D_21, D_22, D_23 = D
    ci_0, ci_1, ci_2, ci_3, ci_4, ci_5 = ci
    w_3a = D_23 * ci_1
    w_3b = D_13 * ci_2
    w_3c = w_3a - w_3b
    w_3c_right = w_3a - w_3c
    w_3 = w_3c + ci_3
    w_3_right = w_3 - w_3c
    w_3c_lo = (product_rest(D_23, ci_1, w_3a, w_3c + w_3c_right)
        - product_rest(D_13, ci_2, w_3b, w_3c_right))
    w_3_lo = w_3c - (w_3 - w_3_right) + (ci_3 - w_3_right) + w_3c_lo
    w_4a = D_03 * ci_2
    w_4b = D_23 * ci_0
    w_4c = w_4a - w_4b
    w_4c_right = w_4a - w_4c
    w_4 = w_4c + ci_4
    w_4_right = w_4 - w_4c
    w_4c_lo = (product_rest(D_03, ci_2, w_4a, w_4c + w_4c_right)
        - product_rest(D_23, ci_0, w_4b, w_4c_right))
    w_4_lo = w_4c - (w_4 - w_4_right) + (ci_4 - w_4_right) + w_4c_lo
    w_5a = D_13 * ci_0
    w_5b = D_03 * ci_1
    w_5c = w_5a - w_5b
    w_5c_right = w_5a - w_5c
    w_5 = w_5c + ci_5
    w_5_right = w_5 - w_5c
    w_5c_lo = (product_rest(D_13, ci_0, w_5a, w_5c + w_5c_right)
        - product_rest(D_03, ci_1, w_5b, w_5c_right))
    w_5_lo = w_5c - (w_5 - w_5_right) + (ci_5 - w_5_right) + w_5c_lo
    co_0a = D_00 * ci_0
    co_0b = D_10 * ci_1
    co_0c = co_0a + co_0b
    co_0c_right = co_0c - co_0a
    co_0d = D_20 * ci_2
    co_0 = co_0c + co_0d
    co_0_right = co_0 - co_0c
    co_0c_lo = (product_rest(D_00, ci_0, co_0a, co_0c - co_0c_right)
        + product_rest(D_10, ci_1, co_0b, co_0c_right))
    co_1a = D_01 * ci_0
    co_1b = D_11 * ci_1
    co_1c = co_1a + co_1b
    co_1c_right = co_1c - co_1a
    co_1d = D_21 * ci_2
    co_1 = co_1c + co_1d
    co_1_right = co_1 - co_1c
    co_1c_lo = (product_rest(D_01, ci_0, co_1a, co_1c - co_1c_right)
        + product_rest(D_11, ci_1, co_1b, co_1c_right))
    co_2a = D_02 * ci_0
    co_2b = D_12 * ci_1
    co_2c = co_2a + co_2b
    co_2c_right = co_2c - co_2a
    co_2d = D_22 * ci_2
    co_2 = co_2c + co_2d
    co_2_right = co_2 - co_2c
    co_2c_lo = (product_rest(D_02, ci_0, co_2a, co_2c - co_2c_right)
        + product_rest(D_12, ci_1, co_2b, co_2c_right))
    co_3a = D_00 * w_3
    co_3b = D_10 * w_4
    co_3c = co_3a + co_3b
    co_3c_right = co_3c - co_3a
    co_3d = D_20 * w_5
    co_3 = co_3c + co_3d
    co_3_right = co_3 - co_3c
    co_3c_lo = (product_rest(D_00, w_3, co_3a, co_3c - co_3c_right)
        + product_rest(D_10, w_4, co_3b, co_3c_right) + (D_00 * w_3_lo + D_10 * w_4_lo))
    co_4a = D_01 * w_3
    co_4b = D_11 * w_4
    co_4c = co_4a + co_4b
    co_4c_right = co_4c - co_4a
    co_4d = D_21 * w_5
    co_4 = co_4c + co_4d
    co_4_right = co_4 - co_4c
    co_4c_lo = (product_rest(D_01, w_3, co_4a, co_4c - co_4c_right)
        + product_rest(D_11, w_4, co_4b, co_4c_right) + (D_01 * w_3_lo + D_11 * w_4_lo))
    co_5a = D_02 * w_3
    co_5b = D_12 * w_4
    co_5c = co_5a + co_5b
    co_5c_right = co_5c - co_5a
    co_5d = D_22 * w_5
    co_5 = co_5c + co_5d
    co_5_right = co_5 - co_5c
    co_5c_lo = (product_rest(D_02, w_3, co_5a, co_5c - co_5c_right)
        + product_rest(D_12, w_4, co_5b, co_5c_right) + (D_02 * w_3_lo + D_12 * w_4_lo))
    co_0_rounded = (co_0
        + (co_0c - (co_0 - co_0_right) + product_rest(D_20, ci_2, co_0d, co_0_right) + co_0c_lo))
    co_1_rounded = (co_1
        + (co_1c - (co_1 - co_1_right) + product_rest(D_21, ci_2, co_1d, co_1_right) + co_1c_lo))
    co_2_rounded = (co_2
        + (co_2c - (co_2 - co_2_right) + product_rest(D_22, ci_2, co_2d, co_2_right) + co_2c_lo))
    co_3_rounded = (co_3
        + (co_3c - (co_3 - co_3_right) + product_rest(D_20, w_5, co_3d, co_3_right) + D_20 * w_5_lo
        + co_3c_lo))
    co_4_rounded = (co_4
        + (co_4c - (co_4 - co_4_right) + product_rest(D_21, w_5, co_4d, co_4_right) + D_21 * w_5_lo
        + co_4c_lo))
    co_5_rounded = (co_5
        + (co_5c - (co_5 - co_5_right) + product_rest(D_22, w_5, co_5d, co_5_right) + D_22 * w_5_lo
        + co_5c_lo))
    return (co_0_rounded, co_1_rounded, co_2_rounded, co_3_rounded, co_4_rounded, co_5_rounded)


@kernel("(3,4),(6)->(6)")
def product_CoAdcinv(D, ci):
    """co = [Ad]*(D) (-ci).

    (3,4),(6)->(6).  D: displacement [R | t], R rotation, t in m; ci, co: coscrew (f in N; τ in
    N m).
    30 mul, 108 add, 24 product rest, 12 neg.  Error <= u |result| + (lin: 11, ang: 35) u^2 S, S
    the sum of the |terms| of the expanded formula; barring over- and underflow.
    """
    D_00, D_01, D_02, D_03, D_10, D_11, D_12, D_13, D_20, D_21, D_22, D_23 = D
    ci_0, ci_1, ci_2, ci_3, ci_4, ci_5 = ci
    w_0a = D_00 * ci_0
    w_0b = D_01 * ci_1
    w_0c = w_0a + w_0b
    w_0c_right = w_0c - w_0a
    w_0d = D_02 * ci_2
    w_0e = w_0c + w_0d
    w_0e_right = w_0e - w_0c
    w_0c_lo = (product_rest(D_00, ci_0, w_0a, w_0c - w_0c_right)
        + product_rest(D_01, ci_1, w_0b, w_0c_right))
    w_0 = -w_0e
    w_0_lo = -(w_0c - (w_0e - w_0e_right) + product_rest(D_02, ci_2, w_0d, w_0e_right) + w_0c_lo)
    w_1a = D_10 * ci_0
    w_1b = D_11 * ci_1
    w_1c = w_1a + w_1b
    w_1c_right = w_1c - w_1a
    w_1d = D_12 * ci_2
    w_1e = w_1c + w_1d
    w_1e_right = w_1e - w_1c
    w_1c_lo = (product_rest(D_10, ci_0, w_1a, w_1c - w_1c_right)
        + product_rest(D_11, ci_1, w_1b, w_1c_right))
    w_1 = -w_1e
    w_1_lo = -(w_1c - (w_1e - w_1e_right) + product_rest(D_12, ci_2, w_1d, w_1e_right) + w_1c_lo)
    w_2a = D_20 * ci_0
    w_2b = D_21 * ci_1
    w_2c = w_2a + w_2b
    w_2c_right = w_2c - w_2a
    w_2d = D_22 * ci_2
    w_2e = w_2c + w_2d
    w_2e_right = w_2e - w_2c
    w_2c_lo = (product_rest(D_20, ci_0, w_2a, w_2c - w_2c_right)
        + product_rest(D_21, ci_1, w_2b, w_2c_right))
    w_2 = -w_2e
    w_2_lo = -(w_2c - (w_2e - w_2e_right) + product_rest(D_22, ci_2, w_2d, w_2e_right) + w_2c_lo)
    w_3a = D_00 * ci_3
    w_3b = D_01 * ci_4
    w_3c = w_3a + w_3b
    w_3c_right = w_3c - w_3a
    w_3d = D_02 * ci_5
    w_3e = w_3c + w_3d
    w_3e_right = w_3e - w_3c
    w_3c_lo = (product_rest(D_00, ci_3, w_3a, w_3c - w_3c_right)
        + product_rest(D_01, ci_4, w_3b, w_3c_right))
    w_3 = -w_3e
    w_4a = D_10 * ci_3
    w_4b = D_11 * ci_4
    w_4c = w_4a + w_4b
    w_4c_right = w_4c - w_4a
    w_4d = D_12 * ci_5
    w_4e = w_4c + w_4d
    w_4e_right = w_4e - w_4c
    w_4c_lo = (product_rest(D_10, ci_3, w_4a, w_4c - w_4c_right)
        + product_rest(D_11, ci_4, w_4b, w_4c_right))
    w_4 = -w_4e
    w_5a = D_20 * ci_3
    w_5b = D_21 * ci_4
    w_5c = w_5a + w_5b
    w_5c_right = w_5c - w_5a
    w_5d = D_22 * ci_5
    w_5e = w_5c + w_5d
    w_5e_right = w_5e - w_5c
    w_5c_lo = (product_rest(D_20, ci_3, w_5a, w_5c - w_5c_right)
        + product_rest(D_21, ci_4, w_5b, w_5c_right))
    w_5 = -w_5e
    co_3a = D_13 * w_2
    co_3b = D_23 * w_1
    co_3c = co_3a - co_3b
    co_3c_right = co_3a - co_3c
    co_3 = co_3c + w_3
    co_3_right = co_3 - co_3c
    co_3_lo2 = (co_3c - (co_3 - co_3_right) + (w_3 - co_3_right) +
        -(w_3c - (w_3e - w_3e_right) + product_rest(D_02, ci_5, w_3d, w_3e_right) + w_3c_lo))
    co_3c_lo = (product_rest(D_13, w_2, co_3a, co_3c + co_3c_right)
        - product_rest(D_23, w_1, co_3b, co_3c_right) + (D_13 * w_2_lo - D_23 * w_1_lo))
    co_4a = D_23 * w_0
    co_4b = D_03 * w_2
    co_4c = co_4a - co_4b
    co_4c_right = co_4a - co_4c
    co_4 = co_4c + w_4
    co_4_right = co_4 - co_4c
    co_4_lo2 = (co_4c - (co_4 - co_4_right) + (w_4 - co_4_right) +
        -(w_4c - (w_4e - w_4e_right) + product_rest(D_12, ci_5, w_4d, w_4e_right) + w_4c_lo))
    co_4c_lo = (product_rest(D_23, w_0, co_4a, co_4c + co_4c_right)
        - product_rest(D_03, w_2, co_4b, co_4c_right) + (D_23 * w_0_lo - D_03 * w_2_lo))
    co_5a = D_03 * w_1
    co_5b = D_13 * w_0
    co_5c = co_5a - co_5b
    co_5c_right = co_5a - co_5c
    co_5 = co_5c + w_5
    co_5_right = co_5 - co_5c
    co_5_lo2 = (co_5c - (co_5 - co_5_right) + (w_5 - co_5_right) +
        -(w_5c - (w_5e - w_5e_right) + product_rest(D_22, ci_5, w_5d, w_5e_right) + w_5c_lo))
    co_5c_lo = (product_rest(D_03, w_1, co_5a, co_5c + co_5c_right)
        - product_rest(D_13, w_0, co_5b, co_5c_right) + (D_03 * w_1_lo - D_13 * w_0_lo))
    w_0_rounded = w_0 + w_0_lo
    w_1_rounded = w_1 + w_1_lo
    w_2_rounded = w_2 + w_2_lo
    co_3_rounded = co_3 + (co_3_lo2 + co_3c_lo)
    co_4_rounded = co_4 + (co_4_lo2 + co_4c_lo)
    co_5_rounded = co_5 + (co_5_lo2 + co_5c_lo)
    return (w_0_rounded, w_1_rounded, w_2_rounded, co_3_rounded, co_4_rounded, co_5_rounded)


@kernel("(3,4)->(6)")
def hctx(D):
    """co = h_tx: column 0 of [Ad]*(D).

    (3,4)->(6).  D: displacement [R | t], R rotation, t in m; co: coscrew (f in N; τ in N m).
    6 mul, 15 add, 6 product rest.  Error <= u |result| + (lin: 0, ang: 6) u^2 S, S the sum of
    the |terms| of the expanded formula; barring over- and underflow.
    """
    D_00, D_01, D_02, D_03, D_10, D_11, D_12, D_13, D_20, D_21, D_22, D_23 = D
    co_3a = D_20 * D_13
    co_3b = D_10 * D_23
    co_3 = co_3a - co_3b
    co_3_right = co_3a - co_3
    co_4a = D_00 * D_23
    co_4b = D_20 * D_03
    co_4 = co_4a - co_4b
    co_4_right = co_4a - co_4
    co_5a = D_10 * D_03
    co_5b = D_00 * D_13
    co_5 = co_5a - co_5b
    co_5_right = co_5a - co_5
    co_3_rounded = (co_3
        + (product_rest(D_20, D_13, co_3a, co_3 + co_3_right)
        - product_rest(D_10, D_23, co_3b, co_3_right)))
    co_4_rounded = (co_4
        + (product_rest(D_00, D_23, co_4a, co_4 + co_4_right)
        - product_rest(D_20, D_03, co_4b, co_4_right)))
    co_5_rounded = (co_5
        + (product_rest(D_10, D_03, co_5a, co_5 + co_5_right)
        - product_rest(D_00, D_13, co_5b, co_5_right)))
    return (D_00, D_10, D_20, co_3_rounded, co_4_rounded, co_5_rounded)


@kernel("(3,4)->(6)")
def hcty(D):
    """co = h_ty: column 1 of [Ad]*(D).

    (3,4)->(6).  D: displacement [R | t], R rotation, t in m; co: coscrew (f in N; τ in N m).
    6 mul, 15 add, 6 product rest.  Error <= u |result| + (lin: 0, ang: 6) u^2 S, S the sum of
    the |terms| of the expanded formula; barring over- and underflow.
    """
    D_00, D_01, D_02, D_03, D_10, D_11, D_12, D_13, D_20, D_21, D_22, D_23 = D
    co_3a = D_21 * D_13
    co_3b = D_11 * D_23
    co_3 = co_3a - co_3b
    co_3_right = co_3a - co_3
    co_4a = D_01 * D_23
    co_4b = D_21 * D_03
    co_4 = co_4a - co_4b
    co_4_right = co_4a - co_4
    co_5a = D_11 * D_03
    co_5b = D_01 * D_13
    co_5 = co_5a - co_5b
    co_5_right = co_5a - co_5
    co_3_rounded = (co_3
        + (product_rest(D_21, D_13, co_3a, co_3 + co_3_right)
        - product_rest(D_11, D_23, co_3b, co_3_right)))
    co_4_rounded = (co_4
        + (product_rest(D_01, D_23, co_4a, co_4 + co_4_right)
        - product_rest(D_21, D_03, co_4b, co_4_right)))
    co_5_rounded = (co_5
        + (product_rest(D_11, D_03, co_5a, co_5 + co_5_right)
        - product_rest(D_01, D_13, co_5b, co_5_right)))
    return (D_01, D_11, D_21, co_3_rounded, co_4_rounded, co_5_rounded)


@kernel("(3,4)->(6)")
def hctz(D):
    """co = h_tz: column 2 of [Ad]*(D).

    (3,4)->(6).  D: displacement [R | t], R rotation, t in m; co: coscrew (f in N; τ in N m).
    6 mul, 15 add, 6 product rest.  Error <= u |result| + (lin: 0, ang: 6) u^2 S, S the sum of
    the |terms| of the expanded formula; barring over- and underflow.
    """
    D_00, D_01, D_02, D_03, D_10, D_11, D_12, D_13, D_20, D_21, D_22, D_23 = D
    co_3a = D_22 * D_13
    co_3b = D_12 * D_23
    co_3 = co_3a - co_3b
    co_3_right = co_3a - co_3
    co_4a = D_02 * D_23
    co_4b = D_22 * D_03
    co_4 = co_4a - co_4b
    co_4_right = co_4a - co_4
    co_5a = D_12 * D_03
    co_5b = D_02 * D_13
    co_5 = co_5a - co_5b
    co_5_right = co_5a - co_5
    co_3_rounded = (co_3
        + (product_rest(D_22, D_13, co_3a, co_3 + co_3_right)
        - product_rest(D_12, D_23, co_3b, co_3_right)))
    co_4_rounded = (co_4
        + (product_rest(D_02, D_23, co_4a, co_4 + co_4_right)
        - product_rest(D_22, D_03, co_4b, co_4_right)))
    co_5_rounded = (co_5
        + (product_rest(D_12, D_03, co_5a, co_5 + co_5_right)
        - product_rest(D_02, D_13, co_5b, co_5_right)))
    return (D_02, D_12, D_22, co_3_rounded, co_4_rounded, co_5_rounded)


@kernel("(3,4)->(6)")
def hctxinv(D):
    """co = -h_tx: -column 0 of [Ad]*(D).

    (3,4)->(6).  D: displacement [R | t], R rotation, t in m; co: coscrew (f in N; τ in N m).
    6 mul, 15 add, 6 product rest, 3 neg.  Error <= u |result| + (lin: 0, ang: 6) u^2 S, S the
    sum of the |terms| of the expanded formula; barring over- and underflow.
    """
    D_00, D_01, D_02, D_03, D_10, D_11, D_12, D_13, D_20, D_21, D_22, D_23 = D
    co_0 = -D_00
    co_1 = -D_10
    co_2 = -D_20
    co_3a = D_10 * D_23
    co_3b = D_20 * D_13
    co_3 = co_3a - co_3b
    co_3_right = co_3a - co_3
    co_4a = D_20 * D_03
    co_4b = D_00 * D_23
    co_4 = co_4a - co_4b
    co_4_right = co_4a - co_4
    co_5a = D_00 * D_13
    co_5b = D_10 * D_03
    co_5 = co_5a - co_5b
    co_5_right = co_5a - co_5
    co_3_rounded = (co_3
        + (product_rest(D_10, D_23, co_3a, co_3 + co_3_right)
        - product_rest(D_20, D_13, co_3b, co_3_right)))
    co_4_rounded = (co_4
        + (product_rest(D_20, D_03, co_4a, co_4 + co_4_right)
        - product_rest(D_00, D_23, co_4b, co_4_right)))
    co_5_rounded = (co_5
        + (product_rest(D_00, D_13, co_5a, co_5 + co_5_right)
        - product_rest(D_10, D_03, co_5b, co_5_right)))
    return (co_0, co_1, co_2, co_3_rounded, co_4_rounded, co_5_rounded)


@kernel("(3,4)->(6)")
def hctyinv(D):
    """co = -h_ty: -column 1 of [Ad]*(D).

    (3,4)->(6).  D: displacement [R | t], R rotation, t in m; co: coscrew (f in N; τ in N m).
    6 mul, 15 add, 6 product rest, 3 neg.  Error <= u |result| + (lin: 0, ang: 6) u^2 S, S the
    sum of the |terms| of the expanded formula; barring over- and underflow.
    """
    D_00, D_01, D_02, D_03, D_10, D_11, D_12, D_13, D_20, D_21, D_22, D_23 = D
    co_0 = -D_01
    co_1 = -D_11
    co_2 = -D_21
    co_3a = D_11 * D_23
    co_3b = D_21 * D_13
    co_3 = co_3a - co_3b
    co_3_right = co_3a - co_3
    co_4a = D_21 * D_03
    co_4b = D_01 * D_23
    co_4 = co_4a - co_4b
    co_4_right = co_4a - co_4
    co_5a = D_01 * D_13
    co_5b = D_11 * D_03
    co_5 = co_5a - co_5b
    co_5_right = co_5a - co_5
    co_3_rounded = (co_3
        + (product_rest(D_11, D_23, co_3a, co_3 + co_3_right)
        - product_rest(D_21, D_13, co_3b, co_3_right)))
    co_4_rounded = (co_4
        + (product_rest(D_21, D_03, co_4a, co_4 + co_4_right)
        - product_rest(D_01, D_23, co_4b, co_4_right)))
    co_5_rounded = (co_5
        + (product_rest(D_01, D_13, co_5a, co_5 + co_5_right)
        - product_rest(D_11, D_03, co_5b, co_5_right)))
    return (co_0, co_1, co_2, co_3_rounded, co_4_rounded, co_5_rounded)


@kernel("(3,4)->(6)")
def hctzinv(D):
    """co = -h_tz: -column 2 of [Ad]*(D).

    (3,4)->(6).  D: displacement [R | t], R rotation, t in m; co: coscrew (f in N; τ in N m).
    6 mul, 15 add, 6 product rest, 3 neg.  Error <= u |result| + (lin: 0, ang: 6) u^2 S, S the
    sum of the |terms| of the expanded formula; barring over- and underflow.
    """
    D_00, D_01, D_02, D_03, D_10, D_11, D_12, D_13, D_20, D_21, D_22, D_23 = D
    co_0 = -D_02
    co_1 = -D_12
    co_2 = -D_22
    co_3a = D_12 * D_23
    co_3b = D_22 * D_13
    co_3 = co_3a - co_3b
    co_3_right = co_3a - co_3
    co_4a = D_22 * D_03
    co_4b = D_02 * D_23
    co_4 = co_4a - co_4b
    co_4_right = co_4a - co_4
    co_5a = D_02 * D_13
    co_5b = D_12 * D_03
    co_5 = co_5a - co_5b
    co_5_right = co_5a - co_5
    co_3_rounded = (co_3
        + (product_rest(D_12, D_23, co_3a, co_3 + co_3_right)
        - product_rest(D_22, D_13, co_3b, co_3_right)))
    co_4_rounded = (co_4
        + (product_rest(D_22, D_03, co_4a, co_4 + co_4_right)
        - product_rest(D_02, D_23, co_4b, co_4_right)))
    co_5_rounded = (co_5
        + (product_rest(D_02, D_13, co_5a, co_5 + co_5_right)
        - product_rest(D_12, D_03, co_5b, co_5_right)))
    return (co_0, co_1, co_2, co_3_rounded, co_4_rounded, co_5_rounded)


@kernel("(3,4)->(6,6)")
def CoAd(D):
    """M = [Ad]*(D).

    (3,4)->(6,6).  D: displacement [R | t], R rotation, t in m; M: 6×6 operator.
    18 mul, 45 add, 18 product rest.  Error <= u |result| + 6 u^2 S, S the sum of the |terms| of
    the expanded formula; barring over- and underflow.
    """
    D_00, D_01, D_02, D_03, D_10, D_11, D_12, D_13, D_20, D_21, D_22, D_23 = D
    M_30a = D_20 * D_13
    M_30b = D_10 * D_23
    M_30 = M_30a - M_30b
    M_30_right = M_30a - M_30
    M_31a = D_21 * D_13
    M_31b = D_11 * D_23
    M_31 = M_31a - M_31b
    M_31_right = M_31a - M_31
    M_32a = D_22 * D_13
    M_32b = D_12 * D_23
    M_32 = M_32a - M_32b
    M_32_right = M_32a - M_32
    M_40a = D_00 * D_23
    M_40b = D_20 * D_03
    M_40 = M_40a - M_40b
    M_40_right = M_40a - M_40
    M_41a = D_01 * D_23
    M_41b = D_21 * D_03
    M_41 = M_41a - M_41b
    M_41_right = M_41a - M_41
    M_42a = D_02 * D_23
    M_42b = D_22 * D_03
    M_42 = M_42a - M_42b
    M_42_right = M_42a - M_42
    M_50a = D_10 * D_03
    M_50b = D_00 * D_13
    M_50 = M_50a - M_50b
    M_50_right = M_50a - M_50
    M_51a = D_11 * D_03
    M_51b = D_01 * D_13
    M_51 = M_51a - M_51b
    M_51_right = M_51a - M_51
    M_52a = D_12 * D_03
    M_52b = D_02 * D_13
    M_52 = M_52a - M_52b
    M_52_right = M_52a - M_52
    M_30_rounded = (M_30
        + (product_rest(D_20, D_13, M_30a, M_30 + M_30_right)
        - product_rest(D_10, D_23, M_30b, M_30_right)))
    M_31_rounded = (M_31
        + (product_rest(D_21, D_13, M_31a, M_31 + M_31_right)
        - product_rest(D_11, D_23, M_31b, M_31_right)))
    M_32_rounded = (M_32
        + (product_rest(D_22, D_13, M_32a, M_32 + M_32_right)
        - product_rest(D_12, D_23, M_32b, M_32_right)))
    M_40_rounded = (M_40
        + (product_rest(D_00, D_23, M_40a, M_40 + M_40_right)
        - product_rest(D_20, D_03, M_40b, M_40_right)))
    M_41_rounded = (M_41
        + (product_rest(D_01, D_23, M_41a, M_41 + M_41_right)
        - product_rest(D_21, D_03, M_41b, M_41_right)))
    M_42_rounded = (M_42
        + (product_rest(D_02, D_23, M_42a, M_42 + M_42_right)
        - product_rest(D_22, D_03, M_42b, M_42_right)))
    M_50_rounded = (M_50
        + (product_rest(D_10, D_03, M_50a, M_50 + M_50_right)
        - product_rest(D_00, D_13, M_50b, M_50_right)))
    M_51_rounded = (M_51
        + (product_rest(D_11, D_03, M_51a, M_51 + M_51_right)
        - product_rest(D_01, D_13, M_51b, M_51_right)))
    M_52_rounded = (M_52
        + (product_rest(D_12, D_03, M_52a, M_52 + M_52_right)
        - product_rest(D_02, D_13, M_52b, M_52_right)))
    return (D_00, D_01, D_02, 0, 0, 0, D_10, D_11, D_12, 0, 0, 0, D_20, D_21, D_22, 0, 0, 0,
        M_30_rounded, M_31_rounded, M_32_rounded, D_00, D_01, D_02, M_40_rounded, M_41_rounded,
        M_42_rounded, D_10, D_11, D_12, M_50_rounded, M_51_rounded, M_52_rounded, D_20, D_21, D_22)


@kernel("(6),(6)->()")
def reciprocal_product(c, x):
    """power = W ⊙ $ = f·v + τ·ω, W = c = (f; τ), $ = x = (ω; v).

    (6),(6)->().  c: coscrew (f in N; τ in N m); x: six components with the angular part on top;
    power: number.
    6 mul, 29 add, 6 product rest.  Error <= u |result| + 19 u^2 S, S the sum of the |terms| of
    the expanded formula; barring over- and underflow.
    """
    c_0, c_1, c_2, c_3, c_4, c_5 = c
    x_0, x_1, x_2, x_3, x_4, x_5 = x
    power_a = c_0 * x_3
    power_b = c_1 * x_4
    power_c = power_a + power_b
    power_c_right = power_c - power_a
    power_d = c_2 * x_5
    power_e = power_c + power_d
    power_e_right = power_e - power_c
    power_c_lo = (product_rest(c_0, x_3, power_a, power_c - power_c_right)
        + product_rest(c_1, x_4, power_b, power_c_right))
    power_f = c_3 * x_0
    power_g = c_4 * x_1
    power_h = power_f + power_g
    power_h_right = power_h - power_f
    power_i = c_5 * x_2
    power_j = power_h + power_i
    power_j_right = power_j - power_h
    power_h_lo = (product_rest(c_3, x_0, power_f, power_h - power_h_right)
        + product_rest(c_4, x_1, power_g, power_h_right))
    power = power_e + power_j
    power_right = power - power_e
    power_j_lo = (power_h - (power_j - power_j_right)
        + product_rest(c_5, x_2, power_i, power_j_right) + power_h_lo)
    power_e_lo = (power_c - (power_e - power_e_right)
        + product_rest(c_2, x_5, power_d, power_e_right) + power_c_lo)
    power_rounded = (power
        + (power_e - (power - power_right) + (power_j - power_right) + power_j_lo + power_e_lo))
    return power_rounded


@kernel("(6),(6)->(6)")
def cross_sc(s, c):
    """co = [ad]*(s) c = (ω×f ; v×f + ω×τ).

    (6),(6)->(6).  s: screw (v in m/s; ω in rad/s); c, co: coscrew (f in N; τ in N m).
    18 mul, 66 add, 18 product rest.  Error <= u |result| + (lin: 6, ang: 12) u^2 S, S the sum
    of the |terms| of the expanded formula; barring over- and underflow.
    """
    s_0, s_1, s_2, s_3, s_4, s_5 = s
    c_0, c_1, c_2, c_3, c_4, c_5 = c
    co_0a = s_4 * c_2
    co_0b = s_5 * c_1
    co_0 = co_0a - co_0b
    co_0_right = co_0a - co_0
    co_1a = s_5 * c_0
    co_1b = s_3 * c_2
    co_1 = co_1a - co_1b
    co_1_right = co_1a - co_1
    co_2a = s_3 * c_1
    co_2b = s_4 * c_0
    co_2 = co_2a - co_2b
    co_2_right = co_2a - co_2
    co_3a = s_1 * c_2
    co_3b = s_2 * c_1
    co_3c = co_3a - co_3b
    co_3c_right = co_3a - co_3c
    co_3d = s_4 * c_5
    co_3e = s_5 * c_4
    co_3f = co_3d - co_3e
    co_3f_right = co_3d - co_3f
    co_3 = co_3c + co_3f
    co_3_right = co_3 - co_3c
    co_3f_lo = (product_rest(s_4, c_5, co_3d, co_3f + co_3f_right)
        - product_rest(s_5, c_4, co_3e, co_3f_right))
    co_3c_lo = (product_rest(s_1, c_2, co_3a, co_3c + co_3c_right)
        - product_rest(s_2, c_1, co_3b, co_3c_right))
    co_4a = s_2 * c_0
    co_4b = s_0 * c_2
    co_4c = co_4a - co_4b
    co_4c_right = co_4a - co_4c
    co_4d = s_5 * c_3
    co_4e = s_3 * c_5
    co_4f = co_4d - co_4e
    co_4f_right = co_4d - co_4f
    co_4 = co_4c + co_4f
    co_4_right = co_4 - co_4c
    co_4f_lo = (product_rest(s_5, c_3, co_4d, co_4f + co_4f_right)
        - product_rest(s_3, c_5, co_4e, co_4f_right))
    co_4c_lo = (product_rest(s_2, c_0, co_4a, co_4c + co_4c_right)
        - product_rest(s_0, c_2, co_4b, co_4c_right))
    co_5a = s_0 * c_1
    co_5b = s_1 * c_0
    co_5c = co_5a - co_5b
    co_5c_right = co_5a - co_5c
    co_5d = s_3 * c_4
    co_5e = s_4 * c_3
    co_5f = co_5d - co_5e
    co_5f_right = co_5d - co_5f
    co_5 = co_5c + co_5f
    co_5_right = co_5 - co_5c
    co_5f_lo = (product_rest(s_3, c_4, co_5d, co_5f + co_5f_right)
        - product_rest(s_4, c_3, co_5e, co_5f_right))
    co_5c_lo = (product_rest(s_0, c_1, co_5a, co_5c + co_5c_right)
        - product_rest(s_1, c_0, co_5b, co_5c_right))
    co_0_rounded = (co_0
        + (product_rest(s_4, c_2, co_0a, co_0 + co_0_right)
        - product_rest(s_5, c_1, co_0b, co_0_right)))
    co_1_rounded = (co_1
        + (product_rest(s_5, c_0, co_1a, co_1 + co_1_right)
        - product_rest(s_3, c_2, co_1b, co_1_right)))
    co_2_rounded = (co_2
        + (product_rest(s_3, c_1, co_2a, co_2 + co_2_right)
        - product_rest(s_4, c_0, co_2b, co_2_right)))
    co_3_rounded = co_3 + (co_3c - (co_3 - co_3_right) + (co_3f - co_3_right) + co_3f_lo + co_3c_lo)
    co_4_rounded = co_4 + (co_4c - (co_4 - co_4_right) + (co_4f - co_4_right) + co_4f_lo + co_4c_lo)
    co_5_rounded = co_5 + (co_5c - (co_5 - co_5_right) + (co_5f - co_5_right) + co_5f_lo + co_5c_lo)
    return (co_0_rounded, co_1_rounded, co_2_rounded, co_3_rounded, co_4_rounded, co_5_rounded)


@kernel("(6),(6)->(6)")
def cross_sca(s, c):
    """co = (0 ; ω×τ).

    (6),(6)->(6).  s: screw (v in m/s; ω in rad/s); c, co: coscrew (f in N; τ in N m).
    6 mul, 15 add, 6 product rest.  Error <= u |result| + (lin: 0, ang: 6) u^2 S, S the sum of
    the |terms| of the expanded formula; barring over- and underflow.
    """
    s_0, s_1, s_2, s_3, s_4, s_5 = s
    c_0, c_1, c_2, c_3, c_4, c_5 = c
    co_3a = s_4 * c_5
    co_3b = s_5 * c_4
    co_3 = co_3a - co_3b
    co_3_right = co_3a - co_3
    co_4a = s_5 * c_3
    co_4b = s_3 * c_5
    co_4 = co_4a - co_4b
    co_4_right = co_4a - co_4
    co_5a = s_3 * c_4
    co_5b = s_4 * c_3
    co_5 = co_5a - co_5b
    co_5_right = co_5a - co_5
    co_3_rounded = (co_3
        + (product_rest(s_4, c_5, co_3a, co_3 + co_3_right)
        - product_rest(s_5, c_4, co_3b, co_3_right)))
    co_4_rounded = (co_4
        + (product_rest(s_5, c_3, co_4a, co_4 + co_4_right)
        - product_rest(s_3, c_5, co_4b, co_4_right)))
    co_5_rounded = (co_5
        + (product_rest(s_3, c_4, co_5a, co_5 + co_5_right)
        - product_rest(s_4, c_3, co_5b, co_5_right)))
    return (0, 0, 0, co_3_rounded, co_4_rounded, co_5_rounded)


@kernel("(3,4),(6)->(6)")
def constraint_ctx(D, c):
    """co = H̄* c = [Ad]*(D) P c; P clears component 0 of c, given in the frame of a tx joint at D.

    (3,4),(6)->(6).  D: displacement [R | t], R rotation, t in m; c, co: coscrew (f in N; τ in N
    m).
    27 mul, 90 add, 21 product rest.  Error <= u |result| + (lin: 6, ang: 26) u^2 S, S the sum
    of the |terms| of the expanded formula; barring over- and underflow.
    """
    D_00, D_01, D_02, D_03, D_10, D_11, D_12, D_13, D_20, D_21, D_22, D_23 = D
    c_0, c_1, c_2, c_3, c_4, c_5 = c
    w_0a = D_01 * c_1
    w_0b = D_02 * c_2
    w_0 = w_0a + w_0b
    w_0_right = w_0 - w_0a
    w_0_lo = (product_rest(D_01, c_1, w_0a, w_0 - w_0_right)
        + product_rest(D_02, c_2, w_0b, w_0_right))
    w_1a = D_11 * c_1
    w_1b = D_12 * c_2
    w_1 = w_1a + w_1b
    w_1_right = w_1 - w_1a
    w_1_lo = (product_rest(D_11, c_1, w_1a, w_1 - w_1_right)
        + product_rest(D_12, c_2, w_1b, w_1_right))
    w_2a = D_21 * c_1
    w_2b = D_22 * c_2
    w_2 = w_2a + w_2b
    w_2_right = w_2 - w_2a
    w_2_lo = (product_rest(D_21, c_1, w_2a, w_2 - w_2_right)
        + product_rest(D_22, c_2, w_2b, w_2_right))
    w_3a = D_00 * c_3
    w_3b = D_01 * c_4
    w_3c = w_3a + w_3b
    w_3c_right = w_3c - w_3a
    w_3d = D_02 * c_5
    w_3 = w_3c + w_3d
    w_3_right = w_3 - w_3c
    w_3c_lo = (product_rest(D_00, c_3, w_3a, w_3c - w_3c_right)
        + product_rest(D_01, c_4, w_3b, w_3c_right))
    w_4a = D_10 * c_3
    w_4b = D_11 * c_4
    w_4c = w_4a + w_4b
    w_4c_right = w_4c - w_4a
    w_4d = D_12 * c_5
    w_4 = w_4c + w_4d
    w_4_right = w_4 - w_4c
    w_4c_lo = (product_rest(D_10, c_3, w_4a, w_4c - w_4c_right)
        + product_rest(D_11, c_4, w_4b, w_4c_right))
    w_5a = D_20 * c_3
    w_5b = D_21 * c_4
    w_5c = w_5a + w_5b
    w_5c_right = w_5c - w_5a
    w_5d = D_22 * c_5
    w_5 = w_5c + w_5d
    w_5_right = w_5 - w_5c
    w_5c_lo = (product_rest(D_20, c_3, w_5a, w_5c - w_5c_right)
        + product_rest(D_21, c_4, w_5b, w_5c_right))
    co_3a = D_13 * w_2
    co_3b = D_23 * w_1
    co_3c = co_3a - co_3b
    co_3c_right = co_3a - co_3c
    co_3 = co_3c + w_3
    co_3_right = co_3 - co_3c
    co_3c_lo = (product_rest(D_13, w_2, co_3a, co_3c + co_3c_right)
        - product_rest(D_23, w_1, co_3b, co_3c_right) + (D_13 * w_2_lo - D_23 * w_1_lo))
    co_3_lo2 = (co_3c - (co_3 - co_3_right) + (w_3 - co_3_right)
        + (w_3c - (w_3 - w_3_right) + product_rest(D_02, c_5, w_3d, w_3_right) + w_3c_lo))
    co_4a = D_23 * w_0
    co_4b = D_03 * w_2
    co_4c = co_4a - co_4b
    co_4c_right = co_4a - co_4c
    co_4 = co_4c + w_4
    co_4_right = co_4 - co_4c
    co_4c_lo = (product_rest(D_23, w_0, co_4a, co_4c + co_4c_right)
        - product_rest(D_03, w_2, co_4b, co_4c_right) + (D_23 * w_0_lo - D_03 * w_2_lo))
    co_4_lo2 = (co_4c - (co_4 - co_4_right) + (w_4 - co_4_right)
        + (w_4c - (w_4 - w_4_right) + product_rest(D_12, c_5, w_4d, w_4_right) + w_4c_lo))
    co_5a = D_03 * w_1
    co_5b = D_13 * w_0
    co_5c = co_5a - co_5b
    co_5c_right = co_5a - co_5c
    co_5 = co_5c + w_5
    co_5_right = co_5 - co_5c
    co_5c_lo = (product_rest(D_03, w_1, co_5a, co_5c + co_5c_right)
        - product_rest(D_13, w_0, co_5b, co_5c_right) + (D_03 * w_1_lo - D_13 * w_0_lo))
    co_5_lo2 = (co_5c - (co_5 - co_5_right) + (w_5 - co_5_right)
        + (w_5c - (w_5 - w_5_right) + product_rest(D_22, c_5, w_5d, w_5_right) + w_5c_lo))
    w_0_rounded = w_0 + w_0_lo
    w_1_rounded = w_1 + w_1_lo
    w_2_rounded = w_2 + w_2_lo
    co_3_rounded = co_3 + (co_3_lo2 + co_3c_lo)
    co_4_rounded = co_4 + (co_4_lo2 + co_4c_lo)
    co_5_rounded = co_5 + (co_5_lo2 + co_5c_lo)
    return (w_0_rounded, w_1_rounded, w_2_rounded, co_3_rounded, co_4_rounded, co_5_rounded)


@kernel("(3,4),(6)->(6)")
def constraint_cty(D, c):
    """co = H̄* c = [Ad]*(D) P c; P clears component 1 of c, given in the frame of a ty joint at D.

    (3,4),(6)->(6).  D: displacement [R | t], R rotation, t in m; c, co: coscrew (f in N; τ in N
    m).
    27 mul, 90 add, 21 product rest.  Error <= u |result| + (lin: 6, ang: 26) u^2 S, S the sum
    of the |terms| of the expanded formula; barring over- and underflow.
    """
    D_00, D_01, D_02, D_03, D_10, D_11, D_12, D_13, D_20, D_21, D_22, D_23 = D
    c_0, c_1, c_2, c_3, c_4, c_5 = c
    w_0a = D_00 * c_0
    w_0b = D_02 * c_2
    w_0 = w_0a + w_0b
    w_0_right = w_0 - w_0a
    w_0_lo = (product_rest(D_00, c_0, w_0a, w_0 - w_0_right)
        + product_rest(D_02, c_2, w_0b, w_0_right))
    w_1a = D_10 * c_0
    w_1b = D_12 * c_2
    w_1 = w_1a + w_1b
    w_1_right = w_1 - w_1a
    w_1_lo = (product_rest(D_10, c_0, w_1a, w_1 - w_1_right)
        + product_rest(D_12, c_2, w_1b, w_1_right))
    w_2a = D_20 * c_0
    w_2b = D_22 * c_2
    w_2 = w_2a + w_2b
    w_2_right = w_2 - w_2a
    w_2_lo = (product_rest(D_20, c_0, w_2a, w_2 - w_2_right)
        + product_rest(D_22, c_2, w_2b, w_2_right))
    w_3a = D_00 * c_3
    w_3b = D_01 * c_4
    w_3c = w_3a + w_3b
    w_3c_right = w_3c - w_3a
    w_3d = D_02 * c_5
    w_3 = w_3c + w_3d
    w_3_right = w_3 - w_3c
    w_3c_lo = (product_rest(D_00, c_3, w_3a, w_3c - w_3c_right)
        + product_rest(D_01, c_4, w_3b, w_3c_right))
    w_4a = D_10 * c_3
    w_4b = D_11 * c_4
    w_4c = w_4a + w_4b
    w_4c_right = w_4c - w_4a
    w_4d = D_12 * c_5
    w_4 = w_4c + w_4d
    w_4_right = w_4 - w_4c
    w_4c_lo = (product_rest(D_10, c_3, w_4a, w_4c - w_4c_right)
        + product_rest(D_11, c_4, w_4b, w_4c_right))
    w_5a = D_20 * c_3
    w_5b = D_21 * c_4
    w_5c = w_5a + w_5b
    w_5c_right = w_5c - w_5a
    w_5d = D_22 * c_5
    w_5 = w_5c + w_5d
    w_5_right = w_5 - w_5c
    w_5c_lo = (product_rest(D_20, c_3, w_5a, w_5c - w_5c_right)
        + product_rest(D_21, c_4, w_5b, w_5c_right))
    co_3a = D_13 * w_2
    co_3b = D_23 * w_1
    co_3c = co_3a - co_3b
    co_3c_right = co_3a - co_3c
    co_3 = co_3c + w_3
    co_3_right = co_3 - co_3c
    co_3c_lo = (product_rest(D_13, w_2, co_3a, co_3c + co_3c_right)
        - product_rest(D_23, w_1, co_3b, co_3c_right) + (D_13 * w_2_lo - D_23 * w_1_lo))
    co_3_lo2 = (co_3c - (co_3 - co_3_right) + (w_3 - co_3_right)
        + (w_3c - (w_3 - w_3_right) + product_rest(D_02, c_5, w_3d, w_3_right) + w_3c_lo))
    co_4a = D_23 * w_0
    co_4b = D_03 * w_2
    co_4c = co_4a - co_4b
    co_4c_right = co_4a - co_4c
    co_4 = co_4c + w_4
    co_4_right = co_4 - co_4c
    co_4c_lo = (product_rest(D_23, w_0, co_4a, co_4c + co_4c_right)
        - product_rest(D_03, w_2, co_4b, co_4c_right) + (D_23 * w_0_lo - D_03 * w_2_lo))
    co_4_lo2 = (co_4c - (co_4 - co_4_right) + (w_4 - co_4_right)
        + (w_4c - (w_4 - w_4_right) + product_rest(D_12, c_5, w_4d, w_4_right) + w_4c_lo))
    co_5a = D_03 * w_1
    co_5b = D_13 * w_0
    co_5c = co_5a - co_5b
    co_5c_right = co_5a - co_5c
    co_5 = co_5c + w_5
    co_5_right = co_5 - co_5c
    co_5c_lo = (product_rest(D_03, w_1, co_5a, co_5c + co_5c_right)
        - product_rest(D_13, w_0, co_5b, co_5c_right) + (D_03 * w_1_lo - D_13 * w_0_lo))
    co_5_lo2 = (co_5c - (co_5 - co_5_right) + (w_5 - co_5_right)
        + (w_5c - (w_5 - w_5_right) + product_rest(D_22, c_5, w_5d, w_5_right) + w_5c_lo))
    w_0_rounded = w_0 + w_0_lo
    w_1_rounded = w_1 + w_1_lo
    w_2_rounded = w_2 + w_2_lo
    co_3_rounded = co_3 + (co_3_lo2 + co_3c_lo)
    co_4_rounded = co_4 + (co_4_lo2 + co_4c_lo)
    co_5_rounded = co_5 + (co_5_lo2 + co_5c_lo)
    return (w_0_rounded, w_1_rounded, w_2_rounded, co_3_rounded, co_4_rounded, co_5_rounded)


@kernel("(3,4),(6)->(6)")
def constraint_ctz(D, c):
    """co = H̄* c = [Ad]*(D) P c; P clears component 2 of c, given in the frame of a tz joint at D.

    (3,4),(6)->(6).  D: displacement [R | t], R rotation, t in m; c, co: coscrew (f in N; τ in N
    m).
    27 mul, 90 add, 21 product rest.  Error <= u |result| + (lin: 6, ang: 26) u^2 S, S the sum
    of the |terms| of the expanded formula; barring over- and underflow.
    """
    D_00, D_01, D_02, D_03, D_10, D_11, D_12, D_13, D_20, D_21, D_22, D_23 = D
    c_0, c_1, c_2, c_3, c_4, c_5 = c
    w_0a = D_00 * c_0
    w_0b = D_01 * c_1
    w_0 = w_0a + w_0b
    w_0_right = w_0 - w_0a
    w_0_lo = (product_rest(D_00, c_0, w_0a, w_0 - w_0_right)
        + product_rest(D_01, c_1, w_0b, w_0_right))
    w_1a = D_10 * c_0
    w_1b = D_11 * c_1
    w_1 = w_1a + w_1b
    w_1_right = w_1 - w_1a
    w_1_lo = (product_rest(D_10, c_0, w_1a, w_1 - w_1_right)
        + product_rest(D_11, c_1, w_1b, w_1_right))
    w_2a = D_20 * c_0
    w_2b = D_21 * c_1
    w_2 = w_2a + w_2b
    w_2_right = w_2 - w_2a
    w_2_lo = (product_rest(D_20, c_0, w_2a, w_2 - w_2_right)
        + product_rest(D_21, c_1, w_2b, w_2_right))
    w_3a = D_00 * c_3
    w_3b = D_01 * c_4
    w_3c = w_3a + w_3b
    w_3c_right = w_3c - w_3a
    w_3d = D_02 * c_5
    w_3 = w_3c + w_3d
    w_3_right = w_3 - w_3c
    w_3c_lo = (product_rest(D_00, c_3, w_3a, w_3c - w_3c_right)
        + product_rest(D_01, c_4, w_3b, w_3c_right))
    w_4a = D_10 * c_3
    w_4b = D_11 * c_4
    w_4c = w_4a + w_4b
    w_4c_right = w_4c - w_4a
    w_4d = D_12 * c_5
    w_4 = w_4c + w_4d
    w_4_right = w_4 - w_4c
    w_4c_lo = (product_rest(D_10, c_3, w_4a, w_4c - w_4c_right)
        + product_rest(D_11, c_4, w_4b, w_4c_right))
    w_5a = D_20 * c_3
    w_5b = D_21 * c_4
    w_5c = w_5a + w_5b
    w_5c_right = w_5c - w_5a
    w_5d = D_22 * c_5
    w_5 = w_5c + w_5d
    w_5_right = w_5 - w_5c
    w_5c_lo = (product_rest(D_20, c_3, w_5a, w_5c - w_5c_right)
        + product_rest(D_21, c_4, w_5b, w_5c_right))
    co_3a = D_13 * w_2
    co_3b = D_23 * w_1
    co_3c = co_3a - co_3b
    co_3c_right = co_3a - co_3c
    co_3 = co_3c + w_3
    co_3_right = co_3 - co_3c
    co_3c_lo = (product_rest(D_13, w_2, co_3a, co_3c + co_3c_right)
        - product_rest(D_23, w_1, co_3b, co_3c_right) + (D_13 * w_2_lo - D_23 * w_1_lo))
    co_3_lo2 = (co_3c - (co_3 - co_3_right) + (w_3 - co_3_right)
        + (w_3c - (w_3 - w_3_right) + product_rest(D_02, c_5, w_3d, w_3_right) + w_3c_lo))
    co_4a = D_23 * w_0
    co_4b = D_03 * w_2
    co_4c = co_4a - co_4b
    co_4c_right = co_4a - co_4c
    co_4 = co_4c + w_4
    co_4_right = co_4 - co_4c
    co_4c_lo = (product_rest(D_23, w_0, co_4a, co_4c + co_4c_right)
        - product_rest(D_03, w_2, co_4b, co_4c_right) + (D_23 * w_0_lo - D_03 * w_2_lo))
    co_4_lo2 = (co_4c - (co_4 - co_4_right) + (w_4 - co_4_right)
        + (w_4c - (w_4 - w_4_right) + product_rest(D_12, c_5, w_4d, w_4_right) + w_4c_lo))
    co_5a = D_03 * w_1
    co_5b = D_13 * w_0
    co_5c = co_5a - co_5b
    co_5c_right = co_5a - co_5c
    co_5 = co_5c + w_5
    co_5_right = co_5 - co_5c
    co_5c_lo = (product_rest(D_03, w_1, co_5a, co_5c + co_5c_right)
        - product_rest(D_13, w_0, co_5b, co_5c_right) + (D_03 * w_1_lo - D_13 * w_0_lo))
    co_5_lo2 = (co_5c - (co_5 - co_5_right) + (w_5 - co_5_right)
        + (w_5c - (w_5 - w_5_right) + product_rest(D_22, c_5, w_5d, w_5_right) + w_5c_lo))
    w_0_rounded = w_0 + w_0_lo
    w_1_rounded = w_1 + w_1_lo
    w_2_rounded = w_2 + w_2_lo
    co_3_rounded = co_3 + (co_3_lo2 + co_3c_lo)
    co_4_rounded = co_4 + (co_4_lo2 + co_4c_lo)
    co_5_rounded = co_5 + (co_5_lo2 + co_5c_lo)
    return (w_0_rounded, w_1_rounded, w_2_rounded, co_3_rounded, co_4_rounded, co_5_rounded)


@kernel("(3,4),(6)->(6)")
def constraint_crx(D, c):
    """co = H̄* c = [Ad]*(D) P c; P clears component 3 of c, given in the frame of a rx joint at D.

    (3,4),(6)->(6).  D: displacement [R | t], R rotation, t in m; c, co: coscrew (f in N; τ in N
    m).
    27 mul, 90 add, 21 product rest.  Error <= u |result| + (lin: 11, ang: 35) u^2 S, S the sum
    of the |terms| of the expanded formula; barring over- and underflow.
    """
    D_00, D_01, D_02, D_03, D_10, D_11, D_12, D_13, D_20, D_21, D_22, D_23 = D
    c_0, c_1, c_2, c_3, c_4, c_5 = c
    w_0a = D_00 * c_0
    w_0b = D_01 * c_1
    w_0c = w_0a + w_0b
    w_0c_right = w_0c - w_0a
    w_0d = D_02 * c_2
    w_0 = w_0c + w_0d
    w_0_right = w_0 - w_0c
    w_0c_lo = (product_rest(D_00, c_0, w_0a, w_0c - w_0c_right)
        + product_rest(D_01, c_1, w_0b, w_0c_right))
    w_0_lo = w_0c - (w_0 - w_0_right) + product_rest(D_02, c_2, w_0d, w_0_right) + w_0c_lo
    w_1a = D_10 * c_0
    w_1b = D_11 * c_1
    w_1c = w_1a + w_1b
    w_1c_right = w_1c - w_1a
    w_1d = D_12 * c_2
    w_1 = w_1c + w_1d
    w_1_right = w_1 - w_1c
    w_1c_lo = (product_rest(D_10, c_0, w_1a, w_1c - w_1c_right)
        + product_rest(D_11, c_1, w_1b, w_1c_right))
    w_1_lo = w_1c - (w_1 - w_1_right) + product_rest(D_12, c_2, w_1d, w_1_right) + w_1c_lo
    w_2a = D_20 * c_0
    w_2b = D_21 * c_1
    w_2c = w_2a + w_2b
    w_2c_right = w_2c - w_2a
    w_2d = D_22 * c_2
    w_2 = w_2c + w_2d
    w_2_right = w_2 - w_2c
    w_2c_lo = (product_rest(D_20, c_0, w_2a, w_2c - w_2c_right)
        + product_rest(D_21, c_1, w_2b, w_2c_right))
    w_2_lo = w_2c - (w_2 - w_2_right) + product_rest(D_22, c_2, w_2d, w_2_right) + w_2c_lo
    w_3a = D_01 * c_4
    w_3b = D_02 * c_5
    w_3 = w_3a + w_3b
    w_3_right = w_3 - w_3a
    w_4a = D_11 * c_4
    w_4b = D_12 * c_5
    w_4 = w_4a + w_4b
    w_4_right = w_4 - w_4a
    w_5a = D_21 * c_4
    w_5b = D_22 * c_5
    w_5 = w_5a + w_5b
    w_5_right = w_5 - w_5a
    co_3a = D_13 * w_2
    co_3b = D_23 * w_1
    co_3c = co_3a - co_3b
    co_3c_right = co_3a - co_3c
    co_3 = co_3c + w_3
    co_3_right = co_3 - co_3c
    w_3_lo = (product_rest(D_01, c_4, w_3a, w_3 - w_3_right)
        + product_rest(D_02, c_5, w_3b, w_3_right))
    co_3c_lo = (product_rest(D_13, w_2, co_3a, co_3c + co_3c_right)
        - product_rest(D_23, w_1, co_3b, co_3c_right) + (D_13 * w_2_lo - D_23 * w_1_lo))
    co_4a = D_23 * w_0
    co_4b = D_03 * w_2
    co_4c = co_4a - co_4b
    co_4c_right = co_4a - co_4c
    co_4 = co_4c + w_4
    co_4_right = co_4 - co_4c
    w_4_lo = (product_rest(D_11, c_4, w_4a, w_4 - w_4_right)
        + product_rest(D_12, c_5, w_4b, w_4_right))
    co_4c_lo = (product_rest(D_23, w_0, co_4a, co_4c + co_4c_right)
        - product_rest(D_03, w_2, co_4b, co_4c_right) + (D_23 * w_0_lo - D_03 * w_2_lo))
    co_5a = D_03 * w_1
    co_5b = D_13 * w_0
    co_5c = co_5a - co_5b
    co_5c_right = co_5a - co_5c
    co_5 = co_5c + w_5
    co_5_right = co_5 - co_5c
    w_5_lo = (product_rest(D_21, c_4, w_5a, w_5 - w_5_right)
        + product_rest(D_22, c_5, w_5b, w_5_right))
    co_5c_lo = (product_rest(D_03, w_1, co_5a, co_5c + co_5c_right)
        - product_rest(D_13, w_0, co_5b, co_5c_right) + (D_03 * w_1_lo - D_13 * w_0_lo))
    w_0_rounded = w_0 + w_0_lo
    w_1_rounded = w_1 + w_1_lo
    w_2_rounded = w_2 + w_2_lo
    co_3_rounded = co_3 + (co_3c - (co_3 - co_3_right) + (w_3 - co_3_right) + w_3_lo + co_3c_lo)
    co_4_rounded = co_4 + (co_4c - (co_4 - co_4_right) + (w_4 - co_4_right) + w_4_lo + co_4c_lo)
    co_5_rounded = co_5 + (co_5c - (co_5 - co_5_right) + (w_5 - co_5_right) + w_5_lo + co_5c_lo)
    return (w_0_rounded, w_1_rounded, w_2_rounded, co_3_rounded, co_4_rounded, co_5_rounded)


@kernel("(3,4),(6)->(6)")
def constraint_cry(D, c):
    """co = H̄* c = [Ad]*(D) P c; P clears component 4 of c, given in the frame of a ry joint at D.

    (3,4),(6)->(6).  D: displacement [R | t], R rotation, t in m; c, co: coscrew (f in N; τ in N
    m).
    27 mul, 90 add, 21 product rest.  Error <= u |result| + (lin: 11, ang: 35) u^2 S, S the sum
    of the |terms| of the expanded formula; barring over- and underflow.
    """
    D_00, D_01, D_02, D_03, D_10, D_11, D_12, D_13, D_20, D_21, D_22, D_23 = D
    c_0, c_1, c_2, c_3, c_4, c_5 = c
    w_0a = D_00 * c_0
    w_0b = D_01 * c_1
    w_0c = w_0a + w_0b
    w_0c_right = w_0c - w_0a
    w_0d = D_02 * c_2
    w_0 = w_0c + w_0d
    w_0_right = w_0 - w_0c
    w_0c_lo = (product_rest(D_00, c_0, w_0a, w_0c - w_0c_right)
        + product_rest(D_01, c_1, w_0b, w_0c_right))
    w_0_lo = w_0c - (w_0 - w_0_right) + product_rest(D_02, c_2, w_0d, w_0_right) + w_0c_lo
    w_1a = D_10 * c_0
    w_1b = D_11 * c_1
    w_1c = w_1a + w_1b
    w_1c_right = w_1c - w_1a
    w_1d = D_12 * c_2
    w_1 = w_1c + w_1d
    w_1_right = w_1 - w_1c
    w_1c_lo = (product_rest(D_10, c_0, w_1a, w_1c - w_1c_right)
        + product_rest(D_11, c_1, w_1b, w_1c_right))
    w_1_lo = w_1c - (w_1 - w_1_right) + product_rest(D_12, c_2, w_1d, w_1_right) + w_1c_lo
    w_2a = D_20 * c_0
    w_2b = D_21 * c_1
    w_2c = w_2a + w_2b
    w_2c_right = w_2c - w_2a
    w_2d = D_22 * c_2
    w_2 = w_2c + w_2d
    w_2_right = w_2 - w_2c
    w_2c_lo = (product_rest(D_20, c_0, w_2a, w_2c - w_2c_right)
        + product_rest(D_21, c_1, w_2b, w_2c_right))
    w_2_lo = w_2c - (w_2 - w_2_right) + product_rest(D_22, c_2, w_2d, w_2_right) + w_2c_lo
    w_3a = D_00 * c_3
    w_3b = D_02 * c_5
    w_3 = w_3a + w_3b
    w_3_right = w_3 - w_3a
    w_4a = D_10 * c_3
    w_4b = D_12 * c_5
    w_4 = w_4a + w_4b
    w_4_right = w_4 - w_4a
    w_5a = D_20 * c_3
    w_5b = D_22 * c_5
    w_5 = w_5a + w_5b
    w_5_right = w_5 - w_5a
    co_3a = D_13 * w_2
    co_3b = D_23 * w_1
    co_3c = co_3a - co_3b
    co_3c_right = co_3a - co_3c
    co_3 = co_3c + w_3
    co_3_right = co_3 - co_3c
    w_3_lo = (product_rest(D_00, c_3, w_3a, w_3 - w_3_right)
        + product_rest(D_02, c_5, w_3b, w_3_right))
    co_3c_lo = (product_rest(D_13, w_2, co_3a, co_3c + co_3c_right)
        - product_rest(D_23, w_1, co_3b, co_3c_right) + (D_13 * w_2_lo - D_23 * w_1_lo))
    co_4a = D_23 * w_0
    co_4b = D_03 * w_2
    co_4c = co_4a - co_4b
    co_4c_right = co_4a - co_4c
    co_4 = co_4c + w_4
    co_4_right = co_4 - co_4c
    w_4_lo = (product_rest(D_10, c_3, w_4a, w_4 - w_4_right)
        + product_rest(D_12, c_5, w_4b, w_4_right))
    co_4c_lo = (product_rest(D_23, w_0, co_4a, co_4c + co_4c_right)
        - product_rest(D_03, w_2, co_4b, co_4c_right) + (D_23 * w_0_lo - D_03 * w_2_lo))
    co_5a = D_03 * w_1
    co_5b = D_13 * w_0
    co_5c = co_5a - co_5b
    co_5c_right = co_5a - co_5c
    co_5 = co_5c + w_5
    co_5_right = co_5 - co_5c
    w_5_lo = (product_rest(D_20, c_3, w_5a, w_5 - w_5_right)
        + product_rest(D_22, c_5, w_5b, w_5_right))
    co_5c_lo = (product_rest(D_03, w_1, co_5a, co_5c + co_5c_right)
        - product_rest(D_13, w_0, co_5b, co_5c_right) + (D_03 * w_1_lo - D_13 * w_0_lo))
    w_0_rounded = w_0 + w_0_lo
    w_1_rounded = w_1 + w_1_lo
    w_2_rounded = w_2 + w_2_lo
    co_3_rounded = co_3 + (co_3c - (co_3 - co_3_right) + (w_3 - co_3_right) + w_3_lo + co_3c_lo)
    co_4_rounded = co_4 + (co_4c - (co_4 - co_4_right) + (w_4 - co_4_right) + w_4_lo + co_4c_lo)
    co_5_rounded = co_5 + (co_5c - (co_5 - co_5_right) + (w_5 - co_5_right) + w_5_lo + co_5c_lo)
    return (w_0_rounded, w_1_rounded, w_2_rounded, co_3_rounded, co_4_rounded, co_5_rounded)


@kernel("(3,4),(6)->(6)")
def constraint_crz(D, c):
    """co = H̄* c = [Ad]*(D) P c; P clears component 5 of c, given in the frame of a rz joint at D.

    (3,4),(6)->(6).  D: displacement [R | t], R rotation, t in m; c, co: coscrew (f in N; τ in N
    m).
    27 mul, 90 add, 21 product rest.  Error <= u |result| + (lin: 11, ang: 35) u^2 S, S the sum
    of the |terms| of the expanded formula; barring over- and underflow.
    """
    D_00, D_01, D_02, D_03, D_10, D_11, D_12, D_13, D_20, D_21, D_22, D_23 = D
    c_0, c_1, c_2, c_3, c_4, c_5 = c
    w_0a = D_00 * c_0
    w_0b = D_01 * c_1
    w_0c = w_0a + w_0b
    w_0c_right = w_0c - w_0a
    w_0d = D_02 * c_2
    w_0 = w_0c + w_0d
    w_0_right = w_0 - w_0c
    w_0c_lo = (product_rest(D_00, c_0, w_0a, w_0c - w_0c_right)
        + product_rest(D_01, c_1, w_0b, w_0c_right))
    w_0_lo = w_0c - (w_0 - w_0_right) + product_rest(D_02, c_2, w_0d, w_0_right) + w_0c_lo
    w_1a = D_10 * c_0
    w_1b = D_11 * c_1
    w_1c = w_1a + w_1b
    w_1c_right = w_1c - w_1a
    w_1d = D_12 * c_2
    w_1 = w_1c + w_1d
    w_1_right = w_1 - w_1c
    w_1c_lo = (product_rest(D_10, c_0, w_1a, w_1c - w_1c_right)
        + product_rest(D_11, c_1, w_1b, w_1c_right))
    w_1_lo = w_1c - (w_1 - w_1_right) + product_rest(D_12, c_2, w_1d, w_1_right) + w_1c_lo
    w_2a = D_20 * c_0
    w_2b = D_21 * c_1
    w_2c = w_2a + w_2b
    w_2c_right = w_2c - w_2a
    w_2d = D_22 * c_2
    w_2 = w_2c + w_2d
    w_2_right = w_2 - w_2c
    w_2c_lo = (product_rest(D_20, c_0, w_2a, w_2c - w_2c_right)
        + product_rest(D_21, c_1, w_2b, w_2c_right))
    w_2_lo = w_2c - (w_2 - w_2_right) + product_rest(D_22, c_2, w_2d, w_2_right) + w_2c_lo
    w_3a = D_00 * c_3
    w_3b = D_01 * c_4
    w_3 = w_3a + w_3b
    w_3_right = w_3 - w_3a
    w_4a = D_10 * c_3
    w_4b = D_11 * c_4
    w_4 = w_4a + w_4b
    w_4_right = w_4 - w_4a
    w_5a = D_20 * c_3
    w_5b = D_21 * c_4
    w_5 = w_5a + w_5b
    w_5_right = w_5 - w_5a
    co_3a = D_13 * w_2
    co_3b = D_23 * w_1
    co_3c = co_3a - co_3b
    co_3c_right = co_3a - co_3c
    co_3 = co_3c + w_3
    co_3_right = co_3 - co_3c
    w_3_lo = (product_rest(D_00, c_3, w_3a, w_3 - w_3_right)
        + product_rest(D_01, c_4, w_3b, w_3_right))
    co_3c_lo = (product_rest(D_13, w_2, co_3a, co_3c + co_3c_right)
        - product_rest(D_23, w_1, co_3b, co_3c_right) + (D_13 * w_2_lo - D_23 * w_1_lo))
    co_4a = D_23 * w_0
    co_4b = D_03 * w_2
    co_4c = co_4a - co_4b
    co_4c_right = co_4a - co_4c
    co_4 = co_4c + w_4
    co_4_right = co_4 - co_4c
    w_4_lo = (product_rest(D_10, c_3, w_4a, w_4 - w_4_right)
        + product_rest(D_11, c_4, w_4b, w_4_right))
    co_4c_lo = (product_rest(D_23, w_0, co_4a, co_4c + co_4c_right)
        - product_rest(D_03, w_2, co_4b, co_4c_right) + (D_23 * w_0_lo - D_03 * w_2_lo))
    co_5a = D_03 * w_1
    co_5b = D_13 * w_0
    co_5c = co_5a - co_5b
    co_5c_right = co_5a - co_5c
    co_5 = co_5c + w_5
    co_5_right = co_5 - co_5c
    w_5_lo = (product_rest(D_20, c_3, w_5a, w_5 - w_5_right)
        + product_rest(D_21, c_4, w_5b, w_5_right))
    co_5c_lo = (product_rest(D_03, w_1, co_5a, co_5c + co_5c_right)
        - product_rest(D_13, w_0, co_5b, co_5c_right) + (D_03 * w_1_lo - D_13 * w_0_lo))
    w_0_rounded = w_0 + w_0_lo
    w_1_rounded = w_1 + w_1_lo
    w_2_rounded = w_2 + w_2_lo
    co_3_rounded = co_3 + (co_3c - (co_3 - co_3_right) + (w_3 - co_3_right) + w_3_lo + co_3c_lo)
    co_4_rounded = co_4 + (co_4c - (co_4 - co_4_right) + (w_4 - co_4_right) + w_4_lo + co_4c_lo)
    co_5_rounded = co_5 + (co_5c - (co_5 - co_5_right) + (w_5 - co_5_right) + w_5_lo + co_5c_lo)
    return (w_0_rounded, w_1_rounded, w_2_rounded, co_3_rounded, co_4_rounded, co_5_rounded)


@kernel("(3,4),(6)->(6)")
def working_ctx(D, c):
    """co = h̄* c = [Ad]*(D) P c; P keeps component 0 of c, given in the frame of a tx joint at D.

    (3,4),(6)->(6).  D: displacement [R | t], R rotation, t in m; c, co: coscrew (f in N; τ in N
    m).
    15 mul, 24 add, 3 product error, 6 product rest.  Error <= u |result| + (lin: 0, ang: 11)
    u^2 S, S the sum of the |terms| of the expanded formula; barring over- and underflow.
    """
    D_00, D_01, D_02, D_03, D_10, D_11, D_12, D_13, D_20, D_21, D_22, D_23 = D
    c_0, c_1, c_2, c_3, c_4, c_5 = c
    w_0 = D_00 * c_0
    w_1 = D_10 * c_0
    w_2 = D_20 * c_0
    w_2_lo = product_error(D_20, c_0, w_2)
    co_3a = D_13 * w_2
    w_1_lo = product_error(D_10, c_0, w_1)
    co_3b = D_23 * w_1
    co_3 = co_3a - co_3b
    co_3_right = co_3a - co_3
    w_0_lo = product_error(D_00, c_0, w_0)
    co_4a = D_23 * w_0
    co_4b = D_03 * w_2
    co_4 = co_4a - co_4b
    co_4_right = co_4a - co_4
    co_5a = D_03 * w_1
    co_5b = D_13 * w_0
    co_5 = co_5a - co_5b
    co_5_right = co_5a - co_5
    w_0_rounded = w_0 + w_0_lo
    w_1_rounded = w_1 + w_1_lo
    w_2_rounded = w_2 + w_2_lo
    co_3_lo = (product_rest(D_13, w_2, co_3a, co_3 + co_3_right)
        - product_rest(D_23, w_1, co_3b, co_3_right) + (D_13 * w_2_lo - D_23 * w_1_lo))
    co_3_rounded = co_3 + co_3_lo
    co_4_lo = (product_rest(D_23, w_0, co_4a, co_4 + co_4_right)
        - product_rest(D_03, w_2, co_4b, co_4_right) + (D_23 * w_0_lo - D_03 * w_2_lo))
    co_4_rounded = co_4 + co_4_lo
    co_5_lo = (product_rest(D_03, w_1, co_5a, co_5 + co_5_right)
        - product_rest(D_13, w_0, co_5b, co_5_right) + (D_03 * w_1_lo - D_13 * w_0_lo))
    co_5_rounded = co_5 + co_5_lo
    return (w_0_rounded, w_1_rounded, w_2_rounded, co_3_rounded, co_4_rounded, co_5_rounded)


@kernel("(3,4),(6)->(6)")
def working_cty(D, c):
    """co = h̄* c = [Ad]*(D) P c; P keeps component 1 of c, given in the frame of a ty joint at D.

    (3,4),(6)->(6).  D: displacement [R | t], R rotation, t in m; c, co: coscrew (f in N; τ in N
    m).
    15 mul, 24 add, 3 product error, 6 product rest.  Error <= u |result| + (lin: 0, ang: 11)
    u^2 S, S the sum of the |terms| of the expanded formula; barring over- and underflow.
    """
    D_00, D_01, D_02, D_03, D_10, D_11, D_12, D_13, D_20, D_21, D_22, D_23 = D
    c_0, c_1, c_2, c_3, c_4, c_5 = c
    w_0 = D_01 * c_1
    w_1 = D_11 * c_1
    w_2 = D_21 * c_1
    w_2_lo = product_error(D_21, c_1, w_2)
    co_3a = D_13 * w_2
    w_1_lo = product_error(D_11, c_1, w_1)
    co_3b = D_23 * w_1
    co_3 = co_3a - co_3b
    co_3_right = co_3a - co_3
    w_0_lo = product_error(D_01, c_1, w_0)
    co_4a = D_23 * w_0
    co_4b = D_03 * w_2
    co_4 = co_4a - co_4b
    co_4_right = co_4a - co_4
    co_5a = D_03 * w_1
    co_5b = D_13 * w_0
    co_5 = co_5a - co_5b
    co_5_right = co_5a - co_5
    w_0_rounded = w_0 + w_0_lo
    w_1_rounded = w_1 + w_1_lo
    w_2_rounded = w_2 + w_2_lo
    co_3_lo = (product_rest(D_13, w_2, co_3a, co_3 + co_3_right)
        - product_rest(D_23, w_1, co_3b, co_3_right) + (D_13 * w_2_lo - D_23 * w_1_lo))
    co_3_rounded = co_3 + co_3_lo
    co_4_lo = (product_rest(D_23, w_0, co_4a, co_4 + co_4_right)
        - product_rest(D_03, w_2, co_4b, co_4_right) + (D_23 * w_0_lo - D_03 * w_2_lo))
    co_4_rounded = co_4 + co_4_lo
    co_5_lo = (product_rest(D_03, w_1, co_5a, co_5 + co_5_right)
        - product_rest(D_13, w_0, co_5b, co_5_right) + (D_03 * w_1_lo - D_13 * w_0_lo))
    co_5_rounded = co_5 + co_5_lo
    return (w_0_rounded, w_1_rounded, w_2_rounded, co_3_rounded, co_4_rounded, co_5_rounded)


@kernel("(3,4),(6)->(6)")
def working_ctz(D, c):
    """co = h̄* c = [Ad]*(D) P c; P keeps component 2 of c, given in the frame of a tz joint at D.

    (3,4),(6)->(6).  D: displacement [R | t], R rotation, t in m; c, co: coscrew (f in N; τ in N
    m).
    15 mul, 24 add, 3 product error, 6 product rest.  Error <= u |result| + (lin: 0, ang: 11)
    u^2 S, S the sum of the |terms| of the expanded formula; barring over- and underflow.
    """
    D_00, D_01, D_02, D_03, D_10, D_11, D_12, D_13, D_20, D_21, D_22, D_23 = D
    c_0, c_1, c_2, c_3, c_4, c_5 = c
    w_0 = D_02 * c_2
    w_1 = D_12 * c_2
    w_2 = D_22 * c_2
    w_2_lo = product_error(D_22, c_2, w_2)
    co_3a = D_13 * w_2
    w_1_lo = product_error(D_12, c_2, w_1)
    co_3b = D_23 * w_1
    co_3 = co_3a - co_3b
    co_3_right = co_3a - co_3
    w_0_lo = product_error(D_02, c_2, w_0)
    co_4a = D_23 * w_0
    co_4b = D_03 * w_2
    co_4 = co_4a - co_4b
    co_4_right = co_4a - co_4
    co_5a = D_03 * w_1
    co_5b = D_13 * w_0
    co_5 = co_5a - co_5b
    co_5_right = co_5a - co_5
    w_0_rounded = w_0 + w_0_lo
    w_1_rounded = w_1 + w_1_lo
    w_2_rounded = w_2 + w_2_lo
    co_3_lo = (product_rest(D_13, w_2, co_3a, co_3 + co_3_right)
        - product_rest(D_23, w_1, co_3b, co_3_right) + (D_13 * w_2_lo - D_23 * w_1_lo))
    co_3_rounded = co_3 + co_3_lo
    co_4_lo = (product_rest(D_23, w_0, co_4a, co_4 + co_4_right)
        - product_rest(D_03, w_2, co_4b, co_4_right) + (D_23 * w_0_lo - D_03 * w_2_lo))
    co_4_rounded = co_4 + co_4_lo
    co_5_lo = (product_rest(D_03, w_1, co_5a, co_5 + co_5_right)
        - product_rest(D_13, w_0, co_5b, co_5_right) + (D_03 * w_1_lo - D_13 * w_0_lo))
    co_5_rounded = co_5 + co_5_lo
    return (w_0_rounded, w_1_rounded, w_2_rounded, co_3_rounded, co_4_rounded, co_5_rounded)


@kernel("(3,4),(6)->(6)")
def working_crx(D, c):
    """co = h̄* c = [Ad]*(D) P c; P keeps component 3 of c, given in the frame of a rx joint at D.

    (3,4),(6)->(6).  D: displacement [R | t], R rotation, t in m; c, co: coscrew (f in N; τ in N
    m).
    3 mul, 3 add, 3 product error.  Error <= u |result|, barring over- and underflow.
    """
    D_00, D_01, D_02, D_03, D_10, D_11, D_12, D_13, D_20, D_21, D_22, D_23 = D
    c_0, c_1, c_2, c_3, c_4, c_5 = c
    w_3 = D_00 * c_3
    w_4 = D_10 * c_3
    w_5 = D_20 * c_3
    w_3_rounded = w_3 + product_error(D_00, c_3, w_3)
    w_4_rounded = w_4 + product_error(D_10, c_3, w_4)
    w_5_rounded = w_5 + product_error(D_20, c_3, w_5)
    return (0, 0, 0, w_3_rounded, w_4_rounded, w_5_rounded)


@kernel("(3,4),(6)->(6)")
def working_cry(D, c):
    """co = h̄* c = [Ad]*(D) P c; P keeps component 4 of c, given in the frame of a ry joint at D.

    (3,4),(6)->(6).  D: displacement [R | t], R rotation, t in m; c, co: coscrew (f in N; τ in N
    m).
    3 mul, 3 add, 3 product error.  Error <= u |result|, barring over- and underflow.
    """
    D_00, D_01, D_02, D_03, D_10, D_11, D_12, D_13, D_20, D_21, D_22, D_23 = D
    c_0, c_1, c_2, c_3, c_4, c_5 = c
    w_3 = D_01 * c_4
    w_4 = D_11 * c_4
    w_5 = D_21 * c_4
    w_3_rounded = w_3 + product_error(D_01, c_4, w_3)
    w_4_rounded = w_4 + product_error(D_11, c_4, w_4)
    w_5_rounded = w_5 + product_error(D_21, c_4, w_5)
    return (0, 0, 0, w_3_rounded, w_4_rounded, w_5_rounded)


@kernel("(3,4),(6)->(6)")
def working_crz(D, c):
    """co = h̄* c = [Ad]*(D) P c; P keeps component 5 of c, given in the frame of a rz joint at D.

    (3,4),(6)->(6).  D: displacement [R | t], R rotation, t in m; c, co: coscrew (f in N; τ in N
    m).
    3 mul, 3 add, 3 product error.  Error <= u |result|, barring over- and underflow.
    """
    D_00, D_01, D_02, D_03, D_10, D_11, D_12, D_13, D_20, D_21, D_22, D_23 = D
    c_0, c_1, c_2, c_3, c_4, c_5 = c
    w_3 = D_02 * c_5
    w_4 = D_12 * c_5
    w_5 = D_22 * c_5
    w_3_rounded = w_3 + product_error(D_02, c_5, w_3)
    w_4_rounded = w_4 + product_error(D_12, c_5, w_4)
    w_5_rounded = w_5 + product_error(D_22, c_5, w_5)
    return (0, 0, 0, w_3_rounded, w_4_rounded, w_5_rounded)
