# Made by `coscrew generate`; changes are overwritten.
# SPDX-License-Identifier: MIT
# coscrew 0.2.0.  Copyright (c) 2026 The coscrew authors.
"""Exponentials and logarithms of rotations and displacements, their Jacobians, interpolation.

In single precision, accurate tier.
"""

from coscrew import _elementary_double as elementary
from numpy import absolute, float64 as real, sqrt, where
from coscrew._kernel import wide_kernel as kernel


@kernel("(3)->(3,3)")
def SO3_exp(v):
    """R = exp v~ = I + sin θ/θ v~ + (1 - cos θ)/θ^2 v~^2, θ = |v|.

    (3)->(3,3).  v: vector; R: rotation or other 3×3 matrix.
    55 mul, 48 add, 1 div, 1 sqrt, 4 abs, 5 less, 6 select.  Error <= R: 1 u of its largest
    component for |v| <= 1e13, in single precision 1e5; searched, not proved.  Each component is
    within 1 ulp as long as its condition is below 1e13; in single precision it is the nearest
    number, except near ties, as long as that is below 1e5; searched, not proved.
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
    s = where(4.611686018427388e+18 < h_largest2, real(2.710505431213761e-20), real(1))
    reduced_0 = halved_0 * s
    reduced_1 = halved_1 * s
    reduced_2 = halved_2 * s
    up = where(s < 1, real(3.6893488147419103e+19), real(1))
    reduced_length = sqrt(reduced_0 * reduced_0 + reduced_1 * reduced_1 + reduced_2 * reduced_2)
    half_angle = reduced_length * up
    y = half_angle * half_angle
    sine, c = elementary.sincos(half_angle)
    sinc_divisor_a = half_angle < 1.4901161193847656e-08
    sinc_divisor = where(sinc_divisor_a, 1.4901161193847656e-08, half_angle)
    sinc_quotient = sine / sinc_divisor
    sinc = where(sinc_divisor_a, 1 - 0.16666666666666666 * y, sinc_quotient)
    turning_0 = v_0 * sinc
    turning_1 = v_1 * sinc
    turning_2 = v_2 * sinc
    beta_v_0 = 0.5 * turning_0
    beta_v_1 = 0.5 * turning_1
    beta_v_2 = 0.5 * turning_2
    m_0 = turning_0 * beta_v_0
    m_1 = turning_1 * beta_v_1
    m_2 = turning_2 * beta_v_2
    m_3 = turning_1 * beta_v_0
    m_4 = turning_2 * beta_v_0
    m_5 = turning_2 * beta_v_1
    others_0 = m_1 + m_2
    others_1 = m_0 + m_2
    others_2 = m_0 + m_1
    alpha_v_0 = c * turning_0
    alpha_v_1 = c * turning_1
    alpha_v_2 = c * turning_2
    R_00 = 1 - others_0
    R_01 = m_3 - alpha_v_2
    R_02 = m_4 + alpha_v_1
    R_10 = m_3 + alpha_v_2
    R_11 = 1 - others_1
    R_12 = m_5 - alpha_v_0
    R_20 = m_4 - alpha_v_1
    R_21 = m_5 + alpha_v_0
    R_22 = 1 - others_2
    return (R_00, R_01, R_02, R_10, R_11, R_12, R_20, R_21, R_22)


@kernel("(3,3)->(3)")
def SO3_log(R):
    """vo with exp vo~ = R, |vo| <= π; if R is not quite a rotation, its defect carries over to vo.

    (3,3)->(3).  R: rotation or other 3×3 matrix; vo: vector.
    40 mul, 51 add, 2 div, 1 sqrt, 6 neg, 5 abs, 2 copysign, 18 less, 2 equal, 39 select.  Error
    <= vo: 1 u of its largest component for R a rotation; searched, not proved.  Each component
    is within 1 ulp as long as its condition is below 1e13; in single precision it is the
    nearest number, except near ties, as long as that is below 1e5; searched, not proved.
    """
    R_00, R_01, R_02, R_10, R_11, R_12, R_20, R_21, R_22 = R
    p_0 = R_21 - R_12
    p_1 = R_02 - R_20
    p_2 = R_10 - R_01
    s_0 = R_12 + R_21
    s_1 = R_02 + R_20
    s_2 = R_01 + R_10
    first_0 = R_00 + 1
    first_1 = 1 - R_00
    others_0 = R_11 + R_22
    others_1 = R_11 - R_22
    d_0 = first_0 + others_0
    d_1 = first_0 - others_0
    d_2 = first_1 + others_1
    d_3 = first_1 - others_1
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
    v_s_d = where(v_s_largest2 < 256, 1.8014398509481984e+16,
        where(4.611686018427388e+18 < v_s_largest2, real(2.710505431213761e-20), real(1)))
    v_s = where(v_s_largest2 < 1.4210854715202004e-14, 3.2451855365842673e+32, v_s_d)
    v_y_0 = upper_0 * v_s
    v_y_1 = upper_1 * v_s
    v_y_2 = upper_2 * v_s
    v_n = sqrt(v_y_0 * v_y_0 + v_y_1 * v_y_1 + v_y_2 * v_y_2)
    v_r_d = where(1 < v_s, 5.551115123125783e-17, where(v_s < 1, real(3.6893488147419103e+19),
        real(1)))
    v_r = where(1.8014398509481984e+16 < v_s, 3.0814879110195774e-33, v_r_d)
    n = v_n * v_r
    half = elementary.atan2(n, upper_3)
    divisor = where(n == 0, 1, n)
    theta = 2 * half
    k = theta / divisor
    vector_0 = upper_0 * k
    vector_1 = upper_1 * k
    vector_2 = upper_2 * k
    return (vector_0, vector_1, vector_2)


@kernel("(3)->(3,3)")
def SO3_leftJacobian(v):
    """R = J_l(v) = I + (1 - cos θ)/θ^2 v~ + (θ - sin θ)/θ^3 v~^2, θ = |v|.

    (3)->(3,3).  v: vector; R: rotation or other 3×3 matrix.
    65 mul, 66 add, 2 div, 1 sqrt, 1 abs, 5 less, 7 select.  Error <= R: 1 u of its largest
    component for |v| <= 1e13, in single precision 1e5; searched, not proved.  Each component is
    within 1 ulp as long as its condition is below 1e13; in single precision it is the nearest
    number, except near ties, as long as that is below 1e5; searched, not proved.
    """
    v_0, v_1, v_2 = v
    halved_0 = 0.5 * v_0
    halved_1 = 0.5 * v_1
    halved_2 = 0.5 * v_2
    y = halved_0 * halved_0 + halved_1 * halved_1 + halved_2 * halved_2
    half_angle = sqrt(y)
    sine, c = elementary.sincos(half_angle)
    sinc_divisor_a = half_angle < 1.4901161193847656e-08
    sinc_divisor = where(sinc_divisor_a, 1.4901161193847656e-08, half_angle)
    sinc_quotient = sine / sinc_divisor
    sinc = where(sinc_divisor_a, 1 - 0.16666666666666666 * y, sinc_quotient)
    g1 = c * sinc
    g2 = 0.5 * (sinc * sinc)
    rest3 = 1 - g1
    x = 4 * y
    far_x_a = x < 1
    far_x = where(far_x_a, 1, x)
    closed3 = rest3 / far_x
    series5g = (x
        * (x * (x * (1.1309962886447716e-31 - 1.216125041553518e-34 * x) - 9.183689863795546e-29)
        + 6.446950284384474e-26))
    series5o = (x
        * (x
        * (x * (x * (series5g - 3.868170170630684e-23) + 1.9572941063391263e-20)
        - 8.22063524662433e-18) + 2.8114572543455206e-15))
    series5w = (x
        * (x
        * (x * (x * (series5o - 7.647163731819816e-13) + 1.6059043836821613e-10)
        - 2.505210838544172e-08) + 2.7557319223985893e-06))
    series5 = x * (series5w - 0.0001984126984126984) + 0.008333333333333333
    g3 = where(far_x_a, 0.16666666666666666 - x * series5, closed3)
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
    return (diagonal0, R_01, R_02, R_10, diagonal1, R_12, R_20, R_21, diagonal2)


@kernel("(3)->(3,3)")
def SO3_rightJacobian(v):
    """R = J_r(v) = I - (1 - cos θ)/θ^2 v~ + (θ - sin θ)/θ^3 v~^2, θ = |v|.

    (3)->(3,3).  v: vector; R: rotation or other 3×3 matrix.
    65 mul, 66 add, 2 div, 1 sqrt, 3 neg, 1 abs, 5 less, 7 select.  Error <= R: 1 u of its
    largest component for |v| <= 1e13, in single precision 1e5; searched, not proved.  Each
    component is within 1 ulp as long as its condition is below 1e13; in single precision it is
    the nearest number, except near ties, as long as that is below 1e5; searched, not proved.
    """
    v_0, v_1, v_2 = v
    halved_0 = 0.5 * v_0
    halved_1 = 0.5 * v_1
    halved_2 = 0.5 * v_2
    y = halved_0 * halved_0 + halved_1 * halved_1 + halved_2 * halved_2
    half_angle = sqrt(y)
    sine, c = elementary.sincos(half_angle)
    sinc_divisor_a = half_angle < 1.4901161193847656e-08
    sinc_divisor = where(sinc_divisor_a, 1.4901161193847656e-08, half_angle)
    sinc_quotient = sine / sinc_divisor
    sinc = where(sinc_divisor_a, 1 - 0.16666666666666666 * y, sinc_quotient)
    g1 = c * sinc
    g2 = 0.5 * (sinc * sinc)
    rest3 = 1 - g1
    x = 4 * y
    far_x_a = x < 1
    far_x = where(far_x_a, 1, x)
    closed3 = rest3 / far_x
    series5g = (x
        * (x * (x * (1.1309962886447716e-31 - 1.216125041553518e-34 * x) - 9.183689863795546e-29)
        + 6.446950284384474e-26))
    series5o = (x
        * (x
        * (x * (x * (series5g - 3.868170170630684e-23) + 1.9572941063391263e-20)
        - 8.22063524662433e-18) + 2.8114572543455206e-15))
    series5w = (x
        * (x
        * (x * (x * (series5o - 7.647163731819816e-13) + 1.6059043836821613e-10)
        - 2.505210838544172e-08) + 2.7557319223985893e-06))
    series5 = x * (series5w - 0.0001984126984126984) + 0.008333333333333333
    g3 = where(far_x_a, 0.16666666666666666 - x * series5, closed3)
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
    return (diagonal0, R_01, R_02, R_10, diagonal1, R_12, R_20, R_21, diagonal2)


@kernel("(3)->(3,3)")
def SO3_leftJacobianInverse(v):
    """R = J_l(v)^-1 = I - v~/2 + (1 - θ/2 cot θ/2)/θ^2 v~^2, θ = |v|; singular at multiples of 2π
    except 0.

    (3)->(3,3).  v: vector; R: rotation or other 3×3 matrix.
    63 mul, 66 add, 4 div, 1 sqrt, 3 neg, 1 abs, 5 less, 7 select.  Error <= R: 1 u of its
    largest component for |v| <= π; searched, not proved.  Each component is within 1 ulp as
    long as its condition is below 1e13; in single precision it is the nearest number, except
    near ties, as long as that is below 1e5; searched, not proved.
    """
    v_0, v_1, v_2 = v
    halved_0 = 0.5 * v_0
    halved_1 = 0.5 * v_1
    halved_2 = 0.5 * v_2
    y = halved_0 * halved_0 + halved_1 * halved_1 + halved_2 * halved_2
    half_angle = sqrt(y)
    sine, c = elementary.sincos(half_angle)
    sinc_divisor_a = half_angle < 1.4901161193847656e-08
    sinc_divisor = where(sinc_divisor_a, 1.4901161193847656e-08, half_angle)
    sinc_quotient = sine / sinc_divisor
    sinc = where(sinc_divisor_a, 1 - 0.16666666666666666 * y, sinc_quotient)
    series_phi_g = (y
        * (y * (y * (4.116826490666969e-29 - 5.107725174524775e-32 * y) - 2.86531123750421e-26)
        + 1.701994875077501e-23))
    series_phi_o = (y
        * (y
        * (y * (y * (series_phi_g - 8.509974375387505e-21) + 3.523129391410427e-18)
        - 1.1837714755139035e-15) + 3.148832124866983e-13))
    series_phi_w = (y
        * (y
        * (y * (y * (series_phi_o - 6.423617534728645e-11) + 9.635426302092969e-09)
        - 1.0020843354176687e-06) + 6.613756613756614e-05))
    series_phi = y * (series_phi_w - 0.002380952380952381) + 0.03333333333333333
    f_more = 2 * y * series_phi
    near_f = 0.3333333333333333 * sinc + 0.3333333333333333 * f_more
    f_rest = sinc - c
    x = 4 * y
    far_y_a = x < 4
    far_y = where(far_y_a, 1, y)
    closed_f = f_rest / far_y
    f = where(far_y_a, near_f, closed_f)
    four_k = 4 * sinc
    b = f / four_k
    b_across = c / sinc
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
    alpha_v_0 = -halved_0
    alpha_v_1 = -halved_1
    alpha_v_2 = -halved_2
    R_01 = m_3 - alpha_v_2
    R_02 = m_4 + alpha_v_1
    R_10 = m_3 + alpha_v_2
    R_12 = m_5 - alpha_v_0
    R_20 = m_4 - alpha_v_1
    R_21 = m_5 + alpha_v_0
    return (diagonal0, R_01, R_02, R_10, diagonal1, R_12, R_20, R_21, diagonal2)


@kernel("(3)->(3,3)")
def SO3_rightJacobianInverse(v):
    """R = J_r(v)^-1 = I + v~/2 + (1 - θ/2 cot θ/2)/θ^2 v~^2, θ = |v|; singular at multiples of 2π
    except 0.

    (3)->(3,3).  v: vector; R: rotation or other 3×3 matrix.
    63 mul, 66 add, 4 div, 1 sqrt, 1 abs, 5 less, 7 select.  Error <= R: 1 u of its largest
    component for |v| <= π; searched, not proved.  Each component is within 1 ulp as long as its
    condition is below 1e13; in single precision it is the nearest number, except near ties, as
    long as that is below 1e5; searched, not proved.
    """
    v_0, v_1, v_2 = v
    halved_0 = 0.5 * v_0
    halved_1 = 0.5 * v_1
    halved_2 = 0.5 * v_2
    y = halved_0 * halved_0 + halved_1 * halved_1 + halved_2 * halved_2
    half_angle = sqrt(y)
    sine, c = elementary.sincos(half_angle)
    sinc_divisor_a = half_angle < 1.4901161193847656e-08
    sinc_divisor = where(sinc_divisor_a, 1.4901161193847656e-08, half_angle)
    sinc_quotient = sine / sinc_divisor
    sinc = where(sinc_divisor_a, 1 - 0.16666666666666666 * y, sinc_quotient)
    series_phi_g = (y
        * (y * (y * (4.116826490666969e-29 - 5.107725174524775e-32 * y) - 2.86531123750421e-26)
        + 1.701994875077501e-23))
    series_phi_o = (y
        * (y
        * (y * (y * (series_phi_g - 8.509974375387505e-21) + 3.523129391410427e-18)
        - 1.1837714755139035e-15) + 3.148832124866983e-13))
    series_phi_w = (y
        * (y
        * (y * (y * (series_phi_o - 6.423617534728645e-11) + 9.635426302092969e-09)
        - 1.0020843354176687e-06) + 6.613756613756614e-05))
    series_phi = y * (series_phi_w - 0.002380952380952381) + 0.03333333333333333
    f_more = 2 * y * series_phi
    near_f = 0.3333333333333333 * sinc + 0.3333333333333333 * f_more
    f_rest = sinc - c
    x = 4 * y
    far_y_a = x < 4
    far_y = where(far_y_a, 1, y)
    closed_f = f_rest / far_y
    f = where(far_y_a, near_f, closed_f)
    four_k = 4 * sinc
    b = f / four_k
    b_across = c / sinc
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
    R_01 = m_3 - halved_2
    R_02 = halved_1 + m_4
    R_10 = halved_2 + m_3
    R_12 = m_5 - halved_0
    R_20 = m_4 - halved_1
    R_21 = halved_0 + m_5
    return (diagonal0, R_01, R_02, R_10, diagonal1, R_12, R_20, R_21, diagonal2)


@kernel("(3,3)->(3,3)")
def mat3x3_orthonormalize(self):
    """self = R + R (I - R^T R)/2, closer to a rotation: a defect d of R becomes 3/4 d^2.

    (3,3)->(3,3).  self: rotation or other 3×3 matrix.
    51 mul, 42 add, 3 neg.  Error <= u |result| + 1/4 u^2 S, S the sum of the |terms| of the
    expanded formula; barring over- and underflow.
    """
    self_00, self_01, self_02, self_10, self_11, self_12, self_20, self_21, self_22 = self
    defect_0 = 1 - self_00 * self_00 - self_10 * self_10 - self_20 * self_20
    defect_1 = 1 - self_01 * self_01 - self_11 * self_11 - self_21 * self_21
    defect_2 = 1 - self_02 * self_02 - self_12 * self_12 - self_22 * self_22
    defect_3 = -(self_00 * self_01) - self_10 * self_11 - self_20 * self_21
    defect_4 = -(self_00 * self_02) - self_10 * self_12 - self_20 * self_22
    defect_5 = -(self_01 * self_02) - self_11 * self_12 - self_21 * self_22
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
    return (self_00_new, self_01_new, self_02_new, self_10_new, self_11_new, self_12_new,
        self_20_new, self_21_new, self_22_new)


@kernel("(3,3)->(3,3)")
def mat3x3_orthonormalized(R):
    """Ro = R + R (I - R^T R)/2, closer to a rotation: a defect d of R becomes 3/4 d^2.

    (3,3)->(3,3).  R, Ro: rotation or other 3×3 matrix.
    51 mul, 42 add, 3 neg.  Error <= u |result| + 1/4 u^2 S, S the sum of the |terms| of the
    expanded formula; barring over- and underflow.
    """
    R_00, R_01, R_02, R_10, R_11, R_12, R_20, R_21, R_22 = R
    defect_0 = 1 - R_00 * R_00 - R_10 * R_10 - R_20 * R_20
    defect_1 = 1 - R_01 * R_01 - R_11 * R_11 - R_21 * R_21
    defect_2 = 1 - R_02 * R_02 - R_12 * R_12 - R_22 * R_22
    defect_3 = -(R_00 * R_01) - R_10 * R_11 - R_20 * R_21
    defect_4 = -(R_00 * R_02) - R_10 * R_12 - R_20 * R_22
    defect_5 = -(R_01 * R_02) - R_11 * R_12 - R_21 * R_22
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
    return (Ro_00, Ro_01, Ro_02, Ro_10, Ro_11, Ro_12, Ro_20, Ro_21, Ro_22)


@kernel("(6)->(3,4)")
def SE3_exp(s):
    """D = exp s = [exp ω~ | J_l(ω) v].

    (6)->(3,4).  s: screw (v in m/s; ω in rad/s); D: displacement [R | t], R rotation, t in m.
    86 mul, 78 add, 2 div, 1 sqrt, 1 abs, 5 less, 7 select.  Error <= R: 1 u, t: 1 u of its
    largest component, or of s.lin if that is larger, for |ω of s| <= 1e13, in single precision
    1e5; searched, not proved.  Each component is within 1 ulp as long as its condition is below
    1e13; in single precision it is the nearest number, except near ties, as long as that is
    below 1e5; searched, not proved.  Intermediate sums may overflow where |v|, or |ω| |v|, is
    above 2e306, in single precision 5e36.
    """
    s_0, s_1, s_2, s_3, s_4, s_5 = s
    halved_0 = 0.5 * s_3
    halved_1 = 0.5 * s_4
    halved_2 = 0.5 * s_5
    y = halved_0 * halved_0 + halved_1 * halved_1 + halved_2 * halved_2
    half_angle = sqrt(y)
    sine, c = elementary.sincos(half_angle)
    sinc_divisor_a = half_angle < 1.4901161193847656e-08
    sinc_divisor = where(sinc_divisor_a, 1.4901161193847656e-08, half_angle)
    sinc_quotient = sine / sinc_divisor
    sinc = where(sinc_divisor_a, 1 - 0.16666666666666666 * y, sinc_quotient)
    g1 = c * sinc
    g2 = 0.5 * (sinc * sinc)
    sine_square = sine * sine
    g0 = 1 - 2 * sine_square
    rest3 = 1 - g1
    x = 4 * y
    far_x_a = x < 1
    far_x = where(far_x_a, 1, x)
    closed3 = rest3 / far_x
    series5g = (x
        * (x * (x * (1.1309962886447716e-31 - 1.216125041553518e-34 * x) - 9.183689863795546e-29)
        + 6.446950284384474e-26))
    series5o = (x
        * (x
        * (x * (x * (series5g - 3.868170170630684e-23) + 1.9572941063391263e-20)
        - 8.22063524662433e-18) + 2.8114572543455206e-15))
    series5w = (x
        * (x
        * (x * (x * (series5o - 7.647163731819816e-13) + 1.6059043836821613e-10)
        - 2.505210838544172e-08) + 2.7557319223985893e-06))
    series5 = x * (series5w - 0.0001984126984126984) + 0.008333333333333333
    g3 = where(far_x_a, 0.16666666666666666 - x * series5, closed3)
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
    return (diagonal0, D_01, D_02, D_03, D_10, diagonal1, D_12, D_13, D_20, D_21, diagonal2, D_23)


@kernel("(3,4)->(6)")
def SE3_log(D):
    """so with exp so = D, |ω| <= π: (J_l(ω)^-1 t; ω), ω = log R.

    (3,4)->(6).  D: displacement [R | t], R rotation, t in m; so: screw (v in m/s; ω in rad/s).
    83 mul, 79 add, 8 div, 2 sqrt, 5 neg, 6 abs, 2 copysign, 20 less, 2 equal, 42 select.  Error
    <= lin: 1 u, ang: 1 u of its largest component for R of D a rotation; searched, not proved.
    Each component is within 1 ulp as long as its condition is below 1e13; in single precision
    it is the nearest number, except near ties, as long as that is below 1e5; searched, not
    proved.  Intermediate sums may overflow where |t| is above 2e306, in single precision 5e36.
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
    upper_3 = absolute(column_3)
    v_s_size_0 = absolute(upper_0)
    v_s_size_1 = absolute(upper_1)
    v_s_size_2 = absolute(upper_2)
    v_s_largest1 = where(v_s_size_0 < v_s_size_1, v_s_size_1, v_s_size_0)
    v_s_largest2 = where(v_s_largest1 < v_s_size_2, v_s_size_2, v_s_largest1)
    v_s_d = where(v_s_largest2 < 256, 1.8014398509481984e+16,
        where(4.611686018427388e+18 < v_s_largest2, real(2.710505431213761e-20), real(1)))
    v_s = where(v_s_largest2 < 1.4210854715202004e-14, 3.2451855365842673e+32, v_s_d)
    v_y_0 = upper_0 * v_s
    v_y_1 = upper_1 * v_s
    v_y_2 = upper_2 * v_s
    v_n = sqrt(v_y_0 * v_y_0 + v_y_1 * v_y_1 + v_y_2 * v_y_2)
    v_r_d = where(1 < v_s, 5.551115123125783e-17, where(v_s < 1, real(3.6893488147419103e+19),
        real(1)))
    v_r = where(1.8014398509481984e+16 < v_s, 3.0814879110195774e-33, v_r_d)
    n = v_n * v_r
    half = elementary.atan2(n, upper_3)
    divisor = where(n == 0, 1, n)
    theta = 2 * half
    k = theta / divisor
    vector_0 = upper_0 * k
    vector_1 = upper_1 * k
    vector_2 = upper_2 * k
    half_angle = 0.5 * theta
    length = sqrt(n * n + upper_3 * upper_3)
    sine = n / length
    c = upper_3 / length
    y = half_angle * half_angle
    sinc_divisor_a = half_angle < 1.4901161193847656e-08
    sinc_divisor = where(sinc_divisor_a, 1.4901161193847656e-08, half_angle)
    sinc_quotient = sine / sinc_divisor
    sinc = where(sinc_divisor_a, 1 - 0.16666666666666666 * y, sinc_quotient)
    series_phi_g = (y
        * (y * (y * (4.116826490666969e-29 - 5.107725174524775e-32 * y) - 2.86531123750421e-26)
        + 1.701994875077501e-23))
    series_phi_o = (y
        * (y
        * (y * (y * (series_phi_g - 8.509974375387505e-21) + 3.523129391410427e-18)
        - 1.1837714755139035e-15) + 3.148832124866983e-13))
    series_phi_w = (y
        * (y
        * (y * (y * (series_phi_o - 6.423617534728645e-11) + 9.635426302092969e-09)
        - 1.0020843354176687e-06) + 6.613756613756614e-05))
    series_phi = y * (series_phi_w - 0.002380952380952381) + 0.03333333333333333
    f_more = 2 * y * series_phi
    near_f = 0.3333333333333333 * sinc + 0.3333333333333333 * f_more
    f_rest = sinc - c
    x = 4 * y
    far_y_a = x < 4
    far_y = where(far_y_a, 1, y)
    closed_f = f_rest / far_y
    f = where(far_y_a, near_f, closed_f)
    four_k = 4 * sinc
    b = f / four_k
    b_across = c / sinc
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
    return (so_0, so_1, so_2, vector_0, vector_1, vector_2)


