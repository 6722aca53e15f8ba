# Made by `coscrew generate`; changes are overwritten.
# SPDX-License-Identifier: MIT
# coscrew 0.2.0.  Copyright (c) 2026 The coscrew authors.
"""Quaternions q = (v; w), the scalar last: products, rotations, conversions, interpolation.

In single precision, plain tier.  A twin(f, …) is f of double precision with these constants.
"""

from coscrew import _elementary_single as elementary
from numpy import absolute, float32 as real, nan, sqrt, where
from coscrew._kernel import single_kernel as kernel
from coscrew._twins import single_twins
from coscrew import double

twin = single_twins(__name__, elementary=elementary)

quaternion_copy = twin(double.quaternion_copy)
quaternion_scale = twin(double.quaternion_scale)
axpy_qq = twin(double.axpy_qq)
quaternion_setIdentity = twin(double.quaternion_setIdentity)
quaternion_conjugated = twin(double.quaternion_conjugated)


@kernel("(4)->()")
def quaternion_norm(q):
    """|q| = sqrt(v·v + w^2).

    (4)->().  q: quaternion (x, y, z, w), the scalar last; norm: number.
    9 mul, 3 add, 1 sqrt, 4 abs, 9 less, 9 select.
    """
    q_0, q_1, q_2, q_3 = q
    s_size_0 = absolute(q_0)
    s_size_1 = absolute(q_1)
    s_size_2 = absolute(q_2)
    s_size_3 = absolute(q_3)
    s_largest1 = where(s_size_0 < s_size_1, s_size_1, s_size_0)
    s_largest2 = where(s_largest1 < s_size_2, s_size_2, s_largest1)
    s_largest3 = where(s_largest2 < s_size_3, s_size_3, s_largest2)
    s_d = where(s_largest3 < 256, 1.8014398509481984e+16, where(4.611686018427388e+18 < s_largest3,
        real(2.710505431213761e-20), real(1)))
    s = where(s_largest3 < 1.4210854715202004e-14, 3.2451855365842673e+32, s_d)
    y_0 = q_0 * s
    y_1 = q_1 * s
    y_2 = q_2 * s
    y_3 = q_3 * s
    n = sqrt(y_0 * y_0 + y_1 * y_1 + y_2 * y_2 + y_3 * y_3)
    r_d = where(1 < s, 5.551115123125783e-17, where(s < 1, real(3.6893488147419103e+19), real(1)))
    r = where(1.8014398509481984e+16 < s, 3.0814879110195774e-33, r_d)
    norm = n * r
    return norm


@kernel("(4)->(4)")
def quaternion_normalize(self):
    """self = self / |self|; zero stays zero.

    (4)->(4).  self: quaternion (x, y, z, w), the scalar last.
    16 mul, 3 add, 4 div, 1 sqrt, 4 abs, 8 less, 1 equal, 9 select.
    """
    self_0, self_1, self_2, self_3 = self
    s_size_0 = absolute(self_0)
    s_size_1 = absolute(self_1)
    s_size_2 = absolute(self_2)
    s_size_3 = absolute(self_3)
    s_largest1 = where(s_size_0 < s_size_1, s_size_1, s_size_0)
    s_largest2 = where(s_largest1 < s_size_2, s_size_2, s_largest1)
    s_largest3 = where(s_largest2 < s_size_3, s_size_3, s_largest2)
    s_d = where(s_largest3 < 256, 1.8014398509481984e+16, where(4.611686018427388e+18 < s_largest3,
        real(2.710505431213761e-20), real(1)))
    s = where(s_largest3 < 1.4210854715202004e-14, 3.2451855365842673e+32, s_d)
    y_0 = self_0 * s
    y_1 = self_1 * s
    y_2 = self_2 * s
    y_3 = self_3 * s
    up = where(1 < s, s, 1)
    down = where(s < 1, s, 1)
    n = sqrt(y_0 * y_0 + y_1 * y_1 + y_2 * y_2 + y_3 * y_3)
    divisor = where(n == 0, up, n)
    sized_0 = self_0 * up
    sized_1 = self_1 * up
    sized_2 = self_2 * up
    sized_3 = self_3 * up
    quotient_0 = sized_0 / divisor
    quotient_1 = sized_1 / divisor
    quotient_2 = sized_2 / divisor
    quotient_3 = sized_3 / divisor
    self_0_new = quotient_0 * down
    self_1_new = quotient_1 * down
    self_2_new = quotient_2 * down
    self_3_new = quotient_3 * down
    return (self_0_new, self_1_new, self_2_new, self_3_new)


