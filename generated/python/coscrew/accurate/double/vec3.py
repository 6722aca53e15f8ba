# Made by `coscrew generate`; changes are overwritten.
# SPDX-License-Identifier: MIT
# coscrew 0.2.0.  Copyright (c) 2026 The coscrew authors.
"""Vectors of three components.

In double precision, accurate tier.
"""

from coscrew import _elementary_double as elementary
from numpy import absolute, float64 as real, sqrt, where
from coscrew._exact import product_error, product_rest
from coscrew._kernel import double_kernel as kernel


@kernel("(3),()->(3)")
def vec3_scale(self, a):
    """self = a self.

    (3),()->(3).  self: vector; a: number.
    3 mul, 3 add, 3 product error.  Error <= u |result|, barring over- and underflow.
    """
    self_0, self_1, self_2 = self
    self_0_new = self_0 * a
    self_1_new = self_1 * a
    self_2_new = self_2 * a
    self_0_new_rounded = self_0_new + product_error(self_0, a, self_0_new)
    self_1_new_rounded = self_1_new + product_error(self_1, a, self_1_new)
    self_2_new_rounded = self_2_new + product_error(self_2, a, self_2_new)
    return (self_0_new_rounded, self_1_new_rounded, self_2_new_rounded)


@kernel("(),(3),(3)->(3)")
def axpy_vv(a, x, y):
    """y = a x + y.

    (),(3),(3)->(3).  a: number; x, y: vector.
    3 mul, 18 add, 3 product rest.  Error <= u |result| + 3 u^2 S, S the sum of the |terms| of
    the expanded formula; barring over- and underflow.
    """
    x_0, x_1, x_2 = x
    y_0, y_1, y_2 = y
    y_0_new_a = a * x_0
    y_0_new = y_0_new_a + y_0
    y_0_new_right = y_0_new - y_0_new_a
    y_1_new_a = a * x_1
    y_1_new = y_1_new_a + y_1
    y_1_new_right = y_1_new - y_1_new_a
    y_2_new_a = a * x_2
    y_2_new = y_2_new_a + y_2
    y_2_new_right = y_2_new - y_2_new_a
    y_0_new_rounded = (y_0_new
        + (product_rest(a, x_0, y_0_new_a, y_0_new - y_0_new_right) + (y_0 - y_0_new_right)))
    y_1_new_rounded = (y_1_new
        + (product_rest(a, x_1, y_1_new_a, y_1_new - y_1_new_right) + (y_1 - y_1_new_right)))
    y_2_new_rounded = (y_2_new
        + (product_rest(a, x_2, y_2_new_a, y_2_new - y_2_new_right) + (y_2 - y_2_new_right)))
    return (y_0_new_rounded, y_1_new_rounded, y_2_new_rounded)


@kernel("(3),(3)->(3)")
def xpy_vv(x, y):
    """y = x + y.

    (3),(3)->(3).  x, y: vector.
    21 add.  Error <= u |result|, barring over- and underflow.
    """
    x_0, x_1, x_2 = x
    y_0, y_1, y_2 = y
    y_0_new = x_0 + y_0
    y_0_new_right = y_0_new - x_0
    y_1_new = x_1 + y_1
    y_1_new_right = y_1_new - x_1
    y_2_new = x_2 + y_2
    y_2_new_right = y_2_new - x_2
    y_0_new_rounded = y_0_new + (x_0 - (y_0_new - y_0_new_right) + (y_0 - y_0_new_right))
    y_1_new_rounded = y_1_new + (x_1 - (y_1_new - y_1_new_right) + (y_1 - y_1_new_right))
    y_2_new_rounded = y_2_new + (x_2 - (y_2_new - y_2_new_right) + (y_2 - y_2_new_right))
    return (y_0_new_rounded, y_1_new_rounded, y_2_new_rounded)


