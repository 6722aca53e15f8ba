# Made by `coscrew generate`; changes are overwritten.
"""Quaternions q = (w; v): products, rotations, conversions, interpolation.

In double precision, accurate tier.
"""

from numpy import absolute, arctan2, float64, sqrt, where
from coscrew._exact import difference_error, product_error, sum_error
from coscrew._kernel import double_kernel as kernel


@kernel("(4),()->(4)")
def quaternion_scale(self, a):
    """self = a self.

    (4),()->(4).  self: quaternion (w; x, y, z), the scalar first; a: number.
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


@kernel("(4)->()")
def quaternion_norm(q):
    """|q| = sqrt(w^2 + v·v).

    (4)->().  q: quaternion (w; x, y, z), the scalar first; norm: number.
    12 mul, 18 add, 5 product error, 5 sum error, 2 div, 1 sqrt, 4 abs, 7 less, 3 equal, 10
    select.
    """
    q_0, q_1, q_2, q_3 = q
    s_size_0 = absolute(q_0)
    s_size_1 = absolute(q_1)
    s_size_2 = absolute(q_2)
    s_size_3 = absolute(q_3)
    s_largest1 = where(s_size_0 < s_size_1, s_size_1, s_size_0)
    s_largest2 = where(s_largest1 < s_size_2, s_size_2, s_largest1)
    s_largest3 = where(s_largest2 < s_size_3, s_size_3, s_largest2)
    s_b = where(6.703903964971299e+153 < s_largest3, float64(3.7291703656001034e-155), float64(1))
    s = where(s_largest3 < 3.4395525670743494e-136, 4.149515568880993e+180, s_b)
    y_0 = q_0 * s
    y_1 = q_1 * s
    y_2 = q_2 * s
    y_3 = q_3 * s
    n_a = y_0 * y_0
    n_b = y_1 * y_1
    n_c = n_a + n_b
    n_c_lo = sum_error(n_a, n_b, n_c) + product_error(y_0, y_0, n_a) + product_error(y_1, y_1, n_b)
    n_d = y_2 * y_2
    n_e = n_c + n_d
    n_e_lo1 = sum_error(n_c, n_d, n_e) + n_c_lo
    n_e_lo = n_e_lo1 + product_error(y_2, y_2, n_d)
    n_f = y_3 * y_3
    n_g = n_e + n_f
    n_g_lo1 = sum_error(n_e, n_f, n_g) + n_e_lo
    n_g_lo = n_g_lo1 + product_error(y_3, y_3, n_f)
    n_of_n_g = n_g + n_g_lo
    n = sqrt(n_of_n_g)
    n_product = n * n
    n_exact = n_of_n_g - n_product - product_error(n, n, n_product)
    n_residual = n_exact + sum_error(n_g, n_g_lo, n_of_n_g)
    n_lo = n_residual / where(n == 0, 1, n + n)
    r_b = where(s < 1, float64(2.6815615859885194e+154), float64(1))
    r = where(1 < s, 2.409919865102884e-181, r_b)
    norm_of_n = n + n_lo
    norm = norm_of_n * r
    norm_lost = norm_of_n - norm * (1 / r)
    norm_total = norm + where(norm_lost == 0, 0, (norm_lost + sum_error(n, n_lo, norm_of_n)) * r)
    norm_rounded = where(norm_total == norm_total, norm_total, norm)
    return norm_rounded


@kernel("(4)->(4)")
def quaternion_normalize(self):
    """self = self / |self|; zero stays zero.

    (4)->(4).  self: quaternion (w; x, y, z), the scalar first.
    33 mul, 43 add, 9 product error, 9 sum error, 10 div, 1 sqrt, 4 abs, 7 less, 10 equal, 18
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
    s = where(s_largest3 < 3.4395525670743494e-136, 4.149515568880993e+180, s_b)
    y_0 = self_0 * s
    y_1 = self_1 * s
    y_2 = self_2 * s
    y_3 = self_3 * s
    n_a = y_0 * y_0
    n_b = y_1 * y_1
    n_c = n_a + n_b
    n_c_lo = sum_error(n_a, n_b, n_c) + product_error(y_0, y_0, n_a) + product_error(y_1, y_1, n_b)
    n_d = y_2 * y_2
    n_e = n_c + n_d
    n_e_lo1 = sum_error(n_c, n_d, n_e) + n_c_lo
    n_e_lo = n_e_lo1 + product_error(y_2, y_2, n_d)
    n_f = y_3 * y_3
    n_g = n_e + n_f
    n_g_lo1 = sum_error(n_e, n_f, n_g) + n_e_lo
    n_g_lo = n_g_lo1 + product_error(y_3, y_3, n_f)
    n_of_n_g = n_g + n_g_lo
    n = sqrt(n_of_n_g)
    n_product = n * n
    n_exact = n_of_n_g - n_product - product_error(n, n, n_product)
    n_residual = n_exact + sum_error(n_g, n_g_lo, n_of_n_g)
    n_lo = n_residual / where(n == 0, 1, n + n)
    divisor = where(n == 0, 1, n)
    divisor_lo = where(n == 0, 0, n_lo)
    up = where(1 < s, s, 1)
    down = where(s < 1, s, 1)
    enlarged_0 = self_0 * up
    enlarged_1 = self_1 * up
    enlarged_2 = self_2 * up
    enlarged_3 = self_3 * up
    quotient_0_of_divisor = divisor + divisor_lo
    quotient_0_of_divisor_lo = sum_error(divisor, divisor_lo, quotient_0_of_divisor)
    quotient_0 = enlarged_0 / quotient_0_of_divisor
    quotient_0_product = quotient_0 * quotient_0_of_divisor
    quotient_0_product_error = product_error(quotient_0, quotient_0_of_divisor, quotient_0_product)
    quotient_0_exact = enlarged_0 - quotient_0_product - quotient_0_product_error
    quotient_0_residual = quotient_0_exact - quotient_0 * quotient_0_of_divisor_lo
    quotient_0_lo = quotient_0_residual / quotient_0_of_divisor
    quotient_1 = enlarged_1 / quotient_0_of_divisor
    quotient_1_product = quotient_1 * quotient_0_of_divisor
    quotient_1_product_error = product_error(quotient_1, quotient_0_of_divisor, quotient_1_product)
    quotient_1_exact = enlarged_1 - quotient_1_product - quotient_1_product_error
    quotient_1_residual = quotient_1_exact - quotient_1 * quotient_0_of_divisor_lo
    quotient_1_lo = quotient_1_residual / quotient_0_of_divisor
    quotient_2 = enlarged_2 / quotient_0_of_divisor
    quotient_2_product = quotient_2 * quotient_0_of_divisor
    quotient_2_product_error = product_error(quotient_2, quotient_0_of_divisor, quotient_2_product)
    quotient_2_exact = enlarged_2 - quotient_2_product - quotient_2_product_error
    quotient_2_residual = quotient_2_exact - quotient_2 * quotient_0_of_divisor_lo
    quotient_2_lo = quotient_2_residual / quotient_0_of_divisor
    quotient_3 = enlarged_3 / quotient_0_of_divisor
    quotient_3_product = quotient_3 * quotient_0_of_divisor
    quotient_3_product_error = product_error(quotient_3, quotient_0_of_divisor, quotient_3_product)
    quotient_3_exact = enlarged_3 - quotient_3_product - quotient_3_product_error
    quotient_3_residual = quotient_3_exact - quotient_3 * quotient_0_of_divisor_lo
    quotient_3_lo = quotient_3_residual / quotient_0_of_divisor
    self_0_new_of_quotient_0 = quotient_0 + quotient_0_lo
    self_0_new_of_quotient_0_lo = sum_error(quotient_0, quotient_0_lo, self_0_new_of_quotient_0)
    self_0_new = self_0_new_of_quotient_0 * down
    self_0_new_inverse = 1 / down
    self_0_new_lost = self_0_new_of_quotient_0 - self_0_new * self_0_new_inverse
    self_0_new_rest = self_0_new_lost + self_0_new_of_quotient_0_lo
    self_0_new_small = self_0_new_rest * down
    self_0_new_lo = where(self_0_new_lost == 0, 0, self_0_new_small)
    self_1_new_of_quotient_1 = quotient_1 + quotient_1_lo
    self_1_new_of_quotient_1_lo = sum_error(quotient_1, quotient_1_lo, self_1_new_of_quotient_1)
    self_1_new = self_1_new_of_quotient_1 * down
    self_1_new_lost = self_1_new_of_quotient_1 - self_1_new * self_0_new_inverse
    self_1_new_rest = self_1_new_lost + self_1_new_of_quotient_1_lo
    self_1_new_small = self_1_new_rest * down
    self_1_new_lo = where(self_1_new_lost == 0, 0, self_1_new_small)
    self_2_new_of_quotient_2 = quotient_2 + quotient_2_lo
    self_2_new_of_quotient_2_lo = sum_error(quotient_2, quotient_2_lo, self_2_new_of_quotient_2)
    self_2_new = self_2_new_of_quotient_2 * down
    self_2_new_lost = self_2_new_of_quotient_2 - self_2_new * self_0_new_inverse
    self_2_new_rest = self_2_new_lost + self_2_new_of_quotient_2_lo
    self_2_new_small = self_2_new_rest * down
    self_2_new_lo = where(self_2_new_lost == 0, 0, self_2_new_small)
    self_3_new_of_quotient_3 = quotient_3 + quotient_3_lo
    self_3_new_of_quotient_3_lo = sum_error(quotient_3, quotient_3_lo, self_3_new_of_quotient_3)
    self_3_new = self_3_new_of_quotient_3 * down
    self_3_new_lost = self_3_new_of_quotient_3 - self_3_new * self_0_new_inverse
    self_3_new_rest = self_3_new_lost + self_3_new_of_quotient_3_lo
    self_3_new_small = self_3_new_rest * down
    self_3_new_lo = where(self_3_new_lost == 0, 0, self_3_new_small)
    self_0_new_total = self_0_new + self_0_new_lo
    self_0_new_rounded = where(self_0_new_total == self_0_new_total, self_0_new_total, self_0_new)
    self_1_new_total = self_1_new + self_1_new_lo
    self_1_new_rounded = where(self_1_new_total == self_1_new_total, self_1_new_total, self_1_new)
    self_2_new_total = self_2_new + self_2_new_lo
    self_2_new_rounded = where(self_2_new_total == self_2_new_total, self_2_new_total, self_2_new)
    self_3_new_total = self_3_new + self_3_new_lo
    self_3_new_rounded = where(self_3_new_total == self_3_new_total, self_3_new_total, self_3_new)
    return (self_0_new_rounded, self_1_new_rounded, self_2_new_rounded, self_3_new_rounded)