@kernel("(4)->(4)")
def quaternion_normalized(q):
    """qo = q / |q|; zero stays zero.

    (4)->(4).  q, qo: quaternion (x, y, z, w), the scalar last.
    16 mul, 3 add, 4 div, 1 sqrt, 4 abs, 8 less, 1 equal, 9 select.
    """
    q_0, q_1, q_2, q_3 = q
    s_size_0 = absolute(q_0)
    s_size_1 = absolute(q_1)
    s_size_2 = absolute(q_2)
    s_size_3 = absolute(q_3)
    s_largest1 = where(s_size_0 < s_size_1, s_size_1, s_size_0)
    s_largest2 = where(s_largest1 < s_size_2, s_size_2, s_largest1)
    s_largest3 = where(s_largest2 < s_size_3, s_size_3, s_largest2)
    s_d = where(s_largest3 < 256, 1.8014398509481984e+16, where(4.611686018427388e+18 < s_largest3,
        real(2.710505431213761e-20), real(1)))
    s = where(s_largest3 < 1.4210854715202004e-14, 3.2451855365842673e+32, s_d)
    y_0 = q_0 * s
    y_1 = q_1 * s
    y_2 = q_2 * s
    y_3 = q_3 * s
    up = where(1 < s, s, 1)
    down = where(s < 1, s, 1)
    n = sqrt(y_0 * y_0 + y_1 * y_1 + y_2 * y_2 + y_3 * y_3)
    divisor = where(n == 0, up, n)
    sized_0 = q_0 * up
    sized_1 = q_1 * up
    sized_2 = q_2 * up
    sized_3 = q_3 * up
    quotient_0 = sized_0 / divisor
    quotient_1 = sized_1 / divisor
    quotient_2 = sized_2 / divisor
    quotient_3 = sized_3 / divisor
    qo_0 = quotient_0 * down
    qo_1 = quotient_1 * down
    qo_2 = quotient_2 * down
    qo_3 = quotient_3 * down
    return (qo_0, qo_1, qo_2, qo_3)


@kernel("(4)->()")
def quaternion_unit_defect(q):
    """|q| - 1: 0 for a unit quaternion, negative for a shorter one.

    (4)->().  q: quaternion (x, y, z, w), the scalar last; defect: number.
    9 mul, 4 add, 1 sqrt, 4 abs, 9 less, 9 select.
    """
    q_0, q_1, q_2, q_3 = q
    s_size_0 = absolute(q_0)
    s_size_1 = absolute(q_1)
    s_size_2 = absolute(q_2)
    s_size_3 = absolute(q_3)
    s_largest1 = where(s_size_0 < s_size_1, s_size_1, s_size_0)
    s_largest2 = where(s_largest1 < s_size_2, s_size_2, s_largest1)
    s_largest3 = where(s_largest2 < s_size_3, s_size_3, s_largest2)
    s_d = where(s_largest3 < 256, 1.8014398509481984e+16, where(4.611686018427388e+18 < s_largest3,
        real(2.710505431213761e-20), real(1)))
    s = where(s_largest3 < 1.4210854715202004e-14, 3.2451855365842673e+32, s_d)
    y_0 = q_0 * s
    y_1 = q_1 * s
    y_2 = q_2 * s
    y_3 = q_3 * s
    n = sqrt(y_0 * y_0 + y_1 * y_1 + y_2 * y_2 + y_3 * y_3)
    r_d = where(1 < s, 5.551115123125783e-17, where(s < 1, real(3.6893488147419103e+19), real(1)))
    r = where(1.8014398509481984e+16 < s, 3.0814879110195774e-33, r_d)
    length = n * r
    defect = length - 1
    return defect


