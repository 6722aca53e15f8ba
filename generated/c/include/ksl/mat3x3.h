/* Made by `coscrew generate`; changes are overwritten. */
/* SPDX-License-Identifier: MIT */
/* coscrew 0.2.0.  Copyright (c) 2026 The coscrew authors. */
/* 3×3 matrices: rotations, and matrices in general. */
#ifndef KSL_MAT3X3_H
#define KSL_MAT3X3_H

#include <stdarg.h>
#include "ksl_types.h"
#include "elementary.h"
#include "vec3.h"
#include "axis.h"

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

/* Ro = w'~ + w~ w~ of a body with angular velocity w and angular acceleration w' = dw: the
     acceleration of its point x, less that of its origin, is Ro x.
   w, dw: vector; Ro: rotation or other 3×3 matrix.
   6 mul, 9 add, 3 neg.
   Error <= u |result| + 1 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_acceleration_tensor(const ksl_vec3_t *w, const ksl_vec3_t *dw,
    ksl_mat3x3_t *Ro) {
  const double ww_0 = KSL_MUL(w->x, w->x);
  const double ww_1 = KSL_MUL(w->y, w->y);
  const double ww_2 = KSL_MUL(w->z, w->z);
  const double ww_3 = KSL_MUL(w->x, w->y);
  const double ww_4 = KSL_MUL(w->x, w->z);
  const double ww_5 = KSL_MUL(w->y, w->z);
  const double Ro_00a = ww_1 + ww_2, Ro_00 = -Ro_00a;
  const double Ro_01 = ww_3 - dw->z;
  const double Ro_02 = dw->y + ww_4;
  const double Ro_10 = dw->z + ww_3;
  const double Ro_11a = ww_0 + ww_2, Ro_11 = -Ro_11a;
  const double Ro_12 = ww_5 - dw->x;
  const double Ro_20 = ww_4 - dw->y;
  const double Ro_21 = dw->x + ww_5;
  const double Ro_22a = ww_0 + ww_1, Ro_22 = -Ro_22a;
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
  const double n_0a = KSL_MUL(R->m11, R->m22), n_0b = KSL_MUL(R->m12, R->m21), n_0 = n_0a - n_0b;
  const double n_1a = KSL_MUL(R->m02, R->m21), n_1b = KSL_MUL(R->m01, R->m22), n_1 = n_1a - n_1b;
  const double n_2a = KSL_MUL(R->m01, R->m12), n_2b = KSL_MUL(R->m02, R->m11), n_2 = n_2a - n_2b;
  const double det_a = KSL_MUL(R->m00, n_0), det_b = KSL_MUL(R->m10, n_1), det_c = det_a + det_b,
      det_d = KSL_MUL(R->m20, n_2), det = det_c + det_d;
  return det;
}

/* Ro = R^-1 = adj R / det R; returns det R, which is 0 or infinite where it under- or overflows.
     Returns 0, with Ro = NaN, where R may be singular: |det R| <= 8 u p + 1e-29 m^3 (double
     1e-229 m^3), p the sum of the |terms| of det R, m the largest |entry|.
   R, Ro: rotation or other 3×3 matrix.
   56 mul, 17 add, 9 div, 1 neg, 19 abs, 16 less, 1 equal, 32 select.
   Error of Ro_ij <= 2 u m_ji / |det R| + 6 u |Ro_ij| p / |det R|, m_ji the sum of the |terms| of
     the cofactor, or 2^-80 m^2 (double 2^-700 m^2) if that is more; barring over- and underflow
     of Ro_ij itself. */
static inline double ksl_mat3x3_inverse(const ksl_mat3x3_t *R, ksl_mat3x3_t *Ro) {
  const double R_size_0 = fabs(R->m00);
  const double R_size_1 = fabs(R->m01);
  const double R_size_2 = fabs(R->m02);
  const double R_size_3 = fabs(R->m10);
  const double R_size_4 = fabs(R->m11);
  const double R_size_5 = fabs(R->m12);
  const double R_size_6 = fabs(R->m20);
  const double R_size_7 = fabs(R->m21);
  const double R_size_8 = fabs(R->m22);
  const double R_largest1 = R_size_0 < R_size_1 ? R_size_1 : R_size_0;
  const double R_largest2 = R_largest1 < R_size_2 ? R_size_2 : R_largest1;
  const double R_largest3 = R_largest2 < R_size_3 ? R_size_3 : R_largest2;
  const double R_largest4 = R_largest3 < R_size_4 ? R_size_4 : R_largest3;
  const double R_largest5 = R_largest4 < R_size_5 ? R_size_5 : R_largest4;
  const double R_largest6 = R_largest5 < R_size_6 ? R_size_6 : R_largest5;
  const double R_largest7 = R_largest6 < R_size_7 ? R_size_7 : R_largest6;
  const double R_largest8 = R_largest7 < R_size_8 ? R_size_8 : R_largest7;
  const double s_b = R_largest8 < 8.452712498170644e+270 ? 2.409919865102884e-181 :
      1.1830521861667747e-271,
      s_d = R_largest8 < 4.149515568880993e+180 ? 4.909093465297727e-91 : s_b,
      s_f = R_largest8 < 2.037035976334486e+90 ? 1.0 : s_d,
      s_h = R_largest8 < 1.0 ? 2.037035976334486e+90 : s_f,
      s_j = R_largest8 < 4.909093465297727e-91 ? 4.149515568880993e+180 : s_h,
      s = R_largest8 < 2.409919865102884e-181 ? 8.452712498170644e+270 : s_j;
  const double A_0 = KSL_MUL(R->m00, s);
  const double A_1 = KSL_MUL(R->m01, s);
  const double A_2 = KSL_MUL(R->m02, s);
  const double A_3 = KSL_MUL(R->m10, s);
  const double A_4 = KSL_MUL(R->m11, s);
  const double A_5 = KSL_MUL(R->m12, s);
  const double A_6 = KSL_MUL(R->m20, s);
  const double A_7 = KSL_MUL(R->m21, s);
  const double A_8 = KSL_MUL(R->m22, s);
  const double n0_0a = KSL_MUL(A_4, A_8), n0_0b = KSL_MUL(A_5, A_7), n0_0 = n0_0a - n0_0b;
  const double n0_1a = KSL_MUL(A_2, A_7), n0_1b = KSL_MUL(A_1, A_8), n0_1 = n0_1a - n0_1b;
  const double n0_2a = KSL_MUL(A_1, A_5), n0_2b = KSL_MUL(A_2, A_4), n0_2 = n0_2a - n0_2b;
  const double n1_0a = KSL_MUL(A_5, A_6), n1_0b = KSL_MUL(A_3, A_8), n1_0 = n1_0a - n1_0b;
  const double n1_1a = KSL_MUL(A_0, A_8), n1_1b = KSL_MUL(A_2, A_6), n1_1 = n1_1a - n1_1b;
  const double n1_2a = KSL_MUL(A_2, A_3), n1_2b = KSL_MUL(A_0, A_5), n1_2 = n1_2a - n1_2b;
  const double n2_0a = KSL_MUL(A_3, A_7), n2_0b = KSL_MUL(A_4, A_6), n2_0 = n2_0a - n2_0b;
  const double n2_1a = KSL_MUL(A_1, A_6), n2_1b = KSL_MUL(A_0, A_7), n2_1 = n2_1a - n2_1b;
  const double n2_2a = KSL_MUL(A_0, A_4), n2_2b = KSL_MUL(A_1, A_3), n2_2 = n2_2a - n2_2b;
  const double d_a = KSL_MUL(A_0, n0_0), d_b = KSL_MUL(A_3, n0_1), d_c = d_a + d_b,
      d_d = KSL_MUL(A_6, n0_2), d = d_c + d_d;
  const double size0_0 = fabs(A_0);
  const double size0_1 = fabs(A_3);
  const double size0_2 = fabs(A_6);
  const double size1_0 = fabs(A_1);
  const double size1_1 = fabs(A_4);
  const double size1_2 = fabs(A_7);
  const double size2_0 = fabs(A_2);
  const double size2_1 = fabs(A_5);
  const double size2_2 = fabs(A_8);
  const double permanent_a = KSL_MUL(size1_1, size2_2), permanent_b = KSL_MUL(size1_2, size2_1),
      permanent_c = permanent_a + permanent_b, permanent_d = KSL_MUL(size0_0, permanent_c),
      permanent_e = KSL_MUL(size1_0, size2_2), permanent_f = KSL_MUL(size1_2, size2_0),
      permanent_g = permanent_e + permanent_f, permanent_h = KSL_MUL(size0_1, permanent_g),
      permanent_i = permanent_d + permanent_h, permanent_j = KSL_MUL(size1_0, size2_1),
      permanent_k = KSL_MUL(size1_1, size2_0), permanent_l = permanent_j + permanent_k,
      permanent_m = KSL_MUL(size0_2, permanent_l), permanent = permanent_i + permanent_m;
  const double top = KSL_MUL(R_largest8, s);
  const double spoiled = KSL_MUL(top, 1.6489340850168661e-229);
  const double least_a = KSL_MUL(permanent, 8.881784197001252e-16), least_b = KSL_MUL(top, top),
      least_c = KSL_MUL(spoiled, least_b), least = least_a + least_c;
  const double regular_a = fabs(d), regular = least < regular_a ? 1.0 : 0.0;
  const double divisor = regular == 1.0 ? d : 1.0;
  const double quotient_0 = n0_0 / divisor;
  const double quotient_1 = n0_1 / divisor;
  const double quotient_2 = n0_2 / divisor;
  const double quotient_3 = n1_0 / divisor;
  const double quotient_4 = n1_1 / divisor;
  const double quotient_5 = n1_2 / divisor;
  const double quotient_6 = n2_0 / divisor;
  const double quotient_7 = n2_1 / divisor;
  const double quotient_8 = n2_2 / divisor;
  const double inverse_0 = KSL_MUL(quotient_0, s);
  const double inverse_1 = KSL_MUL(quotient_1, s);
  const double inverse_2 = KSL_MUL(quotient_2, s);
  const double inverse_3 = KSL_MUL(quotient_3, s);
  const double inverse_4 = KSL_MUL(quotient_4, s);
  const double inverse_5 = KSL_MUL(quotient_5, s);
  const double inverse_6 = KSL_MUL(quotient_6, s);
  const double inverse_7 = KSL_MUL(quotient_7, s);
  const double inverse_8 = KSL_MUL(quotient_8, s);
  const double start_a = -8.452712498170644e+270,
      start_c = d < 0.0 ? start_a : 8.452712498170644e+270,
      start = R_largest8 < 4.149515568880993e+180 ? d : start_c;
  const double r2 = R_largest8 < 4.909093465297727e-91 ? 1.1830521861667747e-271 : 1.0;
  const double once = KSL_MUL(start, r2);
  const double r3 = R_largest8 < 2.409919865102884e-181 ? 1.1830521861667747e-271 : 1.0;
  const double twice = KSL_MUL(once, r3);
  const double r_a = R_largest8 < 2.037035976334486e+90 ? 1.0 : 8.452712498170644e+270,
      r = R_largest8 < 1.0 ? 1.1830521861667747e-271 : r_a;
  const double det_R = KSL_MUL(twice, r);
  const double det = regular == 1.0 ? det_R : 0.0;
  const double Ro_00 = regular == 1.0 ? inverse_0 : (double)NAN;
  const double Ro_01 = regular == 1.0 ? inverse_1 : (double)NAN;
  const double Ro_02 = regular == 1.0 ? inverse_2 : (double)NAN;
  const double Ro_10 = regular == 1.0 ? inverse_3 : (double)NAN;
  const double Ro_11 = regular == 1.0 ? inverse_4 : (double)NAN;
  const double Ro_12 = regular == 1.0 ? inverse_5 : (double)NAN;
  const double Ro_20 = regular == 1.0 ? inverse_6 : (double)NAN;
  const double Ro_21 = regular == 1.0 ? inverse_7 : (double)NAN;
  const double Ro_22 = regular == 1.0 ? inverse_8 : (double)NAN;
  Ro->m00 = Ro_00;
  Ro->m01 = Ro_01;
  Ro->m02 = Ro_02;
  Ro->m10 = Ro_10;
  Ro->m11 = Ro_11;
  Ro->m12 = Ro_12;
  Ro->m20 = Ro_20;
  Ro->m21 = Ro_21;
  Ro->m22 = Ro_22;
  return det;
}

/* self = orthonormal rows by Gram–Schmidt: the first keeps its direction, the second stays on
     its side of the first, the third on its side of both; NaN where the rows are linearly
     dependent to rounding.
   self: rotation or other 3×3 matrix.
   60 mul, 23 add, 12 div, 4 sqrt, 3 neg, 10 abs, 24 less, 5 equal, 39 select.
   |R R^T - I|_ij <= 8 u for the result R; searched, not proved. */
