# Made by `coscrew generate`; changes are overwritten.
# SPDX-License-Identifier: MIT
# coscrew 0.2.0.  Copyright (c) 2026 The coscrew authors.
"""Vectors of three components.

In double precision, certified tier.
"""

from coscrew import _elementary_double as elementary
from numpy import absolute, float64 as real, sqrt, where
from coscrew._exact import product_error, product_rest
from coscrew._kernel import double_kernel as kernel
from numpy import errstate


@kernel("(3),()->(3),(3)")
@errstate(all="ignore")
def vec3_scale(self, a, *, c1=2.004168360008973e-292, c2=1.1102230246251568e-16):
    """self = a self; |error of self| <= self_bound unless inf or NaN.

    (3),()->(3),(3).  self, self_bound: vector; a: number.
    6 mul, 3 add, 3 abs.
    """
    self_0, self_1, self_2 = self
    self_0_new = self_0 * a
    self_1_new = self_1 * a
    self_2_new = self_2 * a
    self_0_new_bound = c2 * (absolute(self_0_new) + c1)
    self_1_new_bound = c2 * (absolute(self_1_new) + c1)
    self_2_new_bound = c2 * (absolute(self_2_new) + c1)
    return (self_0_new, self_1_new, self_2_new, self_0_new_bound, self_1_new_bound,
        self_2_new_bound)


@kernel("(),(3),(3)->(3),(3)")
@errstate(all="ignore")
def axpy_vv(a, x, y, *, c1=2.004168360008973e-292, c2=2.2204460492503136e-16):
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
    y_0_new_bound = c2 * (y_0_new_size + c1)
    y_1_new_bound = c2 * (y_1_new_size + c1)
    y_2_new_bound = c2 * (y_2_new_size + c1)
    return (y_0_new, y_1_new, y_2_new, y_0_new_bound, y_1_new_bound, y_2_new_bound)


@kernel("(3),(3)->(3),(3)")
@errstate(all="ignore")
def xpy_vv(x, y, *, c1=1.1102230246251568e-16):
    """y = x + y; |error of y| <= y_bound unless inf or NaN.

    (3),(3)->(3),(3).  x, y, y_bound: vector.
    3 mul, 3 add, 3 abs.
    """
    x_0, x_1, x_2 = x
    y_0, y_1, y_2 = y
    y_0_new = x_0 + y_0
    y_1_new = x_1 + y_1
    y_2_new = x_2 + y_2
    y_0_new_bound = c1 * absolute(y_0_new)
    y_1_new_bound = c1 * absolute(y_1_new)
    y_2_new_bound = c1 * absolute(y_2_new)
    return (y_0_new, y_1_new, y_2_new, y_0_new_bound, y_1_new_bound, y_2_new_bound)


@kernel("(3),(3)->(3),(3)")
@errstate(all="ignore")
def nxpy_vv(x, y, *, c1=1.1102230246251568e-16):
    """y = -x + y; |error of y| <= y_bound unless inf or NaN.

    (3),(3)->(3),(3).  x, y, y_bound: vector.
    3 mul, 3 add, 3 abs.
    """
    x_0, x_1, x_2 = x
    y_0, y_1, y_2 = y
    y_0_new = y_0 - x_0
    y_1_new = y_1 - x_1
    y_2_new = y_2 - x_2
    y_0_new_bound = c1 * absolute(y_0_new)
    y_1_new_bound = c1 * absolute(y_1_new)
    y_2_new_bound = c1 * absolute(y_2_new)
    return (y_0_new, y_1_new, y_2_new, y_0_new_bound, y_1_new_bound, y_2_new_bound)