@kernel("(4)->(4)")
def quaternion_nearest_unit(q):
    """qo = q / |q|, the unit quaternion nearest to q; NaN for zero, which has none.

    (4)->(4).  q, qo: quaternion (x, y, z, w), the scalar last.
    8 mul, 3 add, 4 div, 1 sqrt, 4 abs, 6 less, 1 equal, 11 select.
    """
    q_0, q_1, q_2, q_3 = q
    s_size_0 = absolute(q_0)
    s_size_1 = absolute(q_1)
    s_size_2 = absolute(q_2)
    s_size_3 = absolute(q_3)
    s_largest1 = where(s_size_0 < s_size_1, s_size_1, s_size_0)
    s_largest2 = where(s_largest1 < s_size_2, s_size_2, s_largest1)
    s_largest3 = where(s_largest2 < s_size_3, s_size_3, s_largest2)
    s_d = where(s_largest3 < 256, 1.8014398509481984e+16, where(4.611686018427388e+18 < s_largest3,
        real(2.710505431213761e-20), real(1)))
    s = where(s_largest3 < 1.4210854715202004e-14, 3.2451855365842673e+32, s_d)
    scaled_s_0 = q_0 * s
    scaled_s_1 = q_1 * s
    scaled_s_2 = q_2 * s
    scaled_s_3 = q_3 * s
    n = sqrt(scaled_s_0 * scaled_s_0 + scaled_s_1 * scaled_s_1 + scaled_s_2 * scaled_s_2 +
        scaled_s_3 * scaled_s_3)
    divisor_a = n == 0
    divisor = where(divisor_a, 1, n)
    unit_0 = scaled_s_0 / divisor
    unit_1 = scaled_s_1 / divisor
    unit_2 = scaled_s_2 / divisor
    unit_3 = scaled_s_3 / divisor
    qo_0 = where(divisor_a, nan, unit_0)
    qo_1 = where(divisor_a, nan, unit_1)
    qo_2 = where(divisor_a, nan, unit_2)
    qo_3 = where(divisor_a, nan, unit_3)
    return (qo_0, qo_1, qo_2, qo_3)

