/* Made by `coscrew generate`; changes are overwritten. */
/* SPDX-License-Identifier: MIT */
/* coscrew 0.2.0.  Copyright (c) 2026 The coscrew authors. */
/* 3×3 matrices: rotations, and matrices in general.
   Certified tier: plain results, and bounds on their errors that always hold. */
#ifndef KSL_MAT3X3_CERTIFIED_H
#define KSL_MAT3X3_CERTIFIED_H

#include "ksl_types.h"

/* Ro = w'~ + w~ w~ of a body with angular velocity w and angular acceleration w' = dw: the
     acceleration of its point x, less that of its origin, is Ro x; |error of Ro| <= Ro_bound
     unless inf or NaN.
   w, dw: vector; Ro, Ro_bound: rotation or other 3×3 matrix.
   15 mul, 27 add, 3 neg, 9 abs. */
static inline void ksl_acceleration_tensor_certified(const ksl_vec3_t *w, const ksl_vec3_t *dw,
    ksl_mat3x3_t *Ro, ksl_mat3x3_t *Ro_bound) {
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
  const double ww_1_abs = fabs(ww_1), ww_2_abs = fabs(ww_2), Ro_00a_size = ww_1_abs + ww_2_abs;
  const double ww_3_abs = fabs(ww_3), dw_2_abs = fabs(dw->z), Ro_01_size = ww_3_abs + dw_2_abs;
  const double dw_1_abs = fabs(dw->y), ww_4_abs = fabs(ww_4), Ro_02_size = dw_1_abs + ww_4_abs;
  const double Ro_10_size = dw_2_abs + ww_3_abs;
  const double ww_0_abs = fabs(ww_0), Ro_11a_size = ww_0_abs + ww_2_abs;
  const double ww_5_abs = fabs(ww_5), dw_0_abs = fabs(dw->x), Ro_12_size = ww_5_abs + dw_0_abs;
  const double Ro_20_size = ww_4_abs + dw_1_abs;
  const double Ro_21_size = dw_0_abs + ww_5_abs;
  const double Ro_22a_size = ww_0_abs + ww_1_abs;
  const double Ro_00a_padded = Ro_00a_size + 2.004168360008973e-292,
      Ro_00a_error_bound = KSL_MUL(2.2204460492503136e-16, Ro_00a_padded);
  const double Ro_01_padded = Ro_01_size + 2.004168360008973e-292,
      Ro_01_error_bound = KSL_MUL(2.2204460492503136e-16, Ro_01_padded);
  const double Ro_02_padded = Ro_02_size + 2.004168360008973e-292,
      Ro_02_error_bound = KSL_MUL(2.2204460492503136e-16, Ro_02_padded);
  const double Ro_10_padded = Ro_10_size + 2.004168360008973e-292,
      Ro_10_error_bound = KSL_MUL(2.2204460492503136e-16, Ro_10_padded);
  const double Ro_11a_padded = Ro_11a_size + 2.004168360008973e-292,
      Ro_11a_error_bound = KSL_MUL(2.2204460492503136e-16, Ro_11a_padded);
  const double Ro_12_padded = Ro_12_size + 2.004168360008973e-292,
      Ro_12_error_bound = KSL_MUL(2.2204460492503136e-16, Ro_12_padded);
  const double Ro_20_padded = Ro_20_size + 2.004168360008973e-292,
      Ro_20_error_bound = KSL_MUL(2.2204460492503136e-16, Ro_20_padded);
  const double Ro_21_padded = Ro_21_size + 2.004168360008973e-292,
      Ro_21_error_bound = KSL_MUL(2.2204460492503136e-16, Ro_21_padded);
  const double Ro_22a_padded = Ro_22a_size + 2.004168360008973e-292,
      Ro_22a_error_bound = KSL_MUL(2.2204460492503136e-16, Ro_22a_padded);
  Ro->m00 = Ro_00;
  Ro->m01 = Ro_01;
  Ro->m02 = Ro_02;
  Ro->m10 = Ro_10;
  Ro->m11 = Ro_11;
  Ro->m12 = Ro_12;
  Ro->m20 = Ro_20;
  Ro->m21 = Ro_21;
  Ro->m22 = Ro_22;
  Ro_bound->m00 = Ro_00a_error_bound;
  Ro_bound->m01 = Ro_01_error_bound;
  Ro_bound->m02 = Ro_02_error_bound;
  Ro_bound->m10 = Ro_10_error_bound;
  Ro_bound->m11 = Ro_11a_error_bound;
  Ro_bound->m12 = Ro_12_error_bound;
  Ro_bound->m20 = Ro_20_error_bound;
  Ro_bound->m21 = Ro_21_error_bound;
  Ro_bound->m22 = Ro_22a_error_bound;
}