@kernel("(),(3)->(3),(3)")
@errstate(all="ignore")
def product_av(a, vi, *, c1=2.004168360008973e-292, c2=1.1102230246251568e-16):
    """vo = a vi; |error of vo| <= vo_bound unless inf or NaN.

    (),(3)->(3),(3).  a: number; vi, vo, vo_bound: vector.
    6 mul, 3 add, 3 abs.
    """
    vi_0, vi_1, vi_2 = vi
    vo_0 = a * vi_0
    vo_1 = a * vi_1
    vo_2 = a * vi_2
    vo_0_bound = c2 * (absolute(vo_0) + c1)
    vo_1_bound = c2 * (absolute(vo_1) + c1)
    vo_2_bound = c2 * (absolute(vo_2) + c1)
    return (vo_0, vo_1, vo_2, vo_0_bound, vo_1_bound, vo_2_bound)


@kernel("(3),(3)->(3),(3)")
@errstate(all="ignore")
def add_vv(v1, v2, *, c1=1.1102230246251568e-16):
    """vo = v1 + v2; |error of vo| <= vo_bound unless inf or NaN.

    (3),(3)->(3),(3).  v1, v2, vo, vo_bound: vector.
    3 mul, 3 add, 3 abs.
    """
    v1_0, v1_1, v1_2 = v1
    v2_0, v2_1, v2_2 = v2
    vo_0 = v1_0 + v2_0
    vo_1 = v1_1 + v2_1
    vo_2 = v1_2 + v2_2
    vo_0_bound = c1 * absolute(vo_0)
    vo_1_bound = c1 * absolute(vo_1)
    vo_2_bound = c1 * absolute(vo_2)
    return (vo_0, vo_1, vo_2, vo_0_bound, vo_1_bound, vo_2_bound)


@kernel("(3),(3)->(3),(3)")
@errstate(all="ignore")
def subtract_vv(v1, v2, *, c1=1.1102230246251568e-16):
    """vo = v1 - v2; |error of vo| <= vo_bound unless inf or NaN.

    (3),(3)->(3),(3).  v1, v2, vo, vo_bound: vector.
    3 mul, 3 add, 3 abs.
    """
    v1_0, v1_1, v1_2 = v1
    v2_0, v2_1, v2_2 = v2
    vo_0 = v1_0 - v2_0
    vo_1 = v1_1 - v2_1
    vo_2 = v1_2 - v2_2
    vo_0_bound = c1 * absolute(vo_0)
    vo_1_bound = c1 * absolute(vo_1)
    vo_2_bound = c1 * absolute(vo_2)
    return (vo_0, vo_1, vo_2, vo_0_bound, vo_1_bound, vo_2_bound)


@kernel("(3),()->(3),(3)")
@errstate(all="ignore")
def vec3_scaled(v, k, *, c1=2.004168360008973e-292, c2=1.1102230246251568e-16):
    """vo = k v; |error of vo| <= vo_bound unless inf or NaN.

    (3),()->(3),(3).  v, vo, vo_bound: vector; k: number.
    6 mul, 3 add, 3 abs.
    """
    v_0, v_1, v_2 = v
    vo_0 = v_0 * k
    vo_1 = v_1 * k
    vo_2 = v_2 * k
    vo_0_bound = c2 * (absolute(vo_0) + c1)
    vo_1_bound = c2 * (absolute(vo_1) + c1)
    vo_2_bound = c2 * (absolute(vo_2) + c1)
    return (vo_0, vo_1, vo_2, vo_0_bound, vo_1_bound, vo_2_bound)


