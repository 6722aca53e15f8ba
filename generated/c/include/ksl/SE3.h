/* Made by `coscrew generate`; changes are overwritten. */
/* SPDX-License-Identifier: MIT */
/* coscrew 0.2.0.  Copyright (c) 2026 The coscrew authors. */
/* Displacements D = [R | t]. */
#ifndef KSL_SE3_H
#define KSL_SE3_H

#include "ksl_types.h"
#include "mat3x3.h"

/* The SE3 of these entries, row by row. */
static inline ksl_SE3_t ksl_SE3(const double m00, const double m01, const double m02,
    const double m03, const double m10, const double m11, const double m12,
    const double m13, const double m20, const double m21, const double m22,
    const double m23) {
  ksl_SE3_t value;
  value.m00 = m00;
  value.m01 = m01;
  value.m02 = m02;
  value.m03 = m03;
  value.m10 = m10;
  value.m11 = m11;
  value.m12 = m12;
  value.m13 = m13;
  value.m20 = m20;
  value.m21 = m21;
  value.m22 = m22;
  value.m23 = m23;
  return value;
}

/* The SE3 of these entries, column by column. */
static inline ksl_SE3_t ksl_SE3_cmo(const double m00, const double m10, const double m20,
    const double m01, const double m11, const double m21, const double m02,
    const double m12, const double m22, const double m03, const double m13,
    const double m23) {
  ksl_SE3_t value;
  value.m00 = m00;
  value.m10 = m10;
  value.m20 = m20;
  value.m01 = m01;
  value.m11 = m11;
  value.m21 = m21;
  value.m02 = m02;
  value.m12 = m12;
  value.m22 = m22;
  value.m03 = m03;
  value.m13 = m13;
  value.m23 = m23;
  return value;
}

/* The displacement [I | 0]. */
static inline ksl_SE3_t ksl_SE3_identity(void) {
  return ksl_SE3(1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0);
}

/* The entry of D at (row, column), for 0 <= row < 3 and 0 <= column < 4; NaN outside. */
static inline double ksl_SE3_get(const ksl_SE3_t *D, const int row, const int column) {
  return row >= 0 && row < 3 && column >= 0 && column < 4 ? D->at[column][row] : (double)NAN;
}

/* Sets the entry of D at (row, column), for 0 <= row < 3 and 0 <= column < 4; does nothing
     outside. */
static inline void ksl_SE3_set(ksl_SE3_t *D, const int row, const int column,
    const double value) {
  if (row >= 0 && row < 3 && column >= 0 && column < 4) {
    D->at[column][row] = value;
  }
}

/* D = [R | t].
   R: rotation or other 3×3 matrix; t: vector.
   No arithmetic.
   Exact. */
static inline ksl_SE3_t ksl_SE3_fromRt(const ksl_mat3x3_t R, const ksl_vec3_t t) {
  ksl_SE3_t D;
  D.m00 = R.m00;
  D.m01 = R.m01;
  D.m02 = R.m02;
  D.m03 = t.x;
  D.m10 = R.m10;
  D.m11 = R.m11;
  D.m12 = R.m12;
  D.m13 = t.y;
  D.m20 = R.m20;
  D.m21 = R.m21;
  D.m22 = R.m22;
  D.m23 = t.z;
  return D;
}

/* Do = D.
   D, Do: displacement [R | t], R rotation, t in m.
   No arithmetic.
   Exact. */
static inline void ksl_SE3_copy(const ksl_SE3_t *D, ksl_SE3_t *Do) {
  const double D_m00 = D->m00;
  const double D_m01 = D->m01;
  const double D_m02 = D->m02;
  const double D_m03 = D->m03;
  const double D_m10 = D->m10;
  const double D_m11 = D->m11;
  const double D_m12 = D->m12;
  const double D_m13 = D->m13;
  const double D_m20 = D->m20;
  const double D_m21 = D->m21;
  const double D_m22 = D->m22;
  const double D_m23 = D->m23;
  Do->m00 = D_m00;
  Do->m01 = D_m01;
  Do->m02 = D_m02;
  Do->m03 = D_m03;
  Do->m10 = D_m10;
  Do->m11 = D_m11;
  Do->m12 = D_m12;
  Do->m13 = D_m13;
  Do->m20 = D_m20;
  Do->m21 = D_m21;
  Do->m22 = D_m22;
  Do->m23 = D_m23;
}

