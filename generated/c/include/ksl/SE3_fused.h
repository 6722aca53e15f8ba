/* Made by `coscrew generate`; changes are overwritten. */
/* SPDX-License-Identifier: MIT */
/* coscrew 0.2.0.  Copyright (c) 2026 The coscrew authors. */
/* Displacements D = [R | t].
   Fused tier: products fused into sums. */
#ifndef KSL_SE3_FUSED_H
#define KSL_SE3_FUSED_H

#include "ksl_types.h"

/* self = self^-1 = [R^T | -R^T t].
   self: displacement [R | t], R rotation, t in m.
   3 mul, 6 fma, 3 neg.
   Error <= u |result| + (R: 0, t: 2) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_SE3_invert_fused(ksl_SE3_t *self) {
  const double self_03_new_a = KSL_MUL(self->m00, self->m03), self_03_new_c_lead = -self_03_new_a,
      self_03_new_c = fma(-self->m10, self->m13, self_03_new_c_lead),
      self_03_new = fma(-self->m20, self->m23, self_03_new_c);
  const double self_13_new_a = KSL_MUL(self->m01, self->m03), self_13_new_c_lead = -self_13_new_a,
      self_13_new_c = fma(-self->m11, self->m13, self_13_new_c_lead),
      self_13_new = fma(-self->m21, self->m23, self_13_new_c);
  const double self_23_new_a = KSL_MUL(self->m02, self->m03), self_23_new_c_lead = -self_23_new_a,
      self_23_new_c = fma(-self->m12, self->m13, self_23_new_c_lead),
      self_23_new = fma(-self->m22, self->m23, self_23_new_c);
  const double self_m10 = self->m10;
  const double self_m20 = self->m20;
  const double self_m01 = self->m01;
  const double self_m21 = self->m21;
  const double self_m02 = self->m02;
  const double self_m12 = self->m12;
  self->m01 = self_m10;
  self->m02 = self_m20;
  self->m03 = self_03_new;
  self->m10 = self_m01;
  self->m12 = self_m21;
  self->m13 = self_13_new;
  self->m20 = self_m02;
  self->m21 = self_m12;
  self->m23 = self_23_new;
}

/* Do = D^-1 = [R^T | -R^T t].
   D, Do: displacement [R | t], R rotation, t in m.
   3 mul, 6 fma, 3 neg.
   Error <= u |result| + (R: 0, t: 2) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_SE3_inverted_fused(const ksl_SE3_t *D, ksl_SE3_t *Do) {
  const double Do_03a = KSL_MUL(D->m00, D->m03), Do_03c_lead = -Do_03a,
      Do_03c = fma(-D->m10, D->m13, Do_03c_lead), Do_03 = fma(-D->m20, D->m23, Do_03c);
  const double Do_13a = KSL_MUL(D->m01, D->m03), Do_13c_lead = -Do_13a,
      Do_13c = fma(-D->m11, D->m13, Do_13c_lead), Do_13 = fma(-D->m21, D->m23, Do_13c);
  const double Do_23a = KSL_MUL(D->m02, D->m03), Do_23c_lead = -Do_23a,
      Do_23c = fma(-D->m12, D->m13, Do_23c_lead), Do_23 = fma(-D->m22, D->m23, Do_23c);
  const double D_m00 = D->m00;
  const double D_m10 = D->m10;
  const double D_m20 = D->m20;
  const double D_m01 = D->m01;
  const double D_m11 = D->m11;
  const double D_m21 = D->m21;
  const double D_m02 = D->m02;
  const double D_m12 = D->m12;
  const double D_m22 = D->m22;
  Do->m00 = D_m00;
  Do->m01 = D_m10;
  Do->m02 = D_m20;
  Do->m03 = Do_03;
  Do->m10 = D_m01;
  Do->m11 = D_m11;
  Do->m12 = D_m21;
  Do->m13 = Do_13;
  Do->m20 = D_m02;
  Do->m21 = D_m12;
  Do->m22 = D_m22;
  Do->m23 = Do_23;
}

/* self = self^-1 = [R^T | -R^T t].
   self: displacement [R | t], R rotation, t in m.
   3 mul, 6 fma, 3 neg.
   Error <= u |result| + (R: 0, t: 2) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_SE3f_invert_fused(ksl_SE3f_t *self) {
  const float self_03_new_a = KSL_MULF(self->m00, self->m03), self_03_new_c_lead = -self_03_new_a,
      self_03_new_c = fmaf(-self->m10, self->m13, self_03_new_c_lead),
      self_03_new = fmaf(-self->m20, self->m23, self_03_new_c);
  const float self_13_new_a = KSL_MULF(self->m01, self->m03), self_13_new_c_lead = -self_13_new_a,
      self_13_new_c = fmaf(-self->m11, self->m13, self_13_new_c_lead),
      self_13_new = fmaf(-self->m21, self->m23, self_13_new_c);
  const float self_23_new_a = KSL_MULF(self->m02, self->m03), self_23_new_c_lead = -self_23_new_a,
      self_23_new_c = fmaf(-self->m12, self->m13, self_23_new_c_lead),
      self_23_new = fmaf(-self->m22, self->m23, self_23_new_c);
  const float self_m10 = self->m10;
  const float self_m20 = self->m20;
  const float self_m01 = self->m01;
  const float self_m21 = self->m21;
  const float self_m02 = self->m02;
  const float self_m12 = self->m12;
  self->m01 = self_m10;
  self->m02 = self_m20;
  self->m03 = self_03_new;
  self->m10 = self_m01;
  self->m12 = self_m21;
  self->m13 = self_13_new;
  self->m20 = self_m02;
  self->m21 = self_m12;
  self->m23 = self_23_new;
}

/* Do = D^-1 = [R^T | -R^T t].
   D, Do: displacement [R | t], R rotation, t in m.
   3 mul, 6 fma, 3 neg.
   Error <= u |result| + (R: 0, t: 2) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_SE3f_inverted_fused(const ksl_SE3f_t *D, ksl_SE3f_t *Do) {
  const float Do_03a = KSL_MULF(D->m00, D->m03), Do_03c_lead = -Do_03a,
      Do_03c = fmaf(-D->m10, D->m13, Do_03c_lead), Do_03 = fmaf(-D->m20, D->m23, Do_03c);
  const float Do_13a = KSL_MULF(D->m01, D->m03), Do_13c_lead = -Do_13a,
      Do_13c = fmaf(-D->m11, D->m13, Do_13c_lead), Do_13 = fmaf(-D->m21, D->m23, Do_13c);
  const float Do_23a = KSL_MULF(D->m02, D->m03), Do_23c_lead = -Do_23a,
      Do_23c = fmaf(-D->m12, D->m13, Do_23c_lead), Do_23 = fmaf(-D->m22, D->m23, Do_23c);
  const float D_m00 = D->m00;
  const float D_m10 = D->m10;
  const float D_m20 = D->m20;
  const float D_m01 = D->m01;
  const float D_m11 = D->m11;
  const float D_m21 = D->m21;
  const float D_m02 = D->m02;
  const float D_m12 = D->m12;
  const float D_m22 = D->m22;
  Do->m00 = D_m00;
  Do->m01 = D_m10;
  Do->m02 = D_m20;
  Do->m03 = Do_03;
  Do->m10 = D_m01;
  Do->m11 = D_m11;
  Do->m12 = D_m21;
  Do->m13 = Do_13;
  Do->m20 = D_m02;
  Do->m21 = D_m12;
  Do->m22 = D_m22;
  Do->m23 = Do_23;
}

#endif
