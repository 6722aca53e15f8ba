# Made by `coscrew generate`; changes are overwritten.
# SPDX-License-Identifier: MIT
# coscrew 0.2.0.  Copyright (c) 2026 The coscrew authors.
"""Exponentials and logarithms of rotations and displacements, their Jacobians, interpolation.

In single precision, accurate tier.
"""

from coscrew import _elementary_double as elementary
from numpy import absolute, float64, sqrt, where
from coscrew._kernel import wide_kernel as kernel


@kernel("(3,3)->(3)")
def SO3_log(R):
    """vo with exp vo~ = R, |vo| <= π; if R is not quite a rotation, its defect carries over to vo.

    (3,3)->(3).  R: rotation or other 3×3 matrix; vo: vector.
    11 mul, 16 add, 1 div, 1 sqrt, 1 atan2, 5 neg, 3 abs, 12 less, 1 equal, 25 select.  Error <=
    vo: 7 u of its largest component for R a rotation; searched, not proved.
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
    v_s_b = where(4.611686018427388e+18 < v_s_largest2, float64(2.710505431213761e-20), float64(1))
    v_s_d = where(v_s_largest2 < 256, 1.8014398509481984e+16, v_s_b)
    v_s = where(v_s_largest2 < 1.4210854715202004e-14, 3.2451855365842673e+32, v_s_d)
    v_y_0 = upper_0 * v_s
    v_y_1 = upper_1 * v_s
    v_y_2 = upper_2 * v_s
    v_n = sqrt(v_y_0 * v_y_0 + v_y_1 * v_y_1 + v_y_2 * v_y_2)
    v_r_b = where(v_s < 1, float64(3.6893488147419103e+19), float64(1))
    v_r_d = where(1 < v_s, 5.551115123125783e-17, v_r_b)
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
    self_00_new_e = self_00 * correction_0 + self_01 * correction_3 + self_02 * correction_4
    self_00_new = self_00 + self_00_new_e
    self_01_new = self_00 * correction_3 + self_01 * correction_1 + self_02 * correction_5 + self_01
    self_02_new = self_00 * correction_4 + self_01 * correction_5 + self_02 * correction_2 + self_02
    self_10_new_e = self_10 * correction_0 + self_11 * correction_3 + self_12 * correction_4
    self_10_new = self_10 + self_10_new_e
    self_11_new = self_10 * correction_3 + self_11 * correction_1 + self_12 * correction_5 + self_11
    self_12_new = self_10 * correction_4 + self_11 * correction_5 + self_12 * correction_2 + self_12
    self_20_new_e = self_20 * correction_0 + self_21 * correction_3 + self_22 * correction_4
    self_20_new = self_20 + self_20_new_e
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
