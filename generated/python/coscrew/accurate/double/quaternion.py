# Made by `coscrew generate`; changes are overwritten.
# SPDX-License-Identifier: MIT
# coscrew 0.2.0.  Copyright (c) 2026 The coscrew authors.
"""Quaternions q = (v; w), the scalar last: products, rotations, conversions, interpolation.

In double precision, accurate tier.
"""

from coscrew import _elementary_double as elementary
from numpy import absolute, float64 as real, nan, sqrt, where
from coscrew._exact import product_error, product_rest
from coscrew._kernel import double_kernel as kernel


@kernel("(4),()->(4)")
def quaternion_scale(self, a):
    """self = a self.

    (4),()->(4).  self: quaternion (x, y, z, w), the scalar last; a: number.
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


@kernel("(),(4),(4)->(4)")
def axpy_qq(a, x, y):
    """y = a x + y.

    (),(4),(4)->(4).  a: number; x, y: quaternion (x, y, z, w), the scalar last.
    4 mul, 24 add, 4 product rest.  Error <= u |result| + 3 u^2 S, S the sum of the |terms| of
    the expanded formula; barring over- and underflow.
    """
    x_0, x_1, x_2, x_3 = x
    y_0, y_1, y_2, y_3 = y
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
    y_0_new_rounded = (y_0_new
        + (product_rest(a, x_0, y_0_new_a, y_0_new - y_0_new_right) + (y_0 - y_0_new_right)))
    y_1_new_rounded = (y_1_new
        + (product_rest(a, x_1, y_1_new_a, y_1_new - y_1_new_right) + (y_1 - y_1_new_right)))
    y_2_new_rounded = (y_2_new
        + (product_rest(a, x_2, y_2_new_a, y_2_new - y_2_new_right) + (y_2 - y_2_new_right)))
    y_3_new_rounded = (y_3_new
        + (product_rest(a, x_3, y_3_new_a, y_3_new - y_3_new_right) + (y_3 - y_3_new_right)))
    return (y_0_new_rounded, y_1_new_rounded, y_2_new_rounded, y_3_new_rounded)


@kernel("(4)->()")
def quaternion_norm(q):
    """|q| = sqrt(v·v + w^2).

    (4)->().  q: quaternion (x, y, z, w), the scalar last; norm: number.
    12 mul, 35 add, 1 product error, 4 product rest, 2 div, 1 sqrt, 4 abs, 9 less, 2 equal, 11
    select.  Each component is within 1 ulp as long as its condition is below 1e13; in single
    precision it is the nearest number, except near ties, as long as that is below 1e5;
    searched, not proved.
    """
    q_0, q_1, q_2, q_3 = q
    s_size_0 = absolute(q_0)
    s_size_1 = absolute(q_1)
    s_size_2 = absolute(q_2)
    s_size_3 = absolute(q_3)
    s_largest1 = where(s_size_0 < s_size_1, s_size_1, s_size_0)
    s_largest2 = where(s_largest1 < s_size_2, s_size_2, s_largest1)
    s_largest3 = where(s_largest2 < s_size_3, s_size_3, s_largest2)
    s_d = where(s_largest3 < 256, 1.3093562431584567e+151,
        where(6.703903964971299e+153 < s_largest3, real(3.7291703656001034e-155), real(1)))
    s = where(s_largest3 < 1.955159272639747e-149, 1.0715086071862673e+301, s_d)
    y_0 = q_0 * s
    y_1 = q_1 * s
    y_2 = q_2 * s
    y_3 = q_3 * s
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
def quaternion_normalize(self):
    """self = self / |self|; zero stays zero.

    (4)->(4).  self: quaternion (x, y, z, w), the scalar last.
    33 mul, 86 add, 5 product error, 4 product rest, 10 div, 1 sqrt, 4 abs, 8 less, 6 equal, 15
    select.  Each component is within 1 ulp as long as its condition is below 1e13; in single
    precision it is the nearest number, except near ties, as long as that is below 1e5;
    searched, not proved.
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
def quaternion_normalized(q):
    """qo = q / |q|; zero stays zero.

    (4)->(4).  q, qo: quaternion (x, y, z, w), the scalar last.
    33 mul, 86 add, 5 product error, 4 product rest, 10 div, 1 sqrt, 4 abs, 8 less, 6 equal, 15
    select.  Each component is within 1 ulp as long as its condition is below 1e13; in single
    precision it is the nearest number, except near ties, as long as that is below 1e5;
    searched, not proved.
    """
    q_0, q_1, q_2, q_3 = q
    s_size_0 = absolute(q_0)
    s_size_1 = absolute(q_1)
    s_size_2 = absolute(q_2)
    s_size_3 = absolute(q_3)
    s_largest1 = where(s_size_0 < s_size_1, s_size_1, s_size_0)
    s_largest2 = where(s_largest1 < s_size_2, s_size_2, s_largest1)
    s_largest3 = where(s_largest2 < s_size_3, s_size_3, s_largest2)
    s_d = where(s_largest3 < 256, 1.3093562431584567e+151,
        where(6.703903964971299e+153 < s_largest3, real(3.7291703656001034e-155), real(1)))
    s = where(s_largest3 < 1.955159272639747e-149, 1.0715086071862673e+301, s_d)
    y_0 = q_0 * s
    y_1 = q_1 * s
    y_2 = q_2 * s
    y_3 = q_3 * s
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
    sized_0 = q_0 * up
    sized_1 = q_1 * up
    sized_2 = q_2 * up
    sized_3 = q_3 * up
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
    qo_0 = quotient_0_sum * down
    qo_0_inverse = 1 / down
    qo_0_rest = (quotient_0_sum - qo_0 * qo_0_inverse
        + (quotient_0 - (quotient_0_sum - quotient_0_sum_right)
        + (quotient_0_lo - quotient_0_sum_right)))
    quotient_1_sum = quotient_1 + quotient_1_lo
    quotient_1_sum_right = quotient_1_sum - quotient_1
    qo_1 = quotient_1_sum * down
    qo_1_rest = (quotient_1_sum - qo_1 * qo_0_inverse
        + (quotient_1 - (quotient_1_sum - quotient_1_sum_right)
        + (quotient_1_lo - quotient_1_sum_right)))
    quotient_2_sum = quotient_2 + quotient_2_lo
    quotient_2_sum_right = quotient_2_sum - quotient_2
    qo_2 = quotient_2_sum * down
    qo_2_rest = (quotient_2_sum - qo_2 * qo_0_inverse
        + (quotient_2 - (quotient_2_sum - quotient_2_sum_right)
        + (quotient_2_lo - quotient_2_sum_right)))
    quotient_3_sum = quotient_3 + quotient_3_lo
    quotient_3_sum_right = quotient_3_sum - quotient_3
    qo_3 = quotient_3_sum * down
    qo_3_rest = (quotient_3_sum - qo_3 * qo_0_inverse
        + (quotient_3 - (quotient_3_sum - quotient_3_sum_right)
        + (quotient_3_lo - quotient_3_sum_right)))
    qo_0_rounded = qo_0 + qo_0_rest * down
    qo_1_rounded = qo_1 + qo_1_rest * down
    qo_2_rounded = qo_2 + qo_2_rest * down
    qo_3_rounded = qo_3 + qo_3_rest * down
    qo_0_final = where(qo_0_rounded == qo_0_rounded, qo_0_rounded, qo_0)
    qo_1_final = where(qo_1_rounded == qo_1_rounded, qo_1_rounded, qo_1)
    qo_2_final = where(qo_2_rounded == qo_2_rounded, qo_2_rounded, qo_2)
    qo_3_final = where(qo_3_rounded == qo_3_rounded, qo_3_rounded, qo_3)
    return (qo_0_final, qo_1_final, qo_2_final, qo_3_final)


@kernel("(4)->()")
def quaternion_unit_defect(q):
    """|q| - 1: 0 for a unit quaternion, negative for a shorter one.

    (4)->().  q: quaternion (x, y, z, w), the scalar last; defect: number.
    12 mul, 42 add, 1 product error, 4 product rest, 2 div, 1 sqrt, 4 abs, 9 less, 2 equal, 11
    select.  Each component is within 1 ulp as long as its condition is below 1e13; in single
    precision it is the nearest number, except near ties, as long as that is below 1e5;
    searched, not proved.
    """
    q_0, q_1, q_2, q_3 = q
    s_size_0 = absolute(q_0)
    s_size_1 = absolute(q_1)
    s_size_2 = absolute(q_2)
    s_size_3 = absolute(q_3)
    s_largest1 = where(s_size_0 < s_size_1, s_size_1, s_size_0)
    s_largest2 = where(s_largest1 < s_size_2, s_size_2, s_largest1)
    s_largest3 = where(s_largest2 < s_size_3, s_size_3, s_largest2)
    s_d = where(s_largest3 < 256, 1.3093562431584567e+151,
        where(6.703903964971299e+153 < s_largest3, real(3.7291703656001034e-155), real(1)))
    s = where(s_largest3 < 1.955159272639747e-149, 1.0715086071862673e+301, s_d)
    y_0 = q_0 * s
    y_1 = q_1 * s
    y_2 = q_2 * s
    y_3 = q_3 * s
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
    length = n_sum * r
    defect = length - 1
    defect_right = length - defect
    length_lo = (n_sum - length * (1 / r) + (n - (n_sum - n_sum_right) + (n_lo - n_sum_right))) * r
    defect_rounded = defect + (length - (defect + defect_right) - (1 - defect_right) + length_lo)
    defect_final = where(defect_rounded == defect_rounded, defect_rounded, defect)
    return defect_final


@kernel("(4)->(4)")
def quaternion_nearest_unit(q):
    """qo = q / |q|, the unit quaternion nearest to q; NaN for zero, which has none.

    (4)->(4).  q, qo: quaternion (x, y, z, w), the scalar last.
    17 mul, 54 add, 5 product error, 4 product rest, 9 div, 1 sqrt, 4 abs, 6 less, 6 equal, 21
    select.  Each component is within 1 ulp as long as its condition is below 1e13; in single
    precision it is the nearest number, except near ties, as long as that is below 1e5;
    searched, not proved.
    """
    q_0, q_1, q_2, q_3 = q
    s_size_0 = absolute(q_0)
    s_size_1 = absolute(q_1)
    s_size_2 = absolute(q_2)
    s_size_3 = absolute(q_3)
    s_largest1 = where(s_size_0 < s_size_1, s_size_1, s_size_0)
    s_largest2 = where(s_largest1 < s_size_2, s_size_2, s_largest1)
    s_largest3 = where(s_largest2 < s_size_3, s_size_3, s_largest2)
    s_d = where(s_largest3 < 256, 1.3093562431584567e+151,
        where(6.703903964971299e+153 < s_largest3, real(3.7291703656001034e-155), real(1)))
    s = where(s_largest3 < 1.955159272639747e-149, 1.0715086071862673e+301, s_d)
    scaled_s_0 = q_0 * s
    scaled_s_1 = q_1 * s
    scaled_s_2 = q_2 * s
    scaled_s_3 = q_3 * s
    n_a = scaled_s_0 * scaled_s_0
    n_b = scaled_s_1 * scaled_s_1
    n_c = n_a + n_b
    n_c_right = n_c - n_a
    n_d = scaled_s_2 * scaled_s_2
    n_e = n_c + n_d
    n_e_right = n_e - n_c
    n_c_lo = (product_rest(scaled_s_0, scaled_s_0, n_a, n_c - n_c_right)
        + product_rest(scaled_s_1, scaled_s_1, n_b, n_c_right))
    n_f = scaled_s_3 * scaled_s_3
    n_g = n_e + n_f
    n_g_right = n_g - n_e
    n_e_lo = n_c - (n_e - n_e_right) + product_rest(scaled_s_2, scaled_s_2, n_d, n_e_right) + n_c_lo
    n_g_lo = n_e - (n_g - n_g_right) + product_rest(scaled_s_3, scaled_s_3, n_f, n_g_right) + n_e_lo
    n_g_sum = n_g + n_g_lo
    n_g_sum_right = n_g_sum - n_g
    n = sqrt(n_g_sum)
    n_product = n * n
    n_lo = ((n_g_sum - n_product - product_error(n, n, n_product)
        + (n_g - (n_g_sum - n_g_sum_right) + (n_g_lo - n_g_sum_right))) / where(n == 0, 1, n + n))
    n_sum = n + n_lo
    n_sum_right = n_sum - n
    divisor_a = n_sum == 0
    divisor = where(divisor_a, 1, n_sum)
    divisor_lo = where(divisor_a, 0, n - (n_sum - n_sum_right) + (n_lo - n_sum_right))
    divisor_sum = divisor + divisor_lo
    divisor_sum_right = divisor_sum - divisor
    divisor_sum_lo = divisor - (divisor_sum - divisor_sum_right) + (divisor_lo - divisor_sum_right)
    unit_0 = scaled_s_0 / divisor_sum
    unit_0_product = unit_0 * divisor_sum
    unit_1 = scaled_s_1 / divisor_sum
    unit_1_product = unit_1 * divisor_sum
    unit_2 = scaled_s_2 / divisor_sum
    unit_2_product = unit_2 * divisor_sum
    unit_3 = scaled_s_3 / divisor_sum
    unit_3_product = unit_3 * divisor_sum
    qo_0 = where(divisor_a, nan, unit_0)
    unit_0_lo = ((scaled_s_0 - unit_0_product - product_error(unit_0, divisor_sum, unit_0_product)
        - unit_0 * divisor_sum_lo) / divisor_sum)
    qo_1 = where(divisor_a, nan, unit_1)
    unit_1_lo = ((scaled_s_1 - unit_1_product - product_error(unit_1, divisor_sum, unit_1_product)
        - unit_1 * divisor_sum_lo) / divisor_sum)
    qo_2 = where(divisor_a, nan, unit_2)
    unit_2_lo = ((scaled_s_2 - unit_2_product - product_error(unit_2, divisor_sum, unit_2_product)
        - unit_2 * divisor_sum_lo) / divisor_sum)
    qo_3 = where(divisor_a, nan, unit_3)
    unit_3_lo = ((scaled_s_3 - unit_3_product - product_error(unit_3, divisor_sum, unit_3_product)
        - unit_3 * divisor_sum_lo) / divisor_sum)
    qo_0_rounded = qo_0 + where(divisor_a, 0, unit_0_lo)
    qo_1_rounded = qo_1 + where(divisor_a, 0, unit_1_lo)
    qo_2_rounded = qo_2 + where(divisor_a, 0, unit_2_lo)
    qo_3_rounded = qo_3 + where(divisor_a, 0, unit_3_lo)
    qo_0_final = where(qo_0_rounded == qo_0_rounded, qo_0_rounded, qo_0)
    qo_1_final = where(qo_1_rounded == qo_1_rounded, qo_1_rounded, qo_1)
    qo_2_final = where(qo_2_rounded == qo_2_rounded, qo_2_rounded, qo_2)
    qo_3_final = where(qo_3_rounded == qo_3_rounded, qo_3_rounded, qo_3)
    return (qo_0_final, qo_1_final, qo_2_final, qo_3_final)


@kernel("(4),(3)->(3)")
def rotate_qv(q, v):
    """vo = R(q) v, |q| = 1.

    (4),(3)->(3).  q: quaternion (x, y, z, w), the scalar last; v, vo: vector.
    30 mul, 75 add, 15 product rest.  Error <= u |result| + 34 u^2 S, S the sum of the |terms|
    of the expanded formula; barring over- and underflow.
    """
    q_0, q_1, q_2, q_3 = q
    v_0, v_1, v_2 = v
    c_0a = q_1 * v_2
    c_0b = q_2 * v_1
    c_0 = c_0a - c_0b
    c_0_right = c_0a - c_0
    c_1a = q_2 * v_0
    c_1b = q_0 * v_2
    c_1 = c_1a - c_1b
    c_1_right = c_1a - c_1
    c_2a = q_0 * v_1
    c_2b = q_1 * v_0
    c_2 = c_2a - c_2b
    c_2_right = c_2a - c_2
    t_0 = 2 * c_0
    t_0_cross2 = (2
        * (product_rest(q_1, v_2, c_0a, c_0 + c_0_right) - product_rest(q_2, v_1, c_0b, c_0_right)))
    t_1 = 2 * c_1
    t_1_cross2 = (2
        * (product_rest(q_2, v_0, c_1a, c_1 + c_1_right) - product_rest(q_0, v_2, c_1b, c_1_right)))
    t_2 = 2 * c_2
    t_2_cross2 = (2
        * (product_rest(q_0, v_1, c_2a, c_2 + c_2_right) - product_rest(q_1, v_0, c_2b, c_2_right)))
    turn_0a = q_1 * t_2
    turn_0b = q_2 * t_1
    turn_0c = turn_0a - turn_0b
    turn_0c_right = turn_0a - turn_0c
    turn_0c_lo1 = (product_rest(q_1, t_2, turn_0a, turn_0c + turn_0c_right)
        - product_rest(q_2, t_1, turn_0b, turn_0c_right))
    turn_0d = q_3 * t_0
    turn_0 = turn_0c + turn_0d
    turn_0_right = turn_0 - turn_0c
    turn_0_lo2 = (turn_0c - (turn_0 - turn_0_right) + product_rest(q_3, t_0, turn_0d, turn_0_right)
        + q_3 * t_0_cross2)
    turn_1a = q_2 * t_0
    turn_1b = q_0 * t_2
    turn_1c = turn_1a - turn_1b
    turn_1c_right = turn_1a - turn_1c
    turn_1c_lo1 = (product_rest(q_2, t_0, turn_1a, turn_1c + turn_1c_right)
        - product_rest(q_0, t_2, turn_1b, turn_1c_right))
    turn_1d = q_3 * t_1
    turn_1 = turn_1c + turn_1d
    turn_1_right = turn_1 - turn_1c
    turn_1_lo2 = (turn_1c - (turn_1 - turn_1_right) + product_rest(q_3, t_1, turn_1d, turn_1_right)
        + q_3 * t_1_cross2)
    turn_2a = q_0 * t_1
    turn_2b = q_1 * t_0
    turn_2c = turn_2a - turn_2b
    turn_2c_right = turn_2a - turn_2c
    turn_2c_lo1 = (product_rest(q_0, t_1, turn_2a, turn_2c + turn_2c_right)
        - product_rest(q_1, t_0, turn_2b, turn_2c_right))
    turn_2d = q_3 * t_2
    turn_2 = turn_2c + turn_2d
    turn_2_right = turn_2 - turn_2c
    turn_2_lo2 = (turn_2c - (turn_2 - turn_2_right) + product_rest(q_3, t_2, turn_2d, turn_2_right)
        + q_3 * t_2_cross2)
    vo_0 = v_0 + turn_0
    vo_0_right = vo_0 - v_0
    vo_1 = v_1 + turn_1
    vo_1_right = vo_1 - v_1
    vo_2 = v_2 + turn_2
    vo_2_right = vo_2 - v_2
    vo_0_rounded = (vo_0
        + (v_0 - (vo_0 - vo_0_right) + (turn_0 - vo_0_right)
        + (turn_0_lo2 + (turn_0c_lo1 + (q_1 * t_2_cross2 - q_2 * t_1_cross2)))))
    vo_1_rounded = (vo_1
        + (v_1 - (vo_1 - vo_1_right) + (turn_1 - vo_1_right)
        + (turn_1_lo2 + (turn_1c_lo1 + (q_2 * t_0_cross2 - q_0 * t_2_cross2)))))
    vo_2_rounded = (vo_2
        + (v_2 - (vo_2 - vo_2_right) + (turn_2 - vo_2_right)
        + (turn_2_lo2 + (turn_2c_lo1 + (q_0 * t_1_cross2 - q_1 * t_0_cross2)))))
    return (vo_0_rounded, vo_1_rounded, vo_2_rounded)


@kernel("(4),(3)->(3)")
def rotate_qconjv(q, v):
    """vo = R(q)^T v, |q| = 1.

    (4),(3)->(3).  q: quaternion (x, y, z, w), the scalar last; v, vo: vector.
    30 mul, 75 add, 15 product rest.  Error <= u |result| + 34 u^2 S, S the sum of the |terms|
    of the expanded formula; barring over- and underflow.
    """
    q_0, q_1, q_2, q_3 = q
    v_0, v_1, v_2 = v
    c_0a = q_2 * v_1
    c_0b = q_1 * v_2
    c_0 = c_0a - c_0b
    c_0_right = c_0a - c_0
    c_1a = q_0 * v_2
    c_1b = q_2 * v_0
    c_1 = c_1a - c_1b
    c_1_right = c_1a - c_1
    c_2a = q_1 * v_0
    c_2b = q_0 * v_1
    c_2 = c_2a - c_2b
    c_2_right = c_2a - c_2
    t_0 = 2 * c_0
    t_0_cross2 = (2
        * (product_rest(q_2, v_1, c_0a, c_0 + c_0_right) - product_rest(q_1, v_2, c_0b, c_0_right)))
    t_1 = 2 * c_1
    t_1_cross2 = (2
        * (product_rest(q_0, v_2, c_1a, c_1 + c_1_right) - product_rest(q_2, v_0, c_1b, c_1_right)))
    t_2 = 2 * c_2
    t_2_cross2 = (2
        * (product_rest(q_1, v_0, c_2a, c_2 + c_2_right) - product_rest(q_0, v_1, c_2b, c_2_right)))
    turn_0a = q_2 * t_1
    turn_0b = q_1 * t_2
    turn_0c = turn_0a - turn_0b
    turn_0c_right = turn_0a - turn_0c
    turn_0c_lo1 = (product_rest(q_2, t_1, turn_0a, turn_0c + turn_0c_right)
        - product_rest(q_1, t_2, turn_0b, turn_0c_right))
    turn_0d = q_3 * t_0
    turn_0 = turn_0c + turn_0d
    turn_0_right = turn_0 - turn_0c
    turn_0_lo2 = (turn_0c - (turn_0 - turn_0_right) + product_rest(q_3, t_0, turn_0d, turn_0_right)
        + q_3 * t_0_cross2)
    turn_1a = q_0 * t_2
    turn_1b = q_2 * t_0
    turn_1c = turn_1a - turn_1b
    turn_1c_right = turn_1a - turn_1c
    turn_1c_lo1 = (product_rest(q_0, t_2, turn_1a, turn_1c + turn_1c_right)
        - product_rest(q_2, t_0, turn_1b, turn_1c_right))
    turn_1d = q_3 * t_1
    turn_1 = turn_1c + turn_1d
    turn_1_right = turn_1 - turn_1c
    turn_1_lo2 = (turn_1c - (turn_1 - turn_1_right) + product_rest(q_3, t_1, turn_1d, turn_1_right)
        + q_3 * t_1_cross2)
    turn_2a = q_1 * t_0
    turn_2b = q_0 * t_1
    turn_2c = turn_2a - turn_2b
    turn_2c_right = turn_2a - turn_2c
    turn_2c_lo1 = (product_rest(q_1, t_0, turn_2a, turn_2c + turn_2c_right)
        - product_rest(q_0, t_1, turn_2b, turn_2c_right))
    turn_2d = q_3 * t_2
    turn_2 = turn_2c + turn_2d
    turn_2_right = turn_2 - turn_2c
    turn_2_lo2 = (turn_2c - (turn_2 - turn_2_right) + product_rest(q_3, t_2, turn_2d, turn_2_right)
        + q_3 * t_2_cross2)
    vo_0 = v_0 + turn_0
    vo_0_right = vo_0 - v_0
    vo_1 = v_1 + turn_1
    vo_1_right = vo_1 - v_1
    vo_2 = v_2 + turn_2
    vo_2_right = vo_2 - v_2
    vo_0_rounded = (vo_0
        + (v_0 - (vo_0 - vo_0_right) + (turn_0 - vo_0_right)
        + (turn_0_lo2 + (turn_0c_lo1 + (q_2 * t_1_cross2 - q_1 * t_2_cross2)))))
    vo_1_rounded = (vo_1
        + (v_1 - (vo_1 - vo_1_right) + (turn_1 - vo_1_right)
        + (turn_1_lo2 + (turn_1c_lo1 + (q_0 * t_2_cross2 - q_2 * t_0_cross2)))))
    vo_2_rounded = (vo_2
        + (v_2 - (vo_2 - vo_2_right) + (turn_2 - vo_2_right)
        + (turn_2_lo2 + (turn_2c_lo1 + (q_1 * t_0_cross2 - q_0 * t_1_cross2)))))
    return (vo_0_rounded, vo_1_rounded, vo_2_rounded)