/* det R; |error of det| <= det_bound unless inf or NaN.
   R: rotation or other 3×3 matrix; det_bound: number.
   13 mul, 14 add, 9 abs. */
static inline double ksl_mat3x3_determinant_certified(const ksl_mat3x3_t *R, double *det_bound) {
  const double n_0a = KSL_MUL(R->m11, R->m22), n_0b = KSL_MUL(R->m12, R->m21), n_0 = n_0a - n_0b;
  const double n_1a = KSL_MUL(R->m02, R->m21), n_1b = KSL_MUL(R->m01, R->m22), n_1 = n_1a - n_1b;
  const double n_2a = KSL_MUL(R->m01, R->m12), n_2b = KSL_MUL(R->m02, R->m11), n_2 = n_2a - n_2b;
  const double det_a = KSL_MUL(R->m00, n_0), det_b = KSL_MUL(R->m10, n_1), det_c = det_a + det_b,
      det_d = KSL_MUL(R->m20, n_2), det = det_c + det_d;
  const double n_0a_abs = fabs(n_0a), n_0b_abs = fabs(n_0b), n_0_size = n_0a_abs + n_0b_abs;
  const double n_1a_abs = fabs(n_1a), n_1b_abs = fabs(n_1b), n_1_size = n_1a_abs + n_1b_abs;
  const double n_2a_abs = fabs(n_2a), n_2b_abs = fabs(n_2b), n_2_size = n_2a_abs + n_2b_abs;
  const double n_0_padded = n_0_size + 2.004168360008973e-292;
  const double R_00_abs = fabs(R->m00), det_a_size = KSL_MUL(R_00_abs, n_0_padded);
  const double n_1_padded = n_1_size + 2.004168360008973e-292;
  const double R_10_abs = fabs(R->m10), det_b_size = KSL_MUL(R_10_abs, n_1_padded),
      det_c_size = det_a_size + det_b_size;
  const double n_2_padded = n_2_size + 2.004168360008973e-292;
  const double R_20_abs = fabs(R->m20), det_d_size = KSL_MUL(R_20_abs, n_2_padded),
      det_size = det_c_size + det_d_size;
  const double det_padded = det_size + 2.004168360008973e-292,
      det_error_bound = KSL_MUL(5.551115123125785e-16, det_padded);
  *det_bound = det_error_bound;
  return det;
}

/* R = cos θ I + sin θ a~ + (1 - cos θ) a a^T, a = axis of length 1 (else R is not a rotation),
     dc = (sin θ, cos θ); |error of R| <= R_bound unless inf or NaN.
   R, R_bound: rotation or other 3×3 matrix; axis: vector; dc: (sin θ, cos θ).
   30 mul, 31 add, 8 abs. */