@kernel("(3),(3)->(),()")
@errstate(all="ignore")
def angle_vv(v1, v2, *, c1=6.703903964971299e+153, c2=3.7291703656001034e-155,
        c3=1.3093562431584567e+151, c4=1.955159272639747e-149, c5=1.0715086071862673e+301,
        c6=1.8051943758648296e-276, c7=1.6886556573573792e-30, c8=140737488355328,
        c9=8.430953463617394e-30, c10=1.2578234859437304e+29, c11=2.6815615859885194e+154,
        c12=7.637340908749012e-152, c13=9.332636185032189e-302, c14=8.751429663976426e-30,
        c15=2.477516562578394e-30, c16=3.9614069451219335e+28, c17=2.603241918220875e-29):
    """angle = atan2(|v1 × v2|, v1·v2), in [0, π]; |error of angle| <= angle_bound unless inf or
    NaN.

    (3),(3)->(),().  v1, v2: vector; angle, angle_bound: number.
    196 mul, 311 add, 22 product error, 12 product rest, 12 div, 2 sqrt, 1 neg, 40 abs, 4
    copysign, 37 less, 5 equal, 56 select.
    """
    v1_0, v1_1, v1_2 = v1
    v2_0, v2_1, v2_2 = v2
    s1_size_0 = absolute(v1_0)
    s1_size_1 = absolute(v1_1)
    s1_size_2 = absolute(v1_2)
    s1_largest1 = where(s1_size_0 < s1_size_1, s1_size_1, s1_size_0)
    s1_largest2 = where(s1_largest1 < s1_size_2, s1_size_2, s1_largest1)
    s1 = where(s1_largest2 < c4, c5, where(s1_largest2 < 256, c3, where(c1 < s1_largest2, real(c2),
        real(1))))
    scaled_s1_0 = v1_0 * s1
    scaled_s1_1 = v1_1 * s1
    scaled_s1_2 = v1_2 * s1
    s2_size_0 = absolute(v2_0)
    s2_size_1 = absolute(v2_1)
    s2_size_2 = absolute(v2_2)
    s2_largest1 = where(s2_size_0 < s2_size_1, s2_size_1, s2_size_0)
    s2_largest2 = where(s2_largest1 < s2_size_2, s2_size_2, s2_largest1)
    s2 = where(s2_largest2 < c4, c5, where(s2_largest2 < 256, c3, where(c1 < s2_largest2, real(c2),
        real(1))))
    scaled_s2_0 = v2_0 * s2
    scaled_s2_1 = v2_1 * s2
    scaled_s2_2 = v2_2 * s2
    c_0a = scaled_s1_1 * scaled_s2_2
    c_0a_padded_1 = c6 + absolute(scaled_s1_1)
    c_0a_padded_2 = c6 + absolute(scaled_s2_2)
    c_0b = scaled_s1_2 * scaled_s2_1
    c_0b_padded_1 = c6 + absolute(scaled_s1_2)
    c_0b_padded_2 = c6 + absolute(scaled_s2_1)
    c_0 = c_0a - c_0b
    c_right_1 = c_0a - c_0
    c_1a = scaled_s1_2 * scaled_s2_0
    c_1a_padded_1 = c6 + absolute(scaled_s2_0)
    c_1b = scaled_s1_0 * scaled_s2_2
    c_1b_padded_1 = c6 + absolute(scaled_s1_0)
    c_1 = c_1a - c_1b
    c_right_2 = c_1a - c_1
    c_2a = scaled_s1_0 * scaled_s2_1
    c_2b = scaled_s1_1 * scaled_s2_0
    c_2 = c_2a - c_2b
    c_right_3 = c_2a - c_2
    s_size_0 = absolute(c_0)
    s_size_1 = absolute(c_1)
    s_size_2 = absolute(c_2)
    s_largest1 = where(s_size_0 < s_size_1, s_size_1, s_size_0)
    s_largest2 = where(s_largest1 < s_size_2, s_size_2, s_largest1)
    s_a = c1 < s_largest2
    s_c = s_largest2 < 256
    s_e = s_largest2 < c4
    s = where(s_e, c5, where(s_c, c3, where(s_a, real(c2), real(1))))
    s_size_3 = where(s_e, c5, where(s_c, c3, where(s_a, real(c2), real(1))))
    y_0 = c_0 * s
    y_inverse_1 = 1 / s
    c_lo_1 = (product_rest(scaled_s1_1, scaled_s2_2, c_0a, c_0 + c_right_1)
        - product_rest(scaled_s1_2, scaled_s2_1, c_0b, c_right_1))
    y_lo_1 = (c_0 - y_0 * y_inverse_1 + c_lo_1) * s
    y_1 = c_1 * s
    c_lo_2 = (product_rest(scaled_s1_2, scaled_s2_0, c_1a, c_1 + c_right_2)
        - product_rest(scaled_s1_0, scaled_s2_2, c_1b, c_right_2))
    y_lo_2 = (c_1 - y_1 * y_inverse_1 + c_lo_2) * s
    y_2 = c_2 * s
    c_lo_3 = (product_rest(scaled_s1_0, scaled_s2_1, c_2a, c_2 + c_right_3)
        - product_rest(scaled_s1_1, scaled_s2_0, c_2b, c_right_3))
    y_lo_3 = (c_2 - y_2 * y_inverse_1 + c_lo_3) * s
    n_a = y_0 * y_0
    n_a_padded_1 = (c6 + s_size_3
        * (c6 + (c_0a_padded_1 * c_0a_padded_2 + c_0b_padded_1 * c_0b_padded_2)))
    n_a_size_2 = n_a_padded_1 * (absolute(y_0) + c8 * (absolute(y_lo_1) + c7 * n_a_padded_1))
    n_b = y_1 * y_1
    n_b_padded_1 = (c6 + s_size_3
        * (c6 + (c_0b_padded_1 * c_1a_padded_1 + c_0a_padded_2 * c_1b_padded_1)))
    n_b_size_2 = n_b_padded_1 * (absolute(y_1) + c8 * (absolute(y_lo_2) + c7 * n_b_padded_1))
    n_c = n_a + n_b
    n_c_right_1 = n_c - n_a
    n_c_lo1_1 = (product_rest(y_0, y_0, n_a, n_c - n_c_right_1)
        + product_rest(y_1, y_1, n_b, n_c_right_1))
    n_d = y_2 * y_2
    n_d_padded_1 = (c6 + s_size_3
        * (c6 + (c_0b_padded_2 * c_1b_padded_1 + c_0a_padded_1 * c_1a_padded_1)))
    n_d_size_2 = n_d_padded_1 * (absolute(y_2) + c8 * (absolute(y_lo_3) + c7 * n_d_padded_1))
    n_e = n_c + n_d
    n_e_right_1 = n_e - n_c
    n_e_lo2_1 = (n_c - (n_e - n_e_right_1) + product_rest(y_2, y_2, n_d, n_e_right_1)
        + (y_lo_3 * y_2 + y_2 * y_lo_3))
    n_e_lo = n_e_lo2_1 + (n_c_lo1_1 + (y_lo_1 * y_0 + y_0 * y_lo_1 + (y_lo_2 * y_1 + y_1 * y_lo_2)))
    n = sqrt(n_e)
    n_product_1 = n * n
    n_lo = (n_e - n_product_1 - product_error(n, n, n_product_1) + n_e_lo) / where(n == 0, 1, n + n)
    n_padded_1 = (c6
        + (n_a_size_2 + n_a_size_2 + (n_b_size_2 + n_b_size_2) + (n_d_size_2 + n_d_size_2)))
    n_bound_1 = absolute(n_e_lo) + c9 * n_padded_1
    r_a = s < 1
    r_c = 1 < s
    r_e = c3 < s
    r = where(r_e, c13, where(r_c, c12, where(r_a, real(c11), real(1))))
    cross = n * r
    cross_lo = (n - cross * (1 / r) + n_lo) * r
    n_size_12 = (n
        + where(4 * n_bound_1 < n_e, (absolute(n_e) + c8 * n_bound_1) * (n_padded_1 / n / n_e), c10
        * (sqrt(n_bound_1) + absolute(n_lo))))
    dot__a = scaled_s1_0 * scaled_s2_0
    dot__b = scaled_s1_1 * scaled_s2_1
    dot__c = dot__a + dot__b
    dot__c_right_1 = dot__c - dot__a
    dot__d = scaled_s1_2 * scaled_s2_2
    dot_ = dot__c + dot__d
    dot__right_1 = dot_ - dot__c
    dot__c_lo = (product_rest(scaled_s1_0, scaled_s2_0, dot__a, dot__c - dot__c_right_1)
        + product_rest(scaled_s1_1, scaled_s2_1, dot__b, dot__c_right_1))
    dot__lo = (dot__c - (dot_ - dot__right_1)
        + product_rest(scaled_s1_2, scaled_s2_2, dot__d, dot__right_1) + dot__c_lo)
    angle = elementary.atan2(cross, dot_)
    angle_size0_1 = absolute(cross)
    angle_size1_1 = absolute(dot_)
    angle_most_1 = where(angle_size0_1 < angle_size1_1, angle_size1_1, angle_size0_1)
    angle_zero_1 = angle_most_1 == 0
    angle_divisor_1 = where(angle_zero_1, 1, angle_most_1)
    angle_part0_1 = cross / angle_divisor_1
    angle_part1_1 = dot_ / angle_divisor_1
    angle_safe_1 = where(angle_zero_1, 1,
        angle_divisor_1 * (angle_part1_1 * angle_part1_1 + angle_part0_1 * angle_part0_1))
    angle_padded_1 = (c6 + (c6 + n_size_12)
        * where(r_e, c13, where(r_c, c12, where(r_a, real(c11), real(1)))))
    angle_padded_2 = (c6
        + (c_1a_padded_1 * c_1b_padded_1 + c_0a_padded_1 * c_0b_padded_2 + c_0a_padded_2
        * c_0b_padded_1))
    angle_size_2 = absolute(cross)
    angle_size_3 = absolute(dot_)
    angle_size_5 = where(angle_size_2 < angle_size_3, angle_size_3, angle_size_2)
    angle_bound_1 = absolute(cross_lo) + c14 * angle_padded_1
    angle_bound_2 = absolute(dot__lo) + c15 * angle_padded_2
    angle_size_11 = (angle_bound_2 + (c6 + angle_bound_1)) / angle_size_5
    angle_size_13 = angle_size_11 * angle_size_11
    angle_size_14 = absolute(elementary.atan2_error(cross, dot_,
        angle) + (angle_part1_1 * cross_lo - angle_part0_1 * dot__lo) / angle_safe_1)
    angle_size_15 = 7 + angle_size_14
    angle_size_19 = where(angle_bound_1 < angle_size_2, angle_size_13, where(angle_bound_2 < dot_,
        angle_size_13, angle_size_15))
    angle_size_22 = (absolute(angle) + (angle_padded_1 + angle_padded_2) / angle_size_5 + c16
        * where(angle_size_11 < 0.25, angle_size_19, angle_size_15))
    angle_bound_3 = c17 * (c6 + angle_size_22) + angle_size_14
    return (angle, angle_bound_3)