@kernel("(4),(4)->(4)")
def quaternion_product_qq(q1i, q2i):
    """qo = q1i q2i.

    (4),(4)->(4).  q1i, q2i, qo: quaternion (x, y, z, w), the scalar last.
    16 mul, 68 add, 16 product rest.  Error <= u |result| + 17 u^2 S, S the sum of the |terms|
    of the expanded formula; barring over- and underflow.
    """
    q1i_0, q1i_1, q1i_2, q1i_3 = q1i
    q2i_0, q2i_1, q2i_2, q2i_3 = q2i
    qo_0a = q1i_0 * q2i_3
    qo_0b = q1i_1 * q2i_2
    qo_0c = q1i_2 * q2i_1
    qo_0d = qo_0b - qo_0c
    qo_0d_right = qo_0b - qo_0d
    qo_0e = qo_0a + qo_0d
    qo_0e_right = qo_0e - qo_0a
    qo_0d_lo = (product_rest(q1i_1, q2i_2, qo_0b, qo_0d + qo_0d_right)
        - product_rest(q1i_2, q2i_1, qo_0c, qo_0d_right))
    qo_0f = q1i_3 * q2i_0
    qo_0 = qo_0e + qo_0f
    qo_0_right = qo_0 - qo_0e
    qo_0e_lo = (product_rest(q1i_0, q2i_3, qo_0a, qo_0e - qo_0e_right) + (qo_0d - qo_0e_right)
        + qo_0d_lo)
    qo_1a = q1i_2 * q2i_0
    qo_1b = q1i_0 * q2i_2
    qo_1c = qo_1a - qo_1b
    qo_1c_right = qo_1a - qo_1c
    qo_1d = q1i_1 * q2i_3
    qo_1e = qo_1c + qo_1d
    qo_1e_right = qo_1e - qo_1c
    qo_1c_lo = (product_rest(q1i_2, q2i_0, qo_1a, qo_1c + qo_1c_right)
        - product_rest(q1i_0, q2i_2, qo_1b, qo_1c_right))
    qo_1f = q1i_3 * q2i_1
    qo_1 = qo_1e + qo_1f
    qo_1_right = qo_1 - qo_1e
    qo_1e_lo = (qo_1c - (qo_1e - qo_1e_right) + product_rest(q1i_1, q2i_3, qo_1d, qo_1e_right)
        + qo_1c_lo)
    qo_2a = q1i_0 * q2i_1
    qo_2b = q1i_1 * q2i_0
    qo_2c = qo_2a - qo_2b
    qo_2c_right = qo_2a - qo_2c
    qo_2d = q1i_2 * q2i_3
    qo_2e = qo_2c + qo_2d
    qo_2e_right = qo_2e - qo_2c
    qo_2c_lo = (product_rest(q1i_0, q2i_1, qo_2a, qo_2c + qo_2c_right)
        - product_rest(q1i_1, q2i_0, qo_2b, qo_2c_right))
    qo_2f = q1i_3 * q2i_2
    qo_2 = qo_2e + qo_2f
    qo_2_right = qo_2 - qo_2e
    qo_2e_lo = (qo_2c - (qo_2e - qo_2e_right) + product_rest(q1i_2, q2i_3, qo_2d, qo_2e_right)
        + qo_2c_lo)
    qo_3a = q1i_3 * q2i_3
    qo_3b = q1i_0 * q2i_0
    qo_3c = q1i_1 * q2i_1
    qo_3d = qo_3b + qo_3c
    qo_3d_right = qo_3d - qo_3b
    qo_3e = q1i_2 * q2i_2
    qo_3f = qo_3d + qo_3e
    qo_3f_right = qo_3f - qo_3d
    qo_3d_lo = (product_rest(q1i_0, q2i_0, qo_3b, qo_3d - qo_3d_right)
        + product_rest(q1i_1, q2i_1, qo_3c, qo_3d_right))
    qo_3 = qo_3a - qo_3f
    qo_3_right = qo_3a - qo_3
    qo_3f_lo = (qo_3d - (qo_3f - qo_3f_right) + product_rest(q1i_2, q2i_2, qo_3e, qo_3f_right)
        + qo_3d_lo)
    qo_0_rounded = (qo_0
        + (qo_0e - (qo_0 - qo_0_right) + product_rest(q1i_3, q2i_0, qo_0f, qo_0_right) + qo_0e_lo))
    qo_1_rounded = (qo_1
        + (qo_1e - (qo_1 - qo_1_right) + product_rest(q1i_3, q2i_1, qo_1f, qo_1_right) + qo_1e_lo))
    qo_2_rounded = (qo_2
        + (qo_2e - (qo_2 - qo_2_right) + product_rest(q1i_3, q2i_2, qo_2f, qo_2_right) + qo_2e_lo))
    qo_3_rounded = (qo_3
        + (product_rest(q1i_3, q2i_3, qo_3a, qo_3 + qo_3_right) - (qo_3f - qo_3_right) - qo_3f_lo))
    return (qo_0_rounded, qo_1_rounded, qo_2_rounded, qo_3_rounded)


@kernel("(4),(4)->(4)")
def quaternion_product_qqconj(q1i, q2i):
    """qo = q1i q2i*.

    (4),(4)->(4).  q1i, q2i, qo: quaternion (x, y, z, w), the scalar last.
    16 mul, 68 add, 16 product rest.  Error <= u |result| + (v: 12, w: 17) u^2 S, S the sum of
    the |terms| of the expanded formula; barring over- and underflow.
    """
    q1i_0, q1i_1, q1i_2, q1i_3 = q1i
    q2i_0, q2i_1, q2i_2, q2i_3 = q2i
    qo_0a = q1i_0 * q2i_3
    qo_0b = q1i_3 * q2i_0
    qo_0c = qo_0a - qo_0b
    qo_0c_right = qo_0a - qo_0c
    qo_0d = q1i_2 * q2i_1
    qo_0e = q1i_1 * q2i_2
    qo_0f = qo_0d - qo_0e
    qo_0f_right = qo_0d - qo_0f
    qo_0 = qo_0c + qo_0f
    qo_0_right = qo_0 - qo_0c
    qo_0f_lo = (product_rest(q1i_2, q2i_1, qo_0d, qo_0f + qo_0f_right)
        - product_rest(q1i_1, q2i_2, qo_0e, qo_0f_right))
    qo_0c_lo = (product_rest(q1i_0, q2i_3, qo_0a, qo_0c + qo_0c_right)
        - product_rest(q1i_3, q2i_0, qo_0b, qo_0c_right))
    qo_1a = q1i_0 * q2i_2
    qo_1b = q1i_2 * q2i_0
    qo_1c = qo_1a - qo_1b
    qo_1c_right = qo_1a - qo_1c
    qo_1d = q1i_1 * q2i_3
    qo_1e = q1i_3 * q2i_1
    qo_1f = qo_1d - qo_1e
    qo_1f_right = qo_1d - qo_1f
    qo_1 = qo_1c + qo_1f
    qo_1_right = qo_1 - qo_1c
    qo_1f_lo = (product_rest(q1i_1, q2i_3, qo_1d, qo_1f + qo_1f_right)
        - product_rest(q1i_3, q2i_1, qo_1e, qo_1f_right))
    qo_1c_lo = (product_rest(q1i_0, q2i_2, qo_1a, qo_1c + qo_1c_right)
        - product_rest(q1i_2, q2i_0, qo_1b, qo_1c_right))
    qo_2a = q1i_1 * q2i_0
    qo_2b = q1i_0 * q2i_1
    qo_2c = qo_2a - qo_2b
    qo_2c_right = qo_2a - qo_2c
    qo_2d = q1i_2 * q2i_3
    qo_2e = q1i_3 * q2i_2
    qo_2f = qo_2d - qo_2e
    qo_2f_right = qo_2d - qo_2f
    qo_2 = qo_2c + qo_2f
    qo_2_right = qo_2 - qo_2c
    qo_2f_lo = (product_rest(q1i_2, q2i_3, qo_2d, qo_2f + qo_2f_right)
        - product_rest(q1i_3, q2i_2, qo_2e, qo_2f_right))
    qo_2c_lo = (product_rest(q1i_1, q2i_0, qo_2a, qo_2c + qo_2c_right)
        - product_rest(q1i_0, q2i_1, qo_2b, qo_2c_right))
    qo_3a = q1i_0 * q2i_0
    qo_3b = q1i_1 * q2i_1
    qo_3c = qo_3a + qo_3b
    qo_3c_right = qo_3c - qo_3a
    qo_3d = q1i_2 * q2i_2
    qo_3e = qo_3c + qo_3d
    qo_3e_right = qo_3e - qo_3c
    qo_3c_lo = (product_rest(q1i_0, q2i_0, qo_3a, qo_3c - qo_3c_right)
        + product_rest(q1i_1, q2i_1, qo_3b, qo_3c_right))
    qo_3f = q1i_3 * q2i_3
    qo_3 = qo_3e + qo_3f
    qo_3_right = qo_3 - qo_3e
    qo_3e_lo = (qo_3c - (qo_3e - qo_3e_right) + product_rest(q1i_2, q2i_2, qo_3d, qo_3e_right)
        + qo_3c_lo)
    qo_0_rounded = qo_0 + (qo_0c - (qo_0 - qo_0_right) + (qo_0f - qo_0_right) + qo_0f_lo + qo_0c_lo)
    qo_1_rounded = qo_1 + (qo_1c - (qo_1 - qo_1_right) + (qo_1f - qo_1_right) + qo_1f_lo + qo_1c_lo)
    qo_2_rounded = qo_2 + (qo_2c - (qo_2 - qo_2_right) + (qo_2f - qo_2_right) + qo_2f_lo + qo_2c_lo)
    qo_3_rounded = (qo_3
        + (qo_3e - (qo_3 - qo_3_right) + product_rest(q1i_3, q2i_3, qo_3f, qo_3_right) + qo_3e_lo))
    return (qo_0_rounded, qo_1_rounded, qo_2_rounded, qo_3_rounded)


@kernel("(4),(4)->(4)")
def quaternion_product_qconjq(q1i, q2i):
    """qo = q1i* q2i.

    (4),(4)->(4).  q1i, q2i, qo: quaternion (x, y, z, w), the scalar last.
    16 mul, 68 add, 16 product rest.  Error <= u |result| + (v: 12, w: 17) u^2 S, S the sum of
    the |terms| of the expanded formula; barring over- and underflow.
    """
    q1i_0, q1i_1, q1i_2, q1i_3 = q1i
    q2i_0, q2i_1, q2i_2, q2i_3 = q2i
    qo_0a = q1i_3 * q2i_0
    qo_0b = q1i_0 * q2i_3
    qo_0c = qo_0a - qo_0b
    qo_0c_right = qo_0a - qo_0c
    qo_0d = q1i_2 * q2i_1
    qo_0e = q1i_1 * q2i_2
    qo_0f = qo_0d - qo_0e
    qo_0f_right = qo_0d - qo_0f
    qo_0 = qo_0c + qo_0f
    qo_0_right = qo_0 - qo_0c
    qo_0f_lo = (product_rest(q1i_2, q2i_1, qo_0d, qo_0f + qo_0f_right)
        - product_rest(q1i_1, q2i_2, qo_0e, qo_0f_right))
    qo_0c_lo = (product_rest(q1i_3, q2i_0, qo_0a, qo_0c + qo_0c_right)
        - product_rest(q1i_0, q2i_3, qo_0b, qo_0c_right))
    qo_1a = q1i_0 * q2i_2
    qo_1b = q1i_2 * q2i_0
    qo_1c = qo_1a - qo_1b
    qo_1c_right = qo_1a - qo_1c
    qo_1d = q1i_3 * q2i_1
    qo_1e = q1i_1 * q2i_3
    qo_1f = qo_1d - qo_1e
    qo_1f_right = qo_1d - qo_1f
    qo_1 = qo_1c + qo_1f
    qo_1_right = qo_1 - qo_1c
    qo_1f_lo = (product_rest(q1i_3, q2i_1, qo_1d, qo_1f + qo_1f_right)
        - product_rest(q1i_1, q2i_3, qo_1e, qo_1f_right))
    qo_1c_lo = (product_rest(q1i_0, q2i_2, qo_1a, qo_1c + qo_1c_right)
        - product_rest(q1i_2, q2i_0, qo_1b, qo_1c_right))
    qo_2a = q1i_1 * q2i_0
    qo_2b = q1i_0 * q2i_1
    qo_2c = qo_2a - qo_2b
    qo_2c_right = qo_2a - qo_2c
    qo_2d = q1i_3 * q2i_2
    qo_2e = q1i_2 * q2i_3
    qo_2f = qo_2d - qo_2e
    qo_2f_right = qo_2d - qo_2f
    qo_2 = qo_2c + qo_2f
    qo_2_right = qo_2 - qo_2c
    qo_2f_lo = (product_rest(q1i_3, q2i_2, qo_2d, qo_2f + qo_2f_right)
        - product_rest(q1i_2, q2i_3, qo_2e, qo_2f_right))
    qo_2c_lo = (product_rest(q1i_1, q2i_0, qo_2a, qo_2c + qo_2c_right)
        - product_rest(q1i_0, q2i_1, qo_2b, qo_2c_right))
    qo_3a = q1i_0 * q2i_0
    qo_3b = q1i_1 * q2i_1
    qo_3c = qo_3a + qo_3b
    qo_3c_right = qo_3c - qo_3a
    qo_3d = q1i_2 * q2i_2
    qo_3e = qo_3c + qo_3d
    qo_3e_right = qo_3e - qo_3c
    qo_3c_lo = (product_rest(q1i_0, q2i_0, qo_3a, qo_3c - qo_3c_right)
        + product_rest(q1i_1, q2i_1, qo_3b, qo_3c_right))
    qo_3f = q1i_3 * q2i_3
    qo_3 = qo_3e + qo_3f
    qo_3_right = qo_3 - qo_3e
    qo_3e_lo = (qo_3c - (qo_3e - qo_3e_right) + product_rest(q1i_2, q2i_2, qo_3d, qo_3e_right)
        + qo_3c_lo)
    qo_0_rounded = qo_0 + (qo_0c - (qo_0 - qo_0_right) + (qo_0f - qo_0_right) + qo_0f_lo + qo_0c_lo)
    qo_1_rounded = qo_1 + (qo_1c - (qo_1 - qo_1_right) + (qo_1f - qo_1_right) + qo_1f_lo + qo_1c_lo)
    qo_2_rounded = qo_2 + (qo_2c - (qo_2 - qo_2_right) + (qo_2f - qo_2_right) + qo_2f_lo + qo_2c_lo)
    qo_3_rounded = (qo_3
        + (qo_3e - (qo_3 - qo_3_right) + product_rest(q1i_3, q2i_3, qo_3f, qo_3_right) + qo_3e_lo))
    return (qo_0_rounded, qo_1_rounded, qo_2_rounded, qo_3_rounded)


@kernel("(4),(4)->(4)")
def quaternion_product_qconjqconj(q1i, q2i):
    """qo = q1i* q2i*.

    (4),(4)->(4).  q1i, q2i, qo: quaternion (x, y, z, w), the scalar last.
    16 mul, 68 add, 16 product rest.  Error <= u |result| + 17 u^2 S, S the sum of the |terms|
    of the expanded formula; barring over- and underflow.
    """
    q1i_0, q1i_1, q1i_2, q1i_3 = q1i
    q2i_0, q2i_1, q2i_2, q2i_3 = q2i
    qo_0a = q1i_1 * q2i_2
    qo_0b = q1i_2 * q2i_1
    qo_0c = qo_0a - qo_0b
    qo_0c_right = qo_0a - qo_0c
    qo_0d = q1i_0 * q2i_3
    qo_0e = qo_0c - qo_0d
    qo_0e_right = qo_0c - qo_0e
    qo_0c_lo = (product_rest(q1i_1, q2i_2, qo_0a, qo_0c + qo_0c_right)
        - product_rest(q1i_2, q2i_1, qo_0b, qo_0c_right))
    qo_0f = q1i_3 * q2i_0
    qo_0 = qo_0e - qo_0f
    qo_0_right = qo_0e - qo_0
    qo_0e_lo = (qo_0c - (qo_0e + qo_0e_right) - product_rest(q1i_0, q2i_3, qo_0d, qo_0e_right)
        + qo_0c_lo)
    qo_1a = q1i_2 * q2i_0
    qo_1b = q1i_0 * q2i_2
    qo_1c = qo_1a - qo_1b
    qo_1c_right = qo_1a - qo_1c
    qo_1d = q1i_1 * q2i_3
    qo_1e = qo_1c - qo_1d
    qo_1e_right = qo_1c - qo_1e
    qo_1c_lo = (product_rest(q1i_2, q2i_0, qo_1a, qo_1c + qo_1c_right)
        - product_rest(q1i_0, q2i_2, qo_1b, qo_1c_right))
    qo_1f = q1i_3 * q2i_1
    qo_1 = qo_1e - qo_1f
    qo_1_right = qo_1e - qo_1
    qo_1e_lo = (qo_1c - (qo_1e + qo_1e_right) - product_rest(q1i_1, q2i_3, qo_1d, qo_1e_right)
        + qo_1c_lo)
    qo_2a = q1i_0 * q2i_1
    qo_2b = q1i_1 * q2i_0
    qo_2c = qo_2a - qo_2b
    qo_2c_right = qo_2a - qo_2c
    qo_2d = q1i_2 * q2i_3
    qo_2e = qo_2c - qo_2d
    qo_2e_right = qo_2c - qo_2e
    qo_2c_lo = (product_rest(q1i_0, q2i_1, qo_2a, qo_2c + qo_2c_right)
        - product_rest(q1i_1, q2i_0, qo_2b, qo_2c_right))
    qo_2f = q1i_3 * q2i_2
    qo_2 = qo_2e - qo_2f
    qo_2_right = qo_2e - qo_2
    qo_2e_lo = (qo_2c - (qo_2e + qo_2e_right) - product_rest(q1i_2, q2i_3, qo_2d, qo_2e_right)
        + qo_2c_lo)
    qo_3a = q1i_3 * q2i_3
    qo_3b = q1i_0 * q2i_0
    qo_3c = q1i_1 * q2i_1
    qo_3d = qo_3b + qo_3c
    qo_3d_right = qo_3d - qo_3b
    qo_3e = q1i_2 * q2i_2
    qo_3f = qo_3d + qo_3e
    qo_3f_right = qo_3f - qo_3d
    qo_3d_lo = (product_rest(q1i_0, q2i_0, qo_3b, qo_3d - qo_3d_right)
        + product_rest(q1i_1, q2i_1, qo_3c, qo_3d_right))
    qo_3 = qo_3a - qo_3f
    qo_3_right = qo_3a - qo_3
    qo_3f_lo = (qo_3d - (qo_3f - qo_3f_right) + product_rest(q1i_2, q2i_2, qo_3e, qo_3f_right)
        + qo_3d_lo)
    qo_0_rounded = (qo_0
        + (qo_0e - (qo_0 + qo_0_right) - product_rest(q1i_3, q2i_0, qo_0f, qo_0_right) + qo_0e_lo))
    qo_1_rounded = (qo_1
        + (qo_1e - (qo_1 + qo_1_right) - product_rest(q1i_3, q2i_1, qo_1f, qo_1_right) + qo_1e_lo))
    qo_2_rounded = (qo_2
        + (qo_2e - (qo_2 + qo_2_right) - product_rest(q1i_3, q2i_2, qo_2f, qo_2_right) + qo_2e_lo))
    qo_3_rounded = (qo_3
        + (product_rest(q1i_3, q2i_3, qo_3a, qo_3 + qo_3_right) - (qo_3f - qo_3_right) - qo_3f_lo))
    return (qo_0_rounded, qo_1_rounded, qo_2_rounded, qo_3_rounded)


@kernel("(2),(4)->(4)")
def quaternion_product_qxq(dci, qi):
    """qo = (s e_x; c) qi, dci = (s, c), sine and cosine of half the angle.

    (2),(4)->(4).  dci: (sin θ, cos θ); qi, qo: quaternion (x, y, z, w), the scalar last.
    8 mul, 20 add, 8 product rest.  Error <= u |result| + 6 u^2 S, S the sum of the |terms| of
    the expanded formula; barring over- and underflow.
    """
    dci_0, dci_1 = dci
    qi_0, qi_1, qi_2, qi_3 = qi
    qo_0a = dci_0 * qi_3
    qo_0b = dci_1 * qi_0
    qo_0 = qo_0a + qo_0b
    qo_0_right = qo_0 - qo_0a
    qo_1a = dci_1 * qi_1
    qo_1b = dci_0 * qi_2
    qo_1 = qo_1a - qo_1b
    qo_1_right = qo_1a - qo_1
    qo_2a = dci_0 * qi_1
    qo_2b = dci_1 * qi_2
    qo_2 = qo_2a + qo_2b
    qo_2_right = qo_2 - qo_2a
    qo_3a = dci_1 * qi_3
    qo_3b = dci_0 * qi_0
    qo_3 = qo_3a - qo_3b
    qo_3_right = qo_3a - qo_3
    qo_0_rounded = (qo_0
        + (product_rest(dci_0, qi_3, qo_0a, qo_0 - qo_0_right)
        + product_rest(dci_1, qi_0, qo_0b, qo_0_right)))
    qo_1_rounded = (qo_1
        + (product_rest(dci_1, qi_1, qo_1a, qo_1 + qo_1_right)
        - product_rest(dci_0, qi_2, qo_1b, qo_1_right)))
    qo_2_rounded = (qo_2
        + (product_rest(dci_0, qi_1, qo_2a, qo_2 - qo_2_right)
        + product_rest(dci_1, qi_2, qo_2b, qo_2_right)))
    qo_3_rounded = (qo_3
        + (product_rest(dci_1, qi_3, qo_3a, qo_3 + qo_3_right)
        - product_rest(dci_0, qi_0, qo_3b, qo_3_right)))
    return (qo_0_rounded, qo_1_rounded, qo_2_rounded, qo_3_rounded)


@kernel("(2),(4)->(4)")
def quaternion_product_qxqconj(dci, qi):
    """qo = (s e_x; c) qi*, dci = (s, c), sine and cosine of half the angle.

    (2),(4)->(4).  dci: (sin θ, cos θ); qi, qo: quaternion (x, y, z, w), the scalar last.
    8 mul, 20 add, 8 product rest, 2 neg.  Error <= u |result| + 6 u^2 S, S the sum of the
    |terms| of the expanded formula; barring over- and underflow.
    """
    dci_0, dci_1 = dci
    qi_0, qi_1, qi_2, qi_3 = qi
    qo_0a = dci_0 * qi_3
    qo_0b = dci_1 * qi_0
    qo_0 = qo_0a - qo_0b
    qo_0_right = qo_0a - qo_0
    qo_1a = dci_0 * qi_2
    qo_1b = dci_1 * qi_1
    qo_1 = qo_1a - qo_1b
    qo_1_right = qo_1a - qo_1
    qo_2a = dci_0 * qi_1
    qo_2b = dci_1 * qi_2
    qo_2c = qo_2a + qo_2b
    qo_2c_right = qo_2c - qo_2a
    qo_2 = -qo_2c
    qo_3a = dci_0 * qi_0
    qo_3b = dci_1 * qi_3
    qo_3 = qo_3a + qo_3b
    qo_3_right = qo_3 - qo_3a
    qo_0_rounded = (qo_0
        + (product_rest(dci_0, qi_3, qo_0a, qo_0 + qo_0_right)
        - product_rest(dci_1, qi_0, qo_0b, qo_0_right)))
    qo_1_rounded = (qo_1
        + (product_rest(dci_0, qi_2, qo_1a, qo_1 + qo_1_right)
        - product_rest(dci_1, qi_1, qo_1b, qo_1_right)))
    qo_2_rounded = (qo_2 +
        -(product_rest(dci_0, qi_1, qo_2a, qo_2c - qo_2c_right)
        + product_rest(dci_1, qi_2, qo_2b, qo_2c_right)))
    qo_3_rounded = (qo_3
        + (product_rest(dci_0, qi_0, qo_3a, qo_3 - qo_3_right)
        + product_rest(dci_1, qi_3, qo_3b, qo_3_right)))
    return (qo_0_rounded, qo_1_rounded, qo_2_rounded, qo_3_rounded)


@kernel("(2),(4)->(4)")
def quaternion_product_qxconjq(dci, qi):
    """qo = (s e_x; c)* qi, dci = (s, c), sine and cosine of half the angle.

    (2),(4)->(4).  dci: (sin θ, cos θ); qi, qo: quaternion (x, y, z, w), the scalar last.
    8 mul, 20 add, 8 product rest.  Error <= u |result| + 6 u^2 S, S the sum of the |terms| of
    the expanded formula; barring over- and underflow.
    """
    dci_0, dci_1 = dci
    qi_0, qi_1, qi_2, qi_3 = qi
    qo_0a = dci_1 * qi_0
    qo_0b = dci_0 * qi_3
    qo_0 = qo_0a - qo_0b
    qo_0_right = qo_0a - qo_0
    qo_1a = dci_0 * qi_2
    qo_1b = dci_1 * qi_1
    qo_1 = qo_1a + qo_1b
    qo_1_right = qo_1 - qo_1a
    qo_2a = dci_1 * qi_2
    qo_2b = dci_0 * qi_1
    qo_2 = qo_2a - qo_2b
    qo_2_right = qo_2a - qo_2
    qo_3a = dci_0 * qi_0
    qo_3b = dci_1 * qi_3
    qo_3 = qo_3a + qo_3b
    qo_3_right = qo_3 - qo_3a
    qo_0_rounded = (qo_0
        + (product_rest(dci_1, qi_0, qo_0a, qo_0 + qo_0_right)
        - product_rest(dci_0, qi_3, qo_0b, qo_0_right)))
    qo_1_rounded = (qo_1
        + (product_rest(dci_0, qi_2, qo_1a, qo_1 - qo_1_right)
        + product_rest(dci_1, qi_1, qo_1b, qo_1_right)))
    qo_2_rounded = (qo_2
        + (product_rest(dci_1, qi_2, qo_2a, qo_2 + qo_2_right)
        - product_rest(dci_0, qi_1, qo_2b, qo_2_right)))
    qo_3_rounded = (qo_3
        + (product_rest(dci_0, qi_0, qo_3a, qo_3 - qo_3_right)
        + product_rest(dci_1, qi_3, qo_3b, qo_3_right)))
    return (qo_0_rounded, qo_1_rounded, qo_2_rounded, qo_3_rounded)


@kernel("(2),(4)->(4)")
def quaternion_product_qxconjqconj(dci, qi):
    """qo = (s e_x; c)* qi*, dci = (s, c), sine and cosine of half the angle.

    (2),(4)->(4).  dci: (sin θ, cos θ); qi, qo: quaternion (x, y, z, w), the scalar last.
    8 mul, 20 add, 8 product rest, 4 neg.  Error <= u |result| + 6 u^2 S, S the sum of the
    |terms| of the expanded formula; barring over- and underflow.
    """
    dci_0, dci_1 = dci
    qi_0, qi_1, qi_2, qi_3 = qi
    qo_0a = dci_0 * qi_3
    qo_0b = dci_1 * qi_0
    qo_0c = qo_0a + qo_0b
    qo_0c_right = qo_0c - qo_0a
    qo_0 = -qo_0c
    qo_1a = dci_0 * qi_2
    qo_1b = dci_1 * qi_1
    qo_1c = qo_1a + qo_1b
    qo_1c_right = qo_1c - qo_1a
    qo_1 = -qo_1c
    qo_2a = dci_0 * qi_1
    qo_2b = dci_1 * qi_2
    qo_2 = qo_2a - qo_2b
    qo_2_right = qo_2a - qo_2
    qo_3a = dci_1 * qi_3
    qo_3b = dci_0 * qi_0
    qo_3 = qo_3a - qo_3b
    qo_3_right = qo_3a - qo_3
    qo_0_rounded = (qo_0 +
        -(product_rest(dci_0, qi_3, qo_0a, qo_0c - qo_0c_right)
        + product_rest(dci_1, qi_0, qo_0b, qo_0c_right)))
    qo_1_rounded = (qo_1 +
        -(product_rest(dci_0, qi_2, qo_1a, qo_1c - qo_1c_right)
        + product_rest(dci_1, qi_1, qo_1b, qo_1c_right)))
    qo_2_rounded = (qo_2
        + (product_rest(dci_0, qi_1, qo_2a, qo_2 + qo_2_right)
        - product_rest(dci_1, qi_2, qo_2b, qo_2_right)))
    qo_3_rounded = (qo_3
        + (product_rest(dci_1, qi_3, qo_3a, qo_3 + qo_3_right)
        - product_rest(dci_0, qi_0, qo_3b, qo_3_right)))
    return (qo_0_rounded, qo_1_rounded, qo_2_rounded, qo_3_rounded)