@kernel("(4)->(4)")
def quaternion_normalized(q):
    """qo = q / |q|; zero stays zero.

    (4)->(4).  q, qo: quaternion (w; x, y, z), the scalar first.
    33 mul, 43 add, 9 product error, 9 sum error, 10 div, 1 sqrt, 4 abs, 7 less, 10 equal, 18
    select.
    """
    q_0, q_1, q_2, q_3 = q
    s_size_0 = absolute(q_0)
    s_size_1 = absolute(q_1)
    s_size_2 = absolute(q_2)
    s_size_3 = absolute(q_3)
    s_largest1 = where(s_size_0 < s_size_1, s_size_1, s_size_0)
    s_largest2 = where(s_largest1 < s_size_2, s_size_2, s_largest1)
    s_largest3 = where(s_largest2 < s_size_3, s_size_3, s_largest2)
    s_b = where(6.703903964971299e+153 < s_largest3, float64(3.7291703656001034e-155), float64(1))
    s = where(s_largest3 < 3.4395525670743494e-136, 4.149515568880993e+180, s_b)
    y_0 = q_0 * s
    y_1 = q_1 * s
    y_2 = q_2 * s
    y_3 = q_3 * s
    n_a = y_0 * y_0
    n_b = y_1 * y_1
    n_c = n_a + n_b
    n_c_lo = sum_error(n_a, n_b, n_c) + product_error(y_0, y_0, n_a) + product_error(y_1, y_1, n_b)
    n_d = y_2 * y_2
    n_e = n_c + n_d
    n_e_lo1 = sum_error(n_c, n_d, n_e) + n_c_lo
    n_e_lo = n_e_lo1 + product_error(y_2, y_2, n_d)
    n_f = y_3 * y_3
    n_g = n_e + n_f
    n_g_lo1 = sum_error(n_e, n_f, n_g) + n_e_lo
    n_g_lo = n_g_lo1 + product_error(y_3, y_3, n_f)
    n_of_n_g = n_g + n_g_lo
    n = sqrt(n_of_n_g)
    n_product = n * n
    n_exact = n_of_n_g - n_product - product_error(n, n, n_product)
    n_residual = n_exact + sum_error(n_g, n_g_lo, n_of_n_g)
    n_lo = n_residual / where(n == 0, 1, n + n)
    divisor = where(n == 0, 1, n)
    divisor_lo = where(n == 0, 0, n_lo)
    up = where(1 < s, s, 1)
    down = where(s < 1, s, 1)
    enlarged_0 = q_0 * up
    enlarged_1 = q_1 * up
    enlarged_2 = q_2 * up
    enlarged_3 = q_3 * up
    quotient_0_of_divisor = divisor + divisor_lo
    quotient_0_of_divisor_lo = sum_error(divisor, divisor_lo, quotient_0_of_divisor)
    quotient_0 = enlarged_0 / quotient_0_of_divisor
    quotient_0_product = quotient_0 * quotient_0_of_divisor
    quotient_0_product_error = product_error(quotient_0, quotient_0_of_divisor, quotient_0_product)
    quotient_0_exact = enlarged_0 - quotient_0_product - quotient_0_product_error
    quotient_0_residual = quotient_0_exact - quotient_0 * quotient_0_of_divisor_lo
    quotient_0_lo = quotient_0_residual / quotient_0_of_divisor
    quotient_1 = enlarged_1 / quotient_0_of_divisor
    quotient_1_product = quotient_1 * quotient_0_of_divisor
    quotient_1_product_error = product_error(quotient_1, quotient_0_of_divisor, quotient_1_product)
    quotient_1_exact = enlarged_1 - quotient_1_product - quotient_1_product_error
    quotient_1_residual = quotient_1_exact - quotient_1 * quotient_0_of_divisor_lo
    quotient_1_lo = quotient_1_residual / quotient_0_of_divisor
    quotient_2 = enlarged_2 / quotient_0_of_divisor
    quotient_2_product = quotient_2 * quotient_0_of_divisor
    quotient_2_product_error = product_error(quotient_2, quotient_0_of_divisor, quotient_2_product)
    quotient_2_exact = enlarged_2 - quotient_2_product - quotient_2_product_error
    quotient_2_residual = quotient_2_exact - quotient_2 * quotient_0_of_divisor_lo
    quotient_2_lo = quotient_2_residual / quotient_0_of_divisor
    quotient_3 = enlarged_3 / quotient_0_of_divisor
    quotient_3_product = quotient_3 * quotient_0_of_divisor
    quotient_3_product_error = product_error(quotient_3, quotient_0_of_divisor, quotient_3_product)
    quotient_3_exact = enlarged_3 - quotient_3_product - quotient_3_product_error
    quotient_3_residual = quotient_3_exact - quotient_3 * quotient_0_of_divisor_lo
    quotient_3_lo = quotient_3_residual / quotient_0_of_divisor
    qo_0_of_quotient_0 = quotient_0 + quotient_0_lo
    qo_0 = qo_0_of_quotient_0 * down
    qo_0_inverse = 1 / down
    qo_0_lost = qo_0_of_quotient_0 - qo_0 * qo_0_inverse
    qo_0_small = (qo_0_lost + sum_error(quotient_0, quotient_0_lo, qo_0_of_quotient_0)) * down
    qo_0_lo = where(qo_0_lost == 0, 0, qo_0_small)
    qo_1_of_quotient_1 = quotient_1 + quotient_1_lo
    qo_1 = qo_1_of_quotient_1 * down
    qo_1_lost = qo_1_of_quotient_1 - qo_1 * qo_0_inverse
    qo_1_small = (qo_1_lost + sum_error(quotient_1, quotient_1_lo, qo_1_of_quotient_1)) * down
    qo_1_lo = where(qo_1_lost == 0, 0, qo_1_small)
    qo_2_of_quotient_2 = quotient_2 + quotient_2_lo
    qo_2 = qo_2_of_quotient_2 * down
    qo_2_lost = qo_2_of_quotient_2 - qo_2 * qo_0_inverse
    qo_2_small = (qo_2_lost + sum_error(quotient_2, quotient_2_lo, qo_2_of_quotient_2)) * down
    qo_2_lo = where(qo_2_lost == 0, 0, qo_2_small)
    qo_3_of_quotient_3 = quotient_3 + quotient_3_lo
    qo_3 = qo_3_of_quotient_3 * down
    qo_3_lost = qo_3_of_quotient_3 - qo_3 * qo_0_inverse
    qo_3_small = (qo_3_lost + sum_error(quotient_3, quotient_3_lo, qo_3_of_quotient_3)) * down
    qo_3_lo = where(qo_3_lost == 0, 0, qo_3_small)
    qo_0_total = qo_0 + qo_0_lo
    qo_0_rounded = where(qo_0_total == qo_0_total, qo_0_total, qo_0)
    qo_1_total = qo_1 + qo_1_lo
    qo_1_rounded = where(qo_1_total == qo_1_total, qo_1_total, qo_1)
    qo_2_total = qo_2 + qo_2_lo
    qo_2_rounded = where(qo_2_total == qo_2_total, qo_2_total, qo_2)
    qo_3_total = qo_3 + qo_3_lo
    qo_3_rounded = where(qo_3_total == qo_3_total, qo_3_total, qo_3)
    return (qo_0_rounded, qo_1_rounded, qo_2_rounded, qo_3_rounded)


