/* Made by `coscrew generate`; changes are overwritten. */
/* SPDX-License-Identifier: MIT */
/* coscrew 0.2.0.  Copyright (c) 2026 The coscrew authors. */
/* Exponentials and logarithms of rotations and displacements, their Jacobians, interpolation.
   Certified tier: plain results, and bounds on their errors that always hold. */
#ifndef KSL_EXPONENTIAL_CERTIFIED_H
#define KSL_EXPONENTIAL_CERTIFIED_H

#include "ksl_types.h"

/* self = R + R (I - R^T R)/2, closer to a rotation: a defect d of R becomes 3/4 d^2; |error of
     self| <= self_bound unless inf or NaN.
   self, self_bound: rotation or other 3×3 matrix.
   93 mul, 105 add, 3 neg, 27 abs. */
static inline void ksl_mat3x3_orthonormalize_certified(ksl_mat3x3_t *self,
    ksl_mat3x3_t *self_bound) {
  const double defect_0a = KSL_MUL(self->m00, self->m00), defect_0b = 1.0 - defect_0a,
      defect_0c = KSL_MUL(self->m10, self->m10), defect_0d = defect_0b - defect_0c,
      defect_0e = KSL_MUL(self->m20, self->m20), defect_0 = defect_0d - defect_0e;
  const double defect_1a = KSL_MUL(self->m01, self->m01), defect_1b = 1.0 - defect_1a,
      defect_1c = KSL_MUL(self->m11, self->m11), defect_1d = defect_1b - defect_1c,
      defect_1e = KSL_MUL(self->m21, self->m21), defect_1 = defect_1d - defect_1e;
  const double defect_2a = KSL_MUL(self->m02, self->m02), defect_2b = 1.0 - defect_2a,
      defect_2c = KSL_MUL(self->m12, self->m12), defect_2d = defect_2b - defect_2c,
      defect_2e = KSL_MUL(self->m22, self->m22), defect_2 = defect_2d - defect_2e;
  const double defect_3a = KSL_MUL(self->m00, self->m01), defect_3b = KSL_MUL(self->m10, self->m11),
      defect_3c = defect_3a + defect_3b, defect_3d = KSL_MUL(self->m20, self->m21),
      defect_3e = defect_3c + defect_3d, defect_3 = -defect_3e;
  const double defect_4a = KSL_MUL(self->m00, self->m02), defect_4b = KSL_MUL(self->m10, self->m12),
      defect_4c = defect_4a + defect_4b, defect_4d = KSL_MUL(self->m20, self->m22),
      defect_4e = defect_4c + defect_4d, defect_4 = -defect_4e;
  const double defect_5a = KSL_MUL(self->m01, self->m02), defect_5b = KSL_MUL(self->m11, self->m12),
      defect_5c = defect_5a + defect_5b, defect_5d = KSL_MUL(self->m21, self->m22),
      defect_5e = defect_5c + defect_5d, defect_5 = -defect_5e;
  const double correction_0 = KSL_MUL(0.5, defect_0);
  const double correction_1 = KSL_MUL(0.5, defect_1);
  const double correction_2 = KSL_MUL(0.5, defect_2);
  const double correction_3 = KSL_MUL(0.5, defect_3);
  const double correction_4 = KSL_MUL(0.5, defect_4);
  const double correction_5 = KSL_MUL(0.5, defect_5);
  const double self_00_new_a = KSL_MUL(self->m00, correction_0),
      self_00_new_b = KSL_MUL(self->m01, correction_3),
      self_00_new_c = self_00_new_a + self_00_new_b,
      self_00_new_d = KSL_MUL(self->m02, correction_4),
      self_00_new_e = self_00_new_c + self_00_new_d, self_00_new = self->m00 + self_00_new_e;
  const double self_01_new_a = KSL_MUL(self->m00, correction_3),
      self_01_new_b = KSL_MUL(self->m01, correction_1),
      self_01_new_c = self_01_new_a + self_01_new_b,
      self_01_new_d = KSL_MUL(self->m02, correction_5),
      self_01_new_e = self_01_new_c + self_01_new_d, self_01_new = self_01_new_e + self->m01;
  const double self_02_new_a = KSL_MUL(self->m00, correction_4),
      self_02_new_b = KSL_MUL(self->m01, correction_5),
      self_02_new_c = self_02_new_a + self_02_new_b,
      self_02_new_d = KSL_MUL(self->m02, correction_2),
      self_02_new_e = self_02_new_c + self_02_new_d, self_02_new = self_02_new_e + self->m02;
  const double self_10_new_a = KSL_MUL(self->m10, correction_0),
      self_10_new_b = KSL_MUL(self->m11, correction_3),
      self_10_new_c = self_10_new_a + self_10_new_b,
      self_10_new_d = KSL_MUL(self->m12, correction_4),
      self_10_new_e = self_10_new_c + self_10_new_d, self_10_new = self->m10 + self_10_new_e;
  const double self_11_new_a = KSL_MUL(self->m10, correction_3),
      self_11_new_b = KSL_MUL(self->m11, correction_1),
      self_11_new_c = self_11_new_a + self_11_new_b,
      self_11_new_d = KSL_MUL(self->m12, correction_5),
      self_11_new_e = self_11_new_c + self_11_new_d, self_11_new = self_11_new_e + self->m11;
  const double self_12_new_a = KSL_MUL(self->m10, correction_4),
      self_12_new_b = KSL_MUL(self->m11, correction_5),
      self_12_new_c = self_12_new_a + self_12_new_b,
      self_12_new_d = KSL_MUL(self->m12, correction_2),
      self_12_new_e = self_12_new_c + self_12_new_d, self_12_new = self_12_new_e + self->m12;
  const double self_20_new_a = KSL_MUL(self->m20, correction_0),
      self_20_new_b = KSL_MUL(self->m21, correction_3),
      self_20_new_c = self_20_new_a + self_20_new_b,
      self_20_new_d = KSL_MUL(self->m22, correction_4),
      self_20_new_e = self_20_new_c + self_20_new_d, self_20_new = self->m20 + self_20_new_e;
  const double self_21_new_a = KSL_MUL(self->m20, correction_3),
      self_21_new_b = KSL_MUL(self->m21, correction_1),
      self_21_new_c = self_21_new_a + self_21_new_b,
      self_21_new_d = KSL_MUL(self->m22, correction_5),
      self_21_new_e = self_21_new_c + self_21_new_d, self_21_new = self_21_new_e + self->m21;
  const double self_22_new_a = KSL_MUL(self->m20, correction_4),
      self_22_new_b = KSL_MUL(self->m21, correction_5),
      self_22_new_c = self_22_new_a + self_22_new_b,
      self_22_new_d = KSL_MUL(self->m22, correction_2),
      self_22_new_e = self_22_new_c + self_22_new_d, self_22_new = self_22_new_e + self->m22;
  const double defect_0a_abs = fabs(defect_0a), defect_0b_size = 1.0 + defect_0a_abs,
      defect_0c_abs = fabs(defect_0c), defect_0d_size = defect_0b_size + defect_0c_abs,
      defect_0e_abs = fabs(defect_0e), defect_0_size = defect_0d_size + defect_0e_abs;
  const double defect_1a_abs = fabs(defect_1a), defect_1b_size = 1.0 + defect_1a_abs,
      defect_1c_abs = fabs(defect_1c), defect_1d_size = defect_1b_size + defect_1c_abs,
      defect_1e_abs = fabs(defect_1e), defect_1_size = defect_1d_size + defect_1e_abs;
  const double defect_2a_abs = fabs(defect_2a), defect_2b_size = 1.0 + defect_2a_abs,
      defect_2c_abs = fabs(defect_2c), defect_2d_size = defect_2b_size + defect_2c_abs,
      defect_2e_abs = fabs(defect_2e), defect_2_size = defect_2d_size + defect_2e_abs;
  const double defect_3a_abs = fabs(defect_3a), defect_3b_abs = fabs(defect_3b),
      defect_3c_size = defect_3a_abs + defect_3b_abs, defect_3d_abs = fabs(defect_3d),
      defect_3e_size = defect_3c_size + defect_3d_abs;
  const double defect_4a_abs = fabs(defect_4a), defect_4b_abs = fabs(defect_4b),
      defect_4c_size = defect_4a_abs + defect_4b_abs, defect_4d_abs = fabs(defect_4d),
      defect_4e_size = defect_4c_size + defect_4d_abs;
  const double defect_5a_abs = fabs(defect_5a), defect_5b_abs = fabs(defect_5b),
      defect_5c_size = defect_5a_abs + defect_5b_abs, defect_5d_abs = fabs(defect_5d),
      defect_5e_size = defect_5c_size + defect_5d_abs;
  const double defect_0_padded = defect_0_size + 2.004168360008973e-292;
  const double correction_0_size = KSL_MUL(0.5, defect_0_padded);
  const double defect_1_padded = defect_1_size + 2.004168360008973e-292;
  const double correction_1_size = KSL_MUL(0.5, defect_1_padded);
  const double defect_2_padded = defect_2_size + 2.004168360008973e-292;
  const double correction_2_size = KSL_MUL(0.5, defect_2_padded);
  const double defect_3e_padded = defect_3e_size + 2.004168360008973e-292;
  const double correction_3_size = KSL_MUL(0.5, defect_3e_padded);
  const double defect_4e_padded = defect_4e_size + 2.004168360008973e-292;
  const double correction_4_size = KSL_MUL(0.5, defect_4e_padded);
  const double defect_5e_padded = defect_5e_size + 2.004168360008973e-292;
  const double correction_5_size = KSL_MUL(0.5, defect_5e_padded);
  const double correction_0_padded = correction_0_size + 2.004168360008973e-292;
  const double self_00_abs = fabs(self->m00),
      self_00_new_a_size = KSL_MUL(self_00_abs, correction_0_padded);
  const double correction_3_padded = correction_3_size + 2.004168360008973e-292;
  const double self_01_abs = fabs(self->m01),
      self_00_new_b_size = KSL_MUL(self_01_abs, correction_3_padded),
      self_00_new_c_size = self_00_new_a_size + self_00_new_b_size;
  const double correction_4_padded = correction_4_size + 2.004168360008973e-292;
  const double self_02_abs = fabs(self->m02),
      self_00_new_d_size = KSL_MUL(self_02_abs, correction_4_padded),
      self_00_new_e_size = self_00_new_c_size + self_00_new_d_size,
      self_00_new_size = self_00_abs + self_00_new_e_size;
  const double self_01_new_a_size = KSL_MUL(self_00_abs, correction_3_padded);
  const double correction_1_padded = correction_1_size + 2.004168360008973e-292;
  const double self_01_new_b_size = KSL_MUL(self_01_abs, correction_1_padded),
      self_01_new_c_size = self_01_new_a_size + self_01_new_b_size;
  const double correction_5_padded = correction_5_size + 2.004168360008973e-292;
  const double self_01_new_d_size = KSL_MUL(self_02_abs, correction_5_padded),
      self_01_new_e_size = self_01_new_c_size + self_01_new_d_size,
      self_01_new_size = self_01_new_e_size + self_01_abs;
  const double self_02_new_a_size = KSL_MUL(self_00_abs, correction_4_padded),
      self_02_new_b_size = KSL_MUL(self_01_abs, correction_5_padded),
      self_02_new_c_size = self_02_new_a_size + self_02_new_b_size;
  const double correction_2_padded = correction_2_size + 2.004168360008973e-292;
  const double self_02_new_d_size = KSL_MUL(self_02_abs, correction_2_padded),
      self_02_new_e_size = self_02_new_c_size + self_02_new_d_size,
      self_02_new_size = self_02_new_e_size + self_02_abs;
  const double self_10_abs = fabs(self->m10),
      self_10_new_a_size = KSL_MUL(self_10_abs, correction_0_padded), self_11_abs = fabs(self->m11),
      self_10_new_b_size = KSL_MUL(self_11_abs, correction_3_padded),
      self_10_new_c_size = self_10_new_a_size + self_10_new_b_size, self_12_abs = fabs(self->m12),
      self_10_new_d_size = KSL_MUL(self_12_abs, correction_4_padded),
      self_10_new_e_size = self_10_new_c_size + self_10_new_d_size,
      self_10_new_size = self_10_abs + self_10_new_e_size;
  const double self_11_new_a_size = KSL_MUL(self_10_abs, correction_3_padded),
      self_11_new_b_size = KSL_MUL(self_11_abs, correction_1_padded),
      self_11_new_c_size = self_11_new_a_size + self_11_new_b_size,
      self_11_new_d_size = KSL_MUL(self_12_abs, correction_5_padded),
      self_11_new_e_size = self_11_new_c_size + self_11_new_d_size,
      self_11_new_size = self_11_new_e_size + self_11_abs;
  const double self_12_new_a_size = KSL_MUL(self_10_abs, correction_4_padded),
      self_12_new_b_size = KSL_MUL(self_11_abs, correction_5_padded),
      self_12_new_c_size = self_12_new_a_size + self_12_new_b_size,
      self_12_new_d_size = KSL_MUL(self_12_abs, correction_2_padded),
      self_12_new_e_size = self_12_new_c_size + self_12_new_d_size,
      self_12_new_size = self_12_new_e_size + self_12_abs;
  const double self_20_abs = fabs(self->m20),
      self_20_new_a_size = KSL_MUL(self_20_abs, correction_0_padded), self_21_abs = fabs(self->m21),
      self_20_new_b_size = KSL_MUL(self_21_abs, correction_3_padded),
      self_20_new_c_size = self_20_new_a_size + self_20_new_b_size, self_22_abs = fabs(self->m22),
      self_20_new_d_size = KSL_MUL(self_22_abs, correction_4_padded),
      self_20_new_e_size = self_20_new_c_size + self_20_new_d_size,
      self_20_new_size = self_20_abs + self_20_new_e_size;
  const double self_21_new_a_size = KSL_MUL(self_20_abs, correction_3_padded),
      self_21_new_b_size = KSL_MUL(self_21_abs, correction_1_padded),
      self_21_new_c_size = self_21_new_a_size + self_21_new_b_size,
      self_21_new_d_size = KSL_MUL(self_22_abs, correction_5_padded),
      self_21_new_e_size = self_21_new_c_size + self_21_new_d_size,
      self_21_new_size = self_21_new_e_size + self_21_abs;
  const double self_22_new_a_size = KSL_MUL(self_20_abs, correction_4_padded),
      self_22_new_b_size = KSL_MUL(self_21_abs, correction_5_padded),
      self_22_new_c_size = self_22_new_a_size + self_22_new_b_size,
      self_22_new_d_size = KSL_MUL(self_22_abs, correction_2_padded),
      self_22_new_e_size = self_22_new_c_size + self_22_new_d_size,
      self_22_new_size = self_22_new_e_size + self_22_abs;
  const double self_00_new_padded = self_00_new_size + 2.004168360008973e-292,
      self_00_new_error_bound = KSL_MUL(9.992007221626415e-16, self_00_new_padded);
  const double self_01_new_padded = self_01_new_size + 2.004168360008973e-292,
      self_01_new_error_bound = KSL_MUL(9.992007221626415e-16, self_01_new_padded);
  const double self_02_new_padded = self_02_new_size + 2.004168360008973e-292,
      self_02_new_error_bound = KSL_MUL(8.881784197001258e-16, self_02_new_padded);
  const double self_10_new_padded = self_10_new_size + 2.004168360008973e-292,
      self_10_new_error_bound = KSL_MUL(9.992007221626415e-16, self_10_new_padded);
  const double self_11_new_padded = self_11_new_size + 2.004168360008973e-292,
      self_11_new_error_bound = KSL_MUL(9.992007221626415e-16, self_11_new_padded);
  const double self_12_new_padded = self_12_new_size + 2.004168360008973e-292,
      self_12_new_error_bound = KSL_MUL(8.881784197001258e-16, self_12_new_padded);
  const double self_20_new_padded = self_20_new_size + 2.004168360008973e-292,
      self_20_new_error_bound = KSL_MUL(9.992007221626415e-16, self_20_new_padded);
  const double self_21_new_padded = self_21_new_size + 2.004168360008973e-292,
      self_21_new_error_bound = KSL_MUL(9.992007221626415e-16, self_21_new_padded);
  const double self_22_new_padded = self_22_new_size + 2.004168360008973e-292,
      self_22_new_error_bound = KSL_MUL(8.881784197001258e-16, self_22_new_padded);
  self->m00 = self_00_new;
  self->m01 = self_01_new;
  self->m02 = self_02_new;
  self->m10 = self_10_new;
  self->m11 = self_11_new;
  self->m12 = self_12_new;
  self->m20 = self_20_new;
  self->m21 = self_21_new;
  self->m22 = self_22_new;
  self_bound->m00 = self_00_new_error_bound;
  self_bound->m01 = self_01_new_error_bound;
  self_bound->m02 = self_02_new_error_bound;
  self_bound->m10 = self_10_new_error_bound;
  self_bound->m11 = self_11_new_error_bound;
  self_bound->m12 = self_12_new_error_bound;
  self_bound->m20 = self_20_new_error_bound;
  self_bound->m21 = self_21_new_error_bound;
  self_bound->m22 = self_22_new_error_bound;
}

