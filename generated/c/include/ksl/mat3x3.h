/* Made by `coscrew generate`; changes are overwritten. */
/* SPDX-License-Identifier: MIT */
/* coscrew 0.1.0.  Copyright (c) 2026 The coscrew authors. */
/* 3×3 matrices: rotations, and matrices in general. */
#ifndef KSL_MAT3X3_H
#define KSL_MAT3X3_H

#include "ksl_types.h"
#include "vec3.h"

/* The mat3x3 of these entries, row by row. */
static inline ksl_mat3x3_t ksl_mat3x3(const double m00, const double m01, const double m02,
    const double m10, const double m11, const double m12, const double m20,
    const double m21, const double m22) {
  ksl_mat3x3_t value;
  value.m00 = m00;
  value.m01 = m01;
  value.m02 = m02;
  value.m10 = m10;
  value.m11 = m11;
  value.m12 = m12;
  value.m20 = m20;
  value.m21 = m21;
  value.m22 = m22;
  return value;
}

/* The mat3x3 of these entries, column by column. */
static inline ksl_mat3x3_t ksl_mat3x3_cmo(const double m00, const double m10, const double m20,
    const double m01, const double m11, const double m21, const double m02,
    const double m12, const double m22) {
  ksl_mat3x3_t value;
  value.m00 = m00;
  value.m10 = m10;
  value.m20 = m20;
  value.m01 = m01;
  value.m11 = m11;
  value.m21 = m21;
  value.m02 = m02;
  value.m12 = m12;
  value.m22 = m22;
  return value;
}

/* The entry of R at (row, column), for 0 <= row < 3 and 0 <= column < 3; NaN outside. */
static inline double ksl_mat3x3_get(const ksl_mat3x3_t *R, const int row, const int column) {
  return row >= 0 && row < 3 && column >= 0 && column < 3 ? R->at[column][row] : (double)NAN;
}

/* Sets the entry of R at (row, column), for 0 <= row < 3 and 0 <= column < 3; does nothing
     outside. */
static inline void ksl_mat3x3_set(ksl_mat3x3_t *R, const int row, const int column,
    const double value) {
  if (row >= 0 && row < 3 && column >= 0 && column < 3) {
    R->at[column][row] = value;
  }
}

/* Ro = R.
   R, Ro: rotation or other 3×3 matrix.
   No arithmetic.
   Exact. */
static inline void ksl_mat3x3_copy(const ksl_mat3x3_t *R, ksl_mat3x3_t *Ro) {
  const double R_m00 = R->m00;
  const double R_m01 = R->m01;
  const double R_m02 = R->m02;
  const double R_m10 = R->m10;
  const double R_m11 = R->m11;
  const double R_m12 = R->m12;
  const double R_m20 = R->m20;
  const double R_m21 = R->m21;
  const double R_m22 = R->m22;
  Ro->m00 = R_m00;
  Ro->m01 = R_m01;
  Ro->m02 = R_m02;
  Ro->m10 = R_m10;
  Ro->m11 = R_m11;
  Ro->m12 = R_m12;
  Ro->m20 = R_m20;
  Ro->m21 = R_m21;
  Ro->m22 = R_m22;
}

/* self = I.
   self: rotation or other 3×3 matrix.
   No arithmetic.
   Exact. */
static inline void ksl_mat3x3_setIdentity(ksl_mat3x3_t *self) {
  self->m00 = 1.0;
  self->m01 = 0.0;
  self->m02 = 0.0;
  self->m10 = 0.0;
  self->m11 = 1.0;
  self->m12 = 0.0;
  self->m20 = 0.0;
  self->m21 = 0.0;
  self->m22 = 1.0;
}

/* R = [x y z], the columns.
   R: rotation or other 3×3 matrix; x, y, z: vector.
   No arithmetic.
   Exact. */
