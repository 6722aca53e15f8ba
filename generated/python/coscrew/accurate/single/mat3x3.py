# Made by `coscrew generate`; changes are overwritten.
# SPDX-License-Identifier: MIT
# coscrew 0.2.0.  Copyright (c) 2026 The coscrew authors.
"""3×3 matrices: rotations, and matrices in general.

In single precision, accurate tier.
"""

from coscrew import _elementary_double as elementary
from numpy import absolute, float64 as real, nan, sqrt, where
from coscrew._kernel import wide_kernel as kernel


@kernel("(3),(3)->(3,3)")
def acceleration_tensor(w, dw):
    """Ro = w'~ + w~ w~ of a body with angular velocity w and angular acceleration w' = dw: the
    acceleration of its point x, less that of its origin, is Ro x.

    (3),(3)->(3,3).  w, dw: vector; Ro: rotation or other 3×3 matrix.
    6 mul, 9 add, 3 neg.  Error <= u |result| + 1/16 u^2 S, S the sum of the |terms| of the
    expanded formula; barring over- and underflow.
    """
    w_0, w_1, w_2 = w
    dw_0, dw_1, dw_2 = dw
    ww_0 = w_0 * w_0
    ww_1 = w_1 * w_1
    ww_2 = w_2 * w_2
    ww_3 = w_0 * w_1
    ww_4 = w_0 * w_2
    ww_5 = w_1 * w_2
    Ro_00 = -ww_1 - ww_2
    Ro_01 = ww_3 - dw_2
    Ro_02 = dw_1 + ww_4
    Ro_10 = dw_2 + ww_3
    Ro_11 = -ww_0 - ww_2
    Ro_12 = ww_5 - dw_0
    Ro_20 = ww_4 - dw_1
    Ro_21 = dw_0 + ww_5
    Ro_22 = -ww_0 - ww_1
    return (Ro_00, Ro_01, Ro_02, Ro_10, Ro_11, Ro_12, Ro_20, Ro_21, Ro_22)


@kernel("(3,3)->()")
def mat3x3_determinant(R):
    """det R.

    (3,3)->().  R: rotation or other 3×3 matrix; det: number.
    9 mul, 5 add.  Error <= u |result| + 5/32 u^2 S, S the sum of the |terms| of the expanded
    formula; barring over- and underflow.
    """
    R_00, R_01, R_02, R_10, R_11, R_12, R_20, R_21, R_22 = R
    n_0 = R_11 * R_22 - R_12 * R_21
    n_1 = R_02 * R_21 - R_01 * R_22
    n_2 = R_01 * R_12 - R_02 * R_11
    det = R_00 * n_0 + R_10 * n_1 + R_20 * n_2
    return det


