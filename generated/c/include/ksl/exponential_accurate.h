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
  const double halved_0 = KSL_MUL(0.5, v->x);
  const double halved_1 = KSL_MUL(0.5, v->y);
  const double halved_2 = KSL_MUL(0.5, v->z);
  const double h_size_0 = fabs(halved_0);
  const double h_size_1 = fabs(halved_1);
  const double h_size_2 = fabs(halved_2);
  const double h_largest1 = h_size_0 < h_size_1 ? h_size_1 : h_size_0;
  const double h_largest2 = h_largest1 < h_size_2 ? h_size_2 : h_largest1;
  const double s = 6.703903964971299e+153 < h_largest2 ? 3.7291703656001034e-155 : 1.0;
  const double reduced_0 = KSL_MUL(halved_0, s);
  const double reduced_1 = KSL_MUL(halved_1, s);
  const double reduced_2 = KSL_MUL(halved_2, s);
  const double up = s < 1.0 ? 2.6815615859885194e+154 : 1.0;
  const double reduced_length_a = KSL_MUL(reduced_0, reduced_0),
      reduced_length_b = KSL_MUL(reduced_1, reduced_1),
      reduced_length_c = reduced_length_a + reduced_length_b,
      reduced_length_c_right = reduced_length_c - reduced_length_a,
      reduced_length_c_left = reduced_length_c - reduced_length_c_right,
      reduced_length_c_left_rest = ksl_product_rest(reduced_0, reduced_0, reduced_length_a,
          reduced_length_c_left),
      reduced_length_c_right_rest = ksl_product_rest(reduced_1, reduced_1, reduced_length_b,
          reduced_length_c_right),
      reduced_length_c_lo = reduced_length_c_left_rest + reduced_length_c_right_rest,
      reduced_length_d = KSL_MUL(reduced_2, reduced_2),
      reduced_length_e = reduced_length_c + reduced_length_d,
      reduced_length_e_right = reduced_length_e - reduced_length_c,
      reduced_length_e_left = reduced_length_e - reduced_length_e_right,
      reduced_length_e_left_rest = reduced_length_c - reduced_length_e_left,
      reduced_length_e_right_rest = ksl_product_rest(reduced_2, reduced_2, reduced_length_d,
          reduced_length_e_right),
      reduced_length_e_lo1 = reduced_length_e_left_rest + reduced_length_e_right_rest,
      reduced_length_e_lo = reduced_length_e_lo1 + reduced_length_c_lo,
      reduced_length_of_reduced_length_e = reduced_length_e + reduced_length_e_lo,
      reduced_length_of_reduced_length_e_right = reduced_length_of_reduced_length_e -
          reduced_length_e,
      reduced_length_of_reduced_length_e_left = reduced_length_of_reduced_length_e -
          reduced_length_of_reduced_length_e_right,
      reduced_length_of_reduced_length_e_left_rest = reduced_length_e -
          reduced_length_of_reduced_length_e_left,
      reduced_length_of_reduced_length_e_right_rest = reduced_length_e_lo -
          reduced_length_of_reduced_length_e_right,
      reduced_length_of_reduced_length_e_lo = reduced_length_of_reduced_length_e_left_rest +
          reduced_length_of_reduced_length_e_right_rest,
      reduced_length = sqrt(reduced_length_of_reduced_length_e),
      reduced_length_product = KSL_MUL(reduced_length, reduced_length),
      reduced_length_product_error = ksl_product_error(reduced_length, reduced_length,
          reduced_length_product),
      reduced_length_rest = reduced_length_of_reduced_length_e - reduced_length_product,
      reduced_length_exact = reduced_length_rest - reduced_length_product_error,
      reduced_length_residual = reduced_length_exact + reduced_length_of_reduced_length_e_lo,
      reduced_length_twice = reduced_length + reduced_length,
      reduced_length_divisor = reduced_length == 0.0 ? 1.0 : reduced_length_twice,
      reduced_length_lo = reduced_length_residual / reduced_length_divisor;
  const double half_angle_of_reduced_length = reduced_length + reduced_length_lo,
      half_angle_of_reduced_length_right = half_angle_of_reduced_length - reduced_length,
      half_angle_of_reduced_length_left = half_angle_of_reduced_length -
          half_angle_of_reduced_length_right,
      half_angle_of_reduced_length_left_rest = reduced_length - half_angle_of_reduced_length_left,
      half_angle_of_reduced_length_right_rest = reduced_length_lo -
          half_angle_of_reduced_length_right,
      half_angle_of_reduced_length_lo = half_angle_of_reduced_length_left_rest +
          half_angle_of_reduced_length_right_rest,
      half_angle = KSL_MUL(half_angle_of_reduced_length, up), half_angle_inverse = 1.0 / up,
      half_angle_back = KSL_MUL(half_angle, half_angle_inverse),
      half_angle_lost = half_angle_of_reduced_length - half_angle_back,
      half_angle_rest = half_angle_lost + half_angle_of_reduced_length_lo,
      half_angle_lo = KSL_MUL(half_angle_rest, up);
  const double y = KSL_MUL(half_angle, half_angle), y_cross1 = KSL_MUL(half_angle_lo, half_angle),
      y_cross2 = KSL_MUL(half_angle, half_angle_lo), y_cross = y_cross1 + y_cross2;
  const double sine_of_half_angle = half_angle + half_angle_lo,
      sine_of_half_angle_right = sine_of_half_angle - half_angle,
      sine_of_half_angle_left = sine_of_half_angle - sine_of_half_angle_right,
      sine_of_half_angle_left_rest = half_angle - sine_of_half_angle_left,
      sine_of_half_angle_right_rest = half_angle_lo - sine_of_half_angle_right,
      sine_of_half_angle_lo = sine_of_half_angle_left_rest + sine_of_half_angle_right_rest;
  double c; const double sine = ksl_sincos(sine_of_half_angle, &c);
  double c_own_error; const double sine_own_error = ksl_sincos_error(sine_of_half_angle, sine, c,
      &c_own_error);
  const double sine_half = KSL_MUL(sine_of_half_angle_lo, 0.5);
  double sine_half_cos; const double sine_half_sin = ksl_sincos(sine_half, &sine_half_cos);
  const double sine_twice = sine_half_sin + sine_half_sin, sine_slope1 = KSL_MUL(sine_half_cos, c),
      sine_slope2 = KSL_MUL(sine_half_sin, sine), sine_slope = sine_slope1 - sine_slope2,
      sine_more = KSL_MUL(sine_slope, sine_twice), sine_lo = sine_own_error + sine_more;
  const double c_slope1 = KSL_MUL(sine_half_cos, sine), c_slope2 = KSL_MUL(sine_half_sin, c),
      c_slope = c_slope1 + c_slope2, c_more = KSL_MUL(c_slope, sine_twice),
      c_lo = c_own_error - c_more;
  const double sinc_divisor = sine_of_half_angle < 1.4901161193847656e-08 ? 1.4901161193847656e-08 :
      sine_of_half_angle,
      sinc_divisor_lo = sine_of_half_angle < 1.4901161193847656e-08 ? 0.0 : sine_of_half_angle_lo;
  const double sinc_quotient_of_sine = sine + sine_lo,
      sinc_quotient_of_sine_right = sinc_quotient_of_sine - sine,
      sinc_quotient_of_sine_left = sinc_quotient_of_sine - sinc_quotient_of_sine_right,
      sinc_quotient_of_sine_left_rest = sine - sinc_quotient_of_sine_left,
      sinc_quotient_of_sine_right_rest = sine_lo - sinc_quotient_of_sine_right,
      sinc_quotient_of_sine_lo = sinc_quotient_of_sine_left_rest + sinc_quotient_of_sine_right_rest,
      sinc_quotient_of_sinc_divisor = sinc_divisor + sinc_divisor_lo,
      sinc_quotient_of_sinc_divisor_right = sinc_quotient_of_sinc_divisor - sinc_divisor,
      sinc_quotient_of_sinc_divisor_left = sinc_quotient_of_sinc_divisor -
          sinc_quotient_of_sinc_divisor_right,
      sinc_quotient_of_sinc_divisor_left_rest = sinc_divisor - sinc_quotient_of_sinc_divisor_left,
      sinc_quotient_of_sinc_divisor_right_rest = sinc_divisor_lo -
          sinc_quotient_of_sinc_divisor_right,
      sinc_quotient_of_sinc_divisor_lo = sinc_quotient_of_sinc_divisor_left_rest +
          sinc_quotient_of_sinc_divisor_right_rest,
      sinc_quotient = sinc_quotient_of_sine / sinc_quotient_of_sinc_divisor,
      sinc_quotient_product = KSL_MUL(sinc_quotient, sinc_quotient_of_sinc_divisor),
      sinc_quotient_product_error = ksl_product_error(sinc_quotient, sinc_quotient_of_sinc_divisor,
          sinc_quotient_product),
      sinc_quotient_rest = sinc_quotient_of_sine - sinc_quotient_product,
      sinc_quotient_exact = sinc_quotient_rest - sinc_quotient_product_error,
      sinc_quotient_numerator = sinc_quotient_exact + sinc_quotient_of_sine_lo,
      sinc_quotient_cross = KSL_MUL(sinc_quotient, sinc_quotient_of_sinc_divisor_lo),
      sinc_quotient_residual = sinc_quotient_numerator - sinc_quotient_cross,
      sinc_quotient_lo = sinc_quotient_residual / sinc_quotient_of_sinc_divisor;
  const double y_error = ksl_product_error(half_angle, half_angle, y), y_lo = y_error + y_cross,
      sinc_a = KSL_MUL(0.16666666666666666, y), sinc_a_cross1 = KSL_MUL(9.25185853854297e-18, y),
      sinc_a_cross2 = KSL_MUL(0.16666666666666666, y_lo),
      sinc_a_cross = sinc_a_cross1 + sinc_a_cross2, sinc_b = 1.0 - sinc_a,
      sinc_b_right = 1.0 - sinc_b, sinc_b_left = sinc_b + sinc_b_right,
      sinc_b_left_rest = 1.0 - sinc_b_left,
      sinc_b_right_rest = ksl_product_rest(0.16666666666666666, y, sinc_a, sinc_b_right),
      sinc_b_lo1 = sinc_b_left_rest - sinc_b_right_rest, sinc_b_lo = sinc_b_lo1 - sinc_a_cross,
      sinc = sine_of_half_angle < 1.4901161193847656e-08 ? sinc_b : sinc_quotient,
      sinc_lo = sine_of_half_angle < 1.4901161193847656e-08 ? sinc_b_lo : sinc_quotient_lo;
  const double turning_0 = KSL_MUL(v->x, sinc), turning_0_cross2 = KSL_MUL(v->x, sinc_lo);
  const double turning_1 = KSL_MUL(v->y, sinc), turning_1_cross2 = KSL_MUL(v->y, sinc_lo);
  const double turning_2 = KSL_MUL(v->z, sinc), turning_2_cross2 = KSL_MUL(v->z, sinc_lo);
  const double turning_0_error = ksl_product_error(v->x, sinc, turning_0),
      turning_0_lo = turning_0_error + turning_0_cross2, beta_v_0 = KSL_MUL(0.5, turning_0),
      beta_v_0_cross2 = KSL_MUL(0.5, turning_0_lo);
  const double turning_1_error = ksl_product_error(v->y, sinc, turning_1),
      turning_1_lo = turning_1_error + turning_1_cross2, beta_v_1 = KSL_MUL(0.5, turning_1),
      beta_v_1_cross2 = KSL_MUL(0.5, turning_1_lo);
  const double turning_2_error = ksl_product_error(v->z, sinc, turning_2),
      turning_2_lo = turning_2_error + turning_2_cross2, beta_v_2 = KSL_MUL(0.5, turning_2),
      beta_v_2_cross2 = KSL_MUL(0.5, turning_2_lo);
  const double m_0 = KSL_MUL(turning_0, beta_v_0), m_0_cross1 = KSL_MUL(turning_0_lo, beta_v_0),
      m_0_cross2 = KSL_MUL(turning_0, beta_v_0_cross2), m_0_cross = m_0_cross1 + m_0_cross2;
  const double m_1 = KSL_MUL(turning_1, beta_v_1), m_1_cross1 = KSL_MUL(turning_1_lo, beta_v_1),
      m_1_cross2 = KSL_MUL(turning_1, beta_v_1_cross2), m_1_cross = m_1_cross1 + m_1_cross2;
  const double m_2 = KSL_MUL(turning_2, beta_v_2), m_2_cross1 = KSL_MUL(turning_2_lo, beta_v_2),
      m_2_cross2 = KSL_MUL(turning_2, beta_v_2_cross2), m_2_cross = m_2_cross1 + m_2_cross2;
  const double m_3 = KSL_MUL(turning_1, beta_v_0), m_3_cross1 = KSL_MUL(turning_1_lo, beta_v_0),
      m_3_cross2 = KSL_MUL(turning_1, beta_v_0_cross2), m_3_cross = m_3_cross1 + m_3_cross2;
  const double m_4 = KSL_MUL(turning_2, beta_v_0), m_4_cross1 = KSL_MUL(turning_2_lo, beta_v_0),
      m_4_cross2 = KSL_MUL(turning_2, beta_v_0_cross2), m_4_cross = m_4_cross1 + m_4_cross2;
  const double m_5 = KSL_MUL(turning_2, beta_v_1), m_5_cross1 = KSL_MUL(turning_2_lo, beta_v_1),
      m_5_cross2 = KSL_MUL(turning_2, beta_v_1_cross2), m_5_cross = m_5_cross1 + m_5_cross2;
  const double others_0 = m_1 + m_2, others_0_right = others_0 - m_1,
      others_0_left = others_0 - others_0_right,
      others_0_left_rest = ksl_product_rest(turning_1, beta_v_1, m_1, others_0_left),
      others_0_right_rest = ksl_product_rest(turning_2, beta_v_2, m_2, others_0_right),
      others_0_cross = m_1_cross + m_2_cross,
      others_0_lo1 = others_0_left_rest + others_0_right_rest,
      others_0_lo = others_0_lo1 + others_0_cross;
  const double others_1 = m_0 + m_2, others_1_right = others_1 - m_0,
      others_1_left = others_1 - others_1_right,
      others_1_left_rest = ksl_product_rest(turning_0, beta_v_0, m_0, others_1_left),
      others_1_right_rest = ksl_product_rest(turning_2, beta_v_2, m_2, others_1_right),
      others_1_cross = m_0_cross + m_2_cross,
      others_1_lo1 = others_1_left_rest + others_1_right_rest,
      others_1_lo = others_1_lo1 + others_1_cross;
  const double others_2 = m_0 + m_1, others_2_right = others_2 - m_0,
      others_2_left = others_2 - others_2_right,
      others_2_left_rest = ksl_product_rest(turning_0, beta_v_0, m_0, others_2_left),
      others_2_right_rest = ksl_product_rest(turning_1, beta_v_1, m_1, others_2_right),
      others_2_cross = m_0_cross + m_1_cross,
      others_2_lo1 = others_2_left_rest + others_2_right_rest,
      others_2_lo = others_2_lo1 + others_2_cross;
  const double alpha_v_0 = KSL_MUL(c, turning_0), alpha_v_0_cross1 = KSL_MUL(c_lo, turning_0),
      alpha_v_0_cross2 = KSL_MUL(c, turning_0_lo),
      alpha_v_0_cross = alpha_v_0_cross1 + alpha_v_0_cross2;
  const double alpha_v_1 = KSL_MUL(c, turning_1), alpha_v_1_cross1 = KSL_MUL(c_lo, turning_1),
      alpha_v_1_cross2 = KSL_MUL(c, turning_1_lo),
      alpha_v_1_cross = alpha_v_1_cross1 + alpha_v_1_cross2;
  const double alpha_v_2 = KSL_MUL(c, turning_2), alpha_v_2_cross1 = KSL_MUL(c_lo, turning_2),
      alpha_v_2_cross2 = KSL_MUL(c, turning_2_lo),
      alpha_v_2_cross = alpha_v_2_cross1 + alpha_v_2_cross2;
  const double R_00 = 1.0 - others_0, R_00_right = 1.0 - R_00, R_00_left = R_00 + R_00_right,
      R_00_left_rest = 1.0 - R_00_left, R_00_right_rest = others_0 - R_00_right,
      R_00_lo1 = R_00_left_rest - R_00_right_rest, R_00_lo = R_00_lo1 - others_0_lo;
  const double R_01 = m_3 - alpha_v_2, R_01_right = m_3 - R_01, R_01_left = R_01 + R_01_right,
      R_01_left_rest = ksl_product_rest(turning_1, beta_v_0, m_3, R_01_left),
      R_01_right_rest = ksl_product_rest(c, turning_2, alpha_v_2, R_01_right),
      R_01_cross = m_3_cross - alpha_v_2_cross, R_01_lo1 = R_01_left_rest - R_01_right_rest,
      R_01_lo = R_01_lo1 + R_01_cross;
  const double R_02 = m_4 + alpha_v_1, R_02_right = R_02 - m_4, R_02_left = R_02 - R_02_right,
      R_02_left_rest = ksl_product_rest(turning_2, beta_v_0, m_4, R_02_left),
      R_02_right_rest = ksl_product_rest(c, turning_1, alpha_v_1, R_02_right),
      R_02_cross = m_4_cross + alpha_v_1_cross, R_02_lo1 = R_02_left_rest + R_02_right_rest,
      R_02_lo = R_02_lo1 + R_02_cross;
  const double R_10 = m_3 + alpha_v_2, R_10_right = R_10 - m_3, R_10_left = R_10 - R_10_right,
      R_10_left_rest = ksl_product_rest(turning_1, beta_v_0, m_3, R_10_left),
      R_10_right_rest = ksl_product_rest(c, turning_2, alpha_v_2, R_10_right),
      R_10_cross = m_3_cross + alpha_v_2_cross, R_10_lo1 = R_10_left_rest + R_10_right_rest,
      R_10_lo = R_10_lo1 + R_10_cross;
  const double R_11 = 1.0 - others_1, R_11_right = 1.0 - R_11, R_11_left = R_11 + R_11_right,
      R_11_left_rest = 1.0 - R_11_left, R_11_right_rest = others_1 - R_11_right,
      R_11_lo1 = R_11_left_rest - R_11_right_rest, R_11_lo = R_11_lo1 - others_1_lo;
  const double R_12 = m_5 - alpha_v_0, R_12_right = m_5 - R_12, R_12_left = R_12 + R_12_right,
      R_12_left_rest = ksl_product_rest(turning_2, beta_v_1, m_5, R_12_left),
      R_12_right_rest = ksl_product_rest(c, turning_0, alpha_v_0, R_12_right),
      R_12_cross = m_5_cross - alpha_v_0_cross, R_12_lo1 = R_12_left_rest - R_12_right_rest,
      R_12_lo = R_12_lo1 + R_12_cross;
  const double R_20 = m_4 - alpha_v_1, R_20_right = m_4 - R_20, R_20_left = R_20 + R_20_right,
      R_20_left_rest = ksl_product_rest(turning_2, beta_v_0, m_4, R_20_left),
      R_20_right_rest = ksl_product_rest(c, turning_1, alpha_v_1, R_20_right),
      R_20_cross = m_4_cross - alpha_v_1_cross, R_20_lo1 = R_20_left_rest - R_20_right_rest,
      R_20_lo = R_20_lo1 + R_20_cross;
  const double R_21 = m_5 + alpha_v_0, R_21_right = R_21 - m_5, R_21_left = R_21 - R_21_right,
      R_21_left_rest = ksl_product_rest(turning_2, beta_v_1, m_5, R_21_left),
      R_21_right_rest = ksl_product_rest(c, turning_0, alpha_v_0, R_21_right),
      R_21_cross = m_5_cross + alpha_v_0_cross, R_21_lo1 = R_21_left_rest + R_21_right_rest,
      R_21_lo = R_21_lo1 + R_21_cross;
  const double R_22 = 1.0 - others_2, R_22_right = 1.0 - R_22, R_22_left = R_22 + R_22_right,
      R_22_left_rest = 1.0 - R_22_left, R_22_right_rest = others_2 - R_22_right,
      R_22_lo1 = R_22_left_rest - R_22_right_rest, R_22_lo = R_22_lo1 - others_2_lo;
  const double R_00_rounded = R_00 + R_00_lo,
      R_00_final = R_00_rounded == R_00_rounded ? R_00_rounded : R_00;
  const double R_01_rounded = R_01 + R_01_lo,
      R_01_final = R_01_rounded == R_01_rounded ? R_01_rounded : R_01;
  const double R_02_rounded = R_02 + R_02_lo,
      R_02_final = R_02_rounded == R_02_rounded ? R_02_rounded : R_02;
  const double R_10_rounded = R_10 + R_10_lo,
      R_10_final = R_10_rounded == R_10_rounded ? R_10_rounded : R_10;
  const double R_11_rounded = R_11 + R_11_lo,
      R_11_final = R_11_rounded == R_11_rounded ? R_11_rounded : R_11;
  const double R_12_rounded = R_12 + R_12_lo,
      R_12_final = R_12_rounded == R_12_rounded ? R_12_rounded : R_12;
  const double R_20_rounded = R_20 + R_20_lo,
      R_20_final = R_20_rounded == R_20_rounded ? R_20_rounded : R_20;
  const double R_21_rounded = R_21 + R_21_lo,
      R_21_final = R_21_rounded == R_21_rounded ? R_21_rounded : R_21;
  const double R_22_rounded = R_22 + R_22_lo,
      R_22_final = R_22_rounded == R_22_rounded ? R_22_rounded : R_22;
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
      v_y_0_rest = v_y_0_lost + v_s_size_0_of_upper_0_lo, v_y_0_lo = KSL_MUL(v_y_0_rest, v_s);
  const double v_y_1 = KSL_MUL(v_s_size_1_of_upper_1, v_s),
      v_y_1_back = KSL_MUL(v_y_1, v_y_0_inverse), v_y_1_lost = v_s_size_1_of_upper_1 - v_y_1_back,
      v_y_1_rest = v_y_1_lost + v_s_size_1_of_upper_1_lo, v_y_1_lo = KSL_MUL(v_y_1_rest, v_s);
  const double v_y_2 = KSL_MUL(v_s_size_2_of_upper_2, v_s),
      v_y_2_back = KSL_MUL(v_y_2, v_y_0_inverse), v_y_2_lost = v_s_size_2_of_upper_2 - v_y_2_back,
      v_y_2_rest = v_y_2_lost + v_s_size_2_of_upper_2_lo, v_y_2_lo = KSL_MUL(v_y_2_rest, v_s);
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
      n_rest = n_lost + n_of_v_n_lo, n_lo = KSL_MUL(n_rest, v_r);
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

/* R = J_l(v) = I + (1 - cos θ)/θ^2 v~ + (θ - sin θ)/θ^3 v~^2, θ = |v|.
   v: vector; R: rotation or other 3×3 matrix.
   208 mul, 471 add, 21 product error, 43 product rest, 6 div, 1 sqrt, 4 abs, 6 less, 10 equal,
     25 select.
   Error <= R: 1 u of its largest component for |v| <= 1e13, in single precision 1e5; searched,
     not proved.  Each component is within 1 ulp as long as its condition is below 1e13; in
     single precision it is the nearest number, except near ties, as long as that is below 1e5;
     searched, not proved. */
static inline void ksl_SO3_leftJacobian_accurate(const ksl_vec3_t *v, ksl_mat3x3_t *R) {
  const double halved_0 = KSL_MUL(0.5, v->x);
  const double halved_1 = KSL_MUL(0.5, v->y);
  const double halved_2 = KSL_MUL(0.5, v->z);
  const double y_a = KSL_MUL(halved_0, halved_0), y_b = KSL_MUL(halved_1, halved_1),
      y_c = y_a + y_b, y_c_right = y_c - y_a, y_c_left = y_c - y_c_right,
      y_c_left_rest = ksl_product_rest(halved_0, halved_0, y_a, y_c_left),
      y_c_right_rest = ksl_product_rest(halved_1, halved_1, y_b, y_c_right),
      y_c_lo = y_c_left_rest + y_c_right_rest, y_d = KSL_MUL(halved_2, halved_2), y = y_c + y_d,
      y_right = y - y_c, y_left = y - y_right, y_left_rest = y_c - y_left,
      y_right_rest = ksl_product_rest(halved_2, halved_2, y_d, y_right),
      y_lo1 = y_left_rest + y_right_rest, y_lo = y_lo1 + y_c_lo;
  const double half_angle_of_y = y + y_lo, half_angle_of_y_right = half_angle_of_y - y,
      half_angle_of_y_left = half_angle_of_y - half_angle_of_y_right,
      half_angle_of_y_left_rest = y - half_angle_of_y_left,
      half_angle_of_y_right_rest = y_lo - half_angle_of_y_right,
      half_angle_of_y_lo = half_angle_of_y_left_rest + half_angle_of_y_right_rest,
      half_angle = sqrt(half_angle_of_y), half_angle_product = KSL_MUL(half_angle, half_angle),
      half_angle_product_error = ksl_product_error(half_angle, half_angle, half_angle_product),
      half_angle_rest = half_angle_of_y - half_angle_product,
      half_angle_exact = half_angle_rest - half_angle_product_error,
      half_angle_residual = half_angle_exact + half_angle_of_y_lo,
      half_angle_twice = half_angle + half_angle,
      half_angle_divisor = half_angle == 0.0 ? 1.0 : half_angle_twice,
      half_angle_lo = half_angle_residual / half_angle_divisor;
  const double sine_of_half_angle = half_angle + half_angle_lo,
      sine_of_half_angle_right = sine_of_half_angle - half_angle,
      sine_of_half_angle_left = sine_of_half_angle - sine_of_half_angle_right,
      sine_of_half_angle_left_rest = half_angle - sine_of_half_angle_left,
      sine_of_half_angle_right_rest = half_angle_lo - sine_of_half_angle_right,
      sine_of_half_angle_lo = sine_of_half_angle_left_rest + sine_of_half_angle_right_rest;
  double c; const double sine = ksl_sincos(sine_of_half_angle, &c);
  double c_own_error; const double sine_own_error = ksl_sincos_error(sine_of_half_angle, sine, c,
      &c_own_error);
  const double sine_half = KSL_MUL(sine_of_half_angle_lo, 0.5);
  double sine_half_cos; const double sine_half_sin = ksl_sincos(sine_half, &sine_half_cos);
  const double sine_twice = sine_half_sin + sine_half_sin, sine_slope1 = KSL_MUL(sine_half_cos, c),
      sine_slope2 = KSL_MUL(sine_half_sin, sine), sine_slope = sine_slope1 - sine_slope2,
      sine_more = KSL_MUL(sine_slope, sine_twice), sine_lo = sine_own_error + sine_more;
  const double c_slope1 = KSL_MUL(sine_half_cos, sine), c_slope2 = KSL_MUL(sine_half_sin, c),
      c_slope = c_slope1 + c_slope2, c_more = KSL_MUL(c_slope, sine_twice),
      c_lo = c_own_error - c_more;
  const double sinc_divisor = sine_of_half_angle < 1.4901161193847656e-08 ? 1.4901161193847656e-08 :
      sine_of_half_angle,
      sinc_divisor_lo = sine_of_half_angle < 1.4901161193847656e-08 ? 0.0 : sine_of_half_angle_lo;
  const double sinc_quotient_of_sine = sine + sine_lo,
      sinc_quotient_of_sine_right = sinc_quotient_of_sine - sine,
      sinc_quotient_of_sine_left = sinc_quotient_of_sine - sinc_quotient_of_sine_right,
      sinc_quotient_of_sine_left_rest = sine - sinc_quotient_of_sine_left,
      sinc_quotient_of_sine_right_rest = sine_lo - sinc_quotient_of_sine_right,
      sinc_quotient_of_sine_lo = sinc_quotient_of_sine_left_rest + sinc_quotient_of_sine_right_rest,
      sinc_quotient_of_sinc_divisor = sinc_divisor + sinc_divisor_lo,
      sinc_quotient_of_sinc_divisor_right = sinc_quotient_of_sinc_divisor - sinc_divisor,
      sinc_quotient_of_sinc_divisor_left = sinc_quotient_of_sinc_divisor -
          sinc_quotient_of_sinc_divisor_right,
      sinc_quotient_of_sinc_divisor_left_rest = sinc_divisor - sinc_quotient_of_sinc_divisor_left,
      sinc_quotient_of_sinc_divisor_right_rest = sinc_divisor_lo -
          sinc_quotient_of_sinc_divisor_right,
      sinc_quotient_of_sinc_divisor_lo = sinc_quotient_of_sinc_divisor_left_rest +
          sinc_quotient_of_sinc_divisor_right_rest,
      sinc_quotient = sinc_quotient_of_sine / sinc_quotient_of_sinc_divisor,
      sinc_quotient_product = KSL_MUL(sinc_quotient, sinc_quotient_of_sinc_divisor),
      sinc_quotient_product_error = ksl_product_error(sinc_quotient, sinc_quotient_of_sinc_divisor,
          sinc_quotient_product),
      sinc_quotient_rest = sinc_quotient_of_sine - sinc_quotient_product,
      sinc_quotient_exact = sinc_quotient_rest - sinc_quotient_product_error,
      sinc_quotient_numerator = sinc_quotient_exact + sinc_quotient_of_sine_lo,
      sinc_quotient_cross = KSL_MUL(sinc_quotient, sinc_quotient_of_sinc_divisor_lo),
      sinc_quotient_residual = sinc_quotient_numerator - sinc_quotient_cross,
      sinc_quotient_lo = sinc_quotient_residual / sinc_quotient_of_sinc_divisor;
  const double sinc_a = KSL_MUL(0.16666666666666666, half_angle_of_y),
      sinc_a_cross1 = KSL_MUL(9.25185853854297e-18, half_angle_of_y),
      sinc_a_cross2 = KSL_MUL(0.16666666666666666, half_angle_of_y_lo),
      sinc_a_cross = sinc_a_cross1 + sinc_a_cross2, sinc_b = 1.0 - sinc_a,
      sinc_b_right = 1.0 - sinc_b, sinc_b_left = sinc_b + sinc_b_right,
      sinc_b_left_rest = 1.0 - sinc_b_left,
      sinc_b_right_rest = ksl_product_rest(0.16666666666666666, half_angle_of_y, sinc_a,
          sinc_b_right),
      sinc_b_lo1 = sinc_b_left_rest - sinc_b_right_rest, sinc_b_lo = sinc_b_lo1 - sinc_a_cross,
      sinc = sine_of_half_angle < 1.4901161193847656e-08 ? sinc_b : sinc_quotient,
      sinc_lo = sine_of_half_angle < 1.4901161193847656e-08 ? sinc_b_lo : sinc_quotient_lo;
  const double g1 = KSL_MUL(c, sinc), g1_cross1 = KSL_MUL(c_lo, sinc),
      g1_cross2 = KSL_MUL(c, sinc_lo), g1_cross = g1_cross1 + g1_cross2;
  const double g2a = KSL_MUL(sinc, sinc), g2a_cross1 = KSL_MUL(sinc_lo, sinc),
      g2a_cross2 = KSL_MUL(sinc, sinc_lo), g2a_cross = g2a_cross1 + g2a_cross2,
      g2a_error = ksl_product_error(sinc, sinc, g2a), g2a_lo = g2a_error + g2a_cross,
      g2 = KSL_MUL(0.5, g2a), g2_cross2 = KSL_MUL(0.5, g2a_lo);
  const double rest3 = 1.0 - g1, rest3_right = 1.0 - rest3, rest3_left = rest3 + rest3_right,
      rest3_left_rest = 1.0 - rest3_left,
      rest3_right_rest = ksl_product_rest(c, sinc, g1, rest3_right),
      rest3_lo1 = rest3_left_rest - rest3_right_rest, rest3_lo = rest3_lo1 - g1_cross;
  const double x = KSL_MUL(4.0, half_angle_of_y), x_cross2 = KSL_MUL(4.0, half_angle_of_y_lo);
  const double far_x_a_of_x = x + x_cross2, far_x_a_of_x_right = far_x_a_of_x - x,
      far_x_a_of_x_left = far_x_a_of_x - far_x_a_of_x_right,
      far_x_a_of_x_left_rest = x - far_x_a_of_x_left,
      far_x_a_of_x_right_rest = x_cross2 - far_x_a_of_x_right,
      far_x_a_of_x_lo = far_x_a_of_x_left_rest + far_x_a_of_x_right_rest,
      far_x = far_x_a_of_x < 1.0 ? 1.0 : far_x_a_of_x,
      far_x_lo = far_x_a_of_x < 1.0 ? 0.0 : far_x_a_of_x_lo;
  const double closed3_of_rest3 = rest3 + rest3_lo,
      closed3_of_rest3_right = closed3_of_rest3 - rest3,
      closed3_of_rest3_left = closed3_of_rest3 - closed3_of_rest3_right,
      closed3_of_rest3_left_rest = rest3 - closed3_of_rest3_left,
      closed3_of_rest3_right_rest = rest3_lo - closed3_of_rest3_right,
      closed3_of_rest3_lo = closed3_of_rest3_left_rest + closed3_of_rest3_right_rest,
      closed3_of_far_x = far_x + far_x_lo, closed3_of_far_x_right = closed3_of_far_x - far_x,
      closed3_of_far_x_left = closed3_of_far_x - closed3_of_far_x_right,
      closed3_of_far_x_left_rest = far_x - closed3_of_far_x_left,
      closed3_of_far_x_right_rest = far_x_lo - closed3_of_far_x_right,
      closed3_of_far_x_lo = closed3_of_far_x_left_rest + closed3_of_far_x_right_rest,
      closed3 = closed3_of_rest3 / closed3_of_far_x,
      closed3_product = KSL_MUL(closed3, closed3_of_far_x),
      closed3_product_error = ksl_product_error(closed3, closed3_of_far_x, closed3_product),
      closed3_rest = closed3_of_rest3 - closed3_product,
      closed3_exact = closed3_rest - closed3_product_error,
      closed3_numerator = closed3_exact + closed3_of_rest3_lo,
      closed3_cross = KSL_MUL(closed3, closed3_of_far_x_lo),
      closed3_residual = closed3_numerator - closed3_cross,
      closed3_lo = closed3_residual / closed3_of_far_x;
  const double series5a = KSL_MUL(1.216125041553518e-34, far_x_a_of_x),
      series5a_cross1 = KSL_MUL(5.586290567888806e-51, far_x_a_of_x),
      series5a_cross2 = KSL_MUL(1.216125041553518e-34, far_x_a_of_x_lo),
      series5a_cross = series5a_cross1 + series5a_cross2,
      series5b = 1.1309962886447716e-31 - series5a,
      series5b_right = 1.1309962886447716e-31 - series5b, series5b_left = series5b + series5b_right,
      series5b_left_rest = 1.1309962886447716e-31 - series5b_left,
      series5b_right_rest = ksl_product_rest(1.216125041553518e-34, far_x_a_of_x, series5a,
          series5b_right),
      series5b_lo1 = series5b_left_rest - series5b_right_rest,
      series5b_lo2 = series5b_lo1 - series5a_cross,
      series5b_lo = series5b_lo2 + 1.0498015412959506e-47,
      series5c = KSL_MUL(far_x_a_of_x, series5b),
      series5c_cross1 = KSL_MUL(far_x_a_of_x_lo, series5b),
      series5c_cross2 = KSL_MUL(far_x_a_of_x, series5b_lo),
      series5c_cross = series5c_cross1 + series5c_cross2,
      series5d = series5c - 9.183689863795546e-29, series5d_right = series5c - series5d,
      series5d_left = series5d + series5d_right,
      series5d_left_rest = ksl_product_rest(far_x_a_of_x, series5b, series5c, series5d_left),
      series5d_right_rest = 9.183689863795546e-29 - series5d_right,
      series5d_lo1 = series5d_left_rest - series5d_right_rest,
      series5d_lo2 = series5d_lo1 - 1.4303150396787322e-45,
      series5d_lo = series5d_lo2 + series5c_cross, series5e = KSL_MUL(far_x_a_of_x, series5d),
      series5e_cross1 = KSL_MUL(far_x_a_of_x_lo, series5d),
      series5e_cross2 = KSL_MUL(far_x_a_of_x, series5d_lo),
      series5e_cross = series5e_cross1 + series5e_cross2,
      series5f = series5e + 6.446950284384474e-26, series5f_right = series5f - series5e,
      series5f_left = series5f - series5f_right,
      series5f_left_rest = ksl_product_rest(far_x_a_of_x, series5d, series5e, series5f_left),
      series5f_right_rest = 6.446950284384474e-26 - series5f_right,
      series5f_lo1 = series5f_left_rest + series5f_right_rest,
      series5f_lo2 = series5f_lo1 + -1.9330404233703465e-42,
      series5f_lo = series5f_lo2 + series5e_cross, series5g = KSL_MUL(far_x_a_of_x, series5f),
      series5g_cross1 = KSL_MUL(far_x_a_of_x_lo, series5f),
      series5g_cross2 = KSL_MUL(far_x_a_of_x, series5f_lo),
      series5g_cross = series5g_cross1 + series5g_cross2,
      series5h = series5g - 3.868170170630684e-23, series5h_right = series5g - series5h,
      series5h_left = series5h + series5h_right,
      series5h_left_rest = ksl_product_rest(far_x_a_of_x, series5f, series5g, series5h_left),
      series5h_right_rest = 3.868170170630684e-23 - series5h_right,
      series5h_lo1 = series5h_left_rest - series5h_right_rest,
      series5h_lo2 = series5h_lo1 - -8.843177655482344e-40,
      series5h_lo = series5h_lo2 + series5g_cross, series5i = KSL_MUL(far_x_a_of_x, series5h),
      series5i_cross1 = KSL_MUL(far_x_a_of_x_lo, series5h),
      series5i_cross2 = KSL_MUL(far_x_a_of_x, series5h_lo),
      series5i_cross = series5i_cross1 + series5i_cross2,
      series5j = series5i + 1.9572941063391263e-20, series5j_right = series5j - series5i,
      series5j_left = series5j - series5j_right,
      series5j_left_rest = ksl_product_rest(far_x_a_of_x, series5h, series5i, series5j_left),
      series5j_right_rest = 1.9572941063391263e-20 - series5j_right,
      series5j_lo1 = series5j_left_rest + series5j_right_rest,
      series5j_lo2 = series5j_lo1 + -1.3643503830087908e-36,
      series5j_lo = series5j_lo2 + series5i_cross, series5k = KSL_MUL(far_x_a_of_x, series5j),
      series5k_cross1 = KSL_MUL(far_x_a_of_x_lo, series5j),
      series5k_cross2 = KSL_MUL(far_x_a_of_x, series5j_lo),
      series5k_cross = series5k_cross1 + series5k_cross2,
      series5l = series5k - 8.22063524662433e-18, series5l_right = series5k - series5l,
      series5l_left = series5l + series5l_right,
      series5l_left_rest = ksl_product_rest(far_x_a_of_x, series5j, series5k, series5l_left),
      series5l_right_rest = 8.22063524662433e-18 - series5l_right,
      series5l_lo1 = series5l_left_rest - series5l_right_rest,
      series5l_lo2 = series5l_lo1 - 2.2141894119604265e-34,
      series5l_lo = series5l_lo2 + series5k_cross, series5m = KSL_MUL(far_x_a_of_x, series5l),
      series5m_cross1 = KSL_MUL(far_x_a_of_x_lo, series5l),
      series5m_cross2 = KSL_MUL(far_x_a_of_x, series5l_lo),
      series5m_cross = series5m_cross1 + series5m_cross2,
      series5n = series5m + 2.8114572543455206e-15, series5n_right = series5n - series5m,
      series5n_left = series5n - series5n_right,
      series5n_left_rest = ksl_product_rest(far_x_a_of_x, series5l, series5m, series5n_left),
      series5n_right_rest = 2.8114572543455206e-15 - series5n_right,
      series5n_lo1 = series5n_left_rest + series5n_right_rest,
      series5n_lo2 = series5n_lo1 + 1.6508842730861433e-31,
      series5n_lo = series5n_lo2 + series5m_cross, series5o = KSL_MUL(far_x_a_of_x, series5n),
      series5o_cross1 = KSL_MUL(far_x_a_of_x_lo, series5n),
      series5o_cross2 = KSL_MUL(far_x_a_of_x, series5n_lo),
      series5o_cross = series5o_cross1 + series5o_cross2,
      series5p = series5o - 7.647163731819816e-13, series5p_right = series5o - series5p,
      series5p_left = series5p + series5p_right,
      series5p_left_rest = ksl_product_rest(far_x_a_of_x, series5n, series5o, series5p_left),
      series5p_right_rest = 7.647163731819816e-13 - series5p_right,
      series5p_lo1 = series5p_left_rest - series5p_right_rest,
      series5p_lo2 = series5p_lo1 - 7.03872877733453e-30,
      series5p_lo = series5p_lo2 + series5o_cross, series5q = KSL_MUL(far_x_a_of_x, series5p),
      series5q_cross1 = KSL_MUL(far_x_a_of_x_lo, series5p),
      series5q_cross2 = KSL_MUL(far_x_a_of_x, series5p_lo),
      series5q_cross = series5q_cross1 + series5q_cross2,
      series5r = series5q + 1.6059043836821613e-10, series5r_right = series5r - series5q,
      series5r_left = series5r - series5r_right,
      series5r_left_rest = ksl_product_rest(far_x_a_of_x, series5p, series5q, series5r_left),
      series5r_right_rest = 1.6059043836821613e-10 - series5r_right,
      series5r_lo1 = series5r_left_rest + series5r_right_rest,
      series5r_lo2 = series5r_lo1 + 1.2585294588752098e-26,
      series5r_lo = series5r_lo2 + series5q_cross, series5s = KSL_MUL(far_x_a_of_x, series5r),
      series5s_cross1 = KSL_MUL(far_x_a_of_x_lo, series5r),
      series5s_cross2 = KSL_MUL(far_x_a_of_x, series5r_lo),
      series5s_cross = series5s_cross1 + series5s_cross2,
      series5t = series5s - 2.505210838544172e-08, series5t_right = series5s - series5t,
      series5t_left = series5t + series5t_right,
      series5t_left_rest = ksl_product_rest(far_x_a_of_x, series5r, series5s, series5t_left),
      series5t_right_rest = 2.505210838544172e-08 - series5t_right,
      series5t_lo1 = series5t_left_rest - series5t_right_rest,
      series5t_lo2 = series5t_lo1 - -1.448814070935912e-24,
      series5t_lo = series5t_lo2 + series5s_cross, series5u = KSL_MUL(far_x_a_of_x, series5t),
      series5u_cross1 = KSL_MUL(far_x_a_of_x_lo, series5t),
      series5u_cross2 = KSL_MUL(far_x_a_of_x, series5t_lo),
      series5u_cross = series5u_cross1 + series5u_cross2,
      series5v = series5u + 2.7557319223985893e-06, series5v_right = series5v - series5u,
      series5v_left = series5v - series5v_right,
      series5v_left_rest = ksl_product_rest(far_x_a_of_x, series5t, series5u, series5v_left),
      series5v_right_rest = 2.7557319223985893e-06 - series5v_right,
      series5v_lo1 = series5v_left_rest + series5v_right_rest,
      series5v_lo2 = series5v_lo1 + -1.858393274046472e-22,
      series5v_lo = series5v_lo2 + series5u_cross, series5w = KSL_MUL(far_x_a_of_x, series5v),
      series5w_cross1 = KSL_MUL(far_x_a_of_x_lo, series5v),
      series5w_cross2 = KSL_MUL(far_x_a_of_x, series5v_lo),
      series5w_cross = series5w_cross1 + series5w_cross2,
      series5x = series5w - 0.0001984126984126984, series5x_right = series5w - series5x,
      series5x_left = series5x + series5x_right,
      series5x_left_rest = ksl_product_rest(far_x_a_of_x, series5v, series5w, series5x_left),
      series5x_right_rest = 0.0001984126984126984 - series5x_right,
      series5x_lo1 = series5x_left_rest - series5x_right_rest,
      series5x_lo2 = series5x_lo1 - 1.7209558293420705e-22,
      series5x_lo = series5x_lo2 + series5w_cross, series5y = KSL_MUL(far_x_a_of_x, series5x),
      series5y_cross1 = KSL_MUL(far_x_a_of_x_lo, series5x),
      series5y_cross2 = KSL_MUL(far_x_a_of_x, series5x_lo),
      series5y_cross = series5y_cross1 + series5y_cross2, series5 = series5y + 0.008333333333333333,
      series5_right = series5 - series5y, series5_left = series5 - series5_right,
      series5_left_rest = ksl_product_rest(far_x_a_of_x, series5x, series5y, series5_left),
      series5_right_rest = 0.008333333333333333 - series5_right,
      series5_lo1 = series5_left_rest + series5_right_rest,
      series5_lo2 = series5_lo1 + 1.1564823173178714e-19, series5_lo = series5_lo2 + series5y_cross;
  const double g3a = KSL_MUL(far_x_a_of_x, series5), g3a_cross1 = KSL_MUL(far_x_a_of_x_lo, series5),
      g3a_cross2 = KSL_MUL(far_x_a_of_x, series5_lo), g3a_cross = g3a_cross1 + g3a_cross2,
      g3b = 0.16666666666666666 - g3a, g3b_right = 0.16666666666666666 - g3b,
      g3b_left = g3b + g3b_right, g3b_left_rest = 0.16666666666666666 - g3b_left,
      g3b_right_rest = ksl_product_rest(far_x_a_of_x, series5, g3a, g3b_right),
      g3b_lo1 = g3b_left_rest - g3b_right_rest, g3b_lo2 = g3b_lo1 - g3a_cross,
      g3b_lo = g3b_lo2 + 9.25185853854297e-18, g3 = far_x_a_of_x < 1.0 ? g3b : closed3,
      g3_lo = far_x_a_of_x < 1.0 ? g3b_lo : closed3_lo;
  const double beta_v_0 = KSL_MUL(v->x, g3), beta_v_0_cross2 = KSL_MUL(v->x, g3_lo);
  const double beta_v_1 = KSL_MUL(v->y, g3), beta_v_1_cross2 = KSL_MUL(v->y, g3_lo);
  const double beta_v_2 = KSL_MUL(v->z, g3), beta_v_2_cross2 = KSL_MUL(v->z, g3_lo);
  const double beta_v_0_error = ksl_product_error(v->x, g3, beta_v_0),
      beta_v_0_lo = beta_v_0_error + beta_v_0_cross2, m_0 = KSL_MUL(v->x, beta_v_0),
      m_0_cross2 = KSL_MUL(v->x, beta_v_0_lo);
  const double beta_v_1_error = ksl_product_error(v->y, g3, beta_v_1),
      beta_v_1_lo = beta_v_1_error + beta_v_1_cross2, m_1 = KSL_MUL(v->y, beta_v_1),
      m_1_cross2 = KSL_MUL(v->y, beta_v_1_lo);
  const double beta_v_2_error = ksl_product_error(v->z, g3, beta_v_2),
      beta_v_2_lo = beta_v_2_error + beta_v_2_cross2, m_2 = KSL_MUL(v->z, beta_v_2),
      m_2_cross2 = KSL_MUL(v->z, beta_v_2_lo);
  const double m_3 = KSL_MUL(v->y, beta_v_0), m_3_cross2 = KSL_MUL(v->y, beta_v_0_lo);
  const double m_4 = KSL_MUL(v->z, beta_v_0), m_4_cross2 = KSL_MUL(v->z, beta_v_0_lo);
  const double m_5 = KSL_MUL(v->z, beta_v_1), m_5_cross2 = KSL_MUL(v->z, beta_v_1_lo);
  const double others_0 = m_1 + m_2, others_0_right = others_0 - m_1,
      others_0_left = others_0 - others_0_right,
      others_0_left_rest = ksl_product_rest(v->y, beta_v_1, m_1, others_0_left),
      others_0_right_rest = ksl_product_rest(v->z, beta_v_2, m_2, others_0_right),
      others_0_cross = m_1_cross2 + m_2_cross2,
      others_0_lo1 = others_0_left_rest + others_0_right_rest,
      others_0_lo = others_0_lo1 + others_0_cross;
  const double others_1 = m_0 + m_2, others_1_right = others_1 - m_0,
      others_1_left = others_1 - others_1_right,
      others_1_left_rest = ksl_product_rest(v->x, beta_v_0, m_0, others_1_left),
      others_1_right_rest = ksl_product_rest(v->z, beta_v_2, m_2, others_1_right),
      others_1_cross = m_0_cross2 + m_2_cross2,
      others_1_lo1 = others_1_left_rest + others_1_right_rest,
      others_1_lo = others_1_lo1 + others_1_cross;
  const double others_2 = m_0 + m_1, others_2_right = others_2 - m_0,
      others_2_left = others_2 - others_2_right,
      others_2_left_rest = ksl_product_rest(v->x, beta_v_0, m_0, others_2_left),
      others_2_right_rest = ksl_product_rest(v->y, beta_v_1, m_1, others_2_right),
      others_2_cross = m_0_cross2 + m_1_cross2,
      others_2_lo1 = others_2_left_rest + others_2_right_rest,
      others_2_lo = others_2_lo1 + others_2_cross;
  const double diagonal0a = 1.0 - others_0, diagonal0a_right = 1.0 - diagonal0a,
      diagonal0a_left = diagonal0a + diagonal0a_right, diagonal0a_left_rest = 1.0 - diagonal0a_left,
      diagonal0a_right_rest = others_0 - diagonal0a_right,
      diagonal0a_lo1 = diagonal0a_left_rest - diagonal0a_right_rest,
      diagonal0a_lo = diagonal0a_lo1 - others_0_lo, diagonal0b = g1 + m_0,
      diagonal0b_right = diagonal0b - g1, diagonal0b_left = diagonal0b - diagonal0b_right,
      diagonal0b_left_rest = ksl_product_rest(c, sinc, g1, diagonal0b_left),
      diagonal0b_right_rest = ksl_product_rest(v->x, beta_v_0, m_0, diagonal0b_right),
      diagonal0b_cross = g1_cross + m_0_cross2,
      diagonal0b_lo1 = diagonal0b_left_rest + diagonal0b_right_rest,
      diagonal0b_lo = diagonal0b_lo1 + diagonal0b_cross,
      m_0_error = ksl_product_error(v->x, beta_v_0, m_0), m_0_lo = m_0_error + m_0_cross2,
      diagonal0c_of_m_0 = m_0 + m_0_lo, diagonal0c_of_others_0 = others_0 + others_0_lo,
      diagonal0 = diagonal0c_of_m_0 < diagonal0c_of_others_0 ? diagonal0b : diagonal0a,
      diagonal0_lo = diagonal0c_of_m_0 < diagonal0c_of_others_0 ? diagonal0b_lo : diagonal0a_lo;
  const double diagonal1a = 1.0 - others_1, diagonal1a_right = 1.0 - diagonal1a,
      diagonal1a_left = diagonal1a + diagonal1a_right, diagonal1a_left_rest = 1.0 - diagonal1a_left,
      diagonal1a_right_rest = others_1 - diagonal1a_right,
      diagonal1a_lo1 = diagonal1a_left_rest - diagonal1a_right_rest,
      diagonal1a_lo = diagonal1a_lo1 - others_1_lo, diagonal1b = g1 + m_1,
      diagonal1b_right = diagonal1b - g1, diagonal1b_left = diagonal1b - diagonal1b_right,
      diagonal1b_left_rest = ksl_product_rest(c, sinc, g1, diagonal1b_left),
      diagonal1b_right_rest = ksl_product_rest(v->y, beta_v_1, m_1, diagonal1b_right),
      diagonal1b_cross = g1_cross + m_1_cross2,
      diagonal1b_lo1 = diagonal1b_left_rest + diagonal1b_right_rest,
      diagonal1b_lo = diagonal1b_lo1 + diagonal1b_cross,
      m_1_error = ksl_product_error(v->y, beta_v_1, m_1), m_1_lo = m_1_error + m_1_cross2,
      diagonal1c_of_m_1 = m_1 + m_1_lo, diagonal1c_of_others_1 = others_1 + others_1_lo,
      diagonal1 = diagonal1c_of_m_1 < diagonal1c_of_others_1 ? diagonal1b : diagonal1a,
      diagonal1_lo = diagonal1c_of_m_1 < diagonal1c_of_others_1 ? diagonal1b_lo : diagonal1a_lo;
  const double diagonal2a = 1.0 - others_2, diagonal2a_right = 1.0 - diagonal2a,
      diagonal2a_left = diagonal2a + diagonal2a_right, diagonal2a_left_rest = 1.0 - diagonal2a_left,
      diagonal2a_right_rest = others_2 - diagonal2a_right,
      diagonal2a_lo1 = diagonal2a_left_rest - diagonal2a_right_rest,
      diagonal2a_lo = diagonal2a_lo1 - others_2_lo, diagonal2b = g1 + m_2,
      diagonal2b_right = diagonal2b - g1, diagonal2b_left = diagonal2b - diagonal2b_right,
      diagonal2b_left_rest = ksl_product_rest(c, sinc, g1, diagonal2b_left),
      diagonal2b_right_rest = ksl_product_rest(v->z, beta_v_2, m_2, diagonal2b_right),
      diagonal2b_cross = g1_cross + m_2_cross2,
      diagonal2b_lo1 = diagonal2b_left_rest + diagonal2b_right_rest,
      diagonal2b_lo = diagonal2b_lo1 + diagonal2b_cross,
      m_2_error = ksl_product_error(v->z, beta_v_2, m_2), m_2_lo = m_2_error + m_2_cross2,
      diagonal2c_of_m_2 = m_2 + m_2_lo, diagonal2c_of_others_2 = others_2 + others_2_lo,
      diagonal2 = diagonal2c_of_m_2 < diagonal2c_of_others_2 ? diagonal2b : diagonal2a,
      diagonal2_lo = diagonal2c_of_m_2 < diagonal2c_of_others_2 ? diagonal2b_lo : diagonal2a_lo;
  const double alpha_v_0 = KSL_MUL(v->x, g2), alpha_v_0_cross2 = KSL_MUL(v->x, g2_cross2);
  const double alpha_v_1 = KSL_MUL(v->y, g2), alpha_v_1_cross2 = KSL_MUL(v->y, g2_cross2);
  const double alpha_v_2 = KSL_MUL(v->z, g2), alpha_v_2_cross2 = KSL_MUL(v->z, g2_cross2);
  const double R_01 = m_3 - alpha_v_2, R_01_right = m_3 - R_01, R_01_left = R_01 + R_01_right,
      R_01_left_rest = ksl_product_rest(v->y, beta_v_0, m_3, R_01_left),
      R_01_right_rest = ksl_product_rest(v->z, g2, alpha_v_2, R_01_right),
      R_01_cross = m_3_cross2 - alpha_v_2_cross2, R_01_lo1 = R_01_left_rest - R_01_right_rest,
      R_01_lo = R_01_lo1 + R_01_cross;
  const double R_02 = m_4 + alpha_v_1, R_02_right = R_02 - m_4, R_02_left = R_02 - R_02_right,
      R_02_left_rest = ksl_product_rest(v->z, beta_v_0, m_4, R_02_left),
      R_02_right_rest = ksl_product_rest(v->y, g2, alpha_v_1, R_02_right),
      R_02_cross = m_4_cross2 + alpha_v_1_cross2, R_02_lo1 = R_02_left_rest + R_02_right_rest,
      R_02_lo = R_02_lo1 + R_02_cross;
  const double R_10 = m_3 + alpha_v_2, R_10_right = R_10 - m_3, R_10_left = R_10 - R_10_right,
      R_10_left_rest = ksl_product_rest(v->y, beta_v_0, m_3, R_10_left),
      R_10_right_rest = ksl_product_rest(v->z, g2, alpha_v_2, R_10_right),
      R_10_cross = m_3_cross2 + alpha_v_2_cross2, R_10_lo1 = R_10_left_rest + R_10_right_rest,
      R_10_lo = R_10_lo1 + R_10_cross;
  const double R_12 = m_5 - alpha_v_0, R_12_right = m_5 - R_12, R_12_left = R_12 + R_12_right,
      R_12_left_rest = ksl_product_rest(v->z, beta_v_1, m_5, R_12_left),
      R_12_right_rest = ksl_product_rest(v->x, g2, alpha_v_0, R_12_right),
      R_12_cross = m_5_cross2 - alpha_v_0_cross2, R_12_lo1 = R_12_left_rest - R_12_right_rest,
      R_12_lo = R_12_lo1 + R_12_cross;
  const double R_20 = m_4 - alpha_v_1, R_20_right = m_4 - R_20, R_20_left = R_20 + R_20_right,
      R_20_left_rest = ksl_product_rest(v->z, beta_v_0, m_4, R_20_left),
      R_20_right_rest = ksl_product_rest(v->y, g2, alpha_v_1, R_20_right),
      R_20_cross = m_4_cross2 - alpha_v_1_cross2, R_20_lo1 = R_20_left_rest - R_20_right_rest,
      R_20_lo = R_20_lo1 + R_20_cross;
  const double R_21 = m_5 + alpha_v_0, R_21_right = R_21 - m_5, R_21_left = R_21 - R_21_right,
      R_21_left_rest = ksl_product_rest(v->z, beta_v_1, m_5, R_21_left),
      R_21_right_rest = ksl_product_rest(v->x, g2, alpha_v_0, R_21_right),
      R_21_cross = m_5_cross2 + alpha_v_0_cross2, R_21_lo1 = R_21_left_rest + R_21_right_rest,
      R_21_lo = R_21_lo1 + R_21_cross;
  const double diagonal0_rounded = diagonal0 + diagonal0_lo,
      diagonal0_final = diagonal0_rounded == diagonal0_rounded ? diagonal0_rounded : diagonal0;
  const double R_01_rounded = R_01 + R_01_lo,
      R_01_final = R_01_rounded == R_01_rounded ? R_01_rounded : R_01;
  const double R_02_rounded = R_02 + R_02_lo,
      R_02_final = R_02_rounded == R_02_rounded ? R_02_rounded : R_02;
  const double R_10_rounded = R_10 + R_10_lo,
      R_10_final = R_10_rounded == R_10_rounded ? R_10_rounded : R_10;
  const double diagonal1_rounded = diagonal1 + diagonal1_lo,
      diagonal1_final = diagonal1_rounded == diagonal1_rounded ? diagonal1_rounded : diagonal1;
  const double R_12_rounded = R_12 + R_12_lo,
      R_12_final = R_12_rounded == R_12_rounded ? R_12_rounded : R_12;
  const double R_20_rounded = R_20 + R_20_lo,
      R_20_final = R_20_rounded == R_20_rounded ? R_20_rounded : R_20;
  const double R_21_rounded = R_21 + R_21_lo,
      R_21_final = R_21_rounded == R_21_rounded ? R_21_rounded : R_21;
  const double diagonal2_rounded = diagonal2 + diagonal2_lo,
      diagonal2_final = diagonal2_rounded == diagonal2_rounded ? diagonal2_rounded : diagonal2;
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
  const double halved_0 = KSL_MUL(0.5, v->x);
  const double halved_1 = KSL_MUL(0.5, v->y);
  const double halved_2 = KSL_MUL(0.5, v->z);
  const double y_a = KSL_MUL(halved_0, halved_0), y_b = KSL_MUL(halved_1, halved_1),
      y_c = y_a + y_b, y_c_right = y_c - y_a, y_c_left = y_c - y_c_right,
      y_c_left_rest = ksl_product_rest(halved_0, halved_0, y_a, y_c_left),
      y_c_right_rest = ksl_product_rest(halved_1, halved_1, y_b, y_c_right),
      y_c_lo = y_c_left_rest + y_c_right_rest, y_d = KSL_MUL(halved_2, halved_2), y = y_c + y_d,
      y_right = y - y_c, y_left = y - y_right, y_left_rest = y_c - y_left,
      y_right_rest = ksl_product_rest(halved_2, halved_2, y_d, y_right),
      y_lo1 = y_left_rest + y_right_rest, y_lo = y_lo1 + y_c_lo;
  const double half_angle_of_y = y + y_lo, half_angle_of_y_right = half_angle_of_y - y,
      half_angle_of_y_left = half_angle_of_y - half_angle_of_y_right,
      half_angle_of_y_left_rest = y - half_angle_of_y_left,
      half_angle_of_y_right_rest = y_lo - half_angle_of_y_right,
      half_angle_of_y_lo = half_angle_of_y_left_rest + half_angle_of_y_right_rest,
      half_angle = sqrt(half_angle_of_y), half_angle_product = KSL_MUL(half_angle, half_angle),
      half_angle_product_error = ksl_product_error(half_angle, half_angle, half_angle_product),
      half_angle_rest = half_angle_of_y - half_angle_product,
      half_angle_exact = half_angle_rest - half_angle_product_error,
      half_angle_residual = half_angle_exact + half_angle_of_y_lo,
      half_angle_twice = half_angle + half_angle,
      half_angle_divisor = half_angle == 0.0 ? 1.0 : half_angle_twice,
      half_angle_lo = half_angle_residual / half_angle_divisor;
  const double sine_of_half_angle = half_angle + half_angle_lo,
      sine_of_half_angle_right = sine_of_half_angle - half_angle,
      sine_of_half_angle_left = sine_of_half_angle - sine_of_half_angle_right,
      sine_of_half_angle_left_rest = half_angle - sine_of_half_angle_left,
      sine_of_half_angle_right_rest = half_angle_lo - sine_of_half_angle_right,
      sine_of_half_angle_lo = sine_of_half_angle_left_rest + sine_of_half_angle_right_rest;
  double c; const double sine = ksl_sincos(sine_of_half_angle, &c);
  double c_own_error; const double sine_own_error = ksl_sincos_error(sine_of_half_angle, sine, c,
      &c_own_error);
  const double sine_half = KSL_MUL(sine_of_half_angle_lo, 0.5);
  double sine_half_cos; const double sine_half_sin = ksl_sincos(sine_half, &sine_half_cos);
  const double sine_twice = sine_half_sin + sine_half_sin, sine_slope1 = KSL_MUL(sine_half_cos, c),
      sine_slope2 = KSL_MUL(sine_half_sin, sine), sine_slope = sine_slope1 - sine_slope2,
      sine_more = KSL_MUL(sine_slope, sine_twice), sine_lo = sine_own_error + sine_more;
  const double c_slope1 = KSL_MUL(sine_half_cos, sine), c_slope2 = KSL_MUL(sine_half_sin, c),
      c_slope = c_slope1 + c_slope2, c_more = KSL_MUL(c_slope, sine_twice),
      c_lo = c_own_error - c_more;
  const double sinc_divisor = sine_of_half_angle < 1.4901161193847656e-08 ? 1.4901161193847656e-08 :
      sine_of_half_angle,
      sinc_divisor_lo = sine_of_half_angle < 1.4901161193847656e-08 ? 0.0 : sine_of_half_angle_lo;
  const double sinc_quotient_of_sine = sine + sine_lo,
      sinc_quotient_of_sine_right = sinc_quotient_of_sine - sine,
      sinc_quotient_of_sine_left = sinc_quotient_of_sine - sinc_quotient_of_sine_right,
      sinc_quotient_of_sine_left_rest = sine - sinc_quotient_of_sine_left,
      sinc_quotient_of_sine_right_rest = sine_lo - sinc_quotient_of_sine_right,
      sinc_quotient_of_sine_lo = sinc_quotient_of_sine_left_rest + sinc_quotient_of_sine_right_rest,
      sinc_quotient_of_sinc_divisor = sinc_divisor + sinc_divisor_lo,
      sinc_quotient_of_sinc_divisor_right = sinc_quotient_of_sinc_divisor - sinc_divisor,
      sinc_quotient_of_sinc_divisor_left = sinc_quotient_of_sinc_divisor -
          sinc_quotient_of_sinc_divisor_right,
      sinc_quotient_of_sinc_divisor_left_rest = sinc_divisor - sinc_quotient_of_sinc_divisor_left,
      sinc_quotient_of_sinc_divisor_right_rest = sinc_divisor_lo -
          sinc_quotient_of_sinc_divisor_right,
      sinc_quotient_of_sinc_divisor_lo = sinc_quotient_of_sinc_divisor_left_rest +
          sinc_quotient_of_sinc_divisor_right_rest,
      sinc_quotient = sinc_quotient_of_sine / sinc_quotient_of_sinc_divisor,
      sinc_quotient_product = KSL_MUL(sinc_quotient, sinc_quotient_of_sinc_divisor),
      sinc_quotient_product_error = ksl_product_error(sinc_quotient, sinc_quotient_of_sinc_divisor,
          sinc_quotient_product),
      sinc_quotient_rest = sinc_quotient_of_sine - sinc_quotient_product,
      sinc_quotient_exact = sinc_quotient_rest - sinc_quotient_product_error,
      sinc_quotient_numerator = sinc_quotient_exact + sinc_quotient_of_sine_lo,
      sinc_quotient_cross = KSL_MUL(sinc_quotient, sinc_quotient_of_sinc_divisor_lo),
      sinc_quotient_residual = sinc_quotient_numerator - sinc_quotient_cross,
      sinc_quotient_lo = sinc_quotient_residual / sinc_quotient_of_sinc_divisor;
  const double sinc_a = KSL_MUL(0.16666666666666666, half_angle_of_y),
      sinc_a_cross1 = KSL_MUL(9.25185853854297e-18, half_angle_of_y),
      sinc_a_cross2 = KSL_MUL(0.16666666666666666, half_angle_of_y_lo),
      sinc_a_cross = sinc_a_cross1 + sinc_a_cross2, sinc_b = 1.0 - sinc_a,
      sinc_b_right = 1.0 - sinc_b, sinc_b_left = sinc_b + sinc_b_right,
      sinc_b_left_rest = 1.0 - sinc_b_left,
      sinc_b_right_rest = ksl_product_rest(0.16666666666666666, half_angle_of_y, sinc_a,
          sinc_b_right),
      sinc_b_lo1 = sinc_b_left_rest - sinc_b_right_rest, sinc_b_lo = sinc_b_lo1 - sinc_a_cross,
      sinc = sine_of_half_angle < 1.4901161193847656e-08 ? sinc_b : sinc_quotient,
      sinc_lo = sine_of_half_angle < 1.4901161193847656e-08 ? sinc_b_lo : sinc_quotient_lo;
  const double g1 = KSL_MUL(c, sinc), g1_cross1 = KSL_MUL(c_lo, sinc),
      g1_cross2 = KSL_MUL(c, sinc_lo), g1_cross = g1_cross1 + g1_cross2;
  const double g2a = KSL_MUL(sinc, sinc), g2a_cross1 = KSL_MUL(sinc_lo, sinc),
      g2a_cross2 = KSL_MUL(sinc, sinc_lo), g2a_cross = g2a_cross1 + g2a_cross2,
      g2a_error = ksl_product_error(sinc, sinc, g2a), g2a_lo = g2a_error + g2a_cross,
      g2 = KSL_MUL(0.5, g2a), g2_cross2 = KSL_MUL(0.5, g2a_lo);
  const double rest3 = 1.0 - g1, rest3_right = 1.0 - rest3, rest3_left = rest3 + rest3_right,
      rest3_left_rest = 1.0 - rest3_left,
      rest3_right_rest = ksl_product_rest(c, sinc, g1, rest3_right),
      rest3_lo1 = rest3_left_rest - rest3_right_rest, rest3_lo = rest3_lo1 - g1_cross;
  const double x = KSL_MUL(4.0, half_angle_of_y), x_cross2 = KSL_MUL(4.0, half_angle_of_y_lo);
  const double far_x_a_of_x = x + x_cross2, far_x_a_of_x_right = far_x_a_of_x - x,
      far_x_a_of_x_left = far_x_a_of_x - far_x_a_of_x_right,
      far_x_a_of_x_left_rest = x - far_x_a_of_x_left,
      far_x_a_of_x_right_rest = x_cross2 - far_x_a_of_x_right,
      far_x_a_of_x_lo = far_x_a_of_x_left_rest + far_x_a_of_x_right_rest,
      far_x = far_x_a_of_x < 1.0 ? 1.0 : far_x_a_of_x,
      far_x_lo = far_x_a_of_x < 1.0 ? 0.0 : far_x_a_of_x_lo;
  const double closed3_of_rest3 = rest3 + rest3_lo,
      closed3_of_rest3_right = closed3_of_rest3 - rest3,
      closed3_of_rest3_left = closed3_of_rest3 - closed3_of_rest3_right,
      closed3_of_rest3_left_rest = rest3 - closed3_of_rest3_left,
      closed3_of_rest3_right_rest = rest3_lo - closed3_of_rest3_right,
      closed3_of_rest3_lo = closed3_of_rest3_left_rest + closed3_of_rest3_right_rest,
      closed3_of_far_x = far_x + far_x_lo, closed3_of_far_x_right = closed3_of_far_x - far_x,
      closed3_of_far_x_left = closed3_of_far_x - closed3_of_far_x_right,
      closed3_of_far_x_left_rest = far_x - closed3_of_far_x_left,
      closed3_of_far_x_right_rest = far_x_lo - closed3_of_far_x_right,
      closed3_of_far_x_lo = closed3_of_far_x_left_rest + closed3_of_far_x_right_rest,
      closed3 = closed3_of_rest3 / closed3_of_far_x,
      closed3_product = KSL_MUL(closed3, closed3_of_far_x),
      closed3_product_error = ksl_product_error(closed3, closed3_of_far_x, closed3_product),
      closed3_rest = closed3_of_rest3 - closed3_product,
      closed3_exact = closed3_rest - closed3_product_error,
      closed3_numerator = closed3_exact + closed3_of_rest3_lo,
      closed3_cross = KSL_MUL(closed3, closed3_of_far_x_lo),
      closed3_residual = closed3_numerator - closed3_cross,
      closed3_lo = closed3_residual / closed3_of_far_x;
  const double series5a = KSL_MUL(1.216125041553518e-34, far_x_a_of_x),
      series5a_cross1 = KSL_MUL(5.586290567888806e-51, far_x_a_of_x),
      series5a_cross2 = KSL_MUL(1.216125041553518e-34, far_x_a_of_x_lo),
      series5a_cross = series5a_cross1 + series5a_cross2,
      series5b = 1.1309962886447716e-31 - series5a,
      series5b_right = 1.1309962886447716e-31 - series5b, series5b_left = series5b + series5b_right,
      series5b_left_rest = 1.1309962886447716e-31 - series5b_left,
      series5b_right_rest = ksl_product_rest(1.216125041553518e-34, far_x_a_of_x, series5a,
          series5b_right),
      series5b_lo1 = series5b_left_rest - series5b_right_rest,
      series5b_lo2 = series5b_lo1 - series5a_cross,
      series5b_lo = series5b_lo2 + 1.0498015412959506e-47,
      series5c = KSL_MUL(far_x_a_of_x, series5b),
      series5c_cross1 = KSL_MUL(far_x_a_of_x_lo, series5b),
      series5c_cross2 = KSL_MUL(far_x_a_of_x, series5b_lo),
      series5c_cross = series5c_cross1 + series5c_cross2,
      series5d = series5c - 9.183689863795546e-29, series5d_right = series5c - series5d,
      series5d_left = series5d + series5d_right,
      series5d_left_rest = ksl_product_rest(far_x_a_of_x, series5b, series5c, series5d_left),
      series5d_right_rest = 9.183689863795546e-29 - series5d_right,
      series5d_lo1 = series5d_left_rest - series5d_right_rest,
      series5d_lo2 = series5d_lo1 - 1.4303150396787322e-45,
      series5d_lo = series5d_lo2 + series5c_cross, series5e = KSL_MUL(far_x_a_of_x, series5d),
      series5e_cross1 = KSL_MUL(far_x_a_of_x_lo, series5d),
      series5e_cross2 = KSL_MUL(far_x_a_of_x, series5d_lo),
      series5e_cross = series5e_cross1 + series5e_cross2,
      series5f = series5e + 6.446950284384474e-26, series5f_right = series5f - series5e,
      series5f_left = series5f - series5f_right,
      series5f_left_rest = ksl_product_rest(far_x_a_of_x, series5d, series5e, series5f_left),
      series5f_right_rest = 6.446950284384474e-26 - series5f_right,
      series5f_lo1 = series5f_left_rest + series5f_right_rest,
      series5f_lo2 = series5f_lo1 + -1.9330404233703465e-42,
      series5f_lo = series5f_lo2 + series5e_cross, series5g = KSL_MUL(far_x_a_of_x, series5f),
      series5g_cross1 = KSL_MUL(far_x_a_of_x_lo, series5f),
      series5g_cross2 = KSL_MUL(far_x_a_of_x, series5f_lo),
      series5g_cross = series5g_cross1 + series5g_cross2,
      series5h = series5g - 3.868170170630684e-23, series5h_right = series5g - series5h,
      series5h_left = series5h + series5h_right,
      series5h_left_rest = ksl_product_rest(far_x_a_of_x, series5f, series5g, series5h_left),
      series5h_right_rest = 3.868170170630684e-23 - series5h_right,
      series5h_lo1 = series5h_left_rest - series5h_right_rest,
      series5h_lo2 = series5h_lo1 - -8.843177655482344e-40,
      series5h_lo = series5h_lo2 + series5g_cross, series5i = KSL_MUL(far_x_a_of_x, series5h),
      series5i_cross1 = KSL_MUL(far_x_a_of_x_lo, series5h),
      series5i_cross2 = KSL_MUL(far_x_a_of_x, series5h_lo),
      series5i_cross = series5i_cross1 + series5i_cross2,
      series5j = series5i + 1.9572941063391263e-20, series5j_right = series5j - series5i,
      series5j_left = series5j - series5j_right,
      series5j_left_rest = ksl_product_rest(far_x_a_of_x, series5h, series5i, series5j_left),
      series5j_right_rest = 1.9572941063391263e-20 - series5j_right,
      series5j_lo1 = series5j_left_rest + series5j_right_rest,
      series5j_lo2 = series5j_lo1 + -1.3643503830087908e-36,
      series5j_lo = series5j_lo2 + series5i_cross, series5k = KSL_MUL(far_x_a_of_x, series5j),
      series5k_cross1 = KSL_MUL(far_x_a_of_x_lo, series5j),
      series5k_cross2 = KSL_MUL(far_x_a_of_x, series5j_lo),
      series5k_cross = series5k_cross1 + series5k_cross2,
      series5l = series5k - 8.22063524662433e-18, series5l_right = series5k - series5l,
      series5l_left = series5l + series5l_right,
      series5l_left_rest = ksl_product_rest(far_x_a_of_x, series5j, series5k, series5l_left),
      series5l_right_rest = 8.22063524662433e-18 - series5l_right,
      series5l_lo1 = series5l_left_rest - series5l_right_rest,
      series5l_lo2 = series5l_lo1 - 2.2141894119604265e-34,
      series5l_lo = series5l_lo2 + series5k_cross, series5m = KSL_MUL(far_x_a_of_x, series5l),
      series5m_cross1 = KSL_MUL(far_x_a_of_x_lo, series5l),
      series5m_cross2 = KSL_MUL(far_x_a_of_x, series5l_lo),
      series5m_cross = series5m_cross1 + series5m_cross2,
      series5n = series5m + 2.8114572543455206e-15, series5n_right = series5n - series5m,
      series5n_left = series5n - series5n_right,
      series5n_left_rest = ksl_product_rest(far_x_a_of_x, series5l, series5m, series5n_left),
      series5n_right_rest = 2.8114572543455206e-15 - series5n_right,
      series5n_lo1 = series5n_left_rest + series5n_right_rest,
      series5n_lo2 = series5n_lo1 + 1.6508842730861433e-31,
      series5n_lo = series5n_lo2 + series5m_cross, series5o = KSL_MUL(far_x_a_of_x, series5n),
      series5o_cross1 = KSL_MUL(far_x_a_of_x_lo, series5n),
      series5o_cross2 = KSL_MUL(far_x_a_of_x, series5n_lo),
      series5o_cross = series5o_cross1 + series5o_cross2,
      series5p = series5o - 7.647163731819816e-13, series5p_right = series5o - series5p,
      series5p_left = series5p + series5p_right,
      series5p_left_rest = ksl_product_rest(far_x_a_of_x, series5n, series5o, series5p_left),
      series5p_right_rest = 7.647163731819816e-13 - series5p_right,
      series5p_lo1 = series5p_left_rest - series5p_right_rest,
      series5p_lo2 = series5p_lo1 - 7.03872877733453e-30,
      series5p_lo = series5p_lo2 + series5o_cross, series5q = KSL_MUL(far_x_a_of_x, series5p),
      series5q_cross1 = KSL_MUL(far_x_a_of_x_lo, series5p),
      series5q_cross2 = KSL_MUL(far_x_a_of_x, series5p_lo),
      series5q_cross = series5q_cross1 + series5q_cross2,
      series5r = series5q + 1.6059043836821613e-10, series5r_right = series5r - series5q,
      series5r_left = series5r - series5r_right,
      series5r_left_rest = ksl_product_rest(far_x_a_of_x, series5p, series5q, series5r_left),
      series5r_right_rest = 1.6059043836821613e-10 - series5r_right,
      series5r_lo1 = series5r_left_rest + series5r_right_rest,
      series5r_lo2 = series5r_lo1 + 1.2585294588752098e-26,
      series5r_lo = series5r_lo2 + series5q_cross, series5s = KSL_MUL(far_x_a_of_x, series5r),
      series5s_cross1 = KSL_MUL(far_x_a_of_x_lo, series5r),
      series5s_cross2 = KSL_MUL(far_x_a_of_x, series5r_lo),
      series5s_cross = series5s_cross1 + series5s_cross2,
      series5t = series5s - 2.505210838544172e-08, series5t_right = series5s - series5t,
      series5t_left = series5t + series5t_right,
      series5t_left_rest = ksl_product_rest(far_x_a_of_x, series5r, series5s, series5t_left),
      series5t_right_rest = 2.505210838544172e-08 - series5t_right,
      series5t_lo1 = series5t_left_rest - series5t_right_rest,
      series5t_lo2 = series5t_lo1 - -1.448814070935912e-24,
      series5t_lo = series5t_lo2 + series5s_cross, series5u = KSL_MUL(far_x_a_of_x, series5t),
      series5u_cross1 = KSL_MUL(far_x_a_of_x_lo, series5t),
      series5u_cross2 = KSL_MUL(far_x_a_of_x, series5t_lo),
      series5u_cross = series5u_cross1 + series5u_cross2,
      series5v = series5u + 2.7557319223985893e-06, series5v_right = series5v - series5u,
      series5v_left = series5v - series5v_right,
      series5v_left_rest = ksl_product_rest(far_x_a_of_x, series5t, series5u, series5v_left),
      series5v_right_rest = 2.7557319223985893e-06 - series5v_right,
      series5v_lo1 = series5v_left_rest + series5v_right_rest,
      series5v_lo2 = series5v_lo1 + -1.858393274046472e-22,
      series5v_lo = series5v_lo2 + series5u_cross, series5w = KSL_MUL(far_x_a_of_x, series5v),
      series5w_cross1 = KSL_MUL(far_x_a_of_x_lo, series5v),
      series5w_cross2 = KSL_MUL(far_x_a_of_x, series5v_lo),
      series5w_cross = series5w_cross1 + series5w_cross2,
      series5x = series5w - 0.0001984126984126984, series5x_right = series5w - series5x,
      series5x_left = series5x + series5x_right,
      series5x_left_rest = ksl_product_rest(far_x_a_of_x, series5v, series5w, series5x_left),
      series5x_right_rest = 0.0001984126984126984 - series5x_right,
      series5x_lo1 = series5x_left_rest - series5x_right_rest,
      series5x_lo2 = series5x_lo1 - 1.7209558293420705e-22,
      series5x_lo = series5x_lo2 + series5w_cross, series5y = KSL_MUL(far_x_a_of_x, series5x),
      series5y_cross1 = KSL_MUL(far_x_a_of_x_lo, series5x),
      series5y_cross2 = KSL_MUL(far_x_a_of_x, series5x_lo),
      series5y_cross = series5y_cross1 + series5y_cross2, series5 = series5y + 0.008333333333333333,
      series5_right = series5 - series5y, series5_left = series5 - series5_right,
      series5_left_rest = ksl_product_rest(far_x_a_of_x, series5x, series5y, series5_left),
      series5_right_rest = 0.008333333333333333 - series5_right,
      series5_lo1 = series5_left_rest + series5_right_rest,
      series5_lo2 = series5_lo1 + 1.1564823173178714e-19, series5_lo = series5_lo2 + series5y_cross;
  const double g3a = KSL_MUL(far_x_a_of_x, series5), g3a_cross1 = KSL_MUL(far_x_a_of_x_lo, series5),
      g3a_cross2 = KSL_MUL(far_x_a_of_x, series5_lo), g3a_cross = g3a_cross1 + g3a_cross2,
      g3b = 0.16666666666666666 - g3a, g3b_right = 0.16666666666666666 - g3b,
      g3b_left = g3b + g3b_right, g3b_left_rest = 0.16666666666666666 - g3b_left,
      g3b_right_rest = ksl_product_rest(far_x_a_of_x, series5, g3a, g3b_right),
      g3b_lo1 = g3b_left_rest - g3b_right_rest, g3b_lo2 = g3b_lo1 - g3a_cross,
      g3b_lo = g3b_lo2 + 9.25185853854297e-18, g3 = far_x_a_of_x < 1.0 ? g3b : closed3,
      g3_lo = far_x_a_of_x < 1.0 ? g3b_lo : closed3_lo;
  const double beta_v_0 = KSL_MUL(v->x, g3), beta_v_0_cross2 = KSL_MUL(v->x, g3_lo);
  const double beta_v_1 = KSL_MUL(v->y, g3), beta_v_1_cross2 = KSL_MUL(v->y, g3_lo);
  const double beta_v_2 = KSL_MUL(v->z, g3), beta_v_2_cross2 = KSL_MUL(v->z, g3_lo);
  const double beta_v_0_error = ksl_product_error(v->x, g3, beta_v_0),
      beta_v_0_lo = beta_v_0_error + beta_v_0_cross2, m_0 = KSL_MUL(v->x, beta_v_0),
      m_0_cross2 = KSL_MUL(v->x, beta_v_0_lo);
  const double beta_v_1_error = ksl_product_error(v->y, g3, beta_v_1),
      beta_v_1_lo = beta_v_1_error + beta_v_1_cross2, m_1 = KSL_MUL(v->y, beta_v_1),
      m_1_cross2 = KSL_MUL(v->y, beta_v_1_lo);
  const double beta_v_2_error = ksl_product_error(v->z, g3, beta_v_2),
      beta_v_2_lo = beta_v_2_error + beta_v_2_cross2, m_2 = KSL_MUL(v->z, beta_v_2),
      m_2_cross2 = KSL_MUL(v->z, beta_v_2_lo);
  const double m_3 = KSL_MUL(v->y, beta_v_0), m_3_cross2 = KSL_MUL(v->y, beta_v_0_lo);
  const double m_4 = KSL_MUL(v->z, beta_v_0), m_4_cross2 = KSL_MUL(v->z, beta_v_0_lo);
  const double m_5 = KSL_MUL(v->z, beta_v_1), m_5_cross2 = KSL_MUL(v->z, beta_v_1_lo);
  const double others_0 = m_1 + m_2, others_0_right = others_0 - m_1,
      others_0_left = others_0 - others_0_right,
      others_0_left_rest = ksl_product_rest(v->y, beta_v_1, m_1, others_0_left),
      others_0_right_rest = ksl_product_rest(v->z, beta_v_2, m_2, others_0_right),
      others_0_cross = m_1_cross2 + m_2_cross2,
      others_0_lo1 = others_0_left_rest + others_0_right_rest,
      others_0_lo = others_0_lo1 + others_0_cross;
  const double others_1 = m_0 + m_2, others_1_right = others_1 - m_0,
      others_1_left = others_1 - others_1_right,
      others_1_left_rest = ksl_product_rest(v->x, beta_v_0, m_0, others_1_left),
      others_1_right_rest = ksl_product_rest(v->z, beta_v_2, m_2, others_1_right),
      others_1_cross = m_0_cross2 + m_2_cross2,
      others_1_lo1 = others_1_left_rest + others_1_right_rest,
      others_1_lo = others_1_lo1 + others_1_cross;
  const double others_2 = m_0 + m_1, others_2_right = others_2 - m_0,
      others_2_left = others_2 - others_2_right,
      others_2_left_rest = ksl_product_rest(v->x, beta_v_0, m_0, others_2_left),
      others_2_right_rest = ksl_product_rest(v->y, beta_v_1, m_1, others_2_right),
      others_2_cross = m_0_cross2 + m_1_cross2,
      others_2_lo1 = others_2_left_rest + others_2_right_rest,
      others_2_lo = others_2_lo1 + others_2_cross;
  const double diagonal0a = 1.0 - others_0, diagonal0a_right = 1.0 - diagonal0a,
      diagonal0a_left = diagonal0a + diagonal0a_right, diagonal0a_left_rest = 1.0 - diagonal0a_left,
      diagonal0a_right_rest = others_0 - diagonal0a_right,
      diagonal0a_lo1 = diagonal0a_left_rest - diagonal0a_right_rest,
      diagonal0a_lo = diagonal0a_lo1 - others_0_lo, diagonal0b = g1 + m_0,
      diagonal0b_right = diagonal0b - g1, diagonal0b_left = diagonal0b - diagonal0b_right,
      diagonal0b_left_rest = ksl_product_rest(c, sinc, g1, diagonal0b_left),
      diagonal0b_right_rest = ksl_product_rest(v->x, beta_v_0, m_0, diagonal0b_right),
      diagonal0b_cross = g1_cross + m_0_cross2,
      diagonal0b_lo1 = diagonal0b_left_rest + diagonal0b_right_rest,
      diagonal0b_lo = diagonal0b_lo1 + diagonal0b_cross,
      m_0_error = ksl_product_error(v->x, beta_v_0, m_0), m_0_lo = m_0_error + m_0_cross2,
      diagonal0c_of_m_0 = m_0 + m_0_lo, diagonal0c_of_others_0 = others_0 + others_0_lo,
      diagonal0 = diagonal0c_of_m_0 < diagonal0c_of_others_0 ? diagonal0b : diagonal0a,
      diagonal0_lo = diagonal0c_of_m_0 < diagonal0c_of_others_0 ? diagonal0b_lo : diagonal0a_lo;
  const double diagonal1a = 1.0 - others_1, diagonal1a_right = 1.0 - diagonal1a,
      diagonal1a_left = diagonal1a + diagonal1a_right, diagonal1a_left_rest = 1.0 - diagonal1a_left,
      diagonal1a_right_rest = others_1 - diagonal1a_right,
      diagonal1a_lo1 = diagonal1a_left_rest - diagonal1a_right_rest,
      diagonal1a_lo = diagonal1a_lo1 - others_1_lo, diagonal1b = g1 + m_1,
      diagonal1b_right = diagonal1b - g1, diagonal1b_left = diagonal1b - diagonal1b_right,
      diagonal1b_left_rest = ksl_product_rest(c, sinc, g1, diagonal1b_left),
      diagonal1b_right_rest = ksl_product_rest(v->y, beta_v_1, m_1, diagonal1b_right),
      diagonal1b_cross = g1_cross + m_1_cross2,
      diagonal1b_lo1 = diagonal1b_left_rest + diagonal1b_right_rest,
      diagonal1b_lo = diagonal1b_lo1 + diagonal1b_cross,
      m_1_error = ksl_product_error(v->y, beta_v_1, m_1), m_1_lo = m_1_error + m_1_cross2,
      diagonal1c_of_m_1 = m_1 + m_1_lo, diagonal1c_of_others_1 = others_1 + others_1_lo,
      diagonal1 = diagonal1c_of_m_1 < diagonal1c_of_others_1 ? diagonal1b : diagonal1a,
      diagonal1_lo = diagonal1c_of_m_1 < diagonal1c_of_others_1 ? diagonal1b_lo : diagonal1a_lo;
  const double diagonal2a = 1.0 - others_2, diagonal2a_right = 1.0 - diagonal2a,
      diagonal2a_left = diagonal2a + diagonal2a_right, diagonal2a_left_rest = 1.0 - diagonal2a_left,
      diagonal2a_right_rest = others_2 - diagonal2a_right,
      diagonal2a_lo1 = diagonal2a_left_rest - diagonal2a_right_rest,
      diagonal2a_lo = diagonal2a_lo1 - others_2_lo, diagonal2b = g1 + m_2,
      diagonal2b_right = diagonal2b - g1, diagonal2b_left = diagonal2b - diagonal2b_right,
      diagonal2b_left_rest = ksl_product_rest(c, sinc, g1, diagonal2b_left),
      diagonal2b_right_rest = ksl_product_rest(v->z, beta_v_2, m_2, diagonal2b_right),
      diagonal2b_cross = g1_cross + m_2_cross2,
      diagonal2b_lo1 = diagonal2b_left_rest + diagonal2b_right_rest,
      diagonal2b_lo = diagonal2b_lo1 + diagonal2b_cross,
      m_2_error = ksl_product_error(v->z, beta_v_2, m_2), m_2_lo = m_2_error + m_2_cross2,
      diagonal2c_of_m_2 = m_2 + m_2_lo, diagonal2c_of_others_2 = others_2 + others_2_lo,
      diagonal2 = diagonal2c_of_m_2 < diagonal2c_of_others_2 ? diagonal2b : diagonal2a,
      diagonal2_lo = diagonal2c_of_m_2 < diagonal2c_of_others_2 ? diagonal2b_lo : diagonal2a_lo;
  const double alpha_v_0a = KSL_MUL(v->x, g2), alpha_v_0a_cross2 = KSL_MUL(v->x, g2_cross2),
      alpha_v_0 = -alpha_v_0a, alpha_v_0_cross = -alpha_v_0a_cross2, alpha_v_0_factor = -v->x;
  const double alpha_v_1a = KSL_MUL(v->y, g2), alpha_v_1a_cross2 = KSL_MUL(v->y, g2_cross2),
      alpha_v_1 = -alpha_v_1a, alpha_v_1_cross = -alpha_v_1a_cross2, alpha_v_1_factor = -v->y;
  const double alpha_v_2a = KSL_MUL(v->z, g2), alpha_v_2a_cross2 = KSL_MUL(v->z, g2_cross2),
      alpha_v_2 = -alpha_v_2a, alpha_v_2_cross = -alpha_v_2a_cross2, alpha_v_2_factor = -v->z;
  const double R_01 = m_3 - alpha_v_2, R_01_right = m_3 - R_01, R_01_left = R_01 + R_01_right,
      R_01_left_rest = ksl_product_rest(v->y, beta_v_0, m_3, R_01_left),
      R_01_right_rest = ksl_product_rest(alpha_v_2_factor, g2, alpha_v_2, R_01_right),
      R_01_cross = m_3_cross2 - alpha_v_2_cross, R_01_lo1 = R_01_left_rest - R_01_right_rest,
      R_01_lo = R_01_lo1 + R_01_cross;
  const double R_02 = m_4 + alpha_v_1, R_02_right = R_02 - m_4, R_02_left = R_02 - R_02_right,
      R_02_left_rest = ksl_product_rest(v->z, beta_v_0, m_4, R_02_left),
      R_02_right_rest = ksl_product_rest(alpha_v_1_factor, g2, alpha_v_1, R_02_right),
      R_02_cross = m_4_cross2 + alpha_v_1_cross, R_02_lo1 = R_02_left_rest + R_02_right_rest,
      R_02_lo = R_02_lo1 + R_02_cross;
  const double R_10 = m_3 + alpha_v_2, R_10_right = R_10 - m_3, R_10_left = R_10 - R_10_right,
      R_10_left_rest = ksl_product_rest(v->y, beta_v_0, m_3, R_10_left),
      R_10_right_rest = ksl_product_rest(alpha_v_2_factor, g2, alpha_v_2, R_10_right),
      R_10_cross = m_3_cross2 + alpha_v_2_cross, R_10_lo1 = R_10_left_rest + R_10_right_rest,
      R_10_lo = R_10_lo1 + R_10_cross;
  const double R_12 = m_5 - alpha_v_0, R_12_right = m_5 - R_12, R_12_left = R_12 + R_12_right,
      R_12_left_rest = ksl_product_rest(v->z, beta_v_1, m_5, R_12_left),
      R_12_right_rest = ksl_product_rest(alpha_v_0_factor, g2, alpha_v_0, R_12_right),
      R_12_cross = m_5_cross2 - alpha_v_0_cross, R_12_lo1 = R_12_left_rest - R_12_right_rest,
      R_12_lo = R_12_lo1 + R_12_cross;
  const double R_20 = m_4 - alpha_v_1, R_20_right = m_4 - R_20, R_20_left = R_20 + R_20_right,
      R_20_left_rest = ksl_product_rest(v->z, beta_v_0, m_4, R_20_left),
      R_20_right_rest = ksl_product_rest(alpha_v_1_factor, g2, alpha_v_1, R_20_right),
      R_20_cross = m_4_cross2 - alpha_v_1_cross, R_20_lo1 = R_20_left_rest - R_20_right_rest,
      R_20_lo = R_20_lo1 + R_20_cross;
  const double R_21 = m_5 + alpha_v_0, R_21_right = R_21 - m_5, R_21_left = R_21 - R_21_right,
      R_21_left_rest = ksl_product_rest(v->z, beta_v_1, m_5, R_21_left),
      R_21_right_rest = ksl_product_rest(alpha_v_0_factor, g2, alpha_v_0, R_21_right),
      R_21_cross = m_5_cross2 + alpha_v_0_cross, R_21_lo1 = R_21_left_rest + R_21_right_rest,
      R_21_lo = R_21_lo1 + R_21_cross;
  const double diagonal0_rounded = diagonal0 + diagonal0_lo,
      diagonal0_final = diagonal0_rounded == diagonal0_rounded ? diagonal0_rounded : diagonal0;
  const double R_01_rounded = R_01 + R_01_lo,
      R_01_final = R_01_rounded == R_01_rounded ? R_01_rounded : R_01;
  const double R_02_rounded = R_02 + R_02_lo,
      R_02_final = R_02_rounded == R_02_rounded ? R_02_rounded : R_02;
  const double R_10_rounded = R_10 + R_10_lo,
      R_10_final = R_10_rounded == R_10_rounded ? R_10_rounded : R_10;
  const double diagonal1_rounded = diagonal1 + diagonal1_lo,
      diagonal1_final = diagonal1_rounded == diagonal1_rounded ? diagonal1_rounded : diagonal1;
  const double R_12_rounded = R_12 + R_12_lo,
      R_12_final = R_12_rounded == R_12_rounded ? R_12_rounded : R_12;
  const double R_20_rounded = R_20 + R_20_lo,
      R_20_final = R_20_rounded == R_20_rounded ? R_20_rounded : R_20;
  const double R_21_rounded = R_21 + R_21_lo,
      R_21_final = R_21_rounded == R_21_rounded ? R_21_rounded : R_21;
  const double diagonal2_rounded = diagonal2 + diagonal2_lo,
      diagonal2_final = diagonal2_rounded == diagonal2_rounded ? diagonal2_rounded : diagonal2;
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
  const double halved_0 = KSL_MUL(0.5, v->x);
  const double halved_1 = KSL_MUL(0.5, v->y);
  const double halved_2 = KSL_MUL(0.5, v->z);
  const double y_a = KSL_MUL(halved_0, halved_0), y_b = KSL_MUL(halved_1, halved_1),
      y_c = y_a + y_b, y_c_right = y_c - y_a, y_c_left = y_c - y_c_right,
      y_c_left_rest = ksl_product_rest(halved_0, halved_0, y_a, y_c_left),
      y_c_right_rest = ksl_product_rest(halved_1, halved_1, y_b, y_c_right),
      y_c_lo = y_c_left_rest + y_c_right_rest, y_d = KSL_MUL(halved_2, halved_2), y = y_c + y_d,
      y_right = y - y_c, y_left = y - y_right, y_left_rest = y_c - y_left,
      y_right_rest = ksl_product_rest(halved_2, halved_2, y_d, y_right),
      y_lo1 = y_left_rest + y_right_rest, y_lo = y_lo1 + y_c_lo;
  const double half_angle_of_y = y + y_lo, half_angle_of_y_right = half_angle_of_y - y,
      half_angle_of_y_left = half_angle_of_y - half_angle_of_y_right,
      half_angle_of_y_left_rest = y - half_angle_of_y_left,
      half_angle_of_y_right_rest = y_lo - half_angle_of_y_right,
      half_angle_of_y_lo = half_angle_of_y_left_rest + half_angle_of_y_right_rest,
      half_angle = sqrt(half_angle_of_y), half_angle_product = KSL_MUL(half_angle, half_angle),
      half_angle_product_error = ksl_product_error(half_angle, half_angle, half_angle_product),
      half_angle_rest = half_angle_of_y - half_angle_product,
      half_angle_exact = half_angle_rest - half_angle_product_error,
      half_angle_residual = half_angle_exact + half_angle_of_y_lo,
      half_angle_twice = half_angle + half_angle,
      half_angle_divisor = half_angle == 0.0 ? 1.0 : half_angle_twice,
      half_angle_lo = half_angle_residual / half_angle_divisor;
  const double sine_of_half_angle = half_angle + half_angle_lo,
      sine_of_half_angle_right = sine_of_half_angle - half_angle,
      sine_of_half_angle_left = sine_of_half_angle - sine_of_half_angle_right,
      sine_of_half_angle_left_rest = half_angle - sine_of_half_angle_left,
      sine_of_half_angle_right_rest = half_angle_lo - sine_of_half_angle_right,
      sine_of_half_angle_lo = sine_of_half_angle_left_rest + sine_of_half_angle_right_rest;
  double c; const double sine = ksl_sincos(sine_of_half_angle, &c);
  double c_own_error; const double sine_own_error = ksl_sincos_error(sine_of_half_angle, sine, c,
      &c_own_error);
  const double sine_half = KSL_MUL(sine_of_half_angle_lo, 0.5);
  double sine_half_cos; const double sine_half_sin = ksl_sincos(sine_half, &sine_half_cos);
  const double sine_twice = sine_half_sin + sine_half_sin, sine_slope1 = KSL_MUL(sine_half_cos, c),
      sine_slope2 = KSL_MUL(sine_half_sin, sine), sine_slope = sine_slope1 - sine_slope2,
      sine_more = KSL_MUL(sine_slope, sine_twice), sine_lo = sine_own_error + sine_more;
  const double c_slope1 = KSL_MUL(sine_half_cos, sine), c_slope2 = KSL_MUL(sine_half_sin, c),
      c_slope = c_slope1 + c_slope2, c_more = KSL_MUL(c_slope, sine_twice),
      c_lo = c_own_error - c_more;
  const double sinc_divisor = sine_of_half_angle < 1.4901161193847656e-08 ? 1.4901161193847656e-08 :
      sine_of_half_angle,
      sinc_divisor_lo = sine_of_half_angle < 1.4901161193847656e-08 ? 0.0 : sine_of_half_angle_lo;
  const double sinc_quotient_of_sine = sine + sine_lo,
      sinc_quotient_of_sine_right = sinc_quotient_of_sine - sine,
      sinc_quotient_of_sine_left = sinc_quotient_of_sine - sinc_quotient_of_sine_right,
      sinc_quotient_of_sine_left_rest = sine - sinc_quotient_of_sine_left,
      sinc_quotient_of_sine_right_rest = sine_lo - sinc_quotient_of_sine_right,
      sinc_quotient_of_sine_lo = sinc_quotient_of_sine_left_rest + sinc_quotient_of_sine_right_rest,
      sinc_quotient_of_sinc_divisor = sinc_divisor + sinc_divisor_lo,
      sinc_quotient_of_sinc_divisor_right = sinc_quotient_of_sinc_divisor - sinc_divisor,
      sinc_quotient_of_sinc_divisor_left = sinc_quotient_of_sinc_divisor -
          sinc_quotient_of_sinc_divisor_right,
      sinc_quotient_of_sinc_divisor_left_rest = sinc_divisor - sinc_quotient_of_sinc_divisor_left,
      sinc_quotient_of_sinc_divisor_right_rest = sinc_divisor_lo -
          sinc_quotient_of_sinc_divisor_right,
      sinc_quotient_of_sinc_divisor_lo = sinc_quotient_of_sinc_divisor_left_rest +
          sinc_quotient_of_sinc_divisor_right_rest,
      sinc_quotient = sinc_quotient_of_sine / sinc_quotient_of_sinc_divisor,
      sinc_quotient_product = KSL_MUL(sinc_quotient, sinc_quotient_of_sinc_divisor),
      sinc_quotient_product_error = ksl_product_error(sinc_quotient, sinc_quotient_of_sinc_divisor,
          sinc_quotient_product),
      sinc_quotient_rest = sinc_quotient_of_sine - sinc_quotient_product,
      sinc_quotient_exact = sinc_quotient_rest - sinc_quotient_product_error,
      sinc_quotient_numerator = sinc_quotient_exact + sinc_quotient_of_sine_lo,
      sinc_quotient_cross = KSL_MUL(sinc_quotient, sinc_quotient_of_sinc_divisor_lo),
      sinc_quotient_residual = sinc_quotient_numerator - sinc_quotient_cross,
      sinc_quotient_lo = sinc_quotient_residual / sinc_quotient_of_sinc_divisor;
  const double sinc_a = KSL_MUL(0.16666666666666666, half_angle_of_y),
      sinc_a_cross1 = KSL_MUL(9.25185853854297e-18, half_angle_of_y),
      sinc_a_cross2 = KSL_MUL(0.16666666666666666, half_angle_of_y_lo),
      sinc_a_cross = sinc_a_cross1 + sinc_a_cross2, sinc_b = 1.0 - sinc_a,
      sinc_b_right = 1.0 - sinc_b, sinc_b_left = sinc_b + sinc_b_right,
      sinc_b_left_rest = 1.0 - sinc_b_left,
      sinc_b_right_rest = ksl_product_rest(0.16666666666666666, half_angle_of_y, sinc_a,
          sinc_b_right),
      sinc_b_lo1 = sinc_b_left_rest - sinc_b_right_rest, sinc_b_lo = sinc_b_lo1 - sinc_a_cross,
      sinc = sine_of_half_angle < 1.4901161193847656e-08 ? sinc_b : sinc_quotient,
      sinc_lo = sine_of_half_angle < 1.4901161193847656e-08 ? sinc_b_lo : sinc_quotient_lo;
  const double series_phi_a = KSL_MUL(5.107725174524775e-32, half_angle_of_y),
      series_phi_a_cross1 = KSL_MUL(4.7410392187559056e-48, half_angle_of_y),
      series_phi_a_cross2 = KSL_MUL(5.107725174524775e-32, half_angle_of_y_lo),
      series_phi_a_cross = series_phi_a_cross1 + series_phi_a_cross2,
      series_phi_b = 4.116826490666969e-29 - series_phi_a,
      series_phi_b_right = 4.116826490666969e-29 - series_phi_b,
      series_phi_b_left = series_phi_b + series_phi_b_right,
      series_phi_b_left_rest = 4.116826490666969e-29 - series_phi_b_left,
      series_phi_b_right_rest = ksl_product_rest(5.107725174524775e-32, half_angle_of_y,
          series_phi_a, series_phi_b_right),
      series_phi_b_lo1 = series_phi_b_left_rest - series_phi_b_right_rest,
      series_phi_b_lo2 = series_phi_b_lo1 - series_phi_a_cross,
      series_phi_b_lo = series_phi_b_lo2 + -1.8714974010023092e-45,
      series_phi_c = KSL_MUL(half_angle_of_y, series_phi_b),
      series_phi_c_cross1 = KSL_MUL(half_angle_of_y_lo, series_phi_b),
      series_phi_c_cross2 = KSL_MUL(half_angle_of_y, series_phi_b_lo),
      series_phi_c_cross = series_phi_c_cross1 + series_phi_c_cross2,
      series_phi_d = series_phi_c - 2.86531123750421e-26,
      series_phi_d_right = series_phi_c - series_phi_d,
      series_phi_d_left = series_phi_d + series_phi_d_right,
      series_phi_d_left_rest = ksl_product_rest(half_angle_of_y, series_phi_b, series_phi_c,
          series_phi_d_left),
      series_phi_d_right_rest = 2.86531123750421e-26 - series_phi_d_right,
      series_phi_d_lo1 = series_phi_d_left_rest - series_phi_d_right_rest,
      series_phi_d_lo2 = series_phi_d_lo1 - 2.3296034284323186e-42,
      series_phi_d_lo = series_phi_d_lo2 + series_phi_c_cross,
      series_phi_e = KSL_MUL(half_angle_of_y, series_phi_d),
      series_phi_e_cross1 = KSL_MUL(half_angle_of_y_lo, series_phi_d),
      series_phi_e_cross2 = KSL_MUL(half_angle_of_y, series_phi_d_lo),
      series_phi_e_cross = series_phi_e_cross1 + series_phi_e_cross2,
      series_phi_f = series_phi_e + 1.701994875077501e-23,
      series_phi_f_right = series_phi_f - series_phi_e,
      series_phi_f_left = series_phi_f - series_phi_f_right,
      series_phi_f_left_rest = ksl_product_rest(half_angle_of_y, series_phi_d, series_phi_e,
          series_phi_f_left),
      series_phi_f_right_rest = 1.701994875077501e-23 - series_phi_f_right,
      series_phi_f_lo1 = series_phi_f_left_rest + series_phi_f_right_rest,
      series_phi_f_lo2 = series_phi_f_lo1 + 3.161967936521494e-40,
      series_phi_f_lo = series_phi_f_lo2 + series_phi_e_cross,
      series_phi_g = KSL_MUL(half_angle_of_y, series_phi_f),
      series_phi_g_cross1 = KSL_MUL(half_angle_of_y_lo, series_phi_f),
      series_phi_g_cross2 = KSL_MUL(half_angle_of_y, series_phi_f_lo),
      series_phi_g_cross = series_phi_g_cross1 + series_phi_g_cross2,
      series_phi_h = series_phi_g - 8.509974375387505e-21,
      series_phi_h_right = series_phi_g - series_phi_h,
      series_phi_h_left = series_phi_h + series_phi_h_right,
      series_phi_h_left_rest = ksl_product_rest(half_angle_of_y, series_phi_f, series_phi_g,
          series_phi_h_left),
      series_phi_h_right_rest = 8.509974375387505e-21 - series_phi_h_right,
      series_phi_h_lo1 = series_phi_h_left_rest - series_phi_h_right_rest,
      series_phi_h_lo2 = series_phi_h_lo1 - 3.2266760594119493e-37,
      series_phi_h_lo = series_phi_h_lo2 + series_phi_g_cross,
      series_phi_i = KSL_MUL(half_angle_of_y, series_phi_h),
      series_phi_i_cross1 = KSL_MUL(half_angle_of_y_lo, series_phi_h),
      series_phi_i_cross2 = KSL_MUL(half_angle_of_y, series_phi_h_lo),
      series_phi_i_cross = series_phi_i_cross1 + series_phi_i_cross2,
      series_phi_j = series_phi_i + 3.523129391410427e-18,
      series_phi_j_right = series_phi_j - series_phi_i,
      series_phi_j_left = series_phi_j - series_phi_j_right,
      series_phi_j_left_rest = ksl_product_rest(half_angle_of_y, series_phi_h, series_phi_i,
          series_phi_j_left),
      series_phi_j_right_rest = 3.523129391410427e-18 - series_phi_j_right,
      series_phi_j_lo1 = series_phi_j_left_rest + series_phi_j_right_rest,
      series_phi_j_lo2 = series_phi_j_lo1 + -1.2521244741738012e-34,
      series_phi_j_lo = series_phi_j_lo2 + series_phi_i_cross,
      series_phi_k = KSL_MUL(half_angle_of_y, series_phi_j),
      series_phi_k_cross1 = KSL_MUL(half_angle_of_y_lo, series_phi_j),
      series_phi_k_cross2 = KSL_MUL(half_angle_of_y, series_phi_j_lo),
      series_phi_k_cross = series_phi_k_cross1 + series_phi_k_cross2,
      series_phi_l = series_phi_k - 1.1837714755139035e-15,
      series_phi_l_right = series_phi_k - series_phi_l,
      series_phi_l_left = series_phi_l + series_phi_l_right,
      series_phi_l_left_rest = ksl_product_rest(half_angle_of_y, series_phi_j, series_phi_k,
          series_phi_l_left),
      series_phi_l_right_rest = 1.1837714755139035e-15 - series_phi_l_right,
      series_phi_l_lo1 = series_phi_l_left_rest - series_phi_l_right_rest,
      series_phi_l_lo2 = series_phi_l_lo1 - 7.23242424407352e-33,
      series_phi_l_lo = series_phi_l_lo2 + series_phi_k_cross,
      series_phi_m = KSL_MUL(half_angle_of_y, series_phi_l),
      series_phi_m_cross1 = KSL_MUL(half_angle_of_y_lo, series_phi_l),
      series_phi_m_cross2 = KSL_MUL(half_angle_of_y, series_phi_l_lo),
      series_phi_m_cross = series_phi_m_cross1 + series_phi_m_cross2,
      series_phi_n = series_phi_m + 3.148832124866983e-13,
      series_phi_n_right = series_phi_n - series_phi_m,
      series_phi_n_left = series_phi_n - series_phi_n_right,
      series_phi_n_left_rest = ksl_product_rest(half_angle_of_y, series_phi_l, series_phi_m,
          series_phi_n_left),
      series_phi_n_right_rest = 3.148832124866983e-13 - series_phi_n_right,
      series_phi_n_lo1 = series_phi_n_left_rest + series_phi_n_right_rest,
      series_phi_n_lo2 = series_phi_n_lo1 + 5.8681293750286156e-30,
      series_phi_n_lo = series_phi_n_lo2 + series_phi_m_cross,
      series_phi_o = KSL_MUL(half_angle_of_y, series_phi_n),
      series_phi_o_cross1 = KSL_MUL(half_angle_of_y_lo, series_phi_n),
      series_phi_o_cross2 = KSL_MUL(half_angle_of_y, series_phi_n_lo),
      series_phi_o_cross = series_phi_o_cross1 + series_phi_o_cross2,
      series_phi_p = series_phi_o - 6.423617534728645e-11,
      series_phi_p_right = series_phi_o - series_phi_p,
      series_phi_p_left = series_phi_p + series_phi_p_right,
      series_phi_p_left_rest = ksl_product_rest(half_angle_of_y, series_phi_n, series_phi_o,
          series_phi_p_left),
      series_phi_p_right_rest = 6.423617534728645e-11 - series_phi_p_right,
      series_phi_p_lo1 = series_phi_p_left_rest - series_phi_p_right_rest,
      series_phi_p_lo2 = series_phi_p_lo1 - 5.034117835500839e-27,
      series_phi_p_lo = series_phi_p_lo2 + series_phi_o_cross,
      series_phi_q = KSL_MUL(half_angle_of_y, series_phi_p),
      series_phi_q_cross1 = KSL_MUL(half_angle_of_y_lo, series_phi_p),
      series_phi_q_cross2 = KSL_MUL(half_angle_of_y, series_phi_p_lo),
      series_phi_q_cross = series_phi_q_cross1 + series_phi_q_cross2,
      series_phi_r = series_phi_q + 9.635426302092969e-09,
      series_phi_r_right = series_phi_r - series_phi_q,
      series_phi_r_left = series_phi_r - series_phi_r_right,
      series_phi_r_left_rest = ksl_product_rest(half_angle_of_y, series_phi_p, series_phi_q,
          series_phi_r_left),
      series_phi_r_right_rest = 9.635426302092969e-09 - series_phi_r_right,
      series_phi_r_lo1 = series_phi_r_left_rest + series_phi_r_right_rest,
      series_phi_r_lo2 = series_phi_r_lo1 + -1.7546051379703029e-25,
      series_phi_r_lo = series_phi_r_lo2 + series_phi_q_cross,
      series_phi_s = KSL_MUL(half_angle_of_y, series_phi_r),
      series_phi_s_cross1 = KSL_MUL(half_angle_of_y_lo, series_phi_r),
      series_phi_s_cross2 = KSL_MUL(half_angle_of_y, series_phi_r_lo),
      series_phi_s_cross = series_phi_s_cross1 + series_phi_s_cross2,
      series_phi_t = series_phi_s - 1.0020843354176687e-06,
      series_phi_t_right = series_phi_s - series_phi_t,
      series_phi_t_left = series_phi_t + series_phi_t_right,
      series_phi_t_left_rest = ksl_product_rest(half_angle_of_y, series_phi_r, series_phi_s,
          series_phi_t_left),
      series_phi_t_right_rest = 1.0020843354176687e-06 - series_phi_t_right,
      series_phi_t_lo1 = series_phi_t_left_rest - series_phi_t_right_rest,
      series_phi_t_lo2 = series_phi_t_lo1 - 4.7926555569351065e-23,
      series_phi_t_lo = series_phi_t_lo2 + series_phi_s_cross,
      series_phi_u = KSL_MUL(half_angle_of_y, series_phi_t),
      series_phi_u_cross1 = KSL_MUL(half_angle_of_y_lo, series_phi_t),
      series_phi_u_cross2 = KSL_MUL(half_angle_of_y, series_phi_t_lo),
      series_phi_u_cross = series_phi_u_cross1 + series_phi_u_cross2,
      series_phi_v = series_phi_u + 6.613756613756614e-05,
      series_phi_v_right = series_phi_v - series_phi_u,
      series_phi_v_left = series_phi_v - series_phi_v_right,
      series_phi_v_left_rest = ksl_product_rest(half_angle_of_y, series_phi_t, series_phi_u,
          series_phi_v_left),
      series_phi_v_right_rest = 6.613756613756614e-05 - series_phi_v_right,
      series_phi_v_lo1 = series_phi_v_left_rest + series_phi_v_right_rest,
      series_phi_v_lo2 = series_phi_v_lo1 + -4.460143857711533e-21,
      series_phi_v_lo = series_phi_v_lo2 + series_phi_u_cross,
      series_phi_w = KSL_MUL(half_angle_of_y, series_phi_v),
      series_phi_w_cross1 = KSL_MUL(half_angle_of_y_lo, series_phi_v),
      series_phi_w_cross2 = KSL_MUL(half_angle_of_y, series_phi_v_lo),
      series_phi_w_cross = series_phi_w_cross1 + series_phi_w_cross2,
      series_phi_x = series_phi_w - 0.002380952380952381,
      series_phi_x_right = series_phi_w - series_phi_x,
      series_phi_x_left = series_phi_x + series_phi_x_right,
      series_phi_x_left_rest = ksl_product_rest(half_angle_of_y, series_phi_v, series_phi_w,
          series_phi_x_left),
      series_phi_x_right_rest = 0.002380952380952381 - series_phi_x_right,
      series_phi_x_lo1 = series_phi_x_left_rest - series_phi_x_right_rest,
      series_phi_x_lo2 = series_phi_x_lo1 - -2.147752875018904e-19,
      series_phi_x_lo = series_phi_x_lo2 + series_phi_w_cross,
      series_phi_y = KSL_MUL(half_angle_of_y, series_phi_x),
      series_phi_y_cross1 = KSL_MUL(half_angle_of_y_lo, series_phi_x),
      series_phi_y_cross2 = KSL_MUL(half_angle_of_y, series_phi_x_lo),
      series_phi_y_cross = series_phi_y_cross1 + series_phi_y_cross2,
      series_phi = series_phi_y + 0.03333333333333333, series_phi_right = series_phi - series_phi_y,
      series_phi_left = series_phi - series_phi_right,
      series_phi_left_rest = ksl_product_rest(half_angle_of_y, series_phi_x, series_phi_y,
          series_phi_left),
      series_phi_right_rest = 0.03333333333333333 - series_phi_right,
      series_phi_lo1 = series_phi_left_rest + series_phi_right_rest,
      series_phi_lo2 = series_phi_lo1 + 4.625929269271486e-19,
      series_phi_lo = series_phi_lo2 + series_phi_y_cross;
  const double f_more_a = KSL_MUL(2.0, half_angle_of_y),
      f_more_a_cross2 = KSL_MUL(2.0, half_angle_of_y_lo), f_more = KSL_MUL(f_more_a, series_phi),
      f_more_cross1 = KSL_MUL(f_more_a_cross2, series_phi),
      f_more_cross2 = KSL_MUL(f_more_a, series_phi_lo),
      f_more_cross = f_more_cross1 + f_more_cross2;
  const double near_f_a = KSL_MUL(0.3333333333333333, sinc),
      near_f_a_cross1 = KSL_MUL(1.850371707708594e-17, sinc),
      near_f_a_cross2 = KSL_MUL(0.3333333333333333, sinc_lo),
      near_f_a_cross = near_f_a_cross1 + near_f_a_cross2,
      f_more_error = ksl_product_error(f_more_a, series_phi, f_more),
      f_more_lo = f_more_error + f_more_cross, near_f_b = KSL_MUL(0.3333333333333333, f_more),
      near_f_b_cross1 = KSL_MUL(1.850371707708594e-17, f_more),
      near_f_b_cross2 = KSL_MUL(0.3333333333333333, f_more_lo),
      near_f_b_cross = near_f_b_cross1 + near_f_b_cross2, near_f = near_f_a + near_f_b,
      near_f_right = near_f - near_f_a, near_f_left = near_f - near_f_right,
      near_f_left_rest = ksl_product_rest(0.3333333333333333, sinc, near_f_a, near_f_left),
      near_f_right_rest = ksl_product_rest(0.3333333333333333, f_more, near_f_b, near_f_right),
      near_f_cross = near_f_a_cross + near_f_b_cross,
      near_f_lo1 = near_f_left_rest + near_f_right_rest, near_f_lo = near_f_lo1 + near_f_cross;
  const double f_rest = sinc - c, f_rest_right = sinc - f_rest, f_rest_left = f_rest + f_rest_right,
      f_rest_left_rest = sinc - f_rest_left, f_rest_right_rest = c - f_rest_right,
      f_rest_lo1 = f_rest_left_rest - f_rest_right_rest, f_rest_lo2 = f_rest_lo1 - c_lo,
      f_rest_lo = f_rest_lo2 + sinc_lo;
  const double x = KSL_MUL(4.0, half_angle_of_y), x_cross2 = KSL_MUL(4.0, half_angle_of_y_lo);
  const double far_y_a_of_x = x + x_cross2, far_y = far_y_a_of_x < 4.0 ? 1.0 : half_angle_of_y,
      far_y_lo = far_y_a_of_x < 4.0 ? 0.0 : half_angle_of_y_lo;
  const double closed_f_of_f_rest = f_rest + f_rest_lo,
      closed_f_of_f_rest_right = closed_f_of_f_rest - f_rest,
      closed_f_of_f_rest_left = closed_f_of_f_rest - closed_f_of_f_rest_right,
      closed_f_of_f_rest_left_rest = f_rest - closed_f_of_f_rest_left,
      closed_f_of_f_rest_right_rest = f_rest_lo - closed_f_of_f_rest_right,
      closed_f_of_f_rest_lo = closed_f_of_f_rest_left_rest + closed_f_of_f_rest_right_rest,
      closed_f_of_far_y = far_y + far_y_lo, closed_f_of_far_y_right = closed_f_of_far_y - far_y,
      closed_f_of_far_y_left = closed_f_of_far_y - closed_f_of_far_y_right,
      closed_f_of_far_y_left_rest = far_y - closed_f_of_far_y_left,
      closed_f_of_far_y_right_rest = far_y_lo - closed_f_of_far_y_right,
      closed_f_of_far_y_lo = closed_f_of_far_y_left_rest + closed_f_of_far_y_right_rest,
      closed_f = closed_f_of_f_rest / closed_f_of_far_y,
      closed_f_product = KSL_MUL(closed_f, closed_f_of_far_y),
      closed_f_product_error = ksl_product_error(closed_f, closed_f_of_far_y, closed_f_product),
      closed_f_rest = closed_f_of_f_rest - closed_f_product,
      closed_f_exact = closed_f_rest - closed_f_product_error,
      closed_f_numerator = closed_f_exact + closed_f_of_f_rest_lo,
      closed_f_cross = KSL_MUL(closed_f, closed_f_of_far_y_lo),
      closed_f_residual = closed_f_numerator - closed_f_cross,
      closed_f_lo = closed_f_residual / closed_f_of_far_y;
  const double f = far_y_a_of_x < 4.0 ? near_f : closed_f,
      f_lo = far_y_a_of_x < 4.0 ? near_f_lo : closed_f_lo;
  const double four_k = KSL_MUL(4.0, sinc), four_k_cross2 = KSL_MUL(4.0, sinc_lo);
  const double b_of_f = f + f_lo, b_of_f_right = b_of_f - f, b_of_f_left = b_of_f - b_of_f_right,
      b_of_f_left_rest = f - b_of_f_left, b_of_f_right_rest = f_lo - b_of_f_right,
      b_of_f_lo = b_of_f_left_rest + b_of_f_right_rest, b_of_four_k = four_k + four_k_cross2,
      b_of_four_k_right = b_of_four_k - four_k, b_of_four_k_left = b_of_four_k - b_of_four_k_right,
      b_of_four_k_left_rest = four_k - b_of_four_k_left,
      b_of_four_k_right_rest = four_k_cross2 - b_of_four_k_right,
      b_of_four_k_lo = b_of_four_k_left_rest + b_of_four_k_right_rest, b = b_of_f / b_of_four_k,
      b_product = KSL_MUL(b, b_of_four_k),
      b_product_error = ksl_product_error(b, b_of_four_k, b_product), b_rest = b_of_f - b_product,
      b_exact = b_rest - b_product_error, b_numerator = b_exact + b_of_f_lo,
      b_cross = KSL_MUL(b, b_of_four_k_lo), b_residual = b_numerator - b_cross,
      b_lo = b_residual / b_of_four_k;
  const double b_across_of_c = c + c_lo, b_across_of_c_right = b_across_of_c - c,
      b_across_of_c_left = b_across_of_c - b_across_of_c_right,
      b_across_of_c_left_rest = c - b_across_of_c_left,
      b_across_of_c_right_rest = c_lo - b_across_of_c_right,
      b_across_of_c_lo = b_across_of_c_left_rest + b_across_of_c_right_rest,
      b_across_of_sinc = sinc + sinc_lo, b_across_of_sinc_right = b_across_of_sinc - sinc,
      b_across_of_sinc_left = b_across_of_sinc - b_across_of_sinc_right,
      b_across_of_sinc_left_rest = sinc - b_across_of_sinc_left,
      b_across_of_sinc_right_rest = sinc_lo - b_across_of_sinc_right,
      b_across_of_sinc_lo = b_across_of_sinc_left_rest + b_across_of_sinc_right_rest,
      b_across = b_across_of_c / b_across_of_sinc,
      b_across_product = KSL_MUL(b_across, b_across_of_sinc),
      b_across_product_error = ksl_product_error(b_across, b_across_of_sinc, b_across_product),
      b_across_rest = b_across_of_c - b_across_product,
      b_across_exact = b_across_rest - b_across_product_error,
      b_across_numerator = b_across_exact + b_across_of_c_lo,
      b_across_cross = KSL_MUL(b_across, b_across_of_sinc_lo),
      b_across_residual = b_across_numerator - b_across_cross,
      b_across_lo = b_across_residual / b_across_of_sinc;
  const double beta_v_0 = KSL_MUL(v->x, b), beta_v_0_cross2 = KSL_MUL(v->x, b_lo);
  const double beta_v_1 = KSL_MUL(v->y, b), beta_v_1_cross2 = KSL_MUL(v->y, b_lo);
  const double beta_v_2 = KSL_MUL(v->z, b), beta_v_2_cross2 = KSL_MUL(v->z, b_lo);
  const double beta_v_0_error = ksl_product_error(v->x, b, beta_v_0),
      beta_v_0_lo = beta_v_0_error + beta_v_0_cross2, m_0 = KSL_MUL(v->x, beta_v_0),
      m_0_cross2 = KSL_MUL(v->x, beta_v_0_lo);
  const double beta_v_1_error = ksl_product_error(v->y, b, beta_v_1),
      beta_v_1_lo = beta_v_1_error + beta_v_1_cross2, m_1 = KSL_MUL(v->y, beta_v_1),
      m_1_cross2 = KSL_MUL(v->y, beta_v_1_lo);
  const double beta_v_2_error = ksl_product_error(v->z, b, beta_v_2),
      beta_v_2_lo = beta_v_2_error + beta_v_2_cross2, m_2 = KSL_MUL(v->z, beta_v_2),
      m_2_cross2 = KSL_MUL(v->z, beta_v_2_lo);
  const double m_3 = KSL_MUL(v->y, beta_v_0), m_3_cross2 = KSL_MUL(v->y, beta_v_0_lo);
  const double m_4 = KSL_MUL(v->z, beta_v_0), m_4_cross2 = KSL_MUL(v->z, beta_v_0_lo);
  const double m_5 = KSL_MUL(v->z, beta_v_1), m_5_cross2 = KSL_MUL(v->z, beta_v_1_lo);
  const double others_0 = m_1 + m_2, others_0_right = others_0 - m_1,
      others_0_left = others_0 - others_0_right,
      others_0_left_rest = ksl_product_rest(v->y, beta_v_1, m_1, others_0_left),
      others_0_right_rest = ksl_product_rest(v->z, beta_v_2, m_2, others_0_right),
      others_0_cross = m_1_cross2 + m_2_cross2,
      others_0_lo1 = others_0_left_rest + others_0_right_rest,
      others_0_lo = others_0_lo1 + others_0_cross;
  const double others_1 = m_0 + m_2, others_1_right = others_1 - m_0,
      others_1_left = others_1 - others_1_right,
      others_1_left_rest = ksl_product_rest(v->x, beta_v_0, m_0, others_1_left),
      others_1_right_rest = ksl_product_rest(v->z, beta_v_2, m_2, others_1_right),
      others_1_cross = m_0_cross2 + m_2_cross2,
      others_1_lo1 = others_1_left_rest + others_1_right_rest,
      others_1_lo = others_1_lo1 + others_1_cross;
  const double others_2 = m_0 + m_1, others_2_right = others_2 - m_0,
      others_2_left = others_2 - others_2_right,
      others_2_left_rest = ksl_product_rest(v->x, beta_v_0, m_0, others_2_left),
      others_2_right_rest = ksl_product_rest(v->y, beta_v_1, m_1, others_2_right),
      others_2_cross = m_0_cross2 + m_1_cross2,
      others_2_lo1 = others_2_left_rest + others_2_right_rest,
      others_2_lo = others_2_lo1 + others_2_cross;
  const double diagonal0a = 1.0 - others_0, diagonal0a_right = 1.0 - diagonal0a,
      diagonal0a_left = diagonal0a + diagonal0a_right, diagonal0a_left_rest = 1.0 - diagonal0a_left,
      diagonal0a_right_rest = others_0 - diagonal0a_right,
      diagonal0a_lo1 = diagonal0a_left_rest - diagonal0a_right_rest,
      diagonal0a_lo = diagonal0a_lo1 - others_0_lo, diagonal0b = b_across + m_0,
      diagonal0b_right = diagonal0b - b_across, diagonal0b_left = diagonal0b - diagonal0b_right,
      diagonal0b_left_rest = b_across - diagonal0b_left,
      diagonal0b_right_rest = ksl_product_rest(v->x, beta_v_0, m_0, diagonal0b_right),
      diagonal0b_lo1 = diagonal0b_left_rest + diagonal0b_right_rest,
      diagonal0b_lo2 = diagonal0b_lo1 + m_0_cross2, diagonal0b_lo = diagonal0b_lo2 + b_across_lo,
      m_0_error = ksl_product_error(v->x, beta_v_0, m_0), m_0_lo = m_0_error + m_0_cross2,
      diagonal0c_of_m_0 = m_0 + m_0_lo, diagonal0c_of_others_0 = others_0 + others_0_lo,
      diagonal0 = diagonal0c_of_m_0 < diagonal0c_of_others_0 ? diagonal0b : diagonal0a,
      diagonal0_lo = diagonal0c_of_m_0 < diagonal0c_of_others_0 ? diagonal0b_lo : diagonal0a_lo;
  const double diagonal1a = 1.0 - others_1, diagonal1a_right = 1.0 - diagonal1a,
      diagonal1a_left = diagonal1a + diagonal1a_right, diagonal1a_left_rest = 1.0 - diagonal1a_left,
      diagonal1a_right_rest = others_1 - diagonal1a_right,
      diagonal1a_lo1 = diagonal1a_left_rest - diagonal1a_right_rest,
      diagonal1a_lo = diagonal1a_lo1 - others_1_lo, diagonal1b = b_across + m_1,
      diagonal1b_right = diagonal1b - b_across, diagonal1b_left = diagonal1b - diagonal1b_right,
      diagonal1b_left_rest = b_across - diagonal1b_left,
      diagonal1b_right_rest = ksl_product_rest(v->y, beta_v_1, m_1, diagonal1b_right),
      diagonal1b_lo1 = diagonal1b_left_rest + diagonal1b_right_rest,
      diagonal1b_lo2 = diagonal1b_lo1 + m_1_cross2, diagonal1b_lo = diagonal1b_lo2 + b_across_lo,
      m_1_error = ksl_product_error(v->y, beta_v_1, m_1), m_1_lo = m_1_error + m_1_cross2,
      diagonal1c_of_m_1 = m_1 + m_1_lo, diagonal1c_of_others_1 = others_1 + others_1_lo,
      diagonal1 = diagonal1c_of_m_1 < diagonal1c_of_others_1 ? diagonal1b : diagonal1a,
      diagonal1_lo = diagonal1c_of_m_1 < diagonal1c_of_others_1 ? diagonal1b_lo : diagonal1a_lo;
  const double diagonal2a = 1.0 - others_2, diagonal2a_right = 1.0 - diagonal2a,
      diagonal2a_left = diagonal2a + diagonal2a_right, diagonal2a_left_rest = 1.0 - diagonal2a_left,
      diagonal2a_right_rest = others_2 - diagonal2a_right,
      diagonal2a_lo1 = diagonal2a_left_rest - diagonal2a_right_rest,
      diagonal2a_lo = diagonal2a_lo1 - others_2_lo, diagonal2b = b_across + m_2,
      diagonal2b_right = diagonal2b - b_across, diagonal2b_left = diagonal2b - diagonal2b_right,
      diagonal2b_left_rest = b_across - diagonal2b_left,
      diagonal2b_right_rest = ksl_product_rest(v->z, beta_v_2, m_2, diagonal2b_right),
      diagonal2b_lo1 = diagonal2b_left_rest + diagonal2b_right_rest,
      diagonal2b_lo2 = diagonal2b_lo1 + m_2_cross2, diagonal2b_lo = diagonal2b_lo2 + b_across_lo,
      m_2_error = ksl_product_error(v->z, beta_v_2, m_2), m_2_lo = m_2_error + m_2_cross2,
      diagonal2c_of_m_2 = m_2 + m_2_lo, diagonal2c_of_others_2 = others_2 + others_2_lo,
      diagonal2 = diagonal2c_of_m_2 < diagonal2c_of_others_2 ? diagonal2b : diagonal2a,
      diagonal2_lo = diagonal2c_of_m_2 < diagonal2c_of_others_2 ? diagonal2b_lo : diagonal2a_lo;
  const double alpha_v_0 = -halved_0;
  const double alpha_v_1 = -halved_1;
  const double alpha_v_2 = -halved_2;
  const double R_01 = m_3 - alpha_v_2, R_01_right = m_3 - R_01, R_01_left = R_01 + R_01_right,
      R_01_left_rest = ksl_product_rest(v->y, beta_v_0, m_3, R_01_left),
      R_01_right_rest = alpha_v_2 - R_01_right, R_01_lo1 = R_01_left_rest - R_01_right_rest,
      R_01_lo = R_01_lo1 + m_3_cross2;
  const double R_02 = m_4 + alpha_v_1, R_02_right = R_02 - m_4, R_02_left = R_02 - R_02_right,
      R_02_left_rest = ksl_product_rest(v->z, beta_v_0, m_4, R_02_left),
      R_02_right_rest = alpha_v_1 - R_02_right, R_02_lo1 = R_02_left_rest + R_02_right_rest,
      R_02_lo = R_02_lo1 + m_4_cross2;
  const double R_10 = m_3 + alpha_v_2, R_10_right = R_10 - m_3, R_10_left = R_10 - R_10_right,
      R_10_left_rest = ksl_product_rest(v->y, beta_v_0, m_3, R_10_left),
      R_10_right_rest = alpha_v_2 - R_10_right, R_10_lo1 = R_10_left_rest + R_10_right_rest,
      R_10_lo = R_10_lo1 + m_3_cross2;
  const double R_12 = m_5 - alpha_v_0, R_12_right = m_5 - R_12, R_12_left = R_12 + R_12_right,
      R_12_left_rest = ksl_product_rest(v->z, beta_v_1, m_5, R_12_left),
      R_12_right_rest = alpha_v_0 - R_12_right, R_12_lo1 = R_12_left_rest - R_12_right_rest,
      R_12_lo = R_12_lo1 + m_5_cross2;
  const double R_20 = m_4 - alpha_v_1, R_20_right = m_4 - R_20, R_20_left = R_20 + R_20_right,
      R_20_left_rest = ksl_product_rest(v->z, beta_v_0, m_4, R_20_left),
      R_20_right_rest = alpha_v_1 - R_20_right, R_20_lo1 = R_20_left_rest - R_20_right_rest,
      R_20_lo = R_20_lo1 + m_4_cross2;
  const double R_21 = m_5 + alpha_v_0, R_21_right = R_21 - m_5, R_21_left = R_21 - R_21_right,
      R_21_left_rest = ksl_product_rest(v->z, beta_v_1, m_5, R_21_left),
      R_21_right_rest = alpha_v_0 - R_21_right, R_21_lo1 = R_21_left_rest + R_21_right_rest,
      R_21_lo = R_21_lo1 + m_5_cross2;
  const double diagonal0_rounded = diagonal0 + diagonal0_lo,
      diagonal0_final = diagonal0_rounded == diagonal0_rounded ? diagonal0_rounded : diagonal0;
  const double R_01_rounded = R_01 + R_01_lo,
      R_01_final = R_01_rounded == R_01_rounded ? R_01_rounded : R_01;
  const double R_02_rounded = R_02 + R_02_lo,
      R_02_final = R_02_rounded == R_02_rounded ? R_02_rounded : R_02;
  const double R_10_rounded = R_10 + R_10_lo,
      R_10_final = R_10_rounded == R_10_rounded ? R_10_rounded : R_10;
  const double diagonal1_rounded = diagonal1 + diagonal1_lo,
      diagonal1_final = diagonal1_rounded == diagonal1_rounded ? diagonal1_rounded : diagonal1;
  const double R_12_rounded = R_12 + R_12_lo,
      R_12_final = R_12_rounded == R_12_rounded ? R_12_rounded : R_12;
  const double R_20_rounded = R_20 + R_20_lo,
      R_20_final = R_20_rounded == R_20_rounded ? R_20_rounded : R_20;
  const double R_21_rounded = R_21 + R_21_lo,
      R_21_final = R_21_rounded == R_21_rounded ? R_21_rounded : R_21;
  const double diagonal2_rounded = diagonal2 + diagonal2_lo,
      diagonal2_final = diagonal2_rounded == diagonal2_rounded ? diagonal2_rounded : diagonal2;
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
  const double halved_0 = KSL_MUL(0.5, v->x);
  const double halved_1 = KSL_MUL(0.5, v->y);
  const double halved_2 = KSL_MUL(0.5, v->z);
  const double y_a = KSL_MUL(halved_0, halved_0), y_b = KSL_MUL(halved_1, halved_1),
      y_c = y_a + y_b, y_c_right = y_c - y_a, y_c_left = y_c - y_c_right,
      y_c_left_rest = ksl_product_rest(halved_0, halved_0, y_a, y_c_left),
      y_c_right_rest = ksl_product_rest(halved_1, halved_1, y_b, y_c_right),
      y_c_lo = y_c_left_rest + y_c_right_rest, y_d = KSL_MUL(halved_2, halved_2), y = y_c + y_d,
      y_right = y - y_c, y_left = y - y_right, y_left_rest = y_c - y_left,
      y_right_rest = ksl_product_rest(halved_2, halved_2, y_d, y_right),
      y_lo1 = y_left_rest + y_right_rest, y_lo = y_lo1 + y_c_lo;
  const double half_angle_of_y = y + y_lo, half_angle_of_y_right = half_angle_of_y - y,
      half_angle_of_y_left = half_angle_of_y - half_angle_of_y_right,
      half_angle_of_y_left_rest = y - half_angle_of_y_left,
      half_angle_of_y_right_rest = y_lo - half_angle_of_y_right,
      half_angle_of_y_lo = half_angle_of_y_left_rest + half_angle_of_y_right_rest,
      half_angle = sqrt(half_angle_of_y), half_angle_product = KSL_MUL(half_angle, half_angle),
      half_angle_product_error = ksl_product_error(half_angle, half_angle, half_angle_product),
      half_angle_rest = half_angle_of_y - half_angle_product,
      half_angle_exact = half_angle_rest - half_angle_product_error,
      half_angle_residual = half_angle_exact + half_angle_of_y_lo,
      half_angle_twice = half_angle + half_angle,
      half_angle_divisor = half_angle == 0.0 ? 1.0 : half_angle_twice,
      half_angle_lo = half_angle_residual / half_angle_divisor;
  const double sine_of_half_angle = half_angle + half_angle_lo,
      sine_of_half_angle_right = sine_of_half_angle - half_angle,
      sine_of_half_angle_left = sine_of_half_angle - sine_of_half_angle_right,
      sine_of_half_angle_left_rest = half_angle - sine_of_half_angle_left,
      sine_of_half_angle_right_rest = half_angle_lo - sine_of_half_angle_right,
      sine_of_half_angle_lo = sine_of_half_angle_left_rest + sine_of_half_angle_right_rest;
  double c; const double sine = ksl_sincos(sine_of_half_angle, &c);
  double c_own_error; const double sine_own_error = ksl_sincos_error(sine_of_half_angle, sine, c,
      &c_own_error);
  const double sine_half = KSL_MUL(sine_of_half_angle_lo, 0.5);
  double sine_half_cos; const double sine_half_sin = ksl_sincos(sine_half, &sine_half_cos);
  const double sine_twice = sine_half_sin + sine_half_sin, sine_slope1 = KSL_MUL(sine_half_cos, c),
      sine_slope2 = KSL_MUL(sine_half_sin, sine), sine_slope = sine_slope1 - sine_slope2,
      sine_more = KSL_MUL(sine_slope, sine_twice), sine_lo = sine_own_error + sine_more;
  const double c_slope1 = KSL_MUL(sine_half_cos, sine), c_slope2 = KSL_MUL(sine_half_sin, c),
      c_slope = c_slope1 + c_slope2, c_more = KSL_MUL(c_slope, sine_twice),
      c_lo = c_own_error - c_more;
  const double sinc_divisor = sine_of_half_angle < 1.4901161193847656e-08 ? 1.4901161193847656e-08 :
      sine_of_half_angle,
      sinc_divisor_lo = sine_of_half_angle < 1.4901161193847656e-08 ? 0.0 : sine_of_half_angle_lo;
  const double sinc_quotient_of_sine = sine + sine_lo,
      sinc_quotient_of_sine_right = sinc_quotient_of_sine - sine,
      sinc_quotient_of_sine_left = sinc_quotient_of_sine - sinc_quotient_of_sine_right,
      sinc_quotient_of_sine_left_rest = sine - sinc_quotient_of_sine_left,
      sinc_quotient_of_sine_right_rest = sine_lo - sinc_quotient_of_sine_right,
      sinc_quotient_of_sine_lo = sinc_quotient_of_sine_left_rest + sinc_quotient_of_sine_right_rest,
      sinc_quotient_of_sinc_divisor = sinc_divisor + sinc_divisor_lo,
      sinc_quotient_of_sinc_divisor_right = sinc_quotient_of_sinc_divisor - sinc_divisor,
      sinc_quotient_of_sinc_divisor_left = sinc_quotient_of_sinc_divisor -
          sinc_quotient_of_sinc_divisor_right,
      sinc_quotient_of_sinc_divisor_left_rest = sinc_divisor - sinc_quotient_of_sinc_divisor_left,
      sinc_quotient_of_sinc_divisor_right_rest = sinc_divisor_lo -
          sinc_quotient_of_sinc_divisor_right,
      sinc_quotient_of_sinc_divisor_lo = sinc_quotient_of_sinc_divisor_left_rest +
          sinc_quotient_of_sinc_divisor_right_rest,
      sinc_quotient = sinc_quotient_of_sine / sinc_quotient_of_sinc_divisor,
      sinc_quotient_product = KSL_MUL(sinc_quotient, sinc_quotient_of_sinc_divisor),
      sinc_quotient_product_error = ksl_product_error(sinc_quotient, sinc_quotient_of_sinc_divisor,
          sinc_quotient_product),
      sinc_quotient_rest = sinc_quotient_of_sine - sinc_quotient_product,
      sinc_quotient_exact = sinc_quotient_rest - sinc_quotient_product_error,
      sinc_quotient_numerator = sinc_quotient_exact + sinc_quotient_of_sine_lo,
      sinc_quotient_cross = KSL_MUL(sinc_quotient, sinc_quotient_of_sinc_divisor_lo),
      sinc_quotient_residual = sinc_quotient_numerator - sinc_quotient_cross,
      sinc_quotient_lo = sinc_quotient_residual / sinc_quotient_of_sinc_divisor;
  const double sinc_a = KSL_MUL(0.16666666666666666, half_angle_of_y),
      sinc_a_cross1 = KSL_MUL(9.25185853854297e-18, half_angle_of_y),
      sinc_a_cross2 = KSL_MUL(0.16666666666666666, half_angle_of_y_lo),
      sinc_a_cross = sinc_a_cross1 + sinc_a_cross2, sinc_b = 1.0 - sinc_a,
      sinc_b_right = 1.0 - sinc_b, sinc_b_left = sinc_b + sinc_b_right,
      sinc_b_left_rest = 1.0 - sinc_b_left,
      sinc_b_right_rest = ksl_product_rest(0.16666666666666666, half_angle_of_y, sinc_a,
          sinc_b_right),
      sinc_b_lo1 = sinc_b_left_rest - sinc_b_right_rest, sinc_b_lo = sinc_b_lo1 - sinc_a_cross,
      sinc = sine_of_half_angle < 1.4901161193847656e-08 ? sinc_b : sinc_quotient,
      sinc_lo = sine_of_half_angle < 1.4901161193847656e-08 ? sinc_b_lo : sinc_quotient_lo;
  const double series_phi_a = KSL_MUL(5.107725174524775e-32, half_angle_of_y),
      series_phi_a_cross1 = KSL_MUL(4.7410392187559056e-48, half_angle_of_y),
      series_phi_a_cross2 = KSL_MUL(5.107725174524775e-32, half_angle_of_y_lo),
      series_phi_a_cross = series_phi_a_cross1 + series_phi_a_cross2,
      series_phi_b = 4.116826490666969e-29 - series_phi_a,
      series_phi_b_right = 4.116826490666969e-29 - series_phi_b,
      series_phi_b_left = series_phi_b + series_phi_b_right,
      series_phi_b_left_rest = 4.116826490666969e-29 - series_phi_b_left,
      series_phi_b_right_rest = ksl_product_rest(5.107725174524775e-32, half_angle_of_y,
          series_phi_a, series_phi_b_right),
      series_phi_b_lo1 = series_phi_b_left_rest - series_phi_b_right_rest,
      series_phi_b_lo2 = series_phi_b_lo1 - series_phi_a_cross,
      series_phi_b_lo = series_phi_b_lo2 + -1.8714974010023092e-45,
      series_phi_c = KSL_MUL(half_angle_of_y, series_phi_b),
      series_phi_c_cross1 = KSL_MUL(half_angle_of_y_lo, series_phi_b),
      series_phi_c_cross2 = KSL_MUL(half_angle_of_y, series_phi_b_lo),
      series_phi_c_cross = series_phi_c_cross1 + series_phi_c_cross2,
      series_phi_d = series_phi_c - 2.86531123750421e-26,
      series_phi_d_right = series_phi_c - series_phi_d,
      series_phi_d_left = series_phi_d + series_phi_d_right,
      series_phi_d_left_rest = ksl_product_rest(half_angle_of_y, series_phi_b, series_phi_c,
          series_phi_d_left),
      series_phi_d_right_rest = 2.86531123750421e-26 - series_phi_d_right,
      series_phi_d_lo1 = series_phi_d_left_rest - series_phi_d_right_rest,
      series_phi_d_lo2 = series_phi_d_lo1 - 2.3296034284323186e-42,
      series_phi_d_lo = series_phi_d_lo2 + series_phi_c_cross,
      series_phi_e = KSL_MUL(half_angle_of_y, series_phi_d),
      series_phi_e_cross1 = KSL_MUL(half_angle_of_y_lo, series_phi_d),
      series_phi_e_cross2 = KSL_MUL(half_angle_of_y, series_phi_d_lo),
      series_phi_e_cross = series_phi_e_cross1 + series_phi_e_cross2,
      series_phi_f = series_phi_e + 1.701994875077501e-23,
      series_phi_f_right = series_phi_f - series_phi_e,
      series_phi_f_left = series_phi_f - series_phi_f_right,
      series_phi_f_left_rest = ksl_product_rest(half_angle_of_y, series_phi_d, series_phi_e,
          series_phi_f_left),
      series_phi_f_right_rest = 1.701994875077501e-23 - series_phi_f_right,
      series_phi_f_lo1 = series_phi_f_left_rest + series_phi_f_right_rest,
      series_phi_f_lo2 = series_phi_f_lo1 + 3.161967936521494e-40,
      series_phi_f_lo = series_phi_f_lo2 + series_phi_e_cross,
      series_phi_g = KSL_MUL(half_angle_of_y, series_phi_f),
      series_phi_g_cross1 = KSL_MUL(half_angle_of_y_lo, series_phi_f),
      series_phi_g_cross2 = KSL_MUL(half_angle_of_y, series_phi_f_lo),
      series_phi_g_cross = series_phi_g_cross1 + series_phi_g_cross2,
      series_phi_h = series_phi_g - 8.509974375387505e-21,
      series_phi_h_right = series_phi_g - series_phi_h,
      series_phi_h_left = series_phi_h + series_phi_h_right,
      series_phi_h_left_rest = ksl_product_rest(half_angle_of_y, series_phi_f, series_phi_g,
          series_phi_h_left),
      series_phi_h_right_rest = 8.509974375387505e-21 - series_phi_h_right,
      series_phi_h_lo1 = series_phi_h_left_rest - series_phi_h_right_rest,
      series_phi_h_lo2 = series_phi_h_lo1 - 3.2266760594119493e-37,
      series_phi_h_lo = series_phi_h_lo2 + series_phi_g_cross,
      series_phi_i = KSL_MUL(half_angle_of_y, series_phi_h),
      series_phi_i_cross1 = KSL_MUL(half_angle_of_y_lo, series_phi_h),
      series_phi_i_cross2 = KSL_MUL(half_angle_of_y, series_phi_h_lo),
      series_phi_i_cross = series_phi_i_cross1 + series_phi_i_cross2,
      series_phi_j = series_phi_i + 3.523129391410427e-18,
      series_phi_j_right = series_phi_j - series_phi_i,
      series_phi_j_left = series_phi_j - series_phi_j_right,
      series_phi_j_left_rest = ksl_product_rest(half_angle_of_y, series_phi_h, series_phi_i,
          series_phi_j_left),
      series_phi_j_right_rest = 3.523129391410427e-18 - series_phi_j_right,
      series_phi_j_lo1 = series_phi_j_left_rest + series_phi_j_right_rest,
      series_phi_j_lo2 = series_phi_j_lo1 + -1.2521244741738012e-34,
      series_phi_j_lo = series_phi_j_lo2 + series_phi_i_cross,
      series_phi_k = KSL_MUL(half_angle_of_y, series_phi_j),
      series_phi_k_cross1 = KSL_MUL(half_angle_of_y_lo, series_phi_j),
      series_phi_k_cross2 = KSL_MUL(half_angle_of_y, series_phi_j_lo),
      series_phi_k_cross = series_phi_k_cross1 + series_phi_k_cross2,
      series_phi_l = series_phi_k - 1.1837714755139035e-15,
      series_phi_l_right = series_phi_k - series_phi_l,
      series_phi_l_left = series_phi_l + series_phi_l_right,
      series_phi_l_left_rest = ksl_product_rest(half_angle_of_y, series_phi_j, series_phi_k,
          series_phi_l_left),
      series_phi_l_right_rest = 1.1837714755139035e-15 - series_phi_l_right,
      series_phi_l_lo1 = series_phi_l_left_rest - series_phi_l_right_rest,
      series_phi_l_lo2 = series_phi_l_lo1 - 7.23242424407352e-33,
      series_phi_l_lo = series_phi_l_lo2 + series_phi_k_cross,
      series_phi_m = KSL_MUL(half_angle_of_y, series_phi_l),
      series_phi_m_cross1 = KSL_MUL(half_angle_of_y_lo, series_phi_l),
      series_phi_m_cross2 = KSL_MUL(half_angle_of_y, series_phi_l_lo),
      series_phi_m_cross = series_phi_m_cross1 + series_phi_m_cross2,
      series_phi_n = series_phi_m + 3.148832124866983e-13,
      series_phi_n_right = series_phi_n - series_phi_m,
      series_phi_n_left = series_phi_n - series_phi_n_right,
      series_phi_n_left_rest = ksl_product_rest(half_angle_of_y, series_phi_l, series_phi_m,
          series_phi_n_left),
      series_phi_n_right_rest = 3.148832124866983e-13 - series_phi_n_right,
      series_phi_n_lo1 = series_phi_n_left_rest + series_phi_n_right_rest,
      series_phi_n_lo2 = series_phi_n_lo1 + 5.8681293750286156e-30,
      series_phi_n_lo = series_phi_n_lo2 + series_phi_m_cross,
      series_phi_o = KSL_MUL(half_angle_of_y, series_phi_n),
      series_phi_o_cross1 = KSL_MUL(half_angle_of_y_lo, series_phi_n),
      series_phi_o_cross2 = KSL_MUL(half_angle_of_y, series_phi_n_lo),
      series_phi_o_cross = series_phi_o_cross1 + series_phi_o_cross2,
      series_phi_p = series_phi_o - 6.423617534728645e-11,
      series_phi_p_right = series_phi_o - series_phi_p,
      series_phi_p_left = series_phi_p + series_phi_p_right,
      series_phi_p_left_rest = ksl_product_rest(half_angle_of_y, series_phi_n, series_phi_o,
          series_phi_p_left),
      series_phi_p_right_rest = 6.423617534728645e-11 - series_phi_p_right,
      series_phi_p_lo1 = series_phi_p_left_rest - series_phi_p_right_rest,
      series_phi_p_lo2 = series_phi_p_lo1 - 5.034117835500839e-27,
      series_phi_p_lo = series_phi_p_lo2 + series_phi_o_cross,
      series_phi_q = KSL_MUL(half_angle_of_y, series_phi_p),
      series_phi_q_cross1 = KSL_MUL(half_angle_of_y_lo, series_phi_p),
      series_phi_q_cross2 = KSL_MUL(half_angle_of_y, series_phi_p_lo),
      series_phi_q_cross = series_phi_q_cross1 + series_phi_q_cross2,
      series_phi_r = series_phi_q + 9.635426302092969e-09,
      series_phi_r_right = series_phi_r - series_phi_q,
      series_phi_r_left = series_phi_r - series_phi_r_right,
      series_phi_r_left_rest = ksl_product_rest(half_angle_of_y, series_phi_p, series_phi_q,
          series_phi_r_left),
      series_phi_r_right_rest = 9.635426302092969e-09 - series_phi_r_right,
      series_phi_r_lo1 = series_phi_r_left_rest + series_phi_r_right_rest,
      series_phi_r_lo2 = series_phi_r_lo1 + -1.7546051379703029e-25,
      series_phi_r_lo = series_phi_r_lo2 + series_phi_q_cross,
      series_phi_s = KSL_MUL(half_angle_of_y, series_phi_r),
      series_phi_s_cross1 = KSL_MUL(half_angle_of_y_lo, series_phi_r),
      series_phi_s_cross2 = KSL_MUL(half_angle_of_y, series_phi_r_lo),
      series_phi_s_cross = series_phi_s_cross1 + series_phi_s_cross2,
      series_phi_t = series_phi_s - 1.0020843354176687e-06,
      series_phi_t_right = series_phi_s - series_phi_t,
      series_phi_t_left = series_phi_t + series_phi_t_right,
      series_phi_t_left_rest = ksl_product_rest(half_angle_of_y, series_phi_r, series_phi_s,
          series_phi_t_left),
      series_phi_t_right_rest = 1.0020843354176687e-06 - series_phi_t_right,
      series_phi_t_lo1 = series_phi_t_left_rest - series_phi_t_right_rest,
      series_phi_t_lo2 = series_phi_t_lo1 - 4.7926555569351065e-23,
      series_phi_t_lo = series_phi_t_lo2 + series_phi_s_cross,
      series_phi_u = KSL_MUL(half_angle_of_y, series_phi_t),
      series_phi_u_cross1 = KSL_MUL(half_angle_of_y_lo, series_phi_t),
      series_phi_u_cross2 = KSL_MUL(half_angle_of_y, series_phi_t_lo),
      series_phi_u_cross = series_phi_u_cross1 + series_phi_u_cross2,
      series_phi_v = series_phi_u + 6.613756613756614e-05,
      series_phi_v_right = series_phi_v - series_phi_u,
      series_phi_v_left = series_phi_v - series_phi_v_right,
      series_phi_v_left_rest = ksl_product_rest(half_angle_of_y, series_phi_t, series_phi_u,
          series_phi_v_left),
      series_phi_v_right_rest = 6.613756613756614e-05 - series_phi_v_right,
      series_phi_v_lo1 = series_phi_v_left_rest + series_phi_v_right_rest,
      series_phi_v_lo2 = series_phi_v_lo1 + -4.460143857711533e-21,
      series_phi_v_lo = series_phi_v_lo2 + series_phi_u_cross,
      series_phi_w = KSL_MUL(half_angle_of_y, series_phi_v),
      series_phi_w_cross1 = KSL_MUL(half_angle_of_y_lo, series_phi_v),
      series_phi_w_cross2 = KSL_MUL(half_angle_of_y, series_phi_v_lo),
      series_phi_w_cross = series_phi_w_cross1 + series_phi_w_cross2,
      series_phi_x = series_phi_w - 0.002380952380952381,
      series_phi_x_right = series_phi_w - series_phi_x,
      series_phi_x_left = series_phi_x + series_phi_x_right,
      series_phi_x_left_rest = ksl_product_rest(half_angle_of_y, series_phi_v, series_phi_w,
          series_phi_x_left),
      series_phi_x_right_rest = 0.002380952380952381 - series_phi_x_right,
      series_phi_x_lo1 = series_phi_x_left_rest - series_phi_x_right_rest,
      series_phi_x_lo2 = series_phi_x_lo1 - -2.147752875018904e-19,
      series_phi_x_lo = series_phi_x_lo2 + series_phi_w_cross,
      series_phi_y = KSL_MUL(half_angle_of_y, series_phi_x),
      series_phi_y_cross1 = KSL_MUL(half_angle_of_y_lo, series_phi_x),
      series_phi_y_cross2 = KSL_MUL(half_angle_of_y, series_phi_x_lo),
      series_phi_y_cross = series_phi_y_cross1 + series_phi_y_cross2,
      series_phi = series_phi_y + 0.03333333333333333, series_phi_right = series_phi - series_phi_y,
      series_phi_left = series_phi - series_phi_right,
      series_phi_left_rest = ksl_product_rest(half_angle_of_y, series_phi_x, series_phi_y,
          series_phi_left),
      series_phi_right_rest = 0.03333333333333333 - series_phi_right,
      series_phi_lo1 = series_phi_left_rest + series_phi_right_rest,
      series_phi_lo2 = series_phi_lo1 + 4.625929269271486e-19,
      series_phi_lo = series_phi_lo2 + series_phi_y_cross;
  const double f_more_a = KSL_MUL(2.0, half_angle_of_y),
      f_more_a_cross2 = KSL_MUL(2.0, half_angle_of_y_lo), f_more = KSL_MUL(f_more_a, series_phi),
      f_more_cross1 = KSL_MUL(f_more_a_cross2, series_phi),
      f_more_cross2 = KSL_MUL(f_more_a, series_phi_lo),
      f_more_cross = f_more_cross1 + f_more_cross2;
  const double near_f_a = KSL_MUL(0.3333333333333333, sinc),
      near_f_a_cross1 = KSL_MUL(1.850371707708594e-17, sinc),
      near_f_a_cross2 = KSL_MUL(0.3333333333333333, sinc_lo),
      near_f_a_cross = near_f_a_cross1 + near_f_a_cross2,
      f_more_error = ksl_product_error(f_more_a, series_phi, f_more),
      f_more_lo = f_more_error + f_more_cross, near_f_b = KSL_MUL(0.3333333333333333, f_more),
      near_f_b_cross1 = KSL_MUL(1.850371707708594e-17, f_more),
      near_f_b_cross2 = KSL_MUL(0.3333333333333333, f_more_lo),
      near_f_b_cross = near_f_b_cross1 + near_f_b_cross2, near_f = near_f_a + near_f_b,
      near_f_right = near_f - near_f_a, near_f_left = near_f - near_f_right,
      near_f_left_rest = ksl_product_rest(0.3333333333333333, sinc, near_f_a, near_f_left),
      near_f_right_rest = ksl_product_rest(0.3333333333333333, f_more, near_f_b, near_f_right),
      near_f_cross = near_f_a_cross + near_f_b_cross,
      near_f_lo1 = near_f_left_rest + near_f_right_rest, near_f_lo = near_f_lo1 + near_f_cross;
  const double f_rest = sinc - c, f_rest_right = sinc - f_rest, f_rest_left = f_rest + f_rest_right,
      f_rest_left_rest = sinc - f_rest_left, f_rest_right_rest = c - f_rest_right,
      f_rest_lo1 = f_rest_left_rest - f_rest_right_rest, f_rest_lo2 = f_rest_lo1 - c_lo,
      f_rest_lo = f_rest_lo2 + sinc_lo;
  const double x = KSL_MUL(4.0, half_angle_of_y), x_cross2 = KSL_MUL(4.0, half_angle_of_y_lo);
  const double far_y_a_of_x = x + x_cross2, far_y = far_y_a_of_x < 4.0 ? 1.0 : half_angle_of_y,
      far_y_lo = far_y_a_of_x < 4.0 ? 0.0 : half_angle_of_y_lo;
  const double closed_f_of_f_rest = f_rest + f_rest_lo,
      closed_f_of_f_rest_right = closed_f_of_f_rest - f_rest,
      closed_f_of_f_rest_left = closed_f_of_f_rest - closed_f_of_f_rest_right,
      closed_f_of_f_rest_left_rest = f_rest - closed_f_of_f_rest_left,
      closed_f_of_f_rest_right_rest = f_rest_lo - closed_f_of_f_rest_right,
      closed_f_of_f_rest_lo = closed_f_of_f_rest_left_rest + closed_f_of_f_rest_right_rest,
      closed_f_of_far_y = far_y + far_y_lo, closed_f_of_far_y_right = closed_f_of_far_y - far_y,
      closed_f_of_far_y_left = closed_f_of_far_y - closed_f_of_far_y_right,
      closed_f_of_far_y_left_rest = far_y - closed_f_of_far_y_left,
      closed_f_of_far_y_right_rest = far_y_lo - closed_f_of_far_y_right,
      closed_f_of_far_y_lo = closed_f_of_far_y_left_rest + closed_f_of_far_y_right_rest,
      closed_f = closed_f_of_f_rest / closed_f_of_far_y,
      closed_f_product = KSL_MUL(closed_f, closed_f_of_far_y),
      closed_f_product_error = ksl_product_error(closed_f, closed_f_of_far_y, closed_f_product),
      closed_f_rest = closed_f_of_f_rest - closed_f_product,
      closed_f_exact = closed_f_rest - closed_f_product_error,
      closed_f_numerator = closed_f_exact + closed_f_of_f_rest_lo,
      closed_f_cross = KSL_MUL(closed_f, closed_f_of_far_y_lo),
      closed_f_residual = closed_f_numerator - closed_f_cross,
      closed_f_lo = closed_f_residual / closed_f_of_far_y;
  const double f = far_y_a_of_x < 4.0 ? near_f : closed_f,
      f_lo = far_y_a_of_x < 4.0 ? near_f_lo : closed_f_lo;
  const double four_k = KSL_MUL(4.0, sinc), four_k_cross2 = KSL_MUL(4.0, sinc_lo);
  const double b_of_f = f + f_lo, b_of_f_right = b_of_f - f, b_of_f_left = b_of_f - b_of_f_right,
      b_of_f_left_rest = f - b_of_f_left, b_of_f_right_rest = f_lo - b_of_f_right,
      b_of_f_lo = b_of_f_left_rest + b_of_f_right_rest, b_of_four_k = four_k + four_k_cross2,
      b_of_four_k_right = b_of_four_k - four_k, b_of_four_k_left = b_of_four_k - b_of_four_k_right,
      b_of_four_k_left_rest = four_k - b_of_four_k_left,
      b_of_four_k_right_rest = four_k_cross2 - b_of_four_k_right,
      b_of_four_k_lo = b_of_four_k_left_rest + b_of_four_k_right_rest, b = b_of_f / b_of_four_k,
      b_product = KSL_MUL(b, b_of_four_k),
      b_product_error = ksl_product_error(b, b_of_four_k, b_product), b_rest = b_of_f - b_product,
      b_exact = b_rest - b_product_error, b_numerator = b_exact + b_of_f_lo,
      b_cross = KSL_MUL(b, b_of_four_k_lo), b_residual = b_numerator - b_cross,
      b_lo = b_residual / b_of_four_k;
  const double b_across_of_c = c + c_lo, b_across_of_c_right = b_across_of_c - c,
      b_across_of_c_left = b_across_of_c - b_across_of_c_right,
      b_across_of_c_left_rest = c - b_across_of_c_left,
      b_across_of_c_right_rest = c_lo - b_across_of_c_right,
      b_across_of_c_lo = b_across_of_c_left_rest + b_across_of_c_right_rest,
      b_across_of_sinc = sinc + sinc_lo, b_across_of_sinc_right = b_across_of_sinc - sinc,
      b_across_of_sinc_left = b_across_of_sinc - b_across_of_sinc_right,
      b_across_of_sinc_left_rest = sinc - b_across_of_sinc_left,
      b_across_of_sinc_right_rest = sinc_lo - b_across_of_sinc_right,
      b_across_of_sinc_lo = b_across_of_sinc_left_rest + b_across_of_sinc_right_rest,
      b_across = b_across_of_c / b_across_of_sinc,
      b_across_product = KSL_MUL(b_across, b_across_of_sinc),
      b_across_product_error = ksl_product_error(b_across, b_across_of_sinc, b_across_product),
      b_across_rest = b_across_of_c - b_across_product,
      b_across_exact = b_across_rest - b_across_product_error,
      b_across_numerator = b_across_exact + b_across_of_c_lo,
      b_across_cross = KSL_MUL(b_across, b_across_of_sinc_lo),
      b_across_residual = b_across_numerator - b_across_cross,
      b_across_lo = b_across_residual / b_across_of_sinc;
  const double beta_v_0 = KSL_MUL(v->x, b), beta_v_0_cross2 = KSL_MUL(v->x, b_lo);
  const double beta_v_1 = KSL_MUL(v->y, b), beta_v_1_cross2 = KSL_MUL(v->y, b_lo);
  const double beta_v_2 = KSL_MUL(v->z, b), beta_v_2_cross2 = KSL_MUL(v->z, b_lo);
  const double beta_v_0_error = ksl_product_error(v->x, b, beta_v_0),
      beta_v_0_lo = beta_v_0_error + beta_v_0_cross2, m_0 = KSL_MUL(v->x, beta_v_0),
      m_0_cross2 = KSL_MUL(v->x, beta_v_0_lo);
  const double beta_v_1_error = ksl_product_error(v->y, b, beta_v_1),
      beta_v_1_lo = beta_v_1_error + beta_v_1_cross2, m_1 = KSL_MUL(v->y, beta_v_1),
      m_1_cross2 = KSL_MUL(v->y, beta_v_1_lo);
  const double beta_v_2_error = ksl_product_error(v->z, b, beta_v_2),
      beta_v_2_lo = beta_v_2_error + beta_v_2_cross2, m_2 = KSL_MUL(v->z, beta_v_2),
      m_2_cross2 = KSL_MUL(v->z, beta_v_2_lo);
  const double m_3 = KSL_MUL(v->y, beta_v_0), m_3_cross2 = KSL_MUL(v->y, beta_v_0_lo);
  const double m_4 = KSL_MUL(v->z, beta_v_0), m_4_cross2 = KSL_MUL(v->z, beta_v_0_lo);
  const double m_5 = KSL_MUL(v->z, beta_v_1), m_5_cross2 = KSL_MUL(v->z, beta_v_1_lo);
  const double others_0 = m_1 + m_2, others_0_right = others_0 - m_1,
      others_0_left = others_0 - others_0_right,
      others_0_left_rest = ksl_product_rest(v->y, beta_v_1, m_1, others_0_left),
      others_0_right_rest = ksl_product_rest(v->z, beta_v_2, m_2, others_0_right),
      others_0_cross = m_1_cross2 + m_2_cross2,
      others_0_lo1 = others_0_left_rest + others_0_right_rest,
      others_0_lo = others_0_lo1 + others_0_cross;
  const double others_1 = m_0 + m_2, others_1_right = others_1 - m_0,
      others_1_left = others_1 - others_1_right,
      others_1_left_rest = ksl_product_rest(v->x, beta_v_0, m_0, others_1_left),
      others_1_right_rest = ksl_product_rest(v->z, beta_v_2, m_2, others_1_right),
      others_1_cross = m_0_cross2 + m_2_cross2,
      others_1_lo1 = others_1_left_rest + others_1_right_rest,
      others_1_lo = others_1_lo1 + others_1_cross;
  const double others_2 = m_0 + m_1, others_2_right = others_2 - m_0,
      others_2_left = others_2 - others_2_right,
      others_2_left_rest = ksl_product_rest(v->x, beta_v_0, m_0, others_2_left),
      others_2_right_rest = ksl_product_rest(v->y, beta_v_1, m_1, others_2_right),
      others_2_cross = m_0_cross2 + m_1_cross2,
      others_2_lo1 = others_2_left_rest + others_2_right_rest,
      others_2_lo = others_2_lo1 + others_2_cross;
  const double diagonal0a = 1.0 - others_0, diagonal0a_right = 1.0 - diagonal0a,
      diagonal0a_left = diagonal0a + diagonal0a_right, diagonal0a_left_rest = 1.0 - diagonal0a_left,
      diagonal0a_right_rest = others_0 - diagonal0a_right,
      diagonal0a_lo1 = diagonal0a_left_rest - diagonal0a_right_rest,
      diagonal0a_lo = diagonal0a_lo1 - others_0_lo, diagonal0b = b_across + m_0,
      diagonal0b_right = diagonal0b - b_across, diagonal0b_left = diagonal0b - diagonal0b_right,
      diagonal0b_left_rest = b_across - diagonal0b_left,
      diagonal0b_right_rest = ksl_product_rest(v->x, beta_v_0, m_0, diagonal0b_right),
      diagonal0b_lo1 = diagonal0b_left_rest + diagonal0b_right_rest,
      diagonal0b_lo2 = diagonal0b_lo1 + m_0_cross2, diagonal0b_lo = diagonal0b_lo2 + b_across_lo,
      m_0_error = ksl_product_error(v->x, beta_v_0, m_0), m_0_lo = m_0_error + m_0_cross2,
      diagonal0c_of_m_0 = m_0 + m_0_lo, diagonal0c_of_others_0 = others_0 + others_0_lo,
      diagonal0 = diagonal0c_of_m_0 < diagonal0c_of_others_0 ? diagonal0b : diagonal0a,
      diagonal0_lo = diagonal0c_of_m_0 < diagonal0c_of_others_0 ? diagonal0b_lo : diagonal0a_lo;
  const double diagonal1a = 1.0 - others_1, diagonal1a_right = 1.0 - diagonal1a,
      diagonal1a_left = diagonal1a + diagonal1a_right, diagonal1a_left_rest = 1.0 - diagonal1a_left,
      diagonal1a_right_rest = others_1 - diagonal1a_right,
      diagonal1a_lo1 = diagonal1a_left_rest - diagonal1a_right_rest,
      diagonal1a_lo = diagonal1a_lo1 - others_1_lo, diagonal1b = b_across + m_1,
      diagonal1b_right = diagonal1b - b_across, diagonal1b_left = diagonal1b - diagonal1b_right,
      diagonal1b_left_rest = b_across - diagonal1b_left,
      diagonal1b_right_rest = ksl_product_rest(v->y, beta_v_1, m_1, diagonal1b_right),
      diagonal1b_lo1 = diagonal1b_left_rest + diagonal1b_right_rest,
      diagonal1b_lo2 = diagonal1b_lo1 + m_1_cross2, diagonal1b_lo = diagonal1b_lo2 + b_across_lo,
      m_1_error = ksl_product_error(v->y, beta_v_1, m_1), m_1_lo = m_1_error + m_1_cross2,
      diagonal1c_of_m_1 = m_1 + m_1_lo, diagonal1c_of_others_1 = others_1 + others_1_lo,
      diagonal1 = diagonal1c_of_m_1 < diagonal1c_of_others_1 ? diagonal1b : diagonal1a,
      diagonal1_lo = diagonal1c_of_m_1 < diagonal1c_of_others_1 ? diagonal1b_lo : diagonal1a_lo;
  const double diagonal2a = 1.0 - others_2, diagonal2a_right = 1.0 - diagonal2a,
      diagonal2a_left = diagonal2a + diagonal2a_right, diagonal2a_left_rest = 1.0 - diagonal2a_left,
      diagonal2a_right_rest = others_2 - diagonal2a_right,
      diagonal2a_lo1 = diagonal2a_left_rest - diagonal2a_right_rest,
      diagonal2a_lo = diagonal2a_lo1 - others_2_lo, diagonal2b = b_across + m_2,
      diagonal2b_right = diagonal2b - b_across, diagonal2b_left = diagonal2b - diagonal2b_right,
      diagonal2b_left_rest = b_across - diagonal2b_left,
      diagonal2b_right_rest = ksl_product_rest(v->z, beta_v_2, m_2, diagonal2b_right),
      diagonal2b_lo1 = diagonal2b_left_rest + diagonal2b_right_rest,
      diagonal2b_lo2 = diagonal2b_lo1 + m_2_cross2, diagonal2b_lo = diagonal2b_lo2 + b_across_lo,
      m_2_error = ksl_product_error(v->z, beta_v_2, m_2), m_2_lo = m_2_error + m_2_cross2,
      diagonal2c_of_m_2 = m_2 + m_2_lo, diagonal2c_of_others_2 = others_2 + others_2_lo,
      diagonal2 = diagonal2c_of_m_2 < diagonal2c_of_others_2 ? diagonal2b : diagonal2a,
      diagonal2_lo = diagonal2c_of_m_2 < diagonal2c_of_others_2 ? diagonal2b_lo : diagonal2a_lo;
  const double R_01 = m_3 - halved_2, R_01_right = m_3 - R_01, R_01_left = R_01 + R_01_right,
      R_01_left_rest = ksl_product_rest(v->y, beta_v_0, m_3, R_01_left),
      R_01_right_rest = halved_2 - R_01_right, R_01_lo1 = R_01_left_rest - R_01_right_rest,
      R_01_lo = R_01_lo1 + m_3_cross2;
  const double R_02 = halved_1 + m_4, R_02_right = R_02 - halved_1, R_02_left = R_02 - R_02_right,
      R_02_left_rest = halved_1 - R_02_left,
      R_02_right_rest = ksl_product_rest(v->z, beta_v_0, m_4, R_02_right),
      R_02_lo1 = R_02_left_rest + R_02_right_rest, R_02_lo = R_02_lo1 + m_4_cross2;
  const double R_10 = halved_2 + m_3, R_10_right = R_10 - halved_2, R_10_left = R_10 - R_10_right,
      R_10_left_rest = halved_2 - R_10_left,
      R_10_right_rest = ksl_product_rest(v->y, beta_v_0, m_3, R_10_right),
      R_10_lo1 = R_10_left_rest + R_10_right_rest, R_10_lo = R_10_lo1 + m_3_cross2;
  const double R_12 = m_5 - halved_0, R_12_right = m_5 - R_12, R_12_left = R_12 + R_12_right,
      R_12_left_rest = ksl_product_rest(v->z, beta_v_1, m_5, R_12_left),
      R_12_right_rest = halved_0 - R_12_right, R_12_lo1 = R_12_left_rest - R_12_right_rest,
      R_12_lo = R_12_lo1 + m_5_cross2;
  const double R_20 = m_4 - halved_1, R_20_right = m_4 - R_20, R_20_left = R_20 + R_20_right,
      R_20_left_rest = ksl_product_rest(v->z, beta_v_0, m_4, R_20_left),
      R_20_right_rest = halved_1 - R_20_right, R_20_lo1 = R_20_left_rest - R_20_right_rest,
      R_20_lo = R_20_lo1 + m_4_cross2;
  const double R_21 = halved_0 + m_5, R_21_right = R_21 - halved_0, R_21_left = R_21 - R_21_right,
      R_21_left_rest = halved_0 - R_21_left,
      R_21_right_rest = ksl_product_rest(v->z, beta_v_1, m_5, R_21_right),
      R_21_lo1 = R_21_left_rest + R_21_right_rest, R_21_lo = R_21_lo1 + m_5_cross2;
  const double diagonal0_rounded = diagonal0 + diagonal0_lo,
      diagonal0_final = diagonal0_rounded == diagonal0_rounded ? diagonal0_rounded : diagonal0;
  const double R_01_rounded = R_01 + R_01_lo,
      R_01_final = R_01_rounded == R_01_rounded ? R_01_rounded : R_01;
  const double R_02_rounded = R_02 + R_02_lo,
      R_02_final = R_02_rounded == R_02_rounded ? R_02_rounded : R_02;
  const double R_10_rounded = R_10 + R_10_lo,
      R_10_final = R_10_rounded == R_10_rounded ? R_10_rounded : R_10;
  const double diagonal1_rounded = diagonal1 + diagonal1_lo,
      diagonal1_final = diagonal1_rounded == diagonal1_rounded ? diagonal1_rounded : diagonal1;
  const double R_12_rounded = R_12 + R_12_lo,
      R_12_final = R_12_rounded == R_12_rounded ? R_12_rounded : R_12;
  const double R_20_rounded = R_20 + R_20_lo,
      R_20_final = R_20_rounded == R_20_rounded ? R_20_rounded : R_20;
  const double R_21_rounded = R_21 + R_21_lo,
      R_21_final = R_21_rounded == R_21_rounded ? R_21_rounded : R_21;
  const double diagonal2_rounded = diagonal2 + diagonal2_lo,
      diagonal2_final = diagonal2_rounded == diagonal2_rounded ? diagonal2_rounded : diagonal2;
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
  const double halved_0 = KSL_MUL(0.5, s->m3);
  const double halved_1 = KSL_MUL(0.5, s->m4);
  const double halved_2 = KSL_MUL(0.5, s->m5);
  const double y_a = KSL_MUL(halved_0, halved_0), y_b = KSL_MUL(halved_1, halved_1),
      y_c = y_a + y_b, y_c_right = y_c - y_a, y_c_left = y_c - y_c_right,
      y_c_left_rest = ksl_product_rest(halved_0, halved_0, y_a, y_c_left),
      y_c_right_rest = ksl_product_rest(halved_1, halved_1, y_b, y_c_right),
      y_c_lo = y_c_left_rest + y_c_right_rest, y_d = KSL_MUL(halved_2, halved_2), y = y_c + y_d,
      y_right = y - y_c, y_left = y - y_right, y_left_rest = y_c - y_left,
      y_right_rest = ksl_product_rest(halved_2, halved_2, y_d, y_right),
      y_lo1 = y_left_rest + y_right_rest, y_lo = y_lo1 + y_c_lo;
  const double half_angle_of_y = y + y_lo, half_angle_of_y_right = half_angle_of_y - y,
      half_angle_of_y_left = half_angle_of_y - half_angle_of_y_right,
      half_angle_of_y_left_rest = y - half_angle_of_y_left,
      half_angle_of_y_right_rest = y_lo - half_angle_of_y_right,
      half_angle_of_y_lo = half_angle_of_y_left_rest + half_angle_of_y_right_rest,
      half_angle = sqrt(half_angle_of_y), half_angle_product = KSL_MUL(half_angle, half_angle),
      half_angle_product_error = ksl_product_error(half_angle, half_angle, half_angle_product),
      half_angle_rest = half_angle_of_y - half_angle_product,
      half_angle_exact = half_angle_rest - half_angle_product_error,
      half_angle_residual = half_angle_exact + half_angle_of_y_lo,
      half_angle_twice = half_angle + half_angle,
      half_angle_divisor = half_angle == 0.0 ? 1.0 : half_angle_twice,
      half_angle_lo = half_angle_residual / half_angle_divisor;
  const double sine_of_half_angle = half_angle + half_angle_lo,
      sine_of_half_angle_right = sine_of_half_angle - half_angle,
      sine_of_half_angle_left = sine_of_half_angle - sine_of_half_angle_right,
      sine_of_half_angle_left_rest = half_angle - sine_of_half_angle_left,
      sine_of_half_angle_right_rest = half_angle_lo - sine_of_half_angle_right,
      sine_of_half_angle_lo = sine_of_half_angle_left_rest + sine_of_half_angle_right_rest;
  double c; const double sine = ksl_sincos(sine_of_half_angle, &c);
  double c_own_error; const double sine_own_error = ksl_sincos_error(sine_of_half_angle, sine, c,
      &c_own_error);
  const double sine_half = KSL_MUL(sine_of_half_angle_lo, 0.5);
  double sine_half_cos; const double sine_half_sin = ksl_sincos(sine_half, &sine_half_cos);
  const double sine_twice = sine_half_sin + sine_half_sin, sine_slope1 = KSL_MUL(sine_half_cos, c),
      sine_slope2 = KSL_MUL(sine_half_sin, sine), sine_slope = sine_slope1 - sine_slope2,
      sine_more = KSL_MUL(sine_slope, sine_twice), sine_lo = sine_own_error + sine_more;
  const double c_slope1 = KSL_MUL(sine_half_cos, sine), c_slope2 = KSL_MUL(sine_half_sin, c),
      c_slope = c_slope1 + c_slope2, c_more = KSL_MUL(c_slope, sine_twice),
      c_lo = c_own_error - c_more;
  const double sinc_divisor = sine_of_half_angle < 1.4901161193847656e-08 ? 1.4901161193847656e-08 :
      sine_of_half_angle,
      sinc_divisor_lo = sine_of_half_angle < 1.4901161193847656e-08 ? 0.0 : sine_of_half_angle_lo;
  const double sinc_quotient_of_sine = sine + sine_lo,
      sinc_quotient_of_sine_right = sinc_quotient_of_sine - sine,
      sinc_quotient_of_sine_left = sinc_quotient_of_sine - sinc_quotient_of_sine_right,
      sinc_quotient_of_sine_left_rest = sine - sinc_quotient_of_sine_left,
      sinc_quotient_of_sine_right_rest = sine_lo - sinc_quotient_of_sine_right,
      sinc_quotient_of_sine_lo = sinc_quotient_of_sine_left_rest + sinc_quotient_of_sine_right_rest,
      sinc_quotient_of_sinc_divisor = sinc_divisor + sinc_divisor_lo,
      sinc_quotient_of_sinc_divisor_right = sinc_quotient_of_sinc_divisor - sinc_divisor,
      sinc_quotient_of_sinc_divisor_left = sinc_quotient_of_sinc_divisor -
          sinc_quotient_of_sinc_divisor_right,
      sinc_quotient_of_sinc_divisor_left_rest = sinc_divisor - sinc_quotient_of_sinc_divisor_left,
      sinc_quotient_of_sinc_divisor_right_rest = sinc_divisor_lo -
          sinc_quotient_of_sinc_divisor_right,
      sinc_quotient_of_sinc_divisor_lo = sinc_quotient_of_sinc_divisor_left_rest +
          sinc_quotient_of_sinc_divisor_right_rest,
      sinc_quotient = sinc_quotient_of_sine / sinc_quotient_of_sinc_divisor,
      sinc_quotient_product = KSL_MUL(sinc_quotient, sinc_quotient_of_sinc_divisor),
      sinc_quotient_product_error = ksl_product_error(sinc_quotient, sinc_quotient_of_sinc_divisor,
          sinc_quotient_product),
      sinc_quotient_rest = sinc_quotient_of_sine - sinc_quotient_product,
      sinc_quotient_exact = sinc_quotient_rest - sinc_quotient_product_error,
      sinc_quotient_numerator = sinc_quotient_exact + sinc_quotient_of_sine_lo,
      sinc_quotient_cross = KSL_MUL(sinc_quotient, sinc_quotient_of_sinc_divisor_lo),
      sinc_quotient_residual = sinc_quotient_numerator - sinc_quotient_cross,
      sinc_quotient_lo = sinc_quotient_residual / sinc_quotient_of_sinc_divisor;
  const double sinc_a = KSL_MUL(0.16666666666666666, half_angle_of_y),
      sinc_a_cross1 = KSL_MUL(9.25185853854297e-18, half_angle_of_y),
      sinc_a_cross2 = KSL_MUL(0.16666666666666666, half_angle_of_y_lo),
      sinc_a_cross = sinc_a_cross1 + sinc_a_cross2, sinc_b = 1.0 - sinc_a,
      sinc_b_right = 1.0 - sinc_b, sinc_b_left = sinc_b + sinc_b_right,
      sinc_b_left_rest = 1.0 - sinc_b_left,
      sinc_b_right_rest = ksl_product_rest(0.16666666666666666, half_angle_of_y, sinc_a,
          sinc_b_right),
      sinc_b_lo1 = sinc_b_left_rest - sinc_b_right_rest, sinc_b_lo = sinc_b_lo1 - sinc_a_cross,
      sinc = sine_of_half_angle < 1.4901161193847656e-08 ? sinc_b : sinc_quotient,
      sinc_lo = sine_of_half_angle < 1.4901161193847656e-08 ? sinc_b_lo : sinc_quotient_lo;
  const double g1 = KSL_MUL(c, sinc), g1_cross1 = KSL_MUL(c_lo, sinc),
      g1_cross2 = KSL_MUL(c, sinc_lo), g1_cross = g1_cross1 + g1_cross2;
  const double g2a = KSL_MUL(sinc, sinc), g2a_cross1 = KSL_MUL(sinc_lo, sinc),
      g2a_cross2 = KSL_MUL(sinc, sinc_lo), g2a_cross = g2a_cross1 + g2a_cross2,
      g2a_error = ksl_product_error(sinc, sinc, g2a), g2a_lo = g2a_error + g2a_cross,
      g2 = KSL_MUL(0.5, g2a), g2_cross2 = KSL_MUL(0.5, g2a_lo);
  const double sine_square = KSL_MUL(sinc_quotient_of_sine, sinc_quotient_of_sine),
      sine_square_cross1 = KSL_MUL(sinc_quotient_of_sine_lo, sinc_quotient_of_sine),
      sine_square_cross2 = KSL_MUL(sinc_quotient_of_sine, sinc_quotient_of_sine_lo),
      sine_square_cross = sine_square_cross1 + sine_square_cross2;
  const double sine_square_error = ksl_product_error(sinc_quotient_of_sine, sinc_quotient_of_sine,
      sine_square),
      sine_square_lo = sine_square_error + sine_square_cross, g0a = KSL_MUL(2.0, sine_square),
      g0a_cross2 = KSL_MUL(2.0, sine_square_lo), g0 = 1.0 - g0a, g0_right = 1.0 - g0,
      g0_left = g0 + g0_right, g0_left_rest = 1.0 - g0_left, g0_right_rest = g0a - g0_right,
      g0_lo1 = g0_left_rest - g0_right_rest, g0_lo = g0_lo1 - g0a_cross2;
  const double rest3 = 1.0 - g1, rest3_right = 1.0 - rest3, rest3_left = rest3 + rest3_right,
      rest3_left_rest = 1.0 - rest3_left,
      rest3_right_rest = ksl_product_rest(c, sinc, g1, rest3_right),
      rest3_lo1 = rest3_left_rest - rest3_right_rest, rest3_lo = rest3_lo1 - g1_cross;
  const double x = KSL_MUL(4.0, half_angle_of_y), x_cross2 = KSL_MUL(4.0, half_angle_of_y_lo);
  const double far_x_a_of_x = x + x_cross2, far_x_a_of_x_right = far_x_a_of_x - x,
      far_x_a_of_x_left = far_x_a_of_x - far_x_a_of_x_right,
      far_x_a_of_x_left_rest = x - far_x_a_of_x_left,
      far_x_a_of_x_right_rest = x_cross2 - far_x_a_of_x_right,
      far_x_a_of_x_lo = far_x_a_of_x_left_rest + far_x_a_of_x_right_rest,
      far_x = far_x_a_of_x < 1.0 ? 1.0 : far_x_a_of_x,
      far_x_lo = far_x_a_of_x < 1.0 ? 0.0 : far_x_a_of_x_lo;
  const double closed3_of_rest3 = rest3 + rest3_lo,
      closed3_of_rest3_right = closed3_of_rest3 - rest3,
      closed3_of_rest3_left = closed3_of_rest3 - closed3_of_rest3_right,
      closed3_of_rest3_left_rest = rest3 - closed3_of_rest3_left,
      closed3_of_rest3_right_rest = rest3_lo - closed3_of_rest3_right,
      closed3_of_rest3_lo = closed3_of_rest3_left_rest + closed3_of_rest3_right_rest,
      closed3_of_far_x = far_x + far_x_lo, closed3_of_far_x_right = closed3_of_far_x - far_x,
      closed3_of_far_x_left = closed3_of_far_x - closed3_of_far_x_right,
      closed3_of_far_x_left_rest = far_x - closed3_of_far_x_left,
      closed3_of_far_x_right_rest = far_x_lo - closed3_of_far_x_right,
      closed3_of_far_x_lo = closed3_of_far_x_left_rest + closed3_of_far_x_right_rest,
      closed3 = closed3_of_rest3 / closed3_of_far_x,
      closed3_product = KSL_MUL(closed3, closed3_of_far_x),
      closed3_product_error = ksl_product_error(closed3, closed3_of_far_x, closed3_product),
      closed3_rest = closed3_of_rest3 - closed3_product,
      closed3_exact = closed3_rest - closed3_product_error,
      closed3_numerator = closed3_exact + closed3_of_rest3_lo,
      closed3_cross = KSL_MUL(closed3, closed3_of_far_x_lo),
      closed3_residual = closed3_numerator - closed3_cross,
      closed3_lo = closed3_residual / closed3_of_far_x;
  const double series5a = KSL_MUL(1.216125041553518e-34, far_x_a_of_x),
      series5a_cross1 = KSL_MUL(5.586290567888806e-51, far_x_a_of_x),
      series5a_cross2 = KSL_MUL(1.216125041553518e-34, far_x_a_of_x_lo),
      series5a_cross = series5a_cross1 + series5a_cross2,
      series5b = 1.1309962886447716e-31 - series5a,
      series5b_right = 1.1309962886447716e-31 - series5b, series5b_left = series5b + series5b_right,
      series5b_left_rest = 1.1309962886447716e-31 - series5b_left,
      series5b_right_rest = ksl_product_rest(1.216125041553518e-34, far_x_a_of_x, series5a,
          series5b_right),
      series5b_lo1 = series5b_left_rest - series5b_right_rest,
      series5b_lo2 = series5b_lo1 - series5a_cross,
      series5b_lo = series5b_lo2 + 1.0498015412959506e-47,
      series5c = KSL_MUL(far_x_a_of_x, series5b),
      series5c_cross1 = KSL_MUL(far_x_a_of_x_lo, series5b),
      series5c_cross2 = KSL_MUL(far_x_a_of_x, series5b_lo),
      series5c_cross = series5c_cross1 + series5c_cross2,
      series5d = series5c - 9.183689863795546e-29, series5d_right = series5c - series5d,
      series5d_left = series5d + series5d_right,
      series5d_left_rest = ksl_product_rest(far_x_a_of_x, series5b, series5c, series5d_left),
      series5d_right_rest = 9.183689863795546e-29 - series5d_right,
      series5d_lo1 = series5d_left_rest - series5d_right_rest,
      series5d_lo2 = series5d_lo1 - 1.4303150396787322e-45,
      series5d_lo = series5d_lo2 + series5c_cross, series5e = KSL_MUL(far_x_a_of_x, series5d),
      series5e_cross1 = KSL_MUL(far_x_a_of_x_lo, series5d),
      series5e_cross2 = KSL_MUL(far_x_a_of_x, series5d_lo),
      series5e_cross = series5e_cross1 + series5e_cross2,
      series5f = series5e + 6.446950284384474e-26, series5f_right = series5f - series5e,
      series5f_left = series5f - series5f_right,
      series5f_left_rest = ksl_product_rest(far_x_a_of_x, series5d, series5e, series5f_left),
      series5f_right_rest = 6.446950284384474e-26 - series5f_right,
      series5f_lo1 = series5f_left_rest + series5f_right_rest,
      series5f_lo2 = series5f_lo1 + -1.9330404233703465e-42,
      series5f_lo = series5f_lo2 + series5e_cross, series5g = KSL_MUL(far_x_a_of_x, series5f),
      series5g_cross1 = KSL_MUL(far_x_a_of_x_lo, series5f),
      series5g_cross2 = KSL_MUL(far_x_a_of_x, series5f_lo),
      series5g_cross = series5g_cross1 + series5g_cross2,
      series5h = series5g - 3.868170170630684e-23, series5h_right = series5g - series5h,
      series5h_left = series5h + series5h_right,
      series5h_left_rest = ksl_product_rest(far_x_a_of_x, series5f, series5g, series5h_left),
      series5h_right_rest = 3.868170170630684e-23 - series5h_right,
      series5h_lo1 = series5h_left_rest - series5h_right_rest,
      series5h_lo2 = series5h_lo1 - -8.843177655482344e-40,
      series5h_lo = series5h_lo2 + series5g_cross, series5i = KSL_MUL(far_x_a_of_x, series5h),
      series5i_cross1 = KSL_MUL(far_x_a_of_x_lo, series5h),
      series5i_cross2 = KSL_MUL(far_x_a_of_x, series5h_lo),
      series5i_cross = series5i_cross1 + series5i_cross2,
      series5j = series5i + 1.9572941063391263e-20, series5j_right = series5j - series5i,
      series5j_left = series5j - series5j_right,
      series5j_left_rest = ksl_product_rest(far_x_a_of_x, series5h, series5i, series5j_left),
      series5j_right_rest = 1.9572941063391263e-20 - series5j_right,
      series5j_lo1 = series5j_left_rest + series5j_right_rest,
      series5j_lo2 = series5j_lo1 + -1.3643503830087908e-36,
      series5j_lo = series5j_lo2 + series5i_cross, series5k = KSL_MUL(far_x_a_of_x, series5j),
      series5k_cross1 = KSL_MUL(far_x_a_of_x_lo, series5j),
      series5k_cross2 = KSL_MUL(far_x_a_of_x, series5j_lo),
      series5k_cross = series5k_cross1 + series5k_cross2,
      series5l = series5k - 8.22063524662433e-18, series5l_right = series5k - series5l,
      series5l_left = series5l + series5l_right,
      series5l_left_rest = ksl_product_rest(far_x_a_of_x, series5j, series5k, series5l_left),
      series5l_right_rest = 8.22063524662433e-18 - series5l_right,
      series5l_lo1 = series5l_left_rest - series5l_right_rest,
      series5l_lo2 = series5l_lo1 - 2.2141894119604265e-34,
      series5l_lo = series5l_lo2 + series5k_cross, series5m = KSL_MUL(far_x_a_of_x, series5l),
      series5m_cross1 = KSL_MUL(far_x_a_of_x_lo, series5l),
      series5m_cross2 = KSL_MUL(far_x_a_of_x, series5l_lo),
      series5m_cross = series5m_cross1 + series5m_cross2,
      series5n = series5m + 2.8114572543455206e-15, series5n_right = series5n - series5m,
      series5n_left = series5n - series5n_right,
      series5n_left_rest = ksl_product_rest(far_x_a_of_x, series5l, series5m, series5n_left),
      series5n_right_rest = 2.8114572543455206e-15 - series5n_right,
      series5n_lo1 = series5n_left_rest + series5n_right_rest,
      series5n_lo2 = series5n_lo1 + 1.6508842730861433e-31,
      series5n_lo = series5n_lo2 + series5m_cross, series5o = KSL_MUL(far_x_a_of_x, series5n),
      series5o_cross1 = KSL_MUL(far_x_a_of_x_lo, series5n),
      series5o_cross2 = KSL_MUL(far_x_a_of_x, series5n_lo),
      series5o_cross = series5o_cross1 + series5o_cross2,
      series5p = series5o - 7.647163731819816e-13, series5p_right = series5o - series5p,
      series5p_left = series5p + series5p_right,
      series5p_left_rest = ksl_product_rest(far_x_a_of_x, series5n, series5o, series5p_left),
      series5p_right_rest = 7.647163731819816e-13 - series5p_right,
      series5p_lo1 = series5p_left_rest - series5p_right_rest,
      series5p_lo2 = series5p_lo1 - 7.03872877733453e-30,
      series5p_lo = series5p_lo2 + series5o_cross, series5q = KSL_MUL(far_x_a_of_x, series5p),
      series5q_cross1 = KSL_MUL(far_x_a_of_x_lo, series5p),
      series5q_cross2 = KSL_MUL(far_x_a_of_x, series5p_lo),
      series5q_cross = series5q_cross1 + series5q_cross2,
      series5r = series5q + 1.6059043836821613e-10, series5r_right = series5r - series5q,
      series5r_left = series5r - series5r_right,
      series5r_left_rest = ksl_product_rest(far_x_a_of_x, series5p, series5q, series5r_left),
      series5r_right_rest = 1.6059043836821613e-10 - series5r_right,
      series5r_lo1 = series5r_left_rest + series5r_right_rest,
      series5r_lo2 = series5r_lo1 + 1.2585294588752098e-26,
      series5r_lo = series5r_lo2 + series5q_cross, series5s = KSL_MUL(far_x_a_of_x, series5r),
      series5s_cross1 = KSL_MUL(far_x_a_of_x_lo, series5r),
      series5s_cross2 = KSL_MUL(far_x_a_of_x, series5r_lo),
      series5s_cross = series5s_cross1 + series5s_cross2,
      series5t = series5s - 2.505210838544172e-08, series5t_right = series5s - series5t,
      series5t_left = series5t + series5t_right,
      series5t_left_rest = ksl_product_rest(far_x_a_of_x, series5r, series5s, series5t_left),
      series5t_right_rest = 2.505210838544172e-08 - series5t_right,
      series5t_lo1 = series5t_left_rest - series5t_right_rest,
      series5t_lo2 = series5t_lo1 - -1.448814070935912e-24,
      series5t_lo = series5t_lo2 + series5s_cross, series5u = KSL_MUL(far_x_a_of_x, series5t),
      series5u_cross1 = KSL_MUL(far_x_a_of_x_lo, series5t),
      series5u_cross2 = KSL_MUL(far_x_a_of_x, series5t_lo),
      series5u_cross = series5u_cross1 + series5u_cross2,
      series5v = series5u + 2.7557319223985893e-06, series5v_right = series5v - series5u,
      series5v_left = series5v - series5v_right,
      series5v_left_rest = ksl_product_rest(far_x_a_of_x, series5t, series5u, series5v_left),
      series5v_right_rest = 2.7557319223985893e-06 - series5v_right,
      series5v_lo1 = series5v_left_rest + series5v_right_rest,
      series5v_lo2 = series5v_lo1 + -1.858393274046472e-22,
      series5v_lo = series5v_lo2 + series5u_cross, series5w = KSL_MUL(far_x_a_of_x, series5v),
      series5w_cross1 = KSL_MUL(far_x_a_of_x_lo, series5v),
      series5w_cross2 = KSL_MUL(far_x_a_of_x, series5v_lo),
      series5w_cross = series5w_cross1 + series5w_cross2,
      series5x = series5w - 0.0001984126984126984, series5x_right = series5w - series5x,
      series5x_left = series5x + series5x_right,
      series5x_left_rest = ksl_product_rest(far_x_a_of_x, series5v, series5w, series5x_left),
      series5x_right_rest = 0.0001984126984126984 - series5x_right,
      series5x_lo1 = series5x_left_rest - series5x_right_rest,
      series5x_lo2 = series5x_lo1 - 1.7209558293420705e-22,
      series5x_lo = series5x_lo2 + series5w_cross, series5y = KSL_MUL(far_x_a_of_x, series5x),
      series5y_cross1 = KSL_MUL(far_x_a_of_x_lo, series5x),
      series5y_cross2 = KSL_MUL(far_x_a_of_x, series5x_lo),
      series5y_cross = series5y_cross1 + series5y_cross2, series5 = series5y + 0.008333333333333333,
      series5_right = series5 - series5y, series5_left = series5 - series5_right,
      series5_left_rest = ksl_product_rest(far_x_a_of_x, series5x, series5y, series5_left),
      series5_right_rest = 0.008333333333333333 - series5_right,
      series5_lo1 = series5_left_rest + series5_right_rest,
      series5_lo2 = series5_lo1 + 1.1564823173178714e-19, series5_lo = series5_lo2 + series5y_cross;
  const double g3a = KSL_MUL(far_x_a_of_x, series5), g3a_cross1 = KSL_MUL(far_x_a_of_x_lo, series5),
      g3a_cross2 = KSL_MUL(far_x_a_of_x, series5_lo), g3a_cross = g3a_cross1 + g3a_cross2,
      g3b = 0.16666666666666666 - g3a, g3b_right = 0.16666666666666666 - g3b,
      g3b_left = g3b + g3b_right, g3b_left_rest = 0.16666666666666666 - g3b_left,
      g3b_right_rest = ksl_product_rest(far_x_a_of_x, series5, g3a, g3b_right),
      g3b_lo1 = g3b_left_rest - g3b_right_rest, g3b_lo2 = g3b_lo1 - g3a_cross,
      g3b_lo = g3b_lo2 + 9.25185853854297e-18, g3 = far_x_a_of_x < 1.0 ? g3b : closed3,
      g3_lo = far_x_a_of_x < 1.0 ? g3b_lo : closed3_lo;
  const double u_0a = KSL_MUL(s->m2, s->m4), u_0b = KSL_MUL(s->m1, s->m5), u_0 = u_0a - u_0b,
      u_0_right = u_0a - u_0, u_0_left = u_0 + u_0_right,
      u_0_left_rest = ksl_product_rest(s->m2, s->m4, u_0a, u_0_left),
      u_0_right_rest = ksl_product_rest(s->m1, s->m5, u_0b, u_0_right),
      u_0_lo = u_0_left_rest - u_0_right_rest;
  const double u_1a = KSL_MUL(s->m0, s->m5), u_1b = KSL_MUL(s->m2, s->m3), u_1 = u_1a - u_1b,
      u_1_right = u_1a - u_1, u_1_left = u_1 + u_1_right,
      u_1_left_rest = ksl_product_rest(s->m0, s->m5, u_1a, u_1_left),
      u_1_right_rest = ksl_product_rest(s->m2, s->m3, u_1b, u_1_right),
      u_1_lo = u_1_left_rest - u_1_right_rest;
  const double u_2a = KSL_MUL(s->m1, s->m3), u_2b = KSL_MUL(s->m0, s->m4), u_2 = u_2a - u_2b,
      u_2_right = u_2a - u_2, u_2_left = u_2 + u_2_right,
      u_2_left_rest = ksl_product_rest(s->m1, s->m3, u_2a, u_2_left),
      u_2_right_rest = ksl_product_rest(s->m0, s->m4, u_2b, u_2_right),
      u_2_lo = u_2_left_rest - u_2_right_rest;
  const double turned_0 = KSL_MUL(g2, u_0), turned_0_cross1 = KSL_MUL(g2_cross2, u_0),
      turned_0_cross2 = KSL_MUL(g2, u_0_lo), turned_0_cross = turned_0_cross1 + turned_0_cross2;
  const double turned_1 = KSL_MUL(g2, u_1), turned_1_cross1 = KSL_MUL(g2_cross2, u_1),
      turned_1_cross2 = KSL_MUL(g2, u_1_lo), turned_1_cross = turned_1_cross1 + turned_1_cross2;
  const double turned_2 = KSL_MUL(g2, u_2), turned_2_cross1 = KSL_MUL(g2_cross2, u_2),
      turned_2_cross2 = KSL_MUL(g2, u_2_lo), turned_2_cross = turned_2_cross1 + turned_2_cross2;
  const double wv_a = KSL_MUL(s->m0, s->m3), wv_b = KSL_MUL(s->m1, s->m4), wv_c = wv_a + wv_b,
      wv_c_right = wv_c - wv_a, wv_c_left = wv_c - wv_c_right,
      wv_c_left_rest = ksl_product_rest(s->m0, s->m3, wv_a, wv_c_left),
      wv_c_right_rest = ksl_product_rest(s->m1, s->m4, wv_b, wv_c_right),
      wv_c_lo = wv_c_left_rest + wv_c_right_rest, wv_d = KSL_MUL(s->m2, s->m5), wv = wv_c + wv_d,
      wv_right = wv - wv_c, wv_left = wv - wv_right, wv_left_rest = wv_c - wv_left,
      wv_right_rest = ksl_product_rest(s->m2, s->m5, wv_d, wv_right),
      wv_lo1 = wv_left_rest + wv_right_rest, wv_lo = wv_lo1 + wv_c_lo;
  const double pitch = KSL_MUL(g3, wv), pitch_cross1 = KSL_MUL(g3_lo, wv),
      pitch_cross2 = KSL_MUL(g3, wv_lo), pitch_cross = pitch_cross1 + pitch_cross2;
  const double pitch_error = ksl_product_error(g3, wv, pitch), pitch_lo = pitch_error + pitch_cross,
      along_0 = KSL_MUL(s->m3, pitch), along_0_cross2 = KSL_MUL(s->m3, pitch_lo);
  const double along_1 = KSL_MUL(s->m4, pitch), along_1_cross2 = KSL_MUL(s->m4, pitch_lo);
  const double along_2 = KSL_MUL(s->m5, pitch), along_2_cross2 = KSL_MUL(s->m5, pitch_lo);
  const double beta_v_0 = KSL_MUL(s->m3, g2), beta_v_0_cross2 = KSL_MUL(s->m3, g2_cross2);
  const double beta_v_1 = KSL_MUL(s->m4, g2), beta_v_1_cross2 = KSL_MUL(s->m4, g2_cross2);
  const double beta_v_2 = KSL_MUL(s->m5, g2), beta_v_2_cross2 = KSL_MUL(s->m5, g2_cross2);
  const double beta_v_0_error = ksl_product_error(s->m3, g2, beta_v_0),
      beta_v_0_lo = beta_v_0_error + beta_v_0_cross2, m_0 = KSL_MUL(s->m3, beta_v_0),
      m_0_cross2 = KSL_MUL(s->m3, beta_v_0_lo);
  const double beta_v_1_error = ksl_product_error(s->m4, g2, beta_v_1),
      beta_v_1_lo = beta_v_1_error + beta_v_1_cross2, m_1 = KSL_MUL(s->m4, beta_v_1),
      m_1_cross2 = KSL_MUL(s->m4, beta_v_1_lo);
  const double beta_v_2_error = ksl_product_error(s->m5, g2, beta_v_2),
      beta_v_2_lo = beta_v_2_error + beta_v_2_cross2, m_2 = KSL_MUL(s->m5, beta_v_2),
      m_2_cross2 = KSL_MUL(s->m5, beta_v_2_lo);
  const double m_3 = KSL_MUL(s->m4, beta_v_0), m_3_cross2 = KSL_MUL(s->m4, beta_v_0_lo);
  const double m_4 = KSL_MUL(s->m5, beta_v_0), m_4_cross2 = KSL_MUL(s->m5, beta_v_0_lo);
  const double m_5 = KSL_MUL(s->m5, beta_v_1), m_5_cross2 = KSL_MUL(s->m5, beta_v_1_lo);
  const double others_0 = m_1 + m_2, others_0_right = others_0 - m_1,
      others_0_left = others_0 - others_0_right,
      others_0_left_rest = ksl_product_rest(s->m4, beta_v_1, m_1, others_0_left),
      others_0_right_rest = ksl_product_rest(s->m5, beta_v_2, m_2, others_0_right),
      others_0_cross = m_1_cross2 + m_2_cross2,
      others_0_lo1 = others_0_left_rest + others_0_right_rest,
      others_0_lo = others_0_lo1 + others_0_cross;
  const double others_1 = m_0 + m_2, others_1_right = others_1 - m_0,
      others_1_left = others_1 - others_1_right,
      others_1_left_rest = ksl_product_rest(s->m3, beta_v_0, m_0, others_1_left),
      others_1_right_rest = ksl_product_rest(s->m5, beta_v_2, m_2, others_1_right),
      others_1_cross = m_0_cross2 + m_2_cross2,
      others_1_lo1 = others_1_left_rest + others_1_right_rest,
      others_1_lo = others_1_lo1 + others_1_cross;
  const double others_2 = m_0 + m_1, others_2_right = others_2 - m_0,
      others_2_left = others_2 - others_2_right,
      others_2_left_rest = ksl_product_rest(s->m3, beta_v_0, m_0, others_2_left),
      others_2_right_rest = ksl_product_rest(s->m4, beta_v_1, m_1, others_2_right),
      others_2_cross = m_0_cross2 + m_1_cross2,
      others_2_lo1 = others_2_left_rest + others_2_right_rest,
      others_2_lo = others_2_lo1 + others_2_cross;
  const double diagonal0a = 1.0 - others_0, diagonal0a_right = 1.0 - diagonal0a,
      diagonal0a_left = diagonal0a + diagonal0a_right, diagonal0a_left_rest = 1.0 - diagonal0a_left,
      diagonal0a_right_rest = others_0 - diagonal0a_right,
      diagonal0a_lo1 = diagonal0a_left_rest - diagonal0a_right_rest,
      diagonal0a_lo = diagonal0a_lo1 - others_0_lo, diagonal0b = g0 + m_0,
      diagonal0b_right = diagonal0b - g0, diagonal0b_left = diagonal0b - diagonal0b_right,
      diagonal0b_left_rest = g0 - diagonal0b_left,
      diagonal0b_right_rest = ksl_product_rest(s->m3, beta_v_0, m_0, diagonal0b_right),
      diagonal0b_lo1 = diagonal0b_left_rest + diagonal0b_right_rest,
      diagonal0b_lo2 = diagonal0b_lo1 + m_0_cross2, diagonal0b_lo = diagonal0b_lo2 + g0_lo,
      m_0_error = ksl_product_error(s->m3, beta_v_0, m_0), m_0_lo = m_0_error + m_0_cross2,
      diagonal0c_of_m_0 = m_0 + m_0_lo, diagonal0c_of_others_0 = others_0 + others_0_lo,
      diagonal0 = diagonal0c_of_m_0 < diagonal0c_of_others_0 ? diagonal0b : diagonal0a,
      diagonal0_lo = diagonal0c_of_m_0 < diagonal0c_of_others_0 ? diagonal0b_lo : diagonal0a_lo;
  const double diagonal1a = 1.0 - others_1, diagonal1a_right = 1.0 - diagonal1a,
      diagonal1a_left = diagonal1a + diagonal1a_right, diagonal1a_left_rest = 1.0 - diagonal1a_left,
      diagonal1a_right_rest = others_1 - diagonal1a_right,
      diagonal1a_lo1 = diagonal1a_left_rest - diagonal1a_right_rest,
      diagonal1a_lo = diagonal1a_lo1 - others_1_lo, diagonal1b = g0 + m_1,
      diagonal1b_right = diagonal1b - g0, diagonal1b_left = diagonal1b - diagonal1b_right,
      diagonal1b_left_rest = g0 - diagonal1b_left,
      diagonal1b_right_rest = ksl_product_rest(s->m4, beta_v_1, m_1, diagonal1b_right),
      diagonal1b_lo1 = diagonal1b_left_rest + diagonal1b_right_rest,
      diagonal1b_lo2 = diagonal1b_lo1 + m_1_cross2, diagonal1b_lo = diagonal1b_lo2 + g0_lo,
      m_1_error = ksl_product_error(s->m4, beta_v_1, m_1), m_1_lo = m_1_error + m_1_cross2,
      diagonal1c_of_m_1 = m_1 + m_1_lo, diagonal1c_of_others_1 = others_1 + others_1_lo,
      diagonal1 = diagonal1c_of_m_1 < diagonal1c_of_others_1 ? diagonal1b : diagonal1a,
      diagonal1_lo = diagonal1c_of_m_1 < diagonal1c_of_others_1 ? diagonal1b_lo : diagonal1a_lo;
  const double diagonal2a = 1.0 - others_2, diagonal2a_right = 1.0 - diagonal2a,
      diagonal2a_left = diagonal2a + diagonal2a_right, diagonal2a_left_rest = 1.0 - diagonal2a_left,
      diagonal2a_right_rest = others_2 - diagonal2a_right,
      diagonal2a_lo1 = diagonal2a_left_rest - diagonal2a_right_rest,
      diagonal2a_lo = diagonal2a_lo1 - others_2_lo, diagonal2b = g0 + m_2,
      diagonal2b_right = diagonal2b - g0, diagonal2b_left = diagonal2b - diagonal2b_right,
      diagonal2b_left_rest = g0 - diagonal2b_left,
      diagonal2b_right_rest = ksl_product_rest(s->m5, beta_v_2, m_2, diagonal2b_right),
      diagonal2b_lo1 = diagonal2b_left_rest + diagonal2b_right_rest,
      diagonal2b_lo2 = diagonal2b_lo1 + m_2_cross2, diagonal2b_lo = diagonal2b_lo2 + g0_lo,
      m_2_error = ksl_product_error(s->m5, beta_v_2, m_2), m_2_lo = m_2_error + m_2_cross2,
      diagonal2c_of_m_2 = m_2 + m_2_lo, diagonal2c_of_others_2 = others_2 + others_2_lo,
      diagonal2 = diagonal2c_of_m_2 < diagonal2c_of_others_2 ? diagonal2b : diagonal2a,
      diagonal2_lo = diagonal2c_of_m_2 < diagonal2c_of_others_2 ? diagonal2b_lo : diagonal2a_lo;
  const double g1_error = ksl_product_error(c, sinc, g1), g1_lo = g1_error + g1_cross,
      alpha_v_0 = KSL_MUL(s->m3, g1), alpha_v_0_cross2 = KSL_MUL(s->m3, g1_lo);
  const double alpha_v_1 = KSL_MUL(s->m4, g1), alpha_v_1_cross2 = KSL_MUL(s->m4, g1_lo);
  const double alpha_v_2 = KSL_MUL(s->m5, g1), alpha_v_2_cross2 = KSL_MUL(s->m5, g1_lo);
  const double across_axis_0 = turned_0 + along_0, across_axis_0_right = across_axis_0 - turned_0,
      across_axis_0_left = across_axis_0 - across_axis_0_right,
      across_axis_0_left_rest = ksl_product_rest(g2, u_0, turned_0, across_axis_0_left),
      across_axis_0_right_rest = ksl_product_rest(s->m3, pitch, along_0, across_axis_0_right),
      across_axis_0_cross = turned_0_cross + along_0_cross2,
      across_axis_0_lo1 = across_axis_0_left_rest + across_axis_0_right_rest,
      across_axis_0_lo = across_axis_0_lo1 + across_axis_0_cross;
  const double across_axis_1 = turned_1 + along_1, across_axis_1_right = across_axis_1 - turned_1,
      across_axis_1_left = across_axis_1 - across_axis_1_right,
      across_axis_1_left_rest = ksl_product_rest(g2, u_1, turned_1, across_axis_1_left),
      across_axis_1_right_rest = ksl_product_rest(s->m4, pitch, along_1, across_axis_1_right),
      across_axis_1_cross = turned_1_cross + along_1_cross2,
      across_axis_1_lo1 = across_axis_1_left_rest + across_axis_1_right_rest,
      across_axis_1_lo = across_axis_1_lo1 + across_axis_1_cross;
  const double across_axis_2 = turned_2 + along_2, across_axis_2_right = across_axis_2 - turned_2,
      across_axis_2_left = across_axis_2 - across_axis_2_right,
      across_axis_2_left_rest = ksl_product_rest(g2, u_2, turned_2, across_axis_2_left),
      across_axis_2_right_rest = ksl_product_rest(s->m5, pitch, along_2, across_axis_2_right),
      across_axis_2_cross = turned_2_cross + along_2_cross2,
      across_axis_2_lo1 = across_axis_2_left_rest + across_axis_2_right_rest,
      across_axis_2_lo = across_axis_2_lo1 + across_axis_2_cross;
  const double D_01 = m_3 - alpha_v_2, D_01_right = m_3 - D_01, D_01_left = D_01 + D_01_right,
      D_01_left_rest = ksl_product_rest(s->m4, beta_v_0, m_3, D_01_left),
      D_01_right_rest = ksl_product_rest(s->m5, g1, alpha_v_2, D_01_right),
      D_01_cross = m_3_cross2 - alpha_v_2_cross2, D_01_lo1 = D_01_left_rest - D_01_right_rest,
      D_01_lo = D_01_lo1 + D_01_cross;
  const double D_02 = m_4 + alpha_v_1, D_02_right = D_02 - m_4, D_02_left = D_02 - D_02_right,
      D_02_left_rest = ksl_product_rest(s->m5, beta_v_0, m_4, D_02_left),
      D_02_right_rest = ksl_product_rest(s->m4, g1, alpha_v_1, D_02_right),
      D_02_cross = m_4_cross2 + alpha_v_1_cross2, D_02_lo1 = D_02_left_rest + D_02_right_rest,
      D_02_lo = D_02_lo1 + D_02_cross;
  const double D_03a = KSL_MUL(s->m0, g1), D_03a_cross2 = KSL_MUL(s->m0, g1_lo),
      D_03 = D_03a + across_axis_0, D_03_right = D_03 - D_03a, D_03_left = D_03 - D_03_right,
      D_03_left_rest = ksl_product_rest(s->m0, g1, D_03a, D_03_left),
      D_03_right_rest = across_axis_0 - D_03_right, D_03_lo1 = D_03_left_rest + D_03_right_rest,
      D_03_lo2 = D_03_lo1 + across_axis_0_lo, D_03_lo = D_03_lo2 + D_03a_cross2;
  const double D_10 = m_3 + alpha_v_2, D_10_right = D_10 - m_3, D_10_left = D_10 - D_10_right,
      D_10_left_rest = ksl_product_rest(s->m4, beta_v_0, m_3, D_10_left),
      D_10_right_rest = ksl_product_rest(s->m5, g1, alpha_v_2, D_10_right),
      D_10_cross = m_3_cross2 + alpha_v_2_cross2, D_10_lo1 = D_10_left_rest + D_10_right_rest,
      D_10_lo = D_10_lo1 + D_10_cross;
  const double D_12 = m_5 - alpha_v_0, D_12_right = m_5 - D_12, D_12_left = D_12 + D_12_right,
      D_12_left_rest = ksl_product_rest(s->m5, beta_v_1, m_5, D_12_left),
      D_12_right_rest = ksl_product_rest(s->m3, g1, alpha_v_0, D_12_right),
      D_12_cross = m_5_cross2 - alpha_v_0_cross2, D_12_lo1 = D_12_left_rest - D_12_right_rest,
      D_12_lo = D_12_lo1 + D_12_cross;
  const double D_13a = KSL_MUL(s->m1, g1), D_13a_cross2 = KSL_MUL(s->m1, g1_lo),
      D_13 = D_13a + across_axis_1, D_13_right = D_13 - D_13a, D_13_left = D_13 - D_13_right,
      D_13_left_rest = ksl_product_rest(s->m1, g1, D_13a, D_13_left),
      D_13_right_rest = across_axis_1 - D_13_right, D_13_lo1 = D_13_left_rest + D_13_right_rest,
      D_13_lo2 = D_13_lo1 + across_axis_1_lo, D_13_lo = D_13_lo2 + D_13a_cross2;
  const double D_20 = m_4 - alpha_v_1, D_20_right = m_4 - D_20, D_20_left = D_20 + D_20_right,
      D_20_left_rest = ksl_product_rest(s->m5, beta_v_0, m_4, D_20_left),
      D_20_right_rest = ksl_product_rest(s->m4, g1, alpha_v_1, D_20_right),
      D_20_cross = m_4_cross2 - alpha_v_1_cross2, D_20_lo1 = D_20_left_rest - D_20_right_rest,
      D_20_lo = D_20_lo1 + D_20_cross;
  const double D_21 = m_5 + alpha_v_0, D_21_right = D_21 - m_5, D_21_left = D_21 - D_21_right,
      D_21_left_rest = ksl_product_rest(s->m5, beta_v_1, m_5, D_21_left),
      D_21_right_rest = ksl_product_rest(s->m3, g1, alpha_v_0, D_21_right),
      D_21_cross = m_5_cross2 + alpha_v_0_cross2, D_21_lo1 = D_21_left_rest + D_21_right_rest,
      D_21_lo = D_21_lo1 + D_21_cross;
  const double D_23a = KSL_MUL(s->m2, g1), D_23a_cross2 = KSL_MUL(s->m2, g1_lo),
      D_23 = D_23a + across_axis_2, D_23_right = D_23 - D_23a, D_23_left = D_23 - D_23_right,
      D_23_left_rest = ksl_product_rest(s->m2, g1, D_23a, D_23_left),
      D_23_right_rest = across_axis_2 - D_23_right, D_23_lo1 = D_23_left_rest + D_23_right_rest,
      D_23_lo2 = D_23_lo1 + across_axis_2_lo, D_23_lo = D_23_lo2 + D_23a_cross2;
  const double diagonal0_rounded = diagonal0 + diagonal0_lo,
      diagonal0_final = diagonal0_rounded == diagonal0_rounded ? diagonal0_rounded : diagonal0;
  const double D_01_rounded = D_01 + D_01_lo,
      D_01_final = D_01_rounded == D_01_rounded ? D_01_rounded : D_01;
  const double D_02_rounded = D_02 + D_02_lo,
      D_02_final = D_02_rounded == D_02_rounded ? D_02_rounded : D_02;
  const double D_03_rounded = D_03 + D_03_lo,
      D_03_final = D_03_rounded == D_03_rounded ? D_03_rounded : D_03;
  const double D_10_rounded = D_10 + D_10_lo,
      D_10_final = D_10_rounded == D_10_rounded ? D_10_rounded : D_10;
  const double diagonal1_rounded = diagonal1 + diagonal1_lo,
      diagonal1_final = diagonal1_rounded == diagonal1_rounded ? diagonal1_rounded : diagonal1;
  const double D_12_rounded = D_12 + D_12_lo,
      D_12_final = D_12_rounded == D_12_rounded ? D_12_rounded : D_12;
  const double D_13_rounded = D_13 + D_13_lo,
      D_13_final = D_13_rounded == D_13_rounded ? D_13_rounded : D_13;
  const double D_20_rounded = D_20 + D_20_lo,
      D_20_final = D_20_rounded == D_20_rounded ? D_20_rounded : D_20;
  const double D_21_rounded = D_21 + D_21_lo,
      D_21_final = D_21_rounded == D_21_rounded ? D_21_rounded : D_21;
  const double diagonal2_rounded = diagonal2 + diagonal2_lo,
      diagonal2_final = diagonal2_rounded == diagonal2_rounded ? diagonal2_rounded : diagonal2;
  const double D_23_rounded = D_23 + D_23_lo,
      D_23_final = D_23_rounded == D_23_rounded ? D_23_rounded : D_23;
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
  const double p_0 = D->m21 - D->m12, p_0_right = D->m21 - p_0, p_0_left = p_0 + p_0_right,
      p_0_left_rest = D->m21 - p_0_left, p_0_right_rest = D->m12 - p_0_right,
      p_0_lo = p_0_left_rest - p_0_right_rest;
  const double p_1 = D->m02 - D->m20, p_1_right = D->m02 - p_1, p_1_left = p_1 + p_1_right,
      p_1_left_rest = D->m02 - p_1_left, p_1_right_rest = D->m20 - p_1_right,
      p_1_lo = p_1_left_rest - p_1_right_rest;
  const double p_2 = D->m10 - D->m01, p_2_right = D->m10 - p_2, p_2_left = p_2 + p_2_right,
      p_2_left_rest = D->m10 - p_2_left, p_2_right_rest = D->m01 - p_2_right,
      p_2_lo = p_2_left_rest - p_2_right_rest;
  const double s_0 = D->m12 + D->m21, s_0_right = s_0 - D->m12, s_0_left = s_0 - s_0_right,
      s_0_left_rest = D->m12 - s_0_left, s_0_right_rest = D->m21 - s_0_right,
      s_0_lo = s_0_left_rest + s_0_right_rest;
  const double s_1 = D->m02 + D->m20, s_1_right = s_1 - D->m02, s_1_left = s_1 - s_1_right,
      s_1_left_rest = D->m02 - s_1_left, s_1_right_rest = D->m20 - s_1_right,
      s_1_lo = s_1_left_rest + s_1_right_rest;
  const double s_2 = D->m01 + D->m10, s_2_right = s_2 - D->m01, s_2_left = s_2 - s_2_right,
      s_2_left_rest = D->m01 - s_2_left, s_2_right_rest = D->m10 - s_2_right,
      s_2_lo = s_2_left_rest + s_2_right_rest;
  const double first_0 = D->m00 + 1.0, first_0_right = first_0 - D->m00,
      first_0_left = first_0 - first_0_right, first_0_left_rest = D->m00 - first_0_left,
      first_0_right_rest = 1.0 - first_0_right, first_0_lo = first_0_left_rest + first_0_right_rest;
  const double first_1 = 1.0 - D->m00, first_1_right = 1.0 - first_1,
      first_1_left = first_1 + first_1_right, first_1_left_rest = 1.0 - first_1_left,
      first_1_right_rest = D->m00 - first_1_right,
      first_1_lo = first_1_left_rest - first_1_right_rest;
  const double others_0 = D->m11 + D->m22, others_0_right = others_0 - D->m11,
      others_0_left = others_0 - others_0_right, others_0_left_rest = D->m11 - others_0_left,
      others_0_right_rest = D->m22 - others_0_right,
      others_0_lo = others_0_left_rest + others_0_right_rest;
  const double others_1 = D->m11 - D->m22, others_1_right = D->m11 - others_1,
      others_1_left = others_1 + others_1_right, others_1_left_rest = D->m11 - others_1_left,
      others_1_right_rest = D->m22 - others_1_right,
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
  const double upper_3 = fabs(upper_0b_of_column_3), upper_3_opposite = -upper_0b_of_column_3_lo,
      upper_3_lo = upper_0b_of_column_3 < 0.0 ? upper_3_opposite : upper_0b_of_column_3_lo;
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
      v_y_0_rest = v_y_0_lost + v_s_size_0_of_upper_0_lo, v_y_0_lo = KSL_MUL(v_y_0_rest, v_s);
  const double v_y_1 = KSL_MUL(v_s_size_1_of_upper_1, v_s),
      v_y_1_back = KSL_MUL(v_y_1, v_y_0_inverse), v_y_1_lost = v_s_size_1_of_upper_1 - v_y_1_back,
      v_y_1_rest = v_y_1_lost + v_s_size_1_of_upper_1_lo, v_y_1_lo = KSL_MUL(v_y_1_rest, v_s);
  const double v_y_2 = KSL_MUL(v_s_size_2_of_upper_2, v_s),
      v_y_2_back = KSL_MUL(v_y_2, v_y_0_inverse), v_y_2_lost = v_s_size_2_of_upper_2 - v_y_2_back,
      v_y_2_rest = v_y_2_lost + v_s_size_2_of_upper_2_lo, v_y_2_lo = KSL_MUL(v_y_2_rest, v_s);
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
      n_rest = n_lost + n_of_v_n_lo, n_lo = KSL_MUL(n_rest, v_r);
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
  const double half_angle = KSL_MUL(0.5, k_of_theta),
      half_angle_cross2 = KSL_MUL(0.5, k_of_theta_lo);
  const double length_a = KSL_MUL(half_of_n, half_of_n),
      length_a_cross1 = KSL_MUL(half_of_n_lo, half_of_n),
      length_a_cross2 = KSL_MUL(half_of_n, half_of_n_lo),
      length_a_cross = length_a_cross1 + length_a_cross2,
      length_b = KSL_MUL(half_of_upper_3, half_of_upper_3),
      length_b_cross1 = KSL_MUL(half_of_upper_3_lo, half_of_upper_3),
      length_b_cross2 = KSL_MUL(half_of_upper_3, half_of_upper_3_lo),
      length_b_cross = length_b_cross1 + length_b_cross2, length_c = length_a + length_b,
      length_c_right = length_c - length_a, length_c_left = length_c - length_c_right,
      length_c_left_rest = ksl_product_rest(half_of_n, half_of_n, length_a, length_c_left),
      length_c_right_rest = ksl_product_rest(half_of_upper_3, half_of_upper_3, length_b,
          length_c_right),
      length_c_cross = length_a_cross + length_b_cross,
      length_c_lo1 = length_c_left_rest + length_c_right_rest,
      length_c_lo = length_c_lo1 + length_c_cross, length_of_length_c = length_c + length_c_lo,
      length_of_length_c_right = length_of_length_c - length_c,
      length_of_length_c_left = length_of_length_c - length_of_length_c_right,
      length_of_length_c_left_rest = length_c - length_of_length_c_left,
      length_of_length_c_right_rest = length_c_lo - length_of_length_c_right,
      length_of_length_c_lo = length_of_length_c_left_rest + length_of_length_c_right_rest,
      length = sqrt(length_of_length_c), length_product = KSL_MUL(length, length),
      length_product_error = ksl_product_error(length, length, length_product),
      length_rest = length_of_length_c - length_product,
      length_exact = length_rest - length_product_error,
      length_residual = length_exact + length_of_length_c_lo, length_twice = length + length,
      length_divisor = length == 0.0 ? 1.0 : length_twice,
      length_lo = length_residual / length_divisor;
  const double sine_of_length = length + length_lo, sine_of_length_right = sine_of_length - length,
      sine_of_length_left = sine_of_length - sine_of_length_right,
      sine_of_length_left_rest = length - sine_of_length_left,
      sine_of_length_right_rest = length_lo - sine_of_length_right,
      sine_of_length_lo = sine_of_length_left_rest + sine_of_length_right_rest,
      sine = half_of_n / sine_of_length, sine_product = KSL_MUL(sine, sine_of_length),
      sine_product_error = ksl_product_error(sine, sine_of_length, sine_product),
      sine_rest = half_of_n - sine_product, sine_exact = sine_rest - sine_product_error,
      sine_numerator = sine_exact + half_of_n_lo, sine_cross = KSL_MUL(sine, sine_of_length_lo),
      sine_residual = sine_numerator - sine_cross, sine_lo = sine_residual / sine_of_length;
  const double c = half_of_upper_3 / sine_of_length, c_product = KSL_MUL(c, sine_of_length),
      c_product_error = ksl_product_error(c, sine_of_length, c_product),
      c_rest = half_of_upper_3 - c_product, c_exact = c_rest - c_product_error,
      c_numerator = c_exact + half_of_upper_3_lo, c_cross = KSL_MUL(c, sine_of_length_lo),
      c_residual = c_numerator - c_cross, c_lo = c_residual / sine_of_length;
  const double y = KSL_MUL(half_angle, half_angle),
      y_cross1 = KSL_MUL(half_angle_cross2, half_angle),
      y_cross2 = KSL_MUL(half_angle, half_angle_cross2), y_cross = y_cross1 + y_cross2;
  const double sinc_divisor_a_of_half_angle = half_angle + half_angle_cross2,
      sinc_divisor_a_of_half_angle_right = sinc_divisor_a_of_half_angle - half_angle,
      sinc_divisor_a_of_half_angle_left = sinc_divisor_a_of_half_angle -
          sinc_divisor_a_of_half_angle_right,
      sinc_divisor_a_of_half_angle_left_rest = half_angle - sinc_divisor_a_of_half_angle_left,
      sinc_divisor_a_of_half_angle_right_rest = half_angle_cross2 -
          sinc_divisor_a_of_half_angle_right,
      sinc_divisor_a_of_half_angle_lo = sinc_divisor_a_of_half_angle_left_rest +
          sinc_divisor_a_of_half_angle_right_rest,
      sinc_divisor = sinc_divisor_a_of_half_angle < 1.4901161193847656e-08 ? 1.4901161193847656e-08
          : sinc_divisor_a_of_half_angle,
      sinc_divisor_lo = sinc_divisor_a_of_half_angle < 1.4901161193847656e-08 ? 0.0 :
          sinc_divisor_a_of_half_angle_lo;
  const double sinc_quotient_of_sine = sine + sine_lo,
      sinc_quotient_of_sine_right = sinc_quotient_of_sine - sine,
      sinc_quotient_of_sine_left = sinc_quotient_of_sine - sinc_quotient_of_sine_right,
      sinc_quotient_of_sine_left_rest = sine - sinc_quotient_of_sine_left,
      sinc_quotient_of_sine_right_rest = sine_lo - sinc_quotient_of_sine_right,
      sinc_quotient_of_sine_lo = sinc_quotient_of_sine_left_rest + sinc_quotient_of_sine_right_rest,
      sinc_quotient_of_sinc_divisor = sinc_divisor + sinc_divisor_lo,
      sinc_quotient_of_sinc_divisor_right = sinc_quotient_of_sinc_divisor - sinc_divisor,
      sinc_quotient_of_sinc_divisor_left = sinc_quotient_of_sinc_divisor -
          sinc_quotient_of_sinc_divisor_right,
      sinc_quotient_of_sinc_divisor_left_rest = sinc_divisor - sinc_quotient_of_sinc_divisor_left,
      sinc_quotient_of_sinc_divisor_right_rest = sinc_divisor_lo -
          sinc_quotient_of_sinc_divisor_right,
      sinc_quotient_of_sinc_divisor_lo = sinc_quotient_of_sinc_divisor_left_rest +
          sinc_quotient_of_sinc_divisor_right_rest,
      sinc_quotient = sinc_quotient_of_sine / sinc_quotient_of_sinc_divisor,
      sinc_quotient_product = KSL_MUL(sinc_quotient, sinc_quotient_of_sinc_divisor),
      sinc_quotient_product_error = ksl_product_error(sinc_quotient, sinc_quotient_of_sinc_divisor,
          sinc_quotient_product),
      sinc_quotient_rest = sinc_quotient_of_sine - sinc_quotient_product,
      sinc_quotient_exact = sinc_quotient_rest - sinc_quotient_product_error,
      sinc_quotient_numerator = sinc_quotient_exact + sinc_quotient_of_sine_lo,
      sinc_quotient_cross = KSL_MUL(sinc_quotient, sinc_quotient_of_sinc_divisor_lo),
      sinc_quotient_residual = sinc_quotient_numerator - sinc_quotient_cross,
      sinc_quotient_lo = sinc_quotient_residual / sinc_quotient_of_sinc_divisor;
  const double y_error = ksl_product_error(half_angle, half_angle, y), y_lo = y_error + y_cross,
      sinc_a = KSL_MUL(0.16666666666666666, y), sinc_a_cross1 = KSL_MUL(9.25185853854297e-18, y),
      sinc_a_cross2 = KSL_MUL(0.16666666666666666, y_lo),
      sinc_a_cross = sinc_a_cross1 + sinc_a_cross2, sinc_b = 1.0 - sinc_a,
      sinc_b_right = 1.0 - sinc_b, sinc_b_left = sinc_b + sinc_b_right,
      sinc_b_left_rest = 1.0 - sinc_b_left,
      sinc_b_right_rest = ksl_product_rest(0.16666666666666666, y, sinc_a, sinc_b_right),
      sinc_b_lo1 = sinc_b_left_rest - sinc_b_right_rest, sinc_b_lo = sinc_b_lo1 - sinc_a_cross,
      sinc = sinc_divisor_a_of_half_angle < 1.4901161193847656e-08 ? sinc_b : sinc_quotient,
      sinc_lo = sinc_divisor_a_of_half_angle < 1.4901161193847656e-08 ? sinc_b_lo :
          sinc_quotient_lo;
  const double series_phi_a = KSL_MUL(5.107725174524775e-32, y),
      series_phi_a_cross1 = KSL_MUL(4.7410392187559056e-48, y),
      series_phi_a_cross2 = KSL_MUL(5.107725174524775e-32, y_lo),
      series_phi_a_cross = series_phi_a_cross1 + series_phi_a_cross2,
      series_phi_b = 4.116826490666969e-29 - series_phi_a,
      series_phi_b_right = 4.116826490666969e-29 - series_phi_b,
      series_phi_b_left = series_phi_b + series_phi_b_right,
      series_phi_b_left_rest = 4.116826490666969e-29 - series_phi_b_left,
      series_phi_b_right_rest = ksl_product_rest(5.107725174524775e-32, y, series_phi_a,
          series_phi_b_right),
      series_phi_b_lo1 = series_phi_b_left_rest - series_phi_b_right_rest,
      series_phi_b_lo2 = series_phi_b_lo1 - series_phi_a_cross,
      series_phi_b_lo = series_phi_b_lo2 + -1.8714974010023092e-45,
      series_phi_c = KSL_MUL(y, series_phi_b), series_phi_c_cross1 = KSL_MUL(y_lo, series_phi_b),
      series_phi_c_cross2 = KSL_MUL(y, series_phi_b_lo),
      series_phi_c_cross = series_phi_c_cross1 + series_phi_c_cross2,
      series_phi_d = series_phi_c - 2.86531123750421e-26,
      series_phi_d_right = series_phi_c - series_phi_d,
      series_phi_d_left = series_phi_d + series_phi_d_right,
      series_phi_d_left_rest = ksl_product_rest(y, series_phi_b, series_phi_c, series_phi_d_left),
      series_phi_d_right_rest = 2.86531123750421e-26 - series_phi_d_right,
      series_phi_d_lo1 = series_phi_d_left_rest - series_phi_d_right_rest,
      series_phi_d_lo2 = series_phi_d_lo1 - 2.3296034284323186e-42,
      series_phi_d_lo = series_phi_d_lo2 + series_phi_c_cross,
      series_phi_e = KSL_MUL(y, series_phi_d), series_phi_e_cross1 = KSL_MUL(y_lo, series_phi_d),
      series_phi_e_cross2 = KSL_MUL(y, series_phi_d_lo),
      series_phi_e_cross = series_phi_e_cross1 + series_phi_e_cross2,
      series_phi_f = series_phi_e + 1.701994875077501e-23,
      series_phi_f_right = series_phi_f - series_phi_e,
      series_phi_f_left = series_phi_f - series_phi_f_right,
      series_phi_f_left_rest = ksl_product_rest(y, series_phi_d, series_phi_e, series_phi_f_left),
      series_phi_f_right_rest = 1.701994875077501e-23 - series_phi_f_right,
      series_phi_f_lo1 = series_phi_f_left_rest + series_phi_f_right_rest,
      series_phi_f_lo2 = series_phi_f_lo1 + 3.161967936521494e-40,
      series_phi_f_lo = series_phi_f_lo2 + series_phi_e_cross,
      series_phi_g = KSL_MUL(y, series_phi_f), series_phi_g_cross1 = KSL_MUL(y_lo, series_phi_f),
      series_phi_g_cross2 = KSL_MUL(y, series_phi_f_lo),
      series_phi_g_cross = series_phi_g_cross1 + series_phi_g_cross2,
      series_phi_h = series_phi_g - 8.509974375387505e-21,
      series_phi_h_right = series_phi_g - series_phi_h,
      series_phi_h_left = series_phi_h + series_phi_h_right,
      series_phi_h_left_rest = ksl_product_rest(y, series_phi_f, series_phi_g, series_phi_h_left),
      series_phi_h_right_rest = 8.509974375387505e-21 - series_phi_h_right,
      series_phi_h_lo1 = series_phi_h_left_rest - series_phi_h_right_rest,
      series_phi_h_lo2 = series_phi_h_lo1 - 3.2266760594119493e-37,
      series_phi_h_lo = series_phi_h_lo2 + series_phi_g_cross,
      series_phi_i = KSL_MUL(y, series_phi_h), series_phi_i_cross1 = KSL_MUL(y_lo, series_phi_h),
      series_phi_i_cross2 = KSL_MUL(y, series_phi_h_lo),
      series_phi_i_cross = series_phi_i_cross1 + series_phi_i_cross2,
      series_phi_j = series_phi_i + 3.523129391410427e-18,
      series_phi_j_right = series_phi_j - series_phi_i,
      series_phi_j_left = series_phi_j - series_phi_j_right,
      series_phi_j_left_rest = ksl_product_rest(y, series_phi_h, series_phi_i, series_phi_j_left),
      series_phi_j_right_rest = 3.523129391410427e-18 - series_phi_j_right,
      series_phi_j_lo1 = series_phi_j_left_rest + series_phi_j_right_rest,
      series_phi_j_lo2 = series_phi_j_lo1 + -1.2521244741738012e-34,
      series_phi_j_lo = series_phi_j_lo2 + series_phi_i_cross,
      series_phi_k = KSL_MUL(y, series_phi_j), series_phi_k_cross1 = KSL_MUL(y_lo, series_phi_j),
      series_phi_k_cross2 = KSL_MUL(y, series_phi_j_lo),
      series_phi_k_cross = series_phi_k_cross1 + series_phi_k_cross2,
      series_phi_l = series_phi_k - 1.1837714755139035e-15,
      series_phi_l_right = series_phi_k - series_phi_l,
      series_phi_l_left = series_phi_l + series_phi_l_right,
      series_phi_l_left_rest = ksl_product_rest(y, series_phi_j, series_phi_k, series_phi_l_left),
      series_phi_l_right_rest = 1.1837714755139035e-15 - series_phi_l_right,
      series_phi_l_lo1 = series_phi_l_left_rest - series_phi_l_right_rest,
      series_phi_l_lo2 = series_phi_l_lo1 - 7.23242424407352e-33,
      series_phi_l_lo = series_phi_l_lo2 + series_phi_k_cross,
      series_phi_m = KSL_MUL(y, series_phi_l), series_phi_m_cross1 = KSL_MUL(y_lo, series_phi_l),
      series_phi_m_cross2 = KSL_MUL(y, series_phi_l_lo),
      series_phi_m_cross = series_phi_m_cross1 + series_phi_m_cross2,
      series_phi_n = series_phi_m + 3.148832124866983e-13,
      series_phi_n_right = series_phi_n - series_phi_m,
      series_phi_n_left = series_phi_n - series_phi_n_right,
      series_phi_n_left_rest = ksl_product_rest(y, series_phi_l, series_phi_m, series_phi_n_left),
      series_phi_n_right_rest = 3.148832124866983e-13 - series_phi_n_right,
      series_phi_n_lo1 = series_phi_n_left_rest + series_phi_n_right_rest,
      series_phi_n_lo2 = series_phi_n_lo1 + 5.8681293750286156e-30,
      series_phi_n_lo = series_phi_n_lo2 + series_phi_m_cross,
      series_phi_o = KSL_MUL(y, series_phi_n), series_phi_o_cross1 = KSL_MUL(y_lo, series_phi_n),
      series_phi_o_cross2 = KSL_MUL(y, series_phi_n_lo),
      series_phi_o_cross = series_phi_o_cross1 + series_phi_o_cross2,
      series_phi_p = series_phi_o - 6.423617534728645e-11,
      series_phi_p_right = series_phi_o - series_phi_p,
      series_phi_p_left = series_phi_p + series_phi_p_right,
      series_phi_p_left_rest = ksl_product_rest(y, series_phi_n, series_phi_o, series_phi_p_left),
      series_phi_p_right_rest = 6.423617534728645e-11 - series_phi_p_right,
      series_phi_p_lo1 = series_phi_p_left_rest - series_phi_p_right_rest,
      series_phi_p_lo2 = series_phi_p_lo1 - 5.034117835500839e-27,
      series_phi_p_lo = series_phi_p_lo2 + series_phi_o_cross,
      series_phi_q = KSL_MUL(y, series_phi_p), series_phi_q_cross1 = KSL_MUL(y_lo, series_phi_p),
      series_phi_q_cross2 = KSL_MUL(y, series_phi_p_lo),
      series_phi_q_cross = series_phi_q_cross1 + series_phi_q_cross2,
      series_phi_r = series_phi_q + 9.635426302092969e-09,
      series_phi_r_right = series_phi_r - series_phi_q,
      series_phi_r_left = series_phi_r - series_phi_r_right,
      series_phi_r_left_rest = ksl_product_rest(y, series_phi_p, series_phi_q, series_phi_r_left),
      series_phi_r_right_rest = 9.635426302092969e-09 - series_phi_r_right,
      series_phi_r_lo1 = series_phi_r_left_rest + series_phi_r_right_rest,
      series_phi_r_lo2 = series_phi_r_lo1 + -1.7546051379703029e-25,
      series_phi_r_lo = series_phi_r_lo2 + series_phi_q_cross,
      series_phi_s = KSL_MUL(y, series_phi_r), series_phi_s_cross1 = KSL_MUL(y_lo, series_phi_r),
      series_phi_s_cross2 = KSL_MUL(y, series_phi_r_lo),
      series_phi_s_cross = series_phi_s_cross1 + series_phi_s_cross2,
      series_phi_t = series_phi_s - 1.0020843354176687e-06,
      series_phi_t_right = series_phi_s - series_phi_t,
      series_phi_t_left = series_phi_t + series_phi_t_right,
      series_phi_t_left_rest = ksl_product_rest(y, series_phi_r, series_phi_s, series_phi_t_left),
      series_phi_t_right_rest = 1.0020843354176687e-06 - series_phi_t_right,
      series_phi_t_lo1 = series_phi_t_left_rest - series_phi_t_right_rest,
      series_phi_t_lo2 = series_phi_t_lo1 - 4.7926555569351065e-23,
      series_phi_t_lo = series_phi_t_lo2 + series_phi_s_cross,
      series_phi_u = KSL_MUL(y, series_phi_t), series_phi_u_cross1 = KSL_MUL(y_lo, series_phi_t),
      series_phi_u_cross2 = KSL_MUL(y, series_phi_t_lo),
      series_phi_u_cross = series_phi_u_cross1 + series_phi_u_cross2,
      series_phi_v = series_phi_u + 6.613756613756614e-05,
      series_phi_v_right = series_phi_v - series_phi_u,
      series_phi_v_left = series_phi_v - series_phi_v_right,
      series_phi_v_left_rest = ksl_product_rest(y, series_phi_t, series_phi_u, series_phi_v_left),
      series_phi_v_right_rest = 6.613756613756614e-05 - series_phi_v_right,
      series_phi_v_lo1 = series_phi_v_left_rest + series_phi_v_right_rest,
      series_phi_v_lo2 = series_phi_v_lo1 + -4.460143857711533e-21,
      series_phi_v_lo = series_phi_v_lo2 + series_phi_u_cross,
      series_phi_w = KSL_MUL(y, series_phi_v), series_phi_w_cross1 = KSL_MUL(y_lo, series_phi_v),
      series_phi_w_cross2 = KSL_MUL(y, series_phi_v_lo),
      series_phi_w_cross = series_phi_w_cross1 + series_phi_w_cross2,
      series_phi_x = series_phi_w - 0.002380952380952381,
      series_phi_x_right = series_phi_w - series_phi_x,
      series_phi_x_left = series_phi_x + series_phi_x_right,
      series_phi_x_left_rest = ksl_product_rest(y, series_phi_v, series_phi_w, series_phi_x_left),
      series_phi_x_right_rest = 0.002380952380952381 - series_phi_x_right,
      series_phi_x_lo1 = series_phi_x_left_rest - series_phi_x_right_rest,
      series_phi_x_lo2 = series_phi_x_lo1 - -2.147752875018904e-19,
      series_phi_x_lo = series_phi_x_lo2 + series_phi_w_cross,
      series_phi_y = KSL_MUL(y, series_phi_x), series_phi_y_cross1 = KSL_MUL(y_lo, series_phi_x),
      series_phi_y_cross2 = KSL_MUL(y, series_phi_x_lo),
      series_phi_y_cross = series_phi_y_cross1 + series_phi_y_cross2,
      series_phi = series_phi_y + 0.03333333333333333, series_phi_right = series_phi - series_phi_y,
      series_phi_left = series_phi - series_phi_right,
      series_phi_left_rest = ksl_product_rest(y, series_phi_x, series_phi_y, series_phi_left),
      series_phi_right_rest = 0.03333333333333333 - series_phi_right,
      series_phi_lo1 = series_phi_left_rest + series_phi_right_rest,
      series_phi_lo2 = series_phi_lo1 + 4.625929269271486e-19,
      series_phi_lo = series_phi_lo2 + series_phi_y_cross;
  const double f_more_a = KSL_MUL(2.0, y), f_more_a_cross2 = KSL_MUL(2.0, y_lo),
      f_more = KSL_MUL(f_more_a, series_phi), f_more_cross1 = KSL_MUL(f_more_a_cross2, series_phi),
      f_more_cross2 = KSL_MUL(f_more_a, series_phi_lo),
      f_more_cross = f_more_cross1 + f_more_cross2;
  const double near_f_a = KSL_MUL(0.3333333333333333, sinc),
      near_f_a_cross1 = KSL_MUL(1.850371707708594e-17, sinc),
      near_f_a_cross2 = KSL_MUL(0.3333333333333333, sinc_lo),
      near_f_a_cross = near_f_a_cross1 + near_f_a_cross2,
      f_more_error = ksl_product_error(f_more_a, series_phi, f_more),
      f_more_lo = f_more_error + f_more_cross, near_f_b = KSL_MUL(0.3333333333333333, f_more),
      near_f_b_cross1 = KSL_MUL(1.850371707708594e-17, f_more),
      near_f_b_cross2 = KSL_MUL(0.3333333333333333, f_more_lo),
      near_f_b_cross = near_f_b_cross1 + near_f_b_cross2, near_f = near_f_a + near_f_b,
      near_f_right = near_f - near_f_a, near_f_left = near_f - near_f_right,
      near_f_left_rest = ksl_product_rest(0.3333333333333333, sinc, near_f_a, near_f_left),
      near_f_right_rest = ksl_product_rest(0.3333333333333333, f_more, near_f_b, near_f_right),
      near_f_cross = near_f_a_cross + near_f_b_cross,
      near_f_lo1 = near_f_left_rest + near_f_right_rest, near_f_lo = near_f_lo1 + near_f_cross;
  const double f_rest = sinc - c, f_rest_right = sinc - f_rest, f_rest_left = f_rest + f_rest_right,
      f_rest_left_rest = sinc - f_rest_left, f_rest_right_rest = c - f_rest_right,
      f_rest_lo1 = f_rest_left_rest - f_rest_right_rest, f_rest_lo2 = f_rest_lo1 - c_lo,
      f_rest_lo = f_rest_lo2 + sinc_lo;
  const double x = KSL_MUL(4.0, y), x_cross2 = KSL_MUL(4.0, y_lo);
  const double far_y_a_of_x = x + x_cross2, far_y = far_y_a_of_x < 4.0 ? 1.0 : y,
      far_y_lo = far_y_a_of_x < 4.0 ? 0.0 : y_lo;
  const double closed_f_of_f_rest = f_rest + f_rest_lo,
      closed_f_of_f_rest_right = closed_f_of_f_rest - f_rest,
      closed_f_of_f_rest_left = closed_f_of_f_rest - closed_f_of_f_rest_right,
      closed_f_of_f_rest_left_rest = f_rest - closed_f_of_f_rest_left,
      closed_f_of_f_rest_right_rest = f_rest_lo - closed_f_of_f_rest_right,
      closed_f_of_f_rest_lo = closed_f_of_f_rest_left_rest + closed_f_of_f_rest_right_rest,
      closed_f_of_far_y = far_y + far_y_lo, closed_f_of_far_y_right = closed_f_of_far_y - far_y,
      closed_f_of_far_y_left = closed_f_of_far_y - closed_f_of_far_y_right,
      closed_f_of_far_y_left_rest = far_y - closed_f_of_far_y_left,
      closed_f_of_far_y_right_rest = far_y_lo - closed_f_of_far_y_right,
      closed_f_of_far_y_lo = closed_f_of_far_y_left_rest + closed_f_of_far_y_right_rest,
      closed_f = closed_f_of_f_rest / closed_f_of_far_y,
      closed_f_product = KSL_MUL(closed_f, closed_f_of_far_y),
      closed_f_product_error = ksl_product_error(closed_f, closed_f_of_far_y, closed_f_product),
      closed_f_rest = closed_f_of_f_rest - closed_f_product,
      closed_f_exact = closed_f_rest - closed_f_product_error,
      closed_f_numerator = closed_f_exact + closed_f_of_f_rest_lo,
      closed_f_cross = KSL_MUL(closed_f, closed_f_of_far_y_lo),
      closed_f_residual = closed_f_numerator - closed_f_cross,
      closed_f_lo = closed_f_residual / closed_f_of_far_y;
  const double f = far_y_a_of_x < 4.0 ? near_f : closed_f,
      f_lo = far_y_a_of_x < 4.0 ? near_f_lo : closed_f_lo;
  const double four_k = KSL_MUL(4.0, sinc), four_k_cross2 = KSL_MUL(4.0, sinc_lo);
  const double b_of_f = f + f_lo, b_of_f_right = b_of_f - f, b_of_f_left = b_of_f - b_of_f_right,
      b_of_f_left_rest = f - b_of_f_left, b_of_f_right_rest = f_lo - b_of_f_right,
      b_of_f_lo = b_of_f_left_rest + b_of_f_right_rest, b_of_four_k = four_k + four_k_cross2,
      b_of_four_k_right = b_of_four_k - four_k, b_of_four_k_left = b_of_four_k - b_of_four_k_right,
      b_of_four_k_left_rest = four_k - b_of_four_k_left,
      b_of_four_k_right_rest = four_k_cross2 - b_of_four_k_right,
      b_of_four_k_lo = b_of_four_k_left_rest + b_of_four_k_right_rest, b = b_of_f / b_of_four_k,
      b_product = KSL_MUL(b, b_of_four_k),
      b_product_error = ksl_product_error(b, b_of_four_k, b_product), b_rest = b_of_f - b_product,
      b_exact = b_rest - b_product_error, b_numerator = b_exact + b_of_f_lo,
      b_cross = KSL_MUL(b, b_of_four_k_lo), b_residual = b_numerator - b_cross,
      b_lo = b_residual / b_of_four_k;
  const double b_across_of_c = c + c_lo, b_across_of_c_right = b_across_of_c - c,
      b_across_of_c_left = b_across_of_c - b_across_of_c_right,
      b_across_of_c_left_rest = c - b_across_of_c_left,
      b_across_of_c_right_rest = c_lo - b_across_of_c_right,
      b_across_of_c_lo = b_across_of_c_left_rest + b_across_of_c_right_rest,
      b_across_of_sinc = sinc + sinc_lo, b_across_of_sinc_right = b_across_of_sinc - sinc,
      b_across_of_sinc_left = b_across_of_sinc - b_across_of_sinc_right,
      b_across_of_sinc_left_rest = sinc - b_across_of_sinc_left,
      b_across_of_sinc_right_rest = sinc_lo - b_across_of_sinc_right,
      b_across_of_sinc_lo = b_across_of_sinc_left_rest + b_across_of_sinc_right_rest,
      b_across = b_across_of_c / b_across_of_sinc,
      b_across_product = KSL_MUL(b_across, b_across_of_sinc),
      b_across_product_error = ksl_product_error(b_across, b_across_of_sinc, b_across_product),
      b_across_rest = b_across_of_c - b_across_product,
      b_across_exact = b_across_rest - b_across_product_error,
      b_across_numerator = b_across_exact + b_across_of_c_lo,
      b_across_cross = KSL_MUL(b_across, b_across_of_sinc_lo),
      b_across_residual = b_across_numerator - b_across_cross,
      b_across_lo = b_across_residual / b_across_of_sinc;
  const double vector_0_error = ksl_product_error(v_s_size_0_of_upper_0, k, vector_0),
      vector_0_lo = vector_0_error + vector_0_cross, wt_a = KSL_MUL(D->m03, vector_0),
      wt_a_cross2 = KSL_MUL(D->m03, vector_0_lo),
      vector_1_error = ksl_product_error(v_s_size_1_of_upper_1, k, vector_1),
      vector_1_lo = vector_1_error + vector_1_cross, wt_b = KSL_MUL(D->m13, vector_1),
      wt_b_cross2 = KSL_MUL(D->m13, vector_1_lo), wt_c = wt_a + wt_b, wt_c_right = wt_c - wt_a,
      wt_c_left = wt_c - wt_c_right,
      wt_c_left_rest = ksl_product_rest(D->m03, vector_0, wt_a, wt_c_left),
      wt_c_right_rest = ksl_product_rest(D->m13, vector_1, wt_b, wt_c_right),
      wt_c_cross = wt_a_cross2 + wt_b_cross2, wt_c_lo1 = wt_c_left_rest + wt_c_right_rest,
      wt_c_lo = wt_c_lo1 + wt_c_cross,
      vector_2_error = ksl_product_error(v_s_size_2_of_upper_2, k, vector_2),
      vector_2_lo = vector_2_error + vector_2_cross, wt_d = KSL_MUL(D->m23, vector_2),
      wt_d_cross2 = KSL_MUL(D->m23, vector_2_lo), wt = wt_c + wt_d, wt_right = wt - wt_c,
      wt_left = wt - wt_right, wt_left_rest = wt_c - wt_left,
      wt_right_rest = ksl_product_rest(D->m23, vector_2, wt_d, wt_right),
      wt_lo1 = wt_left_rest + wt_right_rest, wt_lo2 = wt_lo1 + wt_d_cross2,
      wt_lo = wt_lo2 + wt_c_lo;
  const double pitch = KSL_MUL(b, wt), pitch_cross1 = KSL_MUL(b_lo, wt),
      pitch_cross2 = KSL_MUL(b, wt_lo), pitch_cross = pitch_cross1 + pitch_cross2;
  const double pitch_error = ksl_product_error(b, wt, pitch), pitch_lo = pitch_error + pitch_cross,
      along_0 = KSL_MUL(vector_0, pitch), along_0_cross1 = KSL_MUL(vector_0_lo, pitch),
      along_0_cross2 = KSL_MUL(vector_0, pitch_lo), along_0_cross = along_0_cross1 + along_0_cross2;
  const double along_1 = KSL_MUL(vector_1, pitch), along_1_cross1 = KSL_MUL(vector_1_lo, pitch),
      along_1_cross2 = KSL_MUL(vector_1, pitch_lo), along_1_cross = along_1_cross1 + along_1_cross2;
  const double along_2 = KSL_MUL(vector_2, pitch), along_2_cross1 = KSL_MUL(vector_2_lo, pitch),
      along_2_cross2 = KSL_MUL(vector_2, pitch_lo), along_2_cross = along_2_cross1 + along_2_cross2;
  const double u_0a = KSL_MUL(D->m23, vector_1), u_0a_cross2 = KSL_MUL(D->m23, vector_1_lo),
      u_0b = KSL_MUL(D->m13, vector_2), u_0b_cross2 = KSL_MUL(D->m13, vector_2_lo),
      u_0 = u_0a - u_0b, u_0_right = u_0a - u_0, u_0_left = u_0 + u_0_right,
      u_0_left_rest = ksl_product_rest(D->m23, vector_1, u_0a, u_0_left),
      u_0_right_rest = ksl_product_rest(D->m13, vector_2, u_0b, u_0_right),
      u_0_cross = u_0a_cross2 - u_0b_cross2, u_0_lo1 = u_0_left_rest - u_0_right_rest,
      u_0_lo = u_0_lo1 + u_0_cross;
  const double u_1a = KSL_MUL(D->m03, vector_2), u_1a_cross2 = KSL_MUL(D->m03, vector_2_lo),
      u_1b = KSL_MUL(D->m23, vector_0), u_1b_cross2 = KSL_MUL(D->m23, vector_0_lo),
      u_1 = u_1a - u_1b, u_1_right = u_1a - u_1, u_1_left = u_1 + u_1_right,
      u_1_left_rest = ksl_product_rest(D->m03, vector_2, u_1a, u_1_left),
      u_1_right_rest = ksl_product_rest(D->m23, vector_0, u_1b, u_1_right),
      u_1_cross = u_1a_cross2 - u_1b_cross2, u_1_lo1 = u_1_left_rest - u_1_right_rest,
      u_1_lo = u_1_lo1 + u_1_cross;
  const double u_2a = KSL_MUL(D->m13, vector_0), u_2a_cross2 = KSL_MUL(D->m13, vector_0_lo),
      u_2b = KSL_MUL(D->m03, vector_1), u_2b_cross2 = KSL_MUL(D->m03, vector_1_lo),
      u_2 = u_2a - u_2b, u_2_right = u_2a - u_2, u_2_left = u_2 + u_2_right,
      u_2_left_rest = ksl_product_rest(D->m13, vector_0, u_2a, u_2_left),
      u_2_right_rest = ksl_product_rest(D->m03, vector_1, u_2b, u_2_right),
      u_2_cross = u_2a_cross2 - u_2b_cross2, u_2_lo1 = u_2_left_rest - u_2_right_rest,
      u_2_lo = u_2_lo1 + u_2_cross;
  const double turned_0 = KSL_MUL(0.5, u_0), turned_0_cross2 = KSL_MUL(0.5, u_0_lo);
  const double turned_1 = KSL_MUL(0.5, u_1), turned_1_cross2 = KSL_MUL(0.5, u_1_lo);
  const double turned_2 = KSL_MUL(0.5, u_2), turned_2_cross2 = KSL_MUL(0.5, u_2_lo);
  const double across_axis_0 = along_0 - turned_0, across_axis_0_right = along_0 - across_axis_0,
      across_axis_0_left = across_axis_0 + across_axis_0_right,
      across_axis_0_left_rest = ksl_product_rest(vector_0, pitch, along_0, across_axis_0_left),
      across_axis_0_right_rest = turned_0 - across_axis_0_right,
      across_axis_0_lo1 = across_axis_0_left_rest - across_axis_0_right_rest,
      across_axis_0_lo2 = across_axis_0_lo1 - turned_0_cross2,
      across_axis_0_lo = across_axis_0_lo2 + along_0_cross;
  const double across_axis_1 = along_1 - turned_1, across_axis_1_right = along_1 - across_axis_1,
      across_axis_1_left = across_axis_1 + across_axis_1_right,
      across_axis_1_left_rest = ksl_product_rest(vector_1, pitch, along_1, across_axis_1_left),
      across_axis_1_right_rest = turned_1 - across_axis_1_right,
      across_axis_1_lo1 = across_axis_1_left_rest - across_axis_1_right_rest,
      across_axis_1_lo2 = across_axis_1_lo1 - turned_1_cross2,
      across_axis_1_lo = across_axis_1_lo2 + along_1_cross;
  const double across_axis_2 = along_2 - turned_2, across_axis_2_right = along_2 - across_axis_2,
      across_axis_2_left = across_axis_2 + across_axis_2_right,
      across_axis_2_left_rest = ksl_product_rest(vector_2, pitch, along_2, across_axis_2_left),
      across_axis_2_right_rest = turned_2 - across_axis_2_right,
      across_axis_2_lo1 = across_axis_2_left_rest - across_axis_2_right_rest,
      across_axis_2_lo2 = across_axis_2_lo1 - turned_2_cross2,
      across_axis_2_lo = across_axis_2_lo2 + along_2_cross;
  const double so_0a = KSL_MUL(D->m03, b_across), so_0a_cross2 = KSL_MUL(D->m03, b_across_lo),
      so_0 = so_0a + across_axis_0, so_0_right = so_0 - so_0a, so_0_left = so_0 - so_0_right,
      so_0_left_rest = ksl_product_rest(D->m03, b_across, so_0a, so_0_left),
      so_0_right_rest = across_axis_0 - so_0_right, so_0_lo1 = so_0_left_rest + so_0_right_rest,
      so_0_lo2 = so_0_lo1 + across_axis_0_lo, so_0_lo = so_0_lo2 + so_0a_cross2;
  const double so_1a = KSL_MUL(D->m13, b_across), so_1a_cross2 = KSL_MUL(D->m13, b_across_lo),
      so_1 = so_1a + across_axis_1, so_1_right = so_1 - so_1a, so_1_left = so_1 - so_1_right,
      so_1_left_rest = ksl_product_rest(D->m13, b_across, so_1a, so_1_left),
      so_1_right_rest = across_axis_1 - so_1_right, so_1_lo1 = so_1_left_rest + so_1_right_rest,
      so_1_lo2 = so_1_lo1 + across_axis_1_lo, so_1_lo = so_1_lo2 + so_1a_cross2;
  const double so_2a = KSL_MUL(D->m23, b_across), so_2a_cross2 = KSL_MUL(D->m23, b_across_lo),
      so_2 = so_2a + across_axis_2, so_2_right = so_2 - so_2a, so_2_left = so_2 - so_2_right,
      so_2_left_rest = ksl_product_rest(D->m23, b_across, so_2a, so_2_left),
      so_2_right_rest = across_axis_2 - so_2_right, so_2_lo1 = so_2_left_rest + so_2_right_rest,
      so_2_lo2 = so_2_lo1 + across_axis_2_lo, so_2_lo = so_2_lo2 + so_2a_cross2;
  const double so_0_rounded = so_0 + so_0_lo,
      so_0_final = so_0_rounded == so_0_rounded ? so_0_rounded : so_0;
  const double so_1_rounded = so_1 + so_1_lo,
      so_1_final = so_1_rounded == so_1_rounded ? so_1_rounded : so_1;
  const double so_2_rounded = so_2 + so_2_lo,
      so_2_final = so_2_rounded == so_2_rounded ? so_2_rounded : so_2;
  const double vector_0_rounded = vector_0 + vector_0_lo,
      vector_0_final = vector_0_rounded == vector_0_rounded ? vector_0_rounded : vector_0;
  const double vector_1_rounded = vector_1 + vector_1_lo,
      vector_1_final = vector_1_rounded == vector_1_rounded ? vector_1_rounded : vector_1;
  const double vector_2_rounded = vector_2 + vector_2_lo,
      vector_2_final = vector_2_rounded == vector_2_rounded ? vector_2_rounded : vector_2;
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
  const double halved_0 = KSL_MUL(0.5, s->m3);
  const double halved_1 = KSL_MUL(0.5, s->m4);
  const double halved_2 = KSL_MUL(0.5, s->m5);
  const double y_a = KSL_MUL(halved_0, halved_0), y_b = KSL_MUL(halved_1, halved_1),
      y_c = y_a + y_b, y_c_right = y_c - y_a, y_c_left = y_c - y_c_right,
      y_c_left_rest = ksl_product_rest(halved_0, halved_0, y_a, y_c_left),
      y_c_right_rest = ksl_product_rest(halved_1, halved_1, y_b, y_c_right),
      y_c_lo = y_c_left_rest + y_c_right_rest, y_d = KSL_MUL(halved_2, halved_2), y = y_c + y_d,
      y_right = y - y_c, y_left = y - y_right, y_left_rest = y_c - y_left,
      y_right_rest = ksl_product_rest(halved_2, halved_2, y_d, y_right),
      y_lo1 = y_left_rest + y_right_rest, y_lo = y_lo1 + y_c_lo;
  const double half_angle_of_y = y + y_lo, half_angle_of_y_right = half_angle_of_y - y,
      half_angle_of_y_left = half_angle_of_y - half_angle_of_y_right,
      half_angle_of_y_left_rest = y - half_angle_of_y_left,
      half_angle_of_y_right_rest = y_lo - half_angle_of_y_right,
      half_angle_of_y_lo = half_angle_of_y_left_rest + half_angle_of_y_right_rest,
      half_angle = sqrt(half_angle_of_y), half_angle_product = KSL_MUL(half_angle, half_angle),
      half_angle_product_error = ksl_product_error(half_angle, half_angle, half_angle_product),
      half_angle_rest = half_angle_of_y - half_angle_product,
      half_angle_exact = half_angle_rest - half_angle_product_error,
      half_angle_residual = half_angle_exact + half_angle_of_y_lo,
      half_angle_twice = half_angle + half_angle,
      half_angle_divisor = half_angle == 0.0 ? 1.0 : half_angle_twice,
      half_angle_lo = half_angle_residual / half_angle_divisor;
  const double sine_of_half_angle = half_angle + half_angle_lo,
      sine_of_half_angle_right = sine_of_half_angle - half_angle,
      sine_of_half_angle_left = sine_of_half_angle - sine_of_half_angle_right,
      sine_of_half_angle_left_rest = half_angle - sine_of_half_angle_left,
      sine_of_half_angle_right_rest = half_angle_lo - sine_of_half_angle_right,
      sine_of_half_angle_lo = sine_of_half_angle_left_rest + sine_of_half_angle_right_rest;
  double c; const double sine = ksl_sincos(sine_of_half_angle, &c);
  double c_own_error; const double sine_own_error = ksl_sincos_error(sine_of_half_angle, sine, c,
      &c_own_error);
  const double sine_half = KSL_MUL(sine_of_half_angle_lo, 0.5);
  double sine_half_cos; const double sine_half_sin = ksl_sincos(sine_half, &sine_half_cos);
  const double sine_twice = sine_half_sin + sine_half_sin, sine_slope1 = KSL_MUL(sine_half_cos, c),
      sine_slope2 = KSL_MUL(sine_half_sin, sine), sine_slope = sine_slope1 - sine_slope2,
      sine_more = KSL_MUL(sine_slope, sine_twice), sine_lo = sine_own_error + sine_more;
  const double c_slope1 = KSL_MUL(sine_half_cos, sine), c_slope2 = KSL_MUL(sine_half_sin, c),
      c_slope = c_slope1 + c_slope2, c_more = KSL_MUL(c_slope, sine_twice),
      c_lo = c_own_error - c_more;
  const double sinc_divisor = sine_of_half_angle < 1.4901161193847656e-08 ? 1.4901161193847656e-08 :
      sine_of_half_angle,
      sinc_divisor_lo = sine_of_half_angle < 1.4901161193847656e-08 ? 0.0 : sine_of_half_angle_lo;
  const double sinc_quotient_of_sine = sine + sine_lo,
      sinc_quotient_of_sine_right = sinc_quotient_of_sine - sine,
      sinc_quotient_of_sine_left = sinc_quotient_of_sine - sinc_quotient_of_sine_right,
      sinc_quotient_of_sine_left_rest = sine - sinc_quotient_of_sine_left,
      sinc_quotient_of_sine_right_rest = sine_lo - sinc_quotient_of_sine_right,
      sinc_quotient_of_sine_lo = sinc_quotient_of_sine_left_rest + sinc_quotient_of_sine_right_rest,
      sinc_quotient_of_sinc_divisor = sinc_divisor + sinc_divisor_lo,
      sinc_quotient_of_sinc_divisor_right = sinc_quotient_of_sinc_divisor - sinc_divisor,
      sinc_quotient_of_sinc_divisor_left = sinc_quotient_of_sinc_divisor -
          sinc_quotient_of_sinc_divisor_right,
      sinc_quotient_of_sinc_divisor_left_rest = sinc_divisor - sinc_quotient_of_sinc_divisor_left,
      sinc_quotient_of_sinc_divisor_right_rest = sinc_divisor_lo -
          sinc_quotient_of_sinc_divisor_right,
      sinc_quotient_of_sinc_divisor_lo = sinc_quotient_of_sinc_divisor_left_rest +
          sinc_quotient_of_sinc_divisor_right_rest,
      sinc_quotient = sinc_quotient_of_sine / sinc_quotient_of_sinc_divisor,
      sinc_quotient_product = KSL_MUL(sinc_quotient, sinc_quotient_of_sinc_divisor),
      sinc_quotient_product_error = ksl_product_error(sinc_quotient, sinc_quotient_of_sinc_divisor,
          sinc_quotient_product),
      sinc_quotient_rest = sinc_quotient_of_sine - sinc_quotient_product,
      sinc_quotient_exact = sinc_quotient_rest - sinc_quotient_product_error,
      sinc_quotient_numerator = sinc_quotient_exact + sinc_quotient_of_sine_lo,
      sinc_quotient_cross = KSL_MUL(sinc_quotient, sinc_quotient_of_sinc_divisor_lo),
      sinc_quotient_residual = sinc_quotient_numerator - sinc_quotient_cross,
      sinc_quotient_lo = sinc_quotient_residual / sinc_quotient_of_sinc_divisor;
  const double sinc_a = KSL_MUL(0.16666666666666666, half_angle_of_y),
      sinc_a_cross1 = KSL_MUL(9.25185853854297e-18, half_angle_of_y),
      sinc_a_cross2 = KSL_MUL(0.16666666666666666, half_angle_of_y_lo),
      sinc_a_cross = sinc_a_cross1 + sinc_a_cross2, sinc_b = 1.0 - sinc_a,
      sinc_b_right = 1.0 - sinc_b, sinc_b_left = sinc_b + sinc_b_right,
      sinc_b_left_rest = 1.0 - sinc_b_left,
      sinc_b_right_rest = ksl_product_rest(0.16666666666666666, half_angle_of_y, sinc_a,
          sinc_b_right),
      sinc_b_lo1 = sinc_b_left_rest - sinc_b_right_rest, sinc_b_lo = sinc_b_lo1 - sinc_a_cross,
      sinc = sine_of_half_angle < 1.4901161193847656e-08 ? sinc_b : sinc_quotient,
      sinc_lo = sine_of_half_angle < 1.4901161193847656e-08 ? sinc_b_lo : sinc_quotient_lo;
  const double g1 = KSL_MUL(c, sinc), g1_cross1 = KSL_MUL(c_lo, sinc),
      g1_cross2 = KSL_MUL(c, sinc_lo), g1_cross = g1_cross1 + g1_cross2;
  const double g2a = KSL_MUL(sinc, sinc), g2a_cross1 = KSL_MUL(sinc_lo, sinc),
      g2a_cross2 = KSL_MUL(sinc, sinc_lo), g2a_cross = g2a_cross1 + g2a_cross2,
      g2a_error = ksl_product_error(sinc, sinc, g2a), g2a_lo = g2a_error + g2a_cross,
      g2 = KSL_MUL(0.5, g2a), g2_cross2 = KSL_MUL(0.5, g2a_lo);
  const double rest3 = 1.0 - g1, rest3_right = 1.0 - rest3, rest3_left = rest3 + rest3_right,
      rest3_left_rest = 1.0 - rest3_left,
      rest3_right_rest = ksl_product_rest(c, sinc, g1, rest3_right),
      rest3_lo1 = rest3_left_rest - rest3_right_rest, rest3_lo = rest3_lo1 - g1_cross;
  const double x = KSL_MUL(4.0, half_angle_of_y), x_cross2 = KSL_MUL(4.0, half_angle_of_y_lo);
  const double far_x_a_of_x = x + x_cross2, far_x_a_of_x_right = far_x_a_of_x - x,
      far_x_a_of_x_left = far_x_a_of_x - far_x_a_of_x_right,
      far_x_a_of_x_left_rest = x - far_x_a_of_x_left,
      far_x_a_of_x_right_rest = x_cross2 - far_x_a_of_x_right,
      far_x_a_of_x_lo = far_x_a_of_x_left_rest + far_x_a_of_x_right_rest,
      far_x = far_x_a_of_x < 1.0 ? 1.0 : far_x_a_of_x,
      far_x_lo = far_x_a_of_x < 1.0 ? 0.0 : far_x_a_of_x_lo;
  const double closed3_of_rest3 = rest3 + rest3_lo,
      closed3_of_rest3_right = closed3_of_rest3 - rest3,
      closed3_of_rest3_left = closed3_of_rest3 - closed3_of_rest3_right,
      closed3_of_rest3_left_rest = rest3 - closed3_of_rest3_left,
      closed3_of_rest3_right_rest = rest3_lo - closed3_of_rest3_right,
      closed3_of_rest3_lo = closed3_of_rest3_left_rest + closed3_of_rest3_right_rest,
      closed3_of_far_x = far_x + far_x_lo, closed3_of_far_x_right = closed3_of_far_x - far_x,
      closed3_of_far_x_left = closed3_of_far_x - closed3_of_far_x_right,
      closed3_of_far_x_left_rest = far_x - closed3_of_far_x_left,
      closed3_of_far_x_right_rest = far_x_lo - closed3_of_far_x_right,
      closed3_of_far_x_lo = closed3_of_far_x_left_rest + closed3_of_far_x_right_rest,
      closed3 = closed3_of_rest3 / closed3_of_far_x,
      closed3_product = KSL_MUL(closed3, closed3_of_far_x),
      closed3_product_error = ksl_product_error(closed3, closed3_of_far_x, closed3_product),
      closed3_rest = closed3_of_rest3 - closed3_product,
      closed3_exact = closed3_rest - closed3_product_error,
      closed3_numerator = closed3_exact + closed3_of_rest3_lo,
      closed3_cross = KSL_MUL(closed3, closed3_of_far_x_lo),
      closed3_residual = closed3_numerator - closed3_cross,
      closed3_lo = closed3_residual / closed3_of_far_x;
  const double series5a = KSL_MUL(1.216125041553518e-34, far_x_a_of_x),
      series5a_cross1 = KSL_MUL(5.586290567888806e-51, far_x_a_of_x),
      series5a_cross2 = KSL_MUL(1.216125041553518e-34, far_x_a_of_x_lo),
      series5a_cross = series5a_cross1 + series5a_cross2,
      series5b = 1.1309962886447716e-31 - series5a,
      series5b_right = 1.1309962886447716e-31 - series5b, series5b_left = series5b + series5b_right,
      series5b_left_rest = 1.1309962886447716e-31 - series5b_left,
      series5b_right_rest = ksl_product_rest(1.216125041553518e-34, far_x_a_of_x, series5a,
          series5b_right),
      series5b_lo1 = series5b_left_rest - series5b_right_rest,
      series5b_lo2 = series5b_lo1 - series5a_cross,
      series5b_lo = series5b_lo2 + 1.0498015412959506e-47,
      series5c = KSL_MUL(far_x_a_of_x, series5b),
      series5c_cross1 = KSL_MUL(far_x_a_of_x_lo, series5b),
      series5c_cross2 = KSL_MUL(far_x_a_of_x, series5b_lo),
      series5c_cross = series5c_cross1 + series5c_cross2,
      series5d = series5c - 9.183689863795546e-29, series5d_right = series5c - series5d,
      series5d_left = series5d + series5d_right,
      series5d_left_rest = ksl_product_rest(far_x_a_of_x, series5b, series5c, series5d_left),
      series5d_right_rest = 9.183689863795546e-29 - series5d_right,
      series5d_lo1 = series5d_left_rest - series5d_right_rest,
      series5d_lo2 = series5d_lo1 - 1.4303150396787322e-45,
      series5d_lo = series5d_lo2 + series5c_cross, series5e = KSL_MUL(far_x_a_of_x, series5d),
      series5e_cross1 = KSL_MUL(far_x_a_of_x_lo, series5d),
      series5e_cross2 = KSL_MUL(far_x_a_of_x, series5d_lo),
      series5e_cross = series5e_cross1 + series5e_cross2,
      series5f = series5e + 6.446950284384474e-26, series5f_right = series5f - series5e,
      series5f_left = series5f - series5f_right,
      series5f_left_rest = ksl_product_rest(far_x_a_of_x, series5d, series5e, series5f_left),
      series5f_right_rest = 6.446950284384474e-26 - series5f_right,
      series5f_lo1 = series5f_left_rest + series5f_right_rest,
      series5f_lo2 = series5f_lo1 + -1.9330404233703465e-42,
      series5f_lo = series5f_lo2 + series5e_cross, series5g = KSL_MUL(far_x_a_of_x, series5f),
      series5g_cross1 = KSL_MUL(far_x_a_of_x_lo, series5f),
      series5g_cross2 = KSL_MUL(far_x_a_of_x, series5f_lo),
      series5g_cross = series5g_cross1 + series5g_cross2,
      series5h = series5g - 3.868170170630684e-23, series5h_right = series5g - series5h,
      series5h_left = series5h + series5h_right,
      series5h_left_rest = ksl_product_rest(far_x_a_of_x, series5f, series5g, series5h_left),
      series5h_right_rest = 3.868170170630684e-23 - series5h_right,
      series5h_lo1 = series5h_left_rest - series5h_right_rest,
      series5h_lo2 = series5h_lo1 - -8.843177655482344e-40,
      series5h_lo = series5h_lo2 + series5g_cross, series5i = KSL_MUL(far_x_a_of_x, series5h),
      series5i_cross1 = KSL_MUL(far_x_a_of_x_lo, series5h),
      series5i_cross2 = KSL_MUL(far_x_a_of_x, series5h_lo),
      series5i_cross = series5i_cross1 + series5i_cross2,
      series5j = series5i + 1.9572941063391263e-20, series5j_right = series5j - series5i,
      series5j_left = series5j - series5j_right,
      series5j_left_rest = ksl_product_rest(far_x_a_of_x, series5h, series5i, series5j_left),
      series5j_right_rest = 1.9572941063391263e-20 - series5j_right,
      series5j_lo1 = series5j_left_rest + series5j_right_rest,
      series5j_lo2 = series5j_lo1 + -1.3643503830087908e-36,
      series5j_lo = series5j_lo2 + series5i_cross, series5k = KSL_MUL(far_x_a_of_x, series5j),
      series5k_cross1 = KSL_MUL(far_x_a_of_x_lo, series5j),
      series5k_cross2 = KSL_MUL(far_x_a_of_x, series5j_lo),
      series5k_cross = series5k_cross1 + series5k_cross2,
      series5l = series5k - 8.22063524662433e-18, series5l_right = series5k - series5l,
      series5l_left = series5l + series5l_right,
      series5l_left_rest = ksl_product_rest(far_x_a_of_x, series5j, series5k, series5l_left),
      series5l_right_rest = 8.22063524662433e-18 - series5l_right,
      series5l_lo1 = series5l_left_rest - series5l_right_rest,
      series5l_lo2 = series5l_lo1 - 2.2141894119604265e-34,
      series5l_lo = series5l_lo2 + series5k_cross, series5m = KSL_MUL(far_x_a_of_x, series5l),
      series5m_cross1 = KSL_MUL(far_x_a_of_x_lo, series5l),
      series5m_cross2 = KSL_MUL(far_x_a_of_x, series5l_lo),
      series5m_cross = series5m_cross1 + series5m_cross2,
      series5n = series5m + 2.8114572543455206e-15, series5n_right = series5n - series5m,
      series5n_left = series5n - series5n_right,
      series5n_left_rest = ksl_product_rest(far_x_a_of_x, series5l, series5m, series5n_left),
      series5n_right_rest = 2.8114572543455206e-15 - series5n_right,
      series5n_lo1 = series5n_left_rest + series5n_right_rest,
      series5n_lo2 = series5n_lo1 + 1.6508842730861433e-31,
      series5n_lo = series5n_lo2 + series5m_cross, series5o = KSL_MUL(far_x_a_of_x, series5n),
      series5o_cross1 = KSL_MUL(far_x_a_of_x_lo, series5n),
      series5o_cross2 = KSL_MUL(far_x_a_of_x, series5n_lo),
      series5o_cross = series5o_cross1 + series5o_cross2,
      series5p = series5o - 7.647163731819816e-13, series5p_right = series5o - series5p,
      series5p_left = series5p + series5p_right,
      series5p_left_rest = ksl_product_rest(far_x_a_of_x, series5n, series5o, series5p_left),
      series5p_right_rest = 7.647163731819816e-13 - series5p_right,
      series5p_lo1 = series5p_left_rest - series5p_right_rest,
      series5p_lo2 = series5p_lo1 - 7.03872877733453e-30,
      series5p_lo = series5p_lo2 + series5o_cross, series5q = KSL_MUL(far_x_a_of_x, series5p),
      series5q_cross1 = KSL_MUL(far_x_a_of_x_lo, series5p),
      series5q_cross2 = KSL_MUL(far_x_a_of_x, series5p_lo),
      series5q_cross = series5q_cross1 + series5q_cross2,
      series5r = series5q + 1.6059043836821613e-10, series5r_right = series5r - series5q,
      series5r_left = series5r - series5r_right,
      series5r_left_rest = ksl_product_rest(far_x_a_of_x, series5p, series5q, series5r_left),
      series5r_right_rest = 1.6059043836821613e-10 - series5r_right,
      series5r_lo1 = series5r_left_rest + series5r_right_rest,
      series5r_lo2 = series5r_lo1 + 1.2585294588752098e-26,
      series5r_lo = series5r_lo2 + series5q_cross, series5s = KSL_MUL(far_x_a_of_x, series5r),
      series5s_cross1 = KSL_MUL(far_x_a_of_x_lo, series5r),
      series5s_cross2 = KSL_MUL(far_x_a_of_x, series5r_lo),
      series5s_cross = series5s_cross1 + series5s_cross2,
      series5t = series5s - 2.505210838544172e-08, series5t_right = series5s - series5t,
      series5t_left = series5t + series5t_right,
      series5t_left_rest = ksl_product_rest(far_x_a_of_x, series5r, series5s, series5t_left),
      series5t_right_rest = 2.505210838544172e-08 - series5t_right,
      series5t_lo1 = series5t_left_rest - series5t_right_rest,
      series5t_lo2 = series5t_lo1 - -1.448814070935912e-24,
      series5t_lo = series5t_lo2 + series5s_cross, series5u = KSL_MUL(far_x_a_of_x, series5t),
      series5u_cross1 = KSL_MUL(far_x_a_of_x_lo, series5t),
      series5u_cross2 = KSL_MUL(far_x_a_of_x, series5t_lo),
      series5u_cross = series5u_cross1 + series5u_cross2,
      series5v = series5u + 2.7557319223985893e-06, series5v_right = series5v - series5u,
      series5v_left = series5v - series5v_right,
      series5v_left_rest = ksl_product_rest(far_x_a_of_x, series5t, series5u, series5v_left),
      series5v_right_rest = 2.7557319223985893e-06 - series5v_right,
      series5v_lo1 = series5v_left_rest + series5v_right_rest,
      series5v_lo2 = series5v_lo1 + -1.858393274046472e-22,
      series5v_lo = series5v_lo2 + series5u_cross, series5w = KSL_MUL(far_x_a_of_x, series5v),
      series5w_cross1 = KSL_MUL(far_x_a_of_x_lo, series5v),
      series5w_cross2 = KSL_MUL(far_x_a_of_x, series5v_lo),
      series5w_cross = series5w_cross1 + series5w_cross2,
      series5x = series5w - 0.0001984126984126984, series5x_right = series5w - series5x,
      series5x_left = series5x + series5x_right,
      series5x_left_rest = ksl_product_rest(far_x_a_of_x, series5v, series5w, series5x_left),
      series5x_right_rest = 0.0001984126984126984 - series5x_right,
      series5x_lo1 = series5x_left_rest - series5x_right_rest,
      series5x_lo2 = series5x_lo1 - 1.7209558293420705e-22,
      series5x_lo = series5x_lo2 + series5w_cross, series5y = KSL_MUL(far_x_a_of_x, series5x),
      series5y_cross1 = KSL_MUL(far_x_a_of_x_lo, series5x),
      series5y_cross2 = KSL_MUL(far_x_a_of_x, series5x_lo),
      series5y_cross = series5y_cross1 + series5y_cross2, series5 = series5y + 0.008333333333333333,
      series5_right = series5 - series5y, series5_left = series5 - series5_right,
      series5_left_rest = ksl_product_rest(far_x_a_of_x, series5x, series5y, series5_left),
      series5_right_rest = 0.008333333333333333 - series5_right,
      series5_lo1 = series5_left_rest + series5_right_rest,
      series5_lo2 = series5_lo1 + 1.1564823173178714e-19, series5_lo = series5_lo2 + series5y_cross;
  const double g3a = KSL_MUL(far_x_a_of_x, series5), g3a_cross1 = KSL_MUL(far_x_a_of_x_lo, series5),
      g3a_cross2 = KSL_MUL(far_x_a_of_x, series5_lo), g3a_cross = g3a_cross1 + g3a_cross2,
      g3b = 0.16666666666666666 - g3a, g3b_right = 0.16666666666666666 - g3b,
      g3b_left = g3b + g3b_right, g3b_left_rest = 0.16666666666666666 - g3b_left,
      g3b_right_rest = ksl_product_rest(far_x_a_of_x, series5, g3a, g3b_right),
      g3b_lo1 = g3b_left_rest - g3b_right_rest, g3b_lo2 = g3b_lo1 - g3a_cross,
      g3b_lo = g3b_lo2 + 9.25185853854297e-18, g3 = far_x_a_of_x < 1.0 ? g3b : closed3,
      g3_lo = far_x_a_of_x < 1.0 ? g3b_lo : closed3_lo;
  const double rest4 = 0.5 - g2, rest4_right = 0.5 - rest4, rest4_left = rest4 + rest4_right,
      rest4_left_rest = 0.5 - rest4_left, rest4_right_rest = g2 - rest4_right,
      rest4_lo1 = rest4_left_rest - rest4_right_rest, rest4_lo = rest4_lo1 - g2_cross2;
  const double closed4_of_rest4 = rest4 + rest4_lo,
      closed4_of_rest4_right = closed4_of_rest4 - rest4,
      closed4_of_rest4_left = closed4_of_rest4 - closed4_of_rest4_right,
      closed4_of_rest4_left_rest = rest4 - closed4_of_rest4_left,
      closed4_of_rest4_right_rest = rest4_lo - closed4_of_rest4_right,
      closed4_of_rest4_lo = closed4_of_rest4_left_rest + closed4_of_rest4_right_rest,
      closed4 = closed4_of_rest4 / closed3_of_far_x,
      closed4_product = KSL_MUL(closed4, closed3_of_far_x),
      closed4_product_error = ksl_product_error(closed4, closed3_of_far_x, closed4_product),
      closed4_rest = closed4_of_rest4 - closed4_product,
      closed4_exact = closed4_rest - closed4_product_error,
      closed4_numerator = closed4_exact + closed4_of_rest4_lo,
      closed4_cross = KSL_MUL(closed4, closed3_of_far_x_lo),
      closed4_residual = closed4_numerator - closed4_cross,
      closed4_lo = closed4_residual / closed3_of_far_x;
  const double rest5 = 0.16666666666666666 - g3, rest5_right = 0.16666666666666666 - rest5,
      rest5_left = rest5 + rest5_right, rest5_left_rest = 0.16666666666666666 - rest5_left,
      rest5_right_rest = g3 - rest5_right, rest5_lo1 = rest5_left_rest - rest5_right_rest,
      rest5_lo2 = rest5_lo1 - g3_lo, rest5_lo = rest5_lo2 + 9.25185853854297e-18;
  const double closed5_of_rest5 = rest5 + rest5_lo,
      closed5_of_rest5_right = closed5_of_rest5 - rest5,
      closed5_of_rest5_left = closed5_of_rest5 - closed5_of_rest5_right,
      closed5_of_rest5_left_rest = rest5 - closed5_of_rest5_left,
      closed5_of_rest5_right_rest = rest5_lo - closed5_of_rest5_right,
      closed5_of_rest5_lo = closed5_of_rest5_left_rest + closed5_of_rest5_right_rest,
      closed5 = closed5_of_rest5 / closed3_of_far_x,
      closed5_product = KSL_MUL(closed5, closed3_of_far_x),
      closed5_product_error = ksl_product_error(closed5, closed3_of_far_x, closed5_product),
      closed5_rest = closed5_of_rest5 - closed5_product,
      closed5_exact = closed5_rest - closed5_product_error,
      closed5_numerator = closed5_exact + closed5_of_rest5_lo,
      closed5_cross = KSL_MUL(closed5, closed3_of_far_x_lo),
      closed5_residual = closed5_numerator - closed5_cross,
      closed5_lo = closed5_residual / closed3_of_far_x;
  const double series4a = KSL_MUL(3.7699876288159054e-33, far_x_a_of_x),
      series4a_cross1 = KSL_MUL(2.5870347832750324e-49, far_x_a_of_x),
      series4a_cross2 = KSL_MUL(3.7699876288159054e-33, far_x_a_of_x_lo),
      series4a_cross = series4a_cross1 + series4a_cross2,
      series4b = 3.279889237069838e-30 - series4a,
      series4b_right = 3.279889237069838e-30 - series4b, series4b_left = series4b + series4b_right,
      series4b_left_rest = 3.279889237069838e-30 - series4b_left,
      series4b_right_rest = ksl_product_rest(3.7699876288159054e-33, far_x_a_of_x, series4a,
          series4b_right),
      series4b_lo1 = series4b_left_rest - series4b_right_rest,
      series4b_lo2 = series4b_lo1 - series4a_cross,
      series4b_lo = series4b_lo2 + 1.5117542744029879e-46,
      series4c = KSL_MUL(far_x_a_of_x, series4b),
      series4c_cross1 = KSL_MUL(far_x_a_of_x_lo, series4b),
      series4c_cross2 = KSL_MUL(far_x_a_of_x, series4b_lo),
      series4c_cross = series4c_cross1 + series4c_cross2,
      series4d = series4c - 2.4795962632247976e-27, series4d_right = series4c - series4d,
      series4d_left = series4d + series4d_right,
      series4d_left_rest = ksl_product_rest(far_x_a_of_x, series4b, series4c, series4d_left),
      series4d_right_rest = 2.4795962632247976e-27 - series4d_right,
      series4d_lo1 = series4d_left_rest - series4d_right_rest,
      series4d_lo2 = series4d_lo1 - -1.2953730964765229e-43,
      series4d_lo = series4d_lo2 + series4c_cross, series4e = KSL_MUL(far_x_a_of_x, series4d),
      series4e_cross1 = KSL_MUL(far_x_a_of_x_lo, series4d),
      series4e_cross2 = KSL_MUL(far_x_a_of_x, series4d_lo),
      series4e_cross = series4e_cross1 + series4e_cross2,
      series4f = series4e + 1.6117375710961184e-24, series4f_right = series4f - series4e,
      series4f_left = series4f - series4f_right,
      series4f_left_rest = ksl_product_rest(far_x_a_of_x, series4d, series4e, series4f_left),
      series4f_right_rest = 1.6117375710961184e-24 - series4f_right,
      series4f_lo1 = series4f_left_rest + series4f_right_rest,
      series4f_lo2 = series4f_lo1 + -3.6846573564509766e-41,
      series4f_lo = series4f_lo2 + series4e_cross, series4g = KSL_MUL(far_x_a_of_x, series4f),
      series4g_cross1 = KSL_MUL(far_x_a_of_x_lo, series4f),
      series4g_cross2 = KSL_MUL(far_x_a_of_x, series4f_lo),
      series4g_cross = series4g_cross1 + series4g_cross2,
      series4h = series4g - 8.896791392450574e-22, series4h_right = series4g - series4h,
      series4h_left = series4h + series4h_right,
      series4h_left_rest = ksl_product_rest(far_x_a_of_x, series4f, series4g, series4h_left),
      series4h_right_rest = 8.896791392450574e-22 - series4h_right,
      series4h_lo1 = series4h_left_rest - series4h_right_rest,
      series4h_lo2 = series4h_lo1 - -7.911402614872376e-38,
      series4h_lo = series4h_lo2 + series4g_cross, series4i = KSL_MUL(far_x_a_of_x, series4h),
      series4i_cross1 = KSL_MUL(far_x_a_of_x_lo, series4h),
      series4i_cross2 = KSL_MUL(far_x_a_of_x, series4h_lo),
      series4i_cross = series4i_cross1 + series4i_cross2,
      series4j = series4i + 4.110317623312165e-19, series4j_right = series4j - series4i,
      series4j_left = series4j - series4j_right,
      series4j_left_rest = ksl_product_rest(far_x_a_of_x, series4h, series4i, series4j_left),
      series4j_right_rest = 4.110317623312165e-19 - series4j_right,
      series4j_lo1 = series4j_left_rest + series4j_right_rest,
      series4j_lo2 = series4j_lo1 + 1.4412973378659527e-36,
      series4j_lo = series4j_lo2 + series4i_cross, series4k = KSL_MUL(far_x_a_of_x, series4j),
      series4k_cross1 = KSL_MUL(far_x_a_of_x_lo, series4j),
      series4k_cross2 = KSL_MUL(far_x_a_of_x, series4j_lo),
      series4k_cross = series4k_cross1 + series4k_cross2,
      series4l = series4k - 1.5619206968586225e-16, series4l_right = series4k - series4l,
      series4l_left = series4l + series4l_right,
      series4l_left_rest = ksl_product_rest(far_x_a_of_x, series4j, series4k, series4l_left),
      series4l_right_rest = 1.5619206968586225e-16 - series4l_right,
      series4l_lo1 = series4l_left_rest - series4l_right_rest,
      series4l_lo2 = series4l_lo1 - 1.1910679660273754e-32,
      series4l_lo = series4l_lo2 + series4k_cross, series4m = KSL_MUL(far_x_a_of_x, series4l),
      series4m_cross1 = KSL_MUL(far_x_a_of_x_lo, series4l),
      series4m_cross2 = KSL_MUL(far_x_a_of_x, series4l_lo),
      series4m_cross = series4m_cross1 + series4m_cross2,
      series4n = series4m + 4.779477332387385e-14, series4n_right = series4n - series4m,
      series4n_left = series4n - series4n_right,
      series4n_left_rest = ksl_product_rest(far_x_a_of_x, series4l, series4m, series4n_left),
      series4n_right_rest = 4.779477332387385e-14 - series4n_right,
      series4n_lo1 = series4n_left_rest + series4n_right_rest,
      series4n_lo2 = series4n_lo1 + 4.399205485834081e-31,
      series4n_lo = series4n_lo2 + series4m_cross, series4o = KSL_MUL(far_x_a_of_x, series4n),
      series4o_cross1 = KSL_MUL(far_x_a_of_x_lo, series4n),
      series4o_cross2 = KSL_MUL(far_x_a_of_x, series4n_lo),
      series4o_cross = series4o_cross1 + series4o_cross2,
      series4p = series4o - 1.1470745597729725e-11, series4p_right = series4o - series4p,
      series4p_left = series4p + series4p_right,
      series4p_left_rest = ksl_product_rest(far_x_a_of_x, series4n, series4o, series4p_left),
      series4p_right_rest = 1.1470745597729725e-11 - series4p_right,
      series4p_lo1 = series4p_left_rest - series4p_right_rest,
      series4p_lo2 = series4p_lo1 - 2.0655512752830745e-28,
      series4p_lo = series4p_lo2 + series4o_cross, series4q = KSL_MUL(far_x_a_of_x, series4p),
      series4q_cross1 = KSL_MUL(far_x_a_of_x_lo, series4p),
      series4q_cross2 = KSL_MUL(far_x_a_of_x, series4p_lo),
      series4q_cross = series4q_cross1 + series4q_cross2,
      series4r = series4q + 2.08767569878681e-09, series4r_right = series4r - series4q,
      series4r_left = series4r - series4r_right,
      series4r_left_rest = ksl_product_rest(far_x_a_of_x, series4p, series4q, series4r_left),
      series4r_right_rest = 2.08767569878681e-09 - series4r_right,
      series4r_lo1 = series4r_left_rest + series4r_right_rest,
      series4r_lo2 = series4r_lo1 + -1.20734505911326e-25,
      series4r_lo = series4r_lo2 + series4q_cross, series4s = KSL_MUL(far_x_a_of_x, series4r),
      series4s_cross1 = KSL_MUL(far_x_a_of_x_lo, series4r),
      series4s_cross2 = KSL_MUL(far_x_a_of_x, series4r_lo),
      series4s_cross = series4s_cross1 + series4s_cross2,
      series4t = series4s - 2.755731922398589e-07, series4t_right = series4s - series4t,
      series4t_left = series4t + series4t_right,
      series4t_left_rest = ksl_product_rest(far_x_a_of_x, series4r, series4s, series4t_left),
      series4t_right_rest = 2.755731922398589e-07 - series4t_right,
      series4t_lo1 = series4t_left_rest - series4t_right_rest,
      series4t_lo2 = series4t_lo1 - 2.3767714622250297e-23,
      series4t_lo = series4t_lo2 + series4s_cross, series4u = KSL_MUL(far_x_a_of_x, series4t),
      series4u_cross1 = KSL_MUL(far_x_a_of_x_lo, series4t),
      series4u_cross2 = KSL_MUL(far_x_a_of_x, series4t_lo),
      series4u_cross = series4u_cross1 + series4u_cross2,
      series4v = series4u + 2.48015873015873e-05, series4v_right = series4v - series4u,
      series4v_left = series4v - series4v_right,
      series4v_left_rest = ksl_product_rest(far_x_a_of_x, series4t, series4u, series4v_left),
      series4v_right_rest = 2.48015873015873e-05 - series4v_right,
      series4v_lo1 = series4v_left_rest + series4v_right_rest,
      series4v_lo2 = series4v_lo1 + 2.1511947866775882e-23,
      series4v_lo = series4v_lo2 + series4u_cross, series4w = KSL_MUL(far_x_a_of_x, series4v),
      series4w_cross1 = KSL_MUL(far_x_a_of_x_lo, series4v),
      series4w_cross2 = KSL_MUL(far_x_a_of_x, series4v_lo),
      series4w_cross = series4w_cross1 + series4w_cross2,
      series4x = series4w - 0.001388888888888889, series4x_right = series4w - series4x,
      series4x_left = series4x + series4x_right,
      series4x_left_rest = ksl_product_rest(far_x_a_of_x, series4v, series4w, series4x_left),
      series4x_right_rest = 0.001388888888888889 - series4x_right,
      series4x_lo1 = series4x_left_rest - series4x_right_rest,
      series4x_lo2 = series4x_lo1 - -5.300543954373577e-20,
      series4x_lo = series4x_lo2 + series4w_cross, series4y = KSL_MUL(far_x_a_of_x, series4x),
      series4y_cross1 = KSL_MUL(far_x_a_of_x_lo, series4x),
      series4y_cross2 = KSL_MUL(far_x_a_of_x, series4x_lo),
      series4y_cross = series4y_cross1 + series4y_cross2, series4 = series4y + 0.041666666666666664,
      series4_right = series4 - series4y, series4_left = series4 - series4_right,
      series4_left_rest = ksl_product_rest(far_x_a_of_x, series4x, series4y, series4_left),
      series4_right_rest = 0.041666666666666664 - series4_right,
      series4_lo1 = series4_left_rest + series4_right_rest,
      series4_lo2 = series4_lo1 + 2.3129646346357427e-18, series4_lo = series4_lo2 + series4y_cross;
  const double g4 = far_x_a_of_x < 1.0 ? series4 : closed4,
      g4_lo = far_x_a_of_x < 1.0 ? series4_lo : closed4_lo;
  const double g5 = far_x_a_of_x < 1.0 ? series5 : closed5,
      g5_lo = far_x_a_of_x < 1.0 ? series5_lo : closed5_lo;
  const double rate2a = KSL_MUL(2.0, g4), rate2a_cross2 = KSL_MUL(2.0, g4_lo), rate2 = rate2a - g3,
      rate2_right = rate2a - rate2, rate2_left = rate2 + rate2_right,
      rate2_left_rest = rate2a - rate2_left, rate2_right_rest = g3 - rate2_right,
      rate2_lo1 = rate2_left_rest - rate2_right_rest, rate2_lo2 = rate2_lo1 - g3_lo,
      rate2_lo = rate2_lo2 + rate2a_cross2;
  const double rate3a = KSL_MUL(3.0, g5), rate3a_cross2 = KSL_MUL(3.0, g5_lo), rate3 = rate3a - g4,
      rate3_right = rate3a - rate3, rate3_left = rate3 + rate3_right,
      rate3_left_rest = ksl_product_rest(3.0, g5, rate3a, rate3_left),
      rate3_right_rest = g4 - rate3_right, rate3_lo1 = rate3_left_rest - rate3_right_rest,
      rate3_lo2 = rate3_lo1 - g4_lo, rate3_lo = rate3_lo2 + rate3a_cross2;
  const double beta_v_0 = KSL_MUL(s->m3, g3), beta_v_0_cross2 = KSL_MUL(s->m3, g3_lo);
  const double beta_v_1 = KSL_MUL(s->m4, g3), beta_v_1_cross2 = KSL_MUL(s->m4, g3_lo);
  const double beta_v_2 = KSL_MUL(s->m5, g3), beta_v_2_cross2 = KSL_MUL(s->m5, g3_lo);
  const double beta_v_0_error = ksl_product_error(s->m3, g3, beta_v_0),
      beta_v_0_lo = beta_v_0_error + beta_v_0_cross2, m_0 = KSL_MUL(s->m3, beta_v_0),
      m_0_cross2 = KSL_MUL(s->m3, beta_v_0_lo);
  const double beta_v_1_error = ksl_product_error(s->m4, g3, beta_v_1),
      beta_v_1_lo = beta_v_1_error + beta_v_1_cross2, m_1 = KSL_MUL(s->m4, beta_v_1),
      m_1_cross2 = KSL_MUL(s->m4, beta_v_1_lo);
  const double beta_v_2_error = ksl_product_error(s->m5, g3, beta_v_2),
      beta_v_2_lo = beta_v_2_error + beta_v_2_cross2, m_2 = KSL_MUL(s->m5, beta_v_2),
      m_2_cross2 = KSL_MUL(s->m5, beta_v_2_lo);
  const double m_3 = KSL_MUL(s->m4, beta_v_0), m_3_cross2 = KSL_MUL(s->m4, beta_v_0_lo);
  const double m_4 = KSL_MUL(s->m5, beta_v_0), m_4_cross2 = KSL_MUL(s->m5, beta_v_0_lo);
  const double m_5 = KSL_MUL(s->m5, beta_v_1), m_5_cross2 = KSL_MUL(s->m5, beta_v_1_lo);
  const double others_0 = m_1 + m_2, others_0_right = others_0 - m_1,
      others_0_left = others_0 - others_0_right,
      others_0_left_rest = ksl_product_rest(s->m4, beta_v_1, m_1, others_0_left),
      others_0_right_rest = ksl_product_rest(s->m5, beta_v_2, m_2, others_0_right),
      others_0_cross = m_1_cross2 + m_2_cross2,
      others_0_lo1 = others_0_left_rest + others_0_right_rest,
      others_0_lo = others_0_lo1 + others_0_cross;
  const double others_1 = m_0 + m_2, others_1_right = others_1 - m_0,
      others_1_left = others_1 - others_1_right,
      others_1_left_rest = ksl_product_rest(s->m3, beta_v_0, m_0, others_1_left),
      others_1_right_rest = ksl_product_rest(s->m5, beta_v_2, m_2, others_1_right),
      others_1_cross = m_0_cross2 + m_2_cross2,
      others_1_lo1 = others_1_left_rest + others_1_right_rest,
      others_1_lo = others_1_lo1 + others_1_cross;
  const double others_2 = m_0 + m_1, others_2_right = others_2 - m_0,
      others_2_left = others_2 - others_2_right,
      others_2_left_rest = ksl_product_rest(s->m3, beta_v_0, m_0, others_2_left),
      others_2_right_rest = ksl_product_rest(s->m4, beta_v_1, m_1, others_2_right),
      others_2_cross = m_0_cross2 + m_1_cross2,
      others_2_lo1 = others_2_left_rest + others_2_right_rest,
      others_2_lo = others_2_lo1 + others_2_cross;
  const double diagonal0a = 1.0 - others_0, diagonal0a_right = 1.0 - diagonal0a,
      diagonal0a_left = diagonal0a + diagonal0a_right, diagonal0a_left_rest = 1.0 - diagonal0a_left,
      diagonal0a_right_rest = others_0 - diagonal0a_right,
      diagonal0a_lo1 = diagonal0a_left_rest - diagonal0a_right_rest,
      diagonal0a_lo = diagonal0a_lo1 - others_0_lo, diagonal0b = g1 + m_0,
      diagonal0b_right = diagonal0b - g1, diagonal0b_left = diagonal0b - diagonal0b_right,
      diagonal0b_left_rest = ksl_product_rest(c, sinc, g1, diagonal0b_left),
      diagonal0b_right_rest = ksl_product_rest(s->m3, beta_v_0, m_0, diagonal0b_right),
      diagonal0b_cross = g1_cross + m_0_cross2,
      diagonal0b_lo1 = diagonal0b_left_rest + diagonal0b_right_rest,
      diagonal0b_lo = diagonal0b_lo1 + diagonal0b_cross,
      m_0_error = ksl_product_error(s->m3, beta_v_0, m_0), m_0_lo = m_0_error + m_0_cross2,
      diagonal0c_of_m_0 = m_0 + m_0_lo, diagonal0c_of_others_0 = others_0 + others_0_lo,
      diagonal0 = diagonal0c_of_m_0 < diagonal0c_of_others_0 ? diagonal0b : diagonal0a,
      diagonal0_lo = diagonal0c_of_m_0 < diagonal0c_of_others_0 ? diagonal0b_lo : diagonal0a_lo;
  const double diagonal1a = 1.0 - others_1, diagonal1a_right = 1.0 - diagonal1a,
      diagonal1a_left = diagonal1a + diagonal1a_right, diagonal1a_left_rest = 1.0 - diagonal1a_left,
      diagonal1a_right_rest = others_1 - diagonal1a_right,
      diagonal1a_lo1 = diagonal1a_left_rest - diagonal1a_right_rest,
      diagonal1a_lo = diagonal1a_lo1 - others_1_lo, diagonal1b = g1 + m_1,
      diagonal1b_right = diagonal1b - g1, diagonal1b_left = diagonal1b - diagonal1b_right,
      diagonal1b_left_rest = ksl_product_rest(c, sinc, g1, diagonal1b_left),
      diagonal1b_right_rest = ksl_product_rest(s->m4, beta_v_1, m_1, diagonal1b_right),
      diagonal1b_cross = g1_cross + m_1_cross2,
      diagonal1b_lo1 = diagonal1b_left_rest + diagonal1b_right_rest,
      diagonal1b_lo = diagonal1b_lo1 + diagonal1b_cross,
      m_1_error = ksl_product_error(s->m4, beta_v_1, m_1), m_1_lo = m_1_error + m_1_cross2,
      diagonal1c_of_m_1 = m_1 + m_1_lo, diagonal1c_of_others_1 = others_1 + others_1_lo,
      diagonal1 = diagonal1c_of_m_1 < diagonal1c_of_others_1 ? diagonal1b : diagonal1a,
      diagonal1_lo = diagonal1c_of_m_1 < diagonal1c_of_others_1 ? diagonal1b_lo : diagonal1a_lo;
  const double diagonal2a = 1.0 - others_2, diagonal2a_right = 1.0 - diagonal2a,
      diagonal2a_left = diagonal2a + diagonal2a_right, diagonal2a_left_rest = 1.0 - diagonal2a_left,
      diagonal2a_right_rest = others_2 - diagonal2a_right,
      diagonal2a_lo1 = diagonal2a_left_rest - diagonal2a_right_rest,
      diagonal2a_lo = diagonal2a_lo1 - others_2_lo, diagonal2b = g1 + m_2,
      diagonal2b_right = diagonal2b - g1, diagonal2b_left = diagonal2b - diagonal2b_right,
      diagonal2b_left_rest = ksl_product_rest(c, sinc, g1, diagonal2b_left),
      diagonal2b_right_rest = ksl_product_rest(s->m5, beta_v_2, m_2, diagonal2b_right),
      diagonal2b_cross = g1_cross + m_2_cross2,
      diagonal2b_lo1 = diagonal2b_left_rest + diagonal2b_right_rest,
      diagonal2b_lo = diagonal2b_lo1 + diagonal2b_cross,
      m_2_error = ksl_product_error(s->m5, beta_v_2, m_2), m_2_lo = m_2_error + m_2_cross2,
      diagonal2c_of_m_2 = m_2 + m_2_lo, diagonal2c_of_others_2 = others_2 + others_2_lo,
      diagonal2 = diagonal2c_of_m_2 < diagonal2c_of_others_2 ? diagonal2b : diagonal2a,
      diagonal2_lo = diagonal2c_of_m_2 < diagonal2c_of_others_2 ? diagonal2b_lo : diagonal2a_lo;
  const double alpha_v_0 = KSL_MUL(s->m3, g2), alpha_v_0_cross2 = KSL_MUL(s->m3, g2_cross2);
  const double alpha_v_1 = KSL_MUL(s->m4, g2), alpha_v_1_cross2 = KSL_MUL(s->m4, g2_cross2);
  const double alpha_v_2 = KSL_MUL(s->m5, g2), alpha_v_2_cross2 = KSL_MUL(s->m5, g2_cross2);
  const double J_1 = m_3 - alpha_v_2, J_1_right = m_3 - J_1, J_1_left = J_1 + J_1_right,
      J_1_left_rest = ksl_product_rest(s->m4, beta_v_0, m_3, J_1_left),
      J_1_right_rest = ksl_product_rest(s->m5, g2, alpha_v_2, J_1_right),
      J_1_cross = m_3_cross2 - alpha_v_2_cross2, J_1_lo1 = J_1_left_rest - J_1_right_rest,
      J_1_lo = J_1_lo1 + J_1_cross;
  const double J_2 = m_4 + alpha_v_1, J_2_right = J_2 - m_4, J_2_left = J_2 - J_2_right,
      J_2_left_rest = ksl_product_rest(s->m5, beta_v_0, m_4, J_2_left),
      J_2_right_rest = ksl_product_rest(s->m4, g2, alpha_v_1, J_2_right),
      J_2_cross = m_4_cross2 + alpha_v_1_cross2, J_2_lo1 = J_2_left_rest + J_2_right_rest,
      J_2_lo = J_2_lo1 + J_2_cross;
  const double J_3 = m_3 + alpha_v_2, J_3_right = J_3 - m_3, J_3_left = J_3 - J_3_right,
      J_3_left_rest = ksl_product_rest(s->m4, beta_v_0, m_3, J_3_left),
      J_3_right_rest = ksl_product_rest(s->m5, g2, alpha_v_2, J_3_right),
      J_3_cross = m_3_cross2 + alpha_v_2_cross2, J_3_lo1 = J_3_left_rest + J_3_right_rest,
      J_3_lo = J_3_lo1 + J_3_cross;
  const double J_5 = m_5 - alpha_v_0, J_5_right = m_5 - J_5, J_5_left = J_5 + J_5_right,
      J_5_left_rest = ksl_product_rest(s->m5, beta_v_1, m_5, J_5_left),
      J_5_right_rest = ksl_product_rest(s->m3, g2, alpha_v_0, J_5_right),
      J_5_cross = m_5_cross2 - alpha_v_0_cross2, J_5_lo1 = J_5_left_rest - J_5_right_rest,
      J_5_lo = J_5_lo1 + J_5_cross;
  const double J_6 = m_4 - alpha_v_1, J_6_right = m_4 - J_6, J_6_left = J_6 + J_6_right,
      J_6_left_rest = ksl_product_rest(s->m5, beta_v_0, m_4, J_6_left),
      J_6_right_rest = ksl_product_rest(s->m4, g2, alpha_v_1, J_6_right),
      J_6_cross = m_4_cross2 - alpha_v_1_cross2, J_6_lo1 = J_6_left_rest - J_6_right_rest,
      J_6_lo = J_6_lo1 + J_6_cross;
  const double J_7 = m_5 + alpha_v_0, J_7_right = J_7 - m_5, J_7_left = J_7 - J_7_right,
      J_7_left_rest = ksl_product_rest(s->m5, beta_v_1, m_5, J_7_left),
      J_7_right_rest = ksl_product_rest(s->m3, g2, alpha_v_0, J_7_right),
      J_7_cross = m_5_cross2 + alpha_v_0_cross2, J_7_lo1 = J_7_left_rest + J_7_right_rest,
      J_7_lo = J_7_lo1 + J_7_cross;
  const double rate_vw_a = KSL_MUL(s->m0, s->m3), rate_vw_b = KSL_MUL(s->m1, s->m4),
      rate_vw_c = rate_vw_a + rate_vw_b, rate_vw_c_right = rate_vw_c - rate_vw_a,
      rate_vw_c_left = rate_vw_c - rate_vw_c_right,
      rate_vw_c_left_rest = ksl_product_rest(s->m0, s->m3, rate_vw_a, rate_vw_c_left),
      rate_vw_c_right_rest = ksl_product_rest(s->m1, s->m4, rate_vw_b, rate_vw_c_right),
      rate_vw_c_lo = rate_vw_c_left_rest + rate_vw_c_right_rest, rate_vw_d = KSL_MUL(s->m2, s->m5),
      rate_vw = rate_vw_c + rate_vw_d, rate_vw_right = rate_vw - rate_vw_c,
      rate_vw_left = rate_vw - rate_vw_right, rate_vw_left_rest = rate_vw_c - rate_vw_left,
      rate_vw_right_rest = ksl_product_rest(s->m2, s->m5, rate_vw_d, rate_vw_right),
      rate_vw_lo1 = rate_vw_left_rest + rate_vw_right_rest, rate_vw_lo = rate_vw_lo1 + rate_vw_c_lo;
  const double rate_turn = KSL_MUL(rate2, rate_vw), rate_turn_cross1 = KSL_MUL(rate2_lo, rate_vw),
      rate_turn_cross2 = KSL_MUL(rate2, rate_vw_lo),
      rate_turn_cross = rate_turn_cross1 + rate_turn_cross2;
  const double rate_bend_a = KSL_MUL(rate3, rate_vw),
      rate_bend_a_cross1 = KSL_MUL(rate3_lo, rate_vw),
      rate_bend_a_cross2 = KSL_MUL(rate3, rate_vw_lo),
      rate_bend_a_cross = rate_bend_a_cross1 + rate_bend_a_cross2, rate_bend = -rate_bend_a,
      rate_bend_cross = -rate_bend_a_cross, rate_bend_factor = -rate3;
  const double rate_q_0a = KSL_MUL(s->m0, g2), rate_q_0a_cross2 = KSL_MUL(s->m0, g2_cross2),
      rate_turn_error = ksl_product_error(rate2, rate_vw, rate_turn),
      rate_turn_lo = rate_turn_error + rate_turn_cross, rate_q_0b = KSL_MUL(s->m3, rate_turn),
      rate_q_0b_cross2 = KSL_MUL(s->m3, rate_turn_lo), rate_q_0 = rate_q_0a + rate_q_0b,
      rate_q_0_right = rate_q_0 - rate_q_0a, rate_q_0_left = rate_q_0 - rate_q_0_right,
      rate_q_0_left_rest = ksl_product_rest(s->m0, g2, rate_q_0a, rate_q_0_left),
      rate_q_0_right_rest = ksl_product_rest(s->m3, rate_turn, rate_q_0b, rate_q_0_right),
      rate_q_0_cross = rate_q_0a_cross2 + rate_q_0b_cross2,
      rate_q_0_lo1 = rate_q_0_left_rest + rate_q_0_right_rest,
      rate_q_0_lo = rate_q_0_lo1 + rate_q_0_cross;
  const double rate_q_1a = KSL_MUL(s->m1, g2), rate_q_1a_cross2 = KSL_MUL(s->m1, g2_cross2),
      rate_q_1b = KSL_MUL(s->m4, rate_turn), rate_q_1b_cross2 = KSL_MUL(s->m4, rate_turn_lo),
      rate_q_1 = rate_q_1a + rate_q_1b, rate_q_1_right = rate_q_1 - rate_q_1a,
      rate_q_1_left = rate_q_1 - rate_q_1_right,
      rate_q_1_left_rest = ksl_product_rest(s->m1, g2, rate_q_1a, rate_q_1_left),
      rate_q_1_right_rest = ksl_product_rest(s->m4, rate_turn, rate_q_1b, rate_q_1_right),
      rate_q_1_cross = rate_q_1a_cross2 + rate_q_1b_cross2,
      rate_q_1_lo1 = rate_q_1_left_rest + rate_q_1_right_rest,
      rate_q_1_lo = rate_q_1_lo1 + rate_q_1_cross;
  const double rate_q_2a = KSL_MUL(s->m2, g2), rate_q_2a_cross2 = KSL_MUL(s->m2, g2_cross2),
      rate_q_2b = KSL_MUL(s->m5, rate_turn), rate_q_2b_cross2 = KSL_MUL(s->m5, rate_turn_lo),
      rate_q_2 = rate_q_2a + rate_q_2b, rate_q_2_right = rate_q_2 - rate_q_2a,
      rate_q_2_left = rate_q_2 - rate_q_2_right,
      rate_q_2_left_rest = ksl_product_rest(s->m2, g2, rate_q_2a, rate_q_2_left),
      rate_q_2_right_rest = ksl_product_rest(s->m5, rate_turn, rate_q_2b, rate_q_2_right),
      rate_q_2_cross = rate_q_2a_cross2 + rate_q_2b_cross2,
      rate_q_2_lo1 = rate_q_2_left_rest + rate_q_2_right_rest,
      rate_q_2_lo = rate_q_2_lo1 + rate_q_2_cross;
  const double rate_beta_v_0 = KSL_MUL(s->m0, g3), rate_beta_v_0_cross2 = KSL_MUL(s->m0, g3_lo);
  const double rate_beta_v_1 = KSL_MUL(s->m1, g3), rate_beta_v_1_cross2 = KSL_MUL(s->m1, g3_lo);
  const double rate_beta_v_2 = KSL_MUL(s->m2, g3), rate_beta_v_2_cross2 = KSL_MUL(s->m2, g3_lo);
  const double rate_bend_error = ksl_product_error(rate_bend_factor, rate_vw, rate_bend),
      rate_bend_lo = rate_bend_error + rate_bend_cross, rate_bend_w_0 = KSL_MUL(s->m3, rate_bend),
      rate_bend_w_0_cross2 = KSL_MUL(s->m3, rate_bend_lo);
  const double rate_bend_w_1 = KSL_MUL(s->m4, rate_bend),
      rate_bend_w_1_cross2 = KSL_MUL(s->m4, rate_bend_lo);
  const double rate_bend_w_2 = KSL_MUL(s->m5, rate_bend),
      rate_bend_w_2_cross2 = KSL_MUL(s->m5, rate_bend_lo);
  const double rate_beta_v_1_error = ksl_product_error(s->m1, g3, rate_beta_v_1),
      rate_beta_v_1_lo = rate_beta_v_1_error + rate_beta_v_1_cross2,
      rate_symmetric_0a = KSL_MUL(s->m3, rate_beta_v_1),
      rate_symmetric_0a_cross2 = KSL_MUL(s->m3, rate_beta_v_1_lo),
      rate_beta_v_0_error = ksl_product_error(s->m0, g3, rate_beta_v_0),
      rate_beta_v_0_lo = rate_beta_v_0_error + rate_beta_v_0_cross2,
      rate_symmetric_0b = KSL_MUL(s->m4, rate_beta_v_0),
      rate_symmetric_0b_cross2 = KSL_MUL(s->m4, rate_beta_v_0_lo),
      rate_symmetric_0c = rate_symmetric_0a + rate_symmetric_0b,
      rate_symmetric_0c_right = rate_symmetric_0c - rate_symmetric_0a,
      rate_symmetric_0c_left = rate_symmetric_0c - rate_symmetric_0c_right,
      rate_symmetric_0c_left_rest = ksl_product_rest(s->m3, rate_beta_v_1, rate_symmetric_0a,
          rate_symmetric_0c_left),
      rate_symmetric_0c_right_rest = ksl_product_rest(s->m4, rate_beta_v_0, rate_symmetric_0b,
          rate_symmetric_0c_right),
      rate_symmetric_0c_cross = rate_symmetric_0a_cross2 + rate_symmetric_0b_cross2,
      rate_symmetric_0c_lo1 = rate_symmetric_0c_left_rest + rate_symmetric_0c_right_rest,
      rate_symmetric_0c_lo = rate_symmetric_0c_lo1 + rate_symmetric_0c_cross,
      rate_bend_w_0_error = ksl_product_error(s->m3, rate_bend, rate_bend_w_0),
      rate_bend_w_0_lo = rate_bend_w_0_error + rate_bend_w_0_cross2,
      rate_symmetric_0d = KSL_MUL(s->m4, rate_bend_w_0),
      rate_symmetric_0d_cross2 = KSL_MUL(s->m4, rate_bend_w_0_lo),
      rate_symmetric_0 = rate_symmetric_0c - rate_symmetric_0d,
      rate_symmetric_0_right = rate_symmetric_0c - rate_symmetric_0,
      rate_symmetric_0_left = rate_symmetric_0 + rate_symmetric_0_right,
      rate_symmetric_0_left_rest = rate_symmetric_0c - rate_symmetric_0_left,
      rate_symmetric_0_right_rest = ksl_product_rest(s->m4, rate_bend_w_0, rate_symmetric_0d,
          rate_symmetric_0_right),
      rate_symmetric_0_lo1 = rate_symmetric_0_left_rest - rate_symmetric_0_right_rest,
      rate_symmetric_0_lo2 = rate_symmetric_0_lo1 - rate_symmetric_0d_cross2,
      rate_symmetric_0_lo = rate_symmetric_0_lo2 + rate_symmetric_0c_lo;
  const double rate_beta_v_2_error = ksl_product_error(s->m2, g3, rate_beta_v_2),
      rate_beta_v_2_lo = rate_beta_v_2_error + rate_beta_v_2_cross2,
      rate_symmetric_1a = KSL_MUL(s->m3, rate_beta_v_2),
      rate_symmetric_1a_cross2 = KSL_MUL(s->m3, rate_beta_v_2_lo),
      rate_symmetric_1b = KSL_MUL(s->m5, rate_beta_v_0),
      rate_symmetric_1b_cross2 = KSL_MUL(s->m5, rate_beta_v_0_lo),
      rate_symmetric_1c = rate_symmetric_1a + rate_symmetric_1b,
      rate_symmetric_1c_right = rate_symmetric_1c - rate_symmetric_1a,
      rate_symmetric_1c_left = rate_symmetric_1c - rate_symmetric_1c_right,
      rate_symmetric_1c_left_rest = ksl_product_rest(s->m3, rate_beta_v_2, rate_symmetric_1a,
          rate_symmetric_1c_left),
      rate_symmetric_1c_right_rest = ksl_product_rest(s->m5, rate_beta_v_0, rate_symmetric_1b,
          rate_symmetric_1c_right),
      rate_symmetric_1c_cross = rate_symmetric_1a_cross2 + rate_symmetric_1b_cross2,
      rate_symmetric_1c_lo1 = rate_symmetric_1c_left_rest + rate_symmetric_1c_right_rest,
      rate_symmetric_1c_lo = rate_symmetric_1c_lo1 + rate_symmetric_1c_cross,
      rate_symmetric_1d = KSL_MUL(s->m5, rate_bend_w_0),
      rate_symmetric_1d_cross2 = KSL_MUL(s->m5, rate_bend_w_0_lo),
      rate_symmetric_1 = rate_symmetric_1c - rate_symmetric_1d,
      rate_symmetric_1_right = rate_symmetric_1c - rate_symmetric_1,
      rate_symmetric_1_left = rate_symmetric_1 + rate_symmetric_1_right,
      rate_symmetric_1_left_rest = rate_symmetric_1c - rate_symmetric_1_left,
      rate_symmetric_1_right_rest = ksl_product_rest(s->m5, rate_bend_w_0, rate_symmetric_1d,
          rate_symmetric_1_right),
      rate_symmetric_1_lo1 = rate_symmetric_1_left_rest - rate_symmetric_1_right_rest,
      rate_symmetric_1_lo2 = rate_symmetric_1_lo1 - rate_symmetric_1d_cross2,
      rate_symmetric_1_lo = rate_symmetric_1_lo2 + rate_symmetric_1c_lo;
  const double rate_symmetric_2a = KSL_MUL(s->m4, rate_beta_v_2),
      rate_symmetric_2a_cross2 = KSL_MUL(s->m4, rate_beta_v_2_lo),
      rate_symmetric_2b = KSL_MUL(s->m5, rate_beta_v_1),
      rate_symmetric_2b_cross2 = KSL_MUL(s->m5, rate_beta_v_1_lo),
      rate_symmetric_2c = rate_symmetric_2a + rate_symmetric_2b,
      rate_symmetric_2c_right = rate_symmetric_2c - rate_symmetric_2a,
      rate_symmetric_2c_left = rate_symmetric_2c - rate_symmetric_2c_right,
      rate_symmetric_2c_left_rest = ksl_product_rest(s->m4, rate_beta_v_2, rate_symmetric_2a,
          rate_symmetric_2c_left),
      rate_symmetric_2c_right_rest = ksl_product_rest(s->m5, rate_beta_v_1, rate_symmetric_2b,
          rate_symmetric_2c_right),
      rate_symmetric_2c_cross = rate_symmetric_2a_cross2 + rate_symmetric_2b_cross2,
      rate_symmetric_2c_lo1 = rate_symmetric_2c_left_rest + rate_symmetric_2c_right_rest,
      rate_symmetric_2c_lo = rate_symmetric_2c_lo1 + rate_symmetric_2c_cross,
      rate_bend_w_1_error = ksl_product_error(s->m4, rate_bend, rate_bend_w_1),
      rate_bend_w_1_lo = rate_bend_w_1_error + rate_bend_w_1_cross2,
      rate_symmetric_2d = KSL_MUL(s->m5, rate_bend_w_1),
      rate_symmetric_2d_cross2 = KSL_MUL(s->m5, rate_bend_w_1_lo),
      rate_symmetric_2 = rate_symmetric_2c - rate_symmetric_2d,
      rate_symmetric_2_right = rate_symmetric_2c - rate_symmetric_2,
      rate_symmetric_2_left = rate_symmetric_2 + rate_symmetric_2_right,
      rate_symmetric_2_left_rest = rate_symmetric_2c - rate_symmetric_2_left,
      rate_symmetric_2_right_rest = ksl_product_rest(s->m5, rate_bend_w_1, rate_symmetric_2d,
          rate_symmetric_2_right),
      rate_symmetric_2_lo1 = rate_symmetric_2_left_rest - rate_symmetric_2_right_rest,
      rate_symmetric_2_lo2 = rate_symmetric_2_lo1 - rate_symmetric_2d_cross2,
      rate_symmetric_2_lo = rate_symmetric_2_lo2 + rate_symmetric_2c_lo;
  const double rate_diagonal_0a = KSL_MUL(s->m4, rate_bend_w_1),
      rate_diagonal_0a_cross2 = KSL_MUL(s->m4, rate_bend_w_1_lo),
      rate_bend_w_2_error = ksl_product_error(s->m5, rate_bend, rate_bend_w_2),
      rate_bend_w_2_lo = rate_bend_w_2_error + rate_bend_w_2_cross2,
      rate_diagonal_0b = KSL_MUL(s->m5, rate_bend_w_2),
      rate_diagonal_0b_cross2 = KSL_MUL(s->m5, rate_bend_w_2_lo),
      rate_diagonal_0c = rate_diagonal_0a + rate_diagonal_0b,
      rate_diagonal_0c_right = rate_diagonal_0c - rate_diagonal_0a,
      rate_diagonal_0c_left = rate_diagonal_0c - rate_diagonal_0c_right,
      rate_diagonal_0c_left_rest = ksl_product_rest(s->m4, rate_bend_w_1, rate_diagonal_0a,
          rate_diagonal_0c_left),
      rate_diagonal_0c_right_rest = ksl_product_rest(s->m5, rate_bend_w_2, rate_diagonal_0b,
          rate_diagonal_0c_right),
      rate_diagonal_0c_cross = rate_diagonal_0a_cross2 + rate_diagonal_0b_cross2,
      rate_diagonal_0c_lo1 = rate_diagonal_0c_left_rest + rate_diagonal_0c_right_rest,
      rate_diagonal_0c_lo = rate_diagonal_0c_lo1 + rate_diagonal_0c_cross,
      rate_diagonal_0d = KSL_MUL(2.0, s->m4),
      rate_diagonal_0e = KSL_MUL(rate_diagonal_0d, rate_beta_v_1),
      rate_diagonal_0e_cross2 = KSL_MUL(rate_diagonal_0d, rate_beta_v_1_lo),
      rate_diagonal_0f = KSL_MUL(2.0, s->m5),
      rate_diagonal_0g = KSL_MUL(rate_diagonal_0f, rate_beta_v_2),
      rate_diagonal_0g_cross2 = KSL_MUL(rate_diagonal_0f, rate_beta_v_2_lo),
      rate_diagonal_0h = rate_diagonal_0e + rate_diagonal_0g,
      rate_diagonal_0h_right = rate_diagonal_0h - rate_diagonal_0e,
      rate_diagonal_0h_left = rate_diagonal_0h - rate_diagonal_0h_right,
      rate_diagonal_0h_left_rest = ksl_product_rest(rate_diagonal_0d, rate_beta_v_1,
          rate_diagonal_0e, rate_diagonal_0h_left),
      rate_diagonal_0h_right_rest = ksl_product_rest(rate_diagonal_0f, rate_beta_v_2,
          rate_diagonal_0g, rate_diagonal_0h_right),
      rate_diagonal_0h_cross = rate_diagonal_0e_cross2 + rate_diagonal_0g_cross2,
      rate_diagonal_0h_lo1 = rate_diagonal_0h_left_rest + rate_diagonal_0h_right_rest,
      rate_diagonal_0h_lo = rate_diagonal_0h_lo1 + rate_diagonal_0h_cross,
      rate_diagonal_0 = rate_diagonal_0c - rate_diagonal_0h,
      rate_diagonal_0_right = rate_diagonal_0c - rate_diagonal_0,
      rate_diagonal_0_left = rate_diagonal_0 + rate_diagonal_0_right,
      rate_diagonal_0_left_rest = rate_diagonal_0c - rate_diagonal_0_left,
      rate_diagonal_0_right_rest = rate_diagonal_0h - rate_diagonal_0_right,
      rate_diagonal_0_lo1 = rate_diagonal_0_left_rest - rate_diagonal_0_right_rest,
      rate_diagonal_0_lo2 = rate_diagonal_0_lo1 - rate_diagonal_0h_lo,
      rate_diagonal_0_lo = rate_diagonal_0_lo2 + rate_diagonal_0c_lo;
  const double rate_diagonal_1a = KSL_MUL(s->m3, rate_bend_w_0),
      rate_diagonal_1a_cross2 = KSL_MUL(s->m3, rate_bend_w_0_lo),
      rate_diagonal_1b = rate_diagonal_1a + rate_diagonal_0b,
      rate_diagonal_1b_right = rate_diagonal_1b - rate_diagonal_1a,
      rate_diagonal_1b_left = rate_diagonal_1b - rate_diagonal_1b_right,
      rate_diagonal_1b_left_rest = ksl_product_rest(s->m3, rate_bend_w_0, rate_diagonal_1a,
          rate_diagonal_1b_left),
      rate_diagonal_1b_right_rest = ksl_product_rest(s->m5, rate_bend_w_2, rate_diagonal_0b,
          rate_diagonal_1b_right),
      rate_diagonal_1b_cross = rate_diagonal_1a_cross2 + rate_diagonal_0b_cross2,
      rate_diagonal_1b_lo1 = rate_diagonal_1b_left_rest + rate_diagonal_1b_right_rest,
      rate_diagonal_1b_lo = rate_diagonal_1b_lo1 + rate_diagonal_1b_cross,
      rate_diagonal_1c = KSL_MUL(2.0, s->m3),
      rate_diagonal_1d = KSL_MUL(rate_diagonal_1c, rate_beta_v_0),
      rate_diagonal_1d_cross2 = KSL_MUL(rate_diagonal_1c, rate_beta_v_0_lo),
      rate_diagonal_1e = rate_diagonal_1d + rate_diagonal_0g,
      rate_diagonal_1e_right = rate_diagonal_1e - rate_diagonal_1d,
      rate_diagonal_1e_left = rate_diagonal_1e - rate_diagonal_1e_right,
      rate_diagonal_1e_left_rest = ksl_product_rest(rate_diagonal_1c, rate_beta_v_0,
          rate_diagonal_1d, rate_diagonal_1e_left),
      rate_diagonal_1e_right_rest = ksl_product_rest(rate_diagonal_0f, rate_beta_v_2,
          rate_diagonal_0g, rate_diagonal_1e_right),
      rate_diagonal_1e_cross = rate_diagonal_1d_cross2 + rate_diagonal_0g_cross2,
      rate_diagonal_1e_lo1 = rate_diagonal_1e_left_rest + rate_diagonal_1e_right_rest,
      rate_diagonal_1e_lo = rate_diagonal_1e_lo1 + rate_diagonal_1e_cross,
      rate_diagonal_1 = rate_diagonal_1b - rate_diagonal_1e,
      rate_diagonal_1_right = rate_diagonal_1b - rate_diagonal_1,
      rate_diagonal_1_left = rate_diagonal_1 + rate_diagonal_1_right,
      rate_diagonal_1_left_rest = rate_diagonal_1b - rate_diagonal_1_left,
      rate_diagonal_1_right_rest = rate_diagonal_1e - rate_diagonal_1_right,
      rate_diagonal_1_lo1 = rate_diagonal_1_left_rest - rate_diagonal_1_right_rest,
      rate_diagonal_1_lo2 = rate_diagonal_1_lo1 - rate_diagonal_1e_lo,
      rate_diagonal_1_lo = rate_diagonal_1_lo2 + rate_diagonal_1b_lo;
  const double rate_diagonal_2a = rate_diagonal_1a + rate_diagonal_0a,
      rate_diagonal_2a_right = rate_diagonal_2a - rate_diagonal_1a,
      rate_diagonal_2a_left = rate_diagonal_2a - rate_diagonal_2a_right,
      rate_diagonal_2a_left_rest = ksl_product_rest(s->m3, rate_bend_w_0, rate_diagonal_1a,
          rate_diagonal_2a_left),
      rate_diagonal_2a_right_rest = ksl_product_rest(s->m4, rate_bend_w_1, rate_diagonal_0a,
          rate_diagonal_2a_right),
      rate_diagonal_2a_cross = rate_diagonal_1a_cross2 + rate_diagonal_0a_cross2,
      rate_diagonal_2a_lo1 = rate_diagonal_2a_left_rest + rate_diagonal_2a_right_rest,
      rate_diagonal_2a_lo = rate_diagonal_2a_lo1 + rate_diagonal_2a_cross,
      rate_diagonal_2b = rate_diagonal_1d + rate_diagonal_0e,
      rate_diagonal_2b_right = rate_diagonal_2b - rate_diagonal_1d,
      rate_diagonal_2b_left = rate_diagonal_2b - rate_diagonal_2b_right,
      rate_diagonal_2b_left_rest = ksl_product_rest(rate_diagonal_1c, rate_beta_v_0,
          rate_diagonal_1d, rate_diagonal_2b_left),
      rate_diagonal_2b_right_rest = ksl_product_rest(rate_diagonal_0d, rate_beta_v_1,
          rate_diagonal_0e, rate_diagonal_2b_right),
      rate_diagonal_2b_cross = rate_diagonal_1d_cross2 + rate_diagonal_0e_cross2,
      rate_diagonal_2b_lo1 = rate_diagonal_2b_left_rest + rate_diagonal_2b_right_rest,
      rate_diagonal_2b_lo = rate_diagonal_2b_lo1 + rate_diagonal_2b_cross,
      rate_diagonal_2 = rate_diagonal_2a - rate_diagonal_2b,
      rate_diagonal_2_right = rate_diagonal_2a - rate_diagonal_2,
      rate_diagonal_2_left = rate_diagonal_2 + rate_diagonal_2_right,
      rate_diagonal_2_left_rest = rate_diagonal_2a - rate_diagonal_2_left,
      rate_diagonal_2_right_rest = rate_diagonal_2b - rate_diagonal_2_right,
      rate_diagonal_2_lo1 = rate_diagonal_2_left_rest - rate_diagonal_2_right_rest,
      rate_diagonal_2_lo2 = rate_diagonal_2_lo1 - rate_diagonal_2b_lo,
      rate_diagonal_2_lo = rate_diagonal_2_lo2 + rate_diagonal_2a_lo;
  const double M_04 = rate_symmetric_0 - rate_q_2, M_04_right = rate_symmetric_0 - M_04,
      M_04_left = M_04 + M_04_right, M_04_left_rest = rate_symmetric_0 - M_04_left,
      M_04_right_rest = rate_q_2 - M_04_right, M_04_lo1 = M_04_left_rest - M_04_right_rest,
      M_04_lo2 = M_04_lo1 - rate_q_2_lo, M_04_lo = M_04_lo2 + rate_symmetric_0_lo;
  const double M_05 = rate_q_1 + rate_symmetric_1, M_05_right = M_05 - rate_q_1,
      M_05_left = M_05 - M_05_right, M_05_left_rest = rate_q_1 - M_05_left,
      M_05_right_rest = rate_symmetric_1 - M_05_right, M_05_lo1 = M_05_left_rest + M_05_right_rest,
      M_05_lo2 = M_05_lo1 + rate_symmetric_1_lo, M_05_lo = M_05_lo2 + rate_q_1_lo;
  const double M_13 = rate_q_2 + rate_symmetric_0, M_13_right = M_13 - rate_q_2,
      M_13_left = M_13 - M_13_right, M_13_left_rest = rate_q_2 - M_13_left,
      M_13_right_rest = rate_symmetric_0 - M_13_right, M_13_lo1 = M_13_left_rest + M_13_right_rest,
      M_13_lo2 = M_13_lo1 + rate_symmetric_0_lo, M_13_lo = M_13_lo2 + rate_q_2_lo;
  const double M_15 = rate_symmetric_2 - rate_q_0, M_15_right = rate_symmetric_2 - M_15,
      M_15_left = M_15 + M_15_right, M_15_left_rest = rate_symmetric_2 - M_15_left,
      M_15_right_rest = rate_q_0 - M_15_right, M_15_lo1 = M_15_left_rest - M_15_right_rest,
      M_15_lo2 = M_15_lo1 - rate_q_0_lo, M_15_lo = M_15_lo2 + rate_symmetric_2_lo;
  const double M_23 = rate_symmetric_1 - rate_q_1, M_23_right = rate_symmetric_1 - M_23,
      M_23_left = M_23 + M_23_right, M_23_left_rest = rate_symmetric_1 - M_23_left,
      M_23_right_rest = rate_q_1 - M_23_right, M_23_lo1 = M_23_left_rest - M_23_right_rest,
      M_23_lo2 = M_23_lo1 - rate_q_1_lo, M_23_lo = M_23_lo2 + rate_symmetric_1_lo;
  const double M_24 = rate_q_0 + rate_symmetric_2, M_24_right = M_24 - rate_q_0,
      M_24_left = M_24 - M_24_right, M_24_left_rest = rate_q_0 - M_24_left,
      M_24_right_rest = rate_symmetric_2 - M_24_right, M_24_lo1 = M_24_left_rest + M_24_right_rest,
      M_24_lo2 = M_24_lo1 + rate_symmetric_2_lo, M_24_lo = M_24_lo2 + rate_q_0_lo;
  const double diagonal0_rounded = diagonal0 + diagonal0_lo,
      diagonal0_final = diagonal0_rounded == diagonal0_rounded ? diagonal0_rounded : diagonal0;
  const double J_1_rounded = J_1 + J_1_lo,
      J_1_final = J_1_rounded == J_1_rounded ? J_1_rounded : J_1;
  const double J_2_rounded = J_2 + J_2_lo,
      J_2_final = J_2_rounded == J_2_rounded ? J_2_rounded : J_2;
  const double rate_diagonal_0_rounded = rate_diagonal_0 + rate_diagonal_0_lo,
      rate_diagonal_0_final = rate_diagonal_0_rounded == rate_diagonal_0_rounded ?
          rate_diagonal_0_rounded : rate_diagonal_0;
  const double M_04_rounded = M_04 + M_04_lo,
      M_04_final = M_04_rounded == M_04_rounded ? M_04_rounded : M_04;
  const double M_05_rounded = M_05 + M_05_lo,
      M_05_final = M_05_rounded == M_05_rounded ? M_05_rounded : M_05;
  const double J_3_rounded = J_3 + J_3_lo,
      J_3_final = J_3_rounded == J_3_rounded ? J_3_rounded : J_3;
  const double diagonal1_rounded = diagonal1 + diagonal1_lo,
      diagonal1_final = diagonal1_rounded == diagonal1_rounded ? diagonal1_rounded : diagonal1;
  const double J_5_rounded = J_5 + J_5_lo,
      J_5_final = J_5_rounded == J_5_rounded ? J_5_rounded : J_5;
  const double M_13_rounded = M_13 + M_13_lo,
      M_13_final = M_13_rounded == M_13_rounded ? M_13_rounded : M_13;
  const double rate_diagonal_1_rounded = rate_diagonal_1 + rate_diagonal_1_lo,
      rate_diagonal_1_final = rate_diagonal_1_rounded == rate_diagonal_1_rounded ?
          rate_diagonal_1_rounded : rate_diagonal_1;
  const double M_15_rounded = M_15 + M_15_lo,
      M_15_final = M_15_rounded == M_15_rounded ? M_15_rounded : M_15;
  const double J_6_rounded = J_6 + J_6_lo,
      J_6_final = J_6_rounded == J_6_rounded ? J_6_rounded : J_6;
  const double J_7_rounded = J_7 + J_7_lo,
      J_7_final = J_7_rounded == J_7_rounded ? J_7_rounded : J_7;
  const double diagonal2_rounded = diagonal2 + diagonal2_lo,
      diagonal2_final = diagonal2_rounded == diagonal2_rounded ? diagonal2_rounded : diagonal2;
  const double M_23_rounded = M_23 + M_23_lo,
      M_23_final = M_23_rounded == M_23_rounded ? M_23_rounded : M_23;
  const double M_24_rounded = M_24 + M_24_lo,
      M_24_final = M_24_rounded == M_24_rounded ? M_24_rounded : M_24;
  const double rate_diagonal_2_rounded = rate_diagonal_2 + rate_diagonal_2_lo,
      rate_diagonal_2_final = rate_diagonal_2_rounded == rate_diagonal_2_rounded ?
          rate_diagonal_2_rounded : rate_diagonal_2;
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
  const double halved_0 = KSL_MUL(0.5, s->m3);
  const double halved_1 = KSL_MUL(0.5, s->m4);
  const double halved_2 = KSL_MUL(0.5, s->m5);
  const double y_a = KSL_MUL(halved_0, halved_0), y_b = KSL_MUL(halved_1, halved_1),
      y_c = y_a + y_b, y_c_right = y_c - y_a, y_c_left = y_c - y_c_right,
      y_c_left_rest = ksl_product_rest(halved_0, halved_0, y_a, y_c_left),
      y_c_right_rest = ksl_product_rest(halved_1, halved_1, y_b, y_c_right),
      y_c_lo = y_c_left_rest + y_c_right_rest, y_d = KSL_MUL(halved_2, halved_2), y = y_c + y_d,
      y_right = y - y_c, y_left = y - y_right, y_left_rest = y_c - y_left,
      y_right_rest = ksl_product_rest(halved_2, halved_2, y_d, y_right),
      y_lo1 = y_left_rest + y_right_rest, y_lo = y_lo1 + y_c_lo;
  const double half_angle_of_y = y + y_lo, half_angle_of_y_right = half_angle_of_y - y,
      half_angle_of_y_left = half_angle_of_y - half_angle_of_y_right,
      half_angle_of_y_left_rest = y - half_angle_of_y_left,
      half_angle_of_y_right_rest = y_lo - half_angle_of_y_right,
      half_angle_of_y_lo = half_angle_of_y_left_rest + half_angle_of_y_right_rest,
      half_angle = sqrt(half_angle_of_y), half_angle_product = KSL_MUL(half_angle, half_angle),
      half_angle_product_error = ksl_product_error(half_angle, half_angle, half_angle_product),
      half_angle_rest = half_angle_of_y - half_angle_product,
      half_angle_exact = half_angle_rest - half_angle_product_error,
      half_angle_residual = half_angle_exact + half_angle_of_y_lo,
      half_angle_twice = half_angle + half_angle,
      half_angle_divisor = half_angle == 0.0 ? 1.0 : half_angle_twice,
      half_angle_lo = half_angle_residual / half_angle_divisor;
  const double sine_of_half_angle = half_angle + half_angle_lo,
      sine_of_half_angle_right = sine_of_half_angle - half_angle,
      sine_of_half_angle_left = sine_of_half_angle - sine_of_half_angle_right,
      sine_of_half_angle_left_rest = half_angle - sine_of_half_angle_left,
      sine_of_half_angle_right_rest = half_angle_lo - sine_of_half_angle_right,
      sine_of_half_angle_lo = sine_of_half_angle_left_rest + sine_of_half_angle_right_rest;
  double c; const double sine = ksl_sincos(sine_of_half_angle, &c);
  double c_own_error; const double sine_own_error = ksl_sincos_error(sine_of_half_angle, sine, c,
      &c_own_error);
  const double sine_half = KSL_MUL(sine_of_half_angle_lo, 0.5);
  double sine_half_cos; const double sine_half_sin = ksl_sincos(sine_half, &sine_half_cos);
  const double sine_twice = sine_half_sin + sine_half_sin, sine_slope1 = KSL_MUL(sine_half_cos, c),
      sine_slope2 = KSL_MUL(sine_half_sin, sine), sine_slope = sine_slope1 - sine_slope2,
      sine_more = KSL_MUL(sine_slope, sine_twice), sine_lo = sine_own_error + sine_more;
  const double c_slope1 = KSL_MUL(sine_half_cos, sine), c_slope2 = KSL_MUL(sine_half_sin, c),
      c_slope = c_slope1 + c_slope2, c_more = KSL_MUL(c_slope, sine_twice),
      c_lo = c_own_error - c_more;
  const double sinc_divisor = sine_of_half_angle < 1.4901161193847656e-08 ? 1.4901161193847656e-08 :
      sine_of_half_angle,
      sinc_divisor_lo = sine_of_half_angle < 1.4901161193847656e-08 ? 0.0 : sine_of_half_angle_lo;
  const double sinc_quotient_of_sine = sine + sine_lo,
      sinc_quotient_of_sine_right = sinc_quotient_of_sine - sine,
      sinc_quotient_of_sine_left = sinc_quotient_of_sine - sinc_quotient_of_sine_right,
      sinc_quotient_of_sine_left_rest = sine - sinc_quotient_of_sine_left,
      sinc_quotient_of_sine_right_rest = sine_lo - sinc_quotient_of_sine_right,
      sinc_quotient_of_sine_lo = sinc_quotient_of_sine_left_rest + sinc_quotient_of_sine_right_rest,
      sinc_quotient_of_sinc_divisor = sinc_divisor + sinc_divisor_lo,
      sinc_quotient_of_sinc_divisor_right = sinc_quotient_of_sinc_divisor - sinc_divisor,
      sinc_quotient_of_sinc_divisor_left = sinc_quotient_of_sinc_divisor -
          sinc_quotient_of_sinc_divisor_right,
      sinc_quotient_of_sinc_divisor_left_rest = sinc_divisor - sinc_quotient_of_sinc_divisor_left,
      sinc_quotient_of_sinc_divisor_right_rest = sinc_divisor_lo -
          sinc_quotient_of_sinc_divisor_right,
      sinc_quotient_of_sinc_divisor_lo = sinc_quotient_of_sinc_divisor_left_rest +
          sinc_quotient_of_sinc_divisor_right_rest,
      sinc_quotient = sinc_quotient_of_sine / sinc_quotient_of_sinc_divisor,
      sinc_quotient_product = KSL_MUL(sinc_quotient, sinc_quotient_of_sinc_divisor),
      sinc_quotient_product_error = ksl_product_error(sinc_quotient, sinc_quotient_of_sinc_divisor,
          sinc_quotient_product),
      sinc_quotient_rest = sinc_quotient_of_sine - sinc_quotient_product,
      sinc_quotient_exact = sinc_quotient_rest - sinc_quotient_product_error,
      sinc_quotient_numerator = sinc_quotient_exact + sinc_quotient_of_sine_lo,
      sinc_quotient_cross = KSL_MUL(sinc_quotient, sinc_quotient_of_sinc_divisor_lo),
      sinc_quotient_residual = sinc_quotient_numerator - sinc_quotient_cross,
      sinc_quotient_lo = sinc_quotient_residual / sinc_quotient_of_sinc_divisor;
  const double sinc_a = KSL_MUL(0.16666666666666666, half_angle_of_y),
      sinc_a_cross1 = KSL_MUL(9.25185853854297e-18, half_angle_of_y),
      sinc_a_cross2 = KSL_MUL(0.16666666666666666, half_angle_of_y_lo),
      sinc_a_cross = sinc_a_cross1 + sinc_a_cross2, sinc_b = 1.0 - sinc_a,
      sinc_b_right = 1.0 - sinc_b, sinc_b_left = sinc_b + sinc_b_right,
      sinc_b_left_rest = 1.0 - sinc_b_left,
      sinc_b_right_rest = ksl_product_rest(0.16666666666666666, half_angle_of_y, sinc_a,
          sinc_b_right),
      sinc_b_lo1 = sinc_b_left_rest - sinc_b_right_rest, sinc_b_lo = sinc_b_lo1 - sinc_a_cross,
      sinc = sine_of_half_angle < 1.4901161193847656e-08 ? sinc_b : sinc_quotient,
      sinc_lo = sine_of_half_angle < 1.4901161193847656e-08 ? sinc_b_lo : sinc_quotient_lo;
  const double g1 = KSL_MUL(c, sinc), g1_cross1 = KSL_MUL(c_lo, sinc),
      g1_cross2 = KSL_MUL(c, sinc_lo), g1_cross = g1_cross1 + g1_cross2;
  const double g2a = KSL_MUL(sinc, sinc), g2a_cross1 = KSL_MUL(sinc_lo, sinc),
      g2a_cross2 = KSL_MUL(sinc, sinc_lo), g2a_cross = g2a_cross1 + g2a_cross2,
      g2a_error = ksl_product_error(sinc, sinc, g2a), g2a_lo = g2a_error + g2a_cross,
      g2 = KSL_MUL(0.5, g2a), g2_cross2 = KSL_MUL(0.5, g2a_lo);
  const double rest3 = 1.0 - g1, rest3_right = 1.0 - rest3, rest3_left = rest3 + rest3_right,
      rest3_left_rest = 1.0 - rest3_left,
      rest3_right_rest = ksl_product_rest(c, sinc, g1, rest3_right),
      rest3_lo1 = rest3_left_rest - rest3_right_rest, rest3_lo = rest3_lo1 - g1_cross;
  const double x = KSL_MUL(4.0, half_angle_of_y), x_cross2 = KSL_MUL(4.0, half_angle_of_y_lo);
  const double far_x_a_of_x = x + x_cross2, far_x_a_of_x_right = far_x_a_of_x - x,
      far_x_a_of_x_left = far_x_a_of_x - far_x_a_of_x_right,
      far_x_a_of_x_left_rest = x - far_x_a_of_x_left,
      far_x_a_of_x_right_rest = x_cross2 - far_x_a_of_x_right,
      far_x_a_of_x_lo = far_x_a_of_x_left_rest + far_x_a_of_x_right_rest,
      far_x = far_x_a_of_x < 1.0 ? 1.0 : far_x_a_of_x,
      far_x_lo = far_x_a_of_x < 1.0 ? 0.0 : far_x_a_of_x_lo;
  const double closed3_of_rest3 = rest3 + rest3_lo,
      closed3_of_rest3_right = closed3_of_rest3 - rest3,
      closed3_of_rest3_left = closed3_of_rest3 - closed3_of_rest3_right,
      closed3_of_rest3_left_rest = rest3 - closed3_of_rest3_left,
      closed3_of_rest3_right_rest = rest3_lo - closed3_of_rest3_right,
      closed3_of_rest3_lo = closed3_of_rest3_left_rest + closed3_of_rest3_right_rest,
      closed3_of_far_x = far_x + far_x_lo, closed3_of_far_x_right = closed3_of_far_x - far_x,
      closed3_of_far_x_left = closed3_of_far_x - closed3_of_far_x_right,
      closed3_of_far_x_left_rest = far_x - closed3_of_far_x_left,
      closed3_of_far_x_right_rest = far_x_lo - closed3_of_far_x_right,
      closed3_of_far_x_lo = closed3_of_far_x_left_rest + closed3_of_far_x_right_rest,
      closed3 = closed3_of_rest3 / closed3_of_far_x,
      closed3_product = KSL_MUL(closed3, closed3_of_far_x),
      closed3_product_error = ksl_product_error(closed3, closed3_of_far_x, closed3_product),
      closed3_rest = closed3_of_rest3 - closed3_product,
      closed3_exact = closed3_rest - closed3_product_error,
      closed3_numerator = closed3_exact + closed3_of_rest3_lo,
      closed3_cross = KSL_MUL(closed3, closed3_of_far_x_lo),
      closed3_residual = closed3_numerator - closed3_cross,
      closed3_lo = closed3_residual / closed3_of_far_x;
  const double series5a = KSL_MUL(1.216125041553518e-34, far_x_a_of_x),
      series5a_cross1 = KSL_MUL(5.586290567888806e-51, far_x_a_of_x),
      series5a_cross2 = KSL_MUL(1.216125041553518e-34, far_x_a_of_x_lo),
      series5a_cross = series5a_cross1 + series5a_cross2,
      series5b = 1.1309962886447716e-31 - series5a,
      series5b_right = 1.1309962886447716e-31 - series5b, series5b_left = series5b + series5b_right,
      series5b_left_rest = 1.1309962886447716e-31 - series5b_left,
      series5b_right_rest = ksl_product_rest(1.216125041553518e-34, far_x_a_of_x, series5a,
          series5b_right),
      series5b_lo1 = series5b_left_rest - series5b_right_rest,
      series5b_lo2 = series5b_lo1 - series5a_cross,
      series5b_lo = series5b_lo2 + 1.0498015412959506e-47,
      series5c = KSL_MUL(far_x_a_of_x, series5b),
      series5c_cross1 = KSL_MUL(far_x_a_of_x_lo, series5b),
      series5c_cross2 = KSL_MUL(far_x_a_of_x, series5b_lo),
      series5c_cross = series5c_cross1 + series5c_cross2,
      series5d = series5c - 9.183689863795546e-29, series5d_right = series5c - series5d,
      series5d_left = series5d + series5d_right,
      series5d_left_rest = ksl_product_rest(far_x_a_of_x, series5b, series5c, series5d_left),
      series5d_right_rest = 9.183689863795546e-29 - series5d_right,
      series5d_lo1 = series5d_left_rest - series5d_right_rest,
      series5d_lo2 = series5d_lo1 - 1.4303150396787322e-45,
      series5d_lo = series5d_lo2 + series5c_cross, series5e = KSL_MUL(far_x_a_of_x, series5d),
      series5e_cross1 = KSL_MUL(far_x_a_of_x_lo, series5d),
      series5e_cross2 = KSL_MUL(far_x_a_of_x, series5d_lo),
      series5e_cross = series5e_cross1 + series5e_cross2,
      series5f = series5e + 6.446950284384474e-26, series5f_right = series5f - series5e,
      series5f_left = series5f - series5f_right,
      series5f_left_rest = ksl_product_rest(far_x_a_of_x, series5d, series5e, series5f_left),
      series5f_right_rest = 6.446950284384474e-26 - series5f_right,
      series5f_lo1 = series5f_left_rest + series5f_right_rest,
      series5f_lo2 = series5f_lo1 + -1.9330404233703465e-42,
      series5f_lo = series5f_lo2 + series5e_cross, series5g = KSL_MUL(far_x_a_of_x, series5f),
      series5g_cross1 = KSL_MUL(far_x_a_of_x_lo, series5f),
      series5g_cross2 = KSL_MUL(far_x_a_of_x, series5f_lo),
      series5g_cross = series5g_cross1 + series5g_cross2,
      series5h = series5g - 3.868170170630684e-23, series5h_right = series5g - series5h,
      series5h_left = series5h + series5h_right,
      series5h_left_rest = ksl_product_rest(far_x_a_of_x, series5f, series5g, series5h_left),
      series5h_right_rest = 3.868170170630684e-23 - series5h_right,
      series5h_lo1 = series5h_left_rest - series5h_right_rest,
      series5h_lo2 = series5h_lo1 - -8.843177655482344e-40,
      series5h_lo = series5h_lo2 + series5g_cross, series5i = KSL_MUL(far_x_a_of_x, series5h),
      series5i_cross1 = KSL_MUL(far_x_a_of_x_lo, series5h),
      series5i_cross2 = KSL_MUL(far_x_a_of_x, series5h_lo),
      series5i_cross = series5i_cross1 + series5i_cross2,
      series5j = series5i + 1.9572941063391263e-20, series5j_right = series5j - series5i,
      series5j_left = series5j - series5j_right,
      series5j_left_rest = ksl_product_rest(far_x_a_of_x, series5h, series5i, series5j_left),
      series5j_right_rest = 1.9572941063391263e-20 - series5j_right,
      series5j_lo1 = series5j_left_rest + series5j_right_rest,
      series5j_lo2 = series5j_lo1 + -1.3643503830087908e-36,
      series5j_lo = series5j_lo2 + series5i_cross, series5k = KSL_MUL(far_x_a_of_x, series5j),
      series5k_cross1 = KSL_MUL(far_x_a_of_x_lo, series5j),
      series5k_cross2 = KSL_MUL(far_x_a_of_x, series5j_lo),
      series5k_cross = series5k_cross1 + series5k_cross2,
      series5l = series5k - 8.22063524662433e-18, series5l_right = series5k - series5l,
      series5l_left = series5l + series5l_right,
      series5l_left_rest = ksl_product_rest(far_x_a_of_x, series5j, series5k, series5l_left),
      series5l_right_rest = 8.22063524662433e-18 - series5l_right,
      series5l_lo1 = series5l_left_rest - series5l_right_rest,
      series5l_lo2 = series5l_lo1 - 2.2141894119604265e-34,
      series5l_lo = series5l_lo2 + series5k_cross, series5m = KSL_MUL(far_x_a_of_x, series5l),
      series5m_cross1 = KSL_MUL(far_x_a_of_x_lo, series5l),
      series5m_cross2 = KSL_MUL(far_x_a_of_x, series5l_lo),
      series5m_cross = series5m_cross1 + series5m_cross2,
      series5n = series5m + 2.8114572543455206e-15, series5n_right = series5n - series5m,
      series5n_left = series5n - series5n_right,
      series5n_left_rest = ksl_product_rest(far_x_a_of_x, series5l, series5m, series5n_left),
      series5n_right_rest = 2.8114572543455206e-15 - series5n_right,
      series5n_lo1 = series5n_left_rest + series5n_right_rest,
      series5n_lo2 = series5n_lo1 + 1.6508842730861433e-31,
      series5n_lo = series5n_lo2 + series5m_cross, series5o = KSL_MUL(far_x_a_of_x, series5n),
      series5o_cross1 = KSL_MUL(far_x_a_of_x_lo, series5n),
      series5o_cross2 = KSL_MUL(far_x_a_of_x, series5n_lo),
      series5o_cross = series5o_cross1 + series5o_cross2,
      series5p = series5o - 7.647163731819816e-13, series5p_right = series5o - series5p,
      series5p_left = series5p + series5p_right,
      series5p_left_rest = ksl_product_rest(far_x_a_of_x, series5n, series5o, series5p_left),
      series5p_right_rest = 7.647163731819816e-13 - series5p_right,
      series5p_lo1 = series5p_left_rest - series5p_right_rest,
      series5p_lo2 = series5p_lo1 - 7.03872877733453e-30,
      series5p_lo = series5p_lo2 + series5o_cross, series5q = KSL_MUL(far_x_a_of_x, series5p),
      series5q_cross1 = KSL_MUL(far_x_a_of_x_lo, series5p),
      series5q_cross2 = KSL_MUL(far_x_a_of_x, series5p_lo),
      series5q_cross = series5q_cross1 + series5q_cross2,
      series5r = series5q + 1.6059043836821613e-10, series5r_right = series5r - series5q,
      series5r_left = series5r - series5r_right,
      series5r_left_rest = ksl_product_rest(far_x_a_of_x, series5p, series5q, series5r_left),
      series5r_right_rest = 1.6059043836821613e-10 - series5r_right,
      series5r_lo1 = series5r_left_rest + series5r_right_rest,
      series5r_lo2 = series5r_lo1 + 1.2585294588752098e-26,
      series5r_lo = series5r_lo2 + series5q_cross, series5s = KSL_MUL(far_x_a_of_x, series5r),
      series5s_cross1 = KSL_MUL(far_x_a_of_x_lo, series5r),
      series5s_cross2 = KSL_MUL(far_x_a_of_x, series5r_lo),
      series5s_cross = series5s_cross1 + series5s_cross2,
      series5t = series5s - 2.505210838544172e-08, series5t_right = series5s - series5t,
      series5t_left = series5t + series5t_right,
      series5t_left_rest = ksl_product_rest(far_x_a_of_x, series5r, series5s, series5t_left),
      series5t_right_rest = 2.505210838544172e-08 - series5t_right,
      series5t_lo1 = series5t_left_rest - series5t_right_rest,
      series5t_lo2 = series5t_lo1 - -1.448814070935912e-24,
      series5t_lo = series5t_lo2 + series5s_cross, series5u = KSL_MUL(far_x_a_of_x, series5t),
      series5u_cross1 = KSL_MUL(far_x_a_of_x_lo, series5t),
      series5u_cross2 = KSL_MUL(far_x_a_of_x, series5t_lo),
      series5u_cross = series5u_cross1 + series5u_cross2,
      series5v = series5u + 2.7557319223985893e-06, series5v_right = series5v - series5u,
      series5v_left = series5v - series5v_right,
      series5v_left_rest = ksl_product_rest(far_x_a_of_x, series5t, series5u, series5v_left),
      series5v_right_rest = 2.7557319223985893e-06 - series5v_right,
      series5v_lo1 = series5v_left_rest + series5v_right_rest,
      series5v_lo2 = series5v_lo1 + -1.858393274046472e-22,
      series5v_lo = series5v_lo2 + series5u_cross, series5w = KSL_MUL(far_x_a_of_x, series5v),
      series5w_cross1 = KSL_MUL(far_x_a_of_x_lo, series5v),
      series5w_cross2 = KSL_MUL(far_x_a_of_x, series5v_lo),
      series5w_cross = series5w_cross1 + series5w_cross2,
      series5x = series5w - 0.0001984126984126984, series5x_right = series5w - series5x,
      series5x_left = series5x + series5x_right,
      series5x_left_rest = ksl_product_rest(far_x_a_of_x, series5v, series5w, series5x_left),
      series5x_right_rest = 0.0001984126984126984 - series5x_right,
      series5x_lo1 = series5x_left_rest - series5x_right_rest,
      series5x_lo2 = series5x_lo1 - 1.7209558293420705e-22,
      series5x_lo = series5x_lo2 + series5w_cross, series5y = KSL_MUL(far_x_a_of_x, series5x),
      series5y_cross1 = KSL_MUL(far_x_a_of_x_lo, series5x),
      series5y_cross2 = KSL_MUL(far_x_a_of_x, series5x_lo),
      series5y_cross = series5y_cross1 + series5y_cross2, series5 = series5y + 0.008333333333333333,
      series5_right = series5 - series5y, series5_left = series5 - series5_right,
      series5_left_rest = ksl_product_rest(far_x_a_of_x, series5x, series5y, series5_left),
      series5_right_rest = 0.008333333333333333 - series5_right,
      series5_lo1 = series5_left_rest + series5_right_rest,
      series5_lo2 = series5_lo1 + 1.1564823173178714e-19, series5_lo = series5_lo2 + series5y_cross;
  const double g3a = KSL_MUL(far_x_a_of_x, series5), g3a_cross1 = KSL_MUL(far_x_a_of_x_lo, series5),
      g3a_cross2 = KSL_MUL(far_x_a_of_x, series5_lo), g3a_cross = g3a_cross1 + g3a_cross2,
      g3b = 0.16666666666666666 - g3a, g3b_right = 0.16666666666666666 - g3b,
      g3b_left = g3b + g3b_right, g3b_left_rest = 0.16666666666666666 - g3b_left,
      g3b_right_rest = ksl_product_rest(far_x_a_of_x, series5, g3a, g3b_right),
      g3b_lo1 = g3b_left_rest - g3b_right_rest, g3b_lo2 = g3b_lo1 - g3a_cross,
      g3b_lo = g3b_lo2 + 9.25185853854297e-18, g3 = far_x_a_of_x < 1.0 ? g3b : closed3,
      g3_lo = far_x_a_of_x < 1.0 ? g3b_lo : closed3_lo;
  const double rest4 = 0.5 - g2, rest4_right = 0.5 - rest4, rest4_left = rest4 + rest4_right,
      rest4_left_rest = 0.5 - rest4_left, rest4_right_rest = g2 - rest4_right,
      rest4_lo1 = rest4_left_rest - rest4_right_rest, rest4_lo = rest4_lo1 - g2_cross2;
  const double closed4_of_rest4 = rest4 + rest4_lo,
      closed4_of_rest4_right = closed4_of_rest4 - rest4,
      closed4_of_rest4_left = closed4_of_rest4 - closed4_of_rest4_right,
      closed4_of_rest4_left_rest = rest4 - closed4_of_rest4_left,
      closed4_of_rest4_right_rest = rest4_lo - closed4_of_rest4_right,
      closed4_of_rest4_lo = closed4_of_rest4_left_rest + closed4_of_rest4_right_rest,
      closed4 = closed4_of_rest4 / closed3_of_far_x,
      closed4_product = KSL_MUL(closed4, closed3_of_far_x),
      closed4_product_error = ksl_product_error(closed4, closed3_of_far_x, closed4_product),
      closed4_rest = closed4_of_rest4 - closed4_product,
      closed4_exact = closed4_rest - closed4_product_error,
      closed4_numerator = closed4_exact + closed4_of_rest4_lo,
      closed4_cross = KSL_MUL(closed4, closed3_of_far_x_lo),
      closed4_residual = closed4_numerator - closed4_cross,
      closed4_lo = closed4_residual / closed3_of_far_x;
  const double rest5 = 0.16666666666666666 - g3, rest5_right = 0.16666666666666666 - rest5,
      rest5_left = rest5 + rest5_right, rest5_left_rest = 0.16666666666666666 - rest5_left,
      rest5_right_rest = g3 - rest5_right, rest5_lo1 = rest5_left_rest - rest5_right_rest,
      rest5_lo2 = rest5_lo1 - g3_lo, rest5_lo = rest5_lo2 + 9.25185853854297e-18;
  const double closed5_of_rest5 = rest5 + rest5_lo,
      closed5_of_rest5_right = closed5_of_rest5 - rest5,
      closed5_of_rest5_left = closed5_of_rest5 - closed5_of_rest5_right,
      closed5_of_rest5_left_rest = rest5 - closed5_of_rest5_left,
      closed5_of_rest5_right_rest = rest5_lo - closed5_of_rest5_right,
      closed5_of_rest5_lo = closed5_of_rest5_left_rest + closed5_of_rest5_right_rest,
      closed5 = closed5_of_rest5 / closed3_of_far_x,
      closed5_product = KSL_MUL(closed5, closed3_of_far_x),
      closed5_product_error = ksl_product_error(closed5, closed3_of_far_x, closed5_product),
      closed5_rest = closed5_of_rest5 - closed5_product,
      closed5_exact = closed5_rest - closed5_product_error,
      closed5_numerator = closed5_exact + closed5_of_rest5_lo,
      closed5_cross = KSL_MUL(closed5, closed3_of_far_x_lo),
      closed5_residual = closed5_numerator - closed5_cross,
      closed5_lo = closed5_residual / closed3_of_far_x;
  const double series4a = KSL_MUL(3.7699876288159054e-33, far_x_a_of_x),
      series4a_cross1 = KSL_MUL(2.5870347832750324e-49, far_x_a_of_x),
      series4a_cross2 = KSL_MUL(3.7699876288159054e-33, far_x_a_of_x_lo),
      series4a_cross = series4a_cross1 + series4a_cross2,
      series4b = 3.279889237069838e-30 - series4a,
      series4b_right = 3.279889237069838e-30 - series4b, series4b_left = series4b + series4b_right,
      series4b_left_rest = 3.279889237069838e-30 - series4b_left,
      series4b_right_rest = ksl_product_rest(3.7699876288159054e-33, far_x_a_of_x, series4a,
          series4b_right),
      series4b_lo1 = series4b_left_rest - series4b_right_rest,
      series4b_lo2 = series4b_lo1 - series4a_cross,
      series4b_lo = series4b_lo2 + 1.5117542744029879e-46,
      series4c = KSL_MUL(far_x_a_of_x, series4b),
      series4c_cross1 = KSL_MUL(far_x_a_of_x_lo, series4b),
      series4c_cross2 = KSL_MUL(far_x_a_of_x, series4b_lo),
      series4c_cross = series4c_cross1 + series4c_cross2,
      series4d = series4c - 2.4795962632247976e-27, series4d_right = series4c - series4d,
      series4d_left = series4d + series4d_right,
      series4d_left_rest = ksl_product_rest(far_x_a_of_x, series4b, series4c, series4d_left),
      series4d_right_rest = 2.4795962632247976e-27 - series4d_right,
      series4d_lo1 = series4d_left_rest - series4d_right_rest,
      series4d_lo2 = series4d_lo1 - -1.2953730964765229e-43,
      series4d_lo = series4d_lo2 + series4c_cross, series4e = KSL_MUL(far_x_a_of_x, series4d),
      series4e_cross1 = KSL_MUL(far_x_a_of_x_lo, series4d),
      series4e_cross2 = KSL_MUL(far_x_a_of_x, series4d_lo),
      series4e_cross = series4e_cross1 + series4e_cross2,
      series4f = series4e + 1.6117375710961184e-24, series4f_right = series4f - series4e,
      series4f_left = series4f - series4f_right,
      series4f_left_rest = ksl_product_rest(far_x_a_of_x, series4d, series4e, series4f_left),
      series4f_right_rest = 1.6117375710961184e-24 - series4f_right,
      series4f_lo1 = series4f_left_rest + series4f_right_rest,
      series4f_lo2 = series4f_lo1 + -3.6846573564509766e-41,
      series4f_lo = series4f_lo2 + series4e_cross, series4g = KSL_MUL(far_x_a_of_x, series4f),
      series4g_cross1 = KSL_MUL(far_x_a_of_x_lo, series4f),
      series4g_cross2 = KSL_MUL(far_x_a_of_x, series4f_lo),
      series4g_cross = series4g_cross1 + series4g_cross2,
      series4h = series4g - 8.896791392450574e-22, series4h_right = series4g - series4h,
      series4h_left = series4h + series4h_right,
      series4h_left_rest = ksl_product_rest(far_x_a_of_x, series4f, series4g, series4h_left),
      series4h_right_rest = 8.896791392450574e-22 - series4h_right,
      series4h_lo1 = series4h_left_rest - series4h_right_rest,
      series4h_lo2 = series4h_lo1 - -7.911402614872376e-38,
      series4h_lo = series4h_lo2 + series4g_cross, series4i = KSL_MUL(far_x_a_of_x, series4h),
      series4i_cross1 = KSL_MUL(far_x_a_of_x_lo, series4h),
      series4i_cross2 = KSL_MUL(far_x_a_of_x, series4h_lo),
      series4i_cross = series4i_cross1 + series4i_cross2,
      series4j = series4i + 4.110317623312165e-19, series4j_right = series4j - series4i,
      series4j_left = series4j - series4j_right,
      series4j_left_rest = ksl_product_rest(far_x_a_of_x, series4h, series4i, series4j_left),
      series4j_right_rest = 4.110317623312165e-19 - series4j_right,
      series4j_lo1 = series4j_left_rest + series4j_right_rest,
      series4j_lo2 = series4j_lo1 + 1.4412973378659527e-36,
      series4j_lo = series4j_lo2 + series4i_cross, series4k = KSL_MUL(far_x_a_of_x, series4j),
      series4k_cross1 = KSL_MUL(far_x_a_of_x_lo, series4j),
      series4k_cross2 = KSL_MUL(far_x_a_of_x, series4j_lo),
      series4k_cross = series4k_cross1 + series4k_cross2,
      series4l = series4k - 1.5619206968586225e-16, series4l_right = series4k - series4l,
      series4l_left = series4l + series4l_right,
      series4l_left_rest = ksl_product_rest(far_x_a_of_x, series4j, series4k, series4l_left),
      series4l_right_rest = 1.5619206968586225e-16 - series4l_right,
      series4l_lo1 = series4l_left_rest - series4l_right_rest,
      series4l_lo2 = series4l_lo1 - 1.1910679660273754e-32,
      series4l_lo = series4l_lo2 + series4k_cross, series4m = KSL_MUL(far_x_a_of_x, series4l),
      series4m_cross1 = KSL_MUL(far_x_a_of_x_lo, series4l),
      series4m_cross2 = KSL_MUL(far_x_a_of_x, series4l_lo),
      series4m_cross = series4m_cross1 + series4m_cross2,
      series4n = series4m + 4.779477332387385e-14, series4n_right = series4n - series4m,
      series4n_left = series4n - series4n_right,
      series4n_left_rest = ksl_product_rest(far_x_a_of_x, series4l, series4m, series4n_left),
      series4n_right_rest = 4.779477332387385e-14 - series4n_right,
      series4n_lo1 = series4n_left_rest + series4n_right_rest,
      series4n_lo2 = series4n_lo1 + 4.399205485834081e-31,
      series4n_lo = series4n_lo2 + series4m_cross, series4o = KSL_MUL(far_x_a_of_x, series4n),
      series4o_cross1 = KSL_MUL(far_x_a_of_x_lo, series4n),
      series4o_cross2 = KSL_MUL(far_x_a_of_x, series4n_lo),
      series4o_cross = series4o_cross1 + series4o_cross2,
      series4p = series4o - 1.1470745597729725e-11, series4p_right = series4o - series4p,
      series4p_left = series4p + series4p_right,
      series4p_left_rest = ksl_product_rest(far_x_a_of_x, series4n, series4o, series4p_left),
      series4p_right_rest = 1.1470745597729725e-11 - series4p_right,
      series4p_lo1 = series4p_left_rest - series4p_right_rest,
      series4p_lo2 = series4p_lo1 - 2.0655512752830745e-28,
      series4p_lo = series4p_lo2 + series4o_cross, series4q = KSL_MUL(far_x_a_of_x, series4p),
      series4q_cross1 = KSL_MUL(far_x_a_of_x_lo, series4p),
      series4q_cross2 = KSL_MUL(far_x_a_of_x, series4p_lo),
      series4q_cross = series4q_cross1 + series4q_cross2,
      series4r = series4q + 2.08767569878681e-09, series4r_right = series4r - series4q,
      series4r_left = series4r - series4r_right,
      series4r_left_rest = ksl_product_rest(far_x_a_of_x, series4p, series4q, series4r_left),
      series4r_right_rest = 2.08767569878681e-09 - series4r_right,
      series4r_lo1 = series4r_left_rest + series4r_right_rest,
      series4r_lo2 = series4r_lo1 + -1.20734505911326e-25,
      series4r_lo = series4r_lo2 + series4q_cross, series4s = KSL_MUL(far_x_a_of_x, series4r),
      series4s_cross1 = KSL_MUL(far_x_a_of_x_lo, series4r),
      series4s_cross2 = KSL_MUL(far_x_a_of_x, series4r_lo),
      series4s_cross = series4s_cross1 + series4s_cross2,
      series4t = series4s - 2.755731922398589e-07, series4t_right = series4s - series4t,
      series4t_left = series4t + series4t_right,
      series4t_left_rest = ksl_product_rest(far_x_a_of_x, series4r, series4s, series4t_left),
      series4t_right_rest = 2.755731922398589e-07 - series4t_right,
      series4t_lo1 = series4t_left_rest - series4t_right_rest,
      series4t_lo2 = series4t_lo1 - 2.3767714622250297e-23,
      series4t_lo = series4t_lo2 + series4s_cross, series4u = KSL_MUL(far_x_a_of_x, series4t),
      series4u_cross1 = KSL_MUL(far_x_a_of_x_lo, series4t),
      series4u_cross2 = KSL_MUL(far_x_a_of_x, series4t_lo),
      series4u_cross = series4u_cross1 + series4u_cross2,
      series4v = series4u + 2.48015873015873e-05, series4v_right = series4v - series4u,
      series4v_left = series4v - series4v_right,
      series4v_left_rest = ksl_product_rest(far_x_a_of_x, series4t, series4u, series4v_left),
      series4v_right_rest = 2.48015873015873e-05 - series4v_right,
      series4v_lo1 = series4v_left_rest + series4v_right_rest,
      series4v_lo2 = series4v_lo1 + 2.1511947866775882e-23,
      series4v_lo = series4v_lo2 + series4u_cross, series4w = KSL_MUL(far_x_a_of_x, series4v),
      series4w_cross1 = KSL_MUL(far_x_a_of_x_lo, series4v),
      series4w_cross2 = KSL_MUL(far_x_a_of_x, series4v_lo),
      series4w_cross = series4w_cross1 + series4w_cross2,
      series4x = series4w - 0.001388888888888889, series4x_right = series4w - series4x,
      series4x_left = series4x + series4x_right,
      series4x_left_rest = ksl_product_rest(far_x_a_of_x, series4v, series4w, series4x_left),
      series4x_right_rest = 0.001388888888888889 - series4x_right,
      series4x_lo1 = series4x_left_rest - series4x_right_rest,
      series4x_lo2 = series4x_lo1 - -5.300543954373577e-20,
      series4x_lo = series4x_lo2 + series4w_cross, series4y = KSL_MUL(far_x_a_of_x, series4x),
      series4y_cross1 = KSL_MUL(far_x_a_of_x_lo, series4x),
      series4y_cross2 = KSL_MUL(far_x_a_of_x, series4x_lo),
      series4y_cross = series4y_cross1 + series4y_cross2, series4 = series4y + 0.041666666666666664,
      series4_right = series4 - series4y, series4_left = series4 - series4_right,
      series4_left_rest = ksl_product_rest(far_x_a_of_x, series4x, series4y, series4_left),
      series4_right_rest = 0.041666666666666664 - series4_right,
      series4_lo1 = series4_left_rest + series4_right_rest,
      series4_lo2 = series4_lo1 + 2.3129646346357427e-18, series4_lo = series4_lo2 + series4y_cross;
  const double g4 = far_x_a_of_x < 1.0 ? series4 : closed4,
      g4_lo = far_x_a_of_x < 1.0 ? series4_lo : closed4_lo;
  const double g5 = far_x_a_of_x < 1.0 ? series5 : closed5,
      g5_lo = far_x_a_of_x < 1.0 ? series5_lo : closed5_lo;
  const double rate2a = KSL_MUL(2.0, g4), rate2a_cross2 = KSL_MUL(2.0, g4_lo), rate2 = rate2a - g3,
      rate2_right = rate2a - rate2, rate2_left = rate2 + rate2_right,
      rate2_left_rest = rate2a - rate2_left, rate2_right_rest = g3 - rate2_right,
      rate2_lo1 = rate2_left_rest - rate2_right_rest, rate2_lo2 = rate2_lo1 - g3_lo,
      rate2_lo = rate2_lo2 + rate2a_cross2;
  const double rate3a = KSL_MUL(3.0, g5), rate3a_cross2 = KSL_MUL(3.0, g5_lo), rate3 = rate3a - g4,
      rate3_right = rate3a - rate3, rate3_left = rate3 + rate3_right,
      rate3_left_rest = ksl_product_rest(3.0, g5, rate3a, rate3_left),
      rate3_right_rest = g4 - rate3_right, rate3_lo1 = rate3_left_rest - rate3_right_rest,
      rate3_lo2 = rate3_lo1 - g4_lo, rate3_lo = rate3_lo2 + rate3a_cross2;
  const double beta_v_0 = KSL_MUL(s->m3, g3), beta_v_0_cross2 = KSL_MUL(s->m3, g3_lo);
  const double beta_v_1 = KSL_MUL(s->m4, g3), beta_v_1_cross2 = KSL_MUL(s->m4, g3_lo);
  const double beta_v_2 = KSL_MUL(s->m5, g3), beta_v_2_cross2 = KSL_MUL(s->m5, g3_lo);
  const double beta_v_0_error = ksl_product_error(s->m3, g3, beta_v_0),
      beta_v_0_lo = beta_v_0_error + beta_v_0_cross2, m_0 = KSL_MUL(s->m3, beta_v_0),
      m_0_cross2 = KSL_MUL(s->m3, beta_v_0_lo);
  const double beta_v_1_error = ksl_product_error(s->m4, g3, beta_v_1),
      beta_v_1_lo = beta_v_1_error + beta_v_1_cross2, m_1 = KSL_MUL(s->m4, beta_v_1),
      m_1_cross2 = KSL_MUL(s->m4, beta_v_1_lo);
  const double beta_v_2_error = ksl_product_error(s->m5, g3, beta_v_2),
      beta_v_2_lo = beta_v_2_error + beta_v_2_cross2, m_2 = KSL_MUL(s->m5, beta_v_2),
      m_2_cross2 = KSL_MUL(s->m5, beta_v_2_lo);
  const double m_3 = KSL_MUL(s->m4, beta_v_0), m_3_cross2 = KSL_MUL(s->m4, beta_v_0_lo);
  const double m_4 = KSL_MUL(s->m5, beta_v_0), m_4_cross2 = KSL_MUL(s->m5, beta_v_0_lo);
  const double m_5 = KSL_MUL(s->m5, beta_v_1), m_5_cross2 = KSL_MUL(s->m5, beta_v_1_lo);
  const double others_0 = m_1 + m_2, others_0_right = others_0 - m_1,
      others_0_left = others_0 - others_0_right,
      others_0_left_rest = ksl_product_rest(s->m4, beta_v_1, m_1, others_0_left),
      others_0_right_rest = ksl_product_rest(s->m5, beta_v_2, m_2, others_0_right),
      others_0_cross = m_1_cross2 + m_2_cross2,
      others_0_lo1 = others_0_left_rest + others_0_right_rest,
      others_0_lo = others_0_lo1 + others_0_cross;
  const double others_1 = m_0 + m_2, others_1_right = others_1 - m_0,
      others_1_left = others_1 - others_1_right,
      others_1_left_rest = ksl_product_rest(s->m3, beta_v_0, m_0, others_1_left),
      others_1_right_rest = ksl_product_rest(s->m5, beta_v_2, m_2, others_1_right),
      others_1_cross = m_0_cross2 + m_2_cross2,
      others_1_lo1 = others_1_left_rest + others_1_right_rest,
      others_1_lo = others_1_lo1 + others_1_cross;
  const double others_2 = m_0 + m_1, others_2_right = others_2 - m_0,
      others_2_left = others_2 - others_2_right,
      others_2_left_rest = ksl_product_rest(s->m3, beta_v_0, m_0, others_2_left),
      others_2_right_rest = ksl_product_rest(s->m4, beta_v_1, m_1, others_2_right),
      others_2_cross = m_0_cross2 + m_1_cross2,
      others_2_lo1 = others_2_left_rest + others_2_right_rest,
      others_2_lo = others_2_lo1 + others_2_cross;
  const double diagonal0a = 1.0 - others_0, diagonal0a_right = 1.0 - diagonal0a,
      diagonal0a_left = diagonal0a + diagonal0a_right, diagonal0a_left_rest = 1.0 - diagonal0a_left,
      diagonal0a_right_rest = others_0 - diagonal0a_right,
      diagonal0a_lo1 = diagonal0a_left_rest - diagonal0a_right_rest,
      diagonal0a_lo = diagonal0a_lo1 - others_0_lo, diagonal0b = g1 + m_0,
      diagonal0b_right = diagonal0b - g1, diagonal0b_left = diagonal0b - diagonal0b_right,
      diagonal0b_left_rest = ksl_product_rest(c, sinc, g1, diagonal0b_left),
      diagonal0b_right_rest = ksl_product_rest(s->m3, beta_v_0, m_0, diagonal0b_right),
      diagonal0b_cross = g1_cross + m_0_cross2,
      diagonal0b_lo1 = diagonal0b_left_rest + diagonal0b_right_rest,
      diagonal0b_lo = diagonal0b_lo1 + diagonal0b_cross,
      m_0_error = ksl_product_error(s->m3, beta_v_0, m_0), m_0_lo = m_0_error + m_0_cross2,
      diagonal0c_of_m_0 = m_0 + m_0_lo, diagonal0c_of_others_0 = others_0 + others_0_lo,
      diagonal0 = diagonal0c_of_m_0 < diagonal0c_of_others_0 ? diagonal0b : diagonal0a,
      diagonal0_lo = diagonal0c_of_m_0 < diagonal0c_of_others_0 ? diagonal0b_lo : diagonal0a_lo;
  const double diagonal1a = 1.0 - others_1, diagonal1a_right = 1.0 - diagonal1a,
      diagonal1a_left = diagonal1a + diagonal1a_right, diagonal1a_left_rest = 1.0 - diagonal1a_left,
      diagonal1a_right_rest = others_1 - diagonal1a_right,
      diagonal1a_lo1 = diagonal1a_left_rest - diagonal1a_right_rest,
      diagonal1a_lo = diagonal1a_lo1 - others_1_lo, diagonal1b = g1 + m_1,
      diagonal1b_right = diagonal1b - g1, diagonal1b_left = diagonal1b - diagonal1b_right,
      diagonal1b_left_rest = ksl_product_rest(c, sinc, g1, diagonal1b_left),
      diagonal1b_right_rest = ksl_product_rest(s->m4, beta_v_1, m_1, diagonal1b_right),
      diagonal1b_cross = g1_cross + m_1_cross2,
      diagonal1b_lo1 = diagonal1b_left_rest + diagonal1b_right_rest,
      diagonal1b_lo = diagonal1b_lo1 + diagonal1b_cross,
      m_1_error = ksl_product_error(s->m4, beta_v_1, m_1), m_1_lo = m_1_error + m_1_cross2,
      diagonal1c_of_m_1 = m_1 + m_1_lo, diagonal1c_of_others_1 = others_1 + others_1_lo,
      diagonal1 = diagonal1c_of_m_1 < diagonal1c_of_others_1 ? diagonal1b : diagonal1a,
      diagonal1_lo = diagonal1c_of_m_1 < diagonal1c_of_others_1 ? diagonal1b_lo : diagonal1a_lo;
  const double diagonal2a = 1.0 - others_2, diagonal2a_right = 1.0 - diagonal2a,
      diagonal2a_left = diagonal2a + diagonal2a_right, diagonal2a_left_rest = 1.0 - diagonal2a_left,
      diagonal2a_right_rest = others_2 - diagonal2a_right,
      diagonal2a_lo1 = diagonal2a_left_rest - diagonal2a_right_rest,
      diagonal2a_lo = diagonal2a_lo1 - others_2_lo, diagonal2b = g1 + m_2,
      diagonal2b_right = diagonal2b - g1, diagonal2b_left = diagonal2b - diagonal2b_right,
      diagonal2b_left_rest = ksl_product_rest(c, sinc, g1, diagonal2b_left),
      diagonal2b_right_rest = ksl_product_rest(s->m5, beta_v_2, m_2, diagonal2b_right),
      diagonal2b_cross = g1_cross + m_2_cross2,
      diagonal2b_lo1 = diagonal2b_left_rest + diagonal2b_right_rest,
      diagonal2b_lo = diagonal2b_lo1 + diagonal2b_cross,
      m_2_error = ksl_product_error(s->m5, beta_v_2, m_2), m_2_lo = m_2_error + m_2_cross2,
      diagonal2c_of_m_2 = m_2 + m_2_lo, diagonal2c_of_others_2 = others_2 + others_2_lo,
      diagonal2 = diagonal2c_of_m_2 < diagonal2c_of_others_2 ? diagonal2b : diagonal2a,
      diagonal2_lo = diagonal2c_of_m_2 < diagonal2c_of_others_2 ? diagonal2b_lo : diagonal2a_lo;
  const double alpha_v_0a = KSL_MUL(s->m3, g2), alpha_v_0a_cross2 = KSL_MUL(s->m3, g2_cross2),
      alpha_v_0 = -alpha_v_0a, alpha_v_0_cross = -alpha_v_0a_cross2, alpha_v_0_factor = -s->m3;
  const double alpha_v_1a = KSL_MUL(s->m4, g2), alpha_v_1a_cross2 = KSL_MUL(s->m4, g2_cross2),
      alpha_v_1 = -alpha_v_1a, alpha_v_1_cross = -alpha_v_1a_cross2, alpha_v_1_factor = -s->m4;
  const double alpha_v_2a = KSL_MUL(s->m5, g2), alpha_v_2a_cross2 = KSL_MUL(s->m5, g2_cross2),
      alpha_v_2 = -alpha_v_2a, alpha_v_2_cross = -alpha_v_2a_cross2, alpha_v_2_factor = -s->m5;
  const double J_1 = m_3 - alpha_v_2, J_1_right = m_3 - J_1, J_1_left = J_1 + J_1_right,
      J_1_left_rest = ksl_product_rest(s->m4, beta_v_0, m_3, J_1_left),
      J_1_right_rest = ksl_product_rest(alpha_v_2_factor, g2, alpha_v_2, J_1_right),
      J_1_cross = m_3_cross2 - alpha_v_2_cross, J_1_lo1 = J_1_left_rest - J_1_right_rest,
      J_1_lo = J_1_lo1 + J_1_cross;
  const double J_2 = m_4 + alpha_v_1, J_2_right = J_2 - m_4, J_2_left = J_2 - J_2_right,
      J_2_left_rest = ksl_product_rest(s->m5, beta_v_0, m_4, J_2_left),
      J_2_right_rest = ksl_product_rest(alpha_v_1_factor, g2, alpha_v_1, J_2_right),
      J_2_cross = m_4_cross2 + alpha_v_1_cross, J_2_lo1 = J_2_left_rest + J_2_right_rest,
      J_2_lo = J_2_lo1 + J_2_cross;
  const double J_3 = m_3 + alpha_v_2, J_3_right = J_3 - m_3, J_3_left = J_3 - J_3_right,
      J_3_left_rest = ksl_product_rest(s->m4, beta_v_0, m_3, J_3_left),
      J_3_right_rest = ksl_product_rest(alpha_v_2_factor, g2, alpha_v_2, J_3_right),
      J_3_cross = m_3_cross2 + alpha_v_2_cross, J_3_lo1 = J_3_left_rest + J_3_right_rest,
      J_3_lo = J_3_lo1 + J_3_cross;
  const double J_5 = m_5 - alpha_v_0, J_5_right = m_5 - J_5, J_5_left = J_5 + J_5_right,
      J_5_left_rest = ksl_product_rest(s->m5, beta_v_1, m_5, J_5_left),
      J_5_right_rest = ksl_product_rest(alpha_v_0_factor, g2, alpha_v_0, J_5_right),
      J_5_cross = m_5_cross2 - alpha_v_0_cross, J_5_lo1 = J_5_left_rest - J_5_right_rest,
      J_5_lo = J_5_lo1 + J_5_cross;
  const double J_6 = m_4 - alpha_v_1, J_6_right = m_4 - J_6, J_6_left = J_6 + J_6_right,
      J_6_left_rest = ksl_product_rest(s->m5, beta_v_0, m_4, J_6_left),
      J_6_right_rest = ksl_product_rest(alpha_v_1_factor, g2, alpha_v_1, J_6_right),
      J_6_cross = m_4_cross2 - alpha_v_1_cross, J_6_lo1 = J_6_left_rest - J_6_right_rest,
      J_6_lo = J_6_lo1 + J_6_cross;
  const double J_7 = m_5 + alpha_v_0, J_7_right = J_7 - m_5, J_7_left = J_7 - J_7_right,
      J_7_left_rest = ksl_product_rest(s->m5, beta_v_1, m_5, J_7_left),
      J_7_right_rest = ksl_product_rest(alpha_v_0_factor, g2, alpha_v_0, J_7_right),
      J_7_cross = m_5_cross2 + alpha_v_0_cross, J_7_lo1 = J_7_left_rest + J_7_right_rest,
      J_7_lo = J_7_lo1 + J_7_cross;
  const double rate_vw_a = KSL_MUL(s->m0, s->m3), rate_vw_b = KSL_MUL(s->m1, s->m4),
      rate_vw_c = rate_vw_a + rate_vw_b, rate_vw_c_right = rate_vw_c - rate_vw_a,
      rate_vw_c_left = rate_vw_c - rate_vw_c_right,
      rate_vw_c_left_rest = ksl_product_rest(s->m0, s->m3, rate_vw_a, rate_vw_c_left),
      rate_vw_c_right_rest = ksl_product_rest(s->m1, s->m4, rate_vw_b, rate_vw_c_right),
      rate_vw_c_lo = rate_vw_c_left_rest + rate_vw_c_right_rest, rate_vw_d = KSL_MUL(s->m2, s->m5),
      rate_vw = rate_vw_c + rate_vw_d, rate_vw_right = rate_vw - rate_vw_c,
      rate_vw_left = rate_vw - rate_vw_right, rate_vw_left_rest = rate_vw_c - rate_vw_left,
      rate_vw_right_rest = ksl_product_rest(s->m2, s->m5, rate_vw_d, rate_vw_right),
      rate_vw_lo1 = rate_vw_left_rest + rate_vw_right_rest, rate_vw_lo = rate_vw_lo1 + rate_vw_c_lo;
  const double rate_turn = KSL_MUL(rate2, rate_vw), rate_turn_cross1 = KSL_MUL(rate2_lo, rate_vw),
      rate_turn_cross2 = KSL_MUL(rate2, rate_vw_lo),
      rate_turn_cross = rate_turn_cross1 + rate_turn_cross2;
  const double rate_bend_a = KSL_MUL(rate3, rate_vw),
      rate_bend_a_cross1 = KSL_MUL(rate3_lo, rate_vw),
      rate_bend_a_cross2 = KSL_MUL(rate3, rate_vw_lo),
      rate_bend_a_cross = rate_bend_a_cross1 + rate_bend_a_cross2, rate_bend = -rate_bend_a,
      rate_bend_cross = -rate_bend_a_cross, rate_bend_factor = -rate3;
  const double rate_q_0a = KSL_MUL(s->m0, g2), rate_q_0a_cross2 = KSL_MUL(s->m0, g2_cross2),
      rate_turn_error = ksl_product_error(rate2, rate_vw, rate_turn),
      rate_turn_lo = rate_turn_error + rate_turn_cross, rate_q_0b = KSL_MUL(s->m3, rate_turn),
      rate_q_0b_cross2 = KSL_MUL(s->m3, rate_turn_lo), rate_q_0c = rate_q_0a + rate_q_0b,
      rate_q_0c_right = rate_q_0c - rate_q_0a, rate_q_0c_left = rate_q_0c - rate_q_0c_right,
      rate_q_0c_left_rest = ksl_product_rest(s->m0, g2, rate_q_0a, rate_q_0c_left),
      rate_q_0c_right_rest = ksl_product_rest(s->m3, rate_turn, rate_q_0b, rate_q_0c_right),
      rate_q_0c_cross = rate_q_0a_cross2 + rate_q_0b_cross2,
      rate_q_0c_lo1 = rate_q_0c_left_rest + rate_q_0c_right_rest,
      rate_q_0c_lo = rate_q_0c_lo1 + rate_q_0c_cross, rate_q_0 = -rate_q_0c,
      rate_q_0_lo = -rate_q_0c_lo;
  const double rate_q_1a = KSL_MUL(s->m1, g2), rate_q_1a_cross2 = KSL_MUL(s->m1, g2_cross2),
      rate_q_1b = KSL_MUL(s->m4, rate_turn), rate_q_1b_cross2 = KSL_MUL(s->m4, rate_turn_lo),
      rate_q_1c = rate_q_1a + rate_q_1b, rate_q_1c_right = rate_q_1c - rate_q_1a,
      rate_q_1c_left = rate_q_1c - rate_q_1c_right,
      rate_q_1c_left_rest = ksl_product_rest(s->m1, g2, rate_q_1a, rate_q_1c_left),
      rate_q_1c_right_rest = ksl_product_rest(s->m4, rate_turn, rate_q_1b, rate_q_1c_right),
      rate_q_1c_cross = rate_q_1a_cross2 + rate_q_1b_cross2,
      rate_q_1c_lo1 = rate_q_1c_left_rest + rate_q_1c_right_rest,
      rate_q_1c_lo = rate_q_1c_lo1 + rate_q_1c_cross, rate_q_1 = -rate_q_1c,
      rate_q_1_lo = -rate_q_1c_lo;
  const double rate_q_2a = KSL_MUL(s->m2, g2), rate_q_2a_cross2 = KSL_MUL(s->m2, g2_cross2),
      rate_q_2b = KSL_MUL(s->m5, rate_turn), rate_q_2b_cross2 = KSL_MUL(s->m5, rate_turn_lo),
      rate_q_2c = rate_q_2a + rate_q_2b, rate_q_2c_right = rate_q_2c - rate_q_2a,
      rate_q_2c_left = rate_q_2c - rate_q_2c_right,
      rate_q_2c_left_rest = ksl_product_rest(s->m2, g2, rate_q_2a, rate_q_2c_left),
      rate_q_2c_right_rest = ksl_product_rest(s->m5, rate_turn, rate_q_2b, rate_q_2c_right),
      rate_q_2c_cross = rate_q_2a_cross2 + rate_q_2b_cross2,
      rate_q_2c_lo1 = rate_q_2c_left_rest + rate_q_2c_right_rest,
      rate_q_2c_lo = rate_q_2c_lo1 + rate_q_2c_cross, rate_q_2 = -rate_q_2c,
      rate_q_2_lo = -rate_q_2c_lo;
  const double rate_beta_v_0a = KSL_MUL(s->m0, g3), rate_beta_v_0a_cross2 = KSL_MUL(s->m0, g3_lo),
      rate_beta_v_0 = -rate_beta_v_0a, rate_beta_v_0_cross = -rate_beta_v_0a_cross2,
      rate_beta_v_0_factor = -s->m0;
  const double rate_beta_v_1a = KSL_MUL(s->m1, g3), rate_beta_v_1a_cross2 = KSL_MUL(s->m1, g3_lo),
      rate_beta_v_1 = -rate_beta_v_1a, rate_beta_v_1_cross = -rate_beta_v_1a_cross2,
      rate_beta_v_1_factor = -s->m1;
  const double rate_beta_v_2a = KSL_MUL(s->m2, g3), rate_beta_v_2a_cross2 = KSL_MUL(s->m2, g3_lo),
      rate_beta_v_2 = -rate_beta_v_2a, rate_beta_v_2_cross = -rate_beta_v_2a_cross2,
      rate_beta_v_2_factor = -s->m2;
  const double rate_bend_error = ksl_product_error(rate_bend_factor, rate_vw, rate_bend),
      rate_bend_lo = rate_bend_error + rate_bend_cross, rate_bend_w_0a = KSL_MUL(s->m3, rate_bend),
      rate_bend_w_0a_cross2 = KSL_MUL(s->m3, rate_bend_lo), rate_bend_w_0 = -rate_bend_w_0a,
      rate_bend_w_0_cross = -rate_bend_w_0a_cross2, rate_bend_w_0_factor = -s->m3;
  const double rate_bend_w_1a = KSL_MUL(s->m4, rate_bend),
      rate_bend_w_1a_cross2 = KSL_MUL(s->m4, rate_bend_lo), rate_bend_w_1 = -rate_bend_w_1a,
      rate_bend_w_1_cross = -rate_bend_w_1a_cross2, rate_bend_w_1_factor = -s->m4;
  const double rate_bend_w_2a = KSL_MUL(s->m5, rate_bend),
      rate_bend_w_2a_cross2 = KSL_MUL(s->m5, rate_bend_lo), rate_bend_w_2 = -rate_bend_w_2a,
      rate_bend_w_2_cross = -rate_bend_w_2a_cross2, rate_bend_w_2_factor = -s->m5;
  const double rate_bend_w_0_error = ksl_product_error(rate_bend_w_0_factor, rate_bend,
      rate_bend_w_0),
      rate_bend_w_0_lo = rate_bend_w_0_error + rate_bend_w_0_cross,
      rate_symmetric_0a = KSL_MUL(s->m4, rate_bend_w_0),
      rate_symmetric_0a_cross2 = KSL_MUL(s->m4, rate_bend_w_0_lo),
      rate_beta_v_1_error = ksl_product_error(rate_beta_v_1_factor, g3, rate_beta_v_1),
      rate_beta_v_1_lo = rate_beta_v_1_error + rate_beta_v_1_cross,
      rate_symmetric_0b = KSL_MUL(s->m3, rate_beta_v_1),
      rate_symmetric_0b_cross2 = KSL_MUL(s->m3, rate_beta_v_1_lo),
      rate_beta_v_0_error = ksl_product_error(rate_beta_v_0_factor, g3, rate_beta_v_0),
      rate_beta_v_0_lo = rate_beta_v_0_error + rate_beta_v_0_cross,
      rate_symmetric_0c = KSL_MUL(s->m4, rate_beta_v_0),
      rate_symmetric_0c_cross2 = KSL_MUL(s->m4, rate_beta_v_0_lo),
      rate_symmetric_0d = rate_symmetric_0b + rate_symmetric_0c,
      rate_symmetric_0d_right = rate_symmetric_0d - rate_symmetric_0b,
      rate_symmetric_0d_left = rate_symmetric_0d - rate_symmetric_0d_right,
      rate_symmetric_0d_left_rest = ksl_product_rest(s->m3, rate_beta_v_1, rate_symmetric_0b,
          rate_symmetric_0d_left),
      rate_symmetric_0d_right_rest = ksl_product_rest(s->m4, rate_beta_v_0, rate_symmetric_0c,
          rate_symmetric_0d_right),
      rate_symmetric_0d_cross = rate_symmetric_0b_cross2 + rate_symmetric_0c_cross2,
      rate_symmetric_0d_lo1 = rate_symmetric_0d_left_rest + rate_symmetric_0d_right_rest,
      rate_symmetric_0d_lo = rate_symmetric_0d_lo1 + rate_symmetric_0d_cross,
      rate_symmetric_0 = rate_symmetric_0a - rate_symmetric_0d,
      rate_symmetric_0_right = rate_symmetric_0a - rate_symmetric_0,
      rate_symmetric_0_left = rate_symmetric_0 + rate_symmetric_0_right,
      rate_symmetric_0_left_rest = ksl_product_rest(s->m4, rate_bend_w_0, rate_symmetric_0a,
          rate_symmetric_0_left),
      rate_symmetric_0_right_rest = rate_symmetric_0d - rate_symmetric_0_right,
      rate_symmetric_0_lo1 = rate_symmetric_0_left_rest - rate_symmetric_0_right_rest,
      rate_symmetric_0_lo2 = rate_symmetric_0_lo1 - rate_symmetric_0d_lo,
      rate_symmetric_0_lo = rate_symmetric_0_lo2 + rate_symmetric_0a_cross2;
  const double rate_symmetric_1a = KSL_MUL(s->m5, rate_bend_w_0),
      rate_symmetric_1a_cross2 = KSL_MUL(s->m5, rate_bend_w_0_lo),
      rate_beta_v_2_error = ksl_product_error(rate_beta_v_2_factor, g3, rate_beta_v_2),
      rate_beta_v_2_lo = rate_beta_v_2_error + rate_beta_v_2_cross,
      rate_symmetric_1b = KSL_MUL(s->m3, rate_beta_v_2),
      rate_symmetric_1b_cross2 = KSL_MUL(s->m3, rate_beta_v_2_lo),
      rate_symmetric_1c = KSL_MUL(s->m5, rate_beta_v_0),
      rate_symmetric_1c_cross2 = KSL_MUL(s->m5, rate_beta_v_0_lo),
      rate_symmetric_1d = rate_symmetric_1b + rate_symmetric_1c,
      rate_symmetric_1d_right = rate_symmetric_1d - rate_symmetric_1b,
      rate_symmetric_1d_left = rate_symmetric_1d - rate_symmetric_1d_right,
      rate_symmetric_1d_left_rest = ksl_product_rest(s->m3, rate_beta_v_2, rate_symmetric_1b,
          rate_symmetric_1d_left),
      rate_symmetric_1d_right_rest = ksl_product_rest(s->m5, rate_beta_v_0, rate_symmetric_1c,
          rate_symmetric_1d_right),
      rate_symmetric_1d_cross = rate_symmetric_1b_cross2 + rate_symmetric_1c_cross2,
      rate_symmetric_1d_lo1 = rate_symmetric_1d_left_rest + rate_symmetric_1d_right_rest,
      rate_symmetric_1d_lo = rate_symmetric_1d_lo1 + rate_symmetric_1d_cross,
      rate_symmetric_1 = rate_symmetric_1a - rate_symmetric_1d,
      rate_symmetric_1_right = rate_symmetric_1a - rate_symmetric_1,
      rate_symmetric_1_left = rate_symmetric_1 + rate_symmetric_1_right,
      rate_symmetric_1_left_rest = ksl_product_rest(s->m5, rate_bend_w_0, rate_symmetric_1a,
          rate_symmetric_1_left),
      rate_symmetric_1_right_rest = rate_symmetric_1d - rate_symmetric_1_right,
      rate_symmetric_1_lo1 = rate_symmetric_1_left_rest - rate_symmetric_1_right_rest,
      rate_symmetric_1_lo2 = rate_symmetric_1_lo1 - rate_symmetric_1d_lo,
      rate_symmetric_1_lo = rate_symmetric_1_lo2 + rate_symmetric_1a_cross2;
  const double rate_bend_w_1_error = ksl_product_error(rate_bend_w_1_factor, rate_bend,
      rate_bend_w_1),
      rate_bend_w_1_lo = rate_bend_w_1_error + rate_bend_w_1_cross,
      rate_symmetric_2a = KSL_MUL(s->m5, rate_bend_w_1),
      rate_symmetric_2a_cross2 = KSL_MUL(s->m5, rate_bend_w_1_lo),
      rate_symmetric_2b = KSL_MUL(s->m4, rate_beta_v_2),
      rate_symmetric_2b_cross2 = KSL_MUL(s->m4, rate_beta_v_2_lo),
      rate_symmetric_2c = KSL_MUL(s->m5, rate_beta_v_1),
      rate_symmetric_2c_cross2 = KSL_MUL(s->m5, rate_beta_v_1_lo),
      rate_symmetric_2d = rate_symmetric_2b + rate_symmetric_2c,
      rate_symmetric_2d_right = rate_symmetric_2d - rate_symmetric_2b,
      rate_symmetric_2d_left = rate_symmetric_2d - rate_symmetric_2d_right,
      rate_symmetric_2d_left_rest = ksl_product_rest(s->m4, rate_beta_v_2, rate_symmetric_2b,
          rate_symmetric_2d_left),
      rate_symmetric_2d_right_rest = ksl_product_rest(s->m5, rate_beta_v_1, rate_symmetric_2c,
          rate_symmetric_2d_right),
      rate_symmetric_2d_cross = rate_symmetric_2b_cross2 + rate_symmetric_2c_cross2,
      rate_symmetric_2d_lo1 = rate_symmetric_2d_left_rest + rate_symmetric_2d_right_rest,
      rate_symmetric_2d_lo = rate_symmetric_2d_lo1 + rate_symmetric_2d_cross,
      rate_symmetric_2 = rate_symmetric_2a - rate_symmetric_2d,
      rate_symmetric_2_right = rate_symmetric_2a - rate_symmetric_2,
      rate_symmetric_2_left = rate_symmetric_2 + rate_symmetric_2_right,
      rate_symmetric_2_left_rest = ksl_product_rest(s->m5, rate_bend_w_1, rate_symmetric_2a,
          rate_symmetric_2_left),
      rate_symmetric_2_right_rest = rate_symmetric_2d - rate_symmetric_2_right,
      rate_symmetric_2_lo1 = rate_symmetric_2_left_rest - rate_symmetric_2_right_rest,
      rate_symmetric_2_lo2 = rate_symmetric_2_lo1 - rate_symmetric_2d_lo,
      rate_symmetric_2_lo = rate_symmetric_2_lo2 + rate_symmetric_2a_cross2;
  const double rate_diagonal_0a = KSL_MUL(2.0, s->m4),
      rate_diagonal_0b = KSL_MUL(rate_diagonal_0a, rate_beta_v_1),
      rate_diagonal_0b_cross2 = KSL_MUL(rate_diagonal_0a, rate_beta_v_1_lo),
      rate_diagonal_0c = KSL_MUL(2.0, s->m5),
      rate_diagonal_0d = KSL_MUL(rate_diagonal_0c, rate_beta_v_2),
      rate_diagonal_0d_cross2 = KSL_MUL(rate_diagonal_0c, rate_beta_v_2_lo),
      rate_diagonal_0e = rate_diagonal_0b + rate_diagonal_0d,
      rate_diagonal_0e_right = rate_diagonal_0e - rate_diagonal_0b,
      rate_diagonal_0e_left = rate_diagonal_0e - rate_diagonal_0e_right,
      rate_diagonal_0e_left_rest = ksl_product_rest(rate_diagonal_0a, rate_beta_v_1,
          rate_diagonal_0b, rate_diagonal_0e_left),
      rate_diagonal_0e_right_rest = ksl_product_rest(rate_diagonal_0c, rate_beta_v_2,
          rate_diagonal_0d, rate_diagonal_0e_right),
      rate_diagonal_0e_cross = rate_diagonal_0b_cross2 + rate_diagonal_0d_cross2,
      rate_diagonal_0e_lo1 = rate_diagonal_0e_left_rest + rate_diagonal_0e_right_rest,
      rate_diagonal_0e_lo = rate_diagonal_0e_lo1 + rate_diagonal_0e_cross,
      rate_diagonal_0f = KSL_MUL(s->m4, rate_bend_w_1),
      rate_diagonal_0f_cross2 = KSL_MUL(s->m4, rate_bend_w_1_lo),
      rate_bend_w_2_error = ksl_product_error(rate_bend_w_2_factor, rate_bend, rate_bend_w_2),
      rate_bend_w_2_lo = rate_bend_w_2_error + rate_bend_w_2_cross,
      rate_diagonal_0g = KSL_MUL(s->m5, rate_bend_w_2),
      rate_diagonal_0g_cross2 = KSL_MUL(s->m5, rate_bend_w_2_lo),
      rate_diagonal_0h = rate_diagonal_0f + rate_diagonal_0g,
      rate_diagonal_0h_right = rate_diagonal_0h - rate_diagonal_0f,
      rate_diagonal_0h_left = rate_diagonal_0h - rate_diagonal_0h_right,
      rate_diagonal_0h_left_rest = ksl_product_rest(s->m4, rate_bend_w_1, rate_diagonal_0f,
          rate_diagonal_0h_left),
      rate_diagonal_0h_right_rest = ksl_product_rest(s->m5, rate_bend_w_2, rate_diagonal_0g,
          rate_diagonal_0h_right),
      rate_diagonal_0h_cross = rate_diagonal_0f_cross2 + rate_diagonal_0g_cross2,
      rate_diagonal_0h_lo1 = rate_diagonal_0h_left_rest + rate_diagonal_0h_right_rest,
      rate_diagonal_0h_lo = rate_diagonal_0h_lo1 + rate_diagonal_0h_cross,
      rate_diagonal_0 = rate_diagonal_0e - rate_diagonal_0h,
      rate_diagonal_0_right = rate_diagonal_0e - rate_diagonal_0,
      rate_diagonal_0_left = rate_diagonal_0 + rate_diagonal_0_right,
      rate_diagonal_0_left_rest = rate_diagonal_0e - rate_diagonal_0_left,
      rate_diagonal_0_right_rest = rate_diagonal_0h - rate_diagonal_0_right,
      rate_diagonal_0_lo1 = rate_diagonal_0_left_rest - rate_diagonal_0_right_rest,
      rate_diagonal_0_lo2 = rate_diagonal_0_lo1 - rate_diagonal_0h_lo,
      rate_diagonal_0_lo = rate_diagonal_0_lo2 + rate_diagonal_0e_lo;
  const double rate_diagonal_1a = KSL_MUL(2.0, s->m3),
      rate_diagonal_1b = KSL_MUL(rate_diagonal_1a, rate_beta_v_0),
      rate_diagonal_1b_cross2 = KSL_MUL(rate_diagonal_1a, rate_beta_v_0_lo),
      rate_diagonal_1c = rate_diagonal_1b + rate_diagonal_0d,
      rate_diagonal_1c_right = rate_diagonal_1c - rate_diagonal_1b,
      rate_diagonal_1c_left = rate_diagonal_1c - rate_diagonal_1c_right,
      rate_diagonal_1c_left_rest = ksl_product_rest(rate_diagonal_1a, rate_beta_v_0,
          rate_diagonal_1b, rate_diagonal_1c_left),
      rate_diagonal_1c_right_rest = ksl_product_rest(rate_diagonal_0c, rate_beta_v_2,
          rate_diagonal_0d, rate_diagonal_1c_right),
      rate_diagonal_1c_cross = rate_diagonal_1b_cross2 + rate_diagonal_0d_cross2,
      rate_diagonal_1c_lo1 = rate_diagonal_1c_left_rest + rate_diagonal_1c_right_rest,
      rate_diagonal_1c_lo = rate_diagonal_1c_lo1 + rate_diagonal_1c_cross,
      rate_diagonal_1d = KSL_MUL(s->m3, rate_bend_w_0),
      rate_diagonal_1d_cross2 = KSL_MUL(s->m3, rate_bend_w_0_lo),
      rate_diagonal_1e = rate_diagonal_1d + rate_diagonal_0g,
      rate_diagonal_1e_right = rate_diagonal_1e - rate_diagonal_1d,
      rate_diagonal_1e_left = rate_diagonal_1e - rate_diagonal_1e_right,
      rate_diagonal_1e_left_rest = ksl_product_rest(s->m3, rate_bend_w_0, rate_diagonal_1d,
          rate_diagonal_1e_left),
      rate_diagonal_1e_right_rest = ksl_product_rest(s->m5, rate_bend_w_2, rate_diagonal_0g,
          rate_diagonal_1e_right),
      rate_diagonal_1e_cross = rate_diagonal_1d_cross2 + rate_diagonal_0g_cross2,
      rate_diagonal_1e_lo1 = rate_diagonal_1e_left_rest + rate_diagonal_1e_right_rest,
      rate_diagonal_1e_lo = rate_diagonal_1e_lo1 + rate_diagonal_1e_cross,
      rate_diagonal_1 = rate_diagonal_1c - rate_diagonal_1e,
      rate_diagonal_1_right = rate_diagonal_1c - rate_diagonal_1,
      rate_diagonal_1_left = rate_diagonal_1 + rate_diagonal_1_right,
      rate_diagonal_1_left_rest = rate_diagonal_1c - rate_diagonal_1_left,
      rate_diagonal_1_right_rest = rate_diagonal_1e - rate_diagonal_1_right,
      rate_diagonal_1_lo1 = rate_diagonal_1_left_rest - rate_diagonal_1_right_rest,
      rate_diagonal_1_lo2 = rate_diagonal_1_lo1 - rate_diagonal_1e_lo,
      rate_diagonal_1_lo = rate_diagonal_1_lo2 + rate_diagonal_1c_lo;
  const double rate_diagonal_2a = rate_diagonal_1b + rate_diagonal_0b,
      rate_diagonal_2a_right = rate_diagonal_2a - rate_diagonal_1b,
      rate_diagonal_2a_left = rate_diagonal_2a - rate_diagonal_2a_right,
      rate_diagonal_2a_left_rest = ksl_product_rest(rate_diagonal_1a, rate_beta_v_0,
          rate_diagonal_1b, rate_diagonal_2a_left),
      rate_diagonal_2a_right_rest = ksl_product_rest(rate_diagonal_0a, rate_beta_v_1,
          rate_diagonal_0b, rate_diagonal_2a_right),
      rate_diagonal_2a_cross = rate_diagonal_1b_cross2 + rate_diagonal_0b_cross2,
      rate_diagonal_2a_lo1 = rate_diagonal_2a_left_rest + rate_diagonal_2a_right_rest,
      rate_diagonal_2a_lo = rate_diagonal_2a_lo1 + rate_diagonal_2a_cross,
      rate_diagonal_2b = rate_diagonal_1d + rate_diagonal_0f,
      rate_diagonal_2b_right = rate_diagonal_2b - rate_diagonal_1d,
      rate_diagonal_2b_left = rate_diagonal_2b - rate_diagonal_2b_right,
      rate_diagonal_2b_left_rest = ksl_product_rest(s->m3, rate_bend_w_0, rate_diagonal_1d,
          rate_diagonal_2b_left),
      rate_diagonal_2b_right_rest = ksl_product_rest(s->m4, rate_bend_w_1, rate_diagonal_0f,
          rate_diagonal_2b_right),
      rate_diagonal_2b_cross = rate_diagonal_1d_cross2 + rate_diagonal_0f_cross2,
      rate_diagonal_2b_lo1 = rate_diagonal_2b_left_rest + rate_diagonal_2b_right_rest,
      rate_diagonal_2b_lo = rate_diagonal_2b_lo1 + rate_diagonal_2b_cross,
      rate_diagonal_2 = rate_diagonal_2a - rate_diagonal_2b,
      rate_diagonal_2_right = rate_diagonal_2a - rate_diagonal_2,
      rate_diagonal_2_left = rate_diagonal_2 + rate_diagonal_2_right,
      rate_diagonal_2_left_rest = rate_diagonal_2a - rate_diagonal_2_left,
      rate_diagonal_2_right_rest = rate_diagonal_2b - rate_diagonal_2_right,
      rate_diagonal_2_lo1 = rate_diagonal_2_left_rest - rate_diagonal_2_right_rest,
      rate_diagonal_2_lo2 = rate_diagonal_2_lo1 - rate_diagonal_2b_lo,
      rate_diagonal_2_lo = rate_diagonal_2_lo2 + rate_diagonal_2a_lo;
  const double M_04 = rate_symmetric_0 - rate_q_2, M_04_right = rate_symmetric_0 - M_04,
      M_04_left = M_04 + M_04_right, M_04_left_rest = rate_symmetric_0 - M_04_left,
      M_04_right_rest = rate_q_2 - M_04_right, M_04_lo1 = M_04_left_rest - M_04_right_rest,
      M_04_lo2 = M_04_lo1 - rate_q_2_lo, M_04_lo = M_04_lo2 + rate_symmetric_0_lo;
  const double M_05 = rate_q_1 + rate_symmetric_1, M_05_right = M_05 - rate_q_1,
      M_05_left = M_05 - M_05_right, M_05_left_rest = rate_q_1 - M_05_left,
      M_05_right_rest = rate_symmetric_1 - M_05_right, M_05_lo1 = M_05_left_rest + M_05_right_rest,
      M_05_lo2 = M_05_lo1 + rate_symmetric_1_lo, M_05_lo = M_05_lo2 + rate_q_1_lo;
  const double M_13 = rate_q_2 + rate_symmetric_0, M_13_right = M_13 - rate_q_2,
      M_13_left = M_13 - M_13_right, M_13_left_rest = rate_q_2 - M_13_left,
      M_13_right_rest = rate_symmetric_0 - M_13_right, M_13_lo1 = M_13_left_rest + M_13_right_rest,
      M_13_lo2 = M_13_lo1 + rate_symmetric_0_lo, M_13_lo = M_13_lo2 + rate_q_2_lo;
  const double M_15 = rate_symmetric_2 - rate_q_0, M_15_right = rate_symmetric_2 - M_15,
      M_15_left = M_15 + M_15_right, M_15_left_rest = rate_symmetric_2 - M_15_left,
      M_15_right_rest = rate_q_0 - M_15_right, M_15_lo1 = M_15_left_rest - M_15_right_rest,
      M_15_lo2 = M_15_lo1 - rate_q_0_lo, M_15_lo = M_15_lo2 + rate_symmetric_2_lo;
  const double M_23 = rate_symmetric_1 - rate_q_1, M_23_right = rate_symmetric_1 - M_23,
      M_23_left = M_23 + M_23_right, M_23_left_rest = rate_symmetric_1 - M_23_left,
      M_23_right_rest = rate_q_1 - M_23_right, M_23_lo1 = M_23_left_rest - M_23_right_rest,
      M_23_lo2 = M_23_lo1 - rate_q_1_lo, M_23_lo = M_23_lo2 + rate_symmetric_1_lo;
  const double M_24 = rate_q_0 + rate_symmetric_2, M_24_right = M_24 - rate_q_0,
      M_24_left = M_24 - M_24_right, M_24_left_rest = rate_q_0 - M_24_left,
      M_24_right_rest = rate_symmetric_2 - M_24_right, M_24_lo1 = M_24_left_rest + M_24_right_rest,
      M_24_lo2 = M_24_lo1 + rate_symmetric_2_lo, M_24_lo = M_24_lo2 + rate_q_0_lo;
  const double diagonal0_rounded = diagonal0 + diagonal0_lo,
      diagonal0_final = diagonal0_rounded == diagonal0_rounded ? diagonal0_rounded : diagonal0;
  const double J_1_rounded = J_1 + J_1_lo,
      J_1_final = J_1_rounded == J_1_rounded ? J_1_rounded : J_1;
  const double J_2_rounded = J_2 + J_2_lo,
      J_2_final = J_2_rounded == J_2_rounded ? J_2_rounded : J_2;
  const double rate_diagonal_0_rounded = rate_diagonal_0 + rate_diagonal_0_lo,
      rate_diagonal_0_final = rate_diagonal_0_rounded == rate_diagonal_0_rounded ?
          rate_diagonal_0_rounded : rate_diagonal_0;
  const double M_04_rounded = M_04 + M_04_lo,
      M_04_final = M_04_rounded == M_04_rounded ? M_04_rounded : M_04;
  const double M_05_rounded = M_05 + M_05_lo,
      M_05_final = M_05_rounded == M_05_rounded ? M_05_rounded : M_05;
  const double J_3_rounded = J_3 + J_3_lo,
      J_3_final = J_3_rounded == J_3_rounded ? J_3_rounded : J_3;
  const double diagonal1_rounded = diagonal1 + diagonal1_lo,
      diagonal1_final = diagonal1_rounded == diagonal1_rounded ? diagonal1_rounded : diagonal1;
  const double J_5_rounded = J_5 + J_5_lo,
      J_5_final = J_5_rounded == J_5_rounded ? J_5_rounded : J_5;
  const double M_13_rounded = M_13 + M_13_lo,
      M_13_final = M_13_rounded == M_13_rounded ? M_13_rounded : M_13;
  const double rate_diagonal_1_rounded = rate_diagonal_1 + rate_diagonal_1_lo,
      rate_diagonal_1_final = rate_diagonal_1_rounded == rate_diagonal_1_rounded ?
          rate_diagonal_1_rounded : rate_diagonal_1;
  const double M_15_rounded = M_15 + M_15_lo,
      M_15_final = M_15_rounded == M_15_rounded ? M_15_rounded : M_15;
  const double J_6_rounded = J_6 + J_6_lo,
      J_6_final = J_6_rounded == J_6_rounded ? J_6_rounded : J_6;
  const double J_7_rounded = J_7 + J_7_lo,
      J_7_final = J_7_rounded == J_7_rounded ? J_7_rounded : J_7;
  const double diagonal2_rounded = diagonal2 + diagonal2_lo,
      diagonal2_final = diagonal2_rounded == diagonal2_rounded ? diagonal2_rounded : diagonal2;
  const double M_23_rounded = M_23 + M_23_lo,
      M_23_final = M_23_rounded == M_23_rounded ? M_23_rounded : M_23;
  const double M_24_rounded = M_24 + M_24_lo,
      M_24_final = M_24_rounded == M_24_rounded ? M_24_rounded : M_24;
  const double rate_diagonal_2_rounded = rate_diagonal_2 + rate_diagonal_2_lo,
      rate_diagonal_2_final = rate_diagonal_2_rounded == rate_diagonal_2_rounded ?
          rate_diagonal_2_rounded : rate_diagonal_2;
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
  const double halved_0 = KSL_MUL(0.5, s->m3);
  const double halved_1 = KSL_MUL(0.5, s->m4);
  const double halved_2 = KSL_MUL(0.5, s->m5);
  const double y_a = KSL_MUL(halved_0, halved_0), y_b = KSL_MUL(halved_1, halved_1),
      y_c = y_a + y_b, y_c_right = y_c - y_a, y_c_left = y_c - y_c_right,
      y_c_left_rest = ksl_product_rest(halved_0, halved_0, y_a, y_c_left),
      y_c_right_rest = ksl_product_rest(halved_1, halved_1, y_b, y_c_right),
      y_c_lo = y_c_left_rest + y_c_right_rest, y_d = KSL_MUL(halved_2, halved_2), y = y_c + y_d,
      y_right = y - y_c, y_left = y - y_right, y_left_rest = y_c - y_left,
      y_right_rest = ksl_product_rest(halved_2, halved_2, y_d, y_right),
      y_lo1 = y_left_rest + y_right_rest, y_lo = y_lo1 + y_c_lo;
  const double half_angle_of_y = y + y_lo, half_angle_of_y_right = half_angle_of_y - y,
      half_angle_of_y_left = half_angle_of_y - half_angle_of_y_right,
      half_angle_of_y_left_rest = y - half_angle_of_y_left,
      half_angle_of_y_right_rest = y_lo - half_angle_of_y_right,
      half_angle_of_y_lo = half_angle_of_y_left_rest + half_angle_of_y_right_rest,
      half_angle = sqrt(half_angle_of_y), half_angle_product = KSL_MUL(half_angle, half_angle),
      half_angle_product_error = ksl_product_error(half_angle, half_angle, half_angle_product),
      half_angle_rest = half_angle_of_y - half_angle_product,
      half_angle_exact = half_angle_rest - half_angle_product_error,
      half_angle_residual = half_angle_exact + half_angle_of_y_lo,
      half_angle_twice = half_angle + half_angle,
      half_angle_divisor = half_angle == 0.0 ? 1.0 : half_angle_twice,
      half_angle_lo = half_angle_residual / half_angle_divisor;
  const double sine_of_half_angle = half_angle + half_angle_lo,
      sine_of_half_angle_right = sine_of_half_angle - half_angle,
      sine_of_half_angle_left = sine_of_half_angle - sine_of_half_angle_right,
      sine_of_half_angle_left_rest = half_angle - sine_of_half_angle_left,
      sine_of_half_angle_right_rest = half_angle_lo - sine_of_half_angle_right,
      sine_of_half_angle_lo = sine_of_half_angle_left_rest + sine_of_half_angle_right_rest;
  double c; const double sine = ksl_sincos(sine_of_half_angle, &c);
  double c_own_error; const double sine_own_error = ksl_sincos_error(sine_of_half_angle, sine, c,
      &c_own_error);
  const double sine_half = KSL_MUL(sine_of_half_angle_lo, 0.5);
  double sine_half_cos; const double sine_half_sin = ksl_sincos(sine_half, &sine_half_cos);
  const double sine_twice = sine_half_sin + sine_half_sin, sine_slope1 = KSL_MUL(sine_half_cos, c),
      sine_slope2 = KSL_MUL(sine_half_sin, sine), sine_slope = sine_slope1 - sine_slope2,
      sine_more = KSL_MUL(sine_slope, sine_twice), sine_lo = sine_own_error + sine_more;
  const double c_slope1 = KSL_MUL(sine_half_cos, sine), c_slope2 = KSL_MUL(sine_half_sin, c),
      c_slope = c_slope1 + c_slope2, c_more = KSL_MUL(c_slope, sine_twice),
      c_lo = c_own_error - c_more;
  const double sinc_divisor = sine_of_half_angle < 1.4901161193847656e-08 ? 1.4901161193847656e-08 :
      sine_of_half_angle,
      sinc_divisor_lo = sine_of_half_angle < 1.4901161193847656e-08 ? 0.0 : sine_of_half_angle_lo;
  const double sinc_quotient_of_sine = sine + sine_lo,
      sinc_quotient_of_sine_right = sinc_quotient_of_sine - sine,
      sinc_quotient_of_sine_left = sinc_quotient_of_sine - sinc_quotient_of_sine_right,
      sinc_quotient_of_sine_left_rest = sine - sinc_quotient_of_sine_left,
      sinc_quotient_of_sine_right_rest = sine_lo - sinc_quotient_of_sine_right,
      sinc_quotient_of_sine_lo = sinc_quotient_of_sine_left_rest + sinc_quotient_of_sine_right_rest,
      sinc_quotient_of_sinc_divisor = sinc_divisor + sinc_divisor_lo,
      sinc_quotient_of_sinc_divisor_right = sinc_quotient_of_sinc_divisor - sinc_divisor,
      sinc_quotient_of_sinc_divisor_left = sinc_quotient_of_sinc_divisor -
          sinc_quotient_of_sinc_divisor_right,
      sinc_quotient_of_sinc_divisor_left_rest = sinc_divisor - sinc_quotient_of_sinc_divisor_left,
      sinc_quotient_of_sinc_divisor_right_rest = sinc_divisor_lo -
          sinc_quotient_of_sinc_divisor_right,
      sinc_quotient_of_sinc_divisor_lo = sinc_quotient_of_sinc_divisor_left_rest +
          sinc_quotient_of_sinc_divisor_right_rest,
      sinc_quotient = sinc_quotient_of_sine / sinc_quotient_of_sinc_divisor,
      sinc_quotient_product = KSL_MUL(sinc_quotient, sinc_quotient_of_sinc_divisor),
      sinc_quotient_product_error = ksl_product_error(sinc_quotient, sinc_quotient_of_sinc_divisor,
          sinc_quotient_product),
      sinc_quotient_rest = sinc_quotient_of_sine - sinc_quotient_product,
      sinc_quotient_exact = sinc_quotient_rest - sinc_quotient_product_error,
      sinc_quotient_numerator = sinc_quotient_exact + sinc_quotient_of_sine_lo,
      sinc_quotient_cross = KSL_MUL(sinc_quotient, sinc_quotient_of_sinc_divisor_lo),
      sinc_quotient_residual = sinc_quotient_numerator - sinc_quotient_cross,
      sinc_quotient_lo = sinc_quotient_residual / sinc_quotient_of_sinc_divisor;
  const double sinc_a = KSL_MUL(0.16666666666666666, half_angle_of_y),
      sinc_a_cross1 = KSL_MUL(9.25185853854297e-18, half_angle_of_y),
      sinc_a_cross2 = KSL_MUL(0.16666666666666666, half_angle_of_y_lo),
      sinc_a_cross = sinc_a_cross1 + sinc_a_cross2, sinc_b = 1.0 - sinc_a,
      sinc_b_right = 1.0 - sinc_b, sinc_b_left = sinc_b + sinc_b_right,
      sinc_b_left_rest = 1.0 - sinc_b_left,
      sinc_b_right_rest = ksl_product_rest(0.16666666666666666, half_angle_of_y, sinc_a,
          sinc_b_right),
      sinc_b_lo1 = sinc_b_left_rest - sinc_b_right_rest, sinc_b_lo = sinc_b_lo1 - sinc_a_cross,
      sinc = sine_of_half_angle < 1.4901161193847656e-08 ? sinc_b : sinc_quotient,
      sinc_lo = sine_of_half_angle < 1.4901161193847656e-08 ? sinc_b_lo : sinc_quotient_lo;
  const double series_phi_a = KSL_MUL(5.107725174524775e-32, half_angle_of_y),
      series_phi_a_cross1 = KSL_MUL(4.7410392187559056e-48, half_angle_of_y),
      series_phi_a_cross2 = KSL_MUL(5.107725174524775e-32, half_angle_of_y_lo),
      series_phi_a_cross = series_phi_a_cross1 + series_phi_a_cross2,
      series_phi_b = 4.116826490666969e-29 - series_phi_a,
      series_phi_b_right = 4.116826490666969e-29 - series_phi_b,
      series_phi_b_left = series_phi_b + series_phi_b_right,
      series_phi_b_left_rest = 4.116826490666969e-29 - series_phi_b_left,
      series_phi_b_right_rest = ksl_product_rest(5.107725174524775e-32, half_angle_of_y,
          series_phi_a, series_phi_b_right),
      series_phi_b_lo1 = series_phi_b_left_rest - series_phi_b_right_rest,
      series_phi_b_lo2 = series_phi_b_lo1 - series_phi_a_cross,
      series_phi_b_lo = series_phi_b_lo2 + -1.8714974010023092e-45,
      series_phi_c = KSL_MUL(half_angle_of_y, series_phi_b),
      series_phi_c_cross1 = KSL_MUL(half_angle_of_y_lo, series_phi_b),
      series_phi_c_cross2 = KSL_MUL(half_angle_of_y, series_phi_b_lo),
      series_phi_c_cross = series_phi_c_cross1 + series_phi_c_cross2,
      series_phi_d = series_phi_c - 2.86531123750421e-26,
      series_phi_d_right = series_phi_c - series_phi_d,
      series_phi_d_left = series_phi_d + series_phi_d_right,
      series_phi_d_left_rest = ksl_product_rest(half_angle_of_y, series_phi_b, series_phi_c,
          series_phi_d_left),
      series_phi_d_right_rest = 2.86531123750421e-26 - series_phi_d_right,
      series_phi_d_lo1 = series_phi_d_left_rest - series_phi_d_right_rest,
      series_phi_d_lo2 = series_phi_d_lo1 - 2.3296034284323186e-42,
      series_phi_d_lo = series_phi_d_lo2 + series_phi_c_cross,
      series_phi_e = KSL_MUL(half_angle_of_y, series_phi_d),
      series_phi_e_cross1 = KSL_MUL(half_angle_of_y_lo, series_phi_d),
      series_phi_e_cross2 = KSL_MUL(half_angle_of_y, series_phi_d_lo),
      series_phi_e_cross = series_phi_e_cross1 + series_phi_e_cross2,
      series_phi_f = series_phi_e + 1.701994875077501e-23,
      series_phi_f_right = series_phi_f - series_phi_e,
      series_phi_f_left = series_phi_f - series_phi_f_right,
      series_phi_f_left_rest = ksl_product_rest(half_angle_of_y, series_phi_d, series_phi_e,
          series_phi_f_left),
      series_phi_f_right_rest = 1.701994875077501e-23 - series_phi_f_right,
      series_phi_f_lo1 = series_phi_f_left_rest + series_phi_f_right_rest,
      series_phi_f_lo2 = series_phi_f_lo1 + 3.161967936521494e-40,
      series_phi_f_lo = series_phi_f_lo2 + series_phi_e_cross,
      series_phi_g = KSL_MUL(half_angle_of_y, series_phi_f),
      series_phi_g_cross1 = KSL_MUL(half_angle_of_y_lo, series_phi_f),
      series_phi_g_cross2 = KSL_MUL(half_angle_of_y, series_phi_f_lo),
      series_phi_g_cross = series_phi_g_cross1 + series_phi_g_cross2,
      series_phi_h = series_phi_g - 8.509974375387505e-21,
      series_phi_h_right = series_phi_g - series_phi_h,
      series_phi_h_left = series_phi_h + series_phi_h_right,
      series_phi_h_left_rest = ksl_product_rest(half_angle_of_y, series_phi_f, series_phi_g,
          series_phi_h_left),
      series_phi_h_right_rest = 8.509974375387505e-21 - series_phi_h_right,
      series_phi_h_lo1 = series_phi_h_left_rest - series_phi_h_right_rest,
      series_phi_h_lo2 = series_phi_h_lo1 - 3.2266760594119493e-37,
      series_phi_h_lo = series_phi_h_lo2 + series_phi_g_cross,
      series_phi_i = KSL_MUL(half_angle_of_y, series_phi_h),
      series_phi_i_cross1 = KSL_MUL(half_angle_of_y_lo, series_phi_h),
      series_phi_i_cross2 = KSL_MUL(half_angle_of_y, series_phi_h_lo),
      series_phi_i_cross = series_phi_i_cross1 + series_phi_i_cross2,
      series_phi_j = series_phi_i + 3.523129391410427e-18,
      series_phi_j_right = series_phi_j - series_phi_i,
      series_phi_j_left = series_phi_j - series_phi_j_right,
      series_phi_j_left_rest = ksl_product_rest(half_angle_of_y, series_phi_h, series_phi_i,
          series_phi_j_left),
      series_phi_j_right_rest = 3.523129391410427e-18 - series_phi_j_right,
      series_phi_j_lo1 = series_phi_j_left_rest + series_phi_j_right_rest,
      series_phi_j_lo2 = series_phi_j_lo1 + -1.2521244741738012e-34,
      series_phi_j_lo = series_phi_j_lo2 + series_phi_i_cross,
      series_phi_k = KSL_MUL(half_angle_of_y, series_phi_j),
      series_phi_k_cross1 = KSL_MUL(half_angle_of_y_lo, series_phi_j),
      series_phi_k_cross2 = KSL_MUL(half_angle_of_y, series_phi_j_lo),
      series_phi_k_cross = series_phi_k_cross1 + series_phi_k_cross2,
      series_phi_l = series_phi_k - 1.1837714755139035e-15,
      series_phi_l_right = series_phi_k - series_phi_l,
      series_phi_l_left = series_phi_l + series_phi_l_right,
      series_phi_l_left_rest = ksl_product_rest(half_angle_of_y, series_phi_j, series_phi_k,
          series_phi_l_left),
      series_phi_l_right_rest = 1.1837714755139035e-15 - series_phi_l_right,
      series_phi_l_lo1 = series_phi_l_left_rest - series_phi_l_right_rest,
      series_phi_l_lo2 = series_phi_l_lo1 - 7.23242424407352e-33,
      series_phi_l_lo = series_phi_l_lo2 + series_phi_k_cross,
      series_phi_m = KSL_MUL(half_angle_of_y, series_phi_l),
      series_phi_m_cross1 = KSL_MUL(half_angle_of_y_lo, series_phi_l),
      series_phi_m_cross2 = KSL_MUL(half_angle_of_y, series_phi_l_lo),
      series_phi_m_cross = series_phi_m_cross1 + series_phi_m_cross2,
      series_phi_n = series_phi_m + 3.148832124866983e-13,
      series_phi_n_right = series_phi_n - series_phi_m,
      series_phi_n_left = series_phi_n - series_phi_n_right,
      series_phi_n_left_rest = ksl_product_rest(half_angle_of_y, series_phi_l, series_phi_m,
          series_phi_n_left),
      series_phi_n_right_rest = 3.148832124866983e-13 - series_phi_n_right,
      series_phi_n_lo1 = series_phi_n_left_rest + series_phi_n_right_rest,
      series_phi_n_lo2 = series_phi_n_lo1 + 5.8681293750286156e-30,
      series_phi_n_lo = series_phi_n_lo2 + series_phi_m_cross,
      series_phi_o = KSL_MUL(half_angle_of_y, series_phi_n),
      series_phi_o_cross1 = KSL_MUL(half_angle_of_y_lo, series_phi_n),
      series_phi_o_cross2 = KSL_MUL(half_angle_of_y, series_phi_n_lo),
      series_phi_o_cross = series_phi_o_cross1 + series_phi_o_cross2,
      series_phi_p = series_phi_o - 6.423617534728645e-11,
      series_phi_p_right = series_phi_o - series_phi_p,
      series_phi_p_left = series_phi_p + series_phi_p_right,
      series_phi_p_left_rest = ksl_product_rest(half_angle_of_y, series_phi_n, series_phi_o,
          series_phi_p_left),
      series_phi_p_right_rest = 6.423617534728645e-11 - series_phi_p_right,
      series_phi_p_lo1 = series_phi_p_left_rest - series_phi_p_right_rest,
      series_phi_p_lo2 = series_phi_p_lo1 - 5.034117835500839e-27,
      series_phi_p_lo = series_phi_p_lo2 + series_phi_o_cross,
      series_phi_q = KSL_MUL(half_angle_of_y, series_phi_p),
      series_phi_q_cross1 = KSL_MUL(half_angle_of_y_lo, series_phi_p),
      series_phi_q_cross2 = KSL_MUL(half_angle_of_y, series_phi_p_lo),
      series_phi_q_cross = series_phi_q_cross1 + series_phi_q_cross2,
      series_phi_r = series_phi_q + 9.635426302092969e-09,
      series_phi_r_right = series_phi_r - series_phi_q,
      series_phi_r_left = series_phi_r - series_phi_r_right,
      series_phi_r_left_rest = ksl_product_rest(half_angle_of_y, series_phi_p, series_phi_q,
          series_phi_r_left),
      series_phi_r_right_rest = 9.635426302092969e-09 - series_phi_r_right,
      series_phi_r_lo1 = series_phi_r_left_rest + series_phi_r_right_rest,
      series_phi_r_lo2 = series_phi_r_lo1 + -1.7546051379703029e-25,
      series_phi_r_lo = series_phi_r_lo2 + series_phi_q_cross,
      series_phi_s = KSL_MUL(half_angle_of_y, series_phi_r),
      series_phi_s_cross1 = KSL_MUL(half_angle_of_y_lo, series_phi_r),
      series_phi_s_cross2 = KSL_MUL(half_angle_of_y, series_phi_r_lo),
      series_phi_s_cross = series_phi_s_cross1 + series_phi_s_cross2,
      series_phi_t = series_phi_s - 1.0020843354176687e-06,
      series_phi_t_right = series_phi_s - series_phi_t,
      series_phi_t_left = series_phi_t + series_phi_t_right,
      series_phi_t_left_rest = ksl_product_rest(half_angle_of_y, series_phi_r, series_phi_s,
          series_phi_t_left),
      series_phi_t_right_rest = 1.0020843354176687e-06 - series_phi_t_right,
      series_phi_t_lo1 = series_phi_t_left_rest - series_phi_t_right_rest,
      series_phi_t_lo2 = series_phi_t_lo1 - 4.7926555569351065e-23,
      series_phi_t_lo = series_phi_t_lo2 + series_phi_s_cross,
      series_phi_u = KSL_MUL(half_angle_of_y, series_phi_t),
      series_phi_u_cross1 = KSL_MUL(half_angle_of_y_lo, series_phi_t),
      series_phi_u_cross2 = KSL_MUL(half_angle_of_y, series_phi_t_lo),
      series_phi_u_cross = series_phi_u_cross1 + series_phi_u_cross2,
      series_phi_v = series_phi_u + 6.613756613756614e-05,
      series_phi_v_right = series_phi_v - series_phi_u,
      series_phi_v_left = series_phi_v - series_phi_v_right,
      series_phi_v_left_rest = ksl_product_rest(half_angle_of_y, series_phi_t, series_phi_u,
          series_phi_v_left),
      series_phi_v_right_rest = 6.613756613756614e-05 - series_phi_v_right,
      series_phi_v_lo1 = series_phi_v_left_rest + series_phi_v_right_rest,
      series_phi_v_lo2 = series_phi_v_lo1 + -4.460143857711533e-21,
      series_phi_v_lo = series_phi_v_lo2 + series_phi_u_cross,
      series_phi_w = KSL_MUL(half_angle_of_y, series_phi_v),
      series_phi_w_cross1 = KSL_MUL(half_angle_of_y_lo, series_phi_v),
      series_phi_w_cross2 = KSL_MUL(half_angle_of_y, series_phi_v_lo),
      series_phi_w_cross = series_phi_w_cross1 + series_phi_w_cross2,
      series_phi_x = series_phi_w - 0.002380952380952381,
      series_phi_x_right = series_phi_w - series_phi_x,
      series_phi_x_left = series_phi_x + series_phi_x_right,
      series_phi_x_left_rest = ksl_product_rest(half_angle_of_y, series_phi_v, series_phi_w,
          series_phi_x_left),
      series_phi_x_right_rest = 0.002380952380952381 - series_phi_x_right,
      series_phi_x_lo1 = series_phi_x_left_rest - series_phi_x_right_rest,
      series_phi_x_lo2 = series_phi_x_lo1 - -2.147752875018904e-19,
      series_phi_x_lo = series_phi_x_lo2 + series_phi_w_cross,
      series_phi_y = KSL_MUL(half_angle_of_y, series_phi_x),
      series_phi_y_cross1 = KSL_MUL(half_angle_of_y_lo, series_phi_x),
      series_phi_y_cross2 = KSL_MUL(half_angle_of_y, series_phi_x_lo),
      series_phi_y_cross = series_phi_y_cross1 + series_phi_y_cross2,
      series_phi = series_phi_y + 0.03333333333333333, series_phi_right = series_phi - series_phi_y,
      series_phi_left = series_phi - series_phi_right,
      series_phi_left_rest = ksl_product_rest(half_angle_of_y, series_phi_x, series_phi_y,
          series_phi_left),
      series_phi_right_rest = 0.03333333333333333 - series_phi_right,
      series_phi_lo1 = series_phi_left_rest + series_phi_right_rest,
      series_phi_lo2 = series_phi_lo1 + 4.625929269271486e-19,
      series_phi_lo = series_phi_lo2 + series_phi_y_cross;
  const double f_more_a = KSL_MUL(2.0, half_angle_of_y),
      f_more_a_cross2 = KSL_MUL(2.0, half_angle_of_y_lo), f_more = KSL_MUL(f_more_a, series_phi),
      f_more_cross1 = KSL_MUL(f_more_a_cross2, series_phi),
      f_more_cross2 = KSL_MUL(f_more_a, series_phi_lo),
      f_more_cross = f_more_cross1 + f_more_cross2;
  const double near_f_a = KSL_MUL(0.3333333333333333, sinc),
      near_f_a_cross1 = KSL_MUL(1.850371707708594e-17, sinc),
      near_f_a_cross2 = KSL_MUL(0.3333333333333333, sinc_lo),
      near_f_a_cross = near_f_a_cross1 + near_f_a_cross2,
      f_more_error = ksl_product_error(f_more_a, series_phi, f_more),
      f_more_lo = f_more_error + f_more_cross, near_f_b = KSL_MUL(0.3333333333333333, f_more),
      near_f_b_cross1 = KSL_MUL(1.850371707708594e-17, f_more),
      near_f_b_cross2 = KSL_MUL(0.3333333333333333, f_more_lo),
      near_f_b_cross = near_f_b_cross1 + near_f_b_cross2, near_f = near_f_a + near_f_b,
      near_f_right = near_f - near_f_a, near_f_left = near_f - near_f_right,
      near_f_left_rest = ksl_product_rest(0.3333333333333333, sinc, near_f_a, near_f_left),
      near_f_right_rest = ksl_product_rest(0.3333333333333333, f_more, near_f_b, near_f_right),
      near_f_cross = near_f_a_cross + near_f_b_cross,
      near_f_lo1 = near_f_left_rest + near_f_right_rest, near_f_lo = near_f_lo1 + near_f_cross;
  const double f_rest = sinc - c, f_rest_right = sinc - f_rest, f_rest_left = f_rest + f_rest_right,
      f_rest_left_rest = sinc - f_rest_left, f_rest_right_rest = c - f_rest_right,
      f_rest_lo1 = f_rest_left_rest - f_rest_right_rest, f_rest_lo2 = f_rest_lo1 - c_lo,
      f_rest_lo = f_rest_lo2 + sinc_lo;
  const double x = KSL_MUL(4.0, half_angle_of_y), x_cross2 = KSL_MUL(4.0, half_angle_of_y_lo);
  const double far_y_a_of_x = x + x_cross2, far_y = far_y_a_of_x < 4.0 ? 1.0 : half_angle_of_y,
      far_y_lo = far_y_a_of_x < 4.0 ? 0.0 : half_angle_of_y_lo;
  const double closed_f_of_f_rest = f_rest + f_rest_lo,
      closed_f_of_f_rest_right = closed_f_of_f_rest - f_rest,
      closed_f_of_f_rest_left = closed_f_of_f_rest - closed_f_of_f_rest_right,
      closed_f_of_f_rest_left_rest = f_rest - closed_f_of_f_rest_left,
      closed_f_of_f_rest_right_rest = f_rest_lo - closed_f_of_f_rest_right,
      closed_f_of_f_rest_lo = closed_f_of_f_rest_left_rest + closed_f_of_f_rest_right_rest,
      closed_f_of_far_y = far_y + far_y_lo, closed_f_of_far_y_right = closed_f_of_far_y - far_y,
      closed_f_of_far_y_left = closed_f_of_far_y - closed_f_of_far_y_right,
      closed_f_of_far_y_left_rest = far_y - closed_f_of_far_y_left,
      closed_f_of_far_y_right_rest = far_y_lo - closed_f_of_far_y_right,
      closed_f_of_far_y_lo = closed_f_of_far_y_left_rest + closed_f_of_far_y_right_rest,
      closed_f = closed_f_of_f_rest / closed_f_of_far_y,
      closed_f_product = KSL_MUL(closed_f, closed_f_of_far_y),
      closed_f_product_error = ksl_product_error(closed_f, closed_f_of_far_y, closed_f_product),
      closed_f_rest = closed_f_of_f_rest - closed_f_product,
      closed_f_exact = closed_f_rest - closed_f_product_error,
      closed_f_numerator = closed_f_exact + closed_f_of_f_rest_lo,
      closed_f_cross = KSL_MUL(closed_f, closed_f_of_far_y_lo),
      closed_f_residual = closed_f_numerator - closed_f_cross,
      closed_f_lo = closed_f_residual / closed_f_of_far_y;
  const double f = far_y_a_of_x < 4.0 ? near_f : closed_f,
      f_lo = far_y_a_of_x < 4.0 ? near_f_lo : closed_f_lo;
  const double four_k = KSL_MUL(4.0, sinc), four_k_cross2 = KSL_MUL(4.0, sinc_lo);
  const double b_of_f = f + f_lo, b_of_f_right = b_of_f - f, b_of_f_left = b_of_f - b_of_f_right,
      b_of_f_left_rest = f - b_of_f_left, b_of_f_right_rest = f_lo - b_of_f_right,
      b_of_f_lo = b_of_f_left_rest + b_of_f_right_rest, b_of_four_k = four_k + four_k_cross2,
      b_of_four_k_right = b_of_four_k - four_k, b_of_four_k_left = b_of_four_k - b_of_four_k_right,
      b_of_four_k_left_rest = four_k - b_of_four_k_left,
      b_of_four_k_right_rest = four_k_cross2 - b_of_four_k_right,
      b_of_four_k_lo = b_of_four_k_left_rest + b_of_four_k_right_rest, b = b_of_f / b_of_four_k,
      b_product = KSL_MUL(b, b_of_four_k),
      b_product_error = ksl_product_error(b, b_of_four_k, b_product), b_rest = b_of_f - b_product,
      b_exact = b_rest - b_product_error, b_numerator = b_exact + b_of_f_lo,
      b_cross = KSL_MUL(b, b_of_four_k_lo), b_residual = b_numerator - b_cross,
      b_lo = b_residual / b_of_four_k;
  const double b_across_of_c = c + c_lo, b_across_of_c_right = b_across_of_c - c,
      b_across_of_c_left = b_across_of_c - b_across_of_c_right,
      b_across_of_c_left_rest = c - b_across_of_c_left,
      b_across_of_c_right_rest = c_lo - b_across_of_c_right,
      b_across_of_c_lo = b_across_of_c_left_rest + b_across_of_c_right_rest,
      b_across_of_sinc = sinc + sinc_lo, b_across_of_sinc_right = b_across_of_sinc - sinc,
      b_across_of_sinc_left = b_across_of_sinc - b_across_of_sinc_right,
      b_across_of_sinc_left_rest = sinc - b_across_of_sinc_left,
      b_across_of_sinc_right_rest = sinc_lo - b_across_of_sinc_right,
      b_across_of_sinc_lo = b_across_of_sinc_left_rest + b_across_of_sinc_right_rest,
      b_across = b_across_of_c / b_across_of_sinc,
      b_across_product = KSL_MUL(b_across, b_across_of_sinc),
      b_across_product_error = ksl_product_error(b_across, b_across_of_sinc, b_across_product),
      b_across_rest = b_across_of_c - b_across_product,
      b_across_exact = b_across_rest - b_across_product_error,
      b_across_numerator = b_across_exact + b_across_of_c_lo,
      b_across_cross = KSL_MUL(b_across, b_across_of_sinc_lo),
      b_across_residual = b_across_numerator - b_across_cross,
      b_across_lo = b_across_residual / b_across_of_sinc;
  const double beta_v_0 = KSL_MUL(s->m3, b), beta_v_0_cross2 = KSL_MUL(s->m3, b_lo);
  const double beta_v_1 = KSL_MUL(s->m4, b), beta_v_1_cross2 = KSL_MUL(s->m4, b_lo);
  const double beta_v_2 = KSL_MUL(s->m5, b), beta_v_2_cross2 = KSL_MUL(s->m5, b_lo);
  const double beta_v_0_error = ksl_product_error(s->m3, b, beta_v_0),
      beta_v_0_lo = beta_v_0_error + beta_v_0_cross2, m_0 = KSL_MUL(s->m3, beta_v_0),
      m_0_cross2 = KSL_MUL(s->m3, beta_v_0_lo);
  const double beta_v_1_error = ksl_product_error(s->m4, b, beta_v_1),
      beta_v_1_lo = beta_v_1_error + beta_v_1_cross2, m_1 = KSL_MUL(s->m4, beta_v_1),
      m_1_cross2 = KSL_MUL(s->m4, beta_v_1_lo);
  const double beta_v_2_error = ksl_product_error(s->m5, b, beta_v_2),
      beta_v_2_lo = beta_v_2_error + beta_v_2_cross2, m_2 = KSL_MUL(s->m5, beta_v_2),
      m_2_cross2 = KSL_MUL(s->m5, beta_v_2_lo);
  const double m_3 = KSL_MUL(s->m4, beta_v_0), m_3_cross2 = KSL_MUL(s->m4, beta_v_0_lo);
  const double m_4 = KSL_MUL(s->m5, beta_v_0), m_4_cross2 = KSL_MUL(s->m5, beta_v_0_lo);
  const double m_5 = KSL_MUL(s->m5, beta_v_1), m_5_cross2 = KSL_MUL(s->m5, beta_v_1_lo);
  const double others_0 = m_1 + m_2, others_0_right = others_0 - m_1,
      others_0_left = others_0 - others_0_right,
      others_0_left_rest = ksl_product_rest(s->m4, beta_v_1, m_1, others_0_left),
      others_0_right_rest = ksl_product_rest(s->m5, beta_v_2, m_2, others_0_right),
      others_0_cross = m_1_cross2 + m_2_cross2,
      others_0_lo1 = others_0_left_rest + others_0_right_rest,
      others_0_lo = others_0_lo1 + others_0_cross;
  const double others_1 = m_0 + m_2, others_1_right = others_1 - m_0,
      others_1_left = others_1 - others_1_right,
      others_1_left_rest = ksl_product_rest(s->m3, beta_v_0, m_0, others_1_left),
      others_1_right_rest = ksl_product_rest(s->m5, beta_v_2, m_2, others_1_right),
      others_1_cross = m_0_cross2 + m_2_cross2,
      others_1_lo1 = others_1_left_rest + others_1_right_rest,
      others_1_lo = others_1_lo1 + others_1_cross;
  const double others_2 = m_0 + m_1, others_2_right = others_2 - m_0,
      others_2_left = others_2 - others_2_right,
      others_2_left_rest = ksl_product_rest(s->m3, beta_v_0, m_0, others_2_left),
      others_2_right_rest = ksl_product_rest(s->m4, beta_v_1, m_1, others_2_right),
      others_2_cross = m_0_cross2 + m_1_cross2,
      others_2_lo1 = others_2_left_rest + others_2_right_rest,
      others_2_lo = others_2_lo1 + others_2_cross;
  const double diagonal0a = 1.0 - others_0, diagonal0a_right = 1.0 - diagonal0a,
      diagonal0a_left = diagonal0a + diagonal0a_right, diagonal0a_left_rest = 1.0 - diagonal0a_left,
      diagonal0a_right_rest = others_0 - diagonal0a_right,
      diagonal0a_lo1 = diagonal0a_left_rest - diagonal0a_right_rest,
      diagonal0a_lo = diagonal0a_lo1 - others_0_lo, diagonal0b = b_across + m_0,
      diagonal0b_right = diagonal0b - b_across, diagonal0b_left = diagonal0b - diagonal0b_right,
      diagonal0b_left_rest = b_across - diagonal0b_left,
      diagonal0b_right_rest = ksl_product_rest(s->m3, beta_v_0, m_0, diagonal0b_right),
      diagonal0b_lo1 = diagonal0b_left_rest + diagonal0b_right_rest,
      diagonal0b_lo2 = diagonal0b_lo1 + m_0_cross2, diagonal0b_lo = diagonal0b_lo2 + b_across_lo,
      m_0_error = ksl_product_error(s->m3, beta_v_0, m_0), m_0_lo = m_0_error + m_0_cross2,
      diagonal0c_of_m_0 = m_0 + m_0_lo, diagonal0c_of_others_0 = others_0 + others_0_lo,
      diagonal0 = diagonal0c_of_m_0 < diagonal0c_of_others_0 ? diagonal0b : diagonal0a,
      diagonal0_lo = diagonal0c_of_m_0 < diagonal0c_of_others_0 ? diagonal0b_lo : diagonal0a_lo;
  const double diagonal1a = 1.0 - others_1, diagonal1a_right = 1.0 - diagonal1a,
      diagonal1a_left = diagonal1a + diagonal1a_right, diagonal1a_left_rest = 1.0 - diagonal1a_left,
      diagonal1a_right_rest = others_1 - diagonal1a_right,
      diagonal1a_lo1 = diagonal1a_left_rest - diagonal1a_right_rest,
      diagonal1a_lo = diagonal1a_lo1 - others_1_lo, diagonal1b = b_across + m_1,
      diagonal1b_right = diagonal1b - b_across, diagonal1b_left = diagonal1b - diagonal1b_right,
      diagonal1b_left_rest = b_across - diagonal1b_left,
      diagonal1b_right_rest = ksl_product_rest(s->m4, beta_v_1, m_1, diagonal1b_right),
      diagonal1b_lo1 = diagonal1b_left_rest + diagonal1b_right_rest,
      diagonal1b_lo2 = diagonal1b_lo1 + m_1_cross2, diagonal1b_lo = diagonal1b_lo2 + b_across_lo,
      m_1_error = ksl_product_error(s->m4, beta_v_1, m_1), m_1_lo = m_1_error + m_1_cross2,
      diagonal1c_of_m_1 = m_1 + m_1_lo, diagonal1c_of_others_1 = others_1 + others_1_lo,
      diagonal1 = diagonal1c_of_m_1 < diagonal1c_of_others_1 ? diagonal1b : diagonal1a,
      diagonal1_lo = diagonal1c_of_m_1 < diagonal1c_of_others_1 ? diagonal1b_lo : diagonal1a_lo;
  const double diagonal2a = 1.0 - others_2, diagonal2a_right = 1.0 - diagonal2a,
      diagonal2a_left = diagonal2a + diagonal2a_right, diagonal2a_left_rest = 1.0 - diagonal2a_left,
      diagonal2a_right_rest = others_2 - diagonal2a_right,
      diagonal2a_lo1 = diagonal2a_left_rest - diagonal2a_right_rest,
      diagonal2a_lo = diagonal2a_lo1 - others_2_lo, diagonal2b = b_across + m_2,
      diagonal2b_right = diagonal2b - b_across, diagonal2b_left = diagonal2b - diagonal2b_right,
      diagonal2b_left_rest = b_across - diagonal2b_left,
      diagonal2b_right_rest = ksl_product_rest(s->m5, beta_v_2, m_2, diagonal2b_right),
      diagonal2b_lo1 = diagonal2b_left_rest + diagonal2b_right_rest,
      diagonal2b_lo2 = diagonal2b_lo1 + m_2_cross2, diagonal2b_lo = diagonal2b_lo2 + b_across_lo,
      m_2_error = ksl_product_error(s->m5, beta_v_2, m_2), m_2_lo = m_2_error + m_2_cross2,
      diagonal2c_of_m_2 = m_2 + m_2_lo, diagonal2c_of_others_2 = others_2 + others_2_lo,
      diagonal2 = diagonal2c_of_m_2 < diagonal2c_of_others_2 ? diagonal2b : diagonal2a,
      diagonal2_lo = diagonal2c_of_m_2 < diagonal2c_of_others_2 ? diagonal2b_lo : diagonal2a_lo;
  const double alpha_v_0 = -halved_0;
  const double alpha_v_1 = -halved_1;
  const double alpha_v_2 = -halved_2;
  const double J_1 = m_3 - alpha_v_2, J_1_right = m_3 - J_1, J_1_left = J_1 + J_1_right,
      J_1_left_rest = ksl_product_rest(s->m4, beta_v_0, m_3, J_1_left),
      J_1_right_rest = alpha_v_2 - J_1_right, J_1_lo1 = J_1_left_rest - J_1_right_rest,
      J_1_lo = J_1_lo1 + m_3_cross2;
  const double J_2 = m_4 + alpha_v_1, J_2_right = J_2 - m_4, J_2_left = J_2 - J_2_right,
      J_2_left_rest = ksl_product_rest(s->m5, beta_v_0, m_4, J_2_left),
      J_2_right_rest = alpha_v_1 - J_2_right, J_2_lo1 = J_2_left_rest + J_2_right_rest,
      J_2_lo = J_2_lo1 + m_4_cross2;
  const double J_3 = m_3 + alpha_v_2, J_3_right = J_3 - m_3, J_3_left = J_3 - J_3_right,
      J_3_left_rest = ksl_product_rest(s->m4, beta_v_0, m_3, J_3_left),
      J_3_right_rest = alpha_v_2 - J_3_right, J_3_lo1 = J_3_left_rest + J_3_right_rest,
      J_3_lo = J_3_lo1 + m_3_cross2;
  const double J_5 = m_5 - alpha_v_0, J_5_right = m_5 - J_5, J_5_left = J_5 + J_5_right,
      J_5_left_rest = ksl_product_rest(s->m5, beta_v_1, m_5, J_5_left),
      J_5_right_rest = alpha_v_0 - J_5_right, J_5_lo1 = J_5_left_rest - J_5_right_rest,
      J_5_lo = J_5_lo1 + m_5_cross2;
  const double J_6 = m_4 - alpha_v_1, J_6_right = m_4 - J_6, J_6_left = J_6 + J_6_right,
      J_6_left_rest = ksl_product_rest(s->m5, beta_v_0, m_4, J_6_left),
      J_6_right_rest = alpha_v_1 - J_6_right, J_6_lo1 = J_6_left_rest - J_6_right_rest,
      J_6_lo = J_6_lo1 + m_4_cross2;
  const double J_7 = m_5 + alpha_v_0, J_7_right = J_7 - m_5, J_7_left = J_7 - J_7_right,
      J_7_left_rest = ksl_product_rest(s->m5, beta_v_1, m_5, J_7_left),
      J_7_right_rest = alpha_v_0 - J_7_right, J_7_lo1 = J_7_left_rest + J_7_right_rest,
      J_7_lo = J_7_lo1 + m_5_cross2;
  const double phi_rest_a = KSL_MUL(3.0, b_of_f), phi_rest_a_cross2 = KSL_MUL(3.0, b_of_f_lo),
      phi_rest = phi_rest_a - b_across_of_sinc, phi_rest_right = phi_rest_a - phi_rest,
      phi_rest_left = phi_rest + phi_rest_right,
      phi_rest_left_rest = ksl_product_rest(3.0, b_of_f, phi_rest_a, phi_rest_left),
      phi_rest_right_rest = b_across_of_sinc - phi_rest_right,
      phi_rest_lo1 = phi_rest_left_rest - phi_rest_right_rest,
      phi_rest_lo2 = phi_rest_lo1 - b_across_of_sinc_lo,
      phi_rest_lo = phi_rest_lo2 + phi_rest_a_cross2;
  const double twice_y = KSL_MUL(2.0, closed_f_of_far_y),
      twice_y_cross2 = KSL_MUL(2.0, closed_f_of_far_y_lo);
  const double closed_phi_of_phi_rest = phi_rest + phi_rest_lo,
      closed_phi_of_phi_rest_right = closed_phi_of_phi_rest - phi_rest,
      closed_phi_of_phi_rest_left = closed_phi_of_phi_rest - closed_phi_of_phi_rest_right,
      closed_phi_of_phi_rest_left_rest = phi_rest - closed_phi_of_phi_rest_left,
      closed_phi_of_phi_rest_right_rest = phi_rest_lo - closed_phi_of_phi_rest_right,
      closed_phi_of_phi_rest_lo = closed_phi_of_phi_rest_left_rest +
          closed_phi_of_phi_rest_right_rest,
      closed_phi_of_twice_y = twice_y + twice_y_cross2,
      closed_phi_of_twice_y_right = closed_phi_of_twice_y - twice_y,
      closed_phi_of_twice_y_left = closed_phi_of_twice_y - closed_phi_of_twice_y_right,
      closed_phi_of_twice_y_left_rest = twice_y - closed_phi_of_twice_y_left,
      closed_phi_of_twice_y_right_rest = twice_y_cross2 - closed_phi_of_twice_y_right,
      closed_phi_of_twice_y_lo = closed_phi_of_twice_y_left_rest + closed_phi_of_twice_y_right_rest,
      closed_phi = closed_phi_of_phi_rest / closed_phi_of_twice_y,
      closed_phi_product = KSL_MUL(closed_phi, closed_phi_of_twice_y),
      closed_phi_product_error = ksl_product_error(closed_phi, closed_phi_of_twice_y,
          closed_phi_product),
      closed_phi_rest = closed_phi_of_phi_rest - closed_phi_product,
      closed_phi_exact = closed_phi_rest - closed_phi_product_error,
      closed_phi_numerator = closed_phi_exact + closed_phi_of_phi_rest_lo,
      closed_phi_cross = KSL_MUL(closed_phi, closed_phi_of_twice_y_lo),
      closed_phi_residual = closed_phi_numerator - closed_phi_cross,
      closed_phi_lo = closed_phi_residual / closed_phi_of_twice_y;
  const double phi = far_y_a_of_x < 4.0 ? series_phi : closed_phi,
      phi_lo = far_y_a_of_x < 4.0 ? series_phi_lo : closed_phi_lo;
  const double b_rate_above_a = KSL_MUL(b_of_f, b_of_f),
      b_rate_above_a_cross1 = KSL_MUL(b_of_f_lo, b_of_f),
      b_rate_above_a_cross2 = KSL_MUL(b_of_f, b_of_f_lo),
      b_rate_above_a_cross = b_rate_above_a_cross1 + b_rate_above_a_cross2,
      b_rate_above_a_error = ksl_product_error(b_of_f, b_of_f, b_rate_above_a),
      b_rate_above_a_lo = b_rate_above_a_error + b_rate_above_a_cross,
      b_rate_above_b = KSL_MUL(0.5, b_rate_above_a),
      b_rate_above_b_cross2 = KSL_MUL(0.5, b_rate_above_a_lo),
      b_rate_above_c = KSL_MUL(b_across_of_sinc, phi),
      b_rate_above_c_cross1 = KSL_MUL(b_across_of_sinc_lo, phi),
      b_rate_above_c_cross2 = KSL_MUL(b_across_of_sinc, phi_lo),
      b_rate_above_c_cross = b_rate_above_c_cross1 + b_rate_above_c_cross2,
      b_rate_above = b_rate_above_b - b_rate_above_c,
      b_rate_above_right = b_rate_above_b - b_rate_above,
      b_rate_above_left = b_rate_above + b_rate_above_right,
      b_rate_above_left_rest = b_rate_above_b - b_rate_above_left,
      b_rate_above_right_rest = ksl_product_rest(b_across_of_sinc, phi, b_rate_above_c,
          b_rate_above_right),
      b_rate_above_lo1 = b_rate_above_left_rest - b_rate_above_right_rest,
      b_rate_above_lo2 = b_rate_above_lo1 - b_rate_above_c_cross,
      b_rate_above_lo = b_rate_above_lo2 + b_rate_above_b_cross2;
  const double b_rate_below_a = KSL_MUL(b_across_of_sinc, b_across_of_sinc),
      b_rate_below_a_cross1 = KSL_MUL(b_across_of_sinc_lo, b_across_of_sinc),
      b_rate_below_a_cross2 = KSL_MUL(b_across_of_sinc, b_across_of_sinc_lo),
      b_rate_below_a_cross = b_rate_below_a_cross1 + b_rate_below_a_cross2,
      b_rate_below_a_error = ksl_product_error(b_across_of_sinc, b_across_of_sinc, b_rate_below_a),
      b_rate_below_a_lo = b_rate_below_a_error + b_rate_below_a_cross,
      b_rate_below = KSL_MUL(8.0, b_rate_below_a),
      b_rate_below_cross2 = KSL_MUL(8.0, b_rate_below_a_lo);
  const double b_rate_of_b_rate_above = b_rate_above + b_rate_above_lo,
      b_rate_of_b_rate_above_right = b_rate_of_b_rate_above - b_rate_above,
      b_rate_of_b_rate_above_left = b_rate_of_b_rate_above - b_rate_of_b_rate_above_right,
      b_rate_of_b_rate_above_left_rest = b_rate_above - b_rate_of_b_rate_above_left,
      b_rate_of_b_rate_above_right_rest = b_rate_above_lo - b_rate_of_b_rate_above_right,
      b_rate_of_b_rate_above_lo = b_rate_of_b_rate_above_left_rest +
          b_rate_of_b_rate_above_right_rest,
      b_rate_of_b_rate_below = b_rate_below + b_rate_below_cross2,
      b_rate_of_b_rate_below_right = b_rate_of_b_rate_below - b_rate_below,
      b_rate_of_b_rate_below_left = b_rate_of_b_rate_below - b_rate_of_b_rate_below_right,
      b_rate_of_b_rate_below_left_rest = b_rate_below - b_rate_of_b_rate_below_left,
      b_rate_of_b_rate_below_right_rest = b_rate_below_cross2 - b_rate_of_b_rate_below_right,
      b_rate_of_b_rate_below_lo = b_rate_of_b_rate_below_left_rest +
          b_rate_of_b_rate_below_right_rest,
      b_rate = b_rate_of_b_rate_above / b_rate_of_b_rate_below,
      b_rate_product = KSL_MUL(b_rate, b_rate_of_b_rate_below),
      b_rate_product_error = ksl_product_error(b_rate, b_rate_of_b_rate_below, b_rate_product),
      b_rate_rest = b_rate_of_b_rate_above - b_rate_product,
      b_rate_exact = b_rate_rest - b_rate_product_error,
      b_rate_numerator = b_rate_exact + b_rate_of_b_rate_above_lo,
      b_rate_cross = KSL_MUL(b_rate, b_rate_of_b_rate_below_lo),
      b_rate_residual = b_rate_numerator - b_rate_cross,
      b_rate_lo = b_rate_residual / b_rate_of_b_rate_below;
  const double rate_vw_a = KSL_MUL(s->m0, s->m3), rate_vw_b = KSL_MUL(s->m1, s->m4),
      rate_vw_c = rate_vw_a + rate_vw_b, rate_vw_c_right = rate_vw_c - rate_vw_a,
      rate_vw_c_left = rate_vw_c - rate_vw_c_right,
      rate_vw_c_left_rest = ksl_product_rest(s->m0, s->m3, rate_vw_a, rate_vw_c_left),
      rate_vw_c_right_rest = ksl_product_rest(s->m1, s->m4, rate_vw_b, rate_vw_c_right),
      rate_vw_c_lo = rate_vw_c_left_rest + rate_vw_c_right_rest, rate_vw_d = KSL_MUL(s->m2, s->m5),
      rate_vw = rate_vw_c + rate_vw_d, rate_vw_right = rate_vw - rate_vw_c,
      rate_vw_left = rate_vw - rate_vw_right, rate_vw_left_rest = rate_vw_c - rate_vw_left,
      rate_vw_right_rest = ksl_product_rest(s->m2, s->m5, rate_vw_d, rate_vw_right),
      rate_vw_lo1 = rate_vw_left_rest + rate_vw_right_rest, rate_vw_lo = rate_vw_lo1 + rate_vw_c_lo;
  const double rate_bend_a = KSL_MUL(b_rate, rate_vw),
      rate_bend_a_cross1 = KSL_MUL(b_rate_lo, rate_vw),
      rate_bend_a_cross2 = KSL_MUL(b_rate, rate_vw_lo),
      rate_bend_a_cross = rate_bend_a_cross1 + rate_bend_a_cross2, rate_bend = -rate_bend_a,
      rate_bend_cross = -rate_bend_a_cross, rate_bend_factor = -b_rate;
  const double rate_q_0a = KSL_MUL(0.5, s->m0), rate_q_0 = -rate_q_0a;
  const double rate_q_1a = KSL_MUL(0.5, s->m1), rate_q_1 = -rate_q_1a;
  const double rate_q_2a = KSL_MUL(0.5, s->m2), rate_q_2 = -rate_q_2a;
  const double rate_beta_v_0 = KSL_MUL(s->m0, b), rate_beta_v_0_cross2 = KSL_MUL(s->m0, b_lo);
  const double rate_beta_v_1 = KSL_MUL(s->m1, b), rate_beta_v_1_cross2 = KSL_MUL(s->m1, b_lo);
  const double rate_beta_v_2 = KSL_MUL(s->m2, b), rate_beta_v_2_cross2 = KSL_MUL(s->m2, b_lo);
  const double rate_bend_error = ksl_product_error(rate_bend_factor, rate_vw, rate_bend),
      rate_bend_lo = rate_bend_error + rate_bend_cross, rate_bend_w_0 = KSL_MUL(s->m3, rate_bend),
      rate_bend_w_0_cross2 = KSL_MUL(s->m3, rate_bend_lo);
  const double rate_bend_w_1 = KSL_MUL(s->m4, rate_bend),
      rate_bend_w_1_cross2 = KSL_MUL(s->m4, rate_bend_lo);
  const double rate_bend_w_2 = KSL_MUL(s->m5, rate_bend),
      rate_bend_w_2_cross2 = KSL_MUL(s->m5, rate_bend_lo);
  const double rate_beta_v_1_error = ksl_product_error(s->m1, b, rate_beta_v_1),
      rate_beta_v_1_lo = rate_beta_v_1_error + rate_beta_v_1_cross2,
      rate_symmetric_0a = KSL_MUL(s->m3, rate_beta_v_1),
      rate_symmetric_0a_cross2 = KSL_MUL(s->m3, rate_beta_v_1_lo),
      rate_beta_v_0_error = ksl_product_error(s->m0, b, rate_beta_v_0),
      rate_beta_v_0_lo = rate_beta_v_0_error + rate_beta_v_0_cross2,
      rate_symmetric_0b = KSL_MUL(s->m4, rate_beta_v_0),
      rate_symmetric_0b_cross2 = KSL_MUL(s->m4, rate_beta_v_0_lo),
      rate_symmetric_0c = rate_symmetric_0a + rate_symmetric_0b,
      rate_symmetric_0c_right = rate_symmetric_0c - rate_symmetric_0a,
      rate_symmetric_0c_left = rate_symmetric_0c - rate_symmetric_0c_right,
      rate_symmetric_0c_left_rest = ksl_product_rest(s->m3, rate_beta_v_1, rate_symmetric_0a,
          rate_symmetric_0c_left),
      rate_symmetric_0c_right_rest = ksl_product_rest(s->m4, rate_beta_v_0, rate_symmetric_0b,
          rate_symmetric_0c_right),
      rate_symmetric_0c_cross = rate_symmetric_0a_cross2 + rate_symmetric_0b_cross2,
      rate_symmetric_0c_lo1 = rate_symmetric_0c_left_rest + rate_symmetric_0c_right_rest,
      rate_symmetric_0c_lo = rate_symmetric_0c_lo1 + rate_symmetric_0c_cross,
      rate_bend_w_0_error = ksl_product_error(s->m3, rate_bend, rate_bend_w_0),
      rate_bend_w_0_lo = rate_bend_w_0_error + rate_bend_w_0_cross2,
      rate_symmetric_0d = KSL_MUL(s->m4, rate_bend_w_0),
      rate_symmetric_0d_cross2 = KSL_MUL(s->m4, rate_bend_w_0_lo),
      rate_symmetric_0 = rate_symmetric_0c - rate_symmetric_0d,
      rate_symmetric_0_right = rate_symmetric_0c - rate_symmetric_0,
      rate_symmetric_0_left = rate_symmetric_0 + rate_symmetric_0_right,
      rate_symmetric_0_left_rest = rate_symmetric_0c - rate_symmetric_0_left,
      rate_symmetric_0_right_rest = ksl_product_rest(s->m4, rate_bend_w_0, rate_symmetric_0d,
          rate_symmetric_0_right),
      rate_symmetric_0_lo1 = rate_symmetric_0_left_rest - rate_symmetric_0_right_rest,
      rate_symmetric_0_lo2 = rate_symmetric_0_lo1 - rate_symmetric_0d_cross2,
      rate_symmetric_0_lo = rate_symmetric_0_lo2 + rate_symmetric_0c_lo;
  const double rate_beta_v_2_error = ksl_product_error(s->m2, b, rate_beta_v_2),
      rate_beta_v_2_lo = rate_beta_v_2_error + rate_beta_v_2_cross2,
      rate_symmetric_1a = KSL_MUL(s->m3, rate_beta_v_2),
      rate_symmetric_1a_cross2 = KSL_MUL(s->m3, rate_beta_v_2_lo),
      rate_symmetric_1b = KSL_MUL(s->m5, rate_beta_v_0),
      rate_symmetric_1b_cross2 = KSL_MUL(s->m5, rate_beta_v_0_lo),
      rate_symmetric_1c = rate_symmetric_1a + rate_symmetric_1b,
      rate_symmetric_1c_right = rate_symmetric_1c - rate_symmetric_1a,
      rate_symmetric_1c_left = rate_symmetric_1c - rate_symmetric_1c_right,
      rate_symmetric_1c_left_rest = ksl_product_rest(s->m3, rate_beta_v_2, rate_symmetric_1a,
          rate_symmetric_1c_left),
      rate_symmetric_1c_right_rest = ksl_product_rest(s->m5, rate_beta_v_0, rate_symmetric_1b,
          rate_symmetric_1c_right),
      rate_symmetric_1c_cross = rate_symmetric_1a_cross2 + rate_symmetric_1b_cross2,
      rate_symmetric_1c_lo1 = rate_symmetric_1c_left_rest + rate_symmetric_1c_right_rest,
      rate_symmetric_1c_lo = rate_symmetric_1c_lo1 + rate_symmetric_1c_cross,
      rate_symmetric_1d = KSL_MUL(s->m5, rate_bend_w_0),
      rate_symmetric_1d_cross2 = KSL_MUL(s->m5, rate_bend_w_0_lo),
      rate_symmetric_1 = rate_symmetric_1c - rate_symmetric_1d,
      rate_symmetric_1_right = rate_symmetric_1c - rate_symmetric_1,
      rate_symmetric_1_left = rate_symmetric_1 + rate_symmetric_1_right,
      rate_symmetric_1_left_rest = rate_symmetric_1c - rate_symmetric_1_left,
      rate_symmetric_1_right_rest = ksl_product_rest(s->m5, rate_bend_w_0, rate_symmetric_1d,
          rate_symmetric_1_right),
      rate_symmetric_1_lo1 = rate_symmetric_1_left_rest - rate_symmetric_1_right_rest,
      rate_symmetric_1_lo2 = rate_symmetric_1_lo1 - rate_symmetric_1d_cross2,
      rate_symmetric_1_lo = rate_symmetric_1_lo2 + rate_symmetric_1c_lo;
  const double rate_symmetric_2a = KSL_MUL(s->m4, rate_beta_v_2),
      rate_symmetric_2a_cross2 = KSL_MUL(s->m4, rate_beta_v_2_lo),
      rate_symmetric_2b = KSL_MUL(s->m5, rate_beta_v_1),
      rate_symmetric_2b_cross2 = KSL_MUL(s->m5, rate_beta_v_1_lo),
      rate_symmetric_2c = rate_symmetric_2a + rate_symmetric_2b,
      rate_symmetric_2c_right = rate_symmetric_2c - rate_symmetric_2a,
      rate_symmetric_2c_left = rate_symmetric_2c - rate_symmetric_2c_right,
      rate_symmetric_2c_left_rest = ksl_product_rest(s->m4, rate_beta_v_2, rate_symmetric_2a,
          rate_symmetric_2c_left),
      rate_symmetric_2c_right_rest = ksl_product_rest(s->m5, rate_beta_v_1, rate_symmetric_2b,
          rate_symmetric_2c_right),
      rate_symmetric_2c_cross = rate_symmetric_2a_cross2 + rate_symmetric_2b_cross2,
      rate_symmetric_2c_lo1 = rate_symmetric_2c_left_rest + rate_symmetric_2c_right_rest,
      rate_symmetric_2c_lo = rate_symmetric_2c_lo1 + rate_symmetric_2c_cross,
      rate_bend_w_1_error = ksl_product_error(s->m4, rate_bend, rate_bend_w_1),
      rate_bend_w_1_lo = rate_bend_w_1_error + rate_bend_w_1_cross2,
      rate_symmetric_2d = KSL_MUL(s->m5, rate_bend_w_1),
      rate_symmetric_2d_cross2 = KSL_MUL(s->m5, rate_bend_w_1_lo),
      rate_symmetric_2 = rate_symmetric_2c - rate_symmetric_2d,
      rate_symmetric_2_right = rate_symmetric_2c - rate_symmetric_2,
      rate_symmetric_2_left = rate_symmetric_2 + rate_symmetric_2_right,
      rate_symmetric_2_left_rest = rate_symmetric_2c - rate_symmetric_2_left,
      rate_symmetric_2_right_rest = ksl_product_rest(s->m5, rate_bend_w_1, rate_symmetric_2d,
          rate_symmetric_2_right),
      rate_symmetric_2_lo1 = rate_symmetric_2_left_rest - rate_symmetric_2_right_rest,
      rate_symmetric_2_lo2 = rate_symmetric_2_lo1 - rate_symmetric_2d_cross2,
      rate_symmetric_2_lo = rate_symmetric_2_lo2 + rate_symmetric_2c_lo;
  const double rate_diagonal_0a = KSL_MUL(s->m4, rate_bend_w_1),
      rate_diagonal_0a_cross2 = KSL_MUL(s->m4, rate_bend_w_1_lo),
      rate_bend_w_2_error = ksl_product_error(s->m5, rate_bend, rate_bend_w_2),
      rate_bend_w_2_lo = rate_bend_w_2_error + rate_bend_w_2_cross2,
      rate_diagonal_0b = KSL_MUL(s->m5, rate_bend_w_2),
      rate_diagonal_0b_cross2 = KSL_MUL(s->m5, rate_bend_w_2_lo),
      rate_diagonal_0c = rate_diagonal_0a + rate_diagonal_0b,
      rate_diagonal_0c_right = rate_diagonal_0c - rate_diagonal_0a,
      rate_diagonal_0c_left = rate_diagonal_0c - rate_diagonal_0c_right,
      rate_diagonal_0c_left_rest = ksl_product_rest(s->m4, rate_bend_w_1, rate_diagonal_0a,
          rate_diagonal_0c_left),
      rate_diagonal_0c_right_rest = ksl_product_rest(s->m5, rate_bend_w_2, rate_diagonal_0b,
          rate_diagonal_0c_right),
      rate_diagonal_0c_cross = rate_diagonal_0a_cross2 + rate_diagonal_0b_cross2,
      rate_diagonal_0c_lo1 = rate_diagonal_0c_left_rest + rate_diagonal_0c_right_rest,
      rate_diagonal_0c_lo = rate_diagonal_0c_lo1 + rate_diagonal_0c_cross,
      rate_diagonal_0d = KSL_MUL(2.0, s->m4),
      rate_diagonal_0e = KSL_MUL(rate_diagonal_0d, rate_beta_v_1),
      rate_diagonal_0e_cross2 = KSL_MUL(rate_diagonal_0d, rate_beta_v_1_lo),
      rate_diagonal_0f = KSL_MUL(2.0, s->m5),
      rate_diagonal_0g = KSL_MUL(rate_diagonal_0f, rate_beta_v_2),
      rate_diagonal_0g_cross2 = KSL_MUL(rate_diagonal_0f, rate_beta_v_2_lo),
      rate_diagonal_0h = rate_diagonal_0e + rate_diagonal_0g,
      rate_diagonal_0h_right = rate_diagonal_0h - rate_diagonal_0e,
      rate_diagonal_0h_left = rate_diagonal_0h - rate_diagonal_0h_right,
      rate_diagonal_0h_left_rest = ksl_product_rest(rate_diagonal_0d, rate_beta_v_1,
          rate_diagonal_0e, rate_diagonal_0h_left),
      rate_diagonal_0h_right_rest = ksl_product_rest(rate_diagonal_0f, rate_beta_v_2,
          rate_diagonal_0g, rate_diagonal_0h_right),
      rate_diagonal_0h_cross = rate_diagonal_0e_cross2 + rate_diagonal_0g_cross2,
      rate_diagonal_0h_lo1 = rate_diagonal_0h_left_rest + rate_diagonal_0h_right_rest,
      rate_diagonal_0h_lo = rate_diagonal_0h_lo1 + rate_diagonal_0h_cross,
      rate_diagonal_0 = rate_diagonal_0c - rate_diagonal_0h,
      rate_diagonal_0_right = rate_diagonal_0c - rate_diagonal_0,
      rate_diagonal_0_left = rate_diagonal_0 + rate_diagonal_0_right,
      rate_diagonal_0_left_rest = rate_diagonal_0c - rate_diagonal_0_left,
      rate_diagonal_0_right_rest = rate_diagonal_0h - rate_diagonal_0_right,
      rate_diagonal_0_lo1 = rate_diagonal_0_left_rest - rate_diagonal_0_right_rest,
      rate_diagonal_0_lo2 = rate_diagonal_0_lo1 - rate_diagonal_0h_lo,
      rate_diagonal_0_lo = rate_diagonal_0_lo2 + rate_diagonal_0c_lo;
  const double rate_diagonal_1a = KSL_MUL(s->m3, rate_bend_w_0),
      rate_diagonal_1a_cross2 = KSL_MUL(s->m3, rate_bend_w_0_lo),
      rate_diagonal_1b = rate_diagonal_1a + rate_diagonal_0b,
      rate_diagonal_1b_right = rate_diagonal_1b - rate_diagonal_1a,
      rate_diagonal_1b_left = rate_diagonal_1b - rate_diagonal_1b_right,
      rate_diagonal_1b_left_rest = ksl_product_rest(s->m3, rate_bend_w_0, rate_diagonal_1a,
          rate_diagonal_1b_left),
      rate_diagonal_1b_right_rest = ksl_product_rest(s->m5, rate_bend_w_2, rate_diagonal_0b,
          rate_diagonal_1b_right),
      rate_diagonal_1b_cross = rate_diagonal_1a_cross2 + rate_diagonal_0b_cross2,
      rate_diagonal_1b_lo1 = rate_diagonal_1b_left_rest + rate_diagonal_1b_right_rest,
      rate_diagonal_1b_lo = rate_diagonal_1b_lo1 + rate_diagonal_1b_cross,
      rate_diagonal_1c = KSL_MUL(2.0, s->m3),
      rate_diagonal_1d = KSL_MUL(rate_diagonal_1c, rate_beta_v_0),
      rate_diagonal_1d_cross2 = KSL_MUL(rate_diagonal_1c, rate_beta_v_0_lo),
      rate_diagonal_1e = rate_diagonal_1d + rate_diagonal_0g,
      rate_diagonal_1e_right = rate_diagonal_1e - rate_diagonal_1d,
      rate_diagonal_1e_left = rate_diagonal_1e - rate_diagonal_1e_right,
      rate_diagonal_1e_left_rest = ksl_product_rest(rate_diagonal_1c, rate_beta_v_0,
          rate_diagonal_1d, rate_diagonal_1e_left),
      rate_diagonal_1e_right_rest = ksl_product_rest(rate_diagonal_0f, rate_beta_v_2,
          rate_diagonal_0g, rate_diagonal_1e_right),
      rate_diagonal_1e_cross = rate_diagonal_1d_cross2 + rate_diagonal_0g_cross2,
      rate_diagonal_1e_lo1 = rate_diagonal_1e_left_rest + rate_diagonal_1e_right_rest,
      rate_diagonal_1e_lo = rate_diagonal_1e_lo1 + rate_diagonal_1e_cross,
      rate_diagonal_1 = rate_diagonal_1b - rate_diagonal_1e,
      rate_diagonal_1_right = rate_diagonal_1b - rate_diagonal_1,
      rate_diagonal_1_left = rate_diagonal_1 + rate_diagonal_1_right,
      rate_diagonal_1_left_rest = rate_diagonal_1b - rate_diagonal_1_left,
      rate_diagonal_1_right_rest = rate_diagonal_1e - rate_diagonal_1_right,
      rate_diagonal_1_lo1 = rate_diagonal_1_left_rest - rate_diagonal_1_right_rest,
      rate_diagonal_1_lo2 = rate_diagonal_1_lo1 - rate_diagonal_1e_lo,
      rate_diagonal_1_lo = rate_diagonal_1_lo2 + rate_diagonal_1b_lo;
  const double rate_diagonal_2a = rate_diagonal_1a + rate_diagonal_0a,
      rate_diagonal_2a_right = rate_diagonal_2a - rate_diagonal_1a,
      rate_diagonal_2a_left = rate_diagonal_2a - rate_diagonal_2a_right,
      rate_diagonal_2a_left_rest = ksl_product_rest(s->m3, rate_bend_w_0, rate_diagonal_1a,
          rate_diagonal_2a_left),
      rate_diagonal_2a_right_rest = ksl_product_rest(s->m4, rate_bend_w_1, rate_diagonal_0a,
          rate_diagonal_2a_right),
      rate_diagonal_2a_cross = rate_diagonal_1a_cross2 + rate_diagonal_0a_cross2,
      rate_diagonal_2a_lo1 = rate_diagonal_2a_left_rest + rate_diagonal_2a_right_rest,
      rate_diagonal_2a_lo = rate_diagonal_2a_lo1 + rate_diagonal_2a_cross,
      rate_diagonal_2b = rate_diagonal_1d + rate_diagonal_0e,
      rate_diagonal_2b_right = rate_diagonal_2b - rate_diagonal_1d,
      rate_diagonal_2b_left = rate_diagonal_2b - rate_diagonal_2b_right,
      rate_diagonal_2b_left_rest = ksl_product_rest(rate_diagonal_1c, rate_beta_v_0,
          rate_diagonal_1d, rate_diagonal_2b_left),
      rate_diagonal_2b_right_rest = ksl_product_rest(rate_diagonal_0d, rate_beta_v_1,
          rate_diagonal_0e, rate_diagonal_2b_right),
      rate_diagonal_2b_cross = rate_diagonal_1d_cross2 + rate_diagonal_0e_cross2,
      rate_diagonal_2b_lo1 = rate_diagonal_2b_left_rest + rate_diagonal_2b_right_rest,
      rate_diagonal_2b_lo = rate_diagonal_2b_lo1 + rate_diagonal_2b_cross,
      rate_diagonal_2 = rate_diagonal_2a - rate_diagonal_2b,
      rate_diagonal_2_right = rate_diagonal_2a - rate_diagonal_2,
      rate_diagonal_2_left = rate_diagonal_2 + rate_diagonal_2_right,
      rate_diagonal_2_left_rest = rate_diagonal_2a - rate_diagonal_2_left,
      rate_diagonal_2_right_rest = rate_diagonal_2b - rate_diagonal_2_right,
      rate_diagonal_2_lo1 = rate_diagonal_2_left_rest - rate_diagonal_2_right_rest,
      rate_diagonal_2_lo2 = rate_diagonal_2_lo1 - rate_diagonal_2b_lo,
      rate_diagonal_2_lo = rate_diagonal_2_lo2 + rate_diagonal_2a_lo;
  const double M_04 = rate_symmetric_0 - rate_q_2, M_04_right = rate_symmetric_0 - M_04,
      M_04_left = M_04 + M_04_right, M_04_left_rest = rate_symmetric_0 - M_04_left,
      M_04_right_rest = rate_q_2 - M_04_right, M_04_lo1 = M_04_left_rest - M_04_right_rest,
      M_04_lo = M_04_lo1 + rate_symmetric_0_lo;
  const double M_05 = rate_q_1 + rate_symmetric_1, M_05_right = M_05 - rate_q_1,
      M_05_left = M_05 - M_05_right, M_05_left_rest = rate_q_1 - M_05_left,
      M_05_right_rest = rate_symmetric_1 - M_05_right, M_05_lo1 = M_05_left_rest + M_05_right_rest,
      M_05_lo = M_05_lo1 + rate_symmetric_1_lo;
  const double M_13 = rate_q_2 + rate_symmetric_0, M_13_right = M_13 - rate_q_2,
      M_13_left = M_13 - M_13_right, M_13_left_rest = rate_q_2 - M_13_left,
      M_13_right_rest = rate_symmetric_0 - M_13_right, M_13_lo1 = M_13_left_rest + M_13_right_rest,
      M_13_lo = M_13_lo1 + rate_symmetric_0_lo;
  const double M_15 = rate_symmetric_2 - rate_q_0, M_15_right = rate_symmetric_2 - M_15,
      M_15_left = M_15 + M_15_right, M_15_left_rest = rate_symmetric_2 - M_15_left,
      M_15_right_rest = rate_q_0 - M_15_right, M_15_lo1 = M_15_left_rest - M_15_right_rest,
      M_15_lo = M_15_lo1 + rate_symmetric_2_lo;
  const double M_23 = rate_symmetric_1 - rate_q_1, M_23_right = rate_symmetric_1 - M_23,
      M_23_left = M_23 + M_23_right, M_23_left_rest = rate_symmetric_1 - M_23_left,
      M_23_right_rest = rate_q_1 - M_23_right, M_23_lo1 = M_23_left_rest - M_23_right_rest,
      M_23_lo = M_23_lo1 + rate_symmetric_1_lo;
  const double M_24 = rate_q_0 + rate_symmetric_2, M_24_right = M_24 - rate_q_0,
      M_24_left = M_24 - M_24_right, M_24_left_rest = rate_q_0 - M_24_left,
      M_24_right_rest = rate_symmetric_2 - M_24_right, M_24_lo1 = M_24_left_rest + M_24_right_rest,
      M_24_lo = M_24_lo1 + rate_symmetric_2_lo;
  const double diagonal0_rounded = diagonal0 + diagonal0_lo,
      diagonal0_final = diagonal0_rounded == diagonal0_rounded ? diagonal0_rounded : diagonal0;
  const double J_1_rounded = J_1 + J_1_lo,
      J_1_final = J_1_rounded == J_1_rounded ? J_1_rounded : J_1;
  const double J_2_rounded = J_2 + J_2_lo,
      J_2_final = J_2_rounded == J_2_rounded ? J_2_rounded : J_2;
  const double rate_diagonal_0_rounded = rate_diagonal_0 + rate_diagonal_0_lo,
      rate_diagonal_0_final = rate_diagonal_0_rounded == rate_diagonal_0_rounded ?
          rate_diagonal_0_rounded : rate_diagonal_0;
  const double M_04_rounded = M_04 + M_04_lo,
      M_04_final = M_04_rounded == M_04_rounded ? M_04_rounded : M_04;
  const double M_05_rounded = M_05 + M_05_lo,
      M_05_final = M_05_rounded == M_05_rounded ? M_05_rounded : M_05;
  const double J_3_rounded = J_3 + J_3_lo,
      J_3_final = J_3_rounded == J_3_rounded ? J_3_rounded : J_3;
  const double diagonal1_rounded = diagonal1 + diagonal1_lo,
      diagonal1_final = diagonal1_rounded == diagonal1_rounded ? diagonal1_rounded : diagonal1;
  const double J_5_rounded = J_5 + J_5_lo,
      J_5_final = J_5_rounded == J_5_rounded ? J_5_rounded : J_5;
  const double M_13_rounded = M_13 + M_13_lo,
      M_13_final = M_13_rounded == M_13_rounded ? M_13_rounded : M_13;
  const double rate_diagonal_1_rounded = rate_diagonal_1 + rate_diagonal_1_lo,
      rate_diagonal_1_final = rate_diagonal_1_rounded == rate_diagonal_1_rounded ?
          rate_diagonal_1_rounded : rate_diagonal_1;
  const double M_15_rounded = M_15 + M_15_lo,
      M_15_final = M_15_rounded == M_15_rounded ? M_15_rounded : M_15;
  const double J_6_rounded = J_6 + J_6_lo,
      J_6_final = J_6_rounded == J_6_rounded ? J_6_rounded : J_6;
  const double J_7_rounded = J_7 + J_7_lo,
      J_7_final = J_7_rounded == J_7_rounded ? J_7_rounded : J_7;
  const double diagonal2_rounded = diagonal2 + diagonal2_lo,
      diagonal2_final = diagonal2_rounded == diagonal2_rounded ? diagonal2_rounded : diagonal2;
  const double M_23_rounded = M_23 + M_23_lo,
      M_23_final = M_23_rounded == M_23_rounded ? M_23_rounded : M_23;
  const double M_24_rounded = M_24 + M_24_lo,
      M_24_final = M_24_rounded == M_24_rounded ? M_24_rounded : M_24;
  const double rate_diagonal_2_rounded = rate_diagonal_2 + rate_diagonal_2_lo,
      rate_diagonal_2_final = rate_diagonal_2_rounded == rate_diagonal_2_rounded ?
          rate_diagonal_2_rounded : rate_diagonal_2;
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
  const double halved_0 = KSL_MUL(0.5, s->m3);
  const double halved_1 = KSL_MUL(0.5, s->m4);
  const double halved_2 = KSL_MUL(0.5, s->m5);
  const double y_a = KSL_MUL(halved_0, halved_0), y_b = KSL_MUL(halved_1, halved_1),
      y_c = y_a + y_b, y_c_right = y_c - y_a, y_c_left = y_c - y_c_right,
      y_c_left_rest = ksl_product_rest(halved_0, halved_0, y_a, y_c_left),
      y_c_right_rest = ksl_product_rest(halved_1, halved_1, y_b, y_c_right),
      y_c_lo = y_c_left_rest + y_c_right_rest, y_d = KSL_MUL(halved_2, halved_2), y = y_c + y_d,
      y_right = y - y_c, y_left = y - y_right, y_left_rest = y_c - y_left,
      y_right_rest = ksl_product_rest(halved_2, halved_2, y_d, y_right),
      y_lo1 = y_left_rest + y_right_rest, y_lo = y_lo1 + y_c_lo;
  const double half_angle_of_y = y + y_lo, half_angle_of_y_right = half_angle_of_y - y,
      half_angle_of_y_left = half_angle_of_y - half_angle_of_y_right,
      half_angle_of_y_left_rest = y - half_angle_of_y_left,
      half_angle_of_y_right_rest = y_lo - half_angle_of_y_right,
      half_angle_of_y_lo = half_angle_of_y_left_rest + half_angle_of_y_right_rest,
      half_angle = sqrt(half_angle_of_y), half_angle_product = KSL_MUL(half_angle, half_angle),
      half_angle_product_error = ksl_product_error(half_angle, half_angle, half_angle_product),
      half_angle_rest = half_angle_of_y - half_angle_product,
      half_angle_exact = half_angle_rest - half_angle_product_error,
      half_angle_residual = half_angle_exact + half_angle_of_y_lo,
      half_angle_twice = half_angle + half_angle,
      half_angle_divisor = half_angle == 0.0 ? 1.0 : half_angle_twice,
      half_angle_lo = half_angle_residual / half_angle_divisor;
  const double sine_of_half_angle = half_angle + half_angle_lo,
      sine_of_half_angle_right = sine_of_half_angle - half_angle,
      sine_of_half_angle_left = sine_of_half_angle - sine_of_half_angle_right,
      sine_of_half_angle_left_rest = half_angle - sine_of_half_angle_left,
      sine_of_half_angle_right_rest = half_angle_lo - sine_of_half_angle_right,
      sine_of_half_angle_lo = sine_of_half_angle_left_rest + sine_of_half_angle_right_rest;
  double c; const double sine = ksl_sincos(sine_of_half_angle, &c);
  double c_own_error; const double sine_own_error = ksl_sincos_error(sine_of_half_angle, sine, c,
      &c_own_error);
  const double sine_half = KSL_MUL(sine_of_half_angle_lo, 0.5);
  double sine_half_cos; const double sine_half_sin = ksl_sincos(sine_half, &sine_half_cos);
  const double sine_twice = sine_half_sin + sine_half_sin, sine_slope1 = KSL_MUL(sine_half_cos, c),
      sine_slope2 = KSL_MUL(sine_half_sin, sine), sine_slope = sine_slope1 - sine_slope2,
      sine_more = KSL_MUL(sine_slope, sine_twice), sine_lo = sine_own_error + sine_more;
  const double c_slope1 = KSL_MUL(sine_half_cos, sine), c_slope2 = KSL_MUL(sine_half_sin, c),
      c_slope = c_slope1 + c_slope2, c_more = KSL_MUL(c_slope, sine_twice),
      c_lo = c_own_error - c_more;
  const double sinc_divisor = sine_of_half_angle < 1.4901161193847656e-08 ? 1.4901161193847656e-08 :
      sine_of_half_angle,
      sinc_divisor_lo = sine_of_half_angle < 1.4901161193847656e-08 ? 0.0 : sine_of_half_angle_lo;
  const double sinc_quotient_of_sine = sine + sine_lo,
      sinc_quotient_of_sine_right = sinc_quotient_of_sine - sine,
      sinc_quotient_of_sine_left = sinc_quotient_of_sine - sinc_quotient_of_sine_right,
      sinc_quotient_of_sine_left_rest = sine - sinc_quotient_of_sine_left,
      sinc_quotient_of_sine_right_rest = sine_lo - sinc_quotient_of_sine_right,
      sinc_quotient_of_sine_lo = sinc_quotient_of_sine_left_rest + sinc_quotient_of_sine_right_rest,
      sinc_quotient_of_sinc_divisor = sinc_divisor + sinc_divisor_lo,
      sinc_quotient_of_sinc_divisor_right = sinc_quotient_of_sinc_divisor - sinc_divisor,
      sinc_quotient_of_sinc_divisor_left = sinc_quotient_of_sinc_divisor -
          sinc_quotient_of_sinc_divisor_right,
      sinc_quotient_of_sinc_divisor_left_rest = sinc_divisor - sinc_quotient_of_sinc_divisor_left,
      sinc_quotient_of_sinc_divisor_right_rest = sinc_divisor_lo -
          sinc_quotient_of_sinc_divisor_right,
      sinc_quotient_of_sinc_divisor_lo = sinc_quotient_of_sinc_divisor_left_rest +
          sinc_quotient_of_sinc_divisor_right_rest,
      sinc_quotient = sinc_quotient_of_sine / sinc_quotient_of_sinc_divisor,
      sinc_quotient_product = KSL_MUL(sinc_quotient, sinc_quotient_of_sinc_divisor),
      sinc_quotient_product_error = ksl_product_error(sinc_quotient, sinc_quotient_of_sinc_divisor,
          sinc_quotient_product),
      sinc_quotient_rest = sinc_quotient_of_sine - sinc_quotient_product,
      sinc_quotient_exact = sinc_quotient_rest - sinc_quotient_product_error,
      sinc_quotient_numerator = sinc_quotient_exact + sinc_quotient_of_sine_lo,
      sinc_quotient_cross = KSL_MUL(sinc_quotient, sinc_quotient_of_sinc_divisor_lo),
      sinc_quotient_residual = sinc_quotient_numerator - sinc_quotient_cross,
      sinc_quotient_lo = sinc_quotient_residual / sinc_quotient_of_sinc_divisor;
  const double sinc_a = KSL_MUL(0.16666666666666666, half_angle_of_y),
      sinc_a_cross1 = KSL_MUL(9.25185853854297e-18, half_angle_of_y),
      sinc_a_cross2 = KSL_MUL(0.16666666666666666, half_angle_of_y_lo),
      sinc_a_cross = sinc_a_cross1 + sinc_a_cross2, sinc_b = 1.0 - sinc_a,
      sinc_b_right = 1.0 - sinc_b, sinc_b_left = sinc_b + sinc_b_right,
      sinc_b_left_rest = 1.0 - sinc_b_left,
      sinc_b_right_rest = ksl_product_rest(0.16666666666666666, half_angle_of_y, sinc_a,
          sinc_b_right),
      sinc_b_lo1 = sinc_b_left_rest - sinc_b_right_rest, sinc_b_lo = sinc_b_lo1 - sinc_a_cross,
      sinc = sine_of_half_angle < 1.4901161193847656e-08 ? sinc_b : sinc_quotient,
      sinc_lo = sine_of_half_angle < 1.4901161193847656e-08 ? sinc_b_lo : sinc_quotient_lo;
  const double series_phi_a = KSL_MUL(5.107725174524775e-32, half_angle_of_y),
      series_phi_a_cross1 = KSL_MUL(4.7410392187559056e-48, half_angle_of_y),
      series_phi_a_cross2 = KSL_MUL(5.107725174524775e-32, half_angle_of_y_lo),
      series_phi_a_cross = series_phi_a_cross1 + series_phi_a_cross2,
      series_phi_b = 4.116826490666969e-29 - series_phi_a,
      series_phi_b_right = 4.116826490666969e-29 - series_phi_b,
      series_phi_b_left = series_phi_b + series_phi_b_right,
      series_phi_b_left_rest = 4.116826490666969e-29 - series_phi_b_left,
      series_phi_b_right_rest = ksl_product_rest(5.107725174524775e-32, half_angle_of_y,
          series_phi_a, series_phi_b_right),
      series_phi_b_lo1 = series_phi_b_left_rest - series_phi_b_right_rest,
      series_phi_b_lo2 = series_phi_b_lo1 - series_phi_a_cross,
      series_phi_b_lo = series_phi_b_lo2 + -1.8714974010023092e-45,
      series_phi_c = KSL_MUL(half_angle_of_y, series_phi_b),
      series_phi_c_cross1 = KSL_MUL(half_angle_of_y_lo, series_phi_b),
      series_phi_c_cross2 = KSL_MUL(half_angle_of_y, series_phi_b_lo),
      series_phi_c_cross = series_phi_c_cross1 + series_phi_c_cross2,
      series_phi_d = series_phi_c - 2.86531123750421e-26,
      series_phi_d_right = series_phi_c - series_phi_d,
      series_phi_d_left = series_phi_d + series_phi_d_right,
      series_phi_d_left_rest = ksl_product_rest(half_angle_of_y, series_phi_b, series_phi_c,
          series_phi_d_left),
      series_phi_d_right_rest = 2.86531123750421e-26 - series_phi_d_right,
      series_phi_d_lo1 = series_phi_d_left_rest - series_phi_d_right_rest,
      series_phi_d_lo2 = series_phi_d_lo1 - 2.3296034284323186e-42,
      series_phi_d_lo = series_phi_d_lo2 + series_phi_c_cross,
      series_phi_e = KSL_MUL(half_angle_of_y, series_phi_d),
      series_phi_e_cross1 = KSL_MUL(half_angle_of_y_lo, series_phi_d),
      series_phi_e_cross2 = KSL_MUL(half_angle_of_y, series_phi_d_lo),
      series_phi_e_cross = series_phi_e_cross1 + series_phi_e_cross2,
      series_phi_f = series_phi_e + 1.701994875077501e-23,
      series_phi_f_right = series_phi_f - series_phi_e,
      series_phi_f_left = series_phi_f - series_phi_f_right,
      series_phi_f_left_rest = ksl_product_rest(half_angle_of_y, series_phi_d, series_phi_e,
          series_phi_f_left),
      series_phi_f_right_rest = 1.701994875077501e-23 - series_phi_f_right,
      series_phi_f_lo1 = series_phi_f_left_rest + series_phi_f_right_rest,
      series_phi_f_lo2 = series_phi_f_lo1 + 3.161967936521494e-40,
      series_phi_f_lo = series_phi_f_lo2 + series_phi_e_cross,
      series_phi_g = KSL_MUL(half_angle_of_y, series_phi_f),
      series_phi_g_cross1 = KSL_MUL(half_angle_of_y_lo, series_phi_f),
      series_phi_g_cross2 = KSL_MUL(half_angle_of_y, series_phi_f_lo),
      series_phi_g_cross = series_phi_g_cross1 + series_phi_g_cross2,
      series_phi_h = series_phi_g - 8.509974375387505e-21,
      series_phi_h_right = series_phi_g - series_phi_h,
      series_phi_h_left = series_phi_h + series_phi_h_right,
      series_phi_h_left_rest = ksl_product_rest(half_angle_of_y, series_phi_f, series_phi_g,
          series_phi_h_left),
      series_phi_h_right_rest = 8.509974375387505e-21 - series_phi_h_right,
      series_phi_h_lo1 = series_phi_h_left_rest - series_phi_h_right_rest,
      series_phi_h_lo2 = series_phi_h_lo1 - 3.2266760594119493e-37,
      series_phi_h_lo = series_phi_h_lo2 + series_phi_g_cross,
      series_phi_i = KSL_MUL(half_angle_of_y, series_phi_h),
      series_phi_i_cross1 = KSL_MUL(half_angle_of_y_lo, series_phi_h),
      series_phi_i_cross2 = KSL_MUL(half_angle_of_y, series_phi_h_lo),
      series_phi_i_cross = series_phi_i_cross1 + series_phi_i_cross2,
      series_phi_j = series_phi_i + 3.523129391410427e-18,
      series_phi_j_right = series_phi_j - series_phi_i,
      series_phi_j_left = series_phi_j - series_phi_j_right,
      series_phi_j_left_rest = ksl_product_rest(half_angle_of_y, series_phi_h, series_phi_i,
          series_phi_j_left),
      series_phi_j_right_rest = 3.523129391410427e-18 - series_phi_j_right,
      series_phi_j_lo1 = series_phi_j_left_rest + series_phi_j_right_rest,
      series_phi_j_lo2 = series_phi_j_lo1 + -1.2521244741738012e-34,
      series_phi_j_lo = series_phi_j_lo2 + series_phi_i_cross,
      series_phi_k = KSL_MUL(half_angle_of_y, series_phi_j),
      series_phi_k_cross1 = KSL_MUL(half_angle_of_y_lo, series_phi_j),
      series_phi_k_cross2 = KSL_MUL(half_angle_of_y, series_phi_j_lo),
      series_phi_k_cross = series_phi_k_cross1 + series_phi_k_cross2,
      series_phi_l = series_phi_k - 1.1837714755139035e-15,
      series_phi_l_right = series_phi_k - series_phi_l,
      series_phi_l_left = series_phi_l + series_phi_l_right,
      series_phi_l_left_rest = ksl_product_rest(half_angle_of_y, series_phi_j, series_phi_k,
          series_phi_l_left),
      series_phi_l_right_rest = 1.1837714755139035e-15 - series_phi_l_right,
      series_phi_l_lo1 = series_phi_l_left_rest - series_phi_l_right_rest,
      series_phi_l_lo2 = series_phi_l_lo1 - 7.23242424407352e-33,
      series_phi_l_lo = series_phi_l_lo2 + series_phi_k_cross,
      series_phi_m = KSL_MUL(half_angle_of_y, series_phi_l),
      series_phi_m_cross1 = KSL_MUL(half_angle_of_y_lo, series_phi_l),
      series_phi_m_cross2 = KSL_MUL(half_angle_of_y, series_phi_l_lo),
      series_phi_m_cross = series_phi_m_cross1 + series_phi_m_cross2,
      series_phi_n = series_phi_m + 3.148832124866983e-13,
      series_phi_n_right = series_phi_n - series_phi_m,
      series_phi_n_left = series_phi_n - series_phi_n_right,
      series_phi_n_left_rest = ksl_product_rest(half_angle_of_y, series_phi_l, series_phi_m,
          series_phi_n_left),
      series_phi_n_right_rest = 3.148832124866983e-13 - series_phi_n_right,
      series_phi_n_lo1 = series_phi_n_left_rest + series_phi_n_right_rest,
      series_phi_n_lo2 = series_phi_n_lo1 + 5.8681293750286156e-30,
      series_phi_n_lo = series_phi_n_lo2 + series_phi_m_cross,
      series_phi_o = KSL_MUL(half_angle_of_y, series_phi_n),
      series_phi_o_cross1 = KSL_MUL(half_angle_of_y_lo, series_phi_n),
      series_phi_o_cross2 = KSL_MUL(half_angle_of_y, series_phi_n_lo),
      series_phi_o_cross = series_phi_o_cross1 + series_phi_o_cross2,
      series_phi_p = series_phi_o - 6.423617534728645e-11,
      series_phi_p_right = series_phi_o - series_phi_p,
      series_phi_p_left = series_phi_p + series_phi_p_right,
      series_phi_p_left_rest = ksl_product_rest(half_angle_of_y, series_phi_n, series_phi_o,
          series_phi_p_left),
      series_phi_p_right_rest = 6.423617534728645e-11 - series_phi_p_right,
      series_phi_p_lo1 = series_phi_p_left_rest - series_phi_p_right_rest,
      series_phi_p_lo2 = series_phi_p_lo1 - 5.034117835500839e-27,
      series_phi_p_lo = series_phi_p_lo2 + series_phi_o_cross,
      series_phi_q = KSL_MUL(half_angle_of_y, series_phi_p),
      series_phi_q_cross1 = KSL_MUL(half_angle_of_y_lo, series_phi_p),
      series_phi_q_cross2 = KSL_MUL(half_angle_of_y, series_phi_p_lo),
      series_phi_q_cross = series_phi_q_cross1 + series_phi_q_cross2,
      series_phi_r = series_phi_q + 9.635426302092969e-09,
      series_phi_r_right = series_phi_r - series_phi_q,
      series_phi_r_left = series_phi_r - series_phi_r_right,
      series_phi_r_left_rest = ksl_product_rest(half_angle_of_y, series_phi_p, series_phi_q,
          series_phi_r_left),
      series_phi_r_right_rest = 9.635426302092969e-09 - series_phi_r_right,
      series_phi_r_lo1 = series_phi_r_left_rest + series_phi_r_right_rest,
      series_phi_r_lo2 = series_phi_r_lo1 + -1.7546051379703029e-25,
      series_phi_r_lo = series_phi_r_lo2 + series_phi_q_cross,
      series_phi_s = KSL_MUL(half_angle_of_y, series_phi_r),
      series_phi_s_cross1 = KSL_MUL(half_angle_of_y_lo, series_phi_r),
      series_phi_s_cross2 = KSL_MUL(half_angle_of_y, series_phi_r_lo),
      series_phi_s_cross = series_phi_s_cross1 + series_phi_s_cross2,
      series_phi_t = series_phi_s - 1.0020843354176687e-06,
      series_phi_t_right = series_phi_s - series_phi_t,
      series_phi_t_left = series_phi_t + series_phi_t_right,
      series_phi_t_left_rest = ksl_product_rest(half_angle_of_y, series_phi_r, series_phi_s,
          series_phi_t_left),
      series_phi_t_right_rest = 1.0020843354176687e-06 - series_phi_t_right,
      series_phi_t_lo1 = series_phi_t_left_rest - series_phi_t_right_rest,
      series_phi_t_lo2 = series_phi_t_lo1 - 4.7926555569351065e-23,
      series_phi_t_lo = series_phi_t_lo2 + series_phi_s_cross,
      series_phi_u = KSL_MUL(half_angle_of_y, series_phi_t),
      series_phi_u_cross1 = KSL_MUL(half_angle_of_y_lo, series_phi_t),
      series_phi_u_cross2 = KSL_MUL(half_angle_of_y, series_phi_t_lo),
      series_phi_u_cross = series_phi_u_cross1 + series_phi_u_cross2,
      series_phi_v = series_phi_u + 6.613756613756614e-05,
      series_phi_v_right = series_phi_v - series_phi_u,
      series_phi_v_left = series_phi_v - series_phi_v_right,
      series_phi_v_left_rest = ksl_product_rest(half_angle_of_y, series_phi_t, series_phi_u,
          series_phi_v_left),
      series_phi_v_right_rest = 6.613756613756614e-05 - series_phi_v_right,
      series_phi_v_lo1 = series_phi_v_left_rest + series_phi_v_right_rest,
      series_phi_v_lo2 = series_phi_v_lo1 + -4.460143857711533e-21,
      series_phi_v_lo = series_phi_v_lo2 + series_phi_u_cross,
      series_phi_w = KSL_MUL(half_angle_of_y, series_phi_v),
      series_phi_w_cross1 = KSL_MUL(half_angle_of_y_lo, series_phi_v),
      series_phi_w_cross2 = KSL_MUL(half_angle_of_y, series_phi_v_lo),
      series_phi_w_cross = series_phi_w_cross1 + series_phi_w_cross2,
      series_phi_x = series_phi_w - 0.002380952380952381,
      series_phi_x_right = series_phi_w - series_phi_x,
      series_phi_x_left = series_phi_x + series_phi_x_right,
      series_phi_x_left_rest = ksl_product_rest(half_angle_of_y, series_phi_v, series_phi_w,
          series_phi_x_left),
      series_phi_x_right_rest = 0.002380952380952381 - series_phi_x_right,
      series_phi_x_lo1 = series_phi_x_left_rest - series_phi_x_right_rest,
      series_phi_x_lo2 = series_phi_x_lo1 - -2.147752875018904e-19,
      series_phi_x_lo = series_phi_x_lo2 + series_phi_w_cross,
      series_phi_y = KSL_MUL(half_angle_of_y, series_phi_x),
      series_phi_y_cross1 = KSL_MUL(half_angle_of_y_lo, series_phi_x),
      series_phi_y_cross2 = KSL_MUL(half_angle_of_y, series_phi_x_lo),
      series_phi_y_cross = series_phi_y_cross1 + series_phi_y_cross2,
      series_phi = series_phi_y + 0.03333333333333333, series_phi_right = series_phi - series_phi_y,
      series_phi_left = series_phi - series_phi_right,
      series_phi_left_rest = ksl_product_rest(half_angle_of_y, series_phi_x, series_phi_y,
          series_phi_left),
      series_phi_right_rest = 0.03333333333333333 - series_phi_right,
      series_phi_lo1 = series_phi_left_rest + series_phi_right_rest,
      series_phi_lo2 = series_phi_lo1 + 4.625929269271486e-19,
      series_phi_lo = series_phi_lo2 + series_phi_y_cross;
  const double f_more_a = KSL_MUL(2.0, half_angle_of_y),
      f_more_a_cross2 = KSL_MUL(2.0, half_angle_of_y_lo), f_more = KSL_MUL(f_more_a, series_phi),
      f_more_cross1 = KSL_MUL(f_more_a_cross2, series_phi),
      f_more_cross2 = KSL_MUL(f_more_a, series_phi_lo),
      f_more_cross = f_more_cross1 + f_more_cross2;
  const double near_f_a = KSL_MUL(0.3333333333333333, sinc),
      near_f_a_cross1 = KSL_MUL(1.850371707708594e-17, sinc),
      near_f_a_cross2 = KSL_MUL(0.3333333333333333, sinc_lo),
      near_f_a_cross = near_f_a_cross1 + near_f_a_cross2,
      f_more_error = ksl_product_error(f_more_a, series_phi, f_more),
      f_more_lo = f_more_error + f_more_cross, near_f_b = KSL_MUL(0.3333333333333333, f_more),
      near_f_b_cross1 = KSL_MUL(1.850371707708594e-17, f_more),
      near_f_b_cross2 = KSL_MUL(0.3333333333333333, f_more_lo),
      near_f_b_cross = near_f_b_cross1 + near_f_b_cross2, near_f = near_f_a + near_f_b,
      near_f_right = near_f - near_f_a, near_f_left = near_f - near_f_right,
      near_f_left_rest = ksl_product_rest(0.3333333333333333, sinc, near_f_a, near_f_left),
      near_f_right_rest = ksl_product_rest(0.3333333333333333, f_more, near_f_b, near_f_right),
      near_f_cross = near_f_a_cross + near_f_b_cross,
      near_f_lo1 = near_f_left_rest + near_f_right_rest, near_f_lo = near_f_lo1 + near_f_cross;
  const double f_rest = sinc - c, f_rest_right = sinc - f_rest, f_rest_left = f_rest + f_rest_right,
      f_rest_left_rest = sinc - f_rest_left, f_rest_right_rest = c - f_rest_right,
      f_rest_lo1 = f_rest_left_rest - f_rest_right_rest, f_rest_lo2 = f_rest_lo1 - c_lo,
      f_rest_lo = f_rest_lo2 + sinc_lo;
  const double x = KSL_MUL(4.0, half_angle_of_y), x_cross2 = KSL_MUL(4.0, half_angle_of_y_lo);
  const double far_y_a_of_x = x + x_cross2, far_y = far_y_a_of_x < 4.0 ? 1.0 : half_angle_of_y,
      far_y_lo = far_y_a_of_x < 4.0 ? 0.0 : half_angle_of_y_lo;
  const double closed_f_of_f_rest = f_rest + f_rest_lo,
      closed_f_of_f_rest_right = closed_f_of_f_rest - f_rest,
      closed_f_of_f_rest_left = closed_f_of_f_rest - closed_f_of_f_rest_right,
      closed_f_of_f_rest_left_rest = f_rest - closed_f_of_f_rest_left,
      closed_f_of_f_rest_right_rest = f_rest_lo - closed_f_of_f_rest_right,
      closed_f_of_f_rest_lo = closed_f_of_f_rest_left_rest + closed_f_of_f_rest_right_rest,
      closed_f_of_far_y = far_y + far_y_lo, closed_f_of_far_y_right = closed_f_of_far_y - far_y,
      closed_f_of_far_y_left = closed_f_of_far_y - closed_f_of_far_y_right,
      closed_f_of_far_y_left_rest = far_y - closed_f_of_far_y_left,
      closed_f_of_far_y_right_rest = far_y_lo - closed_f_of_far_y_right,
      closed_f_of_far_y_lo = closed_f_of_far_y_left_rest + closed_f_of_far_y_right_rest,
      closed_f = closed_f_of_f_rest / closed_f_of_far_y,
      closed_f_product = KSL_MUL(closed_f, closed_f_of_far_y),
      closed_f_product_error = ksl_product_error(closed_f, closed_f_of_far_y, closed_f_product),
      closed_f_rest = closed_f_of_f_rest - closed_f_product,
      closed_f_exact = closed_f_rest - closed_f_product_error,
      closed_f_numerator = closed_f_exact + closed_f_of_f_rest_lo,
      closed_f_cross = KSL_MUL(closed_f, closed_f_of_far_y_lo),
      closed_f_residual = closed_f_numerator - closed_f_cross,
      closed_f_lo = closed_f_residual / closed_f_of_far_y;
  const double f = far_y_a_of_x < 4.0 ? near_f : closed_f,
      f_lo = far_y_a_of_x < 4.0 ? near_f_lo : closed_f_lo;
  const double four_k = KSL_MUL(4.0, sinc), four_k_cross2 = KSL_MUL(4.0, sinc_lo);
  const double b_of_f = f + f_lo, b_of_f_right = b_of_f - f, b_of_f_left = b_of_f - b_of_f_right,
      b_of_f_left_rest = f - b_of_f_left, b_of_f_right_rest = f_lo - b_of_f_right,
      b_of_f_lo = b_of_f_left_rest + b_of_f_right_rest, b_of_four_k = four_k + four_k_cross2,
      b_of_four_k_right = b_of_four_k - four_k, b_of_four_k_left = b_of_four_k - b_of_four_k_right,
      b_of_four_k_left_rest = four_k - b_of_four_k_left,
      b_of_four_k_right_rest = four_k_cross2 - b_of_four_k_right,
      b_of_four_k_lo = b_of_four_k_left_rest + b_of_four_k_right_rest, b = b_of_f / b_of_four_k,
      b_product = KSL_MUL(b, b_of_four_k),
      b_product_error = ksl_product_error(b, b_of_four_k, b_product), b_rest = b_of_f - b_product,
      b_exact = b_rest - b_product_error, b_numerator = b_exact + b_of_f_lo,
      b_cross = KSL_MUL(b, b_of_four_k_lo), b_residual = b_numerator - b_cross,
      b_lo = b_residual / b_of_four_k;
  const double b_across_of_c = c + c_lo, b_across_of_c_right = b_across_of_c - c,
      b_across_of_c_left = b_across_of_c - b_across_of_c_right,
      b_across_of_c_left_rest = c - b_across_of_c_left,
      b_across_of_c_right_rest = c_lo - b_across_of_c_right,
      b_across_of_c_lo = b_across_of_c_left_rest + b_across_of_c_right_rest,
      b_across_of_sinc = sinc + sinc_lo, b_across_of_sinc_right = b_across_of_sinc - sinc,
      b_across_of_sinc_left = b_across_of_sinc - b_across_of_sinc_right,
      b_across_of_sinc_left_rest = sinc - b_across_of_sinc_left,
      b_across_of_sinc_right_rest = sinc_lo - b_across_of_sinc_right,
      b_across_of_sinc_lo = b_across_of_sinc_left_rest + b_across_of_sinc_right_rest,
      b_across = b_across_of_c / b_across_of_sinc,
      b_across_product = KSL_MUL(b_across, b_across_of_sinc),
      b_across_product_error = ksl_product_error(b_across, b_across_of_sinc, b_across_product),
      b_across_rest = b_across_of_c - b_across_product,
      b_across_exact = b_across_rest - b_across_product_error,
      b_across_numerator = b_across_exact + b_across_of_c_lo,
      b_across_cross = KSL_MUL(b_across, b_across_of_sinc_lo),
      b_across_residual = b_across_numerator - b_across_cross,
      b_across_lo = b_across_residual / b_across_of_sinc;
  const double beta_v_0 = KSL_MUL(s->m3, b), beta_v_0_cross2 = KSL_MUL(s->m3, b_lo);
  const double beta_v_1 = KSL_MUL(s->m4, b), beta_v_1_cross2 = KSL_MUL(s->m4, b_lo);
  const double beta_v_2 = KSL_MUL(s->m5, b), beta_v_2_cross2 = KSL_MUL(s->m5, b_lo);
  const double beta_v_0_error = ksl_product_error(s->m3, b, beta_v_0),
      beta_v_0_lo = beta_v_0_error + beta_v_0_cross2, m_0 = KSL_MUL(s->m3, beta_v_0),
      m_0_cross2 = KSL_MUL(s->m3, beta_v_0_lo);
  const double beta_v_1_error = ksl_product_error(s->m4, b, beta_v_1),
      beta_v_1_lo = beta_v_1_error + beta_v_1_cross2, m_1 = KSL_MUL(s->m4, beta_v_1),
      m_1_cross2 = KSL_MUL(s->m4, beta_v_1_lo);
  const double beta_v_2_error = ksl_product_error(s->m5, b, beta_v_2),
      beta_v_2_lo = beta_v_2_error + beta_v_2_cross2, m_2 = KSL_MUL(s->m5, beta_v_2),
      m_2_cross2 = KSL_MUL(s->m5, beta_v_2_lo);
  const double m_3 = KSL_MUL(s->m4, beta_v_0), m_3_cross2 = KSL_MUL(s->m4, beta_v_0_lo);
  const double m_4 = KSL_MUL(s->m5, beta_v_0), m_4_cross2 = KSL_MUL(s->m5, beta_v_0_lo);
  const double m_5 = KSL_MUL(s->m5, beta_v_1), m_5_cross2 = KSL_MUL(s->m5, beta_v_1_lo);
  const double others_0 = m_1 + m_2, others_0_right = others_0 - m_1,
      others_0_left = others_0 - others_0_right,
      others_0_left_rest = ksl_product_rest(s->m4, beta_v_1, m_1, others_0_left),
      others_0_right_rest = ksl_product_rest(s->m5, beta_v_2, m_2, others_0_right),
      others_0_cross = m_1_cross2 + m_2_cross2,
      others_0_lo1 = others_0_left_rest + others_0_right_rest,
      others_0_lo = others_0_lo1 + others_0_cross;
  const double others_1 = m_0 + m_2, others_1_right = others_1 - m_0,
      others_1_left = others_1 - others_1_right,
      others_1_left_rest = ksl_product_rest(s->m3, beta_v_0, m_0, others_1_left),
      others_1_right_rest = ksl_product_rest(s->m5, beta_v_2, m_2, others_1_right),
      others_1_cross = m_0_cross2 + m_2_cross2,
      others_1_lo1 = others_1_left_rest + others_1_right_rest,
      others_1_lo = others_1_lo1 + others_1_cross;
  const double others_2 = m_0 + m_1, others_2_right = others_2 - m_0,
      others_2_left = others_2 - others_2_right,
      others_2_left_rest = ksl_product_rest(s->m3, beta_v_0, m_0, others_2_left),
      others_2_right_rest = ksl_product_rest(s->m4, beta_v_1, m_1, others_2_right),
      others_2_cross = m_0_cross2 + m_1_cross2,
      others_2_lo1 = others_2_left_rest + others_2_right_rest,
      others_2_lo = others_2_lo1 + others_2_cross;
  const double diagonal0a = 1.0 - others_0, diagonal0a_right = 1.0 - diagonal0a,
      diagonal0a_left = diagonal0a + diagonal0a_right, diagonal0a_left_rest = 1.0 - diagonal0a_left,
      diagonal0a_right_rest = others_0 - diagonal0a_right,
      diagonal0a_lo1 = diagonal0a_left_rest - diagonal0a_right_rest,
      diagonal0a_lo = diagonal0a_lo1 - others_0_lo, diagonal0b = b_across + m_0,
      diagonal0b_right = diagonal0b - b_across, diagonal0b_left = diagonal0b - diagonal0b_right,
      diagonal0b_left_rest = b_across - diagonal0b_left,
      diagonal0b_right_rest = ksl_product_rest(s->m3, beta_v_0, m_0, diagonal0b_right),
      diagonal0b_lo1 = diagonal0b_left_rest + diagonal0b_right_rest,
      diagonal0b_lo2 = diagonal0b_lo1 + m_0_cross2, diagonal0b_lo = diagonal0b_lo2 + b_across_lo,
      m_0_error = ksl_product_error(s->m3, beta_v_0, m_0), m_0_lo = m_0_error + m_0_cross2,
      diagonal0c_of_m_0 = m_0 + m_0_lo, diagonal0c_of_others_0 = others_0 + others_0_lo,
      diagonal0 = diagonal0c_of_m_0 < diagonal0c_of_others_0 ? diagonal0b : diagonal0a,
      diagonal0_lo = diagonal0c_of_m_0 < diagonal0c_of_others_0 ? diagonal0b_lo : diagonal0a_lo;
  const double diagonal1a = 1.0 - others_1, diagonal1a_right = 1.0 - diagonal1a,
      diagonal1a_left = diagonal1a + diagonal1a_right, diagonal1a_left_rest = 1.0 - diagonal1a_left,
      diagonal1a_right_rest = others_1 - diagonal1a_right,
      diagonal1a_lo1 = diagonal1a_left_rest - diagonal1a_right_rest,
      diagonal1a_lo = diagonal1a_lo1 - others_1_lo, diagonal1b = b_across + m_1,
      diagonal1b_right = diagonal1b - b_across, diagonal1b_left = diagonal1b - diagonal1b_right,
      diagonal1b_left_rest = b_across - diagonal1b_left,
      diagonal1b_right_rest = ksl_product_rest(s->m4, beta_v_1, m_1, diagonal1b_right),
      diagonal1b_lo1 = diagonal1b_left_rest + diagonal1b_right_rest,
      diagonal1b_lo2 = diagonal1b_lo1 + m_1_cross2, diagonal1b_lo = diagonal1b_lo2 + b_across_lo,
      m_1_error = ksl_product_error(s->m4, beta_v_1, m_1), m_1_lo = m_1_error + m_1_cross2,
      diagonal1c_of_m_1 = m_1 + m_1_lo, diagonal1c_of_others_1 = others_1 + others_1_lo,
      diagonal1 = diagonal1c_of_m_1 < diagonal1c_of_others_1 ? diagonal1b : diagonal1a,
      diagonal1_lo = diagonal1c_of_m_1 < diagonal1c_of_others_1 ? diagonal1b_lo : diagonal1a_lo;
  const double diagonal2a = 1.0 - others_2, diagonal2a_right = 1.0 - diagonal2a,
      diagonal2a_left = diagonal2a + diagonal2a_right, diagonal2a_left_rest = 1.0 - diagonal2a_left,
      diagonal2a_right_rest = others_2 - diagonal2a_right,
      diagonal2a_lo1 = diagonal2a_left_rest - diagonal2a_right_rest,
      diagonal2a_lo = diagonal2a_lo1 - others_2_lo, diagonal2b = b_across + m_2,
      diagonal2b_right = diagonal2b - b_across, diagonal2b_left = diagonal2b - diagonal2b_right,
      diagonal2b_left_rest = b_across - diagonal2b_left,
      diagonal2b_right_rest = ksl_product_rest(s->m5, beta_v_2, m_2, diagonal2b_right),
      diagonal2b_lo1 = diagonal2b_left_rest + diagonal2b_right_rest,
      diagonal2b_lo2 = diagonal2b_lo1 + m_2_cross2, diagonal2b_lo = diagonal2b_lo2 + b_across_lo,
      m_2_error = ksl_product_error(s->m5, beta_v_2, m_2), m_2_lo = m_2_error + m_2_cross2,
      diagonal2c_of_m_2 = m_2 + m_2_lo, diagonal2c_of_others_2 = others_2 + others_2_lo,
      diagonal2 = diagonal2c_of_m_2 < diagonal2c_of_others_2 ? diagonal2b : diagonal2a,
      diagonal2_lo = diagonal2c_of_m_2 < diagonal2c_of_others_2 ? diagonal2b_lo : diagonal2a_lo;
  const double J_1 = m_3 - halved_2, J_1_right = m_3 - J_1, J_1_left = J_1 + J_1_right,
      J_1_left_rest = ksl_product_rest(s->m4, beta_v_0, m_3, J_1_left),
      J_1_right_rest = halved_2 - J_1_right, J_1_lo1 = J_1_left_rest - J_1_right_rest,
      J_1_lo = J_1_lo1 + m_3_cross2;
  const double J_2 = halved_1 + m_4, J_2_right = J_2 - halved_1, J_2_left = J_2 - J_2_right,
      J_2_left_rest = halved_1 - J_2_left,
      J_2_right_rest = ksl_product_rest(s->m5, beta_v_0, m_4, J_2_right),
      J_2_lo1 = J_2_left_rest + J_2_right_rest, J_2_lo = J_2_lo1 + m_4_cross2;
  const double J_3 = halved_2 + m_3, J_3_right = J_3 - halved_2, J_3_left = J_3 - J_3_right,
      J_3_left_rest = halved_2 - J_3_left,
      J_3_right_rest = ksl_product_rest(s->m4, beta_v_0, m_3, J_3_right),
      J_3_lo1 = J_3_left_rest + J_3_right_rest, J_3_lo = J_3_lo1 + m_3_cross2;
  const double J_5 = m_5 - halved_0, J_5_right = m_5 - J_5, J_5_left = J_5 + J_5_right,
      J_5_left_rest = ksl_product_rest(s->m5, beta_v_1, m_5, J_5_left),
      J_5_right_rest = halved_0 - J_5_right, J_5_lo1 = J_5_left_rest - J_5_right_rest,
      J_5_lo = J_5_lo1 + m_5_cross2;
  const double J_6 = m_4 - halved_1, J_6_right = m_4 - J_6, J_6_left = J_6 + J_6_right,
      J_6_left_rest = ksl_product_rest(s->m5, beta_v_0, m_4, J_6_left),
      J_6_right_rest = halved_1 - J_6_right, J_6_lo1 = J_6_left_rest - J_6_right_rest,
      J_6_lo = J_6_lo1 + m_4_cross2;
  const double J_7 = halved_0 + m_5, J_7_right = J_7 - halved_0, J_7_left = J_7 - J_7_right,
      J_7_left_rest = halved_0 - J_7_left,
      J_7_right_rest = ksl_product_rest(s->m5, beta_v_1, m_5, J_7_right),
      J_7_lo1 = J_7_left_rest + J_7_right_rest, J_7_lo = J_7_lo1 + m_5_cross2;
  const double phi_rest_a = KSL_MUL(3.0, b_of_f), phi_rest_a_cross2 = KSL_MUL(3.0, b_of_f_lo),
      phi_rest = phi_rest_a - b_across_of_sinc, phi_rest_right = phi_rest_a - phi_rest,
      phi_rest_left = phi_rest + phi_rest_right,
      phi_rest_left_rest = ksl_product_rest(3.0, b_of_f, phi_rest_a, phi_rest_left),
      phi_rest_right_rest = b_across_of_sinc - phi_rest_right,
      phi_rest_lo1 = phi_rest_left_rest - phi_rest_right_rest,
      phi_rest_lo2 = phi_rest_lo1 - b_across_of_sinc_lo,
      phi_rest_lo = phi_rest_lo2 + phi_rest_a_cross2;
  const double twice_y = KSL_MUL(2.0, closed_f_of_far_y),
      twice_y_cross2 = KSL_MUL(2.0, closed_f_of_far_y_lo);
  const double closed_phi_of_phi_rest = phi_rest + phi_rest_lo,
      closed_phi_of_phi_rest_right = closed_phi_of_phi_rest - phi_rest,
      closed_phi_of_phi_rest_left = closed_phi_of_phi_rest - closed_phi_of_phi_rest_right,
      closed_phi_of_phi_rest_left_rest = phi_rest - closed_phi_of_phi_rest_left,
      closed_phi_of_phi_rest_right_rest = phi_rest_lo - closed_phi_of_phi_rest_right,
      closed_phi_of_phi_rest_lo = closed_phi_of_phi_rest_left_rest +
          closed_phi_of_phi_rest_right_rest,
      closed_phi_of_twice_y = twice_y + twice_y_cross2,
      closed_phi_of_twice_y_right = closed_phi_of_twice_y - twice_y,
      closed_phi_of_twice_y_left = closed_phi_of_twice_y - closed_phi_of_twice_y_right,
      closed_phi_of_twice_y_left_rest = twice_y - closed_phi_of_twice_y_left,
      closed_phi_of_twice_y_right_rest = twice_y_cross2 - closed_phi_of_twice_y_right,
      closed_phi_of_twice_y_lo = closed_phi_of_twice_y_left_rest + closed_phi_of_twice_y_right_rest,
      closed_phi = closed_phi_of_phi_rest / closed_phi_of_twice_y,
      closed_phi_product = KSL_MUL(closed_phi, closed_phi_of_twice_y),
      closed_phi_product_error = ksl_product_error(closed_phi, closed_phi_of_twice_y,
          closed_phi_product),
      closed_phi_rest = closed_phi_of_phi_rest - closed_phi_product,
      closed_phi_exact = closed_phi_rest - closed_phi_product_error,
      closed_phi_numerator = closed_phi_exact + closed_phi_of_phi_rest_lo,
      closed_phi_cross = KSL_MUL(closed_phi, closed_phi_of_twice_y_lo),
      closed_phi_residual = closed_phi_numerator - closed_phi_cross,
      closed_phi_lo = closed_phi_residual / closed_phi_of_twice_y;
  const double phi = far_y_a_of_x < 4.0 ? series_phi : closed_phi,
      phi_lo = far_y_a_of_x < 4.0 ? series_phi_lo : closed_phi_lo;
  const double b_rate_above_a = KSL_MUL(b_of_f, b_of_f),
      b_rate_above_a_cross1 = KSL_MUL(b_of_f_lo, b_of_f),
      b_rate_above_a_cross2 = KSL_MUL(b_of_f, b_of_f_lo),
      b_rate_above_a_cross = b_rate_above_a_cross1 + b_rate_above_a_cross2,
      b_rate_above_a_error = ksl_product_error(b_of_f, b_of_f, b_rate_above_a),
      b_rate_above_a_lo = b_rate_above_a_error + b_rate_above_a_cross,
      b_rate_above_b = KSL_MUL(0.5, b_rate_above_a),
      b_rate_above_b_cross2 = KSL_MUL(0.5, b_rate_above_a_lo),
      b_rate_above_c = KSL_MUL(b_across_of_sinc, phi),
      b_rate_above_c_cross1 = KSL_MUL(b_across_of_sinc_lo, phi),
      b_rate_above_c_cross2 = KSL_MUL(b_across_of_sinc, phi_lo),
      b_rate_above_c_cross = b_rate_above_c_cross1 + b_rate_above_c_cross2,
      b_rate_above = b_rate_above_b - b_rate_above_c,
      b_rate_above_right = b_rate_above_b - b_rate_above,
      b_rate_above_left = b_rate_above + b_rate_above_right,
      b_rate_above_left_rest = b_rate_above_b - b_rate_above_left,
      b_rate_above_right_rest = ksl_product_rest(b_across_of_sinc, phi, b_rate_above_c,
          b_rate_above_right),
      b_rate_above_lo1 = b_rate_above_left_rest - b_rate_above_right_rest,
      b_rate_above_lo2 = b_rate_above_lo1 - b_rate_above_c_cross,
      b_rate_above_lo = b_rate_above_lo2 + b_rate_above_b_cross2;
  const double b_rate_below_a = KSL_MUL(b_across_of_sinc, b_across_of_sinc),
      b_rate_below_a_cross1 = KSL_MUL(b_across_of_sinc_lo, b_across_of_sinc),
      b_rate_below_a_cross2 = KSL_MUL(b_across_of_sinc, b_across_of_sinc_lo),
      b_rate_below_a_cross = b_rate_below_a_cross1 + b_rate_below_a_cross2,
      b_rate_below_a_error = ksl_product_error(b_across_of_sinc, b_across_of_sinc, b_rate_below_a),
      b_rate_below_a_lo = b_rate_below_a_error + b_rate_below_a_cross,
      b_rate_below = KSL_MUL(8.0, b_rate_below_a),
      b_rate_below_cross2 = KSL_MUL(8.0, b_rate_below_a_lo);
  const double b_rate_of_b_rate_above = b_rate_above + b_rate_above_lo,
      b_rate_of_b_rate_above_right = b_rate_of_b_rate_above - b_rate_above,
      b_rate_of_b_rate_above_left = b_rate_of_b_rate_above - b_rate_of_b_rate_above_right,
      b_rate_of_b_rate_above_left_rest = b_rate_above - b_rate_of_b_rate_above_left,
      b_rate_of_b_rate_above_right_rest = b_rate_above_lo - b_rate_of_b_rate_above_right,
      b_rate_of_b_rate_above_lo = b_rate_of_b_rate_above_left_rest +
          b_rate_of_b_rate_above_right_rest,
      b_rate_of_b_rate_below = b_rate_below + b_rate_below_cross2,
      b_rate_of_b_rate_below_right = b_rate_of_b_rate_below - b_rate_below,
      b_rate_of_b_rate_below_left = b_rate_of_b_rate_below - b_rate_of_b_rate_below_right,
      b_rate_of_b_rate_below_left_rest = b_rate_below - b_rate_of_b_rate_below_left,
      b_rate_of_b_rate_below_right_rest = b_rate_below_cross2 - b_rate_of_b_rate_below_right,
      b_rate_of_b_rate_below_lo = b_rate_of_b_rate_below_left_rest +
          b_rate_of_b_rate_below_right_rest,
      b_rate = b_rate_of_b_rate_above / b_rate_of_b_rate_below,
      b_rate_product = KSL_MUL(b_rate, b_rate_of_b_rate_below),
      b_rate_product_error = ksl_product_error(b_rate, b_rate_of_b_rate_below, b_rate_product),
      b_rate_rest = b_rate_of_b_rate_above - b_rate_product,
      b_rate_exact = b_rate_rest - b_rate_product_error,
      b_rate_numerator = b_rate_exact + b_rate_of_b_rate_above_lo,
      b_rate_cross = KSL_MUL(b_rate, b_rate_of_b_rate_below_lo),
      b_rate_residual = b_rate_numerator - b_rate_cross,
      b_rate_lo = b_rate_residual / b_rate_of_b_rate_below;
  const double rate_vw_a = KSL_MUL(s->m0, s->m3), rate_vw_b = KSL_MUL(s->m1, s->m4),
      rate_vw_c = rate_vw_a + rate_vw_b, rate_vw_c_right = rate_vw_c - rate_vw_a,
      rate_vw_c_left = rate_vw_c - rate_vw_c_right,
      rate_vw_c_left_rest = ksl_product_rest(s->m0, s->m3, rate_vw_a, rate_vw_c_left),
      rate_vw_c_right_rest = ksl_product_rest(s->m1, s->m4, rate_vw_b, rate_vw_c_right),
      rate_vw_c_lo = rate_vw_c_left_rest + rate_vw_c_right_rest, rate_vw_d = KSL_MUL(s->m2, s->m5),
      rate_vw = rate_vw_c + rate_vw_d, rate_vw_right = rate_vw - rate_vw_c,
      rate_vw_left = rate_vw - rate_vw_right, rate_vw_left_rest = rate_vw_c - rate_vw_left,
      rate_vw_right_rest = ksl_product_rest(s->m2, s->m5, rate_vw_d, rate_vw_right),
      rate_vw_lo1 = rate_vw_left_rest + rate_vw_right_rest, rate_vw_lo = rate_vw_lo1 + rate_vw_c_lo;
  const double rate_bend_a = KSL_MUL(b_rate, rate_vw),
      rate_bend_a_cross1 = KSL_MUL(b_rate_lo, rate_vw),
      rate_bend_a_cross2 = KSL_MUL(b_rate, rate_vw_lo),
      rate_bend_a_cross = rate_bend_a_cross1 + rate_bend_a_cross2, rate_bend = -rate_bend_a,
      rate_bend_cross = -rate_bend_a_cross, rate_bend_factor = -b_rate;
  const double rate_q_0 = KSL_MUL(0.5, s->m0);
  const double rate_q_1 = KSL_MUL(0.5, s->m1);
  const double rate_q_2 = KSL_MUL(0.5, s->m2);
  const double rate_beta_v_0a = KSL_MUL(s->m0, b), rate_beta_v_0a_cross2 = KSL_MUL(s->m0, b_lo),
      rate_beta_v_0 = -rate_beta_v_0a, rate_beta_v_0_cross = -rate_beta_v_0a_cross2,
      rate_beta_v_0_factor = -s->m0;
  const double rate_beta_v_1a = KSL_MUL(s->m1, b), rate_beta_v_1a_cross2 = KSL_MUL(s->m1, b_lo),
      rate_beta_v_1 = -rate_beta_v_1a, rate_beta_v_1_cross = -rate_beta_v_1a_cross2,
      rate_beta_v_1_factor = -s->m1;
  const double rate_beta_v_2a = KSL_MUL(s->m2, b), rate_beta_v_2a_cross2 = KSL_MUL(s->m2, b_lo),
      rate_beta_v_2 = -rate_beta_v_2a, rate_beta_v_2_cross = -rate_beta_v_2a_cross2,
      rate_beta_v_2_factor = -s->m2;
  const double rate_bend_error = ksl_product_error(rate_bend_factor, rate_vw, rate_bend),
      rate_bend_lo = rate_bend_error + rate_bend_cross, rate_bend_w_0a = KSL_MUL(s->m3, rate_bend),
      rate_bend_w_0a_cross2 = KSL_MUL(s->m3, rate_bend_lo), rate_bend_w_0 = -rate_bend_w_0a,
      rate_bend_w_0_cross = -rate_bend_w_0a_cross2, rate_bend_w_0_factor = -s->m3;
  const double rate_bend_w_1a = KSL_MUL(s->m4, rate_bend),
      rate_bend_w_1a_cross2 = KSL_MUL(s->m4, rate_bend_lo), rate_bend_w_1 = -rate_bend_w_1a,
      rate_bend_w_1_cross = -rate_bend_w_1a_cross2, rate_bend_w_1_factor = -s->m4;
  const double rate_bend_w_2a = KSL_MUL(s->m5, rate_bend),
      rate_bend_w_2a_cross2 = KSL_MUL(s->m5, rate_bend_lo), rate_bend_w_2 = -rate_bend_w_2a,
      rate_bend_w_2_cross = -rate_bend_w_2a_cross2, rate_bend_w_2_factor = -s->m5;
  const double rate_bend_w_0_error = ksl_product_error(rate_bend_w_0_factor, rate_bend,
      rate_bend_w_0),
      rate_bend_w_0_lo = rate_bend_w_0_error + rate_bend_w_0_cross,
      rate_symmetric_0a = KSL_MUL(s->m4, rate_bend_w_0),
      rate_symmetric_0a_cross2 = KSL_MUL(s->m4, rate_bend_w_0_lo),
      rate_beta_v_1_error = ksl_product_error(rate_beta_v_1_factor, b, rate_beta_v_1),
      rate_beta_v_1_lo = rate_beta_v_1_error + rate_beta_v_1_cross,
      rate_symmetric_0b = KSL_MUL(s->m3, rate_beta_v_1),
      rate_symmetric_0b_cross2 = KSL_MUL(s->m3, rate_beta_v_1_lo),
      rate_beta_v_0_error = ksl_product_error(rate_beta_v_0_factor, b, rate_beta_v_0),
      rate_beta_v_0_lo = rate_beta_v_0_error + rate_beta_v_0_cross,
      rate_symmetric_0c = KSL_MUL(s->m4, rate_beta_v_0),
      rate_symmetric_0c_cross2 = KSL_MUL(s->m4, rate_beta_v_0_lo),
      rate_symmetric_0d = rate_symmetric_0b + rate_symmetric_0c,
      rate_symmetric_0d_right = rate_symmetric_0d - rate_symmetric_0b,
      rate_symmetric_0d_left = rate_symmetric_0d - rate_symmetric_0d_right,
      rate_symmetric_0d_left_rest = ksl_product_rest(s->m3, rate_beta_v_1, rate_symmetric_0b,
          rate_symmetric_0d_left),
      rate_symmetric_0d_right_rest = ksl_product_rest(s->m4, rate_beta_v_0, rate_symmetric_0c,
          rate_symmetric_0d_right),
      rate_symmetric_0d_cross = rate_symmetric_0b_cross2 + rate_symmetric_0c_cross2,
      rate_symmetric_0d_lo1 = rate_symmetric_0d_left_rest + rate_symmetric_0d_right_rest,
      rate_symmetric_0d_lo = rate_symmetric_0d_lo1 + rate_symmetric_0d_cross,
      rate_symmetric_0 = rate_symmetric_0a - rate_symmetric_0d,
      rate_symmetric_0_right = rate_symmetric_0a - rate_symmetric_0,
      rate_symmetric_0_left = rate_symmetric_0 + rate_symmetric_0_right,
      rate_symmetric_0_left_rest = ksl_product_rest(s->m4, rate_bend_w_0, rate_symmetric_0a,
          rate_symmetric_0_left),
      rate_symmetric_0_right_rest = rate_symmetric_0d - rate_symmetric_0_right,
      rate_symmetric_0_lo1 = rate_symmetric_0_left_rest - rate_symmetric_0_right_rest,
      rate_symmetric_0_lo2 = rate_symmetric_0_lo1 - rate_symmetric_0d_lo,
      rate_symmetric_0_lo = rate_symmetric_0_lo2 + rate_symmetric_0a_cross2;
  const double rate_symmetric_1a = KSL_MUL(s->m5, rate_bend_w_0),
      rate_symmetric_1a_cross2 = KSL_MUL(s->m5, rate_bend_w_0_lo),
      rate_beta_v_2_error = ksl_product_error(rate_beta_v_2_factor, b, rate_beta_v_2),
      rate_beta_v_2_lo = rate_beta_v_2_error + rate_beta_v_2_cross,
      rate_symmetric_1b = KSL_MUL(s->m3, rate_beta_v_2),
      rate_symmetric_1b_cross2 = KSL_MUL(s->m3, rate_beta_v_2_lo),
      rate_symmetric_1c = KSL_MUL(s->m5, rate_beta_v_0),
      rate_symmetric_1c_cross2 = KSL_MUL(s->m5, rate_beta_v_0_lo),
      rate_symmetric_1d = rate_symmetric_1b + rate_symmetric_1c,
      rate_symmetric_1d_right = rate_symmetric_1d - rate_symmetric_1b,
      rate_symmetric_1d_left = rate_symmetric_1d - rate_symmetric_1d_right,
      rate_symmetric_1d_left_rest = ksl_product_rest(s->m3, rate_beta_v_2, rate_symmetric_1b,
          rate_symmetric_1d_left),
      rate_symmetric_1d_right_rest = ksl_product_rest(s->m5, rate_beta_v_0, rate_symmetric_1c,
          rate_symmetric_1d_right),
      rate_symmetric_1d_cross = rate_symmetric_1b_cross2 + rate_symmetric_1c_cross2,
      rate_symmetric_1d_lo1 = rate_symmetric_1d_left_rest + rate_symmetric_1d_right_rest,
      rate_symmetric_1d_lo = rate_symmetric_1d_lo1 + rate_symmetric_1d_cross,
      rate_symmetric_1 = rate_symmetric_1a - rate_symmetric_1d,
      rate_symmetric_1_right = rate_symmetric_1a - rate_symmetric_1,
      rate_symmetric_1_left = rate_symmetric_1 + rate_symmetric_1_right,
      rate_symmetric_1_left_rest = ksl_product_rest(s->m5, rate_bend_w_0, rate_symmetric_1a,
          rate_symmetric_1_left),
      rate_symmetric_1_right_rest = rate_symmetric_1d - rate_symmetric_1_right,
      rate_symmetric_1_lo1 = rate_symmetric_1_left_rest - rate_symmetric_1_right_rest,
      rate_symmetric_1_lo2 = rate_symmetric_1_lo1 - rate_symmetric_1d_lo,
      rate_symmetric_1_lo = rate_symmetric_1_lo2 + rate_symmetric_1a_cross2;
  const double rate_bend_w_1_error = ksl_product_error(rate_bend_w_1_factor, rate_bend,
      rate_bend_w_1),
      rate_bend_w_1_lo = rate_bend_w_1_error + rate_bend_w_1_cross,
      rate_symmetric_2a = KSL_MUL(s->m5, rate_bend_w_1),
      rate_symmetric_2a_cross2 = KSL_MUL(s->m5, rate_bend_w_1_lo),
      rate_symmetric_2b = KSL_MUL(s->m4, rate_beta_v_2),
      rate_symmetric_2b_cross2 = KSL_MUL(s->m4, rate_beta_v_2_lo),
      rate_symmetric_2c = KSL_MUL(s->m5, rate_beta_v_1),
      rate_symmetric_2c_cross2 = KSL_MUL(s->m5, rate_beta_v_1_lo),
      rate_symmetric_2d = rate_symmetric_2b + rate_symmetric_2c,
      rate_symmetric_2d_right = rate_symmetric_2d - rate_symmetric_2b,
      rate_symmetric_2d_left = rate_symmetric_2d - rate_symmetric_2d_right,
      rate_symmetric_2d_left_rest = ksl_product_rest(s->m4, rate_beta_v_2, rate_symmetric_2b,
          rate_symmetric_2d_left),
      rate_symmetric_2d_right_rest = ksl_product_rest(s->m5, rate_beta_v_1, rate_symmetric_2c,
          rate_symmetric_2d_right),
      rate_symmetric_2d_cross = rate_symmetric_2b_cross2 + rate_symmetric_2c_cross2,
      rate_symmetric_2d_lo1 = rate_symmetric_2d_left_rest + rate_symmetric_2d_right_rest,
      rate_symmetric_2d_lo = rate_symmetric_2d_lo1 + rate_symmetric_2d_cross,
      rate_symmetric_2 = rate_symmetric_2a - rate_symmetric_2d,
      rate_symmetric_2_right = rate_symmetric_2a - rate_symmetric_2,
      rate_symmetric_2_left = rate_symmetric_2 + rate_symmetric_2_right,
      rate_symmetric_2_left_rest = ksl_product_rest(s->m5, rate_bend_w_1, rate_symmetric_2a,
          rate_symmetric_2_left),
      rate_symmetric_2_right_rest = rate_symmetric_2d - rate_symmetric_2_right,
      rate_symmetric_2_lo1 = rate_symmetric_2_left_rest - rate_symmetric_2_right_rest,
      rate_symmetric_2_lo2 = rate_symmetric_2_lo1 - rate_symmetric_2d_lo,
      rate_symmetric_2_lo = rate_symmetric_2_lo2 + rate_symmetric_2a_cross2;
  const double rate_diagonal_0a = KSL_MUL(2.0, s->m4),
      rate_diagonal_0b = KSL_MUL(rate_diagonal_0a, rate_beta_v_1),
      rate_diagonal_0b_cross2 = KSL_MUL(rate_diagonal_0a, rate_beta_v_1_lo),
      rate_diagonal_0c = KSL_MUL(2.0, s->m5),
      rate_diagonal_0d = KSL_MUL(rate_diagonal_0c, rate_beta_v_2),
      rate_diagonal_0d_cross2 = KSL_MUL(rate_diagonal_0c, rate_beta_v_2_lo),
      rate_diagonal_0e = rate_diagonal_0b + rate_diagonal_0d,
      rate_diagonal_0e_right = rate_diagonal_0e - rate_diagonal_0b,
      rate_diagonal_0e_left = rate_diagonal_0e - rate_diagonal_0e_right,
      rate_diagonal_0e_left_rest = ksl_product_rest(rate_diagonal_0a, rate_beta_v_1,
          rate_diagonal_0b, rate_diagonal_0e_left),
      rate_diagonal_0e_right_rest = ksl_product_rest(rate_diagonal_0c, rate_beta_v_2,
          rate_diagonal_0d, rate_diagonal_0e_right),
      rate_diagonal_0e_cross = rate_diagonal_0b_cross2 + rate_diagonal_0d_cross2,
      rate_diagonal_0e_lo1 = rate_diagonal_0e_left_rest + rate_diagonal_0e_right_rest,
      rate_diagonal_0e_lo = rate_diagonal_0e_lo1 + rate_diagonal_0e_cross,
      rate_diagonal_0f = KSL_MUL(s->m4, rate_bend_w_1),
      rate_diagonal_0f_cross2 = KSL_MUL(s->m4, rate_bend_w_1_lo),
      rate_bend_w_2_error = ksl_product_error(rate_bend_w_2_factor, rate_bend, rate_bend_w_2),
      rate_bend_w_2_lo = rate_bend_w_2_error + rate_bend_w_2_cross,
      rate_diagonal_0g = KSL_MUL(s->m5, rate_bend_w_2),
      rate_diagonal_0g_cross2 = KSL_MUL(s->m5, rate_bend_w_2_lo),
      rate_diagonal_0h = rate_diagonal_0f + rate_diagonal_0g,
      rate_diagonal_0h_right = rate_diagonal_0h - rate_diagonal_0f,
      rate_diagonal_0h_left = rate_diagonal_0h - rate_diagonal_0h_right,
      rate_diagonal_0h_left_rest = ksl_product_rest(s->m4, rate_bend_w_1, rate_diagonal_0f,
          rate_diagonal_0h_left),
      rate_diagonal_0h_right_rest = ksl_product_rest(s->m5, rate_bend_w_2, rate_diagonal_0g,
          rate_diagonal_0h_right),
      rate_diagonal_0h_cross = rate_diagonal_0f_cross2 + rate_diagonal_0g_cross2,
      rate_diagonal_0h_lo1 = rate_diagonal_0h_left_rest + rate_diagonal_0h_right_rest,
      rate_diagonal_0h_lo = rate_diagonal_0h_lo1 + rate_diagonal_0h_cross,
      rate_diagonal_0 = rate_diagonal_0e - rate_diagonal_0h,
      rate_diagonal_0_right = rate_diagonal_0e - rate_diagonal_0,
      rate_diagonal_0_left = rate_diagonal_0 + rate_diagonal_0_right,
      rate_diagonal_0_left_rest = rate_diagonal_0e - rate_diagonal_0_left,
      rate_diagonal_0_right_rest = rate_diagonal_0h - rate_diagonal_0_right,
      rate_diagonal_0_lo1 = rate_diagonal_0_left_rest - rate_diagonal_0_right_rest,
      rate_diagonal_0_lo2 = rate_diagonal_0_lo1 - rate_diagonal_0h_lo,
      rate_diagonal_0_lo = rate_diagonal_0_lo2 + rate_diagonal_0e_lo;
  const double rate_diagonal_1a = KSL_MUL(2.0, s->m3),
      rate_diagonal_1b = KSL_MUL(rate_diagonal_1a, rate_beta_v_0),
      rate_diagonal_1b_cross2 = KSL_MUL(rate_diagonal_1a, rate_beta_v_0_lo),
      rate_diagonal_1c = rate_diagonal_1b + rate_diagonal_0d,
      rate_diagonal_1c_right = rate_diagonal_1c - rate_diagonal_1b,
      rate_diagonal_1c_left = rate_diagonal_1c - rate_diagonal_1c_right,
      rate_diagonal_1c_left_rest = ksl_product_rest(rate_diagonal_1a, rate_beta_v_0,
          rate_diagonal_1b, rate_diagonal_1c_left),
      rate_diagonal_1c_right_rest = ksl_product_rest(rate_diagonal_0c, rate_beta_v_2,
          rate_diagonal_0d, rate_diagonal_1c_right),
      rate_diagonal_1c_cross = rate_diagonal_1b_cross2 + rate_diagonal_0d_cross2,
      rate_diagonal_1c_lo1 = rate_diagonal_1c_left_rest + rate_diagonal_1c_right_rest,
      rate_diagonal_1c_lo = rate_diagonal_1c_lo1 + rate_diagonal_1c_cross,
      rate_diagonal_1d = KSL_MUL(s->m3, rate_bend_w_0),
      rate_diagonal_1d_cross2 = KSL_MUL(s->m3, rate_bend_w_0_lo),
      rate_diagonal_1e = rate_diagonal_1d + rate_diagonal_0g,
      rate_diagonal_1e_right = rate_diagonal_1e - rate_diagonal_1d,
      rate_diagonal_1e_left = rate_diagonal_1e - rate_diagonal_1e_right,
      rate_diagonal_1e_left_rest = ksl_product_rest(s->m3, rate_bend_w_0, rate_diagonal_1d,
          rate_diagonal_1e_left),
      rate_diagonal_1e_right_rest = ksl_product_rest(s->m5, rate_bend_w_2, rate_diagonal_0g,
          rate_diagonal_1e_right),
      rate_diagonal_1e_cross = rate_diagonal_1d_cross2 + rate_diagonal_0g_cross2,
      rate_diagonal_1e_lo1 = rate_diagonal_1e_left_rest + rate_diagonal_1e_right_rest,
      rate_diagonal_1e_lo = rate_diagonal_1e_lo1 + rate_diagonal_1e_cross,
      rate_diagonal_1 = rate_diagonal_1c - rate_diagonal_1e,
      rate_diagonal_1_right = rate_diagonal_1c - rate_diagonal_1,
      rate_diagonal_1_left = rate_diagonal_1 + rate_diagonal_1_right,
      rate_diagonal_1_left_rest = rate_diagonal_1c - rate_diagonal_1_left,
      rate_diagonal_1_right_rest = rate_diagonal_1e - rate_diagonal_1_right,
      rate_diagonal_1_lo1 = rate_diagonal_1_left_rest - rate_diagonal_1_right_rest,
      rate_diagonal_1_lo2 = rate_diagonal_1_lo1 - rate_diagonal_1e_lo,
      rate_diagonal_1_lo = rate_diagonal_1_lo2 + rate_diagonal_1c_lo;
  const double rate_diagonal_2a = rate_diagonal_1b + rate_diagonal_0b,
      rate_diagonal_2a_right = rate_diagonal_2a - rate_diagonal_1b,
      rate_diagonal_2a_left = rate_diagonal_2a - rate_diagonal_2a_right,
      rate_diagonal_2a_left_rest = ksl_product_rest(rate_diagonal_1a, rate_beta_v_0,
          rate_diagonal_1b, rate_diagonal_2a_left),
      rate_diagonal_2a_right_rest = ksl_product_rest(rate_diagonal_0a, rate_beta_v_1,
          rate_diagonal_0b, rate_diagonal_2a_right),
      rate_diagonal_2a_cross = rate_diagonal_1b_cross2 + rate_diagonal_0b_cross2,
      rate_diagonal_2a_lo1 = rate_diagonal_2a_left_rest + rate_diagonal_2a_right_rest,
      rate_diagonal_2a_lo = rate_diagonal_2a_lo1 + rate_diagonal_2a_cross,
      rate_diagonal_2b = rate_diagonal_1d + rate_diagonal_0f,
      rate_diagonal_2b_right = rate_diagonal_2b - rate_diagonal_1d,
      rate_diagonal_2b_left = rate_diagonal_2b - rate_diagonal_2b_right,
      rate_diagonal_2b_left_rest = ksl_product_rest(s->m3, rate_bend_w_0, rate_diagonal_1d,
          rate_diagonal_2b_left),
      rate_diagonal_2b_right_rest = ksl_product_rest(s->m4, rate_bend_w_1, rate_diagonal_0f,
          rate_diagonal_2b_right),
      rate_diagonal_2b_cross = rate_diagonal_1d_cross2 + rate_diagonal_0f_cross2,
      rate_diagonal_2b_lo1 = rate_diagonal_2b_left_rest + rate_diagonal_2b_right_rest,
      rate_diagonal_2b_lo = rate_diagonal_2b_lo1 + rate_diagonal_2b_cross,
      rate_diagonal_2 = rate_diagonal_2a - rate_diagonal_2b,
      rate_diagonal_2_right = rate_diagonal_2a - rate_diagonal_2,
      rate_diagonal_2_left = rate_diagonal_2 + rate_diagonal_2_right,
      rate_diagonal_2_left_rest = rate_diagonal_2a - rate_diagonal_2_left,
      rate_diagonal_2_right_rest = rate_diagonal_2b - rate_diagonal_2_right,
      rate_diagonal_2_lo1 = rate_diagonal_2_left_rest - rate_diagonal_2_right_rest,
      rate_diagonal_2_lo2 = rate_diagonal_2_lo1 - rate_diagonal_2b_lo,
      rate_diagonal_2_lo = rate_diagonal_2_lo2 + rate_diagonal_2a_lo;
  const double M_04 = rate_symmetric_0 - rate_q_2, M_04_right = rate_symmetric_0 - M_04,
      M_04_left = M_04 + M_04_right, M_04_left_rest = rate_symmetric_0 - M_04_left,
      M_04_right_rest = rate_q_2 - M_04_right, M_04_lo1 = M_04_left_rest - M_04_right_rest,
      M_04_lo = M_04_lo1 + rate_symmetric_0_lo;
  const double M_05 = rate_q_1 + rate_symmetric_1, M_05_right = M_05 - rate_q_1,
      M_05_left = M_05 - M_05_right, M_05_left_rest = rate_q_1 - M_05_left,
      M_05_right_rest = rate_symmetric_1 - M_05_right, M_05_lo1 = M_05_left_rest + M_05_right_rest,
      M_05_lo = M_05_lo1 + rate_symmetric_1_lo;
  const double M_13 = rate_q_2 + rate_symmetric_0, M_13_right = M_13 - rate_q_2,
      M_13_left = M_13 - M_13_right, M_13_left_rest = rate_q_2 - M_13_left,
      M_13_right_rest = rate_symmetric_0 - M_13_right, M_13_lo1 = M_13_left_rest + M_13_right_rest,
      M_13_lo = M_13_lo1 + rate_symmetric_0_lo;
  const double M_15 = rate_symmetric_2 - rate_q_0, M_15_right = rate_symmetric_2 - M_15,
      M_15_left = M_15 + M_15_right, M_15_left_rest = rate_symmetric_2 - M_15_left,
      M_15_right_rest = rate_q_0 - M_15_right, M_15_lo1 = M_15_left_rest - M_15_right_rest,
      M_15_lo = M_15_lo1 + rate_symmetric_2_lo;
  const double M_23 = rate_symmetric_1 - rate_q_1, M_23_right = rate_symmetric_1 - M_23,
      M_23_left = M_23 + M_23_right, M_23_left_rest = rate_symmetric_1 - M_23_left,
      M_23_right_rest = rate_q_1 - M_23_right, M_23_lo1 = M_23_left_rest - M_23_right_rest,
      M_23_lo = M_23_lo1 + rate_symmetric_1_lo;
  const double M_24 = rate_q_0 + rate_symmetric_2, M_24_right = M_24 - rate_q_0,
      M_24_left = M_24 - M_24_right, M_24_left_rest = rate_q_0 - M_24_left,
      M_24_right_rest = rate_symmetric_2 - M_24_right, M_24_lo1 = M_24_left_rest + M_24_right_rest,
      M_24_lo = M_24_lo1 + rate_symmetric_2_lo;
  const double diagonal0_rounded = diagonal0 + diagonal0_lo,
      diagonal0_final = diagonal0_rounded == diagonal0_rounded ? diagonal0_rounded : diagonal0;
  const double J_1_rounded = J_1 + J_1_lo,
      J_1_final = J_1_rounded == J_1_rounded ? J_1_rounded : J_1;
  const double J_2_rounded = J_2 + J_2_lo,
      J_2_final = J_2_rounded == J_2_rounded ? J_2_rounded : J_2;
  const double rate_diagonal_0_rounded = rate_diagonal_0 + rate_diagonal_0_lo,
      rate_diagonal_0_final = rate_diagonal_0_rounded == rate_diagonal_0_rounded ?
          rate_diagonal_0_rounded : rate_diagonal_0;
  const double M_04_rounded = M_04 + M_04_lo,
      M_04_final = M_04_rounded == M_04_rounded ? M_04_rounded : M_04;
  const double M_05_rounded = M_05 + M_05_lo,
      M_05_final = M_05_rounded == M_05_rounded ? M_05_rounded : M_05;
  const double J_3_rounded = J_3 + J_3_lo,
      J_3_final = J_3_rounded == J_3_rounded ? J_3_rounded : J_3;
  const double diagonal1_rounded = diagonal1 + diagonal1_lo,
      diagonal1_final = diagonal1_rounded == diagonal1_rounded ? diagonal1_rounded : diagonal1;
  const double J_5_rounded = J_5 + J_5_lo,
      J_5_final = J_5_rounded == J_5_rounded ? J_5_rounded : J_5;
  const double M_13_rounded = M_13 + M_13_lo,
      M_13_final = M_13_rounded == M_13_rounded ? M_13_rounded : M_13;
  const double rate_diagonal_1_rounded = rate_diagonal_1 + rate_diagonal_1_lo,
      rate_diagonal_1_final = rate_diagonal_1_rounded == rate_diagonal_1_rounded ?
          rate_diagonal_1_rounded : rate_diagonal_1;
  const double M_15_rounded = M_15 + M_15_lo,
      M_15_final = M_15_rounded == M_15_rounded ? M_15_rounded : M_15;
  const double J_6_rounded = J_6 + J_6_lo,
      J_6_final = J_6_rounded == J_6_rounded ? J_6_rounded : J_6;
  const double J_7_rounded = J_7 + J_7_lo,
      J_7_final = J_7_rounded == J_7_rounded ? J_7_rounded : J_7;
  const double diagonal2_rounded = diagonal2 + diagonal2_lo,
      diagonal2_final = diagonal2_rounded == diagonal2_rounded ? diagonal2_rounded : diagonal2;
  const double M_23_rounded = M_23 + M_23_lo,
      M_23_final = M_23_rounded == M_23_rounded ? M_23_rounded : M_23;
  const double M_24_rounded = M_24 + M_24_lo,
      M_24_final = M_24_rounded == M_24_rounded ? M_24_rounded : M_24;
  const double rate_diagonal_2_rounded = rate_diagonal_2 + rate_diagonal_2_lo,
      rate_diagonal_2_final = rate_diagonal_2_rounded == rate_diagonal_2_rounded ?
          rate_diagonal_2_rounded : rate_diagonal_2;
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
      apart_0_left = apart_0 + apart_0_right, apart_0_left_rest = D2->m03 - apart_0_left,
      apart_0_right_rest = D1->m03 - apart_0_right,
      apart_0_lo = apart_0_left_rest - apart_0_right_rest;
  const double apart_1 = D2->m13 - D1->m13, apart_1_right = D2->m13 - apart_1,
      apart_1_left = apart_1 + apart_1_right, apart_1_left_rest = D2->m13 - apart_1_left,
      apart_1_right_rest = D1->m13 - apart_1_right,
      apart_1_lo = apart_1_left_rest - apart_1_right_rest;
  const double apart_2 = D2->m23 - D1->m23, apart_2_right = D2->m23 - apart_2,
      apart_2_left = apart_2 + apart_2_right, apart_2_left_rest = D2->m23 - apart_2_left,
      apart_2_right_rest = D1->m23 - apart_2_right,
      apart_2_lo = apart_2_left_rest - apart_2_right_rest;
  const double between_0a = KSL_MUL(D1->m00, D2->m00), between_0b = KSL_MUL(D1->m10, D2->m10),
      between_0c = between_0a + between_0b, between_0c_right = between_0c - between_0a,
      between_0c_left = between_0c - between_0c_right,
      between_0c_left_rest = ksl_product_rest(D1->m00, D2->m00, between_0a, between_0c_left),
      between_0c_right_rest = ksl_product_rest(D1->m10, D2->m10, between_0b, between_0c_right),
      between_0c_lo = between_0c_left_rest + between_0c_right_rest,
      between_0d = KSL_MUL(D1->m20, D2->m20), between_0 = between_0c + between_0d,
      between_0_right = between_0 - between_0c, between_0_left = between_0 - between_0_right,
      between_0_left_rest = between_0c - between_0_left,
      between_0_right_rest = ksl_product_rest(D1->m20, D2->m20, between_0d, between_0_right),
      between_0_lo1 = between_0_left_rest + between_0_right_rest,
      between_0_lo = between_0_lo1 + between_0c_lo;
  const double between_1a = KSL_MUL(D1->m00, D2->m01), between_1b = KSL_MUL(D1->m10, D2->m11),
      between_1c = between_1a + between_1b, between_1c_right = between_1c - between_1a,
      between_1c_left = between_1c - between_1c_right,
      between_1c_left_rest = ksl_product_rest(D1->m00, D2->m01, between_1a, between_1c_left),
      between_1c_right_rest = ksl_product_rest(D1->m10, D2->m11, between_1b, between_1c_right),
      between_1c_lo = between_1c_left_rest + between_1c_right_rest,
      between_1d = KSL_MUL(D1->m20, D2->m21), between_1 = between_1c + between_1d,
      between_1_right = between_1 - between_1c, between_1_left = between_1 - between_1_right,
      between_1_left_rest = between_1c - between_1_left,
      between_1_right_rest = ksl_product_rest(D1->m20, D2->m21, between_1d, between_1_right),
      between_1_lo1 = between_1_left_rest + between_1_right_rest,
      between_1_lo = between_1_lo1 + between_1c_lo;
  const double between_2a = KSL_MUL(D1->m00, D2->m02), between_2b = KSL_MUL(D1->m10, D2->m12),
      between_2c = between_2a + between_2b, between_2c_right = between_2c - between_2a,
      between_2c_left = between_2c - between_2c_right,
      between_2c_left_rest = ksl_product_rest(D1->m00, D2->m02, between_2a, between_2c_left),
      between_2c_right_rest = ksl_product_rest(D1->m10, D2->m12, between_2b, between_2c_right),
      between_2c_lo = between_2c_left_rest + between_2c_right_rest,
      between_2d = KSL_MUL(D1->m20, D2->m22), between_2 = between_2c + between_2d,
      between_2_right = between_2 - between_2c, between_2_left = between_2 - between_2_right,
      between_2_left_rest = between_2c - between_2_left,
      between_2_right_rest = ksl_product_rest(D1->m20, D2->m22, between_2d, between_2_right),
      between_2_lo1 = between_2_left_rest + between_2_right_rest,
      between_2_lo = between_2_lo1 + between_2c_lo;
  const double between_3a = KSL_MUL(D1->m00, apart_0),
      between_3a_cross2 = KSL_MUL(D1->m00, apart_0_lo), between_3b = KSL_MUL(D1->m10, apart_1),
      between_3b_cross2 = KSL_MUL(D1->m10, apart_1_lo), between_3c = between_3a + between_3b,
      between_3c_right = between_3c - between_3a, between_3c_left = between_3c - between_3c_right,
      between_3c_left_rest = ksl_product_rest(D1->m00, apart_0, between_3a, between_3c_left),
      between_3c_right_rest = ksl_product_rest(D1->m10, apart_1, between_3b, between_3c_right),
      between_3c_cross = between_3a_cross2 + between_3b_cross2,
      between_3c_lo1 = between_3c_left_rest + between_3c_right_rest,
      between_3c_lo = between_3c_lo1 + between_3c_cross, between_3d = KSL_MUL(D1->m20, apart_2),
      between_3d_cross2 = KSL_MUL(D1->m20, apart_2_lo), between_3 = between_3c + between_3d,
      between_3_right = between_3 - between_3c, between_3_left = between_3 - between_3_right,
      between_3_left_rest = between_3c - between_3_left,
      between_3_right_rest = ksl_product_rest(D1->m20, apart_2, between_3d, between_3_right),
      between_3_lo1 = between_3_left_rest + between_3_right_rest,
      between_3_lo2 = between_3_lo1 + between_3d_cross2,
      between_3_lo = between_3_lo2 + between_3c_lo;
  const double between_4a = KSL_MUL(D1->m01, D2->m00), between_4b = KSL_MUL(D1->m11, D2->m10),
      between_4c = between_4a + between_4b, between_4c_right = between_4c - between_4a,
      between_4c_left = between_4c - between_4c_right,
      between_4c_left_rest = ksl_product_rest(D1->m01, D2->m00, between_4a, between_4c_left),
      between_4c_right_rest = ksl_product_rest(D1->m11, D2->m10, between_4b, between_4c_right),
      between_4c_lo = between_4c_left_rest + between_4c_right_rest,
      between_4d = KSL_MUL(D1->m21, D2->m20), between_4 = between_4c + between_4d,
      between_4_right = between_4 - between_4c, between_4_left = between_4 - between_4_right,
      between_4_left_rest = between_4c - between_4_left,
      between_4_right_rest = ksl_product_rest(D1->m21, D2->m20, between_4d, between_4_right),
      between_4_lo1 = between_4_left_rest + between_4_right_rest,
      between_4_lo = between_4_lo1 + between_4c_lo;
  const double between_5a = KSL_MUL(D1->m01, D2->m01), between_5b = KSL_MUL(D1->m11, D2->m11),
      between_5c = between_5a + between_5b, between_5c_right = between_5c - between_5a,
      between_5c_left = between_5c - between_5c_right,
      between_5c_left_rest = ksl_product_rest(D1->m01, D2->m01, between_5a, between_5c_left),
      between_5c_right_rest = ksl_product_rest(D1->m11, D2->m11, between_5b, between_5c_right),
      between_5c_lo = between_5c_left_rest + between_5c_right_rest,
      between_5d = KSL_MUL(D1->m21, D2->m21), between_5 = between_5c + between_5d,
      between_5_right = between_5 - between_5c, between_5_left = between_5 - between_5_right,
      between_5_left_rest = between_5c - between_5_left,
      between_5_right_rest = ksl_product_rest(D1->m21, D2->m21, between_5d, between_5_right),
      between_5_lo1 = between_5_left_rest + between_5_right_rest,
      between_5_lo = between_5_lo1 + between_5c_lo;
  const double between_6a = KSL_MUL(D1->m01, D2->m02), between_6b = KSL_MUL(D1->m11, D2->m12),
      between_6c = between_6a + between_6b, between_6c_right = between_6c - between_6a,
      between_6c_left = between_6c - between_6c_right,
      between_6c_left_rest = ksl_product_rest(D1->m01, D2->m02, between_6a, between_6c_left),
      between_6c_right_rest = ksl_product_rest(D1->m11, D2->m12, between_6b, between_6c_right),
      between_6c_lo = between_6c_left_rest + between_6c_right_rest,
      between_6d = KSL_MUL(D1->m21, D2->m22), between_6 = between_6c + between_6d,
      between_6_right = between_6 - between_6c, between_6_left = between_6 - between_6_right,
      between_6_left_rest = between_6c - between_6_left,
      between_6_right_rest = ksl_product_rest(D1->m21, D2->m22, between_6d, between_6_right),
      between_6_lo1 = between_6_left_rest + between_6_right_rest,
      between_6_lo = between_6_lo1 + between_6c_lo;
  const double between_7a = KSL_MUL(D1->m01, apart_0),
      between_7a_cross2 = KSL_MUL(D1->m01, apart_0_lo), between_7b = KSL_MUL(D1->m11, apart_1),
      between_7b_cross2 = KSL_MUL(D1->m11, apart_1_lo), between_7c = between_7a + between_7b,
      between_7c_right = between_7c - between_7a, between_7c_left = between_7c - between_7c_right,
      between_7c_left_rest = ksl_product_rest(D1->m01, apart_0, between_7a, between_7c_left),
      between_7c_right_rest = ksl_product_rest(D1->m11, apart_1, between_7b, between_7c_right),
      between_7c_cross = between_7a_cross2 + between_7b_cross2,
      between_7c_lo1 = between_7c_left_rest + between_7c_right_rest,
      between_7c_lo = between_7c_lo1 + between_7c_cross, between_7d = KSL_MUL(D1->m21, apart_2),
      between_7d_cross2 = KSL_MUL(D1->m21, apart_2_lo), between_7 = between_7c + between_7d,
      between_7_right = between_7 - between_7c, between_7_left = between_7 - between_7_right,
      between_7_left_rest = between_7c - between_7_left,
      between_7_right_rest = ksl_product_rest(D1->m21, apart_2, between_7d, between_7_right),
      between_7_lo1 = between_7_left_rest + between_7_right_rest,
      between_7_lo2 = between_7_lo1 + between_7d_cross2,
      between_7_lo = between_7_lo2 + between_7c_lo;
  const double between_8a = KSL_MUL(D1->m02, D2->m00), between_8b = KSL_MUL(D1->m12, D2->m10),
      between_8c = between_8a + between_8b, between_8c_right = between_8c - between_8a,
      between_8c_left = between_8c - between_8c_right,
      between_8c_left_rest = ksl_product_rest(D1->m02, D2->m00, between_8a, between_8c_left),
      between_8c_right_rest = ksl_product_rest(D1->m12, D2->m10, between_8b, between_8c_right),
      between_8c_lo = between_8c_left_rest + between_8c_right_rest,
      between_8d = KSL_MUL(D1->m22, D2->m20), between_8 = between_8c + between_8d,
      between_8_right = between_8 - between_8c, between_8_left = between_8 - between_8_right,
      between_8_left_rest = between_8c - between_8_left,
      between_8_right_rest = ksl_product_rest(D1->m22, D2->m20, between_8d, between_8_right),
      between_8_lo1 = between_8_left_rest + between_8_right_rest,
      between_8_lo = between_8_lo1 + between_8c_lo;
  const double between_9a = KSL_MUL(D1->m02, D2->m01), between_9b = KSL_MUL(D1->m12, D2->m11),
      between_9c = between_9a + between_9b, between_9c_right = between_9c - between_9a,
      between_9c_left = between_9c - between_9c_right,
      between_9c_left_rest = ksl_product_rest(D1->m02, D2->m01, between_9a, between_9c_left),
      between_9c_right_rest = ksl_product_rest(D1->m12, D2->m11, between_9b, between_9c_right),
      between_9c_lo = between_9c_left_rest + between_9c_right_rest,
      between_9d = KSL_MUL(D1->m22, D2->m21), between_9 = between_9c + between_9d,
      between_9_right = between_9 - between_9c, between_9_left = between_9 - between_9_right,
      between_9_left_rest = between_9c - between_9_left,
      between_9_right_rest = ksl_product_rest(D1->m22, D2->m21, between_9d, between_9_right),
      between_9_lo1 = between_9_left_rest + between_9_right_rest,
      between_9_lo = between_9_lo1 + between_9c_lo;
  const double between_10a = KSL_MUL(D1->m02, D2->m02), between_10b = KSL_MUL(D1->m12, D2->m12),
      between_10c = between_10a + between_10b, between_10c_right = between_10c - between_10a,
      between_10c_left = between_10c - between_10c_right,
      between_10c_left_rest = ksl_product_rest(D1->m02, D2->m02, between_10a, between_10c_left),
      between_10c_right_rest = ksl_product_rest(D1->m12, D2->m12, between_10b, between_10c_right),
      between_10c_lo = between_10c_left_rest + between_10c_right_rest,
      between_10d = KSL_MUL(D1->m22, D2->m22), between_10 = between_10c + between_10d,
      between_10_right = between_10 - between_10c, between_10_left = between_10 - between_10_right,
      between_10_left_rest = between_10c - between_10_left,
      between_10_right_rest = ksl_product_rest(D1->m22, D2->m22, between_10d, between_10_right),
      between_10_lo1 = between_10_left_rest + between_10_right_rest,
      between_10_lo = between_10_lo1 + between_10c_lo;
  const double between_11a = KSL_MUL(D1->m02, apart_0),
      between_11a_cross2 = KSL_MUL(D1->m02, apart_0_lo), between_11b = KSL_MUL(D1->m12, apart_1),
      between_11b_cross2 = KSL_MUL(D1->m12, apart_1_lo), between_11c = between_11a + between_11b,
      between_11c_right = between_11c - between_11a,
      between_11c_left = between_11c - between_11c_right,
      between_11c_left_rest = ksl_product_rest(D1->m02, apart_0, between_11a, between_11c_left),
      between_11c_right_rest = ksl_product_rest(D1->m12, apart_1, between_11b, between_11c_right),
      between_11c_cross = between_11a_cross2 + between_11b_cross2,
      between_11c_lo1 = between_11c_left_rest + between_11c_right_rest,
      between_11c_lo = between_11c_lo1 + between_11c_cross, between_11d = KSL_MUL(D1->m22, apart_2),
      between_11d_cross2 = KSL_MUL(D1->m22, apart_2_lo), between_11 = between_11c + between_11d,
      between_11_right = between_11 - between_11c, between_11_left = between_11 - between_11_right,
      between_11_left_rest = between_11c - between_11_left,
      between_11_right_rest = ksl_product_rest(D1->m22, apart_2, between_11d, between_11_right),
      between_11_lo1 = between_11_left_rest + between_11_right_rest,
      between_11_lo2 = between_11_lo1 + between_11d_cross2,
      between_11_lo = between_11_lo2 + between_11c_lo;
  const double log_p_0 = between_9 - between_6, log_p_0_right = between_9 - log_p_0,
      log_p_0_left = log_p_0 + log_p_0_right, log_p_0_left_rest = between_9 - log_p_0_left,
      log_p_0_right_rest = between_6 - log_p_0_right,
      log_p_0_lo1 = log_p_0_left_rest - log_p_0_right_rest,
      log_p_0_lo2 = log_p_0_lo1 - between_6_lo, log_p_0_lo = log_p_0_lo2 + between_9_lo;
  const double log_p_1 = between_2 - between_8, log_p_1_right = between_2 - log_p_1,
      log_p_1_left = log_p_1 + log_p_1_right, log_p_1_left_rest = between_2 - log_p_1_left,
      log_p_1_right_rest = between_8 - log_p_1_right,
      log_p_1_lo1 = log_p_1_left_rest - log_p_1_right_rest,
      log_p_1_lo2 = log_p_1_lo1 - between_8_lo, log_p_1_lo = log_p_1_lo2 + between_2_lo;
  const double log_p_2 = between_4 - between_1, log_p_2_right = between_4 - log_p_2,
      log_p_2_left = log_p_2 + log_p_2_right, log_p_2_left_rest = between_4 - log_p_2_left,
      log_p_2_right_rest = between_1 - log_p_2_right,
      log_p_2_lo1 = log_p_2_left_rest - log_p_2_right_rest,
      log_p_2_lo2 = log_p_2_lo1 - between_1_lo, log_p_2_lo = log_p_2_lo2 + between_4_lo;
  const double log_s_0 = between_6 + between_9, log_s_0_right = log_s_0 - between_6,
      log_s_0_left = log_s_0 - log_s_0_right, log_s_0_left_rest = between_6 - log_s_0_left,
      log_s_0_right_rest = between_9 - log_s_0_right,
      log_s_0_lo1 = log_s_0_left_rest + log_s_0_right_rest,
      log_s_0_lo2 = log_s_0_lo1 + between_9_lo, log_s_0_lo = log_s_0_lo2 + between_6_lo;
  const double log_s_1 = between_2 + between_8, log_s_1_right = log_s_1 - between_2,
      log_s_1_left = log_s_1 - log_s_1_right, log_s_1_left_rest = between_2 - log_s_1_left,
      log_s_1_right_rest = between_8 - log_s_1_right,
      log_s_1_lo1 = log_s_1_left_rest + log_s_1_right_rest,
      log_s_1_lo2 = log_s_1_lo1 + between_8_lo, log_s_1_lo = log_s_1_lo2 + between_2_lo;
  const double log_s_2 = between_1 + between_4, log_s_2_right = log_s_2 - between_1,
      log_s_2_left = log_s_2 - log_s_2_right, log_s_2_left_rest = between_1 - log_s_2_left,
      log_s_2_right_rest = between_4 - log_s_2_right,
      log_s_2_lo1 = log_s_2_left_rest + log_s_2_right_rest,
      log_s_2_lo2 = log_s_2_lo1 + between_4_lo, log_s_2_lo = log_s_2_lo2 + between_1_lo;
  const double log_first_0 = between_0 + 1.0, log_first_0_right = log_first_0 - between_0,
      log_first_0_left = log_first_0 - log_first_0_right,
      log_first_0_left_rest = between_0 - log_first_0_left,
      log_first_0_right_rest = 1.0 - log_first_0_right,
      log_first_0_lo1 = log_first_0_left_rest + log_first_0_right_rest,
      log_first_0_lo = log_first_0_lo1 + between_0_lo;
  const double log_first_1 = 1.0 - between_0, log_first_1_right = 1.0 - log_first_1,
      log_first_1_left = log_first_1 + log_first_1_right,
      log_first_1_left_rest = 1.0 - log_first_1_left,
      log_first_1_right_rest = between_0 - log_first_1_right,
      log_first_1_lo1 = log_first_1_left_rest - log_first_1_right_rest,
      log_first_1_lo = log_first_1_lo1 - between_0_lo;
  const double log_others_0 = between_5 + between_10, log_others_0_right = log_others_0 - between_5,
      log_others_0_left = log_others_0 - log_others_0_right,
      log_others_0_left_rest = between_5 - log_others_0_left,
      log_others_0_right_rest = between_10 - log_others_0_right,
      log_others_0_lo1 = log_others_0_left_rest + log_others_0_right_rest,
      log_others_0_lo2 = log_others_0_lo1 + between_10_lo,
      log_others_0_lo = log_others_0_lo2 + between_5_lo;
  const double log_others_1 = between_5 - between_10, log_others_1_right = between_5 - log_others_1,
      log_others_1_left = log_others_1 + log_others_1_right,
      log_others_1_left_rest = between_5 - log_others_1_left,
      log_others_1_right_rest = between_10 - log_others_1_right,
      log_others_1_lo1 = log_others_1_left_rest - log_others_1_right_rest,
      log_others_1_lo2 = log_others_1_lo1 - between_10_lo,
      log_others_1_lo = log_others_1_lo2 + between_5_lo;
  const double log_d_0 = log_first_0 + log_others_0, log_d_0_right = log_d_0 - log_first_0,
      log_d_0_left = log_d_0 - log_d_0_right, log_d_0_left_rest = log_first_0 - log_d_0_left,
      log_d_0_right_rest = log_others_0 - log_d_0_right,
      log_d_0_lo1 = log_d_0_left_rest + log_d_0_right_rest,
      log_d_0_lo2 = log_d_0_lo1 + log_others_0_lo, log_d_0_lo = log_d_0_lo2 + log_first_0_lo;
  const double log_d_1 = log_first_0 - log_others_0, log_d_1_right = log_first_0 - log_d_1,
      log_d_1_left = log_d_1 + log_d_1_right, log_d_1_left_rest = log_first_0 - log_d_1_left,
      log_d_1_right_rest = log_others_0 - log_d_1_right,
      log_d_1_lo1 = log_d_1_left_rest - log_d_1_right_rest,
      log_d_1_lo2 = log_d_1_lo1 - log_others_0_lo, log_d_1_lo = log_d_1_lo2 + log_first_0_lo;
  const double log_d_2 = log_first_1 + log_others_1, log_d_2_right = log_d_2 - log_first_1,
      log_d_2_left = log_d_2 - log_d_2_right, log_d_2_left_rest = log_first_1 - log_d_2_left,
      log_d_2_right_rest = log_others_1 - log_d_2_right,
      log_d_2_lo1 = log_d_2_left_rest + log_d_2_right_rest,
      log_d_2_lo2 = log_d_2_lo1 + log_others_1_lo, log_d_2_lo = log_d_2_lo2 + log_first_1_lo;
  const double log_d_3 = log_first_1 - log_others_1, log_d_3_right = log_first_1 - log_d_3,
      log_d_3_left = log_d_3 + log_d_3_right, log_d_3_left_rest = log_first_1 - log_d_3_left,
      log_d_3_right_rest = log_others_1 - log_d_3_right,
      log_d_3_lo1 = log_d_3_left_rest - log_d_3_right_rest,
      log_d_3_lo2 = log_d_3_lo1 - log_others_1_lo, log_d_3_lo = log_d_3_lo2 + log_first_1_lo;
  const double log_low_0a_of_between_5 = between_5 + between_5_lo,
      log_low_0a_of_between_5_right = log_low_0a_of_between_5 - between_5,
      log_low_0a_of_between_5_left = log_low_0a_of_between_5 - log_low_0a_of_between_5_right,
      log_low_0a_of_between_5_left_rest = between_5 - log_low_0a_of_between_5_left,
      log_low_0a_of_between_5_right_rest = between_5_lo - log_low_0a_of_between_5_right,
      log_low_0a_of_between_5_lo = log_low_0a_of_between_5_left_rest +
          log_low_0a_of_between_5_right_rest,
      log_low_0a_of_between_0 = between_0 + between_0_lo,
      log_low_0 = log_low_0a_of_between_5 < log_low_0a_of_between_0 ? log_d_1 : log_s_2,
      log_low_0_lo = log_low_0a_of_between_5 < log_low_0a_of_between_0 ? log_d_1_lo : log_s_2_lo;
  const double log_low_1 = log_low_0a_of_between_5 < log_low_0a_of_between_0 ? log_s_2 : log_d_2,
      log_low_1_lo = log_low_0a_of_between_5 < log_low_0a_of_between_0 ? log_s_2_lo : log_d_2_lo;
  const double log_low_2 = log_low_0a_of_between_5 < log_low_0a_of_between_0 ? log_s_1 : log_s_0,
      log_low_2_lo = log_low_0a_of_between_5 < log_low_0a_of_between_0 ? log_s_1_lo : log_s_0_lo;
  const double log_low_3 = log_low_0a_of_between_5 < log_low_0a_of_between_0 ? log_p_0 : log_p_1,
      log_low_3_lo = log_low_0a_of_between_5 < log_low_0a_of_between_0 ? log_p_0_lo : log_p_1_lo;
  const double log_high_0a = -log_low_0a_of_between_5, log_high_0a_lo = -log_low_0a_of_between_5_lo,
      log_high_0b_of_log_high_0a = log_high_0a + log_high_0a_lo,
      log_high_0 = log_low_0a_of_between_0 < log_high_0b_of_log_high_0a ? log_s_1 : log_p_0,
      log_high_0_lo = log_low_0a_of_between_0 < log_high_0b_of_log_high_0a ? log_s_1_lo :
          log_p_0_lo;
  const double log_high_1 = log_low_0a_of_between_0 < log_high_0b_of_log_high_0a ? log_s_0 :
      log_p_1,
      log_high_1_lo = log_low_0a_of_between_0 < log_high_0b_of_log_high_0a ? log_s_0_lo :
          log_p_1_lo;
  const double log_high_2 = log_low_0a_of_between_0 < log_high_0b_of_log_high_0a ? log_d_3 :
      log_p_2,
      log_high_2_lo = log_low_0a_of_between_0 < log_high_0b_of_log_high_0a ? log_d_3_lo :
          log_p_2_lo;
  const double log_high_3 = log_low_0a_of_between_0 < log_high_0b_of_log_high_0a ? log_p_2 :
      log_d_0,
      log_high_3_lo = log_low_0a_of_between_0 < log_high_0b_of_log_high_0a ? log_p_2_lo :
          log_d_0_lo;
  const double log_column_0a_of_between_10 = between_10 + between_10_lo,
      log_column_0 = log_column_0a_of_between_10 < 0.0 ? log_low_0 : log_high_0,
      log_column_0_lo = log_column_0a_of_between_10 < 0.0 ? log_low_0_lo : log_high_0_lo;
  const double log_column_1 = log_column_0a_of_between_10 < 0.0 ? log_low_1 : log_high_1,
      log_column_1_lo = log_column_0a_of_between_10 < 0.0 ? log_low_1_lo : log_high_1_lo;
  const double log_column_2 = log_column_0a_of_between_10 < 0.0 ? log_low_2 : log_high_2,
      log_column_2_lo = log_column_0a_of_between_10 < 0.0 ? log_low_2_lo : log_high_2_lo;
  const double log_column_3 = log_column_0a_of_between_10 < 0.0 ? log_low_3 : log_high_3,
      log_column_3_lo = log_column_0a_of_between_10 < 0.0 ? log_low_3_lo : log_high_3_lo;
  const double log_upper_0a = -log_column_0, log_upper_0a_lo = -log_column_0_lo,
      log_upper_0b_of_log_column_3 = log_column_3 + log_column_3_lo,
      log_upper_0b_of_log_column_3_right = log_upper_0b_of_log_column_3 - log_column_3,
      log_upper_0b_of_log_column_3_left = log_upper_0b_of_log_column_3 -
          log_upper_0b_of_log_column_3_right,
      log_upper_0b_of_log_column_3_left_rest = log_column_3 - log_upper_0b_of_log_column_3_left,
      log_upper_0b_of_log_column_3_right_rest = log_column_3_lo -
          log_upper_0b_of_log_column_3_right,
      log_upper_0b_of_log_column_3_lo = log_upper_0b_of_log_column_3_left_rest +
          log_upper_0b_of_log_column_3_right_rest,
      log_upper_0 = log_upper_0b_of_log_column_3 < 0.0 ? log_upper_0a : log_column_0,
      log_upper_0_lo = log_upper_0b_of_log_column_3 < 0.0 ? log_upper_0a_lo : log_column_0_lo;
  const double log_upper_1a = -log_column_1, log_upper_1a_lo = -log_column_1_lo,
      log_upper_1 = log_upper_0b_of_log_column_3 < 0.0 ? log_upper_1a : log_column_1,
      log_upper_1_lo = log_upper_0b_of_log_column_3 < 0.0 ? log_upper_1a_lo : log_column_1_lo;
  const double log_upper_2a = -log_column_2, log_upper_2a_lo = -log_column_2_lo,
      log_upper_2 = log_upper_0b_of_log_column_3 < 0.0 ? log_upper_2a : log_column_2,
      log_upper_2_lo = log_upper_0b_of_log_column_3 < 0.0 ? log_upper_2a_lo : log_column_2_lo;
  const double log_upper_3 = fabs(log_upper_0b_of_log_column_3),
      log_upper_3_opposite = -log_upper_0b_of_log_column_3_lo,
      log_upper_3_lo = log_upper_0b_of_log_column_3 < 0.0 ? log_upper_3_opposite :
          log_upper_0b_of_log_column_3_lo;
  const double log_v_s_size_0_of_log_upper_0 = log_upper_0 + log_upper_0_lo,
      log_v_s_size_0_of_log_upper_0_right = log_v_s_size_0_of_log_upper_0 - log_upper_0,
      log_v_s_size_0_of_log_upper_0_left = log_v_s_size_0_of_log_upper_0 -
          log_v_s_size_0_of_log_upper_0_right,
      log_v_s_size_0_of_log_upper_0_left_rest = log_upper_0 - log_v_s_size_0_of_log_upper_0_left,
      log_v_s_size_0_of_log_upper_0_right_rest = log_upper_0_lo -
          log_v_s_size_0_of_log_upper_0_right,
      log_v_s_size_0_of_log_upper_0_lo = log_v_s_size_0_of_log_upper_0_left_rest +
          log_v_s_size_0_of_log_upper_0_right_rest,
      log_v_s_size_0 = fabs(log_v_s_size_0_of_log_upper_0),
      log_v_s_size_0_opposite = -log_v_s_size_0_of_log_upper_0_lo,
      log_v_s_size_0_lo = log_v_s_size_0_of_log_upper_0 < 0.0 ? log_v_s_size_0_opposite :
          log_v_s_size_0_of_log_upper_0_lo;
  const double log_v_s_size_1_of_log_upper_1 = log_upper_1 + log_upper_1_lo,
      log_v_s_size_1_of_log_upper_1_right = log_v_s_size_1_of_log_upper_1 - log_upper_1,
      log_v_s_size_1_of_log_upper_1_left = log_v_s_size_1_of_log_upper_1 -
          log_v_s_size_1_of_log_upper_1_right,
      log_v_s_size_1_of_log_upper_1_left_rest = log_upper_1 - log_v_s_size_1_of_log_upper_1_left,
      log_v_s_size_1_of_log_upper_1_right_rest = log_upper_1_lo -
          log_v_s_size_1_of_log_upper_1_right,
      log_v_s_size_1_of_log_upper_1_lo = log_v_s_size_1_of_log_upper_1_left_rest +
          log_v_s_size_1_of_log_upper_1_right_rest,
      log_v_s_size_1 = fabs(log_v_s_size_1_of_log_upper_1),
      log_v_s_size_1_opposite = -log_v_s_size_1_of_log_upper_1_lo,
      log_v_s_size_1_lo = log_v_s_size_1_of_log_upper_1 < 0.0 ? log_v_s_size_1_opposite :
          log_v_s_size_1_of_log_upper_1_lo;
  const double log_v_s_size_2_of_log_upper_2 = log_upper_2 + log_upper_2_lo,
      log_v_s_size_2_of_log_upper_2_right = log_v_s_size_2_of_log_upper_2 - log_upper_2,
      log_v_s_size_2_of_log_upper_2_left = log_v_s_size_2_of_log_upper_2 -
          log_v_s_size_2_of_log_upper_2_right,
      log_v_s_size_2_of_log_upper_2_left_rest = log_upper_2 - log_v_s_size_2_of_log_upper_2_left,
      log_v_s_size_2_of_log_upper_2_right_rest = log_upper_2_lo -
          log_v_s_size_2_of_log_upper_2_right,
      log_v_s_size_2_of_log_upper_2_lo = log_v_s_size_2_of_log_upper_2_left_rest +
          log_v_s_size_2_of_log_upper_2_right_rest,
      log_v_s_size_2 = fabs(log_v_s_size_2_of_log_upper_2),
      log_v_s_size_2_opposite = -log_v_s_size_2_of_log_upper_2_lo,
      log_v_s_size_2_lo = log_v_s_size_2_of_log_upper_2 < 0.0 ? log_v_s_size_2_opposite :
          log_v_s_size_2_of_log_upper_2_lo;
  const double log_v_s_largest1a_of_log_v_s_size_0 = log_v_s_size_0 + log_v_s_size_0_lo,
      log_v_s_largest1a_of_log_v_s_size_0_right = log_v_s_largest1a_of_log_v_s_size_0 -
          log_v_s_size_0,
      log_v_s_largest1a_of_log_v_s_size_0_left = log_v_s_largest1a_of_log_v_s_size_0 -
          log_v_s_largest1a_of_log_v_s_size_0_right,
      log_v_s_largest1a_of_log_v_s_size_0_left_rest = log_v_s_size_0 -
          log_v_s_largest1a_of_log_v_s_size_0_left,
      log_v_s_largest1a_of_log_v_s_size_0_right_rest = log_v_s_size_0_lo -
          log_v_s_largest1a_of_log_v_s_size_0_right,
      log_v_s_largest1a_of_log_v_s_size_0_lo = log_v_s_largest1a_of_log_v_s_size_0_left_rest +
          log_v_s_largest1a_of_log_v_s_size_0_right_rest,
      log_v_s_largest1a_of_log_v_s_size_1 = log_v_s_size_1 + log_v_s_size_1_lo,
      log_v_s_largest1a_of_log_v_s_size_1_right = log_v_s_largest1a_of_log_v_s_size_1 -
          log_v_s_size_1,
      log_v_s_largest1a_of_log_v_s_size_1_left = log_v_s_largest1a_of_log_v_s_size_1 -
          log_v_s_largest1a_of_log_v_s_size_1_right,
      log_v_s_largest1a_of_log_v_s_size_1_left_rest = log_v_s_size_1 -
          log_v_s_largest1a_of_log_v_s_size_1_left,
      log_v_s_largest1a_of_log_v_s_size_1_right_rest = log_v_s_size_1_lo -
          log_v_s_largest1a_of_log_v_s_size_1_right,
      log_v_s_largest1a_of_log_v_s_size_1_lo = log_v_s_largest1a_of_log_v_s_size_1_left_rest +
          log_v_s_largest1a_of_log_v_s_size_1_right_rest,
      log_v_s_largest1 = log_v_s_largest1a_of_log_v_s_size_0 < log_v_s_largest1a_of_log_v_s_size_1 ?
          log_v_s_largest1a_of_log_v_s_size_1 : log_v_s_largest1a_of_log_v_s_size_0,
      log_v_s_largest1_lo = log_v_s_largest1a_of_log_v_s_size_0 <
          log_v_s_largest1a_of_log_v_s_size_1 ? log_v_s_largest1a_of_log_v_s_size_1_lo :
          log_v_s_largest1a_of_log_v_s_size_0_lo;
  const double log_v_s_largest2a_of_log_v_s_largest1 = log_v_s_largest1 + log_v_s_largest1_lo,
      log_v_s_largest2a_of_log_v_s_largest1_right = log_v_s_largest2a_of_log_v_s_largest1 -
          log_v_s_largest1,
      log_v_s_largest2a_of_log_v_s_largest1_left = log_v_s_largest2a_of_log_v_s_largest1 -
          log_v_s_largest2a_of_log_v_s_largest1_right,
      log_v_s_largest2a_of_log_v_s_largest1_left_rest = log_v_s_largest1 -
          log_v_s_largest2a_of_log_v_s_largest1_left,
      log_v_s_largest2a_of_log_v_s_largest1_right_rest = log_v_s_largest1_lo -
          log_v_s_largest2a_of_log_v_s_largest1_right,
      log_v_s_largest2a_of_log_v_s_largest1_lo = log_v_s_largest2a_of_log_v_s_largest1_left_rest +
          log_v_s_largest2a_of_log_v_s_largest1_right_rest,
      log_v_s_largest2a_of_log_v_s_size_2 = log_v_s_size_2 + log_v_s_size_2_lo,
      log_v_s_largest2a_of_log_v_s_size_2_right = log_v_s_largest2a_of_log_v_s_size_2 -
          log_v_s_size_2,
      log_v_s_largest2a_of_log_v_s_size_2_left = log_v_s_largest2a_of_log_v_s_size_2 -
          log_v_s_largest2a_of_log_v_s_size_2_right,
      log_v_s_largest2a_of_log_v_s_size_2_left_rest = log_v_s_size_2 -
          log_v_s_largest2a_of_log_v_s_size_2_left,
      log_v_s_largest2a_of_log_v_s_size_2_right_rest = log_v_s_size_2_lo -
          log_v_s_largest2a_of_log_v_s_size_2_right,
      log_v_s_largest2a_of_log_v_s_size_2_lo = log_v_s_largest2a_of_log_v_s_size_2_left_rest +
          log_v_s_largest2a_of_log_v_s_size_2_right_rest,
      log_v_s_largest2 = log_v_s_largest2a_of_log_v_s_largest1 < log_v_s_largest2a_of_log_v_s_size_2
          ? log_v_s_largest2a_of_log_v_s_size_2 : log_v_s_largest2a_of_log_v_s_largest1,
      log_v_s_largest2_lo = log_v_s_largest2a_of_log_v_s_largest1 <
          log_v_s_largest2a_of_log_v_s_size_2 ? log_v_s_largest2a_of_log_v_s_size_2_lo :
          log_v_s_largest2a_of_log_v_s_largest1_lo;
  const double log_v_s_a_of_log_v_s_largest2 = log_v_s_largest2 + log_v_s_largest2_lo,
      log_v_s_b = 6.703903964971299e+153 < log_v_s_a_of_log_v_s_largest2 ? 3.7291703656001034e-155 :
          1.0,
      log_v_s_d = log_v_s_a_of_log_v_s_largest2 < 256.0 ? 1.3093562431584567e+151 : log_v_s_b,
      log_v_s = log_v_s_a_of_log_v_s_largest2 < 1.955159272639747e-149 ? 1.0715086071862673e+301 :
          log_v_s_d;
  const double log_v_y_0 = KSL_MUL(log_v_s_size_0_of_log_upper_0, log_v_s),
      log_v_y_0_inverse = 1.0 / log_v_s, log_v_y_0_back = KSL_MUL(log_v_y_0, log_v_y_0_inverse),
      log_v_y_0_lost = log_v_s_size_0_of_log_upper_0 - log_v_y_0_back,
      log_v_y_0_rest = log_v_y_0_lost + log_v_s_size_0_of_log_upper_0_lo,
      log_v_y_0_lo = KSL_MUL(log_v_y_0_rest, log_v_s);
  const double log_v_y_1 = KSL_MUL(log_v_s_size_1_of_log_upper_1, log_v_s),
      log_v_y_1_back = KSL_MUL(log_v_y_1, log_v_y_0_inverse),
      log_v_y_1_lost = log_v_s_size_1_of_log_upper_1 - log_v_y_1_back,
      log_v_y_1_rest = log_v_y_1_lost + log_v_s_size_1_of_log_upper_1_lo,
      log_v_y_1_lo = KSL_MUL(log_v_y_1_rest, log_v_s);
  const double log_v_y_2 = KSL_MUL(log_v_s_size_2_of_log_upper_2, log_v_s),
      log_v_y_2_back = KSL_MUL(log_v_y_2, log_v_y_0_inverse),
      log_v_y_2_lost = log_v_s_size_2_of_log_upper_2 - log_v_y_2_back,
      log_v_y_2_rest = log_v_y_2_lost + log_v_s_size_2_of_log_upper_2_lo,
      log_v_y_2_lo = KSL_MUL(log_v_y_2_rest, log_v_s);
  const double log_v_n_a = KSL_MUL(log_v_y_0, log_v_y_0),
      log_v_n_a_cross1 = KSL_MUL(log_v_y_0_lo, log_v_y_0),
      log_v_n_a_cross2 = KSL_MUL(log_v_y_0, log_v_y_0_lo),
      log_v_n_a_cross = log_v_n_a_cross1 + log_v_n_a_cross2,
      log_v_n_b = KSL_MUL(log_v_y_1, log_v_y_1),
      log_v_n_b_cross1 = KSL_MUL(log_v_y_1_lo, log_v_y_1),
      log_v_n_b_cross2 = KSL_MUL(log_v_y_1, log_v_y_1_lo),
      log_v_n_b_cross = log_v_n_b_cross1 + log_v_n_b_cross2, log_v_n_c = log_v_n_a + log_v_n_b,
      log_v_n_c_right = log_v_n_c - log_v_n_a, log_v_n_c_left = log_v_n_c - log_v_n_c_right,
      log_v_n_c_left_rest = ksl_product_rest(log_v_y_0, log_v_y_0, log_v_n_a, log_v_n_c_left),
      log_v_n_c_right_rest = ksl_product_rest(log_v_y_1, log_v_y_1, log_v_n_b, log_v_n_c_right),
      log_v_n_c_cross = log_v_n_a_cross + log_v_n_b_cross,
      log_v_n_c_lo1 = log_v_n_c_left_rest + log_v_n_c_right_rest,
      log_v_n_c_lo = log_v_n_c_lo1 + log_v_n_c_cross, log_v_n_d = KSL_MUL(log_v_y_2, log_v_y_2),
      log_v_n_d_cross1 = KSL_MUL(log_v_y_2_lo, log_v_y_2),
      log_v_n_d_cross2 = KSL_MUL(log_v_y_2, log_v_y_2_lo),
      log_v_n_d_cross = log_v_n_d_cross1 + log_v_n_d_cross2, log_v_n_e = log_v_n_c + log_v_n_d,
      log_v_n_e_right = log_v_n_e - log_v_n_c, log_v_n_e_left = log_v_n_e - log_v_n_e_right,
      log_v_n_e_left_rest = log_v_n_c - log_v_n_e_left,
      log_v_n_e_right_rest = ksl_product_rest(log_v_y_2, log_v_y_2, log_v_n_d, log_v_n_e_right),
      log_v_n_e_lo1 = log_v_n_e_left_rest + log_v_n_e_right_rest,
      log_v_n_e_lo2 = log_v_n_e_lo1 + log_v_n_d_cross, log_v_n_e_lo = log_v_n_e_lo2 + log_v_n_c_lo,
      log_v_n_of_log_v_n_e = log_v_n_e + log_v_n_e_lo,
      log_v_n_of_log_v_n_e_right = log_v_n_of_log_v_n_e - log_v_n_e,
      log_v_n_of_log_v_n_e_left = log_v_n_of_log_v_n_e - log_v_n_of_log_v_n_e_right,
      log_v_n_of_log_v_n_e_left_rest = log_v_n_e - log_v_n_of_log_v_n_e_left,
      log_v_n_of_log_v_n_e_right_rest = log_v_n_e_lo - log_v_n_of_log_v_n_e_right,
      log_v_n_of_log_v_n_e_lo = log_v_n_of_log_v_n_e_left_rest + log_v_n_of_log_v_n_e_right_rest,
      log_v_n = sqrt(log_v_n_of_log_v_n_e), log_v_n_product = KSL_MUL(log_v_n, log_v_n),
      log_v_n_product_error = ksl_product_error(log_v_n, log_v_n, log_v_n_product),
      log_v_n_rest = log_v_n_of_log_v_n_e - log_v_n_product,
      log_v_n_exact = log_v_n_rest - log_v_n_product_error,
      log_v_n_residual = log_v_n_exact + log_v_n_of_log_v_n_e_lo, log_v_n_twice = log_v_n + log_v_n,
      log_v_n_divisor = log_v_n == 0.0 ? 1.0 : log_v_n_twice,
      log_v_n_lo = log_v_n_residual / log_v_n_divisor;
  const double log_v_r_b = log_v_s < 1.0 ? 2.6815615859885194e+154 : 1.0,
      log_v_r_d = 1.0 < log_v_s ? 7.637340908749012e-152 : log_v_r_b,
      log_v_r = 1.3093562431584567e+151 < log_v_s ? 9.332636185032189e-302 : log_v_r_d;
  const double log_n_of_log_v_n = log_v_n + log_v_n_lo,
      log_n_of_log_v_n_right = log_n_of_log_v_n - log_v_n,
      log_n_of_log_v_n_left = log_n_of_log_v_n - log_n_of_log_v_n_right,
      log_n_of_log_v_n_left_rest = log_v_n - log_n_of_log_v_n_left,
      log_n_of_log_v_n_right_rest = log_v_n_lo - log_n_of_log_v_n_right,
      log_n_of_log_v_n_lo = log_n_of_log_v_n_left_rest + log_n_of_log_v_n_right_rest,
      log_n = KSL_MUL(log_n_of_log_v_n, log_v_r), log_n_inverse = 1.0 / log_v_r,
      log_n_back = KSL_MUL(log_n, log_n_inverse), log_n_lost = log_n_of_log_v_n - log_n_back,
      log_n_rest = log_n_lost + log_n_of_log_v_n_lo, log_n_lo = KSL_MUL(log_n_rest, log_v_r);
  const double log_half_of_log_n = log_n + log_n_lo,
      log_half_of_log_n_right = log_half_of_log_n - log_n,
      log_half_of_log_n_left = log_half_of_log_n - log_half_of_log_n_right,
      log_half_of_log_n_left_rest = log_n - log_half_of_log_n_left,
      log_half_of_log_n_right_rest = log_n_lo - log_half_of_log_n_right,
      log_half_of_log_n_lo = log_half_of_log_n_left_rest + log_half_of_log_n_right_rest,
      log_half_of_log_upper_3 = log_upper_3 + log_upper_3_lo,
      log_half_of_log_upper_3_right = log_half_of_log_upper_3 - log_upper_3,
      log_half_of_log_upper_3_left = log_half_of_log_upper_3 - log_half_of_log_upper_3_right,
      log_half_of_log_upper_3_left_rest = log_upper_3 - log_half_of_log_upper_3_left,
      log_half_of_log_upper_3_right_rest = log_upper_3_lo - log_half_of_log_upper_3_right,
      log_half_of_log_upper_3_lo = log_half_of_log_upper_3_left_rest +
          log_half_of_log_upper_3_right_rest,
      log_half = ksl_atan2(log_half_of_log_n, log_half_of_log_upper_3),
      log_half_own_error = ksl_atan2_error(log_half_of_log_n, log_half_of_log_upper_3, log_half),
      log_half_size0 = fabs(log_half_of_log_n), log_half_size1 = fabs(log_half_of_log_upper_3),
      log_half_most = log_half_size0 < log_half_size1 ? log_half_size1 : log_half_size0,
      log_half_divisor = log_half_most == 0.0 ? 1.0 : log_half_most,
      log_half_part0 = log_half_of_log_n / log_half_divisor,
      log_half_part1 = log_half_of_log_upper_3 / log_half_divisor,
      log_half_cross1 = KSL_MUL(log_half_part1, log_half_of_log_n_lo),
      log_half_cross2 = KSL_MUL(log_half_part0, log_half_of_log_upper_3_lo),
      log_half_square1 = KSL_MUL(log_half_part1, log_half_part1),
      log_half_square2 = KSL_MUL(log_half_part0, log_half_part0),
      log_half_cross = log_half_cross1 - log_half_cross2,
      log_half_square = log_half_square1 + log_half_square2,
      log_half_divisor2 = KSL_MUL(log_half_divisor, log_half_square),
      log_half_safe = log_half_most == 0.0 ? 1.0 : log_half_divisor2,
      log_half_more = log_half_cross / log_half_safe,
      log_half_lo = log_half_own_error + log_half_more;
  const double log_divisor = log_half_of_log_n == 0.0 ? 1.0 : log_half_of_log_n,
      log_divisor_lo = log_half_of_log_n == 0.0 ? 0.0 : log_half_of_log_n_lo;
  const double log_theta = KSL_MUL(2.0, log_half), log_theta_cross2 = KSL_MUL(2.0, log_half_lo);
  const double log_k_of_log_theta = log_theta + log_theta_cross2,
      log_k_of_log_theta_right = log_k_of_log_theta - log_theta,
      log_k_of_log_theta_left = log_k_of_log_theta - log_k_of_log_theta_right,
      log_k_of_log_theta_left_rest = log_theta - log_k_of_log_theta_left,
      log_k_of_log_theta_right_rest = log_theta_cross2 - log_k_of_log_theta_right,
      log_k_of_log_theta_lo = log_k_of_log_theta_left_rest + log_k_of_log_theta_right_rest,
      log_k_of_log_divisor = log_divisor + log_divisor_lo,
      log_k_of_log_divisor_right = log_k_of_log_divisor - log_divisor,
      log_k_of_log_divisor_left = log_k_of_log_divisor - log_k_of_log_divisor_right,
      log_k_of_log_divisor_left_rest = log_divisor - log_k_of_log_divisor_left,
      log_k_of_log_divisor_right_rest = log_divisor_lo - log_k_of_log_divisor_right,
      log_k_of_log_divisor_lo = log_k_of_log_divisor_left_rest + log_k_of_log_divisor_right_rest,
      log_k = log_k_of_log_theta / log_k_of_log_divisor,
      log_k_product = KSL_MUL(log_k, log_k_of_log_divisor),
      log_k_product_error = ksl_product_error(log_k, log_k_of_log_divisor, log_k_product),
      log_k_rest = log_k_of_log_theta - log_k_product,
      log_k_exact = log_k_rest - log_k_product_error,
      log_k_numerator = log_k_exact + log_k_of_log_theta_lo,
      log_k_cross = KSL_MUL(log_k, log_k_of_log_divisor_lo),
      log_k_residual = log_k_numerator - log_k_cross,
      log_k_lo = log_k_residual / log_k_of_log_divisor;
  const double log_vector_0 = KSL_MUL(log_v_s_size_0_of_log_upper_0, log_k),
      log_vector_0_cross1 = KSL_MUL(log_v_s_size_0_of_log_upper_0_lo, log_k),
      log_vector_0_cross2 = KSL_MUL(log_v_s_size_0_of_log_upper_0, log_k_lo),
      log_vector_0_cross = log_vector_0_cross1 + log_vector_0_cross2;
  const double log_vector_1 = KSL_MUL(log_v_s_size_1_of_log_upper_1, log_k),
      log_vector_1_cross1 = KSL_MUL(log_v_s_size_1_of_log_upper_1_lo, log_k),
      log_vector_1_cross2 = KSL_MUL(log_v_s_size_1_of_log_upper_1, log_k_lo),
      log_vector_1_cross = log_vector_1_cross1 + log_vector_1_cross2;
  const double log_vector_2 = KSL_MUL(log_v_s_size_2_of_log_upper_2, log_k),
      log_vector_2_cross1 = KSL_MUL(log_v_s_size_2_of_log_upper_2_lo, log_k),
      log_vector_2_cross2 = KSL_MUL(log_v_s_size_2_of_log_upper_2, log_k_lo),
      log_vector_2_cross = log_vector_2_cross1 + log_vector_2_cross2;
  const double log_half_angle = KSL_MUL(0.5, log_k_of_log_theta),
      log_half_angle_cross2 = KSL_MUL(0.5, log_k_of_log_theta_lo);
  const double log_length_a = KSL_MUL(log_half_of_log_n, log_half_of_log_n),
      log_length_a_cross1 = KSL_MUL(log_half_of_log_n_lo, log_half_of_log_n),
      log_length_a_cross2 = KSL_MUL(log_half_of_log_n, log_half_of_log_n_lo),
      log_length_a_cross = log_length_a_cross1 + log_length_a_cross2,
      log_length_b = KSL_MUL(log_half_of_log_upper_3, log_half_of_log_upper_3),
      log_length_b_cross1 = KSL_MUL(log_half_of_log_upper_3_lo, log_half_of_log_upper_3),
      log_length_b_cross2 = KSL_MUL(log_half_of_log_upper_3, log_half_of_log_upper_3_lo),
      log_length_b_cross = log_length_b_cross1 + log_length_b_cross2,
      log_length_c = log_length_a + log_length_b, log_length_c_right = log_length_c - log_length_a,
      log_length_c_left = log_length_c - log_length_c_right,
      log_length_c_left_rest = ksl_product_rest(log_half_of_log_n, log_half_of_log_n, log_length_a,
          log_length_c_left),
      log_length_c_right_rest = ksl_product_rest(log_half_of_log_upper_3, log_half_of_log_upper_3,
          log_length_b, log_length_c_right),
      log_length_c_cross = log_length_a_cross + log_length_b_cross,
      log_length_c_lo1 = log_length_c_left_rest + log_length_c_right_rest,
      log_length_c_lo = log_length_c_lo1 + log_length_c_cross,
      log_length_of_log_length_c = log_length_c + log_length_c_lo,
      log_length_of_log_length_c_right = log_length_of_log_length_c - log_length_c,
      log_length_of_log_length_c_left = log_length_of_log_length_c -
          log_length_of_log_length_c_right,
      log_length_of_log_length_c_left_rest = log_length_c - log_length_of_log_length_c_left,
      log_length_of_log_length_c_right_rest = log_length_c_lo - log_length_of_log_length_c_right,
      log_length_of_log_length_c_lo = log_length_of_log_length_c_left_rest +
          log_length_of_log_length_c_right_rest,
      log_length = sqrt(log_length_of_log_length_c),
      log_length_product = KSL_MUL(log_length, log_length),
      log_length_product_error = ksl_product_error(log_length, log_length, log_length_product),
      log_length_rest = log_length_of_log_length_c - log_length_product,
      log_length_exact = log_length_rest - log_length_product_error,
      log_length_residual = log_length_exact + log_length_of_log_length_c_lo,
      log_length_twice = log_length + log_length,
      log_length_divisor = log_length == 0.0 ? 1.0 : log_length_twice,
      log_length_lo = log_length_residual / log_length_divisor;
  const double log_sine_of_log_length = log_length + log_length_lo,
      log_sine_of_log_length_right = log_sine_of_log_length - log_length,
      log_sine_of_log_length_left = log_sine_of_log_length - log_sine_of_log_length_right,
      log_sine_of_log_length_left_rest = log_length - log_sine_of_log_length_left,
      log_sine_of_log_length_right_rest = log_length_lo - log_sine_of_log_length_right,
      log_sine_of_log_length_lo = log_sine_of_log_length_left_rest +
          log_sine_of_log_length_right_rest,
      log_sine = log_half_of_log_n / log_sine_of_log_length,
      log_sine_product = KSL_MUL(log_sine, log_sine_of_log_length),
      log_sine_product_error = ksl_product_error(log_sine, log_sine_of_log_length,
          log_sine_product),
      log_sine_rest = log_half_of_log_n - log_sine_product,
      log_sine_exact = log_sine_rest - log_sine_product_error,
      log_sine_numerator = log_sine_exact + log_half_of_log_n_lo,
      log_sine_cross = KSL_MUL(log_sine, log_sine_of_log_length_lo),
      log_sine_residual = log_sine_numerator - log_sine_cross,
      log_sine_lo = log_sine_residual / log_sine_of_log_length;
  const double log_c = log_half_of_log_upper_3 / log_sine_of_log_length,
      log_c_product = KSL_MUL(log_c, log_sine_of_log_length),
      log_c_product_error = ksl_product_error(log_c, log_sine_of_log_length, log_c_product),
      log_c_rest = log_half_of_log_upper_3 - log_c_product,
      log_c_exact = log_c_rest - log_c_product_error,
      log_c_numerator = log_c_exact + log_half_of_log_upper_3_lo,
      log_c_cross = KSL_MUL(log_c, log_sine_of_log_length_lo),
      log_c_residual = log_c_numerator - log_c_cross,
      log_c_lo = log_c_residual / log_sine_of_log_length;
  const double log_y = KSL_MUL(log_half_angle, log_half_angle),
      log_y_cross1 = KSL_MUL(log_half_angle_cross2, log_half_angle),
      log_y_cross2 = KSL_MUL(log_half_angle, log_half_angle_cross2),
      log_y_cross = log_y_cross1 + log_y_cross2;
  const double log_sinc_divisor_a_of_log_half_angle = log_half_angle + log_half_angle_cross2,
      log_sinc_divisor_a_of_log_half_angle_right = log_sinc_divisor_a_of_log_half_angle -
          log_half_angle,
      log_sinc_divisor_a_of_log_half_angle_left = log_sinc_divisor_a_of_log_half_angle -
          log_sinc_divisor_a_of_log_half_angle_right,
      log_sinc_divisor_a_of_log_half_angle_left_rest = log_half_angle -
          log_sinc_divisor_a_of_log_half_angle_left,
      log_sinc_divisor_a_of_log_half_angle_right_rest = log_half_angle_cross2 -
          log_sinc_divisor_a_of_log_half_angle_right,
      log_sinc_divisor_a_of_log_half_angle_lo = log_sinc_divisor_a_of_log_half_angle_left_rest +
          log_sinc_divisor_a_of_log_half_angle_right_rest,
      log_sinc_divisor = log_sinc_divisor_a_of_log_half_angle < 1.4901161193847656e-08 ?
          1.4901161193847656e-08 : log_sinc_divisor_a_of_log_half_angle,
      log_sinc_divisor_lo = log_sinc_divisor_a_of_log_half_angle < 1.4901161193847656e-08 ? 0.0 :
          log_sinc_divisor_a_of_log_half_angle_lo;
  const double log_sinc_quotient_of_log_sine = log_sine + log_sine_lo,
      log_sinc_quotient_of_log_sine_right = log_sinc_quotient_of_log_sine - log_sine,
      log_sinc_quotient_of_log_sine_left = log_sinc_quotient_of_log_sine -
          log_sinc_quotient_of_log_sine_right,
      log_sinc_quotient_of_log_sine_left_rest = log_sine - log_sinc_quotient_of_log_sine_left,
      log_sinc_quotient_of_log_sine_right_rest = log_sine_lo - log_sinc_quotient_of_log_sine_right,
      log_sinc_quotient_of_log_sine_lo = log_sinc_quotient_of_log_sine_left_rest +
          log_sinc_quotient_of_log_sine_right_rest,
      log_sinc_quotient_of_log_sinc_divisor = log_sinc_divisor + log_sinc_divisor_lo,
      log_sinc_quotient_of_log_sinc_divisor_right = log_sinc_quotient_of_log_sinc_divisor -
          log_sinc_divisor,
      log_sinc_quotient_of_log_sinc_divisor_left = log_sinc_quotient_of_log_sinc_divisor -
          log_sinc_quotient_of_log_sinc_divisor_right,
      log_sinc_quotient_of_log_sinc_divisor_left_rest = log_sinc_divisor -
          log_sinc_quotient_of_log_sinc_divisor_left,
      log_sinc_quotient_of_log_sinc_divisor_right_rest = log_sinc_divisor_lo -
          log_sinc_quotient_of_log_sinc_divisor_right,
      log_sinc_quotient_of_log_sinc_divisor_lo = log_sinc_quotient_of_log_sinc_divisor_left_rest +
          log_sinc_quotient_of_log_sinc_divisor_right_rest,
      log_sinc_quotient = log_sinc_quotient_of_log_sine / log_sinc_quotient_of_log_sinc_divisor,
      log_sinc_quotient_product = KSL_MUL(log_sinc_quotient, log_sinc_quotient_of_log_sinc_divisor),
      log_sinc_quotient_product_error = ksl_product_error(log_sinc_quotient,
          log_sinc_quotient_of_log_sinc_divisor, log_sinc_quotient_product),
      log_sinc_quotient_rest = log_sinc_quotient_of_log_sine - log_sinc_quotient_product,
      log_sinc_quotient_exact = log_sinc_quotient_rest - log_sinc_quotient_product_error,
      log_sinc_quotient_numerator = log_sinc_quotient_exact + log_sinc_quotient_of_log_sine_lo,
      log_sinc_quotient_cross = KSL_MUL(log_sinc_quotient,
          log_sinc_quotient_of_log_sinc_divisor_lo),
      log_sinc_quotient_residual = log_sinc_quotient_numerator - log_sinc_quotient_cross,
      log_sinc_quotient_lo = log_sinc_quotient_residual / log_sinc_quotient_of_log_sinc_divisor;
  const double log_y_error = ksl_product_error(log_half_angle, log_half_angle, log_y),
      log_y_lo = log_y_error + log_y_cross, log_sinc_a = KSL_MUL(0.16666666666666666, log_y),
      log_sinc_a_cross1 = KSL_MUL(9.25185853854297e-18, log_y),
      log_sinc_a_cross2 = KSL_MUL(0.16666666666666666, log_y_lo),
      log_sinc_a_cross = log_sinc_a_cross1 + log_sinc_a_cross2, log_sinc_b = 1.0 - log_sinc_a,
      log_sinc_b_right = 1.0 - log_sinc_b, log_sinc_b_left = log_sinc_b + log_sinc_b_right,
      log_sinc_b_left_rest = 1.0 - log_sinc_b_left,
      log_sinc_b_right_rest = ksl_product_rest(0.16666666666666666, log_y, log_sinc_a,
          log_sinc_b_right),
      log_sinc_b_lo1 = log_sinc_b_left_rest - log_sinc_b_right_rest,
      log_sinc_b_lo = log_sinc_b_lo1 - log_sinc_a_cross,
      log_sinc = log_sinc_divisor_a_of_log_half_angle < 1.4901161193847656e-08 ? log_sinc_b :
          log_sinc_quotient,
      log_sinc_lo = log_sinc_divisor_a_of_log_half_angle < 1.4901161193847656e-08 ? log_sinc_b_lo :
          log_sinc_quotient_lo;
  const double log_series_phi_a = KSL_MUL(5.107725174524775e-32, log_y),
      log_series_phi_a_cross1 = KSL_MUL(4.7410392187559056e-48, log_y),
      log_series_phi_a_cross2 = KSL_MUL(5.107725174524775e-32, log_y_lo),
      log_series_phi_a_cross = log_series_phi_a_cross1 + log_series_phi_a_cross2,
      log_series_phi_b = 4.116826490666969e-29 - log_series_phi_a,
      log_series_phi_b_right = 4.116826490666969e-29 - log_series_phi_b,
      log_series_phi_b_left = log_series_phi_b + log_series_phi_b_right,
      log_series_phi_b_left_rest = 4.116826490666969e-29 - log_series_phi_b_left,
      log_series_phi_b_right_rest = ksl_product_rest(5.107725174524775e-32, log_y, log_series_phi_a,
          log_series_phi_b_right),
      log_series_phi_b_lo1 = log_series_phi_b_left_rest - log_series_phi_b_right_rest,
      log_series_phi_b_lo2 = log_series_phi_b_lo1 - log_series_phi_a_cross,
      log_series_phi_b_lo = log_series_phi_b_lo2 + -1.8714974010023092e-45,
      log_series_phi_c = KSL_MUL(log_y, log_series_phi_b),
      log_series_phi_c_cross1 = KSL_MUL(log_y_lo, log_series_phi_b),
      log_series_phi_c_cross2 = KSL_MUL(log_y, log_series_phi_b_lo),
      log_series_phi_c_cross = log_series_phi_c_cross1 + log_series_phi_c_cross2,
      log_series_phi_d = log_series_phi_c - 2.86531123750421e-26,
      log_series_phi_d_right = log_series_phi_c - log_series_phi_d,
      log_series_phi_d_left = log_series_phi_d + log_series_phi_d_right,
      log_series_phi_d_left_rest = ksl_product_rest(log_y, log_series_phi_b, log_series_phi_c,
          log_series_phi_d_left),
      log_series_phi_d_right_rest = 2.86531123750421e-26 - log_series_phi_d_right,
      log_series_phi_d_lo1 = log_series_phi_d_left_rest - log_series_phi_d_right_rest,
      log_series_phi_d_lo2 = log_series_phi_d_lo1 - 2.3296034284323186e-42,
      log_series_phi_d_lo = log_series_phi_d_lo2 + log_series_phi_c_cross,
      log_series_phi_e = KSL_MUL(log_y, log_series_phi_d),
      log_series_phi_e_cross1 = KSL_MUL(log_y_lo, log_series_phi_d),
      log_series_phi_e_cross2 = KSL_MUL(log_y, log_series_phi_d_lo),
      log_series_phi_e_cross = log_series_phi_e_cross1 + log_series_phi_e_cross2,
      log_series_phi_f = log_series_phi_e + 1.701994875077501e-23,
      log_series_phi_f_right = log_series_phi_f - log_series_phi_e,
      log_series_phi_f_left = log_series_phi_f - log_series_phi_f_right,
      log_series_phi_f_left_rest = ksl_product_rest(log_y, log_series_phi_d, log_series_phi_e,
          log_series_phi_f_left),
      log_series_phi_f_right_rest = 1.701994875077501e-23 - log_series_phi_f_right,
      log_series_phi_f_lo1 = log_series_phi_f_left_rest + log_series_phi_f_right_rest,
      log_series_phi_f_lo2 = log_series_phi_f_lo1 + 3.161967936521494e-40,
      log_series_phi_f_lo = log_series_phi_f_lo2 + log_series_phi_e_cross,
      log_series_phi_g = KSL_MUL(log_y, log_series_phi_f),
      log_series_phi_g_cross1 = KSL_MUL(log_y_lo, log_series_phi_f),
      log_series_phi_g_cross2 = KSL_MUL(log_y, log_series_phi_f_lo),
      log_series_phi_g_cross = log_series_phi_g_cross1 + log_series_phi_g_cross2,
      log_series_phi_h = log_series_phi_g - 8.509974375387505e-21,
      log_series_phi_h_right = log_series_phi_g - log_series_phi_h,
      log_series_phi_h_left = log_series_phi_h + log_series_phi_h_right,
      log_series_phi_h_left_rest = ksl_product_rest(log_y, log_series_phi_f, log_series_phi_g,
          log_series_phi_h_left),
      log_series_phi_h_right_rest = 8.509974375387505e-21 - log_series_phi_h_right,
      log_series_phi_h_lo1 = log_series_phi_h_left_rest - log_series_phi_h_right_rest,
      log_series_phi_h_lo2 = log_series_phi_h_lo1 - 3.2266760594119493e-37,
      log_series_phi_h_lo = log_series_phi_h_lo2 + log_series_phi_g_cross,
      log_series_phi_i = KSL_MUL(log_y, log_series_phi_h),
      log_series_phi_i_cross1 = KSL_MUL(log_y_lo, log_series_phi_h),
      log_series_phi_i_cross2 = KSL_MUL(log_y, log_series_phi_h_lo),
      log_series_phi_i_cross = log_series_phi_i_cross1 + log_series_phi_i_cross2,
      log_series_phi_j = log_series_phi_i + 3.523129391410427e-18,
      log_series_phi_j_right = log_series_phi_j - log_series_phi_i,
      log_series_phi_j_left = log_series_phi_j - log_series_phi_j_right,
      log_series_phi_j_left_rest = ksl_product_rest(log_y, log_series_phi_h, log_series_phi_i,
          log_series_phi_j_left),
      log_series_phi_j_right_rest = 3.523129391410427e-18 - log_series_phi_j_right,
      log_series_phi_j_lo1 = log_series_phi_j_left_rest + log_series_phi_j_right_rest,
      log_series_phi_j_lo2 = log_series_phi_j_lo1 + -1.2521244741738012e-34,
      log_series_phi_j_lo = log_series_phi_j_lo2 + log_series_phi_i_cross,
      log_series_phi_k = KSL_MUL(log_y, log_series_phi_j),
      log_series_phi_k_cross1 = KSL_MUL(log_y_lo, log_series_phi_j),
      log_series_phi_k_cross2 = KSL_MUL(log_y, log_series_phi_j_lo),
      log_series_phi_k_cross = log_series_phi_k_cross1 + log_series_phi_k_cross2,
      log_series_phi_l = log_series_phi_k - 1.1837714755139035e-15,
      log_series_phi_l_right = log_series_phi_k - log_series_phi_l,
      log_series_phi_l_left = log_series_phi_l + log_series_phi_l_right,
      log_series_phi_l_left_rest = ksl_product_rest(log_y, log_series_phi_j, log_series_phi_k,
          log_series_phi_l_left),
      log_series_phi_l_right_rest = 1.1837714755139035e-15 - log_series_phi_l_right,
      log_series_phi_l_lo1 = log_series_phi_l_left_rest - log_series_phi_l_right_rest,
      log_series_phi_l_lo2 = log_series_phi_l_lo1 - 7.23242424407352e-33,
      log_series_phi_l_lo = log_series_phi_l_lo2 + log_series_phi_k_cross,
      log_series_phi_m = KSL_MUL(log_y, log_series_phi_l),
      log_series_phi_m_cross1 = KSL_MUL(log_y_lo, log_series_phi_l),
      log_series_phi_m_cross2 = KSL_MUL(log_y, log_series_phi_l_lo),
      log_series_phi_m_cross = log_series_phi_m_cross1 + log_series_phi_m_cross2,
      log_series_phi_n = log_series_phi_m + 3.148832124866983e-13,
      log_series_phi_n_right = log_series_phi_n - log_series_phi_m,
      log_series_phi_n_left = log_series_phi_n - log_series_phi_n_right,
      log_series_phi_n_left_rest = ksl_product_rest(log_y, log_series_phi_l, log_series_phi_m,
          log_series_phi_n_left),
      log_series_phi_n_right_rest = 3.148832124866983e-13 - log_series_phi_n_right,
      log_series_phi_n_lo1 = log_series_phi_n_left_rest + log_series_phi_n_right_rest,
      log_series_phi_n_lo2 = log_series_phi_n_lo1 + 5.8681293750286156e-30,
      log_series_phi_n_lo = log_series_phi_n_lo2 + log_series_phi_m_cross,
      log_series_phi_o = KSL_MUL(log_y, log_series_phi_n),
      log_series_phi_o_cross1 = KSL_MUL(log_y_lo, log_series_phi_n),
      log_series_phi_o_cross2 = KSL_MUL(log_y, log_series_phi_n_lo),
      log_series_phi_o_cross = log_series_phi_o_cross1 + log_series_phi_o_cross2,
      log_series_phi_p = log_series_phi_o - 6.423617534728645e-11,
      log_series_phi_p_right = log_series_phi_o - log_series_phi_p,
      log_series_phi_p_left = log_series_phi_p + log_series_phi_p_right,
      log_series_phi_p_left_rest = ksl_product_rest(log_y, log_series_phi_n, log_series_phi_o,
          log_series_phi_p_left),
      log_series_phi_p_right_rest = 6.423617534728645e-11 - log_series_phi_p_right,
      log_series_phi_p_lo1 = log_series_phi_p_left_rest - log_series_phi_p_right_rest,
      log_series_phi_p_lo2 = log_series_phi_p_lo1 - 5.034117835500839e-27,
      log_series_phi_p_lo = log_series_phi_p_lo2 + log_series_phi_o_cross,
      log_series_phi_q = KSL_MUL(log_y, log_series_phi_p),
      log_series_phi_q_cross1 = KSL_MUL(log_y_lo, log_series_phi_p),
      log_series_phi_q_cross2 = KSL_MUL(log_y, log_series_phi_p_lo),
      log_series_phi_q_cross = log_series_phi_q_cross1 + log_series_phi_q_cross2,
      log_series_phi_r = log_series_phi_q + 9.635426302092969e-09,
      log_series_phi_r_right = log_series_phi_r - log_series_phi_q,
      log_series_phi_r_left = log_series_phi_r - log_series_phi_r_right,
      log_series_phi_r_left_rest = ksl_product_rest(log_y, log_series_phi_p, log_series_phi_q,
          log_series_phi_r_left),
      log_series_phi_r_right_rest = 9.635426302092969e-09 - log_series_phi_r_right,
      log_series_phi_r_lo1 = log_series_phi_r_left_rest + log_series_phi_r_right_rest,
      log_series_phi_r_lo2 = log_series_phi_r_lo1 + -1.7546051379703029e-25,
      log_series_phi_r_lo = log_series_phi_r_lo2 + log_series_phi_q_cross,
      log_series_phi_s = KSL_MUL(log_y, log_series_phi_r),
      log_series_phi_s_cross1 = KSL_MUL(log_y_lo, log_series_phi_r),
      log_series_phi_s_cross2 = KSL_MUL(log_y, log_series_phi_r_lo),
      log_series_phi_s_cross = log_series_phi_s_cross1 + log_series_phi_s_cross2,
      log_series_phi_t = log_series_phi_s - 1.0020843354176687e-06,
      log_series_phi_t_right = log_series_phi_s - log_series_phi_t,
      log_series_phi_t_left = log_series_phi_t + log_series_phi_t_right,
      log_series_phi_t_left_rest = ksl_product_rest(log_y, log_series_phi_r, log_series_phi_s,
          log_series_phi_t_left),
      log_series_phi_t_right_rest = 1.0020843354176687e-06 - log_series_phi_t_right,
      log_series_phi_t_lo1 = log_series_phi_t_left_rest - log_series_phi_t_right_rest,
      log_series_phi_t_lo2 = log_series_phi_t_lo1 - 4.7926555569351065e-23,
      log_series_phi_t_lo = log_series_phi_t_lo2 + log_series_phi_s_cross,
      log_series_phi_u = KSL_MUL(log_y, log_series_phi_t),
      log_series_phi_u_cross1 = KSL_MUL(log_y_lo, log_series_phi_t),
      log_series_phi_u_cross2 = KSL_MUL(log_y, log_series_phi_t_lo),
      log_series_phi_u_cross = log_series_phi_u_cross1 + log_series_phi_u_cross2,
      log_series_phi_v = log_series_phi_u + 6.613756613756614e-05,
      log_series_phi_v_right = log_series_phi_v - log_series_phi_u,
      log_series_phi_v_left = log_series_phi_v - log_series_phi_v_right,
      log_series_phi_v_left_rest = ksl_product_rest(log_y, log_series_phi_t, log_series_phi_u,
          log_series_phi_v_left),
      log_series_phi_v_right_rest = 6.613756613756614e-05 - log_series_phi_v_right,
      log_series_phi_v_lo1 = log_series_phi_v_left_rest + log_series_phi_v_right_rest,
      log_series_phi_v_lo2 = log_series_phi_v_lo1 + -4.460143857711533e-21,
      log_series_phi_v_lo = log_series_phi_v_lo2 + log_series_phi_u_cross,
      log_series_phi_w = KSL_MUL(log_y, log_series_phi_v),
      log_series_phi_w_cross1 = KSL_MUL(log_y_lo, log_series_phi_v),
      log_series_phi_w_cross2 = KSL_MUL(log_y, log_series_phi_v_lo),
      log_series_phi_w_cross = log_series_phi_w_cross1 + log_series_phi_w_cross2,
      log_series_phi_x = log_series_phi_w - 0.002380952380952381,
      log_series_phi_x_right = log_series_phi_w - log_series_phi_x,
      log_series_phi_x_left = log_series_phi_x + log_series_phi_x_right,
      log_series_phi_x_left_rest = ksl_product_rest(log_y, log_series_phi_v, log_series_phi_w,
          log_series_phi_x_left),
      log_series_phi_x_right_rest = 0.002380952380952381 - log_series_phi_x_right,
      log_series_phi_x_lo1 = log_series_phi_x_left_rest - log_series_phi_x_right_rest,
      log_series_phi_x_lo2 = log_series_phi_x_lo1 - -2.147752875018904e-19,
      log_series_phi_x_lo = log_series_phi_x_lo2 + log_series_phi_w_cross,
      log_series_phi_y = KSL_MUL(log_y, log_series_phi_x),
      log_series_phi_y_cross1 = KSL_MUL(log_y_lo, log_series_phi_x),
      log_series_phi_y_cross2 = KSL_MUL(log_y, log_series_phi_x_lo),
      log_series_phi_y_cross = log_series_phi_y_cross1 + log_series_phi_y_cross2,
      log_series_phi = log_series_phi_y + 0.03333333333333333,
      log_series_phi_right = log_series_phi - log_series_phi_y,
      log_series_phi_left = log_series_phi - log_series_phi_right,
      log_series_phi_left_rest = ksl_product_rest(log_y, log_series_phi_x, log_series_phi_y,
          log_series_phi_left),
      log_series_phi_right_rest = 0.03333333333333333 - log_series_phi_right,
      log_series_phi_lo1 = log_series_phi_left_rest + log_series_phi_right_rest,
      log_series_phi_lo2 = log_series_phi_lo1 + 4.625929269271486e-19,
      log_series_phi_lo = log_series_phi_lo2 + log_series_phi_y_cross;
  const double log_f_more_a = KSL_MUL(2.0, log_y), log_f_more_a_cross2 = KSL_MUL(2.0, log_y_lo),
      log_f_more = KSL_MUL(log_f_more_a, log_series_phi),
      log_f_more_cross1 = KSL_MUL(log_f_more_a_cross2, log_series_phi),
      log_f_more_cross2 = KSL_MUL(log_f_more_a, log_series_phi_lo),
      log_f_more_cross = log_f_more_cross1 + log_f_more_cross2;
  const double log_near_f_a = KSL_MUL(0.3333333333333333, log_sinc),
      log_near_f_a_cross1 = KSL_MUL(1.850371707708594e-17, log_sinc),
      log_near_f_a_cross2 = KSL_MUL(0.3333333333333333, log_sinc_lo),
      log_near_f_a_cross = log_near_f_a_cross1 + log_near_f_a_cross2,
      log_f_more_error = ksl_product_error(log_f_more_a, log_series_phi, log_f_more),
      log_f_more_lo = log_f_more_error + log_f_more_cross,
      log_near_f_b = KSL_MUL(0.3333333333333333, log_f_more),
      log_near_f_b_cross1 = KSL_MUL(1.850371707708594e-17, log_f_more),
      log_near_f_b_cross2 = KSL_MUL(0.3333333333333333, log_f_more_lo),
      log_near_f_b_cross = log_near_f_b_cross1 + log_near_f_b_cross2,
      log_near_f = log_near_f_a + log_near_f_b, log_near_f_right = log_near_f - log_near_f_a,
      log_near_f_left = log_near_f - log_near_f_right,
      log_near_f_left_rest = ksl_product_rest(0.3333333333333333, log_sinc, log_near_f_a,
          log_near_f_left),
      log_near_f_right_rest = ksl_product_rest(0.3333333333333333, log_f_more, log_near_f_b,
          log_near_f_right),
      log_near_f_cross = log_near_f_a_cross + log_near_f_b_cross,
      log_near_f_lo1 = log_near_f_left_rest + log_near_f_right_rest,
      log_near_f_lo = log_near_f_lo1 + log_near_f_cross;
  const double log_f_rest = log_sinc - log_c, log_f_rest_right = log_sinc - log_f_rest,
      log_f_rest_left = log_f_rest + log_f_rest_right,
      log_f_rest_left_rest = log_sinc - log_f_rest_left,
      log_f_rest_right_rest = log_c - log_f_rest_right,
      log_f_rest_lo1 = log_f_rest_left_rest - log_f_rest_right_rest,
      log_f_rest_lo2 = log_f_rest_lo1 - log_c_lo, log_f_rest_lo = log_f_rest_lo2 + log_sinc_lo;
  const double log_x = KSL_MUL(4.0, log_y), log_x_cross2 = KSL_MUL(4.0, log_y_lo);
  const double log_far_y_a_of_log_x = log_x + log_x_cross2,
      log_far_y = log_far_y_a_of_log_x < 4.0 ? 1.0 : log_y,
      log_far_y_lo = log_far_y_a_of_log_x < 4.0 ? 0.0 : log_y_lo;
  const double log_closed_f_of_log_f_rest = log_f_rest + log_f_rest_lo,
      log_closed_f_of_log_f_rest_right = log_closed_f_of_log_f_rest - log_f_rest,
      log_closed_f_of_log_f_rest_left = log_closed_f_of_log_f_rest -
          log_closed_f_of_log_f_rest_right,
      log_closed_f_of_log_f_rest_left_rest = log_f_rest - log_closed_f_of_log_f_rest_left,
      log_closed_f_of_log_f_rest_right_rest = log_f_rest_lo - log_closed_f_of_log_f_rest_right,
      log_closed_f_of_log_f_rest_lo = log_closed_f_of_log_f_rest_left_rest +
          log_closed_f_of_log_f_rest_right_rest,
      log_closed_f_of_log_far_y = log_far_y + log_far_y_lo,
      log_closed_f_of_log_far_y_right = log_closed_f_of_log_far_y - log_far_y,
      log_closed_f_of_log_far_y_left = log_closed_f_of_log_far_y - log_closed_f_of_log_far_y_right,
      log_closed_f_of_log_far_y_left_rest = log_far_y - log_closed_f_of_log_far_y_left,
      log_closed_f_of_log_far_y_right_rest = log_far_y_lo - log_closed_f_of_log_far_y_right,
      log_closed_f_of_log_far_y_lo = log_closed_f_of_log_far_y_left_rest +
          log_closed_f_of_log_far_y_right_rest,
      log_closed_f = log_closed_f_of_log_f_rest / log_closed_f_of_log_far_y,
      log_closed_f_product = KSL_MUL(log_closed_f, log_closed_f_of_log_far_y),
      log_closed_f_product_error = ksl_product_error(log_closed_f, log_closed_f_of_log_far_y,
          log_closed_f_product),
      log_closed_f_rest = log_closed_f_of_log_f_rest - log_closed_f_product,
      log_closed_f_exact = log_closed_f_rest - log_closed_f_product_error,
      log_closed_f_numerator = log_closed_f_exact + log_closed_f_of_log_f_rest_lo,
      log_closed_f_cross = KSL_MUL(log_closed_f, log_closed_f_of_log_far_y_lo),
      log_closed_f_residual = log_closed_f_numerator - log_closed_f_cross,
      log_closed_f_lo = log_closed_f_residual / log_closed_f_of_log_far_y;
  const double log_f = log_far_y_a_of_log_x < 4.0 ? log_near_f : log_closed_f,
      log_f_lo = log_far_y_a_of_log_x < 4.0 ? log_near_f_lo : log_closed_f_lo;
  const double log_four_k = KSL_MUL(4.0, log_sinc), log_four_k_cross2 = KSL_MUL(4.0, log_sinc_lo);
  const double log_b_of_log_f = log_f + log_f_lo, log_b_of_log_f_right = log_b_of_log_f - log_f,
      log_b_of_log_f_left = log_b_of_log_f - log_b_of_log_f_right,
      log_b_of_log_f_left_rest = log_f - log_b_of_log_f_left,
      log_b_of_log_f_right_rest = log_f_lo - log_b_of_log_f_right,
      log_b_of_log_f_lo = log_b_of_log_f_left_rest + log_b_of_log_f_right_rest,
      log_b_of_log_four_k = log_four_k + log_four_k_cross2,
      log_b_of_log_four_k_right = log_b_of_log_four_k - log_four_k,
      log_b_of_log_four_k_left = log_b_of_log_four_k - log_b_of_log_four_k_right,
      log_b_of_log_four_k_left_rest = log_four_k - log_b_of_log_four_k_left,
      log_b_of_log_four_k_right_rest = log_four_k_cross2 - log_b_of_log_four_k_right,
      log_b_of_log_four_k_lo = log_b_of_log_four_k_left_rest + log_b_of_log_four_k_right_rest,
      log_b = log_b_of_log_f / log_b_of_log_four_k,
      log_b_product = KSL_MUL(log_b, log_b_of_log_four_k),
      log_b_product_error = ksl_product_error(log_b, log_b_of_log_four_k, log_b_product),
      log_b_rest = log_b_of_log_f - log_b_product, log_b_exact = log_b_rest - log_b_product_error,
      log_b_numerator = log_b_exact + log_b_of_log_f_lo,
      log_b_cross = KSL_MUL(log_b, log_b_of_log_four_k_lo),
      log_b_residual = log_b_numerator - log_b_cross,
      log_b_lo = log_b_residual / log_b_of_log_four_k;
  const double log_b_across_of_log_c = log_c + log_c_lo,
      log_b_across_of_log_c_right = log_b_across_of_log_c - log_c,
      log_b_across_of_log_c_left = log_b_across_of_log_c - log_b_across_of_log_c_right,
      log_b_across_of_log_c_left_rest = log_c - log_b_across_of_log_c_left,
      log_b_across_of_log_c_right_rest = log_c_lo - log_b_across_of_log_c_right,
      log_b_across_of_log_c_lo = log_b_across_of_log_c_left_rest + log_b_across_of_log_c_right_rest,
      log_b_across_of_log_sinc = log_sinc + log_sinc_lo,
      log_b_across_of_log_sinc_right = log_b_across_of_log_sinc - log_sinc,
      log_b_across_of_log_sinc_left = log_b_across_of_log_sinc - log_b_across_of_log_sinc_right,
      log_b_across_of_log_sinc_left_rest = log_sinc - log_b_across_of_log_sinc_left,
      log_b_across_of_log_sinc_right_rest = log_sinc_lo - log_b_across_of_log_sinc_right,
      log_b_across_of_log_sinc_lo = log_b_across_of_log_sinc_left_rest +
          log_b_across_of_log_sinc_right_rest,
      log_b_across = log_b_across_of_log_c / log_b_across_of_log_sinc,
      log_b_across_product = KSL_MUL(log_b_across, log_b_across_of_log_sinc),
      log_b_across_product_error = ksl_product_error(log_b_across, log_b_across_of_log_sinc,
          log_b_across_product),
      log_b_across_rest = log_b_across_of_log_c - log_b_across_product,
      log_b_across_exact = log_b_across_rest - log_b_across_product_error,
      log_b_across_numerator = log_b_across_exact + log_b_across_of_log_c_lo,
      log_b_across_cross = KSL_MUL(log_b_across, log_b_across_of_log_sinc_lo),
      log_b_across_residual = log_b_across_numerator - log_b_across_cross,
      log_b_across_lo = log_b_across_residual / log_b_across_of_log_sinc;
  const double log_vector_0_error = ksl_product_error(log_v_s_size_0_of_log_upper_0, log_k,
      log_vector_0),
      log_vector_0_lo = log_vector_0_error + log_vector_0_cross,
      log_wt_a = KSL_MUL(between_3, log_vector_0),
      log_wt_a_cross1 = KSL_MUL(between_3_lo, log_vector_0),
      log_wt_a_cross2 = KSL_MUL(between_3, log_vector_0_lo),
      log_wt_a_cross = log_wt_a_cross1 + log_wt_a_cross2,
      log_vector_1_error = ksl_product_error(log_v_s_size_1_of_log_upper_1, log_k, log_vector_1),
      log_vector_1_lo = log_vector_1_error + log_vector_1_cross,
      log_wt_b = KSL_MUL(between_7, log_vector_1),
      log_wt_b_cross1 = KSL_MUL(between_7_lo, log_vector_1),
      log_wt_b_cross2 = KSL_MUL(between_7, log_vector_1_lo),
      log_wt_b_cross = log_wt_b_cross1 + log_wt_b_cross2, log_wt_c = log_wt_a + log_wt_b,
      log_wt_c_right = log_wt_c - log_wt_a, log_wt_c_left = log_wt_c - log_wt_c_right,
      log_wt_c_left_rest = ksl_product_rest(between_3, log_vector_0, log_wt_a, log_wt_c_left),
      log_wt_c_right_rest = ksl_product_rest(between_7, log_vector_1, log_wt_b, log_wt_c_right),
      log_wt_c_cross = log_wt_a_cross + log_wt_b_cross,
      log_wt_c_lo1 = log_wt_c_left_rest + log_wt_c_right_rest,
      log_wt_c_lo = log_wt_c_lo1 + log_wt_c_cross,
      log_vector_2_error = ksl_product_error(log_v_s_size_2_of_log_upper_2, log_k, log_vector_2),
      log_vector_2_lo = log_vector_2_error + log_vector_2_cross,
      log_wt_d = KSL_MUL(between_11, log_vector_2),
      log_wt_d_cross1 = KSL_MUL(between_11_lo, log_vector_2),
      log_wt_d_cross2 = KSL_MUL(between_11, log_vector_2_lo),
      log_wt_d_cross = log_wt_d_cross1 + log_wt_d_cross2, log_wt = log_wt_c + log_wt_d,
      log_wt_right = log_wt - log_wt_c, log_wt_left = log_wt - log_wt_right,
      log_wt_left_rest = log_wt_c - log_wt_left,
      log_wt_right_rest = ksl_product_rest(between_11, log_vector_2, log_wt_d, log_wt_right),
      log_wt_lo1 = log_wt_left_rest + log_wt_right_rest, log_wt_lo2 = log_wt_lo1 + log_wt_d_cross,
      log_wt_lo = log_wt_lo2 + log_wt_c_lo;
  const double log_pitch = KSL_MUL(log_b, log_wt), log_pitch_cross1 = KSL_MUL(log_b_lo, log_wt),
      log_pitch_cross2 = KSL_MUL(log_b, log_wt_lo),
      log_pitch_cross = log_pitch_cross1 + log_pitch_cross2;
  const double log_pitch_error = ksl_product_error(log_b, log_wt, log_pitch),
      log_pitch_lo = log_pitch_error + log_pitch_cross,
      log_along_0 = KSL_MUL(log_vector_0, log_pitch),
      log_along_0_cross1 = KSL_MUL(log_vector_0_lo, log_pitch),
      log_along_0_cross2 = KSL_MUL(log_vector_0, log_pitch_lo),
      log_along_0_cross = log_along_0_cross1 + log_along_0_cross2;
  const double log_along_1 = KSL_MUL(log_vector_1, log_pitch),
      log_along_1_cross1 = KSL_MUL(log_vector_1_lo, log_pitch),
      log_along_1_cross2 = KSL_MUL(log_vector_1, log_pitch_lo),
      log_along_1_cross = log_along_1_cross1 + log_along_1_cross2;
  const double log_along_2 = KSL_MUL(log_vector_2, log_pitch),
      log_along_2_cross1 = KSL_MUL(log_vector_2_lo, log_pitch),
      log_along_2_cross2 = KSL_MUL(log_vector_2, log_pitch_lo),
      log_along_2_cross = log_along_2_cross1 + log_along_2_cross2;
  const double log_u_0a = KSL_MUL(between_11, log_vector_1),
      log_u_0a_cross1 = KSL_MUL(between_11_lo, log_vector_1),
      log_u_0a_cross2 = KSL_MUL(between_11, log_vector_1_lo),
      log_u_0a_cross = log_u_0a_cross1 + log_u_0a_cross2,
      log_u_0b = KSL_MUL(between_7, log_vector_2),
      log_u_0b_cross1 = KSL_MUL(between_7_lo, log_vector_2),
      log_u_0b_cross2 = KSL_MUL(between_7, log_vector_2_lo),
      log_u_0b_cross = log_u_0b_cross1 + log_u_0b_cross2, log_u_0 = log_u_0a - log_u_0b,
      log_u_0_right = log_u_0a - log_u_0, log_u_0_left = log_u_0 + log_u_0_right,
      log_u_0_left_rest = ksl_product_rest(between_11, log_vector_1, log_u_0a, log_u_0_left),
      log_u_0_right_rest = ksl_product_rest(between_7, log_vector_2, log_u_0b, log_u_0_right),
      log_u_0_cross = log_u_0a_cross - log_u_0b_cross,
      log_u_0_lo1 = log_u_0_left_rest - log_u_0_right_rest,
      log_u_0_lo = log_u_0_lo1 + log_u_0_cross;
  const double log_u_1a = KSL_MUL(between_3, log_vector_2),
      log_u_1a_cross1 = KSL_MUL(between_3_lo, log_vector_2),
      log_u_1a_cross2 = KSL_MUL(between_3, log_vector_2_lo),
      log_u_1a_cross = log_u_1a_cross1 + log_u_1a_cross2,
      log_u_1b = KSL_MUL(between_11, log_vector_0),
      log_u_1b_cross1 = KSL_MUL(between_11_lo, log_vector_0),
      log_u_1b_cross2 = KSL_MUL(between_11, log_vector_0_lo),
      log_u_1b_cross = log_u_1b_cross1 + log_u_1b_cross2, log_u_1 = log_u_1a - log_u_1b,
      log_u_1_right = log_u_1a - log_u_1, log_u_1_left = log_u_1 + log_u_1_right,
      log_u_1_left_rest = ksl_product_rest(between_3, log_vector_2, log_u_1a, log_u_1_left),
      log_u_1_right_rest = ksl_product_rest(between_11, log_vector_0, log_u_1b, log_u_1_right),
      log_u_1_cross = log_u_1a_cross - log_u_1b_cross,
      log_u_1_lo1 = log_u_1_left_rest - log_u_1_right_rest,
      log_u_1_lo = log_u_1_lo1 + log_u_1_cross;
  const double log_u_2a = KSL_MUL(between_7, log_vector_0),
      log_u_2a_cross1 = KSL_MUL(between_7_lo, log_vector_0),
      log_u_2a_cross2 = KSL_MUL(between_7, log_vector_0_lo),
      log_u_2a_cross = log_u_2a_cross1 + log_u_2a_cross2,
      log_u_2b = KSL_MUL(between_3, log_vector_1),
      log_u_2b_cross1 = KSL_MUL(between_3_lo, log_vector_1),
      log_u_2b_cross2 = KSL_MUL(between_3, log_vector_1_lo),
      log_u_2b_cross = log_u_2b_cross1 + log_u_2b_cross2, log_u_2 = log_u_2a - log_u_2b,
      log_u_2_right = log_u_2a - log_u_2, log_u_2_left = log_u_2 + log_u_2_right,
      log_u_2_left_rest = ksl_product_rest(between_7, log_vector_0, log_u_2a, log_u_2_left),
      log_u_2_right_rest = ksl_product_rest(between_3, log_vector_1, log_u_2b, log_u_2_right),
      log_u_2_cross = log_u_2a_cross - log_u_2b_cross,
      log_u_2_lo1 = log_u_2_left_rest - log_u_2_right_rest,
      log_u_2_lo = log_u_2_lo1 + log_u_2_cross;
  const double log_turned_0 = KSL_MUL(0.5, log_u_0), log_turned_0_cross2 = KSL_MUL(0.5, log_u_0_lo);
  const double log_turned_1 = KSL_MUL(0.5, log_u_1), log_turned_1_cross2 = KSL_MUL(0.5, log_u_1_lo);
  const double log_turned_2 = KSL_MUL(0.5, log_u_2), log_turned_2_cross2 = KSL_MUL(0.5, log_u_2_lo);
  const double log_across_axis_0 = log_along_0 - log_turned_0,
      log_across_axis_0_right = log_along_0 - log_across_axis_0,
      log_across_axis_0_left = log_across_axis_0 + log_across_axis_0_right,
      log_across_axis_0_left_rest = ksl_product_rest(log_vector_0, log_pitch, log_along_0,
          log_across_axis_0_left),
      log_across_axis_0_right_rest = log_turned_0 - log_across_axis_0_right,
      log_across_axis_0_lo1 = log_across_axis_0_left_rest - log_across_axis_0_right_rest,
      log_across_axis_0_lo2 = log_across_axis_0_lo1 - log_turned_0_cross2,
      log_across_axis_0_lo = log_across_axis_0_lo2 + log_along_0_cross;
  const double log_across_axis_1 = log_along_1 - log_turned_1,
      log_across_axis_1_right = log_along_1 - log_across_axis_1,
      log_across_axis_1_left = log_across_axis_1 + log_across_axis_1_right,
      log_across_axis_1_left_rest = ksl_product_rest(log_vector_1, log_pitch, log_along_1,
          log_across_axis_1_left),
      log_across_axis_1_right_rest = log_turned_1 - log_across_axis_1_right,
      log_across_axis_1_lo1 = log_across_axis_1_left_rest - log_across_axis_1_right_rest,
      log_across_axis_1_lo2 = log_across_axis_1_lo1 - log_turned_1_cross2,
      log_across_axis_1_lo = log_across_axis_1_lo2 + log_along_1_cross;
  const double log_across_axis_2 = log_along_2 - log_turned_2,
      log_across_axis_2_right = log_along_2 - log_across_axis_2,
      log_across_axis_2_left = log_across_axis_2 + log_across_axis_2_right,
      log_across_axis_2_left_rest = ksl_product_rest(log_vector_2, log_pitch, log_along_2,
          log_across_axis_2_left),
      log_across_axis_2_right_rest = log_turned_2 - log_across_axis_2_right,
      log_across_axis_2_lo1 = log_across_axis_2_left_rest - log_across_axis_2_right_rest,
      log_across_axis_2_lo2 = log_across_axis_2_lo1 - log_turned_2_cross2,
      log_across_axis_2_lo = log_across_axis_2_lo2 + log_along_2_cross;
  const double whole_0a = KSL_MUL(between_3, log_b_across),
      whole_0a_cross1 = KSL_MUL(between_3_lo, log_b_across),
      whole_0a_cross2 = KSL_MUL(between_3, log_b_across_lo),
      whole_0a_cross = whole_0a_cross1 + whole_0a_cross2, whole_0 = whole_0a + log_across_axis_0,
      whole_0_right = whole_0 - whole_0a, whole_0_left = whole_0 - whole_0_right,
      whole_0_left_rest = ksl_product_rest(between_3, log_b_across, whole_0a, whole_0_left),
      whole_0_right_rest = log_across_axis_0 - whole_0_right,
      whole_0_lo1 = whole_0_left_rest + whole_0_right_rest,
      whole_0_lo2 = whole_0_lo1 + log_across_axis_0_lo, whole_0_lo = whole_0_lo2 + whole_0a_cross;
  const double whole_1a = KSL_MUL(between_7, log_b_across),
      whole_1a_cross1 = KSL_MUL(between_7_lo, log_b_across),
      whole_1a_cross2 = KSL_MUL(between_7, log_b_across_lo),
      whole_1a_cross = whole_1a_cross1 + whole_1a_cross2, whole_1 = whole_1a + log_across_axis_1,
      whole_1_right = whole_1 - whole_1a, whole_1_left = whole_1 - whole_1_right,
      whole_1_left_rest = ksl_product_rest(between_7, log_b_across, whole_1a, whole_1_left),
      whole_1_right_rest = log_across_axis_1 - whole_1_right,
      whole_1_lo1 = whole_1_left_rest + whole_1_right_rest,
      whole_1_lo2 = whole_1_lo1 + log_across_axis_1_lo, whole_1_lo = whole_1_lo2 + whole_1a_cross;
  const double whole_2a = KSL_MUL(between_11, log_b_across),
      whole_2a_cross1 = KSL_MUL(between_11_lo, log_b_across),
      whole_2a_cross2 = KSL_MUL(between_11, log_b_across_lo),
      whole_2a_cross = whole_2a_cross1 + whole_2a_cross2, whole_2 = whole_2a + log_across_axis_2,
      whole_2_right = whole_2 - whole_2a, whole_2_left = whole_2 - whole_2_right,
      whole_2_left_rest = ksl_product_rest(between_11, log_b_across, whole_2a, whole_2_left),
      whole_2_right_rest = log_across_axis_2 - whole_2_right,
      whole_2_lo1 = whole_2_left_rest + whole_2_right_rest,
      whole_2_lo2 = whole_2_lo1 + log_across_axis_2_lo, whole_2_lo = whole_2_lo2 + whole_2a_cross;
  const double screw_0 = KSL_MUL(k, whole_0), screw_0_cross2 = KSL_MUL(k, whole_0_lo);
  const double screw_1 = KSL_MUL(k, whole_1), screw_1_cross2 = KSL_MUL(k, whole_1_lo);
  const double screw_2 = KSL_MUL(k, whole_2), screw_2_cross2 = KSL_MUL(k, whole_2_lo);
  const double screw_3 = KSL_MUL(k, log_vector_0), screw_3_cross2 = KSL_MUL(k, log_vector_0_lo);
  const double screw_4 = KSL_MUL(k, log_vector_1), screw_4_cross2 = KSL_MUL(k, log_vector_1_lo);
  const double screw_5 = KSL_MUL(k, log_vector_2), screw_5_cross2 = KSL_MUL(k, log_vector_2_lo);
  const double screw_3_error = ksl_product_error(k, log_vector_0, screw_3),
      screw_3_lo = screw_3_error + screw_3_cross2, exp_halved_0 = KSL_MUL(0.5, screw_3),
      exp_halved_0_cross2 = KSL_MUL(0.5, screw_3_lo);
  const double screw_4_error = ksl_product_error(k, log_vector_1, screw_4),
      screw_4_lo = screw_4_error + screw_4_cross2, exp_halved_1 = KSL_MUL(0.5, screw_4),
      exp_halved_1_cross2 = KSL_MUL(0.5, screw_4_lo);
  const double screw_5_error = ksl_product_error(k, log_vector_2, screw_5),
      screw_5_lo = screw_5_error + screw_5_cross2, exp_halved_2 = KSL_MUL(0.5, screw_5),
      exp_halved_2_cross2 = KSL_MUL(0.5, screw_5_lo);
  const double exp_y_a = KSL_MUL(exp_halved_0, exp_halved_0),
      exp_y_a_cross1 = KSL_MUL(exp_halved_0_cross2, exp_halved_0),
      exp_y_a_cross2 = KSL_MUL(exp_halved_0, exp_halved_0_cross2),
      exp_y_a_cross = exp_y_a_cross1 + exp_y_a_cross2,
      exp_y_b = KSL_MUL(exp_halved_1, exp_halved_1),
      exp_y_b_cross1 = KSL_MUL(exp_halved_1_cross2, exp_halved_1),
      exp_y_b_cross2 = KSL_MUL(exp_halved_1, exp_halved_1_cross2),
      exp_y_b_cross = exp_y_b_cross1 + exp_y_b_cross2, exp_y_c = exp_y_a + exp_y_b,
      exp_y_c_right = exp_y_c - exp_y_a, exp_y_c_left = exp_y_c - exp_y_c_right,
      exp_y_c_left_rest = ksl_product_rest(exp_halved_0, exp_halved_0, exp_y_a, exp_y_c_left),
      exp_y_c_right_rest = ksl_product_rest(exp_halved_1, exp_halved_1, exp_y_b, exp_y_c_right),
      exp_y_c_cross = exp_y_a_cross + exp_y_b_cross,
      exp_y_c_lo1 = exp_y_c_left_rest + exp_y_c_right_rest,
      exp_y_c_lo = exp_y_c_lo1 + exp_y_c_cross, exp_y_d = KSL_MUL(exp_halved_2, exp_halved_2),
      exp_y_d_cross1 = KSL_MUL(exp_halved_2_cross2, exp_halved_2),
      exp_y_d_cross2 = KSL_MUL(exp_halved_2, exp_halved_2_cross2),
      exp_y_d_cross = exp_y_d_cross1 + exp_y_d_cross2, exp_y = exp_y_c + exp_y_d,
      exp_y_right = exp_y - exp_y_c, exp_y_left = exp_y - exp_y_right,
      exp_y_left_rest = exp_y_c - exp_y_left,
      exp_y_right_rest = ksl_product_rest(exp_halved_2, exp_halved_2, exp_y_d, exp_y_right),
      exp_y_lo1 = exp_y_left_rest + exp_y_right_rest, exp_y_lo2 = exp_y_lo1 + exp_y_d_cross,
      exp_y_lo = exp_y_lo2 + exp_y_c_lo;
  const double exp_half_angle_of_exp_y = exp_y + exp_y_lo,
      exp_half_angle_of_exp_y_right = exp_half_angle_of_exp_y - exp_y,
      exp_half_angle_of_exp_y_left = exp_half_angle_of_exp_y - exp_half_angle_of_exp_y_right,
      exp_half_angle_of_exp_y_left_rest = exp_y - exp_half_angle_of_exp_y_left,
      exp_half_angle_of_exp_y_right_rest = exp_y_lo - exp_half_angle_of_exp_y_right,
      exp_half_angle_of_exp_y_lo = exp_half_angle_of_exp_y_left_rest +
          exp_half_angle_of_exp_y_right_rest,
      exp_half_angle = sqrt(exp_half_angle_of_exp_y),
      exp_half_angle_product = KSL_MUL(exp_half_angle, exp_half_angle),
      exp_half_angle_product_error = ksl_product_error(exp_half_angle, exp_half_angle,
          exp_half_angle_product),
      exp_half_angle_rest = exp_half_angle_of_exp_y - exp_half_angle_product,
      exp_half_angle_exact = exp_half_angle_rest - exp_half_angle_product_error,
      exp_half_angle_residual = exp_half_angle_exact + exp_half_angle_of_exp_y_lo,
      exp_half_angle_twice = exp_half_angle + exp_half_angle,
      exp_half_angle_divisor = exp_half_angle == 0.0 ? 1.0 : exp_half_angle_twice,
      exp_half_angle_lo = exp_half_angle_residual / exp_half_angle_divisor;
  const double exp_sine_of_exp_half_angle = exp_half_angle + exp_half_angle_lo,
      exp_sine_of_exp_half_angle_right = exp_sine_of_exp_half_angle - exp_half_angle,
      exp_sine_of_exp_half_angle_left = exp_sine_of_exp_half_angle -
          exp_sine_of_exp_half_angle_right,
      exp_sine_of_exp_half_angle_left_rest = exp_half_angle - exp_sine_of_exp_half_angle_left,
      exp_sine_of_exp_half_angle_right_rest = exp_half_angle_lo - exp_sine_of_exp_half_angle_right,
      exp_sine_of_exp_half_angle_lo = exp_sine_of_exp_half_angle_left_rest +
          exp_sine_of_exp_half_angle_right_rest;
  double exp_c; const double exp_sine = ksl_sincos(exp_sine_of_exp_half_angle, &exp_c);
  double exp_c_own_error; const double exp_sine_own_error =
      ksl_sincos_error(exp_sine_of_exp_half_angle, exp_sine, exp_c, &exp_c_own_error);
  const double exp_sine_half = KSL_MUL(exp_sine_of_exp_half_angle_lo, 0.5);
  double exp_sine_half_cos; const double exp_sine_half_sin = ksl_sincos(exp_sine_half,
      &exp_sine_half_cos);
  const double exp_sine_twice = exp_sine_half_sin + exp_sine_half_sin,
      exp_sine_slope1 = KSL_MUL(exp_sine_half_cos, exp_c),
      exp_sine_slope2 = KSL_MUL(exp_sine_half_sin, exp_sine),
      exp_sine_slope = exp_sine_slope1 - exp_sine_slope2,
      exp_sine_more = KSL_MUL(exp_sine_slope, exp_sine_twice),
      exp_sine_lo = exp_sine_own_error + exp_sine_more;
  const double exp_c_slope1 = KSL_MUL(exp_sine_half_cos, exp_sine),
      exp_c_slope2 = KSL_MUL(exp_sine_half_sin, exp_c), exp_c_slope = exp_c_slope1 + exp_c_slope2,
      exp_c_more = KSL_MUL(exp_c_slope, exp_sine_twice), exp_c_lo = exp_c_own_error - exp_c_more;
  const double exp_sinc_divisor = exp_sine_of_exp_half_angle < 1.4901161193847656e-08 ?
      1.4901161193847656e-08 : exp_sine_of_exp_half_angle,
      exp_sinc_divisor_lo = exp_sine_of_exp_half_angle < 1.4901161193847656e-08 ? 0.0 :
          exp_sine_of_exp_half_angle_lo;
  const double exp_sinc_quotient_of_exp_sine = exp_sine + exp_sine_lo,
      exp_sinc_quotient_of_exp_sine_right = exp_sinc_quotient_of_exp_sine - exp_sine,
      exp_sinc_quotient_of_exp_sine_left = exp_sinc_quotient_of_exp_sine -
          exp_sinc_quotient_of_exp_sine_right,
      exp_sinc_quotient_of_exp_sine_left_rest = exp_sine - exp_sinc_quotient_of_exp_sine_left,
      exp_sinc_quotient_of_exp_sine_right_rest = exp_sine_lo - exp_sinc_quotient_of_exp_sine_right,
      exp_sinc_quotient_of_exp_sine_lo = exp_sinc_quotient_of_exp_sine_left_rest +
          exp_sinc_quotient_of_exp_sine_right_rest,
      exp_sinc_quotient_of_exp_sinc_divisor = exp_sinc_divisor + exp_sinc_divisor_lo,
      exp_sinc_quotient_of_exp_sinc_divisor_right = exp_sinc_quotient_of_exp_sinc_divisor -
          exp_sinc_divisor,
      exp_sinc_quotient_of_exp_sinc_divisor_left = exp_sinc_quotient_of_exp_sinc_divisor -
          exp_sinc_quotient_of_exp_sinc_divisor_right,
      exp_sinc_quotient_of_exp_sinc_divisor_left_rest = exp_sinc_divisor -
          exp_sinc_quotient_of_exp_sinc_divisor_left,
      exp_sinc_quotient_of_exp_sinc_divisor_right_rest = exp_sinc_divisor_lo -
          exp_sinc_quotient_of_exp_sinc_divisor_right,
      exp_sinc_quotient_of_exp_sinc_divisor_lo = exp_sinc_quotient_of_exp_sinc_divisor_left_rest +
          exp_sinc_quotient_of_exp_sinc_divisor_right_rest,
      exp_sinc_quotient = exp_sinc_quotient_of_exp_sine / exp_sinc_quotient_of_exp_sinc_divisor,
      exp_sinc_quotient_product = KSL_MUL(exp_sinc_quotient, exp_sinc_quotient_of_exp_sinc_divisor),
      exp_sinc_quotient_product_error = ksl_product_error(exp_sinc_quotient,
          exp_sinc_quotient_of_exp_sinc_divisor, exp_sinc_quotient_product),
      exp_sinc_quotient_rest = exp_sinc_quotient_of_exp_sine - exp_sinc_quotient_product,
      exp_sinc_quotient_exact = exp_sinc_quotient_rest - exp_sinc_quotient_product_error,
      exp_sinc_quotient_numerator = exp_sinc_quotient_exact + exp_sinc_quotient_of_exp_sine_lo,
      exp_sinc_quotient_cross = KSL_MUL(exp_sinc_quotient,
          exp_sinc_quotient_of_exp_sinc_divisor_lo),
      exp_sinc_quotient_residual = exp_sinc_quotient_numerator - exp_sinc_quotient_cross,
      exp_sinc_quotient_lo = exp_sinc_quotient_residual / exp_sinc_quotient_of_exp_sinc_divisor;
  const double exp_sinc_a = KSL_MUL(0.16666666666666666, exp_half_angle_of_exp_y),
      exp_sinc_a_cross1 = KSL_MUL(9.25185853854297e-18, exp_half_angle_of_exp_y),
      exp_sinc_a_cross2 = KSL_MUL(0.16666666666666666, exp_half_angle_of_exp_y_lo),
      exp_sinc_a_cross = exp_sinc_a_cross1 + exp_sinc_a_cross2, exp_sinc_b = 1.0 - exp_sinc_a,
      exp_sinc_b_right = 1.0 - exp_sinc_b, exp_sinc_b_left = exp_sinc_b + exp_sinc_b_right,
      exp_sinc_b_left_rest = 1.0 - exp_sinc_b_left,
      exp_sinc_b_right_rest = ksl_product_rest(0.16666666666666666, exp_half_angle_of_exp_y,
          exp_sinc_a, exp_sinc_b_right),
      exp_sinc_b_lo1 = exp_sinc_b_left_rest - exp_sinc_b_right_rest,
      exp_sinc_b_lo = exp_sinc_b_lo1 - exp_sinc_a_cross,
      exp_sinc = exp_sine_of_exp_half_angle < 1.4901161193847656e-08 ? exp_sinc_b :
          exp_sinc_quotient,
      exp_sinc_lo = exp_sine_of_exp_half_angle < 1.4901161193847656e-08 ? exp_sinc_b_lo :
          exp_sinc_quotient_lo;
  const double exp_g1 = KSL_MUL(exp_c, exp_sinc), exp_g1_cross1 = KSL_MUL(exp_c_lo, exp_sinc),
      exp_g1_cross2 = KSL_MUL(exp_c, exp_sinc_lo), exp_g1_cross = exp_g1_cross1 + exp_g1_cross2;
  const double exp_g2a = KSL_MUL(exp_sinc, exp_sinc),
      exp_g2a_cross1 = KSL_MUL(exp_sinc_lo, exp_sinc),
      exp_g2a_cross2 = KSL_MUL(exp_sinc, exp_sinc_lo),
      exp_g2a_cross = exp_g2a_cross1 + exp_g2a_cross2,
      exp_g2a_error = ksl_product_error(exp_sinc, exp_sinc, exp_g2a),
      exp_g2a_lo = exp_g2a_error + exp_g2a_cross, exp_g2 = KSL_MUL(0.5, exp_g2a),
      exp_g2_cross2 = KSL_MUL(0.5, exp_g2a_lo);
  const double exp_sine_square = KSL_MUL(exp_sinc_quotient_of_exp_sine,
      exp_sinc_quotient_of_exp_sine),
      exp_sine_square_cross1 = KSL_MUL(exp_sinc_quotient_of_exp_sine_lo,
          exp_sinc_quotient_of_exp_sine),
      exp_sine_square_cross2 = KSL_MUL(exp_sinc_quotient_of_exp_sine,
          exp_sinc_quotient_of_exp_sine_lo),
      exp_sine_square_cross = exp_sine_square_cross1 + exp_sine_square_cross2;
  const double exp_sine_square_error = ksl_product_error(exp_sinc_quotient_of_exp_sine,
      exp_sinc_quotient_of_exp_sine, exp_sine_square),
      exp_sine_square_lo = exp_sine_square_error + exp_sine_square_cross,
      exp_g0a = KSL_MUL(2.0, exp_sine_square), exp_g0a_cross2 = KSL_MUL(2.0, exp_sine_square_lo),
      exp_g0 = 1.0 - exp_g0a, exp_g0_right = 1.0 - exp_g0, exp_g0_left = exp_g0 + exp_g0_right,
      exp_g0_left_rest = 1.0 - exp_g0_left, exp_g0_right_rest = exp_g0a - exp_g0_right,
      exp_g0_lo1 = exp_g0_left_rest - exp_g0_right_rest, exp_g0_lo = exp_g0_lo1 - exp_g0a_cross2;
  const double exp_rest3 = 1.0 - exp_g1, exp_rest3_right = 1.0 - exp_rest3,
      exp_rest3_left = exp_rest3 + exp_rest3_right, exp_rest3_left_rest = 1.0 - exp_rest3_left,
      exp_rest3_right_rest = ksl_product_rest(exp_c, exp_sinc, exp_g1, exp_rest3_right),
      exp_rest3_lo1 = exp_rest3_left_rest - exp_rest3_right_rest,
      exp_rest3_lo = exp_rest3_lo1 - exp_g1_cross;
  const double exp_x = KSL_MUL(4.0, exp_half_angle_of_exp_y),
      exp_x_cross2 = KSL_MUL(4.0, exp_half_angle_of_exp_y_lo);
  const double exp_far_x_a_of_exp_x = exp_x + exp_x_cross2,
      exp_far_x_a_of_exp_x_right = exp_far_x_a_of_exp_x - exp_x,
      exp_far_x_a_of_exp_x_left = exp_far_x_a_of_exp_x - exp_far_x_a_of_exp_x_right,
      exp_far_x_a_of_exp_x_left_rest = exp_x - exp_far_x_a_of_exp_x_left,
      exp_far_x_a_of_exp_x_right_rest = exp_x_cross2 - exp_far_x_a_of_exp_x_right,
      exp_far_x_a_of_exp_x_lo = exp_far_x_a_of_exp_x_left_rest + exp_far_x_a_of_exp_x_right_rest,
      exp_far_x = exp_far_x_a_of_exp_x < 1.0 ? 1.0 : exp_far_x_a_of_exp_x,
      exp_far_x_lo = exp_far_x_a_of_exp_x < 1.0 ? 0.0 : exp_far_x_a_of_exp_x_lo;
  const double exp_closed3_of_exp_rest3 = exp_rest3 + exp_rest3_lo,
      exp_closed3_of_exp_rest3_right = exp_closed3_of_exp_rest3 - exp_rest3,
      exp_closed3_of_exp_rest3_left = exp_closed3_of_exp_rest3 - exp_closed3_of_exp_rest3_right,
      exp_closed3_of_exp_rest3_left_rest = exp_rest3 - exp_closed3_of_exp_rest3_left,
      exp_closed3_of_exp_rest3_right_rest = exp_rest3_lo - exp_closed3_of_exp_rest3_right,
      exp_closed3_of_exp_rest3_lo = exp_closed3_of_exp_rest3_left_rest +
          exp_closed3_of_exp_rest3_right_rest,
      exp_closed3_of_exp_far_x = exp_far_x + exp_far_x_lo,
      exp_closed3_of_exp_far_x_right = exp_closed3_of_exp_far_x - exp_far_x,
      exp_closed3_of_exp_far_x_left = exp_closed3_of_exp_far_x - exp_closed3_of_exp_far_x_right,
      exp_closed3_of_exp_far_x_left_rest = exp_far_x - exp_closed3_of_exp_far_x_left,
      exp_closed3_of_exp_far_x_right_rest = exp_far_x_lo - exp_closed3_of_exp_far_x_right,
      exp_closed3_of_exp_far_x_lo = exp_closed3_of_exp_far_x_left_rest +
          exp_closed3_of_exp_far_x_right_rest,
      exp_closed3 = exp_closed3_of_exp_rest3 / exp_closed3_of_exp_far_x,
      exp_closed3_product = KSL_MUL(exp_closed3, exp_closed3_of_exp_far_x),
      exp_closed3_product_error = ksl_product_error(exp_closed3, exp_closed3_of_exp_far_x,
          exp_closed3_product),
      exp_closed3_rest = exp_closed3_of_exp_rest3 - exp_closed3_product,
      exp_closed3_exact = exp_closed3_rest - exp_closed3_product_error,
      exp_closed3_numerator = exp_closed3_exact + exp_closed3_of_exp_rest3_lo,
      exp_closed3_cross = KSL_MUL(exp_closed3, exp_closed3_of_exp_far_x_lo),
      exp_closed3_residual = exp_closed3_numerator - exp_closed3_cross,
      exp_closed3_lo = exp_closed3_residual / exp_closed3_of_exp_far_x;
  const double exp_series5a = KSL_MUL(1.216125041553518e-34, exp_far_x_a_of_exp_x),
      exp_series5a_cross1 = KSL_MUL(5.586290567888806e-51, exp_far_x_a_of_exp_x),
      exp_series5a_cross2 = KSL_MUL(1.216125041553518e-34, exp_far_x_a_of_exp_x_lo),
      exp_series5a_cross = exp_series5a_cross1 + exp_series5a_cross2,
      exp_series5b = 1.1309962886447716e-31 - exp_series5a,
      exp_series5b_right = 1.1309962886447716e-31 - exp_series5b,
      exp_series5b_left = exp_series5b + exp_series5b_right,
      exp_series5b_left_rest = 1.1309962886447716e-31 - exp_series5b_left,
      exp_series5b_right_rest = ksl_product_rest(1.216125041553518e-34, exp_far_x_a_of_exp_x,
          exp_series5a, exp_series5b_right),
      exp_series5b_lo1 = exp_series5b_left_rest - exp_series5b_right_rest,
      exp_series5b_lo2 = exp_series5b_lo1 - exp_series5a_cross,
      exp_series5b_lo = exp_series5b_lo2 + 1.0498015412959506e-47,
      exp_series5c = KSL_MUL(exp_far_x_a_of_exp_x, exp_series5b),
      exp_series5c_cross1 = KSL_MUL(exp_far_x_a_of_exp_x_lo, exp_series5b),
      exp_series5c_cross2 = KSL_MUL(exp_far_x_a_of_exp_x, exp_series5b_lo),
      exp_series5c_cross = exp_series5c_cross1 + exp_series5c_cross2,
      exp_series5d = exp_series5c - 9.183689863795546e-29,
      exp_series5d_right = exp_series5c - exp_series5d,
      exp_series5d_left = exp_series5d + exp_series5d_right,
      exp_series5d_left_rest = ksl_product_rest(exp_far_x_a_of_exp_x, exp_series5b, exp_series5c,
          exp_series5d_left),
      exp_series5d_right_rest = 9.183689863795546e-29 - exp_series5d_right,
      exp_series5d_lo1 = exp_series5d_left_rest - exp_series5d_right_rest,
      exp_series5d_lo2 = exp_series5d_lo1 - 1.4303150396787322e-45,
      exp_series5d_lo = exp_series5d_lo2 + exp_series5c_cross,
      exp_series5e = KSL_MUL(exp_far_x_a_of_exp_x, exp_series5d),
      exp_series5e_cross1 = KSL_MUL(exp_far_x_a_of_exp_x_lo, exp_series5d),
      exp_series5e_cross2 = KSL_MUL(exp_far_x_a_of_exp_x, exp_series5d_lo),
      exp_series5e_cross = exp_series5e_cross1 + exp_series5e_cross2,
      exp_series5f = exp_series5e + 6.446950284384474e-26,
      exp_series5f_right = exp_series5f - exp_series5e,
      exp_series5f_left = exp_series5f - exp_series5f_right,
      exp_series5f_left_rest = ksl_product_rest(exp_far_x_a_of_exp_x, exp_series5d, exp_series5e,
          exp_series5f_left),
      exp_series5f_right_rest = 6.446950284384474e-26 - exp_series5f_right,
      exp_series5f_lo1 = exp_series5f_left_rest + exp_series5f_right_rest,
      exp_series5f_lo2 = exp_series5f_lo1 + -1.9330404233703465e-42,
      exp_series5f_lo = exp_series5f_lo2 + exp_series5e_cross,
      exp_series5g = KSL_MUL(exp_far_x_a_of_exp_x, exp_series5f),
      exp_series5g_cross1 = KSL_MUL(exp_far_x_a_of_exp_x_lo, exp_series5f),
      exp_series5g_cross2 = KSL_MUL(exp_far_x_a_of_exp_x, exp_series5f_lo),
      exp_series5g_cross = exp_series5g_cross1 + exp_series5g_cross2,
      exp_series5h = exp_series5g - 3.868170170630684e-23,
      exp_series5h_right = exp_series5g - exp_series5h,
      exp_series5h_left = exp_series5h + exp_series5h_right,
      exp_series5h_left_rest = ksl_product_rest(exp_far_x_a_of_exp_x, exp_series5f, exp_series5g,
          exp_series5h_left),
      exp_series5h_right_rest = 3.868170170630684e-23 - exp_series5h_right,
      exp_series5h_lo1 = exp_series5h_left_rest - exp_series5h_right_rest,
      exp_series5h_lo2 = exp_series5h_lo1 - -8.843177655482344e-40,
      exp_series5h_lo = exp_series5h_lo2 + exp_series5g_cross,
      exp_series5i = KSL_MUL(exp_far_x_a_of_exp_x, exp_series5h),
      exp_series5i_cross1 = KSL_MUL(exp_far_x_a_of_exp_x_lo, exp_series5h),
      exp_series5i_cross2 = KSL_MUL(exp_far_x_a_of_exp_x, exp_series5h_lo),
      exp_series5i_cross = exp_series5i_cross1 + exp_series5i_cross2,
      exp_series5j = exp_series5i + 1.9572941063391263e-20,
      exp_series5j_right = exp_series5j - exp_series5i,
      exp_series5j_left = exp_series5j - exp_series5j_right,
      exp_series5j_left_rest = ksl_product_rest(exp_far_x_a_of_exp_x, exp_series5h, exp_series5i,
          exp_series5j_left),
      exp_series5j_right_rest = 1.9572941063391263e-20 - exp_series5j_right,
      exp_series5j_lo1 = exp_series5j_left_rest + exp_series5j_right_rest,
      exp_series5j_lo2 = exp_series5j_lo1 + -1.3643503830087908e-36,
      exp_series5j_lo = exp_series5j_lo2 + exp_series5i_cross,
      exp_series5k = KSL_MUL(exp_far_x_a_of_exp_x, exp_series5j),
      exp_series5k_cross1 = KSL_MUL(exp_far_x_a_of_exp_x_lo, exp_series5j),
      exp_series5k_cross2 = KSL_MUL(exp_far_x_a_of_exp_x, exp_series5j_lo),
      exp_series5k_cross = exp_series5k_cross1 + exp_series5k_cross2,
      exp_series5l = exp_series5k - 8.22063524662433e-18,
      exp_series5l_right = exp_series5k - exp_series5l,
      exp_series5l_left = exp_series5l + exp_series5l_right,
      exp_series5l_left_rest = ksl_product_rest(exp_far_x_a_of_exp_x, exp_series5j, exp_series5k,
          exp_series5l_left),
      exp_series5l_right_rest = 8.22063524662433e-18 - exp_series5l_right,
      exp_series5l_lo1 = exp_series5l_left_rest - exp_series5l_right_rest,
      exp_series5l_lo2 = exp_series5l_lo1 - 2.2141894119604265e-34,
      exp_series5l_lo = exp_series5l_lo2 + exp_series5k_cross,
      exp_series5m = KSL_MUL(exp_far_x_a_of_exp_x, exp_series5l),
      exp_series5m_cross1 = KSL_MUL(exp_far_x_a_of_exp_x_lo, exp_series5l),
      exp_series5m_cross2 = KSL_MUL(exp_far_x_a_of_exp_x, exp_series5l_lo),
      exp_series5m_cross = exp_series5m_cross1 + exp_series5m_cross2,
      exp_series5n = exp_series5m + 2.8114572543455206e-15,
      exp_series5n_right = exp_series5n - exp_series5m,
      exp_series5n_left = exp_series5n - exp_series5n_right,
      exp_series5n_left_rest = ksl_product_rest(exp_far_x_a_of_exp_x, exp_series5l, exp_series5m,
          exp_series5n_left),
      exp_series5n_right_rest = 2.8114572543455206e-15 - exp_series5n_right,
      exp_series5n_lo1 = exp_series5n_left_rest + exp_series5n_right_rest,
      exp_series5n_lo2 = exp_series5n_lo1 + 1.6508842730861433e-31,
      exp_series5n_lo = exp_series5n_lo2 + exp_series5m_cross,
      exp_series5o = KSL_MUL(exp_far_x_a_of_exp_x, exp_series5n),
      exp_series5o_cross1 = KSL_MUL(exp_far_x_a_of_exp_x_lo, exp_series5n),
      exp_series5o_cross2 = KSL_MUL(exp_far_x_a_of_exp_x, exp_series5n_lo),
      exp_series5o_cross = exp_series5o_cross1 + exp_series5o_cross2,
      exp_series5p = exp_series5o - 7.647163731819816e-13,
      exp_series5p_right = exp_series5o - exp_series5p,
      exp_series5p_left = exp_series5p + exp_series5p_right,
      exp_series5p_left_rest = ksl_product_rest(exp_far_x_a_of_exp_x, exp_series5n, exp_series5o,
          exp_series5p_left),
      exp_series5p_right_rest = 7.647163731819816e-13 - exp_series5p_right,
      exp_series5p_lo1 = exp_series5p_left_rest - exp_series5p_right_rest,
      exp_series5p_lo2 = exp_series5p_lo1 - 7.03872877733453e-30,
      exp_series5p_lo = exp_series5p_lo2 + exp_series5o_cross,
      exp_series5q = KSL_MUL(exp_far_x_a_of_exp_x, exp_series5p),
      exp_series5q_cross1 = KSL_MUL(exp_far_x_a_of_exp_x_lo, exp_series5p),
      exp_series5q_cross2 = KSL_MUL(exp_far_x_a_of_exp_x, exp_series5p_lo),
      exp_series5q_cross = exp_series5q_cross1 + exp_series5q_cross2,
      exp_series5r = exp_series5q + 1.6059043836821613e-10,
      exp_series5r_right = exp_series5r - exp_series5q,
      exp_series5r_left = exp_series5r - exp_series5r_right,
      exp_series5r_left_rest = ksl_product_rest(exp_far_x_a_of_exp_x, exp_series5p, exp_series5q,
          exp_series5r_left),
      exp_series5r_right_rest = 1.6059043836821613e-10 - exp_series5r_right,
      exp_series5r_lo1 = exp_series5r_left_rest + exp_series5r_right_rest,
      exp_series5r_lo2 = exp_series5r_lo1 + 1.2585294588752098e-26,
      exp_series5r_lo = exp_series5r_lo2 + exp_series5q_cross,
      exp_series5s = KSL_MUL(exp_far_x_a_of_exp_x, exp_series5r),
      exp_series5s_cross1 = KSL_MUL(exp_far_x_a_of_exp_x_lo, exp_series5r),
      exp_series5s_cross2 = KSL_MUL(exp_far_x_a_of_exp_x, exp_series5r_lo),
      exp_series5s_cross = exp_series5s_cross1 + exp_series5s_cross2,
      exp_series5t = exp_series5s - 2.505210838544172e-08,
      exp_series5t_right = exp_series5s - exp_series5t,
      exp_series5t_left = exp_series5t + exp_series5t_right,
      exp_series5t_left_rest = ksl_product_rest(exp_far_x_a_of_exp_x, exp_series5r, exp_series5s,
          exp_series5t_left),
      exp_series5t_right_rest = 2.505210838544172e-08 - exp_series5t_right,
      exp_series5t_lo1 = exp_series5t_left_rest - exp_series5t_right_rest,
      exp_series5t_lo2 = exp_series5t_lo1 - -1.448814070935912e-24,
      exp_series5t_lo = exp_series5t_lo2 + exp_series5s_cross,
      exp_series5u = KSL_MUL(exp_far_x_a_of_exp_x, exp_series5t),
      exp_series5u_cross1 = KSL_MUL(exp_far_x_a_of_exp_x_lo, exp_series5t),
      exp_series5u_cross2 = KSL_MUL(exp_far_x_a_of_exp_x, exp_series5t_lo),
      exp_series5u_cross = exp_series5u_cross1 + exp_series5u_cross2,
      exp_series5v = exp_series5u + 2.7557319223985893e-06,
      exp_series5v_right = exp_series5v - exp_series5u,
      exp_series5v_left = exp_series5v - exp_series5v_right,
      exp_series5v_left_rest = ksl_product_rest(exp_far_x_a_of_exp_x, exp_series5t, exp_series5u,
          exp_series5v_left),
      exp_series5v_right_rest = 2.7557319223985893e-06 - exp_series5v_right,
      exp_series5v_lo1 = exp_series5v_left_rest + exp_series5v_right_rest,
      exp_series5v_lo2 = exp_series5v_lo1 + -1.858393274046472e-22,
      exp_series5v_lo = exp_series5v_lo2 + exp_series5u_cross,
      exp_series5w = KSL_MUL(exp_far_x_a_of_exp_x, exp_series5v),
      exp_series5w_cross1 = KSL_MUL(exp_far_x_a_of_exp_x_lo, exp_series5v),
      exp_series5w_cross2 = KSL_MUL(exp_far_x_a_of_exp_x, exp_series5v_lo),
      exp_series5w_cross = exp_series5w_cross1 + exp_series5w_cross2,
      exp_series5x = exp_series5w - 0.0001984126984126984,
      exp_series5x_right = exp_series5w - exp_series5x,
      exp_series5x_left = exp_series5x + exp_series5x_right,
      exp_series5x_left_rest = ksl_product_rest(exp_far_x_a_of_exp_x, exp_series5v, exp_series5w,
          exp_series5x_left),
      exp_series5x_right_rest = 0.0001984126984126984 - exp_series5x_right,
      exp_series5x_lo1 = exp_series5x_left_rest - exp_series5x_right_rest,
      exp_series5x_lo2 = exp_series5x_lo1 - 1.7209558293420705e-22,
      exp_series5x_lo = exp_series5x_lo2 + exp_series5w_cross,
      exp_series5y = KSL_MUL(exp_far_x_a_of_exp_x, exp_series5x),
      exp_series5y_cross1 = KSL_MUL(exp_far_x_a_of_exp_x_lo, exp_series5x),
      exp_series5y_cross2 = KSL_MUL(exp_far_x_a_of_exp_x, exp_series5x_lo),
      exp_series5y_cross = exp_series5y_cross1 + exp_series5y_cross2,
      exp_series5 = exp_series5y + 0.008333333333333333,
      exp_series5_right = exp_series5 - exp_series5y,
      exp_series5_left = exp_series5 - exp_series5_right,
      exp_series5_left_rest = ksl_product_rest(exp_far_x_a_of_exp_x, exp_series5x, exp_series5y,
          exp_series5_left),
      exp_series5_right_rest = 0.008333333333333333 - exp_series5_right,
      exp_series5_lo1 = exp_series5_left_rest + exp_series5_right_rest,
      exp_series5_lo2 = exp_series5_lo1 + 1.1564823173178714e-19,
      exp_series5_lo = exp_series5_lo2 + exp_series5y_cross;
  const double exp_g3a = KSL_MUL(exp_far_x_a_of_exp_x, exp_series5),
      exp_g3a_cross1 = KSL_MUL(exp_far_x_a_of_exp_x_lo, exp_series5),
      exp_g3a_cross2 = KSL_MUL(exp_far_x_a_of_exp_x, exp_series5_lo),
      exp_g3a_cross = exp_g3a_cross1 + exp_g3a_cross2, exp_g3b = 0.16666666666666666 - exp_g3a,
      exp_g3b_right = 0.16666666666666666 - exp_g3b, exp_g3b_left = exp_g3b + exp_g3b_right,
      exp_g3b_left_rest = 0.16666666666666666 - exp_g3b_left,
      exp_g3b_right_rest = ksl_product_rest(exp_far_x_a_of_exp_x, exp_series5, exp_g3a,
          exp_g3b_right),
      exp_g3b_lo1 = exp_g3b_left_rest - exp_g3b_right_rest,
      exp_g3b_lo2 = exp_g3b_lo1 - exp_g3a_cross, exp_g3b_lo = exp_g3b_lo2 + 9.25185853854297e-18,
      exp_g3 = exp_far_x_a_of_exp_x < 1.0 ? exp_g3b : exp_closed3,
      exp_g3_lo = exp_far_x_a_of_exp_x < 1.0 ? exp_g3b_lo : exp_closed3_lo;
  const double screw_2_error = ksl_product_error(k, whole_2, screw_2),
      screw_2_lo = screw_2_error + screw_2_cross2, exp_u_0a = KSL_MUL(screw_2, screw_4),
      exp_u_0a_cross1 = KSL_MUL(screw_2_lo, screw_4),
      exp_u_0a_cross2 = KSL_MUL(screw_2, screw_4_lo),
      exp_u_0a_cross = exp_u_0a_cross1 + exp_u_0a_cross2,
      screw_1_error = ksl_product_error(k, whole_1, screw_1),
      screw_1_lo = screw_1_error + screw_1_cross2, exp_u_0b = KSL_MUL(screw_1, screw_5),
      exp_u_0b_cross1 = KSL_MUL(screw_1_lo, screw_5),
      exp_u_0b_cross2 = KSL_MUL(screw_1, screw_5_lo),
      exp_u_0b_cross = exp_u_0b_cross1 + exp_u_0b_cross2, exp_u_0 = exp_u_0a - exp_u_0b,
      exp_u_0_right = exp_u_0a - exp_u_0, exp_u_0_left = exp_u_0 + exp_u_0_right,
      exp_u_0_left_rest = ksl_product_rest(screw_2, screw_4, exp_u_0a, exp_u_0_left),
      exp_u_0_right_rest = ksl_product_rest(screw_1, screw_5, exp_u_0b, exp_u_0_right),
      exp_u_0_cross = exp_u_0a_cross - exp_u_0b_cross,
      exp_u_0_lo1 = exp_u_0_left_rest - exp_u_0_right_rest,
      exp_u_0_lo = exp_u_0_lo1 + exp_u_0_cross;
  const double screw_0_error = ksl_product_error(k, whole_0, screw_0),
      screw_0_lo = screw_0_error + screw_0_cross2, exp_u_1a = KSL_MUL(screw_0, screw_5),
      exp_u_1a_cross1 = KSL_MUL(screw_0_lo, screw_5),
      exp_u_1a_cross2 = KSL_MUL(screw_0, screw_5_lo),
      exp_u_1a_cross = exp_u_1a_cross1 + exp_u_1a_cross2, exp_u_1b = KSL_MUL(screw_2, screw_3),
      exp_u_1b_cross1 = KSL_MUL(screw_2_lo, screw_3),
      exp_u_1b_cross2 = KSL_MUL(screw_2, screw_3_lo),
      exp_u_1b_cross = exp_u_1b_cross1 + exp_u_1b_cross2, exp_u_1 = exp_u_1a - exp_u_1b,
      exp_u_1_right = exp_u_1a - exp_u_1, exp_u_1_left = exp_u_1 + exp_u_1_right,
      exp_u_1_left_rest = ksl_product_rest(screw_0, screw_5, exp_u_1a, exp_u_1_left),
      exp_u_1_right_rest = ksl_product_rest(screw_2, screw_3, exp_u_1b, exp_u_1_right),
      exp_u_1_cross = exp_u_1a_cross - exp_u_1b_cross,
      exp_u_1_lo1 = exp_u_1_left_rest - exp_u_1_right_rest,
      exp_u_1_lo = exp_u_1_lo1 + exp_u_1_cross;
  const double exp_u_2a = KSL_MUL(screw_1, screw_3), exp_u_2a_cross1 = KSL_MUL(screw_1_lo, screw_3),
      exp_u_2a_cross2 = KSL_MUL(screw_1, screw_3_lo),
      exp_u_2a_cross = exp_u_2a_cross1 + exp_u_2a_cross2, exp_u_2b = KSL_MUL(screw_0, screw_4),
      exp_u_2b_cross1 = KSL_MUL(screw_0_lo, screw_4),
      exp_u_2b_cross2 = KSL_MUL(screw_0, screw_4_lo),
      exp_u_2b_cross = exp_u_2b_cross1 + exp_u_2b_cross2, exp_u_2 = exp_u_2a - exp_u_2b,
      exp_u_2_right = exp_u_2a - exp_u_2, exp_u_2_left = exp_u_2 + exp_u_2_right,
      exp_u_2_left_rest = ksl_product_rest(screw_1, screw_3, exp_u_2a, exp_u_2_left),
      exp_u_2_right_rest = ksl_product_rest(screw_0, screw_4, exp_u_2b, exp_u_2_right),
      exp_u_2_cross = exp_u_2a_cross - exp_u_2b_cross,
      exp_u_2_lo1 = exp_u_2_left_rest - exp_u_2_right_rest,
      exp_u_2_lo = exp_u_2_lo1 + exp_u_2_cross;
  const double exp_turned_0 = KSL_MUL(exp_g2, exp_u_0),
      exp_turned_0_cross1 = KSL_MUL(exp_g2_cross2, exp_u_0),
      exp_turned_0_cross2 = KSL_MUL(exp_g2, exp_u_0_lo),
      exp_turned_0_cross = exp_turned_0_cross1 + exp_turned_0_cross2;
  const double exp_turned_1 = KSL_MUL(exp_g2, exp_u_1),
      exp_turned_1_cross1 = KSL_MUL(exp_g2_cross2, exp_u_1),
      exp_turned_1_cross2 = KSL_MUL(exp_g2, exp_u_1_lo),
      exp_turned_1_cross = exp_turned_1_cross1 + exp_turned_1_cross2;
  const double exp_turned_2 = KSL_MUL(exp_g2, exp_u_2),
      exp_turned_2_cross1 = KSL_MUL(exp_g2_cross2, exp_u_2),
      exp_turned_2_cross2 = KSL_MUL(exp_g2, exp_u_2_lo),
      exp_turned_2_cross = exp_turned_2_cross1 + exp_turned_2_cross2;
  const double exp_wv_a = KSL_MUL(screw_0, screw_3), exp_wv_a_cross1 = KSL_MUL(screw_0_lo, screw_3),
      exp_wv_a_cross2 = KSL_MUL(screw_0, screw_3_lo),
      exp_wv_a_cross = exp_wv_a_cross1 + exp_wv_a_cross2, exp_wv_b = KSL_MUL(screw_1, screw_4),
      exp_wv_b_cross1 = KSL_MUL(screw_1_lo, screw_4),
      exp_wv_b_cross2 = KSL_MUL(screw_1, screw_4_lo),
      exp_wv_b_cross = exp_wv_b_cross1 + exp_wv_b_cross2, exp_wv_c = exp_wv_a + exp_wv_b,
      exp_wv_c_right = exp_wv_c - exp_wv_a, exp_wv_c_left = exp_wv_c - exp_wv_c_right,
      exp_wv_c_left_rest = ksl_product_rest(screw_0, screw_3, exp_wv_a, exp_wv_c_left),
      exp_wv_c_right_rest = ksl_product_rest(screw_1, screw_4, exp_wv_b, exp_wv_c_right),
      exp_wv_c_cross = exp_wv_a_cross + exp_wv_b_cross,
      exp_wv_c_lo1 = exp_wv_c_left_rest + exp_wv_c_right_rest,
      exp_wv_c_lo = exp_wv_c_lo1 + exp_wv_c_cross, exp_wv_d = KSL_MUL(screw_2, screw_5),
      exp_wv_d_cross1 = KSL_MUL(screw_2_lo, screw_5),
      exp_wv_d_cross2 = KSL_MUL(screw_2, screw_5_lo),
      exp_wv_d_cross = exp_wv_d_cross1 + exp_wv_d_cross2, exp_wv = exp_wv_c + exp_wv_d,
      exp_wv_right = exp_wv - exp_wv_c, exp_wv_left = exp_wv - exp_wv_right,
      exp_wv_left_rest = exp_wv_c - exp_wv_left,
      exp_wv_right_rest = ksl_product_rest(screw_2, screw_5, exp_wv_d, exp_wv_right),
      exp_wv_lo1 = exp_wv_left_rest + exp_wv_right_rest, exp_wv_lo2 = exp_wv_lo1 + exp_wv_d_cross,
      exp_wv_lo = exp_wv_lo2 + exp_wv_c_lo;
  const double exp_pitch = KSL_MUL(exp_g3, exp_wv), exp_pitch_cross1 = KSL_MUL(exp_g3_lo, exp_wv),
      exp_pitch_cross2 = KSL_MUL(exp_g3, exp_wv_lo),
      exp_pitch_cross = exp_pitch_cross1 + exp_pitch_cross2;
  const double exp_pitch_error = ksl_product_error(exp_g3, exp_wv, exp_pitch),
      exp_pitch_lo = exp_pitch_error + exp_pitch_cross, exp_along_0 = KSL_MUL(screw_3, exp_pitch),
      exp_along_0_cross1 = KSL_MUL(screw_3_lo, exp_pitch),
      exp_along_0_cross2 = KSL_MUL(screw_3, exp_pitch_lo),
      exp_along_0_cross = exp_along_0_cross1 + exp_along_0_cross2;
  const double exp_along_1 = KSL_MUL(screw_4, exp_pitch),
      exp_along_1_cross1 = KSL_MUL(screw_4_lo, exp_pitch),
      exp_along_1_cross2 = KSL_MUL(screw_4, exp_pitch_lo),
      exp_along_1_cross = exp_along_1_cross1 + exp_along_1_cross2;
  const double exp_along_2 = KSL_MUL(screw_5, exp_pitch),
      exp_along_2_cross1 = KSL_MUL(screw_5_lo, exp_pitch),
      exp_along_2_cross2 = KSL_MUL(screw_5, exp_pitch_lo),
      exp_along_2_cross = exp_along_2_cross1 + exp_along_2_cross2;
  const double exp_beta_v_0 = KSL_MUL(screw_3, exp_g2),
      exp_beta_v_0_cross1 = KSL_MUL(screw_3_lo, exp_g2),
      exp_beta_v_0_cross2 = KSL_MUL(screw_3, exp_g2_cross2),
      exp_beta_v_0_cross = exp_beta_v_0_cross1 + exp_beta_v_0_cross2;
  const double exp_beta_v_1 = KSL_MUL(screw_4, exp_g2),
      exp_beta_v_1_cross1 = KSL_MUL(screw_4_lo, exp_g2),
      exp_beta_v_1_cross2 = KSL_MUL(screw_4, exp_g2_cross2),
      exp_beta_v_1_cross = exp_beta_v_1_cross1 + exp_beta_v_1_cross2;
  const double exp_beta_v_2 = KSL_MUL(screw_5, exp_g2),
      exp_beta_v_2_cross1 = KSL_MUL(screw_5_lo, exp_g2),
      exp_beta_v_2_cross2 = KSL_MUL(screw_5, exp_g2_cross2),
      exp_beta_v_2_cross = exp_beta_v_2_cross1 + exp_beta_v_2_cross2;
  const double exp_beta_v_0_error = ksl_product_error(screw_3, exp_g2, exp_beta_v_0),
      exp_beta_v_0_lo = exp_beta_v_0_error + exp_beta_v_0_cross,
      exp_m_0 = KSL_MUL(screw_3, exp_beta_v_0), exp_m_0_cross1 = KSL_MUL(screw_3_lo, exp_beta_v_0),
      exp_m_0_cross2 = KSL_MUL(screw_3, exp_beta_v_0_lo),
      exp_m_0_cross = exp_m_0_cross1 + exp_m_0_cross2;
  const double exp_beta_v_1_error = ksl_product_error(screw_4, exp_g2, exp_beta_v_1),
      exp_beta_v_1_lo = exp_beta_v_1_error + exp_beta_v_1_cross,
      exp_m_1 = KSL_MUL(screw_4, exp_beta_v_1), exp_m_1_cross1 = KSL_MUL(screw_4_lo, exp_beta_v_1),
      exp_m_1_cross2 = KSL_MUL(screw_4, exp_beta_v_1_lo),
      exp_m_1_cross = exp_m_1_cross1 + exp_m_1_cross2;
  const double exp_beta_v_2_error = ksl_product_error(screw_5, exp_g2, exp_beta_v_2),
      exp_beta_v_2_lo = exp_beta_v_2_error + exp_beta_v_2_cross,
      exp_m_2 = KSL_MUL(screw_5, exp_beta_v_2), exp_m_2_cross1 = KSL_MUL(screw_5_lo, exp_beta_v_2),
      exp_m_2_cross2 = KSL_MUL(screw_5, exp_beta_v_2_lo),
      exp_m_2_cross = exp_m_2_cross1 + exp_m_2_cross2;
  const double exp_m_3 = KSL_MUL(screw_4, exp_beta_v_0),
      exp_m_3_cross1 = KSL_MUL(screw_4_lo, exp_beta_v_0),
      exp_m_3_cross2 = KSL_MUL(screw_4, exp_beta_v_0_lo),
      exp_m_3_cross = exp_m_3_cross1 + exp_m_3_cross2;
  const double exp_m_4 = KSL_MUL(screw_5, exp_beta_v_0),
      exp_m_4_cross1 = KSL_MUL(screw_5_lo, exp_beta_v_0),
      exp_m_4_cross2 = KSL_MUL(screw_5, exp_beta_v_0_lo),
      exp_m_4_cross = exp_m_4_cross1 + exp_m_4_cross2;
  const double exp_m_5 = KSL_MUL(screw_5, exp_beta_v_1),
      exp_m_5_cross1 = KSL_MUL(screw_5_lo, exp_beta_v_1),
      exp_m_5_cross2 = KSL_MUL(screw_5, exp_beta_v_1_lo),
      exp_m_5_cross = exp_m_5_cross1 + exp_m_5_cross2;
  const double exp_others_0 = exp_m_1 + exp_m_2, exp_others_0_right = exp_others_0 - exp_m_1,
      exp_others_0_left = exp_others_0 - exp_others_0_right,
      exp_others_0_left_rest = ksl_product_rest(screw_4, exp_beta_v_1, exp_m_1, exp_others_0_left),
      exp_others_0_right_rest = ksl_product_rest(screw_5, exp_beta_v_2, exp_m_2,
          exp_others_0_right),
      exp_others_0_cross = exp_m_1_cross + exp_m_2_cross,
      exp_others_0_lo1 = exp_others_0_left_rest + exp_others_0_right_rest,
      exp_others_0_lo = exp_others_0_lo1 + exp_others_0_cross;
  const double exp_others_1 = exp_m_0 + exp_m_2, exp_others_1_right = exp_others_1 - exp_m_0,
      exp_others_1_left = exp_others_1 - exp_others_1_right,
      exp_others_1_left_rest = ksl_product_rest(screw_3, exp_beta_v_0, exp_m_0, exp_others_1_left),
      exp_others_1_right_rest = ksl_product_rest(screw_5, exp_beta_v_2, exp_m_2,
          exp_others_1_right),
      exp_others_1_cross = exp_m_0_cross + exp_m_2_cross,
      exp_others_1_lo1 = exp_others_1_left_rest + exp_others_1_right_rest,
      exp_others_1_lo = exp_others_1_lo1 + exp_others_1_cross;
  const double exp_others_2 = exp_m_0 + exp_m_1, exp_others_2_right = exp_others_2 - exp_m_0,
      exp_others_2_left = exp_others_2 - exp_others_2_right,
      exp_others_2_left_rest = ksl_product_rest(screw_3, exp_beta_v_0, exp_m_0, exp_others_2_left),
      exp_others_2_right_rest = ksl_product_rest(screw_4, exp_beta_v_1, exp_m_1,
          exp_others_2_right),
      exp_others_2_cross = exp_m_0_cross + exp_m_1_cross,
      exp_others_2_lo1 = exp_others_2_left_rest + exp_others_2_right_rest,
      exp_others_2_lo = exp_others_2_lo1 + exp_others_2_cross;
  const double exp_diagonal0a = 1.0 - exp_others_0, exp_diagonal0a_right = 1.0 - exp_diagonal0a,
      exp_diagonal0a_left = exp_diagonal0a + exp_diagonal0a_right,
      exp_diagonal0a_left_rest = 1.0 - exp_diagonal0a_left,
      exp_diagonal0a_right_rest = exp_others_0 - exp_diagonal0a_right,
      exp_diagonal0a_lo1 = exp_diagonal0a_left_rest - exp_diagonal0a_right_rest,
      exp_diagonal0a_lo = exp_diagonal0a_lo1 - exp_others_0_lo, exp_diagonal0b = exp_g0 + exp_m_0,
      exp_diagonal0b_right = exp_diagonal0b - exp_g0,
      exp_diagonal0b_left = exp_diagonal0b - exp_diagonal0b_right,
      exp_diagonal0b_left_rest = exp_g0 - exp_diagonal0b_left,
      exp_diagonal0b_right_rest = ksl_product_rest(screw_3, exp_beta_v_0, exp_m_0,
          exp_diagonal0b_right),
      exp_diagonal0b_lo1 = exp_diagonal0b_left_rest + exp_diagonal0b_right_rest,
      exp_diagonal0b_lo2 = exp_diagonal0b_lo1 + exp_m_0_cross,
      exp_diagonal0b_lo = exp_diagonal0b_lo2 + exp_g0_lo,
      exp_m_0_error = ksl_product_error(screw_3, exp_beta_v_0, exp_m_0),
      exp_m_0_lo = exp_m_0_error + exp_m_0_cross, exp_diagonal0c_of_exp_m_0 = exp_m_0 + exp_m_0_lo,
      exp_diagonal0c_of_exp_others_0 = exp_others_0 + exp_others_0_lo,
      exp_diagonal0 = exp_diagonal0c_of_exp_m_0 < exp_diagonal0c_of_exp_others_0 ? exp_diagonal0b :
          exp_diagonal0a,
      exp_diagonal0_lo = exp_diagonal0c_of_exp_m_0 < exp_diagonal0c_of_exp_others_0 ?
          exp_diagonal0b_lo : exp_diagonal0a_lo;
  const double exp_diagonal1a = 1.0 - exp_others_1, exp_diagonal1a_right = 1.0 - exp_diagonal1a,
      exp_diagonal1a_left = exp_diagonal1a + exp_diagonal1a_right,
      exp_diagonal1a_left_rest = 1.0 - exp_diagonal1a_left,
      exp_diagonal1a_right_rest = exp_others_1 - exp_diagonal1a_right,
      exp_diagonal1a_lo1 = exp_diagonal1a_left_rest - exp_diagonal1a_right_rest,
      exp_diagonal1a_lo = exp_diagonal1a_lo1 - exp_others_1_lo, exp_diagonal1b = exp_g0 + exp_m_1,
      exp_diagonal1b_right = exp_diagonal1b - exp_g0,
      exp_diagonal1b_left = exp_diagonal1b - exp_diagonal1b_right,
      exp_diagonal1b_left_rest = exp_g0 - exp_diagonal1b_left,
      exp_diagonal1b_right_rest = ksl_product_rest(screw_4, exp_beta_v_1, exp_m_1,
          exp_diagonal1b_right),
      exp_diagonal1b_lo1 = exp_diagonal1b_left_rest + exp_diagonal1b_right_rest,
      exp_diagonal1b_lo2 = exp_diagonal1b_lo1 + exp_m_1_cross,
      exp_diagonal1b_lo = exp_diagonal1b_lo2 + exp_g0_lo,
      exp_m_1_error = ksl_product_error(screw_4, exp_beta_v_1, exp_m_1),
      exp_m_1_lo = exp_m_1_error + exp_m_1_cross, exp_diagonal1c_of_exp_m_1 = exp_m_1 + exp_m_1_lo,
      exp_diagonal1c_of_exp_others_1 = exp_others_1 + exp_others_1_lo,
      exp_diagonal1 = exp_diagonal1c_of_exp_m_1 < exp_diagonal1c_of_exp_others_1 ? exp_diagonal1b :
          exp_diagonal1a,
      exp_diagonal1_lo = exp_diagonal1c_of_exp_m_1 < exp_diagonal1c_of_exp_others_1 ?
          exp_diagonal1b_lo : exp_diagonal1a_lo;
  const double exp_diagonal2a = 1.0 - exp_others_2, exp_diagonal2a_right = 1.0 - exp_diagonal2a,
      exp_diagonal2a_left = exp_diagonal2a + exp_diagonal2a_right,
      exp_diagonal2a_left_rest = 1.0 - exp_diagonal2a_left,
      exp_diagonal2a_right_rest = exp_others_2 - exp_diagonal2a_right,
      exp_diagonal2a_lo1 = exp_diagonal2a_left_rest - exp_diagonal2a_right_rest,
      exp_diagonal2a_lo = exp_diagonal2a_lo1 - exp_others_2_lo, exp_diagonal2b = exp_g0 + exp_m_2,
      exp_diagonal2b_right = exp_diagonal2b - exp_g0,
      exp_diagonal2b_left = exp_diagonal2b - exp_diagonal2b_right,
      exp_diagonal2b_left_rest = exp_g0 - exp_diagonal2b_left,
      exp_diagonal2b_right_rest = ksl_product_rest(screw_5, exp_beta_v_2, exp_m_2,
          exp_diagonal2b_right),
      exp_diagonal2b_lo1 = exp_diagonal2b_left_rest + exp_diagonal2b_right_rest,
      exp_diagonal2b_lo2 = exp_diagonal2b_lo1 + exp_m_2_cross,
      exp_diagonal2b_lo = exp_diagonal2b_lo2 + exp_g0_lo,
      exp_m_2_error = ksl_product_error(screw_5, exp_beta_v_2, exp_m_2),
      exp_m_2_lo = exp_m_2_error + exp_m_2_cross, exp_diagonal2c_of_exp_m_2 = exp_m_2 + exp_m_2_lo,
      exp_diagonal2c_of_exp_others_2 = exp_others_2 + exp_others_2_lo,
      exp_diagonal2 = exp_diagonal2c_of_exp_m_2 < exp_diagonal2c_of_exp_others_2 ? exp_diagonal2b :
          exp_diagonal2a,
      exp_diagonal2_lo = exp_diagonal2c_of_exp_m_2 < exp_diagonal2c_of_exp_others_2 ?
          exp_diagonal2b_lo : exp_diagonal2a_lo;
  const double exp_g1_error = ksl_product_error(exp_c, exp_sinc, exp_g1),
      exp_g1_lo = exp_g1_error + exp_g1_cross, exp_alpha_v_0 = KSL_MUL(screw_3, exp_g1),
      exp_alpha_v_0_cross1 = KSL_MUL(screw_3_lo, exp_g1),
      exp_alpha_v_0_cross2 = KSL_MUL(screw_3, exp_g1_lo),
      exp_alpha_v_0_cross = exp_alpha_v_0_cross1 + exp_alpha_v_0_cross2;
  const double exp_alpha_v_1 = KSL_MUL(screw_4, exp_g1),
      exp_alpha_v_1_cross1 = KSL_MUL(screw_4_lo, exp_g1),
      exp_alpha_v_1_cross2 = KSL_MUL(screw_4, exp_g1_lo),
      exp_alpha_v_1_cross = exp_alpha_v_1_cross1 + exp_alpha_v_1_cross2;
  const double exp_alpha_v_2 = KSL_MUL(screw_5, exp_g1),
      exp_alpha_v_2_cross1 = KSL_MUL(screw_5_lo, exp_g1),
      exp_alpha_v_2_cross2 = KSL_MUL(screw_5, exp_g1_lo),
      exp_alpha_v_2_cross = exp_alpha_v_2_cross1 + exp_alpha_v_2_cross2;
  const double exp_across_axis_0 = exp_turned_0 + exp_along_0,
      exp_across_axis_0_right = exp_across_axis_0 - exp_turned_0,
      exp_across_axis_0_left = exp_across_axis_0 - exp_across_axis_0_right,
      exp_across_axis_0_left_rest = ksl_product_rest(exp_g2, exp_u_0, exp_turned_0,
          exp_across_axis_0_left),
      exp_across_axis_0_right_rest = ksl_product_rest(screw_3, exp_pitch, exp_along_0,
          exp_across_axis_0_right),
      exp_across_axis_0_cross = exp_turned_0_cross + exp_along_0_cross,
      exp_across_axis_0_lo1 = exp_across_axis_0_left_rest + exp_across_axis_0_right_rest,
      exp_across_axis_0_lo = exp_across_axis_0_lo1 + exp_across_axis_0_cross;
  const double exp_across_axis_1 = exp_turned_1 + exp_along_1,
      exp_across_axis_1_right = exp_across_axis_1 - exp_turned_1,
      exp_across_axis_1_left = exp_across_axis_1 - exp_across_axis_1_right,
      exp_across_axis_1_left_rest = ksl_product_rest(exp_g2, exp_u_1, exp_turned_1,
          exp_across_axis_1_left),
      exp_across_axis_1_right_rest = ksl_product_rest(screw_4, exp_pitch, exp_along_1,
          exp_across_axis_1_right),
      exp_across_axis_1_cross = exp_turned_1_cross + exp_along_1_cross,
      exp_across_axis_1_lo1 = exp_across_axis_1_left_rest + exp_across_axis_1_right_rest,
      exp_across_axis_1_lo = exp_across_axis_1_lo1 + exp_across_axis_1_cross;
  const double exp_across_axis_2 = exp_turned_2 + exp_along_2,
      exp_across_axis_2_right = exp_across_axis_2 - exp_turned_2,
      exp_across_axis_2_left = exp_across_axis_2 - exp_across_axis_2_right,
      exp_across_axis_2_left_rest = ksl_product_rest(exp_g2, exp_u_2, exp_turned_2,
          exp_across_axis_2_left),
      exp_across_axis_2_right_rest = ksl_product_rest(screw_5, exp_pitch, exp_along_2,
          exp_across_axis_2_right),
      exp_across_axis_2_cross = exp_turned_2_cross + exp_along_2_cross,
      exp_across_axis_2_lo1 = exp_across_axis_2_left_rest + exp_across_axis_2_right_rest,
      exp_across_axis_2_lo = exp_across_axis_2_lo1 + exp_across_axis_2_cross;
  const double step_1 = exp_m_3 - exp_alpha_v_2, step_1_right = exp_m_3 - step_1,
      step_1_left = step_1 + step_1_right,
      step_1_left_rest = ksl_product_rest(screw_4, exp_beta_v_0, exp_m_3, step_1_left),
      step_1_right_rest = ksl_product_rest(screw_5, exp_g1, exp_alpha_v_2, step_1_right),
      step_1_cross = exp_m_3_cross - exp_alpha_v_2_cross,
      step_1_lo1 = step_1_left_rest - step_1_right_rest, step_1_lo = step_1_lo1 + step_1_cross;
  const double step_2 = exp_m_4 + exp_alpha_v_1, step_2_right = step_2 - exp_m_4,
      step_2_left = step_2 - step_2_right,
      step_2_left_rest = ksl_product_rest(screw_5, exp_beta_v_0, exp_m_4, step_2_left),
      step_2_right_rest = ksl_product_rest(screw_4, exp_g1, exp_alpha_v_1, step_2_right),
      step_2_cross = exp_m_4_cross + exp_alpha_v_1_cross,
      step_2_lo1 = step_2_left_rest + step_2_right_rest, step_2_lo = step_2_lo1 + step_2_cross;
  const double step_3a = KSL_MUL(screw_0, exp_g1), step_3a_cross1 = KSL_MUL(screw_0_lo, exp_g1),
      step_3a_cross2 = KSL_MUL(screw_0, exp_g1_lo), step_3a_cross = step_3a_cross1 + step_3a_cross2,
      step_3 = step_3a + exp_across_axis_0, step_3_right = step_3 - step_3a,
      step_3_left = step_3 - step_3_right,
      step_3_left_rest = ksl_product_rest(screw_0, exp_g1, step_3a, step_3_left),
      step_3_right_rest = exp_across_axis_0 - step_3_right,
      step_3_lo1 = step_3_left_rest + step_3_right_rest,
      step_3_lo2 = step_3_lo1 + exp_across_axis_0_lo, step_3_lo = step_3_lo2 + step_3a_cross;
  const double step_4 = exp_m_3 + exp_alpha_v_2, step_4_right = step_4 - exp_m_3,
      step_4_left = step_4 - step_4_right,
      step_4_left_rest = ksl_product_rest(screw_4, exp_beta_v_0, exp_m_3, step_4_left),
      step_4_right_rest = ksl_product_rest(screw_5, exp_g1, exp_alpha_v_2, step_4_right),
      step_4_cross = exp_m_3_cross + exp_alpha_v_2_cross,
      step_4_lo1 = step_4_left_rest + step_4_right_rest, step_4_lo = step_4_lo1 + step_4_cross;
  const double step_6 = exp_m_5 - exp_alpha_v_0, step_6_right = exp_m_5 - step_6,
      step_6_left = step_6 + step_6_right,
      step_6_left_rest = ksl_product_rest(screw_5, exp_beta_v_1, exp_m_5, step_6_left),
      step_6_right_rest = ksl_product_rest(screw_3, exp_g1, exp_alpha_v_0, step_6_right),
      step_6_cross = exp_m_5_cross - exp_alpha_v_0_cross,
      step_6_lo1 = step_6_left_rest - step_6_right_rest, step_6_lo = step_6_lo1 + step_6_cross;
  const double step_7a = KSL_MUL(screw_1, exp_g1), step_7a_cross1 = KSL_MUL(screw_1_lo, exp_g1),
      step_7a_cross2 = KSL_MUL(screw_1, exp_g1_lo), step_7a_cross = step_7a_cross1 + step_7a_cross2,
      step_7 = step_7a + exp_across_axis_1, step_7_right = step_7 - step_7a,
      step_7_left = step_7 - step_7_right,
      step_7_left_rest = ksl_product_rest(screw_1, exp_g1, step_7a, step_7_left),
      step_7_right_rest = exp_across_axis_1 - step_7_right,
      step_7_lo1 = step_7_left_rest + step_7_right_rest,
      step_7_lo2 = step_7_lo1 + exp_across_axis_1_lo, step_7_lo = step_7_lo2 + step_7a_cross;
  const double step_8 = exp_m_4 - exp_alpha_v_1, step_8_right = exp_m_4 - step_8,
      step_8_left = step_8 + step_8_right,
      step_8_left_rest = ksl_product_rest(screw_5, exp_beta_v_0, exp_m_4, step_8_left),
      step_8_right_rest = ksl_product_rest(screw_4, exp_g1, exp_alpha_v_1, step_8_right),
      step_8_cross = exp_m_4_cross - exp_alpha_v_1_cross,
      step_8_lo1 = step_8_left_rest - step_8_right_rest, step_8_lo = step_8_lo1 + step_8_cross;
  const double step_9 = exp_m_5 + exp_alpha_v_0, step_9_right = step_9 - exp_m_5,
      step_9_left = step_9 - step_9_right,
      step_9_left_rest = ksl_product_rest(screw_5, exp_beta_v_1, exp_m_5, step_9_left),
      step_9_right_rest = ksl_product_rest(screw_3, exp_g1, exp_alpha_v_0, step_9_right),
      step_9_cross = exp_m_5_cross + exp_alpha_v_0_cross,
      step_9_lo1 = step_9_left_rest + step_9_right_rest, step_9_lo = step_9_lo1 + step_9_cross;
  const double step_11a = KSL_MUL(screw_2, exp_g1), step_11a_cross1 = KSL_MUL(screw_2_lo, exp_g1),
      step_11a_cross2 = KSL_MUL(screw_2, exp_g1_lo),
      step_11a_cross = step_11a_cross1 + step_11a_cross2, step_11 = step_11a + exp_across_axis_2,
      step_11_right = step_11 - step_11a, step_11_left = step_11 - step_11_right,
      step_11_left_rest = ksl_product_rest(screw_2, exp_g1, step_11a, step_11_left),
      step_11_right_rest = exp_across_axis_2 - step_11_right,
      step_11_lo1 = step_11_left_rest + step_11_right_rest,
      step_11_lo2 = step_11_lo1 + exp_across_axis_2_lo, step_11_lo = step_11_lo2 + step_11a_cross;
  const double Do_00a = KSL_MUL(D1->m00, exp_diagonal0),
      Do_00a_cross2 = KSL_MUL(D1->m00, exp_diagonal0_lo), Do_00b = KSL_MUL(D1->m01, step_4),
      Do_00b_cross2 = KSL_MUL(D1->m01, step_4_lo), Do_00c = KSL_MUL(D1->m02, step_8),
      Do_00c_cross2 = KSL_MUL(D1->m02, step_8_lo), Do_00d = Do_00b + Do_00c,
      Do_00d_right = Do_00d - Do_00b, Do_00d_left = Do_00d - Do_00d_right,
      Do_00d_left_rest = ksl_product_rest(D1->m01, step_4, Do_00b, Do_00d_left),
      Do_00d_right_rest = ksl_product_rest(D1->m02, step_8, Do_00c, Do_00d_right),
      Do_00d_cross = Do_00b_cross2 + Do_00c_cross2,
      Do_00d_lo1 = Do_00d_left_rest + Do_00d_right_rest, Do_00d_lo = Do_00d_lo1 + Do_00d_cross,
      Do_00 = Do_00a + Do_00d, Do_00_right = Do_00 - Do_00a, Do_00_left = Do_00 - Do_00_right,
      Do_00_left_rest = ksl_product_rest(D1->m00, exp_diagonal0, Do_00a, Do_00_left),
      Do_00_right_rest = Do_00d - Do_00_right, Do_00_lo1 = Do_00_left_rest + Do_00_right_rest,
      Do_00_lo2 = Do_00_lo1 + Do_00d_lo, Do_00_lo = Do_00_lo2 + Do_00a_cross2;
  const double Do_01a = KSL_MUL(D1->m00, step_1), Do_01a_cross2 = KSL_MUL(D1->m00, step_1_lo),
      Do_01b = KSL_MUL(D1->m02, step_9), Do_01b_cross2 = KSL_MUL(D1->m02, step_9_lo),
      Do_01c = Do_01a + Do_01b, Do_01c_right = Do_01c - Do_01a, Do_01c_left = Do_01c - Do_01c_right,
      Do_01c_left_rest = ksl_product_rest(D1->m00, step_1, Do_01a, Do_01c_left),
      Do_01c_right_rest = ksl_product_rest(D1->m02, step_9, Do_01b, Do_01c_right),
      Do_01c_cross = Do_01a_cross2 + Do_01b_cross2,
      Do_01c_lo1 = Do_01c_left_rest + Do_01c_right_rest, Do_01c_lo = Do_01c_lo1 + Do_01c_cross,
      Do_01d = KSL_MUL(D1->m01, exp_diagonal1), Do_01d_cross2 = KSL_MUL(D1->m01, exp_diagonal1_lo),
      Do_01 = Do_01c + Do_01d, Do_01_right = Do_01 - Do_01c, Do_01_left = Do_01 - Do_01_right,
      Do_01_left_rest = Do_01c - Do_01_left,
      Do_01_right_rest = ksl_product_rest(D1->m01, exp_diagonal1, Do_01d, Do_01_right),
      Do_01_lo1 = Do_01_left_rest + Do_01_right_rest, Do_01_lo2 = Do_01_lo1 + Do_01d_cross2,
      Do_01_lo = Do_01_lo2 + Do_01c_lo;
  const double Do_02a = KSL_MUL(D1->m00, step_2), Do_02a_cross2 = KSL_MUL(D1->m00, step_2_lo),
      Do_02b = KSL_MUL(D1->m01, step_6), Do_02b_cross2 = KSL_MUL(D1->m01, step_6_lo),
      Do_02c = Do_02a + Do_02b, Do_02c_right = Do_02c - Do_02a, Do_02c_left = Do_02c - Do_02c_right,
      Do_02c_left_rest = ksl_product_rest(D1->m00, step_2, Do_02a, Do_02c_left),
      Do_02c_right_rest = ksl_product_rest(D1->m01, step_6, Do_02b, Do_02c_right),
      Do_02c_cross = Do_02a_cross2 + Do_02b_cross2,
      Do_02c_lo1 = Do_02c_left_rest + Do_02c_right_rest, Do_02c_lo = Do_02c_lo1 + Do_02c_cross,
      Do_02d = KSL_MUL(D1->m02, exp_diagonal2), Do_02d_cross2 = KSL_MUL(D1->m02, exp_diagonal2_lo),
      Do_02 = Do_02c + Do_02d, Do_02_right = Do_02 - Do_02c, Do_02_left = Do_02 - Do_02_right,
      Do_02_left_rest = Do_02c - Do_02_left,
      Do_02_right_rest = ksl_product_rest(D1->m02, exp_diagonal2, Do_02d, Do_02_right),
      Do_02_lo1 = Do_02_left_rest + Do_02_right_rest, Do_02_lo2 = Do_02_lo1 + Do_02d_cross2,
      Do_02_lo = Do_02_lo2 + Do_02c_lo;
  const double Do_03a = KSL_MUL(D1->m00, step_3), Do_03a_cross2 = KSL_MUL(D1->m00, step_3_lo),
      Do_03b = KSL_MUL(D1->m01, step_7), Do_03b_cross2 = KSL_MUL(D1->m01, step_7_lo),
      Do_03c = Do_03a + Do_03b, Do_03c_right = Do_03c - Do_03a, Do_03c_left = Do_03c - Do_03c_right,
      Do_03c_left_rest = ksl_product_rest(D1->m00, step_3, Do_03a, Do_03c_left),
      Do_03c_right_rest = ksl_product_rest(D1->m01, step_7, Do_03b, Do_03c_right),
      Do_03c_cross = Do_03a_cross2 + Do_03b_cross2,
      Do_03c_lo1 = Do_03c_left_rest + Do_03c_right_rest, Do_03c_lo = Do_03c_lo1 + Do_03c_cross,
      Do_03d = KSL_MUL(D1->m02, step_11), Do_03d_cross2 = KSL_MUL(D1->m02, step_11_lo),
      Do_03e = Do_03c + Do_03d, Do_03e_right = Do_03e - Do_03c, Do_03e_left = Do_03e - Do_03e_right,
      Do_03e_left_rest = Do_03c - Do_03e_left,
      Do_03e_right_rest = ksl_product_rest(D1->m02, step_11, Do_03d, Do_03e_right),
      Do_03e_lo1 = Do_03e_left_rest + Do_03e_right_rest, Do_03e_lo2 = Do_03e_lo1 + Do_03d_cross2,
      Do_03e_lo = Do_03e_lo2 + Do_03c_lo, Do_03 = Do_03e + D1->m03, Do_03_right = Do_03 - Do_03e,
      Do_03_left = Do_03 - Do_03_right, Do_03_left_rest = Do_03e - Do_03_left,
      Do_03_right_rest = D1->m03 - Do_03_right, Do_03_lo1 = Do_03_left_rest + Do_03_right_rest,
      Do_03_lo = Do_03_lo1 + Do_03e_lo;
  const double Do_10a = KSL_MUL(D1->m10, exp_diagonal0),
      Do_10a_cross2 = KSL_MUL(D1->m10, exp_diagonal0_lo), Do_10b = KSL_MUL(D1->m11, step_4),
      Do_10b_cross2 = KSL_MUL(D1->m11, step_4_lo), Do_10c = KSL_MUL(D1->m12, step_8),
      Do_10c_cross2 = KSL_MUL(D1->m12, step_8_lo), Do_10d = Do_10b + Do_10c,
      Do_10d_right = Do_10d - Do_10b, Do_10d_left = Do_10d - Do_10d_right,
      Do_10d_left_rest = ksl_product_rest(D1->m11, step_4, Do_10b, Do_10d_left),
      Do_10d_right_rest = ksl_product_rest(D1->m12, step_8, Do_10c, Do_10d_right),
      Do_10d_cross = Do_10b_cross2 + Do_10c_cross2,
      Do_10d_lo1 = Do_10d_left_rest + Do_10d_right_rest, Do_10d_lo = Do_10d_lo1 + Do_10d_cross,
      Do_10 = Do_10a + Do_10d, Do_10_right = Do_10 - Do_10a, Do_10_left = Do_10 - Do_10_right,
      Do_10_left_rest = ksl_product_rest(D1->m10, exp_diagonal0, Do_10a, Do_10_left),
      Do_10_right_rest = Do_10d - Do_10_right, Do_10_lo1 = Do_10_left_rest + Do_10_right_rest,
      Do_10_lo2 = Do_10_lo1 + Do_10d_lo, Do_10_lo = Do_10_lo2 + Do_10a_cross2;
  const double Do_11a = KSL_MUL(D1->m10, step_1), Do_11a_cross2 = KSL_MUL(D1->m10, step_1_lo),
      Do_11b = KSL_MUL(D1->m12, step_9), Do_11b_cross2 = KSL_MUL(D1->m12, step_9_lo),
      Do_11c = Do_11a + Do_11b, Do_11c_right = Do_11c - Do_11a, Do_11c_left = Do_11c - Do_11c_right,
      Do_11c_left_rest = ksl_product_rest(D1->m10, step_1, Do_11a, Do_11c_left),
      Do_11c_right_rest = ksl_product_rest(D1->m12, step_9, Do_11b, Do_11c_right),
      Do_11c_cross = Do_11a_cross2 + Do_11b_cross2,
      Do_11c_lo1 = Do_11c_left_rest + Do_11c_right_rest, Do_11c_lo = Do_11c_lo1 + Do_11c_cross,
      Do_11d = KSL_MUL(D1->m11, exp_diagonal1), Do_11d_cross2 = KSL_MUL(D1->m11, exp_diagonal1_lo),
      Do_11 = Do_11c + Do_11d, Do_11_right = Do_11 - Do_11c, Do_11_left = Do_11 - Do_11_right,
      Do_11_left_rest = Do_11c - Do_11_left,
      Do_11_right_rest = ksl_product_rest(D1->m11, exp_diagonal1, Do_11d, Do_11_right),
      Do_11_lo1 = Do_11_left_rest + Do_11_right_rest, Do_11_lo2 = Do_11_lo1 + Do_11d_cross2,
      Do_11_lo = Do_11_lo2 + Do_11c_lo;
  const double Do_12a = KSL_MUL(D1->m10, step_2), Do_12a_cross2 = KSL_MUL(D1->m10, step_2_lo),
      Do_12b = KSL_MUL(D1->m11, step_6), Do_12b_cross2 = KSL_MUL(D1->m11, step_6_lo),
      Do_12c = Do_12a + Do_12b, Do_12c_right = Do_12c - Do_12a, Do_12c_left = Do_12c - Do_12c_right,
      Do_12c_left_rest = ksl_product_rest(D1->m10, step_2, Do_12a, Do_12c_left),
      Do_12c_right_rest = ksl_product_rest(D1->m11, step_6, Do_12b, Do_12c_right),
      Do_12c_cross = Do_12a_cross2 + Do_12b_cross2,
      Do_12c_lo1 = Do_12c_left_rest + Do_12c_right_rest, Do_12c_lo = Do_12c_lo1 + Do_12c_cross,
      Do_12d = KSL_MUL(D1->m12, exp_diagonal2), Do_12d_cross2 = KSL_MUL(D1->m12, exp_diagonal2_lo),
      Do_12 = Do_12c + Do_12d, Do_12_right = Do_12 - Do_12c, Do_12_left = Do_12 - Do_12_right,
      Do_12_left_rest = Do_12c - Do_12_left,
      Do_12_right_rest = ksl_product_rest(D1->m12, exp_diagonal2, Do_12d, Do_12_right),
      Do_12_lo1 = Do_12_left_rest + Do_12_right_rest, Do_12_lo2 = Do_12_lo1 + Do_12d_cross2,
      Do_12_lo = Do_12_lo2 + Do_12c_lo;
  const double Do_13a = KSL_MUL(D1->m10, step_3), Do_13a_cross2 = KSL_MUL(D1->m10, step_3_lo),
      Do_13b = KSL_MUL(D1->m11, step_7), Do_13b_cross2 = KSL_MUL(D1->m11, step_7_lo),
      Do_13c = Do_13a + Do_13b, Do_13c_right = Do_13c - Do_13a, Do_13c_left = Do_13c - Do_13c_right,
      Do_13c_left_rest = ksl_product_rest(D1->m10, step_3, Do_13a, Do_13c_left),
      Do_13c_right_rest = ksl_product_rest(D1->m11, step_7, Do_13b, Do_13c_right),
      Do_13c_cross = Do_13a_cross2 + Do_13b_cross2,
      Do_13c_lo1 = Do_13c_left_rest + Do_13c_right_rest, Do_13c_lo = Do_13c_lo1 + Do_13c_cross,
      Do_13d = KSL_MUL(D1->m12, step_11), Do_13d_cross2 = KSL_MUL(D1->m12, step_11_lo),
      Do_13e = Do_13c + Do_13d, Do_13e_right = Do_13e - Do_13c, Do_13e_left = Do_13e - Do_13e_right,
      Do_13e_left_rest = Do_13c - Do_13e_left,
      Do_13e_right_rest = ksl_product_rest(D1->m12, step_11, Do_13d, Do_13e_right),
      Do_13e_lo1 = Do_13e_left_rest + Do_13e_right_rest, Do_13e_lo2 = Do_13e_lo1 + Do_13d_cross2,
      Do_13e_lo = Do_13e_lo2 + Do_13c_lo, Do_13 = Do_13e + D1->m13, Do_13_right = Do_13 - Do_13e,
      Do_13_left = Do_13 - Do_13_right, Do_13_left_rest = Do_13e - Do_13_left,
      Do_13_right_rest = D1->m13 - Do_13_right, Do_13_lo1 = Do_13_left_rest + Do_13_right_rest,
      Do_13_lo = Do_13_lo1 + Do_13e_lo;
  const double Do_20a = KSL_MUL(D1->m20, exp_diagonal0),
      Do_20a_cross2 = KSL_MUL(D1->m20, exp_diagonal0_lo), Do_20b = KSL_MUL(D1->m21, step_4),
      Do_20b_cross2 = KSL_MUL(D1->m21, step_4_lo), Do_20c = KSL_MUL(D1->m22, step_8),
      Do_20c_cross2 = KSL_MUL(D1->m22, step_8_lo), Do_20d = Do_20b + Do_20c,
      Do_20d_right = Do_20d - Do_20b, Do_20d_left = Do_20d - Do_20d_right,
      Do_20d_left_rest = ksl_product_rest(D1->m21, step_4, Do_20b, Do_20d_left),
      Do_20d_right_rest = ksl_product_rest(D1->m22, step_8, Do_20c, Do_20d_right),
      Do_20d_cross = Do_20b_cross2 + Do_20c_cross2,
      Do_20d_lo1 = Do_20d_left_rest + Do_20d_right_rest, Do_20d_lo = Do_20d_lo1 + Do_20d_cross,
      Do_20 = Do_20a + Do_20d, Do_20_right = Do_20 - Do_20a, Do_20_left = Do_20 - Do_20_right,
      Do_20_left_rest = ksl_product_rest(D1->m20, exp_diagonal0, Do_20a, Do_20_left),
      Do_20_right_rest = Do_20d - Do_20_right, Do_20_lo1 = Do_20_left_rest + Do_20_right_rest,
      Do_20_lo2 = Do_20_lo1 + Do_20d_lo, Do_20_lo = Do_20_lo2 + Do_20a_cross2;
  const double Do_21a = KSL_MUL(D1->m20, step_1), Do_21a_cross2 = KSL_MUL(D1->m20, step_1_lo),
      Do_21b = KSL_MUL(D1->m22, step_9), Do_21b_cross2 = KSL_MUL(D1->m22, step_9_lo),
      Do_21c = Do_21a + Do_21b, Do_21c_right = Do_21c - Do_21a, Do_21c_left = Do_21c - Do_21c_right,
      Do_21c_left_rest = ksl_product_rest(D1->m20, step_1, Do_21a, Do_21c_left),
      Do_21c_right_rest = ksl_product_rest(D1->m22, step_9, Do_21b, Do_21c_right),
      Do_21c_cross = Do_21a_cross2 + Do_21b_cross2,
      Do_21c_lo1 = Do_21c_left_rest + Do_21c_right_rest, Do_21c_lo = Do_21c_lo1 + Do_21c_cross,
      Do_21d = KSL_MUL(D1->m21, exp_diagonal1), Do_21d_cross2 = KSL_MUL(D1->m21, exp_diagonal1_lo),
      Do_21 = Do_21c + Do_21d, Do_21_right = Do_21 - Do_21c, Do_21_left = Do_21 - Do_21_right,
      Do_21_left_rest = Do_21c - Do_21_left,
      Do_21_right_rest = ksl_product_rest(D1->m21, exp_diagonal1, Do_21d, Do_21_right),
      Do_21_lo1 = Do_21_left_rest + Do_21_right_rest, Do_21_lo2 = Do_21_lo1 + Do_21d_cross2,
      Do_21_lo = Do_21_lo2 + Do_21c_lo;
  const double Do_22a = KSL_MUL(D1->m20, step_2), Do_22a_cross2 = KSL_MUL(D1->m20, step_2_lo),
      Do_22b = KSL_MUL(D1->m21, step_6), Do_22b_cross2 = KSL_MUL(D1->m21, step_6_lo),
      Do_22c = Do_22a + Do_22b, Do_22c_right = Do_22c - Do_22a, Do_22c_left = Do_22c - Do_22c_right,
      Do_22c_left_rest = ksl_product_rest(D1->m20, step_2, Do_22a, Do_22c_left),
      Do_22c_right_rest = ksl_product_rest(D1->m21, step_6, Do_22b, Do_22c_right),
      Do_22c_cross = Do_22a_cross2 + Do_22b_cross2,
      Do_22c_lo1 = Do_22c_left_rest + Do_22c_right_rest, Do_22c_lo = Do_22c_lo1 + Do_22c_cross,
      Do_22d = KSL_MUL(D1->m22, exp_diagonal2), Do_22d_cross2 = KSL_MUL(D1->m22, exp_diagonal2_lo),
      Do_22 = Do_22c + Do_22d, Do_22_right = Do_22 - Do_22c, Do_22_left = Do_22 - Do_22_right,
      Do_22_left_rest = Do_22c - Do_22_left,
      Do_22_right_rest = ksl_product_rest(D1->m22, exp_diagonal2, Do_22d, Do_22_right),
      Do_22_lo1 = Do_22_left_rest + Do_22_right_rest, Do_22_lo2 = Do_22_lo1 + Do_22d_cross2,
      Do_22_lo = Do_22_lo2 + Do_22c_lo;
  const double Do_23a = KSL_MUL(D1->m20, step_3), Do_23a_cross2 = KSL_MUL(D1->m20, step_3_lo),
      Do_23b = KSL_MUL(D1->m21, step_7), Do_23b_cross2 = KSL_MUL(D1->m21, step_7_lo),
      Do_23c = Do_23a + Do_23b, Do_23c_right = Do_23c - Do_23a, Do_23c_left = Do_23c - Do_23c_right,
      Do_23c_left_rest = ksl_product_rest(D1->m20, step_3, Do_23a, Do_23c_left),
      Do_23c_right_rest = ksl_product_rest(D1->m21, step_7, Do_23b, Do_23c_right),
      Do_23c_cross = Do_23a_cross2 + Do_23b_cross2,
      Do_23c_lo1 = Do_23c_left_rest + Do_23c_right_rest, Do_23c_lo = Do_23c_lo1 + Do_23c_cross,
      Do_23d = KSL_MUL(D1->m22, step_11), Do_23d_cross2 = KSL_MUL(D1->m22, step_11_lo),
      Do_23e = Do_23c + Do_23d, Do_23e_right = Do_23e - Do_23c, Do_23e_left = Do_23e - Do_23e_right,
      Do_23e_left_rest = Do_23c - Do_23e_left,
      Do_23e_right_rest = ksl_product_rest(D1->m22, step_11, Do_23d, Do_23e_right),
      Do_23e_lo1 = Do_23e_left_rest + Do_23e_right_rest, Do_23e_lo2 = Do_23e_lo1 + Do_23d_cross2,
      Do_23e_lo = Do_23e_lo2 + Do_23c_lo, Do_23 = Do_23e + D1->m23, Do_23_right = Do_23 - Do_23e,
      Do_23_left = Do_23 - Do_23_right, Do_23_left_rest = Do_23e - Do_23_left,
      Do_23_right_rest = D1->m23 - Do_23_right, Do_23_lo1 = Do_23_left_rest + Do_23_right_rest,
      Do_23_lo = Do_23_lo1 + Do_23e_lo;
  const double Do_00_rounded = Do_00 + Do_00_lo,
      Do_00_final = Do_00_rounded == Do_00_rounded ? Do_00_rounded : Do_00;
  const double Do_01_rounded = Do_01 + Do_01_lo,
      Do_01_final = Do_01_rounded == Do_01_rounded ? Do_01_rounded : Do_01;
  const double Do_02_rounded = Do_02 + Do_02_lo,
      Do_02_final = Do_02_rounded == Do_02_rounded ? Do_02_rounded : Do_02;
  const double Do_03_rounded = Do_03 + Do_03_lo,
      Do_03_final = Do_03_rounded == Do_03_rounded ? Do_03_rounded : Do_03;
  const double Do_10_rounded = Do_10 + Do_10_lo,
      Do_10_final = Do_10_rounded == Do_10_rounded ? Do_10_rounded : Do_10;
  const double Do_11_rounded = Do_11 + Do_11_lo,
      Do_11_final = Do_11_rounded == Do_11_rounded ? Do_11_rounded : Do_11;
  const double Do_12_rounded = Do_12 + Do_12_lo,
      Do_12_final = Do_12_rounded == Do_12_rounded ? Do_12_rounded : Do_12;
  const double Do_13_rounded = Do_13 + Do_13_lo,
      Do_13_final = Do_13_rounded == Do_13_rounded ? Do_13_rounded : Do_13;
  const double Do_20_rounded = Do_20 + Do_20_lo,
      Do_20_final = Do_20_rounded == Do_20_rounded ? Do_20_rounded : Do_20;
  const double Do_21_rounded = Do_21 + Do_21_lo,
      Do_21_final = Do_21_rounded == Do_21_rounded ? Do_21_rounded : Do_21;
  const double Do_22_rounded = Do_22 + Do_22_lo,
      Do_22_final = Do_22_rounded == Do_22_rounded ? Do_22_rounded : Do_22;
  const double Do_23_rounded = Do_23 + Do_23_lo,
      Do_23_final = Do_23_rounded == Do_23_rounded ? Do_23_rounded : Do_23;
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
  const double halved_0 = 0.5 * (double)v->x;
  const double halved_1 = 0.5 * (double)v->y;
  const double halved_2 = 0.5 * (double)v->z;
  const double h_size_0 = fabs(halved_0);
  const double h_size_1 = fabs(halved_1);
  const double h_size_2 = fabs(halved_2);
  const double h_largest1 = h_size_0 < h_size_1 ? h_size_1 : h_size_0;
  const double h_largest2 = h_largest1 < h_size_2 ? h_size_2 : h_largest1;
  const double s = 4.611686018427388e+18 < h_largest2 ? 2.710505431213761e-20 : 1.0;
  const double reduced_0 = KSL_MUL(halved_0, s);
  const double reduced_1 = KSL_MUL(halved_1, s);
  const double reduced_2 = KSL_MUL(halved_2, s);
  const double up = s < 1.0 ? 3.6893488147419103e+19 : 1.0;
  const double reduced_length_a = KSL_MUL(reduced_0, reduced_0),
      reduced_length_b = KSL_MUL(reduced_1, reduced_1),
      reduced_length_c = reduced_length_a + reduced_length_b,
      reduced_length_d = KSL_MUL(reduced_2, reduced_2),
      reduced_length_e = reduced_length_c + reduced_length_d,
      reduced_length = sqrt(reduced_length_e);
  const double half_angle = KSL_MUL(reduced_length, up);
  const double y = KSL_MUL(half_angle, half_angle);
  double c; const double sine = ksl_sincos(half_angle, &c);
  const double sinc_divisor = half_angle < 1.4901161193847656e-08 ? 1.4901161193847656e-08 :
      half_angle;
  const double sinc_quotient = sine / sinc_divisor;
  const double sinc_a = KSL_MUL(0.16666666666666666, y), sinc_b = 1.0 - sinc_a,
      sinc = half_angle < 1.4901161193847656e-08 ? sinc_b : sinc_quotient;
  const double turning_0 = KSL_MUL((double)v->x, sinc);
  const double turning_1 = KSL_MUL((double)v->y, sinc);
  const double turning_2 = KSL_MUL((double)v->z, sinc);
  const double beta_v_0 = KSL_MUL(0.5, turning_0);
  const double beta_v_1 = KSL_MUL(0.5, turning_1);
  const double beta_v_2 = KSL_MUL(0.5, turning_2);
  const double m_0 = KSL_MUL(turning_0, beta_v_0);
  const double m_1 = KSL_MUL(turning_1, beta_v_1);
  const double m_2 = KSL_MUL(turning_2, beta_v_2);
  const double m_3 = KSL_MUL(turning_1, beta_v_0);
  const double m_4 = KSL_MUL(turning_2, beta_v_0);
  const double m_5 = KSL_MUL(turning_2, beta_v_1);
  const double others_0 = m_1 + m_2;
  const double others_1 = m_0 + m_2;
  const double others_2 = m_0 + m_1;
  const double alpha_v_0 = KSL_MUL(c, turning_0);
  const double alpha_v_1 = KSL_MUL(c, turning_1);
  const double alpha_v_2 = KSL_MUL(c, turning_2);
  const double R_00 = 1.0 - others_0;
  const double R_01 = m_3 - alpha_v_2;
  const double R_02 = m_4 + alpha_v_1;
  const double R_10 = m_3 + alpha_v_2;
  const double R_11 = 1.0 - others_1;
  const double R_12 = m_5 - alpha_v_0;
  const double R_20 = m_4 - alpha_v_1;
  const double R_21 = m_5 + alpha_v_0;
  const double R_22 = 1.0 - others_2;
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

/* R = J_l(v) = I + (1 - cos θ)/θ^2 v~ + (θ - sin θ)/θ^3 v~^2, θ = |v|.
   v: vector; R: rotation or other 3×3 matrix.
   65 mul, 66 add, 2 div, 1 sqrt, 1 abs, 5 less, 7 select.
   Error <= R: 1 u of its largest component for |v| <= 1e13, in single precision 1e5; searched,
     not proved.  Each component is within 1 ulp as long as its condition is below 1e13; in
     single precision it is the nearest number, except near ties, as long as that is below 1e5;
     searched, not proved. */
static inline void ksl_SO3_leftJacobianf_accurate(const ksl_vec3f_t *v, ksl_mat3x3f_t *R) {
  const double halved_0 = 0.5 * (double)v->x;
  const double halved_1 = 0.5 * (double)v->y;
  const double halved_2 = 0.5 * (double)v->z;
  const double y_a = KSL_MUL(halved_0, halved_0), y_b = KSL_MUL(halved_1, halved_1),
      y_c = y_a + y_b, y_d = KSL_MUL(halved_2, halved_2), y = y_c + y_d;
  const double half_angle = sqrt(y);
  double c; const double sine = ksl_sincos(half_angle, &c);
  const double sinc_divisor = half_angle < 1.4901161193847656e-08 ? 1.4901161193847656e-08 :
      half_angle;
  const double sinc_quotient = sine / sinc_divisor;
  const double sinc_a = KSL_MUL(0.16666666666666666, y), sinc_b = 1.0 - sinc_a,
      sinc = half_angle < 1.4901161193847656e-08 ? sinc_b : sinc_quotient;
  const double g1 = KSL_MUL(c, sinc);
  const double g2a = KSL_MUL(sinc, sinc), g2 = KSL_MUL(0.5, g2a);
  const double rest3 = 1.0 - g1;
  const double x = KSL_MUL(4.0, y);
  const double far_x = x < 1.0 ? 1.0 : x;
  const double closed3 = rest3 / far_x;
  const double series5a = KSL_MUL(1.216125041553518e-34, x),
      series5b = 1.1309962886447716e-31 - series5a, series5c = KSL_MUL(x, series5b),
      series5d = series5c - 9.183689863795546e-29, series5e = KSL_MUL(x, series5d),
      series5f = series5e + 6.446950284384474e-26, series5g = KSL_MUL(x, series5f),
      series5h = series5g - 3.868170170630684e-23, series5i = KSL_MUL(x, series5h),
      series5j = series5i + 1.9572941063391263e-20, series5k = KSL_MUL(x, series5j),
      series5l = series5k - 8.22063524662433e-18, series5m = KSL_MUL(x, series5l),
      series5n = series5m + 2.8114572543455206e-15, series5o = KSL_MUL(x, series5n),
      series5p = series5o - 7.647163731819816e-13, series5q = KSL_MUL(x, series5p),
      series5r = series5q + 1.6059043836821613e-10, series5s = KSL_MUL(x, series5r),
      series5t = series5s - 2.505210838544172e-08, series5u = KSL_MUL(x, series5t),
      series5v = series5u + 2.7557319223985893e-06, series5w = KSL_MUL(x, series5v),
      series5x = series5w - 0.0001984126984126984, series5y = KSL_MUL(x, series5x),
      series5 = series5y + 0.008333333333333333;
  const double g3a = KSL_MUL(x, series5), g3b = 0.16666666666666666 - g3a,
      g3 = x < 1.0 ? g3b : closed3;
  const double beta_v_0 = KSL_MUL((double)v->x, g3);
  const double beta_v_1 = KSL_MUL((double)v->y, g3);
  const double beta_v_2 = KSL_MUL((double)v->z, g3);
  const double m_0 = KSL_MUL((double)v->x, beta_v_0);
  const double m_1 = KSL_MUL((double)v->y, beta_v_1);
  const double m_2 = KSL_MUL((double)v->z, beta_v_2);
  const double m_3 = KSL_MUL((double)v->y, beta_v_0);
  const double m_4 = KSL_MUL((double)v->z, beta_v_0);
  const double m_5 = KSL_MUL((double)v->z, beta_v_1);
  const double others_0 = m_1 + m_2;
  const double others_1 = m_0 + m_2;
  const double others_2 = m_0 + m_1;
  const double diagonal0a = 1.0 - others_0, diagonal0b = g1 + m_0,
      diagonal0 = m_0 < others_0 ? diagonal0b : diagonal0a;
  const double diagonal1a = 1.0 - others_1, diagonal1b = g1 + m_1,
      diagonal1 = m_1 < others_1 ? diagonal1b : diagonal1a;
  const double diagonal2a = 1.0 - others_2, diagonal2b = g1 + m_2,
      diagonal2 = m_2 < others_2 ? diagonal2b : diagonal2a;
  const double alpha_v_0 = KSL_MUL((double)v->x, g2);
  const double alpha_v_1 = KSL_MUL((double)v->y, g2);
  const double alpha_v_2 = KSL_MUL((double)v->z, g2);
  const double R_01 = m_3 - alpha_v_2;
  const double R_02 = m_4 + alpha_v_1;
  const double R_10 = m_3 + alpha_v_2;
  const double R_12 = m_5 - alpha_v_0;
  const double R_20 = m_4 - alpha_v_1;
  const double R_21 = m_5 + alpha_v_0;
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
  const double halved_0 = 0.5 * (double)v->x;
  const double halved_1 = 0.5 * (double)v->y;
  const double halved_2 = 0.5 * (double)v->z;
  const double y_a = KSL_MUL(halved_0, halved_0), y_b = KSL_MUL(halved_1, halved_1),
      y_c = y_a + y_b, y_d = KSL_MUL(halved_2, halved_2), y = y_c + y_d;
  const double half_angle = sqrt(y);
  double c; const double sine = ksl_sincos(half_angle, &c);
  const double sinc_divisor = half_angle < 1.4901161193847656e-08 ? 1.4901161193847656e-08 :
      half_angle;
  const double sinc_quotient = sine / sinc_divisor;
  const double sinc_a = KSL_MUL(0.16666666666666666, y), sinc_b = 1.0 - sinc_a,
      sinc = half_angle < 1.4901161193847656e-08 ? sinc_b : sinc_quotient;
  const double g1 = KSL_MUL(c, sinc);
  const double g2a = KSL_MUL(sinc, sinc), g2 = KSL_MUL(0.5, g2a);
  const double rest3 = 1.0 - g1;
  const double x = KSL_MUL(4.0, y);
  const double far_x = x < 1.0 ? 1.0 : x;
  const double closed3 = rest3 / far_x;
  const double series5a = KSL_MUL(1.216125041553518e-34, x),
      series5b = 1.1309962886447716e-31 - series5a, series5c = KSL_MUL(x, series5b),
      series5d = series5c - 9.183689863795546e-29, series5e = KSL_MUL(x, series5d),
      series5f = series5e + 6.446950284384474e-26, series5g = KSL_MUL(x, series5f),
      series5h = series5g - 3.868170170630684e-23, series5i = KSL_MUL(x, series5h),
      series5j = series5i + 1.9572941063391263e-20, series5k = KSL_MUL(x, series5j),
      series5l = series5k - 8.22063524662433e-18, series5m = KSL_MUL(x, series5l),
      series5n = series5m + 2.8114572543455206e-15, series5o = KSL_MUL(x, series5n),
      series5p = series5o - 7.647163731819816e-13, series5q = KSL_MUL(x, series5p),
      series5r = series5q + 1.6059043836821613e-10, series5s = KSL_MUL(x, series5r),
      series5t = series5s - 2.505210838544172e-08, series5u = KSL_MUL(x, series5t),
      series5v = series5u + 2.7557319223985893e-06, series5w = KSL_MUL(x, series5v),
      series5x = series5w - 0.0001984126984126984, series5y = KSL_MUL(x, series5x),
      series5 = series5y + 0.008333333333333333;
  const double g3a = KSL_MUL(x, series5), g3b = 0.16666666666666666 - g3a,
      g3 = x < 1.0 ? g3b : closed3;
  const double beta_v_0 = KSL_MUL((double)v->x, g3);
  const double beta_v_1 = KSL_MUL((double)v->y, g3);
  const double beta_v_2 = KSL_MUL((double)v->z, g3);
  const double m_0 = KSL_MUL((double)v->x, beta_v_0);
  const double m_1 = KSL_MUL((double)v->y, beta_v_1);
  const double m_2 = KSL_MUL((double)v->z, beta_v_2);
  const double m_3 = KSL_MUL((double)v->y, beta_v_0);
  const double m_4 = KSL_MUL((double)v->z, beta_v_0);
  const double m_5 = KSL_MUL((double)v->z, beta_v_1);
  const double others_0 = m_1 + m_2;
  const double others_1 = m_0 + m_2;
  const double others_2 = m_0 + m_1;
  const double diagonal0a = 1.0 - others_0, diagonal0b = g1 + m_0,
      diagonal0 = m_0 < others_0 ? diagonal0b : diagonal0a;
  const double diagonal1a = 1.0 - others_1, diagonal1b = g1 + m_1,
      diagonal1 = m_1 < others_1 ? diagonal1b : diagonal1a;
  const double diagonal2a = 1.0 - others_2, diagonal2b = g1 + m_2,
      diagonal2 = m_2 < others_2 ? diagonal2b : diagonal2a;
  const double alpha_v_0a = KSL_MUL((double)v->x, g2), alpha_v_0 = -alpha_v_0a;
  const double alpha_v_1a = KSL_MUL((double)v->y, g2), alpha_v_1 = -alpha_v_1a;
  const double alpha_v_2a = KSL_MUL((double)v->z, g2), alpha_v_2 = -alpha_v_2a;
  const double R_01 = m_3 - alpha_v_2;
  const double R_02 = m_4 + alpha_v_1;
  const double R_10 = m_3 + alpha_v_2;
  const double R_12 = m_5 - alpha_v_0;
  const double R_20 = m_4 - alpha_v_1;
  const double R_21 = m_5 + alpha_v_0;
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
  const double halved_0 = 0.5 * (double)v->x;
  const double halved_1 = 0.5 * (double)v->y;
  const double halved_2 = 0.5 * (double)v->z;
  const double y_a = KSL_MUL(halved_0, halved_0), y_b = KSL_MUL(halved_1, halved_1),
      y_c = y_a + y_b, y_d = KSL_MUL(halved_2, halved_2), y = y_c + y_d;
  const double half_angle = sqrt(y);
  double c; const double sine = ksl_sincos(half_angle, &c);
  const double sinc_divisor = half_angle < 1.4901161193847656e-08 ? 1.4901161193847656e-08 :
      half_angle;
  const double sinc_quotient = sine / sinc_divisor;
  const double sinc_a = KSL_MUL(0.16666666666666666, y), sinc_b = 1.0 - sinc_a,
      sinc = half_angle < 1.4901161193847656e-08 ? sinc_b : sinc_quotient;
  const double series_phi_a = KSL_MUL(5.107725174524775e-32, y),
      series_phi_b = 4.116826490666969e-29 - series_phi_a, series_phi_c = KSL_MUL(y, series_phi_b),
      series_phi_d = series_phi_c - 2.86531123750421e-26, series_phi_e = KSL_MUL(y, series_phi_d),
      series_phi_f = series_phi_e + 1.701994875077501e-23, series_phi_g = KSL_MUL(y, series_phi_f),
      series_phi_h = series_phi_g - 8.509974375387505e-21, series_phi_i = KSL_MUL(y, series_phi_h),
      series_phi_j = series_phi_i + 3.523129391410427e-18, series_phi_k = KSL_MUL(y, series_phi_j),
      series_phi_l = series_phi_k - 1.1837714755139035e-15, series_phi_m = KSL_MUL(y, series_phi_l),
      series_phi_n = series_phi_m + 3.148832124866983e-13, series_phi_o = KSL_MUL(y, series_phi_n),
      series_phi_p = series_phi_o - 6.423617534728645e-11, series_phi_q = KSL_MUL(y, series_phi_p),
      series_phi_r = series_phi_q + 9.635426302092969e-09, series_phi_s = KSL_MUL(y, series_phi_r),
      series_phi_t = series_phi_s - 1.0020843354176687e-06, series_phi_u = KSL_MUL(y, series_phi_t),
      series_phi_v = series_phi_u + 6.613756613756614e-05, series_phi_w = KSL_MUL(y, series_phi_v),
      series_phi_x = series_phi_w - 0.002380952380952381, series_phi_y = KSL_MUL(y, series_phi_x),
      series_phi = series_phi_y + 0.03333333333333333;
  const double f_more_a = KSL_MUL(2.0, y), f_more = KSL_MUL(f_more_a, series_phi);
  const double near_f_a = KSL_MUL(0.3333333333333333, sinc),
      near_f_b = KSL_MUL(0.3333333333333333, f_more), near_f = near_f_a + near_f_b;
  const double f_rest = sinc - c;
  const double x = KSL_MUL(4.0, y);
  const double far_y = x < 4.0 ? 1.0 : y;
  const double closed_f = f_rest / far_y;
  const double f = x < 4.0 ? near_f : closed_f;
  const double four_k = KSL_MUL(4.0, sinc);
  const double b = f / four_k;
  const double b_across = c / sinc;
  const double beta_v_0 = KSL_MUL((double)v->x, b);
  const double beta_v_1 = KSL_MUL((double)v->y, b);
  const double beta_v_2 = KSL_MUL((double)v->z, b);
  const double m_0 = KSL_MUL((double)v->x, beta_v_0);
  const double m_1 = KSL_MUL((double)v->y, beta_v_1);
  const double m_2 = KSL_MUL((double)v->z, beta_v_2);
  const double m_3 = KSL_MUL((double)v->y, beta_v_0);
  const double m_4 = KSL_MUL((double)v->z, beta_v_0);
  const double m_5 = KSL_MUL((double)v->z, beta_v_1);
  const double others_0 = m_1 + m_2;
  const double others_1 = m_0 + m_2;
  const double others_2 = m_0 + m_1;
  const double diagonal0a = 1.0 - others_0, diagonal0b = b_across + m_0,
      diagonal0 = m_0 < others_0 ? diagonal0b : diagonal0a;
  const double diagonal1a = 1.0 - others_1, diagonal1b = b_across + m_1,
      diagonal1 = m_1 < others_1 ? diagonal1b : diagonal1a;
  const double diagonal2a = 1.0 - others_2, diagonal2b = b_across + m_2,
      diagonal2 = m_2 < others_2 ? diagonal2b : diagonal2a;
  const double alpha_v_0 = -halved_0;
  const double alpha_v_1 = -halved_1;
  const double alpha_v_2 = -halved_2;
  const double R_01 = m_3 - alpha_v_2;
  const double R_02 = m_4 + alpha_v_1;
  const double R_10 = m_3 + alpha_v_2;
  const double R_12 = m_5 - alpha_v_0;
  const double R_20 = m_4 - alpha_v_1;
  const double R_21 = m_5 + alpha_v_0;
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
  const double halved_0 = 0.5 * (double)v->x;
  const double halved_1 = 0.5 * (double)v->y;
  const double halved_2 = 0.5 * (double)v->z;
  const double y_a = KSL_MUL(halved_0, halved_0), y_b = KSL_MUL(halved_1, halved_1),
      y_c = y_a + y_b, y_d = KSL_MUL(halved_2, halved_2), y = y_c + y_d;
  const double half_angle = sqrt(y);
  double c; const double sine = ksl_sincos(half_angle, &c);
  const double sinc_divisor = half_angle < 1.4901161193847656e-08 ? 1.4901161193847656e-08 :
      half_angle;
  const double sinc_quotient = sine / sinc_divisor;
  const double sinc_a = KSL_MUL(0.16666666666666666, y), sinc_b = 1.0 - sinc_a,
      sinc = half_angle < 1.4901161193847656e-08 ? sinc_b : sinc_quotient;
  const double series_phi_a = KSL_MUL(5.107725174524775e-32, y),
      series_phi_b = 4.116826490666969e-29 - series_phi_a, series_phi_c = KSL_MUL(y, series_phi_b),
      series_phi_d = series_phi_c - 2.86531123750421e-26, series_phi_e = KSL_MUL(y, series_phi_d),
      series_phi_f = series_phi_e + 1.701994875077501e-23, series_phi_g = KSL_MUL(y, series_phi_f),
      series_phi_h = series_phi_g - 8.509974375387505e-21, series_phi_i = KSL_MUL(y, series_phi_h),
      series_phi_j = series_phi_i + 3.523129391410427e-18, series_phi_k = KSL_MUL(y, series_phi_j),
      series_phi_l = series_phi_k - 1.1837714755139035e-15, series_phi_m = KSL_MUL(y, series_phi_l),
      series_phi_n = series_phi_m + 3.148832124866983e-13, series_phi_o = KSL_MUL(y, series_phi_n),
      series_phi_p = series_phi_o - 6.423617534728645e-11, series_phi_q = KSL_MUL(y, series_phi_p),
      series_phi_r = series_phi_q + 9.635426302092969e-09, series_phi_s = KSL_MUL(y, series_phi_r),
      series_phi_t = series_phi_s - 1.0020843354176687e-06, series_phi_u = KSL_MUL(y, series_phi_t),
      series_phi_v = series_phi_u + 6.613756613756614e-05, series_phi_w = KSL_MUL(y, series_phi_v),
      series_phi_x = series_phi_w - 0.002380952380952381, series_phi_y = KSL_MUL(y, series_phi_x),
      series_phi = series_phi_y + 0.03333333333333333;
  const double f_more_a = KSL_MUL(2.0, y), f_more = KSL_MUL(f_more_a, series_phi);
  const double near_f_a = KSL_MUL(0.3333333333333333, sinc),
      near_f_b = KSL_MUL(0.3333333333333333, f_more), near_f = near_f_a + near_f_b;
  const double f_rest = sinc - c;
  const double x = KSL_MUL(4.0, y);
  const double far_y = x < 4.0 ? 1.0 : y;
  const double closed_f = f_rest / far_y;
  const double f = x < 4.0 ? near_f : closed_f;
  const double four_k = KSL_MUL(4.0, sinc);
  const double b = f / four_k;
  const double b_across = c / sinc;
  const double beta_v_0 = KSL_MUL((double)v->x, b);
  const double beta_v_1 = KSL_MUL((double)v->y, b);
  const double beta_v_2 = KSL_MUL((double)v->z, b);
  const double m_0 = KSL_MUL((double)v->x, beta_v_0);
  const double m_1 = KSL_MUL((double)v->y, beta_v_1);
  const double m_2 = KSL_MUL((double)v->z, beta_v_2);
  const double m_3 = KSL_MUL((double)v->y, beta_v_0);
  const double m_4 = KSL_MUL((double)v->z, beta_v_0);
  const double m_5 = KSL_MUL((double)v->z, beta_v_1);
  const double others_0 = m_1 + m_2;
  const double others_1 = m_0 + m_2;
  const double others_2 = m_0 + m_1;
  const double diagonal0a = 1.0 - others_0, diagonal0b = b_across + m_0,
      diagonal0 = m_0 < others_0 ? diagonal0b : diagonal0a;
  const double diagonal1a = 1.0 - others_1, diagonal1b = b_across + m_1,
      diagonal1 = m_1 < others_1 ? diagonal1b : diagonal1a;
  const double diagonal2a = 1.0 - others_2, diagonal2b = b_across + m_2,
      diagonal2 = m_2 < others_2 ? diagonal2b : diagonal2a;
  const double R_01 = m_3 - halved_2;
  const double R_02 = halved_1 + m_4;
  const double R_10 = halved_2 + m_3;
  const double R_12 = m_5 - halved_0;
  const double R_20 = m_4 - halved_1;
  const double R_21 = halved_0 + m_5;
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

/* D = exp s = [exp ω~ | J_l(ω) v].
   s: screw (v in m/s; ω in rad/s); D: displacement [R | t], R rotation, t in m.
   86 mul, 78 add, 2 div, 1 sqrt, 1 abs, 5 less, 7 select.
   Error <= R: 1 u, t: 1 u of its largest component, or of s.lin if that is larger, for |ω of s|
     <= 1e13, in single precision 1e5; searched, not proved.  Each component is within 1 ulp as
     long as its condition is below 1e13; in single precision it is the nearest number, except
     near ties, as long as that is below 1e5; searched, not proved.  Intermediate sums may
     overflow where |v|, or |ω| |v|, is above 2e306, in single precision 5e36. */
static inline void ksl_SE3f_exp_accurate(const ksl_screwf_t *s, ksl_SE3f_t *D) {
  const double halved_0 = 0.5 * (double)s->m3;
  const double halved_1 = 0.5 * (double)s->m4;
  const double halved_2 = 0.5 * (double)s->m5;
  const double y_a = KSL_MUL(halved_0, halved_0), y_b = KSL_MUL(halved_1, halved_1),
      y_c = y_a + y_b, y_d = KSL_MUL(halved_2, halved_2), y = y_c + y_d;
  const double half_angle = sqrt(y);
  double c; const double sine = ksl_sincos(half_angle, &c);
  const double sinc_divisor = half_angle < 1.4901161193847656e-08 ? 1.4901161193847656e-08 :
      half_angle;
  const double sinc_quotient = sine / sinc_divisor;
  const double sinc_a = KSL_MUL(0.16666666666666666, y), sinc_b = 1.0 - sinc_a,
      sinc = half_angle < 1.4901161193847656e-08 ? sinc_b : sinc_quotient;
  const double g1 = KSL_MUL(c, sinc);
  const double g2a = KSL_MUL(sinc, sinc), g2 = KSL_MUL(0.5, g2a);
  const double sine_square = KSL_MUL(sine, sine);
  const double g0a = KSL_MUL(2.0, sine_square), g0 = 1.0 - g0a;
  const double rest3 = 1.0 - g1;
  const double x = KSL_MUL(4.0, y);
  const double far_x = x < 1.0 ? 1.0 : x;
  const double closed3 = rest3 / far_x;
  const double series5a = KSL_MUL(1.216125041553518e-34, x),
      series5b = 1.1309962886447716e-31 - series5a, series5c = KSL_MUL(x, series5b),
      series5d = series5c - 9.183689863795546e-29, series5e = KSL_MUL(x, series5d),
      series5f = series5e + 6.446950284384474e-26, series5g = KSL_MUL(x, series5f),
      series5h = series5g - 3.868170170630684e-23, series5i = KSL_MUL(x, series5h),
      series5j = series5i + 1.9572941063391263e-20, series5k = KSL_MUL(x, series5j),
      series5l = series5k - 8.22063524662433e-18, series5m = KSL_MUL(x, series5l),
      series5n = series5m + 2.8114572543455206e-15, series5o = KSL_MUL(x, series5n),
      series5p = series5o - 7.647163731819816e-13, series5q = KSL_MUL(x, series5p),
      series5r = series5q + 1.6059043836821613e-10, series5s = KSL_MUL(x, series5r),
      series5t = series5s - 2.505210838544172e-08, series5u = KSL_MUL(x, series5t),
      series5v = series5u + 2.7557319223985893e-06, series5w = KSL_MUL(x, series5v),
      series5x = series5w - 0.0001984126984126984, series5y = KSL_MUL(x, series5x),
      series5 = series5y + 0.008333333333333333;
  const double g3a = KSL_MUL(x, series5), g3b = 0.16666666666666666 - g3a,
      g3 = x < 1.0 ? g3b : closed3;
  const double u_0a = (double)s->m2 * (double)s->m4,
      u_0 = ksl_product_sum(-(double)s->m1, (double)s->m5, u_0a);
  const double u_1a = (double)s->m0 * (double)s->m5,
      u_1 = ksl_product_sum(-(double)s->m2, (double)s->m3, u_1a);
  const double u_2a = (double)s->m1 * (double)s->m3,
      u_2 = ksl_product_sum(-(double)s->m0, (double)s->m4, u_2a);
  const double turned_0 = KSL_MUL(g2, u_0);
  const double turned_1 = KSL_MUL(g2, u_1);
  const double turned_2 = KSL_MUL(g2, u_2);
  const double wv_a = (double)s->m0 * (double)s->m3,
      wv_c = ksl_product_sum((double)s->m1, (double)s->m4, wv_a),
      wv = ksl_product_sum((double)s->m2, (double)s->m5, wv_c);
  const double pitch = KSL_MUL(g3, wv);
  const double along_0 = KSL_MUL((double)s->m3, pitch);
  const double along_1 = KSL_MUL((double)s->m4, pitch);
  const double along_2 = KSL_MUL((double)s->m5, pitch);
  const double beta_v_0 = KSL_MUL((double)s->m3, g2);
  const double beta_v_1 = KSL_MUL((double)s->m4, g2);
  const double beta_v_2 = KSL_MUL((double)s->m5, g2);
  const double m_0 = KSL_MUL((double)s->m3, beta_v_0);
  const double m_1 = KSL_MUL((double)s->m4, beta_v_1);
  const double m_2 = KSL_MUL((double)s->m5, beta_v_2);
  const double m_3 = KSL_MUL((double)s->m4, beta_v_0);
  const double m_4 = KSL_MUL((double)s->m5, beta_v_0);
  const double m_5 = KSL_MUL((double)s->m5, beta_v_1);
  const double others_0 = m_1 + m_2;
  const double others_1 = m_0 + m_2;
  const double others_2 = m_0 + m_1;
  const double diagonal0a = 1.0 - others_0, diagonal0b = g0 + m_0,
      diagonal0 = m_0 < others_0 ? diagonal0b : diagonal0a;
  const double diagonal1a = 1.0 - others_1, diagonal1b = g0 + m_1,
      diagonal1 = m_1 < others_1 ? diagonal1b : diagonal1a;
  const double diagonal2a = 1.0 - others_2, diagonal2b = g0 + m_2,
      diagonal2 = m_2 < others_2 ? diagonal2b : diagonal2a;
  const double alpha_v_0 = KSL_MUL((double)s->m3, g1);
  const double alpha_v_1 = KSL_MUL((double)s->m4, g1);
  const double alpha_v_2 = KSL_MUL((double)s->m5, g1);
  const double across_axis_0 = turned_0 + along_0;
  const double across_axis_1 = turned_1 + along_1;
  const double across_axis_2 = turned_2 + along_2;
  const double D_01 = m_3 - alpha_v_2;
  const double D_02 = m_4 + alpha_v_1;
  const double D_03a = KSL_MUL((double)s->m0, g1), D_03 = D_03a + across_axis_0;
  const double D_10 = m_3 + alpha_v_2;
  const double D_12 = m_5 - alpha_v_0;
  const double D_13a = KSL_MUL((double)s->m1, g1), D_13 = D_13a + across_axis_1;
  const double D_20 = m_4 - alpha_v_1;
  const double D_21 = m_5 + alpha_v_0;
  const double D_23a = KSL_MUL((double)s->m2, g1), D_23 = D_23a + across_axis_2;
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
  const double p_0 = (double)D->m21 - (double)D->m12;
  const double p_1 = (double)D->m02 - (double)D->m20;
  const double p_2 = (double)D->m10 - (double)D->m01;
  const double s_0 = (double)D->m12 + (double)D->m21;
  const double s_1 = (double)D->m02 + (double)D->m20;
  const double s_2 = (double)D->m01 + (double)D->m10;
  const double first_0 = (double)D->m00 + 1.0;
  const double first_1 = 1.0 - (double)D->m00;
  const double others_0 = (double)D->m11 + (double)D->m22;
  const double others_1 = (double)D->m11 - (double)D->m22;
  const double d_0 = first_0 + others_0;
  const double d_1 = first_0 - others_0;
  const double d_2 = first_1 + others_1;
  const double d_3 = first_1 - others_1;
  const double low_0 = (double)D->m11 < (double)D->m00 ? d_1 : s_2;
  const double low_1 = (double)D->m11 < (double)D->m00 ? s_2 : d_2;
  const double low_2 = (double)D->m11 < (double)D->m00 ? s_1 : s_0;
  const double low_3 = (double)D->m11 < (double)D->m00 ? p_0 : p_1;
  const double high_0a = -(double)D->m11, high_0 = (double)D->m00 < high_0a ? s_1 : p_0;
  const double high_1 = (double)D->m00 < high_0a ? s_0 : p_1;
  const double high_2 = (double)D->m00 < high_0a ? d_3 : p_2;
  const double high_3 = (double)D->m00 < high_0a ? p_2 : d_0;
  const double column_0 = (double)D->m22 < 0.0 ? low_0 : high_0;
  const double column_1 = (double)D->m22 < 0.0 ? low_1 : high_1;
  const double column_2 = (double)D->m22 < 0.0 ? low_2 : high_2;
  const double column_3 = (double)D->m22 < 0.0 ? low_3 : high_3;
  const double upper_0a = -column_0, upper_0 = column_3 < 0.0 ? upper_0a : column_0;
  const double upper_1a = -column_1, upper_1 = column_3 < 0.0 ? upper_1a : column_1;
  const double upper_2a = -column_2, upper_2 = column_3 < 0.0 ? upper_2a : column_2;
  const double upper_3 = fabs(column_3);
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
  const double half_angle = KSL_MUL(0.5, theta);
  const double length_a = KSL_MUL(n, n), length_b = KSL_MUL(upper_3, upper_3),
      length_c = length_a + length_b, length = sqrt(length_c);
  const double sine = n / length;
  const double c = upper_3 / length;
  const double y = KSL_MUL(half_angle, half_angle);
  const double sinc_divisor = half_angle < 1.4901161193847656e-08 ? 1.4901161193847656e-08 :
      half_angle;
  const double sinc_quotient = sine / sinc_divisor;
  const double sinc_a = KSL_MUL(0.16666666666666666, y), sinc_b = 1.0 - sinc_a,
      sinc = half_angle < 1.4901161193847656e-08 ? sinc_b : sinc_quotient;
  const double series_phi_a = KSL_MUL(5.107725174524775e-32, y),
      series_phi_b = 4.116826490666969e-29 - series_phi_a, series_phi_c = KSL_MUL(y, series_phi_b),
      series_phi_d = series_phi_c - 2.86531123750421e-26, series_phi_e = KSL_MUL(y, series_phi_d),
      series_phi_f = series_phi_e + 1.701994875077501e-23, series_phi_g = KSL_MUL(y, series_phi_f),
      series_phi_h = series_phi_g - 8.509974375387505e-21, series_phi_i = KSL_MUL(y, series_phi_h),
      series_phi_j = series_phi_i + 3.523129391410427e-18, series_phi_k = KSL_MUL(y, series_phi_j),
      series_phi_l = series_phi_k - 1.1837714755139035e-15, series_phi_m = KSL_MUL(y, series_phi_l),
      series_phi_n = series_phi_m + 3.148832124866983e-13, series_phi_o = KSL_MUL(y, series_phi_n),
      series_phi_p = series_phi_o - 6.423617534728645e-11, series_phi_q = KSL_MUL(y, series_phi_p),
      series_phi_r = series_phi_q + 9.635426302092969e-09, series_phi_s = KSL_MUL(y, series_phi_r),
      series_phi_t = series_phi_s - 1.0020843354176687e-06, series_phi_u = KSL_MUL(y, series_phi_t),
      series_phi_v = series_phi_u + 6.613756613756614e-05, series_phi_w = KSL_MUL(y, series_phi_v),
      series_phi_x = series_phi_w - 0.002380952380952381, series_phi_y = KSL_MUL(y, series_phi_x),
      series_phi = series_phi_y + 0.03333333333333333;
  const double f_more_a = KSL_MUL(2.0, y), f_more = KSL_MUL(f_more_a, series_phi);
  const double near_f_a = KSL_MUL(0.3333333333333333, sinc),
      near_f_b = KSL_MUL(0.3333333333333333, f_more), near_f = near_f_a + near_f_b;
  const double f_rest = sinc - c;
  const double x = KSL_MUL(4.0, y);
  const double far_y = x < 4.0 ? 1.0 : y;
  const double closed_f = f_rest / far_y;
  const double f = x < 4.0 ? near_f : closed_f;
  const double four_k = KSL_MUL(4.0, sinc);
  const double b = f / four_k;
  const double b_across = c / sinc;
  const double wt_a = KSL_MUL((double)D->m03, vector_0), wt_b = KSL_MUL((double)D->m13, vector_1),
      wt_c = wt_a + wt_b, wt_d = KSL_MUL((double)D->m23, vector_2), wt = wt_c + wt_d;
  const double pitch = KSL_MUL(b, wt);
  const double along_0 = KSL_MUL(vector_0, pitch);
  const double along_1 = KSL_MUL(vector_1, pitch);
  const double along_2 = KSL_MUL(vector_2, pitch);
  const double u_0a = KSL_MUL((double)D->m23, vector_1), u_0b = KSL_MUL((double)D->m13, vector_2),
      u_0 = u_0a - u_0b;
  const double u_1a = KSL_MUL((double)D->m03, vector_2), u_1b = KSL_MUL((double)D->m23, vector_0),
      u_1 = u_1a - u_1b;
  const double u_2a = KSL_MUL((double)D->m13, vector_0), u_2b = KSL_MUL((double)D->m03, vector_1),
      u_2 = u_2a - u_2b;
  const double turned_0 = KSL_MUL(0.5, u_0);
  const double turned_1 = KSL_MUL(0.5, u_1);
  const double turned_2 = KSL_MUL(0.5, u_2);
  const double across_axis_0 = along_0 - turned_0;
  const double across_axis_1 = along_1 - turned_1;
  const double across_axis_2 = along_2 - turned_2;
  const double so_0a = KSL_MUL((double)D->m03, b_across), so_0 = so_0a + across_axis_0;
  const double so_1a = KSL_MUL((double)D->m13, b_across), so_1 = so_1a + across_axis_1;
  const double so_2a = KSL_MUL((double)D->m23, b_across), so_2 = so_2a + across_axis_2;
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
  const double halved_0 = 0.5 * (double)s->m3;
  const double halved_1 = 0.5 * (double)s->m4;
  const double halved_2 = 0.5 * (double)s->m5;
  const double y_a = KSL_MUL(halved_0, halved_0), y_b = KSL_MUL(halved_1, halved_1),
      y_c = y_a + y_b, y_d = KSL_MUL(halved_2, halved_2), y = y_c + y_d;
  const double half_angle = sqrt(y);
  double c; const double sine = ksl_sincos(half_angle, &c);
  const double sinc_divisor = half_angle < 1.4901161193847656e-08 ? 1.4901161193847656e-08 :
      half_angle;
  const double sinc_quotient = sine / sinc_divisor;
  const double sinc_a = KSL_MUL(0.16666666666666666, y), sinc_b = 1.0 - sinc_a,
      sinc = half_angle < 1.4901161193847656e-08 ? sinc_b : sinc_quotient;
  const double g1 = KSL_MUL(c, sinc);
  const double g2a = KSL_MUL(sinc, sinc), g2 = KSL_MUL(0.5, g2a);
  const double rest3 = 1.0 - g1;
  const double x = KSL_MUL(4.0, y);
  const double far_x = x < 1.0 ? 1.0 : x;
  const double closed3 = rest3 / far_x;
  const double series5a = KSL_MUL(1.216125041553518e-34, x),
      series5b = 1.1309962886447716e-31 - series5a, series5c = KSL_MUL(x, series5b),
      series5d = series5c - 9.183689863795546e-29, series5e = KSL_MUL(x, series5d),
      series5f = series5e + 6.446950284384474e-26, series5g = KSL_MUL(x, series5f),
      series5h = series5g - 3.868170170630684e-23, series5i = KSL_MUL(x, series5h),
      series5j = series5i + 1.9572941063391263e-20, series5k = KSL_MUL(x, series5j),
      series5l = series5k - 8.22063524662433e-18, series5m = KSL_MUL(x, series5l),
      series5n = series5m + 2.8114572543455206e-15, series5o = KSL_MUL(x, series5n),
      series5p = series5o - 7.647163731819816e-13, series5q = KSL_MUL(x, series5p),
      series5r = series5q + 1.6059043836821613e-10, series5s = KSL_MUL(x, series5r),
      series5t = series5s - 2.505210838544172e-08, series5u = KSL_MUL(x, series5t),
      series5v = series5u + 2.7557319223985893e-06, series5w = KSL_MUL(x, series5v),
      series5x = series5w - 0.0001984126984126984, series5y = KSL_MUL(x, series5x),
      series5 = series5y + 0.008333333333333333;
  const double g3a = KSL_MUL(x, series5), g3b = 0.16666666666666666 - g3a,
      g3 = x < 1.0 ? g3b : closed3;
  const double rest4 = 0.5 - g2;
  const double closed4 = rest4 / far_x;
  const double rest5 = 0.16666666666666666 - g3;
  const double closed5 = rest5 / far_x;
  const double series4a = KSL_MUL(3.7699876288159054e-33, x),
      series4b = 3.279889237069838e-30 - series4a, series4c = KSL_MUL(x, series4b),
      series4d = series4c - 2.4795962632247976e-27, series4e = KSL_MUL(x, series4d),
      series4f = series4e + 1.6117375710961184e-24, series4g = KSL_MUL(x, series4f),
      series4h = series4g - 8.896791392450574e-22, series4i = KSL_MUL(x, series4h),
      series4j = series4i + 4.110317623312165e-19, series4k = KSL_MUL(x, series4j),
      series4l = series4k - 1.5619206968586225e-16, series4m = KSL_MUL(x, series4l),
      series4n = series4m + 4.779477332387385e-14, series4o = KSL_MUL(x, series4n),
      series4p = series4o - 1.1470745597729725e-11, series4q = KSL_MUL(x, series4p),
      series4r = series4q + 2.08767569878681e-09, series4s = KSL_MUL(x, series4r),
      series4t = series4s - 2.755731922398589e-07, series4u = KSL_MUL(x, series4t),
      series4v = series4u + 2.48015873015873e-05, series4w = KSL_MUL(x, series4v),
      series4x = series4w - 0.001388888888888889, series4y = KSL_MUL(x, series4x),
      series4 = series4y + 0.041666666666666664;
  const double g4 = x < 1.0 ? series4 : closed4;
  const double g5 = x < 1.0 ? series5 : closed5;
  const double rate2a = KSL_MUL(2.0, g4), rate2 = rate2a - g3;
  const double rate3a = KSL_MUL(3.0, g5), rate3 = rate3a - g4;
  const double beta_v_0 = KSL_MUL((double)s->m3, g3);
  const double beta_v_1 = KSL_MUL((double)s->m4, g3);
  const double beta_v_2 = KSL_MUL((double)s->m5, g3);
  const double m_0 = KSL_MUL((double)s->m3, beta_v_0);
  const double m_1 = KSL_MUL((double)s->m4, beta_v_1);
  const double m_2 = KSL_MUL((double)s->m5, beta_v_2);
  const double m_3 = KSL_MUL((double)s->m4, beta_v_0);
  const double m_4 = KSL_MUL((double)s->m5, beta_v_0);
  const double m_5 = KSL_MUL((double)s->m5, beta_v_1);
  const double others_0 = m_1 + m_2;
  const double others_1 = m_0 + m_2;
  const double others_2 = m_0 + m_1;
  const double diagonal0a = 1.0 - others_0, diagonal0b = g1 + m_0,
      diagonal0 = m_0 < others_0 ? diagonal0b : diagonal0a;
  const double diagonal1a = 1.0 - others_1, diagonal1b = g1 + m_1,
      diagonal1 = m_1 < others_1 ? diagonal1b : diagonal1a;
  const double diagonal2a = 1.0 - others_2, diagonal2b = g1 + m_2,
      diagonal2 = m_2 < others_2 ? diagonal2b : diagonal2a;
  const double alpha_v_0 = KSL_MUL((double)s->m3, g2);
  const double alpha_v_1 = KSL_MUL((double)s->m4, g2);
  const double alpha_v_2 = KSL_MUL((double)s->m5, g2);
  const double J_1 = m_3 - alpha_v_2;
  const double J_2 = m_4 + alpha_v_1;
  const double J_3 = m_3 + alpha_v_2;
  const double J_5 = m_5 - alpha_v_0;
  const double J_6 = m_4 - alpha_v_1;
  const double J_7 = m_5 + alpha_v_0;
  const double rate_vw_a = (double)s->m0 * (double)s->m3,
      rate_vw_c = ksl_product_sum((double)s->m1, (double)s->m4, rate_vw_a),
      rate_vw = ksl_product_sum((double)s->m2, (double)s->m5, rate_vw_c);
  const double rate_turn = KSL_MUL(rate2, rate_vw);
  const double rate_bend_a = KSL_MUL(rate3, rate_vw), rate_bend = -rate_bend_a;
  const double rate_q_0a = KSL_MUL((double)s->m0, g2),
      rate_q_0b = KSL_MUL((double)s->m3, rate_turn), rate_q_0 = rate_q_0a + rate_q_0b;
  const double rate_q_1a = KSL_MUL((double)s->m1, g2),
      rate_q_1b = KSL_MUL((double)s->m4, rate_turn), rate_q_1 = rate_q_1a + rate_q_1b;
  const double rate_q_2a = KSL_MUL((double)s->m2, g2),
      rate_q_2b = KSL_MUL((double)s->m5, rate_turn), rate_q_2 = rate_q_2a + rate_q_2b;
  const double rate_beta_v_0 = KSL_MUL((double)s->m0, g3);
  const double rate_beta_v_1 = KSL_MUL((double)s->m1, g3);
  const double rate_beta_v_2 = KSL_MUL((double)s->m2, g3);
  const double rate_bend_w_0 = KSL_MUL((double)s->m3, rate_bend);
  const double rate_bend_w_1 = KSL_MUL((double)s->m4, rate_bend);
  const double rate_bend_w_2 = KSL_MUL((double)s->m5, rate_bend);
  const double rate_symmetric_0a = KSL_MUL((double)s->m3, rate_beta_v_1),
      rate_symmetric_0b = KSL_MUL((double)s->m4, rate_beta_v_0),
      rate_symmetric_0c = rate_symmetric_0a + rate_symmetric_0b,
      rate_symmetric_0d = KSL_MUL((double)s->m4, rate_bend_w_0),
      rate_symmetric_0 = rate_symmetric_0c - rate_symmetric_0d;
  const double rate_symmetric_1a = KSL_MUL((double)s->m3, rate_beta_v_2),
      rate_symmetric_1b = KSL_MUL((double)s->m5, rate_beta_v_0),
      rate_symmetric_1c = rate_symmetric_1a + rate_symmetric_1b,
      rate_symmetric_1d = KSL_MUL((double)s->m5, rate_bend_w_0),
      rate_symmetric_1 = rate_symmetric_1c - rate_symmetric_1d;
  const double rate_symmetric_2a = KSL_MUL((double)s->m4, rate_beta_v_2),
      rate_symmetric_2b = KSL_MUL((double)s->m5, rate_beta_v_1),
      rate_symmetric_2c = rate_symmetric_2a + rate_symmetric_2b,
      rate_symmetric_2d = KSL_MUL((double)s->m5, rate_bend_w_1),
      rate_symmetric_2 = rate_symmetric_2c - rate_symmetric_2d;
  const double rate_diagonal_0a = KSL_MUL((double)s->m4, rate_bend_w_1),
      rate_diagonal_0b = KSL_MUL((double)s->m5, rate_bend_w_2),
      rate_diagonal_0c = rate_diagonal_0a + rate_diagonal_0b,
      rate_diagonal_0d = 2.0 * (double)s->m4,
      rate_diagonal_0e = KSL_MUL(rate_diagonal_0d, rate_beta_v_1),
      rate_diagonal_0f = 2.0 * (double)s->m5,
      rate_diagonal_0g = KSL_MUL(rate_diagonal_0f, rate_beta_v_2),
      rate_diagonal_0h = rate_diagonal_0e + rate_diagonal_0g,
      rate_diagonal_0 = rate_diagonal_0c - rate_diagonal_0h;
  const double rate_diagonal_1a = KSL_MUL((double)s->m3, rate_bend_w_0),
      rate_diagonal_1b = rate_diagonal_1a + rate_diagonal_0b,
      rate_diagonal_1c = 2.0 * (double)s->m3,
      rate_diagonal_1d = KSL_MUL(rate_diagonal_1c, rate_beta_v_0),
      rate_diagonal_1e = rate_diagonal_1d + rate_diagonal_0g,
      rate_diagonal_1 = rate_diagonal_1b - rate_diagonal_1e;
  const double rate_diagonal_2a = rate_diagonal_1a + rate_diagonal_0a,
      rate_diagonal_2b = rate_diagonal_1d + rate_diagonal_0e,
      rate_diagonal_2 = rate_diagonal_2a - rate_diagonal_2b;
  const double M_04 = rate_symmetric_0 - rate_q_2;
  const double M_05 = rate_q_1 + rate_symmetric_1;
  const double M_13 = rate_q_2 + rate_symmetric_0;
  const double M_15 = rate_symmetric_2 - rate_q_0;
  const double M_23 = rate_symmetric_1 - rate_q_1;
  const double M_24 = rate_q_0 + rate_symmetric_2;
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
  const double halved_0 = 0.5 * (double)s->m3;
  const double halved_1 = 0.5 * (double)s->m4;
  const double halved_2 = 0.5 * (double)s->m5;
  const double y_a = KSL_MUL(halved_0, halved_0), y_b = KSL_MUL(halved_1, halved_1),
      y_c = y_a + y_b, y_d = KSL_MUL(halved_2, halved_2), y = y_c + y_d;
  const double half_angle = sqrt(y);
  double c; const double sine = ksl_sincos(half_angle, &c);
  const double sinc_divisor = half_angle < 1.4901161193847656e-08 ? 1.4901161193847656e-08 :
      half_angle;
  const double sinc_quotient = sine / sinc_divisor;
  const double sinc_a = KSL_MUL(0.16666666666666666, y), sinc_b = 1.0 - sinc_a,
      sinc = half_angle < 1.4901161193847656e-08 ? sinc_b : sinc_quotient;
  const double g1 = KSL_MUL(c, sinc);
  const double g2a = KSL_MUL(sinc, sinc), g2 = KSL_MUL(0.5, g2a);
  const double rest3 = 1.0 - g1;
  const double x = KSL_MUL(4.0, y);
  const double far_x = x < 1.0 ? 1.0 : x;
  const double closed3 = rest3 / far_x;
  const double series5a = KSL_MUL(1.216125041553518e-34, x),
      series5b = 1.1309962886447716e-31 - series5a, series5c = KSL_MUL(x, series5b),
      series5d = series5c - 9.183689863795546e-29, series5e = KSL_MUL(x, series5d),
      series5f = series5e + 6.446950284384474e-26, series5g = KSL_MUL(x, series5f),
      series5h = series5g - 3.868170170630684e-23, series5i = KSL_MUL(x, series5h),
      series5j = series5i + 1.9572941063391263e-20, series5k = KSL_MUL(x, series5j),
      series5l = series5k - 8.22063524662433e-18, series5m = KSL_MUL(x, series5l),
      series5n = series5m + 2.8114572543455206e-15, series5o = KSL_MUL(x, series5n),
      series5p = series5o - 7.647163731819816e-13, series5q = KSL_MUL(x, series5p),
      series5r = series5q + 1.6059043836821613e-10, series5s = KSL_MUL(x, series5r),
      series5t = series5s - 2.505210838544172e-08, series5u = KSL_MUL(x, series5t),
      series5v = series5u + 2.7557319223985893e-06, series5w = KSL_MUL(x, series5v),
      series5x = series5w - 0.0001984126984126984, series5y = KSL_MUL(x, series5x),
      series5 = series5y + 0.008333333333333333;
  const double g3a = KSL_MUL(x, series5), g3b = 0.16666666666666666 - g3a,
      g3 = x < 1.0 ? g3b : closed3;
  const double rest4 = 0.5 - g2;
  const double closed4 = rest4 / far_x;
  const double rest5 = 0.16666666666666666 - g3;
  const double closed5 = rest5 / far_x;
  const double series4a = KSL_MUL(3.7699876288159054e-33, x),
      series4b = 3.279889237069838e-30 - series4a, series4c = KSL_MUL(x, series4b),
      series4d = series4c - 2.4795962632247976e-27, series4e = KSL_MUL(x, series4d),
      series4f = series4e + 1.6117375710961184e-24, series4g = KSL_MUL(x, series4f),
      series4h = series4g - 8.896791392450574e-22, series4i = KSL_MUL(x, series4h),
      series4j = series4i + 4.110317623312165e-19, series4k = KSL_MUL(x, series4j),
      series4l = series4k - 1.5619206968586225e-16, series4m = KSL_MUL(x, series4l),
      series4n = series4m + 4.779477332387385e-14, series4o = KSL_MUL(x, series4n),
      series4p = series4o - 1.1470745597729725e-11, series4q = KSL_MUL(x, series4p),
      series4r = series4q + 2.08767569878681e-09, series4s = KSL_MUL(x, series4r),
      series4t = series4s - 2.755731922398589e-07, series4u = KSL_MUL(x, series4t),
      series4v = series4u + 2.48015873015873e-05, series4w = KSL_MUL(x, series4v),
      series4x = series4w - 0.001388888888888889, series4y = KSL_MUL(x, series4x),
      series4 = series4y + 0.041666666666666664;
  const double g4 = x < 1.0 ? series4 : closed4;
  const double g5 = x < 1.0 ? series5 : closed5;
  const double rate2a = KSL_MUL(2.0, g4), rate2 = rate2a - g3;
  const double rate3a = KSL_MUL(3.0, g5), rate3 = rate3a - g4;
  const double beta_v_0 = KSL_MUL((double)s->m3, g3);
  const double beta_v_1 = KSL_MUL((double)s->m4, g3);
  const double beta_v_2 = KSL_MUL((double)s->m5, g3);
  const double m_0 = KSL_MUL((double)s->m3, beta_v_0);
  const double m_1 = KSL_MUL((double)s->m4, beta_v_1);
  const double m_2 = KSL_MUL((double)s->m5, beta_v_2);
  const double m_3 = KSL_MUL((double)s->m4, beta_v_0);
  const double m_4 = KSL_MUL((double)s->m5, beta_v_0);
  const double m_5 = KSL_MUL((double)s->m5, beta_v_1);
  const double others_0 = m_1 + m_2;
  const double others_1 = m_0 + m_2;
  const double others_2 = m_0 + m_1;
  const double diagonal0a = 1.0 - others_0, diagonal0b = g1 + m_0,
      diagonal0 = m_0 < others_0 ? diagonal0b : diagonal0a;
  const double diagonal1a = 1.0 - others_1, diagonal1b = g1 + m_1,
      diagonal1 = m_1 < others_1 ? diagonal1b : diagonal1a;
  const double diagonal2a = 1.0 - others_2, diagonal2b = g1 + m_2,
      diagonal2 = m_2 < others_2 ? diagonal2b : diagonal2a;
  const double alpha_v_0a = KSL_MUL((double)s->m3, g2), alpha_v_0 = -alpha_v_0a;
  const double alpha_v_1a = KSL_MUL((double)s->m4, g2), alpha_v_1 = -alpha_v_1a;
  const double alpha_v_2a = KSL_MUL((double)s->m5, g2), alpha_v_2 = -alpha_v_2a;
  const double J_1 = m_3 - alpha_v_2;
  const double J_2 = m_4 + alpha_v_1;
  const double J_3 = m_3 + alpha_v_2;
  const double J_5 = m_5 - alpha_v_0;
  const double J_6 = m_4 - alpha_v_1;
  const double J_7 = m_5 + alpha_v_0;
  const double rate_vw_a = (double)s->m0 * (double)s->m3,
      rate_vw_c = ksl_product_sum((double)s->m1, (double)s->m4, rate_vw_a),
      rate_vw = ksl_product_sum((double)s->m2, (double)s->m5, rate_vw_c);
  const double rate_turn = KSL_MUL(rate2, rate_vw);
  const double rate_bend_a = KSL_MUL(rate3, rate_vw), rate_bend = -rate_bend_a;
  const double rate_q_0a = KSL_MUL((double)s->m0, g2),
      rate_q_0b = KSL_MUL((double)s->m3, rate_turn), rate_q_0c_lead = -rate_q_0a,
      rate_q_0 = rate_q_0c_lead - rate_q_0b;
  const double rate_q_1a = KSL_MUL((double)s->m1, g2),
      rate_q_1b = KSL_MUL((double)s->m4, rate_turn), rate_q_1c_lead = -rate_q_1a,
      rate_q_1 = rate_q_1c_lead - rate_q_1b;
  const double rate_q_2a = KSL_MUL((double)s->m2, g2),
      rate_q_2b = KSL_MUL((double)s->m5, rate_turn), rate_q_2c_lead = -rate_q_2a,
      rate_q_2 = rate_q_2c_lead - rate_q_2b;
  const double rate_beta_v_0a = KSL_MUL((double)s->m0, g3), rate_beta_v_0 = -rate_beta_v_0a;
  const double rate_beta_v_1a = KSL_MUL((double)s->m1, g3), rate_beta_v_1 = -rate_beta_v_1a;
  const double rate_beta_v_2a = KSL_MUL((double)s->m2, g3), rate_beta_v_2 = -rate_beta_v_2a;
  const double rate_bend_w_0a = KSL_MUL((double)s->m3, rate_bend), rate_bend_w_0 = -rate_bend_w_0a;
  const double rate_bend_w_1a = KSL_MUL((double)s->m4, rate_bend), rate_bend_w_1 = -rate_bend_w_1a;
  const double rate_bend_w_2a = KSL_MUL((double)s->m5, rate_bend), rate_bend_w_2 = -rate_bend_w_2a;
  const double rate_symmetric_0a = KSL_MUL((double)s->m4, rate_bend_w_0),
      rate_symmetric_0b = KSL_MUL((double)s->m3, rate_beta_v_1),
      rate_symmetric_0c = KSL_MUL((double)s->m4, rate_beta_v_0),
      rate_symmetric_0d_lead = -rate_symmetric_0b,
      rate_symmetric_0d = rate_symmetric_0d_lead - rate_symmetric_0c,
      rate_symmetric_0 = rate_symmetric_0d + rate_symmetric_0a;
  const double rate_symmetric_1a = KSL_MUL((double)s->m5, rate_bend_w_0),
      rate_symmetric_1b = KSL_MUL((double)s->m3, rate_beta_v_2),
      rate_symmetric_1c = KSL_MUL((double)s->m5, rate_beta_v_0),
      rate_symmetric_1d_lead = -rate_symmetric_1b,
      rate_symmetric_1d = rate_symmetric_1d_lead - rate_symmetric_1c,
      rate_symmetric_1 = rate_symmetric_1d + rate_symmetric_1a;
  const double rate_symmetric_2a = KSL_MUL((double)s->m5, rate_bend_w_1),
      rate_symmetric_2b = KSL_MUL((double)s->m4, rate_beta_v_2),
      rate_symmetric_2c = KSL_MUL((double)s->m5, rate_beta_v_1),
      rate_symmetric_2d_lead = -rate_symmetric_2b,
      rate_symmetric_2d = rate_symmetric_2d_lead - rate_symmetric_2c,
      rate_symmetric_2 = rate_symmetric_2d + rate_symmetric_2a;
  const double rate_diagonal_0a = 2.0 * (double)s->m4,
      rate_diagonal_0b = KSL_MUL(rate_diagonal_0a, rate_beta_v_1),
      rate_diagonal_0c = 2.0 * (double)s->m5,
      rate_diagonal_0d = KSL_MUL(rate_diagonal_0c, rate_beta_v_2),
      rate_diagonal_0e = rate_diagonal_0b + rate_diagonal_0d,
      rate_diagonal_0f = KSL_MUL((double)s->m4, rate_bend_w_1),
      rate_diagonal_0g = KSL_MUL((double)s->m5, rate_bend_w_2),
      rate_diagonal_0h = rate_diagonal_0f + rate_diagonal_0g,
      rate_diagonal_0 = rate_diagonal_0e - rate_diagonal_0h;
  const double rate_diagonal_1a = 2.0 * (double)s->m3,
      rate_diagonal_1b = KSL_MUL(rate_diagonal_1a, rate_beta_v_0),
      rate_diagonal_1c = rate_diagonal_1b + rate_diagonal_0d,
      rate_diagonal_1d = KSL_MUL((double)s->m3, rate_bend_w_0),
      rate_diagonal_1e = rate_diagonal_1d + rate_diagonal_0g,
      rate_diagonal_1 = rate_diagonal_1c - rate_diagonal_1e;
  const double rate_diagonal_2a = rate_diagonal_1b + rate_diagonal_0b,
      rate_diagonal_2b = rate_diagonal_1d + rate_diagonal_0f,
      rate_diagonal_2 = rate_diagonal_2a - rate_diagonal_2b;
  const double M_04 = rate_symmetric_0 - rate_q_2;
  const double M_05 = rate_q_1 + rate_symmetric_1;
  const double M_13 = rate_q_2 + rate_symmetric_0;
  const double M_15 = rate_symmetric_2 - rate_q_0;
  const double M_23 = rate_symmetric_1 - rate_q_1;
  const double M_24 = rate_q_0 + rate_symmetric_2;
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
  const double halved_0 = 0.5 * (double)s->m3;
  const double halved_1 = 0.5 * (double)s->m4;
  const double halved_2 = 0.5 * (double)s->m5;
  const double y_a = KSL_MUL(halved_0, halved_0), y_b = KSL_MUL(halved_1, halved_1),
      y_c = y_a + y_b, y_d = KSL_MUL(halved_2, halved_2), y = y_c + y_d;
  const double half_angle = sqrt(y);
  double c; const double sine = ksl_sincos(half_angle, &c);
  const double sinc_divisor = half_angle < 1.4901161193847656e-08 ? 1.4901161193847656e-08 :
      half_angle;
  const double sinc_quotient = sine / sinc_divisor;
  const double sinc_a = KSL_MUL(0.16666666666666666, y), sinc_b = 1.0 - sinc_a,
      sinc = half_angle < 1.4901161193847656e-08 ? sinc_b : sinc_quotient;
  const double series_phi_a = KSL_MUL(5.107725174524775e-32, y),
      series_phi_b = 4.116826490666969e-29 - series_phi_a, series_phi_c = KSL_MUL(y, series_phi_b),
      series_phi_d = series_phi_c - 2.86531123750421e-26, series_phi_e = KSL_MUL(y, series_phi_d),
      series_phi_f = series_phi_e + 1.701994875077501e-23, series_phi_g = KSL_MUL(y, series_phi_f),
      series_phi_h = series_phi_g - 8.509974375387505e-21, series_phi_i = KSL_MUL(y, series_phi_h),
      series_phi_j = series_phi_i + 3.523129391410427e-18, series_phi_k = KSL_MUL(y, series_phi_j),
      series_phi_l = series_phi_k - 1.1837714755139035e-15, series_phi_m = KSL_MUL(y, series_phi_l),
      series_phi_n = series_phi_m + 3.148832124866983e-13, series_phi_o = KSL_MUL(y, series_phi_n),
      series_phi_p = series_phi_o - 6.423617534728645e-11, series_phi_q = KSL_MUL(y, series_phi_p),
      series_phi_r = series_phi_q + 9.635426302092969e-09, series_phi_s = KSL_MUL(y, series_phi_r),
      series_phi_t = series_phi_s - 1.0020843354176687e-06, series_phi_u = KSL_MUL(y, series_phi_t),
      series_phi_v = series_phi_u + 6.613756613756614e-05, series_phi_w = KSL_MUL(y, series_phi_v),
      series_phi_x = series_phi_w - 0.002380952380952381, series_phi_y = KSL_MUL(y, series_phi_x),
      series_phi = series_phi_y + 0.03333333333333333;
  const double f_more_a = KSL_MUL(2.0, y), f_more = KSL_MUL(f_more_a, series_phi);
  const double near_f_a = KSL_MUL(0.3333333333333333, sinc),
      near_f_b = KSL_MUL(0.3333333333333333, f_more), near_f = near_f_a + near_f_b;
  const double f_rest = sinc - c;
  const double x = KSL_MUL(4.0, y);
  const double far_y = x < 4.0 ? 1.0 : y;
  const double closed_f = f_rest / far_y;
  const double f = x < 4.0 ? near_f : closed_f;
  const double four_k = KSL_MUL(4.0, sinc);
  const double b = f / four_k;
  const double b_across = c / sinc;
  const double beta_v_0 = KSL_MUL((double)s->m3, b);
  const double beta_v_1 = KSL_MUL((double)s->m4, b);
  const double beta_v_2 = KSL_MUL((double)s->m5, b);
  const double m_0 = KSL_MUL((double)s->m3, beta_v_0);
  const double m_1 = KSL_MUL((double)s->m4, beta_v_1);
  const double m_2 = KSL_MUL((double)s->m5, beta_v_2);
  const double m_3 = KSL_MUL((double)s->m4, beta_v_0);
  const double m_4 = KSL_MUL((double)s->m5, beta_v_0);
  const double m_5 = KSL_MUL((double)s->m5, beta_v_1);
  const double others_0 = m_1 + m_2;
  const double others_1 = m_0 + m_2;
  const double others_2 = m_0 + m_1;
  const double diagonal0a = 1.0 - others_0, diagonal0b = b_across + m_0,
      diagonal0 = m_0 < others_0 ? diagonal0b : diagonal0a;
  const double diagonal1a = 1.0 - others_1, diagonal1b = b_across + m_1,
      diagonal1 = m_1 < others_1 ? diagonal1b : diagonal1a;
  const double diagonal2a = 1.0 - others_2, diagonal2b = b_across + m_2,
      diagonal2 = m_2 < others_2 ? diagonal2b : diagonal2a;
  const double alpha_v_0 = -halved_0;
  const double alpha_v_1 = -halved_1;
  const double alpha_v_2 = -halved_2;
  const double J_1 = m_3 - alpha_v_2;
  const double J_2 = m_4 + alpha_v_1;
  const double J_3 = m_3 + alpha_v_2;
  const double J_5 = m_5 - alpha_v_0;
  const double J_6 = m_4 - alpha_v_1;
  const double J_7 = m_5 + alpha_v_0;
  const double phi_rest_a = KSL_MUL(3.0, f), phi_rest = phi_rest_a - sinc;
  const double twice_y = KSL_MUL(2.0, far_y);
  const double closed_phi = phi_rest / twice_y;
  const double phi = x < 4.0 ? series_phi : closed_phi;
  const double b_rate_above_a = KSL_MUL(f, f), b_rate_above_b = KSL_MUL(0.5, b_rate_above_a),
      b_rate_above_c = KSL_MUL(sinc, phi), b_rate_above = b_rate_above_b - b_rate_above_c;
  const double b_rate_below_a = KSL_MUL(sinc, sinc), b_rate_below = KSL_MUL(8.0, b_rate_below_a);
  const double b_rate = b_rate_above / b_rate_below;
  const double rate_vw_a = (double)s->m0 * (double)s->m3,
      rate_vw_c = ksl_product_sum((double)s->m1, (double)s->m4, rate_vw_a),
      rate_vw = ksl_product_sum((double)s->m2, (double)s->m5, rate_vw_c);
  const double rate_bend_a = KSL_MUL(b_rate, rate_vw), rate_bend = -rate_bend_a;
  const double rate_q_0a = 0.5 * (double)s->m0, rate_q_0 = -rate_q_0a;
  const double rate_q_1a = 0.5 * (double)s->m1, rate_q_1 = -rate_q_1a;
  const double rate_q_2a = 0.5 * (double)s->m2, rate_q_2 = -rate_q_2a;
  const double rate_beta_v_0 = KSL_MUL((double)s->m0, b);
  const double rate_beta_v_1 = KSL_MUL((double)s->m1, b);
  const double rate_beta_v_2 = KSL_MUL((double)s->m2, b);
  const double rate_bend_w_0 = KSL_MUL((double)s->m3, rate_bend);
  const double rate_bend_w_1 = KSL_MUL((double)s->m4, rate_bend);
  const double rate_bend_w_2 = KSL_MUL((double)s->m5, rate_bend);
  const double rate_symmetric_0a = KSL_MUL((double)s->m3, rate_beta_v_1),
      rate_symmetric_0b = KSL_MUL((double)s->m4, rate_beta_v_0),
      rate_symmetric_0c = rate_symmetric_0a + rate_symmetric_0b,
      rate_symmetric_0d = KSL_MUL((double)s->m4, rate_bend_w_0),
      rate_symmetric_0 = rate_symmetric_0c - rate_symmetric_0d;
  const double rate_symmetric_1a = KSL_MUL((double)s->m3, rate_beta_v_2),
      rate_symmetric_1b = KSL_MUL((double)s->m5, rate_beta_v_0),
      rate_symmetric_1c = rate_symmetric_1a + rate_symmetric_1b,
      rate_symmetric_1d = KSL_MUL((double)s->m5, rate_bend_w_0),
      rate_symmetric_1 = rate_symmetric_1c - rate_symmetric_1d;
  const double rate_symmetric_2a = KSL_MUL((double)s->m4, rate_beta_v_2),
      rate_symmetric_2b = KSL_MUL((double)s->m5, rate_beta_v_1),
      rate_symmetric_2c = rate_symmetric_2a + rate_symmetric_2b,
      rate_symmetric_2d = KSL_MUL((double)s->m5, rate_bend_w_1),
      rate_symmetric_2 = rate_symmetric_2c - rate_symmetric_2d;
  const double rate_diagonal_0a = KSL_MUL((double)s->m4, rate_bend_w_1),
      rate_diagonal_0b = KSL_MUL((double)s->m5, rate_bend_w_2),
      rate_diagonal_0c = rate_diagonal_0a + rate_diagonal_0b,
      rate_diagonal_0d = 2.0 * (double)s->m4,
      rate_diagonal_0e = KSL_MUL(rate_diagonal_0d, rate_beta_v_1),
      rate_diagonal_0f = 2.0 * (double)s->m5,
      rate_diagonal_0g = KSL_MUL(rate_diagonal_0f, rate_beta_v_2),
      rate_diagonal_0h = rate_diagonal_0e + rate_diagonal_0g,
      rate_diagonal_0 = rate_diagonal_0c - rate_diagonal_0h;
  const double rate_diagonal_1a = KSL_MUL((double)s->m3, rate_bend_w_0),
      rate_diagonal_1b = rate_diagonal_1a + rate_diagonal_0b,
      rate_diagonal_1c = 2.0 * (double)s->m3,
      rate_diagonal_1d = KSL_MUL(rate_diagonal_1c, rate_beta_v_0),
      rate_diagonal_1e = rate_diagonal_1d + rate_diagonal_0g,
      rate_diagonal_1 = rate_diagonal_1b - rate_diagonal_1e;
  const double rate_diagonal_2a = rate_diagonal_1a + rate_diagonal_0a,
      rate_diagonal_2b = rate_diagonal_1d + rate_diagonal_0e,
      rate_diagonal_2 = rate_diagonal_2a - rate_diagonal_2b;
  const double M_04 = rate_symmetric_0 - rate_q_2;
  const double M_05 = rate_q_1 + rate_symmetric_1;
  const double M_13 = rate_q_2 + rate_symmetric_0;
  const double M_15 = rate_symmetric_2 - rate_q_0;
  const double M_23 = rate_symmetric_1 - rate_q_1;
  const double M_24 = rate_q_0 + rate_symmetric_2;
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
  const double halved_0 = 0.5 * (double)s->m3;
  const double halved_1 = 0.5 * (double)s->m4;
  const double halved_2 = 0.5 * (double)s->m5;
  const double y_a = KSL_MUL(halved_0, halved_0), y_b = KSL_MUL(halved_1, halved_1),
      y_c = y_a + y_b, y_d = KSL_MUL(halved_2, halved_2), y = y_c + y_d;
  const double half_angle = sqrt(y);
  double c; const double sine = ksl_sincos(half_angle, &c);
  const double sinc_divisor = half_angle < 1.4901161193847656e-08 ? 1.4901161193847656e-08 :
      half_angle;
  const double sinc_quotient = sine / sinc_divisor;
  const double sinc_a = KSL_MUL(0.16666666666666666, y), sinc_b = 1.0 - sinc_a,
      sinc = half_angle < 1.4901161193847656e-08 ? sinc_b : sinc_quotient;
  const double series_phi_a = KSL_MUL(5.107725174524775e-32, y),
      series_phi_b = 4.116826490666969e-29 - series_phi_a, series_phi_c = KSL_MUL(y, series_phi_b),
      series_phi_d = series_phi_c - 2.86531123750421e-26, series_phi_e = KSL_MUL(y, series_phi_d),
      series_phi_f = series_phi_e + 1.701994875077501e-23, series_phi_g = KSL_MUL(y, series_phi_f),
      series_phi_h = series_phi_g - 8.509974375387505e-21, series_phi_i = KSL_MUL(y, series_phi_h),
      series_phi_j = series_phi_i + 3.523129391410427e-18, series_phi_k = KSL_MUL(y, series_phi_j),
      series_phi_l = series_phi_k - 1.1837714755139035e-15, series_phi_m = KSL_MUL(y, series_phi_l),
      series_phi_n = series_phi_m + 3.148832124866983e-13, series_phi_o = KSL_MUL(y, series_phi_n),
      series_phi_p = series_phi_o - 6.423617534728645e-11, series_phi_q = KSL_MUL(y, series_phi_p),
      series_phi_r = series_phi_q + 9.635426302092969e-09, series_phi_s = KSL_MUL(y, series_phi_r),
      series_phi_t = series_phi_s - 1.0020843354176687e-06, series_phi_u = KSL_MUL(y, series_phi_t),
      series_phi_v = series_phi_u + 6.613756613756614e-05, series_phi_w = KSL_MUL(y, series_phi_v),
      series_phi_x = series_phi_w - 0.002380952380952381, series_phi_y = KSL_MUL(y, series_phi_x),
      series_phi = series_phi_y + 0.03333333333333333;
  const double f_more_a = KSL_MUL(2.0, y), f_more = KSL_MUL(f_more_a, series_phi);
  const double near_f_a = KSL_MUL(0.3333333333333333, sinc),
      near_f_b = KSL_MUL(0.3333333333333333, f_more), near_f = near_f_a + near_f_b;
  const double f_rest = sinc - c;
  const double x = KSL_MUL(4.0, y);
  const double far_y = x < 4.0 ? 1.0 : y;
  const double closed_f = f_rest / far_y;
  const double f = x < 4.0 ? near_f : closed_f;
  const double four_k = KSL_MUL(4.0, sinc);
  const double b = f / four_k;
  const double b_across = c / sinc;
  const double beta_v_0 = KSL_MUL((double)s->m3, b);
  const double beta_v_1 = KSL_MUL((double)s->m4, b);
  const double beta_v_2 = KSL_MUL((double)s->m5, b);
  const double m_0 = KSL_MUL((double)s->m3, beta_v_0);
  const double m_1 = KSL_MUL((double)s->m4, beta_v_1);
  const double m_2 = KSL_MUL((double)s->m5, beta_v_2);
  const double m_3 = KSL_MUL((double)s->m4, beta_v_0);
  const double m_4 = KSL_MUL((double)s->m5, beta_v_0);
  const double m_5 = KSL_MUL((double)s->m5, beta_v_1);
  const double others_0 = m_1 + m_2;
  const double others_1 = m_0 + m_2;
  const double others_2 = m_0 + m_1;
  const double diagonal0a = 1.0 - others_0, diagonal0b = b_across + m_0,
      diagonal0 = m_0 < others_0 ? diagonal0b : diagonal0a;
  const double diagonal1a = 1.0 - others_1, diagonal1b = b_across + m_1,
      diagonal1 = m_1 < others_1 ? diagonal1b : diagonal1a;
  const double diagonal2a = 1.0 - others_2, diagonal2b = b_across + m_2,
      diagonal2 = m_2 < others_2 ? diagonal2b : diagonal2a;
  const double J_1 = m_3 - halved_2;
  const double J_2 = halved_1 + m_4;
  const double J_3 = halved_2 + m_3;
  const double J_5 = m_5 - halved_0;
  const double J_6 = m_4 - halved_1;
  const double J_7 = halved_0 + m_5;
  const double phi_rest_a = KSL_MUL(3.0, f), phi_rest = phi_rest_a - sinc;
  const double twice_y = KSL_MUL(2.0, far_y);
  const double closed_phi = phi_rest / twice_y;
  const double phi = x < 4.0 ? series_phi : closed_phi;
  const double b_rate_above_a = KSL_MUL(f, f), b_rate_above_b = KSL_MUL(0.5, b_rate_above_a),
      b_rate_above_c = KSL_MUL(sinc, phi), b_rate_above = b_rate_above_b - b_rate_above_c;
  const double b_rate_below_a = KSL_MUL(sinc, sinc), b_rate_below = KSL_MUL(8.0, b_rate_below_a);
  const double b_rate = b_rate_above / b_rate_below;
  const double rate_vw_a = (double)s->m0 * (double)s->m3,
      rate_vw_c = ksl_product_sum((double)s->m1, (double)s->m4, rate_vw_a),
      rate_vw = ksl_product_sum((double)s->m2, (double)s->m5, rate_vw_c);
  const double rate_bend_a = KSL_MUL(b_rate, rate_vw), rate_bend = -rate_bend_a;
  const double rate_q_0 = 0.5 * (double)s->m0;
  const double rate_q_1 = 0.5 * (double)s->m1;
  const double rate_q_2 = 0.5 * (double)s->m2;
  const double rate_beta_v_0a = KSL_MUL((double)s->m0, b), rate_beta_v_0 = -rate_beta_v_0a;
  const double rate_beta_v_1a = KSL_MUL((double)s->m1, b), rate_beta_v_1 = -rate_beta_v_1a;
  const double rate_beta_v_2a = KSL_MUL((double)s->m2, b), rate_beta_v_2 = -rate_beta_v_2a;
  const double rate_bend_w_0a = KSL_MUL((double)s->m3, rate_bend), rate_bend_w_0 = -rate_bend_w_0a;
  const double rate_bend_w_1a = KSL_MUL((double)s->m4, rate_bend), rate_bend_w_1 = -rate_bend_w_1a;
  const double rate_bend_w_2a = KSL_MUL((double)s->m5, rate_bend), rate_bend_w_2 = -rate_bend_w_2a;
  const double rate_symmetric_0a = KSL_MUL((double)s->m4, rate_bend_w_0),
      rate_symmetric_0b = KSL_MUL((double)s->m3, rate_beta_v_1),
      rate_symmetric_0c = KSL_MUL((double)s->m4, rate_beta_v_0),
      rate_symmetric_0d_lead = -rate_symmetric_0b,
      rate_symmetric_0d = rate_symmetric_0d_lead - rate_symmetric_0c,
      rate_symmetric_0 = rate_symmetric_0d + rate_symmetric_0a;
  const double rate_symmetric_1a = KSL_MUL((double)s->m5, rate_bend_w_0),
      rate_symmetric_1b = KSL_MUL((double)s->m3, rate_beta_v_2),
      rate_symmetric_1c = KSL_MUL((double)s->m5, rate_beta_v_0),
      rate_symmetric_1d_lead = -rate_symmetric_1b,
      rate_symmetric_1d = rate_symmetric_1d_lead - rate_symmetric_1c,
      rate_symmetric_1 = rate_symmetric_1d + rate_symmetric_1a;
  const double rate_symmetric_2a = KSL_MUL((double)s->m5, rate_bend_w_1),
      rate_symmetric_2b = KSL_MUL((double)s->m4, rate_beta_v_2),
      rate_symmetric_2c = KSL_MUL((double)s->m5, rate_beta_v_1),
      rate_symmetric_2d_lead = -rate_symmetric_2b,
      rate_symmetric_2d = rate_symmetric_2d_lead - rate_symmetric_2c,
      rate_symmetric_2 = rate_symmetric_2d + rate_symmetric_2a;
  const double rate_diagonal_0a = 2.0 * (double)s->m4,
      rate_diagonal_0b = KSL_MUL(rate_diagonal_0a, rate_beta_v_1),
      rate_diagonal_0c = 2.0 * (double)s->m5,
      rate_diagonal_0d = KSL_MUL(rate_diagonal_0c, rate_beta_v_2),
      rate_diagonal_0e = rate_diagonal_0b + rate_diagonal_0d,
      rate_diagonal_0f = KSL_MUL((double)s->m4, rate_bend_w_1),
      rate_diagonal_0g = KSL_MUL((double)s->m5, rate_bend_w_2),
      rate_diagonal_0h = rate_diagonal_0f + rate_diagonal_0g,
      rate_diagonal_0 = rate_diagonal_0e - rate_diagonal_0h;
  const double rate_diagonal_1a = 2.0 * (double)s->m3,
      rate_diagonal_1b = KSL_MUL(rate_diagonal_1a, rate_beta_v_0),
      rate_diagonal_1c = rate_diagonal_1b + rate_diagonal_0d,
      rate_diagonal_1d = KSL_MUL((double)s->m3, rate_bend_w_0),
      rate_diagonal_1e = rate_diagonal_1d + rate_diagonal_0g,
      rate_diagonal_1 = rate_diagonal_1c - rate_diagonal_1e;
  const double rate_diagonal_2a = rate_diagonal_1b + rate_diagonal_0b,
      rate_diagonal_2b = rate_diagonal_1d + rate_diagonal_0f,
      rate_diagonal_2 = rate_diagonal_2a - rate_diagonal_2b;
  const double M_04 = rate_symmetric_0 - rate_q_2;
  const double M_05 = rate_q_1 + rate_symmetric_1;
  const double M_13 = rate_q_2 + rate_symmetric_0;
  const double M_15 = rate_symmetric_2 - rate_q_0;
  const double M_23 = rate_symmetric_1 - rate_q_1;
  const double M_24 = rate_q_0 + rate_symmetric_2;
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
  const double apart_0 = (double)D2->m03 - (double)D1->m03;
  const double apart_1 = (double)D2->m13 - (double)D1->m13;
  const double apart_2 = (double)D2->m23 - (double)D1->m23;
  const double between_0a = (double)D1->m00 * (double)D2->m00,
      between_0c = ksl_product_sum((double)D1->m10, (double)D2->m10, between_0a),
      between_0 = ksl_product_sum((double)D1->m20, (double)D2->m20, between_0c);
  const double between_1a = (double)D1->m00 * (double)D2->m01,
      between_1c = ksl_product_sum((double)D1->m10, (double)D2->m11, between_1a),
      between_1 = ksl_product_sum((double)D1->m20, (double)D2->m21, between_1c);
  const double between_2a = (double)D1->m00 * (double)D2->m02,
      between_2c = ksl_product_sum((double)D1->m10, (double)D2->m12, between_2a),
      between_2 = ksl_product_sum((double)D1->m20, (double)D2->m22, between_2c);
  const double between_3a = KSL_MUL((double)D1->m00, apart_0),
      between_3b = KSL_MUL((double)D1->m10, apart_1), between_3c = between_3a + between_3b,
      between_3d = KSL_MUL((double)D1->m20, apart_2), between_3 = between_3c + between_3d;
  const double between_4a = (double)D1->m01 * (double)D2->m00,
      between_4c = ksl_product_sum((double)D1->m11, (double)D2->m10, between_4a),
      between_4 = ksl_product_sum((double)D1->m21, (double)D2->m20, between_4c);
  const double between_5a = (double)D1->m01 * (double)D2->m01,
      between_5c = ksl_product_sum((double)D1->m11, (double)D2->m11, between_5a),
      between_5 = ksl_product_sum((double)D1->m21, (double)D2->m21, between_5c);
  const double between_6a = (double)D1->m01 * (double)D2->m02,
      between_6c = ksl_product_sum((double)D1->m11, (double)D2->m12, between_6a),
      between_6 = ksl_product_sum((double)D1->m21, (double)D2->m22, between_6c);
  const double between_7a = KSL_MUL((double)D1->m01, apart_0),
      between_7b = KSL_MUL((double)D1->m11, apart_1), between_7c = between_7a + between_7b,
      between_7d = KSL_MUL((double)D1->m21, apart_2), between_7 = between_7c + between_7d;
  const double between_8a = (double)D1->m02 * (double)D2->m00,
      between_8c = ksl_product_sum((double)D1->m12, (double)D2->m10, between_8a),
      between_8 = ksl_product_sum((double)D1->m22, (double)D2->m20, between_8c);
  const double between_9a = (double)D1->m02 * (double)D2->m01,
      between_9c = ksl_product_sum((double)D1->m12, (double)D2->m11, between_9a),
      between_9 = ksl_product_sum((double)D1->m22, (double)D2->m21, between_9c);
  const double between_10a = (double)D1->m02 * (double)D2->m02,
      between_10c = ksl_product_sum((double)D1->m12, (double)D2->m12, between_10a),
      between_10 = ksl_product_sum((double)D1->m22, (double)D2->m22, between_10c);
  const double between_11a = KSL_MUL((double)D1->m02, apart_0),
      between_11b = KSL_MUL((double)D1->m12, apart_1), between_11c = between_11a + between_11b,
      between_11d = KSL_MUL((double)D1->m22, apart_2), between_11 = between_11c + between_11d;
  const double log_p_0 = between_9 - between_6;
  const double log_p_1 = between_2 - between_8;
  const double log_p_2 = between_4 - between_1;
  const double log_s_0 = between_6 + between_9;
  const double log_s_1 = between_2 + between_8;
  const double log_s_2 = between_1 + between_4;
  const double log_first_0 = between_0 + 1.0;
  const double log_first_1 = 1.0 - between_0;
  const double log_others_0 = between_5 + between_10;
  const double log_others_1 = between_5 - between_10;
  const double log_d_0 = log_first_0 + log_others_0;
  const double log_d_1 = log_first_0 - log_others_0;
  const double log_d_2 = log_first_1 + log_others_1;
  const double log_d_3 = log_first_1 - log_others_1;
  const double log_low_0 = between_5 < between_0 ? log_d_1 : log_s_2;
  const double log_low_1 = between_5 < between_0 ? log_s_2 : log_d_2;
  const double log_low_2 = between_5 < between_0 ? log_s_1 : log_s_0;
  const double log_low_3 = between_5 < between_0 ? log_p_0 : log_p_1;
  const double log_high_0a = -between_5, log_high_0 = between_0 < log_high_0a ? log_s_1 : log_p_0;
  const double log_high_1 = between_0 < log_high_0a ? log_s_0 : log_p_1;
  const double log_high_2 = between_0 < log_high_0a ? log_d_3 : log_p_2;
  const double log_high_3 = between_0 < log_high_0a ? log_p_2 : log_d_0;
  const double log_column_0 = between_10 < 0.0 ? log_low_0 : log_high_0;
  const double log_column_1 = between_10 < 0.0 ? log_low_1 : log_high_1;
  const double log_column_2 = between_10 < 0.0 ? log_low_2 : log_high_2;
  const double log_column_3 = between_10 < 0.0 ? log_low_3 : log_high_3;
  const double log_upper_0a = -log_column_0,
      log_upper_0 = log_column_3 < 0.0 ? log_upper_0a : log_column_0;
  const double log_upper_1a = -log_column_1,
      log_upper_1 = log_column_3 < 0.0 ? log_upper_1a : log_column_1;
  const double log_upper_2a = -log_column_2,
      log_upper_2 = log_column_3 < 0.0 ? log_upper_2a : log_column_2;
  const double log_upper_3 = fabs(log_column_3);
  const double log_v_s_size_0 = fabs(log_upper_0);
  const double log_v_s_size_1 = fabs(log_upper_1);
  const double log_v_s_size_2 = fabs(log_upper_2);
  const double log_v_s_largest1 = log_v_s_size_0 < log_v_s_size_1 ? log_v_s_size_1 : log_v_s_size_0;
  const double log_v_s_largest2 = log_v_s_largest1 < log_v_s_size_2 ? log_v_s_size_2 :
      log_v_s_largest1;
  const double log_v_s_b = 4.611686018427388e+18 < log_v_s_largest2 ? 2.710505431213761e-20 : 1.0,
      log_v_s_d = log_v_s_largest2 < 256.0 ? 1.8014398509481984e+16 : log_v_s_b,
      log_v_s = log_v_s_largest2 < 1.4210854715202004e-14 ? 3.2451855365842673e+32 : log_v_s_d;
  const double log_v_y_0 = KSL_MUL(log_upper_0, log_v_s);
  const double log_v_y_1 = KSL_MUL(log_upper_1, log_v_s);
  const double log_v_y_2 = KSL_MUL(log_upper_2, log_v_s);
  const double log_v_n_a = KSL_MUL(log_v_y_0, log_v_y_0), log_v_n_b = KSL_MUL(log_v_y_1, log_v_y_1),
      log_v_n_c = log_v_n_a + log_v_n_b, log_v_n_d = KSL_MUL(log_v_y_2, log_v_y_2),
      log_v_n_e = log_v_n_c + log_v_n_d, log_v_n = sqrt(log_v_n_e);
  const double log_v_r_b = log_v_s < 1.0 ? 3.6893488147419103e+19 : 1.0,
      log_v_r_d = 1.0 < log_v_s ? 5.551115123125783e-17 : log_v_r_b,
      log_v_r = 1.8014398509481984e+16 < log_v_s ? 3.0814879110195774e-33 : log_v_r_d;
  const double log_n = KSL_MUL(log_v_n, log_v_r);
  const double log_half = ksl_atan2(log_n, log_upper_3);
  const double log_divisor = log_n == 0.0 ? 1.0 : log_n;
  const double log_theta = KSL_MUL(2.0, log_half);
  const double log_k = log_theta / log_divisor;
  const double log_vector_0 = KSL_MUL(log_upper_0, log_k);
  const double log_vector_1 = KSL_MUL(log_upper_1, log_k);
  const double log_vector_2 = KSL_MUL(log_upper_2, log_k);
  const double log_half_angle = KSL_MUL(0.5, log_theta);
  const double log_length_a = KSL_MUL(log_n, log_n),
      log_length_b = KSL_MUL(log_upper_3, log_upper_3), log_length_c = log_length_a + log_length_b,
      log_length = sqrt(log_length_c);
  const double log_sine = log_n / log_length;
  const double log_c = log_upper_3 / log_length;
  const double log_y = KSL_MUL(log_half_angle, log_half_angle);
  const double log_sinc_divisor = log_half_angle < 1.4901161193847656e-08 ? 1.4901161193847656e-08 :
      log_half_angle;
  const double log_sinc_quotient = log_sine / log_sinc_divisor;
  const double log_sinc_a = KSL_MUL(0.16666666666666666, log_y), log_sinc_b = 1.0 - log_sinc_a,
      log_sinc = log_half_angle < 1.4901161193847656e-08 ? log_sinc_b : log_sinc_quotient;
  const double log_series_phi_a = KSL_MUL(5.107725174524775e-32, log_y),
      log_series_phi_b = 4.116826490666969e-29 - log_series_phi_a,
      log_series_phi_c = KSL_MUL(log_y, log_series_phi_b),
      log_series_phi_d = log_series_phi_c - 2.86531123750421e-26,
      log_series_phi_e = KSL_MUL(log_y, log_series_phi_d),
      log_series_phi_f = log_series_phi_e + 1.701994875077501e-23,
      log_series_phi_g = KSL_MUL(log_y, log_series_phi_f),
      log_series_phi_h = log_series_phi_g - 8.509974375387505e-21,
      log_series_phi_i = KSL_MUL(log_y, log_series_phi_h),
      log_series_phi_j = log_series_phi_i + 3.523129391410427e-18,
      log_series_phi_k = KSL_MUL(log_y, log_series_phi_j),
      log_series_phi_l = log_series_phi_k - 1.1837714755139035e-15,
      log_series_phi_m = KSL_MUL(log_y, log_series_phi_l),
      log_series_phi_n = log_series_phi_m + 3.148832124866983e-13,
      log_series_phi_o = KSL_MUL(log_y, log_series_phi_n),
      log_series_phi_p = log_series_phi_o - 6.423617534728645e-11,
      log_series_phi_q = KSL_MUL(log_y, log_series_phi_p),
      log_series_phi_r = log_series_phi_q + 9.635426302092969e-09,
      log_series_phi_s = KSL_MUL(log_y, log_series_phi_r),
      log_series_phi_t = log_series_phi_s - 1.0020843354176687e-06,
      log_series_phi_u = KSL_MUL(log_y, log_series_phi_t),
      log_series_phi_v = log_series_phi_u + 6.613756613756614e-05,
      log_series_phi_w = KSL_MUL(log_y, log_series_phi_v),
      log_series_phi_x = log_series_phi_w - 0.002380952380952381,
      log_series_phi_y = KSL_MUL(log_y, log_series_phi_x),
      log_series_phi = log_series_phi_y + 0.03333333333333333;
  const double log_f_more_a = KSL_MUL(2.0, log_y),
      log_f_more = KSL_MUL(log_f_more_a, log_series_phi);
  const double log_near_f_a = KSL_MUL(0.3333333333333333, log_sinc),
      log_near_f_b = KSL_MUL(0.3333333333333333, log_f_more),
      log_near_f = log_near_f_a + log_near_f_b;
  const double log_f_rest = log_sinc - log_c;
  const double log_x = KSL_MUL(4.0, log_y);
  const double log_far_y = log_x < 4.0 ? 1.0 : log_y;
  const double log_closed_f = log_f_rest / log_far_y;
  const double log_f = log_x < 4.0 ? log_near_f : log_closed_f;
  const double log_four_k = KSL_MUL(4.0, log_sinc);
  const double log_b = log_f / log_four_k;
  const double log_b_across = log_c / log_sinc;
  const double log_wt_a = KSL_MUL(between_3, log_vector_0),
      log_wt_b = KSL_MUL(between_7, log_vector_1), log_wt_c = log_wt_a + log_wt_b,
      log_wt_d = KSL_MUL(between_11, log_vector_2), log_wt = log_wt_c + log_wt_d;
  const double log_pitch = KSL_MUL(log_b, log_wt);
  const double log_along_0 = KSL_MUL(log_vector_0, log_pitch);
  const double log_along_1 = KSL_MUL(log_vector_1, log_pitch);
  const double log_along_2 = KSL_MUL(log_vector_2, log_pitch);
  const double log_u_0a = KSL_MUL(between_11, log_vector_1),
      log_u_0b = KSL_MUL(between_7, log_vector_2), log_u_0 = log_u_0a - log_u_0b;
  const double log_u_1a = KSL_MUL(between_3, log_vector_2),
      log_u_1b = KSL_MUL(between_11, log_vector_0), log_u_1 = log_u_1a - log_u_1b;
  const double log_u_2a = KSL_MUL(between_7, log_vector_0),
      log_u_2b = KSL_MUL(between_3, log_vector_1), log_u_2 = log_u_2a - log_u_2b;
  const double log_turned_0 = KSL_MUL(0.5, log_u_0);
  const double log_turned_1 = KSL_MUL(0.5, log_u_1);
  const double log_turned_2 = KSL_MUL(0.5, log_u_2);
  const double log_across_axis_0 = log_along_0 - log_turned_0;
  const double log_across_axis_1 = log_along_1 - log_turned_1;
  const double log_across_axis_2 = log_along_2 - log_turned_2;
  const double whole_0a = KSL_MUL(between_3, log_b_across), whole_0 = whole_0a + log_across_axis_0;
  const double whole_1a = KSL_MUL(between_7, log_b_across), whole_1 = whole_1a + log_across_axis_1;
  const double whole_2a = KSL_MUL(between_11, log_b_across), whole_2 = whole_2a + log_across_axis_2;
  const double screw_0 = KSL_MUL((double)k, whole_0);
  const double screw_1 = KSL_MUL((double)k, whole_1);
  const double screw_2 = KSL_MUL((double)k, whole_2);
  const double screw_3 = KSL_MUL((double)k, log_vector_0);
  const double screw_4 = KSL_MUL((double)k, log_vector_1);
  const double screw_5 = KSL_MUL((double)k, log_vector_2);
  const double exp_halved_0 = KSL_MUL(0.5, screw_3);
  const double exp_halved_1 = KSL_MUL(0.5, screw_4);
  const double exp_halved_2 = KSL_MUL(0.5, screw_5);
  const double exp_y_a = KSL_MUL(exp_halved_0, exp_halved_0),
      exp_y_b = KSL_MUL(exp_halved_1, exp_halved_1), exp_y_c = exp_y_a + exp_y_b,
      exp_y_d = KSL_MUL(exp_halved_2, exp_halved_2), exp_y = exp_y_c + exp_y_d;
  const double exp_half_angle = sqrt(exp_y);
  double exp_c; const double exp_sine = ksl_sincos(exp_half_angle, &exp_c);
  const double exp_sinc_divisor = exp_half_angle < 1.4901161193847656e-08 ? 1.4901161193847656e-08 :
      exp_half_angle;
  const double exp_sinc_quotient = exp_sine / exp_sinc_divisor;
  const double exp_sinc_a = KSL_MUL(0.16666666666666666, exp_y), exp_sinc_b = 1.0 - exp_sinc_a,
      exp_sinc = exp_half_angle < 1.4901161193847656e-08 ? exp_sinc_b : exp_sinc_quotient;
  const double exp_g1 = KSL_MUL(exp_c, exp_sinc);
  const double exp_g2a = KSL_MUL(exp_sinc, exp_sinc), exp_g2 = KSL_MUL(0.5, exp_g2a);
  const double exp_sine_square = KSL_MUL(exp_sine, exp_sine);
  const double exp_g0a = KSL_MUL(2.0, exp_sine_square), exp_g0 = 1.0 - exp_g0a;
  const double exp_rest3 = 1.0 - exp_g1;
  const double exp_x = KSL_MUL(4.0, exp_y);
  const double exp_far_x = exp_x < 1.0 ? 1.0 : exp_x;
  const double exp_closed3 = exp_rest3 / exp_far_x;
  const double exp_series5a = KSL_MUL(1.216125041553518e-34, exp_x),
      exp_series5b = 1.1309962886447716e-31 - exp_series5a,
      exp_series5c = KSL_MUL(exp_x, exp_series5b),
      exp_series5d = exp_series5c - 9.183689863795546e-29,
      exp_series5e = KSL_MUL(exp_x, exp_series5d),
      exp_series5f = exp_series5e + 6.446950284384474e-26,
      exp_series5g = KSL_MUL(exp_x, exp_series5f),
      exp_series5h = exp_series5g - 3.868170170630684e-23,
      exp_series5i = KSL_MUL(exp_x, exp_series5h),
      exp_series5j = exp_series5i + 1.9572941063391263e-20,
      exp_series5k = KSL_MUL(exp_x, exp_series5j),
      exp_series5l = exp_series5k - 8.22063524662433e-18,
      exp_series5m = KSL_MUL(exp_x, exp_series5l),
      exp_series5n = exp_series5m + 2.8114572543455206e-15,
      exp_series5o = KSL_MUL(exp_x, exp_series5n),
      exp_series5p = exp_series5o - 7.647163731819816e-13,
      exp_series5q = KSL_MUL(exp_x, exp_series5p),
      exp_series5r = exp_series5q + 1.6059043836821613e-10,
      exp_series5s = KSL_MUL(exp_x, exp_series5r),
      exp_series5t = exp_series5s - 2.505210838544172e-08,
      exp_series5u = KSL_MUL(exp_x, exp_series5t),
      exp_series5v = exp_series5u + 2.7557319223985893e-06,
      exp_series5w = KSL_MUL(exp_x, exp_series5v),
      exp_series5x = exp_series5w - 0.0001984126984126984,
      exp_series5y = KSL_MUL(exp_x, exp_series5x),
      exp_series5 = exp_series5y + 0.008333333333333333;
  const double exp_g3a = KSL_MUL(exp_x, exp_series5), exp_g3b = 0.16666666666666666 - exp_g3a,
      exp_g3 = exp_x < 1.0 ? exp_g3b : exp_closed3;
  const double exp_u_0a = KSL_MUL(screw_2, screw_4), exp_u_0b = KSL_MUL(screw_1, screw_5),
      exp_u_0 = exp_u_0a - exp_u_0b;
  const double exp_u_1a = KSL_MUL(screw_0, screw_5), exp_u_1b = KSL_MUL(screw_2, screw_3),
      exp_u_1 = exp_u_1a - exp_u_1b;
  const double exp_u_2a = KSL_MUL(screw_1, screw_3), exp_u_2b = KSL_MUL(screw_0, screw_4),
      exp_u_2 = exp_u_2a - exp_u_2b;
  const double exp_turned_0 = KSL_MUL(exp_g2, exp_u_0);
  const double exp_turned_1 = KSL_MUL(exp_g2, exp_u_1);
  const double exp_turned_2 = KSL_MUL(exp_g2, exp_u_2);
  const double exp_wv_a = KSL_MUL(screw_0, screw_3), exp_wv_b = KSL_MUL(screw_1, screw_4),
      exp_wv_c = exp_wv_a + exp_wv_b, exp_wv_d = KSL_MUL(screw_2, screw_5),
      exp_wv = exp_wv_c + exp_wv_d;
  const double exp_pitch = KSL_MUL(exp_g3, exp_wv);
  const double exp_along_0 = KSL_MUL(screw_3, exp_pitch);
  const double exp_along_1 = KSL_MUL(screw_4, exp_pitch);
  const double exp_along_2 = KSL_MUL(screw_5, exp_pitch);
  const double exp_beta_v_0 = KSL_MUL(screw_3, exp_g2);
  const double exp_beta_v_1 = KSL_MUL(screw_4, exp_g2);
  const double exp_beta_v_2 = KSL_MUL(screw_5, exp_g2);
  const double exp_m_0 = KSL_MUL(screw_3, exp_beta_v_0);
  const double exp_m_1 = KSL_MUL(screw_4, exp_beta_v_1);
  const double exp_m_2 = KSL_MUL(screw_5, exp_beta_v_2);
  const double exp_m_3 = KSL_MUL(screw_4, exp_beta_v_0);
  const double exp_m_4 = KSL_MUL(screw_5, exp_beta_v_0);
  const double exp_m_5 = KSL_MUL(screw_5, exp_beta_v_1);
  const double exp_others_0 = exp_m_1 + exp_m_2;
  const double exp_others_1 = exp_m_0 + exp_m_2;
  const double exp_others_2 = exp_m_0 + exp_m_1;
  const double exp_diagonal0a = 1.0 - exp_others_0, exp_diagonal0b = exp_g0 + exp_m_0,
      exp_diagonal0 = exp_m_0 < exp_others_0 ? exp_diagonal0b : exp_diagonal0a;
  const double exp_diagonal1a = 1.0 - exp_others_1, exp_diagonal1b = exp_g0 + exp_m_1,
      exp_diagonal1 = exp_m_1 < exp_others_1 ? exp_diagonal1b : exp_diagonal1a;
  const double exp_diagonal2a = 1.0 - exp_others_2, exp_diagonal2b = exp_g0 + exp_m_2,
      exp_diagonal2 = exp_m_2 < exp_others_2 ? exp_diagonal2b : exp_diagonal2a;
  const double exp_alpha_v_0 = KSL_MUL(screw_3, exp_g1);
  const double exp_alpha_v_1 = KSL_MUL(screw_4, exp_g1);
  const double exp_alpha_v_2 = KSL_MUL(screw_5, exp_g1);
  const double exp_across_axis_0 = exp_turned_0 + exp_along_0;
  const double exp_across_axis_1 = exp_turned_1 + exp_along_1;
  const double exp_across_axis_2 = exp_turned_2 + exp_along_2;
  const double step_1 = exp_m_3 - exp_alpha_v_2;
  const double step_2 = exp_m_4 + exp_alpha_v_1;
  const double step_3a = KSL_MUL(screw_0, exp_g1), step_3 = step_3a + exp_across_axis_0;
  const double step_4 = exp_m_3 + exp_alpha_v_2;
  const double step_6 = exp_m_5 - exp_alpha_v_0;
  const double step_7a = KSL_MUL(screw_1, exp_g1), step_7 = step_7a + exp_across_axis_1;
  const double step_8 = exp_m_4 - exp_alpha_v_1;
  const double step_9 = exp_m_5 + exp_alpha_v_0;
  const double step_11a = KSL_MUL(screw_2, exp_g1), step_11 = step_11a + exp_across_axis_2;
  const double Do_00a = KSL_MUL((double)D1->m00, exp_diagonal0),
      Do_00b = KSL_MUL((double)D1->m01, step_4), Do_00c = KSL_MUL((double)D1->m02, step_8),
      Do_00d = Do_00b + Do_00c, Do_00 = Do_00a + Do_00d;
  const double Do_01a = KSL_MUL((double)D1->m00, step_1), Do_01b = KSL_MUL((double)D1->m02, step_9),
      Do_01c = Do_01a + Do_01b, Do_01d = KSL_MUL((double)D1->m01, exp_diagonal1),
      Do_01 = Do_01c + Do_01d;
  const double Do_02a = KSL_MUL((double)D1->m00, step_2), Do_02b = KSL_MUL((double)D1->m01, step_6),
      Do_02c = Do_02a + Do_02b, Do_02d = KSL_MUL((double)D1->m02, exp_diagonal2),
      Do_02 = Do_02c + Do_02d;
  const double Do_03a = KSL_MUL((double)D1->m00, step_3), Do_03b = KSL_MUL((double)D1->m01, step_7),
      Do_03c = Do_03a + Do_03b, Do_03d = KSL_MUL((double)D1->m02, step_11),
      Do_03e = Do_03c + Do_03d, Do_03 = Do_03e + (double)D1->m03;
  const double Do_10a = KSL_MUL((double)D1->m10, exp_diagonal0),
      Do_10b = KSL_MUL((double)D1->m11, step_4), Do_10c = KSL_MUL((double)D1->m12, step_8),
      Do_10d = Do_10b + Do_10c, Do_10 = Do_10a + Do_10d;
  const double Do_11a = KSL_MUL((double)D1->m10, step_1), Do_11b = KSL_MUL((double)D1->m12, step_9),
      Do_11c = Do_11a + Do_11b, Do_11d = KSL_MUL((double)D1->m11, exp_diagonal1),
      Do_11 = Do_11c + Do_11d;
  const double Do_12a = KSL_MUL((double)D1->m10, step_2), Do_12b = KSL_MUL((double)D1->m11, step_6),
      Do_12c = Do_12a + Do_12b, Do_12d = KSL_MUL((double)D1->m12, exp_diagonal2),
      Do_12 = Do_12c + Do_12d;
  const double Do_13a = KSL_MUL((double)D1->m10, step_3), Do_13b = KSL_MUL((double)D1->m11, step_7),
      Do_13c = Do_13a + Do_13b, Do_13d = KSL_MUL((double)D1->m12, step_11),
      Do_13e = Do_13c + Do_13d, Do_13 = Do_13e + (double)D1->m13;
  const double Do_20a = KSL_MUL((double)D1->m20, exp_diagonal0),
      Do_20b = KSL_MUL((double)D1->m21, step_4), Do_20c = KSL_MUL((double)D1->m22, step_8),
      Do_20d = Do_20b + Do_20c, Do_20 = Do_20a + Do_20d;
  const double Do_21a = KSL_MUL((double)D1->m20, step_1), Do_21b = KSL_MUL((double)D1->m22, step_9),
      Do_21c = Do_21a + Do_21b, Do_21d = KSL_MUL((double)D1->m21, exp_diagonal1),
      Do_21 = Do_21c + Do_21d;
  const double Do_22a = KSL_MUL((double)D1->m20, step_2), Do_22b = KSL_MUL((double)D1->m21, step_6),
      Do_22c = Do_22a + Do_22b, Do_22d = KSL_MUL((double)D1->m22, exp_diagonal2),
      Do_22 = Do_22c + Do_22d;
  const double Do_23a = KSL_MUL((double)D1->m20, step_3), Do_23b = KSL_MUL((double)D1->m21, step_7),
      Do_23c = Do_23a + Do_23b, Do_23d = KSL_MUL((double)D1->m22, step_11),
      Do_23e = Do_23c + Do_23d, Do_23 = Do_23e + (double)D1->m23;
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