static inline void ksl_mat3x3_setFromVectors(ksl_mat3x3_t *R, const ksl_vec3_t *x,
    const ksl_vec3_t *y, const ksl_vec3_t *z) {
  const double x_x = x->x;
  const double y_x = y->x;
  const double z_x = z->x;
  const double x_y = x->y;
  const double y_y = y->y;
  const double z_y = z->y;
  const double x_z = x->z;
  const double y_z = y->z;
  const double z_z = z->z;
  R->m00 = x_x;
  R->m01 = y_x;
  R->m02 = z_x;
  R->m10 = x_y;
  R->m11 = y_y;
  R->m12 = z_y;
  R->m20 = x_z;
  R->m21 = y_z;
  R->m22 = z_z;
}

/* Ro = v~, the matrix with v~ y = v × y.
   v: vector; Ro: rotation or other 3×3 matrix.
   3 neg.
   Exact. */
static inline void ksl_skew(const ksl_vec3_t *v, ksl_mat3x3_t *Ro) {
  const double Ro_01 = -v->z;
  const double Ro_12 = -v->x;
  const double Ro_20 = -v->y;
  const double v_y = v->y;
  const double v_z = v->z;
  const double v_x = v->x;
  Ro->m00 = 0.0;
  Ro->m01 = Ro_01;
  Ro->m02 = v_y;
  Ro->m10 = v_z;
  Ro->m11 = 0.0;
  Ro->m12 = Ro_12;
  Ro->m20 = Ro_20;
  Ro->m21 = v_x;
  Ro->m22 = 0.0;
}

/* self = self^T, the inverse of a rotation.
   self: rotation or other 3×3 matrix.
   No arithmetic.
   Exact. */
static inline void ksl_mat3x3_transpose(ksl_mat3x3_t *self) {
  const double self_m10 = self->m10;
  const double self_m20 = self->m20;
  const double self_m01 = self->m01;
  const double self_m21 = self->m21;
  const double self_m02 = self->m02;
  const double self_m12 = self->m12;
  self->m01 = self_m10;
  self->m02 = self_m20;
  self->m10 = self_m01;
  self->m12 = self_m21;
  self->m20 = self_m02;
  self->m21 = self_m12;
}

/* Ro = R^T, the inverse of a rotation.
   R, Ro: rotation or other 3×3 matrix.
   No arithmetic.
   Exact. */
static inline void ksl_mat3x3_transposed(const ksl_mat3x3_t *R, ksl_mat3x3_t *Ro) {
  const double R_m00 = R->m00;
  const double R_m10 = R->m10;
  const double R_m20 = R->m20;
  const double R_m01 = R->m01;
  const double R_m11 = R->m11;
  const double R_m21 = R->m21;
  const double R_m02 = R->m02;
  const double R_m12 = R->m12;
  const double R_m22 = R->m22;
  Ro->m00 = R_m00;
  Ro->m01 = R_m10;
  Ro->m02 = R_m20;
  Ro->m10 = R_m01;
  Ro->m11 = R_m11;
  Ro->m12 = R_m21;
  Ro->m20 = R_m02;
  Ro->m21 = R_m12;
  Ro->m22 = R_m22;
}

/* det R.
   R: rotation or other 3×3 matrix.
   9 mul, 5 add.
   Error <= u |result| + 4 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline double ksl_mat3x3_determinant(const ksl_mat3x3_t *R) {
  const double n_0a = R->m11 * R->m22, n_0b = R->m12 * R->m21, n_0 = n_0a - n_0b;
  const double n_1a = R->m02 * R->m21, n_1b = R->m01 * R->m22, n_1 = n_1a - n_1b;
  const double n_2a = R->m01 * R->m12, n_2b = R->m02 * R->m11, n_2 = n_2a - n_2b;
  const double det_a = R->m00 * n_0, det_b = R->m10 * n_1, det_c = det_a + det_b,
      det_d = R->m20 * n_2, det = det_c + det_d;
  return det;
}

/* The mat3x3 of these entries, row by row. */
static inline ksl_mat3x3f_t ksl_mat3x3f(const float m00, const float m01, const float m02,
    const float m10, const float m11, const float m12, const float m20,
    const float m21, const float m22) {
  ksl_mat3x3f_t value;
  value.m00 = m00;
  value.m01 = m01;
  value.m02 = m02;
  value.m10 = m10;
  value.m11 = m11;
  value.m12 = m12;
  value.m20 = m20;
  value.m21 = m21;
  value.m22 = m22;
  return value;
}