static inline void ksl_mat3x3_setFromAxisDC_certified(ksl_mat3x3_t *R, const ksl_vec3_t *axis,
    const double dc[2], ksl_mat3x3_t *R_bound) {
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
  const double axis_0_abs = fabs(axis->x), versine_abs = fabs(versine),
      versine_axis_0_size = KSL_MUL(axis_0_abs, versine_abs);
  const double axis_1_abs = fabs(axis->y), versine_axis_1_size = KSL_MUL(axis_1_abs, versine_abs);
  const double axis_2_abs = fabs(axis->z), versine_axis_2_size = KSL_MUL(axis_2_abs, versine_abs);
  const double versine_axis_0_padded = versine_axis_0_size + 2.004168360008973e-292;
  const double m_0_size = KSL_MUL(axis_0_abs, versine_axis_0_padded);
  const double versine_axis_1_padded = versine_axis_1_size + 2.004168360008973e-292;
  const double m_1_size = KSL_MUL(axis_1_abs, versine_axis_1_padded);
  const double versine_axis_2_padded = versine_axis_2_size + 2.004168360008973e-292;
  const double m_2_size = KSL_MUL(axis_2_abs, versine_axis_2_padded);
  const double m_3_size = KSL_MUL(axis_1_abs, versine_axis_0_padded);
  const double m_4_size = KSL_MUL(axis_2_abs, versine_axis_0_padded);
  const double m_5_size = KSL_MUL(axis_2_abs, versine_axis_1_padded);
  const double dc_1_abs = fabs(dc[1]), R_00_size = dc_1_abs + m_0_size;
  const double sine_axis_2_abs = fabs(sine_axis_2), R_01_size = m_3_size + sine_axis_2_abs;
  const double sine_axis_1_abs = fabs(sine_axis_1), R_02_size = m_4_size + sine_axis_1_abs;
  const double R_10_size = m_3_size + sine_axis_2_abs;
  const double R_11_size = dc_1_abs + m_1_size;
  const double sine_axis_0_abs = fabs(sine_axis_0), R_12_size = m_5_size + sine_axis_0_abs;
  const double R_20_size = m_4_size + sine_axis_1_abs;
  const double R_21_size = m_5_size + sine_axis_0_abs;
  const double R_22_size = dc_1_abs + m_2_size;
  const double R_00_padded = R_00_size + 2.004168360008973e-292,
      R_00_error_bound = KSL_MUL(4.440892098500628e-16, R_00_padded);
  const double R_01_padded = R_01_size + 2.004168360008973e-292,
      R_01_error_bound = KSL_MUL(4.440892098500628e-16, R_01_padded);
  const double R_02_padded = R_02_size + 2.004168360008973e-292,
      R_02_error_bound = KSL_MUL(4.440892098500628e-16, R_02_padded);
  const double R_10_padded = R_10_size + 2.004168360008973e-292,
      R_10_error_bound = KSL_MUL(4.440892098500628e-16, R_10_padded);
  const double R_11_padded = R_11_size + 2.004168360008973e-292,
      R_11_error_bound = KSL_MUL(4.440892098500628e-16, R_11_padded);
  const double R_12_padded = R_12_size + 2.004168360008973e-292,
      R_12_error_bound = KSL_MUL(4.440892098500628e-16, R_12_padded);
  const double R_20_padded = R_20_size + 2.004168360008973e-292,
      R_20_error_bound = KSL_MUL(4.440892098500628e-16, R_20_padded);
  const double R_21_padded = R_21_size + 2.004168360008973e-292,
      R_21_error_bound = KSL_MUL(4.440892098500628e-16, R_21_padded);
  const double R_22_padded = R_22_size + 2.004168360008973e-292,
      R_22_error_bound = KSL_MUL(4.440892098500628e-16, R_22_padded);
  R->m00 = R_00;
  R->m01 = R_01;
  R->m02 = R_02;
  R->m10 = R_10;
  R->m11 = R_11;
  R->m12 = R_12;
  R->m20 = R_20;
  R->m21 = R_21;
  R->m22 = R_22;
  R_bound->m00 = R_00_error_bound;
  R_bound->m01 = R_01_error_bound;
  R_bound->m02 = R_02_error_bound;
  R_bound->m10 = R_10_error_bound;
  R_bound->m11 = R_11_error_bound;
  R_bound->m12 = R_12_error_bound;
  R_bound->m20 = R_20_error_bound;
  R_bound->m21 = R_21_error_bound;
  R_bound->m22 = R_22_error_bound;
}