@kernel("(6)->(6,6)")
def SE3_leftJacobian(s):
    """M = J_l(s) = Σ ([ad](s))^k / (k+1)!.

    (6)->(6,6).  s: screw (v in m/s; ω in rad/s); M: 6×6 operator.
    115 mul, 109 add, 4 div, 1 sqrt, 1 neg, 1 abs, 5 less, 9 select.  Error <= M: 1 u of its
    largest component for |ω of s| <= π; searched, not proved.  Each component is within 1 ulp
    as long as its condition is below 1e13; in single precision it is the nearest number, except
    near ties, as long as that is below 1e5; searched, not proved.  Intermediate sums may
    overflow where |v| is above 2e306, in single precision 5e36.
    """
    s_0, s_1, s_2, s_3, s_4, s_5 = s
    halved_0 = 0.5 * s_3
    halved_1 = 0.5 * s_4
    halved_2 = 0.5 * s_5
    y = halved_0 * halved_0 + halved_1 * halved_1 + halved_2 * halved_2
    half_angle = sqrt(y)
    sine, c = elementary.sincos(half_angle)
    sinc_divisor_a = half_angle < 1.4901161193847656e-08
    sinc_divisor = where(sinc_divisor_a, 1.4901161193847656e-08, half_angle)
    sinc_quotient = sine / sinc_divisor
    sinc = where(sinc_divisor_a, 1 - 0.16666666666666666 * y, sinc_quotient)
    g1 = c * sinc
    g2 = 0.5 * (sinc * sinc)
    rest3 = 1 - g1
    x = 4 * y
    far_x_a = x < 1
    far_x = where(far_x_a, 1, x)
    closed3 = rest3 / far_x
    series5g = (x
        * (x * (x * (1.1309962886447716e-31 - 1.216125041553518e-34 * x) - 9.183689863795546e-29)
        + 6.446950284384474e-26))
    series5o = (x
        * (x
        * (x * (x * (series5g - 3.868170170630684e-23) + 1.9572941063391263e-20)
        - 8.22063524662433e-18) + 2.8114572543455206e-15))
    series5w = (x
        * (x
        * (x * (x * (series5o - 7.647163731819816e-13) + 1.6059043836821613e-10)
        - 2.505210838544172e-08) + 2.7557319223985893e-06))
    series5 = x * (series5w - 0.0001984126984126984) + 0.008333333333333333
    g3 = where(far_x_a, 0.16666666666666666 - x * series5, closed3)
    rest4 = 0.5 - g2
    closed4 = rest4 / far_x
    rest5 = 0.16666666666666666 - g3
    closed5 = rest5 / far_x
    series4g = (x
        * (x * (x * (3.279889237069838e-30 - 3.7699876288159054e-33 * x) - 2.4795962632247976e-27)
        + 1.6117375710961184e-24))
    series4o = (x
        * (x
        * (x * (x * (series4g - 8.896791392450574e-22) + 4.110317623312165e-19)
        - 1.5619206968586225e-16) + 4.779477332387385e-14))
    series4w = (x
        * (x
        * (x * (x * (series4o - 1.1470745597729725e-11) + 2.08767569878681e-09)
        - 2.755731922398589e-07) + 2.48015873015873e-05))
    series4 = x * (series4w - 0.001388888888888889) + 0.041666666666666664
    g4 = where(far_x_a, series4, closed4)
    g5 = where(far_x_a, series5, closed5)
    rate2 = 2 * g4 - g3
    rate3 = 3 * g5 - g4
    beta_v_0 = s_3 * g3
    beta_v_1 = s_4 * g3
    beta_v_2 = s_5 * g3
    m_0 = s_3 * beta_v_0
    m_1 = s_4 * beta_v_1
    m_2 = s_5 * beta_v_2
    m_3 = s_4 * beta_v_0
    m_4 = s_5 * beta_v_0
    m_5 = s_5 * beta_v_1
    others_0 = m_1 + m_2
    others_1 = m_0 + m_2
    others_2 = m_0 + m_1
    diagonal0 = where(m_0 < others_0, g1 + m_0, 1 - others_0)
    diagonal1 = where(m_1 < others_1, g1 + m_1, 1 - others_1)
    diagonal2 = where(m_2 < others_2, g1 + m_2, 1 - others_2)
    alpha_v_0 = s_3 * g2
    alpha_v_1 = s_4 * g2
    alpha_v_2 = s_5 * g2
    J_1 = m_3 - alpha_v_2
    J_2 = m_4 + alpha_v_1
    J_3 = m_3 + alpha_v_2
    J_5 = m_5 - alpha_v_0
    J_6 = m_4 - alpha_v_1
    J_7 = m_5 + alpha_v_0
    rate_vw = s_0 * s_3 + s_1 * s_4 + s_2 * s_5
    rate_turn = rate2 * rate_vw
    rate_bend = -(rate3 * rate_vw)
    rate_q_0 = s_0 * g2 + s_3 * rate_turn
    rate_q_1 = s_1 * g2 + s_4 * rate_turn
    rate_q_2 = s_2 * g2 + s_5 * rate_turn
    rate_beta_v_0 = s_0 * g3
    rate_beta_v_1 = s_1 * g3
    rate_beta_v_2 = s_2 * g3
    rate_bend_w_0 = s_3 * rate_bend
    rate_bend_w_1 = s_4 * rate_bend
    rate_bend_w_2 = s_5 * rate_bend
    rate_symmetric_0 = s_3 * rate_beta_v_1 + s_4 * rate_beta_v_0 - s_4 * rate_bend_w_0
    rate_symmetric_1 = s_3 * rate_beta_v_2 + s_5 * rate_beta_v_0 - s_5 * rate_bend_w_0
    rate_symmetric_2 = s_4 * rate_beta_v_2 + s_5 * rate_beta_v_1 - s_5 * rate_bend_w_1
    rate_diagonal_0a = s_4 * rate_bend_w_1
    rate_diagonal_0b = s_5 * rate_bend_w_2
    rate_diagonal_0e = 2 * s_4 * rate_beta_v_1
    rate_diagonal_0g = 2 * s_5 * rate_beta_v_2
    rate_diagonal_0 = rate_diagonal_0a + rate_diagonal_0b - (rate_diagonal_0e + rate_diagonal_0g)
    rate_diagonal_1a = s_3 * rate_bend_w_0
    rate_diagonal_1d = 2 * s_3 * rate_beta_v_0
    rate_diagonal_1 = rate_diagonal_1a + rate_diagonal_0b - (rate_diagonal_1d + rate_diagonal_0g)
    rate_diagonal_2 = rate_diagonal_1a + rate_diagonal_0a - (rate_diagonal_1d + rate_diagonal_0e)
    M_04 = rate_symmetric_0 - rate_q_2
    M_05 = rate_q_1 + rate_symmetric_1
    M_13 = rate_q_2 + rate_symmetric_0
    M_15 = rate_symmetric_2 - rate_q_0
    M_23 = rate_symmetric_1 - rate_q_1
    M_24 = rate_q_0 + rate_symmetric_2
    return (diagonal0, J_1, J_2, rate_diagonal_0, M_04, M_05, J_3, diagonal1, J_5, M_13,
        rate_diagonal_1, M_15, J_6, J_7, diagonal2, M_23, M_24, rate_diagonal_2, 0, 0, 0, diagonal0,
        J_1, J_2, 0, 0, 0, J_3, diagonal1, J_5, 0, 0, 0, J_6, J_7, diagonal2)