@kernel("(4),(2)->(4)")
def quaternion_product_qqx(qi, dci):
    """qo = qi (s e_x; c), dci = (s, c), sine and cosine of half the angle.

    (4),(2)->(4).  qi, qo: quaternion (x, y, z, w), the scalar last; dci: (sin θ, cos θ).
    8 mul, 20 add, 8 product rest.  Error <= u |result| + 6 u^2 S, S the sum of the |terms| of
    the expanded formula; barring over- and underflow.
    """
    qi_0, qi_1, qi_2, qi_3 = qi
    dci_0, dci_1 = dci
    qo_0a = qi_0 * dci_1
    qo_0b = qi_3 * dci_0
    qo_0 = qo_0a + qo_0b
    qo_0_right = qo_0 - qo_0a
    qo_1a = qi_1 * dci_1
    qo_1b = qi_2 * dci_0
    qo_1 = qo_1a + qo_1b
    qo_1_right = qo_1 - qo_1a
    qo_2a = qi_2 * dci_1
    qo_2b = qi_1 * dci_0
    qo_2 = qo_2a - qo_2b
    qo_2_right = qo_2a - qo_2
    qo_3a = qi_3 * dci_1
    qo_3b = qi_0 * dci_0
    qo_3 = qo_3a - qo_3b
    qo_3_right = qo_3a - qo_3
    qo_0_rounded = (qo_0
        + (product_rest(qi_0, dci_1, qo_0a, qo_0 - qo_0_right)
        + product_rest(qi_3, dci_0, qo_0b, qo_0_right)))
    qo_1_rounded = (qo_1
        + (product_rest(qi_1, dci_1, qo_1a, qo_1 - qo_1_right)
        + product_rest(qi_2, dci_0, qo_1b, qo_1_right)))
    qo_2_rounded = (qo_2
        + (product_rest(qi_2, dci_1, qo_2a, qo_2 + qo_2_right)
        - product_rest(qi_1, dci_0, qo_2b, qo_2_right)))
    qo_3_rounded = (qo_3
        + (product_rest(qi_3, dci_1, qo_3a, qo_3 + qo_3_right)
        - product_rest(qi_0, dci_0, qo_3b, qo_3_right)))
    return (qo_0_rounded, qo_1_rounded, qo_2_rounded, qo_3_rounded)


@kernel("(4),(2)->(4)")
def quaternion_product_qqxconj(qi, dci):
    """qo = qi (s e_x; c)*, dci = (s, c), sine and cosine of half the angle.

    (4),(2)->(4).  qi, qo: quaternion (x, y, z, w), the scalar last; dci: (sin θ, cos θ).
    8 mul, 20 add, 8 product rest.  Error <= u |result| + 6 u^2 S, S the sum of the |terms| of
    the expanded formula; barring over- and underflow.
    """
    qi_0, qi_1, qi_2, qi_3 = qi
    dci_0, dci_1 = dci
    qo_0a = qi_0 * dci_1
    qo_0b = qi_3 * dci_0
    qo_0 = qo_0a - qo_0b
    qo_0_right = qo_0a - qo_0
    qo_1a = qi_1 * dci_1
    qo_1b = qi_2 * dci_0
    qo_1 = qo_1a - qo_1b
    qo_1_right = qo_1a - qo_1
    qo_2a = qi_1 * dci_0
    qo_2b = qi_2 * dci_1
    qo_2 = qo_2a + qo_2b
    qo_2_right = qo_2 - qo_2a
    qo_3a = qi_0 * dci_0
    qo_3b = qi_3 * dci_1
    qo_3 = qo_3a + qo_3b
    qo_3_right = qo_3 - qo_3a
    qo_0_rounded = (qo_0
        + (product_rest(qi_0, dci_1, qo_0a, qo_0 + qo_0_right)
        - product_rest(qi_3, dci_0, qo_0b, qo_0_right)))
    qo_1_rounded = (qo_1
        + (product_rest(qi_1, dci_1, qo_1a, qo_1 + qo_1_right)
        - product_rest(qi_2, dci_0, qo_1b, qo_1_right)))
    qo_2_rounded = (qo_2
        + (product_rest(qi_1, dci_0, qo_2a, qo_2 - qo_2_right)
        + product_rest(qi_2, dci_1, qo_2b, qo_2_right)))
    qo_3_rounded = (qo_3
        + (product_rest(qi_0, dci_0, qo_3a, qo_3 - qo_3_right)
        + product_rest(qi_3, dci_1, qo_3b, qo_3_right)))
    return (qo_0_rounded, qo_1_rounded, qo_2_rounded, qo_3_rounded)


@kernel("(4),(2)->(4)")
def quaternion_product_qconjqx(qi, dci):
    """qo = qi* (s e_x; c), dci = (s, c), sine and cosine of half the angle.

    (4),(2)->(4).  qi, qo: quaternion (x, y, z, w), the scalar last; dci: (sin θ, cos θ).
    8 mul, 20 add, 8 product rest, 2 neg.  Error <= u |result| + 6 u^2 S, S the sum of the
    |terms| of the expanded formula; barring over- and underflow.
    """
    qi_0, qi_1, qi_2, qi_3 = qi
    dci_0, dci_1 = dci
    qo_0a = qi_3 * dci_0
    qo_0b = qi_0 * dci_1
    qo_0 = qo_0a - qo_0b
    qo_0_right = qo_0a - qo_0
    qo_1a = qi_1 * dci_1
    qo_1b = qi_2 * dci_0
    qo_1c = qo_1a + qo_1b
    qo_1c_right = qo_1c - qo_1a
    qo_1 = -qo_1c
    qo_2a = qi_1 * dci_0
    qo_2b = qi_2 * dci_1
    qo_2 = qo_2a - qo_2b
    qo_2_right = qo_2a - qo_2
    qo_3a = qi_0 * dci_0
    qo_3b = qi_3 * dci_1
    qo_3 = qo_3a + qo_3b
    qo_3_right = qo_3 - qo_3a
    qo_0_rounded = (qo_0
        + (product_rest(qi_3, dci_0, qo_0a, qo_0 + qo_0_right)
        - product_rest(qi_0, dci_1, qo_0b, qo_0_right)))
    qo_1_rounded = (qo_1 +
        -(product_rest(qi_1, dci_1, qo_1a, qo_1c - qo_1c_right)
        + product_rest(qi_2, dci_0, qo_1b, qo_1c_right)))
    qo_2_rounded = (qo_2
        + (product_rest(qi_1, dci_0, qo_2a, qo_2 + qo_2_right)
        - product_rest(qi_2, dci_1, qo_2b, qo_2_right)))
    qo_3_rounded = (qo_3
        + (product_rest(qi_0, dci_0, qo_3a, qo_3 - qo_3_right)
        + product_rest(qi_3, dci_1, qo_3b, qo_3_right)))
    return (qo_0_rounded, qo_1_rounded, qo_2_rounded, qo_3_rounded)


@kernel("(4),(2)->(4)")
def quaternion_product_qconjqxconj(qi, dci):
    """qo = qi* (s e_x; c)*, dci = (s, c), sine and cosine of half the angle.

    (4),(2)->(4).  qi, qo: quaternion (x, y, z, w), the scalar last; dci: (sin θ, cos θ).
    8 mul, 20 add, 8 product rest, 4 neg.  Error <= u |result| + 6 u^2 S, S the sum of the
    |terms| of the expanded formula; barring over- and underflow.
    """
    qi_0, qi_1, qi_2, qi_3 = qi
    dci_0, dci_1 = dci
    qo_0a = qi_0 * dci_1
    qo_0b = qi_3 * dci_0
    qo_0c = qo_0a + qo_0b
    qo_0c_right = qo_0c - qo_0a
    qo_0 = -qo_0c
    qo_1a = qi_2 * dci_0
    qo_1b = qi_1 * dci_1
    qo_1 = qo_1a - qo_1b
    qo_1_right = qo_1a - qo_1
    qo_2a = qi_1 * dci_0
    qo_2b = qi_2 * dci_1
    qo_2c = qo_2a + qo_2b
    qo_2c_right = qo_2c - qo_2a
    qo_2 = -qo_2c
    qo_3a = qi_3 * dci_1
    qo_3b = qi_0 * dci_0
    qo_3 = qo_3a - qo_3b
    qo_3_right = qo_3a - qo_3
    qo_0_rounded = (qo_0 +
        -(product_rest(qi_0, dci_1, qo_0a, qo_0c - qo_0c_right)
        + product_rest(qi_3, dci_0, qo_0b, qo_0c_right)))
    qo_1_rounded = (qo_1
        + (product_rest(qi_2, dci_0, qo_1a, qo_1 + qo_1_right)
        - product_rest(qi_1, dci_1, qo_1b, qo_1_right)))
    qo_2_rounded = (qo_2 +
        -(product_rest(qi_1, dci_0, qo_2a, qo_2c - qo_2c_right)
        + product_rest(qi_2, dci_1, qo_2b, qo_2c_right)))
    qo_3_rounded = (qo_3
        + (product_rest(qi_3, dci_1, qo_3a, qo_3 + qo_3_right)
        - product_rest(qi_0, dci_0, qo_3b, qo_3_right)))
    return (qo_0_rounded, qo_1_rounded, qo_2_rounded, qo_3_rounded)


@kernel("(2),(4)->(4)")
def quaternion_product_qyq(dci, qi):
    """qo = (s e_y; c) qi, dci = (s, c), sine and cosine of half the angle.

    (2),(4)->(4).  dci: (sin θ, cos θ); qi, qo: quaternion (x, y, z, w), the scalar last.
    8 mul, 20 add, 8 product rest.  Error <= u |result| + 6 u^2 S, S the sum of the |terms| of
    the expanded formula; barring over- and underflow.
    """
    dci_0, dci_1 = dci
    qi_0, qi_1, qi_2, qi_3 = qi
    qo_0a = dci_0 * qi_2
    qo_0b = dci_1 * qi_0
    qo_0 = qo_0a + qo_0b
    qo_0_right = qo_0 - qo_0a
    qo_1a = dci_0 * qi_3
    qo_1b = dci_1 * qi_1
    qo_1 = qo_1a + qo_1b
    qo_1_right = qo_1 - qo_1a
    qo_2a = dci_1 * qi_2
    qo_2b = dci_0 * qi_0
    qo_2 = qo_2a - qo_2b
    qo_2_right = qo_2a - qo_2
    qo_3a = dci_1 * qi_3
    qo_3b = dci_0 * qi_1
    qo_3 = qo_3a - qo_3b
    qo_3_right = qo_3a - qo_3
    qo_0_rounded = (qo_0
        + (product_rest(dci_0, qi_2, qo_0a, qo_0 - qo_0_right)
        + product_rest(dci_1, qi_0, qo_0b, qo_0_right)))
    qo_1_rounded = (qo_1
        + (product_rest(dci_0, qi_3, qo_1a, qo_1 - qo_1_right)
        + product_rest(dci_1, qi_1, qo_1b, qo_1_right)))
    qo_2_rounded = (qo_2
        + (product_rest(dci_1, qi_2, qo_2a, qo_2 + qo_2_right)
        - product_rest(dci_0, qi_0, qo_2b, qo_2_right)))
    qo_3_rounded = (qo_3
        + (product_rest(dci_1, qi_3, qo_3a, qo_3 + qo_3_right)
        - product_rest(dci_0, qi_1, qo_3b, qo_3_right)))
    return (qo_0_rounded, qo_1_rounded, qo_2_rounded, qo_3_rounded)


@kernel("(2),(4)->(4)")
def quaternion_product_qyqconj(dci, qi):
    """qo = (s e_y; c) qi*, dci = (s, c), sine and cosine of half the angle.

    (2),(4)->(4).  dci: (sin θ, cos θ); qi, qo: quaternion (x, y, z, w), the scalar last.
    8 mul, 20 add, 8 product rest, 2 neg.  Error <= u |result| + 6 u^2 S, S the sum of the
    |terms| of the expanded formula; barring over- and underflow.
    """
    dci_0, dci_1 = dci
    qi_0, qi_1, qi_2, qi_3 = qi
    qo_0a = dci_0 * qi_2
    qo_0b = dci_1 * qi_0
    qo_0c = qo_0a + qo_0b
    qo_0c_right = qo_0c - qo_0a
    qo_0 = -qo_0c
    qo_1a = dci_0 * qi_3
    qo_1b = dci_1 * qi_1
    qo_1 = qo_1a - qo_1b
    qo_1_right = qo_1a - qo_1
    qo_2a = dci_0 * qi_0
    qo_2b = dci_1 * qi_2
    qo_2 = qo_2a - qo_2b
    qo_2_right = qo_2a - qo_2
    qo_3a = dci_0 * qi_1
    qo_3b = dci_1 * qi_3
    qo_3 = qo_3a + qo_3b
    qo_3_right = qo_3 - qo_3a
    qo_0_rounded = (qo_0 +
        -(product_rest(dci_0, qi_2, qo_0a, qo_0c - qo_0c_right)
        + product_rest(dci_1, qi_0, qo_0b, qo_0c_right)))
    qo_1_rounded = (qo_1
        + (product_rest(dci_0, qi_3, qo_1a, qo_1 + qo_1_right)
        - product_rest(dci_1, qi_1, qo_1b, qo_1_right)))
    qo_2_rounded = (qo_2
        + (product_rest(dci_0, qi_0, qo_2a, qo_2 + qo_2_right)
        - product_rest(dci_1, qi_2, qo_2b, qo_2_right)))
    qo_3_rounded = (qo_3
        + (product_rest(dci_0, qi_1, qo_3a, qo_3 - qo_3_right)
        + product_rest(dci_1, qi_3, qo_3b, qo_3_right)))
    return (qo_0_rounded, qo_1_rounded, qo_2_rounded, qo_3_rounded)


@kernel("(2),(4)->(4)")
def quaternion_product_qyconjq(dci, qi):
    """qo = (s e_y; c)* qi, dci = (s, c), sine and cosine of half the angle.

    (2),(4)->(4).  dci: (sin θ, cos θ); qi, qo: quaternion (x, y, z, w), the scalar last.
    8 mul, 20 add, 8 product rest.  Error <= u |result| + 6 u^2 S, S the sum of the |terms| of
    the expanded formula; barring over- and underflow.
    """
    dci_0, dci_1 = dci
    qi_0, qi_1, qi_2, qi_3 = qi
    qo_0a = dci_1 * qi_0
    qo_0b = dci_0 * qi_2
    qo_0 = qo_0a - qo_0b
    qo_0_right = qo_0a - qo_0
    qo_1a = dci_1 * qi_1
    qo_1b = dci_0 * qi_3
    qo_1 = qo_1a - qo_1b
    qo_1_right = qo_1a - qo_1
    qo_2a = dci_0 * qi_0
    qo_2b = dci_1 * qi_2
    qo_2 = qo_2a + qo_2b
    qo_2_right = qo_2 - qo_2a
    qo_3a = dci_0 * qi_1
    qo_3b = dci_1 * qi_3
    qo_3 = qo_3a + qo_3b
    qo_3_right = qo_3 - qo_3a
    qo_0_rounded = (qo_0
        + (product_rest(dci_1, qi_0, qo_0a, qo_0 + qo_0_right)
        - product_rest(dci_0, qi_2, qo_0b, qo_0_right)))
    qo_1_rounded = (qo_1
        + (product_rest(dci_1, qi_1, qo_1a, qo_1 + qo_1_right)
        - product_rest(dci_0, qi_3, qo_1b, qo_1_right)))
    qo_2_rounded = (qo_2
        + (product_rest(dci_0, qi_0, qo_2a, qo_2 - qo_2_right)
        + product_rest(dci_1, qi_2, qo_2b, qo_2_right)))
    qo_3_rounded = (qo_3
        + (product_rest(dci_0, qi_1, qo_3a, qo_3 - qo_3_right)
        + product_rest(dci_1, qi_3, qo_3b, qo_3_right)))
    return (qo_0_rounded, qo_1_rounded, qo_2_rounded, qo_3_rounded)


@kernel("(2),(4)->(4)")
def quaternion_product_qyconjqconj(dci, qi):
    """qo = (s e_y; c)* qi*, dci = (s, c), sine and cosine of half the angle.

    (2),(4)->(4).  dci: (sin θ, cos θ); qi, qo: quaternion (x, y, z, w), the scalar last.
    8 mul, 20 add, 8 product rest, 4 neg.  Error <= u |result| + 6 u^2 S, S the sum of the
    |terms| of the expanded formula; barring over- and underflow.
    """
    dci_0, dci_1 = dci
    qi_0, qi_1, qi_2, qi_3 = qi
    qo_0a = dci_0 * qi_2
    qo_0b = dci_1 * qi_0
    qo_0 = qo_0a - qo_0b
    qo_0_right = qo_0a - qo_0
    qo_1a = dci_0 * qi_3
    qo_1b = dci_1 * qi_1
    qo_1c = qo_1a + qo_1b
    qo_1c_right = qo_1c - qo_1a
    qo_1 = -qo_1c
    qo_2a = dci_0 * qi_0
    qo_2b = dci_1 * qi_2
    qo_2c = qo_2a + qo_2b
    qo_2c_right = qo_2c - qo_2a
    qo_2 = -qo_2c
    qo_3a = dci_1 * qi_3
    qo_3b = dci_0 * qi_1
    qo_3 = qo_3a - qo_3b
    qo_3_right = qo_3a - qo_3
    qo_0_rounded = (qo_0
        + (product_rest(dci_0, qi_2, qo_0a, qo_0 + qo_0_right)
        - product_rest(dci_1, qi_0, qo_0b, qo_0_right)))
    qo_1_rounded = (qo_1 +
        -(product_rest(dci_0, qi_3, qo_1a, qo_1c - qo_1c_right)
        + product_rest(dci_1, qi_1, qo_1b, qo_1c_right)))
    qo_2_rounded = (qo_2 +
        -(product_rest(dci_0, qi_0, qo_2a, qo_2c - qo_2c_right)
        + product_rest(dci_1, qi_2, qo_2b, qo_2c_right)))
    qo_3_rounded = (qo_3
        + (product_rest(dci_1, qi_3, qo_3a, qo_3 + qo_3_right)
        - product_rest(dci_0, qi_1, qo_3b, qo_3_right)))
    return (qo_0_rounded, qo_1_rounded, qo_2_rounded, qo_3_rounded)


@kernel("(4),(2)->(4)")
def quaternion_product_qqy(qi, dci):
    """qo = qi (s e_y; c), dci = (s, c), sine and cosine of half the angle.

    (4),(2)->(4).  qi, qo: quaternion (x, y, z, w), the scalar last; dci: (sin θ, cos θ).
    8 mul, 20 add, 8 product rest.  Error <= u |result| + 6 u^2 S, S the sum of the |terms| of
    the expanded formula; barring over- and underflow.
    """
    qi_0, qi_1, qi_2, qi_3 = qi
    dci_0, dci_1 = dci
    qo_0a = qi_0 * dci_1
    qo_0b = qi_2 * dci_0
    qo_0 = qo_0a - qo_0b
    qo_0_right = qo_0a - qo_0
    qo_1a = qi_1 * dci_1
    qo_1b = qi_3 * dci_0
    qo_1 = qo_1a + qo_1b
    qo_1_right = qo_1 - qo_1a
    qo_2a = qi_0 * dci_0
    qo_2b = qi_2 * dci_1
    qo_2 = qo_2a + qo_2b
    qo_2_right = qo_2 - qo_2a
    qo_3a = qi_3 * dci_1
    qo_3b = qi_1 * dci_0
    qo_3 = qo_3a - qo_3b
    qo_3_right = qo_3a - qo_3
    qo_0_rounded = (qo_0
        + (product_rest(qi_0, dci_1, qo_0a, qo_0 + qo_0_right)
        - product_rest(qi_2, dci_0, qo_0b, qo_0_right)))
    qo_1_rounded = (qo_1
        + (product_rest(qi_1, dci_1, qo_1a, qo_1 - qo_1_right)
        + product_rest(qi_3, dci_0, qo_1b, qo_1_right)))
    qo_2_rounded = (qo_2
        + (product_rest(qi_0, dci_0, qo_2a, qo_2 - qo_2_right)
        + product_rest(qi_2, dci_1, qo_2b, qo_2_right)))
    qo_3_rounded = (qo_3
        + (product_rest(qi_3, dci_1, qo_3a, qo_3 + qo_3_right)
        - product_rest(qi_1, dci_0, qo_3b, qo_3_right)))
    return (qo_0_rounded, qo_1_rounded, qo_2_rounded, qo_3_rounded)


@kernel("(4),(2)->(4)")
def quaternion_product_qqyconj(qi, dci):
    """qo = qi (s e_y; c)*, dci = (s, c), sine and cosine of half the angle.

    (4),(2)->(4).  qi, qo: quaternion (x, y, z, w), the scalar last; dci: (sin θ, cos θ).
    8 mul, 20 add, 8 product rest.  Error <= u |result| + 6 u^2 S, S the sum of the |terms| of
    the expanded formula; barring over- and underflow.
    """
    qi_0, qi_1, qi_2, qi_3 = qi
    dci_0, dci_1 = dci
    qo_0a = qi_0 * dci_1
    qo_0b = qi_2 * dci_0
    qo_0 = qo_0a + qo_0b
    qo_0_right = qo_0 - qo_0a
    qo_1a = qi_1 * dci_1
    qo_1b = qi_3 * dci_0
    qo_1 = qo_1a - qo_1b
    qo_1_right = qo_1a - qo_1
    qo_2a = qi_2 * dci_1
    qo_2b = qi_0 * dci_0
    qo_2 = qo_2a - qo_2b
    qo_2_right = qo_2a - qo_2
    qo_3a = qi_1 * dci_0
    qo_3b = qi_3 * dci_1
    qo_3 = qo_3a + qo_3b
    qo_3_right = qo_3 - qo_3a
    qo_0_rounded = (qo_0
        + (product_rest(qi_0, dci_1, qo_0a, qo_0 - qo_0_right)
        + product_rest(qi_2, dci_0, qo_0b, qo_0_right)))
    qo_1_rounded = (qo_1
        + (product_rest(qi_1, dci_1, qo_1a, qo_1 + qo_1_right)
        - product_rest(qi_3, dci_0, qo_1b, qo_1_right)))
    qo_2_rounded = (qo_2
        + (product_rest(qi_2, dci_1, qo_2a, qo_2 + qo_2_right)
        - product_rest(qi_0, dci_0, qo_2b, qo_2_right)))
    qo_3_rounded = (qo_3
        + (product_rest(qi_1, dci_0, qo_3a, qo_3 - qo_3_right)
        + product_rest(qi_3, dci_1, qo_3b, qo_3_right)))
    return (qo_0_rounded, qo_1_rounded, qo_2_rounded, qo_3_rounded)


@kernel("(4),(2)->(4)")
def quaternion_product_qconjqy(qi, dci):
    """qo = qi* (s e_y; c), dci = (s, c), sine and cosine of half the angle.

    (4),(2)->(4).  qi, qo: quaternion (x, y, z, w), the scalar last; dci: (sin θ, cos θ).
    8 mul, 20 add, 8 product rest, 2 neg.  Error <= u |result| + 6 u^2 S, S the sum of the
    |terms| of the expanded formula; barring over- and underflow.
    """
    qi_0, qi_1, qi_2, qi_3 = qi
    dci_0, dci_1 = dci
    qo_0a = qi_2 * dci_0
    qo_0b = qi_0 * dci_1
    qo_0 = qo_0a - qo_0b
    qo_0_right = qo_0a - qo_0
    qo_1a = qi_3 * dci_0
    qo_1b = qi_1 * dci_1
    qo_1 = qo_1a - qo_1b
    qo_1_right = qo_1a - qo_1
    qo_2a = qi_0 * dci_0
    qo_2b = qi_2 * dci_1
    qo_2c = qo_2a + qo_2b
    qo_2c_right = qo_2c - qo_2a
    qo_2 = -qo_2c
    qo_3a = qi_1 * dci_0
    qo_3b = qi_3 * dci_1
    qo_3 = qo_3a + qo_3b
    qo_3_right = qo_3 - qo_3a
    qo_0_rounded = (qo_0
        + (product_rest(qi_2, dci_0, qo_0a, qo_0 + qo_0_right)
        - product_rest(qi_0, dci_1, qo_0b, qo_0_right)))
    qo_1_rounded = (qo_1
        + (product_rest(qi_3, dci_0, qo_1a, qo_1 + qo_1_right)
        - product_rest(qi_1, dci_1, qo_1b, qo_1_right)))
    qo_2_rounded = (qo_2 +
        -(product_rest(qi_0, dci_0, qo_2a, qo_2c - qo_2c_right)
        + product_rest(qi_2, dci_1, qo_2b, qo_2c_right)))
    qo_3_rounded = (qo_3
        + (product_rest(qi_1, dci_0, qo_3a, qo_3 - qo_3_right)
        + product_rest(qi_3, dci_1, qo_3b, qo_3_right)))
    return (qo_0_rounded, qo_1_rounded, qo_2_rounded, qo_3_rounded)