@kernel("(3),(3)->(3)")
def nxpy_vv(x, y):
    """y = -x + y.

    (3),(3)->(3).  x, y: vector.
    21 add.  Error <= u |result|, barring over- and underflow.
    """
    x_0, x_1, x_2 = x
    y_0, y_1, y_2 = y
    y_0_new = y_0 - x_0
    y_0_new_right = y_0 - y_0_new
    y_1_new = y_1 - x_1
    y_1_new_right = y_1 - y_1_new
    y_2_new = y_2 - x_2
    y_2_new_right = y_2 - y_2_new
    y_0_new_rounded = y_0_new + (y_0 - (y_0_new + y_0_new_right) - (x_0 - y_0_new_right))
    y_1_new_rounded = y_1_new + (y_1 - (y_1_new + y_1_new_right) - (x_1 - y_1_new_right))
    y_2_new_rounded = y_2_new + (y_2 - (y_2_new + y_2_new_right) - (x_2 - y_2_new_right))
    return (y_0_new_rounded, y_1_new_rounded, y_2_new_rounded)


@kernel("(),(3)->(3)")
def product_av(a, vi):
    """vo = a vi.

    (),(3)->(3).  a: number; vi, vo: vector.
    3 mul, 3 add, 3 product error.  Error <= u |result|, barring over- and underflow.
    """
    vi_0, vi_1, vi_2 = vi
    vo_0 = a * vi_0
    vo_1 = a * vi_1
    vo_2 = a * vi_2
    vo_0_rounded = vo_0 + product_error(a, vi_0, vo_0)
    vo_1_rounded = vo_1 + product_error(a, vi_1, vo_1)
    vo_2_rounded = vo_2 + product_error(a, vi_2, vo_2)
    return (vo_0_rounded, vo_1_rounded, vo_2_rounded)


@kernel("(3),(3)->(3)")
def add_vv(v1, v2):
    """vo = v1 + v2.

    (3),(3)->(3).  v1, v2, vo: vector.
    21 add.  Error <= u |result|, barring over- and underflow.
    """
    v1_0, v1_1, v1_2 = v1
    v2_0, v2_1, v2_2 = v2
    vo_0 = v1_0 + v2_0
    vo_0_right = vo_0 - v1_0
    vo_1 = v1_1 + v2_1
    vo_1_right = vo_1 - v1_1
    vo_2 = v1_2 + v2_2
    vo_2_right = vo_2 - v1_2
    vo_0_rounded = vo_0 + (v1_0 - (vo_0 - vo_0_right) + (v2_0 - vo_0_right))
    vo_1_rounded = vo_1 + (v1_1 - (vo_1 - vo_1_right) + (v2_1 - vo_1_right))
    vo_2_rounded = vo_2 + (v1_2 - (vo_2 - vo_2_right) + (v2_2 - vo_2_right))
    return (vo_0_rounded, vo_1_rounded, vo_2_rounded)


@kernel("(3),(3)->(3)")
def subtract_vv(v1, v2):
    """vo = v1 - v2.

    (3),(3)->(3).  v1, v2, vo: vector.
    21 add.  Error <= u |result|, barring over- and underflow.
    """
    v1_0, v1_1, v1_2 = v1
    v2_0, v2_1, v2_2 = v2
    vo_0 = v1_0 - v2_0
    vo_0_right = v1_0 - vo_0
    vo_1 = v1_1 - v2_1
    vo_1_right = v1_1 - vo_1
    vo_2 = v1_2 - v2_2
    vo_2_right = v1_2 - vo_2
    vo_0_rounded = vo_0 + (v1_0 - (vo_0 + vo_0_right) - (v2_0 - vo_0_right))
    vo_1_rounded = vo_1 + (v1_1 - (vo_1 + vo_1_right) - (v2_1 - vo_1_right))
    vo_2_rounded = vo_2 + (v1_2 - (vo_2 + vo_2_right) - (v2_2 - vo_2_right))
    return (vo_0_rounded, vo_1_rounded, vo_2_rounded)


@kernel("(3),()->(3)")
def vec3_scaled(v, k):
    """vo = k v.

    (3),()->(3).  v, vo: vector; k: number.
    3 mul, 3 add, 3 product error.  Error <= u |result|, barring over- and underflow.
    """
    v_0, v_1, v_2 = v
    vo_0 = v_0 * k
    vo_1 = v_1 * k
    vo_2 = v_2 * k
    vo_0_rounded = vo_0 + product_error(v_0, k, vo_0)
    vo_1_rounded = vo_1 + product_error(v_1, k, vo_1)
    vo_2_rounded = vo_2 + product_error(v_2, k, vo_2)
    return (vo_0_rounded, vo_1_rounded, vo_2_rounded)