/* self = [I | 0].
   self: displacement [R | t], R rotation, t in m.
   No arithmetic.
   Exact. */
static inline void ksl_SE3_setIdentity(ksl_SE3_t *self) {
  self->m00 = 1.0;
  self->m01 = 0.0;
  self->m02 = 0.0;
  self->m03 = 0.0;
  self->m10 = 0.0;
  self->m11 = 1.0;
  self->m12 = 0.0;
  self->m13 = 0.0;
  self->m20 = 0.0;
  self->m21 = 0.0;
  self->m22 = 1.0;
  self->m23 = 0.0;
}

/* t of D = [R | t].
   D: displacement [R | t], R rotation, t in m; t: vector.
   No arithmetic.
   Exact. */
static inline void ksl_SE3_getTranslation(const ksl_SE3_t *D, ksl_vec3_t *t) {
  const double D_m03 = D->m03;
  const double D_m13 = D->m13;
  const double D_m23 = D->m23;
  t->x = D_m03;
  t->y = D_m13;
  t->z = D_m23;
}

/* R of D = [R | t].
   D: displacement [R | t], R rotation, t in m; R: rotation or other 3×3 matrix.
   No arithmetic.
   Exact. */
static inline void ksl_SE3_getRotation(const ksl_SE3_t *D, ksl_mat3x3_t *R) {
  const double D_m00 = D->m00;
  const double D_m01 = D->m01;
  const double D_m02 = D->m02;
  const double D_m10 = D->m10;
  const double D_m11 = D->m11;
  const double D_m12 = D->m12;
  const double D_m20 = D->m20;
  const double D_m21 = D->m21;
  const double D_m22 = D->m22;
  R->m00 = D_m00;
  R->m01 = D_m01;
  R->m02 = D_m02;
  R->m10 = D_m10;
  R->m11 = D_m11;
  R->m12 = D_m12;
  R->m20 = D_m20;
  R->m21 = D_m21;
  R->m22 = D_m22;
}

/* self = self^-1 = [R^T | -R^T t].
   self: displacement [R | t], R rotation, t in m.
   9 mul, 6 add, 3 neg.
   Error <= u |result| + (R: 0, t: 2) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_SE3_invert(ksl_SE3_t *self) {
  const double self_03_new =
          -(KSL_MUL(self->m00, self->m03) + KSL_MUL(self->m10, self->m13)
          + KSL_MUL(self->m20, self->m23)),
      self_13_new =
          -(KSL_MUL(self->m01, self->m03) + KSL_MUL(self->m11, self->m13)
          + KSL_MUL(self->m21, self->m23)),
      self_23_new =
          -(KSL_MUL(self->m02, self->m03) + KSL_MUL(self->m12, self->m13)
          + KSL_MUL(self->m22, self->m23));
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

/* M = [[R, t], [0, 1]] of D = [R | t].
   D: displacement [R | t], R rotation, t in m; M: 4×4 matrix.
   No arithmetic.
   Exact. */
static inline void ksl_SE3_toMat4x4(const ksl_SE3_t *D, ksl_mat4x4_t *M) {
  const double D_m00 = D->m00;
  const double D_m01 = D->m01;
  const double D_m02 = D->m02;
  const double D_m03 = D->m03;
  const double D_m10 = D->m10;
  const double D_m11 = D->m11;
  const double D_m12 = D->m12;
  const double D_m13 = D->m13;
  const double D_m20 = D->m20;
  const double D_m21 = D->m21;
  const double D_m22 = D->m22;
  const double D_m23 = D->m23;
  M->m00 = D_m00;
  M->m01 = D_m01;
  M->m02 = D_m02;
  M->m03 = D_m03;
  M->m10 = D_m10;
  M->m11 = D_m11;
  M->m12 = D_m12;
  M->m13 = D_m13;
  M->m20 = D_m20;
  M->m21 = D_m21;
  M->m22 = D_m22;
  M->m23 = D_m23;
  M->m30 = 0.0;
  M->m31 = 0.0;
  M->m32 = 0.0;
  M->m33 = 1.0;
}