/* The mat3x3 of these entries, column by column. */
static inline ksl_mat3x3f_t ksl_mat3x3f_cmo(const float m00, const float m10, const float m20,
    const float m01, const float m11, const float m21, const float m02,
    const float m12, const float m22) {
  ksl_mat3x3f_t value;
  value.m00 = m00;
  value.m10 = m10;
  value.m20 = m20;
  value.m01 = m01;
  value.m11 = m11;
  value.m21 = m21;
  value.m02 = m02;
  value.m12 = m12;
  value.m22 = m22;
  return value;
}

/* The entry of R at (row, column), for 0 <= row < 3 and 0 <= column < 3; NaN outside. */
static inline float ksl_mat3x3f_get(const ksl_mat3x3f_t *R, const int row, const int column) {
  return row >= 0 && row < 3 && column >= 0 && column < 3 ? R->at[column][row] : (float)NAN;
}

/* Sets the entry of R at (row, column), for 0 <= row < 3 and 0 <= column < 3; does nothing
     outside. */
static inline void ksl_mat3x3f_set(ksl_mat3x3f_t *R, const int row, const int column,
    const float value) {
  if (row >= 0 && row < 3 && column >= 0 && column < 3) {
    R->at[column][row] = value;
  }
}

/* Ro = R.
   R, Ro: rotation or other 3×3 matrix.
   No arithmetic.
   Exact. */
static inline void ksl_mat3x3f_copy(const ksl_mat3x3f_t *R, ksl_mat3x3f_t *Ro) {
  const float R_m00 = R->m00;
  const float R_m01 = R->m01;
  const float R_m02 = R->m02;
  const float R_m10 = R->m10;
  const float R_m11 = R->m11;
  const float R_m12 = R->m12;
  const float R_m20 = R->m20;
  const float R_m21 = R->m21;
  const float R_m22 = R->m22;
  Ro->m00 = R_m00;
  Ro->m01 = R_m01;
  Ro->m02 = R_m02;
  Ro->m10 = R_m10;
  Ro->m11 = R_m11;
  Ro->m12 = R_m12;
  Ro->m20 = R_m20;
  Ro->m21 = R_m21;
  Ro->m22 = R_m22;
}

/* self = I.
   self: rotation or other 3×3 matrix.
   No arithmetic.
   Exact. */
static inline void ksl_mat3x3f_setIdentity(ksl_mat3x3f_t *self) {
  self->m00 = 1.0f;
  self->m01 = 0.0f;
  self->m02 = 0.0f;
  self->m10 = 0.0f;
  self->m11 = 1.0f;
  self->m12 = 0.0f;
  self->m20 = 0.0f;
  self->m21 = 0.0f;
  self->m22 = 1.0f;
}

/* R = [x y z], the columns.
   R: rotation or other 3×3 matrix; x, y, z: vector.
   No arithmetic.
   Exact. */
static inline void ksl_mat3x3f_setFromVectors(ksl_mat3x3f_t *R, const ksl_vec3f_t *x,
    const ksl_vec3f_t *y, const ksl_vec3f_t *z) {
  const float x_x = x->x;
  const float y_x = y->x;
  const float z_x = z->x;
  const float x_y = x->y;
  const float y_y = y->y;
  const float z_y = z->y;
  const float x_z = x->z;
  const float y_z = y->z;
  const float z_z = z->z;
  R->m00 = x_x;
  R->m01 = y_x;
  R->m02 = z_x;
  R->m10 = x_y;
  R->m11 = y_y;
  R->m12 = z_y;
  R->m20 = x_z;
  R->m21 = y_z;
  R->m22 = z_z;
}

/* Ro = v~, the matrix with v~ y = v × y.
   v: vector; Ro: rotation or other 3×3 matrix.
   3 neg.
   Exact. */
