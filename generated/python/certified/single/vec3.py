# Made by `coscrew generate`; changes are overwritten.
# SPDX-License-Identifier: MIT
# coscrew 0.2.0.  Copyright (c) 2026 The coscrew authors.
"""Vectors of three components.

In single precision, certified tier.
"""

from numpy import absolute
from coscrew._kernel import single_kernel as kernel


@kernel("(3),()->(3),(3)")
def vec3_scale(self, a):
    """self = a self; |error of self| <= self_bound unless inf or NaN.

    (3),()->(3),(3).  self, self_bound: vector; a: number.
    6 mul, 3 add, 3 abs.
    """
    self_0, self_1, self_2 = self
    self_0_new = self_0 * a
    self_1_new = self_1 * a
    self_2_new = self_2 * a
    self_0_new_error_bound = 5.960465e-08 * (absolute(self_0_new) + 1.9721522630525295e-31)
    self_1_new_error_bound = 5.960465e-08 * (absolute(self_1_new) + 1.9721522630525295e-31)
    self_2_new_error_bound = 5.960465e-08 * (absolute(self_2_new) + 1.9721522630525295e-31)
    return (self_0_new, self_1_new, self_2_new, self_0_new_error_bound, self_1_new_error_bound,
        self_2_new_error_bound)


@kernel("(),(3),(3)->(3),(3)")
def axpy_vv(a, x, y):
    """y = a x + y; |error of y| <= y_bound unless inf or NaN.

    (),(3),(3)->(3),(3).  a: number; x, y, y_bound: vector.
    6 mul, 9 add, 6 abs.
    """
    x_0, x_1, x_2 = x
    y_0, y_1, y_2 = y
    y_0_new_a = a * x_0
    y_0_new = y_0_new_a + y_0
    y_1_new_a = a * x_1
    y_1_new = y_1_new_a + y_1
    y_2_new_a = a * x_2
    y_2_new = y_2_new_a + y_2
    y_0_new_size = absolute(y_0_new_a) + absolute(y_0)
    y_1_new_size = absolute(y_1_new_a) + absolute(y_1)
    y_2_new_size = absolute(y_2_new_a) + absolute(y_2)
    y_0_new_error_bound = 1.192093e-07 * (y_0_new_size + 1.9721522630525295e-31)
    y_1_new_error_bound = 1.192093e-07 * (y_1_new_size + 1.9721522630525295e-31)
    y_2_new_error_bound = 1.192093e-07 * (y_2_new_size + 1.9721522630525295e-31)
    return (y_0_new, y_1_new, y_2_new, y_0_new_error_bound, y_1_new_error_bound,
        y_2_new_error_bound)


@kernel("(3),(3)->(3),(3)")
def xpy_vv(x, y):
    """y = x + y; |error of y| <= y_bound unless inf or NaN.

    (3),(3)->(3),(3).  x, y, y_bound: vector.
    3 mul, 3 add, 3 abs.
    """
    x_0, x_1, x_2 = x
    y_0, y_1, y_2 = y
    y_0_new = x_0 + y_0
    y_1_new = x_1 + y_1
    y_2_new = x_2 + y_2
    y_0_new_error_bound = 5.960465e-08 * absolute(y_0_new)
    y_1_new_error_bound = 5.960465e-08 * absolute(y_1_new)
    y_2_new_error_bound = 5.960465e-08 * absolute(y_2_new)
    return (y_0_new, y_1_new, y_2_new, y_0_new_error_bound, y_1_new_error_bound,
        y_2_new_error_bound)


@kernel("(3),(3)->(3),(3)")
def nxpy_vv(x, y):
    """y = -x + y; |error of y| <= y_bound unless inf or NaN.

    (3),(3)->(3),(3).  x, y, y_bound: vector.
    3 mul, 3 add, 3 abs.
    """
    x_0, x_1, x_2 = x
    y_0, y_1, y_2 = y
    y_0_new = y_0 - x_0
    y_1_new = y_1 - x_1
    y_2_new = y_2 - x_2
    y_0_new_error_bound = 5.960465e-08 * absolute(y_0_new)
    y_1_new_error_bound = 5.960465e-08 * absolute(y_1_new)
    y_2_new_error_bound = 5.960465e-08 * absolute(y_2_new)
    return (y_0_new, y_1_new, y_2_new, y_0_new_error_bound, y_1_new_error_bound,
        y_2_new_error_bound)


