# Made by `coscrew generate`; changes are overwritten.
# SPDX-License-Identifier: MIT
# coscrew 0.2.0.  Copyright (c) 2026 The coscrew authors.
"""Exponentials and logarithms of rotations and displacements, their Jacobians, interpolation.

In double precision, certified tier.
"""

from numpy import absolute
from coscrew._kernel import double_kernel as kernel


@kernel("(3,3)->(3,3),(3,3)")
def mat3x3_orthonormalize(self):
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
    defect_0_size = 1 + absolute(defect_0a) + absolute(defect_0c) + absolute(defect_0e)
    defect_1_size = 1 + absolute(defect_1a) + absolute(defect_1c) + absolute(defect_1e)
    defect_2_size = 1 + absolute(defect_2a) + absolute(defect_2c) + absolute(defect_2e)
    correction_0_size = 0.5 * (defect_0_size + 2.004168360008973e-292)
    correction_1_size = 0.5 * (defect_1_size + 2.004168360008973e-292)
    correction_2_size = 0.5 * (defect_2_size + 2.004168360008973e-292)
    defect_3e_size = absolute(defect_3a) + absolute(defect_3b) + absolute(defect_3d)
    correction_3_size = 0.5 * (defect_3e_size + 2.004168360008973e-292)
    defect_4e_size = absolute(defect_4a) + absolute(defect_4b) + absolute(defect_4d)
    correction_4_size = 0.5 * (defect_4e_size + 2.004168360008973e-292)
    defect_5e_size = absolute(defect_5a) + absolute(defect_5b) + absolute(defect_5d)
    correction_5_size = 0.5 * (defect_5e_size + 2.004168360008973e-292)
    correction_0_padded = correction_0_size + 2.004168360008973e-292
    self_00_abs = absolute(self_00)
    correction_3_padded = correction_3_size + 2.004168360008973e-292
    self_01_abs = absolute(self_01)
    correction_4_padded = correction_4_size + 2.004168360008973e-292
    self_02_abs = absolute(self_02)
    self_00_new_c_size = self_00_abs * correction_0_padded + self_01_abs * correction_3_padded
    self_00_new_size = self_00_abs + (self_00_new_c_size + self_02_abs * correction_4_padded)
    correction_1_padded = correction_1_size + 2.004168360008973e-292
    correction_5_padded = correction_5_size + 2.004168360008973e-292
    self_01_new_c_size = self_00_abs * correction_3_padded + self_01_abs * correction_1_padded
    self_01_new_size = self_01_new_c_size + self_02_abs * correction_5_padded + self_01_abs
    correction_2_padded = correction_2_size + 2.004168360008973e-292
    self_02_new_c_size = self_00_abs * correction_4_padded + self_01_abs * correction_5_padded
    self_02_new_size = self_02_new_c_size + self_02_abs * correction_2_padded + self_02_abs
    self_10_abs = absolute(self_10)
    self_11_abs = absolute(self_11)
    self_12_abs = absolute(self_12)
    self_10_new_c_size = self_10_abs * correction_0_padded + self_11_abs * correction_3_padded
    self_10_new_size = self_10_abs + (self_10_new_c_size + self_12_abs * correction_4_padded)
    self_11_new_c_size = self_10_abs * correction_3_padded + self_11_abs * correction_1_padded
    self_11_new_size = self_11_new_c_size + self_12_abs * correction_5_padded + self_11_abs
    self_12_new_c_size = self_10_abs * correction_4_padded + self_11_abs * correction_5_padded
    self_12_new_size = self_12_new_c_size + self_12_abs * correction_2_padded + self_12_abs
    self_20_abs = absolute(self_20)
    self_21_abs = absolute(self_21)
    self_22_abs = absolute(self_22)
    self_20_new_c_size = self_20_abs * correction_0_padded + self_21_abs * correction_3_padded
    self_20_new_size = self_20_abs + (self_20_new_c_size + self_22_abs * correction_4_padded)
    self_21_new_c_size = self_20_abs * correction_3_padded + self_21_abs * correction_1_padded
    self_21_new_size = self_21_new_c_size + self_22_abs * correction_5_padded + self_21_abs
    self_22_new_c_size = self_20_abs * correction_4_padded + self_21_abs * correction_5_padded
    self_22_new_size = self_22_new_c_size + self_22_abs * correction_2_padded + self_22_abs
    self_00_new_error_bound = 9.992007221626415e-16 * (self_00_new_size + 2.004168360008973e-292)
    self_01_new_error_bound = 9.992007221626415e-16 * (self_01_new_size + 2.004168360008973e-292)
    self_02_new_error_bound = 8.881784197001258e-16 * (self_02_new_size + 2.004168360008973e-292)
    self_10_new_error_bound = 9.992007221626415e-16 * (self_10_new_size + 2.004168360008973e-292)
    self_11_new_error_bound = 9.992007221626415e-16 * (self_11_new_size + 2.004168360008973e-292)
    self_12_new_error_bound = 8.881784197001258e-16 * (self_12_new_size + 2.004168360008973e-292)
    self_20_new_error_bound = 9.992007221626415e-16 * (self_20_new_size + 2.004168360008973e-292)
    self_21_new_error_bound = 9.992007221626415e-16 * (self_21_new_size + 2.004168360008973e-292)
    self_22_new_error_bound = 8.881784197001258e-16 * (self_22_new_size + 2.004168360008973e-292)
    return (self_00_new, self_01_new, self_02_new, self_10_new, self_11_new, self_12_new,
        self_20_new, self_21_new, self_22_new, self_00_new_error_bound, self_01_new_error_bound,
        self_02_new_error_bound, self_10_new_error_bound, self_11_new_error_bound,
        self_12_new_error_bound, self_20_new_error_bound, self_21_new_error_bound,
        self_22_new_error_bound)


