# Made by `coscrew generate`; changes are overwritten.
# SPDX-License-Identifier: MIT
# coscrew 0.2.0.  Copyright (c) 2026 The coscrew authors.
"""Vectors of four components: three dimensions and a homogeneous coordinate.

In double precision, accurate tier.
"""

from numpy import absolute, float64, sqrt, where
from coscrew._exact import product_error, product_rest
from coscrew._kernel import double_kernel as kernel


@kernel("(4),()->(4)")
def vec4_scale(self, a):
    """self = a self.

    (4),()->(4).  self: vector (x, y, z) and a homogeneous coordinate w; a: number.
    4 mul, 4 add, 4 product error.  Error <= u |result|, barring over- and underflow.
    """
    self_0, self_1, self_2, self_3 = self
    self_0_new = self_0 * a
    self_1_new = self_1 * a
    self_2_new = self_2 * a
    self_3_new = self_3 * a
    self_0_new_rounded = self_0_new + product_error(self_0, a, self_0_new)
    self_1_new_rounded = self_1_new + product_error(self_1, a, self_1_new)
    self_2_new_rounded = self_2_new + product_error(self_2, a, self_2_new)
    self_3_new_rounded = self_3_new + product_error(self_3, a, self_3_new)
    return (self_0_new_rounded, self_1_new_rounded, self_2_new_rounded, self_3_new_rounded)


@kernel("(4),()->(4)")
def vec4_scaled(v, k):
    """vo = k v.

    (4),()->(4).  v, vo: vector (x, y, z) and a homogeneous coordinate w; k: number.
    4 mul, 4 add, 4 product error.  Error <= u |result|, barring over- and underflow.
    """
    v_0, v_1, v_2, v_3 = v
    vo_0 = v_0 * k
    vo_1 = v_1 * k
    vo_2 = v_2 * k
    vo_3 = v_3 * k
    vo_0_rounded = vo_0 + product_error(v_0, k, vo_0)
    vo_1_rounded = vo_1 + product_error(v_1, k, vo_1)
    vo_2_rounded = vo_2 + product_error(v_2, k, vo_2)
    vo_3_rounded = vo_3 + product_error(v_3, k, vo_3)
    return (vo_0_rounded, vo_1_rounded, vo_2_rounded, vo_3_rounded)


@kernel("(4)->()")
def vec4_l2norm(v):
    """|v| = sqrt(v·v), all four components.

    (4)->().  v: vector (x, y, z) and a homogeneous coordinate w; norm: number.
    12 mul, 35 add, 1 product error, 4 product rest, 2 div, 1 sqrt, 4 abs, 9 less, 2 equal, 11
    select.
    """
    v_0, v_1, v_2, v_3 = v
    s_size_0 = absolute(v_0)
    s_size_1 = absolute(v_1)
    s_size_2 = absolute(v_2)
    s_size_3 = absolute(v_3)
    s_largest1 = where(s_size_0 < s_size_1, s_size_1, s_size_0)
    s_largest2 = where(s_largest1 < s_size_2, s_size_2, s_largest1)
    s_largest3 = where(s_largest2 < s_size_3, s_size_3, s_largest2)
    s_b = where(6.703903964971299e+153 < s_largest3, float64(3.7291703656001034e-155), float64(1))
    s_d = where(s_largest3 < 256, 1.3093562431584567e+151, s_b)
    s = where(s_largest3 < 1.955159272639747e-149, 1.0715086071862673e+301, s_d)
    y_0 = v_0 * s
    y_1 = v_1 * s
    y_2 = v_2 * s
    y_3 = v_3 * s
    n_a = y_0 * y_0
    n_b = y_1 * y_1
    n_c = n_a + n_b
    n_c_right = n_c - n_a
    n_d = y_2 * y_2
    n_e = n_c + n_d
    n_e_right = n_e - n_c
    n_c_lo = product_rest(y_0, y_0, n_a, n_c - n_c_right) + product_rest(y_1, y_1, n_b, n_c_right)
    n_f = y_3 * y_3
    n_g = n_e + n_f
    n_g_right = n_g - n_e
    n_e_lo = n_c - (n_e - n_e_right) + product_rest(y_2, y_2, n_d, n_e_right) + n_c_lo
    n_g_lo = n_e - (n_g - n_g_right) + product_rest(y_3, y_3, n_f, n_g_right) + n_e_lo
    n_of_n_g = n_g + n_g_lo
    n_of_n_g_right = n_of_n_g - n_g
    n = sqrt(n_of_n_g)
    n_product = n * n
    n_of_n_g_lo = n_g - (n_of_n_g - n_of_n_g_right) + (n_g_lo - n_of_n_g_right)
    n_residual = n_of_n_g - n_product - product_error(n, n, n_product) + n_of_n_g_lo
    n_lo = n_residual / where(n == 0, 1, n + n)
    r_b = where(s < 1, float64(2.6815615859885194e+154), float64(1))
    r_d = where(1 < s, 7.637340908749012e-152, r_b)
    r = where(1.3093562431584567e+151 < s, 9.332636185032189e-302, r_d)
    norm_of_n = n + n_lo
    norm_of_n_right = norm_of_n - n
    norm = norm_of_n * r
    norm_of_n_lo = n - (norm_of_n - norm_of_n_right) + (n_lo - norm_of_n_right)
    norm_rounded = norm + (norm_of_n - norm * (1 / r) + norm_of_n_lo) * r
    norm_final = where(norm_rounded == norm_rounded, norm_rounded, norm)
    return norm_final