/* Do = D^-1 = [R^T | -R^T t].
   D, Do: displacement [R | t], R rotation, t in m.
   9 mul, 6 add, 3 neg.
   Error <= u |result| + (R: 0, t: 2) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_SE3_inverted(const ksl_SE3_t *D, ksl_SE3_t *Do) {
  const double Do_03 =
          -(KSL_MUL(D->m00, D->m03) + KSL_MUL(D->m10, D->m13) + KSL_MUL(D->m20, D->m23)),
      Do_13 = -(KSL_MUL(D->m01, D->m03) + KSL_MUL(D->m11, D->m13) + KSL_MUL(D->m21, D->m23)),
      Do_23 = -(KSL_MUL(D->m02, D->m03) + KSL_MUL(D->m12, D->m13) + KSL_MUL(D->m22, D->m23));
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

/* The SE3 of these entries, row by row. */
static inline ksl_SE3f_t ksl_SE3f(const float m00, const float m01, const float m02,
    const float m03, const float m10, const float m11, const float m12,
    const float m13, const float m20, const float m21, const float m22,
    const float m23) {
  ksl_SE3f_t value;
  value.m00 = m00;
  value.m01 = m01;
  value.m02 = m02;
  value.m03 = m03;
  value.m10 = m10;
  value.m11 = m11;
  value.m12 = m12;
  value.m13 = m13;
  value.m20 = m20;
  value.m21 = m21;
  value.m22 = m22;
  value.m23 = m23;
  return value;
}

/* The SE3 of these entries, column by column. */
static inline ksl_SE3f_t ksl_SE3f_cmo(const float m00, const float m10, const float m20,
    const float m01, const float m11, const float m21, const float m02,
    const float m12, const float m22, const float m03, const float m13,
    const float m23) {
  ksl_SE3f_t value;
  value.m00 = m00;
  value.m10 = m10;
  value.m20 = m20;
  value.m01 = m01;
  value.m11 = m11;
  value.m21 = m21;
  value.m02 = m02;
  value.m12 = m12;
  value.m22 = m22;
  value.m03 = m03;
  value.m13 = m13;
  value.m23 = m23;
  return value;
}

/* The displacement [I | 0]. */
static inline ksl_SE3f_t ksl_SE3f_identity(void) {
  return ksl_SE3f(1.0f, 0.0f, 0.0f, 0.0f, 0.0f, 1.0f, 0.0f, 0.0f, 0.0f, 0.0f, 1.0f, 0.0f);
}

/* The entry of D at (row, column), for 0 <= row < 3 and 0 <= column < 4; NaN outside. */
static inline float ksl_SE3f_get(const ksl_SE3f_t *D, const int row, const int column) {
  return row >= 0 && row < 3 && column >= 0 && column < 4 ? D->at[column][row] : (float)NAN;
}

/* Sets the entry of D at (row, column), for 0 <= row < 3 and 0 <= column < 4; does nothing
     outside. */
static inline void ksl_SE3f_set(ksl_SE3f_t *D, const int row, const int column,
    const float value) {
  if (row >= 0 && row < 3 && column >= 0 && column < 4) {
    D->at[column][row] = value;
  }
}

/* D = [R | t].
   R: rotation or other 3×3 matrix; t: vector.
   No arithmetic.
   Exact. */
static inline ksl_SE3f_t ksl_SE3f_fromRt(const ksl_mat3x3f_t R, const ksl_vec3f_t t) {
  ksl_SE3f_t D;
  D.m00 = R.m00;
  D.m01 = R.m01;
  D.m02 = R.m02;
  D.m03 = t.x;
  D.m10 = R.m10;
  D.m11 = R.m11;
  D.m12 = R.m12;
  D.m13 = t.y;
  D.m20 = R.m20;
  D.m21 = R.m21;
  D.m22 = R.m22;
  D.m23 = t.z;
  return D;
}