@kernel("(3,3)->(),(3,3)")
def mat3x3_inverse(R):
    """Ro = R^-1 = adj R / det R; returns det R, which is 0 or infinite where it under- or
    overflows.  Returns 0, with Ro = NaN, where R may be singular: |det R| <= 8 u p + 1e-29 m^3
    (double 1e-229 m^3), p the sum of the |terms| of det R, m the largest |entry|.

    (3,3)->(),(3,3).  R, Ro: rotation or other 3×3 matrix; det: number.
    56 mul, 17 add, 9 div, 1 neg, 19 abs, 16 less, 1 equal, 32 select.  Error of Ro_ij <= 2 u
    m_ji / |det R| + 6 u |Ro_ij| p / |det R|, m_ji the sum of the |terms| of the cofactor, or
    2^-80 m^2 (double 2^-700 m^2) if that is more; barring over- and underflow of Ro_ij itself.
    """
    R_00, R_01, R_02, R_10, R_11, R_12, R_20, R_21, R_22 = R
    R_size_0 = absolute(R_00)
    R_size_1 = absolute(R_01)
    R_size_2 = absolute(R_02)
    R_size_3 = absolute(R_10)
    R_size_4 = absolute(R_11)
    R_size_5 = absolute(R_12)
    R_size_6 = absolute(R_20)
    R_size_7 = absolute(R_21)
    R_size_8 = absolute(R_22)
    R_largest1 = where(R_size_0 < R_size_1, R_size_1, R_size_0)
    R_largest2 = where(R_largest1 < R_size_2, R_size_2, R_largest1)
    R_largest3 = where(R_largest2 < R_size_3, R_size_3, R_largest2)
    R_largest4 = where(R_largest3 < R_size_4, R_size_4, R_largest3)
    R_largest5 = where(R_largest4 < R_size_5, R_size_5, R_largest4)
    R_largest6 = where(R_largest5 < R_size_6, R_size_6, R_largest5)
    R_largest7 = where(R_largest6 < R_size_7, R_size_7, R_largest6)
    R_largest8 = where(R_largest7 < R_size_8, R_size_8, R_largest7)
    s_c = R_largest8 < 1.2089258196146292e+24
    s_e = R_largest8 < 1099511627776
    s_d = where(s_c, 9.094947017729282e-13, where(R_largest8 < 1.329227995784916e+36,
        real(8.271806125530277e-25), real(7.52316384526264e-37)))
    s_g = R_largest8 < 1
    s_i = R_largest8 < 9.094947017729282e-13
    s_k = R_largest8 < 8.271806125530277e-25
    s = where(s_k, 1.329227995784916e+36, where(s_i, 1.2089258196146292e+24, where(s_g,
        1099511627776, where(s_e, 1, s_d))))
    A_0 = R_00 * s
    A_1 = R_01 * s
    A_2 = R_02 * s
    A_3 = R_10 * s
    A_4 = R_11 * s
    A_5 = R_12 * s
    A_6 = R_20 * s
    A_7 = R_21 * s
    A_8 = R_22 * s
    n0_0 = A_4 * A_8 - A_5 * A_7
    n0_1 = A_2 * A_7 - A_1 * A_8
    n0_2 = A_1 * A_5 - A_2 * A_4
    n1_0 = A_5 * A_6 - A_3 * A_8
    n1_1 = A_0 * A_8 - A_2 * A_6
    n1_2 = A_2 * A_3 - A_0 * A_5
    n2_0 = A_3 * A_7 - A_4 * A_6
    n2_1 = A_1 * A_6 - A_0 * A_7
    n2_2 = A_0 * A_4 - A_1 * A_3
    d = A_0 * n0_0 + A_3 * n0_1 + A_6 * n0_2
    size0_0 = absolute(A_0)
    size0_1 = absolute(A_3)
    size0_2 = absolute(A_6)
    size1_0 = absolute(A_1)
    size1_1 = absolute(A_4)
    size1_2 = absolute(A_7)
    size2_0 = absolute(A_2)
    size2_1 = absolute(A_5)
    size2_2 = absolute(A_8)
    permanent_i = (size0_0 * (size1_1 * size2_2 + size1_2 * size2_1) + size0_1
        * (size1_0 * size2_2 + size1_2 * size2_0))
    permanent = permanent_i + size0_2 * (size1_0 * size2_1 + size1_1 * size2_0)
    top = R_largest8 * s
    spoiled = top * 1.262177448353619e-29
    least = permanent * 4.76837158203125e-07 + spoiled * (top * top)
    regular = where(least < absolute(d), real(1), real(0))
    divisor_a = regular == 1
    divisor = where(divisor_a, d, 1)
    quotient_0 = n0_0 / divisor
    quotient_1 = n0_1 / divisor
    quotient_2 = n0_2 / divisor
    quotient_3 = n1_0 / divisor
    quotient_4 = n1_1 / divisor
    quotient_5 = n1_2 / divisor
    quotient_6 = n2_0 / divisor
    quotient_7 = n2_1 / divisor
    quotient_8 = n2_2 / divisor
    inverse_0 = quotient_0 * s
    inverse_1 = quotient_1 * s
    inverse_2 = quotient_2 * s
    inverse_3 = quotient_3 * s
    inverse_4 = quotient_4 * s
    inverse_5 = quotient_5 * s
    inverse_6 = quotient_6 * s
    inverse_7 = quotient_7 * s
    inverse_8 = quotient_8 * s
    start = where(s_c, d, where(d < 0, -1.329227995784916e+36, 1.329227995784916e+36))
    r2 = where(s_i, real(7.52316384526264e-37), real(1))
    once = start * r2
    r3 = where(s_k, real(7.52316384526264e-37), real(1))
    twice = once * r3
    r = where(s_g, 7.52316384526264e-37, where(s_e, real(1), real(1.329227995784916e+36)))
    det_R = twice * r
    det = where(divisor_a, det_R, 0)
    Ro_00 = where(divisor_a, inverse_0, nan)
    Ro_01 = where(divisor_a, inverse_1, nan)
    Ro_02 = where(divisor_a, inverse_2, nan)
    Ro_10 = where(divisor_a, inverse_3, nan)
    Ro_11 = where(divisor_a, inverse_4, nan)
    Ro_12 = where(divisor_a, inverse_5, nan)
    Ro_20 = where(divisor_a, inverse_6, nan)
    Ro_21 = where(divisor_a, inverse_7, nan)
    Ro_22 = where(divisor_a, inverse_8, nan)
    return (det, Ro_00, Ro_01, Ro_02, Ro_10, Ro_11, Ro_12, Ro_20, Ro_21, Ro_22)


