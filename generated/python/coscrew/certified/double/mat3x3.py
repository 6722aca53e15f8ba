# Made by `coscrew generate`; changes are overwritten.
# SPDX-License-Identifier: MIT
# coscrew 0.2.0.  Copyright (c) 2026 The coscrew authors.
"""3×3 matrices: rotations, and matrices in general.

In double precision, certified tier.
"""

from coscrew import _elementary_double as elementary
from numpy import absolute, float64 as real, sqrt, where
from coscrew._exact import product_error, product_rest
from coscrew._kernel import double_kernel as kernel
from numpy import errstate


@kernel("(3),(3)->(3,3),(3,3)")
@errstate(all="ignore")
def acceleration_tensor(w, dw, *, c1=2.004168360008973e-292, c2=2.2204460492503136e-16):
    """Ro = w'~ + w~ w~ of a body with angular velocity w and angular acceleration w' = dw: the
    acceleration of its point x, less that of its origin, is Ro x; |error of Ro| <= Ro_bound
    unless inf or NaN.

    (3),(3)->(3,3),(3,3).  w, dw: vector; Ro, Ro_bound: rotation or other 3×3 matrix.
    15 mul, 27 add, 3 neg, 9 abs.
    """
    w_0, w_1, w_2 = w
    dw_0, dw_1, dw_2 = dw
    ww_0 = w_0 * w_0
    ww_1 = w_1 * w_1
    ww_2 = w_2 * w_2
    ww_3 = w_0 * w_1
    ww_4 = w_0 * w_2
    ww_5 = w_1 * w_2
    Ro_00 = -(ww_1 + ww_2)
    Ro_01 = ww_3 - dw_2
    Ro_02 = dw_1 + ww_4
    Ro_10 = dw_2 + ww_3
    Ro_11 = -(ww_0 + ww_2)
    Ro_12 = ww_5 - dw_0
    Ro_20 = ww_4 - dw_1
    Ro_21 = dw_0 + ww_5
    Ro_22 = -(ww_0 + ww_1)
    ww_1_abs = absolute(ww_1)
    ww_2_abs = absolute(ww_2)
    ww_3_abs = absolute(ww_3)
    dw_2_abs = absolute(dw_2)
    Ro_01_size = ww_3_abs + dw_2_abs
    dw_1_abs = absolute(dw_1)
    ww_4_abs = absolute(ww_4)
    Ro_02_size = dw_1_abs + ww_4_abs
    Ro_10_size = dw_2_abs + ww_3_abs
    ww_0_abs = absolute(ww_0)
    ww_5_abs = absolute(ww_5)
    dw_0_abs = absolute(dw_0)
    Ro_12_size = ww_5_abs + dw_0_abs
    Ro_20_size = ww_4_abs + dw_1_abs
    Ro_21_size = dw_0_abs + ww_5_abs
    Ro_00a_bound = c2 * (ww_1_abs + ww_2_abs + c1)
    Ro_01_bound = c2 * (Ro_01_size + c1)
    Ro_02_bound = c2 * (Ro_02_size + c1)
    Ro_10_bound = c2 * (Ro_10_size + c1)
    Ro_11a_bound = c2 * (ww_0_abs + ww_2_abs + c1)
    Ro_12_bound = c2 * (Ro_12_size + c1)
    Ro_20_bound = c2 * (Ro_20_size + c1)
    Ro_21_bound = c2 * (Ro_21_size + c1)
    Ro_22a_bound = c2 * (ww_0_abs + ww_1_abs + c1)
    return (Ro_00, Ro_01, Ro_02, Ro_10, Ro_11, Ro_12, Ro_20, Ro_21, Ro_22, Ro_00a_bound,
        Ro_01_bound, Ro_02_bound, Ro_10_bound, Ro_11a_bound, Ro_12_bound, Ro_20_bound, Ro_21_bound,
        Ro_22a_bound)


@kernel("(3,3)->(),()")
@errstate(all="ignore")
def mat3x3_determinant(R, *, c1=2.004168360008973e-292, c2=5.551115123125785e-16):
    """det R; |error of det| <= det_bound unless inf or NaN.

    (3,3)->(),().  R: rotation or other 3×3 matrix; det, det_bound: number.
    13 mul, 14 add, 9 abs.
    """
    R_00, R_01, R_02, R_10, R_11, R_12, R_20, R_21, R_22 = R
    n_0a = R_11 * R_22
    n_0b = R_12 * R_21
    n_0 = n_0a - n_0b
    n_1a = R_02 * R_21
    n_1b = R_01 * R_22
    n_1 = n_1a - n_1b
    n_2a = R_01 * R_12
    n_2b = R_02 * R_11
    n_2 = n_2a - n_2b
    det = R_00 * n_0 + R_10 * n_1 + R_20 * n_2
    n_0_size = absolute(n_0a) + absolute(n_0b)
    n_1_size = absolute(n_1a) + absolute(n_1b)
    n_2_size = absolute(n_2a) + absolute(n_2b)
    det_size = (absolute(R_00) * (n_0_size + c1) + absolute(R_10) * (n_1_size + c1)
        + absolute(R_20) * (n_2_size + c1))
    det_bound = c2 * (det_size + c1)
    return (det, det_bound)


@kernel("(3),(2)->(3,3),(3,3)")
@errstate(all="ignore")
def mat3x3_setFromAxisDC(axis, dc, *, c1=2.004168360008973e-292, c2=4.440892098500628e-16):
    """R = cos θ I + sin θ a~ + (1 - cos θ) a a^T, a = axis of length 1 (else R is not a rotation),
    dc = (sin θ, cos θ); |error of R| <= R_bound unless inf or NaN.

    (3),(2)->(3,3),(3,3).  axis: vector; dc: (sin θ, cos θ); R, R_bound: rotation or other 3×3
    matrix.
    30 mul, 31 add, 8 abs.
    """
    axis_0, axis_1, axis_2 = axis
    dc_0, dc_1 = dc
    versine = 1 - dc_1
    versine_axis_0 = axis_0 * versine
    versine_axis_1 = axis_1 * versine
    versine_axis_2 = axis_2 * versine
    m_0 = axis_0 * versine_axis_0
    m_1 = axis_1 * versine_axis_1
    m_2 = axis_2 * versine_axis_2
    m_3 = axis_1 * versine_axis_0
    m_4 = axis_2 * versine_axis_0
    m_5 = axis_2 * versine_axis_1
    sine_axis_0 = axis_0 * dc_0
    sine_axis_1 = axis_1 * dc_0
    sine_axis_2 = axis_2 * dc_0
    R_00 = dc_1 + m_0
    R_01 = m_3 - sine_axis_2
    R_02 = m_4 + sine_axis_1
    R_10 = m_3 + sine_axis_2
    R_11 = dc_1 + m_1
    R_12 = m_5 - sine_axis_0
    R_20 = m_4 - sine_axis_1
    R_21 = m_5 + sine_axis_0
    R_22 = dc_1 + m_2
    axis_0_abs = absolute(axis_0)
    versine_abs = absolute(versine)
    versine_axis_0_size = axis_0_abs * versine_abs
    axis_1_abs = absolute(axis_1)
    versine_axis_1_size = axis_1_abs * versine_abs
    axis_2_abs = absolute(axis_2)
    versine_axis_2_size = axis_2_abs * versine_abs
    versine_axis_0_padded = versine_axis_0_size + c1
    m_0_size = axis_0_abs * versine_axis_0_padded
    versine_axis_1_padded = versine_axis_1_size + c1
    m_1_size = axis_1_abs * versine_axis_1_padded
    m_2_size = axis_2_abs * (versine_axis_2_size + c1)
    m_3_size = axis_1_abs * versine_axis_0_padded
    m_4_size = axis_2_abs * versine_axis_0_padded
    m_5_size = axis_2_abs * versine_axis_1_padded
    dc_1_abs = absolute(dc_1)
    R_00_size = dc_1_abs + m_0_size
    sine_axis_2_abs = absolute(sine_axis_2)
    R_01_size = m_3_size + sine_axis_2_abs
    sine_axis_1_abs = absolute(sine_axis_1)
    R_02_size = m_4_size + sine_axis_1_abs
    R_10_size = m_3_size + sine_axis_2_abs
    R_11_size = dc_1_abs + m_1_size
    sine_axis_0_abs = absolute(sine_axis_0)
    R_12_size = m_5_size + sine_axis_0_abs
    R_20_size = m_4_size + sine_axis_1_abs
    R_21_size = m_5_size + sine_axis_0_abs
    R_22_size = dc_1_abs + m_2_size
    R_00_bound = c2 * (R_00_size + c1)
    R_01_bound = c2 * (R_01_size + c1)
    R_02_bound = c2 * (R_02_size + c1)
    R_10_bound = c2 * (R_10_size + c1)
    R_11_bound = c2 * (R_11_size + c1)
    R_12_bound = c2 * (R_12_size + c1)
    R_20_bound = c2 * (R_20_size + c1)
    R_21_bound = c2 * (R_21_size + c1)
    R_22_bound = c2 * (R_22_size + c1)
    return (R_00, R_01, R_02, R_10, R_11, R_12, R_20, R_21, R_22, R_00_bound, R_01_bound,
        R_02_bound, R_10_bound, R_11_bound, R_12_bound, R_20_bound, R_21_bound, R_22_bound)