@kernel("(4),(4)->(4)")
def product_qq(q1, q2):
    """qo = q1 q2 = (w1 w2 - v1·v2; w1 v2 + w2 v1 + v1 × v2).

    (4),(4)->(4).  q1, q2, qo: quaternion (w; x, y, z), the scalar first.
    16 mul, 40 add, 16 product error, 12 sum error.  Error <= u |result| + (w: 15, v: 16) u^2 S,
    S the sum of the |terms| of the expanded formula; barring over- and underflow.
    """
    q1_0, q1_1, q1_2, q1_3 = q1
    q2_0, q2_1, q2_2, q2_3 = q2
    qo_0a = q1_0 * q2_0
    qo_0b = q1_1 * q2_1
    qo_0c = q1_2 * q2_2
    qo_0d = qo_0b + qo_0c
    qo_0d_lo1 = sum_error(qo_0b, qo_0c, qo_0d) + product_error(q1_1, q2_1, qo_0b)
    qo_0d_lo = qo_0d_lo1 + product_error(q1_2, q2_2, qo_0c)
    qo_0e = q1_3 * q2_3
    qo_0f = qo_0d + qo_0e
    qo_0f_lo1 = sum_error(qo_0d, qo_0e, qo_0f) + qo_0d_lo
    qo_0f_lo = qo_0f_lo1 + product_error(q1_3, q2_3, qo_0e)
    qo_0 = qo_0a - qo_0f
    qo_0_lo1 = difference_error(qo_0a, qo_0f, qo_0) + product_error(q1_0, q2_0, qo_0a)
    qo_0_lo = qo_0_lo1 - qo_0f_lo
    qo_1a = q1_0 * q2_1
    qo_1b = q1_1 * q2_0
    qo_1c = qo_1a + qo_1b
    qo_1c_lo1 = sum_error(qo_1a, qo_1b, qo_1c) + product_error(q1_0, q2_1, qo_1a)
    qo_1c_lo = qo_1c_lo1 + product_error(q1_1, q2_0, qo_1b)
    qo_1d = q1_2 * q2_3
    qo_1e = q1_3 * q2_2
    qo_1f = qo_1d - qo_1e
    qo_1f_lo1 = difference_error(qo_1d, qo_1e, qo_1f) + product_error(q1_2, q2_3, qo_1d)
    qo_1f_lo = qo_1f_lo1 - product_error(q1_3, q2_2, qo_1e)
    qo_1 = qo_1c + qo_1f
    qo_1_lo1 = sum_error(qo_1c, qo_1f, qo_1) + qo_1c_lo
    qo_1_lo = qo_1_lo1 + qo_1f_lo
    qo_2a = q1_0 * q2_2
    qo_2b = q1_3 * q2_1
    qo_2c = q1_1 * q2_3
    qo_2d = qo_2b - qo_2c
    qo_2d_lo1 = difference_error(qo_2b, qo_2c, qo_2d) + product_error(q1_3, q2_1, qo_2b)
    qo_2d_lo = qo_2d_lo1 - product_error(q1_1, q2_3, qo_2c)
    qo_2e = qo_2a + qo_2d
    qo_2e_lo1 = sum_error(qo_2a, qo_2d, qo_2e) + product_error(q1_0, q2_2, qo_2a)
    qo_2e_lo = qo_2e_lo1 + qo_2d_lo
    qo_2f = q1_2 * q2_0
    qo_2 = qo_2e + qo_2f
    qo_2_lo1 = sum_error(qo_2e, qo_2f, qo_2) + qo_2e_lo
    qo_2_lo = qo_2_lo1 + product_error(q1_2, q2_0, qo_2f)
    qo_3a = q1_0 * q2_3
    qo_3b = q1_1 * q2_2
    qo_3c = q1_2 * q2_1
    qo_3d = qo_3b - qo_3c
    qo_3d_lo1 = difference_error(qo_3b, qo_3c, qo_3d) + product_error(q1_1, q2_2, qo_3b)
    qo_3d_lo = qo_3d_lo1 - product_error(q1_2, q2_1, qo_3c)
    qo_3e = qo_3a + qo_3d
    qo_3e_lo1 = sum_error(qo_3a, qo_3d, qo_3e) + product_error(q1_0, q2_3, qo_3a)
    qo_3e_lo = qo_3e_lo1 + qo_3d_lo
    qo_3f = q1_3 * q2_0
    qo_3 = qo_3e + qo_3f
    qo_3_lo1 = sum_error(qo_3e, qo_3f, qo_3) + qo_3e_lo
    qo_3_lo = qo_3_lo1 + product_error(q1_3, q2_0, qo_3f)
    qo_0_rounded = qo_0 + qo_0_lo
    qo_1_rounded = qo_1 + qo_1_lo
    qo_2_rounded = qo_2 + qo_2_lo
    qo_3_rounded = qo_3 + qo_3_lo
    return (qo_0_rounded, qo_1_rounded, qo_2_rounded, qo_3_rounded)


@kernel("(4),(4)->(4)")
def product_qconjq(q1, q2):
    """qo = q1* q2, q1* the conjugate.

    (4),(4)->(4).  q1, q2, qo: quaternion (w; x, y, z), the scalar first.
    16 mul, 40 add, 16 product error, 12 sum error.  Error <= u |result| + (w: 15, v: 10) u^2 S,
    S the sum of the |terms| of the expanded formula; barring over- and underflow.
    """
    q1_0, q1_1, q1_2, q1_3 = q1
    q2_0, q2_1, q2_2, q2_3 = q2
    qo_0a = q1_0 * q2_0
    qo_0b = q1_1 * q2_1
    qo_0c = q1_2 * q2_2
    qo_0d = qo_0b + qo_0c
    qo_0d_lo1 = sum_error(qo_0b, qo_0c, qo_0d) + product_error(q1_1, q2_1, qo_0b)
    qo_0d_lo = qo_0d_lo1 + product_error(q1_2, q2_2, qo_0c)
    qo_0e = q1_3 * q2_3
    qo_0f = qo_0d + qo_0e
    qo_0f_lo1 = sum_error(qo_0d, qo_0e, qo_0f) + qo_0d_lo
    qo_0f_lo = qo_0f_lo1 + product_error(q1_3, q2_3, qo_0e)
    qo_0 = qo_0a + qo_0f
    qo_0_lo1 = sum_error(qo_0a, qo_0f, qo_0) + product_error(q1_0, q2_0, qo_0a)
    qo_0_lo = qo_0_lo1 + qo_0f_lo
    qo_1a = q1_0 * q2_1
    qo_1b = q1_1 * q2_0
    qo_1c = qo_1a - qo_1b
    qo_1c_lo1 = difference_error(qo_1a, qo_1b, qo_1c) + product_error(q1_0, q2_1, qo_1a)
    qo_1c_lo = qo_1c_lo1 - product_error(q1_1, q2_0, qo_1b)
    qo_1d = q1_3 * q2_2
    qo_1e = q1_2 * q2_3
    qo_1f = qo_1d - qo_1e
    qo_1f_lo1 = difference_error(qo_1d, qo_1e, qo_1f) + product_error(q1_3, q2_2, qo_1d)
    qo_1f_lo = qo_1f_lo1 - product_error(q1_2, q2_3, qo_1e)
    qo_1 = qo_1c + qo_1f
    qo_1_lo1 = sum_error(qo_1c, qo_1f, qo_1) + qo_1c_lo
    qo_1_lo = qo_1_lo1 + qo_1f_lo
    qo_2a = q1_0 * q2_2
    qo_2b = q1_2 * q2_0
    qo_2c = qo_2a - qo_2b
    qo_2c_lo1 = difference_error(qo_2a, qo_2b, qo_2c) + product_error(q1_0, q2_2, qo_2a)
    qo_2c_lo = qo_2c_lo1 - product_error(q1_2, q2_0, qo_2b)
    qo_2d = q1_1 * q2_3
    qo_2e = q1_3 * q2_1
    qo_2f = qo_2d - qo_2e
    qo_2f_lo1 = difference_error(qo_2d, qo_2e, qo_2f) + product_error(q1_1, q2_3, qo_2d)
    qo_2f_lo = qo_2f_lo1 - product_error(q1_3, q2_1, qo_2e)
    qo_2 = qo_2c + qo_2f
    qo_2_lo1 = sum_error(qo_2c, qo_2f, qo_2) + qo_2c_lo
    qo_2_lo = qo_2_lo1 + qo_2f_lo
    qo_3a = q1_0 * q2_3
    qo_3b = q1_3 * q2_0
    qo_3c = qo_3a - qo_3b
    qo_3c_lo1 = difference_error(qo_3a, qo_3b, qo_3c) + product_error(q1_0, q2_3, qo_3a)
    qo_3c_lo = qo_3c_lo1 - product_error(q1_3, q2_0, qo_3b)
    qo_3d = q1_2 * q2_1
    qo_3e = q1_1 * q2_2
    qo_3f = qo_3d - qo_3e
    qo_3f_lo1 = difference_error(qo_3d, qo_3e, qo_3f) + product_error(q1_2, q2_1, qo_3d)
    qo_3f_lo = qo_3f_lo1 - product_error(q1_1, q2_2, qo_3e)
    qo_3 = qo_3c + qo_3f
    qo_3_lo1 = sum_error(qo_3c, qo_3f, qo_3) + qo_3c_lo
    qo_3_lo = qo_3_lo1 + qo_3f_lo
    qo_0_rounded = qo_0 + qo_0_lo
    qo_1_rounded = qo_1 + qo_1_lo
    qo_2_rounded = qo_2 + qo_2_lo
    qo_3_rounded = qo_3 + qo_3_lo
    return (qo_0_rounded, qo_1_rounded, qo_2_rounded, qo_3_rounded)