@kernel("(6)->(6,6)")
def SE3_rightJacobian(s):
    """M = J_r(s) = Σ (-[ad](s))^k / (k+1)!.

    (6)->(6,6).  s: screw (v in m/s; ω in rad/s); M: 6×6 operator.
    115 mul, 109 add, 4 div, 1 sqrt, 16 neg, 1 abs, 5 less, 9 select.  Error <= M: 1 u of its
    largest component for |ω of s| <= π; searched, not proved.  Each component is within 1 ulp
    as long as its condition is below 1e13; in single precision it is the nearest number, except
    near ties, as long as that is below 1e5; searched, not proved.  Intermediate sums may
    overflow where |v| is above 2e306, in single precision 5e36.
    """
    s_0, s_1, s_2, s_3, s_4, s_5 = s
    halved_0 = 0.5 * s_3
    halved_1 = 0.5 * s_4
    halved_2 = 0.5 * s_5
    y = halved_0 * halved_0 + halved_1 * halved_1 + halved_2 * halved_2
    half_angle = sqrt(y)
    sine, c = elementary.sincos(half_angle)
    sinc_divisor_a = half_angle < 1.4901161193847656e-08
    sinc_divisor = where(sinc_divisor_a, 1.4901161193847656e-08, half_angle)
    sinc_quotient = sine / sinc_divisor
    sinc = where(sinc_divisor_a, 1 - 0.16666666666666666 * y, sinc_quotient)
    g1 = c * sinc
    g2 = 0.5 * (sinc * sinc)
    rest3 = 1 - g1
    x = 4 * y
    far_x_a = x < 1
    far_x = where(far_x_a, 1, x)
    closed3 = rest3 / far_x
    series5g = (x
        * (x * (x * (1.1309962886447716e-31 - 1.216125041553518e-34 * x) - 9.183689863795546e-29)
        + 6.446950284384474e-26))
    series5o = (x
        * (x
        * (x * (x * (series5g - 3.868170170630684e-23) + 1.9572941063391263e-20)
        - 8.22063524662433e-18) + 2.8114572543455206e-15))
    series5w = (x
        * (x
        * (x * (x * (series5o - 7.647163731819816e-13) + 1.6059043836821613e-10)
        - 2.505210838544172e-08) + 2.7557319223985893e-06))
    series5 = x * (series5w - 0.0001984126984126984) + 0.008333333333333333
    g3 = where(far_x_a, 0.16666666666666666 - x * series5, closed3)
    rest4 = 0.5 - g2
    closed4 = rest4 / far_x
    rest5 = 0.16666666666666666 - g3
    closed5 = rest5 / far_x
    series4g = (x
        * (x * (x * (3.279889237069838e-30 - 3.7699876288159054e-33 * x) - 2.4795962632247976e-27)
        + 1.6117375710961184e-24))
    series4o = (x
        * (x
        * (x * (x * (series4g - 8.896791392450574e-22) + 4.110317623312165e-19)
        - 1.5619206968586225e-16) + 4.779477332387385e-14))
    series4w = (x
        * (x
        * (x * (x * (series4o - 1.1470745597729725e-11) + 2.08767569878681e-09)
        - 2.755731922398589e-07) + 2.48015873015873e-05))
    series4 = x * (series4w - 0.001388888888888889) + 0.041666666666666664
    g4 = where(far_x_a, series4, closed4)
    g5 = where(far_x_a, series5, closed5)
    rate2 = 2 * g4 - g3
    rate3 = 3 * g5 - g4
    beta_v_0 = s_3 * g3
    beta_v_1 = s_4 * g3
    beta_v_2 = s_5 * g3
    m_0 = s_3 * beta_v_0
    m_1 = s_4 * beta_v_1
    m_2 = s_5 * beta_v_2
    m_3 = s_4 * beta_v_0
    m_4 = s_5 * beta_v_0
    m_5 = s_5 * beta_v_1
    others_0 = m_1 + m_2
    others_1 = m_0 + m_2
    others_2 = m_0 + m_1
    diagonal0 = where(m_0 < others_0, g1 + m_0, 1 - others_0)
    diagonal1 = where(m_1 < others_1, g1 + m_1, 1 - others_1)
    diagonal2 = where(m_2 < others_2, g1 + m_2, 1 - others_2)
    alpha_v_0 = -(s_3 * g2)
    alpha_v_1 = -(s_4 * g2)
    alpha_v_2 = -(s_5 * g2)
    J_1 = m_3 - alpha_v_2
    J_2 = m_4 + alpha_v_1
    J_3 = m_3 + alpha_v_2
    J_5 = m_5 - alpha_v_0
    J_6 = m_4 - alpha_v_1
    J_7 = m_5 + alpha_v_0
    rate_vw = s_0 * s_3 + s_1 * s_4 + s_2 * s_5
    rate_turn = rate2 * rate_vw
    rate_bend = -(rate3 * rate_vw)
    rate_q_0 = -(s_0 * g2) - s_3 * rate_turn
    rate_q_1 = -(s_1 * g2) - s_4 * rate_turn
    rate_q_2 = -(s_2 * g2) - s_5 * rate_turn
    rate_beta_v_0 = -(s_0 * g3)
    rate_beta_v_1 = -(s_1 * g3)
    rate_beta_v_2 = -(s_2 * g3)
    rate_bend_w_0 = -(s_3 * rate_bend)
    rate_bend_w_1 = -(s_4 * rate_bend)
    rate_bend_w_2 = -(s_5 * rate_bend)
    rate_symmetric_0 = -(s_3 * rate_beta_v_1) - s_4 * rate_beta_v_0 + s_4 * rate_bend_w_0
    rate_symmetric_1 = -(s_3 * rate_beta_v_2) - s_5 * rate_beta_v_0 + s_5 * rate_bend_w_0
    rate_symmetric_2 = -(s_4 * rate_beta_v_2) - s_5 * rate_beta_v_1 + s_5 * rate_bend_w_1
    rate_diagonal_0b = 2 * s_4 * rate_beta_v_1
    rate_diagonal_0d = 2 * s_5 * rate_beta_v_2
    rate_diagonal_0f = s_4 * rate_bend_w_1
    rate_diagonal_0g = s_5 * rate_bend_w_2
    rate_diagonal_0 = rate_diagonal_0b + rate_diagonal_0d - (rate_diagonal_0f + rate_diagonal_0g)
    rate_diagonal_1b = 2 * s_3 * rate_beta_v_0
    rate_diagonal_1d = s_3 * rate_bend_w_0
    rate_diagonal_1 = rate_diagonal_1b + rate_diagonal_0d - (rate_diagonal_1d + rate_diagonal_0g)
    rate_diagonal_2 = rate_diagonal_1b + rate_diagonal_0b - (rate_diagonal_1d + rate_diagonal_0f)
    M_04 = rate_symmetric_0 - rate_q_2
    M_05 = rate_q_1 + rate_symmetric_1
    M_13 = rate_q_2 + rate_symmetric_0
    M_15 = rate_symmetric_2 - rate_q_0
    M_23 = rate_symmetric_1 - rate_q_1
    M_24 = rate_q_0 + rate_symmetric_2
    return (diagonal0, J_1, J_2, rate_diagonal_0, M_04, M_05, J_3, diagonal1, J_5, M_13,
        rate_diagonal_1, M_15, J_6, J_7, diagonal2, M_23, M_24, rate_diagonal_2, 0, 0, 0, diagonal0,
        J_1, J_2, 0, 0, 0, J_3, diagonal1, J_5, 0, 0, 0, J_6, J_7, diagonal2)