@kernel("(3),(3)->(),()")
@errstate(all="ignore")
def dot_vv(v1, v2, *, c1=2.004168360008973e-292, c2=3.3306690738754706e-16):
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
    dot_bound = c2 * (dot_size + c1)
    return (dot, dot_bound)


@kernel("(),(3)->(3),(3)")
@errstate(all="ignore")
def product_avinv(k, v, *, c1=2.004168360008973e-292, c2=1.1102230246251568e-16):
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
    vo_0a_bound = c2 * (absolute(vo_0a) + c1)
    vo_1a_bound = c2 * (absolute(vo_1a) + c1)
    vo_2a_bound = c2 * (absolute(vo_2a) + c1)
    return (vo_0, vo_1, vo_2, vo_0a_bound, vo_1a_bound, vo_2a_bound)


@kernel("(3),(3)->(3),(3)")
@errstate(all="ignore")
def cross_vv(v1, v2, *, c1=2.004168360008973e-292, c2=2.2204460492503136e-16):
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
    vo_0_bound = c2 * (vo_0_size + c1)
    vo_1_bound = c2 * (vo_1_size + c1)
    vo_2_bound = c2 * (vo_2_size + c1)
    return (vo_0, vo_1, vo_2, vo_0_bound, vo_1_bound, vo_2_bound)