/* Ro = w'~ + w~ w~ of a body with angular velocity w and angular acceleration w' = dw: the
     acceleration of its point x, less that of its origin, is Ro x; |error of Ro| <= Ro_bound
     unless inf or NaN.
   w, dw: vector; Ro, Ro_bound: rotation or other 3×3 matrix.
   15 mul, 27 add, 3 neg, 9 abs. */
static inline void ksl_acceleration_tensorf_certified(const ksl_vec3f_t *w, const ksl_vec3f_t *dw,
    ksl_mat3x3f_t *Ro, ksl_mat3x3f_t *Ro_bound) {
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
  const float ww_1_abs = fabsf(ww_1), ww_2_abs = fabsf(ww_2), Ro_00a_size = ww_1_abs + ww_2_abs;
  const float ww_3_abs = fabsf(ww_3), dw_2_abs = fabsf(dw->z), Ro_01_size = ww_3_abs + dw_2_abs;
  const float dw_1_abs = fabsf(dw->y), ww_4_abs = fabsf(ww_4), Ro_02_size = dw_1_abs + ww_4_abs;
  const float Ro_10_size = dw_2_abs + ww_3_abs;
  const float ww_0_abs = fabsf(ww_0), Ro_11a_size = ww_0_abs + ww_2_abs;
  const float ww_5_abs = fabsf(ww_5), dw_0_abs = fabsf(dw->x), Ro_12_size = ww_5_abs + dw_0_abs;
  const float Ro_20_size = ww_4_abs + dw_1_abs;
  const float Ro_21_size = dw_0_abs + ww_5_abs;
  const float Ro_22a_size = ww_0_abs + ww_1_abs;
  const float Ro_00a_padded = Ro_00a_size + 1.9721523e-31f,
      Ro_00a_error_bound = KSL_MULF(1.192093e-07f, Ro_00a_padded);
  const float Ro_01_padded = Ro_01_size + 1.9721523e-31f,
      Ro_01_error_bound = KSL_MULF(1.192093e-07f, Ro_01_padded);
  const float Ro_02_padded = Ro_02_size + 1.9721523e-31f,
      Ro_02_error_bound = KSL_MULF(1.192093e-07f, Ro_02_padded);
  const float Ro_10_padded = Ro_10_size + 1.9721523e-31f,
      Ro_10_error_bound = KSL_MULF(1.192093e-07f, Ro_10_padded);
  const float Ro_11a_padded = Ro_11a_size + 1.9721523e-31f,
      Ro_11a_error_bound = KSL_MULF(1.192093e-07f, Ro_11a_padded);
  const float Ro_12_padded = Ro_12_size + 1.9721523e-31f,
      Ro_12_error_bound = KSL_MULF(1.192093e-07f, Ro_12_padded);
  const float Ro_20_padded = Ro_20_size + 1.9721523e-31f,
      Ro_20_error_bound = KSL_MULF(1.192093e-07f, Ro_20_padded);
  const float Ro_21_padded = Ro_21_size + 1.9721523e-31f,
      Ro_21_error_bound = KSL_MULF(1.192093e-07f, Ro_21_padded);
  const float Ro_22a_padded = Ro_22a_size + 1.9721523e-31f,
      Ro_22a_error_bound = KSL_MULF(1.192093e-07f, Ro_22a_padded);
  Ro->m00 = Ro_00;
  Ro->m01 = Ro_01;
  Ro->m02 = Ro_02;
  Ro->m10 = Ro_10;
  Ro->m11 = Ro_11;
  Ro->m12 = Ro_12;
  Ro->m20 = Ro_20;
  Ro->m21 = Ro_21;
  Ro->m22 = Ro_22;
  Ro_bound->m00 = Ro_00a_error_bound;
  Ro_bound->m01 = Ro_01_error_bound;
  Ro_bound->m02 = Ro_02_error_bound;
  Ro_bound->m10 = Ro_10_error_bound;
  Ro_bound->m11 = Ro_11a_error_bound;
  Ro_bound->m12 = Ro_12_error_bound;
  Ro_bound->m20 = Ro_20_error_bound;
  Ro_bound->m21 = Ro_21_error_bound;
  Ro_bound->m22 = Ro_22a_error_bound;
}