rotate_qv = twin(double.rotate_qv)
rotate_qconjv = twin(double.rotate_qconjv)
quaternion_product_qq = twin(double.quaternion_product_qq)
quaternion_product_qqconj = twin(double.quaternion_product_qqconj)
quaternion_product_qconjq = twin(double.quaternion_product_qconjq)
quaternion_product_qconjqconj = twin(double.quaternion_product_qconjqconj)
quaternion_product_qxq = twin(double.quaternion_product_qxq)
quaternion_product_qxqconj = twin(double.quaternion_product_qxqconj)
quaternion_product_qxconjq = twin(double.quaternion_product_qxconjq)
quaternion_product_qxconjqconj = twin(double.quaternion_product_qxconjqconj)
quaternion_product_qqx = twin(double.quaternion_product_qqx)
quaternion_product_qqxconj = twin(double.quaternion_product_qqxconj)
quaternion_product_qconjqx = twin(double.quaternion_product_qconjqx)
quaternion_product_qconjqxconj = twin(double.quaternion_product_qconjqxconj)
quaternion_product_qyq = twin(double.quaternion_product_qyq)
quaternion_product_qyqconj = twin(double.quaternion_product_qyqconj)
quaternion_product_qyconjq = twin(double.quaternion_product_qyconjq)
quaternion_product_qyconjqconj = twin(double.quaternion_product_qyconjqconj)
quaternion_product_qqy = twin(double.quaternion_product_qqy)
quaternion_product_qqyconj = twin(double.quaternion_product_qqyconj)
quaternion_product_qconjqy = twin(double.quaternion_product_qconjqy)
quaternion_product_qconjqyconj = twin(double.quaternion_product_qconjqyconj)
quaternion_product_qzq = twin(double.quaternion_product_qzq)
quaternion_product_qzqconj = twin(double.quaternion_product_qzqconj)
quaternion_product_qzconjq = twin(double.quaternion_product_qzconjq)
quaternion_product_qzconjqconj = twin(double.quaternion_product_qzconjqconj)
quaternion_product_qqz = twin(double.quaternion_product_qqz)
quaternion_product_qqzconj = twin(double.quaternion_product_qqzconj)
quaternion_product_qconjqz = twin(double.quaternion_product_qconjqz)
quaternion_product_qconjqzconj = twin(double.quaternion_product_qconjqzconj)
quaternion_product_qv = twin(double.quaternion_product_qv)
quaternion_product_qconjv = twin(double.quaternion_product_qconjv)
quaternion_product_vq = twin(double.quaternion_product_vq)
quaternion_product_vqconj = twin(double.quaternion_product_vqconj)
dot_qq = twin(double.dot_qq)
add_dpiToq = twin(double.add_dpiToq)
subtract_dpiFromq = twin(double.subtract_dpiFromq)
omega_to_dquaternion = twin(double.omega_to_dquaternion)
mat3x3_from_quaternion = twin(double.mat3x3_from_quaternion)
quaternion_from_mat3x3 = twin(double.quaternion_from_mat3x3)
quaternion_from_axis_angle = twin(double.quaternion_from_axis_angle,
    doc="""qo = (axis sin angle/2; cos angle/2); axis of length 1: with another |qo| is not 1, and its
rotation is by another angle.

(3),()->(4).  axis: vector; angle: number; qo: quaternion (x, y, z, w), the scalar last.
26 mul, 27 add, 1 abs.  Error <= qo: 3 u of its largest component for |axis| = 1; searched,
not proved.
""")


@kernel("(4)->(),(3)")
def axis_angle_from_quaternion(q):
    """angle = 2 atan2(|v|, |w|), axis = ±v / |v|; 0 <= angle <= π; the axis is (1, 0, 0) if the
    angle is 0; any multiple of a quaternion.

    (4)->(),(3).  q: quaternion (x, y, z, w), the scalar last; angle: number; axis: vector.
    34 mul, 31 add, 4 div, 1 sqrt, 5 neg, 9 abs, 2 copysign, 19 less, 2 equal, 32 select.  Error
    <= angle: 6 u, axis: 4 u of its largest component; searched, not proved.
    """
    q_0, q_1, q_2, q_3 = q
    s_size_0 = absolute(q_0)
    s_size_1 = absolute(q_1)
    s_size_2 = absolute(q_2)
    s_size_3 = absolute(q_3)
    s_largest1 = where(s_size_0 < s_size_1, s_size_1, s_size_0)
    s_largest2 = where(s_largest1 < s_size_2, s_size_2, s_largest1)
    s_largest3 = where(s_largest2 < s_size_3, s_size_3, s_largest2)
    s_d = where(s_largest3 < 256, 1.8014398509481984e+16, where(4.611686018427388e+18 < s_largest3,
        real(2.710505431213761e-20), real(1)))
    s = where(s_largest3 < 1.4210854715202004e-14, 3.2451855365842673e+32, s_d)
    scaled_s_0 = q_0 * s
    scaled_s_1 = q_1 * s
    scaled_s_2 = q_2 * s
    scaled_s_3 = q_3 * s
    upper_0b = scaled_s_3 < 0
    upper_0 = where(upper_0b, -scaled_s_0, scaled_s_0)
    upper_1 = where(upper_0b, -scaled_s_1, scaled_s_1)
    upper_2 = where(upper_0b, -scaled_s_2, scaled_s_2)
    upper_3 = where(upper_0b, -scaled_s_3, scaled_s_3)
    v_s_size_0 = absolute(upper_0)
    v_s_size_1 = absolute(upper_1)
    v_s_size_2 = absolute(upper_2)
    v_s_largest1 = where(v_s_size_0 < v_s_size_1, v_s_size_1, v_s_size_0)
    v_s_largest2 = where(v_s_largest1 < v_s_size_2, v_s_size_2, v_s_largest1)
    v_s = where(v_s_largest2 < 1.4210854715202004e-14, 3.2451855365842673e+32,
        where(v_s_largest2 < 256, real(1.8014398509481984e+16), real(1)))
    v_y_0 = upper_0 * v_s
    v_y_1 = upper_1 * v_s
    v_y_2 = upper_2 * v_s
    v_n = sqrt(v_y_0 * v_y_0 + v_y_1 * v_y_1 + v_y_2 * v_y_2)
    v_r = where(1.8014398509481984e+16 < v_s, 3.0814879110195774e-33, where(1 < v_s,
        real(5.551115123125783e-17), real(1)))
    n = v_n * v_r
    half = elementary.atan2(n, upper_3)
    divisor_a = v_n == 0
    divisor = where(divisor_a, 1, v_n)
    unit_0 = v_y_0 / divisor
    unit_1 = v_y_1 / divisor
    unit_2 = v_y_2 / divisor
    angle = 2 * half
    axis_0 = where(divisor_a, 1, unit_0)
    return (angle, axis_0, unit_1, unit_2)