/* Ro = R + R (I - R^T R)/2, closer to a rotation: a defect d of R becomes 3/4 d^2; |error of Ro|
     <= Ro_bound unless inf or NaN.
   R, Ro, Ro_bound: rotation or other 3×3 matrix.
   93 mul, 105 add, 3 neg, 27 abs. */
static inline void ksl_mat3x3_orthonormalized_certified(const ksl_mat3x3_t *R, ksl_mat3x3_t *Ro,
    ksl_mat3x3_t *Ro_bound) {
  const double defect_0a = KSL_MUL(R->m00, R->m00), defect_0b = 1.0 - defect_0a,
      defect_0c = KSL_MUL(R->m10, R->m10), defect_0d = defect_0b - defect_0c,
      defect_0e = KSL_MUL(R->m20, R->m20), defect_0 = defect_0d - defect_0e;
  const double defect_1a = KSL_MUL(R->m01, R->m01), defect_1b = 1.0 - defect_1a,
      defect_1c = KSL_MUL(R->m11, R->m11), defect_1d = defect_1b - defect_1c,
      defect_1e = KSL_MUL(R->m21, R->m21), defect_1 = defect_1d - defect_1e;
  const double defect_2a = KSL_MUL(R->m02, R->m02), defect_2b = 1.0 - defect_2a,
      defect_2c = KSL_MUL(R->m12, R->m12), defect_2d = defect_2b - defect_2c,
      defect_2e = KSL_MUL(R->m22, R->m22), defect_2 = defect_2d - defect_2e;
  const double defect_3a = KSL_MUL(R->m00, R->m01), defect_3b = KSL_MUL(R->m10, R->m11),
      defect_3c = defect_3a + defect_3b, defect_3d = KSL_MUL(R->m20, R->m21),
      defect_3e = defect_3c + defect_3d, defect_3 = -defect_3e;
  const double defect_4a = KSL_MUL(R->m00, R->m02), defect_4b = KSL_MUL(R->m10, R->m12),
      defect_4c = defect_4a + defect_4b, defect_4d = KSL_MUL(R->m20, R->m22),
      defect_4e = defect_4c + defect_4d, defect_4 = -defect_4e;
  const double defect_5a = KSL_MUL(R->m01, R->m02), defect_5b = KSL_MUL(R->m11, R->m12),
      defect_5c = defect_5a + defect_5b, defect_5d = KSL_MUL(R->m21, R->m22),
      defect_5e = defect_5c + defect_5d, defect_5 = -defect_5e;
  const double correction_0 = KSL_MUL(0.5, defect_0);
  const double correction_1 = KSL_MUL(0.5, defect_1);
  const double correction_2 = KSL_MUL(0.5, defect_2);
  const double correction_3 = KSL_MUL(0.5, defect_3);
  const double correction_4 = KSL_MUL(0.5, defect_4);
  const double correction_5 = KSL_MUL(0.5, defect_5);
  const double Ro_00a = KSL_MUL(R->m00, correction_0), Ro_00b = KSL_MUL(R->m01, correction_3),
      Ro_00c = Ro_00a + Ro_00b, Ro_00d = KSL_MUL(R->m02, correction_4), Ro_00e = Ro_00c + Ro_00d,
      Ro_00 = R->m00 + Ro_00e;
  const double Ro_01a = KSL_MUL(R->m00, correction_3), Ro_01b = KSL_MUL(R->m01, correction_1),
      Ro_01c = Ro_01a + Ro_01b, Ro_01d = KSL_MUL(R->m02, correction_5), Ro_01e = Ro_01c + Ro_01d,
      Ro_01 = Ro_01e + R->m01;
  const double Ro_02a = KSL_MUL(R->m00, correction_4), Ro_02b = KSL_MUL(R->m01, correction_5),
      Ro_02c = Ro_02a + Ro_02b, Ro_02d = KSL_MUL(R->m02, correction_2), Ro_02e = Ro_02c + Ro_02d,
      Ro_02 = Ro_02e + R->m02;
  const double Ro_10a = KSL_MUL(R->m10, correction_0), Ro_10b = KSL_MUL(R->m11, correction_3),
      Ro_10c = Ro_10a + Ro_10b, Ro_10d = KSL_MUL(R->m12, correction_4), Ro_10e = Ro_10c + Ro_10d,
      Ro_10 = R->m10 + Ro_10e;
  const double Ro_11a = KSL_MUL(R->m10, correction_3), Ro_11b = KSL_MUL(R->m11, correction_1),
      Ro_11c = Ro_11a + Ro_11b, Ro_11d = KSL_MUL(R->m12, correction_5), Ro_11e = Ro_11c + Ro_11d,
      Ro_11 = Ro_11e + R->m11;
  const double Ro_12a = KSL_MUL(R->m10, correction_4), Ro_12b = KSL_MUL(R->m11, correction_5),
      Ro_12c = Ro_12a + Ro_12b, Ro_12d = KSL_MUL(R->m12, correction_2), Ro_12e = Ro_12c + Ro_12d,
      Ro_12 = Ro_12e + R->m12;
  const double Ro_20a = KSL_MUL(R->m20, correction_0), Ro_20b = KSL_MUL(R->m21, correction_3),
      Ro_20c = Ro_20a + Ro_20b, Ro_20d = KSL_MUL(R->m22, correction_4), Ro_20e = Ro_20c + Ro_20d,
      Ro_20 = R->m20 + Ro_20e;
  const double Ro_21a = KSL_MUL(R->m20, correction_3), Ro_21b = KSL_MUL(R->m21, correction_1),
      Ro_21c = Ro_21a + Ro_21b, Ro_21d = KSL_MUL(R->m22, correction_5), Ro_21e = Ro_21c + Ro_21d,
      Ro_21 = Ro_21e + R->m21;
  const double Ro_22a = KSL_MUL(R->m20, correction_4), Ro_22b = KSL_MUL(R->m21, correction_5),
      Ro_22c = Ro_22a + Ro_22b, Ro_22d = KSL_MUL(R->m22, correction_2), Ro_22e = Ro_22c + Ro_22d,
      Ro_22 = Ro_22e + R->m22;
  const double defect_0a_abs = fabs(defect_0a), defect_0b_size = 1.0 + defect_0a_abs,
      defect_0c_abs = fabs(defect_0c), defect_0d_size = defect_0b_size + defect_0c_abs,
      defect_0e_abs = fabs(defect_0e), defect_0_size = defect_0d_size + defect_0e_abs;
  const double defect_1a_abs = fabs(defect_1a), defect_1b_size = 1.0 + defect_1a_abs,
      defect_1c_abs = fabs(defect_1c), defect_1d_size = defect_1b_size + defect_1c_abs,
      defect_1e_abs = fabs(defect_1e), defect_1_size = defect_1d_size + defect_1e_abs;
  const double defect_2a_abs = fabs(defect_2a), defect_2b_size = 1.0 + defect_2a_abs,
      defect_2c_abs = fabs(defect_2c), defect_2d_size = defect_2b_size + defect_2c_abs,
      defect_2e_abs = fabs(defect_2e), defect_2_size = defect_2d_size + defect_2e_abs;
  const double defect_3a_abs = fabs(defect_3a), defect_3b_abs = fabs(defect_3b),
      defect_3c_size = defect_3a_abs + defect_3b_abs, defect_3d_abs = fabs(defect_3d),
      defect_3e_size = defect_3c_size + defect_3d_abs;
  const double defect_4a_abs = fabs(defect_4a), defect_4b_abs = fabs(defect_4b),
      defect_4c_size = defect_4a_abs + defect_4b_abs, defect_4d_abs = fabs(defect_4d),
      defect_4e_size = defect_4c_size + defect_4d_abs;
  const double defect_5a_abs = fabs(defect_5a), defect_5b_abs = fabs(defect_5b),
      defect_5c_size = defect_5a_abs + defect_5b_abs, defect_5d_abs = fabs(defect_5d),
      defect_5e_size = defect_5c_size + defect_5d_abs;
  const double defect_0_padded = defect_0_size + 2.004168360008973e-292;
  const double correction_0_size = KSL_MUL(0.5, defect_0_padded);
  const double defect_1_padded = defect_1_size + 2.004168360008973e-292;
  const double correction_1_size = KSL_MUL(0.5, defect_1_padded);
  const double defect_2_padded = defect_2_size + 2.004168360008973e-292;
  const double correction_2_size = KSL_MUL(0.5, defect_2_padded);
  const double defect_3e_padded = defect_3e_size + 2.004168360008973e-292;
  const double correction_3_size = KSL_MUL(0.5, defect_3e_padded);
  const double defect_4e_padded = defect_4e_size + 2.004168360008973e-292;
  const double correction_4_size = KSL_MUL(0.5, defect_4e_padded);
  const double defect_5e_padded = defect_5e_size + 2.004168360008973e-292;
  const double correction_5_size = KSL_MUL(0.5, defect_5e_padded);
  const double correction_0_padded = correction_0_size + 2.004168360008973e-292;
  const double R_00_abs = fabs(R->m00), Ro_00a_size = KSL_MUL(R_00_abs, correction_0_padded);
  const double correction_3_padded = correction_3_size + 2.004168360008973e-292;
  const double R_01_abs = fabs(R->m01), Ro_00b_size = KSL_MUL(R_01_abs, correction_3_padded),
      Ro_00c_size = Ro_00a_size + Ro_00b_size;
  const double correction_4_padded = correction_4_size + 2.004168360008973e-292;
  const double R_02_abs = fabs(R->m02), Ro_00d_size = KSL_MUL(R_02_abs, correction_4_padded),
      Ro_00e_size = Ro_00c_size + Ro_00d_size, Ro_00_size = R_00_abs + Ro_00e_size;
  const double Ro_01a_size = KSL_MUL(R_00_abs, correction_3_padded);
  const double correction_1_padded = correction_1_size + 2.004168360008973e-292;
  const double Ro_01b_size = KSL_MUL(R_01_abs, correction_1_padded),
      Ro_01c_size = Ro_01a_size + Ro_01b_size;
  const double correction_5_padded = correction_5_size + 2.004168360008973e-292;
  const double Ro_01d_size = KSL_MUL(R_02_abs, correction_5_padded),
      Ro_01e_size = Ro_01c_size + Ro_01d_size, Ro_01_size = Ro_01e_size + R_01_abs;
  const double Ro_02a_size = KSL_MUL(R_00_abs, correction_4_padded),
      Ro_02b_size = KSL_MUL(R_01_abs, correction_5_padded), Ro_02c_size = Ro_02a_size + Ro_02b_size;
  const double correction_2_padded = correction_2_size + 2.004168360008973e-292;
  const double Ro_02d_size = KSL_MUL(R_02_abs, correction_2_padded),
      Ro_02e_size = Ro_02c_size + Ro_02d_size, Ro_02_size = Ro_02e_size + R_02_abs;
  const double R_10_abs = fabs(R->m10), Ro_10a_size = KSL_MUL(R_10_abs, correction_0_padded),
      R_11_abs = fabs(R->m11), Ro_10b_size = KSL_MUL(R_11_abs, correction_3_padded),
      Ro_10c_size = Ro_10a_size + Ro_10b_size, R_12_abs = fabs(R->m12),
      Ro_10d_size = KSL_MUL(R_12_abs, correction_4_padded), Ro_10e_size = Ro_10c_size + Ro_10d_size,
      Ro_10_size = R_10_abs + Ro_10e_size;
  const double Ro_11a_size = KSL_MUL(R_10_abs, correction_3_padded),
      Ro_11b_size = KSL_MUL(R_11_abs, correction_1_padded), Ro_11c_size = Ro_11a_size + Ro_11b_size,
      Ro_11d_size = KSL_MUL(R_12_abs, correction_5_padded), Ro_11e_size = Ro_11c_size + Ro_11d_size,
      Ro_11_size = Ro_11e_size + R_11_abs;
  const double Ro_12a_size = KSL_MUL(R_10_abs, correction_4_padded),
      Ro_12b_size = KSL_MUL(R_11_abs, correction_5_padded), Ro_12c_size = Ro_12a_size + Ro_12b_size,
      Ro_12d_size = KSL_MUL(R_12_abs, correction_2_padded), Ro_12e_size = Ro_12c_size + Ro_12d_size,
      Ro_12_size = Ro_12e_size + R_12_abs;
  const double R_20_abs = fabs(R->m20), Ro_20a_size = KSL_MUL(R_20_abs, correction_0_padded),
      R_21_abs = fabs(R->m21), Ro_20b_size = KSL_MUL(R_21_abs, correction_3_padded),
      Ro_20c_size = Ro_20a_size + Ro_20b_size, R_22_abs = fabs(R->m22),
      Ro_20d_size = KSL_MUL(R_22_abs, correction_4_padded), Ro_20e_size = Ro_20c_size + Ro_20d_size,
      Ro_20_size = R_20_abs + Ro_20e_size;
  const double Ro_21a_size = KSL_MUL(R_20_abs, correction_3_padded),
      Ro_21b_size = KSL_MUL(R_21_abs, correction_1_padded), Ro_21c_size = Ro_21a_size + Ro_21b_size,
      Ro_21d_size = KSL_MUL(R_22_abs, correction_5_padded), Ro_21e_size = Ro_21c_size + Ro_21d_size,
      Ro_21_size = Ro_21e_size + R_21_abs;
  const double Ro_22a_size = KSL_MUL(R_20_abs, correction_4_padded),
      Ro_22b_size = KSL_MUL(R_21_abs, correction_5_padded), Ro_22c_size = Ro_22a_size + Ro_22b_size,
      Ro_22d_size = KSL_MUL(R_22_abs, correction_2_padded), Ro_22e_size = Ro_22c_size + Ro_22d_size,
      Ro_22_size = Ro_22e_size + R_22_abs;
  const double Ro_00_padded = Ro_00_size + 2.004168360008973e-292,
      Ro_00_error_bound = KSL_MUL(9.992007221626415e-16, Ro_00_padded);
  const double Ro_01_padded = Ro_01_size + 2.004168360008973e-292,
      Ro_01_error_bound = KSL_MUL(9.992007221626415e-16, Ro_01_padded);
  const double Ro_02_padded = Ro_02_size + 2.004168360008973e-292,
      Ro_02_error_bound = KSL_MUL(8.881784197001258e-16, Ro_02_padded);
  const double Ro_10_padded = Ro_10_size + 2.004168360008973e-292,
      Ro_10_error_bound = KSL_MUL(9.992007221626415e-16, Ro_10_padded);
  const double Ro_11_padded = Ro_11_size + 2.004168360008973e-292,
      Ro_11_error_bound = KSL_MUL(9.992007221626415e-16, Ro_11_padded);
  const double Ro_12_padded = Ro_12_size + 2.004168360008973e-292,
      Ro_12_error_bound = KSL_MUL(8.881784197001258e-16, Ro_12_padded);
  const double Ro_20_padded = Ro_20_size + 2.004168360008973e-292,
      Ro_20_error_bound = KSL_MUL(9.992007221626415e-16, Ro_20_padded);
  const double Ro_21_padded = Ro_21_size + 2.004168360008973e-292,
      Ro_21_error_bound = KSL_MUL(9.992007221626415e-16, Ro_21_padded);
  const double Ro_22_padded = Ro_22_size + 2.004168360008973e-292,
      Ro_22_error_bound = KSL_MUL(8.881784197001258e-16, Ro_22_padded);
  Ro->m00 = Ro_00;
  Ro->m01 = Ro_01;
  Ro->m02 = Ro_02;
  Ro->m10 = Ro_10;
  Ro->m11 = Ro_11;
  Ro->m12 = Ro_12;
  Ro->m20 = Ro_20;
  Ro->m21 = Ro_21;
  Ro->m22 = Ro_22;
  Ro_bound->m00 = Ro_00_error_bound;
  Ro_bound->m01 = Ro_01_error_bound;
  Ro_bound->m02 = Ro_02_error_bound;
  Ro_bound->m10 = Ro_10_error_bound;
  Ro_bound->m11 = Ro_11_error_bound;
  Ro_bound->m12 = Ro_12_error_bound;
  Ro_bound->m20 = Ro_20_error_bound;
  Ro_bound->m21 = Ro_21_error_bound;
  Ro_bound->m22 = Ro_22_error_bound;
}