@kernel("(),(3)->(3),(3)")
def product_av(a, vi):
    """vo = a vi; |error of vo| <= vo_bound unless inf or NaN.

    (),(3)->(3),(3).  a: number; vi, vo, vo_bound: vector.
    6 mul, 3 add, 3 abs.
    """
    vi_0, vi_1, vi_2 = vi
    vo_0 = a * vi_0
    vo_1 = a * vi_1
    vo_2 = a * vi_2
    vo_0_error_bound = 5.960465e-08 * (absolute(vo_0) + 1.9721522630525295e-31)
    vo_1_error_bound = 5.960465e-08 * (absolute(vo_1) + 1.9721522630525295e-31)
    vo_2_error_bound = 5.960465e-08 * (absolute(vo_2) + 1.9721522630525295e-31)
    return (vo_0, vo_1, vo_2, vo_0_error_bound, vo_1_error_bound, vo_2_error_bound)


@kernel("(3),(3)->(3),(3)")
def add_vv(v1, v2):
    """vo = v1 + v2; |error of vo| <= vo_bound unless inf or NaN.

    (3),(3)->(3),(3).  v1, v2, vo, vo_bound: vector.
    3 mul, 3 add, 3 abs.
    """
    v1_0, v1_1, v1_2 = v1
    v2_0, v2_1, v2_2 = v2
    vo_0 = v1_0 + v2_0
    vo_1 = v1_1 + v2_1
    vo_2 = v1_2 + v2_2
    vo_0_error_bound = 5.960465e-08 * absolute(vo_0)
    vo_1_error_bound = 5.960465e-08 * absolute(vo_1)
    vo_2_error_bound = 5.960465e-08 * absolute(vo_2)
    return (vo_0, vo_1, vo_2, vo_0_error_bound, vo_1_error_bound, vo_2_error_bound)


@kernel("(3),(3)->(3),(3)")
def subtract_vv(v1, v2):
    """vo = v1 - v2; |error of vo| <= vo_bound unless inf or NaN.

    (3),(3)->(3),(3).  v1, v2, vo, vo_bound: vector.
    3 mul, 3 add, 3 abs.
    """
    v1_0, v1_1, v1_2 = v1
    v2_0, v2_1, v2_2 = v2
    vo_0 = v1_0 - v2_0
    vo_1 = v1_1 - v2_1
    vo_2 = v1_2 - v2_2
    vo_0_error_bound = 5.960465e-08 * absolute(vo_0)
    vo_1_error_bound = 5.960465e-08 * absolute(vo_1)
    vo_2_error_bound = 5.960465e-08 * absolute(vo_2)
    return (vo_0, vo_1, vo_2, vo_0_error_bound, vo_1_error_bound, vo_2_error_bound)


@kernel("(3),()->(3),(3)")
def vec3_scaled(v, k):
    """vo = k v; |error of vo| <= vo_bound unless inf or NaN.

    (3),()->(3),(3).  v, vo, vo_bound: vector; k: number.
    6 mul, 3 add, 3 abs.
    """
    v_0, v_1, v_2 = v
    vo_0 = v_0 * k
    vo_1 = v_1 * k
    vo_2 = v_2 * k
    vo_0_error_bound = 5.960465e-08 * (absolute(vo_0) + 1.9721522630525295e-31)
    vo_1_error_bound = 5.960465e-08 * (absolute(vo_1) + 1.9721522630525295e-31)
    vo_2_error_bound = 5.960465e-08 * (absolute(vo_2) + 1.9721522630525295e-31)
    return (vo_0, vo_1, vo_2, vo_0_error_bound, vo_1_error_bound, vo_2_error_bound)