@kernel("(3)->(3,3),(3,3)")
@errstate(all="ignore")
def mat3x3_from_euler_xyz(angles, *, c1=7.814654941017999e-30, c2=3.7470896994678994e-30,
        c3=2.684592926357104e-29):
    """R = R_x(a) R_y(b) R_z(c), angles = (a, b, c); |error of R| <= R_bound unless inf or NaN.

    (3)->(3,3),(3,3).  angles: vector; R, R_bound: rotation or other 3×3 matrix.
    291 mul, 434 add, 39 product error, 8 product rest, 3 div, 9 neg, 18 abs, 3 less, 3 select.
    """
    angles_0, angles_1, angles_2 = angles
    s_0, c_0 = elementary.sincos(angles_0)
    s_own_error_1, c_own_error_1 = elementary.sincos_error(angles_0, s_0, c_0)
    s_1, c_1 = elementary.sincos(angles_1)
    s_own_error_2, c_own_error_2 = elementary.sincos_error(angles_1, s_1, c_1)
    s_2, c_2 = elementary.sincos(angles_2)
    s_own_error_3, c_own_error_3 = elementary.sincos_error(angles_2, s_2, c_2)
    first_0 = c_1 * c_2
    first_1 = -(s_2 * c_1)
    first_6 = -(s_1 * c_2)
    first_7 = s_1 * s_2
    last_3a = s_2 * c_0
    first_lo_1 = product_error(-s_1, c_2, first_6) + -(s_own_error_2 * c_2 + s_1 * c_own_error_3)
    last_3b = s_0 * first_6
    last_3 = last_3a - last_3b
    last_right_1 = last_3a - last_3
    last_lo1_1 = (product_rest(s_2, c_0, last_3a, last_3 + last_right_1)
        - product_rest(s_0, first_6, last_3b, last_right_1))
    last_4a = c_0 * c_2
    first_lo_2 = product_error(s_1, s_2, first_7) + (s_own_error_2 * s_2 + s_1 * s_own_error_3)
    last_4b = s_0 * first_7
    last_4 = last_4a - last_4b
    last_right_2 = last_4a - last_4
    last_lo1_2 = (product_rest(c_0, c_2, last_4a, last_4 + last_right_2)
        - product_rest(s_0, first_7, last_4b, last_right_2))
    last_5 = -(s_0 * c_1)
    last_6a = s_0 * s_2
    last_6b = c_0 * first_6
    last_6 = last_6a + last_6b
    last_right_3 = last_6 - last_6a
    last_lo1_3 = (product_rest(s_0, s_2, last_6a, last_6 - last_right_3)
        + product_rest(c_0, first_6, last_6b, last_right_3))
    last_7a = s_0 * c_2
    last_7b = c_0 * first_7
    last_7 = last_7a + last_7b
    last_right_4 = last_7 - last_7a
    last_lo1_4 = (product_rest(s_0, c_2, last_7a, last_7 - last_right_4)
        + product_rest(c_0, first_7, last_7b, last_right_4))
    last_8 = c_0 * c_1
    first_bound_1 = (c1
        + absolute(product_error(c_1, c_2, first_0) + (c_own_error_2 * c_2 + c_1 * c_own_error_3)))
    first_bound_2 = (c1
        + absolute(product_error(-s_2, c_1, first_1) +
        -(s_own_error_3 * c_1 + s_2 * c_own_error_2)))
    s_bound_1 = c2 + absolute(s_own_error_2)
    last_bound_1 = (c3
        + absolute(last_lo1_1
        + (s_own_error_3 * c_0 + s_2 * c_own_error_1
        - (s_own_error_1 * first_6 + s_0 * first_lo_1))))
    last_bound_2 = (c3
        + absolute(last_lo1_2
        + (c_own_error_1 * c_2 + c_0 * c_own_error_3
        - (s_own_error_1 * first_7 + s_0 * first_lo_2))))
    last_bound_3 = (c1
        + absolute(product_error(-s_0, c_1, last_5) + -(s_own_error_1 * c_1 + s_0 * c_own_error_2)))
    last_bound_4 = (c3
        + absolute(last_lo1_3
        + (s_own_error_1 * s_2 + s_0 * s_own_error_3
        + (c_own_error_1 * first_6 + c_0 * first_lo_1))))
    last_bound_5 = (c3
        + absolute(last_lo1_4
        + (s_own_error_1 * c_2 + s_0 * c_own_error_3
        + (c_own_error_1 * first_7 + c_0 * first_lo_2))))
    last_bound_6 = (c1
        + absolute(product_error(c_0, c_1, last_8) + (c_own_error_1 * c_1 + c_0 * c_own_error_2)))
    return (first_0, first_1, s_1, last_3, last_4, last_5, last_6, last_7, last_8, first_bound_1,
        first_bound_2, s_bound_1, last_bound_1, last_bound_2, last_bound_3, last_bound_4,
        last_bound_5, last_bound_6)