@kernel("(3)->()")
def vec3_l2norm(v):
    """|v| = sqrt(v·v).

    (3)->().  v: vector; norm: number.
    10 mul, 29 add, 1 product error, 3 product rest, 2 div, 1 sqrt, 3 abs, 8 less, 2 equal, 10
    select.
    """
    v_0, v_1, v_2 = v
    s_size_0 = absolute(v_0)
    s_size_1 = absolute(v_1)
    s_size_2 = absolute(v_2)
    s_largest1 = where(s_size_0 < s_size_1, s_size_1, s_size_0)
    s_largest2 = where(s_largest1 < s_size_2, s_size_2, s_largest1)
    s_d = where(s_largest2 < 256, 1.3093562431584567e+151,
        where(6.703903964971299e+153 < s_largest2, real(3.7291703656001034e-155), real(1)))
    s = where(s_largest2 < 1.955159272639747e-149, 1.0715086071862673e+301, s_d)
    y_0 = v_0 * s
    y_1 = v_1 * s
    y_2 = v_2 * s
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


@kernel("(3)->(3)")
def vec3_normalize(self):
    """self = self / |self|; the zero vector stays zero.

    (3)->(3).  self: vector.
    25 mul, 68 add, 4 product error, 3 product rest, 8 div, 1 sqrt, 3 abs, 7 less, 5 equal, 13
    select.
    """
    self_0, self_1, self_2 = self
    s_size_0 = absolute(self_0)
    s_size_1 = absolute(self_1)
    s_size_2 = absolute(self_2)
    s_largest1 = where(s_size_0 < s_size_1, s_size_1, s_size_0)
    s_largest2 = where(s_largest1 < s_size_2, s_size_2, s_largest1)
    s_d = where(s_largest2 < 256, 1.3093562431584567e+151,
        where(6.703903964971299e+153 < s_largest2, real(3.7291703656001034e-155), real(1)))
    s = where(s_largest2 < 1.955159272639747e-149, 1.0715086071862673e+301, s_d)
    y_0 = self_0 * s
    y_1 = self_1 * s
    y_2 = self_2 * s
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
    sized_0 = self_0 * up
    sized_1 = self_1 * up
    sized_2 = self_2 * up
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
    self_0_new_rounded = (self_0_new
        + (quotient_0_sum - self_0_new * self_0_new_inverse + quotient_0_sum_lo) * down)
    self_1_new_rounded = (self_1_new
        + (quotient_1_sum - self_1_new * self_0_new_inverse + quotient_1_sum_lo) * down)
    self_2_new_rounded = (self_2_new
        + (quotient_2_sum - self_2_new * self_0_new_inverse + quotient_2_sum_lo) * down)
    self_0_new_final = where(self_0_new_rounded == self_0_new_rounded, self_0_new_rounded,
        self_0_new)
    self_1_new_final = where(self_1_new_rounded == self_1_new_rounded, self_1_new_rounded,
        self_1_new)
    self_2_new_final = where(self_2_new_rounded == self_2_new_rounded, self_2_new_rounded,
        self_2_new)
    return (self_0_new_final, self_1_new_final, self_2_new_final)