/* Do = D.
   D, Do: displacement [R | t], R rotation, t in m.
   No arithmetic.
   Exact. */
static inline void ksl_SE3f_copy(const ksl_SE3f_t *D, ksl_SE3f_t *Do) {
  const float D_m00 = D->m00;
  const float D_m01 = D->m01;
  const float D_m02 = D->m02;
  const float D_m03 = D->m03;
  const float D_m10 = D->m10;
  const float D_m11 = D->m11;
  const float D_m12 = D->m12;
  const float D_m13 = D->m13;
  const float D_m20 = D->m20;
  const float D_m21 = D->m21;
  const float D_m22 = D->m22;
  const float D_m23 = D->m23;
  Do->m00 = D_m00;
  Do->m01 = D_m01;
  Do->m02 = D_m02;
  Do->m03 = D_m03;
  Do->m10 = D_m10;
  Do->m11 = D_m11;
  Do->m12 = D_m12;
  Do->m13 = D_m13;
  Do->m20 = D_m20;
  Do->m21 = D_m21;
  Do->m22 = D_m22;
  Do->m23 = D_m23;
}

/* self = [I | 0].
   self: displacement [R | t], R rotation, t in m.
   No arithmetic.
   Exact. */
static inline void ksl_SE3f_setIdentity(ksl_SE3f_t *self) {
  self->m00 = 1.0f;
  self->m01 = 0.0f;
  self->m02 = 0.0f;
  self->m03 = 0.0f;
  self->m10 = 0.0f;
  self->m11 = 1.0f;
  self->m12 = 0.0f;
  self->m13 = 0.0f;
  self->m20 = 0.0f;
  self->m21 = 0.0f;
  self->m22 = 1.0f;
  self->m23 = 0.0f;
}

/* t of D = [R | t].
   D: displacement [R | t], R rotation, t in m; t: vector.
   No arithmetic.
   Exact. */
static inline void ksl_SE3f_getTranslation(const ksl_SE3f_t *D, ksl_vec3f_t *t) {
  const float D_m03 = D->m03;
  const float D_m13 = D->m13;
  const float D_m23 = D->m23;
  t->x = D_m03;
  t->y = D_m13;
  t->z = D_m23;
}

/* R of D = [R | t].
   D: displacement [R | t], R rotation, t in m; R: rotation or other 3×3 matrix.
   No arithmetic.
   Exact. */
static inline void ksl_SE3f_getRotation(const ksl_SE3f_t *D, ksl_mat3x3f_t *R) {
  const float D_m00 = D->m00;
  const float D_m01 = D->m01;
  const float D_m02 = D->m02;
  const float D_m10 = D->m10;
  const float D_m11 = D->m11;
  const float D_m12 = D->m12;
  const float D_m20 = D->m20;
  const float D_m21 = D->m21;
  const float D_m22 = D->m22;
  R->m00 = D_m00;
  R->m01 = D_m01;
  R->m02 = D_m02;
  R->m10 = D_m10;
  R->m11 = D_m11;
  R->m12 = D_m12;
  R->m20 = D_m20;
  R->m21 = D_m21;
  R->m22 = D_m22;
}

/* self = self^-1 = [R^T | -R^T t].
   self: displacement [R | t], R rotation, t in m.
   9 mul, 6 add, 3 neg.
   Error <= u |result| + (R: 0, t: 2) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_SE3f_invert(ksl_SE3f_t *self) {
  const float self_03_new =
          -(KSL_MULF(self->m00, self->m03) + KSL_MULF(self->m10, self->m13)
          + KSL_MULF(self->m20, self->m23)),
      self_13_new =
          -(KSL_MULF(self->m01, self->m03) + KSL_MULF(self->m11, self->m13)
          + KSL_MULF(self->m21, self->m23)),
      self_23_new =
          -(KSL_MULF(self->m02, self->m03) + KSL_MULF(self->m12, self->m13)
          + KSL_MULF(self->m22, self->m23));
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

/* M = [[R, t], [0, 1]] of D = [R | t].
   D: displacement [R | t], R rotation, t in m; M: 4×4 matrix.
   No arithmetic.
   Exact. */
