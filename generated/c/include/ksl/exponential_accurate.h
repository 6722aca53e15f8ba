/* Made by `coscrew generate`; changes are overwritten. */
/* SPDX-License-Identifier: MIT */
/* coscrew 0.2.0.  Copyright (c) 2026 The coscrew authors. */
/* Exponentials and logarithms of rotations and displacements, their Jacobians, interpolation.
   Accurate tier: double compensated, single computed in double. */
#ifndef KSL_EXPONENTIAL_ACCURATE_H
#define KSL_EXPONENTIAL_ACCURATE_H

#include "ksl_exact.h"
#include "elementary.h"
#include "ksl_elementary_error.h"

/* vo with exp vo~ = R, |vo| <= π; if R is not quite a rotation, its defect carries over to vo.
   R: rotation or other 3×3 matrix; vo: vector.
   40 mul, 221 add, 5 product error, 3 product rest, 8 div, 1 sqrt, 1 atan2, 1 atan2 error, 12
     neg, 5 abs, 16 less, 10 equal, 58 select.
   Error <= vo: 7 u of its largest component for R a rotation; searched, not proved. */
static inline void ksl_SO3_log_accurate(const ksl_mat3x3_t *R, ksl_vec3_t *vo) {
  const double p_0 = R->m21 - R->m12, p_0_right = R->m21 - p_0, p_0_left = p_0 + p_0_right,
      p_0_left_rest = R->m21 - p_0_left, p_0_right_rest = R->m12 - p_0_right,
      p_0_lo = p_0_left_rest - p_0_right_rest;
  const double p_1 = R->m02 - R->m20, p_1_right = R->m02 - p_1, p_1_left = p_1 + p_1_right,
      p_1_left_rest = R->m02 - p_1_left, p_1_right_rest = R->m20 - p_1_right,
      p_1_lo = p_1_left_rest - p_1_right_rest;
  const double p_2 = R->m10 - R->m01, p_2_right = R->m10 - p_2, p_2_left = p_2 + p_2_right,
      p_2_left_rest = R->m10 - p_2_left, p_2_right_rest = R->m01 - p_2_right,
      p_2_lo = p_2_left_rest - p_2_right_rest;
  const double s_0 = R->m12 + R->m21, s_0_right = s_0 - R->m12, s_0_left = s_0 - s_0_right,
      s_0_left_rest = R->m12 - s_0_left, s_0_right_rest = R->m21 - s_0_right,
      s_0_lo = s_0_left_rest + s_0_right_rest;
  const double s_1 = R->m02 + R->m20, s_1_right = s_1 - R->m02, s_1_left = s_1 - s_1_right,
      s_1_left_rest = R->m02 - s_1_left, s_1_right_rest = R->m20 - s_1_right,
      s_1_lo = s_1_left_rest + s_1_right_rest;
  const double s_2 = R->m01 + R->m10, s_2_right = s_2 - R->m01, s_2_left = s_2 - s_2_right,
      s_2_left_rest = R->m01 - s_2_left, s_2_right_rest = R->m10 - s_2_right,
      s_2_lo = s_2_left_rest + s_2_right_rest;
  const double first_0 = R->m00 + 1.0, first_0_right = first_0 - R->m00,
      first_0_left = first_0 - first_0_right, first_0_left_rest = R->m00 - first_0_left,
      first_0_right_rest = 1.0 - first_0_right, first_0_lo = first_0_left_rest + first_0_right_rest;
  const double first_1 = 1.0 - R->m00, first_1_right = 1.0 - first_1,
      first_1_left = first_1 + first_1_right, first_1_left_rest = 1.0 - first_1_left,
      first_1_right_rest = R->m00 - first_1_right,
      first_1_lo = first_1_left_rest - first_1_right_rest;
  const double others_0 = R->m11 + R->m22, others_0_right = others_0 - R->m11,
      others_0_left = others_0 - others_0_right, others_0_left_rest = R->m11 - others_0_left,
      others_0_right_rest = R->m22 - others_0_right,
      others_0_lo = others_0_left_rest + others_0_right_rest;
  const double others_1 = R->m11 - R->m22, others_1_right = R->m11 - others_1,
      others_1_left = others_1 + others_1_right, others_1_left_rest = R->m11 - others_1_left,
      others_1_right_rest = R->m22 - others_1_right,
      others_1_lo = others_1_left_rest - others_1_right_rest;
  const double d_0 = first_0 + others_0, d_0_right = d_0 - first_0, d_0_left = d_0 - d_0_right,
      d_0_left_rest = first_0 - d_0_left, d_0_right_rest = others_0 - d_0_right,
      d_0_lo1 = d_0_left_rest + d_0_right_rest, d_0_lo2 = d_0_lo1 + others_0_lo,
      d_0_lo = d_0_lo2 + first_0_lo;
  const double d_1 = first_0 - others_0, d_1_right = first_0 - d_1, d_1_left = d_1 + d_1_right,
      d_1_left_rest = first_0 - d_1_left, d_1_right_rest = others_0 - d_1_right,
      d_1_lo1 = d_1_left_rest - d_1_right_rest, d_1_lo2 = d_1_lo1 - others_0_lo,
      d_1_lo = d_1_lo2 + first_0_lo;
  const double d_2 = first_1 + others_1, d_2_right = d_2 - first_1, d_2_left = d_2 - d_2_right,
      d_2_left_rest = first_1 - d_2_left, d_2_right_rest = others_1 - d_2_right,
      d_2_lo1 = d_2_left_rest + d_2_right_rest, d_2_lo2 = d_2_lo1 + others_1_lo,
      d_2_lo = d_2_lo2 + first_1_lo;
  const double d_3 = first_1 - others_1, d_3_right = first_1 - d_3, d_3_left = d_3 + d_3_right,
      d_3_left_rest = first_1 - d_3_left, d_3_right_rest = others_1 - d_3_right,
      d_3_lo1 = d_3_left_rest - d_3_right_rest, d_3_lo2 = d_3_lo1 - others_1_lo,
      d_3_lo = d_3_lo2 + first_1_lo;
  const double low_0 = R->m11 < R->m00 ? d_1 : s_2, low_0_lo = R->m11 < R->m00 ? d_1_lo : s_2_lo;
  const double low_1 = R->m11 < R->m00 ? s_2 : d_2, low_1_lo = R->m11 < R->m00 ? s_2_lo : d_2_lo;
  const double low_2 = R->m11 < R->m00 ? s_1 : s_0, low_2_lo = R->m11 < R->m00 ? s_1_lo : s_0_lo;
  const double low_3 = R->m11 < R->m00 ? p_0 : p_1, low_3_lo = R->m11 < R->m00 ? p_0_lo : p_1_lo;
  const double high_0a = -R->m11, high_0 = R->m00 < high_0a ? s_1 : p_0,
      high_0_lo = R->m00 < high_0a ? s_1_lo : p_0_lo;
  const double high_1 = R->m00 < high_0a ? s_0 : p_1,
      high_1_lo = R->m00 < high_0a ? s_0_lo : p_1_lo;
  const double high_2 = R->m00 < high_0a ? d_3 : p_2,
      high_2_lo = R->m00 < high_0a ? d_3_lo : p_2_lo;
  const double high_3 = R->m00 < high_0a ? p_2 : d_0,
      high_3_lo = R->m00 < high_0a ? p_2_lo : d_0_lo;
  const double column_0 = R->m22 < 0.0 ? low_0 : high_0,
      column_0_lo = R->m22 < 0.0 ? low_0_lo : high_0_lo;
  const double column_1 = R->m22 < 0.0 ? low_1 : high_1,
      column_1_lo = R->m22 < 0.0 ? low_1_lo : high_1_lo;
  const double column_2 = R->m22 < 0.0 ? low_2 : high_2,
      column_2_lo = R->m22 < 0.0 ? low_2_lo : high_2_lo;
  const double column_3 = R->m22 < 0.0 ? low_3 : high_3,
      column_3_lo = R->m22 < 0.0 ? low_3_lo : high_3_lo;
  const double upper_0a = -column_0, upper_0a_lo = -column_0_lo,
      upper_0b_of_column_3 = column_3 + column_3_lo,
      upper_0b_of_column_3_right = upper_0b_of_column_3 - column_3,
      upper_0b_of_column_3_left = upper_0b_of_column_3 - upper_0b_of_column_3_right,
      upper_0b_of_column_3_left_rest = column_3 - upper_0b_of_column_3_left,
      upper_0b_of_column_3_right_rest = column_3_lo - upper_0b_of_column_3_right,
      upper_0b_of_column_3_lo = upper_0b_of_column_3_left_rest + upper_0b_of_column_3_right_rest,
      upper_0 = upper_0b_of_column_3 < 0.0 ? upper_0a : column_0,
      upper_0_lo = upper_0b_of_column_3 < 0.0 ? upper_0a_lo : column_0_lo;
  const double upper_1a = -column_1, upper_1a_lo = -column_1_lo,
      upper_1 = upper_0b_of_column_3 < 0.0 ? upper_1a : column_1,
      upper_1_lo = upper_0b_of_column_3 < 0.0 ? upper_1a_lo : column_1_lo;
  const double upper_2a = -column_2, upper_2a_lo = -column_2_lo,
      upper_2 = upper_0b_of_column_3 < 0.0 ? upper_2a : column_2,
      upper_2_lo = upper_0b_of_column_3 < 0.0 ? upper_2a_lo : column_2_lo;
  const double upper_3a = -upper_0b_of_column_3, upper_3a_lo = -upper_0b_of_column_3_lo,
      upper_3 = upper_0b_of_column_3 < 0.0 ? upper_3a : upper_0b_of_column_3,
      upper_3_lo = upper_0b_of_column_3 < 0.0 ? upper_3a_lo : upper_0b_of_column_3_lo;
  const double v_s_size_0_of_upper_0 = upper_0 + upper_0_lo,
      v_s_size_0_of_upper_0_right = v_s_size_0_of_upper_0 - upper_0,
      v_s_size_0_of_upper_0_left = v_s_size_0_of_upper_0 - v_s_size_0_of_upper_0_right,
      v_s_size_0_of_upper_0_left_rest = upper_0 - v_s_size_0_of_upper_0_left,
      v_s_size_0_of_upper_0_right_rest = upper_0_lo - v_s_size_0_of_upper_0_right,
      v_s_size_0_of_upper_0_lo = v_s_size_0_of_upper_0_left_rest + v_s_size_0_of_upper_0_right_rest,
      v_s_size_0 = fabs(v_s_size_0_of_upper_0), v_s_size_0_opposite = -v_s_size_0_of_upper_0_lo,
      v_s_size_0_lo = v_s_size_0_of_upper_0 < 0.0 ? v_s_size_0_opposite : v_s_size_0_of_upper_0_lo;
  const double v_s_size_1_of_upper_1 = upper_1 + upper_1_lo,
      v_s_size_1_of_upper_1_right = v_s_size_1_of_upper_1 - upper_1,
      v_s_size_1_of_upper_1_left = v_s_size_1_of_upper_1 - v_s_size_1_of_upper_1_right,
      v_s_size_1_of_upper_1_left_rest = upper_1 - v_s_size_1_of_upper_1_left,
      v_s_size_1_of_upper_1_right_rest = upper_1_lo - v_s_size_1_of_upper_1_right,
      v_s_size_1_of_upper_1_lo = v_s_size_1_of_upper_1_left_rest + v_s_size_1_of_upper_1_right_rest,
      v_s_size_1 = fabs(v_s_size_1_of_upper_1), v_s_size_1_opposite = -v_s_size_1_of_upper_1_lo,
      v_s_size_1_lo = v_s_size_1_of_upper_1 < 0.0 ? v_s_size_1_opposite : v_s_size_1_of_upper_1_lo;
  const double v_s_size_2_of_upper_2 = upper_2 + upper_2_lo,
      v_s_size_2_of_upper_2_right = v_s_size_2_of_upper_2 - upper_2,
      v_s_size_2_of_upper_2_left = v_s_size_2_of_upper_2 - v_s_size_2_of_upper_2_right,
      v_s_size_2_of_upper_2_left_rest = upper_2 - v_s_size_2_of_upper_2_left,
      v_s_size_2_of_upper_2_right_rest = upper_2_lo - v_s_size_2_of_upper_2_right,
      v_s_size_2_of_upper_2_lo = v_s_size_2_of_upper_2_left_rest + v_s_size_2_of_upper_2_right_rest,
      v_s_size_2 = fabs(v_s_size_2_of_upper_2), v_s_size_2_opposite = -v_s_size_2_of_upper_2_lo,
      v_s_size_2_lo = v_s_size_2_of_upper_2 < 0.0 ? v_s_size_2_opposite : v_s_size_2_of_upper_2_lo;
  const double v_s_largest1a_of_v_s_size_0 = v_s_size_0 + v_s_size_0_lo,
      v_s_largest1a_of_v_s_size_0_right = v_s_largest1a_of_v_s_size_0 - v_s_size_0,
      v_s_largest1a_of_v_s_size_0_left = v_s_largest1a_of_v_s_size_0 -
          v_s_largest1a_of_v_s_size_0_right,
      v_s_largest1a_of_v_s_size_0_left_rest = v_s_size_0 - v_s_largest1a_of_v_s_size_0_left,
      v_s_largest1a_of_v_s_size_0_right_rest = v_s_size_0_lo - v_s_largest1a_of_v_s_size_0_right,
      v_s_largest1a_of_v_s_size_0_lo = v_s_largest1a_of_v_s_size_0_left_rest +
          v_s_largest1a_of_v_s_size_0_right_rest,
      v_s_largest1a_of_v_s_size_1 = v_s_size_1 + v_s_size_1_lo,
      v_s_largest1a_of_v_s_size_1_right = v_s_largest1a_of_v_s_size_1 - v_s_size_1,
      v_s_largest1a_of_v_s_size_1_left = v_s_largest1a_of_v_s_size_1 -
          v_s_largest1a_of_v_s_size_1_right,
      v_s_largest1a_of_v_s_size_1_left_rest = v_s_size_1 - v_s_largest1a_of_v_s_size_1_left,
      v_s_largest1a_of_v_s_size_1_right_rest = v_s_size_1_lo - v_s_largest1a_of_v_s_size_1_right,
      v_s_largest1a_of_v_s_size_1_lo = v_s_largest1a_of_v_s_size_1_left_rest +
          v_s_largest1a_of_v_s_size_1_right_rest,
      v_s_largest1 = v_s_largest1a_of_v_s_size_0 < v_s_largest1a_of_v_s_size_1 ?
          v_s_largest1a_of_v_s_size_1 : v_s_largest1a_of_v_s_size_0,
      v_s_largest1_lo = v_s_largest1a_of_v_s_size_0 < v_s_largest1a_of_v_s_size_1 ?
          v_s_largest1a_of_v_s_size_1_lo : v_s_largest1a_of_v_s_size_0_lo;
  const double v_s_largest2a_of_v_s_largest1 = v_s_largest1 + v_s_largest1_lo,
      v_s_largest2a_of_v_s_largest1_right = v_s_largest2a_of_v_s_largest1 - v_s_largest1,
      v_s_largest2a_of_v_s_largest1_left = v_s_largest2a_of_v_s_largest1 -
          v_s_largest2a_of_v_s_largest1_right,
      v_s_largest2a_of_v_s_largest1_left_rest = v_s_largest1 - v_s_largest2a_of_v_s_largest1_left,
      v_s_largest2a_of_v_s_largest1_right_rest = v_s_largest1_lo -
          v_s_largest2a_of_v_s_largest1_right,
      v_s_largest2a_of_v_s_largest1_lo = v_s_largest2a_of_v_s_largest1_left_rest +
          v_s_largest2a_of_v_s_largest1_right_rest,
      v_s_largest2a_of_v_s_size_2 = v_s_size_2 + v_s_size_2_lo,
      v_s_largest2a_of_v_s_size_2_right = v_s_largest2a_of_v_s_size_2 - v_s_size_2,
      v_s_largest2a_of_v_s_size_2_left = v_s_largest2a_of_v_s_size_2 -
          v_s_largest2a_of_v_s_size_2_right,
      v_s_largest2a_of_v_s_size_2_left_rest = v_s_size_2 - v_s_largest2a_of_v_s_size_2_left,
      v_s_largest2a_of_v_s_size_2_right_rest = v_s_size_2_lo - v_s_largest2a_of_v_s_size_2_right,
      v_s_largest2a_of_v_s_size_2_lo = v_s_largest2a_of_v_s_size_2_left_rest +
          v_s_largest2a_of_v_s_size_2_right_rest,
      v_s_largest2 = v_s_largest2a_of_v_s_largest1 < v_s_largest2a_of_v_s_size_2 ?
          v_s_largest2a_of_v_s_size_2 : v_s_largest2a_of_v_s_largest1,
      v_s_largest2_lo = v_s_largest2a_of_v_s_largest1 < v_s_largest2a_of_v_s_size_2 ?
          v_s_largest2a_of_v_s_size_2_lo : v_s_largest2a_of_v_s_largest1_lo;
  const double v_s_a_of_v_s_largest2 = v_s_largest2 + v_s_largest2_lo,
      v_s_b = 6.703903964971299e+153 < v_s_a_of_v_s_largest2 ? 3.7291703656001034e-155 : 1.0,
      v_s_d = v_s_a_of_v_s_largest2 < 256.0 ? 1.3093562431584567e+151 : v_s_b,
      v_s = v_s_a_of_v_s_largest2 < 1.955159272639747e-149 ? 1.0715086071862673e+301 : v_s_d;
  const double v_y_0 = KSL_MUL(v_s_size_0_of_upper_0, v_s), v_y_0_inverse = 1.0 / v_s,
      v_y_0_back = KSL_MUL(v_y_0, v_y_0_inverse), v_y_0_lost = v_s_size_0_of_upper_0 - v_y_0_back,
      v_y_0_rest = v_y_0_lost + v_s_size_0_of_upper_0_lo, v_y_0_small = KSL_MUL(v_y_0_rest, v_s),
      v_y_0_lo = v_y_0_lost == 0.0 ? 0.0 : v_y_0_small;
  const double v_y_1 = KSL_MUL(v_s_size_1_of_upper_1, v_s),
      v_y_1_back = KSL_MUL(v_y_1, v_y_0_inverse), v_y_1_lost = v_s_size_1_of_upper_1 - v_y_1_back,
      v_y_1_rest = v_y_1_lost + v_s_size_1_of_upper_1_lo, v_y_1_small = KSL_MUL(v_y_1_rest, v_s),
      v_y_1_lo = v_y_1_lost == 0.0 ? 0.0 : v_y_1_small;
  const double v_y_2 = KSL_MUL(v_s_size_2_of_upper_2, v_s),
      v_y_2_back = KSL_MUL(v_y_2, v_y_0_inverse), v_y_2_lost = v_s_size_2_of_upper_2 - v_y_2_back,
      v_y_2_rest = v_y_2_lost + v_s_size_2_of_upper_2_lo, v_y_2_small = KSL_MUL(v_y_2_rest, v_s),
      v_y_2_lo = v_y_2_lost == 0.0 ? 0.0 : v_y_2_small;
  const double v_n_a = KSL_MUL(v_y_0, v_y_0), v_n_a_cross1 = KSL_MUL(v_y_0_lo, v_y_0),
      v_n_a_cross2 = KSL_MUL(v_y_0, v_y_0_lo), v_n_a_cross = v_n_a_cross1 + v_n_a_cross2,
      v_n_b = KSL_MUL(v_y_1, v_y_1), v_n_b_cross1 = KSL_MUL(v_y_1_lo, v_y_1),
      v_n_b_cross2 = KSL_MUL(v_y_1, v_y_1_lo), v_n_b_cross = v_n_b_cross1 + v_n_b_cross2,
      v_n_c = v_n_a + v_n_b, v_n_c_right = v_n_c - v_n_a, v_n_c_left = v_n_c - v_n_c_right,
      v_n_c_left_rest = ksl_product_rest(v_y_0, v_y_0, v_n_a, v_n_c_left),
      v_n_c_right_rest = ksl_product_rest(v_y_1, v_y_1, v_n_b, v_n_c_right),
      v_n_c_cross = v_n_a_cross + v_n_b_cross, v_n_c_lo1 = v_n_c_left_rest + v_n_c_right_rest,
      v_n_c_lo = v_n_c_lo1 + v_n_c_cross, v_n_d = KSL_MUL(v_y_2, v_y_2),
      v_n_d_cross1 = KSL_MUL(v_y_2_lo, v_y_2), v_n_d_cross2 = KSL_MUL(v_y_2, v_y_2_lo),
      v_n_d_cross = v_n_d_cross1 + v_n_d_cross2, v_n_e = v_n_c + v_n_d, v_n_e_right = v_n_e - v_n_c,
      v_n_e_left = v_n_e - v_n_e_right, v_n_e_left_rest = v_n_c - v_n_e_left,
      v_n_e_right_rest = ksl_product_rest(v_y_2, v_y_2, v_n_d, v_n_e_right),
      v_n_e_lo1 = v_n_e_left_rest + v_n_e_right_rest, v_n_e_lo2 = v_n_e_lo1 + v_n_d_cross,
      v_n_e_lo = v_n_e_lo2 + v_n_c_lo, v_n_of_v_n_e = v_n_e + v_n_e_lo,
      v_n_of_v_n_e_right = v_n_of_v_n_e - v_n_e,
      v_n_of_v_n_e_left = v_n_of_v_n_e - v_n_of_v_n_e_right,
      v_n_of_v_n_e_left_rest = v_n_e - v_n_of_v_n_e_left,
      v_n_of_v_n_e_right_rest = v_n_e_lo - v_n_of_v_n_e_right,
      v_n_of_v_n_e_lo = v_n_of_v_n_e_left_rest + v_n_of_v_n_e_right_rest, v_n = sqrt(v_n_of_v_n_e),
      v_n_product = KSL_MUL(v_n, v_n), v_n_product_error = ksl_product_error(v_n, v_n, v_n_product),
      v_n_rest = v_n_of_v_n_e - v_n_product, v_n_exact = v_n_rest - v_n_product_error,
      v_n_residual = v_n_exact + v_n_of_v_n_e_lo, v_n_twice = v_n + v_n,
      v_n_divisor = v_n == 0.0 ? 1.0 : v_n_twice, v_n_lo = v_n_residual / v_n_divisor;
  const double v_r_b = v_s < 1.0 ? 2.6815615859885194e+154 : 1.0,
      v_r_d = 1.0 < v_s ? 7.637340908749012e-152 : v_r_b,
      v_r = 1.3093562431584567e+151 < v_s ? 9.332636185032189e-302 : v_r_d;
  const double n_of_v_n = v_n + v_n_lo, n_of_v_n_right = n_of_v_n - v_n,
      n_of_v_n_left = n_of_v_n - n_of_v_n_right, n_of_v_n_left_rest = v_n - n_of_v_n_left,
      n_of_v_n_right_rest = v_n_lo - n_of_v_n_right,
      n_of_v_n_lo = n_of_v_n_left_rest + n_of_v_n_right_rest, n = KSL_MUL(n_of_v_n, v_r),
      n_inverse = 1.0 / v_r, n_back = KSL_MUL(n, n_inverse), n_lost = n_of_v_n - n_back,
      n_rest = n_lost + n_of_v_n_lo, n_small = KSL_MUL(n_rest, v_r),
      n_lo = n_lost == 0.0 ? 0.0 : n_small;
  const double half_of_n = n + n_lo, half_of_n_right = half_of_n - n,
      half_of_n_left = half_of_n - half_of_n_right, half_of_n_left_rest = n - half_of_n_left,
      half_of_n_right_rest = n_lo - half_of_n_right,
      half_of_n_lo = half_of_n_left_rest + half_of_n_right_rest,
      half_of_upper_3 = upper_3 + upper_3_lo, half_of_upper_3_right = half_of_upper_3 - upper_3,
      half_of_upper_3_left = half_of_upper_3 - half_of_upper_3_right,
      half_of_upper_3_left_rest = upper_3 - half_of_upper_3_left,
      half_of_upper_3_right_rest = upper_3_lo - half_of_upper_3_right,
      half_of_upper_3_lo = half_of_upper_3_left_rest + half_of_upper_3_right_rest,
      half = ksl_atan2(half_of_n, half_of_upper_3),
      half_own_error = ksl_atan2_error(half_of_n, half_of_upper_3, half),
      half_size0 = fabs(half_of_n), half_size1 = fabs(half_of_upper_3),
      half_most = half_size0 < half_size1 ? half_size1 : half_size0,
      half_divisor = half_most == 0.0 ? 1.0 : half_most, half_part0 = half_of_n / half_divisor,
      half_part1 = half_of_upper_3 / half_divisor, half_cross1 = KSL_MUL(half_part1, half_of_n_lo),
      half_cross2 = KSL_MUL(half_part0, half_of_upper_3_lo),
      half_square1 = KSL_MUL(half_part1, half_part1),
      half_square2 = KSL_MUL(half_part0, half_part0), half_cross = half_cross1 - half_cross2,
      half_square = half_square1 + half_square2, half_divisor2 = KSL_MUL(half_divisor, half_square),
      half_safe = half_most == 0.0 ? 1.0 : half_divisor2, half_more = half_cross / half_safe,
      half_lo = half_own_error + half_more;
  const double divisor = half_of_n == 0.0 ? 1.0 : half_of_n,
      divisor_lo = half_of_n == 0.0 ? 0.0 : half_of_n_lo;
  const double theta = KSL_MUL(2.0, half), theta_cross2 = KSL_MUL(2.0, half_lo);
  const double k_of_theta = theta + theta_cross2, k_of_theta_right = k_of_theta - theta,
      k_of_theta_left = k_of_theta - k_of_theta_right,
      k_of_theta_left_rest = theta - k_of_theta_left,
      k_of_theta_right_rest = theta_cross2 - k_of_theta_right,
      k_of_theta_lo = k_of_theta_left_rest + k_of_theta_right_rest,
      k_of_divisor = divisor + divisor_lo, k_of_divisor_right = k_of_divisor - divisor,
      k_of_divisor_left = k_of_divisor - k_of_divisor_right,
      k_of_divisor_left_rest = divisor - k_of_divisor_left,
      k_of_divisor_right_rest = divisor_lo - k_of_divisor_right,
      k_of_divisor_lo = k_of_divisor_left_rest + k_of_divisor_right_rest,
      k = k_of_theta / k_of_divisor, k_product = KSL_MUL(k, k_of_divisor),
      k_product_error = ksl_product_error(k, k_of_divisor, k_product),
      k_rest = k_of_theta - k_product, k_exact = k_rest - k_product_error,
      k_numerator = k_exact + k_of_theta_lo, k_cross = KSL_MUL(k, k_of_divisor_lo),
      k_residual = k_numerator - k_cross, k_lo = k_residual / k_of_divisor;
  const double vector_0 = KSL_MUL(v_s_size_0_of_upper_0, k),
      vector_0_cross1 = KSL_MUL(v_s_size_0_of_upper_0_lo, k),
      vector_0_cross2 = KSL_MUL(v_s_size_0_of_upper_0, k_lo),
      vector_0_cross = vector_0_cross1 + vector_0_cross2;
  const double vector_1 = KSL_MUL(v_s_size_1_of_upper_1, k),
      vector_1_cross1 = KSL_MUL(v_s_size_1_of_upper_1_lo, k),
      vector_1_cross2 = KSL_MUL(v_s_size_1_of_upper_1, k_lo),
      vector_1_cross = vector_1_cross1 + vector_1_cross2;
  const double vector_2 = KSL_MUL(v_s_size_2_of_upper_2, k),
      vector_2_cross1 = KSL_MUL(v_s_size_2_of_upper_2_lo, k),
      vector_2_cross2 = KSL_MUL(v_s_size_2_of_upper_2, k_lo),
      vector_2_cross = vector_2_cross1 + vector_2_cross2;
  const double vector_0_error = ksl_product_error(v_s_size_0_of_upper_0, k, vector_0),
      vector_0_lo = vector_0_error + vector_0_cross, vector_0_rounded = vector_0 + vector_0_lo,
      vector_0_final = vector_0_rounded == vector_0_rounded ? vector_0_rounded : vector_0;
  const double vector_1_error = ksl_product_error(v_s_size_1_of_upper_1, k, vector_1),
      vector_1_lo = vector_1_error + vector_1_cross, vector_1_rounded = vector_1 + vector_1_lo,
      vector_1_final = vector_1_rounded == vector_1_rounded ? vector_1_rounded : vector_1;
  const double vector_2_error = ksl_product_error(v_s_size_2_of_upper_2, k, vector_2),
      vector_2_lo = vector_2_error + vector_2_cross, vector_2_rounded = vector_2 + vector_2_lo,
      vector_2_final = vector_2_rounded == vector_2_rounded ? vector_2_rounded : vector_2;
  vo->x = vector_0_final;
  vo->y = vector_1_final;
  vo->z = vector_2_final;
}