static inline void ksl_mat3x3_normalize(ksl_mat3x3_t *self) {
  const double q0_s_size_0 = fabs(self->m00);
  const double q0_s_size_1 = fabs(self->m01);
  const double q0_s_size_2 = fabs(self->m02);
  const double q0_s_largest1 = q0_s_size_0 < q0_s_size_1 ? q0_s_size_1 : q0_s_size_0;
  const double q0_s_largest2 = q0_s_largest1 < q0_s_size_2 ? q0_s_size_2 : q0_s_largest1;
  const double q0_s_b = 6.703903964971299e+153 < q0_s_largest2 ? 3.7291703656001034e-155 : 1.0,
      q0_s_d = q0_s_largest2 < 256.0 ? 1.3093562431584567e+151 : q0_s_b,
      q0_s = q0_s_largest2 < 1.955159272639747e-149 ? 1.0715086071862673e+301 : q0_s_d;
  const double q0_y_0 = KSL_MUL(self->m00, q0_s);
  const double q0_y_1 = KSL_MUL(self->m01, q0_s);
  const double q0_y_2 = KSL_MUL(self->m02, q0_s);
  const double q0_up = 1.0 < q0_s ? q0_s : 1.0;
  const double q0_down = q0_s < 1.0 ? q0_s : 1.0;
  const double q0_n_a = KSL_MUL(q0_y_0, q0_y_0), q0_n_b = KSL_MUL(q0_y_1, q0_y_1),
      q0_n_c = q0_n_a + q0_n_b, q0_n_d = KSL_MUL(q0_y_2, q0_y_2), q0_n_e = q0_n_c + q0_n_d,
      q0_n = sqrt(q0_n_e);
  const double q0_divisor = q0_n == 0.0 ? q0_up : q0_n;
  const double q0_sized_0 = KSL_MUL(self->m00, q0_up);
  const double q0_sized_1 = KSL_MUL(self->m01, q0_up);
  const double q0_sized_2 = KSL_MUL(self->m02, q0_up);
  const double q0_quotient_0 = q0_sized_0 / q0_divisor;
  const double q0_quotient_1 = q0_sized_1 / q0_divisor;
  const double q0_quotient_2 = q0_sized_2 / q0_divisor;
  const double q0_0 = KSL_MUL(q0_quotient_0, q0_down);
  const double q0_1 = KSL_MUL(q0_quotient_1, q0_down);
  const double q0_2 = KSL_MUL(q0_quotient_2, q0_down);
  const double u1_s_size_0 = fabs(self->m10);
  const double u1_s_size_1 = fabs(self->m11);
  const double u1_s_size_2 = fabs(self->m12);
  const double u1_s_largest1 = u1_s_size_0 < u1_s_size_1 ? u1_s_size_1 : u1_s_size_0;
  const double u1_s_largest2 = u1_s_largest1 < u1_s_size_2 ? u1_s_size_2 : u1_s_largest1;
  const double u1_s_b = 6.703903964971299e+153 < u1_s_largest2 ? 3.7291703656001034e-155 : 1.0,
      u1_s_d = u1_s_largest2 < 256.0 ? 1.3093562431584567e+151 : u1_s_b,
      u1_s = u1_s_largest2 < 1.955159272639747e-149 ? 1.0715086071862673e+301 : u1_s_d;
  const double u1_y_0 = KSL_MUL(self->m10, u1_s);
  const double u1_y_1 = KSL_MUL(self->m11, u1_s);
  const double u1_y_2 = KSL_MUL(self->m12, u1_s);
  const double u1_up = 1.0 < u1_s ? u1_s : 1.0;
  const double u1_down = u1_s < 1.0 ? u1_s : 1.0;
  const double u1_n_a = KSL_MUL(u1_y_0, u1_y_0), u1_n_b = KSL_MUL(u1_y_1, u1_y_1),
      u1_n_c = u1_n_a + u1_n_b, u1_n_d = KSL_MUL(u1_y_2, u1_y_2), u1_n_e = u1_n_c + u1_n_d,
      u1_n = sqrt(u1_n_e);
  const double u1_divisor = u1_n == 0.0 ? u1_up : u1_n;
  const double u1_sized_0 = KSL_MUL(self->m10, u1_up);
  const double u1_sized_1 = KSL_MUL(self->m11, u1_up);
  const double u1_sized_2 = KSL_MUL(self->m12, u1_up);
  const double u1_quotient_0 = u1_sized_0 / u1_divisor;
  const double u1_quotient_1 = u1_sized_1 / u1_divisor;
  const double u1_quotient_2 = u1_sized_2 / u1_divisor;
  const double u1_0 = KSL_MUL(u1_quotient_0, u1_down);
  const double u1_1 = KSL_MUL(u1_quotient_1, u1_down);
  const double u1_2 = KSL_MUL(u1_quotient_2, u1_down);
  const double along_a = KSL_MUL(q0_0, u1_0), along_b = KSL_MUL(q0_1, u1_1),
      along_c = along_a + along_b, along_d = KSL_MUL(q0_2, u1_2), along = along_c + along_d;
  const double once_0a = KSL_MUL(q0_0, along), once_0 = u1_0 - once_0a;
  const double once_1a = KSL_MUL(q0_1, along), once_1 = u1_1 - once_1a;
  const double once_2a = KSL_MUL(q0_2, along), once_2 = u1_2 - once_2a;
  const double rest_a = KSL_MUL(q0_0, once_0), rest_b = KSL_MUL(q0_1, once_1),
      rest_c = rest_a + rest_b, rest_d = KSL_MUL(q0_2, once_2), rest = rest_c + rest_d;
  const double twice_0a = KSL_MUL(q0_0, rest), twice_0 = once_0 - twice_0a;
  const double twice_1a = KSL_MUL(q0_1, rest), twice_1 = once_1 - twice_1a;
  const double twice_2a = KSL_MUL(q0_2, rest), twice_2 = once_2 - twice_2a;
  const double n_a = KSL_MUL(twice_0, twice_0), n_b = KSL_MUL(twice_1, twice_1), n_c = n_a + n_b,
      n_d = KSL_MUL(twice_2, twice_2), n_e = n_c + n_d, n = sqrt(n_e);
  const double divisor = n == 0.0 ? 1.0 : n;
  const double q1_0 = twice_0 / divisor;
  const double q1_1 = twice_1 / divisor;
  const double q1_2 = twice_2 / divisor;
  const double normal_0a = KSL_MUL(q0_1, q1_2), normal_0b = KSL_MUL(q0_2, q1_1),
      normal_0 = normal_0a - normal_0b;
  const double normal_1a = KSL_MUL(q0_2, q1_0), normal_1b = KSL_MUL(q0_0, q1_2),
      normal_1 = normal_1a - normal_1b;
  const double normal_2a = KSL_MUL(q0_0, q1_1), normal_2b = KSL_MUL(q0_1, q1_0),
      normal_2 = normal_2a - normal_2b;
  const double u2_s_size_0 = fabs(self->m20);
  const double u2_s_size_1 = fabs(self->m21);
  const double u2_s_size_2 = fabs(self->m22);
  const double u2_s_largest1 = u2_s_size_0 < u2_s_size_1 ? u2_s_size_1 : u2_s_size_0;
  const double u2_s_largest2 = u2_s_largest1 < u2_s_size_2 ? u2_s_size_2 : u2_s_largest1;
  const double u2_s_b = 6.703903964971299e+153 < u2_s_largest2 ? 3.7291703656001034e-155 : 1.0,
      u2_s_d = u2_s_largest2 < 256.0 ? 1.3093562431584567e+151 : u2_s_b,
      u2_s = u2_s_largest2 < 1.955159272639747e-149 ? 1.0715086071862673e+301 : u2_s_d;
  const double u2_y_0 = KSL_MUL(self->m20, u2_s);
  const double u2_y_1 = KSL_MUL(self->m21, u2_s);
  const double u2_y_2 = KSL_MUL(self->m22, u2_s);
  const double u2_up = 1.0 < u2_s ? u2_s : 1.0;
  const double u2_down = u2_s < 1.0 ? u2_s : 1.0;
  const double u2_n_a = KSL_MUL(u2_y_0, u2_y_0), u2_n_b = KSL_MUL(u2_y_1, u2_y_1),
      u2_n_c = u2_n_a + u2_n_b, u2_n_d = KSL_MUL(u2_y_2, u2_y_2), u2_n_e = u2_n_c + u2_n_d,
      u2_n = sqrt(u2_n_e);
  const double u2_divisor = u2_n == 0.0 ? u2_up : u2_n;
  const double u2_sized_0 = KSL_MUL(self->m20, u2_up);
  const double u2_sized_1 = KSL_MUL(self->m21, u2_up);
  const double u2_sized_2 = KSL_MUL(self->m22, u2_up);
  const double u2_quotient_0 = u2_sized_0 / u2_divisor;
  const double u2_quotient_1 = u2_sized_1 / u2_divisor;
  const double u2_quotient_2 = u2_sized_2 / u2_divisor;
  const double u2_0 = KSL_MUL(u2_quotient_0, u2_down);
  const double u2_1 = KSL_MUL(u2_quotient_1, u2_down);
  const double u2_2 = KSL_MUL(u2_quotient_2, u2_down);
  const double side_a = KSL_MUL(normal_0, u2_0), side_b = KSL_MUL(normal_1, u2_1),
      side_c = side_a + side_b, side_d = KSL_MUL(normal_2, u2_2), side = side_c + side_d;
  const double q2_0a = -normal_0, q2_0 = side < 0.0 ? q2_0a : normal_0;
  const double q2_1a = -normal_1, q2_1 = side < 0.0 ? q2_1a : normal_1;
  const double q2_2a = -normal_2, q2_2 = side < 0.0 ? q2_2a : normal_2;
  const double size = fabs(side);
  const double less = n < size ? n : size;
  const double dependent = less < 1.7763568394002505e-15 ? 1.0 : 0.0;
  const double self_00_new = dependent == 1.0 ? (double)NAN : q0_0;
  const double self_01_new = dependent == 1.0 ? (double)NAN : q0_1;
  const double self_02_new = dependent == 1.0 ? (double)NAN : q0_2;
  const double self_10_new = dependent == 1.0 ? (double)NAN : q1_0;
  const double self_11_new = dependent == 1.0 ? (double)NAN : q1_1;
  const double self_12_new = dependent == 1.0 ? (double)NAN : q1_2;
  const double self_20_new = dependent == 1.0 ? (double)NAN : q2_0;
  const double self_21_new = dependent == 1.0 ? (double)NAN : q2_1;
  const double self_22_new = dependent == 1.0 ? (double)NAN : q2_2;
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

/* Ro = orthonormal rows by Gram–Schmidt: the first keeps its direction, the second stays on its
     side of the first, the third on its side of both; NaN where the rows are linearly dependent
     to rounding.
   R, Ro: rotation or other 3×3 matrix.
   60 mul, 23 add, 12 div, 4 sqrt, 3 neg, 10 abs, 24 less, 5 equal, 39 select.
   |R R^T - I|_ij <= 8 u for the result R; searched, not proved. */
static inline void ksl_mat3x3_normalized(const ksl_mat3x3_t *R, ksl_mat3x3_t *Ro) {
  const double q0_s_size_0 = fabs(R->m00);
  const double q0_s_size_1 = fabs(R->m01);
  const double q0_s_size_2 = fabs(R->m02);
  const double q0_s_largest1 = q0_s_size_0 < q0_s_size_1 ? q0_s_size_1 : q0_s_size_0;
  const double q0_s_largest2 = q0_s_largest1 < q0_s_size_2 ? q0_s_size_2 : q0_s_largest1;
  const double q0_s_b = 6.703903964971299e+153 < q0_s_largest2 ? 3.7291703656001034e-155 : 1.0,
      q0_s_d = q0_s_largest2 < 256.0 ? 1.3093562431584567e+151 : q0_s_b,
      q0_s = q0_s_largest2 < 1.955159272639747e-149 ? 1.0715086071862673e+301 : q0_s_d;
  const double q0_y_0 = KSL_MUL(R->m00, q0_s);
  const double q0_y_1 = KSL_MUL(R->m01, q0_s);
  const double q0_y_2 = KSL_MUL(R->m02, q0_s);
  const double q0_up = 1.0 < q0_s ? q0_s : 1.0;
  const double q0_down = q0_s < 1.0 ? q0_s : 1.0;
  const double q0_n_a = KSL_MUL(q0_y_0, q0_y_0), q0_n_b = KSL_MUL(q0_y_1, q0_y_1),
      q0_n_c = q0_n_a + q0_n_b, q0_n_d = KSL_MUL(q0_y_2, q0_y_2), q0_n_e = q0_n_c + q0_n_d,
      q0_n = sqrt(q0_n_e);
  const double q0_divisor = q0_n == 0.0 ? q0_up : q0_n;
  const double q0_sized_0 = KSL_MUL(R->m00, q0_up);
  const double q0_sized_1 = KSL_MUL(R->m01, q0_up);
  const double q0_sized_2 = KSL_MUL(R->m02, q0_up);
  const double q0_quotient_0 = q0_sized_0 / q0_divisor;
  const double q0_quotient_1 = q0_sized_1 / q0_divisor;
  const double q0_quotient_2 = q0_sized_2 / q0_divisor;
  const double q0_0 = KSL_MUL(q0_quotient_0, q0_down);
  const double q0_1 = KSL_MUL(q0_quotient_1, q0_down);
  const double q0_2 = KSL_MUL(q0_quotient_2, q0_down);
  const double u1_s_size_0 = fabs(R->m10);
  const double u1_s_size_1 = fabs(R->m11);
  const double u1_s_size_2 = fabs(R->m12);
  const double u1_s_largest1 = u1_s_size_0 < u1_s_size_1 ? u1_s_size_1 : u1_s_size_0;
  const double u1_s_largest2 = u1_s_largest1 < u1_s_size_2 ? u1_s_size_2 : u1_s_largest1;
  const double u1_s_b = 6.703903964971299e+153 < u1_s_largest2 ? 3.7291703656001034e-155 : 1.0,
      u1_s_d = u1_s_largest2 < 256.0 ? 1.3093562431584567e+151 : u1_s_b,
      u1_s = u1_s_largest2 < 1.955159272639747e-149 ? 1.0715086071862673e+301 : u1_s_d;
  const double u1_y_0 = KSL_MUL(R->m10, u1_s);
  const double u1_y_1 = KSL_MUL(R->m11, u1_s);
  const double u1_y_2 = KSL_MUL(R->m12, u1_s);
  const double u1_up = 1.0 < u1_s ? u1_s : 1.0;
  const double u1_down = u1_s < 1.0 ? u1_s : 1.0;
  const double u1_n_a = KSL_MUL(u1_y_0, u1_y_0), u1_n_b = KSL_MUL(u1_y_1, u1_y_1),
      u1_n_c = u1_n_a + u1_n_b, u1_n_d = KSL_MUL(u1_y_2, u1_y_2), u1_n_e = u1_n_c + u1_n_d,
      u1_n = sqrt(u1_n_e);
  const double u1_divisor = u1_n == 0.0 ? u1_up : u1_n;
  const double u1_sized_0 = KSL_MUL(R->m10, u1_up);
  const double u1_sized_1 = KSL_MUL(R->m11, u1_up);
  const double u1_sized_2 = KSL_MUL(R->m12, u1_up);
  const double u1_quotient_0 = u1_sized_0 / u1_divisor;
  const double u1_quotient_1 = u1_sized_1 / u1_divisor;
  const double u1_quotient_2 = u1_sized_2 / u1_divisor;
  const double u1_0 = KSL_MUL(u1_quotient_0, u1_down);
  const double u1_1 = KSL_MUL(u1_quotient_1, u1_down);
  const double u1_2 = KSL_MUL(u1_quotient_2, u1_down);
  const double along_a = KSL_MUL(q0_0, u1_0), along_b = KSL_MUL(q0_1, u1_1),
      along_c = along_a + along_b, along_d = KSL_MUL(q0_2, u1_2), along = along_c + along_d;
  const double once_0a = KSL_MUL(q0_0, along), once_0 = u1_0 - once_0a;
  const double once_1a = KSL_MUL(q0_1, along), once_1 = u1_1 - once_1a;
  const double once_2a = KSL_MUL(q0_2, along), once_2 = u1_2 - once_2a;
  const double rest_a = KSL_MUL(q0_0, once_0), rest_b = KSL_MUL(q0_1, once_1),
      rest_c = rest_a + rest_b, rest_d = KSL_MUL(q0_2, once_2), rest = rest_c + rest_d;
  const double twice_0a = KSL_MUL(q0_0, rest), twice_0 = once_0 - twice_0a;
  const double twice_1a = KSL_MUL(q0_1, rest), twice_1 = once_1 - twice_1a;
  const double twice_2a = KSL_MUL(q0_2, rest), twice_2 = once_2 - twice_2a;
  const double n_a = KSL_MUL(twice_0, twice_0), n_b = KSL_MUL(twice_1, twice_1), n_c = n_a + n_b,
      n_d = KSL_MUL(twice_2, twice_2), n_e = n_c + n_d, n = sqrt(n_e);
  const double divisor = n == 0.0 ? 1.0 : n;
  const double q1_0 = twice_0 / divisor;
  const double q1_1 = twice_1 / divisor;
  const double q1_2 = twice_2 / divisor;
  const double normal_0a = KSL_MUL(q0_1, q1_2), normal_0b = KSL_MUL(q0_2, q1_1),
      normal_0 = normal_0a - normal_0b;
  const double normal_1a = KSL_MUL(q0_2, q1_0), normal_1b = KSL_MUL(q0_0, q1_2),
      normal_1 = normal_1a - normal_1b;
  const double normal_2a = KSL_MUL(q0_0, q1_1), normal_2b = KSL_MUL(q0_1, q1_0),
      normal_2 = normal_2a - normal_2b;
  const double u2_s_size_0 = fabs(R->m20);
  const double u2_s_size_1 = fabs(R->m21);
  const double u2_s_size_2 = fabs(R->m22);
  const double u2_s_largest1 = u2_s_size_0 < u2_s_size_1 ? u2_s_size_1 : u2_s_size_0;
  const double u2_s_largest2 = u2_s_largest1 < u2_s_size_2 ? u2_s_size_2 : u2_s_largest1;
  const double u2_s_b = 6.703903964971299e+153 < u2_s_largest2 ? 3.7291703656001034e-155 : 1.0,
      u2_s_d = u2_s_largest2 < 256.0 ? 1.3093562431584567e+151 : u2_s_b,
      u2_s = u2_s_largest2 < 1.955159272639747e-149 ? 1.0715086071862673e+301 : u2_s_d;
  const double u2_y_0 = KSL_MUL(R->m20, u2_s);
  const double u2_y_1 = KSL_MUL(R->m21, u2_s);
  const double u2_y_2 = KSL_MUL(R->m22, u2_s);
  const double u2_up = 1.0 < u2_s ? u2_s : 1.0;
  const double u2_down = u2_s < 1.0 ? u2_s : 1.0;
  const double u2_n_a = KSL_MUL(u2_y_0, u2_y_0), u2_n_b = KSL_MUL(u2_y_1, u2_y_1),
      u2_n_c = u2_n_a + u2_n_b, u2_n_d = KSL_MUL(u2_y_2, u2_y_2), u2_n_e = u2_n_c + u2_n_d,
      u2_n = sqrt(u2_n_e);
  const double u2_divisor = u2_n == 0.0 ? u2_up : u2_n;
  const double u2_sized_0 = KSL_MUL(R->m20, u2_up);
  const double u2_sized_1 = KSL_MUL(R->m21, u2_up);
  const double u2_sized_2 = KSL_MUL(R->m22, u2_up);
  const double u2_quotient_0 = u2_sized_0 / u2_divisor;
  const double u2_quotient_1 = u2_sized_1 / u2_divisor;
  const double u2_quotient_2 = u2_sized_2 / u2_divisor;
  const double u2_0 = KSL_MUL(u2_quotient_0, u2_down);
  const double u2_1 = KSL_MUL(u2_quotient_1, u2_down);
  const double u2_2 = KSL_MUL(u2_quotient_2, u2_down);
  const double side_a = KSL_MUL(normal_0, u2_0), side_b = KSL_MUL(normal_1, u2_1),
      side_c = side_a + side_b, side_d = KSL_MUL(normal_2, u2_2), side = side_c + side_d;
  const double q2_0a = -normal_0, q2_0 = side < 0.0 ? q2_0a : normal_0;
  const double q2_1a = -normal_1, q2_1 = side < 0.0 ? q2_1a : normal_1;
  const double q2_2a = -normal_2, q2_2 = side < 0.0 ? q2_2a : normal_2;
  const double size = fabs(side);
  const double less = n < size ? n : size;
  const double dependent = less < 1.7763568394002505e-15 ? 1.0 : 0.0;
  const double Ro_00 = dependent == 1.0 ? (double)NAN : q0_0;
  const double Ro_01 = dependent == 1.0 ? (double)NAN : q0_1;
  const double Ro_02 = dependent == 1.0 ? (double)NAN : q0_2;
  const double Ro_10 = dependent == 1.0 ? (double)NAN : q1_0;
  const double Ro_11 = dependent == 1.0 ? (double)NAN : q1_1;
  const double Ro_12 = dependent == 1.0 ? (double)NAN : q1_2;
  const double Ro_20 = dependent == 1.0 ? (double)NAN : q2_0;
  const double Ro_21 = dependent == 1.0 ? (double)NAN : q2_1;
  const double Ro_22 = dependent == 1.0 ? (double)NAN : q2_2;
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

/* R = cos θ I + sin θ a~ + (1 - cos θ) a a^T, a = axis of length 1 (else R is not a rotation),
     dc = (sin θ, cos θ).
   R: rotation or other 3×3 matrix; axis: vector; dc: (sin θ, cos θ).
   12 mul, 10 add.
   Error <= u |result| + 3 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_mat3x3_setFromAxisDC(ksl_mat3x3_t *R, const ksl_vec3_t *axis,
    const double dc[2]) {
  const double versine = 1.0 - dc[1];
  const double versine_axis_0 = KSL_MUL(axis->x, versine);
  const double versine_axis_1 = KSL_MUL(axis->y, versine);
  const double versine_axis_2 = KSL_MUL(axis->z, versine);
  const double m_0 = KSL_MUL(axis->x, versine_axis_0);
  const double m_1 = KSL_MUL(axis->y, versine_axis_1);
  const double m_2 = KSL_MUL(axis->z, versine_axis_2);
  const double m_3 = KSL_MUL(axis->y, versine_axis_0);
  const double m_4 = KSL_MUL(axis->z, versine_axis_0);
  const double m_5 = KSL_MUL(axis->z, versine_axis_1);
  const double sine_axis_0 = KSL_MUL(axis->x, dc[0]);
  const double sine_axis_1 = KSL_MUL(axis->y, dc[0]);
  const double sine_axis_2 = KSL_MUL(axis->z, dc[0]);
  const double R_00 = dc[1] + m_0;
  const double R_01 = m_3 - sine_axis_2;
  const double R_02 = m_4 + sine_axis_1;
  const double R_10 = m_3 + sine_axis_2;
  const double R_11 = dc[1] + m_1;
  const double R_12 = m_5 - sine_axis_0;
  const double R_20 = m_4 - sine_axis_1;
  const double R_21 = m_5 + sine_axis_0;
  const double R_22 = dc[1] + m_2;
  R->m00 = R_00;
  R->m01 = R_01;
  R->m02 = R_02;
  R->m10 = R_10;
  R->m11 = R_11;
  R->m12 = R_12;
  R->m20 = R_20;
  R->m21 = R_21;
  R->m22 = R_22;
}

/* R = R_x(a) R_y(b) R_z(c), angles = (a, b, c).
   angles: vector; R: rotation or other 3×3 matrix.
   98 mul, 103 add, 3 neg, 3 abs. */
static inline void ksl_mat3x3_from_euler_xyz(const ksl_vec3_t *angles, ksl_mat3x3_t *R) {
  double c_0; const double s_0 = ksl_sincos(angles->x, &c_0);
  double c_1; const double s_1 = ksl_sincos(angles->y, &c_1);
  double c_2; const double s_2 = ksl_sincos(angles->z, &c_2);
  const double first_0 = KSL_MUL(c_1, c_2);
  const double first_1a = KSL_MUL(s_2, c_1), first_1 = -first_1a;
  const double first_6a = KSL_MUL(s_1, c_2), first_6 = -first_6a;
  const double first_7 = KSL_MUL(s_1, s_2);
  const double last_3a = KSL_MUL(s_2, c_0), last_3b = KSL_MUL(s_0, first_6),
      last_3 = last_3a - last_3b;
  const double last_4a = KSL_MUL(c_0, c_2), last_4b = KSL_MUL(s_0, first_7),
      last_4 = last_4a - last_4b;
  const double last_5a = KSL_MUL(s_0, c_1), last_5 = -last_5a;
  const double last_6a = KSL_MUL(s_0, s_2), last_6b = KSL_MUL(c_0, first_6),
      last_6 = last_6a + last_6b;
  const double last_7a = KSL_MUL(s_0, c_2), last_7b = KSL_MUL(c_0, first_7),
      last_7 = last_7a + last_7b;
  const double last_8 = KSL_MUL(c_0, c_1);
  R->m00 = first_0;
  R->m01 = first_1;
  R->m02 = s_1;
  R->m10 = last_3;
  R->m11 = last_4;
  R->m12 = last_5;
  R->m20 = last_6;
  R->m21 = last_7;
  R->m22 = last_8;
}

/* angles of the rotation R = R_x(a) R_y(b) R_z(c), angles = (a, b, c); a, c in [-π, π], b in
     [-π/2, π/2]; c = 0 in gimbal lock.
   R: rotation or other 3×3 matrix; angles: vector.
   93 mul, 108 add, 5 div, 1 sqrt, 4 neg, 6 abs, 6 copysign, 18 less, 4 equal, 45 select.
   The rotation by these angles differs from R by at most 12 u in each entry, near gimbal lock
     too; searched, not proved. */
static inline void ksl_euler_xyz_from_mat3x3(const ksl_mat3x3_t *R, ksl_vec3_t *angles) {
  const double n_a = KSL_MUL(R->m00, R->m00), n_b = KSL_MUL(R->m01, R->m01), n_c = n_a + n_b,
      n = sqrt(n_c);
  const double divisor = n == 0.0 ? 1.0 : n;
  const double cosine_a = R->m00 / divisor, cosine = n == 0.0 ? 1.0 : cosine_a;
  const double sine_a = -R->m01, sine = sine_a / divisor;
  const double polar = ksl_atan2(sine_a, R->m00);
  const double third = n == 0.0 ? 0.0 : polar;
  const double left_1a = KSL_MUL(R->m10, sine), left_1b = KSL_MUL(R->m11, cosine),
      left_1 = left_1a + left_1b;
  const double left_2a = KSL_MUL(R->m20, sine), left_2b = KSL_MUL(R->m21, cosine),
      left_2 = left_2a + left_2b;
  const double angles_0 = ksl_atan2(left_2, left_1);
  const double angles_1 = ksl_atan2(R->m02, n);
  angles->x = angles_0;
  angles->y = angles_1;
  angles->z = third;
}

/* R = R_x(a) R_y(b) R_x(c), angles = (a, b, c).
   angles: vector; R: rotation or other 3×3 matrix.
   98 mul, 103 add, 2 neg, 3 abs. */
static inline void ksl_mat3x3_from_euler_xyx(const ksl_vec3_t *angles, ksl_mat3x3_t *R) {
  double c_0; const double s_0 = ksl_sincos(angles->x, &c_0);
  double c_1; const double s_1 = ksl_sincos(angles->y, &c_1);
  double c_2; const double s_2 = ksl_sincos(angles->z, &c_2);
  const double first_1 = KSL_MUL(s_1, s_2);
  const double first_2 = KSL_MUL(s_1, c_2);
  const double first_7 = KSL_MUL(s_2, c_1);
  const double first_8 = KSL_MUL(c_1, c_2);
  const double last_3 = KSL_MUL(s_0, s_1);
  const double last_4a = KSL_MUL(c_0, c_2), last_4b = KSL_MUL(s_0, first_7),
      last_4 = last_4a - last_4b;
  const double last_5a = KSL_MUL(s_0, first_8), last_5b = KSL_MUL(s_2, c_0),
      last_5c = last_5a + last_5b, last_5 = -last_5c;
  const double last_6a = KSL_MUL(s_1, c_0), last_6 = -last_6a;
  const double last_7a = KSL_MUL(s_0, c_2), last_7b = KSL_MUL(c_0, first_7),
      last_7 = last_7a + last_7b;
  const double last_8a = KSL_MUL(c_0, first_8), last_8b = KSL_MUL(s_0, s_2),
      last_8 = last_8a - last_8b;
  R->m00 = c_1;
  R->m01 = first_1;
  R->m02 = first_2;
  R->m10 = last_3;
  R->m11 = last_4;
  R->m12 = last_5;
  R->m20 = last_6;
  R->m21 = last_7;
  R->m22 = last_8;
}

/* angles of the rotation R = R_x(a) R_y(b) R_x(c), angles = (a, b, c); a, c in [-π, π], b in [0,
     π]; c = 0 in gimbal lock.
   R: rotation or other 3×3 matrix; angles: vector.
   93 mul, 108 add, 5 div, 1 sqrt, 3 neg, 6 abs, 6 copysign, 18 less, 4 equal, 45 select.
   The rotation by these angles differs from R by at most 12 u in each entry, near gimbal lock
     too; searched, not proved. */
static inline void ksl_euler_xyx_from_mat3x3(const ksl_mat3x3_t *R, ksl_vec3_t *angles) {
  const double n_a = KSL_MUL(R->m01, R->m01), n_b = KSL_MUL(R->m02, R->m02), n_c = n_a + n_b,
      n = sqrt(n_c);
  const double divisor = n == 0.0 ? 1.0 : n;
  const double cosine_a = R->m02 / divisor, cosine = n == 0.0 ? 1.0 : cosine_a;
  const double sine = R->m01 / divisor;
  const double polar = ksl_atan2(R->m01, R->m02);
  const double third = n == 0.0 ? 0.0 : polar;
  const double left_1a = KSL_MUL(R->m11, cosine), left_1b = KSL_MUL(R->m12, sine),
      left_1 = left_1a - left_1b;
  const double left_2a = KSL_MUL(R->m21, cosine), left_2b = KSL_MUL(R->m22, sine),
      left_2 = left_2a - left_2b;
  const double angles_0 = ksl_atan2(left_2, left_1);
  const double angles_1 = ksl_atan2(n, R->m00);
  angles->x = angles_0;
  angles->y = angles_1;
  angles->z = third;
}

/* A = J^T A J, V = V J: Jacobi's rotation J in the xy plane, by the smaller angle that makes
     A_xy zero; then y, z, x become x, y, z.  A is symmetric, only its lower triangle is read.
     Repeated from V = I, it converges to A = diag(eigenvalues); V A V^T does not change.
   A, V: rotation or other 3×3 matrix.
   21 mul, 14 add, 3 div, 2 sqrt, 1 neg, 1 abs, 1 less, 1 equal, 3 select.
   V A V^T changes by at most 28 u max |A| for orthonormal V; searched, not proved. */
static inline void ksl_mat3x3_jacobi(ksl_mat3x3_t *A, ksl_mat3x3_t *V) {
  const double twice = KSL_MUL(2.0, A->m10);
  const double apart = A->m11 - A->m00;
  const double divisor = twice == 0.0 ? 1.0 : twice;
  const double theta = apart / divisor;
  const double magnitude = fabs(theta);
  const double size_a = KSL_MUL(theta, theta), size_b = 1.0 + size_a, size_c = sqrt(size_b),
      size = magnitude + size_c;
  const double along_a = -size, along = theta < 0.0 ? along_a : size;
  const double t_a = 1.0 / along, t = twice == 0.0 ? 0.0 : t_a;
  const double secant_a = KSL_MUL(t, t), secant_b = 1.0 + secant_a, secant = sqrt(secant_b);
  const double c = 1.0 / secant;
  const double s = KSL_MUL(t, c);
  const double change = KSL_MUL(A->m10, t);
  const double zp_a = KSL_MUL(A->m20, c), zp_b = KSL_MUL(A->m21, s), zp = zp_a - zp_b;
  const double zq_a = KSL_MUL(A->m20, s), zq_b = KSL_MUL(A->m21, c), zq = zq_a + zq_b;
  const double vp_0a = KSL_MUL(V->m00, c), vp_0b = KSL_MUL(V->m01, s), vp_0 = vp_0a - vp_0b;
  const double vp_1a = KSL_MUL(V->m10, c), vp_1b = KSL_MUL(V->m11, s), vp_1 = vp_1a - vp_1b;
  const double vp_2a = KSL_MUL(V->m20, c), vp_2b = KSL_MUL(V->m21, s), vp_2 = vp_2a - vp_2b;
  const double vq_0a = KSL_MUL(V->m00, s), vq_0b = KSL_MUL(V->m01, c), vq_0 = vq_0a + vq_0b;
  const double vq_1a = KSL_MUL(V->m10, s), vq_1b = KSL_MUL(V->m11, c), vq_1 = vq_1a + vq_1b;
  const double vq_2a = KSL_MUL(V->m20, s), vq_2b = KSL_MUL(V->m21, c), vq_2 = vq_2a + vq_2b;
  const double A_00_new = A->m11 + change;
  const double A_22_new = A->m00 - change;
  const double A_m22 = A->m22;
  const double V_m02 = V->m02;
  const double V_m12 = V->m12;
  const double V_m22 = V->m22;
  A->m00 = A_00_new;
  A->m01 = zq;
  A->m02 = 0.0;
  A->m10 = zq;
  A->m11 = A_m22;
  A->m12 = zp;
  A->m20 = 0.0;
  A->m21 = zp;
  A->m22 = A_22_new;
  V->m00 = vq_0;
  V->m01 = V_m02;
  V->m02 = vp_0;
  V->m10 = vq_1;
  V->m11 = V_m12;
  V->m12 = vp_1;
  V->m20 = vq_2;
  V->m21 = V_m22;
  V->m22 = vp_2;
}

/* R = I + sin(angle) axis~ + (1 - cos(angle)) axis~^2, for an axis of length 1; otherwise R is
     not a rotation.
   axis: vector; angle: number; R: rotation or other 3×3 matrix.
   71 mul, 79 add, 2 abs, 1 less, 1 select.
   Error <= R: 9 u of its largest component for |axis| = 1; searched, not proved. */
static inline void ksl_mat3x3_from_axis_angle(const ksl_vec3_t *axis, const double angle,
    ksl_mat3x3_t *R) {
  const double half = KSL_MUL(0.5, angle);
  const double h = ksl_sin(half);
  double cosine; const double sine = ksl_sincos(angle, &cosine);
  const double versine_a = KSL_MUL(h, h), versine_b = KSL_MUL(2.0, versine_a),
      versine_c = 1.0 - cosine, versine = cosine < 0.0 ? versine_c : versine_b;
  const double beta_v_0 = KSL_MUL(axis->x, versine);
  const double beta_v_1 = KSL_MUL(axis->y, versine);
  const double beta_v_2 = KSL_MUL(axis->z, versine);
  const double m_0 = KSL_MUL(axis->x, beta_v_0);
  const double m_1 = KSL_MUL(axis->y, beta_v_1);
  const double m_2 = KSL_MUL(axis->z, beta_v_2);
  const double m_3 = KSL_MUL(axis->y, beta_v_0);
  const double m_4 = KSL_MUL(axis->z, beta_v_0);
  const double m_5 = KSL_MUL(axis->z, beta_v_1);
  const double others_0 = m_1 + m_2;
  const double others_1 = m_0 + m_2;
  const double others_2 = m_0 + m_1;
  const double alpha_v_0 = KSL_MUL(axis->x, sine);
  const double alpha_v_1 = KSL_MUL(axis->y, sine);
  const double alpha_v_2 = KSL_MUL(axis->z, sine);
  const double R_00 = 1.0 - others_0;
  const double R_01 = m_3 - alpha_v_2;
  const double R_02 = m_4 + alpha_v_1;
  const double R_10 = m_3 + alpha_v_2;
  const double R_11 = 1.0 - others_1;
  const double R_12 = m_5 - alpha_v_0;
  const double R_20 = m_4 - alpha_v_1;
  const double R_21 = m_5 + alpha_v_0;
  const double R_22 = 1.0 - others_2;
  R->m00 = R_00;
  R->m01 = R_01;
  R->m02 = R_02;
  R->m10 = R_10;
  R->m11 = R_11;
  R->m12 = R_12;
  R->m20 = R_20;
  R->m21 = R_21;
  R->m22 = R_22;
}

/* angle and axis of the rotation R; 0 <= angle <= π; the axis is (1, 0, 0) if the angle is 0.
   R: rotation or other 3×3 matrix; axis: vector.
   37 mul, 51 add, 4 div, 1 sqrt, 6 neg, 5 abs, 2 copysign, 18 less, 2 equal, 40 select.
   Error <= angle: 8 u, axis: 5 u of its largest component for R a rotation; searched, not
     proved. */
static inline double ksl_axis_angle_from_mat3x3(const ksl_mat3x3_t *R, ksl_vec3_t *axis) {
  const double p_0 = R->m21 - R->m12;
  const double p_1 = R->m02 - R->m20;
  const double p_2 = R->m10 - R->m01;
  const double s_0 = R->m12 + R->m21;
  const double s_1 = R->m02 + R->m20;
  const double s_2 = R->m01 + R->m10;
  const double first_0 = R->m00 + 1.0;
  const double first_1 = 1.0 - R->m00;
  const double others_0 = R->m11 + R->m22;
  const double others_1 = R->m11 - R->m22;
  const double d_0 = first_0 + others_0;
  const double d_1 = first_0 - others_0;
  const double d_2 = first_1 + others_1;
  const double d_3 = first_1 - others_1;
  const double low_0 = R->m11 < R->m00 ? d_1 : s_2;
  const double low_1 = R->m11 < R->m00 ? s_2 : d_2;
  const double low_2 = R->m11 < R->m00 ? s_1 : s_0;
  const double low_3 = R->m11 < R->m00 ? p_0 : p_1;
  const double high_0a = -R->m11, high_0 = R->m00 < high_0a ? s_1 : p_0;
  const double high_1 = R->m00 < high_0a ? s_0 : p_1;
  const double high_2 = R->m00 < high_0a ? d_3 : p_2;
  const double high_3 = R->m00 < high_0a ? p_2 : d_0;
  const double column_0 = R->m22 < 0.0 ? low_0 : high_0;
  const double column_1 = R->m22 < 0.0 ? low_1 : high_1;
  const double column_2 = R->m22 < 0.0 ? low_2 : high_2;
  const double column_3 = R->m22 < 0.0 ? low_3 : high_3;
  const double upper_0a = -column_0, upper_0 = column_3 < 0.0 ? upper_0a : column_0;
  const double upper_1a = -column_1, upper_1 = column_3 < 0.0 ? upper_1a : column_1;
  const double upper_2a = -column_2, upper_2 = column_3 < 0.0 ? upper_2a : column_2;
  const double upper_3a = -column_3, upper_3 = column_3 < 0.0 ? upper_3a : column_3;
  const double v_s_size_0 = fabs(upper_0);
  const double v_s_size_1 = fabs(upper_1);
  const double v_s_size_2 = fabs(upper_2);
  const double v_s_largest1 = v_s_size_0 < v_s_size_1 ? v_s_size_1 : v_s_size_0;
  const double v_s_largest2 = v_s_largest1 < v_s_size_2 ? v_s_size_2 : v_s_largest1;
  const double v_s_b = 6.703903964971299e+153 < v_s_largest2 ? 3.7291703656001034e-155 : 1.0,
      v_s_d = v_s_largest2 < 256.0 ? 1.3093562431584567e+151 : v_s_b,
      v_s = v_s_largest2 < 1.955159272639747e-149 ? 1.0715086071862673e+301 : v_s_d;
  const double v_y_0 = KSL_MUL(upper_0, v_s);
  const double v_y_1 = KSL_MUL(upper_1, v_s);
  const double v_y_2 = KSL_MUL(upper_2, v_s);
  const double v_n_a = KSL_MUL(v_y_0, v_y_0), v_n_b = KSL_MUL(v_y_1, v_y_1), v_n_c = v_n_a + v_n_b,
      v_n_d = KSL_MUL(v_y_2, v_y_2), v_n_e = v_n_c + v_n_d, v_n = sqrt(v_n_e);
  const double v_r_b = v_s < 1.0 ? 2.6815615859885194e+154 : 1.0,
      v_r_d = 1.0 < v_s ? 7.637340908749012e-152 : v_r_b,
      v_r = 1.3093562431584567e+151 < v_s ? 9.332636185032189e-302 : v_r_d;
  const double n = KSL_MUL(v_n, v_r);
  const double half = ksl_atan2(n, upper_3);
  const double divisor = v_n == 0.0 ? 1.0 : v_n;
  const double unit_0 = v_y_0 / divisor;
  const double unit_1 = v_y_1 / divisor;
  const double unit_2 = v_y_2 / divisor;
  const double angle = KSL_MUL(2.0, half);
  const double axis_0 = v_n == 0.0 ? 1.0 : unit_0;
  axis->x = axis_0;
  axis->y = unit_1;
  axis->z = unit_2;
  return angle;
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

/* Ro = w'~ + w~ w~ of a body with angular velocity w and angular acceleration w' = dw: the
     acceleration of its point x, less that of its origin, is Ro x.
   w, dw: vector; Ro: rotation or other 3×3 matrix.
   6 mul, 9 add, 3 neg.
   Error <= u |result| + 1 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_acceleration_tensorf(const ksl_vec3f_t *w, const ksl_vec3f_t *dw,
    ksl_mat3x3f_t *Ro) {
  const float ww_0 = KSL_MULF(w->x, w->x);
  const float ww_1 = KSL_MULF(w->y, w->y);
  const float ww_2 = KSL_MULF(w->z, w->z);
  const float ww_3 = KSL_MULF(w->x, w->y);
  const float ww_4 = KSL_MULF(w->x, w->z);
  const float ww_5 = KSL_MULF(w->y, w->z);
  const float Ro_00a = ww_1 + ww_2, Ro_00 = -Ro_00a;
  const float Ro_01 = ww_3 - dw->z;
  const float Ro_02 = dw->y + ww_4;
  const float Ro_10 = dw->z + ww_3;
  const float Ro_11a = ww_0 + ww_2, Ro_11 = -Ro_11a;
  const float Ro_12 = ww_5 - dw->x;
  const float Ro_20 = ww_4 - dw->y;
  const float Ro_21 = dw->x + ww_5;
  const float Ro_22a = ww_0 + ww_1, Ro_22 = -Ro_22a;
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
  const float n_0a = KSL_MULF(R->m11, R->m22), n_0b = KSL_MULF(R->m12, R->m21), n_0 = n_0a - n_0b;
  const float n_1a = KSL_MULF(R->m02, R->m21), n_1b = KSL_MULF(R->m01, R->m22), n_1 = n_1a - n_1b;
  const float n_2a = KSL_MULF(R->m01, R->m12), n_2b = KSL_MULF(R->m02, R->m11), n_2 = n_2a - n_2b;
  const float det_a = KSL_MULF(R->m00, n_0), det_b = KSL_MULF(R->m10, n_1), det_c = det_a + det_b,
      det_d = KSL_MULF(R->m20, n_2), det = det_c + det_d;
  return det;
}

/* Ro = R^-1 = adj R / det R; returns det R, which is 0 or infinite where it under- or overflows.
     Returns 0, with Ro = NaN, where R may be singular: |det R| <= 8 u p + 1e-29 m^3 (double
     1e-229 m^3), p the sum of the |terms| of det R, m the largest |entry|.
   R, Ro: rotation or other 3×3 matrix.
   56 mul, 17 add, 9 div, 1 neg, 19 abs, 16 less, 1 equal, 32 select.
   Error of Ro_ij <= 2 u m_ji / |det R| + 6 u |Ro_ij| p / |det R|, m_ji the sum of the |terms| of
     the cofactor, or 2^-80 m^2 (double 2^-700 m^2) if that is more; barring over- and underflow
     of Ro_ij itself. */
static inline float ksl_mat3x3f_inverse(const ksl_mat3x3f_t *R, ksl_mat3x3f_t *Ro) {
  const float R_size_0 = fabsf(R->m00);
  const float R_size_1 = fabsf(R->m01);
  const float R_size_2 = fabsf(R->m02);
  const float R_size_3 = fabsf(R->m10);
  const float R_size_4 = fabsf(R->m11);
  const float R_size_5 = fabsf(R->m12);
  const float R_size_6 = fabsf(R->m20);
  const float R_size_7 = fabsf(R->m21);
  const float R_size_8 = fabsf(R->m22);
  const float R_largest1 = R_size_0 < R_size_1 ? R_size_1 : R_size_0;
  const float R_largest2 = R_largest1 < R_size_2 ? R_size_2 : R_largest1;
  const float R_largest3 = R_largest2 < R_size_3 ? R_size_3 : R_largest2;
  const float R_largest4 = R_largest3 < R_size_4 ? R_size_4 : R_largest3;
  const float R_largest5 = R_largest4 < R_size_5 ? R_size_5 : R_largest4;
  const float R_largest6 = R_largest5 < R_size_6 ? R_size_6 : R_largest5;
  const float R_largest7 = R_largest6 < R_size_7 ? R_size_7 : R_largest6;
  const float R_largest8 = R_largest7 < R_size_8 ? R_size_8 : R_largest7;
  const float s_b = R_largest8 < 1.329228e+36f ? 8.271806e-25f : 7.523164e-37f,
      s_d = R_largest8 < 1.2089258e+24f ? 9.094947e-13f : s_b,
      s_f = R_largest8 < 1.0995116e+12f ? 1.0f : s_d,
      s_h = R_largest8 < 1.0f ? 1.0995116e+12f : s_f,
      s_j = R_largest8 < 9.094947e-13f ? 1.2089258e+24f : s_h,
      s = R_largest8 < 8.271806e-25f ? 1.329228e+36f : s_j;
  const float A_0 = KSL_MULF(R->m00, s);
  const float A_1 = KSL_MULF(R->m01, s);
  const float A_2 = KSL_MULF(R->m02, s);
  const float A_3 = KSL_MULF(R->m10, s);
  const float A_4 = KSL_MULF(R->m11, s);
  const float A_5 = KSL_MULF(R->m12, s);
  const float A_6 = KSL_MULF(R->m20, s);
  const float A_7 = KSL_MULF(R->m21, s);
  const float A_8 = KSL_MULF(R->m22, s);
  const float n0_0a = KSL_MULF(A_4, A_8), n0_0b = KSL_MULF(A_5, A_7), n0_0 = n0_0a - n0_0b;
  const float n0_1a = KSL_MULF(A_2, A_7), n0_1b = KSL_MULF(A_1, A_8), n0_1 = n0_1a - n0_1b;
  const float n0_2a = KSL_MULF(A_1, A_5), n0_2b = KSL_MULF(A_2, A_4), n0_2 = n0_2a - n0_2b;
  const float n1_0a = KSL_MULF(A_5, A_6), n1_0b = KSL_MULF(A_3, A_8), n1_0 = n1_0a - n1_0b;
  const float n1_1a = KSL_MULF(A_0, A_8), n1_1b = KSL_MULF(A_2, A_6), n1_1 = n1_1a - n1_1b;
  const float n1_2a = KSL_MULF(A_2, A_3), n1_2b = KSL_MULF(A_0, A_5), n1_2 = n1_2a - n1_2b;
  const float n2_0a = KSL_MULF(A_3, A_7), n2_0b = KSL_MULF(A_4, A_6), n2_0 = n2_0a - n2_0b;
  const float n2_1a = KSL_MULF(A_1, A_6), n2_1b = KSL_MULF(A_0, A_7), n2_1 = n2_1a - n2_1b;
  const float n2_2a = KSL_MULF(A_0, A_4), n2_2b = KSL_MULF(A_1, A_3), n2_2 = n2_2a - n2_2b;
  const float d_a = KSL_MULF(A_0, n0_0), d_b = KSL_MULF(A_3, n0_1), d_c = d_a + d_b,
      d_d = KSL_MULF(A_6, n0_2), d = d_c + d_d;
  const float size0_0 = fabsf(A_0);
  const float size0_1 = fabsf(A_3);
  const float size0_2 = fabsf(A_6);
  const float size1_0 = fabsf(A_1);
  const float size1_1 = fabsf(A_4);
  const float size1_2 = fabsf(A_7);
  const float size2_0 = fabsf(A_2);
  const float size2_1 = fabsf(A_5);
  const float size2_2 = fabsf(A_8);
  const float permanent_a = KSL_MULF(size1_1, size2_2), permanent_b = KSL_MULF(size1_2, size2_1),
      permanent_c = permanent_a + permanent_b, permanent_d = KSL_MULF(size0_0, permanent_c),
      permanent_e = KSL_MULF(size1_0, size2_2), permanent_f = KSL_MULF(size1_2, size2_0),
      permanent_g = permanent_e + permanent_f, permanent_h = KSL_MULF(size0_1, permanent_g),
      permanent_i = permanent_d + permanent_h, permanent_j = KSL_MULF(size1_0, size2_1),
      permanent_k = KSL_MULF(size1_1, size2_0), permanent_l = permanent_j + permanent_k,
      permanent_m = KSL_MULF(size0_2, permanent_l), permanent = permanent_i + permanent_m;
  const float top = KSL_MULF(R_largest8, s);
  const float spoiled = KSL_MULF(top, 1.2621775e-29f);
  const float least_a = KSL_MULF(permanent, 4.7683716e-07f), least_b = KSL_MULF(top, top),
      least_c = KSL_MULF(spoiled, least_b), least = least_a + least_c;
  const float regular_a = fabsf(d), regular = least < regular_a ? 1.0f : 0.0f;
  const float divisor = regular == 1.0f ? d : 1.0f;
  const float quotient_0 = n0_0 / divisor;
  const float quotient_1 = n0_1 / divisor;
  const float quotient_2 = n0_2 / divisor;
  const float quotient_3 = n1_0 / divisor;
  const float quotient_4 = n1_1 / divisor;
  const float quotient_5 = n1_2 / divisor;
  const float quotient_6 = n2_0 / divisor;
  const float quotient_7 = n2_1 / divisor;
  const float quotient_8 = n2_2 / divisor;
  const float inverse_0 = KSL_MULF(quotient_0, s);
  const float inverse_1 = KSL_MULF(quotient_1, s);
  const float inverse_2 = KSL_MULF(quotient_2, s);
  const float inverse_3 = KSL_MULF(quotient_3, s);
  const float inverse_4 = KSL_MULF(quotient_4, s);
  const float inverse_5 = KSL_MULF(quotient_5, s);
  const float inverse_6 = KSL_MULF(quotient_6, s);
  const float inverse_7 = KSL_MULF(quotient_7, s);
  const float inverse_8 = KSL_MULF(quotient_8, s);
  const float start_a = -1.329228e+36f, start_c = d < 0.0f ? start_a : 1.329228e+36f,
      start = R_largest8 < 1.2089258e+24f ? d : start_c;
  const float r2 = R_largest8 < 9.094947e-13f ? 7.523164e-37f : 1.0f;
  const float once = KSL_MULF(start, r2);
  const float r3 = R_largest8 < 8.271806e-25f ? 7.523164e-37f : 1.0f;
  const float twice = KSL_MULF(once, r3);
  const float r_a = R_largest8 < 1.0995116e+12f ? 1.0f : 1.329228e+36f,
      r = R_largest8 < 1.0f ? 7.523164e-37f : r_a;
  const float det_R = KSL_MULF(twice, r);
  const float det = regular == 1.0f ? det_R : 0.0f;
  const float Ro_00 = regular == 1.0f ? inverse_0 : (float)NAN;
  const float Ro_01 = regular == 1.0f ? inverse_1 : (float)NAN;
  const float Ro_02 = regular == 1.0f ? inverse_2 : (float)NAN;
  const float Ro_10 = regular == 1.0f ? inverse_3 : (float)NAN;
  const float Ro_11 = regular == 1.0f ? inverse_4 : (float)NAN;
  const float Ro_12 = regular == 1.0f ? inverse_5 : (float)NAN;
  const float Ro_20 = regular == 1.0f ? inverse_6 : (float)NAN;
  const float Ro_21 = regular == 1.0f ? inverse_7 : (float)NAN;
  const float Ro_22 = regular == 1.0f ? inverse_8 : (float)NAN;
  Ro->m00 = Ro_00;
  Ro->m01 = Ro_01;
  Ro->m02 = Ro_02;
  Ro->m10 = Ro_10;
  Ro->m11 = Ro_11;
  Ro->m12 = Ro_12;
  Ro->m20 = Ro_20;
  Ro->m21 = Ro_21;
  Ro->m22 = Ro_22;
  return det;
}

/* self = orthonormal rows by Gram–Schmidt: the first keeps its direction, the second stays on
     its side of the first, the third on its side of both; NaN where the rows are linearly
     dependent to rounding.
   self: rotation or other 3×3 matrix.
   60 mul, 23 add, 12 div, 4 sqrt, 3 neg, 10 abs, 24 less, 5 equal, 39 select.
   |R R^T - I|_ij <= 8 u for the result R; searched, not proved. */
static inline void ksl_mat3x3f_normalize(ksl_mat3x3f_t *self) {
  const float q0_s_size_0 = fabsf(self->m00);
  const float q0_s_size_1 = fabsf(self->m01);
  const float q0_s_size_2 = fabsf(self->m02);
  const float q0_s_largest1 = q0_s_size_0 < q0_s_size_1 ? q0_s_size_1 : q0_s_size_0;
  const float q0_s_largest2 = q0_s_largest1 < q0_s_size_2 ? q0_s_size_2 : q0_s_largest1;
  const float q0_s_b = 4.611686e+18f < q0_s_largest2 ? 2.7105054e-20f : 1.0f,
      q0_s_d = q0_s_largest2 < 256.0f ? 1.8014399e+16f : q0_s_b,
      q0_s = q0_s_largest2 < 1.4210855e-14f ? 3.2451855e+32f : q0_s_d;
  const float q0_y_0 = KSL_MULF(self->m00, q0_s);
  const float q0_y_1 = KSL_MULF(self->m01, q0_s);
  const float q0_y_2 = KSL_MULF(self->m02, q0_s);
  const float q0_up = 1.0f < q0_s ? q0_s : 1.0f;
  const float q0_down = q0_s < 1.0f ? q0_s : 1.0f;
  const float q0_n_a = KSL_MULF(q0_y_0, q0_y_0), q0_n_b = KSL_MULF(q0_y_1, q0_y_1),
      q0_n_c = q0_n_a + q0_n_b, q0_n_d = KSL_MULF(q0_y_2, q0_y_2), q0_n_e = q0_n_c + q0_n_d,
      q0_n = sqrtf(q0_n_e);
  const float q0_divisor = q0_n == 0.0f ? q0_up : q0_n;
  const float q0_sized_0 = KSL_MULF(self->m00, q0_up);
  const float q0_sized_1 = KSL_MULF(self->m01, q0_up);
  const float q0_sized_2 = KSL_MULF(self->m02, q0_up);
  const float q0_quotient_0 = q0_sized_0 / q0_divisor;
  const float q0_quotient_1 = q0_sized_1 / q0_divisor;
  const float q0_quotient_2 = q0_sized_2 / q0_divisor;
  const float q0_0 = KSL_MULF(q0_quotient_0, q0_down);
  const float q0_1 = KSL_MULF(q0_quotient_1, q0_down);
  const float q0_2 = KSL_MULF(q0_quotient_2, q0_down);
  const float u1_s_size_0 = fabsf(self->m10);
  const float u1_s_size_1 = fabsf(self->m11);
  const float u1_s_size_2 = fabsf(self->m12);
  const float u1_s_largest1 = u1_s_size_0 < u1_s_size_1 ? u1_s_size_1 : u1_s_size_0;
  const float u1_s_largest2 = u1_s_largest1 < u1_s_size_2 ? u1_s_size_2 : u1_s_largest1;
  const float u1_s_b = 4.611686e+18f < u1_s_largest2 ? 2.7105054e-20f : 1.0f,
      u1_s_d = u1_s_largest2 < 256.0f ? 1.8014399e+16f : u1_s_b,
      u1_s = u1_s_largest2 < 1.4210855e-14f ? 3.2451855e+32f : u1_s_d;
  const float u1_y_0 = KSL_MULF(self->m10, u1_s);
  const float u1_y_1 = KSL_MULF(self->m11, u1_s);
  const float u1_y_2 = KSL_MULF(self->m12, u1_s);
  const float u1_up = 1.0f < u1_s ? u1_s : 1.0f;
  const float u1_down = u1_s < 1.0f ? u1_s : 1.0f;
  const float u1_n_a = KSL_MULF(u1_y_0, u1_y_0), u1_n_b = KSL_MULF(u1_y_1, u1_y_1),
      u1_n_c = u1_n_a + u1_n_b, u1_n_d = KSL_MULF(u1_y_2, u1_y_2), u1_n_e = u1_n_c + u1_n_d,
      u1_n = sqrtf(u1_n_e);
  const float u1_divisor = u1_n == 0.0f ? u1_up : u1_n;
  const float u1_sized_0 = KSL_MULF(self->m10, u1_up);
  const float u1_sized_1 = KSL_MULF(self->m11, u1_up);
  const float u1_sized_2 = KSL_MULF(self->m12, u1_up);
  const float u1_quotient_0 = u1_sized_0 / u1_divisor;
  const float u1_quotient_1 = u1_sized_1 / u1_divisor;
  const float u1_quotient_2 = u1_sized_2 / u1_divisor;
  const float u1_0 = KSL_MULF(u1_quotient_0, u1_down);
  const float u1_1 = KSL_MULF(u1_quotient_1, u1_down);
  const float u1_2 = KSL_MULF(u1_quotient_2, u1_down);
  const float along_a = KSL_MULF(q0_0, u1_0), along_b = KSL_MULF(q0_1, u1_1),
      along_c = along_a + along_b, along_d = KSL_MULF(q0_2, u1_2), along = along_c + along_d;
  const float once_0a = KSL_MULF(q0_0, along), once_0 = u1_0 - once_0a;
  const float once_1a = KSL_MULF(q0_1, along), once_1 = u1_1 - once_1a;
  const float once_2a = KSL_MULF(q0_2, along), once_2 = u1_2 - once_2a;
  const float rest_a = KSL_MULF(q0_0, once_0), rest_b = KSL_MULF(q0_1, once_1),
      rest_c = rest_a + rest_b, rest_d = KSL_MULF(q0_2, once_2), rest = rest_c + rest_d;
  const float twice_0a = KSL_MULF(q0_0, rest), twice_0 = once_0 - twice_0a;
  const float twice_1a = KSL_MULF(q0_1, rest), twice_1 = once_1 - twice_1a;
  const float twice_2a = KSL_MULF(q0_2, rest), twice_2 = once_2 - twice_2a;
  const float n_a = KSL_MULF(twice_0, twice_0), n_b = KSL_MULF(twice_1, twice_1), n_c = n_a + n_b,
      n_d = KSL_MULF(twice_2, twice_2), n_e = n_c + n_d, n = sqrtf(n_e);
  const float divisor = n == 0.0f ? 1.0f : n;
  const float q1_0 = twice_0 / divisor;
  const float q1_1 = twice_1 / divisor;
  const float q1_2 = twice_2 / divisor;
  const float normal_0a = KSL_MULF(q0_1, q1_2), normal_0b = KSL_MULF(q0_2, q1_1),
      normal_0 = normal_0a - normal_0b;
  const float normal_1a = KSL_MULF(q0_2, q1_0), normal_1b = KSL_MULF(q0_0, q1_2),
      normal_1 = normal_1a - normal_1b;
  const float normal_2a = KSL_MULF(q0_0, q1_1), normal_2b = KSL_MULF(q0_1, q1_0),
      normal_2 = normal_2a - normal_2b;
  const float u2_s_size_0 = fabsf(self->m20);
  const float u2_s_size_1 = fabsf(self->m21);
  const float u2_s_size_2 = fabsf(self->m22);
  const float u2_s_largest1 = u2_s_size_0 < u2_s_size_1 ? u2_s_size_1 : u2_s_size_0;
  const float u2_s_largest2 = u2_s_largest1 < u2_s_size_2 ? u2_s_size_2 : u2_s_largest1;
  const float u2_s_b = 4.611686e+18f < u2_s_largest2 ? 2.7105054e-20f : 1.0f,
      u2_s_d = u2_s_largest2 < 256.0f ? 1.8014399e+16f : u2_s_b,
      u2_s = u2_s_largest2 < 1.4210855e-14f ? 3.2451855e+32f : u2_s_d;
  const float u2_y_0 = KSL_MULF(self->m20, u2_s);
  const float u2_y_1 = KSL_MULF(self->m21, u2_s);
  const float u2_y_2 = KSL_MULF(self->m22, u2_s);
  const float u2_up = 1.0f < u2_s ? u2_s : 1.0f;
  const float u2_down = u2_s < 1.0f ? u2_s : 1.0f;
  const float u2_n_a = KSL_MULF(u2_y_0, u2_y_0), u2_n_b = KSL_MULF(u2_y_1, u2_y_1),
      u2_n_c = u2_n_a + u2_n_b, u2_n_d = KSL_MULF(u2_y_2, u2_y_2), u2_n_e = u2_n_c + u2_n_d,
      u2_n = sqrtf(u2_n_e);
  const float u2_divisor = u2_n == 0.0f ? u2_up : u2_n;
  const float u2_sized_0 = KSL_MULF(self->m20, u2_up);
  const float u2_sized_1 = KSL_MULF(self->m21, u2_up);
  const float u2_sized_2 = KSL_MULF(self->m22, u2_up);
  const float u2_quotient_0 = u2_sized_0 / u2_divisor;
  const float u2_quotient_1 = u2_sized_1 / u2_divisor;
  const float u2_quotient_2 = u2_sized_2 / u2_divisor;
  const float u2_0 = KSL_MULF(u2_quotient_0, u2_down);
  const float u2_1 = KSL_MULF(u2_quotient_1, u2_down);
  const float u2_2 = KSL_MULF(u2_quotient_2, u2_down);
  const float side_a = KSL_MULF(normal_0, u2_0), side_b = KSL_MULF(normal_1, u2_1),
      side_c = side_a + side_b, side_d = KSL_MULF(normal_2, u2_2), side = side_c + side_d;
  const float q2_0a = -normal_0, q2_0 = side < 0.0f ? q2_0a : normal_0;
  const float q2_1a = -normal_1, q2_1 = side < 0.0f ? q2_1a : normal_1;
  const float q2_2a = -normal_2, q2_2 = side < 0.0f ? q2_2a : normal_2;
  const float size = fabsf(side);
  const float less = n < size ? n : size;
  const float dependent = less < 9.536743e-07f ? 1.0f : 0.0f;
  const float self_00_new = dependent == 1.0f ? (float)NAN : q0_0;
  const float self_01_new = dependent == 1.0f ? (float)NAN : q0_1;
  const float self_02_new = dependent == 1.0f ? (float)NAN : q0_2;
  const float self_10_new = dependent == 1.0f ? (float)NAN : q1_0;
  const float self_11_new = dependent == 1.0f ? (float)NAN : q1_1;
  const float self_12_new = dependent == 1.0f ? (float)NAN : q1_2;
  const float self_20_new = dependent == 1.0f ? (float)NAN : q2_0;
  const float self_21_new = dependent == 1.0f ? (float)NAN : q2_1;
  const float self_22_new = dependent == 1.0f ? (float)NAN : q2_2;
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

/* Ro = orthonormal rows by Gram–Schmidt: the first keeps its direction, the second stays on its
     side of the first, the third on its side of both; NaN where the rows are linearly dependent
     to rounding.
   R, Ro: rotation or other 3×3 matrix.
   60 mul, 23 add, 12 div, 4 sqrt, 3 neg, 10 abs, 24 less, 5 equal, 39 select.
   |R R^T - I|_ij <= 8 u for the result R; searched, not proved. */
static inline void ksl_mat3x3f_normalized(const ksl_mat3x3f_t *R, ksl_mat3x3f_t *Ro) {
  const float q0_s_size_0 = fabsf(R->m00);
  const float q0_s_size_1 = fabsf(R->m01);
  const float q0_s_size_2 = fabsf(R->m02);
  const float q0_s_largest1 = q0_s_size_0 < q0_s_size_1 ? q0_s_size_1 : q0_s_size_0;
  const float q0_s_largest2 = q0_s_largest1 < q0_s_size_2 ? q0_s_size_2 : q0_s_largest1;
  const float q0_s_b = 4.611686e+18f < q0_s_largest2 ? 2.7105054e-20f : 1.0f,
      q0_s_d = q0_s_largest2 < 256.0f ? 1.8014399e+16f : q0_s_b,
      q0_s = q0_s_largest2 < 1.4210855e-14f ? 3.2451855e+32f : q0_s_d;
  const float q0_y_0 = KSL_MULF(R->m00, q0_s);
  const float q0_y_1 = KSL_MULF(R->m01, q0_s);
  const float q0_y_2 = KSL_MULF(R->m02, q0_s);
  const float q0_up = 1.0f < q0_s ? q0_s : 1.0f;
  const float q0_down = q0_s < 1.0f ? q0_s : 1.0f;
  const float q0_n_a = KSL_MULF(q0_y_0, q0_y_0), q0_n_b = KSL_MULF(q0_y_1, q0_y_1),
      q0_n_c = q0_n_a + q0_n_b, q0_n_d = KSL_MULF(q0_y_2, q0_y_2), q0_n_e = q0_n_c + q0_n_d,
      q0_n = sqrtf(q0_n_e);
  const float q0_divisor = q0_n == 0.0f ? q0_up : q0_n;
  const float q0_sized_0 = KSL_MULF(R->m00, q0_up);
  const float q0_sized_1 = KSL_MULF(R->m01, q0_up);
  const float q0_sized_2 = KSL_MULF(R->m02, q0_up);
  const float q0_quotient_0 = q0_sized_0 / q0_divisor;
  const float q0_quotient_1 = q0_sized_1 / q0_divisor;
  const float q0_quotient_2 = q0_sized_2 / q0_divisor;
  const float q0_0 = KSL_MULF(q0_quotient_0, q0_down);
  const float q0_1 = KSL_MULF(q0_quotient_1, q0_down);
  const float q0_2 = KSL_MULF(q0_quotient_2, q0_down);
  const float u1_s_size_0 = fabsf(R->m10);
  const float u1_s_size_1 = fabsf(R->m11);
  const float u1_s_size_2 = fabsf(R->m12);
  const float u1_s_largest1 = u1_s_size_0 < u1_s_size_1 ? u1_s_size_1 : u1_s_size_0;
  const float u1_s_largest2 = u1_s_largest1 < u1_s_size_2 ? u1_s_size_2 : u1_s_largest1;
  const float u1_s_b = 4.611686e+18f < u1_s_largest2 ? 2.7105054e-20f : 1.0f,
      u1_s_d = u1_s_largest2 < 256.0f ? 1.8014399e+16f : u1_s_b,
      u1_s = u1_s_largest2 < 1.4210855e-14f ? 3.2451855e+32f : u1_s_d;
  const float u1_y_0 = KSL_MULF(R->m10, u1_s);
  const float u1_y_1 = KSL_MULF(R->m11, u1_s);
  const float u1_y_2 = KSL_MULF(R->m12, u1_s);
  const float u1_up = 1.0f < u1_s ? u1_s : 1.0f;
  const float u1_down = u1_s < 1.0f ? u1_s : 1.0f;
  const float u1_n_a = KSL_MULF(u1_y_0, u1_y_0), u1_n_b = KSL_MULF(u1_y_1, u1_y_1),
      u1_n_c = u1_n_a + u1_n_b, u1_n_d = KSL_MULF(u1_y_2, u1_y_2), u1_n_e = u1_n_c + u1_n_d,
      u1_n = sqrtf(u1_n_e);
  const float u1_divisor = u1_n == 0.0f ? u1_up : u1_n;
  const float u1_sized_0 = KSL_MULF(R->m10, u1_up);
  const float u1_sized_1 = KSL_MULF(R->m11, u1_up);
  const float u1_sized_2 = KSL_MULF(R->m12, u1_up);
  const float u1_quotient_0 = u1_sized_0 / u1_divisor;
  const float u1_quotient_1 = u1_sized_1 / u1_divisor;
  const float u1_quotient_2 = u1_sized_2 / u1_divisor;
  const float u1_0 = KSL_MULF(u1_quotient_0, u1_down);
  const float u1_1 = KSL_MULF(u1_quotient_1, u1_down);
  const float u1_2 = KSL_MULF(u1_quotient_2, u1_down);
  const float along_a = KSL_MULF(q0_0, u1_0), along_b = KSL_MULF(q0_1, u1_1),
      along_c = along_a + along_b, along_d = KSL_MULF(q0_2, u1_2), along = along_c + along_d;
  const float once_0a = KSL_MULF(q0_0, along), once_0 = u1_0 - once_0a;
  const float once_1a = KSL_MULF(q0_1, along), once_1 = u1_1 - once_1a;
  const float once_2a = KSL_MULF(q0_2, along), once_2 = u1_2 - once_2a;
  const float rest_a = KSL_MULF(q0_0, once_0), rest_b = KSL_MULF(q0_1, once_1),
      rest_c = rest_a + rest_b, rest_d = KSL_MULF(q0_2, once_2), rest = rest_c + rest_d;
  const float twice_0a = KSL_MULF(q0_0, rest), twice_0 = once_0 - twice_0a;
  const float twice_1a = KSL_MULF(q0_1, rest), twice_1 = once_1 - twice_1a;
  const float twice_2a = KSL_MULF(q0_2, rest), twice_2 = once_2 - twice_2a;
  const float n_a = KSL_MULF(twice_0, twice_0), n_b = KSL_MULF(twice_1, twice_1), n_c = n_a + n_b,
      n_d = KSL_MULF(twice_2, twice_2), n_e = n_c + n_d, n = sqrtf(n_e);
  const float divisor = n == 0.0f ? 1.0f : n;
  const float q1_0 = twice_0 / divisor;
  const float q1_1 = twice_1 / divisor;
  const float q1_2 = twice_2 / divisor;
  const float normal_0a = KSL_MULF(q0_1, q1_2), normal_0b = KSL_MULF(q0_2, q1_1),
      normal_0 = normal_0a - normal_0b;
  const float normal_1a = KSL_MULF(q0_2, q1_0), normal_1b = KSL_MULF(q0_0, q1_2),
      normal_1 = normal_1a - normal_1b;
  const float normal_2a = KSL_MULF(q0_0, q1_1), normal_2b = KSL_MULF(q0_1, q1_0),
      normal_2 = normal_2a - normal_2b;
  const float u2_s_size_0 = fabsf(R->m20);
  const float u2_s_size_1 = fabsf(R->m21);
  const float u2_s_size_2 = fabsf(R->m22);
  const float u2_s_largest1 = u2_s_size_0 < u2_s_size_1 ? u2_s_size_1 : u2_s_size_0;
  const float u2_s_largest2 = u2_s_largest1 < u2_s_size_2 ? u2_s_size_2 : u2_s_largest1;
  const float u2_s_b = 4.611686e+18f < u2_s_largest2 ? 2.7105054e-20f : 1.0f,
      u2_s_d = u2_s_largest2 < 256.0f ? 1.8014399e+16f : u2_s_b,
      u2_s = u2_s_largest2 < 1.4210855e-14f ? 3.2451855e+32f : u2_s_d;
  const float u2_y_0 = KSL_MULF(R->m20, u2_s);
  const float u2_y_1 = KSL_MULF(R->m21, u2_s);
  const float u2_y_2 = KSL_MULF(R->m22, u2_s);
  const float u2_up = 1.0f < u2_s ? u2_s : 1.0f;
  const float u2_down = u2_s < 1.0f ? u2_s : 1.0f;
  const float u2_n_a = KSL_MULF(u2_y_0, u2_y_0), u2_n_b = KSL_MULF(u2_y_1, u2_y_1),
      u2_n_c = u2_n_a + u2_n_b, u2_n_d = KSL_MULF(u2_y_2, u2_y_2), u2_n_e = u2_n_c + u2_n_d,
      u2_n = sqrtf(u2_n_e);
  const float u2_divisor = u2_n == 0.0f ? u2_up : u2_n;
  const float u2_sized_0 = KSL_MULF(R->m20, u2_up);
  const float u2_sized_1 = KSL_MULF(R->m21, u2_up);
  const float u2_sized_2 = KSL_MULF(R->m22, u2_up);
  const float u2_quotient_0 = u2_sized_0 / u2_divisor;
  const float u2_quotient_1 = u2_sized_1 / u2_divisor;
  const float u2_quotient_2 = u2_sized_2 / u2_divisor;
  const float u2_0 = KSL_MULF(u2_quotient_0, u2_down);
  const float u2_1 = KSL_MULF(u2_quotient_1, u2_down);
  const float u2_2 = KSL_MULF(u2_quotient_2, u2_down);
  const float side_a = KSL_MULF(normal_0, u2_0), side_b = KSL_MULF(normal_1, u2_1),
      side_c = side_a + side_b, side_d = KSL_MULF(normal_2, u2_2), side = side_c + side_d;
  const float q2_0a = -normal_0, q2_0 = side < 0.0f ? q2_0a : normal_0;
  const float q2_1a = -normal_1, q2_1 = side < 0.0f ? q2_1a : normal_1;
  const float q2_2a = -normal_2, q2_2 = side < 0.0f ? q2_2a : normal_2;
  const float size = fabsf(side);
  const float less = n < size ? n : size;
  const float dependent = less < 9.536743e-07f ? 1.0f : 0.0f;
  const float Ro_00 = dependent == 1.0f ? (float)NAN : q0_0;
  const float Ro_01 = dependent == 1.0f ? (float)NAN : q0_1;
  const float Ro_02 = dependent == 1.0f ? (float)NAN : q0_2;
  const float Ro_10 = dependent == 1.0f ? (float)NAN : q1_0;
  const float Ro_11 = dependent == 1.0f ? (float)NAN : q1_1;
  const float Ro_12 = dependent == 1.0f ? (float)NAN : q1_2;
  const float Ro_20 = dependent == 1.0f ? (float)NAN : q2_0;
  const float Ro_21 = dependent == 1.0f ? (float)NAN : q2_1;
  const float Ro_22 = dependent == 1.0f ? (float)NAN : q2_2;
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

/* R = cos θ I + sin θ a~ + (1 - cos θ) a a^T, a = axis of length 1 (else R is not a rotation),
     dc = (sin θ, cos θ).
   R: rotation or other 3×3 matrix; axis: vector; dc: (sin θ, cos θ).
   12 mul, 10 add.
   Error <= u |result| + 3 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_mat3x3f_setFromAxisDC(ksl_mat3x3f_t *R, const ksl_vec3f_t *axis,
    const float dc[2]) {
  const float versine = 1.0f - dc[1];
  const float versine_axis_0 = KSL_MULF(axis->x, versine);
  const float versine_axis_1 = KSL_MULF(axis->y, versine);
  const float versine_axis_2 = KSL_MULF(axis->z, versine);
  const float m_0 = KSL_MULF(axis->x, versine_axis_0);
  const float m_1 = KSL_MULF(axis->y, versine_axis_1);
  const float m_2 = KSL_MULF(axis->z, versine_axis_2);
  const float m_3 = KSL_MULF(axis->y, versine_axis_0);
  const float m_4 = KSL_MULF(axis->z, versine_axis_0);
  const float m_5 = KSL_MULF(axis->z, versine_axis_1);
  const float sine_axis_0 = KSL_MULF(axis->x, dc[0]);
  const float sine_axis_1 = KSL_MULF(axis->y, dc[0]);
  const float sine_axis_2 = KSL_MULF(axis->z, dc[0]);
  const float R_00 = dc[1] + m_0;
  const float R_01 = m_3 - sine_axis_2;
  const float R_02 = m_4 + sine_axis_1;
  const float R_10 = m_3 + sine_axis_2;
  const float R_11 = dc[1] + m_1;
  const float R_12 = m_5 - sine_axis_0;
  const float R_20 = m_4 - sine_axis_1;
  const float R_21 = m_5 + sine_axis_0;
  const float R_22 = dc[1] + m_2;
  R->m00 = R_00;
  R->m01 = R_01;
  R->m02 = R_02;
  R->m10 = R_10;
  R->m11 = R_11;
  R->m12 = R_12;
  R->m20 = R_20;
  R->m21 = R_21;
  R->m22 = R_22;
}

/* R = R_x(a) R_y(b) R_z(c), angles = (a, b, c).
   angles: vector; R: rotation or other 3×3 matrix.
   80 mul, 85 add, 3 neg, 3 abs. */
static inline void ksl_mat3x3f_from_euler_xyz(const ksl_vec3f_t *angles, ksl_mat3x3f_t *R) {
  float c_0; const float s_0 = ksl_sincosf(angles->x, &c_0);
  float c_1; const float s_1 = ksl_sincosf(angles->y, &c_1);
  float c_2; const float s_2 = ksl_sincosf(angles->z, &c_2);
  const float first_0 = KSL_MULF(c_1, c_2);
  const float first_1a = KSL_MULF(s_2, c_1), first_1 = -first_1a;
  const float first_6a = KSL_MULF(s_1, c_2), first_6 = -first_6a;
  const float first_7 = KSL_MULF(s_1, s_2);
  const float last_3a = KSL_MULF(s_2, c_0), last_3b = KSL_MULF(s_0, first_6),
      last_3 = last_3a - last_3b;
  const float last_4a = KSL_MULF(c_0, c_2), last_4b = KSL_MULF(s_0, first_7),
      last_4 = last_4a - last_4b;
  const float last_5a = KSL_MULF(s_0, c_1), last_5 = -last_5a;
  const float last_6a = KSL_MULF(s_0, s_2), last_6b = KSL_MULF(c_0, first_6),
      last_6 = last_6a + last_6b;
  const float last_7a = KSL_MULF(s_0, c_2), last_7b = KSL_MULF(c_0, first_7),
      last_7 = last_7a + last_7b;
  const float last_8 = KSL_MULF(c_0, c_1);
  R->m00 = first_0;
  R->m01 = first_1;
  R->m02 = s_1;
  R->m10 = last_3;
  R->m11 = last_4;
  R->m12 = last_5;
  R->m20 = last_6;
  R->m21 = last_7;
  R->m22 = last_8;
}

/* angles of the rotation R = R_x(a) R_y(b) R_z(c), angles = (a, b, c); a, c in [-π, π], b in
     [-π/2, π/2]; c = 0 in gimbal lock.
   R: rotation or other 3×3 matrix; angles: vector.
   72 mul, 90 add, 5 div, 1 sqrt, 4 neg, 6 abs, 6 copysign, 18 less, 4 equal, 45 select.
   The rotation by these angles differs from R by at most 12 u in each entry, near gimbal lock
     too; searched, not proved. */
static inline void ksl_euler_xyz_from_mat3x3f(const ksl_mat3x3f_t *R, ksl_vec3f_t *angles) {
  const float n_a = KSL_MULF(R->m00, R->m00), n_b = KSL_MULF(R->m01, R->m01), n_c = n_a + n_b,
      n = sqrtf(n_c);
  const float divisor = n == 0.0f ? 1.0f : n;
  const float cosine_a = R->m00 / divisor, cosine = n == 0.0f ? 1.0f : cosine_a;
  const float sine_a = -R->m01, sine = sine_a / divisor;
  const float polar = ksl_atan2f(sine_a, R->m00);
  const float third = n == 0.0f ? 0.0f : polar;
  const float left_1a = KSL_MULF(R->m10, sine), left_1b = KSL_MULF(R->m11, cosine),
      left_1 = left_1a + left_1b;
  const float left_2a = KSL_MULF(R->m20, sine), left_2b = KSL_MULF(R->m21, cosine),
      left_2 = left_2a + left_2b;
  const float angles_0 = ksl_atan2f(left_2, left_1);
  const float angles_1 = ksl_atan2f(R->m02, n);
  angles->x = angles_0;
  angles->y = angles_1;
  angles->z = third;
}

/* R = R_x(a) R_y(b) R_x(c), angles = (a, b, c).
   angles: vector; R: rotation or other 3×3 matrix.
   80 mul, 85 add, 2 neg, 3 abs. */
static inline void ksl_mat3x3f_from_euler_xyx(const ksl_vec3f_t *angles, ksl_mat3x3f_t *R) {
  float c_0; const float s_0 = ksl_sincosf(angles->x, &c_0);
  float c_1; const float s_1 = ksl_sincosf(angles->y, &c_1);
  float c_2; const float s_2 = ksl_sincosf(angles->z, &c_2);
  const float first_1 = KSL_MULF(s_1, s_2);
  const float first_2 = KSL_MULF(s_1, c_2);
  const float first_7 = KSL_MULF(s_2, c_1);
  const float first_8 = KSL_MULF(c_1, c_2);
  const float last_3 = KSL_MULF(s_0, s_1);
  const float last_4a = KSL_MULF(c_0, c_2), last_4b = KSL_MULF(s_0, first_7),
      last_4 = last_4a - last_4b;
  const float last_5a = KSL_MULF(s_0, first_8), last_5b = KSL_MULF(s_2, c_0),
      last_5c = last_5a + last_5b, last_5 = -last_5c;
  const float last_6a = KSL_MULF(s_1, c_0), last_6 = -last_6a;
  const float last_7a = KSL_MULF(s_0, c_2), last_7b = KSL_MULF(c_0, first_7),
      last_7 = last_7a + last_7b;
  const float last_8a = KSL_MULF(c_0, first_8), last_8b = KSL_MULF(s_0, s_2),
      last_8 = last_8a - last_8b;
  R->m00 = c_1;
  R->m01 = first_1;
  R->m02 = first_2;
  R->m10 = last_3;
  R->m11 = last_4;
  R->m12 = last_5;
  R->m20 = last_6;
  R->m21 = last_7;
  R->m22 = last_8;
}

/* angles of the rotation R = R_x(a) R_y(b) R_x(c), angles = (a, b, c); a, c in [-π, π], b in [0,
     π]; c = 0 in gimbal lock.
   R: rotation or other 3×3 matrix; angles: vector.
   72 mul, 90 add, 5 div, 1 sqrt, 3 neg, 6 abs, 6 copysign, 18 less, 4 equal, 45 select.
   The rotation by these angles differs from R by at most 12 u in each entry, near gimbal lock
     too; searched, not proved. */
static inline void ksl_euler_xyx_from_mat3x3f(const ksl_mat3x3f_t *R, ksl_vec3f_t *angles) {
  const float n_a = KSL_MULF(R->m01, R->m01), n_b = KSL_MULF(R->m02, R->m02), n_c = n_a + n_b,
      n = sqrtf(n_c);
  const float divisor = n == 0.0f ? 1.0f : n;
  const float cosine_a = R->m02 / divisor, cosine = n == 0.0f ? 1.0f : cosine_a;
  const float sine = R->m01 / divisor;
  const float polar = ksl_atan2f(R->m01, R->m02);
  const float third = n == 0.0f ? 0.0f : polar;
  const float left_1a = KSL_MULF(R->m11, cosine), left_1b = KSL_MULF(R->m12, sine),
      left_1 = left_1a - left_1b;
  const float left_2a = KSL_MULF(R->m21, cosine), left_2b = KSL_MULF(R->m22, sine),
      left_2 = left_2a - left_2b;
  const float angles_0 = ksl_atan2f(left_2, left_1);
  const float angles_1 = ksl_atan2f(n, R->m00);
  angles->x = angles_0;
  angles->y = angles_1;
  angles->z = third;
}

/* A = J^T A J, V = V J: Jacobi's rotation J in the xy plane, by the smaller angle that makes
     A_xy zero; then y, z, x become x, y, z.  A is symmetric, only its lower triangle is read.
     Repeated from V = I, it converges to A = diag(eigenvalues); V A V^T does not change.
   A, V: rotation or other 3×3 matrix.
   21 mul, 14 add, 3 div, 2 sqrt, 1 neg, 1 abs, 1 less, 1 equal, 3 select.
   V A V^T changes by at most 28 u max |A| for orthonormal V; searched, not proved. */
static inline void ksl_mat3x3f_jacobi(ksl_mat3x3f_t *A, ksl_mat3x3f_t *V) {
  const float twice = KSL_MULF(2.0f, A->m10);
  const float apart = A->m11 - A->m00;
  const float divisor = twice == 0.0f ? 1.0f : twice;
  const float theta = apart / divisor;
  const float magnitude = fabsf(theta);
  const float size_a = KSL_MULF(theta, theta), size_b = 1.0f + size_a, size_c = sqrtf(size_b),
      size = magnitude + size_c;
  const float along_a = -size, along = theta < 0.0f ? along_a : size;
  const float t_a = 1.0f / along, t = twice == 0.0f ? 0.0f : t_a;
  const float secant_a = KSL_MULF(t, t), secant_b = 1.0f + secant_a, secant = sqrtf(secant_b);
  const float c = 1.0f / secant;
  const float s = KSL_MULF(t, c);
  const float change = KSL_MULF(A->m10, t);
  const float zp_a = KSL_MULF(A->m20, c), zp_b = KSL_MULF(A->m21, s), zp = zp_a - zp_b;
  const float zq_a = KSL_MULF(A->m20, s), zq_b = KSL_MULF(A->m21, c), zq = zq_a + zq_b;
  const float vp_0a = KSL_MULF(V->m00, c), vp_0b = KSL_MULF(V->m01, s), vp_0 = vp_0a - vp_0b;
  const float vp_1a = KSL_MULF(V->m10, c), vp_1b = KSL_MULF(V->m11, s), vp_1 = vp_1a - vp_1b;
  const float vp_2a = KSL_MULF(V->m20, c), vp_2b = KSL_MULF(V->m21, s), vp_2 = vp_2a - vp_2b;
  const float vq_0a = KSL_MULF(V->m00, s), vq_0b = KSL_MULF(V->m01, c), vq_0 = vq_0a + vq_0b;
  const float vq_1a = KSL_MULF(V->m10, s), vq_1b = KSL_MULF(V->m11, c), vq_1 = vq_1a + vq_1b;
  const float vq_2a = KSL_MULF(V->m20, s), vq_2b = KSL_MULF(V->m21, c), vq_2 = vq_2a + vq_2b;
  const float A_00_new = A->m11 + change;
  const float A_22_new = A->m00 - change;
  const float A_m22 = A->m22;
  const float V_m02 = V->m02;
  const float V_m12 = V->m12;
  const float V_m22 = V->m22;
  A->m00 = A_00_new;
  A->m01 = zq;
  A->m02 = 0.0f;
  A->m10 = zq;
  A->m11 = A_m22;
  A->m12 = zp;
  A->m20 = 0.0f;
  A->m21 = zp;
  A->m22 = A_22_new;
  V->m00 = vq_0;
  V->m01 = V_m02;
  V->m02 = vp_0;
  V->m10 = vq_1;
  V->m11 = V_m12;
  V->m12 = vp_1;
  V->m20 = vq_2;
  V->m21 = V_m22;
  V->m22 = vp_2;
}

/* R = I + sin(angle) axis~ + (1 - cos(angle)) axis~^2, for an axis of length 1; otherwise R is
     not a rotation.
   axis: vector; angle: number; R: rotation or other 3×3 matrix.
   59 mul, 67 add, 2 abs, 1 less, 1 select.
   Error <= R: 9 u of its largest component for |axis| = 1; searched, not proved. */
static inline void ksl_mat3x3f_from_axis_angle(const ksl_vec3f_t *axis, const float angle,
    ksl_mat3x3f_t *R) {
  const float half = KSL_MULF(0.5f, angle);
  const float h = ksl_sinf(half);
  float cosine; const float sine = ksl_sincosf(angle, &cosine);
  const float versine_a = KSL_MULF(h, h), versine_b = KSL_MULF(2.0f, versine_a),
      versine_c = 1.0f - cosine, versine = cosine < 0.0f ? versine_c : versine_b;
  const float beta_v_0 = KSL_MULF(axis->x, versine);
  const float beta_v_1 = KSL_MULF(axis->y, versine);
  const float beta_v_2 = KSL_MULF(axis->z, versine);
  const float m_0 = KSL_MULF(axis->x, beta_v_0);
  const float m_1 = KSL_MULF(axis->y, beta_v_1);
  const float m_2 = KSL_MULF(axis->z, beta_v_2);
  const float m_3 = KSL_MULF(axis->y, beta_v_0);
  const float m_4 = KSL_MULF(axis->z, beta_v_0);
  const float m_5 = KSL_MULF(axis->z, beta_v_1);
  const float others_0 = m_1 + m_2;
  const float others_1 = m_0 + m_2;
  const float others_2 = m_0 + m_1;
  const float alpha_v_0 = KSL_MULF(axis->x, sine);
  const float alpha_v_1 = KSL_MULF(axis->y, sine);
  const float alpha_v_2 = KSL_MULF(axis->z, sine);
  const float R_00 = 1.0f - others_0;
  const float R_01 = m_3 - alpha_v_2;
  const float R_02 = m_4 + alpha_v_1;
  const float R_10 = m_3 + alpha_v_2;
  const float R_11 = 1.0f - others_1;
  const float R_12 = m_5 - alpha_v_0;
  const float R_20 = m_4 - alpha_v_1;
  const float R_21 = m_5 + alpha_v_0;
  const float R_22 = 1.0f - others_2;
  R->m00 = R_00;
  R->m01 = R_01;
  R->m02 = R_02;
  R->m10 = R_10;
  R->m11 = R_11;
  R->m12 = R_12;
  R->m20 = R_20;
  R->m21 = R_21;
  R->m22 = R_22;
}

/* angle and axis of the rotation R; 0 <= angle <= π; the axis is (1, 0, 0) if the angle is 0.
   R: rotation or other 3×3 matrix; axis: vector.
   30 mul, 45 add, 4 div, 1 sqrt, 6 neg, 5 abs, 2 copysign, 18 less, 2 equal, 40 select.
   Error <= angle: 8 u, axis: 5 u of its largest component for R a rotation; searched, not
     proved. */
static inline float ksl_axis_angle_from_mat3x3f(const ksl_mat3x3f_t *R, ksl_vec3f_t *axis) {
  const float p_0 = R->m21 - R->m12;
  const float p_1 = R->m02 - R->m20;
  const float p_2 = R->m10 - R->m01;
  const float s_0 = R->m12 + R->m21;
  const float s_1 = R->m02 + R->m20;
  const float s_2 = R->m01 + R->m10;
  const float first_0 = R->m00 + 1.0f;
  const float first_1 = 1.0f - R->m00;
  const float others_0 = R->m11 + R->m22;
  const float others_1 = R->m11 - R->m22;
  const float d_0 = first_0 + others_0;
  const float d_1 = first_0 - others_0;
  const float d_2 = first_1 + others_1;
  const float d_3 = first_1 - others_1;
  const float low_0 = R->m11 < R->m00 ? d_1 : s_2;
  const float low_1 = R->m11 < R->m00 ? s_2 : d_2;
  const float low_2 = R->m11 < R->m00 ? s_1 : s_0;
  const float low_3 = R->m11 < R->m00 ? p_0 : p_1;
  const float high_0a = -R->m11, high_0 = R->m00 < high_0a ? s_1 : p_0;
  const float high_1 = R->m00 < high_0a ? s_0 : p_1;
  const float high_2 = R->m00 < high_0a ? d_3 : p_2;
  const float high_3 = R->m00 < high_0a ? p_2 : d_0;
  const float column_0 = R->m22 < 0.0f ? low_0 : high_0;
  const float column_1 = R->m22 < 0.0f ? low_1 : high_1;
  const float column_2 = R->m22 < 0.0f ? low_2 : high_2;
  const float column_3 = R->m22 < 0.0f ? low_3 : high_3;
  const float upper_0a = -column_0, upper_0 = column_3 < 0.0f ? upper_0a : column_0;
  const float upper_1a = -column_1, upper_1 = column_3 < 0.0f ? upper_1a : column_1;
  const float upper_2a = -column_2, upper_2 = column_3 < 0.0f ? upper_2a : column_2;
  const float upper_3a = -column_3, upper_3 = column_3 < 0.0f ? upper_3a : column_3;
  const float v_s_size_0 = fabsf(upper_0);
  const float v_s_size_1 = fabsf(upper_1);
  const float v_s_size_2 = fabsf(upper_2);
  const float v_s_largest1 = v_s_size_0 < v_s_size_1 ? v_s_size_1 : v_s_size_0;
  const float v_s_largest2 = v_s_largest1 < v_s_size_2 ? v_s_size_2 : v_s_largest1;
  const float v_s_b = 4.611686e+18f < v_s_largest2 ? 2.7105054e-20f : 1.0f,
      v_s_d = v_s_largest2 < 256.0f ? 1.8014399e+16f : v_s_b,
      v_s = v_s_largest2 < 1.4210855e-14f ? 3.2451855e+32f : v_s_d;
  const float v_y_0 = KSL_MULF(upper_0, v_s);
  const float v_y_1 = KSL_MULF(upper_1, v_s);
  const float v_y_2 = KSL_MULF(upper_2, v_s);
  const float v_n_a = KSL_MULF(v_y_0, v_y_0), v_n_b = KSL_MULF(v_y_1, v_y_1), v_n_c = v_n_a + v_n_b,
      v_n_d = KSL_MULF(v_y_2, v_y_2), v_n_e = v_n_c + v_n_d, v_n = sqrtf(v_n_e);
  const float v_r_b = v_s < 1.0f ? 3.689349e+19f : 1.0f, v_r_d = 1.0f < v_s ? 5.551115e-17f : v_r_b,
      v_r = 1.8014399e+16f < v_s ? 3.081488e-33f : v_r_d;
  const float n = KSL_MULF(v_n, v_r);
  const float half = ksl_atan2f(n, upper_3);
  const float divisor = v_n == 0.0f ? 1.0f : v_n;
  const float unit_0 = v_y_0 / divisor;
  const float unit_1 = v_y_1 / divisor;
  const float unit_2 = v_y_2 / divisor;
  const float angle = KSL_MULF(2.0f, half);
  const float axis_0 = v_n == 0.0f ? 1.0f : unit_0;
  axis->x = axis_0;
  axis->y = unit_1;
  axis->z = unit_2;
  return angle;
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

/* What KSL declares beside formulas. */


/* self = self^-1; returns 0, or -3 with self = NaN if self is singular to rounding.  (A determinant
   of 0 would not be enough: it may have underflowed.) */
static inline int ksl_mat3x3_invert(ksl_mat3x3_t *R) {
  ksl_mat3x3_inverse(R, R);
  return R->m00 == R->m00 ? 0 : -3;
}

/* ro = ri^-1; returns 0, or -3 with ro = NaN if ri is singular to rounding. */
static inline int ksl_mat3x3_inverted(
    const ksl_mat3x3_t *ri, ksl_mat3x3_t *ro) {
  ksl_mat3x3_inverse(ri, ro);
  return ro->m00 == ro->m00 ? 0 : -3;
}

/* Axis and angle of the rotation r, by ksl_axis_angle_from_mat3x3. */
static inline void ksl_mat3x3_getAxisAngle(
    const ksl_mat3x3_t *r, ksl_vec3_t *axis, double *angle) {
  *angle = ksl_axis_angle_from_mat3x3(r, axis);
}

/* The rotation about an axis of any length; the identity for the zero vector. */
static inline void ksl_mat3x3_setFromAxisAngle(
    ksl_mat3x3_t *r, const ksl_vec3_t *axis, const double angle) {
  ksl_vec3_t unit;
  ksl_vec3_normalized(axis, &unit);
  ksl_mat3x3_from_axis_angle(&unit, angle, r);
}

/* Principal axes A = v D v^T: A is replaced by the diagonal matrix D of its eigenvalues, the largest
   first; v is a rotation, its columns are the eigenvectors.  A is symmetric, only its lower triangle
   is read.  |v D v^T - A| <= 100 u times the largest entry of A and |v v^T - I| <= 100 u; searched,
   not proved. */
static inline void ksl_mat3x3_pca(ksl_mat3x3_t *A, ksl_mat3x3_t *v) {
  static const int pairs[3][2] = {{0, 1}, {1, 2}, {0, 1}};
  ksl_mat3x3_setIdentity(v);
  /* Off-diagonal entries decrease cubically; after 12 cycles of three planes none is above
     u^2 times the largest entry. */
  for (int n = 0; n < 36 && (A->m10 != 0 || A->m20 != 0 || A->m21 != 0); n++) {
    ksl_mat3x3_jacobi(A, v);
  }
  A->m01 = A->m02 = A->m12 = A->m10 = A->m20 = A->m21 = 0;
  for (int n = 0; n < 3; n++) {
    const int i = pairs[n][0], j = pairs[n][1];
    const double value = A->at[i][i];
    if (value < A->at[j][j]) {
      A->at[i][i] = A->at[j][j];
      A->at[j][j] = value;
      ksl_vec3_swap(&v->v[i], &v->v[j]);
      ksl_vec3_invert(&v->v[j]);
    }
  }
}

/* self = self^-1; returns 0, or -3 with self = NaN if self is singular to rounding.  (A determinant
   of 0 would not be enough: it may have underflowed.) */
static inline int ksl_mat3x3f_invert(ksl_mat3x3f_t *R) {
  ksl_mat3x3f_inverse(R, R);
  return R->m00 == R->m00 ? 0 : -3;
}

/* ro = ri^-1; returns 0, or -3 with ro = NaN if ri is singular to rounding. */
static inline int ksl_mat3x3f_inverted(
    const ksl_mat3x3f_t *ri, ksl_mat3x3f_t *ro) {
  ksl_mat3x3f_inverse(ri, ro);
  return ro->m00 == ro->m00 ? 0 : -3;
}

/* Axis and angle of the rotation r, by ksl_axis_angle_from_mat3x3f. */
static inline void ksl_mat3x3f_getAxisAngle(
    const ksl_mat3x3f_t *r, ksl_vec3f_t *axis, float *angle) {
  *angle = ksl_axis_angle_from_mat3x3f(r, axis);
}

/* The rotation about an axis of any length; the identity for the zero vector. */
static inline void ksl_mat3x3f_setFromAxisAngle(
    ksl_mat3x3f_t *r, const ksl_vec3f_t *axis, const float angle) {
  ksl_vec3f_t unit;
  ksl_vec3f_normalized(axis, &unit);
  ksl_mat3x3f_from_axis_angle(&unit, angle, r);
}

/* Principal axes A = v D v^T: A is replaced by the diagonal matrix D of its eigenvalues, the largest
   first; v is a rotation, its columns are the eigenvectors.  A is symmetric, only its lower triangle
   is read.  |v D v^T - A| <= 100 u times the largest entry of A and |v v^T - I| <= 100 u; searched,
   not proved. */
static inline void ksl_mat3x3f_pca(ksl_mat3x3f_t *A, ksl_mat3x3f_t *v) {
  static const int pairs[3][2] = {{0, 1}, {1, 2}, {0, 1}};
  ksl_mat3x3f_setIdentity(v);
  /* Off-diagonal entries decrease cubically; after 12 cycles of three planes none is above
     u^2 times the largest entry. */
  for (int n = 0; n < 36 && (A->m10 != 0 || A->m20 != 0 || A->m21 != 0); n++) {
    ksl_mat3x3f_jacobi(A, v);
  }
  A->m01 = A->m02 = A->m12 = A->m10 = A->m20 = A->m21 = 0;
  for (int n = 0; n < 3; n++) {
    const int i = pairs[n][0], j = pairs[n][1];
    const float value = A->at[i][i];
    if (value < A->at[j][j]) {
      A->at[i][i] = A->at[j][j];
      A->at[j][j] = value;
      ksl_vec3f_swap(&v->v[i], &v->v[j]);
      ksl_vec3f_invert(&v->v[j]);
    }
  }
}


/* r = R_i(x) R_j(y) R_k(z) for the angles (x, y, z) and the axes i, j, k of the sequence; each
   rotation is about a current axis of the body.  NaN for KSL_AXIS_INVALID. */
static inline void ksl_mat3x3_setFromEulerAngles(
    ksl_mat3x3_t *r, const ksl_axis_enum_t axisType, const ksl_vec3_t *angles) {
  const ksl_vec3i_t axes = ksl_axis_getVector(axisType);
  const int own[3] = {axes.x, axes.y, 3 - axes.x - axes.y};
  const double sign = (axes.y - axes.x + 3) % 3 == 1 ? 1.0 : -1.0;
  const double x = KSL_MUL(sign, angles->x), y = KSL_MUL(sign, angles->y);
  const double z = KSL_MUL(sign, angles->z);
  const ksl_vec3_t turned = ksl_vec3(x, y, z);
  ksl_mat3x3_t R;
  if (axes.x < 0) {
    for (int i = 0; i < 9; i++) { r->as_array[i] = (double)NAN; }
    return;
  }
  if (axes.x == axes.z) {
    ksl_mat3x3_from_euler_xyx(&turned, &R);
  } else {
    ksl_mat3x3_from_euler_xyz(&turned, &R);
  }
  for (int column = 0; column < 3; column++) {
    for (int row = 0; row < 3; row++) { r->at[own[column]][own[row]] = R.at[column][row]; }
  }
}

/* How many whole turns to add to the angle so that it is at least reference - below. */
static inline double ksl_turns(
    const double reference, const double below, const double angle, const double turn) {
  const double least = reference - below, way = least - angle, turns = way / turn;
  return ceil(turns);
}

/* The angles close to those of `near` with the same rotation as sign times `found`; `proper`: the
   axes i and k are the same. */
static inline void ksl_nextAngles(const ksl_vec3_t *found, const double sign, const int proper,
    const ksl_vec3_t *near, ksl_vec3_t *angles) {
  const double eighth = 0.7853981633974483, half = 3.141592653589793, whole = 6.283185307179586;
  const double z = KSL_MUL(sign, found->z);
  const double turns = ksl_turns(near->z, eighth, z, half);
  const int other = fmod(turns, 2) != 0; /* half a turn of z needs one of x, too */
  const double y = KSL_MUL(sign, found->y), flipped = proper ? -y : half - y;
  const double straight = KSL_MUL(sign, found->x), shift = other ? half : 0;
  const double x = straight + shift, middle = other ? flipped : y;
  const double x_turns = ksl_turns(near->x, eighth, x, whole);
  const double y_turns = ksl_turns(near->y, eighth, middle, whole);
  const double to_x = KSL_MUL(whole, x_turns), to_y = KSL_MUL(whole, y_turns);
  const double to_z = KSL_MUL(half, turns);
  angles->x = x + to_x;
  angles->y = middle + to_y;
  angles->z = z + to_z;
}

/* The angles (x, y, z) of the rotation r = R_i(x) R_j(y) R_k(z), for the axes i, j, k of the
   sequence, close to the reference angles (ksl_vec3_t *, the last argument; zeros for NULL): z is
   from 1/8 turn below the reference to 3/8 above it, x and y from 1/8 turn below to 7/8 above.  In
   gimbal lock z is a multiple of half a turn.  NaN for KSL_AXIS_INVALID. */
static inline void ksl_mat3x3_getEulerAnglesWithReference(
    const ksl_mat3x3_t *r, const ksl_axis_enum_t axisType, ksl_vec3_t *angles, ...) {
  const ksl_vec3i_t axes = ksl_axis_getVector(axisType);
  const int own[3] = {axes.x, axes.y, 3 - axes.x - axes.y};
  const double sign = (axes.y - axes.x + 3) % 3 == 1 ? 1.0 : -1.0;
  ksl_vec3_t near = ksl_vec3(0, 0, 0), found = near;
  const ksl_vec3_t *reference;
  ksl_mat3x3_t R;
  va_list arguments;
  va_start(arguments, angles);
  reference = va_arg(arguments, const ksl_vec3_t *);
  va_end(arguments);
  if (reference != NULL) { near = *reference; }
  if (axes.x < 0) {
    angles->x = angles->y = angles->z = (double)NAN;
    return;
  }
  for (int column = 0; column < 3; column++) {
    for (int row = 0; row < 3; row++) { R.at[column][row] = r->at[own[column]][own[row]]; }
  }
  if (axes.x == axes.z) {
    ksl_euler_xyx_from_mat3x3(&R, &found);
  } else {
    ksl_euler_xyz_from_mat3x3(&R, &found);
  }
  ksl_nextAngles(&found, sign, axes.x == axes.z, &near, angles);
}

/* The same with an optional reference. */
#define ksl_mat3x3_getEulerAngles(r, ...) \
  ksl_mat3x3_getEulerAnglesWithReference(r, __VA_ARGS__, (ksl_vec3_t *)NULL)

/* r = R_i(x) R_j(y) R_k(z) for the angles (x, y, z) and the axes i, j, k of the sequence; each
   rotation is about a current axis of the body.  NaN for KSL_AXIS_INVALID. */
static inline void ksl_mat3x3f_setFromEulerAngles(
    ksl_mat3x3f_t *r, const ksl_axis_enum_t axisType, const ksl_vec3f_t *angles) {
  const ksl_vec3i_t axes = ksl_axis_getVector(axisType);
  const int own[3] = {axes.x, axes.y, 3 - axes.x - axes.y};
  const float sign = (axes.y - axes.x + 3) % 3 == 1 ? 1.0f : -1.0f;
  const float x = KSL_MULF(sign, angles->x), y = KSL_MULF(sign, angles->y);
  const float z = KSL_MULF(sign, angles->z);
  const ksl_vec3f_t turned = ksl_vec3f(x, y, z);
  ksl_mat3x3f_t R;
  if (axes.x < 0) {
    for (int i = 0; i < 9; i++) { r->as_array[i] = (float)NAN; }
    return;
  }
  if (axes.x == axes.z) {
    ksl_mat3x3f_from_euler_xyx(&turned, &R);
  } else {
    ksl_mat3x3f_from_euler_xyz(&turned, &R);
  }
  for (int column = 0; column < 3; column++) {
    for (int row = 0; row < 3; row++) { r->at[own[column]][own[row]] = R.at[column][row]; }
  }
}

/* How many whole turns to add to the angle so that it is at least reference - below. */
static inline float ksl_turnsf(
    const float reference, const float below, const float angle, const float turn) {
  const float least = reference - below, way = least - angle, turns = way / turn;
  return ceilf(turns);
}

/* The angles close to those of `near` with the same rotation as sign times `found`; `proper`: the
   axes i and k are the same. */
static inline void ksl_nextAnglesf(const ksl_vec3f_t *found, const float sign, const int proper,
    const ksl_vec3f_t *near, ksl_vec3f_t *angles) {
  const float eighth = 0.7853982f, half = 3.1415927f, whole = 6.2831855f;
  const float z = KSL_MULF(sign, found->z);
  const float turns = ksl_turnsf(near->z, eighth, z, half);
  const int other = fmodf(turns, 2) != 0; /* half a turn of z needs one of x, too */
  const float y = KSL_MULF(sign, found->y), flipped = proper ? -y : half - y;
  const float straight = KSL_MULF(sign, found->x), shift = other ? half : 0;
  const float x = straight + shift, middle = other ? flipped : y;
  const float x_turns = ksl_turnsf(near->x, eighth, x, whole);
  const float y_turns = ksl_turnsf(near->y, eighth, middle, whole);
  const float to_x = KSL_MULF(whole, x_turns), to_y = KSL_MULF(whole, y_turns);
  const float to_z = KSL_MULF(half, turns);
  angles->x = x + to_x;
  angles->y = middle + to_y;
  angles->z = z + to_z;
}

/* The angles (x, y, z) of the rotation r = R_i(x) R_j(y) R_k(z), for the axes i, j, k of the
   sequence, close to the reference angles (ksl_vec3f_t *, the last argument; zeros for NULL): z is
   from 1/8 turn below the reference to 3/8 above it, x and y from 1/8 turn below to 7/8 above.  In
   gimbal lock z is a multiple of half a turn.  NaN for KSL_AXIS_INVALID. */
static inline void ksl_mat3x3f_getEulerAnglesWithReference(
    const ksl_mat3x3f_t *r, const ksl_axis_enum_t axisType, ksl_vec3f_t *angles, ...) {
  const ksl_vec3i_t axes = ksl_axis_getVector(axisType);
  const int own[3] = {axes.x, axes.y, 3 - axes.x - axes.y};
  const float sign = (axes.y - axes.x + 3) % 3 == 1 ? 1.0f : -1.0f;
  ksl_vec3f_t near = ksl_vec3f(0, 0, 0), found = near;
  const ksl_vec3f_t *reference;
  ksl_mat3x3f_t R;
  va_list arguments;
  va_start(arguments, angles);
  reference = va_arg(arguments, const ksl_vec3f_t *);
  va_end(arguments);
  if (reference != NULL) { near = *reference; }
  if (axes.x < 0) {
    angles->x = angles->y = angles->z = (float)NAN;
    return;
  }
  for (int column = 0; column < 3; column++) {
    for (int row = 0; row < 3; row++) { R.at[column][row] = r->at[own[column]][own[row]]; }
  }
  if (axes.x == axes.z) {
    ksl_euler_xyx_from_mat3x3f(&R, &found);
  } else {
    ksl_euler_xyz_from_mat3x3f(&R, &found);
  }
  ksl_nextAnglesf(&found, sign, axes.x == axes.z, &near, angles);
}

/* The same with an optional reference. */
#define ksl_mat3x3f_getEulerAngles(r, ...) \
  ksl_mat3x3f_getEulerAnglesWithReference(r, __VA_ARGS__, (ksl_vec3f_t *)NULL)

#endif