@kernel("(3,3)->(3,3)")
def mat3x3_normalize(self):
    """self = orthonormal rows by Gram–Schmidt: the first keeps its direction, the second stays on
    its side of the first, the third on its side of both; NaN where the rows are linearly
    dependent to rounding.

    (3,3)->(3,3).  self: rotation or other 3×3 matrix.
    60 mul, 23 add, 12 div, 4 sqrt, 3 neg, 10 abs, 24 less, 5 equal, 39 select.  |R R^T - I|_ij
    <= 8 u for the result R; searched, not proved.
    """
    self_00, self_01, self_02, self_10, self_11, self_12, self_20, self_21, self_22 = self
    q0_s_size_0 = absolute(self_00)
    q0_s_size_1 = absolute(self_01)
    q0_s_size_2 = absolute(self_02)
    q0_s_largest1 = where(q0_s_size_0 < q0_s_size_1, q0_s_size_1, q0_s_size_0)
    q0_s_largest2 = where(q0_s_largest1 < q0_s_size_2, q0_s_size_2, q0_s_largest1)
    q0_s_d = where(q0_s_largest2 < 256, 1.8014398509481984e+16,
        where(4.611686018427388e+18 < q0_s_largest2, real(2.710505431213761e-20), real(1)))
    q0_s = where(q0_s_largest2 < 1.4210854715202004e-14, 3.2451855365842673e+32, q0_s_d)
    q0_y_0 = self_00 * q0_s
    q0_y_1 = self_01 * q0_s
    q0_y_2 = self_02 * q0_s
    q0_up = where(1 < q0_s, q0_s, 1)
    q0_down = where(q0_s < 1, q0_s, 1)
    q0_n = sqrt(q0_y_0 * q0_y_0 + q0_y_1 * q0_y_1 + q0_y_2 * q0_y_2)
    q0_divisor = where(q0_n == 0, q0_up, q0_n)
    q0_sized_0 = self_00 * q0_up
    q0_sized_1 = self_01 * q0_up
    q0_sized_2 = self_02 * q0_up
    q0_quotient_0 = q0_sized_0 / q0_divisor
    q0_quotient_1 = q0_sized_1 / q0_divisor
    q0_quotient_2 = q0_sized_2 / q0_divisor
    q0_0 = q0_quotient_0 * q0_down
    q0_1 = q0_quotient_1 * q0_down
    q0_2 = q0_quotient_2 * q0_down
    u1_s_size_0 = absolute(self_10)
    u1_s_size_1 = absolute(self_11)
    u1_s_size_2 = absolute(self_12)
    u1_s_largest1 = where(u1_s_size_0 < u1_s_size_1, u1_s_size_1, u1_s_size_0)
    u1_s_largest2 = where(u1_s_largest1 < u1_s_size_2, u1_s_size_2, u1_s_largest1)
    u1_s_d = where(u1_s_largest2 < 256, 1.8014398509481984e+16,
        where(4.611686018427388e+18 < u1_s_largest2, real(2.710505431213761e-20), real(1)))
    u1_s = where(u1_s_largest2 < 1.4210854715202004e-14, 3.2451855365842673e+32, u1_s_d)
    u1_y_0 = self_10 * u1_s
    u1_y_1 = self_11 * u1_s
    u1_y_2 = self_12 * u1_s
    u1_up = where(1 < u1_s, u1_s, 1)
    u1_down = where(u1_s < 1, u1_s, 1)
    u1_n = sqrt(u1_y_0 * u1_y_0 + u1_y_1 * u1_y_1 + u1_y_2 * u1_y_2)
    u1_divisor = where(u1_n == 0, u1_up, u1_n)
    u1_sized_0 = self_10 * u1_up
    u1_sized_1 = self_11 * u1_up
    u1_sized_2 = self_12 * u1_up
    u1_quotient_0 = u1_sized_0 / u1_divisor
    u1_quotient_1 = u1_sized_1 / u1_divisor
    u1_quotient_2 = u1_sized_2 / u1_divisor
    u1_0 = u1_quotient_0 * u1_down
    u1_1 = u1_quotient_1 * u1_down
    u1_2 = u1_quotient_2 * u1_down
    along = q0_0 * u1_0 + q0_1 * u1_1 + q0_2 * u1_2
    once_0 = u1_0 - q0_0 * along
    once_1 = u1_1 - q0_1 * along
    once_2 = u1_2 - q0_2 * along
    rest = q0_0 * once_0 + q0_1 * once_1 + q0_2 * once_2
    twice_0 = once_0 - q0_0 * rest
    twice_1 = once_1 - q0_1 * rest
    twice_2 = once_2 - q0_2 * rest
    n = sqrt(twice_0 * twice_0 + twice_1 * twice_1 + twice_2 * twice_2)
    divisor = where(n == 0, 1, n)
    q1_0 = twice_0 / divisor
    q1_1 = twice_1 / divisor
    q1_2 = twice_2 / divisor
    normal_0 = q0_1 * q1_2 - q0_2 * q1_1
    normal_1 = q0_2 * q1_0 - q0_0 * q1_2
    normal_2 = q0_0 * q1_1 - q0_1 * q1_0
    u2_s_size_0 = absolute(self_20)
    u2_s_size_1 = absolute(self_21)
    u2_s_size_2 = absolute(self_22)
    u2_s_largest1 = where(u2_s_size_0 < u2_s_size_1, u2_s_size_1, u2_s_size_0)
    u2_s_largest2 = where(u2_s_largest1 < u2_s_size_2, u2_s_size_2, u2_s_largest1)
    u2_s_d = where(u2_s_largest2 < 256, 1.8014398509481984e+16,
        where(4.611686018427388e+18 < u2_s_largest2, real(2.710505431213761e-20), real(1)))
    u2_s = where(u2_s_largest2 < 1.4210854715202004e-14, 3.2451855365842673e+32, u2_s_d)
    u2_y_0 = self_20 * u2_s
    u2_y_1 = self_21 * u2_s
    u2_y_2 = self_22 * u2_s
    u2_up = where(1 < u2_s, u2_s, 1)
    u2_down = where(u2_s < 1, u2_s, 1)
    u2_n = sqrt(u2_y_0 * u2_y_0 + u2_y_1 * u2_y_1 + u2_y_2 * u2_y_2)
    u2_divisor = where(u2_n == 0, u2_up, u2_n)
    u2_sized_0 = self_20 * u2_up
    u2_sized_1 = self_21 * u2_up
    u2_sized_2 = self_22 * u2_up
    u2_quotient_0 = u2_sized_0 / u2_divisor
    u2_quotient_1 = u2_sized_1 / u2_divisor
    u2_quotient_2 = u2_sized_2 / u2_divisor
    u2_0 = u2_quotient_0 * u2_down
    u2_1 = u2_quotient_1 * u2_down
    u2_2 = u2_quotient_2 * u2_down
    side = normal_0 * u2_0 + normal_1 * u2_1 + normal_2 * u2_2
    q2_0b = side < 0
    q2_0 = where(q2_0b, -normal_0, normal_0)
    q2_1 = where(q2_0b, -normal_1, normal_1)
    q2_2 = where(q2_0b, -normal_2, normal_2)
    size = absolute(side)
    less = where(n < size, n, size)
    dependent = where(less < 9.5367431640625e-07, real(1), real(0))
    self_00_new_a = dependent == 1
    self_00_new = where(self_00_new_a, nan, q0_0)
    self_01_new = where(self_00_new_a, nan, q0_1)
    self_02_new = where(self_00_new_a, nan, q0_2)
    self_10_new = where(self_00_new_a, nan, q1_0)
    self_11_new = where(self_00_new_a, nan, q1_1)
    self_12_new = where(self_00_new_a, nan, q1_2)
    self_20_new = where(self_00_new_a, nan, q2_0)
    self_21_new = where(self_00_new_a, nan, q2_1)
    self_22_new = where(self_00_new_a, nan, q2_2)
    return (self_00_new, self_01_new, self_02_new, self_10_new, self_11_new, self_12_new,
        self_20_new, self_21_new, self_22_new)