@kernel("(3,3)->(3),(3)")
@errstate(all="ignore")
def euler_xyz_from_mat3x3(R, *, c1=1.8051943758648296e-276, c2=9.614242987677729e-31,
        c3=140737488355328, c4=4.916947487854274e+29, c5=2.230997459167166e-30,
        c6=1.5845630613906556e+29, c7=6.508104019725916e-30, c8=9.910067449317813e-30,
        c9=1.0401233252484625e+29, c10=3.7470896994679e-30, c11=1.5845630613906556e+29,
        c12=1.120429474644463e-29, c13=4.527322338646221e+28, c14=7.642090607075756e-31,
        c15=2.2778366396519518e-29, c16=4.527322030246999e+28, c17=7.9228157791897855e+28,
        c18=2.277836794817206e-29, c19=1.3016206487799288e-29, c20=6.508104019725916e-30,
        c21=1.0715086071862673e+301):
    """angles of the rotation R = R_x(a) R_y(b) R_z(c), angles = (a, b, c); a, c in [-π, π], b in
    [-π/2, π/2]; c = 0 in gimbal lock; |error of angles| <= angles_bound unless inf or NaN.

    (3,3)->(3),(3).  R: rotation or other 3×3 matrix; angles, angles_bound: vector.
    455 mul, 765 add, 66 product error, 6 product rest, 27 div, 2 sqrt, 4 neg, 72 abs, 12
    copysign, 59 less, 14 equal, 108 select.
    """
    R_00, R_01, R_02, R_10, R_11, R_12, R_20, R_21, R_22 = R
    n_a = R_00 * R_00
    n_a_size_1 = absolute(R_00)
    n_b = R_01 * R_01
    n_b_size_1 = absolute(R_01)
    n_c = n_a + n_b
    n_c_right_1 = n_c - n_a
    n_c_lo = (product_rest(R_00, R_00, n_a, n_c - n_c_right_1)
        + product_rest(R_01, R_01, n_b, n_c_right_1))
    n = sqrt(n_c)
    n_product_1 = n * n
    n_lo = (n_c - n_product_1 - product_error(n, n, n_product_1) + n_c_lo) / where(n == 0, 1, n + n)
    n_padded_1 = c1 + (n_a_size_1 * n_a_size_1 + n_b_size_1 * n_b_size_1)
    n_bound_1 = absolute(n_c_lo) + c2 * n_padded_1
    n_size_6 = absolute(n_lo)
    n_size_12 = (n
        + where(4 * n_bound_1 < n_c, (absolute(n_c) + c3 * n_bound_1) * (n_padded_1 / n / n_c), c4
        * (sqrt(n_bound_1) + n_size_6)))
    divisor_a = n == 0
    divisor = where(divisor_a, 1, n)
    divisor_lo = where(divisor_a, 0, n_lo)
    divisor_padded_1 = c1 + n_size_12
    divisor_bound_1 = c5 * divisor_padded_1 + n_size_6
    divisor_size_4 = divisor_bound_1 < absolute(n - 0)
    cosine_a = R_00 / divisor
    cosine_a_product_1 = cosine_a * divisor
    cosine_a_lo = ((R_00 - cosine_a_product_1
        - product_error(cosine_a, divisor, cosine_a_product_1) - cosine_a * divisor_lo) / divisor)
    cosine_a_padded_2 = (c1
        + (where(divisor_a, 1, n_size_12) + c6
        * where(divisor_size_4, 0, divisor_bound_1 + absolute(1 - n))))
    cosine_a_size_1 = absolute(cosine_a)
    cosine_a_size_2 = absolute(divisor)
    cosine_a_bound_1 = absolute(divisor_lo) + c7 * cosine_a_padded_2
    cosine_a_size_7 = where(4 * cosine_a_bound_1 < cosine_a_size_2, cosine_a_size_2, 0)
    cosine_a_reach_1 = cosine_a_size_2 + c3 * cosine_a_bound_1
    cosine_a_size_11 = (cosine_a_size_1 + cosine_a_reach_1
        * ((c1 + n_a_size_1 + cosine_a_padded_2 * cosine_a_size_1) / cosine_a_size_7)
        / cosine_a_size_2)
    cosine = where(divisor_a, 1, cosine_a)
    cosine_lo = where(divisor_a, 0, cosine_a_lo)
    cosine_size_6 = (c9
        * where(divisor_size_4, 0, absolute(cosine_a_lo) + c8 * (c1 + cosine_a_size_11)
        + absolute(1 - cosine_a)))
    sine_a = -R_01
    sine = sine_a / divisor
    sine_product_1 = sine * divisor
    sine_lo = ((sine_a - sine_product_1 - product_error(sine, divisor, sine_product_1) - sine
        * divisor_lo) / divisor)
    sine_size_1 = absolute(sine)
    polar = elementary.atan2(sine_a, R_00)
    polar_own_error_1 = elementary.atan2_error(sine_a, R_00, polar)
    polar_size_1 = absolute(polar)
    third = where(divisor_a, 0, polar)
    third_size_6 = (c11
        * where(divisor_size_4, 0, absolute(polar_own_error_1) + c10 * (c1 + polar_size_1)
        + absolute(0 - polar)))
    left_1a = R_10 * sine
    left_1a_padded_1 = (c1
        + (sine_size_1 + cosine_a_reach_1
        * ((c1 + n_b_size_1 + cosine_a_padded_2 * sine_size_1) / cosine_a_size_7)
        / cosine_a_size_2))
    left_1b = R_11 * cosine
    left_1b_padded_1 = c1 + (where(divisor_a, 1, cosine_a_size_11) + cosine_size_6)
    left_1 = left_1a + left_1b
    left_right_1 = left_1 - left_1a
    left_lo1_1 = (product_rest(R_10, sine, left_1a, left_1 - left_right_1)
        + product_rest(R_11, cosine, left_1b, left_right_1))
    left_lo_1 = left_lo1_1 + (R_10 * sine_lo + R_11 * cosine_lo)
    left_2a = R_20 * sine
    left_2b = R_21 * cosine
    left_2 = left_2a + left_2b
    left_right_2 = left_2 - left_2a
    left_lo1_2 = (product_rest(R_20, sine, left_2a, left_2 - left_right_2)
        + product_rest(R_21, cosine, left_2b, left_right_2))
    left_lo_2 = left_lo1_2 + (R_20 * sine_lo + R_21 * cosine_lo)
    rest = R_12 + R_22
    rest_right_1 = rest - R_12
    rest_lo = R_12 - (rest - rest_right_1) + (R_22 - rest_right_1)
    rest_size_3 = absolute(R_12) + absolute(R_22)
    first = elementary.atan2(left_2, left_1)
    first_size0_1 = absolute(left_2)
    first_size1_1 = absolute(left_1)
    first_most_1 = where(first_size0_1 < first_size1_1, first_size1_1, first_size0_1)
    first_zero_1 = first_most_1 == 0
    first_divisor_1 = where(first_zero_1, 1, first_most_1)
    first_part0_1 = left_2 / first_divisor_1
    first_part1_1 = left_1 / first_divisor_1
    first_safe_1 = where(first_zero_1, 1,
        first_divisor_1 * (first_part1_1 * first_part1_1 + first_part0_1 * first_part0_1))
    first_lo = (elementary.atan2_error(left_2, left_1, first)
        + (first_part1_1 * left_lo_2 - first_part0_1 * left_lo_1) / first_safe_1)
    first_padded_1 = c1 + (left_1a_padded_1 * absolute(R_20) + left_1b_padded_1 * absolute(R_21))
    first_padded_2 = c1 + (left_1a_padded_1 * absolute(R_10) + left_1b_padded_1 * absolute(R_11))
    first_size_2 = absolute(left_2)
    first_size_3 = absolute(left_1)
    first_size_5 = where(first_size_2 < first_size_3, first_size_3, first_size_2)
    first_bound_1 = absolute(left_lo_2) + c12 * first_padded_1
    first_bound_2 = absolute(left_lo_1) + c12 * first_padded_2
    first_size_11 = (first_bound_2 + (c1 + first_bound_1)) / first_size_5
    first_size_13 = first_size_11 * first_size_11
    first_size_14 = absolute(first_lo)
    first_size_15 = 7 + first_size_14
    first_size_19 = where(first_bound_1 < first_size_2, first_size_13, where(first_bound_2 < left_1,
        first_size_13, first_size_15))
    first_size_22 = (absolute(first) + (first_padded_1 + first_padded_2) / first_size_5 + c13
        * where(first_size_11 < 0.25, first_size_19, first_size_15))
    angles_0a = rest < 1.2676506002282294e+30
    angles_0 = where(angles_0a, first, rest)
    angles_bound_1 = absolute(rest_lo) + c14 * (c1 + rest_size_3)
    angles_size_8 = (angles_bound_1
        + (c15 * (c1 + first_size_22) + first_size_14 + absolute(first - rest)))
    angles_size_10 = (c16
        * where(angles_bound_1 < absolute(rest - 1.2676506002282294e+30), 0, angles_size_8))
    angles_1 = elementary.atan2(R_02, n)
    angles_size0_1 = absolute(R_02)
    angles_size1_1 = absolute(n)
    angles_most_1 = where(angles_size0_1 < angles_size1_1, angles_size1_1, angles_size0_1)
    angles_zero_1 = angles_most_1 == 0
    angles_divisor_1 = where(angles_zero_1, 1, angles_most_1)
    angles_part0_1 = R_02 / angles_divisor_1
    angles_part1_1 = n / angles_divisor_1
    angles_safe_1 = where(angles_zero_1, 1,
        angles_divisor_1 * (angles_part1_1 * angles_part1_1 + angles_part0_1 * angles_part0_1))
    angles_size_13 = absolute(R_02)
    angles_size_14 = absolute(n)
    angles_size_16 = where(angles_size_13 < angles_size_14, angles_size_14, angles_size_13)
    angles_size_21 = (c1 + divisor_bound_1) / angles_size_16
    angles_size_24 = absolute(elementary.atan2_error(R_02, n,
        angles_1) + (angles_part1_1 * 0 - angles_part0_1 * n_lo) / angles_safe_1)
    angles_size_27 = (c17
        * where(angles_size_21 < 0.25, angles_size_21 * angles_size_21, 7 + angles_size_24))
    R_n_0 = R_11 * R_22 - R_12 * R_21
    R_n_1 = R_02 * R_21 - R_01 * R_22
    R_n_2 = R_01 * R_12 - R_02 * R_11
    R_det = R_00 * R_n_0 + R_10 * R_n_1 + R_20 * R_n_2
    R_g_0 = R_00 * R_00 + R_10 * R_10 + R_20 * R_20
    R_g_1 = R_00 * R_01 + R_10 * R_11 + R_20 * R_21
    R_g_2 = R_00 * R_02 + R_10 * R_12 + R_20 * R_22
    R_g_3 = R_01 * R_01 + R_11 * R_11 + R_21 * R_21
    R_g_4 = R_01 * R_02 + R_11 * R_12 + R_21 * R_22
    R_g_5 = R_02 * R_02 + R_12 * R_12 + R_22 * R_22
    R_off_0 = R_det - 1
    R_off_1 = R_g_0 - 1
    R_off_4 = R_g_3 - 1
    R_off_6 = R_g_5 - 1
    R_defect_size_0 = absolute(R_off_0)
    R_defect_size_1 = absolute(R_off_1)
    R_defect_size_2 = absolute(R_g_1)
    R_defect_size_3 = absolute(R_g_2)
    R_defect_size_4 = absolute(R_off_4)
    R_defect_size_5 = absolute(R_g_4)
    R_defect_size_6 = absolute(R_off_6)
    R_defect_largest1 = where(R_defect_size_0 < R_defect_size_1, R_defect_size_1, R_defect_size_0)
    R_defect_largest2 = where(R_defect_largest1 < R_defect_size_2, R_defect_size_2,
        R_defect_largest1)
    R_defect_largest3 = where(R_defect_largest2 < R_defect_size_3, R_defect_size_3,
        R_defect_largest2)
    R_defect_largest4 = where(R_defect_largest3 < R_defect_size_4, R_defect_size_4,
        R_defect_largest3)
    R_defect_largest5 = where(R_defect_largest4 < R_defect_size_5, R_defect_size_5,
        R_defect_largest4)
    R_defect_largest6 = where(R_defect_largest5 < R_defect_size_6, R_defect_size_6,
        R_defect_largest5)
    R_is_less = R_defect_largest6 < 0.001
    R_is_equal = R_defect_largest6 == 0.001
    R_unless_equal = where(R_is_equal, real(0), real(c21))
    R_unless_rotation = where(R_is_less, 0, R_unless_equal)
    R_excess = R_unless_rotation * c21
    R_excess_0 = (absolute(where(angles_0a, first_lo, rest_lo)) + c18
        * (c1 + (where(angles_0a, first_size_22, rest_size_3) + angles_size_10)) + R_excess)
    angles_bound_4 = (c19
        * (c1
        + (absolute(angles_1) + (c1 + angles_size_13 + divisor_padded_1) / angles_size_16
        + angles_size_27)) + angles_size_24)
    R_excess_1 = angles_bound_4 + R_excess
    R_excess_2 = (absolute(where(divisor_a, 0, polar_own_error_1)) + c20
        * (c1 + (where(divisor_a, 0, polar_size_1) + third_size_6)) + R_excess)
    return (angles_0, angles_1, third, R_excess_0, R_excess_1, R_excess_2)