@kernel("(4)->(4)")
def vec4_normalize(self):
    """self = self / |self|; the zero vector stays zero.

    (4)->(4).  self: vector (x, y, z) and a homogeneous coordinate w.
    33 mul, 86 add, 5 product error, 4 product rest, 10 div, 1 sqrt, 4 abs, 8 less, 6 equal, 15
    select.
    """
    self_0, self_1, self_2, self_3 = self
    s_size_0 = absolute(self_0)
    s_size_1 = absolute(self_1)
    s_size_2 = absolute(self_2)
    s_size_3 = absolute(self_3)
    s_largest1 = where(s_size_0 < s_size_1, s_size_1, s_size_0)
    s_largest2 = where(s_largest1 < s_size_2, s_size_2, s_largest1)
    s_largest3 = where(s_largest2 < s_size_3, s_size_3, s_largest2)
    s_b = where(6.703903964971299e+153 < s_largest3, float64(3.7291703656001034e-155), float64(1))
    s_d = where(s_largest3 < 256, 1.3093562431584567e+151, s_b)
    s = where(s_largest3 < 1.955159272639747e-149, 1.0715086071862673e+301, s_d)
    y_0 = self_0 * s
    y_1 = self_1 * s
    y_2 = self_2 * s
    y_3 = self_3 * s
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
    n_f = y_3 * y_3
    n_g = n_e + n_f
    n_g_right = n_g - n_e
    n_e_lo = n_c - (n_e - n_e_right) + product_rest(y_2, y_2, n_d, n_e_right) + n_c_lo
    n_g_lo = n_e - (n_g - n_g_right) + product_rest(y_3, y_3, n_f, n_g_right) + n_e_lo
    n_of_n_g = n_g + n_g_lo
    n_of_n_g_right = n_of_n_g - n_g
    n = sqrt(n_of_n_g)
    n_product = n * n
    n_of_n_g_lo = n_g - (n_of_n_g - n_of_n_g_right) + (n_g_lo - n_of_n_g_right)
    n_residual = n_of_n_g - n_product - product_error(n, n, n_product) + n_of_n_g_lo
    n_lo = n_residual / where(n == 0, 1, n + n)
    divisor_a_of_n = n + n_lo
    divisor_a_of_n_right = divisor_a_of_n - n
    divisor_a = divisor_a_of_n == 0
    divisor = where(divisor_a, up, divisor_a_of_n)
    divisor_a_of_n_lo = n - (divisor_a_of_n - divisor_a_of_n_right) + (n_lo - divisor_a_of_n_right)
    divisor_lo = where(divisor_a, 0, divisor_a_of_n_lo)
    sized_0 = self_0 * up
    sized_1 = self_1 * up
    sized_2 = self_2 * up
    sized_3 = self_3 * up
    quotient_0_of_divisor = divisor + divisor_lo
    quotient_0_of_divisor_right = quotient_0_of_divisor - divisor
    quotient_0_of_divisor_left = quotient_0_of_divisor - quotient_0_of_divisor_right
    quotient_0_of_divisor_right_rest = divisor_lo - quotient_0_of_divisor_right
    quotient_0_of_divisor_left_rest = divisor - quotient_0_of_divisor_left
    quotient_0_of_divisor_lo = quotient_0_of_divisor_left_rest + quotient_0_of_divisor_right_rest
    quotient_0 = sized_0 / quotient_0_of_divisor
    quotient_0_product = quotient_0 * quotient_0_of_divisor
    quotient_0_product_error = product_error(quotient_0, quotient_0_of_divisor, quotient_0_product)
    quotient_0_exact = sized_0 - quotient_0_product - quotient_0_product_error
    quotient_0_residual = quotient_0_exact - quotient_0 * quotient_0_of_divisor_lo
    quotient_0_lo = quotient_0_residual / quotient_0_of_divisor
    quotient_1 = sized_1 / quotient_0_of_divisor
    quotient_1_product = quotient_1 * quotient_0_of_divisor
    quotient_1_product_error = product_error(quotient_1, quotient_0_of_divisor, quotient_1_product)
    quotient_1_exact = sized_1 - quotient_1_product - quotient_1_product_error
    quotient_1_residual = quotient_1_exact - quotient_1 * quotient_0_of_divisor_lo
    quotient_1_lo = quotient_1_residual / quotient_0_of_divisor
    quotient_2 = sized_2 / quotient_0_of_divisor
    quotient_2_product = quotient_2 * quotient_0_of_divisor
    quotient_2_product_error = product_error(quotient_2, quotient_0_of_divisor, quotient_2_product)
    quotient_2_exact = sized_2 - quotient_2_product - quotient_2_product_error
    quotient_2_residual = quotient_2_exact - quotient_2 * quotient_0_of_divisor_lo
    quotient_2_lo = quotient_2_residual / quotient_0_of_divisor
    quotient_3 = sized_3 / quotient_0_of_divisor
    quotient_3_product = quotient_3 * quotient_0_of_divisor
    quotient_3_product_error = product_error(quotient_3, quotient_0_of_divisor, quotient_3_product)
    quotient_3_exact = sized_3 - quotient_3_product - quotient_3_product_error
    quotient_3_residual = quotient_3_exact - quotient_3 * quotient_0_of_divisor_lo
    quotient_3_lo = quotient_3_residual / quotient_0_of_divisor
    self_0_new_of_quotient_0 = quotient_0 + quotient_0_lo
    self_0_new_of_quotient_0_right = self_0_new_of_quotient_0 - quotient_0
    self_0_new_of_quotient_0_left = self_0_new_of_quotient_0 - self_0_new_of_quotient_0_right
    self_0_new_of_quotient_0_right_rest = quotient_0_lo - self_0_new_of_quotient_0_right
    self_0_new_of_quotient_0_left_rest = quotient_0 - self_0_new_of_quotient_0_left
    self_0_new = self_0_new_of_quotient_0 * down
    self_0_new_inverse = 1 / down
    self_0_new_of_quotient_0_lo = self_0_new_of_quotient_0_left_rest + self_0_new_of_quotient_0_right_rest
    self_0_new_lost = self_0_new_of_quotient_0 - self_0_new * self_0_new_inverse
    self_1_new_of_quotient_1 = quotient_1 + quotient_1_lo
    self_1_new_of_quotient_1_right = self_1_new_of_quotient_1 - quotient_1
    self_1_new_of_quotient_1_left = self_1_new_of_quotient_1 - self_1_new_of_quotient_1_right
    self_1_new_of_quotient_1_right_rest = quotient_1_lo - self_1_new_of_quotient_1_right
    self_1_new_of_quotient_1_left_rest = quotient_1 - self_1_new_of_quotient_1_left
    self_1_new = self_1_new_of_quotient_1 * down
    self_1_new_of_quotient_1_lo = self_1_new_of_quotient_1_left_rest + self_1_new_of_quotient_1_right_rest
    self_1_new_lost = self_1_new_of_quotient_1 - self_1_new * self_0_new_inverse
    self_2_new_of_quotient_2 = quotient_2 + quotient_2_lo
    self_2_new_of_quotient_2_right = self_2_new_of_quotient_2 - quotient_2
    self_2_new_of_quotient_2_left = self_2_new_of_quotient_2 - self_2_new_of_quotient_2_right
    self_2_new_of_quotient_2_right_rest = quotient_2_lo - self_2_new_of_quotient_2_right
    self_2_new_of_quotient_2_left_rest = quotient_2 - self_2_new_of_quotient_2_left
    self_2_new = self_2_new_of_quotient_2 * down
    self_2_new_of_quotient_2_lo = self_2_new_of_quotient_2_left_rest + self_2_new_of_quotient_2_right_rest
    self_2_new_lost = self_2_new_of_quotient_2 - self_2_new * self_0_new_inverse
    self_3_new_of_quotient_3 = quotient_3 + quotient_3_lo
    self_3_new_of_quotient_3_right = self_3_new_of_quotient_3 - quotient_3
    self_3_new_of_quotient_3_left = self_3_new_of_quotient_3 - self_3_new_of_quotient_3_right
    self_3_new_of_quotient_3_right_rest = quotient_3_lo - self_3_new_of_quotient_3_right
    self_3_new_of_quotient_3_left_rest = quotient_3 - self_3_new_of_quotient_3_left
    self_3_new = self_3_new_of_quotient_3 * down
    self_3_new_of_quotient_3_lo = self_3_new_of_quotient_3_left_rest + self_3_new_of_quotient_3_right_rest
    self_3_new_lost = self_3_new_of_quotient_3 - self_3_new * self_0_new_inverse
    self_0_new_rounded = self_0_new + (self_0_new_lost + self_0_new_of_quotient_0_lo) * down
    self_0_new_rounded_number = self_0_new_rounded == self_0_new_rounded
    self_1_new_rounded = self_1_new + (self_1_new_lost + self_1_new_of_quotient_1_lo) * down
    self_1_new_rounded_number = self_1_new_rounded == self_1_new_rounded
    self_2_new_rounded = self_2_new + (self_2_new_lost + self_2_new_of_quotient_2_lo) * down
    self_2_new_rounded_number = self_2_new_rounded == self_2_new_rounded
    self_3_new_rounded = self_3_new + (self_3_new_lost + self_3_new_of_quotient_3_lo) * down
    self_3_new_rounded_number = self_3_new_rounded == self_3_new_rounded
    self_0_new_final = where(self_0_new_rounded_number, self_0_new_rounded, self_0_new)
    self_1_new_final = where(self_1_new_rounded_number, self_1_new_rounded, self_1_new)
    self_2_new_final = where(self_2_new_rounded_number, self_2_new_rounded, self_2_new)
    self_3_new_final = where(self_3_new_rounded_number, self_3_new_rounded, self_3_new)
    return (self_0_new_final, self_1_new_final, self_2_new_final, self_3_new_final)


