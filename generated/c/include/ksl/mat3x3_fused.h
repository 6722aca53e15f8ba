/* Made by `coscrew generate`; changes are overwritten. */
/* SPDX-License-Identifier: MIT */
/* coscrew 0.1.0.  Copyright (c) 2026 The coscrew authors. */
/* 3×3 matrices: rotations, and matrices in general.
   Fused tier: products fused into sums. */
#ifndef KSL_MAT3X3_FUSED_H
#define KSL_MAT3X3_FUSED_H

#include "ksl_types.h"

/* det R.
   R: rotation or other 3×3 matrix.
   4 mul, 5 fma.
   Error <= u |result| + 4 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline double ksl_mat3x3_determinant_fused(const ksl_mat3x3_t *R) {
  const double n_0a = R->m11 * R->m22, n_0 = fma(-R->m12, R->m21, n_0a);
  const double n_1a = R->m02 * R->m21, n_1 = fma(-R->m01, R->m22, n_1a);
  const double n_2a = R->m01 * R->m12, n_2 = fma(-R->m02, R->m11, n_2a);
  const double det_a = R->m00 * n_0, det_c = fma(R->m10, n_1, det_a), det = fma(R->m20, n_2, det_c);
  return det;
}

/* det R.
   R: rotation or other 3×3 matrix.
   4 mul, 5 fma.
   Error <= u |result| + 4 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline float ksl_mat3x3f_determinant_fused(const ksl_mat3x3f_t *R) {
  const float n_0a = R->m11 * R->m22, n_0 = fmaf(-R->m12, R->m21, n_0a);
  const float n_1a = R->m02 * R->m21, n_1 = fmaf(-R->m01, R->m22, n_1a);
  const float n_2a = R->m01 * R->m12, n_2 = fmaf(-R->m02, R->m11, n_2a);
  const float det_a = R->m00 * n_0, det_c = fmaf(R->m10, n_1, det_a),
      det = fmaf(R->m20, n_2, det_c);
  return det;
}

#endif