@kernel("(3)->(3)")
def vec3_normalized(v):
    """vo = v / |v|; the zero vector stays zero.

    (3)->(3).  v, vo: vector.
    25 mul, 68 add, 4 product error, 3 product rest, 8 div, 1 sqrt, 3 abs, 7 less, 5 equal, 13
    select.
    """
    v_0, v_1, v_2 = v
    s_size_0 = absolute(v_0)
    s_size_1 = absolute(v_1)
    s_size_2 = absolute(v_2)
    s_largest1 = where(s_size_0 < s_size_1, s_size_1, s_size_0)
    s_largest2 = where(s_largest1 < s_size_2, s_size_2, s_largest1)
    s_d = where(s_largest2 < 256, 1.3093562431584567e+151,
        where(6.703903964971299e+153 < s_largest2, real(3.7291703656001034e-155), real(1)))
    s = where(s_largest2 < 1.955159272639747e-149, 1.0715086071862673e+301, s_d)
    y_0 = v_0 * s
    y_1 = v_1 * s
    y_2 = v_2 * s
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
    sized_0 = v_0 * up
    sized_1 = v_1 * up
    sized_2 = v_2 * up
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
    vo_0_rounded = vo_0 + vo_0_rest * down
    vo_1_rounded = vo_1 + vo_1_rest * down
    vo_2_rounded = vo_2 + vo_2_rest * down
    vo_0_final = where(vo_0_rounded == vo_0_rounded, vo_0_rounded, vo_0)
    vo_1_final = where(vo_1_rounded == vo_1_rounded, vo_1_rounded, vo_1)
    vo_2_final = where(vo_2_rounded == vo_2_rounded, vo_2_rounded, vo_2)
    return (vo_0_final, vo_1_final, vo_2_final)


