/* Made by `coscrew generate`; changes are overwritten. */
/* SPDX-License-Identifier: MIT */
/* coscrew 0.2.0.  Copyright (c) 2026 The coscrew authors. */
/* Exponentials and logarithms of rotations and displacements, their Jacobians, interpolation.
   Fused tier: products fused into sums. */
#ifndef KSL_EXPONENTIAL_FUSED_H
#define KSL_EXPONENTIAL_FUSED_H

#include "ksl_types.h"

/* self = R + R (I - R^T R)/2, closer to a rotation: a defect d of R becomes 3/4 d^2.
   self: rotation or other 3×3 matrix.
   18 mul, 9 add, 33 fma, 3 neg.
   Error <= u |result| + 6 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_mat3x3_orthonormalize_fused(ksl_mat3x3_t *self) {
  const double defect_0b = fma(-self->m00, self->m00, 1.0),
      defect_0d = fma(-self->m10, self->m10, defect_0b),
      defect_0 = fma(-self->m20, self->m20, defect_0d);
  const double defect_1b = fma(-self->m01, self->m01, 1.0),
      defect_1d = fma(-self->m11, self->m11, defect_1b),
      defect_1 = fma(-self->m21, self->m21, defect_1d);
  const double defect_2b = fma(-self->m02, self->m02, 1.0),
      defect_2d = fma(-self->m12, self->m12, defect_2b),
      defect_2 = fma(-self->m22, self->m22, defect_2d);
  const double defect_3a = KSL_MUL(self->m00, self->m01), defect_3c_lead = -defect_3a,
      defect_3c = fma(-self->m10, self->m11, defect_3c_lead),
      defect_3 = fma(-self->m20, self->m21, defect_3c);
  const double defect_4a = KSL_MUL(self->m00, self->m02), defect_4c_lead = -defect_4a,
      defect_4c = fma(-self->m10, self->m12, defect_4c_lead),
      defect_4 = fma(-self->m20, self->m22, defect_4c);
  const double defect_5a = KSL_MUL(self->m01, self->m02), defect_5c_lead = -defect_5a,
      defect_5c = fma(-self->m11, self->m12, defect_5c_lead),
      defect_5 = fma(-self->m21, self->m22, defect_5c);
  const double correction_0 = KSL_MUL(0.5, defect_0);
  const double correction_1 = KSL_MUL(0.5, defect_1);
  const double correction_2 = KSL_MUL(0.5, defect_2);
  const double correction_3 = KSL_MUL(0.5, defect_3);
  const double correction_4 = KSL_MUL(0.5, defect_4);
  const double correction_5 = KSL_MUL(0.5, defect_5);
  const double self_00_new_a = KSL_MUL(self->m00, correction_0),
      self_00_new_c = fma(self->m01, correction_3, self_00_new_a),
      self_00_new_e = fma(self->m02, correction_4, self_00_new_c),
      self_00_new = self->m00 + self_00_new_e;
  const double self_01_new_a = KSL_MUL(self->m00, correction_3),
      self_01_new_c = fma(self->m01, correction_1, self_01_new_a),
      self_01_new_e = fma(self->m02, correction_5, self_01_new_c),
      self_01_new = self_01_new_e + self->m01;
  const double self_02_new_a = KSL_MUL(self->m00, correction_4),
      self_02_new_c = fma(self->m01, correction_5, self_02_new_a),
      self_02_new_e = fma(self->m02, correction_2, self_02_new_c),
      self_02_new = self_02_new_e + self->m02;
  const double self_10_new_a = KSL_MUL(self->m10, correction_0),
      self_10_new_c = fma(self->m11, correction_3, self_10_new_a),
      self_10_new_e = fma(self->m12, correction_4, self_10_new_c),
      self_10_new = self->m10 + self_10_new_e;
  const double self_11_new_a = KSL_MUL(self->m10, correction_3),
      self_11_new_c = fma(self->m11, correction_1, self_11_new_a),
      self_11_new_e = fma(self->m12, correction_5, self_11_new_c),
      self_11_new = self_11_new_e + self->m11;
  const double self_12_new_a = KSL_MUL(self->m10, correction_4),
      self_12_new_c = fma(self->m11, correction_5, self_12_new_a),
      self_12_new_e = fma(self->m12, correction_2, self_12_new_c),
      self_12_new = self_12_new_e + self->m12;
  const double self_20_new_a = KSL_MUL(self->m20, correction_0),
      self_20_new_c = fma(self->m21, correction_3, self_20_new_a),
      self_20_new_e = fma(self->m22, correction_4, self_20_new_c),
      self_20_new = self->m20 + self_20_new_e;
  const double self_21_new_a = KSL_MUL(self->m20, correction_3),
      self_21_new_c = fma(self->m21, correction_1, self_21_new_a),
      self_21_new_e = fma(self->m22, correction_5, self_21_new_c),
      self_21_new = self_21_new_e + self->m21;
  const double self_22_new_a = KSL_MUL(self->m20, correction_4),
      self_22_new_c = fma(self->m21, correction_5, self_22_new_a),
      self_22_new_e = fma(self->m22, correction_2, self_22_new_c),
      self_22_new = self_22_new_e + self->m22;
  self->m00 = self_00_new;
  self->m01 = self_01_new;
  self->m02 = self_02_new;
  self->m10 = self_10_new;
  self->m11 = self_11_new;
  self->m12 = self_12_new;
  self->m20 = self_20_new;
  self->m21 = self_21_new;
  self->m22 = self_22_new;
}

/* Ro = R + R (I - R^T R)/2, closer to a rotation: a defect d of R becomes 3/4 d^2.
   R, Ro: rotation or other 3×3 matrix.
   18 mul, 9 add, 33 fma, 3 neg.
   Error <= u |result| + 6 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_mat3x3_orthonormalized_fused(const ksl_mat3x3_t *R, ksl_mat3x3_t *Ro) {
  const double defect_0b = fma(-R->m00, R->m00, 1.0), defect_0d = fma(-R->m10, R->m10, defect_0b),
      defect_0 = fma(-R->m20, R->m20, defect_0d);
  const double defect_1b = fma(-R->m01, R->m01, 1.0), defect_1d = fma(-R->m11, R->m11, defect_1b),
      defect_1 = fma(-R->m21, R->m21, defect_1d);
  const double defect_2b = fma(-R->m02, R->m02, 1.0), defect_2d = fma(-R->m12, R->m12, defect_2b),
      defect_2 = fma(-R->m22, R->m22, defect_2d);
  const double defect_3a = KSL_MUL(R->m00, R->m01), defect_3c_lead = -defect_3a,
      defect_3c = fma(-R->m10, R->m11, defect_3c_lead), defect_3 = fma(-R->m20, R->m21, defect_3c);
  const double defect_4a = KSL_MUL(R->m00, R->m02), defect_4c_lead = -defect_4a,
      defect_4c = fma(-R->m10, R->m12, defect_4c_lead), defect_4 = fma(-R->m20, R->m22, defect_4c);
  const double defect_5a = KSL_MUL(R->m01, R->m02), defect_5c_lead = -defect_5a,
      defect_5c = fma(-R->m11, R->m12, defect_5c_lead), defect_5 = fma(-R->m21, R->m22, defect_5c);
  const double correction_0 = KSL_MUL(0.5, defect_0);
  const double correction_1 = KSL_MUL(0.5, defect_1);
  const double correction_2 = KSL_MUL(0.5, defect_2);
  const double correction_3 = KSL_MUL(0.5, defect_3);
  const double correction_4 = KSL_MUL(0.5, defect_4);
  const double correction_5 = KSL_MUL(0.5, defect_5);
  const double Ro_00a = KSL_MUL(R->m00, correction_0), Ro_00c = fma(R->m01, correction_3, Ro_00a),
      Ro_00e = fma(R->m02, correction_4, Ro_00c), Ro_00 = R->m00 + Ro_00e;
  const double Ro_01a = KSL_MUL(R->m00, correction_3), Ro_01c = fma(R->m01, correction_1, Ro_01a),
      Ro_01e = fma(R->m02, correction_5, Ro_01c), Ro_01 = Ro_01e + R->m01;
  const double Ro_02a = KSL_MUL(R->m00, correction_4), Ro_02c = fma(R->m01, correction_5, Ro_02a),
      Ro_02e = fma(R->m02, correction_2, Ro_02c), Ro_02 = Ro_02e + R->m02;
  const double Ro_10a = KSL_MUL(R->m10, correction_0), Ro_10c = fma(R->m11, correction_3, Ro_10a),
      Ro_10e = fma(R->m12, correction_4, Ro_10c), Ro_10 = R->m10 + Ro_10e;
  const double Ro_11a = KSL_MUL(R->m10, correction_3), Ro_11c = fma(R->m11, correction_1, Ro_11a),
      Ro_11e = fma(R->m12, correction_5, Ro_11c), Ro_11 = Ro_11e + R->m11;
  const double Ro_12a = KSL_MUL(R->m10, correction_4), Ro_12c = fma(R->m11, correction_5, Ro_12a),
      Ro_12e = fma(R->m12, correction_2, Ro_12c), Ro_12 = Ro_12e + R->m12;
  const double Ro_20a = KSL_MUL(R->m20, correction_0), Ro_20c = fma(R->m21, correction_3, Ro_20a),
      Ro_20e = fma(R->m22, correction_4, Ro_20c), Ro_20 = R->m20 + Ro_20e;
  const double Ro_21a = KSL_MUL(R->m20, correction_3), Ro_21c = fma(R->m21, correction_1, Ro_21a),
      Ro_21e = fma(R->m22, correction_5, Ro_21c), Ro_21 = Ro_21e + R->m21;
  const double Ro_22a = KSL_MUL(R->m20, correction_4), Ro_22c = fma(R->m21, correction_5, Ro_22a),
      Ro_22e = fma(R->m22, correction_2, Ro_22c), Ro_22 = Ro_22e + R->m22;
  Ro->m00 = Ro_00;
  Ro->m01 = Ro_01;
  Ro->m02 = Ro_02;
  Ro->m10 = Ro_10;
  Ro->m11 = Ro_11;
  Ro->m12 = Ro_12;
  Ro->m20 = Ro_20;
  Ro->m21 = Ro_21;
  Ro->m22 = Ro_22;
}

/* self = R + R (I - R^T R)/2, closer to a rotation: a defect d of R becomes 3/4 d^2.
   self: rotation or other 3×3 matrix.
   18 mul, 9 add, 33 fma, 3 neg.
   Error <= u |result| + 6 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_mat3x3f_orthonormalize_fused(ksl_mat3x3f_t *self) {
  const float defect_0b = fmaf(-self->m00, self->m00, 1.0f),
      defect_0d = fmaf(-self->m10, self->m10, defect_0b),
      defect_0 = fmaf(-self->m20, self->m20, defect_0d);
  const float defect_1b = fmaf(-self->m01, self->m01, 1.0f),
      defect_1d = fmaf(-self->m11, self->m11, defect_1b),
      defect_1 = fmaf(-self->m21, self->m21, defect_1d);
  const float defect_2b = fmaf(-self->m02, self->m02, 1.0f),
      defect_2d = fmaf(-self->m12, self->m12, defect_2b),
      defect_2 = fmaf(-self->m22, self->m22, defect_2d);
  const float defect_3a = KSL_MULF(self->m00, self->m01), defect_3c_lead = -defect_3a,
      defect_3c = fmaf(-self->m10, self->m11, defect_3c_lead),
      defect_3 = fmaf(-self->m20, self->m21, defect_3c);
  const float defect_4a = KSL_MULF(self->m00, self->m02), defect_4c_lead = -defect_4a,
      defect_4c = fmaf(-self->m10, self->m12, defect_4c_lead),
      defect_4 = fmaf(-self->m20, self->m22, defect_4c);
  const float defect_5a = KSL_MULF(self->m01, self->m02), defect_5c_lead = -defect_5a,
      defect_5c = fmaf(-self->m11, self->m12, defect_5c_lead),
      defect_5 = fmaf(-self->m21, self->m22, defect_5c);
  const float correction_0 = KSL_MULF(0.5f, defect_0);
  const float correction_1 = KSL_MULF(0.5f, defect_1);
  const float correction_2 = KSL_MULF(0.5f, defect_2);
  const float correction_3 = KSL_MULF(0.5f, defect_3);
  const float correction_4 = KSL_MULF(0.5f, defect_4);
  const float correction_5 = KSL_MULF(0.5f, defect_5);
  const float self_00_new_a = KSL_MULF(self->m00, correction_0),
      self_00_new_c = fmaf(self->m01, correction_3, self_00_new_a),
      self_00_new_e = fmaf(self->m02, correction_4, self_00_new_c),
      self_00_new = self->m00 + self_00_new_e;
  const float self_01_new_a = KSL_MULF(self->m00, correction_3),
      self_01_new_c = fmaf(self->m01, correction_1, self_01_new_a),
      self_01_new_e = fmaf(self->m02, correction_5, self_01_new_c),
      self_01_new = self_01_new_e + self->m01;
  const float self_02_new_a = KSL_MULF(self->m00, correction_4),
      self_02_new_c = fmaf(self->m01, correction_5, self_02_new_a),
      self_02_new_e = fmaf(self->m02, correction_2, self_02_new_c),
      self_02_new = self_02_new_e + self->m02;
  const float self_10_new_a = KSL_MULF(self->m10, correction_0),
      self_10_new_c = fmaf(self->m11, correction_3, self_10_new_a),
      self_10_new_e = fmaf(self->m12, correction_4, self_10_new_c),
      self_10_new = self->m10 + self_10_new_e;
  const float self_11_new_a = KSL_MULF(self->m10, correction_3),
      self_11_new_c = fmaf(self->m11, correction_1, self_11_new_a),
      self_11_new_e = fmaf(self->m12, correction_5, self_11_new_c),
      self_11_new = self_11_new_e + self->m11;
  const float self_12_new_a = KSL_MULF(self->m10, correction_4),
      self_12_new_c = fmaf(self->m11, correction_5, self_12_new_a),
      self_12_new_e = fmaf(self->m12, correction_2, self_12_new_c),
      self_12_new = self_12_new_e + self->m12;
  const float self_20_new_a = KSL_MULF(self->m20, correction_0),
      self_20_new_c = fmaf(self->m21, correction_3, self_20_new_a),
      self_20_new_e = fmaf(self->m22, correction_4, self_20_new_c),
      self_20_new = self->m20 + self_20_new_e;
  const float self_21_new_a = KSL_MULF(self->m20, correction_3),
      self_21_new_c = fmaf(self->m21, correction_1, self_21_new_a),
      self_21_new_e = fmaf(self->m22, correction_5, self_21_new_c),
      self_21_new = self_21_new_e + self->m21;
  const float self_22_new_a = KSL_MULF(self->m20, correction_4),
      self_22_new_c = fmaf(self->m21, correction_5, self_22_new_a),
      self_22_new_e = fmaf(self->m22, correction_2, self_22_new_c),
      self_22_new = self_22_new_e + self->m22;
  self->m00 = self_00_new;
  self->m01 = self_01_new;
  self->m02 = self_02_new;
  self->m10 = self_10_new;
  self->m11 = self_11_new;
  self->m12 = self_12_new;
  self->m20 = self_20_new;
  self->m21 = self_21_new;
  self->m22 = self_22_new;
}

/* Ro = R + R (I - R^T R)/2, closer to a rotation: a defect d of R becomes 3/4 d^2.
   R, Ro: rotation or other 3×3 matrix.
   18 mul, 9 add, 33 fma, 3 neg.
   Error <= u |result| + 6 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_mat3x3f_orthonormalized_fused(const ksl_mat3x3f_t *R, ksl_mat3x3f_t *Ro) {
  const float defect_0b = fmaf(-R->m00, R->m00, 1.0f), defect_0d = fmaf(-R->m10, R->m10, defect_0b),
      defect_0 = fmaf(-R->m20, R->m20, defect_0d);
  const float defect_1b = fmaf(-R->m01, R->m01, 1.0f), defect_1d = fmaf(-R->m11, R->m11, defect_1b),
      defect_1 = fmaf(-R->m21, R->m21, defect_1d);
  const float defect_2b = fmaf(-R->m02, R->m02, 1.0f), defect_2d = fmaf(-R->m12, R->m12, defect_2b),
      defect_2 = fmaf(-R->m22, R->m22, defect_2d);
  const float defect_3a = KSL_MULF(R->m00, R->m01), defect_3c_lead = -defect_3a,
      defect_3c = fmaf(-R->m10, R->m11, defect_3c_lead),
      defect_3 = fmaf(-R->m20, R->m21, defect_3c);
  const float defect_4a = KSL_MULF(R->m00, R->m02), defect_4c_lead = -defect_4a,
      defect_4c = fmaf(-R->m10, R->m12, defect_4c_lead),
      defect_4 = fmaf(-R->m20, R->m22, defect_4c);
  const float defect_5a = KSL_MULF(R->m01, R->m02), defect_5c_lead = -defect_5a,
      defect_5c = fmaf(-R->m11, R->m12, defect_5c_lead),
      defect_5 = fmaf(-R->m21, R->m22, defect_5c);
  const float correction_0 = KSL_MULF(0.5f, defect_0);
  const float correction_1 = KSL_MULF(0.5f, defect_1);
  const float correction_2 = KSL_MULF(0.5f, defect_2);
  const float correction_3 = KSL_MULF(0.5f, defect_3);
  const float correction_4 = KSL_MULF(0.5f, defect_4);
  const float correction_5 = KSL_MULF(0.5f, defect_5);
  const float Ro_00a = KSL_MULF(R->m00, correction_0), Ro_00c = fmaf(R->m01, correction_3, Ro_00a),
      Ro_00e = fmaf(R->m02, correction_4, Ro_00c), Ro_00 = R->m00 + Ro_00e;
  const float Ro_01a = KSL_MULF(R->m00, correction_3), Ro_01c = fmaf(R->m01, correction_1, Ro_01a),
      Ro_01e = fmaf(R->m02, correction_5, Ro_01c), Ro_01 = Ro_01e + R->m01;
  const float Ro_02a = KSL_MULF(R->m00, correction_4), Ro_02c = fmaf(R->m01, correction_5, Ro_02a),
      Ro_02e = fmaf(R->m02, correction_2, Ro_02c), Ro_02 = Ro_02e + R->m02;
  const float Ro_10a = KSL_MULF(R->m10, correction_0), Ro_10c = fmaf(R->m11, correction_3, Ro_10a),
      Ro_10e = fmaf(R->m12, correction_4, Ro_10c), Ro_10 = R->m10 + Ro_10e;
  const float Ro_11a = KSL_MULF(R->m10, correction_3), Ro_11c = fmaf(R->m11, correction_1, Ro_11a),
      Ro_11e = fmaf(R->m12, correction_5, Ro_11c), Ro_11 = Ro_11e + R->m11;
  const float Ro_12a = KSL_MULF(R->m10, correction_4), Ro_12c = fmaf(R->m11, correction_5, Ro_12a),
      Ro_12e = fmaf(R->m12, correction_2, Ro_12c), Ro_12 = Ro_12e + R->m12;
  const float Ro_20a = KSL_MULF(R->m20, correction_0), Ro_20c = fmaf(R->m21, correction_3, Ro_20a),
      Ro_20e = fmaf(R->m22, correction_4, Ro_20c), Ro_20 = R->m20 + Ro_20e;
  const float Ro_21a = KSL_MULF(R->m20, correction_3), Ro_21c = fmaf(R->m21, correction_1, Ro_21a),
      Ro_21e = fmaf(R->m22, correction_5, Ro_21c), Ro_21 = Ro_21e + R->m21;
  const float Ro_22a = KSL_MULF(R->m20, correction_4), Ro_22c = fmaf(R->m21, correction_5, Ro_22a),
      Ro_22e = fmaf(R->m22, correction_2, Ro_22c), Ro_22 = Ro_22e + R->m22;
  Ro->m00 = Ro_00;
  Ro->m01 = Ro_01;
  Ro->m02 = Ro_02;
  Ro->m10 = Ro_10;
  Ro->m11 = Ro_11;
  Ro->m12 = Ro_12;
  Ro->m20 = Ro_20;
  Ro->m21 = Ro_21;
  Ro->m22 = Ro_22;
}

#endif
