/* Made by `coscrew generate`; changes are overwritten. */
/* SPDX-License-Identifier: MIT */
/* coscrew 0.2.0.  Copyright (c) 2026 The coscrew authors. */
/* Displacements D = [R | t].
   Accurate tier: double compensated, single computed in double. */
#ifndef KSL_SE3_ACCURATE_H
#define KSL_SE3_ACCURATE_H

#include "ksl_exact.h"

/* self = self^-1 = [R^T | -R^T t].
   self: displacement [R | t], R rotation, t in m.
   9 mul, 33 add, 9 product rest, 6 neg.
   Error <= u |result| + (R: 0, t: 11) u^2 S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_SE3_invert_accurate(ksl_SE3_t *self) {
  const double self_03_new_a = KSL_MUL(self->m00, self->m03),
      self_03_new_b = KSL_MUL(self->m10, self->m13), self_03_new_c = self_03_new_a + self_03_new_b,
      self_03_new_c_right = self_03_new_c - self_03_new_a,
      self_03_new_c_left_rest = ksl_product_rest(self->m00, self->m03, self_03_new_a, self_03_new_c
          - self_03_new_c_right), self_03_new_d = KSL_MUL(self->m20, self->m23),
      self_03_new_e = self_03_new_c + self_03_new_d,
      self_03_new_e_right = self_03_new_e - self_03_new_c,
      self_03_new_e_lo1 = self_03_new_c - (self_03_new_e - self_03_new_e_right)
          + ksl_product_rest(self->m20, self->m23, self_03_new_d, self_03_new_e_right),
      self_03_new = -self_03_new_e;
  const double self_13_new_a = KSL_MUL(self->m01, self->m03),
      self_13_new_b = KSL_MUL(self->m11, self->m13), self_13_new_c = self_13_new_a + self_13_new_b,
      self_13_new_c_right = self_13_new_c - self_13_new_a,
      self_13_new_c_left_rest = ksl_product_rest(self->m01, self->m03, self_13_new_a, self_13_new_c
          - self_13_new_c_right), self_13_new_d = KSL_MUL(self->m21, self->m23),
      self_13_new_e = self_13_new_c + self_13_new_d,
      self_13_new_e_right = self_13_new_e - self_13_new_c,
      self_13_new_e_lo1 = self_13_new_c - (self_13_new_e - self_13_new_e_right)
          + ksl_product_rest(self->m21, self->m23, self_13_new_d, self_13_new_e_right),
      self_13_new = -self_13_new_e;
  const double self_23_new_a = KSL_MUL(self->m02, self->m03),
      self_23_new_b = KSL_MUL(self->m12, self->m13), self_23_new_c = self_23_new_a + self_23_new_b,
      self_23_new_c_right = self_23_new_c - self_23_new_a,
      self_23_new_c_left_rest = ksl_product_rest(self->m02, self->m03, self_23_new_a, self_23_new_c
          - self_23_new_c_right), self_23_new_d = KSL_MUL(self->m22, self->m23),
      self_23_new_e = self_23_new_c + self_23_new_d,
      self_23_new_e_right = self_23_new_e - self_23_new_c,
      self_23_new_e_lo1 = self_23_new_c - (self_23_new_e - self_23_new_e_right)
          + ksl_product_rest(self->m22, self->m23, self_23_new_d, self_23_new_e_right),
      self_23_new = -self_23_new_e;
  const double self_03_new_lo =
          -(self_03_new_e_lo1
          + (self_03_new_c_left_rest
          + ksl_product_rest(self->m10, self->m13, self_03_new_b, self_03_new_c_right)));
  const double self_03_new_rounded = self_03_new + self_03_new_lo;
  const double self_13_new_lo =
          -(self_13_new_e_lo1
          + (self_13_new_c_left_rest
          + ksl_product_rest(self->m11, self->m13, self_13_new_b, self_13_new_c_right)));
  const double self_13_new_rounded = self_13_new + self_13_new_lo;
  const double self_23_new_lo =
          -(self_23_new_e_lo1
          + (self_23_new_c_left_rest
          + ksl_product_rest(self->m12, self->m13, self_23_new_b, self_23_new_c_right)));
  const double self_23_new_rounded = self_23_new + self_23_new_lo;
  const double self_m10 = self->m10;
  const double self_m20 = self->m20;
  const double self_m01 = self->m01;
  const double self_m21 = self->m21;
  const double self_m02 = self->m02;
  const double self_m12 = self->m12;
  self->m01 = self_m10;
  self->m02 = self_m20;
  self->m03 = self_03_new_rounded;
  self->m10 = self_m01;
  self->m12 = self_m21;
  self->m13 = self_13_new_rounded;
  self->m20 = self_m02;
  self->m21 = self_m12;
  self->m23 = self_23_new_rounded;
}

/* Do = D^-1 = [R^T | -R^T t].
   D, Do: displacement [R | t], R rotation, t in m.
   9 mul, 33 add, 9 product rest, 6 neg.
   Error <= u |result| + (R: 0, t: 11) u^2 S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_SE3_inverted_accurate(const ksl_SE3_t *D, ksl_SE3_t *Do) {
  const double Do_03a = KSL_MUL(D->m00, D->m03), Do_03b = KSL_MUL(D->m10, D->m13),
      Do_03c = Do_03a + Do_03b, Do_03c_right = Do_03c - Do_03a, Do_03d = KSL_MUL(D->m20, D->m23),
      Do_03e = Do_03c + Do_03d, Do_03e_right = Do_03e - Do_03c,
      Do_03c_lo = ksl_product_rest(D->m00, D->m03, Do_03a, Do_03c - Do_03c_right)
          + ksl_product_rest(D->m10, D->m13, Do_03b, Do_03c_right), Do_03 = -Do_03e;
  const double Do_13a = KSL_MUL(D->m01, D->m03), Do_13b = KSL_MUL(D->m11, D->m13),
      Do_13c = Do_13a + Do_13b, Do_13c_right = Do_13c - Do_13a, Do_13d = KSL_MUL(D->m21, D->m23),
      Do_13e = Do_13c + Do_13d, Do_13e_right = Do_13e - Do_13c,
      Do_13c_lo = ksl_product_rest(D->m01, D->m03, Do_13a, Do_13c - Do_13c_right)
          + ksl_product_rest(D->m11, D->m13, Do_13b, Do_13c_right), Do_13 = -Do_13e;
  const double Do_23a = KSL_MUL(D->m02, D->m03), Do_23b = KSL_MUL(D->m12, D->m13),
      Do_23c = Do_23a + Do_23b, Do_23c_right = Do_23c - Do_23a, Do_23d = KSL_MUL(D->m22, D->m23),
      Do_23e = Do_23c + Do_23d, Do_23e_right = Do_23e - Do_23c,
      Do_23c_lo = ksl_product_rest(D->m02, D->m03, Do_23a, Do_23c - Do_23c_right)
          + ksl_product_rest(D->m12, D->m13, Do_23b, Do_23c_right), Do_23 = -Do_23e;
  const double Do_03_rounded = Do_03 +
          -(Do_03c - (Do_03e - Do_03e_right)
          + ksl_product_rest(D->m20, D->m23, Do_03d, Do_03e_right) + Do_03c_lo),
      Do_13_rounded = Do_13 +
          -(Do_13c - (Do_13e - Do_13e_right)
          + ksl_product_rest(D->m21, D->m23, Do_13d, Do_13e_right) + Do_13c_lo),
      Do_23_rounded = Do_23 +
          -(Do_23c - (Do_23e - Do_23e_right)
          + ksl_product_rest(D->m22, D->m23, Do_23d, Do_23e_right) + Do_23c_lo);
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
  Do->m03 = Do_03_rounded;
  Do->m10 = D_m01;
  Do->m11 = D_m11;
  Do->m12 = D_m21;
  Do->m13 = Do_13_rounded;
  Do->m20 = D_m02;
  Do->m21 = D_m12;
  Do->m22 = D_m22;
  Do->m23 = Do_23_rounded;
}

/* self = self^-1 = [R^T | -R^T t].
   self: displacement [R | t], R rotation, t in m.
   9 mul, 6 add, 3 neg.
   Error <= u |result| + (R: 0, t: 3/32) u^2 S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_SE3f_invert_accurate(ksl_SE3f_t *self) {
  const double self_03_new_c = ksl_product_sum(-(double)self->m10, (double)self->m13,
          -((double)self->m00 * (double)self->m03)),
      self_03_new = ksl_product_sum(-(double)self->m20, (double)self->m23, self_03_new_c);
  const double self_13_new_c = ksl_product_sum(-(double)self->m11, (double)self->m13,
          -((double)self->m01 * (double)self->m03)),
      self_13_new = ksl_product_sum(-(double)self->m21, (double)self->m23, self_13_new_c);
  const double self_23_new_c = ksl_product_sum(-(double)self->m12, (double)self->m13,
          -((double)self->m02 * (double)self->m03)),
      self_23_new = ksl_product_sum(-(double)self->m22, (double)self->m23, self_23_new_c);
  const float self_m10 = self->m10;
  const float self_m20 = self->m20;
  const float self_m01 = self->m01;
  const float self_m21 = self->m21;
  const float self_m02 = self->m02;
  const float self_m12 = self->m12;
  self->m01 = self_m10;
  self->m02 = self_m20;
  self->m03 = (float)self_03_new;
  self->m10 = self_m01;
  self->m12 = self_m21;
  self->m13 = (float)self_13_new;
  self->m20 = self_m02;
  self->m21 = self_m12;
  self->m23 = (float)self_23_new;
}

/* Do = D^-1 = [R^T | -R^T t].
   D, Do: displacement [R | t], R rotation, t in m.
   9 mul, 6 add, 3 neg.
   Error <= u |result| + (R: 0, t: 3/32) u^2 S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_SE3f_inverted_accurate(const ksl_SE3f_t *D, ksl_SE3f_t *Do) {
  const double Do_03 = ksl_product_sum(-(double)D->m20, (double)D->m23,
      ksl_product_sum(-(double)D->m10, (double)D->m13, -((double)D->m00 * (double)D->m03))),
      Do_13 = ksl_product_sum(-(double)D->m21, (double)D->m23, ksl_product_sum(-(double)D->m11,
          (double)D->m13, -((double)D->m01 * (double)D->m03))),
      Do_23 = ksl_product_sum(-(double)D->m22, (double)D->m23, ksl_product_sum(-(double)D->m12,
          (double)D->m13, -((double)D->m02 * (double)D->m03)));
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
  Do->m03 = (float)Do_03;
  Do->m10 = D_m01;
  Do->m11 = D_m11;
  Do->m12 = D_m21;
  Do->m13 = (float)Do_13;
  Do->m20 = D_m02;
  Do->m21 = D_m12;
  Do->m22 = D_m22;
  Do->m23 = (float)Do_23;
}

#endif