@kernel("(3),(3)->()")
def angle_vv(v1, v2):
    """angle = atan2(|v1 × v2|, v1·v2), in [0, π].

    (3),(3)->().  v1, v2: vector; angle: number.
    164 mul, 333 add, 22 product error, 12 product rest, 8 div, 1 sqrt, 4 neg, 19 abs, 4
    copysign, 35 less, 6 equal, 51 select.  Each component is within 1 ulp as long as its
    condition is below 1e13; in single precision it is the nearest number, except near ties, as
    long as that is below 1e5; searched, not proved.
    """
    v1_0, v1_1, v1_2 = v1
    v2_0, v2_1, v2_2 = v2
    s1_size_0 = absolute(v1_0)
    s1_size_1 = absolute(v1_1)
    s1_size_2 = absolute(v1_2)
    s1_largest1 = where(s1_size_0 < s1_size_1, s1_size_1, s1_size_0)
    s1_largest2 = where(s1_largest1 < s1_size_2, s1_size_2, s1_largest1)
    s1d = where(s1_largest2 < 256, 1.3093562431584567e+151,
        where(6.703903964971299e+153 < s1_largest2, real(3.7291703656001034e-155), real(1)))
    s1 = where(s1_largest2 < 1.955159272639747e-149, 1.0715086071862673e+301, s1d)
    scaled_s1_0 = v1_0 * s1
    scaled_s1_1 = v1_1 * s1
    scaled_s1_2 = v1_2 * s1
    s2_size_0 = absolute(v2_0)
    s2_size_1 = absolute(v2_1)
    s2_size_2 = absolute(v2_2)
    s2_largest1 = where(s2_size_0 < s2_size_1, s2_size_1, s2_size_0)
    s2_largest2 = where(s2_largest1 < s2_size_2, s2_size_2, s2_largest1)
    s2d = where(s2_largest2 < 256, 1.3093562431584567e+151,
        where(6.703903964971299e+153 < s2_largest2, real(3.7291703656001034e-155), real(1)))
    s2 = where(s2_largest2 < 1.955159272639747e-149, 1.0715086071862673e+301, s2d)
    scaled_s2_0 = v2_0 * s2
    scaled_s2_1 = v2_1 * s2
    scaled_s2_2 = v2_2 * s2
    c_0a = scaled_s1_1 * scaled_s2_2
    c_0b = scaled_s1_2 * scaled_s2_1
    c_0 = c_0a - c_0b
    c_0_right = c_0a - c_0
    c_0_lo = (product_rest(scaled_s1_1, scaled_s2_2, c_0a, c_0 + c_0_right)
        - product_rest(scaled_s1_2, scaled_s2_1, c_0b, c_0_right))
    c_1a = scaled_s1_2 * scaled_s2_0
    c_1b = scaled_s1_0 * scaled_s2_2
    c_1 = c_1a - c_1b
    c_1_right = c_1a - c_1
    c_1_lo = (product_rest(scaled_s1_2, scaled_s2_0, c_1a, c_1 + c_1_right)
        - product_rest(scaled_s1_0, scaled_s2_2, c_1b, c_1_right))
    c_2a = scaled_s1_0 * scaled_s2_1
    c_2b = scaled_s1_1 * scaled_s2_0
    c_2 = c_2a - c_2b
    c_2_right = c_2a - c_2
    c_2_lo = (product_rest(scaled_s1_0, scaled_s2_1, c_2a, c_2 + c_2_right)
        - product_rest(scaled_s1_1, scaled_s2_0, c_2b, c_2_right))
    c_0_sum = c_0 + c_0_lo
    c_0_sum_right = c_0_sum - c_0
    c_0_sum_lo = c_0 - (c_0_sum - c_0_sum_right) + (c_0_lo - c_0_sum_right)
    s_size_0 = absolute(c_0_sum)
    s_size_0_lo = where(c_0_sum < 0, -c_0_sum_lo, c_0_sum_lo)
    c_1_sum = c_1 + c_1_lo
    c_1_sum_right = c_1_sum - c_1
    c_1_sum_lo = c_1 - (c_1_sum - c_1_sum_right) + (c_1_lo - c_1_sum_right)
    s_size_1 = absolute(c_1_sum)
    s_size_1_lo = where(c_1_sum < 0, -c_1_sum_lo, c_1_sum_lo)
    c_2_sum = c_2 + c_2_lo
    c_2_sum_right = c_2_sum - c_2
    c_2_sum_lo = c_2 - (c_2_sum - c_2_sum_right) + (c_2_lo - c_2_sum_right)
    s_size_2 = absolute(c_2_sum)
    s_size_2_lo = where(c_2_sum < 0, -c_2_sum_lo, c_2_sum_lo)
    s_size_0_sum = s_size_0 + s_size_0_lo
    s_size_0_sum_right = s_size_0_sum - s_size_0
    s_size_1_sum = s_size_1 + s_size_1_lo
    s_size_1_sum_right = s_size_1_sum - s_size_1
    s_largest1a = s_size_0_sum < s_size_1_sum
    s_largest1 = where(s_largest1a, s_size_1_sum, s_size_0_sum)
    s_size_1_sum_lo = (s_size_1 - (s_size_1_sum - s_size_1_sum_right)
        + (s_size_1_lo - s_size_1_sum_right))
    s_largest1_lo = where(s_largest1a, s_size_1_sum_lo,
        s_size_0 - (s_size_0_sum - s_size_0_sum_right) + (s_size_0_lo - s_size_0_sum_right))
    s_largest1_sum = s_largest1 + s_largest1_lo
    s_largest1_sum_right = s_largest1_sum - s_largest1
    s_size_2_sum = s_size_2 + s_size_2_lo
    s_size_2_sum_right = s_size_2_sum - s_size_2
    s_largest2a = s_largest1_sum < s_size_2_sum
    s_largest2 = where(s_largest2a, s_size_2_sum, s_largest1_sum)
    s_largest1_sum_lo = (s_largest1 - (s_largest1_sum - s_largest1_sum_right)
        + (s_largest1_lo - s_largest1_sum_right))
    s_largest2_lo = where(s_largest2a,
        s_size_2 - (s_size_2_sum - s_size_2_sum_right) + (s_size_2_lo - s_size_2_sum_right),
        s_largest1_sum_lo)
    s_largest2_sum = s_largest2 + s_largest2_lo
    s_d = where(s_largest2_sum < 256, 1.3093562431584567e+151,
        where(6.703903964971299e+153 < s_largest2_sum, real(3.7291703656001034e-155), real(1)))
    s = where(s_largest2_sum < 1.955159272639747e-149, 1.0715086071862673e+301, s_d)
    y_0 = c_0_sum * s
    y_0_inverse = 1 / s
    y_0_lo = (c_0_sum - y_0 * y_0_inverse + c_0_sum_lo) * s
    y_1 = c_1_sum * s
    y_1_lo = (c_1_sum - y_1 * y_0_inverse + c_1_sum_lo) * s
    y_2 = c_2_sum * s
    y_2_lo = (c_2_sum - y_2 * y_0_inverse + c_2_sum_lo) * s
    n_a = y_0 * y_0
    n_b = y_1 * y_1
    n_c = n_a + n_b
    n_c_right = n_c - n_a
    n_c_lo1 = product_rest(y_0, y_0, n_a, n_c - n_c_right) + product_rest(y_1, y_1, n_b, n_c_right)
    n_d = y_2 * y_2
    n_e = n_c + n_d
    n_e_right = n_e - n_c
    n_e_lo2 = (n_c - (n_e - n_e_right) + product_rest(y_2, y_2, n_d, n_e_right)
        + (y_2_lo * y_2 + y_2 * y_2_lo))
    n_e_lo = n_e_lo2 + (n_c_lo1 + (y_0_lo * y_0 + y_0 * y_0_lo + (y_1_lo * y_1 + y_1 * y_1_lo)))
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
    cross = n_sum * r
    cross_lo = (n_sum - cross * (1 / r) + (n - (n_sum - n_sum_right) + (n_lo - n_sum_right))) * r
    dot__a = scaled_s1_0 * scaled_s2_0
    dot__b = scaled_s1_1 * scaled_s2_1
    dot__c = dot__a + dot__b
    dot__c_right = dot__c - dot__a
    dot__d = scaled_s1_2 * scaled_s2_2
    dot_ = dot__c + dot__d
    dot__right = dot_ - dot__c
    dot__c_lo = (product_rest(scaled_s1_0, scaled_s2_0, dot__a, dot__c - dot__c_right)
        + product_rest(scaled_s1_1, scaled_s2_1, dot__b, dot__c_right))
    dot__lo = (dot__c - (dot_ - dot__right)
        + product_rest(scaled_s1_2, scaled_s2_2, dot__d, dot__right) + dot__c_lo)
    cross_sum = cross + cross_lo
    cross_sum_right = cross_sum - cross
    dot__sum = dot_ + dot__lo
    dot__sum_right = dot__sum - dot_
    angle = elementary.atan2(cross_sum, dot__sum)
    angle_size0 = absolute(cross_sum)
    angle_size1 = absolute(dot__sum)
    angle_most = where(angle_size0 < angle_size1, angle_size1, angle_size0)
    angle_zero = angle_most == 0
    angle_divisor = where(angle_zero, 1, angle_most)
    angle_part0 = cross_sum / angle_divisor
    angle_part1 = dot__sum / angle_divisor
    angle_cross1 = (angle_part1
        * (cross - (cross_sum - cross_sum_right) + (cross_lo - cross_sum_right)))
    angle_cross = (angle_cross1 - angle_part0
        * (dot_ - (dot__sum - dot__sum_right) + (dot__lo - dot__sum_right)))
    angle_more = (angle_cross
        / where(angle_zero, 1, angle_divisor
        * (angle_part1 * angle_part1 + angle_part0 * angle_part0)))
    angle_rounded = angle + (elementary.atan2_error(cross_sum, dot__sum, angle) + angle_more)
    angle_final = where(angle_rounded == angle_rounded, angle_rounded, angle)
    return angle_final


