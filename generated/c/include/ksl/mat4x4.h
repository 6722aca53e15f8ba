/* Made by `coscrew generate`; changes are overwritten. */
/* SPDX-License-Identifier: MIT */
/* coscrew 0.2.0.  Copyright (c) 2026 The coscrew authors. */
/* 4×4 matrices: displacements [[R, t], [0, 1]] and other maps of homogeneous coordinates. */
#ifndef KSL_MAT4X4_H
#define KSL_MAT4X4_H

#include "ksl_types.h"
#include "SE3.h"
#include "vec4.h"

/* The mat4x4 of these entries, row by row. */
static inline ksl_mat4x4_t ksl_mat4x4(const double m00, const double m01, const double m02,
    const double m03, const double m10, const double m11, const double m12,
    const double m13, const double m20, const double m21, const double m22,
    const double m23, const double m30, const double m31, const double m32,
    const double m33) {
  ksl_mat4x4_t value;
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
  value.m30 = m30;
  value.m31 = m31;
  value.m32 = m32;
  value.m33 = m33;
  return value;
}

/* The mat4x4 of these entries, column by column. */
static inline ksl_mat4x4_t ksl_mat4x4_cmo(const double m00, const double m10, const double m20,
    const double m30, const double m01, const double m11, const double m21,
    const double m31, const double m02, const double m12, const double m22,
    const double m32, const double m03, const double m13, const double m23,
    const double m33) {
  ksl_mat4x4_t value;
  value.m00 = m00;
  value.m10 = m10;
  value.m20 = m20;
  value.m30 = m30;
  value.m01 = m01;
  value.m11 = m11;
  value.m21 = m21;
  value.m31 = m31;
  value.m02 = m02;
  value.m12 = m12;
  value.m22 = m22;
  value.m32 = m32;
  value.m03 = m03;
  value.m13 = m13;
  value.m23 = m23;
  value.m33 = m33;
  return value;
}

/* The entry of M at (row, column), for 0 <= row < 4 and 0 <= column < 4; NaN outside. */
static inline double ksl_mat4x4_get(const ksl_mat4x4_t *M, const int row, const int column) {
  return row >= 0 && row < 4 && column >= 0 && column < 4 ? M->at[column][row] : (double)NAN;
}

/* Sets the entry of M at (row, column), for 0 <= row < 4 and 0 <= column < 4; does nothing
     outside. */
static inline void ksl_mat4x4_set(ksl_mat4x4_t *M, const int row, const int column,
    const double value) {
  if (row >= 0 && row < 4 && column >= 0 && column < 4) {
    M->at[column][row] = value;
  }
}

/* M = [[R, t], [0, 1]] of D = [R | t].
   D: displacement [R | t], R rotation, t in m.
   No arithmetic.
   Exact. */
static inline ksl_mat4x4_t ksl_mat4x4_fromSE3(const ksl_SE3_t D) {
  ksl_mat4x4_t M;
  M.m00 = D.m00;
  M.m01 = D.m01;
  M.m02 = D.m02;
  M.m03 = D.m03;
  M.m10 = D.m10;
  M.m11 = D.m11;
  M.m12 = D.m12;
  M.m13 = D.m13;
  M.m20 = D.m20;
  M.m21 = D.m21;
  M.m22 = D.m22;
  M.m23 = D.m23;
  M.m30 = 0.0;
  M.m31 = 0.0;
  M.m32 = 0.0;
  M.m33 = 1.0;
  return M;
}

/* M = [[R, t], [0, 1]].
   R: rotation or other 3×3 matrix; t: vector.
   No arithmetic.
   Exact. */
static inline ksl_mat4x4_t ksl_mat4x4_fromRt(const ksl_mat3x3_t R, const ksl_vec3_t t) {
  ksl_mat4x4_t M;
  M.m00 = R.m00;
  M.m01 = R.m01;
  M.m02 = R.m02;
  M.m03 = t.x;
  M.m10 = R.m10;
  M.m11 = R.m11;
  M.m12 = R.m12;
  M.m13 = t.y;
  M.m20 = R.m20;
  M.m21 = R.m21;
  M.m22 = R.m22;
  M.m23 = t.z;
  M.m30 = 0.0;
  M.m31 = 0.0;
  M.m32 = 0.0;
  M.m33 = 1.0;
  return M;
}

/* D = [R | t], the first three rows of M.
   M: 4×4 matrix; D: displacement [R | t], R rotation, t in m.
   No arithmetic.
   Exact. */