/* self = R + R (I - R^T R)/2, closer to a rotation: a defect d of R becomes 3/4 d^2.
   self: rotation or other 3×3 matrix.
   84 mul, 288 add, 45 product rest, 6 neg.
   Error <= u |result| + 44 u^2 S, S the sum of the |terms| of the expanded formula; barring
     over- and underflow. */
static inline void ksl_mat3x3_orthonormalize_accurate(ksl_mat3x3_t *self) {
  const double defect_0a = KSL_MUL(self->m00, self->m00), defect_0b = 1.0 - defect_0a,
      defect_0b_right = 1.0 - defect_0b, defect_0b_left = defect_0b + defect_0b_right,
      defect_0b_left_rest = 1.0 - defect_0b_left,
      defect_0b_right_rest = ksl_product_rest(self->m00, self->m00, defect_0a, defect_0b_right),
      defect_0b_lo = defect_0b_left_rest - defect_0b_right_rest,
      defect_0c = KSL_MUL(self->m10, self->m10), defect_0d = defect_0b - defect_0c,
      defect_0d_right = defect_0b - defect_0d, defect_0d_left = defect_0d + defect_0d_right,
      defect_0d_left_rest = defect_0b - defect_0d_left,
      defect_0d_right_rest = ksl_product_rest(self->m10, self->m10, defect_0c, defect_0d_right),
      defect_0d_lo1 = defect_0d_left_rest - defect_0d_right_rest,
      defect_0d_lo = defect_0d_lo1 + defect_0b_lo, defect_0e = KSL_MUL(self->m20, self->m20),
      defect_0 = defect_0d - defect_0e, defect_0_right = defect_0d - defect_0,
      defect_0_left = defect_0 + defect_0_right, defect_0_left_rest = defect_0d - defect_0_left,
      defect_0_right_rest = ksl_product_rest(self->m20, self->m20, defect_0e, defect_0_right),
      defect_0_lo1 = defect_0_left_rest - defect_0_right_rest,
      defect_0_lo = defect_0_lo1 + defect_0d_lo;
  const double defect_1a = KSL_MUL(self->m01, self->m01), defect_1b = 1.0 - defect_1a,
      defect_1b_right = 1.0 - defect_1b, defect_1b_left = defect_1b + defect_1b_right,
      defect_1b_left_rest = 1.0 - defect_1b_left,
      defect_1b_right_rest = ksl_product_rest(self->m01, self->m01, defect_1a, defect_1b_right),
      defect_1b_lo = defect_1b_left_rest - defect_1b_right_rest,
      defect_1c = KSL_MUL(self->m11, self->m11), defect_1d = defect_1b - defect_1c,
      defect_1d_right = defect_1b - defect_1d, defect_1d_left = defect_1d + defect_1d_right,
      defect_1d_left_rest = defect_1b - defect_1d_left,
      defect_1d_right_rest = ksl_product_rest(self->m11, self->m11, defect_1c, defect_1d_right),
      defect_1d_lo1 = defect_1d_left_rest - defect_1d_right_rest,
      defect_1d_lo = defect_1d_lo1 + defect_1b_lo, defect_1e = KSL_MUL(self->m21, self->m21),
      defect_1 = defect_1d - defect_1e, defect_1_right = defect_1d - defect_1,
      defect_1_left = defect_1 + defect_1_right, defect_1_left_rest = defect_1d - defect_1_left,
      defect_1_right_rest = ksl_product_rest(self->m21, self->m21, defect_1e, defect_1_right),
      defect_1_lo1 = defect_1_left_rest - defect_1_right_rest,
      defect_1_lo = defect_1_lo1 + defect_1d_lo;
  const double defect_2a = KSL_MUL(self->m02, self->m02), defect_2b = 1.0 - defect_2a,
      defect_2b_right = 1.0 - defect_2b, defect_2b_left = defect_2b + defect_2b_right,
      defect_2b_left_rest = 1.0 - defect_2b_left,
      defect_2b_right_rest = ksl_product_rest(self->m02, self->m02, defect_2a, defect_2b_right),
      defect_2b_lo = defect_2b_left_rest - defect_2b_right_rest,
      defect_2c = KSL_MUL(self->m12, self->m12), defect_2d = defect_2b - defect_2c,
      defect_2d_right = defect_2b - defect_2d, defect_2d_left = defect_2d + defect_2d_right,
      defect_2d_left_rest = defect_2b - defect_2d_left,
      defect_2d_right_rest = ksl_product_rest(self->m12, self->m12, defect_2c, defect_2d_right),
      defect_2d_lo1 = defect_2d_left_rest - defect_2d_right_rest,
      defect_2d_lo = defect_2d_lo1 + defect_2b_lo, defect_2e = KSL_MUL(self->m22, self->m22),
      defect_2 = defect_2d - defect_2e, defect_2_right = defect_2d - defect_2,
      defect_2_left = defect_2 + defect_2_right, defect_2_left_rest = defect_2d - defect_2_left,
      defect_2_right_rest = ksl_product_rest(self->m22, self->m22, defect_2e, defect_2_right),
      defect_2_lo1 = defect_2_left_rest - defect_2_right_rest,
      defect_2_lo = defect_2_lo1 + defect_2d_lo;
  const double defect_3a = KSL_MUL(self->m00, self->m01), defect_3b = KSL_MUL(self->m10, self->m11),
      defect_3c = defect_3a + defect_3b, defect_3c_right = defect_3c - defect_3a,
      defect_3c_left = defect_3c - defect_3c_right,
      defect_3c_left_rest = ksl_product_rest(self->m00, self->m01, defect_3a, defect_3c_left),
      defect_3c_right_rest = ksl_product_rest(self->m10, self->m11, defect_3b, defect_3c_right),
      defect_3c_lo = defect_3c_left_rest + defect_3c_right_rest,
      defect_3d = KSL_MUL(self->m20, self->m21), defect_3e = defect_3c + defect_3d,
      defect_3e_right = defect_3e - defect_3c, defect_3e_left = defect_3e - defect_3e_right,
      defect_3e_left_rest = defect_3c - defect_3e_left,
      defect_3e_right_rest = ksl_product_rest(self->m20, self->m21, defect_3d, defect_3e_right),
      defect_3e_lo1 = defect_3e_left_rest + defect_3e_right_rest,
      defect_3e_lo = defect_3e_lo1 + defect_3c_lo, defect_3 = -defect_3e,
      defect_3_lo = -defect_3e_lo;
  const double defect_4a = KSL_MUL(self->m00, self->m02), defect_4b = KSL_MUL(self->m10, self->m12),
      defect_4c = defect_4a + defect_4b, defect_4c_right = defect_4c - defect_4a,
      defect_4c_left = defect_4c - defect_4c_right,
      defect_4c_left_rest = ksl_product_rest(self->m00, self->m02, defect_4a, defect_4c_left),
      defect_4c_right_rest = ksl_product_rest(self->m10, self->m12, defect_4b, defect_4c_right),
      defect_4c_lo = defect_4c_left_rest + defect_4c_right_rest,
      defect_4d = KSL_MUL(self->m20, self->m22), defect_4e = defect_4c + defect_4d,
      defect_4e_right = defect_4e - defect_4c, defect_4e_left = defect_4e - defect_4e_right,
      defect_4e_left_rest = defect_4c - defect_4e_left,
      defect_4e_right_rest = ksl_product_rest(self->m20, self->m22, defect_4d, defect_4e_right),
      defect_4e_lo1 = defect_4e_left_rest + defect_4e_right_rest,
      defect_4e_lo = defect_4e_lo1 + defect_4c_lo, defect_4 = -defect_4e,
      defect_4_lo = -defect_4e_lo;
  const double defect_5a = KSL_MUL(self->m01, self->m02), defect_5b = KSL_MUL(self->m11, self->m12),
      defect_5c = defect_5a + defect_5b, defect_5c_right = defect_5c - defect_5a,
      defect_5c_left = defect_5c - defect_5c_right,
      defect_5c_left_rest = ksl_product_rest(self->m01, self->m02, defect_5a, defect_5c_left),
      defect_5c_right_rest = ksl_product_rest(self->m11, self->m12, defect_5b, defect_5c_right),
      defect_5c_lo = defect_5c_left_rest + defect_5c_right_rest,
      defect_5d = KSL_MUL(self->m21, self->m22), defect_5e = defect_5c + defect_5d,
      defect_5e_right = defect_5e - defect_5c, defect_5e_left = defect_5e - defect_5e_right,
      defect_5e_left_rest = defect_5c - defect_5e_left,
      defect_5e_right_rest = ksl_product_rest(self->m21, self->m22, defect_5d, defect_5e_right),
      defect_5e_lo1 = defect_5e_left_rest + defect_5e_right_rest,
      defect_5e_lo = defect_5e_lo1 + defect_5c_lo, defect_5 = -defect_5e,
      defect_5_lo = -defect_5e_lo;
  const double correction_0_of_defect_0 = defect_0 + defect_0_lo,
      correction_0_of_defect_0_right = correction_0_of_defect_0 - defect_0,
      correction_0_of_defect_0_left = correction_0_of_defect_0 - correction_0_of_defect_0_right,
      correction_0_of_defect_0_left_rest = defect_0 - correction_0_of_defect_0_left,
      correction_0_of_defect_0_right_rest = defect_0_lo - correction_0_of_defect_0_right,
      correction_0_of_defect_0_lo = correction_0_of_defect_0_left_rest +
          correction_0_of_defect_0_right_rest,
      correction_0 = KSL_MUL(0.5, correction_0_of_defect_0),
      correction_0_cross2 = KSL_MUL(0.5, correction_0_of_defect_0_lo);
  const double correction_1_of_defect_1 = defect_1 + defect_1_lo,
      correction_1_of_defect_1_right = correction_1_of_defect_1 - defect_1,
      correction_1_of_defect_1_left = correction_1_of_defect_1 - correction_1_of_defect_1_right,
      correction_1_of_defect_1_left_rest = defect_1 - correction_1_of_defect_1_left,
      correction_1_of_defect_1_right_rest = defect_1_lo - correction_1_of_defect_1_right,
      correction_1_of_defect_1_lo = correction_1_of_defect_1_left_rest +
          correction_1_of_defect_1_right_rest,
      correction_1 = KSL_MUL(0.5, correction_1_of_defect_1),
      correction_1_cross2 = KSL_MUL(0.5, correction_1_of_defect_1_lo);
  const double correction_2_of_defect_2 = defect_2 + defect_2_lo,
      correction_2_of_defect_2_right = correction_2_of_defect_2 - defect_2,
      correction_2_of_defect_2_left = correction_2_of_defect_2 - correction_2_of_defect_2_right,
      correction_2_of_defect_2_left_rest = defect_2 - correction_2_of_defect_2_left,
      correction_2_of_defect_2_right_rest = defect_2_lo - correction_2_of_defect_2_right,
      correction_2_of_defect_2_lo = correction_2_of_defect_2_left_rest +
          correction_2_of_defect_2_right_rest,
      correction_2 = KSL_MUL(0.5, correction_2_of_defect_2),
      correction_2_cross2 = KSL_MUL(0.5, correction_2_of_defect_2_lo);
  const double correction_3 = KSL_MUL(0.5, defect_3),
      correction_3_cross2 = KSL_MUL(0.5, defect_3_lo);
  const double correction_4 = KSL_MUL(0.5, defect_4),
      correction_4_cross2 = KSL_MUL(0.5, defect_4_lo);
  const double correction_5 = KSL_MUL(0.5, defect_5),
      correction_5_cross2 = KSL_MUL(0.5, defect_5_lo);
  const double self_00_new_a = KSL_MUL(self->m00, correction_0),
      self_00_new_a_cross2 = KSL_MUL(self->m00, correction_0_cross2),
      self_00_new_b = KSL_MUL(self->m01, correction_3),
      self_00_new_b_cross2 = KSL_MUL(self->m01, correction_3_cross2),
      self_00_new_c = self_00_new_a + self_00_new_b,
      self_00_new_c_right = self_00_new_c - self_00_new_a,
      self_00_new_c_left = self_00_new_c - self_00_new_c_right,
      self_00_new_c_left_rest = ksl_product_rest(self->m00, correction_0, self_00_new_a,
          self_00_new_c_left),
      self_00_new_c_right_rest = ksl_product_rest(self->m01, correction_3, self_00_new_b,
          self_00_new_c_right),
      self_00_new_c_cross = self_00_new_a_cross2 + self_00_new_b_cross2,
      self_00_new_c_lo1 = self_00_new_c_left_rest + self_00_new_c_right_rest,
      self_00_new_c_lo = self_00_new_c_lo1 + self_00_new_c_cross,
      self_00_new_d = KSL_MUL(self->m02, correction_4),
      self_00_new_d_cross2 = KSL_MUL(self->m02, correction_4_cross2),
      self_00_new_e = self_00_new_c + self_00_new_d,
      self_00_new_e_right = self_00_new_e - self_00_new_c,
      self_00_new_e_left = self_00_new_e - self_00_new_e_right,
      self_00_new_e_left_rest = self_00_new_c - self_00_new_e_left,
      self_00_new_e_right_rest = ksl_product_rest(self->m02, correction_4, self_00_new_d,
          self_00_new_e_right),
      self_00_new_e_lo1 = self_00_new_e_left_rest + self_00_new_e_right_rest,
      self_00_new_e_lo2 = self_00_new_e_lo1 + self_00_new_d_cross2,
      self_00_new_e_lo = self_00_new_e_lo2 + self_00_new_c_lo,
      self_00_new = self->m00 + self_00_new_e, self_00_new_right = self_00_new - self->m00,
      self_00_new_left = self_00_new - self_00_new_right,
      self_00_new_left_rest = self->m00 - self_00_new_left,
      self_00_new_right_rest = self_00_new_e - self_00_new_right,
      self_00_new_lo1 = self_00_new_left_rest + self_00_new_right_rest,
      self_00_new_lo = self_00_new_lo1 + self_00_new_e_lo;
  const double self_01_new_a = KSL_MUL(self->m00, correction_3),
      self_01_new_a_cross2 = KSL_MUL(self->m00, correction_3_cross2),
      self_01_new_b = KSL_MUL(self->m01, correction_1),
      self_01_new_b_cross2 = KSL_MUL(self->m01, correction_1_cross2),
      self_01_new_c = self_01_new_a + self_01_new_b,
      self_01_new_c_right = self_01_new_c - self_01_new_a,
      self_01_new_c_left = self_01_new_c - self_01_new_c_right,
      self_01_new_c_left_rest = ksl_product_rest(self->m00, correction_3, self_01_new_a,
          self_01_new_c_left),
      self_01_new_c_right_rest = ksl_product_rest(self->m01, correction_1, self_01_new_b,
          self_01_new_c_right),
      self_01_new_c_cross = self_01_new_a_cross2 + self_01_new_b_cross2,
      self_01_new_c_lo1 = self_01_new_c_left_rest + self_01_new_c_right_rest,
      self_01_new_c_lo = self_01_new_c_lo1 + self_01_new_c_cross,
      self_01_new_d = KSL_MUL(self->m02, correction_5),
      self_01_new_d_cross2 = KSL_MUL(self->m02, correction_5_cross2),
      self_01_new_e = self_01_new_c + self_01_new_d,
      self_01_new_e_right = self_01_new_e - self_01_new_c,
      self_01_new_e_left = self_01_new_e - self_01_new_e_right,
      self_01_new_e_left_rest = self_01_new_c - self_01_new_e_left,
      self_01_new_e_right_rest = ksl_product_rest(self->m02, correction_5, self_01_new_d,
          self_01_new_e_right),
      self_01_new_e_lo1 = self_01_new_e_left_rest + self_01_new_e_right_rest,
      self_01_new_e_lo2 = self_01_new_e_lo1 + self_01_new_d_cross2,
      self_01_new_e_lo = self_01_new_e_lo2 + self_01_new_c_lo,
      self_01_new = self_01_new_e + self->m01, self_01_new_right = self_01_new - self_01_new_e,
      self_01_new_left = self_01_new - self_01_new_right,
      self_01_new_left_rest = self_01_new_e - self_01_new_left,
      self_01_new_right_rest = self->m01 - self_01_new_right,
      self_01_new_lo1 = self_01_new_left_rest + self_01_new_right_rest,
      self_01_new_lo = self_01_new_lo1 + self_01_new_e_lo;
  const double self_02_new_a = KSL_MUL(self->m00, correction_4),
      self_02_new_a_cross2 = KSL_MUL(self->m00, correction_4_cross2),
      self_02_new_b = KSL_MUL(self->m01, correction_5),
      self_02_new_b_cross2 = KSL_MUL(self->m01, correction_5_cross2),
      self_02_new_c = self_02_new_a + self_02_new_b,
      self_02_new_c_right = self_02_new_c - self_02_new_a,
      self_02_new_c_left = self_02_new_c - self_02_new_c_right,
      self_02_new_c_left_rest = ksl_product_rest(self->m00, correction_4, self_02_new_a,
          self_02_new_c_left),
      self_02_new_c_right_rest = ksl_product_rest(self->m01, correction_5, self_02_new_b,
          self_02_new_c_right),
      self_02_new_c_cross = self_02_new_a_cross2 + self_02_new_b_cross2,
      self_02_new_c_lo1 = self_02_new_c_left_rest + self_02_new_c_right_rest,
      self_02_new_c_lo = self_02_new_c_lo1 + self_02_new_c_cross,
      self_02_new_d = KSL_MUL(self->m02, correction_2),
      self_02_new_d_cross2 = KSL_MUL(self->m02, correction_2_cross2),
      self_02_new_e = self_02_new_c + self_02_new_d,
      self_02_new_e_right = self_02_new_e - self_02_new_c,
      self_02_new_e_left = self_02_new_e - self_02_new_e_right,
      self_02_new_e_left_rest = self_02_new_c - self_02_new_e_left,
      self_02_new_e_right_rest = ksl_product_rest(self->m02, correction_2, self_02_new_d,
          self_02_new_e_right),
      self_02_new_e_lo1 = self_02_new_e_left_rest + self_02_new_e_right_rest,
      self_02_new_e_lo2 = self_02_new_e_lo1 + self_02_new_d_cross2,
      self_02_new_e_lo = self_02_new_e_lo2 + self_02_new_c_lo,
      self_02_new = self_02_new_e + self->m02, self_02_new_right = self_02_new - self_02_new_e,
      self_02_new_left = self_02_new - self_02_new_right,
      self_02_new_left_rest = self_02_new_e - self_02_new_left,
      self_02_new_right_rest = self->m02 - self_02_new_right,
      self_02_new_lo1 = self_02_new_left_rest + self_02_new_right_rest,
      self_02_new_lo = self_02_new_lo1 + self_02_new_e_lo;
  const double self_10_new_a = KSL_MUL(self->m10, correction_0),
      self_10_new_a_cross2 = KSL_MUL(self->m10, correction_0_cross2),
      self_10_new_b = KSL_MUL(self->m11, correction_3),
      self_10_new_b_cross2 = KSL_MUL(self->m11, correction_3_cross2),
      self_10_new_c = self_10_new_a + self_10_new_b,
      self_10_new_c_right = self_10_new_c - self_10_new_a,
      self_10_new_c_left = self_10_new_c - self_10_new_c_right,
      self_10_new_c_left_rest = ksl_product_rest(self->m10, correction_0, self_10_new_a,
          self_10_new_c_left),
      self_10_new_c_right_rest = ksl_product_rest(self->m11, correction_3, self_10_new_b,
          self_10_new_c_right),
      self_10_new_c_cross = self_10_new_a_cross2 + self_10_new_b_cross2,
      self_10_new_c_lo1 = self_10_new_c_left_rest + self_10_new_c_right_rest,
      self_10_new_c_lo = self_10_new_c_lo1 + self_10_new_c_cross,
      self_10_new_d = KSL_MUL(self->m12, correction_4),
      self_10_new_d_cross2 = KSL_MUL(self->m12, correction_4_cross2),
      self_10_new_e = self_10_new_c + self_10_new_d,
      self_10_new_e_right = self_10_new_e - self_10_new_c,
      self_10_new_e_left = self_10_new_e - self_10_new_e_right,
      self_10_new_e_left_rest = self_10_new_c - self_10_new_e_left,
      self_10_new_e_right_rest = ksl_product_rest(self->m12, correction_4, self_10_new_d,
          self_10_new_e_right),
      self_10_new_e_lo1 = self_10_new_e_left_rest + self_10_new_e_right_rest,
      self_10_new_e_lo2 = self_10_new_e_lo1 + self_10_new_d_cross2,
      self_10_new_e_lo = self_10_new_e_lo2 + self_10_new_c_lo,
      self_10_new = self->m10 + self_10_new_e, self_10_new_right = self_10_new - self->m10,
      self_10_new_left = self_10_new - self_10_new_right,
      self_10_new_left_rest = self->m10 - self_10_new_left,
      self_10_new_right_rest = self_10_new_e - self_10_new_right,
      self_10_new_lo1 = self_10_new_left_rest + self_10_new_right_rest,
      self_10_new_lo = self_10_new_lo1 + self_10_new_e_lo;
  const double self_11_new_a = KSL_MUL(self->m10, correction_3),
      self_11_new_a_cross2 = KSL_MUL(self->m10, correction_3_cross2),
      self_11_new_b = KSL_MUL(self->m11, correction_1),
      self_11_new_b_cross2 = KSL_MUL(self->m11, correction_1_cross2),
      self_11_new_c = self_11_new_a + self_11_new_b,
      self_11_new_c_right = self_11_new_c - self_11_new_a,
      self_11_new_c_left = self_11_new_c - self_11_new_c_right,
      self_11_new_c_left_rest = ksl_product_rest(self->m10, correction_3, self_11_new_a,
          self_11_new_c_left),
      self_11_new_c_right_rest = ksl_product_rest(self->m11, correction_1, self_11_new_b,
          self_11_new_c_right),
      self_11_new_c_cross = self_11_new_a_cross2 + self_11_new_b_cross2,
      self_11_new_c_lo1 = self_11_new_c_left_rest + self_11_new_c_right_rest,
      self_11_new_c_lo = self_11_new_c_lo1 + self_11_new_c_cross,
      self_11_new_d = KSL_MUL(self->m12, correction_5),
      self_11_new_d_cross2 = KSL_MUL(self->m12, correction_5_cross2),
      self_11_new_e = self_11_new_c + self_11_new_d,
      self_11_new_e_right = self_11_new_e - self_11_new_c,
      self_11_new_e_left = self_11_new_e - self_11_new_e_right,
      self_11_new_e_left_rest = self_11_new_c - self_11_new_e_left,
      self_11_new_e_right_rest = ksl_product_rest(self->m12, correction_5, self_11_new_d,
          self_11_new_e_right),
      self_11_new_e_lo1 = self_11_new_e_left_rest + self_11_new_e_right_rest,
      self_11_new_e_lo2 = self_11_new_e_lo1 + self_11_new_d_cross2,
      self_11_new_e_lo = self_11_new_e_lo2 + self_11_new_c_lo,
      self_11_new = self_11_new_e + self->m11, self_11_new_right = self_11_new - self_11_new_e,
      self_11_new_left = self_11_new - self_11_new_right,
      self_11_new_left_rest = self_11_new_e - self_11_new_left,
      self_11_new_right_rest = self->m11 - self_11_new_right,
      self_11_new_lo1 = self_11_new_left_rest + self_11_new_right_rest,
      self_11_new_lo = self_11_new_lo1 + self_11_new_e_lo;
  const double self_12_new_a = KSL_MUL(self->m10, correction_4),
      self_12_new_a_cross2 = KSL_MUL(self->m10, correction_4_cross2),
      self_12_new_b = KSL_MUL(self->m11, correction_5),
      self_12_new_b_cross2 = KSL_MUL(self->m11, correction_5_cross2),
      self_12_new_c = self_12_new_a + self_12_new_b,
      self_12_new_c_right = self_12_new_c - self_12_new_a,
      self_12_new_c_left = self_12_new_c - self_12_new_c_right,
      self_12_new_c_left_rest = ksl_product_rest(self->m10, correction_4, self_12_new_a,
          self_12_new_c_left),
      self_12_new_c_right_rest = ksl_product_rest(self->m11, correction_5, self_12_new_b,
          self_12_new_c_right),
      self_12_new_c_cross = self_12_new_a_cross2 + self_12_new_b_cross2,
      self_12_new_c_lo1 = self_12_new_c_left_rest + self_12_new_c_right_rest,
      self_12_new_c_lo = self_12_new_c_lo1 + self_12_new_c_cross,
      self_12_new_d = KSL_MUL(self->m12, correction_2),
      self_12_new_d_cross2 = KSL_MUL(self->m12, correction_2_cross2),
      self_12_new_e = self_12_new_c + self_12_new_d,
      self_12_new_e_right = self_12_new_e - self_12_new_c,
      self_12_new_e_left = self_12_new_e - self_12_new_e_right,
      self_12_new_e_left_rest = self_12_new_c - self_12_new_e_left,
      self_12_new_e_right_rest = ksl_product_rest(self->m12, correction_2, self_12_new_d,
          self_12_new_e_right),
      self_12_new_e_lo1 = self_12_new_e_left_rest + self_12_new_e_right_rest,
      self_12_new_e_lo2 = self_12_new_e_lo1 + self_12_new_d_cross2,
      self_12_new_e_lo = self_12_new_e_lo2 + self_12_new_c_lo,
      self_12_new = self_12_new_e + self->m12, self_12_new_right = self_12_new - self_12_new_e,
      self_12_new_left = self_12_new - self_12_new_right,
      self_12_new_left_rest = self_12_new_e - self_12_new_left,
      self_12_new_right_rest = self->m12 - self_12_new_right,
      self_12_new_lo1 = self_12_new_left_rest + self_12_new_right_rest,
      self_12_new_lo = self_12_new_lo1 + self_12_new_e_lo;
  const double self_20_new_a = KSL_MUL(self->m20, correction_0),
      self_20_new_a_cross2 = KSL_MUL(self->m20, correction_0_cross2),
      self_20_new_b = KSL_MUL(self->m21, correction_3),
      self_20_new_b_cross2 = KSL_MUL(self->m21, correction_3_cross2),
      self_20_new_c = self_20_new_a + self_20_new_b,
      self_20_new_c_right = self_20_new_c - self_20_new_a,
      self_20_new_c_left = self_20_new_c - self_20_new_c_right,
      self_20_new_c_left_rest = ksl_product_rest(self->m20, correction_0, self_20_new_a,
          self_20_new_c_left),
      self_20_new_c_right_rest = ksl_product_rest(self->m21, correction_3, self_20_new_b,
          self_20_new_c_right),
      self_20_new_c_cross = self_20_new_a_cross2 + self_20_new_b_cross2,
      self_20_new_c_lo1 = self_20_new_c_left_rest + self_20_new_c_right_rest,
      self_20_new_c_lo = self_20_new_c_lo1 + self_20_new_c_cross,
      self_20_new_d = KSL_MUL(self->m22, correction_4),
      self_20_new_d_cross2 = KSL_MUL(self->m22, correction_4_cross2),
      self_20_new_e = self_20_new_c + self_20_new_d,
      self_20_new_e_right = self_20_new_e - self_20_new_c,
      self_20_new_e_left = self_20_new_e - self_20_new_e_right,
      self_20_new_e_left_rest = self_20_new_c - self_20_new_e_left,
      self_20_new_e_right_rest = ksl_product_rest(self->m22, correction_4, self_20_new_d,
          self_20_new_e_right),
      self_20_new_e_lo1 = self_20_new_e_left_rest + self_20_new_e_right_rest,
      self_20_new_e_lo2 = self_20_new_e_lo1 + self_20_new_d_cross2,
      self_20_new_e_lo = self_20_new_e_lo2 + self_20_new_c_lo,
      self_20_new = self->m20 + self_20_new_e, self_20_new_right = self_20_new - self->m20,
      self_20_new_left = self_20_new - self_20_new_right,
      self_20_new_left_rest = self->m20 - self_20_new_left,
      self_20_new_right_rest = self_20_new_e - self_20_new_right,
      self_20_new_lo1 = self_20_new_left_rest + self_20_new_right_rest,
      self_20_new_lo = self_20_new_lo1 + self_20_new_e_lo;
  const double self_21_new_a = KSL_MUL(self->m20, correction_3),
      self_21_new_a_cross2 = KSL_MUL(self->m20, correction_3_cross2),
      self_21_new_b = KSL_MUL(self->m21, correction_1),
      self_21_new_b_cross2 = KSL_MUL(self->m21, correction_1_cross2),
      self_21_new_c = self_21_new_a + self_21_new_b,
      self_21_new_c_right = self_21_new_c - self_21_new_a,
      self_21_new_c_left = self_21_new_c - self_21_new_c_right,
      self_21_new_c_left_rest = ksl_product_rest(self->m20, correction_3, self_21_new_a,
          self_21_new_c_left),
      self_21_new_c_right_rest = ksl_product_rest(self->m21, correction_1, self_21_new_b,
          self_21_new_c_right),
      self_21_new_c_cross = self_21_new_a_cross2 + self_21_new_b_cross2,
      self_21_new_c_lo1 = self_21_new_c_left_rest + self_21_new_c_right_rest,
      self_21_new_c_lo = self_21_new_c_lo1 + self_21_new_c_cross,
      self_21_new_d = KSL_MUL(self->m22, correction_5),
      self_21_new_d_cross2 = KSL_MUL(self->m22, correction_5_cross2),
      self_21_new_e = self_21_new_c + self_21_new_d,
      self_21_new_e_right = self_21_new_e - self_21_new_c,
      self_21_new_e_left = self_21_new_e - self_21_new_e_right,
      self_21_new_e_left_rest = self_21_new_c - self_21_new_e_left,
      self_21_new_e_right_rest = ksl_product_rest(self->m22, correction_5, self_21_new_d,
          self_21_new_e_right),
      self_21_new_e_lo1 = self_21_new_e_left_rest + self_21_new_e_right_rest,
      self_21_new_e_lo2 = self_21_new_e_lo1 + self_21_new_d_cross2,
      self_21_new_e_lo = self_21_new_e_lo2 + self_21_new_c_lo,
      self_21_new = self_21_new_e + self->m21, self_21_new_right = self_21_new - self_21_new_e,
      self_21_new_left = self_21_new - self_21_new_right,
      self_21_new_left_rest = self_21_new_e - self_21_new_left,
      self_21_new_right_rest = self->m21 - self_21_new_right,
      self_21_new_lo1 = self_21_new_left_rest + self_21_new_right_rest,
      self_21_new_lo = self_21_new_lo1 + self_21_new_e_lo;
  const double self_22_new_a = KSL_MUL(self->m20, correction_4),
      self_22_new_a_cross2 = KSL_MUL(self->m20, correction_4_cross2),
      self_22_new_b = KSL_MUL(self->m21, correction_5),
      self_22_new_b_cross2 = KSL_MUL(self->m21, correction_5_cross2),
      self_22_new_c = self_22_new_a + self_22_new_b,
      self_22_new_c_right = self_22_new_c - self_22_new_a,
      self_22_new_c_left = self_22_new_c - self_22_new_c_right,
      self_22_new_c_left_rest = ksl_product_rest(self->m20, correction_4, self_22_new_a,
          self_22_new_c_left),
      self_22_new_c_right_rest = ksl_product_rest(self->m21, correction_5, self_22_new_b,
          self_22_new_c_right),
      self_22_new_c_cross = self_22_new_a_cross2 + self_22_new_b_cross2,
      self_22_new_c_lo1 = self_22_new_c_left_rest + self_22_new_c_right_rest,
      self_22_new_c_lo = self_22_new_c_lo1 + self_22_new_c_cross,
      self_22_new_d = KSL_MUL(self->m22, correction_2),
      self_22_new_d_cross2 = KSL_MUL(self->m22, correction_2_cross2),
      self_22_new_e = self_22_new_c + self_22_new_d,
      self_22_new_e_right = self_22_new_e - self_22_new_c,
      self_22_new_e_left = self_22_new_e - self_22_new_e_right,
      self_22_new_e_left_rest = self_22_new_c - self_22_new_e_left,
      self_22_new_e_right_rest = ksl_product_rest(self->m22, correction_2, self_22_new_d,
          self_22_new_e_right),
      self_22_new_e_lo1 = self_22_new_e_left_rest + self_22_new_e_right_rest,
      self_22_new_e_lo2 = self_22_new_e_lo1 + self_22_new_d_cross2,
      self_22_new_e_lo = self_22_new_e_lo2 + self_22_new_c_lo,
      self_22_new = self_22_new_e + self->m22, self_22_new_right = self_22_new - self_22_new_e,
      self_22_new_left = self_22_new - self_22_new_right,
      self_22_new_left_rest = self_22_new_e - self_22_new_left,
      self_22_new_right_rest = self->m22 - self_22_new_right,
      self_22_new_lo1 = self_22_new_left_rest + self_22_new_right_rest,
      self_22_new_lo = self_22_new_lo1 + self_22_new_e_lo;
  const double self_00_new_rounded = self_00_new + self_00_new_lo;
  const double self_01_new_rounded = self_01_new + self_01_new_lo;
  const double self_02_new_rounded = self_02_new + self_02_new_lo;
  const double self_10_new_rounded = self_10_new + self_10_new_lo;
  const double self_11_new_rounded = self_11_new + self_11_new_lo;
  const double self_12_new_rounded = self_12_new + self_12_new_lo;
  const double self_20_new_rounded = self_20_new + self_20_new_lo;
  const double self_21_new_rounded = self_21_new + self_21_new_lo;
  const double self_22_new_rounded = self_22_new + self_22_new_lo;
  self->m00 = self_00_new_rounded;
  self->m01 = self_01_new_rounded;
  self->m02 = self_02_new_rounded;
  self->m10 = self_10_new_rounded;
  self->m11 = self_11_new_rounded;
  self->m12 = self_12_new_rounded;
  self->m20 = self_20_new_rounded;
  self->m21 = self_21_new_rounded;
  self->m22 = self_22_new_rounded;
}