@kernel("(4),(2)->(4)")
def quaternion_product_qconjqyconj(qi, dci):
    """qo = qi* (s e_y; c)*, dci = (s, c), sine and cosine of half the angle.

    (4),(2)->(4).  qi, qo: quaternion (x, y, z, w), the scalar last; dci: (sin θ, cos θ).
    8 mul, 20 add, 8 product rest, 4 neg.  Error <= u |result| + 6 u^2 S, S the sum of the
    |terms| of the expanded formula; barring over- and underflow.
    """
    qi_0, qi_1, qi_2, qi_3 = qi
    dci_0, dci_1 = dci
    qo_0a = qi_0 * dci_1
    qo_0b = qi_2 * dci_0
    qo_0c = qo_0a + qo_0b
    qo_0c_right = qo_0c - qo_0a
    qo_0 = -qo_0c
    qo_1a = qi_1 * dci_1
    qo_1b = qi_3 * dci_0
    qo_1c = qo_1a + qo_1b
    qo_1c_right = qo_1c - qo_1a
    qo_1 = -qo_1c
    qo_2a = qi_0 * dci_0
    qo_2b = qi_2 * dci_1
    qo_2 = qo_2a - qo_2b
    qo_2_right = qo_2a - qo_2
    qo_3a = qi_3 * dci_1
    qo_3b = qi_1 * dci_0
    qo_3 = qo_3a - qo_3b
    qo_3_right = qo_3a - qo_3
    qo_0_rounded = (qo_0 +
        -(product_rest(qi_0, dci_1, qo_0a, qo_0c - qo_0c_right)
        + product_rest(qi_2, dci_0, qo_0b, qo_0c_right)))
    qo_1_rounded = (qo_1 +
        -(product_rest(qi_1, dci_1, qo_1a, qo_1c - qo_1c_right)
        + product_rest(qi_3, dci_0, qo_1b, qo_1c_right)))
    qo_2_rounded = (qo_2
        + (product_rest(qi_0, dci_0, qo_2a, qo_2 + qo_2_right)
        - product_rest(qi_2, dci_1, qo_2b, qo_2_right)))
    qo_3_rounded = (qo_3
        + (product_rest(qi_3, dci_1, qo_3a, qo_3 + qo_3_right)
        - product_rest(qi_1, dci_0, qo_3b, qo_3_right)))
    return (qo_0_rounded, qo_1_rounded, qo_2_rounded, qo_3_rounded)


@kernel("(2),(4)->(4)")
def quaternion_product_qzq(dci, qi):
    """qo = (s e_z; c) qi, dci = (s, c), sine and cosine of half the angle.

    (2),(4)->(4).  dci: (sin θ, cos θ); qi, qo: quaternion (x, y, z, w), the scalar last.
    8 mul, 20 add, 8 product rest.  Error <= u |result| + 6 u^2 S, S the sum of the |terms| of
    the expanded formula; barring over- and underflow.
    """
    dci_0, dci_1 = dci
    qi_0, qi_1, qi_2, qi_3 = qi
    qo_0a = dci_1 * qi_0
    qo_0b = dci_0 * qi_1
    qo_0 = qo_0a - qo_0b
    qo_0_right = qo_0a - qo_0
    qo_1a = dci_0 * qi_0
    qo_1b = dci_1 * qi_1
    qo_1 = qo_1a + qo_1b
    qo_1_right = qo_1 - qo_1a
    qo_2a = dci_0 * qi_3
    qo_2b = dci_1 * qi_2
    qo_2 = qo_2a + qo_2b
    qo_2_right = qo_2 - qo_2a
    qo_3a = dci_1 * qi_3
    qo_3b = dci_0 * qi_2
    qo_3 = qo_3a - qo_3b
    qo_3_right = qo_3a - qo_3
    qo_0_rounded = (qo_0
        + (product_rest(dci_1, qi_0, qo_0a, qo_0 + qo_0_right)
        - product_rest(dci_0, qi_1, qo_0b, qo_0_right)))
    qo_1_rounded = (qo_1
        + (product_rest(dci_0, qi_0, qo_1a, qo_1 - qo_1_right)
        + product_rest(dci_1, qi_1, qo_1b, qo_1_right)))
    qo_2_rounded = (qo_2
        + (product_rest(dci_0, qi_3, qo_2a, qo_2 - qo_2_right)
        + product_rest(dci_1, qi_2, qo_2b, qo_2_right)))
    qo_3_rounded = (qo_3
        + (product_rest(dci_1, qi_3, qo_3a, qo_3 + qo_3_right)
        - product_rest(dci_0, qi_2, qo_3b, qo_3_right)))
    return (qo_0_rounded, qo_1_rounded, qo_2_rounded, qo_3_rounded)


@kernel("(2),(4)->(4)")
def quaternion_product_qzqconj(dci, qi):
    """qo = (s e_z; c) qi*, dci = (s, c), sine and cosine of half the angle.

    (2),(4)->(4).  dci: (sin θ, cos θ); qi, qo: quaternion (x, y, z, w), the scalar last.
    8 mul, 20 add, 8 product rest, 2 neg.  Error <= u |result| + 6 u^2 S, S the sum of the
    |terms| of the expanded formula; barring over- and underflow.
    """
    dci_0, dci_1 = dci
    qi_0, qi_1, qi_2, qi_3 = qi
    qo_0a = dci_0 * qi_1
    qo_0b = dci_1 * qi_0
    qo_0 = qo_0a - qo_0b
    qo_0_right = qo_0a - qo_0
    qo_1a = dci_0 * qi_0
    qo_1b = dci_1 * qi_1
    qo_1c = qo_1a + qo_1b
    qo_1c_right = qo_1c - qo_1a
    qo_1 = -qo_1c
    qo_2a = dci_0 * qi_3
    qo_2b = dci_1 * qi_2
    qo_2 = qo_2a - qo_2b
    qo_2_right = qo_2a - qo_2
    qo_3a = dci_0 * qi_2
    qo_3b = dci_1 * qi_3
    qo_3 = qo_3a + qo_3b
    qo_3_right = qo_3 - qo_3a
    qo_0_rounded = (qo_0
        + (product_rest(dci_0, qi_1, qo_0a, qo_0 + qo_0_right)
        - product_rest(dci_1, qi_0, qo_0b, qo_0_right)))
    qo_1_rounded = (qo_1 +
        -(product_rest(dci_0, qi_0, qo_1a, qo_1c - qo_1c_right)
        + product_rest(dci_1, qi_1, qo_1b, qo_1c_right)))
    qo_2_rounded = (qo_2
        + (product_rest(dci_0, qi_3, qo_2a, qo_2 + qo_2_right)
        - product_rest(dci_1, qi_2, qo_2b, qo_2_right)))
    qo_3_rounded = (qo_3
        + (product_rest(dci_0, qi_2, qo_3a, qo_3 - qo_3_right)
        + product_rest(dci_1, qi_3, qo_3b, qo_3_right)))
    return (qo_0_rounded, qo_1_rounded, qo_2_rounded, qo_3_rounded)


@kernel("(2),(4)->(4)")
def quaternion_product_qzconjq(dci, qi):
    """qo = (s e_z; c)* qi, dci = (s, c), sine and cosine of half the angle.

    (2),(4)->(4).  dci: (sin θ, cos θ); qi, qo: quaternion (x, y, z, w), the scalar last.
    8 mul, 20 add, 8 product rest.  Error <= u |result| + 6 u^2 S, S the sum of the |terms| of
    the expanded formula; barring over- and underflow.
    """
    dci_0, dci_1 = dci
    qi_0, qi_1, qi_2, qi_3 = qi
    qo_0a = dci_0 * qi_1
    qo_0b = dci_1 * qi_0
    qo_0 = qo_0a + qo_0b
    qo_0_right = qo_0 - qo_0a
    qo_1a = dci_1 * qi_1
    qo_1b = dci_0 * qi_0
    qo_1 = qo_1a - qo_1b
    qo_1_right = qo_1a - qo_1
    qo_2a = dci_1 * qi_2
    qo_2b = dci_0 * qi_3
    qo_2 = qo_2a - qo_2b
    qo_2_right = qo_2a - qo_2
    qo_3a = dci_0 * qi_2
    qo_3b = dci_1 * qi_3
    qo_3 = qo_3a + qo_3b
    qo_3_right = qo_3 - qo_3a
    qo_0_rounded = (qo_0
        + (product_rest(dci_0, qi_1, qo_0a, qo_0 - qo_0_right)
        + product_rest(dci_1, qi_0, qo_0b, qo_0_right)))
    qo_1_rounded = (qo_1
        + (product_rest(dci_1, qi_1, qo_1a, qo_1 + qo_1_right)
        - product_rest(dci_0, qi_0, qo_1b, qo_1_right)))
    qo_2_rounded = (qo_2
        + (product_rest(dci_1, qi_2, qo_2a, qo_2 + qo_2_right)
        - product_rest(dci_0, qi_3, qo_2b, qo_2_right)))
    qo_3_rounded = (qo_3
        + (product_rest(dci_0, qi_2, qo_3a, qo_3 - qo_3_right)
        + product_rest(dci_1, qi_3, qo_3b, qo_3_right)))
    return (qo_0_rounded, qo_1_rounded, qo_2_rounded, qo_3_rounded)


@kernel("(2),(4)->(4)")
def quaternion_product_qzconjqconj(dci, qi):
    """qo = (s e_z; c)* qi*, dci = (s, c), sine and cosine of half the angle.

    (2),(4)->(4).  dci: (sin θ, cos θ); qi, qo: quaternion (x, y, z, w), the scalar last.
    8 mul, 20 add, 8 product rest, 4 neg.  Error <= u |result| + 6 u^2 S, S the sum of the
    |terms| of the expanded formula; barring over- and underflow.
    """
    dci_0, dci_1 = dci
    qi_0, qi_1, qi_2, qi_3 = qi
    qo_0a = dci_0 * qi_1
    qo_0b = dci_1 * qi_0
    qo_0c = qo_0a + qo_0b
    qo_0c_right = qo_0c - qo_0a
    qo_0 = -qo_0c
    qo_1a = dci_0 * qi_0
    qo_1b = dci_1 * qi_1
    qo_1 = qo_1a - qo_1b
    qo_1_right = qo_1a - qo_1
    qo_2a = dci_0 * qi_3
    qo_2b = dci_1 * qi_2
    qo_2c = qo_2a + qo_2b
    qo_2c_right = qo_2c - qo_2a
    qo_2 = -qo_2c
    qo_3a = dci_1 * qi_3
    qo_3b = dci_0 * qi_2
    qo_3 = qo_3a - qo_3b
    qo_3_right = qo_3a - qo_3
    qo_0_rounded = (qo_0 +
        -(product_rest(dci_0, qi_1, qo_0a, qo_0c - qo_0c_right)
        + product_rest(dci_1, qi_0, qo_0b, qo_0c_right)))
    qo_1_rounded = (qo_1
        + (product_rest(dci_0, qi_0, qo_1a, qo_1 + qo_1_right)
        - product_rest(dci_1, qi_1, qo_1b, qo_1_right)))
    qo_2_rounded = (qo_2 +
        -(product_rest(dci_0, qi_3, qo_2a, qo_2c - qo_2c_right)
        + product_rest(dci_1, qi_2, qo_2b, qo_2c_right)))
    qo_3_rounded = (qo_3
        + (product_rest(dci_1, qi_3, qo_3a, qo_3 + qo_3_right)
        - product_rest(dci_0, qi_2, qo_3b, qo_3_right)))
    return (qo_0_rounded, qo_1_rounded, qo_2_rounded, qo_3_rounded)


@kernel("(4),(2)->(4)")
def quaternion_product_qqz(qi, dci):
    """qo = qi (s e_z; c), dci = (s, c), sine and cosine of half the angle.

    (4),(2)->(4).  qi, qo: quaternion (x, y, z, w), the scalar last; dci: (sin θ, cos θ).
    8 mul, 20 add, 8 product rest.  Error <= u |result| + 6 u^2 S, S the sum of the |terms| of
    the expanded formula; barring over- and underflow.
    """
    qi_0, qi_1, qi_2, qi_3 = qi
    dci_0, dci_1 = dci
    qo_0a = qi_0 * dci_1
    qo_0b = qi_1 * dci_0
    qo_0 = qo_0a + qo_0b
    qo_0_right = qo_0 - qo_0a
    qo_1a = qi_1 * dci_1
    qo_1b = qi_0 * dci_0
    qo_1 = qo_1a - qo_1b
    qo_1_right = qo_1a - qo_1
    qo_2a = qi_2 * dci_1
    qo_2b = qi_3 * dci_0
    qo_2 = qo_2a + qo_2b
    qo_2_right = qo_2 - qo_2a
    qo_3a = qi_3 * dci_1
    qo_3b = qi_2 * dci_0
    qo_3 = qo_3a - qo_3b
    qo_3_right = qo_3a - qo_3
    qo_0_rounded = (qo_0
        + (product_rest(qi_0, dci_1, qo_0a, qo_0 - qo_0_right)
        + product_rest(qi_1, dci_0, qo_0b, qo_0_right)))
    qo_1_rounded = (qo_1
        + (product_rest(qi_1, dci_1, qo_1a, qo_1 + qo_1_right)
        - product_rest(qi_0, dci_0, qo_1b, qo_1_right)))
    qo_2_rounded = (qo_2
        + (product_rest(qi_2, dci_1, qo_2a, qo_2 - qo_2_right)
        + product_rest(qi_3, dci_0, qo_2b, qo_2_right)))
    qo_3_rounded = (qo_3
        + (product_rest(qi_3, dci_1, qo_3a, qo_3 + qo_3_right)
        - product_rest(qi_2, dci_0, qo_3b, qo_3_right)))
    return (qo_0_rounded, qo_1_rounded, qo_2_rounded, qo_3_rounded)


@kernel("(4),(2)->(4)")
def quaternion_product_qqzconj(qi, dci):
    """qo = qi (s e_z; c)*, dci = (s, c), sine and cosine of half the angle.

    (4),(2)->(4).  qi, qo: quaternion (x, y, z, w), the scalar last; dci: (sin θ, cos θ).
    8 mul, 20 add, 8 product rest.  Error <= u |result| + 6 u^2 S, S the sum of the |terms| of
    the expanded formula; barring over- and underflow.
    """
    qi_0, qi_1, qi_2, qi_3 = qi
    dci_0, dci_1 = dci
    qo_0a = qi_0 * dci_1
    qo_0b = qi_1 * dci_0
    qo_0 = qo_0a - qo_0b
    qo_0_right = qo_0a - qo_0
    qo_1a = qi_0 * dci_0
    qo_1b = qi_1 * dci_1
    qo_1 = qo_1a + qo_1b
    qo_1_right = qo_1 - qo_1a
    qo_2a = qi_2 * dci_1
    qo_2b = qi_3 * dci_0
    qo_2 = qo_2a - qo_2b
    qo_2_right = qo_2a - qo_2
    qo_3a = qi_2 * dci_0
    qo_3b = qi_3 * dci_1
    qo_3 = qo_3a + qo_3b
    qo_3_right = qo_3 - qo_3a
    qo_0_rounded = (qo_0
        + (product_rest(qi_0, dci_1, qo_0a, qo_0 + qo_0_right)
        - product_rest(qi_1, dci_0, qo_0b, qo_0_right)))
    qo_1_rounded = (qo_1
        + (product_rest(qi_0, dci_0, qo_1a, qo_1 - qo_1_right)
        + product_rest(qi_1, dci_1, qo_1b, qo_1_right)))
    qo_2_rounded = (qo_2
        + (product_rest(qi_2, dci_1, qo_2a, qo_2 + qo_2_right)
        - product_rest(qi_3, dci_0, qo_2b, qo_2_right)))
    qo_3_rounded = (qo_3
        + (product_rest(qi_2, dci_0, qo_3a, qo_3 - qo_3_right)
        + product_rest(qi_3, dci_1, qo_3b, qo_3_right)))
    return (qo_0_rounded, qo_1_rounded, qo_2_rounded, qo_3_rounded)


@kernel("(4),(2)->(4)")
def quaternion_product_qconjqz(qi, dci):
    """qo = qi* (s e_z; c), dci = (s, c), sine and cosine of half the angle.

    (4),(2)->(4).  qi, qo: quaternion (x, y, z, w), the scalar last; dci: (sin θ, cos θ).
    8 mul, 20 add, 8 product rest, 2 neg.  Error <= u |result| + 6 u^2 S, S the sum of the
    |terms| of the expanded formula; barring over- and underflow.
    """
    qi_0, qi_1, qi_2, qi_3 = qi
    dci_0, dci_1 = dci
    qo_0a = qi_0 * dci_1
    qo_0b = qi_1 * dci_0
    qo_0c = qo_0a + qo_0b
    qo_0c_right = qo_0c - qo_0a
    qo_0 = -qo_0c
    qo_1a = qi_0 * dci_0
    qo_1b = qi_1 * dci_1
    qo_1 = qo_1a - qo_1b
    qo_1_right = qo_1a - qo_1
    qo_2a = qi_3 * dci_0
    qo_2b = qi_2 * dci_1
    qo_2 = qo_2a - qo_2b
    qo_2_right = qo_2a - qo_2
    qo_3a = qi_2 * dci_0
    qo_3b = qi_3 * dci_1
    qo_3 = qo_3a + qo_3b
    qo_3_right = qo_3 - qo_3a
    qo_0_rounded = (qo_0 +
        -(product_rest(qi_0, dci_1, qo_0a, qo_0c - qo_0c_right)
        + product_rest(qi_1, dci_0, qo_0b, qo_0c_right)))
    qo_1_rounded = (qo_1
        + (product_rest(qi_0, dci_0, qo_1a, qo_1 + qo_1_right)
        - product_rest(qi_1, dci_1, qo_1b, qo_1_right)))
    qo_2_rounded = (qo_2
        + (product_rest(qi_3, dci_0, qo_2a, qo_2 + qo_2_right)
        - product_rest(qi_2, dci_1, qo_2b, qo_2_right)))
    qo_3_rounded = (qo_3
        + (product_rest(qi_2, dci_0, qo_3a, qo_3 - qo_3_right)
        + product_rest(qi_3, dci_1, qo_3b, qo_3_right)))
    return (qo_0_rounded, qo_1_rounded, qo_2_rounded, qo_3_rounded)


@kernel("(4),(2)->(4)")
def quaternion_product_qconjqzconj(qi, dci):
    """qo = qi* (s e_z; c)*, dci = (s, c), sine and cosine of half the angle.

    (4),(2)->(4).  qi, qo: quaternion (x, y, z, w), the scalar last; dci: (sin θ, cos θ).
    8 mul, 20 add, 8 product rest, 4 neg.  Error <= u |result| + 6 u^2 S, S the sum of the
    |terms| of the expanded formula; barring over- and underflow.
    """
    qi_0, qi_1, qi_2, qi_3 = qi
    dci_0, dci_1 = dci
    qo_0a = qi_1 * dci_0
    qo_0b = qi_0 * dci_1
    qo_0 = qo_0a - qo_0b
    qo_0_right = qo_0a - qo_0
    qo_1a = qi_0 * dci_0
    qo_1b = qi_1 * dci_1
    qo_1c = qo_1a + qo_1b
    qo_1c_right = qo_1c - qo_1a
    qo_1 = -qo_1c
    qo_2a = qi_2 * dci_1
    qo_2b = qi_3 * dci_0
    qo_2c = qo_2a + qo_2b
    qo_2c_right = qo_2c - qo_2a
    qo_2 = -qo_2c
    qo_3a = qi_3 * dci_1
    qo_3b = qi_2 * dci_0
    qo_3 = qo_3a - qo_3b
    qo_3_right = qo_3a - qo_3
    qo_0_rounded = (qo_0
        + (product_rest(qi_1, dci_0, qo_0a, qo_0 + qo_0_right)
        - product_rest(qi_0, dci_1, qo_0b, qo_0_right)))
    qo_1_rounded = (qo_1 +
        -(product_rest(qi_0, dci_0, qo_1a, qo_1c - qo_1c_right)
        + product_rest(qi_1, dci_1, qo_1b, qo_1c_right)))
    qo_2_rounded = (qo_2 +
        -(product_rest(qi_2, dci_1, qo_2a, qo_2c - qo_2c_right)
        + product_rest(qi_3, dci_0, qo_2b, qo_2c_right)))
    qo_3_rounded = (qo_3
        + (product_rest(qi_3, dci_1, qo_3a, qo_3 + qo_3_right)
        - product_rest(qi_2, dci_0, qo_3b, qo_3_right)))
    return (qo_0_rounded, qo_1_rounded, qo_2_rounded, qo_3_rounded)


@kernel("(4),(3)->(4)")
def quaternion_product_qv(qi, vi):
    """qo = qi (vi; 0).

    (4),(3)->(4).  qi, qo: quaternion (x, y, z, w), the scalar last; vi: vector.
    12 mul, 44 add, 12 product rest, 2 neg.  Error <= u |result| + 11 u^2 S, S the sum of the
    |terms| of the expanded formula; barring over- and underflow.
    """
    qi_0, qi_1, qi_2, qi_3 = qi
    vi_0, vi_1, vi_2 = vi
    qo_0a = qi_1 * vi_2
    qo_0b = qi_2 * vi_1
    qo_0c = qo_0a - qo_0b
    qo_0c_right = qo_0a - qo_0c
    qo_0d = qi_3 * vi_0
    qo_0 = qo_0c + qo_0d
    qo_0_right = qo_0 - qo_0c
    qo_0c_lo = (product_rest(qi_1, vi_2, qo_0a, qo_0c + qo_0c_right)
        - product_rest(qi_2, vi_1, qo_0b, qo_0c_right))
    qo_1a = qi_2 * vi_0
    qo_1b = qi_0 * vi_2
    qo_1c = qo_1a - qo_1b
    qo_1c_right = qo_1a - qo_1c
    qo_1d = qi_3 * vi_1
    qo_1 = qo_1c + qo_1d
    qo_1_right = qo_1 - qo_1c
    qo_1c_lo = (product_rest(qi_2, vi_0, qo_1a, qo_1c + qo_1c_right)
        - product_rest(qi_0, vi_2, qo_1b, qo_1c_right))
    qo_2a = qi_0 * vi_1
    qo_2b = qi_1 * vi_0
    qo_2c = qo_2a - qo_2b
    qo_2c_right = qo_2a - qo_2c
    qo_2d = qi_3 * vi_2
    qo_2 = qo_2c + qo_2d
    qo_2_right = qo_2 - qo_2c
    qo_2c_lo = (product_rest(qi_0, vi_1, qo_2a, qo_2c + qo_2c_right)
        - product_rest(qi_1, vi_0, qo_2b, qo_2c_right))
    qo_3a = qi_0 * vi_0
    qo_3b = qi_1 * vi_1
    qo_3c = qo_3a + qo_3b
    qo_3c_right = qo_3c - qo_3a
    qo_3d = qi_2 * vi_2
    qo_3e = qo_3c + qo_3d
    qo_3e_right = qo_3e - qo_3c
    qo_3c_lo = (product_rest(qi_0, vi_0, qo_3a, qo_3c - qo_3c_right)
        + product_rest(qi_1, vi_1, qo_3b, qo_3c_right))
    qo_3 = -qo_3e
    qo_0_rounded = (qo_0
        + (qo_0c - (qo_0 - qo_0_right) + product_rest(qi_3, vi_0, qo_0d, qo_0_right) + qo_0c_lo))
    qo_1_rounded = (qo_1
        + (qo_1c - (qo_1 - qo_1_right) + product_rest(qi_3, vi_1, qo_1d, qo_1_right) + qo_1c_lo))
    qo_2_rounded = (qo_2
        + (qo_2c - (qo_2 - qo_2_right) + product_rest(qi_3, vi_2, qo_2d, qo_2_right) + qo_2c_lo))
    qo_3_rounded = (qo_3 +
        -(qo_3c - (qo_3e - qo_3e_right) + product_rest(qi_2, vi_2, qo_3d, qo_3e_right) + qo_3c_lo))
    return (qo_0_rounded, qo_1_rounded, qo_2_rounded, qo_3_rounded)


@kernel("(4),(3)->(4)")
def quaternion_product_qconjv(qi, vi):
    """qo = qi* (vi; 0).

    (4),(3)->(4).  qi, qo: quaternion (x, y, z, w), the scalar last; vi: vector.
    12 mul, 44 add, 12 product rest.  Error <= u |result| + 11 u^2 S, S the sum of the |terms|
    of the expanded formula; barring over- and underflow.
    """
    qi_0, qi_1, qi_2, qi_3 = qi
    vi_0, vi_1, vi_2 = vi
    qo_0a = qi_2 * vi_1
    qo_0b = qi_1 * vi_2
    qo_0c = qo_0a - qo_0b
    qo_0c_right = qo_0a - qo_0c
    qo_0d = qi_3 * vi_0
    qo_0 = qo_0c + qo_0d
    qo_0_right = qo_0 - qo_0c
    qo_0c_lo = (product_rest(qi_2, vi_1, qo_0a, qo_0c + qo_0c_right)
        - product_rest(qi_1, vi_2, qo_0b, qo_0c_right))
    qo_1a = qi_0 * vi_2
    qo_1b = qi_2 * vi_0
    qo_1c = qo_1a - qo_1b
    qo_1c_right = qo_1a - qo_1c
    qo_1d = qi_3 * vi_1
    qo_1 = qo_1c + qo_1d
    qo_1_right = qo_1 - qo_1c
    qo_1c_lo = (product_rest(qi_0, vi_2, qo_1a, qo_1c + qo_1c_right)
        - product_rest(qi_2, vi_0, qo_1b, qo_1c_right))
    qo_2a = qi_1 * vi_0
    qo_2b = qi_0 * vi_1
    qo_2c = qo_2a - qo_2b
    qo_2c_right = qo_2a - qo_2c
    qo_2d = qi_3 * vi_2
    qo_2 = qo_2c + qo_2d
    qo_2_right = qo_2 - qo_2c
    qo_2c_lo = (product_rest(qi_1, vi_0, qo_2a, qo_2c + qo_2c_right)
        - product_rest(qi_0, vi_1, qo_2b, qo_2c_right))
    qo_3a = qi_0 * vi_0
    qo_3b = qi_1 * vi_1
    qo_3c = qo_3a + qo_3b
    qo_3c_right = qo_3c - qo_3a
    qo_3d = qi_2 * vi_2
    qo_3 = qo_3c + qo_3d
    qo_3_right = qo_3 - qo_3c
    qo_3c_lo = (product_rest(qi_0, vi_0, qo_3a, qo_3c - qo_3c_right)
        + product_rest(qi_1, vi_1, qo_3b, qo_3c_right))
    qo_0_rounded = (qo_0
        + (qo_0c - (qo_0 - qo_0_right) + product_rest(qi_3, vi_0, qo_0d, qo_0_right) + qo_0c_lo))
    qo_1_rounded = (qo_1
        + (qo_1c - (qo_1 - qo_1_right) + product_rest(qi_3, vi_1, qo_1d, qo_1_right) + qo_1c_lo))
    qo_2_rounded = (qo_2
        + (qo_2c - (qo_2 - qo_2_right) + product_rest(qi_3, vi_2, qo_2d, qo_2_right) + qo_2c_lo))
    qo_3_rounded = (qo_3
        + (qo_3c - (qo_3 - qo_3_right) + product_rest(qi_2, vi_2, qo_3d, qo_3_right) + qo_3c_lo))
    return (qo_0_rounded, qo_1_rounded, qo_2_rounded, qo_3_rounded)