@kernel("(3),(3)->(),()")
def dot_vv(v1, v2):
    """v1·v2; |error of dot| <= dot_bound unless inf or NaN.

    (3),(3)->(),().  v1, v2: vector; dot, dot_bound: number.
    4 mul, 5 add, 3 abs.
    """
    v1_0, v1_1, v1_2 = v1
    v2_0, v2_1, v2_2 = v2
    dot_a = v1_0 * v2_0
    dot_b = v1_1 * v2_1
    dot_d = v1_2 * v2_2
    dot = dot_a + dot_b + dot_d
    dot_size = absolute(dot_a) + absolute(dot_b) + absolute(dot_d)
    dot_error_bound = 1.7881396e-07 * (dot_size + 1.9721522630525295e-31)
    return (dot, dot_error_bound)


@kernel("(),(3)->(3),(3)")
def product_avinv(k, v):
    """vo = k (-v); |error of vo| <= vo_bound unless inf or NaN.

    (),(3)->(3),(3).  k: number; v, vo, vo_bound: vector.
    6 mul, 3 add, 3 neg, 3 abs.
    """
    v_0, v_1, v_2 = v
    vo_0a = k * v_0
    vo_0 = -vo_0a
    vo_1a = k * v_1
    vo_1 = -vo_1a
    vo_2a = k * v_2
    vo_2 = -vo_2a
    vo_0a_error_bound = 5.960465e-08 * (absolute(vo_0a) + 1.9721522630525295e-31)
    vo_1a_error_bound = 5.960465e-08 * (absolute(vo_1a) + 1.9721522630525295e-31)
    vo_2a_error_bound = 5.960465e-08 * (absolute(vo_2a) + 1.9721522630525295e-31)
    return (vo_0, vo_1, vo_2, vo_0a_error_bound, vo_1a_error_bound, vo_2a_error_bound)


@kernel("(3),(3)->(3),(3)")
def cross_vv(v1, v2):
    """vo = v1 × v2; |error of vo| <= vo_bound unless inf or NaN.  Exactly zero for v1 = v2, unless
    products overflow.

    (3),(3)->(3),(3).  v1, v2, vo, vo_bound: vector.
    9 mul, 9 add, 6 abs.
    """
    v1_0, v1_1, v1_2 = v1
    v2_0, v2_1, v2_2 = v2
    vo_0a = v1_1 * v2_2
    vo_0b = v1_2 * v2_1
    vo_0 = vo_0a - vo_0b
    vo_1a = v1_2 * v2_0
    vo_1b = v1_0 * v2_2
    vo_1 = vo_1a - vo_1b
    vo_2a = v1_0 * v2_1
    vo_2b = v1_1 * v2_0
    vo_2 = vo_2a - vo_2b
    vo_0_size = absolute(vo_0a) + absolute(vo_0b)
    vo_1_size = absolute(vo_1a) + absolute(vo_1b)
    vo_2_size = absolute(vo_2a) + absolute(vo_2b)
    vo_0_error_bound = 1.192093e-07 * (vo_0_size + 1.9721522630525295e-31)
    vo_1_error_bound = 1.192093e-07 * (vo_1_size + 1.9721522630525295e-31)
    vo_2_error_bound = 1.192093e-07 * (vo_2_size + 1.9721522630525295e-31)
    return (vo_0, vo_1, vo_2, vo_0_error_bound, vo_1_error_bound, vo_2_error_bound)