@kernel("(3)->(4)")
def quaternion_exp(v):
    """qo = exp (v/2; 0) = (v/θ sin θ/2; cos θ/2), θ = |v|: turns by the rotation vector v.

    (3)->(4).  v: vector; qo: quaternion (x, y, z, w), the scalar last.
    65 mul, 80 add, 2 div, 1 sqrt, 5 abs, 2 less, 6 select.  Error <= qo: (7 + θ/200) u of its
    largest component for |v| <= 1e13, in single precision 1e5; searched, not proved.
    """
    v_0, v_1, v_2 = v
    h_0 = 0.5 * v_0
    h_1 = 0.5 * v_1
    h_2 = 0.5 * v_2
    size_0 = absolute(h_0)
    size_1 = absolute(h_1)
    size_2 = absolute(h_2)
    sizes = size_0 + size_1 + size_2
    grid = sizes * 8192
    shifted_0 = h_0 + grid
    shifted_1 = h_1 + grid
    shifted_2 = h_2 + grid
    high_0 = shifted_0 - grid
    high_1 = shifted_1 - grid
    high_2 = shifted_2 - grid
    low_0 = h_0 - high_0
    low_1 = h_1 - high_1
    low_2 = h_2 - high_2
    sum_0 = h_0 + high_0
    sum_1 = h_1 + high_1
    sum_2 = h_2 + high_2
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
    far_k = sine / theta
    k_l = (x
        * (x
        * (x * (x * (x * (6.4469503e-26 * x - 3.8681703e-23) + 1.9572942e-20) - 8.220635e-18)
        + 2.8114574e-15) - 7.6471636e-13) + 1.6059044e-10)
    k = where(theta_b,
        x * (x * (x * (x * (x * (x * k_l - 2.5052108e-08) + 2.7557319e-06) - 0.0001984127) +
            0.008333334) - 0.16666667) + 1,
        far_k)
    g2l = (x
        * (x
        * (x * (x * (x * (2.4795963e-27 * x - 1.6117376e-24) + 8.896791e-22) - 4.1103176e-19)
        + 1.5619207e-16) - 4.7794773e-14) + 1.1470745e-11)
    g2 = (x
        * (x
        * (x * (x * (x * (x * g2l - 2.0876756e-09) + 2.755732e-07) - 2.4801588e-05) + 0.0013888889)
        - 0.041666668) + 0.5)
    near = 1 - x * g2
    qo_0 = h_0 * k
    qo_1 = h_1 * k
    qo_2 = h_2 * k
    qo_3 = where(theta_b, near, cosine)
    return (qo_0, qo_1, qo_2, qo_3)