@kernel("(3),(3)->()")
def dot_vv(v1, v2):
    """v1·v2.

    (3),(3)->().  v1, v2: vector; dot: number.
    3 mul, 11 add, 3 product rest.  Error <= u |result| + 11 u^2 S, S the sum of the |terms| of
    the expanded formula; barring over- and underflow.
    """
    v1_0, v1_1, v1_2 = v1
    v2_0, v2_1, v2_2 = v2
    dot_a = v1_0 * v2_0
    dot_b = v1_1 * v2_1
    dot_c = dot_a + dot_b
    dot_c_right = dot_c - dot_a
    dot_d = v1_2 * v2_2
    dot = dot_c + dot_d
    dot_right = dot - dot_c
    dot_c_lo = (product_rest(v1_0, v2_0, dot_a, dot_c - dot_c_right)
        + product_rest(v1_1, v2_1, dot_b, dot_c_right))
    dot_rounded = (dot
        + (dot_c - (dot - dot_right) + product_rest(v1_2, v2_2, dot_d, dot_right) + dot_c_lo))
    return dot_rounded


@kernel("(),(3)->(3)")
def product_avinv(k, v):
    """vo = k (-v).

    (),(3)->(3).  k: number; v, vo: vector.
    3 mul, 3 add, 3 product error, 6 neg.  Error <= u |result|, barring over- and underflow.
    """
    v_0, v_1, v_2 = v
    vo_0 = -(k * v_0)
    vo_1 = -(k * v_1)
    vo_2 = -(k * v_2)
    vo_0_rounded = vo_0 + product_error(-k, v_0, vo_0)
    vo_1_rounded = vo_1 + product_error(-k, v_1, vo_1)
    vo_2_rounded = vo_2 + product_error(-k, v_2, vo_2)
    return (vo_0_rounded, vo_1_rounded, vo_2_rounded)


