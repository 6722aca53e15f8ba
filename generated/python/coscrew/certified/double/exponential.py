# Made by `coscrew generate`; changes are overwritten.
# SPDX-License-Identifier: MIT
# coscrew 0.2.0.  Copyright (c) 2026 The coscrew authors.
"""Exponentials and logarithms of rotations and displacements, their Jacobians, interpolation.

In double precision, certified tier.
"""

from coscrew import _elementary_double as elementary
from numpy import absolute, float64 as real, sqrt, where
from coscrew._exact import product_error, product_rest
from coscrew._kernel import double_kernel as kernel
from numpy import errstate


@kernel("(3)->(3,3),(3,3)")
@errstate(all="ignore")
def SO3_exp(v, *, c1=268435456, c2=1.8051943758648296e-276, c3=6.703903964971299e+153,
        c4=3.7291703656001034e-155, c5=2.6815615859885194e+154, c6=3.229399894985818e-30,
        c7=140737488355328, c8=2.0056767005853705e+29, c9=5.7192432555642225e-30, c10=5e-324,
        c11=5.762046184631807e+28, c12=1.789728954546449e-29, c13=9.25185853854297e-18,
        c14=2290649224.7000003, c15=8.201505264386605e-28, c16=2.755262189115544e-29,
        c17=1.2206826306780646e+27, c18=8.20625268358031e-28, c19=8.21136891741797e-28,
        c20=1.0551017099379094e-29, c21=1.0000000000000009, c22=8.334199917267314e-28,
        c23=8.316572842510914e-28):
    """R = exp v~ = I + sin θ/θ v~ + (1 - cos θ)/θ^2 v~^2, θ = |v|; |error of R| <= R_bound unless
    inf or NaN.

    (3)->(3,3),(3,3).  v: vector; R, R_bound: rotation or other 3×3 matrix.
    336 mul, 494 add, 17 product error, 22 product rest, 12 div, 3 sqrt, 51 abs, 14 less, 1
    equal, 29 select.
    """
    v_0, v_1, v_2 = v
    size_0 = absolute(v_0)
    size_1 = absolute(v_1)
    size_2 = absolute(v_2)
    sizes = size_0 + size_1 + size_2
    grid = sizes * c1
    shifted_0 = v_0 + grid
    shifted_1 = v_1 + grid
    shifted_2 = v_2 + grid
    high_0 = shifted_0 - grid
    high_1 = shifted_1 - grid
    high_2 = shifted_2 - grid
    low_0 = v_0 - high_0
    low_1 = v_1 - high_1
    low_2 = v_2 - high_2
    sum_0 = v_0 + high_0
    sum_1 = v_1 + high_1
    sum_2 = v_2 + high_2
    squares = high_0 * high_0 + high_1 * high_1 + high_2 * high_2
    cross = low_0 * sum_0 + low_1 * sum_1 + low_2 * sum_2
    x = squares + cross
    theta_b = x < 1
    theta = where(theta_b, 1, sqrt(x))
    theta_shifted = grid + theta
    theta_high = theta_shifted - grid
    theta_low = theta - theta_high
    theta_sum = theta + theta_high
    cross_rest = cross - theta_low * theta_sum
    exact = squares - theta_high * theta_high
    residual = cross_rest + exact
    small = 0.5 * residual / theta
    delta = where(absolute(small) < 0.0078125, small, 0)
    far_sine_a, far_cosine_a = elementary.sincos(theta)
    far_sine = where(theta_b, 1, far_sine_a)
    far_cosine = where(theta_b, 0, far_cosine_a)
    sine = delta * far_cosine + far_sine
    cosine = far_cosine - delta * far_sine
    far_x = where(theta_b, 1, x)
    closed1 = sine / theta
    versine = 1 - cosine
    closed2 = versine / far_x
    g1h = (x
        * (x * (x * (6.446950284384474e-26 * x - 3.868170170630684e-23) + 1.9572941063391263e-20)
        - 8.22063524662433e-18) + 2.8114572543455206e-15)
    g1q = (x
        * (x
        * (x * (x * (x * g1h - 7.647163731819816e-13) + 1.6059043836821613e-10)
        - 2.505210838544172e-08) + 2.7557319223985893e-06))
    g1 = where(theta_b,
        x * (x * (x * (g1q - 0.0001984126984126984) + 0.008333333333333333) - 0.16666666666666666) +
            1,
        closed1)
    g2h = (x
        * (x * (x * (2.4795962632247976e-27 * x - 1.6117375710961184e-24) + 8.896791392450574e-22)
        - 4.110317623312165e-19) + 1.5619206968586225e-16)
    g2q = (x
        * (x
        * (x * (x * (x * g2h - 4.779477332387385e-14) + 1.1470745597729725e-11)
        - 2.08767569878681e-09) + 2.755731922398589e-07))
    g2 = where(theta_b,
        x * (x * (x * (g2q - 2.48015873015873e-05) + 0.001388888888888889) - 0.041666666666666664) +
            0.5,
        closed2)
    g0 = where(theta_b, 1 - x * g2, cosine)
    beta_v_0 = v_0 * g2
    beta_v_1 = v_1 * g2
    beta_v_2 = v_2 * g2
    m_0 = v_0 * beta_v_0
    m_1 = v_1 * beta_v_1
    m_2 = v_2 * beta_v_2
    m_3 = v_1 * beta_v_0
    m_4 = v_2 * beta_v_0
    m_5 = v_2 * beta_v_1
    others_0 = m_1 + m_2
    others_1 = m_0 + m_2
    others_2 = m_0 + m_1
    diagonal0 = where(m_0 < others_0, g0 + m_0, 1 - others_0)
    diagonal1 = where(m_1 < others_1, g0 + m_1, 1 - others_1)
    diagonal2 = where(m_2 < others_2, g0 + m_2, 1 - others_2)
    alpha_v_0 = v_0 * g1
    alpha_v_1 = v_1 * g1
    alpha_v_2 = v_2 * g1
    R_01 = m_3 - alpha_v_2
    R_02 = m_4 + alpha_v_1
    R_10 = m_3 + alpha_v_2
    R_12 = m_5 - alpha_v_0
    R_20 = m_4 - alpha_v_1
    R_21 = m_5 + alpha_v_0
    halved_0 = 0.5 * v_0
    halved_size_1 = absolute(v_0)
    halved_1 = 0.5 * v_1
    halved_size_3 = absolute(v_1)
    halved_2 = 0.5 * v_2
    halved_size_5 = absolute(v_2)
    h_size_0 = absolute(halved_0)
    h_size_1 = absolute(halved_1)
    h_size_2 = absolute(halved_2)
    h_largest1 = where(h_size_0 < h_size_1, h_size_1, h_size_0)
    h_largest2 = where(h_largest1 < h_size_2, h_size_2, h_largest1)
    s_a = c3 < h_largest2
    s = where(s_a, real(c4), real(1))
    s_size_1 = where(s_a, real(c4), real(1))
    reduced_0 = halved_0 * s
    reduced_1 = halved_1 * s
    reduced_2 = halved_2 * s
    up_a = s < 1
    up = where(up_a, real(c5), real(1))
    reduced_length_a = reduced_0 * reduced_0
    reduced_length_a_padded_1 = c2 + (c2 + 0.5 * halved_size_1) * s_size_1
    reduced_length_b = reduced_1 * reduced_1
    reduced_length_b_padded_1 = c2 + (c2 + 0.5 * halved_size_3) * s_size_1
    reduced_length_c = reduced_length_a + reduced_length_b
    reduced_length_c_right_1 = reduced_length_c - reduced_length_a
    reduced_length_c_left_rest_1 = product_rest(reduced_0, reduced_0, reduced_length_a,
        reduced_length_c - reduced_length_c_right_1)
    reduced_length_d = reduced_2 * reduced_2
    reduced_length_d_padded_1 = c2 + (c2 + 0.5 * halved_size_5) * s_size_1
    reduced_length_e = reduced_length_c + reduced_length_d
    reduced_length_e_right_1 = reduced_length_e - reduced_length_c
    reduced_length_e_right_rest_1 = product_rest(reduced_2, reduced_2, reduced_length_d,
        reduced_length_e_right_1)
    reduced_length_c_lo = (reduced_length_c_left_rest_1
        + product_rest(reduced_1, reduced_1, reduced_length_b, reduced_length_c_right_1))
    reduced_length_e_lo = (reduced_length_c - (reduced_length_e - reduced_length_e_right_1)
        + reduced_length_e_right_rest_1 + reduced_length_c_lo)
    reduced_length_c_size_1 = (reduced_length_a_padded_1 * reduced_length_a_padded_1
        + reduced_length_b_padded_1 * reduced_length_b_padded_1)
    reduced_length = sqrt(reduced_length_e)
    reduced_length_product_1 = reduced_length * reduced_length
    reduced_length_exact_1 = (reduced_length_e - reduced_length_product_1
        - product_error(reduced_length, reduced_length, reduced_length_product_1))
    reduced_length_lo = ((reduced_length_exact_1 + reduced_length_e_lo)
        / where(reduced_length == 0, 1, reduced_length + reduced_length))
    reduced_length_padded_1 = (c2
        + (reduced_length_c_size_1 + reduced_length_d_padded_1 * reduced_length_d_padded_1))
    reduced_length_bound_1 = absolute(reduced_length_e_lo) + c6 * reduced_length_padded_1
    reduced_length_size_4 = ((absolute(reduced_length_e) + c7 * reduced_length_bound_1)
        * (reduced_length_padded_1 / reduced_length / reduced_length_e))
    reduced_length_size_8 = c8 * (sqrt(reduced_length_bound_1) + absolute(reduced_length_lo))
    half_angle = reduced_length * up
    half_angle_lo = (reduced_length - half_angle * (1 / up) + reduced_length_lo) * up
    half_angle_padded_1 = (c2
        + (reduced_length
        + where(4 * reduced_length_bound_1
        < reduced_length_e, reduced_length_size_4, reduced_length_size_8)))
    half_angle_size_1 = half_angle_padded_1 * where(up_a, real(c5), real(1))
    y = half_angle * half_angle
    y_padded_1 = c2 + half_angle_size_1
    y_bound_1 = absolute(half_angle_lo) + c9 * y_padded_1
    y_size_2 = y_padded_1 * (absolute(half_angle) + c7 * y_bound_1)
    fine_sine, c = elementary.sincos(half_angle)
    fine_sine_own_error_1, c_own_error_1 = elementary.sincos_error(half_angle, fine_sine, c)
    fine_sine_half_1 = half_angle_lo * 0.5
    fine_sine_half_sin_1, fine_sine_half_cos_1 = elementary.sincos(fine_sine_half_1)
    fine_sine_twice_1 = fine_sine_half_sin_1 + fine_sine_half_sin_1
    fine_sine_size_1 = 1 + y_padded_1
    c_lo = (c_own_error_1 - (fine_sine_half_cos_1 * fine_sine + fine_sine_half_sin_1 * c)
        * fine_sine_twice_1)
    sinc_divisor_a = half_angle < 1.4901161193847656e-08
    sinc_divisor = where(sinc_divisor_a, 1.4901161193847656e-08, half_angle)
    sinc_divisor_lo = where(sinc_divisor_a, 0, half_angle_lo)
    sinc_divisor_size_5 = y_bound_1 < c10 + absolute(half_angle - 1.4901161193847656e-08)
    sinc_divisor_size_10 = (c11
        * where(sinc_divisor_size_5, 0, absolute(1.4901161193847656e-08 - half_angle) + y_bound_1))
    sinc_quotient = fine_sine / sinc_divisor
    sinc_quotient_product_1 = sinc_quotient * sinc_divisor
    sinc_quotient_exact_1 = (fine_sine - sinc_quotient_product_1
        - product_error(sinc_quotient, sinc_divisor, sinc_quotient_product_1))
    fine_sine_lo = (fine_sine_own_error_1
        + (fine_sine_half_cos_1 * c - fine_sine_half_sin_1 * fine_sine) * fine_sine_twice_1)
    sinc_quotient_lo = ((sinc_quotient_exact_1 + fine_sine_lo - sinc_quotient * sinc_divisor_lo)
        / sinc_divisor)
    sinc_quotient_padded_2 = (c2
        + (where(sinc_divisor_a, 1.4901161193847656e-08, half_angle_size_1) + sinc_divisor_size_10))
    sinc_quotient_size_1 = absolute(sinc_quotient)
    sinc_quotient_size_2 = absolute(sinc_divisor)
    sinc_quotient_bound_1 = absolute(sinc_divisor_lo) + c12 * sinc_quotient_padded_2
    sinc_quotient_size_7 = where(4 * sinc_quotient_bound_1 < sinc_quotient_size_2,
        sinc_quotient_size_2, 0)
    sinc_quotient_size_8 = ((c2 + fine_sine_size_1 + sinc_quotient_padded_2 * sinc_quotient_size_1)
        / sinc_quotient_size_7)
    sinc_quotient_size_11 = (sinc_quotient_size_1
        + (sinc_quotient_size_2 + c7 * sinc_quotient_bound_1) * sinc_quotient_size_8
        / sinc_quotient_size_2)
    sinc_a = 0.16666666666666666 * y
    sinc_a_cross2_1 = (0.16666666666666666
        * (product_error(half_angle, half_angle, y)
        + (half_angle_lo * half_angle + half_angle * half_angle_lo)))
    sinc_b = 1 - sinc_a
    sinc_b_right_1 = 1 - sinc_b
    sinc_b_lo = (1 - (sinc_b + sinc_b_right_1)
        - product_rest(0.16666666666666666, y, sinc_a, sinc_b_right_1)
        - (c13 * y + sinc_a_cross2_1))
    sinc_b_size_1 = 1 + c14 * (y_size_2 + y_size_2)
    sinc = where(sinc_divisor_a, sinc_b, sinc_quotient)
    sinc_lo = where(sinc_divisor_a, sinc_b_lo, sinc_quotient_lo)
    sinc_size_4 = (absolute(sinc_b_lo) + c15 * (c2 + sinc_b_size_1)
        + absolute(sinc_b - sinc_quotient))
    sinc_size_7 = (c17
        * where(sinc_divisor_size_5, 0, absolute(sinc_quotient_lo) + c16
        * (c2 + sinc_quotient_size_11) + sinc_size_4))
    turning_0 = v_0 * sinc
    turning_padded_1 = (c2
        + (where(sinc_divisor_a, sinc_b_size_1, sinc_quotient_size_11) + sinc_size_7))
    turning_size_1 = halved_size_1 * turning_padded_1
    turning_1 = v_1 * sinc
    turning_size_2 = halved_size_3 * turning_padded_1
    turning_2 = v_2 * sinc
    turning_size_3 = halved_size_5 * turning_padded_1
    turning_lo_1 = product_error(v_0, sinc, turning_0) + v_0 * sinc_lo
    fine_beta_v_0 = 0.5 * turning_0
    fine_beta_v_cross2_1 = 0.5 * turning_lo_1
    turning_lo_2 = product_error(v_1, sinc, turning_1) + v_1 * sinc_lo
    fine_beta_v_1 = 0.5 * turning_1
    fine_beta_v_cross2_2 = 0.5 * turning_lo_2
    turning_lo_3 = product_error(v_2, sinc, turning_2) + v_2 * sinc_lo
    fine_beta_v_2 = 0.5 * turning_2
    fine_beta_v_cross2_3 = 0.5 * turning_lo_3
    fine_m_0 = turning_0 * fine_beta_v_0
    fine_m_cross_1 = turning_lo_1 * fine_beta_v_0 + turning_0 * fine_beta_v_cross2_1
    fine_m_padded_1 = c2 + turning_size_1
    fine_m_padded_2 = c2 + 0.5 * turning_size_1
    fine_m_reach_1 = absolute(turning_0) + c7 * (absolute(turning_lo_1) + c18 * fine_m_padded_1)
    fine_m_reach_2 = (absolute(fine_beta_v_0) + c7
        * (absolute(fine_beta_v_cross2_1) + c19 * fine_m_padded_2))
    fine_m_size_5 = fine_m_padded_2 * fine_m_reach_1 + fine_m_padded_1 * fine_m_reach_2
    fine_m_1 = turning_1 * fine_beta_v_1
    fine_m_cross_2 = turning_lo_2 * fine_beta_v_1 + turning_1 * fine_beta_v_cross2_2
    fine_m_padded_3 = c2 + turning_size_2
    fine_m_padded_4 = c2 + 0.5 * turning_size_2
    fine_m_reach_3 = absolute(turning_1) + c7 * (absolute(turning_lo_2) + c18 * fine_m_padded_3)
    fine_m_reach_4 = (absolute(fine_beta_v_1) + c7
        * (absolute(fine_beta_v_cross2_2) + c19 * fine_m_padded_4))
    fine_m_size_10 = fine_m_padded_4 * fine_m_reach_3 + fine_m_padded_3 * fine_m_reach_4
    fine_m_2 = turning_2 * fine_beta_v_2
    fine_m_cross_3 = turning_lo_3 * fine_beta_v_2 + turning_2 * fine_beta_v_cross2_3
    fine_m_padded_5 = c2 + turning_size_3
    fine_m_padded_6 = c2 + 0.5 * turning_size_3
    fine_m_reach_5 = absolute(turning_2) + c7 * (absolute(turning_lo_3) + c18 * fine_m_padded_5)
    fine_m_size_14 = (fine_m_padded_5
        * (absolute(fine_beta_v_2) + c7 * (absolute(fine_beta_v_cross2_3) + c19 * fine_m_padded_6)))
    fine_m_size_15 = fine_m_padded_6 * fine_m_reach_5 + fine_m_size_14
    fine_m_3 = turning_1 * fine_beta_v_0
    fine_m_cross_4 = turning_lo_2 * fine_beta_v_0 + turning_1 * fine_beta_v_cross2_1
    fine_m_4 = turning_2 * fine_beta_v_0
    fine_m_cross_5 = turning_lo_3 * fine_beta_v_0 + turning_2 * fine_beta_v_cross2_1
    fine_m_5 = turning_2 * fine_beta_v_1
    fine_m_cross_6 = turning_lo_3 * fine_beta_v_1 + turning_2 * fine_beta_v_cross2_2
    fine_others_0 = fine_m_1 + fine_m_2
    fine_others_right_1 = fine_others_0 - fine_m_1
    fine_others_left_rest_1 = product_rest(turning_1, fine_beta_v_1, fine_m_1,
        fine_others_0 - fine_others_right_1)
    fine_others_1 = fine_m_0 + fine_m_2
    fine_others_right_2 = fine_others_1 - fine_m_0
    fine_others_left_rest_2 = product_rest(turning_0, fine_beta_v_0, fine_m_0,
        fine_others_1 - fine_others_right_2)
    fine_others_2 = fine_m_0 + fine_m_1
    fine_others_right_3 = fine_others_2 - fine_m_0
    fine_others_left_rest_3 = product_rest(turning_0, fine_beta_v_0, fine_m_0,
        fine_others_2 - fine_others_right_3)
    fine_alpha_v_0 = c * turning_0
    fine_alpha_v_cross_1 = c_lo * turning_0 + c * turning_lo_1
    fine_alpha_v_reach_1 = absolute(c) + c7 * (absolute(c_lo) + c20 * fine_sine_size_1)
    fine_alpha_v_1 = c * turning_1
    fine_alpha_v_cross_2 = c_lo * turning_1 + c * turning_lo_2
    fine_alpha_v_2 = c * turning_2
    fine_alpha_v_cross_3 = c_lo * turning_2 + c * turning_lo_3
    R_00 = 1 - fine_others_0
    R_right_1 = 1 - R_00
    fine_others_lo_1 = (fine_others_left_rest_1
        + product_rest(turning_2, fine_beta_v_2, fine_m_2, fine_others_right_1)
        + (fine_m_cross_2 + fine_m_cross_3))
    fine_R_01 = fine_m_3 - fine_alpha_v_2
    fine_R_right_1 = fine_m_3 - fine_R_01
    fine_R_left_rest_1 = product_rest(turning_1, fine_beta_v_0, fine_m_3,
        fine_R_01 + fine_R_right_1)
    fine_alpha_v_size_10 = (fine_alpha_v_reach_1 * fine_m_padded_5 + fine_m_reach_5
        * fine_sine_size_1)
    fine_R_02 = fine_m_4 + fine_alpha_v_1
    fine_R_right_2 = fine_R_02 - fine_m_4
    fine_R_left_rest_2 = product_rest(turning_2, fine_beta_v_0, fine_m_4,
        fine_R_02 - fine_R_right_2)
    fine_alpha_v_size_7 = fine_alpha_v_reach_1 * fine_m_padded_3 + fine_m_reach_3 * fine_sine_size_1
    fine_R_10 = fine_m_3 + fine_alpha_v_2
    fine_R_right_3 = fine_R_10 - fine_m_3
    fine_R_left_rest_3 = product_rest(turning_1, fine_beta_v_0, fine_m_3,
        fine_R_10 - fine_R_right_3)
    R_11 = 1 - fine_others_1
    R_right_2 = 1 - R_11
    fine_others_lo_2 = (fine_others_left_rest_2
        + product_rest(turning_2, fine_beta_v_2, fine_m_2, fine_others_right_2)
        + (fine_m_cross_1 + fine_m_cross_3))
    fine_R_12 = fine_m_5 - fine_alpha_v_0
    fine_R_right_4 = fine_m_5 - fine_R_12
    fine_R_left_rest_4 = product_rest(turning_2, fine_beta_v_1, fine_m_5,
        fine_R_12 + fine_R_right_4)
    fine_alpha_v_size_4 = fine_alpha_v_reach_1 * fine_m_padded_1 + fine_m_reach_1 * fine_sine_size_1
    fine_R_20 = fine_m_4 - fine_alpha_v_1
    fine_R_right_5 = fine_m_4 - fine_R_20
    fine_R_left_rest_5 = product_rest(turning_2, fine_beta_v_0, fine_m_4,
        fine_R_20 + fine_R_right_5)
    fine_R_21 = fine_m_5 + fine_alpha_v_0
    fine_R_right_6 = fine_R_21 - fine_m_5
    fine_R_left_rest_6 = product_rest(turning_2, fine_beta_v_1, fine_m_5,
        fine_R_21 - fine_R_right_6)
    R_22 = 1 - fine_others_2
    R_right_3 = 1 - R_22
    fine_others_lo_3 = (fine_others_left_rest_3
        + product_rest(turning_1, fine_beta_v_1, fine_m_1, fine_others_right_3)
        + (fine_m_cross_1 + fine_m_cross_2))
    diagonal0_error_2 = (c21
        * absolute(1 - (R_00 + R_right_1) - (fine_others_0 - R_right_1) - fine_others_lo_1
        + (R_00 - diagonal0)))
    fine_R_lo_1 = (fine_R_left_rest_1 - product_rest(c, turning_2, fine_alpha_v_2, fine_R_right_1)
        + (fine_m_cross_4 - fine_alpha_v_cross_3))
    R_rest_1 = (c23
        * (c2
        + (fine_alpha_v_size_10
        + (fine_m_padded_2 * fine_m_reach_3 + fine_m_padded_3 * fine_m_reach_2))))
    fine_R_lo_2 = (fine_R_left_rest_2 + product_rest(c, turning_1, fine_alpha_v_1, fine_R_right_2)
        + (fine_m_cross_5 + fine_alpha_v_cross_2))
    R_rest_2 = (c23
        * (c2
        + (fine_alpha_v_size_7
        + (fine_m_padded_2 * fine_m_reach_5 + fine_m_padded_5 * fine_m_reach_2))))
    fine_R_lo_3 = (fine_R_left_rest_3 + product_rest(c, turning_2, fine_alpha_v_2, fine_R_right_3)
        + (fine_m_cross_4 + fine_alpha_v_cross_3))
    diagonal1_error_2 = (c21
        * absolute(1 - (R_11 + R_right_2) - (fine_others_1 - R_right_2) - fine_others_lo_2
        + (R_11 - diagonal1)))
    fine_R_lo_4 = (fine_R_left_rest_4 - product_rest(c, turning_0, fine_alpha_v_0, fine_R_right_4)
        + (fine_m_cross_6 - fine_alpha_v_cross_1))
    R_rest_3 = (c23
        * (c2
        + (fine_alpha_v_size_4
        + (fine_m_padded_4 * fine_m_reach_5 + fine_m_padded_5 * fine_m_reach_4))))
    fine_R_lo_5 = (fine_R_left_rest_5 - product_rest(c, turning_1, fine_alpha_v_1, fine_R_right_5)
        + (fine_m_cross_5 - fine_alpha_v_cross_2))
    fine_R_lo_6 = (fine_R_left_rest_6 + product_rest(c, turning_0, fine_alpha_v_0, fine_R_right_6)
        + (fine_m_cross_6 + fine_alpha_v_cross_1))
    diagonal2_error_2 = (c21
        * absolute(1 - (R_22 + R_right_3) - (fine_others_2 - R_right_3) - fine_others_lo_3
        + (R_22 - diagonal2)))
    diagonal0_bound_1 = diagonal0_error_2 + c22 * (c2 + (1 + (fine_m_size_10 + fine_m_size_15)))
    R_bound_1 = c21 * absolute(fine_R_01 - R_01 + fine_R_lo_1) + R_rest_1
    R_bound_2 = c21 * absolute(fine_R_02 - R_02 + fine_R_lo_2) + R_rest_2
    R_bound_3 = c21 * absolute(fine_R_10 - R_10 + fine_R_lo_3) + R_rest_1
    diagonal1_bound_1 = diagonal1_error_2 + c22 * (c2 + (1 + (fine_m_size_15 + fine_m_size_5)))
    R_bound_4 = c21 * absolute(fine_R_12 - R_12 + fine_R_lo_4) + R_rest_3
    R_bound_5 = c21 * absolute(fine_R_20 - R_20 + fine_R_lo_5) + R_rest_2
    R_bound_6 = c21 * absolute(fine_R_21 - R_21 + fine_R_lo_6) + R_rest_3
    diagonal2_bound_1 = diagonal2_error_2 + c22 * (c2 + (1 + (fine_m_size_10 + fine_m_size_5)))
    return (diagonal0, R_01, R_02, R_10, diagonal1, R_12, R_20, R_21, diagonal2, diagonal0_bound_1,
        R_bound_1, R_bound_2, R_bound_3, diagonal1_bound_1, R_bound_4, R_bound_5, R_bound_6,
        diagonal2_bound_1)


@kernel("(3,3)->(3),(3)")
@errstate(all="ignore")
def SO3_log(R, *, c1=1.8051943758648296e-276, c2=1.6023738312796216e-30, c3=1.5845630613906556e+29,
        c4=6.508104019725916e-30, c5=6.703903964971299e+153, c6=3.7291703656001034e-155,
        c7=1.3093562431584567e+151, c8=1.955159272639747e-149, c9=1.0715086071862673e+301,
        c10=6.705320021857442e-30, c11=140737488355328, c12=1.150011758590251e-29,
        c13=1.1418664350501995e+29, c14=2.6815615859885194e+154, c15=7.637340908749012e-152,
        c16=9.332636185032189e-302, c17=9.423194733875307e-30, c18=4.527322338646221e+28, c19=5e-324,
        c20=6.338250583290453e+28, c21=1.6270263928446146e-29, c22=3.316915129670074e-29,
        c23=3.5202936421278755e-29, c24=1.0715086071862673e+301):
    """vo with exp vo~ = R, |vo| <= π; if R is not quite a rotation, its defect carries over to vo;
    |error of vo| <= vo_bound unless inf or NaN.

    (3,3)->(3),(3).  R: rotation or other 3×3 matrix; vo, vo_bound: vector.
    244 mul, 466 add, 26 product error, 3 product rest, 16 div, 2 sqrt, 10 neg, 72 abs, 4
    copysign, 41 less, 7 equal, 107 select.
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
    upper_lo_1 = where(upper_0b, upper_0a_lo, column_lo_1)
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
    upper_lo_2 = where(upper_0b, upper_1a_lo, column_lo_2)
    upper_rest_3 = c2 * (c1 + column_size_2)
    upper_size_15 = where(upper_size_3, 0,
        absolute(column_lo_2) + upper_rest_3 + (absolute(upper_1a_lo) + upper_rest_3 +
            absolute(upper_1a - column_1)))
    upper_2a = -column_2
    upper_2a_lo = -column_lo_3
    upper_2 = where(upper_0b, upper_2a, column_2)
    upper_lo_3 = where(upper_0b, upper_2a_lo, column_lo_3)
    upper_rest_4 = c2 * (c1 + column_size_3)
    upper_size_22 = where(upper_size_3, 0,
        absolute(column_lo_3) + upper_rest_4 + (absolute(upper_2a_lo) + upper_rest_4 +
            absolute(upper_2a - column_2)))
    upper_3a = -column_3
    upper_3a_lo = -column_lo_4
    upper_3 = where(upper_0b, upper_3a, column_3)
    upper_lo_4 = where(upper_0b, upper_3a_lo, column_lo_4)
    v_s_size_0 = absolute(upper_0)
    v_s_size_padded_1 = c1 + (column_size_1 + c3 * upper_size_8)
    v_s_size_1 = absolute(upper_1)
    v_s_size_padded_2 = c1 + (column_size_2 + c3 * upper_size_15)
    v_s_size_2 = absolute(upper_2)
    v_s_size_padded_3 = c1 + (column_size_3 + c3 * upper_size_22)
    v_s_largest1 = where(v_s_size_0 < v_s_size_1, v_s_size_1, v_s_size_0)
    v_s_largest2 = where(v_s_largest1 < v_s_size_2, v_s_size_2, v_s_largest1)
    v_s_a = c5 < v_s_largest2
    v_s_c = v_s_largest2 < 256
    v_s_e = v_s_largest2 < c8
    v_s = where(v_s_e, c9, where(v_s_c, c7, where(v_s_a, real(c6), real(1))))
    v_s_size_3 = where(v_s_e, c9, where(v_s_c, c7, where(v_s_a, real(c6), real(1))))
    v_y_0 = upper_0 * v_s
    v_y_inverse_1 = 1 / v_s
    v_y_lo_1 = (upper_0 - v_y_0 * v_y_inverse_1 + upper_lo_1) * v_s
    v_y_1 = upper_1 * v_s
    v_y_lo_2 = (upper_1 - v_y_1 * v_y_inverse_1 + upper_lo_2) * v_s
    v_y_2 = upper_2 * v_s
    v_y_lo_3 = (upper_2 - v_y_2 * v_y_inverse_1 + upper_lo_3) * v_s
    v_n_a = v_y_0 * v_y_0
    v_n_a_padded_1 = c1 + v_s_size_3 * v_s_size_padded_1
    v_n_a_size_2 = (v_n_a_padded_1
        * (absolute(v_y_0) + c11 * (absolute(v_y_lo_1) + c10 * v_n_a_padded_1)))
    v_n_b = v_y_1 * v_y_1
    v_n_b_padded_1 = c1 + v_s_size_3 * v_s_size_padded_2
    v_n_b_size_2 = (v_n_b_padded_1
        * (absolute(v_y_1) + c11 * (absolute(v_y_lo_2) + c10 * v_n_b_padded_1)))
    v_n_c = v_n_a + v_n_b
    v_n_c_right_1 = v_n_c - v_n_a
    v_n_c_lo1_1 = (product_rest(v_y_0, v_y_0, v_n_a, v_n_c - v_n_c_right_1)
        + product_rest(v_y_1, v_y_1, v_n_b, v_n_c_right_1))
    v_n_d = v_y_2 * v_y_2
    v_n_d_padded_1 = c1 + v_s_size_3 * v_s_size_padded_3
    v_n_d_size_2 = (v_n_d_padded_1
        * (absolute(v_y_2) + c11 * (absolute(v_y_lo_3) + c10 * v_n_d_padded_1)))
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
    v_n_bound_1 = absolute(v_n_e_lo) + c12 * v_n_padded_1
    v_n_size_4 = (absolute(v_n_e) + c11 * v_n_bound_1) * (v_n_padded_1 / v_n / v_n_e)
    v_r_a = v_s < 1
    v_r_c = 1 < v_s
    v_r_e = c7 < v_s
    v_r = where(v_r_e, c16, where(v_r_c, c15, where(v_r_a, real(c14), real(1))))
    n = v_n * v_r
    n_lo = (v_n - n * (1 / v_r) + v_n_lo) * v_r
    n_padded_1 = (c1
        + (v_n
        + where(4 * v_n_bound_1 < v_n_e, v_n_size_4, c13 * (sqrt(v_n_bound_1) + absolute(v_n_lo)))))
    n_size_1 = n_padded_1 * where(v_r_e, c16, where(v_r_c, c15, where(v_r_a, real(c14), real(1))))
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
    half_padded_1 = c1 + n_size_1
    upper_size_31 = (column_size_4 + c3
        * where(upper_size_3, 0, upper_bound_1
        + (absolute(upper_3a_lo) + upper_rest_1 + absolute(upper_3a - column_3))))
    half_padded_2 = c1 + upper_size_31
    half_size_2 = absolute(n)
    half_size_3 = absolute(upper_3)
    half_size_5 = where(half_size_2 < half_size_3, half_size_3, half_size_2)
    half_bound_1 = absolute(n_lo) + c17 * half_padded_1
    half_bound_2 = absolute(upper_lo_4) + c4 * half_padded_2
    half_size_11 = (half_bound_2 + (c1 + half_bound_1)) / half_size_5
    half_size_13 = half_size_11 * half_size_11
    half_size_15 = 7 + absolute(half_lo)
    half_size_19 = where(half_bound_1 < half_size_2, half_size_13, where(half_bound_2 < upper_3,
        half_size_13, half_size_15))
    divisor_a = n == 0
    divisor = where(divisor_a, 1, n)
    divisor_lo = where(divisor_a, 0, n_lo)
    theta = 2 * half
    k = theta / divisor
    k_product_1 = k * divisor
    k_lo = ((theta - k_product_1 - product_error(k, divisor, k_product_1) + 2 * half_lo - k
        * divisor_lo) / divisor)
    k_padded_2 = (c1
        + (where(divisor_a, 1, n_size_1) + c20
        * where(half_bound_1 < c19 + absolute(n - 0), 0, absolute(1 - n) + half_bound_1)))
    k_size_1 = absolute(k)
    k_size_2 = absolute(divisor)
    k_padded_1 = (c1 + 2
        * (absolute(half) + (half_padded_1 + half_padded_2) / half_size_5 + c18
        * where(half_size_11 < 0.25, half_size_19, half_size_15)))
    k_bound_1 = absolute(divisor_lo) + c21 * k_padded_2
    vector_0 = upper_0 * k
    k_size_11 = (k_size_1 + (k_size_2 + c11 * k_bound_1)
        * ((k_padded_1 + k_padded_2 * k_size_1) / where(4 * k_bound_1 < k_size_2, k_size_2, 0))
        / k_size_2)
    vector_padded_1 = c1 + k_size_11
    vector_reach_2 = k_size_1 + c11 * (absolute(k_lo) + c22 * vector_padded_1)
    vector_1 = upper_1 * k
    vector_2 = upper_2 * k
    vector_size_4 = (vector_padded_1
        * (absolute(upper_0) + c11 * (absolute(upper_lo_1) + c4 * v_s_size_padded_1))
        + v_s_size_padded_1 * vector_reach_2)
    vector_size_8 = (vector_padded_1
        * (absolute(upper_1) + c11 * (absolute(upper_lo_2) + c4 * v_s_size_padded_2))
        + v_s_size_padded_2 * vector_reach_2)
    vector_size_12 = (vector_padded_1
        * (absolute(upper_2) + c11 * (absolute(upper_lo_3) + c4 * v_s_size_padded_3))
        + v_s_size_padded_3 * vector_reach_2)
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
    R_unless_equal = where(R_is_equal, real(0), real(c24))
    R_unless_rotation = where(R_is_less, 0, R_unless_equal)
    R_excess = R_unless_rotation * c24
    R_excess_0 = (absolute(product_error(upper_0, k, vector_0) + (upper_lo_1 * k + upper_0 * k_lo))
        + c23 * (c1 + vector_size_4) + R_excess)
    R_excess_1 = (absolute(product_error(upper_1, k, vector_1) + (upper_lo_2 * k + upper_1 * k_lo))
        + c23 * (c1 + vector_size_8) + R_excess)
    R_excess_2 = (absolute(product_error(upper_2, k, vector_2) + (upper_lo_3 * k + upper_2 * k_lo))
        + c23 * (c1 + vector_size_12) + R_excess)
    return (vector_0, vector_1, vector_2, R_excess_0, R_excess_1, R_excess_2)


@kernel("(3)->(3,3),(3,3)")
@errstate(all="ignore")
def SO3_leftJacobian(v, *, c1=268435456, c2=1.8051943758648296e-276, c3=2.5021685128863245e-30,
        c4=140737488355328, c5=2.567393169377981e+29, c6=4.240128211918887e-30,
        c7=9.054644677292507e+28, c8=1.1389183198259759e-29, c9=9.25185853854297e-18,
        c10=2290649224.7000003, c11=8.120831909935717e-28, c12=1.8842277118313698e-29,
        c13=1.2325982855554354e+27, c14=8.677471603123253e-30, c15=8.120832873841084e-28,
        c16=2.8103175390871538e-30, c17=5.28187582188787e+28, c18=1.9524315162482833e-29,
        c19=5.586290567888806e-51, c20=5.702613188320821e-10, c21=1.0498015412959506e-47,
        c22=8.12514599395154e-28, c23=1.4303150396787322e-45, c24=8.19207783918962e-28,
        c25=-1.9330404233703465e-42, c26=8.261228355723635e-28, c27=-8.843177655482344e-40,
        c28=8.332597543553583e-28, c29=-1.3643503830087908e-36, c30=8.406185404560257e-28,
        c31=2.2141894119604265e-34, c32=8.481991936862865e-28, c33=1.6508842730861433e-31,
        c34=8.560017140461409e-28, c35=7.03872877733453e-30, c36=8.640261015355885e-28,
        c37=1.2585294588752098e-26, c38=8.722723561546295e-28, c39=-1.448814070935912e-24,
        c40=8.80740477903264e-28, c41=-1.858393274046472e-22, c42=8.894304667814918e-28,
        c43=1.7209558293420705e-22, c44=8.98342322789313e-28, c45=1.1564823173178714e-19,
        c46=9.07476046114807e-28, c47=9.168316367579732e-28, c48=8.304820816109472e-28,
        c49=1.0948341329470242e+27, c50=9.197038735090097e-28, c51=9.232045404485834e-28,
        c52=9.267791630980215e-28, c53=1.0835017304955739e+27, c54=1.0000000000000009,
        c55=9.267792597706769e-28):
    """R = J_l(v) = I + (1 - cos θ)/θ^2 v~ + (θ - sin θ)/θ^3 v~^2, θ = |v|; |error of R| <= R_bound
    unless inf or NaN.

    (3)->(3,3),(3,3).  v: vector; R, R_bound: rotation or other 3×3 matrix.
    433 mul, 747 add, 21 product error, 43 product rest, 16 div, 3 sqrt, 90 abs, 20 less, 1
    equal, 45 select.
    """
    v_0, v_1, v_2 = v
    size_0 = absolute(v_0)
    size_1 = absolute(v_1)
    size_2 = absolute(v_2)
    sizes = size_0 + size_1 + size_2
    grid = sizes * c1
    shifted_0 = v_0 + grid
    shifted_1 = v_1 + grid
    shifted_2 = v_2 + grid
    high_0 = shifted_0 - grid
    high_1 = shifted_1 - grid
    high_2 = shifted_2 - grid
    low_0 = v_0 - high_0
    low_1 = v_1 - high_1
    low_2 = v_2 - high_2
    sum_0 = v_0 + high_0
    sum_1 = v_1 + high_1
    sum_2 = v_2 + high_2
    squares = high_0 * high_0 + high_1 * high_1 + high_2 * high_2
    cross = low_0 * sum_0 + low_1 * sum_1 + low_2 * sum_2
    x = squares + cross
    theta_b = x < 1
    theta = where(theta_b, 1, sqrt(x))
    theta_shifted = grid + theta
    theta_high = theta_shifted - grid
    theta_low = theta - theta_high
    theta_sum = theta + theta_high
    cross_rest = cross - theta_low * theta_sum
    exact = squares - theta_high * theta_high
    residual = cross_rest + exact
    small = 0.5 * residual / theta
    delta = where(absolute(small) < 0.0078125, small, 0)
    far_sine_a, far_cosine_a = elementary.sincos(theta)
    far_sine = where(theta_b, 1, far_sine_a)
    far_cosine = where(theta_b, 0, far_cosine_a)
    sine = delta * far_cosine + far_sine
    cosine = far_cosine - delta * far_sine
    far_x = where(theta_b, 1, x)
    middle_x_a = x < 4
    middle_x = where(middle_x_a, 4, x)
    closed1 = sine / theta
    versine = 1 - cosine
    closed2 = versine / far_x
    rest3 = 1 - closed1
    closed3 = rest3 / middle_x
    g1h = (x
        * (x * (x * (6.446950284384474e-26 * x - 3.868170170630684e-23) + 1.9572941063391263e-20)
        - 8.22063524662433e-18) + 2.8114572543455206e-15)
    g1q = (x
        * (x
        * (x * (x * (x * g1h - 7.647163731819816e-13) + 1.6059043836821613e-10)
        - 2.505210838544172e-08) + 2.7557319223985893e-06))
    g1 = where(theta_b,
        x * (x * (x * (g1q - 0.0001984126984126984) + 0.008333333333333333) - 0.16666666666666666) +
            1,
        closed1)
    g2h = (x
        * (x * (x * (2.4795962632247976e-27 * x - 1.6117375710961184e-24) + 8.896791392450574e-22)
        - 4.110317623312165e-19) + 1.5619206968586225e-16)
    g2q = (x
        * (x
        * (x * (x * (x * g2h - 4.779477332387385e-14) + 1.1470745597729725e-11)
        - 2.08767569878681e-09) + 2.755731922398589e-07))
    g2 = where(theta_b,
        x * (x * (x * (g2q - 2.48015873015873e-05) + 0.001388888888888889) - 0.041666666666666664) +
            0.5,
        closed2)
    g3h = (x
        * (x * (x * (9.183689863795546e-29 * x - 6.446950284384474e-26) + 3.868170170630684e-23)
        - 1.9572941063391263e-20) + 8.22063524662433e-18)
    g3q = (x
        * (x
        * (x * (x * (x * g3h - 2.8114572543455206e-15) + 7.647163731819816e-13)
        - 1.6059043836821613e-10) + 2.505210838544172e-08))
    g3 = where(middle_x_a,
        x * (x * (x * (g3q - 2.7557319223985893e-06) + 0.0001984126984126984) -
            0.008333333333333333) + 0.16666666666666666,
        closed3)
    beta_v_0 = v_0 * g3
    beta_v_1 = v_1 * g3
    beta_v_2 = v_2 * g3
    m_0 = v_0 * beta_v_0
    m_1 = v_1 * beta_v_1
    m_2 = v_2 * beta_v_2
    m_3 = v_1 * beta_v_0
    m_4 = v_2 * beta_v_0
    m_5 = v_2 * beta_v_1
    others_0 = m_1 + m_2
    others_1 = m_0 + m_2
    others_2 = m_0 + m_1
    diagonal0 = where(m_0 < others_0, g1 + m_0, 1 - others_0)
    diagonal1 = where(m_1 < others_1, g1 + m_1, 1 - others_1)
    diagonal2 = where(m_2 < others_2, g1 + m_2, 1 - others_2)
    alpha_v_0 = v_0 * g2
    alpha_v_1 = v_1 * g2
    alpha_v_2 = v_2 * g2
    R_01 = m_3 - alpha_v_2
    R_02 = m_4 + alpha_v_1
    R_10 = m_3 + alpha_v_2
    R_12 = m_5 - alpha_v_0
    R_20 = m_4 - alpha_v_1
    R_21 = m_5 + alpha_v_0
    halved_0 = 0.5 * v_0
    halved_size_1 = absolute(v_0)
    halved_1 = 0.5 * v_1
    halved_size_3 = absolute(v_1)
    halved_2 = 0.5 * v_2
    halved_size_5 = absolute(v_2)
    y_a = halved_0 * halved_0
    y_a_padded_1 = c2 + 0.5 * halved_size_1
    y_b = halved_1 * halved_1
    y_b_padded_1 = c2 + 0.5 * halved_size_3
    y_c = y_a + y_b
    y_c_right_1 = y_c - y_a
    y_d = halved_2 * halved_2
    y_d_padded_1 = c2 + 0.5 * halved_size_5
    y = y_c + y_d
    y_right_1 = y - y_c
    y_c_lo = (product_rest(halved_0, halved_0, y_a, y_c - y_c_right_1)
        + product_rest(halved_1, halved_1, y_b, y_c_right_1))
    y_lo = y_c - (y - y_right_1) + product_rest(halved_2, halved_2, y_d, y_right_1) + y_c_lo
    y_size_1 = (y_a_padded_1 * y_a_padded_1 + y_b_padded_1 * y_b_padded_1 + y_d_padded_1
        * y_d_padded_1)
    half_angle = sqrt(y)
    half_angle_product_1 = half_angle * half_angle
    half_angle_residual_1 = (y - half_angle_product_1
        - product_error(half_angle, half_angle, half_angle_product_1) + y_lo)
    half_angle_lo = half_angle_residual_1 / where(half_angle == 0, 1, half_angle + half_angle)
    half_angle_padded_1 = c2 + y_size_1
    half_angle_bound_1 = absolute(y_lo) + c3 * half_angle_padded_1
    half_angle_size_6 = absolute(half_angle_lo)
    half_angle_size_4 = ((absolute(y) + c4 * half_angle_bound_1)
        * (half_angle_padded_1 / half_angle / y))
    half_angle_size_12 = (half_angle
        + where(4 * half_angle_bound_1 < y, half_angle_size_4, c5
        * (sqrt(half_angle_bound_1) + half_angle_size_6)))
    fine_sine, c = elementary.sincos(half_angle)
    fine_sine_own_error_1, c_own_error_1 = elementary.sincos_error(half_angle, fine_sine, c)
    fine_sine_half_1 = half_angle_lo * 0.5
    fine_sine_half_sin_1, fine_sine_half_cos_1 = elementary.sincos(fine_sine_half_1)
    fine_sine_twice_1 = fine_sine_half_sin_1 + fine_sine_half_sin_1
    fine_sine_padded_1 = c2 + half_angle_size_12
    fine_sine_size_1 = 1 + fine_sine_padded_1
    c_lo = (c_own_error_1 - (fine_sine_half_cos_1 * fine_sine + fine_sine_half_sin_1 * c)
        * fine_sine_twice_1)
    sinc_divisor_a = half_angle < 1.4901161193847656e-08
    sinc_divisor = where(sinc_divisor_a, 1.4901161193847656e-08, half_angle)
    sinc_divisor_lo = where(sinc_divisor_a, 0, half_angle_lo)
    sinc_divisor_bound_1 = half_angle_size_6 + c6 * fine_sine_padded_1
    sinc_divisor_size_4 = sinc_divisor_bound_1 < absolute(half_angle - 1.4901161193847656e-08)
    sinc_divisor_size_9 = (c7
        * where(sinc_divisor_size_4, 0, sinc_divisor_bound_1
        + absolute(1.4901161193847656e-08 - half_angle)))
    sinc_quotient = fine_sine / sinc_divisor
    sinc_quotient_product_1 = sinc_quotient * sinc_divisor
    sinc_quotient_exact_1 = (fine_sine - sinc_quotient_product_1
        - product_error(sinc_quotient, sinc_divisor, sinc_quotient_product_1))
    fine_sine_lo = (fine_sine_own_error_1
        + (fine_sine_half_cos_1 * c - fine_sine_half_sin_1 * fine_sine) * fine_sine_twice_1)
    sinc_quotient_lo = ((sinc_quotient_exact_1 + fine_sine_lo - sinc_quotient * sinc_divisor_lo)
        / sinc_divisor)
    sinc_quotient_padded_2 = (c2
        + (where(sinc_divisor_a, 1.4901161193847656e-08, half_angle_size_12) + sinc_divisor_size_9))
    sinc_quotient_size_1 = absolute(sinc_quotient)
    sinc_quotient_size_2 = absolute(sinc_divisor)
    sinc_quotient_bound_1 = absolute(sinc_divisor_lo) + c8 * sinc_quotient_padded_2
    sinc_quotient_size_7 = where(4 * sinc_quotient_bound_1 < sinc_quotient_size_2,
        sinc_quotient_size_2, 0)
    sinc_quotient_size_8 = ((c2 + fine_sine_size_1 + sinc_quotient_padded_2 * sinc_quotient_size_1)
        / sinc_quotient_size_7)
    sinc_quotient_size_11 = (sinc_quotient_size_1
        + (sinc_quotient_size_2 + c4 * sinc_quotient_bound_1) * sinc_quotient_size_8
        / sinc_quotient_size_2)
    sinc_a = 0.16666666666666666 * y
    sinc_b = 1 - sinc_a
    sinc_b_right_1 = 1 - sinc_b
    sinc_b_lo = (1 - (sinc_b + sinc_b_right_1)
        - product_rest(0.16666666666666666, y, sinc_a, sinc_b_right_1)
        - (c9 * y + 0.16666666666666666 * y_lo))
    sinc_b_size_1 = 1 + c10 * y_size_1
    sinc = where(sinc_divisor_a, sinc_b, sinc_quotient)
    sinc_lo = where(sinc_divisor_a, sinc_b_lo, sinc_quotient_lo)
    sinc_size_4 = (absolute(sinc_b_lo) + c11 * (c2 + sinc_b_size_1)
        + absolute(sinc_b - sinc_quotient))
    sinc_size_7 = (c13
        * where(sinc_divisor_size_4, 0, absolute(sinc_quotient_lo) + c12
        * (c2 + sinc_quotient_size_11) + sinc_size_4))
    fine_g1 = c * sinc
    fine_g1_cross_1 = c_lo * sinc + c * sinc_lo
    fine_g1_padded_1 = (c2
        + (where(sinc_divisor_a, sinc_b_size_1, sinc_quotient_size_11) + sinc_size_7))
    fine_g1_reach_2 = absolute(sinc) + c4 * (absolute(sinc_lo) + c15 * fine_g1_padded_1)
    fine_g1_size_5 = (fine_g1_padded_1
        * (absolute(c) + c4 * (absolute(c_lo) + c14 * fine_sine_size_1)) + fine_g1_reach_2
        * fine_sine_size_1)
    fine_g2a = sinc * sinc
    fine_g2a_size_1 = fine_g1_padded_1 * fine_g1_reach_2
    fine_g2 = 0.5 * fine_g2a
    fine_g2_cross2_1 = (0.5
        * (product_error(sinc, sinc, fine_g2a) + (sinc_lo * sinc + sinc * sinc_lo)))
    fine_rest3 = 1 - fine_g1
    fine_rest3_right_1 = 1 - fine_rest3
    fine_x = 4 * y
    fine_x_cross2_1 = 4 * y_lo
    fine_x_size_1 = 4 * y_size_1
    far_x_a = fine_x < 1
    fine_far_x = where(far_x_a, 1, fine_x)
    fine_far_x_lo = where(far_x_a, 0, fine_x_cross2_1)
    fine_far_x_padded_1 = c2 + fine_x_size_1
    fine_far_x_bound_1 = absolute(fine_x_cross2_1) + c16 * fine_far_x_padded_1
    fine_far_x_size_4 = fine_far_x_bound_1 < absolute(fine_x - 1)
    fine_closed3 = fine_rest3 / fine_far_x
    fine_closed3_product_1 = fine_closed3 * fine_far_x
    fine_rest3_lo = (1 - (fine_rest3 + fine_rest3_right_1)
        - product_rest(c, sinc, fine_g1, fine_rest3_right_1) - fine_g1_cross_1)
    fine_closed3_numerator_1 = (fine_rest3 - fine_closed3_product_1
        - product_error(fine_closed3, fine_far_x, fine_closed3_product_1) + fine_rest3_lo)
    fine_closed3_lo = (fine_closed3_numerator_1 - fine_closed3 * fine_far_x_lo) / fine_far_x
    fine_closed3_padded_2 = (c2
        + (where(far_x_a, 1, fine_x_size_1) + c17
        * where(fine_far_x_size_4, 0, fine_far_x_bound_1 + absolute(1 - fine_x))))
    fine_closed3_size_1 = absolute(fine_closed3)
    fine_closed3_size_2 = absolute(fine_far_x)
    fine_closed3_bound_1 = absolute(fine_far_x_lo) + c18 * fine_closed3_padded_2
    fine_closed3_size_7 = where(4 * fine_closed3_bound_1 < fine_closed3_size_2, fine_closed3_size_2,
        0)
    fine_closed3_size_8 = ((c2 + (1 + fine_g1_size_5) + fine_closed3_padded_2
        * fine_closed3_size_1) / fine_closed3_size_7)
    fine_closed3_size_11 = (fine_closed3_size_1 + (fine_closed3_size_2 + c4 * fine_closed3_bound_1)
        * fine_closed3_size_8 / fine_closed3_size_2)
    series5a = 1.216125041553518e-34 * fine_x
    series5b = 1.1309962886447716e-31 - series5a
    series5b_right_1 = 1.1309962886447716e-31 - series5b
    series5b_lo1_1 = (1.1309962886447716e-31 - (series5b + series5b_right_1)
        - product_rest(1.216125041553518e-34, fine_x, series5a, series5b_right_1))
    series5b_lo = series5b_lo1_1 - (c19 * fine_x + 1.216125041553518e-34 * fine_x_cross2_1) + c21
    series5c = fine_x * series5b
    series5c_padded_1 = c2 + (1.1309962886447716e-31 + c20 * fine_x_size_1)
    series5c_reach_1 = absolute(fine_x) + c4 * fine_far_x_bound_1
    series5c_size_4 = (fine_far_x_padded_1
        * (absolute(series5b) + c4 * (absolute(series5b_lo) + c22 * series5c_padded_1)))
    series5d = series5c - 9.183689863795546e-29
    series5d_right_1 = series5c - series5d
    series5d_lo2_1 = (product_rest(fine_x, series5b, series5c, series5d + series5d_right_1)
        - (9.183689863795546e-29 - series5d_right_1) - c23)
    series5d_lo = series5d_lo2_1 + (fine_x_cross2_1 * series5b + fine_x * series5b_lo)
    series5e = fine_x * series5d
    series5e_padded_1 = (c2
        + (9.183689863795546e-29 + (series5c_padded_1 * series5c_reach_1 + series5c_size_4)))
    series5e_size_3 = (fine_far_x_padded_1
        * (absolute(series5d) + c4 * (absolute(series5d_lo) + c24 * series5e_padded_1)))
    series5f = series5e + 6.446950284384474e-26
    series5f_right_1 = series5f - series5e
    series5f_lo2_1 = (product_rest(fine_x, series5d, series5e, series5f - series5f_right_1)
        + (6.446950284384474e-26 - series5f_right_1) + c25)
    series5f_lo = series5f_lo2_1 + (fine_x_cross2_1 * series5d + fine_x * series5d_lo)
    series5g = fine_x * series5f
    series5g_padded_1 = (c2
        + (6.446950284384474e-26 + (series5c_reach_1 * series5e_padded_1 + series5e_size_3)))
    series5g_size_3 = (fine_far_x_padded_1
        * (absolute(series5f) + c4 * (absolute(series5f_lo) + c26 * series5g_padded_1)))
    series5h = series5g - 3.868170170630684e-23
    series5h_right_1 = series5g - series5h
    series5h_lo2_1 = (product_rest(fine_x, series5f, series5g, series5h + series5h_right_1)
        - (3.868170170630684e-23 - series5h_right_1) - c27)
    series5h_lo = series5h_lo2_1 + (fine_x_cross2_1 * series5f + fine_x * series5f_lo)
    series5i = fine_x * series5h
    series5i_padded_1 = (c2
        + (3.868170170630684e-23 + (series5c_reach_1 * series5g_padded_1 + series5g_size_3)))
    series5i_size_3 = (fine_far_x_padded_1
        * (absolute(series5h) + c4 * (absolute(series5h_lo) + c28 * series5i_padded_1)))
    series5j = series5i + 1.9572941063391263e-20
    series5j_right_1 = series5j - series5i
    series5j_lo2_1 = (product_rest(fine_x, series5h, series5i, series5j - series5j_right_1)
        + (1.9572941063391263e-20 - series5j_right_1) + c29)
    series5j_lo = series5j_lo2_1 + (fine_x_cross2_1 * series5h + fine_x * series5h_lo)
    series5k = fine_x * series5j
    series5k_padded_1 = (c2
        + (1.9572941063391263e-20 + (series5c_reach_1 * series5i_padded_1 + series5i_size_3)))
    series5k_size_3 = (fine_far_x_padded_1
        * (absolute(series5j) + c4 * (absolute(series5j_lo) + c30 * series5k_padded_1)))
    series5l = series5k - 8.22063524662433e-18
    series5l_right_1 = series5k - series5l
    series5l_lo2_1 = (product_rest(fine_x, series5j, series5k, series5l + series5l_right_1)
        - (8.22063524662433e-18 - series5l_right_1) - c31)
    series5l_lo = series5l_lo2_1 + (fine_x_cross2_1 * series5j + fine_x * series5j_lo)
    series5m = fine_x * series5l
    series5m_padded_1 = (c2
        + (8.22063524662433e-18 + (series5c_reach_1 * series5k_padded_1 + series5k_size_3)))
    series5m_size_3 = (fine_far_x_padded_1
        * (absolute(series5l) + c4 * (absolute(series5l_lo) + c32 * series5m_padded_1)))
    series5n = series5m + 2.8114572543455206e-15
    series5n_right_1 = series5n - series5m
    series5n_lo2_1 = (product_rest(fine_x, series5l, series5m, series5n - series5n_right_1)
        + (2.8114572543455206e-15 - series5n_right_1) + c33)
    series5n_lo = series5n_lo2_1 + (fine_x_cross2_1 * series5l + fine_x * series5l_lo)
    series5o = fine_x * series5n
    series5o_padded_1 = (c2
        + (2.8114572543455206e-15 + (series5c_reach_1 * series5m_padded_1 + series5m_size_3)))
    series5o_size_3 = (fine_far_x_padded_1
        * (absolute(series5n) + c4 * (absolute(series5n_lo) + c34 * series5o_padded_1)))
    series5p = series5o - 7.647163731819816e-13
    series5p_right_1 = series5o - series5p
    series5p_lo2_1 = (product_rest(fine_x, series5n, series5o, series5p + series5p_right_1)
        - (7.647163731819816e-13 - series5p_right_1) - c35)
    series5p_lo = series5p_lo2_1 + (fine_x_cross2_1 * series5n + fine_x * series5n_lo)
    series5q = fine_x * series5p
    series5q_padded_1 = (c2
        + (7.647163731819816e-13 + (series5c_reach_1 * series5o_padded_1 + series5o_size_3)))
    series5q_size_3 = (fine_far_x_padded_1
        * (absolute(series5p) + c4 * (absolute(series5p_lo) + c36 * series5q_padded_1)))
    series5r = series5q + 1.6059043836821613e-10
    series5r_right_1 = series5r - series5q
    series5r_lo2_1 = (product_rest(fine_x, series5p, series5q, series5r - series5r_right_1)
        + (1.6059043836821613e-10 - series5r_right_1) + c37)
    series5r_lo = series5r_lo2_1 + (fine_x_cross2_1 * series5p + fine_x * series5p_lo)
    series5s = fine_x * series5r
    series5s_padded_1 = (c2
        + (1.6059043836821613e-10 + (series5c_reach_1 * series5q_padded_1 + series5q_size_3)))
    series5s_size_3 = (fine_far_x_padded_1
        * (absolute(series5r) + c4 * (absolute(series5r_lo) + c38 * series5s_padded_1)))
    series5t = series5s - 2.505210838544172e-08
    series5t_right_1 = series5s - series5t
    series5t_lo2_1 = (product_rest(fine_x, series5r, series5s, series5t + series5t_right_1)
        - (2.505210838544172e-08 - series5t_right_1) - c39)
    series5t_lo = series5t_lo2_1 + (fine_x_cross2_1 * series5r + fine_x * series5r_lo)
    series5u = fine_x * series5t
    series5u_padded_1 = (c2
        + (2.505210838544172e-08 + (series5c_reach_1 * series5s_padded_1 + series5s_size_3)))
    series5u_size_3 = (fine_far_x_padded_1
        * (absolute(series5t) + c4 * (absolute(series5t_lo) + c40 * series5u_padded_1)))
    series5v = series5u + 2.7557319223985893e-06
    series5v_right_1 = series5v - series5u
    series5v_lo2_1 = (product_rest(fine_x, series5t, series5u, series5v - series5v_right_1)
        + (2.7557319223985893e-06 - series5v_right_1) + c41)
    series5v_lo = series5v_lo2_1 + (fine_x_cross2_1 * series5t + fine_x * series5t_lo)
    series5w = fine_x * series5v
    series5w_padded_1 = (c2
        + (2.7557319223985893e-06 + (series5c_reach_1 * series5u_padded_1 + series5u_size_3)))
    series5w_size_3 = (fine_far_x_padded_1
        * (absolute(series5v) + c4 * (absolute(series5v_lo) + c42 * series5w_padded_1)))
    series5x = series5w - 0.0001984126984126984
    series5x_right_1 = series5w - series5x
    series5x_lo2_1 = (product_rest(fine_x, series5v, series5w, series5x + series5x_right_1)
        - (0.0001984126984126984 - series5x_right_1) - c43)
    series5x_lo = series5x_lo2_1 + (fine_x_cross2_1 * series5v + fine_x * series5v_lo)
    series5y = fine_x * series5x
    series5y_padded_1 = (c2
        + (0.0001984126984126984 + (series5c_reach_1 * series5w_padded_1 + series5w_size_3)))
    series5y_size_3 = (fine_far_x_padded_1
        * (absolute(series5x) + c4 * (absolute(series5x_lo) + c44 * series5y_padded_1)))
    series5 = series5y + 0.008333333333333333
    series5_right_1 = series5 - series5y
    series5_lo2_1 = (product_rest(fine_x, series5x, series5y, series5 - series5_right_1)
        + (0.008333333333333333 - series5_right_1) + c45)
    series5_lo = series5_lo2_1 + (fine_x_cross2_1 * series5x + fine_x * series5x_lo)
    fine_g3a = fine_x * series5
    fine_g3a_padded_1 = (c2
        + (0.008333333333333333 + (series5c_reach_1 * series5y_padded_1 + series5y_size_3)))
    fine_g3a_size_3 = (fine_far_x_padded_1
        * (absolute(series5) + c4 * (absolute(series5_lo) + c46 * fine_g3a_padded_1)))
    fine_g3b = 0.16666666666666666 - fine_g3a
    fine_g3b_right_1 = 0.16666666666666666 - fine_g3b
    fine_g3b_lo1_1 = (0.16666666666666666 - (fine_g3b + fine_g3b_right_1)
        - product_rest(fine_x, series5, fine_g3a, fine_g3b_right_1))
    fine_g3b_lo = fine_g3b_lo1_1 - (fine_x_cross2_1 * series5 + fine_x * series5_lo) + c9
    fine_g3b_size_1 = 0.16666666666666666 + (fine_g3a_padded_1 * series5c_reach_1 + fine_g3a_size_3)
    fine_g3 = where(far_x_a, fine_g3b, fine_closed3)
    fine_g3_lo = where(far_x_a, fine_g3b_lo, fine_closed3_lo)
    fine_g3_size_4 = (absolute(fine_g3b_lo) + c47 * (c2 + fine_g3b_size_1)
        + absolute(fine_g3b - fine_closed3))
    fine_g3_size_7 = (c49
        * where(fine_far_x_size_4, 0, absolute(fine_closed3_lo) + c48 * (c2 + fine_closed3_size_11)
        + fine_g3_size_4))
    fine_beta_v_0 = v_0 * fine_g3
    fine_beta_v_padded_1 = (c2
        + (where(far_x_a, fine_g3b_size_1, fine_closed3_size_11) + fine_g3_size_7))
    fine_beta_v_1 = v_1 * fine_g3
    fine_beta_v_2 = v_2 * fine_g3
    fine_beta_v_lo_1 = product_error(v_0, fine_g3, fine_beta_v_0) + v_0 * fine_g3_lo
    fine_m_0 = v_0 * fine_beta_v_0
    fine_m_cross2_1 = v_0 * fine_beta_v_lo_1
    fine_m_padded_1 = c2 + fine_beta_v_padded_1 * halved_size_1
    fine_m_size_1 = fine_m_padded_1 * halved_size_1
    fine_beta_v_lo_2 = product_error(v_1, fine_g3, fine_beta_v_1) + v_1 * fine_g3_lo
    fine_m_1 = v_1 * fine_beta_v_1
    fine_m_cross2_2 = v_1 * fine_beta_v_lo_2
    fine_m_padded_2 = c2 + fine_beta_v_padded_1 * halved_size_3
    fine_m_size_2 = fine_m_padded_2 * halved_size_3
    fine_m_2 = v_2 * fine_beta_v_2
    fine_m_cross2_3 = v_2 * (product_error(v_2, fine_g3, fine_beta_v_2) + v_2 * fine_g3_lo)
    fine_m_size_3 = (c2 + fine_beta_v_padded_1 * halved_size_5) * halved_size_5
    fine_m_3 = v_1 * fine_beta_v_0
    fine_m_cross2_4 = v_1 * fine_beta_v_lo_1
    fine_m_4 = v_2 * fine_beta_v_0
    fine_m_cross2_5 = v_2 * fine_beta_v_lo_1
    fine_m_5 = v_2 * fine_beta_v_1
    fine_m_cross2_6 = v_2 * fine_beta_v_lo_2
    fine_others_0 = fine_m_1 + fine_m_2
    fine_others_right_1 = fine_others_0 - fine_m_1
    fine_others_left_rest_1 = product_rest(v_1, fine_beta_v_1, fine_m_1,
        fine_others_0 - fine_others_right_1)
    fine_others_lo_1 = (fine_others_left_rest_1
        + product_rest(v_2, fine_beta_v_2, fine_m_2, fine_others_right_1)
        + (fine_m_cross2_2 + fine_m_cross2_3))
    fine_others_size_1 = fine_m_size_2 + fine_m_size_3
    fine_others_1 = fine_m_0 + fine_m_2
    fine_others_right_2 = fine_others_1 - fine_m_0
    fine_others_left_rest_2 = product_rest(v_0, fine_beta_v_0, fine_m_0,
        fine_others_1 - fine_others_right_2)
    fine_others_lo_2 = (fine_others_left_rest_2
        + product_rest(v_2, fine_beta_v_2, fine_m_2, fine_others_right_2)
        + (fine_m_cross2_1 + fine_m_cross2_3))
    fine_others_size_2 = fine_m_size_1 + fine_m_size_3
    fine_others_2 = fine_m_0 + fine_m_1
    fine_others_right_3 = fine_others_2 - fine_m_0
    fine_others_left_rest_3 = product_rest(v_0, fine_beta_v_0, fine_m_0,
        fine_others_2 - fine_others_right_3)
    fine_others_lo_3 = (fine_others_left_rest_3
        + product_rest(v_1, fine_beta_v_1, fine_m_1, fine_others_right_3)
        + (fine_m_cross2_1 + fine_m_cross2_2))
    fine_others_size_3 = fine_m_size_1 + fine_m_size_2
    fine_diagonal0a = 1 - fine_others_0
    fine_diagonal0a_right_1 = 1 - fine_diagonal0a
    fine_diagonal0a_lo = (1 - (fine_diagonal0a + fine_diagonal0a_right_1)
        - (fine_others_0 - fine_diagonal0a_right_1) - fine_others_lo_1)
    fine_diagonal0a_size_1 = 1 + fine_others_size_1
    fine_diagonal0b = fine_g1 + fine_m_0
    fine_diagonal0b_right_1 = fine_diagonal0b - fine_g1
    fine_diagonal0b_left_rest_1 = product_rest(c, sinc, fine_g1,
        fine_diagonal0b - fine_diagonal0b_right_1)
    fine_diagonal0b_lo1_1 = (fine_diagonal0b_left_rest_1
        + product_rest(v_0, fine_beta_v_0, fine_m_0, fine_diagonal0b_right_1))
    fine_diagonal0b_lo = fine_diagonal0b_lo1_1 + (fine_g1_cross_1 + fine_m_cross2_1)
    fine_diagonal0b_size_1 = fine_g1_size_5 + fine_m_size_1
    fine_diagonal0c = fine_m_0 < fine_others_0
    fine_diagonal0_bound_1 = (absolute(product_error(v_0, fine_beta_v_0, fine_m_0)
        + fine_m_cross2_1) + c50 * (c2 + fine_m_size_1))
    fine_diagonal0_size_8 = (absolute(fine_diagonal0b_lo) + c51 * (c2 + fine_diagonal0b_size_1)
        + absolute(fine_diagonal0b - fine_diagonal0a))
    fine_diagonal0_size_5 = (fine_diagonal0_bound_1
        + (absolute(fine_others_lo_1) + c51 * (c2 + fine_others_size_1))
        < absolute(fine_m_0 - fine_others_0))
    fine_diagonal0_size_10 = where(fine_diagonal0_size_5, 0,
        absolute(fine_diagonal0a_lo) + c52 * (c2 + fine_diagonal0a_size_1) + fine_diagonal0_size_8)
    fine_diagonal1a = 1 - fine_others_1
    fine_diagonal1a_right_1 = 1 - fine_diagonal1a
    fine_diagonal1a_lo = (1 - (fine_diagonal1a + fine_diagonal1a_right_1)
        - (fine_others_1 - fine_diagonal1a_right_1) - fine_others_lo_2)
    fine_diagonal1a_size_1 = 1 + fine_others_size_2
    fine_diagonal1b = fine_g1 + fine_m_1
    fine_diagonal1b_right_1 = fine_diagonal1b - fine_g1
    fine_diagonal1b_left_rest_1 = product_rest(c, sinc, fine_g1,
        fine_diagonal1b - fine_diagonal1b_right_1)
    fine_diagonal1b_lo1_1 = (fine_diagonal1b_left_rest_1
        + product_rest(v_1, fine_beta_v_1, fine_m_1, fine_diagonal1b_right_1))
    fine_diagonal1b_lo = fine_diagonal1b_lo1_1 + (fine_g1_cross_1 + fine_m_cross2_2)
    fine_diagonal1b_size_1 = fine_g1_size_5 + fine_m_size_2
    fine_diagonal1c = fine_m_1 < fine_others_1
    fine_diagonal1_bound_1 = (absolute(product_error(v_1, fine_beta_v_1, fine_m_1)
        + fine_m_cross2_2) + c50 * (c2 + fine_m_size_2))
    fine_diagonal1_size_8 = (absolute(fine_diagonal1b_lo) + c51 * (c2 + fine_diagonal1b_size_1)
        + absolute(fine_diagonal1b - fine_diagonal1a))
    fine_diagonal1_size_5 = (fine_diagonal1_bound_1
        + (absolute(fine_others_lo_2) + c51 * (c2 + fine_others_size_2))
        < absolute(fine_m_1 - fine_others_1))
    fine_diagonal1_size_10 = where(fine_diagonal1_size_5, 0,
        absolute(fine_diagonal1a_lo) + c52 * (c2 + fine_diagonal1a_size_1) + fine_diagonal1_size_8)
    fine_diagonal2a = 1 - fine_others_2
    fine_diagonal2a_right_1 = 1 - fine_diagonal2a
    fine_diagonal2a_lo = (1 - (fine_diagonal2a + fine_diagonal2a_right_1)
        - (fine_others_2 - fine_diagonal2a_right_1) - fine_others_lo_3)
    fine_diagonal2a_size_1 = 1 + fine_others_size_3
    fine_diagonal2b = fine_g1 + fine_m_2
    fine_diagonal2b_right_1 = fine_diagonal2b - fine_g1
    fine_diagonal2b_left_rest_1 = product_rest(c, sinc, fine_g1,
        fine_diagonal2b - fine_diagonal2b_right_1)
    fine_diagonal2b_lo1_1 = (fine_diagonal2b_left_rest_1
        + product_rest(v_2, fine_beta_v_2, fine_m_2, fine_diagonal2b_right_1))
    fine_diagonal2b_lo = fine_diagonal2b_lo1_1 + (fine_g1_cross_1 + fine_m_cross2_3)
    fine_diagonal2b_size_1 = fine_g1_size_5 + fine_m_size_3
    fine_diagonal2c = fine_m_2 < fine_others_2
    fine_diagonal2_bound_1 = (absolute(product_error(v_2, fine_beta_v_2, fine_m_2)
        + fine_m_cross2_3) + c50 * (c2 + fine_m_size_3))
    fine_diagonal2_size_8 = (absolute(fine_diagonal2b_lo) + c51 * (c2 + fine_diagonal2b_size_1)
        + absolute(fine_diagonal2b - fine_diagonal2a))
    fine_diagonal2_size_5 = (fine_diagonal2_bound_1
        + (absolute(fine_others_lo_3) + c51 * (c2 + fine_others_size_3))
        < absolute(fine_m_2 - fine_others_2))
    fine_diagonal2_size_10 = where(fine_diagonal2_size_5, 0,
        absolute(fine_diagonal2a_lo) + c52 * (c2 + fine_diagonal2a_size_1) + fine_diagonal2_size_8)
    fine_alpha_v_0 = v_0 * fine_g2
    fine_alpha_v_cross2_1 = v_0 * fine_g2_cross2_1
    fine_alpha_v_padded_1 = c2 + 0.5 * (fine_g2a_size_1 + fine_g2a_size_1)
    fine_alpha_v_1 = v_1 * fine_g2
    fine_alpha_v_cross2_2 = v_1 * fine_g2_cross2_1
    fine_alpha_v_2 = v_2 * fine_g2
    fine_alpha_v_cross2_3 = v_2 * fine_g2_cross2_1
    fine_R_01 = fine_m_3 - fine_alpha_v_2
    fine_R_right_1 = fine_m_3 - fine_R_01
    fine_R_lo1_1 = (product_rest(v_1, fine_beta_v_0, fine_m_3, fine_R_01 + fine_R_right_1)
        - product_rest(v_2, fine_g2, fine_alpha_v_2, fine_R_right_1))
    fine_R_02 = fine_m_4 + fine_alpha_v_1
    fine_R_right_2 = fine_R_02 - fine_m_4
    fine_R_lo1_2 = (product_rest(v_2, fine_beta_v_0, fine_m_4, fine_R_02 - fine_R_right_2)
        + product_rest(v_1, fine_g2, fine_alpha_v_1, fine_R_right_2))
    fine_R_10 = fine_m_3 + fine_alpha_v_2
    fine_R_right_3 = fine_R_10 - fine_m_3
    fine_R_lo1_3 = (product_rest(v_1, fine_beta_v_0, fine_m_3, fine_R_10 - fine_R_right_3)
        + product_rest(v_2, fine_g2, fine_alpha_v_2, fine_R_right_3))
    fine_R_12 = fine_m_5 - fine_alpha_v_0
    fine_R_right_4 = fine_m_5 - fine_R_12
    fine_R_lo1_4 = (product_rest(v_2, fine_beta_v_1, fine_m_5, fine_R_12 + fine_R_right_4)
        - product_rest(v_0, fine_g2, fine_alpha_v_0, fine_R_right_4))
    fine_R_20 = fine_m_4 - fine_alpha_v_1
    fine_R_right_5 = fine_m_4 - fine_R_20
    fine_R_lo1_5 = (product_rest(v_2, fine_beta_v_0, fine_m_4, fine_R_20 + fine_R_right_5)
        - product_rest(v_1, fine_g2, fine_alpha_v_1, fine_R_right_5))
    fine_R_21 = fine_m_5 + fine_alpha_v_0
    fine_R_right_6 = fine_R_21 - fine_m_5
    fine_R_lo1_6 = (product_rest(v_2, fine_beta_v_1, fine_m_5, fine_R_21 - fine_R_right_6)
        + product_rest(v_0, fine_g2, fine_alpha_v_0, fine_R_right_6))
    diagonal0_apart_1 = where(fine_diagonal0c, fine_diagonal0b, fine_diagonal0a) - diagonal0
    diagonal0_rest_1 = (c55
        * (c2
        + (where(fine_diagonal0c, fine_diagonal0b_size_1, fine_diagonal0a_size_1) + c53
        * fine_diagonal0_size_10)))
    R_rest_1 = (c51
        * (c2 + (fine_alpha_v_padded_1 * halved_size_5 + fine_m_padded_1 * halved_size_3)))
    R_rest_2 = (c51
        * (c2 + (fine_alpha_v_padded_1 * halved_size_3 + fine_m_padded_1 * halved_size_5)))
    diagonal1_apart_1 = where(fine_diagonal1c, fine_diagonal1b, fine_diagonal1a) - diagonal1
    diagonal1_rest_1 = (c55
        * (c2
        + (where(fine_diagonal1c, fine_diagonal1b_size_1, fine_diagonal1a_size_1) + c53
        * fine_diagonal1_size_10)))
    R_rest_3 = (c51
        * (c2 + (fine_alpha_v_padded_1 * halved_size_1 + fine_m_padded_2 * halved_size_5)))
    diagonal2_apart_1 = where(fine_diagonal2c, fine_diagonal2b, fine_diagonal2a) - diagonal2
    diagonal2_rest_1 = (c55
        * (c2
        + (where(fine_diagonal2c, fine_diagonal2b_size_1, fine_diagonal2a_size_1) + c53
        * fine_diagonal2_size_10)))
    diagonal0_bound_1 = (c54
        * absolute(diagonal0_apart_1
        + where(fine_diagonal0c, fine_diagonal0b_lo, fine_diagonal0a_lo)) + diagonal0_rest_1)
    R_bound_1 = (c54
        * absolute(fine_R_01 - R_01 + (fine_R_lo1_1 + (fine_m_cross2_4 - fine_alpha_v_cross2_3)))
        + R_rest_1)
    R_bound_2 = (c54
        * absolute(fine_R_02 - R_02 + (fine_R_lo1_2 + (fine_m_cross2_5 + fine_alpha_v_cross2_2)))
        + R_rest_2)
    R_bound_3 = (c54
        * absolute(fine_R_10 - R_10 + (fine_R_lo1_3 + (fine_m_cross2_4 + fine_alpha_v_cross2_3)))
        + R_rest_1)
    diagonal1_bound_1 = (c54
        * absolute(diagonal1_apart_1
        + where(fine_diagonal1c, fine_diagonal1b_lo, fine_diagonal1a_lo)) + diagonal1_rest_1)
    R_bound_4 = (c54
        * absolute(fine_R_12 - R_12 + (fine_R_lo1_4 + (fine_m_cross2_6 - fine_alpha_v_cross2_1)))
        + R_rest_3)
    R_bound_5 = (c54
        * absolute(fine_R_20 - R_20 + (fine_R_lo1_5 + (fine_m_cross2_5 - fine_alpha_v_cross2_2)))
        + R_rest_2)
    R_bound_6 = (c54
        * absolute(fine_R_21 - R_21 + (fine_R_lo1_6 + (fine_m_cross2_6 + fine_alpha_v_cross2_1)))
        + R_rest_3)
    diagonal2_bound_1 = (c54
        * absolute(diagonal2_apart_1
        + where(fine_diagonal2c, fine_diagonal2b_lo, fine_diagonal2a_lo)) + diagonal2_rest_1)
    return (diagonal0, R_01, R_02, R_10, diagonal1, R_12, R_20, R_21, diagonal2, diagonal0_bound_1,
        R_bound_1, R_bound_2, R_bound_3, diagonal1_bound_1, R_bound_4, R_bound_5, R_bound_6,
        diagonal2_bound_1)


@kernel("(3)->(3,3),(3,3)")
@errstate(all="ignore")
def SO3_rightJacobian(v, *, c1=268435456, c2=1.8051943758648296e-276, c3=2.5021685128863245e-30,
        c4=140737488355328, c5=2.567393169377981e+29, c6=4.240128211918887e-30,
        c7=9.054644677292507e+28, c8=1.1389183198259759e-29, c9=9.25185853854297e-18,
        c10=2290649224.7000003, c11=8.120831909935717e-28, c12=1.8842277118313698e-29,
        c13=1.2325982855554354e+27, c14=8.677471603123253e-30, c15=8.120832873841084e-28,
        c16=2.8103175390871538e-30, c17=5.28187582188787e+28, c18=1.9524315162482833e-29,
        c19=5.586290567888806e-51, c20=5.702613188320821e-10, c21=1.0498015412959506e-47,
        c22=8.12514599395154e-28, c23=1.4303150396787322e-45, c24=8.19207783918962e-28,
        c25=-1.9330404233703465e-42, c26=8.261228355723635e-28, c27=-8.843177655482344e-40,
        c28=8.332597543553583e-28, c29=-1.3643503830087908e-36, c30=8.406185404560257e-28,
        c31=2.2141894119604265e-34, c32=8.481991936862865e-28, c33=1.6508842730861433e-31,
        c34=8.560017140461409e-28, c35=7.03872877733453e-30, c36=8.640261015355885e-28,
        c37=1.2585294588752098e-26, c38=8.722723561546295e-28, c39=-1.448814070935912e-24,
        c40=8.80740477903264e-28, c41=-1.858393274046472e-22, c42=8.894304667814918e-28,
        c43=1.7209558293420705e-22, c44=8.98342322789313e-28, c45=1.1564823173178714e-19,
        c46=9.07476046114807e-28, c47=9.168316367579732e-28, c48=8.304820816109472e-28,
        c49=1.0948341329470242e+27, c50=9.197038735090097e-28, c51=9.232045404485834e-28,
        c52=9.267791630980215e-28, c53=1.0835017304955739e+27, c54=1.0000000000000009,
        c55=9.267792597706769e-28):
    """R = J_r(v) = I - (1 - cos θ)/θ^2 v~ + (θ - sin θ)/θ^3 v~^2, θ = |v|; |error of R| <= R_bound
    unless inf or NaN.

    (3)->(3,3),(3,3).  v: vector; R, R_bound: rotation or other 3×3 matrix.
    433 mul, 747 add, 21 product error, 43 product rest, 16 div, 3 sqrt, 12 neg, 90 abs, 20
    less, 1 equal, 45 select.
    """
    v_0, v_1, v_2 = v
    size_0 = absolute(v_0)
    size_1 = absolute(v_1)
    size_2 = absolute(v_2)
    sizes = size_0 + size_1 + size_2
    grid = sizes * c1
    shifted_0 = v_0 + grid
    shifted_1 = v_1 + grid
    shifted_2 = v_2 + grid
    high_0 = shifted_0 - grid
    high_1 = shifted_1 - grid
    high_2 = shifted_2 - grid
    low_0 = v_0 - high_0
    low_1 = v_1 - high_1
    low_2 = v_2 - high_2
    sum_0 = v_0 + high_0
    sum_1 = v_1 + high_1
    sum_2 = v_2 + high_2
    squares = high_0 * high_0 + high_1 * high_1 + high_2 * high_2
    cross = low_0 * sum_0 + low_1 * sum_1 + low_2 * sum_2
    x = squares + cross
    theta_b = x < 1
    theta = where(theta_b, 1, sqrt(x))
    theta_shifted = grid + theta
    theta_high = theta_shifted - grid
    theta_low = theta - theta_high
    theta_sum = theta + theta_high
    cross_rest = cross - theta_low * theta_sum
    exact = squares - theta_high * theta_high
    residual = cross_rest + exact
    small = 0.5 * residual / theta
    delta = where(absolute(small) < 0.0078125, small, 0)
    far_sine_a, far_cosine_a = elementary.sincos(theta)
    far_sine = where(theta_b, 1, far_sine_a)
    far_cosine = where(theta_b, 0, far_cosine_a)
    sine = delta * far_cosine + far_sine
    cosine = far_cosine - delta * far_sine
    far_x = where(theta_b, 1, x)
    middle_x_a = x < 4
    middle_x = where(middle_x_a, 4, x)
    closed1 = sine / theta
    versine = 1 - cosine
    closed2 = versine / far_x
    rest3 = 1 - closed1
    closed3 = rest3 / middle_x
    g1h = (x
        * (x * (x * (6.446950284384474e-26 * x - 3.868170170630684e-23) + 1.9572941063391263e-20)
        - 8.22063524662433e-18) + 2.8114572543455206e-15)
    g1q = (x
        * (x
        * (x * (x * (x * g1h - 7.647163731819816e-13) + 1.6059043836821613e-10)
        - 2.505210838544172e-08) + 2.7557319223985893e-06))
    g1 = where(theta_b,
        x * (x * (x * (g1q - 0.0001984126984126984) + 0.008333333333333333) - 0.16666666666666666) +
            1,
        closed1)
    g2h = (x
        * (x * (x * (2.4795962632247976e-27 * x - 1.6117375710961184e-24) + 8.896791392450574e-22)
        - 4.110317623312165e-19) + 1.5619206968586225e-16)
    g2q = (x
        * (x
        * (x * (x * (x * g2h - 4.779477332387385e-14) + 1.1470745597729725e-11)
        - 2.08767569878681e-09) + 2.755731922398589e-07))
    g2 = where(theta_b,
        x * (x * (x * (g2q - 2.48015873015873e-05) + 0.001388888888888889) - 0.041666666666666664) +
            0.5,
        closed2)
    g3h = (x
        * (x * (x * (9.183689863795546e-29 * x - 6.446950284384474e-26) + 3.868170170630684e-23)
        - 1.9572941063391263e-20) + 8.22063524662433e-18)
    g3q = (x
        * (x
        * (x * (x * (x * g3h - 2.8114572543455206e-15) + 7.647163731819816e-13)
        - 1.6059043836821613e-10) + 2.505210838544172e-08))
    g3 = where(middle_x_a,
        x * (x * (x * (g3q - 2.7557319223985893e-06) + 0.0001984126984126984) -
            0.008333333333333333) + 0.16666666666666666,
        closed3)
    beta_v_0 = v_0 * g3
    beta_v_1 = v_1 * g3
    beta_v_2 = v_2 * g3
    m_0 = v_0 * beta_v_0
    m_1 = v_1 * beta_v_1
    m_2 = v_2 * beta_v_2
    m_3 = v_1 * beta_v_0
    m_4 = v_2 * beta_v_0
    m_5 = v_2 * beta_v_1
    others_0 = m_1 + m_2
    others_1 = m_0 + m_2
    others_2 = m_0 + m_1
    diagonal0 = where(m_0 < others_0, g1 + m_0, 1 - others_0)
    diagonal1 = where(m_1 < others_1, g1 + m_1, 1 - others_1)
    diagonal2 = where(m_2 < others_2, g1 + m_2, 1 - others_2)
    alpha_v_0 = -(v_0 * g2)
    alpha_v_1 = -(v_1 * g2)
    alpha_v_2 = -(v_2 * g2)
    R_01 = m_3 - alpha_v_2
    R_02 = m_4 + alpha_v_1
    R_10 = m_3 + alpha_v_2
    R_12 = m_5 - alpha_v_0
    R_20 = m_4 - alpha_v_1
    R_21 = m_5 + alpha_v_0
    halved_0 = 0.5 * v_0
    halved_size_1 = absolute(v_0)
    halved_1 = 0.5 * v_1
    halved_size_3 = absolute(v_1)
    halved_2 = 0.5 * v_2
    halved_size_5 = absolute(v_2)
    y_a = halved_0 * halved_0
    y_a_padded_1 = c2 + 0.5 * halved_size_1
    y_b = halved_1 * halved_1
    y_b_padded_1 = c2 + 0.5 * halved_size_3
    y_c = y_a + y_b
    y_c_right_1 = y_c - y_a
    y_d = halved_2 * halved_2
    y_d_padded_1 = c2 + 0.5 * halved_size_5
    y = y_c + y_d
    y_right_1 = y - y_c
    y_c_lo = (product_rest(halved_0, halved_0, y_a, y_c - y_c_right_1)
        + product_rest(halved_1, halved_1, y_b, y_c_right_1))
    y_lo = y_c - (y - y_right_1) + product_rest(halved_2, halved_2, y_d, y_right_1) + y_c_lo
    y_size_1 = (y_a_padded_1 * y_a_padded_1 + y_b_padded_1 * y_b_padded_1 + y_d_padded_1
        * y_d_padded_1)
    half_angle = sqrt(y)
    half_angle_product_1 = half_angle * half_angle
    half_angle_residual_1 = (y - half_angle_product_1
        - product_error(half_angle, half_angle, half_angle_product_1) + y_lo)
    half_angle_lo = half_angle_residual_1 / where(half_angle == 0, 1, half_angle + half_angle)
    half_angle_padded_1 = c2 + y_size_1
    half_angle_bound_1 = absolute(y_lo) + c3 * half_angle_padded_1
    half_angle_size_6 = absolute(half_angle_lo)
    half_angle_size_4 = ((absolute(y) + c4 * half_angle_bound_1)
        * (half_angle_padded_1 / half_angle / y))
    half_angle_size_12 = (half_angle
        + where(4 * half_angle_bound_1 < y, half_angle_size_4, c5
        * (sqrt(half_angle_bound_1) + half_angle_size_6)))
    fine_sine, c = elementary.sincos(half_angle)
    fine_sine_own_error_1, c_own_error_1 = elementary.sincos_error(half_angle, fine_sine, c)
    fine_sine_half_1 = half_angle_lo * 0.5
    fine_sine_half_sin_1, fine_sine_half_cos_1 = elementary.sincos(fine_sine_half_1)
    fine_sine_twice_1 = fine_sine_half_sin_1 + fine_sine_half_sin_1
    fine_sine_padded_1 = c2 + half_angle_size_12
    fine_sine_size_1 = 1 + fine_sine_padded_1
    c_lo = (c_own_error_1 - (fine_sine_half_cos_1 * fine_sine + fine_sine_half_sin_1 * c)
        * fine_sine_twice_1)
    sinc_divisor_a = half_angle < 1.4901161193847656e-08
    sinc_divisor = where(sinc_divisor_a, 1.4901161193847656e-08, half_angle)
    sinc_divisor_lo = where(sinc_divisor_a, 0, half_angle_lo)
    sinc_divisor_bound_1 = half_angle_size_6 + c6 * fine_sine_padded_1
    sinc_divisor_size_4 = sinc_divisor_bound_1 < absolute(half_angle - 1.4901161193847656e-08)
    sinc_divisor_size_9 = (c7
        * where(sinc_divisor_size_4, 0, sinc_divisor_bound_1
        + absolute(1.4901161193847656e-08 - half_angle)))
    sinc_quotient = fine_sine / sinc_divisor
    sinc_quotient_product_1 = sinc_quotient * sinc_divisor
    sinc_quotient_exact_1 = (fine_sine - sinc_quotient_product_1
        - product_error(sinc_quotient, sinc_divisor, sinc_quotient_product_1))
    fine_sine_lo = (fine_sine_own_error_1
        + (fine_sine_half_cos_1 * c - fine_sine_half_sin_1 * fine_sine) * fine_sine_twice_1)
    sinc_quotient_lo = ((sinc_quotient_exact_1 + fine_sine_lo - sinc_quotient * sinc_divisor_lo)
        / sinc_divisor)
    sinc_quotient_padded_2 = (c2
        + (where(sinc_divisor_a, 1.4901161193847656e-08, half_angle_size_12) + sinc_divisor_size_9))
    sinc_quotient_size_1 = absolute(sinc_quotient)
    sinc_quotient_size_2 = absolute(sinc_divisor)
    sinc_quotient_bound_1 = absolute(sinc_divisor_lo) + c8 * sinc_quotient_padded_2
    sinc_quotient_size_7 = where(4 * sinc_quotient_bound_1 < sinc_quotient_size_2,
        sinc_quotient_size_2, 0)
    sinc_quotient_size_8 = ((c2 + fine_sine_size_1 + sinc_quotient_padded_2 * sinc_quotient_size_1)
        / sinc_quotient_size_7)
    sinc_quotient_size_11 = (sinc_quotient_size_1
        + (sinc_quotient_size_2 + c4 * sinc_quotient_bound_1) * sinc_quotient_size_8
        / sinc_quotient_size_2)
    sinc_a = 0.16666666666666666 * y
    sinc_b = 1 - sinc_a
    sinc_b_right_1 = 1 - sinc_b
    sinc_b_lo = (1 - (sinc_b + sinc_b_right_1)
        - product_rest(0.16666666666666666, y, sinc_a, sinc_b_right_1)
        - (c9 * y + 0.16666666666666666 * y_lo))
    sinc_b_size_1 = 1 + c10 * y_size_1
    sinc = where(sinc_divisor_a, sinc_b, sinc_quotient)
    sinc_lo = where(sinc_divisor_a, sinc_b_lo, sinc_quotient_lo)
    sinc_size_4 = (absolute(sinc_b_lo) + c11 * (c2 + sinc_b_size_1)
        + absolute(sinc_b - sinc_quotient))
    sinc_size_7 = (c13
        * where(sinc_divisor_size_4, 0, absolute(sinc_quotient_lo) + c12
        * (c2 + sinc_quotient_size_11) + sinc_size_4))
    fine_g1 = c * sinc
    fine_g1_cross_1 = c_lo * sinc + c * sinc_lo
    fine_g1_padded_1 = (c2
        + (where(sinc_divisor_a, sinc_b_size_1, sinc_quotient_size_11) + sinc_size_7))
    fine_g1_reach_2 = absolute(sinc) + c4 * (absolute(sinc_lo) + c15 * fine_g1_padded_1)
    fine_g1_size_5 = (fine_g1_padded_1
        * (absolute(c) + c4 * (absolute(c_lo) + c14 * fine_sine_size_1)) + fine_g1_reach_2
        * fine_sine_size_1)
    fine_g2a = sinc * sinc
    fine_g2a_size_1 = fine_g1_padded_1 * fine_g1_reach_2
    fine_g2 = 0.5 * fine_g2a
    fine_g2_cross2_1 = (0.5
        * (product_error(sinc, sinc, fine_g2a) + (sinc_lo * sinc + sinc * sinc_lo)))
    fine_rest3 = 1 - fine_g1
    fine_rest3_right_1 = 1 - fine_rest3
    fine_x = 4 * y
    fine_x_cross2_1 = 4 * y_lo
    fine_x_size_1 = 4 * y_size_1
    far_x_a = fine_x < 1
    fine_far_x = where(far_x_a, 1, fine_x)
    fine_far_x_lo = where(far_x_a, 0, fine_x_cross2_1)
    fine_far_x_padded_1 = c2 + fine_x_size_1
    fine_far_x_bound_1 = absolute(fine_x_cross2_1) + c16 * fine_far_x_padded_1
    fine_far_x_size_4 = fine_far_x_bound_1 < absolute(fine_x - 1)
    fine_closed3 = fine_rest3 / fine_far_x
    fine_closed3_product_1 = fine_closed3 * fine_far_x
    fine_rest3_lo = (1 - (fine_rest3 + fine_rest3_right_1)
        - product_rest(c, sinc, fine_g1, fine_rest3_right_1) - fine_g1_cross_1)
    fine_closed3_numerator_1 = (fine_rest3 - fine_closed3_product_1
        - product_error(fine_closed3, fine_far_x, fine_closed3_product_1) + fine_rest3_lo)
    fine_closed3_lo = (fine_closed3_numerator_1 - fine_closed3 * fine_far_x_lo) / fine_far_x
    fine_closed3_padded_2 = (c2
        + (where(far_x_a, 1, fine_x_size_1) + c17
        * where(fine_far_x_size_4, 0, fine_far_x_bound_1 + absolute(1 - fine_x))))
    fine_closed3_size_1 = absolute(fine_closed3)
    fine_closed3_size_2 = absolute(fine_far_x)
    fine_closed3_bound_1 = absolute(fine_far_x_lo) + c18 * fine_closed3_padded_2
    fine_closed3_size_7 = where(4 * fine_closed3_bound_1 < fine_closed3_size_2, fine_closed3_size_2,
        0)
    fine_closed3_size_8 = ((c2 + (1 + fine_g1_size_5) + fine_closed3_padded_2
        * fine_closed3_size_1) / fine_closed3_size_7)
    fine_closed3_size_11 = (fine_closed3_size_1 + (fine_closed3_size_2 + c4 * fine_closed3_bound_1)
        * fine_closed3_size_8 / fine_closed3_size_2)
    series5a = 1.216125041553518e-34 * fine_x
    series5b = 1.1309962886447716e-31 - series5a
    series5b_right_1 = 1.1309962886447716e-31 - series5b
    series5b_lo1_1 = (1.1309962886447716e-31 - (series5b + series5b_right_1)
        - product_rest(1.216125041553518e-34, fine_x, series5a, series5b_right_1))
    series5b_lo = series5b_lo1_1 - (c19 * fine_x + 1.216125041553518e-34 * fine_x_cross2_1) + c21
    series5c = fine_x * series5b
    series5c_padded_1 = c2 + (1.1309962886447716e-31 + c20 * fine_x_size_1)
    series5c_reach_1 = absolute(fine_x) + c4 * fine_far_x_bound_1
    series5c_size_4 = (fine_far_x_padded_1
        * (absolute(series5b) + c4 * (absolute(series5b_lo) + c22 * series5c_padded_1)))
    series5d = series5c - 9.183689863795546e-29
    series5d_right_1 = series5c - series5d
    series5d_lo2_1 = (product_rest(fine_x, series5b, series5c, series5d + series5d_right_1)
        - (9.183689863795546e-29 - series5d_right_1) - c23)
    series5d_lo = series5d_lo2_1 + (fine_x_cross2_1 * series5b + fine_x * series5b_lo)
    series5e = fine_x * series5d
    series5e_padded_1 = (c2
        + (9.183689863795546e-29 + (series5c_padded_1 * series5c_reach_1 + series5c_size_4)))
    series5e_size_3 = (fine_far_x_padded_1
        * (absolute(series5d) + c4 * (absolute(series5d_lo) + c24 * series5e_padded_1)))
    series5f = series5e + 6.446950284384474e-26
    series5f_right_1 = series5f - series5e
    series5f_lo2_1 = (product_rest(fine_x, series5d, series5e, series5f - series5f_right_1)
        + (6.446950284384474e-26 - series5f_right_1) + c25)
    series5f_lo = series5f_lo2_1 + (fine_x_cross2_1 * series5d + fine_x * series5d_lo)
    series5g = fine_x * series5f
    series5g_padded_1 = (c2
        + (6.446950284384474e-26 + (series5c_reach_1 * series5e_padded_1 + series5e_size_3)))
    series5g_size_3 = (fine_far_x_padded_1
        * (absolute(series5f) + c4 * (absolute(series5f_lo) + c26 * series5g_padded_1)))
    series5h = series5g - 3.868170170630684e-23
    series5h_right_1 = series5g - series5h
    series5h_lo2_1 = (product_rest(fine_x, series5f, series5g, series5h + series5h_right_1)
        - (3.868170170630684e-23 - series5h_right_1) - c27)
    series5h_lo = series5h_lo2_1 + (fine_x_cross2_1 * series5f + fine_x * series5f_lo)
    series5i = fine_x * series5h
    series5i_padded_1 = (c2
        + (3.868170170630684e-23 + (series5c_reach_1 * series5g_padded_1 + series5g_size_3)))
    series5i_size_3 = (fine_far_x_padded_1
        * (absolute(series5h) + c4 * (absolute(series5h_lo) + c28 * series5i_padded_1)))
    series5j = series5i + 1.9572941063391263e-20
    series5j_right_1 = series5j - series5i
    series5j_lo2_1 = (product_rest(fine_x, series5h, series5i, series5j - series5j_right_1)
        + (1.9572941063391263e-20 - series5j_right_1) + c29)
    series5j_lo = series5j_lo2_1 + (fine_x_cross2_1 * series5h + fine_x * series5h_lo)
    series5k = fine_x * series5j
    series5k_padded_1 = (c2
        + (1.9572941063391263e-20 + (series5c_reach_1 * series5i_padded_1 + series5i_size_3)))
    series5k_size_3 = (fine_far_x_padded_1
        * (absolute(series5j) + c4 * (absolute(series5j_lo) + c30 * series5k_padded_1)))
    series5l = series5k - 8.22063524662433e-18
    series5l_right_1 = series5k - series5l
    series5l_lo2_1 = (product_rest(fine_x, series5j, series5k, series5l + series5l_right_1)
        - (8.22063524662433e-18 - series5l_right_1) - c31)
    series5l_lo = series5l_lo2_1 + (fine_x_cross2_1 * series5j + fine_x * series5j_lo)
    series5m = fine_x * series5l
    series5m_padded_1 = (c2
        + (8.22063524662433e-18 + (series5c_reach_1 * series5k_padded_1 + series5k_size_3)))
    series5m_size_3 = (fine_far_x_padded_1
        * (absolute(series5l) + c4 * (absolute(series5l_lo) + c32 * series5m_padded_1)))
    series5n = series5m + 2.8114572543455206e-15
    series5n_right_1 = series5n - series5m
    series5n_lo2_1 = (product_rest(fine_x, series5l, series5m, series5n - series5n_right_1)
        + (2.8114572543455206e-15 - series5n_right_1) + c33)
    series5n_lo = series5n_lo2_1 + (fine_x_cross2_1 * series5l + fine_x * series5l_lo)
    series5o = fine_x * series5n
    series5o_padded_1 = (c2
        + (2.8114572543455206e-15 + (series5c_reach_1 * series5m_padded_1 + series5m_size_3)))
    series5o_size_3 = (fine_far_x_padded_1
        * (absolute(series5n) + c4 * (absolute(series5n_lo) + c34 * series5o_padded_1)))
    series5p = series5o - 7.647163731819816e-13
    series5p_right_1 = series5o - series5p
    series5p_lo2_1 = (product_rest(fine_x, series5n, series5o, series5p + series5p_right_1)
        - (7.647163731819816e-13 - series5p_right_1) - c35)
    series5p_lo = series5p_lo2_1 + (fine_x_cross2_1 * series5n + fine_x * series5n_lo)
    series5q = fine_x * series5p
    series5q_padded_1 = (c2
        + (7.647163731819816e-13 + (series5c_reach_1 * series5o_padded_1 + series5o_size_3)))
    series5q_size_3 = (fine_far_x_padded_1
        * (absolute(series5p) + c4 * (absolute(series5p_lo) + c36 * series5q_padded_1)))
    series5r = series5q + 1.6059043836821613e-10
    series5r_right_1 = series5r - series5q
    series5r_lo2_1 = (product_rest(fine_x, series5p, series5q, series5r - series5r_right_1)
        + (1.6059043836821613e-10 - series5r_right_1) + c37)
    series5r_lo = series5r_lo2_1 + (fine_x_cross2_1 * series5p + fine_x * series5p_lo)
    series5s = fine_x * series5r
    series5s_padded_1 = (c2
        + (1.6059043836821613e-10 + (series5c_reach_1 * series5q_padded_1 + series5q_size_3)))
    series5s_size_3 = (fine_far_x_padded_1
        * (absolute(series5r) + c4 * (absolute(series5r_lo) + c38 * series5s_padded_1)))
    series5t = series5s - 2.505210838544172e-08
    series5t_right_1 = series5s - series5t
    series5t_lo2_1 = (product_rest(fine_x, series5r, series5s, series5t + series5t_right_1)
        - (2.505210838544172e-08 - series5t_right_1) - c39)
    series5t_lo = series5t_lo2_1 + (fine_x_cross2_1 * series5r + fine_x * series5r_lo)
    series5u = fine_x * series5t
    series5u_padded_1 = (c2
        + (2.505210838544172e-08 + (series5c_reach_1 * series5s_padded_1 + series5s_size_3)))
    series5u_size_3 = (fine_far_x_padded_1
        * (absolute(series5t) + c4 * (absolute(series5t_lo) + c40 * series5u_padded_1)))
    series5v = series5u + 2.7557319223985893e-06
    series5v_right_1 = series5v - series5u
    series5v_lo2_1 = (product_rest(fine_x, series5t, series5u, series5v - series5v_right_1)
        + (2.7557319223985893e-06 - series5v_right_1) + c41)
    series5v_lo = series5v_lo2_1 + (fine_x_cross2_1 * series5t + fine_x * series5t_lo)
    series5w = fine_x * series5v
    series5w_padded_1 = (c2
        + (2.7557319223985893e-06 + (series5c_reach_1 * series5u_padded_1 + series5u_size_3)))
    series5w_size_3 = (fine_far_x_padded_1
        * (absolute(series5v) + c4 * (absolute(series5v_lo) + c42 * series5w_padded_1)))
    series5x = series5w - 0.0001984126984126984
    series5x_right_1 = series5w - series5x
    series5x_lo2_1 = (product_rest(fine_x, series5v, series5w, series5x + series5x_right_1)
        - (0.0001984126984126984 - series5x_right_1) - c43)
    series5x_lo = series5x_lo2_1 + (fine_x_cross2_1 * series5v + fine_x * series5v_lo)
    series5y = fine_x * series5x
    series5y_padded_1 = (c2
        + (0.0001984126984126984 + (series5c_reach_1 * series5w_padded_1 + series5w_size_3)))
    series5y_size_3 = (fine_far_x_padded_1
        * (absolute(series5x) + c4 * (absolute(series5x_lo) + c44 * series5y_padded_1)))
    series5 = series5y + 0.008333333333333333
    series5_right_1 = series5 - series5y
    series5_lo2_1 = (product_rest(fine_x, series5x, series5y, series5 - series5_right_1)
        + (0.008333333333333333 - series5_right_1) + c45)
    series5_lo = series5_lo2_1 + (fine_x_cross2_1 * series5x + fine_x * series5x_lo)
    fine_g3a = fine_x * series5
    fine_g3a_padded_1 = (c2
        + (0.008333333333333333 + (series5c_reach_1 * series5y_padded_1 + series5y_size_3)))
    fine_g3a_size_3 = (fine_far_x_padded_1
        * (absolute(series5) + c4 * (absolute(series5_lo) + c46 * fine_g3a_padded_1)))
    fine_g3b = 0.16666666666666666 - fine_g3a
    fine_g3b_right_1 = 0.16666666666666666 - fine_g3b
    fine_g3b_lo1_1 = (0.16666666666666666 - (fine_g3b + fine_g3b_right_1)
        - product_rest(fine_x, series5, fine_g3a, fine_g3b_right_1))
    fine_g3b_lo = fine_g3b_lo1_1 - (fine_x_cross2_1 * series5 + fine_x * series5_lo) + c9
    fine_g3b_size_1 = 0.16666666666666666 + (fine_g3a_padded_1 * series5c_reach_1 + fine_g3a_size_3)
    fine_g3 = where(far_x_a, fine_g3b, fine_closed3)
    fine_g3_lo = where(far_x_a, fine_g3b_lo, fine_closed3_lo)
    fine_g3_size_4 = (absolute(fine_g3b_lo) + c47 * (c2 + fine_g3b_size_1)
        + absolute(fine_g3b - fine_closed3))
    fine_g3_size_7 = (c49
        * where(fine_far_x_size_4, 0, absolute(fine_closed3_lo) + c48 * (c2 + fine_closed3_size_11)
        + fine_g3_size_4))
    fine_beta_v_0 = v_0 * fine_g3
    fine_beta_v_padded_1 = (c2
        + (where(far_x_a, fine_g3b_size_1, fine_closed3_size_11) + fine_g3_size_7))
    fine_beta_v_1 = v_1 * fine_g3
    fine_beta_v_2 = v_2 * fine_g3
    fine_beta_v_lo_1 = product_error(v_0, fine_g3, fine_beta_v_0) + v_0 * fine_g3_lo
    fine_m_0 = v_0 * fine_beta_v_0
    fine_m_cross2_1 = v_0 * fine_beta_v_lo_1
    fine_m_padded_1 = c2 + fine_beta_v_padded_1 * halved_size_1
    fine_m_size_1 = fine_m_padded_1 * halved_size_1
    fine_beta_v_lo_2 = product_error(v_1, fine_g3, fine_beta_v_1) + v_1 * fine_g3_lo
    fine_m_1 = v_1 * fine_beta_v_1
    fine_m_cross2_2 = v_1 * fine_beta_v_lo_2
    fine_m_padded_2 = c2 + fine_beta_v_padded_1 * halved_size_3
    fine_m_size_2 = fine_m_padded_2 * halved_size_3
    fine_m_2 = v_2 * fine_beta_v_2
    fine_m_cross2_3 = v_2 * (product_error(v_2, fine_g3, fine_beta_v_2) + v_2 * fine_g3_lo)
    fine_m_size_3 = (c2 + fine_beta_v_padded_1 * halved_size_5) * halved_size_5
    fine_m_3 = v_1 * fine_beta_v_0
    fine_m_cross2_4 = v_1 * fine_beta_v_lo_1
    fine_m_4 = v_2 * fine_beta_v_0
    fine_m_cross2_5 = v_2 * fine_beta_v_lo_1
    fine_m_5 = v_2 * fine_beta_v_1
    fine_m_cross2_6 = v_2 * fine_beta_v_lo_2
    fine_others_0 = fine_m_1 + fine_m_2
    fine_others_right_1 = fine_others_0 - fine_m_1
    fine_others_left_rest_1 = product_rest(v_1, fine_beta_v_1, fine_m_1,
        fine_others_0 - fine_others_right_1)
    fine_others_lo_1 = (fine_others_left_rest_1
        + product_rest(v_2, fine_beta_v_2, fine_m_2, fine_others_right_1)
        + (fine_m_cross2_2 + fine_m_cross2_3))
    fine_others_size_1 = fine_m_size_2 + fine_m_size_3
    fine_others_1 = fine_m_0 + fine_m_2
    fine_others_right_2 = fine_others_1 - fine_m_0
    fine_others_left_rest_2 = product_rest(v_0, fine_beta_v_0, fine_m_0,
        fine_others_1 - fine_others_right_2)
    fine_others_lo_2 = (fine_others_left_rest_2
        + product_rest(v_2, fine_beta_v_2, fine_m_2, fine_others_right_2)
        + (fine_m_cross2_1 + fine_m_cross2_3))
    fine_others_size_2 = fine_m_size_1 + fine_m_size_3
    fine_others_2 = fine_m_0 + fine_m_1
    fine_others_right_3 = fine_others_2 - fine_m_0
    fine_others_left_rest_3 = product_rest(v_0, fine_beta_v_0, fine_m_0,
        fine_others_2 - fine_others_right_3)
    fine_others_lo_3 = (fine_others_left_rest_3
        + product_rest(v_1, fine_beta_v_1, fine_m_1, fine_others_right_3)
        + (fine_m_cross2_1 + fine_m_cross2_2))
    fine_others_size_3 = fine_m_size_1 + fine_m_size_2
    fine_diagonal0a = 1 - fine_others_0
    fine_diagonal0a_right_1 = 1 - fine_diagonal0a
    fine_diagonal0a_lo = (1 - (fine_diagonal0a + fine_diagonal0a_right_1)
        - (fine_others_0 - fine_diagonal0a_right_1) - fine_others_lo_1)
    fine_diagonal0a_size_1 = 1 + fine_others_size_1
    fine_diagonal0b = fine_g1 + fine_m_0
    fine_diagonal0b_right_1 = fine_diagonal0b - fine_g1
    fine_diagonal0b_left_rest_1 = product_rest(c, sinc, fine_g1,
        fine_diagonal0b - fine_diagonal0b_right_1)
    fine_diagonal0b_lo1_1 = (fine_diagonal0b_left_rest_1
        + product_rest(v_0, fine_beta_v_0, fine_m_0, fine_diagonal0b_right_1))
    fine_diagonal0b_lo = fine_diagonal0b_lo1_1 + (fine_g1_cross_1 + fine_m_cross2_1)
    fine_diagonal0b_size_1 = fine_g1_size_5 + fine_m_size_1
    fine_diagonal0c = fine_m_0 < fine_others_0
    fine_diagonal0_bound_1 = (absolute(product_error(v_0, fine_beta_v_0, fine_m_0)
        + fine_m_cross2_1) + c50 * (c2 + fine_m_size_1))
    fine_diagonal0_size_8 = (absolute(fine_diagonal0b_lo) + c51 * (c2 + fine_diagonal0b_size_1)
        + absolute(fine_diagonal0b - fine_diagonal0a))
    fine_diagonal0_size_5 = (fine_diagonal0_bound_1
        + (absolute(fine_others_lo_1) + c51 * (c2 + fine_others_size_1))
        < absolute(fine_m_0 - fine_others_0))
    fine_diagonal0_size_10 = where(fine_diagonal0_size_5, 0,
        absolute(fine_diagonal0a_lo) + c52 * (c2 + fine_diagonal0a_size_1) + fine_diagonal0_size_8)
    fine_diagonal1a = 1 - fine_others_1
    fine_diagonal1a_right_1 = 1 - fine_diagonal1a
    fine_diagonal1a_lo = (1 - (fine_diagonal1a + fine_diagonal1a_right_1)
        - (fine_others_1 - fine_diagonal1a_right_1) - fine_others_lo_2)
    fine_diagonal1a_size_1 = 1 + fine_others_size_2
    fine_diagonal1b = fine_g1 + fine_m_1
    fine_diagonal1b_right_1 = fine_diagonal1b - fine_g1
    fine_diagonal1b_left_rest_1 = product_rest(c, sinc, fine_g1,
        fine_diagonal1b - fine_diagonal1b_right_1)
    fine_diagonal1b_lo1_1 = (fine_diagonal1b_left_rest_1
        + product_rest(v_1, fine_beta_v_1, fine_m_1, fine_diagonal1b_right_1))
    fine_diagonal1b_lo = fine_diagonal1b_lo1_1 + (fine_g1_cross_1 + fine_m_cross2_2)
    fine_diagonal1b_size_1 = fine_g1_size_5 + fine_m_size_2
    fine_diagonal1c = fine_m_1 < fine_others_1
    fine_diagonal1_bound_1 = (absolute(product_error(v_1, fine_beta_v_1, fine_m_1)
        + fine_m_cross2_2) + c50 * (c2 + fine_m_size_2))
    fine_diagonal1_size_8 = (absolute(fine_diagonal1b_lo) + c51 * (c2 + fine_diagonal1b_size_1)
        + absolute(fine_diagonal1b - fine_diagonal1a))
    fine_diagonal1_size_5 = (fine_diagonal1_bound_1
        + (absolute(fine_others_lo_2) + c51 * (c2 + fine_others_size_2))
        < absolute(fine_m_1 - fine_others_1))
    fine_diagonal1_size_10 = where(fine_diagonal1_size_5, 0,
        absolute(fine_diagonal1a_lo) + c52 * (c2 + fine_diagonal1a_size_1) + fine_diagonal1_size_8)
    fine_diagonal2a = 1 - fine_others_2
    fine_diagonal2a_right_1 = 1 - fine_diagonal2a
    fine_diagonal2a_lo = (1 - (fine_diagonal2a + fine_diagonal2a_right_1)
        - (fine_others_2 - fine_diagonal2a_right_1) - fine_others_lo_3)
    fine_diagonal2a_size_1 = 1 + fine_others_size_3
    fine_diagonal2b = fine_g1 + fine_m_2
    fine_diagonal2b_right_1 = fine_diagonal2b - fine_g1
    fine_diagonal2b_left_rest_1 = product_rest(c, sinc, fine_g1,
        fine_diagonal2b - fine_diagonal2b_right_1)
    fine_diagonal2b_lo1_1 = (fine_diagonal2b_left_rest_1
        + product_rest(v_2, fine_beta_v_2, fine_m_2, fine_diagonal2b_right_1))
    fine_diagonal2b_lo = fine_diagonal2b_lo1_1 + (fine_g1_cross_1 + fine_m_cross2_3)
    fine_diagonal2b_size_1 = fine_g1_size_5 + fine_m_size_3
    fine_diagonal2c = fine_m_2 < fine_others_2
    fine_diagonal2_bound_1 = (absolute(product_error(v_2, fine_beta_v_2, fine_m_2)
        + fine_m_cross2_3) + c50 * (c2 + fine_m_size_3))
    fine_diagonal2_size_8 = (absolute(fine_diagonal2b_lo) + c51 * (c2 + fine_diagonal2b_size_1)
        + absolute(fine_diagonal2b - fine_diagonal2a))
    fine_diagonal2_size_5 = (fine_diagonal2_bound_1
        + (absolute(fine_others_lo_3) + c51 * (c2 + fine_others_size_3))
        < absolute(fine_m_2 - fine_others_2))
    fine_diagonal2_size_10 = where(fine_diagonal2_size_5, 0,
        absolute(fine_diagonal2a_lo) + c52 * (c2 + fine_diagonal2a_size_1) + fine_diagonal2_size_8)
    fine_alpha_v_0a_padded_1 = c2 + 0.5 * (fine_g2a_size_1 + fine_g2a_size_1)
    fine_alpha_v_0 = -(v_0 * fine_g2)
    fine_alpha_v_cross_1 = -(v_0 * fine_g2_cross2_1)
    fine_alpha_v_factor_1 = -v_0
    fine_alpha_v_1 = -(v_1 * fine_g2)
    fine_alpha_v_cross_2 = -(v_1 * fine_g2_cross2_1)
    fine_alpha_v_factor_2 = -v_1
    fine_alpha_v_2 = -(v_2 * fine_g2)
    fine_alpha_v_cross_3 = -(v_2 * fine_g2_cross2_1)
    fine_alpha_v_factor_3 = -v_2
    fine_R_01 = fine_m_3 - fine_alpha_v_2
    fine_R_right_1 = fine_m_3 - fine_R_01
    fine_R_right_rest_1 = product_rest(fine_alpha_v_factor_3, fine_g2, fine_alpha_v_2,
        fine_R_right_1)
    fine_R_02 = fine_m_4 + fine_alpha_v_1
    fine_R_right_2 = fine_R_02 - fine_m_4
    fine_R_right_rest_2 = product_rest(fine_alpha_v_factor_2, fine_g2, fine_alpha_v_1,
        fine_R_right_2)
    fine_R_10 = fine_m_3 + fine_alpha_v_2
    fine_R_right_3 = fine_R_10 - fine_m_3
    fine_R_right_rest_3 = product_rest(fine_alpha_v_factor_3, fine_g2, fine_alpha_v_2,
        fine_R_right_3)
    fine_R_12 = fine_m_5 - fine_alpha_v_0
    fine_R_right_4 = fine_m_5 - fine_R_12
    fine_R_right_rest_4 = product_rest(fine_alpha_v_factor_1, fine_g2, fine_alpha_v_0,
        fine_R_right_4)
    fine_R_20 = fine_m_4 - fine_alpha_v_1
    fine_R_right_5 = fine_m_4 - fine_R_20
    fine_R_right_rest_5 = product_rest(fine_alpha_v_factor_2, fine_g2, fine_alpha_v_1,
        fine_R_right_5)
    fine_R_21 = fine_m_5 + fine_alpha_v_0
    fine_R_right_6 = fine_R_21 - fine_m_5
    fine_R_right_rest_6 = product_rest(fine_alpha_v_factor_1, fine_g2, fine_alpha_v_0,
        fine_R_right_6)
    diagonal0_apart_1 = where(fine_diagonal0c, fine_diagonal0b, fine_diagonal0a) - diagonal0
    diagonal0_rest_1 = (c55
        * (c2
        + (where(fine_diagonal0c, fine_diagonal0b_size_1, fine_diagonal0a_size_1) + c53
        * fine_diagonal0_size_10)))
    fine_R_lo_1 = (product_rest(v_1, fine_beta_v_0, fine_m_3, fine_R_01 + fine_R_right_1)
        - fine_R_right_rest_1 + (fine_m_cross2_4 - fine_alpha_v_cross_3))
    R_rest_1 = (c51
        * (c2 + (fine_alpha_v_0a_padded_1 * halved_size_5 + fine_m_padded_1 * halved_size_3)))
    fine_R_lo_2 = (product_rest(v_2, fine_beta_v_0, fine_m_4, fine_R_02 - fine_R_right_2)
        + fine_R_right_rest_2 + (fine_m_cross2_5 + fine_alpha_v_cross_2))
    R_rest_2 = (c51
        * (c2 + (fine_alpha_v_0a_padded_1 * halved_size_3 + fine_m_padded_1 * halved_size_5)))
    fine_R_lo_3 = (product_rest(v_1, fine_beta_v_0, fine_m_3, fine_R_10 - fine_R_right_3)
        + fine_R_right_rest_3 + (fine_m_cross2_4 + fine_alpha_v_cross_3))
    diagonal1_apart_1 = where(fine_diagonal1c, fine_diagonal1b, fine_diagonal1a) - diagonal1
    diagonal1_rest_1 = (c55
        * (c2
        + (where(fine_diagonal1c, fine_diagonal1b_size_1, fine_diagonal1a_size_1) + c53
        * fine_diagonal1_size_10)))
    fine_R_lo_4 = (product_rest(v_2, fine_beta_v_1, fine_m_5, fine_R_12 + fine_R_right_4)
        - fine_R_right_rest_4 + (fine_m_cross2_6 - fine_alpha_v_cross_1))
    R_rest_3 = (c51
        * (c2 + (fine_alpha_v_0a_padded_1 * halved_size_1 + fine_m_padded_2 * halved_size_5)))
    fine_R_lo_5 = (product_rest(v_2, fine_beta_v_0, fine_m_4, fine_R_20 + fine_R_right_5)
        - fine_R_right_rest_5 + (fine_m_cross2_5 - fine_alpha_v_cross_2))
    fine_R_lo_6 = (product_rest(v_2, fine_beta_v_1, fine_m_5, fine_R_21 - fine_R_right_6)
        + fine_R_right_rest_6 + (fine_m_cross2_6 + fine_alpha_v_cross_1))
    diagonal2_apart_1 = where(fine_diagonal2c, fine_diagonal2b, fine_diagonal2a) - diagonal2
    diagonal2_rest_1 = (c55
        * (c2
        + (where(fine_diagonal2c, fine_diagonal2b_size_1, fine_diagonal2a_size_1) + c53
        * fine_diagonal2_size_10)))
    diagonal0_bound_1 = (c54
        * absolute(diagonal0_apart_1
        + where(fine_diagonal0c, fine_diagonal0b_lo, fine_diagonal0a_lo)) + diagonal0_rest_1)
    R_bound_1 = c54 * absolute(fine_R_01 - R_01 + fine_R_lo_1) + R_rest_1
    R_bound_2 = c54 * absolute(fine_R_02 - R_02 + fine_R_lo_2) + R_rest_2
    R_bound_3 = c54 * absolute(fine_R_10 - R_10 + fine_R_lo_3) + R_rest_1
    diagonal1_bound_1 = (c54
        * absolute(diagonal1_apart_1
        + where(fine_diagonal1c, fine_diagonal1b_lo, fine_diagonal1a_lo)) + diagonal1_rest_1)
    R_bound_4 = c54 * absolute(fine_R_12 - R_12 + fine_R_lo_4) + R_rest_3
    R_bound_5 = c54 * absolute(fine_R_20 - R_20 + fine_R_lo_5) + R_rest_2
    R_bound_6 = c54 * absolute(fine_R_21 - R_21 + fine_R_lo_6) + R_rest_3
    diagonal2_bound_1 = (c54
        * absolute(diagonal2_apart_1
        + where(fine_diagonal2c, fine_diagonal2b_lo, fine_diagonal2a_lo)) + diagonal2_rest_1)
    return (diagonal0, R_01, R_02, R_10, diagonal1, R_12, R_20, R_21, diagonal2, diagonal0_bound_1,
        R_bound_1, R_bound_2, R_bound_3, diagonal1_bound_1, R_bound_4, R_bound_5, R_bound_6,
        diagonal2_bound_1)


@kernel("(3)->(3,3),(3,3)")
@errstate(all="ignore")
def SO3_leftJacobianInverse(v, *, c1=268435456, c2=1.8051943758648296e-276,
        c3=2.5021685128863245e-30, c4=140737488355328, c5=2.567393169377981e+29,
        c6=4.240128211918887e-30, c7=9.054644677292507e+28, c8=1.1389183198259759e-29,
        c9=9.25185853854297e-18, c10=2290649224.7000003, c11=8.120831909935717e-28,
        c12=1.8842277118313698e-29, c13=1.2325982855554354e+27, c14=4.7410392187559056e-48,
        c15=6.843135825984986e-08, c16=-1.8714974010023092e-45, c17=2.3296034284323186e-42,
        c18=8.17876581047362e-28, c19=3.161967936521494e-40, c20=8.238918382307457e-28,
        c21=3.2266760594119493e-37, c22=8.301289625437229e-28, c23=-1.2521244741738012e-34,
        c24=8.36587954080333e-28, c25=7.23242424407352e-33, c26=8.432688128405761e-28,
        c27=5.8681293750286156e-30, c28=8.501715387304126e-28, c29=5.034117835500839e-27,
        c30=8.572961317498427e-28, c31=-1.7546051379703029e-25, c32=8.64642591898866e-28,
        c33=4.7926555569351065e-23, c34=8.722109191774827e-28, c35=-4.460143857711533e-21,
        c36=8.800011135856928e-28, c37=-2.147752875018904e-19, c38=8.880131751234963e-28,
        c39=4.625929269271486e-19, c40=2.8103175390871538e-30, c41=8.962471037908933e-28,
        c42=1.850371707708594e-17, c43=6.338251187752959e+28, c44=1.6270262376793602e-29,
        c45=9.075379655148354e-28, c46=8.245490617302283e-28, c47=1.1062092690083102e+27,
        c48=8.125024661305438e-28, c49=8.120832873841084e-28, c50=9.513982289044683e-28,
        c51=9.550468072637709e-28, c52=9.58769341332938e-28, c53=1.0474204728201347e+27,
        c54=1.0000000000000009, c55=9.587694380055934e-28):
    """R = J_l(v)^-1 = I - v~/2 + (1 - θ/2 cot θ/2)/θ^2 v~^2, θ = |v|; singular at multiples of 2π
    except 0; |error of R| <= R_bound unless inf or NaN.

    (3)->(3,3),(3,3).  v: vector; R, R_bound: rotation or other 3×3 matrix.
    420 mul, 746 add, 23 product error, 34 product rest, 23 div, 3 sqrt, 6 neg, 93 abs, 23 less,
    1 equal, 47 select.
    """
    v_0, v_1, v_2 = v
    size_0 = absolute(v_0)
    size_1 = absolute(v_1)
    size_2 = absolute(v_2)
    sizes = size_0 + size_1 + size_2
    grid = sizes * c1
    shifted_0 = v_0 + grid
    shifted_1 = v_1 + grid
    shifted_2 = v_2 + grid
    high_0 = shifted_0 - grid
    high_1 = shifted_1 - grid
    high_2 = shifted_2 - grid
    low_0 = v_0 - high_0
    low_1 = v_1 - high_1
    low_2 = v_2 - high_2
    sum_0 = v_0 + high_0
    sum_1 = v_1 + high_1
    sum_2 = v_2 + high_2
    squares = high_0 * high_0 + high_1 * high_1 + high_2 * high_2
    cross = low_0 * sum_0 + low_1 * sum_1 + low_2 * sum_2
    x = squares + cross
    theta_b = x < 1
    theta = where(theta_b, 1, sqrt(x))
    theta_shifted = grid + theta
    theta_high = theta_shifted - grid
    theta_low = theta - theta_high
    theta_sum = theta + theta_high
    cross_rest = cross - theta_low * theta_sum
    exact = squares - theta_high * theta_high
    residual = cross_rest + exact
    small = 0.5 * residual / theta
    delta = where(absolute(small) < 0.0078125, small, 0)
    far_sine_a, far_cosine_a = elementary.sincos(theta)
    far_sine = where(theta_b, 1, far_sine_a)
    far_cosine = where(theta_b, 0, far_cosine_a)
    sine = delta * far_cosine + far_sine
    cosine = far_cosine - delta * far_sine
    above_b = cosine < 0
    above = where(above_b, sine, cosine + 1)
    below = where(above_b, 1 - cosine, sine)
    cotangent = above / below
    half_cotangent = 0.5 * theta * cotangent
    b_rest = 1 - half_cotangent
    b_divisor_a = x < 4
    b_divisor = where(b_divisor_a, 4, x)
    closed_b = b_rest / b_divisor
    b_h = (x
        * (x * (x * (1.455172475614865e-27 * x + 5.744790668872202e-26) + 2.267952452337683e-24)
        + 8.953517427037546e-23) + 3.534707039629467e-21)
    b_q = (x
        * (x
        * (x * (x * (x * b_h + 1.3954464685812522e-19) + 5.5090028283602295e-18)
        + 2.174868698558062e-16) + 8.586062056277845e-15))
    b_y = (x
        * (x
        * (x * (x * (b_q + 3.3896802963225827e-13) + 1.3382536530684679e-11)
        + 5.284190138687493e-10) + 2.08767569878681e-08))
    b = where(b_divisor_a,
        x * (x * (x * (b_y + 8.267195767195768e-07) + 3.306878306878307e-05) + 0.001388888888888889)
            + 0.08333333333333333,
        closed_b)
    b_across = where(b_divisor_a, 1 - x * b, half_cotangent)
    beta_v_0 = v_0 * b
    beta_v_1 = v_1 * b
    beta_v_2 = v_2 * b
    m_0 = v_0 * beta_v_0
    m_1 = v_1 * beta_v_1
    m_2 = v_2 * beta_v_2
    m_3 = v_1 * beta_v_0
    m_4 = v_2 * beta_v_0
    m_5 = v_2 * beta_v_1
    others_0 = m_1 + m_2
    others_1 = m_0 + m_2
    others_2 = m_0 + m_1
    diagonal0 = where(m_0 < others_0, b_across + m_0, 1 - others_0)
    diagonal1 = where(m_1 < others_1, b_across + m_1, 1 - others_1)
    diagonal2 = where(m_2 < others_2, b_across + m_2, 1 - others_2)
    alpha_v_0 = -(0.5 * v_0)
    alpha_v_1 = -(0.5 * v_1)
    alpha_v_2 = -(0.5 * v_2)
    R_01 = m_3 - alpha_v_2
    R_02 = m_4 + alpha_v_1
    R_10 = m_3 + alpha_v_2
    R_12 = m_5 - alpha_v_0
    R_20 = m_4 - alpha_v_1
    R_21 = m_5 + alpha_v_0
    halved_0 = 0.5 * v_0
    halved_size_1 = absolute(v_0)
    halved_size_2 = 0.5 * halved_size_1
    halved_1 = 0.5 * v_1
    halved_size_3 = absolute(v_1)
    halved_size_4 = 0.5 * halved_size_3
    halved_2 = 0.5 * v_2
    halved_size_5 = absolute(v_2)
    halved_size_6 = 0.5 * halved_size_5
    y_a = halved_0 * halved_0
    y_a_padded_1 = c2 + halved_size_2
    y_b = halved_1 * halved_1
    y_b_padded_1 = c2 + halved_size_4
    y_c = y_a + y_b
    y_c_right_1 = y_c - y_a
    y_d = halved_2 * halved_2
    y_d_padded_1 = c2 + halved_size_6
    y = y_c + y_d
    y_right_1 = y - y_c
    y_c_lo = (product_rest(halved_0, halved_0, y_a, y_c - y_c_right_1)
        + product_rest(halved_1, halved_1, y_b, y_c_right_1))
    y_lo = y_c - (y - y_right_1) + product_rest(halved_2, halved_2, y_d, y_right_1) + y_c_lo
    y_size_1 = (y_a_padded_1 * y_a_padded_1 + y_b_padded_1 * y_b_padded_1 + y_d_padded_1
        * y_d_padded_1)
    half_angle = sqrt(y)
    half_angle_product_1 = half_angle * half_angle
    half_angle_residual_1 = (y - half_angle_product_1
        - product_error(half_angle, half_angle, half_angle_product_1) + y_lo)
    half_angle_lo = half_angle_residual_1 / where(half_angle == 0, 1, half_angle + half_angle)
    half_angle_padded_1 = c2 + y_size_1
    half_angle_bound_1 = absolute(y_lo) + c3 * half_angle_padded_1
    half_angle_reach_1 = absolute(y) + c4 * half_angle_bound_1
    half_angle_size_6 = absolute(half_angle_lo)
    half_angle_size_4 = half_angle_reach_1 * (half_angle_padded_1 / half_angle / y)
    half_angle_size_12 = (half_angle
        + where(4 * half_angle_bound_1 < y, half_angle_size_4, c5
        * (sqrt(half_angle_bound_1) + half_angle_size_6)))
    fine_sine, c = elementary.sincos(half_angle)
    fine_sine_own_error_1, c_own_error_1 = elementary.sincos_error(half_angle, fine_sine, c)
    fine_sine_half_1 = half_angle_lo * 0.5
    fine_sine_half_sin_1, fine_sine_half_cos_1 = elementary.sincos(fine_sine_half_1)
    fine_sine_twice_1 = fine_sine_half_sin_1 + fine_sine_half_sin_1
    fine_sine_padded_1 = c2 + half_angle_size_12
    fine_sine_size_1 = 1 + fine_sine_padded_1
    c_lo = (c_own_error_1 - (fine_sine_half_cos_1 * fine_sine + fine_sine_half_sin_1 * c)
        * fine_sine_twice_1)
    sinc_divisor_a = half_angle < 1.4901161193847656e-08
    sinc_divisor = where(sinc_divisor_a, 1.4901161193847656e-08, half_angle)
    sinc_divisor_lo = where(sinc_divisor_a, 0, half_angle_lo)
    sinc_divisor_bound_1 = half_angle_size_6 + c6 * fine_sine_padded_1
    sinc_divisor_size_4 = sinc_divisor_bound_1 < absolute(half_angle - 1.4901161193847656e-08)
    sinc_divisor_size_9 = (c7
        * where(sinc_divisor_size_4, 0, sinc_divisor_bound_1
        + absolute(1.4901161193847656e-08 - half_angle)))
    sinc_quotient = fine_sine / sinc_divisor
    sinc_quotient_product_1 = sinc_quotient * sinc_divisor
    sinc_quotient_exact_1 = (fine_sine - sinc_quotient_product_1
        - product_error(sinc_quotient, sinc_divisor, sinc_quotient_product_1))
    fine_sine_lo = (fine_sine_own_error_1
        + (fine_sine_half_cos_1 * c - fine_sine_half_sin_1 * fine_sine) * fine_sine_twice_1)
    sinc_quotient_lo = ((sinc_quotient_exact_1 + fine_sine_lo - sinc_quotient * sinc_divisor_lo)
        / sinc_divisor)
    sinc_quotient_padded_1 = c2 + fine_sine_size_1
    sinc_quotient_padded_2 = (c2
        + (where(sinc_divisor_a, 1.4901161193847656e-08, half_angle_size_12) + sinc_divisor_size_9))
    sinc_quotient_size_1 = absolute(sinc_quotient)
    sinc_quotient_size_2 = absolute(sinc_divisor)
    sinc_quotient_bound_1 = absolute(sinc_divisor_lo) + c8 * sinc_quotient_padded_2
    sinc_quotient_size_7 = where(4 * sinc_quotient_bound_1 < sinc_quotient_size_2,
        sinc_quotient_size_2, 0)
    sinc_quotient_size_8 = ((sinc_quotient_padded_1 + sinc_quotient_padded_2
        * sinc_quotient_size_1) / sinc_quotient_size_7)
    sinc_quotient_size_11 = (sinc_quotient_size_1
        + (sinc_quotient_size_2 + c4 * sinc_quotient_bound_1) * sinc_quotient_size_8
        / sinc_quotient_size_2)
    sinc_a = 0.16666666666666666 * y
    sinc_b = 1 - sinc_a
    sinc_b_right_1 = 1 - sinc_b
    sinc_b_lo = (1 - (sinc_b + sinc_b_right_1)
        - product_rest(0.16666666666666666, y, sinc_a, sinc_b_right_1)
        - (c9 * y + 0.16666666666666666 * y_lo))
    sinc_b_size_1 = 1 + c10 * y_size_1
    sinc = where(sinc_divisor_a, sinc_b, sinc_quotient)
    sinc_lo = where(sinc_divisor_a, sinc_b_lo, sinc_quotient_lo)
    sinc_size_4 = (absolute(sinc_b_lo) + c11 * (c2 + sinc_b_size_1)
        + absolute(sinc_b - sinc_quotient))
    sinc_size_7 = (c13
        * where(sinc_divisor_size_4, 0, absolute(sinc_quotient_lo) + c12
        * (c2 + sinc_quotient_size_11) + sinc_size_4))
    sinc_size_8 = where(sinc_divisor_a, sinc_b_size_1, sinc_quotient_size_11) + sinc_size_7
    series_phi_a = 5.107725174524775e-32 * y
    series_phi_b = 4.116826490666969e-29 - series_phi_a
    series_phi_b_right_1 = 4.116826490666969e-29 - series_phi_b
    series_phi_b_right_rest_1 = product_rest(5.107725174524775e-32, y, series_phi_a,
        series_phi_b_right_1)
    series_phi_b_lo1_1 = (4.116826490666969e-29 - (series_phi_b + series_phi_b_right_1)
        - series_phi_b_right_rest_1)
    series_phi_b_lo = series_phi_b_lo1_1 - (c14 * y + 5.107725174524775e-32 * y_lo) + c16
    series_phi_c = y * series_phi_b
    series_phi_c_padded_1 = c2 + (4.116826490666969e-29 + c15 * y_size_1)
    series_phi_c_size_3 = (half_angle_padded_1
        * (absolute(series_phi_b) + c4 * (absolute(series_phi_b_lo) + c11 * series_phi_c_padded_1)))
    series_phi_d = series_phi_c - 2.86531123750421e-26
    series_phi_d_right_1 = series_phi_c - series_phi_d
    series_phi_d_lo1_1 = (product_rest(y, series_phi_b, series_phi_c, series_phi_d
        + series_phi_d_right_1) - (2.86531123750421e-26 - series_phi_d_right_1))
    series_phi_d_lo = series_phi_d_lo1_1 - c17 + (y_lo * series_phi_b + y * series_phi_b_lo)
    series_phi_e = y * series_phi_d
    series_phi_e_padded_1 = (c2
        + (2.86531123750421e-26
        + (half_angle_reach_1 * series_phi_c_padded_1 + series_phi_c_size_3)))
    series_phi_e_size_3 = (half_angle_padded_1
        * (absolute(series_phi_d) + c4 * (absolute(series_phi_d_lo) + c18 * series_phi_e_padded_1)))
    series_phi_f = series_phi_e + 1.701994875077501e-23
    series_phi_f_right_1 = series_phi_f - series_phi_e
    series_phi_f_lo1_1 = (product_rest(y, series_phi_d, series_phi_e, series_phi_f
        - series_phi_f_right_1) + (1.701994875077501e-23 - series_phi_f_right_1))
    series_phi_f_lo = series_phi_f_lo1_1 + c19 + (y_lo * series_phi_d + y * series_phi_d_lo)
    series_phi_g = y * series_phi_f
    series_phi_g_padded_1 = (c2
        + (1.701994875077501e-23
        + (half_angle_reach_1 * series_phi_e_padded_1 + series_phi_e_size_3)))
    series_phi_g_size_3 = (half_angle_padded_1
        * (absolute(series_phi_f) + c4 * (absolute(series_phi_f_lo) + c20 * series_phi_g_padded_1)))
    series_phi_h = series_phi_g - 8.509974375387505e-21
    series_phi_h_right_1 = series_phi_g - series_phi_h
    series_phi_h_lo1_1 = (product_rest(y, series_phi_f, series_phi_g, series_phi_h
        + series_phi_h_right_1) - (8.509974375387505e-21 - series_phi_h_right_1))
    series_phi_h_lo = series_phi_h_lo1_1 - c21 + (y_lo * series_phi_f + y * series_phi_f_lo)
    series_phi_i = y * series_phi_h
    series_phi_i_padded_1 = (c2
        + (8.509974375387505e-21
        + (half_angle_reach_1 * series_phi_g_padded_1 + series_phi_g_size_3)))
    series_phi_i_size_3 = (half_angle_padded_1
        * (absolute(series_phi_h) + c4 * (absolute(series_phi_h_lo) + c22 * series_phi_i_padded_1)))
    series_phi_j = series_phi_i + 3.523129391410427e-18
    series_phi_j_right_1 = series_phi_j - series_phi_i
    series_phi_j_lo1_1 = (product_rest(y, series_phi_h, series_phi_i, series_phi_j
        - series_phi_j_right_1) + (3.523129391410427e-18 - series_phi_j_right_1))
    series_phi_j_lo = series_phi_j_lo1_1 + c23 + (y_lo * series_phi_h + y * series_phi_h_lo)
    series_phi_k = y * series_phi_j
    series_phi_k_padded_1 = (c2
        + (3.523129391410427e-18
        + (half_angle_reach_1 * series_phi_i_padded_1 + series_phi_i_size_3)))
    series_phi_k_size_3 = (half_angle_padded_1
        * (absolute(series_phi_j) + c4 * (absolute(series_phi_j_lo) + c24 * series_phi_k_padded_1)))
    series_phi_l = series_phi_k - 1.1837714755139035e-15
    series_phi_l_right_1 = series_phi_k - series_phi_l
    series_phi_l_left_rest_1 = product_rest(y, series_phi_j, series_phi_k,
        series_phi_l + series_phi_l_right_1)
    series_phi_l_lo = (series_phi_l_left_rest_1 - (1.1837714755139035e-15 - series_phi_l_right_1)
        - c25 + (y_lo * series_phi_j + y * series_phi_j_lo))
    series_phi_m = y * series_phi_l
    series_phi_m_padded_1 = (c2
        + (1.1837714755139035e-15
        + (half_angle_reach_1 * series_phi_k_padded_1 + series_phi_k_size_3)))
    series_phi_m_size_3 = (half_angle_padded_1
        * (absolute(series_phi_l) + c4 * (absolute(series_phi_l_lo) + c26 * series_phi_m_padded_1)))
    series_phi_n = series_phi_m + 3.148832124866983e-13
    series_phi_n_right_1 = series_phi_n - series_phi_m
    series_phi_n_lo1_1 = (product_rest(y, series_phi_l, series_phi_m, series_phi_n
        - series_phi_n_right_1) + (3.148832124866983e-13 - series_phi_n_right_1))
    series_phi_n_lo = series_phi_n_lo1_1 + c27 + (y_lo * series_phi_l + y * series_phi_l_lo)
    series_phi_o = y * series_phi_n
    series_phi_o_padded_1 = (c2
        + (3.148832124866983e-13
        + (half_angle_reach_1 * series_phi_m_padded_1 + series_phi_m_size_3)))
    series_phi_o_size_3 = (half_angle_padded_1
        * (absolute(series_phi_n) + c4 * (absolute(series_phi_n_lo) + c28 * series_phi_o_padded_1)))
    series_phi_p = series_phi_o - 6.423617534728645e-11
    series_phi_p_right_1 = series_phi_o - series_phi_p
    series_phi_p_lo1_1 = (product_rest(y, series_phi_n, series_phi_o, series_phi_p
        + series_phi_p_right_1) - (6.423617534728645e-11 - series_phi_p_right_1))
    series_phi_p_lo = series_phi_p_lo1_1 - c29 + (y_lo * series_phi_n + y * series_phi_n_lo)
    series_phi_q = y * series_phi_p
    series_phi_q_padded_1 = (c2
        + (6.423617534728645e-11
        + (half_angle_reach_1 * series_phi_o_padded_1 + series_phi_o_size_3)))
    series_phi_q_size_3 = (half_angle_padded_1
        * (absolute(series_phi_p) + c4 * (absolute(series_phi_p_lo) + c30 * series_phi_q_padded_1)))
    series_phi_r = series_phi_q + 9.635426302092969e-09
    series_phi_r_right_1 = series_phi_r - series_phi_q
    series_phi_r_lo1_1 = (product_rest(y, series_phi_p, series_phi_q, series_phi_r
        - series_phi_r_right_1) + (9.635426302092969e-09 - series_phi_r_right_1))
    series_phi_r_lo = series_phi_r_lo1_1 + c31 + (y_lo * series_phi_p + y * series_phi_p_lo)
    series_phi_s = y * series_phi_r
    series_phi_s_padded_1 = (c2
        + (9.635426302092969e-09
        + (half_angle_reach_1 * series_phi_q_padded_1 + series_phi_q_size_3)))
    series_phi_s_size_3 = (half_angle_padded_1
        * (absolute(series_phi_r) + c4 * (absolute(series_phi_r_lo) + c32 * series_phi_s_padded_1)))
    series_phi_t = series_phi_s - 1.0020843354176687e-06
    series_phi_t_right_1 = series_phi_s - series_phi_t
    series_phi_t_left_rest_1 = product_rest(y, series_phi_r, series_phi_s,
        series_phi_t + series_phi_t_right_1)
    series_phi_t_lo = (series_phi_t_left_rest_1 - (1.0020843354176687e-06 - series_phi_t_right_1)
        - c33 + (y_lo * series_phi_r + y * series_phi_r_lo))
    series_phi_u = y * series_phi_t
    series_phi_u_padded_1 = (c2
        + (1.0020843354176687e-06
        + (half_angle_reach_1 * series_phi_s_padded_1 + series_phi_s_size_3)))
    series_phi_u_size_3 = (half_angle_padded_1
        * (absolute(series_phi_t) + c4 * (absolute(series_phi_t_lo) + c34 * series_phi_u_padded_1)))
    series_phi_v = series_phi_u + 6.613756613756614e-05
    series_phi_v_right_1 = series_phi_v - series_phi_u
    series_phi_v_lo1_1 = (product_rest(y, series_phi_t, series_phi_u, series_phi_v
        - series_phi_v_right_1) + (6.613756613756614e-05 - series_phi_v_right_1))
    series_phi_v_lo = series_phi_v_lo1_1 + c35 + (y_lo * series_phi_t + y * series_phi_t_lo)
    series_phi_w = y * series_phi_v
    series_phi_w_padded_1 = (c2
        + (6.613756613756614e-05
        + (half_angle_reach_1 * series_phi_u_padded_1 + series_phi_u_size_3)))
    series_phi_w_size_3 = (half_angle_padded_1
        * (absolute(series_phi_v) + c4 * (absolute(series_phi_v_lo) + c36 * series_phi_w_padded_1)))
    series_phi_x = series_phi_w - 0.002380952380952381
    series_phi_x_right_1 = series_phi_w - series_phi_x
    series_phi_x_lo1_1 = (product_rest(y, series_phi_v, series_phi_w, series_phi_x
        + series_phi_x_right_1) - (0.002380952380952381 - series_phi_x_right_1))
    series_phi_x_lo = series_phi_x_lo1_1 - c37 + (y_lo * series_phi_v + y * series_phi_v_lo)
    series_phi_y = y * series_phi_x
    series_phi_y_padded_1 = (c2
        + (0.002380952380952381
        + (half_angle_reach_1 * series_phi_w_padded_1 + series_phi_w_size_3)))
    series_phi_y_size_3 = (half_angle_padded_1
        * (absolute(series_phi_x) + c4 * (absolute(series_phi_x_lo) + c38 * series_phi_y_padded_1)))
    series_phi = series_phi_y + 0.03333333333333333
    series_phi_right_1 = series_phi - series_phi_y
    series_phi_lo2_1 = (product_rest(y, series_phi_x, series_phi_y, series_phi
        - series_phi_right_1) + (0.03333333333333333 - series_phi_right_1) + c39)
    series_phi_lo = series_phi_lo2_1 + (y_lo * series_phi_x + y * series_phi_x_lo)
    f_more_a = 2 * y
    f_more_a_cross2_1 = 2 * y_lo
    f_more = f_more_a * series_phi
    f_more_padded_1 = c2 + 2 * y_size_1
    f_more_padded_2 = (c2
        + (0.03333333333333333
        + (half_angle_reach_1 * series_phi_y_padded_1 + series_phi_y_size_3)))
    f_more_size_2 = (f_more_padded_2
        * (absolute(f_more_a) + c4 * (absolute(f_more_a_cross2_1) + c40 * f_more_padded_1)))
    near_f_a = 0.3333333333333333 * sinc
    near_f_b = 0.3333333333333333 * f_more
    near_f_b_cross2_1 = (0.3333333333333333
        * (product_error(f_more_a, series_phi, f_more)
        + (f_more_a_cross2_1 * series_phi + f_more_a * series_phi_lo)))
    f_more_size_5 = (f_more_size_2 + f_more_padded_1
        * (absolute(series_phi) + c4 * (absolute(series_phi_lo) + c41 * f_more_padded_2)))
    near_f = near_f_a + near_f_b
    near_f_right_1 = near_f - near_f_a
    near_f_left_rest_1 = product_rest(0.3333333333333333, sinc, near_f_a, near_f - near_f_right_1)
    near_f_lo1_1 = (near_f_left_rest_1
        + product_rest(0.3333333333333333, f_more, near_f_b, near_f_right_1))
    near_f_lo = (near_f_lo1_1
        + (c42 * sinc + 0.3333333333333333 * sinc_lo + (c42 * f_more + near_f_b_cross2_1)))
    near_f_size_1 = 0.3333333333333333 * sinc_size_8 + 0.3333333333333333 * f_more_size_5
    f_rest = sinc - c
    f_rest_right_1 = sinc - f_rest
    fine_x = 4 * y
    far_y_a = fine_x < 4
    far_y = where(far_y_a, 1, y)
    far_y_lo = where(far_y_a, 0, y_lo)
    far_y_size_4 = absolute(4 * y_lo) + c40 * (c2 + 4 * y_size_1) < absolute(fine_x - 4)
    closed_f = f_rest / far_y
    closed_f_product_1 = closed_f * far_y
    closed_f_exact_1 = (f_rest - closed_f_product_1
        - product_error(closed_f, far_y, closed_f_product_1))
    closed_f_lo = ((closed_f_exact_1
        + (sinc - (f_rest + f_rest_right_1) - (c - f_rest_right_1) - c_lo + sinc_lo) - closed_f
        * far_y_lo) / far_y)
    closed_f_padded_2 = (c2
        + (where(far_y_a, 1, y_size_1) + c43
        * where(far_y_size_4, 0, absolute(1 - y) + half_angle_bound_1)))
    closed_f_size_1 = absolute(closed_f)
    closed_f_size_2 = absolute(far_y)
    closed_f_bound_1 = absolute(far_y_lo) + c44 * closed_f_padded_2
    closed_f_size_4 = c2 + (fine_sine_size_1 + sinc_size_8) + closed_f_padded_2 * closed_f_size_1
    closed_f_size_9 = ((closed_f_size_2 + c4 * closed_f_bound_1)
        * (closed_f_size_4 / where(4 * closed_f_bound_1 < closed_f_size_2, closed_f_size_2, 0)))
    closed_f_size_11 = closed_f_size_1 + closed_f_size_9 / closed_f_size_2
    f = where(far_y_a, near_f, closed_f)
    f_size_5 = (absolute(closed_f_lo) + c46 * (c2 + closed_f_size_11)
        + (absolute(near_f_lo) + c45 * (c2 + near_f_size_1) + absolute(near_f - closed_f)))
    four_k = 4 * sinc
    four_k_cross2_1 = 4 * sinc_lo
    fine_b = f / four_k
    fine_b_product_1 = fine_b * four_k
    fine_b_numerator_1 = (f - fine_b_product_1 - product_error(fine_b, four_k, fine_b_product_1)
        + where(far_y_a, near_f_lo, closed_f_lo))
    fine_b_lo = (fine_b_numerator_1 - fine_b * four_k_cross2_1) / four_k
    fine_b_padded_2 = c2 + 4 * sinc_size_8
    fine_b_size_1 = absolute(fine_b)
    fine_b_size_2 = absolute(four_k)
    fine_b_bound_1 = absolute(four_k_cross2_1) + c48 * fine_b_padded_2
    fine_b_size_4 = (c2
        + (where(far_y_a, near_f_size_1, closed_f_size_11) + c47
        * where(far_y_size_4, 0, f_size_5)) + fine_b_padded_2 * fine_b_size_1)
    fine_b_size_10 = ((fine_b_size_2 + c4 * fine_b_bound_1)
        * (fine_b_size_4 / where(4 * fine_b_bound_1 < fine_b_size_2, fine_b_size_2, 0))
        / fine_b_size_2)
    fine_b_across = c / sinc
    fine_b_across_product_1 = fine_b_across * sinc
    fine_b_across_lo = ((c - fine_b_across_product_1
        - product_error(fine_b_across, sinc, fine_b_across_product_1) + c_lo - fine_b_across
        * sinc_lo) / sinc)
    fine_b_across_padded_1 = c2 + sinc_size_8
    fine_b_across_size_1 = absolute(fine_b_across)
    fine_b_across_size_2 = absolute(sinc)
    fine_b_across_bound_1 = absolute(sinc_lo) + c49 * fine_b_across_padded_1
    fine_b_across_size_7 = where(4 * fine_b_across_bound_1 < fine_b_across_size_2,
        fine_b_across_size_2, 0)
    fine_b_across_size_8 = ((fine_b_across_padded_1 * fine_b_across_size_1
        + sinc_quotient_padded_1) / fine_b_across_size_7)
    fine_b_across_size_11 = (fine_b_across_size_1
        + (fine_b_across_size_2 + c4 * fine_b_across_bound_1) * fine_b_across_size_8
        / fine_b_across_size_2)
    fine_beta_v_0 = v_0 * fine_b
    fine_beta_v_padded_1 = c2 + (fine_b_size_1 + fine_b_size_10)
    fine_beta_v_1 = v_1 * fine_b
    fine_beta_v_2 = v_2 * fine_b
    fine_beta_v_lo_1 = product_error(v_0, fine_b, fine_beta_v_0) + v_0 * fine_b_lo
    fine_m_0 = v_0 * fine_beta_v_0
    fine_m_cross2_1 = v_0 * fine_beta_v_lo_1
    fine_m_padded_1 = c2 + fine_beta_v_padded_1 * halved_size_1
    fine_m_size_1 = fine_m_padded_1 * halved_size_1
    fine_beta_v_lo_2 = product_error(v_1, fine_b, fine_beta_v_1) + v_1 * fine_b_lo
    fine_m_1 = v_1 * fine_beta_v_1
    fine_m_cross2_2 = v_1 * fine_beta_v_lo_2
    fine_m_padded_2 = c2 + fine_beta_v_padded_1 * halved_size_3
    fine_m_size_2 = fine_m_padded_2 * halved_size_3
    fine_m_2 = v_2 * fine_beta_v_2
    fine_m_cross2_3 = v_2 * (product_error(v_2, fine_b, fine_beta_v_2) + v_2 * fine_b_lo)
    fine_m_size_3 = (c2 + fine_beta_v_padded_1 * halved_size_5) * halved_size_5
    fine_m_3 = v_1 * fine_beta_v_0
    fine_m_cross2_4 = v_1 * fine_beta_v_lo_1
    fine_m_4 = v_2 * fine_beta_v_0
    fine_m_cross2_5 = v_2 * fine_beta_v_lo_1
    fine_m_5 = v_2 * fine_beta_v_1
    fine_m_cross2_6 = v_2 * fine_beta_v_lo_2
    fine_others_0 = fine_m_1 + fine_m_2
    fine_others_right_1 = fine_others_0 - fine_m_1
    fine_others_left_rest_1 = product_rest(v_1, fine_beta_v_1, fine_m_1,
        fine_others_0 - fine_others_right_1)
    fine_others_lo_1 = (fine_others_left_rest_1
        + product_rest(v_2, fine_beta_v_2, fine_m_2, fine_others_right_1)
        + (fine_m_cross2_2 + fine_m_cross2_3))
    fine_others_size_1 = fine_m_size_2 + fine_m_size_3
    fine_others_1 = fine_m_0 + fine_m_2
    fine_others_right_2 = fine_others_1 - fine_m_0
    fine_others_left_rest_2 = product_rest(v_0, fine_beta_v_0, fine_m_0,
        fine_others_1 - fine_others_right_2)
    fine_others_lo_2 = (fine_others_left_rest_2
        + product_rest(v_2, fine_beta_v_2, fine_m_2, fine_others_right_2)
        + (fine_m_cross2_1 + fine_m_cross2_3))
    fine_others_size_2 = fine_m_size_1 + fine_m_size_3
    fine_others_2 = fine_m_0 + fine_m_1
    fine_others_right_3 = fine_others_2 - fine_m_0
    fine_others_left_rest_3 = product_rest(v_0, fine_beta_v_0, fine_m_0,
        fine_others_2 - fine_others_right_3)
    fine_others_lo_3 = (fine_others_left_rest_3
        + product_rest(v_1, fine_beta_v_1, fine_m_1, fine_others_right_3)
        + (fine_m_cross2_1 + fine_m_cross2_2))
    fine_others_size_3 = fine_m_size_1 + fine_m_size_2
    fine_diagonal0a = 1 - fine_others_0
    fine_diagonal0a_right_1 = 1 - fine_diagonal0a
    fine_diagonal0a_lo = (1 - (fine_diagonal0a + fine_diagonal0a_right_1)
        - (fine_others_0 - fine_diagonal0a_right_1) - fine_others_lo_1)
    fine_diagonal0a_size_1 = 1 + fine_others_size_1
    fine_diagonal0b = fine_b_across + fine_m_0
    fine_diagonal0b_right_1 = fine_diagonal0b - fine_b_across
    fine_diagonal0b_right_rest_1 = product_rest(v_0, fine_beta_v_0, fine_m_0,
        fine_diagonal0b_right_1)
    fine_diagonal0b_lo = (fine_b_across - (fine_diagonal0b - fine_diagonal0b_right_1)
        + fine_diagonal0b_right_rest_1 + fine_m_cross2_1 + fine_b_across_lo)
    fine_diagonal0b_size_1 = fine_b_across_size_11 + fine_m_size_1
    fine_diagonal0c = fine_m_0 < fine_others_0
    fine_diagonal0_bound_1 = (absolute(product_error(v_0, fine_beta_v_0, fine_m_0)
        + fine_m_cross2_1) + c50 * (c2 + fine_m_size_1))
    fine_diagonal0_size_8 = (absolute(fine_diagonal0b_lo) + c51 * (c2 + fine_diagonal0b_size_1)
        + absolute(fine_diagonal0b - fine_diagonal0a))
    fine_diagonal0_size_5 = (fine_diagonal0_bound_1
        + (absolute(fine_others_lo_1) + c51 * (c2 + fine_others_size_1))
        < absolute(fine_m_0 - fine_others_0))
    fine_diagonal0_size_10 = where(fine_diagonal0_size_5, 0,
        absolute(fine_diagonal0a_lo) + c52 * (c2 + fine_diagonal0a_size_1) + fine_diagonal0_size_8)
    fine_diagonal1a = 1 - fine_others_1
    fine_diagonal1a_right_1 = 1 - fine_diagonal1a
    fine_diagonal1a_lo = (1 - (fine_diagonal1a + fine_diagonal1a_right_1)
        - (fine_others_1 - fine_diagonal1a_right_1) - fine_others_lo_2)
    fine_diagonal1a_size_1 = 1 + fine_others_size_2
    fine_diagonal1b = fine_b_across + fine_m_1
    fine_diagonal1b_right_1 = fine_diagonal1b - fine_b_across
    fine_diagonal1b_right_rest_1 = product_rest(v_1, fine_beta_v_1, fine_m_1,
        fine_diagonal1b_right_1)
    fine_diagonal1b_lo = (fine_b_across - (fine_diagonal1b - fine_diagonal1b_right_1)
        + fine_diagonal1b_right_rest_1 + fine_m_cross2_2 + fine_b_across_lo)
    fine_diagonal1b_size_1 = fine_b_across_size_11 + fine_m_size_2
    fine_diagonal1c = fine_m_1 < fine_others_1
    fine_diagonal1_bound_1 = (absolute(product_error(v_1, fine_beta_v_1, fine_m_1)
        + fine_m_cross2_2) + c50 * (c2 + fine_m_size_2))
    fine_diagonal1_size_8 = (absolute(fine_diagonal1b_lo) + c51 * (c2 + fine_diagonal1b_size_1)
        + absolute(fine_diagonal1b - fine_diagonal1a))
    fine_diagonal1_size_5 = (fine_diagonal1_bound_1
        + (absolute(fine_others_lo_2) + c51 * (c2 + fine_others_size_2))
        < absolute(fine_m_1 - fine_others_1))
    fine_diagonal1_size_10 = where(fine_diagonal1_size_5, 0,
        absolute(fine_diagonal1a_lo) + c52 * (c2 + fine_diagonal1a_size_1) + fine_diagonal1_size_8)
    fine_diagonal2a = 1 - fine_others_2
    fine_diagonal2a_right_1 = 1 - fine_diagonal2a
    fine_diagonal2a_lo = (1 - (fine_diagonal2a + fine_diagonal2a_right_1)
        - (fine_others_2 - fine_diagonal2a_right_1) - fine_others_lo_3)
    fine_diagonal2a_size_1 = 1 + fine_others_size_3
    fine_diagonal2b = fine_b_across + fine_m_2
    fine_diagonal2b_right_1 = fine_diagonal2b - fine_b_across
    fine_diagonal2b_right_rest_1 = product_rest(v_2, fine_beta_v_2, fine_m_2,
        fine_diagonal2b_right_1)
    fine_diagonal2b_lo = (fine_b_across - (fine_diagonal2b - fine_diagonal2b_right_1)
        + fine_diagonal2b_right_rest_1 + fine_m_cross2_3 + fine_b_across_lo)
    fine_diagonal2b_size_1 = fine_b_across_size_11 + fine_m_size_3
    fine_diagonal2c = fine_m_2 < fine_others_2
    fine_diagonal2_bound_1 = (absolute(product_error(v_2, fine_beta_v_2, fine_m_2)
        + fine_m_cross2_3) + c50 * (c2 + fine_m_size_3))
    fine_diagonal2_size_8 = (absolute(fine_diagonal2b_lo) + c51 * (c2 + fine_diagonal2b_size_1)
        + absolute(fine_diagonal2b - fine_diagonal2a))
    fine_diagonal2_size_5 = (fine_diagonal2_bound_1
        + (absolute(fine_others_lo_3) + c51 * (c2 + fine_others_size_3))
        < absolute(fine_m_2 - fine_others_2))
    fine_diagonal2_size_10 = where(fine_diagonal2_size_5, 0,
        absolute(fine_diagonal2a_lo) + c52 * (c2 + fine_diagonal2a_size_1) + fine_diagonal2_size_8)
    fine_alpha_v_0 = -halved_0
    fine_alpha_v_1 = -halved_1
    fine_alpha_v_2 = -halved_2
    fine_R_01 = fine_m_3 - fine_alpha_v_2
    fine_R_right_1 = fine_m_3 - fine_R_01
    fine_R_02 = fine_m_4 + fine_alpha_v_1
    fine_R_right_2 = fine_R_02 - fine_m_4
    fine_R_10 = fine_m_3 + fine_alpha_v_2
    fine_R_right_3 = fine_R_10 - fine_m_3
    fine_R_12 = fine_m_5 - fine_alpha_v_0
    fine_R_right_4 = fine_m_5 - fine_R_12
    fine_R_20 = fine_m_4 - fine_alpha_v_1
    fine_R_right_5 = fine_m_4 - fine_R_20
    fine_R_21 = fine_m_5 + fine_alpha_v_0
    fine_R_right_6 = fine_R_21 - fine_m_5
    diagonal0_apart_1 = where(fine_diagonal0c, fine_diagonal0b, fine_diagonal0a) - diagonal0
    diagonal0_rest_1 = (c55
        * (c2
        + (where(fine_diagonal0c, fine_diagonal0b_size_1, fine_diagonal0a_size_1) + c53
        * fine_diagonal0_size_10)))
    fine_R_lo_1 = (product_rest(v_1, fine_beta_v_0, fine_m_3, fine_R_01 + fine_R_right_1)
        - (fine_alpha_v_2 - fine_R_right_1) + fine_m_cross2_4)
    R_rest_1 = c51 * (c2 + (fine_m_padded_1 * halved_size_3 + halved_size_6))
    fine_R_lo_2 = (product_rest(v_2, fine_beta_v_0, fine_m_4, fine_R_02 - fine_R_right_2)
        + (fine_alpha_v_1 - fine_R_right_2) + fine_m_cross2_5)
    R_rest_2 = c51 * (c2 + (fine_m_padded_1 * halved_size_5 + halved_size_4))
    fine_R_lo_3 = (product_rest(v_1, fine_beta_v_0, fine_m_3, fine_R_10 - fine_R_right_3)
        + (fine_alpha_v_2 - fine_R_right_3) + fine_m_cross2_4)
    diagonal1_apart_1 = where(fine_diagonal1c, fine_diagonal1b, fine_diagonal1a) - diagonal1
    diagonal1_rest_1 = (c55
        * (c2
        + (where(fine_diagonal1c, fine_diagonal1b_size_1, fine_diagonal1a_size_1) + c53
        * fine_diagonal1_size_10)))
    fine_R_lo_4 = (product_rest(v_2, fine_beta_v_1, fine_m_5, fine_R_12 + fine_R_right_4)
        - (fine_alpha_v_0 - fine_R_right_4) + fine_m_cross2_6)
    R_rest_3 = c51 * (c2 + (fine_m_padded_2 * halved_size_5 + halved_size_2))
    fine_R_lo_5 = (product_rest(v_2, fine_beta_v_0, fine_m_4, fine_R_20 + fine_R_right_5)
        - (fine_alpha_v_1 - fine_R_right_5) + fine_m_cross2_5)
    fine_R_lo_6 = (product_rest(v_2, fine_beta_v_1, fine_m_5, fine_R_21 - fine_R_right_6)
        + (fine_alpha_v_0 - fine_R_right_6) + fine_m_cross2_6)
    diagonal2_apart_1 = where(fine_diagonal2c, fine_diagonal2b, fine_diagonal2a) - diagonal2
    diagonal2_rest_1 = (c55
        * (c2
        + (where(fine_diagonal2c, fine_diagonal2b_size_1, fine_diagonal2a_size_1) + c53
        * fine_diagonal2_size_10)))
    diagonal0_bound_1 = (c54
        * absolute(diagonal0_apart_1
        + where(fine_diagonal0c, fine_diagonal0b_lo, fine_diagonal0a_lo)) + diagonal0_rest_1)
    R_bound_1 = c54 * absolute(fine_R_01 - R_01 + fine_R_lo_1) + R_rest_1
    R_bound_2 = c54 * absolute(fine_R_02 - R_02 + fine_R_lo_2) + R_rest_2
    R_bound_3 = c54 * absolute(fine_R_10 - R_10 + fine_R_lo_3) + R_rest_1
    diagonal1_bound_1 = (c54
        * absolute(diagonal1_apart_1
        + where(fine_diagonal1c, fine_diagonal1b_lo, fine_diagonal1a_lo)) + diagonal1_rest_1)
    R_bound_4 = c54 * absolute(fine_R_12 - R_12 + fine_R_lo_4) + R_rest_3
    R_bound_5 = c54 * absolute(fine_R_20 - R_20 + fine_R_lo_5) + R_rest_2
    R_bound_6 = c54 * absolute(fine_R_21 - R_21 + fine_R_lo_6) + R_rest_3
    diagonal2_bound_1 = (c54
        * absolute(diagonal2_apart_1
        + where(fine_diagonal2c, fine_diagonal2b_lo, fine_diagonal2a_lo)) + diagonal2_rest_1)
    return (diagonal0, R_01, R_02, R_10, diagonal1, R_12, R_20, R_21, diagonal2, diagonal0_bound_1,
        R_bound_1, R_bound_2, R_bound_3, diagonal1_bound_1, R_bound_4, R_bound_5, R_bound_6,
        diagonal2_bound_1)


@kernel("(3)->(3,3),(3,3)")
@errstate(all="ignore")
def SO3_rightJacobianInverse(v, *, c1=268435456, c2=1.8051943758648296e-276,
        c3=2.5021685128863245e-30, c4=140737488355328, c5=2.567393169377981e+29,
        c6=4.240128211918887e-30, c7=9.054644677292507e+28, c8=1.1389183198259759e-29,
        c9=9.25185853854297e-18, c10=2290649224.7000003, c11=8.120831909935717e-28,
        c12=1.8842277118313698e-29, c13=1.2325982855554354e+27, c14=4.7410392187559056e-48,
        c15=6.843135825984986e-08, c16=-1.8714974010023092e-45, c17=2.3296034284323186e-42,
        c18=8.17876581047362e-28, c19=3.161967936521494e-40, c20=8.238918382307457e-28,
        c21=3.2266760594119493e-37, c22=8.301289625437229e-28, c23=-1.2521244741738012e-34,
        c24=8.36587954080333e-28, c25=7.23242424407352e-33, c26=8.432688128405761e-28,
        c27=5.8681293750286156e-30, c28=8.501715387304126e-28, c29=5.034117835500839e-27,
        c30=8.572961317498427e-28, c31=-1.7546051379703029e-25, c32=8.64642591898866e-28,
        c33=4.7926555569351065e-23, c34=8.722109191774827e-28, c35=-4.460143857711533e-21,
        c36=8.800011135856928e-28, c37=-2.147752875018904e-19, c38=8.880131751234963e-28,
        c39=4.625929269271486e-19, c40=2.8103175390871538e-30, c41=8.962471037908933e-28,
        c42=1.850371707708594e-17, c43=6.338251187752959e+28, c44=1.6270262376793602e-29,
        c45=9.075379655148354e-28, c46=8.245490617302283e-28, c47=1.1062092690083102e+27,
        c48=8.125024661305438e-28, c49=8.120832873841084e-28, c50=9.513982289044683e-28,
        c51=9.550468072637709e-28, c52=9.58769341332938e-28, c53=1.0474204728201347e+27,
        c54=1.0000000000000009, c55=9.587694380055934e-28):
    """R = J_r(v)^-1 = I + v~/2 + (1 - θ/2 cot θ/2)/θ^2 v~^2, θ = |v|; singular at multiples of 2π
    except 0; |error of R| <= R_bound unless inf or NaN.

    (3)->(3,3),(3,3).  v: vector; R, R_bound: rotation or other 3×3 matrix.
    420 mul, 746 add, 23 product error, 34 product rest, 23 div, 3 sqrt, 93 abs, 23 less, 1
    equal, 47 select.
    """
    v_0, v_1, v_2 = v
    size_0 = absolute(v_0)
    size_1 = absolute(v_1)
    size_2 = absolute(v_2)
    sizes = size_0 + size_1 + size_2
    grid = sizes * c1
    shifted_0 = v_0 + grid
    shifted_1 = v_1 + grid
    shifted_2 = v_2 + grid
    high_0 = shifted_0 - grid
    high_1 = shifted_1 - grid
    high_2 = shifted_2 - grid
    low_0 = v_0 - high_0
    low_1 = v_1 - high_1
    low_2 = v_2 - high_2
    sum_0 = v_0 + high_0
    sum_1 = v_1 + high_1
    sum_2 = v_2 + high_2
    squares = high_0 * high_0 + high_1 * high_1 + high_2 * high_2
    cross = low_0 * sum_0 + low_1 * sum_1 + low_2 * sum_2
    x = squares + cross
    theta_b = x < 1
    theta = where(theta_b, 1, sqrt(x))
    theta_shifted = grid + theta
    theta_high = theta_shifted - grid
    theta_low = theta - theta_high
    theta_sum = theta + theta_high
    cross_rest = cross - theta_low * theta_sum
    exact = squares - theta_high * theta_high
    residual = cross_rest + exact
    small = 0.5 * residual / theta
    delta = where(absolute(small) < 0.0078125, small, 0)
    far_sine_a, far_cosine_a = elementary.sincos(theta)
    far_sine = where(theta_b, 1, far_sine_a)
    far_cosine = where(theta_b, 0, far_cosine_a)
    sine = delta * far_cosine + far_sine
    cosine = far_cosine - delta * far_sine
    above_b = cosine < 0
    above = where(above_b, sine, cosine + 1)
    below = where(above_b, 1 - cosine, sine)
    cotangent = above / below
    half_cotangent = 0.5 * theta * cotangent
    b_rest = 1 - half_cotangent
    b_divisor_a = x < 4
    b_divisor = where(b_divisor_a, 4, x)
    closed_b = b_rest / b_divisor
    b_h = (x
        * (x * (x * (1.455172475614865e-27 * x + 5.744790668872202e-26) + 2.267952452337683e-24)
        + 8.953517427037546e-23) + 3.534707039629467e-21)
    b_q = (x
        * (x
        * (x * (x * (x * b_h + 1.3954464685812522e-19) + 5.5090028283602295e-18)
        + 2.174868698558062e-16) + 8.586062056277845e-15))
    b_y = (x
        * (x
        * (x * (x * (b_q + 3.3896802963225827e-13) + 1.3382536530684679e-11)
        + 5.284190138687493e-10) + 2.08767569878681e-08))
    b = where(b_divisor_a,
        x * (x * (x * (b_y + 8.267195767195768e-07) + 3.306878306878307e-05) + 0.001388888888888889)
            + 0.08333333333333333,
        closed_b)
    b_across = where(b_divisor_a, 1 - x * b, half_cotangent)
    beta_v_0 = v_0 * b
    beta_v_1 = v_1 * b
    beta_v_2 = v_2 * b
    m_0 = v_0 * beta_v_0
    m_1 = v_1 * beta_v_1
    m_2 = v_2 * beta_v_2
    m_3 = v_1 * beta_v_0
    m_4 = v_2 * beta_v_0
    m_5 = v_2 * beta_v_1
    others_0 = m_1 + m_2
    others_1 = m_0 + m_2
    others_2 = m_0 + m_1
    diagonal0 = where(m_0 < others_0, b_across + m_0, 1 - others_0)
    diagonal1 = where(m_1 < others_1, b_across + m_1, 1 - others_1)
    diagonal2 = where(m_2 < others_2, b_across + m_2, 1 - others_2)
    alpha_v_0 = 0.5 * v_0
    alpha_v_1 = 0.5 * v_1
    alpha_v_2 = 0.5 * v_2
    R_01 = m_3 - alpha_v_2
    R_02 = m_4 + alpha_v_1
    R_10 = m_3 + alpha_v_2
    R_12 = m_5 - alpha_v_0
    R_20 = m_4 - alpha_v_1
    R_21 = m_5 + alpha_v_0
    halved_0 = 0.5 * v_0
    halved_size_1 = absolute(v_0)
    halved_size_2 = 0.5 * halved_size_1
    halved_1 = 0.5 * v_1
    halved_size_3 = absolute(v_1)
    halved_size_4 = 0.5 * halved_size_3
    halved_2 = 0.5 * v_2
    halved_size_5 = absolute(v_2)
    halved_size_6 = 0.5 * halved_size_5
    y_a = halved_0 * halved_0
    y_a_padded_1 = c2 + halved_size_2
    y_b = halved_1 * halved_1
    y_b_padded_1 = c2 + halved_size_4
    y_c = y_a + y_b
    y_c_right_1 = y_c - y_a
    y_d = halved_2 * halved_2
    y_d_padded_1 = c2 + halved_size_6
    y = y_c + y_d
    y_right_1 = y - y_c
    y_c_lo = (product_rest(halved_0, halved_0, y_a, y_c - y_c_right_1)
        + product_rest(halved_1, halved_1, y_b, y_c_right_1))
    y_lo = y_c - (y - y_right_1) + product_rest(halved_2, halved_2, y_d, y_right_1) + y_c_lo
    y_size_1 = (y_a_padded_1 * y_a_padded_1 + y_b_padded_1 * y_b_padded_1 + y_d_padded_1
        * y_d_padded_1)
    half_angle = sqrt(y)
    half_angle_product_1 = half_angle * half_angle
    half_angle_residual_1 = (y - half_angle_product_1
        - product_error(half_angle, half_angle, half_angle_product_1) + y_lo)
    half_angle_lo = half_angle_residual_1 / where(half_angle == 0, 1, half_angle + half_angle)
    half_angle_padded_1 = c2 + y_size_1
    half_angle_bound_1 = absolute(y_lo) + c3 * half_angle_padded_1
    half_angle_reach_1 = absolute(y) + c4 * half_angle_bound_1
    half_angle_size_6 = absolute(half_angle_lo)
    half_angle_size_4 = half_angle_reach_1 * (half_angle_padded_1 / half_angle / y)
    half_angle_size_12 = (half_angle
        + where(4 * half_angle_bound_1 < y, half_angle_size_4, c5
        * (sqrt(half_angle_bound_1) + half_angle_size_6)))
    fine_sine, c = elementary.sincos(half_angle)
    fine_sine_own_error_1, c_own_error_1 = elementary.sincos_error(half_angle, fine_sine, c)
    fine_sine_half_1 = half_angle_lo * 0.5
    fine_sine_half_sin_1, fine_sine_half_cos_1 = elementary.sincos(fine_sine_half_1)
    fine_sine_twice_1 = fine_sine_half_sin_1 + fine_sine_half_sin_1
    fine_sine_padded_1 = c2 + half_angle_size_12
    fine_sine_size_1 = 1 + fine_sine_padded_1
    c_lo = (c_own_error_1 - (fine_sine_half_cos_1 * fine_sine + fine_sine_half_sin_1 * c)
        * fine_sine_twice_1)
    sinc_divisor_a = half_angle < 1.4901161193847656e-08
    sinc_divisor = where(sinc_divisor_a, 1.4901161193847656e-08, half_angle)
    sinc_divisor_lo = where(sinc_divisor_a, 0, half_angle_lo)
    sinc_divisor_bound_1 = half_angle_size_6 + c6 * fine_sine_padded_1
    sinc_divisor_size_4 = sinc_divisor_bound_1 < absolute(half_angle - 1.4901161193847656e-08)
    sinc_divisor_size_9 = (c7
        * where(sinc_divisor_size_4, 0, sinc_divisor_bound_1
        + absolute(1.4901161193847656e-08 - half_angle)))
    sinc_quotient = fine_sine / sinc_divisor
    sinc_quotient_product_1 = sinc_quotient * sinc_divisor
    sinc_quotient_exact_1 = (fine_sine - sinc_quotient_product_1
        - product_error(sinc_quotient, sinc_divisor, sinc_quotient_product_1))
    fine_sine_lo = (fine_sine_own_error_1
        + (fine_sine_half_cos_1 * c - fine_sine_half_sin_1 * fine_sine) * fine_sine_twice_1)
    sinc_quotient_lo = ((sinc_quotient_exact_1 + fine_sine_lo - sinc_quotient * sinc_divisor_lo)
        / sinc_divisor)
    sinc_quotient_padded_1 = c2 + fine_sine_size_1
    sinc_quotient_padded_2 = (c2
        + (where(sinc_divisor_a, 1.4901161193847656e-08, half_angle_size_12) + sinc_divisor_size_9))
    sinc_quotient_size_1 = absolute(sinc_quotient)
    sinc_quotient_size_2 = absolute(sinc_divisor)
    sinc_quotient_bound_1 = absolute(sinc_divisor_lo) + c8 * sinc_quotient_padded_2
    sinc_quotient_size_7 = where(4 * sinc_quotient_bound_1 < sinc_quotient_size_2,
        sinc_quotient_size_2, 0)
    sinc_quotient_size_8 = ((sinc_quotient_padded_1 + sinc_quotient_padded_2
        * sinc_quotient_size_1) / sinc_quotient_size_7)
    sinc_quotient_size_11 = (sinc_quotient_size_1
        + (sinc_quotient_size_2 + c4 * sinc_quotient_bound_1) * sinc_quotient_size_8
        / sinc_quotient_size_2)
    sinc_a = 0.16666666666666666 * y
    sinc_b = 1 - sinc_a
    sinc_b_right_1 = 1 - sinc_b
    sinc_b_lo = (1 - (sinc_b + sinc_b_right_1)
        - product_rest(0.16666666666666666, y, sinc_a, sinc_b_right_1)
        - (c9 * y + 0.16666666666666666 * y_lo))
    sinc_b_size_1 = 1 + c10 * y_size_1
    sinc = where(sinc_divisor_a, sinc_b, sinc_quotient)
    sinc_lo = where(sinc_divisor_a, sinc_b_lo, sinc_quotient_lo)
    sinc_size_4 = (absolute(sinc_b_lo) + c11 * (c2 + sinc_b_size_1)
        + absolute(sinc_b - sinc_quotient))
    sinc_size_7 = (c13
        * where(sinc_divisor_size_4, 0, absolute(sinc_quotient_lo) + c12
        * (c2 + sinc_quotient_size_11) + sinc_size_4))
    sinc_size_8 = where(sinc_divisor_a, sinc_b_size_1, sinc_quotient_size_11) + sinc_size_7
    series_phi_a = 5.107725174524775e-32 * y
    series_phi_b = 4.116826490666969e-29 - series_phi_a
    series_phi_b_right_1 = 4.116826490666969e-29 - series_phi_b
    series_phi_b_right_rest_1 = product_rest(5.107725174524775e-32, y, series_phi_a,
        series_phi_b_right_1)
    series_phi_b_lo1_1 = (4.116826490666969e-29 - (series_phi_b + series_phi_b_right_1)
        - series_phi_b_right_rest_1)
    series_phi_b_lo = series_phi_b_lo1_1 - (c14 * y + 5.107725174524775e-32 * y_lo) + c16
    series_phi_c = y * series_phi_b
    series_phi_c_padded_1 = c2 + (4.116826490666969e-29 + c15 * y_size_1)
    series_phi_c_size_3 = (half_angle_padded_1
        * (absolute(series_phi_b) + c4 * (absolute(series_phi_b_lo) + c11 * series_phi_c_padded_1)))
    series_phi_d = series_phi_c - 2.86531123750421e-26
    series_phi_d_right_1 = series_phi_c - series_phi_d
    series_phi_d_lo1_1 = (product_rest(y, series_phi_b, series_phi_c, series_phi_d
        + series_phi_d_right_1) - (2.86531123750421e-26 - series_phi_d_right_1))
    series_phi_d_lo = series_phi_d_lo1_1 - c17 + (y_lo * series_phi_b + y * series_phi_b_lo)
    series_phi_e = y * series_phi_d
    series_phi_e_padded_1 = (c2
        + (2.86531123750421e-26
        + (half_angle_reach_1 * series_phi_c_padded_1 + series_phi_c_size_3)))
    series_phi_e_size_3 = (half_angle_padded_1
        * (absolute(series_phi_d) + c4 * (absolute(series_phi_d_lo) + c18 * series_phi_e_padded_1)))
    series_phi_f = series_phi_e + 1.701994875077501e-23
    series_phi_f_right_1 = series_phi_f - series_phi_e
    series_phi_f_lo1_1 = (product_rest(y, series_phi_d, series_phi_e, series_phi_f
        - series_phi_f_right_1) + (1.701994875077501e-23 - series_phi_f_right_1))
    series_phi_f_lo = series_phi_f_lo1_1 + c19 + (y_lo * series_phi_d + y * series_phi_d_lo)
    series_phi_g = y * series_phi_f
    series_phi_g_padded_1 = (c2
        + (1.701994875077501e-23
        + (half_angle_reach_1 * series_phi_e_padded_1 + series_phi_e_size_3)))
    series_phi_g_size_3 = (half_angle_padded_1
        * (absolute(series_phi_f) + c4 * (absolute(series_phi_f_lo) + c20 * series_phi_g_padded_1)))
    series_phi_h = series_phi_g - 8.509974375387505e-21
    series_phi_h_right_1 = series_phi_g - series_phi_h
    series_phi_h_lo1_1 = (product_rest(y, series_phi_f, series_phi_g, series_phi_h
        + series_phi_h_right_1) - (8.509974375387505e-21 - series_phi_h_right_1))
    series_phi_h_lo = series_phi_h_lo1_1 - c21 + (y_lo * series_phi_f + y * series_phi_f_lo)
    series_phi_i = y * series_phi_h
    series_phi_i_padded_1 = (c2
        + (8.509974375387505e-21
        + (half_angle_reach_1 * series_phi_g_padded_1 + series_phi_g_size_3)))
    series_phi_i_size_3 = (half_angle_padded_1
        * (absolute(series_phi_h) + c4 * (absolute(series_phi_h_lo) + c22 * series_phi_i_padded_1)))
    series_phi_j = series_phi_i + 3.523129391410427e-18
    series_phi_j_right_1 = series_phi_j - series_phi_i
    series_phi_j_lo1_1 = (product_rest(y, series_phi_h, series_phi_i, series_phi_j
        - series_phi_j_right_1) + (3.523129391410427e-18 - series_phi_j_right_1))
    series_phi_j_lo = series_phi_j_lo1_1 + c23 + (y_lo * series_phi_h + y * series_phi_h_lo)
    series_phi_k = y * series_phi_j
    series_phi_k_padded_1 = (c2
        + (3.523129391410427e-18
        + (half_angle_reach_1 * series_phi_i_padded_1 + series_phi_i_size_3)))
    series_phi_k_size_3 = (half_angle_padded_1
        * (absolute(series_phi_j) + c4 * (absolute(series_phi_j_lo) + c24 * series_phi_k_padded_1)))
    series_phi_l = series_phi_k - 1.1837714755139035e-15
    series_phi_l_right_1 = series_phi_k - series_phi_l
    series_phi_l_left_rest_1 = product_rest(y, series_phi_j, series_phi_k,
        series_phi_l + series_phi_l_right_1)
    series_phi_l_lo = (series_phi_l_left_rest_1 - (1.1837714755139035e-15 - series_phi_l_right_1)
        - c25 + (y_lo * series_phi_j + y * series_phi_j_lo))
    series_phi_m = y * series_phi_l
    series_phi_m_padded_1 = (c2
        + (1.1837714755139035e-15
        + (half_angle_reach_1 * series_phi_k_padded_1 + series_phi_k_size_3)))
    series_phi_m_size_3 = (half_angle_padded_1
        * (absolute(series_phi_l) + c4 * (absolute(series_phi_l_lo) + c26 * series_phi_m_padded_1)))
    series_phi_n = series_phi_m + 3.148832124866983e-13
    series_phi_n_right_1 = series_phi_n - series_phi_m
    series_phi_n_lo1_1 = (product_rest(y, series_phi_l, series_phi_m, series_phi_n
        - series_phi_n_right_1) + (3.148832124866983e-13 - series_phi_n_right_1))
    series_phi_n_lo = series_phi_n_lo1_1 + c27 + (y_lo * series_phi_l + y * series_phi_l_lo)
    series_phi_o = y * series_phi_n
    series_phi_o_padded_1 = (c2
        + (3.148832124866983e-13
        + (half_angle_reach_1 * series_phi_m_padded_1 + series_phi_m_size_3)))
    series_phi_o_size_3 = (half_angle_padded_1
        * (absolute(series_phi_n) + c4 * (absolute(series_phi_n_lo) + c28 * series_phi_o_padded_1)))
    series_phi_p = series_phi_o - 6.423617534728645e-11
    series_phi_p_right_1 = series_phi_o - series_phi_p
    series_phi_p_lo1_1 = (product_rest(y, series_phi_n, series_phi_o, series_phi_p
        + series_phi_p_right_1) - (6.423617534728645e-11 - series_phi_p_right_1))
    series_phi_p_lo = series_phi_p_lo1_1 - c29 + (y_lo * series_phi_n + y * series_phi_n_lo)
    series_phi_q = y * series_phi_p
    series_phi_q_padded_1 = (c2
        + (6.423617534728645e-11
        + (half_angle_reach_1 * series_phi_o_padded_1 + series_phi_o_size_3)))
    series_phi_q_size_3 = (half_angle_padded_1
        * (absolute(series_phi_p) + c4 * (absolute(series_phi_p_lo) + c30 * series_phi_q_padded_1)))
    series_phi_r = series_phi_q + 9.635426302092969e-09
    series_phi_r_right_1 = series_phi_r - series_phi_q
    series_phi_r_lo1_1 = (product_rest(y, series_phi_p, series_phi_q, series_phi_r
        - series_phi_r_right_1) + (9.635426302092969e-09 - series_phi_r_right_1))
    series_phi_r_lo = series_phi_r_lo1_1 + c31 + (y_lo * series_phi_p + y * series_phi_p_lo)
    series_phi_s = y * series_phi_r
    series_phi_s_padded_1 = (c2
        + (9.635426302092969e-09
        + (half_angle_reach_1 * series_phi_q_padded_1 + series_phi_q_size_3)))
    series_phi_s_size_3 = (half_angle_padded_1
        * (absolute(series_phi_r) + c4 * (absolute(series_phi_r_lo) + c32 * series_phi_s_padded_1)))
    series_phi_t = series_phi_s - 1.0020843354176687e-06
    series_phi_t_right_1 = series_phi_s - series_phi_t
    series_phi_t_left_rest_1 = product_rest(y, series_phi_r, series_phi_s,
        series_phi_t + series_phi_t_right_1)
    series_phi_t_lo = (series_phi_t_left_rest_1 - (1.0020843354176687e-06 - series_phi_t_right_1)
        - c33 + (y_lo * series_phi_r + y * series_phi_r_lo))
    series_phi_u = y * series_phi_t
    series_phi_u_padded_1 = (c2
        + (1.0020843354176687e-06
        + (half_angle_reach_1 * series_phi_s_padded_1 + series_phi_s_size_3)))
    series_phi_u_size_3 = (half_angle_padded_1
        * (absolute(series_phi_t) + c4 * (absolute(series_phi_t_lo) + c34 * series_phi_u_padded_1)))
    series_phi_v = series_phi_u + 6.613756613756614e-05
    series_phi_v_right_1 = series_phi_v - series_phi_u
    series_phi_v_lo1_1 = (product_rest(y, series_phi_t, series_phi_u, series_phi_v
        - series_phi_v_right_1) + (6.613756613756614e-05 - series_phi_v_right_1))
    series_phi_v_lo = series_phi_v_lo1_1 + c35 + (y_lo * series_phi_t + y * series_phi_t_lo)
    series_phi_w = y * series_phi_v
    series_phi_w_padded_1 = (c2
        + (6.613756613756614e-05
        + (half_angle_reach_1 * series_phi_u_padded_1 + series_phi_u_size_3)))
    series_phi_w_size_3 = (half_angle_padded_1
        * (absolute(series_phi_v) + c4 * (absolute(series_phi_v_lo) + c36 * series_phi_w_padded_1)))
    series_phi_x = series_phi_w - 0.002380952380952381
    series_phi_x_right_1 = series_phi_w - series_phi_x
    series_phi_x_lo1_1 = (product_rest(y, series_phi_v, series_phi_w, series_phi_x
        + series_phi_x_right_1) - (0.002380952380952381 - series_phi_x_right_1))
    series_phi_x_lo = series_phi_x_lo1_1 - c37 + (y_lo * series_phi_v + y * series_phi_v_lo)
    series_phi_y = y * series_phi_x
    series_phi_y_padded_1 = (c2
        + (0.002380952380952381
        + (half_angle_reach_1 * series_phi_w_padded_1 + series_phi_w_size_3)))
    series_phi_y_size_3 = (half_angle_padded_1
        * (absolute(series_phi_x) + c4 * (absolute(series_phi_x_lo) + c38 * series_phi_y_padded_1)))
    series_phi = series_phi_y + 0.03333333333333333
    series_phi_right_1 = series_phi - series_phi_y
    series_phi_lo2_1 = (product_rest(y, series_phi_x, series_phi_y, series_phi
        - series_phi_right_1) + (0.03333333333333333 - series_phi_right_1) + c39)
    series_phi_lo = series_phi_lo2_1 + (y_lo * series_phi_x + y * series_phi_x_lo)
    f_more_a = 2 * y
    f_more_a_cross2_1 = 2 * y_lo
    f_more = f_more_a * series_phi
    f_more_padded_1 = c2 + 2 * y_size_1
    f_more_padded_2 = (c2
        + (0.03333333333333333
        + (half_angle_reach_1 * series_phi_y_padded_1 + series_phi_y_size_3)))
    f_more_size_2 = (f_more_padded_2
        * (absolute(f_more_a) + c4 * (absolute(f_more_a_cross2_1) + c40 * f_more_padded_1)))
    near_f_a = 0.3333333333333333 * sinc
    near_f_b = 0.3333333333333333 * f_more
    near_f_b_cross2_1 = (0.3333333333333333
        * (product_error(f_more_a, series_phi, f_more)
        + (f_more_a_cross2_1 * series_phi + f_more_a * series_phi_lo)))
    f_more_size_5 = (f_more_size_2 + f_more_padded_1
        * (absolute(series_phi) + c4 * (absolute(series_phi_lo) + c41 * f_more_padded_2)))
    near_f = near_f_a + near_f_b
    near_f_right_1 = near_f - near_f_a
    near_f_left_rest_1 = product_rest(0.3333333333333333, sinc, near_f_a, near_f - near_f_right_1)
    near_f_lo1_1 = (near_f_left_rest_1
        + product_rest(0.3333333333333333, f_more, near_f_b, near_f_right_1))
    near_f_lo = (near_f_lo1_1
        + (c42 * sinc + 0.3333333333333333 * sinc_lo + (c42 * f_more + near_f_b_cross2_1)))
    near_f_size_1 = 0.3333333333333333 * sinc_size_8 + 0.3333333333333333 * f_more_size_5
    f_rest = sinc - c
    f_rest_right_1 = sinc - f_rest
    fine_x = 4 * y
    far_y_a = fine_x < 4
    far_y = where(far_y_a, 1, y)
    far_y_lo = where(far_y_a, 0, y_lo)
    far_y_size_4 = absolute(4 * y_lo) + c40 * (c2 + 4 * y_size_1) < absolute(fine_x - 4)
    closed_f = f_rest / far_y
    closed_f_product_1 = closed_f * far_y
    closed_f_exact_1 = (f_rest - closed_f_product_1
        - product_error(closed_f, far_y, closed_f_product_1))
    closed_f_lo = ((closed_f_exact_1
        + (sinc - (f_rest + f_rest_right_1) - (c - f_rest_right_1) - c_lo + sinc_lo) - closed_f
        * far_y_lo) / far_y)
    closed_f_padded_2 = (c2
        + (where(far_y_a, 1, y_size_1) + c43
        * where(far_y_size_4, 0, absolute(1 - y) + half_angle_bound_1)))
    closed_f_size_1 = absolute(closed_f)
    closed_f_size_2 = absolute(far_y)
    closed_f_bound_1 = absolute(far_y_lo) + c44 * closed_f_padded_2
    closed_f_size_4 = c2 + (fine_sine_size_1 + sinc_size_8) + closed_f_padded_2 * closed_f_size_1
    closed_f_size_9 = ((closed_f_size_2 + c4 * closed_f_bound_1)
        * (closed_f_size_4 / where(4 * closed_f_bound_1 < closed_f_size_2, closed_f_size_2, 0)))
    closed_f_size_11 = closed_f_size_1 + closed_f_size_9 / closed_f_size_2
    f = where(far_y_a, near_f, closed_f)
    f_size_5 = (absolute(closed_f_lo) + c46 * (c2 + closed_f_size_11)
        + (absolute(near_f_lo) + c45 * (c2 + near_f_size_1) + absolute(near_f - closed_f)))
    four_k = 4 * sinc
    four_k_cross2_1 = 4 * sinc_lo
    fine_b = f / four_k
    fine_b_product_1 = fine_b * four_k
    fine_b_numerator_1 = (f - fine_b_product_1 - product_error(fine_b, four_k, fine_b_product_1)
        + where(far_y_a, near_f_lo, closed_f_lo))
    fine_b_lo = (fine_b_numerator_1 - fine_b * four_k_cross2_1) / four_k
    fine_b_padded_2 = c2 + 4 * sinc_size_8
    fine_b_size_1 = absolute(fine_b)
    fine_b_size_2 = absolute(four_k)
    fine_b_bound_1 = absolute(four_k_cross2_1) + c48 * fine_b_padded_2
    fine_b_size_4 = (c2
        + (where(far_y_a, near_f_size_1, closed_f_size_11) + c47
        * where(far_y_size_4, 0, f_size_5)) + fine_b_padded_2 * fine_b_size_1)
    fine_b_size_10 = ((fine_b_size_2 + c4 * fine_b_bound_1)
        * (fine_b_size_4 / where(4 * fine_b_bound_1 < fine_b_size_2, fine_b_size_2, 0))
        / fine_b_size_2)
    fine_b_across = c / sinc
    fine_b_across_product_1 = fine_b_across * sinc
    fine_b_across_lo = ((c - fine_b_across_product_1
        - product_error(fine_b_across, sinc, fine_b_across_product_1) + c_lo - fine_b_across
        * sinc_lo) / sinc)
    fine_b_across_padded_1 = c2 + sinc_size_8
    fine_b_across_size_1 = absolute(fine_b_across)
    fine_b_across_size_2 = absolute(sinc)
    fine_b_across_bound_1 = absolute(sinc_lo) + c49 * fine_b_across_padded_1
    fine_b_across_size_7 = where(4 * fine_b_across_bound_1 < fine_b_across_size_2,
        fine_b_across_size_2, 0)
    fine_b_across_size_8 = ((fine_b_across_padded_1 * fine_b_across_size_1
        + sinc_quotient_padded_1) / fine_b_across_size_7)
    fine_b_across_size_11 = (fine_b_across_size_1
        + (fine_b_across_size_2 + c4 * fine_b_across_bound_1) * fine_b_across_size_8
        / fine_b_across_size_2)
    fine_beta_v_0 = v_0 * fine_b
    fine_beta_v_padded_1 = c2 + (fine_b_size_1 + fine_b_size_10)
    fine_beta_v_1 = v_1 * fine_b
    fine_beta_v_2 = v_2 * fine_b
    fine_beta_v_lo_1 = product_error(v_0, fine_b, fine_beta_v_0) + v_0 * fine_b_lo
    fine_m_0 = v_0 * fine_beta_v_0
    fine_m_cross2_1 = v_0 * fine_beta_v_lo_1
    fine_m_padded_1 = c2 + fine_beta_v_padded_1 * halved_size_1
    fine_m_size_1 = fine_m_padded_1 * halved_size_1
    fine_beta_v_lo_2 = product_error(v_1, fine_b, fine_beta_v_1) + v_1 * fine_b_lo
    fine_m_1 = v_1 * fine_beta_v_1
    fine_m_cross2_2 = v_1 * fine_beta_v_lo_2
    fine_m_padded_2 = c2 + fine_beta_v_padded_1 * halved_size_3
    fine_m_size_2 = fine_m_padded_2 * halved_size_3
    fine_m_2 = v_2 * fine_beta_v_2
    fine_m_cross2_3 = v_2 * (product_error(v_2, fine_b, fine_beta_v_2) + v_2 * fine_b_lo)
    fine_m_size_3 = (c2 + fine_beta_v_padded_1 * halved_size_5) * halved_size_5
    fine_m_3 = v_1 * fine_beta_v_0
    fine_m_cross2_4 = v_1 * fine_beta_v_lo_1
    fine_m_4 = v_2 * fine_beta_v_0
    fine_m_cross2_5 = v_2 * fine_beta_v_lo_1
    fine_m_5 = v_2 * fine_beta_v_1
    fine_m_cross2_6 = v_2 * fine_beta_v_lo_2
    fine_others_0 = fine_m_1 + fine_m_2
    fine_others_right_1 = fine_others_0 - fine_m_1
    fine_others_left_rest_1 = product_rest(v_1, fine_beta_v_1, fine_m_1,
        fine_others_0 - fine_others_right_1)
    fine_others_lo_1 = (fine_others_left_rest_1
        + product_rest(v_2, fine_beta_v_2, fine_m_2, fine_others_right_1)
        + (fine_m_cross2_2 + fine_m_cross2_3))
    fine_others_size_1 = fine_m_size_2 + fine_m_size_3
    fine_others_1 = fine_m_0 + fine_m_2
    fine_others_right_2 = fine_others_1 - fine_m_0
    fine_others_left_rest_2 = product_rest(v_0, fine_beta_v_0, fine_m_0,
        fine_others_1 - fine_others_right_2)
    fine_others_lo_2 = (fine_others_left_rest_2
        + product_rest(v_2, fine_beta_v_2, fine_m_2, fine_others_right_2)
        + (fine_m_cross2_1 + fine_m_cross2_3))
    fine_others_size_2 = fine_m_size_1 + fine_m_size_3
    fine_others_2 = fine_m_0 + fine_m_1
    fine_others_right_3 = fine_others_2 - fine_m_0
    fine_others_left_rest_3 = product_rest(v_0, fine_beta_v_0, fine_m_0,
        fine_others_2 - fine_others_right_3)
    fine_others_lo_3 = (fine_others_left_rest_3
        + product_rest(v_1, fine_beta_v_1, fine_m_1, fine_others_right_3)
        + (fine_m_cross2_1 + fine_m_cross2_2))
    fine_others_size_3 = fine_m_size_1 + fine_m_size_2
    fine_diagonal0a = 1 - fine_others_0
    fine_diagonal0a_right_1 = 1 - fine_diagonal0a
    fine_diagonal0a_lo = (1 - (fine_diagonal0a + fine_diagonal0a_right_1)
        - (fine_others_0 - fine_diagonal0a_right_1) - fine_others_lo_1)
    fine_diagonal0a_size_1 = 1 + fine_others_size_1
    fine_diagonal0b = fine_b_across + fine_m_0
    fine_diagonal0b_right_1 = fine_diagonal0b - fine_b_across
    fine_diagonal0b_right_rest_1 = product_rest(v_0, fine_beta_v_0, fine_m_0,
        fine_diagonal0b_right_1)
    fine_diagonal0b_lo = (fine_b_across - (fine_diagonal0b - fine_diagonal0b_right_1)
        + fine_diagonal0b_right_rest_1 + fine_m_cross2_1 + fine_b_across_lo)
    fine_diagonal0b_size_1 = fine_b_across_size_11 + fine_m_size_1
    fine_diagonal0c = fine_m_0 < fine_others_0
    fine_diagonal0_bound_1 = (absolute(product_error(v_0, fine_beta_v_0, fine_m_0)
        + fine_m_cross2_1) + c50 * (c2 + fine_m_size_1))
    fine_diagonal0_size_8 = (absolute(fine_diagonal0b_lo) + c51 * (c2 + fine_diagonal0b_size_1)
        + absolute(fine_diagonal0b - fine_diagonal0a))
    fine_diagonal0_size_5 = (fine_diagonal0_bound_1
        + (absolute(fine_others_lo_1) + c51 * (c2 + fine_others_size_1))
        < absolute(fine_m_0 - fine_others_0))
    fine_diagonal0_size_10 = where(fine_diagonal0_size_5, 0,
        absolute(fine_diagonal0a_lo) + c52 * (c2 + fine_diagonal0a_size_1) + fine_diagonal0_size_8)
    fine_diagonal1a = 1 - fine_others_1
    fine_diagonal1a_right_1 = 1 - fine_diagonal1a
    fine_diagonal1a_lo = (1 - (fine_diagonal1a + fine_diagonal1a_right_1)
        - (fine_others_1 - fine_diagonal1a_right_1) - fine_others_lo_2)
    fine_diagonal1a_size_1 = 1 + fine_others_size_2
    fine_diagonal1b = fine_b_across + fine_m_1
    fine_diagonal1b_right_1 = fine_diagonal1b - fine_b_across
    fine_diagonal1b_right_rest_1 = product_rest(v_1, fine_beta_v_1, fine_m_1,
        fine_diagonal1b_right_1)
    fine_diagonal1b_lo = (fine_b_across - (fine_diagonal1b - fine_diagonal1b_right_1)
        + fine_diagonal1b_right_rest_1 + fine_m_cross2_2 + fine_b_across_lo)
    fine_diagonal1b_size_1 = fine_b_across_size_11 + fine_m_size_2
    fine_diagonal1c = fine_m_1 < fine_others_1
    fine_diagonal1_bound_1 = (absolute(product_error(v_1, fine_beta_v_1, fine_m_1)
        + fine_m_cross2_2) + c50 * (c2 + fine_m_size_2))
    fine_diagonal1_size_8 = (absolute(fine_diagonal1b_lo) + c51 * (c2 + fine_diagonal1b_size_1)
        + absolute(fine_diagonal1b - fine_diagonal1a))
    fine_diagonal1_size_5 = (fine_diagonal1_bound_1
        + (absolute(fine_others_lo_2) + c51 * (c2 + fine_others_size_2))
        < absolute(fine_m_1 - fine_others_1))
    fine_diagonal1_size_10 = where(fine_diagonal1_size_5, 0,
        absolute(fine_diagonal1a_lo) + c52 * (c2 + fine_diagonal1a_size_1) + fine_diagonal1_size_8)
    fine_diagonal2a = 1 - fine_others_2
    fine_diagonal2a_right_1 = 1 - fine_diagonal2a
    fine_diagonal2a_lo = (1 - (fine_diagonal2a + fine_diagonal2a_right_1)
        - (fine_others_2 - fine_diagonal2a_right_1) - fine_others_lo_3)
    fine_diagonal2a_size_1 = 1 + fine_others_size_3
    fine_diagonal2b = fine_b_across + fine_m_2
    fine_diagonal2b_right_1 = fine_diagonal2b - fine_b_across
    fine_diagonal2b_right_rest_1 = product_rest(v_2, fine_beta_v_2, fine_m_2,
        fine_diagonal2b_right_1)
    fine_diagonal2b_lo = (fine_b_across - (fine_diagonal2b - fine_diagonal2b_right_1)
        + fine_diagonal2b_right_rest_1 + fine_m_cross2_3 + fine_b_across_lo)
    fine_diagonal2b_size_1 = fine_b_across_size_11 + fine_m_size_3
    fine_diagonal2c = fine_m_2 < fine_others_2
    fine_diagonal2_bound_1 = (absolute(product_error(v_2, fine_beta_v_2, fine_m_2)
        + fine_m_cross2_3) + c50 * (c2 + fine_m_size_3))
    fine_diagonal2_size_8 = (absolute(fine_diagonal2b_lo) + c51 * (c2 + fine_diagonal2b_size_1)
        + absolute(fine_diagonal2b - fine_diagonal2a))
    fine_diagonal2_size_5 = (fine_diagonal2_bound_1
        + (absolute(fine_others_lo_3) + c51 * (c2 + fine_others_size_3))
        < absolute(fine_m_2 - fine_others_2))
    fine_diagonal2_size_10 = where(fine_diagonal2_size_5, 0,
        absolute(fine_diagonal2a_lo) + c52 * (c2 + fine_diagonal2a_size_1) + fine_diagonal2_size_8)
    fine_R_01 = fine_m_3 - halved_2
    fine_R_right_1 = fine_m_3 - fine_R_01
    fine_R_02 = halved_1 + fine_m_4
    fine_R_right_2 = fine_R_02 - halved_1
    fine_R_10 = halved_2 + fine_m_3
    fine_R_right_3 = fine_R_10 - halved_2
    fine_R_12 = fine_m_5 - halved_0
    fine_R_right_4 = fine_m_5 - fine_R_12
    fine_R_20 = fine_m_4 - halved_1
    fine_R_right_5 = fine_m_4 - fine_R_20
    fine_R_21 = halved_0 + fine_m_5
    fine_R_right_6 = fine_R_21 - halved_0
    diagonal0_apart_1 = where(fine_diagonal0c, fine_diagonal0b, fine_diagonal0a) - diagonal0
    diagonal0_rest_1 = (c55
        * (c2
        + (where(fine_diagonal0c, fine_diagonal0b_size_1, fine_diagonal0a_size_1) + c53
        * fine_diagonal0_size_10)))
    fine_R_lo_1 = (product_rest(v_1, fine_beta_v_0, fine_m_3, fine_R_01 + fine_R_right_1)
        - (halved_2 - fine_R_right_1) + fine_m_cross2_4)
    R_rest_1 = c51 * (c2 + (fine_m_padded_1 * halved_size_3 + halved_size_6))
    fine_R_lo_2 = (halved_1 - (fine_R_02 - fine_R_right_2)
        + product_rest(v_2, fine_beta_v_0, fine_m_4, fine_R_right_2) + fine_m_cross2_5)
    R_rest_2 = c51 * (c2 + (fine_m_padded_1 * halved_size_5 + halved_size_4))
    fine_R_lo_3 = (halved_2 - (fine_R_10 - fine_R_right_3)
        + product_rest(v_1, fine_beta_v_0, fine_m_3, fine_R_right_3) + fine_m_cross2_4)
    diagonal1_apart_1 = where(fine_diagonal1c, fine_diagonal1b, fine_diagonal1a) - diagonal1
    diagonal1_rest_1 = (c55
        * (c2
        + (where(fine_diagonal1c, fine_diagonal1b_size_1, fine_diagonal1a_size_1) + c53
        * fine_diagonal1_size_10)))
    fine_R_lo_4 = (product_rest(v_2, fine_beta_v_1, fine_m_5, fine_R_12 + fine_R_right_4)
        - (halved_0 - fine_R_right_4) + fine_m_cross2_6)
    R_rest_3 = c51 * (c2 + (fine_m_padded_2 * halved_size_5 + halved_size_2))
    fine_R_lo_5 = (product_rest(v_2, fine_beta_v_0, fine_m_4, fine_R_20 + fine_R_right_5)
        - (halved_1 - fine_R_right_5) + fine_m_cross2_5)
    fine_R_lo_6 = (halved_0 - (fine_R_21 - fine_R_right_6)
        + product_rest(v_2, fine_beta_v_1, fine_m_5, fine_R_right_6) + fine_m_cross2_6)
    diagonal2_apart_1 = where(fine_diagonal2c, fine_diagonal2b, fine_diagonal2a) - diagonal2
    diagonal2_rest_1 = (c55
        * (c2
        + (where(fine_diagonal2c, fine_diagonal2b_size_1, fine_diagonal2a_size_1) + c53
        * fine_diagonal2_size_10)))
    diagonal0_bound_1 = (c54
        * absolute(diagonal0_apart_1
        + where(fine_diagonal0c, fine_diagonal0b_lo, fine_diagonal0a_lo)) + diagonal0_rest_1)
    R_bound_1 = c54 * absolute(fine_R_01 - R_01 + fine_R_lo_1) + R_rest_1
    R_bound_2 = c54 * absolute(fine_R_02 - R_02 + fine_R_lo_2) + R_rest_2
    R_bound_3 = c54 * absolute(fine_R_10 - R_10 + fine_R_lo_3) + R_rest_1
    diagonal1_bound_1 = (c54
        * absolute(diagonal1_apart_1
        + where(fine_diagonal1c, fine_diagonal1b_lo, fine_diagonal1a_lo)) + diagonal1_rest_1)
    R_bound_4 = c54 * absolute(fine_R_12 - R_12 + fine_R_lo_4) + R_rest_3
    R_bound_5 = c54 * absolute(fine_R_20 - R_20 + fine_R_lo_5) + R_rest_2
    R_bound_6 = c54 * absolute(fine_R_21 - R_21 + fine_R_lo_6) + R_rest_3
    diagonal2_bound_1 = (c54
        * absolute(diagonal2_apart_1
        + where(fine_diagonal2c, fine_diagonal2b_lo, fine_diagonal2a_lo)) + diagonal2_rest_1)
    return (diagonal0, R_01, R_02, R_10, diagonal1, R_12, R_20, R_21, diagonal2, diagonal0_bound_1,
        R_bound_1, R_bound_2, R_bound_3, diagonal1_bound_1, R_bound_4, R_bound_5, R_bound_6,
        diagonal2_bound_1)


@kernel("(3,3)->(3,3),(3,3)")
@errstate(all="ignore")
def mat3x3_orthonormalize(self, *, c1=2.004168360008973e-292, c2=9.992007221626415e-16,
        c3=8.881784197001258e-16):
    """self = R + R (I - R^T R)/2, closer to a rotation: a defect d of R becomes 3/4 d^2; |error of
    self| <= self_bound unless inf or NaN.

    (3,3)->(3,3),(3,3).  self, self_bound: rotation or other 3×3 matrix.
    93 mul, 105 add, 3 neg, 27 abs.
    """
    self_00, self_01, self_02, self_10, self_11, self_12, self_20, self_21, self_22 = self
    defect_0a = self_00 * self_00
    defect_0c = self_10 * self_10
    defect_0e = self_20 * self_20
    defect_0 = 1 - defect_0a - defect_0c - defect_0e
    defect_1a = self_01 * self_01
    defect_1c = self_11 * self_11
    defect_1e = self_21 * self_21
    defect_1 = 1 - defect_1a - defect_1c - defect_1e
    defect_2a = self_02 * self_02
    defect_2c = self_12 * self_12
    defect_2e = self_22 * self_22
    defect_2 = 1 - defect_2a - defect_2c - defect_2e
    defect_3a = self_00 * self_01
    defect_3b = self_10 * self_11
    defect_3d = self_20 * self_21
    defect_3 = -(defect_3a + defect_3b + defect_3d)
    defect_4a = self_00 * self_02
    defect_4b = self_10 * self_12
    defect_4d = self_20 * self_22
    defect_4 = -(defect_4a + defect_4b + defect_4d)
    defect_5a = self_01 * self_02
    defect_5b = self_11 * self_12
    defect_5d = self_21 * self_22
    defect_5 = -(defect_5a + defect_5b + defect_5d)
    correction_0 = 0.5 * defect_0
    correction_1 = 0.5 * defect_1
    correction_2 = 0.5 * defect_2
    correction_3 = 0.5 * defect_3
    correction_4 = 0.5 * defect_4
    correction_5 = 0.5 * defect_5
    self_00_new = (self_00
        + (self_00 * correction_0 + self_01 * correction_3 + self_02 * correction_4))
    self_01_new = self_00 * correction_3 + self_01 * correction_1 + self_02 * correction_5 + self_01
    self_02_new = self_00 * correction_4 + self_01 * correction_5 + self_02 * correction_2 + self_02
    self_10_new = (self_10
        + (self_10 * correction_0 + self_11 * correction_3 + self_12 * correction_4))
    self_11_new = self_10 * correction_3 + self_11 * correction_1 + self_12 * correction_5 + self_11
    self_12_new = self_10 * correction_4 + self_11 * correction_5 + self_12 * correction_2 + self_12
    self_20_new = (self_20
        + (self_20 * correction_0 + self_21 * correction_3 + self_22 * correction_4))
    self_21_new = self_20 * correction_3 + self_21 * correction_1 + self_22 * correction_5 + self_21
    self_22_new = self_20 * correction_4 + self_21 * correction_5 + self_22 * correction_2 + self_22
    defect_0_size = 1 + absolute(defect_0a) + absolute(defect_0c) + absolute(defect_0e)
    defect_1_size = 1 + absolute(defect_1a) + absolute(defect_1c) + absolute(defect_1e)
    defect_2_size = 1 + absolute(defect_2a) + absolute(defect_2c) + absolute(defect_2e)
    correction_0_size = 0.5 * (defect_0_size + c1)
    correction_1_size = 0.5 * (defect_1_size + c1)
    correction_2_size = 0.5 * (defect_2_size + c1)
    correction_3_size = 0.5 * (absolute(defect_3a) + absolute(defect_3b) + absolute(defect_3d) + c1)
    correction_4_size = 0.5 * (absolute(defect_4a) + absolute(defect_4b) + absolute(defect_4d) + c1)
    correction_5_size = 0.5 * (absolute(defect_5a) + absolute(defect_5b) + absolute(defect_5d) + c1)
    correction_0_padded = correction_0_size + c1
    self_00_abs = absolute(self_00)
    correction_3_padded = correction_3_size + c1
    self_01_abs = absolute(self_01)
    correction_4_padded = correction_4_size + c1
    self_02_abs = absolute(self_02)
    self_00_new_size = (self_00_abs
        + (self_00_abs * correction_0_padded + self_01_abs * correction_3_padded + self_02_abs
        * correction_4_padded))
    correction_1_padded = correction_1_size + c1
    correction_5_padded = correction_5_size + c1
    self_01_new_size = (self_00_abs * correction_3_padded + self_01_abs * correction_1_padded
        + self_02_abs * correction_5_padded + self_01_abs)
    correction_2_padded = correction_2_size + c1
    self_02_new_size = (self_00_abs * correction_4_padded + self_01_abs * correction_5_padded
        + self_02_abs * correction_2_padded + self_02_abs)
    self_10_abs = absolute(self_10)
    self_11_abs = absolute(self_11)
    self_12_abs = absolute(self_12)
    self_10_new_size = (self_10_abs
        + (self_10_abs * correction_0_padded + self_11_abs * correction_3_padded + self_12_abs
        * correction_4_padded))
    self_11_new_size = (self_10_abs * correction_3_padded + self_11_abs * correction_1_padded
        + self_12_abs * correction_5_padded + self_11_abs)
    self_12_new_size = (self_10_abs * correction_4_padded + self_11_abs * correction_5_padded
        + self_12_abs * correction_2_padded + self_12_abs)
    self_20_abs = absolute(self_20)
    self_21_abs = absolute(self_21)
    self_22_abs = absolute(self_22)
    self_20_new_size = (self_20_abs
        + (self_20_abs * correction_0_padded + self_21_abs * correction_3_padded + self_22_abs
        * correction_4_padded))
    self_21_new_size = (self_20_abs * correction_3_padded + self_21_abs * correction_1_padded
        + self_22_abs * correction_5_padded + self_21_abs)
    self_22_new_size = (self_20_abs * correction_4_padded + self_21_abs * correction_5_padded
        + self_22_abs * correction_2_padded + self_22_abs)
    self_00_new_bound = c2 * (self_00_new_size + c1)
    self_01_new_bound = c2 * (self_01_new_size + c1)
    self_02_new_bound = c3 * (self_02_new_size + c1)
    self_10_new_bound = c2 * (self_10_new_size + c1)
    self_11_new_bound = c2 * (self_11_new_size + c1)
    self_12_new_bound = c3 * (self_12_new_size + c1)
    self_20_new_bound = c2 * (self_20_new_size + c1)
    self_21_new_bound = c2 * (self_21_new_size + c1)
    self_22_new_bound = c3 * (self_22_new_size + c1)
    return (self_00_new, self_01_new, self_02_new, self_10_new, self_11_new, self_12_new,
        self_20_new, self_21_new, self_22_new, self_00_new_bound, self_01_new_bound,
        self_02_new_bound, self_10_new_bound, self_11_new_bound, self_12_new_bound,
        self_20_new_bound, self_21_new_bound, self_22_new_bound)


@kernel("(3,3)->(3,3),(3,3)")
@errstate(all="ignore")
def mat3x3_orthonormalized(R, *, c1=2.004168360008973e-292, c2=9.992007221626415e-16,
        c3=8.881784197001258e-16):
    """Ro = R + R (I - R^T R)/2, closer to a rotation: a defect d of R becomes 3/4 d^2; |error of
    Ro| <= Ro_bound unless inf or NaN.

    (3,3)->(3,3),(3,3).  R, Ro, Ro_bound: rotation or other 3×3 matrix.
    93 mul, 105 add, 3 neg, 27 abs.
    """
    R_00, R_01, R_02, R_10, R_11, R_12, R_20, R_21, R_22 = R
    defect_0a = R_00 * R_00
    defect_0c = R_10 * R_10
    defect_0e = R_20 * R_20
    defect_0 = 1 - defect_0a - defect_0c - defect_0e
    defect_1a = R_01 * R_01
    defect_1c = R_11 * R_11
    defect_1e = R_21 * R_21
    defect_1 = 1 - defect_1a - defect_1c - defect_1e
    defect_2a = R_02 * R_02
    defect_2c = R_12 * R_12
    defect_2e = R_22 * R_22
    defect_2 = 1 - defect_2a - defect_2c - defect_2e
    defect_3a = R_00 * R_01
    defect_3b = R_10 * R_11
    defect_3d = R_20 * R_21
    defect_3 = -(defect_3a + defect_3b + defect_3d)
    defect_4a = R_00 * R_02
    defect_4b = R_10 * R_12
    defect_4d = R_20 * R_22
    defect_4 = -(defect_4a + defect_4b + defect_4d)
    defect_5a = R_01 * R_02
    defect_5b = R_11 * R_12
    defect_5d = R_21 * R_22
    defect_5 = -(defect_5a + defect_5b + defect_5d)
    correction_0 = 0.5 * defect_0
    correction_1 = 0.5 * defect_1
    correction_2 = 0.5 * defect_2
    correction_3 = 0.5 * defect_3
    correction_4 = 0.5 * defect_4
    correction_5 = 0.5 * defect_5
    Ro_00 = R_00 + (R_00 * correction_0 + R_01 * correction_3 + R_02 * correction_4)
    Ro_01 = R_00 * correction_3 + R_01 * correction_1 + R_02 * correction_5 + R_01
    Ro_02 = R_00 * correction_4 + R_01 * correction_5 + R_02 * correction_2 + R_02
    Ro_10 = R_10 + (R_10 * correction_0 + R_11 * correction_3 + R_12 * correction_4)
    Ro_11 = R_10 * correction_3 + R_11 * correction_1 + R_12 * correction_5 + R_11
    Ro_12 = R_10 * correction_4 + R_11 * correction_5 + R_12 * correction_2 + R_12
    Ro_20 = R_20 + (R_20 * correction_0 + R_21 * correction_3 + R_22 * correction_4)
    Ro_21 = R_20 * correction_3 + R_21 * correction_1 + R_22 * correction_5 + R_21
    Ro_22 = R_20 * correction_4 + R_21 * correction_5 + R_22 * correction_2 + R_22
    defect_0_size = 1 + absolute(defect_0a) + absolute(defect_0c) + absolute(defect_0e)
    defect_1_size = 1 + absolute(defect_1a) + absolute(defect_1c) + absolute(defect_1e)
    defect_2_size = 1 + absolute(defect_2a) + absolute(defect_2c) + absolute(defect_2e)
    correction_0_size = 0.5 * (defect_0_size + c1)
    correction_1_size = 0.5 * (defect_1_size + c1)
    correction_2_size = 0.5 * (defect_2_size + c1)
    correction_3_size = 0.5 * (absolute(defect_3a) + absolute(defect_3b) + absolute(defect_3d) + c1)
    correction_4_size = 0.5 * (absolute(defect_4a) + absolute(defect_4b) + absolute(defect_4d) + c1)
    correction_5_size = 0.5 * (absolute(defect_5a) + absolute(defect_5b) + absolute(defect_5d) + c1)
    correction_0_padded = correction_0_size + c1
    R_00_abs = absolute(R_00)
    correction_3_padded = correction_3_size + c1
    R_01_abs = absolute(R_01)
    correction_4_padded = correction_4_size + c1
    R_02_abs = absolute(R_02)
    Ro_00_size = (R_00_abs
        + (R_00_abs * correction_0_padded + R_01_abs * correction_3_padded + R_02_abs
        * correction_4_padded))
    correction_1_padded = correction_1_size + c1
    correction_5_padded = correction_5_size + c1
    Ro_01_size = (R_00_abs * correction_3_padded + R_01_abs * correction_1_padded + R_02_abs
        * correction_5_padded + R_01_abs)
    correction_2_padded = correction_2_size + c1
    Ro_02_size = (R_00_abs * correction_4_padded + R_01_abs * correction_5_padded + R_02_abs
        * correction_2_padded + R_02_abs)
    R_10_abs = absolute(R_10)
    R_11_abs = absolute(R_11)
    R_12_abs = absolute(R_12)
    Ro_10_size = (R_10_abs
        + (R_10_abs * correction_0_padded + R_11_abs * correction_3_padded + R_12_abs
        * correction_4_padded))
    Ro_11_size = (R_10_abs * correction_3_padded + R_11_abs * correction_1_padded + R_12_abs
        * correction_5_padded + R_11_abs)
    Ro_12_size = (R_10_abs * correction_4_padded + R_11_abs * correction_5_padded + R_12_abs
        * correction_2_padded + R_12_abs)
    R_20_abs = absolute(R_20)
    R_21_abs = absolute(R_21)
    R_22_abs = absolute(R_22)
    Ro_20_size = (R_20_abs
        + (R_20_abs * correction_0_padded + R_21_abs * correction_3_padded + R_22_abs
        * correction_4_padded))
    Ro_21_size = (R_20_abs * correction_3_padded + R_21_abs * correction_1_padded + R_22_abs
        * correction_5_padded + R_21_abs)
    Ro_22_size = (R_20_abs * correction_4_padded + R_21_abs * correction_5_padded + R_22_abs
        * correction_2_padded + R_22_abs)
    Ro_00_bound = c2 * (Ro_00_size + c1)
    Ro_01_bound = c2 * (Ro_01_size + c1)
    Ro_02_bound = c3 * (Ro_02_size + c1)
    Ro_10_bound = c2 * (Ro_10_size + c1)
    Ro_11_bound = c2 * (Ro_11_size + c1)
    Ro_12_bound = c3 * (Ro_12_size + c1)
    Ro_20_bound = c2 * (Ro_20_size + c1)
    Ro_21_bound = c2 * (Ro_21_size + c1)
    Ro_22_bound = c3 * (Ro_22_size + c1)
    return (Ro_00, Ro_01, Ro_02, Ro_10, Ro_11, Ro_12, Ro_20, Ro_21, Ro_22, Ro_00_bound, Ro_01_bound,
        Ro_02_bound, Ro_10_bound, Ro_11_bound, Ro_12_bound, Ro_20_bound, Ro_21_bound, Ro_22_bound)


@kernel("(6)->(3,4),(3,4)")
@errstate(all="ignore")
def SE3_exp(s, *, c1=268435456, c2=1.8051943758648296e-276, c3=2.5021685128863245e-30,
        c4=140737488355328, c5=2.567393169377981e+29, c6=4.240128211918887e-30,
        c7=9.054644677292507e+28, c8=1.1389183198259759e-29, c9=9.25185853854297e-18,
        c10=2290649224.7000003, c11=8.120831909935717e-28, c12=1.8842277118313698e-29,
        c13=1.2325982855554354e+27, c14=8.677471603123253e-30, c15=8.120832873841084e-28,
        c16=2.8103175390871538e-30, c17=5.28187582188787e+28, c18=1.9524315162482833e-29,
        c19=5.586290567888806e-51, c20=5.702613188320821e-10, c21=1.0498015412959506e-47,
        c22=8.12514599395154e-28, c23=1.4303150396787322e-45, c24=8.19207783918962e-28,
        c25=-1.9330404233703465e-42, c26=8.261228355723635e-28, c27=-8.843177655482344e-40,
        c28=8.332597543553583e-28, c29=-1.3643503830087908e-36, c30=8.406185404560257e-28,
        c31=2.2141894119604265e-34, c32=8.481991936862865e-28, c33=1.6508842730861433e-31,
        c34=8.560017140461409e-28, c35=7.03872877733453e-30, c36=8.640261015355885e-28,
        c37=1.2585294588752098e-26, c38=8.722723561546295e-28, c39=-1.448814070935912e-24,
        c40=8.80740477903264e-28, c41=-1.858393274046472e-22, c42=8.894304667814918e-28,
        c43=1.7209558293420705e-22, c44=8.98342322789313e-28, c45=1.1564823173178714e-19,
        c46=9.07476046114807e-28, c47=9.168316367579732e-28, c48=8.304820816109472e-28,
        c49=1.0948341329470242e+27, c50=9.168317334306286e-28, c51=1.8735448849987806e-30,
        c52=8.202927567412116e-28, c53=8.219445306520549e-28, c54=8.236702602727626e-28,
        c55=1.2161163344889557e+27, c56=1.0000000000000009, c57=8.236703566632994e-28,
        c58=9.291457458136845e-28):
    """D = exp s = [exp ω~ | J_l(ω) v]; |error of D| <= D_bound unless inf or NaN.

    (6)->(3,4),(3,4).  s: screw (v in m/s; ω in rad/s); D, D_bound: displacement [R | t], R
    rotation, t in m.
    524 mul, 876 add, 24 product error, 58 product rest, 16 div, 3 sqrt, 102 abs, 20 less, 1
    equal, 46 select.
    """
    s_0, s_1, s_2, s_3, s_4, s_5 = s
    size_0 = absolute(s_3)
    size_1 = absolute(s_4)
    size_2 = absolute(s_5)
    sizes = size_0 + size_1 + size_2
    grid = sizes * c1
    shifted_0 = s_3 + grid
    shifted_1 = s_4 + grid
    shifted_2 = s_5 + grid
    high_0 = shifted_0 - grid
    high_1 = shifted_1 - grid
    high_2 = shifted_2 - grid
    low_0 = s_3 - high_0
    low_1 = s_4 - high_1
    low_2 = s_5 - high_2
    sum_0 = s_3 + high_0
    sum_1 = s_4 + high_1
    sum_2 = s_5 + high_2
    squares = high_0 * high_0 + high_1 * high_1 + high_2 * high_2
    cross = low_0 * sum_0 + low_1 * sum_1 + low_2 * sum_2
    x = squares + cross
    theta_b = x < 1
    theta = where(theta_b, 1, sqrt(x))
    theta_shifted = grid + theta
    theta_high = theta_shifted - grid
    theta_low = theta - theta_high
    theta_sum = theta + theta_high
    cross_rest = cross - theta_low * theta_sum
    exact = squares - theta_high * theta_high
    residual = cross_rest + exact
    small = 0.5 * residual / theta
    delta = where(absolute(small) < 0.0078125, small, 0)
    far_sine_a, far_cosine_a = elementary.sincos(theta)
    far_sine = where(theta_b, 1, far_sine_a)
    far_cosine = where(theta_b, 0, far_cosine_a)
    sine = delta * far_cosine + far_sine
    cosine = far_cosine - delta * far_sine
    far_x = where(theta_b, 1, x)
    middle_x_a = x < 4
    middle_x = where(middle_x_a, 4, x)
    closed1 = sine / theta
    versine = 1 - cosine
    closed2 = versine / far_x
    rest3 = 1 - closed1
    closed3 = rest3 / middle_x
    g1h = (x
        * (x * (x * (6.446950284384474e-26 * x - 3.868170170630684e-23) + 1.9572941063391263e-20)
        - 8.22063524662433e-18) + 2.8114572543455206e-15)
    g1q = (x
        * (x
        * (x * (x * (x * g1h - 7.647163731819816e-13) + 1.6059043836821613e-10)
        - 2.505210838544172e-08) + 2.7557319223985893e-06))
    g1 = where(theta_b,
        x * (x * (x * (g1q - 0.0001984126984126984) + 0.008333333333333333) - 0.16666666666666666) +
            1,
        closed1)
    g2h = (x
        * (x * (x * (2.4795962632247976e-27 * x - 1.6117375710961184e-24) + 8.896791392450574e-22)
        - 4.110317623312165e-19) + 1.5619206968586225e-16)
    g2q = (x
        * (x
        * (x * (x * (x * g2h - 4.779477332387385e-14) + 1.1470745597729725e-11)
        - 2.08767569878681e-09) + 2.755731922398589e-07))
    g2 = where(theta_b,
        x * (x * (x * (g2q - 2.48015873015873e-05) + 0.001388888888888889) - 0.041666666666666664) +
            0.5,
        closed2)
    g3h = (x
        * (x * (x * (9.183689863795546e-29 * x - 6.446950284384474e-26) + 3.868170170630684e-23)
        - 1.9572941063391263e-20) + 8.22063524662433e-18)
    g3q = (x
        * (x
        * (x * (x * (x * g3h - 2.8114572543455206e-15) + 7.647163731819816e-13)
        - 1.6059043836821613e-10) + 2.505210838544172e-08))
    g3 = where(middle_x_a,
        x * (x * (x * (g3q - 2.7557319223985893e-06) + 0.0001984126984126984) -
            0.008333333333333333) + 0.16666666666666666,
        closed3)
    g0 = where(theta_b, 1 - x * g2, cosine)
    u_0 = s_2 * s_4 - s_1 * s_5
    u_1 = s_0 * s_5 - s_2 * s_3
    u_2 = s_1 * s_3 - s_0 * s_4
    turned_0 = g2 * u_0
    turned_1 = g2 * u_1
    turned_2 = g2 * u_2
    wv = s_0 * s_3 + s_1 * s_4 + s_2 * s_5
    pitch = g3 * wv
    along_0 = s_3 * pitch
    along_1 = s_4 * pitch
    along_2 = s_5 * pitch
    beta_v_0 = s_3 * g2
    beta_v_1 = s_4 * g2
    beta_v_2 = s_5 * g2
    m_0 = s_3 * beta_v_0
    m_1 = s_4 * beta_v_1
    m_2 = s_5 * beta_v_2
    m_3 = s_4 * beta_v_0
    m_4 = s_5 * beta_v_0
    m_5 = s_5 * beta_v_1
    others_0 = m_1 + m_2
    others_1 = m_0 + m_2
    others_2 = m_0 + m_1
    diagonal0 = where(m_0 < others_0, g0 + m_0, 1 - others_0)
    diagonal1 = where(m_1 < others_1, g0 + m_1, 1 - others_1)
    diagonal2 = where(m_2 < others_2, g0 + m_2, 1 - others_2)
    alpha_v_0 = s_3 * g1
    alpha_v_1 = s_4 * g1
    alpha_v_2 = s_5 * g1
    across_axis_0 = turned_0 + along_0
    across_axis_1 = turned_1 + along_1
    across_axis_2 = turned_2 + along_2
    D_01 = m_3 - alpha_v_2
    D_02 = m_4 + alpha_v_1
    D_03 = s_0 * g1 + across_axis_0
    D_10 = m_3 + alpha_v_2
    D_12 = m_5 - alpha_v_0
    D_13 = s_1 * g1 + across_axis_1
    D_20 = m_4 - alpha_v_1
    D_21 = m_5 + alpha_v_0
    D_23 = s_2 * g1 + across_axis_2
    halved_0 = 0.5 * s_3
    halved_size_1 = absolute(s_3)
    halved_1 = 0.5 * s_4
    halved_size_3 = absolute(s_4)
    halved_2 = 0.5 * s_5
    halved_size_5 = absolute(s_5)
    y_a = halved_0 * halved_0
    y_a_padded_1 = c2 + 0.5 * halved_size_1
    y_b = halved_1 * halved_1
    y_b_padded_1 = c2 + 0.5 * halved_size_3
    y_c = y_a + y_b
    y_c_right_1 = y_c - y_a
    y_d = halved_2 * halved_2
    y_d_padded_1 = c2 + 0.5 * halved_size_5
    y = y_c + y_d
    y_right_1 = y - y_c
    y_c_lo = (product_rest(halved_0, halved_0, y_a, y_c - y_c_right_1)
        + product_rest(halved_1, halved_1, y_b, y_c_right_1))
    y_lo = y_c - (y - y_right_1) + product_rest(halved_2, halved_2, y_d, y_right_1) + y_c_lo
    y_size_1 = (y_a_padded_1 * y_a_padded_1 + y_b_padded_1 * y_b_padded_1 + y_d_padded_1
        * y_d_padded_1)
    half_angle = sqrt(y)
    half_angle_product_1 = half_angle * half_angle
    half_angle_residual_1 = (y - half_angle_product_1
        - product_error(half_angle, half_angle, half_angle_product_1) + y_lo)
    half_angle_lo = half_angle_residual_1 / where(half_angle == 0, 1, half_angle + half_angle)
    half_angle_padded_1 = c2 + y_size_1
    half_angle_bound_1 = absolute(y_lo) + c3 * half_angle_padded_1
    half_angle_size_6 = absolute(half_angle_lo)
    half_angle_size_4 = ((absolute(y) + c4 * half_angle_bound_1)
        * (half_angle_padded_1 / half_angle / y))
    half_angle_size_12 = (half_angle
        + where(4 * half_angle_bound_1 < y, half_angle_size_4, c5
        * (sqrt(half_angle_bound_1) + half_angle_size_6)))
    fine_sine, c = elementary.sincos(half_angle)
    fine_sine_own_error_1, c_own_error_1 = elementary.sincos_error(half_angle, fine_sine, c)
    fine_sine_half_1 = half_angle_lo * 0.5
    fine_sine_half_sin_1, fine_sine_half_cos_1 = elementary.sincos(fine_sine_half_1)
    fine_sine_twice_1 = fine_sine_half_sin_1 + fine_sine_half_sin_1
    fine_sine_lo = (fine_sine_own_error_1
        + (fine_sine_half_cos_1 * c - fine_sine_half_sin_1 * fine_sine) * fine_sine_twice_1)
    fine_sine_padded_1 = c2 + half_angle_size_12
    fine_sine_size_1 = 1 + fine_sine_padded_1
    c_lo = (c_own_error_1 - (fine_sine_half_cos_1 * fine_sine + fine_sine_half_sin_1 * c)
        * fine_sine_twice_1)
    sinc_divisor_a = half_angle < 1.4901161193847656e-08
    sinc_divisor = where(sinc_divisor_a, 1.4901161193847656e-08, half_angle)
    sinc_divisor_lo = where(sinc_divisor_a, 0, half_angle_lo)
    sinc_divisor_bound_1 = half_angle_size_6 + c6 * fine_sine_padded_1
    sinc_divisor_size_4 = sinc_divisor_bound_1 < absolute(half_angle - 1.4901161193847656e-08)
    sinc_divisor_size_9 = (c7
        * where(sinc_divisor_size_4, 0, sinc_divisor_bound_1
        + absolute(1.4901161193847656e-08 - half_angle)))
    sinc_quotient = fine_sine / sinc_divisor
    sinc_quotient_product_1 = sinc_quotient * sinc_divisor
    sinc_quotient_numerator_1 = (fine_sine - sinc_quotient_product_1
        - product_error(sinc_quotient, sinc_divisor, sinc_quotient_product_1) + fine_sine_lo)
    sinc_quotient_lo = (sinc_quotient_numerator_1 - sinc_quotient * sinc_divisor_lo) / sinc_divisor
    sinc_quotient_padded_2 = (c2
        + (where(sinc_divisor_a, 1.4901161193847656e-08, half_angle_size_12) + sinc_divisor_size_9))
    sinc_quotient_size_1 = absolute(sinc_quotient)
    sinc_quotient_size_2 = absolute(sinc_divisor)
    sinc_quotient_bound_1 = absolute(sinc_divisor_lo) + c8 * sinc_quotient_padded_2
    sinc_quotient_size_7 = where(4 * sinc_quotient_bound_1 < sinc_quotient_size_2,
        sinc_quotient_size_2, 0)
    sinc_quotient_size_8 = ((c2 + fine_sine_size_1 + sinc_quotient_padded_2 * sinc_quotient_size_1)
        / sinc_quotient_size_7)
    sinc_quotient_size_11 = (sinc_quotient_size_1
        + (sinc_quotient_size_2 + c4 * sinc_quotient_bound_1) * sinc_quotient_size_8
        / sinc_quotient_size_2)
    sinc_a = 0.16666666666666666 * y
    sinc_b = 1 - sinc_a
    sinc_b_right_1 = 1 - sinc_b
    sinc_b_lo = (1 - (sinc_b + sinc_b_right_1)
        - product_rest(0.16666666666666666, y, sinc_a, sinc_b_right_1)
        - (c9 * y + 0.16666666666666666 * y_lo))
    sinc_b_size_1 = 1 + c10 * y_size_1
    sinc = where(sinc_divisor_a, sinc_b, sinc_quotient)
    sinc_lo = where(sinc_divisor_a, sinc_b_lo, sinc_quotient_lo)
    sinc_size_4 = (absolute(sinc_b_lo) + c11 * (c2 + sinc_b_size_1)
        + absolute(sinc_b - sinc_quotient))
    sinc_size_7 = (c13
        * where(sinc_divisor_size_4, 0, absolute(sinc_quotient_lo) + c12
        * (c2 + sinc_quotient_size_11) + sinc_size_4))
    fine_g1 = c * sinc
    fine_g1_cross_1 = c_lo * sinc + c * sinc_lo
    fine_g1_padded_1 = (c2
        + (where(sinc_divisor_a, sinc_b_size_1, sinc_quotient_size_11) + sinc_size_7))
    fine_g1_rest_1 = c14 * fine_sine_size_1
    fine_g1_reach_2 = absolute(sinc) + c4 * (absolute(sinc_lo) + c15 * fine_g1_padded_1)
    fine_g1_size_5 = (fine_g1_padded_1 * (absolute(c) + c4 * (absolute(c_lo) + fine_g1_rest_1))
        + fine_g1_reach_2 * fine_sine_size_1)
    fine_g2a = sinc * sinc
    fine_g2a_size_1 = fine_g1_padded_1 * fine_g1_reach_2
    fine_g2 = 0.5 * fine_g2a
    fine_g2_cross2_1 = (0.5
        * (product_error(sinc, sinc, fine_g2a) + (sinc_lo * sinc + sinc * sinc_lo)))
    sine_square = fine_sine * fine_sine
    sine_square_size_2 = (fine_sine_size_1
        * (absolute(fine_sine) + c4 * (fine_g1_rest_1 + absolute(fine_sine_lo))))
    fine_g0a = 2 * sine_square
    fine_g0 = 1 - fine_g0a
    fine_g0_right_1 = 1 - fine_g0
    fine_g0a_cross2_1 = (2
        * (product_error(fine_sine, fine_sine, sine_square)
        + (fine_sine_lo * fine_sine + fine_sine * fine_sine_lo)))
    fine_g0_lo = 1 - (fine_g0 + fine_g0_right_1) - (fine_g0a - fine_g0_right_1) - fine_g0a_cross2_1
    fine_g0_size_1 = 1 + 2 * (sine_square_size_2 + sine_square_size_2)
    fine_rest3 = 1 - fine_g1
    fine_rest3_right_1 = 1 - fine_rest3
    fine_x = 4 * y
    fine_x_cross2_1 = 4 * y_lo
    fine_x_size_1 = 4 * y_size_1
    far_x_a = fine_x < 1
    fine_far_x = where(far_x_a, 1, fine_x)
    fine_far_x_lo = where(far_x_a, 0, fine_x_cross2_1)
    fine_far_x_padded_1 = c2 + fine_x_size_1
    fine_far_x_bound_1 = absolute(fine_x_cross2_1) + c16 * fine_far_x_padded_1
    fine_far_x_size_4 = fine_far_x_bound_1 < absolute(fine_x - 1)
    fine_closed3 = fine_rest3 / fine_far_x
    fine_closed3_product_1 = fine_closed3 * fine_far_x
    fine_rest3_lo = (1 - (fine_rest3 + fine_rest3_right_1)
        - product_rest(c, sinc, fine_g1, fine_rest3_right_1) - fine_g1_cross_1)
    fine_closed3_numerator_1 = (fine_rest3 - fine_closed3_product_1
        - product_error(fine_closed3, fine_far_x, fine_closed3_product_1) + fine_rest3_lo)
    fine_closed3_lo = (fine_closed3_numerator_1 - fine_closed3 * fine_far_x_lo) / fine_far_x
    fine_closed3_padded_2 = (c2
        + (where(far_x_a, 1, fine_x_size_1) + c17
        * where(fine_far_x_size_4, 0, fine_far_x_bound_1 + absolute(1 - fine_x))))
    fine_closed3_size_1 = absolute(fine_closed3)
    fine_closed3_size_2 = absolute(fine_far_x)
    fine_closed3_bound_1 = absolute(fine_far_x_lo) + c18 * fine_closed3_padded_2
    fine_closed3_size_7 = where(4 * fine_closed3_bound_1 < fine_closed3_size_2, fine_closed3_size_2,
        0)
    fine_closed3_size_8 = ((c2 + (1 + fine_g1_size_5) + fine_closed3_padded_2
        * fine_closed3_size_1) / fine_closed3_size_7)
    fine_closed3_size_11 = (fine_closed3_size_1 + (fine_closed3_size_2 + c4 * fine_closed3_bound_1)
        * fine_closed3_size_8 / fine_closed3_size_2)
    series5a = 1.216125041553518e-34 * fine_x
    series5b = 1.1309962886447716e-31 - series5a
    series5b_right_1 = 1.1309962886447716e-31 - series5b
    series5b_lo1_1 = (1.1309962886447716e-31 - (series5b + series5b_right_1)
        - product_rest(1.216125041553518e-34, fine_x, series5a, series5b_right_1))
    series5b_lo = series5b_lo1_1 - (c19 * fine_x + 1.216125041553518e-34 * fine_x_cross2_1) + c21
    series5c = fine_x * series5b
    series5c_padded_1 = c2 + (1.1309962886447716e-31 + c20 * fine_x_size_1)
    series5c_reach_1 = absolute(fine_x) + c4 * fine_far_x_bound_1
    series5c_size_4 = (fine_far_x_padded_1
        * (absolute(series5b) + c4 * (absolute(series5b_lo) + c22 * series5c_padded_1)))
    series5d = series5c - 9.183689863795546e-29
    series5d_right_1 = series5c - series5d
    series5d_lo2_1 = (product_rest(fine_x, series5b, series5c, series5d + series5d_right_1)
        - (9.183689863795546e-29 - series5d_right_1) - c23)
    series5d_lo = series5d_lo2_1 + (fine_x_cross2_1 * series5b + fine_x * series5b_lo)
    series5e = fine_x * series5d
    series5e_padded_1 = (c2
        + (9.183689863795546e-29 + (series5c_padded_1 * series5c_reach_1 + series5c_size_4)))
    series5e_size_3 = (fine_far_x_padded_1
        * (absolute(series5d) + c4 * (absolute(series5d_lo) + c24 * series5e_padded_1)))
    series5f = series5e + 6.446950284384474e-26
    series5f_right_1 = series5f - series5e
    series5f_lo2_1 = (product_rest(fine_x, series5d, series5e, series5f - series5f_right_1)
        + (6.446950284384474e-26 - series5f_right_1) + c25)
    series5f_lo = series5f_lo2_1 + (fine_x_cross2_1 * series5d + fine_x * series5d_lo)
    series5g = fine_x * series5f
    series5g_padded_1 = (c2
        + (6.446950284384474e-26 + (series5c_reach_1 * series5e_padded_1 + series5e_size_3)))
    series5g_size_3 = (fine_far_x_padded_1
        * (absolute(series5f) + c4 * (absolute(series5f_lo) + c26 * series5g_padded_1)))
    series5h = series5g - 3.868170170630684e-23
    series5h_right_1 = series5g - series5h
    series5h_lo2_1 = (product_rest(fine_x, series5f, series5g, series5h + series5h_right_1)
        - (3.868170170630684e-23 - series5h_right_1) - c27)
    series5h_lo = series5h_lo2_1 + (fine_x_cross2_1 * series5f + fine_x * series5f_lo)
    series5i = fine_x * series5h
    series5i_padded_1 = (c2
        + (3.868170170630684e-23 + (series5c_reach_1 * series5g_padded_1 + series5g_size_3)))
    series5i_size_3 = (fine_far_x_padded_1
        * (absolute(series5h) + c4 * (absolute(series5h_lo) + c28 * series5i_padded_1)))
    series5j = series5i + 1.9572941063391263e-20
    series5j_right_1 = series5j - series5i
    series5j_lo2_1 = (product_rest(fine_x, series5h, series5i, series5j - series5j_right_1)
        + (1.9572941063391263e-20 - series5j_right_1) + c29)
    series5j_lo = series5j_lo2_1 + (fine_x_cross2_1 * series5h + fine_x * series5h_lo)
    series5k = fine_x * series5j
    series5k_padded_1 = (c2
        + (1.9572941063391263e-20 + (series5c_reach_1 * series5i_padded_1 + series5i_size_3)))
    series5k_size_3 = (fine_far_x_padded_1
        * (absolute(series5j) + c4 * (absolute(series5j_lo) + c30 * series5k_padded_1)))
    series5l = series5k - 8.22063524662433e-18
    series5l_right_1 = series5k - series5l
    series5l_lo2_1 = (product_rest(fine_x, series5j, series5k, series5l + series5l_right_1)
        - (8.22063524662433e-18 - series5l_right_1) - c31)
    series5l_lo = series5l_lo2_1 + (fine_x_cross2_1 * series5j + fine_x * series5j_lo)
    series5m = fine_x * series5l
    series5m_padded_1 = (c2
        + (8.22063524662433e-18 + (series5c_reach_1 * series5k_padded_1 + series5k_size_3)))
    series5m_size_3 = (fine_far_x_padded_1
        * (absolute(series5l) + c4 * (absolute(series5l_lo) + c32 * series5m_padded_1)))
    series5n = series5m + 2.8114572543455206e-15
    series5n_right_1 = series5n - series5m
    series5n_lo2_1 = (product_rest(fine_x, series5l, series5m, series5n - series5n_right_1)
        + (2.8114572543455206e-15 - series5n_right_1) + c33)
    series5n_lo = series5n_lo2_1 + (fine_x_cross2_1 * series5l + fine_x * series5l_lo)
    series5o = fine_x * series5n
    series5o_padded_1 = (c2
        + (2.8114572543455206e-15 + (series5c_reach_1 * series5m_padded_1 + series5m_size_3)))
    series5o_size_3 = (fine_far_x_padded_1
        * (absolute(series5n) + c4 * (absolute(series5n_lo) + c34 * series5o_padded_1)))
    series5p = series5o - 7.647163731819816e-13
    series5p_right_1 = series5o - series5p
    series5p_lo2_1 = (product_rest(fine_x, series5n, series5o, series5p + series5p_right_1)
        - (7.647163731819816e-13 - series5p_right_1) - c35)
    series5p_lo = series5p_lo2_1 + (fine_x_cross2_1 * series5n + fine_x * series5n_lo)
    series5q = fine_x * series5p
    series5q_padded_1 = (c2
        + (7.647163731819816e-13 + (series5c_reach_1 * series5o_padded_1 + series5o_size_3)))
    series5q_size_3 = (fine_far_x_padded_1
        * (absolute(series5p) + c4 * (absolute(series5p_lo) + c36 * series5q_padded_1)))
    series5r = series5q + 1.6059043836821613e-10
    series5r_right_1 = series5r - series5q
    series5r_lo2_1 = (product_rest(fine_x, series5p, series5q, series5r - series5r_right_1)
        + (1.6059043836821613e-10 - series5r_right_1) + c37)
    series5r_lo = series5r_lo2_1 + (fine_x_cross2_1 * series5p + fine_x * series5p_lo)
    series5s = fine_x * series5r
    series5s_padded_1 = (c2
        + (1.6059043836821613e-10 + (series5c_reach_1 * series5q_padded_1 + series5q_size_3)))
    series5s_size_3 = (fine_far_x_padded_1
        * (absolute(series5r) + c4 * (absolute(series5r_lo) + c38 * series5s_padded_1)))
    series5t = series5s - 2.505210838544172e-08
    series5t_right_1 = series5s - series5t
    series5t_lo2_1 = (product_rest(fine_x, series5r, series5s, series5t + series5t_right_1)
        - (2.505210838544172e-08 - series5t_right_1) - c39)
    series5t_lo = series5t_lo2_1 + (fine_x_cross2_1 * series5r + fine_x * series5r_lo)
    series5u = fine_x * series5t
    series5u_padded_1 = (c2
        + (2.505210838544172e-08 + (series5c_reach_1 * series5s_padded_1 + series5s_size_3)))
    series5u_size_3 = (fine_far_x_padded_1
        * (absolute(series5t) + c4 * (absolute(series5t_lo) + c40 * series5u_padded_1)))
    series5v = series5u + 2.7557319223985893e-06
    series5v_right_1 = series5v - series5u
    series5v_lo2_1 = (product_rest(fine_x, series5t, series5u, series5v - series5v_right_1)
        + (2.7557319223985893e-06 - series5v_right_1) + c41)
    series5v_lo = series5v_lo2_1 + (fine_x_cross2_1 * series5t + fine_x * series5t_lo)
    series5w = fine_x * series5v
    series5w_padded_1 = (c2
        + (2.7557319223985893e-06 + (series5c_reach_1 * series5u_padded_1 + series5u_size_3)))
    series5w_size_3 = (fine_far_x_padded_1
        * (absolute(series5v) + c4 * (absolute(series5v_lo) + c42 * series5w_padded_1)))
    series5x = series5w - 0.0001984126984126984
    series5x_right_1 = series5w - series5x
    series5x_lo2_1 = (product_rest(fine_x, series5v, series5w, series5x + series5x_right_1)
        - (0.0001984126984126984 - series5x_right_1) - c43)
    series5x_lo = series5x_lo2_1 + (fine_x_cross2_1 * series5v + fine_x * series5v_lo)
    series5y = fine_x * series5x
    series5y_padded_1 = (c2
        + (0.0001984126984126984 + (series5c_reach_1 * series5w_padded_1 + series5w_size_3)))
    series5y_size_3 = (fine_far_x_padded_1
        * (absolute(series5x) + c4 * (absolute(series5x_lo) + c44 * series5y_padded_1)))
    series5 = series5y + 0.008333333333333333
    series5_right_1 = series5 - series5y
    series5_lo2_1 = (product_rest(fine_x, series5x, series5y, series5 - series5_right_1)
        + (0.008333333333333333 - series5_right_1) + c45)
    series5_lo = series5_lo2_1 + (fine_x_cross2_1 * series5x + fine_x * series5x_lo)
    fine_g3a = fine_x * series5
    fine_g3a_padded_1 = (c2
        + (0.008333333333333333 + (series5c_reach_1 * series5y_padded_1 + series5y_size_3)))
    fine_g3a_size_3 = (fine_far_x_padded_1
        * (absolute(series5) + c4 * (absolute(series5_lo) + c46 * fine_g3a_padded_1)))
    fine_g3b = 0.16666666666666666 - fine_g3a
    fine_g3b_right_1 = 0.16666666666666666 - fine_g3b
    fine_g3b_lo1_1 = (0.16666666666666666 - (fine_g3b + fine_g3b_right_1)
        - product_rest(fine_x, series5, fine_g3a, fine_g3b_right_1))
    fine_g3b_lo = fine_g3b_lo1_1 - (fine_x_cross2_1 * series5 + fine_x * series5_lo) + c9
    fine_g3b_size_1 = 0.16666666666666666 + (fine_g3a_padded_1 * series5c_reach_1 + fine_g3a_size_3)
    fine_g3 = where(far_x_a, fine_g3b, fine_closed3)
    fine_g3_lo = where(far_x_a, fine_g3b_lo, fine_closed3_lo)
    fine_g3_size_4 = (absolute(fine_g3b_lo) + c47 * (c2 + fine_g3b_size_1)
        + absolute(fine_g3b - fine_closed3))
    fine_g3_size_7 = (c49
        * where(fine_far_x_size_4, 0, absolute(fine_closed3_lo) + c48 * (c2 + fine_closed3_size_11)
        + fine_g3_size_4))
    fine_u_0a = s_2 * s_4
    fine_u_0a_size_1 = absolute(s_2)
    fine_u_0b = s_1 * s_5
    fine_u_0b_size_1 = absolute(s_1)
    fine_u_0 = fine_u_0a - fine_u_0b
    fine_u_right_1 = fine_u_0a - fine_u_0
    fine_u_1a = s_0 * s_5
    fine_u_1a_size_1 = absolute(s_0)
    fine_u_1b = s_2 * s_3
    fine_u_1 = fine_u_1a - fine_u_1b
    fine_u_right_2 = fine_u_1a - fine_u_1
    fine_u_2a = s_1 * s_3
    fine_u_2b = s_0 * s_4
    fine_u_2 = fine_u_2a - fine_u_2b
    fine_u_right_3 = fine_u_2a - fine_u_2
    fine_turned_0 = fine_g2 * fine_u_0
    fine_turned_cross2_1 = (fine_g2
        * (product_rest(s_2, s_4, fine_u_0a, fine_u_0 + fine_u_right_1)
        - product_rest(s_1, s_5, fine_u_0b, fine_u_right_1)))
    fine_turned_padded_1 = c2 + 0.5 * (fine_g2a_size_1 + fine_g2a_size_1)
    fine_turned_1 = fine_g2 * fine_u_1
    fine_turned_cross2_2 = (fine_g2
        * (product_rest(s_0, s_5, fine_u_1a, fine_u_1 + fine_u_right_2)
        - product_rest(s_2, s_3, fine_u_1b, fine_u_right_2)))
    fine_turned_2 = fine_g2 * fine_u_2
    fine_turned_cross2_3 = (fine_g2
        * (product_rest(s_1, s_3, fine_u_2a, fine_u_2 + fine_u_right_3)
        - product_rest(s_0, s_4, fine_u_2b, fine_u_right_3)))
    fine_wv_a = s_0 * s_3
    fine_wv_b = s_1 * s_4
    fine_wv_c = fine_wv_a + fine_wv_b
    fine_wv_c_right_1 = fine_wv_c - fine_wv_a
    fine_wv_d = s_2 * s_5
    fine_wv = fine_wv_c + fine_wv_d
    fine_wv_right_1 = fine_wv - fine_wv_c
    fine_wv_c_lo = (product_rest(s_0, s_3, fine_wv_a, fine_wv_c - fine_wv_c_right_1)
        + product_rest(s_1, s_4, fine_wv_b, fine_wv_c_right_1))
    fine_wv_lo = (fine_wv_c - (fine_wv - fine_wv_right_1)
        + product_rest(s_2, s_5, fine_wv_d, fine_wv_right_1) + fine_wv_c_lo)
    fine_pitch = fine_g3 * fine_wv
    fine_pitch_padded_1 = (c2
        + (where(far_x_a, fine_g3b_size_1, fine_closed3_size_11) + fine_g3_size_7))
    fine_pitch_padded_2 = (c2
        + (fine_u_1a_size_1 * halved_size_1 + fine_u_0b_size_1 * halved_size_3 + fine_u_0a_size_1
        * halved_size_5))
    fine_pitch_size_2 = (fine_pitch_padded_2
        * (absolute(fine_g3) + c4 * (absolute(fine_g3_lo) + c50 * fine_pitch_padded_1)))
    fine_pitch_lo = (product_error(fine_g3, fine_wv, fine_pitch)
        + (fine_g3_lo * fine_wv + fine_g3 * fine_wv_lo))
    fine_along_0 = s_3 * fine_pitch
    fine_along_padded_1 = (c2
        + (fine_pitch_size_2 + fine_pitch_padded_1
        * (absolute(fine_wv) + c4 * (absolute(fine_wv_lo) + c51 * fine_pitch_padded_2))))
    fine_along_1 = s_4 * fine_pitch
    fine_along_2 = s_5 * fine_pitch
    fine_beta_v_0 = s_3 * fine_g2
    fine_beta_v_1 = s_4 * fine_g2
    fine_beta_v_2 = s_5 * fine_g2
    fine_beta_v_lo_1 = product_error(s_3, fine_g2, fine_beta_v_0) + s_3 * fine_g2_cross2_1
    fine_m_0 = s_3 * fine_beta_v_0
    fine_m_cross2_1 = s_3 * fine_beta_v_lo_1
    fine_m_padded_1 = c2 + fine_turned_padded_1 * halved_size_1
    fine_m_size_1 = fine_m_padded_1 * halved_size_1
    fine_beta_v_lo_2 = product_error(s_4, fine_g2, fine_beta_v_1) + s_4 * fine_g2_cross2_1
    fine_m_1 = s_4 * fine_beta_v_1
    fine_m_cross2_2 = s_4 * fine_beta_v_lo_2
    fine_m_padded_2 = c2 + fine_turned_padded_1 * halved_size_3
    fine_m_size_2 = fine_m_padded_2 * halved_size_3
    fine_m_2 = s_5 * fine_beta_v_2
    fine_m_cross2_3 = s_5 * (product_error(s_5, fine_g2, fine_beta_v_2) + s_5 * fine_g2_cross2_1)
    fine_m_size_3 = (c2 + fine_turned_padded_1 * halved_size_5) * halved_size_5
    fine_m_3 = s_4 * fine_beta_v_0
    fine_m_cross2_4 = s_4 * fine_beta_v_lo_1
    fine_m_4 = s_5 * fine_beta_v_0
    fine_m_cross2_5 = s_5 * fine_beta_v_lo_1
    fine_m_5 = s_5 * fine_beta_v_1
    fine_m_cross2_6 = s_5 * fine_beta_v_lo_2
    fine_others_0 = fine_m_1 + fine_m_2
    fine_others_right_1 = fine_others_0 - fine_m_1
    fine_others_left_rest_1 = product_rest(s_4, fine_beta_v_1, fine_m_1,
        fine_others_0 - fine_others_right_1)
    fine_others_lo_1 = (fine_others_left_rest_1
        + product_rest(s_5, fine_beta_v_2, fine_m_2, fine_others_right_1)
        + (fine_m_cross2_2 + fine_m_cross2_3))
    fine_others_size_1 = fine_m_size_2 + fine_m_size_3
    fine_others_1 = fine_m_0 + fine_m_2
    fine_others_right_2 = fine_others_1 - fine_m_0
    fine_others_left_rest_2 = product_rest(s_3, fine_beta_v_0, fine_m_0,
        fine_others_1 - fine_others_right_2)
    fine_others_lo_2 = (fine_others_left_rest_2
        + product_rest(s_5, fine_beta_v_2, fine_m_2, fine_others_right_2)
        + (fine_m_cross2_1 + fine_m_cross2_3))
    fine_others_size_2 = fine_m_size_1 + fine_m_size_3
    fine_others_2 = fine_m_0 + fine_m_1
    fine_others_right_3 = fine_others_2 - fine_m_0
    fine_others_left_rest_3 = product_rest(s_3, fine_beta_v_0, fine_m_0,
        fine_others_2 - fine_others_right_3)
    fine_others_lo_3 = (fine_others_left_rest_3
        + product_rest(s_4, fine_beta_v_1, fine_m_1, fine_others_right_3)
        + (fine_m_cross2_1 + fine_m_cross2_2))
    fine_others_size_3 = fine_m_size_1 + fine_m_size_2
    fine_diagonal0a = 1 - fine_others_0
    fine_diagonal0a_right_1 = 1 - fine_diagonal0a
    fine_diagonal0a_lo = (1 - (fine_diagonal0a + fine_diagonal0a_right_1)
        - (fine_others_0 - fine_diagonal0a_right_1) - fine_others_lo_1)
    fine_diagonal0a_size_1 = 1 + fine_others_size_1
    fine_diagonal0b = fine_g0 + fine_m_0
    fine_diagonal0b_right_1 = fine_diagonal0b - fine_g0
    fine_diagonal0b_lo1_1 = (fine_g0 - (fine_diagonal0b - fine_diagonal0b_right_1)
        + product_rest(s_3, fine_beta_v_0, fine_m_0, fine_diagonal0b_right_1))
    fine_diagonal0b_lo = fine_diagonal0b_lo1_1 + fine_m_cross2_1 + fine_g0_lo
    fine_diagonal0b_size_1 = fine_g0_size_1 + fine_m_size_1
    fine_diagonal0c = fine_m_0 < fine_others_0
    fine_diagonal0_bound_1 = (absolute(product_error(s_3, fine_beta_v_0, fine_m_0)
        + fine_m_cross2_1) + c52 * (c2 + fine_m_size_1))
    fine_diagonal0_size_8 = (absolute(fine_diagonal0b_lo) + c53 * (c2 + fine_diagonal0b_size_1)
        + absolute(fine_diagonal0b - fine_diagonal0a))
    fine_diagonal0_size_5 = (fine_diagonal0_bound_1
        + (absolute(fine_others_lo_1) + c53 * (c2 + fine_others_size_1))
        < absolute(fine_m_0 - fine_others_0))
    fine_diagonal0_size_10 = where(fine_diagonal0_size_5, 0,
        absolute(fine_diagonal0a_lo) + c54 * (c2 + fine_diagonal0a_size_1) + fine_diagonal0_size_8)
    fine_diagonal1a = 1 - fine_others_1
    fine_diagonal1a_right_1 = 1 - fine_diagonal1a
    fine_diagonal1a_lo = (1 - (fine_diagonal1a + fine_diagonal1a_right_1)
        - (fine_others_1 - fine_diagonal1a_right_1) - fine_others_lo_2)
    fine_diagonal1a_size_1 = 1 + fine_others_size_2
    fine_diagonal1b = fine_g0 + fine_m_1
    fine_diagonal1b_right_1 = fine_diagonal1b - fine_g0
    fine_diagonal1b_lo1_1 = (fine_g0 - (fine_diagonal1b - fine_diagonal1b_right_1)
        + product_rest(s_4, fine_beta_v_1, fine_m_1, fine_diagonal1b_right_1))
    fine_diagonal1b_lo = fine_diagonal1b_lo1_1 + fine_m_cross2_2 + fine_g0_lo
    fine_diagonal1b_size_1 = fine_g0_size_1 + fine_m_size_2
    fine_diagonal1c = fine_m_1 < fine_others_1
    fine_diagonal1_bound_1 = (absolute(product_error(s_4, fine_beta_v_1, fine_m_1)
        + fine_m_cross2_2) + c52 * (c2 + fine_m_size_2))
    fine_diagonal1_size_8 = (absolute(fine_diagonal1b_lo) + c53 * (c2 + fine_diagonal1b_size_1)
        + absolute(fine_diagonal1b - fine_diagonal1a))
    fine_diagonal1_size_5 = (fine_diagonal1_bound_1
        + (absolute(fine_others_lo_2) + c53 * (c2 + fine_others_size_2))
        < absolute(fine_m_1 - fine_others_1))
    fine_diagonal1_size_10 = where(fine_diagonal1_size_5, 0,
        absolute(fine_diagonal1a_lo) + c54 * (c2 + fine_diagonal1a_size_1) + fine_diagonal1_size_8)
    fine_diagonal2a = 1 - fine_others_2
    fine_diagonal2a_right_1 = 1 - fine_diagonal2a
    fine_diagonal2a_lo = (1 - (fine_diagonal2a + fine_diagonal2a_right_1)
        - (fine_others_2 - fine_diagonal2a_right_1) - fine_others_lo_3)
    fine_diagonal2a_size_1 = 1 + fine_others_size_3
    fine_diagonal2b = fine_g0 + fine_m_2
    fine_diagonal2b_right_1 = fine_diagonal2b - fine_g0
    fine_diagonal2b_lo1_1 = (fine_g0 - (fine_diagonal2b - fine_diagonal2b_right_1)
        + product_rest(s_5, fine_beta_v_2, fine_m_2, fine_diagonal2b_right_1))
    fine_diagonal2b_lo = fine_diagonal2b_lo1_1 + fine_m_cross2_3 + fine_g0_lo
    fine_diagonal2b_size_1 = fine_g0_size_1 + fine_m_size_3
    fine_diagonal2c = fine_m_2 < fine_others_2
    fine_diagonal2_bound_1 = (absolute(product_error(s_5, fine_beta_v_2, fine_m_2)
        + fine_m_cross2_3) + c52 * (c2 + fine_m_size_3))
    fine_diagonal2_size_8 = (absolute(fine_diagonal2b_lo) + c53 * (c2 + fine_diagonal2b_size_1)
        + absolute(fine_diagonal2b - fine_diagonal2a))
    fine_diagonal2_size_5 = (fine_diagonal2_bound_1
        + (absolute(fine_others_lo_3) + c53 * (c2 + fine_others_size_3))
        < absolute(fine_m_2 - fine_others_2))
    fine_diagonal2_size_10 = where(fine_diagonal2_size_5, 0,
        absolute(fine_diagonal2a_lo) + c54 * (c2 + fine_diagonal2a_size_1) + fine_diagonal2_size_8)
    fine_g1_lo = product_error(c, sinc, fine_g1) + fine_g1_cross_1
    fine_alpha_v_0 = s_3 * fine_g1
    fine_alpha_v_cross2_1 = s_3 * fine_g1_lo
    fine_alpha_v_padded_1 = c2 + fine_g1_size_5
    fine_alpha_v_1 = s_4 * fine_g1
    fine_alpha_v_cross2_2 = s_4 * fine_g1_lo
    fine_alpha_v_2 = s_5 * fine_g1
    fine_alpha_v_cross2_3 = s_5 * fine_g1_lo
    fine_across_axis_0 = fine_turned_0 + fine_along_0
    fine_across_axis_right_1 = fine_across_axis_0 - fine_turned_0
    fine_across_axis_left_rest_1 = product_rest(fine_g2, fine_u_0, fine_turned_0,
        fine_across_axis_0 - fine_across_axis_right_1)
    fine_across_axis_lo1_1 = (fine_across_axis_left_rest_1
        + product_rest(s_3, fine_pitch, fine_along_0, fine_across_axis_right_1))
    fine_turned_size_1 = (fine_turned_padded_1
        * (c2 + (fine_u_0a_size_1 * halved_size_3 + fine_u_0b_size_1 * halved_size_5)))
    fine_across_axis_1 = fine_turned_1 + fine_along_1
    fine_across_axis_right_2 = fine_across_axis_1 - fine_turned_1
    fine_across_axis_left_rest_2 = product_rest(fine_g2, fine_u_1, fine_turned_1,
        fine_across_axis_1 - fine_across_axis_right_2)
    fine_across_axis_lo1_2 = (fine_across_axis_left_rest_2
        + product_rest(s_4, fine_pitch, fine_along_1, fine_across_axis_right_2))
    fine_turned_size_2 = (fine_turned_padded_1
        * (c2 + (fine_u_1a_size_1 * halved_size_5 + fine_u_0a_size_1 * halved_size_1)))
    fine_across_axis_2 = fine_turned_2 + fine_along_2
    fine_across_axis_right_3 = fine_across_axis_2 - fine_turned_2
    fine_across_axis_left_rest_3 = product_rest(fine_g2, fine_u_2, fine_turned_2,
        fine_across_axis_2 - fine_across_axis_right_3)
    fine_across_axis_lo1_3 = (fine_across_axis_left_rest_3
        + product_rest(s_5, fine_pitch, fine_along_2, fine_across_axis_right_3))
    fine_turned_size_3 = (fine_turned_padded_1
        * (c2 + (fine_u_0b_size_1 * halved_size_1 + fine_u_1a_size_1 * halved_size_3)))
    fine_D_01 = fine_m_3 - fine_alpha_v_2
    fine_D_right_1 = fine_m_3 - fine_D_01
    fine_D_lo1_1 = (product_rest(s_4, fine_beta_v_0, fine_m_3, fine_D_01 + fine_D_right_1)
        - product_rest(s_5, fine_g1, fine_alpha_v_2, fine_D_right_1))
    fine_D_02 = fine_m_4 + fine_alpha_v_1
    fine_D_right_2 = fine_D_02 - fine_m_4
    fine_D_lo1_2 = (product_rest(s_5, fine_beta_v_0, fine_m_4, fine_D_02 - fine_D_right_2)
        + product_rest(s_4, fine_g1, fine_alpha_v_1, fine_D_right_2))
    fine_D_03a = s_0 * fine_g1
    fine_D_03 = fine_D_03a + fine_across_axis_0
    fine_D_right_3 = fine_D_03 - fine_D_03a
    fine_D_lo1_3 = (product_rest(s_0, fine_g1, fine_D_03a, fine_D_03 - fine_D_right_3)
        + (fine_across_axis_0 - fine_D_right_3))
    fine_D_10 = fine_m_3 + fine_alpha_v_2
    fine_D_right_4 = fine_D_10 - fine_m_3
    fine_D_lo1_4 = (product_rest(s_4, fine_beta_v_0, fine_m_3, fine_D_10 - fine_D_right_4)
        + product_rest(s_5, fine_g1, fine_alpha_v_2, fine_D_right_4))
    fine_D_12 = fine_m_5 - fine_alpha_v_0
    fine_D_right_5 = fine_m_5 - fine_D_12
    fine_D_lo1_5 = (product_rest(s_5, fine_beta_v_1, fine_m_5, fine_D_12 + fine_D_right_5)
        - product_rest(s_3, fine_g1, fine_alpha_v_0, fine_D_right_5))
    fine_D_13a = s_1 * fine_g1
    fine_D_13 = fine_D_13a + fine_across_axis_1
    fine_D_right_6 = fine_D_13 - fine_D_13a
    fine_D_lo1_6 = (product_rest(s_1, fine_g1, fine_D_13a, fine_D_13 - fine_D_right_6)
        + (fine_across_axis_1 - fine_D_right_6))
    fine_D_20 = fine_m_4 - fine_alpha_v_1
    fine_D_right_7 = fine_m_4 - fine_D_20
    fine_D_lo1_7 = (product_rest(s_5, fine_beta_v_0, fine_m_4, fine_D_20 + fine_D_right_7)
        - product_rest(s_4, fine_g1, fine_alpha_v_1, fine_D_right_7))
    fine_D_21 = fine_m_5 + fine_alpha_v_0
    fine_D_right_8 = fine_D_21 - fine_m_5
    fine_D_lo1_8 = (product_rest(s_5, fine_beta_v_1, fine_m_5, fine_D_21 - fine_D_right_8)
        + product_rest(s_3, fine_g1, fine_alpha_v_0, fine_D_right_8))
    fine_D_23a = s_2 * fine_g1
    fine_D_23 = fine_D_23a + fine_across_axis_2
    fine_D_right_9 = fine_D_23 - fine_D_23a
    fine_D_lo1_9 = (product_rest(s_2, fine_g1, fine_D_23a, fine_D_23 - fine_D_right_9)
        + (fine_across_axis_2 - fine_D_right_9))
    diagonal0_apart_1 = where(fine_diagonal0c, fine_diagonal0b, fine_diagonal0a) - diagonal0
    diagonal0_rest_1 = (c57
        * (c2
        + (where(fine_diagonal0c, fine_diagonal0b_size_1, fine_diagonal0a_size_1) + c55
        * fine_diagonal0_size_10)))
    D_rest_1 = (c53
        * (c2 + (fine_alpha_v_padded_1 * halved_size_5 + fine_m_padded_1 * halved_size_3)))
    D_rest_2 = (c53
        * (c2 + (fine_alpha_v_padded_1 * halved_size_3 + fine_m_padded_1 * halved_size_5)))
    fine_D_lo_3 = (fine_D_lo1_3
        + (fine_across_axis_lo1_1
        + (fine_g2_cross2_1 * fine_u_0 + fine_turned_cross2_1 + s_3 * fine_pitch_lo)) + s_0
        * fine_g1_lo)
    D_rest_3 = (c58
        * (c2
        + (fine_alpha_v_padded_1 * fine_u_1a_size_1
        + (fine_along_padded_1 * halved_size_1 + fine_turned_size_1))))
    diagonal1_apart_1 = where(fine_diagonal1c, fine_diagonal1b, fine_diagonal1a) - diagonal1
    diagonal1_rest_1 = (c57
        * (c2
        + (where(fine_diagonal1c, fine_diagonal1b_size_1, fine_diagonal1a_size_1) + c55
        * fine_diagonal1_size_10)))
    D_rest_4 = (c53
        * (c2 + (fine_alpha_v_padded_1 * halved_size_1 + fine_m_padded_2 * halved_size_5)))
    fine_D_lo_6 = (fine_D_lo1_6
        + (fine_across_axis_lo1_2
        + (fine_g2_cross2_1 * fine_u_1 + fine_turned_cross2_2 + s_4 * fine_pitch_lo)) + s_1
        * fine_g1_lo)
    D_rest_5 = (c58
        * (c2
        + (fine_alpha_v_padded_1 * fine_u_0b_size_1
        + (fine_along_padded_1 * halved_size_3 + fine_turned_size_2))))
    diagonal2_apart_1 = where(fine_diagonal2c, fine_diagonal2b, fine_diagonal2a) - diagonal2
    diagonal2_rest_1 = (c57
        * (c2
        + (where(fine_diagonal2c, fine_diagonal2b_size_1, fine_diagonal2a_size_1) + c55
        * fine_diagonal2_size_10)))
    fine_D_lo_9 = (fine_D_lo1_9
        + (fine_across_axis_lo1_3
        + (fine_g2_cross2_1 * fine_u_2 + fine_turned_cross2_3 + s_5 * fine_pitch_lo)) + s_2
        * fine_g1_lo)
    D_rest_6 = (c58
        * (c2
        + (fine_alpha_v_padded_1 * fine_u_0a_size_1
        + (fine_along_padded_1 * halved_size_5 + fine_turned_size_3))))
    diagonal0_bound_1 = (c56
        * absolute(diagonal0_apart_1
        + where(fine_diagonal0c, fine_diagonal0b_lo, fine_diagonal0a_lo)) + diagonal0_rest_1)
    D_bound_1 = (c56
        * absolute(fine_D_01 - D_01 + (fine_D_lo1_1 + (fine_m_cross2_4 - fine_alpha_v_cross2_3)))
        + D_rest_1)
    D_bound_2 = (c56
        * absolute(fine_D_02 - D_02 + (fine_D_lo1_2 + (fine_m_cross2_5 + fine_alpha_v_cross2_2)))
        + D_rest_2)
    D_bound_3 = c56 * absolute(fine_D_03 - D_03 + fine_D_lo_3) + D_rest_3
    D_bound_4 = (c56
        * absolute(fine_D_10 - D_10 + (fine_D_lo1_4 + (fine_m_cross2_4 + fine_alpha_v_cross2_3)))
        + D_rest_1)
    diagonal1_bound_1 = (c56
        * absolute(diagonal1_apart_1
        + where(fine_diagonal1c, fine_diagonal1b_lo, fine_diagonal1a_lo)) + diagonal1_rest_1)
    D_bound_5 = (c56
        * absolute(fine_D_12 - D_12 + (fine_D_lo1_5 + (fine_m_cross2_6 - fine_alpha_v_cross2_1)))
        + D_rest_4)
    D_bound_6 = c56 * absolute(fine_D_13 - D_13 + fine_D_lo_6) + D_rest_5
    D_bound_7 = (c56
        * absolute(fine_D_20 - D_20 + (fine_D_lo1_7 + (fine_m_cross2_5 - fine_alpha_v_cross2_2)))
        + D_rest_2)
    D_bound_8 = (c56
        * absolute(fine_D_21 - D_21 + (fine_D_lo1_8 + (fine_m_cross2_6 + fine_alpha_v_cross2_1)))
        + D_rest_4)
    diagonal2_bound_1 = (c56
        * absolute(diagonal2_apart_1
        + where(fine_diagonal2c, fine_diagonal2b_lo, fine_diagonal2a_lo)) + diagonal2_rest_1)
    D_bound_9 = c56 * absolute(fine_D_23 - D_23 + fine_D_lo_9) + D_rest_6
    return (diagonal0, D_01, D_02, D_03, D_10, diagonal1, D_12, D_13, D_20, D_21, diagonal2, D_23,
        diagonal0_bound_1, D_bound_1, D_bound_2, D_bound_3, D_bound_4, diagonal1_bound_1, D_bound_5,
        D_bound_6, D_bound_7, D_bound_8, diagonal2_bound_1, D_bound_9)


@kernel("(3,4)->(6),(6)")
@errstate(all="ignore")
def SE3_log(D, *, c1=6.703903964971299e+153, c2=3.7291703656001034e-155, c3=1.3093562431584567e+151,
        c4=1.955159272639747e-149, c5=1.0715086071862673e+301, c6=2.6815615859885194e+154,
        c7=7.637340908749012e-152, c8=9.332636185032189e-302, c9=1.8051943758648296e-276,
        c10=1.6023738312796216e-30, c11=1.5845630613906556e+29, c12=6.508104019725916e-30,
        c13=6.705320021857442e-30, c14=140737488355328, c15=1.150011758590251e-29,
        c16=1.1418664350501995e+29, c17=9.423194733875307e-30, c18=4.527322338646221e+28, c19=5e-324,
        c20=6.338250583290453e+28, c21=1.6270263928446146e-29, c22=3.316915129670074e-29,
        c23=1.4883595920139876e-29, c24=9.248172776624906e+28, c25=1.1256681545564732e-29,
        c26=2.357955640370947e-29, c27=3.5212501748002707e+28, c28=2.9286476622855606e-29,
        c29=9.25185853854297e-18, c30=2290649224.7000003, c31=8.413326746211277e-28,
        c32=4.0396275823465884e-29, c33=1.1904042348031753e+27, c34=4.7410392187559056e-48,
        c35=6.843135825984986e-08, c36=-1.8714974010023092e-45, c37=3.113536936946736e-29,
        c38=2.3296034284323186e-42, c39=8.516250370250066e-28, c40=3.161967936521494e-40,
        c41=8.621392666525187e-28, c42=3.2266760594119493e-37, c43=8.728753635036635e-28,
        c44=-1.2521244741738012e-34, c45=8.838333274844017e-28, c46=7.23242424407352e-33,
        c47=8.950131585947334e-28, c48=5.8681293750286156e-30, c49=9.064148568346586e-28,
        c50=5.034117835500839e-27, c51=9.180384222041771e-28, c52=-1.7546051379703029e-25,
        c53=9.29883854703289e-28, c54=4.7926555569351065e-23, c55=9.419511543319943e-28,
        c56=-4.460143857711533e-21, c57=9.542403214664514e-28, c58=-2.147752875018904e-19,
        c59=9.667513557305017e-28, c60=4.625929269271486e-19, c61=3.162841053853558e-29,
        c62=9.794842571241454e-28, c63=1.850371707708594e-17, c64=3.169124989414031e+28,
        c65=3.254053096019738e-29, c66=9.955206102310575e-28, c67=8.596739798391267e-28,
        c68=1.0085955631004589e+27, c69=8.41936839032761e-28, c70=8.413327710116644e-28,
        c71=1.041866381758103e-27, c72=3.892538312770568e-29, c73=3.5202936421278755e-29,
        c74=1.0537979996222264e-27, c75=1.0000000000000009, c76=1.0715106821527331e-27,
        c77=1.0715086071862673e+301):
    """so with exp so = D, |ω| <= π: (J_l(ω)^-1 t; ω), ω = log R; |error of so| <= so_bound unless
    inf or NaN.

    (3,4)->(6),(6).  D: displacement [R | t], R rotation, t in m; so, so_bound: screw (v in m/s;
    ω in rad/s).
    599 mul, 986 add, 36 product error, 36 product rest, 47 div, 5 sqrt, 15 neg, 155 abs, 6
    copysign, 72 less, 10 equal, 171 select.
    """
    D_00, D_01, D_02, D_03, D_10, D_11, D_12, D_13, D_20, D_21, D_22, D_23 = D
    p_0 = D_21 - D_12
    p_1 = D_02 - D_20
    p_2 = D_10 - D_01
    s_0 = D_12 + D_21
    s_1 = D_02 + D_20
    s_2 = D_01 + D_10
    first_0 = D_00 + 1
    first_1 = 1 - D_00
    others_0 = D_11 + D_22
    others_1 = D_11 - D_22
    d_0 = first_0 + others_0
    d_1 = first_0 - others_0
    d_2 = first_1 + others_1
    d_3 = first_1 - others_1
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
    column_1 = where(column_0a, low_1, high_1)
    column_2 = where(column_0a, low_2, high_2)
    column_3 = where(column_0a, low_3, high_3)
    upper_0b = column_3 < 0
    upper_0 = where(upper_0b, -column_0, column_0)
    upper_1 = where(upper_0b, -column_1, column_1)
    upper_2 = where(upper_0b, -column_2, column_2)
    upper_3 = where(upper_0b, -column_3, column_3)
    v_s_size_0 = absolute(upper_0)
    v_s_size_1 = absolute(upper_1)
    v_s_size_2 = absolute(upper_2)
    v_s_largest1 = where(v_s_size_0 < v_s_size_1, v_s_size_1, v_s_size_0)
    v_s_largest2 = where(v_s_largest1 < v_s_size_2, v_s_size_2, v_s_largest1)
    v_s = where(v_s_largest2 < c4, c5, where(v_s_largest2 < 256, c3, where(c1 < v_s_largest2,
        real(c2), real(1))))
    v_y_0 = upper_0 * v_s
    v_y_1 = upper_1 * v_s
    v_y_2 = upper_2 * v_s
    v_n = sqrt(v_y_0 * v_y_0 + v_y_1 * v_y_1 + v_y_2 * v_y_2)
    v_r = where(c3 < v_s, c8, where(1 < v_s, c7, where(v_s < 1, real(c6), real(1))))
    n = v_n * v_r
    half = elementary.atan2(n, upper_3)
    divisor = where(n == 0, 1, n)
    theta = 2 * half
    k = theta / divisor
    vector_0 = upper_0 * k
    vector_1 = upper_1 * k
    vector_2 = upper_2 * k
    x = theta * theta
    far_sine = where(x < 1, 1, n)
    cotangent = upper_3 / far_sine
    half_cotangent = 0.5 * theta * cotangent
    b_rest = 1 - half_cotangent
    b_divisor_a = x < 4
    b_divisor = where(b_divisor_a, 4, x)
    closed_b = b_rest / b_divisor
    b_h = (x
        * (x * (x * (1.455172475614865e-27 * x + 5.744790668872202e-26) + 2.267952452337683e-24)
        + 8.953517427037546e-23) + 3.534707039629467e-21)
    b_q = (x
        * (x
        * (x * (x * (x * b_h + 1.3954464685812522e-19) + 5.5090028283602295e-18)
        + 2.174868698558062e-16) + 8.586062056277845e-15))
    b_y = (x
        * (x
        * (x * (x * (b_q + 3.3896802963225827e-13) + 1.3382536530684679e-11)
        + 5.284190138687493e-10) + 2.08767569878681e-08))
    b = where(b_divisor_a,
        x * (x * (x * (b_y + 8.267195767195768e-07) + 3.306878306878307e-05) + 0.001388888888888889)
            + 0.08333333333333333,
        closed_b)
    b_across = where(b_divisor_a, 1 - x * b, half_cotangent)
    wt = D_03 * vector_0 + D_13 * vector_1 + D_23 * vector_2
    pitch = b * wt
    along_0 = vector_0 * pitch
    along_1 = vector_1 * pitch
    along_2 = vector_2 * pitch
    u_0 = D_23 * vector_1 - D_13 * vector_2
    u_1 = D_03 * vector_2 - D_23 * vector_0
    u_2 = D_13 * vector_0 - D_03 * vector_1
    turned_0 = 0.5 * u_0
    turned_1 = 0.5 * u_1
    turned_2 = 0.5 * u_2
    across_axis_0 = along_0 - turned_0
    across_axis_1 = along_1 - turned_1
    across_axis_2 = along_2 - turned_2
    so_0 = D_03 * b_across + across_axis_0
    so_1 = D_13 * b_across + across_axis_1
    so_2 = D_23 * b_across + across_axis_2
    fine_p_0 = D_21 - D_12
    fine_p_right_1 = D_21 - fine_p_0
    fine_p_lo_1 = D_21 - (fine_p_0 + fine_p_right_1) - (D_12 - fine_p_right_1)
    fine_p_size_3 = absolute(D_21) + absolute(D_12)
    fine_p_1 = D_02 - D_20
    fine_p_right_2 = D_02 - fine_p_1
    fine_p_lo_2 = D_02 - (fine_p_1 + fine_p_right_2) - (D_20 - fine_p_right_2)
    fine_p_size_6 = absolute(D_02) + absolute(D_20)
    fine_p_2 = D_10 - D_01
    fine_p_right_3 = D_10 - fine_p_2
    fine_p_lo_3 = D_10 - (fine_p_2 + fine_p_right_3) - (D_01 - fine_p_right_3)
    fine_p_size_9 = absolute(D_10) + absolute(D_01)
    fine_s_0 = D_12 + D_21
    fine_s_right_1 = fine_s_0 - D_12
    fine_s_lo_1 = D_12 - (fine_s_0 - fine_s_right_1) + (D_21 - fine_s_right_1)
    fine_s_1 = D_02 + D_20
    fine_s_right_2 = fine_s_1 - D_02
    fine_s_lo_2 = D_02 - (fine_s_1 - fine_s_right_2) + (D_20 - fine_s_right_2)
    fine_s_2 = D_01 + D_10
    fine_s_right_3 = fine_s_2 - D_01
    fine_s_lo_3 = D_01 - (fine_s_2 - fine_s_right_3) + (D_10 - fine_s_right_3)
    fine_first_0 = D_00 + 1
    fine_first_right_1 = fine_first_0 - D_00
    fine_first_lo_1 = D_00 - (fine_first_0 - fine_first_right_1) + (1 - fine_first_right_1)
    fine_first_1 = 1 - D_00
    fine_first_right_2 = 1 - fine_first_1
    fine_first_lo_2 = 1 - (fine_first_1 + fine_first_right_2) - (D_00 - fine_first_right_2)
    fine_others_0 = D_11 + D_22
    fine_others_right_1 = fine_others_0 - D_11
    fine_others_lo_1 = D_11 - (fine_others_0 - fine_others_right_1) + (D_22 - fine_others_right_1)
    fine_others_1 = D_11 - D_22
    fine_others_right_2 = D_11 - fine_others_1
    fine_others_lo_2 = D_11 - (fine_others_1 + fine_others_right_2) - (D_22 - fine_others_right_2)
    fine_d_0 = fine_first_0 + fine_others_0
    fine_d_right_1 = fine_d_0 - fine_first_0
    fine_d_size_1 = 1 + absolute(D_00) + (absolute(D_11) + absolute(D_22))
    fine_d_1 = fine_first_0 - fine_others_0
    fine_d_right_2 = fine_first_0 - fine_d_1
    fine_d_2 = fine_first_1 + fine_others_1
    fine_d_right_3 = fine_d_2 - fine_first_1
    fine_d_3 = fine_first_1 - fine_others_1
    fine_d_right_4 = fine_first_1 - fine_d_3
    fine_low_0a = D_11 < D_00
    fine_d_lo_2 = (fine_first_0 - (fine_d_1 + fine_d_right_2) - (fine_others_0 - fine_d_right_2)
        - fine_others_lo_1 + fine_first_lo_1)
    fine_d_lo_3 = (fine_first_1 - (fine_d_2 - fine_d_right_3) + (fine_others_1 - fine_d_right_3)
        + fine_others_lo_2 + fine_first_lo_2)
    fine_high_0b = D_00 < -D_11
    fine_d_lo_4 = (fine_first_1 - (fine_d_3 + fine_d_right_4) - (fine_others_1 - fine_d_right_4)
        - fine_others_lo_2 + fine_first_lo_2)
    fine_d_lo_1 = (fine_first_0 - (fine_d_0 - fine_d_right_1) + (fine_others_0 - fine_d_right_1)
        + fine_others_lo_1 + fine_first_lo_1)
    fine_column_0a = D_22 < 0
    fine_column_0 = where(fine_column_0a, where(fine_low_0a, fine_d_1, fine_s_2),
        where(fine_high_0b, fine_s_1, fine_p_0))
    fine_column_lo_1 = where(fine_column_0a, where(fine_low_0a, fine_d_lo_2, fine_s_lo_3),
        where(fine_high_0b, fine_s_lo_2, fine_p_lo_1))
    fine_column_size_1 = where(fine_column_0a, where(fine_low_0a, fine_d_size_1, fine_p_size_9),
        where(fine_high_0b, fine_p_size_6, fine_p_size_3))
    fine_column_1 = where(fine_column_0a, where(fine_low_0a, fine_s_2, fine_d_2),
        where(fine_high_0b, fine_s_0, fine_p_1))
    fine_column_lo_2 = where(fine_column_0a, where(fine_low_0a, fine_s_lo_3, fine_d_lo_3),
        where(fine_high_0b, fine_s_lo_1, fine_p_lo_2))
    fine_column_size_2 = where(fine_column_0a, where(fine_low_0a, fine_p_size_9, fine_d_size_1),
        where(fine_high_0b, fine_p_size_3, fine_p_size_6))
    fine_column_2 = where(fine_column_0a, where(fine_low_0a, fine_s_1, fine_s_0),
        where(fine_high_0b, fine_d_3, fine_p_2))
    fine_column_lo_3 = where(fine_column_0a, where(fine_low_0a, fine_s_lo_2, fine_s_lo_1),
        where(fine_high_0b, fine_d_lo_4, fine_p_lo_3))
    fine_column_size_3 = where(fine_column_0a, where(fine_low_0a, fine_p_size_6, fine_p_size_3),
        where(fine_high_0b, fine_d_size_1, fine_p_size_9))
    fine_column_3 = where(fine_column_0a, where(fine_low_0a, fine_p_0, fine_p_1),
        where(fine_high_0b, fine_p_2, fine_d_0))
    fine_column_lo_4 = where(fine_column_0a, where(fine_low_0a, fine_p_lo_1, fine_p_lo_2),
        where(fine_high_0b, fine_p_lo_3, fine_d_lo_1))
    fine_column_size_4 = where(fine_column_0a, where(fine_low_0a, fine_p_size_3, fine_p_size_6),
        where(fine_high_0b, fine_p_size_9, fine_d_size_1))
    fine_upper_0a = -fine_column_0
    fine_upper_0a_lo = -fine_column_lo_1
    fine_upper_0b = fine_column_3 < 0
    fine_upper_0 = where(fine_upper_0b, fine_upper_0a, fine_column_0)
    fine_upper_lo_1 = where(fine_upper_0b, fine_upper_0a_lo, fine_column_lo_1)
    fine_upper_bound_1 = absolute(fine_column_lo_4) + c10 * (c9 + fine_column_size_4)
    fine_upper_size_3 = fine_upper_bound_1 < absolute(fine_column_3 - 0)
    fine_upper_rest_2 = c10 * (c9 + fine_column_size_1)
    fine_upper_size_6 = (absolute(fine_upper_0a_lo) + fine_upper_rest_2
        + absolute(fine_upper_0a - fine_column_0))
    fine_upper_1a = -fine_column_1
    fine_upper_1a_lo = -fine_column_lo_2
    fine_upper_1 = where(fine_upper_0b, fine_upper_1a, fine_column_1)
    fine_upper_lo_2 = where(fine_upper_0b, fine_upper_1a_lo, fine_column_lo_2)
    fine_upper_rest_3 = c10 * (c9 + fine_column_size_2)
    fine_upper_size_13 = (absolute(fine_upper_1a_lo) + fine_upper_rest_3
        + absolute(fine_upper_1a - fine_column_1))
    fine_upper_2a = -fine_column_2
    fine_upper_2a_lo = -fine_column_lo_3
    fine_upper_2 = where(fine_upper_0b, fine_upper_2a, fine_column_2)
    fine_upper_lo_3 = where(fine_upper_0b, fine_upper_2a_lo, fine_column_lo_3)
    fine_upper_rest_4 = c10 * (c9 + fine_column_size_3)
    fine_upper_size_20 = (absolute(fine_upper_2a_lo) + fine_upper_rest_4
        + absolute(fine_upper_2a - fine_column_2))
    fine_upper_3 = absolute(fine_column_3)
    fine_upper_lo_4 = where(fine_column_3 < 0, -fine_column_lo_4, fine_column_lo_4)
    fine_upper_size_25 = fine_upper_3 - fine_upper_bound_1
    fine_v_s_size_0 = absolute(fine_upper_0)
    fine_upper_size_10 = (fine_column_size_1 + c11
        * where(fine_upper_size_3, 0, absolute(fine_column_lo_1) + fine_upper_rest_2
        + fine_upper_size_6))
    fine_v_s_size_padded_1 = c9 + fine_upper_size_10
    fine_v_s_size_1 = absolute(fine_upper_1)
    fine_upper_size_17 = (fine_column_size_2 + c11
        * where(fine_upper_size_3, 0, absolute(fine_column_lo_2) + fine_upper_rest_3
        + fine_upper_size_13))
    fine_v_s_size_padded_2 = c9 + fine_upper_size_17
    fine_v_s_size_2 = absolute(fine_upper_2)
    fine_upper_size_24 = (fine_column_size_3 + c11
        * where(fine_upper_size_3, 0, absolute(fine_column_lo_3) + fine_upper_rest_4
        + fine_upper_size_20))
    fine_v_s_size_padded_3 = c9 + fine_upper_size_24
    fine_v_s_largest1 = where(fine_v_s_size_0 < fine_v_s_size_1, fine_v_s_size_1, fine_v_s_size_0)
    fine_v_s_largest2 = where(fine_v_s_largest1 < fine_v_s_size_2, fine_v_s_size_2,
        fine_v_s_largest1)
    fine_v_s_a = c1 < fine_v_s_largest2
    fine_v_s_c = fine_v_s_largest2 < 256
    fine_v_s_e = fine_v_s_largest2 < c4
    fine_v_s = where(fine_v_s_e, c5, where(fine_v_s_c, c3, where(fine_v_s_a, real(c2), real(1))))
    fine_v_s_size_3 = where(fine_v_s_e, c5, where(fine_v_s_c, c3, where(fine_v_s_a, real(c2),
        real(1))))
    fine_v_y_0 = fine_upper_0 * fine_v_s
    fine_v_y_inverse_1 = 1 / fine_v_s
    fine_v_y_lo_1 = (fine_upper_0 - fine_v_y_0 * fine_v_y_inverse_1 + fine_upper_lo_1) * fine_v_s
    fine_v_y_1 = fine_upper_1 * fine_v_s
    fine_v_y_lo_2 = (fine_upper_1 - fine_v_y_1 * fine_v_y_inverse_1 + fine_upper_lo_2) * fine_v_s
    fine_v_y_2 = fine_upper_2 * fine_v_s
    fine_v_y_lo_3 = (fine_upper_2 - fine_v_y_2 * fine_v_y_inverse_1 + fine_upper_lo_3) * fine_v_s
    fine_v_n_a = fine_v_y_0 * fine_v_y_0
    fine_v_n_a_padded_1 = c9 + fine_v_s_size_3 * fine_v_s_size_padded_1
    fine_v_n_a_size_2 = (fine_v_n_a_padded_1
        * (absolute(fine_v_y_0) + c14 * (absolute(fine_v_y_lo_1) + c13 * fine_v_n_a_padded_1)))
    fine_v_n_b = fine_v_y_1 * fine_v_y_1
    fine_v_n_b_padded_1 = c9 + fine_v_s_size_3 * fine_v_s_size_padded_2
    fine_v_n_b_size_2 = (fine_v_n_b_padded_1
        * (absolute(fine_v_y_1) + c14 * (absolute(fine_v_y_lo_2) + c13 * fine_v_n_b_padded_1)))
    fine_v_n_c = fine_v_n_a + fine_v_n_b
    fine_v_n_c_right_1 = fine_v_n_c - fine_v_n_a
    fine_v_n_c_left_rest_1 = product_rest(fine_v_y_0, fine_v_y_0, fine_v_n_a,
        fine_v_n_c - fine_v_n_c_right_1)
    fine_v_n_c_cross_1 = (fine_v_y_lo_1 * fine_v_y_0 + fine_v_y_0 * fine_v_y_lo_1
        + (fine_v_y_lo_2 * fine_v_y_1 + fine_v_y_1 * fine_v_y_lo_2))
    fine_v_n_d = fine_v_y_2 * fine_v_y_2
    fine_v_n_d_padded_1 = c9 + fine_v_s_size_3 * fine_v_s_size_padded_3
    fine_v_n_d_size_2 = (fine_v_n_d_padded_1
        * (absolute(fine_v_y_2) + c14 * (absolute(fine_v_y_lo_3) + c13 * fine_v_n_d_padded_1)))
    fine_v_n_e = fine_v_n_c + fine_v_n_d
    fine_v_n_e_right_1 = fine_v_n_e - fine_v_n_c
    fine_v_n_e_lo1_1 = (fine_v_n_c - (fine_v_n_e - fine_v_n_e_right_1)
        + product_rest(fine_v_y_2, fine_v_y_2, fine_v_n_d, fine_v_n_e_right_1))
    fine_v_n_c_lo = (fine_v_n_c_left_rest_1
        + product_rest(fine_v_y_1, fine_v_y_1, fine_v_n_b, fine_v_n_c_right_1) + fine_v_n_c_cross_1)
    fine_v_n_e_lo = (fine_v_n_e_lo1_1 + (fine_v_y_lo_3 * fine_v_y_2 + fine_v_y_2 * fine_v_y_lo_3)
        + fine_v_n_c_lo)
    fine_v_n = sqrt(fine_v_n_e)
    fine_v_n_product_1 = fine_v_n * fine_v_n
    fine_v_n_residual_1 = (fine_v_n_e - fine_v_n_product_1
        - product_error(fine_v_n, fine_v_n, fine_v_n_product_1) + fine_v_n_e_lo)
    fine_v_n_lo = fine_v_n_residual_1 / where(fine_v_n == 0, 1, fine_v_n + fine_v_n)
    fine_v_n_padded_1 = (c9
        + (fine_v_n_a_size_2 + fine_v_n_a_size_2 + (fine_v_n_b_size_2 + fine_v_n_b_size_2)
        + (fine_v_n_d_size_2 + fine_v_n_d_size_2)))
    fine_v_n_bound_1 = absolute(fine_v_n_e_lo) + c15 * fine_v_n_padded_1
    fine_v_n_size_4 = ((absolute(fine_v_n_e) + c14 * fine_v_n_bound_1)
        * (fine_v_n_padded_1 / fine_v_n / fine_v_n_e))
    fine_v_r_a = fine_v_s < 1
    fine_v_r_c = 1 < fine_v_s
    fine_v_r_e = c3 < fine_v_s
    fine_v_r = where(fine_v_r_e, c8, where(fine_v_r_c, c7, where(fine_v_r_a, real(c6), real(1))))
    fine_n = fine_v_n * fine_v_r
    fine_n_lo = (fine_v_n - fine_n * (1 / fine_v_r) + fine_v_n_lo) * fine_v_r
    fine_n_padded_1 = (c9
        + (fine_v_n
        + where(4 * fine_v_n_bound_1 < fine_v_n_e, fine_v_n_size_4, c16
        * (sqrt(fine_v_n_bound_1) + absolute(fine_v_n_lo)))))
    fine_n_size_1 = (fine_n_padded_1
        * where(fine_v_r_e, c8, where(fine_v_r_c, c7, where(fine_v_r_a, real(c6), real(1)))))
    fine_half = elementary.atan2(fine_n, fine_upper_3)
    fine_half_size0_1 = absolute(fine_n)
    fine_half_size1_1 = absolute(fine_upper_3)
    fine_half_most_1 = where(fine_half_size0_1 < fine_half_size1_1, fine_half_size1_1,
        fine_half_size0_1)
    fine_half_zero_1 = fine_half_most_1 == 0
    fine_half_divisor_1 = where(fine_half_zero_1, 1, fine_half_most_1)
    fine_half_part0_1 = fine_n / fine_half_divisor_1
    fine_half_part1_1 = fine_upper_3 / fine_half_divisor_1
    fine_half_safe_1 = where(fine_half_zero_1, 1,
        fine_half_divisor_1 * (fine_half_part1_1 * fine_half_part1_1 + fine_half_part0_1 *
            fine_half_part0_1))
    fine_half_more_1 = ((fine_half_part1_1 * fine_n_lo - fine_half_part0_1 * fine_upper_lo_4)
        / fine_half_safe_1)
    fine_half_lo = elementary.atan2_error(fine_n, fine_upper_3, fine_half) + fine_half_more_1
    fine_half_padded_1 = c9 + fine_n_size_1
    fine_half_padded_2 = (c9
        + (fine_column_size_4 + c11 * (absolute(fine_upper_size_25) - fine_upper_size_25)))
    fine_half_size_2 = absolute(fine_n)
    fine_half_size_3 = absolute(fine_upper_3)
    fine_half_size_5 = where(fine_half_size_2 < fine_half_size_3, fine_half_size_3,
        fine_half_size_2)
    fine_half_bound_1 = absolute(fine_n_lo) + c17 * fine_half_padded_1
    fine_half_bound_2 = absolute(fine_upper_lo_4) + c12 * fine_half_padded_2
    fine_half_size_11 = (fine_half_bound_2 + (c9 + fine_half_bound_1)) / fine_half_size_5
    fine_half_size_13 = fine_half_size_11 * fine_half_size_11
    fine_half_size_15 = 7 + absolute(fine_half_lo)
    fine_half_size_18 = where(fine_half_bound_2 < fine_upper_3, fine_half_size_13,
        fine_half_size_15)
    fine_half_size_19 = where(fine_half_bound_1 < fine_half_size_2, fine_half_size_13,
        fine_half_size_18)
    fine_half_size_10 = (absolute(fine_half) + (fine_half_padded_1 + fine_half_padded_2)
        / fine_half_size_5)
    fine_divisor_a = fine_n == 0
    fine_divisor = where(fine_divisor_a, 1, fine_n)
    fine_divisor_lo = where(fine_divisor_a, 0, fine_n_lo)
    fine_divisor_size_10 = (c20
        * where(fine_half_bound_1 < c19 + absolute(fine_n - 0), 0, absolute(1 - fine_n)
        + fine_half_bound_1))
    fine_theta = 2 * fine_half
    fine_theta_cross2_1 = 2 * fine_half_lo
    fine_theta_size_1 = (2
        * (fine_half_size_10 + c18
        * where(fine_half_size_11 < 0.25, fine_half_size_19, fine_half_size_15)))
    fine_k = fine_theta / fine_divisor
    fine_k_product_1 = fine_k * fine_divisor
    fine_k_numerator_1 = (fine_theta - fine_k_product_1
        - product_error(fine_k, fine_divisor, fine_k_product_1) + fine_theta_cross2_1)
    fine_k_lo = (fine_k_numerator_1 - fine_k * fine_divisor_lo) / fine_divisor
    fine_k_padded_2 = c9 + (where(fine_divisor_a, 1, fine_n_size_1) + fine_divisor_size_10)
    fine_k_size_1 = absolute(fine_k)
    fine_k_size_2 = absolute(fine_divisor)
    fine_k_bound_1 = absolute(fine_divisor_lo) + c21 * fine_k_padded_2
    fine_k_size_8 = ((c9 + fine_theta_size_1 + fine_k_padded_2 * fine_k_size_1)
        / where(4 * fine_k_bound_1 < fine_k_size_2, fine_k_size_2, 0))
    fine_vector_0 = fine_upper_0 * fine_k
    fine_vector_padded_1 = (c9
        + (fine_k_size_1 + (fine_k_size_2 + c14 * fine_k_bound_1) * fine_k_size_8 / fine_k_size_2))
    fine_vector_reach_2 = fine_k_size_1 + c14 * (absolute(fine_k_lo) + c22 * fine_vector_padded_1)
    fine_vector_size_2 = (fine_vector_padded_1
        * (absolute(fine_upper_0) + c14
        * (absolute(fine_upper_lo_1) + c12 * fine_v_s_size_padded_1)))
    fine_vector_1 = fine_upper_1 * fine_k
    fine_vector_size_6 = (fine_vector_padded_1
        * (absolute(fine_upper_1) + c14
        * (absolute(fine_upper_lo_2) + c12 * fine_v_s_size_padded_2)))
    fine_vector_2 = fine_upper_2 * fine_k
    fine_vector_size_10 = (fine_vector_padded_1
        * (absolute(fine_upper_2) + c14
        * (absolute(fine_upper_lo_3) + c12 * fine_v_s_size_padded_3)))
    half_angle = 0.5 * fine_theta
    half_angle_cross2_1 = 0.5 * fine_theta_cross2_1
    half_angle_size_1 = 0.5 * fine_theta_size_1
    length_a = fine_n * fine_n
    length_a_size_1 = fine_half_padded_1 * (fine_half_size_2 + c14 * fine_half_bound_1)
    length_b = fine_upper_3 * fine_upper_3
    length_b_size_1 = fine_half_padded_2 * (fine_half_size_3 + c14 * fine_half_bound_2)
    length_c = length_a + length_b
    length_c_right_1 = length_c - length_a
    length_c_right_rest_1 = product_rest(fine_upper_3, fine_upper_3, length_b, length_c_right_1)
    length_c_cross_1 = (fine_n_lo * fine_n + fine_n * fine_n_lo
        + (fine_upper_lo_4 * fine_upper_3 + fine_upper_3 * fine_upper_lo_4))
    length_c_lo = (product_rest(fine_n, fine_n, length_a, length_c - length_c_right_1)
        + length_c_right_rest_1 + length_c_cross_1)
    length = sqrt(length_c)
    length_product_1 = length * length
    length_lo = ((length_c - length_product_1 - product_error(length, length, length_product_1)
        + length_c_lo) / where(length == 0, 1, length + length))
    length_padded_1 = c9 + (length_a_size_1 + length_a_size_1 + (length_b_size_1 + length_b_size_1))
    length_bound_1 = absolute(length_c_lo) + c23 * length_padded_1
    length_size_6 = absolute(length_lo)
    length_size_4 = ((absolute(length_c) + c14 * length_bound_1)
        * (length_padded_1 / length / length_c))
    sine = fine_n / length
    sine_product_1 = sine * length
    sine_padded_1 = (c9
        + (length
        + where(4 * length_bound_1 < length_c, length_size_4, c24
        * (sqrt(length_bound_1) + length_size_6))))
    sine_size_1 = absolute(sine)
    sine_size_2 = absolute(length)
    sine_bound_1 = length_size_6 + c25 * sine_padded_1
    sine_size_7 = where(4 * sine_bound_1 < sine_size_2, sine_size_2, 0)
    sine_reach_1 = sine_size_2 + c14 * sine_bound_1
    c = fine_upper_3 / length
    c_product_1 = c * length
    c_lo = ((fine_upper_3 - c_product_1 - product_error(c, length, c_product_1) + fine_upper_lo_4
        - c * length_lo) / length)
    c_size_1 = absolute(c)
    c_size_7 = (c_size_1 + (c_size_1 * sine_padded_1 + fine_half_padded_2) / sine_size_7
        * sine_reach_1 / sine_size_2)
    y = half_angle * half_angle
    y_padded_1 = c9 + half_angle_size_1
    y_bound_1 = absolute(half_angle_cross2_1) + c26 * y_padded_1
    y_size_2 = y_padded_1 * (absolute(half_angle) + c14 * y_bound_1)
    y_size_3 = y_size_2 + y_size_2
    sinc_divisor_a = half_angle < 1.4901161193847656e-08
    sinc_divisor = where(sinc_divisor_a, 1.4901161193847656e-08, half_angle)
    sinc_divisor_lo = where(sinc_divisor_a, 0, half_angle_cross2_1)
    sinc_divisor_size_4 = y_bound_1 < absolute(half_angle - 1.4901161193847656e-08)
    sinc_divisor_size_9 = (c27
        * where(sinc_divisor_size_4, 0, absolute(1.4901161193847656e-08 - half_angle) + y_bound_1))
    sinc_quotient = sine / sinc_divisor
    sinc_quotient_product_1 = sinc_quotient * sinc_divisor
    sine_lo = ((fine_n - sine_product_1 - product_error(sine, length, sine_product_1) + fine_n_lo
        - sine * length_lo) / length)
    sinc_quotient_numerator_1 = (sine - sinc_quotient_product_1
        - product_error(sinc_quotient, sinc_divisor, sinc_quotient_product_1) + sine_lo)
    sinc_quotient_lo = (sinc_quotient_numerator_1 - sinc_quotient * sinc_divisor_lo) / sinc_divisor
    sinc_quotient_padded_2 = (c9
        + (where(sinc_divisor_a, 1.4901161193847656e-08, half_angle_size_1) + sinc_divisor_size_9))
    sinc_quotient_size_1 = absolute(sinc_quotient)
    sinc_quotient_size_2 = absolute(sinc_divisor)
    sinc_quotient_padded_1 = (c9
        + (sine_size_1 + sine_reach_1
        * ((fine_half_padded_1 + sine_padded_1 * sine_size_1) / sine_size_7) / sine_size_2))
    sinc_quotient_bound_1 = absolute(sinc_divisor_lo) + c28 * sinc_quotient_padded_2
    sinc_quotient_size_7 = where(4 * sinc_quotient_bound_1 < sinc_quotient_size_2,
        sinc_quotient_size_2, 0)
    sinc_quotient_size_8 = ((sinc_quotient_padded_1 + sinc_quotient_padded_2
        * sinc_quotient_size_1) / sinc_quotient_size_7)
    sinc_quotient_size_11 = (sinc_quotient_size_1
        + (sinc_quotient_size_2 + c14 * sinc_quotient_bound_1) * sinc_quotient_size_8
        / sinc_quotient_size_2)
    y_lo = (product_error(half_angle, half_angle, y)
        + (half_angle_cross2_1 * half_angle + half_angle * half_angle_cross2_1))
    sinc_a = 0.16666666666666666 * y
    sinc_b = 1 - sinc_a
    sinc_b_right_1 = 1 - sinc_b
    sinc_b_lo = (1 - (sinc_b + sinc_b_right_1)
        - product_rest(0.16666666666666666, y, sinc_a, sinc_b_right_1)
        - (c29 * y + 0.16666666666666666 * y_lo))
    sinc_b_size_1 = 1 + c30 * y_size_3
    sinc = where(sinc_divisor_a, sinc_b, sinc_quotient)
    sinc_lo = where(sinc_divisor_a, sinc_b_lo, sinc_quotient_lo)
    sinc_size_4 = (absolute(sinc_b_lo) + c31 * (c9 + sinc_b_size_1)
        + absolute(sinc_b - sinc_quotient))
    sinc_size_7 = (c33
        * where(sinc_divisor_size_4, 0, absolute(sinc_quotient_lo) + c32
        * (c9 + sinc_quotient_size_11) + sinc_size_4))
    sinc_size_8 = where(sinc_divisor_a, sinc_b_size_1, sinc_quotient_size_11) + sinc_size_7
    series_phi_a = 5.107725174524775e-32 * y
    series_phi_b = 4.116826490666969e-29 - series_phi_a
    series_phi_b_right_1 = 4.116826490666969e-29 - series_phi_b
    series_phi_b_right_rest_1 = product_rest(5.107725174524775e-32, y, series_phi_a,
        series_phi_b_right_1)
    series_phi_b_lo1_1 = (4.116826490666969e-29 - (series_phi_b + series_phi_b_right_1)
        - series_phi_b_right_rest_1)
    series_phi_b_lo = series_phi_b_lo1_1 - (c34 * y + 5.107725174524775e-32 * y_lo) + c36
    series_phi_c = y * series_phi_b
    series_phi_c_padded_1 = c9 + y_size_3
    series_phi_c_padded_2 = c9 + (4.116826490666969e-29 + c35 * y_size_3)
    series_phi_c_bound_1 = absolute(y_lo) + c37 * series_phi_c_padded_1
    series_phi_c_reach_1 = absolute(y) + c14 * series_phi_c_bound_1
    series_phi_c_size_4 = (series_phi_c_padded_1
        * (absolute(series_phi_b) + c14
        * (absolute(series_phi_b_lo) + c31 * series_phi_c_padded_2)))
    series_phi_d = series_phi_c - 2.86531123750421e-26
    series_phi_d_right_1 = series_phi_c - series_phi_d
    series_phi_d_lo1_1 = (product_rest(y, series_phi_b, series_phi_c, series_phi_d
        + series_phi_d_right_1) - (2.86531123750421e-26 - series_phi_d_right_1))
    series_phi_d_lo = series_phi_d_lo1_1 - c38 + (y_lo * series_phi_b + y * series_phi_b_lo)
    series_phi_e = y * series_phi_d
    series_phi_e_padded_1 = (c9
        + (2.86531123750421e-26
        + (series_phi_c_padded_2 * series_phi_c_reach_1 + series_phi_c_size_4)))
    series_phi_e_size_3 = (series_phi_c_padded_1
        * (absolute(series_phi_d) + c14
        * (absolute(series_phi_d_lo) + c39 * series_phi_e_padded_1)))
    series_phi_f = series_phi_e + 1.701994875077501e-23
    series_phi_f_right_1 = series_phi_f - series_phi_e
    series_phi_f_lo1_1 = (product_rest(y, series_phi_d, series_phi_e, series_phi_f
        - series_phi_f_right_1) + (1.701994875077501e-23 - series_phi_f_right_1))
    series_phi_f_lo = series_phi_f_lo1_1 + c40 + (y_lo * series_phi_d + y * series_phi_d_lo)
    series_phi_g = y * series_phi_f
    series_phi_g_padded_1 = (c9
        + (1.701994875077501e-23
        + (series_phi_c_reach_1 * series_phi_e_padded_1 + series_phi_e_size_3)))
    series_phi_g_size_3 = (series_phi_c_padded_1
        * (absolute(series_phi_f) + c14
        * (absolute(series_phi_f_lo) + c41 * series_phi_g_padded_1)))
    series_phi_h = series_phi_g - 8.509974375387505e-21
    series_phi_h_right_1 = series_phi_g - series_phi_h
    series_phi_h_lo1_1 = (product_rest(y, series_phi_f, series_phi_g, series_phi_h
        + series_phi_h_right_1) - (8.509974375387505e-21 - series_phi_h_right_1))
    series_phi_h_lo = series_phi_h_lo1_1 - c42 + (y_lo * series_phi_f + y * series_phi_f_lo)
    series_phi_i = y * series_phi_h
    series_phi_i_padded_1 = (c9
        + (8.509974375387505e-21
        + (series_phi_c_reach_1 * series_phi_g_padded_1 + series_phi_g_size_3)))
    series_phi_i_size_3 = (series_phi_c_padded_1
        * (absolute(series_phi_h) + c14
        * (absolute(series_phi_h_lo) + c43 * series_phi_i_padded_1)))
    series_phi_j = series_phi_i + 3.523129391410427e-18
    series_phi_j_right_1 = series_phi_j - series_phi_i
    series_phi_j_lo1_1 = (product_rest(y, series_phi_h, series_phi_i, series_phi_j
        - series_phi_j_right_1) + (3.523129391410427e-18 - series_phi_j_right_1))
    series_phi_j_lo = series_phi_j_lo1_1 + c44 + (y_lo * series_phi_h + y * series_phi_h_lo)
    series_phi_k = y * series_phi_j
    series_phi_k_padded_1 = (c9
        + (3.523129391410427e-18
        + (series_phi_c_reach_1 * series_phi_i_padded_1 + series_phi_i_size_3)))
    series_phi_k_size_3 = (series_phi_c_padded_1
        * (absolute(series_phi_j) + c14
        * (absolute(series_phi_j_lo) + c45 * series_phi_k_padded_1)))
    series_phi_l = series_phi_k - 1.1837714755139035e-15
    series_phi_l_right_1 = series_phi_k - series_phi_l
    series_phi_l_left_rest_1 = product_rest(y, series_phi_j, series_phi_k,
        series_phi_l + series_phi_l_right_1)
    series_phi_l_lo = (series_phi_l_left_rest_1 - (1.1837714755139035e-15 - series_phi_l_right_1)
        - c46 + (y_lo * series_phi_j + y * series_phi_j_lo))
    series_phi_m = y * series_phi_l
    series_phi_m_padded_1 = (c9
        + (1.1837714755139035e-15
        + (series_phi_c_reach_1 * series_phi_k_padded_1 + series_phi_k_size_3)))
    series_phi_m_size_3 = (series_phi_c_padded_1
        * (absolute(series_phi_l) + c14
        * (absolute(series_phi_l_lo) + c47 * series_phi_m_padded_1)))
    series_phi_n = series_phi_m + 3.148832124866983e-13
    series_phi_n_right_1 = series_phi_n - series_phi_m
    series_phi_n_lo1_1 = (product_rest(y, series_phi_l, series_phi_m, series_phi_n
        - series_phi_n_right_1) + (3.148832124866983e-13 - series_phi_n_right_1))
    series_phi_n_lo = series_phi_n_lo1_1 + c48 + (y_lo * series_phi_l + y * series_phi_l_lo)
    series_phi_o = y * series_phi_n
    series_phi_o_padded_1 = (c9
        + (3.148832124866983e-13
        + (series_phi_c_reach_1 * series_phi_m_padded_1 + series_phi_m_size_3)))
    series_phi_o_size_3 = (series_phi_c_padded_1
        * (absolute(series_phi_n) + c14
        * (absolute(series_phi_n_lo) + c49 * series_phi_o_padded_1)))
    series_phi_p = series_phi_o - 6.423617534728645e-11
    series_phi_p_right_1 = series_phi_o - series_phi_p
    series_phi_p_lo1_1 = (product_rest(y, series_phi_n, series_phi_o, series_phi_p
        + series_phi_p_right_1) - (6.423617534728645e-11 - series_phi_p_right_1))
    series_phi_p_lo = series_phi_p_lo1_1 - c50 + (y_lo * series_phi_n + y * series_phi_n_lo)
    series_phi_q = y * series_phi_p
    series_phi_q_padded_1 = (c9
        + (6.423617534728645e-11
        + (series_phi_c_reach_1 * series_phi_o_padded_1 + series_phi_o_size_3)))
    series_phi_q_size_3 = (series_phi_c_padded_1
        * (absolute(series_phi_p) + c14
        * (absolute(series_phi_p_lo) + c51 * series_phi_q_padded_1)))
    series_phi_r = series_phi_q + 9.635426302092969e-09
    series_phi_r_right_1 = series_phi_r - series_phi_q
    series_phi_r_lo1_1 = (product_rest(y, series_phi_p, series_phi_q, series_phi_r
        - series_phi_r_right_1) + (9.635426302092969e-09 - series_phi_r_right_1))
    series_phi_r_lo = series_phi_r_lo1_1 + c52 + (y_lo * series_phi_p + y * series_phi_p_lo)
    series_phi_s = y * series_phi_r
    series_phi_s_padded_1 = (c9
        + (9.635426302092969e-09
        + (series_phi_c_reach_1 * series_phi_q_padded_1 + series_phi_q_size_3)))
    series_phi_s_size_3 = (series_phi_c_padded_1
        * (absolute(series_phi_r) + c14
        * (absolute(series_phi_r_lo) + c53 * series_phi_s_padded_1)))
    series_phi_t = series_phi_s - 1.0020843354176687e-06
    series_phi_t_right_1 = series_phi_s - series_phi_t
    series_phi_t_left_rest_1 = product_rest(y, series_phi_r, series_phi_s,
        series_phi_t + series_phi_t_right_1)
    series_phi_t_lo = (series_phi_t_left_rest_1 - (1.0020843354176687e-06 - series_phi_t_right_1)
        - c54 + (y_lo * series_phi_r + y * series_phi_r_lo))
    series_phi_u = y * series_phi_t
    series_phi_u_padded_1 = (c9
        + (1.0020843354176687e-06
        + (series_phi_c_reach_1 * series_phi_s_padded_1 + series_phi_s_size_3)))
    series_phi_u_size_3 = (series_phi_c_padded_1
        * (absolute(series_phi_t) + c14
        * (absolute(series_phi_t_lo) + c55 * series_phi_u_padded_1)))
    series_phi_v = series_phi_u + 6.613756613756614e-05
    series_phi_v_right_1 = series_phi_v - series_phi_u
    series_phi_v_lo1_1 = (product_rest(y, series_phi_t, series_phi_u, series_phi_v
        - series_phi_v_right_1) + (6.613756613756614e-05 - series_phi_v_right_1))
    series_phi_v_lo = series_phi_v_lo1_1 + c56 + (y_lo * series_phi_t + y * series_phi_t_lo)
    series_phi_w = y * series_phi_v
    series_phi_w_padded_1 = (c9
        + (6.613756613756614e-05
        + (series_phi_c_reach_1 * series_phi_u_padded_1 + series_phi_u_size_3)))
    series_phi_w_size_3 = (series_phi_c_padded_1
        * (absolute(series_phi_v) + c14
        * (absolute(series_phi_v_lo) + c57 * series_phi_w_padded_1)))
    series_phi_x = series_phi_w - 0.002380952380952381
    series_phi_x_right_1 = series_phi_w - series_phi_x
    series_phi_x_lo1_1 = (product_rest(y, series_phi_v, series_phi_w, series_phi_x
        + series_phi_x_right_1) - (0.002380952380952381 - series_phi_x_right_1))
    series_phi_x_lo = series_phi_x_lo1_1 - c58 + (y_lo * series_phi_v + y * series_phi_v_lo)
    series_phi_y = y * series_phi_x
    series_phi_y_padded_1 = (c9
        + (0.002380952380952381
        + (series_phi_c_reach_1 * series_phi_w_padded_1 + series_phi_w_size_3)))
    series_phi_y_size_3 = (series_phi_c_padded_1
        * (absolute(series_phi_x) + c14
        * (absolute(series_phi_x_lo) + c59 * series_phi_y_padded_1)))
    series_phi = series_phi_y + 0.03333333333333333
    series_phi_right_1 = series_phi - series_phi_y
    series_phi_lo2_1 = (product_rest(y, series_phi_x, series_phi_y, series_phi
        - series_phi_right_1) + (0.03333333333333333 - series_phi_right_1) + c60)
    series_phi_lo = series_phi_lo2_1 + (y_lo * series_phi_x + y * series_phi_x_lo)
    f_more_a = 2 * y
    f_more_a_cross2_1 = 2 * y_lo
    f_more = f_more_a * series_phi
    f_more_padded_1 = c9 + 2 * y_size_3
    f_more_padded_2 = (c9
        + (0.03333333333333333
        + (series_phi_c_reach_1 * series_phi_y_padded_1 + series_phi_y_size_3)))
    f_more_size_2 = (f_more_padded_2
        * (absolute(f_more_a) + c14 * (absolute(f_more_a_cross2_1) + c61 * f_more_padded_1)))
    near_f_a = 0.3333333333333333 * sinc
    near_f_b = 0.3333333333333333 * f_more
    near_f_b_cross2_1 = (0.3333333333333333
        * (product_error(f_more_a, series_phi, f_more)
        + (f_more_a_cross2_1 * series_phi + f_more_a * series_phi_lo)))
    f_more_size_5 = (f_more_size_2 + f_more_padded_1
        * (absolute(series_phi) + c14 * (absolute(series_phi_lo) + c62 * f_more_padded_2)))
    near_f = near_f_a + near_f_b
    near_f_right_1 = near_f - near_f_a
    near_f_left_rest_1 = product_rest(0.3333333333333333, sinc, near_f_a, near_f - near_f_right_1)
    near_f_lo1_1 = (near_f_left_rest_1
        + product_rest(0.3333333333333333, f_more, near_f_b, near_f_right_1))
    near_f_lo = (near_f_lo1_1
        + (c63 * sinc + 0.3333333333333333 * sinc_lo + (c63 * f_more + near_f_b_cross2_1)))
    near_f_size_1 = 0.3333333333333333 * sinc_size_8 + 0.3333333333333333 * f_more_size_5
    f_rest = sinc - c
    f_rest_right_1 = sinc - f_rest
    fine_x = 4 * y
    far_y_a = fine_x < 4
    far_y = where(far_y_a, 1, y)
    far_y_lo = where(far_y_a, 0, y_lo)
    far_y_size_4 = absolute(4 * y_lo) + c61 * (c9 + 4 * y_size_3) < absolute(fine_x - 4)
    closed_f = f_rest / far_y
    closed_f_product_1 = closed_f * far_y
    closed_f_exact_1 = (f_rest - closed_f_product_1
        - product_error(closed_f, far_y, closed_f_product_1))
    closed_f_lo = ((closed_f_exact_1
        + (sinc - (f_rest + f_rest_right_1) - (c - f_rest_right_1) - c_lo + sinc_lo) - closed_f
        * far_y_lo) / far_y)
    closed_f_padded_2 = (c9
        + (where(far_y_a, 1, y_size_3) + c64
        * where(far_y_size_4, 0, absolute(1 - y) + series_phi_c_bound_1)))
    closed_f_size_1 = absolute(closed_f)
    closed_f_size_2 = absolute(far_y)
    closed_f_bound_1 = absolute(far_y_lo) + c65 * closed_f_padded_2
    closed_f_size_4 = c9 + (c_size_7 + sinc_size_8) + closed_f_padded_2 * closed_f_size_1
    closed_f_size_9 = ((closed_f_size_2 + c14 * closed_f_bound_1)
        * (closed_f_size_4 / where(4 * closed_f_bound_1 < closed_f_size_2, closed_f_size_2, 0)))
    closed_f_size_11 = closed_f_size_1 + closed_f_size_9 / closed_f_size_2
    f = where(far_y_a, near_f, closed_f)
    f_size_5 = (absolute(closed_f_lo) + c67 * (c9 + closed_f_size_11)
        + (absolute(near_f_lo) + c66 * (c9 + near_f_size_1) + absolute(near_f - closed_f)))
    four_k = 4 * sinc
    four_k_cross2_1 = 4 * sinc_lo
    fine_b = f / four_k
    fine_b_product_1 = fine_b * four_k
    fine_b_numerator_1 = (f - fine_b_product_1 - product_error(fine_b, four_k, fine_b_product_1)
        + where(far_y_a, near_f_lo, closed_f_lo))
    fine_b_lo = (fine_b_numerator_1 - fine_b * four_k_cross2_1) / four_k
    fine_b_padded_2 = c9 + 4 * sinc_size_8
    fine_b_size_1 = absolute(fine_b)
    fine_b_size_2 = absolute(four_k)
    fine_b_bound_1 = absolute(four_k_cross2_1) + c69 * fine_b_padded_2
    fine_b_size_4 = (c9
        + (where(far_y_a, near_f_size_1, closed_f_size_11) + c68
        * where(far_y_size_4, 0, f_size_5)) + fine_b_padded_2 * fine_b_size_1)
    fine_b_size_9 = ((fine_b_size_2 + c14 * fine_b_bound_1)
        * (fine_b_size_4 / where(4 * fine_b_bound_1 < fine_b_size_2, fine_b_size_2, 0)))
    fine_b_across = c / sinc
    fine_b_across_product_1 = fine_b_across * sinc
    fine_b_across_lo = ((c - fine_b_across_product_1
        - product_error(fine_b_across, sinc, fine_b_across_product_1) + c_lo - fine_b_across
        * sinc_lo) / sinc)
    fine_b_across_padded_2 = c9 + sinc_size_8
    fine_b_across_size_1 = absolute(fine_b_across)
    fine_b_across_size_2 = absolute(sinc)
    fine_b_across_bound_1 = absolute(sinc_lo) + c70 * fine_b_across_padded_2
    fine_b_across_size_7 = where(4 * fine_b_across_bound_1 < fine_b_across_size_2,
        fine_b_across_size_2, 0)
    fine_b_across_size_8 = ((c9 + c_size_7 + fine_b_across_padded_2 * fine_b_across_size_1)
        / fine_b_across_size_7)
    fine_vector_lo_1 = (product_error(fine_upper_0, fine_k, fine_vector_0)
        + (fine_upper_lo_1 * fine_k + fine_upper_0 * fine_k_lo))
    fine_wt_a = D_03 * fine_vector_0
    fine_wt_a_size_1 = absolute(D_03)
    fine_wt_a_padded_1 = c9 + (fine_vector_size_2 + fine_v_s_size_padded_1 * fine_vector_reach_2)
    fine_vector_lo_2 = (product_error(fine_upper_1, fine_k, fine_vector_1)
        + (fine_upper_lo_2 * fine_k + fine_upper_1 * fine_k_lo))
    fine_wt_b = D_13 * fine_vector_1
    fine_wt_b_size_1 = absolute(D_13)
    fine_wt_b_padded_1 = c9 + (fine_vector_size_6 + fine_v_s_size_padded_2 * fine_vector_reach_2)
    fine_wt_c = fine_wt_a + fine_wt_b
    fine_wt_c_right_1 = fine_wt_c - fine_wt_a
    fine_wt_c_left_rest_1 = product_rest(D_03, fine_vector_0, fine_wt_a,
        fine_wt_c - fine_wt_c_right_1)
    fine_wt_c_lo1_1 = (fine_wt_c_left_rest_1
        + product_rest(D_13, fine_vector_1, fine_wt_b, fine_wt_c_right_1))
    fine_vector_lo_3 = (product_error(fine_upper_2, fine_k, fine_vector_2)
        + (fine_upper_lo_3 * fine_k + fine_upper_2 * fine_k_lo))
    fine_wt_d = D_23 * fine_vector_2
    fine_wt_d_size_1 = absolute(D_23)
    fine_wt_d_padded_1 = c9 + (fine_vector_size_10 + fine_v_s_size_padded_3 * fine_vector_reach_2)
    fine_wt = fine_wt_c + fine_wt_d
    fine_wt_right_1 = fine_wt - fine_wt_c
    fine_wt_lo2_1 = (fine_wt_c - (fine_wt - fine_wt_right_1)
        + product_rest(D_23, fine_vector_2, fine_wt_d, fine_wt_right_1) + D_23 * fine_vector_lo_3)
    fine_wt_lo = (fine_wt_lo2_1
        + (fine_wt_c_lo1_1 + (D_03 * fine_vector_lo_1 + D_13 * fine_vector_lo_2)))
    fine_pitch = fine_b * fine_wt
    fine_pitch_padded_1 = c9 + (fine_b_size_1 + fine_b_size_9 / fine_b_size_2)
    fine_pitch_padded_2 = (c9
        + (fine_wt_a_padded_1 * fine_wt_a_size_1 + fine_wt_b_padded_1 * fine_wt_b_size_1
        + fine_wt_d_padded_1 * fine_wt_d_size_1))
    fine_pitch_size_3 = (fine_pitch_padded_1
        * (absolute(fine_wt) + c14 * (absolute(fine_wt_lo) + c72 * fine_pitch_padded_2)))
    fine_pitch_lo = (product_error(fine_b, fine_wt, fine_pitch)
        + (fine_b_lo * fine_wt + fine_b * fine_wt_lo))
    fine_along_0 = fine_vector_0 * fine_pitch
    fine_along_padded_1 = (c9
        + (fine_pitch_padded_2
        * (fine_b_size_1 + c14 * (absolute(fine_b_lo) + c71 * fine_pitch_padded_1))
        + fine_pitch_size_3))
    fine_along_rest_1 = c73 * fine_wt_a_padded_1
    fine_along_reach_2 = (absolute(fine_pitch) + c14
        * (absolute(fine_pitch_lo) + c74 * fine_along_padded_1))
    fine_along_size_2 = (fine_along_padded_1
        * (absolute(fine_vector_0) + c14 * (absolute(fine_vector_lo_1) + fine_along_rest_1)))
    fine_along_1 = fine_vector_1 * fine_pitch
    fine_along_rest_3 = c73 * fine_wt_b_padded_1
    fine_along_size_7 = (fine_along_padded_1
        * (absolute(fine_vector_1) + c14 * (absolute(fine_vector_lo_2) + fine_along_rest_3)))
    fine_along_2 = fine_vector_2 * fine_pitch
    fine_along_rest_4 = c73 * fine_wt_d_padded_1
    fine_along_size_11 = (fine_along_padded_1
        * (absolute(fine_vector_2) + c14 * (absolute(fine_vector_lo_3) + fine_along_rest_4)))
    fine_u_0a = D_23 * fine_vector_1
    fine_u_0b = D_13 * fine_vector_2
    fine_u_0 = fine_u_0a - fine_u_0b
    fine_u_right_1 = fine_u_0a - fine_u_0
    fine_u_lo1_1 = (product_rest(D_23, fine_vector_1, fine_u_0a, fine_u_0 + fine_u_right_1)
        - product_rest(D_13, fine_vector_2, fine_u_0b, fine_u_right_1))
    fine_u_1a = D_03 * fine_vector_2
    fine_u_1b = D_23 * fine_vector_0
    fine_u_1 = fine_u_1a - fine_u_1b
    fine_u_right_2 = fine_u_1a - fine_u_1
    fine_u_lo1_2 = (product_rest(D_03, fine_vector_2, fine_u_1a, fine_u_1 + fine_u_right_2)
        - product_rest(D_23, fine_vector_0, fine_u_1b, fine_u_right_2))
    fine_u_2a = D_13 * fine_vector_0
    fine_u_2b = D_03 * fine_vector_1
    fine_u_2 = fine_u_2a - fine_u_2b
    fine_u_right_3 = fine_u_2a - fine_u_2
    fine_u_lo1_3 = (product_rest(D_13, fine_vector_0, fine_u_2a, fine_u_2 + fine_u_right_3)
        - product_rest(D_03, fine_vector_1, fine_u_2b, fine_u_right_3))
    fine_turned_0 = 0.5 * fine_u_0
    fine_turned_1 = 0.5 * fine_u_1
    fine_turned_2 = 0.5 * fine_u_2
    fine_across_axis_0 = fine_along_0 - fine_turned_0
    fine_across_axis_right_1 = fine_along_0 - fine_across_axis_0
    fine_across_axis_left_rest_1 = product_rest(fine_vector_0, fine_pitch, fine_along_0,
        fine_across_axis_0 + fine_across_axis_right_1)
    fine_turned_cross2_1 = (0.5
        * (fine_u_lo1_1 + (D_23 * fine_vector_lo_2 - D_13 * fine_vector_lo_3)))
    fine_across_axis_lo2_1 = (fine_across_axis_left_rest_1
        - (fine_turned_0 - fine_across_axis_right_1) - fine_turned_cross2_1)
    fine_turned_size_1 = (0.5
        * (fine_wt_b_padded_1 * fine_wt_d_size_1 + fine_wt_b_size_1 * fine_wt_d_padded_1))
    fine_across_axis_1 = fine_along_1 - fine_turned_1
    fine_across_axis_right_2 = fine_along_1 - fine_across_axis_1
    fine_across_axis_left_rest_2 = product_rest(fine_vector_1, fine_pitch, fine_along_1,
        fine_across_axis_1 + fine_across_axis_right_2)
    fine_turned_cross2_2 = (0.5
        * (fine_u_lo1_2 + (D_03 * fine_vector_lo_3 - D_23 * fine_vector_lo_1)))
    fine_across_axis_lo2_2 = (fine_across_axis_left_rest_2
        - (fine_turned_1 - fine_across_axis_right_2) - fine_turned_cross2_2)
    fine_turned_size_2 = (0.5
        * (fine_wt_a_size_1 * fine_wt_d_padded_1 + fine_wt_a_padded_1 * fine_wt_d_size_1))
    fine_across_axis_2 = fine_along_2 - fine_turned_2
    fine_across_axis_right_3 = fine_along_2 - fine_across_axis_2
    fine_across_axis_left_rest_3 = product_rest(fine_vector_2, fine_pitch, fine_along_2,
        fine_across_axis_2 + fine_across_axis_right_3)
    fine_turned_cross2_3 = (0.5
        * (fine_u_lo1_3 + (D_13 * fine_vector_lo_1 - D_03 * fine_vector_lo_2)))
    fine_across_axis_lo2_3 = (fine_across_axis_left_rest_3
        - (fine_turned_2 - fine_across_axis_right_3) - fine_turned_cross2_3)
    fine_turned_size_3 = (0.5
        * (fine_wt_a_padded_1 * fine_wt_b_size_1 + fine_wt_a_size_1 * fine_wt_b_padded_1))
    fine_so_0a = D_03 * fine_b_across
    fine_so_0a_padded_1 = (c9
        + (fine_b_across_size_1 + (fine_b_across_size_2 + c14 * fine_b_across_bound_1)
        * fine_b_across_size_8 / fine_b_across_size_2))
    fine_so_0 = fine_so_0a + fine_across_axis_0
    fine_so_right_1 = fine_so_0 - fine_so_0a
    fine_so_lo1_1 = (product_rest(D_03, fine_b_across, fine_so_0a, fine_so_0 - fine_so_right_1)
        + (fine_across_axis_0 - fine_so_right_1))
    fine_so_1a = D_13 * fine_b_across
    fine_so_1 = fine_so_1a + fine_across_axis_1
    fine_so_right_2 = fine_so_1 - fine_so_1a
    fine_so_lo1_2 = (product_rest(D_13, fine_b_across, fine_so_1a, fine_so_1 - fine_so_right_2)
        + (fine_across_axis_1 - fine_so_right_2))
    fine_so_2a = D_23 * fine_b_across
    fine_so_2 = fine_so_2a + fine_across_axis_2
    fine_so_right_3 = fine_so_2 - fine_so_2a
    fine_so_lo1_3 = (product_rest(D_23, fine_b_across, fine_so_2a, fine_so_2 - fine_so_right_3)
        + (fine_across_axis_2 - fine_so_right_3))
    fine_so_lo_1 = (fine_so_lo1_1
        + (fine_across_axis_lo2_1
        + (fine_vector_lo_1 * fine_pitch + fine_vector_0 * fine_pitch_lo)) + D_03
        * fine_b_across_lo)
    so_rest_1 = (c76
        * (c9
        + (fine_along_size_2 + fine_along_reach_2 * fine_wt_a_padded_1 + fine_turned_size_1
        + fine_so_0a_padded_1 * fine_wt_a_size_1)))
    fine_so_lo_2 = (fine_so_lo1_2
        + (fine_across_axis_lo2_2
        + (fine_vector_lo_2 * fine_pitch + fine_vector_1 * fine_pitch_lo)) + D_13
        * fine_b_across_lo)
    so_rest_2 = (c76
        * (c9
        + (fine_along_size_7 + fine_along_reach_2 * fine_wt_b_padded_1 + fine_turned_size_2
        + fine_so_0a_padded_1 * fine_wt_b_size_1)))
    fine_so_lo_3 = (fine_so_lo1_3
        + (fine_across_axis_lo2_3
        + (fine_vector_lo_3 * fine_pitch + fine_vector_2 * fine_pitch_lo)) + D_23
        * fine_b_across_lo)
    so_rest_3 = (c76
        * (c9
        + (fine_along_size_11 + fine_along_reach_2 * fine_wt_d_padded_1 + fine_turned_size_3
        + fine_so_0a_padded_1 * fine_wt_d_size_1)))
    D_n_0 = D_11 * D_22 - D_12 * D_21
    D_n_1 = D_02 * D_21 - D_01 * D_22
    D_n_2 = D_01 * D_12 - D_02 * D_11
    D_det = D_00 * D_n_0 + D_10 * D_n_1 + D_20 * D_n_2
    D_g_0 = D_00 * D_00 + D_10 * D_10 + D_20 * D_20
    D_g_1 = D_00 * D_01 + D_10 * D_11 + D_20 * D_21
    D_g_2 = D_00 * D_02 + D_10 * D_12 + D_20 * D_22
    D_g_3 = D_01 * D_01 + D_11 * D_11 + D_21 * D_21
    D_g_4 = D_01 * D_02 + D_11 * D_12 + D_21 * D_22
    D_g_5 = D_02 * D_02 + D_12 * D_12 + D_22 * D_22
    D_off_0 = D_det - 1
    D_off_1 = D_g_0 - 1
    D_off_4 = D_g_3 - 1
    D_off_6 = D_g_5 - 1
    D_defect_size_0 = absolute(D_off_0)
    D_defect_size_1 = absolute(D_off_1)
    D_defect_size_2 = absolute(D_g_1)
    D_defect_size_3 = absolute(D_g_2)
    D_defect_size_4 = absolute(D_off_4)
    D_defect_size_5 = absolute(D_g_4)
    D_defect_size_6 = absolute(D_off_6)
    D_defect_largest1 = where(D_defect_size_0 < D_defect_size_1, D_defect_size_1, D_defect_size_0)
    D_defect_largest2 = where(D_defect_largest1 < D_defect_size_2, D_defect_size_2,
        D_defect_largest1)
    D_defect_largest3 = where(D_defect_largest2 < D_defect_size_3, D_defect_size_3,
        D_defect_largest2)
    D_defect_largest4 = where(D_defect_largest3 < D_defect_size_4, D_defect_size_4,
        D_defect_largest3)
    D_defect_largest5 = where(D_defect_largest4 < D_defect_size_5, D_defect_size_5,
        D_defect_largest4)
    D_defect_largest6 = where(D_defect_largest5 < D_defect_size_6, D_defect_size_6,
        D_defect_largest5)
    D_is_less = D_defect_largest6 < 0.001
    D_is_equal = D_defect_largest6 == 0.001
    D_unless_equal = where(D_is_equal, real(0), real(c77))
    D_unless_rotation = where(D_is_less, 0, D_unless_equal)
    D_excess = D_unless_rotation * c77
    D_excess_0 = c75 * absolute(fine_so_lo_1 + (fine_so_0 - so_0)) + so_rest_1 + D_excess
    D_excess_1 = c75 * absolute(fine_so_lo_2 + (fine_so_1 - so_1)) + so_rest_2 + D_excess
    D_excess_2 = c75 * absolute(fine_so_lo_3 + (fine_so_2 - so_2)) + so_rest_3 + D_excess
    D_excess_3 = (fine_along_rest_1 + c75 * absolute(fine_vector_lo_1 + (fine_vector_0 - vector_0))
        + D_excess)
    D_excess_4 = (fine_along_rest_3 + c75 * absolute(fine_vector_lo_2 + (fine_vector_1 - vector_1))
        + D_excess)
    D_excess_5 = (fine_along_rest_4 + c75 * absolute(fine_vector_lo_3 + (fine_vector_2 - vector_2))
        + D_excess)
    return (so_0, so_1, so_2, vector_0, vector_1, vector_2, D_excess_0, D_excess_1, D_excess_2,
        D_excess_3, D_excess_4, D_excess_5)