/* self = R + R (I - R^T R)/2, closer to a rotation: a defect d of R becomes 3/4 d^2; |error of
     self| <= self_bound unless inf or NaN.
   self, self_bound: rotation or other 3×3 matrix.
   93 mul, 105 add, 3 neg, 27 abs. */
static inline void ksl_mat3x3f_orthonormalize_certified(ksl_mat3x3f_t *self,
    ksl_mat3x3f_t *self_bound) {
  const float defect_0a = KSL_MULF(self->m00, self->m00), defect_0b = 1.0f - defect_0a,
      defect_0c = KSL_MULF(self->m10, self->m10), defect_0d = defect_0b - defect_0c,
      defect_0e = KSL_MULF(self->m20, self->m20), defect_0 = defect_0d - defect_0e;
  const float defect_1a = KSL_MULF(self->m01, self->m01), defect_1b = 1.0f - defect_1a,
      defect_1c = KSL_MULF(self->m11, self->m11), defect_1d = defect_1b - defect_1c,
      defect_1e = KSL_MULF(self->m21, self->m21), defect_1 = defect_1d - defect_1e;
  const float defect_2a = KSL_MULF(self->m02, self->m02), defect_2b = 1.0f - defect_2a,
      defect_2c = KSL_MULF(self->m12, self->m12), defect_2d = defect_2b - defect_2c,
      defect_2e = KSL_MULF(self->m22, self->m22), defect_2 = defect_2d - defect_2e;
  const float defect_3a = KSL_MULF(self->m00, self->m01),
      defect_3b = KSL_MULF(self->m10, self->m11), defect_3c = defect_3a + defect_3b,
      defect_3d = KSL_MULF(self->m20, self->m21), defect_3e = defect_3c + defect_3d,
      defect_3 = -defect_3e;
  const float defect_4a = KSL_MULF(self->m00, self->m02),
      defect_4b = KSL_MULF(self->m10, self->m12), defect_4c = defect_4a + defect_4b,
      defect_4d = KSL_MULF(self->m20, self->m22), defect_4e = defect_4c + defect_4d,
      defect_4 = -defect_4e;
  const float defect_5a = KSL_MULF(self->m01, self->m02),
      defect_5b = KSL_MULF(self->m11, self->m12), defect_5c = defect_5a + defect_5b,
      defect_5d = KSL_MULF(self->m21, self->m22), defect_5e = defect_5c + defect_5d,
      defect_5 = -defect_5e;
  const float correction_0 = KSL_MULF(0.5f, defect_0);
  const float correction_1 = KSL_MULF(0.5f, defect_1);
  const float correction_2 = KSL_MULF(0.5f, defect_2);
  const float correction_3 = KSL_MULF(0.5f, defect_3);
  const float correction_4 = KSL_MULF(0.5f, defect_4);
  const float correction_5 = KSL_MULF(0.5f, defect_5);
  const float self_00_new_a = KSL_MULF(self->m00, correction_0),
      self_00_new_b = KSL_MULF(self->m01, correction_3),
      self_00_new_c = self_00_new_a + self_00_new_b,
      self_00_new_d = KSL_MULF(self->m02, correction_4),
      self_00_new_e = self_00_new_c + self_00_new_d, self_00_new = self->m00 + self_00_new_e;
  const float self_01_new_a = KSL_MULF(self->m00, correction_3),
      self_01_new_b = KSL_MULF(self->m01, correction_1),
      self_01_new_c = self_01_new_a + self_01_new_b,
      self_01_new_d = KSL_MULF(self->m02, correction_5),
      self_01_new_e = self_01_new_c + self_01_new_d, self_01_new = self_01_new_e + self->m01;
  const float self_02_new_a = KSL_MULF(self->m00, correction_4),
      self_02_new_b = KSL_MULF(self->m01, correction_5),
      self_02_new_c = self_02_new_a + self_02_new_b,
      self_02_new_d = KSL_MULF(self->m02, correction_2),
      self_02_new_e = self_02_new_c + self_02_new_d, self_02_new = self_02_new_e + self->m02;
  const float self_10_new_a = KSL_MULF(self->m10, correction_0),
      self_10_new_b = KSL_MULF(self->m11, correction_3),
      self_10_new_c = self_10_new_a + self_10_new_b,
      self_10_new_d = KSL_MULF(self->m12, correction_4),
      self_10_new_e = self_10_new_c + self_10_new_d, self_10_new = self->m10 + self_10_new_e;
  const float self_11_new_a = KSL_MULF(self->m10, correction_3),
      self_11_new_b = KSL_MULF(self->m11, correction_1),
      self_11_new_c = self_11_new_a + self_11_new_b,
      self_11_new_d = KSL_MULF(self->m12, correction_5),
      self_11_new_e = self_11_new_c + self_11_new_d, self_11_new = self_11_new_e + self->m11;
  const float self_12_new_a = KSL_MULF(self->m10, correction_4),
      self_12_new_b = KSL_MULF(self->m11, correction_5),
      self_12_new_c = self_12_new_a + self_12_new_b,
      self_12_new_d = KSL_MULF(self->m12, correction_2),
      self_12_new_e = self_12_new_c + self_12_new_d, self_12_new = self_12_new_e + self->m12;
  const float self_20_new_a = KSL_MULF(self->m20, correction_0),
      self_20_new_b = KSL_MULF(self->m21, correction_3),
      self_20_new_c = self_20_new_a + self_20_new_b,
      self_20_new_d = KSL_MULF(self->m22, correction_4),
      self_20_new_e = self_20_new_c + self_20_new_d, self_20_new = self->m20 + self_20_new_e;
  const float self_21_new_a = KSL_MULF(self->m20, correction_3),
      self_21_new_b = KSL_MULF(self->m21, correction_1),
      self_21_new_c = self_21_new_a + self_21_new_b,
      self_21_new_d = KSL_MULF(self->m22, correction_5),
      self_21_new_e = self_21_new_c + self_21_new_d, self_21_new = self_21_new_e + self->m21;
  const float self_22_new_a = KSL_MULF(self->m20, correction_4),
      self_22_new_b = KSL_MULF(self->m21, correction_5),
      self_22_new_c = self_22_new_a + self_22_new_b,
      self_22_new_d = KSL_MULF(self->m22, correction_2),
      self_22_new_e = self_22_new_c + self_22_new_d, self_22_new = self_22_new_e + self->m22;
  const float defect_0a_abs = fabsf(defect_0a), defect_0b_size = 1.0f + defect_0a_abs,
      defect_0c_abs = fabsf(defect_0c), defect_0d_size = defect_0b_size + defect_0c_abs,
      defect_0e_abs = fabsf(defect_0e), defect_0_size = defect_0d_size + defect_0e_abs;
  const float defect_1a_abs = fabsf(defect_1a), defect_1b_size = 1.0f + defect_1a_abs,
      defect_1c_abs = fabsf(defect_1c), defect_1d_size = defect_1b_size + defect_1c_abs,
      defect_1e_abs = fabsf(defect_1e), defect_1_size = defect_1d_size + defect_1e_abs;
  const float defect_2a_abs = fabsf(defect_2a), defect_2b_size = 1.0f + defect_2a_abs,
      defect_2c_abs = fabsf(defect_2c), defect_2d_size = defect_2b_size + defect_2c_abs,
      defect_2e_abs = fabsf(defect_2e), defect_2_size = defect_2d_size + defect_2e_abs;
  const float defect_3a_abs = fabsf(defect_3a), defect_3b_abs = fabsf(defect_3b),
      defect_3c_size = defect_3a_abs + defect_3b_abs, defect_3d_abs = fabsf(defect_3d),
      defect_3e_size = defect_3c_size + defect_3d_abs;
  const float defect_4a_abs = fabsf(defect_4a), defect_4b_abs = fabsf(defect_4b),
      defect_4c_size = defect_4a_abs + defect_4b_abs, defect_4d_abs = fabsf(defect_4d),
      defect_4e_size = defect_4c_size + defect_4d_abs;
  const float defect_5a_abs = fabsf(defect_5a), defect_5b_abs = fabsf(defect_5b),
      defect_5c_size = defect_5a_abs + defect_5b_abs, defect_5d_abs = fabsf(defect_5d),
      defect_5e_size = defect_5c_size + defect_5d_abs;
  const float defect_0_padded = defect_0_size + 1.9721523e-31f;
  const float correction_0_size = KSL_MULF(0.5f, defect_0_padded);
  const float defect_1_padded = defect_1_size + 1.9721523e-31f;
  const float correction_1_size = KSL_MULF(0.5f, defect_1_padded);
  const float defect_2_padded = defect_2_size + 1.9721523e-31f;
  const float correction_2_size = KSL_MULF(0.5f, defect_2_padded);
  const float defect_3e_padded = defect_3e_size + 1.9721523e-31f;
  const float correction_3_size = KSL_MULF(0.5f, defect_3e_padded);
  const float defect_4e_padded = defect_4e_size + 1.9721523e-31f;
  const float correction_4_size = KSL_MULF(0.5f, defect_4e_padded);
  const float defect_5e_padded = defect_5e_size + 1.9721523e-31f;
  const float correction_5_size = KSL_MULF(0.5f, defect_5e_padded);
  const float correction_0_padded = correction_0_size + 1.9721523e-31f;
  const float self_00_abs = fabsf(self->m00),
      self_00_new_a_size = KSL_MULF(self_00_abs, correction_0_padded);
  const float correction_3_padded = correction_3_size + 1.9721523e-31f;
  const float self_01_abs = fabsf(self->m01),
      self_00_new_b_size = KSL_MULF(self_01_abs, correction_3_padded),
      self_00_new_c_size = self_00_new_a_size + self_00_new_b_size;
  const float correction_4_padded = correction_4_size + 1.9721523e-31f;
  const float self_02_abs = fabsf(self->m02),
      self_00_new_d_size = KSL_MULF(self_02_abs, correction_4_padded),
      self_00_new_e_size = self_00_new_c_size + self_00_new_d_size,
      self_00_new_size = self_00_abs + self_00_new_e_size;
  const float self_01_new_a_size = KSL_MULF(self_00_abs, correction_3_padded);
  const float correction_1_padded = correction_1_size + 1.9721523e-31f;
  const float self_01_new_b_size = KSL_MULF(self_01_abs, correction_1_padded),
      self_01_new_c_size = self_01_new_a_size + self_01_new_b_size;
  const float correction_5_padded = correction_5_size + 1.9721523e-31f;
  const float self_01_new_d_size = KSL_MULF(self_02_abs, correction_5_padded),
      self_01_new_e_size = self_01_new_c_size + self_01_new_d_size,
      self_01_new_size = self_01_new_e_size + self_01_abs;
  const float self_02_new_a_size = KSL_MULF(self_00_abs, correction_4_padded),
      self_02_new_b_size = KSL_MULF(self_01_abs, correction_5_padded),
      self_02_new_c_size = self_02_new_a_size + self_02_new_b_size;
  const float correction_2_padded = correction_2_size + 1.9721523e-31f;
  const float self_02_new_d_size = KSL_MULF(self_02_abs, correction_2_padded),
      self_02_new_e_size = self_02_new_c_size + self_02_new_d_size,
      self_02_new_size = self_02_new_e_size + self_02_abs;
  const float self_10_abs = fabsf(self->m10),
      self_10_new_a_size = KSL_MULF(self_10_abs, correction_0_padded),
      self_11_abs = fabsf(self->m11),
      self_10_new_b_size = KSL_MULF(self_11_abs, correction_3_padded),
      self_10_new_c_size = self_10_new_a_size + self_10_new_b_size, self_12_abs = fabsf(self->m12),
      self_10_new_d_size = KSL_MULF(self_12_abs, correction_4_padded),
      self_10_new_e_size = self_10_new_c_size + self_10_new_d_size,
      self_10_new_size = self_10_abs + self_10_new_e_size;
  const float self_11_new_a_size = KSL_MULF(self_10_abs, correction_3_padded),
      self_11_new_b_size = KSL_MULF(self_11_abs, correction_1_padded),
      self_11_new_c_size = self_11_new_a_size + self_11_new_b_size,
      self_11_new_d_size = KSL_MULF(self_12_abs, correction_5_padded),
      self_11_new_e_size = self_11_new_c_size + self_11_new_d_size,
      self_11_new_size = self_11_new_e_size + self_11_abs;
  const float self_12_new_a_size = KSL_MULF(self_10_abs, correction_4_padded),
      self_12_new_b_size = KSL_MULF(self_11_abs, correction_5_padded),
      self_12_new_c_size = self_12_new_a_size + self_12_new_b_size,
      self_12_new_d_size = KSL_MULF(self_12_abs, correction_2_padded),
      self_12_new_e_size = self_12_new_c_size + self_12_new_d_size,
      self_12_new_size = self_12_new_e_size + self_12_abs;
  const float self_20_abs = fabsf(self->m20),
      self_20_new_a_size = KSL_MULF(self_20_abs, correction_0_padded),
      self_21_abs = fabsf(self->m21),
      self_20_new_b_size = KSL_MULF(self_21_abs, correction_3_padded),
      self_20_new_c_size = self_20_new_a_size + self_20_new_b_size, self_22_abs = fabsf(self->m22),
      self_20_new_d_size = KSL_MULF(self_22_abs, correction_4_padded),
      self_20_new_e_size = self_20_new_c_size + self_20_new_d_size,
      self_20_new_size = self_20_abs + self_20_new_e_size;
  const float self_21_new_a_size = KSL_MULF(self_20_abs, correction_3_padded),
      self_21_new_b_size = KSL_MULF(self_21_abs, correction_1_padded),
      self_21_new_c_size = self_21_new_a_size + self_21_new_b_size,
      self_21_new_d_size = KSL_MULF(self_22_abs, correction_5_padded),
      self_21_new_e_size = self_21_new_c_size + self_21_new_d_size,
      self_21_new_size = self_21_new_e_size + self_21_abs;
  const float self_22_new_a_size = KSL_MULF(self_20_abs, correction_4_padded),
      self_22_new_b_size = KSL_MULF(self_21_abs, correction_5_padded),
      self_22_new_c_size = self_22_new_a_size + self_22_new_b_size,
      self_22_new_d_size = KSL_MULF(self_22_abs, correction_2_padded),
      self_22_new_e_size = self_22_new_c_size + self_22_new_d_size,
      self_22_new_size = self_22_new_e_size + self_22_abs;
  const float self_00_new_padded = self_00_new_size + 1.9721523e-31f,
      self_00_new_error_bound = KSL_MULF(5.36442e-07f, self_00_new_padded);
  const float self_01_new_padded = self_01_new_size + 1.9721523e-31f,
      self_01_new_error_bound = KSL_MULF(5.36442e-07f, self_01_new_padded);
  const float self_02_new_padded = self_02_new_size + 1.9721523e-31f,
      self_02_new_error_bound = KSL_MULF(4.7683733e-07f, self_02_new_padded);
  const float self_10_new_padded = self_10_new_size + 1.9721523e-31f,
      self_10_new_error_bound = KSL_MULF(5.36442e-07f, self_10_new_padded);
  const float self_11_new_padded = self_11_new_size + 1.9721523e-31f,
      self_11_new_error_bound = KSL_MULF(5.36442e-07f, self_11_new_padded);
  const float self_12_new_padded = self_12_new_size + 1.9721523e-31f,
      self_12_new_error_bound = KSL_MULF(4.7683733e-07f, self_12_new_padded);
  const float self_20_new_padded = self_20_new_size + 1.9721523e-31f,
      self_20_new_error_bound = KSL_MULF(5.36442e-07f, self_20_new_padded);
  const float self_21_new_padded = self_21_new_size + 1.9721523e-31f,
      self_21_new_error_bound = KSL_MULF(5.36442e-07f, self_21_new_padded);
  const float self_22_new_padded = self_22_new_size + 1.9721523e-31f,
      self_22_new_error_bound = KSL_MULF(4.7683733e-07f, self_22_new_padded);
  self->m00 = self_00_new;
  self->m01 = self_01_new;
  self->m02 = self_02_new;
  self->m10 = self_10_new;
  self->m11 = self_11_new;
  self->m12 = self_12_new;
  self->m20 = self_20_new;
  self->m21 = self_21_new;
  self->m22 = self_22_new;
  self_bound->m00 = self_00_new_error_bound;
  self_bound->m01 = self_01_new_error_bound;
  self_bound->m02 = self_02_new_error_bound;
  self_bound->m10 = self_10_new_error_bound;
  self_bound->m11 = self_11_new_error_bound;
  self_bound->m12 = self_12_new_error_bound;
  self_bound->m20 = self_20_new_error_bound;
  self_bound->m21 = self_21_new_error_bound;
  self_bound->m22 = self_22_new_error_bound;
}