@kernel("(3),(3)->(3),(3)")
@errstate(all="ignore")
def cross_vvinv(v1, v2, *, c1=2.004168360008973e-292, c2=2.2204460492503136e-16):
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
    vo_0_bound = c2 * (vo_0_size + c1)
    vo_1_bound = c2 * (vo_1_size + c1)
    vo_2_bound = c2 * (vo_2_size + c1)
    return (vo_0, vo_1, vo_2, vo_0_bound, vo_1_bound, vo_2_bound)


@kernel("(3),()->(3),(3)")
@errstate(all="ignore")
def add_vvx(v, k, *, c1=1.1102230246251568e-16):
    """vo = v + k e_x; |error of vo| <= vo_bound unless inf or NaN.

    (3),()->(3),(3).  v, vo, vo_bound: vector; k: number.
    1 mul, 1 add, 1 abs.
    """
    v_0, v_1, v_2 = v
    vo_0 = v_0 + k
    vo_0_bound = c1 * absolute(vo_0)
    return (vo_0, v_1, v_2, vo_0_bound, 0, 0)


@kernel("(3),()->(3),(3)")
@errstate(all="ignore")
def add_vvxinv(v, k, *, c1=1.1102230246251568e-16):
    """vo = v - k e_x; |error of vo| <= vo_bound unless inf or NaN.

    (3),()->(3),(3).  v, vo, vo_bound: vector; k: number.
    1 mul, 1 add, 1 abs.
    """
    v_0, v_1, v_2 = v
    vo_0 = v_0 - k
    vo_0_bound = c1 * absolute(vo_0)
    return (vo_0, v_1, v_2, vo_0_bound, 0, 0)


