/* Made by `coscrew generate`; changes are overwritten. */
/* SPDX-License-Identifier: MIT */
/* coscrew 0.2.0.  Copyright (c) 2026 The coscrew authors. */
/* 3×3 matrices: rotations, and matrices in general. */
#ifndef KSL_MAT3X3_H
#define KSL_MAT3X3_H

#include <stdbool.h>
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
  const double Ro_01 = -v->z, Ro_12 = -v->x, Ro_20 = -v->y;
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
  const double ww_0 = KSL_MUL(w->x, w->x), ww_1 = KSL_MUL(w->y, w->y), ww_2 = KSL_MUL(w->z, w->z),
      ww_3 = KSL_MUL(w->x, w->y), ww_4 = KSL_MUL(w->x, w->z), ww_5 = KSL_MUL(w->y, w->z);
  const double Ro_00 = -(ww_1 + ww_2), Ro_01 = ww_3 - dw->z, Ro_02 = dw->y + ww_4,
      Ro_10 = dw->z + ww_3, Ro_11 = -(ww_0 + ww_2), Ro_12 = ww_5 - dw->x, Ro_20 = ww_4 - dw->y,
      Ro_21 = dw->x + ww_5, Ro_22 = -(ww_0 + ww_1);
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
  const double n_0 = KSL_MUL(R->m11, R->m22) - KSL_MUL(R->m12, R->m21),
      n_1 = KSL_MUL(R->m02, R->m21) - KSL_MUL(R->m01, R->m22),
      n_2 = KSL_MUL(R->m01, R->m12) - KSL_MUL(R->m02, R->m11);
  const double det = KSL_MUL(R->m00, n_0) + KSL_MUL(R->m10, n_1) + KSL_MUL(R->m20, n_2);
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
  const double R_size_0 = fabs(R->m00), R_size_1 = fabs(R->m01), R_size_2 = fabs(R->m02),
      R_size_3 = fabs(R->m10), R_size_4 = fabs(R->m11), R_size_5 = fabs(R->m12),
      R_size_6 = fabs(R->m20), R_size_7 = fabs(R->m21), R_size_8 = fabs(R->m22);
  const double R_largest1 = R_size_0 < R_size_1 ? R_size_1 : R_size_0;
  const double R_largest2 = R_largest1 < R_size_2 ? R_size_2 : R_largest1;
  const double R_largest3 = R_largest2 < R_size_3 ? R_size_3 : R_largest2;
  const double R_largest4 = R_largest3 < R_size_4 ? R_size_4 : R_largest3;
  const double R_largest5 = R_largest4 < R_size_5 ? R_size_5 : R_largest4;
  const double R_largest6 = R_largest5 < R_size_6 ? R_size_6 : R_largest5;
  const double R_largest7 = R_largest6 < R_size_7 ? R_size_7 : R_largest6;
  const double R_largest8 = R_largest7 < R_size_8 ? R_size_8 : R_largest7;
  const double s_b = R_largest8 < 8.452712498170644e+270 ? 2.409919865102884e-181
          : 1.1830521861667747e-271,
      s_d = R_largest8 < 4.149515568880993e+180 ? 4.909093465297727e-91 : s_b,
      s_f = R_largest8 < 2.037035976334486e+90 ? 1.0 : s_d,
      s_h = R_largest8 < 1.0 ? 2.037035976334486e+90 : s_f,
      s_j = R_largest8 < 4.909093465297727e-91 ? 4.149515568880993e+180 : s_h,
      s = R_largest8 < 2.409919865102884e-181 ? 8.452712498170644e+270 : s_j;
  const double A_0 = KSL_MUL(R->m00, s), A_1 = KSL_MUL(R->m01, s), A_2 = KSL_MUL(R->m02, s),
      A_3 = KSL_MUL(R->m10, s), A_4 = KSL_MUL(R->m11, s), A_5 = KSL_MUL(R->m12, s),
      A_6 = KSL_MUL(R->m20, s), A_7 = KSL_MUL(R->m21, s), A_8 = KSL_MUL(R->m22, s);
  const double n0_0 = KSL_MUL(A_4, A_8) - KSL_MUL(A_5, A_7),
      n0_1 = KSL_MUL(A_2, A_7) - KSL_MUL(A_1, A_8), n0_2 = KSL_MUL(A_1, A_5) - KSL_MUL(A_2, A_4);
  const double n1_0 = KSL_MUL(A_5, A_6) - KSL_MUL(A_3, A_8),
      n1_1 = KSL_MUL(A_0, A_8) - KSL_MUL(A_2, A_6), n1_2 = KSL_MUL(A_2, A_3) - KSL_MUL(A_0, A_5);
  const double n2_0 = KSL_MUL(A_3, A_7) - KSL_MUL(A_4, A_6),
      n2_1 = KSL_MUL(A_1, A_6) - KSL_MUL(A_0, A_7), n2_2 = KSL_MUL(A_0, A_4) - KSL_MUL(A_1, A_3);
  const double d = KSL_MUL(A_0, n0_0) + KSL_MUL(A_3, n0_1) + KSL_MUL(A_6, n0_2);
  const double size0_0 = fabs(A_0), size0_1 = fabs(A_3), size0_2 = fabs(A_6);
  const double size1_0 = fabs(A_1), size1_1 = fabs(A_4), size1_2 = fabs(A_7);
  const double size2_0 = fabs(A_2), size2_1 = fabs(A_5), size2_2 = fabs(A_8);
  const double permanent_d = KSL_MUL(size0_0, KSL_MUL(size1_1, size2_2)
          + KSL_MUL(size1_2, size2_1)),
      permanent_i = permanent_d
          + KSL_MUL(size0_1, KSL_MUL(size1_0, size2_2) + KSL_MUL(size1_2, size2_0)),
      permanent = permanent_i
          + KSL_MUL(size0_2, KSL_MUL(size1_0, size2_1) + KSL_MUL(size1_1, size2_0));
  const double top = KSL_MUL(R_largest8, s);
  const double spoiled = KSL_MUL(top, 1.6489340850168661e-229);
  const double least = KSL_MUL(permanent, 8.881784197001252e-16)
          + KSL_MUL(spoiled, KSL_MUL(top, top));
  const double regular = least < fabs(d) ? 1.0 : 0.0;
  const double divisor = regular == 1.0 ? d : 1.0;
  const double quotient_0 = n0_0 / divisor, quotient_1 = n0_1 / divisor,
      quotient_2 = n0_2 / divisor, quotient_3 = n1_0 / divisor, quotient_4 = n1_1 / divisor,
      quotient_5 = n1_2 / divisor, quotient_6 = n2_0 / divisor, quotient_7 = n2_1 / divisor,
      quotient_8 = n2_2 / divisor;
  const double inverse_0 = KSL_MUL(quotient_0, s), inverse_1 = KSL_MUL(quotient_1, s),
      inverse_2 = KSL_MUL(quotient_2, s), inverse_3 = KSL_MUL(quotient_3, s),
      inverse_4 = KSL_MUL(quotient_4, s), inverse_5 = KSL_MUL(quotient_5, s),
      inverse_6 = KSL_MUL(quotient_6, s), inverse_7 = KSL_MUL(quotient_7, s),
      inverse_8 = KSL_MUL(quotient_8, s);
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
  const double Ro_00 = regular == 1.0 ? inverse_0 : (double)NAN,
      Ro_01 = regular == 1.0 ? inverse_1 : (double)NAN,
      Ro_02 = regular == 1.0 ? inverse_2 : (double)NAN,
      Ro_10 = regular == 1.0 ? inverse_3 : (double)NAN,
      Ro_11 = regular == 1.0 ? inverse_4 : (double)NAN,
      Ro_12 = regular == 1.0 ? inverse_5 : (double)NAN,
      Ro_20 = regular == 1.0 ? inverse_6 : (double)NAN,
      Ro_21 = regular == 1.0 ? inverse_7 : (double)NAN,
      Ro_22 = regular == 1.0 ? inverse_8 : (double)NAN;
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
  const double q0_s_size_0 = fabs(self->m00), q0_s_size_1 = fabs(self->m01),
      q0_s_size_2 = fabs(self->m02);
  const double q0_s_largest1 = q0_s_size_0 < q0_s_size_1 ? q0_s_size_1 : q0_s_size_0;
  const double q0_s_largest2 = q0_s_largest1 < q0_s_size_2 ? q0_s_size_2 : q0_s_largest1;
  const double q0_s_b = 6.703903964971299e+153 < q0_s_largest2 ? 3.7291703656001034e-155 : 1.0,
      q0_s_d = q0_s_largest2 < 256.0 ? 1.3093562431584567e+151 : q0_s_b,
      q0_s = q0_s_largest2 < 1.955159272639747e-149 ? 1.0715086071862673e+301 : q0_s_d;
  const double q0_y_0 = KSL_MUL(self->m00, q0_s), q0_y_1 = KSL_MUL(self->m01, q0_s),
      q0_y_2 = KSL_MUL(self->m02, q0_s);
  const double q0_up = 1.0 < q0_s ? q0_s : 1.0;
  const double q0_down = q0_s < 1.0 ? q0_s : 1.0;
  const double q0_n = sqrt(KSL_MUL(q0_y_0, q0_y_0) + KSL_MUL(q0_y_1, q0_y_1)
          + KSL_MUL(q0_y_2, q0_y_2));
  const double q0_divisor = q0_n == 0.0 ? q0_up : q0_n;
  const double q0_sized_0 = KSL_MUL(self->m00, q0_up), q0_sized_1 = KSL_MUL(self->m01, q0_up),
      q0_sized_2 = KSL_MUL(self->m02, q0_up);
  const double q0_quotient_0 = q0_sized_0 / q0_divisor, q0_quotient_1 = q0_sized_1 / q0_divisor,
      q0_quotient_2 = q0_sized_2 / q0_divisor;
  const double q0_0 = KSL_MUL(q0_quotient_0, q0_down), q0_1 = KSL_MUL(q0_quotient_1, q0_down),
      q0_2 = KSL_MUL(q0_quotient_2, q0_down);
  const double u1_s_size_0 = fabs(self->m10), u1_s_size_1 = fabs(self->m11),
      u1_s_size_2 = fabs(self->m12);
  const double u1_s_largest1 = u1_s_size_0 < u1_s_size_1 ? u1_s_size_1 : u1_s_size_0;
  const double u1_s_largest2 = u1_s_largest1 < u1_s_size_2 ? u1_s_size_2 : u1_s_largest1;
  const double u1_s_b = 6.703903964971299e+153 < u1_s_largest2 ? 3.7291703656001034e-155 : 1.0,
      u1_s_d = u1_s_largest2 < 256.0 ? 1.3093562431584567e+151 : u1_s_b,
      u1_s = u1_s_largest2 < 1.955159272639747e-149 ? 1.0715086071862673e+301 : u1_s_d;
  const double u1_y_0 = KSL_MUL(self->m10, u1_s), u1_y_1 = KSL_MUL(self->m11, u1_s),
      u1_y_2 = KSL_MUL(self->m12, u1_s);
  const double u1_up = 1.0 < u1_s ? u1_s : 1.0;
  const double u1_down = u1_s < 1.0 ? u1_s : 1.0;
  const double u1_n = sqrt(KSL_MUL(u1_y_0, u1_y_0) + KSL_MUL(u1_y_1, u1_y_1)
          + KSL_MUL(u1_y_2, u1_y_2));
  const double u1_divisor = u1_n == 0.0 ? u1_up : u1_n;
  const double u1_sized_0 = KSL_MUL(self->m10, u1_up), u1_sized_1 = KSL_MUL(self->m11, u1_up),
      u1_sized_2 = KSL_MUL(self->m12, u1_up);
  const double u1_quotient_0 = u1_sized_0 / u1_divisor, u1_quotient_1 = u1_sized_1 / u1_divisor,
      u1_quotient_2 = u1_sized_2 / u1_divisor;
  const double u1_0 = KSL_MUL(u1_quotient_0, u1_down), u1_1 = KSL_MUL(u1_quotient_1, u1_down),
      u1_2 = KSL_MUL(u1_quotient_2, u1_down);
  const double along = KSL_MUL(q0_0, u1_0) + KSL_MUL(q0_1, u1_1) + KSL_MUL(q0_2, u1_2);
  const double once_0 = u1_0 - KSL_MUL(q0_0, along), once_1 = u1_1 - KSL_MUL(q0_1, along),
      once_2 = u1_2 - KSL_MUL(q0_2, along);
  const double rest = KSL_MUL(q0_0, once_0) + KSL_MUL(q0_1, once_1) + KSL_MUL(q0_2, once_2);
  const double twice_0 = once_0 - KSL_MUL(q0_0, rest), twice_1 = once_1 - KSL_MUL(q0_1, rest),
      twice_2 = once_2 - KSL_MUL(q0_2, rest);
  const double n = sqrt(KSL_MUL(twice_0, twice_0) + KSL_MUL(twice_1, twice_1)
          + KSL_MUL(twice_2, twice_2));
  const double divisor = n == 0.0 ? 1.0 : n;
  const double q1_0 = twice_0 / divisor, q1_1 = twice_1 / divisor, q1_2 = twice_2 / divisor;
  const double normal_0 = KSL_MUL(q0_1, q1_2) - KSL_MUL(q0_2, q1_1),
      normal_1 = KSL_MUL(q0_2, q1_0) - KSL_MUL(q0_0, q1_2),
      normal_2 = KSL_MUL(q0_0, q1_1) - KSL_MUL(q0_1, q1_0);
  const double u2_s_size_0 = fabs(self->m20), u2_s_size_1 = fabs(self->m21),
      u2_s_size_2 = fabs(self->m22);
  const double u2_s_largest1 = u2_s_size_0 < u2_s_size_1 ? u2_s_size_1 : u2_s_size_0;
  const double u2_s_largest2 = u2_s_largest1 < u2_s_size_2 ? u2_s_size_2 : u2_s_largest1;
  const double u2_s_b = 6.703903964971299e+153 < u2_s_largest2 ? 3.7291703656001034e-155 : 1.0,
      u2_s_d = u2_s_largest2 < 256.0 ? 1.3093562431584567e+151 : u2_s_b,
      u2_s = u2_s_largest2 < 1.955159272639747e-149 ? 1.0715086071862673e+301 : u2_s_d;
  const double u2_y_0 = KSL_MUL(self->m20, u2_s), u2_y_1 = KSL_MUL(self->m21, u2_s),
      u2_y_2 = KSL_MUL(self->m22, u2_s);
  const double u2_up = 1.0 < u2_s ? u2_s : 1.0;
  const double u2_down = u2_s < 1.0 ? u2_s : 1.0;
  const double u2_n = sqrt(KSL_MUL(u2_y_0, u2_y_0) + KSL_MUL(u2_y_1, u2_y_1)
          + KSL_MUL(u2_y_2, u2_y_2));
  const double u2_divisor = u2_n == 0.0 ? u2_up : u2_n;
  const double u2_sized_0 = KSL_MUL(self->m20, u2_up), u2_sized_1 = KSL_MUL(self->m21, u2_up),
      u2_sized_2 = KSL_MUL(self->m22, u2_up);
  const double u2_quotient_0 = u2_sized_0 / u2_divisor, u2_quotient_1 = u2_sized_1 / u2_divisor,
      u2_quotient_2 = u2_sized_2 / u2_divisor;
  const double u2_0 = KSL_MUL(u2_quotient_0, u2_down), u2_1 = KSL_MUL(u2_quotient_1, u2_down),
      u2_2 = KSL_MUL(u2_quotient_2, u2_down);
  const double side = KSL_MUL(normal_0, u2_0) + KSL_MUL(normal_1, u2_1) + KSL_MUL(normal_2, u2_2);
  const double q2_0a = -normal_0, q2_0 = side < 0.0 ? q2_0a : normal_0;
  const double q2_1a = -normal_1, q2_1 = side < 0.0 ? q2_1a : normal_1;
  const double q2_2a = -normal_2, q2_2 = side < 0.0 ? q2_2a : normal_2;
  const double size = fabs(side);
  const double less = n < size ? n : size;
  const double dependent = less < 1.7763568394002505e-15 ? 1.0 : 0.0;
  const double self_00_new = dependent == 1.0 ? (double)NAN : q0_0,
      self_01_new = dependent == 1.0 ? (double)NAN : q0_1,
      self_02_new = dependent == 1.0 ? (double)NAN : q0_2,
      self_10_new = dependent == 1.0 ? (double)NAN : q1_0,
      self_11_new = dependent == 1.0 ? (double)NAN : q1_1,
      self_12_new = dependent == 1.0 ? (double)NAN : q1_2,
      self_20_new = dependent == 1.0 ? (double)NAN : q2_0,
      self_21_new = dependent == 1.0 ? (double)NAN : q2_1,
      self_22_new = dependent == 1.0 ? (double)NAN : q2_2;
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
  const double q0_s_size_0 = fabs(R->m00), q0_s_size_1 = fabs(R->m01), q0_s_size_2 = fabs(R->m02);
  const double q0_s_largest1 = q0_s_size_0 < q0_s_size_1 ? q0_s_size_1 : q0_s_size_0;
  const double q0_s_largest2 = q0_s_largest1 < q0_s_size_2 ? q0_s_size_2 : q0_s_largest1;
  const double q0_s_b = 6.703903964971299e+153 < q0_s_largest2 ? 3.7291703656001034e-155 : 1.0,
      q0_s_d = q0_s_largest2 < 256.0 ? 1.3093562431584567e+151 : q0_s_b,
      q0_s = q0_s_largest2 < 1.955159272639747e-149 ? 1.0715086071862673e+301 : q0_s_d;
  const double q0_y_0 = KSL_MUL(R->m00, q0_s), q0_y_1 = KSL_MUL(R->m01, q0_s),
      q0_y_2 = KSL_MUL(R->m02, q0_s);
  const double q0_up = 1.0 < q0_s ? q0_s : 1.0;
  const double q0_down = q0_s < 1.0 ? q0_s : 1.0;
  const double q0_n = sqrt(KSL_MUL(q0_y_0, q0_y_0) + KSL_MUL(q0_y_1, q0_y_1)
          + KSL_MUL(q0_y_2, q0_y_2));
  const double q0_divisor = q0_n == 0.0 ? q0_up : q0_n;
  const double q0_sized_0 = KSL_MUL(R->m00, q0_up), q0_sized_1 = KSL_MUL(R->m01, q0_up),
      q0_sized_2 = KSL_MUL(R->m02, q0_up);
  const double q0_quotient_0 = q0_sized_0 / q0_divisor, q0_quotient_1 = q0_sized_1 / q0_divisor,
      q0_quotient_2 = q0_sized_2 / q0_divisor;
  const double q0_0 = KSL_MUL(q0_quotient_0, q0_down), q0_1 = KSL_MUL(q0_quotient_1, q0_down),
      q0_2 = KSL_MUL(q0_quotient_2, q0_down);
  const double u1_s_size_0 = fabs(R->m10), u1_s_size_1 = fabs(R->m11), u1_s_size_2 = fabs(R->m12);
  const double u1_s_largest1 = u1_s_size_0 < u1_s_size_1 ? u1_s_size_1 : u1_s_size_0;
  const double u1_s_largest2 = u1_s_largest1 < u1_s_size_2 ? u1_s_size_2 : u1_s_largest1;
  const double u1_s_b = 6.703903964971299e+153 < u1_s_largest2 ? 3.7291703656001034e-155 : 1.0,
      u1_s_d = u1_s_largest2 < 256.0 ? 1.3093562431584567e+151 : u1_s_b,
      u1_s = u1_s_largest2 < 1.955159272639747e-149 ? 1.0715086071862673e+301 : u1_s_d;
  const double u1_y_0 = KSL_MUL(R->m10, u1_s), u1_y_1 = KSL_MUL(R->m11, u1_s),
      u1_y_2 = KSL_MUL(R->m12, u1_s);
  const double u1_up = 1.0 < u1_s ? u1_s : 1.0;
  const double u1_down = u1_s < 1.0 ? u1_s : 1.0;
  const double u1_n = sqrt(KSL_MUL(u1_y_0, u1_y_0) + KSL_MUL(u1_y_1, u1_y_1)
          + KSL_MUL(u1_y_2, u1_y_2));
  const double u1_divisor = u1_n == 0.0 ? u1_up : u1_n;
  const double u1_sized_0 = KSL_MUL(R->m10, u1_up), u1_sized_1 = KSL_MUL(R->m11, u1_up),
      u1_sized_2 = KSL_MUL(R->m12, u1_up);
  const double u1_quotient_0 = u1_sized_0 / u1_divisor, u1_quotient_1 = u1_sized_1 / u1_divisor,
      u1_quotient_2 = u1_sized_2 / u1_divisor;
  const double u1_0 = KSL_MUL(u1_quotient_0, u1_down), u1_1 = KSL_MUL(u1_quotient_1, u1_down),
      u1_2 = KSL_MUL(u1_quotient_2, u1_down);
  const double along = KSL_MUL(q0_0, u1_0) + KSL_MUL(q0_1, u1_1) + KSL_MUL(q0_2, u1_2);
  const double once_0 = u1_0 - KSL_MUL(q0_0, along), once_1 = u1_1 - KSL_MUL(q0_1, along),
      once_2 = u1_2 - KSL_MUL(q0_2, along);
  const double rest = KSL_MUL(q0_0, once_0) + KSL_MUL(q0_1, once_1) + KSL_MUL(q0_2, once_2);
  const double twice_0 = once_0 - KSL_MUL(q0_0, rest), twice_1 = once_1 - KSL_MUL(q0_1, rest),
      twice_2 = once_2 - KSL_MUL(q0_2, rest);
  const double n = sqrt(KSL_MUL(twice_0, twice_0) + KSL_MUL(twice_1, twice_1)
          + KSL_MUL(twice_2, twice_2));
  const double divisor = n == 0.0 ? 1.0 : n;
  const double q1_0 = twice_0 / divisor, q1_1 = twice_1 / divisor, q1_2 = twice_2 / divisor;
  const double normal_0 = KSL_MUL(q0_1, q1_2) - KSL_MUL(q0_2, q1_1),
      normal_1 = KSL_MUL(q0_2, q1_0) - KSL_MUL(q0_0, q1_2),
      normal_2 = KSL_MUL(q0_0, q1_1) - KSL_MUL(q0_1, q1_0);
  const double u2_s_size_0 = fabs(R->m20), u2_s_size_1 = fabs(R->m21), u2_s_size_2 = fabs(R->m22);
  const double u2_s_largest1 = u2_s_size_0 < u2_s_size_1 ? u2_s_size_1 : u2_s_size_0;
  const double u2_s_largest2 = u2_s_largest1 < u2_s_size_2 ? u2_s_size_2 : u2_s_largest1;
  const double u2_s_b = 6.703903964971299e+153 < u2_s_largest2 ? 3.7291703656001034e-155 : 1.0,
      u2_s_d = u2_s_largest2 < 256.0 ? 1.3093562431584567e+151 : u2_s_b,
      u2_s = u2_s_largest2 < 1.955159272639747e-149 ? 1.0715086071862673e+301 : u2_s_d;
  const double u2_y_0 = KSL_MUL(R->m20, u2_s), u2_y_1 = KSL_MUL(R->m21, u2_s),
      u2_y_2 = KSL_MUL(R->m22, u2_s);
  const double u2_up = 1.0 < u2_s ? u2_s : 1.0;
  const double u2_down = u2_s < 1.0 ? u2_s : 1.0;
  const double u2_n = sqrt(KSL_MUL(u2_y_0, u2_y_0) + KSL_MUL(u2_y_1, u2_y_1)
          + KSL_MUL(u2_y_2, u2_y_2));
  const double u2_divisor = u2_n == 0.0 ? u2_up : u2_n;
  const double u2_sized_0 = KSL_MUL(R->m20, u2_up), u2_sized_1 = KSL_MUL(R->m21, u2_up),
      u2_sized_2 = KSL_MUL(R->m22, u2_up);
  const double u2_quotient_0 = u2_sized_0 / u2_divisor, u2_quotient_1 = u2_sized_1 / u2_divisor,
      u2_quotient_2 = u2_sized_2 / u2_divisor;
  const double u2_0 = KSL_MUL(u2_quotient_0, u2_down), u2_1 = KSL_MUL(u2_quotient_1, u2_down),
      u2_2 = KSL_MUL(u2_quotient_2, u2_down);
  const double side = KSL_MUL(normal_0, u2_0) + KSL_MUL(normal_1, u2_1) + KSL_MUL(normal_2, u2_2);
  const double q2_0a = -normal_0, q2_0 = side < 0.0 ? q2_0a : normal_0;
  const double q2_1a = -normal_1, q2_1 = side < 0.0 ? q2_1a : normal_1;
  const double q2_2a = -normal_2, q2_2 = side < 0.0 ? q2_2a : normal_2;
  const double size = fabs(side);
  const double less = n < size ? n : size;
  const double dependent = less < 1.7763568394002505e-15 ? 1.0 : 0.0;
  const double Ro_00 = dependent == 1.0 ? (double)NAN : q0_0,
      Ro_01 = dependent == 1.0 ? (double)NAN : q0_1, Ro_02 = dependent == 1.0 ? (double)NAN : q0_2,
      Ro_10 = dependent == 1.0 ? (double)NAN : q1_0, Ro_11 = dependent == 1.0 ? (double)NAN : q1_1,
      Ro_12 = dependent == 1.0 ? (double)NAN : q1_2, Ro_20 = dependent == 1.0 ? (double)NAN : q2_0,
      Ro_21 = dependent == 1.0 ? (double)NAN : q2_1, Ro_22 = dependent == 1.0 ? (double)NAN : q2_2;
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
  const double versine_axis_0 = KSL_MUL(axis->x, versine),
      versine_axis_1 = KSL_MUL(axis->y, versine), versine_axis_2 = KSL_MUL(axis->z, versine);
  const double m_0 = KSL_MUL(axis->x, versine_axis_0), m_1 = KSL_MUL(axis->y, versine_axis_1),
      m_2 = KSL_MUL(axis->z, versine_axis_2), m_3 = KSL_MUL(axis->y, versine_axis_0),
      m_4 = KSL_MUL(axis->z, versine_axis_0), m_5 = KSL_MUL(axis->z, versine_axis_1);
  const double sine_axis_0 = KSL_MUL(axis->x, dc[0]), sine_axis_1 = KSL_MUL(axis->y, dc[0]),
      sine_axis_2 = KSL_MUL(axis->z, dc[0]);
  const double R_00 = dc[1] + m_0, R_01 = m_3 - sine_axis_2, R_02 = m_4 + sine_axis_1,
      R_10 = m_3 + sine_axis_2, R_11 = dc[1] + m_1, R_12 = m_5 - sine_axis_0,
      R_20 = m_4 - sine_axis_1, R_21 = m_5 + sine_axis_0, R_22 = dc[1] + m_2;
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
  const double first_0 = KSL_MUL(c_1, c_2), first_1 = -KSL_MUL(s_2, c_1),
      first_6 = -KSL_MUL(s_1, c_2), first_7 = KSL_MUL(s_1, s_2);
  const double last_3 = KSL_MUL(s_2, c_0) - KSL_MUL(s_0, first_6),
      last_4 = KSL_MUL(c_0, c_2) - KSL_MUL(s_0, first_7), last_5 = -KSL_MUL(s_0, c_1),
      last_6 = KSL_MUL(s_0, s_2) + KSL_MUL(c_0, first_6),
      last_7 = KSL_MUL(s_0, c_2) + KSL_MUL(c_0, first_7), last_8 = KSL_MUL(c_0, c_1);
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
   93 mul, 109 add, 5 div, 1 sqrt, 4 neg, 6 abs, 6 copysign, 19 less, 4 equal, 46 select.
   The rotation by these angles differs from R by at most 12 u in each entry, near gimbal lock
     too; searched, not proved. */