@kernel("(4),(4)->(4)")
def product_qqconj(q1, q2):
    """qo = q1 q2*, q2* the conjugate.

    (4),(4)->(4).  q1, q2, qo: quaternion (w; x, y, z), the scalar first.
    16 mul, 40 add, 16 product error, 12 sum error.  Error <= u |result| + (w: 15, v: 10) u^2 S,
    S the sum of the |terms| of the expanded formula; barring over- and underflow.
    """
    q1_0, q1_1, q1_2, q1_3 = q1
    q2_0, q2_1, q2_2, q2_3 = q2
    qo_0a = q1_0 * q2_0
    qo_0b = q1_1 * q2_1
    qo_0c = q1_2 * q2_2
    qo_0d = qo_0b + qo_0c
    qo_0d_lo1 = sum_error(qo_0b, qo_0c, qo_0d) + product_error(q1_1, q2_1, qo_0b)
    qo_0d_lo = qo_0d_lo1 + product_error(q1_2, q2_2, qo_0c)
    qo_0e = q1_3 * q2_3
    qo_0f = qo_0d + qo_0e
    qo_0f_lo1 = sum_error(qo_0d, qo_0e, qo_0f) + qo_0d_lo
    qo_0f_lo = qo_0f_lo1 + product_error(q1_3, q2_3, qo_0e)
    qo_0 = qo_0a + qo_0f
    qo_0_lo1 = sum_error(qo_0a, qo_0f, qo_0) + product_error(q1_0, q2_0, qo_0a)
    qo_0_lo = qo_0_lo1 + qo_0f_lo
    qo_1a = q1_1 * q2_0
    qo_1b = q1_0 * q2_1
    qo_1c = qo_1a - qo_1b
    qo_1c_lo1 = difference_error(qo_1a, qo_1b, qo_1c) + product_error(q1_1, q2_0, qo_1a)
    qo_1c_lo = qo_1c_lo1 - product_error(q1_0, q2_1, qo_1b)
    qo_1d = q1_3 * q2_2
    qo_1e = q1_2 * q2_3
    qo_1f = qo_1d - qo_1e
    qo_1f_lo1 = difference_error(qo_1d, qo_1e, qo_1f) + product_error(q1_3, q2_2, qo_1d)
    qo_1f_lo = qo_1f_lo1 - product_error(q1_2, q2_3, qo_1e)
    qo_1 = qo_1c + qo_1f
    qo_1_lo1 = sum_error(qo_1c, qo_1f, qo_1) + qo_1c_lo
    qo_1_lo = qo_1_lo1 + qo_1f_lo
    qo_2a = q1_2 * q2_0
    qo_2b = q1_0 * q2_2
    qo_2c = qo_2a - qo_2b
    qo_2c_lo1 = difference_error(qo_2a, qo_2b, qo_2c) + product_error(q1_2, q2_0, qo_2a)
    qo_2c_lo = qo_2c_lo1 - product_error(q1_0, q2_2, qo_2b)
    qo_2d = q1_1 * q2_3
    qo_2e = q1_3 * q2_1
    qo_2f = qo_2d - qo_2e
    qo_2f_lo1 = difference_error(qo_2d, qo_2e, qo_2f) + product_error(q1_1, q2_3, qo_2d)
    qo_2f_lo = qo_2f_lo1 - product_error(q1_3, q2_1, qo_2e)
    qo_2 = qo_2c + qo_2f
    qo_2_lo1 = sum_error(qo_2c, qo_2f, qo_2) + qo_2c_lo
    qo_2_lo = qo_2_lo1 + qo_2f_lo
    qo_3a = q1_3 * q2_0
    qo_3b = q1_0 * q2_3
    qo_3c = qo_3a - qo_3b
    qo_3c_lo1 = difference_error(qo_3a, qo_3b, qo_3c) + product_error(q1_3, q2_0, qo_3a)
    qo_3c_lo = qo_3c_lo1 - product_error(q1_0, q2_3, qo_3b)
    qo_3d = q1_2 * q2_1
    qo_3e = q1_1 * q2_2
    qo_3f = qo_3d - qo_3e
    qo_3f_lo1 = difference_error(qo_3d, qo_3e, qo_3f) + product_error(q1_2, q2_1, qo_3d)
    qo_3f_lo = qo_3f_lo1 - product_error(q1_1, q2_2, qo_3e)
    qo_3 = qo_3c + qo_3f
    qo_3_lo1 = sum_error(qo_3c, qo_3f, qo_3) + qo_3c_lo
    qo_3_lo = qo_3_lo1 + qo_3f_lo
    qo_0_rounded = qo_0 + qo_0_lo
    qo_1_rounded = qo_1 + qo_1_lo
    qo_2_rounded = qo_2 + qo_2_lo
    qo_3_rounded = qo_3 + qo_3_lo
    return (qo_0_rounded, qo_1_rounded, qo_2_rounded, qo_3_rounded)


@kernel("(4),(3)->(3)")
def product_qv(q, v):
    """vo = R(q) v, |q| = 1.

    (4),(3)->(3).  q: quaternion (w; x, y, z), the scalar first; v, vo: vector.
    30 mul, 48 add, 18 product error, 12 sum error.  Error <= u |result| + 40 u^2 S, S the sum
    of the |terms| of the expanded formula; barring over- and underflow.
    """
    q_0, q_1, q_2, q_3 = q
    v_0, v_1, v_2 = v
    c_0a = q_2 * v_2
    c_0b = q_3 * v_1
    c_0 = c_0a - c_0b
    c_0_lo1 = difference_error(c_0a, c_0b, c_0) + product_error(q_2, v_2, c_0a)
    c_0_lo = c_0_lo1 - product_error(q_3, v_1, c_0b)
    c_1a = q_3 * v_0
    c_1b = q_1 * v_2
    c_1 = c_1a - c_1b
    c_1_lo1 = difference_error(c_1a, c_1b, c_1) + product_error(q_3, v_0, c_1a)
    c_1_lo = c_1_lo1 - product_error(q_1, v_2, c_1b)
    c_2a = q_1 * v_1
    c_2b = q_2 * v_0
    c_2 = c_2a - c_2b
    c_2_lo1 = difference_error(c_2a, c_2b, c_2) + product_error(q_1, v_1, c_2a)
    c_2_lo = c_2_lo1 - product_error(q_2, v_0, c_2b)
    t_0 = 2 * c_0
    t_0_cross1 = 2 * c_0_lo
    t_0_lo = product_error(2, c_0, t_0) + t_0_cross1
    t_1 = 2 * c_1
    t_1_cross1 = 2 * c_1_lo
    t_1_lo = product_error(2, c_1, t_1) + t_1_cross1
    t_2 = 2 * c_2
    t_2_cross1 = 2 * c_2_lo
    t_2_lo = product_error(2, c_2, t_2) + t_2_cross1
    turn_0a = q_0 * t_0
    turn_0a_lo = product_error(q_0, t_0, turn_0a) + q_0 * t_0_lo
    turn_0b = q_2 * t_2
    turn_0b_lo = product_error(q_2, t_2, turn_0b) + q_2 * t_2_lo
    turn_0c = q_3 * t_1
    turn_0d = turn_0b - turn_0c
    turn_0d_lo1 = difference_error(turn_0b, turn_0c, turn_0d) + turn_0b_lo
    turn_0d_lo = turn_0d_lo1 - (product_error(q_3, t_1, turn_0c) + q_3 * t_1_lo)
    turn_0 = turn_0a + turn_0d
    turn_0_lo1 = sum_error(turn_0a, turn_0d, turn_0) + turn_0a_lo
    turn_0_lo = turn_0_lo1 + turn_0d_lo
    turn_1a = q_0 * t_1
    turn_1a_lo = product_error(q_0, t_1, turn_1a) + q_0 * t_1_lo
    turn_1b = q_3 * t_0
    turn_1b_lo = product_error(q_3, t_0, turn_1b) + q_3 * t_0_lo
    turn_1c = q_1 * t_2
    turn_1d = turn_1b - turn_1c
    turn_1d_lo1 = difference_error(turn_1b, turn_1c, turn_1d) + turn_1b_lo
    turn_1d_lo = turn_1d_lo1 - (product_error(q_1, t_2, turn_1c) + q_1 * t_2_lo)
    turn_1 = turn_1a + turn_1d
    turn_1_lo1 = sum_error(turn_1a, turn_1d, turn_1) + turn_1a_lo
    turn_1_lo = turn_1_lo1 + turn_1d_lo
    turn_2a = q_0 * t_2
    turn_2a_lo = product_error(q_0, t_2, turn_2a) + q_0 * t_2_lo
    turn_2b = q_1 * t_1
    turn_2b_lo = product_error(q_1, t_1, turn_2b) + q_1 * t_1_lo
    turn_2c = q_2 * t_0
    turn_2d = turn_2b - turn_2c
    turn_2d_lo1 = difference_error(turn_2b, turn_2c, turn_2d) + turn_2b_lo
    turn_2d_lo = turn_2d_lo1 - (product_error(q_2, t_0, turn_2c) + q_2 * t_0_lo)
    turn_2 = turn_2a + turn_2d
    turn_2_lo1 = sum_error(turn_2a, turn_2d, turn_2) + turn_2a_lo
    turn_2_lo = turn_2_lo1 + turn_2d_lo
    vo_0 = v_0 + turn_0
    vo_0_lo = sum_error(v_0, turn_0, vo_0) + turn_0_lo
    vo_1 = v_1 + turn_1
    vo_1_lo = sum_error(v_1, turn_1, vo_1) + turn_1_lo
    vo_2 = v_2 + turn_2
    vo_2_lo = sum_error(v_2, turn_2, vo_2) + turn_2_lo
    vo_0_rounded = vo_0 + vo_0_lo
    vo_1_rounded = vo_1 + vo_1_lo
    vo_2_rounded = vo_2 + vo_2_lo
    return (vo_0_rounded, vo_1_rounded, vo_2_rounded)