static inline void ksl_SE3f_toMat4x4f(const ksl_SE3f_t *D, ksl_mat4x4f_t *M) {
  const float D_m00 = D->m00;
  const float D_m01 = D->m01;
  const float D_m02 = D->m02;
  const float D_m03 = D->m03;
  const float D_m10 = D->m10;
  const float D_m11 = D->m11;
  const float D_m12 = D->m12;
  const float D_m13 = D->m13;
  const float D_m20 = D->m20;
  const float D_m21 = D->m21;
  const float D_m22 = D->m22;
  const float D_m23 = D->m23;
  M->m00 = D_m00;
  M->m01 = D_m01;
  M->m02 = D_m02;
  M->m03 = D_m03;
  M->m10 = D_m10;
  M->m11 = D_m11;
  M->m12 = D_m12;
  M->m13 = D_m13;
  M->m20 = D_m20;
  M->m21 = D_m21;
  M->m22 = D_m22;
  M->m23 = D_m23;
  M->m30 = 0.0f;
  M->m31 = 0.0f;
  M->m32 = 0.0f;
  M->m33 = 1.0f;
}

/* Do = D^-1 = [R^T | -R^T t].
   D, Do: displacement [R | t], R rotation, t in m.
   9 mul, 6 add, 3 neg.
   Error <= u |result| + (R: 0, t: 2) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_SE3f_inverted(const ksl_SE3f_t *D, ksl_SE3f_t *Do) {
  const float Do_03 =
          -(KSL_MULF(D->m00, D->m03) + KSL_MULF(D->m10, D->m13) + KSL_MULF(D->m20, D->m23)),
      Do_13 = -(KSL_MULF(D->m01, D->m03) + KSL_MULF(D->m11, D->m13) + KSL_MULF(D->m21, D->m23)),
      Do_23 = -(KSL_MULF(D->m02, D->m03) + KSL_MULF(D->m12, D->m13) + KSL_MULF(D->m22, D->m23));
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

#ifndef KSL_NO_ALLOC
#include <stdlib.h>

/* n ksl_SE3_t on the heap, identities, to be freed by the caller; NULL for n <= 0 or when there
     is no memory. */
static inline ksl_SE3_t *ksl_SE3_alloc(int n) {
  ksl_SE3_t *const all =
      n > 0 ? (ksl_SE3_t *)calloc((size_t)n, sizeof(ksl_SE3_t)) : NULL;
  for (int i = 0; all && i < n; i++) {
    all[i].m00 = all[i].m11 = all[i].m22 = 1.0;
  }
  return all;
}

/* n ksl_SE3f_t on the heap, identities, to be freed by the caller; NULL for n <= 0 or when there
     is no memory. */
static inline ksl_SE3f_t *ksl_SE3f_alloc(int n) {
  ksl_SE3f_t *const all =
      n > 0 ? (ksl_SE3f_t *)calloc((size_t)n, sizeof(ksl_SE3f_t)) : NULL;
  for (int i = 0; all && i < n; i++) {
    all[i].m00 = all[i].m11 = all[i].m22 = 1.0f;
  }
  return all;
}

#endif

/* What KSL declares beside formulas. */

/* m = [[R, t], [0, 1]] of d = [R | t], each number rounded to single precision. */
static inline void ksl_SE3_toMat4x4f(const ksl_SE3_t *d, ksl_mat4x4f_t *m) {
  for (int column = 0; column < 4; column++) {
    for (int row = 0; row < 3; row++) {
      m->at[column][row] = (float)d->at[column][row];
    }
    m->at[column][3] = column == 3 ? 1.0f : 0.0f;
  }
}

#endif