@kernel("(3)->(3,3),(3,3)")
@errstate(all="ignore")
def mat3x3_from_euler_xyx(angles, *, c1=3.7470896994678994e-30, c2=7.814654941017999e-30,
        c3=2.684592926357104e-29):
    """R = R_x(a) R_y(b) R_x(c), angles = (a, b, c); |error of R| <= R_bound unless inf or NaN.

    (3)->(3,3),(3,3).  angles: vector; R, R_bound: rotation or other 3×3 matrix.
    291 mul, 434 add, 39 product error, 8 product rest, 3 div, 5 neg, 18 abs, 3 less, 3 select.
    """
    angles_0, angles_1, angles_2 = angles
    s_0, c_0 = elementary.sincos(angles_0)
    s_own_error_1, c_own_error_1 = elementary.sincos_error(angles_0, s_0, c_0)
    s_1, c_1 = elementary.sincos(angles_1)
    s_own_error_2, c_own_error_2 = elementary.sincos_error(angles_1, s_1, c_1)
    s_2, c_2 = elementary.sincos(angles_2)
    s_own_error_3, c_own_error_3 = elementary.sincos_error(angles_2, s_2, c_2)
    first_1 = s_1 * s_2
    first_2 = s_1 * c_2
    first_7 = s_2 * c_1
    first_8 = c_1 * c_2
    last_3 = s_0 * s_1
    last_4a = c_0 * c_2
    first_lo_1 = product_error(s_2, c_1, first_7) + (s_own_error_3 * c_1 + s_2 * c_own_error_2)
    last_4b = s_0 * first_7
    last_4 = last_4a - last_4b
    last_right_1 = last_4a - last_4
    last_lo1_1 = (product_rest(c_0, c_2, last_4a, last_4 + last_right_1)
        - product_rest(s_0, first_7, last_4b, last_right_1))
    first_lo_2 = product_error(c_1, c_2, first_8) + (c_own_error_2 * c_2 + c_1 * c_own_error_3)
    last_5a = s_0 * first_8
    last_5b = s_2 * c_0
    last_5c = last_5a + last_5b
    last_5c_right_1 = last_5c - last_5a
    last_5c_lo1_1 = (product_rest(s_0, first_8, last_5a, last_5c - last_5c_right_1)
        + product_rest(s_2, c_0, last_5b, last_5c_right_1))
    last_5 = -last_5c
    last_6 = -(s_1 * c_0)
    last_7a = s_0 * c_2
    last_7b = c_0 * first_7
    last_7 = last_7a + last_7b
    last_right_2 = last_7 - last_7a
    last_lo1_2 = (product_rest(s_0, c_2, last_7a, last_7 - last_right_2)
        + product_rest(c_0, first_7, last_7b, last_right_2))
    last_8a = c_0 * first_8
    last_8b = s_0 * s_2
    last_8 = last_8a - last_8b
    last_right_3 = last_8a - last_8
    last_lo1_3 = (product_rest(c_0, first_8, last_8a, last_8 + last_right_3)
        - product_rest(s_0, s_2, last_8b, last_right_3))
    c_bound_1 = c1 + absolute(c_own_error_2)
    first_bound_1 = (c2
        + absolute(product_error(s_1, s_2, first_1) + (s_own_error_2 * s_2 + s_1 * s_own_error_3)))
    first_bound_2 = (c2
        + absolute(product_error(s_1, c_2, first_2) + (s_own_error_2 * c_2 + s_1 * c_own_error_3)))
    last_bound_1 = (c2
        + absolute(product_error(s_0, s_1, last_3) + (s_own_error_1 * s_1 + s_0 * s_own_error_2)))
    last_bound_2 = (c3
        + absolute(last_lo1_1
        + (c_own_error_1 * c_2 + c_0 * c_own_error_3
        - (s_own_error_1 * first_7 + s_0 * first_lo_1))))
    last_bound_3 = (c3
        + absolute(-(last_5c_lo1_1
        + (s_own_error_1 * first_8 + s_0 * first_lo_2
        + (s_own_error_3 * c_0 + s_2 * c_own_error_1)))))
    last_bound_4 = (c2
        + absolute(product_error(-s_1, c_0, last_6) + -(s_own_error_2 * c_0 + s_1 * c_own_error_1)))
    last_bound_5 = (c3
        + absolute(last_lo1_2
        + (s_own_error_1 * c_2 + s_0 * c_own_error_3
        + (c_own_error_1 * first_7 + c_0 * first_lo_1))))
    last_bound_6 = (c3
        + absolute(last_lo1_3
        + (c_own_error_1 * first_8 + c_0 * first_lo_2
        - (s_own_error_1 * s_2 + s_0 * s_own_error_3))))
    return (c_1, first_1, first_2, last_3, last_4, last_5, last_6, last_7, last_8, c_bound_1,
        first_bound_1, first_bound_2, last_bound_1, last_bound_2, last_bound_3, last_bound_4,
        last_bound_5, last_bound_6)


