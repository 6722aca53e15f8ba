/* Made by `coscrew generate`; changes are overwritten. */
/* 3×3 matrices: rotations, and matrices in general.
   Accurate tier: double compensated, single computed in double. */
#ifndef KSL_MAT3X3_ACCURATE_H
#define KSL_MAT3X3_ACCURATE_H

#include "ksl_exact.h"

/* det R.
   R: rotation or other 3×3 matrix.
   12 mul, 19 add, 9 product error, 5 sum error.
   Error <= u |result| + 27 u^2 S, S the sum of the |terms| of the expanded formula; barring
     over- and underflow. */
static inline double ksl_mat3x3_determinant_accurate(const ksl_mat3x3_t *R) {
  const double n_0a = R->m11 * R->m22, n_0a_lo = ksl_product_error(R->m11, R->m22, n_0a),
      n_0b = R->m12 * R->m21, n_0b_lo = ksl_product_error(R->m12, R->m21, n_0b), n_0 = n_0a - n_0b,
      n_0_error = ksl_difference_error(n_0a, n_0b, n_0), n_0_lo1 = n_0_error + n_0a_lo,
      n_0_lo = n_0_lo1 - n_0b_lo;
  const double n_1a = R->m02 * R->m21, n_1a_lo = ksl_product_error(R->m02, R->m21, n_1a),
      n_1b = R->m01 * R->m22, n_1b_lo = ksl_product_error(R->m01, R->m22, n_1b), n_1 = n_1a - n_1b,
      n_1_error = ksl_difference_error(n_1a, n_1b, n_1), n_1_lo1 = n_1_error + n_1a_lo,
      n_1_lo = n_1_lo1 - n_1b_lo;
  const double n_2a = R->m01 * R->m12, n_2a_lo = ksl_product_error(R->m01, R->m12, n_2a),
      n_2b = R->m02 * R->m11, n_2b_lo = ksl_product_error(R->m02, R->m11, n_2b), n_2 = n_2a - n_2b,
      n_2_error = ksl_difference_error(n_2a, n_2b, n_2), n_2_lo1 = n_2_error + n_2a_lo,
      n_2_lo = n_2_lo1 - n_2b_lo;
  const double det_a = R->m00 * n_0, det_a_cross1 = R->m00 * n_0_lo,
      det_a_error = ksl_product_error(R->m00, n_0, det_a), det_a_lo = det_a_error + det_a_cross1,
      det_b = R->m10 * n_1, det_b_cross1 = R->m10 * n_1_lo,
      det_b_error = ksl_product_error(R->m10, n_1, det_b), det_b_lo = det_b_error + det_b_cross1,
      det_c = det_a + det_b, det_c_error = ksl_sum_error(det_a, det_b, det_c),
      det_c_lo1 = det_c_error + det_a_lo, det_c_lo = det_c_lo1 + det_b_lo, det_d = R->m20 * n_2,
      det_d_cross1 = R->m20 * n_2_lo, det_d_error = ksl_product_error(R->m20, n_2, det_d),
      det_d_lo = det_d_error + det_d_cross1, det = det_c + det_d,
      det_error = ksl_sum_error(det_c, det_d, det), det_lo1 = det_error + det_c_lo,
      det_lo = det_lo1 + det_d_lo;
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
