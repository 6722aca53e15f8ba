# Made by `coscrew generate`; changes are overwritten.
# SPDX-License-Identifier: MIT
# coscrew 0.2.0.  Copyright (c) 2026 The coscrew authors.
"""Exponentials and logarithms of rotations and displacements, their Jacobians, interpolation.

In single precision, plain tier.  A twin(f, …) is f of double precision with these constants.
"""

from coscrew import _elementary_single as elementary
from numpy import absolute, float32 as real, sqrt, where
from coscrew._kernel import single_kernel as kernel
from coscrew._twins import single_twins
from coscrew import double

twin = single_twins(__name__)


@kernel("(3)->(3,3)")
def SO3_exp(v):
    """R = exp v~ = I + sin θ/θ v~ + (1 - cos θ)/θ^2 v~^2, θ = |v|.

    (3)->(3,3).  v: vector; R: rotation or other 3×3 matrix.
    71 mul, 96 add, 3 div, 1 sqrt, 5 abs, 5 less, 11 select.  Error <= R: (6 + θ/200) u of its
    largest component for |v| <= 1e13, in single precision 1e5; searched, not proved.
    """
    v_0, v_1, v_2 = v
    size_0 = absolute(v_0)
    size_1 = absolute(v_1)
    size_2 = absolute(v_2)
    sizes = size_0 + size_1 + size_2
    grid = sizes * 8192
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
    g1l = (x
        * (x
        * (x * (x * (x * (6.4469503e-26 * x - 3.8681703e-23) + 1.9572942e-20) - 8.220635e-18)
        + 2.8114574e-15) - 7.6471636e-13) + 1.6059044e-10)
    g1 = where(theta_b,
        x * (x * (x * (x * (x * (x * g1l - 2.5052108e-08) + 2.7557319e-06) - 0.0001984127) +
            0.008333334) - 0.16666667) + 1,
        closed1)
    g2l = (x
        * (x
        * (x * (x * (x * (2.4795963e-27 * x - 1.6117376e-24) + 8.896791e-22) - 4.1103176e-19)
        + 1.5619207e-16) - 4.7794773e-14) + 1.1470745e-11)
    g2 = where(theta_b,
        x * (x * (x * (x * (x * (x * g2l - 2.0876756e-09) + 2.755732e-07) - 2.4801588e-05) +
            0.0013888889) - 0.041666668) + 0.5,
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
    return (diagonal0, R_01, R_02, R_10, diagonal1, R_12, R_20, R_21, diagonal2)


@kernel("(3,3)->(3)")
def SO3_log(R):
    """vo with exp vo~ = R, |vo| <= π; if R is not quite a rotation, its defect carries over to vo.

    (3,3)->(3).  R: rotation or other 3×3 matrix; vo: vector.
    33 mul, 45 add, 2 div, 1 sqrt, 6 neg, 5 abs, 2 copysign, 18 less, 2 equal, 39 select.  Error
    <= vo: 7 u of its largest component for R a rotation; searched, not proved.
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
    82 mul, 108 add, 4 div, 1 sqrt, 5 abs, 6 less, 12 select.  Error <= R: (7 + θ/200) u of its
    largest component for |v| <= 1e13, in single precision 1e5; searched, not proved.
    """
    v_0, v_1, v_2 = v
    size_0 = absolute(v_0)
    size_1 = absolute(v_1)
    size_2 = absolute(v_2)
    sizes = size_0 + size_1 + size_2
    grid = sizes * 8192
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
    g1l = (x
        * (x
        * (x * (x * (x * (6.4469503e-26 * x - 3.8681703e-23) + 1.9572942e-20) - 8.220635e-18)
        + 2.8114574e-15) - 7.6471636e-13) + 1.6059044e-10)
    g1 = where(theta_b,
        x * (x * (x * (x * (x * (x * g1l - 2.5052108e-08) + 2.7557319e-06) - 0.0001984127) +
            0.008333334) - 0.16666667) + 1,
        closed1)
    g2l = (x
        * (x
        * (x * (x * (x * (2.4795963e-27 * x - 1.6117376e-24) + 8.896791e-22) - 4.1103176e-19)
        + 1.5619207e-16) - 4.7794773e-14) + 1.1470745e-11)
    g2 = where(theta_b,
        x * (x * (x * (x * (x * (x * g2l - 2.0876756e-09) + 2.755732e-07) - 2.4801588e-05) +
            0.0013888889) - 0.041666668) + 0.5,
        closed2)
    g3l = (x
        * (x
        * (x * (x * (x * (9.18369e-29 * x - 6.4469503e-26) + 3.8681703e-23) - 1.9572942e-20)
        + 8.220635e-18) - 2.8114574e-15) + 7.6471636e-13)
    g3x = (x
        * (x
        * (x * (x * (x * (x * g3l - 1.6059044e-10) + 2.5052108e-08) - 2.7557319e-06)
        + 0.0001984127) - 0.008333334) + 0.16666667)
    g3 = where(middle_x_a, g3x, closed3)
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
    82 mul, 108 add, 4 div, 1 sqrt, 3 neg, 5 abs, 6 less, 12 select.  Error <= R: (7 + θ/200) u
    of its largest component for |v| <= 1e13, in single precision 1e5; searched, not proved.
    """
    v_0, v_1, v_2 = v
    size_0 = absolute(v_0)
    size_1 = absolute(v_1)
    size_2 = absolute(v_2)
    sizes = size_0 + size_1 + size_2
    grid = sizes * 8192
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
    g1l = (x
        * (x
        * (x * (x * (x * (6.4469503e-26 * x - 3.8681703e-23) + 1.9572942e-20) - 8.220635e-18)
        + 2.8114574e-15) - 7.6471636e-13) + 1.6059044e-10)
    g1 = where(theta_b,
        x * (x * (x * (x * (x * (x * g1l - 2.5052108e-08) + 2.7557319e-06) - 0.0001984127) +
            0.008333334) - 0.16666667) + 1,
        closed1)
    g2l = (x
        * (x
        * (x * (x * (x * (2.4795963e-27 * x - 1.6117376e-24) + 8.896791e-22) - 4.1103176e-19)
        + 1.5619207e-16) - 4.7794773e-14) + 1.1470745e-11)
    g2 = where(theta_b,
        x * (x * (x * (x * (x * (x * g2l - 2.0876756e-09) + 2.755732e-07) - 2.4801588e-05) +
            0.0013888889) - 0.041666668) + 0.5,
        closed2)
    g3l = (x
        * (x
        * (x * (x * (x * (9.18369e-29 * x - 6.4469503e-26) + 3.8681703e-23) - 1.9572942e-20)
        + 8.220635e-18) - 2.8114574e-15) + 7.6471636e-13)
    g3x = (x
        * (x
        * (x * (x * (x * (x * g3l - 1.6059044e-10) + 2.5052108e-08) - 2.7557319e-06)
        + 0.0001984127) - 0.008333334) + 0.16666667)
    g3 = where(middle_x_a, g3x, closed3)
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
    65 mul, 90 add, 3 div, 1 sqrt, 3 neg, 5 abs, 7 less, 12 select.  Error <= R: 6 u of its
    largest component for |v| <= π; searched, not proved.
    """
    v_0, v_1, v_2 = v
    size_0 = absolute(v_0)
    size_1 = absolute(v_1)
    size_2 = absolute(v_2)
    sizes = size_0 + size_1 + size_2
    grid = sizes * 8192
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
    b_l = (x
        * (x
        * (x * (x * (x * (1.4551725e-27 * x + 5.744791e-26) + 2.2679524e-24) + 8.9535176e-23)
        + 3.534707e-21) + 1.3954465e-19) + 5.509003e-18)
    b_y = (x
        * (x
        * (x
        * (x * (x * (x * (x * b_l + 2.1748687e-16) + 8.586062e-15) + 3.3896803e-13)
        + 1.3382536e-11) + 5.2841903e-10) + 2.0876756e-08))
    b = where(b_divisor_a,
        x * (x * (x * (b_y + 8.267196e-07) + 3.3068784e-05) + 0.0013888889) + 0.083333336, closed_b)
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
    return (diagonal0, R_01, R_02, R_10, diagonal1, R_12, R_20, R_21, diagonal2)


@kernel("(3)->(3,3)")
def SO3_rightJacobianInverse(v):
    """R = J_r(v)^-1 = I + v~/2 + (1 - θ/2 cot θ/2)/θ^2 v~^2, θ = |v|; singular at multiples of 2π
    except 0.

    (3)->(3,3).  v: vector; R: rotation or other 3×3 matrix.
    65 mul, 90 add, 3 div, 1 sqrt, 5 abs, 7 less, 12 select.  Error <= R: 6 u of its largest
    component for |v| <= π; searched, not proved.
    """
    v_0, v_1, v_2 = v
    size_0 = absolute(v_0)
    size_1 = absolute(v_1)
    size_2 = absolute(v_2)
    sizes = size_0 + size_1 + size_2
    grid = sizes * 8192
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
    b_l = (x
        * (x
        * (x * (x * (x * (1.4551725e-27 * x + 5.744791e-26) + 2.2679524e-24) + 8.9535176e-23)
        + 3.534707e-21) + 1.3954465e-19) + 5.509003e-18)
    b_y = (x
        * (x
        * (x
        * (x * (x * (x * (x * b_l + 2.1748687e-16) + 8.586062e-15) + 3.3896803e-13)
        + 1.3382536e-11) + 5.2841903e-10) + 2.0876756e-08))
    b = where(b_divisor_a,
        x * (x * (x * (b_y + 8.267196e-07) + 3.3068784e-05) + 0.0013888889) + 0.083333336, closed_b)
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
    return (diagonal0, R_01, R_02, R_10, diagonal1, R_12, R_20, R_21, diagonal2)

mat3x3_orthonormalize = twin(double.mat3x3_orthonormalize)
mat3x3_orthonormalized = twin(double.mat3x3_orthonormalized)


@kernel("(6)->(3,4)")
def SE3_exp(s):
    """D = exp s = [exp ω~ | J_l(ω) v].

    (6)->(3,4).  s: screw (v in m/s; ω in rad/s); D: displacement [R | t], R rotation, t in m.
    102 mul, 120 add, 4 div, 1 sqrt, 5 abs, 6 less, 13 select.  Error <= R: (6 + θ/200) u, t:
    (14 + θ/200) u of its largest component, or of s.lin if that is larger, for |ω of s| <=
    1e13, in single precision 1e5; searched, not proved.  Intermediate sums may overflow where
    |v|, or |ω| |v|, is above 2e306, in single precision 5e36.
    """
    s_0, s_1, s_2, s_3, s_4, s_5 = s
    size_0 = absolute(s_3)
    size_1 = absolute(s_4)
    size_2 = absolute(s_5)
    sizes = size_0 + size_1 + size_2
    grid = sizes * 8192
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
    g1l = (x
        * (x
        * (x * (x * (x * (6.4469503e-26 * x - 3.8681703e-23) + 1.9572942e-20) - 8.220635e-18)
        + 2.8114574e-15) - 7.6471636e-13) + 1.6059044e-10)
    g1 = where(theta_b,
        x * (x * (x * (x * (x * (x * g1l - 2.5052108e-08) + 2.7557319e-06) - 0.0001984127) +
            0.008333334) - 0.16666667) + 1,
        closed1)
    g2l = (x
        * (x
        * (x * (x * (x * (2.4795963e-27 * x - 1.6117376e-24) + 8.896791e-22) - 4.1103176e-19)
        + 1.5619207e-16) - 4.7794773e-14) + 1.1470745e-11)
    g2 = where(theta_b,
        x * (x * (x * (x * (x * (x * g2l - 2.0876756e-09) + 2.755732e-07) - 2.4801588e-05) +
            0.0013888889) - 0.041666668) + 0.5,
        closed2)
    g3l = (x
        * (x
        * (x * (x * (x * (9.18369e-29 * x - 6.4469503e-26) + 3.8681703e-23) - 1.9572942e-20)
        + 8.220635e-18) - 2.8114574e-15) + 7.6471636e-13)
    g3x = (x
        * (x
        * (x * (x * (x * (x * g3l - 1.6059044e-10) + 2.5052108e-08) - 2.7557319e-06)
        + 0.0001984127) - 0.008333334) + 0.16666667)
    g3 = where(middle_x_a, g3x, closed3)
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
    return (diagonal0, D_01, D_02, D_03, D_10, diagonal1, D_12, D_13, D_20, D_21, diagonal2, D_23)


@kernel("(3,4)->(6)")
def SE3_log(D):
    """so with exp so = D, |ω| <= π: (J_l(ω)^-1 t; ω), ω = log R.

    (3,4)->(6).  D: displacement [R | t], R rotation, t in m; so: screw (v in m/s; ω in rad/s).
    72 mul, 74 add, 4 div, 1 sqrt, 6 neg, 5 abs, 2 copysign, 20 less, 2 equal, 43 select.  Error
    <= lin: 18 u, ang: 8 u of its largest component for R of D a rotation; searched, not proved.
    Intermediate sums may overflow where |t| is above 2e306, in single precision 5e36.
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
    x = theta * theta
    far_sine = where(x < 1, 1, n)
    cotangent = upper_3 / far_sine
    half_cotangent = 0.5 * theta * cotangent
    b_rest = 1 - half_cotangent
    b_divisor_a = x < 4
    b_divisor = where(b_divisor_a, 4, x)
    closed_b = b_rest / b_divisor
    b_l = (x
        * (x
        * (x * (x * (x * (1.4551725e-27 * x + 5.744791e-26) + 2.2679524e-24) + 8.9535176e-23)
        + 3.534707e-21) + 1.3954465e-19) + 5.509003e-18)
    b_y = (x
        * (x
        * (x
        * (x * (x * (x * (x * b_l + 2.1748687e-16) + 8.586062e-15) + 3.3896803e-13)
        + 1.3382536e-11) + 5.2841903e-10) + 2.0876756e-08))
    b = where(b_divisor_a,
        x * (x * (x * (b_y + 8.267196e-07) + 3.3068784e-05) + 0.0013888889) + 0.083333336, closed_b)
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
    return (so_0, so_1, so_2, vector_0, vector_1, vector_2)


@kernel("(6)->(6,6)")
def SE3_leftJacobian(s):
    """M = J_l(s) = Σ ([ad](s))^k / (k+1)!.

    (6)->(6,6).  s: screw (v in m/s; ω in rad/s); M: 6×6 operator.
    143 mul, 160 add, 6 div, 1 sqrt, 1 neg, 5 abs, 7 less, 15 select.  Error <= M: 20 u of its
    largest component for |ω of s| <= π; searched, not proved.  Intermediate sums may overflow
    where |v| is above 2e306, in single precision 5e36.
    """
    s_0, s_1, s_2, s_3, s_4, s_5 = s
    size_0 = absolute(s_3)
    size_1 = absolute(s_4)
    size_2 = absolute(s_5)
    sizes = size_0 + size_1 + size_2
    grid = sizes * 8192
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
    g1l = (x
        * (x
        * (x * (x * (x * (6.4469503e-26 * x - 3.8681703e-23) + 1.9572942e-20) - 8.220635e-18)
        + 2.8114574e-15) - 7.6471636e-13) + 1.6059044e-10)
    g1 = where(theta_b,
        x * (x * (x * (x * (x * (x * g1l - 2.5052108e-08) + 2.7557319e-06) - 0.0001984127) +
            0.008333334) - 0.16666667) + 1,
        closed1)
    g2l = (x
        * (x
        * (x * (x * (x * (2.4795963e-27 * x - 1.6117376e-24) + 8.896791e-22) - 4.1103176e-19)
        + 1.5619207e-16) - 4.7794773e-14) + 1.1470745e-11)
    g2 = where(theta_b,
        x * (x * (x * (x * (x * (x * g2l - 2.0876756e-09) + 2.755732e-07) - 2.4801588e-05) +
            0.0013888889) - 0.041666668) + 0.5,
        closed2)
    g3l = (x
        * (x
        * (x * (x * (x * (9.18369e-29 * x - 6.4469503e-26) + 3.8681703e-23) - 1.9572942e-20)
        + 8.220635e-18) - 2.8114574e-15) + 7.6471636e-13)
    g3x = (x
        * (x
        * (x * (x * (x * (x * g3l - 1.6059044e-10) + 2.5052108e-08) - 2.7557319e-06)
        + 0.0001984127) - 0.008333334) + 0.16666667)
    g3 = where(middle_x_a, g3x, closed3)
    late_x_a = x < 9
    late_x = where(late_x_a, 1, x)
    rate2_rest = g1 - 2 * g2
    closed_rate2 = rate2_rest / late_x
    rate3_rest = g2 - 3 * g3
    closed_rate3 = rate3_rest / late_x
    rate2l = (x
        * (x
        * (x * (x * (x * (5.951031e-26 - 8.527712e-29 * x) - 3.5458228e-23) + 1.7793582e-20)
        - 7.398571e-18) + 2.499073e-15) - 6.691268e-13)
    rate2x = (x
        * (x
        * (x * (x * (x * (x * rate2l + 1.3764895e-10) - 2.0876756e-08) + 2.2045856e-06)
        - 0.00014880953) + 0.0055555557) - 0.083333336)
    rate2 = where(late_x_a, rate2x, closed_rate2)
    rate3l = (x
        * (x
        * (x * (x * (x * (2.2040857e-27 - 2.9405903e-30 * x) - 1.418329e-24) + 7.7363405e-22)
        - 3.5231295e-19) + 1.3153016e-16) - 3.93604e-14)
    rate3x = (x
        * (x
        * (x * (x * (x * (x * rate3l + 9.176596e-12) - 1.6059044e-09) + 2.0041686e-07)
        - 1.6534392e-05) + 0.0007936508) - 0.016666668)
    rate3 = where(late_x_a, rate3x, closed_rate3)
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
    143 mul, 160 add, 6 div, 1 sqrt, 13 neg, 5 abs, 7 less, 15 select.  Error <= M: 20 u of its
    largest component for |ω of s| <= π; searched, not proved.  Intermediate sums may overflow
    where |v| is above 2e306, in single precision 5e36.
    """
    s_0, s_1, s_2, s_3, s_4, s_5 = s
    size_0 = absolute(s_3)
    size_1 = absolute(s_4)
    size_2 = absolute(s_5)
    sizes = size_0 + size_1 + size_2
    grid = sizes * 8192
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
    g1l = (x
        * (x
        * (x * (x * (x * (6.4469503e-26 * x - 3.8681703e-23) + 1.9572942e-20) - 8.220635e-18)
        + 2.8114574e-15) - 7.6471636e-13) + 1.6059044e-10)
    g1 = where(theta_b,
        x * (x * (x * (x * (x * (x * g1l - 2.5052108e-08) + 2.7557319e-06) - 0.0001984127) +
            0.008333334) - 0.16666667) + 1,
        closed1)
    g2l = (x
        * (x
        * (x * (x * (x * (2.4795963e-27 * x - 1.6117376e-24) + 8.896791e-22) - 4.1103176e-19)
        + 1.5619207e-16) - 4.7794773e-14) + 1.1470745e-11)
    g2 = where(theta_b,
        x * (x * (x * (x * (x * (x * g2l - 2.0876756e-09) + 2.755732e-07) - 2.4801588e-05) +
            0.0013888889) - 0.041666668) + 0.5,
        closed2)
    g3l = (x
        * (x
        * (x * (x * (x * (9.18369e-29 * x - 6.4469503e-26) + 3.8681703e-23) - 1.9572942e-20)
        + 8.220635e-18) - 2.8114574e-15) + 7.6471636e-13)
    g3x = (x
        * (x
        * (x * (x * (x * (x * g3l - 1.6059044e-10) + 2.5052108e-08) - 2.7557319e-06)
        + 0.0001984127) - 0.008333334) + 0.16666667)
    g3 = where(middle_x_a, g3x, closed3)
    late_x_a = x < 9
    late_x = where(late_x_a, 1, x)
    rate2_rest = g1 - 2 * g2
    closed_rate2 = rate2_rest / late_x
    rate3_rest = g2 - 3 * g3
    closed_rate3 = rate3_rest / late_x
    rate2l = (x
        * (x
        * (x * (x * (x * (5.951031e-26 - 8.527712e-29 * x) - 3.5458228e-23) + 1.7793582e-20)
        - 7.398571e-18) + 2.499073e-15) - 6.691268e-13)
    rate2x = (x
        * (x
        * (x * (x * (x * (x * rate2l + 1.3764895e-10) - 2.0876756e-08) + 2.2045856e-06)
        - 0.00014880953) + 0.0055555557) - 0.083333336)
    rate2 = where(late_x_a, rate2x, closed_rate2)
    rate3l = (x
        * (x
        * (x * (x * (x * (2.2040857e-27 - 2.9405903e-30 * x) - 1.418329e-24) + 7.7363405e-22)
        - 3.5231295e-19) + 1.3153016e-16) - 3.93604e-14)
    rate3x = (x
        * (x
        * (x * (x * (x * (x * rate3l + 9.176596e-12) - 1.6059044e-09) + 2.0041686e-07)
        - 1.6534392e-05) + 0.0007936508) - 0.016666668)
    rate3 = where(late_x_a, rate3x, closed_rate3)
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
    rate_q_0 = -(s_0 * g2 + s_3 * rate_turn)
    rate_q_1 = -(s_1 * g2 + s_4 * rate_turn)
    rate_q_2 = -(s_2 * g2 + s_5 * rate_turn)
    rate_beta_v_0 = -(s_0 * g3)
    rate_beta_v_1 = -(s_1 * g3)
    rate_beta_v_2 = -(s_2 * g3)
    rate_bend_w_0 = -(s_3 * rate_bend)
    rate_bend_w_1 = -(s_4 * rate_bend)
    rate_bend_w_2 = -(s_5 * rate_bend)
    rate_symmetric_0 = s_4 * rate_bend_w_0 - (s_3 * rate_beta_v_1 + s_4 * rate_beta_v_0)
    rate_symmetric_1 = s_5 * rate_bend_w_0 - (s_3 * rate_beta_v_2 + s_5 * rate_beta_v_0)
    rate_symmetric_2 = s_5 * rate_bend_w_1 - (s_4 * rate_beta_v_2 + s_5 * rate_beta_v_1)
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
    115 mul, 133 add, 5 div, 1 sqrt, 7 neg, 5 abs, 7 less, 13 select.  Error <= M: 14 u of its
    largest component for |ω of s| <= π; searched, not proved.  Intermediate sums may overflow
    where |v| is above 2e306, in single precision 5e36.
    """
    s_0, s_1, s_2, s_3, s_4, s_5 = s
    size_0 = absolute(s_3)
    size_1 = absolute(s_4)
    size_2 = absolute(s_5)
    sizes = size_0 + size_1 + size_2
    grid = sizes * 8192
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
    above_b = cosine < 0
    above = where(above_b, sine, cosine + 1)
    below = where(above_b, 1 - cosine, sine)
    cotangent = above / below
    half_cotangent = 0.5 * theta * cotangent
    b_rest = 1 - half_cotangent
    b_divisor_a = x < 4
    b_divisor = where(b_divisor_a, 4, x)
    closed_b = b_rest / b_divisor
    b_l = (x
        * (x
        * (x * (x * (x * (1.4551725e-27 * x + 5.744791e-26) + 2.2679524e-24) + 8.9535176e-23)
        + 3.534707e-21) + 1.3954465e-19) + 5.509003e-18)
    b_y = (x
        * (x
        * (x
        * (x * (x * (x * (x * b_l + 2.1748687e-16) + 8.586062e-15) + 3.3896803e-13)
        + 1.3382536e-11) + 5.2841903e-10) + 2.0876756e-08))
    b = where(b_divisor_a,
        x * (x * (x * (b_y + 8.267196e-07) + 3.3068784e-05) + 0.0013888889) + 0.083333336, closed_b)
    b_across = where(b_divisor_a, 1 - x * b, half_cotangent)
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
    alpha_v_0 = -(0.5 * s_3)
    alpha_v_1 = -(0.5 * s_4)
    alpha_v_2 = -(0.5 * s_5)
    J_1 = m_3 - alpha_v_2
    J_2 = m_4 + alpha_v_1
    J_3 = m_3 + alpha_v_2
    J_5 = m_5 - alpha_v_0
    J_6 = m_4 - alpha_v_1
    J_7 = m_5 + alpha_v_0
    b_rate_across = (2 - half_cotangent) / b_divisor
    b_rate_square = 0.25 + 0.25 * (cotangent * cotangent)
    b_rate_rest = b_rate_square - b_rate_across
    closed_b_rate = b_rate_rest / b_divisor
    b_rate_k = (x
        * (x
        * (x * (x * (x * (3.3612244e-29 * x + 1.2532382e-27) + 4.656552e-26) + 1.7234372e-24)
        + 6.350267e-23) + 2.3279144e-21))
    b_rate_w = (x
        * (x
        * (x
        * (x * (x * (x * (b_rate_k + 8.483297e-20) + 3.0699822e-18) + 1.10180054e-16)
        + 3.9147635e-15) + 1.37377e-13) + 4.7455525e-12))
    b_rate_ah = (x
        * (x
        * (x * (x * (x * (b_rate_w + 1.6059044e-10) + 5.28419e-09) + 1.6701405e-07)
        + 4.9603173e-06) + 0.00013227513) + 0.0027777778)
    b_rate = where(b_divisor_a, b_rate_ah, closed_b_rate)
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
    115 mul, 133 add, 5 div, 1 sqrt, 7 neg, 5 abs, 7 less, 13 select.  Error <= M: 14 u of its
    largest component for |ω of s| <= π; searched, not proved.  Intermediate sums may overflow
    where |v| is above 2e306, in single precision 5e36.
    """
    s_0, s_1, s_2, s_3, s_4, s_5 = s
    size_0 = absolute(s_3)
    size_1 = absolute(s_4)
    size_2 = absolute(s_5)
    sizes = size_0 + size_1 + size_2
    grid = sizes * 8192
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
    above_b = cosine < 0
    above = where(above_b, sine, cosine + 1)
    below = where(above_b, 1 - cosine, sine)
    cotangent = above / below
    half_cotangent = 0.5 * theta * cotangent
    b_rest = 1 - half_cotangent
    b_divisor_a = x < 4
    b_divisor = where(b_divisor_a, 4, x)
    closed_b = b_rest / b_divisor
    b_l = (x
        * (x
        * (x * (x * (x * (1.4551725e-27 * x + 5.744791e-26) + 2.2679524e-24) + 8.9535176e-23)
        + 3.534707e-21) + 1.3954465e-19) + 5.509003e-18)
    b_y = (x
        * (x
        * (x
        * (x * (x * (x * (x * b_l + 2.1748687e-16) + 8.586062e-15) + 3.3896803e-13)
        + 1.3382536e-11) + 5.2841903e-10) + 2.0876756e-08))
    b = where(b_divisor_a,
        x * (x * (x * (b_y + 8.267196e-07) + 3.3068784e-05) + 0.0013888889) + 0.083333336, closed_b)
    b_across = where(b_divisor_a, 1 - x * b, half_cotangent)
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
    alpha_v_0 = 0.5 * s_3
    alpha_v_1 = 0.5 * s_4
    alpha_v_2 = 0.5 * s_5
    J_1 = m_3 - alpha_v_2
    J_2 = m_4 + alpha_v_1
    J_3 = m_3 + alpha_v_2
    J_5 = m_5 - alpha_v_0
    J_6 = m_4 - alpha_v_1
    J_7 = m_5 + alpha_v_0
    b_rate_across = (2 - half_cotangent) / b_divisor
    b_rate_square = 0.25 + 0.25 * (cotangent * cotangent)
    b_rate_rest = b_rate_square - b_rate_across
    closed_b_rate = b_rate_rest / b_divisor
    b_rate_k = (x
        * (x
        * (x * (x * (x * (3.3612244e-29 * x + 1.2532382e-27) + 4.656552e-26) + 1.7234372e-24)
        + 6.350267e-23) + 2.3279144e-21))
    b_rate_w = (x
        * (x
        * (x
        * (x * (x * (x * (b_rate_k + 8.483297e-20) + 3.0699822e-18) + 1.10180054e-16)
        + 3.9147635e-15) + 1.37377e-13) + 4.7455525e-12))
    b_rate_ah = (x
        * (x
        * (x * (x * (x * (b_rate_w + 1.6059044e-10) + 5.28419e-09) + 1.6701405e-07)
        + 4.9603173e-06) + 0.00013227513) + 0.0027777778)
    b_rate = where(b_divisor_a, b_rate_ah, closed_b_rate)
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
    rate_symmetric_0 = s_4 * rate_bend_w_0 - (s_3 * rate_beta_v_1 + s_4 * rate_beta_v_0)
    rate_symmetric_1 = s_5 * rate_bend_w_0 - (s_3 * rate_beta_v_2 + s_5 * rate_beta_v_0)
    rate_symmetric_2 = s_5 * rate_bend_w_1 - (s_4 * rate_beta_v_2 + s_5 * rate_beta_v_1)
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
    252 mul, 248 add, 8 div, 2 sqrt, 6 neg, 10 abs, 2 copysign, 26 less, 2 equal, 56 select.
    Error <= R: 22 u, t: 60 u of its largest component, or of D1.t or D2.t if that is larger,
    for R of D1 a rotation and R of D2 a rotation and 0 <= k <= 1; searched, not proved.
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
    log_upper_3 = where(log_upper_0b, -log_column_3, log_column_3)
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
    log_x = log_theta * log_theta
    log_far_sine = where(log_x < 1, 1, log_n)
    log_cotangent = log_upper_3 / log_far_sine
    log_half_cotangent = 0.5 * log_theta * log_cotangent
    log_b_rest = 1 - log_half_cotangent
    log_b_divisor_a = log_x < 4
    log_b_divisor = where(log_b_divisor_a, 4, log_x)
    log_closed_b = log_b_rest / log_b_divisor
    log_b_j = (log_x
        * (log_x
        * (log_x * (log_x * (1.4551725e-27 * log_x + 5.744791e-26) + 2.2679524e-24)
        + 8.9535176e-23) + 3.534707e-21) + 1.3954465e-19)
    log_b_t = (log_x
        * (log_x
        * (log_x * (log_x * (log_x * log_b_j + 5.509003e-18) + 2.1748687e-16) + 8.586062e-15)
        + 3.3896803e-13) + 1.3382536e-11)
    log_b_ad = (log_x
        * (log_x
        * (log_x * (log_x * (log_x * log_b_t + 5.2841903e-10) + 2.0876756e-08) + 8.267196e-07)
        + 3.3068784e-05) + 0.0013888889)
    log_b = where(log_b_divisor_a, log_x * log_b_ad + 0.083333336, log_closed_b)
    log_b_across = where(log_b_divisor_a, 1 - log_x * log_b, log_half_cotangent)
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
    exp_size_0 = absolute(screw_3)
    exp_size_1 = absolute(screw_4)
    exp_size_2 = absolute(screw_5)
    exp_sizes = exp_size_0 + exp_size_1 + exp_size_2
    exp_grid = exp_sizes * 8192
    exp_shifted_0 = screw_3 + exp_grid
    exp_shifted_1 = screw_4 + exp_grid
    exp_shifted_2 = screw_5 + exp_grid
    exp_high_0 = exp_shifted_0 - exp_grid
    exp_high_1 = exp_shifted_1 - exp_grid
    exp_high_2 = exp_shifted_2 - exp_grid
    exp_low_0 = screw_3 - exp_high_0
    exp_low_1 = screw_4 - exp_high_1
    exp_low_2 = screw_5 - exp_high_2
    exp_sum_0 = screw_3 + exp_high_0
    exp_sum_1 = screw_4 + exp_high_1
    exp_sum_2 = screw_5 + exp_high_2
    exp_squares = exp_high_0 * exp_high_0 + exp_high_1 * exp_high_1 + exp_high_2 * exp_high_2
    exp_cross = exp_low_0 * exp_sum_0 + exp_low_1 * exp_sum_1 + exp_low_2 * exp_sum_2
    exp_x = exp_squares + exp_cross
    exp_theta_b = exp_x < 1
    exp_theta = where(exp_theta_b, 1, sqrt(exp_x))
    exp_theta_shifted = exp_grid + exp_theta
    exp_theta_high = exp_theta_shifted - exp_grid
    exp_theta_low = exp_theta - exp_theta_high
    exp_theta_sum = exp_theta + exp_theta_high
    exp_cross_rest = exp_cross - exp_theta_low * exp_theta_sum
    exp_exact = exp_squares - exp_theta_high * exp_theta_high
    exp_residual = exp_cross_rest + exp_exact
    exp_small = 0.5 * exp_residual / exp_theta
    exp_delta = where(absolute(exp_small) < 0.0078125, exp_small, 0)
    exp_far_sine_a, exp_far_cosine_a = elementary.sincos(exp_theta)
    exp_far_sine = where(exp_theta_b, 1, exp_far_sine_a)
    exp_far_cosine = where(exp_theta_b, 0, exp_far_cosine_a)
    exp_sine = exp_delta * exp_far_cosine + exp_far_sine
    exp_cosine = exp_far_cosine - exp_delta * exp_far_sine
    exp_far_x = where(exp_theta_b, 1, exp_x)
    exp_middle_x_a = exp_x < 4
    exp_middle_x = where(exp_middle_x_a, 4, exp_x)
    exp_closed1 = exp_sine / exp_theta
    exp_versine = 1 - exp_cosine
    exp_closed2 = exp_versine / exp_far_x
    exp_rest3 = 1 - exp_closed1
    exp_closed3 = exp_rest3 / exp_middle_x
    exp_g1j = (exp_x
        * (exp_x
        * (exp_x * (exp_x * (6.4469503e-26 * exp_x - 3.8681703e-23) + 1.9572942e-20)
        - 8.220635e-18) + 2.8114574e-15) - 7.6471636e-13)
    exp_g1t = (exp_x
        * (exp_x
        * (exp_x * (exp_x * (exp_x * exp_g1j + 1.6059044e-10) - 2.5052108e-08) + 2.7557319e-06)
        - 0.0001984127) + 0.008333334)
    exp_g1 = where(exp_theta_b, exp_x * (exp_x * exp_g1t - 0.16666667) + 1, exp_closed1)
    exp_g2j = (exp_x
        * (exp_x
        * (exp_x * (exp_x * (2.4795963e-27 * exp_x - 1.6117376e-24) + 8.896791e-22)
        - 4.1103176e-19) + 1.5619207e-16) - 4.7794773e-14)
    exp_g2t = (exp_x
        * (exp_x
        * (exp_x * (exp_x * (exp_x * exp_g2j + 1.1470745e-11) - 2.0876756e-09) + 2.755732e-07)
        - 2.4801588e-05) + 0.0013888889)
    exp_g2 = where(exp_theta_b, exp_x * (exp_x * exp_g2t - 0.041666668) + 0.5, exp_closed2)
    exp_g3j = (exp_x
        * (exp_x
        * (exp_x * (exp_x * (9.18369e-29 * exp_x - 6.4469503e-26) + 3.8681703e-23) - 1.9572942e-20)
        + 8.220635e-18) - 2.8114574e-15)
    exp_g3t = (exp_x
        * (exp_x
        * (exp_x * (exp_x * (exp_x * exp_g3j + 7.6471636e-13) - 1.6059044e-10) + 2.5052108e-08)
        - 2.7557319e-06) + 0.0001984127)
    exp_g3 = where(exp_middle_x_a, exp_x * (exp_x * exp_g3t - 0.008333334) + 0.16666667,
        exp_closed3)
    exp_g0 = where(exp_theta_b, 1 - exp_x * exp_g2, exp_cosine)
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