@kernel("(3),(4)->(4)")
def quaternion_product_vq(vi, qi):
    """qo = (vi; 0) qi.

    (3),(4)->(4).  vi: vector; qi, qo: quaternion (x, y, z, w), the scalar last.
    12 mul, 44 add, 12 product rest, 2 neg.  Error <= u |result| + 11 u^2 S, S the sum of the
    |terms| of the expanded formula; barring over- and underflow.
    """
    vi_0, vi_1, vi_2 = vi
    qi_0, qi_1, qi_2, qi_3 = qi
    qo_0a = vi_0 * qi_3
    qo_0b = vi_1 * qi_2
    qo_0c = vi_2 * qi_1
    qo_0d = qo_0b - qo_0c
    qo_0d_right = qo_0b - qo_0d
    qo_0 = qo_0a + qo_0d
    qo_0_right = qo_0 - qo_0a
    qo_0d_lo = (product_rest(vi_1, qi_2, qo_0b, qo_0d + qo_0d_right)
        - product_rest(vi_2, qi_1, qo_0c, qo_0d_right))
    qo_1a = vi_2 * qi_0
    qo_1b = vi_0 * qi_2
    qo_1c = qo_1a - qo_1b
    qo_1c_right = qo_1a - qo_1c
    qo_1d = vi_1 * qi_3
    qo_1 = qo_1c + qo_1d
    qo_1_right = qo_1 - qo_1c
    qo_1c_lo = (product_rest(vi_2, qi_0, qo_1a, qo_1c + qo_1c_right)
        - product_rest(vi_0, qi_2, qo_1b, qo_1c_right))
    qo_2a = vi_0 * qi_1
    qo_2b = vi_1 * qi_0
    qo_2c = qo_2a - qo_2b
    qo_2c_right = qo_2a - qo_2c
    qo_2d = vi_2 * qi_3
    qo_2 = qo_2c + qo_2d
    qo_2_right = qo_2 - qo_2c
    qo_2c_lo = (product_rest(vi_0, qi_1, qo_2a, qo_2c + qo_2c_right)
        - product_rest(vi_1, qi_0, qo_2b, qo_2c_right))
    qo_3a = vi_0 * qi_0
    qo_3b = vi_1 * qi_1
    qo_3c = qo_3a + qo_3b
    qo_3c_right = qo_3c - qo_3a
    qo_3d = vi_2 * qi_2
    qo_3e = qo_3c + qo_3d
    qo_3e_right = qo_3e - qo_3c
    qo_3c_lo = (product_rest(vi_0, qi_0, qo_3a, qo_3c - qo_3c_right)
        + product_rest(vi_1, qi_1, qo_3b, qo_3c_right))
    qo_3 = -qo_3e
    qo_0_rounded = (qo_0
        + (product_rest(vi_0, qi_3, qo_0a, qo_0 - qo_0_right) + (qo_0d - qo_0_right) + qo_0d_lo))
    qo_1_rounded = (qo_1
        + (qo_1c - (qo_1 - qo_1_right) + product_rest(vi_1, qi_3, qo_1d, qo_1_right) + qo_1c_lo))
    qo_2_rounded = (qo_2
        + (qo_2c - (qo_2 - qo_2_right) + product_rest(vi_2, qi_3, qo_2d, qo_2_right) + qo_2c_lo))
    qo_3_rounded = (qo_3 +
        -(qo_3c - (qo_3e - qo_3e_right) + product_rest(vi_2, qi_2, qo_3d, qo_3e_right) + qo_3c_lo))
    return (qo_0_rounded, qo_1_rounded, qo_2_rounded, qo_3_rounded)


@kernel("(3),(4)->(4)")
def quaternion_product_vqconj(vi, qi):
    """qo = (vi; 0) qi*.

    (3),(4)->(4).  vi: vector; qi, qo: quaternion (x, y, z, w), the scalar last.
    12 mul, 44 add, 12 product rest.  Error <= u |result| + 11 u^2 S, S the sum of the |terms|
    of the expanded formula; barring over- and underflow.
    """
    vi_0, vi_1, vi_2 = vi
    qi_0, qi_1, qi_2, qi_3 = qi
    qo_0a = vi_0 * qi_3
    qo_0b = vi_2 * qi_1
    qo_0c = vi_1 * qi_2
    qo_0d = qo_0b - qo_0c
    qo_0d_right = qo_0b - qo_0d
    qo_0 = qo_0a + qo_0d
    qo_0_right = qo_0 - qo_0a
    qo_0d_lo = (product_rest(vi_2, qi_1, qo_0b, qo_0d + qo_0d_right)
        - product_rest(vi_1, qi_2, qo_0c, qo_0d_right))
    qo_1a = vi_0 * qi_2
    qo_1b = vi_2 * qi_0
    qo_1c = qo_1a - qo_1b
    qo_1c_right = qo_1a - qo_1c
    qo_1d = vi_1 * qi_3
    qo_1 = qo_1c + qo_1d
    qo_1_right = qo_1 - qo_1c
    qo_1c_lo = (product_rest(vi_0, qi_2, qo_1a, qo_1c + qo_1c_right)
        - product_rest(vi_2, qi_0, qo_1b, qo_1c_right))
    qo_2a = vi_1 * qi_0
    qo_2b = vi_0 * qi_1
    qo_2c = qo_2a - qo_2b
    qo_2c_right = qo_2a - qo_2c
    qo_2d = vi_2 * qi_3
    qo_2 = qo_2c + qo_2d
    qo_2_right = qo_2 - qo_2c
    qo_2c_lo = (product_rest(vi_1, qi_0, qo_2a, qo_2c + qo_2c_right)
        - product_rest(vi_0, qi_1, qo_2b, qo_2c_right))
    qo_3a = vi_0 * qi_0
    qo_3b = vi_1 * qi_1
    qo_3c = qo_3a + qo_3b
    qo_3c_right = qo_3c - qo_3a
    qo_3d = vi_2 * qi_2
    qo_3 = qo_3c + qo_3d
    qo_3_right = qo_3 - qo_3c
    qo_3c_lo = (product_rest(vi_0, qi_0, qo_3a, qo_3c - qo_3c_right)
        + product_rest(vi_1, qi_1, qo_3b, qo_3c_right))
    qo_0_rounded = (qo_0
        + (product_rest(vi_0, qi_3, qo_0a, qo_0 - qo_0_right) + (qo_0d - qo_0_right) + qo_0d_lo))
    qo_1_rounded = (qo_1
        + (qo_1c - (qo_1 - qo_1_right) + product_rest(vi_1, qi_3, qo_1d, qo_1_right) + qo_1c_lo))
    qo_2_rounded = (qo_2
        + (qo_2c - (qo_2 - qo_2_right) + product_rest(vi_2, qi_3, qo_2d, qo_2_right) + qo_2c_lo))
    qo_3_rounded = (qo_3
        + (qo_3c - (qo_3 - qo_3_right) + product_rest(vi_2, qi_2, qo_3d, qo_3_right) + qo_3c_lo))
    return (qo_0_rounded, qo_1_rounded, qo_2_rounded, qo_3_rounded)


@kernel("(4),(4)->()")
def dot_qq(q1i, q2i):
    """q1i·q2i.

    (4),(4)->().  q1i, q2i: quaternion (x, y, z, w), the scalar last; dot: number.
    4 mul, 17 add, 4 product rest.  Error <= u |result| + 17 u^2 S, S the sum of the |terms| of
    the expanded formula; barring over- and underflow.
    """
    q1i_0, q1i_1, q1i_2, q1i_3 = q1i
    q2i_0, q2i_1, q2i_2, q2i_3 = q2i
    dot_a = q1i_0 * q2i_0
    dot_b = q1i_1 * q2i_1
    dot_c = dot_a + dot_b
    dot_c_right = dot_c - dot_a
    dot_d = q1i_2 * q2i_2
    dot_e = dot_c + dot_d
    dot_e_right = dot_e - dot_c
    dot_c_lo = (product_rest(q1i_0, q2i_0, dot_a, dot_c - dot_c_right)
        + product_rest(q1i_1, q2i_1, dot_b, dot_c_right))
    dot_f = q1i_3 * q2i_3
    dot = dot_e + dot_f
    dot_right = dot - dot_e
    dot_e_lo = (dot_c - (dot_e - dot_e_right) + product_rest(q1i_2, q2i_2, dot_d, dot_e_right)
        + dot_c_lo)
    dot_rounded = (dot
        + (dot_e - (dot - dot_right) + product_rest(q1i_3, q2i_3, dot_f, dot_right) + dot_e_lo))
    return dot_rounded


@kernel("(3),(4)->(4)")
def add_dpiToq(dpi, qi):
    """qi = qi + qi (dpi; 0) / 2: rotated by the small rotation vector dpi in the rotated frame, to
    first order; not normalized.

    (3),(4)->(4).  dpi: vector; qi: quaternion (x, y, z, w), the scalar last.
    15 mul, 72 add, 12 product rest.  Error <= u |result| + 15 u^2 S, S the sum of the |terms|
    of the expanded formula; barring over- and underflow.
    """
    dpi_0, dpi_1, dpi_2 = dpi
    qi_0, qi_1, qi_2, qi_3 = qi
    qi_0_new_a = 0.5 * dpi_0
    qi_0_new_b = qi_0_new_a * qi_3
    qi_0_new_c = 0.5 * dpi_2
    qi_0_new_d = qi_0_new_c * qi_1
    qi_0_new_e = 0.5 * dpi_1
    qi_0_new_f = qi_0_new_e * qi_2
    qi_0_new_g = qi_0_new_d - qi_0_new_f
    qi_0_new_g_right = qi_0_new_d - qi_0_new_g
    qi_0_new_g_left_rest = product_rest(qi_0_new_c, qi_1, qi_0_new_d, qi_0_new_g + qi_0_new_g_right)
    qi_0_new_h = qi_0_new_b + qi_0_new_g
    qi_0_new_h_right = qi_0_new_h - qi_0_new_b
    qi_0_new_h_lo1 = (product_rest(qi_0_new_a, qi_3, qi_0_new_b, qi_0_new_h - qi_0_new_h_right)
        + (qi_0_new_g - qi_0_new_h_right))
    qi_0_new = qi_0_new_h + qi_0
    qi_0_new_right = qi_0_new - qi_0_new_h
    qi_0_new_h_lo = (qi_0_new_h_lo1
        + (qi_0_new_g_left_rest - product_rest(qi_0_new_e, qi_2, qi_0_new_f, qi_0_new_g_right)))
    qi_1_new_a = qi_0_new_a * qi_2
    qi_1_new_b = qi_0_new_c * qi_0
    qi_1_new_c = qi_1_new_a - qi_1_new_b
    qi_1_new_c_right = qi_1_new_a - qi_1_new_c
    qi_1_new_c_left_rest = product_rest(qi_0_new_a, qi_2, qi_1_new_a, qi_1_new_c + qi_1_new_c_right)
    qi_1_new_d = qi_0_new_e * qi_3
    qi_1_new_e = qi_1_new_c + qi_1_new_d
    qi_1_new_e_right = qi_1_new_e - qi_1_new_c
    qi_1_new_e_lo1 = (qi_1_new_c - (qi_1_new_e - qi_1_new_e_right)
        + product_rest(qi_0_new_e, qi_3, qi_1_new_d, qi_1_new_e_right))
    qi_1_new = qi_1_new_e + qi_1
    qi_1_new_right = qi_1_new - qi_1_new_e
    qi_1_new_e_lo = (qi_1_new_e_lo1
        + (qi_1_new_c_left_rest - product_rest(qi_0_new_c, qi_0, qi_1_new_b, qi_1_new_c_right)))
    qi_2_new_a = qi_0_new_e * qi_0
    qi_2_new_b = qi_0_new_a * qi_1
    qi_2_new_c = qi_2_new_a - qi_2_new_b
    qi_2_new_c_right = qi_2_new_a - qi_2_new_c
    qi_2_new_c_left_rest = product_rest(qi_0_new_e, qi_0, qi_2_new_a, qi_2_new_c + qi_2_new_c_right)
    qi_2_new_d = qi_0_new_c * qi_3
    qi_2_new_e = qi_2_new_c + qi_2_new_d
    qi_2_new_e_right = qi_2_new_e - qi_2_new_c
    qi_2_new_e_lo1 = (qi_2_new_c - (qi_2_new_e - qi_2_new_e_right)
        + product_rest(qi_0_new_c, qi_3, qi_2_new_d, qi_2_new_e_right))
    qi_2_new = qi_2_new_e + qi_2
    qi_2_new_right = qi_2_new - qi_2_new_e
    qi_2_new_e_lo = (qi_2_new_e_lo1
        + (qi_2_new_c_left_rest - product_rest(qi_0_new_a, qi_1, qi_2_new_b, qi_2_new_c_right)))
    qi_3_new_a = qi_0_new_a * qi_0
    qi_3_new_b = qi_0_new_e * qi_1
    qi_3_new_c = qi_3_new_a + qi_3_new_b
    qi_3_new_c_right = qi_3_new_c - qi_3_new_a
    qi_3_new_c_left_rest = product_rest(qi_0_new_a, qi_0, qi_3_new_a, qi_3_new_c - qi_3_new_c_right)
    qi_3_new_d = qi_0_new_c * qi_2
    qi_3_new_e = qi_3_new_c + qi_3_new_d
    qi_3_new_e_right = qi_3_new_e - qi_3_new_c
    qi_3_new_e_lo1 = (qi_3_new_c - (qi_3_new_e - qi_3_new_e_right)
        + product_rest(qi_0_new_c, qi_2, qi_3_new_d, qi_3_new_e_right))
    qi_3_new = qi_3 - qi_3_new_e
    qi_3_new_right = qi_3 - qi_3_new
    qi_3_new_e_lo = (qi_3_new_e_lo1
        + (qi_3_new_c_left_rest + product_rest(qi_0_new_e, qi_1, qi_3_new_b, qi_3_new_c_right)))
    qi_0_new_rounded = (qi_0_new
        + (qi_0_new_h - (qi_0_new - qi_0_new_right) + (qi_0 - qi_0_new_right) + qi_0_new_h_lo))
    qi_1_new_rounded = (qi_1_new
        + (qi_1_new_e - (qi_1_new - qi_1_new_right) + (qi_1 - qi_1_new_right) + qi_1_new_e_lo))
    qi_2_new_rounded = (qi_2_new
        + (qi_2_new_e - (qi_2_new - qi_2_new_right) + (qi_2 - qi_2_new_right) + qi_2_new_e_lo))
    qi_3_new_rounded = (qi_3_new
        + (qi_3 - (qi_3_new + qi_3_new_right) - (qi_3_new_e - qi_3_new_right) - qi_3_new_e_lo))
    return (qi_0_new_rounded, qi_1_new_rounded, qi_2_new_rounded, qi_3_new_rounded)


@kernel("(3),(4)->(4)")
def subtract_dpiFromq(dpi, qi):
    """qi = qi - qi (dpi; 0) / 2, the opposite of add_dpiToq to first order.

    (3),(4)->(4).  dpi: vector; qi: quaternion (x, y, z, w), the scalar last.
    15 mul, 72 add, 12 product rest.  Error <= u |result| + 15 u^2 S, S the sum of the |terms|
    of the expanded formula; barring over- and underflow.
    """
    dpi_0, dpi_1, dpi_2 = dpi
    qi_0, qi_1, qi_2, qi_3 = qi
    qi_0_new_a = 0.5 * dpi_1
    qi_0_new_b = qi_0_new_a * qi_2
    qi_0_new_c = 0.5 * dpi_2
    qi_0_new_d = qi_0_new_c * qi_1
    qi_0_new_e = qi_0_new_b - qi_0_new_d
    qi_0_new_e_right = qi_0_new_b - qi_0_new_e
    qi_0_new_e_left_rest = product_rest(qi_0_new_a, qi_2, qi_0_new_b, qi_0_new_e + qi_0_new_e_right)
    qi_0_new_f = 0.5 * dpi_0
    qi_0_new_g = qi_0_new_f * qi_3
    qi_0_new_h = qi_0_new_e - qi_0_new_g
    qi_0_new_h_right = qi_0_new_e - qi_0_new_h
    qi_0_new_h_lo1 = (qi_0_new_e - (qi_0_new_h + qi_0_new_h_right)
        - product_rest(qi_0_new_f, qi_3, qi_0_new_g, qi_0_new_h_right))
    qi_0_new = qi_0_new_h + qi_0
    qi_0_new_right = qi_0_new - qi_0_new_h
    qi_0_new_h_lo = (qi_0_new_h_lo1
        + (qi_0_new_e_left_rest - product_rest(qi_0_new_c, qi_1, qi_0_new_d, qi_0_new_e_right)))
    qi_1_new_a = qi_0_new_c * qi_0
    qi_1_new_b = qi_0_new_f * qi_2
    qi_1_new_c = qi_1_new_a - qi_1_new_b
    qi_1_new_c_right = qi_1_new_a - qi_1_new_c
    qi_1_new_c_left_rest = product_rest(qi_0_new_c, qi_0, qi_1_new_a, qi_1_new_c + qi_1_new_c_right)
    qi_1_new_d = qi_0_new_a * qi_3
    qi_1_new_e = qi_1_new_c - qi_1_new_d
    qi_1_new_e_right = qi_1_new_c - qi_1_new_e
    qi_1_new_e_lo1 = (qi_1_new_c - (qi_1_new_e + qi_1_new_e_right)
        - product_rest(qi_0_new_a, qi_3, qi_1_new_d, qi_1_new_e_right))
    qi_1_new = qi_1_new_e + qi_1
    qi_1_new_right = qi_1_new - qi_1_new_e
    qi_1_new_e_lo = (qi_1_new_e_lo1
        + (qi_1_new_c_left_rest - product_rest(qi_0_new_f, qi_2, qi_1_new_b, qi_1_new_c_right)))
    qi_2_new_a = qi_0_new_f * qi_1
    qi_2_new_b = qi_0_new_a * qi_0
    qi_2_new_c = qi_2_new_a - qi_2_new_b
    qi_2_new_c_right = qi_2_new_a - qi_2_new_c
    qi_2_new_c_left_rest = product_rest(qi_0_new_f, qi_1, qi_2_new_a, qi_2_new_c + qi_2_new_c_right)
    qi_2_new_d = qi_0_new_c * qi_3
    qi_2_new_e = qi_2_new_c - qi_2_new_d
    qi_2_new_e_right = qi_2_new_c - qi_2_new_e
    qi_2_new_e_lo1 = (qi_2_new_c - (qi_2_new_e + qi_2_new_e_right)
        - product_rest(qi_0_new_c, qi_3, qi_2_new_d, qi_2_new_e_right))
    qi_2_new = qi_2_new_e + qi_2
    qi_2_new_right = qi_2_new - qi_2_new_e
    qi_2_new_e_lo = (qi_2_new_e_lo1
        + (qi_2_new_c_left_rest - product_rest(qi_0_new_a, qi_0, qi_2_new_b, qi_2_new_c_right)))
    qi_3_new_a = qi_0_new_f * qi_0
    qi_3_new_b = qi_0_new_a * qi_1
    qi_3_new_c = qi_3_new_a + qi_3_new_b
    qi_3_new_c_right = qi_3_new_c - qi_3_new_a
    qi_3_new_c_left_rest = product_rest(qi_0_new_f, qi_0, qi_3_new_a, qi_3_new_c - qi_3_new_c_right)
    qi_3_new_d = qi_0_new_c * qi_2
    qi_3_new_e = qi_3_new_c + qi_3_new_d
    qi_3_new_e_right = qi_3_new_e - qi_3_new_c
    qi_3_new_e_lo1 = (qi_3_new_c - (qi_3_new_e - qi_3_new_e_right)
        + product_rest(qi_0_new_c, qi_2, qi_3_new_d, qi_3_new_e_right))
    qi_3_new = qi_3_new_e + qi_3
    qi_3_new_right = qi_3_new - qi_3_new_e
    qi_3_new_e_lo = (qi_3_new_e_lo1
        + (qi_3_new_c_left_rest + product_rest(qi_0_new_a, qi_1, qi_3_new_b, qi_3_new_c_right)))
    qi_0_new_rounded = (qi_0_new
        + (qi_0_new_h - (qi_0_new - qi_0_new_right) + (qi_0 - qi_0_new_right) + qi_0_new_h_lo))
    qi_1_new_rounded = (qi_1_new
        + (qi_1_new_e - (qi_1_new - qi_1_new_right) + (qi_1 - qi_1_new_right) + qi_1_new_e_lo))
    qi_2_new_rounded = (qi_2_new
        + (qi_2_new_e - (qi_2_new - qi_2_new_right) + (qi_2 - qi_2_new_right) + qi_2_new_e_lo))
    qi_3_new_rounded = (qi_3_new
        + (qi_3_new_e - (qi_3_new - qi_3_new_right) + (qi_3 - qi_3_new_right) + qi_3_new_e_lo))
    return (qi_0_new_rounded, qi_1_new_rounded, qi_2_new_rounded, qi_3_new_rounded)