@kernel("(4),(3)->(3)")
def product_qconjv(q, v):
    """vo = R(q)^T v, |q| = 1.

    (4),(3)->(3).  q: quaternion (w; x, y, z), the scalar first; v, vo: vector.
    30 mul, 48 add, 18 product error, 12 sum error.  Error <= u |result| + 40 u^2 S, S the sum
    of the |terms| of the expanded formula; barring over- and underflow.
    """
    q_0, q_1, q_2, q_3 = q
    v_0, v_1, v_2 = v
    c_0a = q_3 * v_1
    c_0b = q_2 * v_2
    c_0 = c_0a - c_0b
    c_0_lo1 = difference_error(c_0a, c_0b, c_0) + product_error(q_3, v_1, c_0a)
    c_0_lo = c_0_lo1 - product_error(q_2, v_2, c_0b)
    c_1a = q_1 * v_2
    c_1b = q_3 * v_0
    c_1 = c_1a - c_1b
    c_1_lo1 = difference_error(c_1a, c_1b, c_1) + product_error(q_1, v_2, c_1a)
    c_1_lo = c_1_lo1 - product_error(q_3, v_0, c_1b)
    c_2a = q_2 * v_0
    c_2b = q_1 * v_1
    c_2 = c_2a - c_2b
    c_2_lo1 = difference_error(c_2a, c_2b, c_2) + product_error(q_2, v_0, c_2a)
    c_2_lo = c_2_lo1 - product_error(q_1, v_1, c_2b)
    t_0 = 2 * c_0
    t_0_cross1 = 2 * c_0_lo
    t_0_lo = product_error(2, c_0, t_0) + t_0_cross1
    t_1 = 2 * c_1
    t_1_cross1 = 2 * c_1_lo
    t_1_lo = product_error(2, c_1, t_1) + t_1_cross1
    t_2 = 2 * c_2
    t_2_cross1 = 2 * c_2_lo
    t_2_lo = product_error(2, c_2, t_2) + t_2_cross1
    turn_0a = q_0 * t_0
    turn_0a_lo = product_error(q_0, t_0, turn_0a) + q_0 * t_0_lo
    turn_0b = q_3 * t_1
    turn_0b_lo = product_error(q_3, t_1, turn_0b) + q_3 * t_1_lo
    turn_0c = q_2 * t_2
    turn_0d = turn_0b - turn_0c
    turn_0d_lo1 = difference_error(turn_0b, turn_0c, turn_0d) + turn_0b_lo
    turn_0d_lo = turn_0d_lo1 - (product_error(q_2, t_2, turn_0c) + q_2 * t_2_lo)
    turn_0 = turn_0a + turn_0d
    turn_0_lo1 = sum_error(turn_0a, turn_0d, turn_0) + turn_0a_lo
    turn_0_lo = turn_0_lo1 + turn_0d_lo
    turn_1a = q_0 * t_1
    turn_1a_lo = product_error(q_0, t_1, turn_1a) + q_0 * t_1_lo
    turn_1b = q_1 * t_2
    turn_1b_lo = product_error(q_1, t_2, turn_1b) + q_1 * t_2_lo
    turn_1c = q_3 * t_0
    turn_1d = turn_1b - turn_1c
    turn_1d_lo1 = difference_error(turn_1b, turn_1c, turn_1d) + turn_1b_lo
    turn_1d_lo = turn_1d_lo1 - (product_error(q_3, t_0, turn_1c) + q_3 * t_0_lo)
    turn_1 = turn_1a + turn_1d
    turn_1_lo1 = sum_error(turn_1a, turn_1d, turn_1) + turn_1a_lo
    turn_1_lo = turn_1_lo1 + turn_1d_lo
    turn_2a = q_0 * t_2
    turn_2a_lo = product_error(q_0, t_2, turn_2a) + q_0 * t_2_lo
    turn_2b = q_2 * t_0
    turn_2b_lo = product_error(q_2, t_0, turn_2b) + q_2 * t_0_lo
    turn_2c = q_1 * t_1
    turn_2d = turn_2b - turn_2c
    turn_2d_lo1 = difference_error(turn_2b, turn_2c, turn_2d) + turn_2b_lo
    turn_2d_lo = turn_2d_lo1 - (product_error(q_1, t_1, turn_2c) + q_1 * t_1_lo)
    turn_2 = turn_2a + turn_2d
    turn_2_lo1 = sum_error(turn_2a, turn_2d, turn_2) + turn_2a_lo
    turn_2_lo = turn_2_lo1 + turn_2d_lo
    vo_0 = v_0 + turn_0
    vo_0_lo = sum_error(v_0, turn_0, vo_0) + turn_0_lo
    vo_1 = v_1 + turn_1
    vo_1_lo = sum_error(v_1, turn_1, vo_1) + turn_1_lo
    vo_2 = v_2 + turn_2
    vo_2_lo = sum_error(v_2, turn_2, vo_2) + turn_2_lo
    vo_0_rounded = vo_0 + vo_0_lo
    vo_1_rounded = vo_1 + vo_1_lo
    vo_2_rounded = vo_2 + vo_2_lo
    return (vo_0_rounded, vo_1_rounded, vo_2_rounded)