@kernel("(3,3)->(3),(3)")
@errstate(all="ignore")
def euler_xyx_from_mat3x3(R, *, c1=1.8051943758648296e-276, c2=9.614242987677729e-31,
        c3=140737488355328, c4=4.916947487854274e+29, c5=2.230997459167166e-30,
        c6=1.5845630613906556e+29, c7=6.508104019725916e-30, c8=9.910067449317813e-30,
        c9=1.0401233252484625e+29, c10=3.7470896994679e-30, c11=1.5845630613906556e+29,
        c12=1.120429474644463e-29, c13=4.527322338646221e+28, c14=7.642090607075756e-31,
        c15=2.2778366396519518e-29, c16=4.527322030246999e+28, c17=7.9228157791897855e+28,
        c18=2.277836794817206e-29, c19=1.3016206487799288e-29, c20=6.508104019725916e-30,
        c21=1.0715086071862673e+301):
    """angles of the rotation R = R_x(a) R_y(b) R_x(c), angles = (a, b, c); a, c in [-π, π], b in
    [0, π]; c = 0 in gimbal lock; |error of angles| <= angles_bound unless inf or NaN.

    (3,3)->(3),(3).  R: rotation or other 3×3 matrix; angles, angles_bound: vector.
    455 mul, 765 add, 66 product error, 6 product rest, 27 div, 2 sqrt, 3 neg, 72 abs, 12
    copysign, 61 less, 14 equal, 110 select.
    """
    R_00, R_01, R_02, R_10, R_11, R_12, R_20, R_21, R_22 = R
    n_a = R_01 * R_01
    n_a_size_1 = absolute(R_01)
    n_b = R_02 * R_02
    n_b_size_1 = absolute(R_02)
    n_c = n_a + n_b
    n_c_right_1 = n_c - n_a
    n_c_lo = (product_rest(R_01, R_01, n_a, n_c - n_c_right_1)
        + product_rest(R_02, R_02, n_b, n_c_right_1))
    n = sqrt(n_c)
    n_product_1 = n * n
    n_lo = (n_c - n_product_1 - product_error(n, n, n_product_1) + n_c_lo) / where(n == 0, 1, n + n)
    n_padded_1 = c1 + (n_a_size_1 * n_a_size_1 + n_b_size_1 * n_b_size_1)
    n_bound_1 = absolute(n_c_lo) + c2 * n_padded_1
    n_size_6 = absolute(n_lo)
    n_size_12 = (n
        + where(4 * n_bound_1 < n_c, (absolute(n_c) + c3 * n_bound_1) * (n_padded_1 / n / n_c), c4
        * (sqrt(n_bound_1) + n_size_6)))
    divisor_a = n == 0
    divisor = where(divisor_a, 1, n)
    divisor_lo = where(divisor_a, 0, n_lo)
    divisor_padded_1 = c1 + n_size_12
    divisor_bound_1 = c5 * divisor_padded_1 + n_size_6
    divisor_size_4 = divisor_bound_1 < absolute(n - 0)
    cosine_a = R_02 / divisor
    cosine_a_product_1 = cosine_a * divisor
    cosine_a_lo = ((R_02 - cosine_a_product_1
        - product_error(cosine_a, divisor, cosine_a_product_1) - cosine_a * divisor_lo) / divisor)
    cosine_a_padded_2 = (c1
        + (where(divisor_a, 1, n_size_12) + c6
        * where(divisor_size_4, 0, divisor_bound_1 + absolute(1 - n))))
    cosine_a_size_1 = absolute(cosine_a)
    cosine_a_size_2 = absolute(divisor)
    cosine_a_bound_1 = absolute(divisor_lo) + c7 * cosine_a_padded_2
    cosine_a_size_7 = where(4 * cosine_a_bound_1 < cosine_a_size_2, cosine_a_size_2, 0)
    cosine_a_reach_1 = cosine_a_size_2 + c3 * cosine_a_bound_1
    cosine_a_size_11 = (cosine_a_size_1 + cosine_a_reach_1
        * ((c1 + n_b_size_1 + cosine_a_padded_2 * cosine_a_size_1) / cosine_a_size_7)
        / cosine_a_size_2)
    cosine = where(divisor_a, 1, cosine_a)
    cosine_lo = where(divisor_a, 0, cosine_a_lo)
    cosine_size_6 = (c9
        * where(divisor_size_4, 0, absolute(cosine_a_lo) + c8 * (c1 + cosine_a_size_11)
        + absolute(1 - cosine_a)))
    sine = R_01 / divisor
    sine_product_1 = sine * divisor
    sine_lo = ((R_01 - sine_product_1 - product_error(sine, divisor, sine_product_1) - sine
        * divisor_lo) / divisor)
    sine_size_1 = absolute(sine)
    polar = elementary.atan2(R_01, R_02)
    polar_own_error_1 = elementary.atan2_error(R_01, R_02, polar)
    polar_size_1 = absolute(polar)
    third = where(divisor_a, 0, polar)
    third_size_6 = (c11
        * where(divisor_size_4, 0, absolute(polar_own_error_1) + c10 * (c1 + polar_size_1)
        + absolute(0 - polar)))
    left_1a = R_11 * cosine
    left_1a_padded_1 = c1 + (where(divisor_a, 1, cosine_a_size_11) + cosine_size_6)
    left_1b = R_12 * sine
    left_1b_padded_1 = (c1
        + (sine_size_1 + cosine_a_reach_1
        * ((c1 + n_a_size_1 + cosine_a_padded_2 * sine_size_1) / cosine_a_size_7)
        / cosine_a_size_2))
    left_1 = left_1a - left_1b
    left_right_1 = left_1a - left_1
    left_lo1_1 = (product_rest(R_11, cosine, left_1a, left_1 + left_right_1)
        - product_rest(R_12, sine, left_1b, left_right_1))
    left_lo_1 = left_lo1_1 + (R_11 * cosine_lo - R_12 * sine_lo)
    left_2a = R_21 * cosine
    left_2b = R_22 * sine
    left_2 = left_2a - left_2b
    left_right_2 = left_2a - left_2
    left_lo1_2 = (product_rest(R_21, cosine, left_2a, left_2 + left_right_2)
        - product_rest(R_22, sine, left_2b, left_right_2))
    left_lo_2 = left_lo1_2 + (R_21 * cosine_lo - R_22 * sine_lo)
    rest = R_10 + R_20
    rest_right_1 = rest - R_10
    rest_lo = R_10 - (rest - rest_right_1) + (R_20 - rest_right_1)
    rest_size_3 = absolute(R_10) + absolute(R_20)
    first = elementary.atan2(left_2, left_1)
    first_size0_1 = absolute(left_2)
    first_size1_1 = absolute(left_1)
    first_most_1 = where(first_size0_1 < first_size1_1, first_size1_1, first_size0_1)
    first_zero_1 = first_most_1 == 0
    first_divisor_1 = where(first_zero_1, 1, first_most_1)
    first_part0_1 = left_2 / first_divisor_1
    first_part1_1 = left_1 / first_divisor_1
    first_safe_1 = where(first_zero_1, 1,
        first_divisor_1 * (first_part1_1 * first_part1_1 + first_part0_1 * first_part0_1))
    first_lo = (elementary.atan2_error(left_2, left_1, first)
        + (first_part1_1 * left_lo_2 - first_part0_1 * left_lo_1) / first_safe_1)
    first_padded_1 = c1 + (left_1a_padded_1 * absolute(R_21) + left_1b_padded_1 * absolute(R_22))
    first_padded_2 = c1 + (left_1a_padded_1 * absolute(R_11) + left_1b_padded_1 * absolute(R_12))
    first_size_2 = absolute(left_2)
    first_size_3 = absolute(left_1)
    first_size_5 = where(first_size_2 < first_size_3, first_size_3, first_size_2)
    first_bound_1 = absolute(left_lo_2) + c12 * first_padded_1
    first_bound_2 = absolute(left_lo_1) + c12 * first_padded_2
    first_size_11 = (first_bound_2 + (c1 + first_bound_1)) / first_size_5
    first_size_13 = first_size_11 * first_size_11
    first_size_14 = absolute(first_lo)
    first_size_15 = 7 + first_size_14
    first_size_19 = where(first_bound_1 < first_size_2, first_size_13, where(first_bound_2 < left_1,
        first_size_13, first_size_15))
    first_size_22 = (absolute(first) + (first_padded_1 + first_padded_2) / first_size_5 + c13
        * where(first_size_11 < 0.25, first_size_19, first_size_15))
    angles_0a = rest < 1.2676506002282294e+30
    angles_0 = where(angles_0a, first, rest)
    angles_bound_1 = absolute(rest_lo) + c14 * (c1 + rest_size_3)
    angles_size_8 = (angles_bound_1
        + (c15 * (c1 + first_size_22) + first_size_14 + absolute(first - rest)))
    angles_size_10 = (c16
        * where(angles_bound_1 < absolute(rest - 1.2676506002282294e+30), 0, angles_size_8))
    angles_1 = elementary.atan2(n, R_00)
    angles_size0_1 = absolute(n)
    angles_size1_1 = absolute(R_00)
    angles_most_1 = where(angles_size0_1 < angles_size1_1, angles_size1_1, angles_size0_1)
    angles_zero_1 = angles_most_1 == 0
    angles_divisor_1 = where(angles_zero_1, 1, angles_most_1)
    angles_part0_1 = n / angles_divisor_1
    angles_part1_1 = R_00 / angles_divisor_1
    angles_safe_1 = where(angles_zero_1, 1,
        angles_divisor_1 * (angles_part1_1 * angles_part1_1 + angles_part0_1 * angles_part0_1))
    angles_size_13 = absolute(R_00)
    angles_size_14 = absolute(n)
    angles_size_16 = where(angles_size_14 < angles_size_13, angles_size_13, angles_size_14)
    angles_size_21 = (c1 + divisor_bound_1) / angles_size_16
    angles_size_23 = angles_size_21 * angles_size_21
    angles_size_24 = absolute(elementary.atan2_error(n, R_00,
        angles_1) + (angles_part1_1 * n_lo - angles_part0_1 * 0) / angles_safe_1)
    angles_size_25 = 7 + angles_size_24
    angles_size_29 = where(divisor_bound_1 < angles_size_14, angles_size_23, where(0 < R_00,
        angles_size_23, angles_size_25))
    angles_size_20 = absolute(angles_1) + (c1 + angles_size_13 + divisor_padded_1) / angles_size_16
    R_n_0 = R_11 * R_22 - R_12 * R_21
    R_n_1 = R_02 * R_21 - R_01 * R_22
    R_n_2 = R_01 * R_12 - R_02 * R_11
    R_det = R_00 * R_n_0 + R_10 * R_n_1 + R_20 * R_n_2
    R_g_0 = R_00 * R_00 + R_10 * R_10 + R_20 * R_20
    R_g_1 = R_00 * R_01 + R_10 * R_11 + R_20 * R_21
    R_g_2 = R_00 * R_02 + R_10 * R_12 + R_20 * R_22
    R_g_3 = R_01 * R_01 + R_11 * R_11 + R_21 * R_21
    R_g_4 = R_01 * R_02 + R_11 * R_12 + R_21 * R_22
    R_g_5 = R_02 * R_02 + R_12 * R_12 + R_22 * R_22
    R_off_0 = R_det - 1
    R_off_1 = R_g_0 - 1
    R_off_4 = R_g_3 - 1
    R_off_6 = R_g_5 - 1
    R_defect_size_0 = absolute(R_off_0)
    R_defect_size_1 = absolute(R_off_1)
    R_defect_size_2 = absolute(R_g_1)
    R_defect_size_3 = absolute(R_g_2)
    R_defect_size_4 = absolute(R_off_4)
    R_defect_size_5 = absolute(R_g_4)
    R_defect_size_6 = absolute(R_off_6)
    R_defect_largest1 = where(R_defect_size_0 < R_defect_size_1, R_defect_size_1, R_defect_size_0)
    R_defect_largest2 = where(R_defect_largest1 < R_defect_size_2, R_defect_size_2,
        R_defect_largest1)
    R_defect_largest3 = where(R_defect_largest2 < R_defect_size_3, R_defect_size_3,
        R_defect_largest2)
    R_defect_largest4 = where(R_defect_largest3 < R_defect_size_4, R_defect_size_4,
        R_defect_largest3)
    R_defect_largest5 = where(R_defect_largest4 < R_defect_size_5, R_defect_size_5,
        R_defect_largest4)
    R_defect_largest6 = where(R_defect_largest5 < R_defect_size_6, R_defect_size_6,
        R_defect_largest5)
    R_is_less = R_defect_largest6 < 0.001
    R_is_equal = R_defect_largest6 == 0.001
    R_unless_equal = where(R_is_equal, real(0), real(c21))
    R_unless_rotation = where(R_is_less, 0, R_unless_equal)
    R_excess = R_unless_rotation * c21
    R_excess_0 = (absolute(where(angles_0a, first_lo, rest_lo)) + c18
        * (c1 + (where(angles_0a, first_size_22, rest_size_3) + angles_size_10)) + R_excess)
    R_excess_1 = (c19
        * (c1
        + (angles_size_20 + c17 * where(angles_size_21 < 0.25, angles_size_29, angles_size_25)))
        + angles_size_24 + R_excess)
    R_excess_2 = (absolute(where(divisor_a, 0, polar_own_error_1)) + c20
        * (c1 + (where(divisor_a, 0, polar_size_1) + third_size_6)) + R_excess)
    return (angles_0, angles_1, third, R_excess_0, R_excess_1, R_excess_2)


