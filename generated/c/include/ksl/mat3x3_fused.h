/* Made by `coscrew generate`; changes are overwritten. */
/* SPDX-License-Identifier: MIT */
/* coscrew 0.2.0.  Copyright (c) 2026 The coscrew authors. */
/* 3×3 matrices: rotations, and matrices in general.
   Fused tier: products fused into sums. */
#ifndef KSL_MAT3X3_FUSED_H
#define KSL_MAT3X3_FUSED_H

#include "ksl_types.h"

/* Ro = w'~ + w~ w~ of a body with angular velocity w and angular acceleration w' = dw: the
     acceleration of its point x, less that of its origin, is Ro x.
   w, dw: vector; Ro: rotation or other 3×3 matrix.
   6 mul, 9 add, 3 neg.
   Error <= u |result| + 1 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_acceleration_tensor_fused(const ksl_vec3_t *w, const ksl_vec3_t *dw,
    ksl_mat3x3_t *Ro) {
  const double ww_0 = KSL_MUL(w->x, w->x);
  const double ww_1 = KSL_MUL(w->y, w->y);
  const double ww_2 = KSL_MUL(w->z, w->z);
  const double ww_3 = KSL_MUL(w->x, w->y);
  const double ww_4 = KSL_MUL(w->x, w->z);
  const double ww_5 = KSL_MUL(w->y, w->z);
  const double Ro_00a_lead = -ww_1, Ro_00 = Ro_00a_lead - ww_2;
  const double Ro_01 = ww_3 - dw->z;
  const double Ro_02 = dw->y + ww_4;
  const double Ro_10 = dw->z + ww_3;
  const double Ro_11a_lead = -ww_0, Ro_11 = Ro_11a_lead - ww_2;
  const double Ro_12 = ww_5 - dw->x;
  const double Ro_20 = ww_4 - dw->y;
  const double Ro_21 = dw->x + ww_5;
  const double Ro_22a_lead = -ww_0, Ro_22 = Ro_22a_lead - ww_1;
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

/* det R.
   R: rotation or other 3×3 matrix.
   4 mul, 5 fma.
   Error <= u |result| + 4 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline double ksl_mat3x3_determinant_fused(const ksl_mat3x3_t *R) {
  const double n_0a = KSL_MUL(R->m11, R->m22), n_0 = fma(-R->m12, R->m21, n_0a);
  const double n_1a = KSL_MUL(R->m02, R->m21), n_1 = fma(-R->m01, R->m22, n_1a);
  const double n_2a = KSL_MUL(R->m01, R->m12), n_2 = fma(-R->m02, R->m11, n_2a);
  const double det_a = KSL_MUL(R->m00, n_0), det_c = fma(R->m10, n_1, det_a),
      det = fma(R->m20, n_2, det_c);
  return det;
}

/* R = cos θ I + sin θ a~ + (1 - cos θ) a a^T, a = axis of length 1 (else R is not a rotation),
     dc = (sin θ, cos θ).
   R: rotation or other 3×3 matrix; axis: vector; dc: (sin θ, cos θ).
   9 mul, 7 add, 3 fma.
   Error <= u |result| + 3 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_mat3x3_setFromAxisDC_fused(ksl_mat3x3_t *R, const ksl_vec3_t *axis,
    const double dc[2]) {
  const double versine = 1.0 - dc[1];
  const double versine_axis_0 = KSL_MUL(axis->x, versine);
  const double versine_axis_1 = KSL_MUL(axis->y, versine);
  const double versine_axis_2 = KSL_MUL(axis->z, versine);
  const double m_3 = KSL_MUL(axis->y, versine_axis_0);
  const double m_4 = KSL_MUL(axis->z, versine_axis_0);
  const double m_5 = KSL_MUL(axis->z, versine_axis_1);
  const double sine_axis_0 = KSL_MUL(axis->x, dc[0]);
  const double sine_axis_1 = KSL_MUL(axis->y, dc[0]);
  const double sine_axis_2 = KSL_MUL(axis->z, dc[0]);
  const double R_00 = fma(axis->x, versine_axis_0, dc[1]);
  const double R_01 = m_3 - sine_axis_2;
  const double R_02 = m_4 + sine_axis_1;
  const double R_10 = m_3 + sine_axis_2;
  const double R_11 = fma(axis->y, versine_axis_1, dc[1]);
  const double R_12 = m_5 - sine_axis_0;
  const double R_20 = m_4 - sine_axis_1;
  const double R_21 = m_5 + sine_axis_0;
  const double R_22 = fma(axis->z, versine_axis_2, dc[1]);
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

/* Ro = w'~ + w~ w~ of a body with angular velocity w and angular acceleration w' = dw: the
     acceleration of its point x, less that of its origin, is Ro x.
   w, dw: vector; Ro: rotation or other 3×3 matrix.
   6 mul, 9 add, 3 neg.
   Error <= u |result| + 1 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_acceleration_tensorf_fused(const ksl_vec3f_t *w, const ksl_vec3f_t *dw,
    ksl_mat3x3f_t *Ro) {
  const float ww_0 = KSL_MULF(w->x, w->x);
  const float ww_1 = KSL_MULF(w->y, w->y);
  const float ww_2 = KSL_MULF(w->z, w->z);
  const float ww_3 = KSL_MULF(w->x, w->y);
  const float ww_4 = KSL_MULF(w->x, w->z);
  const float ww_5 = KSL_MULF(w->y, w->z);
  const float Ro_00a_lead = -ww_1, Ro_00 = Ro_00a_lead - ww_2;
  const float Ro_01 = ww_3 - dw->z;
  const float Ro_02 = dw->y + ww_4;
  const float Ro_10 = dw->z + ww_3;
  const float Ro_11a_lead = -ww_0, Ro_11 = Ro_11a_lead - ww_2;
  const float Ro_12 = ww_5 - dw->x;
  const float Ro_20 = ww_4 - dw->y;
  const float Ro_21 = dw->x + ww_5;
  const float Ro_22a_lead = -ww_0, Ro_22 = Ro_22a_lead - ww_1;
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

/* det R.
   R: rotation or other 3×3 matrix.
   4 mul, 5 fma.
   Error <= u |result| + 4 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline float ksl_mat3x3f_determinant_fused(const ksl_mat3x3f_t *R) {
  const float n_0a = KSL_MULF(R->m11, R->m22), n_0 = fmaf(-R->m12, R->m21, n_0a);
  const float n_1a = KSL_MULF(R->m02, R->m21), n_1 = fmaf(-R->m01, R->m22, n_1a);
  const float n_2a = KSL_MULF(R->m01, R->m12), n_2 = fmaf(-R->m02, R->m11, n_2a);
  const float det_a = KSL_MULF(R->m00, n_0), det_c = fmaf(R->m10, n_1, det_a),
      det = fmaf(R->m20, n_2, det_c);
  return det;
}

/* R = cos θ I + sin θ a~ + (1 - cos θ) a a^T, a = axis of length 1 (else R is not a rotation),
     dc = (sin θ, cos θ).
   R: rotation or other 3×3 matrix; axis: vector; dc: (sin θ, cos θ).
   9 mul, 7 add, 3 fma.
   Error <= u |result| + 3 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_mat3x3f_setFromAxisDC_fused(ksl_mat3x3f_t *R, const ksl_vec3f_t *axis,
    const float dc[2]) {
  const float versine = 1.0f - dc[1];
  const float versine_axis_0 = KSL_MULF(axis->x, versine);
  const float versine_axis_1 = KSL_MULF(axis->y, versine);
  const float versine_axis_2 = KSL_MULF(axis->z, versine);
  const float m_3 = KSL_MULF(axis->y, versine_axis_0);
  const float m_4 = KSL_MULF(axis->z, versine_axis_0);
  const float m_5 = KSL_MULF(axis->z, versine_axis_1);
  const float sine_axis_0 = KSL_MULF(axis->x, dc[0]);
  const float sine_axis_1 = KSL_MULF(axis->y, dc[0]);
  const float sine_axis_2 = KSL_MULF(axis->z, dc[0]);
  const float R_00 = fmaf(axis->x, versine_axis_0, dc[1]);
  const float R_01 = m_3 - sine_axis_2;
  const float R_02 = m_4 + sine_axis_1;
  const float R_10 = m_3 + sine_axis_2;
  const float R_11 = fmaf(axis->y, versine_axis_1, dc[1]);
  const float R_12 = m_5 - sine_axis_0;
  const float R_20 = m_4 - sine_axis_1;
  const float R_21 = m_5 + sine_axis_0;
  const float R_22 = fmaf(axis->z, versine_axis_2, dc[1]);
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

#endif
