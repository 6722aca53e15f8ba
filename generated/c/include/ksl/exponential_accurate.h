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

/* R = exp v~ = I + sin θ/θ v~ + (1 - cos θ)/θ^2 v~^2, θ = |v|.
   v: vector; R: rotation or other 3×3 matrix.
   178 mul, 320 add, 17 product error, 22 product rest, 5 div, 1 sqrt, 7 abs, 6 less, 10 equal,
     19 select.
   Error <= R: 1 u of its largest component for |v| <= 1e13, in single precision 1e5; searched,
     not proved.  Each component is within 1 ulp as long as its condition is below 1e13; in
     single precision it is the nearest number, except near ties, as long as that is below 1e5;
     searched, not proved. */
static inline void ksl_SO3_exp_accurate(const ksl_vec3_t *v, ksl_mat3x3_t *R) {
  const double halved_0 = KSL_MUL(0.5, v->x), halved_1 = KSL_MUL(0.5, v->y),
      halved_2 = KSL_MUL(0.5, v->z);
  const double h_size_0 = fabs(halved_0), h_size_1 = fabs(halved_1), h_size_2 = fabs(halved_2);
  const double h_largest1 = h_size_0 < h_size_1 ? h_size_1 : h_size_0;
  const double h_largest2 = h_largest1 < h_size_2 ? h_size_2 : h_largest1;
  const double s = 6.703903964971299e+153 < h_largest2 ? 3.7291703656001034e-155 : 1.0;
  const double reduced_0 = KSL_MUL(halved_0, s), reduced_1 = KSL_MUL(halved_1, s),
      reduced_2 = KSL_MUL(halved_2, s);
  const double up = s < 1.0 ? 2.6815615859885194e+154 : 1.0;
  const double reduced_length_a = KSL_MUL(reduced_0, reduced_0),
      reduced_length_b = KSL_MUL(reduced_1, reduced_1),
      reduced_length_c = reduced_length_a + reduced_length_b,
      reduced_length_c_right = reduced_length_c - reduced_length_a,
      reduced_length_c_left_rest = ksl_product_rest(reduced_0, reduced_0, reduced_length_a,
          reduced_length_c - reduced_length_c_right),
      reduced_length_d = KSL_MUL(reduced_2, reduced_2),
      reduced_length_e = reduced_length_c + reduced_length_d,
      reduced_length_e_right = reduced_length_e - reduced_length_c,
      reduced_length_e_right_rest = ksl_product_rest(reduced_2, reduced_2, reduced_length_d,
          reduced_length_e_right),
      reduced_length_c_lo = reduced_length_c_left_rest
          + ksl_product_rest(reduced_1, reduced_1, reduced_length_b, reduced_length_c_right),
      reduced_length_e_lo = reduced_length_c - (reduced_length_e - reduced_length_e_right)
          + reduced_length_e_right_rest + reduced_length_c_lo,
      reduced_length_e_sum = reduced_length_e + reduced_length_e_lo,
      reduced_length_e_sum_right = reduced_length_e_sum - reduced_length_e,
      reduced_length = sqrt(reduced_length_e_sum),
      reduced_length_product = KSL_MUL(reduced_length, reduced_length),
      reduced_length_e_sum_lo = reduced_length_e
          - (reduced_length_e_sum - reduced_length_e_sum_right)
          + (reduced_length_e_lo - reduced_length_e_sum_right),
      reduced_length_exact = reduced_length_e_sum - reduced_length_product
          - ksl_product_error(reduced_length, reduced_length, reduced_length_product),
      reduced_length_twice = reduced_length + reduced_length,
      reduced_length_lo = (reduced_length_exact + reduced_length_e_sum_lo)
          / (reduced_length == 0.0 ? 1.0 : reduced_length_twice);
  const double reduced_length_sum = reduced_length + reduced_length_lo,
      reduced_length_sum_right = reduced_length_sum - reduced_length,
      half_angle = KSL_MUL(reduced_length_sum, up),
      reduced_length_sum_lo = reduced_length - (reduced_length_sum - reduced_length_sum_right)
          + (reduced_length_lo - reduced_length_sum_right),
      half_angle_lo = KSL_MUL(reduced_length_sum - KSL_MUL(half_angle, 1.0 / up)
          + reduced_length_sum_lo, up);
  const double y = KSL_MUL(half_angle, half_angle);
  const double half_angle_sum = half_angle + half_angle_lo,
      half_angle_sum_right = half_angle_sum - half_angle,
      half_angle_sum_lo = half_angle - (half_angle_sum - half_angle_sum_right)
          + (half_angle_lo - half_angle_sum_right);
  double c; const double sine = ksl_sincos(half_angle_sum, &c);
  double c_own_error; const double sine_own_error = ksl_sincos_error(half_angle_sum, sine, c,
      &c_own_error);
  const double sine_half = KSL_MUL(half_angle_sum_lo, 0.5);
  double sine_half_cos; const double sine_half_sin = ksl_sincos(sine_half, &sine_half_cos);
  const double sine_twice = sine_half_sin + sine_half_sin,
      sine_lo = sine_own_error
          + KSL_MUL(KSL_MUL(sine_half_cos, c) - KSL_MUL(sine_half_sin, sine), sine_twice);
  const double c_lo = c_own_error
          - KSL_MUL(KSL_MUL(sine_half_cos, sine) + KSL_MUL(sine_half_sin, c), sine_twice);
  const double sinc_divisor = half_angle_sum < 1.4901161193847656e-08 ? 1.4901161193847656e-08
          : half_angle_sum,
      sinc_divisor_lo = half_angle_sum < 1.4901161193847656e-08 ? 0.0 : half_angle_sum_lo;
  const double sine_sum = sine + sine_lo, sine_sum_right = sine_sum - sine,
      sinc_divisor_sum = sinc_divisor + sinc_divisor_lo,
      sinc_divisor_sum_right = sinc_divisor_sum - sinc_divisor,
      sinc_quotient = sine_sum / sinc_divisor_sum,
      sinc_quotient_product = KSL_MUL(sinc_quotient, sinc_divisor_sum),
      sinc_quotient_exact = sine_sum - sinc_quotient_product
          - ksl_product_error(sinc_quotient, sinc_divisor_sum, sinc_quotient_product),
      sinc_quotient_cross = KSL_MUL(sinc_quotient, sinc_divisor
          - (sinc_divisor_sum - sinc_divisor_sum_right)
          + (sinc_divisor_lo - sinc_divisor_sum_right)),
      sinc_quotient_lo = (sinc_quotient_exact
          + (sine - (sine_sum - sine_sum_right) + (sine_lo - sine_sum_right))
          - sinc_quotient_cross) / sinc_divisor_sum;
  const double sinc_a = KSL_MUL(0.16666666666666666, y),
      y_lo = ksl_product_error(half_angle, half_angle, y)
          + (KSL_MUL(half_angle_lo, half_angle) + KSL_MUL(half_angle, half_angle_lo)),
      sinc_b = 1.0 - sinc_a, sinc_b_right = 1.0 - sinc_b,
      sinc_b_lo1 = 1.0 - (sinc_b + sinc_b_right)
          - ksl_product_rest(0.16666666666666666, y, sinc_a, sinc_b_right),
      sinc_b_lo = sinc_b_lo1
          - (KSL_MUL(9.25185853854297e-18, y) + KSL_MUL(0.16666666666666666, y_lo)),
      sinc = half_angle_sum < 1.4901161193847656e-08 ? sinc_b : sinc_quotient,
      sinc_lo = half_angle_sum < 1.4901161193847656e-08 ? sinc_b_lo : sinc_quotient_lo;
  const double turning_0 = KSL_MUL(v->x, sinc), turning_1 = KSL_MUL(v->y, sinc),
      turning_2 = KSL_MUL(v->z, sinc);
  const double turning_0_lo = ksl_product_error(v->x, sinc, turning_0) + KSL_MUL(v->x, sinc_lo),
      beta_v_0 = KSL_MUL(0.5, turning_0), beta_v_0_cross2 = KSL_MUL(0.5, turning_0_lo);
  const double turning_1_lo = ksl_product_error(v->y, sinc, turning_1) + KSL_MUL(v->y, sinc_lo),
      beta_v_1 = KSL_MUL(0.5, turning_1), beta_v_1_cross2 = KSL_MUL(0.5, turning_1_lo);
  const double turning_2_lo = ksl_product_error(v->z, sinc, turning_2) + KSL_MUL(v->z, sinc_lo),
      beta_v_2 = KSL_MUL(0.5, turning_2);
  const double m_0 = KSL_MUL(turning_0, beta_v_0),
      m_0_cross = KSL_MUL(turning_0_lo, beta_v_0) + KSL_MUL(turning_0, beta_v_0_cross2);
  const double m_1 = KSL_MUL(turning_1, beta_v_1),
      m_1_cross = KSL_MUL(turning_1_lo, beta_v_1) + KSL_MUL(turning_1, beta_v_1_cross2);
  const double m_2 = KSL_MUL(turning_2, beta_v_2),
      m_2_cross = KSL_MUL(turning_2_lo, beta_v_2) + KSL_MUL(turning_2, KSL_MUL(0.5, turning_2_lo));
  const double m_3 = KSL_MUL(turning_1, beta_v_0),
      m_3_cross = KSL_MUL(turning_1_lo, beta_v_0) + KSL_MUL(turning_1, beta_v_0_cross2);
  const double m_4 = KSL_MUL(turning_2, beta_v_0),
      m_4_cross = KSL_MUL(turning_2_lo, beta_v_0) + KSL_MUL(turning_2, beta_v_0_cross2);
  const double m_5 = KSL_MUL(turning_2, beta_v_1),
      m_5_cross = KSL_MUL(turning_2_lo, beta_v_1) + KSL_MUL(turning_2, beta_v_1_cross2);
  const double others_0 = m_1 + m_2, others_0_right = others_0 - m_1,
      others_0_lo1 = ksl_product_rest(turning_1, beta_v_1, m_1, others_0 - others_0_right)
          + ksl_product_rest(turning_2, beta_v_2, m_2, others_0_right);
  const double others_1 = m_0 + m_2, others_1_right = others_1 - m_0,
      others_1_lo1 = ksl_product_rest(turning_0, beta_v_0, m_0, others_1 - others_1_right)
          + ksl_product_rest(turning_2, beta_v_2, m_2, others_1_right);
  const double others_2 = m_0 + m_1, others_2_right = others_2 - m_0,
      others_2_lo1 = ksl_product_rest(turning_0, beta_v_0, m_0, others_2 - others_2_right)
          + ksl_product_rest(turning_1, beta_v_1, m_1, others_2_right);
  const double alpha_v_0 = KSL_MUL(c, turning_0),
      alpha_v_0_cross = KSL_MUL(c_lo, turning_0) + KSL_MUL(c, turning_0_lo);
  const double alpha_v_1 = KSL_MUL(c, turning_1),
      alpha_v_1_cross = KSL_MUL(c_lo, turning_1) + KSL_MUL(c, turning_1_lo);
  const double alpha_v_2 = KSL_MUL(c, turning_2),
      alpha_v_2_cross = KSL_MUL(c_lo, turning_2) + KSL_MUL(c, turning_2_lo);
  const double R_00 = 1.0 - others_0, R_00_right = 1.0 - R_00;
  const double R_01 = m_3 - alpha_v_2, R_01_right = m_3 - R_01,
      R_01_lo1 = ksl_product_rest(turning_1, beta_v_0, m_3, R_01 + R_01_right)
          - ksl_product_rest(c, turning_2, alpha_v_2, R_01_right);
  const double R_02 = m_4 + alpha_v_1, R_02_right = R_02 - m_4,
      R_02_lo1 = ksl_product_rest(turning_2, beta_v_0, m_4, R_02 - R_02_right)
          + ksl_product_rest(c, turning_1, alpha_v_1, R_02_right);
  const double R_10 = m_3 + alpha_v_2, R_10_right = R_10 - m_3,
      R_10_lo1 = ksl_product_rest(turning_1, beta_v_0, m_3, R_10 - R_10_right)
          + ksl_product_rest(c, turning_2, alpha_v_2, R_10_right);
  const double R_11 = 1.0 - others_1, R_11_right = 1.0 - R_11;
  const double R_12 = m_5 - alpha_v_0, R_12_right = m_5 - R_12,
      R_12_lo1 = ksl_product_rest(turning_2, beta_v_1, m_5, R_12 + R_12_right)
          - ksl_product_rest(c, turning_0, alpha_v_0, R_12_right);
  const double R_20 = m_4 - alpha_v_1, R_20_right = m_4 - R_20,
      R_20_lo1 = ksl_product_rest(turning_2, beta_v_0, m_4, R_20 + R_20_right)
          - ksl_product_rest(c, turning_1, alpha_v_1, R_20_right);
  const double R_21 = m_5 + alpha_v_0, R_21_right = R_21 - m_5,
      R_21_lo1 = ksl_product_rest(turning_2, beta_v_1, m_5, R_21 - R_21_right)
          + ksl_product_rest(c, turning_0, alpha_v_0, R_21_right);
  const double R_22 = 1.0 - others_2, R_22_right = 1.0 - R_22;
  const double R_00_rounded = R_00
          + (1.0 - (R_00 + R_00_right) - (others_0 - R_00_right)
          - (others_0_lo1 + (m_1_cross + m_2_cross)));
  const double R_01_rounded = R_01 + (R_01_lo1 + (m_3_cross - alpha_v_2_cross));
  const double R_02_rounded = R_02 + (R_02_lo1 + (m_4_cross + alpha_v_1_cross));
  const double R_10_rounded = R_10 + (R_10_lo1 + (m_3_cross + alpha_v_2_cross));
  const double R_11_rounded = R_11
          + (1.0 - (R_11 + R_11_right) - (others_1 - R_11_right)
          - (others_1_lo1 + (m_0_cross + m_2_cross)));
  const double R_12_rounded = R_12 + (R_12_lo1 + (m_5_cross - alpha_v_0_cross));
  const double R_20_rounded = R_20 + (R_20_lo1 + (m_4_cross - alpha_v_1_cross));
  const double R_21_rounded = R_21 + (R_21_lo1 + (m_5_cross + alpha_v_0_cross));
  const double R_22_rounded = R_22
          + (1.0 - (R_22 + R_22_right) - (others_2 - R_22_right)
          - (others_2_lo1 + (m_0_cross + m_1_cross)));
  const double R_00_final = R_00_rounded == R_00_rounded ? R_00_rounded : R_00;
  const double R_01_final = R_01_rounded == R_01_rounded ? R_01_rounded : R_01;
  const double R_02_final = R_02_rounded == R_02_rounded ? R_02_rounded : R_02;
  const double R_10_final = R_10_rounded == R_10_rounded ? R_10_rounded : R_10;
  const double R_11_final = R_11_rounded == R_11_rounded ? R_11_rounded : R_11;
  const double R_12_final = R_12_rounded == R_12_rounded ? R_12_rounded : R_12;
  const double R_20_final = R_20_rounded == R_20_rounded ? R_20_rounded : R_20;
  const double R_21_final = R_21_rounded == R_21_rounded ? R_21_rounded : R_21;
  const double R_22_final = R_22_rounded == R_22_rounded ? R_22_rounded : R_22;
  R->m00 = R_00_final;
  R->m01 = R_01_final;
  R->m02 = R_02_final;
  R->m10 = R_10_final;
  R->m11 = R_11_final;
  R->m12 = R_12_final;
  R->m20 = R_20_final;
  R->m21 = R_21_final;
  R->m22 = R_22_final;
}

/* vo with exp vo~ = R, |vo| <= π; if R is not quite a rotation, its defect carries over to vo.
   R: rotation or other 3×3 matrix; vo: vector.
   162 mul, 433 add, 26 product error, 3 product rest, 10 div, 1 sqrt, 13 neg, 13 abs, 4
     copysign, 29 less, 9 equal, 77 select.
   Error <= vo: 1 u of its largest component for R a rotation; searched, not proved.  Each
     component is within 1 ulp as long as its condition is below 1e13; in single precision it is
     the nearest number, except near ties, as long as that is below 1e5; searched, not proved. */
static inline void ksl_SO3_log_accurate(const ksl_mat3x3_t *R, ksl_vec3_t *vo) {
  const double p_0 = R->m21 - R->m12, p_0_right = R->m21 - p_0,
      p_0_lo = R->m21 - (p_0 + p_0_right) - (R->m12 - p_0_right);
  const double p_1 = R->m02 - R->m20, p_1_right = R->m02 - p_1,
      p_1_lo = R->m02 - (p_1 + p_1_right) - (R->m20 - p_1_right);
  const double p_2 = R->m10 - R->m01, p_2_right = R->m10 - p_2,
      p_2_lo = R->m10 - (p_2 + p_2_right) - (R->m01 - p_2_right);
  const double s_0 = R->m12 + R->m21, s_0_right = s_0 - R->m12,
      s_0_lo = R->m12 - (s_0 - s_0_right) + (R->m21 - s_0_right);
  const double s_1 = R->m02 + R->m20, s_1_right = s_1 - R->m02,
      s_1_lo = R->m02 - (s_1 - s_1_right) + (R->m20 - s_1_right);
  const double s_2 = R->m01 + R->m10, s_2_right = s_2 - R->m01,
      s_2_lo = R->m01 - (s_2 - s_2_right) + (R->m10 - s_2_right);
  const double first_0 = R->m00 + 1.0, first_0_right = first_0 - R->m00,
      first_0_lo = R->m00 - (first_0 - first_0_right) + (1.0 - first_0_right);
  const double first_1 = 1.0 - R->m00, first_1_right = 1.0 - first_1,
      first_1_lo = 1.0 - (first_1 + first_1_right) - (R->m00 - first_1_right);
  const double others_0 = R->m11 + R->m22, others_0_right = others_0 - R->m11,
      others_0_lo = R->m11 - (others_0 - others_0_right) + (R->m22 - others_0_right);
  const double others_1 = R->m11 - R->m22, others_1_right = R->m11 - others_1,
      others_1_lo = R->m11 - (others_1 + others_1_right) - (R->m22 - others_1_right);
  const double d_0 = first_0 + others_0, d_0_right = d_0 - first_0,
      d_0_lo = first_0 - (d_0 - d_0_right) + (others_0 - d_0_right) + others_0_lo + first_0_lo;
  const double d_1 = first_0 - others_0, d_1_right = first_0 - d_1,
      d_1_lo = first_0 - (d_1 + d_1_right) - (others_0 - d_1_right) - others_0_lo + first_0_lo;
  const double d_2 = first_1 + others_1, d_2_right = d_2 - first_1,
      d_2_lo = first_1 - (d_2 - d_2_right) + (others_1 - d_2_right) + others_1_lo + first_1_lo;
  const double d_3 = first_1 - others_1, d_3_right = first_1 - d_3,
      d_3_lo = first_1 - (d_3 + d_3_right) - (others_1 - d_3_right) - others_1_lo + first_1_lo;
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
      column_3_sum = column_3 + column_3_lo, column_3_sum_right = column_3_sum - column_3,
      column_3_sum_lo = column_3 - (column_3_sum - column_3_sum_right)
          + (column_3_lo - column_3_sum_right), upper_0 = column_3_sum < 0.0 ? upper_0a : column_0,
      upper_0_lo = column_3_sum < 0.0 ? upper_0a_lo : column_0_lo;
  const double upper_1a = -column_1, upper_1a_lo = -column_1_lo,
      upper_1 = column_3_sum < 0.0 ? upper_1a : column_1,
      upper_1_lo = column_3_sum < 0.0 ? upper_1a_lo : column_1_lo;
  const double upper_2a = -column_2, upper_2a_lo = -column_2_lo,
      upper_2 = column_3_sum < 0.0 ? upper_2a : column_2,
      upper_2_lo = column_3_sum < 0.0 ? upper_2a_lo : column_2_lo;
  const double upper_3a = -column_3_sum, upper_3a_lo = -column_3_sum_lo,
      upper_3 = column_3_sum < 0.0 ? upper_3a : column_3_sum,
      upper_3_lo = column_3_sum < 0.0 ? upper_3a_lo : column_3_sum_lo;
  const double upper_0_sum = upper_0 + upper_0_lo, upper_0_sum_right = upper_0_sum - upper_0,
      upper_0_sum_lo = upper_0 - (upper_0_sum - upper_0_sum_right)
          + (upper_0_lo - upper_0_sum_right), v_s_size_0 = fabs(upper_0_sum),
      v_s_size_0_opposite = -upper_0_sum_lo,
      v_s_size_0_lo = upper_0_sum < 0.0 ? v_s_size_0_opposite : upper_0_sum_lo;
  const double upper_1_sum = upper_1 + upper_1_lo, upper_1_sum_right = upper_1_sum - upper_1,
      upper_1_sum_lo = upper_1 - (upper_1_sum - upper_1_sum_right)
          + (upper_1_lo - upper_1_sum_right), v_s_size_1 = fabs(upper_1_sum),
      v_s_size_1_opposite = -upper_1_sum_lo,
      v_s_size_1_lo = upper_1_sum < 0.0 ? v_s_size_1_opposite : upper_1_sum_lo;
  const double upper_2_sum = upper_2 + upper_2_lo, upper_2_sum_right = upper_2_sum - upper_2,
      upper_2_sum_lo = upper_2 - (upper_2_sum - upper_2_sum_right)
          + (upper_2_lo - upper_2_sum_right), v_s_size_2 = fabs(upper_2_sum),
      v_s_size_2_opposite = -upper_2_sum_lo,
      v_s_size_2_lo = upper_2_sum < 0.0 ? v_s_size_2_opposite : upper_2_sum_lo;
  const double v_s_size_0_sum = v_s_size_0 + v_s_size_0_lo,
      v_s_size_0_sum_right = v_s_size_0_sum - v_s_size_0,
      v_s_size_0_sum_lo = v_s_size_0 - (v_s_size_0_sum - v_s_size_0_sum_right)
          + (v_s_size_0_lo - v_s_size_0_sum_right), v_s_size_1_sum = v_s_size_1 + v_s_size_1_lo,
      v_s_size_1_sum_right = v_s_size_1_sum - v_s_size_1,
      v_s_size_1_sum_lo = v_s_size_1 - (v_s_size_1_sum - v_s_size_1_sum_right)
          + (v_s_size_1_lo - v_s_size_1_sum_right),
      v_s_largest1 = v_s_size_0_sum < v_s_size_1_sum ? v_s_size_1_sum : v_s_size_0_sum,
      v_s_largest1_lo = v_s_size_0_sum < v_s_size_1_sum ? v_s_size_1_sum_lo : v_s_size_0_sum_lo;
  const double v_s_largest1_sum = v_s_largest1 + v_s_largest1_lo,
      v_s_largest1_sum_right = v_s_largest1_sum - v_s_largest1,
      v_s_largest1_sum_lo = v_s_largest1 - (v_s_largest1_sum - v_s_largest1_sum_right)
          + (v_s_largest1_lo - v_s_largest1_sum_right), v_s_size_2_sum = v_s_size_2 + v_s_size_2_lo,
      v_s_size_2_sum_right = v_s_size_2_sum - v_s_size_2,
      v_s_size_2_sum_lo = v_s_size_2 - (v_s_size_2_sum - v_s_size_2_sum_right)
          + (v_s_size_2_lo - v_s_size_2_sum_right),
      v_s_largest2 = v_s_largest1_sum < v_s_size_2_sum ? v_s_size_2_sum : v_s_largest1_sum;
  const double v_s_largest2_sum = v_s_largest2
          + (v_s_largest1_sum < v_s_size_2_sum ? v_s_size_2_sum_lo : v_s_largest1_sum_lo),
      v_s_b = 6.703903964971299e+153 < v_s_largest2_sum ? 3.7291703656001034e-155 : 1.0,
      v_s_d = v_s_largest2_sum < 256.0 ? 1.3093562431584567e+151 : v_s_b,
      v_s = v_s_largest2_sum < 1.955159272639747e-149 ? 1.0715086071862673e+301 : v_s_d;
  const double v_y_0 = KSL_MUL(upper_0_sum, v_s), v_y_0_inverse = 1.0 / v_s,
      v_y_0_lo = KSL_MUL(upper_0_sum - KSL_MUL(v_y_0, v_y_0_inverse) + upper_0_sum_lo, v_s);
  const double v_y_1 = KSL_MUL(upper_1_sum, v_s),
      v_y_1_lo = KSL_MUL(upper_1_sum - KSL_MUL(v_y_1, v_y_0_inverse) + upper_1_sum_lo, v_s);
  const double v_y_2 = KSL_MUL(upper_2_sum, v_s),
      v_y_2_lo = KSL_MUL(upper_2_sum - KSL_MUL(v_y_2, v_y_0_inverse) + upper_2_sum_lo, v_s);
  const double v_n_a = KSL_MUL(v_y_0, v_y_0), v_n_b = KSL_MUL(v_y_1, v_y_1), v_n_c = v_n_a + v_n_b,
      v_n_c_right = v_n_c - v_n_a,
      v_n_c_lo1 = ksl_product_rest(v_y_0, v_y_0, v_n_a, v_n_c - v_n_c_right)
          + ksl_product_rest(v_y_1, v_y_1, v_n_b, v_n_c_right), v_n_d = KSL_MUL(v_y_2, v_y_2),
      v_n_e = v_n_c + v_n_d, v_n_e_right = v_n_e - v_n_c,
      v_n_e_lo2 = v_n_c - (v_n_e - v_n_e_right)
          + ksl_product_rest(v_y_2, v_y_2, v_n_d, v_n_e_right)
          + (KSL_MUL(v_y_2_lo, v_y_2) + KSL_MUL(v_y_2, v_y_2_lo)),
      v_n_e_lo = v_n_e_lo2
          + (v_n_c_lo1
          + (KSL_MUL(v_y_0_lo, v_y_0) + KSL_MUL(v_y_0, v_y_0_lo)
          + (KSL_MUL(v_y_1_lo, v_y_1) + KSL_MUL(v_y_1, v_y_1_lo)))), v_n_e_sum = v_n_e + v_n_e_lo,
      v_n_e_sum_right = v_n_e_sum - v_n_e, v_n = sqrt(v_n_e_sum), v_n_product = KSL_MUL(v_n, v_n),
      v_n_e_sum_lo = v_n_e - (v_n_e_sum - v_n_e_sum_right) + (v_n_e_lo - v_n_e_sum_right),
      v_n_twice = v_n + v_n,
      v_n_lo = (v_n_e_sum - v_n_product - ksl_product_error(v_n, v_n, v_n_product) + v_n_e_sum_lo)
          / (v_n == 0.0 ? 1.0 : v_n_twice);
  const double v_r_b = v_s < 1.0 ? 2.6815615859885194e+154 : 1.0,
      v_r_d = 1.0 < v_s ? 7.637340908749012e-152 : v_r_b,
      v_r = 1.3093562431584567e+151 < v_s ? 9.332636185032189e-302 : v_r_d;
  const double v_n_sum = v_n + v_n_lo, v_n_sum_right = v_n_sum - v_n, n = KSL_MUL(v_n_sum, v_r),
      n_lo = KSL_MUL(v_n_sum - KSL_MUL(n, 1.0 / v_r)
          + (v_n - (v_n_sum - v_n_sum_right) + (v_n_lo - v_n_sum_right)), v_r);
  const double n_sum = n + n_lo, n_sum_right = n_sum - n,
      n_sum_lo = n - (n_sum - n_sum_right) + (n_lo - n_sum_right),
      upper_3_sum = upper_3 + upper_3_lo, upper_3_sum_right = upper_3_sum - upper_3,
      half = ksl_atan2(n_sum, upper_3_sum), half_size0 = fabs(n_sum),
      half_size1 = fabs(upper_3_sum), half_most = half_size0 < half_size1 ? half_size1 : half_size0,
      half_divisor = half_most == 0.0 ? 1.0 : half_most, half_part0 = n_sum / half_divisor,
      half_part1 = upper_3_sum / half_divisor,
      half_divisor2 = KSL_MUL(half_divisor, KSL_MUL(half_part1, half_part1)
          + KSL_MUL(half_part0, half_part0)),
      half_cross = KSL_MUL(half_part1, n_sum_lo)
          - KSL_MUL(half_part0, upper_3 - (upper_3_sum - upper_3_sum_right)
          + (upper_3_lo - upper_3_sum_right));
  const double divisor = n_sum == 0.0 ? 1.0 : n_sum, divisor_lo = n_sum == 0.0 ? 0.0 : n_sum_lo;
  const double theta = KSL_MUL(2.0, half),
      theta_cross2 = KSL_MUL(2.0, ksl_atan2_error(n_sum, upper_3_sum, half) + half_cross
          / (half_most == 0.0 ? 1.0 : half_divisor2));
  const double theta_sum = theta + theta_cross2, theta_sum_right = theta_sum - theta,
      divisor_sum = divisor + divisor_lo, divisor_sum_right = divisor_sum - divisor,
      k = theta_sum / divisor_sum, k_product = KSL_MUL(k, divisor_sum),
      theta_sum_lo = theta - (theta_sum - theta_sum_right) + (theta_cross2 - theta_sum_right),
      k_cross = KSL_MUL(k, divisor - (divisor_sum - divisor_sum_right)
          + (divisor_lo - divisor_sum_right)),
      k_lo = (theta_sum - k_product - ksl_product_error(k, divisor_sum, k_product) + theta_sum_lo
          - k_cross) / divisor_sum;
  const double vector_0 = KSL_MUL(upper_0_sum, k), vector_1 = KSL_MUL(upper_1_sum, k),
      vector_2 = KSL_MUL(upper_2_sum, k);
  const double vector_0_rounded = vector_0
          + (ksl_product_error(upper_0_sum, k, vector_0)
          + (KSL_MUL(upper_0_sum_lo, k) + KSL_MUL(upper_0_sum, k_lo)));
  const double vector_1_rounded = vector_1
          + (ksl_product_error(upper_1_sum, k, vector_1)
          + (KSL_MUL(upper_1_sum_lo, k) + KSL_MUL(upper_1_sum, k_lo)));
  const double vector_2_rounded = vector_2
          + (ksl_product_error(upper_2_sum, k, vector_2)
          + (KSL_MUL(upper_2_sum_lo, k) + KSL_MUL(upper_2_sum, k_lo)));
  const double vector_0_final = vector_0_rounded == vector_0_rounded ? vector_0_rounded : vector_0;
  const double vector_1_final = vector_1_rounded == vector_1_rounded ? vector_1_rounded : vector_1;
  const double vector_2_final = vector_2_rounded == vector_2_rounded ? vector_2_rounded : vector_2;
  vo->x = vector_0_final;
  vo->y = vector_1_final;
  vo->z = vector_2_final;
}

/* R = J_l(v) = I + (1 - cos θ)/θ^2 v~ + (θ - sin θ)/θ^3 v~^2, θ = |v|.
   v: vector; R: rotation or other 3×3 matrix.
   208 mul, 471 add, 21 product error, 43 product rest, 6 div, 1 sqrt, 4 abs, 6 less, 10 equal,
     25 select.
   Error <= R: 1 u of its largest component for |v| <= 1e13, in single precision 1e5; searched,
     not proved.  Each component is within 1 ulp as long as its condition is below 1e13; in
     single precision it is the nearest number, except near ties, as long as that is below 1e5;
     searched, not proved. */
static inline void ksl_SO3_leftJacobian_accurate(const ksl_vec3_t *v, ksl_mat3x3_t *R) {
  const double halved_0 = KSL_MUL(0.5, v->x), halved_1 = KSL_MUL(0.5, v->y),
      halved_2 = KSL_MUL(0.5, v->z);
  const double y_a = KSL_MUL(halved_0, halved_0), y_b = KSL_MUL(halved_1, halved_1),
      y_c = y_a + y_b, y_c_right = y_c - y_a, y_d = KSL_MUL(halved_2, halved_2), y = y_c + y_d,
      y_right = y - y_c,
      y_c_lo = ksl_product_rest(halved_0, halved_0, y_a, y_c - y_c_right)
          + ksl_product_rest(halved_1, halved_1, y_b, y_c_right),
      y_lo = y_c - (y - y_right) + ksl_product_rest(halved_2, halved_2, y_d, y_right) + y_c_lo;
  const double y_sum = y + y_lo, y_sum_right = y_sum - y,
      y_sum_lo = y - (y_sum - y_sum_right) + (y_lo - y_sum_right), half_angle = sqrt(y_sum),
      half_angle_product = KSL_MUL(half_angle, half_angle),
      half_angle_twice = half_angle + half_angle,
      half_angle_residual = y_sum - half_angle_product
          - ksl_product_error(half_angle, half_angle, half_angle_product) + y_sum_lo,
      half_angle_lo = half_angle_residual / (half_angle == 0.0 ? 1.0 : half_angle_twice);
  const double half_angle_sum = half_angle + half_angle_lo,
      half_angle_sum_right = half_angle_sum - half_angle,
      half_angle_sum_lo = half_angle - (half_angle_sum - half_angle_sum_right)
          + (half_angle_lo - half_angle_sum_right);
  double c; const double sine = ksl_sincos(half_angle_sum, &c);
  double c_own_error; const double sine_own_error = ksl_sincos_error(half_angle_sum, sine, c,
      &c_own_error);
  const double sine_half = KSL_MUL(half_angle_sum_lo, 0.5);
  double sine_half_cos; const double sine_half_sin = ksl_sincos(sine_half, &sine_half_cos);
  const double sine_twice = sine_half_sin + sine_half_sin,
      sine_lo = sine_own_error
          + KSL_MUL(KSL_MUL(sine_half_cos, c) - KSL_MUL(sine_half_sin, sine), sine_twice);
  const double sinc_divisor = half_angle_sum < 1.4901161193847656e-08 ? 1.4901161193847656e-08
          : half_angle_sum,
      sinc_divisor_lo = half_angle_sum < 1.4901161193847656e-08 ? 0.0 : half_angle_sum_lo;
  const double sine_sum = sine + sine_lo, sine_sum_right = sine_sum - sine,
      sinc_divisor_sum = sinc_divisor + sinc_divisor_lo,
      sinc_divisor_sum_right = sinc_divisor_sum - sinc_divisor,
      sinc_quotient = sine_sum / sinc_divisor_sum,
      sinc_quotient_product = KSL_MUL(sinc_quotient, sinc_divisor_sum),
      sinc_quotient_exact = sine_sum - sinc_quotient_product
          - ksl_product_error(sinc_quotient, sinc_divisor_sum, sinc_quotient_product),
      sinc_quotient_cross = KSL_MUL(sinc_quotient, sinc_divisor
          - (sinc_divisor_sum - sinc_divisor_sum_right)
          + (sinc_divisor_lo - sinc_divisor_sum_right)),
      sinc_quotient_lo = (sinc_quotient_exact
          + (sine - (sine_sum - sine_sum_right) + (sine_lo - sine_sum_right))
          - sinc_quotient_cross) / sinc_divisor_sum;
  const double sinc_a = KSL_MUL(0.16666666666666666, y_sum), sinc_b = 1.0 - sinc_a,
      sinc_b_right = 1.0 - sinc_b,
      sinc_b_lo1 = 1.0 - (sinc_b + sinc_b_right)
          - ksl_product_rest(0.16666666666666666, y_sum, sinc_a, sinc_b_right),
      sinc_b_lo = sinc_b_lo1
          - (KSL_MUL(9.25185853854297e-18, y_sum) + KSL_MUL(0.16666666666666666, y_sum_lo)),
      sinc = half_angle_sum < 1.4901161193847656e-08 ? sinc_b : sinc_quotient,
      sinc_lo = half_angle_sum < 1.4901161193847656e-08 ? sinc_b_lo : sinc_quotient_lo;
  const double g1 = KSL_MUL(c, sinc),
      g1_cross = KSL_MUL(c_own_error
          - KSL_MUL(KSL_MUL(sine_half_cos, sine) + KSL_MUL(sine_half_sin, c), sine_twice), sinc)
          + KSL_MUL(c, sinc_lo);
  const double g2a = KSL_MUL(sinc, sinc), g2 = KSL_MUL(0.5, g2a),
      g2_cross2 = KSL_MUL(0.5, ksl_product_error(sinc, sinc, g2a)
          + (KSL_MUL(sinc_lo, sinc) + KSL_MUL(sinc, sinc_lo)));
  const double rest3 = 1.0 - g1, rest3_right = 1.0 - rest3,
      rest3_lo = 1.0 - (rest3 + rest3_right) - ksl_product_rest(c, sinc, g1, rest3_right)
          - g1_cross;
  const double x = KSL_MUL(4.0, y_sum), x_cross2 = KSL_MUL(4.0, y_sum_lo);
  const double x_sum = x + x_cross2, x_sum_right = x_sum - x,
      x_sum_lo = x - (x_sum - x_sum_right) + (x_cross2 - x_sum_right),
      far_x = x_sum < 1.0 ? 1.0 : x_sum, far_x_lo = x_sum < 1.0 ? 0.0 : x_sum_lo;
  const double rest3_sum = rest3 + rest3_lo, rest3_sum_right = rest3_sum - rest3,
      far_x_sum = far_x + far_x_lo, far_x_sum_right = far_x_sum - far_x,
      closed3 = rest3_sum / far_x_sum, closed3_product = KSL_MUL(closed3, far_x_sum),
      closed3_exact = rest3_sum - closed3_product
          - ksl_product_error(closed3, far_x_sum, closed3_product),
      closed3_numerator = closed3_exact
          + (rest3 - (rest3_sum - rest3_sum_right) + (rest3_lo - rest3_sum_right)),
      closed3_lo = (closed3_numerator
          - KSL_MUL(closed3, far_x - (far_x_sum - far_x_sum_right) + (far_x_lo - far_x_sum_right)))
          / far_x_sum;
  const double series5a = KSL_MUL(1.216125041553518e-34, x_sum),
      series5b = 1.1309962886447716e-31 - series5a,
      series5b_right = 1.1309962886447716e-31 - series5b,
      series5b_lo1 = 1.1309962886447716e-31 - (series5b + series5b_right)
          - ksl_product_rest(1.216125041553518e-34, x_sum, series5a, series5b_right),
      series5c = KSL_MUL(x_sum, series5b),
      series5b_lo = series5b_lo1
          - (KSL_MUL(5.586290567888806e-51, x_sum) + KSL_MUL(1.216125041553518e-34, x_sum_lo))
          + 1.0498015412959506e-47, series5d = series5c - 9.183689863795546e-29,
      series5d_right = series5c - series5d,
      series5d_lo1 = ksl_product_rest(x_sum, series5b, series5c, series5d + series5d_right)
          - (9.183689863795546e-29 - series5d_right), series5e = KSL_MUL(x_sum, series5d),
      series5e_cross2 = KSL_MUL(x_sum, series5d_lo1 - 1.4303150396787322e-45
          + (KSL_MUL(x_sum_lo, series5b) + KSL_MUL(x_sum, series5b_lo))),
      series5f = series5e + 6.446950284384474e-26, series5f_right = series5f - series5e,
      series5f_lo1 = ksl_product_rest(x_sum, series5d, series5e, series5f - series5f_right)
          + (6.446950284384474e-26 - series5f_right), series5g = KSL_MUL(x_sum, series5f),
      series5g_cross2 = KSL_MUL(x_sum, series5f_lo1 + -1.9330404233703465e-42
          + (KSL_MUL(x_sum_lo, series5d) + series5e_cross2)),
      series5h = series5g - 3.868170170630684e-23, series5h_right = series5g - series5h,
      series5h_lo1 = ksl_product_rest(x_sum, series5f, series5g, series5h + series5h_right)
          - (3.868170170630684e-23 - series5h_right), series5i = KSL_MUL(x_sum, series5h),
      series5j = series5i + 1.9572941063391263e-20, series5j_right = series5j - series5i,
      series5j_lo1 = ksl_product_rest(x_sum, series5h, series5i, series5j - series5j_right)
          + (1.9572941063391263e-20 - series5j_right),
      series5i_cross = KSL_MUL(x_sum_lo, series5h)
          + KSL_MUL(x_sum, series5h_lo1 - -8.843177655482344e-40
          + (KSL_MUL(x_sum_lo, series5f) + series5g_cross2)), series5k = KSL_MUL(x_sum, series5j),
      series5l = series5k - 8.22063524662433e-18, series5l_right = series5k - series5l,
      series5l_lo1 = ksl_product_rest(x_sum, series5j, series5k, series5l + series5l_right)
          - (8.22063524662433e-18 - series5l_right),
      series5k_cross = KSL_MUL(x_sum_lo, series5j)
          + KSL_MUL(x_sum, series5j_lo1 + -1.3643503830087908e-36 + series5i_cross),
      series5m = KSL_MUL(x_sum, series5l), series5n = series5m + 2.8114572543455206e-15,
      series5n_right = series5n - series5m,
      series5n_lo1 = ksl_product_rest(x_sum, series5l, series5m, series5n - series5n_right)
          + (2.8114572543455206e-15 - series5n_right),
      series5m_cross = KSL_MUL(x_sum_lo, series5l)
          + KSL_MUL(x_sum, series5l_lo1 - 2.2141894119604265e-34 + series5k_cross),
      series5o = KSL_MUL(x_sum, series5n), series5p = series5o - 7.647163731819816e-13,
      series5p_right = series5o - series5p,
      series5p_lo1 = ksl_product_rest(x_sum, series5n, series5o, series5p + series5p_right)
          - (7.647163731819816e-13 - series5p_right),
      series5o_cross = KSL_MUL(x_sum_lo, series5n)
          + KSL_MUL(x_sum, series5n_lo1 + 1.6508842730861433e-31 + series5m_cross),
      series5q = KSL_MUL(x_sum, series5p), series5r = series5q + 1.6059043836821613e-10,
      series5r_right = series5r - series5q,
      series5r_lo1 = ksl_product_rest(x_sum, series5p, series5q, series5r - series5r_right)
          + (1.6059043836821613e-10 - series5r_right),
      series5q_cross = KSL_MUL(x_sum_lo, series5p)
          + KSL_MUL(x_sum, series5p_lo1 - 7.03872877733453e-30 + series5o_cross),
      series5s = KSL_MUL(x_sum, series5r), series5t = series5s - 2.505210838544172e-08,
      series5t_right = series5s - series5t,
      series5t_lo1 = ksl_product_rest(x_sum, series5r, series5s, series5t + series5t_right)
          - (2.505210838544172e-08 - series5t_right),
      series5s_cross = KSL_MUL(x_sum_lo, series5r)
          + KSL_MUL(x_sum, series5r_lo1 + 1.2585294588752098e-26 + series5q_cross),
      series5u = KSL_MUL(x_sum, series5t), series5v = series5u + 2.7557319223985893e-06,
      series5v_right = series5v - series5u,
      series5v_lo1 = ksl_product_rest(x_sum, series5t, series5u, series5v - series5v_right)
          + (2.7557319223985893e-06 - series5v_right),
      series5u_cross = KSL_MUL(x_sum_lo, series5t)
          + KSL_MUL(x_sum, series5t_lo1 - -1.448814070935912e-24 + series5s_cross),
      series5w = KSL_MUL(x_sum, series5v), series5x = series5w - 0.0001984126984126984,
      series5x_right = series5w - series5x,
      series5x_lo1 = ksl_product_rest(x_sum, series5v, series5w, series5x + series5x_right)
          - (0.0001984126984126984 - series5x_right),
      series5w_cross = KSL_MUL(x_sum_lo, series5v)
          + KSL_MUL(x_sum, series5v_lo1 + -1.858393274046472e-22 + series5u_cross),
      series5y = KSL_MUL(x_sum, series5x), series5 = series5y + 0.008333333333333333,
      series5_right = series5 - series5y,
      series5_lo2 = ksl_product_rest(x_sum, series5x, series5y, series5 - series5_right)
          + (0.008333333333333333 - series5_right) + 1.1564823173178714e-19;
  const double g3a = KSL_MUL(x_sum, series5),
      g3a_cross2 = KSL_MUL(x_sum, series5_lo2
          + (KSL_MUL(x_sum_lo, series5x)
          + KSL_MUL(x_sum, series5x_lo1 - 1.7209558293420705e-22 + series5w_cross))),
      g3b = 0.16666666666666666 - g3a, g3b_right = 0.16666666666666666 - g3b,
      g3b_lo2 = 0.16666666666666666 - (g3b + g3b_right)
          - ksl_product_rest(x_sum, series5, g3a, g3b_right)
          - (KSL_MUL(x_sum_lo, series5) + g3a_cross2), g3b_lo = g3b_lo2 + 9.25185853854297e-18,
      g3 = x_sum < 1.0 ? g3b : closed3, g3_lo = x_sum < 1.0 ? g3b_lo : closed3_lo;
  const double beta_v_0 = KSL_MUL(v->x, g3), beta_v_1 = KSL_MUL(v->y, g3),
      beta_v_2 = KSL_MUL(v->z, g3);
  const double beta_v_0_lo = ksl_product_error(v->x, g3, beta_v_0) + KSL_MUL(v->x, g3_lo),
      m_0 = KSL_MUL(v->x, beta_v_0), m_0_cross2 = KSL_MUL(v->x, beta_v_0_lo);
  const double beta_v_1_lo = ksl_product_error(v->y, g3, beta_v_1) + KSL_MUL(v->y, g3_lo),
      m_1 = KSL_MUL(v->y, beta_v_1), m_1_cross2 = KSL_MUL(v->y, beta_v_1_lo);
  const double m_2 = KSL_MUL(v->z, beta_v_2),
      m_2_cross2 = KSL_MUL(v->z, ksl_product_error(v->z, g3, beta_v_2) + KSL_MUL(v->z, g3_lo));
  const double m_3 = KSL_MUL(v->y, beta_v_0), m_3_cross2 = KSL_MUL(v->y, beta_v_0_lo);
  const double m_4 = KSL_MUL(v->z, beta_v_0), m_4_cross2 = KSL_MUL(v->z, beta_v_0_lo);
  const double m_5 = KSL_MUL(v->z, beta_v_1), m_5_cross2 = KSL_MUL(v->z, beta_v_1_lo);
  const double others_0 = m_1 + m_2, others_0_right = others_0 - m_1,
      others_0_lo1 = ksl_product_rest(v->y, beta_v_1, m_1, others_0 - others_0_right)
          + ksl_product_rest(v->z, beta_v_2, m_2, others_0_right),
      others_0_lo = others_0_lo1 + (m_1_cross2 + m_2_cross2);
  const double others_1 = m_0 + m_2, others_1_right = others_1 - m_0,
      others_1_lo1 = ksl_product_rest(v->x, beta_v_0, m_0, others_1 - others_1_right)
          + ksl_product_rest(v->z, beta_v_2, m_2, others_1_right),
      others_1_lo = others_1_lo1 + (m_0_cross2 + m_2_cross2);
  const double others_2 = m_0 + m_1, others_2_right = others_2 - m_0,
      others_2_lo1 = ksl_product_rest(v->x, beta_v_0, m_0, others_2 - others_2_right)
          + ksl_product_rest(v->y, beta_v_1, m_1, others_2_right),
      others_2_lo = others_2_lo1 + (m_0_cross2 + m_1_cross2);
  const double diagonal0a = 1.0 - others_0, diagonal0a_right = 1.0 - diagonal0a,
      diagonal0a_lo = 1.0 - (diagonal0a + diagonal0a_right) - (others_0 - diagonal0a_right)
          - others_0_lo, diagonal0b = g1 + m_0, diagonal0b_right = diagonal0b - g1,
      diagonal0b_lo1 = ksl_product_rest(c, sinc, g1, diagonal0b - diagonal0b_right)
          + ksl_product_rest(v->x, beta_v_0, m_0, diagonal0b_right),
      diagonal0b_lo = diagonal0b_lo1 + (g1_cross + m_0_cross2),
      m_0_sum = m_0 + (ksl_product_error(v->x, beta_v_0, m_0) + m_0_cross2),
      others_0_sum = others_0 + others_0_lo,
      diagonal0 = m_0_sum < others_0_sum ? diagonal0b : diagonal0a;
  const double diagonal1a = 1.0 - others_1, diagonal1a_right = 1.0 - diagonal1a,
      diagonal1a_lo = 1.0 - (diagonal1a + diagonal1a_right) - (others_1 - diagonal1a_right)
          - others_1_lo, diagonal1b = g1 + m_1, diagonal1b_right = diagonal1b - g1,
      diagonal1b_lo1 = ksl_product_rest(c, sinc, g1, diagonal1b - diagonal1b_right)
          + ksl_product_rest(v->y, beta_v_1, m_1, diagonal1b_right),
      diagonal1b_lo = diagonal1b_lo1 + (g1_cross + m_1_cross2),
      m_1_sum = m_1 + (ksl_product_error(v->y, beta_v_1, m_1) + m_1_cross2),
      others_1_sum = others_1 + others_1_lo,
      diagonal1 = m_1_sum < others_1_sum ? diagonal1b : diagonal1a;
  const double diagonal2a = 1.0 - others_2, diagonal2a_right = 1.0 - diagonal2a,
      diagonal2a_lo = 1.0 - (diagonal2a + diagonal2a_right) - (others_2 - diagonal2a_right)
          - others_2_lo, diagonal2b = g1 + m_2, diagonal2b_right = diagonal2b - g1,
      diagonal2b_lo1 = ksl_product_rest(c, sinc, g1, diagonal2b - diagonal2b_right)
          + ksl_product_rest(v->z, beta_v_2, m_2, diagonal2b_right),
      diagonal2b_lo = diagonal2b_lo1 + (g1_cross + m_2_cross2),
      m_2_sum = m_2 + (ksl_product_error(v->z, beta_v_2, m_2) + m_2_cross2),
      others_2_sum = others_2 + others_2_lo,
      diagonal2 = m_2_sum < others_2_sum ? diagonal2b : diagonal2a;
  const double alpha_v_0 = KSL_MUL(v->x, g2), alpha_v_0_cross2 = KSL_MUL(v->x, g2_cross2);
  const double alpha_v_1 = KSL_MUL(v->y, g2), alpha_v_1_cross2 = KSL_MUL(v->y, g2_cross2);
  const double alpha_v_2 = KSL_MUL(v->z, g2), alpha_v_2_cross2 = KSL_MUL(v->z, g2_cross2);
  const double R_01 = m_3 - alpha_v_2, R_01_right = m_3 - R_01,
      R_01_lo1 = ksl_product_rest(v->y, beta_v_0, m_3, R_01 + R_01_right)
          - ksl_product_rest(v->z, g2, alpha_v_2, R_01_right);
  const double R_02 = m_4 + alpha_v_1, R_02_right = R_02 - m_4,
      R_02_lo1 = ksl_product_rest(v->z, beta_v_0, m_4, R_02 - R_02_right)
          + ksl_product_rest(v->y, g2, alpha_v_1, R_02_right);
  const double R_10 = m_3 + alpha_v_2, R_10_right = R_10 - m_3,
      R_10_lo1 = ksl_product_rest(v->y, beta_v_0, m_3, R_10 - R_10_right)
          + ksl_product_rest(v->z, g2, alpha_v_2, R_10_right);
  const double R_12 = m_5 - alpha_v_0, R_12_right = m_5 - R_12,
      R_12_lo1 = ksl_product_rest(v->z, beta_v_1, m_5, R_12 + R_12_right)
          - ksl_product_rest(v->x, g2, alpha_v_0, R_12_right);
  const double R_20 = m_4 - alpha_v_1, R_20_right = m_4 - R_20,
      R_20_lo1 = ksl_product_rest(v->z, beta_v_0, m_4, R_20 + R_20_right)
          - ksl_product_rest(v->y, g2, alpha_v_1, R_20_right);
  const double R_21 = m_5 + alpha_v_0, R_21_right = R_21 - m_5,
      R_21_lo1 = ksl_product_rest(v->z, beta_v_1, m_5, R_21 - R_21_right)
          + ksl_product_rest(v->x, g2, alpha_v_0, R_21_right);
  const double diagonal0_rounded = diagonal0
          + (m_0_sum < others_0_sum ? diagonal0b_lo : diagonal0a_lo);
  const double R_01_rounded = R_01 + (R_01_lo1 + (m_3_cross2 - alpha_v_2_cross2));
  const double R_02_rounded = R_02 + (R_02_lo1 + (m_4_cross2 + alpha_v_1_cross2));
  const double R_10_rounded = R_10 + (R_10_lo1 + (m_3_cross2 + alpha_v_2_cross2));
  const double diagonal1_rounded = diagonal1
          + (m_1_sum < others_1_sum ? diagonal1b_lo : diagonal1a_lo);
  const double R_12_rounded = R_12 + (R_12_lo1 + (m_5_cross2 - alpha_v_0_cross2));
  const double R_20_rounded = R_20 + (R_20_lo1 + (m_4_cross2 - alpha_v_1_cross2));
  const double R_21_rounded = R_21 + (R_21_lo1 + (m_5_cross2 + alpha_v_0_cross2));
  const double diagonal2_rounded = diagonal2
          + (m_2_sum < others_2_sum ? diagonal2b_lo : diagonal2a_lo);
  const double diagonal0_final = diagonal0_rounded == diagonal0_rounded ? diagonal0_rounded
          : diagonal0;
  const double R_01_final = R_01_rounded == R_01_rounded ? R_01_rounded : R_01;
  const double R_02_final = R_02_rounded == R_02_rounded ? R_02_rounded : R_02;
  const double R_10_final = R_10_rounded == R_10_rounded ? R_10_rounded : R_10;
  const double diagonal1_final = diagonal1_rounded == diagonal1_rounded ? diagonal1_rounded
          : diagonal1;
  const double R_12_final = R_12_rounded == R_12_rounded ? R_12_rounded : R_12;
  const double R_20_final = R_20_rounded == R_20_rounded ? R_20_rounded : R_20;
  const double R_21_final = R_21_rounded == R_21_rounded ? R_21_rounded : R_21;
  const double diagonal2_final = diagonal2_rounded == diagonal2_rounded ? diagonal2_rounded
          : diagonal2;
  R->m00 = diagonal0_final;
  R->m01 = R_01_final;
  R->m02 = R_02_final;
  R->m10 = R_10_final;
  R->m11 = diagonal1_final;
  R->m12 = R_12_final;
  R->m20 = R_20_final;
  R->m21 = R_21_final;
  R->m22 = diagonal2_final;
}

/* R = J_r(v) = I - (1 - cos θ)/θ^2 v~ + (θ - sin θ)/θ^3 v~^2, θ = |v|.
   v: vector; R: rotation or other 3×3 matrix.
   208 mul, 471 add, 21 product error, 43 product rest, 6 div, 1 sqrt, 9 neg, 4 abs, 6 less, 10
     equal, 25 select.
   Error <= R: 1 u of its largest component for |v| <= 1e13, in single precision 1e5; searched,
     not proved.  Each component is within 1 ulp as long as its condition is below 1e13; in
     single precision it is the nearest number, except near ties, as long as that is below 1e5;
     searched, not proved. */
static inline void ksl_SO3_rightJacobian_accurate(const ksl_vec3_t *v, ksl_mat3x3_t *R) {
  const double halved_0 = KSL_MUL(0.5, v->x), halved_1 = KSL_MUL(0.5, v->y),
      halved_2 = KSL_MUL(0.5, v->z);
  const double y_a = KSL_MUL(halved_0, halved_0), y_b = KSL_MUL(halved_1, halved_1),
      y_c = y_a + y_b, y_c_right = y_c - y_a, y_d = KSL_MUL(halved_2, halved_2), y = y_c + y_d,
      y_right = y - y_c,
      y_c_lo = ksl_product_rest(halved_0, halved_0, y_a, y_c - y_c_right)
          + ksl_product_rest(halved_1, halved_1, y_b, y_c_right),
      y_lo = y_c - (y - y_right) + ksl_product_rest(halved_2, halved_2, y_d, y_right) + y_c_lo;
  const double y_sum = y + y_lo, y_sum_right = y_sum - y,
      y_sum_lo = y - (y_sum - y_sum_right) + (y_lo - y_sum_right), half_angle = sqrt(y_sum),
      half_angle_product = KSL_MUL(half_angle, half_angle),
      half_angle_twice = half_angle + half_angle,
      half_angle_residual = y_sum - half_angle_product
          - ksl_product_error(half_angle, half_angle, half_angle_product) + y_sum_lo,
      half_angle_lo = half_angle_residual / (half_angle == 0.0 ? 1.0 : half_angle_twice);
  const double half_angle_sum = half_angle + half_angle_lo,
      half_angle_sum_right = half_angle_sum - half_angle,
      half_angle_sum_lo = half_angle - (half_angle_sum - half_angle_sum_right)
          + (half_angle_lo - half_angle_sum_right);
  double c; const double sine = ksl_sincos(half_angle_sum, &c);
  double c_own_error; const double sine_own_error = ksl_sincos_error(half_angle_sum, sine, c,
      &c_own_error);
  const double sine_half = KSL_MUL(half_angle_sum_lo, 0.5);
  double sine_half_cos; const double sine_half_sin = ksl_sincos(sine_half, &sine_half_cos);
  const double sine_twice = sine_half_sin + sine_half_sin,
      sine_lo = sine_own_error
          + KSL_MUL(KSL_MUL(sine_half_cos, c) - KSL_MUL(sine_half_sin, sine), sine_twice);
  const double sinc_divisor = half_angle_sum < 1.4901161193847656e-08 ? 1.4901161193847656e-08
          : half_angle_sum,
      sinc_divisor_lo = half_angle_sum < 1.4901161193847656e-08 ? 0.0 : half_angle_sum_lo;
  const double sine_sum = sine + sine_lo, sine_sum_right = sine_sum - sine,
      sinc_divisor_sum = sinc_divisor + sinc_divisor_lo,
      sinc_divisor_sum_right = sinc_divisor_sum - sinc_divisor,
      sinc_quotient = sine_sum / sinc_divisor_sum,
      sinc_quotient_product = KSL_MUL(sinc_quotient, sinc_divisor_sum),
      sinc_quotient_exact = sine_sum - sinc_quotient_product
          - ksl_product_error(sinc_quotient, sinc_divisor_sum, sinc_quotient_product),
      sinc_quotient_cross = KSL_MUL(sinc_quotient, sinc_divisor
          - (sinc_divisor_sum - sinc_divisor_sum_right)
          + (sinc_divisor_lo - sinc_divisor_sum_right)),
      sinc_quotient_lo = (sinc_quotient_exact
          + (sine - (sine_sum - sine_sum_right) + (sine_lo - sine_sum_right))
          - sinc_quotient_cross) / sinc_divisor_sum;
  const double sinc_a = KSL_MUL(0.16666666666666666, y_sum), sinc_b = 1.0 - sinc_a,
      sinc_b_right = 1.0 - sinc_b,
      sinc_b_lo1 = 1.0 - (sinc_b + sinc_b_right)
          - ksl_product_rest(0.16666666666666666, y_sum, sinc_a, sinc_b_right),
      sinc_b_lo = sinc_b_lo1
          - (KSL_MUL(9.25185853854297e-18, y_sum) + KSL_MUL(0.16666666666666666, y_sum_lo)),
      sinc = half_angle_sum < 1.4901161193847656e-08 ? sinc_b : sinc_quotient,
      sinc_lo = half_angle_sum < 1.4901161193847656e-08 ? sinc_b_lo : sinc_quotient_lo;
  const double g1 = KSL_MUL(c, sinc),
      g1_cross = KSL_MUL(c_own_error
          - KSL_MUL(KSL_MUL(sine_half_cos, sine) + KSL_MUL(sine_half_sin, c), sine_twice), sinc)
          + KSL_MUL(c, sinc_lo);
  const double g2a = KSL_MUL(sinc, sinc), g2 = KSL_MUL(0.5, g2a),
      g2_cross2 = KSL_MUL(0.5, ksl_product_error(sinc, sinc, g2a)
          + (KSL_MUL(sinc_lo, sinc) + KSL_MUL(sinc, sinc_lo)));
  const double rest3 = 1.0 - g1, rest3_right = 1.0 - rest3,
      rest3_lo = 1.0 - (rest3 + rest3_right) - ksl_product_rest(c, sinc, g1, rest3_right)
          - g1_cross;
  const double x = KSL_MUL(4.0, y_sum), x_cross2 = KSL_MUL(4.0, y_sum_lo);
  const double x_sum = x + x_cross2, x_sum_right = x_sum - x,
      x_sum_lo = x - (x_sum - x_sum_right) + (x_cross2 - x_sum_right),
      far_x = x_sum < 1.0 ? 1.0 : x_sum, far_x_lo = x_sum < 1.0 ? 0.0 : x_sum_lo;
  const double rest3_sum = rest3 + rest3_lo, rest3_sum_right = rest3_sum - rest3,
      far_x_sum = far_x + far_x_lo, far_x_sum_right = far_x_sum - far_x,
      closed3 = rest3_sum / far_x_sum, closed3_product = KSL_MUL(closed3, far_x_sum),
      closed3_exact = rest3_sum - closed3_product
          - ksl_product_error(closed3, far_x_sum, closed3_product),
      closed3_numerator = closed3_exact
          + (rest3 - (rest3_sum - rest3_sum_right) + (rest3_lo - rest3_sum_right)),
      closed3_lo = (closed3_numerator
          - KSL_MUL(closed3, far_x - (far_x_sum - far_x_sum_right) + (far_x_lo - far_x_sum_right)))
          / far_x_sum;
  const double series5a = KSL_MUL(1.216125041553518e-34, x_sum),
      series5b = 1.1309962886447716e-31 - series5a,
      series5b_right = 1.1309962886447716e-31 - series5b,
      series5b_lo1 = 1.1309962886447716e-31 - (series5b + series5b_right)
          - ksl_product_rest(1.216125041553518e-34, x_sum, series5a, series5b_right),
      series5c = KSL_MUL(x_sum, series5b),
      series5b_lo = series5b_lo1
          - (KSL_MUL(5.586290567888806e-51, x_sum) + KSL_MUL(1.216125041553518e-34, x_sum_lo))
          + 1.0498015412959506e-47, series5d = series5c - 9.183689863795546e-29,
      series5d_right = series5c - series5d,
      series5d_lo1 = ksl_product_rest(x_sum, series5b, series5c, series5d + series5d_right)
          - (9.183689863795546e-29 - series5d_right), series5e = KSL_MUL(x_sum, series5d),
      series5e_cross2 = KSL_MUL(x_sum, series5d_lo1 - 1.4303150396787322e-45
          + (KSL_MUL(x_sum_lo, series5b) + KSL_MUL(x_sum, series5b_lo))),
      series5f = series5e + 6.446950284384474e-26, series5f_right = series5f - series5e,
      series5f_lo1 = ksl_product_rest(x_sum, series5d, series5e, series5f - series5f_right)
          + (6.446950284384474e-26 - series5f_right), series5g = KSL_MUL(x_sum, series5f),
      series5g_cross2 = KSL_MUL(x_sum, series5f_lo1 + -1.9330404233703465e-42
          + (KSL_MUL(x_sum_lo, series5d) + series5e_cross2)),
      series5h = series5g - 3.868170170630684e-23, series5h_right = series5g - series5h,
      series5h_lo1 = ksl_product_rest(x_sum, series5f, series5g, series5h + series5h_right)
          - (3.868170170630684e-23 - series5h_right), series5i = KSL_MUL(x_sum, series5h),
      series5j = series5i + 1.9572941063391263e-20, series5j_right = series5j - series5i,
      series5j_lo1 = ksl_product_rest(x_sum, series5h, series5i, series5j - series5j_right)
          + (1.9572941063391263e-20 - series5j_right),
      series5i_cross = KSL_MUL(x_sum_lo, series5h)
          + KSL_MUL(x_sum, series5h_lo1 - -8.843177655482344e-40
          + (KSL_MUL(x_sum_lo, series5f) + series5g_cross2)), series5k = KSL_MUL(x_sum, series5j),
      series5l = series5k - 8.22063524662433e-18, series5l_right = series5k - series5l,
      series5l_lo1 = ksl_product_rest(x_sum, series5j, series5k, series5l + series5l_right)
          - (8.22063524662433e-18 - series5l_right),
      series5k_cross = KSL_MUL(x_sum_lo, series5j)
          + KSL_MUL(x_sum, series5j_lo1 + -1.3643503830087908e-36 + series5i_cross),
      series5m = KSL_MUL(x_sum, series5l), series5n = series5m + 2.8114572543455206e-15,
      series5n_right = series5n - series5m,
      series5n_lo1 = ksl_product_rest(x_sum, series5l, series5m, series5n - series5n_right)
          + (2.8114572543455206e-15 - series5n_right),
      series5m_cross = KSL_MUL(x_sum_lo, series5l)
          + KSL_MUL(x_sum, series5l_lo1 - 2.2141894119604265e-34 + series5k_cross),
      series5o = KSL_MUL(x_sum, series5n), series5p = series5o - 7.647163731819816e-13,
      series5p_right = series5o - series5p,
      series5p_lo1 = ksl_product_rest(x_sum, series5n, series5o, series5p + series5p_right)
          - (7.647163731819816e-13 - series5p_right),
      series5o_cross = KSL_MUL(x_sum_lo, series5n)
          + KSL_MUL(x_sum, series5n_lo1 + 1.6508842730861433e-31 + series5m_cross),
      series5q = KSL_MUL(x_sum, series5p), series5r = series5q + 1.6059043836821613e-10,
      series5r_right = series5r - series5q,
      series5r_lo1 = ksl_product_rest(x_sum, series5p, series5q, series5r - series5r_right)
          + (1.6059043836821613e-10 - series5r_right),
      series5q_cross = KSL_MUL(x_sum_lo, series5p)
          + KSL_MUL(x_sum, series5p_lo1 - 7.03872877733453e-30 + series5o_cross),
      series5s = KSL_MUL(x_sum, series5r), series5t = series5s - 2.505210838544172e-08,
      series5t_right = series5s - series5t,
      series5t_lo1 = ksl_product_rest(x_sum, series5r, series5s, series5t + series5t_right)
          - (2.505210838544172e-08 - series5t_right),
      series5s_cross = KSL_MUL(x_sum_lo, series5r)
          + KSL_MUL(x_sum, series5r_lo1 + 1.2585294588752098e-26 + series5q_cross),
      series5u = KSL_MUL(x_sum, series5t), series5v = series5u + 2.7557319223985893e-06,
      series5v_right = series5v - series5u,
      series5v_lo1 = ksl_product_rest(x_sum, series5t, series5u, series5v - series5v_right)
          + (2.7557319223985893e-06 - series5v_right),
      series5u_cross = KSL_MUL(x_sum_lo, series5t)
          + KSL_MUL(x_sum, series5t_lo1 - -1.448814070935912e-24 + series5s_cross),
      series5w = KSL_MUL(x_sum, series5v), series5x = series5w - 0.0001984126984126984,
      series5x_right = series5w - series5x,
      series5x_lo1 = ksl_product_rest(x_sum, series5v, series5w, series5x + series5x_right)
          - (0.0001984126984126984 - series5x_right),
      series5w_cross = KSL_MUL(x_sum_lo, series5v)
          + KSL_MUL(x_sum, series5v_lo1 + -1.858393274046472e-22 + series5u_cross),
      series5y = KSL_MUL(x_sum, series5x), series5 = series5y + 0.008333333333333333,
      series5_right = series5 - series5y,
      series5_lo2 = ksl_product_rest(x_sum, series5x, series5y, series5 - series5_right)
          + (0.008333333333333333 - series5_right) + 1.1564823173178714e-19;
  const double g3a = KSL_MUL(x_sum, series5),
      g3a_cross2 = KSL_MUL(x_sum, series5_lo2
          + (KSL_MUL(x_sum_lo, series5x)
          + KSL_MUL(x_sum, series5x_lo1 - 1.7209558293420705e-22 + series5w_cross))),
      g3b = 0.16666666666666666 - g3a, g3b_right = 0.16666666666666666 - g3b,
      g3b_lo2 = 0.16666666666666666 - (g3b + g3b_right)
          - ksl_product_rest(x_sum, series5, g3a, g3b_right)
          - (KSL_MUL(x_sum_lo, series5) + g3a_cross2), g3b_lo = g3b_lo2 + 9.25185853854297e-18,
      g3 = x_sum < 1.0 ? g3b : closed3, g3_lo = x_sum < 1.0 ? g3b_lo : closed3_lo;
  const double beta_v_0 = KSL_MUL(v->x, g3), beta_v_1 = KSL_MUL(v->y, g3),
      beta_v_2 = KSL_MUL(v->z, g3);
  const double beta_v_0_lo = ksl_product_error(v->x, g3, beta_v_0) + KSL_MUL(v->x, g3_lo),
      m_0 = KSL_MUL(v->x, beta_v_0), m_0_cross2 = KSL_MUL(v->x, beta_v_0_lo);
  const double beta_v_1_lo = ksl_product_error(v->y, g3, beta_v_1) + KSL_MUL(v->y, g3_lo),
      m_1 = KSL_MUL(v->y, beta_v_1), m_1_cross2 = KSL_MUL(v->y, beta_v_1_lo);
  const double m_2 = KSL_MUL(v->z, beta_v_2),
      m_2_cross2 = KSL_MUL(v->z, ksl_product_error(v->z, g3, beta_v_2) + KSL_MUL(v->z, g3_lo));
  const double m_3 = KSL_MUL(v->y, beta_v_0), m_3_cross2 = KSL_MUL(v->y, beta_v_0_lo);
  const double m_4 = KSL_MUL(v->z, beta_v_0), m_4_cross2 = KSL_MUL(v->z, beta_v_0_lo);
  const double m_5 = KSL_MUL(v->z, beta_v_1), m_5_cross2 = KSL_MUL(v->z, beta_v_1_lo);
  const double others_0 = m_1 + m_2, others_0_right = others_0 - m_1,
      others_0_lo1 = ksl_product_rest(v->y, beta_v_1, m_1, others_0 - others_0_right)
          + ksl_product_rest(v->z, beta_v_2, m_2, others_0_right),
      others_0_lo = others_0_lo1 + (m_1_cross2 + m_2_cross2);
  const double others_1 = m_0 + m_2, others_1_right = others_1 - m_0,
      others_1_lo1 = ksl_product_rest(v->x, beta_v_0, m_0, others_1 - others_1_right)
          + ksl_product_rest(v->z, beta_v_2, m_2, others_1_right),
      others_1_lo = others_1_lo1 + (m_0_cross2 + m_2_cross2);
  const double others_2 = m_0 + m_1, others_2_right = others_2 - m_0,
      others_2_lo1 = ksl_product_rest(v->x, beta_v_0, m_0, others_2 - others_2_right)
          + ksl_product_rest(v->y, beta_v_1, m_1, others_2_right),
      others_2_lo = others_2_lo1 + (m_0_cross2 + m_1_cross2);
  const double diagonal0a = 1.0 - others_0, diagonal0a_right = 1.0 - diagonal0a,
      diagonal0a_lo = 1.0 - (diagonal0a + diagonal0a_right) - (others_0 - diagonal0a_right)
          - others_0_lo, diagonal0b = g1 + m_0, diagonal0b_right = diagonal0b - g1,
      diagonal0b_lo1 = ksl_product_rest(c, sinc, g1, diagonal0b - diagonal0b_right)
          + ksl_product_rest(v->x, beta_v_0, m_0, diagonal0b_right),
      diagonal0b_lo = diagonal0b_lo1 + (g1_cross + m_0_cross2),
      m_0_sum = m_0 + (ksl_product_error(v->x, beta_v_0, m_0) + m_0_cross2),
      others_0_sum = others_0 + others_0_lo,
      diagonal0 = m_0_sum < others_0_sum ? diagonal0b : diagonal0a;
  const double diagonal1a = 1.0 - others_1, diagonal1a_right = 1.0 - diagonal1a,
      diagonal1a_lo = 1.0 - (diagonal1a + diagonal1a_right) - (others_1 - diagonal1a_right)
          - others_1_lo, diagonal1b = g1 + m_1, diagonal1b_right = diagonal1b - g1,
      diagonal1b_lo1 = ksl_product_rest(c, sinc, g1, diagonal1b - diagonal1b_right)
          + ksl_product_rest(v->y, beta_v_1, m_1, diagonal1b_right),
      diagonal1b_lo = diagonal1b_lo1 + (g1_cross + m_1_cross2),
      m_1_sum = m_1 + (ksl_product_error(v->y, beta_v_1, m_1) + m_1_cross2),
      others_1_sum = others_1 + others_1_lo,
      diagonal1 = m_1_sum < others_1_sum ? diagonal1b : diagonal1a;
  const double diagonal2a = 1.0 - others_2, diagonal2a_right = 1.0 - diagonal2a,
      diagonal2a_lo = 1.0 - (diagonal2a + diagonal2a_right) - (others_2 - diagonal2a_right)
          - others_2_lo, diagonal2b = g1 + m_2, diagonal2b_right = diagonal2b - g1,
      diagonal2b_lo1 = ksl_product_rest(c, sinc, g1, diagonal2b - diagonal2b_right)
          + ksl_product_rest(v->z, beta_v_2, m_2, diagonal2b_right),
      diagonal2b_lo = diagonal2b_lo1 + (g1_cross + m_2_cross2),
      m_2_sum = m_2 + (ksl_product_error(v->z, beta_v_2, m_2) + m_2_cross2),
      others_2_sum = others_2 + others_2_lo,
      diagonal2 = m_2_sum < others_2_sum ? diagonal2b : diagonal2a;
  const double alpha_v_0 = -KSL_MUL(v->x, g2), alpha_v_0_cross = -KSL_MUL(v->x, g2_cross2),
      alpha_v_0_factor = -v->x;
  const double alpha_v_1 = -KSL_MUL(v->y, g2), alpha_v_1_cross = -KSL_MUL(v->y, g2_cross2),
      alpha_v_1_factor = -v->y;
  const double alpha_v_2 = -KSL_MUL(v->z, g2), alpha_v_2_cross = -KSL_MUL(v->z, g2_cross2),
      alpha_v_2_factor = -v->z;
  const double R_01 = m_3 - alpha_v_2, R_01_right = m_3 - R_01,
      R_01_lo1 = ksl_product_rest(v->y, beta_v_0, m_3, R_01 + R_01_right)
          - ksl_product_rest(alpha_v_2_factor, g2, alpha_v_2, R_01_right);
  const double R_02 = m_4 + alpha_v_1, R_02_right = R_02 - m_4,
      R_02_lo1 = ksl_product_rest(v->z, beta_v_0, m_4, R_02 - R_02_right)
          + ksl_product_rest(alpha_v_1_factor, g2, alpha_v_1, R_02_right);
  const double R_10 = m_3 + alpha_v_2, R_10_right = R_10 - m_3,
      R_10_lo1 = ksl_product_rest(v->y, beta_v_0, m_3, R_10 - R_10_right)
          + ksl_product_rest(alpha_v_2_factor, g2, alpha_v_2, R_10_right);
  const double R_12 = m_5 - alpha_v_0, R_12_right = m_5 - R_12,
      R_12_lo1 = ksl_product_rest(v->z, beta_v_1, m_5, R_12 + R_12_right)
          - ksl_product_rest(alpha_v_0_factor, g2, alpha_v_0, R_12_right);
  const double R_20 = m_4 - alpha_v_1, R_20_right = m_4 - R_20,
      R_20_lo1 = ksl_product_rest(v->z, beta_v_0, m_4, R_20 + R_20_right)
          - ksl_product_rest(alpha_v_1_factor, g2, alpha_v_1, R_20_right);
  const double R_21 = m_5 + alpha_v_0, R_21_right = R_21 - m_5,
      R_21_lo1 = ksl_product_rest(v->z, beta_v_1, m_5, R_21 - R_21_right)
          + ksl_product_rest(alpha_v_0_factor, g2, alpha_v_0, R_21_right);
  const double diagonal0_rounded = diagonal0
          + (m_0_sum < others_0_sum ? diagonal0b_lo : diagonal0a_lo);
  const double R_01_rounded = R_01 + (R_01_lo1 + (m_3_cross2 - alpha_v_2_cross));
  const double R_02_rounded = R_02 + (R_02_lo1 + (m_4_cross2 + alpha_v_1_cross));
  const double R_10_rounded = R_10 + (R_10_lo1 + (m_3_cross2 + alpha_v_2_cross));
  const double diagonal1_rounded = diagonal1
          + (m_1_sum < others_1_sum ? diagonal1b_lo : diagonal1a_lo);
  const double R_12_rounded = R_12 + (R_12_lo1 + (m_5_cross2 - alpha_v_0_cross));
  const double R_20_rounded = R_20 + (R_20_lo1 + (m_4_cross2 - alpha_v_1_cross));
  const double R_21_rounded = R_21 + (R_21_lo1 + (m_5_cross2 + alpha_v_0_cross));
  const double diagonal2_rounded = diagonal2
          + (m_2_sum < others_2_sum ? diagonal2b_lo : diagonal2a_lo);
  const double diagonal0_final = diagonal0_rounded == diagonal0_rounded ? diagonal0_rounded
          : diagonal0;
  const double R_01_final = R_01_rounded == R_01_rounded ? R_01_rounded : R_01;
  const double R_02_final = R_02_rounded == R_02_rounded ? R_02_rounded : R_02;
  const double R_10_final = R_10_rounded == R_10_rounded ? R_10_rounded : R_10;
  const double diagonal1_final = diagonal1_rounded == diagonal1_rounded ? diagonal1_rounded
          : diagonal1;
  const double R_12_final = R_12_rounded == R_12_rounded ? R_12_rounded : R_12;
  const double R_20_final = R_20_rounded == R_20_rounded ? R_20_rounded : R_20;
  const double R_21_final = R_21_rounded == R_21_rounded ? R_21_rounded : R_21;
  const double diagonal2_final = diagonal2_rounded == diagonal2_rounded ? diagonal2_rounded
          : diagonal2;
  R->m00 = diagonal0_final;
  R->m01 = R_01_final;
  R->m02 = R_02_final;
  R->m10 = R_10_final;
  R->m11 = diagonal1_final;
  R->m12 = R_12_final;
  R->m20 = R_20_final;
  R->m21 = R_21_final;
  R->m22 = diagonal2_final;
}

/* R = J_l(v)^-1 = I - v~/2 + (1 - θ/2 cot θ/2)/θ^2 v~^2, θ = |v|; singular at multiples of 2π
     except 0.
   v: vector; R: rotation or other 3×3 matrix.
   208 mul, 502 add, 23 product error, 34 product rest, 10 div, 1 sqrt, 3 neg, 4 abs, 6 less, 10
     equal, 25 select.
   Error <= R: 1 u of its largest component for |v| <= π; searched, not proved.  Each component
     is within 1 ulp as long as its condition is below 1e13; in single precision it is the
     nearest number, except near ties, as long as that is below 1e5; searched, not proved. */
static inline void ksl_SO3_leftJacobianInverse_accurate(const ksl_vec3_t *v, ksl_mat3x3_t *R) {
  const double halved_0 = KSL_MUL(0.5, v->x), halved_1 = KSL_MUL(0.5, v->y),
      halved_2 = KSL_MUL(0.5, v->z);
  const double y_a = KSL_MUL(halved_0, halved_0), y_b = KSL_MUL(halved_1, halved_1),
      y_c = y_a + y_b, y_c_right = y_c - y_a, y_d = KSL_MUL(halved_2, halved_2), y = y_c + y_d,
      y_right = y - y_c,
      y_c_lo = ksl_product_rest(halved_0, halved_0, y_a, y_c - y_c_right)
          + ksl_product_rest(halved_1, halved_1, y_b, y_c_right),
      y_lo = y_c - (y - y_right) + ksl_product_rest(halved_2, halved_2, y_d, y_right) + y_c_lo;
  const double y_sum = y + y_lo, y_sum_right = y_sum - y,
      y_sum_lo = y - (y_sum - y_sum_right) + (y_lo - y_sum_right), half_angle = sqrt(y_sum),
      half_angle_product = KSL_MUL(half_angle, half_angle),
      half_angle_twice = half_angle + half_angle,
      half_angle_residual = y_sum - half_angle_product
          - ksl_product_error(half_angle, half_angle, half_angle_product) + y_sum_lo,
      half_angle_lo = half_angle_residual / (half_angle == 0.0 ? 1.0 : half_angle_twice);
  const double half_angle_sum = half_angle + half_angle_lo,
      half_angle_sum_right = half_angle_sum - half_angle,
      half_angle_sum_lo = half_angle - (half_angle_sum - half_angle_sum_right)
          + (half_angle_lo - half_angle_sum_right);
  double c; const double sine = ksl_sincos(half_angle_sum, &c);
  double c_own_error; const double sine_own_error = ksl_sincos_error(half_angle_sum, sine, c,
      &c_own_error);
  const double sine_half = KSL_MUL(half_angle_sum_lo, 0.5);
  double sine_half_cos; const double sine_half_sin = ksl_sincos(sine_half, &sine_half_cos);
  const double sine_twice = sine_half_sin + sine_half_sin,
      sine_lo = sine_own_error
          + KSL_MUL(KSL_MUL(sine_half_cos, c) - KSL_MUL(sine_half_sin, sine), sine_twice);
  const double c_lo = c_own_error
          - KSL_MUL(KSL_MUL(sine_half_cos, sine) + KSL_MUL(sine_half_sin, c), sine_twice);
  const double sinc_divisor = half_angle_sum < 1.4901161193847656e-08 ? 1.4901161193847656e-08
          : half_angle_sum,
      sinc_divisor_lo = half_angle_sum < 1.4901161193847656e-08 ? 0.0 : half_angle_sum_lo;
  const double sine_sum = sine + sine_lo, sine_sum_right = sine_sum - sine,
      sinc_divisor_sum = sinc_divisor + sinc_divisor_lo,
      sinc_divisor_sum_right = sinc_divisor_sum - sinc_divisor,
      sinc_quotient = sine_sum / sinc_divisor_sum,
      sinc_quotient_product = KSL_MUL(sinc_quotient, sinc_divisor_sum),
      sinc_quotient_exact = sine_sum - sinc_quotient_product
          - ksl_product_error(sinc_quotient, sinc_divisor_sum, sinc_quotient_product),
      sinc_quotient_cross = KSL_MUL(sinc_quotient, sinc_divisor
          - (sinc_divisor_sum - sinc_divisor_sum_right)
          + (sinc_divisor_lo - sinc_divisor_sum_right)),
      sinc_quotient_lo = (sinc_quotient_exact
          + (sine - (sine_sum - sine_sum_right) + (sine_lo - sine_sum_right))
          - sinc_quotient_cross) / sinc_divisor_sum;
  const double sinc_a = KSL_MUL(0.16666666666666666, y_sum), sinc_b = 1.0 - sinc_a,
      sinc_b_right = 1.0 - sinc_b,
      sinc_b_lo1 = 1.0 - (sinc_b + sinc_b_right)
          - ksl_product_rest(0.16666666666666666, y_sum, sinc_a, sinc_b_right),
      sinc_b_lo = sinc_b_lo1
          - (KSL_MUL(9.25185853854297e-18, y_sum) + KSL_MUL(0.16666666666666666, y_sum_lo)),
      sinc = half_angle_sum < 1.4901161193847656e-08 ? sinc_b : sinc_quotient,
      sinc_lo = half_angle_sum < 1.4901161193847656e-08 ? sinc_b_lo : sinc_quotient_lo;
  const double series_phi_a = KSL_MUL(5.107725174524775e-32, y_sum),
      series_phi_b = 4.116826490666969e-29 - series_phi_a,
      series_phi_b_right = 4.116826490666969e-29 - series_phi_b,
      series_phi_b_right_rest = ksl_product_rest(5.107725174524775e-32, y_sum, series_phi_a,
          series_phi_b_right),
      series_phi_b_lo1 = 4.116826490666969e-29 - (series_phi_b + series_phi_b_right)
          - series_phi_b_right_rest, series_phi_c = KSL_MUL(y_sum, series_phi_b),
      series_phi_b_lo = series_phi_b_lo1
          - (KSL_MUL(4.7410392187559056e-48, y_sum) + KSL_MUL(5.107725174524775e-32, y_sum_lo)) +
          -1.8714974010023092e-45, series_phi_d = series_phi_c - 2.86531123750421e-26,
      series_phi_d_right = series_phi_c - series_phi_d,
      series_phi_d_left_rest = ksl_product_rest(y_sum, series_phi_b, series_phi_c, series_phi_d
          + series_phi_d_right),
      series_phi_d_lo2 = series_phi_d_left_rest - (2.86531123750421e-26 - series_phi_d_right)
          - 2.3296034284323186e-42, series_phi_e = KSL_MUL(y_sum, series_phi_d),
      series_phi_e_cross2 = KSL_MUL(y_sum, series_phi_d_lo2
          + (KSL_MUL(y_sum_lo, series_phi_b) + KSL_MUL(y_sum, series_phi_b_lo))),
      series_phi_f = series_phi_e + 1.701994875077501e-23,
      series_phi_f_right = series_phi_f - series_phi_e,
      series_phi_f_left_rest = ksl_product_rest(y_sum, series_phi_d, series_phi_e, series_phi_f
          - series_phi_f_right),
      series_phi_f_lo2 = series_phi_f_left_rest + (1.701994875077501e-23 - series_phi_f_right)
          + 3.161967936521494e-40, series_phi_g = KSL_MUL(y_sum, series_phi_f),
      series_phi_h = series_phi_g - 8.509974375387505e-21,
      series_phi_h_right = series_phi_g - series_phi_h,
      series_phi_h_left_rest = ksl_product_rest(y_sum, series_phi_f, series_phi_g, series_phi_h
          + series_phi_h_right),
      series_phi_g_cross = KSL_MUL(y_sum_lo, series_phi_f)
          + KSL_MUL(y_sum, series_phi_f_lo2
          + (KSL_MUL(y_sum_lo, series_phi_d) + series_phi_e_cross2)),
      series_phi_i = KSL_MUL(y_sum, series_phi_h),
      series_phi_h_lo = series_phi_h_left_rest - (8.509974375387505e-21 - series_phi_h_right)
          - 3.2266760594119493e-37 + series_phi_g_cross,
      series_phi_j = series_phi_i + 3.523129391410427e-18,
      series_phi_j_right = series_phi_j - series_phi_i,
      series_phi_j_left_rest = ksl_product_rest(y_sum, series_phi_h, series_phi_i, series_phi_j
          - series_phi_j_right),
      series_phi_j_lo2 = series_phi_j_left_rest + (3.523129391410427e-18 - series_phi_j_right) +
          -1.2521244741738012e-34, series_phi_k = KSL_MUL(y_sum, series_phi_j),
      series_phi_k_cross2 = KSL_MUL(y_sum, series_phi_j_lo2
          + (KSL_MUL(y_sum_lo, series_phi_h) + KSL_MUL(y_sum, series_phi_h_lo))),
      series_phi_l = series_phi_k - 1.1837714755139035e-15,
      series_phi_l_right = series_phi_k - series_phi_l,
      series_phi_l_left_rest = ksl_product_rest(y_sum, series_phi_j, series_phi_k, series_phi_l
          + series_phi_l_right),
      series_phi_l_lo2 = series_phi_l_left_rest - (1.1837714755139035e-15 - series_phi_l_right)
          - 7.23242424407352e-33, series_phi_m = KSL_MUL(y_sum, series_phi_l),
      series_phi_n = series_phi_m + 3.148832124866983e-13,
      series_phi_n_right = series_phi_n - series_phi_m,
      series_phi_n_left_rest = ksl_product_rest(y_sum, series_phi_l, series_phi_m, series_phi_n
          - series_phi_n_right),
      series_phi_m_cross = KSL_MUL(y_sum_lo, series_phi_l)
          + KSL_MUL(y_sum, series_phi_l_lo2
          + (KSL_MUL(y_sum_lo, series_phi_j) + series_phi_k_cross2)),
      series_phi_o = KSL_MUL(y_sum, series_phi_n),
      series_phi_n_lo = series_phi_n_left_rest + (3.148832124866983e-13 - series_phi_n_right)
          + 5.8681293750286156e-30 + series_phi_m_cross,
      series_phi_p = series_phi_o - 6.423617534728645e-11,
      series_phi_p_right = series_phi_o - series_phi_p,
      series_phi_p_left_rest = ksl_product_rest(y_sum, series_phi_n, series_phi_o, series_phi_p
          + series_phi_p_right),
      series_phi_p_lo2 = series_phi_p_left_rest - (6.423617534728645e-11 - series_phi_p_right)
          - 5.034117835500839e-27, series_phi_q = KSL_MUL(y_sum, series_phi_p),
      series_phi_q_cross2 = KSL_MUL(y_sum, series_phi_p_lo2
          + (KSL_MUL(y_sum_lo, series_phi_n) + KSL_MUL(y_sum, series_phi_n_lo))),
      series_phi_r = series_phi_q + 9.635426302092969e-09,
      series_phi_r_right = series_phi_r - series_phi_q,
      series_phi_r_left_rest = ksl_product_rest(y_sum, series_phi_p, series_phi_q, series_phi_r
          - series_phi_r_right),
      series_phi_r_lo2 = series_phi_r_left_rest + (9.635426302092969e-09 - series_phi_r_right) +
          -1.7546051379703029e-25, series_phi_s = KSL_MUL(y_sum, series_phi_r),
      series_phi_t = series_phi_s - 1.0020843354176687e-06,
      series_phi_t_right = series_phi_s - series_phi_t,
      series_phi_t_left_rest = ksl_product_rest(y_sum, series_phi_r, series_phi_s, series_phi_t
          + series_phi_t_right),
      series_phi_s_cross = KSL_MUL(y_sum_lo, series_phi_r)
          + KSL_MUL(y_sum, series_phi_r_lo2
          + (KSL_MUL(y_sum_lo, series_phi_p) + series_phi_q_cross2)),
      series_phi_u = KSL_MUL(y_sum, series_phi_t),
      series_phi_t_lo = series_phi_t_left_rest - (1.0020843354176687e-06 - series_phi_t_right)
          - 4.7926555569351065e-23 + series_phi_s_cross,
      series_phi_v = series_phi_u + 6.613756613756614e-05,
      series_phi_v_right = series_phi_v - series_phi_u,
      series_phi_v_left_rest = ksl_product_rest(y_sum, series_phi_t, series_phi_u, series_phi_v
          - series_phi_v_right),
      series_phi_v_lo2 = series_phi_v_left_rest + (6.613756613756614e-05 - series_phi_v_right) +
          -4.460143857711533e-21, series_phi_w = KSL_MUL(y_sum, series_phi_v),
      series_phi_w_cross2 = KSL_MUL(y_sum, series_phi_v_lo2
          + (KSL_MUL(y_sum_lo, series_phi_t) + KSL_MUL(y_sum, series_phi_t_lo))),
      series_phi_x = series_phi_w - 0.002380952380952381,
      series_phi_x_right = series_phi_w - series_phi_x,
      series_phi_x_left_rest = ksl_product_rest(y_sum, series_phi_v, series_phi_w, series_phi_x
          + series_phi_x_right),
      series_phi_x_lo2 = series_phi_x_left_rest - (0.002380952380952381 - series_phi_x_right) -
          -2.147752875018904e-19, series_phi_y = KSL_MUL(y_sum, series_phi_x),
      series_phi = series_phi_y + 0.03333333333333333, series_phi_right = series_phi - series_phi_y,
      series_phi_lo1 = ksl_product_rest(y_sum, series_phi_x, series_phi_y, series_phi
          - series_phi_right) + (0.03333333333333333 - series_phi_right),
      series_phi_y_cross = KSL_MUL(y_sum_lo, series_phi_x)
          + KSL_MUL(y_sum, series_phi_x_lo2
          + (KSL_MUL(y_sum_lo, series_phi_v) + series_phi_w_cross2));
  const double f_more_a = KSL_MUL(2.0, y_sum), f_more = KSL_MUL(f_more_a, series_phi);
  const double near_f_a = KSL_MUL(0.3333333333333333, sinc);
  const double f_more_cross = KSL_MUL(KSL_MUL(2.0, y_sum_lo), series_phi)
          + KSL_MUL(f_more_a, series_phi_lo1 + 4.625929269271486e-19 + series_phi_y_cross);
  const double near_f_b = KSL_MUL(0.3333333333333333, f_more), near_f = near_f_a + near_f_b,
      near_f_right = near_f - near_f_a,
      near_f_b_cross = KSL_MUL(1.850371707708594e-17, f_more)
          + KSL_MUL(0.3333333333333333, ksl_product_error(f_more_a, series_phi, f_more)
          + f_more_cross),
      near_f_left_rest = ksl_product_rest(0.3333333333333333, sinc, near_f_a, near_f
          - near_f_right),
      near_f_cross = KSL_MUL(1.850371707708594e-17, sinc) + KSL_MUL(0.3333333333333333, sinc_lo)
          + near_f_b_cross,
      near_f_lo = near_f_left_rest
          + ksl_product_rest(0.3333333333333333, f_more, near_f_b, near_f_right) + near_f_cross;
  const double f_rest = sinc - c, f_rest_right = sinc - f_rest,
      f_rest_lo = sinc - (f_rest + f_rest_right) - (c - f_rest_right) - c_lo + sinc_lo;
  const double x = KSL_MUL(4.0, y_sum);
  const double x_sum = x + KSL_MUL(4.0, y_sum_lo), far_y = x_sum < 4.0 ? 1.0 : y_sum,
      far_y_lo = x_sum < 4.0 ? 0.0 : y_sum_lo;
  const double f_rest_sum = f_rest + f_rest_lo, f_rest_sum_right = f_rest_sum - f_rest,
      far_y_sum = far_y + far_y_lo, far_y_sum_right = far_y_sum - far_y,
      closed_f = f_rest_sum / far_y_sum, closed_f_product = KSL_MUL(closed_f, far_y_sum),
      closed_f_exact = f_rest_sum - closed_f_product
          - ksl_product_error(closed_f, far_y_sum, closed_f_product),
      closed_f_numerator = closed_f_exact
          + (f_rest - (f_rest_sum - f_rest_sum_right) + (f_rest_lo - f_rest_sum_right)),
      closed_f_lo = (closed_f_numerator
          - KSL_MUL(closed_f, far_y - (far_y_sum - far_y_sum_right)
          + (far_y_lo - far_y_sum_right))) / far_y_sum;
  const double f = x_sum < 4.0 ? near_f : closed_f, f_lo = x_sum < 4.0 ? near_f_lo : closed_f_lo;
  const double four_k = KSL_MUL(4.0, sinc), four_k_cross2 = KSL_MUL(4.0, sinc_lo);
  const double f_sum = f + f_lo, f_sum_right = f_sum - f, four_k_sum = four_k + four_k_cross2,
      four_k_sum_right = four_k_sum - four_k, b = f_sum / four_k_sum,
      b_product = KSL_MUL(b, four_k_sum),
      b_numerator = f_sum - b_product - ksl_product_error(b, four_k_sum, b_product)
          + (f - (f_sum - f_sum_right) + (f_lo - f_sum_right)),
      b_lo = (b_numerator
          - KSL_MUL(b, four_k - (four_k_sum - four_k_sum_right)
          + (four_k_cross2 - four_k_sum_right))) / four_k_sum;
  const double c_sum = c + c_lo, c_sum_right = c_sum - c, sinc_sum = sinc + sinc_lo,
      sinc_sum_right = sinc_sum - sinc, b_across = c_sum / sinc_sum,
      b_across_product = KSL_MUL(b_across, sinc_sum),
      b_across_exact = c_sum - b_across_product
          - ksl_product_error(b_across, sinc_sum, b_across_product),
      b_across_cross = KSL_MUL(b_across, sinc - (sinc_sum - sinc_sum_right)
          + (sinc_lo - sinc_sum_right)),
      b_across_lo = (b_across_exact + (c - (c_sum - c_sum_right) + (c_lo - c_sum_right))
          - b_across_cross) / sinc_sum;
  const double beta_v_0 = KSL_MUL(v->x, b), beta_v_1 = KSL_MUL(v->y, b),
      beta_v_2 = KSL_MUL(v->z, b);
  const double beta_v_0_lo = ksl_product_error(v->x, b, beta_v_0) + KSL_MUL(v->x, b_lo),
      m_0 = KSL_MUL(v->x, beta_v_0), m_0_cross2 = KSL_MUL(v->x, beta_v_0_lo);
  const double beta_v_1_lo = ksl_product_error(v->y, b, beta_v_1) + KSL_MUL(v->y, b_lo),
      m_1 = KSL_MUL(v->y, beta_v_1), m_1_cross2 = KSL_MUL(v->y, beta_v_1_lo);
  const double m_2 = KSL_MUL(v->z, beta_v_2),
      m_2_cross2 = KSL_MUL(v->z, ksl_product_error(v->z, b, beta_v_2) + KSL_MUL(v->z, b_lo));
  const double m_3 = KSL_MUL(v->y, beta_v_0), m_3_cross2 = KSL_MUL(v->y, beta_v_0_lo);
  const double m_4 = KSL_MUL(v->z, beta_v_0), m_4_cross2 = KSL_MUL(v->z, beta_v_0_lo);
  const double m_5 = KSL_MUL(v->z, beta_v_1), m_5_cross2 = KSL_MUL(v->z, beta_v_1_lo);
  const double others_0 = m_1 + m_2, others_0_right = others_0 - m_1,
      others_0_lo1 = ksl_product_rest(v->y, beta_v_1, m_1, others_0 - others_0_right)
          + ksl_product_rest(v->z, beta_v_2, m_2, others_0_right),
      others_0_lo = others_0_lo1 + (m_1_cross2 + m_2_cross2);
  const double others_1 = m_0 + m_2, others_1_right = others_1 - m_0,
      others_1_lo1 = ksl_product_rest(v->x, beta_v_0, m_0, others_1 - others_1_right)
          + ksl_product_rest(v->z, beta_v_2, m_2, others_1_right),
      others_1_lo = others_1_lo1 + (m_0_cross2 + m_2_cross2);
  const double others_2 = m_0 + m_1, others_2_right = others_2 - m_0,
      others_2_lo1 = ksl_product_rest(v->x, beta_v_0, m_0, others_2 - others_2_right)
          + ksl_product_rest(v->y, beta_v_1, m_1, others_2_right),
      others_2_lo = others_2_lo1 + (m_0_cross2 + m_1_cross2);
  const double diagonal0a = 1.0 - others_0, diagonal0a_right = 1.0 - diagonal0a,
      diagonal0a_lo = 1.0 - (diagonal0a + diagonal0a_right) - (others_0 - diagonal0a_right)
          - others_0_lo, diagonal0b = b_across + m_0, diagonal0b_right = diagonal0b - b_across,
      diagonal0b_lo = b_across - (diagonal0b - diagonal0b_right)
          + ksl_product_rest(v->x, beta_v_0, m_0, diagonal0b_right) + m_0_cross2 + b_across_lo,
      m_0_sum = m_0 + (ksl_product_error(v->x, beta_v_0, m_0) + m_0_cross2),
      others_0_sum = others_0 + others_0_lo,
      diagonal0 = m_0_sum < others_0_sum ? diagonal0b : diagonal0a;
  const double diagonal1a = 1.0 - others_1, diagonal1a_right = 1.0 - diagonal1a,
      diagonal1a_lo = 1.0 - (diagonal1a + diagonal1a_right) - (others_1 - diagonal1a_right)
          - others_1_lo, diagonal1b = b_across + m_1, diagonal1b_right = diagonal1b - b_across,
      diagonal1b_lo = b_across - (diagonal1b - diagonal1b_right)
          + ksl_product_rest(v->y, beta_v_1, m_1, diagonal1b_right) + m_1_cross2 + b_across_lo,
      m_1_sum = m_1 + (ksl_product_error(v->y, beta_v_1, m_1) + m_1_cross2),
      others_1_sum = others_1 + others_1_lo,
      diagonal1 = m_1_sum < others_1_sum ? diagonal1b : diagonal1a;
  const double diagonal2a = 1.0 - others_2, diagonal2a_right = 1.0 - diagonal2a,
      diagonal2a_lo = 1.0 - (diagonal2a + diagonal2a_right) - (others_2 - diagonal2a_right)
          - others_2_lo, diagonal2b = b_across + m_2, diagonal2b_right = diagonal2b - b_across,
      diagonal2b_lo = b_across - (diagonal2b - diagonal2b_right)
          + ksl_product_rest(v->z, beta_v_2, m_2, diagonal2b_right) + m_2_cross2 + b_across_lo,
      m_2_sum = m_2 + (ksl_product_error(v->z, beta_v_2, m_2) + m_2_cross2),
      others_2_sum = others_2 + others_2_lo,
      diagonal2 = m_2_sum < others_2_sum ? diagonal2b : diagonal2a;
  const double alpha_v_0 = -halved_0, alpha_v_1 = -halved_1, alpha_v_2 = -halved_2;
  const double R_01 = m_3 - alpha_v_2, R_01_right = m_3 - R_01;
  const double R_02 = m_4 + alpha_v_1, R_02_right = R_02 - m_4;
  const double R_10 = m_3 + alpha_v_2, R_10_right = R_10 - m_3;
  const double R_12 = m_5 - alpha_v_0, R_12_right = m_5 - R_12;
  const double R_20 = m_4 - alpha_v_1, R_20_right = m_4 - R_20;
  const double R_21 = m_5 + alpha_v_0, R_21_right = R_21 - m_5;
  const double diagonal0_rounded = diagonal0
          + (m_0_sum < others_0_sum ? diagonal0b_lo : diagonal0a_lo);
  const double R_01_rounded = R_01
          + (ksl_product_rest(v->y, beta_v_0, m_3, R_01 + R_01_right) - (alpha_v_2 - R_01_right)
          + m_3_cross2);
  const double R_02_rounded = R_02
          + (ksl_product_rest(v->z, beta_v_0, m_4, R_02 - R_02_right) + (alpha_v_1 - R_02_right)
          + m_4_cross2);
  const double R_10_rounded = R_10
          + (ksl_product_rest(v->y, beta_v_0, m_3, R_10 - R_10_right) + (alpha_v_2 - R_10_right)
          + m_3_cross2);
  const double diagonal1_rounded = diagonal1
          + (m_1_sum < others_1_sum ? diagonal1b_lo : diagonal1a_lo);
  const double R_12_rounded = R_12
          + (ksl_product_rest(v->z, beta_v_1, m_5, R_12 + R_12_right) - (alpha_v_0 - R_12_right)
          + m_5_cross2);
  const double R_20_rounded = R_20
          + (ksl_product_rest(v->z, beta_v_0, m_4, R_20 + R_20_right) - (alpha_v_1 - R_20_right)
          + m_4_cross2);
  const double R_21_rounded = R_21
          + (ksl_product_rest(v->z, beta_v_1, m_5, R_21 - R_21_right) + (alpha_v_0 - R_21_right)
          + m_5_cross2);
  const double diagonal2_rounded = diagonal2
          + (m_2_sum < others_2_sum ? diagonal2b_lo : diagonal2a_lo);
  const double diagonal0_final = diagonal0_rounded == diagonal0_rounded ? diagonal0_rounded
          : diagonal0;
  const double R_01_final = R_01_rounded == R_01_rounded ? R_01_rounded : R_01;
  const double R_02_final = R_02_rounded == R_02_rounded ? R_02_rounded : R_02;
  const double R_10_final = R_10_rounded == R_10_rounded ? R_10_rounded : R_10;
  const double diagonal1_final = diagonal1_rounded == diagonal1_rounded ? diagonal1_rounded
          : diagonal1;
  const double R_12_final = R_12_rounded == R_12_rounded ? R_12_rounded : R_12;
  const double R_20_final = R_20_rounded == R_20_rounded ? R_20_rounded : R_20;
  const double R_21_final = R_21_rounded == R_21_rounded ? R_21_rounded : R_21;
  const double diagonal2_final = diagonal2_rounded == diagonal2_rounded ? diagonal2_rounded
          : diagonal2;
  R->m00 = diagonal0_final;
  R->m01 = R_01_final;
  R->m02 = R_02_final;
  R->m10 = R_10_final;
  R->m11 = diagonal1_final;
  R->m12 = R_12_final;
  R->m20 = R_20_final;
  R->m21 = R_21_final;
  R->m22 = diagonal2_final;
}

/* R = J_r(v)^-1 = I + v~/2 + (1 - θ/2 cot θ/2)/θ^2 v~^2, θ = |v|; singular at multiples of 2π
     except 0.
   v: vector; R: rotation or other 3×3 matrix.
   208 mul, 502 add, 23 product error, 34 product rest, 10 div, 1 sqrt, 4 abs, 6 less, 10 equal,
     25 select.
   Error <= R: 1 u of its largest component for |v| <= π; searched, not proved.  Each component
     is within 1 ulp as long as its condition is below 1e13; in single precision it is the
     nearest number, except near ties, as long as that is below 1e5; searched, not proved. */
static inline void ksl_SO3_rightJacobianInverse_accurate(const ksl_vec3_t *v, ksl_mat3x3_t *R) {
  const double halved_0 = KSL_MUL(0.5, v->x), halved_1 = KSL_MUL(0.5, v->y),
      halved_2 = KSL_MUL(0.5, v->z);
  const double y_a = KSL_MUL(halved_0, halved_0), y_b = KSL_MUL(halved_1, halved_1),
      y_c = y_a + y_b, y_c_right = y_c - y_a, y_d = KSL_MUL(halved_2, halved_2), y = y_c + y_d,
      y_right = y - y_c,
      y_c_lo = ksl_product_rest(halved_0, halved_0, y_a, y_c - y_c_right)
          + ksl_product_rest(halved_1, halved_1, y_b, y_c_right),
      y_lo = y_c - (y - y_right) + ksl_product_rest(halved_2, halved_2, y_d, y_right) + y_c_lo;
  const double y_sum = y + y_lo, y_sum_right = y_sum - y,
      y_sum_lo = y - (y_sum - y_sum_right) + (y_lo - y_sum_right), half_angle = sqrt(y_sum),
      half_angle_product = KSL_MUL(half_angle, half_angle),
      half_angle_twice = half_angle + half_angle,
      half_angle_residual = y_sum - half_angle_product
          - ksl_product_error(half_angle, half_angle, half_angle_product) + y_sum_lo,
      half_angle_lo = half_angle_residual / (half_angle == 0.0 ? 1.0 : half_angle_twice);
  const double half_angle_sum = half_angle + half_angle_lo,
      half_angle_sum_right = half_angle_sum - half_angle,
      half_angle_sum_lo = half_angle - (half_angle_sum - half_angle_sum_right)
          + (half_angle_lo - half_angle_sum_right);
  double c; const double sine = ksl_sincos(half_angle_sum, &c);
  double c_own_error; const double sine_own_error = ksl_sincos_error(half_angle_sum, sine, c,
      &c_own_error);
  const double sine_half = KSL_MUL(half_angle_sum_lo, 0.5);
  double sine_half_cos; const double sine_half_sin = ksl_sincos(sine_half, &sine_half_cos);
  const double sine_twice = sine_half_sin + sine_half_sin,
      sine_lo = sine_own_error
          + KSL_MUL(KSL_MUL(sine_half_cos, c) - KSL_MUL(sine_half_sin, sine), sine_twice);
  const double c_lo = c_own_error
          - KSL_MUL(KSL_MUL(sine_half_cos, sine) + KSL_MUL(sine_half_sin, c), sine_twice);
  const double sinc_divisor = half_angle_sum < 1.4901161193847656e-08 ? 1.4901161193847656e-08
          : half_angle_sum,
      sinc_divisor_lo = half_angle_sum < 1.4901161193847656e-08 ? 0.0 : half_angle_sum_lo;
  const double sine_sum = sine + sine_lo, sine_sum_right = sine_sum - sine,
      sinc_divisor_sum = sinc_divisor + sinc_divisor_lo,
      sinc_divisor_sum_right = sinc_divisor_sum - sinc_divisor,
      sinc_quotient = sine_sum / sinc_divisor_sum,
      sinc_quotient_product = KSL_MUL(sinc_quotient, sinc_divisor_sum),
      sinc_quotient_exact = sine_sum - sinc_quotient_product
          - ksl_product_error(sinc_quotient, sinc_divisor_sum, sinc_quotient_product),
      sinc_quotient_cross = KSL_MUL(sinc_quotient, sinc_divisor
          - (sinc_divisor_sum - sinc_divisor_sum_right)
          + (sinc_divisor_lo - sinc_divisor_sum_right)),
      sinc_quotient_lo = (sinc_quotient_exact
          + (sine - (sine_sum - sine_sum_right) + (sine_lo - sine_sum_right))
          - sinc_quotient_cross) / sinc_divisor_sum;
  const double sinc_a = KSL_MUL(0.16666666666666666, y_sum), sinc_b = 1.0 - sinc_a,
      sinc_b_right = 1.0 - sinc_b,
      sinc_b_lo1 = 1.0 - (sinc_b + sinc_b_right)
          - ksl_product_rest(0.16666666666666666, y_sum, sinc_a, sinc_b_right),
      sinc_b_lo = sinc_b_lo1
          - (KSL_MUL(9.25185853854297e-18, y_sum) + KSL_MUL(0.16666666666666666, y_sum_lo)),
      sinc = half_angle_sum < 1.4901161193847656e-08 ? sinc_b : sinc_quotient,
      sinc_lo = half_angle_sum < 1.4901161193847656e-08 ? sinc_b_lo : sinc_quotient_lo;
  const double series_phi_a = KSL_MUL(5.107725174524775e-32, y_sum),
      series_phi_b = 4.116826490666969e-29 - series_phi_a,
      series_phi_b_right = 4.116826490666969e-29 - series_phi_b,
      series_phi_b_right_rest = ksl_product_rest(5.107725174524775e-32, y_sum, series_phi_a,
          series_phi_b_right),
      series_phi_b_lo1 = 4.116826490666969e-29 - (series_phi_b + series_phi_b_right)
          - series_phi_b_right_rest, series_phi_c = KSL_MUL(y_sum, series_phi_b),
      series_phi_b_lo = series_phi_b_lo1
          - (KSL_MUL(4.7410392187559056e-48, y_sum) + KSL_MUL(5.107725174524775e-32, y_sum_lo)) +
          -1.8714974010023092e-45, series_phi_d = series_phi_c - 2.86531123750421e-26,
      series_phi_d_right = series_phi_c - series_phi_d,
      series_phi_d_left_rest = ksl_product_rest(y_sum, series_phi_b, series_phi_c, series_phi_d
          + series_phi_d_right),
      series_phi_d_lo2 = series_phi_d_left_rest - (2.86531123750421e-26 - series_phi_d_right)
          - 2.3296034284323186e-42, series_phi_e = KSL_MUL(y_sum, series_phi_d),
      series_phi_e_cross2 = KSL_MUL(y_sum, series_phi_d_lo2
          + (KSL_MUL(y_sum_lo, series_phi_b) + KSL_MUL(y_sum, series_phi_b_lo))),
      series_phi_f = series_phi_e + 1.701994875077501e-23,
      series_phi_f_right = series_phi_f - series_phi_e,
      series_phi_f_left_rest = ksl_product_rest(y_sum, series_phi_d, series_phi_e, series_phi_f
          - series_phi_f_right),
      series_phi_f_lo2 = series_phi_f_left_rest + (1.701994875077501e-23 - series_phi_f_right)
          + 3.161967936521494e-40, series_phi_g = KSL_MUL(y_sum, series_phi_f),
      series_phi_h = series_phi_g - 8.509974375387505e-21,
      series_phi_h_right = series_phi_g - series_phi_h,
      series_phi_h_left_rest = ksl_product_rest(y_sum, series_phi_f, series_phi_g, series_phi_h
          + series_phi_h_right),
      series_phi_g_cross = KSL_MUL(y_sum_lo, series_phi_f)
          + KSL_MUL(y_sum, series_phi_f_lo2
          + (KSL_MUL(y_sum_lo, series_phi_d) + series_phi_e_cross2)),
      series_phi_i = KSL_MUL(y_sum, series_phi_h),
      series_phi_h_lo = series_phi_h_left_rest - (8.509974375387505e-21 - series_phi_h_right)
          - 3.2266760594119493e-37 + series_phi_g_cross,
      series_phi_j = series_phi_i + 3.523129391410427e-18,
      series_phi_j_right = series_phi_j - series_phi_i,
      series_phi_j_left_rest = ksl_product_rest(y_sum, series_phi_h, series_phi_i, series_phi_j
          - series_phi_j_right),
      series_phi_j_lo2 = series_phi_j_left_rest + (3.523129391410427e-18 - series_phi_j_right) +
          -1.2521244741738012e-34, series_phi_k = KSL_MUL(y_sum, series_phi_j),
      series_phi_k_cross2 = KSL_MUL(y_sum, series_phi_j_lo2
          + (KSL_MUL(y_sum_lo, series_phi_h) + KSL_MUL(y_sum, series_phi_h_lo))),
      series_phi_l = series_phi_k - 1.1837714755139035e-15,
      series_phi_l_right = series_phi_k - series_phi_l,
      series_phi_l_left_rest = ksl_product_rest(y_sum, series_phi_j, series_phi_k, series_phi_l
          + series_phi_l_right),
      series_phi_l_lo2 = series_phi_l_left_rest - (1.1837714755139035e-15 - series_phi_l_right)
          - 7.23242424407352e-33, series_phi_m = KSL_MUL(y_sum, series_phi_l),
      series_phi_n = series_phi_m + 3.148832124866983e-13,
      series_phi_n_right = series_phi_n - series_phi_m,
      series_phi_n_left_rest = ksl_product_rest(y_sum, series_phi_l, series_phi_m, series_phi_n
          - series_phi_n_right),
      series_phi_m_cross = KSL_MUL(y_sum_lo, series_phi_l)
          + KSL_MUL(y_sum, series_phi_l_lo2
          + (KSL_MUL(y_sum_lo, series_phi_j) + series_phi_k_cross2)),
      series_phi_o = KSL_MUL(y_sum, series_phi_n),
      series_phi_n_lo = series_phi_n_left_rest + (3.148832124866983e-13 - series_phi_n_right)
          + 5.8681293750286156e-30 + series_phi_m_cross,
      series_phi_p = series_phi_o - 6.423617534728645e-11,
      series_phi_p_right = series_phi_o - series_phi_p,
      series_phi_p_left_rest = ksl_product_rest(y_sum, series_phi_n, series_phi_o, series_phi_p
          + series_phi_p_right),
      series_phi_p_lo2 = series_phi_p_left_rest - (6.423617534728645e-11 - series_phi_p_right)
          - 5.034117835500839e-27, series_phi_q = KSL_MUL(y_sum, series_phi_p),
      series_phi_q_cross2 = KSL_MUL(y_sum, series_phi_p_lo2
          + (KSL_MUL(y_sum_lo, series_phi_n) + KSL_MUL(y_sum, series_phi_n_lo))),
      series_phi_r = series_phi_q + 9.635426302092969e-09,
      series_phi_r_right = series_phi_r - series_phi_q,
      series_phi_r_left_rest = ksl_product_rest(y_sum, series_phi_p, series_phi_q, series_phi_r
          - series_phi_r_right),
      series_phi_r_lo2 = series_phi_r_left_rest + (9.635426302092969e-09 - series_phi_r_right) +
          -1.7546051379703029e-25, series_phi_s = KSL_MUL(y_sum, series_phi_r),
      series_phi_t = series_phi_s - 1.0020843354176687e-06,
      series_phi_t_right = series_phi_s - series_phi_t,
      series_phi_t_left_rest = ksl_product_rest(y_sum, series_phi_r, series_phi_s, series_phi_t
          + series_phi_t_right),
      series_phi_s_cross = KSL_MUL(y_sum_lo, series_phi_r)
          + KSL_MUL(y_sum, series_phi_r_lo2
          + (KSL_MUL(y_sum_lo, series_phi_p) + series_phi_q_cross2)),
      series_phi_u = KSL_MUL(y_sum, series_phi_t),
      series_phi_t_lo = series_phi_t_left_rest - (1.0020843354176687e-06 - series_phi_t_right)
          - 4.7926555569351065e-23 + series_phi_s_cross,
      series_phi_v = series_phi_u + 6.613756613756614e-05,
      series_phi_v_right = series_phi_v - series_phi_u,
      series_phi_v_left_rest = ksl_product_rest(y_sum, series_phi_t, series_phi_u, series_phi_v
          - series_phi_v_right),
      series_phi_v_lo2 = series_phi_v_left_rest + (6.613756613756614e-05 - series_phi_v_right) +
          -4.460143857711533e-21, series_phi_w = KSL_MUL(y_sum, series_phi_v),
      series_phi_w_cross2 = KSL_MUL(y_sum, series_phi_v_lo2
          + (KSL_MUL(y_sum_lo, series_phi_t) + KSL_MUL(y_sum, series_phi_t_lo))),
      series_phi_x = series_phi_w - 0.002380952380952381,
      series_phi_x_right = series_phi_w - series_phi_x,
      series_phi_x_left_rest = ksl_product_rest(y_sum, series_phi_v, series_phi_w, series_phi_x
          + series_phi_x_right),
      series_phi_x_lo2 = series_phi_x_left_rest - (0.002380952380952381 - series_phi_x_right) -
          -2.147752875018904e-19, series_phi_y = KSL_MUL(y_sum, series_phi_x),
      series_phi = series_phi_y + 0.03333333333333333, series_phi_right = series_phi - series_phi_y,
      series_phi_lo1 = ksl_product_rest(y_sum, series_phi_x, series_phi_y, series_phi
          - series_phi_right) + (0.03333333333333333 - series_phi_right),
      series_phi_y_cross = KSL_MUL(y_sum_lo, series_phi_x)
          + KSL_MUL(y_sum, series_phi_x_lo2
          + (KSL_MUL(y_sum_lo, series_phi_v) + series_phi_w_cross2));
  const double f_more_a = KSL_MUL(2.0, y_sum), f_more = KSL_MUL(f_more_a, series_phi);
  const double near_f_a = KSL_MUL(0.3333333333333333, sinc);
  const double f_more_cross = KSL_MUL(KSL_MUL(2.0, y_sum_lo), series_phi)
          + KSL_MUL(f_more_a, series_phi_lo1 + 4.625929269271486e-19 + series_phi_y_cross);
  const double near_f_b = KSL_MUL(0.3333333333333333, f_more), near_f = near_f_a + near_f_b,
      near_f_right = near_f - near_f_a,
      near_f_b_cross = KSL_MUL(1.850371707708594e-17, f_more)
          + KSL_MUL(0.3333333333333333, ksl_product_error(f_more_a, series_phi, f_more)
          + f_more_cross),
      near_f_left_rest = ksl_product_rest(0.3333333333333333, sinc, near_f_a, near_f
          - near_f_right),
      near_f_cross = KSL_MUL(1.850371707708594e-17, sinc) + KSL_MUL(0.3333333333333333, sinc_lo)
          + near_f_b_cross,
      near_f_lo = near_f_left_rest
          + ksl_product_rest(0.3333333333333333, f_more, near_f_b, near_f_right) + near_f_cross;
  const double f_rest = sinc - c, f_rest_right = sinc - f_rest,
      f_rest_lo = sinc - (f_rest + f_rest_right) - (c - f_rest_right) - c_lo + sinc_lo;
  const double x = KSL_MUL(4.0, y_sum);
  const double x_sum = x + KSL_MUL(4.0, y_sum_lo), far_y = x_sum < 4.0 ? 1.0 : y_sum,
      far_y_lo = x_sum < 4.0 ? 0.0 : y_sum_lo;
  const double f_rest_sum = f_rest + f_rest_lo, f_rest_sum_right = f_rest_sum - f_rest,
      far_y_sum = far_y + far_y_lo, far_y_sum_right = far_y_sum - far_y,
      closed_f = f_rest_sum / far_y_sum, closed_f_product = KSL_MUL(closed_f, far_y_sum),
      closed_f_exact = f_rest_sum - closed_f_product
          - ksl_product_error(closed_f, far_y_sum, closed_f_product),
      closed_f_numerator = closed_f_exact
          + (f_rest - (f_rest_sum - f_rest_sum_right) + (f_rest_lo - f_rest_sum_right)),
      closed_f_lo = (closed_f_numerator
          - KSL_MUL(closed_f, far_y - (far_y_sum - far_y_sum_right)
          + (far_y_lo - far_y_sum_right))) / far_y_sum;
  const double f = x_sum < 4.0 ? near_f : closed_f, f_lo = x_sum < 4.0 ? near_f_lo : closed_f_lo;
  const double four_k = KSL_MUL(4.0, sinc), four_k_cross2 = KSL_MUL(4.0, sinc_lo);
  const double f_sum = f + f_lo, f_sum_right = f_sum - f, four_k_sum = four_k + four_k_cross2,
      four_k_sum_right = four_k_sum - four_k, b = f_sum / four_k_sum,
      b_product = KSL_MUL(b, four_k_sum),
      b_numerator = f_sum - b_product - ksl_product_error(b, four_k_sum, b_product)
          + (f - (f_sum - f_sum_right) + (f_lo - f_sum_right)),
      b_lo = (b_numerator
          - KSL_MUL(b, four_k - (four_k_sum - four_k_sum_right)
          + (four_k_cross2 - four_k_sum_right))) / four_k_sum;
  const double c_sum = c + c_lo, c_sum_right = c_sum - c, sinc_sum = sinc + sinc_lo,
      sinc_sum_right = sinc_sum - sinc, b_across = c_sum / sinc_sum,
      b_across_product = KSL_MUL(b_across, sinc_sum),
      b_across_exact = c_sum - b_across_product
          - ksl_product_error(b_across, sinc_sum, b_across_product),
      b_across_cross = KSL_MUL(b_across, sinc - (sinc_sum - sinc_sum_right)
          + (sinc_lo - sinc_sum_right)),
      b_across_lo = (b_across_exact + (c - (c_sum - c_sum_right) + (c_lo - c_sum_right))
          - b_across_cross) / sinc_sum;
  const double beta_v_0 = KSL_MUL(v->x, b), beta_v_1 = KSL_MUL(v->y, b),
      beta_v_2 = KSL_MUL(v->z, b);
  const double beta_v_0_lo = ksl_product_error(v->x, b, beta_v_0) + KSL_MUL(v->x, b_lo),
      m_0 = KSL_MUL(v->x, beta_v_0), m_0_cross2 = KSL_MUL(v->x, beta_v_0_lo);
  const double beta_v_1_lo = ksl_product_error(v->y, b, beta_v_1) + KSL_MUL(v->y, b_lo),
      m_1 = KSL_MUL(v->y, beta_v_1), m_1_cross2 = KSL_MUL(v->y, beta_v_1_lo);
  const double m_2 = KSL_MUL(v->z, beta_v_2),
      m_2_cross2 = KSL_MUL(v->z, ksl_product_error(v->z, b, beta_v_2) + KSL_MUL(v->z, b_lo));
  const double m_3 = KSL_MUL(v->y, beta_v_0), m_3_cross2 = KSL_MUL(v->y, beta_v_0_lo);
  const double m_4 = KSL_MUL(v->z, beta_v_0), m_4_cross2 = KSL_MUL(v->z, beta_v_0_lo);
  const double m_5 = KSL_MUL(v->z, beta_v_1), m_5_cross2 = KSL_MUL(v->z, beta_v_1_lo);
  const double others_0 = m_1 + m_2, others_0_right = others_0 - m_1,
      others_0_lo1 = ksl_product_rest(v->y, beta_v_1, m_1, others_0 - others_0_right)
          + ksl_product_rest(v->z, beta_v_2, m_2, others_0_right),
      others_0_lo = others_0_lo1 + (m_1_cross2 + m_2_cross2);
  const double others_1 = m_0 + m_2, others_1_right = others_1 - m_0,
      others_1_lo1 = ksl_product_rest(v->x, beta_v_0, m_0, others_1 - others_1_right)
          + ksl_product_rest(v->z, beta_v_2, m_2, others_1_right),
      others_1_lo = others_1_lo1 + (m_0_cross2 + m_2_cross2);
  const double others_2 = m_0 + m_1, others_2_right = others_2 - m_0,
      others_2_lo1 = ksl_product_rest(v->x, beta_v_0, m_0, others_2 - others_2_right)
          + ksl_product_rest(v->y, beta_v_1, m_1, others_2_right),
      others_2_lo = others_2_lo1 + (m_0_cross2 + m_1_cross2);
  const double diagonal0a = 1.0 - others_0, diagonal0a_right = 1.0 - diagonal0a,
      diagonal0a_lo = 1.0 - (diagonal0a + diagonal0a_right) - (others_0 - diagonal0a_right)
          - others_0_lo, diagonal0b = b_across + m_0, diagonal0b_right = diagonal0b - b_across,
      diagonal0b_lo = b_across - (diagonal0b - diagonal0b_right)
          + ksl_product_rest(v->x, beta_v_0, m_0, diagonal0b_right) + m_0_cross2 + b_across_lo,
      m_0_sum = m_0 + (ksl_product_error(v->x, beta_v_0, m_0) + m_0_cross2),
      others_0_sum = others_0 + others_0_lo,
      diagonal0 = m_0_sum < others_0_sum ? diagonal0b : diagonal0a;
  const double diagonal1a = 1.0 - others_1, diagonal1a_right = 1.0 - diagonal1a,
      diagonal1a_lo = 1.0 - (diagonal1a + diagonal1a_right) - (others_1 - diagonal1a_right)
          - others_1_lo, diagonal1b = b_across + m_1, diagonal1b_right = diagonal1b - b_across,
      diagonal1b_lo = b_across - (diagonal1b - diagonal1b_right)
          + ksl_product_rest(v->y, beta_v_1, m_1, diagonal1b_right) + m_1_cross2 + b_across_lo,
      m_1_sum = m_1 + (ksl_product_error(v->y, beta_v_1, m_1) + m_1_cross2),
      others_1_sum = others_1 + others_1_lo,
      diagonal1 = m_1_sum < others_1_sum ? diagonal1b : diagonal1a;
  const double diagonal2a = 1.0 - others_2, diagonal2a_right = 1.0 - diagonal2a,
      diagonal2a_lo = 1.0 - (diagonal2a + diagonal2a_right) - (others_2 - diagonal2a_right)
          - others_2_lo, diagonal2b = b_across + m_2, diagonal2b_right = diagonal2b - b_across,
      diagonal2b_lo = b_across - (diagonal2b - diagonal2b_right)
          + ksl_product_rest(v->z, beta_v_2, m_2, diagonal2b_right) + m_2_cross2 + b_across_lo,
      m_2_sum = m_2 + (ksl_product_error(v->z, beta_v_2, m_2) + m_2_cross2),
      others_2_sum = others_2 + others_2_lo,
      diagonal2 = m_2_sum < others_2_sum ? diagonal2b : diagonal2a;
  const double R_01 = m_3 - halved_2, R_01_right = m_3 - R_01;
  const double R_02 = halved_1 + m_4, R_02_right = R_02 - halved_1;
  const double R_10 = halved_2 + m_3, R_10_right = R_10 - halved_2;
  const double R_12 = m_5 - halved_0, R_12_right = m_5 - R_12;
  const double R_20 = m_4 - halved_1, R_20_right = m_4 - R_20;
  const double R_21 = halved_0 + m_5, R_21_right = R_21 - halved_0;
  const double diagonal0_rounded = diagonal0
          + (m_0_sum < others_0_sum ? diagonal0b_lo : diagonal0a_lo);
  const double R_01_rounded = R_01
          + (ksl_product_rest(v->y, beta_v_0, m_3, R_01 + R_01_right) - (halved_2 - R_01_right)
          + m_3_cross2);
  const double R_02_rounded = R_02
          + (halved_1 - (R_02 - R_02_right) + ksl_product_rest(v->z, beta_v_0, m_4, R_02_right)
          + m_4_cross2);
  const double R_10_rounded = R_10
          + (halved_2 - (R_10 - R_10_right) + ksl_product_rest(v->y, beta_v_0, m_3, R_10_right)
          + m_3_cross2);
  const double diagonal1_rounded = diagonal1
          + (m_1_sum < others_1_sum ? diagonal1b_lo : diagonal1a_lo);
  const double R_12_rounded = R_12
          + (ksl_product_rest(v->z, beta_v_1, m_5, R_12 + R_12_right) - (halved_0 - R_12_right)
          + m_5_cross2);
  const double R_20_rounded = R_20
          + (ksl_product_rest(v->z, beta_v_0, m_4, R_20 + R_20_right) - (halved_1 - R_20_right)
          + m_4_cross2);
  const double R_21_rounded = R_21
          + (halved_0 - (R_21 - R_21_right) + ksl_product_rest(v->z, beta_v_1, m_5, R_21_right)
          + m_5_cross2);
  const double diagonal2_rounded = diagonal2
          + (m_2_sum < others_2_sum ? diagonal2b_lo : diagonal2a_lo);
  const double diagonal0_final = diagonal0_rounded == diagonal0_rounded ? diagonal0_rounded
          : diagonal0;
  const double R_01_final = R_01_rounded == R_01_rounded ? R_01_rounded : R_01;
  const double R_02_final = R_02_rounded == R_02_rounded ? R_02_rounded : R_02;
  const double R_10_final = R_10_rounded == R_10_rounded ? R_10_rounded : R_10;
  const double diagonal1_final = diagonal1_rounded == diagonal1_rounded ? diagonal1_rounded
          : diagonal1;
  const double R_12_final = R_12_rounded == R_12_rounded ? R_12_rounded : R_12;
  const double R_20_final = R_20_rounded == R_20_rounded ? R_20_rounded : R_20;
  const double R_21_final = R_21_rounded == R_21_rounded ? R_21_rounded : R_21;
  const double diagonal2_final = diagonal2_rounded == diagonal2_rounded ? diagonal2_rounded
          : diagonal2;
  R->m00 = diagonal0_final;
  R->m01 = R_01_final;
  R->m02 = R_02_final;
  R->m10 = R_10_final;
  R->m11 = diagonal1_final;
  R->m12 = R_12_final;
  R->m20 = R_20_final;
  R->m21 = R_21_final;
  R->m22 = diagonal2_final;
}

/* self = R + R (I - R^T R)/2, closer to a rotation: a defect d of R becomes 3/4 d^2.
   self: rotation or other 3×3 matrix.
   84 mul, 288 add, 45 product rest, 6 neg.
   Error <= u |result| + 44 u^2 S, S the sum of the |terms| of the expanded formula; barring
     over- and underflow. */
static inline void ksl_mat3x3_orthonormalize_accurate(ksl_mat3x3_t *self) {
  const double defect_0a = KSL_MUL(self->m00, self->m00), defect_0b = 1.0 - defect_0a,
      defect_0b_right = 1.0 - defect_0b, defect_0c = KSL_MUL(self->m10, self->m10),
      defect_0d = defect_0b - defect_0c, defect_0d_right = defect_0b - defect_0d,
      defect_0d_lo1 = defect_0b - (defect_0d + defect_0d_right)
          - ksl_product_rest(self->m10, self->m10, defect_0c, defect_0d_right),
      defect_0e = KSL_MUL(self->m20, self->m20), defect_0 = defect_0d - defect_0e,
      defect_0_right = defect_0d - defect_0,
      defect_0d_lo = defect_0d_lo1
          + (1.0 - (defect_0b + defect_0b_right)
          - ksl_product_rest(self->m00, self->m00, defect_0a, defect_0b_right)),
      defect_0_lo = defect_0d - (defect_0 + defect_0_right)
          - ksl_product_rest(self->m20, self->m20, defect_0e, defect_0_right) + defect_0d_lo;
  const double defect_1a = KSL_MUL(self->m01, self->m01), defect_1b = 1.0 - defect_1a,
      defect_1b_right = 1.0 - defect_1b, defect_1c = KSL_MUL(self->m11, self->m11),
      defect_1d = defect_1b - defect_1c, defect_1d_right = defect_1b - defect_1d,
      defect_1d_lo1 = defect_1b - (defect_1d + defect_1d_right)
          - ksl_product_rest(self->m11, self->m11, defect_1c, defect_1d_right),
      defect_1e = KSL_MUL(self->m21, self->m21), defect_1 = defect_1d - defect_1e,
      defect_1_right = defect_1d - defect_1,
      defect_1d_lo = defect_1d_lo1
          + (1.0 - (defect_1b + defect_1b_right)
          - ksl_product_rest(self->m01, self->m01, defect_1a, defect_1b_right)),
      defect_1_lo = defect_1d - (defect_1 + defect_1_right)
          - ksl_product_rest(self->m21, self->m21, defect_1e, defect_1_right) + defect_1d_lo;
  const double defect_2a = KSL_MUL(self->m02, self->m02), defect_2b = 1.0 - defect_2a,
      defect_2b_right = 1.0 - defect_2b, defect_2c = KSL_MUL(self->m12, self->m12),
      defect_2d = defect_2b - defect_2c, defect_2d_right = defect_2b - defect_2d,
      defect_2d_lo1 = defect_2b - (defect_2d + defect_2d_right)
          - ksl_product_rest(self->m12, self->m12, defect_2c, defect_2d_right),
      defect_2e = KSL_MUL(self->m22, self->m22), defect_2 = defect_2d - defect_2e,
      defect_2_right = defect_2d - defect_2,
      defect_2d_lo = defect_2d_lo1
          + (1.0 - (defect_2b + defect_2b_right)
          - ksl_product_rest(self->m02, self->m02, defect_2a, defect_2b_right)),
      defect_2_lo = defect_2d - (defect_2 + defect_2_right)
          - ksl_product_rest(self->m22, self->m22, defect_2e, defect_2_right) + defect_2d_lo;
  const double defect_3a = KSL_MUL(self->m00, self->m01), defect_3b = KSL_MUL(self->m10, self->m11),
      defect_3c = defect_3a + defect_3b, defect_3c_right = defect_3c - defect_3a,
      defect_3c_left_rest = ksl_product_rest(self->m00, self->m01, defect_3a, defect_3c
          - defect_3c_right), defect_3d = KSL_MUL(self->m20, self->m21),
      defect_3e = defect_3c + defect_3d, defect_3e_right = defect_3e - defect_3c,
      defect_3e_lo1 = defect_3c - (defect_3e - defect_3e_right)
          + ksl_product_rest(self->m20, self->m21, defect_3d, defect_3e_right),
      defect_3 = -defect_3e;
  const double defect_4a = KSL_MUL(self->m00, self->m02), defect_4b = KSL_MUL(self->m10, self->m12),
      defect_4c = defect_4a + defect_4b, defect_4c_right = defect_4c - defect_4a,
      defect_4c_left_rest = ksl_product_rest(self->m00, self->m02, defect_4a, defect_4c
          - defect_4c_right), defect_4d = KSL_MUL(self->m20, self->m22),
      defect_4e = defect_4c + defect_4d, defect_4e_right = defect_4e - defect_4c,
      defect_4e_lo1 = defect_4c - (defect_4e - defect_4e_right)
          + ksl_product_rest(self->m20, self->m22, defect_4d, defect_4e_right),
      defect_4 = -defect_4e;
  const double defect_5a = KSL_MUL(self->m01, self->m02), defect_5b = KSL_MUL(self->m11, self->m12),
      defect_5c = defect_5a + defect_5b, defect_5c_right = defect_5c - defect_5a,
      defect_5c_left_rest = ksl_product_rest(self->m01, self->m02, defect_5a, defect_5c
          - defect_5c_right), defect_5d = KSL_MUL(self->m21, self->m22),
      defect_5e = defect_5c + defect_5d, defect_5e_right = defect_5e - defect_5c,
      defect_5e_lo1 = defect_5c - (defect_5e - defect_5e_right)
          + ksl_product_rest(self->m21, self->m22, defect_5d, defect_5e_right),
      defect_5 = -defect_5e;
  const double defect_0_sum = defect_0 + defect_0_lo, defect_0_sum_right = defect_0_sum - defect_0,
      correction_0 = KSL_MUL(0.5, defect_0_sum),
      correction_0_cross2 = KSL_MUL(0.5, defect_0 - (defect_0_sum - defect_0_sum_right)
          + (defect_0_lo - defect_0_sum_right));
  const double defect_1_sum = defect_1 + defect_1_lo, defect_1_sum_right = defect_1_sum - defect_1,
      correction_1 = KSL_MUL(0.5, defect_1_sum),
      correction_1_cross2 = KSL_MUL(0.5, defect_1 - (defect_1_sum - defect_1_sum_right)
          + (defect_1_lo - defect_1_sum_right));
  const double defect_2_sum = defect_2 + defect_2_lo, defect_2_sum_right = defect_2_sum - defect_2,
      correction_2 = KSL_MUL(0.5, defect_2_sum),
      correction_2_cross2 = KSL_MUL(0.5, defect_2 - (defect_2_sum - defect_2_sum_right)
          + (defect_2_lo - defect_2_sum_right));
  const double correction_3 = KSL_MUL(0.5, defect_3),
      correction_3_cross2 = KSL_MUL(0.5,
          -(defect_3e_lo1
          + (defect_3c_left_rest
          + ksl_product_rest(self->m10, self->m11, defect_3b, defect_3c_right))));
  const double correction_4 = KSL_MUL(0.5, defect_4),
      correction_4_cross2 = KSL_MUL(0.5,
          -(defect_4e_lo1
          + (defect_4c_left_rest
          + ksl_product_rest(self->m10, self->m12, defect_4b, defect_4c_right))));
  const double correction_5 = KSL_MUL(0.5, defect_5),
      correction_5_cross2 = KSL_MUL(0.5,
          -(defect_5e_lo1
          + (defect_5c_left_rest
          + ksl_product_rest(self->m11, self->m12, defect_5b, defect_5c_right))));
  const double self_00_new_a = KSL_MUL(self->m00, correction_0),
      self_00_new_b = KSL_MUL(self->m01, correction_3),
      self_00_new_c = self_00_new_a + self_00_new_b,
      self_00_new_c_right = self_00_new_c - self_00_new_a,
      self_00_new_c_left_rest = ksl_product_rest(self->m00, correction_0, self_00_new_a,
          self_00_new_c - self_00_new_c_right),
      self_00_new_c_lo1 = self_00_new_c_left_rest
          + ksl_product_rest(self->m01, correction_3, self_00_new_b, self_00_new_c_right),
      self_00_new_d = KSL_MUL(self->m02, correction_4),
      self_00_new_e = self_00_new_c + self_00_new_d,
      self_00_new_e_right = self_00_new_e - self_00_new_c,
      self_00_new_e_right_rest = ksl_product_rest(self->m02, correction_4, self_00_new_d,
          self_00_new_e_right),
      self_00_new_e_lo2 = self_00_new_c - (self_00_new_e - self_00_new_e_right)
          + self_00_new_e_right_rest + KSL_MUL(self->m02, correction_4_cross2),
      self_00_new = self->m00 + self_00_new_e, self_00_new_right = self_00_new - self->m00,
      self_00_new_e_lo = self_00_new_e_lo2
          + (self_00_new_c_lo1
          + (KSL_MUL(self->m00, correction_0_cross2) + KSL_MUL(self->m01, correction_3_cross2)));
  const double self_01_new_a = KSL_MUL(self->m00, correction_3),
      self_01_new_b = KSL_MUL(self->m01, correction_1),
      self_01_new_c = self_01_new_a + self_01_new_b,
      self_01_new_c_right = self_01_new_c - self_01_new_a,
      self_01_new_c_left_rest = ksl_product_rest(self->m00, correction_3, self_01_new_a,
          self_01_new_c - self_01_new_c_right),
      self_01_new_c_lo1 = self_01_new_c_left_rest
          + ksl_product_rest(self->m01, correction_1, self_01_new_b, self_01_new_c_right),
      self_01_new_d = KSL_MUL(self->m02, correction_5),
      self_01_new_e = self_01_new_c + self_01_new_d,
      self_01_new_e_right = self_01_new_e - self_01_new_c,
      self_01_new_e_right_rest = ksl_product_rest(self->m02, correction_5, self_01_new_d,
          self_01_new_e_right),
      self_01_new_e_lo2 = self_01_new_c - (self_01_new_e - self_01_new_e_right)
          + self_01_new_e_right_rest + KSL_MUL(self->m02, correction_5_cross2),
      self_01_new = self_01_new_e + self->m01, self_01_new_right = self_01_new - self_01_new_e,
      self_01_new_e_lo = self_01_new_e_lo2
          + (self_01_new_c_lo1
          + (KSL_MUL(self->m00, correction_3_cross2) + KSL_MUL(self->m01, correction_1_cross2)));
  const double self_02_new_a = KSL_MUL(self->m00, correction_4),
      self_02_new_b = KSL_MUL(self->m01, correction_5),
      self_02_new_c = self_02_new_a + self_02_new_b,
      self_02_new_c_right = self_02_new_c - self_02_new_a,
      self_02_new_c_left_rest = ksl_product_rest(self->m00, correction_4, self_02_new_a,
          self_02_new_c - self_02_new_c_right),
      self_02_new_c_lo1 = self_02_new_c_left_rest
          + ksl_product_rest(self->m01, correction_5, self_02_new_b, self_02_new_c_right),
      self_02_new_d = KSL_MUL(self->m02, correction_2),
      self_02_new_e = self_02_new_c + self_02_new_d,
      self_02_new_e_right = self_02_new_e - self_02_new_c,
      self_02_new_e_right_rest = ksl_product_rest(self->m02, correction_2, self_02_new_d,
          self_02_new_e_right),
      self_02_new_e_lo2 = self_02_new_c - (self_02_new_e - self_02_new_e_right)
          + self_02_new_e_right_rest + KSL_MUL(self->m02, correction_2_cross2),
      self_02_new = self_02_new_e + self->m02, self_02_new_right = self_02_new - self_02_new_e,
      self_02_new_e_lo = self_02_new_e_lo2
          + (self_02_new_c_lo1
          + (KSL_MUL(self->m00, correction_4_cross2) + KSL_MUL(self->m01, correction_5_cross2)));
  const double self_10_new_a = KSL_MUL(self->m10, correction_0),
      self_10_new_b = KSL_MUL(self->m11, correction_3),
      self_10_new_c = self_10_new_a + self_10_new_b,
      self_10_new_c_right = self_10_new_c - self_10_new_a,
      self_10_new_c_left_rest = ksl_product_rest(self->m10, correction_0, self_10_new_a,
          self_10_new_c - self_10_new_c_right),
      self_10_new_c_lo1 = self_10_new_c_left_rest
          + ksl_product_rest(self->m11, correction_3, self_10_new_b, self_10_new_c_right),
      self_10_new_d = KSL_MUL(self->m12, correction_4),
      self_10_new_e = self_10_new_c + self_10_new_d,
      self_10_new_e_right = self_10_new_e - self_10_new_c,
      self_10_new_e_right_rest = ksl_product_rest(self->m12, correction_4, self_10_new_d,
          self_10_new_e_right),
      self_10_new_e_lo2 = self_10_new_c - (self_10_new_e - self_10_new_e_right)
          + self_10_new_e_right_rest + KSL_MUL(self->m12, correction_4_cross2),
      self_10_new = self->m10 + self_10_new_e, self_10_new_right = self_10_new - self->m10,
      self_10_new_e_lo = self_10_new_e_lo2
          + (self_10_new_c_lo1
          + (KSL_MUL(self->m10, correction_0_cross2) + KSL_MUL(self->m11, correction_3_cross2)));
  const double self_11_new_a = KSL_MUL(self->m10, correction_3),
      self_11_new_b = KSL_MUL(self->m11, correction_1),
      self_11_new_c = self_11_new_a + self_11_new_b,
      self_11_new_c_right = self_11_new_c - self_11_new_a,
      self_11_new_c_left_rest = ksl_product_rest(self->m10, correction_3, self_11_new_a,
          self_11_new_c - self_11_new_c_right),
      self_11_new_c_lo1 = self_11_new_c_left_rest
          + ksl_product_rest(self->m11, correction_1, self_11_new_b, self_11_new_c_right),
      self_11_new_d = KSL_MUL(self->m12, correction_5),
      self_11_new_e = self_11_new_c + self_11_new_d,
      self_11_new_e_right = self_11_new_e - self_11_new_c,
      self_11_new_e_right_rest = ksl_product_rest(self->m12, correction_5, self_11_new_d,
          self_11_new_e_right),
      self_11_new_e_lo2 = self_11_new_c - (self_11_new_e - self_11_new_e_right)
          + self_11_new_e_right_rest + KSL_MUL(self->m12, correction_5_cross2),
      self_11_new = self_11_new_e + self->m11, self_11_new_right = self_11_new - self_11_new_e,
      self_11_new_e_lo = self_11_new_e_lo2
          + (self_11_new_c_lo1
          + (KSL_MUL(self->m10, correction_3_cross2) + KSL_MUL(self->m11, correction_1_cross2)));
  const double self_12_new_a = KSL_MUL(self->m10, correction_4),
      self_12_new_b = KSL_MUL(self->m11, correction_5),
      self_12_new_c = self_12_new_a + self_12_new_b,
      self_12_new_c_right = self_12_new_c - self_12_new_a,
      self_12_new_c_left_rest = ksl_product_rest(self->m10, correction_4, self_12_new_a,
          self_12_new_c - self_12_new_c_right),
      self_12_new_c_lo1 = self_12_new_c_left_rest
          + ksl_product_rest(self->m11, correction_5, self_12_new_b, self_12_new_c_right),
      self_12_new_d = KSL_MUL(self->m12, correction_2),
      self_12_new_e = self_12_new_c + self_12_new_d,
      self_12_new_e_right = self_12_new_e - self_12_new_c,
      self_12_new_e_right_rest = ksl_product_rest(self->m12, correction_2, self_12_new_d,
          self_12_new_e_right),
      self_12_new_e_lo2 = self_12_new_c - (self_12_new_e - self_12_new_e_right)
          + self_12_new_e_right_rest + KSL_MUL(self->m12, correction_2_cross2),
      self_12_new = self_12_new_e + self->m12, self_12_new_right = self_12_new - self_12_new_e,
      self_12_new_e_lo = self_12_new_e_lo2
          + (self_12_new_c_lo1
          + (KSL_MUL(self->m10, correction_4_cross2) + KSL_MUL(self->m11, correction_5_cross2)));
  const double self_20_new_a = KSL_MUL(self->m20, correction_0),
      self_20_new_b = KSL_MUL(self->m21, correction_3),
      self_20_new_c = self_20_new_a + self_20_new_b,
      self_20_new_c_right = self_20_new_c - self_20_new_a,
      self_20_new_c_left_rest = ksl_product_rest(self->m20, correction_0, self_20_new_a,
          self_20_new_c - self_20_new_c_right),
      self_20_new_c_lo1 = self_20_new_c_left_rest
          + ksl_product_rest(self->m21, correction_3, self_20_new_b, self_20_new_c_right),
      self_20_new_d = KSL_MUL(self->m22, correction_4),
      self_20_new_e = self_20_new_c + self_20_new_d,
      self_20_new_e_right = self_20_new_e - self_20_new_c,
      self_20_new_e_right_rest = ksl_product_rest(self->m22, correction_4, self_20_new_d,
          self_20_new_e_right),
      self_20_new_e_lo2 = self_20_new_c - (self_20_new_e - self_20_new_e_right)
          + self_20_new_e_right_rest + KSL_MUL(self->m22, correction_4_cross2),
      self_20_new = self->m20 + self_20_new_e, self_20_new_right = self_20_new - self->m20,
      self_20_new_e_lo = self_20_new_e_lo2
          + (self_20_new_c_lo1
          + (KSL_MUL(self->m20, correction_0_cross2) + KSL_MUL(self->m21, correction_3_cross2)));
  const double self_21_new_a = KSL_MUL(self->m20, correction_3),
      self_21_new_b = KSL_MUL(self->m21, correction_1),
      self_21_new_c = self_21_new_a + self_21_new_b,
      self_21_new_c_right = self_21_new_c - self_21_new_a,
      self_21_new_c_left_rest = ksl_product_rest(self->m20, correction_3, self_21_new_a,
          self_21_new_c - self_21_new_c_right),
      self_21_new_c_lo1 = self_21_new_c_left_rest
          + ksl_product_rest(self->m21, correction_1, self_21_new_b, self_21_new_c_right),
      self_21_new_d = KSL_MUL(self->m22, correction_5),
      self_21_new_e = self_21_new_c + self_21_new_d,
      self_21_new_e_right = self_21_new_e - self_21_new_c,
      self_21_new_e_right_rest = ksl_product_rest(self->m22, correction_5, self_21_new_d,
          self_21_new_e_right),
      self_21_new_e_lo2 = self_21_new_c - (self_21_new_e - self_21_new_e_right)
          + self_21_new_e_right_rest + KSL_MUL(self->m22, correction_5_cross2),
      self_21_new = self_21_new_e + self->m21, self_21_new_right = self_21_new - self_21_new_e,
      self_21_new_e_lo = self_21_new_e_lo2
          + (self_21_new_c_lo1
          + (KSL_MUL(self->m20, correction_3_cross2) + KSL_MUL(self->m21, correction_1_cross2)));
  const double self_22_new_a = KSL_MUL(self->m20, correction_4),
      self_22_new_b = KSL_MUL(self->m21, correction_5),
      self_22_new_c = self_22_new_a + self_22_new_b,
      self_22_new_c_right = self_22_new_c - self_22_new_a,
      self_22_new_c_left_rest = ksl_product_rest(self->m20, correction_4, self_22_new_a,
          self_22_new_c - self_22_new_c_right),
      self_22_new_c_lo1 = self_22_new_c_left_rest
          + ksl_product_rest(self->m21, correction_5, self_22_new_b, self_22_new_c_right),
      self_22_new_d = KSL_MUL(self->m22, correction_2),
      self_22_new_e = self_22_new_c + self_22_new_d,
      self_22_new_e_right = self_22_new_e - self_22_new_c,
      self_22_new_e_right_rest = ksl_product_rest(self->m22, correction_2, self_22_new_d,
          self_22_new_e_right),
      self_22_new_e_lo2 = self_22_new_c - (self_22_new_e - self_22_new_e_right)
          + self_22_new_e_right_rest + KSL_MUL(self->m22, correction_2_cross2),
      self_22_new = self_22_new_e + self->m22, self_22_new_right = self_22_new - self_22_new_e,
      self_22_new_e_lo = self_22_new_e_lo2
          + (self_22_new_c_lo1
          + (KSL_MUL(self->m20, correction_4_cross2) + KSL_MUL(self->m21, correction_5_cross2)));
  const double self_00_new_rounded = self_00_new
          + (self->m00 - (self_00_new - self_00_new_right) + (self_00_new_e - self_00_new_right)
          + self_00_new_e_lo),
      self_01_new_rounded = self_01_new
          + (self_01_new_e - (self_01_new - self_01_new_right) + (self->m01 - self_01_new_right)
          + self_01_new_e_lo),
      self_02_new_rounded = self_02_new
          + (self_02_new_e - (self_02_new - self_02_new_right) + (self->m02 - self_02_new_right)
          + self_02_new_e_lo),
      self_10_new_rounded = self_10_new
          + (self->m10 - (self_10_new - self_10_new_right) + (self_10_new_e - self_10_new_right)
          + self_10_new_e_lo),
      self_11_new_rounded = self_11_new
          + (self_11_new_e - (self_11_new - self_11_new_right) + (self->m11 - self_11_new_right)
          + self_11_new_e_lo),
      self_12_new_rounded = self_12_new
          + (self_12_new_e - (self_12_new - self_12_new_right) + (self->m12 - self_12_new_right)
          + self_12_new_e_lo),
      self_20_new_rounded = self_20_new
          + (self->m20 - (self_20_new - self_20_new_right) + (self_20_new_e - self_20_new_right)
          + self_20_new_e_lo),
      self_21_new_rounded = self_21_new
          + (self_21_new_e - (self_21_new - self_21_new_right) + (self->m21 - self_21_new_right)
          + self_21_new_e_lo),
      self_22_new_rounded = self_22_new
          + (self_22_new_e - (self_22_new - self_22_new_right) + (self->m22 - self_22_new_right)
          + self_22_new_e_lo);
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
      defect_0b_right = 1.0 - defect_0b, defect_0c = KSL_MUL(R->m10, R->m10),
      defect_0d = defect_0b - defect_0c, defect_0d_right = defect_0b - defect_0d,
      defect_0d_lo1 = defect_0b - (defect_0d + defect_0d_right)
          - ksl_product_rest(R->m10, R->m10, defect_0c, defect_0d_right),
      defect_0e = KSL_MUL(R->m20, R->m20), defect_0 = defect_0d - defect_0e,
      defect_0_right = defect_0d - defect_0,
      defect_0d_lo = defect_0d_lo1
          + (1.0 - (defect_0b + defect_0b_right)
          - ksl_product_rest(R->m00, R->m00, defect_0a, defect_0b_right)),
      defect_0_lo = defect_0d - (defect_0 + defect_0_right)
          - ksl_product_rest(R->m20, R->m20, defect_0e, defect_0_right) + defect_0d_lo;
  const double defect_1a = KSL_MUL(R->m01, R->m01), defect_1b = 1.0 - defect_1a,
      defect_1b_right = 1.0 - defect_1b, defect_1c = KSL_MUL(R->m11, R->m11),
      defect_1d = defect_1b - defect_1c, defect_1d_right = defect_1b - defect_1d,
      defect_1d_lo1 = defect_1b - (defect_1d + defect_1d_right)
          - ksl_product_rest(R->m11, R->m11, defect_1c, defect_1d_right),
      defect_1e = KSL_MUL(R->m21, R->m21), defect_1 = defect_1d - defect_1e,
      defect_1_right = defect_1d - defect_1,
      defect_1d_lo = defect_1d_lo1
          + (1.0 - (defect_1b + defect_1b_right)
          - ksl_product_rest(R->m01, R->m01, defect_1a, defect_1b_right)),
      defect_1_lo = defect_1d - (defect_1 + defect_1_right)
          - ksl_product_rest(R->m21, R->m21, defect_1e, defect_1_right) + defect_1d_lo;
  const double defect_2a = KSL_MUL(R->m02, R->m02), defect_2b = 1.0 - defect_2a,
      defect_2b_right = 1.0 - defect_2b, defect_2c = KSL_MUL(R->m12, R->m12),
      defect_2d = defect_2b - defect_2c, defect_2d_right = defect_2b - defect_2d,
      defect_2d_lo1 = defect_2b - (defect_2d + defect_2d_right)
          - ksl_product_rest(R->m12, R->m12, defect_2c, defect_2d_right),
      defect_2e = KSL_MUL(R->m22, R->m22), defect_2 = defect_2d - defect_2e,
      defect_2_right = defect_2d - defect_2,
      defect_2d_lo = defect_2d_lo1
          + (1.0 - (defect_2b + defect_2b_right)
          - ksl_product_rest(R->m02, R->m02, defect_2a, defect_2b_right)),
      defect_2_lo = defect_2d - (defect_2 + defect_2_right)
          - ksl_product_rest(R->m22, R->m22, defect_2e, defect_2_right) + defect_2d_lo;
  const double defect_3a = KSL_MUL(R->m00, R->m01), defect_3b = KSL_MUL(R->m10, R->m11),
      defect_3c = defect_3a + defect_3b, defect_3c_right = defect_3c - defect_3a,
      defect_3d = KSL_MUL(R->m20, R->m21), defect_3e = defect_3c + defect_3d,
      defect_3e_right = defect_3e - defect_3c,
      defect_3c_lo = ksl_product_rest(R->m00, R->m01, defect_3a, defect_3c - defect_3c_right)
          + ksl_product_rest(R->m10, R->m11, defect_3b, defect_3c_right), defect_3 = -defect_3e;
  const double defect_4a = KSL_MUL(R->m00, R->m02), defect_4b = KSL_MUL(R->m10, R->m12),
      defect_4c = defect_4a + defect_4b, defect_4c_right = defect_4c - defect_4a,
      defect_4d = KSL_MUL(R->m20, R->m22), defect_4e = defect_4c + defect_4d,
      defect_4e_right = defect_4e - defect_4c,
      defect_4c_lo = ksl_product_rest(R->m00, R->m02, defect_4a, defect_4c - defect_4c_right)
          + ksl_product_rest(R->m10, R->m12, defect_4b, defect_4c_right), defect_4 = -defect_4e;
  const double defect_5a = KSL_MUL(R->m01, R->m02), defect_5b = KSL_MUL(R->m11, R->m12),
      defect_5c = defect_5a + defect_5b, defect_5c_right = defect_5c - defect_5a,
      defect_5d = KSL_MUL(R->m21, R->m22), defect_5e = defect_5c + defect_5d,
      defect_5e_right = defect_5e - defect_5c,
      defect_5c_lo = ksl_product_rest(R->m01, R->m02, defect_5a, defect_5c - defect_5c_right)
          + ksl_product_rest(R->m11, R->m12, defect_5b, defect_5c_right), defect_5 = -defect_5e;
  const double defect_0_sum = defect_0 + defect_0_lo, defect_0_sum_right = defect_0_sum - defect_0,
      correction_0 = KSL_MUL(0.5, defect_0_sum),
      correction_0_cross2 = KSL_MUL(0.5, defect_0 - (defect_0_sum - defect_0_sum_right)
          + (defect_0_lo - defect_0_sum_right));
  const double defect_1_sum = defect_1 + defect_1_lo, defect_1_sum_right = defect_1_sum - defect_1,
      correction_1 = KSL_MUL(0.5, defect_1_sum),
      correction_1_cross2 = KSL_MUL(0.5, defect_1 - (defect_1_sum - defect_1_sum_right)
          + (defect_1_lo - defect_1_sum_right));
  const double defect_2_sum = defect_2 + defect_2_lo, defect_2_sum_right = defect_2_sum - defect_2,
      correction_2 = KSL_MUL(0.5, defect_2_sum),
      correction_2_cross2 = KSL_MUL(0.5, defect_2 - (defect_2_sum - defect_2_sum_right)
          + (defect_2_lo - defect_2_sum_right));
  const double correction_3 = KSL_MUL(0.5, defect_3);
  const double defect_3_lo =
          -(defect_3c - (defect_3e - defect_3e_right)
          + ksl_product_rest(R->m20, R->m21, defect_3d, defect_3e_right) + defect_3c_lo);
  const double correction_3_cross2 = KSL_MUL(0.5, defect_3_lo);
  const double correction_4 = KSL_MUL(0.5, defect_4);
  const double defect_4_lo =
          -(defect_4c - (defect_4e - defect_4e_right)
          + ksl_product_rest(R->m20, R->m22, defect_4d, defect_4e_right) + defect_4c_lo);
  const double correction_4_cross2 = KSL_MUL(0.5, defect_4_lo);
  const double correction_5 = KSL_MUL(0.5, defect_5);
  const double defect_5_lo =
          -(defect_5c - (defect_5e - defect_5e_right)
          + ksl_product_rest(R->m21, R->m22, defect_5d, defect_5e_right) + defect_5c_lo);
  const double correction_5_cross2 = KSL_MUL(0.5, defect_5_lo);
  const double Ro_00a = KSL_MUL(R->m00, correction_0), Ro_00b = KSL_MUL(R->m01, correction_3),
      Ro_00c = Ro_00a + Ro_00b, Ro_00c_right = Ro_00c - Ro_00a,
      Ro_00c_lo1 = ksl_product_rest(R->m00, correction_0, Ro_00a, Ro_00c - Ro_00c_right)
          + ksl_product_rest(R->m01, correction_3, Ro_00b, Ro_00c_right),
      Ro_00d = KSL_MUL(R->m02, correction_4), Ro_00e = Ro_00c + Ro_00d,
      Ro_00e_right = Ro_00e - Ro_00c,
      Ro_00e_lo2 = Ro_00c - (Ro_00e - Ro_00e_right)
          + ksl_product_rest(R->m02, correction_4, Ro_00d, Ro_00e_right)
          + KSL_MUL(R->m02, correction_4_cross2), Ro_00 = R->m00 + Ro_00e,
      Ro_00_right = Ro_00 - R->m00,
      Ro_00e_lo = Ro_00e_lo2
          + (Ro_00c_lo1
          + (KSL_MUL(R->m00, correction_0_cross2) + KSL_MUL(R->m01, correction_3_cross2)));
  const double Ro_01a = KSL_MUL(R->m00, correction_3), Ro_01b = KSL_MUL(R->m01, correction_1),
      Ro_01c = Ro_01a + Ro_01b, Ro_01c_right = Ro_01c - Ro_01a,
      Ro_01c_lo1 = ksl_product_rest(R->m00, correction_3, Ro_01a, Ro_01c - Ro_01c_right)
          + ksl_product_rest(R->m01, correction_1, Ro_01b, Ro_01c_right),
      Ro_01d = KSL_MUL(R->m02, correction_5), Ro_01e = Ro_01c + Ro_01d,
      Ro_01e_right = Ro_01e - Ro_01c,
      Ro_01e_lo2 = Ro_01c - (Ro_01e - Ro_01e_right)
          + ksl_product_rest(R->m02, correction_5, Ro_01d, Ro_01e_right)
          + KSL_MUL(R->m02, correction_5_cross2), Ro_01 = Ro_01e + R->m01,
      Ro_01_right = Ro_01 - Ro_01e,
      Ro_01e_lo = Ro_01e_lo2
          + (Ro_01c_lo1
          + (KSL_MUL(R->m00, correction_3_cross2) + KSL_MUL(R->m01, correction_1_cross2)));
  const double Ro_02a = KSL_MUL(R->m00, correction_4), Ro_02b = KSL_MUL(R->m01, correction_5),
      Ro_02c = Ro_02a + Ro_02b, Ro_02c_right = Ro_02c - Ro_02a,
      Ro_02c_lo1 = ksl_product_rest(R->m00, correction_4, Ro_02a, Ro_02c - Ro_02c_right)
          + ksl_product_rest(R->m01, correction_5, Ro_02b, Ro_02c_right),
      Ro_02d = KSL_MUL(R->m02, correction_2), Ro_02e = Ro_02c + Ro_02d,
      Ro_02e_right = Ro_02e - Ro_02c,
      Ro_02e_lo2 = Ro_02c - (Ro_02e - Ro_02e_right)
          + ksl_product_rest(R->m02, correction_2, Ro_02d, Ro_02e_right)
          + KSL_MUL(R->m02, correction_2_cross2), Ro_02 = Ro_02e + R->m02,
      Ro_02_right = Ro_02 - Ro_02e,
      Ro_02e_lo = Ro_02e_lo2
          + (Ro_02c_lo1
          + (KSL_MUL(R->m00, correction_4_cross2) + KSL_MUL(R->m01, correction_5_cross2)));
  const double Ro_10a = KSL_MUL(R->m10, correction_0), Ro_10b = KSL_MUL(R->m11, correction_3),
      Ro_10c = Ro_10a + Ro_10b, Ro_10c_right = Ro_10c - Ro_10a,
      Ro_10c_lo1 = ksl_product_rest(R->m10, correction_0, Ro_10a, Ro_10c - Ro_10c_right)
          + ksl_product_rest(R->m11, correction_3, Ro_10b, Ro_10c_right),
      Ro_10d = KSL_MUL(R->m12, correction_4), Ro_10e = Ro_10c + Ro_10d,
      Ro_10e_right = Ro_10e - Ro_10c,
      Ro_10e_lo2 = Ro_10c - (Ro_10e - Ro_10e_right)
          + ksl_product_rest(R->m12, correction_4, Ro_10d, Ro_10e_right)
          + KSL_MUL(R->m12, correction_4_cross2), Ro_10 = R->m10 + Ro_10e,
      Ro_10_right = Ro_10 - R->m10,
      Ro_10e_lo = Ro_10e_lo2
          + (Ro_10c_lo1
          + (KSL_MUL(R->m10, correction_0_cross2) + KSL_MUL(R->m11, correction_3_cross2)));
  const double Ro_11a = KSL_MUL(R->m10, correction_3), Ro_11b = KSL_MUL(R->m11, correction_1),
      Ro_11c = Ro_11a + Ro_11b, Ro_11c_right = Ro_11c - Ro_11a,
      Ro_11c_lo1 = ksl_product_rest(R->m10, correction_3, Ro_11a, Ro_11c - Ro_11c_right)
          + ksl_product_rest(R->m11, correction_1, Ro_11b, Ro_11c_right),
      Ro_11d = KSL_MUL(R->m12, correction_5), Ro_11e = Ro_11c + Ro_11d,
      Ro_11e_right = Ro_11e - Ro_11c,
      Ro_11e_lo2 = Ro_11c - (Ro_11e - Ro_11e_right)
          + ksl_product_rest(R->m12, correction_5, Ro_11d, Ro_11e_right)
          + KSL_MUL(R->m12, correction_5_cross2), Ro_11 = Ro_11e + R->m11,
      Ro_11_right = Ro_11 - Ro_11e,
      Ro_11e_lo = Ro_11e_lo2
          + (Ro_11c_lo1
          + (KSL_MUL(R->m10, correction_3_cross2) + KSL_MUL(R->m11, correction_1_cross2)));
  const double Ro_12a = KSL_MUL(R->m10, correction_4), Ro_12b = KSL_MUL(R->m11, correction_5),
      Ro_12c = Ro_12a + Ro_12b, Ro_12c_right = Ro_12c - Ro_12a,
      Ro_12c_lo1 = ksl_product_rest(R->m10, correction_4, Ro_12a, Ro_12c - Ro_12c_right)
          + ksl_product_rest(R->m11, correction_5, Ro_12b, Ro_12c_right),
      Ro_12d = KSL_MUL(R->m12, correction_2), Ro_12e = Ro_12c + Ro_12d,
      Ro_12e_right = Ro_12e - Ro_12c,
      Ro_12e_lo2 = Ro_12c - (Ro_12e - Ro_12e_right)
          + ksl_product_rest(R->m12, correction_2, Ro_12d, Ro_12e_right)
          + KSL_MUL(R->m12, correction_2_cross2), Ro_12 = Ro_12e + R->m12,
      Ro_12_right = Ro_12 - Ro_12e,
      Ro_12e_lo = Ro_12e_lo2
          + (Ro_12c_lo1
          + (KSL_MUL(R->m10, correction_4_cross2) + KSL_MUL(R->m11, correction_5_cross2)));
  const double Ro_20a = KSL_MUL(R->m20, correction_0), Ro_20b = KSL_MUL(R->m21, correction_3),
      Ro_20c = Ro_20a + Ro_20b, Ro_20c_right = Ro_20c - Ro_20a,
      Ro_20c_lo1 = ksl_product_rest(R->m20, correction_0, Ro_20a, Ro_20c - Ro_20c_right)
          + ksl_product_rest(R->m21, correction_3, Ro_20b, Ro_20c_right),
      Ro_20d = KSL_MUL(R->m22, correction_4), Ro_20e = Ro_20c + Ro_20d,
      Ro_20e_right = Ro_20e - Ro_20c,
      Ro_20e_lo2 = Ro_20c - (Ro_20e - Ro_20e_right)
          + ksl_product_rest(R->m22, correction_4, Ro_20d, Ro_20e_right)
          + KSL_MUL(R->m22, correction_4_cross2), Ro_20 = R->m20 + Ro_20e,
      Ro_20_right = Ro_20 - R->m20,
      Ro_20e_lo = Ro_20e_lo2
          + (Ro_20c_lo1
          + (KSL_MUL(R->m20, correction_0_cross2) + KSL_MUL(R->m21, correction_3_cross2)));
  const double Ro_21a = KSL_MUL(R->m20, correction_3), Ro_21b = KSL_MUL(R->m21, correction_1),
      Ro_21c = Ro_21a + Ro_21b, Ro_21c_right = Ro_21c - Ro_21a,
      Ro_21c_lo1 = ksl_product_rest(R->m20, correction_3, Ro_21a, Ro_21c - Ro_21c_right)
          + ksl_product_rest(R->m21, correction_1, Ro_21b, Ro_21c_right),
      Ro_21d = KSL_MUL(R->m22, correction_5), Ro_21e = Ro_21c + Ro_21d,
      Ro_21e_right = Ro_21e - Ro_21c,
      Ro_21e_lo2 = Ro_21c - (Ro_21e - Ro_21e_right)
          + ksl_product_rest(R->m22, correction_5, Ro_21d, Ro_21e_right)
          + KSL_MUL(R->m22, correction_5_cross2), Ro_21 = Ro_21e + R->m21,
      Ro_21_right = Ro_21 - Ro_21e,
      Ro_21e_lo = Ro_21e_lo2
          + (Ro_21c_lo1
          + (KSL_MUL(R->m20, correction_3_cross2) + KSL_MUL(R->m21, correction_1_cross2)));
  const double Ro_22a = KSL_MUL(R->m20, correction_4), Ro_22b = KSL_MUL(R->m21, correction_5),
      Ro_22c = Ro_22a + Ro_22b, Ro_22c_right = Ro_22c - Ro_22a,
      Ro_22c_lo1 = ksl_product_rest(R->m20, correction_4, Ro_22a, Ro_22c - Ro_22c_right)
          + ksl_product_rest(R->m21, correction_5, Ro_22b, Ro_22c_right),
      Ro_22d = KSL_MUL(R->m22, correction_2), Ro_22e = Ro_22c + Ro_22d,
      Ro_22e_right = Ro_22e - Ro_22c,
      Ro_22e_lo2 = Ro_22c - (Ro_22e - Ro_22e_right)
          + ksl_product_rest(R->m22, correction_2, Ro_22d, Ro_22e_right)
          + KSL_MUL(R->m22, correction_2_cross2), Ro_22 = Ro_22e + R->m22,
      Ro_22_right = Ro_22 - Ro_22e,
      Ro_22e_lo = Ro_22e_lo2
          + (Ro_22c_lo1
          + (KSL_MUL(R->m20, correction_4_cross2) + KSL_MUL(R->m21, correction_5_cross2)));
  const double Ro_00_rounded = Ro_00
          + (R->m00 - (Ro_00 - Ro_00_right) + (Ro_00e - Ro_00_right) + Ro_00e_lo),
      Ro_01_rounded = Ro_01 + (Ro_01e - (Ro_01 - Ro_01_right) + (R->m01 - Ro_01_right) + Ro_01e_lo),
      Ro_02_rounded = Ro_02 + (Ro_02e - (Ro_02 - Ro_02_right) + (R->m02 - Ro_02_right) + Ro_02e_lo),
      Ro_10_rounded = Ro_10 + (R->m10 - (Ro_10 - Ro_10_right) + (Ro_10e - Ro_10_right) + Ro_10e_lo),
      Ro_11_rounded = Ro_11 + (Ro_11e - (Ro_11 - Ro_11_right) + (R->m11 - Ro_11_right) + Ro_11e_lo),
      Ro_12_rounded = Ro_12 + (Ro_12e - (Ro_12 - Ro_12_right) + (R->m12 - Ro_12_right) + Ro_12e_lo),
      Ro_20_rounded = Ro_20 + (R->m20 - (Ro_20 - Ro_20_right) + (Ro_20e - Ro_20_right) + Ro_20e_lo),
      Ro_21_rounded = Ro_21 + (Ro_21e - (Ro_21 - Ro_21_right) + (R->m21 - Ro_21_right) + Ro_21e_lo),
      Ro_22_rounded = Ro_22 + (Ro_22e - (Ro_22 - Ro_22_right) + (R->m22 - Ro_22_right) + Ro_22e_lo);
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

/* D = exp s = [exp ω~ | J_l(ω) v].
   s: screw (v in m/s; ω in rad/s); D: displacement [R | t], R rotation, t in m.
   246 mul, 553 add, 24 product error, 58 product rest, 6 div, 1 sqrt, 4 abs, 6 less, 13 equal,
     28 select.
   Error <= R: 1 u, t: 1 u of its largest component, or of s.lin if that is larger, for |ω of s|
     <= 1e13, in single precision 1e5; searched, not proved.  Each component is within 1 ulp as
     long as its condition is below 1e13; in single precision it is the nearest number, except
     near ties, as long as that is below 1e5; searched, not proved.  Intermediate sums may
     overflow where |v|, or |ω| |v|, is above 2e306, in single precision 5e36. */
static inline void ksl_SE3_exp_accurate(const ksl_screw_t *s, ksl_SE3_t *D) {
  const double halved_0 = KSL_MUL(0.5, s->m3), halved_1 = KSL_MUL(0.5, s->m4),
      halved_2 = KSL_MUL(0.5, s->m5);
  const double y_a = KSL_MUL(halved_0, halved_0), y_b = KSL_MUL(halved_1, halved_1),
      y_c = y_a + y_b, y_c_right = y_c - y_a, y_d = KSL_MUL(halved_2, halved_2), y = y_c + y_d,
      y_right = y - y_c,
      y_c_lo = ksl_product_rest(halved_0, halved_0, y_a, y_c - y_c_right)
          + ksl_product_rest(halved_1, halved_1, y_b, y_c_right),
      y_lo = y_c - (y - y_right) + ksl_product_rest(halved_2, halved_2, y_d, y_right) + y_c_lo;
  const double y_sum = y + y_lo, y_sum_right = y_sum - y,
      y_sum_lo = y - (y_sum - y_sum_right) + (y_lo - y_sum_right), half_angle = sqrt(y_sum),
      half_angle_product = KSL_MUL(half_angle, half_angle),
      half_angle_twice = half_angle + half_angle,
      half_angle_residual = y_sum - half_angle_product
          - ksl_product_error(half_angle, half_angle, half_angle_product) + y_sum_lo,
      half_angle_lo = half_angle_residual / (half_angle == 0.0 ? 1.0 : half_angle_twice);
  const double half_angle_sum = half_angle + half_angle_lo,
      half_angle_sum_right = half_angle_sum - half_angle,
      half_angle_sum_lo = half_angle - (half_angle_sum - half_angle_sum_right)
          + (half_angle_lo - half_angle_sum_right);
  double c; const double sine = ksl_sincos(half_angle_sum, &c);
  double c_own_error; const double sine_own_error = ksl_sincos_error(half_angle_sum, sine, c,
      &c_own_error);
  const double sine_half = KSL_MUL(half_angle_sum_lo, 0.5);
  double sine_half_cos; const double sine_half_sin = ksl_sincos(sine_half, &sine_half_cos);
  const double sine_twice = sine_half_sin + sine_half_sin,
      sine_lo = sine_own_error
          + KSL_MUL(KSL_MUL(sine_half_cos, c) - KSL_MUL(sine_half_sin, sine), sine_twice);
  const double sinc_divisor = half_angle_sum < 1.4901161193847656e-08 ? 1.4901161193847656e-08
          : half_angle_sum,
      sinc_divisor_lo = half_angle_sum < 1.4901161193847656e-08 ? 0.0 : half_angle_sum_lo;
  const double sine_sum = sine + sine_lo, sine_sum_right = sine_sum - sine,
      sine_sum_lo = sine - (sine_sum - sine_sum_right) + (sine_lo - sine_sum_right),
      sinc_divisor_sum = sinc_divisor + sinc_divisor_lo,
      sinc_divisor_sum_right = sinc_divisor_sum - sinc_divisor,
      sinc_quotient = sine_sum / sinc_divisor_sum,
      sinc_quotient_product = KSL_MUL(sinc_quotient, sinc_divisor_sum),
      sinc_quotient_cross = KSL_MUL(sinc_quotient, sinc_divisor
          - (sinc_divisor_sum - sinc_divisor_sum_right)
          + (sinc_divisor_lo - sinc_divisor_sum_right)),
      sinc_quotient_numerator = sine_sum - sinc_quotient_product
          - ksl_product_error(sinc_quotient, sinc_divisor_sum, sinc_quotient_product) + sine_sum_lo,
      sinc_quotient_lo = (sinc_quotient_numerator - sinc_quotient_cross) / sinc_divisor_sum;
  const double sinc_a = KSL_MUL(0.16666666666666666, y_sum), sinc_b = 1.0 - sinc_a,
      sinc_b_right = 1.0 - sinc_b,
      sinc_b_lo1 = 1.0 - (sinc_b + sinc_b_right)
          - ksl_product_rest(0.16666666666666666, y_sum, sinc_a, sinc_b_right),
      sinc_b_lo = sinc_b_lo1
          - (KSL_MUL(9.25185853854297e-18, y_sum) + KSL_MUL(0.16666666666666666, y_sum_lo)),
      sinc = half_angle_sum < 1.4901161193847656e-08 ? sinc_b : sinc_quotient,
      sinc_lo = half_angle_sum < 1.4901161193847656e-08 ? sinc_b_lo : sinc_quotient_lo;
  const double g1 = KSL_MUL(c, sinc),
      g1_cross = KSL_MUL(c_own_error
          - KSL_MUL(KSL_MUL(sine_half_cos, sine) + KSL_MUL(sine_half_sin, c), sine_twice), sinc)
          + KSL_MUL(c, sinc_lo);
  const double g2a = KSL_MUL(sinc, sinc), g2 = KSL_MUL(0.5, g2a),
      g2_cross2 = KSL_MUL(0.5, ksl_product_error(sinc, sinc, g2a)
          + (KSL_MUL(sinc_lo, sinc) + KSL_MUL(sinc, sinc_lo)));
  const double sine_square = KSL_MUL(sine_sum, sine_sum);
  const double g0a = KSL_MUL(2.0, sine_square), g0 = 1.0 - g0a, g0_right = 1.0 - g0,
      g0a_cross2 = KSL_MUL(2.0, ksl_product_error(sine_sum, sine_sum, sine_square)
          + (KSL_MUL(sine_sum_lo, sine_sum) + KSL_MUL(sine_sum, sine_sum_lo))),
      g0_lo = 1.0 - (g0 + g0_right) - (g0a - g0_right) - g0a_cross2;
  const double rest3 = 1.0 - g1, rest3_right = 1.0 - rest3,
      rest3_lo = 1.0 - (rest3 + rest3_right) - ksl_product_rest(c, sinc, g1, rest3_right)
          - g1_cross;
  const double x = KSL_MUL(4.0, y_sum), x_cross2 = KSL_MUL(4.0, y_sum_lo);
  const double x_sum = x + x_cross2, x_sum_right = x_sum - x,
      x_sum_lo = x - (x_sum - x_sum_right) + (x_cross2 - x_sum_right),
      far_x = x_sum < 1.0 ? 1.0 : x_sum, far_x_lo = x_sum < 1.0 ? 0.0 : x_sum_lo;
  const double rest3_sum = rest3 + rest3_lo, rest3_sum_right = rest3_sum - rest3,
      far_x_sum = far_x + far_x_lo, far_x_sum_right = far_x_sum - far_x,
      closed3 = rest3_sum / far_x_sum, closed3_product = KSL_MUL(closed3, far_x_sum),
      closed3_exact = rest3_sum - closed3_product
          - ksl_product_error(closed3, far_x_sum, closed3_product),
      closed3_numerator = closed3_exact
          + (rest3 - (rest3_sum - rest3_sum_right) + (rest3_lo - rest3_sum_right)),
      closed3_lo = (closed3_numerator
          - KSL_MUL(closed3, far_x - (far_x_sum - far_x_sum_right) + (far_x_lo - far_x_sum_right)))
          / far_x_sum;
  const double series5a = KSL_MUL(1.216125041553518e-34, x_sum),
      series5b = 1.1309962886447716e-31 - series5a,
      series5b_right = 1.1309962886447716e-31 - series5b,
      series5b_lo1 = 1.1309962886447716e-31 - (series5b + series5b_right)
          - ksl_product_rest(1.216125041553518e-34, x_sum, series5a, series5b_right),
      series5c = KSL_MUL(x_sum, series5b),
      series5b_lo = series5b_lo1
          - (KSL_MUL(5.586290567888806e-51, x_sum) + KSL_MUL(1.216125041553518e-34, x_sum_lo))
          + 1.0498015412959506e-47, series5d = series5c - 9.183689863795546e-29,
      series5d_right = series5c - series5d,
      series5d_lo1 = ksl_product_rest(x_sum, series5b, series5c, series5d + series5d_right)
          - (9.183689863795546e-29 - series5d_right), series5e = KSL_MUL(x_sum, series5d),
      series5e_cross2 = KSL_MUL(x_sum, series5d_lo1 - 1.4303150396787322e-45
          + (KSL_MUL(x_sum_lo, series5b) + KSL_MUL(x_sum, series5b_lo))),
      series5f = series5e + 6.446950284384474e-26, series5f_right = series5f - series5e,
      series5f_lo1 = ksl_product_rest(x_sum, series5d, series5e, series5f - series5f_right)
          + (6.446950284384474e-26 - series5f_right), series5g = KSL_MUL(x_sum, series5f),
      series5g_cross2 = KSL_MUL(x_sum, series5f_lo1 + -1.9330404233703465e-42
          + (KSL_MUL(x_sum_lo, series5d) + series5e_cross2)),
      series5h = series5g - 3.868170170630684e-23, series5h_right = series5g - series5h,
      series5h_lo1 = ksl_product_rest(x_sum, series5f, series5g, series5h + series5h_right)
          - (3.868170170630684e-23 - series5h_right), series5i = KSL_MUL(x_sum, series5h),
      series5j = series5i + 1.9572941063391263e-20, series5j_right = series5j - series5i,
      series5j_lo1 = ksl_product_rest(x_sum, series5h, series5i, series5j - series5j_right)
          + (1.9572941063391263e-20 - series5j_right),
      series5i_cross = KSL_MUL(x_sum_lo, series5h)
          + KSL_MUL(x_sum, series5h_lo1 - -8.843177655482344e-40
          + (KSL_MUL(x_sum_lo, series5f) + series5g_cross2)), series5k = KSL_MUL(x_sum, series5j),
      series5l = series5k - 8.22063524662433e-18, series5l_right = series5k - series5l,
      series5l_lo1 = ksl_product_rest(x_sum, series5j, series5k, series5l + series5l_right)
          - (8.22063524662433e-18 - series5l_right),
      series5k_cross = KSL_MUL(x_sum_lo, series5j)
          + KSL_MUL(x_sum, series5j_lo1 + -1.3643503830087908e-36 + series5i_cross),
      series5m = KSL_MUL(x_sum, series5l), series5n = series5m + 2.8114572543455206e-15,
      series5n_right = series5n - series5m,
      series5n_lo1 = ksl_product_rest(x_sum, series5l, series5m, series5n - series5n_right)
          + (2.8114572543455206e-15 - series5n_right),
      series5m_cross = KSL_MUL(x_sum_lo, series5l)
          + KSL_MUL(x_sum, series5l_lo1 - 2.2141894119604265e-34 + series5k_cross),
      series5o = KSL_MUL(x_sum, series5n), series5p = series5o - 7.647163731819816e-13,
      series5p_right = series5o - series5p,
      series5p_lo1 = ksl_product_rest(x_sum, series5n, series5o, series5p + series5p_right)
          - (7.647163731819816e-13 - series5p_right),
      series5o_cross = KSL_MUL(x_sum_lo, series5n)
          + KSL_MUL(x_sum, series5n_lo1 + 1.6508842730861433e-31 + series5m_cross),
      series5q = KSL_MUL(x_sum, series5p), series5r = series5q + 1.6059043836821613e-10,
      series5r_right = series5r - series5q,
      series5r_lo1 = ksl_product_rest(x_sum, series5p, series5q, series5r - series5r_right)
          + (1.6059043836821613e-10 - series5r_right),
      series5q_cross = KSL_MUL(x_sum_lo, series5p)
          + KSL_MUL(x_sum, series5p_lo1 - 7.03872877733453e-30 + series5o_cross),
      series5s = KSL_MUL(x_sum, series5r), series5t = series5s - 2.505210838544172e-08,
      series5t_right = series5s - series5t,
      series5t_lo1 = ksl_product_rest(x_sum, series5r, series5s, series5t + series5t_right)
          - (2.505210838544172e-08 - series5t_right),
      series5s_cross = KSL_MUL(x_sum_lo, series5r)
          + KSL_MUL(x_sum, series5r_lo1 + 1.2585294588752098e-26 + series5q_cross),
      series5u = KSL_MUL(x_sum, series5t), series5v = series5u + 2.7557319223985893e-06,
      series5v_right = series5v - series5u,
      series5v_lo1 = ksl_product_rest(x_sum, series5t, series5u, series5v - series5v_right)
          + (2.7557319223985893e-06 - series5v_right),
      series5u_cross = KSL_MUL(x_sum_lo, series5t)
          + KSL_MUL(x_sum, series5t_lo1 - -1.448814070935912e-24 + series5s_cross),
      series5w = KSL_MUL(x_sum, series5v), series5x = series5w - 0.0001984126984126984,
      series5x_right = series5w - series5x,
      series5x_lo1 = ksl_product_rest(x_sum, series5v, series5w, series5x + series5x_right)
          - (0.0001984126984126984 - series5x_right),
      series5w_cross = KSL_MUL(x_sum_lo, series5v)
          + KSL_MUL(x_sum, series5v_lo1 + -1.858393274046472e-22 + series5u_cross),
      series5y = KSL_MUL(x_sum, series5x), series5 = series5y + 0.008333333333333333,
      series5_right = series5 - series5y,
      series5_lo2 = ksl_product_rest(x_sum, series5x, series5y, series5 - series5_right)
          + (0.008333333333333333 - series5_right) + 1.1564823173178714e-19;
  const double g3a = KSL_MUL(x_sum, series5),
      g3a_cross2 = KSL_MUL(x_sum, series5_lo2
          + (KSL_MUL(x_sum_lo, series5x)
          + KSL_MUL(x_sum, series5x_lo1 - 1.7209558293420705e-22 + series5w_cross))),
      g3b = 0.16666666666666666 - g3a, g3b_right = 0.16666666666666666 - g3b,
      g3b_lo2 = 0.16666666666666666 - (g3b + g3b_right)
          - ksl_product_rest(x_sum, series5, g3a, g3b_right)
          - (KSL_MUL(x_sum_lo, series5) + g3a_cross2), g3b_lo = g3b_lo2 + 9.25185853854297e-18,
      g3 = x_sum < 1.0 ? g3b : closed3;
  const double u_0a = KSL_MUL(s->m2, s->m4), u_0b = KSL_MUL(s->m1, s->m5), u_0 = u_0a - u_0b,
      u_0_right = u_0a - u_0;
  const double u_1a = KSL_MUL(s->m0, s->m5), u_1b = KSL_MUL(s->m2, s->m3), u_1 = u_1a - u_1b,
      u_1_right = u_1a - u_1;
  const double u_2a = KSL_MUL(s->m1, s->m3), u_2b = KSL_MUL(s->m0, s->m4), u_2 = u_2a - u_2b,
      u_2_right = u_2a - u_2;
  const double turned_0 = KSL_MUL(g2, u_0),
      turned_0_cross2 = KSL_MUL(g2, ksl_product_rest(s->m2, s->m4, u_0a, u_0 + u_0_right)
          - ksl_product_rest(s->m1, s->m5, u_0b, u_0_right));
  const double turned_1 = KSL_MUL(g2, u_1),
      turned_1_cross2 = KSL_MUL(g2, ksl_product_rest(s->m0, s->m5, u_1a, u_1 + u_1_right)
          - ksl_product_rest(s->m2, s->m3, u_1b, u_1_right));
  const double turned_2 = KSL_MUL(g2, u_2),
      turned_2_cross2 = KSL_MUL(g2, ksl_product_rest(s->m1, s->m3, u_2a, u_2 + u_2_right)
          - ksl_product_rest(s->m0, s->m4, u_2b, u_2_right));
  const double wv_a = KSL_MUL(s->m0, s->m3), wv_b = KSL_MUL(s->m1, s->m4), wv_c = wv_a + wv_b,
      wv_c_right = wv_c - wv_a, wv_d = KSL_MUL(s->m2, s->m5), wv = wv_c + wv_d,
      wv_right = wv - wv_c,
      wv_c_lo = ksl_product_rest(s->m0, s->m3, wv_a, wv_c - wv_c_right)
          + ksl_product_rest(s->m1, s->m4, wv_b, wv_c_right);
  const double pitch = KSL_MUL(g3, wv),
      pitch_cross2 = KSL_MUL(g3, wv_c - (wv - wv_right)
          + ksl_product_rest(s->m2, s->m5, wv_d, wv_right) + wv_c_lo);
  const double pitch_lo = ksl_product_error(g3, wv, pitch)
          + (KSL_MUL(x_sum < 1.0 ? g3b_lo : closed3_lo, wv) + pitch_cross2),
      along_0 = KSL_MUL(s->m3, pitch);
  const double along_1 = KSL_MUL(s->m4, pitch), along_2 = KSL_MUL(s->m5, pitch);
  const double beta_v_0 = KSL_MUL(s->m3, g2), beta_v_1 = KSL_MUL(s->m4, g2),
      beta_v_2 = KSL_MUL(s->m5, g2);
  const double beta_v_0_lo = ksl_product_error(s->m3, g2, beta_v_0) + KSL_MUL(s->m3, g2_cross2),
      m_0 = KSL_MUL(s->m3, beta_v_0), m_0_cross2 = KSL_MUL(s->m3, beta_v_0_lo);
  const double beta_v_1_lo = ksl_product_error(s->m4, g2, beta_v_1) + KSL_MUL(s->m4, g2_cross2),
      m_1 = KSL_MUL(s->m4, beta_v_1), m_1_cross2 = KSL_MUL(s->m4, beta_v_1_lo);
  const double m_2 = KSL_MUL(s->m5, beta_v_2),
      m_2_cross2 = KSL_MUL(s->m5, ksl_product_error(s->m5, g2, beta_v_2)
          + KSL_MUL(s->m5, g2_cross2));
  const double m_3 = KSL_MUL(s->m4, beta_v_0), m_3_cross2 = KSL_MUL(s->m4, beta_v_0_lo);
  const double m_4 = KSL_MUL(s->m5, beta_v_0), m_4_cross2 = KSL_MUL(s->m5, beta_v_0_lo);
  const double m_5 = KSL_MUL(s->m5, beta_v_1), m_5_cross2 = KSL_MUL(s->m5, beta_v_1_lo);
  const double others_0 = m_1 + m_2, others_0_right = others_0 - m_1,
      others_0_lo1 = ksl_product_rest(s->m4, beta_v_1, m_1, others_0 - others_0_right)
          + ksl_product_rest(s->m5, beta_v_2, m_2, others_0_right),
      others_0_lo = others_0_lo1 + (m_1_cross2 + m_2_cross2);
  const double others_1 = m_0 + m_2, others_1_right = others_1 - m_0,
      others_1_lo1 = ksl_product_rest(s->m3, beta_v_0, m_0, others_1 - others_1_right)
          + ksl_product_rest(s->m5, beta_v_2, m_2, others_1_right),
      others_1_lo = others_1_lo1 + (m_0_cross2 + m_2_cross2);
  const double others_2 = m_0 + m_1, others_2_right = others_2 - m_0,
      others_2_lo1 = ksl_product_rest(s->m3, beta_v_0, m_0, others_2 - others_2_right)
          + ksl_product_rest(s->m4, beta_v_1, m_1, others_2_right),
      others_2_lo = others_2_lo1 + (m_0_cross2 + m_1_cross2);
  const double diagonal0a = 1.0 - others_0, diagonal0a_right = 1.0 - diagonal0a,
      diagonal0a_lo = 1.0 - (diagonal0a + diagonal0a_right) - (others_0 - diagonal0a_right)
          - others_0_lo, diagonal0b = g0 + m_0, diagonal0b_right = diagonal0b - g0,
      diagonal0b_lo = g0 - (diagonal0b - diagonal0b_right)
          + ksl_product_rest(s->m3, beta_v_0, m_0, diagonal0b_right) + m_0_cross2 + g0_lo,
      m_0_sum = m_0 + (ksl_product_error(s->m3, beta_v_0, m_0) + m_0_cross2),
      others_0_sum = others_0 + others_0_lo,
      diagonal0 = m_0_sum < others_0_sum ? diagonal0b : diagonal0a;
  const double diagonal1a = 1.0 - others_1, diagonal1a_right = 1.0 - diagonal1a,
      diagonal1a_lo = 1.0 - (diagonal1a + diagonal1a_right) - (others_1 - diagonal1a_right)
          - others_1_lo, diagonal1b = g0 + m_1, diagonal1b_right = diagonal1b - g0,
      diagonal1b_lo = g0 - (diagonal1b - diagonal1b_right)
          + ksl_product_rest(s->m4, beta_v_1, m_1, diagonal1b_right) + m_1_cross2 + g0_lo,
      m_1_sum = m_1 + (ksl_product_error(s->m4, beta_v_1, m_1) + m_1_cross2),
      others_1_sum = others_1 + others_1_lo,
      diagonal1 = m_1_sum < others_1_sum ? diagonal1b : diagonal1a;
  const double diagonal2a = 1.0 - others_2, diagonal2a_right = 1.0 - diagonal2a,
      diagonal2a_lo = 1.0 - (diagonal2a + diagonal2a_right) - (others_2 - diagonal2a_right)
          - others_2_lo, diagonal2b = g0 + m_2, diagonal2b_right = diagonal2b - g0,
      diagonal2b_lo = g0 - (diagonal2b - diagonal2b_right)
          + ksl_product_rest(s->m5, beta_v_2, m_2, diagonal2b_right) + m_2_cross2 + g0_lo,
      m_2_sum = m_2 + (ksl_product_error(s->m5, beta_v_2, m_2) + m_2_cross2),
      others_2_sum = others_2 + others_2_lo,
      diagonal2 = m_2_sum < others_2_sum ? diagonal2b : diagonal2a;
  const double g1_lo = ksl_product_error(c, sinc, g1) + g1_cross, alpha_v_0 = KSL_MUL(s->m3, g1),
      alpha_v_0_cross2 = KSL_MUL(s->m3, g1_lo);
  const double alpha_v_1 = KSL_MUL(s->m4, g1), alpha_v_1_cross2 = KSL_MUL(s->m4, g1_lo);
  const double alpha_v_2 = KSL_MUL(s->m5, g1), alpha_v_2_cross2 = KSL_MUL(s->m5, g1_lo);
  const double across_axis_0 = turned_0 + along_0, across_axis_0_right = across_axis_0 - turned_0,
      across_axis_0_left_rest = ksl_product_rest(g2, u_0, turned_0, across_axis_0
          - across_axis_0_right),
      across_axis_0_lo1 = across_axis_0_left_rest
          + ksl_product_rest(s->m3, pitch, along_0, across_axis_0_right);
  const double across_axis_1 = turned_1 + along_1, across_axis_1_right = across_axis_1 - turned_1,
      across_axis_1_left_rest = ksl_product_rest(g2, u_1, turned_1, across_axis_1
          - across_axis_1_right),
      across_axis_1_lo1 = across_axis_1_left_rest
          + ksl_product_rest(s->m4, pitch, along_1, across_axis_1_right);
  const double across_axis_2 = turned_2 + along_2, across_axis_2_right = across_axis_2 - turned_2,
      across_axis_2_left_rest = ksl_product_rest(g2, u_2, turned_2, across_axis_2
          - across_axis_2_right),
      across_axis_2_lo1 = across_axis_2_left_rest
          + ksl_product_rest(s->m5, pitch, along_2, across_axis_2_right);
  const double D_01 = m_3 - alpha_v_2, D_01_right = m_3 - D_01,
      D_01_lo1 = ksl_product_rest(s->m4, beta_v_0, m_3, D_01 + D_01_right)
          - ksl_product_rest(s->m5, g1, alpha_v_2, D_01_right);
  const double D_02 = m_4 + alpha_v_1, D_02_right = D_02 - m_4,
      D_02_lo1 = ksl_product_rest(s->m5, beta_v_0, m_4, D_02 - D_02_right)
          + ksl_product_rest(s->m4, g1, alpha_v_1, D_02_right);
  const double D_03a = KSL_MUL(s->m0, g1), D_03 = D_03a + across_axis_0, D_03_right = D_03 - D_03a;
  const double across_axis_0_lo = across_axis_0_lo1
          + (KSL_MUL(g2_cross2, u_0) + turned_0_cross2 + KSL_MUL(s->m3, pitch_lo));
  const double D_10 = m_3 + alpha_v_2, D_10_right = D_10 - m_3,
      D_10_lo1 = ksl_product_rest(s->m4, beta_v_0, m_3, D_10 - D_10_right)
          + ksl_product_rest(s->m5, g1, alpha_v_2, D_10_right);
  const double D_12 = m_5 - alpha_v_0, D_12_right = m_5 - D_12,
      D_12_lo1 = ksl_product_rest(s->m5, beta_v_1, m_5, D_12 + D_12_right)
          - ksl_product_rest(s->m3, g1, alpha_v_0, D_12_right);
  const double D_13a = KSL_MUL(s->m1, g1), D_13 = D_13a + across_axis_1, D_13_right = D_13 - D_13a;
  const double across_axis_1_lo = across_axis_1_lo1
          + (KSL_MUL(g2_cross2, u_1) + turned_1_cross2 + KSL_MUL(s->m4, pitch_lo));
  const double D_20 = m_4 - alpha_v_1, D_20_right = m_4 - D_20,
      D_20_lo1 = ksl_product_rest(s->m5, beta_v_0, m_4, D_20 + D_20_right)
          - ksl_product_rest(s->m4, g1, alpha_v_1, D_20_right);
  const double D_21 = m_5 + alpha_v_0, D_21_right = D_21 - m_5,
      D_21_lo1 = ksl_product_rest(s->m5, beta_v_1, m_5, D_21 - D_21_right)
          + ksl_product_rest(s->m3, g1, alpha_v_0, D_21_right);
  const double D_23a = KSL_MUL(s->m2, g1), D_23 = D_23a + across_axis_2, D_23_right = D_23 - D_23a;
  const double across_axis_2_lo = across_axis_2_lo1
          + (KSL_MUL(g2_cross2, u_2) + turned_2_cross2 + KSL_MUL(s->m5, pitch_lo));
  const double diagonal0_rounded = diagonal0
          + (m_0_sum < others_0_sum ? diagonal0b_lo : diagonal0a_lo);
  const double D_01_rounded = D_01 + (D_01_lo1 + (m_3_cross2 - alpha_v_2_cross2));
  const double D_02_rounded = D_02 + (D_02_lo1 + (m_4_cross2 + alpha_v_1_cross2));
  const double D_03_lo = ksl_product_rest(s->m0, g1, D_03a, D_03 - D_03_right)
          + (across_axis_0 - D_03_right) + across_axis_0_lo + KSL_MUL(s->m0, g1_lo);
  const double D_03_rounded = D_03 + D_03_lo;
  const double D_10_rounded = D_10 + (D_10_lo1 + (m_3_cross2 + alpha_v_2_cross2));
  const double diagonal1_rounded = diagonal1
          + (m_1_sum < others_1_sum ? diagonal1b_lo : diagonal1a_lo);
  const double D_12_rounded = D_12 + (D_12_lo1 + (m_5_cross2 - alpha_v_0_cross2));
  const double D_13_lo = ksl_product_rest(s->m1, g1, D_13a, D_13 - D_13_right)
          + (across_axis_1 - D_13_right) + across_axis_1_lo + KSL_MUL(s->m1, g1_lo);
  const double D_13_rounded = D_13 + D_13_lo;
  const double D_20_rounded = D_20 + (D_20_lo1 + (m_4_cross2 - alpha_v_1_cross2));
  const double D_21_rounded = D_21 + (D_21_lo1 + (m_5_cross2 + alpha_v_0_cross2));
  const double diagonal2_rounded = diagonal2
          + (m_2_sum < others_2_sum ? diagonal2b_lo : diagonal2a_lo);
  const double D_23_lo = ksl_product_rest(s->m2, g1, D_23a, D_23 - D_23_right)
          + (across_axis_2 - D_23_right) + across_axis_2_lo + KSL_MUL(s->m2, g1_lo);
  const double D_23_rounded = D_23 + D_23_lo;
  const double diagonal0_final = diagonal0_rounded == diagonal0_rounded ? diagonal0_rounded
          : diagonal0;
  const double D_01_final = D_01_rounded == D_01_rounded ? D_01_rounded : D_01;
  const double D_02_final = D_02_rounded == D_02_rounded ? D_02_rounded : D_02;
  const double D_03_final = D_03_rounded == D_03_rounded ? D_03_rounded : D_03;
  const double D_10_final = D_10_rounded == D_10_rounded ? D_10_rounded : D_10;
  const double diagonal1_final = diagonal1_rounded == diagonal1_rounded ? diagonal1_rounded
          : diagonal1;
  const double D_12_final = D_12_rounded == D_12_rounded ? D_12_rounded : D_12;
  const double D_13_final = D_13_rounded == D_13_rounded ? D_13_rounded : D_13;
  const double D_20_final = D_20_rounded == D_20_rounded ? D_20_rounded : D_20;
  const double D_21_final = D_21_rounded == D_21_rounded ? D_21_rounded : D_21;
  const double diagonal2_final = diagonal2_rounded == diagonal2_rounded ? diagonal2_rounded
          : diagonal2;
  const double D_23_final = D_23_rounded == D_23_rounded ? D_23_rounded : D_23;
  D->m00 = diagonal0_final;
  D->m01 = D_01_final;
  D->m02 = D_02_final;
  D->m03 = D_03_final;
  D->m10 = D_10_final;
  D->m11 = diagonal1_final;
  D->m12 = D_12_final;
  D->m13 = D_13_final;
  D->m20 = D_20_final;
  D->m21 = D_21_final;
  D->m22 = diagonal2_final;
  D->m23 = D_23_final;
}

/* so with exp so = D, |ω| <= π: (J_l(ω)^-1 t; ω), ω = log R.
   D: displacement [R | t], R rotation, t in m; so: screw (v in m/s; ω in rad/s).
   285 mul, 748 add, 36 product error, 36 product rest, 23 div, 2 sqrt, 12 neg, 14 abs, 4
     copysign, 32 less, 13 equal, 88 select.
   Error <= lin: 1 u, ang: 1 u of its largest component for R of D a rotation; searched, not
     proved.  Each component is within 1 ulp as long as its condition is below 1e13; in single
     precision it is the nearest number, except near ties, as long as that is below 1e5;
     searched, not proved.  Intermediate sums may overflow where |t| is above 2e306, in single
     precision 5e36. */
static inline void ksl_SE3_log_accurate(const ksl_SE3_t *D, ksl_screw_t *so) {
  const double p_0 = D->m21 - D->m12, p_0_right = D->m21 - p_0,
      p_0_lo = D->m21 - (p_0 + p_0_right) - (D->m12 - p_0_right);
  const double p_1 = D->m02 - D->m20, p_1_right = D->m02 - p_1,
      p_1_lo = D->m02 - (p_1 + p_1_right) - (D->m20 - p_1_right);
  const double p_2 = D->m10 - D->m01, p_2_right = D->m10 - p_2,
      p_2_lo = D->m10 - (p_2 + p_2_right) - (D->m01 - p_2_right);
  const double s_0 = D->m12 + D->m21, s_0_right = s_0 - D->m12,
      s_0_lo = D->m12 - (s_0 - s_0_right) + (D->m21 - s_0_right);
  const double s_1 = D->m02 + D->m20, s_1_right = s_1 - D->m02,
      s_1_lo = D->m02 - (s_1 - s_1_right) + (D->m20 - s_1_right);
  const double s_2 = D->m01 + D->m10, s_2_right = s_2 - D->m01,
      s_2_lo = D->m01 - (s_2 - s_2_right) + (D->m10 - s_2_right);
  const double first_0 = D->m00 + 1.0, first_0_right = first_0 - D->m00,
      first_0_lo = D->m00 - (first_0 - first_0_right) + (1.0 - first_0_right);
  const double first_1 = 1.0 - D->m00, first_1_right = 1.0 - first_1,
      first_1_lo = 1.0 - (first_1 + first_1_right) - (D->m00 - first_1_right);
  const double others_0 = D->m11 + D->m22, others_0_right = others_0 - D->m11,
      others_0_lo = D->m11 - (others_0 - others_0_right) + (D->m22 - others_0_right);
  const double others_1 = D->m11 - D->m22, others_1_right = D->m11 - others_1,
      others_1_lo = D->m11 - (others_1 + others_1_right) - (D->m22 - others_1_right);
  const double d_0 = first_0 + others_0, d_0_right = d_0 - first_0,
      d_0_lo = first_0 - (d_0 - d_0_right) + (others_0 - d_0_right) + others_0_lo + first_0_lo;
  const double d_1 = first_0 - others_0, d_1_right = first_0 - d_1,
      d_1_lo = first_0 - (d_1 + d_1_right) - (others_0 - d_1_right) - others_0_lo + first_0_lo;
  const double d_2 = first_1 + others_1, d_2_right = d_2 - first_1,
      d_2_lo = first_1 - (d_2 - d_2_right) + (others_1 - d_2_right) + others_1_lo + first_1_lo;
  const double d_3 = first_1 - others_1, d_3_right = first_1 - d_3,
      d_3_lo = first_1 - (d_3 + d_3_right) - (others_1 - d_3_right) - others_1_lo + first_1_lo;
  const double low_0 = D->m11 < D->m00 ? d_1 : s_2, low_0_lo = D->m11 < D->m00 ? d_1_lo : s_2_lo;
  const double low_1 = D->m11 < D->m00 ? s_2 : d_2, low_1_lo = D->m11 < D->m00 ? s_2_lo : d_2_lo;
  const double low_2 = D->m11 < D->m00 ? s_1 : s_0, low_2_lo = D->m11 < D->m00 ? s_1_lo : s_0_lo;
  const double low_3 = D->m11 < D->m00 ? p_0 : p_1, low_3_lo = D->m11 < D->m00 ? p_0_lo : p_1_lo;
  const double high_0a = -D->m11, high_0 = D->m00 < high_0a ? s_1 : p_0,
      high_0_lo = D->m00 < high_0a ? s_1_lo : p_0_lo;
  const double high_1 = D->m00 < high_0a ? s_0 : p_1,
      high_1_lo = D->m00 < high_0a ? s_0_lo : p_1_lo;
  const double high_2 = D->m00 < high_0a ? d_3 : p_2,
      high_2_lo = D->m00 < high_0a ? d_3_lo : p_2_lo;
  const double high_3 = D->m00 < high_0a ? p_2 : d_0,
      high_3_lo = D->m00 < high_0a ? p_2_lo : d_0_lo;
  const double column_0 = D->m22 < 0.0 ? low_0 : high_0,
      column_0_lo = D->m22 < 0.0 ? low_0_lo : high_0_lo;
  const double column_1 = D->m22 < 0.0 ? low_1 : high_1,
      column_1_lo = D->m22 < 0.0 ? low_1_lo : high_1_lo;
  const double column_2 = D->m22 < 0.0 ? low_2 : high_2,
      column_2_lo = D->m22 < 0.0 ? low_2_lo : high_2_lo;
  const double column_3 = D->m22 < 0.0 ? low_3 : high_3,
      column_3_lo = D->m22 < 0.0 ? low_3_lo : high_3_lo;
  const double upper_0a = -column_0, upper_0a_lo = -column_0_lo,
      column_3_sum = column_3 + column_3_lo, column_3_sum_right = column_3_sum - column_3,
      column_3_sum_lo = column_3 - (column_3_sum - column_3_sum_right)
          + (column_3_lo - column_3_sum_right), upper_0 = column_3_sum < 0.0 ? upper_0a : column_0,
      upper_0_lo = column_3_sum < 0.0 ? upper_0a_lo : column_0_lo;
  const double upper_1a = -column_1, upper_1a_lo = -column_1_lo,
      upper_1 = column_3_sum < 0.0 ? upper_1a : column_1,
      upper_1_lo = column_3_sum < 0.0 ? upper_1a_lo : column_1_lo;
  const double upper_2a = -column_2, upper_2a_lo = -column_2_lo,
      upper_2 = column_3_sum < 0.0 ? upper_2a : column_2,
      upper_2_lo = column_3_sum < 0.0 ? upper_2a_lo : column_2_lo;
  const double upper_3 = fabs(column_3_sum), upper_3_opposite = -column_3_sum_lo,
      upper_3_lo = column_3_sum < 0.0 ? upper_3_opposite : column_3_sum_lo;
  const double upper_0_sum = upper_0 + upper_0_lo, upper_0_sum_right = upper_0_sum - upper_0,
      upper_0_sum_lo = upper_0 - (upper_0_sum - upper_0_sum_right)
          + (upper_0_lo - upper_0_sum_right), v_s_size_0 = fabs(upper_0_sum),
      v_s_size_0_opposite = -upper_0_sum_lo,
      v_s_size_0_lo = upper_0_sum < 0.0 ? v_s_size_0_opposite : upper_0_sum_lo;
  const double upper_1_sum = upper_1 + upper_1_lo, upper_1_sum_right = upper_1_sum - upper_1,
      upper_1_sum_lo = upper_1 - (upper_1_sum - upper_1_sum_right)
          + (upper_1_lo - upper_1_sum_right), v_s_size_1 = fabs(upper_1_sum),
      v_s_size_1_opposite = -upper_1_sum_lo,
      v_s_size_1_lo = upper_1_sum < 0.0 ? v_s_size_1_opposite : upper_1_sum_lo;
  const double upper_2_sum = upper_2 + upper_2_lo, upper_2_sum_right = upper_2_sum - upper_2,
      upper_2_sum_lo = upper_2 - (upper_2_sum - upper_2_sum_right)
          + (upper_2_lo - upper_2_sum_right), v_s_size_2 = fabs(upper_2_sum),
      v_s_size_2_opposite = -upper_2_sum_lo,
      v_s_size_2_lo = upper_2_sum < 0.0 ? v_s_size_2_opposite : upper_2_sum_lo;
  const double v_s_size_0_sum = v_s_size_0 + v_s_size_0_lo,
      v_s_size_0_sum_right = v_s_size_0_sum - v_s_size_0,
      v_s_size_0_sum_lo = v_s_size_0 - (v_s_size_0_sum - v_s_size_0_sum_right)
          + (v_s_size_0_lo - v_s_size_0_sum_right), v_s_size_1_sum = v_s_size_1 + v_s_size_1_lo,
      v_s_size_1_sum_right = v_s_size_1_sum - v_s_size_1,
      v_s_size_1_sum_lo = v_s_size_1 - (v_s_size_1_sum - v_s_size_1_sum_right)
          + (v_s_size_1_lo - v_s_size_1_sum_right),
      v_s_largest1 = v_s_size_0_sum < v_s_size_1_sum ? v_s_size_1_sum : v_s_size_0_sum,
      v_s_largest1_lo = v_s_size_0_sum < v_s_size_1_sum ? v_s_size_1_sum_lo : v_s_size_0_sum_lo;
  const double v_s_largest1_sum = v_s_largest1 + v_s_largest1_lo,
      v_s_largest1_sum_right = v_s_largest1_sum - v_s_largest1,
      v_s_largest1_sum_lo = v_s_largest1 - (v_s_largest1_sum - v_s_largest1_sum_right)
          + (v_s_largest1_lo - v_s_largest1_sum_right), v_s_size_2_sum = v_s_size_2 + v_s_size_2_lo,
      v_s_size_2_sum_right = v_s_size_2_sum - v_s_size_2,
      v_s_size_2_sum_lo = v_s_size_2 - (v_s_size_2_sum - v_s_size_2_sum_right)
          + (v_s_size_2_lo - v_s_size_2_sum_right),
      v_s_largest2 = v_s_largest1_sum < v_s_size_2_sum ? v_s_size_2_sum : v_s_largest1_sum;
  const double v_s_largest2_sum = v_s_largest2
          + (v_s_largest1_sum < v_s_size_2_sum ? v_s_size_2_sum_lo : v_s_largest1_sum_lo),
      v_s_b = 6.703903964971299e+153 < v_s_largest2_sum ? 3.7291703656001034e-155 : 1.0,
      v_s_d = v_s_largest2_sum < 256.0 ? 1.3093562431584567e+151 : v_s_b,
      v_s = v_s_largest2_sum < 1.955159272639747e-149 ? 1.0715086071862673e+301 : v_s_d;
  const double v_y_0 = KSL_MUL(upper_0_sum, v_s), v_y_0_inverse = 1.0 / v_s,
      v_y_0_lo = KSL_MUL(upper_0_sum - KSL_MUL(v_y_0, v_y_0_inverse) + upper_0_sum_lo, v_s);
  const double v_y_1 = KSL_MUL(upper_1_sum, v_s),
      v_y_1_lo = KSL_MUL(upper_1_sum - KSL_MUL(v_y_1, v_y_0_inverse) + upper_1_sum_lo, v_s);
  const double v_y_2 = KSL_MUL(upper_2_sum, v_s),
      v_y_2_lo = KSL_MUL(upper_2_sum - KSL_MUL(v_y_2, v_y_0_inverse) + upper_2_sum_lo, v_s);
  const double v_n_a = KSL_MUL(v_y_0, v_y_0), v_n_b = KSL_MUL(v_y_1, v_y_1), v_n_c = v_n_a + v_n_b,
      v_n_c_right = v_n_c - v_n_a,
      v_n_c_lo1 = ksl_product_rest(v_y_0, v_y_0, v_n_a, v_n_c - v_n_c_right)
          + ksl_product_rest(v_y_1, v_y_1, v_n_b, v_n_c_right), v_n_d = KSL_MUL(v_y_2, v_y_2),
      v_n_e = v_n_c + v_n_d, v_n_e_right = v_n_e - v_n_c,
      v_n_e_lo2 = v_n_c - (v_n_e - v_n_e_right)
          + ksl_product_rest(v_y_2, v_y_2, v_n_d, v_n_e_right)
          + (KSL_MUL(v_y_2_lo, v_y_2) + KSL_MUL(v_y_2, v_y_2_lo)),
      v_n_e_lo = v_n_e_lo2
          + (v_n_c_lo1
          + (KSL_MUL(v_y_0_lo, v_y_0) + KSL_MUL(v_y_0, v_y_0_lo)
          + (KSL_MUL(v_y_1_lo, v_y_1) + KSL_MUL(v_y_1, v_y_1_lo)))), v_n_e_sum = v_n_e + v_n_e_lo,
      v_n_e_sum_right = v_n_e_sum - v_n_e, v_n = sqrt(v_n_e_sum), v_n_product = KSL_MUL(v_n, v_n),
      v_n_e_sum_lo = v_n_e - (v_n_e_sum - v_n_e_sum_right) + (v_n_e_lo - v_n_e_sum_right),
      v_n_twice = v_n + v_n,
      v_n_lo = (v_n_e_sum - v_n_product - ksl_product_error(v_n, v_n, v_n_product) + v_n_e_sum_lo)
          / (v_n == 0.0 ? 1.0 : v_n_twice);
  const double v_r_b = v_s < 1.0 ? 2.6815615859885194e+154 : 1.0,
      v_r_d = 1.0 < v_s ? 7.637340908749012e-152 : v_r_b,
      v_r = 1.3093562431584567e+151 < v_s ? 9.332636185032189e-302 : v_r_d;
  const double v_n_sum = v_n + v_n_lo, v_n_sum_right = v_n_sum - v_n, n = KSL_MUL(v_n_sum, v_r),
      n_lo = KSL_MUL(v_n_sum - KSL_MUL(n, 1.0 / v_r)
          + (v_n - (v_n_sum - v_n_sum_right) + (v_n_lo - v_n_sum_right)), v_r);
  const double n_sum = n + n_lo, n_sum_right = n_sum - n,
      n_sum_lo = n - (n_sum - n_sum_right) + (n_lo - n_sum_right),
      upper_3_sum = upper_3 + upper_3_lo, upper_3_sum_right = upper_3_sum - upper_3,
      upper_3_sum_lo = upper_3 - (upper_3_sum - upper_3_sum_right)
          + (upper_3_lo - upper_3_sum_right), half = ksl_atan2(n_sum, upper_3_sum),
      half_size0 = fabs(n_sum), half_size1 = fabs(upper_3_sum),
      half_most = half_size0 < half_size1 ? half_size1 : half_size0,
      half_divisor = half_most == 0.0 ? 1.0 : half_most, half_part0 = n_sum / half_divisor,
      half_part1 = upper_3_sum / half_divisor,
      half_divisor2 = KSL_MUL(half_divisor, KSL_MUL(half_part1, half_part1)
          + KSL_MUL(half_part0, half_part0)),
      half_more = (KSL_MUL(half_part1, n_sum_lo) - KSL_MUL(half_part0, upper_3_sum_lo))
          / (half_most == 0.0 ? 1.0 : half_divisor2);
  const double divisor = n_sum == 0.0 ? 1.0 : n_sum, divisor_lo = n_sum == 0.0 ? 0.0 : n_sum_lo;
  const double theta = KSL_MUL(2.0, half),
      theta_cross2 = KSL_MUL(2.0, ksl_atan2_error(n_sum, upper_3_sum, half) + half_more);
  const double theta_sum = theta + theta_cross2, theta_sum_right = theta_sum - theta,
      theta_sum_lo = theta - (theta_sum - theta_sum_right) + (theta_cross2 - theta_sum_right),
      divisor_sum = divisor + divisor_lo, divisor_sum_right = divisor_sum - divisor,
      k = theta_sum / divisor_sum, k_product = KSL_MUL(k, divisor_sum),
      k_cross = KSL_MUL(k, divisor - (divisor_sum - divisor_sum_right)
          + (divisor_lo - divisor_sum_right)),
      k_lo = (theta_sum - k_product - ksl_product_error(k, divisor_sum, k_product) + theta_sum_lo
          - k_cross) / divisor_sum;
  const double vector_0 = KSL_MUL(upper_0_sum, k), vector_1 = KSL_MUL(upper_1_sum, k),
      vector_2 = KSL_MUL(upper_2_sum, k);
  const double half_angle = KSL_MUL(0.5, theta_sum), half_angle_cross2 = KSL_MUL(0.5, theta_sum_lo);
  const double length_a = KSL_MUL(n_sum, n_sum), length_b = KSL_MUL(upper_3_sum, upper_3_sum),
      length_c = length_a + length_b, length_c_right = length_c - length_a,
      length_c_right_rest = ksl_product_rest(upper_3_sum, upper_3_sum, length_b, length_c_right),
      length_c_cross = KSL_MUL(n_sum_lo, n_sum) + KSL_MUL(n_sum, n_sum_lo)
          + (KSL_MUL(upper_3_sum_lo, upper_3_sum) + KSL_MUL(upper_3_sum, upper_3_sum_lo)),
      length_c_lo = ksl_product_rest(n_sum, n_sum, length_a, length_c - length_c_right)
          + length_c_right_rest + length_c_cross, length_c_sum = length_c + length_c_lo,
      length_c_sum_right = length_c_sum - length_c, length = sqrt(length_c_sum),
      length_product = KSL_MUL(length, length),
      length_c_sum_lo = length_c - (length_c_sum - length_c_sum_right)
          + (length_c_lo - length_c_sum_right), length_twice = length + length,
      length_residual = length_c_sum - length_product
          - ksl_product_error(length, length, length_product) + length_c_sum_lo,
      length_lo = length_residual / (length == 0.0 ? 1.0 : length_twice);
  const double length_sum = length + length_lo, length_sum_right = length_sum - length,
      length_sum_lo = length - (length_sum - length_sum_right) + (length_lo - length_sum_right),
      sine = n_sum / length_sum, sine_product = KSL_MUL(sine, length_sum),
      sine_lo = (n_sum - sine_product - ksl_product_error(sine, length_sum, sine_product)
          + n_sum_lo - KSL_MUL(sine, length_sum_lo)) / length_sum;
  const double c = upper_3_sum / length_sum, c_product = KSL_MUL(c, length_sum),
      c_lo = (upper_3_sum - c_product - ksl_product_error(c, length_sum, c_product)
          + upper_3_sum_lo - KSL_MUL(c, length_sum_lo)) / length_sum;
  const double y = KSL_MUL(half_angle, half_angle);
  const double half_angle_sum = half_angle + half_angle_cross2,
      half_angle_sum_right = half_angle_sum - half_angle,
      half_angle_sum_lo = half_angle - (half_angle_sum - half_angle_sum_right)
          + (half_angle_cross2 - half_angle_sum_right),
      sinc_divisor = half_angle_sum < 1.4901161193847656e-08 ? 1.4901161193847656e-08
          : half_angle_sum,
      sinc_divisor_lo = half_angle_sum < 1.4901161193847656e-08 ? 0.0 : half_angle_sum_lo;
  const double sine_sum = sine + sine_lo, sine_sum_right = sine_sum - sine,
      sinc_divisor_sum = sinc_divisor + sinc_divisor_lo,
      sinc_divisor_sum_right = sinc_divisor_sum - sinc_divisor,
      sinc_quotient = sine_sum / sinc_divisor_sum,
      sinc_quotient_product = KSL_MUL(sinc_quotient, sinc_divisor_sum),
      sinc_quotient_exact = sine_sum - sinc_quotient_product
          - ksl_product_error(sinc_quotient, sinc_divisor_sum, sinc_quotient_product),
      sinc_quotient_cross = KSL_MUL(sinc_quotient, sinc_divisor
          - (sinc_divisor_sum - sinc_divisor_sum_right)
          + (sinc_divisor_lo - sinc_divisor_sum_right)),
      sinc_quotient_lo = (sinc_quotient_exact
          + (sine - (sine_sum - sine_sum_right) + (sine_lo - sine_sum_right))
          - sinc_quotient_cross) / sinc_divisor_sum;
  const double y_lo = ksl_product_error(half_angle, half_angle, y)
          + (KSL_MUL(half_angle_cross2, half_angle) + KSL_MUL(half_angle, half_angle_cross2)),
      sinc_a = KSL_MUL(0.16666666666666666, y), sinc_b = 1.0 - sinc_a, sinc_b_right = 1.0 - sinc_b,
      sinc_b_lo1 = 1.0 - (sinc_b + sinc_b_right)
          - ksl_product_rest(0.16666666666666666, y, sinc_a, sinc_b_right),
      sinc_b_lo = sinc_b_lo1
          - (KSL_MUL(9.25185853854297e-18, y) + KSL_MUL(0.16666666666666666, y_lo)),
      sinc = half_angle_sum < 1.4901161193847656e-08 ? sinc_b : sinc_quotient,
      sinc_lo = half_angle_sum < 1.4901161193847656e-08 ? sinc_b_lo : sinc_quotient_lo;
  const double series_phi_a = KSL_MUL(5.107725174524775e-32, y),
      series_phi_b = 4.116826490666969e-29 - series_phi_a,
      series_phi_b_right = 4.116826490666969e-29 - series_phi_b,
      series_phi_b_right_rest = ksl_product_rest(5.107725174524775e-32, y, series_phi_a,
          series_phi_b_right),
      series_phi_b_lo1 = 4.116826490666969e-29 - (series_phi_b + series_phi_b_right)
          - series_phi_b_right_rest, series_phi_c = KSL_MUL(y, series_phi_b),
      series_phi_b_lo = series_phi_b_lo1
          - (KSL_MUL(4.7410392187559056e-48, y) + KSL_MUL(5.107725174524775e-32, y_lo)) +
          -1.8714974010023092e-45, series_phi_d = series_phi_c - 2.86531123750421e-26,
      series_phi_d_right = series_phi_c - series_phi_d,
      series_phi_d_lo1 = ksl_product_rest(y, series_phi_b, series_phi_c, series_phi_d
          + series_phi_d_right) - (2.86531123750421e-26 - series_phi_d_right),
      series_phi_e = KSL_MUL(y, series_phi_d),
      series_phi_e_cross2 = KSL_MUL(y, series_phi_d_lo1 - 2.3296034284323186e-42
          + (KSL_MUL(y_lo, series_phi_b) + KSL_MUL(y, series_phi_b_lo))),
      series_phi_f = series_phi_e + 1.701994875077501e-23,
      series_phi_f_right = series_phi_f - series_phi_e,
      series_phi_f_lo1 = ksl_product_rest(y, series_phi_d, series_phi_e, series_phi_f
          - series_phi_f_right) + (1.701994875077501e-23 - series_phi_f_right),
      series_phi_g = KSL_MUL(y, series_phi_f),
      series_phi_g_cross2 = KSL_MUL(y, series_phi_f_lo1 + 3.161967936521494e-40
          + (KSL_MUL(y_lo, series_phi_d) + series_phi_e_cross2)),
      series_phi_h = series_phi_g - 8.509974375387505e-21,
      series_phi_h_right = series_phi_g - series_phi_h,
      series_phi_h_lo1 = ksl_product_rest(y, series_phi_f, series_phi_g, series_phi_h
          + series_phi_h_right) - (8.509974375387505e-21 - series_phi_h_right),
      series_phi_i = KSL_MUL(y, series_phi_h),
      series_phi_i_cross2 = KSL_MUL(y, series_phi_h_lo1 - 3.2266760594119493e-37
          + (KSL_MUL(y_lo, series_phi_f) + series_phi_g_cross2)),
      series_phi_j = series_phi_i + 3.523129391410427e-18,
      series_phi_j_right = series_phi_j - series_phi_i,
      series_phi_j_lo1 = ksl_product_rest(y, series_phi_h, series_phi_i, series_phi_j
          - series_phi_j_right) + (3.523129391410427e-18 - series_phi_j_right),
      series_phi_k = KSL_MUL(y, series_phi_j),
      series_phi_k_cross2 = KSL_MUL(y, series_phi_j_lo1 + -1.2521244741738012e-34
          + (KSL_MUL(y_lo, series_phi_h) + series_phi_i_cross2)),
      series_phi_l = series_phi_k - 1.1837714755139035e-15,
      series_phi_l_right = series_phi_k - series_phi_l,
      series_phi_l_lo1 = ksl_product_rest(y, series_phi_j, series_phi_k, series_phi_l
          + series_phi_l_right) - (1.1837714755139035e-15 - series_phi_l_right),
      series_phi_m = KSL_MUL(y, series_phi_l),
      series_phi_m_cross2 = KSL_MUL(y, series_phi_l_lo1 - 7.23242424407352e-33
          + (KSL_MUL(y_lo, series_phi_j) + series_phi_k_cross2)),
      series_phi_n = series_phi_m + 3.148832124866983e-13,
      series_phi_n_right = series_phi_n - series_phi_m,
      series_phi_n_lo1 = ksl_product_rest(y, series_phi_l, series_phi_m, series_phi_n
          - series_phi_n_right) + (3.148832124866983e-13 - series_phi_n_right),
      series_phi_o = KSL_MUL(y, series_phi_n),
      series_phi_o_cross2 = KSL_MUL(y, series_phi_n_lo1 + 5.8681293750286156e-30
          + (KSL_MUL(y_lo, series_phi_l) + series_phi_m_cross2)),
      series_phi_p = series_phi_o - 6.423617534728645e-11,
      series_phi_p_right = series_phi_o - series_phi_p,
      series_phi_p_lo1 = ksl_product_rest(y, series_phi_n, series_phi_o, series_phi_p
          + series_phi_p_right) - (6.423617534728645e-11 - series_phi_p_right),
      series_phi_q = KSL_MUL(y, series_phi_p),
      series_phi_q_cross2 = KSL_MUL(y, series_phi_p_lo1 - 5.034117835500839e-27
          + (KSL_MUL(y_lo, series_phi_n) + series_phi_o_cross2)),
      series_phi_r = series_phi_q + 9.635426302092969e-09,
      series_phi_r_right = series_phi_r - series_phi_q,
      series_phi_r_lo1 = ksl_product_rest(y, series_phi_p, series_phi_q, series_phi_r
          - series_phi_r_right) + (9.635426302092969e-09 - series_phi_r_right),
      series_phi_s = KSL_MUL(y, series_phi_r),
      series_phi_s_cross2 = KSL_MUL(y, series_phi_r_lo1 + -1.7546051379703029e-25
          + (KSL_MUL(y_lo, series_phi_p) + series_phi_q_cross2)),
      series_phi_t = series_phi_s - 1.0020843354176687e-06,
      series_phi_t_right = series_phi_s - series_phi_t,
      series_phi_t_lo1 = ksl_product_rest(y, series_phi_r, series_phi_s, series_phi_t
          + series_phi_t_right) - (1.0020843354176687e-06 - series_phi_t_right),
      series_phi_u = KSL_MUL(y, series_phi_t),
      series_phi_u_cross2 = KSL_MUL(y, series_phi_t_lo1 - 4.7926555569351065e-23
          + (KSL_MUL(y_lo, series_phi_r) + series_phi_s_cross2)),
      series_phi_v = series_phi_u + 6.613756613756614e-05,
      series_phi_v_right = series_phi_v - series_phi_u,
      series_phi_v_lo1 = ksl_product_rest(y, series_phi_t, series_phi_u, series_phi_v
          - series_phi_v_right) + (6.613756613756614e-05 - series_phi_v_right),
      series_phi_w = KSL_MUL(y, series_phi_v),
      series_phi_w_cross2 = KSL_MUL(y, series_phi_v_lo1 + -4.460143857711533e-21
          + (KSL_MUL(y_lo, series_phi_t) + series_phi_u_cross2)),
      series_phi_x = series_phi_w - 0.002380952380952381,
      series_phi_x_right = series_phi_w - series_phi_x,
      series_phi_x_lo1 = ksl_product_rest(y, series_phi_v, series_phi_w, series_phi_x
          + series_phi_x_right) - (0.002380952380952381 - series_phi_x_right),
      series_phi_y = KSL_MUL(y, series_phi_x),
      series_phi_y_cross2 = KSL_MUL(y, series_phi_x_lo1 - -2.147752875018904e-19
          + (KSL_MUL(y_lo, series_phi_v) + series_phi_w_cross2)),
      series_phi = series_phi_y + 0.03333333333333333, series_phi_right = series_phi - series_phi_y,
      series_phi_lo1 = ksl_product_rest(y, series_phi_x, series_phi_y, series_phi
          - series_phi_right) + (0.03333333333333333 - series_phi_right);
  const double f_more_a = KSL_MUL(2.0, y), f_more = KSL_MUL(f_more_a, series_phi),
      f_more_cross2 = KSL_MUL(f_more_a, series_phi_lo1 + 4.625929269271486e-19
          + (KSL_MUL(y_lo, series_phi_x) + series_phi_y_cross2));
  const double near_f_a = KSL_MUL(0.3333333333333333, sinc),
      near_f_b = KSL_MUL(0.3333333333333333, f_more),
      f_more_lo = ksl_product_error(f_more_a, series_phi, f_more)
          + (KSL_MUL(KSL_MUL(2.0, y_lo), series_phi) + f_more_cross2), near_f = near_f_a + near_f_b,
      near_f_right = near_f - near_f_a,
      near_f_b_cross = KSL_MUL(1.850371707708594e-17, f_more)
          + KSL_MUL(0.3333333333333333, f_more_lo),
      near_f_left_rest = ksl_product_rest(0.3333333333333333, sinc, near_f_a, near_f
          - near_f_right),
      near_f_cross = KSL_MUL(1.850371707708594e-17, sinc) + KSL_MUL(0.3333333333333333, sinc_lo)
          + near_f_b_cross,
      near_f_lo = near_f_left_rest
          + ksl_product_rest(0.3333333333333333, f_more, near_f_b, near_f_right) + near_f_cross;
  const double f_rest = sinc - c, f_rest_right = sinc - f_rest,
      f_rest_lo = sinc - (f_rest + f_rest_right) - (c - f_rest_right) - c_lo + sinc_lo;
  const double x = KSL_MUL(4.0, y);
  const double x_sum = x + KSL_MUL(4.0, y_lo), far_y = x_sum < 4.0 ? 1.0 : y,
      far_y_lo = x_sum < 4.0 ? 0.0 : y_lo;
  const double f_rest_sum = f_rest + f_rest_lo, f_rest_sum_right = f_rest_sum - f_rest,
      far_y_sum = far_y + far_y_lo, far_y_sum_right = far_y_sum - far_y,
      closed_f = f_rest_sum / far_y_sum, closed_f_product = KSL_MUL(closed_f, far_y_sum),
      closed_f_exact = f_rest_sum - closed_f_product
          - ksl_product_error(closed_f, far_y_sum, closed_f_product),
      closed_f_numerator = closed_f_exact
          + (f_rest - (f_rest_sum - f_rest_sum_right) + (f_rest_lo - f_rest_sum_right)),
      closed_f_lo = (closed_f_numerator
          - KSL_MUL(closed_f, far_y - (far_y_sum - far_y_sum_right)
          + (far_y_lo - far_y_sum_right))) / far_y_sum;
  const double f = x_sum < 4.0 ? near_f : closed_f, f_lo = x_sum < 4.0 ? near_f_lo : closed_f_lo;
  const double four_k = KSL_MUL(4.0, sinc), four_k_cross2 = KSL_MUL(4.0, sinc_lo);
  const double f_sum = f + f_lo, f_sum_right = f_sum - f, four_k_sum = four_k + four_k_cross2,
      four_k_sum_right = four_k_sum - four_k, b = f_sum / four_k_sum,
      b_product = KSL_MUL(b, four_k_sum),
      b_numerator = f_sum - b_product - ksl_product_error(b, four_k_sum, b_product)
          + (f - (f_sum - f_sum_right) + (f_lo - f_sum_right));
  const double c_sum = c + c_lo, c_sum_right = c_sum - c, sinc_sum = sinc + sinc_lo,
      sinc_sum_right = sinc_sum - sinc, b_across = c_sum / sinc_sum,
      b_across_product = KSL_MUL(b_across, sinc_sum),
      b_across_exact = c_sum - b_across_product
          - ksl_product_error(b_across, sinc_sum, b_across_product),
      b_across_cross = KSL_MUL(b_across, sinc - (sinc_sum - sinc_sum_right)
          + (sinc_lo - sinc_sum_right)),
      b_across_lo = (b_across_exact + (c - (c_sum - c_sum_right) + (c_lo - c_sum_right))
          - b_across_cross) / sinc_sum;
  const double vector_0_lo = ksl_product_error(upper_0_sum, k, vector_0)
          + (KSL_MUL(upper_0_sum_lo, k) + KSL_MUL(upper_0_sum, k_lo)),
      wt_a = KSL_MUL(D->m03, vector_0),
      vector_1_lo = ksl_product_error(upper_1_sum, k, vector_1)
          + (KSL_MUL(upper_1_sum_lo, k) + KSL_MUL(upper_1_sum, k_lo)),
      wt_b = KSL_MUL(D->m13, vector_1), wt_c = wt_a + wt_b, wt_c_right = wt_c - wt_a,
      wt_c_lo1 = ksl_product_rest(D->m03, vector_0, wt_a, wt_c - wt_c_right)
          + ksl_product_rest(D->m13, vector_1, wt_b, wt_c_right),
      vector_2_lo = ksl_product_error(upper_2_sum, k, vector_2)
          + (KSL_MUL(upper_2_sum_lo, k) + KSL_MUL(upper_2_sum, k_lo)),
      wt_d = KSL_MUL(D->m23, vector_2), wt = wt_c + wt_d, wt_right = wt - wt_c,
      wt_lo2 = wt_c - (wt - wt_right) + ksl_product_rest(D->m23, vector_2, wt_d, wt_right)
          + KSL_MUL(D->m23, vector_2_lo);
  const double pitch = KSL_MUL(b, wt),
      pitch_cross1 = KSL_MUL((b_numerator
          - KSL_MUL(b, four_k - (four_k_sum - four_k_sum_right)
          + (four_k_cross2 - four_k_sum_right))) / four_k_sum, wt),
      pitch_cross = pitch_cross1
          + KSL_MUL(b, wt_lo2
          + (wt_c_lo1 + (KSL_MUL(D->m03, vector_0_lo) + KSL_MUL(D->m13, vector_1_lo))));
  const double pitch_lo = ksl_product_error(b, wt, pitch) + pitch_cross,
      along_0 = KSL_MUL(vector_0, pitch);
  const double along_1 = KSL_MUL(vector_1, pitch), along_2 = KSL_MUL(vector_2, pitch);
  const double u_0a = KSL_MUL(D->m23, vector_1), u_0b = KSL_MUL(D->m13, vector_2),
      u_0 = u_0a - u_0b, u_0_right = u_0a - u_0,
      u_0_lo1 = ksl_product_rest(D->m23, vector_1, u_0a, u_0 + u_0_right)
          - ksl_product_rest(D->m13, vector_2, u_0b, u_0_right);
  const double u_1a = KSL_MUL(D->m03, vector_2), u_1b = KSL_MUL(D->m23, vector_0),
      u_1 = u_1a - u_1b, u_1_right = u_1a - u_1,
      u_1_lo1 = ksl_product_rest(D->m03, vector_2, u_1a, u_1 + u_1_right)
          - ksl_product_rest(D->m23, vector_0, u_1b, u_1_right);
  const double u_2a = KSL_MUL(D->m13, vector_0), u_2b = KSL_MUL(D->m03, vector_1),
      u_2 = u_2a - u_2b, u_2_right = u_2a - u_2,
      u_2_lo1 = ksl_product_rest(D->m13, vector_0, u_2a, u_2 + u_2_right)
          - ksl_product_rest(D->m03, vector_1, u_2b, u_2_right);
  const double turned_0 = KSL_MUL(0.5, u_0), turned_1 = KSL_MUL(0.5, u_1),
      turned_2 = KSL_MUL(0.5, u_2);
  const double across_axis_0 = along_0 - turned_0, across_axis_0_right = along_0 - across_axis_0,
      across_axis_0_lo1 = ksl_product_rest(vector_0, pitch, along_0, across_axis_0
          + across_axis_0_right) - (turned_0 - across_axis_0_right),
      across_axis_0_lo2 = across_axis_0_lo1
          - KSL_MUL(0.5, u_0_lo1 + (KSL_MUL(D->m23, vector_1_lo) - KSL_MUL(D->m13, vector_2_lo)));
  const double across_axis_1 = along_1 - turned_1, across_axis_1_right = along_1 - across_axis_1,
      across_axis_1_lo1 = ksl_product_rest(vector_1, pitch, along_1, across_axis_1
          + across_axis_1_right) - (turned_1 - across_axis_1_right),
      across_axis_1_lo2 = across_axis_1_lo1
          - KSL_MUL(0.5, u_1_lo1 + (KSL_MUL(D->m03, vector_2_lo) - KSL_MUL(D->m23, vector_0_lo)));
  const double across_axis_2 = along_2 - turned_2, across_axis_2_right = along_2 - across_axis_2,
      across_axis_2_lo1 = ksl_product_rest(vector_2, pitch, along_2, across_axis_2
          + across_axis_2_right) - (turned_2 - across_axis_2_right),
      across_axis_2_lo2 = across_axis_2_lo1
          - KSL_MUL(0.5, u_2_lo1 + (KSL_MUL(D->m13, vector_0_lo) - KSL_MUL(D->m03, vector_1_lo)));
  const double so_0a = KSL_MUL(D->m03, b_across), so_0 = so_0a + across_axis_0,
      so_0_right = so_0 - so_0a,
      so_0_lo1 = ksl_product_rest(D->m03, b_across, so_0a, so_0 - so_0_right)
          + (across_axis_0 - so_0_right);
  const double so_1a = KSL_MUL(D->m13, b_across), so_1 = so_1a + across_axis_1,
      so_1_right = so_1 - so_1a,
      so_1_lo1 = ksl_product_rest(D->m13, b_across, so_1a, so_1 - so_1_right)
          + (across_axis_1 - so_1_right);
  const double so_2a = KSL_MUL(D->m23, b_across), so_2 = so_2a + across_axis_2,
      so_2_right = so_2 - so_2a,
      so_2_lo1 = ksl_product_rest(D->m23, b_across, so_2a, so_2 - so_2_right)
          + (across_axis_2 - so_2_right);
  const double so_0_rounded = so_0
          + (so_0_lo1
          + (across_axis_0_lo2 + (KSL_MUL(vector_0_lo, pitch) + KSL_MUL(vector_0, pitch_lo)))
          + KSL_MUL(D->m03, b_across_lo));
  const double so_1_rounded = so_1
          + (so_1_lo1
          + (across_axis_1_lo2 + (KSL_MUL(vector_1_lo, pitch) + KSL_MUL(vector_1, pitch_lo)))
          + KSL_MUL(D->m13, b_across_lo));
  const double so_2_rounded = so_2
          + (so_2_lo1
          + (across_axis_2_lo2 + (KSL_MUL(vector_2_lo, pitch) + KSL_MUL(vector_2, pitch_lo)))
          + KSL_MUL(D->m23, b_across_lo));
  const double vector_0_rounded = vector_0 + vector_0_lo;
  const double vector_1_rounded = vector_1 + vector_1_lo;
  const double vector_2_rounded = vector_2 + vector_2_lo;
  const double so_0_final = so_0_rounded == so_0_rounded ? so_0_rounded : so_0;
  const double so_1_final = so_1_rounded == so_1_rounded ? so_1_rounded : so_1;
  const double so_2_final = so_2_rounded == so_2_rounded ? so_2_rounded : so_2;
  const double vector_0_final = vector_0_rounded == vector_0_rounded ? vector_0_rounded : vector_0;
  const double vector_1_final = vector_1_rounded == vector_1_rounded ? vector_1_rounded : vector_1;
  const double vector_2_final = vector_2_rounded == vector_2_rounded ? vector_2_rounded : vector_2;
  so->m0 = so_0_final;
  so->m1 = so_1_final;
  so->m2 = so_2_final;
  so->m3 = vector_0_final;
  so->m4 = vector_1_final;
  so->m5 = vector_2_final;
}

/* M = J_l(s) = Σ ([ad](s))^k / (k+1)!.
   s: screw (v in m/s; ω in rad/s); M: 6×6 operator.
   321 mul, 819 add, 31 product error, 87 product rest, 10 div, 1 sqrt, 3 neg, 4 abs, 6 less, 19
     equal, 38 select.
   Error <= M: 1 u of its largest component for |ω of s| <= π; searched, not proved.  Each
     component is within 1 ulp as long as its condition is below 1e13; in single precision it is
     the nearest number, except near ties, as long as that is below 1e5; searched, not proved.
     Intermediate sums may overflow where |v| is above 2e306, in single precision 5e36. */
static inline void ksl_SE3_leftJacobian_accurate(const ksl_screw_t *s, ksl_mat6x6_t *M) {
  const double halved_0 = KSL_MUL(0.5, s->m3), halved_1 = KSL_MUL(0.5, s->m4),
      halved_2 = KSL_MUL(0.5, s->m5);
  const double y_a = KSL_MUL(halved_0, halved_0), y_b = KSL_MUL(halved_1, halved_1),
      y_c = y_a + y_b, y_c_right = y_c - y_a, y_d = KSL_MUL(halved_2, halved_2), y = y_c + y_d,
      y_right = y - y_c,
      y_c_lo = ksl_product_rest(halved_0, halved_0, y_a, y_c - y_c_right)
          + ksl_product_rest(halved_1, halved_1, y_b, y_c_right),
      y_lo = y_c - (y - y_right) + ksl_product_rest(halved_2, halved_2, y_d, y_right) + y_c_lo;
  const double y_sum = y + y_lo, y_sum_right = y_sum - y,
      y_sum_lo = y - (y_sum - y_sum_right) + (y_lo - y_sum_right), half_angle = sqrt(y_sum),
      half_angle_product = KSL_MUL(half_angle, half_angle),
      half_angle_twice = half_angle + half_angle,
      half_angle_residual = y_sum - half_angle_product
          - ksl_product_error(half_angle, half_angle, half_angle_product) + y_sum_lo,
      half_angle_lo = half_angle_residual / (half_angle == 0.0 ? 1.0 : half_angle_twice);
  const double half_angle_sum = half_angle + half_angle_lo,
      half_angle_sum_right = half_angle_sum - half_angle,
      half_angle_sum_lo = half_angle - (half_angle_sum - half_angle_sum_right)
          + (half_angle_lo - half_angle_sum_right);
  double c; const double sine = ksl_sincos(half_angle_sum, &c);
  double c_own_error; const double sine_own_error = ksl_sincos_error(half_angle_sum, sine, c,
      &c_own_error);
  const double sine_half = KSL_MUL(half_angle_sum_lo, 0.5);
  double sine_half_cos; const double sine_half_sin = ksl_sincos(sine_half, &sine_half_cos);
  const double sine_twice = sine_half_sin + sine_half_sin,
      sine_lo = sine_own_error
          + KSL_MUL(KSL_MUL(sine_half_cos, c) - KSL_MUL(sine_half_sin, sine), sine_twice);
  const double sinc_divisor = half_angle_sum < 1.4901161193847656e-08 ? 1.4901161193847656e-08
          : half_angle_sum,
      sinc_divisor_lo = half_angle_sum < 1.4901161193847656e-08 ? 0.0 : half_angle_sum_lo;
  const double sine_sum = sine + sine_lo, sine_sum_right = sine_sum - sine,
      sinc_divisor_sum = sinc_divisor + sinc_divisor_lo,
      sinc_divisor_sum_right = sinc_divisor_sum - sinc_divisor,
      sinc_quotient = sine_sum / sinc_divisor_sum,
      sinc_quotient_product = KSL_MUL(sinc_quotient, sinc_divisor_sum),
      sinc_quotient_exact = sine_sum - sinc_quotient_product
          - ksl_product_error(sinc_quotient, sinc_divisor_sum, sinc_quotient_product),
      sinc_quotient_cross = KSL_MUL(sinc_quotient, sinc_divisor
          - (sinc_divisor_sum - sinc_divisor_sum_right)
          + (sinc_divisor_lo - sinc_divisor_sum_right)),
      sinc_quotient_lo = (sinc_quotient_exact
          + (sine - (sine_sum - sine_sum_right) + (sine_lo - sine_sum_right))
          - sinc_quotient_cross) / sinc_divisor_sum;
  const double sinc_a = KSL_MUL(0.16666666666666666, y_sum), sinc_b = 1.0 - sinc_a,
      sinc_b_right = 1.0 - sinc_b,
      sinc_b_lo1 = 1.0 - (sinc_b + sinc_b_right)
          - ksl_product_rest(0.16666666666666666, y_sum, sinc_a, sinc_b_right),
      sinc_b_lo = sinc_b_lo1
          - (KSL_MUL(9.25185853854297e-18, y_sum) + KSL_MUL(0.16666666666666666, y_sum_lo)),
      sinc = half_angle_sum < 1.4901161193847656e-08 ? sinc_b : sinc_quotient,
      sinc_lo = half_angle_sum < 1.4901161193847656e-08 ? sinc_b_lo : sinc_quotient_lo;
  const double g1 = KSL_MUL(c, sinc),
      g1_cross = KSL_MUL(c_own_error
          - KSL_MUL(KSL_MUL(sine_half_cos, sine) + KSL_MUL(sine_half_sin, c), sine_twice), sinc)
          + KSL_MUL(c, sinc_lo);
  const double g2a = KSL_MUL(sinc, sinc), g2 = KSL_MUL(0.5, g2a),
      g2_cross2 = KSL_MUL(0.5, ksl_product_error(sinc, sinc, g2a)
          + (KSL_MUL(sinc_lo, sinc) + KSL_MUL(sinc, sinc_lo)));
  const double rest3 = 1.0 - g1, rest3_right = 1.0 - rest3,
      rest3_lo = 1.0 - (rest3 + rest3_right) - ksl_product_rest(c, sinc, g1, rest3_right)
          - g1_cross;
  const double x = KSL_MUL(4.0, y_sum), x_cross2 = KSL_MUL(4.0, y_sum_lo);
  const double x_sum = x + x_cross2, x_sum_right = x_sum - x,
      x_sum_lo = x - (x_sum - x_sum_right) + (x_cross2 - x_sum_right),
      far_x = x_sum < 1.0 ? 1.0 : x_sum, far_x_lo = x_sum < 1.0 ? 0.0 : x_sum_lo;
  const double rest3_sum = rest3 + rest3_lo, rest3_sum_right = rest3_sum - rest3,
      far_x_sum = far_x + far_x_lo, far_x_sum_right = far_x_sum - far_x,
      far_x_sum_lo = far_x - (far_x_sum - far_x_sum_right) + (far_x_lo - far_x_sum_right),
      closed3 = rest3_sum / far_x_sum, closed3_product = KSL_MUL(closed3, far_x_sum),
      closed3_exact = rest3_sum - closed3_product
          - ksl_product_error(closed3, far_x_sum, closed3_product),
      closed3_lo = (closed3_exact
          + (rest3 - (rest3_sum - rest3_sum_right) + (rest3_lo - rest3_sum_right))
          - KSL_MUL(closed3, far_x_sum_lo)) / far_x_sum;
  const double series5a = KSL_MUL(1.216125041553518e-34, x_sum),
      series5b = 1.1309962886447716e-31 - series5a,
      series5b_right = 1.1309962886447716e-31 - series5b,
      series5b_lo1 = 1.1309962886447716e-31 - (series5b + series5b_right)
          - ksl_product_rest(1.216125041553518e-34, x_sum, series5a, series5b_right),
      series5c = KSL_MUL(x_sum, series5b),
      series5b_lo = series5b_lo1
          - (KSL_MUL(5.586290567888806e-51, x_sum) + KSL_MUL(1.216125041553518e-34, x_sum_lo))
          + 1.0498015412959506e-47, series5d = series5c - 9.183689863795546e-29,
      series5d_right = series5c - series5d,
      series5d_lo1 = ksl_product_rest(x_sum, series5b, series5c, series5d + series5d_right)
          - (9.183689863795546e-29 - series5d_right), series5e = KSL_MUL(x_sum, series5d),
      series5e_cross2 = KSL_MUL(x_sum, series5d_lo1 - 1.4303150396787322e-45
          + (KSL_MUL(x_sum_lo, series5b) + KSL_MUL(x_sum, series5b_lo))),
      series5f = series5e + 6.446950284384474e-26, series5f_right = series5f - series5e,
      series5f_lo1 = ksl_product_rest(x_sum, series5d, series5e, series5f - series5f_right)
          + (6.446950284384474e-26 - series5f_right), series5g = KSL_MUL(x_sum, series5f),
      series5g_cross2 = KSL_MUL(x_sum, series5f_lo1 + -1.9330404233703465e-42
          + (KSL_MUL(x_sum_lo, series5d) + series5e_cross2)),
      series5h = series5g - 3.868170170630684e-23, series5h_right = series5g - series5h,
      series5h_lo1 = ksl_product_rest(x_sum, series5f, series5g, series5h + series5h_right)
          - (3.868170170630684e-23 - series5h_right), series5i = KSL_MUL(x_sum, series5h),
      series5j = series5i + 1.9572941063391263e-20, series5j_right = series5j - series5i,
      series5j_lo1 = ksl_product_rest(x_sum, series5h, series5i, series5j - series5j_right)
          + (1.9572941063391263e-20 - series5j_right),
      series5i_cross = KSL_MUL(x_sum_lo, series5h)
          + KSL_MUL(x_sum, series5h_lo1 - -8.843177655482344e-40
          + (KSL_MUL(x_sum_lo, series5f) + series5g_cross2)), series5k = KSL_MUL(x_sum, series5j),
      series5l = series5k - 8.22063524662433e-18, series5l_right = series5k - series5l,
      series5l_lo1 = ksl_product_rest(x_sum, series5j, series5k, series5l + series5l_right)
          - (8.22063524662433e-18 - series5l_right),
      series5k_cross = KSL_MUL(x_sum_lo, series5j)
          + KSL_MUL(x_sum, series5j_lo1 + -1.3643503830087908e-36 + series5i_cross),
      series5m = KSL_MUL(x_sum, series5l), series5n = series5m + 2.8114572543455206e-15,
      series5n_right = series5n - series5m,
      series5n_lo1 = ksl_product_rest(x_sum, series5l, series5m, series5n - series5n_right)
          + (2.8114572543455206e-15 - series5n_right),
      series5m_cross = KSL_MUL(x_sum_lo, series5l)
          + KSL_MUL(x_sum, series5l_lo1 - 2.2141894119604265e-34 + series5k_cross),
      series5o = KSL_MUL(x_sum, series5n), series5p = series5o - 7.647163731819816e-13,
      series5p_right = series5o - series5p,
      series5p_lo1 = ksl_product_rest(x_sum, series5n, series5o, series5p + series5p_right)
          - (7.647163731819816e-13 - series5p_right),
      series5o_cross = KSL_MUL(x_sum_lo, series5n)
          + KSL_MUL(x_sum, series5n_lo1 + 1.6508842730861433e-31 + series5m_cross),
      series5q = KSL_MUL(x_sum, series5p), series5r = series5q + 1.6059043836821613e-10,
      series5r_right = series5r - series5q,
      series5r_lo1 = ksl_product_rest(x_sum, series5p, series5q, series5r - series5r_right)
          + (1.6059043836821613e-10 - series5r_right),
      series5q_cross = KSL_MUL(x_sum_lo, series5p)
          + KSL_MUL(x_sum, series5p_lo1 - 7.03872877733453e-30 + series5o_cross),
      series5s = KSL_MUL(x_sum, series5r), series5t = series5s - 2.505210838544172e-08,
      series5t_right = series5s - series5t,
      series5t_lo1 = ksl_product_rest(x_sum, series5r, series5s, series5t + series5t_right)
          - (2.505210838544172e-08 - series5t_right),
      series5s_cross = KSL_MUL(x_sum_lo, series5r)
          + KSL_MUL(x_sum, series5r_lo1 + 1.2585294588752098e-26 + series5q_cross),
      series5u = KSL_MUL(x_sum, series5t), series5v = series5u + 2.7557319223985893e-06,
      series5v_right = series5v - series5u,
      series5v_lo1 = ksl_product_rest(x_sum, series5t, series5u, series5v - series5v_right)
          + (2.7557319223985893e-06 - series5v_right),
      series5u_cross = KSL_MUL(x_sum_lo, series5t)
          + KSL_MUL(x_sum, series5t_lo1 - -1.448814070935912e-24 + series5s_cross),
      series5w = KSL_MUL(x_sum, series5v), series5x = series5w - 0.0001984126984126984,
      series5x_right = series5w - series5x,
      series5x_lo1 = ksl_product_rest(x_sum, series5v, series5w, series5x + series5x_right)
          - (0.0001984126984126984 - series5x_right),
      series5w_cross = KSL_MUL(x_sum_lo, series5v)
          + KSL_MUL(x_sum, series5v_lo1 + -1.858393274046472e-22 + series5u_cross),
      series5y = KSL_MUL(x_sum, series5x), series5 = series5y + 0.008333333333333333,
      series5_right = series5 - series5y,
      series5_lo2 = ksl_product_rest(x_sum, series5x, series5y, series5 - series5_right)
          + (0.008333333333333333 - series5_right) + 1.1564823173178714e-19,
      series5_lo = series5_lo2
          + (KSL_MUL(x_sum_lo, series5x)
          + KSL_MUL(x_sum, series5x_lo1 - 1.7209558293420705e-22 + series5w_cross));
  const double g3a = KSL_MUL(x_sum, series5), g3b = 0.16666666666666666 - g3a,
      g3b_right = 0.16666666666666666 - g3b,
      g3b_lo1 = 0.16666666666666666 - (g3b + g3b_right)
          - ksl_product_rest(x_sum, series5, g3a, g3b_right),
      g3b_lo = g3b_lo1 - (KSL_MUL(x_sum_lo, series5) + KSL_MUL(x_sum, series5_lo))
          + 9.25185853854297e-18, g3 = x_sum < 1.0 ? g3b : closed3,
      g3_lo = x_sum < 1.0 ? g3b_lo : closed3_lo;
  const double rest4 = 0.5 - g2, rest4_right = 0.5 - rest4,
      rest4_lo = 0.5 - (rest4 + rest4_right) - (g2 - rest4_right) - g2_cross2;
  const double rest4_sum = rest4 + rest4_lo, rest4_sum_right = rest4_sum - rest4,
      closed4 = rest4_sum / far_x_sum, closed4_product = KSL_MUL(closed4, far_x_sum),
      closed4_exact = rest4_sum - closed4_product
          - ksl_product_error(closed4, far_x_sum, closed4_product),
      closed4_lo = (closed4_exact
          + (rest4 - (rest4_sum - rest4_sum_right) + (rest4_lo - rest4_sum_right))
          - KSL_MUL(closed4, far_x_sum_lo)) / far_x_sum;
  const double rest5 = 0.16666666666666666 - g3, rest5_right = 0.16666666666666666 - rest5,
      rest5_lo = 0.16666666666666666 - (rest5 + rest5_right) - (g3 - rest5_right) - g3_lo
          + 9.25185853854297e-18;
  const double rest5_sum = rest5 + rest5_lo, rest5_sum_right = rest5_sum - rest5,
      closed5 = rest5_sum / far_x_sum, closed5_product = KSL_MUL(closed5, far_x_sum),
      closed5_exact = rest5_sum - closed5_product
          - ksl_product_error(closed5, far_x_sum, closed5_product),
      closed5_lo = (closed5_exact
          + (rest5 - (rest5_sum - rest5_sum_right) + (rest5_lo - rest5_sum_right))
          - KSL_MUL(closed5, far_x_sum_lo)) / far_x_sum;
  const double series4a = KSL_MUL(3.7699876288159054e-33, x_sum),
      series4b = 3.279889237069838e-30 - series4a,
      series4b_right = 3.279889237069838e-30 - series4b,
      series4b_lo1 = 3.279889237069838e-30 - (series4b + series4b_right)
          - ksl_product_rest(3.7699876288159054e-33, x_sum, series4a, series4b_right),
      series4c = KSL_MUL(x_sum, series4b),
      series4b_lo = series4b_lo1
          - (KSL_MUL(2.5870347832750324e-49, x_sum) + KSL_MUL(3.7699876288159054e-33, x_sum_lo))
          + 1.5117542744029879e-46, series4d = series4c - 2.4795962632247976e-27,
      series4d_right = series4c - series4d,
      series4d_lo1 = ksl_product_rest(x_sum, series4b, series4c, series4d + series4d_right)
          - (2.4795962632247976e-27 - series4d_right), series4e = KSL_MUL(x_sum, series4d),
      series4e_cross2 = KSL_MUL(x_sum, series4d_lo1 - -1.2953730964765229e-43
          + (KSL_MUL(x_sum_lo, series4b) + KSL_MUL(x_sum, series4b_lo))),
      series4f = series4e + 1.6117375710961184e-24, series4f_right = series4f - series4e,
      series4f_lo1 = ksl_product_rest(x_sum, series4d, series4e, series4f - series4f_right)
          + (1.6117375710961184e-24 - series4f_right), series4g = KSL_MUL(x_sum, series4f),
      series4g_cross2 = KSL_MUL(x_sum, series4f_lo1 + -3.6846573564509766e-41
          + (KSL_MUL(x_sum_lo, series4d) + series4e_cross2)),
      series4h = series4g - 8.896791392450574e-22, series4h_right = series4g - series4h,
      series4h_lo1 = ksl_product_rest(x_sum, series4f, series4g, series4h + series4h_right)
          - (8.896791392450574e-22 - series4h_right), series4i = KSL_MUL(x_sum, series4h),
      series4j = series4i + 4.110317623312165e-19, series4j_right = series4j - series4i,
      series4j_lo1 = ksl_product_rest(x_sum, series4h, series4i, series4j - series4j_right)
          + (4.110317623312165e-19 - series4j_right),
      series4i_cross = KSL_MUL(x_sum_lo, series4h)
          + KSL_MUL(x_sum, series4h_lo1 - -7.911402614872376e-38
          + (KSL_MUL(x_sum_lo, series4f) + series4g_cross2)), series4k = KSL_MUL(x_sum, series4j),
      series4l = series4k - 1.5619206968586225e-16, series4l_right = series4k - series4l,
      series4l_lo1 = ksl_product_rest(x_sum, series4j, series4k, series4l + series4l_right)
          - (1.5619206968586225e-16 - series4l_right),
      series4k_cross = KSL_MUL(x_sum_lo, series4j)
          + KSL_MUL(x_sum, series4j_lo1 + 1.4412973378659527e-36 + series4i_cross),
      series4m = KSL_MUL(x_sum, series4l), series4n = series4m + 4.779477332387385e-14,
      series4n_right = series4n - series4m,
      series4n_lo1 = ksl_product_rest(x_sum, series4l, series4m, series4n - series4n_right)
          + (4.779477332387385e-14 - series4n_right),
      series4m_cross = KSL_MUL(x_sum_lo, series4l)
          + KSL_MUL(x_sum, series4l_lo1 - 1.1910679660273754e-32 + series4k_cross),
      series4o = KSL_MUL(x_sum, series4n), series4p = series4o - 1.1470745597729725e-11,
      series4p_right = series4o - series4p,
      series4p_lo1 = ksl_product_rest(x_sum, series4n, series4o, series4p + series4p_right)
          - (1.1470745597729725e-11 - series4p_right),
      series4o_cross = KSL_MUL(x_sum_lo, series4n)
          + KSL_MUL(x_sum, series4n_lo1 + 4.399205485834081e-31 + series4m_cross),
      series4q = KSL_MUL(x_sum, series4p), series4r = series4q + 2.08767569878681e-09,
      series4r_right = series4r - series4q,
      series4r_lo1 = ksl_product_rest(x_sum, series4p, series4q, series4r - series4r_right)
          + (2.08767569878681e-09 - series4r_right),
      series4q_cross = KSL_MUL(x_sum_lo, series4p)
          + KSL_MUL(x_sum, series4p_lo1 - 2.0655512752830745e-28 + series4o_cross),
      series4s = KSL_MUL(x_sum, series4r), series4t = series4s - 2.755731922398589e-07,
      series4t_right = series4s - series4t,
      series4t_lo1 = ksl_product_rest(x_sum, series4r, series4s, series4t + series4t_right)
          - (2.755731922398589e-07 - series4t_right),
      series4s_cross = KSL_MUL(x_sum_lo, series4r)
          + KSL_MUL(x_sum, series4r_lo1 + -1.20734505911326e-25 + series4q_cross),
      series4u = KSL_MUL(x_sum, series4t), series4v = series4u + 2.48015873015873e-05,
      series4v_right = series4v - series4u,
      series4v_lo1 = ksl_product_rest(x_sum, series4t, series4u, series4v - series4v_right)
          + (2.48015873015873e-05 - series4v_right),
      series4u_cross = KSL_MUL(x_sum_lo, series4t)
          + KSL_MUL(x_sum, series4t_lo1 - 2.3767714622250297e-23 + series4s_cross),
      series4w = KSL_MUL(x_sum, series4v), series4x = series4w - 0.001388888888888889,
      series4x_right = series4w - series4x,
      series4x_lo1 = ksl_product_rest(x_sum, series4v, series4w, series4x + series4x_right)
          - (0.001388888888888889 - series4x_right),
      series4w_cross = KSL_MUL(x_sum_lo, series4v)
          + KSL_MUL(x_sum, series4v_lo1 + 2.1511947866775882e-23 + series4u_cross),
      series4y = KSL_MUL(x_sum, series4x), series4 = series4y + 0.041666666666666664,
      series4_right = series4 - series4y,
      series4_lo2 = ksl_product_rest(x_sum, series4x, series4y, series4 - series4_right)
          + (0.041666666666666664 - series4_right) + 2.3129646346357427e-18,
      series4_lo = series4_lo2
          + (KSL_MUL(x_sum_lo, series4x)
          + KSL_MUL(x_sum, series4x_lo1 - -5.300543954373577e-20 + series4w_cross));
  const double g4 = x_sum < 1.0 ? series4 : closed4, g4_lo = x_sum < 1.0 ? series4_lo : closed4_lo;
  const double g5 = x_sum < 1.0 ? series5 : closed5;
  const double rate2a = KSL_MUL(2.0, g4), rate2 = rate2a - g3, rate2_right = rate2a - rate2;
  const double rate3a = KSL_MUL(3.0, g5), rate3 = rate3a - g4, rate3_right = rate3a - rate3;
  const double beta_v_0 = KSL_MUL(s->m3, g3), beta_v_1 = KSL_MUL(s->m4, g3),
      beta_v_2 = KSL_MUL(s->m5, g3);
  const double beta_v_0_lo = ksl_product_error(s->m3, g3, beta_v_0) + KSL_MUL(s->m3, g3_lo),
      m_0 = KSL_MUL(s->m3, beta_v_0), m_0_cross2 = KSL_MUL(s->m3, beta_v_0_lo);
  const double beta_v_1_lo = ksl_product_error(s->m4, g3, beta_v_1) + KSL_MUL(s->m4, g3_lo),
      m_1 = KSL_MUL(s->m4, beta_v_1), m_1_cross2 = KSL_MUL(s->m4, beta_v_1_lo);
  const double m_2 = KSL_MUL(s->m5, beta_v_2),
      m_2_cross2 = KSL_MUL(s->m5, ksl_product_error(s->m5, g3, beta_v_2) + KSL_MUL(s->m5, g3_lo));
  const double m_3 = KSL_MUL(s->m4, beta_v_0), m_3_cross2 = KSL_MUL(s->m4, beta_v_0_lo);
  const double m_4 = KSL_MUL(s->m5, beta_v_0), m_4_cross2 = KSL_MUL(s->m5, beta_v_0_lo);
  const double m_5 = KSL_MUL(s->m5, beta_v_1), m_5_cross2 = KSL_MUL(s->m5, beta_v_1_lo);
  const double others_0 = m_1 + m_2, others_0_right = others_0 - m_1,
      others_0_lo1 = ksl_product_rest(s->m4, beta_v_1, m_1, others_0 - others_0_right)
          + ksl_product_rest(s->m5, beta_v_2, m_2, others_0_right),
      others_0_lo = others_0_lo1 + (m_1_cross2 + m_2_cross2);
  const double others_1 = m_0 + m_2, others_1_right = others_1 - m_0,
      others_1_lo1 = ksl_product_rest(s->m3, beta_v_0, m_0, others_1 - others_1_right)
          + ksl_product_rest(s->m5, beta_v_2, m_2, others_1_right),
      others_1_lo = others_1_lo1 + (m_0_cross2 + m_2_cross2);
  const double others_2 = m_0 + m_1, others_2_right = others_2 - m_0,
      others_2_lo1 = ksl_product_rest(s->m3, beta_v_0, m_0, others_2 - others_2_right)
          + ksl_product_rest(s->m4, beta_v_1, m_1, others_2_right),
      others_2_lo = others_2_lo1 + (m_0_cross2 + m_1_cross2);
  const double diagonal0a = 1.0 - others_0, diagonal0a_right = 1.0 - diagonal0a,
      diagonal0a_lo = 1.0 - (diagonal0a + diagonal0a_right) - (others_0 - diagonal0a_right)
          - others_0_lo, diagonal0b = g1 + m_0, diagonal0b_right = diagonal0b - g1,
      diagonal0b_lo1 = ksl_product_rest(c, sinc, g1, diagonal0b - diagonal0b_right)
          + ksl_product_rest(s->m3, beta_v_0, m_0, diagonal0b_right),
      diagonal0b_lo = diagonal0b_lo1 + (g1_cross + m_0_cross2),
      m_0_sum = m_0 + (ksl_product_error(s->m3, beta_v_0, m_0) + m_0_cross2),
      others_0_sum = others_0 + others_0_lo,
      diagonal0 = m_0_sum < others_0_sum ? diagonal0b : diagonal0a;
  const double diagonal1a = 1.0 - others_1, diagonal1a_right = 1.0 - diagonal1a,
      diagonal1a_lo = 1.0 - (diagonal1a + diagonal1a_right) - (others_1 - diagonal1a_right)
          - others_1_lo, diagonal1b = g1 + m_1, diagonal1b_right = diagonal1b - g1,
      diagonal1b_lo1 = ksl_product_rest(c, sinc, g1, diagonal1b - diagonal1b_right)
          + ksl_product_rest(s->m4, beta_v_1, m_1, diagonal1b_right),
      diagonal1b_lo = diagonal1b_lo1 + (g1_cross + m_1_cross2),
      m_1_sum = m_1 + (ksl_product_error(s->m4, beta_v_1, m_1) + m_1_cross2),
      others_1_sum = others_1 + others_1_lo,
      diagonal1 = m_1_sum < others_1_sum ? diagonal1b : diagonal1a;
  const double diagonal2a = 1.0 - others_2, diagonal2a_right = 1.0 - diagonal2a,
      diagonal2a_lo = 1.0 - (diagonal2a + diagonal2a_right) - (others_2 - diagonal2a_right)
          - others_2_lo, diagonal2b = g1 + m_2, diagonal2b_right = diagonal2b - g1,
      diagonal2b_lo1 = ksl_product_rest(c, sinc, g1, diagonal2b - diagonal2b_right)
          + ksl_product_rest(s->m5, beta_v_2, m_2, diagonal2b_right),
      diagonal2b_lo = diagonal2b_lo1 + (g1_cross + m_2_cross2),
      m_2_sum = m_2 + (ksl_product_error(s->m5, beta_v_2, m_2) + m_2_cross2),
      others_2_sum = others_2 + others_2_lo,
      diagonal2 = m_2_sum < others_2_sum ? diagonal2b : diagonal2a;
  const double alpha_v_0 = KSL_MUL(s->m3, g2), alpha_v_0_cross2 = KSL_MUL(s->m3, g2_cross2);
  const double alpha_v_1 = KSL_MUL(s->m4, g2), alpha_v_1_cross2 = KSL_MUL(s->m4, g2_cross2);
  const double alpha_v_2 = KSL_MUL(s->m5, g2), alpha_v_2_cross2 = KSL_MUL(s->m5, g2_cross2);
  const double J_1 = m_3 - alpha_v_2, J_1_right = m_3 - J_1;
  const double J_2 = m_4 + alpha_v_1, J_2_right = J_2 - m_4;
  const double J_3 = m_3 + alpha_v_2, J_3_right = J_3 - m_3;
  const double J_5 = m_5 - alpha_v_0, J_5_right = m_5 - J_5;
  const double J_6 = m_4 - alpha_v_1, J_6_right = m_4 - J_6;
  const double J_7 = m_5 + alpha_v_0, J_7_right = J_7 - m_5;
  const double rate_vw_a = KSL_MUL(s->m0, s->m3), rate_vw_b = KSL_MUL(s->m1, s->m4),
      rate_vw_c = rate_vw_a + rate_vw_b, rate_vw_c_right = rate_vw_c - rate_vw_a,
      rate_vw_d = KSL_MUL(s->m2, s->m5), rate_vw = rate_vw_c + rate_vw_d,
      rate_vw_right = rate_vw - rate_vw_c,
      rate_vw_c_lo = ksl_product_rest(s->m0, s->m3, rate_vw_a, rate_vw_c - rate_vw_c_right)
          + ksl_product_rest(s->m1, s->m4, rate_vw_b, rate_vw_c_right),
      rate_vw_lo = rate_vw_c - (rate_vw - rate_vw_right)
          + ksl_product_rest(s->m2, s->m5, rate_vw_d, rate_vw_right) + rate_vw_c_lo;
  const double rate_turn = KSL_MUL(rate2, rate_vw);
  const double rate3_lo = ksl_product_rest(3.0, g5, rate3a, rate3 + rate3_right)
          - (g4 - rate3_right) - g4_lo + KSL_MUL(3.0, x_sum < 1.0 ? series5_lo : closed5_lo);
  const double rate_bend = -KSL_MUL(rate3, rate_vw);
  const double rate_q_0a = KSL_MUL(s->m0, g2);
  const double rate_turn_cross = KSL_MUL(rate2a - (rate2 + rate2_right) - (g3 - rate2_right)
          - g3_lo + KSL_MUL(2.0, g4_lo), rate_vw) + KSL_MUL(rate2, rate_vw_lo);
  const double rate_turn_lo = ksl_product_error(rate2, rate_vw, rate_turn) + rate_turn_cross,
      rate_q_0b = KSL_MUL(s->m3, rate_turn), rate_q_0 = rate_q_0a + rate_q_0b,
      rate_q_0_right = rate_q_0 - rate_q_0a,
      rate_q_0_lo1 = ksl_product_rest(s->m0, g2, rate_q_0a, rate_q_0 - rate_q_0_right)
          + ksl_product_rest(s->m3, rate_turn, rate_q_0b, rate_q_0_right),
      rate_q_0_lo = rate_q_0_lo1 + (KSL_MUL(s->m0, g2_cross2) + KSL_MUL(s->m3, rate_turn_lo));
  const double rate_q_1a = KSL_MUL(s->m1, g2), rate_q_1b = KSL_MUL(s->m4, rate_turn),
      rate_q_1 = rate_q_1a + rate_q_1b, rate_q_1_right = rate_q_1 - rate_q_1a,
      rate_q_1_lo1 = ksl_product_rest(s->m1, g2, rate_q_1a, rate_q_1 - rate_q_1_right)
          + ksl_product_rest(s->m4, rate_turn, rate_q_1b, rate_q_1_right),
      rate_q_1_lo = rate_q_1_lo1 + (KSL_MUL(s->m1, g2_cross2) + KSL_MUL(s->m4, rate_turn_lo));
  const double rate_q_2a = KSL_MUL(s->m2, g2), rate_q_2b = KSL_MUL(s->m5, rate_turn),
      rate_q_2 = rate_q_2a + rate_q_2b, rate_q_2_right = rate_q_2 - rate_q_2a,
      rate_q_2_lo1 = ksl_product_rest(s->m2, g2, rate_q_2a, rate_q_2 - rate_q_2_right)
          + ksl_product_rest(s->m5, rate_turn, rate_q_2b, rate_q_2_right),
      rate_q_2_lo = rate_q_2_lo1 + (KSL_MUL(s->m2, g2_cross2) + KSL_MUL(s->m5, rate_turn_lo));
  const double rate_beta_v_0 = KSL_MUL(s->m0, g3), rate_beta_v_1 = KSL_MUL(s->m1, g3),
      rate_beta_v_2 = KSL_MUL(s->m2, g3);
  const double rate_bend_lo = ksl_product_error(-rate3, rate_vw, rate_bend) +
          -(KSL_MUL(rate3_lo, rate_vw) + KSL_MUL(rate3, rate_vw_lo)),
      rate_bend_w_0 = KSL_MUL(s->m3, rate_bend);
  const double rate_bend_w_1 = KSL_MUL(s->m4, rate_bend), rate_bend_w_2 = KSL_MUL(s->m5, rate_bend);
  const double rate_beta_v_1_lo = ksl_product_error(s->m1, g3, rate_beta_v_1)
          + KSL_MUL(s->m1, g3_lo), rate_symmetric_0a = KSL_MUL(s->m3, rate_beta_v_1),
      rate_beta_v_0_lo = ksl_product_error(s->m0, g3, rate_beta_v_0) + KSL_MUL(s->m0, g3_lo),
      rate_symmetric_0b = KSL_MUL(s->m4, rate_beta_v_0),
      rate_symmetric_0c = rate_symmetric_0a + rate_symmetric_0b,
      rate_symmetric_0c_right = rate_symmetric_0c - rate_symmetric_0a,
      rate_symmetric_0c_left_rest = ksl_product_rest(s->m3, rate_beta_v_1, rate_symmetric_0a,
          rate_symmetric_0c - rate_symmetric_0c_right),
      rate_symmetric_0c_lo1 = rate_symmetric_0c_left_rest
          + ksl_product_rest(s->m4, rate_beta_v_0, rate_symmetric_0b, rate_symmetric_0c_right),
      rate_bend_w_0_lo = ksl_product_error(s->m3, rate_bend, rate_bend_w_0)
          + KSL_MUL(s->m3, rate_bend_lo), rate_symmetric_0d = KSL_MUL(s->m4, rate_bend_w_0),
      rate_symmetric_0 = rate_symmetric_0c - rate_symmetric_0d,
      rate_symmetric_0_right = rate_symmetric_0c - rate_symmetric_0,
      rate_symmetric_0_right_rest = ksl_product_rest(s->m4, rate_bend_w_0, rate_symmetric_0d,
          rate_symmetric_0_right),
      rate_symmetric_0_lo1 = rate_symmetric_0c - (rate_symmetric_0 + rate_symmetric_0_right)
          - rate_symmetric_0_right_rest,
      rate_symmetric_0c_lo = rate_symmetric_0c_lo1
          + (KSL_MUL(s->m3, rate_beta_v_1_lo) + KSL_MUL(s->m4, rate_beta_v_0_lo)),
      rate_symmetric_0_lo = rate_symmetric_0_lo1 - KSL_MUL(s->m4, rate_bend_w_0_lo)
          + rate_symmetric_0c_lo;
  const double rate_beta_v_2_lo = ksl_product_error(s->m2, g3, rate_beta_v_2)
          + KSL_MUL(s->m2, g3_lo), rate_symmetric_1a = KSL_MUL(s->m3, rate_beta_v_2),
      rate_symmetric_1b = KSL_MUL(s->m5, rate_beta_v_0),
      rate_symmetric_1c = rate_symmetric_1a + rate_symmetric_1b,
      rate_symmetric_1c_right = rate_symmetric_1c - rate_symmetric_1a,
      rate_symmetric_1c_left_rest = ksl_product_rest(s->m3, rate_beta_v_2, rate_symmetric_1a,
          rate_symmetric_1c - rate_symmetric_1c_right),
      rate_symmetric_1c_lo1 = rate_symmetric_1c_left_rest
          + ksl_product_rest(s->m5, rate_beta_v_0, rate_symmetric_1b, rate_symmetric_1c_right),
      rate_symmetric_1d = KSL_MUL(s->m5, rate_bend_w_0),
      rate_symmetric_1 = rate_symmetric_1c - rate_symmetric_1d,
      rate_symmetric_1_right = rate_symmetric_1c - rate_symmetric_1,
      rate_symmetric_1_right_rest = ksl_product_rest(s->m5, rate_bend_w_0, rate_symmetric_1d,
          rate_symmetric_1_right),
      rate_symmetric_1_lo1 = rate_symmetric_1c - (rate_symmetric_1 + rate_symmetric_1_right)
          - rate_symmetric_1_right_rest,
      rate_symmetric_1c_lo = rate_symmetric_1c_lo1
          + (KSL_MUL(s->m3, rate_beta_v_2_lo) + KSL_MUL(s->m5, rate_beta_v_0_lo)),
      rate_symmetric_1_lo = rate_symmetric_1_lo1 - KSL_MUL(s->m5, rate_bend_w_0_lo)
          + rate_symmetric_1c_lo;
  const double rate_symmetric_2a = KSL_MUL(s->m4, rate_beta_v_2),
      rate_symmetric_2b = KSL_MUL(s->m5, rate_beta_v_1),
      rate_symmetric_2c = rate_symmetric_2a + rate_symmetric_2b,
      rate_symmetric_2c_right = rate_symmetric_2c - rate_symmetric_2a,
      rate_symmetric_2c_left_rest = ksl_product_rest(s->m4, rate_beta_v_2, rate_symmetric_2a,
          rate_symmetric_2c - rate_symmetric_2c_right),
      rate_symmetric_2c_lo1 = rate_symmetric_2c_left_rest
          + ksl_product_rest(s->m5, rate_beta_v_1, rate_symmetric_2b, rate_symmetric_2c_right),
      rate_bend_w_1_lo = ksl_product_error(s->m4, rate_bend, rate_bend_w_1)
          + KSL_MUL(s->m4, rate_bend_lo), rate_symmetric_2d = KSL_MUL(s->m5, rate_bend_w_1),
      rate_symmetric_2 = rate_symmetric_2c - rate_symmetric_2d,
      rate_symmetric_2_right = rate_symmetric_2c - rate_symmetric_2,
      rate_symmetric_2_right_rest = ksl_product_rest(s->m5, rate_bend_w_1, rate_symmetric_2d,
          rate_symmetric_2_right),
      rate_symmetric_2_lo1 = rate_symmetric_2c - (rate_symmetric_2 + rate_symmetric_2_right)
          - rate_symmetric_2_right_rest,
      rate_symmetric_2c_lo = rate_symmetric_2c_lo1
          + (KSL_MUL(s->m4, rate_beta_v_2_lo) + KSL_MUL(s->m5, rate_beta_v_1_lo)),
      rate_symmetric_2_lo = rate_symmetric_2_lo1 - KSL_MUL(s->m5, rate_bend_w_1_lo)
          + rate_symmetric_2c_lo;
  const double rate_diagonal_0a = KSL_MUL(s->m4, rate_bend_w_1),
      rate_diagonal_0a_cross2 = KSL_MUL(s->m4, rate_bend_w_1_lo),
      rate_diagonal_0b = KSL_MUL(s->m5, rate_bend_w_2),
      rate_diagonal_0b_cross2 = KSL_MUL(s->m5, ksl_product_error(s->m5, rate_bend, rate_bend_w_2)
          + KSL_MUL(s->m5, rate_bend_lo)), rate_diagonal_0c = rate_diagonal_0a + rate_diagonal_0b,
      rate_diagonal_0c_right = rate_diagonal_0c - rate_diagonal_0a,
      rate_diagonal_0c_left_rest = ksl_product_rest(s->m4, rate_bend_w_1, rate_diagonal_0a,
          rate_diagonal_0c - rate_diagonal_0c_right),
      rate_diagonal_0c_lo1 = rate_diagonal_0c_left_rest
          + ksl_product_rest(s->m5, rate_bend_w_2, rate_diagonal_0b, rate_diagonal_0c_right),
      rate_diagonal_0d = KSL_MUL(2.0, s->m4),
      rate_diagonal_0e = KSL_MUL(rate_diagonal_0d, rate_beta_v_1),
      rate_diagonal_0e_cross2 = KSL_MUL(rate_diagonal_0d, rate_beta_v_1_lo),
      rate_diagonal_0f = KSL_MUL(2.0, s->m5),
      rate_diagonal_0g = KSL_MUL(rate_diagonal_0f, rate_beta_v_2),
      rate_diagonal_0g_cross2 = KSL_MUL(rate_diagonal_0f, rate_beta_v_2_lo),
      rate_diagonal_0h = rate_diagonal_0e + rate_diagonal_0g,
      rate_diagonal_0h_right = rate_diagonal_0h - rate_diagonal_0e,
      rate_diagonal_0h_left_rest = ksl_product_rest(rate_diagonal_0d, rate_beta_v_1,
          rate_diagonal_0e, rate_diagonal_0h - rate_diagonal_0h_right),
      rate_diagonal_0h_lo1 = rate_diagonal_0h_left_rest
          + ksl_product_rest(rate_diagonal_0f, rate_beta_v_2, rate_diagonal_0g,
              rate_diagonal_0h_right),
      rate_diagonal_0 = rate_diagonal_0c - rate_diagonal_0h,
      rate_diagonal_0_right = rate_diagonal_0c - rate_diagonal_0,
      rate_diagonal_0_lo1 = rate_diagonal_0c - (rate_diagonal_0 + rate_diagonal_0_right)
          - (rate_diagonal_0h - rate_diagonal_0_right),
      rate_diagonal_0_lo2 = rate_diagonal_0_lo1
          - (rate_diagonal_0h_lo1 + (rate_diagonal_0e_cross2 + rate_diagonal_0g_cross2));
  const double rate_diagonal_1a = KSL_MUL(s->m3, rate_bend_w_0),
      rate_diagonal_1a_cross2 = KSL_MUL(s->m3, rate_bend_w_0_lo),
      rate_diagonal_1b = rate_diagonal_1a + rate_diagonal_0b,
      rate_diagonal_1b_right = rate_diagonal_1b - rate_diagonal_1a,
      rate_diagonal_1b_left_rest = ksl_product_rest(s->m3, rate_bend_w_0, rate_diagonal_1a,
          rate_diagonal_1b - rate_diagonal_1b_right),
      rate_diagonal_1b_lo1 = rate_diagonal_1b_left_rest
          + ksl_product_rest(s->m5, rate_bend_w_2, rate_diagonal_0b, rate_diagonal_1b_right),
      rate_diagonal_1c = KSL_MUL(2.0, s->m3),
      rate_diagonal_1d = KSL_MUL(rate_diagonal_1c, rate_beta_v_0),
      rate_diagonal_1d_cross2 = KSL_MUL(rate_diagonal_1c, rate_beta_v_0_lo),
      rate_diagonal_1e = rate_diagonal_1d + rate_diagonal_0g,
      rate_diagonal_1e_right = rate_diagonal_1e - rate_diagonal_1d,
      rate_diagonal_1e_left_rest = ksl_product_rest(rate_diagonal_1c, rate_beta_v_0,
          rate_diagonal_1d, rate_diagonal_1e - rate_diagonal_1e_right),
      rate_diagonal_1e_lo1 = rate_diagonal_1e_left_rest
          + ksl_product_rest(rate_diagonal_0f, rate_beta_v_2, rate_diagonal_0g,
              rate_diagonal_1e_right),
      rate_diagonal_1 = rate_diagonal_1b - rate_diagonal_1e,
      rate_diagonal_1_right = rate_diagonal_1b - rate_diagonal_1,
      rate_diagonal_1_lo1 = rate_diagonal_1b - (rate_diagonal_1 + rate_diagonal_1_right)
          - (rate_diagonal_1e - rate_diagonal_1_right),
      rate_diagonal_1_lo2 = rate_diagonal_1_lo1
          - (rate_diagonal_1e_lo1 + (rate_diagonal_1d_cross2 + rate_diagonal_0g_cross2));
  const double rate_diagonal_2a = rate_diagonal_1a + rate_diagonal_0a,
      rate_diagonal_2a_right = rate_diagonal_2a - rate_diagonal_1a,
      rate_diagonal_2a_left_rest = ksl_product_rest(s->m3, rate_bend_w_0, rate_diagonal_1a,
          rate_diagonal_2a - rate_diagonal_2a_right),
      rate_diagonal_2a_lo1 = rate_diagonal_2a_left_rest
          + ksl_product_rest(s->m4, rate_bend_w_1, rate_diagonal_0a, rate_diagonal_2a_right),
      rate_diagonal_2b = rate_diagonal_1d + rate_diagonal_0e,
      rate_diagonal_2b_right = rate_diagonal_2b - rate_diagonal_1d,
      rate_diagonal_2b_left_rest = ksl_product_rest(rate_diagonal_1c, rate_beta_v_0,
          rate_diagonal_1d, rate_diagonal_2b - rate_diagonal_2b_right),
      rate_diagonal_2b_lo1 = rate_diagonal_2b_left_rest
          + ksl_product_rest(rate_diagonal_0d, rate_beta_v_1, rate_diagonal_0e,
              rate_diagonal_2b_right),
      rate_diagonal_2 = rate_diagonal_2a - rate_diagonal_2b,
      rate_diagonal_2_right = rate_diagonal_2a - rate_diagonal_2,
      rate_diagonal_2_lo1 = rate_diagonal_2a - (rate_diagonal_2 + rate_diagonal_2_right)
          - (rate_diagonal_2b - rate_diagonal_2_right),
      rate_diagonal_2_lo2 = rate_diagonal_2_lo1
          - (rate_diagonal_2b_lo1 + (rate_diagonal_1d_cross2 + rate_diagonal_0e_cross2));
  const double M_04 = rate_symmetric_0 - rate_q_2, M_04_right = rate_symmetric_0 - M_04;
  const double M_05 = rate_q_1 + rate_symmetric_1, M_05_right = M_05 - rate_q_1;
  const double M_13 = rate_q_2 + rate_symmetric_0, M_13_right = M_13 - rate_q_2;
  const double M_15 = rate_symmetric_2 - rate_q_0, M_15_right = rate_symmetric_2 - M_15;
  const double M_23 = rate_symmetric_1 - rate_q_1, M_23_right = rate_symmetric_1 - M_23;
  const double M_24 = rate_q_0 + rate_symmetric_2, M_24_right = M_24 - rate_q_0;
  const double diagonal0_rounded = diagonal0
          + (m_0_sum < others_0_sum ? diagonal0b_lo : diagonal0a_lo),
      diagonal0_final = diagonal0_rounded == diagonal0_rounded ? diagonal0_rounded : diagonal0;
  const double J_1_lo = ksl_product_rest(s->m4, beta_v_0, m_3, J_1 + J_1_right)
          - ksl_product_rest(s->m5, g2, alpha_v_2, J_1_right) + (m_3_cross2 - alpha_v_2_cross2);
  const double J_1_rounded = J_1 + J_1_lo,
      J_1_final = J_1_rounded == J_1_rounded ? J_1_rounded : J_1;
  const double J_2_lo = ksl_product_rest(s->m5, beta_v_0, m_4, J_2 - J_2_right)
          + ksl_product_rest(s->m4, g2, alpha_v_1, J_2_right) + (m_4_cross2 + alpha_v_1_cross2);
  const double J_2_rounded = J_2 + J_2_lo,
      J_2_final = J_2_rounded == J_2_rounded ? J_2_rounded : J_2;
  const double rate_diagonal_0_rounded = rate_diagonal_0
          + (rate_diagonal_0_lo2
          + (rate_diagonal_0c_lo1 + (rate_diagonal_0a_cross2 + rate_diagonal_0b_cross2)));
  const double M_04_rounded = M_04
          + (rate_symmetric_0 - (M_04 + M_04_right) - (rate_q_2 - M_04_right) - rate_q_2_lo
          + rate_symmetric_0_lo);
  const double M_05_rounded = M_05
          + (rate_q_1 - (M_05 - M_05_right) + (rate_symmetric_1 - M_05_right) + rate_symmetric_1_lo
          + rate_q_1_lo);
  const double J_3_lo = ksl_product_rest(s->m4, beta_v_0, m_3, J_3 - J_3_right)
          + ksl_product_rest(s->m5, g2, alpha_v_2, J_3_right) + (m_3_cross2 + alpha_v_2_cross2);
  const double J_3_rounded = J_3 + J_3_lo,
      J_3_final = J_3_rounded == J_3_rounded ? J_3_rounded : J_3;
  const double diagonal1_rounded = diagonal1
          + (m_1_sum < others_1_sum ? diagonal1b_lo : diagonal1a_lo),
      diagonal1_final = diagonal1_rounded == diagonal1_rounded ? diagonal1_rounded : diagonal1;
  const double J_5_lo = ksl_product_rest(s->m5, beta_v_1, m_5, J_5 + J_5_right)
          - ksl_product_rest(s->m3, g2, alpha_v_0, J_5_right) + (m_5_cross2 - alpha_v_0_cross2);
  const double J_5_rounded = J_5 + J_5_lo,
      J_5_final = J_5_rounded == J_5_rounded ? J_5_rounded : J_5;
  const double M_13_rounded = M_13
          + (rate_q_2 - (M_13 - M_13_right) + (rate_symmetric_0 - M_13_right) + rate_symmetric_0_lo
          + rate_q_2_lo);
  const double rate_diagonal_1_rounded = rate_diagonal_1
          + (rate_diagonal_1_lo2
          + (rate_diagonal_1b_lo1 + (rate_diagonal_1a_cross2 + rate_diagonal_0b_cross2)));
  const double M_15_rounded = M_15
          + (rate_symmetric_2 - (M_15 + M_15_right) - (rate_q_0 - M_15_right) - rate_q_0_lo
          + rate_symmetric_2_lo);
  const double J_6_lo = ksl_product_rest(s->m5, beta_v_0, m_4, J_6 + J_6_right)
          - ksl_product_rest(s->m4, g2, alpha_v_1, J_6_right) + (m_4_cross2 - alpha_v_1_cross2);
  const double J_6_rounded = J_6 + J_6_lo,
      J_6_final = J_6_rounded == J_6_rounded ? J_6_rounded : J_6;
  const double J_7_lo = ksl_product_rest(s->m5, beta_v_1, m_5, J_7 - J_7_right)
          + ksl_product_rest(s->m3, g2, alpha_v_0, J_7_right) + (m_5_cross2 + alpha_v_0_cross2);
  const double J_7_rounded = J_7 + J_7_lo,
      J_7_final = J_7_rounded == J_7_rounded ? J_7_rounded : J_7;
  const double diagonal2_rounded = diagonal2
          + (m_2_sum < others_2_sum ? diagonal2b_lo : diagonal2a_lo),
      diagonal2_final = diagonal2_rounded == diagonal2_rounded ? diagonal2_rounded : diagonal2;
  const double M_23_rounded = M_23
          + (rate_symmetric_1 - (M_23 + M_23_right) - (rate_q_1 - M_23_right) - rate_q_1_lo
          + rate_symmetric_1_lo);
  const double M_24_rounded = M_24
          + (rate_q_0 - (M_24 - M_24_right) + (rate_symmetric_2 - M_24_right) + rate_symmetric_2_lo
          + rate_q_0_lo);
  const double rate_diagonal_2_rounded = rate_diagonal_2
          + (rate_diagonal_2_lo2
          + (rate_diagonal_2a_lo1 + (rate_diagonal_1a_cross2 + rate_diagonal_0a_cross2)));
  const double rate_diagonal_0_final = rate_diagonal_0_rounded == rate_diagonal_0_rounded
          ? rate_diagonal_0_rounded : rate_diagonal_0;
  const double M_04_final = M_04_rounded == M_04_rounded ? M_04_rounded : M_04;
  const double M_05_final = M_05_rounded == M_05_rounded ? M_05_rounded : M_05;
  const double M_13_final = M_13_rounded == M_13_rounded ? M_13_rounded : M_13;
  const double rate_diagonal_1_final = rate_diagonal_1_rounded == rate_diagonal_1_rounded
          ? rate_diagonal_1_rounded : rate_diagonal_1;
  const double M_15_final = M_15_rounded == M_15_rounded ? M_15_rounded : M_15;
  const double M_23_final = M_23_rounded == M_23_rounded ? M_23_rounded : M_23;
  const double M_24_final = M_24_rounded == M_24_rounded ? M_24_rounded : M_24;
  const double rate_diagonal_2_final = rate_diagonal_2_rounded == rate_diagonal_2_rounded
          ? rate_diagonal_2_rounded : rate_diagonal_2;
  M->at[0][0] = diagonal0_final;
  M->at[1][0] = J_1_final;
  M->at[2][0] = J_2_final;
  M->at[3][0] = rate_diagonal_0_final;
  M->at[4][0] = M_04_final;
  M->at[5][0] = M_05_final;
  M->at[0][1] = J_3_final;
  M->at[1][1] = diagonal1_final;
  M->at[2][1] = J_5_final;
  M->at[3][1] = M_13_final;
  M->at[4][1] = rate_diagonal_1_final;
  M->at[5][1] = M_15_final;
  M->at[0][2] = J_6_final;
  M->at[1][2] = J_7_final;
  M->at[2][2] = diagonal2_final;
  M->at[3][2] = M_23_final;
  M->at[4][2] = M_24_final;
  M->at[5][2] = rate_diagonal_2_final;
  M->at[0][3] = 0.0;
  M->at[1][3] = 0.0;
  M->at[2][3] = 0.0;
  M->at[3][3] = diagonal0_final;
  M->at[4][3] = J_1_final;
  M->at[5][3] = J_2_final;
  M->at[0][4] = 0.0;
  M->at[1][4] = 0.0;
  M->at[2][4] = 0.0;
  M->at[3][4] = J_3_final;
  M->at[4][4] = diagonal1_final;
  M->at[5][4] = J_5_final;
  M->at[0][5] = 0.0;
  M->at[1][5] = 0.0;
  M->at[2][5] = 0.0;
  M->at[3][5] = J_6_final;
  M->at[4][5] = J_7_final;
  M->at[5][5] = diagonal2_final;
}

/* M = J_r(s) = Σ (-[ad](s))^k / (k+1)!.
   s: screw (v in m/s; ω in rad/s); M: 6×6 operator.
   321 mul, 819 add, 31 product error, 87 product rest, 10 div, 1 sqrt, 36 neg, 4 abs, 6 less, 19
     equal, 38 select.
   Error <= M: 1 u of its largest component for |ω of s| <= π; searched, not proved.  Each
     component is within 1 ulp as long as its condition is below 1e13; in single precision it is
     the nearest number, except near ties, as long as that is below 1e5; searched, not proved.
     Intermediate sums may overflow where |v| is above 2e306, in single precision 5e36. */
static inline void ksl_SE3_rightJacobian_accurate(const ksl_screw_t *s, ksl_mat6x6_t *M) {
  const double halved_0 = KSL_MUL(0.5, s->m3), halved_1 = KSL_MUL(0.5, s->m4),
      halved_2 = KSL_MUL(0.5, s->m5);
  const double y_a = KSL_MUL(halved_0, halved_0), y_b = KSL_MUL(halved_1, halved_1),
      y_c = y_a + y_b, y_c_right = y_c - y_a, y_d = KSL_MUL(halved_2, halved_2), y = y_c + y_d,
      y_right = y - y_c,
      y_c_lo = ksl_product_rest(halved_0, halved_0, y_a, y_c - y_c_right)
          + ksl_product_rest(halved_1, halved_1, y_b, y_c_right),
      y_lo = y_c - (y - y_right) + ksl_product_rest(halved_2, halved_2, y_d, y_right) + y_c_lo;
  const double y_sum = y + y_lo, y_sum_right = y_sum - y,
      y_sum_lo = y - (y_sum - y_sum_right) + (y_lo - y_sum_right), half_angle = sqrt(y_sum),
      half_angle_product = KSL_MUL(half_angle, half_angle),
      half_angle_twice = half_angle + half_angle,
      half_angle_residual = y_sum - half_angle_product
          - ksl_product_error(half_angle, half_angle, half_angle_product) + y_sum_lo,
      half_angle_lo = half_angle_residual / (half_angle == 0.0 ? 1.0 : half_angle_twice);
  const double half_angle_sum = half_angle + half_angle_lo,
      half_angle_sum_right = half_angle_sum - half_angle,
      half_angle_sum_lo = half_angle - (half_angle_sum - half_angle_sum_right)
          + (half_angle_lo - half_angle_sum_right);
  double c; const double sine = ksl_sincos(half_angle_sum, &c);
  double c_own_error; const double sine_own_error = ksl_sincos_error(half_angle_sum, sine, c,
      &c_own_error);
  const double sine_half = KSL_MUL(half_angle_sum_lo, 0.5);
  double sine_half_cos; const double sine_half_sin = ksl_sincos(sine_half, &sine_half_cos);
  const double sine_twice = sine_half_sin + sine_half_sin,
      sine_lo = sine_own_error
          + KSL_MUL(KSL_MUL(sine_half_cos, c) - KSL_MUL(sine_half_sin, sine), sine_twice);
  const double sinc_divisor = half_angle_sum < 1.4901161193847656e-08 ? 1.4901161193847656e-08
          : half_angle_sum,
      sinc_divisor_lo = half_angle_sum < 1.4901161193847656e-08 ? 0.0 : half_angle_sum_lo;
  const double sine_sum = sine + sine_lo, sine_sum_right = sine_sum - sine,
      sinc_divisor_sum = sinc_divisor + sinc_divisor_lo,
      sinc_divisor_sum_right = sinc_divisor_sum - sinc_divisor,
      sinc_quotient = sine_sum / sinc_divisor_sum,
      sinc_quotient_product = KSL_MUL(sinc_quotient, sinc_divisor_sum),
      sinc_quotient_exact = sine_sum - sinc_quotient_product
          - ksl_product_error(sinc_quotient, sinc_divisor_sum, sinc_quotient_product),
      sinc_quotient_cross = KSL_MUL(sinc_quotient, sinc_divisor
          - (sinc_divisor_sum - sinc_divisor_sum_right)
          + (sinc_divisor_lo - sinc_divisor_sum_right)),
      sinc_quotient_lo = (sinc_quotient_exact
          + (sine - (sine_sum - sine_sum_right) + (sine_lo - sine_sum_right))
          - sinc_quotient_cross) / sinc_divisor_sum;
  const double sinc_a = KSL_MUL(0.16666666666666666, y_sum), sinc_b = 1.0 - sinc_a,
      sinc_b_right = 1.0 - sinc_b,
      sinc_b_lo1 = 1.0 - (sinc_b + sinc_b_right)
          - ksl_product_rest(0.16666666666666666, y_sum, sinc_a, sinc_b_right),
      sinc_b_lo = sinc_b_lo1
          - (KSL_MUL(9.25185853854297e-18, y_sum) + KSL_MUL(0.16666666666666666, y_sum_lo)),
      sinc = half_angle_sum < 1.4901161193847656e-08 ? sinc_b : sinc_quotient,
      sinc_lo = half_angle_sum < 1.4901161193847656e-08 ? sinc_b_lo : sinc_quotient_lo;
  const double g1 = KSL_MUL(c, sinc),
      g1_cross = KSL_MUL(c_own_error
          - KSL_MUL(KSL_MUL(sine_half_cos, sine) + KSL_MUL(sine_half_sin, c), sine_twice), sinc)
          + KSL_MUL(c, sinc_lo);
  const double g2a = KSL_MUL(sinc, sinc), g2 = KSL_MUL(0.5, g2a),
      g2_cross2 = KSL_MUL(0.5, ksl_product_error(sinc, sinc, g2a)
          + (KSL_MUL(sinc_lo, sinc) + KSL_MUL(sinc, sinc_lo)));
  const double rest3 = 1.0 - g1, rest3_right = 1.0 - rest3,
      rest3_lo = 1.0 - (rest3 + rest3_right) - ksl_product_rest(c, sinc, g1, rest3_right)
          - g1_cross;
  const double x = KSL_MUL(4.0, y_sum), x_cross2 = KSL_MUL(4.0, y_sum_lo);
  const double x_sum = x + x_cross2, x_sum_right = x_sum - x,
      x_sum_lo = x - (x_sum - x_sum_right) + (x_cross2 - x_sum_right),
      far_x = x_sum < 1.0 ? 1.0 : x_sum, far_x_lo = x_sum < 1.0 ? 0.0 : x_sum_lo;
  const double rest3_sum = rest3 + rest3_lo, rest3_sum_right = rest3_sum - rest3,
      far_x_sum = far_x + far_x_lo, far_x_sum_right = far_x_sum - far_x,
      far_x_sum_lo = far_x - (far_x_sum - far_x_sum_right) + (far_x_lo - far_x_sum_right),
      closed3 = rest3_sum / far_x_sum, closed3_product = KSL_MUL(closed3, far_x_sum),
      closed3_exact = rest3_sum - closed3_product
          - ksl_product_error(closed3, far_x_sum, closed3_product),
      closed3_lo = (closed3_exact
          + (rest3 - (rest3_sum - rest3_sum_right) + (rest3_lo - rest3_sum_right))
          - KSL_MUL(closed3, far_x_sum_lo)) / far_x_sum;
  const double series5a = KSL_MUL(1.216125041553518e-34, x_sum),
      series5b = 1.1309962886447716e-31 - series5a,
      series5b_right = 1.1309962886447716e-31 - series5b,
      series5b_lo1 = 1.1309962886447716e-31 - (series5b + series5b_right)
          - ksl_product_rest(1.216125041553518e-34, x_sum, series5a, series5b_right),
      series5c = KSL_MUL(x_sum, series5b),
      series5b_lo = series5b_lo1
          - (KSL_MUL(5.586290567888806e-51, x_sum) + KSL_MUL(1.216125041553518e-34, x_sum_lo))
          + 1.0498015412959506e-47, series5d = series5c - 9.183689863795546e-29,
      series5d_right = series5c - series5d,
      series5d_lo1 = ksl_product_rest(x_sum, series5b, series5c, series5d + series5d_right)
          - (9.183689863795546e-29 - series5d_right), series5e = KSL_MUL(x_sum, series5d),
      series5e_cross2 = KSL_MUL(x_sum, series5d_lo1 - 1.4303150396787322e-45
          + (KSL_MUL(x_sum_lo, series5b) + KSL_MUL(x_sum, series5b_lo))),
      series5f = series5e + 6.446950284384474e-26, series5f_right = series5f - series5e,
      series5f_lo1 = ksl_product_rest(x_sum, series5d, series5e, series5f - series5f_right)
          + (6.446950284384474e-26 - series5f_right), series5g = KSL_MUL(x_sum, series5f),
      series5g_cross2 = KSL_MUL(x_sum, series5f_lo1 + -1.9330404233703465e-42
          + (KSL_MUL(x_sum_lo, series5d) + series5e_cross2)),
      series5h = series5g - 3.868170170630684e-23, series5h_right = series5g - series5h,
      series5h_lo1 = ksl_product_rest(x_sum, series5f, series5g, series5h + series5h_right)
          - (3.868170170630684e-23 - series5h_right), series5i = KSL_MUL(x_sum, series5h),
      series5j = series5i + 1.9572941063391263e-20, series5j_right = series5j - series5i,
      series5j_lo1 = ksl_product_rest(x_sum, series5h, series5i, series5j - series5j_right)
          + (1.9572941063391263e-20 - series5j_right),
      series5i_cross = KSL_MUL(x_sum_lo, series5h)
          + KSL_MUL(x_sum, series5h_lo1 - -8.843177655482344e-40
          + (KSL_MUL(x_sum_lo, series5f) + series5g_cross2)), series5k = KSL_MUL(x_sum, series5j),
      series5l = series5k - 8.22063524662433e-18, series5l_right = series5k - series5l,
      series5l_lo1 = ksl_product_rest(x_sum, series5j, series5k, series5l + series5l_right)
          - (8.22063524662433e-18 - series5l_right),
      series5k_cross = KSL_MUL(x_sum_lo, series5j)
          + KSL_MUL(x_sum, series5j_lo1 + -1.3643503830087908e-36 + series5i_cross),
      series5m = KSL_MUL(x_sum, series5l), series5n = series5m + 2.8114572543455206e-15,
      series5n_right = series5n - series5m,
      series5n_lo1 = ksl_product_rest(x_sum, series5l, series5m, series5n - series5n_right)
          + (2.8114572543455206e-15 - series5n_right),
      series5m_cross = KSL_MUL(x_sum_lo, series5l)
          + KSL_MUL(x_sum, series5l_lo1 - 2.2141894119604265e-34 + series5k_cross),
      series5o = KSL_MUL(x_sum, series5n), series5p = series5o - 7.647163731819816e-13,
      series5p_right = series5o - series5p,
      series5p_lo1 = ksl_product_rest(x_sum, series5n, series5o, series5p + series5p_right)
          - (7.647163731819816e-13 - series5p_right),
      series5o_cross = KSL_MUL(x_sum_lo, series5n)
          + KSL_MUL(x_sum, series5n_lo1 + 1.6508842730861433e-31 + series5m_cross),
      series5q = KSL_MUL(x_sum, series5p), series5r = series5q + 1.6059043836821613e-10,
      series5r_right = series5r - series5q,
      series5r_lo1 = ksl_product_rest(x_sum, series5p, series5q, series5r - series5r_right)
          + (1.6059043836821613e-10 - series5r_right),
      series5q_cross = KSL_MUL(x_sum_lo, series5p)
          + KSL_MUL(x_sum, series5p_lo1 - 7.03872877733453e-30 + series5o_cross),
      series5s = KSL_MUL(x_sum, series5r), series5t = series5s - 2.505210838544172e-08,
      series5t_right = series5s - series5t,
      series5t_lo1 = ksl_product_rest(x_sum, series5r, series5s, series5t + series5t_right)
          - (2.505210838544172e-08 - series5t_right),
      series5s_cross = KSL_MUL(x_sum_lo, series5r)
          + KSL_MUL(x_sum, series5r_lo1 + 1.2585294588752098e-26 + series5q_cross),
      series5u = KSL_MUL(x_sum, series5t), series5v = series5u + 2.7557319223985893e-06,
      series5v_right = series5v - series5u,
      series5v_lo1 = ksl_product_rest(x_sum, series5t, series5u, series5v - series5v_right)
          + (2.7557319223985893e-06 - series5v_right),
      series5u_cross = KSL_MUL(x_sum_lo, series5t)
          + KSL_MUL(x_sum, series5t_lo1 - -1.448814070935912e-24 + series5s_cross),
      series5w = KSL_MUL(x_sum, series5v), series5x = series5w - 0.0001984126984126984,
      series5x_right = series5w - series5x,
      series5x_lo1 = ksl_product_rest(x_sum, series5v, series5w, series5x + series5x_right)
          - (0.0001984126984126984 - series5x_right),
      series5w_cross = KSL_MUL(x_sum_lo, series5v)
          + KSL_MUL(x_sum, series5v_lo1 + -1.858393274046472e-22 + series5u_cross),
      series5y = KSL_MUL(x_sum, series5x), series5 = series5y + 0.008333333333333333,
      series5_right = series5 - series5y,
      series5_lo2 = ksl_product_rest(x_sum, series5x, series5y, series5 - series5_right)
          + (0.008333333333333333 - series5_right) + 1.1564823173178714e-19,
      series5_lo = series5_lo2
          + (KSL_MUL(x_sum_lo, series5x)
          + KSL_MUL(x_sum, series5x_lo1 - 1.7209558293420705e-22 + series5w_cross));
  const double g3a = KSL_MUL(x_sum, series5), g3b = 0.16666666666666666 - g3a,
      g3b_right = 0.16666666666666666 - g3b,
      g3b_lo1 = 0.16666666666666666 - (g3b + g3b_right)
          - ksl_product_rest(x_sum, series5, g3a, g3b_right),
      g3b_lo = g3b_lo1 - (KSL_MUL(x_sum_lo, series5) + KSL_MUL(x_sum, series5_lo))
          + 9.25185853854297e-18, g3 = x_sum < 1.0 ? g3b : closed3,
      g3_lo = x_sum < 1.0 ? g3b_lo : closed3_lo;
  const double rest4 = 0.5 - g2, rest4_right = 0.5 - rest4,
      rest4_lo = 0.5 - (rest4 + rest4_right) - (g2 - rest4_right) - g2_cross2;
  const double rest4_sum = rest4 + rest4_lo, rest4_sum_right = rest4_sum - rest4,
      closed4 = rest4_sum / far_x_sum, closed4_product = KSL_MUL(closed4, far_x_sum),
      closed4_exact = rest4_sum - closed4_product
          - ksl_product_error(closed4, far_x_sum, closed4_product),
      closed4_lo = (closed4_exact
          + (rest4 - (rest4_sum - rest4_sum_right) + (rest4_lo - rest4_sum_right))
          - KSL_MUL(closed4, far_x_sum_lo)) / far_x_sum;
  const double rest5 = 0.16666666666666666 - g3, rest5_right = 0.16666666666666666 - rest5,
      rest5_lo = 0.16666666666666666 - (rest5 + rest5_right) - (g3 - rest5_right) - g3_lo
          + 9.25185853854297e-18;
  const double rest5_sum = rest5 + rest5_lo, rest5_sum_right = rest5_sum - rest5,
      closed5 = rest5_sum / far_x_sum, closed5_product = KSL_MUL(closed5, far_x_sum),
      closed5_exact = rest5_sum - closed5_product
          - ksl_product_error(closed5, far_x_sum, closed5_product),
      closed5_lo = (closed5_exact
          + (rest5 - (rest5_sum - rest5_sum_right) + (rest5_lo - rest5_sum_right))
          - KSL_MUL(closed5, far_x_sum_lo)) / far_x_sum;
  const double series4a = KSL_MUL(3.7699876288159054e-33, x_sum),
      series4b = 3.279889237069838e-30 - series4a,
      series4b_right = 3.279889237069838e-30 - series4b,
      series4b_lo1 = 3.279889237069838e-30 - (series4b + series4b_right)
          - ksl_product_rest(3.7699876288159054e-33, x_sum, series4a, series4b_right),
      series4c = KSL_MUL(x_sum, series4b),
      series4b_lo = series4b_lo1
          - (KSL_MUL(2.5870347832750324e-49, x_sum) + KSL_MUL(3.7699876288159054e-33, x_sum_lo))
          + 1.5117542744029879e-46, series4d = series4c - 2.4795962632247976e-27,
      series4d_right = series4c - series4d,
      series4d_lo1 = ksl_product_rest(x_sum, series4b, series4c, series4d + series4d_right)
          - (2.4795962632247976e-27 - series4d_right), series4e = KSL_MUL(x_sum, series4d),
      series4e_cross2 = KSL_MUL(x_sum, series4d_lo1 - -1.2953730964765229e-43
          + (KSL_MUL(x_sum_lo, series4b) + KSL_MUL(x_sum, series4b_lo))),
      series4f = series4e + 1.6117375710961184e-24, series4f_right = series4f - series4e,
      series4f_lo1 = ksl_product_rest(x_sum, series4d, series4e, series4f - series4f_right)
          + (1.6117375710961184e-24 - series4f_right), series4g = KSL_MUL(x_sum, series4f),
      series4g_cross2 = KSL_MUL(x_sum, series4f_lo1 + -3.6846573564509766e-41
          + (KSL_MUL(x_sum_lo, series4d) + series4e_cross2)),
      series4h = series4g - 8.896791392450574e-22, series4h_right = series4g - series4h,
      series4h_lo1 = ksl_product_rest(x_sum, series4f, series4g, series4h + series4h_right)
          - (8.896791392450574e-22 - series4h_right), series4i = KSL_MUL(x_sum, series4h),
      series4j = series4i + 4.110317623312165e-19, series4j_right = series4j - series4i,
      series4j_lo1 = ksl_product_rest(x_sum, series4h, series4i, series4j - series4j_right)
          + (4.110317623312165e-19 - series4j_right),
      series4i_cross = KSL_MUL(x_sum_lo, series4h)
          + KSL_MUL(x_sum, series4h_lo1 - -7.911402614872376e-38
          + (KSL_MUL(x_sum_lo, series4f) + series4g_cross2)), series4k = KSL_MUL(x_sum, series4j),
      series4l = series4k - 1.5619206968586225e-16, series4l_right = series4k - series4l,
      series4l_lo1 = ksl_product_rest(x_sum, series4j, series4k, series4l + series4l_right)
          - (1.5619206968586225e-16 - series4l_right),
      series4k_cross = KSL_MUL(x_sum_lo, series4j)
          + KSL_MUL(x_sum, series4j_lo1 + 1.4412973378659527e-36 + series4i_cross),
      series4m = KSL_MUL(x_sum, series4l), series4n = series4m + 4.779477332387385e-14,
      series4n_right = series4n - series4m,
      series4n_lo1 = ksl_product_rest(x_sum, series4l, series4m, series4n - series4n_right)
          + (4.779477332387385e-14 - series4n_right),
      series4m_cross = KSL_MUL(x_sum_lo, series4l)
          + KSL_MUL(x_sum, series4l_lo1 - 1.1910679660273754e-32 + series4k_cross),
      series4o = KSL_MUL(x_sum, series4n), series4p = series4o - 1.1470745597729725e-11,
      series4p_right = series4o - series4p,
      series4p_lo1 = ksl_product_rest(x_sum, series4n, series4o, series4p + series4p_right)
          - (1.1470745597729725e-11 - series4p_right),
      series4o_cross = KSL_MUL(x_sum_lo, series4n)
          + KSL_MUL(x_sum, series4n_lo1 + 4.399205485834081e-31 + series4m_cross),
      series4q = KSL_MUL(x_sum, series4p), series4r = series4q + 2.08767569878681e-09,
      series4r_right = series4r - series4q,
      series4r_lo1 = ksl_product_rest(x_sum, series4p, series4q, series4r - series4r_right)
          + (2.08767569878681e-09 - series4r_right),
      series4q_cross = KSL_MUL(x_sum_lo, series4p)
          + KSL_MUL(x_sum, series4p_lo1 - 2.0655512752830745e-28 + series4o_cross),
      series4s = KSL_MUL(x_sum, series4r), series4t = series4s - 2.755731922398589e-07,
      series4t_right = series4s - series4t,
      series4t_lo1 = ksl_product_rest(x_sum, series4r, series4s, series4t + series4t_right)
          - (2.755731922398589e-07 - series4t_right),
      series4s_cross = KSL_MUL(x_sum_lo, series4r)
          + KSL_MUL(x_sum, series4r_lo1 + -1.20734505911326e-25 + series4q_cross),
      series4u = KSL_MUL(x_sum, series4t), series4v = series4u + 2.48015873015873e-05,
      series4v_right = series4v - series4u,
      series4v_lo1 = ksl_product_rest(x_sum, series4t, series4u, series4v - series4v_right)
          + (2.48015873015873e-05 - series4v_right),
      series4u_cross = KSL_MUL(x_sum_lo, series4t)
          + KSL_MUL(x_sum, series4t_lo1 - 2.3767714622250297e-23 + series4s_cross),
      series4w = KSL_MUL(x_sum, series4v), series4x = series4w - 0.001388888888888889,
      series4x_right = series4w - series4x,
      series4x_lo1 = ksl_product_rest(x_sum, series4v, series4w, series4x + series4x_right)
          - (0.001388888888888889 - series4x_right),
      series4w_cross = KSL_MUL(x_sum_lo, series4v)
          + KSL_MUL(x_sum, series4v_lo1 + 2.1511947866775882e-23 + series4u_cross),
      series4y = KSL_MUL(x_sum, series4x), series4 = series4y + 0.041666666666666664,
      series4_right = series4 - series4y,
      series4_lo2 = ksl_product_rest(x_sum, series4x, series4y, series4 - series4_right)
          + (0.041666666666666664 - series4_right) + 2.3129646346357427e-18,
      series4_lo = series4_lo2
          + (KSL_MUL(x_sum_lo, series4x)
          + KSL_MUL(x_sum, series4x_lo1 - -5.300543954373577e-20 + series4w_cross));
  const double g4 = x_sum < 1.0 ? series4 : closed4, g4_lo = x_sum < 1.0 ? series4_lo : closed4_lo;
  const double g5 = x_sum < 1.0 ? series5 : closed5;
  const double rate2a = KSL_MUL(2.0, g4), rate2 = rate2a - g3, rate2_right = rate2a - rate2;
  const double rate3a = KSL_MUL(3.0, g5), rate3 = rate3a - g4, rate3_right = rate3a - rate3;
  const double beta_v_0 = KSL_MUL(s->m3, g3), beta_v_1 = KSL_MUL(s->m4, g3),
      beta_v_2 = KSL_MUL(s->m5, g3);
  const double beta_v_0_lo = ksl_product_error(s->m3, g3, beta_v_0) + KSL_MUL(s->m3, g3_lo),
      m_0 = KSL_MUL(s->m3, beta_v_0), m_0_cross2 = KSL_MUL(s->m3, beta_v_0_lo);
  const double beta_v_1_lo = ksl_product_error(s->m4, g3, beta_v_1) + KSL_MUL(s->m4, g3_lo),
      m_1 = KSL_MUL(s->m4, beta_v_1), m_1_cross2 = KSL_MUL(s->m4, beta_v_1_lo);
  const double m_2 = KSL_MUL(s->m5, beta_v_2),
      m_2_cross2 = KSL_MUL(s->m5, ksl_product_error(s->m5, g3, beta_v_2) + KSL_MUL(s->m5, g3_lo));
  const double m_3 = KSL_MUL(s->m4, beta_v_0), m_3_cross2 = KSL_MUL(s->m4, beta_v_0_lo);
  const double m_4 = KSL_MUL(s->m5, beta_v_0), m_4_cross2 = KSL_MUL(s->m5, beta_v_0_lo);
  const double m_5 = KSL_MUL(s->m5, beta_v_1), m_5_cross2 = KSL_MUL(s->m5, beta_v_1_lo);
  const double others_0 = m_1 + m_2, others_0_right = others_0 - m_1,
      others_0_lo1 = ksl_product_rest(s->m4, beta_v_1, m_1, others_0 - others_0_right)
          + ksl_product_rest(s->m5, beta_v_2, m_2, others_0_right),
      others_0_lo = others_0_lo1 + (m_1_cross2 + m_2_cross2);
  const double others_1 = m_0 + m_2, others_1_right = others_1 - m_0,
      others_1_lo1 = ksl_product_rest(s->m3, beta_v_0, m_0, others_1 - others_1_right)
          + ksl_product_rest(s->m5, beta_v_2, m_2, others_1_right),
      others_1_lo = others_1_lo1 + (m_0_cross2 + m_2_cross2);
  const double others_2 = m_0 + m_1, others_2_right = others_2 - m_0,
      others_2_lo1 = ksl_product_rest(s->m3, beta_v_0, m_0, others_2 - others_2_right)
          + ksl_product_rest(s->m4, beta_v_1, m_1, others_2_right),
      others_2_lo = others_2_lo1 + (m_0_cross2 + m_1_cross2);
  const double diagonal0a = 1.0 - others_0, diagonal0a_right = 1.0 - diagonal0a,
      diagonal0a_lo = 1.0 - (diagonal0a + diagonal0a_right) - (others_0 - diagonal0a_right)
          - others_0_lo, diagonal0b = g1 + m_0, diagonal0b_right = diagonal0b - g1,
      diagonal0b_lo1 = ksl_product_rest(c, sinc, g1, diagonal0b - diagonal0b_right)
          + ksl_product_rest(s->m3, beta_v_0, m_0, diagonal0b_right),
      diagonal0b_lo = diagonal0b_lo1 + (g1_cross + m_0_cross2),
      m_0_sum = m_0 + (ksl_product_error(s->m3, beta_v_0, m_0) + m_0_cross2),
      others_0_sum = others_0 + others_0_lo,
      diagonal0 = m_0_sum < others_0_sum ? diagonal0b : diagonal0a;
  const double diagonal1a = 1.0 - others_1, diagonal1a_right = 1.0 - diagonal1a,
      diagonal1a_lo = 1.0 - (diagonal1a + diagonal1a_right) - (others_1 - diagonal1a_right)
          - others_1_lo, diagonal1b = g1 + m_1, diagonal1b_right = diagonal1b - g1,
      diagonal1b_lo1 = ksl_product_rest(c, sinc, g1, diagonal1b - diagonal1b_right)
          + ksl_product_rest(s->m4, beta_v_1, m_1, diagonal1b_right),
      diagonal1b_lo = diagonal1b_lo1 + (g1_cross + m_1_cross2),
      m_1_sum = m_1 + (ksl_product_error(s->m4, beta_v_1, m_1) + m_1_cross2),
      others_1_sum = others_1 + others_1_lo,
      diagonal1 = m_1_sum < others_1_sum ? diagonal1b : diagonal1a;
  const double diagonal2a = 1.0 - others_2, diagonal2a_right = 1.0 - diagonal2a,
      diagonal2a_lo = 1.0 - (diagonal2a + diagonal2a_right) - (others_2 - diagonal2a_right)
          - others_2_lo, diagonal2b = g1 + m_2, diagonal2b_right = diagonal2b - g1,
      diagonal2b_lo1 = ksl_product_rest(c, sinc, g1, diagonal2b - diagonal2b_right)
          + ksl_product_rest(s->m5, beta_v_2, m_2, diagonal2b_right),
      diagonal2b_lo = diagonal2b_lo1 + (g1_cross + m_2_cross2),
      m_2_sum = m_2 + (ksl_product_error(s->m5, beta_v_2, m_2) + m_2_cross2),
      others_2_sum = others_2 + others_2_lo,
      diagonal2 = m_2_sum < others_2_sum ? diagonal2b : diagonal2a;
  const double alpha_v_0 = -KSL_MUL(s->m3, g2), alpha_v_0_cross = -KSL_MUL(s->m3, g2_cross2),
      alpha_v_0_factor = -s->m3;
  const double alpha_v_1 = -KSL_MUL(s->m4, g2), alpha_v_1_cross = -KSL_MUL(s->m4, g2_cross2),
      alpha_v_1_factor = -s->m4;
  const double alpha_v_2 = -KSL_MUL(s->m5, g2), alpha_v_2_cross = -KSL_MUL(s->m5, g2_cross2),
      alpha_v_2_factor = -s->m5;
  const double J_1 = m_3 - alpha_v_2, J_1_right = m_3 - J_1,
      J_1_lo1 = ksl_product_rest(s->m4, beta_v_0, m_3, J_1 + J_1_right)
          - ksl_product_rest(alpha_v_2_factor, g2, alpha_v_2, J_1_right);
  const double J_2 = m_4 + alpha_v_1, J_2_right = J_2 - m_4,
      J_2_lo1 = ksl_product_rest(s->m5, beta_v_0, m_4, J_2 - J_2_right)
          + ksl_product_rest(alpha_v_1_factor, g2, alpha_v_1, J_2_right);
  const double J_3 = m_3 + alpha_v_2, J_3_right = J_3 - m_3,
      J_3_lo1 = ksl_product_rest(s->m4, beta_v_0, m_3, J_3 - J_3_right)
          + ksl_product_rest(alpha_v_2_factor, g2, alpha_v_2, J_3_right);
  const double J_5 = m_5 - alpha_v_0, J_5_right = m_5 - J_5,
      J_5_lo1 = ksl_product_rest(s->m5, beta_v_1, m_5, J_5 + J_5_right)
          - ksl_product_rest(alpha_v_0_factor, g2, alpha_v_0, J_5_right);
  const double J_6 = m_4 - alpha_v_1, J_6_right = m_4 - J_6,
      J_6_lo1 = ksl_product_rest(s->m5, beta_v_0, m_4, J_6 + J_6_right)
          - ksl_product_rest(alpha_v_1_factor, g2, alpha_v_1, J_6_right);
  const double J_7 = m_5 + alpha_v_0, J_7_right = J_7 - m_5,
      J_7_lo1 = ksl_product_rest(s->m5, beta_v_1, m_5, J_7 - J_7_right)
          + ksl_product_rest(alpha_v_0_factor, g2, alpha_v_0, J_7_right);
  const double rate_vw_a = KSL_MUL(s->m0, s->m3), rate_vw_b = KSL_MUL(s->m1, s->m4),
      rate_vw_c = rate_vw_a + rate_vw_b, rate_vw_c_right = rate_vw_c - rate_vw_a,
      rate_vw_d = KSL_MUL(s->m2, s->m5), rate_vw = rate_vw_c + rate_vw_d,
      rate_vw_right = rate_vw - rate_vw_c,
      rate_vw_c_lo = ksl_product_rest(s->m0, s->m3, rate_vw_a, rate_vw_c - rate_vw_c_right)
          + ksl_product_rest(s->m1, s->m4, rate_vw_b, rate_vw_c_right),
      rate_vw_lo = rate_vw_c - (rate_vw - rate_vw_right)
          + ksl_product_rest(s->m2, s->m5, rate_vw_d, rate_vw_right) + rate_vw_c_lo;
  const double rate_turn = KSL_MUL(rate2, rate_vw);
  const double rate3_lo = ksl_product_rest(3.0, g5, rate3a, rate3 + rate3_right)
          - (g4 - rate3_right) - g4_lo + KSL_MUL(3.0, x_sum < 1.0 ? series5_lo : closed5_lo);
  const double rate_bend = -KSL_MUL(rate3, rate_vw);
  const double rate_q_0a = KSL_MUL(s->m0, g2);
  const double rate_turn_cross = KSL_MUL(rate2a - (rate2 + rate2_right) - (g3 - rate2_right)
          - g3_lo + KSL_MUL(2.0, g4_lo), rate_vw) + KSL_MUL(rate2, rate_vw_lo);
  const double rate_turn_lo = ksl_product_error(rate2, rate_vw, rate_turn) + rate_turn_cross,
      rate_q_0b = KSL_MUL(s->m3, rate_turn), rate_q_0c = rate_q_0a + rate_q_0b,
      rate_q_0c_right = rate_q_0c - rate_q_0a,
      rate_q_0c_lo1 = ksl_product_rest(s->m0, g2, rate_q_0a, rate_q_0c - rate_q_0c_right)
          + ksl_product_rest(s->m3, rate_turn, rate_q_0b, rate_q_0c_right), rate_q_0 = -rate_q_0c,
      rate_q_0_lo = -(rate_q_0c_lo1 + (KSL_MUL(s->m0, g2_cross2) + KSL_MUL(s->m3, rate_turn_lo)));
  const double rate_q_1a = KSL_MUL(s->m1, g2), rate_q_1b = KSL_MUL(s->m4, rate_turn),
      rate_q_1c = rate_q_1a + rate_q_1b, rate_q_1c_right = rate_q_1c - rate_q_1a,
      rate_q_1c_lo1 = ksl_product_rest(s->m1, g2, rate_q_1a, rate_q_1c - rate_q_1c_right)
          + ksl_product_rest(s->m4, rate_turn, rate_q_1b, rate_q_1c_right), rate_q_1 = -rate_q_1c,
      rate_q_1_lo = -(rate_q_1c_lo1 + (KSL_MUL(s->m1, g2_cross2) + KSL_MUL(s->m4, rate_turn_lo)));
  const double rate_q_2a = KSL_MUL(s->m2, g2), rate_q_2b = KSL_MUL(s->m5, rate_turn),
      rate_q_2c = rate_q_2a + rate_q_2b, rate_q_2c_right = rate_q_2c - rate_q_2a,
      rate_q_2c_lo1 = ksl_product_rest(s->m2, g2, rate_q_2a, rate_q_2c - rate_q_2c_right)
          + ksl_product_rest(s->m5, rate_turn, rate_q_2b, rate_q_2c_right), rate_q_2 = -rate_q_2c,
      rate_q_2_lo = -(rate_q_2c_lo1 + (KSL_MUL(s->m2, g2_cross2) + KSL_MUL(s->m5, rate_turn_lo)));
  const double rate_beta_v_0 = -KSL_MUL(s->m0, g3), rate_beta_v_1 = -KSL_MUL(s->m1, g3),
      rate_beta_v_2 = -KSL_MUL(s->m2, g3);
  const double rate_bend_lo = ksl_product_error(-rate3, rate_vw, rate_bend) +
          -(KSL_MUL(rate3_lo, rate_vw) + KSL_MUL(rate3, rate_vw_lo)),
      rate_bend_w_0 = -KSL_MUL(s->m3, rate_bend);
  const double rate_bend_w_1 = -KSL_MUL(s->m4, rate_bend),
      rate_bend_w_2 = -KSL_MUL(s->m5, rate_bend);
  const double rate_bend_w_0_lo = ksl_product_error(-s->m3, rate_bend, rate_bend_w_0) +
          -KSL_MUL(s->m3, rate_bend_lo), rate_symmetric_0a = KSL_MUL(s->m4, rate_bend_w_0),
      rate_beta_v_1_lo = ksl_product_error(-s->m1, g3, rate_beta_v_1) + -KSL_MUL(s->m1, g3_lo),
      rate_symmetric_0b = KSL_MUL(s->m3, rate_beta_v_1),
      rate_beta_v_0_lo = ksl_product_error(-s->m0, g3, rate_beta_v_0) + -KSL_MUL(s->m0, g3_lo),
      rate_symmetric_0c = KSL_MUL(s->m4, rate_beta_v_0),
      rate_symmetric_0d = rate_symmetric_0b + rate_symmetric_0c,
      rate_symmetric_0d_right = rate_symmetric_0d - rate_symmetric_0b,
      rate_symmetric_0d_left_rest = ksl_product_rest(s->m3, rate_beta_v_1, rate_symmetric_0b,
          rate_symmetric_0d - rate_symmetric_0d_right),
      rate_symmetric_0d_lo1 = rate_symmetric_0d_left_rest
          + ksl_product_rest(s->m4, rate_beta_v_0, rate_symmetric_0c, rate_symmetric_0d_right),
      rate_symmetric_0 = rate_symmetric_0a - rate_symmetric_0d,
      rate_symmetric_0_right = rate_symmetric_0a - rate_symmetric_0,
      rate_symmetric_0_left_rest = ksl_product_rest(s->m4, rate_bend_w_0, rate_symmetric_0a,
          rate_symmetric_0 + rate_symmetric_0_right),
      rate_symmetric_0d_lo = rate_symmetric_0d_lo1
          + (KSL_MUL(s->m3, rate_beta_v_1_lo) + KSL_MUL(s->m4, rate_beta_v_0_lo)),
      rate_symmetric_0_lo2 = rate_symmetric_0_left_rest
          - (rate_symmetric_0d - rate_symmetric_0_right) - rate_symmetric_0d_lo,
      rate_symmetric_0_lo = rate_symmetric_0_lo2 + KSL_MUL(s->m4, rate_bend_w_0_lo);
  const double rate_symmetric_1a = KSL_MUL(s->m5, rate_bend_w_0),
      rate_beta_v_2_lo = ksl_product_error(-s->m2, g3, rate_beta_v_2) + -KSL_MUL(s->m2, g3_lo),
      rate_symmetric_1b = KSL_MUL(s->m3, rate_beta_v_2),
      rate_symmetric_1c = KSL_MUL(s->m5, rate_beta_v_0),
      rate_symmetric_1d = rate_symmetric_1b + rate_symmetric_1c,
      rate_symmetric_1d_right = rate_symmetric_1d - rate_symmetric_1b,
      rate_symmetric_1d_left_rest = ksl_product_rest(s->m3, rate_beta_v_2, rate_symmetric_1b,
          rate_symmetric_1d - rate_symmetric_1d_right),
      rate_symmetric_1d_lo1 = rate_symmetric_1d_left_rest
          + ksl_product_rest(s->m5, rate_beta_v_0, rate_symmetric_1c, rate_symmetric_1d_right),
      rate_symmetric_1 = rate_symmetric_1a - rate_symmetric_1d,
      rate_symmetric_1_right = rate_symmetric_1a - rate_symmetric_1,
      rate_symmetric_1_left_rest = ksl_product_rest(s->m5, rate_bend_w_0, rate_symmetric_1a,
          rate_symmetric_1 + rate_symmetric_1_right),
      rate_symmetric_1d_lo = rate_symmetric_1d_lo1
          + (KSL_MUL(s->m3, rate_beta_v_2_lo) + KSL_MUL(s->m5, rate_beta_v_0_lo)),
      rate_symmetric_1_lo2 = rate_symmetric_1_left_rest
          - (rate_symmetric_1d - rate_symmetric_1_right) - rate_symmetric_1d_lo,
      rate_symmetric_1_lo = rate_symmetric_1_lo2 + KSL_MUL(s->m5, rate_bend_w_0_lo);
  const double rate_bend_w_1_lo = ksl_product_error(-s->m4, rate_bend, rate_bend_w_1) +
          -KSL_MUL(s->m4, rate_bend_lo), rate_symmetric_2a = KSL_MUL(s->m5, rate_bend_w_1),
      rate_symmetric_2b = KSL_MUL(s->m4, rate_beta_v_2),
      rate_symmetric_2c = KSL_MUL(s->m5, rate_beta_v_1),
      rate_symmetric_2d = rate_symmetric_2b + rate_symmetric_2c,
      rate_symmetric_2d_right = rate_symmetric_2d - rate_symmetric_2b,
      rate_symmetric_2d_left_rest = ksl_product_rest(s->m4, rate_beta_v_2, rate_symmetric_2b,
          rate_symmetric_2d - rate_symmetric_2d_right),
      rate_symmetric_2d_lo1 = rate_symmetric_2d_left_rest
          + ksl_product_rest(s->m5, rate_beta_v_1, rate_symmetric_2c, rate_symmetric_2d_right),
      rate_symmetric_2 = rate_symmetric_2a - rate_symmetric_2d,
      rate_symmetric_2_right = rate_symmetric_2a - rate_symmetric_2,
      rate_symmetric_2_left_rest = ksl_product_rest(s->m5, rate_bend_w_1, rate_symmetric_2a,
          rate_symmetric_2 + rate_symmetric_2_right),
      rate_symmetric_2d_lo = rate_symmetric_2d_lo1
          + (KSL_MUL(s->m4, rate_beta_v_2_lo) + KSL_MUL(s->m5, rate_beta_v_1_lo)),
      rate_symmetric_2_lo2 = rate_symmetric_2_left_rest
          - (rate_symmetric_2d - rate_symmetric_2_right) - rate_symmetric_2d_lo,
      rate_symmetric_2_lo = rate_symmetric_2_lo2 + KSL_MUL(s->m5, rate_bend_w_1_lo);
  const double rate_diagonal_0a = KSL_MUL(2.0, s->m4),
      rate_diagonal_0b = KSL_MUL(rate_diagonal_0a, rate_beta_v_1),
      rate_diagonal_0b_cross2 = KSL_MUL(rate_diagonal_0a, rate_beta_v_1_lo),
      rate_diagonal_0c = KSL_MUL(2.0, s->m5),
      rate_diagonal_0d = KSL_MUL(rate_diagonal_0c, rate_beta_v_2),
      rate_diagonal_0d_cross2 = KSL_MUL(rate_diagonal_0c, rate_beta_v_2_lo),
      rate_diagonal_0e = rate_diagonal_0b + rate_diagonal_0d,
      rate_diagonal_0e_right = rate_diagonal_0e - rate_diagonal_0b,
      rate_diagonal_0e_left_rest = ksl_product_rest(rate_diagonal_0a, rate_beta_v_1,
          rate_diagonal_0b, rate_diagonal_0e - rate_diagonal_0e_right),
      rate_diagonal_0e_lo1 = rate_diagonal_0e_left_rest
          + ksl_product_rest(rate_diagonal_0c, rate_beta_v_2, rate_diagonal_0d,
              rate_diagonal_0e_right),
      rate_diagonal_0f = KSL_MUL(s->m4, rate_bend_w_1),
      rate_diagonal_0f_cross2 = KSL_MUL(s->m4, rate_bend_w_1_lo),
      rate_diagonal_0g = KSL_MUL(s->m5, rate_bend_w_2),
      rate_diagonal_0g_cross2 = KSL_MUL(s->m5, ksl_product_error(-s->m5, rate_bend, rate_bend_w_2)
          + -KSL_MUL(s->m5, rate_bend_lo)), rate_diagonal_0h = rate_diagonal_0f + rate_diagonal_0g,
      rate_diagonal_0h_right = rate_diagonal_0h - rate_diagonal_0f,
      rate_diagonal_0h_left_rest = ksl_product_rest(s->m4, rate_bend_w_1, rate_diagonal_0f,
          rate_diagonal_0h - rate_diagonal_0h_right),
      rate_diagonal_0h_lo1 = rate_diagonal_0h_left_rest
          + ksl_product_rest(s->m5, rate_bend_w_2, rate_diagonal_0g, rate_diagonal_0h_right),
      rate_diagonal_0 = rate_diagonal_0e - rate_diagonal_0h,
      rate_diagonal_0_right = rate_diagonal_0e - rate_diagonal_0,
      rate_diagonal_0_lo1 = rate_diagonal_0e - (rate_diagonal_0 + rate_diagonal_0_right)
          - (rate_diagonal_0h - rate_diagonal_0_right),
      rate_diagonal_0_lo2 = rate_diagonal_0_lo1
          - (rate_diagonal_0h_lo1 + (rate_diagonal_0f_cross2 + rate_diagonal_0g_cross2));
  const double rate_diagonal_1a = KSL_MUL(2.0, s->m3),
      rate_diagonal_1b = KSL_MUL(rate_diagonal_1a, rate_beta_v_0),
      rate_diagonal_1b_cross2 = KSL_MUL(rate_diagonal_1a, rate_beta_v_0_lo),
      rate_diagonal_1c = rate_diagonal_1b + rate_diagonal_0d,
      rate_diagonal_1c_right = rate_diagonal_1c - rate_diagonal_1b,
      rate_diagonal_1c_left_rest = ksl_product_rest(rate_diagonal_1a, rate_beta_v_0,
          rate_diagonal_1b, rate_diagonal_1c - rate_diagonal_1c_right),
      rate_diagonal_1c_lo1 = rate_diagonal_1c_left_rest
          + ksl_product_rest(rate_diagonal_0c, rate_beta_v_2, rate_diagonal_0d,
              rate_diagonal_1c_right),
      rate_diagonal_1d = KSL_MUL(s->m3, rate_bend_w_0),
      rate_diagonal_1d_cross2 = KSL_MUL(s->m3, rate_bend_w_0_lo),
      rate_diagonal_1e = rate_diagonal_1d + rate_diagonal_0g,
      rate_diagonal_1e_right = rate_diagonal_1e - rate_diagonal_1d,
      rate_diagonal_1e_left_rest = ksl_product_rest(s->m3, rate_bend_w_0, rate_diagonal_1d,
          rate_diagonal_1e - rate_diagonal_1e_right),
      rate_diagonal_1e_lo1 = rate_diagonal_1e_left_rest
          + ksl_product_rest(s->m5, rate_bend_w_2, rate_diagonal_0g, rate_diagonal_1e_right),
      rate_diagonal_1 = rate_diagonal_1c - rate_diagonal_1e,
      rate_diagonal_1_right = rate_diagonal_1c - rate_diagonal_1,
      rate_diagonal_1_lo1 = rate_diagonal_1c - (rate_diagonal_1 + rate_diagonal_1_right)
          - (rate_diagonal_1e - rate_diagonal_1_right),
      rate_diagonal_1_lo2 = rate_diagonal_1_lo1
          - (rate_diagonal_1e_lo1 + (rate_diagonal_1d_cross2 + rate_diagonal_0g_cross2));
  const double rate_diagonal_2a = rate_diagonal_1b + rate_diagonal_0b,
      rate_diagonal_2a_right = rate_diagonal_2a - rate_diagonal_1b,
      rate_diagonal_2a_left_rest = ksl_product_rest(rate_diagonal_1a, rate_beta_v_0,
          rate_diagonal_1b, rate_diagonal_2a - rate_diagonal_2a_right),
      rate_diagonal_2a_lo1 = rate_diagonal_2a_left_rest
          + ksl_product_rest(rate_diagonal_0a, rate_beta_v_1, rate_diagonal_0b,
              rate_diagonal_2a_right),
      rate_diagonal_2b = rate_diagonal_1d + rate_diagonal_0f,
      rate_diagonal_2b_right = rate_diagonal_2b - rate_diagonal_1d,
      rate_diagonal_2b_left_rest = ksl_product_rest(s->m3, rate_bend_w_0, rate_diagonal_1d,
          rate_diagonal_2b - rate_diagonal_2b_right),
      rate_diagonal_2b_lo1 = rate_diagonal_2b_left_rest
          + ksl_product_rest(s->m4, rate_bend_w_1, rate_diagonal_0f, rate_diagonal_2b_right),
      rate_diagonal_2 = rate_diagonal_2a - rate_diagonal_2b,
      rate_diagonal_2_right = rate_diagonal_2a - rate_diagonal_2,
      rate_diagonal_2_lo1 = rate_diagonal_2a - (rate_diagonal_2 + rate_diagonal_2_right)
          - (rate_diagonal_2b - rate_diagonal_2_right),
      rate_diagonal_2_lo2 = rate_diagonal_2_lo1
          - (rate_diagonal_2b_lo1 + (rate_diagonal_1d_cross2 + rate_diagonal_0f_cross2));
  const double M_04 = rate_symmetric_0 - rate_q_2, M_04_right = rate_symmetric_0 - M_04;
  const double M_05 = rate_q_1 + rate_symmetric_1, M_05_right = M_05 - rate_q_1;
  const double M_13 = rate_q_2 + rate_symmetric_0, M_13_right = M_13 - rate_q_2;
  const double M_15 = rate_symmetric_2 - rate_q_0, M_15_right = rate_symmetric_2 - M_15;
  const double M_23 = rate_symmetric_1 - rate_q_1, M_23_right = rate_symmetric_1 - M_23;
  const double M_24 = rate_q_0 + rate_symmetric_2, M_24_right = M_24 - rate_q_0;
  const double diagonal0_rounded = diagonal0
          + (m_0_sum < others_0_sum ? diagonal0b_lo : diagonal0a_lo),
      diagonal0_final = diagonal0_rounded == diagonal0_rounded ? diagonal0_rounded : diagonal0;
  const double J_1_rounded = J_1 + (J_1_lo1 + (m_3_cross2 - alpha_v_2_cross)),
      J_1_final = J_1_rounded == J_1_rounded ? J_1_rounded : J_1;
  const double J_2_rounded = J_2 + (J_2_lo1 + (m_4_cross2 + alpha_v_1_cross)),
      J_2_final = J_2_rounded == J_2_rounded ? J_2_rounded : J_2;
  const double rate_diagonal_0_rounded = rate_diagonal_0
          + (rate_diagonal_0_lo2
          + (rate_diagonal_0e_lo1 + (rate_diagonal_0b_cross2 + rate_diagonal_0d_cross2)));
  const double M_04_rounded = M_04
          + (rate_symmetric_0 - (M_04 + M_04_right) - (rate_q_2 - M_04_right) - rate_q_2_lo
          + rate_symmetric_0_lo);
  const double M_05_rounded = M_05
          + (rate_q_1 - (M_05 - M_05_right) + (rate_symmetric_1 - M_05_right) + rate_symmetric_1_lo
          + rate_q_1_lo);
  const double J_3_rounded = J_3 + (J_3_lo1 + (m_3_cross2 + alpha_v_2_cross)),
      J_3_final = J_3_rounded == J_3_rounded ? J_3_rounded : J_3;
  const double diagonal1_rounded = diagonal1
          + (m_1_sum < others_1_sum ? diagonal1b_lo : diagonal1a_lo),
      diagonal1_final = diagonal1_rounded == diagonal1_rounded ? diagonal1_rounded : diagonal1;
  const double J_5_rounded = J_5 + (J_5_lo1 + (m_5_cross2 - alpha_v_0_cross)),
      J_5_final = J_5_rounded == J_5_rounded ? J_5_rounded : J_5;
  const double M_13_rounded = M_13
          + (rate_q_2 - (M_13 - M_13_right) + (rate_symmetric_0 - M_13_right) + rate_symmetric_0_lo
          + rate_q_2_lo);
  const double rate_diagonal_1_rounded = rate_diagonal_1
          + (rate_diagonal_1_lo2
          + (rate_diagonal_1c_lo1 + (rate_diagonal_1b_cross2 + rate_diagonal_0d_cross2)));
  const double M_15_rounded = M_15
          + (rate_symmetric_2 - (M_15 + M_15_right) - (rate_q_0 - M_15_right) - rate_q_0_lo
          + rate_symmetric_2_lo);
  const double J_6_rounded = J_6 + (J_6_lo1 + (m_4_cross2 - alpha_v_1_cross)),
      J_6_final = J_6_rounded == J_6_rounded ? J_6_rounded : J_6;
  const double J_7_rounded = J_7 + (J_7_lo1 + (m_5_cross2 + alpha_v_0_cross)),
      J_7_final = J_7_rounded == J_7_rounded ? J_7_rounded : J_7;
  const double diagonal2_rounded = diagonal2
          + (m_2_sum < others_2_sum ? diagonal2b_lo : diagonal2a_lo),
      diagonal2_final = diagonal2_rounded == diagonal2_rounded ? diagonal2_rounded : diagonal2;
  const double M_23_rounded = M_23
          + (rate_symmetric_1 - (M_23 + M_23_right) - (rate_q_1 - M_23_right) - rate_q_1_lo
          + rate_symmetric_1_lo);
  const double M_24_rounded = M_24
          + (rate_q_0 - (M_24 - M_24_right) + (rate_symmetric_2 - M_24_right) + rate_symmetric_2_lo
          + rate_q_0_lo);
  const double rate_diagonal_2_rounded = rate_diagonal_2
          + (rate_diagonal_2_lo2
          + (rate_diagonal_2a_lo1 + (rate_diagonal_1b_cross2 + rate_diagonal_0b_cross2)));
  const double rate_diagonal_0_final = rate_diagonal_0_rounded == rate_diagonal_0_rounded
          ? rate_diagonal_0_rounded : rate_diagonal_0;
  const double M_04_final = M_04_rounded == M_04_rounded ? M_04_rounded : M_04;
  const double M_05_final = M_05_rounded == M_05_rounded ? M_05_rounded : M_05;
  const double M_13_final = M_13_rounded == M_13_rounded ? M_13_rounded : M_13;
  const double rate_diagonal_1_final = rate_diagonal_1_rounded == rate_diagonal_1_rounded
          ? rate_diagonal_1_rounded : rate_diagonal_1;
  const double M_15_final = M_15_rounded == M_15_rounded ? M_15_rounded : M_15;
  const double M_23_final = M_23_rounded == M_23_rounded ? M_23_rounded : M_23;
  const double M_24_final = M_24_rounded == M_24_rounded ? M_24_rounded : M_24;
  const double rate_diagonal_2_final = rate_diagonal_2_rounded == rate_diagonal_2_rounded
          ? rate_diagonal_2_rounded : rate_diagonal_2;
  M->at[0][0] = diagonal0_final;
  M->at[1][0] = J_1_final;
  M->at[2][0] = J_2_final;
  M->at[3][0] = rate_diagonal_0_final;
  M->at[4][0] = M_04_final;
  M->at[5][0] = M_05_final;
  M->at[0][1] = J_3_final;
  M->at[1][1] = diagonal1_final;
  M->at[2][1] = J_5_final;
  M->at[3][1] = M_13_final;
  M->at[4][1] = rate_diagonal_1_final;
  M->at[5][1] = M_15_final;
  M->at[0][2] = J_6_final;
  M->at[1][2] = J_7_final;
  M->at[2][2] = diagonal2_final;
  M->at[3][2] = M_23_final;
  M->at[4][2] = M_24_final;
  M->at[5][2] = rate_diagonal_2_final;
  M->at[0][3] = 0.0;
  M->at[1][3] = 0.0;
  M->at[2][3] = 0.0;
  M->at[3][3] = diagonal0_final;
  M->at[4][3] = J_1_final;
  M->at[5][3] = J_2_final;
  M->at[0][4] = 0.0;
  M->at[1][4] = 0.0;
  M->at[2][4] = 0.0;
  M->at[3][4] = J_3_final;
  M->at[4][4] = diagonal1_final;
  M->at[5][4] = J_5_final;
  M->at[0][5] = 0.0;
  M->at[1][5] = 0.0;
  M->at[2][5] = 0.0;
  M->at[3][5] = J_6_final;
  M->at[4][5] = J_7_final;
  M->at[5][5] = diagonal2_final;
}

/* M = J_l(s)^-1; singular where |ω| is a multiple of 2π except 0.
   s: screw (v in m/s; ω in rad/s); M: 6×6 operator.
   283 mul, 721 add, 34 product error, 60 product rest, 14 div, 1 sqrt, 9 neg, 4 abs, 6 less, 19
     equal, 36 select.
   Error <= M: 1 u of its largest component for |ω of s| <= π; searched, not proved.  Each
     component is within 1 ulp as long as its condition is below 1e13; in single precision it is
     the nearest number, except near ties, as long as that is below 1e5; searched, not proved.
     Intermediate sums may overflow where |v| is above 2e306, in single precision 5e36. */
static inline void ksl_SE3_leftJacobianInverse_accurate(const ksl_screw_t *s, ksl_mat6x6_t *M) {
  const double halved_0 = KSL_MUL(0.5, s->m3), halved_1 = KSL_MUL(0.5, s->m4),
      halved_2 = KSL_MUL(0.5, s->m5);
  const double y_a = KSL_MUL(halved_0, halved_0), y_b = KSL_MUL(halved_1, halved_1),
      y_c = y_a + y_b, y_c_right = y_c - y_a, y_d = KSL_MUL(halved_2, halved_2), y = y_c + y_d,
      y_right = y - y_c,
      y_c_lo = ksl_product_rest(halved_0, halved_0, y_a, y_c - y_c_right)
          + ksl_product_rest(halved_1, halved_1, y_b, y_c_right),
      y_lo = y_c - (y - y_right) + ksl_product_rest(halved_2, halved_2, y_d, y_right) + y_c_lo;
  const double y_sum = y + y_lo, y_sum_right = y_sum - y,
      y_sum_lo = y - (y_sum - y_sum_right) + (y_lo - y_sum_right), half_angle = sqrt(y_sum),
      half_angle_product = KSL_MUL(half_angle, half_angle),
      half_angle_twice = half_angle + half_angle,
      half_angle_residual = y_sum - half_angle_product
          - ksl_product_error(half_angle, half_angle, half_angle_product) + y_sum_lo,
      half_angle_lo = half_angle_residual / (half_angle == 0.0 ? 1.0 : half_angle_twice);
  const double half_angle_sum = half_angle + half_angle_lo,
      half_angle_sum_right = half_angle_sum - half_angle,
      half_angle_sum_lo = half_angle - (half_angle_sum - half_angle_sum_right)
          + (half_angle_lo - half_angle_sum_right);
  double c; const double sine = ksl_sincos(half_angle_sum, &c);
  double c_own_error; const double sine_own_error = ksl_sincos_error(half_angle_sum, sine, c,
      &c_own_error);
  const double sine_half = KSL_MUL(half_angle_sum_lo, 0.5);
  double sine_half_cos; const double sine_half_sin = ksl_sincos(sine_half, &sine_half_cos);
  const double sine_twice = sine_half_sin + sine_half_sin,
      sine_lo = sine_own_error
          + KSL_MUL(KSL_MUL(sine_half_cos, c) - KSL_MUL(sine_half_sin, sine), sine_twice);
  const double c_lo = c_own_error
          - KSL_MUL(KSL_MUL(sine_half_cos, sine) + KSL_MUL(sine_half_sin, c), sine_twice);
  const double sinc_divisor = half_angle_sum < 1.4901161193847656e-08 ? 1.4901161193847656e-08
          : half_angle_sum,
      sinc_divisor_lo = half_angle_sum < 1.4901161193847656e-08 ? 0.0 : half_angle_sum_lo;
  const double sine_sum = sine + sine_lo, sine_sum_right = sine_sum - sine,
      sinc_divisor_sum = sinc_divisor + sinc_divisor_lo,
      sinc_divisor_sum_right = sinc_divisor_sum - sinc_divisor,
      sinc_quotient = sine_sum / sinc_divisor_sum,
      sinc_quotient_product = KSL_MUL(sinc_quotient, sinc_divisor_sum),
      sinc_quotient_exact = sine_sum - sinc_quotient_product
          - ksl_product_error(sinc_quotient, sinc_divisor_sum, sinc_quotient_product),
      sinc_quotient_cross = KSL_MUL(sinc_quotient, sinc_divisor
          - (sinc_divisor_sum - sinc_divisor_sum_right)
          + (sinc_divisor_lo - sinc_divisor_sum_right)),
      sinc_quotient_lo = (sinc_quotient_exact
          + (sine - (sine_sum - sine_sum_right) + (sine_lo - sine_sum_right))
          - sinc_quotient_cross) / sinc_divisor_sum;
  const double sinc_a = KSL_MUL(0.16666666666666666, y_sum), sinc_b = 1.0 - sinc_a,
      sinc_b_right = 1.0 - sinc_b,
      sinc_b_lo1 = 1.0 - (sinc_b + sinc_b_right)
          - ksl_product_rest(0.16666666666666666, y_sum, sinc_a, sinc_b_right),
      sinc_b_lo = sinc_b_lo1
          - (KSL_MUL(9.25185853854297e-18, y_sum) + KSL_MUL(0.16666666666666666, y_sum_lo)),
      sinc = half_angle_sum < 1.4901161193847656e-08 ? sinc_b : sinc_quotient,
      sinc_lo = half_angle_sum < 1.4901161193847656e-08 ? sinc_b_lo : sinc_quotient_lo;
  const double series_phi_a = KSL_MUL(5.107725174524775e-32, y_sum),
      series_phi_b = 4.116826490666969e-29 - series_phi_a,
      series_phi_b_right = 4.116826490666969e-29 - series_phi_b,
      series_phi_b_right_rest = ksl_product_rest(5.107725174524775e-32, y_sum, series_phi_a,
          series_phi_b_right),
      series_phi_b_lo1 = 4.116826490666969e-29 - (series_phi_b + series_phi_b_right)
          - series_phi_b_right_rest, series_phi_c = KSL_MUL(y_sum, series_phi_b),
      series_phi_b_lo = series_phi_b_lo1
          - (KSL_MUL(4.7410392187559056e-48, y_sum) + KSL_MUL(5.107725174524775e-32, y_sum_lo)) +
          -1.8714974010023092e-45, series_phi_d = series_phi_c - 2.86531123750421e-26,
      series_phi_d_right = series_phi_c - series_phi_d,
      series_phi_d_left_rest = ksl_product_rest(y_sum, series_phi_b, series_phi_c, series_phi_d
          + series_phi_d_right),
      series_phi_d_lo2 = series_phi_d_left_rest - (2.86531123750421e-26 - series_phi_d_right)
          - 2.3296034284323186e-42, series_phi_e = KSL_MUL(y_sum, series_phi_d),
      series_phi_e_cross2 = KSL_MUL(y_sum, series_phi_d_lo2
          + (KSL_MUL(y_sum_lo, series_phi_b) + KSL_MUL(y_sum, series_phi_b_lo))),
      series_phi_f = series_phi_e + 1.701994875077501e-23,
      series_phi_f_right = series_phi_f - series_phi_e,
      series_phi_f_left_rest = ksl_product_rest(y_sum, series_phi_d, series_phi_e, series_phi_f
          - series_phi_f_right),
      series_phi_f_lo2 = series_phi_f_left_rest + (1.701994875077501e-23 - series_phi_f_right)
          + 3.161967936521494e-40, series_phi_g = KSL_MUL(y_sum, series_phi_f),
      series_phi_h = series_phi_g - 8.509974375387505e-21,
      series_phi_h_right = series_phi_g - series_phi_h,
      series_phi_h_left_rest = ksl_product_rest(y_sum, series_phi_f, series_phi_g, series_phi_h
          + series_phi_h_right),
      series_phi_g_cross = KSL_MUL(y_sum_lo, series_phi_f)
          + KSL_MUL(y_sum, series_phi_f_lo2
          + (KSL_MUL(y_sum_lo, series_phi_d) + series_phi_e_cross2)),
      series_phi_i = KSL_MUL(y_sum, series_phi_h),
      series_phi_h_lo = series_phi_h_left_rest - (8.509974375387505e-21 - series_phi_h_right)
          - 3.2266760594119493e-37 + series_phi_g_cross,
      series_phi_j = series_phi_i + 3.523129391410427e-18,
      series_phi_j_right = series_phi_j - series_phi_i,
      series_phi_j_left_rest = ksl_product_rest(y_sum, series_phi_h, series_phi_i, series_phi_j
          - series_phi_j_right),
      series_phi_j_lo2 = series_phi_j_left_rest + (3.523129391410427e-18 - series_phi_j_right) +
          -1.2521244741738012e-34, series_phi_k = KSL_MUL(y_sum, series_phi_j),
      series_phi_k_cross2 = KSL_MUL(y_sum, series_phi_j_lo2
          + (KSL_MUL(y_sum_lo, series_phi_h) + KSL_MUL(y_sum, series_phi_h_lo))),
      series_phi_l = series_phi_k - 1.1837714755139035e-15,
      series_phi_l_right = series_phi_k - series_phi_l,
      series_phi_l_left_rest = ksl_product_rest(y_sum, series_phi_j, series_phi_k, series_phi_l
          + series_phi_l_right),
      series_phi_l_lo2 = series_phi_l_left_rest - (1.1837714755139035e-15 - series_phi_l_right)
          - 7.23242424407352e-33, series_phi_m = KSL_MUL(y_sum, series_phi_l),
      series_phi_n = series_phi_m + 3.148832124866983e-13,
      series_phi_n_right = series_phi_n - series_phi_m,
      series_phi_n_left_rest = ksl_product_rest(y_sum, series_phi_l, series_phi_m, series_phi_n
          - series_phi_n_right),
      series_phi_m_cross = KSL_MUL(y_sum_lo, series_phi_l)
          + KSL_MUL(y_sum, series_phi_l_lo2
          + (KSL_MUL(y_sum_lo, series_phi_j) + series_phi_k_cross2)),
      series_phi_o = KSL_MUL(y_sum, series_phi_n),
      series_phi_n_lo = series_phi_n_left_rest + (3.148832124866983e-13 - series_phi_n_right)
          + 5.8681293750286156e-30 + series_phi_m_cross,
      series_phi_p = series_phi_o - 6.423617534728645e-11,
      series_phi_p_right = series_phi_o - series_phi_p,
      series_phi_p_left_rest = ksl_product_rest(y_sum, series_phi_n, series_phi_o, series_phi_p
          + series_phi_p_right),
      series_phi_p_lo2 = series_phi_p_left_rest - (6.423617534728645e-11 - series_phi_p_right)
          - 5.034117835500839e-27, series_phi_q = KSL_MUL(y_sum, series_phi_p),
      series_phi_q_cross2 = KSL_MUL(y_sum, series_phi_p_lo2
          + (KSL_MUL(y_sum_lo, series_phi_n) + KSL_MUL(y_sum, series_phi_n_lo))),
      series_phi_r = series_phi_q + 9.635426302092969e-09,
      series_phi_r_right = series_phi_r - series_phi_q,
      series_phi_r_left_rest = ksl_product_rest(y_sum, series_phi_p, series_phi_q, series_phi_r
          - series_phi_r_right),
      series_phi_r_lo2 = series_phi_r_left_rest + (9.635426302092969e-09 - series_phi_r_right) +
          -1.7546051379703029e-25, series_phi_s = KSL_MUL(y_sum, series_phi_r),
      series_phi_t = series_phi_s - 1.0020843354176687e-06,
      series_phi_t_right = series_phi_s - series_phi_t,
      series_phi_t_left_rest = ksl_product_rest(y_sum, series_phi_r, series_phi_s, series_phi_t
          + series_phi_t_right),
      series_phi_s_cross = KSL_MUL(y_sum_lo, series_phi_r)
          + KSL_MUL(y_sum, series_phi_r_lo2
          + (KSL_MUL(y_sum_lo, series_phi_p) + series_phi_q_cross2)),
      series_phi_u = KSL_MUL(y_sum, series_phi_t),
      series_phi_t_lo = series_phi_t_left_rest - (1.0020843354176687e-06 - series_phi_t_right)
          - 4.7926555569351065e-23 + series_phi_s_cross,
      series_phi_v = series_phi_u + 6.613756613756614e-05,
      series_phi_v_right = series_phi_v - series_phi_u,
      series_phi_v_left_rest = ksl_product_rest(y_sum, series_phi_t, series_phi_u, series_phi_v
          - series_phi_v_right),
      series_phi_v_lo2 = series_phi_v_left_rest + (6.613756613756614e-05 - series_phi_v_right) +
          -4.460143857711533e-21, series_phi_w = KSL_MUL(y_sum, series_phi_v),
      series_phi_w_cross2 = KSL_MUL(y_sum, series_phi_v_lo2
          + (KSL_MUL(y_sum_lo, series_phi_t) + KSL_MUL(y_sum, series_phi_t_lo))),
      series_phi_x = series_phi_w - 0.002380952380952381,
      series_phi_x_right = series_phi_w - series_phi_x,
      series_phi_x_left_rest = ksl_product_rest(y_sum, series_phi_v, series_phi_w, series_phi_x
          + series_phi_x_right),
      series_phi_x_lo2 = series_phi_x_left_rest - (0.002380952380952381 - series_phi_x_right) -
          -2.147752875018904e-19, series_phi_y = KSL_MUL(y_sum, series_phi_x),
      series_phi = series_phi_y + 0.03333333333333333, series_phi_right = series_phi - series_phi_y,
      series_phi_lo1 = ksl_product_rest(y_sum, series_phi_x, series_phi_y, series_phi
          - series_phi_right) + (0.03333333333333333 - series_phi_right),
      series_phi_y_cross = KSL_MUL(y_sum_lo, series_phi_x)
          + KSL_MUL(y_sum, series_phi_x_lo2
          + (KSL_MUL(y_sum_lo, series_phi_v) + series_phi_w_cross2)),
      series_phi_lo = series_phi_lo1 + 4.625929269271486e-19 + series_phi_y_cross;
  const double f_more_a = KSL_MUL(2.0, y_sum), f_more = KSL_MUL(f_more_a, series_phi);
  const double near_f_a = KSL_MUL(0.3333333333333333, sinc),
      near_f_b = KSL_MUL(0.3333333333333333, f_more),
      f_more_lo = ksl_product_error(f_more_a, series_phi, f_more)
          + (KSL_MUL(KSL_MUL(2.0, y_sum_lo), series_phi) + KSL_MUL(f_more_a, series_phi_lo)),
      near_f = near_f_a + near_f_b, near_f_right = near_f - near_f_a,
      near_f_b_cross = KSL_MUL(1.850371707708594e-17, f_more)
          + KSL_MUL(0.3333333333333333, f_more_lo),
      near_f_left_rest = ksl_product_rest(0.3333333333333333, sinc, near_f_a, near_f
          - near_f_right),
      near_f_cross = KSL_MUL(1.850371707708594e-17, sinc) + KSL_MUL(0.3333333333333333, sinc_lo)
          + near_f_b_cross,
      near_f_lo = near_f_left_rest
          + ksl_product_rest(0.3333333333333333, f_more, near_f_b, near_f_right) + near_f_cross;
  const double f_rest = sinc - c, f_rest_right = sinc - f_rest,
      f_rest_lo = sinc - (f_rest + f_rest_right) - (c - f_rest_right) - c_lo + sinc_lo;
  const double x = KSL_MUL(4.0, y_sum);
  const double x_sum = x + KSL_MUL(4.0, y_sum_lo), far_y = x_sum < 4.0 ? 1.0 : y_sum,
      far_y_lo = x_sum < 4.0 ? 0.0 : y_sum_lo;
  const double f_rest_sum = f_rest + f_rest_lo, f_rest_sum_right = f_rest_sum - f_rest,
      far_y_sum = far_y + far_y_lo, far_y_sum_right = far_y_sum - far_y,
      far_y_sum_lo = far_y - (far_y_sum - far_y_sum_right) + (far_y_lo - far_y_sum_right),
      closed_f = f_rest_sum / far_y_sum, closed_f_product = KSL_MUL(closed_f, far_y_sum),
      closed_f_exact = f_rest_sum - closed_f_product
          - ksl_product_error(closed_f, far_y_sum, closed_f_product),
      closed_f_residual = closed_f_exact
          + (f_rest - (f_rest_sum - f_rest_sum_right) + (f_rest_lo - f_rest_sum_right))
          - KSL_MUL(closed_f, far_y_sum_lo), closed_f_lo = closed_f_residual / far_y_sum;
  const double f = x_sum < 4.0 ? near_f : closed_f, f_lo = x_sum < 4.0 ? near_f_lo : closed_f_lo;
  const double four_k = KSL_MUL(4.0, sinc), four_k_cross2 = KSL_MUL(4.0, sinc_lo);
  const double f_sum = f + f_lo, f_sum_right = f_sum - f,
      f_sum_lo = f - (f_sum - f_sum_right) + (f_lo - f_sum_right),
      four_k_sum = four_k + four_k_cross2, four_k_sum_right = four_k_sum - four_k,
      b = f_sum / four_k_sum, b_product = KSL_MUL(b, four_k_sum),
      b_cross = KSL_MUL(b, four_k - (four_k_sum - four_k_sum_right)
          + (four_k_cross2 - four_k_sum_right)),
      b_lo = (f_sum - b_product - ksl_product_error(b, four_k_sum, b_product) + f_sum_lo - b_cross)
          / four_k_sum;
  const double c_sum = c + c_lo, c_sum_right = c_sum - c, sinc_sum = sinc + sinc_lo,
      sinc_sum_right = sinc_sum - sinc,
      sinc_sum_lo = sinc - (sinc_sum - sinc_sum_right) + (sinc_lo - sinc_sum_right),
      b_across = c_sum / sinc_sum, b_across_product = KSL_MUL(b_across, sinc_sum),
      b_across_exact = c_sum - b_across_product
          - ksl_product_error(b_across, sinc_sum, b_across_product),
      b_across_lo = (b_across_exact + (c - (c_sum - c_sum_right) + (c_lo - c_sum_right))
          - KSL_MUL(b_across, sinc_sum_lo)) / sinc_sum;
  const double beta_v_0 = KSL_MUL(s->m3, b), beta_v_1 = KSL_MUL(s->m4, b),
      beta_v_2 = KSL_MUL(s->m5, b);
  const double beta_v_0_lo = ksl_product_error(s->m3, b, beta_v_0) + KSL_MUL(s->m3, b_lo),
      m_0 = KSL_MUL(s->m3, beta_v_0), m_0_cross2 = KSL_MUL(s->m3, beta_v_0_lo);
  const double beta_v_1_lo = ksl_product_error(s->m4, b, beta_v_1) + KSL_MUL(s->m4, b_lo),
      m_1 = KSL_MUL(s->m4, beta_v_1), m_1_cross2 = KSL_MUL(s->m4, beta_v_1_lo);
  const double m_2 = KSL_MUL(s->m5, beta_v_2),
      m_2_cross2 = KSL_MUL(s->m5, ksl_product_error(s->m5, b, beta_v_2) + KSL_MUL(s->m5, b_lo));
  const double m_3 = KSL_MUL(s->m4, beta_v_0), m_3_cross2 = KSL_MUL(s->m4, beta_v_0_lo);
  const double m_4 = KSL_MUL(s->m5, beta_v_0), m_4_cross2 = KSL_MUL(s->m5, beta_v_0_lo);
  const double m_5 = KSL_MUL(s->m5, beta_v_1), m_5_cross2 = KSL_MUL(s->m5, beta_v_1_lo);
  const double others_0 = m_1 + m_2, others_0_right = others_0 - m_1,
      others_0_lo1 = ksl_product_rest(s->m4, beta_v_1, m_1, others_0 - others_0_right)
          + ksl_product_rest(s->m5, beta_v_2, m_2, others_0_right),
      others_0_lo = others_0_lo1 + (m_1_cross2 + m_2_cross2);
  const double others_1 = m_0 + m_2, others_1_right = others_1 - m_0,
      others_1_lo1 = ksl_product_rest(s->m3, beta_v_0, m_0, others_1 - others_1_right)
          + ksl_product_rest(s->m5, beta_v_2, m_2, others_1_right),
      others_1_lo = others_1_lo1 + (m_0_cross2 + m_2_cross2);
  const double others_2 = m_0 + m_1, others_2_right = others_2 - m_0,
      others_2_lo1 = ksl_product_rest(s->m3, beta_v_0, m_0, others_2 - others_2_right)
          + ksl_product_rest(s->m4, beta_v_1, m_1, others_2_right),
      others_2_lo = others_2_lo1 + (m_0_cross2 + m_1_cross2);
  const double diagonal0a = 1.0 - others_0, diagonal0a_right = 1.0 - diagonal0a,
      diagonal0a_lo = 1.0 - (diagonal0a + diagonal0a_right) - (others_0 - diagonal0a_right)
          - others_0_lo, diagonal0b = b_across + m_0, diagonal0b_right = diagonal0b - b_across,
      diagonal0b_lo = b_across - (diagonal0b - diagonal0b_right)
          + ksl_product_rest(s->m3, beta_v_0, m_0, diagonal0b_right) + m_0_cross2 + b_across_lo,
      m_0_sum = m_0 + (ksl_product_error(s->m3, beta_v_0, m_0) + m_0_cross2),
      others_0_sum = others_0 + others_0_lo,
      diagonal0 = m_0_sum < others_0_sum ? diagonal0b : diagonal0a;
  const double diagonal1a = 1.0 - others_1, diagonal1a_right = 1.0 - diagonal1a,
      diagonal1a_lo = 1.0 - (diagonal1a + diagonal1a_right) - (others_1 - diagonal1a_right)
          - others_1_lo, diagonal1b = b_across + m_1, diagonal1b_right = diagonal1b - b_across,
      diagonal1b_lo = b_across - (diagonal1b - diagonal1b_right)
          + ksl_product_rest(s->m4, beta_v_1, m_1, diagonal1b_right) + m_1_cross2 + b_across_lo,
      m_1_sum = m_1 + (ksl_product_error(s->m4, beta_v_1, m_1) + m_1_cross2),
      others_1_sum = others_1 + others_1_lo,
      diagonal1 = m_1_sum < others_1_sum ? diagonal1b : diagonal1a;
  const double diagonal2a = 1.0 - others_2, diagonal2a_right = 1.0 - diagonal2a,
      diagonal2a_lo = 1.0 - (diagonal2a + diagonal2a_right) - (others_2 - diagonal2a_right)
          - others_2_lo, diagonal2b = b_across + m_2, diagonal2b_right = diagonal2b - b_across,
      diagonal2b_lo = b_across - (diagonal2b - diagonal2b_right)
          + ksl_product_rest(s->m5, beta_v_2, m_2, diagonal2b_right) + m_2_cross2 + b_across_lo,
      m_2_sum = m_2 + (ksl_product_error(s->m5, beta_v_2, m_2) + m_2_cross2),
      others_2_sum = others_2 + others_2_lo,
      diagonal2 = m_2_sum < others_2_sum ? diagonal2b : diagonal2a;
  const double alpha_v_0 = -halved_0, alpha_v_1 = -halved_1, alpha_v_2 = -halved_2;
  const double J_1 = m_3 - alpha_v_2, J_1_right = m_3 - J_1;
  const double J_2 = m_4 + alpha_v_1, J_2_right = J_2 - m_4;
  const double J_3 = m_3 + alpha_v_2, J_3_right = J_3 - m_3;
  const double J_5 = m_5 - alpha_v_0, J_5_right = m_5 - J_5;
  const double J_6 = m_4 - alpha_v_1, J_6_right = m_4 - J_6;
  const double J_7 = m_5 + alpha_v_0, J_7_right = J_7 - m_5;
  const double phi_rest_a = KSL_MUL(3.0, f_sum), phi_rest = phi_rest_a - sinc_sum,
      phi_rest_right = phi_rest_a - phi_rest,
      phi_rest_lo = ksl_product_rest(3.0, f_sum, phi_rest_a, phi_rest + phi_rest_right)
          - (sinc_sum - phi_rest_right) - sinc_sum_lo + KSL_MUL(3.0, f_sum_lo);
  const double twice_y = KSL_MUL(2.0, far_y_sum), twice_y_cross2 = KSL_MUL(2.0, far_y_sum_lo);
  const double phi_rest_sum = phi_rest + phi_rest_lo, phi_rest_sum_right = phi_rest_sum - phi_rest,
      twice_y_sum = twice_y + twice_y_cross2, twice_y_sum_right = twice_y_sum - twice_y,
      closed_phi = phi_rest_sum / twice_y_sum,
      closed_phi_product = KSL_MUL(closed_phi, twice_y_sum),
      closed_phi_exact = phi_rest_sum - closed_phi_product
          - ksl_product_error(closed_phi, twice_y_sum, closed_phi_product),
      closed_phi_numerator = closed_phi_exact
          + (phi_rest - (phi_rest_sum - phi_rest_sum_right) + (phi_rest_lo - phi_rest_sum_right)),
      closed_phi_residual = closed_phi_numerator
          - KSL_MUL(closed_phi, twice_y - (twice_y_sum - twice_y_sum_right)
          + (twice_y_cross2 - twice_y_sum_right)),
      closed_phi_lo = closed_phi_residual / twice_y_sum;
  const double phi = x_sum < 4.0 ? series_phi : closed_phi;
  const double b_rate_above_a = KSL_MUL(f_sum, f_sum),
      b_rate_above_b = KSL_MUL(0.5, b_rate_above_a), b_rate_above_c = KSL_MUL(sinc_sum, phi),
      b_rate_above = b_rate_above_b - b_rate_above_c,
      b_rate_above_right = b_rate_above_b - b_rate_above,
      b_rate_above_lo1 = b_rate_above_b - (b_rate_above + b_rate_above_right)
          - ksl_product_rest(sinc_sum, phi, b_rate_above_c, b_rate_above_right),
      b_rate_above_b_cross2 = KSL_MUL(0.5, ksl_product_error(f_sum, f_sum, b_rate_above_a)
          + (KSL_MUL(f_sum_lo, f_sum) + KSL_MUL(f_sum, f_sum_lo))),
      b_rate_above_lo2 = b_rate_above_lo1
          - (KSL_MUL(sinc_sum_lo, phi)
          + KSL_MUL(sinc_sum, x_sum < 4.0 ? series_phi_lo : closed_phi_lo)),
      b_rate_above_lo = b_rate_above_lo2 + b_rate_above_b_cross2;
  const double b_rate_below_a = KSL_MUL(sinc_sum, sinc_sum),
      b_rate_below = KSL_MUL(8.0, b_rate_below_a),
      b_rate_below_a_lo = ksl_product_error(sinc_sum, sinc_sum, b_rate_below_a)
          + (KSL_MUL(sinc_sum_lo, sinc_sum) + KSL_MUL(sinc_sum, sinc_sum_lo)),
      b_rate_below_cross2 = KSL_MUL(8.0, b_rate_below_a_lo);
  const double b_rate_above_sum = b_rate_above + b_rate_above_lo,
      b_rate_above_sum_right = b_rate_above_sum - b_rate_above,
      b_rate_below_sum = b_rate_below + b_rate_below_cross2,
      b_rate_below_sum_right = b_rate_below_sum - b_rate_below,
      b_rate = b_rate_above_sum / b_rate_below_sum,
      b_rate_product = KSL_MUL(b_rate, b_rate_below_sum),
      b_rate_above_sum_lo = b_rate_above - (b_rate_above_sum - b_rate_above_sum_right)
          + (b_rate_above_lo - b_rate_above_sum_right),
      b_rate_cross = KSL_MUL(b_rate, b_rate_below - (b_rate_below_sum - b_rate_below_sum_right)
          + (b_rate_below_cross2 - b_rate_below_sum_right)),
      b_rate_residual = b_rate_above_sum - b_rate_product
          - ksl_product_error(b_rate, b_rate_below_sum, b_rate_product) + b_rate_above_sum_lo
          - b_rate_cross;
  const double rate_vw_a = KSL_MUL(s->m0, s->m3), rate_vw_b = KSL_MUL(s->m1, s->m4),
      rate_vw_c = rate_vw_a + rate_vw_b, rate_vw_c_right = rate_vw_c - rate_vw_a,
      rate_vw_d = KSL_MUL(s->m2, s->m5), rate_vw = rate_vw_c + rate_vw_d,
      rate_vw_right = rate_vw - rate_vw_c,
      rate_vw_c_lo = ksl_product_rest(s->m0, s->m3, rate_vw_a, rate_vw_c - rate_vw_c_right)
          + ksl_product_rest(s->m1, s->m4, rate_vw_b, rate_vw_c_right);
  const double rate_bend_a_cross2 = KSL_MUL(b_rate, rate_vw_c - (rate_vw - rate_vw_right)
          + ksl_product_rest(s->m2, s->m5, rate_vw_d, rate_vw_right) + rate_vw_c_lo),
      rate_bend = -KSL_MUL(b_rate, rate_vw);
  const double rate_q_0 = -KSL_MUL(0.5, s->m0), rate_q_1 = -KSL_MUL(0.5, s->m1),
      rate_q_2 = -KSL_MUL(0.5, s->m2);
  const double rate_beta_v_0 = KSL_MUL(s->m0, b), rate_beta_v_1 = KSL_MUL(s->m1, b),
      rate_beta_v_2 = KSL_MUL(s->m2, b);
  const double rate_bend_lo = ksl_product_error(-b_rate, rate_vw, rate_bend) +
          -(KSL_MUL(b_rate_residual / b_rate_below_sum, rate_vw) + rate_bend_a_cross2),
      rate_bend_w_0 = KSL_MUL(s->m3, rate_bend);
  const double rate_bend_w_1 = KSL_MUL(s->m4, rate_bend), rate_bend_w_2 = KSL_MUL(s->m5, rate_bend);
  const double rate_beta_v_1_lo = ksl_product_error(s->m1, b, rate_beta_v_1) + KSL_MUL(s->m1, b_lo),
      rate_symmetric_0a = KSL_MUL(s->m3, rate_beta_v_1),
      rate_beta_v_0_lo = ksl_product_error(s->m0, b, rate_beta_v_0) + KSL_MUL(s->m0, b_lo),
      rate_symmetric_0b = KSL_MUL(s->m4, rate_beta_v_0),
      rate_symmetric_0c = rate_symmetric_0a + rate_symmetric_0b,
      rate_symmetric_0c_right = rate_symmetric_0c - rate_symmetric_0a,
      rate_symmetric_0c_left_rest = ksl_product_rest(s->m3, rate_beta_v_1, rate_symmetric_0a,
          rate_symmetric_0c - rate_symmetric_0c_right),
      rate_symmetric_0c_lo1 = rate_symmetric_0c_left_rest
          + ksl_product_rest(s->m4, rate_beta_v_0, rate_symmetric_0b, rate_symmetric_0c_right),
      rate_bend_w_0_lo = ksl_product_error(s->m3, rate_bend, rate_bend_w_0)
          + KSL_MUL(s->m3, rate_bend_lo), rate_symmetric_0d = KSL_MUL(s->m4, rate_bend_w_0),
      rate_symmetric_0 = rate_symmetric_0c - rate_symmetric_0d,
      rate_symmetric_0_right = rate_symmetric_0c - rate_symmetric_0,
      rate_symmetric_0_right_rest = ksl_product_rest(s->m4, rate_bend_w_0, rate_symmetric_0d,
          rate_symmetric_0_right),
      rate_symmetric_0_lo1 = rate_symmetric_0c - (rate_symmetric_0 + rate_symmetric_0_right)
          - rate_symmetric_0_right_rest,
      rate_symmetric_0c_lo = rate_symmetric_0c_lo1
          + (KSL_MUL(s->m3, rate_beta_v_1_lo) + KSL_MUL(s->m4, rate_beta_v_0_lo)),
      rate_symmetric_0_lo = rate_symmetric_0_lo1 - KSL_MUL(s->m4, rate_bend_w_0_lo)
          + rate_symmetric_0c_lo;
  const double rate_beta_v_2_lo = ksl_product_error(s->m2, b, rate_beta_v_2) + KSL_MUL(s->m2, b_lo),
      rate_symmetric_1a = KSL_MUL(s->m3, rate_beta_v_2),
      rate_symmetric_1b = KSL_MUL(s->m5, rate_beta_v_0),
      rate_symmetric_1c = rate_symmetric_1a + rate_symmetric_1b,
      rate_symmetric_1c_right = rate_symmetric_1c - rate_symmetric_1a,
      rate_symmetric_1c_left_rest = ksl_product_rest(s->m3, rate_beta_v_2, rate_symmetric_1a,
          rate_symmetric_1c - rate_symmetric_1c_right),
      rate_symmetric_1c_lo1 = rate_symmetric_1c_left_rest
          + ksl_product_rest(s->m5, rate_beta_v_0, rate_symmetric_1b, rate_symmetric_1c_right),
      rate_symmetric_1d = KSL_MUL(s->m5, rate_bend_w_0),
      rate_symmetric_1 = rate_symmetric_1c - rate_symmetric_1d,
      rate_symmetric_1_right = rate_symmetric_1c - rate_symmetric_1,
      rate_symmetric_1_right_rest = ksl_product_rest(s->m5, rate_bend_w_0, rate_symmetric_1d,
          rate_symmetric_1_right),
      rate_symmetric_1_lo1 = rate_symmetric_1c - (rate_symmetric_1 + rate_symmetric_1_right)
          - rate_symmetric_1_right_rest,
      rate_symmetric_1c_lo = rate_symmetric_1c_lo1
          + (KSL_MUL(s->m3, rate_beta_v_2_lo) + KSL_MUL(s->m5, rate_beta_v_0_lo)),
      rate_symmetric_1_lo = rate_symmetric_1_lo1 - KSL_MUL(s->m5, rate_bend_w_0_lo)
          + rate_symmetric_1c_lo;
  const double rate_symmetric_2a = KSL_MUL(s->m4, rate_beta_v_2),
      rate_symmetric_2b = KSL_MUL(s->m5, rate_beta_v_1),
      rate_symmetric_2c = rate_symmetric_2a + rate_symmetric_2b,
      rate_symmetric_2c_right = rate_symmetric_2c - rate_symmetric_2a,
      rate_symmetric_2c_left_rest = ksl_product_rest(s->m4, rate_beta_v_2, rate_symmetric_2a,
          rate_symmetric_2c - rate_symmetric_2c_right),
      rate_symmetric_2c_lo1 = rate_symmetric_2c_left_rest
          + ksl_product_rest(s->m5, rate_beta_v_1, rate_symmetric_2b, rate_symmetric_2c_right),
      rate_bend_w_1_lo = ksl_product_error(s->m4, rate_bend, rate_bend_w_1)
          + KSL_MUL(s->m4, rate_bend_lo), rate_symmetric_2d = KSL_MUL(s->m5, rate_bend_w_1),
      rate_symmetric_2 = rate_symmetric_2c - rate_symmetric_2d,
      rate_symmetric_2_right = rate_symmetric_2c - rate_symmetric_2,
      rate_symmetric_2_right_rest = ksl_product_rest(s->m5, rate_bend_w_1, rate_symmetric_2d,
          rate_symmetric_2_right),
      rate_symmetric_2_lo1 = rate_symmetric_2c - (rate_symmetric_2 + rate_symmetric_2_right)
          - rate_symmetric_2_right_rest,
      rate_symmetric_2c_lo = rate_symmetric_2c_lo1
          + (KSL_MUL(s->m4, rate_beta_v_2_lo) + KSL_MUL(s->m5, rate_beta_v_1_lo)),
      rate_symmetric_2_lo = rate_symmetric_2_lo1 - KSL_MUL(s->m5, rate_bend_w_1_lo)
          + rate_symmetric_2c_lo;
  const double rate_diagonal_0a = KSL_MUL(s->m4, rate_bend_w_1),
      rate_diagonal_0a_cross2 = KSL_MUL(s->m4, rate_bend_w_1_lo),
      rate_diagonal_0b = KSL_MUL(s->m5, rate_bend_w_2),
      rate_diagonal_0b_cross2 = KSL_MUL(s->m5, ksl_product_error(s->m5, rate_bend, rate_bend_w_2)
          + KSL_MUL(s->m5, rate_bend_lo)), rate_diagonal_0c = rate_diagonal_0a + rate_diagonal_0b,
      rate_diagonal_0c_right = rate_diagonal_0c - rate_diagonal_0a,
      rate_diagonal_0c_left_rest = ksl_product_rest(s->m4, rate_bend_w_1, rate_diagonal_0a,
          rate_diagonal_0c - rate_diagonal_0c_right),
      rate_diagonal_0c_lo1 = rate_diagonal_0c_left_rest
          + ksl_product_rest(s->m5, rate_bend_w_2, rate_diagonal_0b, rate_diagonal_0c_right),
      rate_diagonal_0d = KSL_MUL(2.0, s->m4),
      rate_diagonal_0e = KSL_MUL(rate_diagonal_0d, rate_beta_v_1),
      rate_diagonal_0e_cross2 = KSL_MUL(rate_diagonal_0d, rate_beta_v_1_lo),
      rate_diagonal_0f = KSL_MUL(2.0, s->m5),
      rate_diagonal_0g = KSL_MUL(rate_diagonal_0f, rate_beta_v_2),
      rate_diagonal_0g_cross2 = KSL_MUL(rate_diagonal_0f, rate_beta_v_2_lo),
      rate_diagonal_0h = rate_diagonal_0e + rate_diagonal_0g,
      rate_diagonal_0h_right = rate_diagonal_0h - rate_diagonal_0e,
      rate_diagonal_0h_left_rest = ksl_product_rest(rate_diagonal_0d, rate_beta_v_1,
          rate_diagonal_0e, rate_diagonal_0h - rate_diagonal_0h_right),
      rate_diagonal_0h_lo1 = rate_diagonal_0h_left_rest
          + ksl_product_rest(rate_diagonal_0f, rate_beta_v_2, rate_diagonal_0g,
              rate_diagonal_0h_right),
      rate_diagonal_0 = rate_diagonal_0c - rate_diagonal_0h,
      rate_diagonal_0_right = rate_diagonal_0c - rate_diagonal_0,
      rate_diagonal_0_lo1 = rate_diagonal_0c - (rate_diagonal_0 + rate_diagonal_0_right)
          - (rate_diagonal_0h - rate_diagonal_0_right),
      rate_diagonal_0_lo2 = rate_diagonal_0_lo1
          - (rate_diagonal_0h_lo1 + (rate_diagonal_0e_cross2 + rate_diagonal_0g_cross2));
  const double rate_diagonal_1a = KSL_MUL(s->m3, rate_bend_w_0),
      rate_diagonal_1a_cross2 = KSL_MUL(s->m3, rate_bend_w_0_lo),
      rate_diagonal_1b = rate_diagonal_1a + rate_diagonal_0b,
      rate_diagonal_1b_right = rate_diagonal_1b - rate_diagonal_1a,
      rate_diagonal_1b_left_rest = ksl_product_rest(s->m3, rate_bend_w_0, rate_diagonal_1a,
          rate_diagonal_1b - rate_diagonal_1b_right),
      rate_diagonal_1b_lo1 = rate_diagonal_1b_left_rest
          + ksl_product_rest(s->m5, rate_bend_w_2, rate_diagonal_0b, rate_diagonal_1b_right),
      rate_diagonal_1c = KSL_MUL(2.0, s->m3),
      rate_diagonal_1d = KSL_MUL(rate_diagonal_1c, rate_beta_v_0),
      rate_diagonal_1d_cross2 = KSL_MUL(rate_diagonal_1c, rate_beta_v_0_lo),
      rate_diagonal_1e = rate_diagonal_1d + rate_diagonal_0g,
      rate_diagonal_1e_right = rate_diagonal_1e - rate_diagonal_1d,
      rate_diagonal_1e_left_rest = ksl_product_rest(rate_diagonal_1c, rate_beta_v_0,
          rate_diagonal_1d, rate_diagonal_1e - rate_diagonal_1e_right),
      rate_diagonal_1e_lo1 = rate_diagonal_1e_left_rest
          + ksl_product_rest(rate_diagonal_0f, rate_beta_v_2, rate_diagonal_0g,
              rate_diagonal_1e_right),
      rate_diagonal_1 = rate_diagonal_1b - rate_diagonal_1e,
      rate_diagonal_1_right = rate_diagonal_1b - rate_diagonal_1,
      rate_diagonal_1_lo1 = rate_diagonal_1b - (rate_diagonal_1 + rate_diagonal_1_right)
          - (rate_diagonal_1e - rate_diagonal_1_right),
      rate_diagonal_1_lo2 = rate_diagonal_1_lo1
          - (rate_diagonal_1e_lo1 + (rate_diagonal_1d_cross2 + rate_diagonal_0g_cross2));
  const double rate_diagonal_2a = rate_diagonal_1a + rate_diagonal_0a,
      rate_diagonal_2a_right = rate_diagonal_2a - rate_diagonal_1a,
      rate_diagonal_2a_left_rest = ksl_product_rest(s->m3, rate_bend_w_0, rate_diagonal_1a,
          rate_diagonal_2a - rate_diagonal_2a_right),
      rate_diagonal_2a_lo1 = rate_diagonal_2a_left_rest
          + ksl_product_rest(s->m4, rate_bend_w_1, rate_diagonal_0a, rate_diagonal_2a_right),
      rate_diagonal_2b = rate_diagonal_1d + rate_diagonal_0e,
      rate_diagonal_2b_right = rate_diagonal_2b - rate_diagonal_1d,
      rate_diagonal_2b_left_rest = ksl_product_rest(rate_diagonal_1c, rate_beta_v_0,
          rate_diagonal_1d, rate_diagonal_2b - rate_diagonal_2b_right),
      rate_diagonal_2b_lo1 = rate_diagonal_2b_left_rest
          + ksl_product_rest(rate_diagonal_0d, rate_beta_v_1, rate_diagonal_0e,
              rate_diagonal_2b_right),
      rate_diagonal_2 = rate_diagonal_2a - rate_diagonal_2b,
      rate_diagonal_2_right = rate_diagonal_2a - rate_diagonal_2,
      rate_diagonal_2_lo1 = rate_diagonal_2a - (rate_diagonal_2 + rate_diagonal_2_right)
          - (rate_diagonal_2b - rate_diagonal_2_right),
      rate_diagonal_2_lo2 = rate_diagonal_2_lo1
          - (rate_diagonal_2b_lo1 + (rate_diagonal_1d_cross2 + rate_diagonal_0e_cross2));
  const double M_04 = rate_symmetric_0 - rate_q_2, M_04_right = rate_symmetric_0 - M_04;
  const double M_05 = rate_q_1 + rate_symmetric_1, M_05_right = M_05 - rate_q_1;
  const double M_13 = rate_q_2 + rate_symmetric_0, M_13_right = M_13 - rate_q_2;
  const double M_15 = rate_symmetric_2 - rate_q_0, M_15_right = rate_symmetric_2 - M_15;
  const double M_23 = rate_symmetric_1 - rate_q_1, M_23_right = rate_symmetric_1 - M_23;
  const double M_24 = rate_q_0 + rate_symmetric_2, M_24_right = M_24 - rate_q_0;
  const double diagonal0_rounded = diagonal0
          + (m_0_sum < others_0_sum ? diagonal0b_lo : diagonal0a_lo),
      diagonal0_final = diagonal0_rounded == diagonal0_rounded ? diagonal0_rounded : diagonal0;
  const double J_1_rounded = J_1
          + (ksl_product_rest(s->m4, beta_v_0, m_3, J_1 + J_1_right) - (alpha_v_2 - J_1_right)
          + m_3_cross2), J_1_final = J_1_rounded == J_1_rounded ? J_1_rounded : J_1;
  const double J_2_rounded = J_2
          + (ksl_product_rest(s->m5, beta_v_0, m_4, J_2 - J_2_right) + (alpha_v_1 - J_2_right)
          + m_4_cross2), J_2_final = J_2_rounded == J_2_rounded ? J_2_rounded : J_2;
  const double rate_diagonal_0_rounded = rate_diagonal_0
          + (rate_diagonal_0_lo2
          + (rate_diagonal_0c_lo1 + (rate_diagonal_0a_cross2 + rate_diagonal_0b_cross2)));
  const double M_04_rounded = M_04
          + (rate_symmetric_0 - (M_04 + M_04_right) - (rate_q_2 - M_04_right)
          + rate_symmetric_0_lo);
  const double M_05_rounded = M_05
          + (rate_q_1 - (M_05 - M_05_right) + (rate_symmetric_1 - M_05_right)
          + rate_symmetric_1_lo);
  const double J_3_rounded = J_3
          + (ksl_product_rest(s->m4, beta_v_0, m_3, J_3 - J_3_right) + (alpha_v_2 - J_3_right)
          + m_3_cross2), J_3_final = J_3_rounded == J_3_rounded ? J_3_rounded : J_3;
  const double diagonal1_rounded = diagonal1
          + (m_1_sum < others_1_sum ? diagonal1b_lo : diagonal1a_lo),
      diagonal1_final = diagonal1_rounded == diagonal1_rounded ? diagonal1_rounded : diagonal1;
  const double J_5_rounded = J_5
          + (ksl_product_rest(s->m5, beta_v_1, m_5, J_5 + J_5_right) - (alpha_v_0 - J_5_right)
          + m_5_cross2), J_5_final = J_5_rounded == J_5_rounded ? J_5_rounded : J_5;
  const double M_13_rounded = M_13
          + (rate_q_2 - (M_13 - M_13_right) + (rate_symmetric_0 - M_13_right)
          + rate_symmetric_0_lo);
  const double rate_diagonal_1_rounded = rate_diagonal_1
          + (rate_diagonal_1_lo2
          + (rate_diagonal_1b_lo1 + (rate_diagonal_1a_cross2 + rate_diagonal_0b_cross2)));
  const double M_15_rounded = M_15
          + (rate_symmetric_2 - (M_15 + M_15_right) - (rate_q_0 - M_15_right)
          + rate_symmetric_2_lo);
  const double J_6_rounded = J_6
          + (ksl_product_rest(s->m5, beta_v_0, m_4, J_6 + J_6_right) - (alpha_v_1 - J_6_right)
          + m_4_cross2), J_6_final = J_6_rounded == J_6_rounded ? J_6_rounded : J_6;
  const double J_7_rounded = J_7
          + (ksl_product_rest(s->m5, beta_v_1, m_5, J_7 - J_7_right) + (alpha_v_0 - J_7_right)
          + m_5_cross2), J_7_final = J_7_rounded == J_7_rounded ? J_7_rounded : J_7;
  const double diagonal2_rounded = diagonal2
          + (m_2_sum < others_2_sum ? diagonal2b_lo : diagonal2a_lo),
      diagonal2_final = diagonal2_rounded == diagonal2_rounded ? diagonal2_rounded : diagonal2;
  const double M_23_rounded = M_23
          + (rate_symmetric_1 - (M_23 + M_23_right) - (rate_q_1 - M_23_right)
          + rate_symmetric_1_lo);
  const double M_24_rounded = M_24
          + (rate_q_0 - (M_24 - M_24_right) + (rate_symmetric_2 - M_24_right)
          + rate_symmetric_2_lo);
  const double rate_diagonal_2_rounded = rate_diagonal_2
          + (rate_diagonal_2_lo2
          + (rate_diagonal_2a_lo1 + (rate_diagonal_1a_cross2 + rate_diagonal_0a_cross2)));
  const double rate_diagonal_0_final = rate_diagonal_0_rounded == rate_diagonal_0_rounded
          ? rate_diagonal_0_rounded : rate_diagonal_0;
  const double M_04_final = M_04_rounded == M_04_rounded ? M_04_rounded : M_04;
  const double M_05_final = M_05_rounded == M_05_rounded ? M_05_rounded : M_05;
  const double M_13_final = M_13_rounded == M_13_rounded ? M_13_rounded : M_13;
  const double rate_diagonal_1_final = rate_diagonal_1_rounded == rate_diagonal_1_rounded
          ? rate_diagonal_1_rounded : rate_diagonal_1;
  const double M_15_final = M_15_rounded == M_15_rounded ? M_15_rounded : M_15;
  const double M_23_final = M_23_rounded == M_23_rounded ? M_23_rounded : M_23;
  const double M_24_final = M_24_rounded == M_24_rounded ? M_24_rounded : M_24;
  const double rate_diagonal_2_final = rate_diagonal_2_rounded == rate_diagonal_2_rounded
          ? rate_diagonal_2_rounded : rate_diagonal_2;
  M->at[0][0] = diagonal0_final;
  M->at[1][0] = J_1_final;
  M->at[2][0] = J_2_final;
  M->at[3][0] = rate_diagonal_0_final;
  M->at[4][0] = M_04_final;
  M->at[5][0] = M_05_final;
  M->at[0][1] = J_3_final;
  M->at[1][1] = diagonal1_final;
  M->at[2][1] = J_5_final;
  M->at[3][1] = M_13_final;
  M->at[4][1] = rate_diagonal_1_final;
  M->at[5][1] = M_15_final;
  M->at[0][2] = J_6_final;
  M->at[1][2] = J_7_final;
  M->at[2][2] = diagonal2_final;
  M->at[3][2] = M_23_final;
  M->at[4][2] = M_24_final;
  M->at[5][2] = rate_diagonal_2_final;
  M->at[0][3] = 0.0;
  M->at[1][3] = 0.0;
  M->at[2][3] = 0.0;
  M->at[3][3] = diagonal0_final;
  M->at[4][3] = J_1_final;
  M->at[5][3] = J_2_final;
  M->at[0][4] = 0.0;
  M->at[1][4] = 0.0;
  M->at[2][4] = 0.0;
  M->at[3][4] = J_3_final;
  M->at[4][4] = diagonal1_final;
  M->at[5][4] = J_5_final;
  M->at[0][5] = 0.0;
  M->at[1][5] = 0.0;
  M->at[2][5] = 0.0;
  M->at[3][5] = J_6_final;
  M->at[4][5] = J_7_final;
  M->at[5][5] = diagonal2_final;
}

/* M = J_r(s)^-1; singular where |ω| is a multiple of 2π except 0.
   s: screw (v in m/s; ω in rad/s); M: 6×6 operator.
   283 mul, 721 add, 34 product error, 60 product rest, 14 div, 1 sqrt, 21 neg, 4 abs, 6 less, 19
     equal, 36 select.
   Error <= M: 1 u of its largest component for |ω of s| <= π; searched, not proved.  Each
     component is within 1 ulp as long as its condition is below 1e13; in single precision it is
     the nearest number, except near ties, as long as that is below 1e5; searched, not proved.
     Intermediate sums may overflow where |v| is above 2e306, in single precision 5e36. */
static inline void ksl_SE3_rightJacobianInverse_accurate(const ksl_screw_t *s, ksl_mat6x6_t *M) {
  const double halved_0 = KSL_MUL(0.5, s->m3), halved_1 = KSL_MUL(0.5, s->m4),
      halved_2 = KSL_MUL(0.5, s->m5);
  const double y_a = KSL_MUL(halved_0, halved_0), y_b = KSL_MUL(halved_1, halved_1),
      y_c = y_a + y_b, y_c_right = y_c - y_a, y_d = KSL_MUL(halved_2, halved_2), y = y_c + y_d,
      y_right = y - y_c,
      y_c_lo = ksl_product_rest(halved_0, halved_0, y_a, y_c - y_c_right)
          + ksl_product_rest(halved_1, halved_1, y_b, y_c_right),
      y_lo = y_c - (y - y_right) + ksl_product_rest(halved_2, halved_2, y_d, y_right) + y_c_lo;
  const double y_sum = y + y_lo, y_sum_right = y_sum - y,
      y_sum_lo = y - (y_sum - y_sum_right) + (y_lo - y_sum_right), half_angle = sqrt(y_sum),
      half_angle_product = KSL_MUL(half_angle, half_angle),
      half_angle_twice = half_angle + half_angle,
      half_angle_residual = y_sum - half_angle_product
          - ksl_product_error(half_angle, half_angle, half_angle_product) + y_sum_lo,
      half_angle_lo = half_angle_residual / (half_angle == 0.0 ? 1.0 : half_angle_twice);
  const double half_angle_sum = half_angle + half_angle_lo,
      half_angle_sum_right = half_angle_sum - half_angle,
      half_angle_sum_lo = half_angle - (half_angle_sum - half_angle_sum_right)
          + (half_angle_lo - half_angle_sum_right);
  double c; const double sine = ksl_sincos(half_angle_sum, &c);
  double c_own_error; const double sine_own_error = ksl_sincos_error(half_angle_sum, sine, c,
      &c_own_error);
  const double sine_half = KSL_MUL(half_angle_sum_lo, 0.5);
  double sine_half_cos; const double sine_half_sin = ksl_sincos(sine_half, &sine_half_cos);
  const double sine_twice = sine_half_sin + sine_half_sin,
      sine_lo = sine_own_error
          + KSL_MUL(KSL_MUL(sine_half_cos, c) - KSL_MUL(sine_half_sin, sine), sine_twice);
  const double c_lo = c_own_error
          - KSL_MUL(KSL_MUL(sine_half_cos, sine) + KSL_MUL(sine_half_sin, c), sine_twice);
  const double sinc_divisor = half_angle_sum < 1.4901161193847656e-08 ? 1.4901161193847656e-08
          : half_angle_sum,
      sinc_divisor_lo = half_angle_sum < 1.4901161193847656e-08 ? 0.0 : half_angle_sum_lo;
  const double sine_sum = sine + sine_lo, sine_sum_right = sine_sum - sine,
      sinc_divisor_sum = sinc_divisor + sinc_divisor_lo,
      sinc_divisor_sum_right = sinc_divisor_sum - sinc_divisor,
      sinc_quotient = sine_sum / sinc_divisor_sum,
      sinc_quotient_product = KSL_MUL(sinc_quotient, sinc_divisor_sum),
      sinc_quotient_exact = sine_sum - sinc_quotient_product
          - ksl_product_error(sinc_quotient, sinc_divisor_sum, sinc_quotient_product),
      sinc_quotient_cross = KSL_MUL(sinc_quotient, sinc_divisor
          - (sinc_divisor_sum - sinc_divisor_sum_right)
          + (sinc_divisor_lo - sinc_divisor_sum_right)),
      sinc_quotient_lo = (sinc_quotient_exact
          + (sine - (sine_sum - sine_sum_right) + (sine_lo - sine_sum_right))
          - sinc_quotient_cross) / sinc_divisor_sum;
  const double sinc_a = KSL_MUL(0.16666666666666666, y_sum), sinc_b = 1.0 - sinc_a,
      sinc_b_right = 1.0 - sinc_b,
      sinc_b_lo1 = 1.0 - (sinc_b + sinc_b_right)
          - ksl_product_rest(0.16666666666666666, y_sum, sinc_a, sinc_b_right),
      sinc_b_lo = sinc_b_lo1
          - (KSL_MUL(9.25185853854297e-18, y_sum) + KSL_MUL(0.16666666666666666, y_sum_lo)),
      sinc = half_angle_sum < 1.4901161193847656e-08 ? sinc_b : sinc_quotient,
      sinc_lo = half_angle_sum < 1.4901161193847656e-08 ? sinc_b_lo : sinc_quotient_lo;
  const double series_phi_a = KSL_MUL(5.107725174524775e-32, y_sum),
      series_phi_b = 4.116826490666969e-29 - series_phi_a,
      series_phi_b_right = 4.116826490666969e-29 - series_phi_b,
      series_phi_b_right_rest = ksl_product_rest(5.107725174524775e-32, y_sum, series_phi_a,
          series_phi_b_right),
      series_phi_b_lo1 = 4.116826490666969e-29 - (series_phi_b + series_phi_b_right)
          - series_phi_b_right_rest, series_phi_c = KSL_MUL(y_sum, series_phi_b),
      series_phi_b_lo = series_phi_b_lo1
          - (KSL_MUL(4.7410392187559056e-48, y_sum) + KSL_MUL(5.107725174524775e-32, y_sum_lo)) +
          -1.8714974010023092e-45, series_phi_d = series_phi_c - 2.86531123750421e-26,
      series_phi_d_right = series_phi_c - series_phi_d,
      series_phi_d_left_rest = ksl_product_rest(y_sum, series_phi_b, series_phi_c, series_phi_d
          + series_phi_d_right),
      series_phi_d_lo2 = series_phi_d_left_rest - (2.86531123750421e-26 - series_phi_d_right)
          - 2.3296034284323186e-42, series_phi_e = KSL_MUL(y_sum, series_phi_d),
      series_phi_e_cross2 = KSL_MUL(y_sum, series_phi_d_lo2
          + (KSL_MUL(y_sum_lo, series_phi_b) + KSL_MUL(y_sum, series_phi_b_lo))),
      series_phi_f = series_phi_e + 1.701994875077501e-23,
      series_phi_f_right = series_phi_f - series_phi_e,
      series_phi_f_left_rest = ksl_product_rest(y_sum, series_phi_d, series_phi_e, series_phi_f
          - series_phi_f_right),
      series_phi_f_lo2 = series_phi_f_left_rest + (1.701994875077501e-23 - series_phi_f_right)
          + 3.161967936521494e-40, series_phi_g = KSL_MUL(y_sum, series_phi_f),
      series_phi_h = series_phi_g - 8.509974375387505e-21,
      series_phi_h_right = series_phi_g - series_phi_h,
      series_phi_h_left_rest = ksl_product_rest(y_sum, series_phi_f, series_phi_g, series_phi_h
          + series_phi_h_right),
      series_phi_g_cross = KSL_MUL(y_sum_lo, series_phi_f)
          + KSL_MUL(y_sum, series_phi_f_lo2
          + (KSL_MUL(y_sum_lo, series_phi_d) + series_phi_e_cross2)),
      series_phi_i = KSL_MUL(y_sum, series_phi_h),
      series_phi_h_lo = series_phi_h_left_rest - (8.509974375387505e-21 - series_phi_h_right)
          - 3.2266760594119493e-37 + series_phi_g_cross,
      series_phi_j = series_phi_i + 3.523129391410427e-18,
      series_phi_j_right = series_phi_j - series_phi_i,
      series_phi_j_left_rest = ksl_product_rest(y_sum, series_phi_h, series_phi_i, series_phi_j
          - series_phi_j_right),
      series_phi_j_lo2 = series_phi_j_left_rest + (3.523129391410427e-18 - series_phi_j_right) +
          -1.2521244741738012e-34, series_phi_k = KSL_MUL(y_sum, series_phi_j),
      series_phi_k_cross2 = KSL_MUL(y_sum, series_phi_j_lo2
          + (KSL_MUL(y_sum_lo, series_phi_h) + KSL_MUL(y_sum, series_phi_h_lo))),
      series_phi_l = series_phi_k - 1.1837714755139035e-15,
      series_phi_l_right = series_phi_k - series_phi_l,
      series_phi_l_left_rest = ksl_product_rest(y_sum, series_phi_j, series_phi_k, series_phi_l
          + series_phi_l_right),
      series_phi_l_lo2 = series_phi_l_left_rest - (1.1837714755139035e-15 - series_phi_l_right)
          - 7.23242424407352e-33, series_phi_m = KSL_MUL(y_sum, series_phi_l),
      series_phi_n = series_phi_m + 3.148832124866983e-13,
      series_phi_n_right = series_phi_n - series_phi_m,
      series_phi_n_left_rest = ksl_product_rest(y_sum, series_phi_l, series_phi_m, series_phi_n
          - series_phi_n_right),
      series_phi_m_cross = KSL_MUL(y_sum_lo, series_phi_l)
          + KSL_MUL(y_sum, series_phi_l_lo2
          + (KSL_MUL(y_sum_lo, series_phi_j) + series_phi_k_cross2)),
      series_phi_o = KSL_MUL(y_sum, series_phi_n),
      series_phi_n_lo = series_phi_n_left_rest + (3.148832124866983e-13 - series_phi_n_right)
          + 5.8681293750286156e-30 + series_phi_m_cross,
      series_phi_p = series_phi_o - 6.423617534728645e-11,
      series_phi_p_right = series_phi_o - series_phi_p,
      series_phi_p_left_rest = ksl_product_rest(y_sum, series_phi_n, series_phi_o, series_phi_p
          + series_phi_p_right),
      series_phi_p_lo2 = series_phi_p_left_rest - (6.423617534728645e-11 - series_phi_p_right)
          - 5.034117835500839e-27, series_phi_q = KSL_MUL(y_sum, series_phi_p),
      series_phi_q_cross2 = KSL_MUL(y_sum, series_phi_p_lo2
          + (KSL_MUL(y_sum_lo, series_phi_n) + KSL_MUL(y_sum, series_phi_n_lo))),
      series_phi_r = series_phi_q + 9.635426302092969e-09,
      series_phi_r_right = series_phi_r - series_phi_q,
      series_phi_r_left_rest = ksl_product_rest(y_sum, series_phi_p, series_phi_q, series_phi_r
          - series_phi_r_right),
      series_phi_r_lo2 = series_phi_r_left_rest + (9.635426302092969e-09 - series_phi_r_right) +
          -1.7546051379703029e-25, series_phi_s = KSL_MUL(y_sum, series_phi_r),
      series_phi_t = series_phi_s - 1.0020843354176687e-06,
      series_phi_t_right = series_phi_s - series_phi_t,
      series_phi_t_left_rest = ksl_product_rest(y_sum, series_phi_r, series_phi_s, series_phi_t
          + series_phi_t_right),
      series_phi_s_cross = KSL_MUL(y_sum_lo, series_phi_r)
          + KSL_MUL(y_sum, series_phi_r_lo2
          + (KSL_MUL(y_sum_lo, series_phi_p) + series_phi_q_cross2)),
      series_phi_u = KSL_MUL(y_sum, series_phi_t),
      series_phi_t_lo = series_phi_t_left_rest - (1.0020843354176687e-06 - series_phi_t_right)
          - 4.7926555569351065e-23 + series_phi_s_cross,
      series_phi_v = series_phi_u + 6.613756613756614e-05,
      series_phi_v_right = series_phi_v - series_phi_u,
      series_phi_v_left_rest = ksl_product_rest(y_sum, series_phi_t, series_phi_u, series_phi_v
          - series_phi_v_right),
      series_phi_v_lo2 = series_phi_v_left_rest + (6.613756613756614e-05 - series_phi_v_right) +
          -4.460143857711533e-21, series_phi_w = KSL_MUL(y_sum, series_phi_v),
      series_phi_w_cross2 = KSL_MUL(y_sum, series_phi_v_lo2
          + (KSL_MUL(y_sum_lo, series_phi_t) + KSL_MUL(y_sum, series_phi_t_lo))),
      series_phi_x = series_phi_w - 0.002380952380952381,
      series_phi_x_right = series_phi_w - series_phi_x,
      series_phi_x_left_rest = ksl_product_rest(y_sum, series_phi_v, series_phi_w, series_phi_x
          + series_phi_x_right),
      series_phi_x_lo2 = series_phi_x_left_rest - (0.002380952380952381 - series_phi_x_right) -
          -2.147752875018904e-19, series_phi_y = KSL_MUL(y_sum, series_phi_x),
      series_phi = series_phi_y + 0.03333333333333333, series_phi_right = series_phi - series_phi_y,
      series_phi_lo1 = ksl_product_rest(y_sum, series_phi_x, series_phi_y, series_phi
          - series_phi_right) + (0.03333333333333333 - series_phi_right),
      series_phi_y_cross = KSL_MUL(y_sum_lo, series_phi_x)
          + KSL_MUL(y_sum, series_phi_x_lo2
          + (KSL_MUL(y_sum_lo, series_phi_v) + series_phi_w_cross2)),
      series_phi_lo = series_phi_lo1 + 4.625929269271486e-19 + series_phi_y_cross;
  const double f_more_a = KSL_MUL(2.0, y_sum), f_more = KSL_MUL(f_more_a, series_phi);
  const double near_f_a = KSL_MUL(0.3333333333333333, sinc),
      near_f_b = KSL_MUL(0.3333333333333333, f_more),
      f_more_lo = ksl_product_error(f_more_a, series_phi, f_more)
          + (KSL_MUL(KSL_MUL(2.0, y_sum_lo), series_phi) + KSL_MUL(f_more_a, series_phi_lo)),
      near_f = near_f_a + near_f_b, near_f_right = near_f - near_f_a,
      near_f_b_cross = KSL_MUL(1.850371707708594e-17, f_more)
          + KSL_MUL(0.3333333333333333, f_more_lo),
      near_f_left_rest = ksl_product_rest(0.3333333333333333, sinc, near_f_a, near_f
          - near_f_right),
      near_f_cross = KSL_MUL(1.850371707708594e-17, sinc) + KSL_MUL(0.3333333333333333, sinc_lo)
          + near_f_b_cross,
      near_f_lo = near_f_left_rest
          + ksl_product_rest(0.3333333333333333, f_more, near_f_b, near_f_right) + near_f_cross;
  const double f_rest = sinc - c, f_rest_right = sinc - f_rest,
      f_rest_lo = sinc - (f_rest + f_rest_right) - (c - f_rest_right) - c_lo + sinc_lo;
  const double x = KSL_MUL(4.0, y_sum);
  const double x_sum = x + KSL_MUL(4.0, y_sum_lo), far_y = x_sum < 4.0 ? 1.0 : y_sum,
      far_y_lo = x_sum < 4.0 ? 0.0 : y_sum_lo;
  const double f_rest_sum = f_rest + f_rest_lo, f_rest_sum_right = f_rest_sum - f_rest,
      far_y_sum = far_y + far_y_lo, far_y_sum_right = far_y_sum - far_y,
      far_y_sum_lo = far_y - (far_y_sum - far_y_sum_right) + (far_y_lo - far_y_sum_right),
      closed_f = f_rest_sum / far_y_sum, closed_f_product = KSL_MUL(closed_f, far_y_sum),
      closed_f_exact = f_rest_sum - closed_f_product
          - ksl_product_error(closed_f, far_y_sum, closed_f_product),
      closed_f_residual = closed_f_exact
          + (f_rest - (f_rest_sum - f_rest_sum_right) + (f_rest_lo - f_rest_sum_right))
          - KSL_MUL(closed_f, far_y_sum_lo), closed_f_lo = closed_f_residual / far_y_sum;
  const double f = x_sum < 4.0 ? near_f : closed_f, f_lo = x_sum < 4.0 ? near_f_lo : closed_f_lo;
  const double four_k = KSL_MUL(4.0, sinc), four_k_cross2 = KSL_MUL(4.0, sinc_lo);
  const double f_sum = f + f_lo, f_sum_right = f_sum - f,
      f_sum_lo = f - (f_sum - f_sum_right) + (f_lo - f_sum_right),
      four_k_sum = four_k + four_k_cross2, four_k_sum_right = four_k_sum - four_k,
      b = f_sum / four_k_sum, b_product = KSL_MUL(b, four_k_sum),
      b_cross = KSL_MUL(b, four_k - (four_k_sum - four_k_sum_right)
          + (four_k_cross2 - four_k_sum_right)),
      b_lo = (f_sum - b_product - ksl_product_error(b, four_k_sum, b_product) + f_sum_lo - b_cross)
          / four_k_sum;
  const double c_sum = c + c_lo, c_sum_right = c_sum - c, sinc_sum = sinc + sinc_lo,
      sinc_sum_right = sinc_sum - sinc,
      sinc_sum_lo = sinc - (sinc_sum - sinc_sum_right) + (sinc_lo - sinc_sum_right),
      b_across = c_sum / sinc_sum, b_across_product = KSL_MUL(b_across, sinc_sum),
      b_across_exact = c_sum - b_across_product
          - ksl_product_error(b_across, sinc_sum, b_across_product),
      b_across_lo = (b_across_exact + (c - (c_sum - c_sum_right) + (c_lo - c_sum_right))
          - KSL_MUL(b_across, sinc_sum_lo)) / sinc_sum;
  const double beta_v_0 = KSL_MUL(s->m3, b), beta_v_1 = KSL_MUL(s->m4, b),
      beta_v_2 = KSL_MUL(s->m5, b);
  const double beta_v_0_lo = ksl_product_error(s->m3, b, beta_v_0) + KSL_MUL(s->m3, b_lo),
      m_0 = KSL_MUL(s->m3, beta_v_0), m_0_cross2 = KSL_MUL(s->m3, beta_v_0_lo);
  const double beta_v_1_lo = ksl_product_error(s->m4, b, beta_v_1) + KSL_MUL(s->m4, b_lo),
      m_1 = KSL_MUL(s->m4, beta_v_1), m_1_cross2 = KSL_MUL(s->m4, beta_v_1_lo);
  const double m_2 = KSL_MUL(s->m5, beta_v_2),
      m_2_cross2 = KSL_MUL(s->m5, ksl_product_error(s->m5, b, beta_v_2) + KSL_MUL(s->m5, b_lo));
  const double m_3 = KSL_MUL(s->m4, beta_v_0), m_3_cross2 = KSL_MUL(s->m4, beta_v_0_lo);
  const double m_4 = KSL_MUL(s->m5, beta_v_0), m_4_cross2 = KSL_MUL(s->m5, beta_v_0_lo);
  const double m_5 = KSL_MUL(s->m5, beta_v_1), m_5_cross2 = KSL_MUL(s->m5, beta_v_1_lo);
  const double others_0 = m_1 + m_2, others_0_right = others_0 - m_1,
      others_0_lo1 = ksl_product_rest(s->m4, beta_v_1, m_1, others_0 - others_0_right)
          + ksl_product_rest(s->m5, beta_v_2, m_2, others_0_right),
      others_0_lo = others_0_lo1 + (m_1_cross2 + m_2_cross2);
  const double others_1 = m_0 + m_2, others_1_right = others_1 - m_0,
      others_1_lo1 = ksl_product_rest(s->m3, beta_v_0, m_0, others_1 - others_1_right)
          + ksl_product_rest(s->m5, beta_v_2, m_2, others_1_right),
      others_1_lo = others_1_lo1 + (m_0_cross2 + m_2_cross2);
  const double others_2 = m_0 + m_1, others_2_right = others_2 - m_0,
      others_2_lo1 = ksl_product_rest(s->m3, beta_v_0, m_0, others_2 - others_2_right)
          + ksl_product_rest(s->m4, beta_v_1, m_1, others_2_right),
      others_2_lo = others_2_lo1 + (m_0_cross2 + m_1_cross2);
  const double diagonal0a = 1.0 - others_0, diagonal0a_right = 1.0 - diagonal0a,
      diagonal0a_lo = 1.0 - (diagonal0a + diagonal0a_right) - (others_0 - diagonal0a_right)
          - others_0_lo, diagonal0b = b_across + m_0, diagonal0b_right = diagonal0b - b_across,
      diagonal0b_lo = b_across - (diagonal0b - diagonal0b_right)
          + ksl_product_rest(s->m3, beta_v_0, m_0, diagonal0b_right) + m_0_cross2 + b_across_lo,
      m_0_sum = m_0 + (ksl_product_error(s->m3, beta_v_0, m_0) + m_0_cross2),
      others_0_sum = others_0 + others_0_lo,
      diagonal0 = m_0_sum < others_0_sum ? diagonal0b : diagonal0a;
  const double diagonal1a = 1.0 - others_1, diagonal1a_right = 1.0 - diagonal1a,
      diagonal1a_lo = 1.0 - (diagonal1a + diagonal1a_right) - (others_1 - diagonal1a_right)
          - others_1_lo, diagonal1b = b_across + m_1, diagonal1b_right = diagonal1b - b_across,
      diagonal1b_lo = b_across - (diagonal1b - diagonal1b_right)
          + ksl_product_rest(s->m4, beta_v_1, m_1, diagonal1b_right) + m_1_cross2 + b_across_lo,
      m_1_sum = m_1 + (ksl_product_error(s->m4, beta_v_1, m_1) + m_1_cross2),
      others_1_sum = others_1 + others_1_lo,
      diagonal1 = m_1_sum < others_1_sum ? diagonal1b : diagonal1a;
  const double diagonal2a = 1.0 - others_2, diagonal2a_right = 1.0 - diagonal2a,
      diagonal2a_lo = 1.0 - (diagonal2a + diagonal2a_right) - (others_2 - diagonal2a_right)
          - others_2_lo, diagonal2b = b_across + m_2, diagonal2b_right = diagonal2b - b_across,
      diagonal2b_lo = b_across - (diagonal2b - diagonal2b_right)
          + ksl_product_rest(s->m5, beta_v_2, m_2, diagonal2b_right) + m_2_cross2 + b_across_lo,
      m_2_sum = m_2 + (ksl_product_error(s->m5, beta_v_2, m_2) + m_2_cross2),
      others_2_sum = others_2 + others_2_lo,
      diagonal2 = m_2_sum < others_2_sum ? diagonal2b : diagonal2a;
  const double J_1 = m_3 - halved_2, J_1_right = m_3 - J_1;
  const double J_2 = halved_1 + m_4, J_2_right = J_2 - halved_1;
  const double J_3 = halved_2 + m_3, J_3_right = J_3 - halved_2;
  const double J_5 = m_5 - halved_0, J_5_right = m_5 - J_5;
  const double J_6 = m_4 - halved_1, J_6_right = m_4 - J_6;
  const double J_7 = halved_0 + m_5, J_7_right = J_7 - halved_0;
  const double phi_rest_a = KSL_MUL(3.0, f_sum), phi_rest = phi_rest_a - sinc_sum,
      phi_rest_right = phi_rest_a - phi_rest,
      phi_rest_lo = ksl_product_rest(3.0, f_sum, phi_rest_a, phi_rest + phi_rest_right)
          - (sinc_sum - phi_rest_right) - sinc_sum_lo + KSL_MUL(3.0, f_sum_lo);
  const double twice_y = KSL_MUL(2.0, far_y_sum), twice_y_cross2 = KSL_MUL(2.0, far_y_sum_lo);
  const double phi_rest_sum = phi_rest + phi_rest_lo, phi_rest_sum_right = phi_rest_sum - phi_rest,
      twice_y_sum = twice_y + twice_y_cross2, twice_y_sum_right = twice_y_sum - twice_y,
      closed_phi = phi_rest_sum / twice_y_sum,
      closed_phi_product = KSL_MUL(closed_phi, twice_y_sum),
      closed_phi_exact = phi_rest_sum - closed_phi_product
          - ksl_product_error(closed_phi, twice_y_sum, closed_phi_product),
      closed_phi_numerator = closed_phi_exact
          + (phi_rest - (phi_rest_sum - phi_rest_sum_right) + (phi_rest_lo - phi_rest_sum_right)),
      closed_phi_residual = closed_phi_numerator
          - KSL_MUL(closed_phi, twice_y - (twice_y_sum - twice_y_sum_right)
          + (twice_y_cross2 - twice_y_sum_right)),
      closed_phi_lo = closed_phi_residual / twice_y_sum;
  const double phi = x_sum < 4.0 ? series_phi : closed_phi;
  const double b_rate_above_a = KSL_MUL(f_sum, f_sum),
      b_rate_above_b = KSL_MUL(0.5, b_rate_above_a), b_rate_above_c = KSL_MUL(sinc_sum, phi),
      b_rate_above = b_rate_above_b - b_rate_above_c,
      b_rate_above_right = b_rate_above_b - b_rate_above,
      b_rate_above_lo1 = b_rate_above_b - (b_rate_above + b_rate_above_right)
          - ksl_product_rest(sinc_sum, phi, b_rate_above_c, b_rate_above_right),
      b_rate_above_b_cross2 = KSL_MUL(0.5, ksl_product_error(f_sum, f_sum, b_rate_above_a)
          + (KSL_MUL(f_sum_lo, f_sum) + KSL_MUL(f_sum, f_sum_lo))),
      b_rate_above_lo2 = b_rate_above_lo1
          - (KSL_MUL(sinc_sum_lo, phi)
          + KSL_MUL(sinc_sum, x_sum < 4.0 ? series_phi_lo : closed_phi_lo)),
      b_rate_above_lo = b_rate_above_lo2 + b_rate_above_b_cross2;
  const double b_rate_below_a = KSL_MUL(sinc_sum, sinc_sum),
      b_rate_below = KSL_MUL(8.0, b_rate_below_a),
      b_rate_below_a_lo = ksl_product_error(sinc_sum, sinc_sum, b_rate_below_a)
          + (KSL_MUL(sinc_sum_lo, sinc_sum) + KSL_MUL(sinc_sum, sinc_sum_lo)),
      b_rate_below_cross2 = KSL_MUL(8.0, b_rate_below_a_lo);
  const double b_rate_above_sum = b_rate_above + b_rate_above_lo,
      b_rate_above_sum_right = b_rate_above_sum - b_rate_above,
      b_rate_below_sum = b_rate_below + b_rate_below_cross2,
      b_rate_below_sum_right = b_rate_below_sum - b_rate_below,
      b_rate = b_rate_above_sum / b_rate_below_sum,
      b_rate_product = KSL_MUL(b_rate, b_rate_below_sum),
      b_rate_above_sum_lo = b_rate_above - (b_rate_above_sum - b_rate_above_sum_right)
          + (b_rate_above_lo - b_rate_above_sum_right),
      b_rate_cross = KSL_MUL(b_rate, b_rate_below - (b_rate_below_sum - b_rate_below_sum_right)
          + (b_rate_below_cross2 - b_rate_below_sum_right)),
      b_rate_residual = b_rate_above_sum - b_rate_product
          - ksl_product_error(b_rate, b_rate_below_sum, b_rate_product) + b_rate_above_sum_lo
          - b_rate_cross;
  const double rate_vw_a = KSL_MUL(s->m0, s->m3), rate_vw_b = KSL_MUL(s->m1, s->m4),
      rate_vw_c = rate_vw_a + rate_vw_b, rate_vw_c_right = rate_vw_c - rate_vw_a,
      rate_vw_d = KSL_MUL(s->m2, s->m5), rate_vw = rate_vw_c + rate_vw_d,
      rate_vw_right = rate_vw - rate_vw_c,
      rate_vw_c_lo = ksl_product_rest(s->m0, s->m3, rate_vw_a, rate_vw_c - rate_vw_c_right)
          + ksl_product_rest(s->m1, s->m4, rate_vw_b, rate_vw_c_right);
  const double rate_bend_a_cross2 = KSL_MUL(b_rate, rate_vw_c - (rate_vw - rate_vw_right)
          + ksl_product_rest(s->m2, s->m5, rate_vw_d, rate_vw_right) + rate_vw_c_lo),
      rate_bend = -KSL_MUL(b_rate, rate_vw);
  const double rate_q_0 = KSL_MUL(0.5, s->m0), rate_q_1 = KSL_MUL(0.5, s->m1),
      rate_q_2 = KSL_MUL(0.5, s->m2);
  const double rate_beta_v_0 = -KSL_MUL(s->m0, b), rate_beta_v_1 = -KSL_MUL(s->m1, b),
      rate_beta_v_2 = -KSL_MUL(s->m2, b);
  const double rate_bend_lo = ksl_product_error(-b_rate, rate_vw, rate_bend) +
          -(KSL_MUL(b_rate_residual / b_rate_below_sum, rate_vw) + rate_bend_a_cross2),
      rate_bend_w_0 = -KSL_MUL(s->m3, rate_bend);
  const double rate_bend_w_1 = -KSL_MUL(s->m4, rate_bend),
      rate_bend_w_2 = -KSL_MUL(s->m5, rate_bend);
  const double rate_bend_w_0_lo = ksl_product_error(-s->m3, rate_bend, rate_bend_w_0) +
          -KSL_MUL(s->m3, rate_bend_lo), rate_symmetric_0a = KSL_MUL(s->m4, rate_bend_w_0),
      rate_beta_v_1_lo = ksl_product_error(-s->m1, b, rate_beta_v_1) + -KSL_MUL(s->m1, b_lo),
      rate_symmetric_0b = KSL_MUL(s->m3, rate_beta_v_1),
      rate_beta_v_0_lo = ksl_product_error(-s->m0, b, rate_beta_v_0) + -KSL_MUL(s->m0, b_lo),
      rate_symmetric_0c = KSL_MUL(s->m4, rate_beta_v_0),
      rate_symmetric_0d = rate_symmetric_0b + rate_symmetric_0c,
      rate_symmetric_0d_right = rate_symmetric_0d - rate_symmetric_0b,
      rate_symmetric_0d_left_rest = ksl_product_rest(s->m3, rate_beta_v_1, rate_symmetric_0b,
          rate_symmetric_0d - rate_symmetric_0d_right),
      rate_symmetric_0d_lo1 = rate_symmetric_0d_left_rest
          + ksl_product_rest(s->m4, rate_beta_v_0, rate_symmetric_0c, rate_symmetric_0d_right),
      rate_symmetric_0 = rate_symmetric_0a - rate_symmetric_0d,
      rate_symmetric_0_right = rate_symmetric_0a - rate_symmetric_0,
      rate_symmetric_0_left_rest = ksl_product_rest(s->m4, rate_bend_w_0, rate_symmetric_0a,
          rate_symmetric_0 + rate_symmetric_0_right),
      rate_symmetric_0d_lo = rate_symmetric_0d_lo1
          + (KSL_MUL(s->m3, rate_beta_v_1_lo) + KSL_MUL(s->m4, rate_beta_v_0_lo)),
      rate_symmetric_0_lo2 = rate_symmetric_0_left_rest
          - (rate_symmetric_0d - rate_symmetric_0_right) - rate_symmetric_0d_lo,
      rate_symmetric_0_lo = rate_symmetric_0_lo2 + KSL_MUL(s->m4, rate_bend_w_0_lo);
  const double rate_symmetric_1a = KSL_MUL(s->m5, rate_bend_w_0),
      rate_beta_v_2_lo = ksl_product_error(-s->m2, b, rate_beta_v_2) + -KSL_MUL(s->m2, b_lo),
      rate_symmetric_1b = KSL_MUL(s->m3, rate_beta_v_2),
      rate_symmetric_1c = KSL_MUL(s->m5, rate_beta_v_0),
      rate_symmetric_1d = rate_symmetric_1b + rate_symmetric_1c,
      rate_symmetric_1d_right = rate_symmetric_1d - rate_symmetric_1b,
      rate_symmetric_1d_left_rest = ksl_product_rest(s->m3, rate_beta_v_2, rate_symmetric_1b,
          rate_symmetric_1d - rate_symmetric_1d_right),
      rate_symmetric_1d_lo1 = rate_symmetric_1d_left_rest
          + ksl_product_rest(s->m5, rate_beta_v_0, rate_symmetric_1c, rate_symmetric_1d_right),
      rate_symmetric_1 = rate_symmetric_1a - rate_symmetric_1d,
      rate_symmetric_1_right = rate_symmetric_1a - rate_symmetric_1,
      rate_symmetric_1_left_rest = ksl_product_rest(s->m5, rate_bend_w_0, rate_symmetric_1a,
          rate_symmetric_1 + rate_symmetric_1_right),
      rate_symmetric_1d_lo = rate_symmetric_1d_lo1
          + (KSL_MUL(s->m3, rate_beta_v_2_lo) + KSL_MUL(s->m5, rate_beta_v_0_lo)),
      rate_symmetric_1_lo2 = rate_symmetric_1_left_rest
          - (rate_symmetric_1d - rate_symmetric_1_right) - rate_symmetric_1d_lo,
      rate_symmetric_1_lo = rate_symmetric_1_lo2 + KSL_MUL(s->m5, rate_bend_w_0_lo);
  const double rate_bend_w_1_lo = ksl_product_error(-s->m4, rate_bend, rate_bend_w_1) +
          -KSL_MUL(s->m4, rate_bend_lo), rate_symmetric_2a = KSL_MUL(s->m5, rate_bend_w_1),
      rate_symmetric_2b = KSL_MUL(s->m4, rate_beta_v_2),
      rate_symmetric_2c = KSL_MUL(s->m5, rate_beta_v_1),
      rate_symmetric_2d = rate_symmetric_2b + rate_symmetric_2c,
      rate_symmetric_2d_right = rate_symmetric_2d - rate_symmetric_2b,
      rate_symmetric_2d_left_rest = ksl_product_rest(s->m4, rate_beta_v_2, rate_symmetric_2b,
          rate_symmetric_2d - rate_symmetric_2d_right),
      rate_symmetric_2d_lo1 = rate_symmetric_2d_left_rest
          + ksl_product_rest(s->m5, rate_beta_v_1, rate_symmetric_2c, rate_symmetric_2d_right),
      rate_symmetric_2 = rate_symmetric_2a - rate_symmetric_2d,
      rate_symmetric_2_right = rate_symmetric_2a - rate_symmetric_2,
      rate_symmetric_2_left_rest = ksl_product_rest(s->m5, rate_bend_w_1, rate_symmetric_2a,
          rate_symmetric_2 + rate_symmetric_2_right),
      rate_symmetric_2d_lo = rate_symmetric_2d_lo1
          + (KSL_MUL(s->m4, rate_beta_v_2_lo) + KSL_MUL(s->m5, rate_beta_v_1_lo)),
      rate_symmetric_2_lo2 = rate_symmetric_2_left_rest
          - (rate_symmetric_2d - rate_symmetric_2_right) - rate_symmetric_2d_lo,
      rate_symmetric_2_lo = rate_symmetric_2_lo2 + KSL_MUL(s->m5, rate_bend_w_1_lo);
  const double rate_diagonal_0a = KSL_MUL(2.0, s->m4),
      rate_diagonal_0b = KSL_MUL(rate_diagonal_0a, rate_beta_v_1),
      rate_diagonal_0b_cross2 = KSL_MUL(rate_diagonal_0a, rate_beta_v_1_lo),
      rate_diagonal_0c = KSL_MUL(2.0, s->m5),
      rate_diagonal_0d = KSL_MUL(rate_diagonal_0c, rate_beta_v_2),
      rate_diagonal_0d_cross2 = KSL_MUL(rate_diagonal_0c, rate_beta_v_2_lo),
      rate_diagonal_0e = rate_diagonal_0b + rate_diagonal_0d,
      rate_diagonal_0e_right = rate_diagonal_0e - rate_diagonal_0b,
      rate_diagonal_0e_left_rest = ksl_product_rest(rate_diagonal_0a, rate_beta_v_1,
          rate_diagonal_0b, rate_diagonal_0e - rate_diagonal_0e_right),
      rate_diagonal_0e_lo1 = rate_diagonal_0e_left_rest
          + ksl_product_rest(rate_diagonal_0c, rate_beta_v_2, rate_diagonal_0d,
              rate_diagonal_0e_right),
      rate_diagonal_0f = KSL_MUL(s->m4, rate_bend_w_1),
      rate_diagonal_0f_cross2 = KSL_MUL(s->m4, rate_bend_w_1_lo),
      rate_diagonal_0g = KSL_MUL(s->m5, rate_bend_w_2),
      rate_diagonal_0g_cross2 = KSL_MUL(s->m5, ksl_product_error(-s->m5, rate_bend, rate_bend_w_2)
          + -KSL_MUL(s->m5, rate_bend_lo)), rate_diagonal_0h = rate_diagonal_0f + rate_diagonal_0g,
      rate_diagonal_0h_right = rate_diagonal_0h - rate_diagonal_0f,
      rate_diagonal_0h_left_rest = ksl_product_rest(s->m4, rate_bend_w_1, rate_diagonal_0f,
          rate_diagonal_0h - rate_diagonal_0h_right),
      rate_diagonal_0h_lo1 = rate_diagonal_0h_left_rest
          + ksl_product_rest(s->m5, rate_bend_w_2, rate_diagonal_0g, rate_diagonal_0h_right),
      rate_diagonal_0 = rate_diagonal_0e - rate_diagonal_0h,
      rate_diagonal_0_right = rate_diagonal_0e - rate_diagonal_0,
      rate_diagonal_0_lo1 = rate_diagonal_0e - (rate_diagonal_0 + rate_diagonal_0_right)
          - (rate_diagonal_0h - rate_diagonal_0_right),
      rate_diagonal_0_lo2 = rate_diagonal_0_lo1
          - (rate_diagonal_0h_lo1 + (rate_diagonal_0f_cross2 + rate_diagonal_0g_cross2));
  const double rate_diagonal_1a = KSL_MUL(2.0, s->m3),
      rate_diagonal_1b = KSL_MUL(rate_diagonal_1a, rate_beta_v_0),
      rate_diagonal_1b_cross2 = KSL_MUL(rate_diagonal_1a, rate_beta_v_0_lo),
      rate_diagonal_1c = rate_diagonal_1b + rate_diagonal_0d,
      rate_diagonal_1c_right = rate_diagonal_1c - rate_diagonal_1b,
      rate_diagonal_1c_left_rest = ksl_product_rest(rate_diagonal_1a, rate_beta_v_0,
          rate_diagonal_1b, rate_diagonal_1c - rate_diagonal_1c_right),
      rate_diagonal_1c_lo1 = rate_diagonal_1c_left_rest
          + ksl_product_rest(rate_diagonal_0c, rate_beta_v_2, rate_diagonal_0d,
              rate_diagonal_1c_right),
      rate_diagonal_1d = KSL_MUL(s->m3, rate_bend_w_0),
      rate_diagonal_1d_cross2 = KSL_MUL(s->m3, rate_bend_w_0_lo),
      rate_diagonal_1e = rate_diagonal_1d + rate_diagonal_0g,
      rate_diagonal_1e_right = rate_diagonal_1e - rate_diagonal_1d,
      rate_diagonal_1e_left_rest = ksl_product_rest(s->m3, rate_bend_w_0, rate_diagonal_1d,
          rate_diagonal_1e - rate_diagonal_1e_right),
      rate_diagonal_1e_lo1 = rate_diagonal_1e_left_rest
          + ksl_product_rest(s->m5, rate_bend_w_2, rate_diagonal_0g, rate_diagonal_1e_right),
      rate_diagonal_1 = rate_diagonal_1c - rate_diagonal_1e,
      rate_diagonal_1_right = rate_diagonal_1c - rate_diagonal_1,
      rate_diagonal_1_lo1 = rate_diagonal_1c - (rate_diagonal_1 + rate_diagonal_1_right)
          - (rate_diagonal_1e - rate_diagonal_1_right),
      rate_diagonal_1_lo2 = rate_diagonal_1_lo1
          - (rate_diagonal_1e_lo1 + (rate_diagonal_1d_cross2 + rate_diagonal_0g_cross2));
  const double rate_diagonal_2a = rate_diagonal_1b + rate_diagonal_0b,
      rate_diagonal_2a_right = rate_diagonal_2a - rate_diagonal_1b,
      rate_diagonal_2a_left_rest = ksl_product_rest(rate_diagonal_1a, rate_beta_v_0,
          rate_diagonal_1b, rate_diagonal_2a - rate_diagonal_2a_right),
      rate_diagonal_2a_lo1 = rate_diagonal_2a_left_rest
          + ksl_product_rest(rate_diagonal_0a, rate_beta_v_1, rate_diagonal_0b,
              rate_diagonal_2a_right),
      rate_diagonal_2b = rate_diagonal_1d + rate_diagonal_0f,
      rate_diagonal_2b_right = rate_diagonal_2b - rate_diagonal_1d,
      rate_diagonal_2b_left_rest = ksl_product_rest(s->m3, rate_bend_w_0, rate_diagonal_1d,
          rate_diagonal_2b - rate_diagonal_2b_right),
      rate_diagonal_2b_lo1 = rate_diagonal_2b_left_rest
          + ksl_product_rest(s->m4, rate_bend_w_1, rate_diagonal_0f, rate_diagonal_2b_right),
      rate_diagonal_2 = rate_diagonal_2a - rate_diagonal_2b,
      rate_diagonal_2_right = rate_diagonal_2a - rate_diagonal_2,
      rate_diagonal_2_lo1 = rate_diagonal_2a - (rate_diagonal_2 + rate_diagonal_2_right)
          - (rate_diagonal_2b - rate_diagonal_2_right),
      rate_diagonal_2_lo2 = rate_diagonal_2_lo1
          - (rate_diagonal_2b_lo1 + (rate_diagonal_1d_cross2 + rate_diagonal_0f_cross2));
  const double M_04 = rate_symmetric_0 - rate_q_2, M_04_right = rate_symmetric_0 - M_04;
  const double M_05 = rate_q_1 + rate_symmetric_1, M_05_right = M_05 - rate_q_1;
  const double M_13 = rate_q_2 + rate_symmetric_0, M_13_right = M_13 - rate_q_2;
  const double M_15 = rate_symmetric_2 - rate_q_0, M_15_right = rate_symmetric_2 - M_15;
  const double M_23 = rate_symmetric_1 - rate_q_1, M_23_right = rate_symmetric_1 - M_23;
  const double M_24 = rate_q_0 + rate_symmetric_2, M_24_right = M_24 - rate_q_0;
  const double diagonal0_rounded = diagonal0
          + (m_0_sum < others_0_sum ? diagonal0b_lo : diagonal0a_lo),
      diagonal0_final = diagonal0_rounded == diagonal0_rounded ? diagonal0_rounded : diagonal0;
  const double J_1_rounded = J_1
          + (ksl_product_rest(s->m4, beta_v_0, m_3, J_1 + J_1_right) - (halved_2 - J_1_right)
          + m_3_cross2), J_1_final = J_1_rounded == J_1_rounded ? J_1_rounded : J_1;
  const double J_2_rounded = J_2
          + (halved_1 - (J_2 - J_2_right) + ksl_product_rest(s->m5, beta_v_0, m_4, J_2_right)
          + m_4_cross2), J_2_final = J_2_rounded == J_2_rounded ? J_2_rounded : J_2;
  const double rate_diagonal_0_rounded = rate_diagonal_0
          + (rate_diagonal_0_lo2
          + (rate_diagonal_0e_lo1 + (rate_diagonal_0b_cross2 + rate_diagonal_0d_cross2)));
  const double M_04_rounded = M_04
          + (rate_symmetric_0 - (M_04 + M_04_right) - (rate_q_2 - M_04_right)
          + rate_symmetric_0_lo);
  const double M_05_rounded = M_05
          + (rate_q_1 - (M_05 - M_05_right) + (rate_symmetric_1 - M_05_right)
          + rate_symmetric_1_lo);
  const double J_3_rounded = J_3
          + (halved_2 - (J_3 - J_3_right) + ksl_product_rest(s->m4, beta_v_0, m_3, J_3_right)
          + m_3_cross2), J_3_final = J_3_rounded == J_3_rounded ? J_3_rounded : J_3;
  const double diagonal1_rounded = diagonal1
          + (m_1_sum < others_1_sum ? diagonal1b_lo : diagonal1a_lo),
      diagonal1_final = diagonal1_rounded == diagonal1_rounded ? diagonal1_rounded : diagonal1;
  const double J_5_rounded = J_5
          + (ksl_product_rest(s->m5, beta_v_1, m_5, J_5 + J_5_right) - (halved_0 - J_5_right)
          + m_5_cross2), J_5_final = J_5_rounded == J_5_rounded ? J_5_rounded : J_5;
  const double M_13_rounded = M_13
          + (rate_q_2 - (M_13 - M_13_right) + (rate_symmetric_0 - M_13_right)
          + rate_symmetric_0_lo);
  const double rate_diagonal_1_rounded = rate_diagonal_1
          + (rate_diagonal_1_lo2
          + (rate_diagonal_1c_lo1 + (rate_diagonal_1b_cross2 + rate_diagonal_0d_cross2)));
  const double M_15_rounded = M_15
          + (rate_symmetric_2 - (M_15 + M_15_right) - (rate_q_0 - M_15_right)
          + rate_symmetric_2_lo);
  const double J_6_rounded = J_6
          + (ksl_product_rest(s->m5, beta_v_0, m_4, J_6 + J_6_right) - (halved_1 - J_6_right)
          + m_4_cross2), J_6_final = J_6_rounded == J_6_rounded ? J_6_rounded : J_6;
  const double J_7_rounded = J_7
          + (halved_0 - (J_7 - J_7_right) + ksl_product_rest(s->m5, beta_v_1, m_5, J_7_right)
          + m_5_cross2), J_7_final = J_7_rounded == J_7_rounded ? J_7_rounded : J_7;
  const double diagonal2_rounded = diagonal2
          + (m_2_sum < others_2_sum ? diagonal2b_lo : diagonal2a_lo),
      diagonal2_final = diagonal2_rounded == diagonal2_rounded ? diagonal2_rounded : diagonal2;
  const double M_23_rounded = M_23
          + (rate_symmetric_1 - (M_23 + M_23_right) - (rate_q_1 - M_23_right)
          + rate_symmetric_1_lo);
  const double M_24_rounded = M_24
          + (rate_q_0 - (M_24 - M_24_right) + (rate_symmetric_2 - M_24_right)
          + rate_symmetric_2_lo);
  const double rate_diagonal_2_rounded = rate_diagonal_2
          + (rate_diagonal_2_lo2
          + (rate_diagonal_2a_lo1 + (rate_diagonal_1b_cross2 + rate_diagonal_0b_cross2)));
  const double rate_diagonal_0_final = rate_diagonal_0_rounded == rate_diagonal_0_rounded
          ? rate_diagonal_0_rounded : rate_diagonal_0;
  const double M_04_final = M_04_rounded == M_04_rounded ? M_04_rounded : M_04;
  const double M_05_final = M_05_rounded == M_05_rounded ? M_05_rounded : M_05;
  const double M_13_final = M_13_rounded == M_13_rounded ? M_13_rounded : M_13;
  const double rate_diagonal_1_final = rate_diagonal_1_rounded == rate_diagonal_1_rounded
          ? rate_diagonal_1_rounded : rate_diagonal_1;
  const double M_15_final = M_15_rounded == M_15_rounded ? M_15_rounded : M_15;
  const double M_23_final = M_23_rounded == M_23_rounded ? M_23_rounded : M_23;
  const double M_24_final = M_24_rounded == M_24_rounded ? M_24_rounded : M_24;
  const double rate_diagonal_2_final = rate_diagonal_2_rounded == rate_diagonal_2_rounded
          ? rate_diagonal_2_rounded : rate_diagonal_2;
  M->at[0][0] = diagonal0_final;
  M->at[1][0] = J_1_final;
  M->at[2][0] = J_2_final;
  M->at[3][0] = rate_diagonal_0_final;
  M->at[4][0] = M_04_final;
  M->at[5][0] = M_05_final;
  M->at[0][1] = J_3_final;
  M->at[1][1] = diagonal1_final;
  M->at[2][1] = J_5_final;
  M->at[3][1] = M_13_final;
  M->at[4][1] = rate_diagonal_1_final;
  M->at[5][1] = M_15_final;
  M->at[0][2] = J_6_final;
  M->at[1][2] = J_7_final;
  M->at[2][2] = diagonal2_final;
  M->at[3][2] = M_23_final;
  M->at[4][2] = M_24_final;
  M->at[5][2] = rate_diagonal_2_final;
  M->at[0][3] = 0.0;
  M->at[1][3] = 0.0;
  M->at[2][3] = 0.0;
  M->at[3][3] = diagonal0_final;
  M->at[4][3] = J_1_final;
  M->at[5][3] = J_2_final;
  M->at[0][4] = 0.0;
  M->at[1][4] = 0.0;
  M->at[2][4] = 0.0;
  M->at[3][4] = J_3_final;
  M->at[4][4] = diagonal1_final;
  M->at[5][4] = J_5_final;
  M->at[0][5] = 0.0;
  M->at[1][5] = 0.0;
  M->at[2][5] = 0.0;
  M->at[3][5] = J_6_final;
  M->at[4][5] = J_7_final;
  M->at[5][5] = diagonal2_final;
}

/* Do = D1 exp(k log(D1^-1 D2)), the screw motion from D1 at k = 0 to D2 at k = 1.
   D1, D2, Do: displacement [R | t], R rotation, t in m; k: number.
   717 mul, 1706 add, 66 product error, 166 product rest, 29 div, 3 sqrt, 13 neg, 18 abs, 4
     copysign, 38 less, 20 equal, 110 select.
   Error <= R: 1 u, t: 1 u of its largest component, or of D1.t or D2.t if that is larger, for R
     of D1 a rotation and R of D2 a rotation and 0 <= k <= 1; searched, not proved.  Each
     component is within 1 ulp as long as its condition is below 1e13; in single precision it is
     the nearest number, except near ties, as long as that is below 1e5; searched, not proved.
     Intermediate sums may overflow where |t| of D1 or D2 is above 2e306, in single precision
     5e36. */
static inline void ksl_SE3_interpolated_accurate(const ksl_SE3_t *D1, const ksl_SE3_t *D2,
    const double k, ksl_SE3_t *Do) {
  const double apart_0 = D2->m03 - D1->m03, apart_0_right = D2->m03 - apart_0,
      apart_0_lo = D2->m03 - (apart_0 + apart_0_right) - (D1->m03 - apart_0_right);
  const double apart_1 = D2->m13 - D1->m13, apart_1_right = D2->m13 - apart_1,
      apart_1_lo = D2->m13 - (apart_1 + apart_1_right) - (D1->m13 - apart_1_right);
  const double apart_2 = D2->m23 - D1->m23, apart_2_right = D2->m23 - apart_2,
      apart_2_lo = D2->m23 - (apart_2 + apart_2_right) - (D1->m23 - apart_2_right);
  const double between_0a = KSL_MUL(D1->m00, D2->m00), between_0b = KSL_MUL(D1->m10, D2->m10),
      between_0c = between_0a + between_0b, between_0c_right = between_0c - between_0a,
      between_0c_left_rest = ksl_product_rest(D1->m00, D2->m00, between_0a, between_0c
          - between_0c_right), between_0d = KSL_MUL(D1->m20, D2->m20),
      between_0 = between_0c + between_0d, between_0_right = between_0 - between_0c,
      between_0_lo1 = between_0c - (between_0 - between_0_right)
          + ksl_product_rest(D1->m20, D2->m20, between_0d, between_0_right),
      between_0_lo = between_0_lo1
          + (between_0c_left_rest
          + ksl_product_rest(D1->m10, D2->m10, between_0b, between_0c_right));
  const double between_1a = KSL_MUL(D1->m00, D2->m01), between_1b = KSL_MUL(D1->m10, D2->m11),
      between_1c = between_1a + between_1b, between_1c_right = between_1c - between_1a,
      between_1c_left_rest = ksl_product_rest(D1->m00, D2->m01, between_1a, between_1c
          - between_1c_right), between_1d = KSL_MUL(D1->m20, D2->m21),
      between_1 = between_1c + between_1d, between_1_right = between_1 - between_1c,
      between_1_lo1 = between_1c - (between_1 - between_1_right)
          + ksl_product_rest(D1->m20, D2->m21, between_1d, between_1_right),
      between_1_lo = between_1_lo1
          + (between_1c_left_rest
          + ksl_product_rest(D1->m10, D2->m11, between_1b, between_1c_right));
  const double between_2a = KSL_MUL(D1->m00, D2->m02), between_2b = KSL_MUL(D1->m10, D2->m12),
      between_2c = between_2a + between_2b, between_2c_right = between_2c - between_2a,
      between_2c_left_rest = ksl_product_rest(D1->m00, D2->m02, between_2a, between_2c
          - between_2c_right), between_2d = KSL_MUL(D1->m20, D2->m22),
      between_2 = between_2c + between_2d, between_2_right = between_2 - between_2c,
      between_2_lo1 = between_2c - (between_2 - between_2_right)
          + ksl_product_rest(D1->m20, D2->m22, between_2d, between_2_right),
      between_2_lo = between_2_lo1
          + (between_2c_left_rest
          + ksl_product_rest(D1->m10, D2->m12, between_2b, between_2c_right));
  const double between_3a = KSL_MUL(D1->m00, apart_0), between_3b = KSL_MUL(D1->m10, apart_1),
      between_3c = between_3a + between_3b, between_3c_right = between_3c - between_3a,
      between_3c_left_rest = ksl_product_rest(D1->m00, apart_0, between_3a, between_3c
          - between_3c_right),
      between_3c_lo1 = between_3c_left_rest
          + ksl_product_rest(D1->m10, apart_1, between_3b, between_3c_right),
      between_3d = KSL_MUL(D1->m20, apart_2), between_3 = between_3c + between_3d,
      between_3_right = between_3 - between_3c,
      between_3_lo1 = between_3c - (between_3 - between_3_right)
          + ksl_product_rest(D1->m20, apart_2, between_3d, between_3_right),
      between_3_lo = between_3_lo1 + KSL_MUL(D1->m20, apart_2_lo)
          + (between_3c_lo1 + (KSL_MUL(D1->m00, apart_0_lo) + KSL_MUL(D1->m10, apart_1_lo)));
  const double between_4a = KSL_MUL(D1->m01, D2->m00), between_4b = KSL_MUL(D1->m11, D2->m10),
      between_4c = between_4a + between_4b, between_4c_right = between_4c - between_4a,
      between_4c_left_rest = ksl_product_rest(D1->m01, D2->m00, between_4a, between_4c
          - between_4c_right), between_4d = KSL_MUL(D1->m21, D2->m20),
      between_4 = between_4c + between_4d, between_4_right = between_4 - between_4c,
      between_4_lo1 = between_4c - (between_4 - between_4_right)
          + ksl_product_rest(D1->m21, D2->m20, between_4d, between_4_right),
      between_4_lo = between_4_lo1
          + (between_4c_left_rest
          + ksl_product_rest(D1->m11, D2->m10, between_4b, between_4c_right));
  const double between_5a = KSL_MUL(D1->m01, D2->m01), between_5b = KSL_MUL(D1->m11, D2->m11),
      between_5c = between_5a + between_5b, between_5c_right = between_5c - between_5a,
      between_5c_left_rest = ksl_product_rest(D1->m01, D2->m01, between_5a, between_5c
          - between_5c_right), between_5d = KSL_MUL(D1->m21, D2->m21),
      between_5 = between_5c + between_5d, between_5_right = between_5 - between_5c,
      between_5_lo1 = between_5c - (between_5 - between_5_right)
          + ksl_product_rest(D1->m21, D2->m21, between_5d, between_5_right),
      between_5_lo = between_5_lo1
          + (between_5c_left_rest
          + ksl_product_rest(D1->m11, D2->m11, between_5b, between_5c_right));
  const double between_6a = KSL_MUL(D1->m01, D2->m02), between_6b = KSL_MUL(D1->m11, D2->m12),
      between_6c = between_6a + between_6b, between_6c_right = between_6c - between_6a,
      between_6c_left_rest = ksl_product_rest(D1->m01, D2->m02, between_6a, between_6c
          - between_6c_right), between_6d = KSL_MUL(D1->m21, D2->m22),
      between_6 = between_6c + between_6d, between_6_right = between_6 - between_6c,
      between_6_lo1 = between_6c - (between_6 - between_6_right)
          + ksl_product_rest(D1->m21, D2->m22, between_6d, between_6_right),
      between_6_lo = between_6_lo1
          + (between_6c_left_rest
          + ksl_product_rest(D1->m11, D2->m12, between_6b, between_6c_right));
  const double between_7a = KSL_MUL(D1->m01, apart_0), between_7b = KSL_MUL(D1->m11, apart_1),
      between_7c = between_7a + between_7b, between_7c_right = between_7c - between_7a,
      between_7c_left_rest = ksl_product_rest(D1->m01, apart_0, between_7a, between_7c
          - between_7c_right),
      between_7c_lo1 = between_7c_left_rest
          + ksl_product_rest(D1->m11, apart_1, between_7b, between_7c_right),
      between_7d = KSL_MUL(D1->m21, apart_2), between_7 = between_7c + between_7d,
      between_7_right = between_7 - between_7c,
      between_7_lo1 = between_7c - (between_7 - between_7_right)
          + ksl_product_rest(D1->m21, apart_2, between_7d, between_7_right),
      between_7_lo = between_7_lo1 + KSL_MUL(D1->m21, apart_2_lo)
          + (between_7c_lo1 + (KSL_MUL(D1->m01, apart_0_lo) + KSL_MUL(D1->m11, apart_1_lo)));
  const double between_8a = KSL_MUL(D1->m02, D2->m00), between_8b = KSL_MUL(D1->m12, D2->m10),
      between_8c = between_8a + between_8b, between_8c_right = between_8c - between_8a,
      between_8c_left_rest = ksl_product_rest(D1->m02, D2->m00, between_8a, between_8c
          - between_8c_right), between_8d = KSL_MUL(D1->m22, D2->m20),
      between_8 = between_8c + between_8d, between_8_right = between_8 - between_8c,
      between_8_lo1 = between_8c - (between_8 - between_8_right)
          + ksl_product_rest(D1->m22, D2->m20, between_8d, between_8_right),
      between_8_lo = between_8_lo1
          + (between_8c_left_rest
          + ksl_product_rest(D1->m12, D2->m10, between_8b, between_8c_right));
  const double between_9a = KSL_MUL(D1->m02, D2->m01), between_9b = KSL_MUL(D1->m12, D2->m11),
      between_9c = between_9a + between_9b, between_9c_right = between_9c - between_9a,
      between_9c_left_rest = ksl_product_rest(D1->m02, D2->m01, between_9a, between_9c
          - between_9c_right), between_9d = KSL_MUL(D1->m22, D2->m21),
      between_9 = between_9c + between_9d, between_9_right = between_9 - between_9c,
      between_9_lo1 = between_9c - (between_9 - between_9_right)
          + ksl_product_rest(D1->m22, D2->m21, between_9d, between_9_right),
      between_9_lo = between_9_lo1
          + (between_9c_left_rest
          + ksl_product_rest(D1->m12, D2->m11, between_9b, between_9c_right));
  const double between_10a = KSL_MUL(D1->m02, D2->m02), between_10b = KSL_MUL(D1->m12, D2->m12),
      between_10c = between_10a + between_10b, between_10c_right = between_10c - between_10a,
      between_10c_left_rest = ksl_product_rest(D1->m02, D2->m02, between_10a, between_10c
          - between_10c_right), between_10d = KSL_MUL(D1->m22, D2->m22),
      between_10 = between_10c + between_10d, between_10_right = between_10 - between_10c,
      between_10_lo1 = between_10c - (between_10 - between_10_right)
          + ksl_product_rest(D1->m22, D2->m22, between_10d, between_10_right),
      between_10_lo = between_10_lo1
          + (between_10c_left_rest
          + ksl_product_rest(D1->m12, D2->m12, between_10b, between_10c_right));
  const double between_11a = KSL_MUL(D1->m02, apart_0), between_11b = KSL_MUL(D1->m12, apart_1),
      between_11c = between_11a + between_11b, between_11c_right = between_11c - between_11a,
      between_11c_left_rest = ksl_product_rest(D1->m02, apart_0, between_11a, between_11c
          - between_11c_right),
      between_11c_lo1 = between_11c_left_rest
          + ksl_product_rest(D1->m12, apart_1, between_11b, between_11c_right),
      between_11d = KSL_MUL(D1->m22, apart_2), between_11 = between_11c + between_11d,
      between_11_right = between_11 - between_11c,
      between_11_lo1 = between_11c - (between_11 - between_11_right)
          + ksl_product_rest(D1->m22, apart_2, between_11d, between_11_right),
      between_11_lo = between_11_lo1 + KSL_MUL(D1->m22, apart_2_lo)
          + (between_11c_lo1 + (KSL_MUL(D1->m02, apart_0_lo) + KSL_MUL(D1->m12, apart_1_lo)));
  const double log_p_0 = between_9 - between_6, log_p_0_right = between_9 - log_p_0,
      log_p_0_lo = between_9 - (log_p_0 + log_p_0_right) - (between_6 - log_p_0_right)
          - between_6_lo + between_9_lo;
  const double log_p_1 = between_2 - between_8, log_p_1_right = between_2 - log_p_1,
      log_p_1_lo = between_2 - (log_p_1 + log_p_1_right) - (between_8 - log_p_1_right)
          - between_8_lo + between_2_lo;
  const double log_p_2 = between_4 - between_1, log_p_2_right = between_4 - log_p_2,
      log_p_2_lo = between_4 - (log_p_2 + log_p_2_right) - (between_1 - log_p_2_right)
          - between_1_lo + between_4_lo;
  const double log_s_0 = between_6 + between_9, log_s_0_right = log_s_0 - between_6,
      log_s_0_lo = between_6 - (log_s_0 - log_s_0_right) + (between_9 - log_s_0_right)
          + between_9_lo + between_6_lo;
  const double log_s_1 = between_2 + between_8, log_s_1_right = log_s_1 - between_2,
      log_s_1_lo = between_2 - (log_s_1 - log_s_1_right) + (between_8 - log_s_1_right)
          + between_8_lo + between_2_lo;
  const double log_s_2 = between_1 + between_4, log_s_2_right = log_s_2 - between_1,
      log_s_2_lo = between_1 - (log_s_2 - log_s_2_right) + (between_4 - log_s_2_right)
          + between_4_lo + between_1_lo;
  const double log_first_0 = between_0 + 1.0, log_first_0_right = log_first_0 - between_0,
      log_first_0_lo = between_0 - (log_first_0 - log_first_0_right) + (1.0 - log_first_0_right)
          + between_0_lo;
  const double log_first_1 = 1.0 - between_0, log_first_1_right = 1.0 - log_first_1,
      log_first_1_lo = 1.0 - (log_first_1 + log_first_1_right) - (between_0 - log_first_1_right)
          - between_0_lo;
  const double log_others_0 = between_5 + between_10, log_others_0_right = log_others_0 - between_5,
      log_others_0_lo = between_5 - (log_others_0 - log_others_0_right)
          + (between_10 - log_others_0_right) + between_10_lo + between_5_lo;
  const double log_others_1 = between_5 - between_10, log_others_1_right = between_5 - log_others_1,
      log_others_1_lo = between_5 - (log_others_1 + log_others_1_right)
          - (between_10 - log_others_1_right) - between_10_lo + between_5_lo;
  const double log_d_0 = log_first_0 + log_others_0, log_d_0_right = log_d_0 - log_first_0,
      log_d_0_lo = log_first_0 - (log_d_0 - log_d_0_right) + (log_others_0 - log_d_0_right)
          + log_others_0_lo + log_first_0_lo;
  const double log_d_1 = log_first_0 - log_others_0, log_d_1_right = log_first_0 - log_d_1,
      log_d_1_lo = log_first_0 - (log_d_1 + log_d_1_right) - (log_others_0 - log_d_1_right)
          - log_others_0_lo + log_first_0_lo;
  const double log_d_2 = log_first_1 + log_others_1, log_d_2_right = log_d_2 - log_first_1,
      log_d_2_lo = log_first_1 - (log_d_2 - log_d_2_right) + (log_others_1 - log_d_2_right)
          + log_others_1_lo + log_first_1_lo;
  const double log_d_3 = log_first_1 - log_others_1, log_d_3_right = log_first_1 - log_d_3,
      log_d_3_lo = log_first_1 - (log_d_3 + log_d_3_right) - (log_others_1 - log_d_3_right)
          - log_others_1_lo + log_first_1_lo;
  const double between_5_sum = between_5 + between_5_lo,
      between_5_sum_right = between_5_sum - between_5, between_0_sum = between_0 + between_0_lo,
      log_low_0 = between_5_sum < between_0_sum ? log_d_1 : log_s_2,
      log_low_0_lo = between_5_sum < between_0_sum ? log_d_1_lo : log_s_2_lo;
  const double log_low_1 = between_5_sum < between_0_sum ? log_s_2 : log_d_2,
      log_low_1_lo = between_5_sum < between_0_sum ? log_s_2_lo : log_d_2_lo;
  const double log_low_2 = between_5_sum < between_0_sum ? log_s_1 : log_s_0,
      log_low_2_lo = between_5_sum < between_0_sum ? log_s_1_lo : log_s_0_lo;
  const double log_low_3 = between_5_sum < between_0_sum ? log_p_0 : log_p_1,
      log_low_3_lo = between_5_sum < between_0_sum ? log_p_0_lo : log_p_1_lo;
  const double log_high_0a_sum = -between_5_sum +
          -(between_5 - (between_5_sum - between_5_sum_right)
          + (between_5_lo - between_5_sum_right)),
      log_high_0 = between_0_sum < log_high_0a_sum ? log_s_1 : log_p_0,
      log_high_0_lo = between_0_sum < log_high_0a_sum ? log_s_1_lo : log_p_0_lo;
  const double log_high_1 = between_0_sum < log_high_0a_sum ? log_s_0 : log_p_1,
      log_high_1_lo = between_0_sum < log_high_0a_sum ? log_s_0_lo : log_p_1_lo;
  const double log_high_2 = between_0_sum < log_high_0a_sum ? log_d_3 : log_p_2,
      log_high_2_lo = between_0_sum < log_high_0a_sum ? log_d_3_lo : log_p_2_lo;
  const double log_high_3 = between_0_sum < log_high_0a_sum ? log_p_2 : log_d_0,
      log_high_3_lo = between_0_sum < log_high_0a_sum ? log_p_2_lo : log_d_0_lo;
  const double between_10_sum = between_10 + between_10_lo,
      log_column_0 = between_10_sum < 0.0 ? log_low_0 : log_high_0,
      log_column_0_lo = between_10_sum < 0.0 ? log_low_0_lo : log_high_0_lo;
  const double log_column_1 = between_10_sum < 0.0 ? log_low_1 : log_high_1,
      log_column_1_lo = between_10_sum < 0.0 ? log_low_1_lo : log_high_1_lo;
  const double log_column_2 = between_10_sum < 0.0 ? log_low_2 : log_high_2,
      log_column_2_lo = between_10_sum < 0.0 ? log_low_2_lo : log_high_2_lo;
  const double log_column_3 = between_10_sum < 0.0 ? log_low_3 : log_high_3,
      log_column_3_lo = between_10_sum < 0.0 ? log_low_3_lo : log_high_3_lo;
  const double log_upper_0a = -log_column_0, log_upper_0a_lo = -log_column_0_lo,
      log_column_3_sum = log_column_3 + log_column_3_lo,
      log_column_3_sum_right = log_column_3_sum - log_column_3,
      log_column_3_sum_lo = log_column_3 - (log_column_3_sum - log_column_3_sum_right)
          + (log_column_3_lo - log_column_3_sum_right),
      log_upper_0 = log_column_3_sum < 0.0 ? log_upper_0a : log_column_0,
      log_upper_0_lo = log_column_3_sum < 0.0 ? log_upper_0a_lo : log_column_0_lo;
  const double log_upper_1a = -log_column_1, log_upper_1a_lo = -log_column_1_lo,
      log_upper_1 = log_column_3_sum < 0.0 ? log_upper_1a : log_column_1,
      log_upper_1_lo = log_column_3_sum < 0.0 ? log_upper_1a_lo : log_column_1_lo;
  const double log_upper_2a = -log_column_2, log_upper_2a_lo = -log_column_2_lo,
      log_upper_2 = log_column_3_sum < 0.0 ? log_upper_2a : log_column_2,
      log_upper_2_lo = log_column_3_sum < 0.0 ? log_upper_2a_lo : log_column_2_lo;
  const double log_upper_3 = fabs(log_column_3_sum), log_upper_3_opposite = -log_column_3_sum_lo,
      log_upper_3_lo = log_column_3_sum < 0.0 ? log_upper_3_opposite : log_column_3_sum_lo;
  const double log_upper_0_sum = log_upper_0 + log_upper_0_lo,
      log_upper_0_sum_right = log_upper_0_sum - log_upper_0,
      log_upper_0_sum_lo = log_upper_0 - (log_upper_0_sum - log_upper_0_sum_right)
          + (log_upper_0_lo - log_upper_0_sum_right), log_v_s_size_0 = fabs(log_upper_0_sum),
      log_v_s_size_0_opposite = -log_upper_0_sum_lo,
      log_v_s_size_0_lo = log_upper_0_sum < 0.0 ? log_v_s_size_0_opposite : log_upper_0_sum_lo;
  const double log_upper_1_sum = log_upper_1 + log_upper_1_lo,
      log_upper_1_sum_right = log_upper_1_sum - log_upper_1,
      log_upper_1_sum_lo = log_upper_1 - (log_upper_1_sum - log_upper_1_sum_right)
          + (log_upper_1_lo - log_upper_1_sum_right), log_v_s_size_1 = fabs(log_upper_1_sum),
      log_v_s_size_1_opposite = -log_upper_1_sum_lo,
      log_v_s_size_1_lo = log_upper_1_sum < 0.0 ? log_v_s_size_1_opposite : log_upper_1_sum_lo;
  const double log_upper_2_sum = log_upper_2 + log_upper_2_lo,
      log_upper_2_sum_right = log_upper_2_sum - log_upper_2,
      log_upper_2_sum_lo = log_upper_2 - (log_upper_2_sum - log_upper_2_sum_right)
          + (log_upper_2_lo - log_upper_2_sum_right), log_v_s_size_2 = fabs(log_upper_2_sum),
      log_v_s_size_2_opposite = -log_upper_2_sum_lo,
      log_v_s_size_2_lo = log_upper_2_sum < 0.0 ? log_v_s_size_2_opposite : log_upper_2_sum_lo;
  const double log_v_s_size_0_sum = log_v_s_size_0 + log_v_s_size_0_lo,
      log_v_s_size_0_sum_right = log_v_s_size_0_sum - log_v_s_size_0,
      log_v_s_size_0_sum_lo = log_v_s_size_0 - (log_v_s_size_0_sum - log_v_s_size_0_sum_right)
          + (log_v_s_size_0_lo - log_v_s_size_0_sum_right),
      log_v_s_size_1_sum = log_v_s_size_1 + log_v_s_size_1_lo,
      log_v_s_size_1_sum_right = log_v_s_size_1_sum - log_v_s_size_1,
      log_v_s_size_1_sum_lo = log_v_s_size_1 - (log_v_s_size_1_sum - log_v_s_size_1_sum_right)
          + (log_v_s_size_1_lo - log_v_s_size_1_sum_right),
      log_v_s_largest1 = log_v_s_size_0_sum < log_v_s_size_1_sum ? log_v_s_size_1_sum
          : log_v_s_size_0_sum,
      log_v_s_largest1_lo = log_v_s_size_0_sum < log_v_s_size_1_sum ? log_v_s_size_1_sum_lo
          : log_v_s_size_0_sum_lo;
  const double log_v_s_largest1_sum = log_v_s_largest1 + log_v_s_largest1_lo,
      log_v_s_largest1_sum_right = log_v_s_largest1_sum - log_v_s_largest1,
      log_v_s_largest1_sum_lo = log_v_s_largest1
          - (log_v_s_largest1_sum - log_v_s_largest1_sum_right)
          + (log_v_s_largest1_lo - log_v_s_largest1_sum_right),
      log_v_s_size_2_sum = log_v_s_size_2 + log_v_s_size_2_lo,
      log_v_s_size_2_sum_right = log_v_s_size_2_sum - log_v_s_size_2,
      log_v_s_size_2_sum_lo = log_v_s_size_2 - (log_v_s_size_2_sum - log_v_s_size_2_sum_right)
          + (log_v_s_size_2_lo - log_v_s_size_2_sum_right),
      log_v_s_largest2 = log_v_s_largest1_sum < log_v_s_size_2_sum ? log_v_s_size_2_sum
          : log_v_s_largest1_sum;
  const double log_v_s_largest2_sum = log_v_s_largest2
          + (log_v_s_largest1_sum < log_v_s_size_2_sum ? log_v_s_size_2_sum_lo
          : log_v_s_largest1_sum_lo),
      log_v_s_b = 6.703903964971299e+153 < log_v_s_largest2_sum ? 3.7291703656001034e-155 : 1.0,
      log_v_s_d = log_v_s_largest2_sum < 256.0 ? 1.3093562431584567e+151 : log_v_s_b,
      log_v_s = log_v_s_largest2_sum < 1.955159272639747e-149 ? 1.0715086071862673e+301 : log_v_s_d;
  const double log_v_y_0 = KSL_MUL(log_upper_0_sum, log_v_s), log_v_y_0_inverse = 1.0 / log_v_s,
      log_v_y_0_lo = KSL_MUL(log_upper_0_sum - KSL_MUL(log_v_y_0, log_v_y_0_inverse)
          + log_upper_0_sum_lo, log_v_s);
  const double log_v_y_1 = KSL_MUL(log_upper_1_sum, log_v_s),
      log_v_y_1_lo = KSL_MUL(log_upper_1_sum - KSL_MUL(log_v_y_1, log_v_y_0_inverse)
          + log_upper_1_sum_lo, log_v_s);
  const double log_v_y_2 = KSL_MUL(log_upper_2_sum, log_v_s),
      log_v_y_2_lo = KSL_MUL(log_upper_2_sum - KSL_MUL(log_v_y_2, log_v_y_0_inverse)
          + log_upper_2_sum_lo, log_v_s);
  const double log_v_n_a = KSL_MUL(log_v_y_0, log_v_y_0), log_v_n_b = KSL_MUL(log_v_y_1, log_v_y_1),
      log_v_n_c = log_v_n_a + log_v_n_b, log_v_n_c_right = log_v_n_c - log_v_n_a,
      log_v_n_a_cross = KSL_MUL(log_v_y_0_lo, log_v_y_0) + KSL_MUL(log_v_y_0, log_v_y_0_lo),
      log_v_n_c_left_rest = ksl_product_rest(log_v_y_0, log_v_y_0, log_v_n_a, log_v_n_c
          - log_v_n_c_right),
      log_v_n_c_lo1 = log_v_n_c_left_rest
          + ksl_product_rest(log_v_y_1, log_v_y_1, log_v_n_b, log_v_n_c_right),
      log_v_n_d = KSL_MUL(log_v_y_2, log_v_y_2), log_v_n_e = log_v_n_c + log_v_n_d,
      log_v_n_e_right = log_v_n_e - log_v_n_c,
      log_v_n_e_lo1 = log_v_n_c - (log_v_n_e - log_v_n_e_right)
          + ksl_product_rest(log_v_y_2, log_v_y_2, log_v_n_d, log_v_n_e_right),
      log_v_n_c_lo = log_v_n_c_lo1
          + (log_v_n_a_cross
          + (KSL_MUL(log_v_y_1_lo, log_v_y_1) + KSL_MUL(log_v_y_1, log_v_y_1_lo))),
      log_v_n_e_lo = log_v_n_e_lo1
          + (KSL_MUL(log_v_y_2_lo, log_v_y_2) + KSL_MUL(log_v_y_2, log_v_y_2_lo)) + log_v_n_c_lo,
      log_v_n_e_sum = log_v_n_e + log_v_n_e_lo, log_v_n_e_sum_right = log_v_n_e_sum - log_v_n_e,
      log_v_n = sqrt(log_v_n_e_sum), log_v_n_product = KSL_MUL(log_v_n, log_v_n),
      log_v_n_e_sum_lo = log_v_n_e - (log_v_n_e_sum - log_v_n_e_sum_right)
          + (log_v_n_e_lo - log_v_n_e_sum_right), log_v_n_twice = log_v_n + log_v_n,
      log_v_n_residual = log_v_n_e_sum - log_v_n_product
          - ksl_product_error(log_v_n, log_v_n, log_v_n_product) + log_v_n_e_sum_lo,
      log_v_n_lo = log_v_n_residual / (log_v_n == 0.0 ? 1.0 : log_v_n_twice);
  const double log_v_r_b = log_v_s < 1.0 ? 2.6815615859885194e+154 : 1.0,
      log_v_r_d = 1.0 < log_v_s ? 7.637340908749012e-152 : log_v_r_b,
      log_v_r = 1.3093562431584567e+151 < log_v_s ? 9.332636185032189e-302 : log_v_r_d;
  const double log_v_n_sum = log_v_n + log_v_n_lo, log_v_n_sum_right = log_v_n_sum - log_v_n,
      log_n = KSL_MUL(log_v_n_sum, log_v_r),
      log_n_rest = log_v_n_sum - KSL_MUL(log_n, 1.0 / log_v_r)
          + (log_v_n - (log_v_n_sum - log_v_n_sum_right) + (log_v_n_lo - log_v_n_sum_right)),
      log_n_lo = KSL_MUL(log_n_rest, log_v_r);
  const double log_n_sum = log_n + log_n_lo, log_n_sum_right = log_n_sum - log_n,
      log_n_sum_lo = log_n - (log_n_sum - log_n_sum_right) + (log_n_lo - log_n_sum_right),
      log_upper_3_sum = log_upper_3 + log_upper_3_lo,
      log_upper_3_sum_right = log_upper_3_sum - log_upper_3,
      log_upper_3_sum_lo = log_upper_3 - (log_upper_3_sum - log_upper_3_sum_right)
          + (log_upper_3_lo - log_upper_3_sum_right),
      log_half = ksl_atan2(log_n_sum, log_upper_3_sum), log_half_size0 = fabs(log_n_sum),
      log_half_size1 = fabs(log_upper_3_sum),
      log_half_most = log_half_size0 < log_half_size1 ? log_half_size1 : log_half_size0,
      log_half_divisor = log_half_most == 0.0 ? 1.0 : log_half_most,
      log_half_part0 = log_n_sum / log_half_divisor,
      log_half_part1 = log_upper_3_sum / log_half_divisor,
      log_half_divisor2 = KSL_MUL(log_half_divisor, KSL_MUL(log_half_part1, log_half_part1)
          + KSL_MUL(log_half_part0, log_half_part0)),
      log_half_cross = KSL_MUL(log_half_part1, log_n_sum_lo)
          - KSL_MUL(log_half_part0, log_upper_3_sum_lo);
  const double log_divisor = log_n_sum == 0.0 ? 1.0 : log_n_sum,
      log_divisor_lo = log_n_sum == 0.0 ? 0.0 : log_n_sum_lo;
  const double log_theta = KSL_MUL(2.0, log_half);
  const double log_half_lo = ksl_atan2_error(log_n_sum, log_upper_3_sum, log_half) + log_half_cross
          / (log_half_most == 0.0 ? 1.0 : log_half_divisor2);
  const double log_theta_cross2 = KSL_MUL(2.0, log_half_lo);
  const double log_theta_sum = log_theta + log_theta_cross2,
      log_theta_sum_right = log_theta_sum - log_theta,
      log_theta_sum_lo = log_theta - (log_theta_sum - log_theta_sum_right)
          + (log_theta_cross2 - log_theta_sum_right),
      log_divisor_sum = log_divisor + log_divisor_lo,
      log_divisor_sum_right = log_divisor_sum - log_divisor,
      log_k = log_theta_sum / log_divisor_sum, log_k_product = KSL_MUL(log_k, log_divisor_sum),
      log_k_cross = KSL_MUL(log_k, log_divisor - (log_divisor_sum - log_divisor_sum_right)
          + (log_divisor_lo - log_divisor_sum_right)),
      log_k_residual = log_theta_sum - log_k_product
          - ksl_product_error(log_k, log_divisor_sum, log_k_product) + log_theta_sum_lo
          - log_k_cross, log_k_lo = log_k_residual / log_divisor_sum;
  const double log_vector_0 = KSL_MUL(log_upper_0_sum, log_k),
      log_vector_1 = KSL_MUL(log_upper_1_sum, log_k),
      log_vector_2 = KSL_MUL(log_upper_2_sum, log_k);
  const double log_half_angle = KSL_MUL(0.5, log_theta_sum),
      log_half_angle_cross2 = KSL_MUL(0.5, log_theta_sum_lo);
  const double log_length_a = KSL_MUL(log_n_sum, log_n_sum),
      log_length_b = KSL_MUL(log_upper_3_sum, log_upper_3_sum),
      log_length_c = log_length_a + log_length_b, log_length_c_right = log_length_c - log_length_a,
      log_length_b_cross = KSL_MUL(log_upper_3_sum_lo, log_upper_3_sum)
          + KSL_MUL(log_upper_3_sum, log_upper_3_sum_lo),
      log_length_c_left_rest = ksl_product_rest(log_n_sum, log_n_sum, log_length_a, log_length_c
          - log_length_c_right),
      log_length_c_lo1 = log_length_c_left_rest
          + ksl_product_rest(log_upper_3_sum, log_upper_3_sum, log_length_b, log_length_c_right),
      log_length_c_lo = log_length_c_lo1
          + (KSL_MUL(log_n_sum_lo, log_n_sum) + KSL_MUL(log_n_sum, log_n_sum_lo)
          + log_length_b_cross), log_length_c_sum = log_length_c + log_length_c_lo,
      log_length_c_sum_right = log_length_c_sum - log_length_c, log_length = sqrt(log_length_c_sum),
      log_length_product = KSL_MUL(log_length, log_length),
      log_length_c_sum_lo = log_length_c - (log_length_c_sum - log_length_c_sum_right)
          + (log_length_c_lo - log_length_c_sum_right), log_length_twice = log_length + log_length,
      log_length_residual = log_length_c_sum - log_length_product
          - ksl_product_error(log_length, log_length, log_length_product) + log_length_c_sum_lo,
      log_length_lo = log_length_residual / (log_length == 0.0 ? 1.0 : log_length_twice);
  const double log_length_sum = log_length + log_length_lo,
      log_length_sum_right = log_length_sum - log_length,
      log_length_sum_lo = log_length - (log_length_sum - log_length_sum_right)
          + (log_length_lo - log_length_sum_right), log_sine = log_n_sum / log_length_sum,
      log_sine_product = KSL_MUL(log_sine, log_length_sum),
      log_sine_numerator = log_n_sum - log_sine_product
          - ksl_product_error(log_sine, log_length_sum, log_sine_product) + log_n_sum_lo,
      log_sine_lo = (log_sine_numerator - KSL_MUL(log_sine, log_length_sum_lo)) / log_length_sum;
  const double log_c = log_upper_3_sum / log_length_sum,
      log_c_product = KSL_MUL(log_c, log_length_sum),
      log_c_numerator = log_upper_3_sum - log_c_product
          - ksl_product_error(log_c, log_length_sum, log_c_product) + log_upper_3_sum_lo,
      log_c_lo = (log_c_numerator - KSL_MUL(log_c, log_length_sum_lo)) / log_length_sum;
  const double log_y = KSL_MUL(log_half_angle, log_half_angle);
  const double log_half_angle_sum = log_half_angle + log_half_angle_cross2,
      log_half_angle_sum_right = log_half_angle_sum - log_half_angle,
      log_half_angle_sum_lo = log_half_angle - (log_half_angle_sum - log_half_angle_sum_right)
          + (log_half_angle_cross2 - log_half_angle_sum_right),
      log_sinc_divisor = log_half_angle_sum < 1.4901161193847656e-08 ? 1.4901161193847656e-08
          : log_half_angle_sum,
      log_sinc_divisor_lo = log_half_angle_sum < 1.4901161193847656e-08 ? 0.0
          : log_half_angle_sum_lo;
  const double log_sine_sum = log_sine + log_sine_lo, log_sine_sum_right = log_sine_sum - log_sine,
      log_sinc_divisor_sum = log_sinc_divisor + log_sinc_divisor_lo,
      log_sinc_divisor_sum_right = log_sinc_divisor_sum - log_sinc_divisor,
      log_sinc_quotient = log_sine_sum / log_sinc_divisor_sum,
      log_sinc_quotient_product = KSL_MUL(log_sinc_quotient, log_sinc_divisor_sum),
      log_sinc_quotient_product_error = ksl_product_error(log_sinc_quotient, log_sinc_divisor_sum,
          log_sinc_quotient_product),
      log_sine_sum_lo = log_sine - (log_sine_sum - log_sine_sum_right)
          + (log_sine_lo - log_sine_sum_right),
      log_sinc_divisor_sum_lo = log_sinc_divisor
          - (log_sinc_divisor_sum - log_sinc_divisor_sum_right)
          + (log_sinc_divisor_lo - log_sinc_divisor_sum_right),
      log_sinc_quotient_numerator = log_sine_sum - log_sinc_quotient_product
          - log_sinc_quotient_product_error + log_sine_sum_lo,
      log_sinc_quotient_lo = (log_sinc_quotient_numerator
          - KSL_MUL(log_sinc_quotient, log_sinc_divisor_sum_lo)) / log_sinc_divisor_sum;
  const double log_y_cross = KSL_MUL(log_half_angle_cross2, log_half_angle)
          + KSL_MUL(log_half_angle, log_half_angle_cross2);
  const double log_y_lo = ksl_product_error(log_half_angle, log_half_angle, log_y) + log_y_cross,
      log_sinc_a = KSL_MUL(0.16666666666666666, log_y), log_sinc_b = 1.0 - log_sinc_a,
      log_sinc_b_right = 1.0 - log_sinc_b,
      log_sinc_b_lo1 = 1.0 - (log_sinc_b + log_sinc_b_right)
          - ksl_product_rest(0.16666666666666666, log_y, log_sinc_a, log_sinc_b_right),
      log_sinc_b_lo = log_sinc_b_lo1
          - (KSL_MUL(9.25185853854297e-18, log_y) + KSL_MUL(0.16666666666666666, log_y_lo)),
      log_sinc = log_half_angle_sum < 1.4901161193847656e-08 ? log_sinc_b : log_sinc_quotient,
      log_sinc_lo = log_half_angle_sum < 1.4901161193847656e-08 ? log_sinc_b_lo
          : log_sinc_quotient_lo;
  const double log_series_phi_a = KSL_MUL(5.107725174524775e-32, log_y),
      log_series_phi_b = 4.116826490666969e-29 - log_series_phi_a,
      log_series_phi_b_right = 4.116826490666969e-29 - log_series_phi_b,
      log_series_phi_b_right_rest = ksl_product_rest(5.107725174524775e-32, log_y, log_series_phi_a,
          log_series_phi_b_right),
      log_series_phi_b_lo1 = 4.116826490666969e-29 - (log_series_phi_b + log_series_phi_b_right)
          - log_series_phi_b_right_rest,
      log_series_phi_b_lo2 = log_series_phi_b_lo1
          - (KSL_MUL(4.7410392187559056e-48, log_y) + KSL_MUL(5.107725174524775e-32, log_y_lo)),
      log_series_phi_c = KSL_MUL(log_y, log_series_phi_b),
      log_series_phi_d = log_series_phi_c - 2.86531123750421e-26,
      log_series_phi_d_right = log_series_phi_c - log_series_phi_d,
      log_series_phi_d_left_rest = ksl_product_rest(log_y, log_series_phi_b, log_series_phi_c,
          log_series_phi_d + log_series_phi_d_right),
      log_series_phi_d_lo2 = log_series_phi_d_left_rest
          - (2.86531123750421e-26 - log_series_phi_d_right) - 2.3296034284323186e-42,
      log_series_phi_e = KSL_MUL(log_y, log_series_phi_d),
      log_series_phi_d_lo = log_series_phi_d_lo2
          + (KSL_MUL(log_y_lo, log_series_phi_b)
          + KSL_MUL(log_y, log_series_phi_b_lo2 + -1.8714974010023092e-45)),
      log_series_phi_f = log_series_phi_e + 1.701994875077501e-23,
      log_series_phi_f_right = log_series_phi_f - log_series_phi_e,
      log_series_phi_f_left_rest = ksl_product_rest(log_y, log_series_phi_d, log_series_phi_e,
          log_series_phi_f - log_series_phi_f_right),
      log_series_phi_f_lo2 = log_series_phi_f_left_rest
          + (1.701994875077501e-23 - log_series_phi_f_right) + 3.161967936521494e-40,
      log_series_phi_g = KSL_MUL(log_y, log_series_phi_f),
      log_series_phi_g_cross2 = KSL_MUL(log_y, log_series_phi_f_lo2
          + (KSL_MUL(log_y_lo, log_series_phi_d) + KSL_MUL(log_y, log_series_phi_d_lo))),
      log_series_phi_h = log_series_phi_g - 8.509974375387505e-21,
      log_series_phi_h_right = log_series_phi_g - log_series_phi_h,
      log_series_phi_h_left_rest = ksl_product_rest(log_y, log_series_phi_f, log_series_phi_g,
          log_series_phi_h + log_series_phi_h_right),
      log_series_phi_h_lo2 = log_series_phi_h_left_rest
          - (8.509974375387505e-21 - log_series_phi_h_right) - 3.2266760594119493e-37,
      log_series_phi_i = KSL_MUL(log_y, log_series_phi_h),
      log_series_phi_i_cross2 = KSL_MUL(log_y, log_series_phi_h_lo2
          + (KSL_MUL(log_y_lo, log_series_phi_f) + log_series_phi_g_cross2)),
      log_series_phi_j = log_series_phi_i + 3.523129391410427e-18,
      log_series_phi_j_right = log_series_phi_j - log_series_phi_i,
      log_series_phi_j_left_rest = ksl_product_rest(log_y, log_series_phi_h, log_series_phi_i,
          log_series_phi_j - log_series_phi_j_right),
      log_series_phi_j_lo2 = log_series_phi_j_left_rest
          + (3.523129391410427e-18 - log_series_phi_j_right) + -1.2521244741738012e-34,
      log_series_phi_k = KSL_MUL(log_y, log_series_phi_j),
      log_series_phi_k_cross2 = KSL_MUL(log_y, log_series_phi_j_lo2
          + (KSL_MUL(log_y_lo, log_series_phi_h) + log_series_phi_i_cross2)),
      log_series_phi_l = log_series_phi_k - 1.1837714755139035e-15,
      log_series_phi_l_right = log_series_phi_k - log_series_phi_l,
      log_series_phi_l_left_rest = ksl_product_rest(log_y, log_series_phi_j, log_series_phi_k,
          log_series_phi_l + log_series_phi_l_right),
      log_series_phi_l_lo2 = log_series_phi_l_left_rest
          - (1.1837714755139035e-15 - log_series_phi_l_right) - 7.23242424407352e-33,
      log_series_phi_m = KSL_MUL(log_y, log_series_phi_l),
      log_series_phi_m_cross2 = KSL_MUL(log_y, log_series_phi_l_lo2
          + (KSL_MUL(log_y_lo, log_series_phi_j) + log_series_phi_k_cross2)),
      log_series_phi_n = log_series_phi_m + 3.148832124866983e-13,
      log_series_phi_n_right = log_series_phi_n - log_series_phi_m,
      log_series_phi_n_left_rest = ksl_product_rest(log_y, log_series_phi_l, log_series_phi_m,
          log_series_phi_n - log_series_phi_n_right),
      log_series_phi_n_lo2 = log_series_phi_n_left_rest
          + (3.148832124866983e-13 - log_series_phi_n_right) + 5.8681293750286156e-30,
      log_series_phi_o = KSL_MUL(log_y, log_series_phi_n),
      log_series_phi_o_cross2 = KSL_MUL(log_y, log_series_phi_n_lo2
          + (KSL_MUL(log_y_lo, log_series_phi_l) + log_series_phi_m_cross2)),
      log_series_phi_p = log_series_phi_o - 6.423617534728645e-11,
      log_series_phi_p_right = log_series_phi_o - log_series_phi_p,
      log_series_phi_p_left_rest = ksl_product_rest(log_y, log_series_phi_n, log_series_phi_o,
          log_series_phi_p + log_series_phi_p_right),
      log_series_phi_p_lo2 = log_series_phi_p_left_rest
          - (6.423617534728645e-11 - log_series_phi_p_right) - 5.034117835500839e-27,
      log_series_phi_q = KSL_MUL(log_y, log_series_phi_p),
      log_series_phi_q_cross2 = KSL_MUL(log_y, log_series_phi_p_lo2
          + (KSL_MUL(log_y_lo, log_series_phi_n) + log_series_phi_o_cross2)),
      log_series_phi_r = log_series_phi_q + 9.635426302092969e-09,
      log_series_phi_r_right = log_series_phi_r - log_series_phi_q,
      log_series_phi_r_left_rest = ksl_product_rest(log_y, log_series_phi_p, log_series_phi_q,
          log_series_phi_r - log_series_phi_r_right),
      log_series_phi_r_lo2 = log_series_phi_r_left_rest
          + (9.635426302092969e-09 - log_series_phi_r_right) + -1.7546051379703029e-25,
      log_series_phi_s = KSL_MUL(log_y, log_series_phi_r),
      log_series_phi_s_cross2 = KSL_MUL(log_y, log_series_phi_r_lo2
          + (KSL_MUL(log_y_lo, log_series_phi_p) + log_series_phi_q_cross2)),
      log_series_phi_t = log_series_phi_s - 1.0020843354176687e-06,
      log_series_phi_t_right = log_series_phi_s - log_series_phi_t,
      log_series_phi_t_left_rest = ksl_product_rest(log_y, log_series_phi_r, log_series_phi_s,
          log_series_phi_t + log_series_phi_t_right),
      log_series_phi_t_lo2 = log_series_phi_t_left_rest
          - (1.0020843354176687e-06 - log_series_phi_t_right) - 4.7926555569351065e-23,
      log_series_phi_u = KSL_MUL(log_y, log_series_phi_t),
      log_series_phi_u_cross2 = KSL_MUL(log_y, log_series_phi_t_lo2
          + (KSL_MUL(log_y_lo, log_series_phi_r) + log_series_phi_s_cross2)),
      log_series_phi_v = log_series_phi_u + 6.613756613756614e-05,
      log_series_phi_v_right = log_series_phi_v - log_series_phi_u,
      log_series_phi_v_left_rest = ksl_product_rest(log_y, log_series_phi_t, log_series_phi_u,
          log_series_phi_v - log_series_phi_v_right),
      log_series_phi_v_lo2 = log_series_phi_v_left_rest
          + (6.613756613756614e-05 - log_series_phi_v_right) + -4.460143857711533e-21,
      log_series_phi_w = KSL_MUL(log_y, log_series_phi_v),
      log_series_phi_w_cross2 = KSL_MUL(log_y, log_series_phi_v_lo2
          + (KSL_MUL(log_y_lo, log_series_phi_t) + log_series_phi_u_cross2)),
      log_series_phi_x = log_series_phi_w - 0.002380952380952381,
      log_series_phi_x_right = log_series_phi_w - log_series_phi_x,
      log_series_phi_x_left_rest = ksl_product_rest(log_y, log_series_phi_v, log_series_phi_w,
          log_series_phi_x + log_series_phi_x_right),
      log_series_phi_x_lo2 = log_series_phi_x_left_rest
          - (0.002380952380952381 - log_series_phi_x_right) - -2.147752875018904e-19,
      log_series_phi_y = KSL_MUL(log_y, log_series_phi_x),
      log_series_phi_y_cross2 = KSL_MUL(log_y, log_series_phi_x_lo2
          + (KSL_MUL(log_y_lo, log_series_phi_v) + log_series_phi_w_cross2)),
      log_series_phi = log_series_phi_y + 0.03333333333333333,
      log_series_phi_right = log_series_phi - log_series_phi_y,
      log_series_phi_left_rest = ksl_product_rest(log_y, log_series_phi_x, log_series_phi_y,
          log_series_phi - log_series_phi_right),
      log_series_phi_lo2 = log_series_phi_left_rest + (0.03333333333333333 - log_series_phi_right)
          + 4.625929269271486e-19;
  const double log_f_more_a = KSL_MUL(2.0, log_y),
      log_f_more = KSL_MUL(log_f_more_a, log_series_phi),
      log_f_more_cross2 = KSL_MUL(log_f_more_a, log_series_phi_lo2
          + (KSL_MUL(log_y_lo, log_series_phi_x) + log_series_phi_y_cross2));
  const double log_near_f_a = KSL_MUL(0.3333333333333333, log_sinc),
      log_near_f_b = KSL_MUL(0.3333333333333333, log_f_more),
      log_f_more_lo = ksl_product_error(log_f_more_a, log_series_phi, log_f_more)
          + (KSL_MUL(KSL_MUL(2.0, log_y_lo), log_series_phi) + log_f_more_cross2),
      log_near_f = log_near_f_a + log_near_f_b, log_near_f_right = log_near_f - log_near_f_a,
      log_near_f_b_cross = KSL_MUL(1.850371707708594e-17, log_f_more)
          + KSL_MUL(0.3333333333333333, log_f_more_lo),
      log_near_f_left_rest = ksl_product_rest(0.3333333333333333, log_sinc, log_near_f_a, log_near_f
          - log_near_f_right),
      log_near_f_cross = KSL_MUL(1.850371707708594e-17, log_sinc)
          + KSL_MUL(0.3333333333333333, log_sinc_lo) + log_near_f_b_cross,
      log_near_f_lo = log_near_f_left_rest
          + ksl_product_rest(0.3333333333333333, log_f_more, log_near_f_b, log_near_f_right)
          + log_near_f_cross;
  const double log_f_rest = log_sinc - log_c, log_f_rest_right = log_sinc - log_f_rest,
      log_f_rest_lo = log_sinc - (log_f_rest + log_f_rest_right) - (log_c - log_f_rest_right)
          - log_c_lo + log_sinc_lo;
  const double log_x = KSL_MUL(4.0, log_y);
  const double log_x_sum = log_x + KSL_MUL(4.0, log_y_lo),
      log_far_y = log_x_sum < 4.0 ? 1.0 : log_y, log_far_y_lo = log_x_sum < 4.0 ? 0.0 : log_y_lo;
  const double log_f_rest_sum = log_f_rest + log_f_rest_lo,
      log_f_rest_sum_right = log_f_rest_sum - log_f_rest, log_far_y_sum = log_far_y + log_far_y_lo,
      log_far_y_sum_right = log_far_y_sum - log_far_y,
      log_closed_f = log_f_rest_sum / log_far_y_sum,
      log_closed_f_product = KSL_MUL(log_closed_f, log_far_y_sum),
      log_closed_f_exact = log_f_rest_sum - log_closed_f_product
          - ksl_product_error(log_closed_f, log_far_y_sum, log_closed_f_product),
      log_closed_f_numerator = log_closed_f_exact
          + (log_f_rest - (log_f_rest_sum - log_f_rest_sum_right)
          + (log_f_rest_lo - log_f_rest_sum_right)),
      log_closed_f_cross = KSL_MUL(log_closed_f, log_far_y - (log_far_y_sum - log_far_y_sum_right)
          + (log_far_y_lo - log_far_y_sum_right)),
      log_closed_f_lo = (log_closed_f_numerator - log_closed_f_cross) / log_far_y_sum;
  const double log_f = log_x_sum < 4.0 ? log_near_f : log_closed_f,
      log_f_lo = log_x_sum < 4.0 ? log_near_f_lo : log_closed_f_lo;
  const double log_four_k = KSL_MUL(4.0, log_sinc), log_four_k_cross2 = KSL_MUL(4.0, log_sinc_lo);
  const double log_f_sum = log_f + log_f_lo, log_f_sum_right = log_f_sum - log_f,
      log_four_k_sum = log_four_k + log_four_k_cross2,
      log_four_k_sum_right = log_four_k_sum - log_four_k, log_b = log_f_sum / log_four_k_sum,
      log_b_product = KSL_MUL(log_b, log_four_k_sum),
      log_b_exact = log_f_sum - log_b_product
          - ksl_product_error(log_b, log_four_k_sum, log_b_product),
      log_b_cross = KSL_MUL(log_b, log_four_k - (log_four_k_sum - log_four_k_sum_right)
          + (log_four_k_cross2 - log_four_k_sum_right));
  const double log_c_sum = log_c + log_c_lo, log_c_sum_right = log_c_sum - log_c,
      log_sinc_sum = log_sinc + log_sinc_lo, log_sinc_sum_right = log_sinc_sum - log_sinc,
      log_b_across = log_c_sum / log_sinc_sum,
      log_b_across_product = KSL_MUL(log_b_across, log_sinc_sum),
      log_b_across_exact = log_c_sum - log_b_across_product
          - ksl_product_error(log_b_across, log_sinc_sum, log_b_across_product),
      log_b_across_cross = KSL_MUL(log_b_across, log_sinc - (log_sinc_sum - log_sinc_sum_right)
          + (log_sinc_lo - log_sinc_sum_right)),
      log_b_across_lo = (log_b_across_exact
          + (log_c - (log_c_sum - log_c_sum_right) + (log_c_lo - log_c_sum_right))
          - log_b_across_cross) / log_sinc_sum;
  const double log_vector_0_lo = ksl_product_error(log_upper_0_sum, log_k, log_vector_0)
          + (KSL_MUL(log_upper_0_sum_lo, log_k) + KSL_MUL(log_upper_0_sum, log_k_lo)),
      log_wt_a = KSL_MUL(between_3, log_vector_0),
      log_vector_1_lo = ksl_product_error(log_upper_1_sum, log_k, log_vector_1)
          + (KSL_MUL(log_upper_1_sum_lo, log_k) + KSL_MUL(log_upper_1_sum, log_k_lo)),
      log_wt_b = KSL_MUL(between_7, log_vector_1), log_wt_c = log_wt_a + log_wt_b,
      log_wt_c_right = log_wt_c - log_wt_a,
      log_wt_a_cross = KSL_MUL(between_3_lo, log_vector_0) + KSL_MUL(between_3, log_vector_0_lo),
      log_wt_c_left_rest = ksl_product_rest(between_3, log_vector_0, log_wt_a, log_wt_c
          - log_wt_c_right),
      log_wt_c_cross = log_wt_a_cross
          + (KSL_MUL(between_7_lo, log_vector_1) + KSL_MUL(between_7, log_vector_1_lo)),
      log_vector_2_lo = ksl_product_error(log_upper_2_sum, log_k, log_vector_2)
          + (KSL_MUL(log_upper_2_sum_lo, log_k) + KSL_MUL(log_upper_2_sum, log_k_lo)),
      log_wt_d = KSL_MUL(between_11, log_vector_2), log_wt = log_wt_c + log_wt_d,
      log_wt_right = log_wt - log_wt_c,
      log_wt_lo1 = log_wt_c - (log_wt - log_wt_right)
          + ksl_product_rest(between_11, log_vector_2, log_wt_d, log_wt_right),
      log_wt_c_lo = log_wt_c_left_rest
          + ksl_product_rest(between_7, log_vector_1, log_wt_b, log_wt_c_right) + log_wt_c_cross;
  const double log_pitch = KSL_MUL(log_b, log_wt);
  const double log_b_lo = (log_b_exact
          + (log_f - (log_f_sum - log_f_sum_right) + (log_f_lo - log_f_sum_right)) - log_b_cross)
          / log_four_k_sum;
  const double log_pitch_cross2 = KSL_MUL(log_b, log_wt_lo1
          + (KSL_MUL(between_11_lo, log_vector_2) + KSL_MUL(between_11, log_vector_2_lo))
          + log_wt_c_lo);
  const double log_pitch_lo = ksl_product_error(log_b, log_wt, log_pitch)
          + (KSL_MUL(log_b_lo, log_wt) + log_pitch_cross2),
      log_along_0 = KSL_MUL(log_vector_0, log_pitch);
  const double log_along_1 = KSL_MUL(log_vector_1, log_pitch),
      log_along_2 = KSL_MUL(log_vector_2, log_pitch);
  const double log_u_0a = KSL_MUL(between_11, log_vector_1),
      log_u_0b = KSL_MUL(between_7, log_vector_2), log_u_0 = log_u_0a - log_u_0b,
      log_u_0_right = log_u_0a - log_u_0,
      log_u_0a_cross = KSL_MUL(between_11_lo, log_vector_1) + KSL_MUL(between_11, log_vector_1_lo),
      log_u_0_left_rest = ksl_product_rest(between_11, log_vector_1, log_u_0a, log_u_0
          + log_u_0_right),
      log_u_0_cross = log_u_0a_cross
          - (KSL_MUL(between_7_lo, log_vector_2) + KSL_MUL(between_7, log_vector_2_lo));
  const double log_u_1a = KSL_MUL(between_3, log_vector_2),
      log_u_1b = KSL_MUL(between_11, log_vector_0), log_u_1 = log_u_1a - log_u_1b,
      log_u_1_right = log_u_1a - log_u_1,
      log_u_1b_cross = KSL_MUL(between_11_lo, log_vector_0) + KSL_MUL(between_11, log_vector_0_lo),
      log_u_1_left_rest = ksl_product_rest(between_3, log_vector_2, log_u_1a, log_u_1
          + log_u_1_right),
      log_u_1_cross = KSL_MUL(between_3_lo, log_vector_2) + KSL_MUL(between_3, log_vector_2_lo)
          - log_u_1b_cross;
  const double log_u_2a = KSL_MUL(between_7, log_vector_0),
      log_u_2b = KSL_MUL(between_3, log_vector_1), log_u_2 = log_u_2a - log_u_2b,
      log_u_2_right = log_u_2a - log_u_2,
      log_u_2a_cross = KSL_MUL(between_7_lo, log_vector_0) + KSL_MUL(between_7, log_vector_0_lo),
      log_u_2_left_rest = ksl_product_rest(between_7, log_vector_0, log_u_2a, log_u_2
          + log_u_2_right),
      log_u_2_cross = log_u_2a_cross
          - (KSL_MUL(between_3_lo, log_vector_1) + KSL_MUL(between_3, log_vector_1_lo));
  const double log_turned_0 = KSL_MUL(0.5, log_u_0);
  const double log_turned_1 = KSL_MUL(0.5, log_u_1);
  const double log_turned_2 = KSL_MUL(0.5, log_u_2);
  const double log_across_axis_0 = log_along_0 - log_turned_0,
      log_across_axis_0_right = log_along_0 - log_across_axis_0,
      log_across_axis_0_left_rest = ksl_product_rest(log_vector_0, log_pitch, log_along_0,
          log_across_axis_0 + log_across_axis_0_right);
  const double log_turned_0_cross2 = KSL_MUL(0.5, log_u_0_left_rest
          - ksl_product_rest(between_7, log_vector_2, log_u_0b, log_u_0_right) + log_u_0_cross);
  const double log_across_axis_0_lo2 = log_across_axis_0_left_rest
          - (log_turned_0 - log_across_axis_0_right) - log_turned_0_cross2;
  const double log_across_axis_1 = log_along_1 - log_turned_1,
      log_across_axis_1_right = log_along_1 - log_across_axis_1,
      log_across_axis_1_left_rest = ksl_product_rest(log_vector_1, log_pitch, log_along_1,
          log_across_axis_1 + log_across_axis_1_right);
  const double log_turned_1_cross2 = KSL_MUL(0.5, log_u_1_left_rest
          - ksl_product_rest(between_11, log_vector_0, log_u_1b, log_u_1_right) + log_u_1_cross);
  const double log_across_axis_1_lo2 = log_across_axis_1_left_rest
          - (log_turned_1 - log_across_axis_1_right) - log_turned_1_cross2;
  const double log_across_axis_2 = log_along_2 - log_turned_2,
      log_across_axis_2_right = log_along_2 - log_across_axis_2,
      log_across_axis_2_left_rest = ksl_product_rest(log_vector_2, log_pitch, log_along_2,
          log_across_axis_2 + log_across_axis_2_right);
  const double log_turned_2_cross2 = KSL_MUL(0.5, log_u_2_left_rest
          - ksl_product_rest(between_3, log_vector_1, log_u_2b, log_u_2_right) + log_u_2_cross);
  const double log_across_axis_2_lo2 = log_across_axis_2_left_rest
          - (log_turned_2 - log_across_axis_2_right) - log_turned_2_cross2;
  const double whole_0a = KSL_MUL(between_3, log_b_across), whole_0 = whole_0a + log_across_axis_0,
      whole_0_right = whole_0 - whole_0a,
      whole_0_lo1 = ksl_product_rest(between_3, log_b_across, whole_0a, whole_0 - whole_0_right)
          + (log_across_axis_0 - whole_0_right),
      whole_0_lo2 = whole_0_lo1
          + (log_across_axis_0_lo2
          + (KSL_MUL(log_vector_0_lo, log_pitch) + KSL_MUL(log_vector_0, log_pitch_lo)));
  const double whole_1a = KSL_MUL(between_7, log_b_across), whole_1 = whole_1a + log_across_axis_1,
      whole_1_right = whole_1 - whole_1a,
      whole_1_lo1 = ksl_product_rest(between_7, log_b_across, whole_1a, whole_1 - whole_1_right)
          + (log_across_axis_1 - whole_1_right),
      whole_1_lo2 = whole_1_lo1
          + (log_across_axis_1_lo2
          + (KSL_MUL(log_vector_1_lo, log_pitch) + KSL_MUL(log_vector_1, log_pitch_lo)));
  const double whole_2a = KSL_MUL(between_11, log_b_across), whole_2 = whole_2a + log_across_axis_2,
      whole_2_right = whole_2 - whole_2a,
      whole_2_lo1 = ksl_product_rest(between_11, log_b_across, whole_2a, whole_2 - whole_2_right)
          + (log_across_axis_2 - whole_2_right),
      whole_2_lo2 = whole_2_lo1
          + (log_across_axis_2_lo2
          + (KSL_MUL(log_vector_2_lo, log_pitch) + KSL_MUL(log_vector_2, log_pitch_lo)));
  const double screw_0 = KSL_MUL(k, whole_0);
  const double screw_1 = KSL_MUL(k, whole_1);
  const double screw_2 = KSL_MUL(k, whole_2);
  const double screw_3 = KSL_MUL(k, log_vector_0), screw_4 = KSL_MUL(k, log_vector_1),
      screw_5 = KSL_MUL(k, log_vector_2);
  const double screw_3_lo = ksl_product_error(k, log_vector_0, screw_3)
          + KSL_MUL(k, log_vector_0_lo), exp_halved_0 = KSL_MUL(0.5, screw_3),
      exp_halved_0_cross2 = KSL_MUL(0.5, screw_3_lo);
  const double screw_4_lo = ksl_product_error(k, log_vector_1, screw_4)
          + KSL_MUL(k, log_vector_1_lo), exp_halved_1 = KSL_MUL(0.5, screw_4),
      exp_halved_1_cross2 = KSL_MUL(0.5, screw_4_lo);
  const double screw_5_lo = ksl_product_error(k, log_vector_2, screw_5)
          + KSL_MUL(k, log_vector_2_lo), exp_halved_2 = KSL_MUL(0.5, screw_5),
      exp_halved_2_cross2 = KSL_MUL(0.5, screw_5_lo);
  const double exp_y_a = KSL_MUL(exp_halved_0, exp_halved_0),
      exp_y_b = KSL_MUL(exp_halved_1, exp_halved_1), exp_y_c = exp_y_a + exp_y_b,
      exp_y_c_right = exp_y_c - exp_y_a,
      exp_y_a_cross = KSL_MUL(exp_halved_0_cross2, exp_halved_0)
          + KSL_MUL(exp_halved_0, exp_halved_0_cross2),
      exp_y_c_left_rest = ksl_product_rest(exp_halved_0, exp_halved_0, exp_y_a, exp_y_c
          - exp_y_c_right),
      exp_y_c_cross = exp_y_a_cross
          + (KSL_MUL(exp_halved_1_cross2, exp_halved_1)
          + KSL_MUL(exp_halved_1, exp_halved_1_cross2)),
      exp_y_d = KSL_MUL(exp_halved_2, exp_halved_2), exp_y = exp_y_c + exp_y_d,
      exp_y_right = exp_y - exp_y_c,
      exp_y_lo1 = exp_y_c - (exp_y - exp_y_right)
          + ksl_product_rest(exp_halved_2, exp_halved_2, exp_y_d, exp_y_right),
      exp_y_c_lo = exp_y_c_left_rest
          + ksl_product_rest(exp_halved_1, exp_halved_1, exp_y_b, exp_y_c_right) + exp_y_c_cross,
      exp_y_lo = exp_y_lo1
          + (KSL_MUL(exp_halved_2_cross2, exp_halved_2)
          + KSL_MUL(exp_halved_2, exp_halved_2_cross2)) + exp_y_c_lo;
  const double exp_y_sum = exp_y + exp_y_lo, exp_y_sum_right = exp_y_sum - exp_y,
      exp_y_sum_lo = exp_y - (exp_y_sum - exp_y_sum_right) + (exp_y_lo - exp_y_sum_right),
      exp_half_angle = sqrt(exp_y_sum),
      exp_half_angle_product = KSL_MUL(exp_half_angle, exp_half_angle),
      exp_half_angle_exact = exp_y_sum - exp_half_angle_product
          - ksl_product_error(exp_half_angle, exp_half_angle, exp_half_angle_product),
      exp_half_angle_twice = exp_half_angle + exp_half_angle,
      exp_half_angle_lo = (exp_half_angle_exact + exp_y_sum_lo)
          / (exp_half_angle == 0.0 ? 1.0 : exp_half_angle_twice);
  const double exp_half_angle_sum = exp_half_angle + exp_half_angle_lo,
      exp_half_angle_sum_right = exp_half_angle_sum - exp_half_angle,
      exp_half_angle_sum_lo = exp_half_angle - (exp_half_angle_sum - exp_half_angle_sum_right)
          + (exp_half_angle_lo - exp_half_angle_sum_right);
  double exp_c; const double exp_sine = ksl_sincos(exp_half_angle_sum, &exp_c);
  double exp_c_own_error; const double exp_sine_own_error = ksl_sincos_error(exp_half_angle_sum,
      exp_sine, exp_c, &exp_c_own_error);
  const double exp_sine_half = KSL_MUL(exp_half_angle_sum_lo, 0.5);
  double exp_sine_half_cos; const double exp_sine_half_sin = ksl_sincos(exp_sine_half,
      &exp_sine_half_cos);
  const double exp_sine_twice = exp_sine_half_sin + exp_sine_half_sin,
      exp_sine_lo = exp_sine_own_error
          + KSL_MUL(KSL_MUL(exp_sine_half_cos, exp_c)
          - KSL_MUL(exp_sine_half_sin, exp_sine), exp_sine_twice);
  const double exp_sinc_divisor = exp_half_angle_sum < 1.4901161193847656e-08
          ? 1.4901161193847656e-08 : exp_half_angle_sum,
      exp_sinc_divisor_lo = exp_half_angle_sum < 1.4901161193847656e-08 ? 0.0
          : exp_half_angle_sum_lo;
  const double exp_sine_sum = exp_sine + exp_sine_lo, exp_sine_sum_right = exp_sine_sum - exp_sine,
      exp_sine_sum_lo = exp_sine - (exp_sine_sum - exp_sine_sum_right)
          + (exp_sine_lo - exp_sine_sum_right),
      exp_sinc_divisor_sum = exp_sinc_divisor + exp_sinc_divisor_lo,
      exp_sinc_divisor_sum_right = exp_sinc_divisor_sum - exp_sinc_divisor,
      exp_sinc_quotient = exp_sine_sum / exp_sinc_divisor_sum,
      exp_sinc_quotient_product = KSL_MUL(exp_sinc_quotient, exp_sinc_divisor_sum),
      exp_sinc_quotient_product_error = ksl_product_error(exp_sinc_quotient, exp_sinc_divisor_sum,
          exp_sinc_quotient_product),
      exp_sinc_divisor_sum_lo = exp_sinc_divisor
          - (exp_sinc_divisor_sum - exp_sinc_divisor_sum_right)
          + (exp_sinc_divisor_lo - exp_sinc_divisor_sum_right),
      exp_sinc_quotient_numerator = exp_sine_sum - exp_sinc_quotient_product
          - exp_sinc_quotient_product_error + exp_sine_sum_lo,
      exp_sinc_quotient_lo = (exp_sinc_quotient_numerator
          - KSL_MUL(exp_sinc_quotient, exp_sinc_divisor_sum_lo)) / exp_sinc_divisor_sum;
  const double exp_sinc_a = KSL_MUL(0.16666666666666666, exp_y_sum), exp_sinc_b = 1.0 - exp_sinc_a,
      exp_sinc_b_right = 1.0 - exp_sinc_b,
      exp_sinc_b_lo1 = 1.0 - (exp_sinc_b + exp_sinc_b_right)
          - ksl_product_rest(0.16666666666666666, exp_y_sum, exp_sinc_a, exp_sinc_b_right),
      exp_sinc_b_lo = exp_sinc_b_lo1
          - (KSL_MUL(9.25185853854297e-18, exp_y_sum) + KSL_MUL(0.16666666666666666, exp_y_sum_lo)),
      exp_sinc = exp_half_angle_sum < 1.4901161193847656e-08 ? exp_sinc_b : exp_sinc_quotient,
      exp_sinc_lo = exp_half_angle_sum < 1.4901161193847656e-08 ? exp_sinc_b_lo
          : exp_sinc_quotient_lo;
  const double exp_g1 = KSL_MUL(exp_c, exp_sinc),
      exp_g1_cross1 = KSL_MUL(exp_c_own_error
          - KSL_MUL(KSL_MUL(exp_sine_half_cos, exp_sine)
          + KSL_MUL(exp_sine_half_sin, exp_c), exp_sine_twice), exp_sinc),
      exp_g1_cross = exp_g1_cross1 + KSL_MUL(exp_c, exp_sinc_lo);
  const double exp_g2a = KSL_MUL(exp_sinc, exp_sinc), exp_g2 = KSL_MUL(0.5, exp_g2a),
      exp_g2_cross2 = KSL_MUL(0.5, ksl_product_error(exp_sinc, exp_sinc, exp_g2a)
          + (KSL_MUL(exp_sinc_lo, exp_sinc) + KSL_MUL(exp_sinc, exp_sinc_lo)));
  const double exp_sine_square = KSL_MUL(exp_sine_sum, exp_sine_sum),
      exp_sine_square_cross = KSL_MUL(exp_sine_sum_lo, exp_sine_sum)
          + KSL_MUL(exp_sine_sum, exp_sine_sum_lo);
  const double exp_g0a = KSL_MUL(2.0, exp_sine_square), exp_g0 = 1.0 - exp_g0a,
      exp_g0_right = 1.0 - exp_g0,
      exp_g0a_cross2 = KSL_MUL(2.0, ksl_product_error(exp_sine_sum, exp_sine_sum, exp_sine_square)
          + exp_sine_square_cross),
      exp_g0_lo = 1.0 - (exp_g0 + exp_g0_right) - (exp_g0a - exp_g0_right) - exp_g0a_cross2;
  const double exp_rest3 = 1.0 - exp_g1, exp_rest3_right = 1.0 - exp_rest3,
      exp_rest3_lo = 1.0 - (exp_rest3 + exp_rest3_right)
          - ksl_product_rest(exp_c, exp_sinc, exp_g1, exp_rest3_right) - exp_g1_cross;
  const double exp_x = KSL_MUL(4.0, exp_y_sum), exp_x_cross2 = KSL_MUL(4.0, exp_y_sum_lo);
  const double exp_x_sum = exp_x + exp_x_cross2, exp_x_sum_right = exp_x_sum - exp_x,
      exp_x_sum_lo = exp_x - (exp_x_sum - exp_x_sum_right) + (exp_x_cross2 - exp_x_sum_right),
      exp_far_x = exp_x_sum < 1.0 ? 1.0 : exp_x_sum,
      exp_far_x_lo = exp_x_sum < 1.0 ? 0.0 : exp_x_sum_lo;
  const double exp_rest3_sum = exp_rest3 + exp_rest3_lo,
      exp_rest3_sum_right = exp_rest3_sum - exp_rest3, exp_far_x_sum = exp_far_x + exp_far_x_lo,
      exp_far_x_sum_right = exp_far_x_sum - exp_far_x, exp_closed3 = exp_rest3_sum / exp_far_x_sum,
      exp_closed3_product = KSL_MUL(exp_closed3, exp_far_x_sum),
      exp_closed3_exact = exp_rest3_sum - exp_closed3_product
          - ksl_product_error(exp_closed3, exp_far_x_sum, exp_closed3_product),
      exp_closed3_numerator = exp_closed3_exact
          + (exp_rest3 - (exp_rest3_sum - exp_rest3_sum_right)
          + (exp_rest3_lo - exp_rest3_sum_right)),
      exp_closed3_cross = KSL_MUL(exp_closed3, exp_far_x - (exp_far_x_sum - exp_far_x_sum_right)
          + (exp_far_x_lo - exp_far_x_sum_right)),
      exp_closed3_lo = (exp_closed3_numerator - exp_closed3_cross) / exp_far_x_sum;
  const double exp_series5a = KSL_MUL(1.216125041553518e-34, exp_x_sum),
      exp_series5b = 1.1309962886447716e-31 - exp_series5a,
      exp_series5b_right = 1.1309962886447716e-31 - exp_series5b,
      exp_series5b_right_rest = ksl_product_rest(1.216125041553518e-34, exp_x_sum, exp_series5a,
          exp_series5b_right),
      exp_series5a_cross = KSL_MUL(5.586290567888806e-51, exp_x_sum)
          + KSL_MUL(1.216125041553518e-34, exp_x_sum_lo),
      exp_series5c = KSL_MUL(exp_x_sum, exp_series5b),
      exp_series5b_lo = 1.1309962886447716e-31 - (exp_series5b + exp_series5b_right)
          - exp_series5b_right_rest - exp_series5a_cross + 1.0498015412959506e-47,
      exp_series5d = exp_series5c - 9.183689863795546e-29,
      exp_series5d_right = exp_series5c - exp_series5d,
      exp_series5d_left_rest = ksl_product_rest(exp_x_sum, exp_series5b, exp_series5c, exp_series5d
          + exp_series5d_right),
      exp_series5d_lo2 = exp_series5d_left_rest - (9.183689863795546e-29 - exp_series5d_right)
          - 1.4303150396787322e-45, exp_series5e = KSL_MUL(exp_x_sum, exp_series5d),
      exp_series5e_cross2 = KSL_MUL(exp_x_sum, exp_series5d_lo2
          + (KSL_MUL(exp_x_sum_lo, exp_series5b) + KSL_MUL(exp_x_sum, exp_series5b_lo))),
      exp_series5f = exp_series5e + 6.446950284384474e-26,
      exp_series5f_right = exp_series5f - exp_series5e,
      exp_series5f_left_rest = ksl_product_rest(exp_x_sum, exp_series5d, exp_series5e, exp_series5f
          - exp_series5f_right),
      exp_series5f_lo2 = exp_series5f_left_rest + (6.446950284384474e-26 - exp_series5f_right) +
          -1.9330404233703465e-42, exp_series5g = KSL_MUL(exp_x_sum, exp_series5f),
      exp_series5g_cross2 = KSL_MUL(exp_x_sum, exp_series5f_lo2
          + (KSL_MUL(exp_x_sum_lo, exp_series5d) + exp_series5e_cross2)),
      exp_series5h = exp_series5g - 3.868170170630684e-23,
      exp_series5h_right = exp_series5g - exp_series5h,
      exp_series5h_left_rest = ksl_product_rest(exp_x_sum, exp_series5f, exp_series5g, exp_series5h
          + exp_series5h_right),
      exp_series5h_lo2 = exp_series5h_left_rest - (3.868170170630684e-23 - exp_series5h_right) -
          -8.843177655482344e-40, exp_series5i = KSL_MUL(exp_x_sum, exp_series5h),
      exp_series5i_cross2 = KSL_MUL(exp_x_sum, exp_series5h_lo2
          + (KSL_MUL(exp_x_sum_lo, exp_series5f) + exp_series5g_cross2)),
      exp_series5j = exp_series5i + 1.9572941063391263e-20,
      exp_series5j_right = exp_series5j - exp_series5i,
      exp_series5j_left_rest = ksl_product_rest(exp_x_sum, exp_series5h, exp_series5i, exp_series5j
          - exp_series5j_right),
      exp_series5j_lo2 = exp_series5j_left_rest + (1.9572941063391263e-20 - exp_series5j_right) +
          -1.3643503830087908e-36, exp_series5k = KSL_MUL(exp_x_sum, exp_series5j),
      exp_series5k_cross2 = KSL_MUL(exp_x_sum, exp_series5j_lo2
          + (KSL_MUL(exp_x_sum_lo, exp_series5h) + exp_series5i_cross2)),
      exp_series5l = exp_series5k - 8.22063524662433e-18,
      exp_series5l_right = exp_series5k - exp_series5l,
      exp_series5l_left_rest = ksl_product_rest(exp_x_sum, exp_series5j, exp_series5k, exp_series5l
          + exp_series5l_right),
      exp_series5l_lo2 = exp_series5l_left_rest - (8.22063524662433e-18 - exp_series5l_right)
          - 2.2141894119604265e-34, exp_series5m = KSL_MUL(exp_x_sum, exp_series5l),
      exp_series5m_cross2 = KSL_MUL(exp_x_sum, exp_series5l_lo2
          + (KSL_MUL(exp_x_sum_lo, exp_series5j) + exp_series5k_cross2)),
      exp_series5n = exp_series5m + 2.8114572543455206e-15,
      exp_series5n_right = exp_series5n - exp_series5m,
      exp_series5n_left_rest = ksl_product_rest(exp_x_sum, exp_series5l, exp_series5m, exp_series5n
          - exp_series5n_right),
      exp_series5n_lo2 = exp_series5n_left_rest + (2.8114572543455206e-15 - exp_series5n_right)
          + 1.6508842730861433e-31, exp_series5o = KSL_MUL(exp_x_sum, exp_series5n),
      exp_series5o_cross2 = KSL_MUL(exp_x_sum, exp_series5n_lo2
          + (KSL_MUL(exp_x_sum_lo, exp_series5l) + exp_series5m_cross2)),
      exp_series5p = exp_series5o - 7.647163731819816e-13,
      exp_series5p_right = exp_series5o - exp_series5p,
      exp_series5p_left_rest = ksl_product_rest(exp_x_sum, exp_series5n, exp_series5o, exp_series5p
          + exp_series5p_right),
      exp_series5p_lo2 = exp_series5p_left_rest - (7.647163731819816e-13 - exp_series5p_right)
          - 7.03872877733453e-30, exp_series5q = KSL_MUL(exp_x_sum, exp_series5p),
      exp_series5q_cross2 = KSL_MUL(exp_x_sum, exp_series5p_lo2
          + (KSL_MUL(exp_x_sum_lo, exp_series5n) + exp_series5o_cross2)),
      exp_series5r = exp_series5q + 1.6059043836821613e-10,
      exp_series5r_right = exp_series5r - exp_series5q,
      exp_series5r_left_rest = ksl_product_rest(exp_x_sum, exp_series5p, exp_series5q, exp_series5r
          - exp_series5r_right),
      exp_series5r_lo2 = exp_series5r_left_rest + (1.6059043836821613e-10 - exp_series5r_right)
          + 1.2585294588752098e-26, exp_series5s = KSL_MUL(exp_x_sum, exp_series5r),
      exp_series5s_cross2 = KSL_MUL(exp_x_sum, exp_series5r_lo2
          + (KSL_MUL(exp_x_sum_lo, exp_series5p) + exp_series5q_cross2)),
      exp_series5t = exp_series5s - 2.505210838544172e-08,
      exp_series5t_right = exp_series5s - exp_series5t,
      exp_series5t_left_rest = ksl_product_rest(exp_x_sum, exp_series5r, exp_series5s, exp_series5t
          + exp_series5t_right),
      exp_series5t_lo2 = exp_series5t_left_rest - (2.505210838544172e-08 - exp_series5t_right) -
          -1.448814070935912e-24, exp_series5u = KSL_MUL(exp_x_sum, exp_series5t),
      exp_series5u_cross2 = KSL_MUL(exp_x_sum, exp_series5t_lo2
          + (KSL_MUL(exp_x_sum_lo, exp_series5r) + exp_series5s_cross2)),
      exp_series5v = exp_series5u + 2.7557319223985893e-06,
      exp_series5v_right = exp_series5v - exp_series5u,
      exp_series5v_left_rest = ksl_product_rest(exp_x_sum, exp_series5t, exp_series5u, exp_series5v
          - exp_series5v_right),
      exp_series5v_lo2 = exp_series5v_left_rest + (2.7557319223985893e-06 - exp_series5v_right) +
          -1.858393274046472e-22, exp_series5w = KSL_MUL(exp_x_sum, exp_series5v),
      exp_series5w_cross2 = KSL_MUL(exp_x_sum, exp_series5v_lo2
          + (KSL_MUL(exp_x_sum_lo, exp_series5t) + exp_series5u_cross2)),
      exp_series5x = exp_series5w - 0.0001984126984126984,
      exp_series5x_right = exp_series5w - exp_series5x,
      exp_series5x_left_rest = ksl_product_rest(exp_x_sum, exp_series5v, exp_series5w, exp_series5x
          + exp_series5x_right),
      exp_series5x_lo2 = exp_series5x_left_rest - (0.0001984126984126984 - exp_series5x_right)
          - 1.7209558293420705e-22, exp_series5y = KSL_MUL(exp_x_sum, exp_series5x),
      exp_series5y_cross2 = KSL_MUL(exp_x_sum, exp_series5x_lo2
          + (KSL_MUL(exp_x_sum_lo, exp_series5v) + exp_series5w_cross2)),
      exp_series5 = exp_series5y + 0.008333333333333333,
      exp_series5_right = exp_series5 - exp_series5y,
      exp_series5_left_rest = ksl_product_rest(exp_x_sum, exp_series5x, exp_series5y, exp_series5
          - exp_series5_right),
      exp_series5_lo2 = exp_series5_left_rest + (0.008333333333333333 - exp_series5_right)
          + 1.1564823173178714e-19;
  const double exp_g3a = KSL_MUL(exp_x_sum, exp_series5), exp_g3b = 0.16666666666666666 - exp_g3a,
      exp_g3b_right = 0.16666666666666666 - exp_g3b,
      exp_g3a_cross = KSL_MUL(exp_x_sum_lo, exp_series5)
          + KSL_MUL(exp_x_sum, exp_series5_lo2
          + (KSL_MUL(exp_x_sum_lo, exp_series5x) + exp_series5y_cross2)),
      exp_g3b_lo2 = 0.16666666666666666 - (exp_g3b + exp_g3b_right)
          - ksl_product_rest(exp_x_sum, exp_series5, exp_g3a, exp_g3b_right) - exp_g3a_cross,
      exp_g3b_lo = exp_g3b_lo2 + 9.25185853854297e-18,
      exp_g3 = exp_x_sum < 1.0 ? exp_g3b : exp_closed3;
  const double screw_2_cross2 = KSL_MUL(k, whole_2_lo2
          + (KSL_MUL(between_11_lo, log_b_across) + KSL_MUL(between_11, log_b_across_lo)));
  const double screw_2_lo = ksl_product_error(k, whole_2, screw_2) + screw_2_cross2,
      exp_u_0a = KSL_MUL(screw_2, screw_4);
  const double screw_1_cross2 = KSL_MUL(k, whole_1_lo2
          + (KSL_MUL(between_7_lo, log_b_across) + KSL_MUL(between_7, log_b_across_lo)));
  const double screw_1_lo = ksl_product_error(k, whole_1, screw_1) + screw_1_cross2,
      exp_u_0b = KSL_MUL(screw_1, screw_5), exp_u_0 = exp_u_0a - exp_u_0b,
      exp_u_0_right = exp_u_0a - exp_u_0,
      exp_u_0_lo1 = ksl_product_rest(screw_2, screw_4, exp_u_0a, exp_u_0 + exp_u_0_right)
          - ksl_product_rest(screw_1, screw_5, exp_u_0b, exp_u_0_right),
      exp_u_0_cross = KSL_MUL(screw_2_lo, screw_4) + KSL_MUL(screw_2, screw_4_lo)
          - (KSL_MUL(screw_1_lo, screw_5) + KSL_MUL(screw_1, screw_5_lo));
  const double screw_0_cross2 = KSL_MUL(k, whole_0_lo2
          + (KSL_MUL(between_3_lo, log_b_across) + KSL_MUL(between_3, log_b_across_lo)));
  const double screw_0_lo = ksl_product_error(k, whole_0, screw_0) + screw_0_cross2,
      exp_u_1a = KSL_MUL(screw_0, screw_5), exp_u_1b = KSL_MUL(screw_2, screw_3),
      exp_u_1 = exp_u_1a - exp_u_1b, exp_u_1_right = exp_u_1a - exp_u_1,
      exp_u_1_lo1 = ksl_product_rest(screw_0, screw_5, exp_u_1a, exp_u_1 + exp_u_1_right)
          - ksl_product_rest(screw_2, screw_3, exp_u_1b, exp_u_1_right),
      exp_u_1_cross = KSL_MUL(screw_0_lo, screw_5) + KSL_MUL(screw_0, screw_5_lo)
          - (KSL_MUL(screw_2_lo, screw_3) + KSL_MUL(screw_2, screw_3_lo));
  const double exp_u_2a = KSL_MUL(screw_1, screw_3), exp_u_2b = KSL_MUL(screw_0, screw_4),
      exp_u_2 = exp_u_2a - exp_u_2b, exp_u_2_right = exp_u_2a - exp_u_2,
      exp_u_2_lo1 = ksl_product_rest(screw_1, screw_3, exp_u_2a, exp_u_2 + exp_u_2_right)
          - ksl_product_rest(screw_0, screw_4, exp_u_2b, exp_u_2_right),
      exp_u_2_cross = KSL_MUL(screw_1_lo, screw_3) + KSL_MUL(screw_1, screw_3_lo)
          - (KSL_MUL(screw_0_lo, screw_4) + KSL_MUL(screw_0, screw_4_lo));
  const double exp_turned_0 = KSL_MUL(exp_g2, exp_u_0);
  const double exp_turned_1 = KSL_MUL(exp_g2, exp_u_1);
  const double exp_turned_2 = KSL_MUL(exp_g2, exp_u_2);
  const double exp_wv_a = KSL_MUL(screw_0, screw_3), exp_wv_b = KSL_MUL(screw_1, screw_4),
      exp_wv_c = exp_wv_a + exp_wv_b, exp_wv_c_right = exp_wv_c - exp_wv_a,
      exp_wv_c_lo1 = ksl_product_rest(screw_0, screw_3, exp_wv_a, exp_wv_c - exp_wv_c_right)
          + ksl_product_rest(screw_1, screw_4, exp_wv_b, exp_wv_c_right),
      exp_wv_c_cross = KSL_MUL(screw_0_lo, screw_3) + KSL_MUL(screw_0, screw_3_lo)
          + (KSL_MUL(screw_1_lo, screw_4) + KSL_MUL(screw_1, screw_4_lo)),
      exp_wv_d = KSL_MUL(screw_2, screw_5), exp_wv = exp_wv_c + exp_wv_d,
      exp_wv_right = exp_wv - exp_wv_c,
      exp_wv_lo1 = exp_wv_c - (exp_wv - exp_wv_right)
          + ksl_product_rest(screw_2, screw_5, exp_wv_d, exp_wv_right);
  const double exp_pitch = KSL_MUL(exp_g3, exp_wv),
      exp_pitch_cross2 = KSL_MUL(exp_g3, exp_wv_lo1
          + (KSL_MUL(screw_2_lo, screw_5) + KSL_MUL(screw_2, screw_5_lo))
          + (exp_wv_c_lo1 + exp_wv_c_cross));
  const double exp_pitch_lo = ksl_product_error(exp_g3, exp_wv, exp_pitch)
          + (KSL_MUL(exp_x_sum < 1.0 ? exp_g3b_lo : exp_closed3_lo, exp_wv) + exp_pitch_cross2),
      exp_along_0 = KSL_MUL(screw_3, exp_pitch);
  const double exp_along_1 = KSL_MUL(screw_4, exp_pitch), exp_along_2 = KSL_MUL(screw_5, exp_pitch);
  const double exp_beta_v_0 = KSL_MUL(screw_3, exp_g2), exp_beta_v_1 = KSL_MUL(screw_4, exp_g2),
      exp_beta_v_2 = KSL_MUL(screw_5, exp_g2);
  const double exp_beta_v_0_lo = ksl_product_error(screw_3, exp_g2, exp_beta_v_0)
          + (KSL_MUL(screw_3_lo, exp_g2) + KSL_MUL(screw_3, exp_g2_cross2)),
      exp_m_0 = KSL_MUL(screw_3, exp_beta_v_0),
      exp_m_0_cross = KSL_MUL(screw_3_lo, exp_beta_v_0) + KSL_MUL(screw_3, exp_beta_v_0_lo);
  const double exp_beta_v_1_lo = ksl_product_error(screw_4, exp_g2, exp_beta_v_1)
          + (KSL_MUL(screw_4_lo, exp_g2) + KSL_MUL(screw_4, exp_g2_cross2)),
      exp_m_1 = KSL_MUL(screw_4, exp_beta_v_1),
      exp_m_1_cross = KSL_MUL(screw_4_lo, exp_beta_v_1) + KSL_MUL(screw_4, exp_beta_v_1_lo);
  const double exp_m_2 = KSL_MUL(screw_5, exp_beta_v_2),
      exp_m_2_cross2 = KSL_MUL(screw_5, ksl_product_error(screw_5, exp_g2, exp_beta_v_2)
          + (KSL_MUL(screw_5_lo, exp_g2) + KSL_MUL(screw_5, exp_g2_cross2))),
      exp_m_2_cross = KSL_MUL(screw_5_lo, exp_beta_v_2) + exp_m_2_cross2;
  const double exp_m_3 = KSL_MUL(screw_4, exp_beta_v_0),
      exp_m_3_cross = KSL_MUL(screw_4_lo, exp_beta_v_0) + KSL_MUL(screw_4, exp_beta_v_0_lo);
  const double exp_m_4 = KSL_MUL(screw_5, exp_beta_v_0),
      exp_m_4_cross = KSL_MUL(screw_5_lo, exp_beta_v_0) + KSL_MUL(screw_5, exp_beta_v_0_lo);
  const double exp_m_5 = KSL_MUL(screw_5, exp_beta_v_1),
      exp_m_5_cross = KSL_MUL(screw_5_lo, exp_beta_v_1) + KSL_MUL(screw_5, exp_beta_v_1_lo);
  const double exp_others_0 = exp_m_1 + exp_m_2, exp_others_0_right = exp_others_0 - exp_m_1,
      exp_others_0_left_rest = ksl_product_rest(screw_4, exp_beta_v_1, exp_m_1, exp_others_0
          - exp_others_0_right),
      exp_others_0_lo = exp_others_0_left_rest
          + ksl_product_rest(screw_5, exp_beta_v_2, exp_m_2, exp_others_0_right)
          + (exp_m_1_cross + exp_m_2_cross);
  const double exp_others_1 = exp_m_0 + exp_m_2, exp_others_1_right = exp_others_1 - exp_m_0,
      exp_others_1_left_rest = ksl_product_rest(screw_3, exp_beta_v_0, exp_m_0, exp_others_1
          - exp_others_1_right),
      exp_others_1_lo = exp_others_1_left_rest
          + ksl_product_rest(screw_5, exp_beta_v_2, exp_m_2, exp_others_1_right)
          + (exp_m_0_cross + exp_m_2_cross);
  const double exp_others_2 = exp_m_0 + exp_m_1, exp_others_2_right = exp_others_2 - exp_m_0,
      exp_others_2_left_rest = ksl_product_rest(screw_3, exp_beta_v_0, exp_m_0, exp_others_2
          - exp_others_2_right),
      exp_others_2_lo = exp_others_2_left_rest
          + ksl_product_rest(screw_4, exp_beta_v_1, exp_m_1, exp_others_2_right)
          + (exp_m_0_cross + exp_m_1_cross);
  const double exp_diagonal0a = 1.0 - exp_others_0, exp_diagonal0a_right = 1.0 - exp_diagonal0a,
      exp_diagonal0a_lo = 1.0 - (exp_diagonal0a + exp_diagonal0a_right)
          - (exp_others_0 - exp_diagonal0a_right) - exp_others_0_lo,
      exp_diagonal0b = exp_g0 + exp_m_0, exp_diagonal0b_right = exp_diagonal0b - exp_g0,
      exp_diagonal0b_lo1 = exp_g0 - (exp_diagonal0b - exp_diagonal0b_right)
          + ksl_product_rest(screw_3, exp_beta_v_0, exp_m_0, exp_diagonal0b_right),
      exp_diagonal0b_lo = exp_diagonal0b_lo1 + exp_m_0_cross + exp_g0_lo,
      exp_m_0_sum = exp_m_0 + (ksl_product_error(screw_3, exp_beta_v_0, exp_m_0) + exp_m_0_cross),
      exp_others_0_sum = exp_others_0 + exp_others_0_lo,
      exp_diagonal0 = exp_m_0_sum < exp_others_0_sum ? exp_diagonal0b : exp_diagonal0a,
      exp_diagonal0_lo = exp_m_0_sum < exp_others_0_sum ? exp_diagonal0b_lo : exp_diagonal0a_lo;
  const double exp_diagonal1a = 1.0 - exp_others_1, exp_diagonal1a_right = 1.0 - exp_diagonal1a,
      exp_diagonal1a_lo = 1.0 - (exp_diagonal1a + exp_diagonal1a_right)
          - (exp_others_1 - exp_diagonal1a_right) - exp_others_1_lo,
      exp_diagonal1b = exp_g0 + exp_m_1, exp_diagonal1b_right = exp_diagonal1b - exp_g0,
      exp_diagonal1b_lo1 = exp_g0 - (exp_diagonal1b - exp_diagonal1b_right)
          + ksl_product_rest(screw_4, exp_beta_v_1, exp_m_1, exp_diagonal1b_right),
      exp_diagonal1b_lo = exp_diagonal1b_lo1 + exp_m_1_cross + exp_g0_lo,
      exp_m_1_sum = exp_m_1 + (ksl_product_error(screw_4, exp_beta_v_1, exp_m_1) + exp_m_1_cross),
      exp_others_1_sum = exp_others_1 + exp_others_1_lo,
      exp_diagonal1 = exp_m_1_sum < exp_others_1_sum ? exp_diagonal1b : exp_diagonal1a,
      exp_diagonal1_lo = exp_m_1_sum < exp_others_1_sum ? exp_diagonal1b_lo : exp_diagonal1a_lo;
  const double exp_diagonal2a = 1.0 - exp_others_2, exp_diagonal2a_right = 1.0 - exp_diagonal2a,
      exp_diagonal2a_lo = 1.0 - (exp_diagonal2a + exp_diagonal2a_right)
          - (exp_others_2 - exp_diagonal2a_right) - exp_others_2_lo,
      exp_diagonal2b = exp_g0 + exp_m_2, exp_diagonal2b_right = exp_diagonal2b - exp_g0,
      exp_diagonal2b_lo1 = exp_g0 - (exp_diagonal2b - exp_diagonal2b_right)
          + ksl_product_rest(screw_5, exp_beta_v_2, exp_m_2, exp_diagonal2b_right),
      exp_diagonal2b_lo = exp_diagonal2b_lo1 + exp_m_2_cross + exp_g0_lo,
      exp_m_2_sum = exp_m_2 + (ksl_product_error(screw_5, exp_beta_v_2, exp_m_2) + exp_m_2_cross),
      exp_others_2_sum = exp_others_2 + exp_others_2_lo,
      exp_diagonal2 = exp_m_2_sum < exp_others_2_sum ? exp_diagonal2b : exp_diagonal2a,
      exp_diagonal2_lo = exp_m_2_sum < exp_others_2_sum ? exp_diagonal2b_lo : exp_diagonal2a_lo;
  const double exp_g1_lo = ksl_product_error(exp_c, exp_sinc, exp_g1) + exp_g1_cross,
      exp_alpha_v_0 = KSL_MUL(screw_3, exp_g1),
      exp_alpha_v_0_cross = KSL_MUL(screw_3_lo, exp_g1) + KSL_MUL(screw_3, exp_g1_lo);
  const double exp_alpha_v_1 = KSL_MUL(screw_4, exp_g1),
      exp_alpha_v_1_cross = KSL_MUL(screw_4_lo, exp_g1) + KSL_MUL(screw_4, exp_g1_lo);
  const double exp_alpha_v_2 = KSL_MUL(screw_5, exp_g1),
      exp_alpha_v_2_cross = KSL_MUL(screw_5_lo, exp_g1) + KSL_MUL(screw_5, exp_g1_lo);
  const double exp_across_axis_0 = exp_turned_0 + exp_along_0,
      exp_across_axis_0_right = exp_across_axis_0 - exp_turned_0;
  const double exp_turned_0_cross = KSL_MUL(exp_g2_cross2, exp_u_0)
          + KSL_MUL(exp_g2, exp_u_0_lo1 + exp_u_0_cross);
  const double exp_across_axis_0_left_rest = ksl_product_rest(exp_g2, exp_u_0, exp_turned_0,
      exp_across_axis_0 - exp_across_axis_0_right),
      exp_across_axis_0_lo1 = exp_across_axis_0_left_rest
          + ksl_product_rest(screw_3, exp_pitch, exp_along_0, exp_across_axis_0_right);
  const double exp_across_axis_1 = exp_turned_1 + exp_along_1,
      exp_across_axis_1_right = exp_across_axis_1 - exp_turned_1;
  const double exp_turned_1_cross = KSL_MUL(exp_g2_cross2, exp_u_1)
          + KSL_MUL(exp_g2, exp_u_1_lo1 + exp_u_1_cross);
  const double exp_across_axis_1_left_rest = ksl_product_rest(exp_g2, exp_u_1, exp_turned_1,
      exp_across_axis_1 - exp_across_axis_1_right),
      exp_across_axis_1_lo1 = exp_across_axis_1_left_rest
          + ksl_product_rest(screw_4, exp_pitch, exp_along_1, exp_across_axis_1_right);
  const double exp_across_axis_2 = exp_turned_2 + exp_along_2,
      exp_across_axis_2_right = exp_across_axis_2 - exp_turned_2;
  const double exp_turned_2_cross = KSL_MUL(exp_g2_cross2, exp_u_2)
          + KSL_MUL(exp_g2, exp_u_2_lo1 + exp_u_2_cross);
  const double exp_across_axis_2_left_rest = ksl_product_rest(exp_g2, exp_u_2, exp_turned_2,
      exp_across_axis_2 - exp_across_axis_2_right),
      exp_across_axis_2_lo1 = exp_across_axis_2_left_rest
          + ksl_product_rest(screw_5, exp_pitch, exp_along_2, exp_across_axis_2_right);
  const double step_1 = exp_m_3 - exp_alpha_v_2, step_1_right = exp_m_3 - step_1,
      step_1_lo1 = ksl_product_rest(screw_4, exp_beta_v_0, exp_m_3, step_1 + step_1_right)
          - ksl_product_rest(screw_5, exp_g1, exp_alpha_v_2, step_1_right),
      step_1_lo = step_1_lo1 + (exp_m_3_cross - exp_alpha_v_2_cross);
  const double step_2 = exp_m_4 + exp_alpha_v_1, step_2_right = step_2 - exp_m_4,
      step_2_lo1 = ksl_product_rest(screw_5, exp_beta_v_0, exp_m_4, step_2 - step_2_right)
          + ksl_product_rest(screw_4, exp_g1, exp_alpha_v_1, step_2_right),
      step_2_lo = step_2_lo1 + (exp_m_4_cross + exp_alpha_v_1_cross);
  const double step_3a = KSL_MUL(screw_0, exp_g1), step_3 = step_3a + exp_across_axis_0,
      step_3_right = step_3 - step_3a;
  const double exp_across_axis_0_lo = exp_across_axis_0_lo1
          + (exp_turned_0_cross
          + (KSL_MUL(screw_3_lo, exp_pitch) + KSL_MUL(screw_3, exp_pitch_lo)));
  const double step_3_lo2 = ksl_product_rest(screw_0, exp_g1, step_3a, step_3 - step_3_right)
          + (exp_across_axis_0 - step_3_right) + exp_across_axis_0_lo,
      step_3_lo = step_3_lo2 + (KSL_MUL(screw_0_lo, exp_g1) + KSL_MUL(screw_0, exp_g1_lo));
  const double step_4 = exp_m_3 + exp_alpha_v_2, step_4_right = step_4 - exp_m_3,
      step_4_lo1 = ksl_product_rest(screw_4, exp_beta_v_0, exp_m_3, step_4 - step_4_right)
          + ksl_product_rest(screw_5, exp_g1, exp_alpha_v_2, step_4_right),
      step_4_lo = step_4_lo1 + (exp_m_3_cross + exp_alpha_v_2_cross);
  const double step_6 = exp_m_5 - exp_alpha_v_0, step_6_right = exp_m_5 - step_6,
      step_6_lo1 = ksl_product_rest(screw_5, exp_beta_v_1, exp_m_5, step_6 + step_6_right)
          - ksl_product_rest(screw_3, exp_g1, exp_alpha_v_0, step_6_right),
      step_6_lo = step_6_lo1 + (exp_m_5_cross - exp_alpha_v_0_cross);
  const double step_7a = KSL_MUL(screw_1, exp_g1), step_7 = step_7a + exp_across_axis_1,
      step_7_right = step_7 - step_7a;
  const double exp_across_axis_1_lo = exp_across_axis_1_lo1
          + (exp_turned_1_cross
          + (KSL_MUL(screw_4_lo, exp_pitch) + KSL_MUL(screw_4, exp_pitch_lo)));
  const double step_7_lo2 = ksl_product_rest(screw_1, exp_g1, step_7a, step_7 - step_7_right)
          + (exp_across_axis_1 - step_7_right) + exp_across_axis_1_lo,
      step_7_lo = step_7_lo2 + (KSL_MUL(screw_1_lo, exp_g1) + KSL_MUL(screw_1, exp_g1_lo));
  const double step_8 = exp_m_4 - exp_alpha_v_1, step_8_right = exp_m_4 - step_8,
      step_8_lo1 = ksl_product_rest(screw_5, exp_beta_v_0, exp_m_4, step_8 + step_8_right)
          - ksl_product_rest(screw_4, exp_g1, exp_alpha_v_1, step_8_right),
      step_8_lo = step_8_lo1 + (exp_m_4_cross - exp_alpha_v_1_cross);
  const double step_9 = exp_m_5 + exp_alpha_v_0, step_9_right = step_9 - exp_m_5,
      step_9_lo1 = ksl_product_rest(screw_5, exp_beta_v_1, exp_m_5, step_9 - step_9_right)
          + ksl_product_rest(screw_3, exp_g1, exp_alpha_v_0, step_9_right),
      step_9_lo = step_9_lo1 + (exp_m_5_cross + exp_alpha_v_0_cross);
  const double step_11a = KSL_MUL(screw_2, exp_g1), step_11 = step_11a + exp_across_axis_2,
      step_11_right = step_11 - step_11a;
  const double exp_across_axis_2_lo = exp_across_axis_2_lo1
          + (exp_turned_2_cross
          + (KSL_MUL(screw_5_lo, exp_pitch) + KSL_MUL(screw_5, exp_pitch_lo)));
  const double step_11_lo2 = ksl_product_rest(screw_2, exp_g1, step_11a, step_11 - step_11_right)
          + (exp_across_axis_2 - step_11_right) + exp_across_axis_2_lo,
      step_11_lo = step_11_lo2 + (KSL_MUL(screw_2_lo, exp_g1) + KSL_MUL(screw_2, exp_g1_lo));
  const double Do_00a = KSL_MUL(D1->m00, exp_diagonal0), Do_00b = KSL_MUL(D1->m01, step_4),
      Do_00c = KSL_MUL(D1->m02, step_8), Do_00d = Do_00b + Do_00c, Do_00d_right = Do_00d - Do_00b,
      Do_00d_lo1 = ksl_product_rest(D1->m01, step_4, Do_00b, Do_00d - Do_00d_right)
          + ksl_product_rest(D1->m02, step_8, Do_00c, Do_00d_right), Do_00 = Do_00a + Do_00d,
      Do_00_right = Do_00 - Do_00a,
      Do_00_lo1 = ksl_product_rest(D1->m00, exp_diagonal0, Do_00a, Do_00 - Do_00_right)
          + (Do_00d - Do_00_right);
  const double Do_01a = KSL_MUL(D1->m00, step_1), Do_01b = KSL_MUL(D1->m02, step_9),
      Do_01c = Do_01a + Do_01b, Do_01c_right = Do_01c - Do_01a,
      Do_01c_lo1 = ksl_product_rest(D1->m00, step_1, Do_01a, Do_01c - Do_01c_right)
          + ksl_product_rest(D1->m02, step_9, Do_01b, Do_01c_right),
      Do_01d = KSL_MUL(D1->m01, exp_diagonal1), Do_01 = Do_01c + Do_01d,
      Do_01_right = Do_01 - Do_01c,
      Do_01_lo2 = Do_01c - (Do_01 - Do_01_right)
          + ksl_product_rest(D1->m01, exp_diagonal1, Do_01d, Do_01_right)
          + KSL_MUL(D1->m01, exp_diagonal1_lo);
  const double Do_02a = KSL_MUL(D1->m00, step_2), Do_02b = KSL_MUL(D1->m01, step_6),
      Do_02c = Do_02a + Do_02b, Do_02c_right = Do_02c - Do_02a,
      Do_02c_lo1 = ksl_product_rest(D1->m00, step_2, Do_02a, Do_02c - Do_02c_right)
          + ksl_product_rest(D1->m01, step_6, Do_02b, Do_02c_right),
      Do_02d = KSL_MUL(D1->m02, exp_diagonal2), Do_02 = Do_02c + Do_02d,
      Do_02_right = Do_02 - Do_02c,
      Do_02_lo2 = Do_02c - (Do_02 - Do_02_right)
          + ksl_product_rest(D1->m02, exp_diagonal2, Do_02d, Do_02_right)
          + KSL_MUL(D1->m02, exp_diagonal2_lo);
  const double Do_03a = KSL_MUL(D1->m00, step_3), Do_03b = KSL_MUL(D1->m01, step_7),
      Do_03c = Do_03a + Do_03b, Do_03c_right = Do_03c - Do_03a,
      Do_03c_lo1 = ksl_product_rest(D1->m00, step_3, Do_03a, Do_03c - Do_03c_right)
          + ksl_product_rest(D1->m01, step_7, Do_03b, Do_03c_right),
      Do_03d = KSL_MUL(D1->m02, step_11), Do_03e = Do_03c + Do_03d, Do_03e_right = Do_03e - Do_03c,
      Do_03e_lo2 = Do_03c - (Do_03e - Do_03e_right)
          + ksl_product_rest(D1->m02, step_11, Do_03d, Do_03e_right) + KSL_MUL(D1->m02, step_11_lo),
      Do_03 = Do_03e + D1->m03, Do_03_right = Do_03 - Do_03e,
      Do_03e_lo = Do_03e_lo2
          + (Do_03c_lo1 + (KSL_MUL(D1->m00, step_3_lo) + KSL_MUL(D1->m01, step_7_lo)));
  const double Do_10a = KSL_MUL(D1->m10, exp_diagonal0), Do_10b = KSL_MUL(D1->m11, step_4),
      Do_10c = KSL_MUL(D1->m12, step_8), Do_10d = Do_10b + Do_10c, Do_10d_right = Do_10d - Do_10b,
      Do_10d_lo1 = ksl_product_rest(D1->m11, step_4, Do_10b, Do_10d - Do_10d_right)
          + ksl_product_rest(D1->m12, step_8, Do_10c, Do_10d_right), Do_10 = Do_10a + Do_10d,
      Do_10_right = Do_10 - Do_10a,
      Do_10_lo1 = ksl_product_rest(D1->m10, exp_diagonal0, Do_10a, Do_10 - Do_10_right)
          + (Do_10d - Do_10_right);
  const double Do_11a = KSL_MUL(D1->m10, step_1), Do_11b = KSL_MUL(D1->m12, step_9),
      Do_11c = Do_11a + Do_11b, Do_11c_right = Do_11c - Do_11a,
      Do_11c_lo1 = ksl_product_rest(D1->m10, step_1, Do_11a, Do_11c - Do_11c_right)
          + ksl_product_rest(D1->m12, step_9, Do_11b, Do_11c_right),
      Do_11d = KSL_MUL(D1->m11, exp_diagonal1), Do_11 = Do_11c + Do_11d,
      Do_11_right = Do_11 - Do_11c,
      Do_11_lo2 = Do_11c - (Do_11 - Do_11_right)
          + ksl_product_rest(D1->m11, exp_diagonal1, Do_11d, Do_11_right)
          + KSL_MUL(D1->m11, exp_diagonal1_lo);
  const double Do_12a = KSL_MUL(D1->m10, step_2), Do_12b = KSL_MUL(D1->m11, step_6),
      Do_12c = Do_12a + Do_12b, Do_12c_right = Do_12c - Do_12a,
      Do_12c_lo1 = ksl_product_rest(D1->m10, step_2, Do_12a, Do_12c - Do_12c_right)
          + ksl_product_rest(D1->m11, step_6, Do_12b, Do_12c_right),
      Do_12d = KSL_MUL(D1->m12, exp_diagonal2), Do_12 = Do_12c + Do_12d,
      Do_12_right = Do_12 - Do_12c,
      Do_12_lo2 = Do_12c - (Do_12 - Do_12_right)
          + ksl_product_rest(D1->m12, exp_diagonal2, Do_12d, Do_12_right)
          + KSL_MUL(D1->m12, exp_diagonal2_lo);
  const double Do_13a = KSL_MUL(D1->m10, step_3), Do_13b = KSL_MUL(D1->m11, step_7),
      Do_13c = Do_13a + Do_13b, Do_13c_right = Do_13c - Do_13a,
      Do_13c_lo1 = ksl_product_rest(D1->m10, step_3, Do_13a, Do_13c - Do_13c_right)
          + ksl_product_rest(D1->m11, step_7, Do_13b, Do_13c_right),
      Do_13d = KSL_MUL(D1->m12, step_11), Do_13e = Do_13c + Do_13d, Do_13e_right = Do_13e - Do_13c,
      Do_13e_lo2 = Do_13c - (Do_13e - Do_13e_right)
          + ksl_product_rest(D1->m12, step_11, Do_13d, Do_13e_right) + KSL_MUL(D1->m12, step_11_lo),
      Do_13 = Do_13e + D1->m13, Do_13_right = Do_13 - Do_13e,
      Do_13e_lo = Do_13e_lo2
          + (Do_13c_lo1 + (KSL_MUL(D1->m10, step_3_lo) + KSL_MUL(D1->m11, step_7_lo)));
  const double Do_20a = KSL_MUL(D1->m20, exp_diagonal0), Do_20b = KSL_MUL(D1->m21, step_4),
      Do_20c = KSL_MUL(D1->m22, step_8), Do_20d = Do_20b + Do_20c, Do_20d_right = Do_20d - Do_20b,
      Do_20d_lo1 = ksl_product_rest(D1->m21, step_4, Do_20b, Do_20d - Do_20d_right)
          + ksl_product_rest(D1->m22, step_8, Do_20c, Do_20d_right), Do_20 = Do_20a + Do_20d,
      Do_20_right = Do_20 - Do_20a,
      Do_20_lo1 = ksl_product_rest(D1->m20, exp_diagonal0, Do_20a, Do_20 - Do_20_right)
          + (Do_20d - Do_20_right);
  const double Do_21a = KSL_MUL(D1->m20, step_1), Do_21b = KSL_MUL(D1->m22, step_9),
      Do_21c = Do_21a + Do_21b, Do_21c_right = Do_21c - Do_21a,
      Do_21c_lo1 = ksl_product_rest(D1->m20, step_1, Do_21a, Do_21c - Do_21c_right)
          + ksl_product_rest(D1->m22, step_9, Do_21b, Do_21c_right),
      Do_21d = KSL_MUL(D1->m21, exp_diagonal1), Do_21 = Do_21c + Do_21d,
      Do_21_right = Do_21 - Do_21c,
      Do_21_lo2 = Do_21c - (Do_21 - Do_21_right)
          + ksl_product_rest(D1->m21, exp_diagonal1, Do_21d, Do_21_right)
          + KSL_MUL(D1->m21, exp_diagonal1_lo);
  const double Do_22a = KSL_MUL(D1->m20, step_2), Do_22b = KSL_MUL(D1->m21, step_6),
      Do_22c = Do_22a + Do_22b, Do_22c_right = Do_22c - Do_22a,
      Do_22c_lo1 = ksl_product_rest(D1->m20, step_2, Do_22a, Do_22c - Do_22c_right)
          + ksl_product_rest(D1->m21, step_6, Do_22b, Do_22c_right),
      Do_22d = KSL_MUL(D1->m22, exp_diagonal2), Do_22 = Do_22c + Do_22d,
      Do_22_right = Do_22 - Do_22c,
      Do_22_lo2 = Do_22c - (Do_22 - Do_22_right)
          + ksl_product_rest(D1->m22, exp_diagonal2, Do_22d, Do_22_right)
          + KSL_MUL(D1->m22, exp_diagonal2_lo);
  const double Do_23a = KSL_MUL(D1->m20, step_3), Do_23b = KSL_MUL(D1->m21, step_7),
      Do_23c = Do_23a + Do_23b, Do_23c_right = Do_23c - Do_23a,
      Do_23c_lo1 = ksl_product_rest(D1->m20, step_3, Do_23a, Do_23c - Do_23c_right)
          + ksl_product_rest(D1->m21, step_7, Do_23b, Do_23c_right),
      Do_23d = KSL_MUL(D1->m22, step_11), Do_23e = Do_23c + Do_23d, Do_23e_right = Do_23e - Do_23c,
      Do_23e_lo2 = Do_23c - (Do_23e - Do_23e_right)
          + ksl_product_rest(D1->m22, step_11, Do_23d, Do_23e_right) + KSL_MUL(D1->m22, step_11_lo),
      Do_23 = Do_23e + D1->m23, Do_23_right = Do_23 - Do_23e,
      Do_23e_lo = Do_23e_lo2
          + (Do_23c_lo1 + (KSL_MUL(D1->m20, step_3_lo) + KSL_MUL(D1->m21, step_7_lo)));
  const double Do_00_rounded = Do_00
          + (Do_00_lo1 + (Do_00d_lo1 + (KSL_MUL(D1->m01, step_4_lo) + KSL_MUL(D1->m02, step_8_lo)))
          + KSL_MUL(D1->m00, exp_diagonal0_lo));
  const double Do_01_rounded = Do_01
          + (Do_01_lo2
          + (Do_01c_lo1 + (KSL_MUL(D1->m00, step_1_lo) + KSL_MUL(D1->m02, step_9_lo))));
  const double Do_02_rounded = Do_02
          + (Do_02_lo2
          + (Do_02c_lo1 + (KSL_MUL(D1->m00, step_2_lo) + KSL_MUL(D1->m01, step_6_lo))));
  const double Do_03_rounded = Do_03
          + (Do_03e - (Do_03 - Do_03_right) + (D1->m03 - Do_03_right) + Do_03e_lo);
  const double Do_10_rounded = Do_10
          + (Do_10_lo1 + (Do_10d_lo1 + (KSL_MUL(D1->m11, step_4_lo) + KSL_MUL(D1->m12, step_8_lo)))
          + KSL_MUL(D1->m10, exp_diagonal0_lo));
  const double Do_11_rounded = Do_11
          + (Do_11_lo2
          + (Do_11c_lo1 + (KSL_MUL(D1->m10, step_1_lo) + KSL_MUL(D1->m12, step_9_lo))));
  const double Do_12_rounded = Do_12
          + (Do_12_lo2
          + (Do_12c_lo1 + (KSL_MUL(D1->m10, step_2_lo) + KSL_MUL(D1->m11, step_6_lo))));
  const double Do_13_rounded = Do_13
          + (Do_13e - (Do_13 - Do_13_right) + (D1->m13 - Do_13_right) + Do_13e_lo);
  const double Do_20_rounded = Do_20
          + (Do_20_lo1 + (Do_20d_lo1 + (KSL_MUL(D1->m21, step_4_lo) + KSL_MUL(D1->m22, step_8_lo)))
          + KSL_MUL(D1->m20, exp_diagonal0_lo));
  const double Do_21_rounded = Do_21
          + (Do_21_lo2
          + (Do_21c_lo1 + (KSL_MUL(D1->m20, step_1_lo) + KSL_MUL(D1->m22, step_9_lo))));
  const double Do_22_rounded = Do_22
          + (Do_22_lo2
          + (Do_22c_lo1 + (KSL_MUL(D1->m20, step_2_lo) + KSL_MUL(D1->m21, step_6_lo))));
  const double Do_23_rounded = Do_23
          + (Do_23e - (Do_23 - Do_23_right) + (D1->m23 - Do_23_right) + Do_23e_lo);
  const double Do_00_final = Do_00_rounded == Do_00_rounded ? Do_00_rounded : Do_00;
  const double Do_01_final = Do_01_rounded == Do_01_rounded ? Do_01_rounded : Do_01;
  const double Do_02_final = Do_02_rounded == Do_02_rounded ? Do_02_rounded : Do_02;
  const double Do_03_final = Do_03_rounded == Do_03_rounded ? Do_03_rounded : Do_03;
  const double Do_10_final = Do_10_rounded == Do_10_rounded ? Do_10_rounded : Do_10;
  const double Do_11_final = Do_11_rounded == Do_11_rounded ? Do_11_rounded : Do_11;
  const double Do_12_final = Do_12_rounded == Do_12_rounded ? Do_12_rounded : Do_12;
  const double Do_13_final = Do_13_rounded == Do_13_rounded ? Do_13_rounded : Do_13;
  const double Do_20_final = Do_20_rounded == Do_20_rounded ? Do_20_rounded : Do_20;
  const double Do_21_final = Do_21_rounded == Do_21_rounded ? Do_21_rounded : Do_21;
  const double Do_22_final = Do_22_rounded == Do_22_rounded ? Do_22_rounded : Do_22;
  const double Do_23_final = Do_23_rounded == Do_23_rounded ? Do_23_rounded : Do_23;
  Do->m00 = Do_00_final;
  Do->m01 = Do_01_final;
  Do->m02 = Do_02_final;
  Do->m03 = Do_03_final;
  Do->m10 = Do_10_final;
  Do->m11 = Do_11_final;
  Do->m12 = Do_12_final;
  Do->m13 = Do_13_final;
  Do->m20 = Do_20_final;
  Do->m21 = Do_21_final;
  Do->m22 = Do_22_final;
  Do->m23 = Do_23_final;
}

/* R = exp v~ = I + sin θ/θ v~ + (1 - cos θ)/θ^2 v~^2, θ = |v|.
   v: vector; R: rotation or other 3×3 matrix.
   55 mul, 48 add, 1 div, 1 sqrt, 4 abs, 5 less, 6 select.
   Error <= R: 1 u of its largest component for |v| <= 1e13, in single precision 1e5; searched,
     not proved.  Each component is within 1 ulp as long as its condition is below 1e13; in
     single precision it is the nearest number, except near ties, as long as that is below 1e5;
     searched, not proved. */
static inline void ksl_SO3_expf_accurate(const ksl_vec3f_t *v, ksl_mat3x3f_t *R) {
  const double halved_0 = 0.5 * (double)v->x, halved_1 = 0.5 * (double)v->y,
      halved_2 = 0.5 * (double)v->z;
  const double h_size_0 = fabs(halved_0), h_size_1 = fabs(halved_1), h_size_2 = fabs(halved_2);
  const double h_largest1 = h_size_0 < h_size_1 ? h_size_1 : h_size_0;
  const double h_largest2 = h_largest1 < h_size_2 ? h_size_2 : h_largest1;
  const double s = 4.611686018427388e+18 < h_largest2 ? 2.710505431213761e-20 : 1.0;
  const double reduced_0 = KSL_MUL(halved_0, s), reduced_1 = KSL_MUL(halved_1, s),
      reduced_2 = KSL_MUL(halved_2, s);
  const double up = s < 1.0 ? 3.6893488147419103e+19 : 1.0;
  const double reduced_length = sqrt(KSL_MUL(reduced_0, reduced_0) + KSL_MUL(reduced_1, reduced_1)
          + KSL_MUL(reduced_2, reduced_2));
  const double half_angle = KSL_MUL(reduced_length, up);
  const double y = KSL_MUL(half_angle, half_angle);
  double c; const double sine = ksl_sincos(half_angle, &c);
  const double sinc_divisor = half_angle < 1.4901161193847656e-08 ? 1.4901161193847656e-08
          : half_angle;
  const double sinc_quotient = sine / sinc_divisor;
  const double sinc_b = 1.0 - KSL_MUL(0.16666666666666666, y),
      sinc = half_angle < 1.4901161193847656e-08 ? sinc_b : sinc_quotient;
  const double turning_0 = KSL_MUL((double)v->x, sinc), turning_1 = KSL_MUL((double)v->y, sinc),
      turning_2 = KSL_MUL((double)v->z, sinc);
  const double beta_v_0 = KSL_MUL(0.5, turning_0), beta_v_1 = KSL_MUL(0.5, turning_1),
      beta_v_2 = KSL_MUL(0.5, turning_2);
  const double m_0 = KSL_MUL(turning_0, beta_v_0), m_1 = KSL_MUL(turning_1, beta_v_1),
      m_2 = KSL_MUL(turning_2, beta_v_2), m_3 = KSL_MUL(turning_1, beta_v_0),
      m_4 = KSL_MUL(turning_2, beta_v_0), m_5 = KSL_MUL(turning_2, beta_v_1);
  const double others_0 = m_1 + m_2, others_1 = m_0 + m_2, others_2 = m_0 + m_1;
  const double alpha_v_0 = KSL_MUL(c, turning_0), alpha_v_1 = KSL_MUL(c, turning_1),
      alpha_v_2 = KSL_MUL(c, turning_2);
  const double R_00 = 1.0 - others_0, R_01 = m_3 - alpha_v_2, R_02 = m_4 + alpha_v_1,
      R_10 = m_3 + alpha_v_2, R_11 = 1.0 - others_1, R_12 = m_5 - alpha_v_0, R_20 = m_4 - alpha_v_1,
      R_21 = m_5 + alpha_v_0, R_22 = 1.0 - others_2;
  R->m00 = (float)R_00;
  R->m01 = (float)R_01;
  R->m02 = (float)R_02;
  R->m10 = (float)R_10;
  R->m11 = (float)R_11;
  R->m12 = (float)R_12;
  R->m20 = (float)R_20;
  R->m21 = (float)R_21;
  R->m22 = (float)R_22;
}

/* vo with exp vo~ = R, |vo| <= π; if R is not quite a rotation, its defect carries over to vo.
   R: rotation or other 3×3 matrix; vo: vector.
   40 mul, 51 add, 2 div, 1 sqrt, 6 neg, 5 abs, 2 copysign, 18 less, 2 equal, 39 select.
   Error <= vo: 1 u of its largest component for R a rotation; searched, not proved.  Each
     component is within 1 ulp as long as its condition is below 1e13; in single precision it is
     the nearest number, except near ties, as long as that is below 1e5; searched, not proved. */
static inline void ksl_SO3_logf_accurate(const ksl_mat3x3f_t *R, ksl_vec3f_t *vo) {
  const double p_0 = (double)R->m21 - (double)R->m12, p_1 = (double)R->m02 - (double)R->m20,
      p_2 = (double)R->m10 - (double)R->m01;
  const double s_0 = (double)R->m12 + (double)R->m21, s_1 = (double)R->m02 + (double)R->m20,
      s_2 = (double)R->m01 + (double)R->m10;
  const double first_0 = (double)R->m00 + 1.0, first_1 = 1.0 - (double)R->m00;
  const double others_0 = (double)R->m11 + (double)R->m22,
      others_1 = (double)R->m11 - (double)R->m22;
  const double d_0 = first_0 + others_0, d_1 = first_0 - others_0, d_2 = first_1 + others_1,
      d_3 = first_1 - others_1;
  const double low_0 = (double)R->m11 < (double)R->m00 ? d_1 : s_2,
      low_1 = (double)R->m11 < (double)R->m00 ? s_2 : d_2,
      low_2 = (double)R->m11 < (double)R->m00 ? s_1 : s_0,
      low_3 = (double)R->m11 < (double)R->m00 ? p_0 : p_1;
  const double high_0a = -(double)R->m11, high_0 = (double)R->m00 < high_0a ? s_1 : p_0;
  const double high_1 = (double)R->m00 < high_0a ? s_0 : p_1,
      high_2 = (double)R->m00 < high_0a ? d_3 : p_2, high_3 = (double)R->m00 < high_0a ? p_2 : d_0;
  const double column_0 = (double)R->m22 < 0.0 ? low_0 : high_0,
      column_1 = (double)R->m22 < 0.0 ? low_1 : high_1,
      column_2 = (double)R->m22 < 0.0 ? low_2 : high_2,
      column_3 = (double)R->m22 < 0.0 ? low_3 : high_3;
  const double upper_0a = -column_0, upper_0 = column_3 < 0.0 ? upper_0a : column_0;
  const double upper_1a = -column_1, upper_1 = column_3 < 0.0 ? upper_1a : column_1;
  const double upper_2a = -column_2, upper_2 = column_3 < 0.0 ? upper_2a : column_2;
  const double upper_3a = -column_3, upper_3 = column_3 < 0.0 ? upper_3a : column_3;
  const double v_s_size_0 = fabs(upper_0), v_s_size_1 = fabs(upper_1), v_s_size_2 = fabs(upper_2);
  const double v_s_largest1 = v_s_size_0 < v_s_size_1 ? v_s_size_1 : v_s_size_0;
  const double v_s_largest2 = v_s_largest1 < v_s_size_2 ? v_s_size_2 : v_s_largest1;
  const double v_s_b = 4.611686018427388e+18 < v_s_largest2 ? 2.710505431213761e-20 : 1.0,
      v_s_d = v_s_largest2 < 256.0 ? 1.8014398509481984e+16 : v_s_b,
      v_s = v_s_largest2 < 1.4210854715202004e-14 ? 3.2451855365842673e+32 : v_s_d;
  const double v_y_0 = KSL_MUL(upper_0, v_s), v_y_1 = KSL_MUL(upper_1, v_s),
      v_y_2 = KSL_MUL(upper_2, v_s);
  const double v_n = sqrt(KSL_MUL(v_y_0, v_y_0) + KSL_MUL(v_y_1, v_y_1) + KSL_MUL(v_y_2, v_y_2));
  const double v_r_b = v_s < 1.0 ? 3.6893488147419103e+19 : 1.0,
      v_r_d = 1.0 < v_s ? 5.551115123125783e-17 : v_r_b,
      v_r = 1.8014398509481984e+16 < v_s ? 3.0814879110195774e-33 : v_r_d;
  const double n = KSL_MUL(v_n, v_r);
  const double half = ksl_atan2(n, upper_3);
  const double divisor = n == 0.0 ? 1.0 : n;
  const double theta = KSL_MUL(2.0, half);
  const double k = theta / divisor;
  const double vector_0 = KSL_MUL(upper_0, k), vector_1 = KSL_MUL(upper_1, k),
      vector_2 = KSL_MUL(upper_2, k);
  vo->x = (float)vector_0;
  vo->y = (float)vector_1;
  vo->z = (float)vector_2;
}

/* R = J_l(v) = I + (1 - cos θ)/θ^2 v~ + (θ - sin θ)/θ^3 v~^2, θ = |v|.
   v: vector; R: rotation or other 3×3 matrix.
   65 mul, 66 add, 2 div, 1 sqrt, 1 abs, 5 less, 7 select.
   Error <= R: 1 u of its largest component for |v| <= 1e13, in single precision 1e5; searched,
     not proved.  Each component is within 1 ulp as long as its condition is below 1e13; in
     single precision it is the nearest number, except near ties, as long as that is below 1e5;
     searched, not proved. */
static inline void ksl_SO3_leftJacobianf_accurate(const ksl_vec3f_t *v, ksl_mat3x3f_t *R) {
  const double halved_0 = 0.5 * (double)v->x, halved_1 = 0.5 * (double)v->y,
      halved_2 = 0.5 * (double)v->z;
  const double y = KSL_MUL(halved_0, halved_0) + KSL_MUL(halved_1, halved_1)
          + KSL_MUL(halved_2, halved_2);
  const double half_angle = sqrt(y);
  double c; const double sine = ksl_sincos(half_angle, &c);
  const double sinc_divisor = half_angle < 1.4901161193847656e-08 ? 1.4901161193847656e-08
          : half_angle;
  const double sinc_quotient = sine / sinc_divisor;
  const double sinc_b = 1.0 - KSL_MUL(0.16666666666666666, y),
      sinc = half_angle < 1.4901161193847656e-08 ? sinc_b : sinc_quotient;
  const double g1 = KSL_MUL(c, sinc);
  const double g2 = KSL_MUL(0.5, KSL_MUL(sinc, sinc));
  const double rest3 = 1.0 - g1;
  const double x = KSL_MUL(4.0, y);
  const double far_x = x < 1.0 ? 1.0 : x;
  const double closed3 = rest3 / far_x;
  const double series5f = KSL_MUL(x, KSL_MUL(x, 1.1309962886447716e-31
          - KSL_MUL(1.216125041553518e-34, x)) - 9.183689863795546e-29) + 6.446950284384474e-26,
      series5m = KSL_MUL(x, KSL_MUL(x, KSL_MUL(x, KSL_MUL(x, series5f) - 3.868170170630684e-23)
          + 1.9572941063391263e-20) - 8.22063524662433e-18),
      series5s = KSL_MUL(x, KSL_MUL(x, KSL_MUL(x, series5m + 2.8114572543455206e-15)
          - 7.647163731819816e-13) + 1.6059043836821613e-10),
      series5 = KSL_MUL(x, KSL_MUL(x, KSL_MUL(x, series5s - 2.505210838544172e-08)
          + 2.7557319223985893e-06) - 0.0001984126984126984) + 0.008333333333333333;
  const double g3b = 0.16666666666666666 - KSL_MUL(x, series5), g3 = x < 1.0 ? g3b : closed3;
  const double beta_v_0 = KSL_MUL((double)v->x, g3), beta_v_1 = KSL_MUL((double)v->y, g3),
      beta_v_2 = KSL_MUL((double)v->z, g3);
  const double m_0 = KSL_MUL((double)v->x, beta_v_0), m_1 = KSL_MUL((double)v->y, beta_v_1),
      m_2 = KSL_MUL((double)v->z, beta_v_2), m_3 = KSL_MUL((double)v->y, beta_v_0),
      m_4 = KSL_MUL((double)v->z, beta_v_0), m_5 = KSL_MUL((double)v->z, beta_v_1);
  const double others_0 = m_1 + m_2, others_1 = m_0 + m_2, others_2 = m_0 + m_1;
  const double diagonal0a = 1.0 - others_0, diagonal0b = g1 + m_0,
      diagonal0 = m_0 < others_0 ? diagonal0b : diagonal0a;
  const double diagonal1a = 1.0 - others_1, diagonal1b = g1 + m_1,
      diagonal1 = m_1 < others_1 ? diagonal1b : diagonal1a;
  const double diagonal2a = 1.0 - others_2, diagonal2b = g1 + m_2,
      diagonal2 = m_2 < others_2 ? diagonal2b : diagonal2a;
  const double alpha_v_0 = KSL_MUL((double)v->x, g2), alpha_v_1 = KSL_MUL((double)v->y, g2),
      alpha_v_2 = KSL_MUL((double)v->z, g2);
  const double R_01 = m_3 - alpha_v_2, R_02 = m_4 + alpha_v_1, R_10 = m_3 + alpha_v_2,
      R_12 = m_5 - alpha_v_0, R_20 = m_4 - alpha_v_1, R_21 = m_5 + alpha_v_0;
  R->m00 = (float)diagonal0;
  R->m01 = (float)R_01;
  R->m02 = (float)R_02;
  R->m10 = (float)R_10;
  R->m11 = (float)diagonal1;
  R->m12 = (float)R_12;
  R->m20 = (float)R_20;
  R->m21 = (float)R_21;
  R->m22 = (float)diagonal2;
}

/* R = J_r(v) = I - (1 - cos θ)/θ^2 v~ + (θ - sin θ)/θ^3 v~^2, θ = |v|.
   v: vector; R: rotation or other 3×3 matrix.
   65 mul, 66 add, 2 div, 1 sqrt, 3 neg, 1 abs, 5 less, 7 select.
   Error <= R: 1 u of its largest component for |v| <= 1e13, in single precision 1e5; searched,
     not proved.  Each component is within 1 ulp as long as its condition is below 1e13; in
     single precision it is the nearest number, except near ties, as long as that is below 1e5;
     searched, not proved. */
static inline void ksl_SO3_rightJacobianf_accurate(const ksl_vec3f_t *v, ksl_mat3x3f_t *R) {
  const double halved_0 = 0.5 * (double)v->x, halved_1 = 0.5 * (double)v->y,
      halved_2 = 0.5 * (double)v->z;
  const double y = KSL_MUL(halved_0, halved_0) + KSL_MUL(halved_1, halved_1)
          + KSL_MUL(halved_2, halved_2);
  const double half_angle = sqrt(y);
  double c; const double sine = ksl_sincos(half_angle, &c);
  const double sinc_divisor = half_angle < 1.4901161193847656e-08 ? 1.4901161193847656e-08
          : half_angle;
  const double sinc_quotient = sine / sinc_divisor;
  const double sinc_b = 1.0 - KSL_MUL(0.16666666666666666, y),
      sinc = half_angle < 1.4901161193847656e-08 ? sinc_b : sinc_quotient;
  const double g1 = KSL_MUL(c, sinc);
  const double g2 = KSL_MUL(0.5, KSL_MUL(sinc, sinc));
  const double rest3 = 1.0 - g1;
  const double x = KSL_MUL(4.0, y);
  const double far_x = x < 1.0 ? 1.0 : x;
  const double closed3 = rest3 / far_x;
  const double series5f = KSL_MUL(x, KSL_MUL(x, 1.1309962886447716e-31
          - KSL_MUL(1.216125041553518e-34, x)) - 9.183689863795546e-29) + 6.446950284384474e-26,
      series5m = KSL_MUL(x, KSL_MUL(x, KSL_MUL(x, KSL_MUL(x, series5f) - 3.868170170630684e-23)
          + 1.9572941063391263e-20) - 8.22063524662433e-18),
      series5s = KSL_MUL(x, KSL_MUL(x, KSL_MUL(x, series5m + 2.8114572543455206e-15)
          - 7.647163731819816e-13) + 1.6059043836821613e-10),
      series5 = KSL_MUL(x, KSL_MUL(x, KSL_MUL(x, series5s - 2.505210838544172e-08)
          + 2.7557319223985893e-06) - 0.0001984126984126984) + 0.008333333333333333;
  const double g3b = 0.16666666666666666 - KSL_MUL(x, series5), g3 = x < 1.0 ? g3b : closed3;
  const double beta_v_0 = KSL_MUL((double)v->x, g3), beta_v_1 = KSL_MUL((double)v->y, g3),
      beta_v_2 = KSL_MUL((double)v->z, g3);
  const double m_0 = KSL_MUL((double)v->x, beta_v_0), m_1 = KSL_MUL((double)v->y, beta_v_1),
      m_2 = KSL_MUL((double)v->z, beta_v_2), m_3 = KSL_MUL((double)v->y, beta_v_0),
      m_4 = KSL_MUL((double)v->z, beta_v_0), m_5 = KSL_MUL((double)v->z, beta_v_1);
  const double others_0 = m_1 + m_2, others_1 = m_0 + m_2, others_2 = m_0 + m_1;
  const double diagonal0a = 1.0 - others_0, diagonal0b = g1 + m_0,
      diagonal0 = m_0 < others_0 ? diagonal0b : diagonal0a;
  const double diagonal1a = 1.0 - others_1, diagonal1b = g1 + m_1,
      diagonal1 = m_1 < others_1 ? diagonal1b : diagonal1a;
  const double diagonal2a = 1.0 - others_2, diagonal2b = g1 + m_2,
      diagonal2 = m_2 < others_2 ? diagonal2b : diagonal2a;
  const double alpha_v_0 = -KSL_MUL((double)v->x, g2), alpha_v_1 = -KSL_MUL((double)v->y, g2),
      alpha_v_2 = -KSL_MUL((double)v->z, g2);
  const double R_01 = m_3 - alpha_v_2, R_02 = m_4 + alpha_v_1, R_10 = m_3 + alpha_v_2,
      R_12 = m_5 - alpha_v_0, R_20 = m_4 - alpha_v_1, R_21 = m_5 + alpha_v_0;
  R->m00 = (float)diagonal0;
  R->m01 = (float)R_01;
  R->m02 = (float)R_02;
  R->m10 = (float)R_10;
  R->m11 = (float)diagonal1;
  R->m12 = (float)R_12;
  R->m20 = (float)R_20;
  R->m21 = (float)R_21;
  R->m22 = (float)diagonal2;
}

/* R = J_l(v)^-1 = I - v~/2 + (1 - θ/2 cot θ/2)/θ^2 v~^2, θ = |v|; singular at multiples of 2π
     except 0.
   v: vector; R: rotation or other 3×3 matrix.
   63 mul, 66 add, 4 div, 1 sqrt, 3 neg, 1 abs, 5 less, 7 select.
   Error <= R: 1 u of its largest component for |v| <= π; searched, not proved.  Each component
     is within 1 ulp as long as its condition is below 1e13; in single precision it is the
     nearest number, except near ties, as long as that is below 1e5; searched, not proved. */
static inline void ksl_SO3_leftJacobianInversef_accurate(const ksl_vec3f_t *v, ksl_mat3x3f_t *R) {
  const double halved_0 = 0.5 * (double)v->x, halved_1 = 0.5 * (double)v->y,
      halved_2 = 0.5 * (double)v->z;
  const double y = KSL_MUL(halved_0, halved_0) + KSL_MUL(halved_1, halved_1)
          + KSL_MUL(halved_2, halved_2);
  const double half_angle = sqrt(y);
  double c; const double sine = ksl_sincos(half_angle, &c);
  const double sinc_divisor = half_angle < 1.4901161193847656e-08 ? 1.4901161193847656e-08
          : half_angle;
  const double sinc_quotient = sine / sinc_divisor;
  const double sinc_b = 1.0 - KSL_MUL(0.16666666666666666, y),
      sinc = half_angle < 1.4901161193847656e-08 ? sinc_b : sinc_quotient;
  const double series_phi_f = KSL_MUL(y, KSL_MUL(y, 4.116826490666969e-29
          - KSL_MUL(5.107725174524775e-32, y)) - 2.86531123750421e-26) + 1.701994875077501e-23,
      series_phi_m = KSL_MUL(y, KSL_MUL(y, KSL_MUL(y, KSL_MUL(y, series_phi_f)
          - 8.509974375387505e-21) + 3.523129391410427e-18) - 1.1837714755139035e-15),
      series_phi_s = KSL_MUL(y, KSL_MUL(y, KSL_MUL(y, series_phi_m + 3.148832124866983e-13)
          - 6.423617534728645e-11) + 9.635426302092969e-09),
      series_phi_y = KSL_MUL(y, KSL_MUL(y, KSL_MUL(y, series_phi_s - 1.0020843354176687e-06)
          + 6.613756613756614e-05) - 0.002380952380952381),
      series_phi = series_phi_y + 0.03333333333333333;
  const double f_more = KSL_MUL(KSL_MUL(2.0, y), series_phi);
  const double near_f = KSL_MUL(0.3333333333333333, sinc) + KSL_MUL(0.3333333333333333, f_more);
  const double f_rest = sinc - c;
  const double x = KSL_MUL(4.0, y);
  const double far_y = x < 4.0 ? 1.0 : y;
  const double closed_f = f_rest / far_y;
  const double f = x < 4.0 ? near_f : closed_f;
  const double four_k = KSL_MUL(4.0, sinc);
  const double b = f / four_k;
  const double b_across = c / sinc;
  const double beta_v_0 = KSL_MUL((double)v->x, b), beta_v_1 = KSL_MUL((double)v->y, b),
      beta_v_2 = KSL_MUL((double)v->z, b);
  const double m_0 = KSL_MUL((double)v->x, beta_v_0), m_1 = KSL_MUL((double)v->y, beta_v_1),
      m_2 = KSL_MUL((double)v->z, beta_v_2), m_3 = KSL_MUL((double)v->y, beta_v_0),
      m_4 = KSL_MUL((double)v->z, beta_v_0), m_5 = KSL_MUL((double)v->z, beta_v_1);
  const double others_0 = m_1 + m_2, others_1 = m_0 + m_2, others_2 = m_0 + m_1;
  const double diagonal0a = 1.0 - others_0, diagonal0b = b_across + m_0,
      diagonal0 = m_0 < others_0 ? diagonal0b : diagonal0a;
  const double diagonal1a = 1.0 - others_1, diagonal1b = b_across + m_1,
      diagonal1 = m_1 < others_1 ? diagonal1b : diagonal1a;
  const double diagonal2a = 1.0 - others_2, diagonal2b = b_across + m_2,
      diagonal2 = m_2 < others_2 ? diagonal2b : diagonal2a;
  const double alpha_v_0 = -halved_0, alpha_v_1 = -halved_1, alpha_v_2 = -halved_2;
  const double R_01 = m_3 - alpha_v_2, R_02 = m_4 + alpha_v_1, R_10 = m_3 + alpha_v_2,
      R_12 = m_5 - alpha_v_0, R_20 = m_4 - alpha_v_1, R_21 = m_5 + alpha_v_0;
  R->m00 = (float)diagonal0;
  R->m01 = (float)R_01;
  R->m02 = (float)R_02;
  R->m10 = (float)R_10;
  R->m11 = (float)diagonal1;
  R->m12 = (float)R_12;
  R->m20 = (float)R_20;
  R->m21 = (float)R_21;
  R->m22 = (float)diagonal2;
}

/* R = J_r(v)^-1 = I + v~/2 + (1 - θ/2 cot θ/2)/θ^2 v~^2, θ = |v|; singular at multiples of 2π
     except 0.
   v: vector; R: rotation or other 3×3 matrix.
   63 mul, 66 add, 4 div, 1 sqrt, 1 abs, 5 less, 7 select.
   Error <= R: 1 u of its largest component for |v| <= π; searched, not proved.  Each component
     is within 1 ulp as long as its condition is below 1e13; in single precision it is the
     nearest number, except near ties, as long as that is below 1e5; searched, not proved. */
static inline void ksl_SO3_rightJacobianInversef_accurate(const ksl_vec3f_t *v, ksl_mat3x3f_t *R) {
  const double halved_0 = 0.5 * (double)v->x, halved_1 = 0.5 * (double)v->y,
      halved_2 = 0.5 * (double)v->z;
  const double y = KSL_MUL(halved_0, halved_0) + KSL_MUL(halved_1, halved_1)
          + KSL_MUL(halved_2, halved_2);
  const double half_angle = sqrt(y);
  double c; const double sine = ksl_sincos(half_angle, &c);
  const double sinc_divisor = half_angle < 1.4901161193847656e-08 ? 1.4901161193847656e-08
          : half_angle;
  const double sinc_quotient = sine / sinc_divisor;
  const double sinc_b = 1.0 - KSL_MUL(0.16666666666666666, y),
      sinc = half_angle < 1.4901161193847656e-08 ? sinc_b : sinc_quotient;
  const double series_phi_f = KSL_MUL(y, KSL_MUL(y, 4.116826490666969e-29
          - KSL_MUL(5.107725174524775e-32, y)) - 2.86531123750421e-26) + 1.701994875077501e-23,
      series_phi_m = KSL_MUL(y, KSL_MUL(y, KSL_MUL(y, KSL_MUL(y, series_phi_f)
          - 8.509974375387505e-21) + 3.523129391410427e-18) - 1.1837714755139035e-15),
      series_phi_s = KSL_MUL(y, KSL_MUL(y, KSL_MUL(y, series_phi_m + 3.148832124866983e-13)
          - 6.423617534728645e-11) + 9.635426302092969e-09),
      series_phi_y = KSL_MUL(y, KSL_MUL(y, KSL_MUL(y, series_phi_s - 1.0020843354176687e-06)
          + 6.613756613756614e-05) - 0.002380952380952381),
      series_phi = series_phi_y + 0.03333333333333333;
  const double f_more = KSL_MUL(KSL_MUL(2.0, y), series_phi);
  const double near_f = KSL_MUL(0.3333333333333333, sinc) + KSL_MUL(0.3333333333333333, f_more);
  const double f_rest = sinc - c;
  const double x = KSL_MUL(4.0, y);
  const double far_y = x < 4.0 ? 1.0 : y;
  const double closed_f = f_rest / far_y;
  const double f = x < 4.0 ? near_f : closed_f;
  const double four_k = KSL_MUL(4.0, sinc);
  const double b = f / four_k;
  const double b_across = c / sinc;
  const double beta_v_0 = KSL_MUL((double)v->x, b), beta_v_1 = KSL_MUL((double)v->y, b),
      beta_v_2 = KSL_MUL((double)v->z, b);
  const double m_0 = KSL_MUL((double)v->x, beta_v_0), m_1 = KSL_MUL((double)v->y, beta_v_1),
      m_2 = KSL_MUL((double)v->z, beta_v_2), m_3 = KSL_MUL((double)v->y, beta_v_0),
      m_4 = KSL_MUL((double)v->z, beta_v_0), m_5 = KSL_MUL((double)v->z, beta_v_1);
  const double others_0 = m_1 + m_2, others_1 = m_0 + m_2, others_2 = m_0 + m_1;
  const double diagonal0a = 1.0 - others_0, diagonal0b = b_across + m_0,
      diagonal0 = m_0 < others_0 ? diagonal0b : diagonal0a;
  const double diagonal1a = 1.0 - others_1, diagonal1b = b_across + m_1,
      diagonal1 = m_1 < others_1 ? diagonal1b : diagonal1a;
  const double diagonal2a = 1.0 - others_2, diagonal2b = b_across + m_2,
      diagonal2 = m_2 < others_2 ? diagonal2b : diagonal2a;
  const double R_01 = m_3 - halved_2, R_02 = halved_1 + m_4, R_10 = halved_2 + m_3,
      R_12 = m_5 - halved_0, R_20 = m_4 - halved_1, R_21 = halved_0 + m_5;
  R->m00 = (float)diagonal0;
  R->m01 = (float)R_01;
  R->m02 = (float)R_02;
  R->m10 = (float)R_10;
  R->m11 = (float)diagonal1;
  R->m12 = (float)R_12;
  R->m20 = (float)R_20;
  R->m21 = (float)R_21;
  R->m22 = (float)diagonal2;
}

/* self = R + R (I - R^T R)/2, closer to a rotation: a defect d of R becomes 3/4 d^2.
   self: rotation or other 3×3 matrix.
   51 mul, 42 add, 3 neg.
   Error <= u |result| + 1/4 u^2 S, S the sum of the |terms| of the expanded formula; barring
     over- and underflow. */
static inline void ksl_mat3x3f_orthonormalize_accurate(ksl_mat3x3f_t *self) {
  const double defect_0d = ksl_product_sum(-(double)self->m10, (double)self->m10,
      ksl_product_sum(-(double)self->m00, (double)self->m00, 1.0)),
      defect_0 = ksl_product_sum(-(double)self->m20, (double)self->m20, defect_0d);
  const double defect_1d = ksl_product_sum(-(double)self->m11, (double)self->m11,
      ksl_product_sum(-(double)self->m01, (double)self->m01, 1.0)),
      defect_1 = ksl_product_sum(-(double)self->m21, (double)self->m21, defect_1d);
  const double defect_2d = ksl_product_sum(-(double)self->m12, (double)self->m12,
      ksl_product_sum(-(double)self->m02, (double)self->m02, 1.0)),
      defect_2 = ksl_product_sum(-(double)self->m22, (double)self->m22, defect_2d);
  const double defect_3c = ksl_product_sum(-(double)self->m10, (double)self->m11,
          -((double)self->m00 * (double)self->m01)),
      defect_3 = ksl_product_sum(-(double)self->m20, (double)self->m21, defect_3c);
  const double defect_4c = ksl_product_sum(-(double)self->m10, (double)self->m12,
          -((double)self->m00 * (double)self->m02)),
      defect_4 = ksl_product_sum(-(double)self->m20, (double)self->m22, defect_4c);
  const double defect_5c = ksl_product_sum(-(double)self->m11, (double)self->m12,
          -((double)self->m01 * (double)self->m02)),
      defect_5 = ksl_product_sum(-(double)self->m21, (double)self->m22, defect_5c);
  const double correction_0 = KSL_MUL(0.5, defect_0), correction_1 = KSL_MUL(0.5, defect_1),
      correction_2 = KSL_MUL(0.5, defect_2), correction_3 = KSL_MUL(0.5, defect_3),
      correction_4 = KSL_MUL(0.5, defect_4), correction_5 = KSL_MUL(0.5, defect_5);
  const double self_00_new_e = KSL_MUL((double)self->m00, correction_0)
          + KSL_MUL((double)self->m01, correction_3) + KSL_MUL((double)self->m02, correction_4),
      self_00_new = (double)self->m00 + self_00_new_e;
  const double self_01_new_e = KSL_MUL((double)self->m00, correction_3)
          + KSL_MUL((double)self->m01, correction_1) + KSL_MUL((double)self->m02, correction_5),
      self_01_new = self_01_new_e + (double)self->m01;
  const double self_02_new_e = KSL_MUL((double)self->m00, correction_4)
          + KSL_MUL((double)self->m01, correction_5) + KSL_MUL((double)self->m02, correction_2),
      self_02_new = self_02_new_e + (double)self->m02;
  const double self_10_new_e = KSL_MUL((double)self->m10, correction_0)
          + KSL_MUL((double)self->m11, correction_3) + KSL_MUL((double)self->m12, correction_4),
      self_10_new = (double)self->m10 + self_10_new_e;
  const double self_11_new_e = KSL_MUL((double)self->m10, correction_3)
          + KSL_MUL((double)self->m11, correction_1) + KSL_MUL((double)self->m12, correction_5),
      self_11_new = self_11_new_e + (double)self->m11;
  const double self_12_new_e = KSL_MUL((double)self->m10, correction_4)
          + KSL_MUL((double)self->m11, correction_5) + KSL_MUL((double)self->m12, correction_2),
      self_12_new = self_12_new_e + (double)self->m12;
  const double self_20_new_e = KSL_MUL((double)self->m20, correction_0)
          + KSL_MUL((double)self->m21, correction_3) + KSL_MUL((double)self->m22, correction_4),
      self_20_new = (double)self->m20 + self_20_new_e;
  const double self_21_new_e = KSL_MUL((double)self->m20, correction_3)
          + KSL_MUL((double)self->m21, correction_1) + KSL_MUL((double)self->m22, correction_5),
      self_21_new = self_21_new_e + (double)self->m21;
  const double self_22_new_e = KSL_MUL((double)self->m20, correction_4)
          + KSL_MUL((double)self->m21, correction_5) + KSL_MUL((double)self->m22, correction_2),
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
  const double defect_0d = ksl_product_sum(-(double)R->m10, (double)R->m10,
      ksl_product_sum(-(double)R->m00, (double)R->m00, 1.0)),
      defect_0 = ksl_product_sum(-(double)R->m20, (double)R->m20, defect_0d);
  const double defect_1d = ksl_product_sum(-(double)R->m11, (double)R->m11,
      ksl_product_sum(-(double)R->m01, (double)R->m01, 1.0)),
      defect_1 = ksl_product_sum(-(double)R->m21, (double)R->m21, defect_1d);
  const double defect_2d = ksl_product_sum(-(double)R->m12, (double)R->m12,
      ksl_product_sum(-(double)R->m02, (double)R->m02, 1.0)),
      defect_2 = ksl_product_sum(-(double)R->m22, (double)R->m22, defect_2d);
  const double defect_3 = ksl_product_sum(-(double)R->m20, (double)R->m21,
      ksl_product_sum(-(double)R->m10, (double)R->m11, -((double)R->m00 * (double)R->m01))),
      defect_4 = ksl_product_sum(-(double)R->m20, (double)R->m22, ksl_product_sum(-(double)R->m10,
          (double)R->m12, -((double)R->m00 * (double)R->m02))),
      defect_5 = ksl_product_sum(-(double)R->m21, (double)R->m22, ksl_product_sum(-(double)R->m11,
          (double)R->m12, -((double)R->m01 * (double)R->m02)));
  const double correction_0 = KSL_MUL(0.5, defect_0), correction_1 = KSL_MUL(0.5, defect_1),
      correction_2 = KSL_MUL(0.5, defect_2), correction_3 = KSL_MUL(0.5, defect_3),
      correction_4 = KSL_MUL(0.5, defect_4), correction_5 = KSL_MUL(0.5, defect_5);
  const double Ro_00 = (double)R->m00
          + (KSL_MUL((double)R->m00, correction_0) + KSL_MUL((double)R->m01, correction_3)
          + KSL_MUL((double)R->m02, correction_4)),
      Ro_01 = KSL_MUL((double)R->m00, correction_3) + KSL_MUL((double)R->m01, correction_1)
          + KSL_MUL((double)R->m02, correction_5) + (double)R->m01,
      Ro_02 = KSL_MUL((double)R->m00, correction_4) + KSL_MUL((double)R->m01, correction_5)
          + KSL_MUL((double)R->m02, correction_2) + (double)R->m02,
      Ro_10 = (double)R->m10
          + (KSL_MUL((double)R->m10, correction_0) + KSL_MUL((double)R->m11, correction_3)
          + KSL_MUL((double)R->m12, correction_4)),
      Ro_11 = KSL_MUL((double)R->m10, correction_3) + KSL_MUL((double)R->m11, correction_1)
          + KSL_MUL((double)R->m12, correction_5) + (double)R->m11,
      Ro_12 = KSL_MUL((double)R->m10, correction_4) + KSL_MUL((double)R->m11, correction_5)
          + KSL_MUL((double)R->m12, correction_2) + (double)R->m12,
      Ro_20 = (double)R->m20
          + (KSL_MUL((double)R->m20, correction_0) + KSL_MUL((double)R->m21, correction_3)
          + KSL_MUL((double)R->m22, correction_4)),
      Ro_21 = KSL_MUL((double)R->m20, correction_3) + KSL_MUL((double)R->m21, correction_1)
          + KSL_MUL((double)R->m22, correction_5) + (double)R->m21,
      Ro_22 = KSL_MUL((double)R->m20, correction_4) + KSL_MUL((double)R->m21, correction_5)
          + KSL_MUL((double)R->m22, correction_2) + (double)R->m22;
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

/* D = exp s = [exp ω~ | J_l(ω) v].
   s: screw (v in m/s; ω in rad/s); D: displacement [R | t], R rotation, t in m.
   86 mul, 78 add, 2 div, 1 sqrt, 1 abs, 5 less, 7 select.
   Error <= R: 1 u, t: 1 u of its largest component, or of s.lin if that is larger, for |ω of s|
     <= 1e13, in single precision 1e5; searched, not proved.  Each component is within 1 ulp as
     long as its condition is below 1e13; in single precision it is the nearest number, except
     near ties, as long as that is below 1e5; searched, not proved.  Intermediate sums may
     overflow where |v|, or |ω| |v|, is above 2e306, in single precision 5e36. */
static inline void ksl_SE3f_exp_accurate(const ksl_screwf_t *s, ksl_SE3f_t *D) {
  const double halved_0 = 0.5 * (double)s->m3, halved_1 = 0.5 * (double)s->m4,
      halved_2 = 0.5 * (double)s->m5;
  const double y = KSL_MUL(halved_0, halved_0) + KSL_MUL(halved_1, halved_1)
          + KSL_MUL(halved_2, halved_2);
  const double half_angle = sqrt(y);
  double c; const double sine = ksl_sincos(half_angle, &c);
  const double sinc_divisor = half_angle < 1.4901161193847656e-08 ? 1.4901161193847656e-08
          : half_angle;
  const double sinc_quotient = sine / sinc_divisor;
  const double sinc_b = 1.0 - KSL_MUL(0.16666666666666666, y),
      sinc = half_angle < 1.4901161193847656e-08 ? sinc_b : sinc_quotient;
  const double g1 = KSL_MUL(c, sinc);
  const double g2 = KSL_MUL(0.5, KSL_MUL(sinc, sinc));
  const double sine_square = KSL_MUL(sine, sine);
  const double g0 = 1.0 - KSL_MUL(2.0, sine_square);
  const double rest3 = 1.0 - g1;
  const double x = KSL_MUL(4.0, y);
  const double far_x = x < 1.0 ? 1.0 : x;
  const double closed3 = rest3 / far_x;
  const double series5f = KSL_MUL(x, KSL_MUL(x, 1.1309962886447716e-31
          - KSL_MUL(1.216125041553518e-34, x)) - 9.183689863795546e-29) + 6.446950284384474e-26,
      series5m = KSL_MUL(x, KSL_MUL(x, KSL_MUL(x, KSL_MUL(x, series5f) - 3.868170170630684e-23)
          + 1.9572941063391263e-20) - 8.22063524662433e-18),
      series5s = KSL_MUL(x, KSL_MUL(x, KSL_MUL(x, series5m + 2.8114572543455206e-15)
          - 7.647163731819816e-13) + 1.6059043836821613e-10),
      series5 = KSL_MUL(x, KSL_MUL(x, KSL_MUL(x, series5s - 2.505210838544172e-08)
          + 2.7557319223985893e-06) - 0.0001984126984126984) + 0.008333333333333333;
  const double g3b = 0.16666666666666666 - KSL_MUL(x, series5), g3 = x < 1.0 ? g3b : closed3;
  const double u_0 = ksl_product_sum(-(double)s->m1, (double)s->m5, (double)s->m2 * (double)s->m4),
      u_1 = ksl_product_sum(-(double)s->m2, (double)s->m3, (double)s->m0 * (double)s->m5),
      u_2 = ksl_product_sum(-(double)s->m0, (double)s->m4, (double)s->m1 * (double)s->m3);
  const double turned_0 = KSL_MUL(g2, u_0), turned_1 = KSL_MUL(g2, u_1),
      turned_2 = KSL_MUL(g2, u_2);
  const double wv = ksl_product_sum((double)s->m2, (double)s->m5, ksl_product_sum((double)s->m1,
      (double)s->m4, (double)s->m0 * (double)s->m3));
  const double pitch = KSL_MUL(g3, wv);
  const double along_0 = KSL_MUL((double)s->m3, pitch), along_1 = KSL_MUL((double)s->m4, pitch),
      along_2 = KSL_MUL((double)s->m5, pitch);
  const double beta_v_0 = KSL_MUL((double)s->m3, g2), beta_v_1 = KSL_MUL((double)s->m4, g2),
      beta_v_2 = KSL_MUL((double)s->m5, g2);
  const double m_0 = KSL_MUL((double)s->m3, beta_v_0), m_1 = KSL_MUL((double)s->m4, beta_v_1),
      m_2 = KSL_MUL((double)s->m5, beta_v_2), m_3 = KSL_MUL((double)s->m4, beta_v_0),
      m_4 = KSL_MUL((double)s->m5, beta_v_0), m_5 = KSL_MUL((double)s->m5, beta_v_1);
  const double others_0 = m_1 + m_2, others_1 = m_0 + m_2, others_2 = m_0 + m_1;
  const double diagonal0a = 1.0 - others_0, diagonal0b = g0 + m_0,
      diagonal0 = m_0 < others_0 ? diagonal0b : diagonal0a;
  const double diagonal1a = 1.0 - others_1, diagonal1b = g0 + m_1,
      diagonal1 = m_1 < others_1 ? diagonal1b : diagonal1a;
  const double diagonal2a = 1.0 - others_2, diagonal2b = g0 + m_2,
      diagonal2 = m_2 < others_2 ? diagonal2b : diagonal2a;
  const double alpha_v_0 = KSL_MUL((double)s->m3, g1), alpha_v_1 = KSL_MUL((double)s->m4, g1),
      alpha_v_2 = KSL_MUL((double)s->m5, g1);
  const double across_axis_0 = turned_0 + along_0, across_axis_1 = turned_1 + along_1,
      across_axis_2 = turned_2 + along_2;
  const double D_01 = m_3 - alpha_v_2, D_02 = m_4 + alpha_v_1,
      D_03 = KSL_MUL((double)s->m0, g1) + across_axis_0, D_10 = m_3 + alpha_v_2,
      D_12 = m_5 - alpha_v_0, D_13 = KSL_MUL((double)s->m1, g1) + across_axis_1,
      D_20 = m_4 - alpha_v_1, D_21 = m_5 + alpha_v_0,
      D_23 = KSL_MUL((double)s->m2, g1) + across_axis_2;
  D->m00 = (float)diagonal0;
  D->m01 = (float)D_01;
  D->m02 = (float)D_02;
  D->m03 = (float)D_03;
  D->m10 = (float)D_10;
  D->m11 = (float)diagonal1;
  D->m12 = (float)D_12;
  D->m13 = (float)D_13;
  D->m20 = (float)D_20;
  D->m21 = (float)D_21;
  D->m22 = (float)diagonal2;
  D->m23 = (float)D_23;
}

/* so with exp so = D, |ω| <= π: (J_l(ω)^-1 t; ω), ω = log R.
   D: displacement [R | t], R rotation, t in m; so: screw (v in m/s; ω in rad/s).
   83 mul, 79 add, 8 div, 2 sqrt, 5 neg, 6 abs, 2 copysign, 20 less, 2 equal, 42 select.
   Error <= lin: 1 u, ang: 1 u of its largest component for R of D a rotation; searched, not
     proved.  Each component is within 1 ulp as long as its condition is below 1e13; in single
     precision it is the nearest number, except near ties, as long as that is below 1e5;
     searched, not proved.  Intermediate sums may overflow where |t| is above 2e306, in single
     precision 5e36. */
static inline void ksl_SE3f_log_accurate(const ksl_SE3f_t *D, ksl_screwf_t *so) {
  const double p_0 = (double)D->m21 - (double)D->m12, p_1 = (double)D->m02 - (double)D->m20,
      p_2 = (double)D->m10 - (double)D->m01;
  const double s_0 = (double)D->m12 + (double)D->m21, s_1 = (double)D->m02 + (double)D->m20,
      s_2 = (double)D->m01 + (double)D->m10;
  const double first_0 = (double)D->m00 + 1.0, first_1 = 1.0 - (double)D->m00;
  const double others_0 = (double)D->m11 + (double)D->m22,
      others_1 = (double)D->m11 - (double)D->m22;
  const double d_0 = first_0 + others_0, d_1 = first_0 - others_0, d_2 = first_1 + others_1,
      d_3 = first_1 - others_1;
  const double low_0 = (double)D->m11 < (double)D->m00 ? d_1 : s_2,
      low_1 = (double)D->m11 < (double)D->m00 ? s_2 : d_2,
      low_2 = (double)D->m11 < (double)D->m00 ? s_1 : s_0,
      low_3 = (double)D->m11 < (double)D->m00 ? p_0 : p_1;
  const double high_0a = -(double)D->m11, high_0 = (double)D->m00 < high_0a ? s_1 : p_0;
  const double high_1 = (double)D->m00 < high_0a ? s_0 : p_1,
      high_2 = (double)D->m00 < high_0a ? d_3 : p_2, high_3 = (double)D->m00 < high_0a ? p_2 : d_0;
  const double column_0 = (double)D->m22 < 0.0 ? low_0 : high_0,
      column_1 = (double)D->m22 < 0.0 ? low_1 : high_1,
      column_2 = (double)D->m22 < 0.0 ? low_2 : high_2,
      column_3 = (double)D->m22 < 0.0 ? low_3 : high_3;
  const double upper_0a = -column_0, upper_0 = column_3 < 0.0 ? upper_0a : column_0;
  const double upper_1a = -column_1, upper_1 = column_3 < 0.0 ? upper_1a : column_1;
  const double upper_2a = -column_2, upper_2 = column_3 < 0.0 ? upper_2a : column_2;
  const double upper_3 = fabs(column_3);
  const double v_s_size_0 = fabs(upper_0), v_s_size_1 = fabs(upper_1), v_s_size_2 = fabs(upper_2);
  const double v_s_largest1 = v_s_size_0 < v_s_size_1 ? v_s_size_1 : v_s_size_0;
  const double v_s_largest2 = v_s_largest1 < v_s_size_2 ? v_s_size_2 : v_s_largest1;
  const double v_s_b = 4.611686018427388e+18 < v_s_largest2 ? 2.710505431213761e-20 : 1.0,
      v_s_d = v_s_largest2 < 256.0 ? 1.8014398509481984e+16 : v_s_b,
      v_s = v_s_largest2 < 1.4210854715202004e-14 ? 3.2451855365842673e+32 : v_s_d;
  const double v_y_0 = KSL_MUL(upper_0, v_s), v_y_1 = KSL_MUL(upper_1, v_s),
      v_y_2 = KSL_MUL(upper_2, v_s);
  const double v_n = sqrt(KSL_MUL(v_y_0, v_y_0) + KSL_MUL(v_y_1, v_y_1) + KSL_MUL(v_y_2, v_y_2));
  const double v_r_b = v_s < 1.0 ? 3.6893488147419103e+19 : 1.0,
      v_r_d = 1.0 < v_s ? 5.551115123125783e-17 : v_r_b,
      v_r = 1.8014398509481984e+16 < v_s ? 3.0814879110195774e-33 : v_r_d;
  const double n = KSL_MUL(v_n, v_r);
  const double half = ksl_atan2(n, upper_3);
  const double divisor = n == 0.0 ? 1.0 : n;
  const double theta = KSL_MUL(2.0, half);
  const double k = theta / divisor;
  const double vector_0 = KSL_MUL(upper_0, k), vector_1 = KSL_MUL(upper_1, k),
      vector_2 = KSL_MUL(upper_2, k);
  const double half_angle = KSL_MUL(0.5, theta);
  const double length = sqrt(KSL_MUL(n, n) + KSL_MUL(upper_3, upper_3));
  const double sine = n / length;
  const double c = upper_3 / length;
  const double y = KSL_MUL(half_angle, half_angle);
  const double sinc_divisor = half_angle < 1.4901161193847656e-08 ? 1.4901161193847656e-08
          : half_angle;
  const double sinc_quotient = sine / sinc_divisor;
  const double sinc_b = 1.0 - KSL_MUL(0.16666666666666666, y),
      sinc = half_angle < 1.4901161193847656e-08 ? sinc_b : sinc_quotient;
  const double series_phi_f = KSL_MUL(y, KSL_MUL(y, 4.116826490666969e-29
          - KSL_MUL(5.107725174524775e-32, y)) - 2.86531123750421e-26) + 1.701994875077501e-23,
      series_phi_m = KSL_MUL(y, KSL_MUL(y, KSL_MUL(y, KSL_MUL(y, series_phi_f)
          - 8.509974375387505e-21) + 3.523129391410427e-18) - 1.1837714755139035e-15),
      series_phi_s = KSL_MUL(y, KSL_MUL(y, KSL_MUL(y, series_phi_m + 3.148832124866983e-13)
          - 6.423617534728645e-11) + 9.635426302092969e-09),
      series_phi_y = KSL_MUL(y, KSL_MUL(y, KSL_MUL(y, series_phi_s - 1.0020843354176687e-06)
          + 6.613756613756614e-05) - 0.002380952380952381),
      series_phi = series_phi_y + 0.03333333333333333;
  const double f_more = KSL_MUL(KSL_MUL(2.0, y), series_phi);
  const double near_f = KSL_MUL(0.3333333333333333, sinc) + KSL_MUL(0.3333333333333333, f_more);
  const double f_rest = sinc - c;
  const double x = KSL_MUL(4.0, y);
  const double far_y = x < 4.0 ? 1.0 : y;
  const double closed_f = f_rest / far_y;
  const double f = x < 4.0 ? near_f : closed_f;
  const double four_k = KSL_MUL(4.0, sinc);
  const double b = f / four_k;
  const double b_across = c / sinc;
  const double wt = KSL_MUL((double)D->m03, vector_0) + KSL_MUL((double)D->m13, vector_1)
          + KSL_MUL((double)D->m23, vector_2);
  const double pitch = KSL_MUL(b, wt);
  const double along_0 = KSL_MUL(vector_0, pitch), along_1 = KSL_MUL(vector_1, pitch),
      along_2 = KSL_MUL(vector_2, pitch);
  const double u_0 = KSL_MUL((double)D->m23, vector_1) - KSL_MUL((double)D->m13, vector_2),
      u_1 = KSL_MUL((double)D->m03, vector_2) - KSL_MUL((double)D->m23, vector_0),
      u_2 = KSL_MUL((double)D->m13, vector_0) - KSL_MUL((double)D->m03, vector_1);
  const double turned_0 = KSL_MUL(0.5, u_0), turned_1 = KSL_MUL(0.5, u_1),
      turned_2 = KSL_MUL(0.5, u_2);
  const double across_axis_0 = along_0 - turned_0, across_axis_1 = along_1 - turned_1,
      across_axis_2 = along_2 - turned_2;
  const double so_0 = KSL_MUL((double)D->m03, b_across) + across_axis_0,
      so_1 = KSL_MUL((double)D->m13, b_across) + across_axis_1,
      so_2 = KSL_MUL((double)D->m23, b_across) + across_axis_2;
  so->m0 = (float)so_0;
  so->m1 = (float)so_1;
  so->m2 = (float)so_2;
  so->m3 = (float)vector_0;
  so->m4 = (float)vector_1;
  so->m5 = (float)vector_2;
}

/* M = J_l(s) = Σ ([ad](s))^k / (k+1)!.
   s: screw (v in m/s; ω in rad/s); M: 6×6 operator.
   115 mul, 109 add, 4 div, 1 sqrt, 1 neg, 1 abs, 5 less, 9 select.
   Error <= M: 1 u of its largest component for |ω of s| <= π; searched, not proved.  Each
     component is within 1 ulp as long as its condition is below 1e13; in single precision it is
     the nearest number, except near ties, as long as that is below 1e5; searched, not proved.
     Intermediate sums may overflow where |v| is above 2e306, in single precision 5e36. */
static inline void ksl_SE3f_leftJacobian_accurate(const ksl_screwf_t *s, ksl_mat6x6f_t *M) {
  const double halved_0 = 0.5 * (double)s->m3, halved_1 = 0.5 * (double)s->m4,
      halved_2 = 0.5 * (double)s->m5;
  const double y = KSL_MUL(halved_0, halved_0) + KSL_MUL(halved_1, halved_1)
          + KSL_MUL(halved_2, halved_2);
  const double half_angle = sqrt(y);
  double c; const double sine = ksl_sincos(half_angle, &c);
  const double sinc_divisor = half_angle < 1.4901161193847656e-08 ? 1.4901161193847656e-08
          : half_angle;
  const double sinc_quotient = sine / sinc_divisor;
  const double sinc_b = 1.0 - KSL_MUL(0.16666666666666666, y),
      sinc = half_angle < 1.4901161193847656e-08 ? sinc_b : sinc_quotient;
  const double g1 = KSL_MUL(c, sinc);
  const double g2 = KSL_MUL(0.5, KSL_MUL(sinc, sinc));
  const double rest3 = 1.0 - g1;
  const double x = KSL_MUL(4.0, y);
  const double far_x = x < 1.0 ? 1.0 : x;
  const double closed3 = rest3 / far_x;
  const double series5f = KSL_MUL(x, KSL_MUL(x, 1.1309962886447716e-31
          - KSL_MUL(1.216125041553518e-34, x)) - 9.183689863795546e-29) + 6.446950284384474e-26,
      series5m = KSL_MUL(x, KSL_MUL(x, KSL_MUL(x, KSL_MUL(x, series5f) - 3.868170170630684e-23)
          + 1.9572941063391263e-20) - 8.22063524662433e-18),
      series5s = KSL_MUL(x, KSL_MUL(x, KSL_MUL(x, series5m + 2.8114572543455206e-15)
          - 7.647163731819816e-13) + 1.6059043836821613e-10),
      series5 = KSL_MUL(x, KSL_MUL(x, KSL_MUL(x, series5s - 2.505210838544172e-08)
          + 2.7557319223985893e-06) - 0.0001984126984126984) + 0.008333333333333333;
  const double g3b = 0.16666666666666666 - KSL_MUL(x, series5), g3 = x < 1.0 ? g3b : closed3;
  const double rest4 = 0.5 - g2;
  const double closed4 = rest4 / far_x;
  const double rest5 = 0.16666666666666666 - g3;
  const double closed5 = rest5 / far_x;
  const double series4f = KSL_MUL(x, KSL_MUL(x, 3.279889237069838e-30
          - KSL_MUL(3.7699876288159054e-33, x)) - 2.4795962632247976e-27) + 1.6117375710961184e-24,
      series4m = KSL_MUL(x, KSL_MUL(x, KSL_MUL(x, KSL_MUL(x, series4f) - 8.896791392450574e-22)
          + 4.110317623312165e-19) - 1.5619206968586225e-16),
      series4s = KSL_MUL(x, KSL_MUL(x, KSL_MUL(x, series4m + 4.779477332387385e-14)
          - 1.1470745597729725e-11) + 2.08767569878681e-09),
      series4 = KSL_MUL(x, KSL_MUL(x, KSL_MUL(x, series4s - 2.755731922398589e-07)
          + 2.48015873015873e-05) - 0.001388888888888889) + 0.041666666666666664;
  const double g4 = x < 1.0 ? series4 : closed4;
  const double g5 = x < 1.0 ? series5 : closed5;
  const double rate2 = KSL_MUL(2.0, g4) - g3;
  const double rate3 = KSL_MUL(3.0, g5) - g4;
  const double beta_v_0 = KSL_MUL((double)s->m3, g3), beta_v_1 = KSL_MUL((double)s->m4, g3),
      beta_v_2 = KSL_MUL((double)s->m5, g3);
  const double m_0 = KSL_MUL((double)s->m3, beta_v_0), m_1 = KSL_MUL((double)s->m4, beta_v_1),
      m_2 = KSL_MUL((double)s->m5, beta_v_2), m_3 = KSL_MUL((double)s->m4, beta_v_0),
      m_4 = KSL_MUL((double)s->m5, beta_v_0), m_5 = KSL_MUL((double)s->m5, beta_v_1);
  const double others_0 = m_1 + m_2, others_1 = m_0 + m_2, others_2 = m_0 + m_1;
  const double diagonal0a = 1.0 - others_0, diagonal0b = g1 + m_0,
      diagonal0 = m_0 < others_0 ? diagonal0b : diagonal0a;
  const double diagonal1a = 1.0 - others_1, diagonal1b = g1 + m_1,
      diagonal1 = m_1 < others_1 ? diagonal1b : diagonal1a;
  const double diagonal2a = 1.0 - others_2, diagonal2b = g1 + m_2,
      diagonal2 = m_2 < others_2 ? diagonal2b : diagonal2a;
  const double alpha_v_0 = KSL_MUL((double)s->m3, g2), alpha_v_1 = KSL_MUL((double)s->m4, g2),
      alpha_v_2 = KSL_MUL((double)s->m5, g2);
  const double J_1 = m_3 - alpha_v_2, J_2 = m_4 + alpha_v_1, J_3 = m_3 + alpha_v_2,
      J_5 = m_5 - alpha_v_0, J_6 = m_4 - alpha_v_1, J_7 = m_5 + alpha_v_0;
  const double rate_vw = ksl_product_sum((double)s->m2, (double)s->m5,
      ksl_product_sum((double)s->m1, (double)s->m4, (double)s->m0 * (double)s->m3));
  const double rate_turn = KSL_MUL(rate2, rate_vw);
  const double rate_bend = -KSL_MUL(rate3, rate_vw);
  const double rate_q_0 = KSL_MUL((double)s->m0, g2) + KSL_MUL((double)s->m3, rate_turn),
      rate_q_1 = KSL_MUL((double)s->m1, g2) + KSL_MUL((double)s->m4, rate_turn),
      rate_q_2 = KSL_MUL((double)s->m2, g2) + KSL_MUL((double)s->m5, rate_turn);
  const double rate_beta_v_0 = KSL_MUL((double)s->m0, g3),
      rate_beta_v_1 = KSL_MUL((double)s->m1, g3), rate_beta_v_2 = KSL_MUL((double)s->m2, g3);
  const double rate_bend_w_0 = KSL_MUL((double)s->m3, rate_bend),
      rate_bend_w_1 = KSL_MUL((double)s->m4, rate_bend),
      rate_bend_w_2 = KSL_MUL((double)s->m5, rate_bend);
  const double rate_symmetric_0 = KSL_MUL((double)s->m3, rate_beta_v_1)
          + KSL_MUL((double)s->m4, rate_beta_v_0) - KSL_MUL((double)s->m4, rate_bend_w_0),
      rate_symmetric_1 = KSL_MUL((double)s->m3, rate_beta_v_2)
          + KSL_MUL((double)s->m5, rate_beta_v_0) - KSL_MUL((double)s->m5, rate_bend_w_0),
      rate_symmetric_2 = KSL_MUL((double)s->m4, rate_beta_v_2)
          + KSL_MUL((double)s->m5, rate_beta_v_1) - KSL_MUL((double)s->m5, rate_bend_w_1);
  const double rate_diagonal_0a = KSL_MUL((double)s->m4, rate_bend_w_1),
      rate_diagonal_0b = KSL_MUL((double)s->m5, rate_bend_w_2),
      rate_diagonal_0e = KSL_MUL(2.0 * (double)s->m4, rate_beta_v_1),
      rate_diagonal_0g = KSL_MUL(2.0 * (double)s->m5, rate_beta_v_2),
      rate_diagonal_0 = rate_diagonal_0a + rate_diagonal_0b - (rate_diagonal_0e + rate_diagonal_0g);
  const double rate_diagonal_1a = KSL_MUL((double)s->m3, rate_bend_w_0),
      rate_diagonal_1d = KSL_MUL(2.0 * (double)s->m3, rate_beta_v_0),
      rate_diagonal_1 = rate_diagonal_1a + rate_diagonal_0b - (rate_diagonal_1d + rate_diagonal_0g);
  const double rate_diagonal_2 = rate_diagonal_1a + rate_diagonal_0a
          - (rate_diagonal_1d + rate_diagonal_0e);
  const double M_04 = rate_symmetric_0 - rate_q_2, M_05 = rate_q_1 + rate_symmetric_1,
      M_13 = rate_q_2 + rate_symmetric_0, M_15 = rate_symmetric_2 - rate_q_0,
      M_23 = rate_symmetric_1 - rate_q_1, M_24 = rate_q_0 + rate_symmetric_2;
  M->at[0][0] = (float)diagonal0;
  M->at[1][0] = (float)J_1;
  M->at[2][0] = (float)J_2;
  M->at[3][0] = (float)rate_diagonal_0;
  M->at[4][0] = (float)M_04;
  M->at[5][0] = (float)M_05;
  M->at[0][1] = (float)J_3;
  M->at[1][1] = (float)diagonal1;
  M->at[2][1] = (float)J_5;
  M->at[3][1] = (float)M_13;
  M->at[4][1] = (float)rate_diagonal_1;
  M->at[5][1] = (float)M_15;
  M->at[0][2] = (float)J_6;
  M->at[1][2] = (float)J_7;
  M->at[2][2] = (float)diagonal2;
  M->at[3][2] = (float)M_23;
  M->at[4][2] = (float)M_24;
  M->at[5][2] = (float)rate_diagonal_2;
  M->at[0][3] = (float)0.0;
  M->at[1][3] = (float)0.0;
  M->at[2][3] = (float)0.0;
  M->at[3][3] = (float)diagonal0;
  M->at[4][3] = (float)J_1;
  M->at[5][3] = (float)J_2;
  M->at[0][4] = (float)0.0;
  M->at[1][4] = (float)0.0;
  M->at[2][4] = (float)0.0;
  M->at[3][4] = (float)J_3;
  M->at[4][4] = (float)diagonal1;
  M->at[5][4] = (float)J_5;
  M->at[0][5] = (float)0.0;
  M->at[1][5] = (float)0.0;
  M->at[2][5] = (float)0.0;
  M->at[3][5] = (float)J_6;
  M->at[4][5] = (float)J_7;
  M->at[5][5] = (float)diagonal2;
}

/* M = J_r(s) = Σ (-[ad](s))^k / (k+1)!.
   s: screw (v in m/s; ω in rad/s); M: 6×6 operator.
   115 mul, 109 add, 4 div, 1 sqrt, 16 neg, 1 abs, 5 less, 9 select.
   Error <= M: 1 u of its largest component for |ω of s| <= π; searched, not proved.  Each
     component is within 1 ulp as long as its condition is below 1e13; in single precision it is
     the nearest number, except near ties, as long as that is below 1e5; searched, not proved.
     Intermediate sums may overflow where |v| is above 2e306, in single precision 5e36. */
static inline void ksl_SE3f_rightJacobian_accurate(const ksl_screwf_t *s, ksl_mat6x6f_t *M) {
  const double halved_0 = 0.5 * (double)s->m3, halved_1 = 0.5 * (double)s->m4,
      halved_2 = 0.5 * (double)s->m5;
  const double y = KSL_MUL(halved_0, halved_0) + KSL_MUL(halved_1, halved_1)
          + KSL_MUL(halved_2, halved_2);
  const double half_angle = sqrt(y);
  double c; const double sine = ksl_sincos(half_angle, &c);
  const double sinc_divisor = half_angle < 1.4901161193847656e-08 ? 1.4901161193847656e-08
          : half_angle;
  const double sinc_quotient = sine / sinc_divisor;
  const double sinc_b = 1.0 - KSL_MUL(0.16666666666666666, y),
      sinc = half_angle < 1.4901161193847656e-08 ? sinc_b : sinc_quotient;
  const double g1 = KSL_MUL(c, sinc);
  const double g2 = KSL_MUL(0.5, KSL_MUL(sinc, sinc));
  const double rest3 = 1.0 - g1;
  const double x = KSL_MUL(4.0, y);
  const double far_x = x < 1.0 ? 1.0 : x;
  const double closed3 = rest3 / far_x;
  const double series5f = KSL_MUL(x, KSL_MUL(x, 1.1309962886447716e-31
          - KSL_MUL(1.216125041553518e-34, x)) - 9.183689863795546e-29) + 6.446950284384474e-26,
      series5m = KSL_MUL(x, KSL_MUL(x, KSL_MUL(x, KSL_MUL(x, series5f) - 3.868170170630684e-23)
          + 1.9572941063391263e-20) - 8.22063524662433e-18),
      series5s = KSL_MUL(x, KSL_MUL(x, KSL_MUL(x, series5m + 2.8114572543455206e-15)
          - 7.647163731819816e-13) + 1.6059043836821613e-10),
      series5 = KSL_MUL(x, KSL_MUL(x, KSL_MUL(x, series5s - 2.505210838544172e-08)
          + 2.7557319223985893e-06) - 0.0001984126984126984) + 0.008333333333333333;
  const double g3b = 0.16666666666666666 - KSL_MUL(x, series5), g3 = x < 1.0 ? g3b : closed3;
  const double rest4 = 0.5 - g2;
  const double closed4 = rest4 / far_x;
  const double rest5 = 0.16666666666666666 - g3;
  const double closed5 = rest5 / far_x;
  const double series4f = KSL_MUL(x, KSL_MUL(x, 3.279889237069838e-30
          - KSL_MUL(3.7699876288159054e-33, x)) - 2.4795962632247976e-27) + 1.6117375710961184e-24,
      series4m = KSL_MUL(x, KSL_MUL(x, KSL_MUL(x, KSL_MUL(x, series4f) - 8.896791392450574e-22)
          + 4.110317623312165e-19) - 1.5619206968586225e-16),
      series4s = KSL_MUL(x, KSL_MUL(x, KSL_MUL(x, series4m + 4.779477332387385e-14)
          - 1.1470745597729725e-11) + 2.08767569878681e-09),
      series4 = KSL_MUL(x, KSL_MUL(x, KSL_MUL(x, series4s - 2.755731922398589e-07)
          + 2.48015873015873e-05) - 0.001388888888888889) + 0.041666666666666664;
  const double g4 = x < 1.0 ? series4 : closed4;
  const double g5 = x < 1.0 ? series5 : closed5;
  const double rate2 = KSL_MUL(2.0, g4) - g3;
  const double rate3 = KSL_MUL(3.0, g5) - g4;
  const double beta_v_0 = KSL_MUL((double)s->m3, g3), beta_v_1 = KSL_MUL((double)s->m4, g3),
      beta_v_2 = KSL_MUL((double)s->m5, g3);
  const double m_0 = KSL_MUL((double)s->m3, beta_v_0), m_1 = KSL_MUL((double)s->m4, beta_v_1),
      m_2 = KSL_MUL((double)s->m5, beta_v_2), m_3 = KSL_MUL((double)s->m4, beta_v_0),
      m_4 = KSL_MUL((double)s->m5, beta_v_0), m_5 = KSL_MUL((double)s->m5, beta_v_1);
  const double others_0 = m_1 + m_2, others_1 = m_0 + m_2, others_2 = m_0 + m_1;
  const double diagonal0a = 1.0 - others_0, diagonal0b = g1 + m_0,
      diagonal0 = m_0 < others_0 ? diagonal0b : diagonal0a;
  const double diagonal1a = 1.0 - others_1, diagonal1b = g1 + m_1,
      diagonal1 = m_1 < others_1 ? diagonal1b : diagonal1a;
  const double diagonal2a = 1.0 - others_2, diagonal2b = g1 + m_2,
      diagonal2 = m_2 < others_2 ? diagonal2b : diagonal2a;
  const double alpha_v_0 = -KSL_MUL((double)s->m3, g2), alpha_v_1 = -KSL_MUL((double)s->m4, g2),
      alpha_v_2 = -KSL_MUL((double)s->m5, g2);
  const double J_1 = m_3 - alpha_v_2, J_2 = m_4 + alpha_v_1, J_3 = m_3 + alpha_v_2,
      J_5 = m_5 - alpha_v_0, J_6 = m_4 - alpha_v_1, J_7 = m_5 + alpha_v_0;
  const double rate_vw = ksl_product_sum((double)s->m2, (double)s->m5,
      ksl_product_sum((double)s->m1, (double)s->m4, (double)s->m0 * (double)s->m3));
  const double rate_turn = KSL_MUL(rate2, rate_vw);
  const double rate_bend = -KSL_MUL(rate3, rate_vw);
  const double rate_q_0 = -KSL_MUL((double)s->m0, g2) - KSL_MUL((double)s->m3, rate_turn),
      rate_q_1 = -KSL_MUL((double)s->m1, g2) - KSL_MUL((double)s->m4, rate_turn),
      rate_q_2 = -KSL_MUL((double)s->m2, g2) - KSL_MUL((double)s->m5, rate_turn);
  const double rate_beta_v_0 = -KSL_MUL((double)s->m0, g3),
      rate_beta_v_1 = -KSL_MUL((double)s->m1, g3), rate_beta_v_2 = -KSL_MUL((double)s->m2, g3);
  const double rate_bend_w_0 = -KSL_MUL((double)s->m3, rate_bend),
      rate_bend_w_1 = -KSL_MUL((double)s->m4, rate_bend),
      rate_bend_w_2 = -KSL_MUL((double)s->m5, rate_bend);
  const double rate_symmetric_0 = -KSL_MUL((double)s->m3, rate_beta_v_1)
          - KSL_MUL((double)s->m4, rate_beta_v_0) + KSL_MUL((double)s->m4, rate_bend_w_0),
      rate_symmetric_1 = -KSL_MUL((double)s->m3, rate_beta_v_2)
          - KSL_MUL((double)s->m5, rate_beta_v_0) + KSL_MUL((double)s->m5, rate_bend_w_0),
      rate_symmetric_2 = -KSL_MUL((double)s->m4, rate_beta_v_2)
          - KSL_MUL((double)s->m5, rate_beta_v_1) + KSL_MUL((double)s->m5, rate_bend_w_1);
  const double rate_diagonal_0b = KSL_MUL(2.0 * (double)s->m4, rate_beta_v_1),
      rate_diagonal_0d = KSL_MUL(2.0 * (double)s->m5, rate_beta_v_2),
      rate_diagonal_0f = KSL_MUL((double)s->m4, rate_bend_w_1),
      rate_diagonal_0g = KSL_MUL((double)s->m5, rate_bend_w_2),
      rate_diagonal_0 = rate_diagonal_0b + rate_diagonal_0d - (rate_diagonal_0f + rate_diagonal_0g);
  const double rate_diagonal_1b = KSL_MUL(2.0 * (double)s->m3, rate_beta_v_0),
      rate_diagonal_1d = KSL_MUL((double)s->m3, rate_bend_w_0),
      rate_diagonal_1 = rate_diagonal_1b + rate_diagonal_0d - (rate_diagonal_1d + rate_diagonal_0g);
  const double rate_diagonal_2 = rate_diagonal_1b + rate_diagonal_0b
          - (rate_diagonal_1d + rate_diagonal_0f);
  const double M_04 = rate_symmetric_0 - rate_q_2, M_05 = rate_q_1 + rate_symmetric_1,
      M_13 = rate_q_2 + rate_symmetric_0, M_15 = rate_symmetric_2 - rate_q_0,
      M_23 = rate_symmetric_1 - rate_q_1, M_24 = rate_q_0 + rate_symmetric_2;
  M->at[0][0] = (float)diagonal0;
  M->at[1][0] = (float)J_1;
  M->at[2][0] = (float)J_2;
  M->at[3][0] = (float)rate_diagonal_0;
  M->at[4][0] = (float)M_04;
  M->at[5][0] = (float)M_05;
  M->at[0][1] = (float)J_3;
  M->at[1][1] = (float)diagonal1;
  M->at[2][1] = (float)J_5;
  M->at[3][1] = (float)M_13;
  M->at[4][1] = (float)rate_diagonal_1;
  M->at[5][1] = (float)M_15;
  M->at[0][2] = (float)J_6;
  M->at[1][2] = (float)J_7;
  M->at[2][2] = (float)diagonal2;
  M->at[3][2] = (float)M_23;
  M->at[4][2] = (float)M_24;
  M->at[5][2] = (float)rate_diagonal_2;
  M->at[0][3] = (float)0.0;
  M->at[1][3] = (float)0.0;
  M->at[2][3] = (float)0.0;
  M->at[3][3] = (float)diagonal0;
  M->at[4][3] = (float)J_1;
  M->at[5][3] = (float)J_2;
  M->at[0][4] = (float)0.0;
  M->at[1][4] = (float)0.0;
  M->at[2][4] = (float)0.0;
  M->at[3][4] = (float)J_3;
  M->at[4][4] = (float)diagonal1;
  M->at[5][4] = (float)J_5;
  M->at[0][5] = (float)0.0;
  M->at[1][5] = (float)0.0;
  M->at[2][5] = (float)0.0;
  M->at[3][5] = (float)J_6;
  M->at[4][5] = (float)J_7;
  M->at[5][5] = (float)diagonal2;
}

/* M = J_l(s)^-1; singular where |ω| is a multiple of 2π except 0.
   s: screw (v in m/s; ω in rad/s); M: 6×6 operator.
   101 mul, 91 add, 6 div, 1 sqrt, 7 neg, 1 abs, 5 less, 8 select.
   Error <= M: 1 u of its largest component for |ω of s| <= π; searched, not proved.  Each
     component is within 1 ulp as long as its condition is below 1e13; in single precision it is
     the nearest number, except near ties, as long as that is below 1e5; searched, not proved.
     Intermediate sums may overflow where |v| is above 2e306, in single precision 5e36. */
static inline void ksl_SE3f_leftJacobianInverse_accurate(const ksl_screwf_t *s, ksl_mat6x6f_t *M) {
  const double halved_0 = 0.5 * (double)s->m3, halved_1 = 0.5 * (double)s->m4,
      halved_2 = 0.5 * (double)s->m5;
  const double y = KSL_MUL(halved_0, halved_0) + KSL_MUL(halved_1, halved_1)
          + KSL_MUL(halved_2, halved_2);
  const double half_angle = sqrt(y);
  double c; const double sine = ksl_sincos(half_angle, &c);
  const double sinc_divisor = half_angle < 1.4901161193847656e-08 ? 1.4901161193847656e-08
          : half_angle;
  const double sinc_quotient = sine / sinc_divisor;
  const double sinc_b = 1.0 - KSL_MUL(0.16666666666666666, y),
      sinc = half_angle < 1.4901161193847656e-08 ? sinc_b : sinc_quotient;
  const double series_phi_f = KSL_MUL(y, KSL_MUL(y, 4.116826490666969e-29
          - KSL_MUL(5.107725174524775e-32, y)) - 2.86531123750421e-26) + 1.701994875077501e-23,
      series_phi_m = KSL_MUL(y, KSL_MUL(y, KSL_MUL(y, KSL_MUL(y, series_phi_f)
          - 8.509974375387505e-21) + 3.523129391410427e-18) - 1.1837714755139035e-15),
      series_phi_s = KSL_MUL(y, KSL_MUL(y, KSL_MUL(y, series_phi_m + 3.148832124866983e-13)
          - 6.423617534728645e-11) + 9.635426302092969e-09),
      series_phi_y = KSL_MUL(y, KSL_MUL(y, KSL_MUL(y, series_phi_s - 1.0020843354176687e-06)
          + 6.613756613756614e-05) - 0.002380952380952381),
      series_phi = series_phi_y + 0.03333333333333333;
  const double f_more = KSL_MUL(KSL_MUL(2.0, y), series_phi);
  const double near_f = KSL_MUL(0.3333333333333333, sinc) + KSL_MUL(0.3333333333333333, f_more);
  const double f_rest = sinc - c;
  const double x = KSL_MUL(4.0, y);
  const double far_y = x < 4.0 ? 1.0 : y;
  const double closed_f = f_rest / far_y;
  const double f = x < 4.0 ? near_f : closed_f;
  const double four_k = KSL_MUL(4.0, sinc);
  const double b = f / four_k;
  const double b_across = c / sinc;
  const double beta_v_0 = KSL_MUL((double)s->m3, b), beta_v_1 = KSL_MUL((double)s->m4, b),
      beta_v_2 = KSL_MUL((double)s->m5, b);
  const double m_0 = KSL_MUL((double)s->m3, beta_v_0), m_1 = KSL_MUL((double)s->m4, beta_v_1),
      m_2 = KSL_MUL((double)s->m5, beta_v_2), m_3 = KSL_MUL((double)s->m4, beta_v_0),
      m_4 = KSL_MUL((double)s->m5, beta_v_0), m_5 = KSL_MUL((double)s->m5, beta_v_1);
  const double others_0 = m_1 + m_2, others_1 = m_0 + m_2, others_2 = m_0 + m_1;
  const double diagonal0a = 1.0 - others_0, diagonal0b = b_across + m_0,
      diagonal0 = m_0 < others_0 ? diagonal0b : diagonal0a;
  const double diagonal1a = 1.0 - others_1, diagonal1b = b_across + m_1,
      diagonal1 = m_1 < others_1 ? diagonal1b : diagonal1a;
  const double diagonal2a = 1.0 - others_2, diagonal2b = b_across + m_2,
      diagonal2 = m_2 < others_2 ? diagonal2b : diagonal2a;
  const double alpha_v_0 = -halved_0, alpha_v_1 = -halved_1, alpha_v_2 = -halved_2;
  const double J_1 = m_3 - alpha_v_2, J_2 = m_4 + alpha_v_1, J_3 = m_3 + alpha_v_2,
      J_5 = m_5 - alpha_v_0, J_6 = m_4 - alpha_v_1, J_7 = m_5 + alpha_v_0;
  const double phi_rest = KSL_MUL(3.0, f) - sinc;
  const double twice_y = KSL_MUL(2.0, far_y);
  const double closed_phi = phi_rest / twice_y;
  const double phi = x < 4.0 ? series_phi : closed_phi;
  const double b_rate_above = KSL_MUL(0.5, KSL_MUL(f, f)) - KSL_MUL(sinc, phi);
  const double b_rate_below = KSL_MUL(8.0, KSL_MUL(sinc, sinc));
  const double b_rate = b_rate_above / b_rate_below;
  const double rate_vw = ksl_product_sum((double)s->m2, (double)s->m5,
      ksl_product_sum((double)s->m1, (double)s->m4, (double)s->m0 * (double)s->m3));
  const double rate_bend = -KSL_MUL(b_rate, rate_vw);
  const double rate_q_0 = -(0.5 * (double)s->m0), rate_q_1 = -(0.5 * (double)s->m1),
      rate_q_2 = -(0.5 * (double)s->m2);
  const double rate_beta_v_0 = KSL_MUL((double)s->m0, b), rate_beta_v_1 = KSL_MUL((double)s->m1, b),
      rate_beta_v_2 = KSL_MUL((double)s->m2, b);
  const double rate_bend_w_0 = KSL_MUL((double)s->m3, rate_bend),
      rate_bend_w_1 = KSL_MUL((double)s->m4, rate_bend),
      rate_bend_w_2 = KSL_MUL((double)s->m5, rate_bend);
  const double rate_symmetric_0 = KSL_MUL((double)s->m3, rate_beta_v_1)
          + KSL_MUL((double)s->m4, rate_beta_v_0) - KSL_MUL((double)s->m4, rate_bend_w_0),
      rate_symmetric_1 = KSL_MUL((double)s->m3, rate_beta_v_2)
          + KSL_MUL((double)s->m5, rate_beta_v_0) - KSL_MUL((double)s->m5, rate_bend_w_0),
      rate_symmetric_2 = KSL_MUL((double)s->m4, rate_beta_v_2)
          + KSL_MUL((double)s->m5, rate_beta_v_1) - KSL_MUL((double)s->m5, rate_bend_w_1);
  const double rate_diagonal_0a = KSL_MUL((double)s->m4, rate_bend_w_1),
      rate_diagonal_0b = KSL_MUL((double)s->m5, rate_bend_w_2),
      rate_diagonal_0e = KSL_MUL(2.0 * (double)s->m4, rate_beta_v_1),
      rate_diagonal_0g = KSL_MUL(2.0 * (double)s->m5, rate_beta_v_2),
      rate_diagonal_0 = rate_diagonal_0a + rate_diagonal_0b - (rate_diagonal_0e + rate_diagonal_0g);
  const double rate_diagonal_1a = KSL_MUL((double)s->m3, rate_bend_w_0),
      rate_diagonal_1d = KSL_MUL(2.0 * (double)s->m3, rate_beta_v_0),
      rate_diagonal_1 = rate_diagonal_1a + rate_diagonal_0b - (rate_diagonal_1d + rate_diagonal_0g);
  const double rate_diagonal_2 = rate_diagonal_1a + rate_diagonal_0a
          - (rate_diagonal_1d + rate_diagonal_0e);
  const double M_04 = rate_symmetric_0 - rate_q_2, M_05 = rate_q_1 + rate_symmetric_1,
      M_13 = rate_q_2 + rate_symmetric_0, M_15 = rate_symmetric_2 - rate_q_0,
      M_23 = rate_symmetric_1 - rate_q_1, M_24 = rate_q_0 + rate_symmetric_2;
  M->at[0][0] = (float)diagonal0;
  M->at[1][0] = (float)J_1;
  M->at[2][0] = (float)J_2;
  M->at[3][0] = (float)rate_diagonal_0;
  M->at[4][0] = (float)M_04;
  M->at[5][0] = (float)M_05;
  M->at[0][1] = (float)J_3;
  M->at[1][1] = (float)diagonal1;
  M->at[2][1] = (float)J_5;
  M->at[3][1] = (float)M_13;
  M->at[4][1] = (float)rate_diagonal_1;
  M->at[5][1] = (float)M_15;
  M->at[0][2] = (float)J_6;
  M->at[1][2] = (float)J_7;
  M->at[2][2] = (float)diagonal2;
  M->at[3][2] = (float)M_23;
  M->at[4][2] = (float)M_24;
  M->at[5][2] = (float)rate_diagonal_2;
  M->at[0][3] = (float)0.0;
  M->at[1][3] = (float)0.0;
  M->at[2][3] = (float)0.0;
  M->at[3][3] = (float)diagonal0;
  M->at[4][3] = (float)J_1;
  M->at[5][3] = (float)J_2;
  M->at[0][4] = (float)0.0;
  M->at[1][4] = (float)0.0;
  M->at[2][4] = (float)0.0;
  M->at[3][4] = (float)J_3;
  M->at[4][4] = (float)diagonal1;
  M->at[5][4] = (float)J_5;
  M->at[0][5] = (float)0.0;
  M->at[1][5] = (float)0.0;
  M->at[2][5] = (float)0.0;
  M->at[3][5] = (float)J_6;
  M->at[4][5] = (float)J_7;
  M->at[5][5] = (float)diagonal2;
}

/* M = J_r(s)^-1; singular where |ω| is a multiple of 2π except 0.
   s: screw (v in m/s; ω in rad/s); M: 6×6 operator.
   101 mul, 91 add, 6 div, 1 sqrt, 10 neg, 1 abs, 5 less, 8 select.
   Error <= M: 1 u of its largest component for |ω of s| <= π; searched, not proved.  Each
     component is within 1 ulp as long as its condition is below 1e13; in single precision it is
     the nearest number, except near ties, as long as that is below 1e5; searched, not proved.
     Intermediate sums may overflow where |v| is above 2e306, in single precision 5e36. */
static inline void ksl_SE3f_rightJacobianInverse_accurate(const ksl_screwf_t *s, ksl_mat6x6f_t *M) {
  const double halved_0 = 0.5 * (double)s->m3, halved_1 = 0.5 * (double)s->m4,
      halved_2 = 0.5 * (double)s->m5;
  const double y = KSL_MUL(halved_0, halved_0) + KSL_MUL(halved_1, halved_1)
          + KSL_MUL(halved_2, halved_2);
  const double half_angle = sqrt(y);
  double c; const double sine = ksl_sincos(half_angle, &c);
  const double sinc_divisor = half_angle < 1.4901161193847656e-08 ? 1.4901161193847656e-08
          : half_angle;
  const double sinc_quotient = sine / sinc_divisor;
  const double sinc_b = 1.0 - KSL_MUL(0.16666666666666666, y),
      sinc = half_angle < 1.4901161193847656e-08 ? sinc_b : sinc_quotient;
  const double series_phi_f = KSL_MUL(y, KSL_MUL(y, 4.116826490666969e-29
          - KSL_MUL(5.107725174524775e-32, y)) - 2.86531123750421e-26) + 1.701994875077501e-23,
      series_phi_m = KSL_MUL(y, KSL_MUL(y, KSL_MUL(y, KSL_MUL(y, series_phi_f)
          - 8.509974375387505e-21) + 3.523129391410427e-18) - 1.1837714755139035e-15),
      series_phi_s = KSL_MUL(y, KSL_MUL(y, KSL_MUL(y, series_phi_m + 3.148832124866983e-13)
          - 6.423617534728645e-11) + 9.635426302092969e-09),
      series_phi_y = KSL_MUL(y, KSL_MUL(y, KSL_MUL(y, series_phi_s - 1.0020843354176687e-06)
          + 6.613756613756614e-05) - 0.002380952380952381),
      series_phi = series_phi_y + 0.03333333333333333;
  const double f_more = KSL_MUL(KSL_MUL(2.0, y), series_phi);
  const double near_f = KSL_MUL(0.3333333333333333, sinc) + KSL_MUL(0.3333333333333333, f_more);
  const double f_rest = sinc - c;
  const double x = KSL_MUL(4.0, y);
  const double far_y = x < 4.0 ? 1.0 : y;
  const double closed_f = f_rest / far_y;
  const double f = x < 4.0 ? near_f : closed_f;
  const double four_k = KSL_MUL(4.0, sinc);
  const double b = f / four_k;
  const double b_across = c / sinc;
  const double beta_v_0 = KSL_MUL((double)s->m3, b), beta_v_1 = KSL_MUL((double)s->m4, b),
      beta_v_2 = KSL_MUL((double)s->m5, b);
  const double m_0 = KSL_MUL((double)s->m3, beta_v_0), m_1 = KSL_MUL((double)s->m4, beta_v_1),
      m_2 = KSL_MUL((double)s->m5, beta_v_2), m_3 = KSL_MUL((double)s->m4, beta_v_0),
      m_4 = KSL_MUL((double)s->m5, beta_v_0), m_5 = KSL_MUL((double)s->m5, beta_v_1);
  const double others_0 = m_1 + m_2, others_1 = m_0 + m_2, others_2 = m_0 + m_1;
  const double diagonal0a = 1.0 - others_0, diagonal0b = b_across + m_0,
      diagonal0 = m_0 < others_0 ? diagonal0b : diagonal0a;
  const double diagonal1a = 1.0 - others_1, diagonal1b = b_across + m_1,
      diagonal1 = m_1 < others_1 ? diagonal1b : diagonal1a;
  const double diagonal2a = 1.0 - others_2, diagonal2b = b_across + m_2,
      diagonal2 = m_2 < others_2 ? diagonal2b : diagonal2a;
  const double J_1 = m_3 - halved_2, J_2 = halved_1 + m_4, J_3 = halved_2 + m_3,
      J_5 = m_5 - halved_0, J_6 = m_4 - halved_1, J_7 = halved_0 + m_5;
  const double phi_rest = KSL_MUL(3.0, f) - sinc;
  const double twice_y = KSL_MUL(2.0, far_y);
  const double closed_phi = phi_rest / twice_y;
  const double phi = x < 4.0 ? series_phi : closed_phi;
  const double b_rate_above = KSL_MUL(0.5, KSL_MUL(f, f)) - KSL_MUL(sinc, phi);
  const double b_rate_below = KSL_MUL(8.0, KSL_MUL(sinc, sinc));
  const double b_rate = b_rate_above / b_rate_below;
  const double rate_vw = ksl_product_sum((double)s->m2, (double)s->m5,
      ksl_product_sum((double)s->m1, (double)s->m4, (double)s->m0 * (double)s->m3));
  const double rate_bend = -KSL_MUL(b_rate, rate_vw);
  const double rate_q_0 = 0.5 * (double)s->m0, rate_q_1 = 0.5 * (double)s->m1,
      rate_q_2 = 0.5 * (double)s->m2;
  const double rate_beta_v_0 = -KSL_MUL((double)s->m0, b),
      rate_beta_v_1 = -KSL_MUL((double)s->m1, b), rate_beta_v_2 = -KSL_MUL((double)s->m2, b);
  const double rate_bend_w_0 = -KSL_MUL((double)s->m3, rate_bend),
      rate_bend_w_1 = -KSL_MUL((double)s->m4, rate_bend),
      rate_bend_w_2 = -KSL_MUL((double)s->m5, rate_bend);
  const double rate_symmetric_0 = -KSL_MUL((double)s->m3, rate_beta_v_1)
          - KSL_MUL((double)s->m4, rate_beta_v_0) + KSL_MUL((double)s->m4, rate_bend_w_0),
      rate_symmetric_1 = -KSL_MUL((double)s->m3, rate_beta_v_2)
          - KSL_MUL((double)s->m5, rate_beta_v_0) + KSL_MUL((double)s->m5, rate_bend_w_0),
      rate_symmetric_2 = -KSL_MUL((double)s->m4, rate_beta_v_2)
          - KSL_MUL((double)s->m5, rate_beta_v_1) + KSL_MUL((double)s->m5, rate_bend_w_1);
  const double rate_diagonal_0b = KSL_MUL(2.0 * (double)s->m4, rate_beta_v_1),
      rate_diagonal_0d = KSL_MUL(2.0 * (double)s->m5, rate_beta_v_2),
      rate_diagonal_0f = KSL_MUL((double)s->m4, rate_bend_w_1),
      rate_diagonal_0g = KSL_MUL((double)s->m5, rate_bend_w_2),
      rate_diagonal_0 = rate_diagonal_0b + rate_diagonal_0d - (rate_diagonal_0f + rate_diagonal_0g);
  const double rate_diagonal_1b = KSL_MUL(2.0 * (double)s->m3, rate_beta_v_0),
      rate_diagonal_1d = KSL_MUL((double)s->m3, rate_bend_w_0),
      rate_diagonal_1 = rate_diagonal_1b + rate_diagonal_0d - (rate_diagonal_1d + rate_diagonal_0g);
  const double rate_diagonal_2 = rate_diagonal_1b + rate_diagonal_0b
          - (rate_diagonal_1d + rate_diagonal_0f);
  const double M_04 = rate_symmetric_0 - rate_q_2, M_05 = rate_q_1 + rate_symmetric_1,
      M_13 = rate_q_2 + rate_symmetric_0, M_15 = rate_symmetric_2 - rate_q_0,
      M_23 = rate_symmetric_1 - rate_q_1, M_24 = rate_q_0 + rate_symmetric_2;
  M->at[0][0] = (float)diagonal0;
  M->at[1][0] = (float)J_1;
  M->at[2][0] = (float)J_2;
  M->at[3][0] = (float)rate_diagonal_0;
  M->at[4][0] = (float)M_04;
  M->at[5][0] = (float)M_05;
  M->at[0][1] = (float)J_3;
  M->at[1][1] = (float)diagonal1;
  M->at[2][1] = (float)J_5;
  M->at[3][1] = (float)M_13;
  M->at[4][1] = (float)rate_diagonal_1;
  M->at[5][1] = (float)M_15;
  M->at[0][2] = (float)J_6;
  M->at[1][2] = (float)J_7;
  M->at[2][2] = (float)diagonal2;
  M->at[3][2] = (float)M_23;
  M->at[4][2] = (float)M_24;
  M->at[5][2] = (float)rate_diagonal_2;
  M->at[0][3] = (float)0.0;
  M->at[1][3] = (float)0.0;
  M->at[2][3] = (float)0.0;
  M->at[3][3] = (float)diagonal0;
  M->at[4][3] = (float)J_1;
  M->at[5][3] = (float)J_2;
  M->at[0][4] = (float)0.0;
  M->at[1][4] = (float)0.0;
  M->at[2][4] = (float)0.0;
  M->at[3][4] = (float)J_3;
  M->at[4][4] = (float)diagonal1;
  M->at[5][4] = (float)J_5;
  M->at[0][5] = (float)0.0;
  M->at[1][5] = (float)0.0;
  M->at[2][5] = (float)0.0;
  M->at[3][5] = (float)J_6;
  M->at[4][5] = (float)J_7;
  M->at[5][5] = (float)diagonal2;
}

/* Do = D1 exp(k log(D1^-1 D2)), the screw motion from D1 at k = 0 to D2 at k = 1.
   D1, D2, Do: displacement [R | t], R rotation, t in m; k: number.
   247 mul, 211 add, 10 div, 3 sqrt, 5 neg, 7 abs, 2 copysign, 25 less, 2 equal, 49 select.
   Error <= R: 1 u, t: 1 u of its largest component, or of D1.t or D2.t if that is larger, for R
     of D1 a rotation and R of D2 a rotation and 0 <= k <= 1; searched, not proved.  Each
     component is within 1 ulp as long as its condition is below 1e13; in single precision it is
     the nearest number, except near ties, as long as that is below 1e5; searched, not proved.
     Intermediate sums may overflow where |t| of D1 or D2 is above 2e306, in single precision
     5e36. */
static inline void ksl_SE3f_interpolated_accurate(const ksl_SE3f_t *D1, const ksl_SE3f_t *D2,
    const float k, ksl_SE3f_t *Do) {
  const double apart_0 = (double)D2->m03 - (double)D1->m03,
      apart_1 = (double)D2->m13 - (double)D1->m13, apart_2 = (double)D2->m23 - (double)D1->m23;
  const double between_0 = ksl_product_sum((double)D1->m20, (double)D2->m20,
      ksl_product_sum((double)D1->m10, (double)D2->m10, (double)D1->m00 * (double)D2->m00)),
      between_1 = ksl_product_sum((double)D1->m20, (double)D2->m21, ksl_product_sum((double)D1->m10,
          (double)D2->m11, (double)D1->m00 * (double)D2->m01)),
      between_2 = ksl_product_sum((double)D1->m20, (double)D2->m22, ksl_product_sum((double)D1->m10,
          (double)D2->m12, (double)D1->m00 * (double)D2->m02)),
      between_3 = KSL_MUL((double)D1->m00, apart_0) + KSL_MUL((double)D1->m10, apart_1)
          + KSL_MUL((double)D1->m20, apart_2),
      between_4 = ksl_product_sum((double)D1->m21, (double)D2->m20, ksl_product_sum((double)D1->m11,
          (double)D2->m10, (double)D1->m01 * (double)D2->m00)),
      between_5 = ksl_product_sum((double)D1->m21, (double)D2->m21, ksl_product_sum((double)D1->m11,
          (double)D2->m11, (double)D1->m01 * (double)D2->m01)),
      between_6 = ksl_product_sum((double)D1->m21, (double)D2->m22, ksl_product_sum((double)D1->m11,
          (double)D2->m12, (double)D1->m01 * (double)D2->m02)),
      between_7 = KSL_MUL((double)D1->m01, apart_0) + KSL_MUL((double)D1->m11, apart_1)
          + KSL_MUL((double)D1->m21, apart_2),
      between_8 = ksl_product_sum((double)D1->m22, (double)D2->m20, ksl_product_sum((double)D1->m12,
          (double)D2->m10, (double)D1->m02 * (double)D2->m00)),
      between_9 = ksl_product_sum((double)D1->m22, (double)D2->m21, ksl_product_sum((double)D1->m12,
          (double)D2->m11, (double)D1->m02 * (double)D2->m01)),
      between_10 = ksl_product_sum((double)D1->m22, (double)D2->m22,
          ksl_product_sum((double)D1->m12, (double)D2->m12, (double)D1->m02 * (double)D2->m02)),
      between_11 = KSL_MUL((double)D1->m02, apart_0) + KSL_MUL((double)D1->m12, apart_1)
          + KSL_MUL((double)D1->m22, apart_2);
  const double log_p_0 = between_9 - between_6, log_p_1 = between_2 - between_8,
      log_p_2 = between_4 - between_1;
  const double log_s_0 = between_6 + between_9, log_s_1 = between_2 + between_8,
      log_s_2 = between_1 + between_4;
  const double log_first_0 = between_0 + 1.0, log_first_1 = 1.0 - between_0;
  const double log_others_0 = between_5 + between_10, log_others_1 = between_5 - between_10;
  const double log_d_0 = log_first_0 + log_others_0, log_d_1 = log_first_0 - log_others_0,
      log_d_2 = log_first_1 + log_others_1, log_d_3 = log_first_1 - log_others_1;
  const double log_low_0 = between_5 < between_0 ? log_d_1 : log_s_2,
      log_low_1 = between_5 < between_0 ? log_s_2 : log_d_2,
      log_low_2 = between_5 < between_0 ? log_s_1 : log_s_0,
      log_low_3 = between_5 < between_0 ? log_p_0 : log_p_1;
  const double log_high_0a = -between_5, log_high_0 = between_0 < log_high_0a ? log_s_1 : log_p_0;
  const double log_high_1 = between_0 < log_high_0a ? log_s_0 : log_p_1,
      log_high_2 = between_0 < log_high_0a ? log_d_3 : log_p_2,
      log_high_3 = between_0 < log_high_0a ? log_p_2 : log_d_0;
  const double log_column_0 = between_10 < 0.0 ? log_low_0 : log_high_0,
      log_column_1 = between_10 < 0.0 ? log_low_1 : log_high_1,
      log_column_2 = between_10 < 0.0 ? log_low_2 : log_high_2,
      log_column_3 = between_10 < 0.0 ? log_low_3 : log_high_3;
  const double log_upper_0a = -log_column_0,
      log_upper_0 = log_column_3 < 0.0 ? log_upper_0a : log_column_0;
  const double log_upper_1a = -log_column_1,
      log_upper_1 = log_column_3 < 0.0 ? log_upper_1a : log_column_1;
  const double log_upper_2a = -log_column_2,
      log_upper_2 = log_column_3 < 0.0 ? log_upper_2a : log_column_2;
  const double log_upper_3 = fabs(log_column_3);
  const double log_v_s_size_0 = fabs(log_upper_0), log_v_s_size_1 = fabs(log_upper_1),
      log_v_s_size_2 = fabs(log_upper_2);
  const double log_v_s_largest1 = log_v_s_size_0 < log_v_s_size_1 ? log_v_s_size_1 : log_v_s_size_0;
  const double log_v_s_largest2 = log_v_s_largest1 < log_v_s_size_2 ? log_v_s_size_2
          : log_v_s_largest1;
  const double log_v_s_b = 4.611686018427388e+18 < log_v_s_largest2 ? 2.710505431213761e-20 : 1.0,
      log_v_s_d = log_v_s_largest2 < 256.0 ? 1.8014398509481984e+16 : log_v_s_b,
      log_v_s = log_v_s_largest2 < 1.4210854715202004e-14 ? 3.2451855365842673e+32 : log_v_s_d;
  const double log_v_y_0 = KSL_MUL(log_upper_0, log_v_s), log_v_y_1 = KSL_MUL(log_upper_1, log_v_s),
      log_v_y_2 = KSL_MUL(log_upper_2, log_v_s);
  const double log_v_n = sqrt(KSL_MUL(log_v_y_0, log_v_y_0) + KSL_MUL(log_v_y_1, log_v_y_1)
          + KSL_MUL(log_v_y_2, log_v_y_2));
  const double log_v_r_b = log_v_s < 1.0 ? 3.6893488147419103e+19 : 1.0,
      log_v_r_d = 1.0 < log_v_s ? 5.551115123125783e-17 : log_v_r_b,
      log_v_r = 1.8014398509481984e+16 < log_v_s ? 3.0814879110195774e-33 : log_v_r_d;
  const double log_n = KSL_MUL(log_v_n, log_v_r);
  const double log_half = ksl_atan2(log_n, log_upper_3);
  const double log_divisor = log_n == 0.0 ? 1.0 : log_n;
  const double log_theta = KSL_MUL(2.0, log_half);
  const double log_k = log_theta / log_divisor;
  const double log_vector_0 = KSL_MUL(log_upper_0, log_k),
      log_vector_1 = KSL_MUL(log_upper_1, log_k), log_vector_2 = KSL_MUL(log_upper_2, log_k);
  const double log_half_angle = KSL_MUL(0.5, log_theta);
  const double log_length = sqrt(KSL_MUL(log_n, log_n) + KSL_MUL(log_upper_3, log_upper_3));
  const double log_sine = log_n / log_length;
  const double log_c = log_upper_3 / log_length;
  const double log_y = KSL_MUL(log_half_angle, log_half_angle);
  const double log_sinc_divisor = log_half_angle < 1.4901161193847656e-08 ? 1.4901161193847656e-08
          : log_half_angle;
  const double log_sinc_quotient = log_sine / log_sinc_divisor;
  const double log_sinc_b = 1.0 - KSL_MUL(0.16666666666666666, log_y),
      log_sinc = log_half_angle < 1.4901161193847656e-08 ? log_sinc_b : log_sinc_quotient;
  const double log_series_phi_e = KSL_MUL(log_y, KSL_MUL(log_y, 4.116826490666969e-29
          - KSL_MUL(5.107725174524775e-32, log_y)) - 2.86531123750421e-26),
      log_series_phi_j = KSL_MUL(log_y, KSL_MUL(log_y, log_series_phi_e + 1.701994875077501e-23)
          - 8.509974375387505e-21) + 3.523129391410427e-18,
      log_series_phi_o = KSL_MUL(log_y, KSL_MUL(log_y, KSL_MUL(log_y, log_series_phi_j)
          - 1.1837714755139035e-15) + 3.148832124866983e-13),
      log_series_phi_t = KSL_MUL(log_y, KSL_MUL(log_y, log_series_phi_o - 6.423617534728645e-11)
          + 9.635426302092969e-09) - 1.0020843354176687e-06,
      log_series_phi = KSL_MUL(log_y, KSL_MUL(log_y, KSL_MUL(log_y, log_series_phi_t)
          + 6.613756613756614e-05) - 0.002380952380952381) + 0.03333333333333333;
  const double log_f_more = KSL_MUL(KSL_MUL(2.0, log_y), log_series_phi);
  const double log_near_f = KSL_MUL(0.3333333333333333, log_sinc)
          + KSL_MUL(0.3333333333333333, log_f_more);
  const double log_f_rest = log_sinc - log_c;
  const double log_x = KSL_MUL(4.0, log_y);
  const double log_far_y = log_x < 4.0 ? 1.0 : log_y;
  const double log_closed_f = log_f_rest / log_far_y;
  const double log_f = log_x < 4.0 ? log_near_f : log_closed_f;
  const double log_four_k = KSL_MUL(4.0, log_sinc);
  const double log_b = log_f / log_four_k;
  const double log_b_across = log_c / log_sinc;
  const double log_wt = KSL_MUL(between_3, log_vector_0) + KSL_MUL(between_7, log_vector_1)
          + KSL_MUL(between_11, log_vector_2);
  const double log_pitch = KSL_MUL(log_b, log_wt);
  const double log_along_0 = KSL_MUL(log_vector_0, log_pitch),
      log_along_1 = KSL_MUL(log_vector_1, log_pitch),
      log_along_2 = KSL_MUL(log_vector_2, log_pitch);
  const double log_u_0 = KSL_MUL(between_11, log_vector_1) - KSL_MUL(between_7, log_vector_2),
      log_u_1 = KSL_MUL(between_3, log_vector_2) - KSL_MUL(between_11, log_vector_0),
      log_u_2 = KSL_MUL(between_7, log_vector_0) - KSL_MUL(between_3, log_vector_1);
  const double log_turned_0 = KSL_MUL(0.5, log_u_0), log_turned_1 = KSL_MUL(0.5, log_u_1),
      log_turned_2 = KSL_MUL(0.5, log_u_2);
  const double log_across_axis_0 = log_along_0 - log_turned_0,
      log_across_axis_1 = log_along_1 - log_turned_1,
      log_across_axis_2 = log_along_2 - log_turned_2;
  const double whole_0 = KSL_MUL(between_3, log_b_across) + log_across_axis_0,
      whole_1 = KSL_MUL(between_7, log_b_across) + log_across_axis_1,
      whole_2 = KSL_MUL(between_11, log_b_across) + log_across_axis_2;
  const double screw_0 = KSL_MUL((double)k, whole_0), screw_1 = KSL_MUL((double)k, whole_1),
      screw_2 = KSL_MUL((double)k, whole_2), screw_3 = KSL_MUL((double)k, log_vector_0),
      screw_4 = KSL_MUL((double)k, log_vector_1), screw_5 = KSL_MUL((double)k, log_vector_2);
  const double exp_halved_0 = KSL_MUL(0.5, screw_3), exp_halved_1 = KSL_MUL(0.5, screw_4),
      exp_halved_2 = KSL_MUL(0.5, screw_5);
  const double exp_y = KSL_MUL(exp_halved_0, exp_halved_0) + KSL_MUL(exp_halved_1, exp_halved_1)
          + KSL_MUL(exp_halved_2, exp_halved_2);
  const double exp_half_angle = sqrt(exp_y);
  double exp_c; const double exp_sine = ksl_sincos(exp_half_angle, &exp_c);
  const double exp_sinc_divisor = exp_half_angle < 1.4901161193847656e-08 ? 1.4901161193847656e-08
          : exp_half_angle;
  const double exp_sinc_quotient = exp_sine / exp_sinc_divisor;
  const double exp_sinc_b = 1.0 - KSL_MUL(0.16666666666666666, exp_y),
      exp_sinc = exp_half_angle < 1.4901161193847656e-08 ? exp_sinc_b : exp_sinc_quotient;
  const double exp_g1 = KSL_MUL(exp_c, exp_sinc);
  const double exp_g2 = KSL_MUL(0.5, KSL_MUL(exp_sinc, exp_sinc));
  const double exp_sine_square = KSL_MUL(exp_sine, exp_sine);
  const double exp_g0 = 1.0 - KSL_MUL(2.0, exp_sine_square);
  const double exp_rest3 = 1.0 - exp_g1;
  const double exp_x = KSL_MUL(4.0, exp_y);
  const double exp_far_x = exp_x < 1.0 ? 1.0 : exp_x;
  const double exp_closed3 = exp_rest3 / exp_far_x;
  const double exp_series5e = KSL_MUL(exp_x, KSL_MUL(exp_x, 1.1309962886447716e-31
          - KSL_MUL(1.216125041553518e-34, exp_x)) - 9.183689863795546e-29),
      exp_series5k = KSL_MUL(exp_x, KSL_MUL(exp_x, KSL_MUL(exp_x, exp_series5e
          + 6.446950284384474e-26) - 3.868170170630684e-23) + 1.9572941063391263e-20),
      exp_series5q = KSL_MUL(exp_x, KSL_MUL(exp_x, KSL_MUL(exp_x, exp_series5k
          - 8.22063524662433e-18) + 2.8114572543455206e-15) - 7.647163731819816e-13),
      exp_series5w = KSL_MUL(exp_x, KSL_MUL(exp_x, KSL_MUL(exp_x, exp_series5q
          + 1.6059043836821613e-10) - 2.505210838544172e-08) + 2.7557319223985893e-06),
      exp_series5 = KSL_MUL(exp_x, exp_series5w - 0.0001984126984126984) + 0.008333333333333333;
  const double exp_g3b = 0.16666666666666666 - KSL_MUL(exp_x, exp_series5),
      exp_g3 = exp_x < 1.0 ? exp_g3b : exp_closed3;
  const double exp_u_0 = KSL_MUL(screw_2, screw_4) - KSL_MUL(screw_1, screw_5),
      exp_u_1 = KSL_MUL(screw_0, screw_5) - KSL_MUL(screw_2, screw_3),
      exp_u_2 = KSL_MUL(screw_1, screw_3) - KSL_MUL(screw_0, screw_4);
  const double exp_turned_0 = KSL_MUL(exp_g2, exp_u_0), exp_turned_1 = KSL_MUL(exp_g2, exp_u_1),
      exp_turned_2 = KSL_MUL(exp_g2, exp_u_2);
  const double exp_wv = KSL_MUL(screw_0, screw_3) + KSL_MUL(screw_1, screw_4)
          + KSL_MUL(screw_2, screw_5);
  const double exp_pitch = KSL_MUL(exp_g3, exp_wv);
  const double exp_along_0 = KSL_MUL(screw_3, exp_pitch), exp_along_1 = KSL_MUL(screw_4, exp_pitch),
      exp_along_2 = KSL_MUL(screw_5, exp_pitch);
  const double exp_beta_v_0 = KSL_MUL(screw_3, exp_g2), exp_beta_v_1 = KSL_MUL(screw_4, exp_g2),
      exp_beta_v_2 = KSL_MUL(screw_5, exp_g2);
  const double exp_m_0 = KSL_MUL(screw_3, exp_beta_v_0), exp_m_1 = KSL_MUL(screw_4, exp_beta_v_1),
      exp_m_2 = KSL_MUL(screw_5, exp_beta_v_2), exp_m_3 = KSL_MUL(screw_4, exp_beta_v_0),
      exp_m_4 = KSL_MUL(screw_5, exp_beta_v_0), exp_m_5 = KSL_MUL(screw_5, exp_beta_v_1);
  const double exp_others_0 = exp_m_1 + exp_m_2, exp_others_1 = exp_m_0 + exp_m_2,
      exp_others_2 = exp_m_0 + exp_m_1;
  const double exp_diagonal0a = 1.0 - exp_others_0, exp_diagonal0b = exp_g0 + exp_m_0,
      exp_diagonal0 = exp_m_0 < exp_others_0 ? exp_diagonal0b : exp_diagonal0a;
  const double exp_diagonal1a = 1.0 - exp_others_1, exp_diagonal1b = exp_g0 + exp_m_1,
      exp_diagonal1 = exp_m_1 < exp_others_1 ? exp_diagonal1b : exp_diagonal1a;
  const double exp_diagonal2a = 1.0 - exp_others_2, exp_diagonal2b = exp_g0 + exp_m_2,
      exp_diagonal2 = exp_m_2 < exp_others_2 ? exp_diagonal2b : exp_diagonal2a;
  const double exp_alpha_v_0 = KSL_MUL(screw_3, exp_g1), exp_alpha_v_1 = KSL_MUL(screw_4, exp_g1),
      exp_alpha_v_2 = KSL_MUL(screw_5, exp_g1);
  const double exp_across_axis_0 = exp_turned_0 + exp_along_0,
      exp_across_axis_1 = exp_turned_1 + exp_along_1,
      exp_across_axis_2 = exp_turned_2 + exp_along_2;
  const double step_1 = exp_m_3 - exp_alpha_v_2, step_2 = exp_m_4 + exp_alpha_v_1,
      step_3 = KSL_MUL(screw_0, exp_g1) + exp_across_axis_0, step_4 = exp_m_3 + exp_alpha_v_2,
      step_6 = exp_m_5 - exp_alpha_v_0, step_7 = KSL_MUL(screw_1, exp_g1) + exp_across_axis_1,
      step_8 = exp_m_4 - exp_alpha_v_1, step_9 = exp_m_5 + exp_alpha_v_0,
      step_11 = KSL_MUL(screw_2, exp_g1) + exp_across_axis_2;
  const double Do_00 = KSL_MUL((double)D1->m00, exp_diagonal0)
          + (KSL_MUL((double)D1->m01, step_4) + KSL_MUL((double)D1->m02, step_8)),
      Do_01 = KSL_MUL((double)D1->m00, step_1) + KSL_MUL((double)D1->m02, step_9)
          + KSL_MUL((double)D1->m01, exp_diagonal1),
      Do_02 = KSL_MUL((double)D1->m00, step_2) + KSL_MUL((double)D1->m01, step_6)
          + KSL_MUL((double)D1->m02, exp_diagonal2),
      Do_03 = KSL_MUL((double)D1->m00, step_3) + KSL_MUL((double)D1->m01, step_7)
          + KSL_MUL((double)D1->m02, step_11) + (double)D1->m03,
      Do_10 = KSL_MUL((double)D1->m10, exp_diagonal0)
          + (KSL_MUL((double)D1->m11, step_4) + KSL_MUL((double)D1->m12, step_8)),
      Do_11 = KSL_MUL((double)D1->m10, step_1) + KSL_MUL((double)D1->m12, step_9)
          + KSL_MUL((double)D1->m11, exp_diagonal1),
      Do_12 = KSL_MUL((double)D1->m10, step_2) + KSL_MUL((double)D1->m11, step_6)
          + KSL_MUL((double)D1->m12, exp_diagonal2),
      Do_13 = KSL_MUL((double)D1->m10, step_3) + KSL_MUL((double)D1->m11, step_7)
          + KSL_MUL((double)D1->m12, step_11) + (double)D1->m13,
      Do_20 = KSL_MUL((double)D1->m20, exp_diagonal0)
          + (KSL_MUL((double)D1->m21, step_4) + KSL_MUL((double)D1->m22, step_8)),
      Do_21 = KSL_MUL((double)D1->m20, step_1) + KSL_MUL((double)D1->m22, step_9)
          + KSL_MUL((double)D1->m21, exp_diagonal1),
      Do_22 = KSL_MUL((double)D1->m20, step_2) + KSL_MUL((double)D1->m21, step_6)
          + KSL_MUL((double)D1->m22, exp_diagonal2),
      Do_23 = KSL_MUL((double)D1->m20, step_3) + KSL_MUL((double)D1->m21, step_7)
          + KSL_MUL((double)D1->m22, step_11) + (double)D1->m23;
  Do->m00 = (float)Do_00;
  Do->m01 = (float)Do_01;
  Do->m02 = (float)Do_02;
  Do->m03 = (float)Do_03;
  Do->m10 = (float)Do_10;
  Do->m11 = (float)Do_11;
  Do->m12 = (float)Do_12;
  Do->m13 = (float)Do_13;
  Do->m20 = (float)Do_20;
  Do->m21 = (float)Do_21;
  Do->m22 = (float)Do_22;
  Do->m23 = (float)Do_23;
}

#endif
