# Made by `coscrew generate`; changes are overwritten.
# SPDX-License-Identifier: MIT
# coscrew 0.2.0.  Copyright (c) 2026 The coscrew authors.
"""3×3 matrices: rotations, and matrices in general.

In single precision, certified tier.
"""

from numpy import absolute
from coscrew._kernel import single_kernel as kernel


@kernel("(3),(3)->(3,3),(3,3)")
def acceleration_tensor(w, dw):
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
    Ro_00a_error_bound = 1.192093e-07 * (ww_1_abs + ww_2_abs + 1.9721522630525295e-31)
    Ro_01_error_bound = 1.192093e-07 * (Ro_01_size + 1.9721522630525295e-31)
    Ro_02_error_bound = 1.192093e-07 * (Ro_02_size + 1.9721522630525295e-31)
    Ro_10_error_bound = 1.192093e-07 * (Ro_10_size + 1.9721522630525295e-31)
    Ro_11a_error_bound = 1.192093e-07 * (ww_0_abs + ww_2_abs + 1.9721522630525295e-31)
    Ro_12_error_bound = 1.192093e-07 * (Ro_12_size + 1.9721522630525295e-31)
    Ro_20_error_bound = 1.192093e-07 * (Ro_20_size + 1.9721522630525295e-31)
    Ro_21_error_bound = 1.192093e-07 * (Ro_21_size + 1.9721522630525295e-31)
    Ro_22a_error_bound = 1.192093e-07 * (ww_0_abs + ww_1_abs + 1.9721522630525295e-31)
    return (Ro_00, Ro_01, Ro_02, Ro_10, Ro_11, Ro_12, Ro_20, Ro_21, Ro_22, Ro_00a_error_bound,
        Ro_01_error_bound, Ro_02_error_bound, Ro_10_error_bound, Ro_11a_error_bound,
        Ro_12_error_bound, Ro_20_error_bound, Ro_21_error_bound, Ro_22a_error_bound)


@kernel("(3,3)->(),()")
def mat3x3_determinant(R):
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
    det_a_size = absolute(R_00) * (n_0_size + 1.9721522630525295e-31)
    det_c_size = det_a_size + absolute(R_10) * (n_1_size + 1.9721522630525295e-31)
    det_size = det_c_size + absolute(R_20) * (n_2_size + 1.9721522630525295e-31)
    det_error_bound = 2.9802328e-07 * (det_size + 1.9721522630525295e-31)
    return (det, det_error_bound)


@kernel("(3),(2)->(3,3),(3,3)")
def mat3x3_setFromAxisDC(axis, dc):
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
    versine_axis_0_padded = versine_axis_0_size + 1.9721522630525295e-31
    m_0_size = axis_0_abs * versine_axis_0_padded
    versine_axis_1_padded = versine_axis_1_size + 1.9721522630525295e-31
    m_1_size = axis_1_abs * versine_axis_1_padded
    m_2_size = axis_2_abs * (versine_axis_2_size + 1.9721522630525295e-31)
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
    R_00_error_bound = 2.3841864e-07 * (R_00_size + 1.9721522630525295e-31)
    R_01_error_bound = 2.3841864e-07 * (R_01_size + 1.9721522630525295e-31)
    R_02_error_bound = 2.3841864e-07 * (R_02_size + 1.9721522630525295e-31)
    R_10_error_bound = 2.3841864e-07 * (R_10_size + 1.9721522630525295e-31)
    R_11_error_bound = 2.3841864e-07 * (R_11_size + 1.9721522630525295e-31)
    R_12_error_bound = 2.3841864e-07 * (R_12_size + 1.9721522630525295e-31)
    R_20_error_bound = 2.3841864e-07 * (R_20_size + 1.9721522630525295e-31)
    R_21_error_bound = 2.3841864e-07 * (R_21_size + 1.9721522630525295e-31)
    R_22_error_bound = 2.3841864e-07 * (R_22_size + 1.9721522630525295e-31)
    return (R_00, R_01, R_02, R_10, R_11, R_12, R_20, R_21, R_22, R_00_error_bound,
        R_01_error_bound, R_02_error_bound, R_10_error_bound, R_11_error_bound, R_12_error_bound,
        R_20_error_bound, R_21_error_bound, R_22_error_bound)
