/* Made by `coscrew generate`; changes are overwritten. */
/* SPDX-License-Identifier: MIT */
/* coscrew 0.1.0.  Copyright (c) 2026 The coscrew authors. */
/* 3×3 matrices: rotations, and matrices in general.
   Accurate tier: double compensated, single computed in double. */
#ifndef KSL_MAT3X3_ACCURATE_H
#define KSL_MAT3X3_ACCURATE_H

#include "ksl_exact.h"

/* det R.
   R: rotation or other 3×3 matrix.
   12 mul, 26 add, 9 product rest.
   Error <= u |result| + 28 u^2 S, S the sum of the |terms| of the expanded formula; barring
     over- and underflow. */
static inline double ksl_mat3x3_determinant_accurate(const ksl_mat3x3_t *R) {
  const double n_0a = R->m11 * R->m22, n_0b = R->m12 * R->m21, n_0 = n_0a - n_0b,
      n_0_right = n_0a - n_0, n_0_left = n_0 + n_0_right,
      n_0_left_rest = ksl_product_rest(R->m11, R->m22, n_0a, n_0_left),
      n_0_right_rest = ksl_product_rest(R->m12, R->m21, n_0b, n_0_right),
      n_0_lo = n_0_left_rest - n_0_right_rest;
  const double n_1a = R->m02 * R->m21, n_1b = R->m01 * R->m22, n_1 = n_1a - n_1b,
      n_1_right = n_1a - n_1, n_1_left = n_1 + n_1_right,
      n_1_left_rest = ksl_product_rest(R->m02, R->m21, n_1a, n_1_left),
      n_1_right_rest = ksl_product_rest(R->m01, R->m22, n_1b, n_1_right),
      n_1_lo = n_1_left_rest - n_1_right_rest;
  const double n_2a = R->m01 * R->m12, n_2b = R->m02 * R->m11, n_2 = n_2a - n_2b,
      n_2_right = n_2a - n_2, n_2_left = n_2 + n_2_right,
      n_2_left_rest = ksl_product_rest(R->m01, R->m12, n_2a, n_2_left),
      n_2_right_rest = ksl_product_rest(R->m02, R->m11, n_2b, n_2_right),
      n_2_lo = n_2_left_rest - n_2_right_rest;
  const double det_a = R->m00 * n_0, det_a_cross2 = R->m00 * n_0_lo, det_b = R->m10 * n_1,
      det_b_cross2 = R->m10 * n_1_lo, det_c = det_a + det_b, det_c_right = det_c - det_a,
      det_c_left = det_c - det_c_right,
      det_c_left_rest = ksl_product_rest(R->m00, n_0, det_a, det_c_left),
      det_c_right_rest = ksl_product_rest(R->m10, n_1, det_b, det_c_right),
      det_c_cross = det_a_cross2 + det_b_cross2, det_c_lo1 = det_c_left_rest + det_c_right_rest,
      det_c_lo = det_c_lo1 + det_c_cross, det_d = R->m20 * n_2, det_d_cross2 = R->m20 * n_2_lo,
      det = det_c + det_d, det_right = det - det_c, det_left = det - det_right,
      det_left_rest = det_c - det_left,
      det_right_rest = ksl_product_rest(R->m20, n_2, det_d, det_right),
      det_lo1 = det_left_rest + det_right_rest, det_lo2 = det_lo1 + det_d_cross2,
      det_lo = det_lo2 + det_c_lo;
  const double det_rounded = det + det_lo;
  return det_rounded;
}

/* det R.
   R: rotation or other 3×3 matrix.
   9 mul, 5 add.
   Error <= u |result| + 5/32 u^2 S, S the sum of the |terms| of the expanded formula; barring
     over- and underflow. */
static inline float ksl_mat3x3f_determinant_accurate(const ksl_mat3x3f_t *R) {
  const double n_0a = (double)R->m11 * (double)R->m22, n_0b = (double)R->m12 * (double)R->m21,
      n_0 = n_0a - n_0b;
  const double n_1a = (double)R->m02 * (double)R->m21, n_1b = (double)R->m01 * (double)R->m22,
      n_1 = n_1a - n_1b;
  const double n_2a = (double)R->m01 * (double)R->m12, n_2b = (double)R->m02 * (double)R->m11,
      n_2 = n_2a - n_2b;
  const double det_a = (double)R->m00 * n_0, det_b = (double)R->m10 * n_1, det_c = det_a + det_b,
      det_d = (double)R->m20 * n_2, det = det_c + det_d;
  return (float)det;
}

#endif