@kernel("(4)->(3)")
def quaternion_log(q):
    """vo = θ v/|v|, θ = 2 atan2(|v|, |w|) <= π: the rotation vector of q, or of any multiple of
    it.

    (4)->(3).  q: quaternion (x, y, z, w), the scalar last; vo: vector.
    37 mul, 31 add, 2 div, 1 sqrt, 5 neg, 9 abs, 2 copysign, 19 less, 2 equal, 31 select.  Error
    <= vo: 6 u of its largest component; searched, not proved.
    """
    q_0, q_1, q_2, q_3 = q
    s_size_0 = absolute(q_0)
    s_size_1 = absolute(q_1)
    s_size_2 = absolute(q_2)
    s_size_3 = absolute(q_3)
    s_largest1 = where(s_size_0 < s_size_1, s_size_1, s_size_0)
    s_largest2 = where(s_largest1 < s_size_2, s_size_2, s_largest1)
    s_largest3 = where(s_largest2 < s_size_3, s_size_3, s_largest2)
    s_d = where(s_largest3 < 256, 1.8014398509481984e+16, where(4.611686018427388e+18 < s_largest3,
        real(2.710505431213761e-20), real(1)))
    s = where(s_largest3 < 1.4210854715202004e-14, 3.2451855365842673e+32, s_d)
    scaled_s_0 = q_0 * s
    scaled_s_1 = q_1 * s
    scaled_s_2 = q_2 * s
    scaled_s_3 = q_3 * s
    upper_0b = scaled_s_3 < 0
    upper_0 = where(upper_0b, -scaled_s_0, scaled_s_0)
    upper_1 = where(upper_0b, -scaled_s_1, scaled_s_1)
    upper_2 = where(upper_0b, -scaled_s_2, scaled_s_2)
    upper_3 = where(upper_0b, -scaled_s_3, scaled_s_3)
    v_s_size_0 = absolute(upper_0)
    v_s_size_1 = absolute(upper_1)
    v_s_size_2 = absolute(upper_2)
    v_s_largest1 = where(v_s_size_0 < v_s_size_1, v_s_size_1, v_s_size_0)
    v_s_largest2 = where(v_s_largest1 < v_s_size_2, v_s_size_2, v_s_largest1)
    v_s = where(v_s_largest2 < 1.4210854715202004e-14, 3.2451855365842673e+32,
        where(v_s_largest2 < 256, real(1.8014398509481984e+16), real(1)))
    v_y_0 = upper_0 * v_s
    v_y_1 = upper_1 * v_s
    v_y_2 = upper_2 * v_s
    v_n = sqrt(v_y_0 * v_y_0 + v_y_1 * v_y_1 + v_y_2 * v_y_2)
    v_r = where(1.8014398509481984e+16 < v_s, 3.0814879110195774e-33, where(1 < v_s,
        real(5.551115123125783e-17), real(1)))
    n = v_n * v_r
    half = elementary.atan2(n, upper_3)
    divisor = where(n == 0, 1, n)
    theta = 2 * half
    k = theta / divisor
    vector_0 = upper_0 * k
    vector_1 = upper_1 * k
    vector_2 = upper_2 * k
    return (vector_0, vector_1, vector_2)