@kernel("(6)->(6,6)")
def SE3_leftJacobianInverse(s):
    """M = J_l(s)^-1; singular where |ω| is a multiple of 2π except 0.

    (6)->(6,6).  s: screw (v in m/s; ω in rad/s); M: 6×6 operator.
    101 mul, 91 add, 6 div, 1 sqrt, 7 neg, 1 abs, 5 less, 8 select.  Error <= M: 1 u of its
    largest component for |ω of s| <= π; searched, not proved.  Each component is within 1 ulp
    as long as its condition is below 1e13; in single precision it is the nearest number, except
    near ties, as long as that is below 1e5; searched, not proved.  Intermediate sums may
    overflow where |v| is above 2e306, in single precision 5e36.
    """
    s_0, s_1, s_2, s_3, s_4, s_5 = s
    halved_0 = 0.5 * s_3
    halved_1 = 0.5 * s_4
    halved_2 = 0.5 * s_5
    y = halved_0 * halved_0 + halved_1 * halved_1 + halved_2 * halved_2
    half_angle = sqrt(y)
    sine, c = elementary.sincos(half_angle)
    sinc_divisor_a = half_angle < 1.4901161193847656e-08
    sinc_divisor = where(sinc_divisor_a, 1.4901161193847656e-08, half_angle)
    sinc_quotient = sine / sinc_divisor
    sinc = where(sinc_divisor_a, 1 - 0.16666666666666666 * y, sinc_quotient)
    series_phi_g = (y
        * (y * (y * (4.116826490666969e-29 - 5.107725174524775e-32 * y) - 2.86531123750421e-26)
        + 1.701994875077501e-23))
    series_phi_o = (y
        * (y
        * (y * (y * (series_phi_g - 8.509974375387505e-21) + 3.523129391410427e-18)
        - 1.1837714755139035e-15) + 3.148832124866983e-13))
    series_phi_w = (y
        * (y
        * (y * (y * (series_phi_o - 6.423617534728645e-11) + 9.635426302092969e-09)
        - 1.0020843354176687e-06) + 6.613756613756614e-05))
    series_phi = y * (series_phi_w - 0.002380952380952381) + 0.03333333333333333
    f_more = 2 * y * series_phi
    near_f = 0.3333333333333333 * sinc + 0.3333333333333333 * f_more
    f_rest = sinc - c
    x = 4 * y
    far_y_a = x < 4
    far_y = where(far_y_a, 1, y)
    closed_f = f_rest / far_y
    f = where(far_y_a, near_f, closed_f)
    four_k = 4 * sinc
    b = f / four_k
    b_across = c / sinc
    beta_v_0 = s_3 * b
    beta_v_1 = s_4 * b
    beta_v_2 = s_5 * b
    m_0 = s_3 * beta_v_0
    m_1 = s_4 * beta_v_1
    m_2 = s_5 * beta_v_2
    m_3 = s_4 * beta_v_0
    m_4 = s_5 * beta_v_0
    m_5 = s_5 * beta_v_1
    others_0 = m_1 + m_2
    others_1 = m_0 + m_2
    others_2 = m_0 + m_1
    diagonal0 = where(m_0 < others_0, b_across + m_0, 1 - others_0)
    diagonal1 = where(m_1 < others_1, b_across + m_1, 1 - others_1)
    diagonal2 = where(m_2 < others_2, b_across + m_2, 1 - others_2)
    alpha_v_0 = -halved_0
    alpha_v_1 = -halved_1
    alpha_v_2 = -halved_2
    J_1 = m_3 - alpha_v_2
    J_2 = m_4 + alpha_v_1
    J_3 = m_3 + alpha_v_2
    J_5 = m_5 - alpha_v_0
    J_6 = m_4 - alpha_v_1
    J_7 = m_5 + alpha_v_0
    phi_rest = 3 * f - sinc
    twice_y = 2 * far_y
    closed_phi = phi_rest / twice_y
    phi = where(far_y_a, series_phi, closed_phi)
    b_rate_above = 0.5 * (f * f) - sinc * phi
    b_rate_below = 8 * (sinc * sinc)
    b_rate = b_rate_above / b_rate_below
    rate_vw = s_0 * s_3 + s_1 * s_4 + s_2 * s_5
    rate_bend = -(b_rate * rate_vw)
    rate_q_0 = -(0.5 * s_0)
    rate_q_1 = -(0.5 * s_1)
    rate_q_2 = -(0.5 * s_2)
    rate_beta_v_0 = s_0 * b
    rate_beta_v_1 = s_1 * b
    rate_beta_v_2 = s_2 * b
    rate_bend_w_0 = s_3 * rate_bend
    rate_bend_w_1 = s_4 * rate_bend
    rate_bend_w_2 = s_5 * rate_bend
    rate_symmetric_0 = s_3 * rate_beta_v_1 + s_4 * rate_beta_v_0 - s_4 * rate_bend_w_0
    rate_symmetric_1 = s_3 * rate_beta_v_2 + s_5 * rate_beta_v_0 - s_5 * rate_bend_w_0
    rate_symmetric_2 = s_4 * rate_beta_v_2 + s_5 * rate_beta_v_1 - s_5 * rate_bend_w_1
    rate_diagonal_0a = s_4 * rate_bend_w_1
    rate_diagonal_0b = s_5 * rate_bend_w_2
    rate_diagonal_0e = 2 * s_4 * rate_beta_v_1
    rate_diagonal_0g = 2 * s_5 * rate_beta_v_2
    rate_diagonal_0 = rate_diagonal_0a + rate_diagonal_0b - (rate_diagonal_0e + rate_diagonal_0g)
    rate_diagonal_1a = s_3 * rate_bend_w_0
    rate_diagonal_1d = 2 * s_3 * rate_beta_v_0
    rate_diagonal_1 = rate_diagonal_1a + rate_diagonal_0b - (rate_diagonal_1d + rate_diagonal_0g)
    rate_diagonal_2 = rate_diagonal_1a + rate_diagonal_0a - (rate_diagonal_1d + rate_diagonal_0e)
    M_04 = rate_symmetric_0 - rate_q_2
    M_05 = rate_q_1 + rate_symmetric_1
    M_13 = rate_q_2 + rate_symmetric_0
    M_15 = rate_symmetric_2 - rate_q_0
    M_23 = rate_symmetric_1 - rate_q_1
    M_24 = rate_q_0 + rate_symmetric_2
    return (diagonal0, J_1, J_2, rate_diagonal_0, M_04, M_05, J_3, diagonal1, J_5, M_13,
        rate_diagonal_1, M_15, J_6, J_7, diagonal2, M_23, M_24, rate_diagonal_2, 0, 0, 0, diagonal0,
        J_1, J_2, 0, 0, 0, J_3, diagonal1, J_5, 0, 0, 0, J_6, J_7, diagonal2)