static inline void ksl_skewf(const ksl_vec3f_t *v, ksl_mat3x3f_t *Ro) {
  const float Ro_01 = -v->z;
  const float Ro_12 = -v->x;
  const float Ro_20 = -v->y;
  const float v_y = v->y;
  const float v_z = v->z;
  const float v_x = v->x;
  Ro->m00 = 0.0f;
  Ro->m01 = Ro_01;
  Ro->m02 = v_y;
  Ro->m10 = v_z;
  Ro->m11 = 0.0f;
  Ro->m12 = Ro_12;
  Ro->m20 = Ro_20;
  Ro->m21 = v_x;
  Ro->m22 = 0.0f;
}

/* self = self^T, the inverse of a rotation.
   self: rotation or other 3×3 matrix.
   No arithmetic.
   Exact. */
static inline void ksl_mat3x3f_transpose(ksl_mat3x3f_t *self) {
  const float self_m10 = self->m10;
  const float self_m20 = self->m20;
  const float self_m01 = self->m01;
  const float self_m21 = self->m21;
  const float self_m02 = self->m02;
  const float self_m12 = self->m12;
  self->m01 = self_m10;
  self->m02 = self_m20;
  self->m10 = self_m01;
  self->m12 = self_m21;
  self->m20 = self_m02;
  self->m21 = self_m12;
}

/* Ro = R^T, the inverse of a rotation.
   R, Ro: rotation or other 3×3 matrix.
   No arithmetic.
   Exact. */
static inline void ksl_mat3x3f_transposed(const ksl_mat3x3f_t *R, ksl_mat3x3f_t *Ro) {
  const float R_m00 = R->m00;
  const float R_m10 = R->m10;
  const float R_m20 = R->m20;
  const float R_m01 = R->m01;
  const float R_m11 = R->m11;
  const float R_m21 = R->m21;
  const float R_m02 = R->m02;
  const float R_m12 = R->m12;
  const float R_m22 = R->m22;
  Ro->m00 = R_m00;
  Ro->m01 = R_m10;
  Ro->m02 = R_m20;
  Ro->m10 = R_m01;
  Ro->m11 = R_m11;
  Ro->m12 = R_m21;
  Ro->m20 = R_m02;
  Ro->m21 = R_m12;
  Ro->m22 = R_m22;
}

/* det R.
   R: rotation or other 3×3 matrix.
   9 mul, 5 add.
   Error <= u |result| + 4 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline float ksl_mat3x3f_determinant(const ksl_mat3x3f_t *R) {
  const float n_0a = R->m11 * R->m22, n_0b = R->m12 * R->m21, n_0 = n_0a - n_0b;
  const float n_1a = R->m02 * R->m21, n_1b = R->m01 * R->m22, n_1 = n_1a - n_1b;
  const float n_2a = R->m01 * R->m12, n_2b = R->m02 * R->m11, n_2 = n_2a - n_2b;
  const float det_a = R->m00 * n_0, det_b = R->m10 * n_1, det_c = det_a + det_b,
      det_d = R->m20 * n_2, det = det_c + det_d;
  return det;
}

#ifndef KSL_NO_ALLOC
#include <stdlib.h>

/* n ksl_mat3x3_t on the heap, identities, to be freed by the caller; NULL for n <= 0 or when
     there is no memory. */
static inline ksl_mat3x3_t *ksl_mat3x3_alloc(int n) {
  ksl_mat3x3_t *const all =
      n > 0 ? (ksl_mat3x3_t *)calloc((size_t)n, sizeof(ksl_mat3x3_t)) : NULL;
  for (int i = 0; all && i < n; i++) {
    all[i].m00 = all[i].m11 = all[i].m22 = 1.0;
  }
  return all;
}

/* n ksl_mat3x3f_t on the heap, identities, to be freed by the caller; NULL for n <= 0 or when
     there is no memory. */
static inline ksl_mat3x3f_t *ksl_mat3x3f_alloc(int n) {
  ksl_mat3x3f_t *const all =
      n > 0 ? (ksl_mat3x3f_t *)calloc((size_t)n, sizeof(ksl_mat3x3f_t)) : NULL;
  for (int i = 0; all && i < n; i++) {
    all[i].m00 = all[i].m11 = all[i].m22 = 1.0f;
  }
  return all;
}

#endif

#endif
