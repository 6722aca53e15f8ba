/* Made by `coscrew generate`; changes are overwritten. */
/* SPDX-License-Identifier: MIT */
/* coscrew 0.2.0.  Copyright (c) 2026 The coscrew authors. */
/* Displacements D = [R | t].
   Certified tier: plain results, and bounds on their errors that always hold. */
#ifndef KSL_SE3_CERTIFIED_H
#define KSL_SE3_CERTIFIED_H

#include "ksl_types.h"

/* self = self^-1 = [R^T | -R^T t]; |error of self| <= self_bound unless inf or NaN.
   self, self_bound: displacement [R | t], R rotation, t in m.
   12 mul, 15 add, 3 neg, 9 abs. */
static inline void ksl_SE3_invert_certified(ksl_SE3_t *self, ksl_SE3_t *self_bound) {
  const double self_03_new_a = KSL_MUL(self->m00, self->m03),
      self_03_new_b = KSL_MUL(self->m10, self->m13), self_03_new_d = KSL_MUL(self->m20, self->m23),
      self_03_new = -(self_03_new_a + self_03_new_b + self_03_new_d);
  const double self_13_new_a = KSL_MUL(self->m01, self->m03),
      self_13_new_b = KSL_MUL(self->m11, self->m13), self_13_new_d = KSL_MUL(self->m21, self->m23),
      self_13_new = -(self_13_new_a + self_13_new_b + self_13_new_d);
  const double self_23_new_a = KSL_MUL(self->m02, self->m03),
      self_23_new_b = KSL_MUL(self->m12, self->m13), self_23_new_d = KSL_MUL(self->m22, self->m23),
      self_23_new = -(self_23_new_a + self_23_new_b + self_23_new_d);
  const double self_03_new_e_bound = KSL_MUL(3.3306690738754706e-16, fabs(self_03_new_a)
          + fabs(self_03_new_b) + fabs(self_03_new_d) + 2.004168360008973e-292),
      self_13_new_e_bound = KSL_MUL(3.3306690738754706e-16, fabs(self_13_new_a)
          + fabs(self_13_new_b) + fabs(self_13_new_d) + 2.004168360008973e-292),
      self_23_new_e_bound = KSL_MUL(3.3306690738754706e-16, fabs(self_23_new_a)
          + fabs(self_23_new_b) + fabs(self_23_new_d) + 2.004168360008973e-292);
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
  self_bound->m00 = 0.0;
  self_bound->m01 = 0.0;
  self_bound->m02 = 0.0;
  self_bound->m03 = self_03_new_e_bound;
  self_bound->m10 = 0.0;
  self_bound->m11 = 0.0;
  self_bound->m12 = 0.0;
  self_bound->m13 = self_13_new_e_bound;
  self_bound->m20 = 0.0;
  self_bound->m21 = 0.0;
  self_bound->m22 = 0.0;
  self_bound->m23 = self_23_new_e_bound;
}

/* Do = D^-1 = [R^T | -R^T t]; |error of Do| <= Do_bound unless inf or NaN.
   D, Do, Do_bound: displacement [R | t], R rotation, t in m.
   12 mul, 15 add, 3 neg, 9 abs. */
static inline void ksl_SE3_inverted_certified(const ksl_SE3_t *D, ksl_SE3_t *Do,
    ksl_SE3_t *Do_bound) {
  const double Do_03a = KSL_MUL(D->m00, D->m03), Do_03b = KSL_MUL(D->m10, D->m13),
      Do_03d = KSL_MUL(D->m20, D->m23), Do_03 = -(Do_03a + Do_03b + Do_03d);
  const double Do_13a = KSL_MUL(D->m01, D->m03), Do_13b = KSL_MUL(D->m11, D->m13),
      Do_13d = KSL_MUL(D->m21, D->m23), Do_13 = -(Do_13a + Do_13b + Do_13d);
  const double Do_23a = KSL_MUL(D->m02, D->m03), Do_23b = KSL_MUL(D->m12, D->m13),
      Do_23d = KSL_MUL(D->m22, D->m23), Do_23 = -(Do_23a + Do_23b + Do_23d);
  const double Do_03e_bound = KSL_MUL(3.3306690738754706e-16, fabs(Do_03a) + fabs(Do_03b)
          + fabs(Do_03d) + 2.004168360008973e-292);
  const double Do_13e_bound = KSL_MUL(3.3306690738754706e-16, fabs(Do_13a) + fabs(Do_13b)
          + fabs(Do_13d) + 2.004168360008973e-292);
  const double Do_23e_bound = KSL_MUL(3.3306690738754706e-16, fabs(Do_23a) + fabs(Do_23b)
          + fabs(Do_23d) + 2.004168360008973e-292);
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
  Do_bound->m00 = 0.0;
  Do_bound->m01 = 0.0;
  Do_bound->m02 = 0.0;
  Do_bound->m03 = Do_03e_bound;
  Do_bound->m10 = 0.0;
  Do_bound->m11 = 0.0;
  Do_bound->m12 = 0.0;
  Do_bound->m13 = Do_13e_bound;
  Do_bound->m20 = 0.0;
  Do_bound->m21 = 0.0;
  Do_bound->m22 = 0.0;
  Do_bound->m23 = Do_23e_bound;
}