@kernel("(3),(3)->(3),(3)")
def cross_vvinv(v1, v2):
    """vo = v1 × (-v2); |error of vo| <= vo_bound unless inf or NaN.

    (3),(3)->(3),(3).  v1, v2, vo, vo_bound: vector.
    9 mul, 9 add, 6 abs.
    """
    v1_0, v1_1, v1_2 = v1
    v2_0, v2_1, v2_2 = v2
    vo_0a = v1_2 * v2_1
    vo_0b = v1_1 * v2_2
    vo_0 = vo_0a - vo_0b
    vo_1a = v1_0 * v2_2
    vo_1b = v1_2 * v2_0
    vo_1 = vo_1a - vo_1b
    vo_2a = v1_1 * v2_0
    vo_2b = v1_0 * v2_1
    vo_2 = vo_2a - vo_2b
    vo_0_size = absolute(vo_0a) + absolute(vo_0b)
    vo_1_size = absolute(vo_1a) + absolute(vo_1b)
    vo_2_size = absolute(vo_2a) + absolute(vo_2b)
    vo_0_error_bound = 1.192093e-07 * (vo_0_size + 1.9721522630525295e-31)
    vo_1_error_bound = 1.192093e-07 * (vo_1_size + 1.9721522630525295e-31)
    vo_2_error_bound = 1.192093e-07 * (vo_2_size + 1.9721522630525295e-31)
    return (vo_0, vo_1, vo_2, vo_0_error_bound, vo_1_error_bound, vo_2_error_bound)


@kernel("(3),()->(3),(3)")
def add_vvx(v, k):
    """vo = v + k e_x; |error of vo| <= vo_bound unless inf or NaN.

    (3),()->(3),(3).  v, vo, vo_bound: vector; k: number.
    1 mul, 1 add, 1 abs.
    """
    v_0, v_1, v_2 = v
    vo_0 = v_0 + k
    vo_0_error_bound = 5.960465e-08 * absolute(vo_0)
    return (vo_0, v_1, v_2, vo_0_error_bound, 0, 0)


@kernel("(3),()->(3),(3)")
def add_vvxinv(v, k):
    """vo = v - k e_x; |error of vo| <= vo_bound unless inf or NaN.

    (3),()->(3),(3).  v, vo, vo_bound: vector; k: number.
    1 mul, 1 add, 1 abs.
    """
    v_0, v_1, v_2 = v
    vo_0 = v_0 - k
    vo_0_error_bound = 5.960465e-08 * absolute(vo_0)
    return (vo_0, v_1, v_2, vo_0_error_bound, 0, 0)


@kernel("(3),()->(3),(3)")
def add_vvy(v, k):
    """vo = v + k e_y; |error of vo| <= vo_bound unless inf or NaN.

    (3),()->(3),(3).  v, vo, vo_bound: vector; k: number.
    1 mul, 1 add, 1 abs.
    """
    v_0, v_1, v_2 = v
    vo_1 = v_1 + k
    vo_1_error_bound = 5.960465e-08 * absolute(vo_1)
    return (v_0, vo_1, v_2, 0, vo_1_error_bound, 0)


@kernel("(3),()->(3),(3)")
def add_vvyinv(v, k):
    """vo = v - k e_y; |error of vo| <= vo_bound unless inf or NaN.

    (3),()->(3),(3).  v, vo, vo_bound: vector; k: number.
    1 mul, 1 add, 1 abs.
    """
    v_0, v_1, v_2 = v
    vo_1 = v_1 - k
    vo_1_error_bound = 5.960465e-08 * absolute(vo_1)
    return (v_0, vo_1, v_2, 0, vo_1_error_bound, 0)


@kernel("(3),()->(3),(3)")
def add_vvz(v, k):
    """vo = v + k e_z; |error of vo| <= vo_bound unless inf or NaN.

    (3),()->(3),(3).  v, vo, vo_bound: vector; k: number.
    1 mul, 1 add, 1 abs.
    """
    v_0, v_1, v_2 = v
    vo_2 = v_2 + k
    vo_2_error_bound = 5.960465e-08 * absolute(vo_2)
    return (v_0, v_1, vo_2, 0, 0, vo_2_error_bound)


@kernel("(3),()->(3),(3)")
def add_vvzinv(v, k):
    """vo = v - k e_z; |error of vo| <= vo_bound unless inf or NaN.

    (3),()->(3),(3).  v, vo, vo_bound: vector; k: number.
    1 mul, 1 add, 1 abs.
    """
    v_0, v_1, v_2 = v
    vo_2 = v_2 - k
    vo_2_error_bound = 5.960465e-08 * absolute(vo_2)
    return (v_0, v_1, vo_2, 0, 0, vo_2_error_bound)