static inline void ksl_mat4x4_toSE3(const ksl_mat4x4_t *M, ksl_SE3_t *D) {
  const double M_m00 = M->m00;
  const double M_m01 = M->m01;
  const double M_m02 = M->m02;
  const double M_m03 = M->m03;
  const double M_m10 = M->m10;
  const double M_m11 = M->m11;
  const double M_m12 = M->m12;
  const double M_m13 = M->m13;
  const double M_m20 = M->m20;
  const double M_m21 = M->m21;
  const double M_m22 = M->m22;
  const double M_m23 = M->m23;
  D->m00 = M_m00;
  D->m01 = M_m01;
  D->m02 = M_m02;
  D->m03 = M_m03;
  D->m10 = M_m10;
  D->m11 = M_m11;
  D->m12 = M_m12;
  D->m13 = M_m13;
  D->m20 = M_m20;
  D->m21 = M_m21;
  D->m22 = M_m22;
  D->m23 = M_m23;
}

/* self = I.
   self: 4×4 matrix.
   No arithmetic.
   Exact. */
static inline void ksl_mat4x4_setIdentity(ksl_mat4x4_t *self) {
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
  self->m30 = 0.0;
  self->m31 = 0.0;
  self->m32 = 0.0;
  self->m33 = 1.0;
}

/* t, the first three entries of the last column of M.
   M: 4×4 matrix; t: vector.
   No arithmetic.
   Exact. */
static inline void ksl_mat4x4_getTranslation(const ksl_mat4x4_t *M, ksl_vec3_t *t) {
  const double M_m03 = M->m03;
  const double M_m13 = M->m13;
  const double M_m23 = M->m23;
  t->x = M_m03;
  t->y = M_m13;
  t->z = M_m23;
}

/* The mat4x4 of these entries, row by row. */
static inline ksl_mat4x4f_t ksl_mat4x4f(const float m00, const float m01, const float m02,
    const float m03, const float m10, const float m11, const float m12,
    const float m13, const float m20, const float m21, const float m22,
    const float m23, const float m30, const float m31, const float m32,
    const float m33) {
  ksl_mat4x4f_t value;
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
  value.m30 = m30;
  value.m31 = m31;
  value.m32 = m32;
  value.m33 = m33;
  return value;
}

/* The mat4x4 of these entries, column by column. */
static inline ksl_mat4x4f_t ksl_mat4x4f_cmo(const float m00, const float m10, const float m20,
    const float m30, const float m01, const float m11, const float m21,
    const float m31, const float m02, const float m12, const float m22,
    const float m32, const float m03, const float m13, const float m23,
    const float m33) {
  ksl_mat4x4f_t value;
  value.m00 = m00;
  value.m10 = m10;
  value.m20 = m20;
  value.m30 = m30;
  value.m01 = m01;
  value.m11 = m11;
  value.m21 = m21;
  value.m31 = m31;
  value.m02 = m02;
  value.m12 = m12;
  value.m22 = m22;
  value.m32 = m32;
  value.m03 = m03;
  value.m13 = m13;
  value.m23 = m23;
  value.m33 = m33;
  return value;
}

/* The entry of M at (row, column), for 0 <= row < 4 and 0 <= column < 4; NaN outside. */
static inline float ksl_mat4x4f_get(const ksl_mat4x4f_t *M, const int row, const int column) {
  return row >= 0 && row < 4 && column >= 0 && column < 4 ? M->at[column][row] : (float)NAN;
}

/* Sets the entry of M at (row, column), for 0 <= row < 4 and 0 <= column < 4; does nothing
     outside. */
static inline void ksl_mat4x4f_set(ksl_mat4x4f_t *M, const int row, const int column,
    const float value) {
  if (row >= 0 && row < 4 && column >= 0 && column < 4) {
    M->at[column][row] = value;
  }
}

/* M = [[R, t], [0, 1]] of D = [R | t].
   D: displacement [R | t], R rotation, t in m.
   No arithmetic.
   Exact. */
static inline ksl_mat4x4f_t ksl_mat4x4f_fromSE3f(const ksl_SE3f_t D) {
  ksl_mat4x4f_t M;
  M.m00 = D.m00;
  M.m01 = D.m01;
  M.m02 = D.m02;
  M.m03 = D.m03;
  M.m10 = D.m10;
  M.m11 = D.m11;
  M.m12 = D.m12;
  M.m13 = D.m13;
  M.m20 = D.m20;
  M.m21 = D.m21;
  M.m22 = D.m22;
  M.m23 = D.m23;
  M.m30 = 0.0f;
  M.m31 = 0.0f;
  M.m32 = 0.0f;
  M.m33 = 1.0f;
  return M;
}