/* self = self^-1 = [R^T | -R^T t]; |error of self| <= self_bound unless inf or NaN.
   self, self_bound: displacement [R | t], R rotation, t in m.
   12 mul, 15 add, 3 neg, 9 abs. */
static inline void ksl_SE3f_invert_certified(ksl_SE3f_t *self, ksl_SE3f_t *self_bound) {
  const float self_03_new_a = KSL_MULF(self->m00, self->m03),
      self_03_new_b = KSL_MULF(self->m10, self->m13),
      self_03_new_d = KSL_MULF(self->m20, self->m23),
      self_03_new = -(self_03_new_a + self_03_new_b + self_03_new_d);
  const float self_13_new_a = KSL_MULF(self->m01, self->m03),
      self_13_new_b = KSL_MULF(self->m11, self->m13),
      self_13_new_d = KSL_MULF(self->m21, self->m23),
      self_13_new = -(self_13_new_a + self_13_new_b + self_13_new_d);
  const float self_23_new_a = KSL_MULF(self->m02, self->m03),
      self_23_new_b = KSL_MULF(self->m12, self->m13),
      self_23_new_d = KSL_MULF(self->m22, self->m23),
      self_23_new = -(self_23_new_a + self_23_new_b + self_23_new_d);
  const float self_03_new_e_bound = KSL_MULF(1.7881396e-07f, fabsf(self_03_new_a)
          + fabsf(self_03_new_b) + fabsf(self_03_new_d) + 1.9721523e-31f),
      self_13_new_e_bound = KSL_MULF(1.7881396e-07f, fabsf(self_13_new_a) + fabsf(self_13_new_b)
          + fabsf(self_13_new_d) + 1.9721523e-31f),
      self_23_new_e_bound = KSL_MULF(1.7881396e-07f, fabsf(self_23_new_a) + fabsf(self_23_new_b)
          + fabsf(self_23_new_d) + 1.9721523e-31f);
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
  self_bound->m00 = 0.0f;
  self_bound->m01 = 0.0f;
  self_bound->m02 = 0.0f;
  self_bound->m03 = self_03_new_e_bound;
  self_bound->m10 = 0.0f;
  self_bound->m11 = 0.0f;
  self_bound->m12 = 0.0f;
  self_bound->m13 = self_13_new_e_bound;
  self_bound->m20 = 0.0f;
  self_bound->m21 = 0.0f;
  self_bound->m22 = 0.0f;
  self_bound->m23 = self_23_new_e_bound;
}

/* Do = D^-1 = [R^T | -R^T t]; |error of Do| <= Do_bound unless inf or NaN.
   D, Do, Do_bound: displacement [R | t], R rotation, t in m.
   12 mul, 15 add, 3 neg, 9 abs. */
static inline void ksl_SE3f_inverted_certified(const ksl_SE3f_t *D, ksl_SE3f_t *Do,
    ksl_SE3f_t *Do_bound) {
  const float Do_03a = KSL_MULF(D->m00, D->m03), Do_03b = KSL_MULF(D->m10, D->m13),
      Do_03d = KSL_MULF(D->m20, D->m23), Do_03 = -(Do_03a + Do_03b + Do_03d);
  const float Do_13a = KSL_MULF(D->m01, D->m03), Do_13b = KSL_MULF(D->m11, D->m13),
      Do_13d = KSL_MULF(D->m21, D->m23), Do_13 = -(Do_13a + Do_13b + Do_13d);
  const float Do_23a = KSL_MULF(D->m02, D->m03), Do_23b = KSL_MULF(D->m12, D->m13),
      Do_23d = KSL_MULF(D->m22, D->m23), Do_23 = -(Do_23a + Do_23b + Do_23d);
  const float Do_03e_bound = KSL_MULF(1.7881396e-07f, fabsf(Do_03a) + fabsf(Do_03b) + fabsf(Do_03d)
          + 1.9721523e-31f);
  const float Do_13e_bound = KSL_MULF(1.7881396e-07f, fabsf(Do_13a) + fabsf(Do_13b) + fabsf(Do_13d)
          + 1.9721523e-31f);
  const float Do_23e_bound = KSL_MULF(1.7881396e-07f, fabsf(Do_23a) + fabsf(Do_23b) + fabsf(Do_23d)
          + 1.9721523e-31f);
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
  Do_bound->m00 = 0.0f;
  Do_bound->m01 = 0.0f;
  Do_bound->m02 = 0.0f;
  Do_bound->m03 = Do_03e_bound;
  Do_bound->m10 = 0.0f;
  Do_bound->m11 = 0.0f;
  Do_bound->m12 = 0.0f;
  Do_bound->m13 = Do_13e_bound;
  Do_bound->m20 = 0.0f;
  Do_bound->m21 = 0.0f;
  Do_bound->m22 = 0.0f;
  Do_bound->m23 = Do_23e_bound;
}

#endif