@kernel("(4)->(4)")
def vec4_normalized(v):
    """vo = v / |v|; the zero vector stays zero.

    (4)->(4).  v, vo: vector (x, y, z) and a homogeneous coordinate w.
    33 mul, 86 add, 5 product error, 4 product rest, 10 div, 1 sqrt, 4 abs, 8 less, 6 equal, 15
    select.
    """
    v_0, v_1, v_2, v_3 = v
    s_size_0 = absolute(v_0)
    s_size_1 = absolute(v_1)
    s_size_2 = absolute(v_2)
    s_size_3 = absolute(v_3)
    s_largest1 = where(s_size_0 < s_size_1, s_size_1, s_size_0)
    s_largest2 = where(s_largest1 < s_size_2, s_size_2, s_largest1)
    s_largest3 = where(s_largest2 < s_size_3, s_size_3, s_largest2)
    s_b = where(6.703903964971299e+153 < s_largest3, float64(3.7291703656001034e-155), float64(1))
    s_d = where(s_largest3 < 256, 1.3093562431584567e+151, s_b)
    s = where(s_largest3 < 1.955159272639747e-149, 1.0715086071862673e+301, s_d)
    y_0 = v_0 * s
    y_1 = v_1 * s
    y_2 = v_2 * s
    y_3 = v_3 * s
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
    n_f = y_3 * y_3
    n_g = n_e + n_f
    n_g_right = n_g - n_e
    n_e_lo = n_c - (n_e - n_e_right) + product_rest(y_2, y_2, n_d, n_e_right) + n_c_lo
    n_g_lo = n_e - (n_g - n_g_right) + product_rest(y_3, y_3, n_f, n_g_right) + n_e_lo
    n_of_n_g = n_g + n_g_lo
    n_of_n_g_right = n_of_n_g - n_g
    n = sqrt(n_of_n_g)
    n_product = n * n
    n_of_n_g_lo = n_g - (n_of_n_g - n_of_n_g_right) + (n_g_lo - n_of_n_g_right)
    n_residual = n_of_n_g - n_product - product_error(n, n, n_product) + n_of_n_g_lo
    n_lo = n_residual / where(n == 0, 1, n + n)
    divisor_a_of_n = n + n_lo
    divisor_a_of_n_right = divisor_a_of_n - n
    divisor_a = divisor_a_of_n == 0
    divisor = where(divisor_a, up, divisor_a_of_n)
    divisor_a_of_n_lo = n - (divisor_a_of_n - divisor_a_of_n_right) + (n_lo - divisor_a_of_n_right)
    divisor_lo = where(divisor_a, 0, divisor_a_of_n_lo)
    sized_0 = v_0 * up
    sized_1 = v_1 * up
    sized_2 = v_2 * up
    sized_3 = v_3 * up
    quotient_0_of_divisor = divisor + divisor_lo
    quotient_0_of_divisor_right = quotient_0_of_divisor - divisor
    quotient_0_of_divisor_left = quotient_0_of_divisor - quotient_0_of_divisor_right
    quotient_0_of_divisor_right_rest = divisor_lo - quotient_0_of_divisor_right
    quotient_0_of_divisor_left_rest = divisor - quotient_0_of_divisor_left
    quotient_0_of_divisor_lo = quotient_0_of_divisor_left_rest + quotient_0_of_divisor_right_rest
    quotient_0 = sized_0 / quotient_0_of_divisor
    quotient_0_product = quotient_0 * quotient_0_of_divisor
    quotient_0_product_error = product_error(quotient_0, quotient_0_of_divisor, quotient_0_product)
    quotient_0_exact = sized_0 - quotient_0_product - quotient_0_product_error
    quotient_0_residual = quotient_0_exact - quotient_0 * quotient_0_of_divisor_lo
    quotient_0_lo = quotient_0_residual / quotient_0_of_divisor
    quotient_1 = sized_1 / quotient_0_of_divisor
    quotient_1_product = quotient_1 * quotient_0_of_divisor
    quotient_1_product_error = product_error(quotient_1, quotient_0_of_divisor, quotient_1_product)
    quotient_1_exact = sized_1 - quotient_1_product - quotient_1_product_error
    quotient_1_residual = quotient_1_exact - quotient_1 * quotient_0_of_divisor_lo
    quotient_1_lo = quotient_1_residual / quotient_0_of_divisor
    quotient_2 = sized_2 / quotient_0_of_divisor
    quotient_2_product = quotient_2 * quotient_0_of_divisor
    quotient_2_product_error = product_error(quotient_2, quotient_0_of_divisor, quotient_2_product)
    quotient_2_exact = sized_2 - quotient_2_product - quotient_2_product_error
    quotient_2_residual = quotient_2_exact - quotient_2 * quotient_0_of_divisor_lo
    quotient_2_lo = quotient_2_residual / quotient_0_of_divisor
    quotient_3 = sized_3 / quotient_0_of_divisor
    quotient_3_product = quotient_3 * quotient_0_of_divisor
    quotient_3_product_error = product_error(quotient_3, quotient_0_of_divisor, quotient_3_product)
    quotient_3_exact = sized_3 - quotient_3_product - quotient_3_product_error
    quotient_3_residual = quotient_3_exact - quotient_3 * quotient_0_of_divisor_lo
    quotient_3_lo = quotient_3_residual / quotient_0_of_divisor
    vo_0_of_quotient_0 = quotient_0 + quotient_0_lo
    vo_0_of_quotient_0_right = vo_0_of_quotient_0 - quotient_0
    vo_0_of_quotient_0_left_rest = quotient_0 - (vo_0_of_quotient_0 - vo_0_of_quotient_0_right)
    vo_0_of_quotient_0_right_rest = quotient_0_lo - vo_0_of_quotient_0_right
    vo_0 = vo_0_of_quotient_0 * down
    vo_0_inverse = 1 / down
    vo_0_of_quotient_0_lo = vo_0_of_quotient_0_left_rest + vo_0_of_quotient_0_right_rest
    vo_1_of_quotient_1 = quotient_1 + quotient_1_lo
    vo_1_of_quotient_1_right = vo_1_of_quotient_1 - quotient_1
    vo_1_of_quotient_1_left_rest = quotient_1 - (vo_1_of_quotient_1 - vo_1_of_quotient_1_right)
    vo_1_of_quotient_1_right_rest = quotient_1_lo - vo_1_of_quotient_1_right
    vo_1 = vo_1_of_quotient_1 * down
    vo_1_of_quotient_1_lo = vo_1_of_quotient_1_left_rest + vo_1_of_quotient_1_right_rest
    vo_2_of_quotient_2 = quotient_2 + quotient_2_lo
    vo_2_of_quotient_2_right = vo_2_of_quotient_2 - quotient_2
    vo_2_of_quotient_2_left_rest = quotient_2 - (vo_2_of_quotient_2 - vo_2_of_quotient_2_right)
    vo_2_of_quotient_2_right_rest = quotient_2_lo - vo_2_of_quotient_2_right
    vo_2 = vo_2_of_quotient_2 * down
    vo_2_of_quotient_2_lo = vo_2_of_quotient_2_left_rest + vo_2_of_quotient_2_right_rest
    vo_3_of_quotient_3 = quotient_3 + quotient_3_lo
    vo_3_of_quotient_3_right = vo_3_of_quotient_3 - quotient_3
    vo_3_of_quotient_3_left_rest = quotient_3 - (vo_3_of_quotient_3 - vo_3_of_quotient_3_right)
    vo_3_of_quotient_3_right_rest = quotient_3_lo - vo_3_of_quotient_3_right
    vo_3 = vo_3_of_quotient_3 * down
    vo_3_of_quotient_3_lo = vo_3_of_quotient_3_left_rest + vo_3_of_quotient_3_right_rest
    vo_0_rounded = vo_0 + (vo_0_of_quotient_0 - vo_0 * vo_0_inverse + vo_0_of_quotient_0_lo) * down
    vo_1_rounded = vo_1 + (vo_1_of_quotient_1 - vo_1 * vo_0_inverse + vo_1_of_quotient_1_lo) * down
    vo_2_rounded = vo_2 + (vo_2_of_quotient_2 - vo_2 * vo_0_inverse + vo_2_of_quotient_2_lo) * down
    vo_3_rounded = vo_3 + (vo_3_of_quotient_3 - vo_3 * vo_0_inverse + vo_3_of_quotient_3_lo) * down
    vo_0_final = where(vo_0_rounded == vo_0_rounded, vo_0_rounded, vo_0)
    vo_1_final = where(vo_1_rounded == vo_1_rounded, vo_1_rounded, vo_1)
    vo_2_final = where(vo_2_rounded == vo_2_rounded, vo_2_rounded, vo_2)
    vo_3_final = where(vo_3_rounded == vo_3_rounded, vo_3_rounded, vo_3)
    return (vo_0_final, vo_1_final, vo_2_final, vo_3_final)