@kernel("(6)->(6,6)")
def SE3_rightJacobianInverse(s):
    """M = J_r(s)^-1; singular where |ω| is a multiple of 2π except 0.

    (6)->(6,6).  s: screw (v in m/s; ω in rad/s); M: 6×6 operator.
    101 mul, 91 add, 6 div, 1 sqrt, 10 neg, 1 abs, 5 less, 8 select.  Error <= M: 1 u of its
    largest component for |ω of s| <= π; searched, not proved.  Each component is within 1 ulp
    as long as its condition is below 1e13; in single precision it is the nearest number, except
    near ties, as long as that is below 1e5; searched, not proved.  Intermediate sums may
    overflow where |v| is above 2e306, in single precision 5e36.
    """
    s_0, s_1, s_2, s_3, s_4, s_5 = s
    halved_0 = 0.5 * s_3
    halved_1 = 0.5 * s_4
    halved_2 = 0.5 * s_5
    y = halved_0 * halved_0 + halved_1 * halved_1 + halved_2 * halved_2
    half_angle = sqrt(y)
    sine, c = elementary.sincos(half_angle)
    sinc_divisor_a = half_angle < 1.4901161193847656e-08
    sinc_divisor = where(sinc_divisor_a, 1.4901161193847656e-08, half_angle)
    sinc_quotient = sine / sinc_divisor
    sinc = where(sinc_divisor_a, 1 - 0.16666666666666666 * y, sinc_quotient)
    series_phi_g = (y
        * (y * (y * (4.116826490666969e-29 - 5.107725174524775e-32 * y) - 2.86531123750421e-26)
        + 1.701994875077501e-23))
    series_phi_o = (y
        * (y
        * (y * (y * (series_phi_g - 8.509974375387505e-21) + 3.523129391410427e-18)
        - 1.1837714755139035e-15) + 3.148832124866983e-13))
    series_phi_w = (y
        * (y
        * (y * (y * (series_phi_o - 6.423617534728645e-11) + 9.635426302092969e-09)
        - 1.0020843354176687e-06) + 6.613756613756614e-05))
    series_phi = y * (series_phi_w - 0.002380952380952381) + 0.03333333333333333
    f_more = 2 * y * series_phi
    near_f = 0.3333333333333333 * sinc + 0.3333333333333333 * f_more
    f_rest = sinc - c
    x = 4 * y
    far_y_a = x < 4
    far_y = where(far_y_a, 1, y)
    closed_f = f_rest / far_y
    f = where(far_y_a, near_f, closed_f)
    four_k = 4 * sinc
    b = f / four_k
    b_across = c / sinc
    beta_v_0 = s_3 * b
    beta_v_1 = s_4 * b
    beta_v_2 = s_5 * b
    m_0 = s_3 * beta_v_0
    m_1 = s_4 * beta_v_1
    m_2 = s_5 * beta_v_2
    m_3 = s_4 * beta_v_0
    m_4 = s_5 * beta_v_0
    m_5 = s_5 * beta_v_1
    others_0 = m_1 + m_2
    others_1 = m_0 + m_2
    others_2 = m_0 + m_1
    diagonal0 = where(m_0 < others_0, b_across + m_0, 1 - others_0)
    diagonal1 = where(m_1 < others_1, b_across + m_1, 1 - others_1)
    diagonal2 = where(m_2 < others_2, b_across + m_2, 1 - others_2)
    J_1 = m_3 - halved_2
    J_2 = halved_1 + m_4
    J_3 = halved_2 + m_3
    J_5 = m_5 - halved_0
    J_6 = m_4 - halved_1
    J_7 = halved_0 + m_5
    phi_rest = 3 * f - sinc
    twice_y = 2 * far_y
    closed_phi = phi_rest / twice_y
    phi = where(far_y_a, series_phi, closed_phi)
    b_rate_above = 0.5 * (f * f) - sinc * phi
    b_rate_below = 8 * (sinc * sinc)
    b_rate = b_rate_above / b_rate_below
    rate_vw = s_0 * s_3 + s_1 * s_4 + s_2 * s_5
    rate_bend = -(b_rate * rate_vw)
    rate_q_0 = 0.5 * s_0
    rate_q_1 = 0.5 * s_1
    rate_q_2 = 0.5 * s_2
    rate_beta_v_0 = -(s_0 * b)
    rate_beta_v_1 = -(s_1 * b)
    rate_beta_v_2 = -(s_2 * b)
    rate_bend_w_0 = -(s_3 * rate_bend)
    rate_bend_w_1 = -(s_4 * rate_bend)
    rate_bend_w_2 = -(s_5 * rate_bend)
    rate_symmetric_0 = -(s_3 * rate_beta_v_1) - s_4 * rate_beta_v_0 + s_4 * rate_bend_w_0
    rate_symmetric_1 = -(s_3 * rate_beta_v_2) - s_5 * rate_beta_v_0 + s_5 * rate_bend_w_0
    rate_symmetric_2 = -(s_4 * rate_beta_v_2) - s_5 * rate_beta_v_1 + s_5 * rate_bend_w_1
    rate_diagonal_0b = 2 * s_4 * rate_beta_v_1
    rate_diagonal_0d = 2 * s_5 * rate_beta_v_2
    rate_diagonal_0f = s_4 * rate_bend_w_1
    rate_diagonal_0g = s_5 * rate_bend_w_2
    rate_diagonal_0 = rate_diagonal_0b + rate_diagonal_0d - (rate_diagonal_0f + rate_diagonal_0g)
    rate_diagonal_1b = 2 * s_3 * rate_beta_v_0
    rate_diagonal_1d = s_3 * rate_bend_w_0
    rate_diagonal_1 = rate_diagonal_1b + rate_diagonal_0d - (rate_diagonal_1d + rate_diagonal_0g)
    rate_diagonal_2 = rate_diagonal_1b + rate_diagonal_0b - (rate_diagonal_1d + rate_diagonal_0f)
    M_04 = rate_symmetric_0 - rate_q_2
    M_05 = rate_q_1 + rate_symmetric_1
    M_13 = rate_q_2 + rate_symmetric_0
    M_15 = rate_symmetric_2 - rate_q_0
    M_23 = rate_symmetric_1 - rate_q_1
    M_24 = rate_q_0 + rate_symmetric_2
    return (diagonal0, J_1, J_2, rate_diagonal_0, M_04, M_05, J_3, diagonal1, J_5, M_13,
        rate_diagonal_1, M_15, J_6, J_7, diagonal2, M_23, M_24, rate_diagonal_2, 0, 0, 0, diagonal0,
        J_1, J_2, 0, 0, 0, J_3, diagonal1, J_5, 0, 0, 0, J_6, J_7, diagonal2)