@kernel("(),(3)->(3)")
def product_ainvv(k, v):
    """vo = v / k.

    (),(3)->(3).  k: number; v, vo: vector.
    3 mul, 9 add, 3 product error, 6 div, 3 equal, 3 select.
    """
    v_0, v_1, v_2 = v
    vo_0 = v_0 / k
    vo_0_product = vo_0 * k
    vo_1 = v_1 / k
    vo_1_product = vo_1 * k
    vo_2 = v_2 / k
    vo_2_product = vo_2 * k
    vo_0_rounded = vo_0 + (v_0 - vo_0_product - product_error(vo_0, k, vo_0_product)) / k
    vo_1_rounded = vo_1 + (v_1 - vo_1_product - product_error(vo_1, k, vo_1_product)) / k
    vo_2_rounded = vo_2 + (v_2 - vo_2_product - product_error(vo_2, k, vo_2_product)) / k
    vo_0_final = where(vo_0_rounded == vo_0_rounded, vo_0_rounded, vo_0)
    vo_1_final = where(vo_1_rounded == vo_1_rounded, vo_1_rounded, vo_1)
    vo_2_final = where(vo_2_rounded == vo_2_rounded, vo_2_rounded, vo_2)
    return (vo_0_final, vo_1_final, vo_2_final)


@kernel("(3),(3)->(3)")
def cross_vv(v1, v2):
    """vo = v1 × v2.  Exactly zero for v1 = v2, unless products overflow.

    (3),(3)->(3).  v1, v2, vo: vector.
    6 mul, 15 add, 6 product rest.  Error <= u |result| + 6 u^2 S, S the sum of the |terms| of
    the expanded formula; barring over- and underflow.
    """
    v1_0, v1_1, v1_2 = v1
    v2_0, v2_1, v2_2 = v2
    vo_0a = v1_1 * v2_2
    vo_0b = v1_2 * v2_1
    vo_0 = vo_0a - vo_0b
    vo_0_right = vo_0a - vo_0
    vo_1a = v1_2 * v2_0
    vo_1b = v1_0 * v2_2
    vo_1 = vo_1a - vo_1b
    vo_1_right = vo_1a - vo_1
    vo_2a = v1_0 * v2_1
    vo_2b = v1_1 * v2_0
    vo_2 = vo_2a - vo_2b
    vo_2_right = vo_2a - vo_2
    vo_0_rounded = (vo_0
        + (product_rest(v1_1, v2_2, vo_0a, vo_0 + vo_0_right)
        - product_rest(v1_2, v2_1, vo_0b, vo_0_right)))
    vo_1_rounded = (vo_1
        + (product_rest(v1_2, v2_0, vo_1a, vo_1 + vo_1_right)
        - product_rest(v1_0, v2_2, vo_1b, vo_1_right)))
    vo_2_rounded = (vo_2
        + (product_rest(v1_0, v2_1, vo_2a, vo_2 + vo_2_right)
        - product_rest(v1_1, v2_0, vo_2b, vo_2_right)))
    return (vo_0_rounded, vo_1_rounded, vo_2_rounded)