@kernel("(3),()->(3,3),(3,3)")
@errstate(all="ignore")
def mat3x3_from_axis_angle(axis, angle, *, c1=1.8051943758648296e-276, c2=3.7470896994678994e-30,
        c3=9.318421041595558e-30, c4=8.973295241917294e-30, c5=3.9614071812401596e+28,
        c6=2.998906207317825e-29, c7=2.841133715943113e-29):
    """R = I + sin(angle) axis~ + (1 - cos(angle)) axis~^2, for an axis of length 1; otherwise R is
    not a rotation; |error of R| <= R_bound unless inf or NaN.

    (3),()->(3,3),(3,3).  axis: vector; angle: number; R, R_bound: rotation or other 3×3 matrix.
    216 mul, 380 add, 26 product error, 18 product rest, 2 div, 24 abs, 4 less, 6 select.
    """
    axis_0, axis_1, axis_2 = axis
    half = 0.5 * angle
    h = elementary.sin(half)
    h_own_error_1 = elementary.sin_error(half, h)
    h_size_1 = 1 + (c1 + 0.5 * absolute(angle))
    sine, cosine = elementary.sincos(angle)
    sine_own_error_1, cosine_own_error_1 = elementary.sincos_error(angle, sine, cosine)
    versine_a = h * h
    versine_b = 2 * versine_a
    versine_b_cross2_1 = (2
        * (product_error(h, h, versine_a) + (h_own_error_1 * h + h * h_own_error_1)))
    versine_b_size_1 = 2 * (h_size_1 * h_size_1)
    versine_c = 1 - cosine
    versine_c_right_1 = 1 - versine_c
    versine_c_lo = (1 - (versine_c + versine_c_right_1) - (cosine - versine_c_right_1)
        - cosine_own_error_1)
    versine_d = cosine < 0
    versine = where(versine_d, versine_c, versine_b)
    versine_lo = where(versine_d, versine_c_lo, versine_b_cross2_1)
    versine_size_8 = (absolute(versine_b_cross2_1) + c4 * (c1 + versine_b_size_1)
        + (c3 + absolute(versine_c_lo) + absolute(versine_c - versine_b)))
    beta_v_0 = axis_0 * versine
    beta_v_size_1 = absolute(axis_0)
    versine_size_11 = (where(versine_d, 2, versine_b_size_1) + c5
        * where(c2 + absolute(cosine_own_error_1) < absolute(cosine - 0), 0, versine_size_8))
    beta_v_padded_1 = c1 + versine_size_11
    beta_v_1 = axis_1 * versine
    beta_v_size_3 = absolute(axis_1)
    beta_v_2 = axis_2 * versine
    beta_v_size_5 = absolute(axis_2)
    beta_v_lo_1 = product_error(axis_0, versine, beta_v_0) + axis_0 * versine_lo
    m_0 = axis_0 * beta_v_0
    m_cross2_1 = axis_0 * beta_v_lo_1
    m_padded_1 = c1 + beta_v_padded_1 * beta_v_size_1
    m_size_1 = beta_v_size_1 * m_padded_1
    beta_v_lo_2 = product_error(axis_1, versine, beta_v_1) + axis_1 * versine_lo
    m_1 = axis_1 * beta_v_1
    m_cross2_2 = axis_1 * beta_v_lo_2
    m_padded_2 = c1 + beta_v_padded_1 * beta_v_size_3
    m_size_2 = beta_v_size_3 * m_padded_2
    m_2 = axis_2 * beta_v_2
    m_cross2_3 = axis_2 * (product_error(axis_2, versine, beta_v_2) + axis_2 * versine_lo)
    m_size_3 = beta_v_size_5 * (c1 + beta_v_padded_1 * beta_v_size_5)
    m_3 = axis_1 * beta_v_0
    m_cross2_4 = axis_1 * beta_v_lo_1
    m_4 = axis_2 * beta_v_0
    m_cross2_5 = axis_2 * beta_v_lo_1
    m_5 = axis_2 * beta_v_1
    m_cross2_6 = axis_2 * beta_v_lo_2
    others_0 = m_1 + m_2
    others_right_1 = others_0 - m_1
    others_lo1_1 = (product_rest(axis_1, beta_v_1, m_1, others_0 - others_right_1)
        + product_rest(axis_2, beta_v_2, m_2, others_right_1))
    others_1 = m_0 + m_2
    others_right_2 = others_1 - m_0
    others_lo1_2 = (product_rest(axis_0, beta_v_0, m_0, others_1 - others_right_2)
        + product_rest(axis_2, beta_v_2, m_2, others_right_2))
    others_2 = m_0 + m_1
    others_right_3 = others_2 - m_0
    others_lo1_3 = (product_rest(axis_0, beta_v_0, m_0, others_2 - others_right_3)
        + product_rest(axis_1, beta_v_1, m_1, others_right_3))
    alpha_v_0 = axis_0 * sine
    alpha_v_cross2_1 = axis_0 * sine_own_error_1
    alpha_v_1 = axis_1 * sine
    alpha_v_cross2_2 = axis_1 * sine_own_error_1
    alpha_v_2 = axis_2 * sine
    alpha_v_cross2_3 = axis_2 * sine_own_error_1
    R_00 = 1 - others_0
    R_right_1 = 1 - R_00
    R_01 = m_3 - alpha_v_2
    R_right_2 = m_3 - R_01
    R_02 = m_4 + alpha_v_1
    R_right_3 = R_02 - m_4
    R_10 = m_3 + alpha_v_2
    R_right_4 = R_10 - m_3
    R_11 = 1 - others_1
    R_right_5 = 1 - R_11
    R_12 = m_5 - alpha_v_0
    R_right_6 = m_5 - R_12
    R_20 = m_4 - alpha_v_1
    R_right_7 = m_4 - R_20
    R_21 = m_5 + alpha_v_0
    R_right_8 = R_21 - m_5
    R_22 = 1 - others_2
    R_right_9 = 1 - R_22
    R_error_1 = absolute(1 - (R_00 + R_right_1) - (others_0 - R_right_1) - (others_lo1_1 +
        (m_cross2_2 + m_cross2_3)))
    R_lo_2 = (product_rest(axis_1, beta_v_0, m_3, R_01 + R_right_2)
        - product_rest(axis_2, sine, alpha_v_2, R_right_2) + (m_cross2_4 - alpha_v_cross2_3))
    R_rest_2 = c7 * (c1 + (beta_v_size_5 + beta_v_size_3 * m_padded_1))
    R_lo_3 = (product_rest(axis_2, beta_v_0, m_4, R_02 - R_right_3)
        + product_rest(axis_1, sine, alpha_v_1, R_right_3) + (m_cross2_5 + alpha_v_cross2_2))
    R_rest_3 = c7 * (c1 + (beta_v_size_3 + beta_v_size_5 * m_padded_1))
    R_lo_4 = (product_rest(axis_1, beta_v_0, m_3, R_10 - R_right_4)
        + product_rest(axis_2, sine, alpha_v_2, R_right_4) + (m_cross2_4 + alpha_v_cross2_3))
    R_error_5 = absolute(1 - (R_11 + R_right_5) - (others_1 - R_right_5) - (others_lo1_2 +
        (m_cross2_1 + m_cross2_3)))
    R_lo_6 = (product_rest(axis_2, beta_v_1, m_5, R_12 + R_right_6)
        - product_rest(axis_0, sine, alpha_v_0, R_right_6) + (m_cross2_6 - alpha_v_cross2_1))
    R_rest_5 = c7 * (c1 + (beta_v_size_1 + beta_v_size_5 * m_padded_2))
    R_lo_7 = (product_rest(axis_2, beta_v_0, m_4, R_20 + R_right_7)
        - product_rest(axis_1, sine, alpha_v_1, R_right_7) + (m_cross2_5 - alpha_v_cross2_2))
    R_lo_8 = (product_rest(axis_2, beta_v_1, m_5, R_21 - R_right_8)
        + product_rest(axis_0, sine, alpha_v_0, R_right_8) + (m_cross2_6 + alpha_v_cross2_1))
    R_error_9 = absolute(1 - (R_22 + R_right_9) - (others_2 - R_right_9) - (others_lo1_3 +
        (m_cross2_1 + m_cross2_2)))
    R_bound_1 = R_error_1 + c6 * (c1 + (1 + (m_size_2 + m_size_3)))
    R_bound_2 = absolute(R_lo_2) + R_rest_2
    R_bound_3 = absolute(R_lo_3) + R_rest_3
    R_bound_4 = absolute(R_lo_4) + R_rest_2
    R_bound_5 = R_error_5 + c6 * (c1 + (1 + (m_size_1 + m_size_3)))
    R_bound_6 = absolute(R_lo_6) + R_rest_5
    R_bound_7 = absolute(R_lo_7) + R_rest_3
    R_bound_8 = absolute(R_lo_8) + R_rest_5
    R_bound_9 = R_error_9 + c6 * (c1 + (1 + (m_size_1 + m_size_2)))
    return (R_00, R_01, R_02, R_10, R_11, R_12, R_20, R_21, R_22, R_bound_1, R_bound_2, R_bound_3,
        R_bound_4, R_bound_5, R_bound_6, R_bound_7, R_bound_8, R_bound_9)