@kernel("(3,3)->(3,3)")
def mat3x3_normalized(R):
    """Ro = orthonormal rows by Gram–Schmidt: the first keeps its direction, the second stays on
    its side of the first, the third on its side of both; NaN where the rows are linearly
    dependent to rounding.

    (3,3)->(3,3).  R, Ro: rotation or other 3×3 matrix.
    60 mul, 23 add, 12 div, 4 sqrt, 3 neg, 10 abs, 24 less, 5 equal, 39 select.  |R R^T - I|_ij
    <= 8 u for the result R; searched, not proved.
    """
    R_00, R_01, R_02, R_10, R_11, R_12, R_20, R_21, R_22 = R
    q0_s_size_0 = absolute(R_00)
    q0_s_size_1 = absolute(R_01)
    q0_s_size_2 = absolute(R_02)
    q0_s_largest1 = where(q0_s_size_0 < q0_s_size_1, q0_s_size_1, q0_s_size_0)
    q0_s_largest2 = where(q0_s_largest1 < q0_s_size_2, q0_s_size_2, q0_s_largest1)
    q0_s_d = where(q0_s_largest2 < 256, 1.8014398509481984e+16,
        where(4.611686018427388e+18 < q0_s_largest2, real(2.710505431213761e-20), real(1)))
    q0_s = where(q0_s_largest2 < 1.4210854715202004e-14, 3.2451855365842673e+32, q0_s_d)
    q0_y_0 = R_00 * q0_s
    q0_y_1 = R_01 * q0_s
    q0_y_2 = R_02 * q0_s
    q0_up = where(1 < q0_s, q0_s, 1)
    q0_down = where(q0_s < 1, q0_s, 1)
    q0_n = sqrt(q0_y_0 * q0_y_0 + q0_y_1 * q0_y_1 + q0_y_2 * q0_y_2)
    q0_divisor = where(q0_n == 0, q0_up, q0_n)
    q0_sized_0 = R_00 * q0_up
    q0_sized_1 = R_01 * q0_up
    q0_sized_2 = R_02 * q0_up
    q0_quotient_0 = q0_sized_0 / q0_divisor
    q0_quotient_1 = q0_sized_1 / q0_divisor
    q0_quotient_2 = q0_sized_2 / q0_divisor
    q0_0 = q0_quotient_0 * q0_down
    q0_1 = q0_quotient_1 * q0_down
    q0_2 = q0_quotient_2 * q0_down
    u1_s_size_0 = absolute(R_10)
    u1_s_size_1 = absolute(R_11)
    u1_s_size_2 = absolute(R_12)
    u1_s_largest1 = where(u1_s_size_0 < u1_s_size_1, u1_s_size_1, u1_s_size_0)
    u1_s_largest2 = where(u1_s_largest1 < u1_s_size_2, u1_s_size_2, u1_s_largest1)
    u1_s_d = where(u1_s_largest2 < 256, 1.8014398509481984e+16,
        where(4.611686018427388e+18 < u1_s_largest2, real(2.710505431213761e-20), real(1)))
    u1_s = where(u1_s_largest2 < 1.4210854715202004e-14, 3.2451855365842673e+32, u1_s_d)
    u1_y_0 = R_10 * u1_s
    u1_y_1 = R_11 * u1_s
    u1_y_2 = R_12 * u1_s
    u1_up = where(1 < u1_s, u1_s, 1)
    u1_down = where(u1_s < 1, u1_s, 1)
    u1_n = sqrt(u1_y_0 * u1_y_0 + u1_y_1 * u1_y_1 + u1_y_2 * u1_y_2)
    u1_divisor = where(u1_n == 0, u1_up, u1_n)
    u1_sized_0 = R_10 * u1_up
    u1_sized_1 = R_11 * u1_up
    u1_sized_2 = R_12 * u1_up
    u1_quotient_0 = u1_sized_0 / u1_divisor
    u1_quotient_1 = u1_sized_1 / u1_divisor
    u1_quotient_2 = u1_sized_2 / u1_divisor
    u1_0 = u1_quotient_0 * u1_down
    u1_1 = u1_quotient_1 * u1_down
    u1_2 = u1_quotient_2 * u1_down
    along = q0_0 * u1_0 + q0_1 * u1_1 + q0_2 * u1_2
    once_0 = u1_0 - q0_0 * along
    once_1 = u1_1 - q0_1 * along
    once_2 = u1_2 - q0_2 * along
    rest = q0_0 * once_0 + q0_1 * once_1 + q0_2 * once_2
    twice_0 = once_0 - q0_0 * rest
    twice_1 = once_1 - q0_1 * rest
    twice_2 = once_2 - q0_2 * rest
    n = sqrt(twice_0 * twice_0 + twice_1 * twice_1 + twice_2 * twice_2)
    divisor = where(n == 0, 1, n)
    q1_0 = twice_0 / divisor
    q1_1 = twice_1 / divisor
    q1_2 = twice_2 / divisor
    normal_0 = q0_1 * q1_2 - q0_2 * q1_1
    normal_1 = q0_2 * q1_0 - q0_0 * q1_2
    normal_2 = q0_0 * q1_1 - q0_1 * q1_0
    u2_s_size_0 = absolute(R_20)
    u2_s_size_1 = absolute(R_21)
    u2_s_size_2 = absolute(R_22)
    u2_s_largest1 = where(u2_s_size_0 < u2_s_size_1, u2_s_size_1, u2_s_size_0)
    u2_s_largest2 = where(u2_s_largest1 < u2_s_size_2, u2_s_size_2, u2_s_largest1)
    u2_s_d = where(u2_s_largest2 < 256, 1.8014398509481984e+16,
        where(4.611686018427388e+18 < u2_s_largest2, real(2.710505431213761e-20), real(1)))
    u2_s = where(u2_s_largest2 < 1.4210854715202004e-14, 3.2451855365842673e+32, u2_s_d)
    u2_y_0 = R_20 * u2_s
    u2_y_1 = R_21 * u2_s
    u2_y_2 = R_22 * u2_s
    u2_up = where(1 < u2_s, u2_s, 1)
    u2_down = where(u2_s < 1, u2_s, 1)
    u2_n = sqrt(u2_y_0 * u2_y_0 + u2_y_1 * u2_y_1 + u2_y_2 * u2_y_2)
    u2_divisor = where(u2_n == 0, u2_up, u2_n)
    u2_sized_0 = R_20 * u2_up
    u2_sized_1 = R_21 * u2_up
    u2_sized_2 = R_22 * u2_up
    u2_quotient_0 = u2_sized_0 / u2_divisor
    u2_quotient_1 = u2_sized_1 / u2_divisor
    u2_quotient_2 = u2_sized_2 / u2_divisor
    u2_0 = u2_quotient_0 * u2_down
    u2_1 = u2_quotient_1 * u2_down
    u2_2 = u2_quotient_2 * u2_down
    side = normal_0 * u2_0 + normal_1 * u2_1 + normal_2 * u2_2
    q2_0b = side < 0
    q2_0 = where(q2_0b, -normal_0, normal_0)
    q2_1 = where(q2_0b, -normal_1, normal_1)
    q2_2 = where(q2_0b, -normal_2, normal_2)
    size = absolute(side)
    less = where(n < size, n, size)
    dependent = where(less < 9.5367431640625e-07, real(1), real(0))
    Ro_00a = dependent == 1
    Ro_00 = where(Ro_00a, nan, q0_0)
    Ro_01 = where(Ro_00a, nan, q0_1)
    Ro_02 = where(Ro_00a, nan, q0_2)
    Ro_10 = where(Ro_00a, nan, q1_0)
    Ro_11 = where(Ro_00a, nan, q1_1)
    Ro_12 = where(Ro_00a, nan, q1_2)
    Ro_20 = where(Ro_00a, nan, q2_0)
    Ro_21 = where(Ro_00a, nan, q2_1)
    Ro_22 = where(Ro_00a, nan, q2_2)
    return (Ro_00, Ro_01, Ro_02, Ro_10, Ro_11, Ro_12, Ro_20, Ro_21, Ro_22)