@kernel("(3),(4)->(4)")
def omega_to_dquaternion(w, qi):
    """dqo = (w; 0) qi / 2 + (1 - qi·qi) qi: the rate of qi for the angular velocity w in the
    reference frame, rad/s, and a term that draws its norm to 1.

    (3),(4)->(4).  w: vector; qi, dqo: quaternion (x, y, z, w), the scalar last.
    27 mul, 101 add, 20 product rest.  Error <= u |result| + (v: 35, w: 32) u^2 S, S the sum of
    the |terms| of the expanded formula; barring over- and underflow.
    """
    w_0, w_1, w_2 = w
    qi_0, qi_1, qi_2, qi_3 = qi
    dqo_0a = 0.5 * w_0
    dqo_0b = dqo_0a * qi_3
    dqo_0c = 0.5 * w_1
    dqo_0d = dqo_0c * qi_2
    dqo_0e = 0.5 * w_2
    dqo_0f = dqo_0e * qi_1
    dqo_0g = dqo_0d - dqo_0f
    dqo_0g_right = dqo_0d - dqo_0g
    dqo_0h = dqo_0b + dqo_0g
    dqo_0h_right = dqo_0h - dqo_0b
    dqo_0g_lo = (product_rest(dqo_0c, qi_2, dqo_0d, dqo_0g + dqo_0g_right)
        - product_rest(dqo_0e, qi_1, dqo_0f, dqo_0g_right))
    dqo_0i = qi_0 * qi_0
    dqo_0j = 1 - dqo_0i
    dqo_0j_right = 1 - dqo_0j
    dqo_0k = qi_1 * qi_1
    dqo_0l = dqo_0j - dqo_0k
    dqo_0l_right = dqo_0j - dqo_0l
    dqo_0l_lo1 = dqo_0j - (dqo_0l + dqo_0l_right) - product_rest(qi_1, qi_1, dqo_0k, dqo_0l_right)
    dqo_0m = qi_2 * qi_2
    dqo_0n = dqo_0l - dqo_0m
    dqo_0n_right = dqo_0l - dqo_0n
    dqo_0l_lo = (dqo_0l_lo1
        + (1 - (dqo_0j + dqo_0j_right) - product_rest(qi_0, qi_0, dqo_0i, dqo_0j_right)))
    dqo_0o = qi_3 * qi_3
    dqo_0p = dqo_0n - dqo_0o
    dqo_0p_right = dqo_0n - dqo_0p
    dqo_0n_lo = (dqo_0l - (dqo_0n + dqo_0n_right) - product_rest(qi_2, qi_2, dqo_0m, dqo_0n_right)
        + dqo_0l_lo)
    dqo_0p_lo = (dqo_0n - (dqo_0p + dqo_0p_right) - product_rest(qi_3, qi_3, dqo_0o, dqo_0p_right)
        + dqo_0n_lo)
    dqo_0p_sum = dqo_0p + dqo_0p_lo
    dqo_0p_sum_right = dqo_0p_sum - dqo_0p
    dqo_0p_sum_lo = dqo_0p - (dqo_0p_sum - dqo_0p_sum_right) + (dqo_0p_lo - dqo_0p_sum_right)
    dqo_0q = qi_0 * dqo_0p_sum
    dqo_0 = dqo_0h + dqo_0q
    dqo_0_right = dqo_0 - dqo_0h
    dqo_0_lo2 = (dqo_0h - (dqo_0 - dqo_0_right)
        + product_rest(qi_0, dqo_0p_sum, dqo_0q, dqo_0_right) + qi_0 * dqo_0p_sum_lo)
    dqo_1a = dqo_0e * qi_0
    dqo_1b = dqo_0a * qi_2
    dqo_1c = dqo_1a - dqo_1b
    dqo_1c_right = dqo_1a - dqo_1c
    dqo_1d = dqo_0c * qi_3
    dqo_1e = dqo_1c + dqo_1d
    dqo_1e_right = dqo_1e - dqo_1c
    dqo_1c_lo = (product_rest(dqo_0e, qi_0, dqo_1a, dqo_1c + dqo_1c_right)
        - product_rest(dqo_0a, qi_2, dqo_1b, dqo_1c_right))
    dqo_1f = qi_1 * dqo_0p_sum
    dqo_1 = dqo_1e + dqo_1f
    dqo_1_right = dqo_1 - dqo_1e
    dqo_1_lo2 = (dqo_1e - (dqo_1 - dqo_1_right)
        + product_rest(qi_1, dqo_0p_sum, dqo_1f, dqo_1_right) + qi_1 * dqo_0p_sum_lo)
    dqo_2a = dqo_0a * qi_1
    dqo_2b = dqo_0c * qi_0
    dqo_2c = dqo_2a - dqo_2b
    dqo_2c_right = dqo_2a - dqo_2c
    dqo_2d = dqo_0e * qi_3
    dqo_2e = dqo_2c + dqo_2d
    dqo_2e_right = dqo_2e - dqo_2c
    dqo_2c_lo = (product_rest(dqo_0a, qi_1, dqo_2a, dqo_2c + dqo_2c_right)
        - product_rest(dqo_0c, qi_0, dqo_2b, dqo_2c_right))
    dqo_2f = qi_2 * dqo_0p_sum
    dqo_2 = dqo_2e + dqo_2f
    dqo_2_right = dqo_2 - dqo_2e
    dqo_2_lo2 = (dqo_2e - (dqo_2 - dqo_2_right)
        + product_rest(qi_2, dqo_0p_sum, dqo_2f, dqo_2_right) + qi_2 * dqo_0p_sum_lo)
    dqo_3a = qi_3 * dqo_0p_sum
    dqo_3b = dqo_0a * qi_0
    dqo_3c = dqo_0c * qi_1
    dqo_3d = dqo_3b + dqo_3c
    dqo_3d_right = dqo_3d - dqo_3b
    dqo_3e = dqo_0e * qi_2
    dqo_3f = dqo_3d + dqo_3e
    dqo_3f_right = dqo_3f - dqo_3d
    dqo_3d_lo = (product_rest(dqo_0a, qi_0, dqo_3b, dqo_3d - dqo_3d_right)
        + product_rest(dqo_0c, qi_1, dqo_3c, dqo_3d_right))
    dqo_3 = dqo_3a - dqo_3f
    dqo_3_right = dqo_3a - dqo_3
    dqo_3f_lo = (dqo_3d - (dqo_3f - dqo_3f_right)
        + product_rest(dqo_0e, qi_2, dqo_3e, dqo_3f_right) + dqo_3d_lo)
    dqo_0_rounded = (dqo_0
        + (dqo_0_lo2
        + (product_rest(dqo_0a, qi_3, dqo_0b, dqo_0h - dqo_0h_right) + (dqo_0g - dqo_0h_right)
        + dqo_0g_lo)))
    dqo_1_rounded = (dqo_1
        + (dqo_1_lo2
        + (dqo_1c - (dqo_1e - dqo_1e_right) + product_rest(dqo_0c, qi_3, dqo_1d, dqo_1e_right)
        + dqo_1c_lo)))
    dqo_2_rounded = (dqo_2
        + (dqo_2_lo2
        + (dqo_2c - (dqo_2e - dqo_2e_right) + product_rest(dqo_0e, qi_3, dqo_2d, dqo_2e_right)
        + dqo_2c_lo)))
    dqo_3_rounded = (dqo_3
        + (product_rest(qi_3, dqo_0p_sum, dqo_3a, dqo_3 + dqo_3_right) - (dqo_3f - dqo_3_right)
        - dqo_3f_lo + qi_3 * dqo_0p_sum_lo))
    return (dqo_0_rounded, dqo_1_rounded, dqo_2_rounded, dqo_3_rounded)


@kernel("(4)->(3,3)")
def mat3x3_from_quaternion(q):
    """R = I + 2 (w v~ + v~^2) / q·q, for any nonzero q whose square neither over- nor underflows.

    (4)->(3,3).  q: quaternion (x, y, z, w), the scalar last; R: rotation or other 3×3 matrix.
    41 mul, 116 add, 10 product error, 24 product rest, 2 div, 9 equal, 9 select.  Error <= R: 1
    u of its largest component for 2^-450 < |q| < 2^511, in single precision 2^-45 < |q| < 2^63;
    searched, not proved.  Each component is within 1 ulp as long as its condition is below
    1e13; in single precision it is the nearest number, except near ties, as long as that is
    below 1e5; searched, not proved.
    """
    q_0, q_1, q_2, q_3 = q
    squares_0 = q_3 * q_3
    squares_1 = q_0 * q_0
    squares_2 = q_1 * q_1
    squares_3 = q_2 * q_2
    pairs_0 = squares_0 + squares_1
    pairs_0_right = pairs_0 - squares_0
    pairs_0_lo = (product_rest(q_3, q_3, squares_0, pairs_0 - pairs_0_right)
        + product_rest(q_0, q_0, squares_1, pairs_0_right))
    pairs_1 = squares_2 + squares_3
    pairs_1_right = pairs_1 - squares_2
    pairs_1_lo = (product_rest(q_1, q_1, squares_2, pairs_1 - pairs_1_right)
        + product_rest(q_2, q_2, squares_3, pairs_1_right))
    pairs_2 = squares_0 + squares_2
    pairs_2_right = pairs_2 - squares_0
    pairs_3 = squares_1 + squares_3
    pairs_3_right = pairs_3 - squares_1
    pairs_4 = squares_0 + squares_3
    pairs_4_right = pairs_4 - squares_0
    pairs_5 = squares_1 + squares_2
    pairs_5_right = pairs_5 - squares_1
    square = pairs_0 + pairs_1
    square_right = square - pairs_0
    square_lo = (pairs_0 - (square - square_right) + (pairs_1 - square_right) + pairs_1_lo
        + pairs_0_lo)
    square_sum = square + square_lo
    square_sum_right = square_sum - square
    factor = 1 / square_sum
    factor_product = factor * square_sum
    factor_cross = (factor
        * (square - (square_sum - square_sum_right) + (square_lo - square_sum_right)))
    factor_lo = ((1 - factor_product - product_error(factor, square_sum, factor_product)
        - factor_cross) / square_sum)
    d0 = pairs_0 - pairs_1
    d0_right = pairs_0 - d0
    d1 = pairs_2 - pairs_3
    d1_right = pairs_2 - d1
    pairs_3_lo = (product_rest(q_0, q_0, squares_1, pairs_3 - pairs_3_right)
        + product_rest(q_2, q_2, squares_3, pairs_3_right))
    pairs_2_lo = (product_rest(q_3, q_3, squares_0, pairs_2 - pairs_2_right)
        + product_rest(q_1, q_1, squares_2, pairs_2_right))
    d2 = pairs_4 - pairs_5
    d2_right = pairs_4 - d2
    pairs_5_lo = (product_rest(q_0, q_0, squares_1, pairs_5 - pairs_5_right)
        + product_rest(q_1, q_1, squares_2, pairs_5_right))
    pairs_4_lo = (product_rest(q_3, q_3, squares_0, pairs_4 - pairs_4_right)
        + product_rest(q_2, q_2, squares_3, pairs_4_right))
    twice = 2 * factor
    twice_cross2 = 2 * factor_lo
    m_0a = q_0 * q_1
    m_0b = q_2 * q_3
    m_0 = m_0a - m_0b
    m_0_right = m_0a - m_0
    m_1a = q_0 * q_2
    m_1b = q_1 * q_3
    m_1 = m_1a + m_1b
    m_1_right = m_1 - m_1a
    m_2a = q_1 * q_2
    m_2b = q_0 * q_3
    m_2 = m_2a - m_2b
    m_2_right = m_2a - m_2
    m_3 = m_0a + m_0b
    m_3_right = m_3 - m_0a
    m_4 = m_1a - m_1b
    m_4_right = m_1a - m_4
    m_5 = m_2b + m_2a
    m_5_right = m_5 - m_2b
    R_00 = factor * d0
    R_01 = twice * m_0
    R_02 = twice * m_1
    R_10 = twice * m_3
    R_11 = factor * d1
    R_12 = twice * m_2
    R_20 = twice * m_4
    R_21 = twice * m_5
    R_22 = factor * d2
    R_00_lo = (product_error(factor, d0, R_00)
        + (factor_lo * d0 + factor
        * (pairs_0 - (d0 + d0_right) - (pairs_1 - d0_right) - pairs_1_lo + pairs_0_lo)))
    R_00_rounded = R_00 + R_00_lo
    R_01_cross = (twice_cross2 * m_0 + twice
        * (product_rest(q_0, q_1, m_0a, m_0 + m_0_right) - product_rest(q_2, q_3, m_0b, m_0_right)))
    R_01_rounded = R_01 + (product_error(twice, m_0, R_01) + R_01_cross)
    R_02_cross = (twice_cross2 * m_1 + twice
        * (product_rest(q_0, q_2, m_1a, m_1 - m_1_right) + product_rest(q_1, q_3, m_1b, m_1_right)))
    R_02_rounded = R_02 + (product_error(twice, m_1, R_02) + R_02_cross)
    R_10_cross = (twice_cross2 * m_3 + twice
        * (product_rest(q_0, q_1, m_0a, m_3 - m_3_right) + product_rest(q_2, q_3, m_0b, m_3_right)))
    R_10_rounded = R_10 + (product_error(twice, m_3, R_10) + R_10_cross)
    R_11_lo = (product_error(factor, d1, R_11)
        + (factor_lo * d1 + factor
        * (pairs_2 - (d1 + d1_right) - (pairs_3 - d1_right) - pairs_3_lo + pairs_2_lo)))
    R_11_rounded = R_11 + R_11_lo
    R_12_cross = (twice_cross2 * m_2 + twice
        * (product_rest(q_1, q_2, m_2a, m_2 + m_2_right) - product_rest(q_0, q_3, m_2b, m_2_right)))
    R_12_rounded = R_12 + (product_error(twice, m_2, R_12) + R_12_cross)
    R_20_cross = (twice_cross2 * m_4 + twice
        * (product_rest(q_0, q_2, m_1a, m_4 + m_4_right) - product_rest(q_1, q_3, m_1b, m_4_right)))
    R_20_rounded = R_20 + (product_error(twice, m_4, R_20) + R_20_cross)
    R_21_cross = (twice_cross2 * m_5 + twice
        * (product_rest(q_0, q_3, m_2b, m_5 - m_5_right) + product_rest(q_1, q_2, m_2a, m_5_right)))
    R_21_rounded = R_21 + (product_error(twice, m_5, R_21) + R_21_cross)
    R_22_lo = (product_error(factor, d2, R_22)
        + (factor_lo * d2 + factor
        * (pairs_4 - (d2 + d2_right) - (pairs_5 - d2_right) - pairs_5_lo + pairs_4_lo)))
    R_22_rounded = R_22 + R_22_lo
    R_00_final = where(R_00_rounded == R_00_rounded, R_00_rounded, R_00)
    R_01_final = where(R_01_rounded == R_01_rounded, R_01_rounded, R_01)
    R_02_final = where(R_02_rounded == R_02_rounded, R_02_rounded, R_02)
    R_10_final = where(R_10_rounded == R_10_rounded, R_10_rounded, R_10)
    R_11_final = where(R_11_rounded == R_11_rounded, R_11_rounded, R_11)
    R_12_final = where(R_12_rounded == R_12_rounded, R_12_rounded, R_12)
    R_20_final = where(R_20_rounded == R_20_rounded, R_20_rounded, R_20)
    R_21_final = where(R_21_rounded == R_21_rounded, R_21_rounded, R_21)
    R_22_final = where(R_22_rounded == R_22_rounded, R_22_rounded, R_22)
    return (R_00_final, R_01_final, R_02_final, R_10_final, R_11_final, R_12_final, R_20_final,
        R_21_final, R_22_final)


@kernel("(3,3)->(4)")
def quaternion_from_mat3x3(R):
    """qo with R(qo) = R and w >= 0; if R is not quite a rotation, its defect carries over to qo.

    (3,3)->(4).  R: rotation or other 3×3 matrix; qo: quaternion (x, y, z, w), the scalar last.
    21 mul, 182 add, 5 product error, 4 product rest, 9 div, 1 sqrt, 9 neg, 4 less, 5 equal, 37
    select.  Error <= qo: 1 u of its largest component for R a rotation; searched, not proved.
    Each component is within 1 ulp as long as its condition is below 1e13; in single precision
    it is the nearest number, except near ties, as long as that is below 1e5; searched, not
    proved.
    """
    R_00, R_01, R_02, R_10, R_11, R_12, R_20, R_21, R_22 = R
    p_0 = R_21 - R_12
    p_0_right = R_21 - p_0
    p_0_lo = R_21 - (p_0 + p_0_right) - (R_12 - p_0_right)
    p_1 = R_02 - R_20
    p_1_right = R_02 - p_1
    p_1_lo = R_02 - (p_1 + p_1_right) - (R_20 - p_1_right)
    p_2 = R_10 - R_01
    p_2_right = R_10 - p_2
    p_2_lo = R_10 - (p_2 + p_2_right) - (R_01 - p_2_right)
    s_0 = R_12 + R_21
    s_0_right = s_0 - R_12
    s_0_lo = R_12 - (s_0 - s_0_right) + (R_21 - s_0_right)
    s_1 = R_02 + R_20
    s_1_right = s_1 - R_02
    s_1_lo = R_02 - (s_1 - s_1_right) + (R_20 - s_1_right)
    s_2 = R_01 + R_10
    s_2_right = s_2 - R_01
    s_2_lo = R_01 - (s_2 - s_2_right) + (R_10 - s_2_right)
    first_0 = R_00 + 1
    first_0_right = first_0 - R_00
    first_0_lo = R_00 - (first_0 - first_0_right) + (1 - first_0_right)
    first_1 = 1 - R_00
    first_1_right = 1 - first_1
    first_1_lo = 1 - (first_1 + first_1_right) - (R_00 - first_1_right)
    others_0 = R_11 + R_22
    others_0_right = others_0 - R_11
    others_0_lo = R_11 - (others_0 - others_0_right) + (R_22 - others_0_right)
    others_1 = R_11 - R_22
    others_1_right = R_11 - others_1
    others_1_lo = R_11 - (others_1 + others_1_right) - (R_22 - others_1_right)
    d_0 = first_0 + others_0
    d_0_right = d_0 - first_0
    d_1 = first_0 - others_0
    d_1_right = first_0 - d_1
    d_2 = first_1 + others_1
    d_2_right = d_2 - first_1
    d_3 = first_1 - others_1
    d_3_right = first_1 - d_3
    low_0a = R_11 < R_00
    low_0 = where(low_0a, d_1, s_2)
    low_1 = where(low_0a, s_2, d_2)
    low_2 = where(low_0a, s_1, s_0)
    low_3 = where(low_0a, p_0, p_1)
    high_0b = R_00 < -R_11
    high_0 = where(high_0b, s_1, p_0)
    high_1 = where(high_0b, s_0, p_1)
    high_2 = where(high_0b, d_3, p_2)
    high_3 = where(high_0b, p_2, d_0)
    column_0a = R_22 < 0
    column_0 = where(column_0a, low_0, high_0)
    low_0_lo = where(low_0a,
        first_0 - (d_1 + d_1_right) - (others_0 - d_1_right) - others_0_lo + first_0_lo, s_2_lo)
    column_0_lo = where(column_0a, low_0_lo, where(high_0b, s_1_lo, p_0_lo))
    column_1 = where(column_0a, low_1, high_1)
    low_1_lo = where(low_0a, s_2_lo,
        first_1 - (d_2 - d_2_right) + (others_1 - d_2_right) + others_1_lo + first_1_lo)
    column_1_lo = where(column_0a, low_1_lo, where(high_0b, s_0_lo, p_1_lo))
    column_2 = where(column_0a, low_2, high_2)
    high_2_lo = where(high_0b,
        first_1 - (d_3 + d_3_right) - (others_1 - d_3_right) - others_1_lo + first_1_lo, p_2_lo)
    column_2_lo = where(column_0a, where(low_0a, s_1_lo, s_0_lo), high_2_lo)
    column_3 = where(column_0a, low_3, high_3)
    high_3_lo = where(high_0b, p_2_lo,
        first_0 - (d_0 - d_0_right) + (others_0 - d_0_right) + others_0_lo + first_0_lo)
    column_3_lo = where(column_0a, where(low_0a, p_0_lo, p_1_lo), high_3_lo)
    column_3_sum = column_3 + column_3_lo
    column_3_sum_right = column_3_sum - column_3
    column_3_sum_lo = (column_3 - (column_3_sum - column_3_sum_right)
        + (column_3_lo - column_3_sum_right))
    upper_0b = column_3_sum < 0
    upper_0 = where(upper_0b, -column_0, column_0)
    upper_0_lo = where(upper_0b, -column_0_lo, column_0_lo)
    upper_1 = where(upper_0b, -column_1, column_1)
    upper_1_lo = where(upper_0b, -column_1_lo, column_1_lo)
    upper_2 = where(upper_0b, -column_2, column_2)
    upper_2_lo = where(upper_0b, -column_2_lo, column_2_lo)
    upper_3 = where(upper_0b, -column_3_sum, column_3_sum)
    upper_3_lo = where(upper_0b, -column_3_sum_lo, column_3_sum_lo)
    length_a = upper_0 * upper_0
    length_b = upper_1 * upper_1
    length_c = length_a + length_b
    length_c_right = length_c - length_a
    length_c_lo1 = (product_rest(upper_0, upper_0, length_a, length_c - length_c_right)
        + product_rest(upper_1, upper_1, length_b, length_c_right))
    length_d = upper_2 * upper_2
    length_e = length_c + length_d
    length_e_right = length_e - length_c
    length_e_lo1 = (length_c - (length_e - length_e_right)
        + product_rest(upper_2, upper_2, length_d, length_e_right))
    length_c_lo = (length_c_lo1
        + (upper_0_lo * upper_0 + upper_0 * upper_0_lo
        + (upper_1_lo * upper_1 + upper_1 * upper_1_lo)))
    length_f = upper_3 * upper_3
    length_g = length_e + length_f
    length_g_right = length_g - length_e
    length_g_lo1 = (length_e - (length_g - length_g_right)
        + product_rest(upper_3, upper_3, length_f, length_g_right))
    length_e_lo = length_e_lo1 + (upper_2_lo * upper_2 + upper_2 * upper_2_lo) + length_c_lo
    length_g_lo = length_g_lo1 + (upper_3_lo * upper_3 + upper_3 * upper_3_lo) + length_e_lo
    length_g_sum = length_g + length_g_lo
    length_g_sum_right = length_g_sum - length_g
    length = sqrt(length_g_sum)
    length_product = length * length
    length_g_sum_lo = (length_g - (length_g_sum - length_g_sum_right)
        + (length_g_lo - length_g_sum_right))
    length_lo = ((length_g_sum - length_product - product_error(length, length, length_product)
        + length_g_sum_lo) / where(length == 0, 1, length + length))
    upper_0_sum = upper_0 + upper_0_lo
    upper_0_sum_right = upper_0_sum - upper_0
    length_sum = length + length_lo
    length_sum_right = length_sum - length
    length_sum_lo = length - (length_sum - length_sum_right) + (length_lo - length_sum_right)
    qo_0 = upper_0_sum / length_sum
    qo_0_product = qo_0 * length_sum
    upper_0_sum_lo = upper_0 - (upper_0_sum - upper_0_sum_right) + (upper_0_lo - upper_0_sum_right)
    upper_1_sum = upper_1 + upper_1_lo
    upper_1_sum_right = upper_1_sum - upper_1
    qo_1 = upper_1_sum / length_sum
    qo_1_product = qo_1 * length_sum
    upper_1_sum_lo = upper_1 - (upper_1_sum - upper_1_sum_right) + (upper_1_lo - upper_1_sum_right)
    upper_2_sum = upper_2 + upper_2_lo
    upper_2_sum_right = upper_2_sum - upper_2
    qo_2 = upper_2_sum / length_sum
    qo_2_product = qo_2 * length_sum
    upper_2_sum_lo = upper_2 - (upper_2_sum - upper_2_sum_right) + (upper_2_lo - upper_2_sum_right)
    upper_3_sum = upper_3 + upper_3_lo
    upper_3_sum_right = upper_3_sum - upper_3
    qo_3 = upper_3_sum / length_sum
    qo_3_product = qo_3 * length_sum
    upper_3_sum_lo = upper_3 - (upper_3_sum - upper_3_sum_right) + (upper_3_lo - upper_3_sum_right)
    qo_0_lo = ((upper_0_sum - qo_0_product - product_error(qo_0, length_sum, qo_0_product)
        + upper_0_sum_lo - qo_0 * length_sum_lo) / length_sum)
    qo_0_rounded = qo_0 + qo_0_lo
    qo_1_lo = ((upper_1_sum - qo_1_product - product_error(qo_1, length_sum, qo_1_product)
        + upper_1_sum_lo - qo_1 * length_sum_lo) / length_sum)
    qo_1_rounded = qo_1 + qo_1_lo
    qo_2_lo = ((upper_2_sum - qo_2_product - product_error(qo_2, length_sum, qo_2_product)
        + upper_2_sum_lo - qo_2 * length_sum_lo) / length_sum)
    qo_2_rounded = qo_2 + qo_2_lo
    qo_3_lo = ((upper_3_sum - qo_3_product - product_error(qo_3, length_sum, qo_3_product)
        + upper_3_sum_lo - qo_3 * length_sum_lo) / length_sum)
    qo_3_rounded = qo_3 + qo_3_lo
    qo_0_final = where(qo_0_rounded == qo_0_rounded, qo_0_rounded, qo_0)
    qo_1_final = where(qo_1_rounded == qo_1_rounded, qo_1_rounded, qo_1)
    qo_2_final = where(qo_2_rounded == qo_2_rounded, qo_2_rounded, qo_2)
    qo_3_final = where(qo_3_rounded == qo_3_rounded, qo_3_rounded, qo_3)
    return (qo_0_final, qo_1_final, qo_2_final, qo_3_final)


@kernel("(3),()->(4)")
def quaternion_from_axis_angle(axis, angle):
    """qo = (axis sin angle/2; cos angle/2); axis of length 1: with another |qo| is not 1, and its
    rotation is by another angle.

    (3),()->(4).  axis: vector; angle: number; qo: quaternion (x, y, z, w), the scalar last.
    90 mul, 134 add, 14 product error, 1 div, 3 abs, 1 less, 4 equal, 5 select.  Error <= qo: 1
    u of its largest component for |axis| = 1; searched, not proved.  Each component is within 1
    ulp as long as its condition is below 1e13; in single precision it is the nearest number,
    except near ties, as long as that is below 1e5; searched, not proved.
    """
    axis_0, axis_1, axis_2 = axis
    half = 0.5 * angle
    sine, qo_3 = elementary.sincos(half)
    sine_own_error, qo_3_own_error = elementary.sincos_error(half, sine, qo_3)
    qo_0 = axis_0 * sine
    qo_1 = axis_1 * sine
    qo_2 = axis_2 * sine
    qo_0_rounded = qo_0 + (product_error(axis_0, sine, qo_0) + axis_0 * sine_own_error)
    qo_1_rounded = qo_1 + (product_error(axis_1, sine, qo_1) + axis_1 * sine_own_error)
    qo_2_rounded = qo_2 + (product_error(axis_2, sine, qo_2) + axis_2 * sine_own_error)
    qo_3_rounded = qo_3 + qo_3_own_error
    qo_0_final = where(qo_0_rounded == qo_0_rounded, qo_0_rounded, qo_0)
    qo_1_final = where(qo_1_rounded == qo_1_rounded, qo_1_rounded, qo_1)
    qo_2_final = where(qo_2_rounded == qo_2_rounded, qo_2_rounded, qo_2)
    qo_3_final = where(qo_3_rounded == qo_3_rounded, qo_3_rounded, qo_3)
    return (qo_0_final, qo_1_final, qo_2_final, qo_3_final)