@kernel("(4),(4),()->(4)")
def quaternion_interpolated(q1, q2, k):
    """qo = q1 (q1* q2)^k along the shorter arc: q1 at k = 0, ±q2 at k = 1; |q1| = |q2| = 1.

    (4),(4),()->(4).  q1, q2, qo: quaternion (x, y, z, w), the scalar last; k: number.
    129 mul, 135 add, 4 div, 2 sqrt, 5 neg, 10 abs, 2 copysign, 17 less, 2 equal, 33 select.
    Error <= qo: 16 u of its largest component for |q1| = 1 and |q2| = 1 and 0 <= k <= 1;
    searched, not proved.
    """
    q1_0, q1_1, q1_2, q1_3 = q1
    q2_0, q2_1, q2_2, q2_3 = q2
    between_0 = q1_3 * q2_0 - q1_0 * q2_3 + (q1_2 * q2_1 - q1_1 * q2_2)
    between_1 = q1_0 * q2_2 - q1_2 * q2_0 + (q1_3 * q2_1 - q1_1 * q2_3)
    between_2 = q1_1 * q2_0 - q1_0 * q2_1 + (q1_3 * q2_2 - q1_2 * q2_3)
    between_3 = q1_0 * q2_0 + q1_1 * q2_1 + q1_2 * q2_2 + q1_3 * q2_3
    upper_0b = between_3 < 0
    upper_0 = where(upper_0b, -between_0, between_0)
    upper_1 = where(upper_0b, -between_1, between_1)
    upper_2 = where(upper_0b, -between_2, between_2)
    upper_3 = where(upper_0b, -between_3, between_3)
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
    rate = half / divisor
    kv_0 = k * upper_0
    kv_1 = k * upper_1
    kv_2 = k * upper_2
    step_0 = rate * kv_0
    step_1 = rate * kv_1
    step_2 = rate * kv_2
    exp_size_0 = absolute(step_0)
    exp_size_1 = absolute(step_1)
    exp_size_2 = absolute(step_2)
    exp_sizes = exp_size_0 + exp_size_1 + exp_size_2
    exp_grid = exp_sizes * 8192
    exp_shifted_0 = step_0 + exp_grid
    exp_shifted_1 = step_1 + exp_grid
    exp_shifted_2 = step_2 + exp_grid
    exp_high_0 = exp_shifted_0 - exp_grid
    exp_high_1 = exp_shifted_1 - exp_grid
    exp_high_2 = exp_shifted_2 - exp_grid
    exp_low_0 = step_0 - exp_high_0
    exp_low_1 = step_1 - exp_high_1
    exp_low_2 = step_2 - exp_high_2
    exp_sum_0 = step_0 + exp_high_0
    exp_sum_1 = step_1 + exp_high_1
    exp_sum_2 = step_2 + exp_high_2
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
    exp_far_k = exp_sine / exp_theta
    exp_k_j = (exp_x
        * (exp_x
        * (exp_x * (exp_x * (6.4469503e-26 * exp_x - 3.8681703e-23) + 1.9572942e-20)
        - 8.220635e-18) + 2.8114574e-15) - 7.6471636e-13)
    exp_k_t = (exp_x
        * (exp_x
        * (exp_x * (exp_x * (exp_x * exp_k_j + 1.6059044e-10) - 2.5052108e-08) + 2.7557319e-06)
        - 0.0001984127) + 0.008333334)
    exp_k = where(exp_theta_b, exp_x * (exp_x * exp_k_t - 0.16666667) + 1, exp_far_k)
    exp_g2j = (exp_x
        * (exp_x
        * (exp_x * (exp_x * (2.4795963e-27 * exp_x - 1.6117376e-24) + 8.896791e-22)
        - 4.1103176e-19) + 1.5619207e-16) - 4.7794773e-14)
    exp_g2t = (exp_x
        * (exp_x
        * (exp_x * (exp_x * (exp_x * exp_g2j + 1.1470745e-11) - 2.0876756e-09) + 2.755732e-07)
        - 2.4801588e-05) + 0.0013888889)
    exp_g2 = exp_x * (exp_x * exp_g2t - 0.041666668) + 0.5
    exp_near = 1 - exp_x * exp_g2
    power_0 = step_0 * exp_k
    power_1 = step_1 * exp_k
    power_2 = step_2 * exp_k
    power_3 = where(exp_theta_b, exp_near, exp_cosine)
    qo_0 = q1_0 * power_3 + (q1_1 * power_2 - q1_2 * power_1) + q1_3 * power_0
    qo_1 = q1_2 * power_0 - q1_0 * power_2 + q1_1 * power_3 + q1_3 * power_1
    qo_2 = q1_0 * power_1 - q1_1 * power_0 + q1_2 * power_3 + q1_3 * power_2
    qo_3 = q1_3 * power_3 - (q1_0 * power_0 + q1_1 * power_1 + q1_2 * power_2)
    return (qo_0, qo_1, qo_2, qo_3)
