# Made by `coscrew generate`; changes are overwritten.
# SPDX-License-Identifier: MIT
# coscrew 0.2.0.  Copyright (c) 2026 The coscrew authors.
"""3×3 matrices: rotations, and matrices in general.

In double precision, plain tier.
"""

from coscrew import _elementary_double as elementary
from numpy import absolute, float64 as real, nan, sqrt, where
from coscrew._kernel import double_kernel as kernel


@kernel("(3,3)->(3,3)")
def mat3x3_copy(R):
    """Ro = R.

    (3,3)->(3,3).  R, Ro: rotation or other 3×3 matrix.
    No arithmetic.  Exact.
    """
    R_00, R_01, R_02, R_10, R_11, R_12, R_20, R_21, R_22 = R
    return (R_00, R_01, R_02, R_10, R_11, R_12, R_20, R_21, R_22)


@kernel("(3,3)->(3,3)")
def mat3x3_setIdentity(self):
    """self = I.

    (3,3)->(3,3).  self: rotation or other 3×3 matrix.
    No arithmetic.  Exact.
    """
    return (1, 0, 0, 0, 1, 0, 0, 0, 1)


@kernel("(3),(3),(3)->(3,3)")
def mat3x3_setFromVectors(x, y, z):
    """R = [x y z], the columns.

    (3),(3),(3)->(3,3).  x, y, z: vector; R: rotation or other 3×3 matrix.
    No arithmetic.  Exact.
    """
    x_0, x_1, x_2 = x
    y_0, y_1, y_2 = y
    z_0, z_1, z_2 = z
    return (x_0, y_0, z_0, x_1, y_1, z_1, x_2, y_2, z_2)


@kernel("(3)->(3,3)")
def skew(v):
    """Ro = v~, the matrix with v~ y = v × y.

    (3)->(3,3).  v: vector; Ro: rotation or other 3×3 matrix.
    3 neg.  Exact.
    """
    v_0, v_1, v_2 = v
    Ro_01 = -v_2
    Ro_12 = -v_0
    Ro_20 = -v_1
    return (0, Ro_01, v_1, v_2, 0, Ro_12, Ro_20, v_0, 0)


@kernel("(3),(3)->(3,3)")
def acceleration_tensor(w, dw):
    """Ro = w'~ + w~ w~ of a body with angular velocity w and angular acceleration w' = dw: the
    acceleration of its point x, less that of its origin, is Ro x.

    (3),(3)->(3,3).  w, dw: vector; Ro: rotation or other 3×3 matrix.
    6 mul, 9 add, 3 neg.  Error <= u |result| + 1 u S, S the sum of the |terms| of the expanded
    formula; barring over- and underflow.
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
    return (Ro_00, Ro_01, Ro_02, Ro_10, Ro_11, Ro_12, Ro_20, Ro_21, Ro_22)


@kernel("(3,3)->(3,3)")
def mat3x3_transpose(self):
    """self = self^T, the inverse of a rotation.

    (3,3)->(3,3).  self: rotation or other 3×3 matrix.
    No arithmetic.  Exact.
    """
    self_00, self_01, self_02, self_10, self_11, self_12, self_20, self_21, self_22 = self
    return (self_00, self_10, self_20, self_01, self_11, self_21, self_02, self_12, self_22)


@kernel("(3,3)->(3,3)")
def mat3x3_transposed(R):
    """Ro = R^T, the inverse of a rotation.

    (3,3)->(3,3).  R, Ro: rotation or other 3×3 matrix.
    No arithmetic.  Exact.
    """
    R_00, R_01, R_02, R_10, R_11, R_12, R_20, R_21, R_22 = R
    return (R_00, R_10, R_20, R_01, R_11, R_21, R_02, R_12, R_22)


@kernel("(3,3)->()")
def mat3x3_determinant(R):
    """det R.

    (3,3)->().  R: rotation or other 3×3 matrix; det: number.
    9 mul, 5 add.  Error <= u |result| + 4 u S, S the sum of the |terms| of the expanded
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
    s_c = R_largest8 < 4.149515568880993e+180
    s_e = R_largest8 < 2.037035976334486e+90
    s_d = where(s_c, 4.909093465297727e-91, where(R_largest8 < 8.452712498170644e+270,
        real(2.409919865102884e-181), real(1.1830521861667747e-271)))
    s_g = R_largest8 < 1
    s_i = R_largest8 < 4.909093465297727e-91
    s_k = R_largest8 < 2.409919865102884e-181
    s = where(s_k, 8.452712498170644e+270, where(s_i, 4.149515568880993e+180, where(s_g,
        2.037035976334486e+90, where(s_e, 1, s_d))))
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
    spoiled = top * 1.6489340850168661e-229
    least = permanent * 8.881784197001252e-16 + spoiled * (top * top)
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
    start = where(s_c, d, where(d < 0, -8.452712498170644e+270, 8.452712498170644e+270))
    r2 = where(s_i, real(1.1830521861667747e-271), real(1))
    once = start * r2
    r3 = where(s_k, real(1.1830521861667747e-271), real(1))
    twice = once * r3
    r = where(s_g, 1.1830521861667747e-271, where(s_e, real(1), real(8.452712498170644e+270)))
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
    q0_s_d = where(q0_s_largest2 < 256, 1.3093562431584567e+151,
        where(6.703903964971299e+153 < q0_s_largest2, real(3.7291703656001034e-155), real(1)))
    q0_s = where(q0_s_largest2 < 1.955159272639747e-149, 1.0715086071862673e+301, q0_s_d)
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
    u1_s_d = where(u1_s_largest2 < 256, 1.3093562431584567e+151,
        where(6.703903964971299e+153 < u1_s_largest2, real(3.7291703656001034e-155), real(1)))
    u1_s = where(u1_s_largest2 < 1.955159272639747e-149, 1.0715086071862673e+301, u1_s_d)
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
    u2_s_d = where(u2_s_largest2 < 256, 1.3093562431584567e+151,
        where(6.703903964971299e+153 < u2_s_largest2, real(3.7291703656001034e-155), real(1)))
    u2_s = where(u2_s_largest2 < 1.955159272639747e-149, 1.0715086071862673e+301, u2_s_d)
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
    dependent = where(less < 1.7763568394002505e-15, real(1), real(0))
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
    q0_s_d = where(q0_s_largest2 < 256, 1.3093562431584567e+151,
        where(6.703903964971299e+153 < q0_s_largest2, real(3.7291703656001034e-155), real(1)))
    q0_s = where(q0_s_largest2 < 1.955159272639747e-149, 1.0715086071862673e+301, q0_s_d)
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
    u1_s_d = where(u1_s_largest2 < 256, 1.3093562431584567e+151,
        where(6.703903964971299e+153 < u1_s_largest2, real(3.7291703656001034e-155), real(1)))
    u1_s = where(u1_s_largest2 < 1.955159272639747e-149, 1.0715086071862673e+301, u1_s_d)
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
    u2_s_d = where(u2_s_largest2 < 256, 1.3093562431584567e+151,
        where(6.703903964971299e+153 < u2_s_largest2, real(3.7291703656001034e-155), real(1)))
    u2_s = where(u2_s_largest2 < 1.955159272639747e-149, 1.0715086071862673e+301, u2_s_d)
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
    dependent = where(less < 1.7763568394002505e-15, real(1), real(0))
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
    12 mul, 10 add.  Error <= u |result| + 3 u S, S the sum of the |terms| of the expanded
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
    98 mul, 103 add, 3 neg, 3 abs.
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
    93 mul, 109 add, 5 div, 1 sqrt, 4 neg, 6 abs, 6 copysign, 19 less, 4 equal, 46 select.  The
    rotation by these angles differs from R by at most 12 u in each entry, near gimbal lock too;
    searched, not proved.
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
    98 mul, 103 add, 2 neg, 3 abs.
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
    last_5 = -(s_0 * first_8 + s_2 * c_0)
    last_6 = -(s_1 * c_0)
    last_7 = s_0 * c_2 + c_0 * first_7
    last_8 = c_0 * first_8 - s_0 * s_2
    return (c_1, first_1, first_2, last_3, last_4, last_5, last_6, last_7, last_8)