@kernel("(3,4),(3,4),()->(3,4)")
def SE3_interpolated(D1, D2, k):
    """Do = D1 exp(k log(D1^-1 D2)), the screw motion from D1 at k = 0 to D2 at k = 1.

    (3,4),(3,4),()->(3,4).  D1, D2, Do: displacement [R | t], R rotation, t in m; k: number.
    247 mul, 211 add, 10 div, 3 sqrt, 5 neg, 7 abs, 2 copysign, 25 less, 2 equal, 49 select.
    Error <= R: 1 u, t: 1 u of its largest component, or of D1.t or D2.t if that is larger, for
    R of D1 a rotation and R of D2 a rotation and 0 <= k <= 1; searched, not proved.  Each
    component is within 1 ulp as long as its condition is below 1e13; in single precision it is
    the nearest number, except near ties, as long as that is below 1e5; searched, not proved.
    Intermediate sums may overflow where |t| of D1 or D2 is above 2e306, in single precision
    5e36.
    """
    D1_00, D1_01, D1_02, D1_03, D1_10, D1_11, D1_12, D1_13, D1_20, D1_21, D1_22, D1_23 = D1
    D2_00, D2_01, D2_02, D2_03, D2_10, D2_11, D2_12, D2_13, D2_20, D2_21, D2_22, D2_23 = D2
    apart_0 = D2_03 - D1_03
    apart_1 = D2_13 - D1_13
    apart_2 = D2_23 - D1_23
    between_0 = D1_00 * D2_00 + D1_10 * D2_10 + D1_20 * D2_20
    between_1 = D1_00 * D2_01 + D1_10 * D2_11 + D1_20 * D2_21
    between_2 = D1_00 * D2_02 + D1_10 * D2_12 + D1_20 * D2_22
    between_3 = D1_00 * apart_0 + D1_10 * apart_1 + D1_20 * apart_2
    between_4 = D1_01 * D2_00 + D1_11 * D2_10 + D1_21 * D2_20
    between_5 = D1_01 * D2_01 + D1_11 * D2_11 + D1_21 * D2_21
    between_6 = D1_01 * D2_02 + D1_11 * D2_12 + D1_21 * D2_22
    between_7 = D1_01 * apart_0 + D1_11 * apart_1 + D1_21 * apart_2
    between_8 = D1_02 * D2_00 + D1_12 * D2_10 + D1_22 * D2_20
    between_9 = D1_02 * D2_01 + D1_12 * D2_11 + D1_22 * D2_21
    between_10 = D1_02 * D2_02 + D1_12 * D2_12 + D1_22 * D2_22
    between_11 = D1_02 * apart_0 + D1_12 * apart_1 + D1_22 * apart_2
    log_p_0 = between_9 - between_6
    log_p_1 = between_2 - between_8
    log_p_2 = between_4 - between_1
    log_s_0 = between_6 + between_9
    log_s_1 = between_2 + between_8
    log_s_2 = between_1 + between_4
    log_first_0 = between_0 + 1
    log_first_1 = 1 - between_0
    log_others_0 = between_5 + between_10
    log_others_1 = between_5 - between_10
    log_d_0 = log_first_0 + log_others_0
    log_d_1 = log_first_0 - log_others_0
    log_d_2 = log_first_1 + log_others_1
    log_d_3 = log_first_1 - log_others_1
    log_low_0a = between_5 < between_0
    log_low_0 = where(log_low_0a, log_d_1, log_s_2)
    log_low_1 = where(log_low_0a, log_s_2, log_d_2)
    log_low_2 = where(log_low_0a, log_s_1, log_s_0)
    log_low_3 = where(log_low_0a, log_p_0, log_p_1)
    log_high_0b = between_0 < -between_5
    log_high_0 = where(log_high_0b, log_s_1, log_p_0)
    log_high_1 = where(log_high_0b, log_s_0, log_p_1)
    log_high_2 = where(log_high_0b, log_d_3, log_p_2)
    log_high_3 = where(log_high_0b, log_p_2, log_d_0)
    log_column_0a = between_10 < 0
    log_column_0 = where(log_column_0a, log_low_0, log_high_0)
    log_column_1 = where(log_column_0a, log_low_1, log_high_1)
    log_column_2 = where(log_column_0a, log_low_2, log_high_2)
    log_column_3 = where(log_column_0a, log_low_3, log_high_3)
    log_upper_0b = log_column_3 < 0
    log_upper_0 = where(log_upper_0b, -log_column_0, log_column_0)
    log_upper_1 = where(log_upper_0b, -log_column_1, log_column_1)
    log_upper_2 = where(log_upper_0b, -log_column_2, log_column_2)
    log_upper_3 = absolute(log_column_3)
    log_v_s_size_0 = absolute(log_upper_0)
    log_v_s_size_1 = absolute(log_upper_1)
    log_v_s_size_2 = absolute(log_upper_2)
    log_v_s_largest1 = where(log_v_s_size_0 < log_v_s_size_1, log_v_s_size_1, log_v_s_size_0)
    log_v_s_largest2 = where(log_v_s_largest1 < log_v_s_size_2, log_v_s_size_2, log_v_s_largest1)
    log_v_s_b = where(4.611686018427388e+18 < log_v_s_largest2, real(2.710505431213761e-20),
        real(1))
    log_v_s = where(log_v_s_largest2 < 1.4210854715202004e-14, 3.2451855365842673e+32,
        where(log_v_s_largest2 < 256, 1.8014398509481984e+16, log_v_s_b))
    log_v_y_0 = log_upper_0 * log_v_s
    log_v_y_1 = log_upper_1 * log_v_s
    log_v_y_2 = log_upper_2 * log_v_s
    log_v_n = sqrt(log_v_y_0 * log_v_y_0 + log_v_y_1 * log_v_y_1 + log_v_y_2 * log_v_y_2)
    log_v_r_d = where(1 < log_v_s, 5.551115123125783e-17, where(log_v_s < 1,
        real(3.6893488147419103e+19), real(1)))
    log_v_r = where(1.8014398509481984e+16 < log_v_s, 3.0814879110195774e-33, log_v_r_d)
    log_n = log_v_n * log_v_r
    log_half = elementary.atan2(log_n, log_upper_3)
    log_divisor = where(log_n == 0, 1, log_n)
    log_theta = 2 * log_half
    log_k = log_theta / log_divisor
    log_vector_0 = log_upper_0 * log_k
    log_vector_1 = log_upper_1 * log_k
    log_vector_2 = log_upper_2 * log_k
    log_half_angle = 0.5 * log_theta
    log_length = sqrt(log_n * log_n + log_upper_3 * log_upper_3)
    log_sine = log_n / log_length
    log_c = log_upper_3 / log_length
    log_y = log_half_angle * log_half_angle
    log_sinc_divisor_a = log_half_angle < 1.4901161193847656e-08
    log_sinc_divisor = where(log_sinc_divisor_a, 1.4901161193847656e-08, log_half_angle)
    log_sinc_quotient = log_sine / log_sinc_divisor
    log_sinc = where(log_sinc_divisor_a, 1 - 0.16666666666666666 * log_y, log_sinc_quotient)
    log_series_phi_g = (log_y
        * (log_y
        * (log_y * (4.116826490666969e-29 - 5.107725174524775e-32 * log_y) - 2.86531123750421e-26)
        + 1.701994875077501e-23))
    log_series_phi_m = (log_y
        * (log_y * (log_y * (log_series_phi_g - 8.509974375387505e-21) + 3.523129391410427e-18)
        - 1.1837714755139035e-15))
    log_series_phi_s = (log_y
        * (log_y * (log_y * (log_series_phi_m + 3.148832124866983e-13) - 6.423617534728645e-11)
        + 9.635426302092969e-09))
    log_series_phi_y = (log_y
        * (log_y * (log_y * (log_series_phi_s - 1.0020843354176687e-06) + 6.613756613756614e-05)
        - 0.002380952380952381))
    log_series_phi = log_series_phi_y + 0.03333333333333333
    log_f_more = 2 * log_y * log_series_phi
    log_near_f = 0.3333333333333333 * log_sinc + 0.3333333333333333 * log_f_more
    log_f_rest = log_sinc - log_c
    log_x = 4 * log_y
    log_far_y_a = log_x < 4
    log_far_y = where(log_far_y_a, 1, log_y)
    log_closed_f = log_f_rest / log_far_y
    log_f = where(log_far_y_a, log_near_f, log_closed_f)
    log_four_k = 4 * log_sinc
    log_b = log_f / log_four_k
    log_b_across = log_c / log_sinc
    log_wt = between_3 * log_vector_0 + between_7 * log_vector_1 + between_11 * log_vector_2
    log_pitch = log_b * log_wt
    log_along_0 = log_vector_0 * log_pitch
    log_along_1 = log_vector_1 * log_pitch
    log_along_2 = log_vector_2 * log_pitch
    log_u_0 = between_11 * log_vector_1 - between_7 * log_vector_2
    log_u_1 = between_3 * log_vector_2 - between_11 * log_vector_0
    log_u_2 = between_7 * log_vector_0 - between_3 * log_vector_1
    log_turned_0 = 0.5 * log_u_0
    log_turned_1 = 0.5 * log_u_1
    log_turned_2 = 0.5 * log_u_2
    log_across_axis_0 = log_along_0 - log_turned_0
    log_across_axis_1 = log_along_1 - log_turned_1
    log_across_axis_2 = log_along_2 - log_turned_2
    whole_0 = between_3 * log_b_across + log_across_axis_0
    whole_1 = between_7 * log_b_across + log_across_axis_1
    whole_2 = between_11 * log_b_across + log_across_axis_2
    screw_0 = k * whole_0
    screw_1 = k * whole_1
    screw_2 = k * whole_2
    screw_3 = k * log_vector_0
    screw_4 = k * log_vector_1
    screw_5 = k * log_vector_2
    exp_halved_0 = 0.5 * screw_3
    exp_halved_1 = 0.5 * screw_4
    exp_halved_2 = 0.5 * screw_5
    exp_y = exp_halved_0 * exp_halved_0 + exp_halved_1 * exp_halved_1 + exp_halved_2 * exp_halved_2
    exp_half_angle = sqrt(exp_y)
    exp_sine, exp_c = elementary.sincos(exp_half_angle)
    exp_sinc_divisor_a = exp_half_angle < 1.4901161193847656e-08
    exp_sinc_divisor = where(exp_sinc_divisor_a, 1.4901161193847656e-08, exp_half_angle)
    exp_sinc_quotient = exp_sine / exp_sinc_divisor
    exp_sinc = where(exp_sinc_divisor_a, 1 - 0.16666666666666666 * exp_y, exp_sinc_quotient)
    exp_g1 = exp_c * exp_sinc
    exp_g2 = 0.5 * (exp_sinc * exp_sinc)
    exp_sine_square = exp_sine * exp_sine
    exp_g0 = 1 - 2 * exp_sine_square
    exp_rest3 = 1 - exp_g1
    exp_x = 4 * exp_y
    exp_far_x_a = exp_x < 1
    exp_far_x = where(exp_far_x_a, 1, exp_x)
    exp_closed3 = exp_rest3 / exp_far_x
    exp_series5g = (exp_x
        * (exp_x
        * (exp_x * (1.1309962886447716e-31 - 1.216125041553518e-34 * exp_x)
        - 9.183689863795546e-29) + 6.446950284384474e-26))
    exp_series5m = (exp_x
        * (exp_x * (exp_x * (exp_series5g - 3.868170170630684e-23) + 1.9572941063391263e-20)
        - 8.22063524662433e-18))
    exp_series5s = (exp_x
        * (exp_x * (exp_x * (exp_series5m + 2.8114572543455206e-15) - 7.647163731819816e-13)
        + 1.6059043836821613e-10))
    exp_series5y = (exp_x
        * (exp_x * (exp_x * (exp_series5s - 2.505210838544172e-08) + 2.7557319223985893e-06)
        - 0.0001984126984126984))
    exp_series5 = exp_series5y + 0.008333333333333333
    exp_g3 = where(exp_far_x_a, 0.16666666666666666 - exp_x * exp_series5, exp_closed3)
    exp_u_0 = screw_2 * screw_4 - screw_1 * screw_5
    exp_u_1 = screw_0 * screw_5 - screw_2 * screw_3
    exp_u_2 = screw_1 * screw_3 - screw_0 * screw_4
    exp_turned_0 = exp_g2 * exp_u_0
    exp_turned_1 = exp_g2 * exp_u_1
    exp_turned_2 = exp_g2 * exp_u_2
    exp_wv = screw_0 * screw_3 + screw_1 * screw_4 + screw_2 * screw_5
    exp_pitch = exp_g3 * exp_wv
    exp_along_0 = screw_3 * exp_pitch
    exp_along_1 = screw_4 * exp_pitch
    exp_along_2 = screw_5 * exp_pitch
    exp_beta_v_0 = screw_3 * exp_g2
    exp_beta_v_1 = screw_4 * exp_g2
    exp_beta_v_2 = screw_5 * exp_g2
    exp_m_0 = screw_3 * exp_beta_v_0
    exp_m_1 = screw_4 * exp_beta_v_1
    exp_m_2 = screw_5 * exp_beta_v_2
    exp_m_3 = screw_4 * exp_beta_v_0
    exp_m_4 = screw_5 * exp_beta_v_0
    exp_m_5 = screw_5 * exp_beta_v_1
    exp_others_0 = exp_m_1 + exp_m_2
    exp_others_1 = exp_m_0 + exp_m_2
    exp_others_2 = exp_m_0 + exp_m_1
    exp_diagonal0 = where(exp_m_0 < exp_others_0, exp_g0 + exp_m_0, 1 - exp_others_0)
    exp_diagonal1 = where(exp_m_1 < exp_others_1, exp_g0 + exp_m_1, 1 - exp_others_1)
    exp_diagonal2 = where(exp_m_2 < exp_others_2, exp_g0 + exp_m_2, 1 - exp_others_2)
    exp_alpha_v_0 = screw_3 * exp_g1
    exp_alpha_v_1 = screw_4 * exp_g1
    exp_alpha_v_2 = screw_5 * exp_g1
    exp_across_axis_0 = exp_turned_0 + exp_along_0
    exp_across_axis_1 = exp_turned_1 + exp_along_1
    exp_across_axis_2 = exp_turned_2 + exp_along_2
    step_1 = exp_m_3 - exp_alpha_v_2
    step_2 = exp_m_4 + exp_alpha_v_1
    step_3 = screw_0 * exp_g1 + exp_across_axis_0
    step_4 = exp_m_3 + exp_alpha_v_2
    step_6 = exp_m_5 - exp_alpha_v_0
    step_7 = screw_1 * exp_g1 + exp_across_axis_1
    step_8 = exp_m_4 - exp_alpha_v_1
    step_9 = exp_m_5 + exp_alpha_v_0
    step_11 = screw_2 * exp_g1 + exp_across_axis_2
    Do_00 = D1_00 * exp_diagonal0 + (D1_01 * step_4 + D1_02 * step_8)
    Do_01 = D1_00 * step_1 + D1_02 * step_9 + D1_01 * exp_diagonal1
    Do_02 = D1_00 * step_2 + D1_01 * step_6 + D1_02 * exp_diagonal2
    Do_03 = D1_00 * step_3 + D1_01 * step_7 + D1_02 * step_11 + D1_03
    Do_10 = D1_10 * exp_diagonal0 + (D1_11 * step_4 + D1_12 * step_8)
    Do_11 = D1_10 * step_1 + D1_12 * step_9 + D1_11 * exp_diagonal1
    Do_12 = D1_10 * step_2 + D1_11 * step_6 + D1_12 * exp_diagonal2
    Do_13 = D1_10 * step_3 + D1_11 * step_7 + D1_12 * step_11 + D1_13
    Do_20 = D1_20 * exp_diagonal0 + (D1_21 * step_4 + D1_22 * step_8)
    Do_21 = D1_20 * step_1 + D1_22 * step_9 + D1_21 * exp_diagonal1
    Do_22 = D1_20 * step_2 + D1_21 * step_6 + D1_22 * exp_diagonal2
    Do_23 = D1_20 * step_3 + D1_21 * step_7 + D1_22 * step_11 + D1_23
    return (Do_00, Do_01, Do_02, Do_03, Do_10, Do_11, Do_12, Do_13, Do_20, Do_21, Do_22, Do_23)
