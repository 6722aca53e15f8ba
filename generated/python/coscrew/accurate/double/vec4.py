# Made by `coscrew generate`; changes are overwritten.
# SPDX-License-Identifier: MIT
# coscrew 0.2.0.  Copyright (c) 2026 The coscrew authors.
"""Vectors of four components: three dimensions and a homogeneous coordinate.

In double precision, accurate tier.
"""

from numpy import absolute, float64 as real, sqrt, where
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
    s_d = where(s_largest3 < 256, 1.3093562431584567e+151,
        where(6.703903964971299e+153 < s_largest3, real(3.7291703656001034e-155), real(1)))
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
    n_g_sum = n_g + n_g_lo
    n_g_sum_right = n_g_sum - n_g
    n = sqrt(n_g_sum)
    n_product = n * n
    n_lo = ((n_g_sum - n_product - product_error(n, n, n_product)
        + (n_g - (n_g_sum - n_g_sum_right) + (n_g_lo - n_g_sum_right))) / where(n == 0, 1, n + n))
    r_d = where(1 < s, 7.637340908749012e-152, where(s < 1, real(2.6815615859885194e+154), real(1)))
    r = where(1.3093562431584567e+151 < s, 9.332636185032189e-302, r_d)
    n_sum = n + n_lo
    n_sum_right = n_sum - n
    norm = n_sum * r
    norm_rounded = (norm
        + (n_sum - norm * (1 / r) + (n - (n_sum - n_sum_right) + (n_lo - n_sum_right))) * r)
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
    s_d = where(s_largest3 < 256, 1.3093562431584567e+151,
        where(6.703903964971299e+153 < s_largest3, real(3.7291703656001034e-155), real(1)))
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
    n_g_sum = n_g + n_g_lo
    n_g_sum_right = n_g_sum - n_g
    n = sqrt(n_g_sum)
    n_product = n * n
    n_lo = ((n_g_sum - n_product - product_error(n, n, n_product)
        + (n_g - (n_g_sum - n_g_sum_right) + (n_g_lo - n_g_sum_right))) / where(n == 0, 1, n + n))
    n_sum = n + n_lo
    n_sum_right = n_sum - n
    divisor_a = n_sum == 0
    divisor = where(divisor_a, up, n_sum)
    divisor_lo = where(divisor_a, 0, n - (n_sum - n_sum_right) + (n_lo - n_sum_right))
    sized_0 = self_0 * up
    sized_1 = self_1 * up
    sized_2 = self_2 * up
    sized_3 = self_3 * up
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
    quotient_0_sum = quotient_0 + quotient_0_lo
    quotient_0_sum_right = quotient_0_sum - quotient_0
    self_0_new = quotient_0_sum * down
    self_0_new_inverse = 1 / down
    quotient_0_sum_lo = (quotient_0 - (quotient_0_sum - quotient_0_sum_right)
        + (quotient_0_lo - quotient_0_sum_right))
    quotient_1_sum = quotient_1 + quotient_1_lo
    quotient_1_sum_right = quotient_1_sum - quotient_1
    self_1_new = quotient_1_sum * down
    quotient_1_sum_lo = (quotient_1 - (quotient_1_sum - quotient_1_sum_right)
        + (quotient_1_lo - quotient_1_sum_right))
    quotient_2_sum = quotient_2 + quotient_2_lo
    quotient_2_sum_right = quotient_2_sum - quotient_2
    self_2_new = quotient_2_sum * down
    quotient_2_sum_lo = (quotient_2 - (quotient_2_sum - quotient_2_sum_right)
        + (quotient_2_lo - quotient_2_sum_right))
    quotient_3_sum = quotient_3 + quotient_3_lo
    quotient_3_sum_right = quotient_3_sum - quotient_3
    self_3_new = quotient_3_sum * down
    quotient_3_sum_lo = (quotient_3 - (quotient_3_sum - quotient_3_sum_right)
        + (quotient_3_lo - quotient_3_sum_right))
    self_0_new_rounded = (self_0_new
        + (quotient_0_sum - self_0_new * self_0_new_inverse + quotient_0_sum_lo) * down)
    self_1_new_rounded = (self_1_new
        + (quotient_1_sum - self_1_new * self_0_new_inverse + quotient_1_sum_lo) * down)
    self_2_new_rounded = (self_2_new
        + (quotient_2_sum - self_2_new * self_0_new_inverse + quotient_2_sum_lo) * down)
    self_3_new_rounded = (self_3_new
        + (quotient_3_sum - self_3_new * self_0_new_inverse + quotient_3_sum_lo) * down)
    self_0_new_final = where(self_0_new_rounded == self_0_new_rounded, self_0_new_rounded,
        self_0_new)
    self_1_new_final = where(self_1_new_rounded == self_1_new_rounded, self_1_new_rounded,
        self_1_new)
    self_2_new_final = where(self_2_new_rounded == self_2_new_rounded, self_2_new_rounded,
        self_2_new)
    self_3_new_final = where(self_3_new_rounded == self_3_new_rounded, self_3_new_rounded,
        self_3_new)
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
    s_d = where(s_largest3 < 256, 1.3093562431584567e+151,
        where(6.703903964971299e+153 < s_largest3, real(3.7291703656001034e-155), real(1)))
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
    n_g_sum = n_g + n_g_lo
    n_g_sum_right = n_g_sum - n_g
    n = sqrt(n_g_sum)
    n_product = n * n
    n_lo = ((n_g_sum - n_product - product_error(n, n, n_product)
        + (n_g - (n_g_sum - n_g_sum_right) + (n_g_lo - n_g_sum_right))) / where(n == 0, 1, n + n))
    n_sum = n + n_lo
    n_sum_right = n_sum - n
    divisor_a = n_sum == 0
    divisor = where(divisor_a, up, n_sum)
    divisor_lo = where(divisor_a, 0, n - (n_sum - n_sum_right) + (n_lo - n_sum_right))
    sized_0 = v_0 * up
    sized_1 = v_1 * up
    sized_2 = v_2 * up
    sized_3 = v_3 * up
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
    quotient_0_sum = quotient_0 + quotient_0_lo
    quotient_0_sum_right = quotient_0_sum - quotient_0
    vo_0 = quotient_0_sum * down
    vo_0_inverse = 1 / down
    vo_0_rest = (quotient_0_sum - vo_0 * vo_0_inverse
        + (quotient_0 - (quotient_0_sum - quotient_0_sum_right)
        + (quotient_0_lo - quotient_0_sum_right)))
    quotient_1_sum = quotient_1 + quotient_1_lo
    quotient_1_sum_right = quotient_1_sum - quotient_1
    vo_1 = quotient_1_sum * down
    vo_1_rest = (quotient_1_sum - vo_1 * vo_0_inverse
        + (quotient_1 - (quotient_1_sum - quotient_1_sum_right)
        + (quotient_1_lo - quotient_1_sum_right)))
    quotient_2_sum = quotient_2 + quotient_2_lo
    quotient_2_sum_right = quotient_2_sum - quotient_2
    vo_2 = quotient_2_sum * down
    vo_2_rest = (quotient_2_sum - vo_2 * vo_0_inverse
        + (quotient_2 - (quotient_2_sum - quotient_2_sum_right)
        + (quotient_2_lo - quotient_2_sum_right)))
    quotient_3_sum = quotient_3 + quotient_3_lo
    quotient_3_sum_right = quotient_3_sum - quotient_3
    vo_3 = quotient_3_sum * down
    vo_3_rest = (quotient_3_sum - vo_3 * vo_0_inverse
        + (quotient_3 - (quotient_3_sum - quotient_3_sum_right)
        + (quotient_3_lo - quotient_3_sum_right)))
    vo_0_rounded = vo_0 + vo_0_rest * down
    vo_1_rounded = vo_1 + vo_1_rest * down
    vo_2_rounded = vo_2 + vo_2_rest * down
    vo_3_rounded = vo_3 + vo_3_rest * down
    vo_0_final = where(vo_0_rounded == vo_0_rounded, vo_0_rounded, vo_0)
    vo_1_final = where(vo_1_rounded == vo_1_rounded, vo_1_rounded, vo_1)
    vo_2_final = where(vo_2_rounded == vo_2_rounded, vo_2_rounded, vo_2)
    vo_3_final = where(vo_3_rounded == vo_3_rounded, vo_3_rounded, vo_3)
    return (vo_0_final, vo_1_final, vo_2_final, vo_3_final)