@kernel("(4)->(3,3)")
def mat3x3_from_quaternion(q):
    """R = I + 2 (w v~ + v~^2) / q·q, for any q but zero whose square neither over- nor underflows.

    (4)->(3,3).  q: quaternion (w; x, y, z), the scalar first; R: rotation or other 3×3 matrix.
    41 mul, 80 add, 21 product error, 17 sum error, 2 div, 9 equal, 9 select.
    """
    q_0, q_1, q_2, q_3 = q
    squares_0 = q_0 * q_0
    squares_0_lo = product_error(q_0, q_0, squares_0)
    squares_1 = q_1 * q_1
    squares_1_lo = product_error(q_1, q_1, squares_1)
    squares_2 = q_2 * q_2
    squares_2_lo = product_error(q_2, q_2, squares_2)
    squares_3 = q_3 * q_3
    squares_3_lo = product_error(q_3, q_3, squares_3)
    pairs_0 = squares_0 + squares_1
    pairs_0_lo = sum_error(squares_0, squares_1, pairs_0) + squares_0_lo + squares_1_lo
    pairs_1 = squares_2 + squares_3
    pairs_1_lo = sum_error(squares_2, squares_3, pairs_1) + squares_2_lo + squares_3_lo
    pairs_2 = squares_0 + squares_2
    pairs_2_lo = sum_error(squares_0, squares_2, pairs_2) + squares_0_lo + squares_2_lo
    pairs_3 = squares_1 + squares_3
    pairs_4 = squares_0 + squares_3
    pairs_4_lo = sum_error(squares_0, squares_3, pairs_4) + squares_0_lo + squares_3_lo
    pairs_5 = squares_1 + squares_2
    square = pairs_0 + pairs_1
    square_lo = sum_error(pairs_0, pairs_1, square) + pairs_0_lo + pairs_1_lo
    factor_of_square = square + square_lo
    factor = 1 / factor_of_square
    factor_product = factor * factor_of_square
    factor_exact = 1 - factor_product - product_error(factor, factor_of_square, factor_product)
    factor_residual = factor_exact - factor * sum_error(square, square_lo, factor_of_square)
    factor_lo = factor_residual / factor_of_square
    d0 = pairs_0 - pairs_1
    d1 = pairs_2 - pairs_3
    d1_lo1 = difference_error(pairs_2, pairs_3, d1) + pairs_2_lo
    d1_lo = d1_lo1 - (sum_error(squares_1, squares_3, pairs_3) + squares_1_lo + squares_3_lo)
    d2 = pairs_4 - pairs_5
    d2_lo1 = difference_error(pairs_4, pairs_5, d2) + pairs_4_lo
    d2_lo = d2_lo1 - (sum_error(squares_1, squares_2, pairs_5) + squares_1_lo + squares_2_lo)
    twice = 2 * factor
    twice_lo = product_error(2, factor, twice) + 2 * factor_lo
    m_0a = q_1 * q_2
    m_0a_lo = product_error(q_1, q_2, m_0a)
    m_0b = q_0 * q_3
    m_0b_lo = product_error(q_0, q_3, m_0b)
    m_0 = m_0a - m_0b
    m_1a = q_0 * q_2
    m_1a_lo = product_error(q_0, q_2, m_1a)
    m_1b = q_1 * q_3
    m_1b_lo = product_error(q_1, q_3, m_1b)
    m_1 = m_1a + m_1b
    m_2a = q_2 * q_3
    m_2a_lo = product_error(q_2, q_3, m_2a)
    m_2b = q_0 * q_1
    m_2b_lo = product_error(q_0, q_1, m_2b)
    m_2 = m_2a - m_2b
    m_3 = m_0b + m_0a
    m_4 = m_1b - m_1a
    m_5 = m_2b + m_2a
    R_00 = factor * d0
    R_00_cross2 = factor * (difference_error(pairs_0, pairs_1, d0) + pairs_0_lo - pairs_1_lo)
    R_00_lo = product_error(factor, d0, R_00) + factor_lo * d0 + R_00_cross2
    R_01 = twice * m_0
    R_01_cross2 = twice * (difference_error(m_0a, m_0b, m_0) + m_0a_lo - m_0b_lo)
    R_01_lo = product_error(twice, m_0, R_01) + twice_lo * m_0 + R_01_cross2
    R_02 = twice * m_1
    R_02_cross2 = twice * (sum_error(m_1a, m_1b, m_1) + m_1a_lo + m_1b_lo)
    R_02_lo = product_error(twice, m_1, R_02) + twice_lo * m_1 + R_02_cross2
    R_10 = twice * m_3
    R_10_cross2 = twice * (sum_error(m_0b, m_0a, m_3) + m_0b_lo + m_0a_lo)
    R_10_lo = product_error(twice, m_3, R_10) + twice_lo * m_3 + R_10_cross2
    R_11 = factor * d1
    R_11_cross2 = factor * d1_lo
    R_11_lo = product_error(factor, d1, R_11) + factor_lo * d1 + R_11_cross2
    R_12 = twice * m_2
    R_12_cross2 = twice * (difference_error(m_2a, m_2b, m_2) + m_2a_lo - m_2b_lo)
    R_12_lo = product_error(twice, m_2, R_12) + twice_lo * m_2 + R_12_cross2
    R_20 = twice * m_4
    R_20_cross2 = twice * (difference_error(m_1b, m_1a, m_4) + m_1b_lo - m_1a_lo)
    R_20_lo = product_error(twice, m_4, R_20) + twice_lo * m_4 + R_20_cross2
    R_21 = twice * m_5
    R_21_cross2 = twice * (sum_error(m_2b, m_2a, m_5) + m_2b_lo + m_2a_lo)
    R_21_lo = product_error(twice, m_5, R_21) + twice_lo * m_5 + R_21_cross2
    R_22 = factor * d2
    R_22_cross2 = factor * d2_lo
    R_22_lo = product_error(factor, d2, R_22) + factor_lo * d2 + R_22_cross2
    R_00_total = R_00 + R_00_lo
    R_00_rounded = where(R_00_total == R_00_total, R_00_total, R_00)
    R_01_total = R_01 + R_01_lo
    R_01_rounded = where(R_01_total == R_01_total, R_01_total, R_01)
    R_02_total = R_02 + R_02_lo
    R_02_rounded = where(R_02_total == R_02_total, R_02_total, R_02)
    R_10_total = R_10 + R_10_lo
    R_10_rounded = where(R_10_total == R_10_total, R_10_total, R_10)
    R_11_total = R_11 + R_11_lo
    R_11_rounded = where(R_11_total == R_11_total, R_11_total, R_11)
    R_12_total = R_12 + R_12_lo
    R_12_rounded = where(R_12_total == R_12_total, R_12_total, R_12)
    R_20_total = R_20 + R_20_lo
    R_20_rounded = where(R_20_total == R_20_total, R_20_total, R_20)
    R_21_total = R_21 + R_21_lo
    R_21_rounded = where(R_21_total == R_21_total, R_21_total, R_21)
    R_22_total = R_22 + R_22_lo
    R_22_rounded = where(R_22_total == R_22_total, R_22_total, R_22)
    return (R_00_rounded, R_01_rounded, R_02_rounded, R_10_rounded, R_11_rounded, R_12_rounded,
        R_20_rounded, R_21_rounded, R_22_rounded)


