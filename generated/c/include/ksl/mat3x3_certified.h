/* Made by `coscrew generate`; changes are overwritten. */
/* SPDX-License-Identifier: MIT */
/* coscrew 0.1.0.  Copyright (c) 2026 The coscrew authors. */
/* 3×3 matrices: rotations, and matrices in general.
   Certified tier: plain results, and bounds of their errors that hold. */
#ifndef KSL_MAT3X3_CERTIFIED_H
#define KSL_MAT3X3_CERTIFIED_H

#include "ksl_types.h"

/* det R; |error of det| <= det_bound unless inf or NaN.
   R: rotation or other 3×3 matrix; det_bound: number.
   13 mul, 14 add, 9 abs. */
static inline double ksl_mat3x3_determinant_certified(const ksl_mat3x3_t *R, double *det_bound) {
  const double n_0a = R->m11 * R->m22, n_0b = R->m12 * R->m21, n_0 = n_0a - n_0b;
  const double n_1a = R->m02 * R->m21, n_1b = R->m01 * R->m22, n_1 = n_1a - n_1b;
  const double n_2a = R->m01 * R->m12, n_2b = R->m02 * R->m11, n_2 = n_2a - n_2b;
  const double det_a = R->m00 * n_0, det_b = R->m10 * n_1, det_c = det_a + det_b,
      det_d = R->m20 * n_2, det = det_c + det_d;
  const double n_0a_abs = fabs(n_0a), n_0b_abs = fabs(n_0b), n_0_size = n_0a_abs + n_0b_abs;
  const double n_1a_abs = fabs(n_1a), n_1b_abs = fabs(n_1b), n_1_size = n_1a_abs + n_1b_abs;
  const double n_2a_abs = fabs(n_2a), n_2b_abs = fabs(n_2b), n_2_size = n_2a_abs + n_2b_abs;
  const double n_0_padded = n_0_size + 2.004168360008973e-292;
  const double R_00_abs = fabs(R->m00), det_a_size = R_00_abs * n_0_padded;
  const double n_1_padded = n_1_size + 2.004168360008973e-292;
  const double R_10_abs = fabs(R->m10), det_b_size = R_10_abs * n_1_padded,
      det_c_size = det_a_size + det_b_size;
  const double n_2_padded = n_2_size + 2.004168360008973e-292;
  const double R_20_abs = fabs(R->m20), det_d_size = R_20_abs * n_2_padded,
      det_size = det_c_size + det_d_size;
  const double det_padded = det_size + 2.004168360008973e-292,
      det_error_bound = 5.551115123125785e-16 * det_padded;
  *det_bound = det_error_bound;
  return det;
}

/* det R; |error of det| <= det_bound unless inf or NaN.
   R: rotation or other 3×3 matrix; det_bound: number.
   13 mul, 14 add, 9 abs. */
static inline float ksl_mat3x3f_determinant_certified(const ksl_mat3x3f_t *R, float *det_bound) {
  const float n_0a = R->m11 * R->m22, n_0b = R->m12 * R->m21, n_0 = n_0a - n_0b;
  const float n_1a = R->m02 * R->m21, n_1b = R->m01 * R->m22, n_1 = n_1a - n_1b;
  const float n_2a = R->m01 * R->m12, n_2b = R->m02 * R->m11, n_2 = n_2a - n_2b;
  const float det_a = R->m00 * n_0, det_b = R->m10 * n_1, det_c = det_a + det_b,
      det_d = R->m20 * n_2, det = det_c + det_d;
  const float n_0a_abs = fabsf(n_0a), n_0b_abs = fabsf(n_0b), n_0_size = n_0a_abs + n_0b_abs;
  const float n_1a_abs = fabsf(n_1a), n_1b_abs = fabsf(n_1b), n_1_size = n_1a_abs + n_1b_abs;
  const float n_2a_abs = fabsf(n_2a), n_2b_abs = fabsf(n_2b), n_2_size = n_2a_abs + n_2b_abs;
  const float n_0_padded = n_0_size + 1.9721523e-31f;
  const float R_00_abs = fabsf(R->m00), det_a_size = R_00_abs * n_0_padded;
  const float n_1_padded = n_1_size + 1.9721523e-31f;
  const float R_10_abs = fabsf(R->m10), det_b_size = R_10_abs * n_1_padded,
      det_c_size = det_a_size + det_b_size;
  const float n_2_padded = n_2_size + 1.9721523e-31f;
  const float R_20_abs = fabsf(R->m20), det_d_size = R_20_abs * n_2_padded,
      det_size = det_c_size + det_d_size;
  const float det_padded = det_size + 1.9721523e-31f, det_error_bound = 2.9802328e-07f * det_padded;
  *det_bound = det_error_bound;
  return det;
}

#endif