@kernel("(3,3)->(3)")
def euler_xyx_from_mat3x3(R):
    """angles of the rotation R = R_x(a) R_y(b) R_x(c), angles = (a, b, c); a, c in [-π, π], b in
    [0, π]; c = 0 in gimbal lock.

    (3,3)->(3).  R: rotation or other 3×3 matrix; angles: vector.
    93 mul, 109 add, 5 div, 1 sqrt, 3 neg, 6 abs, 6 copysign, 19 less, 4 equal, 46 select.  The
    rotation by these angles differs from R by at most 12 u in each entry, near gimbal lock too;
    searched, not proved.
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


@kernel("(3,3)->(3,3)")
def mat3x3_nearest_rotation(A):
    """Ro = the rotation nearest to A, U diag(1, 1, ±1) V^T of A = U diag(s1, s2, s3) V^T: no
    rotation R has a larger tr R^T A or a smaller |R - A|.  For every finite A but 0, for which
    it is NaN; where several are equally near (s2 ± s3 = 0: reflections with s2 = s3, matrices
    of rank 1) one of them.

    (3,3)->(3,3).  A, Ro: rotation or other 3×3 matrix.
    649 mul, 400 add, 51 div, 32 sqrt, 37 neg, 42 abs, 60 less, 34 equal, 169 select.  |Ro -
    nearest|_F <= 16 u s1 / (s2 ± s3), + if det A > 0, and |Ro^T Ro - I|_ij <= 6 u; measured,
    not proved.
    """
    A_00, A_01, A_02, A_10, A_11, A_12, A_20, A_21, A_22 = A
    s_size_0 = absolute(A_00)
    s_size_1 = absolute(A_01)
    s_size_2 = absolute(A_02)
    s_size_3 = absolute(A_10)
    s_size_4 = absolute(A_11)
    s_size_5 = absolute(A_12)
    s_size_6 = absolute(A_20)
    s_size_7 = absolute(A_21)
    s_size_8 = absolute(A_22)
    s_largest1 = where(s_size_0 < s_size_1, s_size_1, s_size_0)
    s_largest2 = where(s_largest1 < s_size_2, s_size_2, s_largest1)
    s_largest3 = where(s_largest2 < s_size_3, s_size_3, s_largest2)
    s_largest4 = where(s_largest3 < s_size_4, s_size_4, s_largest3)
    s_largest5 = where(s_largest4 < s_size_5, s_size_5, s_largest4)
    s_largest6 = where(s_largest5 < s_size_6, s_size_6, s_largest5)
    s_largest7 = where(s_largest6 < s_size_7, s_size_7, s_largest6)
    s_largest8 = where(s_largest7 < s_size_8, s_size_8, s_largest7)
    s_d = where(s_largest8 < 256, 1.3093562431584567e+151,
        where(6.703903964971299e+153 < s_largest8, real(3.7291703656001034e-155), real(1)))
    s = where(s_largest8 < 1.955159272639747e-149, 1.0715086071862673e+301, s_d)
    scaled_s_0 = A_00 * s
    scaled_s_1 = A_01 * s
    scaled_s_2 = A_02 * s
    scaled_s_3 = A_10 * s
    scaled_s_4 = A_11 * s
    scaled_s_5 = A_12 * s
    scaled_s_6 = A_20 * s
    scaled_s_7 = A_21 * s
    scaled_s_8 = A_22 * s
    turn001_aa = scaled_s_0 * scaled_s_0 + scaled_s_3 * scaled_s_3 + scaled_s_6 * scaled_s_6
    turn001_bb = scaled_s_1 * scaled_s_1 + scaled_s_4 * scaled_s_4 + scaled_s_7 * scaled_s_7
    turn001_g = scaled_s_0 * scaled_s_1 + scaled_s_3 * scaled_s_4 + scaled_s_6 * scaled_s_7
    turn001_apart = turn001_bb - turn001_aa
    turn001_e = 0.5 * turn001_apart
    turn001_size_g = absolute(turn001_g)
    turn001_size_e = absolute(turn001_e)
    turn001_above_a = turn001_size_g < turn001_size_e
    turn001_above = where(turn001_above_a, turn001_g, turn001_e)
    turn001_below = where(turn001_above_a, turn001_e, turn001_g)
    turn001_divisor = where(turn001_below == 0, 1, turn001_below)
    turn001_ratio = turn001_above / turn001_divisor
    turn001_root = sqrt(1 + turn001_ratio * turn001_ratio)
    turn001_signed = where(turn001_ratio < 0, -turn001_root, turn001_root)
    turn001_top = where(turn001_above_a, turn001_ratio, 1)
    turn001_bottom = where(turn001_above_a, turn001_root + 1, turn001_ratio + turn001_signed)
    turn001_t = turn001_top / turn001_bottom
    turn001_tangent = where(turn001_g == 0, 0, turn001_t)
    turn001_secant = sqrt(1 + turn001_tangent * turn001_tangent)
    turn001_cosine = 1 / turn001_secant
    turn001_sine = turn001_tangent * turn001_cosine
    turn001_p_a = turn001_aa < turn001_bb
    turn001_p = where(turn001_p_a, turn001_sine, turn001_cosine)
    turn001_q = where(turn001_p_a, -turn001_cosine, turn001_sine)
    turn001_a_0 = scaled_s_0 * turn001_p - scaled_s_1 * turn001_q
    turn001_a_1 = scaled_s_3 * turn001_p - scaled_s_4 * turn001_q
    turn001_a_2 = scaled_s_6 * turn001_p - scaled_s_7 * turn001_q
    turn001_b_0 = scaled_s_0 * turn001_q + scaled_s_1 * turn001_p
    turn001_b_1 = scaled_s_3 * turn001_q + scaled_s_4 * turn001_p
    turn001_b_2 = scaled_s_6 * turn001_q + scaled_s_7 * turn001_p
    turn002_aa = turn001_a_0 * turn001_a_0 + turn001_a_1 * turn001_a_1 + turn001_a_2 * turn001_a_2
    turn002_bb = scaled_s_2 * scaled_s_2 + scaled_s_5 * scaled_s_5 + scaled_s_8 * scaled_s_8
    turn002_g = scaled_s_2 * turn001_a_0 + scaled_s_5 * turn001_a_1 + scaled_s_8 * turn001_a_2
    turn002_apart = turn002_bb - turn002_aa
    turn002_e = 0.5 * turn002_apart
    turn002_size_g = absolute(turn002_g)
    turn002_size_e = absolute(turn002_e)
    turn002_above_a = turn002_size_g < turn002_size_e
    turn002_above = where(turn002_above_a, turn002_g, turn002_e)
    turn002_below = where(turn002_above_a, turn002_e, turn002_g)
    turn002_divisor = where(turn002_below == 0, 1, turn002_below)
    turn002_ratio = turn002_above / turn002_divisor
    turn002_root = sqrt(1 + turn002_ratio * turn002_ratio)
    turn002_signed = where(turn002_ratio < 0, -turn002_root, turn002_root)
    turn002_top = where(turn002_above_a, turn002_ratio, 1)
    turn002_bottom = where(turn002_above_a, turn002_root + 1, turn002_ratio + turn002_signed)
    turn002_t = turn002_top / turn002_bottom
    turn002_tangent = where(turn002_g == 0, 0, turn002_t)
    turn002_secant = sqrt(1 + turn002_tangent * turn002_tangent)
    turn002_cosine = 1 / turn002_secant
    turn002_sine = turn002_tangent * turn002_cosine
    turn002_p_a = turn002_aa < turn002_bb
    turn002_p = where(turn002_p_a, turn002_sine, turn002_cosine)
    turn002_q = where(turn002_p_a, -turn002_cosine, turn002_sine)
    turn002_a_0 = turn001_a_0 * turn002_p - scaled_s_2 * turn002_q
    turn002_a_1 = turn001_a_1 * turn002_p - scaled_s_5 * turn002_q
    turn002_a_2 = turn001_a_2 * turn002_p - scaled_s_8 * turn002_q
    turn002_b_0 = scaled_s_2 * turn002_p + turn001_a_0 * turn002_q
    turn002_b_1 = scaled_s_5 * turn002_p + turn001_a_1 * turn002_q
    turn002_b_2 = scaled_s_8 * turn002_p + turn001_a_2 * turn002_q
    turn002_c_0 = turn001_p * turn002_p
    turn002_c_1 = -(turn001_q * turn002_p)
    turn002_d_0 = turn001_p * turn002_q
    turn002_d_1 = -(turn001_q * turn002_q)
    turn012_aa = turn001_b_0 * turn001_b_0 + turn001_b_1 * turn001_b_1 + turn001_b_2 * turn001_b_2
    turn012_bb = turn002_b_0 * turn002_b_0 + turn002_b_1 * turn002_b_1 + turn002_b_2 * turn002_b_2
    turn012_g = turn001_b_0 * turn002_b_0 + turn001_b_1 * turn002_b_1 + turn001_b_2 * turn002_b_2
    turn012_apart = turn012_bb - turn012_aa
    turn012_e = 0.5 * turn012_apart
    turn012_size_g = absolute(turn012_g)
    turn012_size_e = absolute(turn012_e)
    turn012_above_a = turn012_size_g < turn012_size_e
    turn012_above = where(turn012_above_a, turn012_g, turn012_e)
    turn012_below = where(turn012_above_a, turn012_e, turn012_g)
    turn012_divisor = where(turn012_below == 0, 1, turn012_below)
    turn012_ratio = turn012_above / turn012_divisor
    turn012_root = sqrt(1 + turn012_ratio * turn012_ratio)
    turn012_signed = where(turn012_ratio < 0, -turn012_root, turn012_root)
    turn012_top = where(turn012_above_a, turn012_ratio, 1)
    turn012_bottom = where(turn012_above_a, turn012_root + 1, turn012_ratio + turn012_signed)
    turn012_t = turn012_top / turn012_bottom
    turn012_tangent = where(turn012_g == 0, 0, turn012_t)
    turn012_secant = sqrt(1 + turn012_tangent * turn012_tangent)
    turn012_cosine = 1 / turn012_secant
    turn012_sine = turn012_tangent * turn012_cosine
    turn012_p_a = turn012_aa < turn012_bb
    turn012_p = where(turn012_p_a, turn012_sine, turn012_cosine)
    turn012_q = where(turn012_p_a, -turn012_cosine, turn012_sine)
    turn012_a_0 = turn001_b_0 * turn012_p - turn002_b_0 * turn012_q
    turn012_a_1 = turn001_b_1 * turn012_p - turn002_b_1 * turn012_q
    turn012_a_2 = turn001_b_2 * turn012_p - turn002_b_2 * turn012_q
    turn012_b_0 = turn001_b_0 * turn012_q + turn002_b_0 * turn012_p
    turn012_b_1 = turn001_b_1 * turn012_q + turn002_b_1 * turn012_p
    turn012_b_2 = turn001_b_2 * turn012_q + turn002_b_2 * turn012_p
    turn012_c_0 = turn001_q * turn012_p - turn002_d_0 * turn012_q
    turn012_c_1 = turn001_p * turn012_p - turn002_d_1 * turn012_q
    turn012_c_2 = -(turn002_p * turn012_q)
    turn012_d_0 = turn001_q * turn012_q + turn002_d_0 * turn012_p
    turn012_d_1 = turn001_p * turn012_q + turn002_d_1 * turn012_p
    turn012_d_2 = turn002_p * turn012_p
    turn101_aa = turn002_a_0 * turn002_a_0 + turn002_a_1 * turn002_a_1 + turn002_a_2 * turn002_a_2
    turn101_bb = turn012_a_0 * turn012_a_0 + turn012_a_1 * turn012_a_1 + turn012_a_2 * turn012_a_2
    turn101_g = turn002_a_0 * turn012_a_0 + turn002_a_1 * turn012_a_1 + turn002_a_2 * turn012_a_2
    turn101_apart = turn101_bb - turn101_aa
    turn101_e = 0.5 * turn101_apart
    turn101_size_g = absolute(turn101_g)
    turn101_size_e = absolute(turn101_e)
    turn101_above_a = turn101_size_g < turn101_size_e
    turn101_above = where(turn101_above_a, turn101_g, turn101_e)
    turn101_below = where(turn101_above_a, turn101_e, turn101_g)
    turn101_divisor = where(turn101_below == 0, 1, turn101_below)
    turn101_ratio = turn101_above / turn101_divisor
    turn101_root = sqrt(1 + turn101_ratio * turn101_ratio)
    turn101_signed = where(turn101_ratio < 0, -turn101_root, turn101_root)
    turn101_top = where(turn101_above_a, turn101_ratio, 1)
    turn101_bottom = where(turn101_above_a, turn101_root + 1, turn101_ratio + turn101_signed)
    turn101_t = turn101_top / turn101_bottom
    turn101_tangent = where(turn101_g == 0, 0, turn101_t)
    turn101_secant = sqrt(1 + turn101_tangent * turn101_tangent)
    turn101_cosine = 1 / turn101_secant
    turn101_sine = turn101_tangent * turn101_cosine
    turn101_p_a = turn101_aa < turn101_bb
    turn101_p = where(turn101_p_a, turn101_sine, turn101_cosine)
    turn101_q = where(turn101_p_a, -turn101_cosine, turn101_sine)
    turn101_a_0 = turn002_a_0 * turn101_p - turn012_a_0 * turn101_q
    turn101_a_1 = turn002_a_1 * turn101_p - turn012_a_1 * turn101_q
    turn101_a_2 = turn002_a_2 * turn101_p - turn012_a_2 * turn101_q
    turn101_b_0 = turn002_a_0 * turn101_q + turn012_a_0 * turn101_p
    turn101_b_1 = turn002_a_1 * turn101_q + turn012_a_1 * turn101_p
    turn101_b_2 = turn002_a_2 * turn101_q + turn012_a_2 * turn101_p
    turn101_c_0 = turn002_c_0 * turn101_p - turn012_c_0 * turn101_q
    turn101_c_1 = turn002_c_1 * turn101_p - turn012_c_1 * turn101_q
    turn101_c_2 = -(turn002_q * turn101_p + turn012_c_2 * turn101_q)
    turn101_d_0 = turn002_c_0 * turn101_q + turn012_c_0 * turn101_p
    turn101_d_1 = turn002_c_1 * turn101_q + turn012_c_1 * turn101_p
    turn101_d_2 = turn012_c_2 * turn101_p - turn002_q * turn101_q
    turn102_aa = turn101_a_0 * turn101_a_0 + turn101_a_1 * turn101_a_1 + turn101_a_2 * turn101_a_2
    turn102_bb = turn012_b_0 * turn012_b_0 + turn012_b_1 * turn012_b_1 + turn012_b_2 * turn012_b_2
    turn102_g = turn012_b_0 * turn101_a_0 + turn012_b_1 * turn101_a_1 + turn012_b_2 * turn101_a_2
    turn102_apart = turn102_bb - turn102_aa
    turn102_e = 0.5 * turn102_apart
    turn102_size_g = absolute(turn102_g)
    turn102_size_e = absolute(turn102_e)
    turn102_above_a = turn102_size_g < turn102_size_e
    turn102_above = where(turn102_above_a, turn102_g, turn102_e)
    turn102_below = where(turn102_above_a, turn102_e, turn102_g)
    turn102_divisor = where(turn102_below == 0, 1, turn102_below)
    turn102_ratio = turn102_above / turn102_divisor
    turn102_root = sqrt(1 + turn102_ratio * turn102_ratio)
    turn102_signed = where(turn102_ratio < 0, -turn102_root, turn102_root)
    turn102_top = where(turn102_above_a, turn102_ratio, 1)
    turn102_bottom = where(turn102_above_a, turn102_root + 1, turn102_ratio + turn102_signed)
    turn102_t = turn102_top / turn102_bottom
    turn102_tangent = where(turn102_g == 0, 0, turn102_t)
    turn102_secant = sqrt(1 + turn102_tangent * turn102_tangent)
    turn102_cosine = 1 / turn102_secant
    turn102_sine = turn102_tangent * turn102_cosine
    turn102_p_a = turn102_aa < turn102_bb
    turn102_p = where(turn102_p_a, turn102_sine, turn102_cosine)
    turn102_q = where(turn102_p_a, -turn102_cosine, turn102_sine)
    turn102_a_0 = turn101_a_0 * turn102_p - turn012_b_0 * turn102_q
    turn102_a_1 = turn101_a_1 * turn102_p - turn012_b_1 * turn102_q
    turn102_a_2 = turn101_a_2 * turn102_p - turn012_b_2 * turn102_q
    turn102_b_0 = turn012_b_0 * turn102_p + turn101_a_0 * turn102_q
    turn102_b_1 = turn012_b_1 * turn102_p + turn101_a_1 * turn102_q
    turn102_b_2 = turn012_b_2 * turn102_p + turn101_a_2 * turn102_q
    turn102_c_0 = turn101_c_0 * turn102_p - turn012_d_0 * turn102_q
    turn102_c_1 = turn101_c_1 * turn102_p - turn012_d_1 * turn102_q
    turn102_c_2 = turn101_c_2 * turn102_p - turn012_d_2 * turn102_q
    turn102_d_0 = turn012_d_0 * turn102_p + turn101_c_0 * turn102_q
    turn102_d_1 = turn012_d_1 * turn102_p + turn101_c_1 * turn102_q
    turn102_d_2 = turn012_d_2 * turn102_p + turn101_c_2 * turn102_q
    turn112_aa = turn101_b_0 * turn101_b_0 + turn101_b_1 * turn101_b_1 + turn101_b_2 * turn101_b_2
    turn112_bb = turn102_b_0 * turn102_b_0 + turn102_b_1 * turn102_b_1 + turn102_b_2 * turn102_b_2
    turn112_g = turn101_b_0 * turn102_b_0 + turn101_b_1 * turn102_b_1 + turn101_b_2 * turn102_b_2
    turn112_apart = turn112_bb - turn112_aa
    turn112_e = 0.5 * turn112_apart
    turn112_size_g = absolute(turn112_g)
    turn112_size_e = absolute(turn112_e)
    turn112_above_a = turn112_size_g < turn112_size_e
    turn112_above = where(turn112_above_a, turn112_g, turn112_e)
    turn112_below = where(turn112_above_a, turn112_e, turn112_g)
    turn112_divisor = where(turn112_below == 0, 1, turn112_below)
    turn112_ratio = turn112_above / turn112_divisor
    turn112_root = sqrt(1 + turn112_ratio * turn112_ratio)
    turn112_signed = where(turn112_ratio < 0, -turn112_root, turn112_root)
    turn112_top = where(turn112_above_a, turn112_ratio, 1)
    turn112_bottom = where(turn112_above_a, turn112_root + 1, turn112_ratio + turn112_signed)
    turn112_t = turn112_top / turn112_bottom
    turn112_tangent = where(turn112_g == 0, 0, turn112_t)
    turn112_secant = sqrt(1 + turn112_tangent * turn112_tangent)
    turn112_cosine = 1 / turn112_secant
    turn112_sine = turn112_tangent * turn112_cosine
    turn112_p_a = turn112_aa < turn112_bb
    turn112_p = where(turn112_p_a, turn112_sine, turn112_cosine)
    turn112_q = where(turn112_p_a, -turn112_cosine, turn112_sine)
    turn112_a_0 = turn101_b_0 * turn112_p - turn102_b_0 * turn112_q
    turn112_a_1 = turn101_b_1 * turn112_p - turn102_b_1 * turn112_q
    turn112_a_2 = turn101_b_2 * turn112_p - turn102_b_2 * turn112_q
    turn112_b_0 = turn101_b_0 * turn112_q + turn102_b_0 * turn112_p
    turn112_b_1 = turn101_b_1 * turn112_q + turn102_b_1 * turn112_p
    turn112_b_2 = turn101_b_2 * turn112_q + turn102_b_2 * turn112_p
    turn112_c_0 = turn101_d_0 * turn112_p - turn102_d_0 * turn112_q
    turn112_c_1 = turn101_d_1 * turn112_p - turn102_d_1 * turn112_q
    turn112_c_2 = turn101_d_2 * turn112_p - turn102_d_2 * turn112_q
    turn112_d_0 = turn101_d_0 * turn112_q + turn102_d_0 * turn112_p
    turn112_d_1 = turn101_d_1 * turn112_q + turn102_d_1 * turn112_p
    turn112_d_2 = turn101_d_2 * turn112_q + turn102_d_2 * turn112_p
    turn201_aa = turn102_a_0 * turn102_a_0 + turn102_a_1 * turn102_a_1 + turn102_a_2 * turn102_a_2
    turn201_bb = turn112_a_0 * turn112_a_0 + turn112_a_1 * turn112_a_1 + turn112_a_2 * turn112_a_2
    turn201_g = turn102_a_0 * turn112_a_0 + turn102_a_1 * turn112_a_1 + turn102_a_2 * turn112_a_2
    turn201_apart = turn201_bb - turn201_aa
    turn201_e = 0.5 * turn201_apart
    turn201_size_g = absolute(turn201_g)
    turn201_size_e = absolute(turn201_e)
    turn201_above_a = turn201_size_g < turn201_size_e
    turn201_above = where(turn201_above_a, turn201_g, turn201_e)
    turn201_below = where(turn201_above_a, turn201_e, turn201_g)
    turn201_divisor = where(turn201_below == 0, 1, turn201_below)
    turn201_ratio = turn201_above / turn201_divisor
    turn201_root = sqrt(1 + turn201_ratio * turn201_ratio)
    turn201_signed = where(turn201_ratio < 0, -turn201_root, turn201_root)
    turn201_top = where(turn201_above_a, turn201_ratio, 1)
    turn201_bottom = where(turn201_above_a, turn201_root + 1, turn201_ratio + turn201_signed)
    turn201_t = turn201_top / turn201_bottom
    turn201_tangent = where(turn201_g == 0, 0, turn201_t)
    turn201_secant = sqrt(1 + turn201_tangent * turn201_tangent)
    turn201_cosine = 1 / turn201_secant
    turn201_sine = turn201_tangent * turn201_cosine
    turn201_p_a = turn201_aa < turn201_bb
    turn201_p = where(turn201_p_a, turn201_sine, turn201_cosine)
    turn201_q = where(turn201_p_a, -turn201_cosine, turn201_sine)
    turn201_a_0 = turn102_a_0 * turn201_p - turn112_a_0 * turn201_q
    turn201_a_1 = turn102_a_1 * turn201_p - turn112_a_1 * turn201_q
    turn201_a_2 = turn102_a_2 * turn201_p - turn112_a_2 * turn201_q
    turn201_b_0 = turn102_a_0 * turn201_q + turn112_a_0 * turn201_p
    turn201_b_1 = turn102_a_1 * turn201_q + turn112_a_1 * turn201_p
    turn201_b_2 = turn102_a_2 * turn201_q + turn112_a_2 * turn201_p
    turn201_c_0 = turn102_c_0 * turn201_p - turn112_c_0 * turn201_q
    turn201_c_1 = turn102_c_1 * turn201_p - turn112_c_1 * turn201_q
    turn201_c_2 = turn102_c_2 * turn201_p - turn112_c_2 * turn201_q
    turn201_d_0 = turn102_c_0 * turn201_q + turn112_c_0 * turn201_p
    turn201_d_1 = turn102_c_1 * turn201_q + turn112_c_1 * turn201_p
    turn201_d_2 = turn102_c_2 * turn201_q + turn112_c_2 * turn201_p
    turn202_aa = turn201_a_0 * turn201_a_0 + turn201_a_1 * turn201_a_1 + turn201_a_2 * turn201_a_2
    turn202_bb = turn112_b_0 * turn112_b_0 + turn112_b_1 * turn112_b_1 + turn112_b_2 * turn112_b_2
    turn202_g = turn112_b_0 * turn201_a_0 + turn112_b_1 * turn201_a_1 + turn112_b_2 * turn201_a_2
    turn202_apart = turn202_bb - turn202_aa
    turn202_e = 0.5 * turn202_apart
    turn202_size_g = absolute(turn202_g)
    turn202_size_e = absolute(turn202_e)
    turn202_above_a = turn202_size_g < turn202_size_e
    turn202_above = where(turn202_above_a, turn202_g, turn202_e)
    turn202_below = where(turn202_above_a, turn202_e, turn202_g)
    turn202_divisor = where(turn202_below == 0, 1, turn202_below)
    turn202_ratio = turn202_above / turn202_divisor
    turn202_root = sqrt(1 + turn202_ratio * turn202_ratio)
    turn202_signed = where(turn202_ratio < 0, -turn202_root, turn202_root)
    turn202_top = where(turn202_above_a, turn202_ratio, 1)
    turn202_bottom = where(turn202_above_a, turn202_root + 1, turn202_ratio + turn202_signed)
    turn202_t = turn202_top / turn202_bottom
    turn202_tangent = where(turn202_g == 0, 0, turn202_t)
    turn202_secant = sqrt(1 + turn202_tangent * turn202_tangent)
    turn202_cosine = 1 / turn202_secant
    turn202_sine = turn202_tangent * turn202_cosine
    turn202_p_a = turn202_aa < turn202_bb
    turn202_p = where(turn202_p_a, turn202_sine, turn202_cosine)
    turn202_q = where(turn202_p_a, -turn202_cosine, turn202_sine)
    turn202_a_0 = turn201_a_0 * turn202_p - turn112_b_0 * turn202_q
    turn202_a_1 = turn201_a_1 * turn202_p - turn112_b_1 * turn202_q
    turn202_a_2 = turn201_a_2 * turn202_p - turn112_b_2 * turn202_q
    turn202_b_0 = turn112_b_0 * turn202_p + turn201_a_0 * turn202_q
    turn202_b_1 = turn112_b_1 * turn202_p + turn201_a_1 * turn202_q
    turn202_b_2 = turn112_b_2 * turn202_p + turn201_a_2 * turn202_q
    turn202_c_0 = turn201_c_0 * turn202_p - turn112_d_0 * turn202_q
    turn202_c_1 = turn201_c_1 * turn202_p - turn112_d_1 * turn202_q
    turn202_c_2 = turn201_c_2 * turn202_p - turn112_d_2 * turn202_q
    turn202_d_0 = turn112_d_0 * turn202_p + turn201_c_0 * turn202_q
    turn202_d_1 = turn112_d_1 * turn202_p + turn201_c_1 * turn202_q
    turn202_d_2 = turn112_d_2 * turn202_p + turn201_c_2 * turn202_q
    turn212_aa = turn201_b_0 * turn201_b_0 + turn201_b_1 * turn201_b_1 + turn201_b_2 * turn201_b_2
    turn212_bb = turn202_b_0 * turn202_b_0 + turn202_b_1 * turn202_b_1 + turn202_b_2 * turn202_b_2
    turn212_g = turn201_b_0 * turn202_b_0 + turn201_b_1 * turn202_b_1 + turn201_b_2 * turn202_b_2
    turn212_apart = turn212_bb - turn212_aa
    turn212_e = 0.5 * turn212_apart
    turn212_size_g = absolute(turn212_g)
    turn212_size_e = absolute(turn212_e)
    turn212_above_a = turn212_size_g < turn212_size_e
    turn212_above = where(turn212_above_a, turn212_g, turn212_e)
    turn212_below = where(turn212_above_a, turn212_e, turn212_g)
    turn212_divisor = where(turn212_below == 0, 1, turn212_below)
    turn212_ratio = turn212_above / turn212_divisor
    turn212_root = sqrt(1 + turn212_ratio * turn212_ratio)
    turn212_signed = where(turn212_ratio < 0, -turn212_root, turn212_root)
    turn212_top = where(turn212_above_a, turn212_ratio, 1)
    turn212_bottom = where(turn212_above_a, turn212_root + 1, turn212_ratio + turn212_signed)
    turn212_t = turn212_top / turn212_bottom
    turn212_tangent = where(turn212_g == 0, 0, turn212_t)
    turn212_secant = sqrt(1 + turn212_tangent * turn212_tangent)
    turn212_cosine = 1 / turn212_secant
    turn212_sine = turn212_tangent * turn212_cosine
    turn212_p_a = turn212_aa < turn212_bb
    turn212_p = where(turn212_p_a, turn212_sine, turn212_cosine)
    turn212_q = where(turn212_p_a, -turn212_cosine, turn212_sine)
    turn212_a_0 = turn201_b_0 * turn212_p - turn202_b_0 * turn212_q
    turn212_a_1 = turn201_b_1 * turn212_p - turn202_b_1 * turn212_q
    turn212_a_2 = turn201_b_2 * turn212_p - turn202_b_2 * turn212_q
    turn212_b_0 = turn201_b_0 * turn212_q + turn202_b_0 * turn212_p
    turn212_b_1 = turn201_b_1 * turn212_q + turn202_b_1 * turn212_p
    turn212_b_2 = turn201_b_2 * turn212_q + turn202_b_2 * turn212_p
    turn212_c_0 = turn201_d_0 * turn212_p - turn202_d_0 * turn212_q
    turn212_c_1 = turn201_d_1 * turn212_p - turn202_d_1 * turn212_q
    turn212_c_2 = turn201_d_2 * turn212_p - turn202_d_2 * turn212_q
    turn212_d_0 = turn201_d_0 * turn212_q + turn202_d_0 * turn212_p
    turn212_d_1 = turn201_d_1 * turn212_q + turn202_d_1 * turn212_p
    turn212_d_2 = turn201_d_2 * turn212_q + turn202_d_2 * turn212_p
    turn301_aa = turn202_a_0 * turn202_a_0 + turn202_a_1 * turn202_a_1 + turn202_a_2 * turn202_a_2
    turn301_bb = turn212_a_0 * turn212_a_0 + turn212_a_1 * turn212_a_1 + turn212_a_2 * turn212_a_2
    turn301_g = turn202_a_0 * turn212_a_0 + turn202_a_1 * turn212_a_1 + turn202_a_2 * turn212_a_2
    turn301_apart = turn301_bb - turn301_aa
    turn301_e = 0.5 * turn301_apart
    turn301_size_g = absolute(turn301_g)
    turn301_size_e = absolute(turn301_e)
    turn301_above_a = turn301_size_g < turn301_size_e
    turn301_above = where(turn301_above_a, turn301_g, turn301_e)
    turn301_below = where(turn301_above_a, turn301_e, turn301_g)
    turn301_divisor = where(turn301_below == 0, 1, turn301_below)
    turn301_ratio = turn301_above / turn301_divisor
    turn301_root = sqrt(1 + turn301_ratio * turn301_ratio)
    turn301_signed = where(turn301_ratio < 0, -turn301_root, turn301_root)
    turn301_top = where(turn301_above_a, turn301_ratio, 1)
    turn301_bottom = where(turn301_above_a, turn301_root + 1, turn301_ratio + turn301_signed)
    turn301_t = turn301_top / turn301_bottom
    turn301_tangent = where(turn301_g == 0, 0, turn301_t)
    turn301_secant = sqrt(1 + turn301_tangent * turn301_tangent)
    turn301_cosine = 1 / turn301_secant
    turn301_sine = turn301_tangent * turn301_cosine
    turn301_p_a = turn301_aa < turn301_bb
    turn301_p = where(turn301_p_a, turn301_sine, turn301_cosine)
    turn301_q = where(turn301_p_a, -turn301_cosine, turn301_sine)
    turn301_a_0 = turn202_a_0 * turn301_p - turn212_a_0 * turn301_q
    turn301_a_1 = turn202_a_1 * turn301_p - turn212_a_1 * turn301_q
    turn301_a_2 = turn202_a_2 * turn301_p - turn212_a_2 * turn301_q
    turn301_b_0 = turn202_a_0 * turn301_q + turn212_a_0 * turn301_p
    turn301_b_1 = turn202_a_1 * turn301_q + turn212_a_1 * turn301_p
    turn301_b_2 = turn202_a_2 * turn301_q + turn212_a_2 * turn301_p
    turn301_c_0 = turn202_c_0 * turn301_p - turn212_c_0 * turn301_q
    turn301_c_1 = turn202_c_1 * turn301_p - turn212_c_1 * turn301_q
    turn301_c_2 = turn202_c_2 * turn301_p - turn212_c_2 * turn301_q
    turn301_d_0 = turn202_c_0 * turn301_q + turn212_c_0 * turn301_p
    turn301_d_1 = turn202_c_1 * turn301_q + turn212_c_1 * turn301_p
    turn301_d_2 = turn202_c_2 * turn301_q + turn212_c_2 * turn301_p
    turn302_aa = turn301_a_0 * turn301_a_0 + turn301_a_1 * turn301_a_1 + turn301_a_2 * turn301_a_2
    turn302_bb = turn212_b_0 * turn212_b_0 + turn212_b_1 * turn212_b_1 + turn212_b_2 * turn212_b_2
    turn302_g = turn212_b_0 * turn301_a_0 + turn212_b_1 * turn301_a_1 + turn212_b_2 * turn301_a_2
    turn302_apart = turn302_bb - turn302_aa
    turn302_e = 0.5 * turn302_apart
    turn302_size_g = absolute(turn302_g)
    turn302_size_e = absolute(turn302_e)
    turn302_above_a = turn302_size_g < turn302_size_e
    turn302_above = where(turn302_above_a, turn302_g, turn302_e)
    turn302_below = where(turn302_above_a, turn302_e, turn302_g)
    turn302_divisor = where(turn302_below == 0, 1, turn302_below)
    turn302_ratio = turn302_above / turn302_divisor
    turn302_root = sqrt(1 + turn302_ratio * turn302_ratio)
    turn302_signed = where(turn302_ratio < 0, -turn302_root, turn302_root)
    turn302_top = where(turn302_above_a, turn302_ratio, 1)
    turn302_bottom = where(turn302_above_a, turn302_root + 1, turn302_ratio + turn302_signed)
    turn302_t = turn302_top / turn302_bottom
    turn302_tangent = where(turn302_g == 0, 0, turn302_t)
    turn302_secant = sqrt(1 + turn302_tangent * turn302_tangent)
    turn302_cosine = 1 / turn302_secant
    turn302_sine = turn302_tangent * turn302_cosine
    turn302_p_a = turn302_aa < turn302_bb
    turn302_p = where(turn302_p_a, turn302_sine, turn302_cosine)
    turn302_q = where(turn302_p_a, -turn302_cosine, turn302_sine)
    turn302_a_0 = turn301_a_0 * turn302_p - turn212_b_0 * turn302_q
    turn302_a_1 = turn301_a_1 * turn302_p - turn212_b_1 * turn302_q
    turn302_a_2 = turn301_a_2 * turn302_p - turn212_b_2 * turn302_q
    turn302_b_0 = turn212_b_0 * turn302_p + turn301_a_0 * turn302_q
    turn302_b_1 = turn212_b_1 * turn302_p + turn301_a_1 * turn302_q
    turn302_b_2 = turn212_b_2 * turn302_p + turn301_a_2 * turn302_q
    turn302_c_0 = turn301_c_0 * turn302_p - turn212_d_0 * turn302_q
    turn302_c_1 = turn301_c_1 * turn302_p - turn212_d_1 * turn302_q
    turn302_c_2 = turn301_c_2 * turn302_p - turn212_d_2 * turn302_q
    turn302_d_0 = turn212_d_0 * turn302_p + turn301_c_0 * turn302_q
    turn302_d_1 = turn212_d_1 * turn302_p + turn301_c_1 * turn302_q
    turn302_d_2 = turn212_d_2 * turn302_p + turn301_c_2 * turn302_q
    turn312_aa = turn301_b_0 * turn301_b_0 + turn301_b_1 * turn301_b_1 + turn301_b_2 * turn301_b_2
    turn312_bb = turn302_b_0 * turn302_b_0 + turn302_b_1 * turn302_b_1 + turn302_b_2 * turn302_b_2
    turn312_g = turn301_b_0 * turn302_b_0 + turn301_b_1 * turn302_b_1 + turn301_b_2 * turn302_b_2
    turn312_apart = turn312_bb - turn312_aa
    turn312_e = 0.5 * turn312_apart
    turn312_size_g = absolute(turn312_g)
    turn312_size_e = absolute(turn312_e)
    turn312_above_a = turn312_size_g < turn312_size_e
    turn312_above = where(turn312_above_a, turn312_g, turn312_e)
    turn312_below = where(turn312_above_a, turn312_e, turn312_g)
    turn312_divisor = where(turn312_below == 0, 1, turn312_below)
    turn312_ratio = turn312_above / turn312_divisor
    turn312_root = sqrt(1 + turn312_ratio * turn312_ratio)
    turn312_signed = where(turn312_ratio < 0, -turn312_root, turn312_root)
    turn312_top = where(turn312_above_a, turn312_ratio, 1)
    turn312_bottom = where(turn312_above_a, turn312_root + 1, turn312_ratio + turn312_signed)
    turn312_t = turn312_top / turn312_bottom
    turn312_tangent = where(turn312_g == 0, 0, turn312_t)
    turn312_secant = sqrt(1 + turn312_tangent * turn312_tangent)
    turn312_cosine = 1 / turn312_secant
    turn312_sine = turn312_tangent * turn312_cosine
    turn312_p_a = turn312_aa < turn312_bb
    turn312_p = where(turn312_p_a, turn312_sine, turn312_cosine)
    turn312_q = where(turn312_p_a, -turn312_cosine, turn312_sine)
    turn312_a_0 = turn301_b_0 * turn312_p - turn302_b_0 * turn312_q
    turn312_a_1 = turn301_b_1 * turn312_p - turn302_b_1 * turn312_q
    turn312_a_2 = turn301_b_2 * turn312_p - turn302_b_2 * turn312_q
    turn312_b_0 = turn301_b_0 * turn312_q + turn302_b_0 * turn312_p
    turn312_b_1 = turn301_b_1 * turn312_q + turn302_b_1 * turn312_p
    turn312_b_2 = turn301_b_2 * turn312_q + turn302_b_2 * turn312_p
    turn312_c_0 = turn301_d_0 * turn312_p - turn302_d_0 * turn312_q
    turn312_c_1 = turn301_d_1 * turn312_p - turn302_d_1 * turn312_q
    turn312_c_2 = turn301_d_2 * turn312_p - turn302_d_2 * turn312_q
    turn312_d_0 = turn301_d_0 * turn312_q + turn302_d_0 * turn312_p
    turn312_d_1 = turn301_d_1 * turn312_q + turn302_d_1 * turn312_p
    turn312_d_2 = turn301_d_2 * turn312_q + turn302_d_2 * turn312_p
    turn401_aa = turn302_a_0 * turn302_a_0 + turn302_a_1 * turn302_a_1 + turn302_a_2 * turn302_a_2
    turn401_bb = turn312_a_0 * turn312_a_0 + turn312_a_1 * turn312_a_1 + turn312_a_2 * turn312_a_2
    turn401_g = turn302_a_0 * turn312_a_0 + turn302_a_1 * turn312_a_1 + turn302_a_2 * turn312_a_2
    turn401_apart = turn401_bb - turn401_aa
    turn401_e = 0.5 * turn401_apart
    turn401_size_g = absolute(turn401_g)
    turn401_size_e = absolute(turn401_e)
    turn401_above_a = turn401_size_g < turn401_size_e
    turn401_above = where(turn401_above_a, turn401_g, turn401_e)
    turn401_below = where(turn401_above_a, turn401_e, turn401_g)
    turn401_divisor = where(turn401_below == 0, 1, turn401_below)
    turn401_ratio = turn401_above / turn401_divisor
    turn401_root = sqrt(1 + turn401_ratio * turn401_ratio)
    turn401_signed = where(turn401_ratio < 0, -turn401_root, turn401_root)
    turn401_top = where(turn401_above_a, turn401_ratio, 1)
    turn401_bottom = where(turn401_above_a, turn401_root + 1, turn401_ratio + turn401_signed)
    turn401_t = turn401_top / turn401_bottom
    turn401_tangent = where(turn401_g == 0, 0, turn401_t)
    turn401_secant = sqrt(1 + turn401_tangent * turn401_tangent)
    turn401_cosine = 1 / turn401_secant
    turn401_sine = turn401_tangent * turn401_cosine
    turn401_p_a = turn401_aa < turn401_bb
    turn401_p = where(turn401_p_a, turn401_sine, turn401_cosine)
    turn401_q = where(turn401_p_a, -turn401_cosine, turn401_sine)
    turn401_a_0 = turn302_a_0 * turn401_p - turn312_a_0 * turn401_q
    turn401_a_1 = turn302_a_1 * turn401_p - turn312_a_1 * turn401_q
    turn401_a_2 = turn302_a_2 * turn401_p - turn312_a_2 * turn401_q
    turn401_b_0 = turn302_a_0 * turn401_q + turn312_a_0 * turn401_p
    turn401_b_1 = turn302_a_1 * turn401_q + turn312_a_1 * turn401_p
    turn401_b_2 = turn302_a_2 * turn401_q + turn312_a_2 * turn401_p
    turn401_c_0 = turn302_c_0 * turn401_p - turn312_c_0 * turn401_q
    turn401_c_1 = turn302_c_1 * turn401_p - turn312_c_1 * turn401_q
    turn401_c_2 = turn302_c_2 * turn401_p - turn312_c_2 * turn401_q
    turn401_d_0 = turn302_c_0 * turn401_q + turn312_c_0 * turn401_p
    turn401_d_1 = turn302_c_1 * turn401_q + turn312_c_1 * turn401_p
    turn401_d_2 = turn302_c_2 * turn401_q + turn312_c_2 * turn401_p
    turn402_aa = turn401_a_0 * turn401_a_0 + turn401_a_1 * turn401_a_1 + turn401_a_2 * turn401_a_2
    turn402_bb = turn312_b_0 * turn312_b_0 + turn312_b_1 * turn312_b_1 + turn312_b_2 * turn312_b_2
    turn402_g = turn312_b_0 * turn401_a_0 + turn312_b_1 * turn401_a_1 + turn312_b_2 * turn401_a_2
    turn402_apart = turn402_bb - turn402_aa
    turn402_e = 0.5 * turn402_apart
    turn402_size_g = absolute(turn402_g)
    turn402_size_e = absolute(turn402_e)
    turn402_above_a = turn402_size_g < turn402_size_e
    turn402_above = where(turn402_above_a, turn402_g, turn402_e)
    turn402_below = where(turn402_above_a, turn402_e, turn402_g)
    turn402_divisor = where(turn402_below == 0, 1, turn402_below)
    turn402_ratio = turn402_above / turn402_divisor
    turn402_root = sqrt(1 + turn402_ratio * turn402_ratio)
    turn402_signed = where(turn402_ratio < 0, -turn402_root, turn402_root)
    turn402_top = where(turn402_above_a, turn402_ratio, 1)
    turn402_bottom = where(turn402_above_a, turn402_root + 1, turn402_ratio + turn402_signed)
    turn402_t = turn402_top / turn402_bottom
    turn402_tangent = where(turn402_g == 0, 0, turn402_t)
    turn402_secant = sqrt(1 + turn402_tangent * turn402_tangent)
    turn402_cosine = 1 / turn402_secant
    turn402_sine = turn402_tangent * turn402_cosine
    turn402_p_a = turn402_aa < turn402_bb
    turn402_p = where(turn402_p_a, turn402_sine, turn402_cosine)
    turn402_q = where(turn402_p_a, -turn402_cosine, turn402_sine)
    turn402_a_0 = turn401_a_0 * turn402_p - turn312_b_0 * turn402_q
    turn402_a_1 = turn401_a_1 * turn402_p - turn312_b_1 * turn402_q
    turn402_a_2 = turn401_a_2 * turn402_p - turn312_b_2 * turn402_q
    turn402_b_0 = turn312_b_0 * turn402_p + turn401_a_0 * turn402_q
    turn402_b_1 = turn312_b_1 * turn402_p + turn401_a_1 * turn402_q
    turn402_b_2 = turn312_b_2 * turn402_p + turn401_a_2 * turn402_q
    turn402_c_0 = turn401_c_0 * turn402_p - turn312_d_0 * turn402_q
    turn402_c_1 = turn401_c_1 * turn402_p - turn312_d_1 * turn402_q
    turn402_c_2 = turn401_c_2 * turn402_p - turn312_d_2 * turn402_q
    turn402_d_0 = turn312_d_0 * turn402_p + turn401_c_0 * turn402_q
    turn402_d_1 = turn312_d_1 * turn402_p + turn401_c_1 * turn402_q
    turn402_d_2 = turn312_d_2 * turn402_p + turn401_c_2 * turn402_q
    turn412_aa = turn401_b_0 * turn401_b_0 + turn401_b_1 * turn401_b_1 + turn401_b_2 * turn401_b_2
    turn412_bb = turn402_b_0 * turn402_b_0 + turn402_b_1 * turn402_b_1 + turn402_b_2 * turn402_b_2
    turn412_g = turn401_b_0 * turn402_b_0 + turn401_b_1 * turn402_b_1 + turn401_b_2 * turn402_b_2
    turn412_apart = turn412_bb - turn412_aa
    turn412_e = 0.5 * turn412_apart
    turn412_size_g = absolute(turn412_g)
    turn412_size_e = absolute(turn412_e)
    turn412_above_a = turn412_size_g < turn412_size_e
    turn412_above = where(turn412_above_a, turn412_g, turn412_e)
    turn412_below = where(turn412_above_a, turn412_e, turn412_g)
    turn412_divisor = where(turn412_below == 0, 1, turn412_below)
    turn412_ratio = turn412_above / turn412_divisor
    turn412_root = sqrt(1 + turn412_ratio * turn412_ratio)
    turn412_signed = where(turn412_ratio < 0, -turn412_root, turn412_root)
    turn412_top = where(turn412_above_a, turn412_ratio, 1)
    turn412_bottom = where(turn412_above_a, turn412_root + 1, turn412_ratio + turn412_signed)
    turn412_t = turn412_top / turn412_bottom
    turn412_tangent = where(turn412_g == 0, 0, turn412_t)
    turn412_secant = sqrt(1 + turn412_tangent * turn412_tangent)
    turn412_cosine = 1 / turn412_secant
    turn412_sine = turn412_tangent * turn412_cosine
    turn412_p_a = turn412_aa < turn412_bb
    turn412_p = where(turn412_p_a, turn412_sine, turn412_cosine)
    turn412_q = where(turn412_p_a, -turn412_cosine, turn412_sine)
    turn412_a_0 = turn401_b_0 * turn412_p - turn402_b_0 * turn412_q
    turn412_a_1 = turn401_b_1 * turn412_p - turn402_b_1 * turn412_q
    turn412_a_2 = turn401_b_2 * turn412_p - turn402_b_2 * turn412_q
    turn412_c_0 = turn401_d_0 * turn412_p - turn402_d_0 * turn412_q
    turn412_c_1 = turn401_d_1 * turn412_p - turn402_d_1 * turn412_q
    turn412_c_2 = turn401_d_2 * turn412_p - turn402_d_2 * turn412_q
    turn412_d_0 = turn401_d_0 * turn412_q + turn402_d_0 * turn412_p
    turn412_d_1 = turn401_d_1 * turn412_q + turn402_d_1 * turn412_p
    turn412_d_2 = turn401_d_2 * turn412_q + turn402_d_2 * turn412_p
    longest = sqrt(turn402_a_0 * turn402_a_0 + turn402_a_1 * turn402_a_1 + turn402_a_2 *
        turn402_a_2)
    first_divisor_a = longest == 0
    first_divisor = where(first_divisor_a, 1, longest)
    u0_0 = turn402_a_0 / first_divisor
    u0_1 = turn402_a_1 / first_divisor
    u0_2 = turn402_a_2 / first_divisor
    least = 0.015625 * (1.7763568394002505e-15 * 1.7763568394002505e-15) * (longest * longest)
    second_along = turn412_a_0 * u0_0 + turn412_a_1 * u0_1 + turn412_a_2 * u0_2
    second_part_0 = turn412_a_0 - u0_0 * second_along
    second_part_1 = turn412_a_1 - u0_1 * second_along
    second_part_2 = turn412_a_2 - u0_2 * second_along
    second_whole = turn412_a_0 * turn412_a_0 + turn412_a_1 * turn412_a_1 + turn412_a_2 * turn412_a_2
    second_kept = (second_part_0 * second_part_0 + second_part_1 * second_part_1 + second_part_2
        * second_part_2)
    second_enough_a = 0.25 * second_whole
    second_enough = where(second_enough_a < least, least, second_enough_a)
    second_is_kept = where(second_enough < second_kept, real(1), real(0))
    second_size_0 = absolute(u0_0)
    second_size_1 = absolute(u0_1)
    second_size_2 = absolute(u0_2)
    second_is_y = where(second_size_1 < second_size_0, real(1), real(0))
    second_less_a = second_is_y == 0
    second_less = where(second_less_a, second_size_0, second_size_1)
    second_is_z = where(second_size_2 < second_less, real(1), real(0))
    second_xy_0 = where(second_less_a, real(1), real(0))
    second_xy_1 = where(second_less_a, real(0), real(1))
    second_axis_0a = second_is_z == 1
    second_axis_0 = where(second_axis_0a, 0, second_xy_0)
    second_axis_1 = where(second_axis_0a, 0, second_xy_1)
    second_axis_2 = where(second_axis_0a, real(1), real(0))
    second_along_axis = u0_0 * second_axis_0 + u0_1 * second_axis_1 + u0_2 * second_axis_2
    second_other_0 = second_axis_0 - u0_0 * second_along_axis
    second_other_1 = second_axis_1 - u0_1 * second_along_axis
    second_other_2 = second_axis_2 - u0_2 * second_along_axis
    second_found_0a = second_is_kept == 1
    second_found_0 = where(second_found_0a, second_part_0, second_other_0)
    second_found_1 = where(second_found_0a, second_part_1, second_other_1)
    second_found_2 = where(second_found_0a, second_part_2, second_other_2)
    second_length = sqrt(second_found_0 * second_found_0 + second_found_1 * second_found_1 +
        second_found_2 * second_found_2)
    second_across_0 = second_found_0 / second_length
    second_across_1 = second_found_1 / second_length
    second_across_2 = second_found_2 / second_length
    u2_0 = u0_1 * second_across_2 - u0_2 * second_across_1
    u2_1 = u0_2 * second_across_0 - u0_0 * second_across_2
    u2_2 = u0_0 * second_across_1 - u0_1 * second_across_0
    turned_0 = turn402_c_0 * u0_0 + turn412_c_0 * second_across_0 + turn412_d_0 * u2_0
    turned_1 = turn402_c_1 * u0_0 + turn412_c_1 * second_across_0 + turn412_d_1 * u2_0
    turned_2 = turn402_c_2 * u0_0 + turn412_c_2 * second_across_0 + turn412_d_2 * u2_0
    turned_3 = turn402_c_0 * u0_1 + turn412_c_0 * second_across_1 + turn412_d_0 * u2_1
    turned_4 = turn402_c_1 * u0_1 + turn412_c_1 * second_across_1 + turn412_d_1 * u2_1
    turned_5 = turn402_c_2 * u0_1 + turn412_c_2 * second_across_1 + turn412_d_2 * u2_1
    turned_6 = turn402_c_0 * u0_2 + turn412_c_0 * second_across_2 + turn412_d_0 * u2_2
    turned_7 = turn402_c_1 * u0_2 + turn412_c_1 * second_across_2 + turn412_d_1 * u2_2
    turned_8 = turn402_c_2 * u0_2 + turn412_c_2 * second_across_2 + turn412_d_2 * u2_2
    gram_0 = turned_0 * turned_0 + turned_3 * turned_3 + turned_6 * turned_6
    gram_1 = turned_0 * turned_1 + turned_3 * turned_4 + turned_6 * turned_7
    gram_2 = turned_0 * turned_2 + turned_3 * turned_5 + turned_6 * turned_8
    gram_3 = turned_1 * turned_1 + turned_4 * turned_4 + turned_7 * turned_7
    gram_4 = turned_1 * turned_2 + turned_4 * turned_5 + turned_7 * turned_8
    gram_5 = turned_2 * turned_2 + turned_5 * turned_5 + turned_8 * turned_8
    half_0 = 1.5 - 0.5 * gram_0
    half_1 = -(0.5 * gram_1)
    half_2 = -(0.5 * gram_2)
    half_4 = 1.5 - 0.5 * gram_3
    half_5 = -(0.5 * gram_4)
    half_8 = 1.5 - 0.5 * gram_5
    Ro_00 = where(first_divisor_a, nan, turned_0 * half_0 + turned_1 * half_1 + turned_2 * half_2)
    Ro_01 = where(first_divisor_a, nan, turned_0 * half_1 + turned_1 * half_4 + turned_2 * half_5)
    Ro_02 = where(first_divisor_a, nan, turned_0 * half_2 + turned_1 * half_5 + turned_2 * half_8)
    Ro_10 = where(first_divisor_a, nan, turned_3 * half_0 + turned_4 * half_1 + turned_5 * half_2)
    Ro_11 = where(first_divisor_a, nan, turned_3 * half_1 + turned_4 * half_4 + turned_5 * half_5)
    Ro_12 = where(first_divisor_a, nan, turned_3 * half_2 + turned_4 * half_5 + turned_5 * half_8)
    Ro_20 = where(first_divisor_a, nan, turned_6 * half_0 + turned_7 * half_1 + turned_8 * half_2)
    Ro_21 = where(first_divisor_a, nan, turned_6 * half_1 + turned_7 * half_4 + turned_8 * half_5)
    Ro_22 = where(first_divisor_a, nan, turned_6 * half_2 + turned_7 * half_5 + turned_8 * half_8)
    return (Ro_00, Ro_01, Ro_02, Ro_10, Ro_11, Ro_12, Ro_20, Ro_21, Ro_22)


@kernel("(3),()->(3,3)")
def mat3x3_from_axis_angle(axis, angle):
    """R = I + sin(angle) axis~ + (1 - cos(angle)) axis~^2, for an axis of length 1; otherwise R is
    not a rotation.

    (3),()->(3,3).  axis: vector; angle: number; R: rotation or other 3×3 matrix.
    71 mul, 79 add, 2 abs, 1 less, 1 select.  Error <= R: 9 u of its largest component for
    |axis| = 1; searched, not proved.
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
    <= angle: 8 u, axis: 5 u of its largest component for R a rotation; searched, not proved.
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
    v_s_d = where(v_s_largest2 < 256, 1.3093562431584567e+151,
        where(6.703903964971299e+153 < v_s_largest2, real(3.7291703656001034e-155), real(1)))
    v_s = where(v_s_largest2 < 1.955159272639747e-149, 1.0715086071862673e+301, v_s_d)
    v_y_0 = upper_0 * v_s
    v_y_1 = upper_1 * v_s
    v_y_2 = upper_2 * v_s
    v_n = sqrt(v_y_0 * v_y_0 + v_y_1 * v_y_1 + v_y_2 * v_y_2)
    v_r_d = where(1 < v_s, 7.637340908749012e-152, where(v_s < 1, real(2.6815615859885194e+154),
        real(1)))
    v_r = where(1.3093562431584567e+151 < v_s, 9.332636185032189e-302, v_r_d)
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