@kernel("(3,3)->(4)")
def quaternion_from_mat3x3(R):
    """qo with R(qo) = R and w >= 0; of an R that is not quite a rotation, off by as much as R.

    (3,3)->(4).  R: rotation or other 3×3 matrix; qo: quaternion (w; x, y, z), the scalar first.
    21 mul, 73 add, 9 product error, 27 sum error, 9 div, 1 sqrt, 9 neg, 4 less, 5 equal, 37
    select.
    """
    R_00, R_01, R_02, R_10, R_11, R_12, R_20, R_21, R_22 = R
    p_0 = R_21 - R_12
    p_0_lo = difference_error(R_21, R_12, p_0)
    p_1 = R_02 - R_20
    p_1_lo = difference_error(R_02, R_20, p_1)
    p_2 = R_10 - R_01
    p_2_lo = difference_error(R_10, R_01, p_2)
    s_0 = R_12 + R_21
    s_0_lo = sum_error(R_12, R_21, s_0)
    s_1 = R_02 + R_20
    s_1_lo = sum_error(R_02, R_20, s_1)
    s_2 = R_01 + R_10
    s_2_lo = sum_error(R_01, R_10, s_2)
    d_0a = R_00 + R_11
    d_0b = d_0a + R_22
    d_0 = d_0b + 1
    d_0_lo = sum_error(d_0b, 1, d_0) + (sum_error(d_0a, R_22, d_0b) + sum_error(R_00, R_11, d_0a))
    d_1a = R_00 - R_11
    d_1b = d_1a - R_22
    d_1b_lo = difference_error(d_1a, R_22, d_1b) + difference_error(R_00, R_11, d_1a)
    d_1 = d_1b + 1
    d_1_lo = sum_error(d_1b, 1, d_1) + d_1b_lo
    d_2a = R_11 - R_00
    d_2b = d_2a - R_22
    d_2b_lo = difference_error(d_2a, R_22, d_2b) + difference_error(R_11, R_00, d_2a)
    d_2 = d_2b + 1
    d_2_lo = sum_error(d_2b, 1, d_2) + d_2b_lo
    d_3a = R_22 - R_00
    d_3b = d_3a - R_11
    d_3b_lo = difference_error(d_3a, R_11, d_3b) + difference_error(R_22, R_00, d_3a)
    d_3 = d_3b + 1
    d_3_lo = sum_error(d_3b, 1, d_3) + d_3b_lo
    low_0 = where(R_11 < R_00, p_0, p_1)
    low_1 = where(R_11 < R_00, d_1, s_2)
    low_1_lo = where(R_11 < R_00, d_1_lo, s_2_lo)
    low_2 = where(R_11 < R_00, s_2, d_2)
    low_2_lo = where(R_11 < R_00, s_2_lo, d_2_lo)
    low_3 = where(R_11 < R_00, s_1, s_0)
    high_0 = where(R_00 < -R_11, p_2, d_0)
    high_0_lo = where(R_00 < -R_11, p_2_lo, d_0_lo)
    high_1 = where(R_00 < -R_11, s_1, p_0)
    high_2 = where(R_00 < -R_11, s_0, p_1)
    high_3 = where(R_00 < -R_11, d_3, p_2)
    high_3_lo = where(R_00 < -R_11, d_3_lo, p_2_lo)
    column_0 = where(R_22 < 0, low_0, high_0)
    column_0_lo = where(R_22 < 0, where(R_11 < R_00, p_0_lo, p_1_lo), high_0_lo)
    column_1 = where(R_22 < 0, low_1, high_1)
    column_1_lo = where(R_22 < 0, low_1_lo, where(R_00 < -R_11, s_1_lo, p_0_lo))
    column_2 = where(R_22 < 0, low_2, high_2)
    column_2_lo = where(R_22 < 0, low_2_lo, where(R_00 < -R_11, s_0_lo, p_1_lo))
    column_3 = where(R_22 < 0, low_3, high_3)
    column_3_lo = where(R_22 < 0, where(R_11 < R_00, s_1_lo, s_0_lo), high_3_lo)
    upper_0 = where(column_0 < 0, -column_0, column_0)
    upper_0_lo = where(column_0 < 0, -column_0_lo, column_0_lo)
    upper_1 = where(column_0 < 0, -column_1, column_1)
    upper_1_lo = where(column_0 < 0, -column_1_lo, column_1_lo)
    upper_2 = where(column_0 < 0, -column_2, column_2)
    upper_2_lo = where(column_0 < 0, -column_2_lo, column_2_lo)
    upper_3 = where(column_0 < 0, -column_3, column_3)
    upper_3_lo = where(column_0 < 0, -column_3_lo, column_3_lo)
    length_a = upper_0 * upper_0
    length_a_lo1 = product_error(upper_0, upper_0, length_a) + upper_0_lo * upper_0
    length_a_lo = length_a_lo1 + upper_0 * upper_0_lo
    length_b = upper_1 * upper_1
    length_b_lo1 = product_error(upper_1, upper_1, length_b) + upper_1_lo * upper_1
    length_b_lo = length_b_lo1 + upper_1 * upper_1_lo
    length_c = length_a + length_b
    length_c_lo1 = sum_error(length_a, length_b, length_c) + length_a_lo
    length_c_lo = length_c_lo1 + length_b_lo
    length_d = upper_2 * upper_2
    length_d_lo1 = product_error(upper_2, upper_2, length_d) + upper_2_lo * upper_2
    length_d_lo = length_d_lo1 + upper_2 * upper_2_lo
    length_e = length_c + length_d
    length_e_lo1 = sum_error(length_c, length_d, length_e) + length_c_lo
    length_e_lo = length_e_lo1 + length_d_lo
    length_f = upper_3 * upper_3
    length_f_lo1 = product_error(upper_3, upper_3, length_f) + upper_3_lo * upper_3
    length_f_lo = length_f_lo1 + upper_3 * upper_3_lo
    length_g = length_e + length_f
    length_g_lo1 = sum_error(length_e, length_f, length_g) + length_e_lo
    length_g_lo = length_g_lo1 + length_f_lo
    length_of_length_g = length_g + length_g_lo
    length = sqrt(length_of_length_g)
    length_product = length * length
    length_product_error = product_error(length, length, length_product)
    length_exact = length_of_length_g - length_product - length_product_error
    length_residual = length_exact + sum_error(length_g, length_g_lo, length_of_length_g)
    length_lo = length_residual / where(length == 0, 1, length + length)
    qo_0_of_upper_0 = upper_0 + upper_0_lo
    qo_0_of_length = length + length_lo
    qo_0_of_length_lo = sum_error(length, length_lo, qo_0_of_length)
    qo_0 = qo_0_of_upper_0 / qo_0_of_length
    qo_0_product = qo_0 * qo_0_of_length
    qo_0_exact = qo_0_of_upper_0 - qo_0_product - product_error(qo_0, qo_0_of_length, qo_0_product)
    qo_0_lo1 = qo_0_exact + sum_error(upper_0, upper_0_lo, qo_0_of_upper_0)
    qo_0_residual = qo_0_lo1 - qo_0 * qo_0_of_length_lo
    qo_0_lo = qo_0_residual / qo_0_of_length
    qo_1_of_upper_1 = upper_1 + upper_1_lo
    qo_1 = qo_1_of_upper_1 / qo_0_of_length
    qo_1_product = qo_1 * qo_0_of_length
    qo_1_exact = qo_1_of_upper_1 - qo_1_product - product_error(qo_1, qo_0_of_length, qo_1_product)
    qo_1_lo1 = qo_1_exact + sum_error(upper_1, upper_1_lo, qo_1_of_upper_1)
    qo_1_residual = qo_1_lo1 - qo_1 * qo_0_of_length_lo
    qo_1_lo = qo_1_residual / qo_0_of_length
    qo_2_of_upper_2 = upper_2 + upper_2_lo
    qo_2 = qo_2_of_upper_2 / qo_0_of_length
    qo_2_product = qo_2 * qo_0_of_length
    qo_2_exact = qo_2_of_upper_2 - qo_2_product - product_error(qo_2, qo_0_of_length, qo_2_product)
    qo_2_lo1 = qo_2_exact + sum_error(upper_2, upper_2_lo, qo_2_of_upper_2)
    qo_2_residual = qo_2_lo1 - qo_2 * qo_0_of_length_lo
    qo_2_lo = qo_2_residual / qo_0_of_length
    qo_3_of_upper_3 = upper_3 + upper_3_lo
    qo_3 = qo_3_of_upper_3 / qo_0_of_length
    qo_3_product = qo_3 * qo_0_of_length
    qo_3_exact = qo_3_of_upper_3 - qo_3_product - product_error(qo_3, qo_0_of_length, qo_3_product)
    qo_3_lo1 = qo_3_exact + sum_error(upper_3, upper_3_lo, qo_3_of_upper_3)
    qo_3_residual = qo_3_lo1 - qo_3 * qo_0_of_length_lo
    qo_3_lo = qo_3_residual / qo_0_of_length
    qo_0_total = qo_0 + qo_0_lo
    qo_0_rounded = where(qo_0_total == qo_0_total, qo_0_total, qo_0)
    qo_1_total = qo_1 + qo_1_lo
    qo_1_rounded = where(qo_1_total == qo_1_total, qo_1_total, qo_1)
    qo_2_total = qo_2 + qo_2_lo
    qo_2_rounded = where(qo_2_total == qo_2_total, qo_2_total, qo_2)
    qo_3_total = qo_3 + qo_3_lo
    qo_3_rounded = where(qo_3_total == qo_3_total, qo_3_total, qo_3)
    return (qo_0_rounded, qo_1_rounded, qo_2_rounded, qo_3_rounded)


