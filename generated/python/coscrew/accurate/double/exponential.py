# Made by `coscrew generate`; changes are overwritten.
# SPDX-License-Identifier: MIT
# coscrew 0.2.0.  Copyright (c) 2026 The coscrew authors.
"""Exponentials and logarithms of rotations and displacements, their Jacobians, interpolation.

In double precision, accurate tier.
"""

from coscrew import _elementary_double as elementary
from numpy import absolute, float64 as real, sqrt, where
from coscrew._exact import product_error, product_rest
from coscrew._kernel import double_kernel as kernel


@kernel("(3)->(3,3)")
def SO3_exp(v):
    """R = exp v~ = I + sin θ/θ v~ + (1 - cos θ)/θ^2 v~^2, θ = |v|.

    (3)->(3,3).  v: vector; R: rotation or other 3×3 matrix.
    178 mul, 320 add, 17 product error, 22 product rest, 5 div, 1 sqrt, 7 abs, 6 less, 10 equal,
    19 select.  Error <= R: 1 u of its largest component for |v| <= 1e13, in single precision
    1e5; searched, not proved.  Each component is within 1 ulp as long as its condition is below
    1e13; in single precision it is the nearest number, except near ties, as long as that is
    below 1e5; searched, not proved.
    """
    v_0, v_1, v_2 = v
    halved_0 = 0.5 * v_0
    halved_1 = 0.5 * v_1
    halved_2 = 0.5 * v_2
    h_size_0 = absolute(halved_0)
    h_size_1 = absolute(halved_1)
    h_size_2 = absolute(halved_2)
    h_largest1 = where(h_size_0 < h_size_1, h_size_1, h_size_0)
    h_largest2 = where(h_largest1 < h_size_2, h_size_2, h_largest1)
    s = where(6.703903964971299e+153 < h_largest2, real(3.7291703656001034e-155), real(1))
    reduced_0 = halved_0 * s
    reduced_1 = halved_1 * s
    reduced_2 = halved_2 * s
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
    c_lo = c_own_error - (sine_half_cos * sine + sine_half_sin * c) * sine_twice
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
    turning_0 = v_0 * sinc
    turning_1 = v_1 * sinc
    turning_2 = v_2 * sinc
    turning_0_lo = product_error(v_0, sinc, turning_0) + v_0 * sinc_lo
    beta_v_0 = 0.5 * turning_0
    beta_v_0_cross2 = 0.5 * turning_0_lo
    turning_1_lo = product_error(v_1, sinc, turning_1) + v_1 * sinc_lo
    beta_v_1 = 0.5 * turning_1
    beta_v_1_cross2 = 0.5 * turning_1_lo
    turning_2_lo = product_error(v_2, sinc, turning_2) + v_2 * sinc_lo
    beta_v_2 = 0.5 * turning_2
    m_0 = turning_0 * beta_v_0
    m_0_cross = turning_0_lo * beta_v_0 + turning_0 * beta_v_0_cross2
    m_1 = turning_1 * beta_v_1
    m_1_cross = turning_1_lo * beta_v_1 + turning_1 * beta_v_1_cross2
    m_2 = turning_2 * beta_v_2
    m_2_cross = turning_2_lo * beta_v_2 + turning_2 * (0.5 * turning_2_lo)
    m_3 = turning_1 * beta_v_0
    m_3_cross = turning_1_lo * beta_v_0 + turning_1 * beta_v_0_cross2
    m_4 = turning_2 * beta_v_0
    m_4_cross = turning_2_lo * beta_v_0 + turning_2 * beta_v_0_cross2
    m_5 = turning_2 * beta_v_1
    m_5_cross = turning_2_lo * beta_v_1 + turning_2 * beta_v_1_cross2
    others_0 = m_1 + m_2
    others_0_right = others_0 - m_1
    others_0_lo1 = (product_rest(turning_1, beta_v_1, m_1, others_0 - others_0_right)
        + product_rest(turning_2, beta_v_2, m_2, others_0_right))
    others_1 = m_0 + m_2
    others_1_right = others_1 - m_0
    others_1_lo1 = (product_rest(turning_0, beta_v_0, m_0, others_1 - others_1_right)
        + product_rest(turning_2, beta_v_2, m_2, others_1_right))
    others_2 = m_0 + m_1
    others_2_right = others_2 - m_0
    others_2_lo1 = (product_rest(turning_0, beta_v_0, m_0, others_2 - others_2_right)
        + product_rest(turning_1, beta_v_1, m_1, others_2_right))
    alpha_v_0 = c * turning_0
    alpha_v_0_cross = c_lo * turning_0 + c * turning_0_lo
    alpha_v_1 = c * turning_1
    alpha_v_1_cross = c_lo * turning_1 + c * turning_1_lo
    alpha_v_2 = c * turning_2
    alpha_v_2_cross = c_lo * turning_2 + c * turning_2_lo
    R_00 = 1 - others_0
    R_00_right = 1 - R_00
    R_01 = m_3 - alpha_v_2
    R_01_right = m_3 - R_01
    R_01_lo1 = (product_rest(turning_1, beta_v_0, m_3, R_01 + R_01_right)
        - product_rest(c, turning_2, alpha_v_2, R_01_right))
    R_02 = m_4 + alpha_v_1
    R_02_right = R_02 - m_4
    R_02_lo1 = (product_rest(turning_2, beta_v_0, m_4, R_02 - R_02_right)
        + product_rest(c, turning_1, alpha_v_1, R_02_right))
    R_10 = m_3 + alpha_v_2
    R_10_right = R_10 - m_3
    R_10_lo1 = (product_rest(turning_1, beta_v_0, m_3, R_10 - R_10_right)
        + product_rest(c, turning_2, alpha_v_2, R_10_right))
    R_11 = 1 - others_1
    R_11_right = 1 - R_11
    R_12 = m_5 - alpha_v_0
    R_12_right = m_5 - R_12
    R_12_lo1 = (product_rest(turning_2, beta_v_1, m_5, R_12 + R_12_right)
        - product_rest(c, turning_0, alpha_v_0, R_12_right))
    R_20 = m_4 - alpha_v_1
    R_20_right = m_4 - R_20
    R_20_lo1 = (product_rest(turning_2, beta_v_0, m_4, R_20 + R_20_right)
        - product_rest(c, turning_1, alpha_v_1, R_20_right))
    R_21 = m_5 + alpha_v_0
    R_21_right = R_21 - m_5
    R_21_lo1 = (product_rest(turning_2, beta_v_1, m_5, R_21 - R_21_right)
        + product_rest(c, turning_0, alpha_v_0, R_21_right))
    R_22 = 1 - others_2
    R_22_right = 1 - R_22
    R_00_rounded = (R_00
        + (1 - (R_00 + R_00_right) - (others_0 - R_00_right)
        - (others_0_lo1 + (m_1_cross + m_2_cross))))
    R_01_rounded = R_01 + (R_01_lo1 + (m_3_cross - alpha_v_2_cross))
    R_02_rounded = R_02 + (R_02_lo1 + (m_4_cross + alpha_v_1_cross))
    R_10_rounded = R_10 + (R_10_lo1 + (m_3_cross + alpha_v_2_cross))
    R_11_rounded = (R_11
        + (1 - (R_11 + R_11_right) - (others_1 - R_11_right)
        - (others_1_lo1 + (m_0_cross + m_2_cross))))
    R_12_rounded = R_12 + (R_12_lo1 + (m_5_cross - alpha_v_0_cross))
    R_20_rounded = R_20 + (R_20_lo1 + (m_4_cross - alpha_v_1_cross))
    R_21_rounded = R_21 + (R_21_lo1 + (m_5_cross + alpha_v_0_cross))
    R_22_rounded = (R_22
        + (1 - (R_22 + R_22_right) - (others_2 - R_22_right)
        - (others_2_lo1 + (m_0_cross + m_1_cross))))
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


@kernel("(3,3)->(3)")
def SO3_log(R):
    """vo with exp vo~ = R, |vo| <= π; if R is not quite a rotation, its defect carries over to vo.

    (3,3)->(3).  R: rotation or other 3×3 matrix; vo: vector.
    162 mul, 433 add, 26 product error, 3 product rest, 10 div, 1 sqrt, 13 neg, 13 abs, 4
    copysign, 29 less, 9 equal, 77 select.  Error <= vo: 1 u of its largest component for R a
    rotation; searched, not proved.  Each component is within 1 ulp as long as its condition is
    below 1e13; in single precision it is the nearest number, except near ties, as long as that
    is below 1e5; searched, not proved.
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
    divisor_a = n_sum == 0
    divisor = where(divisor_a, 1, n_sum)
    divisor_lo = where(divisor_a, 0, n_sum_lo)
    theta = 2 * half
    theta_cross2 = 2 * (elementary.atan2_error(n_sum, upper_3_sum, half) + half_more)
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
    vector_0 = upper_0_sum * k
    vector_1 = upper_1_sum * k
    vector_2 = upper_2_sum * k
    vector_0_rounded = (vector_0
        + (product_error(upper_0_sum, k, vector_0) + (upper_0_sum_lo * k + upper_0_sum * k_lo)))
    vector_1_rounded = (vector_1
        + (product_error(upper_1_sum, k, vector_1) + (upper_1_sum_lo * k + upper_1_sum * k_lo)))
    vector_2_rounded = (vector_2
        + (product_error(upper_2_sum, k, vector_2) + (upper_2_sum_lo * k + upper_2_sum * k_lo)))
    vector_0_final = where(vector_0_rounded == vector_0_rounded, vector_0_rounded, vector_0)
    vector_1_final = where(vector_1_rounded == vector_1_rounded, vector_1_rounded, vector_1)
    vector_2_final = where(vector_2_rounded == vector_2_rounded, vector_2_rounded, vector_2)
    return (vector_0_final, vector_1_final, vector_2_final)


@kernel("(3)->(3,3)")
def SO3_leftJacobian(v):
    """R = J_l(v) = I + (1 - cos θ)/θ^2 v~ + (θ - sin θ)/θ^3 v~^2, θ = |v|.

    (3)->(3,3).  v: vector; R: rotation or other 3×3 matrix.
    208 mul, 471 add, 21 product error, 43 product rest, 6 div, 1 sqrt, 4 abs, 6 less, 10 equal,
    25 select.  Error <= R: 1 u of its largest component for |v| <= 1e13, in single precision
    1e5; searched, not proved.  Each component is within 1 ulp as long as its condition is below
    1e13; in single precision it is the nearest number, except near ties, as long as that is
    below 1e5; searched, not proved.
    """
    v_0, v_1, v_2 = v
    halved_0 = 0.5 * v_0
    halved_1 = 0.5 * v_1
    halved_2 = 0.5 * v_2
    y_a = halved_0 * halved_0
    y_b = halved_1 * halved_1
    y_c = y_a + y_b
    y_c_right = y_c - y_a
    y_d = halved_2 * halved_2
    y = y_c + y_d
    y_right = y - y_c
    y_c_lo = (product_rest(halved_0, halved_0, y_a, y_c - y_c_right)
        + product_rest(halved_1, halved_1, y_b, y_c_right))
    y_lo = y_c - (y - y_right) + product_rest(halved_2, halved_2, y_d, y_right) + y_c_lo
    y_sum = y + y_lo
    y_sum_right = y_sum - y
    y_sum_lo = y - (y_sum - y_sum_right) + (y_lo - y_sum_right)
    half_angle = sqrt(y_sum)
    half_angle_product = half_angle * half_angle
    half_angle_residual = (y_sum - half_angle_product
        - product_error(half_angle, half_angle, half_angle_product) + y_sum_lo)
    half_angle_lo = half_angle_residual / where(half_angle == 0, 1, half_angle + half_angle)
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
    sinc_a = 0.16666666666666666 * y_sum
    sinc_b = 1 - sinc_a
    sinc_b_right = 1 - sinc_b
    sinc_b_lo1 = (1 - (sinc_b + sinc_b_right)
        - product_rest(0.16666666666666666, y_sum, sinc_a, sinc_b_right))
    sinc = where(sinc_divisor_a, sinc_b, sinc_quotient)
    sinc_quotient_lo = ((sinc_quotient_exact
        + (sine - (sine_sum - sine_sum_right) + (sine_lo - sine_sum_right)) - sinc_quotient_cross)
        / sinc_divisor_sum)
    sinc_lo = where(sinc_divisor_a,
        sinc_b_lo1 - (9.25185853854297e-18 * y_sum + 0.16666666666666666 * y_sum_lo),
        sinc_quotient_lo)
    g1 = c * sinc
    g1_cross = ((c_own_error - (sine_half_cos * sine + sine_half_sin * c) * sine_twice) * sinc + c
        * sinc_lo)
    g2a = sinc * sinc
    g2 = 0.5 * g2a
    g2_cross2 = 0.5 * (product_error(sinc, sinc, g2a) + (sinc_lo * sinc + sinc * sinc_lo))
    rest3 = 1 - g1
    rest3_right = 1 - rest3
    rest3_lo = 1 - (rest3 + rest3_right) - product_rest(c, sinc, g1, rest3_right) - g1_cross
    x = 4 * y_sum
    x_cross2 = 4 * y_sum_lo
    x_sum = x + x_cross2
    x_sum_right = x_sum - x
    x_sum_lo = x - (x_sum - x_sum_right) + (x_cross2 - x_sum_right)
    far_x_a = x_sum < 1
    far_x = where(far_x_a, 1, x_sum)
    far_x_lo = where(far_x_a, 0, x_sum_lo)
    rest3_sum = rest3 + rest3_lo
    rest3_sum_right = rest3_sum - rest3
    far_x_sum = far_x + far_x_lo
    far_x_sum_right = far_x_sum - far_x
    closed3 = rest3_sum / far_x_sum
    closed3_product = closed3 * far_x_sum
    closed3_exact = rest3_sum - closed3_product - product_error(closed3, far_x_sum, closed3_product)
    closed3_numerator = (closed3_exact
        + (rest3 - (rest3_sum - rest3_sum_right) + (rest3_lo - rest3_sum_right)))
    series5a = 1.216125041553518e-34 * x_sum
    series5b = 1.1309962886447716e-31 - series5a
    series5b_right = 1.1309962886447716e-31 - series5b
    series5b_lo1 = (1.1309962886447716e-31 - (series5b + series5b_right)
        - product_rest(1.216125041553518e-34, x_sum, series5a, series5b_right))
    series5c = x_sum * series5b
    series5c_cross2 = (x_sum
        * (series5b_lo1 - (5.586290567888806e-51 * x_sum + 1.216125041553518e-34 * x_sum_lo)
        + 1.0498015412959506e-47))
    series5d = series5c - 9.183689863795546e-29
    series5d_right = series5c - series5d
    series5d_lo2 = (product_rest(x_sum, series5b, series5c, series5d + series5d_right)
        - (9.183689863795546e-29 - series5d_right) - 1.4303150396787322e-45)
    series5e = x_sum * series5d
    series5f = series5e + 6.446950284384474e-26
    series5f_right = series5f - series5e
    series5f_lo2 = (product_rest(x_sum, series5d, series5e, series5f - series5f_right)
        + (6.446950284384474e-26 - series5f_right) + -1.9330404233703465e-42)
    series5g = x_sum * series5f
    series5g_cross2 = (x_sum
        * (series5f_lo2
        + (x_sum_lo * series5d + x_sum * (series5d_lo2 + (x_sum_lo * series5b + series5c_cross2)))))
    series5h = series5g - 3.868170170630684e-23
    series5h_right = series5g - series5h
    series5h_lo2 = (product_rest(x_sum, series5f, series5g, series5h + series5h_right)
        - (3.868170170630684e-23 - series5h_right) - -8.843177655482344e-40)
    series5i = x_sum * series5h
    series5j = series5i + 1.9572941063391263e-20
    series5j_right = series5j - series5i
    series5j_lo1 = (product_rest(x_sum, series5h, series5i, series5j - series5j_right)
        + (1.9572941063391263e-20 - series5j_right))
    series5k = x_sum * series5j
    series5j_lo = (series5j_lo1 + -1.3643503830087908e-36
        + (x_sum_lo * series5h + x_sum * (series5h_lo2 + (x_sum_lo * series5f + series5g_cross2))))
    series5l = series5k - 8.22063524662433e-18
    series5l_right = series5k - series5l
    series5l_lo2 = (product_rest(x_sum, series5j, series5k, series5l + series5l_right)
        - (8.22063524662433e-18 - series5l_right) - 2.2141894119604265e-34)
    series5m = x_sum * series5l
    series5n = series5m + 2.8114572543455206e-15
    series5n_right = series5n - series5m
    series5n_lo2 = (product_rest(x_sum, series5l, series5m, series5n - series5n_right)
        + (2.8114572543455206e-15 - series5n_right) + 1.6508842730861433e-31)
    series5o = x_sum * series5n
    series5o_cross2 = (x_sum
        * (series5n_lo2
        + (x_sum_lo * series5l + x_sum
        * (series5l_lo2 + (x_sum_lo * series5j + x_sum * series5j_lo)))))
    series5p = series5o - 7.647163731819816e-13
    series5p_right = series5o - series5p
    series5p_lo2 = (product_rest(x_sum, series5n, series5o, series5p + series5p_right)
        - (7.647163731819816e-13 - series5p_right) - 7.03872877733453e-30)
    series5q = x_sum * series5p
    series5r = series5q + 1.6059043836821613e-10
    series5r_right = series5r - series5q
    series5r_lo2 = (product_rest(x_sum, series5p, series5q, series5r - series5r_right)
        + (1.6059043836821613e-10 - series5r_right) + 1.2585294588752098e-26)
    series5s = x_sum * series5r
    series5s_cross2 = (x_sum
        * (series5r_lo2
        + (x_sum_lo * series5p + x_sum * (series5p_lo2 + (x_sum_lo * series5n + series5o_cross2)))))
    series5t = series5s - 2.505210838544172e-08
    series5t_right = series5s - series5t
    series5t_lo2 = (product_rest(x_sum, series5r, series5s, series5t + series5t_right)
        - (2.505210838544172e-08 - series5t_right) - -1.448814070935912e-24)
    series5u = x_sum * series5t
    series5v = series5u + 2.7557319223985893e-06
    series5v_right = series5v - series5u
    series5v_lo2 = (product_rest(x_sum, series5t, series5u, series5v - series5v_right)
        + (2.7557319223985893e-06 - series5v_right) + -1.858393274046472e-22)
    series5w = x_sum * series5v
    series5w_cross2 = (x_sum
        * (series5v_lo2
        + (x_sum_lo * series5t + x_sum * (series5t_lo2 + (x_sum_lo * series5r + series5s_cross2)))))
    series5x = series5w - 0.0001984126984126984
    series5x_right = series5w - series5x
    series5x_lo2 = (product_rest(x_sum, series5v, series5w, series5x + series5x_right)
        - (0.0001984126984126984 - series5x_right) - 1.7209558293420705e-22)
    series5y = x_sum * series5x
    series5 = series5y + 0.008333333333333333
    series5_right = series5 - series5y
    series5_lo2 = (product_rest(x_sum, series5x, series5y, series5 - series5_right)
        + (0.008333333333333333 - series5_right) + 1.1564823173178714e-19)
    g3a = x_sum * series5
    g3b = 0.16666666666666666 - g3a
    g3b_right = 0.16666666666666666 - g3b
    g3a_cross = (x_sum_lo * series5 + x_sum
        * (series5_lo2
        + (x_sum_lo * series5x + x_sum * (series5x_lo2 + (x_sum_lo * series5v + series5w_cross2)))))
    g3 = where(far_x_a, g3b, closed3)
    g3b_lo = (0.16666666666666666 - (g3b + g3b_right)
        - product_rest(x_sum, series5, g3a, g3b_right) - g3a_cross + 9.25185853854297e-18)
    g3_lo = where(far_x_a, g3b_lo,
        (closed3_numerator - closed3 * (far_x - (far_x_sum - far_x_sum_right) + (far_x_lo -
            far_x_sum_right))) / far_x_sum)
    beta_v_0 = v_0 * g3
    beta_v_1 = v_1 * g3
    beta_v_2 = v_2 * g3
    beta_v_0_lo = product_error(v_0, g3, beta_v_0) + v_0 * g3_lo
    m_0 = v_0 * beta_v_0
    m_0_cross2 = v_0 * beta_v_0_lo
    beta_v_1_lo = product_error(v_1, g3, beta_v_1) + v_1 * g3_lo
    m_1 = v_1 * beta_v_1
    m_1_cross2 = v_1 * beta_v_1_lo
    m_2 = v_2 * beta_v_2
    m_2_cross2 = v_2 * (product_error(v_2, g3, beta_v_2) + v_2 * g3_lo)
    m_3 = v_1 * beta_v_0
    m_3_cross2 = v_1 * beta_v_0_lo
    m_4 = v_2 * beta_v_0
    m_4_cross2 = v_2 * beta_v_0_lo
    m_5 = v_2 * beta_v_1
    m_5_cross2 = v_2 * beta_v_1_lo
    others_0 = m_1 + m_2
    others_0_right = others_0 - m_1
    others_0_lo1 = (product_rest(v_1, beta_v_1, m_1, others_0 - others_0_right)
        + product_rest(v_2, beta_v_2, m_2, others_0_right))
    others_0_lo = others_0_lo1 + (m_1_cross2 + m_2_cross2)
    others_1 = m_0 + m_2
    others_1_right = others_1 - m_0
    others_1_lo1 = (product_rest(v_0, beta_v_0, m_0, others_1 - others_1_right)
        + product_rest(v_2, beta_v_2, m_2, others_1_right))
    others_1_lo = others_1_lo1 + (m_0_cross2 + m_2_cross2)
    others_2 = m_0 + m_1
    others_2_right = others_2 - m_0
    others_2_lo1 = (product_rest(v_0, beta_v_0, m_0, others_2 - others_2_right)
        + product_rest(v_1, beta_v_1, m_1, others_2_right))
    others_2_lo = others_2_lo1 + (m_0_cross2 + m_1_cross2)
    diagonal0a = 1 - others_0
    diagonal0a_right = 1 - diagonal0a
    diagonal0b = g1 + m_0
    diagonal0b_right = diagonal0b - g1
    diagonal0b_lo1 = (product_rest(c, sinc, g1, diagonal0b - diagonal0b_right)
        + product_rest(v_0, beta_v_0, m_0, diagonal0b_right))
    diagonal0c = m_0 + (product_error(v_0, beta_v_0, m_0) + m_0_cross2) < others_0 + others_0_lo
    diagonal0 = where(diagonal0c, diagonal0b, diagonal0a)
    diagonal0a_lo = (1 - (diagonal0a + diagonal0a_right) - (others_0 - diagonal0a_right)
        - others_0_lo)
    diagonal1a = 1 - others_1
    diagonal1a_right = 1 - diagonal1a
    diagonal1b = g1 + m_1
    diagonal1b_right = diagonal1b - g1
    diagonal1b_lo1 = (product_rest(c, sinc, g1, diagonal1b - diagonal1b_right)
        + product_rest(v_1, beta_v_1, m_1, diagonal1b_right))
    diagonal1c = m_1 + (product_error(v_1, beta_v_1, m_1) + m_1_cross2) < others_1 + others_1_lo
    diagonal1 = where(diagonal1c, diagonal1b, diagonal1a)
    diagonal1a_lo = (1 - (diagonal1a + diagonal1a_right) - (others_1 - diagonal1a_right)
        - others_1_lo)
    diagonal2a = 1 - others_2
    diagonal2a_right = 1 - diagonal2a
    diagonal2b = g1 + m_2
    diagonal2b_right = diagonal2b - g1
    diagonal2b_lo1 = (product_rest(c, sinc, g1, diagonal2b - diagonal2b_right)
        + product_rest(v_2, beta_v_2, m_2, diagonal2b_right))
    diagonal2c = m_2 + (product_error(v_2, beta_v_2, m_2) + m_2_cross2) < others_2 + others_2_lo
    diagonal2 = where(diagonal2c, diagonal2b, diagonal2a)
    diagonal2a_lo = (1 - (diagonal2a + diagonal2a_right) - (others_2 - diagonal2a_right)
        - others_2_lo)
    alpha_v_0 = v_0 * g2
    alpha_v_0_cross2 = v_0 * g2_cross2
    alpha_v_1 = v_1 * g2
    alpha_v_1_cross2 = v_1 * g2_cross2
    alpha_v_2 = v_2 * g2
    alpha_v_2_cross2 = v_2 * g2_cross2
    R_01 = m_3 - alpha_v_2
    R_01_right = m_3 - R_01
    R_02 = m_4 + alpha_v_1
    R_02_right = R_02 - m_4
    R_10 = m_3 + alpha_v_2
    R_10_right = R_10 - m_3
    R_12 = m_5 - alpha_v_0
    R_12_right = m_5 - R_12
    R_20 = m_4 - alpha_v_1
    R_20_right = m_4 - R_20
    R_21 = m_5 + alpha_v_0
    R_21_right = R_21 - m_5
    diagonal0_rounded = (diagonal0
        + where(diagonal0c, diagonal0b_lo1 + (g1_cross + m_0_cross2), diagonal0a_lo))
    R_01_lo = (product_rest(v_1, beta_v_0, m_3, R_01 + R_01_right)
        - product_rest(v_2, g2, alpha_v_2, R_01_right) + (m_3_cross2 - alpha_v_2_cross2))
    R_01_rounded = R_01 + R_01_lo
    R_02_lo = (product_rest(v_2, beta_v_0, m_4, R_02 - R_02_right)
        + product_rest(v_1, g2, alpha_v_1, R_02_right) + (m_4_cross2 + alpha_v_1_cross2))
    R_02_rounded = R_02 + R_02_lo
    R_10_lo = (product_rest(v_1, beta_v_0, m_3, R_10 - R_10_right)
        + product_rest(v_2, g2, alpha_v_2, R_10_right) + (m_3_cross2 + alpha_v_2_cross2))
    R_10_rounded = R_10 + R_10_lo
    diagonal1_rounded = (diagonal1
        + where(diagonal1c, diagonal1b_lo1 + (g1_cross + m_1_cross2), diagonal1a_lo))
    R_12_lo = (product_rest(v_2, beta_v_1, m_5, R_12 + R_12_right)
        - product_rest(v_0, g2, alpha_v_0, R_12_right) + (m_5_cross2 - alpha_v_0_cross2))
    R_12_rounded = R_12 + R_12_lo
    R_20_lo = (product_rest(v_2, beta_v_0, m_4, R_20 + R_20_right)
        - product_rest(v_1, g2, alpha_v_1, R_20_right) + (m_4_cross2 - alpha_v_1_cross2))
    R_20_rounded = R_20 + R_20_lo
    R_21_lo = (product_rest(v_2, beta_v_1, m_5, R_21 - R_21_right)
        + product_rest(v_0, g2, alpha_v_0, R_21_right) + (m_5_cross2 + alpha_v_0_cross2))
    R_21_rounded = R_21 + R_21_lo
    diagonal2_rounded = (diagonal2
        + where(diagonal2c, diagonal2b_lo1 + (g1_cross + m_2_cross2), diagonal2a_lo))
    diagonal0_final = where(diagonal0_rounded == diagonal0_rounded, diagonal0_rounded, diagonal0)
    R_01_final = where(R_01_rounded == R_01_rounded, R_01_rounded, R_01)
    R_02_final = where(R_02_rounded == R_02_rounded, R_02_rounded, R_02)
    R_10_final = where(R_10_rounded == R_10_rounded, R_10_rounded, R_10)
    diagonal1_final = where(diagonal1_rounded == diagonal1_rounded, diagonal1_rounded, diagonal1)
    R_12_final = where(R_12_rounded == R_12_rounded, R_12_rounded, R_12)
    R_20_final = where(R_20_rounded == R_20_rounded, R_20_rounded, R_20)
    R_21_final = where(R_21_rounded == R_21_rounded, R_21_rounded, R_21)
    diagonal2_final = where(diagonal2_rounded == diagonal2_rounded, diagonal2_rounded, diagonal2)
    return (diagonal0_final, R_01_final, R_02_final, R_10_final, diagonal1_final, R_12_final,
        R_20_final, R_21_final, diagonal2_final)


@kernel("(3)->(3,3)")
def SO3_rightJacobian(v):
    """R = J_r(v) = I - (1 - cos θ)/θ^2 v~ + (θ - sin θ)/θ^3 v~^2, θ = |v|.

    (3)->(3,3).  v: vector; R: rotation or other 3×3 matrix.
    208 mul, 471 add, 21 product error, 43 product rest, 6 div, 1 sqrt, 9 neg, 4 abs, 6 less, 10
    equal, 25 select.  Error <= R: 1 u of its largest component for |v| <= 1e13, in single
    precision 1e5; searched, not proved.  Each component is within 1 ulp as long as its
    condition is below 1e13; in single precision it is the nearest number, except near ties, as
    long as that is below 1e5; searched, not proved.
    """
    v_0, v_1, v_2 = v
    halved_0 = 0.5 * v_0
    halved_1 = 0.5 * v_1
    halved_2 = 0.5 * v_2
    y_a = halved_0 * halved_0
    y_b = halved_1 * halved_1
    y_c = y_a + y_b
    y_c_right = y_c - y_a
    y_d = halved_2 * halved_2
    y = y_c + y_d
    y_right = y - y_c
    y_c_lo = (product_rest(halved_0, halved_0, y_a, y_c - y_c_right)
        + product_rest(halved_1, halved_1, y_b, y_c_right))
    y_lo = y_c - (y - y_right) + product_rest(halved_2, halved_2, y_d, y_right) + y_c_lo
    y_sum = y + y_lo
    y_sum_right = y_sum - y
    y_sum_lo = y - (y_sum - y_sum_right) + (y_lo - y_sum_right)
    half_angle = sqrt(y_sum)
    half_angle_product = half_angle * half_angle
    half_angle_residual = (y_sum - half_angle_product
        - product_error(half_angle, half_angle, half_angle_product) + y_sum_lo)
    half_angle_lo = half_angle_residual / where(half_angle == 0, 1, half_angle + half_angle)
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
    sinc_a = 0.16666666666666666 * y_sum
    sinc_b = 1 - sinc_a
    sinc_b_right = 1 - sinc_b
    sinc_b_lo1 = (1 - (sinc_b + sinc_b_right)
        - product_rest(0.16666666666666666, y_sum, sinc_a, sinc_b_right))
    sinc = where(sinc_divisor_a, sinc_b, sinc_quotient)
    sinc_quotient_lo = ((sinc_quotient_exact
        + (sine - (sine_sum - sine_sum_right) + (sine_lo - sine_sum_right)) - sinc_quotient_cross)
        / sinc_divisor_sum)
    sinc_lo = where(sinc_divisor_a,
        sinc_b_lo1 - (9.25185853854297e-18 * y_sum + 0.16666666666666666 * y_sum_lo),
        sinc_quotient_lo)
    g1 = c * sinc
    g1_cross = ((c_own_error - (sine_half_cos * sine + sine_half_sin * c) * sine_twice) * sinc + c
        * sinc_lo)
    g2a = sinc * sinc
    g2 = 0.5 * g2a
    g2_cross2 = 0.5 * (product_error(sinc, sinc, g2a) + (sinc_lo * sinc + sinc * sinc_lo))
    rest3 = 1 - g1
    rest3_right = 1 - rest3
    rest3_lo = 1 - (rest3 + rest3_right) - product_rest(c, sinc, g1, rest3_right) - g1_cross
    x = 4 * y_sum
    x_cross2 = 4 * y_sum_lo
    x_sum = x + x_cross2
    x_sum_right = x_sum - x
    x_sum_lo = x - (x_sum - x_sum_right) + (x_cross2 - x_sum_right)
    far_x_a = x_sum < 1
    far_x = where(far_x_a, 1, x_sum)
    far_x_lo = where(far_x_a, 0, x_sum_lo)
    rest3_sum = rest3 + rest3_lo
    rest3_sum_right = rest3_sum - rest3
    far_x_sum = far_x + far_x_lo
    far_x_sum_right = far_x_sum - far_x
    closed3 = rest3_sum / far_x_sum
    closed3_product = closed3 * far_x_sum
    closed3_exact = rest3_sum - closed3_product - product_error(closed3, far_x_sum, closed3_product)
    closed3_numerator = (closed3_exact
        + (rest3 - (rest3_sum - rest3_sum_right) + (rest3_lo - rest3_sum_right)))
    series5a = 1.216125041553518e-34 * x_sum
    series5b = 1.1309962886447716e-31 - series5a
    series5b_right = 1.1309962886447716e-31 - series5b
    series5b_lo1 = (1.1309962886447716e-31 - (series5b + series5b_right)
        - product_rest(1.216125041553518e-34, x_sum, series5a, series5b_right))
    series5c = x_sum * series5b
    series5c_cross2 = (x_sum
        * (series5b_lo1 - (5.586290567888806e-51 * x_sum + 1.216125041553518e-34 * x_sum_lo)
        + 1.0498015412959506e-47))
    series5d = series5c - 9.183689863795546e-29
    series5d_right = series5c - series5d
    series5d_lo2 = (product_rest(x_sum, series5b, series5c, series5d + series5d_right)
        - (9.183689863795546e-29 - series5d_right) - 1.4303150396787322e-45)
    series5e = x_sum * series5d
    series5f = series5e + 6.446950284384474e-26
    series5f_right = series5f - series5e
    series5f_lo2 = (product_rest(x_sum, series5d, series5e, series5f - series5f_right)
        + (6.446950284384474e-26 - series5f_right) + -1.9330404233703465e-42)
    series5g = x_sum * series5f
    series5g_cross2 = (x_sum
        * (series5f_lo2
        + (x_sum_lo * series5d + x_sum * (series5d_lo2 + (x_sum_lo * series5b + series5c_cross2)))))
    series5h = series5g - 3.868170170630684e-23
    series5h_right = series5g - series5h
    series5h_lo2 = (product_rest(x_sum, series5f, series5g, series5h + series5h_right)
        - (3.868170170630684e-23 - series5h_right) - -8.843177655482344e-40)
    series5i = x_sum * series5h
    series5j = series5i + 1.9572941063391263e-20
    series5j_right = series5j - series5i
    series5j_lo1 = (product_rest(x_sum, series5h, series5i, series5j - series5j_right)
        + (1.9572941063391263e-20 - series5j_right))
    series5k = x_sum * series5j
    series5j_lo = (series5j_lo1 + -1.3643503830087908e-36
        + (x_sum_lo * series5h + x_sum * (series5h_lo2 + (x_sum_lo * series5f + series5g_cross2))))
    series5l = series5k - 8.22063524662433e-18
    series5l_right = series5k - series5l
    series5l_lo2 = (product_rest(x_sum, series5j, series5k, series5l + series5l_right)
        - (8.22063524662433e-18 - series5l_right) - 2.2141894119604265e-34)
    series5m = x_sum * series5l
    series5n = series5m + 2.8114572543455206e-15
    series5n_right = series5n - series5m
    series5n_lo2 = (product_rest(x_sum, series5l, series5m, series5n - series5n_right)
        + (2.8114572543455206e-15 - series5n_right) + 1.6508842730861433e-31)
    series5o = x_sum * series5n
    series5o_cross2 = (x_sum
        * (series5n_lo2
        + (x_sum_lo * series5l + x_sum
        * (series5l_lo2 + (x_sum_lo * series5j + x_sum * series5j_lo)))))
    series5p = series5o - 7.647163731819816e-13
    series5p_right = series5o - series5p
    series5p_lo2 = (product_rest(x_sum, series5n, series5o, series5p + series5p_right)
        - (7.647163731819816e-13 - series5p_right) - 7.03872877733453e-30)
    series5q = x_sum * series5p
    series5r = series5q + 1.6059043836821613e-10
    series5r_right = series5r - series5q
    series5r_lo2 = (product_rest(x_sum, series5p, series5q, series5r - series5r_right)
        + (1.6059043836821613e-10 - series5r_right) + 1.2585294588752098e-26)
    series5s = x_sum * series5r
    series5s_cross2 = (x_sum
        * (series5r_lo2
        + (x_sum_lo * series5p + x_sum * (series5p_lo2 + (x_sum_lo * series5n + series5o_cross2)))))
    series5t = series5s - 2.505210838544172e-08
    series5t_right = series5s - series5t
    series5t_lo2 = (product_rest(x_sum, series5r, series5s, series5t + series5t_right)
        - (2.505210838544172e-08 - series5t_right) - -1.448814070935912e-24)
    series5u = x_sum * series5t
    series5v = series5u + 2.7557319223985893e-06
    series5v_right = series5v - series5u
    series5v_lo2 = (product_rest(x_sum, series5t, series5u, series5v - series5v_right)
        + (2.7557319223985893e-06 - series5v_right) + -1.858393274046472e-22)
    series5w = x_sum * series5v
    series5w_cross2 = (x_sum
        * (series5v_lo2
        + (x_sum_lo * series5t + x_sum * (series5t_lo2 + (x_sum_lo * series5r + series5s_cross2)))))
    series5x = series5w - 0.0001984126984126984
    series5x_right = series5w - series5x
    series5x_lo2 = (product_rest(x_sum, series5v, series5w, series5x + series5x_right)
        - (0.0001984126984126984 - series5x_right) - 1.7209558293420705e-22)
    series5y = x_sum * series5x
    series5 = series5y + 0.008333333333333333
    series5_right = series5 - series5y
    series5_lo2 = (product_rest(x_sum, series5x, series5y, series5 - series5_right)
        + (0.008333333333333333 - series5_right) + 1.1564823173178714e-19)
    g3a = x_sum * series5
    g3b = 0.16666666666666666 - g3a
    g3b_right = 0.16666666666666666 - g3b
    g3a_cross = (x_sum_lo * series5 + x_sum
        * (series5_lo2
        + (x_sum_lo * series5x + x_sum * (series5x_lo2 + (x_sum_lo * series5v + series5w_cross2)))))
    g3 = where(far_x_a, g3b, closed3)
    g3b_lo = (0.16666666666666666 - (g3b + g3b_right)
        - product_rest(x_sum, series5, g3a, g3b_right) - g3a_cross + 9.25185853854297e-18)
    g3_lo = where(far_x_a, g3b_lo,
        (closed3_numerator - closed3 * (far_x - (far_x_sum - far_x_sum_right) + (far_x_lo -
            far_x_sum_right))) / far_x_sum)
    beta_v_0 = v_0 * g3
    beta_v_1 = v_1 * g3
    beta_v_2 = v_2 * g3
    beta_v_0_lo = product_error(v_0, g3, beta_v_0) + v_0 * g3_lo
    m_0 = v_0 * beta_v_0
    m_0_cross2 = v_0 * beta_v_0_lo
    beta_v_1_lo = product_error(v_1, g3, beta_v_1) + v_1 * g3_lo
    m_1 = v_1 * beta_v_1
    m_1_cross2 = v_1 * beta_v_1_lo
    m_2 = v_2 * beta_v_2
    m_2_cross2 = v_2 * (product_error(v_2, g3, beta_v_2) + v_2 * g3_lo)
    m_3 = v_1 * beta_v_0
    m_3_cross2 = v_1 * beta_v_0_lo
    m_4 = v_2 * beta_v_0
    m_4_cross2 = v_2 * beta_v_0_lo
    m_5 = v_2 * beta_v_1
    m_5_cross2 = v_2 * beta_v_1_lo
    others_0 = m_1 + m_2
    others_0_right = others_0 - m_1
    others_0_lo1 = (product_rest(v_1, beta_v_1, m_1, others_0 - others_0_right)
        + product_rest(v_2, beta_v_2, m_2, others_0_right))
    others_0_lo = others_0_lo1 + (m_1_cross2 + m_2_cross2)
    others_1 = m_0 + m_2
    others_1_right = others_1 - m_0
    others_1_lo1 = (product_rest(v_0, beta_v_0, m_0, others_1 - others_1_right)
        + product_rest(v_2, beta_v_2, m_2, others_1_right))
    others_1_lo = others_1_lo1 + (m_0_cross2 + m_2_cross2)
    others_2 = m_0 + m_1
    others_2_right = others_2 - m_0
    others_2_lo1 = (product_rest(v_0, beta_v_0, m_0, others_2 - others_2_right)
        + product_rest(v_1, beta_v_1, m_1, others_2_right))
    others_2_lo = others_2_lo1 + (m_0_cross2 + m_1_cross2)
    diagonal0a = 1 - others_0
    diagonal0a_right = 1 - diagonal0a
    diagonal0b = g1 + m_0
    diagonal0b_right = diagonal0b - g1
    diagonal0b_lo1 = (product_rest(c, sinc, g1, diagonal0b - diagonal0b_right)
        + product_rest(v_0, beta_v_0, m_0, diagonal0b_right))
    diagonal0c = m_0 + (product_error(v_0, beta_v_0, m_0) + m_0_cross2) < others_0 + others_0_lo
    diagonal0 = where(diagonal0c, diagonal0b, diagonal0a)
    diagonal0a_lo = (1 - (diagonal0a + diagonal0a_right) - (others_0 - diagonal0a_right)
        - others_0_lo)
    diagonal1a = 1 - others_1
    diagonal1a_right = 1 - diagonal1a
    diagonal1b = g1 + m_1
    diagonal1b_right = diagonal1b - g1
    diagonal1b_lo1 = (product_rest(c, sinc, g1, diagonal1b - diagonal1b_right)
        + product_rest(v_1, beta_v_1, m_1, diagonal1b_right))
    diagonal1c = m_1 + (product_error(v_1, beta_v_1, m_1) + m_1_cross2) < others_1 + others_1_lo
    diagonal1 = where(diagonal1c, diagonal1b, diagonal1a)
    diagonal1a_lo = (1 - (diagonal1a + diagonal1a_right) - (others_1 - diagonal1a_right)
        - others_1_lo)
    diagonal2a = 1 - others_2
    diagonal2a_right = 1 - diagonal2a
    diagonal2b = g1 + m_2
    diagonal2b_right = diagonal2b - g1
    diagonal2b_lo1 = (product_rest(c, sinc, g1, diagonal2b - diagonal2b_right)
        + product_rest(v_2, beta_v_2, m_2, diagonal2b_right))
    diagonal2c = m_2 + (product_error(v_2, beta_v_2, m_2) + m_2_cross2) < others_2 + others_2_lo
    diagonal2 = where(diagonal2c, diagonal2b, diagonal2a)
    diagonal2a_lo = (1 - (diagonal2a + diagonal2a_right) - (others_2 - diagonal2a_right)
        - others_2_lo)
    alpha_v_0 = -(v_0 * g2)
    alpha_v_0_cross = -(v_0 * g2_cross2)
    alpha_v_0_factor = -v_0
    alpha_v_1 = -(v_1 * g2)
    alpha_v_1_cross = -(v_1 * g2_cross2)
    alpha_v_1_factor = -v_1
    alpha_v_2 = -(v_2 * g2)
    alpha_v_2_cross = -(v_2 * g2_cross2)
    alpha_v_2_factor = -v_2
    R_01 = m_3 - alpha_v_2
    R_01_right = m_3 - R_01
    R_01_lo1 = (product_rest(v_1, beta_v_0, m_3, R_01 + R_01_right)
        - product_rest(alpha_v_2_factor, g2, alpha_v_2, R_01_right))
    R_02 = m_4 + alpha_v_1
    R_02_right = R_02 - m_4
    R_02_lo1 = (product_rest(v_2, beta_v_0, m_4, R_02 - R_02_right)
        + product_rest(alpha_v_1_factor, g2, alpha_v_1, R_02_right))
    R_10 = m_3 + alpha_v_2
    R_10_right = R_10 - m_3
    R_10_lo1 = (product_rest(v_1, beta_v_0, m_3, R_10 - R_10_right)
        + product_rest(alpha_v_2_factor, g2, alpha_v_2, R_10_right))
    R_12 = m_5 - alpha_v_0
    R_12_right = m_5 - R_12
    R_12_lo1 = (product_rest(v_2, beta_v_1, m_5, R_12 + R_12_right)
        - product_rest(alpha_v_0_factor, g2, alpha_v_0, R_12_right))
    R_20 = m_4 - alpha_v_1
    R_20_right = m_4 - R_20
    R_20_lo1 = (product_rest(v_2, beta_v_0, m_4, R_20 + R_20_right)
        - product_rest(alpha_v_1_factor, g2, alpha_v_1, R_20_right))
    R_21 = m_5 + alpha_v_0
    R_21_right = R_21 - m_5
    R_21_lo1 = (product_rest(v_2, beta_v_1, m_5, R_21 - R_21_right)
        + product_rest(alpha_v_0_factor, g2, alpha_v_0, R_21_right))
    diagonal0_rounded = (diagonal0
        + where(diagonal0c, diagonal0b_lo1 + (g1_cross + m_0_cross2), diagonal0a_lo))
    R_01_rounded = R_01 + (R_01_lo1 + (m_3_cross2 - alpha_v_2_cross))
    R_02_rounded = R_02 + (R_02_lo1 + (m_4_cross2 + alpha_v_1_cross))
    R_10_rounded = R_10 + (R_10_lo1 + (m_3_cross2 + alpha_v_2_cross))
    diagonal1_rounded = (diagonal1
        + where(diagonal1c, diagonal1b_lo1 + (g1_cross + m_1_cross2), diagonal1a_lo))
    R_12_rounded = R_12 + (R_12_lo1 + (m_5_cross2 - alpha_v_0_cross))
    R_20_rounded = R_20 + (R_20_lo1 + (m_4_cross2 - alpha_v_1_cross))
    R_21_rounded = R_21 + (R_21_lo1 + (m_5_cross2 + alpha_v_0_cross))
    diagonal2_rounded = (diagonal2
        + where(diagonal2c, diagonal2b_lo1 + (g1_cross + m_2_cross2), diagonal2a_lo))
    diagonal0_final = where(diagonal0_rounded == diagonal0_rounded, diagonal0_rounded, diagonal0)
    R_01_final = where(R_01_rounded == R_01_rounded, R_01_rounded, R_01)
    R_02_final = where(R_02_rounded == R_02_rounded, R_02_rounded, R_02)
    R_10_final = where(R_10_rounded == R_10_rounded, R_10_rounded, R_10)
    diagonal1_final = where(diagonal1_rounded == diagonal1_rounded, diagonal1_rounded, diagonal1)
    R_12_final = where(R_12_rounded == R_12_rounded, R_12_rounded, R_12)
    R_20_final = where(R_20_rounded == R_20_rounded, R_20_rounded, R_20)
    R_21_final = where(R_21_rounded == R_21_rounded, R_21_rounded, R_21)
    diagonal2_final = where(diagonal2_rounded == diagonal2_rounded, diagonal2_rounded, diagonal2)
    return (diagonal0_final, R_01_final, R_02_final, R_10_final, diagonal1_final, R_12_final,
        R_20_final, R_21_final, diagonal2_final)


@kernel("(3)->(3,3)")
def SO3_leftJacobianInverse(v):
    """R = J_l(v)^-1 = I - v~/2 + (1 - θ/2 cot θ/2)/θ^2 v~^2, θ = |v|; singular at multiples of 2π
    except 0.

    (3)->(3,3).  v: vector; R: rotation or other 3×3 matrix.
    208 mul, 502 add, 23 product error, 34 product rest, 10 div, 1 sqrt, 3 neg, 4 abs, 6 less,
    10 equal, 25 select.  Error <= R: 1 u of its largest component for |v| <= π; searched, not
    proved.  Each component is within 1 ulp as long as its condition is below 1e13; in single
    precision it is the nearest number, except near ties, as long as that is below 1e5;
    searched, not proved.
    """
    v_0, v_1, v_2 = v
    halved_0 = 0.5 * v_0
    halved_1 = 0.5 * v_1
    halved_2 = 0.5 * v_2
    y_a = halved_0 * halved_0
    y_b = halved_1 * halved_1
    y_c = y_a + y_b
    y_c_right = y_c - y_a
    y_d = halved_2 * halved_2
    y = y_c + y_d
    y_right = y - y_c
    y_c_lo = (product_rest(halved_0, halved_0, y_a, y_c - y_c_right)
        + product_rest(halved_1, halved_1, y_b, y_c_right))
    y_lo = y_c - (y - y_right) + product_rest(halved_2, halved_2, y_d, y_right) + y_c_lo
    y_sum = y + y_lo
    y_sum_right = y_sum - y
    y_sum_lo = y - (y_sum - y_sum_right) + (y_lo - y_sum_right)
    half_angle = sqrt(y_sum)
    half_angle_product = half_angle * half_angle
    half_angle_residual = (y_sum - half_angle_product
        - product_error(half_angle, half_angle, half_angle_product) + y_sum_lo)
    half_angle_lo = half_angle_residual / where(half_angle == 0, 1, half_angle + half_angle)
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
    c_lo = c_own_error - (sine_half_cos * sine + sine_half_sin * c) * sine_twice
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
    sinc_a = 0.16666666666666666 * y_sum
    sinc_b = 1 - sinc_a
    sinc_b_right = 1 - sinc_b
    sinc_b_lo1 = (1 - (sinc_b + sinc_b_right)
        - product_rest(0.16666666666666666, y_sum, sinc_a, sinc_b_right))
    sinc = where(sinc_divisor_a, sinc_b, sinc_quotient)
    sinc_quotient_lo = ((sinc_quotient_exact
        + (sine - (sine_sum - sine_sum_right) + (sine_lo - sine_sum_right)) - sinc_quotient_cross)
        / sinc_divisor_sum)
    sinc_lo = where(sinc_divisor_a,
        sinc_b_lo1 - (9.25185853854297e-18 * y_sum + 0.16666666666666666 * y_sum_lo),
        sinc_quotient_lo)
    series_phi_a = 5.107725174524775e-32 * y_sum
    series_phi_b = 4.116826490666969e-29 - series_phi_a
    series_phi_b_right = 4.116826490666969e-29 - series_phi_b
    series_phi_b_right_rest = product_rest(5.107725174524775e-32, y_sum, series_phi_a,
        series_phi_b_right)
    series_phi_b_lo1 = (4.116826490666969e-29 - (series_phi_b + series_phi_b_right)
        - series_phi_b_right_rest)
    series_phi_c = y_sum * series_phi_b
    series_phi_c_cross2 = (y_sum
        * (series_phi_b_lo1 - (4.7410392187559056e-48 * y_sum + 5.107725174524775e-32 * y_sum_lo) +
        -1.8714974010023092e-45))
    series_phi_d = series_phi_c - 2.86531123750421e-26
    series_phi_d_right = series_phi_c - series_phi_d
    series_phi_d_lo1 = (product_rest(y_sum, series_phi_b, series_phi_c, series_phi_d
        + series_phi_d_right) - (2.86531123750421e-26 - series_phi_d_right))
    series_phi_e = y_sum * series_phi_d
    series_phi_f = series_phi_e + 1.701994875077501e-23
    series_phi_f_right = series_phi_f - series_phi_e
    series_phi_f_lo1 = (product_rest(y_sum, series_phi_d, series_phi_e, series_phi_f
        - series_phi_f_right) + (1.701994875077501e-23 - series_phi_f_right))
    series_phi_e_cross = (y_sum_lo * series_phi_d + y_sum
        * (series_phi_d_lo1 - 2.3296034284323186e-42
        + (y_sum_lo * series_phi_b + series_phi_c_cross2)))
    series_phi_g = y_sum * series_phi_f
    series_phi_h = series_phi_g - 8.509974375387505e-21
    series_phi_h_right = series_phi_g - series_phi_h
    series_phi_h_lo1 = (product_rest(y_sum, series_phi_f, series_phi_g, series_phi_h
        + series_phi_h_right) - (8.509974375387505e-21 - series_phi_h_right))
    series_phi_g_cross = (y_sum_lo * series_phi_f + y_sum
        * (series_phi_f_lo1 + 3.161967936521494e-40 + series_phi_e_cross))
    series_phi_i = y_sum * series_phi_h
    series_phi_j = series_phi_i + 3.523129391410427e-18
    series_phi_j_right = series_phi_j - series_phi_i
    series_phi_j_lo1 = (product_rest(y_sum, series_phi_h, series_phi_i, series_phi_j
        - series_phi_j_right) + (3.523129391410427e-18 - series_phi_j_right))
    series_phi_i_cross = (y_sum_lo * series_phi_h + y_sum
        * (series_phi_h_lo1 - 3.2266760594119493e-37 + series_phi_g_cross))
    series_phi_k = y_sum * series_phi_j
    series_phi_l = series_phi_k - 1.1837714755139035e-15
    series_phi_l_right = series_phi_k - series_phi_l
    series_phi_l_lo1 = (product_rest(y_sum, series_phi_j, series_phi_k, series_phi_l
        + series_phi_l_right) - (1.1837714755139035e-15 - series_phi_l_right))
    series_phi_k_cross = (y_sum_lo * series_phi_j + y_sum
        * (series_phi_j_lo1 + -1.2521244741738012e-34 + series_phi_i_cross))
    series_phi_m = y_sum * series_phi_l
    series_phi_n = series_phi_m + 3.148832124866983e-13
    series_phi_n_right = series_phi_n - series_phi_m
    series_phi_n_lo1 = (product_rest(y_sum, series_phi_l, series_phi_m, series_phi_n
        - series_phi_n_right) + (3.148832124866983e-13 - series_phi_n_right))
    series_phi_m_cross = (y_sum_lo * series_phi_l + y_sum
        * (series_phi_l_lo1 - 7.23242424407352e-33 + series_phi_k_cross))
    series_phi_o = y_sum * series_phi_n
    series_phi_p = series_phi_o - 6.423617534728645e-11
    series_phi_p_right = series_phi_o - series_phi_p
    series_phi_p_lo1 = (product_rest(y_sum, series_phi_n, series_phi_o, series_phi_p
        + series_phi_p_right) - (6.423617534728645e-11 - series_phi_p_right))
    series_phi_o_cross = (y_sum_lo * series_phi_n + y_sum
        * (series_phi_n_lo1 + 5.8681293750286156e-30 + series_phi_m_cross))
    series_phi_q = y_sum * series_phi_p
    series_phi_r = series_phi_q + 9.635426302092969e-09
    series_phi_r_right = series_phi_r - series_phi_q
    series_phi_r_lo1 = (product_rest(y_sum, series_phi_p, series_phi_q, series_phi_r
        - series_phi_r_right) + (9.635426302092969e-09 - series_phi_r_right))
    series_phi_q_cross = (y_sum_lo * series_phi_p + y_sum
        * (series_phi_p_lo1 - 5.034117835500839e-27 + series_phi_o_cross))
    series_phi_s = y_sum * series_phi_r
    series_phi_t = series_phi_s - 1.0020843354176687e-06
    series_phi_t_right = series_phi_s - series_phi_t
    series_phi_t_lo1 = (product_rest(y_sum, series_phi_r, series_phi_s, series_phi_t
        + series_phi_t_right) - (1.0020843354176687e-06 - series_phi_t_right))
    series_phi_s_cross = (y_sum_lo * series_phi_r + y_sum
        * (series_phi_r_lo1 + -1.7546051379703029e-25 + series_phi_q_cross))
    series_phi_u = y_sum * series_phi_t
    series_phi_v = series_phi_u + 6.613756613756614e-05
    series_phi_v_right = series_phi_v - series_phi_u
    series_phi_v_lo1 = (product_rest(y_sum, series_phi_t, series_phi_u, series_phi_v
        - series_phi_v_right) + (6.613756613756614e-05 - series_phi_v_right))
    series_phi_u_cross = (y_sum_lo * series_phi_t + y_sum
        * (series_phi_t_lo1 - 4.7926555569351065e-23 + series_phi_s_cross))
    series_phi_w = y_sum * series_phi_v
    series_phi_x = series_phi_w - 0.002380952380952381
    series_phi_x_right = series_phi_w - series_phi_x
    series_phi_x_lo1 = (product_rest(y_sum, series_phi_v, series_phi_w, series_phi_x
        + series_phi_x_right) - (0.002380952380952381 - series_phi_x_right))
    series_phi_w_cross = (y_sum_lo * series_phi_v + y_sum
        * (series_phi_v_lo1 + -4.460143857711533e-21 + series_phi_u_cross))
    series_phi_y = y_sum * series_phi_x
    series_phi = series_phi_y + 0.03333333333333333
    series_phi_right = series_phi - series_phi_y
    series_phi_lo1 = (product_rest(y_sum, series_phi_x, series_phi_y, series_phi
        - series_phi_right) + (0.03333333333333333 - series_phi_right))
    series_phi_y_cross = (y_sum_lo * series_phi_x + y_sum
        * (series_phi_x_lo1 - -2.147752875018904e-19 + series_phi_w_cross))
    f_more_a = 2 * y_sum
    f_more = f_more_a * series_phi
    near_f_a = 0.3333333333333333 * sinc
    f_more_cross = (2 * y_sum_lo * series_phi + f_more_a
        * (series_phi_lo1 + 4.625929269271486e-19 + series_phi_y_cross))
    near_f_b = 0.3333333333333333 * f_more
    near_f = near_f_a + near_f_b
    near_f_right = near_f - near_f_a
    near_f_b_cross = (1.850371707708594e-17 * f_more + 0.3333333333333333
        * (product_error(f_more_a, series_phi, f_more) + f_more_cross))
    near_f_left_rest = product_rest(0.3333333333333333, sinc, near_f_a, near_f - near_f_right)
    near_f_lo1 = near_f_left_rest + product_rest(0.3333333333333333, f_more, near_f_b, near_f_right)
    f_rest = sinc - c
    f_rest_right = sinc - f_rest
    f_rest_lo = sinc - (f_rest + f_rest_right) - (c - f_rest_right) - c_lo + sinc_lo
    x = 4 * y_sum
    far_y_a = x + 4 * y_sum_lo < 4
    far_y = where(far_y_a, 1, y_sum)
    far_y_lo = where(far_y_a, 0, y_sum_lo)
    f_rest_sum = f_rest + f_rest_lo
    f_rest_sum_right = f_rest_sum - f_rest
    far_y_sum = far_y + far_y_lo
    far_y_sum_right = far_y_sum - far_y
    closed_f = f_rest_sum / far_y_sum
    closed_f_product = closed_f * far_y_sum
    closed_f_exact = (f_rest_sum - closed_f_product
        - product_error(closed_f, far_y_sum, closed_f_product))
    closed_f_numerator = (closed_f_exact
        + (f_rest - (f_rest_sum - f_rest_sum_right) + (f_rest_lo - f_rest_sum_right)))
    f = where(far_y_a, near_f, closed_f)
    closed_f_lo = ((closed_f_numerator - closed_f
        * (far_y - (far_y_sum - far_y_sum_right) + (far_y_lo - far_y_sum_right))) / far_y_sum)
    f_lo = where(far_y_a,
        near_f_lo1 + (1.850371707708594e-17 * sinc + 0.3333333333333333 * sinc_lo + near_f_b_cross),
        closed_f_lo)
    four_k = 4 * sinc
    four_k_cross2 = 4 * sinc_lo
    f_sum = f + f_lo
    f_sum_right = f_sum - f
    four_k_sum = four_k + four_k_cross2
    four_k_sum_right = four_k_sum - four_k
    b = f_sum / four_k_sum
    b_product = b * four_k_sum
    b_numerator = (f_sum - b_product - product_error(b, four_k_sum, b_product)
        + (f - (f_sum - f_sum_right) + (f_lo - f_sum_right)))
    b_lo = ((b_numerator - b
        * (four_k - (four_k_sum - four_k_sum_right) + (four_k_cross2 - four_k_sum_right)))
        / four_k_sum)
    c_sum = c + c_lo
    c_sum_right = c_sum - c
    sinc_sum = sinc + sinc_lo
    sinc_sum_right = sinc_sum - sinc
    b_across = c_sum / sinc_sum
    b_across_product = b_across * sinc_sum
    b_across_exact = c_sum - b_across_product - product_error(b_across, sinc_sum, b_across_product)
    b_across_cross = b_across * (sinc - (sinc_sum - sinc_sum_right) + (sinc_lo - sinc_sum_right))
    b_across_lo = ((b_across_exact + (c - (c_sum - c_sum_right) + (c_lo - c_sum_right))
        - b_across_cross) / sinc_sum)
    beta_v_0 = v_0 * b
    beta_v_1 = v_1 * b
    beta_v_2 = v_2 * b
    beta_v_0_lo = product_error(v_0, b, beta_v_0) + v_0 * b_lo
    m_0 = v_0 * beta_v_0
    m_0_cross2 = v_0 * beta_v_0_lo
    beta_v_1_lo = product_error(v_1, b, beta_v_1) + v_1 * b_lo
    m_1 = v_1 * beta_v_1
    m_1_cross2 = v_1 * beta_v_1_lo
    m_2 = v_2 * beta_v_2
    m_2_cross2 = v_2 * (product_error(v_2, b, beta_v_2) + v_2 * b_lo)
    m_3 = v_1 * beta_v_0
    m_3_cross2 = v_1 * beta_v_0_lo
    m_4 = v_2 * beta_v_0
    m_4_cross2 = v_2 * beta_v_0_lo
    m_5 = v_2 * beta_v_1
    m_5_cross2 = v_2 * beta_v_1_lo
    others_0 = m_1 + m_2
    others_0_right = others_0 - m_1
    others_0_lo1 = (product_rest(v_1, beta_v_1, m_1, others_0 - others_0_right)
        + product_rest(v_2, beta_v_2, m_2, others_0_right))
    others_0_lo = others_0_lo1 + (m_1_cross2 + m_2_cross2)
    others_1 = m_0 + m_2
    others_1_right = others_1 - m_0
    others_1_lo1 = (product_rest(v_0, beta_v_0, m_0, others_1 - others_1_right)
        + product_rest(v_2, beta_v_2, m_2, others_1_right))
    others_1_lo = others_1_lo1 + (m_0_cross2 + m_2_cross2)
    others_2 = m_0 + m_1
    others_2_right = others_2 - m_0
    others_2_lo1 = (product_rest(v_0, beta_v_0, m_0, others_2 - others_2_right)
        + product_rest(v_1, beta_v_1, m_1, others_2_right))
    others_2_lo = others_2_lo1 + (m_0_cross2 + m_1_cross2)
    diagonal0a = 1 - others_0
    diagonal0a_right = 1 - diagonal0a
    diagonal0b = b_across + m_0
    diagonal0b_right = diagonal0b - b_across
    diagonal0c = m_0 + (product_error(v_0, beta_v_0, m_0) + m_0_cross2) < others_0 + others_0_lo
    diagonal0 = where(diagonal0c, diagonal0b, diagonal0a)
    diagonal0b_lo = (b_across - (diagonal0b - diagonal0b_right)
        + product_rest(v_0, beta_v_0, m_0, diagonal0b_right) + m_0_cross2 + b_across_lo)
    diagonal1a = 1 - others_1
    diagonal1a_right = 1 - diagonal1a
    diagonal1b = b_across + m_1
    diagonal1b_right = diagonal1b - b_across
    diagonal1c = m_1 + (product_error(v_1, beta_v_1, m_1) + m_1_cross2) < others_1 + others_1_lo
    diagonal1 = where(diagonal1c, diagonal1b, diagonal1a)
    diagonal1b_lo = (b_across - (diagonal1b - diagonal1b_right)
        + product_rest(v_1, beta_v_1, m_1, diagonal1b_right) + m_1_cross2 + b_across_lo)
    diagonal2a = 1 - others_2
    diagonal2a_right = 1 - diagonal2a
    diagonal2b = b_across + m_2
    diagonal2b_right = diagonal2b - b_across
    diagonal2c = m_2 + (product_error(v_2, beta_v_2, m_2) + m_2_cross2) < others_2 + others_2_lo
    diagonal2 = where(diagonal2c, diagonal2b, diagonal2a)
    diagonal2b_lo = (b_across - (diagonal2b - diagonal2b_right)
        + product_rest(v_2, beta_v_2, m_2, diagonal2b_right) + m_2_cross2 + b_across_lo)
    alpha_v_0 = -halved_0
    alpha_v_1 = -halved_1
    alpha_v_2 = -halved_2
    R_01 = m_3 - alpha_v_2
    R_01_right = m_3 - R_01
    R_02 = m_4 + alpha_v_1
    R_02_right = R_02 - m_4
    R_10 = m_3 + alpha_v_2
    R_10_right = R_10 - m_3
    R_12 = m_5 - alpha_v_0
    R_12_right = m_5 - R_12
    R_20 = m_4 - alpha_v_1
    R_20_right = m_4 - R_20
    R_21 = m_5 + alpha_v_0
    R_21_right = R_21 - m_5
    diagonal0_rounded = (diagonal0
        + where(diagonal0c, diagonal0b_lo, 1 - (diagonal0a + diagonal0a_right)
        - (others_0 - diagonal0a_right) - others_0_lo))
    R_01_rounded = (R_01
        + (product_rest(v_1, beta_v_0, m_3, R_01 + R_01_right) - (alpha_v_2 - R_01_right)
        + m_3_cross2))
    R_02_rounded = (R_02
        + (product_rest(v_2, beta_v_0, m_4, R_02 - R_02_right) + (alpha_v_1 - R_02_right)
        + m_4_cross2))
    R_10_rounded = (R_10
        + (product_rest(v_1, beta_v_0, m_3, R_10 - R_10_right) + (alpha_v_2 - R_10_right)
        + m_3_cross2))
    diagonal1_rounded = (diagonal1
        + where(diagonal1c, diagonal1b_lo, 1 - (diagonal1a + diagonal1a_right)
        - (others_1 - diagonal1a_right) - others_1_lo))
    R_12_rounded = (R_12
        + (product_rest(v_2, beta_v_1, m_5, R_12 + R_12_right) - (alpha_v_0 - R_12_right)
        + m_5_cross2))
    R_20_rounded = (R_20
        + (product_rest(v_2, beta_v_0, m_4, R_20 + R_20_right) - (alpha_v_1 - R_20_right)
        + m_4_cross2))
    R_21_rounded = (R_21
        + (product_rest(v_2, beta_v_1, m_5, R_21 - R_21_right) + (alpha_v_0 - R_21_right)
        + m_5_cross2))
    diagonal2_rounded = (diagonal2
        + where(diagonal2c, diagonal2b_lo, 1 - (diagonal2a + diagonal2a_right)
        - (others_2 - diagonal2a_right) - others_2_lo))
    diagonal0_final = where(diagonal0_rounded == diagonal0_rounded, diagonal0_rounded, diagonal0)
    R_01_final = where(R_01_rounded == R_01_rounded, R_01_rounded, R_01)
    R_02_final = where(R_02_rounded == R_02_rounded, R_02_rounded, R_02)
    R_10_final = where(R_10_rounded == R_10_rounded, R_10_rounded, R_10)
    diagonal1_final = where(diagonal1_rounded == diagonal1_rounded, diagonal1_rounded, diagonal1)
    R_12_final = where(R_12_rounded == R_12_rounded, R_12_rounded, R_12)
    R_20_final = where(R_20_rounded == R_20_rounded, R_20_rounded, R_20)
    R_21_final = where(R_21_rounded == R_21_rounded, R_21_rounded, R_21)
    diagonal2_final = where(diagonal2_rounded == diagonal2_rounded, diagonal2_rounded, diagonal2)
    return (diagonal0_final, R_01_final, R_02_final, R_10_final, diagonal1_final, R_12_final,
        R_20_final, R_21_final, diagonal2_final)


@kernel("(3)->(3,3)")
def SO3_rightJacobianInverse(v):
    """R = J_r(v)^-1 = I + v~/2 + (1 - θ/2 cot θ/2)/θ^2 v~^2, θ = |v|; singular at multiples of 2π
    except 0.

    (3)->(3,3).  v: vector; R: rotation or other 3×3 matrix.
    208 mul, 502 add, 23 product error, 34 product rest, 10 div, 1 sqrt, 4 abs, 6 less, 10
    equal, 25 select.  Error <= R: 1 u of its largest component for |v| <= π; searched, not
    proved.  Each component is within 1 ulp as long as its condition is below 1e13; in single
    precision it is the nearest number, except near ties, as long as that is below 1e5;
    searched, not proved.
    """
    v_0, v_1, v_2 = v
    halved_0 = 0.5 * v_0
    halved_1 = 0.5 * v_1
    halved_2 = 0.5 * v_2
    y_a = halved_0 * halved_0
    y_b = halved_1 * halved_1
    y_c = y_a + y_b
    y_c_right = y_c - y_a
    y_d = halved_2 * halved_2
    y = y_c + y_d
    y_right = y - y_c
    y_c_lo = (product_rest(halved_0, halved_0, y_a, y_c - y_c_right)
        + product_rest(halved_1, halved_1, y_b, y_c_right))
    y_lo = y_c - (y - y_right) + product_rest(halved_2, halved_2, y_d, y_right) + y_c_lo
    y_sum = y + y_lo
    y_sum_right = y_sum - y
    y_sum_lo = y - (y_sum - y_sum_right) + (y_lo - y_sum_right)
    half_angle = sqrt(y_sum)
    half_angle_product = half_angle * half_angle
    half_angle_residual = (y_sum - half_angle_product
        - product_error(half_angle, half_angle, half_angle_product) + y_sum_lo)
    half_angle_lo = half_angle_residual / where(half_angle == 0, 1, half_angle + half_angle)
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
    c_lo = c_own_error - (sine_half_cos * sine + sine_half_sin * c) * sine_twice
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
    sinc_a = 0.16666666666666666 * y_sum
    sinc_b = 1 - sinc_a
    sinc_b_right = 1 - sinc_b
    sinc_b_lo1 = (1 - (sinc_b + sinc_b_right)
        - product_rest(0.16666666666666666, y_sum, sinc_a, sinc_b_right))
    sinc = where(sinc_divisor_a, sinc_b, sinc_quotient)
    sinc_quotient_lo = ((sinc_quotient_exact
        + (sine - (sine_sum - sine_sum_right) + (sine_lo - sine_sum_right)) - sinc_quotient_cross)
        / sinc_divisor_sum)
    sinc_lo = where(sinc_divisor_a,
        sinc_b_lo1 - (9.25185853854297e-18 * y_sum + 0.16666666666666666 * y_sum_lo),
        sinc_quotient_lo)
    series_phi_a = 5.107725174524775e-32 * y_sum
    series_phi_b = 4.116826490666969e-29 - series_phi_a
    series_phi_b_right = 4.116826490666969e-29 - series_phi_b
    series_phi_b_right_rest = product_rest(5.107725174524775e-32, y_sum, series_phi_a,
        series_phi_b_right)
    series_phi_b_lo1 = (4.116826490666969e-29 - (series_phi_b + series_phi_b_right)
        - series_phi_b_right_rest)
    series_phi_c = y_sum * series_phi_b
    series_phi_c_cross2 = (y_sum
        * (series_phi_b_lo1 - (4.7410392187559056e-48 * y_sum + 5.107725174524775e-32 * y_sum_lo) +
        -1.8714974010023092e-45))
    series_phi_d = series_phi_c - 2.86531123750421e-26
    series_phi_d_right = series_phi_c - series_phi_d
    series_phi_d_lo1 = (product_rest(y_sum, series_phi_b, series_phi_c, series_phi_d
        + series_phi_d_right) - (2.86531123750421e-26 - series_phi_d_right))
    series_phi_e = y_sum * series_phi_d
    series_phi_f = series_phi_e + 1.701994875077501e-23
    series_phi_f_right = series_phi_f - series_phi_e
    series_phi_f_lo1 = (product_rest(y_sum, series_phi_d, series_phi_e, series_phi_f
        - series_phi_f_right) + (1.701994875077501e-23 - series_phi_f_right))
    series_phi_e_cross = (y_sum_lo * series_phi_d + y_sum
        * (series_phi_d_lo1 - 2.3296034284323186e-42
        + (y_sum_lo * series_phi_b + series_phi_c_cross2)))
    series_phi_g = y_sum * series_phi_f
    series_phi_h = series_phi_g - 8.509974375387505e-21
    series_phi_h_right = series_phi_g - series_phi_h
    series_phi_h_lo1 = (product_rest(y_sum, series_phi_f, series_phi_g, series_phi_h
        + series_phi_h_right) - (8.509974375387505e-21 - series_phi_h_right))
    series_phi_g_cross = (y_sum_lo * series_phi_f + y_sum
        * (series_phi_f_lo1 + 3.161967936521494e-40 + series_phi_e_cross))
    series_phi_i = y_sum * series_phi_h
    series_phi_j = series_phi_i + 3.523129391410427e-18
    series_phi_j_right = series_phi_j - series_phi_i
    series_phi_j_lo1 = (product_rest(y_sum, series_phi_h, series_phi_i, series_phi_j
        - series_phi_j_right) + (3.523129391410427e-18 - series_phi_j_right))
    series_phi_i_cross = (y_sum_lo * series_phi_h + y_sum
        * (series_phi_h_lo1 - 3.2266760594119493e-37 + series_phi_g_cross))
    series_phi_k = y_sum * series_phi_j
    series_phi_l = series_phi_k - 1.1837714755139035e-15
    series_phi_l_right = series_phi_k - series_phi_l
    series_phi_l_lo1 = (product_rest(y_sum, series_phi_j, series_phi_k, series_phi_l
        + series_phi_l_right) - (1.1837714755139035e-15 - series_phi_l_right))
    series_phi_k_cross = (y_sum_lo * series_phi_j + y_sum
        * (series_phi_j_lo1 + -1.2521244741738012e-34 + series_phi_i_cross))
    series_phi_m = y_sum * series_phi_l
    series_phi_n = series_phi_m + 3.148832124866983e-13
    series_phi_n_right = series_phi_n - series_phi_m
    series_phi_n_lo1 = (product_rest(y_sum, series_phi_l, series_phi_m, series_phi_n
        - series_phi_n_right) + (3.148832124866983e-13 - series_phi_n_right))
    series_phi_m_cross = (y_sum_lo * series_phi_l + y_sum
        * (series_phi_l_lo1 - 7.23242424407352e-33 + series_phi_k_cross))
    series_phi_o = y_sum * series_phi_n
    series_phi_p = series_phi_o - 6.423617534728645e-11
    series_phi_p_right = series_phi_o - series_phi_p
    series_phi_p_lo1 = (product_rest(y_sum, series_phi_n, series_phi_o, series_phi_p
        + series_phi_p_right) - (6.423617534728645e-11 - series_phi_p_right))
    series_phi_o_cross = (y_sum_lo * series_phi_n + y_sum
        * (series_phi_n_lo1 + 5.8681293750286156e-30 + series_phi_m_cross))
    series_phi_q = y_sum * series_phi_p
    series_phi_r = series_phi_q + 9.635426302092969e-09
    series_phi_r_right = series_phi_r - series_phi_q
    series_phi_r_lo1 = (product_rest(y_sum, series_phi_p, series_phi_q, series_phi_r
        - series_phi_r_right) + (9.635426302092969e-09 - series_phi_r_right))
    series_phi_q_cross = (y_sum_lo * series_phi_p + y_sum
        * (series_phi_p_lo1 - 5.034117835500839e-27 + series_phi_o_cross))
    series_phi_s = y_sum * series_phi_r
    series_phi_t = series_phi_s - 1.0020843354176687e-06
    series_phi_t_right = series_phi_s - series_phi_t
    series_phi_t_lo1 = (product_rest(y_sum, series_phi_r, series_phi_s, series_phi_t
        + series_phi_t_right) - (1.0020843354176687e-06 - series_phi_t_right))
    series_phi_s_cross = (y_sum_lo * series_phi_r + y_sum
        * (series_phi_r_lo1 + -1.7546051379703029e-25 + series_phi_q_cross))
    series_phi_u = y_sum * series_phi_t
    series_phi_v = series_phi_u + 6.613756613756614e-05
    series_phi_v_right = series_phi_v - series_phi_u
    series_phi_v_lo1 = (product_rest(y_sum, series_phi_t, series_phi_u, series_phi_v
        - series_phi_v_right) + (6.613756613756614e-05 - series_phi_v_right))
    series_phi_u_cross = (y_sum_lo * series_phi_t + y_sum
        * (series_phi_t_lo1 - 4.7926555569351065e-23 + series_phi_s_cross))
    series_phi_w = y_sum * series_phi_v
    series_phi_x = series_phi_w - 0.002380952380952381
    series_phi_x_right = series_phi_w - series_phi_x
    series_phi_x_lo1 = (product_rest(y_sum, series_phi_v, series_phi_w, series_phi_x
        + series_phi_x_right) - (0.002380952380952381 - series_phi_x_right))
    series_phi_w_cross = (y_sum_lo * series_phi_v + y_sum
        * (series_phi_v_lo1 + -4.460143857711533e-21 + series_phi_u_cross))
    series_phi_y = y_sum * series_phi_x
    series_phi = series_phi_y + 0.03333333333333333
    series_phi_right = series_phi - series_phi_y
    series_phi_lo1 = (product_rest(y_sum, series_phi_x, series_phi_y, series_phi
        - series_phi_right) + (0.03333333333333333 - series_phi_right))
    series_phi_y_cross = (y_sum_lo * series_phi_x + y_sum
        * (series_phi_x_lo1 - -2.147752875018904e-19 + series_phi_w_cross))
    f_more_a = 2 * y_sum
    f_more = f_more_a * series_phi
    near_f_a = 0.3333333333333333 * sinc
    f_more_cross = (2 * y_sum_lo * series_phi + f_more_a
        * (series_phi_lo1 + 4.625929269271486e-19 + series_phi_y_cross))
    near_f_b = 0.3333333333333333 * f_more
    near_f = near_f_a + near_f_b
    near_f_right = near_f - near_f_a
    near_f_b_cross = (1.850371707708594e-17 * f_more + 0.3333333333333333
        * (product_error(f_more_a, series_phi, f_more) + f_more_cross))
    near_f_left_rest = product_rest(0.3333333333333333, sinc, near_f_a, near_f - near_f_right)
    near_f_lo1 = near_f_left_rest + product_rest(0.3333333333333333, f_more, near_f_b, near_f_right)
    f_rest = sinc - c
    f_rest_right = sinc - f_rest
    f_rest_lo = sinc - (f_rest + f_rest_right) - (c - f_rest_right) - c_lo + sinc_lo
    x = 4 * y_sum
    far_y_a = x + 4 * y_sum_lo < 4
    far_y = where(far_y_a, 1, y_sum)
    far_y_lo = where(far_y_a, 0, y_sum_lo)
    f_rest_sum = f_rest + f_rest_lo
    f_rest_sum_right = f_rest_sum - f_rest
    far_y_sum = far_y + far_y_lo
    far_y_sum_right = far_y_sum - far_y
    closed_f = f_rest_sum / far_y_sum
    closed_f_product = closed_f * far_y_sum
    closed_f_exact = (f_rest_sum - closed_f_product
        - product_error(closed_f, far_y_sum, closed_f_product))
    closed_f_numerator = (closed_f_exact
        + (f_rest - (f_rest_sum - f_rest_sum_right) + (f_rest_lo - f_rest_sum_right)))
    f = where(far_y_a, near_f, closed_f)
    closed_f_lo = ((closed_f_numerator - closed_f
        * (far_y - (far_y_sum - far_y_sum_right) + (far_y_lo - far_y_sum_right))) / far_y_sum)
    f_lo = where(far_y_a,
        near_f_lo1 + (1.850371707708594e-17 * sinc + 0.3333333333333333 * sinc_lo + near_f_b_cross),
        closed_f_lo)
    four_k = 4 * sinc
    four_k_cross2 = 4 * sinc_lo
    f_sum = f + f_lo
    f_sum_right = f_sum - f
    four_k_sum = four_k + four_k_cross2
    four_k_sum_right = four_k_sum - four_k
    b = f_sum / four_k_sum
    b_product = b * four_k_sum
    b_numerator = (f_sum - b_product - product_error(b, four_k_sum, b_product)
        + (f - (f_sum - f_sum_right) + (f_lo - f_sum_right)))
    b_lo = ((b_numerator - b
        * (four_k - (four_k_sum - four_k_sum_right) + (four_k_cross2 - four_k_sum_right)))
        / four_k_sum)
    c_sum = c + c_lo
    c_sum_right = c_sum - c
    sinc_sum = sinc + sinc_lo
    sinc_sum_right = sinc_sum - sinc
    b_across = c_sum / sinc_sum
    b_across_product = b_across * sinc_sum
    b_across_exact = c_sum - b_across_product - product_error(b_across, sinc_sum, b_across_product)
    b_across_cross = b_across * (sinc - (sinc_sum - sinc_sum_right) + (sinc_lo - sinc_sum_right))
    b_across_lo = ((b_across_exact + (c - (c_sum - c_sum_right) + (c_lo - c_sum_right))
        - b_across_cross) / sinc_sum)
    beta_v_0 = v_0 * b
    beta_v_1 = v_1 * b
    beta_v_2 = v_2 * b
    beta_v_0_lo = product_error(v_0, b, beta_v_0) + v_0 * b_lo
    m_0 = v_0 * beta_v_0
    m_0_cross2 = v_0 * beta_v_0_lo
    beta_v_1_lo = product_error(v_1, b, beta_v_1) + v_1 * b_lo
    m_1 = v_1 * beta_v_1
    m_1_cross2 = v_1 * beta_v_1_lo
    m_2 = v_2 * beta_v_2
    m_2_cross2 = v_2 * (product_error(v_2, b, beta_v_2) + v_2 * b_lo)
    m_3 = v_1 * beta_v_0
    m_3_cross2 = v_1 * beta_v_0_lo
    m_4 = v_2 * beta_v_0
    m_4_cross2 = v_2 * beta_v_0_lo
    m_5 = v_2 * beta_v_1
    m_5_cross2 = v_2 * beta_v_1_lo
    others_0 = m_1 + m_2
    others_0_right = others_0 - m_1
    others_0_lo1 = (product_rest(v_1, beta_v_1, m_1, others_0 - others_0_right)
        + product_rest(v_2, beta_v_2, m_2, others_0_right))
    others_0_lo = others_0_lo1 + (m_1_cross2 + m_2_cross2)
    others_1 = m_0 + m_2
    others_1_right = others_1 - m_0
    others_1_lo1 = (product_rest(v_0, beta_v_0, m_0, others_1 - others_1_right)
        + product_rest(v_2, beta_v_2, m_2, others_1_right))
    others_1_lo = others_1_lo1 + (m_0_cross2 + m_2_cross2)
    others_2 = m_0 + m_1
    others_2_right = others_2 - m_0
    others_2_lo1 = (product_rest(v_0, beta_v_0, m_0, others_2 - others_2_right)
        + product_rest(v_1, beta_v_1, m_1, others_2_right))
    others_2_lo = others_2_lo1 + (m_0_cross2 + m_1_cross2)
    diagonal0a = 1 - others_0
    diagonal0a_right = 1 - diagonal0a
    diagonal0b = b_across + m_0
    diagonal0b_right = diagonal0b - b_across
    diagonal0c = m_0 + (product_error(v_0, beta_v_0, m_0) + m_0_cross2) < others_0 + others_0_lo
    diagonal0 = where(diagonal0c, diagonal0b, diagonal0a)
    diagonal0b_lo = (b_across - (diagonal0b - diagonal0b_right)
        + product_rest(v_0, beta_v_0, m_0, diagonal0b_right) + m_0_cross2 + b_across_lo)
    diagonal1a = 1 - others_1
    diagonal1a_right = 1 - diagonal1a
    diagonal1b = b_across + m_1
    diagonal1b_right = diagonal1b - b_across
    diagonal1c = m_1 + (product_error(v_1, beta_v_1, m_1) + m_1_cross2) < others_1 + others_1_lo
    diagonal1 = where(diagonal1c, diagonal1b, diagonal1a)
    diagonal1b_lo = (b_across - (diagonal1b - diagonal1b_right)
        + product_rest(v_1, beta_v_1, m_1, diagonal1b_right) + m_1_cross2 + b_across_lo)
    diagonal2a = 1 - others_2
    diagonal2a_right = 1 - diagonal2a
    diagonal2b = b_across + m_2
    diagonal2b_right = diagonal2b - b_across
    diagonal2c = m_2 + (product_error(v_2, beta_v_2, m_2) + m_2_cross2) < others_2 + others_2_lo
    diagonal2 = where(diagonal2c, diagonal2b, diagonal2a)
    diagonal2b_lo = (b_across - (diagonal2b - diagonal2b_right)
        + product_rest(v_2, beta_v_2, m_2, diagonal2b_right) + m_2_cross2 + b_across_lo)
    R_01 = m_3 - halved_2
    R_01_right = m_3 - R_01
    R_02 = halved_1 + m_4
    R_02_right = R_02 - halved_1
    R_10 = halved_2 + m_3
    R_10_right = R_10 - halved_2
    R_12 = m_5 - halved_0
    R_12_right = m_5 - R_12
    R_20 = m_4 - halved_1
    R_20_right = m_4 - R_20
    R_21 = halved_0 + m_5
    R_21_right = R_21 - halved_0
    diagonal0_rounded = (diagonal0
        + where(diagonal0c, diagonal0b_lo, 1 - (diagonal0a + diagonal0a_right)
        - (others_0 - diagonal0a_right) - others_0_lo))
    R_01_rounded = (R_01
        + (product_rest(v_1, beta_v_0, m_3, R_01 + R_01_right) - (halved_2 - R_01_right)
        + m_3_cross2))
    R_02_rounded = (R_02
        + (halved_1 - (R_02 - R_02_right) + product_rest(v_2, beta_v_0, m_4, R_02_right)
        + m_4_cross2))
    R_10_rounded = (R_10
        + (halved_2 - (R_10 - R_10_right) + product_rest(v_1, beta_v_0, m_3, R_10_right)
        + m_3_cross2))
    diagonal1_rounded = (diagonal1
        + where(diagonal1c, diagonal1b_lo, 1 - (diagonal1a + diagonal1a_right)
        - (others_1 - diagonal1a_right) - others_1_lo))
    R_12_rounded = (R_12
        + (product_rest(v_2, beta_v_1, m_5, R_12 + R_12_right) - (halved_0 - R_12_right)
        + m_5_cross2))
    R_20_rounded = (R_20
        + (product_rest(v_2, beta_v_0, m_4, R_20 + R_20_right) - (halved_1 - R_20_right)
        + m_4_cross2))
    R_21_rounded = (R_21
        + (halved_0 - (R_21 - R_21_right) + product_rest(v_2, beta_v_1, m_5, R_21_right)
        + m_5_cross2))
    diagonal2_rounded = (diagonal2
        + where(diagonal2c, diagonal2b_lo, 1 - (diagonal2a + diagonal2a_right)
        - (others_2 - diagonal2a_right) - others_2_lo))
    diagonal0_final = where(diagonal0_rounded == diagonal0_rounded, diagonal0_rounded, diagonal0)
    R_01_final = where(R_01_rounded == R_01_rounded, R_01_rounded, R_01)
    R_02_final = where(R_02_rounded == R_02_rounded, R_02_rounded, R_02)
    R_10_final = where(R_10_rounded == R_10_rounded, R_10_rounded, R_10)
    diagonal1_final = where(diagonal1_rounded == diagonal1_rounded, diagonal1_rounded, diagonal1)
    R_12_final = where(R_12_rounded == R_12_rounded, R_12_rounded, R_12)
    R_20_final = where(R_20_rounded == R_20_rounded, R_20_rounded, R_20)
    R_21_final = where(R_21_rounded == R_21_rounded, R_21_rounded, R_21)
    diagonal2_final = where(diagonal2_rounded == diagonal2_rounded, diagonal2_rounded, diagonal2)
    return (diagonal0_final, R_01_final, R_02_final, R_10_final, diagonal1_final, R_12_final,
        R_20_final, R_21_final, diagonal2_final)


@kernel("(3,3)->(3,3)")
def mat3x3_orthonormalize(self):
    """self = R + R (I - R^T R)/2, closer to a rotation: a defect d of R becomes 3/4 d^2.

    (3,3)->(3,3).  self: rotation or other 3×3 matrix.
    84 mul, 288 add, 45 product rest, 6 neg.  Error <= u |result| + 44 u^2 S, S the sum of the
    |terms| of the expanded formula; barring over- and underflow.
    """
    self_00, self_01, self_02, self_10, self_11, self_12, self_20, self_21, self_22 = self
    defect_0a = self_00 * self_00
    defect_0b = 1 - defect_0a
    defect_0b_right = 1 - defect_0b
    defect_0c = self_10 * self_10
    defect_0d = defect_0b - defect_0c
    defect_0d_right = defect_0b - defect_0d
    defect_0d_lo1 = (defect_0b - (defect_0d + defect_0d_right)
        - product_rest(self_10, self_10, defect_0c, defect_0d_right))
    defect_0e = self_20 * self_20
    defect_0 = defect_0d - defect_0e
    defect_0_right = defect_0d - defect_0
    defect_0d_lo = (defect_0d_lo1
        + (1 - (defect_0b + defect_0b_right)
        - product_rest(self_00, self_00, defect_0a, defect_0b_right)))
    defect_0_lo = (defect_0d - (defect_0 + defect_0_right)
        - product_rest(self_20, self_20, defect_0e, defect_0_right) + defect_0d_lo)
    defect_1a = self_01 * self_01
    defect_1b = 1 - defect_1a
    defect_1b_right = 1 - defect_1b
    defect_1c = self_11 * self_11
    defect_1d = defect_1b - defect_1c
    defect_1d_right = defect_1b - defect_1d
    defect_1d_lo1 = (defect_1b - (defect_1d + defect_1d_right)
        - product_rest(self_11, self_11, defect_1c, defect_1d_right))
    defect_1e = self_21 * self_21
    defect_1 = defect_1d - defect_1e
    defect_1_right = defect_1d - defect_1
    defect_1d_lo = (defect_1d_lo1
        + (1 - (defect_1b + defect_1b_right)
        - product_rest(self_01, self_01, defect_1a, defect_1b_right)))
    defect_1_lo = (defect_1d - (defect_1 + defect_1_right)
        - product_rest(self_21, self_21, defect_1e, defect_1_right) + defect_1d_lo)
    defect_2a = self_02 * self_02
    defect_2b = 1 - defect_2a
    defect_2b_right = 1 - defect_2b
    defect_2c = self_12 * self_12
    defect_2d = defect_2b - defect_2c
    defect_2d_right = defect_2b - defect_2d
    defect_2d_lo1 = (defect_2b - (defect_2d + defect_2d_right)
        - product_rest(self_12, self_12, defect_2c, defect_2d_right))
    defect_2e = self_22 * self_22
    defect_2 = defect_2d - defect_2e
    defect_2_right = defect_2d - defect_2
    defect_2d_lo = (defect_2d_lo1
        + (1 - (defect_2b + defect_2b_right)
        - product_rest(self_02, self_02, defect_2a, defect_2b_right)))
    defect_2_lo = (defect_2d - (defect_2 + defect_2_right)
        - product_rest(self_22, self_22, defect_2e, defect_2_right) + defect_2d_lo)
    defect_3a = self_00 * self_01
    defect_3b = self_10 * self_11
    defect_3c = defect_3a + defect_3b
    defect_3c_right = defect_3c - defect_3a
    defect_3d = self_20 * self_21
    defect_3e = defect_3c + defect_3d
    defect_3e_right = defect_3e - defect_3c
    defect_3c_lo = (product_rest(self_00, self_01, defect_3a, defect_3c - defect_3c_right)
        + product_rest(self_10, self_11, defect_3b, defect_3c_right))
    defect_3 = -defect_3e
    defect_4a = self_00 * self_02
    defect_4b = self_10 * self_12
    defect_4c = defect_4a + defect_4b
    defect_4c_right = defect_4c - defect_4a
    defect_4d = self_20 * self_22
    defect_4e = defect_4c + defect_4d
    defect_4e_right = defect_4e - defect_4c
    defect_4c_lo = (product_rest(self_00, self_02, defect_4a, defect_4c - defect_4c_right)
        + product_rest(self_10, self_12, defect_4b, defect_4c_right))
    defect_4 = -defect_4e
    defect_5a = self_01 * self_02
    defect_5b = self_11 * self_12
    defect_5c = defect_5a + defect_5b
    defect_5c_right = defect_5c - defect_5a
    defect_5d = self_21 * self_22
    defect_5e = defect_5c + defect_5d
    defect_5e_right = defect_5e - defect_5c
    defect_5c_lo = (product_rest(self_01, self_02, defect_5a, defect_5c - defect_5c_right)
        + product_rest(self_11, self_12, defect_5b, defect_5c_right))
    defect_5 = -defect_5e
    defect_0_sum = defect_0 + defect_0_lo
    defect_0_sum_right = defect_0_sum - defect_0
    correction_0 = 0.5 * defect_0_sum
    correction_0_cross2 = (0.5
        * (defect_0 - (defect_0_sum - defect_0_sum_right) + (defect_0_lo - defect_0_sum_right)))
    defect_1_sum = defect_1 + defect_1_lo
    defect_1_sum_right = defect_1_sum - defect_1
    correction_1 = 0.5 * defect_1_sum
    correction_1_cross2 = (0.5
        * (defect_1 - (defect_1_sum - defect_1_sum_right) + (defect_1_lo - defect_1_sum_right)))
    defect_2_sum = defect_2 + defect_2_lo
    defect_2_sum_right = defect_2_sum - defect_2
    correction_2 = 0.5 * defect_2_sum
    correction_2_cross2 = (0.5
        * (defect_2 - (defect_2_sum - defect_2_sum_right) + (defect_2_lo - defect_2_sum_right)))
    correction_3 = 0.5 * defect_3
    correction_3_cross2 = (0.5 *
        -(defect_3c - (defect_3e - defect_3e_right)
        + product_rest(self_20, self_21, defect_3d, defect_3e_right) + defect_3c_lo))
    correction_4 = 0.5 * defect_4
    correction_4_cross2 = (0.5 *
        -(defect_4c - (defect_4e - defect_4e_right)
        + product_rest(self_20, self_22, defect_4d, defect_4e_right) + defect_4c_lo))
    correction_5 = 0.5 * defect_5
    correction_5_cross2 = (0.5 *
        -(defect_5c - (defect_5e - defect_5e_right)
        + product_rest(self_21, self_22, defect_5d, defect_5e_right) + defect_5c_lo))
    self_00_new_a = self_00 * correction_0
    self_00_new_b = self_01 * correction_3
    self_00_new_c = self_00_new_a + self_00_new_b
    self_00_new_c_right = self_00_new_c - self_00_new_a
    self_00_new_c_left_rest = product_rest(self_00, correction_0, self_00_new_a,
        self_00_new_c - self_00_new_c_right)
    self_00_new_c_lo1 = (self_00_new_c_left_rest
        + product_rest(self_01, correction_3, self_00_new_b, self_00_new_c_right))
    self_00_new_d = self_02 * correction_4
    self_00_new_e = self_00_new_c + self_00_new_d
    self_00_new_e_right = self_00_new_e - self_00_new_c
    self_00_new_e_lo1 = (self_00_new_c - (self_00_new_e - self_00_new_e_right)
        + product_rest(self_02, correction_4, self_00_new_d, self_00_new_e_right))
    self_00_new_c_lo = (self_00_new_c_lo1
        + (self_00 * correction_0_cross2 + self_01 * correction_3_cross2))
    self_00_new = self_00 + self_00_new_e
    self_00_new_right = self_00_new - self_00
    self_00_new_lo1 = (self_00 - (self_00_new - self_00_new_right)
        + (self_00_new_e - self_00_new_right))
    self_01_new_a = self_00 * correction_3
    self_01_new_b = self_01 * correction_1
    self_01_new_c = self_01_new_a + self_01_new_b
    self_01_new_c_right = self_01_new_c - self_01_new_a
    self_01_new_c_left_rest = product_rest(self_00, correction_3, self_01_new_a,
        self_01_new_c - self_01_new_c_right)
    self_01_new_c_lo1 = (self_01_new_c_left_rest
        + product_rest(self_01, correction_1, self_01_new_b, self_01_new_c_right))
    self_01_new_d = self_02 * correction_5
    self_01_new_e = self_01_new_c + self_01_new_d
    self_01_new_e_right = self_01_new_e - self_01_new_c
    self_01_new_e_lo1 = (self_01_new_c - (self_01_new_e - self_01_new_e_right)
        + product_rest(self_02, correction_5, self_01_new_d, self_01_new_e_right))
    self_01_new_c_lo = (self_01_new_c_lo1
        + (self_00 * correction_3_cross2 + self_01 * correction_1_cross2))
    self_01_new = self_01_new_e + self_01
    self_01_new_right = self_01_new - self_01_new_e
    self_01_new_lo1 = (self_01_new_e - (self_01_new - self_01_new_right)
        + (self_01 - self_01_new_right))
    self_02_new_a = self_00 * correction_4
    self_02_new_b = self_01 * correction_5
    self_02_new_c = self_02_new_a + self_02_new_b
    self_02_new_c_right = self_02_new_c - self_02_new_a
    self_02_new_c_left_rest = product_rest(self_00, correction_4, self_02_new_a,
        self_02_new_c - self_02_new_c_right)
    self_02_new_c_lo1 = (self_02_new_c_left_rest
        + product_rest(self_01, correction_5, self_02_new_b, self_02_new_c_right))
    self_02_new_d = self_02 * correction_2
    self_02_new_e = self_02_new_c + self_02_new_d
    self_02_new_e_right = self_02_new_e - self_02_new_c
    self_02_new_e_lo1 = (self_02_new_c - (self_02_new_e - self_02_new_e_right)
        + product_rest(self_02, correction_2, self_02_new_d, self_02_new_e_right))
    self_02_new_c_lo = (self_02_new_c_lo1
        + (self_00 * correction_4_cross2 + self_01 * correction_5_cross2))
    self_02_new = self_02_new_e + self_02
    self_02_new_right = self_02_new - self_02_new_e
    self_02_new_lo1 = (self_02_new_e - (self_02_new - self_02_new_right)
        + (self_02 - self_02_new_right))
    self_10_new_a = self_10 * correction_0
    self_10_new_b = self_11 * correction_3
    self_10_new_c = self_10_new_a + self_10_new_b
    self_10_new_c_right = self_10_new_c - self_10_new_a
    self_10_new_c_left_rest = product_rest(self_10, correction_0, self_10_new_a,
        self_10_new_c - self_10_new_c_right)
    self_10_new_c_lo1 = (self_10_new_c_left_rest
        + product_rest(self_11, correction_3, self_10_new_b, self_10_new_c_right))
    self_10_new_d = self_12 * correction_4
    self_10_new_e = self_10_new_c + self_10_new_d
    self_10_new_e_right = self_10_new_e - self_10_new_c
    self_10_new_e_lo1 = (self_10_new_c - (self_10_new_e - self_10_new_e_right)
        + product_rest(self_12, correction_4, self_10_new_d, self_10_new_e_right))
    self_10_new_c_lo = (self_10_new_c_lo1
        + (self_10 * correction_0_cross2 + self_11 * correction_3_cross2))
    self_10_new = self_10 + self_10_new_e
    self_10_new_right = self_10_new - self_10
    self_10_new_lo1 = (self_10 - (self_10_new - self_10_new_right)
        + (self_10_new_e - self_10_new_right))
    self_11_new_a = self_10 * correction_3
    self_11_new_b = self_11 * correction_1
    self_11_new_c = self_11_new_a + self_11_new_b
    self_11_new_c_right = self_11_new_c - self_11_new_a
    self_11_new_c_left_rest = product_rest(self_10, correction_3, self_11_new_a,
        self_11_new_c - self_11_new_c_right)
    self_11_new_c_lo1 = (self_11_new_c_left_rest
        + product_rest(self_11, correction_1, self_11_new_b, self_11_new_c_right))
    self_11_new_d = self_12 * correction_5
    self_11_new_e = self_11_new_c + self_11_new_d
    self_11_new_e_right = self_11_new_e - self_11_new_c
    self_11_new_e_lo1 = (self_11_new_c - (self_11_new_e - self_11_new_e_right)
        + product_rest(self_12, correction_5, self_11_new_d, self_11_new_e_right))
    self_11_new_c_lo = (self_11_new_c_lo1
        + (self_10 * correction_3_cross2 + self_11 * correction_1_cross2))
    self_11_new = self_11_new_e + self_11
    self_11_new_right = self_11_new - self_11_new_e
    self_11_new_lo1 = (self_11_new_e - (self_11_new - self_11_new_right)
        + (self_11 - self_11_new_right))
    self_12_new_a = self_10 * correction_4
    self_12_new_b = self_11 * correction_5
    self_12_new_c = self_12_new_a + self_12_new_b
    self_12_new_c_right = self_12_new_c - self_12_new_a
    self_12_new_c_left_rest = product_rest(self_10, correction_4, self_12_new_a,
        self_12_new_c - self_12_new_c_right)
    self_12_new_c_lo1 = (self_12_new_c_left_rest
        + product_rest(self_11, correction_5, self_12_new_b, self_12_new_c_right))
    self_12_new_d = self_12 * correction_2
    self_12_new_e = self_12_new_c + self_12_new_d
    self_12_new_e_right = self_12_new_e - self_12_new_c
    self_12_new_e_lo1 = (self_12_new_c - (self_12_new_e - self_12_new_e_right)
        + product_rest(self_12, correction_2, self_12_new_d, self_12_new_e_right))
    self_12_new_c_lo = (self_12_new_c_lo1
        + (self_10 * correction_4_cross2 + self_11 * correction_5_cross2))
    self_12_new = self_12_new_e + self_12
    self_12_new_right = self_12_new - self_12_new_e
    self_12_new_lo1 = (self_12_new_e - (self_12_new - self_12_new_right)
        + (self_12 - self_12_new_right))
    self_20_new_a = self_20 * correction_0
    self_20_new_b = self_21 * correction_3
    self_20_new_c = self_20_new_a + self_20_new_b
    self_20_new_c_right = self_20_new_c - self_20_new_a
    self_20_new_c_left_rest = product_rest(self_20, correction_0, self_20_new_a,
        self_20_new_c - self_20_new_c_right)
    self_20_new_c_lo1 = (self_20_new_c_left_rest
        + product_rest(self_21, correction_3, self_20_new_b, self_20_new_c_right))
    self_20_new_d = self_22 * correction_4
    self_20_new_e = self_20_new_c + self_20_new_d
    self_20_new_e_right = self_20_new_e - self_20_new_c
    self_20_new_e_lo1 = (self_20_new_c - (self_20_new_e - self_20_new_e_right)
        + product_rest(self_22, correction_4, self_20_new_d, self_20_new_e_right))
    self_20_new_c_lo = (self_20_new_c_lo1
        + (self_20 * correction_0_cross2 + self_21 * correction_3_cross2))
    self_20_new = self_20 + self_20_new_e
    self_20_new_right = self_20_new - self_20
    self_20_new_lo1 = (self_20 - (self_20_new - self_20_new_right)
        + (self_20_new_e - self_20_new_right))
    self_21_new_a = self_20 * correction_3
    self_21_new_b = self_21 * correction_1
    self_21_new_c = self_21_new_a + self_21_new_b
    self_21_new_c_right = self_21_new_c - self_21_new_a
    self_21_new_c_left_rest = product_rest(self_20, correction_3, self_21_new_a,
        self_21_new_c - self_21_new_c_right)
    self_21_new_c_lo1 = (self_21_new_c_left_rest
        + product_rest(self_21, correction_1, self_21_new_b, self_21_new_c_right))
    self_21_new_d = self_22 * correction_5
    self_21_new_e = self_21_new_c + self_21_new_d
    self_21_new_e_right = self_21_new_e - self_21_new_c
    self_21_new_e_lo1 = (self_21_new_c - (self_21_new_e - self_21_new_e_right)
        + product_rest(self_22, correction_5, self_21_new_d, self_21_new_e_right))
    self_21_new_c_lo = (self_21_new_c_lo1
        + (self_20 * correction_3_cross2 + self_21 * correction_1_cross2))
    self_21_new = self_21_new_e + self_21
    self_21_new_right = self_21_new - self_21_new_e
    self_21_new_lo1 = (self_21_new_e - (self_21_new - self_21_new_right)
        + (self_21 - self_21_new_right))
    self_22_new_a = self_20 * correction_4
    self_22_new_b = self_21 * correction_5
    self_22_new_c = self_22_new_a + self_22_new_b
    self_22_new_c_right = self_22_new_c - self_22_new_a
    self_22_new_c_left_rest = product_rest(self_20, correction_4, self_22_new_a,
        self_22_new_c - self_22_new_c_right)
    self_22_new_c_lo1 = (self_22_new_c_left_rest
        + product_rest(self_21, correction_5, self_22_new_b, self_22_new_c_right))
    self_22_new_d = self_22 * correction_2
    self_22_new_e = self_22_new_c + self_22_new_d
    self_22_new_e_right = self_22_new_e - self_22_new_c
    self_22_new_e_lo1 = (self_22_new_c - (self_22_new_e - self_22_new_e_right)
        + product_rest(self_22, correction_2, self_22_new_d, self_22_new_e_right))
    self_22_new_c_lo = (self_22_new_c_lo1
        + (self_20 * correction_4_cross2 + self_21 * correction_5_cross2))
    self_22_new = self_22_new_e + self_22
    self_22_new_right = self_22_new - self_22_new_e
    self_22_new_lo1 = (self_22_new_e - (self_22_new - self_22_new_right)
        + (self_22 - self_22_new_right))
    self_00_new_rounded = (self_00_new
        + (self_00_new_lo1
        + (self_00_new_e_lo1 + self_02 * correction_4_cross2 + self_00_new_c_lo)))
    self_01_new_rounded = (self_01_new
        + (self_01_new_lo1
        + (self_01_new_e_lo1 + self_02 * correction_5_cross2 + self_01_new_c_lo)))
    self_02_new_rounded = (self_02_new
        + (self_02_new_lo1
        + (self_02_new_e_lo1 + self_02 * correction_2_cross2 + self_02_new_c_lo)))
    self_10_new_rounded = (self_10_new
        + (self_10_new_lo1
        + (self_10_new_e_lo1 + self_12 * correction_4_cross2 + self_10_new_c_lo)))
    self_11_new_rounded = (self_11_new
        + (self_11_new_lo1
        + (self_11_new_e_lo1 + self_12 * correction_5_cross2 + self_11_new_c_lo)))
    self_12_new_rounded = (self_12_new
        + (self_12_new_lo1
        + (self_12_new_e_lo1 + self_12 * correction_2_cross2 + self_12_new_c_lo)))
    self_20_new_rounded = (self_20_new
        + (self_20_new_lo1
        + (self_20_new_e_lo1 + self_22 * correction_4_cross2 + self_20_new_c_lo)))
    self_21_new_rounded = (self_21_new
        + (self_21_new_lo1
        + (self_21_new_e_lo1 + self_22 * correction_5_cross2 + self_21_new_c_lo)))
    self_22_new_rounded = (self_22_new
        + (self_22_new_lo1
        + (self_22_new_e_lo1 + self_22 * correction_2_cross2 + self_22_new_c_lo)))
    return (self_00_new_rounded, self_01_new_rounded, self_02_new_rounded, self_10_new_rounded,
        self_11_new_rounded, self_12_new_rounded, self_20_new_rounded, self_21_new_rounded,
        self_22_new_rounded)


@kernel("(3,3)->(3,3)")
def mat3x3_orthonormalized(R):
    """Ro = R + R (I - R^T R)/2, closer to a rotation: a defect d of R becomes 3/4 d^2.

    (3,3)->(3,3).  R, Ro: rotation or other 3×3 matrix.
    84 mul, 288 add, 45 product rest, 6 neg.  Error <= u |result| + 44 u^2 S, S the sum of the
    |terms| of the expanded formula; barring over- and underflow.
    """
    R_00, R_01, R_02, R_10, R_11, R_12, R_20, R_21, R_22 = R
    defect_0a = R_00 * R_00
    defect_0b = 1 - defect_0a
    defect_0b_right = 1 - defect_0b
    defect_0c = R_10 * R_10
    defect_0d = defect_0b - defect_0c
    defect_0d_right = defect_0b - defect_0d
    defect_0d_lo1 = (defect_0b - (defect_0d + defect_0d_right)
        - product_rest(R_10, R_10, defect_0c, defect_0d_right))
    defect_0e = R_20 * R_20
    defect_0 = defect_0d - defect_0e
    defect_0_right = defect_0d - defect_0
    defect_0d_lo = (defect_0d_lo1
        + (1 - (defect_0b + defect_0b_right)
        - product_rest(R_00, R_00, defect_0a, defect_0b_right)))
    defect_0_lo = (defect_0d - (defect_0 + defect_0_right)
        - product_rest(R_20, R_20, defect_0e, defect_0_right) + defect_0d_lo)
    defect_1a = R_01 * R_01
    defect_1b = 1 - defect_1a
    defect_1b_right = 1 - defect_1b
    defect_1c = R_11 * R_11
    defect_1d = defect_1b - defect_1c
    defect_1d_right = defect_1b - defect_1d
    defect_1d_lo1 = (defect_1b - (defect_1d + defect_1d_right)
        - product_rest(R_11, R_11, defect_1c, defect_1d_right))
    defect_1e = R_21 * R_21
    defect_1 = defect_1d - defect_1e
    defect_1_right = defect_1d - defect_1
    defect_1d_lo = (defect_1d_lo1
        + (1 - (defect_1b + defect_1b_right)
        - product_rest(R_01, R_01, defect_1a, defect_1b_right)))
    defect_1_lo = (defect_1d - (defect_1 + defect_1_right)
        - product_rest(R_21, R_21, defect_1e, defect_1_right) + defect_1d_lo)
    defect_2a = R_02 * R_02
    defect_2b = 1 - defect_2a
    defect_2b_right = 1 - defect_2b
    defect_2c = R_12 * R_12
    defect_2d = defect_2b - defect_2c
    defect_2d_right = defect_2b - defect_2d
    defect_2d_lo1 = (defect_2b - (defect_2d + defect_2d_right)
        - product_rest(R_12, R_12, defect_2c, defect_2d_right))
    defect_2e = R_22 * R_22
    defect_2 = defect_2d - defect_2e
    defect_2_right = defect_2d - defect_2
    defect_2d_lo = (defect_2d_lo1
        + (1 - (defect_2b + defect_2b_right)
        - product_rest(R_02, R_02, defect_2a, defect_2b_right)))
    defect_2_lo = (defect_2d - (defect_2 + defect_2_right)
        - product_rest(R_22, R_22, defect_2e, defect_2_right) + defect_2d_lo)
    defect_3a = R_00 * R_01
    defect_3b = R_10 * R_11
    defect_3c = defect_3a + defect_3b
    defect_3c_right = defect_3c - defect_3a
    defect_3d = R_20 * R_21
    defect_3e = defect_3c + defect_3d
    defect_3e_right = defect_3e - defect_3c
    defect_3c_lo = (product_rest(R_00, R_01, defect_3a, defect_3c - defect_3c_right)
        + product_rest(R_10, R_11, defect_3b, defect_3c_right))
    defect_3 = -defect_3e
    defect_4a = R_00 * R_02
    defect_4b = R_10 * R_12
    defect_4c = defect_4a + defect_4b
    defect_4c_right = defect_4c - defect_4a
    defect_4d = R_20 * R_22
    defect_4e = defect_4c + defect_4d
    defect_4e_right = defect_4e - defect_4c
    defect_4c_lo = (product_rest(R_00, R_02, defect_4a, defect_4c - defect_4c_right)
        + product_rest(R_10, R_12, defect_4b, defect_4c_right))
    defect_4 = -defect_4e
    defect_5a = R_01 * R_02
    defect_5b = R_11 * R_12
    defect_5c = defect_5a + defect_5b
    defect_5c_right = defect_5c - defect_5a
    defect_5d = R_21 * R_22
    defect_5e = defect_5c + defect_5d
    defect_5e_right = defect_5e - defect_5c
    defect_5c_lo = (product_rest(R_01, R_02, defect_5a, defect_5c - defect_5c_right)
        + product_rest(R_11, R_12, defect_5b, defect_5c_right))
    defect_5 = -defect_5e
    defect_0_sum = defect_0 + defect_0_lo
    defect_0_sum_right = defect_0_sum - defect_0
    correction_0 = 0.5 * defect_0_sum
    correction_0_cross2 = (0.5
        * (defect_0 - (defect_0_sum - defect_0_sum_right) + (defect_0_lo - defect_0_sum_right)))
    defect_1_sum = defect_1 + defect_1_lo
    defect_1_sum_right = defect_1_sum - defect_1
    correction_1 = 0.5 * defect_1_sum
    correction_1_cross2 = (0.5
        * (defect_1 - (defect_1_sum - defect_1_sum_right) + (defect_1_lo - defect_1_sum_right)))
    defect_2_sum = defect_2 + defect_2_lo
    defect_2_sum_right = defect_2_sum - defect_2
    correction_2 = 0.5 * defect_2_sum
    correction_2_cross2 = (0.5
        * (defect_2 - (defect_2_sum - defect_2_sum_right) + (defect_2_lo - defect_2_sum_right)))
    correction_3 = 0.5 * defect_3
    correction_3_cross2 = (0.5 *
        -(defect_3c - (defect_3e - defect_3e_right)
        + product_rest(R_20, R_21, defect_3d, defect_3e_right) + defect_3c_lo))
    correction_4 = 0.5 * defect_4
    correction_4_cross2 = (0.5 *
        -(defect_4c - (defect_4e - defect_4e_right)
        + product_rest(R_20, R_22, defect_4d, defect_4e_right) + defect_4c_lo))
    correction_5 = 0.5 * defect_5
    correction_5_cross2 = (0.5 *
        -(defect_5c - (defect_5e - defect_5e_right)
        + product_rest(R_21, R_22, defect_5d, defect_5e_right) + defect_5c_lo))
    Ro_00a = R_00 * correction_0
    Ro_00b = R_01 * correction_3
    Ro_00c = Ro_00a + Ro_00b
    Ro_00c_right = Ro_00c - Ro_00a
    Ro_00c_lo1 = (product_rest(R_00, correction_0, Ro_00a, Ro_00c - Ro_00c_right)
        + product_rest(R_01, correction_3, Ro_00b, Ro_00c_right))
    Ro_00d = R_02 * correction_4
    Ro_00e = Ro_00c + Ro_00d
    Ro_00e_right = Ro_00e - Ro_00c
    Ro_00e_lo2 = (Ro_00c - (Ro_00e - Ro_00e_right)
        + product_rest(R_02, correction_4, Ro_00d, Ro_00e_right) + R_02 * correction_4_cross2)
    Ro_00 = R_00 + Ro_00e
    Ro_00_right = Ro_00 - R_00
    Ro_00e_lo = (Ro_00e_lo2
        + (Ro_00c_lo1 + (R_00 * correction_0_cross2 + R_01 * correction_3_cross2)))
    Ro_01a = R_00 * correction_3
    Ro_01b = R_01 * correction_1
    Ro_01c = Ro_01a + Ro_01b
    Ro_01c_right = Ro_01c - Ro_01a
    Ro_01c_lo1 = (product_rest(R_00, correction_3, Ro_01a, Ro_01c - Ro_01c_right)
        + product_rest(R_01, correction_1, Ro_01b, Ro_01c_right))
    Ro_01d = R_02 * correction_5
    Ro_01e = Ro_01c + Ro_01d
    Ro_01e_right = Ro_01e - Ro_01c
    Ro_01e_lo2 = (Ro_01c - (Ro_01e - Ro_01e_right)
        + product_rest(R_02, correction_5, Ro_01d, Ro_01e_right) + R_02 * correction_5_cross2)
    Ro_01 = Ro_01e + R_01
    Ro_01_right = Ro_01 - Ro_01e
    Ro_01e_lo = (Ro_01e_lo2
        + (Ro_01c_lo1 + (R_00 * correction_3_cross2 + R_01 * correction_1_cross2)))
    Ro_02a = R_00 * correction_4
    Ro_02b = R_01 * correction_5
    Ro_02c = Ro_02a + Ro_02b
    Ro_02c_right = Ro_02c - Ro_02a
    Ro_02c_lo1 = (product_rest(R_00, correction_4, Ro_02a, Ro_02c - Ro_02c_right)
        + product_rest(R_01, correction_5, Ro_02b, Ro_02c_right))
    Ro_02d = R_02 * correction_2
    Ro_02e = Ro_02c + Ro_02d
    Ro_02e_right = Ro_02e - Ro_02c
    Ro_02e_lo2 = (Ro_02c - (Ro_02e - Ro_02e_right)
        + product_rest(R_02, correction_2, Ro_02d, Ro_02e_right) + R_02 * correction_2_cross2)
    Ro_02 = Ro_02e + R_02
    Ro_02_right = Ro_02 - Ro_02e
    Ro_02e_lo = (Ro_02e_lo2
        + (Ro_02c_lo1 + (R_00 * correction_4_cross2 + R_01 * correction_5_cross2)))
    Ro_10a = R_10 * correction_0
    Ro_10b = R_11 * correction_3
    Ro_10c = Ro_10a + Ro_10b
    Ro_10c_right = Ro_10c - Ro_10a
    Ro_10c_lo1 = (product_rest(R_10, correction_0, Ro_10a, Ro_10c - Ro_10c_right)
        + product_rest(R_11, correction_3, Ro_10b, Ro_10c_right))
    Ro_10d = R_12 * correction_4
    Ro_10e = Ro_10c + Ro_10d
    Ro_10e_right = Ro_10e - Ro_10c
    Ro_10e_lo2 = (Ro_10c - (Ro_10e - Ro_10e_right)
        + product_rest(R_12, correction_4, Ro_10d, Ro_10e_right) + R_12 * correction_4_cross2)
    Ro_10 = R_10 + Ro_10e
    Ro_10_right = Ro_10 - R_10
    Ro_10e_lo = (Ro_10e_lo2
        + (Ro_10c_lo1 + (R_10 * correction_0_cross2 + R_11 * correction_3_cross2)))
    Ro_11a = R_10 * correction_3
    Ro_11b = R_11 * correction_1
    Ro_11c = Ro_11a + Ro_11b
    Ro_11c_right = Ro_11c - Ro_11a
    Ro_11c_lo1 = (product_rest(R_10, correction_3, Ro_11a, Ro_11c - Ro_11c_right)
        + product_rest(R_11, correction_1, Ro_11b, Ro_11c_right))
    Ro_11d = R_12 * correction_5
    Ro_11e = Ro_11c + Ro_11d
    Ro_11e_right = Ro_11e - Ro_11c
    Ro_11e_lo2 = (Ro_11c - (Ro_11e - Ro_11e_right)
        + product_rest(R_12, correction_5, Ro_11d, Ro_11e_right) + R_12 * correction_5_cross2)
    Ro_11 = Ro_11e + R_11
    Ro_11_right = Ro_11 - Ro_11e
    Ro_11e_lo = (Ro_11e_lo2
        + (Ro_11c_lo1 + (R_10 * correction_3_cross2 + R_11 * correction_1_cross2)))
    Ro_12a = R_10 * correction_4
    Ro_12b = R_11 * correction_5
    Ro_12c = Ro_12a + Ro_12b
    Ro_12c_right = Ro_12c - Ro_12a
    Ro_12c_lo1 = (product_rest(R_10, correction_4, Ro_12a, Ro_12c - Ro_12c_right)
        + product_rest(R_11, correction_5, Ro_12b, Ro_12c_right))
    Ro_12d = R_12 * correction_2
    Ro_12e = Ro_12c + Ro_12d
    Ro_12e_right = Ro_12e - Ro_12c
    Ro_12e_lo2 = (Ro_12c - (Ro_12e - Ro_12e_right)
        + product_rest(R_12, correction_2, Ro_12d, Ro_12e_right) + R_12 * correction_2_cross2)
    Ro_12 = Ro_12e + R_12
    Ro_12_right = Ro_12 - Ro_12e
    Ro_12e_lo = (Ro_12e_lo2
        + (Ro_12c_lo1 + (R_10 * correction_4_cross2 + R_11 * correction_5_cross2)))
    Ro_20a = R_20 * correction_0
    Ro_20b = R_21 * correction_3
    Ro_20c = Ro_20a + Ro_20b
    Ro_20c_right = Ro_20c - Ro_20a
    Ro_20c_lo1 = (product_rest(R_20, correction_0, Ro_20a, Ro_20c - Ro_20c_right)
        + product_rest(R_21, correction_3, Ro_20b, Ro_20c_right))
    Ro_20d = R_22 * correction_4
    Ro_20e = Ro_20c + Ro_20d
    Ro_20e_right = Ro_20e - Ro_20c
    Ro_20e_lo2 = (Ro_20c - (Ro_20e - Ro_20e_right)
        + product_rest(R_22, correction_4, Ro_20d, Ro_20e_right) + R_22 * correction_4_cross2)
    Ro_20 = R_20 + Ro_20e
    Ro_20_right = Ro_20 - R_20
    Ro_20e_lo = (Ro_20e_lo2
        + (Ro_20c_lo1 + (R_20 * correction_0_cross2 + R_21 * correction_3_cross2)))
    Ro_21a = R_20 * correction_3
    Ro_21b = R_21 * correction_1
    Ro_21c = Ro_21a + Ro_21b
    Ro_21c_right = Ro_21c - Ro_21a
    Ro_21c_lo1 = (product_rest(R_20, correction_3, Ro_21a, Ro_21c - Ro_21c_right)
        + product_rest(R_21, correction_1, Ro_21b, Ro_21c_right))
    Ro_21d = R_22 * correction_5
    Ro_21e = Ro_21c + Ro_21d
    Ro_21e_right = Ro_21e - Ro_21c
    Ro_21e_lo2 = (Ro_21c - (Ro_21e - Ro_21e_right)
        + product_rest(R_22, correction_5, Ro_21d, Ro_21e_right) + R_22 * correction_5_cross2)
    Ro_21 = Ro_21e + R_21
    Ro_21_right = Ro_21 - Ro_21e
    Ro_21e_lo = (Ro_21e_lo2
        + (Ro_21c_lo1 + (R_20 * correction_3_cross2 + R_21 * correction_1_cross2)))
    Ro_22a = R_20 * correction_4
    Ro_22b = R_21 * correction_5
    Ro_22c = Ro_22a + Ro_22b
    Ro_22c_right = Ro_22c - Ro_22a
    Ro_22c_lo1 = (product_rest(R_20, correction_4, Ro_22a, Ro_22c - Ro_22c_right)
        + product_rest(R_21, correction_5, Ro_22b, Ro_22c_right))
    Ro_22d = R_22 * correction_2
    Ro_22e = Ro_22c + Ro_22d
    Ro_22e_right = Ro_22e - Ro_22c
    Ro_22e_lo2 = (Ro_22c - (Ro_22e - Ro_22e_right)
        + product_rest(R_22, correction_2, Ro_22d, Ro_22e_right) + R_22 * correction_2_cross2)
    Ro_22 = Ro_22e + R_22
    Ro_22_right = Ro_22 - Ro_22e
    Ro_22e_lo = (Ro_22e_lo2
        + (Ro_22c_lo1 + (R_20 * correction_4_cross2 + R_21 * correction_5_cross2)))
    Ro_00_rounded = Ro_00 + (R_00 - (Ro_00 - Ro_00_right) + (Ro_00e - Ro_00_right) + Ro_00e_lo)
    Ro_01_rounded = Ro_01 + (Ro_01e - (Ro_01 - Ro_01_right) + (R_01 - Ro_01_right) + Ro_01e_lo)
    Ro_02_rounded = Ro_02 + (Ro_02e - (Ro_02 - Ro_02_right) + (R_02 - Ro_02_right) + Ro_02e_lo)
    Ro_10_rounded = Ro_10 + (R_10 - (Ro_10 - Ro_10_right) + (Ro_10e - Ro_10_right) + Ro_10e_lo)
    Ro_11_rounded = Ro_11 + (Ro_11e - (Ro_11 - Ro_11_right) + (R_11 - Ro_11_right) + Ro_11e_lo)
    Ro_12_rounded = Ro_12 + (Ro_12e - (Ro_12 - Ro_12_right) + (R_12 - Ro_12_right) + Ro_12e_lo)
    Ro_20_rounded = Ro_20 + (R_20 - (Ro_20 - Ro_20_right) + (Ro_20e - Ro_20_right) + Ro_20e_lo)
    Ro_21_rounded = Ro_21 + (Ro_21e - (Ro_21 - Ro_21_right) + (R_21 - Ro_21_right) + Ro_21e_lo)
    Ro_22_rounded = Ro_22 + (Ro_22e - (Ro_22 - Ro_22_right) + (R_22 - Ro_22_right) + Ro_22e_lo)
    return (Ro_00_rounded, Ro_01_rounded, Ro_02_rounded, Ro_10_rounded, Ro_11_rounded,
        Ro_12_rounded, Ro_20_rounded, Ro_21_rounded, Ro_22_rounded)


@kernel("(6)->(3,4)")
def SE3_exp(s):
    """D = exp s = [exp ω~ | J_l(ω) v].

    (6)->(3,4).  s: screw (v in m/s; ω in rad/s); D: displacement [R | t], R rotation, t in m.
    246 mul, 553 add, 24 product error, 58 product rest, 6 div, 1 sqrt, 4 abs, 6 less, 13 equal,
    28 select.  Error <= R: 1 u, t: 1 u of its largest component, or of s.lin if that is larger,
    for |ω of s| <= 1e13, in single precision 1e5; searched, not proved.  Each component is
    within 1 ulp as long as its condition is below 1e13; in single precision it is the nearest
    number, except near ties, as long as that is below 1e5; searched, not proved.  Intermediate
    sums may overflow where |v|, or |ω| |v|, is above 2e306, in single precision 5e36.
    """
    s_0, s_1, s_2, s_3, s_4, s_5 = s
    halved_0 = 0.5 * s_3
    halved_1 = 0.5 * s_4
    halved_2 = 0.5 * s_5
    y_a = halved_0 * halved_0
    y_b = halved_1 * halved_1
    y_c = y_a + y_b
    y_c_right = y_c - y_a
    y_d = halved_2 * halved_2
    y = y_c + y_d
    y_right = y - y_c
    y_c_lo = (product_rest(halved_0, halved_0, y_a, y_c - y_c_right)
        + product_rest(halved_1, halved_1, y_b, y_c_right))
    y_lo = y_c - (y - y_right) + product_rest(halved_2, halved_2, y_d, y_right) + y_c_lo
    y_sum = y + y_lo
    y_sum_right = y_sum - y
    y_sum_lo = y - (y_sum - y_sum_right) + (y_lo - y_sum_right)
    half_angle = sqrt(y_sum)
    half_angle_product = half_angle * half_angle
    half_angle_residual = (y_sum - half_angle_product
        - product_error(half_angle, half_angle, half_angle_product) + y_sum_lo)
    half_angle_lo = half_angle_residual / where(half_angle == 0, 1, half_angle + half_angle)
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
    sine_sum_lo = sine - (sine_sum - sine_sum_right) + (sine_lo - sine_sum_right)
    sinc_divisor_sum = sinc_divisor + sinc_divisor_lo
    sinc_divisor_sum_right = sinc_divisor_sum - sinc_divisor
    sinc_quotient = sine_sum / sinc_divisor_sum
    sinc_quotient_product = sinc_quotient * sinc_divisor_sum
    sinc_quotient_cross = (sinc_quotient
        * (sinc_divisor - (sinc_divisor_sum - sinc_divisor_sum_right)
        + (sinc_divisor_lo - sinc_divisor_sum_right)))
    sinc_quotient_numerator = (sine_sum - sinc_quotient_product
        - product_error(sinc_quotient, sinc_divisor_sum, sinc_quotient_product) + sine_sum_lo)
    sinc_a = 0.16666666666666666 * y_sum
    sinc_b = 1 - sinc_a
    sinc_b_right = 1 - sinc_b
    sinc_b_lo1 = (1 - (sinc_b + sinc_b_right)
        - product_rest(0.16666666666666666, y_sum, sinc_a, sinc_b_right))
    sinc = where(sinc_divisor_a, sinc_b, sinc_quotient)
    sinc_b_lo = sinc_b_lo1 - (9.25185853854297e-18 * y_sum + 0.16666666666666666 * y_sum_lo)
    sinc_lo = where(sinc_divisor_a, sinc_b_lo,
        (sinc_quotient_numerator - sinc_quotient_cross) / sinc_divisor_sum)
    g1 = c * sinc
    g1_cross = ((c_own_error - (sine_half_cos * sine + sine_half_sin * c) * sine_twice) * sinc + c
        * sinc_lo)
    g2a = sinc * sinc
    g2 = 0.5 * g2a
    g2_cross2 = 0.5 * (product_error(sinc, sinc, g2a) + (sinc_lo * sinc + sinc * sinc_lo))
    sine_square = sine_sum * sine_sum
    g0a = 2 * sine_square
    g0 = 1 - g0a
    g0_right = 1 - g0
    g0a_cross2 = (2
        * (product_error(sine_sum, sine_sum, sine_square)
        + (sine_sum_lo * sine_sum + sine_sum * sine_sum_lo)))
    g0_lo = 1 - (g0 + g0_right) - (g0a - g0_right) - g0a_cross2
    rest3 = 1 - g1
    rest3_right = 1 - rest3
    rest3_lo = 1 - (rest3 + rest3_right) - product_rest(c, sinc, g1, rest3_right) - g1_cross
    x = 4 * y_sum
    x_cross2 = 4 * y_sum_lo
    x_sum = x + x_cross2
    x_sum_right = x_sum - x
    x_sum_lo = x - (x_sum - x_sum_right) + (x_cross2 - x_sum_right)
    far_x_a = x_sum < 1
    far_x = where(far_x_a, 1, x_sum)
    far_x_lo = where(far_x_a, 0, x_sum_lo)
    rest3_sum = rest3 + rest3_lo
    rest3_sum_right = rest3_sum - rest3
    far_x_sum = far_x + far_x_lo
    far_x_sum_right = far_x_sum - far_x
    closed3 = rest3_sum / far_x_sum
    closed3_product = closed3 * far_x_sum
    closed3_exact = rest3_sum - closed3_product - product_error(closed3, far_x_sum, closed3_product)
    closed3_numerator = (closed3_exact
        + (rest3 - (rest3_sum - rest3_sum_right) + (rest3_lo - rest3_sum_right)))
    series5a = 1.216125041553518e-34 * x_sum
    series5b = 1.1309962886447716e-31 - series5a
    series5b_right = 1.1309962886447716e-31 - series5b
    series5b_lo1 = (1.1309962886447716e-31 - (series5b + series5b_right)
        - product_rest(1.216125041553518e-34, x_sum, series5a, series5b_right))
    series5c = x_sum * series5b
    series5c_cross2 = (x_sum
        * (series5b_lo1 - (5.586290567888806e-51 * x_sum + 1.216125041553518e-34 * x_sum_lo)
        + 1.0498015412959506e-47))
    series5d = series5c - 9.183689863795546e-29
    series5d_right = series5c - series5d
    series5d_lo2 = (product_rest(x_sum, series5b, series5c, series5d + series5d_right)
        - (9.183689863795546e-29 - series5d_right) - 1.4303150396787322e-45)
    series5e = x_sum * series5d
    series5f = series5e + 6.446950284384474e-26
    series5f_right = series5f - series5e
    series5f_lo2 = (product_rest(x_sum, series5d, series5e, series5f - series5f_right)
        + (6.446950284384474e-26 - series5f_right) + -1.9330404233703465e-42)
    series5g = x_sum * series5f
    series5g_cross2 = (x_sum
        * (series5f_lo2
        + (x_sum_lo * series5d + x_sum * (series5d_lo2 + (x_sum_lo * series5b + series5c_cross2)))))
    series5h = series5g - 3.868170170630684e-23
    series5h_right = series5g - series5h
    series5h_lo2 = (product_rest(x_sum, series5f, series5g, series5h + series5h_right)
        - (3.868170170630684e-23 - series5h_right) - -8.843177655482344e-40)
    series5i = x_sum * series5h
    series5j = series5i + 1.9572941063391263e-20
    series5j_right = series5j - series5i
    series5j_lo1 = (product_rest(x_sum, series5h, series5i, series5j - series5j_right)
        + (1.9572941063391263e-20 - series5j_right))
    series5k = x_sum * series5j
    series5j_lo = (series5j_lo1 + -1.3643503830087908e-36
        + (x_sum_lo * series5h + x_sum * (series5h_lo2 + (x_sum_lo * series5f + series5g_cross2))))
    series5l = series5k - 8.22063524662433e-18
    series5l_right = series5k - series5l
    series5l_lo2 = (product_rest(x_sum, series5j, series5k, series5l + series5l_right)
        - (8.22063524662433e-18 - series5l_right) - 2.2141894119604265e-34)
    series5m = x_sum * series5l
    series5n = series5m + 2.8114572543455206e-15
    series5n_right = series5n - series5m
    series5n_lo2 = (product_rest(x_sum, series5l, series5m, series5n - series5n_right)
        + (2.8114572543455206e-15 - series5n_right) + 1.6508842730861433e-31)
    series5o = x_sum * series5n
    series5o_cross2 = (x_sum
        * (series5n_lo2
        + (x_sum_lo * series5l + x_sum
        * (series5l_lo2 + (x_sum_lo * series5j + x_sum * series5j_lo)))))
    series5p = series5o - 7.647163731819816e-13
    series5p_right = series5o - series5p
    series5p_lo2 = (product_rest(x_sum, series5n, series5o, series5p + series5p_right)
        - (7.647163731819816e-13 - series5p_right) - 7.03872877733453e-30)
    series5q = x_sum * series5p
    series5r = series5q + 1.6059043836821613e-10
    series5r_right = series5r - series5q
    series5r_lo2 = (product_rest(x_sum, series5p, series5q, series5r - series5r_right)
        + (1.6059043836821613e-10 - series5r_right) + 1.2585294588752098e-26)
    series5s = x_sum * series5r
    series5s_cross2 = (x_sum
        * (series5r_lo2
        + (x_sum_lo * series5p + x_sum * (series5p_lo2 + (x_sum_lo * series5n + series5o_cross2)))))
    series5t = series5s - 2.505210838544172e-08
    series5t_right = series5s - series5t
    series5t_lo2 = (product_rest(x_sum, series5r, series5s, series5t + series5t_right)
        - (2.505210838544172e-08 - series5t_right) - -1.448814070935912e-24)
    series5u = x_sum * series5t
    series5v = series5u + 2.7557319223985893e-06
    series5v_right = series5v - series5u
    series5v_lo2 = (product_rest(x_sum, series5t, series5u, series5v - series5v_right)
        + (2.7557319223985893e-06 - series5v_right) + -1.858393274046472e-22)
    series5w = x_sum * series5v
    series5w_cross2 = (x_sum
        * (series5v_lo2
        + (x_sum_lo * series5t + x_sum * (series5t_lo2 + (x_sum_lo * series5r + series5s_cross2)))))
    series5x = series5w - 0.0001984126984126984
    series5x_right = series5w - series5x
    series5x_lo2 = (product_rest(x_sum, series5v, series5w, series5x + series5x_right)
        - (0.0001984126984126984 - series5x_right) - 1.7209558293420705e-22)
    series5y = x_sum * series5x
    series5 = series5y + 0.008333333333333333
    series5_right = series5 - series5y
    series5_lo2 = (product_rest(x_sum, series5x, series5y, series5 - series5_right)
        + (0.008333333333333333 - series5_right) + 1.1564823173178714e-19)
    g3a = x_sum * series5
    g3b = 0.16666666666666666 - g3a
    g3b_right = 0.16666666666666666 - g3b
    g3a_cross = (x_sum_lo * series5 + x_sum
        * (series5_lo2
        + (x_sum_lo * series5x + x_sum * (series5x_lo2 + (x_sum_lo * series5v + series5w_cross2)))))
    g3 = where(far_x_a, g3b, closed3)
    g3b_lo = (0.16666666666666666 - (g3b + g3b_right)
        - product_rest(x_sum, series5, g3a, g3b_right) - g3a_cross + 9.25185853854297e-18)
    u_0a = s_2 * s_4
    u_0b = s_1 * s_5
    u_0 = u_0a - u_0b
    u_0_right = u_0a - u_0
    u_1a = s_0 * s_5
    u_1b = s_2 * s_3
    u_1 = u_1a - u_1b
    u_1_right = u_1a - u_1
    u_2a = s_1 * s_3
    u_2b = s_0 * s_4
    u_2 = u_2a - u_2b
    u_2_right = u_2a - u_2
    turned_0 = g2 * u_0
    turned_1 = g2 * u_1
    turned_2 = g2 * u_2
    wv_a = s_0 * s_3
    wv_b = s_1 * s_4
    wv_c = wv_a + wv_b
    wv_c_right = wv_c - wv_a
    wv_d = s_2 * s_5
    wv = wv_c + wv_d
    wv_right = wv - wv_c
    wv_c_lo = (product_rest(s_0, s_3, wv_a, wv_c - wv_c_right)
        + product_rest(s_1, s_4, wv_b, wv_c_right))
    pitch = g3 * wv
    g3_lo = where(far_x_a, g3b_lo,
        (closed3_numerator - closed3 * (far_x - (far_x_sum - far_x_sum_right) + (far_x_lo -
            far_x_sum_right))) / far_x_sum)
    pitch_lo = (product_error(g3, wv, pitch)
        + (g3_lo * wv + g3
        * (wv_c - (wv - wv_right) + product_rest(s_2, s_5, wv_d, wv_right) + wv_c_lo)))
    along_0 = s_3 * pitch
    along_1 = s_4 * pitch
    along_2 = s_5 * pitch
    beta_v_0 = s_3 * g2
    beta_v_1 = s_4 * g2
    beta_v_2 = s_5 * g2
    beta_v_0_lo = product_error(s_3, g2, beta_v_0) + s_3 * g2_cross2
    m_0 = s_3 * beta_v_0
    m_0_cross2 = s_3 * beta_v_0_lo
    beta_v_1_lo = product_error(s_4, g2, beta_v_1) + s_4 * g2_cross2
    m_1 = s_4 * beta_v_1
    m_1_cross2 = s_4 * beta_v_1_lo
    m_2 = s_5 * beta_v_2
    m_2_cross2 = s_5 * (product_error(s_5, g2, beta_v_2) + s_5 * g2_cross2)
    m_3 = s_4 * beta_v_0
    m_3_cross2 = s_4 * beta_v_0_lo
    m_4 = s_5 * beta_v_0
    m_4_cross2 = s_5 * beta_v_0_lo
    m_5 = s_5 * beta_v_1
    m_5_cross2 = s_5 * beta_v_1_lo
    others_0 = m_1 + m_2
    others_0_right = others_0 - m_1
    others_0_lo1 = (product_rest(s_4, beta_v_1, m_1, others_0 - others_0_right)
        + product_rest(s_5, beta_v_2, m_2, others_0_right))
    others_0_lo = others_0_lo1 + (m_1_cross2 + m_2_cross2)
    others_1 = m_0 + m_2
    others_1_right = others_1 - m_0
    others_1_lo1 = (product_rest(s_3, beta_v_0, m_0, others_1 - others_1_right)
        + product_rest(s_5, beta_v_2, m_2, others_1_right))
    others_1_lo = others_1_lo1 + (m_0_cross2 + m_2_cross2)
    others_2 = m_0 + m_1
    others_2_right = others_2 - m_0
    others_2_lo1 = (product_rest(s_3, beta_v_0, m_0, others_2 - others_2_right)
        + product_rest(s_4, beta_v_1, m_1, others_2_right))
    others_2_lo = others_2_lo1 + (m_0_cross2 + m_1_cross2)
    diagonal0a = 1 - others_0
    diagonal0a_right = 1 - diagonal0a
    diagonal0b = g0 + m_0
    diagonal0b_right = diagonal0b - g0
    diagonal0c = m_0 + (product_error(s_3, beta_v_0, m_0) + m_0_cross2) < others_0 + others_0_lo
    diagonal0 = where(diagonal0c, diagonal0b, diagonal0a)
    diagonal0b_lo = (g0 - (diagonal0b - diagonal0b_right)
        + product_rest(s_3, beta_v_0, m_0, diagonal0b_right) + m_0_cross2 + g0_lo)
    diagonal1a = 1 - others_1
    diagonal1a_right = 1 - diagonal1a
    diagonal1b = g0 + m_1
    diagonal1b_right = diagonal1b - g0
    diagonal1c = m_1 + (product_error(s_4, beta_v_1, m_1) + m_1_cross2) < others_1 + others_1_lo
    diagonal1 = where(diagonal1c, diagonal1b, diagonal1a)
    diagonal1b_lo = (g0 - (diagonal1b - diagonal1b_right)
        + product_rest(s_4, beta_v_1, m_1, diagonal1b_right) + m_1_cross2 + g0_lo)
    diagonal2a = 1 - others_2
    diagonal2a_right = 1 - diagonal2a
    diagonal2b = g0 + m_2
    diagonal2b_right = diagonal2b - g0
    diagonal2c = m_2 + (product_error(s_5, beta_v_2, m_2) + m_2_cross2) < others_2 + others_2_lo
    diagonal2 = where(diagonal2c, diagonal2b, diagonal2a)
    diagonal2b_lo = (g0 - (diagonal2b - diagonal2b_right)
        + product_rest(s_5, beta_v_2, m_2, diagonal2b_right) + m_2_cross2 + g0_lo)
    g1_lo = product_error(c, sinc, g1) + g1_cross
    alpha_v_0 = s_3 * g1
    alpha_v_0_cross2 = s_3 * g1_lo
    alpha_v_1 = s_4 * g1
    alpha_v_1_cross2 = s_4 * g1_lo
    alpha_v_2 = s_5 * g1
    alpha_v_2_cross2 = s_5 * g1_lo
    across_axis_0 = turned_0 + along_0
    across_axis_0_right = across_axis_0 - turned_0
    turned_0_cross = (g2_cross2 * u_0 + g2
        * (product_rest(s_2, s_4, u_0a, u_0 + u_0_right) - product_rest(s_1, s_5, u_0b, u_0_right)))
    across_axis_0_lo1 = (product_rest(g2, u_0, turned_0, across_axis_0 - across_axis_0_right)
        + product_rest(s_3, pitch, along_0, across_axis_0_right))
    across_axis_1 = turned_1 + along_1
    across_axis_1_right = across_axis_1 - turned_1
    turned_1_cross = (g2_cross2 * u_1 + g2
        * (product_rest(s_0, s_5, u_1a, u_1 + u_1_right) - product_rest(s_2, s_3, u_1b, u_1_right)))
    across_axis_1_lo1 = (product_rest(g2, u_1, turned_1, across_axis_1 - across_axis_1_right)
        + product_rest(s_4, pitch, along_1, across_axis_1_right))
    across_axis_2 = turned_2 + along_2
    across_axis_2_right = across_axis_2 - turned_2
    turned_2_cross = (g2_cross2 * u_2 + g2
        * (product_rest(s_1, s_3, u_2a, u_2 + u_2_right) - product_rest(s_0, s_4, u_2b, u_2_right)))
    across_axis_2_lo1 = (product_rest(g2, u_2, turned_2, across_axis_2 - across_axis_2_right)
        + product_rest(s_5, pitch, along_2, across_axis_2_right))
    D_01 = m_3 - alpha_v_2
    D_01_right = m_3 - D_01
    D_02 = m_4 + alpha_v_1
    D_02_right = D_02 - m_4
    D_03a = s_0 * g1
    D_03 = D_03a + across_axis_0
    D_03_right = D_03 - D_03a
    D_03_lo2 = (product_rest(s_0, g1, D_03a, D_03 - D_03_right) + (across_axis_0 - D_03_right)
        + (across_axis_0_lo1 + (turned_0_cross + s_3 * pitch_lo)))
    D_10 = m_3 + alpha_v_2
    D_10_right = D_10 - m_3
    D_12 = m_5 - alpha_v_0
    D_12_right = m_5 - D_12
    D_13a = s_1 * g1
    D_13 = D_13a + across_axis_1
    D_13_right = D_13 - D_13a
    D_13_lo2 = (product_rest(s_1, g1, D_13a, D_13 - D_13_right) + (across_axis_1 - D_13_right)
        + (across_axis_1_lo1 + (turned_1_cross + s_4 * pitch_lo)))
    D_20 = m_4 - alpha_v_1
    D_20_right = m_4 - D_20
    D_21 = m_5 + alpha_v_0
    D_21_right = D_21 - m_5
    D_23a = s_2 * g1
    D_23 = D_23a + across_axis_2
    D_23_right = D_23 - D_23a
    D_23_lo2 = (product_rest(s_2, g1, D_23a, D_23 - D_23_right) + (across_axis_2 - D_23_right)
        + (across_axis_2_lo1 + (turned_2_cross + s_5 * pitch_lo)))
    diagonal0_rounded = (diagonal0
        + where(diagonal0c, diagonal0b_lo, 1 - (diagonal0a + diagonal0a_right)
        - (others_0 - diagonal0a_right) - others_0_lo))
    D_01_lo = (product_rest(s_4, beta_v_0, m_3, D_01 + D_01_right)
        - product_rest(s_5, g1, alpha_v_2, D_01_right) + (m_3_cross2 - alpha_v_2_cross2))
    D_01_rounded = D_01 + D_01_lo
    D_02_lo = (product_rest(s_5, beta_v_0, m_4, D_02 - D_02_right)
        + product_rest(s_4, g1, alpha_v_1, D_02_right) + (m_4_cross2 + alpha_v_1_cross2))
    D_02_rounded = D_02 + D_02_lo
    D_03_rounded = D_03 + (D_03_lo2 + s_0 * g1_lo)
    D_10_lo = (product_rest(s_4, beta_v_0, m_3, D_10 - D_10_right)
        + product_rest(s_5, g1, alpha_v_2, D_10_right) + (m_3_cross2 + alpha_v_2_cross2))
    D_10_rounded = D_10 + D_10_lo
    diagonal1_rounded = (diagonal1
        + where(diagonal1c, diagonal1b_lo, 1 - (diagonal1a + diagonal1a_right)
        - (others_1 - diagonal1a_right) - others_1_lo))
    D_12_lo = (product_rest(s_5, beta_v_1, m_5, D_12 + D_12_right)
        - product_rest(s_3, g1, alpha_v_0, D_12_right) + (m_5_cross2 - alpha_v_0_cross2))
    D_12_rounded = D_12 + D_12_lo
    D_13_rounded = D_13 + (D_13_lo2 + s_1 * g1_lo)
    D_20_lo = (product_rest(s_5, beta_v_0, m_4, D_20 + D_20_right)
        - product_rest(s_4, g1, alpha_v_1, D_20_right) + (m_4_cross2 - alpha_v_1_cross2))
    D_20_rounded = D_20 + D_20_lo
    D_21_lo = (product_rest(s_5, beta_v_1, m_5, D_21 - D_21_right)
        + product_rest(s_3, g1, alpha_v_0, D_21_right) + (m_5_cross2 + alpha_v_0_cross2))
    D_21_rounded = D_21 + D_21_lo
    diagonal2_rounded = (diagonal2
        + where(diagonal2c, diagonal2b_lo, 1 - (diagonal2a + diagonal2a_right)
        - (others_2 - diagonal2a_right) - others_2_lo))
    D_23_rounded = D_23 + (D_23_lo2 + s_2 * g1_lo)
    diagonal0_final = where(diagonal0_rounded == diagonal0_rounded, diagonal0_rounded, diagonal0)
    D_01_final = where(D_01_rounded == D_01_rounded, D_01_rounded, D_01)
    D_02_final = where(D_02_rounded == D_02_rounded, D_02_rounded, D_02)
    D_03_final = where(D_03_rounded == D_03_rounded, D_03_rounded, D_03)
    D_10_final = where(D_10_rounded == D_10_rounded, D_10_rounded, D_10)
    diagonal1_final = where(diagonal1_rounded == diagonal1_rounded, diagonal1_rounded, diagonal1)
    D_12_final = where(D_12_rounded == D_12_rounded, D_12_rounded, D_12)
    D_13_final = where(D_13_rounded == D_13_rounded, D_13_rounded, D_13)
    D_20_final = where(D_20_rounded == D_20_rounded, D_20_rounded, D_20)
    D_21_final = where(D_21_rounded == D_21_rounded, D_21_rounded, D_21)
    diagonal2_final = where(diagonal2_rounded == diagonal2_rounded, diagonal2_rounded, diagonal2)
    D_23_final = where(D_23_rounded == D_23_rounded, D_23_rounded, D_23)
    return (diagonal0_final, D_01_final, D_02_final, D_03_final, D_10_final, diagonal1_final,
        D_12_final, D_13_final, D_20_final, D_21_final, diagonal2_final, D_23_final)


@kernel("(3,4)->(6)")
def SE3_log(D):
    """so with exp so = D, |ω| <= π: (J_l(ω)^-1 t; ω), ω = log R.

    (3,4)->(6).  D: displacement [R | t], R rotation, t in m; so: screw (v in m/s; ω in rad/s).
    285 mul, 748 add, 36 product error, 36 product rest, 23 div, 2 sqrt, 12 neg, 14 abs, 4
    copysign, 32 less, 13 equal, 88 select.  Error <= lin: 1 u, ang: 1 u of its largest
    component for R of D a rotation; searched, not proved.  Each component is within 1 ulp as
    long as its condition is below 1e13; in single precision it is the nearest number, except
    near ties, as long as that is below 1e5; searched, not proved.  Intermediate sums may
    overflow where |t| is above 2e306, in single precision 5e36.
    """
    D_00, D_01, D_02, D_03, D_10, D_11, D_12, D_13, D_20, D_21, D_22, D_23 = D
    p_0 = D_21 - D_12
    p_0_right = D_21 - p_0
    p_0_lo = D_21 - (p_0 + p_0_right) - (D_12 - p_0_right)
    p_1 = D_02 - D_20
    p_1_right = D_02 - p_1
    p_1_lo = D_02 - (p_1 + p_1_right) - (D_20 - p_1_right)
    p_2 = D_10 - D_01
    p_2_right = D_10 - p_2
    p_2_lo = D_10 - (p_2 + p_2_right) - (D_01 - p_2_right)
    s_0 = D_12 + D_21
    s_0_right = s_0 - D_12
    s_0_lo = D_12 - (s_0 - s_0_right) + (D_21 - s_0_right)
    s_1 = D_02 + D_20
    s_1_right = s_1 - D_02
    s_1_lo = D_02 - (s_1 - s_1_right) + (D_20 - s_1_right)
    s_2 = D_01 + D_10
    s_2_right = s_2 - D_01
    s_2_lo = D_01 - (s_2 - s_2_right) + (D_10 - s_2_right)
    first_0 = D_00 + 1
    first_0_right = first_0 - D_00
    first_0_lo = D_00 - (first_0 - first_0_right) + (1 - first_0_right)
    first_1 = 1 - D_00
    first_1_right = 1 - first_1
    first_1_lo = 1 - (first_1 + first_1_right) - (D_00 - first_1_right)
    others_0 = D_11 + D_22
    others_0_right = others_0 - D_11
    others_0_lo = D_11 - (others_0 - others_0_right) + (D_22 - others_0_right)
    others_1 = D_11 - D_22
    others_1_right = D_11 - others_1
    others_1_lo = D_11 - (others_1 + others_1_right) - (D_22 - others_1_right)
    d_0 = first_0 + others_0
    d_0_right = d_0 - first_0
    d_1 = first_0 - others_0
    d_1_right = first_0 - d_1
    d_2 = first_1 + others_1
    d_2_right = d_2 - first_1
    d_3 = first_1 - others_1
    d_3_right = first_1 - d_3
    low_0a = D_11 < D_00
    low_0 = where(low_0a, d_1, s_2)
    low_1 = where(low_0a, s_2, d_2)
    low_2 = where(low_0a, s_1, s_0)
    low_3 = where(low_0a, p_0, p_1)
    high_0b = D_00 < -D_11
    high_0 = where(high_0b, s_1, p_0)
    high_1 = where(high_0b, s_0, p_1)
    high_2 = where(high_0b, d_3, p_2)
    high_3 = where(high_0b, p_2, d_0)
    column_0a = D_22 < 0
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
    upper_3 = absolute(column_3_sum)
    upper_3_lo = where(column_3_sum < 0, -column_3_sum_lo, column_3_sum_lo)
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
    upper_3_sum_lo = upper_3 - (upper_3_sum - upper_3_sum_right) + (upper_3_lo - upper_3_sum_right)
    half = elementary.atan2(n_sum, upper_3_sum)
    half_size0 = absolute(n_sum)
    half_size1 = absolute(upper_3_sum)
    half_most = where(half_size0 < half_size1, half_size1, half_size0)
    half_zero = half_most == 0
    half_divisor = where(half_zero, 1, half_most)
    half_part0 = n_sum / half_divisor
    half_part1 = upper_3_sum / half_divisor
    half_safe = where(half_zero, 1,
        half_divisor * (half_part1 * half_part1 + half_part0 * half_part0))
    divisor_a = n_sum == 0
    divisor = where(divisor_a, 1, n_sum)
    divisor_lo = where(divisor_a, 0, n_sum_lo)
    theta = 2 * half
    theta_cross2 = (2
        * (elementary.atan2_error(n_sum, upper_3_sum, half)
        + (half_part1 * n_sum_lo - half_part0 * upper_3_sum_lo) / half_safe))
    theta_sum = theta + theta_cross2
    theta_sum_right = theta_sum - theta
    theta_sum_lo = theta - (theta_sum - theta_sum_right) + (theta_cross2 - theta_sum_right)
    divisor_sum = divisor + divisor_lo
    divisor_sum_right = divisor_sum - divisor
    k = theta_sum / divisor_sum
    k_product = k * divisor_sum
    k_cross = k * (divisor - (divisor_sum - divisor_sum_right) + (divisor_lo - divisor_sum_right))
    k_lo = ((theta_sum - k_product - product_error(k, divisor_sum, k_product) + theta_sum_lo
        - k_cross) / divisor_sum)
    vector_0 = upper_0_sum * k
    vector_1 = upper_1_sum * k
    vector_2 = upper_2_sum * k
    half_angle = 0.5 * theta_sum
    half_angle_cross2 = 0.5 * theta_sum_lo
    length_a = n_sum * n_sum
    length_b = upper_3_sum * upper_3_sum
    length_c = length_a + length_b
    length_c_right = length_c - length_a
    length_c_lo1 = (product_rest(n_sum, n_sum, length_a, length_c - length_c_right)
        + product_rest(upper_3_sum, upper_3_sum, length_b, length_c_right))
    length_c_lo = (length_c_lo1
        + (n_sum_lo * n_sum + n_sum * n_sum_lo
        + (upper_3_sum_lo * upper_3_sum + upper_3_sum * upper_3_sum_lo)))
    length_c_sum = length_c + length_c_lo
    length_c_sum_right = length_c_sum - length_c
    length = sqrt(length_c_sum)
    length_product = length * length
    length_c_sum_lo = (length_c - (length_c_sum - length_c_sum_right)
        + (length_c_lo - length_c_sum_right))
    length_lo = ((length_c_sum - length_product - product_error(length, length, length_product)
        + length_c_sum_lo) / where(length == 0, 1, length + length))
    length_sum = length + length_lo
    length_sum_right = length_sum - length
    length_sum_lo = length - (length_sum - length_sum_right) + (length_lo - length_sum_right)
    sine = n_sum / length_sum
    sine_product = sine * length_sum
    sine_lo = ((n_sum - sine_product - product_error(sine, length_sum, sine_product) + n_sum_lo
        - sine * length_sum_lo) / length_sum)
    c = upper_3_sum / length_sum
    c_product = c * length_sum
    c_lo = ((upper_3_sum - c_product - product_error(c, length_sum, c_product) + upper_3_sum_lo - c
        * length_sum_lo) / length_sum)
    y = half_angle * half_angle
    half_angle_sum = half_angle + half_angle_cross2
    half_angle_sum_right = half_angle_sum - half_angle
    sinc_divisor_a = half_angle_sum < 1.4901161193847656e-08
    sinc_divisor = where(sinc_divisor_a, 1.4901161193847656e-08, half_angle_sum)
    sinc_divisor_lo = where(sinc_divisor_a, 0,
        half_angle - (half_angle_sum - half_angle_sum_right) + (half_angle_cross2 -
            half_angle_sum_right))
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
    y_lo = (product_error(half_angle, half_angle, y)
        + (half_angle_cross2 * half_angle + half_angle * half_angle_cross2))
    sinc_a = 0.16666666666666666 * y
    sinc_b = 1 - sinc_a
    sinc_b_right = 1 - sinc_b
    sinc_b_lo1 = (1 - (sinc_b + sinc_b_right)
        - product_rest(0.16666666666666666, y, sinc_a, sinc_b_right))
    sinc = where(sinc_divisor_a, sinc_b, sinc_quotient)
    sinc_quotient_lo = ((sinc_quotient_exact
        + (sine - (sine_sum - sine_sum_right) + (sine_lo - sine_sum_right)) - sinc_quotient_cross)
        / sinc_divisor_sum)
    sinc_lo = where(sinc_divisor_a,
        sinc_b_lo1 - (9.25185853854297e-18 * y + 0.16666666666666666 * y_lo), sinc_quotient_lo)
    series_phi_a = 5.107725174524775e-32 * y
    series_phi_b = 4.116826490666969e-29 - series_phi_a
    series_phi_b_right = 4.116826490666969e-29 - series_phi_b
    series_phi_b_right_rest = product_rest(5.107725174524775e-32, y, series_phi_a,
        series_phi_b_right)
    series_phi_b_lo1 = (4.116826490666969e-29 - (series_phi_b + series_phi_b_right)
        - series_phi_b_right_rest)
    series_phi_c = y * series_phi_b
    series_phi_c_cross2 = (y
        * (series_phi_b_lo1 - (4.7410392187559056e-48 * y + 5.107725174524775e-32 * y_lo) +
        -1.8714974010023092e-45))
    series_phi_d = series_phi_c - 2.86531123750421e-26
    series_phi_d_right = series_phi_c - series_phi_d
    series_phi_d_lo1 = (product_rest(y, series_phi_b, series_phi_c, series_phi_d
        + series_phi_d_right) - (2.86531123750421e-26 - series_phi_d_right))
    series_phi_e = y * series_phi_d
    series_phi_f = series_phi_e + 1.701994875077501e-23
    series_phi_f_right = series_phi_f - series_phi_e
    series_phi_f_lo1 = (product_rest(y, series_phi_d, series_phi_e, series_phi_f
        - series_phi_f_right) + (1.701994875077501e-23 - series_phi_f_right))
    series_phi_e_cross = (y_lo * series_phi_d + y
        * (series_phi_d_lo1 - 2.3296034284323186e-42 + (y_lo * series_phi_b + series_phi_c_cross2)))
    series_phi_g = y * series_phi_f
    series_phi_h = series_phi_g - 8.509974375387505e-21
    series_phi_h_right = series_phi_g - series_phi_h
    series_phi_h_lo1 = (product_rest(y, series_phi_f, series_phi_g, series_phi_h
        + series_phi_h_right) - (8.509974375387505e-21 - series_phi_h_right))
    series_phi_g_cross = (y_lo * series_phi_f + y
        * (series_phi_f_lo1 + 3.161967936521494e-40 + series_phi_e_cross))
    series_phi_i = y * series_phi_h
    series_phi_j = series_phi_i + 3.523129391410427e-18
    series_phi_j_right = series_phi_j - series_phi_i
    series_phi_j_lo1 = (product_rest(y, series_phi_h, series_phi_i, series_phi_j
        - series_phi_j_right) + (3.523129391410427e-18 - series_phi_j_right))
    series_phi_i_cross = (y_lo * series_phi_h + y
        * (series_phi_h_lo1 - 3.2266760594119493e-37 + series_phi_g_cross))
    series_phi_k = y * series_phi_j
    series_phi_l = series_phi_k - 1.1837714755139035e-15
    series_phi_l_right = series_phi_k - series_phi_l
    series_phi_l_lo1 = (product_rest(y, series_phi_j, series_phi_k, series_phi_l
        + series_phi_l_right) - (1.1837714755139035e-15 - series_phi_l_right))
    series_phi_k_cross = (y_lo * series_phi_j + y
        * (series_phi_j_lo1 + -1.2521244741738012e-34 + series_phi_i_cross))
    series_phi_m = y * series_phi_l
    series_phi_n = series_phi_m + 3.148832124866983e-13
    series_phi_n_right = series_phi_n - series_phi_m
    series_phi_n_lo1 = (product_rest(y, series_phi_l, series_phi_m, series_phi_n
        - series_phi_n_right) + (3.148832124866983e-13 - series_phi_n_right))
    series_phi_m_cross = (y_lo * series_phi_l + y
        * (series_phi_l_lo1 - 7.23242424407352e-33 + series_phi_k_cross))
    series_phi_o = y * series_phi_n
    series_phi_p = series_phi_o - 6.423617534728645e-11
    series_phi_p_right = series_phi_o - series_phi_p
    series_phi_p_lo1 = (product_rest(y, series_phi_n, series_phi_o, series_phi_p
        + series_phi_p_right) - (6.423617534728645e-11 - series_phi_p_right))
    series_phi_o_cross = (y_lo * series_phi_n + y
        * (series_phi_n_lo1 + 5.8681293750286156e-30 + series_phi_m_cross))
    series_phi_q = y * series_phi_p
    series_phi_r = series_phi_q + 9.635426302092969e-09
    series_phi_r_right = series_phi_r - series_phi_q
    series_phi_r_lo1 = (product_rest(y, series_phi_p, series_phi_q, series_phi_r
        - series_phi_r_right) + (9.635426302092969e-09 - series_phi_r_right))
    series_phi_q_cross = (y_lo * series_phi_p + y
        * (series_phi_p_lo1 - 5.034117835500839e-27 + series_phi_o_cross))
    series_phi_s = y * series_phi_r
    series_phi_t = series_phi_s - 1.0020843354176687e-06
    series_phi_t_right = series_phi_s - series_phi_t
    series_phi_t_lo1 = (product_rest(y, series_phi_r, series_phi_s, series_phi_t
        + series_phi_t_right) - (1.0020843354176687e-06 - series_phi_t_right))
    series_phi_s_cross = (y_lo * series_phi_r + y
        * (series_phi_r_lo1 + -1.7546051379703029e-25 + series_phi_q_cross))
    series_phi_u = y * series_phi_t
    series_phi_v = series_phi_u + 6.613756613756614e-05
    series_phi_v_right = series_phi_v - series_phi_u
    series_phi_v_lo1 = (product_rest(y, series_phi_t, series_phi_u, series_phi_v
        - series_phi_v_right) + (6.613756613756614e-05 - series_phi_v_right))
    series_phi_u_cross = (y_lo * series_phi_t + y
        * (series_phi_t_lo1 - 4.7926555569351065e-23 + series_phi_s_cross))
    series_phi_w = y * series_phi_v
    series_phi_x = series_phi_w - 0.002380952380952381
    series_phi_x_right = series_phi_w - series_phi_x
    series_phi_x_lo1 = (product_rest(y, series_phi_v, series_phi_w, series_phi_x
        + series_phi_x_right) - (0.002380952380952381 - series_phi_x_right))
    series_phi_w_cross = (y_lo * series_phi_v + y
        * (series_phi_v_lo1 + -4.460143857711533e-21 + series_phi_u_cross))
    series_phi_y = y * series_phi_x
    series_phi = series_phi_y + 0.03333333333333333
    series_phi_right = series_phi - series_phi_y
    series_phi_lo1 = (product_rest(y, series_phi_x, series_phi_y, series_phi - series_phi_right)
        + (0.03333333333333333 - series_phi_right))
    f_more_a = 2 * y
    f_more = f_more_a * series_phi
    series_phi_lo = (series_phi_lo1 + 4.625929269271486e-19
        + (y_lo * series_phi_x + y
        * (series_phi_x_lo1 - -2.147752875018904e-19 + series_phi_w_cross)))
    near_f_a = 0.3333333333333333 * sinc
    near_f_b = 0.3333333333333333 * f_more
    near_f_b_cross2 = (0.3333333333333333
        * (product_error(f_more_a, series_phi, f_more)
        + (2 * y_lo * series_phi + f_more_a * series_phi_lo)))
    near_f = near_f_a + near_f_b
    near_f_right = near_f - near_f_a
    near_f_left_rest = product_rest(0.3333333333333333, sinc, near_f_a, near_f - near_f_right)
    near_f_cross = (1.850371707708594e-17 * sinc + 0.3333333333333333 * sinc_lo
        + (1.850371707708594e-17 * f_more + near_f_b_cross2))
    f_rest = sinc - c
    f_rest_right = sinc - f_rest
    f_rest_lo = sinc - (f_rest + f_rest_right) - (c - f_rest_right) - c_lo + sinc_lo
    x = 4 * y
    far_y_a = x + 4 * y_lo < 4
    far_y = where(far_y_a, 1, y)
    far_y_lo = where(far_y_a, 0, y_lo)
    f_rest_sum = f_rest + f_rest_lo
    f_rest_sum_right = f_rest_sum - f_rest
    far_y_sum = far_y + far_y_lo
    far_y_sum_right = far_y_sum - far_y
    closed_f = f_rest_sum / far_y_sum
    closed_f_product = closed_f * far_y_sum
    closed_f_exact = (f_rest_sum - closed_f_product
        - product_error(closed_f, far_y_sum, closed_f_product))
    closed_f_numerator = (closed_f_exact
        + (f_rest - (f_rest_sum - f_rest_sum_right) + (f_rest_lo - f_rest_sum_right)))
    f = where(far_y_a, near_f, closed_f)
    closed_f_lo = ((closed_f_numerator - closed_f
        * (far_y - (far_y_sum - far_y_sum_right) + (far_y_lo - far_y_sum_right))) / far_y_sum)
    f_lo = where(far_y_a, near_f_left_rest + product_rest(0.3333333333333333, f_more, near_f_b,
        near_f_right) + near_f_cross, closed_f_lo)
    four_k = 4 * sinc
    four_k_cross2 = 4 * sinc_lo
    f_sum = f + f_lo
    f_sum_right = f_sum - f
    four_k_sum = four_k + four_k_cross2
    four_k_sum_right = four_k_sum - four_k
    b = f_sum / four_k_sum
    b_product = b * four_k_sum
    b_numerator = (f_sum - b_product - product_error(b, four_k_sum, b_product)
        + (f - (f_sum - f_sum_right) + (f_lo - f_sum_right)))
    c_sum = c + c_lo
    c_sum_right = c_sum - c
    sinc_sum = sinc + sinc_lo
    sinc_sum_right = sinc_sum - sinc
    b_across = c_sum / sinc_sum
    b_across_product = b_across * sinc_sum
    b_across_exact = c_sum - b_across_product - product_error(b_across, sinc_sum, b_across_product)
    b_across_cross = b_across * (sinc - (sinc_sum - sinc_sum_right) + (sinc_lo - sinc_sum_right))
    b_across_lo = ((b_across_exact + (c - (c_sum - c_sum_right) + (c_lo - c_sum_right))
        - b_across_cross) / sinc_sum)
    vector_0_lo = (product_error(upper_0_sum, k, vector_0)
        + (upper_0_sum_lo * k + upper_0_sum * k_lo))
    wt_a = D_03 * vector_0
    vector_1_lo = (product_error(upper_1_sum, k, vector_1)
        + (upper_1_sum_lo * k + upper_1_sum * k_lo))
    wt_b = D_13 * vector_1
    wt_c = wt_a + wt_b
    wt_c_right = wt_c - wt_a
    wt_c_lo1 = (product_rest(D_03, vector_0, wt_a, wt_c - wt_c_right)
        + product_rest(D_13, vector_1, wt_b, wt_c_right))
    vector_2_lo = (product_error(upper_2_sum, k, vector_2)
        + (upper_2_sum_lo * k + upper_2_sum * k_lo))
    wt_d = D_23 * vector_2
    wt = wt_c + wt_d
    wt_right = wt - wt_c
    wt_lo2 = (wt_c - (wt - wt_right) + product_rest(D_23, vector_2, wt_d, wt_right) + D_23
        * vector_2_lo)
    pitch = b * wt
    pitch_cross1 = ((b_numerator - b
        * (four_k - (four_k_sum - four_k_sum_right) + (four_k_cross2 - four_k_sum_right)))
        / four_k_sum * wt)
    pitch_lo = (product_error(b, wt, pitch)
        + (pitch_cross1 + b * (wt_lo2 + (wt_c_lo1 + (D_03 * vector_0_lo + D_13 * vector_1_lo)))))
    along_0 = vector_0 * pitch
    along_1 = vector_1 * pitch
    along_2 = vector_2 * pitch
    u_0a = D_23 * vector_1
    u_0b = D_13 * vector_2
    u_0 = u_0a - u_0b
    u_0_right = u_0a - u_0
    u_0_lo1 = (product_rest(D_23, vector_1, u_0a, u_0 + u_0_right)
        - product_rest(D_13, vector_2, u_0b, u_0_right))
    u_1a = D_03 * vector_2
    u_1b = D_23 * vector_0
    u_1 = u_1a - u_1b
    u_1_right = u_1a - u_1
    u_1_lo1 = (product_rest(D_03, vector_2, u_1a, u_1 + u_1_right)
        - product_rest(D_23, vector_0, u_1b, u_1_right))
    u_2a = D_13 * vector_0
    u_2b = D_03 * vector_1
    u_2 = u_2a - u_2b
    u_2_right = u_2a - u_2
    u_2_lo1 = (product_rest(D_13, vector_0, u_2a, u_2 + u_2_right)
        - product_rest(D_03, vector_1, u_2b, u_2_right))
    turned_0 = 0.5 * u_0
    turned_1 = 0.5 * u_1
    turned_2 = 0.5 * u_2
    across_axis_0 = along_0 - turned_0
    across_axis_0_right = along_0 - across_axis_0
    across_axis_0_lo1 = (product_rest(vector_0, pitch, along_0, across_axis_0
        + across_axis_0_right) - (turned_0 - across_axis_0_right))
    across_axis_1 = along_1 - turned_1
    across_axis_1_right = along_1 - across_axis_1
    across_axis_1_lo1 = (product_rest(vector_1, pitch, along_1, across_axis_1
        + across_axis_1_right) - (turned_1 - across_axis_1_right))
    across_axis_2 = along_2 - turned_2
    across_axis_2_right = along_2 - across_axis_2
    across_axis_2_lo1 = (product_rest(vector_2, pitch, along_2, across_axis_2
        + across_axis_2_right) - (turned_2 - across_axis_2_right))
    so_0a = D_03 * b_across
    so_0 = so_0a + across_axis_0
    so_0_right = so_0 - so_0a
    across_axis_0_lo = (across_axis_0_lo1 - 0.5
        * (u_0_lo1 + (D_23 * vector_1_lo - D_13 * vector_2_lo))
        + (vector_0_lo * pitch + vector_0 * pitch_lo))
    so_1a = D_13 * b_across
    so_1 = so_1a + across_axis_1
    so_1_right = so_1 - so_1a
    across_axis_1_lo = (across_axis_1_lo1 - 0.5
        * (u_1_lo1 + (D_03 * vector_2_lo - D_23 * vector_0_lo))
        + (vector_1_lo * pitch + vector_1 * pitch_lo))
    so_2a = D_23 * b_across
    so_2 = so_2a + across_axis_2
    so_2_right = so_2 - so_2a
    across_axis_2_lo = (across_axis_2_lo1 - 0.5
        * (u_2_lo1 + (D_13 * vector_0_lo - D_03 * vector_1_lo))
        + (vector_2_lo * pitch + vector_2 * pitch_lo))
    so_0_rounded = (so_0
        + (product_rest(D_03, b_across, so_0a, so_0 - so_0_right) + (across_axis_0 - so_0_right)
        + across_axis_0_lo + D_03 * b_across_lo))
    so_1_rounded = (so_1
        + (product_rest(D_13, b_across, so_1a, so_1 - so_1_right) + (across_axis_1 - so_1_right)
        + across_axis_1_lo + D_13 * b_across_lo))
    so_2_rounded = (so_2
        + (product_rest(D_23, b_across, so_2a, so_2 - so_2_right) + (across_axis_2 - so_2_right)
        + across_axis_2_lo + D_23 * b_across_lo))
    vector_0_rounded = vector_0 + vector_0_lo
    vector_1_rounded = vector_1 + vector_1_lo
    vector_2_rounded = vector_2 + vector_2_lo
    so_0_final = where(so_0_rounded == so_0_rounded, so_0_rounded, so_0)
    so_1_final = where(so_1_rounded == so_1_rounded, so_1_rounded, so_1)
    so_2_final = where(so_2_rounded == so_2_rounded, so_2_rounded, so_2)
    vector_0_final = where(vector_0_rounded == vector_0_rounded, vector_0_rounded, vector_0)
    vector_1_final = where(vector_1_rounded == vector_1_rounded, vector_1_rounded, vector_1)
    vector_2_final = where(vector_2_rounded == vector_2_rounded, vector_2_rounded, vector_2)
    return (so_0_final, so_1_final, so_2_final, vector_0_final, vector_1_final, vector_2_final)


@kernel("(6)->(6,6)")
def SE3_leftJacobian(s):
    """M = J_l(s) = Σ ([ad](s))^k / (k+1)!.

    (6)->(6,6).  s: screw (v in m/s; ω in rad/s); M: 6×6 operator.
    321 mul, 819 add, 31 product error, 87 product rest, 10 div, 1 sqrt, 3 neg, 4 abs, 6 less,
    19 equal, 38 select.  Error <= M: 1 u of its largest component for |ω of s| <= π; searched,
    not proved.  Each component is within 1 ulp as long as its condition is below 1e13; in
    single precision it is the nearest number, except near ties, as long as that is below 1e5;
    searched, not proved.  Intermediate sums may overflow where |v| is above 2e306, in single
    precision 5e36.
    """
    s_0, s_1, s_2, s_3, s_4, s_5 = s
    halved_0 = 0.5 * s_3
    halved_1 = 0.5 * s_4
    halved_2 = 0.5 * s_5
    y_a = halved_0 * halved_0
    y_b = halved_1 * halved_1
    y_c = y_a + y_b
    y_c_right = y_c - y_a
    y_d = halved_2 * halved_2
    y = y_c + y_d
    y_right = y - y_c
    y_c_lo = (product_rest(halved_0, halved_0, y_a, y_c - y_c_right)
        + product_rest(halved_1, halved_1, y_b, y_c_right))
    y_lo = y_c - (y - y_right) + product_rest(halved_2, halved_2, y_d, y_right) + y_c_lo
    y_sum = y + y_lo
    y_sum_right = y_sum - y
    y_sum_lo = y - (y_sum - y_sum_right) + (y_lo - y_sum_right)
    half_angle = sqrt(y_sum)
    half_angle_product = half_angle * half_angle
    half_angle_residual = (y_sum - half_angle_product
        - product_error(half_angle, half_angle, half_angle_product) + y_sum_lo)
    half_angle_lo = half_angle_residual / where(half_angle == 0, 1, half_angle + half_angle)
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
    sinc_a = 0.16666666666666666 * y_sum
    sinc_b = 1 - sinc_a
    sinc_b_right = 1 - sinc_b
    sinc_b_lo1 = (1 - (sinc_b + sinc_b_right)
        - product_rest(0.16666666666666666, y_sum, sinc_a, sinc_b_right))
    sinc = where(sinc_divisor_a, sinc_b, sinc_quotient)
    sinc_quotient_lo = ((sinc_quotient_exact
        + (sine - (sine_sum - sine_sum_right) + (sine_lo - sine_sum_right)) - sinc_quotient_cross)
        / sinc_divisor_sum)
    sinc_lo = where(sinc_divisor_a,
        sinc_b_lo1 - (9.25185853854297e-18 * y_sum + 0.16666666666666666 * y_sum_lo),
        sinc_quotient_lo)
    g1 = c * sinc
    g1_cross = ((c_own_error - (sine_half_cos * sine + sine_half_sin * c) * sine_twice) * sinc + c
        * sinc_lo)
    g2a = sinc * sinc
    g2 = 0.5 * g2a
    g2_cross2 = 0.5 * (product_error(sinc, sinc, g2a) + (sinc_lo * sinc + sinc * sinc_lo))
    rest3 = 1 - g1
    rest3_right = 1 - rest3
    rest3_lo = 1 - (rest3 + rest3_right) - product_rest(c, sinc, g1, rest3_right) - g1_cross
    x = 4 * y_sum
    x_cross2 = 4 * y_sum_lo
    x_sum = x + x_cross2
    x_sum_right = x_sum - x
    x_sum_lo = x - (x_sum - x_sum_right) + (x_cross2 - x_sum_right)
    far_x_a = x_sum < 1
    far_x = where(far_x_a, 1, x_sum)
    far_x_lo = where(far_x_a, 0, x_sum_lo)
    rest3_sum = rest3 + rest3_lo
    rest3_sum_right = rest3_sum - rest3
    far_x_sum = far_x + far_x_lo
    far_x_sum_right = far_x_sum - far_x
    far_x_sum_lo = far_x - (far_x_sum - far_x_sum_right) + (far_x_lo - far_x_sum_right)
    closed3 = rest3_sum / far_x_sum
    closed3_product = closed3 * far_x_sum
    closed3_exact = rest3_sum - closed3_product - product_error(closed3, far_x_sum, closed3_product)
    series5a = 1.216125041553518e-34 * x_sum
    series5b = 1.1309962886447716e-31 - series5a
    series5b_right = 1.1309962886447716e-31 - series5b
    series5b_lo1 = (1.1309962886447716e-31 - (series5b + series5b_right)
        - product_rest(1.216125041553518e-34, x_sum, series5a, series5b_right))
    series5c = x_sum * series5b
    series5c_cross2 = (x_sum
        * (series5b_lo1 - (5.586290567888806e-51 * x_sum + 1.216125041553518e-34 * x_sum_lo)
        + 1.0498015412959506e-47))
    series5d = series5c - 9.183689863795546e-29
    series5d_right = series5c - series5d
    series5d_lo2 = (product_rest(x_sum, series5b, series5c, series5d + series5d_right)
        - (9.183689863795546e-29 - series5d_right) - 1.4303150396787322e-45)
    series5e = x_sum * series5d
    series5f = series5e + 6.446950284384474e-26
    series5f_right = series5f - series5e
    series5f_lo2 = (product_rest(x_sum, series5d, series5e, series5f - series5f_right)
        + (6.446950284384474e-26 - series5f_right) + -1.9330404233703465e-42)
    series5g = x_sum * series5f
    series5g_cross2 = (x_sum
        * (series5f_lo2
        + (x_sum_lo * series5d + x_sum * (series5d_lo2 + (x_sum_lo * series5b + series5c_cross2)))))
    series5h = series5g - 3.868170170630684e-23
    series5h_right = series5g - series5h
    series5h_lo2 = (product_rest(x_sum, series5f, series5g, series5h + series5h_right)
        - (3.868170170630684e-23 - series5h_right) - -8.843177655482344e-40)
    series5i = x_sum * series5h
    series5j = series5i + 1.9572941063391263e-20
    series5j_right = series5j - series5i
    series5j_lo1 = (product_rest(x_sum, series5h, series5i, series5j - series5j_right)
        + (1.9572941063391263e-20 - series5j_right))
    series5k = x_sum * series5j
    series5j_lo = (series5j_lo1 + -1.3643503830087908e-36
        + (x_sum_lo * series5h + x_sum * (series5h_lo2 + (x_sum_lo * series5f + series5g_cross2))))
    series5l = series5k - 8.22063524662433e-18
    series5l_right = series5k - series5l
    series5l_lo2 = (product_rest(x_sum, series5j, series5k, series5l + series5l_right)
        - (8.22063524662433e-18 - series5l_right) - 2.2141894119604265e-34)
    series5m = x_sum * series5l
    series5n = series5m + 2.8114572543455206e-15
    series5n_right = series5n - series5m
    series5n_lo2 = (product_rest(x_sum, series5l, series5m, series5n - series5n_right)
        + (2.8114572543455206e-15 - series5n_right) + 1.6508842730861433e-31)
    series5o = x_sum * series5n
    series5o_cross2 = (x_sum
        * (series5n_lo2
        + (x_sum_lo * series5l + x_sum
        * (series5l_lo2 + (x_sum_lo * series5j + x_sum * series5j_lo)))))
    series5p = series5o - 7.647163731819816e-13
    series5p_right = series5o - series5p
    series5p_lo2 = (product_rest(x_sum, series5n, series5o, series5p + series5p_right)
        - (7.647163731819816e-13 - series5p_right) - 7.03872877733453e-30)
    series5q = x_sum * series5p
    series5r = series5q + 1.6059043836821613e-10
    series5r_right = series5r - series5q
    series5r_lo2 = (product_rest(x_sum, series5p, series5q, series5r - series5r_right)
        + (1.6059043836821613e-10 - series5r_right) + 1.2585294588752098e-26)
    series5s = x_sum * series5r
    series5s_cross2 = (x_sum
        * (series5r_lo2
        + (x_sum_lo * series5p + x_sum * (series5p_lo2 + (x_sum_lo * series5n + series5o_cross2)))))
    series5t = series5s - 2.505210838544172e-08
    series5t_right = series5s - series5t
    series5t_lo2 = (product_rest(x_sum, series5r, series5s, series5t + series5t_right)
        - (2.505210838544172e-08 - series5t_right) - -1.448814070935912e-24)
    series5u = x_sum * series5t
    series5v = series5u + 2.7557319223985893e-06
    series5v_right = series5v - series5u
    series5v_lo2 = (product_rest(x_sum, series5t, series5u, series5v - series5v_right)
        + (2.7557319223985893e-06 - series5v_right) + -1.858393274046472e-22)
    series5w = x_sum * series5v
    series5w_cross2 = (x_sum
        * (series5v_lo2
        + (x_sum_lo * series5t + x_sum * (series5t_lo2 + (x_sum_lo * series5r + series5s_cross2)))))
    series5x = series5w - 0.0001984126984126984
    series5x_right = series5w - series5x
    series5x_lo2 = (product_rest(x_sum, series5v, series5w, series5x + series5x_right)
        - (0.0001984126984126984 - series5x_right) - 1.7209558293420705e-22)
    series5y = x_sum * series5x
    series5 = series5y + 0.008333333333333333
    series5_right = series5 - series5y
    series5_lo2 = (product_rest(x_sum, series5x, series5y, series5 - series5_right)
        + (0.008333333333333333 - series5_right) + 1.1564823173178714e-19)
    series5_lo = (series5_lo2
        + (x_sum_lo * series5x + x_sum * (series5x_lo2 + (x_sum_lo * series5v + series5w_cross2))))
    g3a = x_sum * series5
    g3b = 0.16666666666666666 - g3a
    g3b_right = 0.16666666666666666 - g3b
    g3b_lo2 = (0.16666666666666666 - (g3b + g3b_right)
        - product_rest(x_sum, series5, g3a, g3b_right) - (x_sum_lo * series5 + x_sum * series5_lo))
    g3 = where(far_x_a, g3b, closed3)
    closed3_lo = ((closed3_exact
        + (rest3 - (rest3_sum - rest3_sum_right) + (rest3_lo - rest3_sum_right)) - closed3
        * far_x_sum_lo) / far_x_sum)
    g3_lo = where(far_x_a, g3b_lo2 + 9.25185853854297e-18, closed3_lo)
    rest4 = 0.5 - g2
    rest4_right = 0.5 - rest4
    rest4_lo = 0.5 - (rest4 + rest4_right) - (g2 - rest4_right) - g2_cross2
    rest4_sum = rest4 + rest4_lo
    rest4_sum_right = rest4_sum - rest4
    closed4 = rest4_sum / far_x_sum
    closed4_product = closed4 * far_x_sum
    closed4_exact = rest4_sum - closed4_product - product_error(closed4, far_x_sum, closed4_product)
    rest5 = 0.16666666666666666 - g3
    rest5_right = 0.16666666666666666 - rest5
    rest5_lo = (0.16666666666666666 - (rest5 + rest5_right) - (g3 - rest5_right) - g3_lo
        + 9.25185853854297e-18)
    rest5_sum = rest5 + rest5_lo
    rest5_sum_right = rest5_sum - rest5
    closed5 = rest5_sum / far_x_sum
    closed5_product = closed5 * far_x_sum
    closed5_exact = rest5_sum - closed5_product - product_error(closed5, far_x_sum, closed5_product)
    series4a = 3.7699876288159054e-33 * x_sum
    series4b = 3.279889237069838e-30 - series4a
    series4b_right = 3.279889237069838e-30 - series4b
    series4b_lo1 = (3.279889237069838e-30 - (series4b + series4b_right)
        - product_rest(3.7699876288159054e-33, x_sum, series4a, series4b_right))
    series4c = x_sum * series4b
    series4c_cross2 = (x_sum
        * (series4b_lo1 - (2.5870347832750324e-49 * x_sum + 3.7699876288159054e-33 * x_sum_lo)
        + 1.5117542744029879e-46))
    series4d = series4c - 2.4795962632247976e-27
    series4d_right = series4c - series4d
    series4d_lo1 = (product_rest(x_sum, series4b, series4c, series4d + series4d_right)
        - (2.4795962632247976e-27 - series4d_right))
    series4e = x_sum * series4d
    series4f = series4e + 1.6117375710961184e-24
    series4f_right = series4f - series4e
    series4f_lo1 = (product_rest(x_sum, series4d, series4e, series4f - series4f_right)
        + (1.6117375710961184e-24 - series4f_right))
    series4e_cross = (x_sum_lo * series4d + x_sum
        * (series4d_lo1 - -1.2953730964765229e-43 + (x_sum_lo * series4b + series4c_cross2)))
    series4g = x_sum * series4f
    series4h = series4g - 8.896791392450574e-22
    series4h_right = series4g - series4h
    series4h_lo2 = (product_rest(x_sum, series4f, series4g, series4h + series4h_right)
        - (8.896791392450574e-22 - series4h_right) - -7.911402614872376e-38)
    series4i = x_sum * series4h
    series4i_cross2 = (x_sum
        * (series4h_lo2
        + (x_sum_lo * series4f + x_sum
        * (series4f_lo1 + -3.6846573564509766e-41 + series4e_cross))))
    series4j = series4i + 4.110317623312165e-19
    series4j_right = series4j - series4i
    series4j_lo2 = (product_rest(x_sum, series4h, series4i, series4j - series4j_right)
        + (4.110317623312165e-19 - series4j_right) + 1.4412973378659527e-36)
    series4k = x_sum * series4j
    series4l = series4k - 1.5619206968586225e-16
    series4l_right = series4k - series4l
    series4l_lo2 = (product_rest(x_sum, series4j, series4k, series4l + series4l_right)
        - (1.5619206968586225e-16 - series4l_right) - 1.1910679660273754e-32)
    series4m = x_sum * series4l
    series4m_cross2 = (x_sum
        * (series4l_lo2
        + (x_sum_lo * series4j + x_sum * (series4j_lo2 + (x_sum_lo * series4h + series4i_cross2)))))
    series4n = series4m + 4.779477332387385e-14
    series4n_right = series4n - series4m
    series4n_lo2 = (product_rest(x_sum, series4l, series4m, series4n - series4n_right)
        + (4.779477332387385e-14 - series4n_right) + 4.399205485834081e-31)
    series4o = x_sum * series4n
    series4p = series4o - 1.1470745597729725e-11
    series4p_right = series4o - series4p
    series4p_lo2 = (product_rest(x_sum, series4n, series4o, series4p + series4p_right)
        - (1.1470745597729725e-11 - series4p_right) - 2.0655512752830745e-28)
    series4q = x_sum * series4p
    series4q_cross2 = (x_sum
        * (series4p_lo2
        + (x_sum_lo * series4n + x_sum * (series4n_lo2 + (x_sum_lo * series4l + series4m_cross2)))))
    series4r = series4q + 2.08767569878681e-09
    series4r_right = series4r - series4q
    series4r_lo2 = (product_rest(x_sum, series4p, series4q, series4r - series4r_right)
        + (2.08767569878681e-09 - series4r_right) + -1.20734505911326e-25)
    series4s = x_sum * series4r
    series4t = series4s - 2.755731922398589e-07
    series4t_right = series4s - series4t
    series4t_lo2 = (product_rest(x_sum, series4r, series4s, series4t + series4t_right)
        - (2.755731922398589e-07 - series4t_right) - 2.3767714622250297e-23)
    series4u = x_sum * series4t
    series4u_cross2 = (x_sum
        * (series4t_lo2
        + (x_sum_lo * series4r + x_sum * (series4r_lo2 + (x_sum_lo * series4p + series4q_cross2)))))
    series4v = series4u + 2.48015873015873e-05
    series4v_right = series4v - series4u
    series4v_lo2 = (product_rest(x_sum, series4t, series4u, series4v - series4v_right)
        + (2.48015873015873e-05 - series4v_right) + 2.1511947866775882e-23)
    series4w = x_sum * series4v
    series4x = series4w - 0.001388888888888889
    series4x_right = series4w - series4x
    series4x_lo2 = (product_rest(x_sum, series4v, series4w, series4x + series4x_right)
        - (0.001388888888888889 - series4x_right) - -5.300543954373577e-20)
    series4y = x_sum * series4x
    series4y_cross2 = (x_sum
        * (series4x_lo2
        + (x_sum_lo * series4v + x_sum * (series4v_lo2 + (x_sum_lo * series4t + series4u_cross2)))))
    series4 = series4y + 0.041666666666666664
    series4_right = series4 - series4y
    series4_lo2 = (product_rest(x_sum, series4x, series4y, series4 - series4_right)
        + (0.041666666666666664 - series4_right) + 2.3129646346357427e-18)
    g4 = where(far_x_a, series4, closed4)
    closed4_lo = ((closed4_exact
        + (rest4 - (rest4_sum - rest4_sum_right) + (rest4_lo - rest4_sum_right)) - closed4
        * far_x_sum_lo) / far_x_sum)
    g4_lo = where(far_x_a, series4_lo2 + (x_sum_lo * series4x + series4y_cross2), closed4_lo)
    g5 = where(far_x_a, series5, closed5)
    closed5_lo = ((closed5_exact
        + (rest5 - (rest5_sum - rest5_sum_right) + (rest5_lo - rest5_sum_right)) - closed5
        * far_x_sum_lo) / far_x_sum)
    rate2a = 2 * g4
    rate2 = rate2a - g3
    rate2_right = rate2a - rate2
    rate3a = 3 * g5
    rate3 = rate3a - g4
    rate3_right = rate3a - rate3
    beta_v_0 = s_3 * g3
    beta_v_1 = s_4 * g3
    beta_v_2 = s_5 * g3
    beta_v_0_lo = product_error(s_3, g3, beta_v_0) + s_3 * g3_lo
    m_0 = s_3 * beta_v_0
    m_0_cross2 = s_3 * beta_v_0_lo
    beta_v_1_lo = product_error(s_4, g3, beta_v_1) + s_4 * g3_lo
    m_1 = s_4 * beta_v_1
    m_1_cross2 = s_4 * beta_v_1_lo
    m_2 = s_5 * beta_v_2
    m_2_cross2 = s_5 * (product_error(s_5, g3, beta_v_2) + s_5 * g3_lo)
    m_3 = s_4 * beta_v_0
    m_3_cross2 = s_4 * beta_v_0_lo
    m_4 = s_5 * beta_v_0
    m_4_cross2 = s_5 * beta_v_0_lo
    m_5 = s_5 * beta_v_1
    m_5_cross2 = s_5 * beta_v_1_lo
    others_0 = m_1 + m_2
    others_0_right = others_0 - m_1
    others_0_lo1 = (product_rest(s_4, beta_v_1, m_1, others_0 - others_0_right)
        + product_rest(s_5, beta_v_2, m_2, others_0_right))
    others_0_lo = others_0_lo1 + (m_1_cross2 + m_2_cross2)
    others_1 = m_0 + m_2
    others_1_right = others_1 - m_0
    others_1_lo1 = (product_rest(s_3, beta_v_0, m_0, others_1 - others_1_right)
        + product_rest(s_5, beta_v_2, m_2, others_1_right))
    others_1_lo = others_1_lo1 + (m_0_cross2 + m_2_cross2)
    others_2 = m_0 + m_1
    others_2_right = others_2 - m_0
    others_2_lo1 = (product_rest(s_3, beta_v_0, m_0, others_2 - others_2_right)
        + product_rest(s_4, beta_v_1, m_1, others_2_right))
    others_2_lo = others_2_lo1 + (m_0_cross2 + m_1_cross2)
    diagonal0a = 1 - others_0
    diagonal0a_right = 1 - diagonal0a
    diagonal0b = g1 + m_0
    diagonal0b_right = diagonal0b - g1
    diagonal0b_lo1 = (product_rest(c, sinc, g1, diagonal0b - diagonal0b_right)
        + product_rest(s_3, beta_v_0, m_0, diagonal0b_right))
    diagonal0c = m_0 + (product_error(s_3, beta_v_0, m_0) + m_0_cross2) < others_0 + others_0_lo
    diagonal0 = where(diagonal0c, diagonal0b, diagonal0a)
    diagonal0a_lo = (1 - (diagonal0a + diagonal0a_right) - (others_0 - diagonal0a_right)
        - others_0_lo)
    diagonal1a = 1 - others_1
    diagonal1a_right = 1 - diagonal1a
    diagonal1b = g1 + m_1
    diagonal1b_right = diagonal1b - g1
    diagonal1b_lo1 = (product_rest(c, sinc, g1, diagonal1b - diagonal1b_right)
        + product_rest(s_4, beta_v_1, m_1, diagonal1b_right))
    diagonal1c = m_1 + (product_error(s_4, beta_v_1, m_1) + m_1_cross2) < others_1 + others_1_lo
    diagonal1 = where(diagonal1c, diagonal1b, diagonal1a)
    diagonal1a_lo = (1 - (diagonal1a + diagonal1a_right) - (others_1 - diagonal1a_right)
        - others_1_lo)
    diagonal2a = 1 - others_2
    diagonal2a_right = 1 - diagonal2a
    diagonal2b = g1 + m_2
    diagonal2b_right = diagonal2b - g1
    diagonal2b_lo1 = (product_rest(c, sinc, g1, diagonal2b - diagonal2b_right)
        + product_rest(s_5, beta_v_2, m_2, diagonal2b_right))
    diagonal2c = m_2 + (product_error(s_5, beta_v_2, m_2) + m_2_cross2) < others_2 + others_2_lo
    diagonal2 = where(diagonal2c, diagonal2b, diagonal2a)
    diagonal2a_lo = (1 - (diagonal2a + diagonal2a_right) - (others_2 - diagonal2a_right)
        - others_2_lo)
    alpha_v_0 = s_3 * g2
    alpha_v_0_cross2 = s_3 * g2_cross2
    alpha_v_1 = s_4 * g2
    alpha_v_1_cross2 = s_4 * g2_cross2
    alpha_v_2 = s_5 * g2
    alpha_v_2_cross2 = s_5 * g2_cross2
    J_1 = m_3 - alpha_v_2
    J_1_right = m_3 - J_1
    J_2 = m_4 + alpha_v_1
    J_2_right = J_2 - m_4
    J_3 = m_3 + alpha_v_2
    J_3_right = J_3 - m_3
    J_5 = m_5 - alpha_v_0
    J_5_right = m_5 - J_5
    J_6 = m_4 - alpha_v_1
    J_6_right = m_4 - J_6
    J_7 = m_5 + alpha_v_0
    J_7_right = J_7 - m_5
    rate_vw_a = s_0 * s_3
    rate_vw_b = s_1 * s_4
    rate_vw_c = rate_vw_a + rate_vw_b
    rate_vw_c_right = rate_vw_c - rate_vw_a
    rate_vw_d = s_2 * s_5
    rate_vw = rate_vw_c + rate_vw_d
    rate_vw_right = rate_vw - rate_vw_c
    rate_vw_c_lo = (product_rest(s_0, s_3, rate_vw_a, rate_vw_c - rate_vw_c_right)
        + product_rest(s_1, s_4, rate_vw_b, rate_vw_c_right))
    rate_vw_lo = (rate_vw_c - (rate_vw - rate_vw_right)
        + product_rest(s_2, s_5, rate_vw_d, rate_vw_right) + rate_vw_c_lo)
    rate_turn = rate2 * rate_vw
    rate3_lo = (product_rest(3, g5, rate3a, rate3 + rate3_right) - (g4 - rate3_right) - g4_lo + 3
        * where(far_x_a, series5_lo, closed5_lo))
    rate_bend = -(rate3 * rate_vw)
    rate_q_0a = s_0 * g2
    rate_turn_cross = ((rate2a - (rate2 + rate2_right) - (g3 - rate2_right) - g3_lo + 2 * g4_lo)
        * rate_vw + rate2 * rate_vw_lo)
    rate_turn_lo = product_error(rate2, rate_vw, rate_turn) + rate_turn_cross
    rate_q_0b = s_3 * rate_turn
    rate_q_0 = rate_q_0a + rate_q_0b
    rate_q_0_right = rate_q_0 - rate_q_0a
    rate_q_0_lo1 = (product_rest(s_0, g2, rate_q_0a, rate_q_0 - rate_q_0_right)
        + product_rest(s_3, rate_turn, rate_q_0b, rate_q_0_right))
    rate_q_0_lo = rate_q_0_lo1 + (s_0 * g2_cross2 + s_3 * rate_turn_lo)
    rate_q_1a = s_1 * g2
    rate_q_1b = s_4 * rate_turn
    rate_q_1 = rate_q_1a + rate_q_1b
    rate_q_1_right = rate_q_1 - rate_q_1a
    rate_q_1_lo1 = (product_rest(s_1, g2, rate_q_1a, rate_q_1 - rate_q_1_right)
        + product_rest(s_4, rate_turn, rate_q_1b, rate_q_1_right))
    rate_q_1_lo = rate_q_1_lo1 + (s_1 * g2_cross2 + s_4 * rate_turn_lo)
    rate_q_2a = s_2 * g2
    rate_q_2b = s_5 * rate_turn
    rate_q_2 = rate_q_2a + rate_q_2b
    rate_q_2_right = rate_q_2 - rate_q_2a
    rate_q_2_lo1 = (product_rest(s_2, g2, rate_q_2a, rate_q_2 - rate_q_2_right)
        + product_rest(s_5, rate_turn, rate_q_2b, rate_q_2_right))
    rate_q_2_lo = rate_q_2_lo1 + (s_2 * g2_cross2 + s_5 * rate_turn_lo)
    rate_beta_v_0 = s_0 * g3
    rate_beta_v_1 = s_1 * g3
    rate_beta_v_2 = s_2 * g3
    rate_bend_lo = (product_error(-rate3, rate_vw, rate_bend) +
        -(rate3_lo * rate_vw + rate3 * rate_vw_lo))
    rate_bend_w_0 = s_3 * rate_bend
    rate_bend_w_1 = s_4 * rate_bend
    rate_bend_w_2 = s_5 * rate_bend
    rate_beta_v_1_lo = product_error(s_1, g3, rate_beta_v_1) + s_1 * g3_lo
    rate_symmetric_0a = s_3 * rate_beta_v_1
    rate_beta_v_0_lo = product_error(s_0, g3, rate_beta_v_0) + s_0 * g3_lo
    rate_symmetric_0b = s_4 * rate_beta_v_0
    rate_symmetric_0c = rate_symmetric_0a + rate_symmetric_0b
    rate_symmetric_0c_right = rate_symmetric_0c - rate_symmetric_0a
    rate_symmetric_0c_left_rest = product_rest(s_3, rate_beta_v_1, rate_symmetric_0a,
        rate_symmetric_0c - rate_symmetric_0c_right)
    rate_symmetric_0c_lo1 = (rate_symmetric_0c_left_rest
        + product_rest(s_4, rate_beta_v_0, rate_symmetric_0b, rate_symmetric_0c_right))
    rate_bend_w_0_lo = product_error(s_3, rate_bend, rate_bend_w_0) + s_3 * rate_bend_lo
    rate_symmetric_0d = s_4 * rate_bend_w_0
    rate_symmetric_0 = rate_symmetric_0c - rate_symmetric_0d
    rate_symmetric_0_right = rate_symmetric_0c - rate_symmetric_0
    rate_symmetric_0_right_rest = product_rest(s_4, rate_bend_w_0, rate_symmetric_0d,
        rate_symmetric_0_right)
    rate_symmetric_0_lo2 = (rate_symmetric_0c - (rate_symmetric_0 + rate_symmetric_0_right)
        - rate_symmetric_0_right_rest - s_4 * rate_bend_w_0_lo)
    rate_symmetric_0_lo = (rate_symmetric_0_lo2
        + (rate_symmetric_0c_lo1 + (s_3 * rate_beta_v_1_lo + s_4 * rate_beta_v_0_lo)))
    rate_beta_v_2_lo = product_error(s_2, g3, rate_beta_v_2) + s_2 * g3_lo
    rate_symmetric_1a = s_3 * rate_beta_v_2
    rate_symmetric_1b = s_5 * rate_beta_v_0
    rate_symmetric_1c = rate_symmetric_1a + rate_symmetric_1b
    rate_symmetric_1c_right = rate_symmetric_1c - rate_symmetric_1a
    rate_symmetric_1c_left_rest = product_rest(s_3, rate_beta_v_2, rate_symmetric_1a,
        rate_symmetric_1c - rate_symmetric_1c_right)
    rate_symmetric_1c_lo1 = (rate_symmetric_1c_left_rest
        + product_rest(s_5, rate_beta_v_0, rate_symmetric_1b, rate_symmetric_1c_right))
    rate_symmetric_1d = s_5 * rate_bend_w_0
    rate_symmetric_1 = rate_symmetric_1c - rate_symmetric_1d
    rate_symmetric_1_right = rate_symmetric_1c - rate_symmetric_1
    rate_symmetric_1_right_rest = product_rest(s_5, rate_bend_w_0, rate_symmetric_1d,
        rate_symmetric_1_right)
    rate_symmetric_1_lo2 = (rate_symmetric_1c - (rate_symmetric_1 + rate_symmetric_1_right)
        - rate_symmetric_1_right_rest - s_5 * rate_bend_w_0_lo)
    rate_symmetric_1_lo = (rate_symmetric_1_lo2
        + (rate_symmetric_1c_lo1 + (s_3 * rate_beta_v_2_lo + s_5 * rate_beta_v_0_lo)))
    rate_symmetric_2a = s_4 * rate_beta_v_2
    rate_symmetric_2b = s_5 * rate_beta_v_1
    rate_symmetric_2c = rate_symmetric_2a + rate_symmetric_2b
    rate_symmetric_2c_right = rate_symmetric_2c - rate_symmetric_2a
    rate_symmetric_2c_left_rest = product_rest(s_4, rate_beta_v_2, rate_symmetric_2a,
        rate_symmetric_2c - rate_symmetric_2c_right)
    rate_symmetric_2c_lo1 = (rate_symmetric_2c_left_rest
        + product_rest(s_5, rate_beta_v_1, rate_symmetric_2b, rate_symmetric_2c_right))
    rate_bend_w_1_lo = product_error(s_4, rate_bend, rate_bend_w_1) + s_4 * rate_bend_lo
    rate_symmetric_2d = s_5 * rate_bend_w_1
    rate_symmetric_2 = rate_symmetric_2c - rate_symmetric_2d
    rate_symmetric_2_right = rate_symmetric_2c - rate_symmetric_2
    rate_symmetric_2_right_rest = product_rest(s_5, rate_bend_w_1, rate_symmetric_2d,
        rate_symmetric_2_right)
    rate_symmetric_2_lo2 = (rate_symmetric_2c - (rate_symmetric_2 + rate_symmetric_2_right)
        - rate_symmetric_2_right_rest - s_5 * rate_bend_w_1_lo)
    rate_symmetric_2_lo = (rate_symmetric_2_lo2
        + (rate_symmetric_2c_lo1 + (s_4 * rate_beta_v_2_lo + s_5 * rate_beta_v_1_lo)))
    rate_diagonal_0a = s_4 * rate_bend_w_1
    rate_diagonal_0a_cross2 = s_4 * rate_bend_w_1_lo
    rate_diagonal_0b = s_5 * rate_bend_w_2
    rate_diagonal_0b_cross2 = (s_5
        * (product_error(s_5, rate_bend, rate_bend_w_2) + s_5 * rate_bend_lo))
    rate_diagonal_0c = rate_diagonal_0a + rate_diagonal_0b
    rate_diagonal_0c_right = rate_diagonal_0c - rate_diagonal_0a
    rate_diagonal_0c_left_rest = product_rest(s_4, rate_bend_w_1, rate_diagonal_0a,
        rate_diagonal_0c - rate_diagonal_0c_right)
    rate_diagonal_0c_lo1 = (rate_diagonal_0c_left_rest
        + product_rest(s_5, rate_bend_w_2, rate_diagonal_0b, rate_diagonal_0c_right))
    rate_diagonal_0d = 2 * s_4
    rate_diagonal_0e = rate_diagonal_0d * rate_beta_v_1
    rate_diagonal_0e_cross2 = rate_diagonal_0d * rate_beta_v_1_lo
    rate_diagonal_0f = 2 * s_5
    rate_diagonal_0g = rate_diagonal_0f * rate_beta_v_2
    rate_diagonal_0g_cross2 = rate_diagonal_0f * rate_beta_v_2_lo
    rate_diagonal_0h = rate_diagonal_0e + rate_diagonal_0g
    rate_diagonal_0h_right = rate_diagonal_0h - rate_diagonal_0e
    rate_diagonal_0h_left_rest = product_rest(rate_diagonal_0d, rate_beta_v_1, rate_diagonal_0e,
        rate_diagonal_0h - rate_diagonal_0h_right)
    rate_diagonal_0h_lo1 = (rate_diagonal_0h_left_rest
        + product_rest(rate_diagonal_0f, rate_beta_v_2, rate_diagonal_0g, rate_diagonal_0h_right))
    rate_diagonal_0 = rate_diagonal_0c - rate_diagonal_0h
    rate_diagonal_0_right = rate_diagonal_0c - rate_diagonal_0
    rate_diagonal_0_lo1 = (rate_diagonal_0c - (rate_diagonal_0 + rate_diagonal_0_right)
        - (rate_diagonal_0h - rate_diagonal_0_right))
    rate_diagonal_0_lo2 = (rate_diagonal_0_lo1
        - (rate_diagonal_0h_lo1 + (rate_diagonal_0e_cross2 + rate_diagonal_0g_cross2)))
    rate_diagonal_1a = s_3 * rate_bend_w_0
    rate_diagonal_1a_cross2 = s_3 * rate_bend_w_0_lo
    rate_diagonal_1b = rate_diagonal_1a + rate_diagonal_0b
    rate_diagonal_1b_right = rate_diagonal_1b - rate_diagonal_1a
    rate_diagonal_1b_left_rest = product_rest(s_3, rate_bend_w_0, rate_diagonal_1a,
        rate_diagonal_1b - rate_diagonal_1b_right)
    rate_diagonal_1b_lo1 = (rate_diagonal_1b_left_rest
        + product_rest(s_5, rate_bend_w_2, rate_diagonal_0b, rate_diagonal_1b_right))
    rate_diagonal_1c = 2 * s_3
    rate_diagonal_1d = rate_diagonal_1c * rate_beta_v_0
    rate_diagonal_1d_cross2 = rate_diagonal_1c * rate_beta_v_0_lo
    rate_diagonal_1e = rate_diagonal_1d + rate_diagonal_0g
    rate_diagonal_1e_right = rate_diagonal_1e - rate_diagonal_1d
    rate_diagonal_1e_left_rest = product_rest(rate_diagonal_1c, rate_beta_v_0, rate_diagonal_1d,
        rate_diagonal_1e - rate_diagonal_1e_right)
    rate_diagonal_1e_lo1 = (rate_diagonal_1e_left_rest
        + product_rest(rate_diagonal_0f, rate_beta_v_2, rate_diagonal_0g, rate_diagonal_1e_right))
    rate_diagonal_1 = rate_diagonal_1b - rate_diagonal_1e
    rate_diagonal_1_right = rate_diagonal_1b - rate_diagonal_1
    rate_diagonal_1_lo1 = (rate_diagonal_1b - (rate_diagonal_1 + rate_diagonal_1_right)
        - (rate_diagonal_1e - rate_diagonal_1_right))
    rate_diagonal_1_lo2 = (rate_diagonal_1_lo1
        - (rate_diagonal_1e_lo1 + (rate_diagonal_1d_cross2 + rate_diagonal_0g_cross2)))
    rate_diagonal_2a = rate_diagonal_1a + rate_diagonal_0a
    rate_diagonal_2a_right = rate_diagonal_2a - rate_diagonal_1a
    rate_diagonal_2a_left_rest = product_rest(s_3, rate_bend_w_0, rate_diagonal_1a,
        rate_diagonal_2a - rate_diagonal_2a_right)
    rate_diagonal_2a_lo1 = (rate_diagonal_2a_left_rest
        + product_rest(s_4, rate_bend_w_1, rate_diagonal_0a, rate_diagonal_2a_right))
    rate_diagonal_2b = rate_diagonal_1d + rate_diagonal_0e
    rate_diagonal_2b_right = rate_diagonal_2b - rate_diagonal_1d
    rate_diagonal_2b_left_rest = product_rest(rate_diagonal_1c, rate_beta_v_0, rate_diagonal_1d,
        rate_diagonal_2b - rate_diagonal_2b_right)
    rate_diagonal_2b_lo1 = (rate_diagonal_2b_left_rest
        + product_rest(rate_diagonal_0d, rate_beta_v_1, rate_diagonal_0e, rate_diagonal_2b_right))
    rate_diagonal_2 = rate_diagonal_2a - rate_diagonal_2b
    rate_diagonal_2_right = rate_diagonal_2a - rate_diagonal_2
    rate_diagonal_2_lo1 = (rate_diagonal_2a - (rate_diagonal_2 + rate_diagonal_2_right)
        - (rate_diagonal_2b - rate_diagonal_2_right))
    rate_diagonal_2_lo2 = (rate_diagonal_2_lo1
        - (rate_diagonal_2b_lo1 + (rate_diagonal_1d_cross2 + rate_diagonal_0e_cross2)))
    M_04 = rate_symmetric_0 - rate_q_2
    M_04_right = rate_symmetric_0 - M_04
    M_05 = rate_q_1 + rate_symmetric_1
    M_05_right = M_05 - rate_q_1
    M_13 = rate_q_2 + rate_symmetric_0
    M_13_right = M_13 - rate_q_2
    M_15 = rate_symmetric_2 - rate_q_0
    M_15_right = rate_symmetric_2 - M_15
    M_23 = rate_symmetric_1 - rate_q_1
    M_23_right = rate_symmetric_1 - M_23
    M_24 = rate_q_0 + rate_symmetric_2
    M_24_right = M_24 - rate_q_0
    diagonal0_rounded = (diagonal0
        + where(diagonal0c, diagonal0b_lo1 + (g1_cross + m_0_cross2), diagonal0a_lo))
    diagonal0_final = where(diagonal0_rounded == diagonal0_rounded, diagonal0_rounded, diagonal0)
    J_1_lo = (product_rest(s_4, beta_v_0, m_3, J_1 + J_1_right)
        - product_rest(s_5, g2, alpha_v_2, J_1_right) + (m_3_cross2 - alpha_v_2_cross2))
    J_1_rounded = J_1 + J_1_lo
    J_1_final = where(J_1_rounded == J_1_rounded, J_1_rounded, J_1)
    J_2_lo = (product_rest(s_5, beta_v_0, m_4, J_2 - J_2_right)
        + product_rest(s_4, g2, alpha_v_1, J_2_right) + (m_4_cross2 + alpha_v_1_cross2))
    J_2_rounded = J_2 + J_2_lo
    J_2_final = where(J_2_rounded == J_2_rounded, J_2_rounded, J_2)
    rate_diagonal_0_rounded = (rate_diagonal_0
        + (rate_diagonal_0_lo2
        + (rate_diagonal_0c_lo1 + (rate_diagonal_0a_cross2 + rate_diagonal_0b_cross2))))
    M_04_rounded = (M_04
        + (rate_symmetric_0 - (M_04 + M_04_right) - (rate_q_2 - M_04_right) - rate_q_2_lo
        + rate_symmetric_0_lo))
    M_05_rounded = (M_05
        + (rate_q_1 - (M_05 - M_05_right) + (rate_symmetric_1 - M_05_right) + rate_symmetric_1_lo
        + rate_q_1_lo))
    J_3_lo = (product_rest(s_4, beta_v_0, m_3, J_3 - J_3_right)
        + product_rest(s_5, g2, alpha_v_2, J_3_right) + (m_3_cross2 + alpha_v_2_cross2))
    J_3_rounded = J_3 + J_3_lo
    J_3_final = where(J_3_rounded == J_3_rounded, J_3_rounded, J_3)
    diagonal1_rounded = (diagonal1
        + where(diagonal1c, diagonal1b_lo1 + (g1_cross + m_1_cross2), diagonal1a_lo))
    diagonal1_final = where(diagonal1_rounded == diagonal1_rounded, diagonal1_rounded, diagonal1)
    J_5_lo = (product_rest(s_5, beta_v_1, m_5, J_5 + J_5_right)
        - product_rest(s_3, g2, alpha_v_0, J_5_right) + (m_5_cross2 - alpha_v_0_cross2))
    J_5_rounded = J_5 + J_5_lo
    J_5_final = where(J_5_rounded == J_5_rounded, J_5_rounded, J_5)
    M_13_rounded = (M_13
        + (rate_q_2 - (M_13 - M_13_right) + (rate_symmetric_0 - M_13_right) + rate_symmetric_0_lo
        + rate_q_2_lo))
    rate_diagonal_1_rounded = (rate_diagonal_1
        + (rate_diagonal_1_lo2
        + (rate_diagonal_1b_lo1 + (rate_diagonal_1a_cross2 + rate_diagonal_0b_cross2))))
    M_15_rounded = (M_15
        + (rate_symmetric_2 - (M_15 + M_15_right) - (rate_q_0 - M_15_right) - rate_q_0_lo
        + rate_symmetric_2_lo))
    J_6_lo = (product_rest(s_5, beta_v_0, m_4, J_6 + J_6_right)
        - product_rest(s_4, g2, alpha_v_1, J_6_right) + (m_4_cross2 - alpha_v_1_cross2))
    J_6_rounded = J_6 + J_6_lo
    J_6_final = where(J_6_rounded == J_6_rounded, J_6_rounded, J_6)
    J_7_lo = (product_rest(s_5, beta_v_1, m_5, J_7 - J_7_right)
        + product_rest(s_3, g2, alpha_v_0, J_7_right) + (m_5_cross2 + alpha_v_0_cross2))
    J_7_rounded = J_7 + J_7_lo
    J_7_final = where(J_7_rounded == J_7_rounded, J_7_rounded, J_7)
    diagonal2_rounded = (diagonal2
        + where(diagonal2c, diagonal2b_lo1 + (g1_cross + m_2_cross2), diagonal2a_lo))
    diagonal2_final = where(diagonal2_rounded == diagonal2_rounded, diagonal2_rounded, diagonal2)
    M_23_rounded = (M_23
        + (rate_symmetric_1 - (M_23 + M_23_right) - (rate_q_1 - M_23_right) - rate_q_1_lo
        + rate_symmetric_1_lo))
    M_24_rounded = (M_24
        + (rate_q_0 - (M_24 - M_24_right) + (rate_symmetric_2 - M_24_right) + rate_symmetric_2_lo
        + rate_q_0_lo))
    rate_diagonal_2_rounded = (rate_diagonal_2
        + (rate_diagonal_2_lo2
        + (rate_diagonal_2a_lo1 + (rate_diagonal_1a_cross2 + rate_diagonal_0a_cross2))))
    rate_diagonal_0_final = where(rate_diagonal_0_rounded == rate_diagonal_0_rounded,
        rate_diagonal_0_rounded, rate_diagonal_0)
    M_04_final = where(M_04_rounded == M_04_rounded, M_04_rounded, M_04)
    M_05_final = where(M_05_rounded == M_05_rounded, M_05_rounded, M_05)
    M_13_final = where(M_13_rounded == M_13_rounded, M_13_rounded, M_13)
    rate_diagonal_1_final = where(rate_diagonal_1_rounded == rate_diagonal_1_rounded,
        rate_diagonal_1_rounded, rate_diagonal_1)
    M_15_final = where(M_15_rounded == M_15_rounded, M_15_rounded, M_15)
    M_23_final = where(M_23_rounded == M_23_rounded, M_23_rounded, M_23)
    M_24_final = where(M_24_rounded == M_24_rounded, M_24_rounded, M_24)
    rate_diagonal_2_final = where(rate_diagonal_2_rounded == rate_diagonal_2_rounded,
        rate_diagonal_2_rounded, rate_diagonal_2)
    return (diagonal0_final, J_1_final, J_2_final, rate_diagonal_0_final, M_04_final, M_05_final,
        J_3_final, diagonal1_final, J_5_final, M_13_final, rate_diagonal_1_final, M_15_final,
        J_6_final, J_7_final, diagonal2_final, M_23_final, M_24_final, rate_diagonal_2_final, 0, 0,
        0, diagonal0_final, J_1_final, J_2_final, 0, 0, 0, J_3_final, diagonal1_final, J_5_final, 0,
        0, 0, J_6_final, J_7_final, diagonal2_final)


@kernel("(6)->(6,6)")
def SE3_rightJacobian(s):
    """M = J_r(s) = Σ (-[ad](s))^k / (k+1)!.

    (6)->(6,6).  s: screw (v in m/s; ω in rad/s); M: 6×6 operator.
    321 mul, 819 add, 31 product error, 87 product rest, 10 div, 1 sqrt, 36 neg, 4 abs, 6 less,
    19 equal, 38 select.  Error <= M: 1 u of its largest component for |ω of s| <= π; searched,
    not proved.  Each component is within 1 ulp as long as its condition is below 1e13; in
    single precision it is the nearest number, except near ties, as long as that is below 1e5;
    searched, not proved.  Intermediate sums may overflow where |v| is above 2e306, in single
    precision 5e36.
    """
    s_0, s_1, s_2, s_3, s_4, s_5 = s
    halved_0 = 0.5 * s_3
    halved_1 = 0.5 * s_4
    halved_2 = 0.5 * s_5
    y_a = halved_0 * halved_0
    y_b = halved_1 * halved_1
    y_c = y_a + y_b
    y_c_right = y_c - y_a
    y_d = halved_2 * halved_2
    y = y_c + y_d
    y_right = y - y_c
    y_c_lo = (product_rest(halved_0, halved_0, y_a, y_c - y_c_right)
        + product_rest(halved_1, halved_1, y_b, y_c_right))
    y_lo = y_c - (y - y_right) + product_rest(halved_2, halved_2, y_d, y_right) + y_c_lo
    y_sum = y + y_lo
    y_sum_right = y_sum - y
    y_sum_lo = y - (y_sum - y_sum_right) + (y_lo - y_sum_right)
    half_angle = sqrt(y_sum)
    half_angle_product = half_angle * half_angle
    half_angle_residual = (y_sum - half_angle_product
        - product_error(half_angle, half_angle, half_angle_product) + y_sum_lo)
    half_angle_lo = half_angle_residual / where(half_angle == 0, 1, half_angle + half_angle)
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
    sinc_a = 0.16666666666666666 * y_sum
    sinc_b = 1 - sinc_a
    sinc_b_right = 1 - sinc_b
    sinc_b_lo1 = (1 - (sinc_b + sinc_b_right)
        - product_rest(0.16666666666666666, y_sum, sinc_a, sinc_b_right))
    sinc = where(sinc_divisor_a, sinc_b, sinc_quotient)
    sinc_quotient_lo = ((sinc_quotient_exact
        + (sine - (sine_sum - sine_sum_right) + (sine_lo - sine_sum_right)) - sinc_quotient_cross)
        / sinc_divisor_sum)
    sinc_lo = where(sinc_divisor_a,
        sinc_b_lo1 - (9.25185853854297e-18 * y_sum + 0.16666666666666666 * y_sum_lo),
        sinc_quotient_lo)
    g1 = c * sinc
    g1_cross = ((c_own_error - (sine_half_cos * sine + sine_half_sin * c) * sine_twice) * sinc + c
        * sinc_lo)
    g2a = sinc * sinc
    g2 = 0.5 * g2a
    g2_cross2 = 0.5 * (product_error(sinc, sinc, g2a) + (sinc_lo * sinc + sinc * sinc_lo))
    rest3 = 1 - g1
    rest3_right = 1 - rest3
    rest3_lo = 1 - (rest3 + rest3_right) - product_rest(c, sinc, g1, rest3_right) - g1_cross
    x = 4 * y_sum
    x_cross2 = 4 * y_sum_lo
    x_sum = x + x_cross2
    x_sum_right = x_sum - x
    x_sum_lo = x - (x_sum - x_sum_right) + (x_cross2 - x_sum_right)
    far_x_a = x_sum < 1
    far_x = where(far_x_a, 1, x_sum)
    far_x_lo = where(far_x_a, 0, x_sum_lo)
    rest3_sum = rest3 + rest3_lo
    rest3_sum_right = rest3_sum - rest3
    far_x_sum = far_x + far_x_lo
    far_x_sum_right = far_x_sum - far_x
    far_x_sum_lo = far_x - (far_x_sum - far_x_sum_right) + (far_x_lo - far_x_sum_right)
    closed3 = rest3_sum / far_x_sum
    closed3_product = closed3 * far_x_sum
    closed3_exact = rest3_sum - closed3_product - product_error(closed3, far_x_sum, closed3_product)
    series5a = 1.216125041553518e-34 * x_sum
    series5b = 1.1309962886447716e-31 - series5a
    series5b_right = 1.1309962886447716e-31 - series5b
    series5b_lo1 = (1.1309962886447716e-31 - (series5b + series5b_right)
        - product_rest(1.216125041553518e-34, x_sum, series5a, series5b_right))
    series5c = x_sum * series5b
    series5c_cross2 = (x_sum
        * (series5b_lo1 - (5.586290567888806e-51 * x_sum + 1.216125041553518e-34 * x_sum_lo)
        + 1.0498015412959506e-47))
    series5d = series5c - 9.183689863795546e-29
    series5d_right = series5c - series5d
    series5d_lo2 = (product_rest(x_sum, series5b, series5c, series5d + series5d_right)
        - (9.183689863795546e-29 - series5d_right) - 1.4303150396787322e-45)
    series5e = x_sum * series5d
    series5f = series5e + 6.446950284384474e-26
    series5f_right = series5f - series5e
    series5f_lo2 = (product_rest(x_sum, series5d, series5e, series5f - series5f_right)
        + (6.446950284384474e-26 - series5f_right) + -1.9330404233703465e-42)
    series5g = x_sum * series5f
    series5g_cross2 = (x_sum
        * (series5f_lo2
        + (x_sum_lo * series5d + x_sum * (series5d_lo2 + (x_sum_lo * series5b + series5c_cross2)))))
    series5h = series5g - 3.868170170630684e-23
    series5h_right = series5g - series5h
    series5h_lo2 = (product_rest(x_sum, series5f, series5g, series5h + series5h_right)
        - (3.868170170630684e-23 - series5h_right) - -8.843177655482344e-40)
    series5i = x_sum * series5h
    series5j = series5i + 1.9572941063391263e-20
    series5j_right = series5j - series5i
    series5j_lo1 = (product_rest(x_sum, series5h, series5i, series5j - series5j_right)
        + (1.9572941063391263e-20 - series5j_right))
    series5k = x_sum * series5j
    series5j_lo = (series5j_lo1 + -1.3643503830087908e-36
        + (x_sum_lo * series5h + x_sum * (series5h_lo2 + (x_sum_lo * series5f + series5g_cross2))))
    series5l = series5k - 8.22063524662433e-18
    series5l_right = series5k - series5l
    series5l_lo2 = (product_rest(x_sum, series5j, series5k, series5l + series5l_right)
        - (8.22063524662433e-18 - series5l_right) - 2.2141894119604265e-34)
    series5m = x_sum * series5l
    series5n = series5m + 2.8114572543455206e-15
    series5n_right = series5n - series5m
    series5n_lo2 = (product_rest(x_sum, series5l, series5m, series5n - series5n_right)
        + (2.8114572543455206e-15 - series5n_right) + 1.6508842730861433e-31)
    series5o = x_sum * series5n
    series5o_cross2 = (x_sum
        * (series5n_lo2
        + (x_sum_lo * series5l + x_sum
        * (series5l_lo2 + (x_sum_lo * series5j + x_sum * series5j_lo)))))
    series5p = series5o - 7.647163731819816e-13
    series5p_right = series5o - series5p
    series5p_lo2 = (product_rest(x_sum, series5n, series5o, series5p + series5p_right)
        - (7.647163731819816e-13 - series5p_right) - 7.03872877733453e-30)
    series5q = x_sum * series5p
    series5r = series5q + 1.6059043836821613e-10
    series5r_right = series5r - series5q
    series5r_lo2 = (product_rest(x_sum, series5p, series5q, series5r - series5r_right)
        + (1.6059043836821613e-10 - series5r_right) + 1.2585294588752098e-26)
    series5s = x_sum * series5r
    series5s_cross2 = (x_sum
        * (series5r_lo2
        + (x_sum_lo * series5p + x_sum * (series5p_lo2 + (x_sum_lo * series5n + series5o_cross2)))))
    series5t = series5s - 2.505210838544172e-08
    series5t_right = series5s - series5t
    series5t_lo2 = (product_rest(x_sum, series5r, series5s, series5t + series5t_right)
        - (2.505210838544172e-08 - series5t_right) - -1.448814070935912e-24)
    series5u = x_sum * series5t
    series5v = series5u + 2.7557319223985893e-06
    series5v_right = series5v - series5u
    series5v_lo2 = (product_rest(x_sum, series5t, series5u, series5v - series5v_right)
        + (2.7557319223985893e-06 - series5v_right) + -1.858393274046472e-22)
    series5w = x_sum * series5v
    series5w_cross2 = (x_sum
        * (series5v_lo2
        + (x_sum_lo * series5t + x_sum * (series5t_lo2 + (x_sum_lo * series5r + series5s_cross2)))))
    series5x = series5w - 0.0001984126984126984
    series5x_right = series5w - series5x
    series5x_lo2 = (product_rest(x_sum, series5v, series5w, series5x + series5x_right)
        - (0.0001984126984126984 - series5x_right) - 1.7209558293420705e-22)
    series5y = x_sum * series5x
    series5 = series5y + 0.008333333333333333
    series5_right = series5 - series5y
    series5_lo2 = (product_rest(x_sum, series5x, series5y, series5 - series5_right)
        + (0.008333333333333333 - series5_right) + 1.1564823173178714e-19)
    series5_lo = (series5_lo2
        + (x_sum_lo * series5x + x_sum * (series5x_lo2 + (x_sum_lo * series5v + series5w_cross2))))
    g3a = x_sum * series5
    g3b = 0.16666666666666666 - g3a
    g3b_right = 0.16666666666666666 - g3b
    g3b_lo2 = (0.16666666666666666 - (g3b + g3b_right)
        - product_rest(x_sum, series5, g3a, g3b_right) - (x_sum_lo * series5 + x_sum * series5_lo))
    g3 = where(far_x_a, g3b, closed3)
    closed3_lo = ((closed3_exact
        + (rest3 - (rest3_sum - rest3_sum_right) + (rest3_lo - rest3_sum_right)) - closed3
        * far_x_sum_lo) / far_x_sum)
    g3_lo = where(far_x_a, g3b_lo2 + 9.25185853854297e-18, closed3_lo)
    rest4 = 0.5 - g2
    rest4_right = 0.5 - rest4
    rest4_lo = 0.5 - (rest4 + rest4_right) - (g2 - rest4_right) - g2_cross2
    rest4_sum = rest4 + rest4_lo
    rest4_sum_right = rest4_sum - rest4
    closed4 = rest4_sum / far_x_sum
    closed4_product = closed4 * far_x_sum
    closed4_exact = rest4_sum - closed4_product - product_error(closed4, far_x_sum, closed4_product)
    rest5 = 0.16666666666666666 - g3
    rest5_right = 0.16666666666666666 - rest5
    rest5_lo = (0.16666666666666666 - (rest5 + rest5_right) - (g3 - rest5_right) - g3_lo
        + 9.25185853854297e-18)
    rest5_sum = rest5 + rest5_lo
    rest5_sum_right = rest5_sum - rest5
    closed5 = rest5_sum / far_x_sum
    closed5_product = closed5 * far_x_sum
    closed5_exact = rest5_sum - closed5_product - product_error(closed5, far_x_sum, closed5_product)
    series4a = 3.7699876288159054e-33 * x_sum
    series4b = 3.279889237069838e-30 - series4a
    series4b_right = 3.279889237069838e-30 - series4b
    series4b_lo1 = (3.279889237069838e-30 - (series4b + series4b_right)
        - product_rest(3.7699876288159054e-33, x_sum, series4a, series4b_right))
    series4c = x_sum * series4b
    series4c_cross2 = (x_sum
        * (series4b_lo1 - (2.5870347832750324e-49 * x_sum + 3.7699876288159054e-33 * x_sum_lo)
        + 1.5117542744029879e-46))
    series4d = series4c - 2.4795962632247976e-27
    series4d_right = series4c - series4d
    series4d_lo1 = (product_rest(x_sum, series4b, series4c, series4d + series4d_right)
        - (2.4795962632247976e-27 - series4d_right))
    series4e = x_sum * series4d
    series4f = series4e + 1.6117375710961184e-24
    series4f_right = series4f - series4e
    series4f_lo1 = (product_rest(x_sum, series4d, series4e, series4f - series4f_right)
        + (1.6117375710961184e-24 - series4f_right))
    series4e_cross = (x_sum_lo * series4d + x_sum
        * (series4d_lo1 - -1.2953730964765229e-43 + (x_sum_lo * series4b + series4c_cross2)))
    series4g = x_sum * series4f
    series4h = series4g - 8.896791392450574e-22
    series4h_right = series4g - series4h
    series4h_lo2 = (product_rest(x_sum, series4f, series4g, series4h + series4h_right)
        - (8.896791392450574e-22 - series4h_right) - -7.911402614872376e-38)
    series4i = x_sum * series4h
    series4i_cross2 = (x_sum
        * (series4h_lo2
        + (x_sum_lo * series4f + x_sum
        * (series4f_lo1 + -3.6846573564509766e-41 + series4e_cross))))
    series4j = series4i + 4.110317623312165e-19
    series4j_right = series4j - series4i
    series4j_lo2 = (product_rest(x_sum, series4h, series4i, series4j - series4j_right)
        + (4.110317623312165e-19 - series4j_right) + 1.4412973378659527e-36)
    series4k = x_sum * series4j
    series4l = series4k - 1.5619206968586225e-16
    series4l_right = series4k - series4l
    series4l_lo2 = (product_rest(x_sum, series4j, series4k, series4l + series4l_right)
        - (1.5619206968586225e-16 - series4l_right) - 1.1910679660273754e-32)
    series4m = x_sum * series4l
    series4m_cross2 = (x_sum
        * (series4l_lo2
        + (x_sum_lo * series4j + x_sum * (series4j_lo2 + (x_sum_lo * series4h + series4i_cross2)))))
    series4n = series4m + 4.779477332387385e-14
    series4n_right = series4n - series4m
    series4n_lo2 = (product_rest(x_sum, series4l, series4m, series4n - series4n_right)
        + (4.779477332387385e-14 - series4n_right) + 4.399205485834081e-31)
    series4o = x_sum * series4n
    series4p = series4o - 1.1470745597729725e-11
    series4p_right = series4o - series4p
    series4p_lo2 = (product_rest(x_sum, series4n, series4o, series4p + series4p_right)
        - (1.1470745597729725e-11 - series4p_right) - 2.0655512752830745e-28)
    series4q = x_sum * series4p
    series4q_cross2 = (x_sum
        * (series4p_lo2
        + (x_sum_lo * series4n + x_sum * (series4n_lo2 + (x_sum_lo * series4l + series4m_cross2)))))
    series4r = series4q + 2.08767569878681e-09
    series4r_right = series4r - series4q
    series4r_lo2 = (product_rest(x_sum, series4p, series4q, series4r - series4r_right)
        + (2.08767569878681e-09 - series4r_right) + -1.20734505911326e-25)
    series4s = x_sum * series4r
    series4t = series4s - 2.755731922398589e-07
    series4t_right = series4s - series4t
    series4t_lo2 = (product_rest(x_sum, series4r, series4s, series4t + series4t_right)
        - (2.755731922398589e-07 - series4t_right) - 2.3767714622250297e-23)
    series4u = x_sum * series4t
    series4u_cross2 = (x_sum
        * (series4t_lo2
        + (x_sum_lo * series4r + x_sum * (series4r_lo2 + (x_sum_lo * series4p + series4q_cross2)))))
    series4v = series4u + 2.48015873015873e-05
    series4v_right = series4v - series4u
    series4v_lo2 = (product_rest(x_sum, series4t, series4u, series4v - series4v_right)
        + (2.48015873015873e-05 - series4v_right) + 2.1511947866775882e-23)
    series4w = x_sum * series4v
    series4x = series4w - 0.001388888888888889
    series4x_right = series4w - series4x
    series4x_lo2 = (product_rest(x_sum, series4v, series4w, series4x + series4x_right)
        - (0.001388888888888889 - series4x_right) - -5.300543954373577e-20)
    series4y = x_sum * series4x
    series4y_cross2 = (x_sum
        * (series4x_lo2
        + (x_sum_lo * series4v + x_sum * (series4v_lo2 + (x_sum_lo * series4t + series4u_cross2)))))
    series4 = series4y + 0.041666666666666664
    series4_right = series4 - series4y
    series4_lo2 = (product_rest(x_sum, series4x, series4y, series4 - series4_right)
        + (0.041666666666666664 - series4_right) + 2.3129646346357427e-18)
    g4 = where(far_x_a, series4, closed4)
    closed4_lo = ((closed4_exact
        + (rest4 - (rest4_sum - rest4_sum_right) + (rest4_lo - rest4_sum_right)) - closed4
        * far_x_sum_lo) / far_x_sum)
    g4_lo = where(far_x_a, series4_lo2 + (x_sum_lo * series4x + series4y_cross2), closed4_lo)
    g5 = where(far_x_a, series5, closed5)
    closed5_lo = ((closed5_exact
        + (rest5 - (rest5_sum - rest5_sum_right) + (rest5_lo - rest5_sum_right)) - closed5
        * far_x_sum_lo) / far_x_sum)
    rate2a = 2 * g4
    rate2 = rate2a - g3
    rate2_right = rate2a - rate2
    rate3a = 3 * g5
    rate3 = rate3a - g4
    rate3_right = rate3a - rate3
    beta_v_0 = s_3 * g3
    beta_v_1 = s_4 * g3
    beta_v_2 = s_5 * g3
    beta_v_0_lo = product_error(s_3, g3, beta_v_0) + s_3 * g3_lo
    m_0 = s_3 * beta_v_0
    m_0_cross2 = s_3 * beta_v_0_lo
    beta_v_1_lo = product_error(s_4, g3, beta_v_1) + s_4 * g3_lo
    m_1 = s_4 * beta_v_1
    m_1_cross2 = s_4 * beta_v_1_lo
    m_2 = s_5 * beta_v_2
    m_2_cross2 = s_5 * (product_error(s_5, g3, beta_v_2) + s_5 * g3_lo)
    m_3 = s_4 * beta_v_0
    m_3_cross2 = s_4 * beta_v_0_lo
    m_4 = s_5 * beta_v_0
    m_4_cross2 = s_5 * beta_v_0_lo
    m_5 = s_5 * beta_v_1
    m_5_cross2 = s_5 * beta_v_1_lo
    others_0 = m_1 + m_2
    others_0_right = others_0 - m_1
    others_0_lo1 = (product_rest(s_4, beta_v_1, m_1, others_0 - others_0_right)
        + product_rest(s_5, beta_v_2, m_2, others_0_right))
    others_0_lo = others_0_lo1 + (m_1_cross2 + m_2_cross2)
    others_1 = m_0 + m_2
    others_1_right = others_1 - m_0
    others_1_lo1 = (product_rest(s_3, beta_v_0, m_0, others_1 - others_1_right)
        + product_rest(s_5, beta_v_2, m_2, others_1_right))
    others_1_lo = others_1_lo1 + (m_0_cross2 + m_2_cross2)
    others_2 = m_0 + m_1
    others_2_right = others_2 - m_0
    others_2_lo1 = (product_rest(s_3, beta_v_0, m_0, others_2 - others_2_right)
        + product_rest(s_4, beta_v_1, m_1, others_2_right))
    others_2_lo = others_2_lo1 + (m_0_cross2 + m_1_cross2)
    diagonal0a = 1 - others_0
    diagonal0a_right = 1 - diagonal0a
    diagonal0b = g1 + m_0
    diagonal0b_right = diagonal0b - g1
    diagonal0b_lo1 = (product_rest(c, sinc, g1, diagonal0b - diagonal0b_right)
        + product_rest(s_3, beta_v_0, m_0, diagonal0b_right))
    diagonal0c = m_0 + (product_error(s_3, beta_v_0, m_0) + m_0_cross2) < others_0 + others_0_lo
    diagonal0 = where(diagonal0c, diagonal0b, diagonal0a)
    diagonal0a_lo = (1 - (diagonal0a + diagonal0a_right) - (others_0 - diagonal0a_right)
        - others_0_lo)
    diagonal1a = 1 - others_1
    diagonal1a_right = 1 - diagonal1a
    diagonal1b = g1 + m_1
    diagonal1b_right = diagonal1b - g1
    diagonal1b_lo1 = (product_rest(c, sinc, g1, diagonal1b - diagonal1b_right)
        + product_rest(s_4, beta_v_1, m_1, diagonal1b_right))
    diagonal1c = m_1 + (product_error(s_4, beta_v_1, m_1) + m_1_cross2) < others_1 + others_1_lo
    diagonal1 = where(diagonal1c, diagonal1b, diagonal1a)
    diagonal1a_lo = (1 - (diagonal1a + diagonal1a_right) - (others_1 - diagonal1a_right)
        - others_1_lo)
    diagonal2a = 1 - others_2
    diagonal2a_right = 1 - diagonal2a
    diagonal2b = g1 + m_2
    diagonal2b_right = diagonal2b - g1
    diagonal2b_lo1 = (product_rest(c, sinc, g1, diagonal2b - diagonal2b_right)
        + product_rest(s_5, beta_v_2, m_2, diagonal2b_right))
    diagonal2c = m_2 + (product_error(s_5, beta_v_2, m_2) + m_2_cross2) < others_2 + others_2_lo
    diagonal2 = where(diagonal2c, diagonal2b, diagonal2a)
    diagonal2a_lo = (1 - (diagonal2a + diagonal2a_right) - (others_2 - diagonal2a_right)
        - others_2_lo)
    alpha_v_0 = -(s_3 * g2)
    alpha_v_0_cross = -(s_3 * g2_cross2)
    alpha_v_0_factor = -s_3
    alpha_v_1 = -(s_4 * g2)
    alpha_v_1_cross = -(s_4 * g2_cross2)
    alpha_v_1_factor = -s_4
    alpha_v_2 = -(s_5 * g2)
    alpha_v_2_cross = -(s_5 * g2_cross2)
    alpha_v_2_factor = -s_5
    J_1 = m_3 - alpha_v_2
    J_1_right = m_3 - J_1
    J_2 = m_4 + alpha_v_1
    J_2_right = J_2 - m_4
    J_3 = m_3 + alpha_v_2
    J_3_right = J_3 - m_3
    J_5 = m_5 - alpha_v_0
    J_5_right = m_5 - J_5
    J_6 = m_4 - alpha_v_1
    J_6_right = m_4 - J_6
    J_7 = m_5 + alpha_v_0
    J_7_right = J_7 - m_5
    rate_vw_a = s_0 * s_3
    rate_vw_b = s_1 * s_4
    rate_vw_c = rate_vw_a + rate_vw_b
    rate_vw_c_right = rate_vw_c - rate_vw_a
    rate_vw_d = s_2 * s_5
    rate_vw = rate_vw_c + rate_vw_d
    rate_vw_right = rate_vw - rate_vw_c
    rate_vw_c_lo = (product_rest(s_0, s_3, rate_vw_a, rate_vw_c - rate_vw_c_right)
        + product_rest(s_1, s_4, rate_vw_b, rate_vw_c_right))
    rate_vw_lo = (rate_vw_c - (rate_vw - rate_vw_right)
        + product_rest(s_2, s_5, rate_vw_d, rate_vw_right) + rate_vw_c_lo)
    rate_turn = rate2 * rate_vw
    rate3_lo = (product_rest(3, g5, rate3a, rate3 + rate3_right) - (g4 - rate3_right) - g4_lo + 3
        * where(far_x_a, series5_lo, closed5_lo))
    rate_bend = -(rate3 * rate_vw)
    rate_q_0a = s_0 * g2
    rate_turn_cross = ((rate2a - (rate2 + rate2_right) - (g3 - rate2_right) - g3_lo + 2 * g4_lo)
        * rate_vw + rate2 * rate_vw_lo)
    rate_turn_lo = product_error(rate2, rate_vw, rate_turn) + rate_turn_cross
    rate_q_0b = s_3 * rate_turn
    rate_q_0c = rate_q_0a + rate_q_0b
    rate_q_0c_right = rate_q_0c - rate_q_0a
    rate_q_0c_lo1 = (product_rest(s_0, g2, rate_q_0a, rate_q_0c - rate_q_0c_right)
        + product_rest(s_3, rate_turn, rate_q_0b, rate_q_0c_right))
    rate_q_0 = -rate_q_0c
    rate_q_0_lo = -(rate_q_0c_lo1 + (s_0 * g2_cross2 + s_3 * rate_turn_lo))
    rate_q_1a = s_1 * g2
    rate_q_1b = s_4 * rate_turn
    rate_q_1c = rate_q_1a + rate_q_1b
    rate_q_1c_right = rate_q_1c - rate_q_1a
    rate_q_1c_lo1 = (product_rest(s_1, g2, rate_q_1a, rate_q_1c - rate_q_1c_right)
        + product_rest(s_4, rate_turn, rate_q_1b, rate_q_1c_right))
    rate_q_1 = -rate_q_1c
    rate_q_1_lo = -(rate_q_1c_lo1 + (s_1 * g2_cross2 + s_4 * rate_turn_lo))
    rate_q_2a = s_2 * g2
    rate_q_2b = s_5 * rate_turn
    rate_q_2c = rate_q_2a + rate_q_2b
    rate_q_2c_right = rate_q_2c - rate_q_2a
    rate_q_2c_lo1 = (product_rest(s_2, g2, rate_q_2a, rate_q_2c - rate_q_2c_right)
        + product_rest(s_5, rate_turn, rate_q_2b, rate_q_2c_right))
    rate_q_2 = -rate_q_2c
    rate_q_2_lo = -(rate_q_2c_lo1 + (s_2 * g2_cross2 + s_5 * rate_turn_lo))
    rate_beta_v_0 = -(s_0 * g3)
    rate_beta_v_1 = -(s_1 * g3)
    rate_beta_v_2 = -(s_2 * g3)
    rate_bend_lo = (product_error(-rate3, rate_vw, rate_bend) +
        -(rate3_lo * rate_vw + rate3 * rate_vw_lo))
    rate_bend_w_0 = -(s_3 * rate_bend)
    rate_bend_w_1 = -(s_4 * rate_bend)
    rate_bend_w_2 = -(s_5 * rate_bend)
    rate_bend_w_0_lo = product_error(-s_3, rate_bend, rate_bend_w_0) + -(s_3 * rate_bend_lo)
    rate_symmetric_0a = s_4 * rate_bend_w_0
    rate_beta_v_1_lo = product_error(-s_1, g3, rate_beta_v_1) + -(s_1 * g3_lo)
    rate_symmetric_0b = s_3 * rate_beta_v_1
    rate_beta_v_0_lo = product_error(-s_0, g3, rate_beta_v_0) + -(s_0 * g3_lo)
    rate_symmetric_0c = s_4 * rate_beta_v_0
    rate_symmetric_0d = rate_symmetric_0b + rate_symmetric_0c
    rate_symmetric_0d_right = rate_symmetric_0d - rate_symmetric_0b
    rate_symmetric_0d_left_rest = product_rest(s_3, rate_beta_v_1, rate_symmetric_0b,
        rate_symmetric_0d - rate_symmetric_0d_right)
    rate_symmetric_0d_lo1 = (rate_symmetric_0d_left_rest
        + product_rest(s_4, rate_beta_v_0, rate_symmetric_0c, rate_symmetric_0d_right))
    rate_symmetric_0 = rate_symmetric_0a - rate_symmetric_0d
    rate_symmetric_0_right = rate_symmetric_0a - rate_symmetric_0
    rate_symmetric_0_left_rest = product_rest(s_4, rate_bend_w_0, rate_symmetric_0a,
        rate_symmetric_0 + rate_symmetric_0_right)
    rate_symmetric_0_lo1 = rate_symmetric_0_left_rest - (rate_symmetric_0d - rate_symmetric_0_right)
    rate_symmetric_0_lo = (rate_symmetric_0_lo1
        - (rate_symmetric_0d_lo1 + (s_3 * rate_beta_v_1_lo + s_4 * rate_beta_v_0_lo)) + s_4
        * rate_bend_w_0_lo)
    rate_symmetric_1a = s_5 * rate_bend_w_0
    rate_beta_v_2_lo = product_error(-s_2, g3, rate_beta_v_2) + -(s_2 * g3_lo)
    rate_symmetric_1b = s_3 * rate_beta_v_2
    rate_symmetric_1c = s_5 * rate_beta_v_0
    rate_symmetric_1d = rate_symmetric_1b + rate_symmetric_1c
    rate_symmetric_1d_right = rate_symmetric_1d - rate_symmetric_1b
    rate_symmetric_1d_left_rest = product_rest(s_3, rate_beta_v_2, rate_symmetric_1b,
        rate_symmetric_1d - rate_symmetric_1d_right)
    rate_symmetric_1d_lo1 = (rate_symmetric_1d_left_rest
        + product_rest(s_5, rate_beta_v_0, rate_symmetric_1c, rate_symmetric_1d_right))
    rate_symmetric_1 = rate_symmetric_1a - rate_symmetric_1d
    rate_symmetric_1_right = rate_symmetric_1a - rate_symmetric_1
    rate_symmetric_1_left_rest = product_rest(s_5, rate_bend_w_0, rate_symmetric_1a,
        rate_symmetric_1 + rate_symmetric_1_right)
    rate_symmetric_1_lo1 = rate_symmetric_1_left_rest - (rate_symmetric_1d - rate_symmetric_1_right)
    rate_symmetric_1_lo = (rate_symmetric_1_lo1
        - (rate_symmetric_1d_lo1 + (s_3 * rate_beta_v_2_lo + s_5 * rate_beta_v_0_lo)) + s_5
        * rate_bend_w_0_lo)
    rate_bend_w_1_lo = product_error(-s_4, rate_bend, rate_bend_w_1) + -(s_4 * rate_bend_lo)
    rate_symmetric_2a = s_5 * rate_bend_w_1
    rate_symmetric_2b = s_4 * rate_beta_v_2
    rate_symmetric_2c = s_5 * rate_beta_v_1
    rate_symmetric_2d = rate_symmetric_2b + rate_symmetric_2c
    rate_symmetric_2d_right = rate_symmetric_2d - rate_symmetric_2b
    rate_symmetric_2d_left_rest = product_rest(s_4, rate_beta_v_2, rate_symmetric_2b,
        rate_symmetric_2d - rate_symmetric_2d_right)
    rate_symmetric_2d_lo1 = (rate_symmetric_2d_left_rest
        + product_rest(s_5, rate_beta_v_1, rate_symmetric_2c, rate_symmetric_2d_right))
    rate_symmetric_2 = rate_symmetric_2a - rate_symmetric_2d
    rate_symmetric_2_right = rate_symmetric_2a - rate_symmetric_2
    rate_symmetric_2_left_rest = product_rest(s_5, rate_bend_w_1, rate_symmetric_2a,
        rate_symmetric_2 + rate_symmetric_2_right)
    rate_symmetric_2_lo1 = rate_symmetric_2_left_rest - (rate_symmetric_2d - rate_symmetric_2_right)
    rate_symmetric_2_lo = (rate_symmetric_2_lo1
        - (rate_symmetric_2d_lo1 + (s_4 * rate_beta_v_2_lo + s_5 * rate_beta_v_1_lo)) + s_5
        * rate_bend_w_1_lo)
    rate_diagonal_0a = 2 * s_4
    rate_diagonal_0b = rate_diagonal_0a * rate_beta_v_1
    rate_diagonal_0b_cross2 = rate_diagonal_0a * rate_beta_v_1_lo
    rate_diagonal_0c = 2 * s_5
    rate_diagonal_0d = rate_diagonal_0c * rate_beta_v_2
    rate_diagonal_0d_cross2 = rate_diagonal_0c * rate_beta_v_2_lo
    rate_diagonal_0e = rate_diagonal_0b + rate_diagonal_0d
    rate_diagonal_0e_right = rate_diagonal_0e - rate_diagonal_0b
    rate_diagonal_0e_left_rest = product_rest(rate_diagonal_0a, rate_beta_v_1, rate_diagonal_0b,
        rate_diagonal_0e - rate_diagonal_0e_right)
    rate_diagonal_0e_lo1 = (rate_diagonal_0e_left_rest
        + product_rest(rate_diagonal_0c, rate_beta_v_2, rate_diagonal_0d, rate_diagonal_0e_right))
    rate_diagonal_0f = s_4 * rate_bend_w_1
    rate_diagonal_0f_cross2 = s_4 * rate_bend_w_1_lo
    rate_diagonal_0g = s_5 * rate_bend_w_2
    rate_diagonal_0g_cross2 = (s_5
        * (product_error(-s_5, rate_bend, rate_bend_w_2) + -(s_5 * rate_bend_lo)))
    rate_diagonal_0h = rate_diagonal_0f + rate_diagonal_0g
    rate_diagonal_0h_right = rate_diagonal_0h - rate_diagonal_0f
    rate_diagonal_0h_left_rest = product_rest(s_4, rate_bend_w_1, rate_diagonal_0f,
        rate_diagonal_0h - rate_diagonal_0h_right)
    rate_diagonal_0h_lo1 = (rate_diagonal_0h_left_rest
        + product_rest(s_5, rate_bend_w_2, rate_diagonal_0g, rate_diagonal_0h_right))
    rate_diagonal_0 = rate_diagonal_0e - rate_diagonal_0h
    rate_diagonal_0_right = rate_diagonal_0e - rate_diagonal_0
    rate_diagonal_0_lo1 = (rate_diagonal_0e - (rate_diagonal_0 + rate_diagonal_0_right)
        - (rate_diagonal_0h - rate_diagonal_0_right))
    rate_diagonal_0_lo2 = (rate_diagonal_0_lo1
        - (rate_diagonal_0h_lo1 + (rate_diagonal_0f_cross2 + rate_diagonal_0g_cross2)))
    rate_diagonal_1a = 2 * s_3
    rate_diagonal_1b = rate_diagonal_1a * rate_beta_v_0
    rate_diagonal_1b_cross2 = rate_diagonal_1a * rate_beta_v_0_lo
    rate_diagonal_1c = rate_diagonal_1b + rate_diagonal_0d
    rate_diagonal_1c_right = rate_diagonal_1c - rate_diagonal_1b
    rate_diagonal_1c_left_rest = product_rest(rate_diagonal_1a, rate_beta_v_0, rate_diagonal_1b,
        rate_diagonal_1c - rate_diagonal_1c_right)
    rate_diagonal_1c_lo1 = (rate_diagonal_1c_left_rest
        + product_rest(rate_diagonal_0c, rate_beta_v_2, rate_diagonal_0d, rate_diagonal_1c_right))
    rate_diagonal_1d = s_3 * rate_bend_w_0
    rate_diagonal_1d_cross2 = s_3 * rate_bend_w_0_lo
    rate_diagonal_1e = rate_diagonal_1d + rate_diagonal_0g
    rate_diagonal_1e_right = rate_diagonal_1e - rate_diagonal_1d
    rate_diagonal_1e_left_rest = product_rest(s_3, rate_bend_w_0, rate_diagonal_1d,
        rate_diagonal_1e - rate_diagonal_1e_right)
    rate_diagonal_1e_lo1 = (rate_diagonal_1e_left_rest
        + product_rest(s_5, rate_bend_w_2, rate_diagonal_0g, rate_diagonal_1e_right))
    rate_diagonal_1 = rate_diagonal_1c - rate_diagonal_1e
    rate_diagonal_1_right = rate_diagonal_1c - rate_diagonal_1
    rate_diagonal_1_lo1 = (rate_diagonal_1c - (rate_diagonal_1 + rate_diagonal_1_right)
        - (rate_diagonal_1e - rate_diagonal_1_right))
    rate_diagonal_1_lo2 = (rate_diagonal_1_lo1
        - (rate_diagonal_1e_lo1 + (rate_diagonal_1d_cross2 + rate_diagonal_0g_cross2)))
    rate_diagonal_2a = rate_diagonal_1b + rate_diagonal_0b
    rate_diagonal_2a_right = rate_diagonal_2a - rate_diagonal_1b
    rate_diagonal_2a_left_rest = product_rest(rate_diagonal_1a, rate_beta_v_0, rate_diagonal_1b,
        rate_diagonal_2a - rate_diagonal_2a_right)
    rate_diagonal_2a_lo1 = (rate_diagonal_2a_left_rest
        + product_rest(rate_diagonal_0a, rate_beta_v_1, rate_diagonal_0b, rate_diagonal_2a_right))
    rate_diagonal_2b = rate_diagonal_1d + rate_diagonal_0f
    rate_diagonal_2b_right = rate_diagonal_2b - rate_diagonal_1d
    rate_diagonal_2b_left_rest = product_rest(s_3, rate_bend_w_0, rate_diagonal_1d,
        rate_diagonal_2b - rate_diagonal_2b_right)
    rate_diagonal_2b_lo1 = (rate_diagonal_2b_left_rest
        + product_rest(s_4, rate_bend_w_1, rate_diagonal_0f, rate_diagonal_2b_right))
    rate_diagonal_2 = rate_diagonal_2a - rate_diagonal_2b
    rate_diagonal_2_right = rate_diagonal_2a - rate_diagonal_2
    rate_diagonal_2_lo1 = (rate_diagonal_2a - (rate_diagonal_2 + rate_diagonal_2_right)
        - (rate_diagonal_2b - rate_diagonal_2_right))
    rate_diagonal_2_lo2 = (rate_diagonal_2_lo1
        - (rate_diagonal_2b_lo1 + (rate_diagonal_1d_cross2 + rate_diagonal_0f_cross2)))
    M_04 = rate_symmetric_0 - rate_q_2
    M_04_right = rate_symmetric_0 - M_04
    M_05 = rate_q_1 + rate_symmetric_1
    M_05_right = M_05 - rate_q_1
    M_13 = rate_q_2 + rate_symmetric_0
    M_13_right = M_13 - rate_q_2
    M_15 = rate_symmetric_2 - rate_q_0
    M_15_right = rate_symmetric_2 - M_15
    M_23 = rate_symmetric_1 - rate_q_1
    M_23_right = rate_symmetric_1 - M_23
    M_24 = rate_q_0 + rate_symmetric_2
    M_24_right = M_24 - rate_q_0
    diagonal0_rounded = (diagonal0
        + where(diagonal0c, diagonal0b_lo1 + (g1_cross + m_0_cross2), diagonal0a_lo))
    diagonal0_final = where(diagonal0_rounded == diagonal0_rounded, diagonal0_rounded, diagonal0)
    J_1_lo = (product_rest(s_4, beta_v_0, m_3, J_1 + J_1_right)
        - product_rest(alpha_v_2_factor, g2, alpha_v_2, J_1_right) + (m_3_cross2 - alpha_v_2_cross))
    J_1_rounded = J_1 + J_1_lo
    J_1_final = where(J_1_rounded == J_1_rounded, J_1_rounded, J_1)
    J_2_lo = (product_rest(s_5, beta_v_0, m_4, J_2 - J_2_right)
        + product_rest(alpha_v_1_factor, g2, alpha_v_1, J_2_right) + (m_4_cross2 + alpha_v_1_cross))
    J_2_rounded = J_2 + J_2_lo
    J_2_final = where(J_2_rounded == J_2_rounded, J_2_rounded, J_2)
    rate_diagonal_0_rounded = (rate_diagonal_0
        + (rate_diagonal_0_lo2
        + (rate_diagonal_0e_lo1 + (rate_diagonal_0b_cross2 + rate_diagonal_0d_cross2))))
    M_04_rounded = (M_04
        + (rate_symmetric_0 - (M_04 + M_04_right) - (rate_q_2 - M_04_right) - rate_q_2_lo
        + rate_symmetric_0_lo))
    M_05_rounded = (M_05
        + (rate_q_1 - (M_05 - M_05_right) + (rate_symmetric_1 - M_05_right) + rate_symmetric_1_lo
        + rate_q_1_lo))
    J_3_lo = (product_rest(s_4, beta_v_0, m_3, J_3 - J_3_right)
        + product_rest(alpha_v_2_factor, g2, alpha_v_2, J_3_right) + (m_3_cross2 + alpha_v_2_cross))
    J_3_rounded = J_3 + J_3_lo
    J_3_final = where(J_3_rounded == J_3_rounded, J_3_rounded, J_3)
    diagonal1_rounded = (diagonal1
        + where(diagonal1c, diagonal1b_lo1 + (g1_cross + m_1_cross2), diagonal1a_lo))
    diagonal1_final = where(diagonal1_rounded == diagonal1_rounded, diagonal1_rounded, diagonal1)
    J_5_lo = (product_rest(s_5, beta_v_1, m_5, J_5 + J_5_right)
        - product_rest(alpha_v_0_factor, g2, alpha_v_0, J_5_right) + (m_5_cross2 - alpha_v_0_cross))
    J_5_rounded = J_5 + J_5_lo
    J_5_final = where(J_5_rounded == J_5_rounded, J_5_rounded, J_5)
    M_13_rounded = (M_13
        + (rate_q_2 - (M_13 - M_13_right) + (rate_symmetric_0 - M_13_right) + rate_symmetric_0_lo
        + rate_q_2_lo))
    rate_diagonal_1_rounded = (rate_diagonal_1
        + (rate_diagonal_1_lo2
        + (rate_diagonal_1c_lo1 + (rate_diagonal_1b_cross2 + rate_diagonal_0d_cross2))))
    M_15_rounded = (M_15
        + (rate_symmetric_2 - (M_15 + M_15_right) - (rate_q_0 - M_15_right) - rate_q_0_lo
        + rate_symmetric_2_lo))
    J_6_lo = (product_rest(s_5, beta_v_0, m_4, J_6 + J_6_right)
        - product_rest(alpha_v_1_factor, g2, alpha_v_1, J_6_right) + (m_4_cross2 - alpha_v_1_cross))
    J_6_rounded = J_6 + J_6_lo
    J_6_final = where(J_6_rounded == J_6_rounded, J_6_rounded, J_6)
    J_7_lo = (product_rest(s_5, beta_v_1, m_5, J_7 - J_7_right)
        + product_rest(alpha_v_0_factor, g2, alpha_v_0, J_7_right) + (m_5_cross2 + alpha_v_0_cross))
    J_7_rounded = J_7 + J_7_lo
    J_7_final = where(J_7_rounded == J_7_rounded, J_7_rounded, J_7)
    diagonal2_rounded = (diagonal2
        + where(diagonal2c, diagonal2b_lo1 + (g1_cross + m_2_cross2), diagonal2a_lo))
    diagonal2_final = where(diagonal2_rounded == diagonal2_rounded, diagonal2_rounded, diagonal2)
    M_23_rounded = (M_23
        + (rate_symmetric_1 - (M_23 + M_23_right) - (rate_q_1 - M_23_right) - rate_q_1_lo
        + rate_symmetric_1_lo))
    M_24_rounded = (M_24
        + (rate_q_0 - (M_24 - M_24_right) + (rate_symmetric_2 - M_24_right) + rate_symmetric_2_lo
        + rate_q_0_lo))
    rate_diagonal_2_rounded = (rate_diagonal_2
        + (rate_diagonal_2_lo2
        + (rate_diagonal_2a_lo1 + (rate_diagonal_1b_cross2 + rate_diagonal_0b_cross2))))
    rate_diagonal_0_final = where(rate_diagonal_0_rounded == rate_diagonal_0_rounded,
        rate_diagonal_0_rounded, rate_diagonal_0)
    M_04_final = where(M_04_rounded == M_04_rounded, M_04_rounded, M_04)
    M_05_final = where(M_05_rounded == M_05_rounded, M_05_rounded, M_05)
    M_13_final = where(M_13_rounded == M_13_rounded, M_13_rounded, M_13)
    rate_diagonal_1_final = where(rate_diagonal_1_rounded == rate_diagonal_1_rounded,
        rate_diagonal_1_rounded, rate_diagonal_1)
    M_15_final = where(M_15_rounded == M_15_rounded, M_15_rounded, M_15)
    M_23_final = where(M_23_rounded == M_23_rounded, M_23_rounded, M_23)
    M_24_final = where(M_24_rounded == M_24_rounded, M_24_rounded, M_24)
    rate_diagonal_2_final = where(rate_diagonal_2_rounded == rate_diagonal_2_rounded,
        rate_diagonal_2_rounded, rate_diagonal_2)
    return (diagonal0_final, J_1_final, J_2_final, rate_diagonal_0_final, M_04_final, M_05_final,
        J_3_final, diagonal1_final, J_5_final, M_13_final, rate_diagonal_1_final, M_15_final,
        J_6_final, J_7_final, diagonal2_final, M_23_final, M_24_final, rate_diagonal_2_final, 0, 0,
        0, diagonal0_final, J_1_final, J_2_final, 0, 0, 0, J_3_final, diagonal1_final, J_5_final, 0,
        0, 0, J_6_final, J_7_final, diagonal2_final)


@kernel("(6)->(6,6)")
def SE3_leftJacobianInverse(s):
    """M = J_l(s)^-1; singular where |ω| is a multiple of 2π except 0.

    (6)->(6,6).  s: screw (v in m/s; ω in rad/s); M: 6×6 operator.
    283 mul, 721 add, 34 product error, 60 product rest, 14 div, 1 sqrt, 9 neg, 4 abs, 6 less,
    19 equal, 36 select.  Error <= M: 1 u of its largest component for |ω of s| <= π; searched,
    not proved.  Each component is within 1 ulp as long as its condition is below 1e13; in
    single precision it is the nearest number, except near ties, as long as that is below 1e5;
    searched, not proved.  Intermediate sums may overflow where |v| is above 2e306, in single
    precision 5e36.
    """
    s_0, s_1, s_2, s_3, s_4, s_5 = s
    halved_0 = 0.5 * s_3
    halved_1 = 0.5 * s_4
    halved_2 = 0.5 * s_5
    y_a = halved_0 * halved_0
    y_b = halved_1 * halved_1
    y_c = y_a + y_b
    y_c_right = y_c - y_a
    y_d = halved_2 * halved_2
    y = y_c + y_d
    y_right = y - y_c
    y_c_lo = (product_rest(halved_0, halved_0, y_a, y_c - y_c_right)
        + product_rest(halved_1, halved_1, y_b, y_c_right))
    y_lo = y_c - (y - y_right) + product_rest(halved_2, halved_2, y_d, y_right) + y_c_lo
    y_sum = y + y_lo
    y_sum_right = y_sum - y
    y_sum_lo = y - (y_sum - y_sum_right) + (y_lo - y_sum_right)
    half_angle = sqrt(y_sum)
    half_angle_product = half_angle * half_angle
    half_angle_residual = (y_sum - half_angle_product
        - product_error(half_angle, half_angle, half_angle_product) + y_sum_lo)
    half_angle_lo = half_angle_residual / where(half_angle == 0, 1, half_angle + half_angle)
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
    c_lo = c_own_error - (sine_half_cos * sine + sine_half_sin * c) * sine_twice
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
    sinc_a = 0.16666666666666666 * y_sum
    sinc_b = 1 - sinc_a
    sinc_b_right = 1 - sinc_b
    sinc_b_lo1 = (1 - (sinc_b + sinc_b_right)
        - product_rest(0.16666666666666666, y_sum, sinc_a, sinc_b_right))
    sinc = where(sinc_divisor_a, sinc_b, sinc_quotient)
    sinc_quotient_lo = ((sinc_quotient_exact
        + (sine - (sine_sum - sine_sum_right) + (sine_lo - sine_sum_right)) - sinc_quotient_cross)
        / sinc_divisor_sum)
    sinc_lo = where(sinc_divisor_a,
        sinc_b_lo1 - (9.25185853854297e-18 * y_sum + 0.16666666666666666 * y_sum_lo),
        sinc_quotient_lo)
    series_phi_a = 5.107725174524775e-32 * y_sum
    series_phi_b = 4.116826490666969e-29 - series_phi_a
    series_phi_b_right = 4.116826490666969e-29 - series_phi_b
    series_phi_b_right_rest = product_rest(5.107725174524775e-32, y_sum, series_phi_a,
        series_phi_b_right)
    series_phi_b_lo1 = (4.116826490666969e-29 - (series_phi_b + series_phi_b_right)
        - series_phi_b_right_rest)
    series_phi_c = y_sum * series_phi_b
    series_phi_c_cross2 = (y_sum
        * (series_phi_b_lo1 - (4.7410392187559056e-48 * y_sum + 5.107725174524775e-32 * y_sum_lo) +
        -1.8714974010023092e-45))
    series_phi_d = series_phi_c - 2.86531123750421e-26
    series_phi_d_right = series_phi_c - series_phi_d
    series_phi_d_lo1 = (product_rest(y_sum, series_phi_b, series_phi_c, series_phi_d
        + series_phi_d_right) - (2.86531123750421e-26 - series_phi_d_right))
    series_phi_e = y_sum * series_phi_d
    series_phi_f = series_phi_e + 1.701994875077501e-23
    series_phi_f_right = series_phi_f - series_phi_e
    series_phi_f_lo1 = (product_rest(y_sum, series_phi_d, series_phi_e, series_phi_f
        - series_phi_f_right) + (1.701994875077501e-23 - series_phi_f_right))
    series_phi_e_cross = (y_sum_lo * series_phi_d + y_sum
        * (series_phi_d_lo1 - 2.3296034284323186e-42
        + (y_sum_lo * series_phi_b + series_phi_c_cross2)))
    series_phi_g = y_sum * series_phi_f
    series_phi_h = series_phi_g - 8.509974375387505e-21
    series_phi_h_right = series_phi_g - series_phi_h
    series_phi_h_lo1 = (product_rest(y_sum, series_phi_f, series_phi_g, series_phi_h
        + series_phi_h_right) - (8.509974375387505e-21 - series_phi_h_right))
    series_phi_g_cross = (y_sum_lo * series_phi_f + y_sum
        * (series_phi_f_lo1 + 3.161967936521494e-40 + series_phi_e_cross))
    series_phi_i = y_sum * series_phi_h
    series_phi_j = series_phi_i + 3.523129391410427e-18
    series_phi_j_right = series_phi_j - series_phi_i
    series_phi_j_lo1 = (product_rest(y_sum, series_phi_h, series_phi_i, series_phi_j
        - series_phi_j_right) + (3.523129391410427e-18 - series_phi_j_right))
    series_phi_i_cross = (y_sum_lo * series_phi_h + y_sum
        * (series_phi_h_lo1 - 3.2266760594119493e-37 + series_phi_g_cross))
    series_phi_k = y_sum * series_phi_j
    series_phi_l = series_phi_k - 1.1837714755139035e-15
    series_phi_l_right = series_phi_k - series_phi_l
    series_phi_l_lo1 = (product_rest(y_sum, series_phi_j, series_phi_k, series_phi_l
        + series_phi_l_right) - (1.1837714755139035e-15 - series_phi_l_right))
    series_phi_k_cross = (y_sum_lo * series_phi_j + y_sum
        * (series_phi_j_lo1 + -1.2521244741738012e-34 + series_phi_i_cross))
    series_phi_m = y_sum * series_phi_l
    series_phi_n = series_phi_m + 3.148832124866983e-13
    series_phi_n_right = series_phi_n - series_phi_m
    series_phi_n_lo1 = (product_rest(y_sum, series_phi_l, series_phi_m, series_phi_n
        - series_phi_n_right) + (3.148832124866983e-13 - series_phi_n_right))
    series_phi_m_cross = (y_sum_lo * series_phi_l + y_sum
        * (series_phi_l_lo1 - 7.23242424407352e-33 + series_phi_k_cross))
    series_phi_o = y_sum * series_phi_n
    series_phi_p = series_phi_o - 6.423617534728645e-11
    series_phi_p_right = series_phi_o - series_phi_p
    series_phi_p_lo1 = (product_rest(y_sum, series_phi_n, series_phi_o, series_phi_p
        + series_phi_p_right) - (6.423617534728645e-11 - series_phi_p_right))
    series_phi_o_cross = (y_sum_lo * series_phi_n + y_sum
        * (series_phi_n_lo1 + 5.8681293750286156e-30 + series_phi_m_cross))
    series_phi_q = y_sum * series_phi_p
    series_phi_r = series_phi_q + 9.635426302092969e-09
    series_phi_r_right = series_phi_r - series_phi_q
    series_phi_r_lo1 = (product_rest(y_sum, series_phi_p, series_phi_q, series_phi_r
        - series_phi_r_right) + (9.635426302092969e-09 - series_phi_r_right))
    series_phi_q_cross = (y_sum_lo * series_phi_p + y_sum
        * (series_phi_p_lo1 - 5.034117835500839e-27 + series_phi_o_cross))
    series_phi_s = y_sum * series_phi_r
    series_phi_t = series_phi_s - 1.0020843354176687e-06
    series_phi_t_right = series_phi_s - series_phi_t
    series_phi_t_lo1 = (product_rest(y_sum, series_phi_r, series_phi_s, series_phi_t
        + series_phi_t_right) - (1.0020843354176687e-06 - series_phi_t_right))
    series_phi_s_cross = (y_sum_lo * series_phi_r + y_sum
        * (series_phi_r_lo1 + -1.7546051379703029e-25 + series_phi_q_cross))
    series_phi_u = y_sum * series_phi_t
    series_phi_v = series_phi_u + 6.613756613756614e-05
    series_phi_v_right = series_phi_v - series_phi_u
    series_phi_v_lo1 = (product_rest(y_sum, series_phi_t, series_phi_u, series_phi_v
        - series_phi_v_right) + (6.613756613756614e-05 - series_phi_v_right))
    series_phi_u_cross = (y_sum_lo * series_phi_t + y_sum
        * (series_phi_t_lo1 - 4.7926555569351065e-23 + series_phi_s_cross))
    series_phi_w = y_sum * series_phi_v
    series_phi_x = series_phi_w - 0.002380952380952381
    series_phi_x_right = series_phi_w - series_phi_x
    series_phi_x_lo1 = (product_rest(y_sum, series_phi_v, series_phi_w, series_phi_x
        + series_phi_x_right) - (0.002380952380952381 - series_phi_x_right))
    series_phi_w_cross = (y_sum_lo * series_phi_v + y_sum
        * (series_phi_v_lo1 + -4.460143857711533e-21 + series_phi_u_cross))
    series_phi_y = y_sum * series_phi_x
    series_phi = series_phi_y + 0.03333333333333333
    series_phi_right = series_phi - series_phi_y
    series_phi_lo1 = (product_rest(y_sum, series_phi_x, series_phi_y, series_phi
        - series_phi_right) + (0.03333333333333333 - series_phi_right))
    series_phi_y_cross = (y_sum_lo * series_phi_x + y_sum
        * (series_phi_x_lo1 - -2.147752875018904e-19 + series_phi_w_cross))
    series_phi_lo = series_phi_lo1 + 4.625929269271486e-19 + series_phi_y_cross
    f_more_a = 2 * y_sum
    f_more = f_more_a * series_phi
    near_f_a = 0.3333333333333333 * sinc
    near_f_b = 0.3333333333333333 * f_more
    near_f_b_cross2 = (0.3333333333333333
        * (product_error(f_more_a, series_phi, f_more)
        + (2 * y_sum_lo * series_phi + f_more_a * series_phi_lo)))
    near_f = near_f_a + near_f_b
    near_f_right = near_f - near_f_a
    near_f_left_rest = product_rest(0.3333333333333333, sinc, near_f_a, near_f - near_f_right)
    near_f_cross = (1.850371707708594e-17 * sinc + 0.3333333333333333 * sinc_lo
        + (1.850371707708594e-17 * f_more + near_f_b_cross2))
    f_rest = sinc - c
    f_rest_right = sinc - f_rest
    f_rest_lo = sinc - (f_rest + f_rest_right) - (c - f_rest_right) - c_lo + sinc_lo
    x = 4 * y_sum
    far_y_a = x + 4 * y_sum_lo < 4
    far_y = where(far_y_a, 1, y_sum)
    far_y_lo = where(far_y_a, 0, y_sum_lo)
    f_rest_sum = f_rest + f_rest_lo
    f_rest_sum_right = f_rest_sum - f_rest
    far_y_sum = far_y + far_y_lo
    far_y_sum_right = far_y_sum - far_y
    far_y_sum_lo = far_y - (far_y_sum - far_y_sum_right) + (far_y_lo - far_y_sum_right)
    closed_f = f_rest_sum / far_y_sum
    closed_f_product = closed_f * far_y_sum
    closed_f_exact = (f_rest_sum - closed_f_product
        - product_error(closed_f, far_y_sum, closed_f_product))
    f = where(far_y_a, near_f, closed_f)
    closed_f_lo = ((closed_f_exact
        + (f_rest - (f_rest_sum - f_rest_sum_right) + (f_rest_lo - f_rest_sum_right)) - closed_f
        * far_y_sum_lo) / far_y_sum)
    f_lo = where(far_y_a, near_f_left_rest + product_rest(0.3333333333333333, f_more, near_f_b,
        near_f_right) + near_f_cross, closed_f_lo)
    four_k = 4 * sinc
    four_k_cross2 = 4 * sinc_lo
    f_sum = f + f_lo
    f_sum_right = f_sum - f
    f_sum_lo = f - (f_sum - f_sum_right) + (f_lo - f_sum_right)
    four_k_sum = four_k + four_k_cross2
    four_k_sum_right = four_k_sum - four_k
    b = f_sum / four_k_sum
    b_product = b * four_k_sum
    b_cross = b * (four_k - (four_k_sum - four_k_sum_right) + (four_k_cross2 - four_k_sum_right))
    b_lo = ((f_sum - b_product - product_error(b, four_k_sum, b_product) + f_sum_lo - b_cross)
        / four_k_sum)
    c_sum = c + c_lo
    c_sum_right = c_sum - c
    sinc_sum = sinc + sinc_lo
    sinc_sum_right = sinc_sum - sinc
    sinc_sum_lo = sinc - (sinc_sum - sinc_sum_right) + (sinc_lo - sinc_sum_right)
    b_across = c_sum / sinc_sum
    b_across_product = b_across * sinc_sum
    b_across_exact = c_sum - b_across_product - product_error(b_across, sinc_sum, b_across_product)
    b_across_lo = ((b_across_exact + (c - (c_sum - c_sum_right) + (c_lo - c_sum_right)) - b_across
        * sinc_sum_lo) / sinc_sum)
    beta_v_0 = s_3 * b
    beta_v_1 = s_4 * b
    beta_v_2 = s_5 * b
    beta_v_0_lo = product_error(s_3, b, beta_v_0) + s_3 * b_lo
    m_0 = s_3 * beta_v_0
    m_0_cross2 = s_3 * beta_v_0_lo
    beta_v_1_lo = product_error(s_4, b, beta_v_1) + s_4 * b_lo
    m_1 = s_4 * beta_v_1
    m_1_cross2 = s_4 * beta_v_1_lo
    m_2 = s_5 * beta_v_2
    m_2_cross2 = s_5 * (product_error(s_5, b, beta_v_2) + s_5 * b_lo)
    m_3 = s_4 * beta_v_0
    m_3_cross2 = s_4 * beta_v_0_lo
    m_4 = s_5 * beta_v_0
    m_4_cross2 = s_5 * beta_v_0_lo
    m_5 = s_5 * beta_v_1
    m_5_cross2 = s_5 * beta_v_1_lo
    others_0 = m_1 + m_2
    others_0_right = others_0 - m_1
    others_0_lo1 = (product_rest(s_4, beta_v_1, m_1, others_0 - others_0_right)
        + product_rest(s_5, beta_v_2, m_2, others_0_right))
    others_0_lo = others_0_lo1 + (m_1_cross2 + m_2_cross2)
    others_1 = m_0 + m_2
    others_1_right = others_1 - m_0
    others_1_lo1 = (product_rest(s_3, beta_v_0, m_0, others_1 - others_1_right)
        + product_rest(s_5, beta_v_2, m_2, others_1_right))
    others_1_lo = others_1_lo1 + (m_0_cross2 + m_2_cross2)
    others_2 = m_0 + m_1
    others_2_right = others_2 - m_0
    others_2_lo1 = (product_rest(s_3, beta_v_0, m_0, others_2 - others_2_right)
        + product_rest(s_4, beta_v_1, m_1, others_2_right))
    others_2_lo = others_2_lo1 + (m_0_cross2 + m_1_cross2)
    diagonal0a = 1 - others_0
    diagonal0a_right = 1 - diagonal0a
    diagonal0b = b_across + m_0
    diagonal0b_right = diagonal0b - b_across
    diagonal0c = m_0 + (product_error(s_3, beta_v_0, m_0) + m_0_cross2) < others_0 + others_0_lo
    diagonal0 = where(diagonal0c, diagonal0b, diagonal0a)
    diagonal0b_lo = (b_across - (diagonal0b - diagonal0b_right)
        + product_rest(s_3, beta_v_0, m_0, diagonal0b_right) + m_0_cross2 + b_across_lo)
    diagonal1a = 1 - others_1
    diagonal1a_right = 1 - diagonal1a
    diagonal1b = b_across + m_1
    diagonal1b_right = diagonal1b - b_across
    diagonal1c = m_1 + (product_error(s_4, beta_v_1, m_1) + m_1_cross2) < others_1 + others_1_lo
    diagonal1 = where(diagonal1c, diagonal1b, diagonal1a)
    diagonal1b_lo = (b_across - (diagonal1b - diagonal1b_right)
        + product_rest(s_4, beta_v_1, m_1, diagonal1b_right) + m_1_cross2 + b_across_lo)
    diagonal2a = 1 - others_2
    diagonal2a_right = 1 - diagonal2a
    diagonal2b = b_across + m_2
    diagonal2b_right = diagonal2b - b_across
    diagonal2c = m_2 + (product_error(s_5, beta_v_2, m_2) + m_2_cross2) < others_2 + others_2_lo
    diagonal2 = where(diagonal2c, diagonal2b, diagonal2a)
    diagonal2b_lo = (b_across - (diagonal2b - diagonal2b_right)
        + product_rest(s_5, beta_v_2, m_2, diagonal2b_right) + m_2_cross2 + b_across_lo)
    alpha_v_0 = -halved_0
    alpha_v_1 = -halved_1
    alpha_v_2 = -halved_2
    J_1 = m_3 - alpha_v_2
    J_1_right = m_3 - J_1
    J_2 = m_4 + alpha_v_1
    J_2_right = J_2 - m_4
    J_3 = m_3 + alpha_v_2
    J_3_right = J_3 - m_3
    J_5 = m_5 - alpha_v_0
    J_5_right = m_5 - J_5
    J_6 = m_4 - alpha_v_1
    J_6_right = m_4 - J_6
    J_7 = m_5 + alpha_v_0
    J_7_right = J_7 - m_5
    phi_rest_a = 3 * f_sum
    phi_rest = phi_rest_a - sinc_sum
    phi_rest_right = phi_rest_a - phi_rest
    phi_rest_lo = (product_rest(3, f_sum, phi_rest_a, phi_rest + phi_rest_right)
        - (sinc_sum - phi_rest_right) - sinc_sum_lo + 3 * f_sum_lo)
    twice_y = 2 * far_y_sum
    twice_y_cross2 = 2 * far_y_sum_lo
    phi_rest_sum = phi_rest + phi_rest_lo
    phi_rest_sum_right = phi_rest_sum - phi_rest
    twice_y_sum = twice_y + twice_y_cross2
    twice_y_sum_right = twice_y_sum - twice_y
    closed_phi = phi_rest_sum / twice_y_sum
    closed_phi_product = closed_phi * twice_y_sum
    closed_phi_exact = (phi_rest_sum - closed_phi_product
        - product_error(closed_phi, twice_y_sum, closed_phi_product))
    closed_phi_numerator = (closed_phi_exact
        + (phi_rest - (phi_rest_sum - phi_rest_sum_right) + (phi_rest_lo - phi_rest_sum_right)))
    closed_phi_residual = (closed_phi_numerator - closed_phi
        * (twice_y - (twice_y_sum - twice_y_sum_right) + (twice_y_cross2 - twice_y_sum_right)))
    phi = where(far_y_a, series_phi, closed_phi)
    b_rate_above_a = f_sum * f_sum
    b_rate_above_b = 0.5 * b_rate_above_a
    b_rate_above_c = sinc_sum * phi
    b_rate_above = b_rate_above_b - b_rate_above_c
    b_rate_above_right = b_rate_above_b - b_rate_above
    b_rate_above_lo1 = (b_rate_above_b - (b_rate_above + b_rate_above_right)
        - product_rest(sinc_sum, phi, b_rate_above_c, b_rate_above_right))
    b_rate_above_lo2 = (b_rate_above_lo1
        - (sinc_sum_lo * phi + sinc_sum
        * where(far_y_a, series_phi_lo, closed_phi_residual / twice_y_sum)))
    b_rate_above_lo = (b_rate_above_lo2 + 0.5
        * (product_error(f_sum, f_sum, b_rate_above_a) + (f_sum_lo * f_sum + f_sum * f_sum_lo)))
    b_rate_below_a = sinc_sum * sinc_sum
    b_rate_below = 8 * b_rate_below_a
    b_rate_below_cross2 = (8
        * (product_error(sinc_sum, sinc_sum, b_rate_below_a)
        + (sinc_sum_lo * sinc_sum + sinc_sum * sinc_sum_lo)))
    b_rate_above_sum = b_rate_above + b_rate_above_lo
    b_rate_above_sum_right = b_rate_above_sum - b_rate_above
    b_rate_below_sum = b_rate_below + b_rate_below_cross2
    b_rate_below_sum_right = b_rate_below_sum - b_rate_below
    b_rate = b_rate_above_sum / b_rate_below_sum
    b_rate_product = b_rate * b_rate_below_sum
    b_rate_above_sum_lo = (b_rate_above - (b_rate_above_sum - b_rate_above_sum_right)
        + (b_rate_above_lo - b_rate_above_sum_right))
    b_rate_cross = (b_rate
        * (b_rate_below - (b_rate_below_sum - b_rate_below_sum_right)
        + (b_rate_below_cross2 - b_rate_below_sum_right)))
    b_rate_residual = (b_rate_above_sum - b_rate_product
        - product_error(b_rate, b_rate_below_sum, b_rate_product) + b_rate_above_sum_lo
        - b_rate_cross)
    rate_vw_a = s_0 * s_3
    rate_vw_b = s_1 * s_4
    rate_vw_c = rate_vw_a + rate_vw_b
    rate_vw_c_right = rate_vw_c - rate_vw_a
    rate_vw_d = s_2 * s_5
    rate_vw = rate_vw_c + rate_vw_d
    rate_vw_right = rate_vw - rate_vw_c
    rate_vw_c_lo = (product_rest(s_0, s_3, rate_vw_a, rate_vw_c - rate_vw_c_right)
        + product_rest(s_1, s_4, rate_vw_b, rate_vw_c_right))
    rate_bend_a_cross2 = (b_rate
        * (rate_vw_c - (rate_vw - rate_vw_right) + product_rest(s_2, s_5, rate_vw_d, rate_vw_right)
        + rate_vw_c_lo))
    rate_bend = -(b_rate * rate_vw)
    rate_q_0 = -(0.5 * s_0)
    rate_q_1 = -(0.5 * s_1)
    rate_q_2 = -(0.5 * s_2)
    rate_beta_v_0 = s_0 * b
    rate_beta_v_1 = s_1 * b
    rate_beta_v_2 = s_2 * b
    rate_bend_lo = (product_error(-b_rate, rate_vw, rate_bend) +
        -(b_rate_residual / b_rate_below_sum * rate_vw + rate_bend_a_cross2))
    rate_bend_w_0 = s_3 * rate_bend
    rate_bend_w_1 = s_4 * rate_bend
    rate_bend_w_2 = s_5 * rate_bend
    rate_beta_v_1_lo = product_error(s_1, b, rate_beta_v_1) + s_1 * b_lo
    rate_symmetric_0a = s_3 * rate_beta_v_1
    rate_beta_v_0_lo = product_error(s_0, b, rate_beta_v_0) + s_0 * b_lo
    rate_symmetric_0b = s_4 * rate_beta_v_0
    rate_symmetric_0c = rate_symmetric_0a + rate_symmetric_0b
    rate_symmetric_0c_right = rate_symmetric_0c - rate_symmetric_0a
    rate_symmetric_0c_left_rest = product_rest(s_3, rate_beta_v_1, rate_symmetric_0a,
        rate_symmetric_0c - rate_symmetric_0c_right)
    rate_symmetric_0c_lo1 = (rate_symmetric_0c_left_rest
        + product_rest(s_4, rate_beta_v_0, rate_symmetric_0b, rate_symmetric_0c_right))
    rate_bend_w_0_lo = product_error(s_3, rate_bend, rate_bend_w_0) + s_3 * rate_bend_lo
    rate_symmetric_0d = s_4 * rate_bend_w_0
    rate_symmetric_0 = rate_symmetric_0c - rate_symmetric_0d
    rate_symmetric_0_right = rate_symmetric_0c - rate_symmetric_0
    rate_symmetric_0_right_rest = product_rest(s_4, rate_bend_w_0, rate_symmetric_0d,
        rate_symmetric_0_right)
    rate_symmetric_0_lo2 = (rate_symmetric_0c - (rate_symmetric_0 + rate_symmetric_0_right)
        - rate_symmetric_0_right_rest - s_4 * rate_bend_w_0_lo)
    rate_symmetric_0_lo = (rate_symmetric_0_lo2
        + (rate_symmetric_0c_lo1 + (s_3 * rate_beta_v_1_lo + s_4 * rate_beta_v_0_lo)))
    rate_beta_v_2_lo = product_error(s_2, b, rate_beta_v_2) + s_2 * b_lo
    rate_symmetric_1a = s_3 * rate_beta_v_2
    rate_symmetric_1b = s_5 * rate_beta_v_0
    rate_symmetric_1c = rate_symmetric_1a + rate_symmetric_1b
    rate_symmetric_1c_right = rate_symmetric_1c - rate_symmetric_1a
    rate_symmetric_1c_left_rest = product_rest(s_3, rate_beta_v_2, rate_symmetric_1a,
        rate_symmetric_1c - rate_symmetric_1c_right)
    rate_symmetric_1c_lo1 = (rate_symmetric_1c_left_rest
        + product_rest(s_5, rate_beta_v_0, rate_symmetric_1b, rate_symmetric_1c_right))
    rate_symmetric_1d = s_5 * rate_bend_w_0
    rate_symmetric_1 = rate_symmetric_1c - rate_symmetric_1d
    rate_symmetric_1_right = rate_symmetric_1c - rate_symmetric_1
    rate_symmetric_1_right_rest = product_rest(s_5, rate_bend_w_0, rate_symmetric_1d,
        rate_symmetric_1_right)
    rate_symmetric_1_lo2 = (rate_symmetric_1c - (rate_symmetric_1 + rate_symmetric_1_right)
        - rate_symmetric_1_right_rest - s_5 * rate_bend_w_0_lo)
    rate_symmetric_1_lo = (rate_symmetric_1_lo2
        + (rate_symmetric_1c_lo1 + (s_3 * rate_beta_v_2_lo + s_5 * rate_beta_v_0_lo)))
    rate_symmetric_2a = s_4 * rate_beta_v_2
    rate_symmetric_2b = s_5 * rate_beta_v_1
    rate_symmetric_2c = rate_symmetric_2a + rate_symmetric_2b
    rate_symmetric_2c_right = rate_symmetric_2c - rate_symmetric_2a
    rate_symmetric_2c_left_rest = product_rest(s_4, rate_beta_v_2, rate_symmetric_2a,
        rate_symmetric_2c - rate_symmetric_2c_right)
    rate_symmetric_2c_lo1 = (rate_symmetric_2c_left_rest
        + product_rest(s_5, rate_beta_v_1, rate_symmetric_2b, rate_symmetric_2c_right))
    rate_bend_w_1_lo = product_error(s_4, rate_bend, rate_bend_w_1) + s_4 * rate_bend_lo
    rate_symmetric_2d = s_5 * rate_bend_w_1
    rate_symmetric_2 = rate_symmetric_2c - rate_symmetric_2d
    rate_symmetric_2_right = rate_symmetric_2c - rate_symmetric_2
    rate_symmetric_2_right_rest = product_rest(s_5, rate_bend_w_1, rate_symmetric_2d,
        rate_symmetric_2_right)
    rate_symmetric_2_lo2 = (rate_symmetric_2c - (rate_symmetric_2 + rate_symmetric_2_right)
        - rate_symmetric_2_right_rest - s_5 * rate_bend_w_1_lo)
    rate_symmetric_2_lo = (rate_symmetric_2_lo2
        + (rate_symmetric_2c_lo1 + (s_4 * rate_beta_v_2_lo + s_5 * rate_beta_v_1_lo)))
    rate_diagonal_0a = s_4 * rate_bend_w_1
    rate_diagonal_0a_cross2 = s_4 * rate_bend_w_1_lo
    rate_diagonal_0b = s_5 * rate_bend_w_2
    rate_diagonal_0b_cross2 = (s_5
        * (product_error(s_5, rate_bend, rate_bend_w_2) + s_5 * rate_bend_lo))
    rate_diagonal_0c = rate_diagonal_0a + rate_diagonal_0b
    rate_diagonal_0c_right = rate_diagonal_0c - rate_diagonal_0a
    rate_diagonal_0c_left_rest = product_rest(s_4, rate_bend_w_1, rate_diagonal_0a,
        rate_diagonal_0c - rate_diagonal_0c_right)
    rate_diagonal_0c_lo1 = (rate_diagonal_0c_left_rest
        + product_rest(s_5, rate_bend_w_2, rate_diagonal_0b, rate_diagonal_0c_right))
    rate_diagonal_0d = 2 * s_4
    rate_diagonal_0e = rate_diagonal_0d * rate_beta_v_1
    rate_diagonal_0e_cross2 = rate_diagonal_0d * rate_beta_v_1_lo
    rate_diagonal_0f = 2 * s_5
    rate_diagonal_0g = rate_diagonal_0f * rate_beta_v_2
    rate_diagonal_0g_cross2 = rate_diagonal_0f * rate_beta_v_2_lo
    rate_diagonal_0h = rate_diagonal_0e + rate_diagonal_0g
    rate_diagonal_0h_right = rate_diagonal_0h - rate_diagonal_0e
    rate_diagonal_0h_left_rest = product_rest(rate_diagonal_0d, rate_beta_v_1, rate_diagonal_0e,
        rate_diagonal_0h - rate_diagonal_0h_right)
    rate_diagonal_0h_lo1 = (rate_diagonal_0h_left_rest
        + product_rest(rate_diagonal_0f, rate_beta_v_2, rate_diagonal_0g, rate_diagonal_0h_right))
    rate_diagonal_0 = rate_diagonal_0c - rate_diagonal_0h
    rate_diagonal_0_right = rate_diagonal_0c - rate_diagonal_0
    rate_diagonal_0_lo1 = (rate_diagonal_0c - (rate_diagonal_0 + rate_diagonal_0_right)
        - (rate_diagonal_0h - rate_diagonal_0_right))
    rate_diagonal_0_lo2 = (rate_diagonal_0_lo1
        - (rate_diagonal_0h_lo1 + (rate_diagonal_0e_cross2 + rate_diagonal_0g_cross2)))
    rate_diagonal_1a = s_3 * rate_bend_w_0
    rate_diagonal_1a_cross2 = s_3 * rate_bend_w_0_lo
    rate_diagonal_1b = rate_diagonal_1a + rate_diagonal_0b
    rate_diagonal_1b_right = rate_diagonal_1b - rate_diagonal_1a
    rate_diagonal_1b_left_rest = product_rest(s_3, rate_bend_w_0, rate_diagonal_1a,
        rate_diagonal_1b - rate_diagonal_1b_right)
    rate_diagonal_1b_lo1 = (rate_diagonal_1b_left_rest
        + product_rest(s_5, rate_bend_w_2, rate_diagonal_0b, rate_diagonal_1b_right))
    rate_diagonal_1c = 2 * s_3
    rate_diagonal_1d = rate_diagonal_1c * rate_beta_v_0
    rate_diagonal_1d_cross2 = rate_diagonal_1c * rate_beta_v_0_lo
    rate_diagonal_1e = rate_diagonal_1d + rate_diagonal_0g
    rate_diagonal_1e_right = rate_diagonal_1e - rate_diagonal_1d
    rate_diagonal_1e_left_rest = product_rest(rate_diagonal_1c, rate_beta_v_0, rate_diagonal_1d,
        rate_diagonal_1e - rate_diagonal_1e_right)
    rate_diagonal_1e_lo1 = (rate_diagonal_1e_left_rest
        + product_rest(rate_diagonal_0f, rate_beta_v_2, rate_diagonal_0g, rate_diagonal_1e_right))
    rate_diagonal_1 = rate_diagonal_1b - rate_diagonal_1e
    rate_diagonal_1_right = rate_diagonal_1b - rate_diagonal_1
    rate_diagonal_1_lo1 = (rate_diagonal_1b - (rate_diagonal_1 + rate_diagonal_1_right)
        - (rate_diagonal_1e - rate_diagonal_1_right))
    rate_diagonal_1_lo2 = (rate_diagonal_1_lo1
        - (rate_diagonal_1e_lo1 + (rate_diagonal_1d_cross2 + rate_diagonal_0g_cross2)))
    rate_diagonal_2a = rate_diagonal_1a + rate_diagonal_0a
    rate_diagonal_2a_right = rate_diagonal_2a - rate_diagonal_1a
    rate_diagonal_2a_left_rest = product_rest(s_3, rate_bend_w_0, rate_diagonal_1a,
        rate_diagonal_2a - rate_diagonal_2a_right)
    rate_diagonal_2a_lo1 = (rate_diagonal_2a_left_rest
        + product_rest(s_4, rate_bend_w_1, rate_diagonal_0a, rate_diagonal_2a_right))
    rate_diagonal_2b = rate_diagonal_1d + rate_diagonal_0e
    rate_diagonal_2b_right = rate_diagonal_2b - rate_diagonal_1d
    rate_diagonal_2b_left_rest = product_rest(rate_diagonal_1c, rate_beta_v_0, rate_diagonal_1d,
        rate_diagonal_2b - rate_diagonal_2b_right)
    rate_diagonal_2b_lo1 = (rate_diagonal_2b_left_rest
        + product_rest(rate_diagonal_0d, rate_beta_v_1, rate_diagonal_0e, rate_diagonal_2b_right))
    rate_diagonal_2 = rate_diagonal_2a - rate_diagonal_2b
    rate_diagonal_2_right = rate_diagonal_2a - rate_diagonal_2
    rate_diagonal_2_lo1 = (rate_diagonal_2a - (rate_diagonal_2 + rate_diagonal_2_right)
        - (rate_diagonal_2b - rate_diagonal_2_right))
    rate_diagonal_2_lo2 = (rate_diagonal_2_lo1
        - (rate_diagonal_2b_lo1 + (rate_diagonal_1d_cross2 + rate_diagonal_0e_cross2)))
    M_04 = rate_symmetric_0 - rate_q_2
    M_04_right = rate_symmetric_0 - M_04
    M_05 = rate_q_1 + rate_symmetric_1
    M_05_right = M_05 - rate_q_1
    M_13 = rate_q_2 + rate_symmetric_0
    M_13_right = M_13 - rate_q_2
    M_15 = rate_symmetric_2 - rate_q_0
    M_15_right = rate_symmetric_2 - M_15
    M_23 = rate_symmetric_1 - rate_q_1
    M_23_right = rate_symmetric_1 - M_23
    M_24 = rate_q_0 + rate_symmetric_2
    M_24_right = M_24 - rate_q_0
    diagonal0_rounded = (diagonal0
        + where(diagonal0c, diagonal0b_lo, 1 - (diagonal0a + diagonal0a_right)
        - (others_0 - diagonal0a_right) - others_0_lo))
    diagonal0_final = where(diagonal0_rounded == diagonal0_rounded, diagonal0_rounded, diagonal0)
    J_1_rounded = (J_1
        + (product_rest(s_4, beta_v_0, m_3, J_1 + J_1_right) - (alpha_v_2 - J_1_right)
        + m_3_cross2))
    J_1_final = where(J_1_rounded == J_1_rounded, J_1_rounded, J_1)
    J_2_rounded = (J_2
        + (product_rest(s_5, beta_v_0, m_4, J_2 - J_2_right) + (alpha_v_1 - J_2_right)
        + m_4_cross2))
    J_2_final = where(J_2_rounded == J_2_rounded, J_2_rounded, J_2)
    rate_diagonal_0_rounded = (rate_diagonal_0
        + (rate_diagonal_0_lo2
        + (rate_diagonal_0c_lo1 + (rate_diagonal_0a_cross2 + rate_diagonal_0b_cross2))))
    M_04_rounded = (M_04
        + (rate_symmetric_0 - (M_04 + M_04_right) - (rate_q_2 - M_04_right) + rate_symmetric_0_lo))
    M_05_rounded = (M_05
        + (rate_q_1 - (M_05 - M_05_right) + (rate_symmetric_1 - M_05_right) + rate_symmetric_1_lo))
    J_3_rounded = (J_3
        + (product_rest(s_4, beta_v_0, m_3, J_3 - J_3_right) + (alpha_v_2 - J_3_right)
        + m_3_cross2))
    J_3_final = where(J_3_rounded == J_3_rounded, J_3_rounded, J_3)
    diagonal1_rounded = (diagonal1
        + where(diagonal1c, diagonal1b_lo, 1 - (diagonal1a + diagonal1a_right)
        - (others_1 - diagonal1a_right) - others_1_lo))
    diagonal1_final = where(diagonal1_rounded == diagonal1_rounded, diagonal1_rounded, diagonal1)
    J_5_rounded = (J_5
        + (product_rest(s_5, beta_v_1, m_5, J_5 + J_5_right) - (alpha_v_0 - J_5_right)
        + m_5_cross2))
    J_5_final = where(J_5_rounded == J_5_rounded, J_5_rounded, J_5)
    M_13_rounded = (M_13
        + (rate_q_2 - (M_13 - M_13_right) + (rate_symmetric_0 - M_13_right) + rate_symmetric_0_lo))
    rate_diagonal_1_rounded = (rate_diagonal_1
        + (rate_diagonal_1_lo2
        + (rate_diagonal_1b_lo1 + (rate_diagonal_1a_cross2 + rate_diagonal_0b_cross2))))
    M_15_rounded = (M_15
        + (rate_symmetric_2 - (M_15 + M_15_right) - (rate_q_0 - M_15_right) + rate_symmetric_2_lo))
    J_6_rounded = (J_6
        + (product_rest(s_5, beta_v_0, m_4, J_6 + J_6_right) - (alpha_v_1 - J_6_right)
        + m_4_cross2))
    J_6_final = where(J_6_rounded == J_6_rounded, J_6_rounded, J_6)
    J_7_rounded = (J_7
        + (product_rest(s_5, beta_v_1, m_5, J_7 - J_7_right) + (alpha_v_0 - J_7_right)
        + m_5_cross2))
    J_7_final = where(J_7_rounded == J_7_rounded, J_7_rounded, J_7)
    diagonal2_rounded = (diagonal2
        + where(diagonal2c, diagonal2b_lo, 1 - (diagonal2a + diagonal2a_right)
        - (others_2 - diagonal2a_right) - others_2_lo))
    diagonal2_final = where(diagonal2_rounded == diagonal2_rounded, diagonal2_rounded, diagonal2)
    M_23_rounded = (M_23
        + (rate_symmetric_1 - (M_23 + M_23_right) - (rate_q_1 - M_23_right) + rate_symmetric_1_lo))
    M_24_rounded = (M_24
        + (rate_q_0 - (M_24 - M_24_right) + (rate_symmetric_2 - M_24_right) + rate_symmetric_2_lo))
    rate_diagonal_2_rounded = (rate_diagonal_2
        + (rate_diagonal_2_lo2
        + (rate_diagonal_2a_lo1 + (rate_diagonal_1a_cross2 + rate_diagonal_0a_cross2))))
    rate_diagonal_0_final = where(rate_diagonal_0_rounded == rate_diagonal_0_rounded,
        rate_diagonal_0_rounded, rate_diagonal_0)
    M_04_final = where(M_04_rounded == M_04_rounded, M_04_rounded, M_04)
    M_05_final = where(M_05_rounded == M_05_rounded, M_05_rounded, M_05)
    M_13_final = where(M_13_rounded == M_13_rounded, M_13_rounded, M_13)
    rate_diagonal_1_final = where(rate_diagonal_1_rounded == rate_diagonal_1_rounded,
        rate_diagonal_1_rounded, rate_diagonal_1)
    M_15_final = where(M_15_rounded == M_15_rounded, M_15_rounded, M_15)
    M_23_final = where(M_23_rounded == M_23_rounded, M_23_rounded, M_23)
    M_24_final = where(M_24_rounded == M_24_rounded, M_24_rounded, M_24)
    rate_diagonal_2_final = where(rate_diagonal_2_rounded == rate_diagonal_2_rounded,
        rate_diagonal_2_rounded, rate_diagonal_2)
    return (diagonal0_final, J_1_final, J_2_final, rate_diagonal_0_final, M_04_final, M_05_final,
        J_3_final, diagonal1_final, J_5_final, M_13_final, rate_diagonal_1_final, M_15_final,
        J_6_final, J_7_final, diagonal2_final, M_23_final, M_24_final, rate_diagonal_2_final, 0, 0,
        0, diagonal0_final, J_1_final, J_2_final, 0, 0, 0, J_3_final, diagonal1_final, J_5_final, 0,
        0, 0, J_6_final, J_7_final, diagonal2_final)


@kernel("(6)->(6,6)")
def SE3_rightJacobianInverse(s):
    """M = J_r(s)^-1; singular where |ω| is a multiple of 2π except 0.

    (6)->(6,6).  s: screw (v in m/s; ω in rad/s); M: 6×6 operator.
    283 mul, 721 add, 34 product error, 60 product rest, 14 div, 1 sqrt, 21 neg, 4 abs, 6 less,
    19 equal, 36 select.  Error <= M: 1 u of its largest component for |ω of s| <= π; searched,
    not proved.  Each component is within 1 ulp as long as its condition is below 1e13; in
    single precision it is the nearest number, except near ties, as long as that is below 1e5;
    searched, not proved.  Intermediate sums may overflow where |v| is above 2e306, in single
    precision 5e36.
    """
    s_0, s_1, s_2, s_3, s_4, s_5 = s
    halved_0 = 0.5 * s_3
    halved_1 = 0.5 * s_4
    halved_2 = 0.5 * s_5
    y_a = halved_0 * halved_0
    y_b = halved_1 * halved_1
    y_c = y_a + y_b
    y_c_right = y_c - y_a
    y_d = halved_2 * halved_2
    y = y_c + y_d
    y_right = y - y_c
    y_c_lo = (product_rest(halved_0, halved_0, y_a, y_c - y_c_right)
        + product_rest(halved_1, halved_1, y_b, y_c_right))
    y_lo = y_c - (y - y_right) + product_rest(halved_2, halved_2, y_d, y_right) + y_c_lo
    y_sum = y + y_lo
    y_sum_right = y_sum - y
    y_sum_lo = y - (y_sum - y_sum_right) + (y_lo - y_sum_right)
    half_angle = sqrt(y_sum)
    half_angle_product = half_angle * half_angle
    half_angle_residual = (y_sum - half_angle_product
        - product_error(half_angle, half_angle, half_angle_product) + y_sum_lo)
    half_angle_lo = half_angle_residual / where(half_angle == 0, 1, half_angle + half_angle)
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
    c_lo = c_own_error - (sine_half_cos * sine + sine_half_sin * c) * sine_twice
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
    sinc_a = 0.16666666666666666 * y_sum
    sinc_b = 1 - sinc_a
    sinc_b_right = 1 - sinc_b
    sinc_b_lo1 = (1 - (sinc_b + sinc_b_right)
        - product_rest(0.16666666666666666, y_sum, sinc_a, sinc_b_right))
    sinc = where(sinc_divisor_a, sinc_b, sinc_quotient)
    sinc_quotient_lo = ((sinc_quotient_exact
        + (sine - (sine_sum - sine_sum_right) + (sine_lo - sine_sum_right)) - sinc_quotient_cross)
        / sinc_divisor_sum)
    sinc_lo = where(sinc_divisor_a,
        sinc_b_lo1 - (9.25185853854297e-18 * y_sum + 0.16666666666666666 * y_sum_lo),
        sinc_quotient_lo)
    series_phi_a = 5.107725174524775e-32 * y_sum
    series_phi_b = 4.116826490666969e-29 - series_phi_a
    series_phi_b_right = 4.116826490666969e-29 - series_phi_b
    series_phi_b_right_rest = product_rest(5.107725174524775e-32, y_sum, series_phi_a,
        series_phi_b_right)
    series_phi_b_lo1 = (4.116826490666969e-29 - (series_phi_b + series_phi_b_right)
        - series_phi_b_right_rest)
    series_phi_c = y_sum * series_phi_b
    series_phi_c_cross2 = (y_sum
        * (series_phi_b_lo1 - (4.7410392187559056e-48 * y_sum + 5.107725174524775e-32 * y_sum_lo) +
        -1.8714974010023092e-45))
    series_phi_d = series_phi_c - 2.86531123750421e-26
    series_phi_d_right = series_phi_c - series_phi_d
    series_phi_d_lo1 = (product_rest(y_sum, series_phi_b, series_phi_c, series_phi_d
        + series_phi_d_right) - (2.86531123750421e-26 - series_phi_d_right))
    series_phi_e = y_sum * series_phi_d
    series_phi_f = series_phi_e + 1.701994875077501e-23
    series_phi_f_right = series_phi_f - series_phi_e
    series_phi_f_lo1 = (product_rest(y_sum, series_phi_d, series_phi_e, series_phi_f
        - series_phi_f_right) + (1.701994875077501e-23 - series_phi_f_right))
    series_phi_e_cross = (y_sum_lo * series_phi_d + y_sum
        * (series_phi_d_lo1 - 2.3296034284323186e-42
        + (y_sum_lo * series_phi_b + series_phi_c_cross2)))
    series_phi_g = y_sum * series_phi_f
    series_phi_h = series_phi_g - 8.509974375387505e-21
    series_phi_h_right = series_phi_g - series_phi_h
    series_phi_h_lo1 = (product_rest(y_sum, series_phi_f, series_phi_g, series_phi_h
        + series_phi_h_right) - (8.509974375387505e-21 - series_phi_h_right))
    series_phi_g_cross = (y_sum_lo * series_phi_f + y_sum
        * (series_phi_f_lo1 + 3.161967936521494e-40 + series_phi_e_cross))
    series_phi_i = y_sum * series_phi_h
    series_phi_j = series_phi_i + 3.523129391410427e-18
    series_phi_j_right = series_phi_j - series_phi_i
    series_phi_j_lo1 = (product_rest(y_sum, series_phi_h, series_phi_i, series_phi_j
        - series_phi_j_right) + (3.523129391410427e-18 - series_phi_j_right))
    series_phi_i_cross = (y_sum_lo * series_phi_h + y_sum
        * (series_phi_h_lo1 - 3.2266760594119493e-37 + series_phi_g_cross))
    series_phi_k = y_sum * series_phi_j
    series_phi_l = series_phi_k - 1.1837714755139035e-15
    series_phi_l_right = series_phi_k - series_phi_l
    series_phi_l_lo1 = (product_rest(y_sum, series_phi_j, series_phi_k, series_phi_l
        + series_phi_l_right) - (1.1837714755139035e-15 - series_phi_l_right))
    series_phi_k_cross = (y_sum_lo * series_phi_j + y_sum
        * (series_phi_j_lo1 + -1.2521244741738012e-34 + series_phi_i_cross))
    series_phi_m = y_sum * series_phi_l
    series_phi_n = series_phi_m + 3.148832124866983e-13
    series_phi_n_right = series_phi_n - series_phi_m
    series_phi_n_lo1 = (product_rest(y_sum, series_phi_l, series_phi_m, series_phi_n
        - series_phi_n_right) + (3.148832124866983e-13 - series_phi_n_right))
    series_phi_m_cross = (y_sum_lo * series_phi_l + y_sum
        * (series_phi_l_lo1 - 7.23242424407352e-33 + series_phi_k_cross))
    series_phi_o = y_sum * series_phi_n
    series_phi_p = series_phi_o - 6.423617534728645e-11
    series_phi_p_right = series_phi_o - series_phi_p
    series_phi_p_lo1 = (product_rest(y_sum, series_phi_n, series_phi_o, series_phi_p
        + series_phi_p_right) - (6.423617534728645e-11 - series_phi_p_right))
    series_phi_o_cross = (y_sum_lo * series_phi_n + y_sum
        * (series_phi_n_lo1 + 5.8681293750286156e-30 + series_phi_m_cross))
    series_phi_q = y_sum * series_phi_p
    series_phi_r = series_phi_q + 9.635426302092969e-09
    series_phi_r_right = series_phi_r - series_phi_q
    series_phi_r_lo1 = (product_rest(y_sum, series_phi_p, series_phi_q, series_phi_r
        - series_phi_r_right) + (9.635426302092969e-09 - series_phi_r_right))
    series_phi_q_cross = (y_sum_lo * series_phi_p + y_sum
        * (series_phi_p_lo1 - 5.034117835500839e-27 + series_phi_o_cross))
    series_phi_s = y_sum * series_phi_r
    series_phi_t = series_phi_s - 1.0020843354176687e-06
    series_phi_t_right = series_phi_s - series_phi_t
    series_phi_t_lo1 = (product_rest(y_sum, series_phi_r, series_phi_s, series_phi_t
        + series_phi_t_right) - (1.0020843354176687e-06 - series_phi_t_right))
    series_phi_s_cross = (y_sum_lo * series_phi_r + y_sum
        * (series_phi_r_lo1 + -1.7546051379703029e-25 + series_phi_q_cross))
    series_phi_u = y_sum * series_phi_t
    series_phi_v = series_phi_u + 6.613756613756614e-05
    series_phi_v_right = series_phi_v - series_phi_u
    series_phi_v_lo1 = (product_rest(y_sum, series_phi_t, series_phi_u, series_phi_v
        - series_phi_v_right) + (6.613756613756614e-05 - series_phi_v_right))
    series_phi_u_cross = (y_sum_lo * series_phi_t + y_sum
        * (series_phi_t_lo1 - 4.7926555569351065e-23 + series_phi_s_cross))
    series_phi_w = y_sum * series_phi_v
    series_phi_x = series_phi_w - 0.002380952380952381
    series_phi_x_right = series_phi_w - series_phi_x
    series_phi_x_lo1 = (product_rest(y_sum, series_phi_v, series_phi_w, series_phi_x
        + series_phi_x_right) - (0.002380952380952381 - series_phi_x_right))
    series_phi_w_cross = (y_sum_lo * series_phi_v + y_sum
        * (series_phi_v_lo1 + -4.460143857711533e-21 + series_phi_u_cross))
    series_phi_y = y_sum * series_phi_x
    series_phi = series_phi_y + 0.03333333333333333
    series_phi_right = series_phi - series_phi_y
    series_phi_lo1 = (product_rest(y_sum, series_phi_x, series_phi_y, series_phi
        - series_phi_right) + (0.03333333333333333 - series_phi_right))
    series_phi_y_cross = (y_sum_lo * series_phi_x + y_sum
        * (series_phi_x_lo1 - -2.147752875018904e-19 + series_phi_w_cross))
    series_phi_lo = series_phi_lo1 + 4.625929269271486e-19 + series_phi_y_cross
    f_more_a = 2 * y_sum
    f_more = f_more_a * series_phi
    near_f_a = 0.3333333333333333 * sinc
    near_f_b = 0.3333333333333333 * f_more
    near_f_b_cross2 = (0.3333333333333333
        * (product_error(f_more_a, series_phi, f_more)
        + (2 * y_sum_lo * series_phi + f_more_a * series_phi_lo)))
    near_f = near_f_a + near_f_b
    near_f_right = near_f - near_f_a
    near_f_left_rest = product_rest(0.3333333333333333, sinc, near_f_a, near_f - near_f_right)
    near_f_cross = (1.850371707708594e-17 * sinc + 0.3333333333333333 * sinc_lo
        + (1.850371707708594e-17 * f_more + near_f_b_cross2))
    f_rest = sinc - c
    f_rest_right = sinc - f_rest
    f_rest_lo = sinc - (f_rest + f_rest_right) - (c - f_rest_right) - c_lo + sinc_lo
    x = 4 * y_sum
    far_y_a = x + 4 * y_sum_lo < 4
    far_y = where(far_y_a, 1, y_sum)
    far_y_lo = where(far_y_a, 0, y_sum_lo)
    f_rest_sum = f_rest + f_rest_lo
    f_rest_sum_right = f_rest_sum - f_rest
    far_y_sum = far_y + far_y_lo
    far_y_sum_right = far_y_sum - far_y
    far_y_sum_lo = far_y - (far_y_sum - far_y_sum_right) + (far_y_lo - far_y_sum_right)
    closed_f = f_rest_sum / far_y_sum
    closed_f_product = closed_f * far_y_sum
    closed_f_exact = (f_rest_sum - closed_f_product
        - product_error(closed_f, far_y_sum, closed_f_product))
    f = where(far_y_a, near_f, closed_f)
    closed_f_lo = ((closed_f_exact
        + (f_rest - (f_rest_sum - f_rest_sum_right) + (f_rest_lo - f_rest_sum_right)) - closed_f
        * far_y_sum_lo) / far_y_sum)
    f_lo = where(far_y_a, near_f_left_rest + product_rest(0.3333333333333333, f_more, near_f_b,
        near_f_right) + near_f_cross, closed_f_lo)
    four_k = 4 * sinc
    four_k_cross2 = 4 * sinc_lo
    f_sum = f + f_lo
    f_sum_right = f_sum - f
    f_sum_lo = f - (f_sum - f_sum_right) + (f_lo - f_sum_right)
    four_k_sum = four_k + four_k_cross2
    four_k_sum_right = four_k_sum - four_k
    b = f_sum / four_k_sum
    b_product = b * four_k_sum
    b_cross = b * (four_k - (four_k_sum - four_k_sum_right) + (four_k_cross2 - four_k_sum_right))
    b_lo = ((f_sum - b_product - product_error(b, four_k_sum, b_product) + f_sum_lo - b_cross)
        / four_k_sum)
    c_sum = c + c_lo
    c_sum_right = c_sum - c
    sinc_sum = sinc + sinc_lo
    sinc_sum_right = sinc_sum - sinc
    sinc_sum_lo = sinc - (sinc_sum - sinc_sum_right) + (sinc_lo - sinc_sum_right)
    b_across = c_sum / sinc_sum
    b_across_product = b_across * sinc_sum
    b_across_exact = c_sum - b_across_product - product_error(b_across, sinc_sum, b_across_product)
    b_across_lo = ((b_across_exact + (c - (c_sum - c_sum_right) + (c_lo - c_sum_right)) - b_across
        * sinc_sum_lo) / sinc_sum)
    beta_v_0 = s_3 * b
    beta_v_1 = s_4 * b
    beta_v_2 = s_5 * b
    beta_v_0_lo = product_error(s_3, b, beta_v_0) + s_3 * b_lo
    m_0 = s_3 * beta_v_0
    m_0_cross2 = s_3 * beta_v_0_lo
    beta_v_1_lo = product_error(s_4, b, beta_v_1) + s_4 * b_lo
    m_1 = s_4 * beta_v_1
    m_1_cross2 = s_4 * beta_v_1_lo
    m_2 = s_5 * beta_v_2
    m_2_cross2 = s_5 * (product_error(s_5, b, beta_v_2) + s_5 * b_lo)
    m_3 = s_4 * beta_v_0
    m_3_cross2 = s_4 * beta_v_0_lo
    m_4 = s_5 * beta_v_0
    m_4_cross2 = s_5 * beta_v_0_lo
    m_5 = s_5 * beta_v_1
    m_5_cross2 = s_5 * beta_v_1_lo
    others_0 = m_1 + m_2
    others_0_right = others_0 - m_1
    others_0_lo1 = (product_rest(s_4, beta_v_1, m_1, others_0 - others_0_right)
        + product_rest(s_5, beta_v_2, m_2, others_0_right))
    others_0_lo = others_0_lo1 + (m_1_cross2 + m_2_cross2)
    others_1 = m_0 + m_2
    others_1_right = others_1 - m_0
    others_1_lo1 = (product_rest(s_3, beta_v_0, m_0, others_1 - others_1_right)
        + product_rest(s_5, beta_v_2, m_2, others_1_right))
    others_1_lo = others_1_lo1 + (m_0_cross2 + m_2_cross2)
    others_2 = m_0 + m_1
    others_2_right = others_2 - m_0
    others_2_lo1 = (product_rest(s_3, beta_v_0, m_0, others_2 - others_2_right)
        + product_rest(s_4, beta_v_1, m_1, others_2_right))
    others_2_lo = others_2_lo1 + (m_0_cross2 + m_1_cross2)
    diagonal0a = 1 - others_0
    diagonal0a_right = 1 - diagonal0a
    diagonal0b = b_across + m_0
    diagonal0b_right = diagonal0b - b_across
    diagonal0c = m_0 + (product_error(s_3, beta_v_0, m_0) + m_0_cross2) < others_0 + others_0_lo
    diagonal0 = where(diagonal0c, diagonal0b, diagonal0a)
    diagonal0b_lo = (b_across - (diagonal0b - diagonal0b_right)
        + product_rest(s_3, beta_v_0, m_0, diagonal0b_right) + m_0_cross2 + b_across_lo)
    diagonal1a = 1 - others_1
    diagonal1a_right = 1 - diagonal1a
    diagonal1b = b_across + m_1
    diagonal1b_right = diagonal1b - b_across
    diagonal1c = m_1 + (product_error(s_4, beta_v_1, m_1) + m_1_cross2) < others_1 + others_1_lo
    diagonal1 = where(diagonal1c, diagonal1b, diagonal1a)
    diagonal1b_lo = (b_across - (diagonal1b - diagonal1b_right)
        + product_rest(s_4, beta_v_1, m_1, diagonal1b_right) + m_1_cross2 + b_across_lo)
    diagonal2a = 1 - others_2
    diagonal2a_right = 1 - diagonal2a
    diagonal2b = b_across + m_2
    diagonal2b_right = diagonal2b - b_across
    diagonal2c = m_2 + (product_error(s_5, beta_v_2, m_2) + m_2_cross2) < others_2 + others_2_lo
    diagonal2 = where(diagonal2c, diagonal2b, diagonal2a)
    diagonal2b_lo = (b_across - (diagonal2b - diagonal2b_right)
        + product_rest(s_5, beta_v_2, m_2, diagonal2b_right) + m_2_cross2 + b_across_lo)
    J_1 = m_3 - halved_2
    J_1_right = m_3 - J_1
    J_2 = halved_1 + m_4
    J_2_right = J_2 - halved_1
    J_3 = halved_2 + m_3
    J_3_right = J_3 - halved_2
    J_5 = m_5 - halved_0
    J_5_right = m_5 - J_5
    J_6 = m_4 - halved_1
    J_6_right = m_4 - J_6
    J_7 = halved_0 + m_5
    J_7_right = J_7 - halved_0
    phi_rest_a = 3 * f_sum
    phi_rest = phi_rest_a - sinc_sum
    phi_rest_right = phi_rest_a - phi_rest
    phi_rest_lo = (product_rest(3, f_sum, phi_rest_a, phi_rest + phi_rest_right)
        - (sinc_sum - phi_rest_right) - sinc_sum_lo + 3 * f_sum_lo)
    twice_y = 2 * far_y_sum
    twice_y_cross2 = 2 * far_y_sum_lo
    phi_rest_sum = phi_rest + phi_rest_lo
    phi_rest_sum_right = phi_rest_sum - phi_rest
    twice_y_sum = twice_y + twice_y_cross2
    twice_y_sum_right = twice_y_sum - twice_y
    closed_phi = phi_rest_sum / twice_y_sum
    closed_phi_product = closed_phi * twice_y_sum
    closed_phi_exact = (phi_rest_sum - closed_phi_product
        - product_error(closed_phi, twice_y_sum, closed_phi_product))
    closed_phi_numerator = (closed_phi_exact
        + (phi_rest - (phi_rest_sum - phi_rest_sum_right) + (phi_rest_lo - phi_rest_sum_right)))
    closed_phi_residual = (closed_phi_numerator - closed_phi
        * (twice_y - (twice_y_sum - twice_y_sum_right) + (twice_y_cross2 - twice_y_sum_right)))
    phi = where(far_y_a, series_phi, closed_phi)
    b_rate_above_a = f_sum * f_sum
    b_rate_above_b = 0.5 * b_rate_above_a
    b_rate_above_c = sinc_sum * phi
    b_rate_above = b_rate_above_b - b_rate_above_c
    b_rate_above_right = b_rate_above_b - b_rate_above
    b_rate_above_lo1 = (b_rate_above_b - (b_rate_above + b_rate_above_right)
        - product_rest(sinc_sum, phi, b_rate_above_c, b_rate_above_right))
    b_rate_above_lo2 = (b_rate_above_lo1
        - (sinc_sum_lo * phi + sinc_sum
        * where(far_y_a, series_phi_lo, closed_phi_residual / twice_y_sum)))
    b_rate_above_lo = (b_rate_above_lo2 + 0.5
        * (product_error(f_sum, f_sum, b_rate_above_a) + (f_sum_lo * f_sum + f_sum * f_sum_lo)))
    b_rate_below_a = sinc_sum * sinc_sum
    b_rate_below = 8 * b_rate_below_a
    b_rate_below_cross2 = (8
        * (product_error(sinc_sum, sinc_sum, b_rate_below_a)
        + (sinc_sum_lo * sinc_sum + sinc_sum * sinc_sum_lo)))
    b_rate_above_sum = b_rate_above + b_rate_above_lo
    b_rate_above_sum_right = b_rate_above_sum - b_rate_above
    b_rate_below_sum = b_rate_below + b_rate_below_cross2
    b_rate_below_sum_right = b_rate_below_sum - b_rate_below
    b_rate = b_rate_above_sum / b_rate_below_sum
    b_rate_product = b_rate * b_rate_below_sum
    b_rate_above_sum_lo = (b_rate_above - (b_rate_above_sum - b_rate_above_sum_right)
        + (b_rate_above_lo - b_rate_above_sum_right))
    b_rate_cross = (b_rate
        * (b_rate_below - (b_rate_below_sum - b_rate_below_sum_right)
        + (b_rate_below_cross2 - b_rate_below_sum_right)))
    b_rate_residual = (b_rate_above_sum - b_rate_product
        - product_error(b_rate, b_rate_below_sum, b_rate_product) + b_rate_above_sum_lo
        - b_rate_cross)
    rate_vw_a = s_0 * s_3
    rate_vw_b = s_1 * s_4
    rate_vw_c = rate_vw_a + rate_vw_b
    rate_vw_c_right = rate_vw_c - rate_vw_a
    rate_vw_d = s_2 * s_5
    rate_vw = rate_vw_c + rate_vw_d
    rate_vw_right = rate_vw - rate_vw_c
    rate_vw_c_lo = (product_rest(s_0, s_3, rate_vw_a, rate_vw_c - rate_vw_c_right)
        + product_rest(s_1, s_4, rate_vw_b, rate_vw_c_right))
    rate_bend_a_cross2 = (b_rate
        * (rate_vw_c - (rate_vw - rate_vw_right) + product_rest(s_2, s_5, rate_vw_d, rate_vw_right)
        + rate_vw_c_lo))
    rate_bend = -(b_rate * rate_vw)
    rate_q_0 = 0.5 * s_0
    rate_q_1 = 0.5 * s_1
    rate_q_2 = 0.5 * s_2
    rate_beta_v_0 = -(s_0 * b)
    rate_beta_v_1 = -(s_1 * b)
    rate_beta_v_2 = -(s_2 * b)
    rate_bend_lo = (product_error(-b_rate, rate_vw, rate_bend) +
        -(b_rate_residual / b_rate_below_sum * rate_vw + rate_bend_a_cross2))
    rate_bend_w_0 = -(s_3 * rate_bend)
    rate_bend_w_1 = -(s_4 * rate_bend)
    rate_bend_w_2 = -(s_5 * rate_bend)
    rate_bend_w_0_lo = product_error(-s_3, rate_bend, rate_bend_w_0) + -(s_3 * rate_bend_lo)
    rate_symmetric_0a = s_4 * rate_bend_w_0
    rate_beta_v_1_lo = product_error(-s_1, b, rate_beta_v_1) + -(s_1 * b_lo)
    rate_symmetric_0b = s_3 * rate_beta_v_1
    rate_beta_v_0_lo = product_error(-s_0, b, rate_beta_v_0) + -(s_0 * b_lo)
    rate_symmetric_0c = s_4 * rate_beta_v_0
    rate_symmetric_0d = rate_symmetric_0b + rate_symmetric_0c
    rate_symmetric_0d_right = rate_symmetric_0d - rate_symmetric_0b
    rate_symmetric_0d_left_rest = product_rest(s_3, rate_beta_v_1, rate_symmetric_0b,
        rate_symmetric_0d - rate_symmetric_0d_right)
    rate_symmetric_0d_lo1 = (rate_symmetric_0d_left_rest
        + product_rest(s_4, rate_beta_v_0, rate_symmetric_0c, rate_symmetric_0d_right))
    rate_symmetric_0 = rate_symmetric_0a - rate_symmetric_0d
    rate_symmetric_0_right = rate_symmetric_0a - rate_symmetric_0
    rate_symmetric_0_left_rest = product_rest(s_4, rate_bend_w_0, rate_symmetric_0a,
        rate_symmetric_0 + rate_symmetric_0_right)
    rate_symmetric_0_lo1 = rate_symmetric_0_left_rest - (rate_symmetric_0d - rate_symmetric_0_right)
    rate_symmetric_0_lo = (rate_symmetric_0_lo1
        - (rate_symmetric_0d_lo1 + (s_3 * rate_beta_v_1_lo + s_4 * rate_beta_v_0_lo)) + s_4
        * rate_bend_w_0_lo)
    rate_symmetric_1a = s_5 * rate_bend_w_0
    rate_beta_v_2_lo = product_error(-s_2, b, rate_beta_v_2) + -(s_2 * b_lo)
    rate_symmetric_1b = s_3 * rate_beta_v_2
    rate_symmetric_1c = s_5 * rate_beta_v_0
    rate_symmetric_1d = rate_symmetric_1b + rate_symmetric_1c
    rate_symmetric_1d_right = rate_symmetric_1d - rate_symmetric_1b
    rate_symmetric_1d_left_rest = product_rest(s_3, rate_beta_v_2, rate_symmetric_1b,
        rate_symmetric_1d - rate_symmetric_1d_right)
    rate_symmetric_1d_lo1 = (rate_symmetric_1d_left_rest
        + product_rest(s_5, rate_beta_v_0, rate_symmetric_1c, rate_symmetric_1d_right))
    rate_symmetric_1 = rate_symmetric_1a - rate_symmetric_1d
    rate_symmetric_1_right = rate_symmetric_1a - rate_symmetric_1
    rate_symmetric_1_left_rest = product_rest(s_5, rate_bend_w_0, rate_symmetric_1a,
        rate_symmetric_1 + rate_symmetric_1_right)
    rate_symmetric_1_lo1 = rate_symmetric_1_left_rest - (rate_symmetric_1d - rate_symmetric_1_right)
    rate_symmetric_1_lo = (rate_symmetric_1_lo1
        - (rate_symmetric_1d_lo1 + (s_3 * rate_beta_v_2_lo + s_5 * rate_beta_v_0_lo)) + s_5
        * rate_bend_w_0_lo)
    rate_bend_w_1_lo = product_error(-s_4, rate_bend, rate_bend_w_1) + -(s_4 * rate_bend_lo)
    rate_symmetric_2a = s_5 * rate_bend_w_1
    rate_symmetric_2b = s_4 * rate_beta_v_2
    rate_symmetric_2c = s_5 * rate_beta_v_1
    rate_symmetric_2d = rate_symmetric_2b + rate_symmetric_2c
    rate_symmetric_2d_right = rate_symmetric_2d - rate_symmetric_2b
    rate_symmetric_2d_left_rest = product_rest(s_4, rate_beta_v_2, rate_symmetric_2b,
        rate_symmetric_2d - rate_symmetric_2d_right)
    rate_symmetric_2d_lo1 = (rate_symmetric_2d_left_rest
        + product_rest(s_5, rate_beta_v_1, rate_symmetric_2c, rate_symmetric_2d_right))
    rate_symmetric_2 = rate_symmetric_2a - rate_symmetric_2d
    rate_symmetric_2_right = rate_symmetric_2a - rate_symmetric_2
    rate_symmetric_2_left_rest = product_rest(s_5, rate_bend_w_1, rate_symmetric_2a,
        rate_symmetric_2 + rate_symmetric_2_right)
    rate_symmetric_2_lo1 = rate_symmetric_2_left_rest - (rate_symmetric_2d - rate_symmetric_2_right)
    rate_symmetric_2_lo = (rate_symmetric_2_lo1
        - (rate_symmetric_2d_lo1 + (s_4 * rate_beta_v_2_lo + s_5 * rate_beta_v_1_lo)) + s_5
        * rate_bend_w_1_lo)
    rate_diagonal_0a = 2 * s_4
    rate_diagonal_0b = rate_diagonal_0a * rate_beta_v_1
    rate_diagonal_0b_cross2 = rate_diagonal_0a * rate_beta_v_1_lo
    rate_diagonal_0c = 2 * s_5
    rate_diagonal_0d = rate_diagonal_0c * rate_beta_v_2
    rate_diagonal_0d_cross2 = rate_diagonal_0c * rate_beta_v_2_lo
    rate_diagonal_0e = rate_diagonal_0b + rate_diagonal_0d
    rate_diagonal_0e_right = rate_diagonal_0e - rate_diagonal_0b
    rate_diagonal_0e_left_rest = product_rest(rate_diagonal_0a, rate_beta_v_1, rate_diagonal_0b,
        rate_diagonal_0e - rate_diagonal_0e_right)
    rate_diagonal_0e_lo1 = (rate_diagonal_0e_left_rest
        + product_rest(rate_diagonal_0c, rate_beta_v_2, rate_diagonal_0d, rate_diagonal_0e_right))
    rate_diagonal_0f = s_4 * rate_bend_w_1
    rate_diagonal_0f_cross2 = s_4 * rate_bend_w_1_lo
    rate_diagonal_0g = s_5 * rate_bend_w_2
    rate_diagonal_0g_cross2 = (s_5
        * (product_error(-s_5, rate_bend, rate_bend_w_2) + -(s_5 * rate_bend_lo)))
    rate_diagonal_0h = rate_diagonal_0f + rate_diagonal_0g
    rate_diagonal_0h_right = rate_diagonal_0h - rate_diagonal_0f
    rate_diagonal_0h_left_rest = product_rest(s_4, rate_bend_w_1, rate_diagonal_0f,
        rate_diagonal_0h - rate_diagonal_0h_right)
    rate_diagonal_0h_lo1 = (rate_diagonal_0h_left_rest
        + product_rest(s_5, rate_bend_w_2, rate_diagonal_0g, rate_diagonal_0h_right))
    rate_diagonal_0 = rate_diagonal_0e - rate_diagonal_0h
    rate_diagonal_0_right = rate_diagonal_0e - rate_diagonal_0
    rate_diagonal_0_lo1 = (rate_diagonal_0e - (rate_diagonal_0 + rate_diagonal_0_right)
        - (rate_diagonal_0h - rate_diagonal_0_right))
    rate_diagonal_0_lo2 = (rate_diagonal_0_lo1
        - (rate_diagonal_0h_lo1 + (rate_diagonal_0f_cross2 + rate_diagonal_0g_cross2)))
    rate_diagonal_1a = 2 * s_3
    rate_diagonal_1b = rate_diagonal_1a * rate_beta_v_0
    rate_diagonal_1b_cross2 = rate_diagonal_1a * rate_beta_v_0_lo
    rate_diagonal_1c = rate_diagonal_1b + rate_diagonal_0d
    rate_diagonal_1c_right = rate_diagonal_1c - rate_diagonal_1b
    rate_diagonal_1c_left_rest = product_rest(rate_diagonal_1a, rate_beta_v_0, rate_diagonal_1b,
        rate_diagonal_1c - rate_diagonal_1c_right)
    rate_diagonal_1c_lo1 = (rate_diagonal_1c_left_rest
        + product_rest(rate_diagonal_0c, rate_beta_v_2, rate_diagonal_0d, rate_diagonal_1c_right))
    rate_diagonal_1d = s_3 * rate_bend_w_0
    rate_diagonal_1d_cross2 = s_3 * rate_bend_w_0_lo
    rate_diagonal_1e = rate_diagonal_1d + rate_diagonal_0g
    rate_diagonal_1e_right = rate_diagonal_1e - rate_diagonal_1d
    rate_diagonal_1e_left_rest = product_rest(s_3, rate_bend_w_0, rate_diagonal_1d,
        rate_diagonal_1e - rate_diagonal_1e_right)
    rate_diagonal_1e_lo1 = (rate_diagonal_1e_left_rest
        + product_rest(s_5, rate_bend_w_2, rate_diagonal_0g, rate_diagonal_1e_right))
    rate_diagonal_1 = rate_diagonal_1c - rate_diagonal_1e
    rate_diagonal_1_right = rate_diagonal_1c - rate_diagonal_1
    rate_diagonal_1_lo1 = (rate_diagonal_1c - (rate_diagonal_1 + rate_diagonal_1_right)
        - (rate_diagonal_1e - rate_diagonal_1_right))
    rate_diagonal_1_lo2 = (rate_diagonal_1_lo1
        - (rate_diagonal_1e_lo1 + (rate_diagonal_1d_cross2 + rate_diagonal_0g_cross2)))
    rate_diagonal_2a = rate_diagonal_1b + rate_diagonal_0b
    rate_diagonal_2a_right = rate_diagonal_2a - rate_diagonal_1b
    rate_diagonal_2a_left_rest = product_rest(rate_diagonal_1a, rate_beta_v_0, rate_diagonal_1b,
        rate_diagonal_2a - rate_diagonal_2a_right)
    rate_diagonal_2a_lo1 = (rate_diagonal_2a_left_rest
        + product_rest(rate_diagonal_0a, rate_beta_v_1, rate_diagonal_0b, rate_diagonal_2a_right))
    rate_diagonal_2b = rate_diagonal_1d + rate_diagonal_0f
    rate_diagonal_2b_right = rate_diagonal_2b - rate_diagonal_1d
    rate_diagonal_2b_left_rest = product_rest(s_3, rate_bend_w_0, rate_diagonal_1d,
        rate_diagonal_2b - rate_diagonal_2b_right)
    rate_diagonal_2b_lo1 = (rate_diagonal_2b_left_rest
        + product_rest(s_4, rate_bend_w_1, rate_diagonal_0f, rate_diagonal_2b_right))
    rate_diagonal_2 = rate_diagonal_2a - rate_diagonal_2b
    rate_diagonal_2_right = rate_diagonal_2a - rate_diagonal_2
    rate_diagonal_2_lo1 = (rate_diagonal_2a - (rate_diagonal_2 + rate_diagonal_2_right)
        - (rate_diagonal_2b - rate_diagonal_2_right))
    rate_diagonal_2_lo2 = (rate_diagonal_2_lo1
        - (rate_diagonal_2b_lo1 + (rate_diagonal_1d_cross2 + rate_diagonal_0f_cross2)))
    M_04 = rate_symmetric_0 - rate_q_2
    M_04_right = rate_symmetric_0 - M_04
    M_05 = rate_q_1 + rate_symmetric_1
    M_05_right = M_05 - rate_q_1
    M_13 = rate_q_2 + rate_symmetric_0
    M_13_right = M_13 - rate_q_2
    M_15 = rate_symmetric_2 - rate_q_0
    M_15_right = rate_symmetric_2 - M_15
    M_23 = rate_symmetric_1 - rate_q_1
    M_23_right = rate_symmetric_1 - M_23
    M_24 = rate_q_0 + rate_symmetric_2
    M_24_right = M_24 - rate_q_0
    diagonal0_rounded = (diagonal0
        + where(diagonal0c, diagonal0b_lo, 1 - (diagonal0a + diagonal0a_right)
        - (others_0 - diagonal0a_right) - others_0_lo))
    diagonal0_final = where(diagonal0_rounded == diagonal0_rounded, diagonal0_rounded, diagonal0)
    J_1_rounded = (J_1
        + (product_rest(s_4, beta_v_0, m_3, J_1 + J_1_right) - (halved_2 - J_1_right) + m_3_cross2))
    J_1_final = where(J_1_rounded == J_1_rounded, J_1_rounded, J_1)
    J_2_rounded = (J_2
        + (halved_1 - (J_2 - J_2_right) + product_rest(s_5, beta_v_0, m_4, J_2_right) + m_4_cross2))
    J_2_final = where(J_2_rounded == J_2_rounded, J_2_rounded, J_2)
    rate_diagonal_0_rounded = (rate_diagonal_0
        + (rate_diagonal_0_lo2
        + (rate_diagonal_0e_lo1 + (rate_diagonal_0b_cross2 + rate_diagonal_0d_cross2))))
    M_04_rounded = (M_04
        + (rate_symmetric_0 - (M_04 + M_04_right) - (rate_q_2 - M_04_right) + rate_symmetric_0_lo))
    M_05_rounded = (M_05
        + (rate_q_1 - (M_05 - M_05_right) + (rate_symmetric_1 - M_05_right) + rate_symmetric_1_lo))
    J_3_rounded = (J_3
        + (halved_2 - (J_3 - J_3_right) + product_rest(s_4, beta_v_0, m_3, J_3_right) + m_3_cross2))
    J_3_final = where(J_3_rounded == J_3_rounded, J_3_rounded, J_3)
    diagonal1_rounded = (diagonal1
        + where(diagonal1c, diagonal1b_lo, 1 - (diagonal1a + diagonal1a_right)
        - (others_1 - diagonal1a_right) - others_1_lo))
    diagonal1_final = where(diagonal1_rounded == diagonal1_rounded, diagonal1_rounded, diagonal1)
    J_5_rounded = (J_5
        + (product_rest(s_5, beta_v_1, m_5, J_5 + J_5_right) - (halved_0 - J_5_right) + m_5_cross2))
    J_5_final = where(J_5_rounded == J_5_rounded, J_5_rounded, J_5)
    M_13_rounded = (M_13
        + (rate_q_2 - (M_13 - M_13_right) + (rate_symmetric_0 - M_13_right) + rate_symmetric_0_lo))
    rate_diagonal_1_rounded = (rate_diagonal_1
        + (rate_diagonal_1_lo2
        + (rate_diagonal_1c_lo1 + (rate_diagonal_1b_cross2 + rate_diagonal_0d_cross2))))
    M_15_rounded = (M_15
        + (rate_symmetric_2 - (M_15 + M_15_right) - (rate_q_0 - M_15_right) + rate_symmetric_2_lo))
    J_6_rounded = (J_6
        + (product_rest(s_5, beta_v_0, m_4, J_6 + J_6_right) - (halved_1 - J_6_right) + m_4_cross2))
    J_6_final = where(J_6_rounded == J_6_rounded, J_6_rounded, J_6)
    J_7_rounded = (J_7
        + (halved_0 - (J_7 - J_7_right) + product_rest(s_5, beta_v_1, m_5, J_7_right) + m_5_cross2))
    J_7_final = where(J_7_rounded == J_7_rounded, J_7_rounded, J_7)
    diagonal2_rounded = (diagonal2
        + where(diagonal2c, diagonal2b_lo, 1 - (diagonal2a + diagonal2a_right)
        - (others_2 - diagonal2a_right) - others_2_lo))
    diagonal2_final = where(diagonal2_rounded == diagonal2_rounded, diagonal2_rounded, diagonal2)
    M_23_rounded = (M_23
        + (rate_symmetric_1 - (M_23 + M_23_right) - (rate_q_1 - M_23_right) + rate_symmetric_1_lo))
    M_24_rounded = (M_24
        + (rate_q_0 - (M_24 - M_24_right) + (rate_symmetric_2 - M_24_right) + rate_symmetric_2_lo))
    rate_diagonal_2_rounded = (rate_diagonal_2
        + (rate_diagonal_2_lo2
        + (rate_diagonal_2a_lo1 + (rate_diagonal_1b_cross2 + rate_diagonal_0b_cross2))))
    rate_diagonal_0_final = where(rate_diagonal_0_rounded == rate_diagonal_0_rounded,
        rate_diagonal_0_rounded, rate_diagonal_0)
    M_04_final = where(M_04_rounded == M_04_rounded, M_04_rounded, M_04)
    M_05_final = where(M_05_rounded == M_05_rounded, M_05_rounded, M_05)
    M_13_final = where(M_13_rounded == M_13_rounded, M_13_rounded, M_13)
    rate_diagonal_1_final = where(rate_diagonal_1_rounded == rate_diagonal_1_rounded,
        rate_diagonal_1_rounded, rate_diagonal_1)
    M_15_final = where(M_15_rounded == M_15_rounded, M_15_rounded, M_15)
    M_23_final = where(M_23_rounded == M_23_rounded, M_23_rounded, M_23)
    M_24_final = where(M_24_rounded == M_24_rounded, M_24_rounded, M_24)
    rate_diagonal_2_final = where(rate_diagonal_2_rounded == rate_diagonal_2_rounded,
        rate_diagonal_2_rounded, rate_diagonal_2)
    return (diagonal0_final, J_1_final, J_2_final, rate_diagonal_0_final, M_04_final, M_05_final,
        J_3_final, diagonal1_final, J_5_final, M_13_final, rate_diagonal_1_final, M_15_final,
        J_6_final, J_7_final, diagonal2_final, M_23_final, M_24_final, rate_diagonal_2_final, 0, 0,
        0, diagonal0_final, J_1_final, J_2_final, 0, 0, 0, J_3_final, diagonal1_final, J_5_final, 0,
        0, 0, J_6_final, J_7_final, diagonal2_final)


@kernel("(3,4),(3,4),()->(3,4)")
def SE3_interpolated(D1, D2, k):
    """Do = D1 exp(k log(D1^-1 D2)), the screw motion from D1 at k = 0 to D2 at k = 1.

    (3,4),(3,4),()->(3,4).  D1, D2, Do: displacement [R | t], R rotation, t in m; k: number.
    717 mul, 1706 add, 66 product error, 166 product rest, 29 div, 3 sqrt, 13 neg, 18 abs, 4
    copysign, 38 less, 20 equal, 110 select.  Error <= R: 1 u, t: 1 u of its largest component,
    or of D1.t or D2.t if that is larger, for R of D1 a rotation and R of D2 a rotation and 0 <=
    k <= 1; searched, not proved.  Each component is within 1 ulp as long as its condition is
    below 1e13; in single precision it is the nearest number, except near ties, as long as that
    is below 1e5; searched, not proved.  Intermediate sums may overflow where |t| of D1 or D2 is
    above 2e306, in single precision 5e36.
    """
    D1_00, D1_01, D1_02, D1_03, D1_10, D1_11, D1_12, D1_13, D1_20, D1_21, D1_22, D1_23 = D1
    D2_00, D2_01, D2_02, D2_03, D2_10, D2_11, D2_12, D2_13, D2_20, D2_21, D2_22, D2_23 = D2
    apart_0 = D2_03 - D1_03
    apart_0_right = D2_03 - apart_0
    apart_0_lo = D2_03 - (apart_0 + apart_0_right) - (D1_03 - apart_0_right)
    apart_1 = D2_13 - D1_13
    apart_1_right = D2_13 - apart_1
    apart_1_lo = D2_13 - (apart_1 + apart_1_right) - (D1_13 - apart_1_right)
    apart_2 = D2_23 - D1_23
    apart_2_right = D2_23 - apart_2
    apart_2_lo = D2_23 - (apart_2 + apart_2_right) - (D1_23 - apart_2_right)
    between_0a = D1_00 * D2_00
    between_0b = D1_10 * D2_10
    between_0c = between_0a + between_0b
    between_0c_right = between_0c - between_0a
    between_0d = D1_20 * D2_20
    between_0 = between_0c + between_0d
    between_0_right = between_0 - between_0c
    between_0c_lo = (product_rest(D1_00, D2_00, between_0a, between_0c - between_0c_right)
        + product_rest(D1_10, D2_10, between_0b, between_0c_right))
    between_0_lo = (between_0c - (between_0 - between_0_right)
        + product_rest(D1_20, D2_20, between_0d, between_0_right) + between_0c_lo)
    between_1a = D1_00 * D2_01
    between_1b = D1_10 * D2_11
    between_1c = between_1a + between_1b
    between_1c_right = between_1c - between_1a
    between_1d = D1_20 * D2_21
    between_1 = between_1c + between_1d
    between_1_right = between_1 - between_1c
    between_1c_lo = (product_rest(D1_00, D2_01, between_1a, between_1c - between_1c_right)
        + product_rest(D1_10, D2_11, between_1b, between_1c_right))
    between_1_lo = (between_1c - (between_1 - between_1_right)
        + product_rest(D1_20, D2_21, between_1d, between_1_right) + between_1c_lo)
    between_2a = D1_00 * D2_02
    between_2b = D1_10 * D2_12
    between_2c = between_2a + between_2b
    between_2c_right = between_2c - between_2a
    between_2d = D1_20 * D2_22
    between_2 = between_2c + between_2d
    between_2_right = between_2 - between_2c
    between_2c_lo = (product_rest(D1_00, D2_02, between_2a, between_2c - between_2c_right)
        + product_rest(D1_10, D2_12, between_2b, between_2c_right))
    between_2_lo = (between_2c - (between_2 - between_2_right)
        + product_rest(D1_20, D2_22, between_2d, between_2_right) + between_2c_lo)
    between_3a = D1_00 * apart_0
    between_3b = D1_10 * apart_1
    between_3c = between_3a + between_3b
    between_3c_right = between_3c - between_3a
    between_3c_lo1 = (product_rest(D1_00, apart_0, between_3a, between_3c - between_3c_right)
        + product_rest(D1_10, apart_1, between_3b, between_3c_right))
    between_3d = D1_20 * apart_2
    between_3 = between_3c + between_3d
    between_3_right = between_3 - between_3c
    between_3_lo2 = (between_3c - (between_3 - between_3_right)
        + product_rest(D1_20, apart_2, between_3d, between_3_right) + D1_20 * apart_2_lo)
    between_3_lo = between_3_lo2 + (between_3c_lo1 + (D1_00 * apart_0_lo + D1_10 * apart_1_lo))
    between_4a = D1_01 * D2_00
    between_4b = D1_11 * D2_10
    between_4c = between_4a + between_4b
    between_4c_right = between_4c - between_4a
    between_4d = D1_21 * D2_20
    between_4 = between_4c + between_4d
    between_4_right = between_4 - between_4c
    between_4c_lo = (product_rest(D1_01, D2_00, between_4a, between_4c - between_4c_right)
        + product_rest(D1_11, D2_10, between_4b, between_4c_right))
    between_4_lo = (between_4c - (between_4 - between_4_right)
        + product_rest(D1_21, D2_20, between_4d, between_4_right) + between_4c_lo)
    between_5a = D1_01 * D2_01
    between_5b = D1_11 * D2_11
    between_5c = between_5a + between_5b
    between_5c_right = between_5c - between_5a
    between_5d = D1_21 * D2_21
    between_5 = between_5c + between_5d
    between_5_right = between_5 - between_5c
    between_5c_lo = (product_rest(D1_01, D2_01, between_5a, between_5c - between_5c_right)
        + product_rest(D1_11, D2_11, between_5b, between_5c_right))
    between_5_lo = (between_5c - (between_5 - between_5_right)
        + product_rest(D1_21, D2_21, between_5d, between_5_right) + between_5c_lo)
    between_6a = D1_01 * D2_02
    between_6b = D1_11 * D2_12
    between_6c = between_6a + between_6b
    between_6c_right = between_6c - between_6a
    between_6d = D1_21 * D2_22
    between_6 = between_6c + between_6d
    between_6_right = between_6 - between_6c
    between_6c_lo = (product_rest(D1_01, D2_02, between_6a, between_6c - between_6c_right)
        + product_rest(D1_11, D2_12, between_6b, between_6c_right))
    between_6_lo = (between_6c - (between_6 - between_6_right)
        + product_rest(D1_21, D2_22, between_6d, between_6_right) + between_6c_lo)
    between_7a = D1_01 * apart_0
    between_7b = D1_11 * apart_1
    between_7c = between_7a + between_7b
    between_7c_right = between_7c - between_7a
    between_7c_lo1 = (product_rest(D1_01, apart_0, between_7a, between_7c - between_7c_right)
        + product_rest(D1_11, apart_1, between_7b, between_7c_right))
    between_7d = D1_21 * apart_2
    between_7 = between_7c + between_7d
    between_7_right = between_7 - between_7c
    between_7_lo2 = (between_7c - (between_7 - between_7_right)
        + product_rest(D1_21, apart_2, between_7d, between_7_right) + D1_21 * apart_2_lo)
    between_7_lo = between_7_lo2 + (between_7c_lo1 + (D1_01 * apart_0_lo + D1_11 * apart_1_lo))
    between_8a = D1_02 * D2_00
    between_8b = D1_12 * D2_10
    between_8c = between_8a + between_8b
    between_8c_right = between_8c - between_8a
    between_8d = D1_22 * D2_20
    between_8 = between_8c + between_8d
    between_8_right = between_8 - between_8c
    between_8c_lo = (product_rest(D1_02, D2_00, between_8a, between_8c - between_8c_right)
        + product_rest(D1_12, D2_10, between_8b, between_8c_right))
    between_8_lo = (between_8c - (between_8 - between_8_right)
        + product_rest(D1_22, D2_20, between_8d, between_8_right) + between_8c_lo)
    between_9a = D1_02 * D2_01
    between_9b = D1_12 * D2_11
    between_9c = between_9a + between_9b
    between_9c_right = between_9c - between_9a
    between_9d = D1_22 * D2_21
    between_9 = between_9c + between_9d
    between_9_right = between_9 - between_9c
    between_9c_lo = (product_rest(D1_02, D2_01, between_9a, between_9c - between_9c_right)
        + product_rest(D1_12, D2_11, between_9b, between_9c_right))
    between_9_lo = (between_9c - (between_9 - between_9_right)
        + product_rest(D1_22, D2_21, between_9d, between_9_right) + between_9c_lo)
    between_10a = D1_02 * D2_02
    between_10b = D1_12 * D2_12
    between_10c = between_10a + between_10b
    between_10c_right = between_10c - between_10a
    between_10d = D1_22 * D2_22
    between_10 = between_10c + between_10d
    between_10_right = between_10 - between_10c
    between_10c_lo = (product_rest(D1_02, D2_02, between_10a, between_10c - between_10c_right)
        + product_rest(D1_12, D2_12, between_10b, between_10c_right))
    between_10_lo = (between_10c - (between_10 - between_10_right)
        + product_rest(D1_22, D2_22, between_10d, between_10_right) + between_10c_lo)
    between_11a = D1_02 * apart_0
    between_11b = D1_12 * apart_1
    between_11c = between_11a + between_11b
    between_11c_right = between_11c - between_11a
    between_11c_left_rest = product_rest(D1_02, apart_0, between_11a,
        between_11c - between_11c_right)
    between_11d = D1_22 * apart_2
    between_11 = between_11c + between_11d
    between_11_right = between_11 - between_11c
    between_11_lo2 = (between_11c - (between_11 - between_11_right)
        + product_rest(D1_22, apart_2, between_11d, between_11_right) + D1_22 * apart_2_lo)
    between_11c_lo = (between_11c_left_rest
        + product_rest(D1_12, apart_1, between_11b, between_11c_right)
        + (D1_02 * apart_0_lo + D1_12 * apart_1_lo))
    between_11_lo = between_11_lo2 + between_11c_lo
    log_p_0 = between_9 - between_6
    log_p_0_right = between_9 - log_p_0
    log_p_0_lo = (between_9 - (log_p_0 + log_p_0_right) - (between_6 - log_p_0_right)
        - between_6_lo + between_9_lo)
    log_p_1 = between_2 - between_8
    log_p_1_right = between_2 - log_p_1
    log_p_1_lo = (between_2 - (log_p_1 + log_p_1_right) - (between_8 - log_p_1_right)
        - between_8_lo + between_2_lo)
    log_p_2 = between_4 - between_1
    log_p_2_right = between_4 - log_p_2
    log_p_2_lo = (between_4 - (log_p_2 + log_p_2_right) - (between_1 - log_p_2_right)
        - between_1_lo + between_4_lo)
    log_s_0 = between_6 + between_9
    log_s_0_right = log_s_0 - between_6
    log_s_0_lo = (between_6 - (log_s_0 - log_s_0_right) + (between_9 - log_s_0_right)
        + between_9_lo + between_6_lo)
    log_s_1 = between_2 + between_8
    log_s_1_right = log_s_1 - between_2
    log_s_1_lo = (between_2 - (log_s_1 - log_s_1_right) + (between_8 - log_s_1_right)
        + between_8_lo + between_2_lo)
    log_s_2 = between_1 + between_4
    log_s_2_right = log_s_2 - between_1
    log_s_2_lo = (between_1 - (log_s_2 - log_s_2_right) + (between_4 - log_s_2_right)
        + between_4_lo + between_1_lo)
    log_first_0 = between_0 + 1
    log_first_0_right = log_first_0 - between_0
    log_first_0_lo = (between_0 - (log_first_0 - log_first_0_right) + (1 - log_first_0_right)
        + between_0_lo)
    log_first_1 = 1 - between_0
    log_first_1_right = 1 - log_first_1
    log_first_1_lo = (1 - (log_first_1 + log_first_1_right) - (between_0 - log_first_1_right)
        - between_0_lo)
    log_others_0 = between_5 + between_10
    log_others_0_right = log_others_0 - between_5
    log_others_0_lo = (between_5 - (log_others_0 - log_others_0_right)
        + (between_10 - log_others_0_right) + between_10_lo + between_5_lo)
    log_others_1 = between_5 - between_10
    log_others_1_right = between_5 - log_others_1
    log_others_1_lo = (between_5 - (log_others_1 + log_others_1_right)
        - (between_10 - log_others_1_right) - between_10_lo + between_5_lo)
    log_d_0 = log_first_0 + log_others_0
    log_d_0_right = log_d_0 - log_first_0
    log_d_1 = log_first_0 - log_others_0
    log_d_1_right = log_first_0 - log_d_1
    log_d_2 = log_first_1 + log_others_1
    log_d_2_right = log_d_2 - log_first_1
    log_d_3 = log_first_1 - log_others_1
    log_d_3_right = log_first_1 - log_d_3
    between_5_sum = between_5 + between_5_lo
    between_5_sum_right = between_5_sum - between_5
    between_0_sum = between_0 + between_0_lo
    log_low_0a = between_5_sum < between_0_sum
    log_low_0 = where(log_low_0a, log_d_1, log_s_2)
    log_d_1_lo = (log_first_0 - (log_d_1 + log_d_1_right) - (log_others_0 - log_d_1_right)
        - log_others_0_lo + log_first_0_lo)
    log_low_1 = where(log_low_0a, log_s_2, log_d_2)
    log_d_2_lo = (log_first_1 - (log_d_2 - log_d_2_right) + (log_others_1 - log_d_2_right)
        + log_others_1_lo + log_first_1_lo)
    log_low_2 = where(log_low_0a, log_s_1, log_s_0)
    log_low_3 = where(log_low_0a, log_p_0, log_p_1)
    log_high_0b = (between_0_sum < -between_5_sum +
        -(between_5 - (between_5_sum - between_5_sum_right) + (between_5_lo - between_5_sum_right)))
    log_high_0 = where(log_high_0b, log_s_1, log_p_0)
    log_high_1 = where(log_high_0b, log_s_0, log_p_1)
    log_high_2 = where(log_high_0b, log_d_3, log_p_2)
    log_d_3_lo = (log_first_1 - (log_d_3 + log_d_3_right) - (log_others_1 - log_d_3_right)
        - log_others_1_lo + log_first_1_lo)
    log_high_3 = where(log_high_0b, log_p_2, log_d_0)
    log_d_0_lo = (log_first_0 - (log_d_0 - log_d_0_right) + (log_others_0 - log_d_0_right)
        + log_others_0_lo + log_first_0_lo)
    log_column_0a = between_10 + between_10_lo < 0
    log_column_0 = where(log_column_0a, log_low_0, log_high_0)
    log_column_0_lo = where(log_column_0a, where(log_low_0a, log_d_1_lo, log_s_2_lo),
        where(log_high_0b, log_s_1_lo, log_p_0_lo))
    log_column_1 = where(log_column_0a, log_low_1, log_high_1)
    log_column_1_lo = where(log_column_0a, where(log_low_0a, log_s_2_lo, log_d_2_lo),
        where(log_high_0b, log_s_0_lo, log_p_1_lo))
    log_column_2 = where(log_column_0a, log_low_2, log_high_2)
    log_column_2_lo = where(log_column_0a, where(log_low_0a, log_s_1_lo, log_s_0_lo),
        where(log_high_0b, log_d_3_lo, log_p_2_lo))
    log_column_3 = where(log_column_0a, log_low_3, log_high_3)
    log_column_3_lo = where(log_column_0a, where(log_low_0a, log_p_0_lo, log_p_1_lo),
        where(log_high_0b, log_p_2_lo, log_d_0_lo))
    log_column_3_sum = log_column_3 + log_column_3_lo
    log_column_3_sum_right = log_column_3_sum - log_column_3
    log_column_3_sum_lo = (log_column_3 - (log_column_3_sum - log_column_3_sum_right)
        + (log_column_3_lo - log_column_3_sum_right))
    log_upper_0b = log_column_3_sum < 0
    log_upper_0 = where(log_upper_0b, -log_column_0, log_column_0)
    log_upper_0_lo = where(log_upper_0b, -log_column_0_lo, log_column_0_lo)
    log_upper_1 = where(log_upper_0b, -log_column_1, log_column_1)
    log_upper_1_lo = where(log_upper_0b, -log_column_1_lo, log_column_1_lo)
    log_upper_2 = where(log_upper_0b, -log_column_2, log_column_2)
    log_upper_2_lo = where(log_upper_0b, -log_column_2_lo, log_column_2_lo)
    log_upper_3 = absolute(log_column_3_sum)
    log_upper_3_lo = where(log_column_3_sum < 0, -log_column_3_sum_lo, log_column_3_sum_lo)
    log_upper_0_sum = log_upper_0 + log_upper_0_lo
    log_upper_0_sum_right = log_upper_0_sum - log_upper_0
    log_upper_0_sum_lo = (log_upper_0 - (log_upper_0_sum - log_upper_0_sum_right)
        + (log_upper_0_lo - log_upper_0_sum_right))
    log_v_s_size_0 = absolute(log_upper_0_sum)
    log_v_s_size_0_lo = where(log_upper_0_sum < 0, -log_upper_0_sum_lo, log_upper_0_sum_lo)
    log_upper_1_sum = log_upper_1 + log_upper_1_lo
    log_upper_1_sum_right = log_upper_1_sum - log_upper_1
    log_upper_1_sum_lo = (log_upper_1 - (log_upper_1_sum - log_upper_1_sum_right)
        + (log_upper_1_lo - log_upper_1_sum_right))
    log_v_s_size_1 = absolute(log_upper_1_sum)
    log_v_s_size_1_lo = where(log_upper_1_sum < 0, -log_upper_1_sum_lo, log_upper_1_sum_lo)
    log_upper_2_sum = log_upper_2 + log_upper_2_lo
    log_upper_2_sum_right = log_upper_2_sum - log_upper_2
    log_upper_2_sum_lo = (log_upper_2 - (log_upper_2_sum - log_upper_2_sum_right)
        + (log_upper_2_lo - log_upper_2_sum_right))
    log_v_s_size_2 = absolute(log_upper_2_sum)
    log_v_s_size_2_lo = where(log_upper_2_sum < 0, -log_upper_2_sum_lo, log_upper_2_sum_lo)
    log_v_s_size_0_sum = log_v_s_size_0 + log_v_s_size_0_lo
    log_v_s_size_0_sum_right = log_v_s_size_0_sum - log_v_s_size_0
    log_v_s_size_1_sum = log_v_s_size_1 + log_v_s_size_1_lo
    log_v_s_size_1_sum_right = log_v_s_size_1_sum - log_v_s_size_1
    log_v_s_largest1a = log_v_s_size_0_sum < log_v_s_size_1_sum
    log_v_s_largest1 = where(log_v_s_largest1a, log_v_s_size_1_sum, log_v_s_size_0_sum)
    log_v_s_size_1_sum_lo = (log_v_s_size_1 - (log_v_s_size_1_sum - log_v_s_size_1_sum_right)
        + (log_v_s_size_1_lo - log_v_s_size_1_sum_right))
    log_v_s_size_0_sum_lo = (log_v_s_size_0 - (log_v_s_size_0_sum - log_v_s_size_0_sum_right)
        + (log_v_s_size_0_lo - log_v_s_size_0_sum_right))
    log_v_s_largest1_lo = where(log_v_s_largest1a, log_v_s_size_1_sum_lo, log_v_s_size_0_sum_lo)
    log_v_s_largest1_sum = log_v_s_largest1 + log_v_s_largest1_lo
    log_v_s_largest1_sum_right = log_v_s_largest1_sum - log_v_s_largest1
    log_v_s_size_2_sum = log_v_s_size_2 + log_v_s_size_2_lo
    log_v_s_size_2_sum_right = log_v_s_size_2_sum - log_v_s_size_2
    log_v_s_largest2a = log_v_s_largest1_sum < log_v_s_size_2_sum
    log_v_s_largest2 = where(log_v_s_largest2a, log_v_s_size_2_sum, log_v_s_largest1_sum)
    log_v_s_largest1_sum_lo = (log_v_s_largest1
        - (log_v_s_largest1_sum - log_v_s_largest1_sum_right)
        + (log_v_s_largest1_lo - log_v_s_largest1_sum_right))
    log_v_s_size_2_sum_lo = (log_v_s_size_2 - (log_v_s_size_2_sum - log_v_s_size_2_sum_right)
        + (log_v_s_size_2_lo - log_v_s_size_2_sum_right))
    log_v_s_largest2_sum = (log_v_s_largest2
        + where(log_v_s_largest2a, log_v_s_size_2_sum_lo, log_v_s_largest1_sum_lo))
    log_v_s_b = where(6.703903964971299e+153 < log_v_s_largest2_sum, real(3.7291703656001034e-155),
        real(1))
    log_v_s_d = where(log_v_s_largest2_sum < 256, 1.3093562431584567e+151, log_v_s_b)
    log_v_s = where(log_v_s_largest2_sum < 1.955159272639747e-149, 1.0715086071862673e+301,
        log_v_s_d)
    log_v_y_0 = log_upper_0_sum * log_v_s
    log_v_y_0_inverse = 1 / log_v_s
    log_v_y_0_lo = (log_upper_0_sum - log_v_y_0 * log_v_y_0_inverse + log_upper_0_sum_lo) * log_v_s
    log_v_y_1 = log_upper_1_sum * log_v_s
    log_v_y_1_lo = (log_upper_1_sum - log_v_y_1 * log_v_y_0_inverse + log_upper_1_sum_lo) * log_v_s
    log_v_y_2 = log_upper_2_sum * log_v_s
    log_v_y_2_lo = (log_upper_2_sum - log_v_y_2 * log_v_y_0_inverse + log_upper_2_sum_lo) * log_v_s
    log_v_n_a = log_v_y_0 * log_v_y_0
    log_v_n_b = log_v_y_1 * log_v_y_1
    log_v_n_c = log_v_n_a + log_v_n_b
    log_v_n_c_right = log_v_n_c - log_v_n_a
    log_v_n_c_left_rest = product_rest(log_v_y_0, log_v_y_0, log_v_n_a, log_v_n_c - log_v_n_c_right)
    log_v_n_c_cross = (log_v_y_0_lo * log_v_y_0 + log_v_y_0 * log_v_y_0_lo
        + (log_v_y_1_lo * log_v_y_1 + log_v_y_1 * log_v_y_1_lo))
    log_v_n_d = log_v_y_2 * log_v_y_2
    log_v_n_e = log_v_n_c + log_v_n_d
    log_v_n_e_right = log_v_n_e - log_v_n_c
    log_v_n_e_lo1 = (log_v_n_c - (log_v_n_e - log_v_n_e_right)
        + product_rest(log_v_y_2, log_v_y_2, log_v_n_d, log_v_n_e_right))
    log_v_n_c_lo = (log_v_n_c_left_rest
        + product_rest(log_v_y_1, log_v_y_1, log_v_n_b, log_v_n_c_right) + log_v_n_c_cross)
    log_v_n_e_lo = (log_v_n_e_lo1 + (log_v_y_2_lo * log_v_y_2 + log_v_y_2 * log_v_y_2_lo)
        + log_v_n_c_lo)
    log_v_n_e_sum = log_v_n_e + log_v_n_e_lo
    log_v_n_e_sum_right = log_v_n_e_sum - log_v_n_e
    log_v_n = sqrt(log_v_n_e_sum)
    log_v_n_product = log_v_n * log_v_n
    log_v_n_e_sum_lo = (log_v_n_e - (log_v_n_e_sum - log_v_n_e_sum_right)
        + (log_v_n_e_lo - log_v_n_e_sum_right))
    log_v_n_residual = (log_v_n_e_sum - log_v_n_product
        - product_error(log_v_n, log_v_n, log_v_n_product) + log_v_n_e_sum_lo)
    log_v_n_lo = log_v_n_residual / where(log_v_n == 0, 1, log_v_n + log_v_n)
    log_v_r_d = where(1 < log_v_s, 7.637340908749012e-152, where(log_v_s < 1,
        real(2.6815615859885194e+154), real(1)))
    log_v_r = where(1.3093562431584567e+151 < log_v_s, 9.332636185032189e-302, log_v_r_d)
    log_v_n_sum = log_v_n + log_v_n_lo
    log_v_n_sum_right = log_v_n_sum - log_v_n
    log_n = log_v_n_sum * log_v_r
    log_n_lo = ((log_v_n_sum - log_n * (1 / log_v_r)
        + (log_v_n - (log_v_n_sum - log_v_n_sum_right) + (log_v_n_lo - log_v_n_sum_right)))
        * log_v_r)
    log_n_sum = log_n + log_n_lo
    log_n_sum_right = log_n_sum - log_n
    log_n_sum_lo = log_n - (log_n_sum - log_n_sum_right) + (log_n_lo - log_n_sum_right)
    log_upper_3_sum = log_upper_3 + log_upper_3_lo
    log_upper_3_sum_right = log_upper_3_sum - log_upper_3
    log_upper_3_sum_lo = (log_upper_3 - (log_upper_3_sum - log_upper_3_sum_right)
        + (log_upper_3_lo - log_upper_3_sum_right))
    log_half = elementary.atan2(log_n_sum, log_upper_3_sum)
    log_half_size0 = absolute(log_n_sum)
    log_half_size1 = absolute(log_upper_3_sum)
    log_half_most = where(log_half_size0 < log_half_size1, log_half_size1, log_half_size0)
    log_half_zero = log_half_most == 0
    log_half_divisor = where(log_half_zero, 1, log_half_most)
    log_half_part0 = log_n_sum / log_half_divisor
    log_half_part1 = log_upper_3_sum / log_half_divisor
    log_half_safe = where(log_half_zero, 1,
        log_half_divisor * (log_half_part1 * log_half_part1 + log_half_part0 * log_half_part0))
    log_half_more = ((log_half_part1 * log_n_sum_lo - log_half_part0 * log_upper_3_sum_lo)
        / log_half_safe)
    log_divisor_a = log_n_sum == 0
    log_divisor = where(log_divisor_a, 1, log_n_sum)
    log_divisor_lo = where(log_divisor_a, 0, log_n_sum_lo)
    log_theta = 2 * log_half
    log_theta_cross2 = (2
        * (elementary.atan2_error(log_n_sum, log_upper_3_sum, log_half) + log_half_more))
    log_theta_sum = log_theta + log_theta_cross2
    log_theta_sum_right = log_theta_sum - log_theta
    log_theta_sum_lo = (log_theta - (log_theta_sum - log_theta_sum_right)
        + (log_theta_cross2 - log_theta_sum_right))
    log_divisor_sum = log_divisor + log_divisor_lo
    log_divisor_sum_right = log_divisor_sum - log_divisor
    log_k = log_theta_sum / log_divisor_sum
    log_k_product = log_k * log_divisor_sum
    log_k_cross = (log_k
        * (log_divisor - (log_divisor_sum - log_divisor_sum_right)
        + (log_divisor_lo - log_divisor_sum_right)))
    log_k_lo = ((log_theta_sum - log_k_product
        - product_error(log_k, log_divisor_sum, log_k_product) + log_theta_sum_lo - log_k_cross)
        / log_divisor_sum)
    log_vector_0 = log_upper_0_sum * log_k
    log_vector_1 = log_upper_1_sum * log_k
    log_vector_2 = log_upper_2_sum * log_k
    log_half_angle = 0.5 * log_theta_sum
    log_half_angle_cross2 = 0.5 * log_theta_sum_lo
    log_length_a = log_n_sum * log_n_sum
    log_length_b = log_upper_3_sum * log_upper_3_sum
    log_length_c = log_length_a + log_length_b
    log_length_c_right = log_length_c - log_length_a
    log_length_b_cross = log_upper_3_sum_lo * log_upper_3_sum + log_upper_3_sum * log_upper_3_sum_lo
    log_length_c_left_rest = product_rest(log_n_sum, log_n_sum, log_length_a,
        log_length_c - log_length_c_right)
    log_length_c_lo1 = (log_length_c_left_rest
        + product_rest(log_upper_3_sum, log_upper_3_sum, log_length_b, log_length_c_right))
    log_length_c_lo = (log_length_c_lo1
        + (log_n_sum_lo * log_n_sum + log_n_sum * log_n_sum_lo + log_length_b_cross))
    log_length_c_sum = log_length_c + log_length_c_lo
    log_length_c_sum_right = log_length_c_sum - log_length_c
    log_length = sqrt(log_length_c_sum)
    log_length_product = log_length * log_length
    log_length_c_sum_lo = (log_length_c - (log_length_c_sum - log_length_c_sum_right)
        + (log_length_c_lo - log_length_c_sum_right))
    log_length_residual = (log_length_c_sum - log_length_product
        - product_error(log_length, log_length, log_length_product) + log_length_c_sum_lo)
    log_length_lo = log_length_residual / where(log_length == 0, 1, log_length + log_length)
    log_length_sum = log_length + log_length_lo
    log_length_sum_right = log_length_sum - log_length
    log_length_sum_lo = (log_length - (log_length_sum - log_length_sum_right)
        + (log_length_lo - log_length_sum_right))
    log_sine = log_n_sum / log_length_sum
    log_sine_product = log_sine * log_length_sum
    log_sine_numerator = (log_n_sum - log_sine_product
        - product_error(log_sine, log_length_sum, log_sine_product) + log_n_sum_lo)
    log_sine_lo = (log_sine_numerator - log_sine * log_length_sum_lo) / log_length_sum
    log_c = log_upper_3_sum / log_length_sum
    log_c_product = log_c * log_length_sum
    log_c_numerator = (log_upper_3_sum - log_c_product
        - product_error(log_c, log_length_sum, log_c_product) + log_upper_3_sum_lo)
    log_c_lo = (log_c_numerator - log_c * log_length_sum_lo) / log_length_sum
    log_y = log_half_angle * log_half_angle
    log_half_angle_sum = log_half_angle + log_half_angle_cross2
    log_half_angle_sum_right = log_half_angle_sum - log_half_angle
    log_sinc_divisor_a = log_half_angle_sum < 1.4901161193847656e-08
    log_sinc_divisor = where(log_sinc_divisor_a, 1.4901161193847656e-08, log_half_angle_sum)
    log_half_angle_sum_lo = (log_half_angle - (log_half_angle_sum - log_half_angle_sum_right)
        + (log_half_angle_cross2 - log_half_angle_sum_right))
    log_sinc_divisor_lo = where(log_sinc_divisor_a, 0, log_half_angle_sum_lo)
    log_sine_sum = log_sine + log_sine_lo
    log_sine_sum_right = log_sine_sum - log_sine
    log_sinc_divisor_sum = log_sinc_divisor + log_sinc_divisor_lo
    log_sinc_divisor_sum_right = log_sinc_divisor_sum - log_sinc_divisor
    log_sinc_quotient = log_sine_sum / log_sinc_divisor_sum
    log_sinc_quotient_product = log_sinc_quotient * log_sinc_divisor_sum
    log_sinc_quotient_exact = (log_sine_sum - log_sinc_quotient_product
        - product_error(log_sinc_quotient, log_sinc_divisor_sum, log_sinc_quotient_product))
    log_sinc_divisor_sum_lo = (log_sinc_divisor
        - (log_sinc_divisor_sum - log_sinc_divisor_sum_right)
        + (log_sinc_divisor_lo - log_sinc_divisor_sum_right))
    log_sinc_quotient_numerator = (log_sinc_quotient_exact
        + (log_sine - (log_sine_sum - log_sine_sum_right) + (log_sine_lo - log_sine_sum_right)))
    log_y_lo = (product_error(log_half_angle, log_half_angle, log_y)
        + (log_half_angle_cross2 * log_half_angle + log_half_angle * log_half_angle_cross2))
    log_sinc_a = 0.16666666666666666 * log_y
    log_sinc_b = 1 - log_sinc_a
    log_sinc_b_right = 1 - log_sinc_b
    log_sinc_b_lo1 = (1 - (log_sinc_b + log_sinc_b_right)
        - product_rest(0.16666666666666666, log_y, log_sinc_a, log_sinc_b_right))
    log_sinc = where(log_sinc_divisor_a, log_sinc_b, log_sinc_quotient)
    log_sinc_quotient_lo = ((log_sinc_quotient_numerator - log_sinc_quotient
        * log_sinc_divisor_sum_lo) / log_sinc_divisor_sum)
    log_sinc_lo = where(log_sinc_divisor_a,
        log_sinc_b_lo1 - (9.25185853854297e-18 * log_y + 0.16666666666666666 * log_y_lo),
        log_sinc_quotient_lo)
    log_series_phi_a = 5.107725174524775e-32 * log_y
    log_series_phi_b = 4.116826490666969e-29 - log_series_phi_a
    log_series_phi_b_right = 4.116826490666969e-29 - log_series_phi_b
    log_series_phi_b_right_rest = product_rest(5.107725174524775e-32, log_y, log_series_phi_a,
        log_series_phi_b_right)
    log_series_phi_b_lo1 = (4.116826490666969e-29 - (log_series_phi_b + log_series_phi_b_right)
        - log_series_phi_b_right_rest)
    log_series_phi_c = log_y * log_series_phi_b
    log_series_phi_b_lo = (log_series_phi_b_lo1
        - (4.7410392187559056e-48 * log_y + 5.107725174524775e-32 * log_y_lo) +
        -1.8714974010023092e-45)
    log_series_phi_d = log_series_phi_c - 2.86531123750421e-26
    log_series_phi_d_right = log_series_phi_c - log_series_phi_d
    log_series_phi_d_left_rest = product_rest(log_y, log_series_phi_b, log_series_phi_c,
        log_series_phi_d + log_series_phi_d_right)
    log_series_phi_d_lo2 = (log_series_phi_d_left_rest
        - (2.86531123750421e-26 - log_series_phi_d_right) - 2.3296034284323186e-42)
    log_series_phi_e = log_y * log_series_phi_d
    log_series_phi_f = log_series_phi_e + 1.701994875077501e-23
    log_series_phi_f_right = log_series_phi_f - log_series_phi_e
    log_series_phi_f_left_rest = product_rest(log_y, log_series_phi_d, log_series_phi_e,
        log_series_phi_f - log_series_phi_f_right)
    log_series_phi_e_cross = (log_y_lo * log_series_phi_d + log_y
        * (log_series_phi_d_lo2 + (log_y_lo * log_series_phi_b + log_y * log_series_phi_b_lo)))
    log_series_phi_g = log_y * log_series_phi_f
    log_series_phi_f_lo = (log_series_phi_f_left_rest
        + (1.701994875077501e-23 - log_series_phi_f_right) + 3.161967936521494e-40
        + log_series_phi_e_cross)
    log_series_phi_h = log_series_phi_g - 8.509974375387505e-21
    log_series_phi_h_right = log_series_phi_g - log_series_phi_h
    log_series_phi_h_left_rest = product_rest(log_y, log_series_phi_f, log_series_phi_g,
        log_series_phi_h + log_series_phi_h_right)
    log_series_phi_h_lo2 = (log_series_phi_h_left_rest
        - (8.509974375387505e-21 - log_series_phi_h_right) - 3.2266760594119493e-37)
    log_series_phi_i = log_y * log_series_phi_h
    log_series_phi_j = log_series_phi_i + 3.523129391410427e-18
    log_series_phi_j_right = log_series_phi_j - log_series_phi_i
    log_series_phi_j_left_rest = product_rest(log_y, log_series_phi_h, log_series_phi_i,
        log_series_phi_j - log_series_phi_j_right)
    log_series_phi_i_cross = (log_y_lo * log_series_phi_h + log_y
        * (log_series_phi_h_lo2 + (log_y_lo * log_series_phi_f + log_y * log_series_phi_f_lo)))
    log_series_phi_k = log_y * log_series_phi_j
    log_series_phi_j_lo = (log_series_phi_j_left_rest
        + (3.523129391410427e-18 - log_series_phi_j_right) + -1.2521244741738012e-34
        + log_series_phi_i_cross)
    log_series_phi_l = log_series_phi_k - 1.1837714755139035e-15
    log_series_phi_l_right = log_series_phi_k - log_series_phi_l
    log_series_phi_l_left_rest = product_rest(log_y, log_series_phi_j, log_series_phi_k,
        log_series_phi_l + log_series_phi_l_right)
    log_series_phi_l_lo2 = (log_series_phi_l_left_rest
        - (1.1837714755139035e-15 - log_series_phi_l_right) - 7.23242424407352e-33)
    log_series_phi_m = log_y * log_series_phi_l
    log_series_phi_n = log_series_phi_m + 3.148832124866983e-13
    log_series_phi_n_right = log_series_phi_n - log_series_phi_m
    log_series_phi_n_left_rest = product_rest(log_y, log_series_phi_l, log_series_phi_m,
        log_series_phi_n - log_series_phi_n_right)
    log_series_phi_m_cross = (log_y_lo * log_series_phi_l + log_y
        * (log_series_phi_l_lo2 + (log_y_lo * log_series_phi_j + log_y * log_series_phi_j_lo)))
    log_series_phi_o = log_y * log_series_phi_n
    log_series_phi_n_lo = (log_series_phi_n_left_rest
        + (3.148832124866983e-13 - log_series_phi_n_right) + 5.8681293750286156e-30
        + log_series_phi_m_cross)
    log_series_phi_p = log_series_phi_o - 6.423617534728645e-11
    log_series_phi_p_right = log_series_phi_o - log_series_phi_p
    log_series_phi_p_left_rest = product_rest(log_y, log_series_phi_n, log_series_phi_o,
        log_series_phi_p + log_series_phi_p_right)
    log_series_phi_p_lo2 = (log_series_phi_p_left_rest
        - (6.423617534728645e-11 - log_series_phi_p_right) - 5.034117835500839e-27)
    log_series_phi_q = log_y * log_series_phi_p
    log_series_phi_r = log_series_phi_q + 9.635426302092969e-09
    log_series_phi_r_right = log_series_phi_r - log_series_phi_q
    log_series_phi_r_left_rest = product_rest(log_y, log_series_phi_p, log_series_phi_q,
        log_series_phi_r - log_series_phi_r_right)
    log_series_phi_q_cross = (log_y_lo * log_series_phi_p + log_y
        * (log_series_phi_p_lo2 + (log_y_lo * log_series_phi_n + log_y * log_series_phi_n_lo)))
    log_series_phi_s = log_y * log_series_phi_r
    log_series_phi_r_lo = (log_series_phi_r_left_rest
        + (9.635426302092969e-09 - log_series_phi_r_right) + -1.7546051379703029e-25
        + log_series_phi_q_cross)
    log_series_phi_t = log_series_phi_s - 1.0020843354176687e-06
    log_series_phi_t_right = log_series_phi_s - log_series_phi_t
    log_series_phi_t_left_rest = product_rest(log_y, log_series_phi_r, log_series_phi_s,
        log_series_phi_t + log_series_phi_t_right)
    log_series_phi_t_lo2 = (log_series_phi_t_left_rest
        - (1.0020843354176687e-06 - log_series_phi_t_right) - 4.7926555569351065e-23)
    log_series_phi_u = log_y * log_series_phi_t
    log_series_phi_v = log_series_phi_u + 6.613756613756614e-05
    log_series_phi_v_right = log_series_phi_v - log_series_phi_u
    log_series_phi_v_left_rest = product_rest(log_y, log_series_phi_t, log_series_phi_u,
        log_series_phi_v - log_series_phi_v_right)
    log_series_phi_u_cross = (log_y_lo * log_series_phi_t + log_y
        * (log_series_phi_t_lo2 + (log_y_lo * log_series_phi_r + log_y * log_series_phi_r_lo)))
    log_series_phi_w = log_y * log_series_phi_v
    log_series_phi_v_lo = (log_series_phi_v_left_rest
        + (6.613756613756614e-05 - log_series_phi_v_right) + -4.460143857711533e-21
        + log_series_phi_u_cross)
    log_series_phi_x = log_series_phi_w - 0.002380952380952381
    log_series_phi_x_right = log_series_phi_w - log_series_phi_x
    log_series_phi_x_left_rest = product_rest(log_y, log_series_phi_v, log_series_phi_w,
        log_series_phi_x + log_series_phi_x_right)
    log_series_phi_x_lo2 = (log_series_phi_x_left_rest
        - (0.002380952380952381 - log_series_phi_x_right) - -2.147752875018904e-19)
    log_series_phi_y = log_y * log_series_phi_x
    log_series_phi = log_series_phi_y + 0.03333333333333333
    log_series_phi_right = log_series_phi - log_series_phi_y
    log_series_phi_left_rest = product_rest(log_y, log_series_phi_x, log_series_phi_y,
        log_series_phi - log_series_phi_right)
    log_series_phi_y_cross = (log_y_lo * log_series_phi_x + log_y
        * (log_series_phi_x_lo2 + (log_y_lo * log_series_phi_v + log_y * log_series_phi_v_lo)))
    log_f_more_a = 2 * log_y
    log_f_more = log_f_more_a * log_series_phi
    log_series_phi_lo = (log_series_phi_left_rest + (0.03333333333333333 - log_series_phi_right)
        + 4.625929269271486e-19 + log_series_phi_y_cross)
    log_near_f_a = 0.3333333333333333 * log_sinc
    log_near_f_b = 0.3333333333333333 * log_f_more
    log_f_more_lo = (product_error(log_f_more_a, log_series_phi, log_f_more)
        + (2 * log_y_lo * log_series_phi + log_f_more_a * log_series_phi_lo))
    log_near_f = log_near_f_a + log_near_f_b
    log_near_f_right = log_near_f - log_near_f_a
    log_near_f_b_cross = 1.850371707708594e-17 * log_f_more + 0.3333333333333333 * log_f_more_lo
    log_near_f_left_rest = product_rest(0.3333333333333333, log_sinc, log_near_f_a,
        log_near_f - log_near_f_right)
    log_near_f_lo1 = (log_near_f_left_rest
        + product_rest(0.3333333333333333, log_f_more, log_near_f_b, log_near_f_right))
    log_f_rest = log_sinc - log_c
    log_f_rest_right = log_sinc - log_f_rest
    log_f_rest_lo = (log_sinc - (log_f_rest + log_f_rest_right) - (log_c - log_f_rest_right)
        - log_c_lo + log_sinc_lo)
    log_x = 4 * log_y
    log_far_y_a = log_x + 4 * log_y_lo < 4
    log_far_y = where(log_far_y_a, 1, log_y)
    log_far_y_lo = where(log_far_y_a, 0, log_y_lo)
    log_f_rest_sum = log_f_rest + log_f_rest_lo
    log_f_rest_sum_right = log_f_rest_sum - log_f_rest
    log_far_y_sum = log_far_y + log_far_y_lo
    log_far_y_sum_right = log_far_y_sum - log_far_y
    log_closed_f = log_f_rest_sum / log_far_y_sum
    log_closed_f_product = log_closed_f * log_far_y_sum
    log_closed_f_exact = (log_f_rest_sum - log_closed_f_product
        - product_error(log_closed_f, log_far_y_sum, log_closed_f_product))
    log_closed_f_numerator = (log_closed_f_exact
        + (log_f_rest - (log_f_rest_sum - log_f_rest_sum_right)
        + (log_f_rest_lo - log_f_rest_sum_right)))
    log_closed_f_cross = (log_closed_f
        * (log_far_y - (log_far_y_sum - log_far_y_sum_right)
        + (log_far_y_lo - log_far_y_sum_right)))
    log_f = where(log_far_y_a, log_near_f, log_closed_f)
    log_near_f_lo = (log_near_f_lo1
        + (1.850371707708594e-17 * log_sinc + 0.3333333333333333 * log_sinc_lo
        + log_near_f_b_cross))
    log_f_lo = where(log_far_y_a, log_near_f_lo,
        (log_closed_f_numerator - log_closed_f_cross) / log_far_y_sum)
    log_four_k = 4 * log_sinc
    log_four_k_cross2 = 4 * log_sinc_lo
    log_f_sum = log_f + log_f_lo
    log_f_sum_right = log_f_sum - log_f
    log_four_k_sum = log_four_k + log_four_k_cross2
    log_four_k_sum_right = log_four_k_sum - log_four_k
    log_b = log_f_sum / log_four_k_sum
    log_b_product = log_b * log_four_k_sum
    log_b_exact = log_f_sum - log_b_product - product_error(log_b, log_four_k_sum, log_b_product)
    log_b_cross = (log_b
        * (log_four_k - (log_four_k_sum - log_four_k_sum_right)
        + (log_four_k_cross2 - log_four_k_sum_right)))
    log_c_sum = log_c + log_c_lo
    log_c_sum_right = log_c_sum - log_c
    log_sinc_sum = log_sinc + log_sinc_lo
    log_sinc_sum_right = log_sinc_sum - log_sinc
    log_b_across = log_c_sum / log_sinc_sum
    log_b_across_product = log_b_across * log_sinc_sum
    log_b_across_exact = (log_c_sum - log_b_across_product
        - product_error(log_b_across, log_sinc_sum, log_b_across_product))
    log_b_across_cross = (log_b_across
        * (log_sinc - (log_sinc_sum - log_sinc_sum_right) + (log_sinc_lo - log_sinc_sum_right)))
    log_b_across_lo = ((log_b_across_exact
        + (log_c - (log_c_sum - log_c_sum_right) + (log_c_lo - log_c_sum_right))
        - log_b_across_cross) / log_sinc_sum)
    log_vector_0_lo = (product_error(log_upper_0_sum, log_k, log_vector_0)
        + (log_upper_0_sum_lo * log_k + log_upper_0_sum * log_k_lo))
    log_wt_a = between_3 * log_vector_0
    log_vector_1_lo = (product_error(log_upper_1_sum, log_k, log_vector_1)
        + (log_upper_1_sum_lo * log_k + log_upper_1_sum * log_k_lo))
    log_wt_b = between_7 * log_vector_1
    log_wt_c = log_wt_a + log_wt_b
    log_wt_c_right = log_wt_c - log_wt_a
    log_wt_c_left_rest = product_rest(between_3, log_vector_0, log_wt_a, log_wt_c - log_wt_c_right)
    log_wt_c_cross = (between_3_lo * log_vector_0 + between_3 * log_vector_0_lo
        + (between_7_lo * log_vector_1 + between_7 * log_vector_1_lo))
    log_vector_2_lo = (product_error(log_upper_2_sum, log_k, log_vector_2)
        + (log_upper_2_sum_lo * log_k + log_upper_2_sum * log_k_lo))
    log_wt_d = between_11 * log_vector_2
    log_wt = log_wt_c + log_wt_d
    log_wt_right = log_wt - log_wt_c
    log_wt_lo1 = (log_wt_c - (log_wt - log_wt_right)
        + product_rest(between_11, log_vector_2, log_wt_d, log_wt_right))
    log_wt_c_lo = (log_wt_c_left_rest
        + product_rest(between_7, log_vector_1, log_wt_b, log_wt_c_right) + log_wt_c_cross)
    log_pitch = log_b * log_wt
    log_pitch_cross1 = ((log_b_exact
        + (log_f - (log_f_sum - log_f_sum_right) + (log_f_lo - log_f_sum_right)) - log_b_cross)
        / log_four_k_sum * log_wt)
    log_pitch_cross = (log_pitch_cross1 + log_b
        * (log_wt_lo1 + (between_11_lo * log_vector_2 + between_11 * log_vector_2_lo)
        + log_wt_c_lo))
    log_pitch_lo = product_error(log_b, log_wt, log_pitch) + log_pitch_cross
    log_along_0 = log_vector_0 * log_pitch
    log_along_1 = log_vector_1 * log_pitch
    log_along_2 = log_vector_2 * log_pitch
    log_u_0a = between_11 * log_vector_1
    log_u_0b = between_7 * log_vector_2
    log_u_0 = log_u_0a - log_u_0b
    log_u_0_right = log_u_0a - log_u_0
    log_u_0_left_rest = product_rest(between_11, log_vector_1, log_u_0a, log_u_0 + log_u_0_right)
    log_u_0_cross = (between_11_lo * log_vector_1 + between_11 * log_vector_1_lo
        - (between_7_lo * log_vector_2 + between_7 * log_vector_2_lo))
    log_u_1a = between_3 * log_vector_2
    log_u_1b = between_11 * log_vector_0
    log_u_1 = log_u_1a - log_u_1b
    log_u_1_right = log_u_1a - log_u_1
    log_u_1_left_rest = product_rest(between_3, log_vector_2, log_u_1a, log_u_1 + log_u_1_right)
    log_u_1_cross = (between_3_lo * log_vector_2 + between_3 * log_vector_2_lo
        - (between_11_lo * log_vector_0 + between_11 * log_vector_0_lo))
    log_u_2a = between_7 * log_vector_0
    log_u_2b = between_3 * log_vector_1
    log_u_2 = log_u_2a - log_u_2b
    log_u_2_right = log_u_2a - log_u_2
    log_u_2_left_rest = product_rest(between_7, log_vector_0, log_u_2a, log_u_2 + log_u_2_right)
    log_u_2_cross = (between_7_lo * log_vector_0 + between_7 * log_vector_0_lo
        - (between_3_lo * log_vector_1 + between_3 * log_vector_1_lo))
    log_turned_0 = 0.5 * log_u_0
    log_turned_1 = 0.5 * log_u_1
    log_turned_2 = 0.5 * log_u_2
    log_across_axis_0 = log_along_0 - log_turned_0
    log_across_axis_0_right = log_along_0 - log_across_axis_0
    log_across_axis_0_left_rest = product_rest(log_vector_0, log_pitch, log_along_0,
        log_across_axis_0 + log_across_axis_0_right)
    log_turned_0_cross2 = (0.5
        * (log_u_0_left_rest - product_rest(between_7, log_vector_2, log_u_0b, log_u_0_right)
        + log_u_0_cross))
    log_across_axis_0_lo2 = (log_across_axis_0_left_rest - (log_turned_0 - log_across_axis_0_right)
        - log_turned_0_cross2)
    log_across_axis_1 = log_along_1 - log_turned_1
    log_across_axis_1_right = log_along_1 - log_across_axis_1
    log_across_axis_1_left_rest = product_rest(log_vector_1, log_pitch, log_along_1,
        log_across_axis_1 + log_across_axis_1_right)
    log_turned_1_cross2 = (0.5
        * (log_u_1_left_rest - product_rest(between_11, log_vector_0, log_u_1b, log_u_1_right)
        + log_u_1_cross))
    log_across_axis_1_lo2 = (log_across_axis_1_left_rest - (log_turned_1 - log_across_axis_1_right)
        - log_turned_1_cross2)
    log_across_axis_2 = log_along_2 - log_turned_2
    log_across_axis_2_right = log_along_2 - log_across_axis_2
    log_across_axis_2_left_rest = product_rest(log_vector_2, log_pitch, log_along_2,
        log_across_axis_2 + log_across_axis_2_right)
    log_turned_2_cross2 = (0.5
        * (log_u_2_left_rest - product_rest(between_3, log_vector_1, log_u_2b, log_u_2_right)
        + log_u_2_cross))
    log_across_axis_2_lo2 = (log_across_axis_2_left_rest - (log_turned_2 - log_across_axis_2_right)
        - log_turned_2_cross2)
    whole_0a = between_3 * log_b_across
    whole_0 = whole_0a + log_across_axis_0
    whole_0_right = whole_0 - whole_0a
    whole_0_lo1 = (product_rest(between_3, log_b_across, whole_0a, whole_0 - whole_0_right)
        + (log_across_axis_0 - whole_0_right))
    whole_0_lo2 = (whole_0_lo1
        + (log_across_axis_0_lo2 + (log_vector_0_lo * log_pitch + log_vector_0 * log_pitch_lo)))
    whole_1a = between_7 * log_b_across
    whole_1 = whole_1a + log_across_axis_1
    whole_1_right = whole_1 - whole_1a
    whole_1_lo1 = (product_rest(between_7, log_b_across, whole_1a, whole_1 - whole_1_right)
        + (log_across_axis_1 - whole_1_right))
    whole_1_lo2 = (whole_1_lo1
        + (log_across_axis_1_lo2 + (log_vector_1_lo * log_pitch + log_vector_1 * log_pitch_lo)))
    whole_2a = between_11 * log_b_across
    whole_2 = whole_2a + log_across_axis_2
    whole_2_right = whole_2 - whole_2a
    whole_2_lo1 = (product_rest(between_11, log_b_across, whole_2a, whole_2 - whole_2_right)
        + (log_across_axis_2 - whole_2_right))
    whole_2_lo2 = (whole_2_lo1
        + (log_across_axis_2_lo2 + (log_vector_2_lo * log_pitch + log_vector_2 * log_pitch_lo)))
    screw_0 = k * whole_0
    screw_1 = k * whole_1
    screw_2 = k * whole_2
    screw_3 = k * log_vector_0
    screw_4 = k * log_vector_1
    screw_5 = k * log_vector_2
    screw_3_lo = product_error(k, log_vector_0, screw_3) + k * log_vector_0_lo
    exp_halved_0 = 0.5 * screw_3
    exp_halved_0_cross2 = 0.5 * screw_3_lo
    screw_4_lo = product_error(k, log_vector_1, screw_4) + k * log_vector_1_lo
    exp_halved_1 = 0.5 * screw_4
    exp_halved_1_cross2 = 0.5 * screw_4_lo
    screw_5_lo = product_error(k, log_vector_2, screw_5) + k * log_vector_2_lo
    exp_halved_2 = 0.5 * screw_5
    exp_halved_2_cross2 = 0.5 * screw_5_lo
    exp_y_a = exp_halved_0 * exp_halved_0
    exp_y_b = exp_halved_1 * exp_halved_1
    exp_y_c = exp_y_a + exp_y_b
    exp_y_c_right = exp_y_c - exp_y_a
    exp_y_a_cross = exp_halved_0_cross2 * exp_halved_0 + exp_halved_0 * exp_halved_0_cross2
    exp_y_c_left_rest = product_rest(exp_halved_0, exp_halved_0, exp_y_a, exp_y_c - exp_y_c_right)
    exp_y_c_cross = (exp_y_a_cross
        + (exp_halved_1_cross2 * exp_halved_1 + exp_halved_1 * exp_halved_1_cross2))
    exp_y_d = exp_halved_2 * exp_halved_2
    exp_y = exp_y_c + exp_y_d
    exp_y_right = exp_y - exp_y_c
    exp_y_lo1 = (exp_y_c - (exp_y - exp_y_right)
        + product_rest(exp_halved_2, exp_halved_2, exp_y_d, exp_y_right))
    exp_y_c_lo = (exp_y_c_left_rest
        + product_rest(exp_halved_1, exp_halved_1, exp_y_b, exp_y_c_right) + exp_y_c_cross)
    exp_y_lo = (exp_y_lo1
        + (exp_halved_2_cross2 * exp_halved_2 + exp_halved_2 * exp_halved_2_cross2) + exp_y_c_lo)
    exp_y_sum = exp_y + exp_y_lo
    exp_y_sum_right = exp_y_sum - exp_y
    exp_y_sum_lo = exp_y - (exp_y_sum - exp_y_sum_right) + (exp_y_lo - exp_y_sum_right)
    exp_half_angle = sqrt(exp_y_sum)
    exp_half_angle_product = exp_half_angle * exp_half_angle
    exp_half_angle_residual = (exp_y_sum - exp_half_angle_product
        - product_error(exp_half_angle, exp_half_angle, exp_half_angle_product) + exp_y_sum_lo)
    exp_half_angle_lo = (exp_half_angle_residual
        / where(exp_half_angle == 0, 1, exp_half_angle + exp_half_angle))
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
    exp_sinc_divisor_a = exp_half_angle_sum < 1.4901161193847656e-08
    exp_sinc_divisor = where(exp_sinc_divisor_a, 1.4901161193847656e-08, exp_half_angle_sum)
    exp_sinc_divisor_lo = where(exp_sinc_divisor_a, 0, exp_half_angle_sum_lo)
    exp_sine_sum = exp_sine + exp_sine_lo
    exp_sine_sum_right = exp_sine_sum - exp_sine
    exp_sine_sum_lo = (exp_sine - (exp_sine_sum - exp_sine_sum_right)
        + (exp_sine_lo - exp_sine_sum_right))
    exp_sinc_divisor_sum = exp_sinc_divisor + exp_sinc_divisor_lo
    exp_sinc_divisor_sum_right = exp_sinc_divisor_sum - exp_sinc_divisor
    exp_sinc_quotient = exp_sine_sum / exp_sinc_divisor_sum
    exp_sinc_quotient_product = exp_sinc_quotient * exp_sinc_divisor_sum
    exp_sinc_quotient_exact = (exp_sine_sum - exp_sinc_quotient_product
        - product_error(exp_sinc_quotient, exp_sinc_divisor_sum, exp_sinc_quotient_product))
    exp_sinc_divisor_sum_lo = (exp_sinc_divisor
        - (exp_sinc_divisor_sum - exp_sinc_divisor_sum_right)
        + (exp_sinc_divisor_lo - exp_sinc_divisor_sum_right))
    exp_sinc_a = 0.16666666666666666 * exp_y_sum
    exp_sinc_b = 1 - exp_sinc_a
    exp_sinc_b_right = 1 - exp_sinc_b
    exp_sinc_b_lo1 = (1 - (exp_sinc_b + exp_sinc_b_right)
        - product_rest(0.16666666666666666, exp_y_sum, exp_sinc_a, exp_sinc_b_right))
    exp_sinc = where(exp_sinc_divisor_a, exp_sinc_b, exp_sinc_quotient)
    exp_sinc_quotient_lo = ((exp_sinc_quotient_exact + exp_sine_sum_lo - exp_sinc_quotient
        * exp_sinc_divisor_sum_lo) / exp_sinc_divisor_sum)
    exp_sinc_b_lo = (exp_sinc_b_lo1
        - (9.25185853854297e-18 * exp_y_sum + 0.16666666666666666 * exp_y_sum_lo))
    exp_sinc_lo = where(exp_sinc_divisor_a, exp_sinc_b_lo, exp_sinc_quotient_lo)
    exp_g1 = exp_c * exp_sinc
    exp_g1_cross = ((exp_c_own_error - (exp_sine_half_cos * exp_sine + exp_sine_half_sin * exp_c)
        * exp_sine_twice) * exp_sinc + exp_c * exp_sinc_lo)
    exp_g2a = exp_sinc * exp_sinc
    exp_g2 = 0.5 * exp_g2a
    exp_g2_cross2 = (0.5
        * (product_error(exp_sinc, exp_sinc, exp_g2a)
        + (exp_sinc_lo * exp_sinc + exp_sinc * exp_sinc_lo)))
    exp_sine_square = exp_sine_sum * exp_sine_sum
    exp_g0a = 2 * exp_sine_square
    exp_g0 = 1 - exp_g0a
    exp_g0_right = 1 - exp_g0
    exp_g0a_cross2 = (2
        * (product_error(exp_sine_sum, exp_sine_sum, exp_sine_square)
        + (exp_sine_sum_lo * exp_sine_sum + exp_sine_sum * exp_sine_sum_lo)))
    exp_g0_lo = 1 - (exp_g0 + exp_g0_right) - (exp_g0a - exp_g0_right) - exp_g0a_cross2
    exp_rest3 = 1 - exp_g1
    exp_rest3_right = 1 - exp_rest3
    exp_rest3_lo = (1 - (exp_rest3 + exp_rest3_right)
        - product_rest(exp_c, exp_sinc, exp_g1, exp_rest3_right) - exp_g1_cross)
    exp_x = 4 * exp_y_sum
    exp_x_cross2 = 4 * exp_y_sum_lo
    exp_x_sum = exp_x + exp_x_cross2
    exp_x_sum_right = exp_x_sum - exp_x
    exp_x_sum_lo = exp_x - (exp_x_sum - exp_x_sum_right) + (exp_x_cross2 - exp_x_sum_right)
    exp_far_x_a = exp_x_sum < 1
    exp_far_x = where(exp_far_x_a, 1, exp_x_sum)
    exp_far_x_lo = where(exp_far_x_a, 0, exp_x_sum_lo)
    exp_rest3_sum = exp_rest3 + exp_rest3_lo
    exp_rest3_sum_right = exp_rest3_sum - exp_rest3
    exp_far_x_sum = exp_far_x + exp_far_x_lo
    exp_far_x_sum_right = exp_far_x_sum - exp_far_x
    exp_closed3 = exp_rest3_sum / exp_far_x_sum
    exp_closed3_product = exp_closed3 * exp_far_x_sum
    exp_closed3_exact = (exp_rest3_sum - exp_closed3_product
        - product_error(exp_closed3, exp_far_x_sum, exp_closed3_product))
    exp_closed3_numerator = (exp_closed3_exact
        + (exp_rest3 - (exp_rest3_sum - exp_rest3_sum_right)
        + (exp_rest3_lo - exp_rest3_sum_right)))
    exp_closed3_cross = (exp_closed3
        * (exp_far_x - (exp_far_x_sum - exp_far_x_sum_right)
        + (exp_far_x_lo - exp_far_x_sum_right)))
    exp_series5a = 1.216125041553518e-34 * exp_x_sum
    exp_series5b = 1.1309962886447716e-31 - exp_series5a
    exp_series5b_right = 1.1309962886447716e-31 - exp_series5b
    exp_series5b_right_rest = product_rest(1.216125041553518e-34, exp_x_sum, exp_series5a,
        exp_series5b_right)
    exp_series5b_lo1 = (1.1309962886447716e-31 - (exp_series5b + exp_series5b_right)
        - exp_series5b_right_rest)
    exp_series5c = exp_x_sum * exp_series5b
    exp_series5b_lo = (exp_series5b_lo1
        - (5.586290567888806e-51 * exp_x_sum + 1.216125041553518e-34 * exp_x_sum_lo)
        + 1.0498015412959506e-47)
    exp_series5d = exp_series5c - 9.183689863795546e-29
    exp_series5d_right = exp_series5c - exp_series5d
    exp_series5d_left_rest = product_rest(exp_x_sum, exp_series5b, exp_series5c,
        exp_series5d + exp_series5d_right)
    exp_series5d_lo2 = (exp_series5d_left_rest - (9.183689863795546e-29 - exp_series5d_right)
        - 1.4303150396787322e-45)
    exp_series5e = exp_x_sum * exp_series5d
    exp_series5f = exp_series5e + 6.446950284384474e-26
    exp_series5f_right = exp_series5f - exp_series5e
    exp_series5f_left_rest = product_rest(exp_x_sum, exp_series5d, exp_series5e,
        exp_series5f - exp_series5f_right)
    exp_series5e_cross = (exp_x_sum_lo * exp_series5d + exp_x_sum
        * (exp_series5d_lo2 + (exp_x_sum_lo * exp_series5b + exp_x_sum * exp_series5b_lo)))
    exp_series5g = exp_x_sum * exp_series5f
    exp_series5f_lo = (exp_series5f_left_rest + (6.446950284384474e-26 - exp_series5f_right) +
        -1.9330404233703465e-42 + exp_series5e_cross)
    exp_series5h = exp_series5g - 3.868170170630684e-23
    exp_series5h_right = exp_series5g - exp_series5h
    exp_series5h_left_rest = product_rest(exp_x_sum, exp_series5f, exp_series5g,
        exp_series5h + exp_series5h_right)
    exp_series5h_lo2 = (exp_series5h_left_rest - (3.868170170630684e-23 - exp_series5h_right) -
        -8.843177655482344e-40)
    exp_series5i = exp_x_sum * exp_series5h
    exp_series5j = exp_series5i + 1.9572941063391263e-20
    exp_series5j_right = exp_series5j - exp_series5i
    exp_series5j_left_rest = product_rest(exp_x_sum, exp_series5h, exp_series5i,
        exp_series5j - exp_series5j_right)
    exp_series5i_cross = (exp_x_sum_lo * exp_series5h + exp_x_sum
        * (exp_series5h_lo2 + (exp_x_sum_lo * exp_series5f + exp_x_sum * exp_series5f_lo)))
    exp_series5k = exp_x_sum * exp_series5j
    exp_series5j_lo = (exp_series5j_left_rest + (1.9572941063391263e-20 - exp_series5j_right) +
        -1.3643503830087908e-36 + exp_series5i_cross)
    exp_series5l = exp_series5k - 8.22063524662433e-18
    exp_series5l_right = exp_series5k - exp_series5l
    exp_series5l_left_rest = product_rest(exp_x_sum, exp_series5j, exp_series5k,
        exp_series5l + exp_series5l_right)
    exp_series5l_lo2 = (exp_series5l_left_rest - (8.22063524662433e-18 - exp_series5l_right)
        - 2.2141894119604265e-34)
    exp_series5m = exp_x_sum * exp_series5l
    exp_series5n = exp_series5m + 2.8114572543455206e-15
    exp_series5n_right = exp_series5n - exp_series5m
    exp_series5n_left_rest = product_rest(exp_x_sum, exp_series5l, exp_series5m,
        exp_series5n - exp_series5n_right)
    exp_series5m_cross = (exp_x_sum_lo * exp_series5l + exp_x_sum
        * (exp_series5l_lo2 + (exp_x_sum_lo * exp_series5j + exp_x_sum * exp_series5j_lo)))
    exp_series5o = exp_x_sum * exp_series5n
    exp_series5n_lo = (exp_series5n_left_rest + (2.8114572543455206e-15 - exp_series5n_right)
        + 1.6508842730861433e-31 + exp_series5m_cross)
    exp_series5p = exp_series5o - 7.647163731819816e-13
    exp_series5p_right = exp_series5o - exp_series5p
    exp_series5p_left_rest = product_rest(exp_x_sum, exp_series5n, exp_series5o,
        exp_series5p + exp_series5p_right)
    exp_series5p_lo2 = (exp_series5p_left_rest - (7.647163731819816e-13 - exp_series5p_right)
        - 7.03872877733453e-30)
    exp_series5q = exp_x_sum * exp_series5p
    exp_series5r = exp_series5q + 1.6059043836821613e-10
    exp_series5r_right = exp_series5r - exp_series5q
    exp_series5r_left_rest = product_rest(exp_x_sum, exp_series5p, exp_series5q,
        exp_series5r - exp_series5r_right)
    exp_series5q_cross = (exp_x_sum_lo * exp_series5p + exp_x_sum
        * (exp_series5p_lo2 + (exp_x_sum_lo * exp_series5n + exp_x_sum * exp_series5n_lo)))
    exp_series5s = exp_x_sum * exp_series5r
    exp_series5r_lo = (exp_series5r_left_rest + (1.6059043836821613e-10 - exp_series5r_right)
        + 1.2585294588752098e-26 + exp_series5q_cross)
    exp_series5t = exp_series5s - 2.505210838544172e-08
    exp_series5t_right = exp_series5s - exp_series5t
    exp_series5t_left_rest = product_rest(exp_x_sum, exp_series5r, exp_series5s,
        exp_series5t + exp_series5t_right)
    exp_series5t_lo2 = (exp_series5t_left_rest - (2.505210838544172e-08 - exp_series5t_right) -
        -1.448814070935912e-24)
    exp_series5u = exp_x_sum * exp_series5t
    exp_series5v = exp_series5u + 2.7557319223985893e-06
    exp_series5v_right = exp_series5v - exp_series5u
    exp_series5v_left_rest = product_rest(exp_x_sum, exp_series5t, exp_series5u,
        exp_series5v - exp_series5v_right)
    exp_series5u_cross = (exp_x_sum_lo * exp_series5t + exp_x_sum
        * (exp_series5t_lo2 + (exp_x_sum_lo * exp_series5r + exp_x_sum * exp_series5r_lo)))
    exp_series5w = exp_x_sum * exp_series5v
    exp_series5v_lo = (exp_series5v_left_rest + (2.7557319223985893e-06 - exp_series5v_right) +
        -1.858393274046472e-22 + exp_series5u_cross)
    exp_series5x = exp_series5w - 0.0001984126984126984
    exp_series5x_right = exp_series5w - exp_series5x
    exp_series5x_left_rest = product_rest(exp_x_sum, exp_series5v, exp_series5w,
        exp_series5x + exp_series5x_right)
    exp_series5x_lo2 = (exp_series5x_left_rest - (0.0001984126984126984 - exp_series5x_right)
        - 1.7209558293420705e-22)
    exp_series5y = exp_x_sum * exp_series5x
    exp_series5 = exp_series5y + 0.008333333333333333
    exp_series5_right = exp_series5 - exp_series5y
    exp_series5_lo1 = (product_rest(exp_x_sum, exp_series5x, exp_series5y, exp_series5
        - exp_series5_right) + (0.008333333333333333 - exp_series5_right))
    exp_series5y_cross = (exp_x_sum_lo * exp_series5x + exp_x_sum
        * (exp_series5x_lo2 + (exp_x_sum_lo * exp_series5v + exp_x_sum * exp_series5v_lo)))
    exp_g3a = exp_x_sum * exp_series5
    exp_g3b = 0.16666666666666666 - exp_g3a
    exp_g3b_right = 0.16666666666666666 - exp_g3b
    exp_g3b_lo1 = (0.16666666666666666 - (exp_g3b + exp_g3b_right)
        - product_rest(exp_x_sum, exp_series5, exp_g3a, exp_g3b_right))
    exp_g3b_lo2 = (exp_g3b_lo1
        - (exp_x_sum_lo * exp_series5 + exp_x_sum
        * (exp_series5_lo1 + 1.1564823173178714e-19 + exp_series5y_cross)))
    exp_g3 = where(exp_far_x_a, exp_g3b, exp_closed3)
    screw_2_lo = (product_error(k, whole_2, screw_2) + k
        * (whole_2_lo2 + (between_11_lo * log_b_across + between_11 * log_b_across_lo)))
    exp_u_0a = screw_2 * screw_4
    screw_1_lo = (product_error(k, whole_1, screw_1) + k
        * (whole_1_lo2 + (between_7_lo * log_b_across + between_7 * log_b_across_lo)))
    exp_u_0b = screw_1 * screw_5
    exp_u_0 = exp_u_0a - exp_u_0b
    exp_u_0_right = exp_u_0a - exp_u_0
    exp_u_0_lo1 = (product_rest(screw_2, screw_4, exp_u_0a, exp_u_0 + exp_u_0_right)
        - product_rest(screw_1, screw_5, exp_u_0b, exp_u_0_right))
    screw_0_lo = (product_error(k, whole_0, screw_0) + k
        * (whole_0_lo2 + (between_3_lo * log_b_across + between_3 * log_b_across_lo)))
    exp_u_1a = screw_0 * screw_5
    exp_u_1b = screw_2 * screw_3
    exp_u_1 = exp_u_1a - exp_u_1b
    exp_u_1_right = exp_u_1a - exp_u_1
    exp_u_1_lo1 = (product_rest(screw_0, screw_5, exp_u_1a, exp_u_1 + exp_u_1_right)
        - product_rest(screw_2, screw_3, exp_u_1b, exp_u_1_right))
    exp_u_2a = screw_1 * screw_3
    exp_u_2b = screw_0 * screw_4
    exp_u_2 = exp_u_2a - exp_u_2b
    exp_u_2_right = exp_u_2a - exp_u_2
    exp_u_2_lo1 = (product_rest(screw_1, screw_3, exp_u_2a, exp_u_2 + exp_u_2_right)
        - product_rest(screw_0, screw_4, exp_u_2b, exp_u_2_right))
    exp_turned_0 = exp_g2 * exp_u_0
    exp_turned_0_cross2 = (exp_g2
        * (exp_u_0_lo1
        + (screw_2_lo * screw_4 + screw_2 * screw_4_lo
        - (screw_1_lo * screw_5 + screw_1 * screw_5_lo))))
    exp_turned_1 = exp_g2 * exp_u_1
    exp_turned_1_cross2 = (exp_g2
        * (exp_u_1_lo1
        + (screw_0_lo * screw_5 + screw_0 * screw_5_lo
        - (screw_2_lo * screw_3 + screw_2 * screw_3_lo))))
    exp_turned_2 = exp_g2 * exp_u_2
    exp_turned_2_cross2 = (exp_g2
        * (exp_u_2_lo1
        + (screw_1_lo * screw_3 + screw_1 * screw_3_lo
        - (screw_0_lo * screw_4 + screw_0 * screw_4_lo))))
    exp_wv_a = screw_0 * screw_3
    exp_wv_b = screw_1 * screw_4
    exp_wv_c = exp_wv_a + exp_wv_b
    exp_wv_c_right = exp_wv_c - exp_wv_a
    exp_wv_c_lo1 = (product_rest(screw_0, screw_3, exp_wv_a, exp_wv_c - exp_wv_c_right)
        + product_rest(screw_1, screw_4, exp_wv_b, exp_wv_c_right))
    exp_wv_d = screw_2 * screw_5
    exp_wv = exp_wv_c + exp_wv_d
    exp_wv_right = exp_wv - exp_wv_c
    exp_wv_lo1 = (exp_wv_c - (exp_wv - exp_wv_right)
        + product_rest(screw_2, screw_5, exp_wv_d, exp_wv_right))
    exp_wv_c_lo = (exp_wv_c_lo1
        + (screw_0_lo * screw_3 + screw_0 * screw_3_lo
        + (screw_1_lo * screw_4 + screw_1 * screw_4_lo)))
    exp_pitch = exp_g3 * exp_wv
    exp_pitch_cross1 = (where(exp_far_x_a, exp_g3b_lo2
        + 9.25185853854297e-18, (exp_closed3_numerator - exp_closed3_cross) / exp_far_x_sum)
        * exp_wv)
    exp_pitch_cross = (exp_pitch_cross1 + exp_g3
        * (exp_wv_lo1 + (screw_2_lo * screw_5 + screw_2 * screw_5_lo) + exp_wv_c_lo))
    exp_pitch_lo = product_error(exp_g3, exp_wv, exp_pitch) + exp_pitch_cross
    exp_along_0 = screw_3 * exp_pitch
    exp_along_1 = screw_4 * exp_pitch
    exp_along_2 = screw_5 * exp_pitch
    exp_beta_v_0 = screw_3 * exp_g2
    exp_beta_v_1 = screw_4 * exp_g2
    exp_beta_v_2 = screw_5 * exp_g2
    exp_beta_v_0_lo = (product_error(screw_3, exp_g2, exp_beta_v_0)
        + (screw_3_lo * exp_g2 + screw_3 * exp_g2_cross2))
    exp_m_0 = screw_3 * exp_beta_v_0
    exp_m_0_cross = screw_3_lo * exp_beta_v_0 + screw_3 * exp_beta_v_0_lo
    exp_beta_v_1_lo = (product_error(screw_4, exp_g2, exp_beta_v_1)
        + (screw_4_lo * exp_g2 + screw_4 * exp_g2_cross2))
    exp_m_1 = screw_4 * exp_beta_v_1
    exp_m_1_cross = screw_4_lo * exp_beta_v_1 + screw_4 * exp_beta_v_1_lo
    exp_m_2 = screw_5 * exp_beta_v_2
    exp_m_2_cross = (screw_5_lo * exp_beta_v_2 + screw_5
        * (product_error(screw_5, exp_g2, exp_beta_v_2)
        + (screw_5_lo * exp_g2 + screw_5 * exp_g2_cross2)))
    exp_m_3 = screw_4 * exp_beta_v_0
    exp_m_3_cross = screw_4_lo * exp_beta_v_0 + screw_4 * exp_beta_v_0_lo
    exp_m_4 = screw_5 * exp_beta_v_0
    exp_m_4_cross = screw_5_lo * exp_beta_v_0 + screw_5 * exp_beta_v_0_lo
    exp_m_5 = screw_5 * exp_beta_v_1
    exp_m_5_cross = screw_5_lo * exp_beta_v_1 + screw_5 * exp_beta_v_1_lo
    exp_others_0 = exp_m_1 + exp_m_2
    exp_others_0_right = exp_others_0 - exp_m_1
    exp_others_0_left_rest = product_rest(screw_4, exp_beta_v_1, exp_m_1,
        exp_others_0 - exp_others_0_right)
    exp_others_0_lo = (exp_others_0_left_rest
        + product_rest(screw_5, exp_beta_v_2, exp_m_2, exp_others_0_right)
        + (exp_m_1_cross + exp_m_2_cross))
    exp_others_1 = exp_m_0 + exp_m_2
    exp_others_1_right = exp_others_1 - exp_m_0
    exp_others_1_left_rest = product_rest(screw_3, exp_beta_v_0, exp_m_0,
        exp_others_1 - exp_others_1_right)
    exp_others_1_lo = (exp_others_1_left_rest
        + product_rest(screw_5, exp_beta_v_2, exp_m_2, exp_others_1_right)
        + (exp_m_0_cross + exp_m_2_cross))
    exp_others_2 = exp_m_0 + exp_m_1
    exp_others_2_right = exp_others_2 - exp_m_0
    exp_others_2_left_rest = product_rest(screw_3, exp_beta_v_0, exp_m_0,
        exp_others_2 - exp_others_2_right)
    exp_others_2_lo = (exp_others_2_left_rest
        + product_rest(screw_4, exp_beta_v_1, exp_m_1, exp_others_2_right)
        + (exp_m_0_cross + exp_m_1_cross))
    exp_diagonal0a = 1 - exp_others_0
    exp_diagonal0a_right = 1 - exp_diagonal0a
    exp_diagonal0b = exp_g0 + exp_m_0
    exp_diagonal0b_right = exp_diagonal0b - exp_g0
    exp_diagonal0b_lo1 = (exp_g0 - (exp_diagonal0b - exp_diagonal0b_right)
        + product_rest(screw_3, exp_beta_v_0, exp_m_0, exp_diagonal0b_right))
    exp_diagonal0c = (exp_m_0 + (product_error(screw_3, exp_beta_v_0, exp_m_0) + exp_m_0_cross)
        < exp_others_0 + exp_others_0_lo)
    exp_diagonal0 = where(exp_diagonal0c, exp_diagonal0b, exp_diagonal0a)
    exp_diagonal0a_lo = (1 - (exp_diagonal0a + exp_diagonal0a_right)
        - (exp_others_0 - exp_diagonal0a_right) - exp_others_0_lo)
    exp_diagonal0_lo = where(exp_diagonal0c, exp_diagonal0b_lo1 + exp_m_0_cross + exp_g0_lo,
        exp_diagonal0a_lo)
    exp_diagonal1a = 1 - exp_others_1
    exp_diagonal1a_right = 1 - exp_diagonal1a
    exp_diagonal1b = exp_g0 + exp_m_1
    exp_diagonal1b_right = exp_diagonal1b - exp_g0
    exp_diagonal1b_lo1 = (exp_g0 - (exp_diagonal1b - exp_diagonal1b_right)
        + product_rest(screw_4, exp_beta_v_1, exp_m_1, exp_diagonal1b_right))
    exp_diagonal1c = (exp_m_1 + (product_error(screw_4, exp_beta_v_1, exp_m_1) + exp_m_1_cross)
        < exp_others_1 + exp_others_1_lo)
    exp_diagonal1 = where(exp_diagonal1c, exp_diagonal1b, exp_diagonal1a)
    exp_diagonal1a_lo = (1 - (exp_diagonal1a + exp_diagonal1a_right)
        - (exp_others_1 - exp_diagonal1a_right) - exp_others_1_lo)
    exp_diagonal1_lo = where(exp_diagonal1c, exp_diagonal1b_lo1 + exp_m_1_cross + exp_g0_lo,
        exp_diagonal1a_lo)
    exp_diagonal2a = 1 - exp_others_2
    exp_diagonal2a_right = 1 - exp_diagonal2a
    exp_diagonal2b = exp_g0 + exp_m_2
    exp_diagonal2b_right = exp_diagonal2b - exp_g0
    exp_diagonal2b_lo1 = (exp_g0 - (exp_diagonal2b - exp_diagonal2b_right)
        + product_rest(screw_5, exp_beta_v_2, exp_m_2, exp_diagonal2b_right))
    exp_diagonal2c = (exp_m_2 + (product_error(screw_5, exp_beta_v_2, exp_m_2) + exp_m_2_cross)
        < exp_others_2 + exp_others_2_lo)
    exp_diagonal2 = where(exp_diagonal2c, exp_diagonal2b, exp_diagonal2a)
    exp_diagonal2a_lo = (1 - (exp_diagonal2a + exp_diagonal2a_right)
        - (exp_others_2 - exp_diagonal2a_right) - exp_others_2_lo)
    exp_diagonal2_lo = where(exp_diagonal2c, exp_diagonal2b_lo1 + exp_m_2_cross + exp_g0_lo,
        exp_diagonal2a_lo)
    exp_g1_lo = product_error(exp_c, exp_sinc, exp_g1) + exp_g1_cross
    exp_alpha_v_0 = screw_3 * exp_g1
    exp_alpha_v_0_cross = screw_3_lo * exp_g1 + screw_3 * exp_g1_lo
    exp_alpha_v_1 = screw_4 * exp_g1
    exp_alpha_v_1_cross = screw_4_lo * exp_g1 + screw_4 * exp_g1_lo
    exp_alpha_v_2 = screw_5 * exp_g1
    exp_alpha_v_2_cross = screw_5_lo * exp_g1 + screw_5 * exp_g1_lo
    exp_across_axis_0 = exp_turned_0 + exp_along_0
    exp_across_axis_0_right = exp_across_axis_0 - exp_turned_0
    exp_across_axis_0_left_rest = product_rest(exp_g2, exp_u_0, exp_turned_0,
        exp_across_axis_0 - exp_across_axis_0_right)
    exp_across_axis_0_lo1 = (exp_across_axis_0_left_rest
        + product_rest(screw_3, exp_pitch, exp_along_0, exp_across_axis_0_right))
    exp_across_axis_1 = exp_turned_1 + exp_along_1
    exp_across_axis_1_right = exp_across_axis_1 - exp_turned_1
    exp_across_axis_1_left_rest = product_rest(exp_g2, exp_u_1, exp_turned_1,
        exp_across_axis_1 - exp_across_axis_1_right)
    exp_across_axis_1_lo1 = (exp_across_axis_1_left_rest
        + product_rest(screw_4, exp_pitch, exp_along_1, exp_across_axis_1_right))
    exp_across_axis_2 = exp_turned_2 + exp_along_2
    exp_across_axis_2_right = exp_across_axis_2 - exp_turned_2
    exp_across_axis_2_left_rest = product_rest(exp_g2, exp_u_2, exp_turned_2,
        exp_across_axis_2 - exp_across_axis_2_right)
    exp_across_axis_2_lo1 = (exp_across_axis_2_left_rest
        + product_rest(screw_5, exp_pitch, exp_along_2, exp_across_axis_2_right))
    step_1 = exp_m_3 - exp_alpha_v_2
    step_1_right = exp_m_3 - step_1
    step_1_lo1 = (product_rest(screw_4, exp_beta_v_0, exp_m_3, step_1 + step_1_right)
        - product_rest(screw_5, exp_g1, exp_alpha_v_2, step_1_right))
    step_1_lo = step_1_lo1 + (exp_m_3_cross - exp_alpha_v_2_cross)
    step_2 = exp_m_4 + exp_alpha_v_1
    step_2_right = step_2 - exp_m_4
    step_2_lo1 = (product_rest(screw_5, exp_beta_v_0, exp_m_4, step_2 - step_2_right)
        + product_rest(screw_4, exp_g1, exp_alpha_v_1, step_2_right))
    step_2_lo = step_2_lo1 + (exp_m_4_cross + exp_alpha_v_1_cross)
    step_3a = screw_0 * exp_g1
    step_3 = step_3a + exp_across_axis_0
    step_3_right = step_3 - step_3a
    exp_across_axis_0_lo = (exp_across_axis_0_lo1
        + (exp_g2_cross2 * exp_u_0 + exp_turned_0_cross2
        + (screw_3_lo * exp_pitch + screw_3 * exp_pitch_lo)))
    step_3_lo2 = (product_rest(screw_0, exp_g1, step_3a, step_3 - step_3_right)
        + (exp_across_axis_0 - step_3_right) + exp_across_axis_0_lo)
    step_3_lo = step_3_lo2 + (screw_0_lo * exp_g1 + screw_0 * exp_g1_lo)
    step_4 = exp_m_3 + exp_alpha_v_2
    step_4_right = step_4 - exp_m_3
    step_4_lo1 = (product_rest(screw_4, exp_beta_v_0, exp_m_3, step_4 - step_4_right)
        + product_rest(screw_5, exp_g1, exp_alpha_v_2, step_4_right))
    step_4_lo = step_4_lo1 + (exp_m_3_cross + exp_alpha_v_2_cross)
    step_6 = exp_m_5 - exp_alpha_v_0
    step_6_right = exp_m_5 - step_6
    step_6_lo1 = (product_rest(screw_5, exp_beta_v_1, exp_m_5, step_6 + step_6_right)
        - product_rest(screw_3, exp_g1, exp_alpha_v_0, step_6_right))
    step_6_lo = step_6_lo1 + (exp_m_5_cross - exp_alpha_v_0_cross)
    step_7a = screw_1 * exp_g1
    step_7 = step_7a + exp_across_axis_1
    step_7_right = step_7 - step_7a
    exp_across_axis_1_lo = (exp_across_axis_1_lo1
        + (exp_g2_cross2 * exp_u_1 + exp_turned_1_cross2
        + (screw_4_lo * exp_pitch + screw_4 * exp_pitch_lo)))
    step_7_lo2 = (product_rest(screw_1, exp_g1, step_7a, step_7 - step_7_right)
        + (exp_across_axis_1 - step_7_right) + exp_across_axis_1_lo)
    step_7_lo = step_7_lo2 + (screw_1_lo * exp_g1 + screw_1 * exp_g1_lo)
    step_8 = exp_m_4 - exp_alpha_v_1
    step_8_right = exp_m_4 - step_8
    step_8_lo1 = (product_rest(screw_5, exp_beta_v_0, exp_m_4, step_8 + step_8_right)
        - product_rest(screw_4, exp_g1, exp_alpha_v_1, step_8_right))
    step_8_lo = step_8_lo1 + (exp_m_4_cross - exp_alpha_v_1_cross)
    step_9 = exp_m_5 + exp_alpha_v_0
    step_9_right = step_9 - exp_m_5
    step_9_lo1 = (product_rest(screw_5, exp_beta_v_1, exp_m_5, step_9 - step_9_right)
        + product_rest(screw_3, exp_g1, exp_alpha_v_0, step_9_right))
    step_9_lo = step_9_lo1 + (exp_m_5_cross + exp_alpha_v_0_cross)
    step_11a = screw_2 * exp_g1
    step_11 = step_11a + exp_across_axis_2
    step_11_right = step_11 - step_11a
    exp_across_axis_2_lo = (exp_across_axis_2_lo1
        + (exp_g2_cross2 * exp_u_2 + exp_turned_2_cross2
        + (screw_5_lo * exp_pitch + screw_5 * exp_pitch_lo)))
    step_11_lo2 = (product_rest(screw_2, exp_g1, step_11a, step_11 - step_11_right)
        + (exp_across_axis_2 - step_11_right) + exp_across_axis_2_lo)
    step_11_lo = step_11_lo2 + (screw_2_lo * exp_g1 + screw_2 * exp_g1_lo)
    Do_00a = D1_00 * exp_diagonal0
    Do_00b = D1_01 * step_4
    Do_00c = D1_02 * step_8
    Do_00d = Do_00b + Do_00c
    Do_00d_right = Do_00d - Do_00b
    Do_00d_lo1 = (product_rest(D1_01, step_4, Do_00b, Do_00d - Do_00d_right)
        + product_rest(D1_02, step_8, Do_00c, Do_00d_right))
    Do_00 = Do_00a + Do_00d
    Do_00_right = Do_00 - Do_00a
    Do_00_lo1 = (product_rest(D1_00, exp_diagonal0, Do_00a, Do_00 - Do_00_right)
        + (Do_00d - Do_00_right))
    Do_01a = D1_00 * step_1
    Do_01b = D1_02 * step_9
    Do_01c = Do_01a + Do_01b
    Do_01c_right = Do_01c - Do_01a
    Do_01c_lo1 = (product_rest(D1_00, step_1, Do_01a, Do_01c - Do_01c_right)
        + product_rest(D1_02, step_9, Do_01b, Do_01c_right))
    Do_01d = D1_01 * exp_diagonal1
    Do_01 = Do_01c + Do_01d
    Do_01_right = Do_01 - Do_01c
    Do_01_lo2 = (Do_01c - (Do_01 - Do_01_right)
        + product_rest(D1_01, exp_diagonal1, Do_01d, Do_01_right) + D1_01 * exp_diagonal1_lo)
    Do_02a = D1_00 * step_2
    Do_02b = D1_01 * step_6
    Do_02c = Do_02a + Do_02b
    Do_02c_right = Do_02c - Do_02a
    Do_02c_lo1 = (product_rest(D1_00, step_2, Do_02a, Do_02c - Do_02c_right)
        + product_rest(D1_01, step_6, Do_02b, Do_02c_right))
    Do_02d = D1_02 * exp_diagonal2
    Do_02 = Do_02c + Do_02d
    Do_02_right = Do_02 - Do_02c
    Do_02_lo2 = (Do_02c - (Do_02 - Do_02_right)
        + product_rest(D1_02, exp_diagonal2, Do_02d, Do_02_right) + D1_02 * exp_diagonal2_lo)
    Do_03a = D1_00 * step_3
    Do_03b = D1_01 * step_7
    Do_03c = Do_03a + Do_03b
    Do_03c_right = Do_03c - Do_03a
    Do_03c_lo1 = (product_rest(D1_00, step_3, Do_03a, Do_03c - Do_03c_right)
        + product_rest(D1_01, step_7, Do_03b, Do_03c_right))
    Do_03d = D1_02 * step_11
    Do_03e = Do_03c + Do_03d
    Do_03e_right = Do_03e - Do_03c
    Do_03e_lo2 = (Do_03c - (Do_03e - Do_03e_right)
        + product_rest(D1_02, step_11, Do_03d, Do_03e_right) + D1_02 * step_11_lo)
    Do_03 = Do_03e + D1_03
    Do_03_right = Do_03 - Do_03e
    Do_10a = D1_10 * exp_diagonal0
    Do_10b = D1_11 * step_4
    Do_10c = D1_12 * step_8
    Do_10d = Do_10b + Do_10c
    Do_10d_right = Do_10d - Do_10b
    Do_10d_lo1 = (product_rest(D1_11, step_4, Do_10b, Do_10d - Do_10d_right)
        + product_rest(D1_12, step_8, Do_10c, Do_10d_right))
    Do_10 = Do_10a + Do_10d
    Do_10_right = Do_10 - Do_10a
    Do_10_lo1 = (product_rest(D1_10, exp_diagonal0, Do_10a, Do_10 - Do_10_right)
        + (Do_10d - Do_10_right))
    Do_11a = D1_10 * step_1
    Do_11b = D1_12 * step_9
    Do_11c = Do_11a + Do_11b
    Do_11c_right = Do_11c - Do_11a
    Do_11c_lo1 = (product_rest(D1_10, step_1, Do_11a, Do_11c - Do_11c_right)
        + product_rest(D1_12, step_9, Do_11b, Do_11c_right))
    Do_11d = D1_11 * exp_diagonal1
    Do_11 = Do_11c + Do_11d
    Do_11_right = Do_11 - Do_11c
    Do_11_lo2 = (Do_11c - (Do_11 - Do_11_right)
        + product_rest(D1_11, exp_diagonal1, Do_11d, Do_11_right) + D1_11 * exp_diagonal1_lo)
    Do_12a = D1_10 * step_2
    Do_12b = D1_11 * step_6
    Do_12c = Do_12a + Do_12b
    Do_12c_right = Do_12c - Do_12a
    Do_12c_lo1 = (product_rest(D1_10, step_2, Do_12a, Do_12c - Do_12c_right)
        + product_rest(D1_11, step_6, Do_12b, Do_12c_right))
    Do_12d = D1_12 * exp_diagonal2
    Do_12 = Do_12c + Do_12d
    Do_12_right = Do_12 - Do_12c
    Do_12_lo2 = (Do_12c - (Do_12 - Do_12_right)
        + product_rest(D1_12, exp_diagonal2, Do_12d, Do_12_right) + D1_12 * exp_diagonal2_lo)
    Do_13a = D1_10 * step_3
    Do_13b = D1_11 * step_7
    Do_13c = Do_13a + Do_13b
    Do_13c_right = Do_13c - Do_13a
    Do_13c_lo1 = (product_rest(D1_10, step_3, Do_13a, Do_13c - Do_13c_right)
        + product_rest(D1_11, step_7, Do_13b, Do_13c_right))
    Do_13d = D1_12 * step_11
    Do_13e = Do_13c + Do_13d
    Do_13e_right = Do_13e - Do_13c
    Do_13e_lo2 = (Do_13c - (Do_13e - Do_13e_right)
        + product_rest(D1_12, step_11, Do_13d, Do_13e_right) + D1_12 * step_11_lo)
    Do_13 = Do_13e + D1_13
    Do_13_right = Do_13 - Do_13e
    Do_20a = D1_20 * exp_diagonal0
    Do_20b = D1_21 * step_4
    Do_20c = D1_22 * step_8
    Do_20d = Do_20b + Do_20c
    Do_20d_right = Do_20d - Do_20b
    Do_20d_lo1 = (product_rest(D1_21, step_4, Do_20b, Do_20d - Do_20d_right)
        + product_rest(D1_22, step_8, Do_20c, Do_20d_right))
    Do_20 = Do_20a + Do_20d
    Do_20_right = Do_20 - Do_20a
    Do_20_lo1 = (product_rest(D1_20, exp_diagonal0, Do_20a, Do_20 - Do_20_right)
        + (Do_20d - Do_20_right))
    Do_21a = D1_20 * step_1
    Do_21b = D1_22 * step_9
    Do_21c = Do_21a + Do_21b
    Do_21c_right = Do_21c - Do_21a
    Do_21c_lo1 = (product_rest(D1_20, step_1, Do_21a, Do_21c - Do_21c_right)
        + product_rest(D1_22, step_9, Do_21b, Do_21c_right))
    Do_21d = D1_21 * exp_diagonal1
    Do_21 = Do_21c + Do_21d
    Do_21_right = Do_21 - Do_21c
    Do_21_lo2 = (Do_21c - (Do_21 - Do_21_right)
        + product_rest(D1_21, exp_diagonal1, Do_21d, Do_21_right) + D1_21 * exp_diagonal1_lo)
    Do_22a = D1_20 * step_2
    Do_22b = D1_21 * step_6
    Do_22c = Do_22a + Do_22b
    Do_22c_right = Do_22c - Do_22a
    Do_22c_lo1 = (product_rest(D1_20, step_2, Do_22a, Do_22c - Do_22c_right)
        + product_rest(D1_21, step_6, Do_22b, Do_22c_right))
    Do_22d = D1_22 * exp_diagonal2
    Do_22 = Do_22c + Do_22d
    Do_22_right = Do_22 - Do_22c
    Do_22_lo2 = (Do_22c - (Do_22 - Do_22_right)
        + product_rest(D1_22, exp_diagonal2, Do_22d, Do_22_right) + D1_22 * exp_diagonal2_lo)
    Do_23a = D1_20 * step_3
    Do_23b = D1_21 * step_7
    Do_23c = Do_23a + Do_23b
    Do_23c_right = Do_23c - Do_23a
    Do_23c_lo1 = (product_rest(D1_20, step_3, Do_23a, Do_23c - Do_23c_right)
        + product_rest(D1_21, step_7, Do_23b, Do_23c_right))
    Do_23d = D1_22 * step_11
    Do_23e = Do_23c + Do_23d
    Do_23e_right = Do_23e - Do_23c
    Do_23e_lo2 = (Do_23c - (Do_23e - Do_23e_right)
        + product_rest(D1_22, step_11, Do_23d, Do_23e_right) + D1_22 * step_11_lo)
    Do_23 = Do_23e + D1_23
    Do_23_right = Do_23 - Do_23e
    Do_00_rounded = (Do_00
        + (Do_00_lo1 + (Do_00d_lo1 + (D1_01 * step_4_lo + D1_02 * step_8_lo)) + D1_00
        * exp_diagonal0_lo))
    Do_01_rounded = Do_01 + (Do_01_lo2 + (Do_01c_lo1 + (D1_00 * step_1_lo + D1_02 * step_9_lo)))
    Do_02_rounded = Do_02 + (Do_02_lo2 + (Do_02c_lo1 + (D1_00 * step_2_lo + D1_01 * step_6_lo)))
    Do_03_lo = (Do_03e - (Do_03 - Do_03_right) + (D1_03 - Do_03_right)
        + (Do_03e_lo2 + (Do_03c_lo1 + (D1_00 * step_3_lo + D1_01 * step_7_lo))))
    Do_03_rounded = Do_03 + Do_03_lo
    Do_10_rounded = (Do_10
        + (Do_10_lo1 + (Do_10d_lo1 + (D1_11 * step_4_lo + D1_12 * step_8_lo)) + D1_10
        * exp_diagonal0_lo))
    Do_11_rounded = Do_11 + (Do_11_lo2 + (Do_11c_lo1 + (D1_10 * step_1_lo + D1_12 * step_9_lo)))
    Do_12_rounded = Do_12 + (Do_12_lo2 + (Do_12c_lo1 + (D1_10 * step_2_lo + D1_11 * step_6_lo)))
    Do_13_lo = (Do_13e - (Do_13 - Do_13_right) + (D1_13 - Do_13_right)
        + (Do_13e_lo2 + (Do_13c_lo1 + (D1_10 * step_3_lo + D1_11 * step_7_lo))))
    Do_13_rounded = Do_13 + Do_13_lo
    Do_20_rounded = (Do_20
        + (Do_20_lo1 + (Do_20d_lo1 + (D1_21 * step_4_lo + D1_22 * step_8_lo)) + D1_20
        * exp_diagonal0_lo))
    Do_21_rounded = Do_21 + (Do_21_lo2 + (Do_21c_lo1 + (D1_20 * step_1_lo + D1_22 * step_9_lo)))
    Do_22_rounded = Do_22 + (Do_22_lo2 + (Do_22c_lo1 + (D1_20 * step_2_lo + D1_21 * step_6_lo)))
    Do_23_lo = (Do_23e - (Do_23 - Do_23_right) + (D1_23 - Do_23_right)
        + (Do_23e_lo2 + (Do_23c_lo1 + (D1_20 * step_3_lo + D1_21 * step_7_lo))))
    Do_23_rounded = Do_23 + Do_23_lo
    Do_00_final = where(Do_00_rounded == Do_00_rounded, Do_00_rounded, Do_00)
    Do_01_final = where(Do_01_rounded == Do_01_rounded, Do_01_rounded, Do_01)
    Do_02_final = where(Do_02_rounded == Do_02_rounded, Do_02_rounded, Do_02)
    Do_03_final = where(Do_03_rounded == Do_03_rounded, Do_03_rounded, Do_03)
    Do_10_final = where(Do_10_rounded == Do_10_rounded, Do_10_rounded, Do_10)
    Do_11_final = where(Do_11_rounded == Do_11_rounded, Do_11_rounded, Do_11)
    Do_12_final = where(Do_12_rounded == Do_12_rounded, Do_12_rounded, Do_12)
    Do_13_final = where(Do_13_rounded == Do_13_rounded, Do_13_rounded, Do_13)
    Do_20_final = where(Do_20_rounded == Do_20_rounded, Do_20_rounded, Do_20)
    Do_21_final = where(Do_21_rounded == Do_21_rounded, Do_21_rounded, Do_21)
    Do_22_final = where(Do_22_rounded == Do_22_rounded, Do_22_rounded, Do_22)
    Do_23_final = where(Do_23_rounded == Do_23_rounded, Do_23_rounded, Do_23)
    return (Do_00_final, Do_01_final, Do_02_final, Do_03_final, Do_10_final, Do_11_final,
        Do_12_final, Do_13_final, Do_20_final, Do_21_final, Do_22_final, Do_23_final)