@kernel("(4)->(),(3)")
def axis_angle_from_quaternion(q):
    """angle = 2 atan2(|v|, |w|), axis = ±v / |v|; 0 <= angle <= π; the axis is (1, 0, 0) if the
    angle is 0; any multiple of a quaternion.

    (4)->(),(3).  q: quaternion (x, y, z, w), the scalar last; angle: number; axis: vector.
    149 mul, 268 add, 25 product error, 3 product rest, 13 div, 1 sqrt, 5 neg, 17 abs, 4
    copysign, 27 less, 10 equal, 51 select.  Error <= angle: 1 u, axis: 1 u of its largest
    component; searched, not proved.  Each component is within 1 ulp as long as its condition is
    below 1e13; in single precision it is the nearest number, except near ties, as long as that
    is below 1e5; searched, not proved.
    """
    q_0, q_1, q_2, q_3 = q
    s_size_0 = absolute(q_0)
    s_size_1 = absolute(q_1)
    s_size_2 = absolute(q_2)
    s_size_3 = absolute(q_3)
    s_largest1 = where(s_size_0 < s_size_1, s_size_1, s_size_0)
    s_largest2 = where(s_largest1 < s_size_2, s_size_2, s_largest1)
    s_largest3 = where(s_largest2 < s_size_3, s_size_3, s_largest2)
    s_d = where(s_largest3 < 256, 1.3093562431584567e+151,
        where(6.703903964971299e+153 < s_largest3, real(3.7291703656001034e-155), real(1)))
    s = where(s_largest3 < 1.955159272639747e-149, 1.0715086071862673e+301, s_d)
    scaled_s_0 = q_0 * s
    scaled_s_1 = q_1 * s
    scaled_s_2 = q_2 * s
    scaled_s_3 = q_3 * s
    upper_0b = scaled_s_3 < 0
    upper_0 = where(upper_0b, -scaled_s_0, scaled_s_0)
    upper_1 = where(upper_0b, -scaled_s_1, scaled_s_1)
    upper_2 = where(upper_0b, -scaled_s_2, scaled_s_2)
    upper_3 = where(upper_0b, -scaled_s_3, scaled_s_3)
    v_s_size_0 = absolute(upper_0)
    v_s_size_1 = absolute(upper_1)
    v_s_size_2 = absolute(upper_2)
    v_s_largest1 = where(v_s_size_0 < v_s_size_1, v_s_size_1, v_s_size_0)
    v_s_largest2 = where(v_s_largest1 < v_s_size_2, v_s_size_2, v_s_largest1)
    v_s = where(v_s_largest2 < 1.955159272639747e-149, 1.0715086071862673e+301,
        where(v_s_largest2 < 256, real(1.3093562431584567e+151), real(1)))
    v_y_0 = upper_0 * v_s
    v_y_1 = upper_1 * v_s
    v_y_2 = upper_2 * v_s
    v_n_a = v_y_0 * v_y_0
    v_n_b = v_y_1 * v_y_1
    v_n_c = v_n_a + v_n_b
    v_n_c_right = v_n_c - v_n_a
    v_n_d = v_y_2 * v_y_2
    v_n_e = v_n_c + v_n_d
    v_n_e_right = v_n_e - v_n_c
    v_n_c_lo = (product_rest(v_y_0, v_y_0, v_n_a, v_n_c - v_n_c_right)
        + product_rest(v_y_1, v_y_1, v_n_b, v_n_c_right))
    v_n_e_lo = (v_n_c - (v_n_e - v_n_e_right) + product_rest(v_y_2, v_y_2, v_n_d, v_n_e_right)
        + v_n_c_lo)
    v_n_e_sum = v_n_e + v_n_e_lo
    v_n_e_sum_right = v_n_e_sum - v_n_e
    v_n = sqrt(v_n_e_sum)
    v_n_product = v_n * v_n
    v_n_residual = (v_n_e_sum - v_n_product - product_error(v_n, v_n, v_n_product)
        + (v_n_e - (v_n_e_sum - v_n_e_sum_right) + (v_n_e_lo - v_n_e_sum_right)))
    v_n_lo = v_n_residual / where(v_n == 0, 1, v_n + v_n)
    v_r = where(1.3093562431584567e+151 < v_s, 9.332636185032189e-302, where(1 < v_s,
        real(7.637340908749012e-152), real(1)))
    v_n_sum = v_n + v_n_lo
    v_n_sum_right = v_n_sum - v_n
    v_n_sum_lo = v_n - (v_n_sum - v_n_sum_right) + (v_n_lo - v_n_sum_right)
    n = v_n_sum * v_r
    n_lo = (v_n_sum - n * (1 / v_r) + v_n_sum_lo) * v_r
    n_sum = n + n_lo
    n_sum_right = n_sum - n
    half = elementary.atan2(n_sum, upper_3)
    half_size0 = absolute(n_sum)
    half_size1 = absolute(upper_3)
    half_most = where(half_size0 < half_size1, half_size1, half_size0)
    half_zero = half_most == 0
    half_divisor = where(half_zero, 1, half_most)
    half_part0 = n_sum / half_divisor
    half_part1 = upper_3 / half_divisor
    half_safe = where(half_zero, 1,
        half_divisor * (half_part1 * half_part1 + half_part0 * half_part0))
    half_more = ((half_part1 * (n - (n_sum - n_sum_right) + (n_lo - n_sum_right)) - half_part0 * 0)
        / half_safe)
    divisor_a = v_n_sum == 0
    divisor = where(divisor_a, 1, v_n_sum)
    divisor_lo = where(divisor_a, 0, v_n_sum_lo)
    divisor_sum = divisor + divisor_lo
    divisor_sum_right = divisor_sum - divisor
    divisor_sum_lo = divisor - (divisor_sum - divisor_sum_right) + (divisor_lo - divisor_sum_right)
    unit_0 = v_y_0 / divisor_sum
    unit_0_product = unit_0 * divisor_sum
    unit_1 = v_y_1 / divisor_sum
    unit_1_product = unit_1 * divisor_sum
    unit_2 = v_y_2 / divisor_sum
    unit_2_product = unit_2 * divisor_sum
    angle = 2 * half
    axis_0 = where(divisor_a, 1, unit_0)
    angle_rounded = angle + 2 * (elementary.atan2_error(n_sum, upper_3, half) + half_more)
    axis_0_lo = where(divisor_a, 0, (v_y_0 - unit_0_product - product_error(unit_0, divisor_sum,
        unit_0_product) - unit_0 * divisor_sum_lo) / divisor_sum)
    axis_0_rounded = axis_0 + axis_0_lo
    unit_1_rounded = (unit_1
        + (v_y_1 - unit_1_product - product_error(unit_1, divisor_sum, unit_1_product) - unit_1
        * divisor_sum_lo) / divisor_sum)
    unit_2_rounded = (unit_2
        + (v_y_2 - unit_2_product - product_error(unit_2, divisor_sum, unit_2_product) - unit_2
        * divisor_sum_lo) / divisor_sum)
    angle_final = where(angle_rounded == angle_rounded, angle_rounded, angle)
    axis_0_final = where(axis_0_rounded == axis_0_rounded, axis_0_rounded, axis_0)
    unit_1_final = where(unit_1_rounded == unit_1_rounded, unit_1_rounded, unit_1)
    unit_2_final = where(unit_2_rounded == unit_2_rounded, unit_2_rounded, unit_2)
    return (angle_final, axis_0_final, unit_1_final, unit_2_final)


@kernel("(3)->(4)")
def quaternion_exp(v):
    """qo = exp (v/2; 0) = (v/θ sin θ/2; cos θ/2), θ = |v|: turns by the rotation vector v.

    (3)->(4).  v: vector; qo: quaternion (x, y, z, w), the scalar last.
    145 mul, 231 add, 17 product error, 4 product rest, 5 div, 1 sqrt, 7 abs, 6 less, 5 equal,
    14 select.  Error <= qo: 1 u of its largest component for |v| <= 1e13, in single precision
    1e5; searched, not proved.  Each component is within 1 ulp as long as its condition is below
    1e13; in single precision it is the nearest number, except near ties, as long as that is
    below 1e5; searched, not proved.
    """
    v_0, v_1, v_2 = v
    h_0 = 0.5 * v_0
    h_1 = 0.5 * v_1
    h_2 = 0.5 * v_2
    h_size_0 = absolute(h_0)
    h_size_1 = absolute(h_1)
    h_size_2 = absolute(h_2)
    h_largest1 = where(h_size_0 < h_size_1, h_size_1, h_size_0)
    h_largest2 = where(h_largest1 < h_size_2, h_size_2, h_largest1)
    s = where(6.703903964971299e+153 < h_largest2, real(3.7291703656001034e-155), real(1))
    reduced_0 = h_0 * s
    reduced_1 = h_1 * s
    reduced_2 = h_2 * s
    up = where(s < 1, real(2.6815615859885194e+154), real(1))
    reduced_length_a = reduced_0 * reduced_0
    reduced_length_b = reduced_1 * reduced_1
    reduced_length_c = reduced_length_a + reduced_length_b
    reduced_length_c_right = reduced_length_c - reduced_length_a
    reduced_length_c_left_rest = product_rest(reduced_0, reduced_0, reduced_length_a,
        reduced_length_c - reduced_length_c_right)
    reduced_length_d = reduced_2 * reduced_2
    reduced_length_e = reduced_length_c + reduced_length_d
    reduced_length_e_right = reduced_length_e - reduced_length_c
    reduced_length_e_right_rest = product_rest(reduced_2, reduced_2, reduced_length_d,
        reduced_length_e_right)
    reduced_length_c_lo = (reduced_length_c_left_rest
        + product_rest(reduced_1, reduced_1, reduced_length_b, reduced_length_c_right))
    reduced_length_e_lo = (reduced_length_c - (reduced_length_e - reduced_length_e_right)
        + reduced_length_e_right_rest + reduced_length_c_lo)
    reduced_length_e_sum = reduced_length_e + reduced_length_e_lo
    reduced_length_e_sum_right = reduced_length_e_sum - reduced_length_e
    reduced_length = sqrt(reduced_length_e_sum)
    reduced_length_product = reduced_length * reduced_length
    reduced_length_e_sum_lo = (reduced_length_e
        - (reduced_length_e_sum - reduced_length_e_sum_right)
        + (reduced_length_e_lo - reduced_length_e_sum_right))
    reduced_length_exact = (reduced_length_e_sum - reduced_length_product
        - product_error(reduced_length, reduced_length, reduced_length_product))
    reduced_length_lo = ((reduced_length_exact + reduced_length_e_sum_lo)
        / where(reduced_length == 0, 1, reduced_length + reduced_length))
    reduced_length_sum = reduced_length + reduced_length_lo
    reduced_length_sum_right = reduced_length_sum - reduced_length
    half_angle = reduced_length_sum * up
    reduced_length_sum_lo = (reduced_length - (reduced_length_sum - reduced_length_sum_right)
        + (reduced_length_lo - reduced_length_sum_right))
    half_angle_lo = (reduced_length_sum - half_angle * (1 / up) + reduced_length_sum_lo) * up
    y = half_angle * half_angle
    half_angle_sum = half_angle + half_angle_lo
    half_angle_sum_right = half_angle_sum - half_angle
    half_angle_sum_lo = (half_angle - (half_angle_sum - half_angle_sum_right)
        + (half_angle_lo - half_angle_sum_right))
    sine, c = elementary.sincos(half_angle_sum)
    sine_own_error, c_own_error = elementary.sincos_error(half_angle_sum, sine, c)
    sine_half = half_angle_sum_lo * 0.5
    sine_half_sin, sine_half_cos = elementary.sincos(sine_half)
    sine_twice = sine_half_sin + sine_half_sin
    sine_lo = sine_own_error + (sine_half_cos * c - sine_half_sin * sine) * sine_twice
    sinc_divisor_a = half_angle_sum < 1.4901161193847656e-08
    sinc_divisor = where(sinc_divisor_a, 1.4901161193847656e-08, half_angle_sum)
    sinc_divisor_lo = where(sinc_divisor_a, 0, half_angle_sum_lo)
    sine_sum = sine + sine_lo
    sine_sum_right = sine_sum - sine
    sinc_divisor_sum = sinc_divisor + sinc_divisor_lo
    sinc_divisor_sum_right = sinc_divisor_sum - sinc_divisor
    sinc_quotient = sine_sum / sinc_divisor_sum
    sinc_quotient_product = sinc_quotient * sinc_divisor_sum
    sinc_quotient_exact = (sine_sum - sinc_quotient_product
        - product_error(sinc_quotient, sinc_divisor_sum, sinc_quotient_product))
    sinc_quotient_cross = (sinc_quotient
        * (sinc_divisor - (sinc_divisor_sum - sinc_divisor_sum_right)
        + (sinc_divisor_lo - sinc_divisor_sum_right)))
    sinc_a = 0.16666666666666666 * y
    sinc_a_cross2 = (0.16666666666666666
        * (product_error(half_angle, half_angle, y)
        + (half_angle_lo * half_angle + half_angle * half_angle_lo)))
    sinc_b = 1 - sinc_a
    sinc_b_right = 1 - sinc_b
    sinc = where(sinc_divisor_a, sinc_b, sinc_quotient)
    sinc_b_lo = (1 - (sinc_b + sinc_b_right)
        - product_rest(0.16666666666666666, y, sinc_a, sinc_b_right)
        - (9.25185853854297e-18 * y + sinc_a_cross2))
    sinc_quotient_lo = ((sinc_quotient_exact
        + (sine - (sine_sum - sine_sum_right) + (sine_lo - sine_sum_right)) - sinc_quotient_cross)
        / sinc_divisor_sum)
    sinc_lo = where(sinc_divisor_a, sinc_b_lo, sinc_quotient_lo)
    qo_0 = h_0 * sinc
    qo_1 = h_1 * sinc
    qo_2 = h_2 * sinc
    qo_0_rounded = qo_0 + (product_error(h_0, sinc, qo_0) + h_0 * sinc_lo)
    qo_1_rounded = qo_1 + (product_error(h_1, sinc, qo_1) + h_1 * sinc_lo)
    qo_2_rounded = qo_2 + (product_error(h_2, sinc, qo_2) + h_2 * sinc_lo)
    c_rounded = c + (c_own_error - (sine_half_cos * sine + sine_half_sin * c) * sine_twice)
    qo_0_final = where(qo_0_rounded == qo_0_rounded, qo_0_rounded, qo_0)
    qo_1_final = where(qo_1_rounded == qo_1_rounded, qo_1_rounded, qo_1)
    qo_2_final = where(qo_2_rounded == qo_2_rounded, qo_2_rounded, qo_2)
    c_final = where(c_rounded == c_rounded, c_rounded, c)
    return (qo_0_final, qo_1_final, qo_2_final, c_final)


@kernel("(4)->(3)")
def quaternion_log(q):
    """vo = θ v/|v|, θ = 2 atan2(|v|, |w|) <= π: the rotation vector of q, or of any multiple of
    it.

    (4)->(3).  q: quaternion (x, y, z, w), the scalar last; vo: vector.
    151 mul, 271 add, 26 product error, 3 product rest, 9 div, 1 sqrt, 5 neg, 17 abs, 4
    copysign, 27 less, 9 equal, 48 select.  Error <= vo: 1 u of its largest component; searched,
    not proved.  Each component is within 1 ulp as long as its condition is below 1e13; in
    single precision it is the nearest number, except near ties, as long as that is below 1e5;
    searched, not proved.
    """
    q_0, q_1, q_2, q_3 = q
    s_size_0 = absolute(q_0)
    s_size_1 = absolute(q_1)
    s_size_2 = absolute(q_2)
    s_size_3 = absolute(q_3)
    s_largest1 = where(s_size_0 < s_size_1, s_size_1, s_size_0)
    s_largest2 = where(s_largest1 < s_size_2, s_size_2, s_largest1)
    s_largest3 = where(s_largest2 < s_size_3, s_size_3, s_largest2)
    s_d = where(s_largest3 < 256, 1.3093562431584567e+151,
        where(6.703903964971299e+153 < s_largest3, real(3.7291703656001034e-155), real(1)))
    s = where(s_largest3 < 1.955159272639747e-149, 1.0715086071862673e+301, s_d)
    scaled_s_0 = q_0 * s
    scaled_s_1 = q_1 * s
    scaled_s_2 = q_2 * s
    scaled_s_3 = q_3 * s
    upper_0b = scaled_s_3 < 0
    upper_0 = where(upper_0b, -scaled_s_0, scaled_s_0)
    upper_1 = where(upper_0b, -scaled_s_1, scaled_s_1)
    upper_2 = where(upper_0b, -scaled_s_2, scaled_s_2)
    upper_3 = where(upper_0b, -scaled_s_3, scaled_s_3)
    v_s_size_0 = absolute(upper_0)
    v_s_size_1 = absolute(upper_1)
    v_s_size_2 = absolute(upper_2)
    v_s_largest1 = where(v_s_size_0 < v_s_size_1, v_s_size_1, v_s_size_0)
    v_s_largest2 = where(v_s_largest1 < v_s_size_2, v_s_size_2, v_s_largest1)
    v_s = where(v_s_largest2 < 1.955159272639747e-149, 1.0715086071862673e+301,
        where(v_s_largest2 < 256, real(1.3093562431584567e+151), real(1)))
    v_y_0 = upper_0 * v_s
    v_y_1 = upper_1 * v_s
    v_y_2 = upper_2 * v_s
    v_n_a = v_y_0 * v_y_0
    v_n_b = v_y_1 * v_y_1
    v_n_c = v_n_a + v_n_b
    v_n_c_right = v_n_c - v_n_a
    v_n_d = v_y_2 * v_y_2
    v_n_e = v_n_c + v_n_d
    v_n_e_right = v_n_e - v_n_c
    v_n_c_lo = (product_rest(v_y_0, v_y_0, v_n_a, v_n_c - v_n_c_right)
        + product_rest(v_y_1, v_y_1, v_n_b, v_n_c_right))
    v_n_e_lo = (v_n_c - (v_n_e - v_n_e_right) + product_rest(v_y_2, v_y_2, v_n_d, v_n_e_right)
        + v_n_c_lo)
    v_n_e_sum = v_n_e + v_n_e_lo
    v_n_e_sum_right = v_n_e_sum - v_n_e
    v_n = sqrt(v_n_e_sum)
    v_n_product = v_n * v_n
    v_n_residual = (v_n_e_sum - v_n_product - product_error(v_n, v_n, v_n_product)
        + (v_n_e - (v_n_e_sum - v_n_e_sum_right) + (v_n_e_lo - v_n_e_sum_right)))
    v_n_lo = v_n_residual / where(v_n == 0, 1, v_n + v_n)
    v_r = where(1.3093562431584567e+151 < v_s, 9.332636185032189e-302, where(1 < v_s,
        real(7.637340908749012e-152), real(1)))
    v_n_sum = v_n + v_n_lo
    v_n_sum_right = v_n_sum - v_n
    n = v_n_sum * v_r
    n_lo = ((v_n_sum - n * (1 / v_r)
        + (v_n - (v_n_sum - v_n_sum_right) + (v_n_lo - v_n_sum_right))) * v_r)
    n_sum = n + n_lo
    n_sum_right = n_sum - n
    n_sum_lo = n - (n_sum - n_sum_right) + (n_lo - n_sum_right)
    half = elementary.atan2(n_sum, upper_3)
    half_size0 = absolute(n_sum)
    half_size1 = absolute(upper_3)
    half_most = where(half_size0 < half_size1, half_size1, half_size0)
    half_zero = half_most == 0
    half_divisor = where(half_zero, 1, half_most)
    half_part0 = n_sum / half_divisor
    half_part1 = upper_3 / half_divisor
    half_more = ((half_part1 * n_sum_lo - half_part0 * 0)
        / where(half_zero, 1, half_divisor * (half_part1 * half_part1 + half_part0 * half_part0)))
    divisor_a = n_sum == 0
    divisor = where(divisor_a, 1, n_sum)
    divisor_lo = where(divisor_a, 0, n_sum_lo)
    theta = 2 * half
    theta_cross2 = 2 * (elementary.atan2_error(n_sum, upper_3, half) + half_more)
    theta_sum = theta + theta_cross2
    theta_sum_right = theta_sum - theta
    divisor_sum = divisor + divisor_lo
    divisor_sum_right = divisor_sum - divisor
    k = theta_sum / divisor_sum
    k_product = k * divisor_sum
    theta_sum_lo = theta - (theta_sum - theta_sum_right) + (theta_cross2 - theta_sum_right)
    k_cross = k * (divisor - (divisor_sum - divisor_sum_right) + (divisor_lo - divisor_sum_right))
    k_lo = ((theta_sum - k_product - product_error(k, divisor_sum, k_product) + theta_sum_lo
        - k_cross) / divisor_sum)
    vector_0 = upper_0 * k
    vector_1 = upper_1 * k
    vector_2 = upper_2 * k
    vector_0_rounded = vector_0 + (product_error(upper_0, k, vector_0) + upper_0 * k_lo)
    vector_1_rounded = vector_1 + (product_error(upper_1, k, vector_1) + upper_1 * k_lo)
    vector_2_rounded = vector_2 + (product_error(upper_2, k, vector_2) + upper_2 * k_lo)
    vector_0_final = where(vector_0_rounded == vector_0_rounded, vector_0_rounded, vector_0)
    vector_1_final = where(vector_1_rounded == vector_1_rounded, vector_1_rounded, vector_1)
    vector_2_final = where(vector_2_rounded == vector_2_rounded, vector_2_rounded, vector_2)
    return (vector_0_final, vector_1_final, vector_2_final)