/* Ro = R + R (I - R^T R)/2, closer to a rotation: a defect d of R becomes 3/4 d^2.
   R, Ro: rotation or other 3×3 matrix.
   84 mul, 288 add, 45 product rest, 6 neg.
   Error <= u |result| + 44 u^2 S, S the sum of the |terms| of the expanded formula; barring
     over- and underflow. */
static inline void ksl_mat3x3_orthonormalized_accurate(const ksl_mat3x3_t *R, ksl_mat3x3_t *Ro) {
  const double defect_0a = KSL_MUL(R->m00, R->m00), defect_0b = 1.0 - defect_0a,
      defect_0b_right = 1.0 - defect_0b, defect_0b_left = defect_0b + defect_0b_right,
      defect_0b_left_rest = 1.0 - defect_0b_left,
      defect_0b_right_rest = ksl_product_rest(R->m00, R->m00, defect_0a, defect_0b_right),
      defect_0b_lo = defect_0b_left_rest - defect_0b_right_rest,
      defect_0c = KSL_MUL(R->m10, R->m10), defect_0d = defect_0b - defect_0c,
      defect_0d_right = defect_0b - defect_0d, defect_0d_left = defect_0d + defect_0d_right,
      defect_0d_left_rest = defect_0b - defect_0d_left,
      defect_0d_right_rest = ksl_product_rest(R->m10, R->m10, defect_0c, defect_0d_right),
      defect_0d_lo1 = defect_0d_left_rest - defect_0d_right_rest,
      defect_0d_lo = defect_0d_lo1 + defect_0b_lo, defect_0e = KSL_MUL(R->m20, R->m20),
      defect_0 = defect_0d - defect_0e, defect_0_right = defect_0d - defect_0,
      defect_0_left = defect_0 + defect_0_right, defect_0_left_rest = defect_0d - defect_0_left,
      defect_0_right_rest = ksl_product_rest(R->m20, R->m20, defect_0e, defect_0_right),
      defect_0_lo1 = defect_0_left_rest - defect_0_right_rest,
      defect_0_lo = defect_0_lo1 + defect_0d_lo;
  const double defect_1a = KSL_MUL(R->m01, R->m01), defect_1b = 1.0 - defect_1a,
      defect_1b_right = 1.0 - defect_1b, defect_1b_left = defect_1b + defect_1b_right,
      defect_1b_left_rest = 1.0 - defect_1b_left,
      defect_1b_right_rest = ksl_product_rest(R->m01, R->m01, defect_1a, defect_1b_right),
      defect_1b_lo = defect_1b_left_rest - defect_1b_right_rest,
      defect_1c = KSL_MUL(R->m11, R->m11), defect_1d = defect_1b - defect_1c,
      defect_1d_right = defect_1b - defect_1d, defect_1d_left = defect_1d + defect_1d_right,
      defect_1d_left_rest = defect_1b - defect_1d_left,
      defect_1d_right_rest = ksl_product_rest(R->m11, R->m11, defect_1c, defect_1d_right),
      defect_1d_lo1 = defect_1d_left_rest - defect_1d_right_rest,
      defect_1d_lo = defect_1d_lo1 + defect_1b_lo, defect_1e = KSL_MUL(R->m21, R->m21),
      defect_1 = defect_1d - defect_1e, defect_1_right = defect_1d - defect_1,
      defect_1_left = defect_1 + defect_1_right, defect_1_left_rest = defect_1d - defect_1_left,
      defect_1_right_rest = ksl_product_rest(R->m21, R->m21, defect_1e, defect_1_right),
      defect_1_lo1 = defect_1_left_rest - defect_1_right_rest,
      defect_1_lo = defect_1_lo1 + defect_1d_lo;
  const double defect_2a = KSL_MUL(R->m02, R->m02), defect_2b = 1.0 - defect_2a,
      defect_2b_right = 1.0 - defect_2b, defect_2b_left = defect_2b + defect_2b_right,
      defect_2b_left_rest = 1.0 - defect_2b_left,
      defect_2b_right_rest = ksl_product_rest(R->m02, R->m02, defect_2a, defect_2b_right),
      defect_2b_lo = defect_2b_left_rest - defect_2b_right_rest,
      defect_2c = KSL_MUL(R->m12, R->m12), defect_2d = defect_2b - defect_2c,
      defect_2d_right = defect_2b - defect_2d, defect_2d_left = defect_2d + defect_2d_right,
      defect_2d_left_rest = defect_2b - defect_2d_left,
      defect_2d_right_rest = ksl_product_rest(R->m12, R->m12, defect_2c, defect_2d_right),
      defect_2d_lo1 = defect_2d_left_rest - defect_2d_right_rest,
      defect_2d_lo = defect_2d_lo1 + defect_2b_lo, defect_2e = KSL_MUL(R->m22, R->m22),
      defect_2 = defect_2d - defect_2e, defect_2_right = defect_2d - defect_2,
      defect_2_left = defect_2 + defect_2_right, defect_2_left_rest = defect_2d - defect_2_left,
      defect_2_right_rest = ksl_product_rest(R->m22, R->m22, defect_2e, defect_2_right),
      defect_2_lo1 = defect_2_left_rest - defect_2_right_rest,
      defect_2_lo = defect_2_lo1 + defect_2d_lo;
  const double defect_3a = KSL_MUL(R->m00, R->m01), defect_3b = KSL_MUL(R->m10, R->m11),
      defect_3c = defect_3a + defect_3b, defect_3c_right = defect_3c - defect_3a,
      defect_3c_left = defect_3c - defect_3c_right,
      defect_3c_left_rest = ksl_product_rest(R->m00, R->m01, defect_3a, defect_3c_left),
      defect_3c_right_rest = ksl_product_rest(R->m10, R->m11, defect_3b, defect_3c_right),
      defect_3c_lo = defect_3c_left_rest + defect_3c_right_rest,
      defect_3d = KSL_MUL(R->m20, R->m21), defect_3e = defect_3c + defect_3d,
      defect_3e_right = defect_3e - defect_3c, defect_3e_left = defect_3e - defect_3e_right,
      defect_3e_left_rest = defect_3c - defect_3e_left,
      defect_3e_right_rest = ksl_product_rest(R->m20, R->m21, defect_3d, defect_3e_right),
      defect_3e_lo1 = defect_3e_left_rest + defect_3e_right_rest,
      defect_3e_lo = defect_3e_lo1 + defect_3c_lo, defect_3 = -defect_3e,
      defect_3_lo = -defect_3e_lo;
  const double defect_4a = KSL_MUL(R->m00, R->m02), defect_4b = KSL_MUL(R->m10, R->m12),
      defect_4c = defect_4a + defect_4b, defect_4c_right = defect_4c - defect_4a,
      defect_4c_left = defect_4c - defect_4c_right,
      defect_4c_left_rest = ksl_product_rest(R->m00, R->m02, defect_4a, defect_4c_left),
      defect_4c_right_rest = ksl_product_rest(R->m10, R->m12, defect_4b, defect_4c_right),
      defect_4c_lo = defect_4c_left_rest + defect_4c_right_rest,
      defect_4d = KSL_MUL(R->m20, R->m22), defect_4e = defect_4c + defect_4d,
      defect_4e_right = defect_4e - defect_4c, defect_4e_left = defect_4e - defect_4e_right,
      defect_4e_left_rest = defect_4c - defect_4e_left,
      defect_4e_right_rest = ksl_product_rest(R->m20, R->m22, defect_4d, defect_4e_right),
      defect_4e_lo1 = defect_4e_left_rest + defect_4e_right_rest,
      defect_4e_lo = defect_4e_lo1 + defect_4c_lo, defect_4 = -defect_4e,
      defect_4_lo = -defect_4e_lo;
  const double defect_5a = KSL_MUL(R->m01, R->m02), defect_5b = KSL_MUL(R->m11, R->m12),
      defect_5c = defect_5a + defect_5b, defect_5c_right = defect_5c - defect_5a,
      defect_5c_left = defect_5c - defect_5c_right,
      defect_5c_left_rest = ksl_product_rest(R->m01, R->m02, defect_5a, defect_5c_left),
      defect_5c_right_rest = ksl_product_rest(R->m11, R->m12, defect_5b, defect_5c_right),
      defect_5c_lo = defect_5c_left_rest + defect_5c_right_rest,
      defect_5d = KSL_MUL(R->m21, R->m22), defect_5e = defect_5c + defect_5d,
      defect_5e_right = defect_5e - defect_5c, defect_5e_left = defect_5e - defect_5e_right,
      defect_5e_left_rest = defect_5c - defect_5e_left,
      defect_5e_right_rest = ksl_product_rest(R->m21, R->m22, defect_5d, defect_5e_right),
      defect_5e_lo1 = defect_5e_left_rest + defect_5e_right_rest,
      defect_5e_lo = defect_5e_lo1 + defect_5c_lo, defect_5 = -defect_5e,
      defect_5_lo = -defect_5e_lo;
  const double correction_0_of_defect_0 = defect_0 + defect_0_lo,
      correction_0_of_defect_0_right = correction_0_of_defect_0 - defect_0,
      correction_0_of_defect_0_left = correction_0_of_defect_0 - correction_0_of_defect_0_right,
      correction_0_of_defect_0_left_rest = defect_0 - correction_0_of_defect_0_left,
      correction_0_of_defect_0_right_rest = defect_0_lo - correction_0_of_defect_0_right,
      correction_0_of_defect_0_lo = correction_0_of_defect_0_left_rest +
          correction_0_of_defect_0_right_rest,
      correction_0 = KSL_MUL(0.5, correction_0_of_defect_0),
      correction_0_cross2 = KSL_MUL(0.5, correction_0_of_defect_0_lo);
  const double correction_1_of_defect_1 = defect_1 + defect_1_lo,
      correction_1_of_defect_1_right = correction_1_of_defect_1 - defect_1,
      correction_1_of_defect_1_left = correction_1_of_defect_1 - correction_1_of_defect_1_right,
      correction_1_of_defect_1_left_rest = defect_1 - correction_1_of_defect_1_left,
      correction_1_of_defect_1_right_rest = defect_1_lo - correction_1_of_defect_1_right,
      correction_1_of_defect_1_lo = correction_1_of_defect_1_left_rest +
          correction_1_of_defect_1_right_rest,
      correction_1 = KSL_MUL(0.5, correction_1_of_defect_1),
      correction_1_cross2 = KSL_MUL(0.5, correction_1_of_defect_1_lo);
  const double correction_2_of_defect_2 = defect_2 + defect_2_lo,
      correction_2_of_defect_2_right = correction_2_of_defect_2 - defect_2,
      correction_2_of_defect_2_left = correction_2_of_defect_2 - correction_2_of_defect_2_right,
      correction_2_of_defect_2_left_rest = defect_2 - correction_2_of_defect_2_left,
      correction_2_of_defect_2_right_rest = defect_2_lo - correction_2_of_defect_2_right,
      correction_2_of_defect_2_lo = correction_2_of_defect_2_left_rest +
          correction_2_of_defect_2_right_rest,
      correction_2 = KSL_MUL(0.5, correction_2_of_defect_2),
      correction_2_cross2 = KSL_MUL(0.5, correction_2_of_defect_2_lo);
  const double correction_3 = KSL_MUL(0.5, defect_3),
      correction_3_cross2 = KSL_MUL(0.5, defect_3_lo);
  const double correction_4 = KSL_MUL(0.5, defect_4),
      correction_4_cross2 = KSL_MUL(0.5, defect_4_lo);
  const double correction_5 = KSL_MUL(0.5, defect_5),
      correction_5_cross2 = KSL_MUL(0.5, defect_5_lo);
  const double Ro_00a = KSL_MUL(R->m00, correction_0),
      Ro_00a_cross2 = KSL_MUL(R->m00, correction_0_cross2), Ro_00b = KSL_MUL(R->m01, correction_3),
      Ro_00b_cross2 = KSL_MUL(R->m01, correction_3_cross2), Ro_00c = Ro_00a + Ro_00b,
      Ro_00c_right = Ro_00c - Ro_00a, Ro_00c_left = Ro_00c - Ro_00c_right,
      Ro_00c_left_rest = ksl_product_rest(R->m00, correction_0, Ro_00a, Ro_00c_left),
      Ro_00c_right_rest = ksl_product_rest(R->m01, correction_3, Ro_00b, Ro_00c_right),
      Ro_00c_cross = Ro_00a_cross2 + Ro_00b_cross2,
      Ro_00c_lo1 = Ro_00c_left_rest + Ro_00c_right_rest, Ro_00c_lo = Ro_00c_lo1 + Ro_00c_cross,
      Ro_00d = KSL_MUL(R->m02, correction_4), Ro_00d_cross2 = KSL_MUL(R->m02, correction_4_cross2),
      Ro_00e = Ro_00c + Ro_00d, Ro_00e_right = Ro_00e - Ro_00c, Ro_00e_left = Ro_00e - Ro_00e_right,
      Ro_00e_left_rest = Ro_00c - Ro_00e_left,
      Ro_00e_right_rest = ksl_product_rest(R->m02, correction_4, Ro_00d, Ro_00e_right),
      Ro_00e_lo1 = Ro_00e_left_rest + Ro_00e_right_rest, Ro_00e_lo2 = Ro_00e_lo1 + Ro_00d_cross2,
      Ro_00e_lo = Ro_00e_lo2 + Ro_00c_lo, Ro_00 = R->m00 + Ro_00e, Ro_00_right = Ro_00 - R->m00,
      Ro_00_left = Ro_00 - Ro_00_right, Ro_00_left_rest = R->m00 - Ro_00_left,
      Ro_00_right_rest = Ro_00e - Ro_00_right, Ro_00_lo1 = Ro_00_left_rest + Ro_00_right_rest,
      Ro_00_lo = Ro_00_lo1 + Ro_00e_lo;
  const double Ro_01a = KSL_MUL(R->m00, correction_3),
      Ro_01a_cross2 = KSL_MUL(R->m00, correction_3_cross2), Ro_01b = KSL_MUL(R->m01, correction_1),
      Ro_01b_cross2 = KSL_MUL(R->m01, correction_1_cross2), Ro_01c = Ro_01a + Ro_01b,
      Ro_01c_right = Ro_01c - Ro_01a, Ro_01c_left = Ro_01c - Ro_01c_right,
      Ro_01c_left_rest = ksl_product_rest(R->m00, correction_3, Ro_01a, Ro_01c_left),
      Ro_01c_right_rest = ksl_product_rest(R->m01, correction_1, Ro_01b, Ro_01c_right),
      Ro_01c_cross = Ro_01a_cross2 + Ro_01b_cross2,
      Ro_01c_lo1 = Ro_01c_left_rest + Ro_01c_right_rest, Ro_01c_lo = Ro_01c_lo1 + Ro_01c_cross,
      Ro_01d = KSL_MUL(R->m02, correction_5), Ro_01d_cross2 = KSL_MUL(R->m02, correction_5_cross2),
      Ro_01e = Ro_01c + Ro_01d, Ro_01e_right = Ro_01e - Ro_01c, Ro_01e_left = Ro_01e - Ro_01e_right,
      Ro_01e_left_rest = Ro_01c - Ro_01e_left,
      Ro_01e_right_rest = ksl_product_rest(R->m02, correction_5, Ro_01d, Ro_01e_right),
      Ro_01e_lo1 = Ro_01e_left_rest + Ro_01e_right_rest, Ro_01e_lo2 = Ro_01e_lo1 + Ro_01d_cross2,
      Ro_01e_lo = Ro_01e_lo2 + Ro_01c_lo, Ro_01 = Ro_01e + R->m01, Ro_01_right = Ro_01 - Ro_01e,
      Ro_01_left = Ro_01 - Ro_01_right, Ro_01_left_rest = Ro_01e - Ro_01_left,
      Ro_01_right_rest = R->m01 - Ro_01_right, Ro_01_lo1 = Ro_01_left_rest + Ro_01_right_rest,
      Ro_01_lo = Ro_01_lo1 + Ro_01e_lo;
  const double Ro_02a = KSL_MUL(R->m00, correction_4),
      Ro_02a_cross2 = KSL_MUL(R->m00, correction_4_cross2), Ro_02b = KSL_MUL(R->m01, correction_5),
      Ro_02b_cross2 = KSL_MUL(R->m01, correction_5_cross2), Ro_02c = Ro_02a + Ro_02b,
      Ro_02c_right = Ro_02c - Ro_02a, Ro_02c_left = Ro_02c - Ro_02c_right,
      Ro_02c_left_rest = ksl_product_rest(R->m00, correction_4, Ro_02a, Ro_02c_left),
      Ro_02c_right_rest = ksl_product_rest(R->m01, correction_5, Ro_02b, Ro_02c_right),
      Ro_02c_cross = Ro_02a_cross2 + Ro_02b_cross2,
      Ro_02c_lo1 = Ro_02c_left_rest + Ro_02c_right_rest, Ro_02c_lo = Ro_02c_lo1 + Ro_02c_cross,
      Ro_02d = KSL_MUL(R->m02, correction_2), Ro_02d_cross2 = KSL_MUL(R->m02, correction_2_cross2),
      Ro_02e = Ro_02c + Ro_02d, Ro_02e_right = Ro_02e - Ro_02c, Ro_02e_left = Ro_02e - Ro_02e_right,
      Ro_02e_left_rest = Ro_02c - Ro_02e_left,
      Ro_02e_right_rest = ksl_product_rest(R->m02, correction_2, Ro_02d, Ro_02e_right),
      Ro_02e_lo1 = Ro_02e_left_rest + Ro_02e_right_rest, Ro_02e_lo2 = Ro_02e_lo1 + Ro_02d_cross2,
      Ro_02e_lo = Ro_02e_lo2 + Ro_02c_lo, Ro_02 = Ro_02e + R->m02, Ro_02_right = Ro_02 - Ro_02e,
      Ro_02_left = Ro_02 - Ro_02_right, Ro_02_left_rest = Ro_02e - Ro_02_left,
      Ro_02_right_rest = R->m02 - Ro_02_right, Ro_02_lo1 = Ro_02_left_rest + Ro_02_right_rest,
      Ro_02_lo = Ro_02_lo1 + Ro_02e_lo;
  const double Ro_10a = KSL_MUL(R->m10, correction_0),
      Ro_10a_cross2 = KSL_MUL(R->m10, correction_0_cross2), Ro_10b = KSL_MUL(R->m11, correction_3),
      Ro_10b_cross2 = KSL_MUL(R->m11, correction_3_cross2), Ro_10c = Ro_10a + Ro_10b,
      Ro_10c_right = Ro_10c - Ro_10a, Ro_10c_left = Ro_10c - Ro_10c_right,
      Ro_10c_left_rest = ksl_product_rest(R->m10, correction_0, Ro_10a, Ro_10c_left),
      Ro_10c_right_rest = ksl_product_rest(R->m11, correction_3, Ro_10b, Ro_10c_right),
      Ro_10c_cross = Ro_10a_cross2 + Ro_10b_cross2,
      Ro_10c_lo1 = Ro_10c_left_rest + Ro_10c_right_rest, Ro_10c_lo = Ro_10c_lo1 + Ro_10c_cross,
      Ro_10d = KSL_MUL(R->m12, correction_4), Ro_10d_cross2 = KSL_MUL(R->m12, correction_4_cross2),
      Ro_10e = Ro_10c + Ro_10d, Ro_10e_right = Ro_10e - Ro_10c, Ro_10e_left = Ro_10e - Ro_10e_right,
      Ro_10e_left_rest = Ro_10c - Ro_10e_left,
      Ro_10e_right_rest = ksl_product_rest(R->m12, correction_4, Ro_10d, Ro_10e_right),
      Ro_10e_lo1 = Ro_10e_left_rest + Ro_10e_right_rest, Ro_10e_lo2 = Ro_10e_lo1 + Ro_10d_cross2,
      Ro_10e_lo = Ro_10e_lo2 + Ro_10c_lo, Ro_10 = R->m10 + Ro_10e, Ro_10_right = Ro_10 - R->m10,
      Ro_10_left = Ro_10 - Ro_10_right, Ro_10_left_rest = R->m10 - Ro_10_left,
      Ro_10_right_rest = Ro_10e - Ro_10_right, Ro_10_lo1 = Ro_10_left_rest + Ro_10_right_rest,
      Ro_10_lo = Ro_10_lo1 + Ro_10e_lo;
  const double Ro_11a = KSL_MUL(R->m10, correction_3),
      Ro_11a_cross2 = KSL_MUL(R->m10, correction_3_cross2), Ro_11b = KSL_MUL(R->m11, correction_1),
      Ro_11b_cross2 = KSL_MUL(R->m11, correction_1_cross2), Ro_11c = Ro_11a + Ro_11b,
      Ro_11c_right = Ro_11c - Ro_11a, Ro_11c_left = Ro_11c - Ro_11c_right,
      Ro_11c_left_rest = ksl_product_rest(R->m10, correction_3, Ro_11a, Ro_11c_left),
      Ro_11c_right_rest = ksl_product_rest(R->m11, correction_1, Ro_11b, Ro_11c_right),
      Ro_11c_cross = Ro_11a_cross2 + Ro_11b_cross2,
      Ro_11c_lo1 = Ro_11c_left_rest + Ro_11c_right_rest, Ro_11c_lo = Ro_11c_lo1 + Ro_11c_cross,
      Ro_11d = KSL_MUL(R->m12, correction_5), Ro_11d_cross2 = KSL_MUL(R->m12, correction_5_cross2),
      Ro_11e = Ro_11c + Ro_11d, Ro_11e_right = Ro_11e - Ro_11c, Ro_11e_left = Ro_11e - Ro_11e_right,
      Ro_11e_left_rest = Ro_11c - Ro_11e_left,
      Ro_11e_right_rest = ksl_product_rest(R->m12, correction_5, Ro_11d, Ro_11e_right),
      Ro_11e_lo1 = Ro_11e_left_rest + Ro_11e_right_rest, Ro_11e_lo2 = Ro_11e_lo1 + Ro_11d_cross2,
      Ro_11e_lo = Ro_11e_lo2 + Ro_11c_lo, Ro_11 = Ro_11e + R->m11, Ro_11_right = Ro_11 - Ro_11e,
      Ro_11_left = Ro_11 - Ro_11_right, Ro_11_left_rest = Ro_11e - Ro_11_left,
      Ro_11_right_rest = R->m11 - Ro_11_right, Ro_11_lo1 = Ro_11_left_rest + Ro_11_right_rest,
      Ro_11_lo = Ro_11_lo1 + Ro_11e_lo;
  const double Ro_12a = KSL_MUL(R->m10, correction_4),
      Ro_12a_cross2 = KSL_MUL(R->m10, correction_4_cross2), Ro_12b = KSL_MUL(R->m11, correction_5),
      Ro_12b_cross2 = KSL_MUL(R->m11, correction_5_cross2), Ro_12c = Ro_12a + Ro_12b,
      Ro_12c_right = Ro_12c - Ro_12a, Ro_12c_left = Ro_12c - Ro_12c_right,
      Ro_12c_left_rest = ksl_product_rest(R->m10, correction_4, Ro_12a, Ro_12c_left),
      Ro_12c_right_rest = ksl_product_rest(R->m11, correction_5, Ro_12b, Ro_12c_right),
      Ro_12c_cross = Ro_12a_cross2 + Ro_12b_cross2,
      Ro_12c_lo1 = Ro_12c_left_rest + Ro_12c_right_rest, Ro_12c_lo = Ro_12c_lo1 + Ro_12c_cross,
      Ro_12d = KSL_MUL(R->m12, correction_2), Ro_12d_cross2 = KSL_MUL(R->m12, correction_2_cross2),
      Ro_12e = Ro_12c + Ro_12d, Ro_12e_right = Ro_12e - Ro_12c, Ro_12e_left = Ro_12e - Ro_12e_right,
      Ro_12e_left_rest = Ro_12c - Ro_12e_left,
      Ro_12e_right_rest = ksl_product_rest(R->m12, correction_2, Ro_12d, Ro_12e_right),
      Ro_12e_lo1 = Ro_12e_left_rest + Ro_12e_right_rest, Ro_12e_lo2 = Ro_12e_lo1 + Ro_12d_cross2,
      Ro_12e_lo = Ro_12e_lo2 + Ro_12c_lo, Ro_12 = Ro_12e + R->m12, Ro_12_right = Ro_12 - Ro_12e,
      Ro_12_left = Ro_12 - Ro_12_right, Ro_12_left_rest = Ro_12e - Ro_12_left,
      Ro_12_right_rest = R->m12 - Ro_12_right, Ro_12_lo1 = Ro_12_left_rest + Ro_12_right_rest,
      Ro_12_lo = Ro_12_lo1 + Ro_12e_lo;
  const double Ro_20a = KSL_MUL(R->m20, correction_0),
      Ro_20a_cross2 = KSL_MUL(R->m20, correction_0_cross2), Ro_20b = KSL_MUL(R->m21, correction_3),
      Ro_20b_cross2 = KSL_MUL(R->m21, correction_3_cross2), Ro_20c = Ro_20a + Ro_20b,
      Ro_20c_right = Ro_20c - Ro_20a, Ro_20c_left = Ro_20c - Ro_20c_right,
      Ro_20c_left_rest = ksl_product_rest(R->m20, correction_0, Ro_20a, Ro_20c_left),
      Ro_20c_right_rest = ksl_product_rest(R->m21, correction_3, Ro_20b, Ro_20c_right),
      Ro_20c_cross = Ro_20a_cross2 + Ro_20b_cross2,
      Ro_20c_lo1 = Ro_20c_left_rest + Ro_20c_right_rest, Ro_20c_lo = Ro_20c_lo1 + Ro_20c_cross,
      Ro_20d = KSL_MUL(R->m22, correction_4), Ro_20d_cross2 = KSL_MUL(R->m22, correction_4_cross2),
      Ro_20e = Ro_20c + Ro_20d, Ro_20e_right = Ro_20e - Ro_20c, Ro_20e_left = Ro_20e - Ro_20e_right,
      Ro_20e_left_rest = Ro_20c - Ro_20e_left,
      Ro_20e_right_rest = ksl_product_rest(R->m22, correction_4, Ro_20d, Ro_20e_right),
      Ro_20e_lo1 = Ro_20e_left_rest + Ro_20e_right_rest, Ro_20e_lo2 = Ro_20e_lo1 + Ro_20d_cross2,
      Ro_20e_lo = Ro_20e_lo2 + Ro_20c_lo, Ro_20 = R->m20 + Ro_20e, Ro_20_right = Ro_20 - R->m20,
      Ro_20_left = Ro_20 - Ro_20_right, Ro_20_left_rest = R->m20 - Ro_20_left,
      Ro_20_right_rest = Ro_20e - Ro_20_right, Ro_20_lo1 = Ro_20_left_rest + Ro_20_right_rest,
      Ro_20_lo = Ro_20_lo1 + Ro_20e_lo;
  const double Ro_21a = KSL_MUL(R->m20, correction_3),
      Ro_21a_cross2 = KSL_MUL(R->m20, correction_3_cross2), Ro_21b = KSL_MUL(R->m21, correction_1),
      Ro_21b_cross2 = KSL_MUL(R->m21, correction_1_cross2), Ro_21c = Ro_21a + Ro_21b,
      Ro_21c_right = Ro_21c - Ro_21a, Ro_21c_left = Ro_21c - Ro_21c_right,
      Ro_21c_left_rest = ksl_product_rest(R->m20, correction_3, Ro_21a, Ro_21c_left),
      Ro_21c_right_rest = ksl_product_rest(R->m21, correction_1, Ro_21b, Ro_21c_right),
      Ro_21c_cross = Ro_21a_cross2 + Ro_21b_cross2,
      Ro_21c_lo1 = Ro_21c_left_rest + Ro_21c_right_rest, Ro_21c_lo = Ro_21c_lo1 + Ro_21c_cross,
      Ro_21d = KSL_MUL(R->m22, correction_5), Ro_21d_cross2 = KSL_MUL(R->m22, correction_5_cross2),
      Ro_21e = Ro_21c + Ro_21d, Ro_21e_right = Ro_21e - Ro_21c, Ro_21e_left = Ro_21e - Ro_21e_right,
      Ro_21e_left_rest = Ro_21c - Ro_21e_left,
      Ro_21e_right_rest = ksl_product_rest(R->m22, correction_5, Ro_21d, Ro_21e_right),
      Ro_21e_lo1 = Ro_21e_left_rest + Ro_21e_right_rest, Ro_21e_lo2 = Ro_21e_lo1 + Ro_21d_cross2,
      Ro_21e_lo = Ro_21e_lo2 + Ro_21c_lo, Ro_21 = Ro_21e + R->m21, Ro_21_right = Ro_21 - Ro_21e,
      Ro_21_left = Ro_21 - Ro_21_right, Ro_21_left_rest = Ro_21e - Ro_21_left,
      Ro_21_right_rest = R->m21 - Ro_21_right, Ro_21_lo1 = Ro_21_left_rest + Ro_21_right_rest,
      Ro_21_lo = Ro_21_lo1 + Ro_21e_lo;
  const double Ro_22a = KSL_MUL(R->m20, correction_4),
      Ro_22a_cross2 = KSL_MUL(R->m20, correction_4_cross2), Ro_22b = KSL_MUL(R->m21, correction_5),
      Ro_22b_cross2 = KSL_MUL(R->m21, correction_5_cross2), Ro_22c = Ro_22a + Ro_22b,
      Ro_22c_right = Ro_22c - Ro_22a, Ro_22c_left = Ro_22c - Ro_22c_right,
      Ro_22c_left_rest = ksl_product_rest(R->m20, correction_4, Ro_22a, Ro_22c_left),
      Ro_22c_right_rest = ksl_product_rest(R->m21, correction_5, Ro_22b, Ro_22c_right),
      Ro_22c_cross = Ro_22a_cross2 + Ro_22b_cross2,
      Ro_22c_lo1 = Ro_22c_left_rest + Ro_22c_right_rest, Ro_22c_lo = Ro_22c_lo1 + Ro_22c_cross,
      Ro_22d = KSL_MUL(R->m22, correction_2), Ro_22d_cross2 = KSL_MUL(R->m22, correction_2_cross2),
      Ro_22e = Ro_22c + Ro_22d, Ro_22e_right = Ro_22e - Ro_22c, Ro_22e_left = Ro_22e - Ro_22e_right,
      Ro_22e_left_rest = Ro_22c - Ro_22e_left,
      Ro_22e_right_rest = ksl_product_rest(R->m22, correction_2, Ro_22d, Ro_22e_right),
      Ro_22e_lo1 = Ro_22e_left_rest + Ro_22e_right_rest, Ro_22e_lo2 = Ro_22e_lo1 + Ro_22d_cross2,
      Ro_22e_lo = Ro_22e_lo2 + Ro_22c_lo, Ro_22 = Ro_22e + R->m22, Ro_22_right = Ro_22 - Ro_22e,
      Ro_22_left = Ro_22 - Ro_22_right, Ro_22_left_rest = Ro_22e - Ro_22_left,
      Ro_22_right_rest = R->m22 - Ro_22_right, Ro_22_lo1 = Ro_22_left_rest + Ro_22_right_rest,
      Ro_22_lo = Ro_22_lo1 + Ro_22e_lo;
  const double Ro_00_rounded = Ro_00 + Ro_00_lo;
  const double Ro_01_rounded = Ro_01 + Ro_01_lo;
  const double Ro_02_rounded = Ro_02 + Ro_02_lo;
  const double Ro_10_rounded = Ro_10 + Ro_10_lo;
  const double Ro_11_rounded = Ro_11 + Ro_11_lo;
  const double Ro_12_rounded = Ro_12 + Ro_12_lo;
  const double Ro_20_rounded = Ro_20 + Ro_20_lo;
  const double Ro_21_rounded = Ro_21 + Ro_21_lo;
  const double Ro_22_rounded = Ro_22 + Ro_22_lo;
  Ro->m00 = Ro_00_rounded;
  Ro->m01 = Ro_01_rounded;
  Ro->m02 = Ro_02_rounded;
  Ro->m10 = Ro_10_rounded;
  Ro->m11 = Ro_11_rounded;
  Ro->m12 = Ro_12_rounded;
  Ro->m20 = Ro_20_rounded;
  Ro->m21 = Ro_21_rounded;
  Ro->m22 = Ro_22_rounded;
}