@kernel("(3),(3)->(3)")
def cross_vvinv(v1, v2):
    """vo = v1 × (-v2).

    (3),(3)->(3).  v1, v2, vo: vector.
    6 mul, 15 add, 6 product rest.  Error <= u |result| + 6 u^2 S, S the sum of the |terms| of
    the expanded formula; barring over- and underflow.
    """
    v1_0, v1_1, v1_2 = v1
    v2_0, v2_1, v2_2 = v2
    vo_0a = v1_2 * v2_1
    vo_0b = v1_1 * v2_2
    vo_0 = vo_0a - vo_0b
    vo_0_right = vo_0a - vo_0
    vo_1a = v1_0 * v2_2
    vo_1b = v1_2 * v2_0
    vo_1 = vo_1a - vo_1b
    vo_1_right = vo_1a - vo_1
    vo_2a = v1_1 * v2_0
    vo_2b = v1_0 * v2_1
    vo_2 = vo_2a - vo_2b
    vo_2_right = vo_2a - vo_2
    vo_0_rounded = (vo_0
        + (product_rest(v1_2, v2_1, vo_0a, vo_0 + vo_0_right)
        - product_rest(v1_1, v2_2, vo_0b, vo_0_right)))
    vo_1_rounded = (vo_1
        + (product_rest(v1_0, v2_2, vo_1a, vo_1 + vo_1_right)
        - product_rest(v1_2, v2_0, vo_1b, vo_1_right)))
    vo_2_rounded = (vo_2
        + (product_rest(v1_1, v2_0, vo_2a, vo_2 + vo_2_right)
        - product_rest(v1_0, v2_1, vo_2b, vo_2_right)))
    return (vo_0_rounded, vo_1_rounded, vo_2_rounded)


@kernel("(3),()->(3)")
def add_vvx(v, k):
    """vo = v + k e_x.

    (3),()->(3).  v, vo: vector; k: number.
    7 add.  Error <= u |result|, barring over- and underflow.
    """
    v_0, v_1, v_2 = v
    vo_0 = v_0 + k
    vo_0_right = vo_0 - v_0
    vo_0_rounded = vo_0 + (v_0 - (vo_0 - vo_0_right) + (k - vo_0_right))
    return (vo_0_rounded, v_1, v_2)


@kernel("(3),()->(3)")
def add_vvxinv(v, k):
    """vo = v - k e_x.

    (3),()->(3).  v, vo: vector; k: number.
    7 add.  Error <= u |result|, barring over- and underflow.
    """
    v_0, v_1, v_2 = v
    vo_0 = v_0 - k
    vo_0_right = v_0 - vo_0
    vo_0_rounded = vo_0 + (v_0 - (vo_0 + vo_0_right) - (k - vo_0_right))
    return (vo_0_rounded, v_1, v_2)


@kernel("(3),()->(3)")
def add_vvy(v, k):
    """vo = v + k e_y.

    (3),()->(3).  v, vo: vector; k: number.
    7 add.  Error <= u |result|, barring over- and underflow.
    """
    v_0, v_1, v_2 = v
    vo_1 = v_1 + k
    vo_1_right = vo_1 - v_1
    vo_1_rounded = vo_1 + (v_1 - (vo_1 - vo_1_right) + (k - vo_1_right))
    return (v_0, vo_1_rounded, v_2)


@kernel("(3),()->(3)")
def add_vvyinv(v, k):
    """vo = v - k e_y.

    (3),()->(3).  v, vo: vector; k: number.
    7 add.  Error <= u |result|, barring over- and underflow.
    """
    v_0, v_1, v_2 = v
    vo_1 = v_1 - k
    vo_1_right = v_1 - vo_1
    vo_1_rounded = vo_1 + (v_1 - (vo_1 + vo_1_right) - (k - vo_1_right))
    return (v_0, vo_1_rounded, v_2)


@kernel("(3),()->(3)")
def add_vvz(v, k):
    """vo = v + k e_z.

    (3),()->(3).  v, vo: vector; k: number.
    7 add.  Error <= u |result|, barring over- and underflow.
    """
    v_0, v_1, v_2 = v
    vo_2 = v_2 + k
    vo_2_right = vo_2 - v_2
    vo_2_rounded = vo_2 + (v_2 - (vo_2 - vo_2_right) + (k - vo_2_right))
    return (v_0, v_1, vo_2_rounded)


@kernel("(3),()->(3)")
def add_vvzinv(v, k):
    """vo = v - k e_z.

    (3),()->(3).  v, vo: vector; k: number.
    7 add.  Error <= u |result|, barring over- and underflow.
    """
    v_0, v_1, v_2 = v
    vo_2 = v_2 - k
    vo_2_right = v_2 - vo_2
    vo_2_rounded = vo_2 + (v_2 - (vo_2 + vo_2_right) - (k - vo_2_right))
    return (v_0, v_1, vo_2_rounded)