/* det R; |error of det| <= det_bound unless inf or NaN.
   R: rotation or other 3×3 matrix; det_bound: number.
   13 mul, 14 add, 9 abs. */
static inline float ksl_mat3x3f_determinant_certified(const ksl_mat3x3f_t *R, float *det_bound) {
  const float n_0a = KSL_MULF(R->m11, R->m22), n_0b = KSL_MULF(R->m12, R->m21), n_0 = n_0a - n_0b;
  const float n_1a = KSL_MULF(R->m02, R->m21), n_1b = KSL_MULF(R->m01, R->m22), n_1 = n_1a - n_1b;
  const float n_2a = KSL_MULF(R->m01, R->m12), n_2b = KSL_MULF(R->m02, R->m11), n_2 = n_2a - n_2b;
  const float det_a = KSL_MULF(R->m00, n_0), det_b = KSL_MULF(R->m10, n_1), det_c = det_a + det_b,
      det_d = KSL_MULF(R->m20, n_2), det = det_c + det_d;
  const float n_0a_abs = fabsf(n_0a), n_0b_abs = fabsf(n_0b), n_0_size = n_0a_abs + n_0b_abs;
  const float n_1a_abs = fabsf(n_1a), n_1b_abs = fabsf(n_1b), n_1_size = n_1a_abs + n_1b_abs;
  const float n_2a_abs = fabsf(n_2a), n_2b_abs = fabsf(n_2b), n_2_size = n_2a_abs + n_2b_abs;
  const float n_0_padded = n_0_size + 1.9721523e-31f;
  const float R_00_abs = fabsf(R->m00), det_a_size = KSL_MULF(R_00_abs, n_0_padded);
  const float n_1_padded = n_1_size + 1.9721523e-31f;
  const float R_10_abs = fabsf(R->m10), det_b_size = KSL_MULF(R_10_abs, n_1_padded),
      det_c_size = det_a_size + det_b_size;
  const float n_2_padded = n_2_size + 1.9721523e-31f;
  const float R_20_abs = fabsf(R->m20), det_d_size = KSL_MULF(R_20_abs, n_2_padded),
      det_size = det_c_size + det_d_size;
  const float det_padded = det_size + 1.9721523e-31f,
      det_error_bound = KSL_MULF(2.9802328e-07f, det_padded);
  *det_bound = det_error_bound;
  return det;
}

/* R = cos θ I + sin θ a~ + (1 - cos θ) a a^T, a = axis of length 1 (else R is not a rotation),
     dc = (sin θ, cos θ); |error of R| <= R_bound unless inf or NaN.
   R, R_bound: rotation or other 3×3 matrix; axis: vector; dc: (sin θ, cos θ).
   30 mul, 31 add, 8 abs. */