@kernel("(3,3)->(),(3),(),(3)")
@errstate(all="ignore")
def axis_angle_from_mat3x3(R, *, c1=1.8051943758648296e-276, c2=1.6023738312796216e-30,
        c3=1.5845630613906556e+29, c4=6.703903964971299e+153, c5=3.7291703656001034e-155,
        c6=1.3093562431584567e+151, c7=1.955159272639747e-149, c8=1.0715086071862673e+301,
        c9=6.705320021857442e-30, c10=140737488355328, c11=1.150011758590251e-29,
        c12=1.1418664350501995e+29, c13=2.6815615859885194e+154, c14=7.637340908749012e-152,
        c15=9.332636185032189e-302, c16=9.423194733875307e-30, c17=6.508104019725916e-30,
        c18=4.527322338646221e+28, c19=9.152022998369425e-30, c20=7.9228134180075855e+28,
        c21=1.3016211142756918e-29, c22=1.86204130450056e-29, c23=5.516518603020976e+28,
        c24=2.3160472449138492e-29, c25=1.8620414596658144e-29, c26=1.0715086071862673e+301):
    """angle and axis of the rotation R; 0 <= angle <= π; the axis is (1, 0, 0) if the angle is 0;
    |error of angle| <= angle_bound, |error of axis| <= axis_bound unless inf or NaN.

    (3,3)->(),(3),(),(3).  R: rotation or other 3×3 matrix; angle, angle_bound: number; axis,
    axis_bound: vector.
    233 mul, 467 add, 25 product error, 3 product rest, 24 div, 2 sqrt, 10 neg, 70 abs, 4
    copysign, 41 less, 7 equal, 111 select.
    """
    R_00, R_01, R_02, R_10, R_11, R_12, R_20, R_21, R_22 = R
    p_0 = R_21 - R_12
    p_right_1 = R_21 - p_0
    p_lo_1 = R_21 - (p_0 + p_right_1) - (R_12 - p_right_1)
    p_size_3 = absolute(R_21) + absolute(R_12)
    p_1 = R_02 - R_20
    p_right_2 = R_02 - p_1
    p_lo_2 = R_02 - (p_1 + p_right_2) - (R_20 - p_right_2)
    p_size_6 = absolute(R_02) + absolute(R_20)
    p_2 = R_10 - R_01
    p_right_3 = R_10 - p_2
    p_lo_3 = R_10 - (p_2 + p_right_3) - (R_01 - p_right_3)
    p_size_9 = absolute(R_10) + absolute(R_01)
    s_0 = R_12 + R_21
    s_right_1 = s_0 - R_12
    s_lo_1 = R_12 - (s_0 - s_right_1) + (R_21 - s_right_1)
    s_1 = R_02 + R_20
    s_right_2 = s_1 - R_02
    s_lo_2 = R_02 - (s_1 - s_right_2) + (R_20 - s_right_2)
    s_2 = R_01 + R_10
    s_right_3 = s_2 - R_01
    s_lo_3 = R_01 - (s_2 - s_right_3) + (R_10 - s_right_3)
    first_0 = R_00 + 1
    first_right_1 = first_0 - R_00
    first_lo_1 = R_00 - (first_0 - first_right_1) + (1 - first_right_1)
    first_1 = 1 - R_00
    first_right_2 = 1 - first_1
    first_lo_2 = 1 - (first_1 + first_right_2) - (R_00 - first_right_2)
    others_0 = R_11 + R_22
    others_right_1 = others_0 - R_11
    others_lo_1 = R_11 - (others_0 - others_right_1) + (R_22 - others_right_1)
    others_1 = R_11 - R_22
    others_right_2 = R_11 - others_1
    others_lo_2 = R_11 - (others_1 + others_right_2) - (R_22 - others_right_2)
    d_0 = first_0 + others_0
    d_right_1 = d_0 - first_0
    d_size_1 = 1 + absolute(R_00) + (absolute(R_11) + absolute(R_22))
    d_1 = first_0 - others_0
    d_right_2 = first_0 - d_1
    d_2 = first_1 + others_1
    d_right_3 = d_2 - first_1
    d_3 = first_1 - others_1
    d_right_4 = first_1 - d_3
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
    low_lo_1 = where(low_0a,
        first_0 - (d_1 + d_right_2) - (others_0 - d_right_2) - others_lo_1 + first_lo_1, s_lo_3)
    column_lo_1 = where(column_0a, low_lo_1, where(high_0b, s_lo_2, p_lo_1))
    column_size_1 = where(column_0a, where(low_0a, d_size_1, p_size_9), where(high_0b, p_size_6,
        p_size_3))
    column_1 = where(column_0a, low_1, high_1)
    low_lo_2 = where(low_0a, s_lo_3,
        first_1 - (d_2 - d_right_3) + (others_1 - d_right_3) + others_lo_2 + first_lo_2)
    column_lo_2 = where(column_0a, low_lo_2, where(high_0b, s_lo_1, p_lo_2))
    column_size_2 = where(column_0a, where(low_0a, p_size_9, d_size_1), where(high_0b, p_size_3,
        p_size_6))
    column_2 = where(column_0a, low_2, high_2)
    high_lo_3 = where(high_0b,
        first_1 - (d_3 + d_right_4) - (others_1 - d_right_4) - others_lo_2 + first_lo_2, p_lo_3)
    column_lo_3 = where(column_0a, where(low_0a, s_lo_2, s_lo_1), high_lo_3)
    column_size_3 = where(column_0a, where(low_0a, p_size_6, p_size_3), where(high_0b, d_size_1,
        p_size_9))
    column_3 = where(column_0a, low_3, high_3)
    high_lo_4 = where(high_0b, p_lo_3,
        first_0 - (d_0 - d_right_1) + (others_0 - d_right_1) + others_lo_1 + first_lo_1)
    column_lo_4 = where(column_0a, where(low_0a, p_lo_1, p_lo_2), high_lo_4)
    column_size_4 = where(column_0a, where(low_0a, p_size_3, p_size_6), where(high_0b, p_size_9,
        d_size_1))
    upper_0a = -column_0
    upper_0a_lo = -column_lo_1
    upper_0b = column_3 < 0
    upper_0 = where(upper_0b, upper_0a, column_0)
    upper_rest_1 = c2 * (c1 + column_size_4)
    upper_bound_1 = absolute(column_lo_4) + upper_rest_1
    upper_size_3 = upper_bound_1 < absolute(column_3 - 0)
    upper_rest_2 = c2 * (c1 + column_size_1)
    upper_size_8 = where(upper_size_3, 0,
        absolute(column_lo_1) + upper_rest_2 + (absolute(upper_0a_lo) + upper_rest_2 +
            absolute(upper_0a - column_0)))
    upper_1a = -column_1
    upper_1a_lo = -column_lo_2
    upper_1 = where(upper_0b, upper_1a, column_1)
    upper_rest_3 = c2 * (c1 + column_size_2)
    upper_size_15 = where(upper_size_3, 0,
        absolute(column_lo_2) + upper_rest_3 + (absolute(upper_1a_lo) + upper_rest_3 +
            absolute(upper_1a - column_1)))
    upper_2a = -column_2
    upper_2a_lo = -column_lo_3
    upper_2 = where(upper_0b, upper_2a, column_2)
    upper_rest_4 = c2 * (c1 + column_size_3)
    upper_size_22 = where(upper_size_3, 0,
        absolute(column_lo_3) + upper_rest_4 + (absolute(upper_2a_lo) + upper_rest_4 +
            absolute(upper_2a - column_2)))
    upper_3a = -column_3
    upper_3a_lo = -column_lo_4
    upper_3 = where(upper_0b, upper_3a, column_3)
    upper_lo_4 = where(upper_0b, upper_3a_lo, column_lo_4)
    v_s_size_0 = absolute(upper_0)
    v_s_size_1 = absolute(upper_1)
    v_s_size_2 = absolute(upper_2)
    v_s_largest1 = where(v_s_size_0 < v_s_size_1, v_s_size_1, v_s_size_0)
    v_s_largest2 = where(v_s_largest1 < v_s_size_2, v_s_size_2, v_s_largest1)
    v_s_a = c4 < v_s_largest2
    v_s_c = v_s_largest2 < 256
    v_s_e = v_s_largest2 < c7
    v_s = where(v_s_e, c8, where(v_s_c, c6, where(v_s_a, real(c5), real(1))))
    v_s_size_3 = where(v_s_e, c8, where(v_s_c, c6, where(v_s_a, real(c5), real(1))))
    v_y_0 = upper_0 * v_s
    v_y_inverse_1 = 1 / v_s
    v_y_lo_1 = (upper_0 - v_y_0 * v_y_inverse_1 + where(upper_0b, upper_0a_lo, column_lo_1)) * v_s
    v_y_1 = upper_1 * v_s
    v_y_lo_2 = (upper_1 - v_y_1 * v_y_inverse_1 + where(upper_0b, upper_1a_lo, column_lo_2)) * v_s
    v_y_2 = upper_2 * v_s
    v_y_lo_3 = (upper_2 - v_y_2 * v_y_inverse_1 + where(upper_0b, upper_2a_lo, column_lo_3)) * v_s
    v_n_a = v_y_0 * v_y_0
    v_n_a_padded_1 = c1 + v_s_size_3 * (c1 + (column_size_1 + c3 * upper_size_8))
    v_n_a_size_2 = (v_n_a_padded_1
        * (absolute(v_y_0) + c10 * (absolute(v_y_lo_1) + c9 * v_n_a_padded_1)))
    v_n_b = v_y_1 * v_y_1
    v_n_b_padded_1 = c1 + v_s_size_3 * (c1 + (column_size_2 + c3 * upper_size_15))
    v_n_b_size_2 = (v_n_b_padded_1
        * (absolute(v_y_1) + c10 * (absolute(v_y_lo_2) + c9 * v_n_b_padded_1)))
    v_n_c = v_n_a + v_n_b
    v_n_c_right_1 = v_n_c - v_n_a
    v_n_c_lo1_1 = (product_rest(v_y_0, v_y_0, v_n_a, v_n_c - v_n_c_right_1)
        + product_rest(v_y_1, v_y_1, v_n_b, v_n_c_right_1))
    v_n_d = v_y_2 * v_y_2
    v_n_d_padded_1 = c1 + v_s_size_3 * (c1 + (column_size_3 + c3 * upper_size_22))
    v_n_d_size_2 = (v_n_d_padded_1
        * (absolute(v_y_2) + c10 * (absolute(v_y_lo_3) + c9 * v_n_d_padded_1)))
    v_n_e = v_n_c + v_n_d
    v_n_e_right_1 = v_n_e - v_n_c
    v_n_e_lo2_1 = (v_n_c - (v_n_e - v_n_e_right_1)
        + product_rest(v_y_2, v_y_2, v_n_d, v_n_e_right_1) + (v_y_lo_3 * v_y_2 + v_y_2 * v_y_lo_3))
    v_n_e_lo = (v_n_e_lo2_1
        + (v_n_c_lo1_1
        + (v_y_lo_1 * v_y_0 + v_y_0 * v_y_lo_1 + (v_y_lo_2 * v_y_1 + v_y_1 * v_y_lo_2))))
    v_n = sqrt(v_n_e)
    v_n_product_1 = v_n * v_n
    v_n_lo = ((v_n_e - v_n_product_1 - product_error(v_n, v_n, v_n_product_1) + v_n_e_lo)
        / where(v_n == 0, 1, v_n + v_n))
    v_n_padded_1 = (c1
        + (v_n_a_size_2 + v_n_a_size_2 + (v_n_b_size_2 + v_n_b_size_2)
        + (v_n_d_size_2 + v_n_d_size_2)))
    v_n_bound_1 = absolute(v_n_e_lo) + c11 * v_n_padded_1
    v_n_size_6 = absolute(v_n_lo)
    v_n_size_4 = (absolute(v_n_e) + c10 * v_n_bound_1) * (v_n_padded_1 / v_n / v_n_e)
    v_n_size_12 = (v_n
        + where(4 * v_n_bound_1 < v_n_e, v_n_size_4, c12 * (sqrt(v_n_bound_1) + v_n_size_6)))
    v_r_a = v_s < 1
    v_r_c = 1 < v_s
    v_r_e = c6 < v_s
    v_r = where(v_r_e, c15, where(v_r_c, c14, where(v_r_a, real(c13), real(1))))
    n = v_n * v_r
    n_lo = (v_n - n * (1 / v_r) + v_n_lo) * v_r
    n_padded_1 = c1 + v_n_size_12
    half = elementary.atan2(n, upper_3)
    half_size0_1 = absolute(n)
    half_size1_1 = absolute(upper_3)
    half_most_1 = where(half_size0_1 < half_size1_1, half_size1_1, half_size0_1)
    half_zero_1 = half_most_1 == 0
    half_divisor_1 = where(half_zero_1, 1, half_most_1)
    half_part0_1 = n / half_divisor_1
    half_part1_1 = upper_3 / half_divisor_1
    half_safe_1 = where(half_zero_1, 1,
        half_divisor_1 * (half_part1_1 * half_part1_1 + half_part0_1 * half_part0_1))
    half_lo = (elementary.atan2_error(n, upper_3, half)
        + (half_part1_1 * n_lo - half_part0_1 * upper_lo_4) / half_safe_1)
    half_padded_1 = (c1 + n_padded_1
        * where(v_r_e, c15, where(v_r_c, c14, where(v_r_a, real(c13), real(1)))))
    upper_size_31 = (column_size_4 + c3
        * where(upper_size_3, 0, upper_bound_1
        + (absolute(upper_3a_lo) + upper_rest_1 + absolute(upper_3a - column_3))))
    half_padded_2 = c1 + upper_size_31
    half_size_2 = absolute(n)
    half_size_3 = absolute(upper_3)
    half_size_5 = where(half_size_2 < half_size_3, half_size_3, half_size_2)
    half_bound_1 = absolute(n_lo) + c16 * half_padded_1
    half_bound_2 = absolute(upper_lo_4) + c17 * half_padded_2
    half_size_11 = (half_bound_2 + (c1 + half_bound_1)) / half_size_5
    half_size_13 = half_size_11 * half_size_11
    half_size_15 = 7 + absolute(half_lo)
    half_size_19 = where(half_bound_1 < half_size_2, half_size_13, where(half_bound_2 < upper_3,
        half_size_13, half_size_15))
    divisor_a = v_n == 0
    divisor = where(divisor_a, 1, v_n)
    divisor_lo = where(divisor_a, 0, v_n_lo)
    divisor_bound_1 = c19 * n_padded_1 + v_n_size_6
    divisor_size_4 = divisor_bound_1 < absolute(v_n - 0)
    unit_0 = v_y_0 / divisor
    unit_product_1 = unit_0 * divisor
    unit_lo_1 = ((v_y_0 - unit_product_1 - product_error(unit_0, divisor, unit_product_1)
        + v_y_lo_1 - unit_0 * divisor_lo) / divisor)
    unit_padded_1 = (c1
        + (where(divisor_a, 1, v_n_size_12) + c20
        * where(divisor_size_4, 0, divisor_bound_1 + absolute(1 - v_n))))
    unit_size_1 = absolute(unit_0)
    unit_size_2 = absolute(divisor)
    unit_bound_1 = absolute(divisor_lo) + c21 * unit_padded_1
    unit_size_7 = where(4 * unit_bound_1 < unit_size_2, unit_size_2, 0)
    unit_reach_1 = unit_size_2 + c10 * unit_bound_1
    unit_size_11 = (unit_size_1 + unit_reach_1
        * ((unit_padded_1 * unit_size_1 + v_n_a_padded_1) / unit_size_7) / unit_size_2)
    unit_1 = v_y_1 / divisor
    unit_product_2 = unit_1 * divisor
    unit_size_12 = absolute(unit_1)
    unit_2 = v_y_2 / divisor
    unit_product_3 = unit_2 * divisor
    unit_size_19 = absolute(unit_2)
    angle = 2 * half
    axis_0 = where(divisor_a, 1, unit_0)
    axis_size_6 = (c23
        * where(divisor_size_4, 0, absolute(unit_lo_1) + c22 * (c1 + unit_size_11)
        + absolute(1 - unit_0)))
    angle_size_1 = (2
        * (absolute(half) + (half_padded_1 + half_padded_2) / half_size_5 + c18
        * where(half_size_11 < 0.25, half_size_19, half_size_15)))
    unit_error_2 = absolute((v_y_1 - unit_product_2 - product_error(unit_1, divisor,
        unit_product_2) + v_y_lo_2 - unit_1 * divisor_lo) / divisor)
    unit_rest_5 = (c22
        * (c1
        + (unit_size_12 + unit_reach_1
        * ((unit_padded_1 * unit_size_12 + v_n_b_padded_1) / unit_size_7) / unit_size_2)))
    unit_error_3 = absolute((v_y_2 - unit_product_3 - product_error(unit_2, divisor,
        unit_product_3) + v_y_lo_3 - unit_2 * divisor_lo) / divisor)
    unit_rest_6 = (c22
        * (c1
        + (unit_size_19 + unit_reach_1
        * ((unit_padded_1 * unit_size_19 + v_n_d_padded_1) / unit_size_7) / unit_size_2)))
    R_n_0 = R_11 * R_22 - R_12 * R_21
    R_n_1 = R_02 * R_21 - R_01 * R_22
    R_n_2 = R_01 * R_12 - R_02 * R_11
    R_det = R_00 * R_n_0 + R_10 * R_n_1 + R_20 * R_n_2
    R_g_0 = R_00 * R_00 + R_10 * R_10 + R_20 * R_20
    R_g_1 = R_00 * R_01 + R_10 * R_11 + R_20 * R_21
    R_g_2 = R_00 * R_02 + R_10 * R_12 + R_20 * R_22
    R_g_3 = R_01 * R_01 + R_11 * R_11 + R_21 * R_21
    R_g_4 = R_01 * R_02 + R_11 * R_12 + R_21 * R_22
    R_g_5 = R_02 * R_02 + R_12 * R_12 + R_22 * R_22
    R_off_0 = R_det - 1
    R_off_1 = R_g_0 - 1
    R_off_4 = R_g_3 - 1
    R_off_6 = R_g_5 - 1
    R_defect_size_0 = absolute(R_off_0)
    R_defect_size_1 = absolute(R_off_1)
    R_defect_size_2 = absolute(R_g_1)
    R_defect_size_3 = absolute(R_g_2)
    R_defect_size_4 = absolute(R_off_4)
    R_defect_size_5 = absolute(R_g_4)
    R_defect_size_6 = absolute(R_off_6)
    R_defect_largest1 = where(R_defect_size_0 < R_defect_size_1, R_defect_size_1, R_defect_size_0)
    R_defect_largest2 = where(R_defect_largest1 < R_defect_size_2, R_defect_size_2,
        R_defect_largest1)
    R_defect_largest3 = where(R_defect_largest2 < R_defect_size_3, R_defect_size_3,
        R_defect_largest2)
    R_defect_largest4 = where(R_defect_largest3 < R_defect_size_4, R_defect_size_4,
        R_defect_largest3)
    R_defect_largest5 = where(R_defect_largest4 < R_defect_size_5, R_defect_size_5,
        R_defect_largest4)
    R_defect_largest6 = where(R_defect_largest5 < R_defect_size_6, R_defect_size_6,
        R_defect_largest5)
    R_is_less = R_defect_largest6 < 0.001
    R_is_equal = R_defect_largest6 == 0.001
    R_unless_equal = where(R_is_equal, real(0), real(c26))
    R_unless_rotation = where(R_is_less, 0, R_unless_equal)
    R_excess = R_unless_rotation * c26
    R_excess_0 = absolute(2 * half_lo) + c24 * (c1 + angle_size_1) + R_excess
    R_excess_1 = (absolute(where(divisor_a, 0, unit_lo_1)) + c25
        * (c1 + (where(divisor_a, 1, unit_size_11) + axis_size_6)) + R_excess)
    R_excess_2 = unit_error_2 + unit_rest_5 + R_excess
    R_excess_3 = unit_error_3 + unit_rest_6 + R_excess
    return (angle, axis_0, unit_1, unit_2, R_excess_0, R_excess_1, R_excess_2, R_excess_3)