/* vo with exp vo~ = R, |vo| <= π; if R is not quite a rotation, its defect carries over to vo.
   R: rotation or other 3×3 matrix; vo: vector.
   11 mul, 16 add, 1 div, 1 sqrt, 1 atan2, 5 neg, 3 abs, 12 less, 1 equal, 25 select.
   Error <= vo: 7 u of its largest component for R a rotation; searched, not proved. */
static inline void ksl_SO3_logf_accurate(const ksl_mat3x3f_t *R, ksl_vec3f_t *vo) {
  const double p_0 = (double)R->m21 - (double)R->m12;
  const double p_1 = (double)R->m02 - (double)R->m20;
  const double p_2 = (double)R->m10 - (double)R->m01;
  const double s_0 = (double)R->m12 + (double)R->m21;
  const double s_1 = (double)R->m02 + (double)R->m20;
  const double s_2 = (double)R->m01 + (double)R->m10;
  const double first_0 = (double)R->m00 + 1.0;
  const double first_1 = 1.0 - (double)R->m00;
  const double others_0 = (double)R->m11 + (double)R->m22;
  const double others_1 = (double)R->m11 - (double)R->m22;
  const double d_0 = first_0 + others_0;
  const double d_1 = first_0 - others_0;
  const double d_2 = first_1 + others_1;
  const double d_3 = first_1 - others_1;
  const double low_0 = (double)R->m11 < (double)R->m00 ? d_1 : s_2;
  const double low_1 = (double)R->m11 < (double)R->m00 ? s_2 : d_2;
  const double low_2 = (double)R->m11 < (double)R->m00 ? s_1 : s_0;
  const double low_3 = (double)R->m11 < (double)R->m00 ? p_0 : p_1;
  const double high_0a = -(double)R->m11, high_0 = (double)R->m00 < high_0a ? s_1 : p_0;
  const double high_1 = (double)R->m00 < high_0a ? s_0 : p_1;
  const double high_2 = (double)R->m00 < high_0a ? d_3 : p_2;
  const double high_3 = (double)R->m00 < high_0a ? p_2 : d_0;
  const double column_0 = (double)R->m22 < 0.0 ? low_0 : high_0;
  const double column_1 = (double)R->m22 < 0.0 ? low_1 : high_1;
  const double column_2 = (double)R->m22 < 0.0 ? low_2 : high_2;
  const double column_3 = (double)R->m22 < 0.0 ? low_3 : high_3;
  const double upper_0a = -column_0, upper_0 = column_3 < 0.0 ? upper_0a : column_0;
  const double upper_1a = -column_1, upper_1 = column_3 < 0.0 ? upper_1a : column_1;
  const double upper_2a = -column_2, upper_2 = column_3 < 0.0 ? upper_2a : column_2;
  const double upper_3a = -column_3, upper_3 = column_3 < 0.0 ? upper_3a : column_3;
  const double v_s_size_0 = fabs(upper_0);
  const double v_s_size_1 = fabs(upper_1);
  const double v_s_size_2 = fabs(upper_2);
  const double v_s_largest1 = v_s_size_0 < v_s_size_1 ? v_s_size_1 : v_s_size_0;
  const double v_s_largest2 = v_s_largest1 < v_s_size_2 ? v_s_size_2 : v_s_largest1;
  const double v_s_b = 4.611686018427388e+18 < v_s_largest2 ? 2.710505431213761e-20 : 1.0,
      v_s_d = v_s_largest2 < 256.0 ? 1.8014398509481984e+16 : v_s_b,
      v_s = v_s_largest2 < 1.4210854715202004e-14 ? 3.2451855365842673e+32 : v_s_d;
  const double v_y_0 = KSL_MUL(upper_0, v_s);
  const double v_y_1 = KSL_MUL(upper_1, v_s);
  const double v_y_2 = KSL_MUL(upper_2, v_s);
  const double v_n_a = KSL_MUL(v_y_0, v_y_0), v_n_b = KSL_MUL(v_y_1, v_y_1), v_n_c = v_n_a + v_n_b,
      v_n_d = KSL_MUL(v_y_2, v_y_2), v_n_e = v_n_c + v_n_d, v_n = sqrt(v_n_e);
  const double v_r_b = v_s < 1.0 ? 3.6893488147419103e+19 : 1.0,
      v_r_d = 1.0 < v_s ? 5.551115123125783e-17 : v_r_b,
      v_r = 1.8014398509481984e+16 < v_s ? 3.0814879110195774e-33 : v_r_d;
  const double n = KSL_MUL(v_n, v_r);
  const double half = ksl_atan2(n, upper_3);
  const double divisor = n == 0.0 ? 1.0 : n;
  const double theta = KSL_MUL(2.0, half);
  const double k = theta / divisor;
  const double vector_0 = KSL_MUL(upper_0, k);
  const double vector_1 = KSL_MUL(upper_1, k);
  const double vector_2 = KSL_MUL(upper_2, k);
  vo->x = (float)vector_0;
  vo->y = (float)vector_1;
  vo->z = (float)vector_2;
}