@kernel("(3),(2)->(3,3)")
def mat3x3_setFromAxisDC(axis, dc):
    """R = cos θ I + sin θ a~ + (1 - cos θ) a a^T, a = axis of length 1 (else R is not a rotation),
    dc = (sin θ, cos θ).

    (3),(2)->(3,3).  axis: vector; dc: (sin θ, cos θ); R: rotation or other 3×3 matrix.
    12 mul, 10 add.  Error <= u |result| + 1/8 u^2 S, S the sum of the |terms| of the expanded
    formula; barring over- and underflow.
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
    return (R_00, R_01, R_02, R_10, R_11, R_12, R_20, R_21, R_22)


@kernel("(3)->(3,3)")
def mat3x3_from_euler_xyz(angles):
    """R = R_x(a) R_y(b) R_z(c), angles = (a, b, c).

    (3)->(3,3).  angles: vector; R: rotation or other 3×3 matrix.
    98 mul, 103 add, 3 neg, 3 abs.  Each component is within 1 ulp as long as its condition is
    below 1e13; in single precision it is the nearest number, except near ties, as long as that
    is below 1e5; searched, not proved.
    """
    angles_0, angles_1, angles_2 = angles
    s_0, c_0 = elementary.sincos(angles_0)
    s_1, c_1 = elementary.sincos(angles_1)
    s_2, c_2 = elementary.sincos(angles_2)
    first_0 = c_1 * c_2
    first_1 = -(s_2 * c_1)
    first_6 = -(s_1 * c_2)
    first_7 = s_1 * s_2
    last_3 = s_2 * c_0 - s_0 * first_6
    last_4 = c_0 * c_2 - s_0 * first_7
    last_5 = -(s_0 * c_1)
    last_6 = s_0 * s_2 + c_0 * first_6
    last_7 = s_0 * c_2 + c_0 * first_7
    last_8 = c_0 * c_1
    return (first_0, first_1, s_1, last_3, last_4, last_5, last_6, last_7, last_8)


@kernel("(3,3)->(3)")
def euler_xyz_from_mat3x3(R):
    """angles of the rotation R = R_x(a) R_y(b) R_z(c), angles = (a, b, c); a, c in [-π, π], b in
    [-π/2, π/2]; c = 0 in gimbal lock.

    (3,3)->(3).  R: rotation or other 3×3 matrix; angles: vector.
    93 mul, 109 add, 5 div, 1 sqrt, 4 neg, 6 abs, 6 copysign, 19 less, 4 equal, 46 select.  Each
    component is within 1 ulp as long as its condition is below 1e13; in single precision it is
    the nearest number, except near ties, as long as that is below 1e5; searched, not proved.
    """
    R_00, R_01, R_02, R_10, R_11, R_12, R_20, R_21, R_22 = R
    n = sqrt(R_00 * R_00 + R_01 * R_01)
    divisor_a = n == 0
    divisor = where(divisor_a, 1, n)
    cosine = where(divisor_a, 1, R_00 / divisor)
    sine_a = -R_01
    sine = sine_a / divisor
    polar = elementary.atan2(sine_a, R_00)
    third = where(divisor_a, 0, polar)
    left_1 = R_10 * sine + R_11 * cosine
    left_2 = R_20 * sine + R_21 * cosine
    rest = R_12 + R_22
    first = elementary.atan2(left_2, left_1)
    angles_0 = where(rest < 1.2676506002282294e+30, first, rest)
    angles_1 = elementary.atan2(R_02, n)
    return (angles_0, angles_1, third)


@kernel("(3)->(3,3)")
def mat3x3_from_euler_xyx(angles):
    """R = R_x(a) R_y(b) R_x(c), angles = (a, b, c).

    (3)->(3,3).  angles: vector; R: rotation or other 3×3 matrix.
    98 mul, 103 add, 2 neg, 3 abs.  Each component is within 1 ulp as long as its condition is
    below 1e13; in single precision it is the nearest number, except near ties, as long as that
    is below 1e5; searched, not proved.
    """
    angles_0, angles_1, angles_2 = angles
    s_0, c_0 = elementary.sincos(angles_0)
    s_1, c_1 = elementary.sincos(angles_1)
    s_2, c_2 = elementary.sincos(angles_2)
    first_1 = s_1 * s_2
    first_2 = s_1 * c_2
    first_7 = s_2 * c_1
    first_8 = c_1 * c_2
    last_3 = s_0 * s_1
    last_4 = c_0 * c_2 - s_0 * first_7
    last_5 = -(s_0 * first_8) - s_2 * c_0
    last_6 = -(s_1 * c_0)
    last_7 = s_0 * c_2 + c_0 * first_7
    last_8 = c_0 * first_8 - s_0 * s_2
    return (c_1, first_1, first_2, last_3, last_4, last_5, last_6, last_7, last_8)


@kernel("(3,3)->(3)")
def euler_xyx_from_mat3x3(R):
    """angles of the rotation R = R_x(a) R_y(b) R_x(c), angles = (a, b, c); a, c in [-π, π], b in
    [0, π]; c = 0 in gimbal lock.

    (3,3)->(3).  R: rotation or other 3×3 matrix; angles: vector.
    93 mul, 109 add, 5 div, 1 sqrt, 3 neg, 6 abs, 6 copysign, 19 less, 4 equal, 46 select.  Each
    component is within 1 ulp as long as its condition is below 1e13; in single precision it is
    the nearest number, except near ties, as long as that is below 1e5; searched, not proved.
    """
    R_00, R_01, R_02, R_10, R_11, R_12, R_20, R_21, R_22 = R
    n = sqrt(R_01 * R_01 + R_02 * R_02)
    divisor_a = n == 0
    divisor = where(divisor_a, 1, n)
    cosine = where(divisor_a, 1, R_02 / divisor)
    sine = R_01 / divisor
    polar = elementary.atan2(R_01, R_02)
    third = where(divisor_a, 0, polar)
    left_1 = R_11 * cosine - R_12 * sine
    left_2 = R_21 * cosine - R_22 * sine
    rest = R_10 + R_20
    first = elementary.atan2(left_2, left_1)
    angles_0 = where(rest < 1.2676506002282294e+30, first, rest)
    angles_1 = elementary.atan2(n, R_00)
    return (angles_0, angles_1, third)


@kernel("(3,3),(3,3)->(3,3),(3,3)")
def mat3x3_jacobi(A, V):
    """A = J^T A J, V = V J: Jacobi's rotation J in the xy plane, by the smaller angle that makes
    A_xy zero; then y, z, x become x, y, z.  A is symmetric, only its lower triangle is read.
    Repeated from V = I, it converges to A = diag(eigenvalues); V A V^T does not change.

    (3,3),(3,3)->(3,3),(3,3).  A, V: rotation or other 3×3 matrix.
    21 mul, 14 add, 3 div, 2 sqrt, 1 neg, 1 abs, 1 less, 1 equal, 3 select.  V A V^T changes by
    at most 28 u max |A| for orthonormal V; searched, not proved.
    """
    A_00, A_01, A_02, A_10, A_11, A_12, A_20, A_21, A_22 = A
    V_00, V_01, V_02, V_10, V_11, V_12, V_20, V_21, V_22 = V
    twice = 2 * A_10
    apart = A_11 - A_00
    divisor_a = twice == 0
    divisor = where(divisor_a, 1, twice)
    theta = apart / divisor
    magnitude = absolute(theta)
    size = magnitude + sqrt(1 + theta * theta)
    along = where(theta < 0, -size, size)
    t = where(divisor_a, 0, 1 / along)
    secant = sqrt(1 + t * t)
    c = 1 / secant
    s = t * c
    change = A_10 * t
    zp = A_20 * c - A_21 * s
    zq = A_20 * s + A_21 * c
    vp_0 = V_00 * c - V_01 * s
    vp_1 = V_10 * c - V_11 * s
    vp_2 = V_20 * c - V_21 * s
    vq_0 = V_00 * s + V_01 * c
    vq_1 = V_10 * s + V_11 * c
    vq_2 = V_20 * s + V_21 * c
    A_00_new = A_11 + change
    A_22_new = A_00 - change
    return (A_00_new, zq, 0, zq, A_22, zp, 0, zp, A_22_new, vq_0, V_02, vp_0, vq_1, V_12, vp_1,
        vq_2, V_22, vp_2)


@kernel("(3,3)->()")
def mat3x3_rotation_defect(R):
    """the largest of |det R - 1| and |R^T R - I|_ij: 0 for a rotation, 2 for a reflection, NaN if
    an entry is NaN.

    (3,3)->().  R: rotation or other 3×3 matrix; defect: number.
    27 mul, 21 add, 7 abs, 6 less, 6 select.  Error <= 6 u near a rotation; measured, not
    proved.
    """
    R_00, R_01, R_02, R_10, R_11, R_12, R_20, R_21, R_22 = R
    n_0 = R_11 * R_22 - R_12 * R_21
    n_1 = R_02 * R_21 - R_01 * R_22
    n_2 = R_01 * R_12 - R_02 * R_11
    det = R_00 * n_0 + R_10 * n_1 + R_20 * n_2
    g_0 = R_00 * R_00 + R_10 * R_10 + R_20 * R_20
    g_1 = R_00 * R_01 + R_10 * R_11 + R_20 * R_21
    g_2 = R_00 * R_02 + R_10 * R_12 + R_20 * R_22
    g_3 = R_01 * R_01 + R_11 * R_11 + R_21 * R_21
    g_4 = R_01 * R_02 + R_11 * R_12 + R_21 * R_22
    g_5 = R_02 * R_02 + R_12 * R_12 + R_22 * R_22
    off_0 = det - 1
    off_1 = g_0 - 1
    off_4 = g_3 - 1
    off_6 = g_5 - 1
    defect_size_0 = absolute(off_0)
    defect_size_1 = absolute(off_1)
    defect_size_2 = absolute(g_1)
    defect_size_3 = absolute(g_2)
    defect_size_4 = absolute(off_4)
    defect_size_5 = absolute(g_4)
    defect_size_6 = absolute(off_6)
    defect_largest1 = where(defect_size_0 < defect_size_1, defect_size_1, defect_size_0)
    defect_largest2 = where(defect_largest1 < defect_size_2, defect_size_2, defect_largest1)
    defect_largest3 = where(defect_largest2 < defect_size_3, defect_size_3, defect_largest2)
    defect_largest4 = where(defect_largest3 < defect_size_4, defect_size_4, defect_largest3)
    defect_largest5 = where(defect_largest4 < defect_size_5, defect_size_5, defect_largest4)
    defect_largest6 = where(defect_largest5 < defect_size_6, defect_size_6, defect_largest5)
    return defect_largest6


@kernel("(3),()->(3,3)")
def mat3x3_from_axis_angle(axis, angle):
    """R = I + sin(angle) axis~ + (1 - cos(angle)) axis~^2, for an axis of length 1; otherwise R is
    not a rotation.

    (3),()->(3,3).  axis: vector; angle: number; R: rotation or other 3×3 matrix.
    71 mul, 79 add, 2 abs, 1 less, 1 select.  Error <= R: 1 u of its largest component for
    |axis| = 1; searched, not proved.  Each component is within 1 ulp as long as its condition
    is below 1e13; in single precision it is the nearest number, except near ties, as long as
    that is below 1e5; searched, not proved.
    """
    axis_0, axis_1, axis_2 = axis
    half = 0.5 * angle
    h = elementary.sin(half)
    sine, cosine = elementary.sincos(angle)
    versine = where(cosine < 0, 1 - cosine, 2 * (h * h))
    beta_v_0 = axis_0 * versine
    beta_v_1 = axis_1 * versine
    beta_v_2 = axis_2 * versine
    m_0 = axis_0 * beta_v_0
    m_1 = axis_1 * beta_v_1
    m_2 = axis_2 * beta_v_2
    m_3 = axis_1 * beta_v_0
    m_4 = axis_2 * beta_v_0
    m_5 = axis_2 * beta_v_1
    others_0 = m_1 + m_2
    others_1 = m_0 + m_2
    others_2 = m_0 + m_1
    alpha_v_0 = axis_0 * sine
    alpha_v_1 = axis_1 * sine
    alpha_v_2 = axis_2 * sine
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


@kernel("(3,3)->(),(3)")
def axis_angle_from_mat3x3(R):
    """angle and axis of the rotation R; 0 <= angle <= π; the axis is (1, 0, 0) if the angle is 0.

    (3,3)->(),(3).  R: rotation or other 3×3 matrix; angle: number; axis: vector.
    37 mul, 51 add, 4 div, 1 sqrt, 6 neg, 5 abs, 2 copysign, 18 less, 2 equal, 40 select.  Error
    <= angle: 1 u, axis: 1 u of its largest component for R a rotation; searched, not proved.
    Each component is within 1 ulp as long as its condition is below 1e13; in single precision
    it is the nearest number, except near ties, as long as that is below 1e5; searched, not
    proved.
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
    divisor_a = v_n == 0
    divisor = where(divisor_a, 1, v_n)
    unit_0 = v_y_0 / divisor
    unit_1 = v_y_1 / divisor
    unit_2 = v_y_2 / divisor
    angle = 2 * half
    axis_0 = where(divisor_a, 1, unit_0)
    return (angle, axis_0, unit_1, unit_2)