/* Ro = R + R (I - R^T R)/2, closer to a rotation: a defect d of R becomes 3/4 d^2; |error of Ro|
     <= Ro_bound unless inf or NaN.
   R, Ro, Ro_bound: rotation or other 3×3 matrix.
   93 mul, 105 add, 3 neg, 27 abs. */
static inline void ksl_mat3x3f_orthonormalized_certified(const ksl_mat3x3f_t *R,
    ksl_mat3x3f_t *Ro, ksl_mat3x3f_t *Ro_bound) {
  const float defect_0a = KSL_MULF(R->m00, R->m00), defect_0b = 1.0f - defect_0a,
      defect_0c = KSL_MULF(R->m10, R->m10), defect_0d = defect_0b - defect_0c,
      defect_0e = KSL_MULF(R->m20, R->m20), defect_0 = defect_0d - defect_0e;
  const float defect_1a = KSL_MULF(R->m01, R->m01), defect_1b = 1.0f - defect_1a,
      defect_1c = KSL_MULF(R->m11, R->m11), defect_1d = defect_1b - defect_1c,
      defect_1e = KSL_MULF(R->m21, R->m21), defect_1 = defect_1d - defect_1e;
  const float defect_2a = KSL_MULF(R->m02, R->m02), defect_2b = 1.0f - defect_2a,
      defect_2c = KSL_MULF(R->m12, R->m12), defect_2d = defect_2b - defect_2c,
      defect_2e = KSL_MULF(R->m22, R->m22), defect_2 = defect_2d - defect_2e;
  const float defect_3a = KSL_MULF(R->m00, R->m01), defect_3b = KSL_MULF(R->m10, R->m11),
      defect_3c = defect_3a + defect_3b, defect_3d = KSL_MULF(R->m20, R->m21),
      defect_3e = defect_3c + defect_3d, defect_3 = -defect_3e;
  const float defect_4a = KSL_MULF(R->m00, R->m02), defect_4b = KSL_MULF(R->m10, R->m12),
      defect_4c = defect_4a + defect_4b, defect_4d = KSL_MULF(R->m20, R->m22),
      defect_4e = defect_4c + defect_4d, defect_4 = -defect_4e;
  const float defect_5a = KSL_MULF(R->m01, R->m02), defect_5b = KSL_MULF(R->m11, R->m12),
      defect_5c = defect_5a + defect_5b, defect_5d = KSL_MULF(R->m21, R->m22),
      defect_5e = defect_5c + defect_5d, defect_5 = -defect_5e;
  const float correction_0 = KSL_MULF(0.5f, defect_0);
  const float correction_1 = KSL_MULF(0.5f, defect_1);
  const float correction_2 = KSL_MULF(0.5f, defect_2);
  const float correction_3 = KSL_MULF(0.5f, defect_3);
  const float correction_4 = KSL_MULF(0.5f, defect_4);
  const float correction_5 = KSL_MULF(0.5f, defect_5);
  const float Ro_00a = KSL_MULF(R->m00, correction_0), Ro_00b = KSL_MULF(R->m01, correction_3),
      Ro_00c = Ro_00a + Ro_00b, Ro_00d = KSL_MULF(R->m02, correction_4), Ro_00e = Ro_00c + Ro_00d,
      Ro_00 = R->m00 + Ro_00e;
  const float Ro_01a = KSL_MULF(R->m00, correction_3), Ro_01b = KSL_MULF(R->m01, correction_1),
      Ro_01c = Ro_01a + Ro_01b, Ro_01d = KSL_MULF(R->m02, correction_5), Ro_01e = Ro_01c + Ro_01d,
      Ro_01 = Ro_01e + R->m01;
  const float Ro_02a = KSL_MULF(R->m00, correction_4), Ro_02b = KSL_MULF(R->m01, correction_5),
      Ro_02c = Ro_02a + Ro_02b, Ro_02d = KSL_MULF(R->m02, correction_2), Ro_02e = Ro_02c + Ro_02d,
      Ro_02 = Ro_02e + R->m02;
  const float Ro_10a = KSL_MULF(R->m10, correction_0), Ro_10b = KSL_MULF(R->m11, correction_3),
      Ro_10c = Ro_10a + Ro_10b, Ro_10d = KSL_MULF(R->m12, correction_4), Ro_10e = Ro_10c + Ro_10d,
      Ro_10 = R->m10 + Ro_10e;
  const float Ro_11a = KSL_MULF(R->m10, correction_3), Ro_11b = KSL_MULF(R->m11, correction_1),
      Ro_11c = Ro_11a + Ro_11b, Ro_11d = KSL_MULF(R->m12, correction_5), Ro_11e = Ro_11c + Ro_11d,
      Ro_11 = Ro_11e + R->m11;
  const float Ro_12a = KSL_MULF(R->m10, correction_4), Ro_12b = KSL_MULF(R->m11, correction_5),
      Ro_12c = Ro_12a + Ro_12b, Ro_12d = KSL_MULF(R->m12, correction_2), Ro_12e = Ro_12c + Ro_12d,
      Ro_12 = Ro_12e + R->m12;
  const float Ro_20a = KSL_MULF(R->m20, correction_0), Ro_20b = KSL_MULF(R->m21, correction_3),
      Ro_20c = Ro_20a + Ro_20b, Ro_20d = KSL_MULF(R->m22, correction_4), Ro_20e = Ro_20c + Ro_20d,
      Ro_20 = R->m20 + Ro_20e;
  const float Ro_21a = KSL_MULF(R->m20, correction_3), Ro_21b = KSL_MULF(R->m21, correction_1),
      Ro_21c = Ro_21a + Ro_21b, Ro_21d = KSL_MULF(R->m22, correction_5), Ro_21e = Ro_21c + Ro_21d,
      Ro_21 = Ro_21e + R->m21;
  const float Ro_22a = KSL_MULF(R->m20, correction_4), Ro_22b = KSL_MULF(R->m21, correction_5),
      Ro_22c = Ro_22a + Ro_22b, Ro_22d = KSL_MULF(R->m22, correction_2), Ro_22e = Ro_22c + Ro_22d,
      Ro_22 = Ro_22e + R->m22;
  const float defect_0a_abs = fabsf(defect_0a), defect_0b_size = 1.0f + defect_0a_abs,
      defect_0c_abs = fabsf(defect_0c), defect_0d_size = defect_0b_size + defect_0c_abs,
      defect_0e_abs = fabsf(defect_0e), defect_0_size = defect_0d_size + defect_0e_abs;
  const float defect_1a_abs = fabsf(defect_1a), defect_1b_size = 1.0f + defect_1a_abs,
      defect_1c_abs = fabsf(defect_1c), defect_1d_size = defect_1b_size + defect_1c_abs,
      defect_1e_abs = fabsf(defect_1e), defect_1_size = defect_1d_size + defect_1e_abs;
  const float defect_2a_abs = fabsf(defect_2a), defect_2b_size = 1.0f + defect_2a_abs,
      defect_2c_abs = fabsf(defect_2c), defect_2d_size = defect_2b_size + defect_2c_abs,
      defect_2e_abs = fabsf(defect_2e), defect_2_size = defect_2d_size + defect_2e_abs;
  const float defect_3a_abs = fabsf(defect_3a), defect_3b_abs = fabsf(defect_3b),
      defect_3c_size = defect_3a_abs + defect_3b_abs, defect_3d_abs = fabsf(defect_3d),
      defect_3e_size = defect_3c_size + defect_3d_abs;
  const float defect_4a_abs = fabsf(defect_4a), defect_4b_abs = fabsf(defect_4b),
      defect_4c_size = defect_4a_abs + defect_4b_abs, defect_4d_abs = fabsf(defect_4d),
      defect_4e_size = defect_4c_size + defect_4d_abs;
  const float defect_5a_abs = fabsf(defect_5a), defect_5b_abs = fabsf(defect_5b),
      defect_5c_size = defect_5a_abs + defect_5b_abs, defect_5d_abs = fabsf(defect_5d),
      defect_5e_size = defect_5c_size + defect_5d_abs;
  const float defect_0_padded = defect_0_size + 1.9721523e-31f;
  const float correction_0_size = KSL_MULF(0.5f, defect_0_padded);
  const float defect_1_padded = defect_1_size + 1.9721523e-31f;
  const float correction_1_size = KSL_MULF(0.5f, defect_1_padded);
  const float defect_2_padded = defect_2_size + 1.9721523e-31f;
  const float correction_2_size = KSL_MULF(0.5f, defect_2_padded);
  const float defect_3e_padded = defect_3e_size + 1.9721523e-31f;
  const float correction_3_size = KSL_MULF(0.5f, defect_3e_padded);
  const float defect_4e_padded = defect_4e_size + 1.9721523e-31f;
  const float correction_4_size = KSL_MULF(0.5f, defect_4e_padded);
  const float defect_5e_padded = defect_5e_size + 1.9721523e-31f;
  const float correction_5_size = KSL_MULF(0.5f, defect_5e_padded);
  const float correction_0_padded = correction_0_size + 1.9721523e-31f;
  const float R_00_abs = fabsf(R->m00), Ro_00a_size = KSL_MULF(R_00_abs, correction_0_padded);
  const float correction_3_padded = correction_3_size + 1.9721523e-31f;
  const float R_01_abs = fabsf(R->m01), Ro_00b_size = KSL_MULF(R_01_abs, correction_3_padded),
      Ro_00c_size = Ro_00a_size + Ro_00b_size;
  const float correction_4_padded = correction_4_size + 1.9721523e-31f;
  const float R_02_abs = fabsf(R->m02), Ro_00d_size = KSL_MULF(R_02_abs, correction_4_padded),
      Ro_00e_size = Ro_00c_size + Ro_00d_size, Ro_00_size = R_00_abs + Ro_00e_size;
  const float Ro_01a_size = KSL_MULF(R_00_abs, correction_3_padded);
  const float correction_1_padded = correction_1_size + 1.9721523e-31f;
  const float Ro_01b_size = KSL_MULF(R_01_abs, correction_1_padded),
      Ro_01c_size = Ro_01a_size + Ro_01b_size;
  const float correction_5_padded = correction_5_size + 1.9721523e-31f;
  const float Ro_01d_size = KSL_MULF(R_02_abs, correction_5_padded),
      Ro_01e_size = Ro_01c_size + Ro_01d_size, Ro_01_size = Ro_01e_size + R_01_abs;
  const float Ro_02a_size = KSL_MULF(R_00_abs, correction_4_padded),
      Ro_02b_size = KSL_MULF(R_01_abs, correction_5_padded),
      Ro_02c_size = Ro_02a_size + Ro_02b_size;
  const float correction_2_padded = correction_2_size + 1.9721523e-31f;
  const float Ro_02d_size = KSL_MULF(R_02_abs, correction_2_padded),
      Ro_02e_size = Ro_02c_size + Ro_02d_size, Ro_02_size = Ro_02e_size + R_02_abs;
  const float R_10_abs = fabsf(R->m10), Ro_10a_size = KSL_MULF(R_10_abs, correction_0_padded),
      R_11_abs = fabsf(R->m11), Ro_10b_size = KSL_MULF(R_11_abs, correction_3_padded),
      Ro_10c_size = Ro_10a_size + Ro_10b_size, R_12_abs = fabsf(R->m12),
      Ro_10d_size = KSL_MULF(R_12_abs, correction_4_padded),
      Ro_10e_size = Ro_10c_size + Ro_10d_size, Ro_10_size = R_10_abs + Ro_10e_size;
  const float Ro_11a_size = KSL_MULF(R_10_abs, correction_3_padded),
      Ro_11b_size = KSL_MULF(R_11_abs, correction_1_padded),
      Ro_11c_size = Ro_11a_size + Ro_11b_size,
      Ro_11d_size = KSL_MULF(R_12_abs, correction_5_padded),
      Ro_11e_size = Ro_11c_size + Ro_11d_size, Ro_11_size = Ro_11e_size + R_11_abs;
  const float Ro_12a_size = KSL_MULF(R_10_abs, correction_4_padded),
      Ro_12b_size = KSL_MULF(R_11_abs, correction_5_padded),
      Ro_12c_size = Ro_12a_size + Ro_12b_size,
      Ro_12d_size = KSL_MULF(R_12_abs, correction_2_padded),
      Ro_12e_size = Ro_12c_size + Ro_12d_size, Ro_12_size = Ro_12e_size + R_12_abs;
  const float R_20_abs = fabsf(R->m20), Ro_20a_size = KSL_MULF(R_20_abs, correction_0_padded),
      R_21_abs = fabsf(R->m21), Ro_20b_size = KSL_MULF(R_21_abs, correction_3_padded),
      Ro_20c_size = Ro_20a_size + Ro_20b_size, R_22_abs = fabsf(R->m22),
      Ro_20d_size = KSL_MULF(R_22_abs, correction_4_padded),
      Ro_20e_size = Ro_20c_size + Ro_20d_size, Ro_20_size = R_20_abs + Ro_20e_size;
  const float Ro_21a_size = KSL_MULF(R_20_abs, correction_3_padded),
      Ro_21b_size = KSL_MULF(R_21_abs, correction_1_padded),
      Ro_21c_size = Ro_21a_size + Ro_21b_size,
      Ro_21d_size = KSL_MULF(R_22_abs, correction_5_padded),
      Ro_21e_size = Ro_21c_size + Ro_21d_size, Ro_21_size = Ro_21e_size + R_21_abs;
  const float Ro_22a_size = KSL_MULF(R_20_abs, correction_4_padded),
      Ro_22b_size = KSL_MULF(R_21_abs, correction_5_padded),
      Ro_22c_size = Ro_22a_size + Ro_22b_size,
      Ro_22d_size = KSL_MULF(R_22_abs, correction_2_padded),
      Ro_22e_size = Ro_22c_size + Ro_22d_size, Ro_22_size = Ro_22e_size + R_22_abs;
  const float Ro_00_padded = Ro_00_size + 1.9721523e-31f,
      Ro_00_error_bound = KSL_MULF(5.36442e-07f, Ro_00_padded);
  const float Ro_01_padded = Ro_01_size + 1.9721523e-31f,
      Ro_01_error_bound = KSL_MULF(5.36442e-07f, Ro_01_padded);
  const float Ro_02_padded = Ro_02_size + 1.9721523e-31f,
      Ro_02_error_bound = KSL_MULF(4.7683733e-07f, Ro_02_padded);
  const float Ro_10_padded = Ro_10_size + 1.9721523e-31f,
      Ro_10_error_bound = KSL_MULF(5.36442e-07f, Ro_10_padded);
  const float Ro_11_padded = Ro_11_size + 1.9721523e-31f,
      Ro_11_error_bound = KSL_MULF(5.36442e-07f, Ro_11_padded);
  const float Ro_12_padded = Ro_12_size + 1.9721523e-31f,
      Ro_12_error_bound = KSL_MULF(4.7683733e-07f, Ro_12_padded);
  const float Ro_20_padded = Ro_20_size + 1.9721523e-31f,
      Ro_20_error_bound = KSL_MULF(5.36442e-07f, Ro_20_padded);
  const float Ro_21_padded = Ro_21_size + 1.9721523e-31f,
      Ro_21_error_bound = KSL_MULF(5.36442e-07f, Ro_21_padded);
  const float Ro_22_padded = Ro_22_size + 1.9721523e-31f,
      Ro_22_error_bound = KSL_MULF(4.7683733e-07f, Ro_22_padded);
  Ro->m00 = Ro_00;
  Ro->m01 = Ro_01;
  Ro->m02 = Ro_02;
  Ro->m10 = Ro_10;
  Ro->m11 = Ro_11;
  Ro->m12 = Ro_12;
  Ro->m20 = Ro_20;
  Ro->m21 = Ro_21;
  Ro->m22 = Ro_22;
  Ro_bound->m00 = Ro_00_error_bound;
  Ro_bound->m01 = Ro_01_error_bound;
  Ro_bound->m02 = Ro_02_error_bound;
  Ro_bound->m10 = Ro_10_error_bound;
  Ro_bound->m11 = Ro_11_error_bound;
  Ro_bound->m12 = Ro_12_error_bound;
  Ro_bound->m20 = Ro_20_error_bound;
  Ro_bound->m21 = Ro_21_error_bound;
  Ro_bound->m22 = Ro_22_error_bound;
}

#endif