@kernel("(4)->(),(3)")
def axis_angle_from_quaternion(q):
    """angle = 2 atan2(|v|, |w|), axis = ±v / |v|; 0 <= angle <= π; the axis is (1, 0, 0) where
    angle = 0; any multiple of a quaternion.

    (4)->(),(3).  q: quaternion (w; x, y, z), the scalar first; angle: number; axis: vector.
    21 mul, 31 add, 8 product error, 6 sum error, 9 div, 1 sqrt, 1 atan2, 4 neg, 3 abs, 7 less,
    7 equal, 20 select.
    """
    q_0, q_1, q_2, q_3 = q
    upper_0 = where(q_0 < 0, -q_0, q_0)
    upper_1 = where(q_0 < 0, -q_1, q_1)
    upper_2 = where(q_0 < 0, -q_2, q_2)
    upper_3 = where(q_0 < 0, -q_3, q_3)
    v_s_size_0 = absolute(upper_1)
    v_s_size_1 = absolute(upper_2)
    v_s_size_2 = absolute(upper_3)
    v_s_largest1 = where(v_s_size_0 < v_s_size_1, v_s_size_1, v_s_size_0)
    v_s_largest2 = where(v_s_largest1 < v_s_size_2, v_s_size_2, v_s_largest1)
    v_s_b = where(6.703903964971299e+153 < v_s_largest2, float64(3.7291703656001034e-155), float64(1))
    v_s = where(v_s_largest2 < 3.4395525670743494e-136, 4.149515568880993e+180, v_s_b)
    v_y_0 = upper_1 * v_s
    v_y_1 = upper_2 * v_s
    v_y_2 = upper_3 * v_s
    v_n_a = v_y_0 * v_y_0
    v_n_b = v_y_1 * v_y_1
    v_n_c = v_n_a + v_n_b
    v_n_c_lo1 = sum_error(v_n_a, v_n_b, v_n_c) + product_error(v_y_0, v_y_0, v_n_a)
    v_n_c_lo = v_n_c_lo1 + product_error(v_y_1, v_y_1, v_n_b)
    v_n_d = v_y_2 * v_y_2
    v_n_e = v_n_c + v_n_d
    v_n_e_lo1 = sum_error(v_n_c, v_n_d, v_n_e) + v_n_c_lo
    v_n_e_lo = v_n_e_lo1 + product_error(v_y_2, v_y_2, v_n_d)
    v_n_of_v_n_e = v_n_e + v_n_e_lo
    v_n = sqrt(v_n_of_v_n_e)
    v_n_product = v_n * v_n
    v_n_exact = v_n_of_v_n_e - v_n_product - product_error(v_n, v_n, v_n_product)
    v_n_residual = v_n_exact + sum_error(v_n_e, v_n_e_lo, v_n_of_v_n_e)
    v_n_lo = v_n_residual / where(v_n == 0, 1, v_n + v_n)
    v_r_b = where(v_s < 1, float64(2.6815615859885194e+154), float64(1))
    v_r = where(1 < v_s, 2.409919865102884e-181, v_r_b)
    n_of_v_n = v_n + v_n_lo
    n = n_of_v_n * v_r
    n_lost = n_of_v_n - n * (1 / v_r)
    n_lo = where(n_lost == 0, 0, (n_lost + sum_error(v_n, v_n_lo, n_of_v_n)) * v_r)
    half_of_n = n + n_lo
    half_of_n_lo = sum_error(n, n_lo, half_of_n)
    half = arctan2(half_of_n, upper_0)
    divisor = where(half_of_n == 0, 1, half_of_n)
    divisor_lo = where(half_of_n == 0, 0, half_of_n_lo)
    unit_0_of_divisor = divisor + divisor_lo
    unit_0_of_divisor_lo = sum_error(divisor, divisor_lo, unit_0_of_divisor)
    unit_0 = upper_1 / unit_0_of_divisor
    unit_0_product = unit_0 * unit_0_of_divisor
    unit_0_product_error = product_error(unit_0, unit_0_of_divisor, unit_0_product)
    unit_0_exact = upper_1 - unit_0_product - unit_0_product_error
    unit_0_residual = unit_0_exact - unit_0 * unit_0_of_divisor_lo
    unit_0_lo = unit_0_residual / unit_0_of_divisor
    unit_1 = upper_2 / unit_0_of_divisor
    unit_1_product = unit_1 * unit_0_of_divisor
    unit_1_product_error = product_error(unit_1, unit_0_of_divisor, unit_1_product)
    unit_1_exact = upper_2 - unit_1_product - unit_1_product_error
    unit_1_residual = unit_1_exact - unit_1 * unit_0_of_divisor_lo
    unit_1_lo = unit_1_residual / unit_0_of_divisor
    unit_2 = upper_3 / unit_0_of_divisor
    unit_2_product = unit_2 * unit_0_of_divisor
    unit_2_product_error = product_error(unit_2, unit_0_of_divisor, unit_2_product)
    unit_2_exact = upper_3 - unit_2_product - unit_2_product_error
    unit_2_residual = unit_2_exact - unit_2 * unit_0_of_divisor_lo
    unit_2_lo = unit_2_residual / unit_0_of_divisor
    angle = 2 * half
    angle_cross1 = 2 * (upper_0 * half_of_n_lo / (upper_0 * upper_0 + half_of_n * half_of_n))
    angle_lo = product_error(2, half, angle) + angle_cross1
    axis_0 = where(half_of_n == 0, 1, unit_0)
    axis_0_lo = where(half_of_n == 0, 0, unit_0_lo)
    angle_total = angle + angle_lo
    angle_rounded = where(angle_total == angle_total, angle_total, angle)
    axis_0_total = axis_0 + axis_0_lo
    axis_0_rounded = where(axis_0_total == axis_0_total, axis_0_total, axis_0)
    unit_1_total = unit_1 + unit_1_lo
    unit_1_rounded = where(unit_1_total == unit_1_total, unit_1_total, unit_1)
    unit_2_total = unit_2 + unit_2_lo
    unit_2_rounded = where(unit_2_total == unit_2_total, unit_2_total, unit_2)
    return (angle_rounded, axis_0_rounded, unit_1_rounded, unit_2_rounded)


@kernel("(4)->(3)")
def quaternion_log(q):
    """vo = θ v/|v|, θ = 2 atan2(|v|, |w|) <= π: the rotation vector of q, or of any multiple of
    it.

    (4)->(3).  q: quaternion (w; x, y, z), the scalar first; vo: vector.
    23 mul, 29 add, 9 product error, 7 sum error, 5 div, 1 sqrt, 1 atan2, 4 neg, 3 abs, 7 less,
    6 equal, 17 select.
    """
    q_0, q_1, q_2, q_3 = q
    upper_0 = where(q_0 < 0, -q_0, q_0)
    upper_1 = where(q_0 < 0, -q_1, q_1)
    upper_2 = where(q_0 < 0, -q_2, q_2)
    upper_3 = where(q_0 < 0, -q_3, q_3)
    v_s_size_0 = absolute(upper_1)
    v_s_size_1 = absolute(upper_2)
    v_s_size_2 = absolute(upper_3)
    v_s_largest1 = where(v_s_size_0 < v_s_size_1, v_s_size_1, v_s_size_0)
    v_s_largest2 = where(v_s_largest1 < v_s_size_2, v_s_size_2, v_s_largest1)
    v_s_b = where(6.703903964971299e+153 < v_s_largest2, float64(3.7291703656001034e-155), float64(1))
    v_s = where(v_s_largest2 < 3.4395525670743494e-136, 4.149515568880993e+180, v_s_b)
    v_y_0 = upper_1 * v_s
    v_y_1 = upper_2 * v_s
    v_y_2 = upper_3 * v_s
    v_n_a = v_y_0 * v_y_0
    v_n_b = v_y_1 * v_y_1
    v_n_c = v_n_a + v_n_b
    v_n_c_lo1 = sum_error(v_n_a, v_n_b, v_n_c) + product_error(v_y_0, v_y_0, v_n_a)
    v_n_c_lo = v_n_c_lo1 + product_error(v_y_1, v_y_1, v_n_b)
    v_n_d = v_y_2 * v_y_2
    v_n_e = v_n_c + v_n_d
    v_n_e_lo1 = sum_error(v_n_c, v_n_d, v_n_e) + v_n_c_lo
    v_n_e_lo = v_n_e_lo1 + product_error(v_y_2, v_y_2, v_n_d)
    v_n_of_v_n_e = v_n_e + v_n_e_lo
    v_n = sqrt(v_n_of_v_n_e)
    v_n_product = v_n * v_n
    v_n_exact = v_n_of_v_n_e - v_n_product - product_error(v_n, v_n, v_n_product)
    v_n_residual = v_n_exact + sum_error(v_n_e, v_n_e_lo, v_n_of_v_n_e)
    v_n_lo = v_n_residual / where(v_n == 0, 1, v_n + v_n)
    v_r_b = where(v_s < 1, float64(2.6815615859885194e+154), float64(1))
    v_r = where(1 < v_s, 2.409919865102884e-181, v_r_b)
    n_of_v_n = v_n + v_n_lo
    n = n_of_v_n * v_r
    n_lost = n_of_v_n - n * (1 / v_r)
    n_lo = where(n_lost == 0, 0, (n_lost + sum_error(v_n, v_n_lo, n_of_v_n)) * v_r)
    half_of_n = n + n_lo
    half_of_n_lo = sum_error(n, n_lo, half_of_n)
    half = arctan2(half_of_n, upper_0)
    divisor = where(half_of_n == 0, 1, half_of_n)
    divisor_lo = where(half_of_n == 0, 0, half_of_n_lo)
    theta = 2 * half
    theta_cross1 = 2 * (upper_0 * half_of_n_lo / (upper_0 * upper_0 + half_of_n * half_of_n))
    theta_lo = product_error(2, half, theta) + theta_cross1
    k_of_theta = theta + theta_lo
    k_of_divisor = divisor + divisor_lo
    k = k_of_theta / k_of_divisor
    k_product = k * k_of_divisor
    k_exact = k_of_theta - k_product - product_error(k, k_of_divisor, k_product)
    k_lo1 = k_exact + sum_error(theta, theta_lo, k_of_theta)
    k_residual = k_lo1 - k * sum_error(divisor, divisor_lo, k_of_divisor)
    k_lo = k_residual / k_of_divisor
    vector_0 = upper_1 * k
    vector_1 = upper_2 * k
    vector_2 = upper_3 * k
    vector_0_total = vector_0 + (product_error(upper_1, k, vector_0) + upper_1 * k_lo)
    vector_0_rounded = where(vector_0_total == vector_0_total, vector_0_total, vector_0)
    vector_1_total = vector_1 + (product_error(upper_2, k, vector_1) + upper_2 * k_lo)
    vector_1_rounded = where(vector_1_total == vector_1_total, vector_1_total, vector_1)
    vector_2_total = vector_2 + (product_error(upper_3, k, vector_2) + upper_3 * k_lo)
    vector_2_rounded = where(vector_2_total == vector_2_total, vector_2_total, vector_2)
    return (vector_0_rounded, vector_1_rounded, vector_2_rounded)