/* self = R + R (I - R^T R)/2, closer to a rotation: a defect d of R becomes 3/4 d^2.
   self: rotation or other 3×3 matrix.
   51 mul, 42 add, 3 neg.
   Error <= u |result| + 1/4 u^2 S, S the sum of the |terms| of the expanded formula; barring
     over- and underflow. */
static inline void ksl_mat3x3f_orthonormalize_accurate(ksl_mat3x3f_t *self) {
  const double defect_0b = ksl_product_sum(-(double)self->m00, (double)self->m00, 1.0),
      defect_0d = ksl_product_sum(-(double)self->m10, (double)self->m10, defect_0b),
      defect_0 = ksl_product_sum(-(double)self->m20, (double)self->m20, defect_0d);
  const double defect_1b = ksl_product_sum(-(double)self->m01, (double)self->m01, 1.0),
      defect_1d = ksl_product_sum(-(double)self->m11, (double)self->m11, defect_1b),
      defect_1 = ksl_product_sum(-(double)self->m21, (double)self->m21, defect_1d);
  const double defect_2b = ksl_product_sum(-(double)self->m02, (double)self->m02, 1.0),
      defect_2d = ksl_product_sum(-(double)self->m12, (double)self->m12, defect_2b),
      defect_2 = ksl_product_sum(-(double)self->m22, (double)self->m22, defect_2d);
  const double defect_3a = (double)self->m00 * (double)self->m01, defect_3c_lead = -defect_3a,
      defect_3c = ksl_product_sum(-(double)self->m10, (double)self->m11, defect_3c_lead),
      defect_3 = ksl_product_sum(-(double)self->m20, (double)self->m21, defect_3c);
  const double defect_4a = (double)self->m00 * (double)self->m02, defect_4c_lead = -defect_4a,
      defect_4c = ksl_product_sum(-(double)self->m10, (double)self->m12, defect_4c_lead),
      defect_4 = ksl_product_sum(-(double)self->m20, (double)self->m22, defect_4c);
  const double defect_5a = (double)self->m01 * (double)self->m02, defect_5c_lead = -defect_5a,
      defect_5c = ksl_product_sum(-(double)self->m11, (double)self->m12, defect_5c_lead),
      defect_5 = ksl_product_sum(-(double)self->m21, (double)self->m22, defect_5c);
  const double correction_0 = KSL_MUL(0.5, defect_0);
  const double correction_1 = KSL_MUL(0.5, defect_1);
  const double correction_2 = KSL_MUL(0.5, defect_2);
  const double correction_3 = KSL_MUL(0.5, defect_3);
  const double correction_4 = KSL_MUL(0.5, defect_4);
  const double correction_5 = KSL_MUL(0.5, defect_5);
  const double self_00_new_a = KSL_MUL((double)self->m00, correction_0),
      self_00_new_b = KSL_MUL((double)self->m01, correction_3),
      self_00_new_c = self_00_new_a + self_00_new_b,
      self_00_new_d = KSL_MUL((double)self->m02, correction_4),
      self_00_new_e = self_00_new_c + self_00_new_d,
      self_00_new = (double)self->m00 + self_00_new_e;
  const double self_01_new_a = KSL_MUL((double)self->m00, correction_3),
      self_01_new_b = KSL_MUL((double)self->m01, correction_1),
      self_01_new_c = self_01_new_a + self_01_new_b,
      self_01_new_d = KSL_MUL((double)self->m02, correction_5),
      self_01_new_e = self_01_new_c + self_01_new_d,
      self_01_new = self_01_new_e + (double)self->m01;
  const double self_02_new_a = KSL_MUL((double)self->m00, correction_4),
      self_02_new_b = KSL_MUL((double)self->m01, correction_5),
      self_02_new_c = self_02_new_a + self_02_new_b,
      self_02_new_d = KSL_MUL((double)self->m02, correction_2),
      self_02_new_e = self_02_new_c + self_02_new_d,
      self_02_new = self_02_new_e + (double)self->m02;
  const double self_10_new_a = KSL_MUL((double)self->m10, correction_0),
      self_10_new_b = KSL_MUL((double)self->m11, correction_3),
      self_10_new_c = self_10_new_a + self_10_new_b,
      self_10_new_d = KSL_MUL((double)self->m12, correction_4),
      self_10_new_e = self_10_new_c + self_10_new_d,
      self_10_new = (double)self->m10 + self_10_new_e;
  const double self_11_new_a = KSL_MUL((double)self->m10, correction_3),
      self_11_new_b = KSL_MUL((double)self->m11, correction_1),
      self_11_new_c = self_11_new_a + self_11_new_b,
      self_11_new_d = KSL_MUL((double)self->m12, correction_5),
      self_11_new_e = self_11_new_c + self_11_new_d,
      self_11_new = self_11_new_e + (double)self->m11;
  const double self_12_new_a = KSL_MUL((double)self->m10, correction_4),
      self_12_new_b = KSL_MUL((double)self->m11, correction_5),
      self_12_new_c = self_12_new_a + self_12_new_b,
      self_12_new_d = KSL_MUL((double)self->m12, correction_2),
      self_12_new_e = self_12_new_c + self_12_new_d,
      self_12_new = self_12_new_e + (double)self->m12;
  const double self_20_new_a = KSL_MUL((double)self->m20, correction_0),
      self_20_new_b = KSL_MUL((double)self->m21, correction_3),
      self_20_new_c = self_20_new_a + self_20_new_b,
      self_20_new_d = KSL_MUL((double)self->m22, correction_4),
      self_20_new_e = self_20_new_c + self_20_new_d,
      self_20_new = (double)self->m20 + self_20_new_e;
  const double self_21_new_a = KSL_MUL((double)self->m20, correction_3),
      self_21_new_b = KSL_MUL((double)self->m21, correction_1),
      self_21_new_c = self_21_new_a + self_21_new_b,
      self_21_new_d = KSL_MUL((double)self->m22, correction_5),
      self_21_new_e = self_21_new_c + self_21_new_d,
      self_21_new = self_21_new_e + (double)self->m21;
  const double self_22_new_a = KSL_MUL((double)self->m20, correction_4),
      self_22_new_b = KSL_MUL((double)self->m21, correction_5),
      self_22_new_c = self_22_new_a + self_22_new_b,
      self_22_new_d = KSL_MUL((double)self->m22, correction_2),
      self_22_new_e = self_22_new_c + self_22_new_d,
      self_22_new = self_22_new_e + (double)self->m22;
  self->m00 = (float)self_00_new;
  self->m01 = (float)self_01_new;
  self->m02 = (float)self_02_new;
  self->m10 = (float)self_10_new;
  self->m11 = (float)self_11_new;
  self->m12 = (float)self_12_new;
  self->m20 = (float)self_20_new;
  self->m21 = (float)self_21_new;
  self->m22 = (float)self_22_new;
}