@kernel("(3),()->(3),(3)")
@errstate(all="ignore")
def add_vvy(v, k, *, c1=1.1102230246251568e-16):
    """vo = v + k e_y; |error of vo| <= vo_bound unless inf or NaN.

    (3),()->(3),(3).  v, vo, vo_bound: vector; k: number.
    1 mul, 1 add, 1 abs.
    """
    v_0, v_1, v_2 = v
    vo_1 = v_1 + k
    vo_1_bound = c1 * absolute(vo_1)
    return (v_0, vo_1, v_2, 0, vo_1_bound, 0)


@kernel("(3),()->(3),(3)")
@errstate(all="ignore")
def add_vvyinv(v, k, *, c1=1.1102230246251568e-16):
    """vo = v - k e_y; |error of vo| <= vo_bound unless inf or NaN.

    (3),()->(3),(3).  v, vo, vo_bound: vector; k: number.
    1 mul, 1 add, 1 abs.
    """
    v_0, v_1, v_2 = v
    vo_1 = v_1 - k
    vo_1_bound = c1 * absolute(vo_1)
    return (v_0, vo_1, v_2, 0, vo_1_bound, 0)


@kernel("(3),()->(3),(3)")
@errstate(all="ignore")
def add_vvz(v, k, *, c1=1.1102230246251568e-16):
    """vo = v + k e_z; |error of vo| <= vo_bound unless inf or NaN.

    (3),()->(3),(3).  v, vo, vo_bound: vector; k: number.
    1 mul, 1 add, 1 abs.
    """
    v_0, v_1, v_2 = v
    vo_2 = v_2 + k
    vo_2_bound = c1 * absolute(vo_2)
    return (v_0, v_1, vo_2, 0, 0, vo_2_bound)


@kernel("(3),()->(3),(3)")
@errstate(all="ignore")
def add_vvzinv(v, k, *, c1=1.1102230246251568e-16):
    """vo = v - k e_z; |error of vo| <= vo_bound unless inf or NaN.

    (3),()->(3),(3).  v, vo, vo_bound: vector; k: number.
    1 mul, 1 add, 1 abs.
    """
    v_0, v_1, v_2 = v
    vo_2 = v_2 - k
    vo_2_bound = c1 * absolute(vo_2)
    return (v_0, v_1, vo_2, 0, 0, vo_2_bound)