static inline void ksl_mat3x3f_setFromAxisDC_certified(ksl_mat3x3f_t *R, const ksl_vec3f_t *axis,
    const float dc[2], ksl_mat3x3f_t *R_bound) {
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
  const float axis_0_abs = fabsf(axis->x), versine_abs = fabsf(versine),
      versine_axis_0_size = KSL_MULF(axis_0_abs, versine_abs);
  const float axis_1_abs = fabsf(axis->y), versine_axis_1_size = KSL_MULF(axis_1_abs, versine_abs);
  const float axis_2_abs = fabsf(axis->z), versine_axis_2_size = KSL_MULF(axis_2_abs, versine_abs);
  const float versine_axis_0_padded = versine_axis_0_size + 1.9721523e-31f;
  const float m_0_size = KSL_MULF(axis_0_abs, versine_axis_0_padded);
  const float versine_axis_1_padded = versine_axis_1_size + 1.9721523e-31f;
  const float m_1_size = KSL_MULF(axis_1_abs, versine_axis_1_padded);
  const float versine_axis_2_padded = versine_axis_2_size + 1.9721523e-31f;
  const float m_2_size = KSL_MULF(axis_2_abs, versine_axis_2_padded);
  const float m_3_size = KSL_MULF(axis_1_abs, versine_axis_0_padded);
  const float m_4_size = KSL_MULF(axis_2_abs, versine_axis_0_padded);
  const float m_5_size = KSL_MULF(axis_2_abs, versine_axis_1_padded);
  const float dc_1_abs = fabsf(dc[1]), R_00_size = dc_1_abs + m_0_size;
  const float sine_axis_2_abs = fabsf(sine_axis_2), R_01_size = m_3_size + sine_axis_2_abs;
  const float sine_axis_1_abs = fabsf(sine_axis_1), R_02_size = m_4_size + sine_axis_1_abs;
  const float R_10_size = m_3_size + sine_axis_2_abs;
  const float R_11_size = dc_1_abs + m_1_size;
  const float sine_axis_0_abs = fabsf(sine_axis_0), R_12_size = m_5_size + sine_axis_0_abs;
  const float R_20_size = m_4_size + sine_axis_1_abs;
  const float R_21_size = m_5_size + sine_axis_0_abs;
  const float R_22_size = dc_1_abs + m_2_size;
  const float R_00_padded = R_00_size + 1.9721523e-31f,
      R_00_error_bound = KSL_MULF(2.3841864e-07f, R_00_padded);
  const float R_01_padded = R_01_size + 1.9721523e-31f,
      R_01_error_bound = KSL_MULF(2.3841864e-07f, R_01_padded);
  const float R_02_padded = R_02_size + 1.9721523e-31f,
      R_02_error_bound = KSL_MULF(2.3841864e-07f, R_02_padded);
  const float R_10_padded = R_10_size + 1.9721523e-31f,
      R_10_error_bound = KSL_MULF(2.3841864e-07f, R_10_padded);
  const float R_11_padded = R_11_size + 1.9721523e-31f,
      R_11_error_bound = KSL_MULF(2.3841864e-07f, R_11_padded);
  const float R_12_padded = R_12_size + 1.9721523e-31f,
      R_12_error_bound = KSL_MULF(2.3841864e-07f, R_12_padded);
  const float R_20_padded = R_20_size + 1.9721523e-31f,
      R_20_error_bound = KSL_MULF(2.3841864e-07f, R_20_padded);
  const float R_21_padded = R_21_size + 1.9721523e-31f,
      R_21_error_bound = KSL_MULF(2.3841864e-07f, R_21_padded);
  const float R_22_padded = R_22_size + 1.9721523e-31f,
      R_22_error_bound = KSL_MULF(2.3841864e-07f, R_22_padded);
  R->m00 = R_00;
  R->m01 = R_01;
  R->m02 = R_02;
  R->m10 = R_10;
  R->m11 = R_11;
  R->m12 = R_12;
  R->m20 = R_20;
  R->m21 = R_21;
  R->m22 = R_22;
  R_bound->m00 = R_00_error_bound;
  R_bound->m01 = R_01_error_bound;
  R_bound->m02 = R_02_error_bound;
  R_bound->m10 = R_10_error_bound;
  R_bound->m11 = R_11_error_bound;
  R_bound->m12 = R_12_error_bound;
  R_bound->m20 = R_20_error_bound;
  R_bound->m21 = R_21_error_bound;
  R_bound->m22 = R_22_error_bound;
}

#endif