@kernel("(3,3)->(3,3),(3,3)")
def mat3x3_orthonormalized(R):
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
    correction_0_size = 0.5 * (defect_0_size + 2.004168360008973e-292)
    correction_1_size = 0.5 * (defect_1_size + 2.004168360008973e-292)
    correction_2_size = 0.5 * (defect_2_size + 2.004168360008973e-292)
    defect_3e_size = absolute(defect_3a) + absolute(defect_3b) + absolute(defect_3d)
    correction_3_size = 0.5 * (defect_3e_size + 2.004168360008973e-292)
    defect_4e_size = absolute(defect_4a) + absolute(defect_4b) + absolute(defect_4d)
    correction_4_size = 0.5 * (defect_4e_size + 2.004168360008973e-292)
    defect_5e_size = absolute(defect_5a) + absolute(defect_5b) + absolute(defect_5d)
    correction_5_size = 0.5 * (defect_5e_size + 2.004168360008973e-292)
    correction_0_padded = correction_0_size + 2.004168360008973e-292
    R_00_abs = absolute(R_00)
    correction_3_padded = correction_3_size + 2.004168360008973e-292
    R_01_abs = absolute(R_01)
    correction_4_padded = correction_4_size + 2.004168360008973e-292
    R_02_abs = absolute(R_02)
    Ro_00c_size = R_00_abs * correction_0_padded + R_01_abs * correction_3_padded
    Ro_00_size = R_00_abs + (Ro_00c_size + R_02_abs * correction_4_padded)
    correction_1_padded = correction_1_size + 2.004168360008973e-292
    correction_5_padded = correction_5_size + 2.004168360008973e-292
    Ro_01c_size = R_00_abs * correction_3_padded + R_01_abs * correction_1_padded
    Ro_01_size = Ro_01c_size + R_02_abs * correction_5_padded + R_01_abs
    correction_2_padded = correction_2_size + 2.004168360008973e-292
    Ro_02c_size = R_00_abs * correction_4_padded + R_01_abs * correction_5_padded
    Ro_02_size = Ro_02c_size + R_02_abs * correction_2_padded + R_02_abs
    R_10_abs = absolute(R_10)
    R_11_abs = absolute(R_11)
    R_12_abs = absolute(R_12)
    Ro_10c_size = R_10_abs * correction_0_padded + R_11_abs * correction_3_padded
    Ro_10_size = R_10_abs + (Ro_10c_size + R_12_abs * correction_4_padded)
    Ro_11c_size = R_10_abs * correction_3_padded + R_11_abs * correction_1_padded
    Ro_11_size = Ro_11c_size + R_12_abs * correction_5_padded + R_11_abs
    Ro_12c_size = R_10_abs * correction_4_padded + R_11_abs * correction_5_padded
    Ro_12_size = Ro_12c_size + R_12_abs * correction_2_padded + R_12_abs
    R_20_abs = absolute(R_20)
    R_21_abs = absolute(R_21)
    R_22_abs = absolute(R_22)
    Ro_20c_size = R_20_abs * correction_0_padded + R_21_abs * correction_3_padded
    Ro_20_size = R_20_abs + (Ro_20c_size + R_22_abs * correction_4_padded)
    Ro_21c_size = R_20_abs * correction_3_padded + R_21_abs * correction_1_padded
    Ro_21_size = Ro_21c_size + R_22_abs * correction_5_padded + R_21_abs
    Ro_22c_size = R_20_abs * correction_4_padded + R_21_abs * correction_5_padded
    Ro_22_size = Ro_22c_size + R_22_abs * correction_2_padded + R_22_abs
    Ro_00_error_bound = 9.992007221626415e-16 * (Ro_00_size + 2.004168360008973e-292)
    Ro_01_error_bound = 9.992007221626415e-16 * (Ro_01_size + 2.004168360008973e-292)
    Ro_02_error_bound = 8.881784197001258e-16 * (Ro_02_size + 2.004168360008973e-292)
    Ro_10_error_bound = 9.992007221626415e-16 * (Ro_10_size + 2.004168360008973e-292)
    Ro_11_error_bound = 9.992007221626415e-16 * (Ro_11_size + 2.004168360008973e-292)
    Ro_12_error_bound = 8.881784197001258e-16 * (Ro_12_size + 2.004168360008973e-292)
    Ro_20_error_bound = 9.992007221626415e-16 * (Ro_20_size + 2.004168360008973e-292)
    Ro_21_error_bound = 9.992007221626415e-16 * (Ro_21_size + 2.004168360008973e-292)
    Ro_22_error_bound = 8.881784197001258e-16 * (Ro_22_size + 2.004168360008973e-292)
    return (Ro_00, Ro_01, Ro_02, Ro_10, Ro_11, Ro_12, Ro_20, Ro_21, Ro_22, Ro_00_error_bound,
        Ro_01_error_bound, Ro_02_error_bound, Ro_10_error_bound, Ro_11_error_bound,
        Ro_12_error_bound, Ro_20_error_bound, Ro_21_error_bound, Ro_22_error_bound)