/* M = [[R, t], [0, 1]].
   R: rotation or other 3×3 matrix; t: vector.
   No arithmetic.
   Exact. */
static inline ksl_mat4x4f_t ksl_mat4x4f_fromRt(const ksl_mat3x3f_t R, const ksl_vec3f_t t) {
  ksl_mat4x4f_t M;
  M.m00 = R.m00;
  M.m01 = R.m01;
  M.m02 = R.m02;
  M.m03 = t.x;
  M.m10 = R.m10;
  M.m11 = R.m11;
  M.m12 = R.m12;
  M.m13 = t.y;
  M.m20 = R.m20;
  M.m21 = R.m21;
  M.m22 = R.m22;
  M.m23 = t.z;
  M.m30 = 0.0f;
  M.m31 = 0.0f;
  M.m32 = 0.0f;
  M.m33 = 1.0f;
  return M;
}

/* D = [R | t], the first three rows of M.
   M: 4×4 matrix; D: displacement [R | t], R rotation, t in m.
   No arithmetic.
   Exact. */
static inline void ksl_mat4x4f_toSE3f(const ksl_mat4x4f_t *M, ksl_SE3f_t *D) {
  const float M_m00 = M->m00;
  const float M_m01 = M->m01;
  const float M_m02 = M->m02;
  const float M_m03 = M->m03;
  const float M_m10 = M->m10;
  const float M_m11 = M->m11;
  const float M_m12 = M->m12;
  const float M_m13 = M->m13;
  const float M_m20 = M->m20;
  const float M_m21 = M->m21;
  const float M_m22 = M->m22;
  const float M_m23 = M->m23;
  D->m00 = M_m00;
  D->m01 = M_m01;
  D->m02 = M_m02;
  D->m03 = M_m03;
  D->m10 = M_m10;
  D->m11 = M_m11;
  D->m12 = M_m12;
  D->m13 = M_m13;
  D->m20 = M_m20;
  D->m21 = M_m21;
  D->m22 = M_m22;
  D->m23 = M_m23;
}

/* self = I.
   self: 4×4 matrix.
   No arithmetic.
   Exact. */
static inline void ksl_mat4x4f_setIdentity(ksl_mat4x4f_t *self) {
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
  self->m30 = 0.0f;
  self->m31 = 0.0f;
  self->m32 = 0.0f;
  self->m33 = 1.0f;
}

/* t, the first three entries of the last column of M.
   M: 4×4 matrix; t: vector.
   No arithmetic.
   Exact. */
static inline void ksl_mat4x4f_getTranslation(const ksl_mat4x4f_t *M, ksl_vec3f_t *t) {
  const float M_m03 = M->m03;
  const float M_m13 = M->m13;
  const float M_m23 = M->m23;
  t->x = M_m03;
  t->y = M_m13;
  t->z = M_m23;
}

#ifndef KSL_NO_ALLOC
#include <stdlib.h>

/* n ksl_mat4x4_t on the heap, identities, to be freed by the caller; NULL for n <= 0 or when
     there is no memory. */
static inline ksl_mat4x4_t *ksl_mat4x4_alloc(int n) {
  ksl_mat4x4_t *const all =
      n > 0 ? (ksl_mat4x4_t *)calloc((size_t)n, sizeof(ksl_mat4x4_t)) : NULL;
  for (int i = 0; all && i < n; i++) {
    all[i].m00 = all[i].m11 = all[i].m22 = all[i].m33 = 1.0;
  }
  return all;
}

/* n ksl_mat4x4f_t on the heap, identities, to be freed by the caller; NULL for n <= 0 or when
     there is no memory. */
static inline ksl_mat4x4f_t *ksl_mat4x4f_alloc(int n) {
  ksl_mat4x4f_t *const all =
      n > 0 ? (ksl_mat4x4f_t *)calloc((size_t)n, sizeof(ksl_mat4x4f_t)) : NULL;
  for (int i = 0; all && i < n; i++) {
    all[i].m00 = all[i].m11 = all[i].m22 = all[i].m33 = 1.0f;
  }
  return all;
}

#endif

#endif