@kernel("(4),(4),()->(4)")
def quaternion_interpolated(q1, q2, k):
    """qo = q1 (q1* q2)^k along the shorter arc: q1 at k = 0, ±q2 at k = 1; |q1| = |q2| = 1.

    (4),(4),()->(4).  q1, q2, qo: quaternion (x, y, z, w), the scalar last; k: number.
    371 mul, 774 add, 46 product error, 39 product rest, 16 div, 2 sqrt, 14 neg, 21 abs, 4
    copysign, 36 less, 11 equal, 68 select.  Error <= qo: 1 u of its largest component for |q1|
    = 1 and |q2| = 1 and 0 <= k <= 1; searched, not proved.  Each component is within 1 ulp as
    long as its condition is below 1e13; in single precision it is the nearest number, except
    near ties, as long as that is below 1e5; searched, not proved.
    """
    q1_0, q1_1, q1_2, q1_3 = q1
    q2_0, q2_1, q2_2, q2_3 = q2
    between_0a = q1_3 * q2_0
    between_0b = q1_0 * q2_3
    between_0c = between_0a - between_0b
    between_0c_right = between_0a - between_0c
    between_0d = q1_2 * q2_1
    between_0e = q1_1 * q2_2
    between_0f = between_0d - between_0e
    between_0f_right = between_0d - between_0f
    between_0 = between_0c + between_0f
    between_0_right = between_0 - between_0c
    between_0f_lo = (product_rest(q1_2, q2_1, between_0d, between_0f + between_0f_right)
        - product_rest(q1_1, q2_2, between_0e, between_0f_right))
    between_0c_lo = (product_rest(q1_3, q2_0, between_0a, between_0c + between_0c_right)
        - product_rest(q1_0, q2_3, between_0b, between_0c_right))
    between_0_lo = (between_0c - (between_0 - between_0_right) + (between_0f - between_0_right)
        + between_0f_lo + between_0c_lo)
    between_1a = q1_0 * q2_2
    between_1b = q1_2 * q2_0
    between_1c = between_1a - between_1b
    between_1c_right = between_1a - between_1c
    between_1d = q1_3 * q2_1
    between_1e = q1_1 * q2_3
    between_1f = between_1d - between_1e
    between_1f_right = between_1d - between_1f
    between_1 = between_1c + between_1f
    between_1_right = between_1 - between_1c
    between_1f_lo = (product_rest(q1_3, q2_1, between_1d, between_1f + between_1f_right)
        - product_rest(q1_1, q2_3, between_1e, between_1f_right))
    between_1c_lo = (product_rest(q1_0, q2_2, between_1a, between_1c + between_1c_right)
        - product_rest(q1_2, q2_0, between_1b, between_1c_right))
    between_1_lo = (between_1c - (between_1 - between_1_right) + (between_1f - between_1_right)
        + between_1f_lo + between_1c_lo)
    between_2a = q1_1 * q2_0
    between_2b = q1_0 * q2_1
    between_2c = between_2a - between_2b
    between_2c_right = between_2a - between_2c
    between_2d = q1_3 * q2_2
    between_2e = q1_2 * q2_3
    between_2f = between_2d - between_2e
    between_2f_right = between_2d - between_2f
    between_2 = between_2c + between_2f
    between_2_right = between_2 - between_2c
    between_2f_lo = (product_rest(q1_3, q2_2, between_2d, between_2f + between_2f_right)
        - product_rest(q1_2, q2_3, between_2e, between_2f_right))
    between_2c_lo = (product_rest(q1_1, q2_0, between_2a, between_2c + between_2c_right)
        - product_rest(q1_0, q2_1, between_2b, between_2c_right))
    between_2_lo = (between_2c - (between_2 - between_2_right) + (between_2f - between_2_right)
        + between_2f_lo + between_2c_lo)
    between_3a = q1_0 * q2_0
    between_3b = q1_1 * q2_1
    between_3c = between_3a + between_3b
    between_3c_right = between_3c - between_3a
    between_3d = q1_2 * q2_2
    between_3e = between_3c + between_3d
    between_3e_right = between_3e - between_3c
    between_3c_lo = (product_rest(q1_0, q2_0, between_3a, between_3c - between_3c_right)
        + product_rest(q1_1, q2_1, between_3b, between_3c_right))
    between_3f = q1_3 * q2_3
    between_3 = between_3e + between_3f
    between_3_right = between_3 - between_3e
    between_3e_lo = (between_3c - (between_3e - between_3e_right)
        + product_rest(q1_2, q2_2, between_3d, between_3e_right) + between_3c_lo)
    between_3_lo = (between_3e - (between_3 - between_3_right)
        + product_rest(q1_3, q2_3, between_3f, between_3_right) + between_3e_lo)
    between_3_sum = between_3 + between_3_lo
    between_3_sum_right = between_3_sum - between_3
    between_3_sum_lo = (between_3 - (between_3_sum - between_3_sum_right)
        + (between_3_lo - between_3_sum_right))
    upper_0b = between_3_sum < 0
    upper_0 = where(upper_0b, -between_0, between_0)
    upper_0_lo = where(upper_0b, -between_0_lo, between_0_lo)
    upper_1 = where(upper_0b, -between_1, between_1)
    upper_1_lo = where(upper_0b, -between_1_lo, between_1_lo)
    upper_2 = where(upper_0b, -between_2, between_2)
    upper_2_lo = where(upper_0b, -between_2_lo, between_2_lo)
    upper_3 = absolute(between_3_sum)
    upper_3_lo = where(between_3_sum < 0, -between_3_sum_lo, between_3_sum_lo)
    upper_0_sum = upper_0 + upper_0_lo
    upper_0_sum_right = upper_0_sum - upper_0
    upper_0_sum_lo = upper_0 - (upper_0_sum - upper_0_sum_right) + (upper_0_lo - upper_0_sum_right)
    v_s_size_0 = absolute(upper_0_sum)
    v_s_size_0_lo = where(upper_0_sum < 0, -upper_0_sum_lo, upper_0_sum_lo)
    upper_1_sum = upper_1 + upper_1_lo
    upper_1_sum_right = upper_1_sum - upper_1
    upper_1_sum_lo = upper_1 - (upper_1_sum - upper_1_sum_right) + (upper_1_lo - upper_1_sum_right)
    v_s_size_1 = absolute(upper_1_sum)
    v_s_size_1_lo = where(upper_1_sum < 0, -upper_1_sum_lo, upper_1_sum_lo)
    upper_2_sum = upper_2 + upper_2_lo
    upper_2_sum_right = upper_2_sum - upper_2
    upper_2_sum_lo = upper_2 - (upper_2_sum - upper_2_sum_right) + (upper_2_lo - upper_2_sum_right)
    v_s_size_2 = absolute(upper_2_sum)
    v_s_size_2_lo = where(upper_2_sum < 0, -upper_2_sum_lo, upper_2_sum_lo)
    v_s_size_0_sum = v_s_size_0 + v_s_size_0_lo
    v_s_size_0_sum_right = v_s_size_0_sum - v_s_size_0
    v_s_size_1_sum = v_s_size_1 + v_s_size_1_lo
    v_s_size_1_sum_right = v_s_size_1_sum - v_s_size_1
    v_s_largest1a = v_s_size_0_sum < v_s_size_1_sum
    v_s_largest1 = where(v_s_largest1a, v_s_size_1_sum, v_s_size_0_sum)
    v_s_size_1_sum_lo = (v_s_size_1 - (v_s_size_1_sum - v_s_size_1_sum_right)
        + (v_s_size_1_lo - v_s_size_1_sum_right))
    v_s_size_0_sum_lo = (v_s_size_0 - (v_s_size_0_sum - v_s_size_0_sum_right)
        + (v_s_size_0_lo - v_s_size_0_sum_right))
    v_s_largest1_lo = where(v_s_largest1a, v_s_size_1_sum_lo, v_s_size_0_sum_lo)
    v_s_largest1_sum = v_s_largest1 + v_s_largest1_lo
    v_s_largest1_sum_right = v_s_largest1_sum - v_s_largest1
    v_s_size_2_sum = v_s_size_2 + v_s_size_2_lo
    v_s_size_2_sum_right = v_s_size_2_sum - v_s_size_2
    v_s_largest2a = v_s_largest1_sum < v_s_size_2_sum
    v_s_largest2 = where(v_s_largest2a, v_s_size_2_sum, v_s_largest1_sum)
    v_s_largest1_sum_lo = (v_s_largest1 - (v_s_largest1_sum - v_s_largest1_sum_right)
        + (v_s_largest1_lo - v_s_largest1_sum_right))
    v_s_size_2_sum_lo = (v_s_size_2 - (v_s_size_2_sum - v_s_size_2_sum_right)
        + (v_s_size_2_lo - v_s_size_2_sum_right))
    v_s_largest2_sum = v_s_largest2 + where(v_s_largest2a, v_s_size_2_sum_lo, v_s_largest1_sum_lo)
    v_s_b = where(6.703903964971299e+153 < v_s_largest2_sum, real(3.7291703656001034e-155), real(1))
    v_s = where(v_s_largest2_sum < 1.955159272639747e-149, 1.0715086071862673e+301,
        where(v_s_largest2_sum < 256, 1.3093562431584567e+151, v_s_b))
    v_y_0 = upper_0_sum * v_s
    v_y_0_inverse = 1 / v_s
    v_y_0_lo = (upper_0_sum - v_y_0 * v_y_0_inverse + upper_0_sum_lo) * v_s
    v_y_1 = upper_1_sum * v_s
    v_y_1_lo = (upper_1_sum - v_y_1 * v_y_0_inverse + upper_1_sum_lo) * v_s
    v_y_2 = upper_2_sum * v_s
    v_y_2_lo = (upper_2_sum - v_y_2 * v_y_0_inverse + upper_2_sum_lo) * v_s
    v_n_a = v_y_0 * v_y_0
    v_n_b = v_y_1 * v_y_1
    v_n_c = v_n_a + v_n_b
    v_n_c_right = v_n_c - v_n_a
    v_n_c_lo1 = (product_rest(v_y_0, v_y_0, v_n_a, v_n_c - v_n_c_right)
        + product_rest(v_y_1, v_y_1, v_n_b, v_n_c_right))
    v_n_d = v_y_2 * v_y_2
    v_n_e = v_n_c + v_n_d
    v_n_e_right = v_n_e - v_n_c
    v_n_e_lo2 = (v_n_c - (v_n_e - v_n_e_right) + product_rest(v_y_2, v_y_2, v_n_d, v_n_e_right)
        + (v_y_2_lo * v_y_2 + v_y_2 * v_y_2_lo))
    v_n_e_lo = (v_n_e_lo2
        + (v_n_c_lo1
        + (v_y_0_lo * v_y_0 + v_y_0 * v_y_0_lo + (v_y_1_lo * v_y_1 + v_y_1 * v_y_1_lo))))
    v_n_e_sum = v_n_e + v_n_e_lo
    v_n_e_sum_right = v_n_e_sum - v_n_e
    v_n = sqrt(v_n_e_sum)
    v_n_product = v_n * v_n
    v_n_residual = (v_n_e_sum - v_n_product - product_error(v_n, v_n, v_n_product)
        + (v_n_e - (v_n_e_sum - v_n_e_sum_right) + (v_n_e_lo - v_n_e_sum_right)))
    v_n_lo = v_n_residual / where(v_n == 0, 1, v_n + v_n)
    v_r_d = where(1 < v_s, 7.637340908749012e-152, where(v_s < 1, real(2.6815615859885194e+154),
        real(1)))
    v_r = where(1.3093562431584567e+151 < v_s, 9.332636185032189e-302, v_r_d)
    v_n_sum = v_n + v_n_lo
    v_n_sum_right = v_n_sum - v_n
    n = v_n_sum * v_r
    n_lo = ((v_n_sum - n * (1 / v_r)
        + (v_n - (v_n_sum - v_n_sum_right) + (v_n_lo - v_n_sum_right))) * v_r)
    n_sum = n + n_lo
    n_sum_right = n_sum - n
    n_sum_lo = n - (n_sum - n_sum_right) + (n_lo - n_sum_right)
    upper_3_sum = upper_3 + upper_3_lo
    upper_3_sum_right = upper_3_sum - upper_3
    half = elementary.atan2(n_sum, upper_3_sum)
    half_size0 = absolute(n_sum)
    half_size1 = absolute(upper_3_sum)
    half_most = where(half_size0 < half_size1, half_size1, half_size0)
    half_zero = half_most == 0
    half_divisor = where(half_zero, 1, half_most)
    half_part0 = n_sum / half_divisor
    half_part1 = upper_3_sum / half_divisor
    half_cross = (half_part1 * n_sum_lo - half_part0
        * (upper_3 - (upper_3_sum - upper_3_sum_right) + (upper_3_lo - upper_3_sum_right)))
    half_more = (half_cross
        / where(half_zero, 1, half_divisor * (half_part1 * half_part1 + half_part0 * half_part0)))
    half_lo = elementary.atan2_error(n_sum, upper_3_sum, half) + half_more
    divisor_a = n_sum == 0
    divisor = where(divisor_a, 1, n_sum)
    divisor_lo = where(divisor_a, 0, n_sum_lo)
    half_sum = half + half_lo
    half_sum_right = half_sum - half
    divisor_sum = divisor + divisor_lo
    divisor_sum_right = divisor_sum - divisor
    rate = half_sum / divisor_sum
    rate_product = rate * divisor_sum
    rate_exact = half_sum - rate_product - product_error(rate, divisor_sum, rate_product)
    rate_cross = (rate
        * (divisor - (divisor_sum - divisor_sum_right) + (divisor_lo - divisor_sum_right)))
    rate_lo = ((rate_exact + (half - (half_sum - half_sum_right) + (half_lo - half_sum_right))
        - rate_cross) / divisor_sum)
    kv_0 = k * upper_0_sum
    kv_1 = k * upper_1_sum
    kv_2 = k * upper_2_sum
    step_0 = rate * kv_0
    step_1 = rate * kv_1
    step_2 = rate * kv_2
    step_0_lo = (product_error(rate, kv_0, step_0)
        + (rate_lo * kv_0 + rate * (product_error(k, upper_0_sum, kv_0) + k * upper_0_sum_lo)))
    step_0_sum = step_0 + step_0_lo
    step_0_sum_right = step_0_sum - step_0
    step_0_sum_lo = step_0 - (step_0_sum - step_0_sum_right) + (step_0_lo - step_0_sum_right)
    exp_h_size_0 = absolute(step_0_sum)
    exp_h_size_0_lo = where(step_0_sum < 0, -step_0_sum_lo, step_0_sum_lo)
    step_1_lo = (product_error(rate, kv_1, step_1)
        + (rate_lo * kv_1 + rate * (product_error(k, upper_1_sum, kv_1) + k * upper_1_sum_lo)))
    step_1_sum = step_1 + step_1_lo
    step_1_sum_right = step_1_sum - step_1
    step_1_sum_lo = step_1 - (step_1_sum - step_1_sum_right) + (step_1_lo - step_1_sum_right)
    exp_h_size_1 = absolute(step_1_sum)
    exp_h_size_1_lo = where(step_1_sum < 0, -step_1_sum_lo, step_1_sum_lo)
    step_2_lo = (product_error(rate, kv_2, step_2)
        + (rate_lo * kv_2 + rate * (product_error(k, upper_2_sum, kv_2) + k * upper_2_sum_lo)))
    step_2_sum = step_2 + step_2_lo
    step_2_sum_right = step_2_sum - step_2
    step_2_sum_lo = step_2 - (step_2_sum - step_2_sum_right) + (step_2_lo - step_2_sum_right)
    exp_h_size_2 = absolute(step_2_sum)
    exp_h_size_2_lo = where(step_2_sum < 0, -step_2_sum_lo, step_2_sum_lo)
    exp_h_size_0_sum = exp_h_size_0 + exp_h_size_0_lo
    exp_h_size_0_sum_right = exp_h_size_0_sum - exp_h_size_0
    exp_h_size_1_sum = exp_h_size_1 + exp_h_size_1_lo
    exp_h_size_1_sum_right = exp_h_size_1_sum - exp_h_size_1
    exp_h_largest1a = exp_h_size_0_sum < exp_h_size_1_sum
    exp_h_largest1 = where(exp_h_largest1a, exp_h_size_1_sum, exp_h_size_0_sum)
    exp_h_size_1_sum_lo = (exp_h_size_1 - (exp_h_size_1_sum - exp_h_size_1_sum_right)
        + (exp_h_size_1_lo - exp_h_size_1_sum_right))
    exp_h_size_0_sum_lo = (exp_h_size_0 - (exp_h_size_0_sum - exp_h_size_0_sum_right)
        + (exp_h_size_0_lo - exp_h_size_0_sum_right))
    exp_h_largest1_lo = where(exp_h_largest1a, exp_h_size_1_sum_lo, exp_h_size_0_sum_lo)
    exp_h_largest1_sum = exp_h_largest1 + exp_h_largest1_lo
    exp_h_largest1_sum_right = exp_h_largest1_sum - exp_h_largest1
    exp_h_size_2_sum = exp_h_size_2 + exp_h_size_2_lo
    exp_h_size_2_sum_right = exp_h_size_2_sum - exp_h_size_2
    exp_h_largest2a = exp_h_largest1_sum < exp_h_size_2_sum
    exp_h_largest2 = where(exp_h_largest2a, exp_h_size_2_sum, exp_h_largest1_sum)
    exp_h_largest1_sum_lo = (exp_h_largest1 - (exp_h_largest1_sum - exp_h_largest1_sum_right)
        + (exp_h_largest1_lo - exp_h_largest1_sum_right))
    exp_h_size_2_sum_lo = (exp_h_size_2 - (exp_h_size_2_sum - exp_h_size_2_sum_right)
        + (exp_h_size_2_lo - exp_h_size_2_sum_right))
    exp_s_a = (6.703903964971299e+153 < exp_h_largest2
        + where(exp_h_largest2a, exp_h_size_2_sum_lo, exp_h_largest1_sum_lo))
    exp_s = where(exp_s_a, real(3.7291703656001034e-155), real(1))
    exp_reduced_0 = step_0_sum * exp_s
    exp_reduced_0_inverse = 1 / exp_s
    exp_reduced_0_lo = (step_0_sum - exp_reduced_0 * exp_reduced_0_inverse + step_0_sum_lo) * exp_s
    exp_reduced_1 = step_1_sum * exp_s
    exp_reduced_1_lo = (step_1_sum - exp_reduced_1 * exp_reduced_0_inverse + step_1_sum_lo) * exp_s
    exp_reduced_2 = step_2_sum * exp_s
    exp_reduced_2_lo = (step_2_sum - exp_reduced_2 * exp_reduced_0_inverse + step_2_sum_lo) * exp_s
    exp_up = where(exp_s < 1, real(2.6815615859885194e+154), real(1))
    exp_reduced_length_a = exp_reduced_0 * exp_reduced_0
    exp_reduced_length_b = exp_reduced_1 * exp_reduced_1
    exp_reduced_length_c = exp_reduced_length_a + exp_reduced_length_b
    exp_reduced_length_c_right = exp_reduced_length_c - exp_reduced_length_a
    exp_reduced_length_a_cross = exp_reduced_0_lo * exp_reduced_0 + exp_reduced_0 * exp_reduced_0_lo
    exp_reduced_length_c_left_rest = product_rest(exp_reduced_0, exp_reduced_0,
        exp_reduced_length_a, exp_reduced_length_c - exp_reduced_length_c_right)
    exp_reduced_length_c_right_rest = product_rest(exp_reduced_1, exp_reduced_1,
        exp_reduced_length_b, exp_reduced_length_c_right)
    exp_reduced_length_c_cross = (exp_reduced_length_a_cross
        + (exp_reduced_1_lo * exp_reduced_1 + exp_reduced_1 * exp_reduced_1_lo))
    exp_reduced_length_d = exp_reduced_2 * exp_reduced_2
    exp_reduced_length_e = exp_reduced_length_c + exp_reduced_length_d
    exp_reduced_length_e_right = exp_reduced_length_e - exp_reduced_length_c
    exp_reduced_length_e_right_rest = product_rest(exp_reduced_2, exp_reduced_2,
        exp_reduced_length_d, exp_reduced_length_e_right)
    exp_reduced_length_e_lo1 = (exp_reduced_length_c
        - (exp_reduced_length_e - exp_reduced_length_e_right) + exp_reduced_length_e_right_rest)
    exp_reduced_length_e_lo2 = (exp_reduced_length_e_lo1
        + (exp_reduced_2_lo * exp_reduced_2 + exp_reduced_2 * exp_reduced_2_lo))
    exp_reduced_length_e_lo = (exp_reduced_length_e_lo2
        + (exp_reduced_length_c_left_rest + exp_reduced_length_c_right_rest
        + exp_reduced_length_c_cross))
    exp_reduced_length_e_sum = exp_reduced_length_e + exp_reduced_length_e_lo
    exp_reduced_length_e_sum_right = exp_reduced_length_e_sum - exp_reduced_length_e
    exp_reduced_length_e_sum_left_rest = (exp_reduced_length_e
        - (exp_reduced_length_e_sum - exp_reduced_length_e_sum_right))
    exp_reduced_length = sqrt(exp_reduced_length_e_sum)
    exp_reduced_length_product = exp_reduced_length * exp_reduced_length
    exp_reduced_length_product_error = product_error(exp_reduced_length, exp_reduced_length,
        exp_reduced_length_product)
    exp_reduced_length_e_sum_lo = (exp_reduced_length_e_sum_left_rest
        + (exp_reduced_length_e_lo - exp_reduced_length_e_sum_right))
    exp_reduced_length_residual = (exp_reduced_length_e_sum - exp_reduced_length_product
        - exp_reduced_length_product_error + exp_reduced_length_e_sum_lo)
    exp_reduced_length_lo = (exp_reduced_length_residual
        / where(exp_reduced_length == 0, 1, exp_reduced_length + exp_reduced_length))
    exp_reduced_length_sum = exp_reduced_length + exp_reduced_length_lo
    exp_reduced_length_sum_right = exp_reduced_length_sum - exp_reduced_length
    exp_reduced_length_sum_left_rest = (exp_reduced_length
        - (exp_reduced_length_sum - exp_reduced_length_sum_right))
    exp_half_angle = exp_reduced_length_sum * exp_up
    exp_reduced_length_sum_lo = (exp_reduced_length_sum_left_rest
        + (exp_reduced_length_lo - exp_reduced_length_sum_right))
    exp_half_angle_lo = ((exp_reduced_length_sum - exp_half_angle * (1 / exp_up)
        + exp_reduced_length_sum_lo) * exp_up)
    exp_y = exp_half_angle * exp_half_angle
    exp_half_angle_sum = exp_half_angle + exp_half_angle_lo
    exp_half_angle_sum_right = exp_half_angle_sum - exp_half_angle
    exp_half_angle_sum_lo = (exp_half_angle - (exp_half_angle_sum - exp_half_angle_sum_right)
        + (exp_half_angle_lo - exp_half_angle_sum_right))
    exp_sine, exp_c = elementary.sincos(exp_half_angle_sum)
    exp_sine_own_error, exp_c_own_error = elementary.sincos_error(exp_half_angle_sum, exp_sine,
        exp_c)
    exp_sine_half = exp_half_angle_sum_lo * 0.5
    exp_sine_half_sin, exp_sine_half_cos = elementary.sincos(exp_sine_half)
    exp_sine_twice = exp_sine_half_sin + exp_sine_half_sin
    exp_sine_lo = (exp_sine_own_error + (exp_sine_half_cos * exp_c - exp_sine_half_sin * exp_sine)
        * exp_sine_twice)
    exp_c_lo = (exp_c_own_error - (exp_sine_half_cos * exp_sine + exp_sine_half_sin * exp_c)
        * exp_sine_twice)
    exp_sinc_divisor_a = exp_half_angle_sum < 1.4901161193847656e-08
    exp_sinc_divisor = where(exp_sinc_divisor_a, 1.4901161193847656e-08, exp_half_angle_sum)
    exp_sinc_divisor_lo = where(exp_sinc_divisor_a, 0, exp_half_angle_sum_lo)
    exp_sine_sum = exp_sine + exp_sine_lo
    exp_sine_sum_right = exp_sine_sum - exp_sine
    exp_sinc_divisor_sum = exp_sinc_divisor + exp_sinc_divisor_lo
    exp_sinc_divisor_sum_right = exp_sinc_divisor_sum - exp_sinc_divisor
    exp_sinc_quotient = exp_sine_sum / exp_sinc_divisor_sum
    exp_sinc_quotient_product = exp_sinc_quotient * exp_sinc_divisor_sum
    exp_sinc_quotient_exact = (exp_sine_sum - exp_sinc_quotient_product
        - product_error(exp_sinc_quotient, exp_sinc_divisor_sum, exp_sinc_quotient_product))
    exp_sinc_divisor_sum_lo = (exp_sinc_divisor
        - (exp_sinc_divisor_sum - exp_sinc_divisor_sum_right)
        + (exp_sinc_divisor_lo - exp_sinc_divisor_sum_right))
    exp_sinc_quotient_numerator = (exp_sinc_quotient_exact
        + (exp_sine - (exp_sine_sum - exp_sine_sum_right) + (exp_sine_lo - exp_sine_sum_right)))
    exp_sinc_a = 0.16666666666666666 * exp_y
    exp_y_lo = (product_error(exp_half_angle, exp_half_angle, exp_y)
        + (exp_half_angle_lo * exp_half_angle + exp_half_angle * exp_half_angle_lo))
    exp_sinc_b = 1 - exp_sinc_a
    exp_sinc_b_right = 1 - exp_sinc_b
    exp_sinc_b_lo1 = (1 - (exp_sinc_b + exp_sinc_b_right)
        - product_rest(0.16666666666666666, exp_y, exp_sinc_a, exp_sinc_b_right))
    exp_sinc = where(exp_sinc_divisor_a, exp_sinc_b, exp_sinc_quotient)
    exp_sinc_quotient_lo = ((exp_sinc_quotient_numerator - exp_sinc_quotient
        * exp_sinc_divisor_sum_lo) / exp_sinc_divisor_sum)
    exp_sinc_lo = where(exp_sinc_divisor_a,
        exp_sinc_b_lo1 - (9.25185853854297e-18 * exp_y + 0.16666666666666666 * exp_y_lo),
        exp_sinc_quotient_lo)
    power_0 = step_0_sum * exp_sinc
    power_1 = step_1_sum * exp_sinc
    power_2 = step_2_sum * exp_sinc
    qo_0a = q1_0 * exp_c
    power_2_lo = (product_error(step_2_sum, exp_sinc, power_2)
        + (step_2_sum_lo * exp_sinc + step_2_sum * exp_sinc_lo))
    qo_0b = q1_1 * power_2
    power_1_lo = (product_error(step_1_sum, exp_sinc, power_1)
        + (step_1_sum_lo * exp_sinc + step_1_sum * exp_sinc_lo))
    qo_0c = q1_2 * power_1
    qo_0d = qo_0b - qo_0c
    qo_0d_right = qo_0b - qo_0d
    qo_0d_lo1 = (product_rest(q1_1, power_2, qo_0b, qo_0d + qo_0d_right)
        - product_rest(q1_2, power_1, qo_0c, qo_0d_right))
    qo_0e = qo_0a + qo_0d
    qo_0e_right = qo_0e - qo_0a
    qo_0e_lo2 = (product_rest(q1_0, exp_c, qo_0a, qo_0e - qo_0e_right) + (qo_0d - qo_0e_right)
        + (qo_0d_lo1 + (q1_1 * power_2_lo - q1_2 * power_1_lo)))
    power_0_lo = (product_error(step_0_sum, exp_sinc, power_0)
        + (step_0_sum_lo * exp_sinc + step_0_sum * exp_sinc_lo))
    qo_0f = q1_3 * power_0
    qo_0 = qo_0e + qo_0f
    qo_0_right = qo_0 - qo_0e
    qo_1a = q1_2 * power_0
    qo_1b = q1_0 * power_2
    qo_1c = qo_1a - qo_1b
    qo_1c_right = qo_1a - qo_1c
    qo_1c_lo1 = (product_rest(q1_2, power_0, qo_1a, qo_1c + qo_1c_right)
        - product_rest(q1_0, power_2, qo_1b, qo_1c_right))
    qo_1d = q1_1 * exp_c
    qo_1e = qo_1c + qo_1d
    qo_1e_right = qo_1e - qo_1c
    qo_1e_lo2 = (qo_1c - (qo_1e - qo_1e_right) + product_rest(q1_1, exp_c, qo_1d, qo_1e_right)
        + q1_1 * exp_c_lo)
    qo_1f = q1_3 * power_1
    qo_1 = qo_1e + qo_1f
    qo_1_right = qo_1 - qo_1e
    qo_1_lo2 = (qo_1e - (qo_1 - qo_1_right) + product_rest(q1_3, power_1, qo_1f, qo_1_right) + q1_3
        * power_1_lo)
    qo_2a = q1_0 * power_1
    qo_2b = q1_1 * power_0
    qo_2c = qo_2a - qo_2b
    qo_2c_right = qo_2a - qo_2c
    qo_2c_lo1 = (product_rest(q1_0, power_1, qo_2a, qo_2c + qo_2c_right)
        - product_rest(q1_1, power_0, qo_2b, qo_2c_right))
    qo_2d = q1_2 * exp_c
    qo_2e = qo_2c + qo_2d
    qo_2e_right = qo_2e - qo_2c
    qo_2e_lo2 = (qo_2c - (qo_2e - qo_2e_right) + product_rest(q1_2, exp_c, qo_2d, qo_2e_right)
        + q1_2 * exp_c_lo)
    qo_2f = q1_3 * power_2
    qo_2 = qo_2e + qo_2f
    qo_2_right = qo_2 - qo_2e
    qo_2_lo2 = (qo_2e - (qo_2 - qo_2_right) + product_rest(q1_3, power_2, qo_2f, qo_2_right) + q1_3
        * power_2_lo)
    qo_3a = q1_3 * exp_c
    qo_3b = q1_0 * power_0
    qo_3c = q1_1 * power_1
    qo_3d = qo_3b + qo_3c
    qo_3d_right = qo_3d - qo_3b
    qo_3d_lo1 = (product_rest(q1_0, power_0, qo_3b, qo_3d - qo_3d_right)
        + product_rest(q1_1, power_1, qo_3c, qo_3d_right))
    qo_3e = q1_2 * power_2
    qo_3f = qo_3d + qo_3e
    qo_3f_right = qo_3f - qo_3d
    qo_3f_lo2 = (qo_3d - (qo_3f - qo_3f_right) + product_rest(q1_2, power_2, qo_3e, qo_3f_right)
        + q1_2 * power_2_lo)
    qo_3 = qo_3a - qo_3f
    qo_3_right = qo_3a - qo_3
    qo_3_lo1 = product_rest(q1_3, exp_c, qo_3a, qo_3 + qo_3_right) - (qo_3f - qo_3_right)
    qo_0_lo = (qo_0e - (qo_0 - qo_0_right) + product_rest(q1_3, power_0, qo_0f, qo_0_right) + q1_3
        * power_0_lo + (qo_0e_lo2 + q1_0 * exp_c_lo))
    qo_0_rounded = qo_0 + qo_0_lo
    qo_1_rounded = (qo_1
        + (qo_1_lo2 + (qo_1e_lo2 + (qo_1c_lo1 + (q1_2 * power_0_lo - q1_0 * power_2_lo)))))
    qo_2_rounded = (qo_2
        + (qo_2_lo2 + (qo_2e_lo2 + (qo_2c_lo1 + (q1_0 * power_1_lo - q1_1 * power_0_lo)))))
    qo_3_rounded = (qo_3
        + (qo_3_lo1 - (qo_3f_lo2 + (qo_3d_lo1 + (q1_0 * power_0_lo + q1_1 * power_1_lo))) + q1_3
        * exp_c_lo))
    qo_0_final = where(qo_0_rounded == qo_0_rounded, qo_0_rounded, qo_0)
    qo_1_final = where(qo_1_rounded == qo_1_rounded, qo_1_rounded, qo_1)
    qo_2_final = where(qo_2_rounded == qo_2_rounded, qo_2_rounded, qo_2)
    qo_3_final = where(qo_3_rounded == qo_3_rounded, qo_3_rounded, qo_3)
    return (qo_0_final, qo_1_final, qo_2_final, qo_3_final)