static inline void ksl_euler_xyz_from_mat3x3(const ksl_mat3x3_t *R, ksl_vec3_t *angles) {
  const double n = sqrt(KSL_MUL(R->m00, R->m00) + KSL_MUL(R->m01, R->m01));
  const double divisor = n == 0.0 ? 1.0 : n;
  const double cosine_a = R->m00 / divisor, cosine = n == 0.0 ? 1.0 : cosine_a;
  const double sine_a = -R->m01, sine = sine_a / divisor;
  const double polar = ksl_atan2(sine_a, R->m00);
  const double third = n == 0.0 ? 0.0 : polar;
  const double left_1 = KSL_MUL(R->m10, sine) + KSL_MUL(R->m11, cosine),
      left_2 = KSL_MUL(R->m20, sine) + KSL_MUL(R->m21, cosine);
  const double rest = R->m12 + R->m22;
  const double first = ksl_atan2(left_2, left_1);
  const double angles_0 = rest < 1.2676506002282294e+30 ? first : rest,
      angles_1 = ksl_atan2(R->m02, n);
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
  const double first_1 = KSL_MUL(s_1, s_2), first_2 = KSL_MUL(s_1, c_2),
      first_7 = KSL_MUL(s_2, c_1), first_8 = KSL_MUL(c_1, c_2);
  const double last_3 = KSL_MUL(s_0, s_1), last_4 = KSL_MUL(c_0, c_2) - KSL_MUL(s_0, first_7),
      last_5 = -(KSL_MUL(s_0, first_8) + KSL_MUL(s_2, c_0)), last_6 = -KSL_MUL(s_1, c_0),
      last_7 = KSL_MUL(s_0, c_2) + KSL_MUL(c_0, first_7),
      last_8 = KSL_MUL(c_0, first_8) - KSL_MUL(s_0, s_2);
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
   93 mul, 109 add, 5 div, 1 sqrt, 3 neg, 6 abs, 6 copysign, 19 less, 4 equal, 46 select.
   The rotation by these angles differs from R by at most 12 u in each entry, near gimbal lock
     too; searched, not proved. */
static inline void ksl_euler_xyx_from_mat3x3(const ksl_mat3x3_t *R, ksl_vec3_t *angles) {
  const double n = sqrt(KSL_MUL(R->m01, R->m01) + KSL_MUL(R->m02, R->m02));
  const double divisor = n == 0.0 ? 1.0 : n;
  const double cosine_a = R->m02 / divisor, cosine = n == 0.0 ? 1.0 : cosine_a;
  const double sine = R->m01 / divisor;
  const double polar = ksl_atan2(R->m01, R->m02);
  const double third = n == 0.0 ? 0.0 : polar;
  const double left_1 = KSL_MUL(R->m11, cosine) - KSL_MUL(R->m12, sine),
      left_2 = KSL_MUL(R->m21, cosine) - KSL_MUL(R->m22, sine);
  const double rest = R->m10 + R->m20;
  const double first = ksl_atan2(left_2, left_1);
  const double angles_0 = rest < 1.2676506002282294e+30 ? first : rest,
      angles_1 = ksl_atan2(n, R->m00);
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
  const double size = magnitude + sqrt(1.0 + KSL_MUL(theta, theta));
  const double along_a = -size, along = theta < 0.0 ? along_a : size;
  const double t_a = 1.0 / along, t = twice == 0.0 ? 0.0 : t_a;
  const double secant = sqrt(1.0 + KSL_MUL(t, t));
  const double c = 1.0 / secant;
  const double s = KSL_MUL(t, c);
  const double change = KSL_MUL(A->m10, t);
  const double zp = KSL_MUL(A->m20, c) - KSL_MUL(A->m21, s);
  const double zq = KSL_MUL(A->m20, s) + KSL_MUL(A->m21, c);
  const double vp_0 = KSL_MUL(V->m00, c) - KSL_MUL(V->m01, s),
      vp_1 = KSL_MUL(V->m10, c) - KSL_MUL(V->m11, s),
      vp_2 = KSL_MUL(V->m20, c) - KSL_MUL(V->m21, s);
  const double vq_0 = KSL_MUL(V->m00, s) + KSL_MUL(V->m01, c),
      vq_1 = KSL_MUL(V->m10, s) + KSL_MUL(V->m11, c),
      vq_2 = KSL_MUL(V->m20, s) + KSL_MUL(V->m21, c);
  const double A_00_new = A->m11 + change, A_22_new = A->m00 - change;
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

/* the largest of |det R - 1| and |R^T R - I|_ij: 0 for a rotation, 2 for a reflection, NaN if an
     entry is NaN.
   R: rotation or other 3×3 matrix.
   27 mul, 21 add, 7 abs, 6 less, 6 select.
   Error <= 6 u near a rotation; measured, not proved. */
static inline double ksl_mat3x3_rotation_defect(const ksl_mat3x3_t *R) {
  const double n_0 = KSL_MUL(R->m11, R->m22) - KSL_MUL(R->m12, R->m21),
      n_1 = KSL_MUL(R->m02, R->m21) - KSL_MUL(R->m01, R->m22),
      n_2 = KSL_MUL(R->m01, R->m12) - KSL_MUL(R->m02, R->m11);
  const double det = KSL_MUL(R->m00, n_0) + KSL_MUL(R->m10, n_1) + KSL_MUL(R->m20, n_2);
  const double g_0 = KSL_MUL(R->m00, R->m00) + KSL_MUL(R->m10, R->m10) + KSL_MUL(R->m20, R->m20),
      g_1 = KSL_MUL(R->m00, R->m01) + KSL_MUL(R->m10, R->m11) + KSL_MUL(R->m20, R->m21),
      g_2 = KSL_MUL(R->m00, R->m02) + KSL_MUL(R->m10, R->m12) + KSL_MUL(R->m20, R->m22),
      g_3 = KSL_MUL(R->m01, R->m01) + KSL_MUL(R->m11, R->m11) + KSL_MUL(R->m21, R->m21),
      g_4 = KSL_MUL(R->m01, R->m02) + KSL_MUL(R->m11, R->m12) + KSL_MUL(R->m21, R->m22),
      g_5 = KSL_MUL(R->m02, R->m02) + KSL_MUL(R->m12, R->m12) + KSL_MUL(R->m22, R->m22);
  const double off_0 = det - 1.0, off_1 = g_0 - 1.0, off_4 = g_3 - 1.0, off_6 = g_5 - 1.0;
  const double defect_size_0 = fabs(off_0), defect_size_1 = fabs(off_1), defect_size_2 = fabs(g_1),
      defect_size_3 = fabs(g_2), defect_size_4 = fabs(off_4), defect_size_5 = fabs(g_4),
      defect_size_6 = fabs(off_6);
  const double defect_largest1 = defect_size_0 < defect_size_1 ? defect_size_1 : defect_size_0;
  const double defect_largest2 = defect_largest1 < defect_size_2 ? defect_size_2 : defect_largest1;
  const double defect_largest3 = defect_largest2 < defect_size_3 ? defect_size_3 : defect_largest2;
  const double defect_largest4 = defect_largest3 < defect_size_4 ? defect_size_4 : defect_largest3;
  const double defect_largest5 = defect_largest4 < defect_size_5 ? defect_size_5 : defect_largest4;
  const double defect_largest6 = defect_largest5 < defect_size_6 ? defect_size_6 : defect_largest5;
  return defect_largest6;
}

/* Ro = the rotation nearest to A, U diag(1, 1, ±1) V^T of A = U diag(s1, s2, s3) V^T: no
     rotation R has a larger tr R^T A or a smaller |R - A|.  For every finite A but 0, for which
     it is NaN; where several are equally near (s2 ± s3 = 0: reflections with s2 = s3, matrices
     of rank 1) one of them.
   A, Ro: rotation or other 3×3 matrix.
   649 mul, 400 add, 51 div, 32 sqrt, 37 neg, 42 abs, 60 less, 34 equal, 169 select.
   |Ro - nearest|_F <= 16 u s1 / (s2 ± s3), + if det A > 0, and |Ro^T Ro - I|_ij <= 6 u;
     measured, not proved. */
static inline void ksl_mat3x3_nearest_rotation(const ksl_mat3x3_t *A, ksl_mat3x3_t *Ro) {
  const double s_size_0 = fabs(A->m00), s_size_1 = fabs(A->m01), s_size_2 = fabs(A->m02),
      s_size_3 = fabs(A->m10), s_size_4 = fabs(A->m11), s_size_5 = fabs(A->m12),
      s_size_6 = fabs(A->m20), s_size_7 = fabs(A->m21), s_size_8 = fabs(A->m22);
  const double s_largest1 = s_size_0 < s_size_1 ? s_size_1 : s_size_0;
  const double s_largest2 = s_largest1 < s_size_2 ? s_size_2 : s_largest1;
  const double s_largest3 = s_largest2 < s_size_3 ? s_size_3 : s_largest2;
  const double s_largest4 = s_largest3 < s_size_4 ? s_size_4 : s_largest3;
  const double s_largest5 = s_largest4 < s_size_5 ? s_size_5 : s_largest4;
  const double s_largest6 = s_largest5 < s_size_6 ? s_size_6 : s_largest5;
  const double s_largest7 = s_largest6 < s_size_7 ? s_size_7 : s_largest6;
  const double s_largest8 = s_largest7 < s_size_8 ? s_size_8 : s_largest7;
  const double s_b = 6.703903964971299e+153 < s_largest8 ? 3.7291703656001034e-155 : 1.0,
      s_d = s_largest8 < 256.0 ? 1.3093562431584567e+151 : s_b,
      s = s_largest8 < 1.955159272639747e-149 ? 1.0715086071862673e+301 : s_d;
  const double scaled_s_0 = KSL_MUL(A->m00, s), scaled_s_1 = KSL_MUL(A->m01, s),
      scaled_s_2 = KSL_MUL(A->m02, s), scaled_s_3 = KSL_MUL(A->m10, s),
      scaled_s_4 = KSL_MUL(A->m11, s), scaled_s_5 = KSL_MUL(A->m12, s),
      scaled_s_6 = KSL_MUL(A->m20, s), scaled_s_7 = KSL_MUL(A->m21, s),
      scaled_s_8 = KSL_MUL(A->m22, s);
  const double turn001_aa = KSL_MUL(scaled_s_0, scaled_s_0) + KSL_MUL(scaled_s_3, scaled_s_3)
          + KSL_MUL(scaled_s_6, scaled_s_6);
  const double turn001_bb = KSL_MUL(scaled_s_1, scaled_s_1) + KSL_MUL(scaled_s_4, scaled_s_4)
          + KSL_MUL(scaled_s_7, scaled_s_7);
  const double turn001_g = KSL_MUL(scaled_s_0, scaled_s_1) + KSL_MUL(scaled_s_3, scaled_s_4)
          + KSL_MUL(scaled_s_6, scaled_s_7);
  const double turn001_apart = turn001_bb - turn001_aa;
  const double turn001_e = KSL_MUL(0.5, turn001_apart);
  const double turn001_size_g = fabs(turn001_g);
  const double turn001_size_e = fabs(turn001_e);
  const double turn001_above = turn001_size_g < turn001_size_e ? turn001_g : turn001_e;
  const double turn001_below = turn001_size_g < turn001_size_e ? turn001_e : turn001_g;
  const double turn001_divisor = turn001_below == 0.0 ? 1.0 : turn001_below;
  const double turn001_ratio = turn001_above / turn001_divisor;
  const double turn001_root = sqrt(1.0 + KSL_MUL(turn001_ratio, turn001_ratio));
  const double turn001_signed_a = -turn001_root,
      turn001_signed = turn001_ratio < 0.0 ? turn001_signed_a : turn001_root;
  const double turn001_top = turn001_size_g < turn001_size_e ? turn001_ratio : 1.0;
  const double turn001_bottom_a = turn001_ratio + turn001_signed,
      turn001_bottom_b = turn001_root + 1.0,
      turn001_bottom = turn001_size_g < turn001_size_e ? turn001_bottom_b : turn001_bottom_a;
  const double turn001_t = turn001_top / turn001_bottom;
  const double turn001_tangent = turn001_g == 0.0 ? 0.0 : turn001_t;
  const double turn001_secant = sqrt(1.0 + KSL_MUL(turn001_tangent, turn001_tangent));
  const double turn001_cosine = 1.0 / turn001_secant;
  const double turn001_sine = KSL_MUL(turn001_tangent, turn001_cosine);
  const double turn001_p = turn001_aa < turn001_bb ? turn001_sine : turn001_cosine;
  const double turn001_q_a = -turn001_cosine,
      turn001_q = turn001_aa < turn001_bb ? turn001_q_a : turn001_sine;
  const double turn001_a_0 = KSL_MUL(scaled_s_0, turn001_p) - KSL_MUL(scaled_s_1, turn001_q),
      turn001_a_1 = KSL_MUL(scaled_s_3, turn001_p) - KSL_MUL(scaled_s_4, turn001_q),
      turn001_a_2 = KSL_MUL(scaled_s_6, turn001_p) - KSL_MUL(scaled_s_7, turn001_q);
  const double turn001_b_0 = KSL_MUL(scaled_s_0, turn001_q) + KSL_MUL(scaled_s_1, turn001_p),
      turn001_b_1 = KSL_MUL(scaled_s_3, turn001_q) + KSL_MUL(scaled_s_4, turn001_p),
      turn001_b_2 = KSL_MUL(scaled_s_6, turn001_q) + KSL_MUL(scaled_s_7, turn001_p);
  const double turn002_aa = KSL_MUL(turn001_a_0, turn001_a_0) + KSL_MUL(turn001_a_1, turn001_a_1)
          + KSL_MUL(turn001_a_2, turn001_a_2);
  const double turn002_bb = KSL_MUL(scaled_s_2, scaled_s_2) + KSL_MUL(scaled_s_5, scaled_s_5)
          + KSL_MUL(scaled_s_8, scaled_s_8);
  const double turn002_g = KSL_MUL(scaled_s_2, turn001_a_0) + KSL_MUL(scaled_s_5, turn001_a_1)
          + KSL_MUL(scaled_s_8, turn001_a_2);
  const double turn002_apart = turn002_bb - turn002_aa;
  const double turn002_e = KSL_MUL(0.5, turn002_apart);
  const double turn002_size_g = fabs(turn002_g);
  const double turn002_size_e = fabs(turn002_e);
  const double turn002_above = turn002_size_g < turn002_size_e ? turn002_g : turn002_e;
  const double turn002_below = turn002_size_g < turn002_size_e ? turn002_e : turn002_g;
  const double turn002_divisor = turn002_below == 0.0 ? 1.0 : turn002_below;
  const double turn002_ratio = turn002_above / turn002_divisor;
  const double turn002_root = sqrt(1.0 + KSL_MUL(turn002_ratio, turn002_ratio));
  const double turn002_signed_a = -turn002_root,
      turn002_signed = turn002_ratio < 0.0 ? turn002_signed_a : turn002_root;
  const double turn002_top = turn002_size_g < turn002_size_e ? turn002_ratio : 1.0;
  const double turn002_bottom_a = turn002_ratio + turn002_signed,
      turn002_bottom_b = turn002_root + 1.0,
      turn002_bottom = turn002_size_g < turn002_size_e ? turn002_bottom_b : turn002_bottom_a;
  const double turn002_t = turn002_top / turn002_bottom;
  const double turn002_tangent = turn002_g == 0.0 ? 0.0 : turn002_t;
  const double turn002_secant = sqrt(1.0 + KSL_MUL(turn002_tangent, turn002_tangent));
  const double turn002_cosine = 1.0 / turn002_secant;
  const double turn002_sine = KSL_MUL(turn002_tangent, turn002_cosine);
  const double turn002_p = turn002_aa < turn002_bb ? turn002_sine : turn002_cosine;
  const double turn002_q_a = -turn002_cosine,
      turn002_q = turn002_aa < turn002_bb ? turn002_q_a : turn002_sine;
  const double turn002_a_0 = KSL_MUL(turn001_a_0, turn002_p) - KSL_MUL(scaled_s_2, turn002_q),
      turn002_a_1 = KSL_MUL(turn001_a_1, turn002_p) - KSL_MUL(scaled_s_5, turn002_q),
      turn002_a_2 = KSL_MUL(turn001_a_2, turn002_p) - KSL_MUL(scaled_s_8, turn002_q);
  const double turn002_b_0 = KSL_MUL(scaled_s_2, turn002_p) + KSL_MUL(turn001_a_0, turn002_q),
      turn002_b_1 = KSL_MUL(scaled_s_5, turn002_p) + KSL_MUL(turn001_a_1, turn002_q),
      turn002_b_2 = KSL_MUL(scaled_s_8, turn002_p) + KSL_MUL(turn001_a_2, turn002_q);
  const double turn002_c_0 = KSL_MUL(turn001_p, turn002_p),
      turn002_c_1 = -KSL_MUL(turn001_q, turn002_p);
  const double turn002_d_0 = KSL_MUL(turn001_p, turn002_q),
      turn002_d_1 = -KSL_MUL(turn001_q, turn002_q);
  const double turn012_aa = KSL_MUL(turn001_b_0, turn001_b_0) + KSL_MUL(turn001_b_1, turn001_b_1)
          + KSL_MUL(turn001_b_2, turn001_b_2);
  const double turn012_bb = KSL_MUL(turn002_b_0, turn002_b_0) + KSL_MUL(turn002_b_1, turn002_b_1)
          + KSL_MUL(turn002_b_2, turn002_b_2);
  const double turn012_g = KSL_MUL(turn001_b_0, turn002_b_0) + KSL_MUL(turn001_b_1, turn002_b_1)
          + KSL_MUL(turn001_b_2, turn002_b_2);
  const double turn012_apart = turn012_bb - turn012_aa;
  const double turn012_e = KSL_MUL(0.5, turn012_apart);
  const double turn012_size_g = fabs(turn012_g);
  const double turn012_size_e = fabs(turn012_e);
  const double turn012_above = turn012_size_g < turn012_size_e ? turn012_g : turn012_e;
  const double turn012_below = turn012_size_g < turn012_size_e ? turn012_e : turn012_g;
  const double turn012_divisor = turn012_below == 0.0 ? 1.0 : turn012_below;
  const double turn012_ratio = turn012_above / turn012_divisor;
  const double turn012_root = sqrt(1.0 + KSL_MUL(turn012_ratio, turn012_ratio));
  const double turn012_signed_a = -turn012_root,
      turn012_signed = turn012_ratio < 0.0 ? turn012_signed_a : turn012_root;
  const double turn012_top = turn012_size_g < turn012_size_e ? turn012_ratio : 1.0;
  const double turn012_bottom_a = turn012_ratio + turn012_signed,
      turn012_bottom_b = turn012_root + 1.0,
      turn012_bottom = turn012_size_g < turn012_size_e ? turn012_bottom_b : turn012_bottom_a;
  const double turn012_t = turn012_top / turn012_bottom;
  const double turn012_tangent = turn012_g == 0.0 ? 0.0 : turn012_t;
  const double turn012_secant = sqrt(1.0 + KSL_MUL(turn012_tangent, turn012_tangent));
  const double turn012_cosine = 1.0 / turn012_secant;
  const double turn012_sine = KSL_MUL(turn012_tangent, turn012_cosine);
  const double turn012_p = turn012_aa < turn012_bb ? turn012_sine : turn012_cosine;
  const double turn012_q_a = -turn012_cosine,
      turn012_q = turn012_aa < turn012_bb ? turn012_q_a : turn012_sine;
  const double turn012_a_0 = KSL_MUL(turn001_b_0, turn012_p) - KSL_MUL(turn002_b_0, turn012_q),
      turn012_a_1 = KSL_MUL(turn001_b_1, turn012_p) - KSL_MUL(turn002_b_1, turn012_q),
      turn012_a_2 = KSL_MUL(turn001_b_2, turn012_p) - KSL_MUL(turn002_b_2, turn012_q);
  const double turn012_b_0 = KSL_MUL(turn001_b_0, turn012_q) + KSL_MUL(turn002_b_0, turn012_p),
      turn012_b_1 = KSL_MUL(turn001_b_1, turn012_q) + KSL_MUL(turn002_b_1, turn012_p),
      turn012_b_2 = KSL_MUL(turn001_b_2, turn012_q) + KSL_MUL(turn002_b_2, turn012_p);
  const double turn012_c_0 = KSL_MUL(turn001_q, turn012_p) - KSL_MUL(turn002_d_0, turn012_q),
      turn012_c_1 = KSL_MUL(turn001_p, turn012_p) - KSL_MUL(turn002_d_1, turn012_q),
      turn012_c_2 = -KSL_MUL(turn002_p, turn012_q);
  const double turn012_d_0 = KSL_MUL(turn001_q, turn012_q) + KSL_MUL(turn002_d_0, turn012_p),
      turn012_d_1 = KSL_MUL(turn001_p, turn012_q) + KSL_MUL(turn002_d_1, turn012_p),
      turn012_d_2 = KSL_MUL(turn002_p, turn012_p);
  const double turn101_aa = KSL_MUL(turn002_a_0, turn002_a_0) + KSL_MUL(turn002_a_1, turn002_a_1)
          + KSL_MUL(turn002_a_2, turn002_a_2);
  const double turn101_bb = KSL_MUL(turn012_a_0, turn012_a_0) + KSL_MUL(turn012_a_1, turn012_a_1)
          + KSL_MUL(turn012_a_2, turn012_a_2);
  const double turn101_g = KSL_MUL(turn002_a_0, turn012_a_0) + KSL_MUL(turn002_a_1, turn012_a_1)
          + KSL_MUL(turn002_a_2, turn012_a_2);
  const double turn101_apart = turn101_bb - turn101_aa;
  const double turn101_e = KSL_MUL(0.5, turn101_apart);
  const double turn101_size_g = fabs(turn101_g);
  const double turn101_size_e = fabs(turn101_e);
  const double turn101_above = turn101_size_g < turn101_size_e ? turn101_g : turn101_e;
  const double turn101_below = turn101_size_g < turn101_size_e ? turn101_e : turn101_g;
  const double turn101_divisor = turn101_below == 0.0 ? 1.0 : turn101_below;
  const double turn101_ratio = turn101_above / turn101_divisor;
  const double turn101_root = sqrt(1.0 + KSL_MUL(turn101_ratio, turn101_ratio));
  const double turn101_signed_a = -turn101_root,
      turn101_signed = turn101_ratio < 0.0 ? turn101_signed_a : turn101_root;
  const double turn101_top = turn101_size_g < turn101_size_e ? turn101_ratio : 1.0;
  const double turn101_bottom_a = turn101_ratio + turn101_signed,
      turn101_bottom_b = turn101_root + 1.0,
      turn101_bottom = turn101_size_g < turn101_size_e ? turn101_bottom_b : turn101_bottom_a;
  const double turn101_t = turn101_top / turn101_bottom;
  const double turn101_tangent = turn101_g == 0.0 ? 0.0 : turn101_t;
  const double turn101_secant = sqrt(1.0 + KSL_MUL(turn101_tangent, turn101_tangent));
  const double turn101_cosine = 1.0 / turn101_secant;
  const double turn101_sine = KSL_MUL(turn101_tangent, turn101_cosine);
  const double turn101_p = turn101_aa < turn101_bb ? turn101_sine : turn101_cosine;
  const double turn101_q_a = -turn101_cosine,
      turn101_q = turn101_aa < turn101_bb ? turn101_q_a : turn101_sine;
  const double turn101_a_0 = KSL_MUL(turn002_a_0, turn101_p) - KSL_MUL(turn012_a_0, turn101_q),
      turn101_a_1 = KSL_MUL(turn002_a_1, turn101_p) - KSL_MUL(turn012_a_1, turn101_q),
      turn101_a_2 = KSL_MUL(turn002_a_2, turn101_p) - KSL_MUL(turn012_a_2, turn101_q);
  const double turn101_b_0 = KSL_MUL(turn002_a_0, turn101_q) + KSL_MUL(turn012_a_0, turn101_p),
      turn101_b_1 = KSL_MUL(turn002_a_1, turn101_q) + KSL_MUL(turn012_a_1, turn101_p),
      turn101_b_2 = KSL_MUL(turn002_a_2, turn101_q) + KSL_MUL(turn012_a_2, turn101_p);
  const double turn101_c_0 = KSL_MUL(turn002_c_0, turn101_p) - KSL_MUL(turn012_c_0, turn101_q),
      turn101_c_1 = KSL_MUL(turn002_c_1, turn101_p) - KSL_MUL(turn012_c_1, turn101_q),
      turn101_c_2 = -(KSL_MUL(turn002_q, turn101_p) + KSL_MUL(turn012_c_2, turn101_q));
  const double turn101_d_0 = KSL_MUL(turn002_c_0, turn101_q) + KSL_MUL(turn012_c_0, turn101_p),
      turn101_d_1 = KSL_MUL(turn002_c_1, turn101_q) + KSL_MUL(turn012_c_1, turn101_p),
      turn101_d_2 = KSL_MUL(turn012_c_2, turn101_p) - KSL_MUL(turn002_q, turn101_q);
  const double turn102_aa = KSL_MUL(turn101_a_0, turn101_a_0) + KSL_MUL(turn101_a_1, turn101_a_1)
          + KSL_MUL(turn101_a_2, turn101_a_2);
  const double turn102_bb = KSL_MUL(turn012_b_0, turn012_b_0) + KSL_MUL(turn012_b_1, turn012_b_1)
          + KSL_MUL(turn012_b_2, turn012_b_2);
  const double turn102_g = KSL_MUL(turn012_b_0, turn101_a_0) + KSL_MUL(turn012_b_1, turn101_a_1)
          + KSL_MUL(turn012_b_2, turn101_a_2);
  const double turn102_apart = turn102_bb - turn102_aa;
  const double turn102_e = KSL_MUL(0.5, turn102_apart);
  const double turn102_size_g = fabs(turn102_g);
  const double turn102_size_e = fabs(turn102_e);
  const double turn102_above = turn102_size_g < turn102_size_e ? turn102_g : turn102_e;
  const double turn102_below = turn102_size_g < turn102_size_e ? turn102_e : turn102_g;
  const double turn102_divisor = turn102_below == 0.0 ? 1.0 : turn102_below;
  const double turn102_ratio = turn102_above / turn102_divisor;
  const double turn102_root = sqrt(1.0 + KSL_MUL(turn102_ratio, turn102_ratio));
  const double turn102_signed_a = -turn102_root,
      turn102_signed = turn102_ratio < 0.0 ? turn102_signed_a : turn102_root;
  const double turn102_top = turn102_size_g < turn102_size_e ? turn102_ratio : 1.0;
  const double turn102_bottom_a = turn102_ratio + turn102_signed,
      turn102_bottom_b = turn102_root + 1.0,
      turn102_bottom = turn102_size_g < turn102_size_e ? turn102_bottom_b : turn102_bottom_a;
  const double turn102_t = turn102_top / turn102_bottom;
  const double turn102_tangent = turn102_g == 0.0 ? 0.0 : turn102_t;
  const double turn102_secant = sqrt(1.0 + KSL_MUL(turn102_tangent, turn102_tangent));
  const double turn102_cosine = 1.0 / turn102_secant;
  const double turn102_sine = KSL_MUL(turn102_tangent, turn102_cosine);
  const double turn102_p = turn102_aa < turn102_bb ? turn102_sine : turn102_cosine;
  const double turn102_q_a = -turn102_cosine,
      turn102_q = turn102_aa < turn102_bb ? turn102_q_a : turn102_sine;
  const double turn102_a_0 = KSL_MUL(turn101_a_0, turn102_p) - KSL_MUL(turn012_b_0, turn102_q),
      turn102_a_1 = KSL_MUL(turn101_a_1, turn102_p) - KSL_MUL(turn012_b_1, turn102_q),
      turn102_a_2 = KSL_MUL(turn101_a_2, turn102_p) - KSL_MUL(turn012_b_2, turn102_q);
  const double turn102_b_0 = KSL_MUL(turn012_b_0, turn102_p) + KSL_MUL(turn101_a_0, turn102_q),
      turn102_b_1 = KSL_MUL(turn012_b_1, turn102_p) + KSL_MUL(turn101_a_1, turn102_q),
      turn102_b_2 = KSL_MUL(turn012_b_2, turn102_p) + KSL_MUL(turn101_a_2, turn102_q);
  const double turn102_c_0 = KSL_MUL(turn101_c_0, turn102_p) - KSL_MUL(turn012_d_0, turn102_q),
      turn102_c_1 = KSL_MUL(turn101_c_1, turn102_p) - KSL_MUL(turn012_d_1, turn102_q),
      turn102_c_2 = KSL_MUL(turn101_c_2, turn102_p) - KSL_MUL(turn012_d_2, turn102_q);
  const double turn102_d_0 = KSL_MUL(turn012_d_0, turn102_p) + KSL_MUL(turn101_c_0, turn102_q),
      turn102_d_1 = KSL_MUL(turn012_d_1, turn102_p) + KSL_MUL(turn101_c_1, turn102_q),
      turn102_d_2 = KSL_MUL(turn012_d_2, turn102_p) + KSL_MUL(turn101_c_2, turn102_q);
  const double turn112_aa = KSL_MUL(turn101_b_0, turn101_b_0) + KSL_MUL(turn101_b_1, turn101_b_1)
          + KSL_MUL(turn101_b_2, turn101_b_2);
  const double turn112_bb = KSL_MUL(turn102_b_0, turn102_b_0) + KSL_MUL(turn102_b_1, turn102_b_1)
          + KSL_MUL(turn102_b_2, turn102_b_2);
  const double turn112_g = KSL_MUL(turn101_b_0, turn102_b_0) + KSL_MUL(turn101_b_1, turn102_b_1)
          + KSL_MUL(turn101_b_2, turn102_b_2);
  const double turn112_apart = turn112_bb - turn112_aa;
  const double turn112_e = KSL_MUL(0.5, turn112_apart);
  const double turn112_size_g = fabs(turn112_g);
  const double turn112_size_e = fabs(turn112_e);
  const double turn112_above = turn112_size_g < turn112_size_e ? turn112_g : turn112_e;
  const double turn112_below = turn112_size_g < turn112_size_e ? turn112_e : turn112_g;
  const double turn112_divisor = turn112_below == 0.0 ? 1.0 : turn112_below;
  const double turn112_ratio = turn112_above / turn112_divisor;
  const double turn112_root = sqrt(1.0 + KSL_MUL(turn112_ratio, turn112_ratio));
  const double turn112_signed_a = -turn112_root,
      turn112_signed = turn112_ratio < 0.0 ? turn112_signed_a : turn112_root;
  const double turn112_top = turn112_size_g < turn112_size_e ? turn112_ratio : 1.0;
  const double turn112_bottom_a = turn112_ratio + turn112_signed,
      turn112_bottom_b = turn112_root + 1.0,
      turn112_bottom = turn112_size_g < turn112_size_e ? turn112_bottom_b : turn112_bottom_a;
  const double turn112_t = turn112_top / turn112_bottom;
  const double turn112_tangent = turn112_g == 0.0 ? 0.0 : turn112_t;
  const double turn112_secant = sqrt(1.0 + KSL_MUL(turn112_tangent, turn112_tangent));
  const double turn112_cosine = 1.0 / turn112_secant;
  const double turn112_sine = KSL_MUL(turn112_tangent, turn112_cosine);
  const double turn112_p = turn112_aa < turn112_bb ? turn112_sine : turn112_cosine;
  const double turn112_q_a = -turn112_cosine,
      turn112_q = turn112_aa < turn112_bb ? turn112_q_a : turn112_sine;
  const double turn112_a_0 = KSL_MUL(turn101_b_0, turn112_p) - KSL_MUL(turn102_b_0, turn112_q),
      turn112_a_1 = KSL_MUL(turn101_b_1, turn112_p) - KSL_MUL(turn102_b_1, turn112_q),
      turn112_a_2 = KSL_MUL(turn101_b_2, turn112_p) - KSL_MUL(turn102_b_2, turn112_q);
  const double turn112_b_0 = KSL_MUL(turn101_b_0, turn112_q) + KSL_MUL(turn102_b_0, turn112_p),
      turn112_b_1 = KSL_MUL(turn101_b_1, turn112_q) + KSL_MUL(turn102_b_1, turn112_p),
      turn112_b_2 = KSL_MUL(turn101_b_2, turn112_q) + KSL_MUL(turn102_b_2, turn112_p);
  const double turn112_c_0 = KSL_MUL(turn101_d_0, turn112_p) - KSL_MUL(turn102_d_0, turn112_q),
      turn112_c_1 = KSL_MUL(turn101_d_1, turn112_p) - KSL_MUL(turn102_d_1, turn112_q),
      turn112_c_2 = KSL_MUL(turn101_d_2, turn112_p) - KSL_MUL(turn102_d_2, turn112_q);
  const double turn112_d_0 = KSL_MUL(turn101_d_0, turn112_q) + KSL_MUL(turn102_d_0, turn112_p),
      turn112_d_1 = KSL_MUL(turn101_d_1, turn112_q) + KSL_MUL(turn102_d_1, turn112_p),
      turn112_d_2 = KSL_MUL(turn101_d_2, turn112_q) + KSL_MUL(turn102_d_2, turn112_p);
  const double turn201_aa = KSL_MUL(turn102_a_0, turn102_a_0) + KSL_MUL(turn102_a_1, turn102_a_1)
          + KSL_MUL(turn102_a_2, turn102_a_2);
  const double turn201_bb = KSL_MUL(turn112_a_0, turn112_a_0) + KSL_MUL(turn112_a_1, turn112_a_1)
          + KSL_MUL(turn112_a_2, turn112_a_2);
  const double turn201_g = KSL_MUL(turn102_a_0, turn112_a_0) + KSL_MUL(turn102_a_1, turn112_a_1)
          + KSL_MUL(turn102_a_2, turn112_a_2);
  const double turn201_apart = turn201_bb - turn201_aa;
  const double turn201_e = KSL_MUL(0.5, turn201_apart);
  const double turn201_size_g = fabs(turn201_g);
  const double turn201_size_e = fabs(turn201_e);
  const double turn201_above = turn201_size_g < turn201_size_e ? turn201_g : turn201_e;
  const double turn201_below = turn201_size_g < turn201_size_e ? turn201_e : turn201_g;
  const double turn201_divisor = turn201_below == 0.0 ? 1.0 : turn201_below;
  const double turn201_ratio = turn201_above / turn201_divisor;
  const double turn201_root = sqrt(1.0 + KSL_MUL(turn201_ratio, turn201_ratio));
  const double turn201_signed_a = -turn201_root,
      turn201_signed = turn201_ratio < 0.0 ? turn201_signed_a : turn201_root;
  const double turn201_top = turn201_size_g < turn201_size_e ? turn201_ratio : 1.0;
  const double turn201_bottom_a = turn201_ratio + turn201_signed,
      turn201_bottom_b = turn201_root + 1.0,
      turn201_bottom = turn201_size_g < turn201_size_e ? turn201_bottom_b : turn201_bottom_a;
  const double turn201_t = turn201_top / turn201_bottom;
  const double turn201_tangent = turn201_g == 0.0 ? 0.0 : turn201_t;
  const double turn201_secant = sqrt(1.0 + KSL_MUL(turn201_tangent, turn201_tangent));
  const double turn201_cosine = 1.0 / turn201_secant;
  const double turn201_sine = KSL_MUL(turn201_tangent, turn201_cosine);
  const double turn201_p = turn201_aa < turn201_bb ? turn201_sine : turn201_cosine;
  const double turn201_q_a = -turn201_cosine,
      turn201_q = turn201_aa < turn201_bb ? turn201_q_a : turn201_sine;
  const double turn201_a_0 = KSL_MUL(turn102_a_0, turn201_p) - KSL_MUL(turn112_a_0, turn201_q),
      turn201_a_1 = KSL_MUL(turn102_a_1, turn201_p) - KSL_MUL(turn112_a_1, turn201_q),
      turn201_a_2 = KSL_MUL(turn102_a_2, turn201_p) - KSL_MUL(turn112_a_2, turn201_q);
  const double turn201_b_0 = KSL_MUL(turn102_a_0, turn201_q) + KSL_MUL(turn112_a_0, turn201_p),
      turn201_b_1 = KSL_MUL(turn102_a_1, turn201_q) + KSL_MUL(turn112_a_1, turn201_p),
      turn201_b_2 = KSL_MUL(turn102_a_2, turn201_q) + KSL_MUL(turn112_a_2, turn201_p);
  const double turn201_c_0 = KSL_MUL(turn102_c_0, turn201_p) - KSL_MUL(turn112_c_0, turn201_q),
      turn201_c_1 = KSL_MUL(turn102_c_1, turn201_p) - KSL_MUL(turn112_c_1, turn201_q),
      turn201_c_2 = KSL_MUL(turn102_c_2, turn201_p) - KSL_MUL(turn112_c_2, turn201_q);
  const double turn201_d_0 = KSL_MUL(turn102_c_0, turn201_q) + KSL_MUL(turn112_c_0, turn201_p),
      turn201_d_1 = KSL_MUL(turn102_c_1, turn201_q) + KSL_MUL(turn112_c_1, turn201_p),
      turn201_d_2 = KSL_MUL(turn102_c_2, turn201_q) + KSL_MUL(turn112_c_2, turn201_p);
  const double turn202_aa = KSL_MUL(turn201_a_0, turn201_a_0) + KSL_MUL(turn201_a_1, turn201_a_1)
          + KSL_MUL(turn201_a_2, turn201_a_2);
  const double turn202_bb = KSL_MUL(turn112_b_0, turn112_b_0) + KSL_MUL(turn112_b_1, turn112_b_1)
          + KSL_MUL(turn112_b_2, turn112_b_2);
  const double turn202_g = KSL_MUL(turn112_b_0, turn201_a_0) + KSL_MUL(turn112_b_1, turn201_a_1)
          + KSL_MUL(turn112_b_2, turn201_a_2);
  const double turn202_apart = turn202_bb - turn202_aa;
  const double turn202_e = KSL_MUL(0.5, turn202_apart);
  const double turn202_size_g = fabs(turn202_g);
  const double turn202_size_e = fabs(turn202_e);
  const double turn202_above = turn202_size_g < turn202_size_e ? turn202_g : turn202_e;
  const double turn202_below = turn202_size_g < turn202_size_e ? turn202_e : turn202_g;
  const double turn202_divisor = turn202_below == 0.0 ? 1.0 : turn202_below;
  const double turn202_ratio = turn202_above / turn202_divisor;
  const double turn202_root = sqrt(1.0 + KSL_MUL(turn202_ratio, turn202_ratio));
  const double turn202_signed_a = -turn202_root,
      turn202_signed = turn202_ratio < 0.0 ? turn202_signed_a : turn202_root;
  const double turn202_top = turn202_size_g < turn202_size_e ? turn202_ratio : 1.0;
  const double turn202_bottom_a = turn202_ratio + turn202_signed,
      turn202_bottom_b = turn202_root + 1.0,
      turn202_bottom = turn202_size_g < turn202_size_e ? turn202_bottom_b : turn202_bottom_a;
  const double turn202_t = turn202_top / turn202_bottom;
  const double turn202_tangent = turn202_g == 0.0 ? 0.0 : turn202_t;
  const double turn202_secant = sqrt(1.0 + KSL_MUL(turn202_tangent, turn202_tangent));
  const double turn202_cosine = 1.0 / turn202_secant;
  const double turn202_sine = KSL_MUL(turn202_tangent, turn202_cosine);
  const double turn202_p = turn202_aa < turn202_bb ? turn202_sine : turn202_cosine;
  const double turn202_q_a = -turn202_cosine,
      turn202_q = turn202_aa < turn202_bb ? turn202_q_a : turn202_sine;
  const double turn202_a_0 = KSL_MUL(turn201_a_0, turn202_p) - KSL_MUL(turn112_b_0, turn202_q),
      turn202_a_1 = KSL_MUL(turn201_a_1, turn202_p) - KSL_MUL(turn112_b_1, turn202_q),
      turn202_a_2 = KSL_MUL(turn201_a_2, turn202_p) - KSL_MUL(turn112_b_2, turn202_q);
  const double turn202_b_0 = KSL_MUL(turn112_b_0, turn202_p) + KSL_MUL(turn201_a_0, turn202_q),
      turn202_b_1 = KSL_MUL(turn112_b_1, turn202_p) + KSL_MUL(turn201_a_1, turn202_q),
      turn202_b_2 = KSL_MUL(turn112_b_2, turn202_p) + KSL_MUL(turn201_a_2, turn202_q);
  const double turn202_c_0 = KSL_MUL(turn201_c_0, turn202_p) - KSL_MUL(turn112_d_0, turn202_q),
      turn202_c_1 = KSL_MUL(turn201_c_1, turn202_p) - KSL_MUL(turn112_d_1, turn202_q),
      turn202_c_2 = KSL_MUL(turn201_c_2, turn202_p) - KSL_MUL(turn112_d_2, turn202_q);
  const double turn202_d_0 = KSL_MUL(turn112_d_0, turn202_p) + KSL_MUL(turn201_c_0, turn202_q),
      turn202_d_1 = KSL_MUL(turn112_d_1, turn202_p) + KSL_MUL(turn201_c_1, turn202_q),
      turn202_d_2 = KSL_MUL(turn112_d_2, turn202_p) + KSL_MUL(turn201_c_2, turn202_q);
  const double turn212_aa = KSL_MUL(turn201_b_0, turn201_b_0) + KSL_MUL(turn201_b_1, turn201_b_1)
          + KSL_MUL(turn201_b_2, turn201_b_2);
  const double turn212_bb = KSL_MUL(turn202_b_0, turn202_b_0) + KSL_MUL(turn202_b_1, turn202_b_1)
          + KSL_MUL(turn202_b_2, turn202_b_2);
  const double turn212_g = KSL_MUL(turn201_b_0, turn202_b_0) + KSL_MUL(turn201_b_1, turn202_b_1)
          + KSL_MUL(turn201_b_2, turn202_b_2);
  const double turn212_apart = turn212_bb - turn212_aa;
  const double turn212_e = KSL_MUL(0.5, turn212_apart);
  const double turn212_size_g = fabs(turn212_g);
  const double turn212_size_e = fabs(turn212_e);
  const double turn212_above = turn212_size_g < turn212_size_e ? turn212_g : turn212_e;
  const double turn212_below = turn212_size_g < turn212_size_e ? turn212_e : turn212_g;
  const double turn212_divisor = turn212_below == 0.0 ? 1.0 : turn212_below;
  const double turn212_ratio = turn212_above / turn212_divisor;
  const double turn212_root = sqrt(1.0 + KSL_MUL(turn212_ratio, turn212_ratio));
  const double turn212_signed_a = -turn212_root,
      turn212_signed = turn212_ratio < 0.0 ? turn212_signed_a : turn212_root;
  const double turn212_top = turn212_size_g < turn212_size_e ? turn212_ratio : 1.0;
  const double turn212_bottom_a = turn212_ratio + turn212_signed,
      turn212_bottom_b = turn212_root + 1.0,
      turn212_bottom = turn212_size_g < turn212_size_e ? turn212_bottom_b : turn212_bottom_a;
  const double turn212_t = turn212_top / turn212_bottom;
  const double turn212_tangent = turn212_g == 0.0 ? 0.0 : turn212_t;
  const double turn212_secant = sqrt(1.0 + KSL_MUL(turn212_tangent, turn212_tangent));
  const double turn212_cosine = 1.0 / turn212_secant;
  const double turn212_sine = KSL_MUL(turn212_tangent, turn212_cosine);
  const double turn212_p = turn212_aa < turn212_bb ? turn212_sine : turn212_cosine;
  const double turn212_q_a = -turn212_cosine,
      turn212_q = turn212_aa < turn212_bb ? turn212_q_a : turn212_sine;
  const double turn212_a_0 = KSL_MUL(turn201_b_0, turn212_p) - KSL_MUL(turn202_b_0, turn212_q),
      turn212_a_1 = KSL_MUL(turn201_b_1, turn212_p) - KSL_MUL(turn202_b_1, turn212_q),
      turn212_a_2 = KSL_MUL(turn201_b_2, turn212_p) - KSL_MUL(turn202_b_2, turn212_q);
  const double turn212_b_0 = KSL_MUL(turn201_b_0, turn212_q) + KSL_MUL(turn202_b_0, turn212_p),
      turn212_b_1 = KSL_MUL(turn201_b_1, turn212_q) + KSL_MUL(turn202_b_1, turn212_p),
      turn212_b_2 = KSL_MUL(turn201_b_2, turn212_q) + KSL_MUL(turn202_b_2, turn212_p);
  const double turn212_c_0 = KSL_MUL(turn201_d_0, turn212_p) - KSL_MUL(turn202_d_0, turn212_q),
      turn212_c_1 = KSL_MUL(turn201_d_1, turn212_p) - KSL_MUL(turn202_d_1, turn212_q),
      turn212_c_2 = KSL_MUL(turn201_d_2, turn212_p) - KSL_MUL(turn202_d_2, turn212_q);
  const double turn212_d_0 = KSL_MUL(turn201_d_0, turn212_q) + KSL_MUL(turn202_d_0, turn212_p),
      turn212_d_1 = KSL_MUL(turn201_d_1, turn212_q) + KSL_MUL(turn202_d_1, turn212_p),
      turn212_d_2 = KSL_MUL(turn201_d_2, turn212_q) + KSL_MUL(turn202_d_2, turn212_p);
  const double turn301_aa = KSL_MUL(turn202_a_0, turn202_a_0) + KSL_MUL(turn202_a_1, turn202_a_1)
          + KSL_MUL(turn202_a_2, turn202_a_2);
  const double turn301_bb = KSL_MUL(turn212_a_0, turn212_a_0) + KSL_MUL(turn212_a_1, turn212_a_1)
          + KSL_MUL(turn212_a_2, turn212_a_2);
  const double turn301_g = KSL_MUL(turn202_a_0, turn212_a_0) + KSL_MUL(turn202_a_1, turn212_a_1)
          + KSL_MUL(turn202_a_2, turn212_a_2);
  const double turn301_apart = turn301_bb - turn301_aa;
  const double turn301_e = KSL_MUL(0.5, turn301_apart);
  const double turn301_size_g = fabs(turn301_g);
  const double turn301_size_e = fabs(turn301_e);
  const double turn301_above = turn301_size_g < turn301_size_e ? turn301_g : turn301_e;
  const double turn301_below = turn301_size_g < turn301_size_e ? turn301_e : turn301_g;
  const double turn301_divisor = turn301_below == 0.0 ? 1.0 : turn301_below;
  const double turn301_ratio = turn301_above / turn301_divisor;
  const double turn301_root = sqrt(1.0 + KSL_MUL(turn301_ratio, turn301_ratio));
  const double turn301_signed_a = -turn301_root,
      turn301_signed = turn301_ratio < 0.0 ? turn301_signed_a : turn301_root;
  const double turn301_top = turn301_size_g < turn301_size_e ? turn301_ratio : 1.0;
  const double turn301_bottom_a = turn301_ratio + turn301_signed,
      turn301_bottom_b = turn301_root + 1.0,
      turn301_bottom = turn301_size_g < turn301_size_e ? turn301_bottom_b : turn301_bottom_a;
  const double turn301_t = turn301_top / turn301_bottom;
  const double turn301_tangent = turn301_g == 0.0 ? 0.0 : turn301_t;
  const double turn301_secant = sqrt(1.0 + KSL_MUL(turn301_tangent, turn301_tangent));
  const double turn301_cosine = 1.0 / turn301_secant;
  const double turn301_sine = KSL_MUL(turn301_tangent, turn301_cosine);
  const double turn301_p = turn301_aa < turn301_bb ? turn301_sine : turn301_cosine;
  const double turn301_q_a = -turn301_cosine,
      turn301_q = turn301_aa < turn301_bb ? turn301_q_a : turn301_sine;
  const double turn301_a_0 = KSL_MUL(turn202_a_0, turn301_p) - KSL_MUL(turn212_a_0, turn301_q),
      turn301_a_1 = KSL_MUL(turn202_a_1, turn301_p) - KSL_MUL(turn212_a_1, turn301_q),
      turn301_a_2 = KSL_MUL(turn202_a_2, turn301_p) - KSL_MUL(turn212_a_2, turn301_q);
  const double turn301_b_0 = KSL_MUL(turn202_a_0, turn301_q) + KSL_MUL(turn212_a_0, turn301_p),
      turn301_b_1 = KSL_MUL(turn202_a_1, turn301_q) + KSL_MUL(turn212_a_1, turn301_p),
      turn301_b_2 = KSL_MUL(turn202_a_2, turn301_q) + KSL_MUL(turn212_a_2, turn301_p);
  const double turn301_c_0 = KSL_MUL(turn202_c_0, turn301_p) - KSL_MUL(turn212_c_0, turn301_q),
      turn301_c_1 = KSL_MUL(turn202_c_1, turn301_p) - KSL_MUL(turn212_c_1, turn301_q),
      turn301_c_2 = KSL_MUL(turn202_c_2, turn301_p) - KSL_MUL(turn212_c_2, turn301_q);
  const double turn301_d_0 = KSL_MUL(turn202_c_0, turn301_q) + KSL_MUL(turn212_c_0, turn301_p),
      turn301_d_1 = KSL_MUL(turn202_c_1, turn301_q) + KSL_MUL(turn212_c_1, turn301_p),
      turn301_d_2 = KSL_MUL(turn202_c_2, turn301_q) + KSL_MUL(turn212_c_2, turn301_p);
  const double turn302_aa = KSL_MUL(turn301_a_0, turn301_a_0) + KSL_MUL(turn301_a_1, turn301_a_1)
          + KSL_MUL(turn301_a_2, turn301_a_2);
  const double turn302_bb = KSL_MUL(turn212_b_0, turn212_b_0) + KSL_MUL(turn212_b_1, turn212_b_1)
          + KSL_MUL(turn212_b_2, turn212_b_2);
  const double turn302_g = KSL_MUL(turn212_b_0, turn301_a_0) + KSL_MUL(turn212_b_1, turn301_a_1)
          + KSL_MUL(turn212_b_2, turn301_a_2);
  const double turn302_apart = turn302_bb - turn302_aa;
  const double turn302_e = KSL_MUL(0.5, turn302_apart);
  const double turn302_size_g = fabs(turn302_g);
  const double turn302_size_e = fabs(turn302_e);
  const double turn302_above = turn302_size_g < turn302_size_e ? turn302_g : turn302_e;
  const double turn302_below = turn302_size_g < turn302_size_e ? turn302_e : turn302_g;
  const double turn302_divisor = turn302_below == 0.0 ? 1.0 : turn302_below;
  const double turn302_ratio = turn302_above / turn302_divisor;
  const double turn302_root = sqrt(1.0 + KSL_MUL(turn302_ratio, turn302_ratio));
  const double turn302_signed_a = -turn302_root,
      turn302_signed = turn302_ratio < 0.0 ? turn302_signed_a : turn302_root;
  const double turn302_top = turn302_size_g < turn302_size_e ? turn302_ratio : 1.0;
  const double turn302_bottom_a = turn302_ratio + turn302_signed,
      turn302_bottom_b = turn302_root + 1.0,
      turn302_bottom = turn302_size_g < turn302_size_e ? turn302_bottom_b : turn302_bottom_a;
  const double turn302_t = turn302_top / turn302_bottom;
  const double turn302_tangent = turn302_g == 0.0 ? 0.0 : turn302_t;
  const double turn302_secant = sqrt(1.0 + KSL_MUL(turn302_tangent, turn302_tangent));
  const double turn302_cosine = 1.0 / turn302_secant;
  const double turn302_sine = KSL_MUL(turn302_tangent, turn302_cosine);
  const double turn302_p = turn302_aa < turn302_bb ? turn302_sine : turn302_cosine;
  const double turn302_q_a = -turn302_cosine,
      turn302_q = turn302_aa < turn302_bb ? turn302_q_a : turn302_sine;
  const double turn302_a_0 = KSL_MUL(turn301_a_0, turn302_p) - KSL_MUL(turn212_b_0, turn302_q),
      turn302_a_1 = KSL_MUL(turn301_a_1, turn302_p) - KSL_MUL(turn212_b_1, turn302_q),
      turn302_a_2 = KSL_MUL(turn301_a_2, turn302_p) - KSL_MUL(turn212_b_2, turn302_q);
  const double turn302_b_0 = KSL_MUL(turn212_b_0, turn302_p) + KSL_MUL(turn301_a_0, turn302_q),
      turn302_b_1 = KSL_MUL(turn212_b_1, turn302_p) + KSL_MUL(turn301_a_1, turn302_q),
      turn302_b_2 = KSL_MUL(turn212_b_2, turn302_p) + KSL_MUL(turn301_a_2, turn302_q);
  const double turn302_c_0 = KSL_MUL(turn301_c_0, turn302_p) - KSL_MUL(turn212_d_0, turn302_q),
      turn302_c_1 = KSL_MUL(turn301_c_1, turn302_p) - KSL_MUL(turn212_d_1, turn302_q),
      turn302_c_2 = KSL_MUL(turn301_c_2, turn302_p) - KSL_MUL(turn212_d_2, turn302_q);
  const double turn302_d_0 = KSL_MUL(turn212_d_0, turn302_p) + KSL_MUL(turn301_c_0, turn302_q),
      turn302_d_1 = KSL_MUL(turn212_d_1, turn302_p) + KSL_MUL(turn301_c_1, turn302_q),
      turn302_d_2 = KSL_MUL(turn212_d_2, turn302_p) + KSL_MUL(turn301_c_2, turn302_q);
  const double turn312_aa = KSL_MUL(turn301_b_0, turn301_b_0) + KSL_MUL(turn301_b_1, turn301_b_1)
          + KSL_MUL(turn301_b_2, turn301_b_2);
  const double turn312_bb = KSL_MUL(turn302_b_0, turn302_b_0) + KSL_MUL(turn302_b_1, turn302_b_1)
          + KSL_MUL(turn302_b_2, turn302_b_2);
  const double turn312_g = KSL_MUL(turn301_b_0, turn302_b_0) + KSL_MUL(turn301_b_1, turn302_b_1)
          + KSL_MUL(turn301_b_2, turn302_b_2);
  const double turn312_apart = turn312_bb - turn312_aa;
  const double turn312_e = KSL_MUL(0.5, turn312_apart);
  const double turn312_size_g = fabs(turn312_g);
  const double turn312_size_e = fabs(turn312_e);
  const double turn312_above = turn312_size_g < turn312_size_e ? turn312_g : turn312_e;
  const double turn312_below = turn312_size_g < turn312_size_e ? turn312_e : turn312_g;
  const double turn312_divisor = turn312_below == 0.0 ? 1.0 : turn312_below;
  const double turn312_ratio = turn312_above / turn312_divisor;
  const double turn312_root = sqrt(1.0 + KSL_MUL(turn312_ratio, turn312_ratio));
  const double turn312_signed_a = -turn312_root,
      turn312_signed = turn312_ratio < 0.0 ? turn312_signed_a : turn312_root;
  const double turn312_top = turn312_size_g < turn312_size_e ? turn312_ratio : 1.0;
  const double turn312_bottom_a = turn312_ratio + turn312_signed,
      turn312_bottom_b = turn312_root + 1.0,
      turn312_bottom = turn312_size_g < turn312_size_e ? turn312_bottom_b : turn312_bottom_a;
  const double turn312_t = turn312_top / turn312_bottom;
  const double turn312_tangent = turn312_g == 0.0 ? 0.0 : turn312_t;
  const double turn312_secant = sqrt(1.0 + KSL_MUL(turn312_tangent, turn312_tangent));
  const double turn312_cosine = 1.0 / turn312_secant;
  const double turn312_sine = KSL_MUL(turn312_tangent, turn312_cosine);
  const double turn312_p = turn312_aa < turn312_bb ? turn312_sine : turn312_cosine;
  const double turn312_q_a = -turn312_cosine,
      turn312_q = turn312_aa < turn312_bb ? turn312_q_a : turn312_sine;
  const double turn312_a_0 = KSL_MUL(turn301_b_0, turn312_p) - KSL_MUL(turn302_b_0, turn312_q),
      turn312_a_1 = KSL_MUL(turn301_b_1, turn312_p) - KSL_MUL(turn302_b_1, turn312_q),
      turn312_a_2 = KSL_MUL(turn301_b_2, turn312_p) - KSL_MUL(turn302_b_2, turn312_q);
  const double turn312_b_0 = KSL_MUL(turn301_b_0, turn312_q) + KSL_MUL(turn302_b_0, turn312_p),
      turn312_b_1 = KSL_MUL(turn301_b_1, turn312_q) + KSL_MUL(turn302_b_1, turn312_p),
      turn312_b_2 = KSL_MUL(turn301_b_2, turn312_q) + KSL_MUL(turn302_b_2, turn312_p);
  const double turn312_c_0 = KSL_MUL(turn301_d_0, turn312_p) - KSL_MUL(turn302_d_0, turn312_q),
      turn312_c_1 = KSL_MUL(turn301_d_1, turn312_p) - KSL_MUL(turn302_d_1, turn312_q),
      turn312_c_2 = KSL_MUL(turn301_d_2, turn312_p) - KSL_MUL(turn302_d_2, turn312_q);
  const double turn312_d_0 = KSL_MUL(turn301_d_0, turn312_q) + KSL_MUL(turn302_d_0, turn312_p),
      turn312_d_1 = KSL_MUL(turn301_d_1, turn312_q) + KSL_MUL(turn302_d_1, turn312_p),
      turn312_d_2 = KSL_MUL(turn301_d_2, turn312_q) + KSL_MUL(turn302_d_2, turn312_p);
  const double turn401_aa = KSL_MUL(turn302_a_0, turn302_a_0) + KSL_MUL(turn302_a_1, turn302_a_1)
          + KSL_MUL(turn302_a_2, turn302_a_2);
  const double turn401_bb = KSL_MUL(turn312_a_0, turn312_a_0) + KSL_MUL(turn312_a_1, turn312_a_1)
          + KSL_MUL(turn312_a_2, turn312_a_2);
  const double turn401_g = KSL_MUL(turn302_a_0, turn312_a_0) + KSL_MUL(turn302_a_1, turn312_a_1)
          + KSL_MUL(turn302_a_2, turn312_a_2);
  const double turn401_apart = turn401_bb - turn401_aa;
  const double turn401_e = KSL_MUL(0.5, turn401_apart);
  const double turn401_size_g = fabs(turn401_g);
  const double turn401_size_e = fabs(turn401_e);
  const double turn401_above = turn401_size_g < turn401_size_e ? turn401_g : turn401_e;
  const double turn401_below = turn401_size_g < turn401_size_e ? turn401_e : turn401_g;
  const double turn401_divisor = turn401_below == 0.0 ? 1.0 : turn401_below;
  const double turn401_ratio = turn401_above / turn401_divisor;
  const double turn401_root = sqrt(1.0 + KSL_MUL(turn401_ratio, turn401_ratio));
  const double turn401_signed_a = -turn401_root,
      turn401_signed = turn401_ratio < 0.0 ? turn401_signed_a : turn401_root;
  const double turn401_top = turn401_size_g < turn401_size_e ? turn401_ratio : 1.0;
  const double turn401_bottom_a = turn401_ratio + turn401_signed,
      turn401_bottom_b = turn401_root + 1.0,
      turn401_bottom = turn401_size_g < turn401_size_e ? turn401_bottom_b : turn401_bottom_a;
  const double turn401_t = turn401_top / turn401_bottom;
  const double turn401_tangent = turn401_g == 0.0 ? 0.0 : turn401_t;
  const double turn401_secant = sqrt(1.0 + KSL_MUL(turn401_tangent, turn401_tangent));
  const double turn401_cosine = 1.0 / turn401_secant;
  const double turn401_sine = KSL_MUL(turn401_tangent, turn401_cosine);
  const double turn401_p = turn401_aa < turn401_bb ? turn401_sine : turn401_cosine;
  const double turn401_q_a = -turn401_cosine,
      turn401_q = turn401_aa < turn401_bb ? turn401_q_a : turn401_sine;
  const double turn401_a_0 = KSL_MUL(turn302_a_0, turn401_p) - KSL_MUL(turn312_a_0, turn401_q),
      turn401_a_1 = KSL_MUL(turn302_a_1, turn401_p) - KSL_MUL(turn312_a_1, turn401_q),
      turn401_a_2 = KSL_MUL(turn302_a_2, turn401_p) - KSL_MUL(turn312_a_2, turn401_q);
  const double turn401_b_0 = KSL_MUL(turn302_a_0, turn401_q) + KSL_MUL(turn312_a_0, turn401_p),
      turn401_b_1 = KSL_MUL(turn302_a_1, turn401_q) + KSL_MUL(turn312_a_1, turn401_p),
      turn401_b_2 = KSL_MUL(turn302_a_2, turn401_q) + KSL_MUL(turn312_a_2, turn401_p);
  const double turn401_c_0 = KSL_MUL(turn302_c_0, turn401_p) - KSL_MUL(turn312_c_0, turn401_q),
      turn401_c_1 = KSL_MUL(turn302_c_1, turn401_p) - KSL_MUL(turn312_c_1, turn401_q),
      turn401_c_2 = KSL_MUL(turn302_c_2, turn401_p) - KSL_MUL(turn312_c_2, turn401_q);
  const double turn401_d_0 = KSL_MUL(turn302_c_0, turn401_q) + KSL_MUL(turn312_c_0, turn401_p),
      turn401_d_1 = KSL_MUL(turn302_c_1, turn401_q) + KSL_MUL(turn312_c_1, turn401_p),
      turn401_d_2 = KSL_MUL(turn302_c_2, turn401_q) + KSL_MUL(turn312_c_2, turn401_p);
  const double turn402_aa = KSL_MUL(turn401_a_0, turn401_a_0) + KSL_MUL(turn401_a_1, turn401_a_1)
          + KSL_MUL(turn401_a_2, turn401_a_2);
  const double turn402_bb = KSL_MUL(turn312_b_0, turn312_b_0) + KSL_MUL(turn312_b_1, turn312_b_1)
          + KSL_MUL(turn312_b_2, turn312_b_2);
  const double turn402_g = KSL_MUL(turn312_b_0, turn401_a_0) + KSL_MUL(turn312_b_1, turn401_a_1)
          + KSL_MUL(turn312_b_2, turn401_a_2);
  const double turn402_apart = turn402_bb - turn402_aa;
  const double turn402_e = KSL_MUL(0.5, turn402_apart);
  const double turn402_size_g = fabs(turn402_g);
  const double turn402_size_e = fabs(turn402_e);
  const double turn402_above = turn402_size_g < turn402_size_e ? turn402_g : turn402_e;
  const double turn402_below = turn402_size_g < turn402_size_e ? turn402_e : turn402_g;
  const double turn402_divisor = turn402_below == 0.0 ? 1.0 : turn402_below;
  const double turn402_ratio = turn402_above / turn402_divisor;
  const double turn402_root = sqrt(1.0 + KSL_MUL(turn402_ratio, turn402_ratio));
  const double turn402_signed_a = -turn402_root,
      turn402_signed = turn402_ratio < 0.0 ? turn402_signed_a : turn402_root;
  const double turn402_top = turn402_size_g < turn402_size_e ? turn402_ratio : 1.0;
  const double turn402_bottom_a = turn402_ratio + turn402_signed,
      turn402_bottom_b = turn402_root + 1.0,
      turn402_bottom = turn402_size_g < turn402_size_e ? turn402_bottom_b : turn402_bottom_a;
  const double turn402_t = turn402_top / turn402_bottom;
  const double turn402_tangent = turn402_g == 0.0 ? 0.0 : turn402_t;
  const double turn402_secant = sqrt(1.0 + KSL_MUL(turn402_tangent, turn402_tangent));
  const double turn402_cosine = 1.0 / turn402_secant;
  const double turn402_sine = KSL_MUL(turn402_tangent, turn402_cosine);
  const double turn402_p = turn402_aa < turn402_bb ? turn402_sine : turn402_cosine;
  const double turn402_q_a = -turn402_cosine,
      turn402_q = turn402_aa < turn402_bb ? turn402_q_a : turn402_sine;
  const double turn402_a_0 = KSL_MUL(turn401_a_0, turn402_p) - KSL_MUL(turn312_b_0, turn402_q),
      turn402_a_1 = KSL_MUL(turn401_a_1, turn402_p) - KSL_MUL(turn312_b_1, turn402_q),
      turn402_a_2 = KSL_MUL(turn401_a_2, turn402_p) - KSL_MUL(turn312_b_2, turn402_q);
  const double turn402_b_0 = KSL_MUL(turn312_b_0, turn402_p) + KSL_MUL(turn401_a_0, turn402_q),
      turn402_b_1 = KSL_MUL(turn312_b_1, turn402_p) + KSL_MUL(turn401_a_1, turn402_q),
      turn402_b_2 = KSL_MUL(turn312_b_2, turn402_p) + KSL_MUL(turn401_a_2, turn402_q);
  const double turn402_c_0 = KSL_MUL(turn401_c_0, turn402_p) - KSL_MUL(turn312_d_0, turn402_q),
      turn402_c_1 = KSL_MUL(turn401_c_1, turn402_p) - KSL_MUL(turn312_d_1, turn402_q),
      turn402_c_2 = KSL_MUL(turn401_c_2, turn402_p) - KSL_MUL(turn312_d_2, turn402_q);
  const double turn402_d_0 = KSL_MUL(turn312_d_0, turn402_p) + KSL_MUL(turn401_c_0, turn402_q),
      turn402_d_1 = KSL_MUL(turn312_d_1, turn402_p) + KSL_MUL(turn401_c_1, turn402_q),
      turn402_d_2 = KSL_MUL(turn312_d_2, turn402_p) + KSL_MUL(turn401_c_2, turn402_q);
  const double turn412_aa = KSL_MUL(turn401_b_0, turn401_b_0) + KSL_MUL(turn401_b_1, turn401_b_1)
          + KSL_MUL(turn401_b_2, turn401_b_2);
  const double turn412_bb = KSL_MUL(turn402_b_0, turn402_b_0) + KSL_MUL(turn402_b_1, turn402_b_1)
          + KSL_MUL(turn402_b_2, turn402_b_2);
  const double turn412_g = KSL_MUL(turn401_b_0, turn402_b_0) + KSL_MUL(turn401_b_1, turn402_b_1)
          + KSL_MUL(turn401_b_2, turn402_b_2);
  const double turn412_apart = turn412_bb - turn412_aa;
  const double turn412_e = KSL_MUL(0.5, turn412_apart);
  const double turn412_size_g = fabs(turn412_g);
  const double turn412_size_e = fabs(turn412_e);
  const double turn412_above = turn412_size_g < turn412_size_e ? turn412_g : turn412_e;
  const double turn412_below = turn412_size_g < turn412_size_e ? turn412_e : turn412_g;
  const double turn412_divisor = turn412_below == 0.0 ? 1.0 : turn412_below;
  const double turn412_ratio = turn412_above / turn412_divisor;
  const double turn412_root = sqrt(1.0 + KSL_MUL(turn412_ratio, turn412_ratio));
  const double turn412_signed_a = -turn412_root,
      turn412_signed = turn412_ratio < 0.0 ? turn412_signed_a : turn412_root;
  const double turn412_top = turn412_size_g < turn412_size_e ? turn412_ratio : 1.0;
  const double turn412_bottom_a = turn412_ratio + turn412_signed,
      turn412_bottom_b = turn412_root + 1.0,
      turn412_bottom = turn412_size_g < turn412_size_e ? turn412_bottom_b : turn412_bottom_a;
  const double turn412_t = turn412_top / turn412_bottom;
  const double turn412_tangent = turn412_g == 0.0 ? 0.0 : turn412_t;
  const double turn412_secant = sqrt(1.0 + KSL_MUL(turn412_tangent, turn412_tangent));
  const double turn412_cosine = 1.0 / turn412_secant;
  const double turn412_sine = KSL_MUL(turn412_tangent, turn412_cosine);
  const double turn412_p = turn412_aa < turn412_bb ? turn412_sine : turn412_cosine;
  const double turn412_q_a = -turn412_cosine,
      turn412_q = turn412_aa < turn412_bb ? turn412_q_a : turn412_sine;
  const double turn412_a_0 = KSL_MUL(turn401_b_0, turn412_p) - KSL_MUL(turn402_b_0, turn412_q),
      turn412_a_1 = KSL_MUL(turn401_b_1, turn412_p) - KSL_MUL(turn402_b_1, turn412_q),
      turn412_a_2 = KSL_MUL(turn401_b_2, turn412_p) - KSL_MUL(turn402_b_2, turn412_q);
  const double turn412_c_0 = KSL_MUL(turn401_d_0, turn412_p) - KSL_MUL(turn402_d_0, turn412_q),
      turn412_c_1 = KSL_MUL(turn401_d_1, turn412_p) - KSL_MUL(turn402_d_1, turn412_q),
      turn412_c_2 = KSL_MUL(turn401_d_2, turn412_p) - KSL_MUL(turn402_d_2, turn412_q);
  const double turn412_d_0 = KSL_MUL(turn401_d_0, turn412_q) + KSL_MUL(turn402_d_0, turn412_p),
      turn412_d_1 = KSL_MUL(turn401_d_1, turn412_q) + KSL_MUL(turn402_d_1, turn412_p),
      turn412_d_2 = KSL_MUL(turn401_d_2, turn412_q) + KSL_MUL(turn402_d_2, turn412_p);
  const double longest = sqrt(KSL_MUL(turn402_a_0, turn402_a_0) + KSL_MUL(turn402_a_1, turn402_a_1)
          + KSL_MUL(turn402_a_2, turn402_a_2));
  const double first_divisor = longest == 0.0 ? 1.0 : longest;
  const double u0_0 = turn402_a_0 / first_divisor, u0_1 = turn402_a_1 / first_divisor,
      u0_2 = turn402_a_2 / first_divisor;
  const double least = KSL_MUL(KSL_MUL(0.015625, KSL_MUL(1.7763568394002505e-15,
      1.7763568394002505e-15)), KSL_MUL(longest, longest));
  const double second_along = KSL_MUL(turn412_a_0, u0_0) + KSL_MUL(turn412_a_1, u0_1)
          + KSL_MUL(turn412_a_2, u0_2);
  const double second_part_0 = turn412_a_0 - KSL_MUL(u0_0, second_along),
      second_part_1 = turn412_a_1 - KSL_MUL(u0_1, second_along),
      second_part_2 = turn412_a_2 - KSL_MUL(u0_2, second_along);
  const double second_whole = KSL_MUL(turn412_a_0, turn412_a_0) + KSL_MUL(turn412_a_1, turn412_a_1)
          + KSL_MUL(turn412_a_2, turn412_a_2);
  const double second_kept = KSL_MUL(second_part_0, second_part_0)
          + KSL_MUL(second_part_1, second_part_1) + KSL_MUL(second_part_2, second_part_2);
  const double second_enough_a = KSL_MUL(0.25, second_whole),
      second_enough = second_enough_a < least ? least : second_enough_a;
  const double second_is_kept = second_enough < second_kept ? 1.0 : 0.0;
  const double second_size_0 = fabs(u0_0), second_size_1 = fabs(u0_1), second_size_2 = fabs(u0_2);
  const double second_is_y = second_size_1 < second_size_0 ? 1.0 : 0.0;
  const double second_less = second_is_y == 0.0 ? second_size_0 : second_size_1;
  const double second_is_z = second_size_2 < second_less ? 1.0 : 0.0;
  const double second_xy_0 = second_is_y == 0.0 ? 1.0 : 0.0,
      second_xy_1 = second_is_y == 0.0 ? 0.0 : 1.0;
  const double second_axis_0 = second_is_z == 1.0 ? 0.0 : second_xy_0,
      second_axis_1 = second_is_z == 1.0 ? 0.0 : second_xy_1,
      second_axis_2 = second_is_z == 1.0 ? 1.0 : 0.0;
  const double second_along_axis = KSL_MUL(u0_0, second_axis_0) + KSL_MUL(u0_1, second_axis_1)
          + KSL_MUL(u0_2, second_axis_2);
  const double second_other_0 = second_axis_0 - KSL_MUL(u0_0, second_along_axis),
      second_other_1 = second_axis_1 - KSL_MUL(u0_1, second_along_axis),
      second_other_2 = second_axis_2 - KSL_MUL(u0_2, second_along_axis);
  const double second_found_0 = second_is_kept == 1.0 ? second_part_0 : second_other_0,
      second_found_1 = second_is_kept == 1.0 ? second_part_1 : second_other_1,
      second_found_2 = second_is_kept == 1.0 ? second_part_2 : second_other_2;
  const double second_length = sqrt(KSL_MUL(second_found_0, second_found_0)
          + KSL_MUL(second_found_1, second_found_1) + KSL_MUL(second_found_2, second_found_2));
  const double second_across_0 = second_found_0 / second_length,
      second_across_1 = second_found_1 / second_length,
      second_across_2 = second_found_2 / second_length;
  const double u2_0 = KSL_MUL(u0_1, second_across_2) - KSL_MUL(u0_2, second_across_1),
      u2_1 = KSL_MUL(u0_2, second_across_0) - KSL_MUL(u0_0, second_across_2),
      u2_2 = KSL_MUL(u0_0, second_across_1) - KSL_MUL(u0_1, second_across_0);
  const double turned_0 = KSL_MUL(turn402_c_0, u0_0) + KSL_MUL(turn412_c_0, second_across_0)
          + KSL_MUL(turn412_d_0, u2_0),
      turned_1 = KSL_MUL(turn402_c_1, u0_0) + KSL_MUL(turn412_c_1, second_across_0)
          + KSL_MUL(turn412_d_1, u2_0),
      turned_2 = KSL_MUL(turn402_c_2, u0_0) + KSL_MUL(turn412_c_2, second_across_0)
          + KSL_MUL(turn412_d_2, u2_0),
      turned_3 = KSL_MUL(turn402_c_0, u0_1) + KSL_MUL(turn412_c_0, second_across_1)
          + KSL_MUL(turn412_d_0, u2_1),
      turned_4 = KSL_MUL(turn402_c_1, u0_1) + KSL_MUL(turn412_c_1, second_across_1)
          + KSL_MUL(turn412_d_1, u2_1),
      turned_5 = KSL_MUL(turn402_c_2, u0_1) + KSL_MUL(turn412_c_2, second_across_1)
          + KSL_MUL(turn412_d_2, u2_1),
      turned_6 = KSL_MUL(turn402_c_0, u0_2) + KSL_MUL(turn412_c_0, second_across_2)
          + KSL_MUL(turn412_d_0, u2_2),
      turned_7 = KSL_MUL(turn402_c_1, u0_2) + KSL_MUL(turn412_c_1, second_across_2)
          + KSL_MUL(turn412_d_1, u2_2),
      turned_8 = KSL_MUL(turn402_c_2, u0_2) + KSL_MUL(turn412_c_2, second_across_2)
          + KSL_MUL(turn412_d_2, u2_2);
  const double gram_0 = KSL_MUL(turned_0, turned_0) + KSL_MUL(turned_3, turned_3)
          + KSL_MUL(turned_6, turned_6),
      gram_1 = KSL_MUL(turned_0, turned_1) + KSL_MUL(turned_3, turned_4)
          + KSL_MUL(turned_6, turned_7),
      gram_2 = KSL_MUL(turned_0, turned_2) + KSL_MUL(turned_3, turned_5)
          + KSL_MUL(turned_6, turned_8),
      gram_3 = KSL_MUL(turned_1, turned_1) + KSL_MUL(turned_4, turned_4)
          + KSL_MUL(turned_7, turned_7),
      gram_4 = KSL_MUL(turned_1, turned_2) + KSL_MUL(turned_4, turned_5)
          + KSL_MUL(turned_7, turned_8),
      gram_5 = KSL_MUL(turned_2, turned_2) + KSL_MUL(turned_5, turned_5)
          + KSL_MUL(turned_8, turned_8);
  const double half_0 = 1.5 - KSL_MUL(0.5, gram_0), half_1 = -KSL_MUL(0.5, gram_1),
      half_2 = -KSL_MUL(0.5, gram_2), half_4 = 1.5 - KSL_MUL(0.5, gram_3),
      half_5 = -KSL_MUL(0.5, gram_4), half_8 = 1.5 - KSL_MUL(0.5, gram_5);
  const double Ro_00e = KSL_MUL(turned_0, half_0) + KSL_MUL(turned_1, half_1)
          + KSL_MUL(turned_2, half_2), Ro_00 = longest == 0.0 ? (double)NAN : Ro_00e;
  const double Ro_01e = KSL_MUL(turned_0, half_1) + KSL_MUL(turned_1, half_4)
          + KSL_MUL(turned_2, half_5), Ro_01 = longest == 0.0 ? (double)NAN : Ro_01e;
  const double Ro_02e = KSL_MUL(turned_0, half_2) + KSL_MUL(turned_1, half_5)
          + KSL_MUL(turned_2, half_8), Ro_02 = longest == 0.0 ? (double)NAN : Ro_02e;
  const double Ro_10e = KSL_MUL(turned_3, half_0) + KSL_MUL(turned_4, half_1)
          + KSL_MUL(turned_5, half_2), Ro_10 = longest == 0.0 ? (double)NAN : Ro_10e;
  const double Ro_11e = KSL_MUL(turned_3, half_1) + KSL_MUL(turned_4, half_4)
          + KSL_MUL(turned_5, half_5), Ro_11 = longest == 0.0 ? (double)NAN : Ro_11e;
  const double Ro_12e = KSL_MUL(turned_3, half_2) + KSL_MUL(turned_4, half_5)
          + KSL_MUL(turned_5, half_8), Ro_12 = longest == 0.0 ? (double)NAN : Ro_12e;
  const double Ro_20e = KSL_MUL(turned_6, half_0) + KSL_MUL(turned_7, half_1)
          + KSL_MUL(turned_8, half_2), Ro_20 = longest == 0.0 ? (double)NAN : Ro_20e;
  const double Ro_21e = KSL_MUL(turned_6, half_1) + KSL_MUL(turned_7, half_4)
          + KSL_MUL(turned_8, half_5), Ro_21 = longest == 0.0 ? (double)NAN : Ro_21e;
  const double Ro_22e = KSL_MUL(turned_6, half_2) + KSL_MUL(turned_7, half_5)
          + KSL_MUL(turned_8, half_8), Ro_22 = longest == 0.0 ? (double)NAN : Ro_22e;
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
  const double versine_b = KSL_MUL(2.0, KSL_MUL(h, h)), versine_c = 1.0 - cosine,
      versine = cosine < 0.0 ? versine_c : versine_b;
  const double beta_v_0 = KSL_MUL(axis->x, versine), beta_v_1 = KSL_MUL(axis->y, versine),
      beta_v_2 = KSL_MUL(axis->z, versine);
  const double m_0 = KSL_MUL(axis->x, beta_v_0), m_1 = KSL_MUL(axis->y, beta_v_1),
      m_2 = KSL_MUL(axis->z, beta_v_2), m_3 = KSL_MUL(axis->y, beta_v_0),
      m_4 = KSL_MUL(axis->z, beta_v_0), m_5 = KSL_MUL(axis->z, beta_v_1);
  const double others_0 = m_1 + m_2, others_1 = m_0 + m_2, others_2 = m_0 + m_1;
  const double alpha_v_0 = KSL_MUL(axis->x, sine), alpha_v_1 = KSL_MUL(axis->y, sine),
      alpha_v_2 = KSL_MUL(axis->z, sine);
  const double R_00 = 1.0 - others_0, R_01 = m_3 - alpha_v_2, R_02 = m_4 + alpha_v_1,
      R_10 = m_3 + alpha_v_2, R_11 = 1.0 - others_1, R_12 = m_5 - alpha_v_0, R_20 = m_4 - alpha_v_1,
      R_21 = m_5 + alpha_v_0, R_22 = 1.0 - others_2;
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
  const double p_0 = R->m21 - R->m12, p_1 = R->m02 - R->m20, p_2 = R->m10 - R->m01;
  const double s_0 = R->m12 + R->m21, s_1 = R->m02 + R->m20, s_2 = R->m01 + R->m10;
  const double first_0 = R->m00 + 1.0, first_1 = 1.0 - R->m00;
  const double others_0 = R->m11 + R->m22, others_1 = R->m11 - R->m22;
  const double d_0 = first_0 + others_0, d_1 = first_0 - others_0, d_2 = first_1 + others_1,
      d_3 = first_1 - others_1;
  const double low_0 = R->m11 < R->m00 ? d_1 : s_2, low_1 = R->m11 < R->m00 ? s_2 : d_2,
      low_2 = R->m11 < R->m00 ? s_1 : s_0, low_3 = R->m11 < R->m00 ? p_0 : p_1;
  const double high_0a = -R->m11, high_0 = R->m00 < high_0a ? s_1 : p_0;
  const double high_1 = R->m00 < high_0a ? s_0 : p_1, high_2 = R->m00 < high_0a ? d_3 : p_2,
      high_3 = R->m00 < high_0a ? p_2 : d_0;
  const double column_0 = R->m22 < 0.0 ? low_0 : high_0, column_1 = R->m22 < 0.0 ? low_1 : high_1,
      column_2 = R->m22 < 0.0 ? low_2 : high_2, column_3 = R->m22 < 0.0 ? low_3 : high_3;
  const double upper_0a = -column_0, upper_0 = column_3 < 0.0 ? upper_0a : column_0;
  const double upper_1a = -column_1, upper_1 = column_3 < 0.0 ? upper_1a : column_1;
  const double upper_2a = -column_2, upper_2 = column_3 < 0.0 ? upper_2a : column_2;
  const double upper_3a = -column_3, upper_3 = column_3 < 0.0 ? upper_3a : column_3;
  const double v_s_size_0 = fabs(upper_0), v_s_size_1 = fabs(upper_1), v_s_size_2 = fabs(upper_2);
  const double v_s_largest1 = v_s_size_0 < v_s_size_1 ? v_s_size_1 : v_s_size_0;
  const double v_s_largest2 = v_s_largest1 < v_s_size_2 ? v_s_size_2 : v_s_largest1;
  const double v_s_b = 6.703903964971299e+153 < v_s_largest2 ? 3.7291703656001034e-155 : 1.0,
      v_s_d = v_s_largest2 < 256.0 ? 1.3093562431584567e+151 : v_s_b,
      v_s = v_s_largest2 < 1.955159272639747e-149 ? 1.0715086071862673e+301 : v_s_d;
  const double v_y_0 = KSL_MUL(upper_0, v_s), v_y_1 = KSL_MUL(upper_1, v_s),
      v_y_2 = KSL_MUL(upper_2, v_s);
  const double v_n = sqrt(KSL_MUL(v_y_0, v_y_0) + KSL_MUL(v_y_1, v_y_1) + KSL_MUL(v_y_2, v_y_2));
  const double v_r_b = v_s < 1.0 ? 2.6815615859885194e+154 : 1.0,
      v_r_d = 1.0 < v_s ? 7.637340908749012e-152 : v_r_b,
      v_r = 1.3093562431584567e+151 < v_s ? 9.332636185032189e-302 : v_r_d;
  const double n = KSL_MUL(v_n, v_r);
  const double half = ksl_atan2(n, upper_3);
  const double divisor = v_n == 0.0 ? 1.0 : v_n;
  const double unit_0 = v_y_0 / divisor, unit_1 = v_y_1 / divisor, unit_2 = v_y_2 / divisor;
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
  const float Ro_01 = -v->z, Ro_12 = -v->x, Ro_20 = -v->y;
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
  const float ww_0 = KSL_MULF(w->x, w->x), ww_1 = KSL_MULF(w->y, w->y), ww_2 = KSL_MULF(w->z, w->z),
      ww_3 = KSL_MULF(w->x, w->y), ww_4 = KSL_MULF(w->x, w->z), ww_5 = KSL_MULF(w->y, w->z);
  const float Ro_00 = -(ww_1 + ww_2), Ro_01 = ww_3 - dw->z, Ro_02 = dw->y + ww_4,
      Ro_10 = dw->z + ww_3, Ro_11 = -(ww_0 + ww_2), Ro_12 = ww_5 - dw->x, Ro_20 = ww_4 - dw->y,
      Ro_21 = dw->x + ww_5, Ro_22 = -(ww_0 + ww_1);
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
  const float n_0 = KSL_MULF(R->m11, R->m22) - KSL_MULF(R->m12, R->m21),
      n_1 = KSL_MULF(R->m02, R->m21) - KSL_MULF(R->m01, R->m22),
      n_2 = KSL_MULF(R->m01, R->m12) - KSL_MULF(R->m02, R->m11);
  const float det = KSL_MULF(R->m00, n_0) + KSL_MULF(R->m10, n_1) + KSL_MULF(R->m20, n_2);
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
  const float R_size_0 = fabsf(R->m00), R_size_1 = fabsf(R->m01), R_size_2 = fabsf(R->m02),
      R_size_3 = fabsf(R->m10), R_size_4 = fabsf(R->m11), R_size_5 = fabsf(R->m12),
      R_size_6 = fabsf(R->m20), R_size_7 = fabsf(R->m21), R_size_8 = fabsf(R->m22);
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
  const float A_0 = KSL_MULF(R->m00, s), A_1 = KSL_MULF(R->m01, s), A_2 = KSL_MULF(R->m02, s),
      A_3 = KSL_MULF(R->m10, s), A_4 = KSL_MULF(R->m11, s), A_5 = KSL_MULF(R->m12, s),
      A_6 = KSL_MULF(R->m20, s), A_7 = KSL_MULF(R->m21, s), A_8 = KSL_MULF(R->m22, s);
  const float n0_0 = KSL_MULF(A_4, A_8) - KSL_MULF(A_5, A_7),
      n0_1 = KSL_MULF(A_2, A_7) - KSL_MULF(A_1, A_8),
      n0_2 = KSL_MULF(A_1, A_5) - KSL_MULF(A_2, A_4);
  const float n1_0 = KSL_MULF(A_5, A_6) - KSL_MULF(A_3, A_8),
      n1_1 = KSL_MULF(A_0, A_8) - KSL_MULF(A_2, A_6),
      n1_2 = KSL_MULF(A_2, A_3) - KSL_MULF(A_0, A_5);
  const float n2_0 = KSL_MULF(A_3, A_7) - KSL_MULF(A_4, A_6),
      n2_1 = KSL_MULF(A_1, A_6) - KSL_MULF(A_0, A_7),
      n2_2 = KSL_MULF(A_0, A_4) - KSL_MULF(A_1, A_3);
  const float d = KSL_MULF(A_0, n0_0) + KSL_MULF(A_3, n0_1) + KSL_MULF(A_6, n0_2);
  const float size0_0 = fabsf(A_0), size0_1 = fabsf(A_3), size0_2 = fabsf(A_6);
  const float size1_0 = fabsf(A_1), size1_1 = fabsf(A_4), size1_2 = fabsf(A_7);
  const float size2_0 = fabsf(A_2), size2_1 = fabsf(A_5), size2_2 = fabsf(A_8);
  const float permanent_d = KSL_MULF(size0_0, KSL_MULF(size1_1, size2_2)
          + KSL_MULF(size1_2, size2_1)),
      permanent_i = permanent_d
          + KSL_MULF(size0_1, KSL_MULF(size1_0, size2_2) + KSL_MULF(size1_2, size2_0)),
      permanent = permanent_i
          + KSL_MULF(size0_2, KSL_MULF(size1_0, size2_1) + KSL_MULF(size1_1, size2_0));
  const float top = KSL_MULF(R_largest8, s);
  const float spoiled = KSL_MULF(top, 1.2621775e-29f);
  const float least = KSL_MULF(permanent, 4.7683716e-07f) + KSL_MULF(spoiled, KSL_MULF(top, top));
  const float regular = least < fabsf(d) ? 1.0f : 0.0f;
  const float divisor = regular == 1.0f ? d : 1.0f;
  const float quotient_0 = n0_0 / divisor, quotient_1 = n0_1 / divisor, quotient_2 = n0_2 / divisor,
      quotient_3 = n1_0 / divisor, quotient_4 = n1_1 / divisor, quotient_5 = n1_2 / divisor,
      quotient_6 = n2_0 / divisor, quotient_7 = n2_1 / divisor, quotient_8 = n2_2 / divisor;
  const float inverse_0 = KSL_MULF(quotient_0, s), inverse_1 = KSL_MULF(quotient_1, s),
      inverse_2 = KSL_MULF(quotient_2, s), inverse_3 = KSL_MULF(quotient_3, s),
      inverse_4 = KSL_MULF(quotient_4, s), inverse_5 = KSL_MULF(quotient_5, s),
      inverse_6 = KSL_MULF(quotient_6, s), inverse_7 = KSL_MULF(quotient_7, s),
      inverse_8 = KSL_MULF(quotient_8, s);
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
  const float Ro_00 = regular == 1.0f ? inverse_0 : (float)NAN,
      Ro_01 = regular == 1.0f ? inverse_1 : (float)NAN,
      Ro_02 = regular == 1.0f ? inverse_2 : (float)NAN,
      Ro_10 = regular == 1.0f ? inverse_3 : (float)NAN,
      Ro_11 = regular == 1.0f ? inverse_4 : (float)NAN,
      Ro_12 = regular == 1.0f ? inverse_5 : (float)NAN,
      Ro_20 = regular == 1.0f ? inverse_6 : (float)NAN,
      Ro_21 = regular == 1.0f ? inverse_7 : (float)NAN,
      Ro_22 = regular == 1.0f ? inverse_8 : (float)NAN;
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
  const float q0_s_size_0 = fabsf(self->m00), q0_s_size_1 = fabsf(self->m01),
      q0_s_size_2 = fabsf(self->m02);
  const float q0_s_largest1 = q0_s_size_0 < q0_s_size_1 ? q0_s_size_1 : q0_s_size_0;
  const float q0_s_largest2 = q0_s_largest1 < q0_s_size_2 ? q0_s_size_2 : q0_s_largest1;
  const float q0_s_b = 4.611686e+18f < q0_s_largest2 ? 2.7105054e-20f : 1.0f,
      q0_s_d = q0_s_largest2 < 256.0f ? 1.8014399e+16f : q0_s_b,
      q0_s = q0_s_largest2 < 1.4210855e-14f ? 3.2451855e+32f : q0_s_d;
  const float q0_y_0 = KSL_MULF(self->m00, q0_s), q0_y_1 = KSL_MULF(self->m01, q0_s),
      q0_y_2 = KSL_MULF(self->m02, q0_s);
  const float q0_up = 1.0f < q0_s ? q0_s : 1.0f;
  const float q0_down = q0_s < 1.0f ? q0_s : 1.0f;
  const float q0_n = sqrtf(KSL_MULF(q0_y_0, q0_y_0) + KSL_MULF(q0_y_1, q0_y_1)
          + KSL_MULF(q0_y_2, q0_y_2));
  const float q0_divisor = q0_n == 0.0f ? q0_up : q0_n;
  const float q0_sized_0 = KSL_MULF(self->m00, q0_up), q0_sized_1 = KSL_MULF(self->m01, q0_up),
      q0_sized_2 = KSL_MULF(self->m02, q0_up);
  const float q0_quotient_0 = q0_sized_0 / q0_divisor, q0_quotient_1 = q0_sized_1 / q0_divisor,
      q0_quotient_2 = q0_sized_2 / q0_divisor;
  const float q0_0 = KSL_MULF(q0_quotient_0, q0_down), q0_1 = KSL_MULF(q0_quotient_1, q0_down),
      q0_2 = KSL_MULF(q0_quotient_2, q0_down);
  const float u1_s_size_0 = fabsf(self->m10), u1_s_size_1 = fabsf(self->m11),
      u1_s_size_2 = fabsf(self->m12);
  const float u1_s_largest1 = u1_s_size_0 < u1_s_size_1 ? u1_s_size_1 : u1_s_size_0;
  const float u1_s_largest2 = u1_s_largest1 < u1_s_size_2 ? u1_s_size_2 : u1_s_largest1;
  const float u1_s_b = 4.611686e+18f < u1_s_largest2 ? 2.7105054e-20f : 1.0f,
      u1_s_d = u1_s_largest2 < 256.0f ? 1.8014399e+16f : u1_s_b,
      u1_s = u1_s_largest2 < 1.4210855e-14f ? 3.2451855e+32f : u1_s_d;
  const float u1_y_0 = KSL_MULF(self->m10, u1_s), u1_y_1 = KSL_MULF(self->m11, u1_s),
      u1_y_2 = KSL_MULF(self->m12, u1_s);
  const float u1_up = 1.0f < u1_s ? u1_s : 1.0f;
  const float u1_down = u1_s < 1.0f ? u1_s : 1.0f;
  const float u1_n = sqrtf(KSL_MULF(u1_y_0, u1_y_0) + KSL_MULF(u1_y_1, u1_y_1)
          + KSL_MULF(u1_y_2, u1_y_2));
  const float u1_divisor = u1_n == 0.0f ? u1_up : u1_n;
  const float u1_sized_0 = KSL_MULF(self->m10, u1_up), u1_sized_1 = KSL_MULF(self->m11, u1_up),
      u1_sized_2 = KSL_MULF(self->m12, u1_up);
  const float u1_quotient_0 = u1_sized_0 / u1_divisor, u1_quotient_1 = u1_sized_1 / u1_divisor,
      u1_quotient_2 = u1_sized_2 / u1_divisor;
  const float u1_0 = KSL_MULF(u1_quotient_0, u1_down), u1_1 = KSL_MULF(u1_quotient_1, u1_down),
      u1_2 = KSL_MULF(u1_quotient_2, u1_down);
  const float along = KSL_MULF(q0_0, u1_0) + KSL_MULF(q0_1, u1_1) + KSL_MULF(q0_2, u1_2);
  const float once_0 = u1_0 - KSL_MULF(q0_0, along), once_1 = u1_1 - KSL_MULF(q0_1, along),
      once_2 = u1_2 - KSL_MULF(q0_2, along);
  const float rest = KSL_MULF(q0_0, once_0) + KSL_MULF(q0_1, once_1) + KSL_MULF(q0_2, once_2);
  const float twice_0 = once_0 - KSL_MULF(q0_0, rest), twice_1 = once_1 - KSL_MULF(q0_1, rest),
      twice_2 = once_2 - KSL_MULF(q0_2, rest);
  const float n = sqrtf(KSL_MULF(twice_0, twice_0) + KSL_MULF(twice_1, twice_1)
          + KSL_MULF(twice_2, twice_2));
  const float divisor = n == 0.0f ? 1.0f : n;
  const float q1_0 = twice_0 / divisor, q1_1 = twice_1 / divisor, q1_2 = twice_2 / divisor;
  const float normal_0 = KSL_MULF(q0_1, q1_2) - KSL_MULF(q0_2, q1_1),
      normal_1 = KSL_MULF(q0_2, q1_0) - KSL_MULF(q0_0, q1_2),
      normal_2 = KSL_MULF(q0_0, q1_1) - KSL_MULF(q0_1, q1_0);
  const float u2_s_size_0 = fabsf(self->m20), u2_s_size_1 = fabsf(self->m21),
      u2_s_size_2 = fabsf(self->m22);
  const float u2_s_largest1 = u2_s_size_0 < u2_s_size_1 ? u2_s_size_1 : u2_s_size_0;
  const float u2_s_largest2 = u2_s_largest1 < u2_s_size_2 ? u2_s_size_2 : u2_s_largest1;
  const float u2_s_b = 4.611686e+18f < u2_s_largest2 ? 2.7105054e-20f : 1.0f,
      u2_s_d = u2_s_largest2 < 256.0f ? 1.8014399e+16f : u2_s_b,
      u2_s = u2_s_largest2 < 1.4210855e-14f ? 3.2451855e+32f : u2_s_d;
  const float u2_y_0 = KSL_MULF(self->m20, u2_s), u2_y_1 = KSL_MULF(self->m21, u2_s),
      u2_y_2 = KSL_MULF(self->m22, u2_s);
  const float u2_up = 1.0f < u2_s ? u2_s : 1.0f;
  const float u2_down = u2_s < 1.0f ? u2_s : 1.0f;
  const float u2_n = sqrtf(KSL_MULF(u2_y_0, u2_y_0) + KSL_MULF(u2_y_1, u2_y_1)
          + KSL_MULF(u2_y_2, u2_y_2));
  const float u2_divisor = u2_n == 0.0f ? u2_up : u2_n;
  const float u2_sized_0 = KSL_MULF(self->m20, u2_up), u2_sized_1 = KSL_MULF(self->m21, u2_up),
      u2_sized_2 = KSL_MULF(self->m22, u2_up);
  const float u2_quotient_0 = u2_sized_0 / u2_divisor, u2_quotient_1 = u2_sized_1 / u2_divisor,
      u2_quotient_2 = u2_sized_2 / u2_divisor;
  const float u2_0 = KSL_MULF(u2_quotient_0, u2_down), u2_1 = KSL_MULF(u2_quotient_1, u2_down),
      u2_2 = KSL_MULF(u2_quotient_2, u2_down);
  const float side = KSL_MULF(normal_0, u2_0) + KSL_MULF(normal_1, u2_1) + KSL_MULF(normal_2, u2_2);
  const float q2_0a = -normal_0, q2_0 = side < 0.0f ? q2_0a : normal_0;
  const float q2_1a = -normal_1, q2_1 = side < 0.0f ? q2_1a : normal_1;
  const float q2_2a = -normal_2, q2_2 = side < 0.0f ? q2_2a : normal_2;
  const float size = fabsf(side);
  const float less = n < size ? n : size;
  const float dependent = less < 9.536743e-07f ? 1.0f : 0.0f;
  const float self_00_new = dependent == 1.0f ? (float)NAN : q0_0,
      self_01_new = dependent == 1.0f ? (float)NAN : q0_1,
      self_02_new = dependent == 1.0f ? (float)NAN : q0_2,
      self_10_new = dependent == 1.0f ? (float)NAN : q1_0,
      self_11_new = dependent == 1.0f ? (float)NAN : q1_1,
      self_12_new = dependent == 1.0f ? (float)NAN : q1_2,
      self_20_new = dependent == 1.0f ? (float)NAN : q2_0,
      self_21_new = dependent == 1.0f ? (float)NAN : q2_1,
      self_22_new = dependent == 1.0f ? (float)NAN : q2_2;
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
  const float q0_s_size_0 = fabsf(R->m00), q0_s_size_1 = fabsf(R->m01), q0_s_size_2 = fabsf(R->m02);
  const float q0_s_largest1 = q0_s_size_0 < q0_s_size_1 ? q0_s_size_1 : q0_s_size_0;
  const float q0_s_largest2 = q0_s_largest1 < q0_s_size_2 ? q0_s_size_2 : q0_s_largest1;
  const float q0_s_b = 4.611686e+18f < q0_s_largest2 ? 2.7105054e-20f : 1.0f,
      q0_s_d = q0_s_largest2 < 256.0f ? 1.8014399e+16f : q0_s_b,
      q0_s = q0_s_largest2 < 1.4210855e-14f ? 3.2451855e+32f : q0_s_d;
  const float q0_y_0 = KSL_MULF(R->m00, q0_s), q0_y_1 = KSL_MULF(R->m01, q0_s),
      q0_y_2 = KSL_MULF(R->m02, q0_s);
  const float q0_up = 1.0f < q0_s ? q0_s : 1.0f;
  const float q0_down = q0_s < 1.0f ? q0_s : 1.0f;
  const float q0_n = sqrtf(KSL_MULF(q0_y_0, q0_y_0) + KSL_MULF(q0_y_1, q0_y_1)
          + KSL_MULF(q0_y_2, q0_y_2));
  const float q0_divisor = q0_n == 0.0f ? q0_up : q0_n;
  const float q0_sized_0 = KSL_MULF(R->m00, q0_up), q0_sized_1 = KSL_MULF(R->m01, q0_up),
      q0_sized_2 = KSL_MULF(R->m02, q0_up);
  const float q0_quotient_0 = q0_sized_0 / q0_divisor, q0_quotient_1 = q0_sized_1 / q0_divisor,
      q0_quotient_2 = q0_sized_2 / q0_divisor;
  const float q0_0 = KSL_MULF(q0_quotient_0, q0_down), q0_1 = KSL_MULF(q0_quotient_1, q0_down),
      q0_2 = KSL_MULF(q0_quotient_2, q0_down);
  const float u1_s_size_0 = fabsf(R->m10), u1_s_size_1 = fabsf(R->m11), u1_s_size_2 = fabsf(R->m12);
  const float u1_s_largest1 = u1_s_size_0 < u1_s_size_1 ? u1_s_size_1 : u1_s_size_0;
  const float u1_s_largest2 = u1_s_largest1 < u1_s_size_2 ? u1_s_size_2 : u1_s_largest1;
  const float u1_s_b = 4.611686e+18f < u1_s_largest2 ? 2.7105054e-20f : 1.0f,
      u1_s_d = u1_s_largest2 < 256.0f ? 1.8014399e+16f : u1_s_b,
      u1_s = u1_s_largest2 < 1.4210855e-14f ? 3.2451855e+32f : u1_s_d;
  const float u1_y_0 = KSL_MULF(R->m10, u1_s), u1_y_1 = KSL_MULF(R->m11, u1_s),
      u1_y_2 = KSL_MULF(R->m12, u1_s);
  const float u1_up = 1.0f < u1_s ? u1_s : 1.0f;
  const float u1_down = u1_s < 1.0f ? u1_s : 1.0f;
  const float u1_n = sqrtf(KSL_MULF(u1_y_0, u1_y_0) + KSL_MULF(u1_y_1, u1_y_1)
          + KSL_MULF(u1_y_2, u1_y_2));
  const float u1_divisor = u1_n == 0.0f ? u1_up : u1_n;
  const float u1_sized_0 = KSL_MULF(R->m10, u1_up), u1_sized_1 = KSL_MULF(R->m11, u1_up),
      u1_sized_2 = KSL_MULF(R->m12, u1_up);
  const float u1_quotient_0 = u1_sized_0 / u1_divisor, u1_quotient_1 = u1_sized_1 / u1_divisor,
      u1_quotient_2 = u1_sized_2 / u1_divisor;
  const float u1_0 = KSL_MULF(u1_quotient_0, u1_down), u1_1 = KSL_MULF(u1_quotient_1, u1_down),
      u1_2 = KSL_MULF(u1_quotient_2, u1_down);
  const float along = KSL_MULF(q0_0, u1_0) + KSL_MULF(q0_1, u1_1) + KSL_MULF(q0_2, u1_2);
  const float once_0 = u1_0 - KSL_MULF(q0_0, along), once_1 = u1_1 - KSL_MULF(q0_1, along),
      once_2 = u1_2 - KSL_MULF(q0_2, along);
  const float rest = KSL_MULF(q0_0, once_0) + KSL_MULF(q0_1, once_1) + KSL_MULF(q0_2, once_2);
  const float twice_0 = once_0 - KSL_MULF(q0_0, rest), twice_1 = once_1 - KSL_MULF(q0_1, rest),
      twice_2 = once_2 - KSL_MULF(q0_2, rest);
  const float n = sqrtf(KSL_MULF(twice_0, twice_0) + KSL_MULF(twice_1, twice_1)
          + KSL_MULF(twice_2, twice_2));
  const float divisor = n == 0.0f ? 1.0f : n;
  const float q1_0 = twice_0 / divisor, q1_1 = twice_1 / divisor, q1_2 = twice_2 / divisor;
  const float normal_0 = KSL_MULF(q0_1, q1_2) - KSL_MULF(q0_2, q1_1),
      normal_1 = KSL_MULF(q0_2, q1_0) - KSL_MULF(q0_0, q1_2),
      normal_2 = KSL_MULF(q0_0, q1_1) - KSL_MULF(q0_1, q1_0);
  const float u2_s_size_0 = fabsf(R->m20), u2_s_size_1 = fabsf(R->m21), u2_s_size_2 = fabsf(R->m22);
  const float u2_s_largest1 = u2_s_size_0 < u2_s_size_1 ? u2_s_size_1 : u2_s_size_0;
  const float u2_s_largest2 = u2_s_largest1 < u2_s_size_2 ? u2_s_size_2 : u2_s_largest1;
  const float u2_s_b = 4.611686e+18f < u2_s_largest2 ? 2.7105054e-20f : 1.0f,
      u2_s_d = u2_s_largest2 < 256.0f ? 1.8014399e+16f : u2_s_b,
      u2_s = u2_s_largest2 < 1.4210855e-14f ? 3.2451855e+32f : u2_s_d;
  const float u2_y_0 = KSL_MULF(R->m20, u2_s), u2_y_1 = KSL_MULF(R->m21, u2_s),
      u2_y_2 = KSL_MULF(R->m22, u2_s);
  const float u2_up = 1.0f < u2_s ? u2_s : 1.0f;
  const float u2_down = u2_s < 1.0f ? u2_s : 1.0f;
  const float u2_n = sqrtf(KSL_MULF(u2_y_0, u2_y_0) + KSL_MULF(u2_y_1, u2_y_1)
          + KSL_MULF(u2_y_2, u2_y_2));
  const float u2_divisor = u2_n == 0.0f ? u2_up : u2_n;
  const float u2_sized_0 = KSL_MULF(R->m20, u2_up), u2_sized_1 = KSL_MULF(R->m21, u2_up),
      u2_sized_2 = KSL_MULF(R->m22, u2_up);
  const float u2_quotient_0 = u2_sized_0 / u2_divisor, u2_quotient_1 = u2_sized_1 / u2_divisor,
      u2_quotient_2 = u2_sized_2 / u2_divisor;
  const float u2_0 = KSL_MULF(u2_quotient_0, u2_down), u2_1 = KSL_MULF(u2_quotient_1, u2_down),
      u2_2 = KSL_MULF(u2_quotient_2, u2_down);
  const float side = KSL_MULF(normal_0, u2_0) + KSL_MULF(normal_1, u2_1) + KSL_MULF(normal_2, u2_2);
  const float q2_0a = -normal_0, q2_0 = side < 0.0f ? q2_0a : normal_0;
  const float q2_1a = -normal_1, q2_1 = side < 0.0f ? q2_1a : normal_1;
  const float q2_2a = -normal_2, q2_2 = side < 0.0f ? q2_2a : normal_2;
  const float size = fabsf(side);
  const float less = n < size ? n : size;
  const float dependent = less < 9.536743e-07f ? 1.0f : 0.0f;
  const float Ro_00 = dependent == 1.0f ? (float)NAN : q0_0,
      Ro_01 = dependent == 1.0f ? (float)NAN : q0_1, Ro_02 = dependent == 1.0f ? (float)NAN : q0_2,
      Ro_10 = dependent == 1.0f ? (float)NAN : q1_0, Ro_11 = dependent == 1.0f ? (float)NAN : q1_1,
      Ro_12 = dependent == 1.0f ? (float)NAN : q1_2, Ro_20 = dependent == 1.0f ? (float)NAN : q2_0,
      Ro_21 = dependent == 1.0f ? (float)NAN : q2_1, Ro_22 = dependent == 1.0f ? (float)NAN : q2_2;
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
  const float versine_axis_0 = KSL_MULF(axis->x, versine),
      versine_axis_1 = KSL_MULF(axis->y, versine), versine_axis_2 = KSL_MULF(axis->z, versine);
  const float m_0 = KSL_MULF(axis->x, versine_axis_0), m_1 = KSL_MULF(axis->y, versine_axis_1),
      m_2 = KSL_MULF(axis->z, versine_axis_2), m_3 = KSL_MULF(axis->y, versine_axis_0),
      m_4 = KSL_MULF(axis->z, versine_axis_0), m_5 = KSL_MULF(axis->z, versine_axis_1);
  const float sine_axis_0 = KSL_MULF(axis->x, dc[0]), sine_axis_1 = KSL_MULF(axis->y, dc[0]),
      sine_axis_2 = KSL_MULF(axis->z, dc[0]);
  const float R_00 = dc[1] + m_0, R_01 = m_3 - sine_axis_2, R_02 = m_4 + sine_axis_1,
      R_10 = m_3 + sine_axis_2, R_11 = dc[1] + m_1, R_12 = m_5 - sine_axis_0,
      R_20 = m_4 - sine_axis_1, R_21 = m_5 + sine_axis_0, R_22 = dc[1] + m_2;
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
  const float first_0 = KSL_MULF(c_1, c_2), first_1 = -KSL_MULF(s_2, c_1),
      first_6 = -KSL_MULF(s_1, c_2), first_7 = KSL_MULF(s_1, s_2);
  const float last_3 = KSL_MULF(s_2, c_0) - KSL_MULF(s_0, first_6),
      last_4 = KSL_MULF(c_0, c_2) - KSL_MULF(s_0, first_7), last_5 = -KSL_MULF(s_0, c_1),
      last_6 = KSL_MULF(s_0, s_2) + KSL_MULF(c_0, first_6),
      last_7 = KSL_MULF(s_0, c_2) + KSL_MULF(c_0, first_7), last_8 = KSL_MULF(c_0, c_1);
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
   72 mul, 91 add, 5 div, 1 sqrt, 4 neg, 6 abs, 6 copysign, 19 less, 4 equal, 46 select.
   The rotation by these angles differs from R by at most 12 u in each entry, near gimbal lock
     too; searched, not proved. */
static inline void ksl_euler_xyz_from_mat3x3f(const ksl_mat3x3f_t *R, ksl_vec3f_t *angles) {
  const float n = sqrtf(KSL_MULF(R->m00, R->m00) + KSL_MULF(R->m01, R->m01));
  const float divisor = n == 0.0f ? 1.0f : n;
  const float cosine_a = R->m00 / divisor, cosine = n == 0.0f ? 1.0f : cosine_a;
  const float sine_a = -R->m01, sine = sine_a / divisor;
  const float polar = ksl_atan2f(sine_a, R->m00);
  const float third = n == 0.0f ? 0.0f : polar;
  const float left_1 = KSL_MULF(R->m10, sine) + KSL_MULF(R->m11, cosine),
      left_2 = KSL_MULF(R->m20, sine) + KSL_MULF(R->m21, cosine);
  const float rest = R->m12 + R->m22;
  const float first = ksl_atan2f(left_2, left_1);
  const float angles_0 = rest < 1.2676506e+30f ? first : rest, angles_1 = ksl_atan2f(R->m02, n);
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
  const float first_1 = KSL_MULF(s_1, s_2), first_2 = KSL_MULF(s_1, c_2),
      first_7 = KSL_MULF(s_2, c_1), first_8 = KSL_MULF(c_1, c_2);
  const float last_3 = KSL_MULF(s_0, s_1), last_4 = KSL_MULF(c_0, c_2) - KSL_MULF(s_0, first_7),
      last_5 = -(KSL_MULF(s_0, first_8) + KSL_MULF(s_2, c_0)), last_6 = -KSL_MULF(s_1, c_0),
      last_7 = KSL_MULF(s_0, c_2) + KSL_MULF(c_0, first_7),
      last_8 = KSL_MULF(c_0, first_8) - KSL_MULF(s_0, s_2);
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
   72 mul, 91 add, 5 div, 1 sqrt, 3 neg, 6 abs, 6 copysign, 19 less, 4 equal, 46 select.
   The rotation by these angles differs from R by at most 12 u in each entry, near gimbal lock
     too; searched, not proved. */
static inline void ksl_euler_xyx_from_mat3x3f(const ksl_mat3x3f_t *R, ksl_vec3f_t *angles) {
  const float n = sqrtf(KSL_MULF(R->m01, R->m01) + KSL_MULF(R->m02, R->m02));
  const float divisor = n == 0.0f ? 1.0f : n;
  const float cosine_a = R->m02 / divisor, cosine = n == 0.0f ? 1.0f : cosine_a;
  const float sine = R->m01 / divisor;
  const float polar = ksl_atan2f(R->m01, R->m02);
  const float third = n == 0.0f ? 0.0f : polar;
  const float left_1 = KSL_MULF(R->m11, cosine) - KSL_MULF(R->m12, sine),
      left_2 = KSL_MULF(R->m21, cosine) - KSL_MULF(R->m22, sine);
  const float rest = R->m10 + R->m20;
  const float first = ksl_atan2f(left_2, left_1);
  const float angles_0 = rest < 1.2676506e+30f ? first : rest, angles_1 = ksl_atan2f(n, R->m00);
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
  const float size = magnitude + sqrtf(1.0f + KSL_MULF(theta, theta));
  const float along_a = -size, along = theta < 0.0f ? along_a : size;
  const float t_a = 1.0f / along, t = twice == 0.0f ? 0.0f : t_a;
  const float secant = sqrtf(1.0f + KSL_MULF(t, t));
  const float c = 1.0f / secant;
  const float s = KSL_MULF(t, c);
  const float change = KSL_MULF(A->m10, t);
  const float zp = KSL_MULF(A->m20, c) - KSL_MULF(A->m21, s);
  const float zq = KSL_MULF(A->m20, s) + KSL_MULF(A->m21, c);
  const float vp_0 = KSL_MULF(V->m00, c) - KSL_MULF(V->m01, s),
      vp_1 = KSL_MULF(V->m10, c) - KSL_MULF(V->m11, s),
      vp_2 = KSL_MULF(V->m20, c) - KSL_MULF(V->m21, s);
  const float vq_0 = KSL_MULF(V->m00, s) + KSL_MULF(V->m01, c),
      vq_1 = KSL_MULF(V->m10, s) + KSL_MULF(V->m11, c),
      vq_2 = KSL_MULF(V->m20, s) + KSL_MULF(V->m21, c);
  const float A_00_new = A->m11 + change, A_22_new = A->m00 - change;
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

/* the largest of |det R - 1| and |R^T R - I|_ij: 0 for a rotation, 2 for a reflection, NaN if an
     entry is NaN.
   R: rotation or other 3×3 matrix.
   27 mul, 21 add, 7 abs, 6 less, 6 select.
   Error <= 6 u near a rotation; measured, not proved. */
static inline float ksl_mat3x3f_rotation_defect(const ksl_mat3x3f_t *R) {
  const float n_0 = KSL_MULF(R->m11, R->m22) - KSL_MULF(R->m12, R->m21),
      n_1 = KSL_MULF(R->m02, R->m21) - KSL_MULF(R->m01, R->m22),
      n_2 = KSL_MULF(R->m01, R->m12) - KSL_MULF(R->m02, R->m11);
  const float det = KSL_MULF(R->m00, n_0) + KSL_MULF(R->m10, n_1) + KSL_MULF(R->m20, n_2);
  const float g_0 = KSL_MULF(R->m00, R->m00) + KSL_MULF(R->m10, R->m10) + KSL_MULF(R->m20, R->m20),
      g_1 = KSL_MULF(R->m00, R->m01) + KSL_MULF(R->m10, R->m11) + KSL_MULF(R->m20, R->m21),
      g_2 = KSL_MULF(R->m00, R->m02) + KSL_MULF(R->m10, R->m12) + KSL_MULF(R->m20, R->m22),
      g_3 = KSL_MULF(R->m01, R->m01) + KSL_MULF(R->m11, R->m11) + KSL_MULF(R->m21, R->m21),
      g_4 = KSL_MULF(R->m01, R->m02) + KSL_MULF(R->m11, R->m12) + KSL_MULF(R->m21, R->m22),
      g_5 = KSL_MULF(R->m02, R->m02) + KSL_MULF(R->m12, R->m12) + KSL_MULF(R->m22, R->m22);
  const float off_0 = det - 1.0f, off_1 = g_0 - 1.0f, off_4 = g_3 - 1.0f, off_6 = g_5 - 1.0f;
  const float defect_size_0 = fabsf(off_0), defect_size_1 = fabsf(off_1),
      defect_size_2 = fabsf(g_1), defect_size_3 = fabsf(g_2), defect_size_4 = fabsf(off_4),
      defect_size_5 = fabsf(g_4), defect_size_6 = fabsf(off_6);
  const float defect_largest1 = defect_size_0 < defect_size_1 ? defect_size_1 : defect_size_0;
  const float defect_largest2 = defect_largest1 < defect_size_2 ? defect_size_2 : defect_largest1;
  const float defect_largest3 = defect_largest2 < defect_size_3 ? defect_size_3 : defect_largest2;
  const float defect_largest4 = defect_largest3 < defect_size_4 ? defect_size_4 : defect_largest3;
  const float defect_largest5 = defect_largest4 < defect_size_5 ? defect_size_5 : defect_largest4;
  const float defect_largest6 = defect_largest5 < defect_size_6 ? defect_size_6 : defect_largest5;
  return defect_largest6;
}

/* Ro = the rotation nearest to A, U diag(1, 1, ±1) V^T of A = U diag(s1, s2, s3) V^T: no
     rotation R has a larger tr R^T A or a smaller |R - A|.  For every finite A but 0, for which
     it is NaN; where several are equally near (s2 ± s3 = 0: reflections with s2 = s3, matrices
     of rank 1) one of them.
   A, Ro: rotation or other 3×3 matrix.
   649 mul, 400 add, 51 div, 32 sqrt, 37 neg, 42 abs, 60 less, 34 equal, 169 select.
   |Ro - nearest|_F <= 16 u s1 / (s2 ± s3), + if det A > 0, and |Ro^T Ro - I|_ij <= 6 u;
     measured, not proved. */
static inline void ksl_mat3x3f_nearest_rotation(const ksl_mat3x3f_t *A, ksl_mat3x3f_t *Ro) {
  const float s_size_0 = fabsf(A->m00), s_size_1 = fabsf(A->m01), s_size_2 = fabsf(A->m02),
      s_size_3 = fabsf(A->m10), s_size_4 = fabsf(A->m11), s_size_5 = fabsf(A->m12),
      s_size_6 = fabsf(A->m20), s_size_7 = fabsf(A->m21), s_size_8 = fabsf(A->m22);
  const float s_largest1 = s_size_0 < s_size_1 ? s_size_1 : s_size_0;
  const float s_largest2 = s_largest1 < s_size_2 ? s_size_2 : s_largest1;
  const float s_largest3 = s_largest2 < s_size_3 ? s_size_3 : s_largest2;
  const float s_largest4 = s_largest3 < s_size_4 ? s_size_4 : s_largest3;
  const float s_largest5 = s_largest4 < s_size_5 ? s_size_5 : s_largest4;
  const float s_largest6 = s_largest5 < s_size_6 ? s_size_6 : s_largest5;
  const float s_largest7 = s_largest6 < s_size_7 ? s_size_7 : s_largest6;
  const float s_largest8 = s_largest7 < s_size_8 ? s_size_8 : s_largest7;
  const float s_b = 4.611686e+18f < s_largest8 ? 2.7105054e-20f : 1.0f,
      s_d = s_largest8 < 256.0f ? 1.8014399e+16f : s_b,
      s = s_largest8 < 1.4210855e-14f ? 3.2451855e+32f : s_d;
  const float scaled_s_0 = KSL_MULF(A->m00, s), scaled_s_1 = KSL_MULF(A->m01, s),
      scaled_s_2 = KSL_MULF(A->m02, s), scaled_s_3 = KSL_MULF(A->m10, s),
      scaled_s_4 = KSL_MULF(A->m11, s), scaled_s_5 = KSL_MULF(A->m12, s),
      scaled_s_6 = KSL_MULF(A->m20, s), scaled_s_7 = KSL_MULF(A->m21, s),
      scaled_s_8 = KSL_MULF(A->m22, s);
  const float turn001_aa = KSL_MULF(scaled_s_0, scaled_s_0) + KSL_MULF(scaled_s_3, scaled_s_3)
          + KSL_MULF(scaled_s_6, scaled_s_6);
  const float turn001_bb = KSL_MULF(scaled_s_1, scaled_s_1) + KSL_MULF(scaled_s_4, scaled_s_4)
          + KSL_MULF(scaled_s_7, scaled_s_7);
  const float turn001_g = KSL_MULF(scaled_s_0, scaled_s_1) + KSL_MULF(scaled_s_3, scaled_s_4)
          + KSL_MULF(scaled_s_6, scaled_s_7);
  const float turn001_apart = turn001_bb - turn001_aa;
  const float turn001_e = KSL_MULF(0.5f, turn001_apart);
  const float turn001_size_g = fabsf(turn001_g);
  const float turn001_size_e = fabsf(turn001_e);
  const float turn001_above = turn001_size_g < turn001_size_e ? turn001_g : turn001_e;
  const float turn001_below = turn001_size_g < turn001_size_e ? turn001_e : turn001_g;
  const float turn001_divisor = turn001_below == 0.0f ? 1.0f : turn001_below;
  const float turn001_ratio = turn001_above / turn001_divisor;
  const float turn001_root = sqrtf(1.0f + KSL_MULF(turn001_ratio, turn001_ratio));
  const float turn001_signed_a = -turn001_root,
      turn001_signed = turn001_ratio < 0.0f ? turn001_signed_a : turn001_root;
  const float turn001_top = turn001_size_g < turn001_size_e ? turn001_ratio : 1.0f;
  const float turn001_bottom_a = turn001_ratio + turn001_signed,
      turn001_bottom_b = turn001_root + 1.0f,
      turn001_bottom = turn001_size_g < turn001_size_e ? turn001_bottom_b : turn001_bottom_a;
  const float turn001_t = turn001_top / turn001_bottom;
  const float turn001_tangent = turn001_g == 0.0f ? 0.0f : turn001_t;
  const float turn001_secant = sqrtf(1.0f + KSL_MULF(turn001_tangent, turn001_tangent));
  const float turn001_cosine = 1.0f / turn001_secant;
  const float turn001_sine = KSL_MULF(turn001_tangent, turn001_cosine);
  const float turn001_p = turn001_aa < turn001_bb ? turn001_sine : turn001_cosine;
  const float turn001_q_a = -turn001_cosine,
      turn001_q = turn001_aa < turn001_bb ? turn001_q_a : turn001_sine;
  const float turn001_a_0 = KSL_MULF(scaled_s_0, turn001_p) - KSL_MULF(scaled_s_1, turn001_q),
      turn001_a_1 = KSL_MULF(scaled_s_3, turn001_p) - KSL_MULF(scaled_s_4, turn001_q),
      turn001_a_2 = KSL_MULF(scaled_s_6, turn001_p) - KSL_MULF(scaled_s_7, turn001_q);
  const float turn001_b_0 = KSL_MULF(scaled_s_0, turn001_q) + KSL_MULF(scaled_s_1, turn001_p),
      turn001_b_1 = KSL_MULF(scaled_s_3, turn001_q) + KSL_MULF(scaled_s_4, turn001_p),
      turn001_b_2 = KSL_MULF(scaled_s_6, turn001_q) + KSL_MULF(scaled_s_7, turn001_p);
  const float turn002_aa = KSL_MULF(turn001_a_0, turn001_a_0) + KSL_MULF(turn001_a_1, turn001_a_1)
          + KSL_MULF(turn001_a_2, turn001_a_2);
  const float turn002_bb = KSL_MULF(scaled_s_2, scaled_s_2) + KSL_MULF(scaled_s_5, scaled_s_5)
          + KSL_MULF(scaled_s_8, scaled_s_8);
  const float turn002_g = KSL_MULF(scaled_s_2, turn001_a_0) + KSL_MULF(scaled_s_5, turn001_a_1)
          + KSL_MULF(scaled_s_8, turn001_a_2);
  const float turn002_apart = turn002_bb - turn002_aa;
  const float turn002_e = KSL_MULF(0.5f, turn002_apart);
  const float turn002_size_g = fabsf(turn002_g);
  const float turn002_size_e = fabsf(turn002_e);
  const float turn002_above = turn002_size_g < turn002_size_e ? turn002_g : turn002_e;
  const float turn002_below = turn002_size_g < turn002_size_e ? turn002_e : turn002_g;
  const float turn002_divisor = turn002_below == 0.0f ? 1.0f : turn002_below;
  const float turn002_ratio = turn002_above / turn002_divisor;
  const float turn002_root = sqrtf(1.0f + KSL_MULF(turn002_ratio, turn002_ratio));
  const float turn002_signed_a = -turn002_root,
      turn002_signed = turn002_ratio < 0.0f ? turn002_signed_a : turn002_root;
  const float turn002_top = turn002_size_g < turn002_size_e ? turn002_ratio : 1.0f;
  const float turn002_bottom_a = turn002_ratio + turn002_signed,
      turn002_bottom_b = turn002_root + 1.0f,
      turn002_bottom = turn002_size_g < turn002_size_e ? turn002_bottom_b : turn002_bottom_a;
  const float turn002_t = turn002_top / turn002_bottom;
  const float turn002_tangent = turn002_g == 0.0f ? 0.0f : turn002_t;
  const float turn002_secant = sqrtf(1.0f + KSL_MULF(turn002_tangent, turn002_tangent));
  const float turn002_cosine = 1.0f / turn002_secant;
  const float turn002_sine = KSL_MULF(turn002_tangent, turn002_cosine);
  const float turn002_p = turn002_aa < turn002_bb ? turn002_sine : turn002_cosine;
  const float turn002_q_a = -turn002_cosine,
      turn002_q = turn002_aa < turn002_bb ? turn002_q_a : turn002_sine;
  const float turn002_a_0 = KSL_MULF(turn001_a_0, turn002_p) - KSL_MULF(scaled_s_2, turn002_q),
      turn002_a_1 = KSL_MULF(turn001_a_1, turn002_p) - KSL_MULF(scaled_s_5, turn002_q),
      turn002_a_2 = KSL_MULF(turn001_a_2, turn002_p) - KSL_MULF(scaled_s_8, turn002_q);
  const float turn002_b_0 = KSL_MULF(scaled_s_2, turn002_p) + KSL_MULF(turn001_a_0, turn002_q),
      turn002_b_1 = KSL_MULF(scaled_s_5, turn002_p) + KSL_MULF(turn001_a_1, turn002_q),
      turn002_b_2 = KSL_MULF(scaled_s_8, turn002_p) + KSL_MULF(turn001_a_2, turn002_q);
  const float turn002_c_0 = KSL_MULF(turn001_p, turn002_p),
      turn002_c_1 = -KSL_MULF(turn001_q, turn002_p);
  const float turn002_d_0 = KSL_MULF(turn001_p, turn002_q),
      turn002_d_1 = -KSL_MULF(turn001_q, turn002_q);
  const float turn012_aa = KSL_MULF(turn001_b_0, turn001_b_0) + KSL_MULF(turn001_b_1, turn001_b_1)
          + KSL_MULF(turn001_b_2, turn001_b_2);
  const float turn012_bb = KSL_MULF(turn002_b_0, turn002_b_0) + KSL_MULF(turn002_b_1, turn002_b_1)
          + KSL_MULF(turn002_b_2, turn002_b_2);
  const float turn012_g = KSL_MULF(turn001_b_0, turn002_b_0) + KSL_MULF(turn001_b_1, turn002_b_1)
          + KSL_MULF(turn001_b_2, turn002_b_2);
  const float turn012_apart = turn012_bb - turn012_aa;
  const float turn012_e = KSL_MULF(0.5f, turn012_apart);
  const float turn012_size_g = fabsf(turn012_g);
  const float turn012_size_e = fabsf(turn012_e);
  const float turn012_above = turn012_size_g < turn012_size_e ? turn012_g : turn012_e;
  const float turn012_below = turn012_size_g < turn012_size_e ? turn012_e : turn012_g;
  const float turn012_divisor = turn012_below == 0.0f ? 1.0f : turn012_below;
  const float turn012_ratio = turn012_above / turn012_divisor;
  const float turn012_root = sqrtf(1.0f + KSL_MULF(turn012_ratio, turn012_ratio));
  const float turn012_signed_a = -turn012_root,
      turn012_signed = turn012_ratio < 0.0f ? turn012_signed_a : turn012_root;
  const float turn012_top = turn012_size_g < turn012_size_e ? turn012_ratio : 1.0f;
  const float turn012_bottom_a = turn012_ratio + turn012_signed,
      turn012_bottom_b = turn012_root + 1.0f,
      turn012_bottom = turn012_size_g < turn012_size_e ? turn012_bottom_b : turn012_bottom_a;
  const float turn012_t = turn012_top / turn012_bottom;
  const float turn012_tangent = turn012_g == 0.0f ? 0.0f : turn012_t;
  const float turn012_secant = sqrtf(1.0f + KSL_MULF(turn012_tangent, turn012_tangent));
  const float turn012_cosine = 1.0f / turn012_secant;
  const float turn012_sine = KSL_MULF(turn012_tangent, turn012_cosine);
  const float turn012_p = turn012_aa < turn012_bb ? turn012_sine : turn012_cosine;
  const float turn012_q_a = -turn012_cosine,
      turn012_q = turn012_aa < turn012_bb ? turn012_q_a : turn012_sine;
  const float turn012_a_0 = KSL_MULF(turn001_b_0, turn012_p) - KSL_MULF(turn002_b_0, turn012_q),
      turn012_a_1 = KSL_MULF(turn001_b_1, turn012_p) - KSL_MULF(turn002_b_1, turn012_q),
      turn012_a_2 = KSL_MULF(turn001_b_2, turn012_p) - KSL_MULF(turn002_b_2, turn012_q);
  const float turn012_b_0 = KSL_MULF(turn001_b_0, turn012_q) + KSL_MULF(turn002_b_0, turn012_p),
      turn012_b_1 = KSL_MULF(turn001_b_1, turn012_q) + KSL_MULF(turn002_b_1, turn012_p),
      turn012_b_2 = KSL_MULF(turn001_b_2, turn012_q) + KSL_MULF(turn002_b_2, turn012_p);
  const float turn012_c_0 = KSL_MULF(turn001_q, turn012_p) - KSL_MULF(turn002_d_0, turn012_q),
      turn012_c_1 = KSL_MULF(turn001_p, turn012_p) - KSL_MULF(turn002_d_1, turn012_q),
      turn012_c_2 = -KSL_MULF(turn002_p, turn012_q);
  const float turn012_d_0 = KSL_MULF(turn001_q, turn012_q) + KSL_MULF(turn002_d_0, turn012_p),
      turn012_d_1 = KSL_MULF(turn001_p, turn012_q) + KSL_MULF(turn002_d_1, turn012_p),
      turn012_d_2 = KSL_MULF(turn002_p, turn012_p);
  const float turn101_aa = KSL_MULF(turn002_a_0, turn002_a_0) + KSL_MULF(turn002_a_1, turn002_a_1)
          + KSL_MULF(turn002_a_2, turn002_a_2);
  const float turn101_bb = KSL_MULF(turn012_a_0, turn012_a_0) + KSL_MULF(turn012_a_1, turn012_a_1)
          + KSL_MULF(turn012_a_2, turn012_a_2);
  const float turn101_g = KSL_MULF(turn002_a_0, turn012_a_0) + KSL_MULF(turn002_a_1, turn012_a_1)
          + KSL_MULF(turn002_a_2, turn012_a_2);
  const float turn101_apart = turn101_bb - turn101_aa;
  const float turn101_e = KSL_MULF(0.5f, turn101_apart);
  const float turn101_size_g = fabsf(turn101_g);
  const float turn101_size_e = fabsf(turn101_e);
  const float turn101_above = turn101_size_g < turn101_size_e ? turn101_g : turn101_e;
  const float turn101_below = turn101_size_g < turn101_size_e ? turn101_e : turn101_g;
  const float turn101_divisor = turn101_below == 0.0f ? 1.0f : turn101_below;
  const float turn101_ratio = turn101_above / turn101_divisor;
  const float turn101_root = sqrtf(1.0f + KSL_MULF(turn101_ratio, turn101_ratio));
  const float turn101_signed_a = -turn101_root,
      turn101_signed = turn101_ratio < 0.0f ? turn101_signed_a : turn101_root;
  const float turn101_top = turn101_size_g < turn101_size_e ? turn101_ratio : 1.0f;
  const float turn101_bottom_a = turn101_ratio + turn101_signed,
      turn101_bottom_b = turn101_root + 1.0f,
      turn101_bottom = turn101_size_g < turn101_size_e ? turn101_bottom_b : turn101_bottom_a;
  const float turn101_t = turn101_top / turn101_bottom;
  const float turn101_tangent = turn101_g == 0.0f ? 0.0f : turn101_t;
  const float turn101_secant = sqrtf(1.0f + KSL_MULF(turn101_tangent, turn101_tangent));
  const float turn101_cosine = 1.0f / turn101_secant;
  const float turn101_sine = KSL_MULF(turn101_tangent, turn101_cosine);
  const float turn101_p = turn101_aa < turn101_bb ? turn101_sine : turn101_cosine;
  const float turn101_q_a = -turn101_cosine,
      turn101_q = turn101_aa < turn101_bb ? turn101_q_a : turn101_sine;
  const float turn101_a_0 = KSL_MULF(turn002_a_0, turn101_p) - KSL_MULF(turn012_a_0, turn101_q),
      turn101_a_1 = KSL_MULF(turn002_a_1, turn101_p) - KSL_MULF(turn012_a_1, turn101_q),
      turn101_a_2 = KSL_MULF(turn002_a_2, turn101_p) - KSL_MULF(turn012_a_2, turn101_q);
  const float turn101_b_0 = KSL_MULF(turn002_a_0, turn101_q) + KSL_MULF(turn012_a_0, turn101_p),
      turn101_b_1 = KSL_MULF(turn002_a_1, turn101_q) + KSL_MULF(turn012_a_1, turn101_p),
      turn101_b_2 = KSL_MULF(turn002_a_2, turn101_q) + KSL_MULF(turn012_a_2, turn101_p);
  const float turn101_c_0 = KSL_MULF(turn002_c_0, turn101_p) - KSL_MULF(turn012_c_0, turn101_q),
      turn101_c_1 = KSL_MULF(turn002_c_1, turn101_p) - KSL_MULF(turn012_c_1, turn101_q),
      turn101_c_2 = -(KSL_MULF(turn002_q, turn101_p) + KSL_MULF(turn012_c_2, turn101_q));
  const float turn101_d_0 = KSL_MULF(turn002_c_0, turn101_q) + KSL_MULF(turn012_c_0, turn101_p),
      turn101_d_1 = KSL_MULF(turn002_c_1, turn101_q) + KSL_MULF(turn012_c_1, turn101_p),
      turn101_d_2 = KSL_MULF(turn012_c_2, turn101_p) - KSL_MULF(turn002_q, turn101_q);
  const float turn102_aa = KSL_MULF(turn101_a_0, turn101_a_0) + KSL_MULF(turn101_a_1, turn101_a_1)
          + KSL_MULF(turn101_a_2, turn101_a_2);
  const float turn102_bb = KSL_MULF(turn012_b_0, turn012_b_0) + KSL_MULF(turn012_b_1, turn012_b_1)
          + KSL_MULF(turn012_b_2, turn012_b_2);
  const float turn102_g = KSL_MULF(turn012_b_0, turn101_a_0) + KSL_MULF(turn012_b_1, turn101_a_1)
          + KSL_MULF(turn012_b_2, turn101_a_2);
  const float turn102_apart = turn102_bb - turn102_aa;
  const float turn102_e = KSL_MULF(0.5f, turn102_apart);
  const float turn102_size_g = fabsf(turn102_g);
  const float turn102_size_e = fabsf(turn102_e);
  const float turn102_above = turn102_size_g < turn102_size_e ? turn102_g : turn102_e;
  const float turn102_below = turn102_size_g < turn102_size_e ? turn102_e : turn102_g;
  const float turn102_divisor = turn102_below == 0.0f ? 1.0f : turn102_below;
  const float turn102_ratio = turn102_above / turn102_divisor;
  const float turn102_root = sqrtf(1.0f + KSL_MULF(turn102_ratio, turn102_ratio));
  const float turn102_signed_a = -turn102_root,
      turn102_signed = turn102_ratio < 0.0f ? turn102_signed_a : turn102_root;
  const float turn102_top = turn102_size_g < turn102_size_e ? turn102_ratio : 1.0f;
  const float turn102_bottom_a = turn102_ratio + turn102_signed,
      turn102_bottom_b = turn102_root + 1.0f,
      turn102_bottom = turn102_size_g < turn102_size_e ? turn102_bottom_b : turn102_bottom_a;
  const float turn102_t = turn102_top / turn102_bottom;
  const float turn102_tangent = turn102_g == 0.0f ? 0.0f : turn102_t;
  const float turn102_secant = sqrtf(1.0f + KSL_MULF(turn102_tangent, turn102_tangent));
  const float turn102_cosine = 1.0f / turn102_secant;
  const float turn102_sine = KSL_MULF(turn102_tangent, turn102_cosine);
  const float turn102_p = turn102_aa < turn102_bb ? turn102_sine : turn102_cosine;
  const float turn102_q_a = -turn102_cosine,
      turn102_q = turn102_aa < turn102_bb ? turn102_q_a : turn102_sine;
  const float turn102_a_0 = KSL_MULF(turn101_a_0, turn102_p) - KSL_MULF(turn012_b_0, turn102_q),
      turn102_a_1 = KSL_MULF(turn101_a_1, turn102_p) - KSL_MULF(turn012_b_1, turn102_q),
      turn102_a_2 = KSL_MULF(turn101_a_2, turn102_p) - KSL_MULF(turn012_b_2, turn102_q);
  const float turn102_b_0 = KSL_MULF(turn012_b_0, turn102_p) + KSL_MULF(turn101_a_0, turn102_q),
      turn102_b_1 = KSL_MULF(turn012_b_1, turn102_p) + KSL_MULF(turn101_a_1, turn102_q),
      turn102_b_2 = KSL_MULF(turn012_b_2, turn102_p) + KSL_MULF(turn101_a_2, turn102_q);
  const float turn102_c_0 = KSL_MULF(turn101_c_0, turn102_p) - KSL_MULF(turn012_d_0, turn102_q),
      turn102_c_1 = KSL_MULF(turn101_c_1, turn102_p) - KSL_MULF(turn012_d_1, turn102_q),
      turn102_c_2 = KSL_MULF(turn101_c_2, turn102_p) - KSL_MULF(turn012_d_2, turn102_q);
  const float turn102_d_0 = KSL_MULF(turn012_d_0, turn102_p) + KSL_MULF(turn101_c_0, turn102_q),
      turn102_d_1 = KSL_MULF(turn012_d_1, turn102_p) + KSL_MULF(turn101_c_1, turn102_q),
      turn102_d_2 = KSL_MULF(turn012_d_2, turn102_p) + KSL_MULF(turn101_c_2, turn102_q);
  const float turn112_aa = KSL_MULF(turn101_b_0, turn101_b_0) + KSL_MULF(turn101_b_1, turn101_b_1)
          + KSL_MULF(turn101_b_2, turn101_b_2);
  const float turn112_bb = KSL_MULF(turn102_b_0, turn102_b_0) + KSL_MULF(turn102_b_1, turn102_b_1)
          + KSL_MULF(turn102_b_2, turn102_b_2);
  const float turn112_g = KSL_MULF(turn101_b_0, turn102_b_0) + KSL_MULF(turn101_b_1, turn102_b_1)
          + KSL_MULF(turn101_b_2, turn102_b_2);
  const float turn112_apart = turn112_bb - turn112_aa;
  const float turn112_e = KSL_MULF(0.5f, turn112_apart);
  const float turn112_size_g = fabsf(turn112_g);
  const float turn112_size_e = fabsf(turn112_e);
  const float turn112_above = turn112_size_g < turn112_size_e ? turn112_g : turn112_e;
  const float turn112_below = turn112_size_g < turn112_size_e ? turn112_e : turn112_g;
  const float turn112_divisor = turn112_below == 0.0f ? 1.0f : turn112_below;
  const float turn112_ratio = turn112_above / turn112_divisor;
  const float turn112_root = sqrtf(1.0f + KSL_MULF(turn112_ratio, turn112_ratio));
  const float turn112_signed_a = -turn112_root,
      turn112_signed = turn112_ratio < 0.0f ? turn112_signed_a : turn112_root;
  const float turn112_top = turn112_size_g < turn112_size_e ? turn112_ratio : 1.0f;
  const float turn112_bottom_a = turn112_ratio + turn112_signed,
      turn112_bottom_b = turn112_root + 1.0f,
      turn112_bottom = turn112_size_g < turn112_size_e ? turn112_bottom_b : turn112_bottom_a;
  const float turn112_t = turn112_top / turn112_bottom;
  const float turn112_tangent = turn112_g == 0.0f ? 0.0f : turn112_t;
  const float turn112_secant = sqrtf(1.0f + KSL_MULF(turn112_tangent, turn112_tangent));
  const float turn112_cosine = 1.0f / turn112_secant;
  const float turn112_sine = KSL_MULF(turn112_tangent, turn112_cosine);
  const float turn112_p = turn112_aa < turn112_bb ? turn112_sine : turn112_cosine;
  const float turn112_q_a = -turn112_cosine,
      turn112_q = turn112_aa < turn112_bb ? turn112_q_a : turn112_sine;
  const float turn112_a_0 = KSL_MULF(turn101_b_0, turn112_p) - KSL_MULF(turn102_b_0, turn112_q),
      turn112_a_1 = KSL_MULF(turn101_b_1, turn112_p) - KSL_MULF(turn102_b_1, turn112_q),
      turn112_a_2 = KSL_MULF(turn101_b_2, turn112_p) - KSL_MULF(turn102_b_2, turn112_q);
  const float turn112_b_0 = KSL_MULF(turn101_b_0, turn112_q) + KSL_MULF(turn102_b_0, turn112_p),
      turn112_b_1 = KSL_MULF(turn101_b_1, turn112_q) + KSL_MULF(turn102_b_1, turn112_p),
      turn112_b_2 = KSL_MULF(turn101_b_2, turn112_q) + KSL_MULF(turn102_b_2, turn112_p);
  const float turn112_c_0 = KSL_MULF(turn101_d_0, turn112_p) - KSL_MULF(turn102_d_0, turn112_q),
      turn112_c_1 = KSL_MULF(turn101_d_1, turn112_p) - KSL_MULF(turn102_d_1, turn112_q),
      turn112_c_2 = KSL_MULF(turn101_d_2, turn112_p) - KSL_MULF(turn102_d_2, turn112_q);
  const float turn112_d_0 = KSL_MULF(turn101_d_0, turn112_q) + KSL_MULF(turn102_d_0, turn112_p),
      turn112_d_1 = KSL_MULF(turn101_d_1, turn112_q) + KSL_MULF(turn102_d_1, turn112_p),
      turn112_d_2 = KSL_MULF(turn101_d_2, turn112_q) + KSL_MULF(turn102_d_2, turn112_p);
  const float turn201_aa = KSL_MULF(turn102_a_0, turn102_a_0) + KSL_MULF(turn102_a_1, turn102_a_1)
          + KSL_MULF(turn102_a_2, turn102_a_2);
  const float turn201_bb = KSL_MULF(turn112_a_0, turn112_a_0) + KSL_MULF(turn112_a_1, turn112_a_1)
          + KSL_MULF(turn112_a_2, turn112_a_2);
  const float turn201_g = KSL_MULF(turn102_a_0, turn112_a_0) + KSL_MULF(turn102_a_1, turn112_a_1)
          + KSL_MULF(turn102_a_2, turn112_a_2);
  const float turn201_apart = turn201_bb - turn201_aa;
  const float turn201_e = KSL_MULF(0.5f, turn201_apart);
  const float turn201_size_g = fabsf(turn201_g);
  const float turn201_size_e = fabsf(turn201_e);
  const float turn201_above = turn201_size_g < turn201_size_e ? turn201_g : turn201_e;
  const float turn201_below = turn201_size_g < turn201_size_e ? turn201_e : turn201_g;
  const float turn201_divisor = turn201_below == 0.0f ? 1.0f : turn201_below;
  const float turn201_ratio = turn201_above / turn201_divisor;
  const float turn201_root = sqrtf(1.0f + KSL_MULF(turn201_ratio, turn201_ratio));
  const float turn201_signed_a = -turn201_root,
      turn201_signed = turn201_ratio < 0.0f ? turn201_signed_a : turn201_root;
  const float turn201_top = turn201_size_g < turn201_size_e ? turn201_ratio : 1.0f;
  const float turn201_bottom_a = turn201_ratio + turn201_signed,
      turn201_bottom_b = turn201_root + 1.0f,
      turn201_bottom = turn201_size_g < turn201_size_e ? turn201_bottom_b : turn201_bottom_a;
  const float turn201_t = turn201_top / turn201_bottom;
  const float turn201_tangent = turn201_g == 0.0f ? 0.0f : turn201_t;
  const float turn201_secant = sqrtf(1.0f + KSL_MULF(turn201_tangent, turn201_tangent));
  const float turn201_cosine = 1.0f / turn201_secant;
  const float turn201_sine = KSL_MULF(turn201_tangent, turn201_cosine);
  const float turn201_p = turn201_aa < turn201_bb ? turn201_sine : turn201_cosine;
  const float turn201_q_a = -turn201_cosine,
      turn201_q = turn201_aa < turn201_bb ? turn201_q_a : turn201_sine;
  const float turn201_a_0 = KSL_MULF(turn102_a_0, turn201_p) - KSL_MULF(turn112_a_0, turn201_q),
      turn201_a_1 = KSL_MULF(turn102_a_1, turn201_p) - KSL_MULF(turn112_a_1, turn201_q),
      turn201_a_2 = KSL_MULF(turn102_a_2, turn201_p) - KSL_MULF(turn112_a_2, turn201_q);
  const float turn201_b_0 = KSL_MULF(turn102_a_0, turn201_q) + KSL_MULF(turn112_a_0, turn201_p),
      turn201_b_1 = KSL_MULF(turn102_a_1, turn201_q) + KSL_MULF(turn112_a_1, turn201_p),
      turn201_b_2 = KSL_MULF(turn102_a_2, turn201_q) + KSL_MULF(turn112_a_2, turn201_p);
  const float turn201_c_0 = KSL_MULF(turn102_c_0, turn201_p) - KSL_MULF(turn112_c_0, turn201_q),
      turn201_c_1 = KSL_MULF(turn102_c_1, turn201_p) - KSL_MULF(turn112_c_1, turn201_q),
      turn201_c_2 = KSL_MULF(turn102_c_2, turn201_p) - KSL_MULF(turn112_c_2, turn201_q);
  const float turn201_d_0 = KSL_MULF(turn102_c_0, turn201_q) + KSL_MULF(turn112_c_0, turn201_p),
      turn201_d_1 = KSL_MULF(turn102_c_1, turn201_q) + KSL_MULF(turn112_c_1, turn201_p),
      turn201_d_2 = KSL_MULF(turn102_c_2, turn201_q) + KSL_MULF(turn112_c_2, turn201_p);
  const float turn202_aa = KSL_MULF(turn201_a_0, turn201_a_0) + KSL_MULF(turn201_a_1, turn201_a_1)
          + KSL_MULF(turn201_a_2, turn201_a_2);
  const float turn202_bb = KSL_MULF(turn112_b_0, turn112_b_0) + KSL_MULF(turn112_b_1, turn112_b_1)
          + KSL_MULF(turn112_b_2, turn112_b_2);
  const float turn202_g = KSL_MULF(turn112_b_0, turn201_a_0) + KSL_MULF(turn112_b_1, turn201_a_1)
          + KSL_MULF(turn112_b_2, turn201_a_2);
  const float turn202_apart = turn202_bb - turn202_aa;
  const float turn202_e = KSL_MULF(0.5f, turn202_apart);
  const float turn202_size_g = fabsf(turn202_g);
  const float turn202_size_e = fabsf(turn202_e);
  const float turn202_above = turn202_size_g < turn202_size_e ? turn202_g : turn202_e;
  const float turn202_below = turn202_size_g < turn202_size_e ? turn202_e : turn202_g;
  const float turn202_divisor = turn202_below == 0.0f ? 1.0f : turn202_below;
  const float turn202_ratio = turn202_above / turn202_divisor;
  const float turn202_root = sqrtf(1.0f + KSL_MULF(turn202_ratio, turn202_ratio));
  const float turn202_signed_a = -turn202_root,
      turn202_signed = turn202_ratio < 0.0f ? turn202_signed_a : turn202_root;
  const float turn202_top = turn202_size_g < turn202_size_e ? turn202_ratio : 1.0f;
  const float turn202_bottom_a = turn202_ratio + turn202_signed,
      turn202_bottom_b = turn202_root + 1.0f,
      turn202_bottom = turn202_size_g < turn202_size_e ? turn202_bottom_b : turn202_bottom_a;
  const float turn202_t = turn202_top / turn202_bottom;
  const float turn202_tangent = turn202_g == 0.0f ? 0.0f : turn202_t;
  const float turn202_secant = sqrtf(1.0f + KSL_MULF(turn202_tangent, turn202_tangent));
  const float turn202_cosine = 1.0f / turn202_secant;
  const float turn202_sine = KSL_MULF(turn202_tangent, turn202_cosine);
  const float turn202_p = turn202_aa < turn202_bb ? turn202_sine : turn202_cosine;
  const float turn202_q_a = -turn202_cosine,
      turn202_q = turn202_aa < turn202_bb ? turn202_q_a : turn202_sine;
  const float turn202_a_0 = KSL_MULF(turn201_a_0, turn202_p) - KSL_MULF(turn112_b_0, turn202_q),
      turn202_a_1 = KSL_MULF(turn201_a_1, turn202_p) - KSL_MULF(turn112_b_1, turn202_q),
      turn202_a_2 = KSL_MULF(turn201_a_2, turn202_p) - KSL_MULF(turn112_b_2, turn202_q);
  const float turn202_b_0 = KSL_MULF(turn112_b_0, turn202_p) + KSL_MULF(turn201_a_0, turn202_q),
      turn202_b_1 = KSL_MULF(turn112_b_1, turn202_p) + KSL_MULF(turn201_a_1, turn202_q),
      turn202_b_2 = KSL_MULF(turn112_b_2, turn202_p) + KSL_MULF(turn201_a_2, turn202_q);
  const float turn202_c_0 = KSL_MULF(turn201_c_0, turn202_p) - KSL_MULF(turn112_d_0, turn202_q),
      turn202_c_1 = KSL_MULF(turn201_c_1, turn202_p) - KSL_MULF(turn112_d_1, turn202_q),
      turn202_c_2 = KSL_MULF(turn201_c_2, turn202_p) - KSL_MULF(turn112_d_2, turn202_q);
  const float turn202_d_0 = KSL_MULF(turn112_d_0, turn202_p) + KSL_MULF(turn201_c_0, turn202_q),
      turn202_d_1 = KSL_MULF(turn112_d_1, turn202_p) + KSL_MULF(turn201_c_1, turn202_q),
      turn202_d_2 = KSL_MULF(turn112_d_2, turn202_p) + KSL_MULF(turn201_c_2, turn202_q);
  const float turn212_aa = KSL_MULF(turn201_b_0, turn201_b_0) + KSL_MULF(turn201_b_1, turn201_b_1)
          + KSL_MULF(turn201_b_2, turn201_b_2);
  const float turn212_bb = KSL_MULF(turn202_b_0, turn202_b_0) + KSL_MULF(turn202_b_1, turn202_b_1)
          + KSL_MULF(turn202_b_2, turn202_b_2);
  const float turn212_g = KSL_MULF(turn201_b_0, turn202_b_0) + KSL_MULF(turn201_b_1, turn202_b_1)
          + KSL_MULF(turn201_b_2, turn202_b_2);
  const float turn212_apart = turn212_bb - turn212_aa;
  const float turn212_e = KSL_MULF(0.5f, turn212_apart);
  const float turn212_size_g = fabsf(turn212_g);
  const float turn212_size_e = fabsf(turn212_e);
  const float turn212_above = turn212_size_g < turn212_size_e ? turn212_g : turn212_e;
  const float turn212_below = turn212_size_g < turn212_size_e ? turn212_e : turn212_g;
  const float turn212_divisor = turn212_below == 0.0f ? 1.0f : turn212_below;
  const float turn212_ratio = turn212_above / turn212_divisor;
  const float turn212_root = sqrtf(1.0f + KSL_MULF(turn212_ratio, turn212_ratio));
  const float turn212_signed_a = -turn212_root,
      turn212_signed = turn212_ratio < 0.0f ? turn212_signed_a : turn212_root;
  const float turn212_top = turn212_size_g < turn212_size_e ? turn212_ratio : 1.0f;
  const float turn212_bottom_a = turn212_ratio + turn212_signed,
      turn212_bottom_b = turn212_root + 1.0f,
      turn212_bottom = turn212_size_g < turn212_size_e ? turn212_bottom_b : turn212_bottom_a;
  const float turn212_t = turn212_top / turn212_bottom;
  const float turn212_tangent = turn212_g == 0.0f ? 0.0f : turn212_t;
  const float turn212_secant = sqrtf(1.0f + KSL_MULF(turn212_tangent, turn212_tangent));
  const float turn212_cosine = 1.0f / turn212_secant;
  const float turn212_sine = KSL_MULF(turn212_tangent, turn212_cosine);
  const float turn212_p = turn212_aa < turn212_bb ? turn212_sine : turn212_cosine;
  const float turn212_q_a = -turn212_cosine,
      turn212_q = turn212_aa < turn212_bb ? turn212_q_a : turn212_sine;
  const float turn212_a_0 = KSL_MULF(turn201_b_0, turn212_p) - KSL_MULF(turn202_b_0, turn212_q),
      turn212_a_1 = KSL_MULF(turn201_b_1, turn212_p) - KSL_MULF(turn202_b_1, turn212_q),
      turn212_a_2 = KSL_MULF(turn201_b_2, turn212_p) - KSL_MULF(turn202_b_2, turn212_q);
  const float turn212_b_0 = KSL_MULF(turn201_b_0, turn212_q) + KSL_MULF(turn202_b_0, turn212_p),
      turn212_b_1 = KSL_MULF(turn201_b_1, turn212_q) + KSL_MULF(turn202_b_1, turn212_p),
      turn212_b_2 = KSL_MULF(turn201_b_2, turn212_q) + KSL_MULF(turn202_b_2, turn212_p);
  const float turn212_c_0 = KSL_MULF(turn201_d_0, turn212_p) - KSL_MULF(turn202_d_0, turn212_q),
      turn212_c_1 = KSL_MULF(turn201_d_1, turn212_p) - KSL_MULF(turn202_d_1, turn212_q),
      turn212_c_2 = KSL_MULF(turn201_d_2, turn212_p) - KSL_MULF(turn202_d_2, turn212_q);
  const float turn212_d_0 = KSL_MULF(turn201_d_0, turn212_q) + KSL_MULF(turn202_d_0, turn212_p),
      turn212_d_1 = KSL_MULF(turn201_d_1, turn212_q) + KSL_MULF(turn202_d_1, turn212_p),
      turn212_d_2 = KSL_MULF(turn201_d_2, turn212_q) + KSL_MULF(turn202_d_2, turn212_p);
  const float turn301_aa = KSL_MULF(turn202_a_0, turn202_a_0) + KSL_MULF(turn202_a_1, turn202_a_1)
          + KSL_MULF(turn202_a_2, turn202_a_2);
  const float turn301_bb = KSL_MULF(turn212_a_0, turn212_a_0) + KSL_MULF(turn212_a_1, turn212_a_1)
          + KSL_MULF(turn212_a_2, turn212_a_2);
  const float turn301_g = KSL_MULF(turn202_a_0, turn212_a_0) + KSL_MULF(turn202_a_1, turn212_a_1)
          + KSL_MULF(turn202_a_2, turn212_a_2);
  const float turn301_apart = turn301_bb - turn301_aa;
  const float turn301_e = KSL_MULF(0.5f, turn301_apart);
  const float turn301_size_g = fabsf(turn301_g);
  const float turn301_size_e = fabsf(turn301_e);
  const float turn301_above = turn301_size_g < turn301_size_e ? turn301_g : turn301_e;
  const float turn301_below = turn301_size_g < turn301_size_e ? turn301_e : turn301_g;
  const float turn301_divisor = turn301_below == 0.0f ? 1.0f : turn301_below;
  const float turn301_ratio = turn301_above / turn301_divisor;
  const float turn301_root = sqrtf(1.0f + KSL_MULF(turn301_ratio, turn301_ratio));
  const float turn301_signed_a = -turn301_root,
      turn301_signed = turn301_ratio < 0.0f ? turn301_signed_a : turn301_root;
  const float turn301_top = turn301_size_g < turn301_size_e ? turn301_ratio : 1.0f;
  const float turn301_bottom_a = turn301_ratio + turn301_signed,
      turn301_bottom_b = turn301_root + 1.0f,
      turn301_bottom = turn301_size_g < turn301_size_e ? turn301_bottom_b : turn301_bottom_a;
  const float turn301_t = turn301_top / turn301_bottom;
  const float turn301_tangent = turn301_g == 0.0f ? 0.0f : turn301_t;
  const float turn301_secant = sqrtf(1.0f + KSL_MULF(turn301_tangent, turn301_tangent));
  const float turn301_cosine = 1.0f / turn301_secant;
  const float turn301_sine = KSL_MULF(turn301_tangent, turn301_cosine);
  const float turn301_p = turn301_aa < turn301_bb ? turn301_sine : turn301_cosine;
  const float turn301_q_a = -turn301_cosine,
      turn301_q = turn301_aa < turn301_bb ? turn301_q_a : turn301_sine;
  const float turn301_a_0 = KSL_MULF(turn202_a_0, turn301_p) - KSL_MULF(turn212_a_0, turn301_q),
      turn301_a_1 = KSL_MULF(turn202_a_1, turn301_p) - KSL_MULF(turn212_a_1, turn301_q),
      turn301_a_2 = KSL_MULF(turn202_a_2, turn301_p) - KSL_MULF(turn212_a_2, turn301_q);
  const float turn301_b_0 = KSL_MULF(turn202_a_0, turn301_q) + KSL_MULF(turn212_a_0, turn301_p),
      turn301_b_1 = KSL_MULF(turn202_a_1, turn301_q) + KSL_MULF(turn212_a_1, turn301_p),
      turn301_b_2 = KSL_MULF(turn202_a_2, turn301_q) + KSL_MULF(turn212_a_2, turn301_p);
  const float turn301_c_0 = KSL_MULF(turn202_c_0, turn301_p) - KSL_MULF(turn212_c_0, turn301_q),
      turn301_c_1 = KSL_MULF(turn202_c_1, turn301_p) - KSL_MULF(turn212_c_1, turn301_q),
      turn301_c_2 = KSL_MULF(turn202_c_2, turn301_p) - KSL_MULF(turn212_c_2, turn301_q);
  const float turn301_d_0 = KSL_MULF(turn202_c_0, turn301_q) + KSL_MULF(turn212_c_0, turn301_p),
      turn301_d_1 = KSL_MULF(turn202_c_1, turn301_q) + KSL_MULF(turn212_c_1, turn301_p),
      turn301_d_2 = KSL_MULF(turn202_c_2, turn301_q) + KSL_MULF(turn212_c_2, turn301_p);
  const float turn302_aa = KSL_MULF(turn301_a_0, turn301_a_0) + KSL_MULF(turn301_a_1, turn301_a_1)
          + KSL_MULF(turn301_a_2, turn301_a_2);
  const float turn302_bb = KSL_MULF(turn212_b_0, turn212_b_0) + KSL_MULF(turn212_b_1, turn212_b_1)
          + KSL_MULF(turn212_b_2, turn212_b_2);
  const float turn302_g = KSL_MULF(turn212_b_0, turn301_a_0) + KSL_MULF(turn212_b_1, turn301_a_1)
          + KSL_MULF(turn212_b_2, turn301_a_2);
  const float turn302_apart = turn302_bb - turn302_aa;
  const float turn302_e = KSL_MULF(0.5f, turn302_apart);
  const float turn302_size_g = fabsf(turn302_g);
  const float turn302_size_e = fabsf(turn302_e);
  const float turn302_above = turn302_size_g < turn302_size_e ? turn302_g : turn302_e;
  const float turn302_below = turn302_size_g < turn302_size_e ? turn302_e : turn302_g;
  const float turn302_divisor = turn302_below == 0.0f ? 1.0f : turn302_below;
  const float turn302_ratio = turn302_above / turn302_divisor;
  const float turn302_root = sqrtf(1.0f + KSL_MULF(turn302_ratio, turn302_ratio));
  const float turn302_signed_a = -turn302_root,
      turn302_signed = turn302_ratio < 0.0f ? turn302_signed_a : turn302_root;
  const float turn302_top = turn302_size_g < turn302_size_e ? turn302_ratio : 1.0f;
  const float turn302_bottom_a = turn302_ratio + turn302_signed,
      turn302_bottom_b = turn302_root + 1.0f,
      turn302_bottom = turn302_size_g < turn302_size_e ? turn302_bottom_b : turn302_bottom_a;
  const float turn302_t = turn302_top / turn302_bottom;
  const float turn302_tangent = turn302_g == 0.0f ? 0.0f : turn302_t;
  const float turn302_secant = sqrtf(1.0f + KSL_MULF(turn302_tangent, turn302_tangent));
  const float turn302_cosine = 1.0f / turn302_secant;
  const float turn302_sine = KSL_MULF(turn302_tangent, turn302_cosine);
  const float turn302_p = turn302_aa < turn302_bb ? turn302_sine : turn302_cosine;
  const float turn302_q_a = -turn302_cosine,
      turn302_q = turn302_aa < turn302_bb ? turn302_q_a : turn302_sine;
  const float turn302_a_0 = KSL_MULF(turn301_a_0, turn302_p) - KSL_MULF(turn212_b_0, turn302_q),
      turn302_a_1 = KSL_MULF(turn301_a_1, turn302_p) - KSL_MULF(turn212_b_1, turn302_q),
      turn302_a_2 = KSL_MULF(turn301_a_2, turn302_p) - KSL_MULF(turn212_b_2, turn302_q);
  const float turn302_b_0 = KSL_MULF(turn212_b_0, turn302_p) + KSL_MULF(turn301_a_0, turn302_q),
      turn302_b_1 = KSL_MULF(turn212_b_1, turn302_p) + KSL_MULF(turn301_a_1, turn302_q),
      turn302_b_2 = KSL_MULF(turn212_b_2, turn302_p) + KSL_MULF(turn301_a_2, turn302_q);
  const float turn302_c_0 = KSL_MULF(turn301_c_0, turn302_p) - KSL_MULF(turn212_d_0, turn302_q),
      turn302_c_1 = KSL_MULF(turn301_c_1, turn302_p) - KSL_MULF(turn212_d_1, turn302_q),
      turn302_c_2 = KSL_MULF(turn301_c_2, turn302_p) - KSL_MULF(turn212_d_2, turn302_q);
  const float turn302_d_0 = KSL_MULF(turn212_d_0, turn302_p) + KSL_MULF(turn301_c_0, turn302_q),
      turn302_d_1 = KSL_MULF(turn212_d_1, turn302_p) + KSL_MULF(turn301_c_1, turn302_q),
      turn302_d_2 = KSL_MULF(turn212_d_2, turn302_p) + KSL_MULF(turn301_c_2, turn302_q);
  const float turn312_aa = KSL_MULF(turn301_b_0, turn301_b_0) + KSL_MULF(turn301_b_1, turn301_b_1)
          + KSL_MULF(turn301_b_2, turn301_b_2);
  const float turn312_bb = KSL_MULF(turn302_b_0, turn302_b_0) + KSL_MULF(turn302_b_1, turn302_b_1)
          + KSL_MULF(turn302_b_2, turn302_b_2);
  const float turn312_g = KSL_MULF(turn301_b_0, turn302_b_0) + KSL_MULF(turn301_b_1, turn302_b_1)
          + KSL_MULF(turn301_b_2, turn302_b_2);
  const float turn312_apart = turn312_bb - turn312_aa;
  const float turn312_e = KSL_MULF(0.5f, turn312_apart);
  const float turn312_size_g = fabsf(turn312_g);
  const float turn312_size_e = fabsf(turn312_e);
  const float turn312_above = turn312_size_g < turn312_size_e ? turn312_g : turn312_e;
  const float turn312_below = turn312_size_g < turn312_size_e ? turn312_e : turn312_g;
  const float turn312_divisor = turn312_below == 0.0f ? 1.0f : turn312_below;
  const float turn312_ratio = turn312_above / turn312_divisor;
  const float turn312_root = sqrtf(1.0f + KSL_MULF(turn312_ratio, turn312_ratio));
  const float turn312_signed_a = -turn312_root,
      turn312_signed = turn312_ratio < 0.0f ? turn312_signed_a : turn312_root;
  const float turn312_top = turn312_size_g < turn312_size_e ? turn312_ratio : 1.0f;
  const float turn312_bottom_a = turn312_ratio + turn312_signed,
      turn312_bottom_b = turn312_root + 1.0f,
      turn312_bottom = turn312_size_g < turn312_size_e ? turn312_bottom_b : turn312_bottom_a;
  const float turn312_t = turn312_top / turn312_bottom;
  const float turn312_tangent = turn312_g == 0.0f ? 0.0f : turn312_t;
  const float turn312_secant = sqrtf(1.0f + KSL_MULF(turn312_tangent, turn312_tangent));
  const float turn312_cosine = 1.0f / turn312_secant;
  const float turn312_sine = KSL_MULF(turn312_tangent, turn312_cosine);
  const float turn312_p = turn312_aa < turn312_bb ? turn312_sine : turn312_cosine;
  const float turn312_q_a = -turn312_cosine,
      turn312_q = turn312_aa < turn312_bb ? turn312_q_a : turn312_sine;
  const float turn312_a_0 = KSL_MULF(turn301_b_0, turn312_p) - KSL_MULF(turn302_b_0, turn312_q),
      turn312_a_1 = KSL_MULF(turn301_b_1, turn312_p) - KSL_MULF(turn302_b_1, turn312_q),
      turn312_a_2 = KSL_MULF(turn301_b_2, turn312_p) - KSL_MULF(turn302_b_2, turn312_q);
  const float turn312_b_0 = KSL_MULF(turn301_b_0, turn312_q) + KSL_MULF(turn302_b_0, turn312_p),
      turn312_b_1 = KSL_MULF(turn301_b_1, turn312_q) + KSL_MULF(turn302_b_1, turn312_p),
      turn312_b_2 = KSL_MULF(turn301_b_2, turn312_q) + KSL_MULF(turn302_b_2, turn312_p);
  const float turn312_c_0 = KSL_MULF(turn301_d_0, turn312_p) - KSL_MULF(turn302_d_0, turn312_q),
      turn312_c_1 = KSL_MULF(turn301_d_1, turn312_p) - KSL_MULF(turn302_d_1, turn312_q),
      turn312_c_2 = KSL_MULF(turn301_d_2, turn312_p) - KSL_MULF(turn302_d_2, turn312_q);
  const float turn312_d_0 = KSL_MULF(turn301_d_0, turn312_q) + KSL_MULF(turn302_d_0, turn312_p),
      turn312_d_1 = KSL_MULF(turn301_d_1, turn312_q) + KSL_MULF(turn302_d_1, turn312_p),
      turn312_d_2 = KSL_MULF(turn301_d_2, turn312_q) + KSL_MULF(turn302_d_2, turn312_p);
  const float turn401_aa = KSL_MULF(turn302_a_0, turn302_a_0) + KSL_MULF(turn302_a_1, turn302_a_1)
          + KSL_MULF(turn302_a_2, turn302_a_2);
  const float turn401_bb = KSL_MULF(turn312_a_0, turn312_a_0) + KSL_MULF(turn312_a_1, turn312_a_1)
          + KSL_MULF(turn312_a_2, turn312_a_2);
  const float turn401_g = KSL_MULF(turn302_a_0, turn312_a_0) + KSL_MULF(turn302_a_1, turn312_a_1)
          + KSL_MULF(turn302_a_2, turn312_a_2);
  const float turn401_apart = turn401_bb - turn401_aa;
  const float turn401_e = KSL_MULF(0.5f, turn401_apart);
  const float turn401_size_g = fabsf(turn401_g);
  const float turn401_size_e = fabsf(turn401_e);
  const float turn401_above = turn401_size_g < turn401_size_e ? turn401_g : turn401_e;
  const float turn401_below = turn401_size_g < turn401_size_e ? turn401_e : turn401_g;
  const float turn401_divisor = turn401_below == 0.0f ? 1.0f : turn401_below;
  const float turn401_ratio = turn401_above / turn401_divisor;
  const float turn401_root = sqrtf(1.0f + KSL_MULF(turn401_ratio, turn401_ratio));
  const float turn401_signed_a = -turn401_root,
      turn401_signed = turn401_ratio < 0.0f ? turn401_signed_a : turn401_root;
  const float turn401_top = turn401_size_g < turn401_size_e ? turn401_ratio : 1.0f;
  const float turn401_bottom_a = turn401_ratio + turn401_signed,
      turn401_bottom_b = turn401_root + 1.0f,
      turn401_bottom = turn401_size_g < turn401_size_e ? turn401_bottom_b : turn401_bottom_a;
  const float turn401_t = turn401_top / turn401_bottom;
  const float turn401_tangent = turn401_g == 0.0f ? 0.0f : turn401_t;
  const float turn401_secant = sqrtf(1.0f + KSL_MULF(turn401_tangent, turn401_tangent));
  const float turn401_cosine = 1.0f / turn401_secant;
  const float turn401_sine = KSL_MULF(turn401_tangent, turn401_cosine);
  const float turn401_p = turn401_aa < turn401_bb ? turn401_sine : turn401_cosine;
  const float turn401_q_a = -turn401_cosine,
      turn401_q = turn401_aa < turn401_bb ? turn401_q_a : turn401_sine;
  const float turn401_a_0 = KSL_MULF(turn302_a_0, turn401_p) - KSL_MULF(turn312_a_0, turn401_q),
      turn401_a_1 = KSL_MULF(turn302_a_1, turn401_p) - KSL_MULF(turn312_a_1, turn401_q),
      turn401_a_2 = KSL_MULF(turn302_a_2, turn401_p) - KSL_MULF(turn312_a_2, turn401_q);
  const float turn401_b_0 = KSL_MULF(turn302_a_0, turn401_q) + KSL_MULF(turn312_a_0, turn401_p),
      turn401_b_1 = KSL_MULF(turn302_a_1, turn401_q) + KSL_MULF(turn312_a_1, turn401_p),
      turn401_b_2 = KSL_MULF(turn302_a_2, turn401_q) + KSL_MULF(turn312_a_2, turn401_p);
  const float turn401_c_0 = KSL_MULF(turn302_c_0, turn401_p) - KSL_MULF(turn312_c_0, turn401_q),
      turn401_c_1 = KSL_MULF(turn302_c_1, turn401_p) - KSL_MULF(turn312_c_1, turn401_q),
      turn401_c_2 = KSL_MULF(turn302_c_2, turn401_p) - KSL_MULF(turn312_c_2, turn401_q);
  const float turn401_d_0 = KSL_MULF(turn302_c_0, turn401_q) + KSL_MULF(turn312_c_0, turn401_p),
      turn401_d_1 = KSL_MULF(turn302_c_1, turn401_q) + KSL_MULF(turn312_c_1, turn401_p),
      turn401_d_2 = KSL_MULF(turn302_c_2, turn401_q) + KSL_MULF(turn312_c_2, turn401_p);
  const float turn402_aa = KSL_MULF(turn401_a_0, turn401_a_0) + KSL_MULF(turn401_a_1, turn401_a_1)
          + KSL_MULF(turn401_a_2, turn401_a_2);
  const float turn402_bb = KSL_MULF(turn312_b_0, turn312_b_0) + KSL_MULF(turn312_b_1, turn312_b_1)
          + KSL_MULF(turn312_b_2, turn312_b_2);
  const float turn402_g = KSL_MULF(turn312_b_0, turn401_a_0) + KSL_MULF(turn312_b_1, turn401_a_1)
          + KSL_MULF(turn312_b_2, turn401_a_2);
  const float turn402_apart = turn402_bb - turn402_aa;
  const float turn402_e = KSL_MULF(0.5f, turn402_apart);
  const float turn402_size_g = fabsf(turn402_g);
  const float turn402_size_e = fabsf(turn402_e);
  const float turn402_above = turn402_size_g < turn402_size_e ? turn402_g : turn402_e;
  const float turn402_below = turn402_size_g < turn402_size_e ? turn402_e : turn402_g;
  const float turn402_divisor = turn402_below == 0.0f ? 1.0f : turn402_below;
  const float turn402_ratio = turn402_above / turn402_divisor;
  const float turn402_root = sqrtf(1.0f + KSL_MULF(turn402_ratio, turn402_ratio));
  const float turn402_signed_a = -turn402_root,
      turn402_signed = turn402_ratio < 0.0f ? turn402_signed_a : turn402_root;
  const float turn402_top = turn402_size_g < turn402_size_e ? turn402_ratio : 1.0f;
  const float turn402_bottom_a = turn402_ratio + turn402_signed,
      turn402_bottom_b = turn402_root + 1.0f,
      turn402_bottom = turn402_size_g < turn402_size_e ? turn402_bottom_b : turn402_bottom_a;
  const float turn402_t = turn402_top / turn402_bottom;
  const float turn402_tangent = turn402_g == 0.0f ? 0.0f : turn402_t;
  const float turn402_secant = sqrtf(1.0f + KSL_MULF(turn402_tangent, turn402_tangent));
  const float turn402_cosine = 1.0f / turn402_secant;
  const float turn402_sine = KSL_MULF(turn402_tangent, turn402_cosine);
  const float turn402_p = turn402_aa < turn402_bb ? turn402_sine : turn402_cosine;
  const float turn402_q_a = -turn402_cosine,
      turn402_q = turn402_aa < turn402_bb ? turn402_q_a : turn402_sine;
  const float turn402_a_0 = KSL_MULF(turn401_a_0, turn402_p) - KSL_MULF(turn312_b_0, turn402_q),
      turn402_a_1 = KSL_MULF(turn401_a_1, turn402_p) - KSL_MULF(turn312_b_1, turn402_q),
      turn402_a_2 = KSL_MULF(turn401_a_2, turn402_p) - KSL_MULF(turn312_b_2, turn402_q);
  const float turn402_b_0 = KSL_MULF(turn312_b_0, turn402_p) + KSL_MULF(turn401_a_0, turn402_q),
      turn402_b_1 = KSL_MULF(turn312_b_1, turn402_p) + KSL_MULF(turn401_a_1, turn402_q),
      turn402_b_2 = KSL_MULF(turn312_b_2, turn402_p) + KSL_MULF(turn401_a_2, turn402_q);
  const float turn402_c_0 = KSL_MULF(turn401_c_0, turn402_p) - KSL_MULF(turn312_d_0, turn402_q),
      turn402_c_1 = KSL_MULF(turn401_c_1, turn402_p) - KSL_MULF(turn312_d_1, turn402_q),
      turn402_c_2 = KSL_MULF(turn401_c_2, turn402_p) - KSL_MULF(turn312_d_2, turn402_q);
  const float turn402_d_0 = KSL_MULF(turn312_d_0, turn402_p) + KSL_MULF(turn401_c_0, turn402_q),
      turn402_d_1 = KSL_MULF(turn312_d_1, turn402_p) + KSL_MULF(turn401_c_1, turn402_q),
      turn402_d_2 = KSL_MULF(turn312_d_2, turn402_p) + KSL_MULF(turn401_c_2, turn402_q);
  const float turn412_aa = KSL_MULF(turn401_b_0, turn401_b_0) + KSL_MULF(turn401_b_1, turn401_b_1)
          + KSL_MULF(turn401_b_2, turn401_b_2);
  const float turn412_bb = KSL_MULF(turn402_b_0, turn402_b_0) + KSL_MULF(turn402_b_1, turn402_b_1)
          + KSL_MULF(turn402_b_2, turn402_b_2);
  const float turn412_g = KSL_MULF(turn401_b_0, turn402_b_0) + KSL_MULF(turn401_b_1, turn402_b_1)
          + KSL_MULF(turn401_b_2, turn402_b_2);
  const float turn412_apart = turn412_bb - turn412_aa;
  const float turn412_e = KSL_MULF(0.5f, turn412_apart);
  const float turn412_size_g = fabsf(turn412_g);
  const float turn412_size_e = fabsf(turn412_e);
  const float turn412_above = turn412_size_g < turn412_size_e ? turn412_g : turn412_e;
  const float turn412_below = turn412_size_g < turn412_size_e ? turn412_e : turn412_g;
  const float turn412_divisor = turn412_below == 0.0f ? 1.0f : turn412_below;
  const float turn412_ratio = turn412_above / turn412_divisor;
  const float turn412_root = sqrtf(1.0f + KSL_MULF(turn412_ratio, turn412_ratio));
  const float turn412_signed_a = -turn412_root,
      turn412_signed = turn412_ratio < 0.0f ? turn412_signed_a : turn412_root;
  const float turn412_top = turn412_size_g < turn412_size_e ? turn412_ratio : 1.0f;
  const float turn412_bottom_a = turn412_ratio + turn412_signed,
      turn412_bottom_b = turn412_root + 1.0f,
      turn412_bottom = turn412_size_g < turn412_size_e ? turn412_bottom_b : turn412_bottom_a;
  const float turn412_t = turn412_top / turn412_bottom;
  const float turn412_tangent = turn412_g == 0.0f ? 0.0f : turn412_t;
  const float turn412_secant = sqrtf(1.0f + KSL_MULF(turn412_tangent, turn412_tangent));
  const float turn412_cosine = 1.0f / turn412_secant;
  const float turn412_sine = KSL_MULF(turn412_tangent, turn412_cosine);
  const float turn412_p = turn412_aa < turn412_bb ? turn412_sine : turn412_cosine;
  const float turn412_q_a = -turn412_cosine,
      turn412_q = turn412_aa < turn412_bb ? turn412_q_a : turn412_sine;
  const float turn412_a_0 = KSL_MULF(turn401_b_0, turn412_p) - KSL_MULF(turn402_b_0, turn412_q),
      turn412_a_1 = KSL_MULF(turn401_b_1, turn412_p) - KSL_MULF(turn402_b_1, turn412_q),
      turn412_a_2 = KSL_MULF(turn401_b_2, turn412_p) - KSL_MULF(turn402_b_2, turn412_q);
  const float turn412_c_0 = KSL_MULF(turn401_d_0, turn412_p) - KSL_MULF(turn402_d_0, turn412_q),
      turn412_c_1 = KSL_MULF(turn401_d_1, turn412_p) - KSL_MULF(turn402_d_1, turn412_q),
      turn412_c_2 = KSL_MULF(turn401_d_2, turn412_p) - KSL_MULF(turn402_d_2, turn412_q);
  const float turn412_d_0 = KSL_MULF(turn401_d_0, turn412_q) + KSL_MULF(turn402_d_0, turn412_p),
      turn412_d_1 = KSL_MULF(turn401_d_1, turn412_q) + KSL_MULF(turn402_d_1, turn412_p),
      turn412_d_2 = KSL_MULF(turn401_d_2, turn412_q) + KSL_MULF(turn402_d_2, turn412_p);
  const float longest = sqrtf(KSL_MULF(turn402_a_0, turn402_a_0)
          + KSL_MULF(turn402_a_1, turn402_a_1) + KSL_MULF(turn402_a_2, turn402_a_2));
  const float first_divisor = longest == 0.0f ? 1.0f : longest;
  const float u0_0 = turn402_a_0 / first_divisor, u0_1 = turn402_a_1 / first_divisor,
      u0_2 = turn402_a_2 / first_divisor;
  const float least = KSL_MULF(KSL_MULF(0.015625f, KSL_MULF(9.536743e-07f, 9.536743e-07f)),
      KSL_MULF(longest, longest));
  const float second_along = KSL_MULF(turn412_a_0, u0_0) + KSL_MULF(turn412_a_1, u0_1)
          + KSL_MULF(turn412_a_2, u0_2);
  const float second_part_0 = turn412_a_0 - KSL_MULF(u0_0, second_along),
      second_part_1 = turn412_a_1 - KSL_MULF(u0_1, second_along),
      second_part_2 = turn412_a_2 - KSL_MULF(u0_2, second_along);
  const float second_whole = KSL_MULF(turn412_a_0, turn412_a_0)
          + KSL_MULF(turn412_a_1, turn412_a_1) + KSL_MULF(turn412_a_2, turn412_a_2);
  const float second_kept = KSL_MULF(second_part_0, second_part_0)
          + KSL_MULF(second_part_1, second_part_1) + KSL_MULF(second_part_2, second_part_2);
  const float second_enough_a = KSL_MULF(0.25f, second_whole),
      second_enough = second_enough_a < least ? least : second_enough_a;
  const float second_is_kept = second_enough < second_kept ? 1.0f : 0.0f;
  const float second_size_0 = fabsf(u0_0), second_size_1 = fabsf(u0_1), second_size_2 = fabsf(u0_2);
  const float second_is_y = second_size_1 < second_size_0 ? 1.0f : 0.0f;
  const float second_less = second_is_y == 0.0f ? second_size_0 : second_size_1;
  const float second_is_z = second_size_2 < second_less ? 1.0f : 0.0f;
  const float second_xy_0 = second_is_y == 0.0f ? 1.0f : 0.0f,
      second_xy_1 = second_is_y == 0.0f ? 0.0f : 1.0f;
  const float second_axis_0 = second_is_z == 1.0f ? 0.0f : second_xy_0,
      second_axis_1 = second_is_z == 1.0f ? 0.0f : second_xy_1,
      second_axis_2 = second_is_z == 1.0f ? 1.0f : 0.0f;
  const float second_along_axis = KSL_MULF(u0_0, second_axis_0) + KSL_MULF(u0_1, second_axis_1)
          + KSL_MULF(u0_2, second_axis_2);
  const float second_other_0 = second_axis_0 - KSL_MULF(u0_0, second_along_axis),
      second_other_1 = second_axis_1 - KSL_MULF(u0_1, second_along_axis),
      second_other_2 = second_axis_2 - KSL_MULF(u0_2, second_along_axis);
  const float second_found_0 = second_is_kept == 1.0f ? second_part_0 : second_other_0,
      second_found_1 = second_is_kept == 1.0f ? second_part_1 : second_other_1,
      second_found_2 = second_is_kept == 1.0f ? second_part_2 : second_other_2;
  const float second_length = sqrtf(KSL_MULF(second_found_0, second_found_0)
          + KSL_MULF(second_found_1, second_found_1) + KSL_MULF(second_found_2, second_found_2));
  const float second_across_0 = second_found_0 / second_length,
      second_across_1 = second_found_1 / second_length,
      second_across_2 = second_found_2 / second_length;
  const float u2_0 = KSL_MULF(u0_1, second_across_2) - KSL_MULF(u0_2, second_across_1),
      u2_1 = KSL_MULF(u0_2, second_across_0) - KSL_MULF(u0_0, second_across_2),
      u2_2 = KSL_MULF(u0_0, second_across_1) - KSL_MULF(u0_1, second_across_0);
  const float turned_0 = KSL_MULF(turn402_c_0, u0_0) + KSL_MULF(turn412_c_0, second_across_0)
          + KSL_MULF(turn412_d_0, u2_0),
      turned_1 = KSL_MULF(turn402_c_1, u0_0) + KSL_MULF(turn412_c_1, second_across_0)
          + KSL_MULF(turn412_d_1, u2_0),
      turned_2 = KSL_MULF(turn402_c_2, u0_0) + KSL_MULF(turn412_c_2, second_across_0)
          + KSL_MULF(turn412_d_2, u2_0),
      turned_3 = KSL_MULF(turn402_c_0, u0_1) + KSL_MULF(turn412_c_0, second_across_1)
          + KSL_MULF(turn412_d_0, u2_1),
      turned_4 = KSL_MULF(turn402_c_1, u0_1) + KSL_MULF(turn412_c_1, second_across_1)
          + KSL_MULF(turn412_d_1, u2_1),
      turned_5 = KSL_MULF(turn402_c_2, u0_1) + KSL_MULF(turn412_c_2, second_across_1)
          + KSL_MULF(turn412_d_2, u2_1),
      turned_6 = KSL_MULF(turn402_c_0, u0_2) + KSL_MULF(turn412_c_0, second_across_2)
          + KSL_MULF(turn412_d_0, u2_2),
      turned_7 = KSL_MULF(turn402_c_1, u0_2) + KSL_MULF(turn412_c_1, second_across_2)
          + KSL_MULF(turn412_d_1, u2_2),
      turned_8 = KSL_MULF(turn402_c_2, u0_2) + KSL_MULF(turn412_c_2, second_across_2)
          + KSL_MULF(turn412_d_2, u2_2);
  const float gram_0 = KSL_MULF(turned_0, turned_0) + KSL_MULF(turned_3, turned_3)
          + KSL_MULF(turned_6, turned_6),
      gram_1 = KSL_MULF(turned_0, turned_1) + KSL_MULF(turned_3, turned_4)
          + KSL_MULF(turned_6, turned_7),
      gram_2 = KSL_MULF(turned_0, turned_2) + KSL_MULF(turned_3, turned_5)
          + KSL_MULF(turned_6, turned_8),
      gram_3 = KSL_MULF(turned_1, turned_1) + KSL_MULF(turned_4, turned_4)
          + KSL_MULF(turned_7, turned_7),
      gram_4 = KSL_MULF(turned_1, turned_2) + KSL_MULF(turned_4, turned_5)
          + KSL_MULF(turned_7, turned_8),
      gram_5 = KSL_MULF(turned_2, turned_2) + KSL_MULF(turned_5, turned_5)
          + KSL_MULF(turned_8, turned_8);
  const float half_0 = 1.5f - KSL_MULF(0.5f, gram_0), half_1 = -KSL_MULF(0.5f, gram_1),
      half_2 = -KSL_MULF(0.5f, gram_2), half_4 = 1.5f - KSL_MULF(0.5f, gram_3),
      half_5 = -KSL_MULF(0.5f, gram_4), half_8 = 1.5f - KSL_MULF(0.5f, gram_5);
  const float Ro_00e = KSL_MULF(turned_0, half_0) + KSL_MULF(turned_1, half_1)
          + KSL_MULF(turned_2, half_2), Ro_00 = longest == 0.0f ? (float)NAN : Ro_00e;
  const float Ro_01e = KSL_MULF(turned_0, half_1) + KSL_MULF(turned_1, half_4)
          + KSL_MULF(turned_2, half_5), Ro_01 = longest == 0.0f ? (float)NAN : Ro_01e;
  const float Ro_02e = KSL_MULF(turned_0, half_2) + KSL_MULF(turned_1, half_5)
          + KSL_MULF(turned_2, half_8), Ro_02 = longest == 0.0f ? (float)NAN : Ro_02e;
  const float Ro_10e = KSL_MULF(turned_3, half_0) + KSL_MULF(turned_4, half_1)
          + KSL_MULF(turned_5, half_2), Ro_10 = longest == 0.0f ? (float)NAN : Ro_10e;
  const float Ro_11e = KSL_MULF(turned_3, half_1) + KSL_MULF(turned_4, half_4)
          + KSL_MULF(turned_5, half_5), Ro_11 = longest == 0.0f ? (float)NAN : Ro_11e;
  const float Ro_12e = KSL_MULF(turned_3, half_2) + KSL_MULF(turned_4, half_5)
          + KSL_MULF(turned_5, half_8), Ro_12 = longest == 0.0f ? (float)NAN : Ro_12e;
  const float Ro_20e = KSL_MULF(turned_6, half_0) + KSL_MULF(turned_7, half_1)
          + KSL_MULF(turned_8, half_2), Ro_20 = longest == 0.0f ? (float)NAN : Ro_20e;
  const float Ro_21e = KSL_MULF(turned_6, half_1) + KSL_MULF(turned_7, half_4)
          + KSL_MULF(turned_8, half_5), Ro_21 = longest == 0.0f ? (float)NAN : Ro_21e;
  const float Ro_22e = KSL_MULF(turned_6, half_2) + KSL_MULF(turned_7, half_5)
          + KSL_MULF(turned_8, half_8), Ro_22 = longest == 0.0f ? (float)NAN : Ro_22e;
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
  const float versine_b = KSL_MULF(2.0f, KSL_MULF(h, h)), versine_c = 1.0f - cosine,
      versine = cosine < 0.0f ? versine_c : versine_b;
  const float beta_v_0 = KSL_MULF(axis->x, versine), beta_v_1 = KSL_MULF(axis->y, versine),
      beta_v_2 = KSL_MULF(axis->z, versine);
  const float m_0 = KSL_MULF(axis->x, beta_v_0), m_1 = KSL_MULF(axis->y, beta_v_1),
      m_2 = KSL_MULF(axis->z, beta_v_2), m_3 = KSL_MULF(axis->y, beta_v_0),
      m_4 = KSL_MULF(axis->z, beta_v_0), m_5 = KSL_MULF(axis->z, beta_v_1);
  const float others_0 = m_1 + m_2, others_1 = m_0 + m_2, others_2 = m_0 + m_1;
  const float alpha_v_0 = KSL_MULF(axis->x, sine), alpha_v_1 = KSL_MULF(axis->y, sine),
      alpha_v_2 = KSL_MULF(axis->z, sine);
  const float R_00 = 1.0f - others_0, R_01 = m_3 - alpha_v_2, R_02 = m_4 + alpha_v_1,
      R_10 = m_3 + alpha_v_2, R_11 = 1.0f - others_1, R_12 = m_5 - alpha_v_0,
      R_20 = m_4 - alpha_v_1, R_21 = m_5 + alpha_v_0, R_22 = 1.0f - others_2;
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
  const float p_0 = R->m21 - R->m12, p_1 = R->m02 - R->m20, p_2 = R->m10 - R->m01;
  const float s_0 = R->m12 + R->m21, s_1 = R->m02 + R->m20, s_2 = R->m01 + R->m10;
  const float first_0 = R->m00 + 1.0f, first_1 = 1.0f - R->m00;
  const float others_0 = R->m11 + R->m22, others_1 = R->m11 - R->m22;
  const float d_0 = first_0 + others_0, d_1 = first_0 - others_0, d_2 = first_1 + others_1,
      d_3 = first_1 - others_1;
  const float low_0 = R->m11 < R->m00 ? d_1 : s_2, low_1 = R->m11 < R->m00 ? s_2 : d_2,
      low_2 = R->m11 < R->m00 ? s_1 : s_0, low_3 = R->m11 < R->m00 ? p_0 : p_1;
  const float high_0a = -R->m11, high_0 = R->m00 < high_0a ? s_1 : p_0;
  const float high_1 = R->m00 < high_0a ? s_0 : p_1, high_2 = R->m00 < high_0a ? d_3 : p_2,
      high_3 = R->m00 < high_0a ? p_2 : d_0;
  const float column_0 = R->m22 < 0.0f ? low_0 : high_0, column_1 = R->m22 < 0.0f ? low_1 : high_1,
      column_2 = R->m22 < 0.0f ? low_2 : high_2, column_3 = R->m22 < 0.0f ? low_3 : high_3;
  const float upper_0a = -column_0, upper_0 = column_3 < 0.0f ? upper_0a : column_0;
  const float upper_1a = -column_1, upper_1 = column_3 < 0.0f ? upper_1a : column_1;
  const float upper_2a = -column_2, upper_2 = column_3 < 0.0f ? upper_2a : column_2;
  const float upper_3a = -column_3, upper_3 = column_3 < 0.0f ? upper_3a : column_3;
  const float v_s_size_0 = fabsf(upper_0), v_s_size_1 = fabsf(upper_1), v_s_size_2 = fabsf(upper_2);
  const float v_s_largest1 = v_s_size_0 < v_s_size_1 ? v_s_size_1 : v_s_size_0;
  const float v_s_largest2 = v_s_largest1 < v_s_size_2 ? v_s_size_2 : v_s_largest1;
  const float v_s_b = 4.611686e+18f < v_s_largest2 ? 2.7105054e-20f : 1.0f,
      v_s_d = v_s_largest2 < 256.0f ? 1.8014399e+16f : v_s_b,
      v_s = v_s_largest2 < 1.4210855e-14f ? 3.2451855e+32f : v_s_d;
  const float v_y_0 = KSL_MULF(upper_0, v_s), v_y_1 = KSL_MULF(upper_1, v_s),
      v_y_2 = KSL_MULF(upper_2, v_s);
  const float v_n = sqrtf(KSL_MULF(v_y_0, v_y_0) + KSL_MULF(v_y_1, v_y_1) + KSL_MULF(v_y_2, v_y_2));
  const float v_r_b = v_s < 1.0f ? 3.689349e+19f : 1.0f, v_r_d = 1.0f < v_s ? 5.551115e-17f : v_r_b,
      v_r = 1.8014399e+16f < v_s ? 3.081488e-33f : v_r_d;
  const float n = KSL_MULF(v_n, v_r);
  const float half = ksl_atan2f(n, upper_3);
  const float divisor = v_n == 0.0f ? 1.0f : v_n;
  const float unit_0 = v_y_0 / divisor, unit_1 = v_y_1 / divisor, unit_2 = v_y_2 / divisor;
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


/* Whether R is a rotation: its ksl_mat3x3_rotation_defect is at most 0.001.  Functions that
   require a rotation return the formula's value for other matrices; Python refuses them. */
static inline bool ksl_mat3x3_is_rotation(const ksl_mat3x3_t *R) {
  return ksl_mat3x3_rotation_defect(R) <= 0.001;
}

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

/* Whether R is a rotation: its ksl_mat3x3f_rotation_defect is at most 0.001f.  Functions that
   require a rotation return the formula's value for other matrices; Python refuses them. */
static inline bool ksl_mat3x3f_is_rotation(const ksl_mat3x3f_t *R) {
  return ksl_mat3x3f_rotation_defect(R) <= 0.001f;
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