/* Ro = R + R (I - R^T R)/2, closer to a rotation: a defect d of R becomes 3/4 d^2.
   R, Ro: rotation or other 3×3 matrix.
   51 mul, 42 add, 3 neg.
   Error <= u |result| + 1/4 u^2 S, S the sum of the |terms| of the expanded formula; barring
     over- and underflow. */
static inline void ksl_mat3x3f_orthonormalized_accurate(const ksl_mat3x3f_t *R, ksl_mat3x3f_t *Ro) {
  const double defect_0b = ksl_product_sum(-(double)R->m00, (double)R->m00, 1.0),
      defect_0d = ksl_product_sum(-(double)R->m10, (double)R->m10, defect_0b),
      defect_0 = ksl_product_sum(-(double)R->m20, (double)R->m20, defect_0d);
  const double defect_1b = ksl_product_sum(-(double)R->m01, (double)R->m01, 1.0),
      defect_1d = ksl_product_sum(-(double)R->m11, (double)R->m11, defect_1b),
      defect_1 = ksl_product_sum(-(double)R->m21, (double)R->m21, defect_1d);
  const double defect_2b = ksl_product_sum(-(double)R->m02, (double)R->m02, 1.0),
      defect_2d = ksl_product_sum(-(double)R->m12, (double)R->m12, defect_2b),
      defect_2 = ksl_product_sum(-(double)R->m22, (double)R->m22, defect_2d);
  const double defect_3a = (double)R->m00 * (double)R->m01, defect_3c_lead = -defect_3a,
      defect_3c = ksl_product_sum(-(double)R->m10, (double)R->m11, defect_3c_lead),
      defect_3 = ksl_product_sum(-(double)R->m20, (double)R->m21, defect_3c);
  const double defect_4a = (double)R->m00 * (double)R->m02, defect_4c_lead = -defect_4a,
      defect_4c = ksl_product_sum(-(double)R->m10, (double)R->m12, defect_4c_lead),
      defect_4 = ksl_product_sum(-(double)R->m20, (double)R->m22, defect_4c);
  const double defect_5a = (double)R->m01 * (double)R->m02, defect_5c_lead = -defect_5a,
      defect_5c = ksl_product_sum(-(double)R->m11, (double)R->m12, defect_5c_lead),
      defect_5 = ksl_product_sum(-(double)R->m21, (double)R->m22, defect_5c);
  const double correction_0 = KSL_MUL(0.5, defect_0);
  const double correction_1 = KSL_MUL(0.5, defect_1);
  const double correction_2 = KSL_MUL(0.5, defect_2);
  const double correction_3 = KSL_MUL(0.5, defect_3);
  const double correction_4 = KSL_MUL(0.5, defect_4);
  const double correction_5 = KSL_MUL(0.5, defect_5);
  const double Ro_00a = KSL_MUL((double)R->m00, correction_0),
      Ro_00b = KSL_MUL((double)R->m01, correction_3), Ro_00c = Ro_00a + Ro_00b,
      Ro_00d = KSL_MUL((double)R->m02, correction_4), Ro_00e = Ro_00c + Ro_00d,
      Ro_00 = (double)R->m00 + Ro_00e;
  const double Ro_01a = KSL_MUL((double)R->m00, correction_3),
      Ro_01b = KSL_MUL((double)R->m01, correction_1), Ro_01c = Ro_01a + Ro_01b,
      Ro_01d = KSL_MUL((double)R->m02, correction_5), Ro_01e = Ro_01c + Ro_01d,
      Ro_01 = Ro_01e + (double)R->m01;
  const double Ro_02a = KSL_MUL((double)R->m00, correction_4),
      Ro_02b = KSL_MUL((double)R->m01, correction_5), Ro_02c = Ro_02a + Ro_02b,
      Ro_02d = KSL_MUL((double)R->m02, correction_2), Ro_02e = Ro_02c + Ro_02d,
      Ro_02 = Ro_02e + (double)R->m02;
  const double Ro_10a = KSL_MUL((double)R->m10, correction_0),
      Ro_10b = KSL_MUL((double)R->m11, correction_3), Ro_10c = Ro_10a + Ro_10b,
      Ro_10d = KSL_MUL((double)R->m12, correction_4), Ro_10e = Ro_10c + Ro_10d,
      Ro_10 = (double)R->m10 + Ro_10e;
  const double Ro_11a = KSL_MUL((double)R->m10, correction_3),
      Ro_11b = KSL_MUL((double)R->m11, correction_1), Ro_11c = Ro_11a + Ro_11b,
      Ro_11d = KSL_MUL((double)R->m12, correction_5), Ro_11e = Ro_11c + Ro_11d,
      Ro_11 = Ro_11e + (double)R->m11;
  const double Ro_12a = KSL_MUL((double)R->m10, correction_4),
      Ro_12b = KSL_MUL((double)R->m11, correction_5), Ro_12c = Ro_12a + Ro_12b,
      Ro_12d = KSL_MUL((double)R->m12, correction_2), Ro_12e = Ro_12c + Ro_12d,
      Ro_12 = Ro_12e + (double)R->m12;
  const double Ro_20a = KSL_MUL((double)R->m20, correction_0),
      Ro_20b = KSL_MUL((double)R->m21, correction_3), Ro_20c = Ro_20a + Ro_20b,
      Ro_20d = KSL_MUL((double)R->m22, correction_4), Ro_20e = Ro_20c + Ro_20d,
      Ro_20 = (double)R->m20 + Ro_20e;
  const double Ro_21a = KSL_MUL((double)R->m20, correction_3),
      Ro_21b = KSL_MUL((double)R->m21, correction_1), Ro_21c = Ro_21a + Ro_21b,
      Ro_21d = KSL_MUL((double)R->m22, correction_5), Ro_21e = Ro_21c + Ro_21d,
      Ro_21 = Ro_21e + (double)R->m21;
  const double Ro_22a = KSL_MUL((double)R->m20, correction_4),
      Ro_22b = KSL_MUL((double)R->m21, correction_5), Ro_22c = Ro_22a + Ro_22b,
      Ro_22d = KSL_MUL((double)R->m22, correction_2), Ro_22e = Ro_22c + Ro_22d,
      Ro_22 = Ro_22e + (double)R->m22;
  Ro->m00 = (float)Ro_00;
  Ro->m01 = (float)Ro_01;
  Ro->m02 = (float)Ro_02;
  Ro->m10 = (float)Ro_10;
  Ro->m11 = (float)Ro_11;
  Ro->m12 = (float)Ro_12;
  Ro->m20 = (float)Ro_20;
  Ro->m21 = (float)Ro_21;
  Ro->m22 = (float)Ro_22;
}

#endif
