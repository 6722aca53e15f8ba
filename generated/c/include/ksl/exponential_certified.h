/* Made by `coscrew generate`; changes are overwritten. */
/* SPDX-License-Identifier: MIT */
/* coscrew 0.2.0.  Copyright (c) 2026 The coscrew authors. */
/* Exponentials and logarithms of rotations and displacements, their Jacobians, interpolation.
   Certified tier: plain results, and bounds on their errors that always hold. */
#ifndef KSL_EXPONENTIAL_CERTIFIED_H
#define KSL_EXPONENTIAL_CERTIFIED_H

#include "ksl_types.h"
#include "ksl_exact.h"
#include "ksl_exactf.h"
#include "elementary.h"
#include "ksl_elementary_error.h"

/* R = exp v~ = I + sin θ/θ v~ + (1 - cos θ)/θ^2 v~^2, θ = |v|; |error of R| <= R_bound unless
     inf or NaN.
   v: vector; R, R_bound: rotation or other 3×3 matrix.
   336 mul, 494 add, 17 product error, 22 product rest, 12 div, 3 sqrt, 51 abs, 14 less, 1 equal,
     29 select. */
static inline void ksl_SO3_exp_certified(const ksl_vec3_t *v, ksl_mat3x3_t *R,
    ksl_mat3x3_t *R_bound) {
  const double size_0 = fabs(v->x), size_1 = fabs(v->y), size_2 = fabs(v->z);
  const double sizes = size_0 + size_1 + size_2;
  const double grid = KSL_MUL(sizes, 268435456.0);
  const double shifted_0 = v->x + grid, shifted_1 = v->y + grid, shifted_2 = v->z + grid;
  const double high_0 = shifted_0 - grid, high_1 = shifted_1 - grid, high_2 = shifted_2 - grid;
  const double low_0 = v->x - high_0, low_1 = v->y - high_1, low_2 = v->z - high_2;
  const double sum_0 = v->x + high_0, sum_1 = v->y + high_1, sum_2 = v->z + high_2;
  const double squares = KSL_MUL(high_0, high_0) + KSL_MUL(high_1, high_1)
          + KSL_MUL(high_2, high_2);
  const double cross = KSL_MUL(low_0, sum_0) + KSL_MUL(low_1, sum_1) + KSL_MUL(low_2, sum_2);
  const double x = squares + cross;
  const double theta_a = sqrt(x), theta = x < 1.0 ? 1.0 : theta_a;
  const double theta_shifted = grid + theta;
  const double theta_high = theta_shifted - grid;
  const double theta_low = theta - theta_high;
  const double theta_sum = theta + theta_high;
  const double cross_rest = cross - KSL_MUL(theta_low, theta_sum);
  const double exact = squares - KSL_MUL(theta_high, theta_high);
  const double residual = cross_rest + exact;
  const double small = KSL_MUL(0.5, residual) / theta;
  const double delta = fabs(small) < 0.0078125 ? small : 0.0;
  double far_cosine_a; const double far_sine_a = ksl_sincos(theta, &far_cosine_a);
  const double far_sine = x < 1.0 ? 1.0 : far_sine_a;
  const double far_cosine = x < 1.0 ? 0.0 : far_cosine_a;
  const double sine = KSL_MUL(delta, far_cosine) + far_sine;
  const double cosine = far_cosine - KSL_MUL(delta, far_sine);
  const double far_x = x < 1.0 ? 1.0 : x;
  const double closed1 = sine / theta;
  const double versine = 1.0 - cosine;
  const double closed2 = versine / far_x;
  const double g1g = KSL_MUL(x, KSL_MUL(x, KSL_MUL(x, KSL_MUL(6.446950284384474e-26, x)
          - 3.868170170630684e-23) + 1.9572941063391263e-20) - 8.22063524662433e-18),
      g1n = KSL_MUL(x, KSL_MUL(x, KSL_MUL(x, g1g + 2.8114572543455206e-15) - 7.647163731819816e-13)
          + 1.6059043836821613e-10) - 2.505210838544172e-08,
      g1u = KSL_MUL(x, KSL_MUL(x, KSL_MUL(x, KSL_MUL(x, g1n) + 2.7557319223985893e-06)
          - 0.0001984126984126984) + 0.008333333333333333),
      g1x = KSL_MUL(x, g1u - 0.16666666666666666) + 1.0, g1 = x < 1.0 ? g1x : closed1;
  const double g2g = KSL_MUL(x, KSL_MUL(x, KSL_MUL(x, KSL_MUL(2.4795962632247976e-27, x)
          - 1.6117375710961184e-24) + 8.896791392450574e-22) - 4.110317623312165e-19),
      g2n = KSL_MUL(x, KSL_MUL(x, KSL_MUL(x, g2g + 1.5619206968586225e-16) - 4.779477332387385e-14)
          + 1.1470745597729725e-11) - 2.08767569878681e-09,
      g2v = KSL_MUL(x, KSL_MUL(x, KSL_MUL(x, KSL_MUL(x, g2n) + 2.755731922398589e-07)
          - 2.48015873015873e-05) + 0.001388888888888889) - 0.041666666666666664,
      g2x = KSL_MUL(x, g2v) + 0.5, g2 = x < 1.0 ? g2x : closed2;
  const double g0b = 1.0 - KSL_MUL(x, g2), g0 = x < 1.0 ? g0b : cosine;
  const double beta_v_0 = KSL_MUL(v->x, g2);
  const double beta_v_1 = KSL_MUL(v->y, g2);
  const double beta_v_2 = KSL_MUL(v->z, g2);
  const double m_0 = KSL_MUL(v->x, beta_v_0);
  const double m_1 = KSL_MUL(v->y, beta_v_1);
  const double m_2 = KSL_MUL(v->z, beta_v_2);
  const double m_3 = KSL_MUL(v->y, beta_v_0);
  const double m_4 = KSL_MUL(v->z, beta_v_0);
  const double m_5 = KSL_MUL(v->z, beta_v_1);
  const double others_0 = m_1 + m_2;
  const double others_1 = m_0 + m_2;
  const double others_2 = m_0 + m_1;
  const double diagonal0a = 1.0 - others_0, diagonal0b = g0 + m_0,
      diagonal0 = m_0 < others_0 ? diagonal0b : diagonal0a;
  const double diagonal1a = 1.0 - others_1, diagonal1b = g0 + m_1,
      diagonal1 = m_1 < others_1 ? diagonal1b : diagonal1a;
  const double diagonal2a = 1.0 - others_2, diagonal2b = g0 + m_2,
      diagonal2 = m_2 < others_2 ? diagonal2b : diagonal2a;
  const double alpha_v_0 = KSL_MUL(v->x, g1);
  const double alpha_v_1 = KSL_MUL(v->y, g1);
  const double alpha_v_2 = KSL_MUL(v->z, g1);
  const double R_01 = m_3 - alpha_v_2;
  const double R_02 = m_4 + alpha_v_1;
  const double R_10 = m_3 + alpha_v_2;
  const double R_12 = m_5 - alpha_v_0;
  const double R_20 = m_4 - alpha_v_1;
  const double R_21 = m_5 + alpha_v_0;
  const double halved_0 = KSL_MUL(0.5, v->x), halved_size_1 = fabs(v->x);
  const double halved_1 = KSL_MUL(0.5, v->y), halved_size_3 = fabs(v->y);
  const double halved_2 = KSL_MUL(0.5, v->z), halved_size_5 = fabs(v->z);
  const double h_size_0 = fabs(halved_0), h_size_1 = fabs(halved_1), h_size_2 = fabs(halved_2);
  const double h_largest1 = h_size_0 < h_size_1 ? h_size_1 : h_size_0;
  const double h_largest2 = h_largest1 < h_size_2 ? h_size_2 : h_largest1;
  const double s = 6.703903964971299e+153 < h_largest2 ? 3.7291703656001034e-155 : 1.0,
      s_size_1 = 6.703903964971299e+153 < h_largest2 ? 3.7291703656001034e-155 : 1.0;
  const double reduced_0 = KSL_MUL(halved_0, s), reduced_1 = KSL_MUL(halved_1, s),
      reduced_2 = KSL_MUL(halved_2, s);
  const double up = s < 1.0 ? 2.6815615859885194e+154 : 1.0;
  const double reduced_length_a = KSL_MUL(reduced_0, reduced_0),
      reduced_length_a_padded_1 = 1.8051943758648296e-276
          + KSL_MUL(1.8051943758648296e-276 + KSL_MUL(0.5, halved_size_1), s_size_1),
      reduced_length_b = KSL_MUL(reduced_1, reduced_1),
      reduced_length_b_padded_1 = 1.8051943758648296e-276
          + KSL_MUL(1.8051943758648296e-276 + KSL_MUL(0.5, halved_size_3), s_size_1),
      reduced_length_c = reduced_length_a + reduced_length_b,
      reduced_length_c_right_1 = reduced_length_c - reduced_length_a,
      reduced_length_c_left_rest_1 = ksl_product_rest(reduced_0, reduced_0, reduced_length_a,
          reduced_length_c - reduced_length_c_right_1),
      reduced_length_a_size_1 = KSL_MUL(reduced_length_a_padded_1, reduced_length_a_padded_1),
      reduced_length_d = KSL_MUL(reduced_2, reduced_2),
      reduced_length_d_padded_1 = 1.8051943758648296e-276
          + KSL_MUL(1.8051943758648296e-276 + KSL_MUL(0.5, halved_size_5), s_size_1),
      reduced_length_e = reduced_length_c + reduced_length_d,
      reduced_length_e_right_1 = reduced_length_e - reduced_length_c,
      reduced_length_e_right_rest_1 = ksl_product_rest(reduced_2, reduced_2, reduced_length_d,
          reduced_length_e_right_1),
      reduced_length_c_lo = reduced_length_c_left_rest_1
          + ksl_product_rest(reduced_1, reduced_1, reduced_length_b, reduced_length_c_right_1),
      reduced_length_e_lo = reduced_length_c - (reduced_length_e - reduced_length_e_right_1)
          + reduced_length_e_right_rest_1 + reduced_length_c_lo,
      reduced_length_c_size_1 = reduced_length_a_size_1
          + KSL_MUL(reduced_length_b_padded_1, reduced_length_b_padded_1),
      reduced_length = sqrt(reduced_length_e),
      reduced_length_product_1 = KSL_MUL(reduced_length, reduced_length),
      reduced_length_exact_1 = reduced_length_e - reduced_length_product_1
          - ksl_product_error(reduced_length, reduced_length, reduced_length_product_1),
      reduced_length_twice_1 = reduced_length + reduced_length,
      reduced_length_lo = (reduced_length_exact_1 + reduced_length_e_lo)
          / (reduced_length == 0.0 ? 1.0 : reduced_length_twice_1),
      reduced_length_padded_1 = 1.8051943758648296e-276
          + (reduced_length_c_size_1
          + KSL_MUL(reduced_length_d_padded_1, reduced_length_d_padded_1)),
      reduced_length_bound_1 = fabs(reduced_length_e_lo)
          + KSL_MUL(3.229399894985818e-30, reduced_length_padded_1),
      reduced_length_reach_1 = fabs(reduced_length_e)
          + KSL_MUL(140737488355328.0, reduced_length_bound_1),
      reduced_length_size_4 = KSL_MUL(reduced_length_reach_1, reduced_length_padded_1
          / reduced_length / reduced_length_e),
      reduced_length_size_8 = KSL_MUL(2.0056767005853705e+29, sqrt(reduced_length_bound_1)
          + fabs(reduced_length_lo));
  const double half_angle = KSL_MUL(reduced_length, up),
      half_angle_lo = KSL_MUL(reduced_length - KSL_MUL(half_angle, 1.0 / up)
          + reduced_length_lo, up);
  const double reduced_length_size_12 = reduced_length
          + (KSL_MUL(4.0, reduced_length_bound_1) < reduced_length_e ? reduced_length_size_4
          : reduced_length_size_8);
  const double half_angle_size_1 = KSL_MUL(1.8051943758648296e-276 + reduced_length_size_12, s
          < 1.0 ? 2.6815615859885194e+154 : 1.0);
  const double y = KSL_MUL(half_angle, half_angle),
      y_padded_1 = 1.8051943758648296e-276 + half_angle_size_1,
      y_bound_1 = fabs(half_angle_lo) + KSL_MUL(5.7192432555642225e-30, y_padded_1),
      y_size_2 = KSL_MUL(y_padded_1, fabs(half_angle) + KSL_MUL(140737488355328.0, y_bound_1));
  double c; const double fine_sine = ksl_sincos(half_angle, &c);
  double c_own_error_1; const double fine_sine_own_error_1 = ksl_sincos_error(half_angle, fine_sine,
      c, &c_own_error_1);
  const double fine_sine_half_1 = KSL_MUL(half_angle_lo, 0.5);
  double fine_sine_half_cos_1; const double fine_sine_half_sin_1 = ksl_sincos(fine_sine_half_1,
      &fine_sine_half_cos_1);
  const double fine_sine_twice_1 = fine_sine_half_sin_1 + fine_sine_half_sin_1,
      fine_sine_size_1 = 1.0 + y_padded_1;
  const double c_lo = c_own_error_1
          - KSL_MUL(KSL_MUL(fine_sine_half_cos_1, fine_sine)
          + KSL_MUL(fine_sine_half_sin_1, c), fine_sine_twice_1);
  const double sinc_divisor = half_angle < 1.4901161193847656e-08 ? 1.4901161193847656e-08
          : half_angle, sinc_divisor_lo = half_angle < 1.4901161193847656e-08 ? 0.0 : half_angle_lo,
      sinc_divisor_size_4 = 5e-324 + fabs(half_angle - 1.4901161193847656e-08),
      sinc_divisor_size_8 = fabs(1.4901161193847656e-08 - half_angle) + y_bound_1,
      sinc_divisor_size_10 = KSL_MUL(5.762046184631807e+28, y_bound_1 < sinc_divisor_size_4 ? 0.0
          : sinc_divisor_size_8);
  const double sinc_quotient = fine_sine / sinc_divisor,
      sinc_quotient_product_1 = KSL_MUL(sinc_quotient, sinc_divisor);
  const double fine_sine_lo = fine_sine_own_error_1
          + KSL_MUL(KSL_MUL(fine_sine_half_cos_1, c)
          - KSL_MUL(fine_sine_half_sin_1, fine_sine), fine_sine_twice_1);
  const double sinc_quotient_exact_1 = fine_sine - sinc_quotient_product_1
          - ksl_product_error(sinc_quotient, sinc_divisor, sinc_quotient_product_1),
      sinc_quotient_lo = (sinc_quotient_exact_1 + fine_sine_lo
          - KSL_MUL(sinc_quotient, sinc_divisor_lo)) / sinc_divisor;
  const double sinc_divisor_size_11 = (half_angle < 1.4901161193847656e-08 ? 1.4901161193847656e-08
          : half_angle_size_1) + sinc_divisor_size_10;
  const double sinc_quotient_padded_2 = 1.8051943758648296e-276 + sinc_divisor_size_11,
      sinc_quotient_size_1 = fabs(sinc_quotient), sinc_quotient_size_2 = fabs(sinc_divisor),
      sinc_quotient_bound_1 = fabs(sinc_divisor_lo)
          + KSL_MUL(1.789728954546449e-29, sinc_quotient_padded_2),
      sinc_quotient_size_4 = 1.8051943758648296e-276 + fine_sine_size_1
          + KSL_MUL(sinc_quotient_padded_2, sinc_quotient_size_1),
      sinc_quotient_size_8 = sinc_quotient_size_4
          / (KSL_MUL(4.0, sinc_quotient_bound_1) < sinc_quotient_size_2 ? sinc_quotient_size_2
          : 0.0),
      sinc_quotient_size_10 = KSL_MUL(sinc_quotient_size_2
          + KSL_MUL(140737488355328.0, sinc_quotient_bound_1), sinc_quotient_size_8)
          / sinc_quotient_size_2,
      sinc_quotient_size_11 = sinc_quotient_size_1 + sinc_quotient_size_10;
  const double sinc_a = KSL_MUL(0.16666666666666666, y),
      y_lo = ksl_product_error(half_angle, half_angle, y)
          + (KSL_MUL(half_angle_lo, half_angle) + KSL_MUL(half_angle, half_angle_lo)),
      sinc_b = 1.0 - sinc_a, sinc_b_right_1 = 1.0 - sinc_b,
      sinc_b_lo1_1 = 1.0 - (sinc_b + sinc_b_right_1)
          - ksl_product_rest(0.16666666666666666, y, sinc_a, sinc_b_right_1),
      sinc_b_lo = sinc_b_lo1_1
          - (KSL_MUL(9.25185853854297e-18, y) + KSL_MUL(0.16666666666666666, y_lo)),
      sinc_b_size_1 = 1.0 + KSL_MUL(2290649224.7000003, y_size_2 + y_size_2),
      sinc = half_angle < 1.4901161193847656e-08 ? sinc_b : sinc_quotient,
      sinc_lo = half_angle < 1.4901161193847656e-08 ? sinc_b_lo : sinc_quotient_lo,
      sinc_size_4 = fabs(sinc_b_lo)
          + KSL_MUL(8.201505264386605e-28, 1.8051943758648296e-276 + sinc_b_size_1)
          + fabs(sinc_b - sinc_quotient),
      sinc_size_5 = fabs(sinc_quotient_lo)
          + KSL_MUL(2.755262189115544e-29, 1.8051943758648296e-276 + sinc_quotient_size_11)
          + sinc_size_4,
      sinc_size_7 = KSL_MUL(1.2206826306780646e+27, y_bound_1 < sinc_divisor_size_4 ? 0.0
          : sinc_size_5);
  const double turning_0 = KSL_MUL(v->x, sinc),
      turning_padded_1 = 1.8051943758648296e-276
          + ((half_angle < 1.4901161193847656e-08 ? sinc_b_size_1 : sinc_quotient_size_11)
          + sinc_size_7), turning_size_1 = KSL_MUL(halved_size_1, turning_padded_1);
  const double turning_1 = KSL_MUL(v->y, sinc),
      turning_size_2 = KSL_MUL(halved_size_3, turning_padded_1);
  const double turning_2 = KSL_MUL(v->z, sinc),
      turning_size_3 = KSL_MUL(halved_size_5, turning_padded_1);
  const double turning_lo_1 = ksl_product_error(v->x, sinc, turning_0) + KSL_MUL(v->x, sinc_lo),
      fine_beta_v_0 = KSL_MUL(0.5, turning_0), fine_beta_v_cross2_1 = KSL_MUL(0.5, turning_lo_1);
  const double turning_lo_2 = ksl_product_error(v->y, sinc, turning_1) + KSL_MUL(v->y, sinc_lo),
      fine_beta_v_1 = KSL_MUL(0.5, turning_1), fine_beta_v_cross2_2 = KSL_MUL(0.5, turning_lo_2);
  const double turning_lo_3 = ksl_product_error(v->z, sinc, turning_2) + KSL_MUL(v->z, sinc_lo),
      fine_beta_v_2 = KSL_MUL(0.5, turning_2), fine_beta_v_cross2_3 = KSL_MUL(0.5, turning_lo_3);
  const double fine_m_0 = KSL_MUL(turning_0, fine_beta_v_0),
      fine_m_cross_1 = KSL_MUL(turning_lo_1, fine_beta_v_0)
          + KSL_MUL(turning_0, fine_beta_v_cross2_1),
      fine_m_padded_1 = 1.8051943758648296e-276 + turning_size_1,
      fine_m_padded_2 = 1.8051943758648296e-276 + KSL_MUL(0.5, turning_size_1),
      fine_m_reach_1 = fabs(turning_0)
          + KSL_MUL(140737488355328.0, fabs(turning_lo_1)
          + KSL_MUL(8.20625268358031e-28, fine_m_padded_1)),
      fine_m_reach_2 = fabs(fine_beta_v_0)
          + KSL_MUL(140737488355328.0, fabs(fine_beta_v_cross2_1)
          + KSL_MUL(8.21136891741797e-28, fine_m_padded_2)),
      fine_m_size_5 = KSL_MUL(fine_m_padded_2, fine_m_reach_1)
          + KSL_MUL(fine_m_padded_1, fine_m_reach_2);
  const double fine_m_1 = KSL_MUL(turning_1, fine_beta_v_1),
      fine_m_cross_2 = KSL_MUL(turning_lo_2, fine_beta_v_1)
          + KSL_MUL(turning_1, fine_beta_v_cross2_2),
      fine_m_padded_3 = 1.8051943758648296e-276 + turning_size_2,
      fine_m_padded_4 = 1.8051943758648296e-276 + KSL_MUL(0.5, turning_size_2),
      fine_m_reach_3 = fabs(turning_1)
          + KSL_MUL(140737488355328.0, fabs(turning_lo_2)
          + KSL_MUL(8.20625268358031e-28, fine_m_padded_3)),
      fine_m_reach_4 = fabs(fine_beta_v_1)
          + KSL_MUL(140737488355328.0, fabs(fine_beta_v_cross2_2)
          + KSL_MUL(8.21136891741797e-28, fine_m_padded_4)),
      fine_m_size_10 = KSL_MUL(fine_m_padded_4, fine_m_reach_3)
          + KSL_MUL(fine_m_padded_3, fine_m_reach_4);
  const double fine_m_2 = KSL_MUL(turning_2, fine_beta_v_2),
      fine_m_cross_3 = KSL_MUL(turning_lo_3, fine_beta_v_2)
          + KSL_MUL(turning_2, fine_beta_v_cross2_3),
      fine_m_padded_5 = 1.8051943758648296e-276 + turning_size_3,
      fine_m_padded_6 = 1.8051943758648296e-276 + KSL_MUL(0.5, turning_size_3),
      fine_m_reach_5 = fabs(turning_2)
          + KSL_MUL(140737488355328.0, fabs(turning_lo_3)
          + KSL_MUL(8.20625268358031e-28, fine_m_padded_5)),
      fine_m_reach_6 = fabs(fine_beta_v_2)
          + KSL_MUL(140737488355328.0, fabs(fine_beta_v_cross2_3)
          + KSL_MUL(8.21136891741797e-28, fine_m_padded_6)),
      fine_m_size_15 = KSL_MUL(fine_m_padded_6, fine_m_reach_5)
          + KSL_MUL(fine_m_padded_5, fine_m_reach_6);
  const double fine_m_3 = KSL_MUL(turning_1, fine_beta_v_0),
      fine_m_cross_4 = KSL_MUL(turning_lo_2, fine_beta_v_0)
          + KSL_MUL(turning_1, fine_beta_v_cross2_1);
  const double fine_m_4 = KSL_MUL(turning_2, fine_beta_v_0),
      fine_m_cross_5 = KSL_MUL(turning_lo_3, fine_beta_v_0)
          + KSL_MUL(turning_2, fine_beta_v_cross2_1);
  const double fine_m_5 = KSL_MUL(turning_2, fine_beta_v_1),
      fine_m_cross_6 = KSL_MUL(turning_lo_3, fine_beta_v_1)
          + KSL_MUL(turning_2, fine_beta_v_cross2_2);
  const double fine_others_0 = fine_m_1 + fine_m_2, fine_others_right_1 = fine_others_0 - fine_m_1,
      fine_others_left_rest_1 = ksl_product_rest(turning_1, fine_beta_v_1, fine_m_1, fine_others_0
          - fine_others_right_1),
      fine_others_lo1_1 = fine_others_left_rest_1
          + ksl_product_rest(turning_2, fine_beta_v_2, fine_m_2, fine_others_right_1);
  const double fine_others_1 = fine_m_0 + fine_m_2, fine_others_right_2 = fine_others_1 - fine_m_0,
      fine_others_left_rest_2 = ksl_product_rest(turning_0, fine_beta_v_0, fine_m_0, fine_others_1
          - fine_others_right_2),
      fine_others_lo1_2 = fine_others_left_rest_2
          + ksl_product_rest(turning_2, fine_beta_v_2, fine_m_2, fine_others_right_2);
  const double fine_others_2 = fine_m_0 + fine_m_1, fine_others_right_3 = fine_others_2 - fine_m_0,
      fine_others_left_rest_3 = ksl_product_rest(turning_0, fine_beta_v_0, fine_m_0, fine_others_2
          - fine_others_right_3),
      fine_others_lo1_3 = fine_others_left_rest_3
          + ksl_product_rest(turning_1, fine_beta_v_1, fine_m_1, fine_others_right_3);
  const double fine_alpha_v_0 = KSL_MUL(c, turning_0),
      fine_alpha_v_cross_1 = KSL_MUL(c_lo, turning_0) + KSL_MUL(c, turning_lo_1),
      fine_alpha_v_reach_1 = fabs(c)
          + KSL_MUL(140737488355328.0, fabs(c_lo)
          + KSL_MUL(1.0551017099379094e-29, fine_sine_size_1));
  const double fine_alpha_v_1 = KSL_MUL(c, turning_1),
      fine_alpha_v_cross_2 = KSL_MUL(c_lo, turning_1) + KSL_MUL(c, turning_lo_2);
  const double fine_alpha_v_2 = KSL_MUL(c, turning_2),
      fine_alpha_v_cross_3 = KSL_MUL(c_lo, turning_2) + KSL_MUL(c, turning_lo_3);
  const double R_00 = 1.0 - fine_others_0, R_right_1 = 1.0 - R_00;
  const double fine_R_01 = fine_m_3 - fine_alpha_v_2, fine_R_right_1 = fine_m_3 - fine_R_01,
      fine_R_left_rest_1 = ksl_product_rest(turning_1, fine_beta_v_0, fine_m_3, fine_R_01
          + fine_R_right_1);
  const double fine_alpha_v_size_10 = KSL_MUL(fine_alpha_v_reach_1, fine_m_padded_5)
          + KSL_MUL(fine_m_reach_5, fine_sine_size_1);
  const double fine_R_02 = fine_m_4 + fine_alpha_v_1, fine_R_right_2 = fine_R_02 - fine_m_4,
      fine_R_left_rest_2 = ksl_product_rest(turning_2, fine_beta_v_0, fine_m_4, fine_R_02
          - fine_R_right_2);
  const double fine_alpha_v_size_7 = KSL_MUL(fine_alpha_v_reach_1, fine_m_padded_3)
          + KSL_MUL(fine_m_reach_3, fine_sine_size_1);
  const double fine_R_10 = fine_m_3 + fine_alpha_v_2, fine_R_right_3 = fine_R_10 - fine_m_3,
      fine_R_left_rest_3 = ksl_product_rest(turning_1, fine_beta_v_0, fine_m_3, fine_R_10
          - fine_R_right_3);
  const double R_11 = 1.0 - fine_others_1, R_right_2 = 1.0 - R_11;
  const double fine_R_12 = fine_m_5 - fine_alpha_v_0, fine_R_right_4 = fine_m_5 - fine_R_12,
      fine_R_left_rest_4 = ksl_product_rest(turning_2, fine_beta_v_1, fine_m_5, fine_R_12
          + fine_R_right_4);
  const double fine_alpha_v_size_4 = KSL_MUL(fine_alpha_v_reach_1, fine_m_padded_1)
          + KSL_MUL(fine_m_reach_1, fine_sine_size_1);
  const double fine_R_20 = fine_m_4 - fine_alpha_v_1, fine_R_right_5 = fine_m_4 - fine_R_20,
      fine_R_left_rest_5 = ksl_product_rest(turning_2, fine_beta_v_0, fine_m_4, fine_R_20
          + fine_R_right_5);
  const double fine_R_21 = fine_m_5 + fine_alpha_v_0, fine_R_right_6 = fine_R_21 - fine_m_5,
      fine_R_left_rest_6 = ksl_product_rest(turning_2, fine_beta_v_1, fine_m_5, fine_R_21
          - fine_R_right_6);
  const double R_22 = 1.0 - fine_others_2, R_right_3 = 1.0 - R_22;
  const double R_lo_1 = 1.0 - (R_00 + R_right_1) - (fine_others_0 - R_right_1)
          - (fine_others_lo1_1 + (fine_m_cross_2 + fine_m_cross_3));
  const double diagonal0_rest_1 = KSL_MUL(8.334199917267314e-28, 1.8051943758648296e-276
          + (1.0 + (fine_m_size_10 + fine_m_size_15)));
  const double fine_R_lo_1 = fine_R_left_rest_1
          - ksl_product_rest(c, turning_2, fine_alpha_v_2, fine_R_right_1)
          + (fine_m_cross_4 - fine_alpha_v_cross_3);
  const double R_padded_1 = 1.8051943758648296e-276
          + (fine_alpha_v_size_10
          + (KSL_MUL(fine_m_padded_2, fine_m_reach_3) + KSL_MUL(fine_m_padded_3, fine_m_reach_2))),
      R_rest_1 = KSL_MUL(8.316572842510914e-28, R_padded_1);
  const double fine_R_lo_2 = fine_R_left_rest_2
          + ksl_product_rest(c, turning_1, fine_alpha_v_1, fine_R_right_2)
          + (fine_m_cross_5 + fine_alpha_v_cross_2);
  const double R_padded_2 = 1.8051943758648296e-276
          + (fine_alpha_v_size_7
          + (KSL_MUL(fine_m_padded_2, fine_m_reach_5) + KSL_MUL(fine_m_padded_5, fine_m_reach_2))),
      R_rest_2 = KSL_MUL(8.316572842510914e-28, R_padded_2);
  const double fine_R_lo_3 = fine_R_left_rest_3
          + ksl_product_rest(c, turning_2, fine_alpha_v_2, fine_R_right_3)
          + (fine_m_cross_4 + fine_alpha_v_cross_3);
  const double R_lo_2 = 1.0 - (R_11 + R_right_2) - (fine_others_1 - R_right_2)
          - (fine_others_lo1_2 + (fine_m_cross_1 + fine_m_cross_3));
  const double diagonal1_rest_1 = KSL_MUL(8.334199917267314e-28, 1.8051943758648296e-276
          + (1.0 + (fine_m_size_15 + fine_m_size_5)));
  const double fine_R_lo_4 = fine_R_left_rest_4
          - ksl_product_rest(c, turning_0, fine_alpha_v_0, fine_R_right_4)
          + (fine_m_cross_6 - fine_alpha_v_cross_1);
  const double R_padded_3 = 1.8051943758648296e-276
          + (fine_alpha_v_size_4
          + (KSL_MUL(fine_m_padded_4, fine_m_reach_5) + KSL_MUL(fine_m_padded_5, fine_m_reach_4))),
      R_rest_3 = KSL_MUL(8.316572842510914e-28, R_padded_3);
  const double fine_R_lo_5 = fine_R_left_rest_5
          - ksl_product_rest(c, turning_1, fine_alpha_v_1, fine_R_right_5)
          + (fine_m_cross_5 - fine_alpha_v_cross_2);
  const double fine_R_lo_6 = fine_R_left_rest_6
          + ksl_product_rest(c, turning_0, fine_alpha_v_0, fine_R_right_6)
          + (fine_m_cross_6 + fine_alpha_v_cross_1);
  const double R_lo_3 = 1.0 - (R_22 + R_right_3) - (fine_others_2 - R_right_3)
          - (fine_others_lo1_3 + (fine_m_cross_1 + fine_m_cross_2));
  const double diagonal2_rest_1 = KSL_MUL(8.334199917267314e-28, 1.8051943758648296e-276
          + (1.0 + (fine_m_size_10 + fine_m_size_5))),
      diagonal0_bound_1 = KSL_MUL(1.0000000000000009, fabs(R_lo_1 + (R_00 - diagonal0)))
          + diagonal0_rest_1,
      R_bound_1 = KSL_MUL(1.0000000000000009, fabs(fine_R_01 - R_01 + fine_R_lo_1)) + R_rest_1,
      R_bound_2 = KSL_MUL(1.0000000000000009, fabs(fine_R_02 - R_02 + fine_R_lo_2)) + R_rest_2,
      R_bound_3 = KSL_MUL(1.0000000000000009, fabs(fine_R_10 - R_10 + fine_R_lo_3)) + R_rest_1,
      diagonal1_bound_1 = KSL_MUL(1.0000000000000009, fabs(R_lo_2 + (R_11 - diagonal1)))
          + diagonal1_rest_1,
      R_bound_4 = KSL_MUL(1.0000000000000009, fabs(fine_R_12 - R_12 + fine_R_lo_4)) + R_rest_3,
      R_bound_5 = KSL_MUL(1.0000000000000009, fabs(fine_R_20 - R_20 + fine_R_lo_5)) + R_rest_2,
      R_bound_6 = KSL_MUL(1.0000000000000009, fabs(fine_R_21 - R_21 + fine_R_lo_6)) + R_rest_3,
      diagonal2_bound_1 = KSL_MUL(1.0000000000000009, fabs(R_lo_3 + (R_22 - diagonal2)))
          + diagonal2_rest_1;
  R->m00 = diagonal0;
  R->m01 = R_01;
  R->m02 = R_02;
  R->m10 = R_10;
  R->m11 = diagonal1;
  R->m12 = R_12;
  R->m20 = R_20;
  R->m21 = R_21;
  R->m22 = diagonal2;
  R_bound->m00 = diagonal0_bound_1;
  R_bound->m01 = R_bound_1;
  R_bound->m02 = R_bound_2;
  R_bound->m10 = R_bound_3;
  R_bound->m11 = diagonal1_bound_1;
  R_bound->m12 = R_bound_4;
  R_bound->m20 = R_bound_5;
  R_bound->m21 = R_bound_6;
  R_bound->m22 = diagonal2_bound_1;
}

/* vo with exp vo~ = R, |vo| <= π; if R is not quite a rotation, its defect carries over to vo;
     |error of vo| <= vo_bound unless inf or NaN.
   R: rotation or other 3×3 matrix; vo, vo_bound: vector.
   244 mul, 466 add, 26 product error, 3 product rest, 16 div, 2 sqrt, 10 neg, 72 abs, 4
     copysign, 41 less, 7 equal, 107 select. */
static inline void ksl_SO3_log_certified(const ksl_mat3x3_t *R, ksl_vec3_t *vo,
    ksl_vec3_t *vo_bound) {
  const double p_0 = R->m21 - R->m12, p_right_1 = R->m21 - p_0,
      p_lo_1 = R->m21 - (p_0 + p_right_1) - (R->m12 - p_right_1),
      p_size_3 = fabs(R->m21) + fabs(R->m12);
  const double p_1 = R->m02 - R->m20, p_right_2 = R->m02 - p_1,
      p_lo_2 = R->m02 - (p_1 + p_right_2) - (R->m20 - p_right_2),
      p_size_6 = fabs(R->m02) + fabs(R->m20);
  const double p_2 = R->m10 - R->m01, p_right_3 = R->m10 - p_2,
      p_lo_3 = R->m10 - (p_2 + p_right_3) - (R->m01 - p_right_3),
      p_size_9 = fabs(R->m10) + fabs(R->m01);
  const double s_0 = R->m12 + R->m21, s_right_1 = s_0 - R->m12,
      s_lo_1 = R->m12 - (s_0 - s_right_1) + (R->m21 - s_right_1);
  const double s_1 = R->m02 + R->m20, s_right_2 = s_1 - R->m02,
      s_lo_2 = R->m02 - (s_1 - s_right_2) + (R->m20 - s_right_2);
  const double s_2 = R->m01 + R->m10, s_right_3 = s_2 - R->m01,
      s_lo_3 = R->m01 - (s_2 - s_right_3) + (R->m10 - s_right_3);
  const double first_0 = R->m00 + 1.0, first_right_1 = first_0 - R->m00,
      first_lo_1 = R->m00 - (first_0 - first_right_1) + (1.0 - first_right_1);
  const double first_1 = 1.0 - R->m00, first_right_2 = 1.0 - first_1,
      first_lo_2 = 1.0 - (first_1 + first_right_2) - (R->m00 - first_right_2);
  const double others_0 = R->m11 + R->m22, others_right_1 = others_0 - R->m11,
      others_lo_1 = R->m11 - (others_0 - others_right_1) + (R->m22 - others_right_1);
  const double others_1 = R->m11 - R->m22, others_right_2 = R->m11 - others_1,
      others_lo_2 = R->m11 - (others_1 + others_right_2) - (R->m22 - others_right_2);
  const double d_0 = first_0 + others_0, d_right_1 = d_0 - first_0,
      d_lo_1 = first_0 - (d_0 - d_right_1) + (others_0 - d_right_1) + others_lo_1 + first_lo_1,
      d_size_1 = 1.0 + fabs(R->m00) + (fabs(R->m11) + fabs(R->m22));
  const double d_1 = first_0 - others_0, d_right_2 = first_0 - d_1,
      d_lo_2 = first_0 - (d_1 + d_right_2) - (others_0 - d_right_2) - others_lo_1 + first_lo_1;
  const double d_2 = first_1 + others_1, d_right_3 = d_2 - first_1,
      d_lo_3 = first_1 - (d_2 - d_right_3) + (others_1 - d_right_3) + others_lo_2 + first_lo_2;
  const double d_3 = first_1 - others_1, d_right_4 = first_1 - d_3,
      d_lo_4 = first_1 - (d_3 + d_right_4) - (others_1 - d_right_4) - others_lo_2 + first_lo_2;
  const double low_0 = R->m11 < R->m00 ? d_1 : s_2, low_lo_1 = R->m11 < R->m00 ? d_lo_2 : s_lo_3,
      low_size_1 = R->m11 < R->m00 ? d_size_1 : p_size_9;
  const double low_1 = R->m11 < R->m00 ? s_2 : d_2, low_lo_2 = R->m11 < R->m00 ? s_lo_3 : d_lo_3,
      low_size_2 = R->m11 < R->m00 ? p_size_9 : d_size_1;
  const double low_2 = R->m11 < R->m00 ? s_1 : s_0, low_lo_3 = R->m11 < R->m00 ? s_lo_2 : s_lo_1,
      low_size_3 = R->m11 < R->m00 ? p_size_6 : p_size_3;
  const double low_3 = R->m11 < R->m00 ? p_0 : p_1, low_lo_4 = R->m11 < R->m00 ? p_lo_1 : p_lo_2,
      low_size_4 = R->m11 < R->m00 ? p_size_3 : p_size_6;
  const double high_0a = -R->m11, high_0 = R->m00 < high_0a ? s_1 : p_0,
      high_lo_1 = R->m00 < high_0a ? s_lo_2 : p_lo_1,
      high_size_1 = R->m00 < high_0a ? p_size_6 : p_size_3;
  const double high_1 = R->m00 < high_0a ? s_0 : p_1,
      high_lo_2 = R->m00 < high_0a ? s_lo_1 : p_lo_2,
      high_size_2 = R->m00 < high_0a ? p_size_3 : p_size_6;
  const double high_2 = R->m00 < high_0a ? d_3 : p_2,
      high_lo_3 = R->m00 < high_0a ? d_lo_4 : p_lo_3,
      high_size_3 = R->m00 < high_0a ? d_size_1 : p_size_9;
  const double high_3 = R->m00 < high_0a ? p_2 : d_0,
      high_lo_4 = R->m00 < high_0a ? p_lo_3 : d_lo_1,
      high_size_4 = R->m00 < high_0a ? p_size_9 : d_size_1;
  const double column_0 = R->m22 < 0.0 ? low_0 : high_0,
      column_lo_1 = R->m22 < 0.0 ? low_lo_1 : high_lo_1,
      column_size_1 = R->m22 < 0.0 ? low_size_1 : high_size_1;
  const double column_1 = R->m22 < 0.0 ? low_1 : high_1,
      column_lo_2 = R->m22 < 0.0 ? low_lo_2 : high_lo_2,
      column_size_2 = R->m22 < 0.0 ? low_size_2 : high_size_2;
  const double column_2 = R->m22 < 0.0 ? low_2 : high_2,
      column_lo_3 = R->m22 < 0.0 ? low_lo_3 : high_lo_3,
      column_size_3 = R->m22 < 0.0 ? low_size_3 : high_size_3;
  const double column_3 = R->m22 < 0.0 ? low_3 : high_3,
      column_lo_4 = R->m22 < 0.0 ? low_lo_4 : high_lo_4,
      column_size_4 = R->m22 < 0.0 ? low_size_4 : high_size_4;
  const double upper_0a = -column_0, upper_0a_lo = -column_lo_1,
      upper_0 = column_3 < 0.0 ? upper_0a : column_0,
      upper_lo_1 = column_3 < 0.0 ? upper_0a_lo : column_lo_1,
      upper_rest_1 = KSL_MUL(1.6023738312796216e-30, 1.8051943758648296e-276 + column_size_4),
      upper_bound_1 = fabs(column_lo_4) + upper_rest_1, upper_size_2 = fabs(column_3 - 0.0),
      upper_rest_2 = KSL_MUL(1.6023738312796216e-30, 1.8051943758648296e-276 + column_size_1),
      upper_size_7 = fabs(column_lo_1) + upper_rest_2
          + (fabs(upper_0a_lo) + upper_rest_2 + fabs(upper_0a - column_0));
  const double upper_1a = -column_1, upper_1a_lo = -column_lo_2,
      upper_1 = column_3 < 0.0 ? upper_1a : column_1,
      upper_lo_2 = column_3 < 0.0 ? upper_1a_lo : column_lo_2,
      upper_rest_3 = KSL_MUL(1.6023738312796216e-30, 1.8051943758648296e-276 + column_size_2),
      upper_size_14 = fabs(column_lo_2) + upper_rest_3
          + (fabs(upper_1a_lo) + upper_rest_3 + fabs(upper_1a - column_1));
  const double upper_2a = -column_2, upper_2a_lo = -column_lo_3,
      upper_2 = column_3 < 0.0 ? upper_2a : column_2,
      upper_lo_3 = column_3 < 0.0 ? upper_2a_lo : column_lo_3,
      upper_rest_4 = KSL_MUL(1.6023738312796216e-30, 1.8051943758648296e-276 + column_size_3),
      upper_size_21 = fabs(column_lo_3) + upper_rest_4
          + (fabs(upper_2a_lo) + upper_rest_4 + fabs(upper_2a - column_2));
  const double upper_3a = -column_3, upper_3a_lo = -column_lo_4,
      upper_3 = column_3 < 0.0 ? upper_3a : column_3,
      upper_lo_4 = column_3 < 0.0 ? upper_3a_lo : column_lo_4,
      upper_size_28 = upper_bound_1
          + (fabs(upper_3a_lo) + upper_rest_1 + fabs(upper_3a - column_3));
  const double v_s_size_0 = fabs(upper_0),
      v_s_size_padded_1 = 1.8051943758648296e-276
          + (column_size_1
          + KSL_MUL(1.5845630613906556e+29, upper_bound_1 < upper_size_2 ? 0.0 : upper_size_7));
  const double v_s_size_1 = fabs(upper_1),
      v_s_size_padded_2 = 1.8051943758648296e-276
          + (column_size_2
          + KSL_MUL(1.5845630613906556e+29, upper_bound_1 < upper_size_2 ? 0.0 : upper_size_14));
  const double v_s_size_2 = fabs(upper_2),
      v_s_size_padded_3 = 1.8051943758648296e-276
          + (column_size_3
          + KSL_MUL(1.5845630613906556e+29, upper_bound_1 < upper_size_2 ? 0.0 : upper_size_21));
  const double v_s_largest1 = v_s_size_0 < v_s_size_1 ? v_s_size_1 : v_s_size_0;
  const double v_s_largest2 = v_s_largest1 < v_s_size_2 ? v_s_size_2 : v_s_largest1;
  const double v_s_b = 6.703903964971299e+153 < v_s_largest2 ? 3.7291703656001034e-155 : 1.0,
      v_s_b_size_1 = 6.703903964971299e+153 < v_s_largest2 ? 3.7291703656001034e-155 : 1.0,
      v_s_d = v_s_largest2 < 256.0 ? 1.3093562431584567e+151 : v_s_b,
      v_s_d_size_1 = v_s_largest2 < 256.0 ? 1.3093562431584567e+151 : v_s_b_size_1,
      v_s = v_s_largest2 < 1.955159272639747e-149 ? 1.0715086071862673e+301 : v_s_d,
      v_s_size_3 = v_s_largest2 < 1.955159272639747e-149 ? 1.0715086071862673e+301 : v_s_d_size_1;
  const double v_y_0 = KSL_MUL(upper_0, v_s), v_y_inverse_1 = 1.0 / v_s,
      v_y_lo_1 = KSL_MUL(upper_0 - KSL_MUL(v_y_0, v_y_inverse_1) + upper_lo_1, v_s);
  const double v_y_1 = KSL_MUL(upper_1, v_s),
      v_y_lo_2 = KSL_MUL(upper_1 - KSL_MUL(v_y_1, v_y_inverse_1) + upper_lo_2, v_s);
  const double v_y_2 = KSL_MUL(upper_2, v_s),
      v_y_lo_3 = KSL_MUL(upper_2 - KSL_MUL(v_y_2, v_y_inverse_1) + upper_lo_3, v_s);
  const double v_n_a = KSL_MUL(v_y_0, v_y_0),
      v_n_a_padded_1 = 1.8051943758648296e-276 + KSL_MUL(v_s_size_3, v_s_size_padded_1),
      v_n_a_size_2 = KSL_MUL(v_n_a_padded_1, fabs(v_y_0)
          + KSL_MUL(140737488355328.0, fabs(v_y_lo_1)
          + KSL_MUL(6.705320021857442e-30, v_n_a_padded_1))), v_n_b = KSL_MUL(v_y_1, v_y_1),
      v_n_b_padded_1 = 1.8051943758648296e-276 + KSL_MUL(v_s_size_3, v_s_size_padded_2),
      v_n_b_size_2 = KSL_MUL(v_n_b_padded_1, fabs(v_y_1)
          + KSL_MUL(140737488355328.0, fabs(v_y_lo_2)
          + KSL_MUL(6.705320021857442e-30, v_n_b_padded_1))), v_n_c = v_n_a + v_n_b,
      v_n_c_right_1 = v_n_c - v_n_a,
      v_n_c_lo1_1 = ksl_product_rest(v_y_0, v_y_0, v_n_a, v_n_c - v_n_c_right_1)
          + ksl_product_rest(v_y_1, v_y_1, v_n_b, v_n_c_right_1), v_n_d = KSL_MUL(v_y_2, v_y_2),
      v_n_d_padded_1 = 1.8051943758648296e-276 + KSL_MUL(v_s_size_3, v_s_size_padded_3),
      v_n_d_size_2 = KSL_MUL(v_n_d_padded_1, fabs(v_y_2)
          + KSL_MUL(140737488355328.0, fabs(v_y_lo_3)
          + KSL_MUL(6.705320021857442e-30, v_n_d_padded_1))), v_n_e = v_n_c + v_n_d,
      v_n_e_right_1 = v_n_e - v_n_c,
      v_n_e_lo1_1 = v_n_c - (v_n_e - v_n_e_right_1)
          + ksl_product_rest(v_y_2, v_y_2, v_n_d, v_n_e_right_1),
      v_n_c_lo = v_n_c_lo1_1
          + (KSL_MUL(v_y_lo_1, v_y_0) + KSL_MUL(v_y_0, v_y_lo_1)
          + (KSL_MUL(v_y_lo_2, v_y_1) + KSL_MUL(v_y_1, v_y_lo_2))),
      v_n_e_lo = v_n_e_lo1_1 + (KSL_MUL(v_y_lo_3, v_y_2) + KSL_MUL(v_y_2, v_y_lo_3)) + v_n_c_lo,
      v_n = sqrt(v_n_e), v_n_product_1 = KSL_MUL(v_n, v_n), v_n_twice_1 = v_n + v_n,
      v_n_lo = (v_n_e - v_n_product_1 - ksl_product_error(v_n, v_n, v_n_product_1) + v_n_e_lo)
          / (v_n == 0.0 ? 1.0 : v_n_twice_1),
      v_n_padded_1 = 1.8051943758648296e-276
          + (v_n_a_size_2 + v_n_a_size_2 + (v_n_b_size_2 + v_n_b_size_2)
          + (v_n_d_size_2 + v_n_d_size_2)),
      v_n_bound_1 = fabs(v_n_e_lo) + KSL_MUL(1.150011758590251e-29, v_n_padded_1),
      v_n_size_4 = KSL_MUL(fabs(v_n_e) + KSL_MUL(140737488355328.0, v_n_bound_1), v_n_padded_1
          / v_n / v_n_e),
      v_n_size_8 = KSL_MUL(1.1418664350501995e+29, sqrt(v_n_bound_1) + fabs(v_n_lo));
  const double v_r_b = v_s < 1.0 ? 2.6815615859885194e+154 : 1.0,
      v_r_b_size_1 = v_s < 1.0 ? 2.6815615859885194e+154 : 1.0,
      v_r_d = 1.0 < v_s ? 7.637340908749012e-152 : v_r_b,
      v_r_d_size_1 = 1.0 < v_s ? 7.637340908749012e-152 : v_r_b_size_1,
      v_r = 1.3093562431584567e+151 < v_s ? 9.332636185032189e-302 : v_r_d;
  const double n = KSL_MUL(v_n, v_r), n_lo = KSL_MUL(v_n - KSL_MUL(n, 1.0 / v_r) + v_n_lo, v_r),
      n_padded_1 = 1.8051943758648296e-276
          + (v_n + (KSL_MUL(4.0, v_n_bound_1) < v_n_e ? v_n_size_4 : v_n_size_8)),
      n_size_1 = KSL_MUL(n_padded_1, 1.3093562431584567e+151 < v_s ? 9.332636185032189e-302
          : v_r_d_size_1);
  const double half = ksl_atan2(n, upper_3), half_size0_1 = fabs(n), half_size1_1 = fabs(upper_3),
      half_most_1 = half_size0_1 < half_size1_1 ? half_size1_1 : half_size0_1,
      half_divisor_1 = half_most_1 == 0.0 ? 1.0 : half_most_1, half_part0_1 = n / half_divisor_1,
      half_part1_1 = upper_3 / half_divisor_1,
      half_divisor2_1 = KSL_MUL(half_divisor_1, KSL_MUL(half_part1_1, half_part1_1)
          + KSL_MUL(half_part0_1, half_part0_1)),
      half_more_1 = (KSL_MUL(half_part1_1, n_lo) - KSL_MUL(half_part0_1, upper_lo_4))
          / (half_most_1 == 0.0 ? 1.0 : half_divisor2_1),
      half_lo = ksl_atan2_error(n, upper_3, half) + half_more_1,
      half_padded_1 = 1.8051943758648296e-276 + n_size_1,
      half_padded_2 = 1.8051943758648296e-276
          + (column_size_4
          + KSL_MUL(1.5845630613906556e+29, upper_bound_1 < upper_size_2 ? 0.0 : upper_size_28)),
      half_size_2 = fabs(n), half_size_3 = fabs(upper_3),
      half_size_5 = half_size_2 < half_size_3 ? half_size_3 : half_size_2,
      half_bound_1 = fabs(n_lo) + KSL_MUL(9.423194733875307e-30, half_padded_1),
      half_bound_2 = fabs(upper_lo_4) + KSL_MUL(6.508104019725916e-30, half_padded_2),
      half_size_11 = (half_bound_2 + (1.8051943758648296e-276 + half_bound_1)) / half_size_5,
      half_size_13 = KSL_MUL(half_size_11, half_size_11), half_size_15 = 7.0 + fabs(half_lo),
      half_size_18 = half_bound_2 < upper_3 ? half_size_13 : half_size_15,
      half_size_19 = half_bound_1 < half_size_2 ? half_size_13 : half_size_18,
      half_size_21 = KSL_MUL(4.527322338646221e+28, half_size_11 < 0.25 ? half_size_19
          : half_size_15);
  const double divisor = n == 0.0 ? 1.0 : n, divisor_lo = n == 0.0 ? 0.0 : n_lo,
      divisor_size_8 = fabs(1.0 - n) + half_bound_1;
  const double theta = KSL_MUL(2.0, half);
  const double k = theta / divisor, k_product_1 = KSL_MUL(k, divisor),
      k_lo = (theta - k_product_1 - ksl_product_error(k, divisor, k_product_1)
          + KSL_MUL(2.0, half_lo) - KSL_MUL(k, divisor_lo)) / divisor;
  const double divisor_size_11 = (n == 0.0 ? 1.0 : n_size_1)
          + KSL_MUL(6.338250583290453e+28, half_bound_1 < 5e-324 + fabs(n - 0.0) ? 0.0
          : divisor_size_8);
  const double k_padded_2 = 1.8051943758648296e-276 + divisor_size_11, k_size_1 = fabs(k),
      k_size_2 = fabs(divisor),
      k_padded_1 = 1.8051943758648296e-276
          + KSL_MUL(2.0, fabs(half) + (half_padded_1 + half_padded_2) / half_size_5 + half_size_21),
      k_bound_1 = fabs(divisor_lo) + KSL_MUL(1.6270263928446146e-29, k_padded_2),
      k_size_8 = (k_padded_1 + KSL_MUL(k_padded_2, k_size_1))
          / (KSL_MUL(4.0, k_bound_1) < k_size_2 ? k_size_2 : 0.0);
  const double vector_0 = KSL_MUL(upper_0, k),
      vector_padded_1 = 1.8051943758648296e-276
          + (k_size_1 + KSL_MUL(k_size_2 + KSL_MUL(140737488355328.0, k_bound_1), k_size_8)
          / k_size_2),
      vector_reach_1 = fabs(upper_0)
          + KSL_MUL(140737488355328.0, fabs(upper_lo_1)
          + KSL_MUL(6.508104019725916e-30, v_s_size_padded_1)),
      vector_reach_2 = k_size_1
          + KSL_MUL(140737488355328.0, fabs(k_lo)
          + KSL_MUL(3.316915129670074e-29, vector_padded_1));
  const double vector_1 = KSL_MUL(upper_1, k),
      vector_reach_3 = fabs(upper_1)
          + KSL_MUL(140737488355328.0, fabs(upper_lo_2)
          + KSL_MUL(6.508104019725916e-30, v_s_size_padded_2));
  const double vector_2 = KSL_MUL(upper_2, k),
      vector_reach_4 = fabs(upper_2)
          + KSL_MUL(140737488355328.0, fabs(upper_lo_3)
          + KSL_MUL(6.508104019725916e-30, v_s_size_padded_3));
  const double vector_padded_2 = 1.8051943758648296e-276
          + (KSL_MUL(vector_padded_1, vector_reach_1) + KSL_MUL(v_s_size_padded_1, vector_reach_2)),
      vector_error_3 = fabs(ksl_product_error(upper_0, k, vector_0)
          + (KSL_MUL(upper_lo_1, k) + KSL_MUL(upper_0, k_lo))),
      vector_padded_3 = 1.8051943758648296e-276
          + (KSL_MUL(vector_padded_1, vector_reach_3) + KSL_MUL(v_s_size_padded_2, vector_reach_2)),
      vector_error_5 = fabs(ksl_product_error(upper_1, k, vector_1)
          + (KSL_MUL(upper_lo_2, k) + KSL_MUL(upper_1, k_lo))),
      vector_padded_4 = 1.8051943758648296e-276
          + (KSL_MUL(vector_padded_1, vector_reach_4) + KSL_MUL(v_s_size_padded_3, vector_reach_2)),
      vector_error_7 = fabs(ksl_product_error(upper_2, k, vector_2)
          + (KSL_MUL(upper_lo_3, k) + KSL_MUL(upper_2, k_lo)));
  const double R_n_0 = KSL_MUL(R->m11, R->m22) - KSL_MUL(R->m12, R->m21),
      R_n_1 = KSL_MUL(R->m02, R->m21) - KSL_MUL(R->m01, R->m22),
      R_n_2 = KSL_MUL(R->m01, R->m12) - KSL_MUL(R->m02, R->m11);
  const double R_det = KSL_MUL(R->m00, R_n_0) + KSL_MUL(R->m10, R_n_1) + KSL_MUL(R->m20, R_n_2);
  const double R_g_0 = KSL_MUL(R->m00, R->m00) + KSL_MUL(R->m10, R->m10) + KSL_MUL(R->m20, R->m20),
      R_g_1 = KSL_MUL(R->m00, R->m01) + KSL_MUL(R->m10, R->m11) + KSL_MUL(R->m20, R->m21),
      R_g_2 = KSL_MUL(R->m00, R->m02) + KSL_MUL(R->m10, R->m12) + KSL_MUL(R->m20, R->m22),
      R_g_3 = KSL_MUL(R->m01, R->m01) + KSL_MUL(R->m11, R->m11) + KSL_MUL(R->m21, R->m21),
      R_g_4 = KSL_MUL(R->m01, R->m02) + KSL_MUL(R->m11, R->m12) + KSL_MUL(R->m21, R->m22),
      R_g_5 = KSL_MUL(R->m02, R->m02) + KSL_MUL(R->m12, R->m12) + KSL_MUL(R->m22, R->m22);
  const double R_off_0 = R_det - 1.0, R_off_1 = R_g_0 - 1.0, R_off_4 = R_g_3 - 1.0,
      R_off_6 = R_g_5 - 1.0;
  const double R_defect_size_0 = fabs(R_off_0), R_defect_size_1 = fabs(R_off_1),
      R_defect_size_2 = fabs(R_g_1), R_defect_size_3 = fabs(R_g_2), R_defect_size_4 = fabs(R_off_4),
      R_defect_size_5 = fabs(R_g_4), R_defect_size_6 = fabs(R_off_6);
  const double R_defect_largest1 = R_defect_size_0 < R_defect_size_1 ? R_defect_size_1
          : R_defect_size_0;
  const double R_defect_largest2 = R_defect_largest1 < R_defect_size_2 ? R_defect_size_2
          : R_defect_largest1;
  const double R_defect_largest3 = R_defect_largest2 < R_defect_size_3 ? R_defect_size_3
          : R_defect_largest2;
  const double R_defect_largest4 = R_defect_largest3 < R_defect_size_4 ? R_defect_size_4
          : R_defect_largest3;
  const double R_defect_largest5 = R_defect_largest4 < R_defect_size_5 ? R_defect_size_5
          : R_defect_largest4;
  const double R_defect_largest6 = R_defect_largest5 < R_defect_size_6 ? R_defect_size_6
          : R_defect_largest5;
  const double R_unless_equal = R_defect_largest6 == 0.001 ? 0.0 : 1.0715086071862673e+301;
  const double R_unless_rotation = R_defect_largest6 < 0.001 ? 0.0 : R_unless_equal;
  const double R_excess = KSL_MUL(R_unless_rotation, 1.0715086071862673e+301),
      R_excess_0 = vector_error_3 + KSL_MUL(3.5202936421278755e-29, vector_padded_2) + R_excess,
      R_excess_1 = vector_error_5 + KSL_MUL(3.5202936421278755e-29, vector_padded_3) + R_excess,
      R_excess_2 = vector_error_7 + KSL_MUL(3.5202936421278755e-29, vector_padded_4) + R_excess;
  vo->x = vector_0;
  vo->y = vector_1;
  vo->z = vector_2;
  vo_bound->x = R_excess_0;
  vo_bound->y = R_excess_1;
  vo_bound->z = R_excess_2;
}

/* R = J_l(v) = I + (1 - cos θ)/θ^2 v~ + (θ - sin θ)/θ^3 v~^2, θ = |v|; |error of R| <= R_bound
     unless inf or NaN.
   v: vector; R, R_bound: rotation or other 3×3 matrix.
   433 mul, 747 add, 21 product error, 43 product rest, 16 div, 3 sqrt, 90 abs, 20 less, 1 equal,
     45 select. */
static inline void ksl_SO3_leftJacobian_certified(const ksl_vec3_t *v, ksl_mat3x3_t *R,
    ksl_mat3x3_t *R_bound) {
  const double size_0 = fabs(v->x), size_1 = fabs(v->y), size_2 = fabs(v->z);
  const double sizes = size_0 + size_1 + size_2;
  const double grid = KSL_MUL(sizes, 268435456.0);
  const double shifted_0 = v->x + grid, shifted_1 = v->y + grid, shifted_2 = v->z + grid;
  const double high_0 = shifted_0 - grid, high_1 = shifted_1 - grid, high_2 = shifted_2 - grid;
  const double low_0 = v->x - high_0, low_1 = v->y - high_1, low_2 = v->z - high_2;
  const double sum_0 = v->x + high_0, sum_1 = v->y + high_1, sum_2 = v->z + high_2;
  const double squares = KSL_MUL(high_0, high_0) + KSL_MUL(high_1, high_1)
          + KSL_MUL(high_2, high_2);
  const double cross = KSL_MUL(low_0, sum_0) + KSL_MUL(low_1, sum_1) + KSL_MUL(low_2, sum_2);
  const double x = squares + cross;
  const double theta_a = sqrt(x), theta = x < 1.0 ? 1.0 : theta_a;
  const double theta_shifted = grid + theta;
  const double theta_high = theta_shifted - grid;
  const double theta_low = theta - theta_high;
  const double theta_sum = theta + theta_high;
  const double cross_rest = cross - KSL_MUL(theta_low, theta_sum);
  const double exact = squares - KSL_MUL(theta_high, theta_high);
  const double residual = cross_rest + exact;
  const double small = KSL_MUL(0.5, residual) / theta;
  const double delta = fabs(small) < 0.0078125 ? small : 0.0;
  double far_cosine_a; const double far_sine_a = ksl_sincos(theta, &far_cosine_a);
  const double far_sine = x < 1.0 ? 1.0 : far_sine_a;
  const double far_cosine = x < 1.0 ? 0.0 : far_cosine_a;
  const double sine = KSL_MUL(delta, far_cosine) + far_sine;
  const double cosine = far_cosine - KSL_MUL(delta, far_sine);
  const double far_x = x < 1.0 ? 1.0 : x;
  const double middle_x = x < 4.0 ? 4.0 : x;
  const double closed1 = sine / theta;
  const double versine = 1.0 - cosine;
  const double closed2 = versine / far_x;
  const double rest3 = 1.0 - closed1;
  const double closed3 = rest3 / middle_x;
  const double g1g = KSL_MUL(x, KSL_MUL(x, KSL_MUL(x, KSL_MUL(6.446950284384474e-26, x)
          - 3.868170170630684e-23) + 1.9572941063391263e-20) - 8.22063524662433e-18),
      g1n = KSL_MUL(x, KSL_MUL(x, KSL_MUL(x, g1g + 2.8114572543455206e-15) - 7.647163731819816e-13)
          + 1.6059043836821613e-10) - 2.505210838544172e-08,
      g1u = KSL_MUL(x, KSL_MUL(x, KSL_MUL(x, KSL_MUL(x, g1n) + 2.7557319223985893e-06)
          - 0.0001984126984126984) + 0.008333333333333333),
      g1x = KSL_MUL(x, g1u - 0.16666666666666666) + 1.0, g1 = x < 1.0 ? g1x : closed1;
  const double g2g = KSL_MUL(x, KSL_MUL(x, KSL_MUL(x, KSL_MUL(2.4795962632247976e-27, x)
          - 1.6117375710961184e-24) + 8.896791392450574e-22) - 4.110317623312165e-19),
      g2n = KSL_MUL(x, KSL_MUL(x, KSL_MUL(x, g2g + 1.5619206968586225e-16) - 4.779477332387385e-14)
          + 1.1470745597729725e-11) - 2.08767569878681e-09,
      g2v = KSL_MUL(x, KSL_MUL(x, KSL_MUL(x, KSL_MUL(x, g2n) + 2.755731922398589e-07)
          - 2.48015873015873e-05) + 0.001388888888888889) - 0.041666666666666664,
      g2x = KSL_MUL(x, g2v) + 0.5, g2 = x < 1.0 ? g2x : closed2;
  const double g3g = KSL_MUL(x, KSL_MUL(x, KSL_MUL(x, KSL_MUL(9.183689863795546e-29, x)
          - 6.446950284384474e-26) + 3.868170170630684e-23) - 1.9572941063391263e-20),
      g3n = KSL_MUL(x, KSL_MUL(x, KSL_MUL(x, g3g + 8.22063524662433e-18) - 2.8114572543455206e-15)
          + 7.647163731819816e-13) - 1.6059043836821613e-10,
      g3u = KSL_MUL(x, KSL_MUL(x, KSL_MUL(x, KSL_MUL(x, g3n) + 2.505210838544172e-08)
          - 2.7557319223985893e-06) + 0.0001984126984126984),
      g3x = KSL_MUL(x, g3u - 0.008333333333333333) + 0.16666666666666666,
      g3 = x < 4.0 ? g3x : closed3;
  const double beta_v_0 = KSL_MUL(v->x, g3);
  const double beta_v_1 = KSL_MUL(v->y, g3);
  const double beta_v_2 = KSL_MUL(v->z, g3);
  const double m_0 = KSL_MUL(v->x, beta_v_0);
  const double m_1 = KSL_MUL(v->y, beta_v_1);
  const double m_2 = KSL_MUL(v->z, beta_v_2);
  const double m_3 = KSL_MUL(v->y, beta_v_0);
  const double m_4 = KSL_MUL(v->z, beta_v_0);
  const double m_5 = KSL_MUL(v->z, beta_v_1);
  const double others_0 = m_1 + m_2;
  const double others_1 = m_0 + m_2;
  const double others_2 = m_0 + m_1;
  const double diagonal0a = 1.0 - others_0, diagonal0b = g1 + m_0,
      diagonal0 = m_0 < others_0 ? diagonal0b : diagonal0a;
  const double diagonal1a = 1.0 - others_1, diagonal1b = g1 + m_1,
      diagonal1 = m_1 < others_1 ? diagonal1b : diagonal1a;
  const double diagonal2a = 1.0 - others_2, diagonal2b = g1 + m_2,
      diagonal2 = m_2 < others_2 ? diagonal2b : diagonal2a;
  const double alpha_v_0 = KSL_MUL(v->x, g2);
  const double alpha_v_1 = KSL_MUL(v->y, g2);
  const double alpha_v_2 = KSL_MUL(v->z, g2);
  const double R_01 = m_3 - alpha_v_2;
  const double R_02 = m_4 + alpha_v_1;
  const double R_10 = m_3 + alpha_v_2;
  const double R_12 = m_5 - alpha_v_0;
  const double R_20 = m_4 - alpha_v_1;
  const double R_21 = m_5 + alpha_v_0;
  const double halved_0 = KSL_MUL(0.5, v->x), halved_size_1 = fabs(v->x);
  const double halved_1 = KSL_MUL(0.5, v->y), halved_size_3 = fabs(v->y);
  const double halved_2 = KSL_MUL(0.5, v->z), halved_size_5 = fabs(v->z);
  const double y_a = KSL_MUL(halved_0, halved_0),
      y_a_padded_1 = 1.8051943758648296e-276 + KSL_MUL(0.5, halved_size_1),
      y_b = KSL_MUL(halved_1, halved_1),
      y_b_padded_1 = 1.8051943758648296e-276 + KSL_MUL(0.5, halved_size_3), y_c = y_a + y_b,
      y_c_right_1 = y_c - y_a, y_d = KSL_MUL(halved_2, halved_2),
      y_d_padded_1 = 1.8051943758648296e-276 + KSL_MUL(0.5, halved_size_5), y = y_c + y_d,
      y_right_1 = y - y_c,
      y_c_lo = ksl_product_rest(halved_0, halved_0, y_a, y_c - y_c_right_1)
          + ksl_product_rest(halved_1, halved_1, y_b, y_c_right_1),
      y_lo = y_c - (y - y_right_1) + ksl_product_rest(halved_2, halved_2, y_d, y_right_1) + y_c_lo,
      y_size_1 = KSL_MUL(y_a_padded_1, y_a_padded_1) + KSL_MUL(y_b_padded_1, y_b_padded_1)
          + KSL_MUL(y_d_padded_1, y_d_padded_1);
  const double half_angle = sqrt(y), half_angle_product_1 = KSL_MUL(half_angle, half_angle),
      half_angle_twice_1 = half_angle + half_angle,
      half_angle_residual_1 = y - half_angle_product_1
          - ksl_product_error(half_angle, half_angle, half_angle_product_1) + y_lo,
      half_angle_lo = half_angle_residual_1 / (half_angle == 0.0 ? 1.0 : half_angle_twice_1),
      half_angle_padded_1 = 1.8051943758648296e-276 + y_size_1,
      half_angle_bound_1 = fabs(y_lo) + KSL_MUL(2.5021685128863245e-30, half_angle_padded_1),
      half_angle_size_4 = KSL_MUL(fabs(y)
          + KSL_MUL(140737488355328.0, half_angle_bound_1), half_angle_padded_1 / half_angle / y),
      half_angle_size_6 = fabs(half_angle_lo),
      half_angle_size_8 = KSL_MUL(2.567393169377981e+29, sqrt(half_angle_bound_1)
          + half_angle_size_6),
      half_angle_size_12 = half_angle
          + (KSL_MUL(4.0, half_angle_bound_1) < y ? half_angle_size_4 : half_angle_size_8);
  double c; const double fine_sine = ksl_sincos(half_angle, &c);
  double c_own_error_1; const double fine_sine_own_error_1 = ksl_sincos_error(half_angle, fine_sine,
      c, &c_own_error_1);
  const double fine_sine_half_1 = KSL_MUL(half_angle_lo, 0.5);
  double fine_sine_half_cos_1; const double fine_sine_half_sin_1 = ksl_sincos(fine_sine_half_1,
      &fine_sine_half_cos_1);
  const double fine_sine_twice_1 = fine_sine_half_sin_1 + fine_sine_half_sin_1,
      fine_sine_padded_1 = 1.8051943758648296e-276 + half_angle_size_12,
      fine_sine_size_1 = 1.0 + fine_sine_padded_1;
  const double c_lo = c_own_error_1
          - KSL_MUL(KSL_MUL(fine_sine_half_cos_1, fine_sine)
          + KSL_MUL(fine_sine_half_sin_1, c), fine_sine_twice_1);
  const double sinc_divisor = half_angle < 1.4901161193847656e-08 ? 1.4901161193847656e-08
          : half_angle, sinc_divisor_lo = half_angle < 1.4901161193847656e-08 ? 0.0 : half_angle_lo,
      sinc_divisor_bound_1 = half_angle_size_6 + KSL_MUL(4.240128211918887e-30, fine_sine_padded_1),
      sinc_divisor_size_3 = fabs(half_angle - 1.4901161193847656e-08),
      sinc_divisor_size_7 = sinc_divisor_bound_1 + fabs(1.4901161193847656e-08 - half_angle),
      sinc_divisor_size_9 = KSL_MUL(9.054644677292507e+28, sinc_divisor_bound_1
          < sinc_divisor_size_3 ? 0.0 : sinc_divisor_size_7);
  const double sinc_quotient = fine_sine / sinc_divisor,
      sinc_quotient_product_1 = KSL_MUL(sinc_quotient, sinc_divisor);
  const double fine_sine_lo = fine_sine_own_error_1
          + KSL_MUL(KSL_MUL(fine_sine_half_cos_1, c)
          - KSL_MUL(fine_sine_half_sin_1, fine_sine), fine_sine_twice_1);
  const double sinc_quotient_exact_1 = fine_sine - sinc_quotient_product_1
          - ksl_product_error(sinc_quotient, sinc_divisor, sinc_quotient_product_1),
      sinc_quotient_lo = (sinc_quotient_exact_1 + fine_sine_lo
          - KSL_MUL(sinc_quotient, sinc_divisor_lo)) / sinc_divisor;
  const double sinc_divisor_size_10 = (half_angle < 1.4901161193847656e-08 ? 1.4901161193847656e-08
          : half_angle_size_12) + sinc_divisor_size_9;
  const double sinc_quotient_padded_2 = 1.8051943758648296e-276 + sinc_divisor_size_10,
      sinc_quotient_size_1 = fabs(sinc_quotient), sinc_quotient_size_2 = fabs(sinc_divisor),
      sinc_quotient_bound_1 = fabs(sinc_divisor_lo)
          + KSL_MUL(1.1389183198259759e-29, sinc_quotient_padded_2),
      sinc_quotient_size_4 = 1.8051943758648296e-276 + fine_sine_size_1
          + KSL_MUL(sinc_quotient_padded_2, sinc_quotient_size_1),
      sinc_quotient_size_8 = sinc_quotient_size_4
          / (KSL_MUL(4.0, sinc_quotient_bound_1) < sinc_quotient_size_2 ? sinc_quotient_size_2
          : 0.0),
      sinc_quotient_size_10 = KSL_MUL(sinc_quotient_size_2
          + KSL_MUL(140737488355328.0, sinc_quotient_bound_1), sinc_quotient_size_8)
          / sinc_quotient_size_2,
      sinc_quotient_size_11 = sinc_quotient_size_1 + sinc_quotient_size_10;
  const double sinc_a = KSL_MUL(0.16666666666666666, y), sinc_b = 1.0 - sinc_a,
      sinc_b_right_1 = 1.0 - sinc_b,
      sinc_b_lo1_1 = 1.0 - (sinc_b + sinc_b_right_1)
          - ksl_product_rest(0.16666666666666666, y, sinc_a, sinc_b_right_1),
      sinc_b_lo = sinc_b_lo1_1
          - (KSL_MUL(9.25185853854297e-18, y) + KSL_MUL(0.16666666666666666, y_lo)),
      sinc_b_size_1 = 1.0 + KSL_MUL(2290649224.7000003, y_size_1),
      sinc = half_angle < 1.4901161193847656e-08 ? sinc_b : sinc_quotient,
      sinc_lo = half_angle < 1.4901161193847656e-08 ? sinc_b_lo : sinc_quotient_lo,
      sinc_size_4 = fabs(sinc_b_lo)
          + KSL_MUL(8.120831909935717e-28, 1.8051943758648296e-276 + sinc_b_size_1)
          + fabs(sinc_b - sinc_quotient),
      sinc_size_5 = fabs(sinc_quotient_lo)
          + KSL_MUL(1.8842277118313698e-29, 1.8051943758648296e-276 + sinc_quotient_size_11)
          + sinc_size_4,
      sinc_size_7 = KSL_MUL(1.2325982855554354e+27, sinc_divisor_bound_1 < sinc_divisor_size_3
          ? 0.0 : sinc_size_5);
  const double fine_g1 = KSL_MUL(c, sinc),
      fine_g1_cross_1 = KSL_MUL(c_lo, sinc) + KSL_MUL(c, sinc_lo),
      fine_g1_padded_1 = 1.8051943758648296e-276
          + ((half_angle < 1.4901161193847656e-08 ? sinc_b_size_1 : sinc_quotient_size_11)
          + sinc_size_7),
      fine_g1_reach_2 = fabs(sinc)
          + KSL_MUL(140737488355328.0, fabs(sinc_lo)
          + KSL_MUL(8.120832873841084e-28, fine_g1_padded_1)),
      fine_g1_size_2 = KSL_MUL(fine_g1_padded_1, fabs(c)
          + KSL_MUL(140737488355328.0, fabs(c_lo)
          + KSL_MUL(8.677471603123253e-30, fine_sine_size_1))),
      fine_g1_size_5 = fine_g1_size_2 + KSL_MUL(fine_g1_reach_2, fine_sine_size_1);
  const double fine_g2a = KSL_MUL(sinc, sinc),
      fine_g2a_size_1 = KSL_MUL(fine_g1_padded_1, fine_g1_reach_2),
      fine_g2 = KSL_MUL(0.5, fine_g2a),
      fine_g2_cross2_1 = KSL_MUL(0.5, ksl_product_error(sinc, sinc, fine_g2a)
          + (KSL_MUL(sinc_lo, sinc) + KSL_MUL(sinc, sinc_lo)));
  const double fine_rest3 = 1.0 - fine_g1, fine_rest3_right_1 = 1.0 - fine_rest3;
  const double fine_x = KSL_MUL(4.0, y), fine_x_cross2_1 = KSL_MUL(4.0, y_lo),
      fine_x_size_1 = KSL_MUL(4.0, y_size_1);
  const double fine_far_x = fine_x < 1.0 ? 1.0 : fine_x,
      fine_far_x_lo = fine_x < 1.0 ? 0.0 : fine_x_cross2_1,
      fine_far_x_padded_1 = 1.8051943758648296e-276 + fine_x_size_1,
      fine_far_x_bound_1 = fabs(fine_x_cross2_1)
          + KSL_MUL(2.8103175390871538e-30, fine_far_x_padded_1),
      fine_far_x_size_3 = fabs(fine_x - 1.0),
      fine_far_x_size_7 = fine_far_x_bound_1 + fabs(1.0 - fine_x),
      fine_far_x_size_9 = KSL_MUL(5.28187582188787e+28, fine_far_x_bound_1 < fine_far_x_size_3
          ? 0.0 : fine_far_x_size_7);
  const double fine_closed3 = fine_rest3 / fine_far_x,
      fine_closed3_product_1 = KSL_MUL(fine_closed3, fine_far_x);
  const double fine_rest3_lo = 1.0 - (fine_rest3 + fine_rest3_right_1)
          - ksl_product_rest(c, sinc, fine_g1, fine_rest3_right_1) - fine_g1_cross_1;
  const double fine_closed3_numerator_1 = fine_rest3 - fine_closed3_product_1
          - ksl_product_error(fine_closed3, fine_far_x, fine_closed3_product_1) + fine_rest3_lo,
      fine_closed3_lo = (fine_closed3_numerator_1 - KSL_MUL(fine_closed3, fine_far_x_lo))
          / fine_far_x,
      fine_closed3_padded_2 = 1.8051943758648296e-276
          + ((fine_x < 1.0 ? 1.0 : fine_x_size_1) + fine_far_x_size_9),
      fine_closed3_size_1 = fabs(fine_closed3), fine_closed3_size_2 = fabs(fine_far_x),
      fine_closed3_bound_1 = fabs(fine_far_x_lo)
          + KSL_MUL(1.9524315162482833e-29, fine_closed3_padded_2),
      fine_closed3_size_4 = 1.8051943758648296e-276 + (1.0 + fine_g1_size_5)
          + KSL_MUL(fine_closed3_padded_2, fine_closed3_size_1),
      fine_closed3_size_8 = fine_closed3_size_4
          / (KSL_MUL(4.0, fine_closed3_bound_1) < fine_closed3_size_2 ? fine_closed3_size_2 : 0.0),
      fine_closed3_size_10 = KSL_MUL(fine_closed3_size_2
          + KSL_MUL(140737488355328.0, fine_closed3_bound_1), fine_closed3_size_8)
          / fine_closed3_size_2, fine_closed3_size_11 = fine_closed3_size_1 + fine_closed3_size_10;
  const double series5a = KSL_MUL(1.216125041553518e-34, fine_x),
      series5b = 1.1309962886447716e-31 - series5a,
      series5b_right_1 = 1.1309962886447716e-31 - series5b,
      series5b_lo1_1 = 1.1309962886447716e-31 - (series5b + series5b_right_1)
          - ksl_product_rest(1.216125041553518e-34, fine_x, series5a, series5b_right_1),
      series5b_lo = series5b_lo1_1
          - (KSL_MUL(5.586290567888806e-51, fine_x)
          + KSL_MUL(1.216125041553518e-34, fine_x_cross2_1)) + 1.0498015412959506e-47,
      series5c = KSL_MUL(fine_x, series5b),
      series5c_padded_1 = 1.8051943758648296e-276
          + (1.1309962886447716e-31 + KSL_MUL(5.702613188320821e-10, fine_x_size_1)),
      series5c_reach_1 = fabs(fine_x) + KSL_MUL(140737488355328.0, fine_far_x_bound_1),
      series5c_reach_2 = fabs(series5b)
          + KSL_MUL(140737488355328.0, fabs(series5b_lo)
          + KSL_MUL(8.12514599395154e-28, series5c_padded_1)),
      series5d = series5c - 9.183689863795546e-29, series5d_right_1 = series5c - series5d,
      series5d_lo1_1 = ksl_product_rest(fine_x, series5b, series5c, series5d + series5d_right_1)
          - (9.183689863795546e-29 - series5d_right_1),
      series5d_lo = series5d_lo1_1 - 1.4303150396787322e-45
          + (KSL_MUL(fine_x_cross2_1, series5b) + KSL_MUL(fine_x, series5b_lo)),
      series5e = KSL_MUL(fine_x, series5d),
      series5d_size_1 = 9.183689863795546e-29
          + (KSL_MUL(series5c_padded_1, series5c_reach_1)
          + KSL_MUL(fine_far_x_padded_1, series5c_reach_2)),
      series5e_padded_1 = 1.8051943758648296e-276 + series5d_size_1,
      series5e_reach_1 = fabs(series5d)
          + KSL_MUL(140737488355328.0, fabs(series5d_lo)
          + KSL_MUL(8.19207783918962e-28, series5e_padded_1)),
      series5f = series5e + 6.446950284384474e-26, series5f_right_1 = series5f - series5e,
      series5f_lo1_1 = ksl_product_rest(fine_x, series5d, series5e, series5f - series5f_right_1)
          + (6.446950284384474e-26 - series5f_right_1),
      series5f_lo = series5f_lo1_1 + -1.9330404233703465e-42
          + (KSL_MUL(fine_x_cross2_1, series5d) + KSL_MUL(fine_x, series5d_lo)),
      series5g = KSL_MUL(fine_x, series5f),
      series5f_size_1 = 6.446950284384474e-26
          + (KSL_MUL(series5c_reach_1, series5e_padded_1)
          + KSL_MUL(fine_far_x_padded_1, series5e_reach_1)),
      series5g_padded_1 = 1.8051943758648296e-276 + series5f_size_1,
      series5g_reach_1 = fabs(series5f)
          + KSL_MUL(140737488355328.0, fabs(series5f_lo)
          + KSL_MUL(8.261228355723635e-28, series5g_padded_1)),
      series5h = series5g - 3.868170170630684e-23, series5h_right_1 = series5g - series5h,
      series5h_lo1_1 = ksl_product_rest(fine_x, series5f, series5g, series5h + series5h_right_1)
          - (3.868170170630684e-23 - series5h_right_1),
      series5h_lo = series5h_lo1_1 - -8.843177655482344e-40
          + (KSL_MUL(fine_x_cross2_1, series5f) + KSL_MUL(fine_x, series5f_lo)),
      series5i = KSL_MUL(fine_x, series5h),
      series5h_size_1 = 3.868170170630684e-23
          + (KSL_MUL(series5c_reach_1, series5g_padded_1)
          + KSL_MUL(fine_far_x_padded_1, series5g_reach_1)),
      series5i_padded_1 = 1.8051943758648296e-276 + series5h_size_1,
      series5i_reach_1 = fabs(series5h)
          + KSL_MUL(140737488355328.0, fabs(series5h_lo)
          + KSL_MUL(8.332597543553583e-28, series5i_padded_1)),
      series5j = series5i + 1.9572941063391263e-20, series5j_right_1 = series5j - series5i,
      series5j_lo1_1 = ksl_product_rest(fine_x, series5h, series5i, series5j - series5j_right_1)
          + (1.9572941063391263e-20 - series5j_right_1),
      series5j_lo = series5j_lo1_1 + -1.3643503830087908e-36
          + (KSL_MUL(fine_x_cross2_1, series5h) + KSL_MUL(fine_x, series5h_lo)),
      series5k = KSL_MUL(fine_x, series5j),
      series5j_size_1 = 1.9572941063391263e-20
          + (KSL_MUL(series5c_reach_1, series5i_padded_1)
          + KSL_MUL(fine_far_x_padded_1, series5i_reach_1)),
      series5k_padded_1 = 1.8051943758648296e-276 + series5j_size_1,
      series5k_reach_1 = fabs(series5j)
          + KSL_MUL(140737488355328.0, fabs(series5j_lo)
          + KSL_MUL(8.406185404560257e-28, series5k_padded_1)),
      series5l = series5k - 8.22063524662433e-18, series5l_right_1 = series5k - series5l,
      series5l_lo1_1 = ksl_product_rest(fine_x, series5j, series5k, series5l + series5l_right_1)
          - (8.22063524662433e-18 - series5l_right_1),
      series5l_lo = series5l_lo1_1 - 2.2141894119604265e-34
          + (KSL_MUL(fine_x_cross2_1, series5j) + KSL_MUL(fine_x, series5j_lo)),
      series5m = KSL_MUL(fine_x, series5l),
      series5l_size_1 = 8.22063524662433e-18
          + (KSL_MUL(series5c_reach_1, series5k_padded_1)
          + KSL_MUL(fine_far_x_padded_1, series5k_reach_1)),
      series5m_padded_1 = 1.8051943758648296e-276 + series5l_size_1,
      series5m_reach_1 = fabs(series5l)
          + KSL_MUL(140737488355328.0, fabs(series5l_lo)
          + KSL_MUL(8.481991936862865e-28, series5m_padded_1)),
      series5n = series5m + 2.8114572543455206e-15, series5n_right_1 = series5n - series5m,
      series5n_lo1_1 = ksl_product_rest(fine_x, series5l, series5m, series5n - series5n_right_1)
          + (2.8114572543455206e-15 - series5n_right_1),
      series5n_lo = series5n_lo1_1 + 1.6508842730861433e-31
          + (KSL_MUL(fine_x_cross2_1, series5l) + KSL_MUL(fine_x, series5l_lo)),
      series5o = KSL_MUL(fine_x, series5n),
      series5n_size_1 = 2.8114572543455206e-15
          + (KSL_MUL(series5c_reach_1, series5m_padded_1)
          + KSL_MUL(fine_far_x_padded_1, series5m_reach_1)),
      series5o_padded_1 = 1.8051943758648296e-276 + series5n_size_1,
      series5o_reach_1 = fabs(series5n)
          + KSL_MUL(140737488355328.0, fabs(series5n_lo)
          + KSL_MUL(8.560017140461409e-28, series5o_padded_1)),
      series5p = series5o - 7.647163731819816e-13, series5p_right_1 = series5o - series5p,
      series5p_lo1_1 = ksl_product_rest(fine_x, series5n, series5o, series5p + series5p_right_1)
          - (7.647163731819816e-13 - series5p_right_1),
      series5p_lo = series5p_lo1_1 - 7.03872877733453e-30
          + (KSL_MUL(fine_x_cross2_1, series5n) + KSL_MUL(fine_x, series5n_lo)),
      series5q = KSL_MUL(fine_x, series5p),
      series5p_size_1 = 7.647163731819816e-13
          + (KSL_MUL(series5c_reach_1, series5o_padded_1)
          + KSL_MUL(fine_far_x_padded_1, series5o_reach_1)),
      series5q_padded_1 = 1.8051943758648296e-276 + series5p_size_1,
      series5q_reach_1 = fabs(series5p)
          + KSL_MUL(140737488355328.0, fabs(series5p_lo)
          + KSL_MUL(8.640261015355885e-28, series5q_padded_1)),
      series5r = series5q + 1.6059043836821613e-10, series5r_right_1 = series5r - series5q,
      series5r_lo1_1 = ksl_product_rest(fine_x, series5p, series5q, series5r - series5r_right_1)
          + (1.6059043836821613e-10 - series5r_right_1),
      series5r_lo = series5r_lo1_1 + 1.2585294588752098e-26
          + (KSL_MUL(fine_x_cross2_1, series5p) + KSL_MUL(fine_x, series5p_lo)),
      series5s = KSL_MUL(fine_x, series5r),
      series5r_size_1 = 1.6059043836821613e-10
          + (KSL_MUL(series5c_reach_1, series5q_padded_1)
          + KSL_MUL(fine_far_x_padded_1, series5q_reach_1)),
      series5s_padded_1 = 1.8051943758648296e-276 + series5r_size_1,
      series5s_reach_1 = fabs(series5r)
          + KSL_MUL(140737488355328.0, fabs(series5r_lo)
          + KSL_MUL(8.722723561546295e-28, series5s_padded_1)),
      series5t = series5s - 2.505210838544172e-08, series5t_right_1 = series5s - series5t,
      series5t_lo1_1 = ksl_product_rest(fine_x, series5r, series5s, series5t + series5t_right_1)
          - (2.505210838544172e-08 - series5t_right_1),
      series5t_lo = series5t_lo1_1 - -1.448814070935912e-24
          + (KSL_MUL(fine_x_cross2_1, series5r) + KSL_MUL(fine_x, series5r_lo)),
      series5u = KSL_MUL(fine_x, series5t),
      series5t_size_1 = 2.505210838544172e-08
          + (KSL_MUL(series5c_reach_1, series5s_padded_1)
          + KSL_MUL(fine_far_x_padded_1, series5s_reach_1)),
      series5u_padded_1 = 1.8051943758648296e-276 + series5t_size_1,
      series5u_reach_1 = fabs(series5t)
          + KSL_MUL(140737488355328.0, fabs(series5t_lo)
          + KSL_MUL(8.80740477903264e-28, series5u_padded_1)),
      series5v = series5u + 2.7557319223985893e-06, series5v_right_1 = series5v - series5u,
      series5v_lo1_1 = ksl_product_rest(fine_x, series5t, series5u, series5v - series5v_right_1)
          + (2.7557319223985893e-06 - series5v_right_1),
      series5v_lo = series5v_lo1_1 + -1.858393274046472e-22
          + (KSL_MUL(fine_x_cross2_1, series5t) + KSL_MUL(fine_x, series5t_lo)),
      series5w = KSL_MUL(fine_x, series5v),
      series5v_size_1 = 2.7557319223985893e-06
          + (KSL_MUL(series5c_reach_1, series5u_padded_1)
          + KSL_MUL(fine_far_x_padded_1, series5u_reach_1)),
      series5w_padded_1 = 1.8051943758648296e-276 + series5v_size_1,
      series5w_reach_1 = fabs(series5v)
          + KSL_MUL(140737488355328.0, fabs(series5v_lo)
          + KSL_MUL(8.894304667814918e-28, series5w_padded_1)),
      series5x = series5w - 0.0001984126984126984, series5x_right_1 = series5w - series5x,
      series5x_lo1_1 = ksl_product_rest(fine_x, series5v, series5w, series5x + series5x_right_1)
          - (0.0001984126984126984 - series5x_right_1),
      series5x_lo = series5x_lo1_1 - 1.7209558293420705e-22
          + (KSL_MUL(fine_x_cross2_1, series5v) + KSL_MUL(fine_x, series5v_lo)),
      series5y = KSL_MUL(fine_x, series5x),
      series5x_size_1 = 0.0001984126984126984
          + (KSL_MUL(series5c_reach_1, series5w_padded_1)
          + KSL_MUL(fine_far_x_padded_1, series5w_reach_1)),
      series5y_padded_1 = 1.8051943758648296e-276 + series5x_size_1,
      series5y_reach_1 = fabs(series5x)
          + KSL_MUL(140737488355328.0, fabs(series5x_lo)
          + KSL_MUL(8.98342322789313e-28, series5y_padded_1)),
      series5 = series5y + 0.008333333333333333, series5_right_1 = series5 - series5y,
      series5_lo1_1 = ksl_product_rest(fine_x, series5x, series5y, series5 - series5_right_1)
          + (0.008333333333333333 - series5_right_1),
      series5_lo = series5_lo1_1 + 1.1564823173178714e-19
          + (KSL_MUL(fine_x_cross2_1, series5x) + KSL_MUL(fine_x, series5x_lo));
  const double fine_g3a = KSL_MUL(fine_x, series5);
  const double series5_size_1 = 0.008333333333333333
          + (KSL_MUL(series5c_reach_1, series5y_padded_1)
          + KSL_MUL(fine_far_x_padded_1, series5y_reach_1));
  const double fine_g3a_padded_1 = 1.8051943758648296e-276 + series5_size_1,
      fine_g3a_reach_1 = fabs(series5)
          + KSL_MUL(140737488355328.0, fabs(series5_lo)
          + KSL_MUL(9.07476046114807e-28, fine_g3a_padded_1)),
      fine_g3b = 0.16666666666666666 - fine_g3a, fine_g3b_right_1 = 0.16666666666666666 - fine_g3b,
      fine_g3b_lo1_1 = 0.16666666666666666 - (fine_g3b + fine_g3b_right_1)
          - ksl_product_rest(fine_x, series5, fine_g3a, fine_g3b_right_1),
      fine_g3b_lo = fine_g3b_lo1_1
          - (KSL_MUL(fine_x_cross2_1, series5) + KSL_MUL(fine_x, series5_lo))
          + 9.25185853854297e-18,
      fine_g3b_size_1 = 0.16666666666666666
          + (KSL_MUL(fine_g3a_padded_1, series5c_reach_1)
          + KSL_MUL(fine_far_x_padded_1, fine_g3a_reach_1)),
      fine_g3 = fine_x < 1.0 ? fine_g3b : fine_closed3,
      fine_g3_lo = fine_x < 1.0 ? fine_g3b_lo : fine_closed3_lo,
      fine_g3_size_4 = fabs(fine_g3b_lo)
          + KSL_MUL(9.168316367579732e-28, 1.8051943758648296e-276 + fine_g3b_size_1)
          + fabs(fine_g3b - fine_closed3),
      fine_g3_size_5 = fabs(fine_closed3_lo)
          + KSL_MUL(8.304820816109472e-28, 1.8051943758648296e-276 + fine_closed3_size_11)
          + fine_g3_size_4,
      fine_g3_size_7 = KSL_MUL(1.0948341329470242e+27, fine_far_x_bound_1 < fine_far_x_size_3 ? 0.0
          : fine_g3_size_5);
  const double fine_beta_v_0 = KSL_MUL(v->x, fine_g3),
      fine_beta_v_padded_1 = 1.8051943758648296e-276
          + ((fine_x < 1.0 ? fine_g3b_size_1 : fine_closed3_size_11) + fine_g3_size_7);
  const double fine_beta_v_1 = KSL_MUL(v->y, fine_g3);
  const double fine_beta_v_2 = KSL_MUL(v->z, fine_g3);
  const double fine_beta_v_lo_1 = ksl_product_error(v->x, fine_g3, fine_beta_v_0)
          + KSL_MUL(v->x, fine_g3_lo), fine_m_0 = KSL_MUL(v->x, fine_beta_v_0),
      fine_m_cross2_1 = KSL_MUL(v->x, fine_beta_v_lo_1),
      fine_m_padded_1 = 1.8051943758648296e-276 + KSL_MUL(fine_beta_v_padded_1, halved_size_1),
      fine_m_size_1 = KSL_MUL(fine_m_padded_1, halved_size_1);
  const double fine_beta_v_lo_2 = ksl_product_error(v->y, fine_g3, fine_beta_v_1)
          + KSL_MUL(v->y, fine_g3_lo), fine_m_1 = KSL_MUL(v->y, fine_beta_v_1),
      fine_m_cross2_2 = KSL_MUL(v->y, fine_beta_v_lo_2),
      fine_m_padded_2 = 1.8051943758648296e-276 + KSL_MUL(fine_beta_v_padded_1, halved_size_3),
      fine_m_size_2 = KSL_MUL(fine_m_padded_2, halved_size_3);
  const double fine_m_2 = KSL_MUL(v->z, fine_beta_v_2),
      fine_m_cross2_3 = KSL_MUL(v->z, ksl_product_error(v->z, fine_g3, fine_beta_v_2)
          + KSL_MUL(v->z, fine_g3_lo)),
      fine_m_size_3 = KSL_MUL(1.8051943758648296e-276
          + KSL_MUL(fine_beta_v_padded_1, halved_size_5), halved_size_5);
  const double fine_m_3 = KSL_MUL(v->y, fine_beta_v_0),
      fine_m_cross2_4 = KSL_MUL(v->y, fine_beta_v_lo_1);
  const double fine_m_4 = KSL_MUL(v->z, fine_beta_v_0),
      fine_m_cross2_5 = KSL_MUL(v->z, fine_beta_v_lo_1);
  const double fine_m_5 = KSL_MUL(v->z, fine_beta_v_1),
      fine_m_cross2_6 = KSL_MUL(v->z, fine_beta_v_lo_2);
  const double fine_others_0 = fine_m_1 + fine_m_2, fine_others_right_1 = fine_others_0 - fine_m_1,
      fine_others_left_rest_1 = ksl_product_rest(v->y, fine_beta_v_1, fine_m_1, fine_others_0
          - fine_others_right_1),
      fine_others_lo1_1 = fine_others_left_rest_1
          + ksl_product_rest(v->z, fine_beta_v_2, fine_m_2, fine_others_right_1),
      fine_others_lo_1 = fine_others_lo1_1 + (fine_m_cross2_2 + fine_m_cross2_3),
      fine_others_size_1 = fine_m_size_2 + fine_m_size_3;
  const double fine_others_1 = fine_m_0 + fine_m_2, fine_others_right_2 = fine_others_1 - fine_m_0,
      fine_others_left_rest_2 = ksl_product_rest(v->x, fine_beta_v_0, fine_m_0, fine_others_1
          - fine_others_right_2),
      fine_others_lo1_2 = fine_others_left_rest_2
          + ksl_product_rest(v->z, fine_beta_v_2, fine_m_2, fine_others_right_2),
      fine_others_lo_2 = fine_others_lo1_2 + (fine_m_cross2_1 + fine_m_cross2_3),
      fine_others_size_2 = fine_m_size_1 + fine_m_size_3;
  const double fine_others_2 = fine_m_0 + fine_m_1, fine_others_right_3 = fine_others_2 - fine_m_0,
      fine_others_left_rest_3 = ksl_product_rest(v->x, fine_beta_v_0, fine_m_0, fine_others_2
          - fine_others_right_3),
      fine_others_lo1_3 = fine_others_left_rest_3
          + ksl_product_rest(v->y, fine_beta_v_1, fine_m_1, fine_others_right_3),
      fine_others_lo_3 = fine_others_lo1_3 + (fine_m_cross2_1 + fine_m_cross2_2),
      fine_others_size_3 = fine_m_size_1 + fine_m_size_2;
  const double fine_diagonal0a = 1.0 - fine_others_0,
      fine_diagonal0a_right_1 = 1.0 - fine_diagonal0a,
      fine_diagonal0a_lo = 1.0 - (fine_diagonal0a + fine_diagonal0a_right_1)
          - (fine_others_0 - fine_diagonal0a_right_1) - fine_others_lo_1,
      fine_diagonal0a_size_1 = 1.0 + fine_others_size_1, fine_diagonal0b = fine_g1 + fine_m_0,
      fine_diagonal0b_right_1 = fine_diagonal0b - fine_g1,
      fine_diagonal0b_left_rest_1 = ksl_product_rest(c, sinc, fine_g1, fine_diagonal0b
          - fine_diagonal0b_right_1),
      fine_diagonal0b_lo1_1 = fine_diagonal0b_left_rest_1
          + ksl_product_rest(v->x, fine_beta_v_0, fine_m_0, fine_diagonal0b_right_1),
      fine_diagonal0b_lo = fine_diagonal0b_lo1_1 + (fine_g1_cross_1 + fine_m_cross2_1),
      fine_diagonal0b_size_1 = fine_g1_size_5 + fine_m_size_1,
      fine_diagonal0_error_1 = fabs(ksl_product_error(v->x, fine_beta_v_0, fine_m_0)
          + fine_m_cross2_1),
      fine_diagonal0_bound_2 = fabs(fine_others_lo_1)
          + KSL_MUL(9.232045404485834e-28, 1.8051943758648296e-276 + fine_others_size_1),
      fine_diagonal0_bound_3 = fabs(fine_diagonal0b_lo)
          + KSL_MUL(9.232045404485834e-28, 1.8051943758648296e-276 + fine_diagonal0b_size_1),
      fine_diagonal0_bound_4 = fabs(fine_diagonal0a_lo)
          + KSL_MUL(9.267791630980215e-28, 1.8051943758648296e-276 + fine_diagonal0a_size_1),
      fine_diagonal0_size_9 = fine_diagonal0_bound_4
          + (fine_diagonal0_bound_3 + fabs(fine_diagonal0b - fine_diagonal0a)),
      fine_diagonal0_size_2 = fine_diagonal0_error_1
          + KSL_MUL(9.197038735090097e-28, 1.8051943758648296e-276 + fine_m_size_1)
          + fine_diagonal0_bound_2,
      fine_diagonal0_size_11 = KSL_MUL(1.0835017304955739e+27, fine_diagonal0_size_2
          < fabs(fine_m_0 - fine_others_0) ? 0.0 : fine_diagonal0_size_9);
  const double fine_diagonal1a = 1.0 - fine_others_1,
      fine_diagonal1a_right_1 = 1.0 - fine_diagonal1a,
      fine_diagonal1a_lo = 1.0 - (fine_diagonal1a + fine_diagonal1a_right_1)
          - (fine_others_1 - fine_diagonal1a_right_1) - fine_others_lo_2,
      fine_diagonal1a_size_1 = 1.0 + fine_others_size_2, fine_diagonal1b = fine_g1 + fine_m_1,
      fine_diagonal1b_right_1 = fine_diagonal1b - fine_g1,
      fine_diagonal1b_left_rest_1 = ksl_product_rest(c, sinc, fine_g1, fine_diagonal1b
          - fine_diagonal1b_right_1),
      fine_diagonal1b_lo1_1 = fine_diagonal1b_left_rest_1
          + ksl_product_rest(v->y, fine_beta_v_1, fine_m_1, fine_diagonal1b_right_1),
      fine_diagonal1b_lo = fine_diagonal1b_lo1_1 + (fine_g1_cross_1 + fine_m_cross2_2),
      fine_diagonal1b_size_1 = fine_g1_size_5 + fine_m_size_2,
      fine_diagonal1_error_1 = fabs(ksl_product_error(v->y, fine_beta_v_1, fine_m_1)
          + fine_m_cross2_2),
      fine_diagonal1_bound_2 = fabs(fine_others_lo_2)
          + KSL_MUL(9.232045404485834e-28, 1.8051943758648296e-276 + fine_others_size_2),
      fine_diagonal1_bound_3 = fabs(fine_diagonal1b_lo)
          + KSL_MUL(9.232045404485834e-28, 1.8051943758648296e-276 + fine_diagonal1b_size_1),
      fine_diagonal1_bound_4 = fabs(fine_diagonal1a_lo)
          + KSL_MUL(9.267791630980215e-28, 1.8051943758648296e-276 + fine_diagonal1a_size_1),
      fine_diagonal1_size_9 = fine_diagonal1_bound_4
          + (fine_diagonal1_bound_3 + fabs(fine_diagonal1b - fine_diagonal1a)),
      fine_diagonal1_size_2 = fine_diagonal1_error_1
          + KSL_MUL(9.197038735090097e-28, 1.8051943758648296e-276 + fine_m_size_2)
          + fine_diagonal1_bound_2,
      fine_diagonal1_size_11 = KSL_MUL(1.0835017304955739e+27, fine_diagonal1_size_2
          < fabs(fine_m_1 - fine_others_1) ? 0.0 : fine_diagonal1_size_9);
  const double fine_diagonal2a = 1.0 - fine_others_2,
      fine_diagonal2a_right_1 = 1.0 - fine_diagonal2a,
      fine_diagonal2a_lo = 1.0 - (fine_diagonal2a + fine_diagonal2a_right_1)
          - (fine_others_2 - fine_diagonal2a_right_1) - fine_others_lo_3,
      fine_diagonal2a_size_1 = 1.0 + fine_others_size_3, fine_diagonal2b = fine_g1 + fine_m_2,
      fine_diagonal2b_right_1 = fine_diagonal2b - fine_g1,
      fine_diagonal2b_left_rest_1 = ksl_product_rest(c, sinc, fine_g1, fine_diagonal2b
          - fine_diagonal2b_right_1),
      fine_diagonal2b_lo1_1 = fine_diagonal2b_left_rest_1
          + ksl_product_rest(v->z, fine_beta_v_2, fine_m_2, fine_diagonal2b_right_1),
      fine_diagonal2b_lo = fine_diagonal2b_lo1_1 + (fine_g1_cross_1 + fine_m_cross2_3),
      fine_diagonal2b_size_1 = fine_g1_size_5 + fine_m_size_3,
      fine_diagonal2_error_1 = fabs(ksl_product_error(v->z, fine_beta_v_2, fine_m_2)
          + fine_m_cross2_3),
      fine_diagonal2_bound_2 = fabs(fine_others_lo_3)
          + KSL_MUL(9.232045404485834e-28, 1.8051943758648296e-276 + fine_others_size_3),
      fine_diagonal2_bound_3 = fabs(fine_diagonal2b_lo)
          + KSL_MUL(9.232045404485834e-28, 1.8051943758648296e-276 + fine_diagonal2b_size_1),
      fine_diagonal2_bound_4 = fabs(fine_diagonal2a_lo)
          + KSL_MUL(9.267791630980215e-28, 1.8051943758648296e-276 + fine_diagonal2a_size_1),
      fine_diagonal2_size_9 = fine_diagonal2_bound_4
          + (fine_diagonal2_bound_3 + fabs(fine_diagonal2b - fine_diagonal2a)),
      fine_diagonal2_size_2 = fine_diagonal2_error_1
          + KSL_MUL(9.197038735090097e-28, 1.8051943758648296e-276 + fine_m_size_3)
          + fine_diagonal2_bound_2,
      fine_diagonal2_size_11 = KSL_MUL(1.0835017304955739e+27, fine_diagonal2_size_2
          < fabs(fine_m_2 - fine_others_2) ? 0.0 : fine_diagonal2_size_9);
  const double fine_alpha_v_0 = KSL_MUL(v->x, fine_g2),
      fine_alpha_v_cross2_1 = KSL_MUL(v->x, fine_g2_cross2_1),
      fine_alpha_v_padded_1 = 1.8051943758648296e-276
          + KSL_MUL(0.5, fine_g2a_size_1 + fine_g2a_size_1);
  const double fine_alpha_v_1 = KSL_MUL(v->y, fine_g2),
      fine_alpha_v_cross2_2 = KSL_MUL(v->y, fine_g2_cross2_1);
  const double fine_alpha_v_2 = KSL_MUL(v->z, fine_g2),
      fine_alpha_v_cross2_3 = KSL_MUL(v->z, fine_g2_cross2_1);
  const double fine_R_01 = fine_m_3 - fine_alpha_v_2, fine_R_right_1 = fine_m_3 - fine_R_01,
      fine_R_left_rest_1 = ksl_product_rest(v->y, fine_beta_v_0, fine_m_3, fine_R_01
          + fine_R_right_1);
  const double fine_R_02 = fine_m_4 + fine_alpha_v_1, fine_R_right_2 = fine_R_02 - fine_m_4,
      fine_R_left_rest_2 = ksl_product_rest(v->z, fine_beta_v_0, fine_m_4, fine_R_02
          - fine_R_right_2);
  const double fine_R_10 = fine_m_3 + fine_alpha_v_2, fine_R_right_3 = fine_R_10 - fine_m_3,
      fine_R_left_rest_3 = ksl_product_rest(v->y, fine_beta_v_0, fine_m_3, fine_R_10
          - fine_R_right_3);
  const double fine_R_12 = fine_m_5 - fine_alpha_v_0, fine_R_right_4 = fine_m_5 - fine_R_12,
      fine_R_left_rest_4 = ksl_product_rest(v->z, fine_beta_v_1, fine_m_5, fine_R_12
          + fine_R_right_4);
  const double fine_R_20 = fine_m_4 - fine_alpha_v_1, fine_R_right_5 = fine_m_4 - fine_R_20,
      fine_R_left_rest_5 = ksl_product_rest(v->z, fine_beta_v_0, fine_m_4, fine_R_20
          + fine_R_right_5);
  const double fine_R_21 = fine_m_5 + fine_alpha_v_0, fine_R_right_6 = fine_R_21 - fine_m_5,
      fine_R_left_rest_6 = ksl_product_rest(v->z, fine_beta_v_1, fine_m_5, fine_R_21
          - fine_R_right_6);
  const double diagonal0_apart_1 = (fine_m_0 < fine_others_0 ? fine_diagonal0b : fine_diagonal0a)
          - diagonal0,
      diagonal0_padded_1 = 1.8051943758648296e-276
          + ((fine_m_0 < fine_others_0 ? fine_diagonal0b_size_1 : fine_diagonal0a_size_1)
          + fine_diagonal0_size_11),
      diagonal0_error_2 = KSL_MUL(1.0000000000000009, fabs(diagonal0_apart_1
          + (fine_m_0 < fine_others_0 ? fine_diagonal0b_lo : fine_diagonal0a_lo)));
  const double fine_R_lo_1 = fine_R_left_rest_1
          - ksl_product_rest(v->z, fine_g2, fine_alpha_v_2, fine_R_right_1)
          + (fine_m_cross2_4 - fine_alpha_v_cross2_3);
  const double R_padded_1 = 1.8051943758648296e-276
          + (KSL_MUL(fine_alpha_v_padded_1, halved_size_5)
          + KSL_MUL(fine_m_padded_1, halved_size_3)),
      R_rest_1 = KSL_MUL(9.232045404485834e-28, R_padded_1);
  const double fine_R_lo_2 = fine_R_left_rest_2
          + ksl_product_rest(v->y, fine_g2, fine_alpha_v_1, fine_R_right_2)
          + (fine_m_cross2_5 + fine_alpha_v_cross2_2);
  const double R_padded_2 = 1.8051943758648296e-276
          + (KSL_MUL(fine_alpha_v_padded_1, halved_size_3)
          + KSL_MUL(fine_m_padded_1, halved_size_5)),
      R_rest_2 = KSL_MUL(9.232045404485834e-28, R_padded_2);
  const double fine_R_lo_3 = fine_R_left_rest_3
          + ksl_product_rest(v->z, fine_g2, fine_alpha_v_2, fine_R_right_3)
          + (fine_m_cross2_4 + fine_alpha_v_cross2_3);
  const double diagonal1_apart_1 = (fine_m_1 < fine_others_1 ? fine_diagonal1b : fine_diagonal1a)
          - diagonal1,
      diagonal1_padded_1 = 1.8051943758648296e-276
          + ((fine_m_1 < fine_others_1 ? fine_diagonal1b_size_1 : fine_diagonal1a_size_1)
          + fine_diagonal1_size_11),
      diagonal1_error_2 = KSL_MUL(1.0000000000000009, fabs(diagonal1_apart_1
          + (fine_m_1 < fine_others_1 ? fine_diagonal1b_lo : fine_diagonal1a_lo)));
  const double fine_R_lo_4 = fine_R_left_rest_4
          - ksl_product_rest(v->x, fine_g2, fine_alpha_v_0, fine_R_right_4)
          + (fine_m_cross2_6 - fine_alpha_v_cross2_1);
  const double R_padded_3 = 1.8051943758648296e-276
          + (KSL_MUL(fine_alpha_v_padded_1, halved_size_1)
          + KSL_MUL(fine_m_padded_2, halved_size_5)),
      R_rest_3 = KSL_MUL(9.232045404485834e-28, R_padded_3);
  const double fine_R_lo_5 = fine_R_left_rest_5
          - ksl_product_rest(v->y, fine_g2, fine_alpha_v_1, fine_R_right_5)
          + (fine_m_cross2_5 - fine_alpha_v_cross2_2);
  const double fine_R_lo_6 = fine_R_left_rest_6
          + ksl_product_rest(v->x, fine_g2, fine_alpha_v_0, fine_R_right_6)
          + (fine_m_cross2_6 + fine_alpha_v_cross2_1);
  const double diagonal2_apart_1 = (fine_m_2 < fine_others_2 ? fine_diagonal2b : fine_diagonal2a)
          - diagonal2,
      diagonal2_padded_1 = 1.8051943758648296e-276
          + ((fine_m_2 < fine_others_2 ? fine_diagonal2b_size_1 : fine_diagonal2a_size_1)
          + fine_diagonal2_size_11),
      diagonal2_error_2 = KSL_MUL(1.0000000000000009, fabs(diagonal2_apart_1
          + (fine_m_2 < fine_others_2 ? fine_diagonal2b_lo : fine_diagonal2a_lo))),
      diagonal0_bound_1 = diagonal0_error_2 + KSL_MUL(9.267792597706769e-28, diagonal0_padded_1),
      R_bound_1 = KSL_MUL(1.0000000000000009, fabs(fine_R_01 - R_01 + fine_R_lo_1)) + R_rest_1,
      R_bound_2 = KSL_MUL(1.0000000000000009, fabs(fine_R_02 - R_02 + fine_R_lo_2)) + R_rest_2,
      R_bound_3 = KSL_MUL(1.0000000000000009, fabs(fine_R_10 - R_10 + fine_R_lo_3)) + R_rest_1,
      diagonal1_bound_1 = diagonal1_error_2 + KSL_MUL(9.267792597706769e-28, diagonal1_padded_1),
      R_bound_4 = KSL_MUL(1.0000000000000009, fabs(fine_R_12 - R_12 + fine_R_lo_4)) + R_rest_3,
      R_bound_5 = KSL_MUL(1.0000000000000009, fabs(fine_R_20 - R_20 + fine_R_lo_5)) + R_rest_2,
      R_bound_6 = KSL_MUL(1.0000000000000009, fabs(fine_R_21 - R_21 + fine_R_lo_6)) + R_rest_3,
      diagonal2_bound_1 = diagonal2_error_2 + KSL_MUL(9.267792597706769e-28, diagonal2_padded_1);
  R->m00 = diagonal0;
  R->m01 = R_01;
  R->m02 = R_02;
  R->m10 = R_10;
  R->m11 = diagonal1;
  R->m12 = R_12;
  R->m20 = R_20;
  R->m21 = R_21;
  R->m22 = diagonal2;
  R_bound->m00 = diagonal0_bound_1;
  R_bound->m01 = R_bound_1;
  R_bound->m02 = R_bound_2;
  R_bound->m10 = R_bound_3;
  R_bound->m11 = diagonal1_bound_1;
  R_bound->m12 = R_bound_4;
  R_bound->m20 = R_bound_5;
  R_bound->m21 = R_bound_6;
  R_bound->m22 = diagonal2_bound_1;
}

/* R = J_r(v) = I - (1 - cos θ)/θ^2 v~ + (θ - sin θ)/θ^3 v~^2, θ = |v|; |error of R| <= R_bound
     unless inf or NaN.
   v: vector; R, R_bound: rotation or other 3×3 matrix.
   433 mul, 747 add, 21 product error, 43 product rest, 16 div, 3 sqrt, 12 neg, 90 abs, 20 less,
     1 equal, 45 select. */
static inline void ksl_SO3_rightJacobian_certified(const ksl_vec3_t *v, ksl_mat3x3_t *R,
    ksl_mat3x3_t *R_bound) {
  const double size_0 = fabs(v->x), size_1 = fabs(v->y), size_2 = fabs(v->z);
  const double sizes = size_0 + size_1 + size_2;
  const double grid = KSL_MUL(sizes, 268435456.0);
  const double shifted_0 = v->x + grid, shifted_1 = v->y + grid, shifted_2 = v->z + grid;
  const double high_0 = shifted_0 - grid, high_1 = shifted_1 - grid, high_2 = shifted_2 - grid;
  const double low_0 = v->x - high_0, low_1 = v->y - high_1, low_2 = v->z - high_2;
  const double sum_0 = v->x + high_0, sum_1 = v->y + high_1, sum_2 = v->z + high_2;
  const double squares = KSL_MUL(high_0, high_0) + KSL_MUL(high_1, high_1)
          + KSL_MUL(high_2, high_2);
  const double cross = KSL_MUL(low_0, sum_0) + KSL_MUL(low_1, sum_1) + KSL_MUL(low_2, sum_2);
  const double x = squares + cross;
  const double theta_a = sqrt(x), theta = x < 1.0 ? 1.0 : theta_a;
  const double theta_shifted = grid + theta;
  const double theta_high = theta_shifted - grid;
  const double theta_low = theta - theta_high;
  const double theta_sum = theta + theta_high;
  const double cross_rest = cross - KSL_MUL(theta_low, theta_sum);
  const double exact = squares - KSL_MUL(theta_high, theta_high);
  const double residual = cross_rest + exact;
  const double small = KSL_MUL(0.5, residual) / theta;
  const double delta = fabs(small) < 0.0078125 ? small : 0.0;
  double far_cosine_a; const double far_sine_a = ksl_sincos(theta, &far_cosine_a);
  const double far_sine = x < 1.0 ? 1.0 : far_sine_a;
  const double far_cosine = x < 1.0 ? 0.0 : far_cosine_a;
  const double sine = KSL_MUL(delta, far_cosine) + far_sine;
  const double cosine = far_cosine - KSL_MUL(delta, far_sine);
  const double far_x = x < 1.0 ? 1.0 : x;
  const double middle_x = x < 4.0 ? 4.0 : x;
  const double closed1 = sine / theta;
  const double versine = 1.0 - cosine;
  const double closed2 = versine / far_x;
  const double rest3 = 1.0 - closed1;
  const double closed3 = rest3 / middle_x;
  const double g1g = KSL_MUL(x, KSL_MUL(x, KSL_MUL(x, KSL_MUL(6.446950284384474e-26, x)
          - 3.868170170630684e-23) + 1.9572941063391263e-20) - 8.22063524662433e-18),
      g1n = KSL_MUL(x, KSL_MUL(x, KSL_MUL(x, g1g + 2.8114572543455206e-15) - 7.647163731819816e-13)
          + 1.6059043836821613e-10) - 2.505210838544172e-08,
      g1u = KSL_MUL(x, KSL_MUL(x, KSL_MUL(x, KSL_MUL(x, g1n) + 2.7557319223985893e-06)
          - 0.0001984126984126984) + 0.008333333333333333),
      g1x = KSL_MUL(x, g1u - 0.16666666666666666) + 1.0, g1 = x < 1.0 ? g1x : closed1;
  const double g2g = KSL_MUL(x, KSL_MUL(x, KSL_MUL(x, KSL_MUL(2.4795962632247976e-27, x)
          - 1.6117375710961184e-24) + 8.896791392450574e-22) - 4.110317623312165e-19),
      g2n = KSL_MUL(x, KSL_MUL(x, KSL_MUL(x, g2g + 1.5619206968586225e-16) - 4.779477332387385e-14)
          + 1.1470745597729725e-11) - 2.08767569878681e-09,
      g2v = KSL_MUL(x, KSL_MUL(x, KSL_MUL(x, KSL_MUL(x, g2n) + 2.755731922398589e-07)
          - 2.48015873015873e-05) + 0.001388888888888889) - 0.041666666666666664,
      g2x = KSL_MUL(x, g2v) + 0.5, g2 = x < 1.0 ? g2x : closed2;
  const double g3g = KSL_MUL(x, KSL_MUL(x, KSL_MUL(x, KSL_MUL(9.183689863795546e-29, x)
          - 6.446950284384474e-26) + 3.868170170630684e-23) - 1.9572941063391263e-20),
      g3n = KSL_MUL(x, KSL_MUL(x, KSL_MUL(x, g3g + 8.22063524662433e-18) - 2.8114572543455206e-15)
          + 7.647163731819816e-13) - 1.6059043836821613e-10,
      g3u = KSL_MUL(x, KSL_MUL(x, KSL_MUL(x, KSL_MUL(x, g3n) + 2.505210838544172e-08)
          - 2.7557319223985893e-06) + 0.0001984126984126984),
      g3x = KSL_MUL(x, g3u - 0.008333333333333333) + 0.16666666666666666,
      g3 = x < 4.0 ? g3x : closed3;
  const double beta_v_0 = KSL_MUL(v->x, g3);
  const double beta_v_1 = KSL_MUL(v->y, g3);
  const double beta_v_2 = KSL_MUL(v->z, g3);
  const double m_0 = KSL_MUL(v->x, beta_v_0);
  const double m_1 = KSL_MUL(v->y, beta_v_1);
  const double m_2 = KSL_MUL(v->z, beta_v_2);
  const double m_3 = KSL_MUL(v->y, beta_v_0);
  const double m_4 = KSL_MUL(v->z, beta_v_0);
  const double m_5 = KSL_MUL(v->z, beta_v_1);
  const double others_0 = m_1 + m_2;
  const double others_1 = m_0 + m_2;
  const double others_2 = m_0 + m_1;
  const double diagonal0a = 1.0 - others_0, diagonal0b = g1 + m_0,
      diagonal0 = m_0 < others_0 ? diagonal0b : diagonal0a;
  const double diagonal1a = 1.0 - others_1, diagonal1b = g1 + m_1,
      diagonal1 = m_1 < others_1 ? diagonal1b : diagonal1a;
  const double diagonal2a = 1.0 - others_2, diagonal2b = g1 + m_2,
      diagonal2 = m_2 < others_2 ? diagonal2b : diagonal2a;
  const double alpha_v_0 = -KSL_MUL(v->x, g2);
  const double alpha_v_1 = -KSL_MUL(v->y, g2);
  const double alpha_v_2 = -KSL_MUL(v->z, g2);
  const double R_01 = m_3 - alpha_v_2;
  const double R_02 = m_4 + alpha_v_1;
  const double R_10 = m_3 + alpha_v_2;
  const double R_12 = m_5 - alpha_v_0;
  const double R_20 = m_4 - alpha_v_1;
  const double R_21 = m_5 + alpha_v_0;
  const double halved_0 = KSL_MUL(0.5, v->x), halved_size_1 = fabs(v->x);
  const double halved_1 = KSL_MUL(0.5, v->y), halved_size_3 = fabs(v->y);
  const double halved_2 = KSL_MUL(0.5, v->z), halved_size_5 = fabs(v->z);
  const double y_a = KSL_MUL(halved_0, halved_0),
      y_a_padded_1 = 1.8051943758648296e-276 + KSL_MUL(0.5, halved_size_1),
      y_b = KSL_MUL(halved_1, halved_1),
      y_b_padded_1 = 1.8051943758648296e-276 + KSL_MUL(0.5, halved_size_3), y_c = y_a + y_b,
      y_c_right_1 = y_c - y_a, y_d = KSL_MUL(halved_2, halved_2),
      y_d_padded_1 = 1.8051943758648296e-276 + KSL_MUL(0.5, halved_size_5), y = y_c + y_d,
      y_right_1 = y - y_c,
      y_c_lo = ksl_product_rest(halved_0, halved_0, y_a, y_c - y_c_right_1)
          + ksl_product_rest(halved_1, halved_1, y_b, y_c_right_1),
      y_lo = y_c - (y - y_right_1) + ksl_product_rest(halved_2, halved_2, y_d, y_right_1) + y_c_lo,
      y_size_1 = KSL_MUL(y_a_padded_1, y_a_padded_1) + KSL_MUL(y_b_padded_1, y_b_padded_1)
          + KSL_MUL(y_d_padded_1, y_d_padded_1);
  const double half_angle = sqrt(y), half_angle_product_1 = KSL_MUL(half_angle, half_angle),
      half_angle_twice_1 = half_angle + half_angle,
      half_angle_residual_1 = y - half_angle_product_1
          - ksl_product_error(half_angle, half_angle, half_angle_product_1) + y_lo,
      half_angle_lo = half_angle_residual_1 / (half_angle == 0.0 ? 1.0 : half_angle_twice_1),
      half_angle_padded_1 = 1.8051943758648296e-276 + y_size_1,
      half_angle_bound_1 = fabs(y_lo) + KSL_MUL(2.5021685128863245e-30, half_angle_padded_1),
      half_angle_size_4 = KSL_MUL(fabs(y)
          + KSL_MUL(140737488355328.0, half_angle_bound_1), half_angle_padded_1 / half_angle / y),
      half_angle_size_6 = fabs(half_angle_lo),
      half_angle_size_8 = KSL_MUL(2.567393169377981e+29, sqrt(half_angle_bound_1)
          + half_angle_size_6),
      half_angle_size_12 = half_angle
          + (KSL_MUL(4.0, half_angle_bound_1) < y ? half_angle_size_4 : half_angle_size_8);
  double c; const double fine_sine = ksl_sincos(half_angle, &c);
  double c_own_error_1; const double fine_sine_own_error_1 = ksl_sincos_error(half_angle, fine_sine,
      c, &c_own_error_1);
  const double fine_sine_half_1 = KSL_MUL(half_angle_lo, 0.5);
  double fine_sine_half_cos_1; const double fine_sine_half_sin_1 = ksl_sincos(fine_sine_half_1,
      &fine_sine_half_cos_1);
  const double fine_sine_twice_1 = fine_sine_half_sin_1 + fine_sine_half_sin_1,
      fine_sine_padded_1 = 1.8051943758648296e-276 + half_angle_size_12,
      fine_sine_size_1 = 1.0 + fine_sine_padded_1;
  const double c_lo = c_own_error_1
          - KSL_MUL(KSL_MUL(fine_sine_half_cos_1, fine_sine)
          + KSL_MUL(fine_sine_half_sin_1, c), fine_sine_twice_1);
  const double sinc_divisor = half_angle < 1.4901161193847656e-08 ? 1.4901161193847656e-08
          : half_angle, sinc_divisor_lo = half_angle < 1.4901161193847656e-08 ? 0.0 : half_angle_lo,
      sinc_divisor_bound_1 = half_angle_size_6 + KSL_MUL(4.240128211918887e-30, fine_sine_padded_1),
      sinc_divisor_size_3 = fabs(half_angle - 1.4901161193847656e-08),
      sinc_divisor_size_7 = sinc_divisor_bound_1 + fabs(1.4901161193847656e-08 - half_angle),
      sinc_divisor_size_9 = KSL_MUL(9.054644677292507e+28, sinc_divisor_bound_1
          < sinc_divisor_size_3 ? 0.0 : sinc_divisor_size_7);
  const double sinc_quotient = fine_sine / sinc_divisor,
      sinc_quotient_product_1 = KSL_MUL(sinc_quotient, sinc_divisor);
  const double fine_sine_lo = fine_sine_own_error_1
          + KSL_MUL(KSL_MUL(fine_sine_half_cos_1, c)
          - KSL_MUL(fine_sine_half_sin_1, fine_sine), fine_sine_twice_1);
  const double sinc_quotient_exact_1 = fine_sine - sinc_quotient_product_1
          - ksl_product_error(sinc_quotient, sinc_divisor, sinc_quotient_product_1),
      sinc_quotient_lo = (sinc_quotient_exact_1 + fine_sine_lo
          - KSL_MUL(sinc_quotient, sinc_divisor_lo)) / sinc_divisor;
  const double sinc_divisor_size_10 = (half_angle < 1.4901161193847656e-08 ? 1.4901161193847656e-08
          : half_angle_size_12) + sinc_divisor_size_9;
  const double sinc_quotient_padded_2 = 1.8051943758648296e-276 + sinc_divisor_size_10,
      sinc_quotient_size_1 = fabs(sinc_quotient), sinc_quotient_size_2 = fabs(sinc_divisor),
      sinc_quotient_bound_1 = fabs(sinc_divisor_lo)
          + KSL_MUL(1.1389183198259759e-29, sinc_quotient_padded_2),
      sinc_quotient_size_4 = 1.8051943758648296e-276 + fine_sine_size_1
          + KSL_MUL(sinc_quotient_padded_2, sinc_quotient_size_1),
      sinc_quotient_size_8 = sinc_quotient_size_4
          / (KSL_MUL(4.0, sinc_quotient_bound_1) < sinc_quotient_size_2 ? sinc_quotient_size_2
          : 0.0),
      sinc_quotient_size_10 = KSL_MUL(sinc_quotient_size_2
          + KSL_MUL(140737488355328.0, sinc_quotient_bound_1), sinc_quotient_size_8)
          / sinc_quotient_size_2,
      sinc_quotient_size_11 = sinc_quotient_size_1 + sinc_quotient_size_10;
  const double sinc_a = KSL_MUL(0.16666666666666666, y), sinc_b = 1.0 - sinc_a,
      sinc_b_right_1 = 1.0 - sinc_b,
      sinc_b_lo1_1 = 1.0 - (sinc_b + sinc_b_right_1)
          - ksl_product_rest(0.16666666666666666, y, sinc_a, sinc_b_right_1),
      sinc_b_lo = sinc_b_lo1_1
          - (KSL_MUL(9.25185853854297e-18, y) + KSL_MUL(0.16666666666666666, y_lo)),
      sinc_b_size_1 = 1.0 + KSL_MUL(2290649224.7000003, y_size_1),
      sinc = half_angle < 1.4901161193847656e-08 ? sinc_b : sinc_quotient,
      sinc_lo = half_angle < 1.4901161193847656e-08 ? sinc_b_lo : sinc_quotient_lo,
      sinc_size_4 = fabs(sinc_b_lo)
          + KSL_MUL(8.120831909935717e-28, 1.8051943758648296e-276 + sinc_b_size_1)
          + fabs(sinc_b - sinc_quotient),
      sinc_size_5 = fabs(sinc_quotient_lo)
          + KSL_MUL(1.8842277118313698e-29, 1.8051943758648296e-276 + sinc_quotient_size_11)
          + sinc_size_4,
      sinc_size_7 = KSL_MUL(1.2325982855554354e+27, sinc_divisor_bound_1 < sinc_divisor_size_3
          ? 0.0 : sinc_size_5);
  const double fine_g1 = KSL_MUL(c, sinc),
      fine_g1_cross_1 = KSL_MUL(c_lo, sinc) + KSL_MUL(c, sinc_lo),
      fine_g1_padded_1 = 1.8051943758648296e-276
          + ((half_angle < 1.4901161193847656e-08 ? sinc_b_size_1 : sinc_quotient_size_11)
          + sinc_size_7),
      fine_g1_reach_2 = fabs(sinc)
          + KSL_MUL(140737488355328.0, fabs(sinc_lo)
          + KSL_MUL(8.120832873841084e-28, fine_g1_padded_1)),
      fine_g1_size_2 = KSL_MUL(fine_g1_padded_1, fabs(c)
          + KSL_MUL(140737488355328.0, fabs(c_lo)
          + KSL_MUL(8.677471603123253e-30, fine_sine_size_1))),
      fine_g1_size_5 = fine_g1_size_2 + KSL_MUL(fine_g1_reach_2, fine_sine_size_1);
  const double fine_g2a = KSL_MUL(sinc, sinc),
      fine_g2a_size_1 = KSL_MUL(fine_g1_padded_1, fine_g1_reach_2),
      fine_g2 = KSL_MUL(0.5, fine_g2a),
      fine_g2_cross2_1 = KSL_MUL(0.5, ksl_product_error(sinc, sinc, fine_g2a)
          + (KSL_MUL(sinc_lo, sinc) + KSL_MUL(sinc, sinc_lo)));
  const double fine_rest3 = 1.0 - fine_g1, fine_rest3_right_1 = 1.0 - fine_rest3;
  const double fine_x = KSL_MUL(4.0, y), fine_x_cross2_1 = KSL_MUL(4.0, y_lo),
      fine_x_size_1 = KSL_MUL(4.0, y_size_1);
  const double fine_far_x = fine_x < 1.0 ? 1.0 : fine_x,
      fine_far_x_lo = fine_x < 1.0 ? 0.0 : fine_x_cross2_1,
      fine_far_x_padded_1 = 1.8051943758648296e-276 + fine_x_size_1,
      fine_far_x_bound_1 = fabs(fine_x_cross2_1)
          + KSL_MUL(2.8103175390871538e-30, fine_far_x_padded_1),
      fine_far_x_size_3 = fabs(fine_x - 1.0),
      fine_far_x_size_7 = fine_far_x_bound_1 + fabs(1.0 - fine_x),
      fine_far_x_size_9 = KSL_MUL(5.28187582188787e+28, fine_far_x_bound_1 < fine_far_x_size_3
          ? 0.0 : fine_far_x_size_7);
  const double fine_closed3 = fine_rest3 / fine_far_x,
      fine_closed3_product_1 = KSL_MUL(fine_closed3, fine_far_x);
  const double fine_rest3_lo = 1.0 - (fine_rest3 + fine_rest3_right_1)
          - ksl_product_rest(c, sinc, fine_g1, fine_rest3_right_1) - fine_g1_cross_1;
  const double fine_closed3_numerator_1 = fine_rest3 - fine_closed3_product_1
          - ksl_product_error(fine_closed3, fine_far_x, fine_closed3_product_1) + fine_rest3_lo,
      fine_closed3_lo = (fine_closed3_numerator_1 - KSL_MUL(fine_closed3, fine_far_x_lo))
          / fine_far_x,
      fine_closed3_padded_2 = 1.8051943758648296e-276
          + ((fine_x < 1.0 ? 1.0 : fine_x_size_1) + fine_far_x_size_9),
      fine_closed3_size_1 = fabs(fine_closed3), fine_closed3_size_2 = fabs(fine_far_x),
      fine_closed3_bound_1 = fabs(fine_far_x_lo)
          + KSL_MUL(1.9524315162482833e-29, fine_closed3_padded_2),
      fine_closed3_size_4 = 1.8051943758648296e-276 + (1.0 + fine_g1_size_5)
          + KSL_MUL(fine_closed3_padded_2, fine_closed3_size_1),
      fine_closed3_size_8 = fine_closed3_size_4
          / (KSL_MUL(4.0, fine_closed3_bound_1) < fine_closed3_size_2 ? fine_closed3_size_2 : 0.0),
      fine_closed3_size_10 = KSL_MUL(fine_closed3_size_2
          + KSL_MUL(140737488355328.0, fine_closed3_bound_1), fine_closed3_size_8)
          / fine_closed3_size_2, fine_closed3_size_11 = fine_closed3_size_1 + fine_closed3_size_10;
  const double series5a = KSL_MUL(1.216125041553518e-34, fine_x),
      series5b = 1.1309962886447716e-31 - series5a,
      series5b_right_1 = 1.1309962886447716e-31 - series5b,
      series5b_lo1_1 = 1.1309962886447716e-31 - (series5b + series5b_right_1)
          - ksl_product_rest(1.216125041553518e-34, fine_x, series5a, series5b_right_1),
      series5b_lo = series5b_lo1_1
          - (KSL_MUL(5.586290567888806e-51, fine_x)
          + KSL_MUL(1.216125041553518e-34, fine_x_cross2_1)) + 1.0498015412959506e-47,
      series5c = KSL_MUL(fine_x, series5b),
      series5c_padded_1 = 1.8051943758648296e-276
          + (1.1309962886447716e-31 + KSL_MUL(5.702613188320821e-10, fine_x_size_1)),
      series5c_reach_1 = fabs(fine_x) + KSL_MUL(140737488355328.0, fine_far_x_bound_1),
      series5c_reach_2 = fabs(series5b)
          + KSL_MUL(140737488355328.0, fabs(series5b_lo)
          + KSL_MUL(8.12514599395154e-28, series5c_padded_1)),
      series5d = series5c - 9.183689863795546e-29, series5d_right_1 = series5c - series5d,
      series5d_lo1_1 = ksl_product_rest(fine_x, series5b, series5c, series5d + series5d_right_1)
          - (9.183689863795546e-29 - series5d_right_1),
      series5d_lo = series5d_lo1_1 - 1.4303150396787322e-45
          + (KSL_MUL(fine_x_cross2_1, series5b) + KSL_MUL(fine_x, series5b_lo)),
      series5e = KSL_MUL(fine_x, series5d),
      series5d_size_1 = 9.183689863795546e-29
          + (KSL_MUL(series5c_padded_1, series5c_reach_1)
          + KSL_MUL(fine_far_x_padded_1, series5c_reach_2)),
      series5e_padded_1 = 1.8051943758648296e-276 + series5d_size_1,
      series5e_reach_1 = fabs(series5d)
          + KSL_MUL(140737488355328.0, fabs(series5d_lo)
          + KSL_MUL(8.19207783918962e-28, series5e_padded_1)),
      series5f = series5e + 6.446950284384474e-26, series5f_right_1 = series5f - series5e,
      series5f_lo1_1 = ksl_product_rest(fine_x, series5d, series5e, series5f - series5f_right_1)
          + (6.446950284384474e-26 - series5f_right_1),
      series5f_lo = series5f_lo1_1 + -1.9330404233703465e-42
          + (KSL_MUL(fine_x_cross2_1, series5d) + KSL_MUL(fine_x, series5d_lo)),
      series5g = KSL_MUL(fine_x, series5f),
      series5f_size_1 = 6.446950284384474e-26
          + (KSL_MUL(series5c_reach_1, series5e_padded_1)
          + KSL_MUL(fine_far_x_padded_1, series5e_reach_1)),
      series5g_padded_1 = 1.8051943758648296e-276 + series5f_size_1,
      series5g_reach_1 = fabs(series5f)
          + KSL_MUL(140737488355328.0, fabs(series5f_lo)
          + KSL_MUL(8.261228355723635e-28, series5g_padded_1)),
      series5h = series5g - 3.868170170630684e-23, series5h_right_1 = series5g - series5h,
      series5h_lo1_1 = ksl_product_rest(fine_x, series5f, series5g, series5h + series5h_right_1)
          - (3.868170170630684e-23 - series5h_right_1),
      series5h_lo = series5h_lo1_1 - -8.843177655482344e-40
          + (KSL_MUL(fine_x_cross2_1, series5f) + KSL_MUL(fine_x, series5f_lo)),
      series5i = KSL_MUL(fine_x, series5h),
      series5h_size_1 = 3.868170170630684e-23
          + (KSL_MUL(series5c_reach_1, series5g_padded_1)
          + KSL_MUL(fine_far_x_padded_1, series5g_reach_1)),
      series5i_padded_1 = 1.8051943758648296e-276 + series5h_size_1,
      series5i_reach_1 = fabs(series5h)
          + KSL_MUL(140737488355328.0, fabs(series5h_lo)
          + KSL_MUL(8.332597543553583e-28, series5i_padded_1)),
      series5j = series5i + 1.9572941063391263e-20, series5j_right_1 = series5j - series5i,
      series5j_lo1_1 = ksl_product_rest(fine_x, series5h, series5i, series5j - series5j_right_1)
          + (1.9572941063391263e-20 - series5j_right_1),
      series5j_lo = series5j_lo1_1 + -1.3643503830087908e-36
          + (KSL_MUL(fine_x_cross2_1, series5h) + KSL_MUL(fine_x, series5h_lo)),
      series5k = KSL_MUL(fine_x, series5j),
      series5j_size_1 = 1.9572941063391263e-20
          + (KSL_MUL(series5c_reach_1, series5i_padded_1)
          + KSL_MUL(fine_far_x_padded_1, series5i_reach_1)),
      series5k_padded_1 = 1.8051943758648296e-276 + series5j_size_1,
      series5k_reach_1 = fabs(series5j)
          + KSL_MUL(140737488355328.0, fabs(series5j_lo)
          + KSL_MUL(8.406185404560257e-28, series5k_padded_1)),
      series5l = series5k - 8.22063524662433e-18, series5l_right_1 = series5k - series5l,
      series5l_lo1_1 = ksl_product_rest(fine_x, series5j, series5k, series5l + series5l_right_1)
          - (8.22063524662433e-18 - series5l_right_1),
      series5l_lo = series5l_lo1_1 - 2.2141894119604265e-34
          + (KSL_MUL(fine_x_cross2_1, series5j) + KSL_MUL(fine_x, series5j_lo)),
      series5m = KSL_MUL(fine_x, series5l),
      series5l_size_1 = 8.22063524662433e-18
          + (KSL_MUL(series5c_reach_1, series5k_padded_1)
          + KSL_MUL(fine_far_x_padded_1, series5k_reach_1)),
      series5m_padded_1 = 1.8051943758648296e-276 + series5l_size_1,
      series5m_reach_1 = fabs(series5l)
          + KSL_MUL(140737488355328.0, fabs(series5l_lo)
          + KSL_MUL(8.481991936862865e-28, series5m_padded_1)),
      series5n = series5m + 2.8114572543455206e-15, series5n_right_1 = series5n - series5m,
      series5n_lo1_1 = ksl_product_rest(fine_x, series5l, series5m, series5n - series5n_right_1)
          + (2.8114572543455206e-15 - series5n_right_1),
      series5n_lo = series5n_lo1_1 + 1.6508842730861433e-31
          + (KSL_MUL(fine_x_cross2_1, series5l) + KSL_MUL(fine_x, series5l_lo)),
      series5o = KSL_MUL(fine_x, series5n),
      series5n_size_1 = 2.8114572543455206e-15
          + (KSL_MUL(series5c_reach_1, series5m_padded_1)
          + KSL_MUL(fine_far_x_padded_1, series5m_reach_1)),
      series5o_padded_1 = 1.8051943758648296e-276 + series5n_size_1,
      series5o_reach_1 = fabs(series5n)
          + KSL_MUL(140737488355328.0, fabs(series5n_lo)
          + KSL_MUL(8.560017140461409e-28, series5o_padded_1)),
      series5p = series5o - 7.647163731819816e-13, series5p_right_1 = series5o - series5p,
      series5p_lo1_1 = ksl_product_rest(fine_x, series5n, series5o, series5p + series5p_right_1)
          - (7.647163731819816e-13 - series5p_right_1),
      series5p_lo = series5p_lo1_1 - 7.03872877733453e-30
          + (KSL_MUL(fine_x_cross2_1, series5n) + KSL_MUL(fine_x, series5n_lo)),
      series5q = KSL_MUL(fine_x, series5p),
      series5p_size_1 = 7.647163731819816e-13
          + (KSL_MUL(series5c_reach_1, series5o_padded_1)
          + KSL_MUL(fine_far_x_padded_1, series5o_reach_1)),
      series5q_padded_1 = 1.8051943758648296e-276 + series5p_size_1,
      series5q_reach_1 = fabs(series5p)
          + KSL_MUL(140737488355328.0, fabs(series5p_lo)
          + KSL_MUL(8.640261015355885e-28, series5q_padded_1)),
      series5r = series5q + 1.6059043836821613e-10, series5r_right_1 = series5r - series5q,
      series5r_lo1_1 = ksl_product_rest(fine_x, series5p, series5q, series5r - series5r_right_1)
          + (1.6059043836821613e-10 - series5r_right_1),
      series5r_lo = series5r_lo1_1 + 1.2585294588752098e-26
          + (KSL_MUL(fine_x_cross2_1, series5p) + KSL_MUL(fine_x, series5p_lo)),
      series5s = KSL_MUL(fine_x, series5r),
      series5r_size_1 = 1.6059043836821613e-10
          + (KSL_MUL(series5c_reach_1, series5q_padded_1)
          + KSL_MUL(fine_far_x_padded_1, series5q_reach_1)),
      series5s_padded_1 = 1.8051943758648296e-276 + series5r_size_1,
      series5s_reach_1 = fabs(series5r)
          + KSL_MUL(140737488355328.0, fabs(series5r_lo)
          + KSL_MUL(8.722723561546295e-28, series5s_padded_1)),
      series5t = series5s - 2.505210838544172e-08, series5t_right_1 = series5s - series5t,
      series5t_lo1_1 = ksl_product_rest(fine_x, series5r, series5s, series5t + series5t_right_1)
          - (2.505210838544172e-08 - series5t_right_1),
      series5t_lo = series5t_lo1_1 - -1.448814070935912e-24
          + (KSL_MUL(fine_x_cross2_1, series5r) + KSL_MUL(fine_x, series5r_lo)),
      series5u = KSL_MUL(fine_x, series5t),
      series5t_size_1 = 2.505210838544172e-08
          + (KSL_MUL(series5c_reach_1, series5s_padded_1)
          + KSL_MUL(fine_far_x_padded_1, series5s_reach_1)),
      series5u_padded_1 = 1.8051943758648296e-276 + series5t_size_1,
      series5u_reach_1 = fabs(series5t)
          + KSL_MUL(140737488355328.0, fabs(series5t_lo)
          + KSL_MUL(8.80740477903264e-28, series5u_padded_1)),
      series5v = series5u + 2.7557319223985893e-06, series5v_right_1 = series5v - series5u,
      series5v_lo1_1 = ksl_product_rest(fine_x, series5t, series5u, series5v - series5v_right_1)
          + (2.7557319223985893e-06 - series5v_right_1),
      series5v_lo = series5v_lo1_1 + -1.858393274046472e-22
          + (KSL_MUL(fine_x_cross2_1, series5t) + KSL_MUL(fine_x, series5t_lo)),
      series5w = KSL_MUL(fine_x, series5v),
      series5v_size_1 = 2.7557319223985893e-06
          + (KSL_MUL(series5c_reach_1, series5u_padded_1)
          + KSL_MUL(fine_far_x_padded_1, series5u_reach_1)),
      series5w_padded_1 = 1.8051943758648296e-276 + series5v_size_1,
      series5w_reach_1 = fabs(series5v)
          + KSL_MUL(140737488355328.0, fabs(series5v_lo)
          + KSL_MUL(8.894304667814918e-28, series5w_padded_1)),
      series5x = series5w - 0.0001984126984126984, series5x_right_1 = series5w - series5x,
      series5x_lo1_1 = ksl_product_rest(fine_x, series5v, series5w, series5x + series5x_right_1)
          - (0.0001984126984126984 - series5x_right_1),
      series5x_lo = series5x_lo1_1 - 1.7209558293420705e-22
          + (KSL_MUL(fine_x_cross2_1, series5v) + KSL_MUL(fine_x, series5v_lo)),
      series5y = KSL_MUL(fine_x, series5x),
      series5x_size_1 = 0.0001984126984126984
          + (KSL_MUL(series5c_reach_1, series5w_padded_1)
          + KSL_MUL(fine_far_x_padded_1, series5w_reach_1)),
      series5y_padded_1 = 1.8051943758648296e-276 + series5x_size_1,
      series5y_reach_1 = fabs(series5x)
          + KSL_MUL(140737488355328.0, fabs(series5x_lo)
          + KSL_MUL(8.98342322789313e-28, series5y_padded_1)),
      series5 = series5y + 0.008333333333333333, series5_right_1 = series5 - series5y,
      series5_lo1_1 = ksl_product_rest(fine_x, series5x, series5y, series5 - series5_right_1)
          + (0.008333333333333333 - series5_right_1),
      series5_lo = series5_lo1_1 + 1.1564823173178714e-19
          + (KSL_MUL(fine_x_cross2_1, series5x) + KSL_MUL(fine_x, series5x_lo));
  const double fine_g3a = KSL_MUL(fine_x, series5);
  const double series5_size_1 = 0.008333333333333333
          + (KSL_MUL(series5c_reach_1, series5y_padded_1)
          + KSL_MUL(fine_far_x_padded_1, series5y_reach_1));
  const double fine_g3a_padded_1 = 1.8051943758648296e-276 + series5_size_1,
      fine_g3a_reach_1 = fabs(series5)
          + KSL_MUL(140737488355328.0, fabs(series5_lo)
          + KSL_MUL(9.07476046114807e-28, fine_g3a_padded_1)),
      fine_g3b = 0.16666666666666666 - fine_g3a, fine_g3b_right_1 = 0.16666666666666666 - fine_g3b,
      fine_g3b_lo1_1 = 0.16666666666666666 - (fine_g3b + fine_g3b_right_1)
          - ksl_product_rest(fine_x, series5, fine_g3a, fine_g3b_right_1),
      fine_g3b_lo = fine_g3b_lo1_1
          - (KSL_MUL(fine_x_cross2_1, series5) + KSL_MUL(fine_x, series5_lo))
          + 9.25185853854297e-18,
      fine_g3b_size_1 = 0.16666666666666666
          + (KSL_MUL(fine_g3a_padded_1, series5c_reach_1)
          + KSL_MUL(fine_far_x_padded_1, fine_g3a_reach_1)),
      fine_g3 = fine_x < 1.0 ? fine_g3b : fine_closed3,
      fine_g3_lo = fine_x < 1.0 ? fine_g3b_lo : fine_closed3_lo,
      fine_g3_size_4 = fabs(fine_g3b_lo)
          + KSL_MUL(9.168316367579732e-28, 1.8051943758648296e-276 + fine_g3b_size_1)
          + fabs(fine_g3b - fine_closed3),
      fine_g3_size_5 = fabs(fine_closed3_lo)
          + KSL_MUL(8.304820816109472e-28, 1.8051943758648296e-276 + fine_closed3_size_11)
          + fine_g3_size_4,
      fine_g3_size_7 = KSL_MUL(1.0948341329470242e+27, fine_far_x_bound_1 < fine_far_x_size_3 ? 0.0
          : fine_g3_size_5);
  const double fine_beta_v_0 = KSL_MUL(v->x, fine_g3),
      fine_beta_v_padded_1 = 1.8051943758648296e-276
          + ((fine_x < 1.0 ? fine_g3b_size_1 : fine_closed3_size_11) + fine_g3_size_7);
  const double fine_beta_v_1 = KSL_MUL(v->y, fine_g3);
  const double fine_beta_v_2 = KSL_MUL(v->z, fine_g3);
  const double fine_beta_v_lo_1 = ksl_product_error(v->x, fine_g3, fine_beta_v_0)
          + KSL_MUL(v->x, fine_g3_lo), fine_m_0 = KSL_MUL(v->x, fine_beta_v_0),
      fine_m_cross2_1 = KSL_MUL(v->x, fine_beta_v_lo_1),
      fine_m_padded_1 = 1.8051943758648296e-276 + KSL_MUL(fine_beta_v_padded_1, halved_size_1),
      fine_m_size_1 = KSL_MUL(fine_m_padded_1, halved_size_1);
  const double fine_beta_v_lo_2 = ksl_product_error(v->y, fine_g3, fine_beta_v_1)
          + KSL_MUL(v->y, fine_g3_lo), fine_m_1 = KSL_MUL(v->y, fine_beta_v_1),
      fine_m_cross2_2 = KSL_MUL(v->y, fine_beta_v_lo_2),
      fine_m_padded_2 = 1.8051943758648296e-276 + KSL_MUL(fine_beta_v_padded_1, halved_size_3),
      fine_m_size_2 = KSL_MUL(fine_m_padded_2, halved_size_3);
  const double fine_m_2 = KSL_MUL(v->z, fine_beta_v_2),
      fine_m_cross2_3 = KSL_MUL(v->z, ksl_product_error(v->z, fine_g3, fine_beta_v_2)
          + KSL_MUL(v->z, fine_g3_lo)),
      fine_m_size_3 = KSL_MUL(1.8051943758648296e-276
          + KSL_MUL(fine_beta_v_padded_1, halved_size_5), halved_size_5);
  const double fine_m_3 = KSL_MUL(v->y, fine_beta_v_0),
      fine_m_cross2_4 = KSL_MUL(v->y, fine_beta_v_lo_1);
  const double fine_m_4 = KSL_MUL(v->z, fine_beta_v_0),
      fine_m_cross2_5 = KSL_MUL(v->z, fine_beta_v_lo_1);
  const double fine_m_5 = KSL_MUL(v->z, fine_beta_v_1),
      fine_m_cross2_6 = KSL_MUL(v->z, fine_beta_v_lo_2);
  const double fine_others_0 = fine_m_1 + fine_m_2, fine_others_right_1 = fine_others_0 - fine_m_1,
      fine_others_left_rest_1 = ksl_product_rest(v->y, fine_beta_v_1, fine_m_1, fine_others_0
          - fine_others_right_1),
      fine_others_lo1_1 = fine_others_left_rest_1
          + ksl_product_rest(v->z, fine_beta_v_2, fine_m_2, fine_others_right_1),
      fine_others_lo_1 = fine_others_lo1_1 + (fine_m_cross2_2 + fine_m_cross2_3),
      fine_others_size_1 = fine_m_size_2 + fine_m_size_3;
  const double fine_others_1 = fine_m_0 + fine_m_2, fine_others_right_2 = fine_others_1 - fine_m_0,
      fine_others_left_rest_2 = ksl_product_rest(v->x, fine_beta_v_0, fine_m_0, fine_others_1
          - fine_others_right_2),
      fine_others_lo1_2 = fine_others_left_rest_2
          + ksl_product_rest(v->z, fine_beta_v_2, fine_m_2, fine_others_right_2),
      fine_others_lo_2 = fine_others_lo1_2 + (fine_m_cross2_1 + fine_m_cross2_3),
      fine_others_size_2 = fine_m_size_1 + fine_m_size_3;
  const double fine_others_2 = fine_m_0 + fine_m_1, fine_others_right_3 = fine_others_2 - fine_m_0,
      fine_others_left_rest_3 = ksl_product_rest(v->x, fine_beta_v_0, fine_m_0, fine_others_2
          - fine_others_right_3),
      fine_others_lo1_3 = fine_others_left_rest_3
          + ksl_product_rest(v->y, fine_beta_v_1, fine_m_1, fine_others_right_3),
      fine_others_lo_3 = fine_others_lo1_3 + (fine_m_cross2_1 + fine_m_cross2_2),
      fine_others_size_3 = fine_m_size_1 + fine_m_size_2;
  const double fine_diagonal0a = 1.0 - fine_others_0,
      fine_diagonal0a_right_1 = 1.0 - fine_diagonal0a,
      fine_diagonal0a_lo = 1.0 - (fine_diagonal0a + fine_diagonal0a_right_1)
          - (fine_others_0 - fine_diagonal0a_right_1) - fine_others_lo_1,
      fine_diagonal0a_size_1 = 1.0 + fine_others_size_1, fine_diagonal0b = fine_g1 + fine_m_0,
      fine_diagonal0b_right_1 = fine_diagonal0b - fine_g1,
      fine_diagonal0b_left_rest_1 = ksl_product_rest(c, sinc, fine_g1, fine_diagonal0b
          - fine_diagonal0b_right_1),
      fine_diagonal0b_lo1_1 = fine_diagonal0b_left_rest_1
          + ksl_product_rest(v->x, fine_beta_v_0, fine_m_0, fine_diagonal0b_right_1),
      fine_diagonal0b_lo = fine_diagonal0b_lo1_1 + (fine_g1_cross_1 + fine_m_cross2_1),
      fine_diagonal0b_size_1 = fine_g1_size_5 + fine_m_size_1,
      fine_diagonal0_error_1 = fabs(ksl_product_error(v->x, fine_beta_v_0, fine_m_0)
          + fine_m_cross2_1),
      fine_diagonal0_bound_2 = fabs(fine_others_lo_1)
          + KSL_MUL(9.232045404485834e-28, 1.8051943758648296e-276 + fine_others_size_1),
      fine_diagonal0_bound_3 = fabs(fine_diagonal0b_lo)
          + KSL_MUL(9.232045404485834e-28, 1.8051943758648296e-276 + fine_diagonal0b_size_1),
      fine_diagonal0_bound_4 = fabs(fine_diagonal0a_lo)
          + KSL_MUL(9.267791630980215e-28, 1.8051943758648296e-276 + fine_diagonal0a_size_1),
      fine_diagonal0_size_9 = fine_diagonal0_bound_4
          + (fine_diagonal0_bound_3 + fabs(fine_diagonal0b - fine_diagonal0a)),
      fine_diagonal0_size_2 = fine_diagonal0_error_1
          + KSL_MUL(9.197038735090097e-28, 1.8051943758648296e-276 + fine_m_size_1)
          + fine_diagonal0_bound_2,
      fine_diagonal0_size_11 = KSL_MUL(1.0835017304955739e+27, fine_diagonal0_size_2
          < fabs(fine_m_0 - fine_others_0) ? 0.0 : fine_diagonal0_size_9);
  const double fine_diagonal1a = 1.0 - fine_others_1,
      fine_diagonal1a_right_1 = 1.0 - fine_diagonal1a,
      fine_diagonal1a_lo = 1.0 - (fine_diagonal1a + fine_diagonal1a_right_1)
          - (fine_others_1 - fine_diagonal1a_right_1) - fine_others_lo_2,
      fine_diagonal1a_size_1 = 1.0 + fine_others_size_2, fine_diagonal1b = fine_g1 + fine_m_1,
      fine_diagonal1b_right_1 = fine_diagonal1b - fine_g1,
      fine_diagonal1b_left_rest_1 = ksl_product_rest(c, sinc, fine_g1, fine_diagonal1b
          - fine_diagonal1b_right_1),
      fine_diagonal1b_lo1_1 = fine_diagonal1b_left_rest_1
          + ksl_product_rest(v->y, fine_beta_v_1, fine_m_1, fine_diagonal1b_right_1),
      fine_diagonal1b_lo = fine_diagonal1b_lo1_1 + (fine_g1_cross_1 + fine_m_cross2_2),
      fine_diagonal1b_size_1 = fine_g1_size_5 + fine_m_size_2,
      fine_diagonal1_error_1 = fabs(ksl_product_error(v->y, fine_beta_v_1, fine_m_1)
          + fine_m_cross2_2),
      fine_diagonal1_bound_2 = fabs(fine_others_lo_2)
          + KSL_MUL(9.232045404485834e-28, 1.8051943758648296e-276 + fine_others_size_2),
      fine_diagonal1_bound_3 = fabs(fine_diagonal1b_lo)
          + KSL_MUL(9.232045404485834e-28, 1.8051943758648296e-276 + fine_diagonal1b_size_1),
      fine_diagonal1_bound_4 = fabs(fine_diagonal1a_lo)
          + KSL_MUL(9.267791630980215e-28, 1.8051943758648296e-276 + fine_diagonal1a_size_1),
      fine_diagonal1_size_9 = fine_diagonal1_bound_4
          + (fine_diagonal1_bound_3 + fabs(fine_diagonal1b - fine_diagonal1a)),
      fine_diagonal1_size_2 = fine_diagonal1_error_1
          + KSL_MUL(9.197038735090097e-28, 1.8051943758648296e-276 + fine_m_size_2)
          + fine_diagonal1_bound_2,
      fine_diagonal1_size_11 = KSL_MUL(1.0835017304955739e+27, fine_diagonal1_size_2
          < fabs(fine_m_1 - fine_others_1) ? 0.0 : fine_diagonal1_size_9);
  const double fine_diagonal2a = 1.0 - fine_others_2,
      fine_diagonal2a_right_1 = 1.0 - fine_diagonal2a,
      fine_diagonal2a_lo = 1.0 - (fine_diagonal2a + fine_diagonal2a_right_1)
          - (fine_others_2 - fine_diagonal2a_right_1) - fine_others_lo_3,
      fine_diagonal2a_size_1 = 1.0 + fine_others_size_3, fine_diagonal2b = fine_g1 + fine_m_2,
      fine_diagonal2b_right_1 = fine_diagonal2b - fine_g1,
      fine_diagonal2b_left_rest_1 = ksl_product_rest(c, sinc, fine_g1, fine_diagonal2b
          - fine_diagonal2b_right_1),
      fine_diagonal2b_lo1_1 = fine_diagonal2b_left_rest_1
          + ksl_product_rest(v->z, fine_beta_v_2, fine_m_2, fine_diagonal2b_right_1),
      fine_diagonal2b_lo = fine_diagonal2b_lo1_1 + (fine_g1_cross_1 + fine_m_cross2_3),
      fine_diagonal2b_size_1 = fine_g1_size_5 + fine_m_size_3,
      fine_diagonal2_error_1 = fabs(ksl_product_error(v->z, fine_beta_v_2, fine_m_2)
          + fine_m_cross2_3),
      fine_diagonal2_bound_2 = fabs(fine_others_lo_3)
          + KSL_MUL(9.232045404485834e-28, 1.8051943758648296e-276 + fine_others_size_3),
      fine_diagonal2_bound_3 = fabs(fine_diagonal2b_lo)
          + KSL_MUL(9.232045404485834e-28, 1.8051943758648296e-276 + fine_diagonal2b_size_1),
      fine_diagonal2_bound_4 = fabs(fine_diagonal2a_lo)
          + KSL_MUL(9.267791630980215e-28, 1.8051943758648296e-276 + fine_diagonal2a_size_1),
      fine_diagonal2_size_9 = fine_diagonal2_bound_4
          + (fine_diagonal2_bound_3 + fabs(fine_diagonal2b - fine_diagonal2a)),
      fine_diagonal2_size_2 = fine_diagonal2_error_1
          + KSL_MUL(9.197038735090097e-28, 1.8051943758648296e-276 + fine_m_size_3)
          + fine_diagonal2_bound_2,
      fine_diagonal2_size_11 = KSL_MUL(1.0835017304955739e+27, fine_diagonal2_size_2
          < fabs(fine_m_2 - fine_others_2) ? 0.0 : fine_diagonal2_size_9);
  const double fine_alpha_v_0a_padded_1 = 1.8051943758648296e-276
          + KSL_MUL(0.5, fine_g2a_size_1 + fine_g2a_size_1),
      fine_alpha_v_0 = -KSL_MUL(v->x, fine_g2),
      fine_alpha_v_cross_1 = -KSL_MUL(v->x, fine_g2_cross2_1), fine_alpha_v_factor_1 = -v->x;
  const double fine_alpha_v_1 = -KSL_MUL(v->y, fine_g2),
      fine_alpha_v_cross_2 = -KSL_MUL(v->y, fine_g2_cross2_1), fine_alpha_v_factor_2 = -v->y;
  const double fine_alpha_v_2 = -KSL_MUL(v->z, fine_g2),
      fine_alpha_v_cross_3 = -KSL_MUL(v->z, fine_g2_cross2_1), fine_alpha_v_factor_3 = -v->z;
  const double fine_R_01 = fine_m_3 - fine_alpha_v_2, fine_R_right_1 = fine_m_3 - fine_R_01,
      fine_R_right_rest_1 = ksl_product_rest(fine_alpha_v_factor_3, fine_g2, fine_alpha_v_2,
          fine_R_right_1),
      fine_R_lo1_1 = ksl_product_rest(v->y, fine_beta_v_0, fine_m_3, fine_R_01 + fine_R_right_1)
          - fine_R_right_rest_1;
  const double fine_R_02 = fine_m_4 + fine_alpha_v_1, fine_R_right_2 = fine_R_02 - fine_m_4,
      fine_R_right_rest_2 = ksl_product_rest(fine_alpha_v_factor_2, fine_g2, fine_alpha_v_1,
          fine_R_right_2),
      fine_R_lo1_2 = ksl_product_rest(v->z, fine_beta_v_0, fine_m_4, fine_R_02 - fine_R_right_2)
          + fine_R_right_rest_2;
  const double fine_R_10 = fine_m_3 + fine_alpha_v_2, fine_R_right_3 = fine_R_10 - fine_m_3,
      fine_R_right_rest_3 = ksl_product_rest(fine_alpha_v_factor_3, fine_g2, fine_alpha_v_2,
          fine_R_right_3),
      fine_R_lo1_3 = ksl_product_rest(v->y, fine_beta_v_0, fine_m_3, fine_R_10 - fine_R_right_3)
          + fine_R_right_rest_3;
  const double fine_R_12 = fine_m_5 - fine_alpha_v_0, fine_R_right_4 = fine_m_5 - fine_R_12,
      fine_R_right_rest_4 = ksl_product_rest(fine_alpha_v_factor_1, fine_g2, fine_alpha_v_0,
          fine_R_right_4),
      fine_R_lo1_4 = ksl_product_rest(v->z, fine_beta_v_1, fine_m_5, fine_R_12 + fine_R_right_4)
          - fine_R_right_rest_4;
  const double fine_R_20 = fine_m_4 - fine_alpha_v_1, fine_R_right_5 = fine_m_4 - fine_R_20,
      fine_R_right_rest_5 = ksl_product_rest(fine_alpha_v_factor_2, fine_g2, fine_alpha_v_1,
          fine_R_right_5),
      fine_R_lo1_5 = ksl_product_rest(v->z, fine_beta_v_0, fine_m_4, fine_R_20 + fine_R_right_5)
          - fine_R_right_rest_5;
  const double fine_R_21 = fine_m_5 + fine_alpha_v_0, fine_R_right_6 = fine_R_21 - fine_m_5,
      fine_R_right_rest_6 = ksl_product_rest(fine_alpha_v_factor_1, fine_g2, fine_alpha_v_0,
          fine_R_right_6),
      fine_R_lo1_6 = ksl_product_rest(v->z, fine_beta_v_1, fine_m_5, fine_R_21 - fine_R_right_6)
          + fine_R_right_rest_6;
  const double diagonal0_apart_1 = (fine_m_0 < fine_others_0 ? fine_diagonal0b : fine_diagonal0a)
          - diagonal0,
      diagonal0_padded_1 = 1.8051943758648296e-276
          + ((fine_m_0 < fine_others_0 ? fine_diagonal0b_size_1 : fine_diagonal0a_size_1)
          + fine_diagonal0_size_11),
      diagonal0_error_2 = KSL_MUL(1.0000000000000009, fabs(diagonal0_apart_1
          + (fine_m_0 < fine_others_0 ? fine_diagonal0b_lo : fine_diagonal0a_lo))),
      R_padded_1 = 1.8051943758648296e-276
          + (KSL_MUL(fine_alpha_v_0a_padded_1, halved_size_5)
          + KSL_MUL(fine_m_padded_1, halved_size_3)),
      R_rest_1 = KSL_MUL(9.232045404485834e-28, R_padded_1),
      R_padded_2 = 1.8051943758648296e-276
          + (KSL_MUL(fine_alpha_v_0a_padded_1, halved_size_3)
          + KSL_MUL(fine_m_padded_1, halved_size_5)),
      R_rest_2 = KSL_MUL(9.232045404485834e-28, R_padded_2),
      diagonal1_apart_1 = (fine_m_1 < fine_others_1 ? fine_diagonal1b : fine_diagonal1a)
          - diagonal1,
      diagonal1_padded_1 = 1.8051943758648296e-276
          + ((fine_m_1 < fine_others_1 ? fine_diagonal1b_size_1 : fine_diagonal1a_size_1)
          + fine_diagonal1_size_11),
      diagonal1_error_2 = KSL_MUL(1.0000000000000009, fabs(diagonal1_apart_1
          + (fine_m_1 < fine_others_1 ? fine_diagonal1b_lo : fine_diagonal1a_lo))),
      R_padded_3 = 1.8051943758648296e-276
          + (KSL_MUL(fine_alpha_v_0a_padded_1, halved_size_1)
          + KSL_MUL(fine_m_padded_2, halved_size_5)),
      R_rest_3 = KSL_MUL(9.232045404485834e-28, R_padded_3),
      diagonal2_apart_1 = (fine_m_2 < fine_others_2 ? fine_diagonal2b : fine_diagonal2a)
          - diagonal2,
      diagonal2_padded_1 = 1.8051943758648296e-276
          + ((fine_m_2 < fine_others_2 ? fine_diagonal2b_size_1 : fine_diagonal2a_size_1)
          + fine_diagonal2_size_11),
      diagonal2_error_2 = KSL_MUL(1.0000000000000009, fabs(diagonal2_apart_1
          + (fine_m_2 < fine_others_2 ? fine_diagonal2b_lo : fine_diagonal2a_lo))),
      diagonal0_bound_1 = diagonal0_error_2 + KSL_MUL(9.267792597706769e-28, diagonal0_padded_1),
      R_bound_1 = KSL_MUL(1.0000000000000009, fabs(fine_R_01 - R_01
          + (fine_R_lo1_1 + (fine_m_cross2_4 - fine_alpha_v_cross_3)))) + R_rest_1,
      R_bound_2 = KSL_MUL(1.0000000000000009, fabs(fine_R_02 - R_02
          + (fine_R_lo1_2 + (fine_m_cross2_5 + fine_alpha_v_cross_2)))) + R_rest_2,
      R_bound_3 = KSL_MUL(1.0000000000000009, fabs(fine_R_10 - R_10
          + (fine_R_lo1_3 + (fine_m_cross2_4 + fine_alpha_v_cross_3)))) + R_rest_1,
      diagonal1_bound_1 = diagonal1_error_2 + KSL_MUL(9.267792597706769e-28, diagonal1_padded_1),
      R_bound_4 = KSL_MUL(1.0000000000000009, fabs(fine_R_12 - R_12
          + (fine_R_lo1_4 + (fine_m_cross2_6 - fine_alpha_v_cross_1)))) + R_rest_3,
      R_bound_5 = KSL_MUL(1.0000000000000009, fabs(fine_R_20 - R_20
          + (fine_R_lo1_5 + (fine_m_cross2_5 - fine_alpha_v_cross_2)))) + R_rest_2,
      R_bound_6 = KSL_MUL(1.0000000000000009, fabs(fine_R_21 - R_21
          + (fine_R_lo1_6 + (fine_m_cross2_6 + fine_alpha_v_cross_1)))) + R_rest_3,
      diagonal2_bound_1 = diagonal2_error_2 + KSL_MUL(9.267792597706769e-28, diagonal2_padded_1);
  R->m00 = diagonal0;
  R->m01 = R_01;
  R->m02 = R_02;
  R->m10 = R_10;
  R->m11 = diagonal1;
  R->m12 = R_12;
  R->m20 = R_20;
  R->m21 = R_21;
  R->m22 = diagonal2;
  R_bound->m00 = diagonal0_bound_1;
  R_bound->m01 = R_bound_1;
  R_bound->m02 = R_bound_2;
  R_bound->m10 = R_bound_3;
  R_bound->m11 = diagonal1_bound_1;
  R_bound->m12 = R_bound_4;
  R_bound->m20 = R_bound_5;
  R_bound->m21 = R_bound_6;
  R_bound->m22 = diagonal2_bound_1;
}

/* R = J_l(v)^-1 = I - v~/2 + (1 - θ/2 cot θ/2)/θ^2 v~^2, θ = |v|; singular at multiples of 2π
     except 0; |error of R| <= R_bound unless inf or NaN.
   v: vector; R, R_bound: rotation or other 3×3 matrix.
   420 mul, 746 add, 23 product error, 34 product rest, 23 div, 3 sqrt, 6 neg, 93 abs, 23 less, 1
     equal, 47 select. */
static inline void ksl_SO3_leftJacobianInverse_certified(const ksl_vec3_t *v, ksl_mat3x3_t *R,
    ksl_mat3x3_t *R_bound) {
  const double size_0 = fabs(v->x), size_1 = fabs(v->y), size_2 = fabs(v->z);
  const double sizes = size_0 + size_1 + size_2;
  const double grid = KSL_MUL(sizes, 268435456.0);
  const double shifted_0 = v->x + grid, shifted_1 = v->y + grid, shifted_2 = v->z + grid;
  const double high_0 = shifted_0 - grid, high_1 = shifted_1 - grid, high_2 = shifted_2 - grid;
  const double low_0 = v->x - high_0, low_1 = v->y - high_1, low_2 = v->z - high_2;
  const double sum_0 = v->x + high_0, sum_1 = v->y + high_1, sum_2 = v->z + high_2;
  const double squares = KSL_MUL(high_0, high_0) + KSL_MUL(high_1, high_1)
          + KSL_MUL(high_2, high_2);
  const double cross = KSL_MUL(low_0, sum_0) + KSL_MUL(low_1, sum_1) + KSL_MUL(low_2, sum_2);
  const double x = squares + cross;
  const double theta_a = sqrt(x), theta = x < 1.0 ? 1.0 : theta_a;
  const double theta_shifted = grid + theta;
  const double theta_high = theta_shifted - grid;
  const double theta_low = theta - theta_high;
  const double theta_sum = theta + theta_high;
  const double cross_rest = cross - KSL_MUL(theta_low, theta_sum);
  const double exact = squares - KSL_MUL(theta_high, theta_high);
  const double residual = cross_rest + exact;
  const double small = KSL_MUL(0.5, residual) / theta;
  const double delta = fabs(small) < 0.0078125 ? small : 0.0;
  double far_cosine_a; const double far_sine_a = ksl_sincos(theta, &far_cosine_a);
  const double far_sine = x < 1.0 ? 1.0 : far_sine_a;
  const double far_cosine = x < 1.0 ? 0.0 : far_cosine_a;
  const double sine = KSL_MUL(delta, far_cosine) + far_sine;
  const double cosine = far_cosine - KSL_MUL(delta, far_sine);
  const double above_a = cosine + 1.0, above = cosine < 0.0 ? sine : above_a;
  const double below_a = 1.0 - cosine, below = cosine < 0.0 ? below_a : sine;
  const double cotangent = above / below;
  const double half_cotangent = KSL_MUL(KSL_MUL(0.5, theta), cotangent);
  const double b_rest = 1.0 - half_cotangent;
  const double b_divisor = x < 4.0 ? 4.0 : x;
  const double closed_b = b_rest / b_divisor;
  const double b_g = KSL_MUL(x, KSL_MUL(x, KSL_MUL(x, KSL_MUL(1.455172475614865e-27, x)
          + 5.744790668872202e-26) + 2.267952452337683e-24) + 8.953517427037546e-23),
      b_n = KSL_MUL(x, KSL_MUL(x, KSL_MUL(x, b_g + 3.534707039629467e-21) + 1.3954464685812522e-19)
          + 5.5090028283602295e-18) + 2.174868698558062e-16,
      b_u = KSL_MUL(x, KSL_MUL(x, KSL_MUL(x, KSL_MUL(x, b_n) + 8.586062056277845e-15)
          + 3.3896802963225827e-13) + 1.3382536530684679e-11),
      b_ab = KSL_MUL(x, KSL_MUL(x, KSL_MUL(x, b_u + 5.284190138687493e-10) + 2.08767569878681e-08)
          + 8.267195767195768e-07) + 3.306878306878307e-05,
      b_af = KSL_MUL(x, KSL_MUL(x, b_ab) + 0.001388888888888889) + 0.08333333333333333,
      b = x < 4.0 ? b_af : closed_b;
  const double b_across_b = 1.0 - KSL_MUL(x, b), b_across = x < 4.0 ? b_across_b : half_cotangent;
  const double beta_v_0 = KSL_MUL(v->x, b);
  const double beta_v_1 = KSL_MUL(v->y, b);
  const double beta_v_2 = KSL_MUL(v->z, b);
  const double m_0 = KSL_MUL(v->x, beta_v_0);
  const double m_1 = KSL_MUL(v->y, beta_v_1);
  const double m_2 = KSL_MUL(v->z, beta_v_2);
  const double m_3 = KSL_MUL(v->y, beta_v_0);
  const double m_4 = KSL_MUL(v->z, beta_v_0);
  const double m_5 = KSL_MUL(v->z, beta_v_1);
  const double others_0 = m_1 + m_2;
  const double others_1 = m_0 + m_2;
  const double others_2 = m_0 + m_1;
  const double diagonal0a = 1.0 - others_0, diagonal0b = b_across + m_0,
      diagonal0 = m_0 < others_0 ? diagonal0b : diagonal0a;
  const double diagonal1a = 1.0 - others_1, diagonal1b = b_across + m_1,
      diagonal1 = m_1 < others_1 ? diagonal1b : diagonal1a;
  const double diagonal2a = 1.0 - others_2, diagonal2b = b_across + m_2,
      diagonal2 = m_2 < others_2 ? diagonal2b : diagonal2a;
  const double alpha_v_0 = -KSL_MUL(0.5, v->x);
  const double alpha_v_1 = -KSL_MUL(0.5, v->y);
  const double alpha_v_2 = -KSL_MUL(0.5, v->z);
  const double R_01 = m_3 - alpha_v_2;
  const double R_02 = m_4 + alpha_v_1;
  const double R_10 = m_3 + alpha_v_2;
  const double R_12 = m_5 - alpha_v_0;
  const double R_20 = m_4 - alpha_v_1;
  const double R_21 = m_5 + alpha_v_0;
  const double halved_0 = KSL_MUL(0.5, v->x), halved_size_1 = fabs(v->x),
      halved_size_2 = KSL_MUL(0.5, halved_size_1);
  const double halved_1 = KSL_MUL(0.5, v->y), halved_size_3 = fabs(v->y),
      halved_size_4 = KSL_MUL(0.5, halved_size_3);
  const double halved_2 = KSL_MUL(0.5, v->z), halved_size_5 = fabs(v->z),
      halved_size_6 = KSL_MUL(0.5, halved_size_5);
  const double y_a = KSL_MUL(halved_0, halved_0),
      y_a_padded_1 = 1.8051943758648296e-276 + halved_size_2, y_b = KSL_MUL(halved_1, halved_1),
      y_b_padded_1 = 1.8051943758648296e-276 + halved_size_4, y_c = y_a + y_b,
      y_c_right_1 = y_c - y_a, y_d = KSL_MUL(halved_2, halved_2),
      y_d_padded_1 = 1.8051943758648296e-276 + halved_size_6, y = y_c + y_d, y_right_1 = y - y_c,
      y_c_lo = ksl_product_rest(halved_0, halved_0, y_a, y_c - y_c_right_1)
          + ksl_product_rest(halved_1, halved_1, y_b, y_c_right_1),
      y_lo = y_c - (y - y_right_1) + ksl_product_rest(halved_2, halved_2, y_d, y_right_1) + y_c_lo,
      y_size_1 = KSL_MUL(y_a_padded_1, y_a_padded_1) + KSL_MUL(y_b_padded_1, y_b_padded_1)
          + KSL_MUL(y_d_padded_1, y_d_padded_1);
  const double half_angle = sqrt(y), half_angle_product_1 = KSL_MUL(half_angle, half_angle),
      half_angle_twice_1 = half_angle + half_angle,
      half_angle_residual_1 = y - half_angle_product_1
          - ksl_product_error(half_angle, half_angle, half_angle_product_1) + y_lo,
      half_angle_lo = half_angle_residual_1 / (half_angle == 0.0 ? 1.0 : half_angle_twice_1),
      half_angle_padded_1 = 1.8051943758648296e-276 + y_size_1,
      half_angle_bound_1 = fabs(y_lo) + KSL_MUL(2.5021685128863245e-30, half_angle_padded_1),
      half_angle_reach_1 = fabs(y) + KSL_MUL(140737488355328.0, half_angle_bound_1),
      half_angle_size_4 = KSL_MUL(half_angle_reach_1, half_angle_padded_1 / half_angle / y),
      half_angle_size_6 = fabs(half_angle_lo),
      half_angle_size_8 = KSL_MUL(2.567393169377981e+29, sqrt(half_angle_bound_1)
          + half_angle_size_6),
      half_angle_size_12 = half_angle
          + (KSL_MUL(4.0, half_angle_bound_1) < y ? half_angle_size_4 : half_angle_size_8);
  double c; const double fine_sine = ksl_sincos(half_angle, &c);
  double c_own_error_1; const double fine_sine_own_error_1 = ksl_sincos_error(half_angle, fine_sine,
      c, &c_own_error_1);
  const double fine_sine_half_1 = KSL_MUL(half_angle_lo, 0.5);
  double fine_sine_half_cos_1; const double fine_sine_half_sin_1 = ksl_sincos(fine_sine_half_1,
      &fine_sine_half_cos_1);
  const double fine_sine_twice_1 = fine_sine_half_sin_1 + fine_sine_half_sin_1,
      fine_sine_padded_1 = 1.8051943758648296e-276 + half_angle_size_12,
      fine_sine_size_1 = 1.0 + fine_sine_padded_1;
  const double c_lo = c_own_error_1
          - KSL_MUL(KSL_MUL(fine_sine_half_cos_1, fine_sine)
          + KSL_MUL(fine_sine_half_sin_1, c), fine_sine_twice_1);
  const double sinc_divisor = half_angle < 1.4901161193847656e-08 ? 1.4901161193847656e-08
          : half_angle, sinc_divisor_lo = half_angle < 1.4901161193847656e-08 ? 0.0 : half_angle_lo,
      sinc_divisor_bound_1 = half_angle_size_6 + KSL_MUL(4.240128211918887e-30, fine_sine_padded_1),
      sinc_divisor_size_3 = fabs(half_angle - 1.4901161193847656e-08),
      sinc_divisor_size_7 = sinc_divisor_bound_1 + fabs(1.4901161193847656e-08 - half_angle),
      sinc_divisor_size_9 = KSL_MUL(9.054644677292507e+28, sinc_divisor_bound_1
          < sinc_divisor_size_3 ? 0.0 : sinc_divisor_size_7);
  const double sinc_quotient = fine_sine / sinc_divisor,
      sinc_quotient_product_1 = KSL_MUL(sinc_quotient, sinc_divisor);
  const double fine_sine_lo = fine_sine_own_error_1
          + KSL_MUL(KSL_MUL(fine_sine_half_cos_1, c)
          - KSL_MUL(fine_sine_half_sin_1, fine_sine), fine_sine_twice_1);
  const double sinc_quotient_exact_1 = fine_sine - sinc_quotient_product_1
          - ksl_product_error(sinc_quotient, sinc_divisor, sinc_quotient_product_1),
      sinc_quotient_lo = (sinc_quotient_exact_1 + fine_sine_lo
          - KSL_MUL(sinc_quotient, sinc_divisor_lo)) / sinc_divisor,
      sinc_quotient_padded_1 = 1.8051943758648296e-276 + fine_sine_size_1;
  const double sinc_divisor_size_10 = (half_angle < 1.4901161193847656e-08 ? 1.4901161193847656e-08
          : half_angle_size_12) + sinc_divisor_size_9;
  const double sinc_quotient_padded_2 = 1.8051943758648296e-276 + sinc_divisor_size_10,
      sinc_quotient_size_1 = fabs(sinc_quotient), sinc_quotient_size_2 = fabs(sinc_divisor),
      sinc_quotient_bound_1 = fabs(sinc_divisor_lo)
          + KSL_MUL(1.1389183198259759e-29, sinc_quotient_padded_2),
      sinc_quotient_size_7 = KSL_MUL(4.0, sinc_quotient_bound_1) < sinc_quotient_size_2
          ? sinc_quotient_size_2 : 0.0,
      sinc_quotient_size_8 = (sinc_quotient_padded_1
          + KSL_MUL(sinc_quotient_padded_2, sinc_quotient_size_1)) / sinc_quotient_size_7,
      sinc_quotient_size_10 = KSL_MUL(sinc_quotient_size_2
          + KSL_MUL(140737488355328.0, sinc_quotient_bound_1), sinc_quotient_size_8)
          / sinc_quotient_size_2,
      sinc_quotient_size_11 = sinc_quotient_size_1 + sinc_quotient_size_10;
  const double sinc_a = KSL_MUL(0.16666666666666666, y), sinc_b = 1.0 - sinc_a,
      sinc_b_right_1 = 1.0 - sinc_b,
      sinc_b_lo1_1 = 1.0 - (sinc_b + sinc_b_right_1)
          - ksl_product_rest(0.16666666666666666, y, sinc_a, sinc_b_right_1),
      sinc_b_lo = sinc_b_lo1_1
          - (KSL_MUL(9.25185853854297e-18, y) + KSL_MUL(0.16666666666666666, y_lo)),
      sinc_b_size_1 = 1.0 + KSL_MUL(2290649224.7000003, y_size_1),
      sinc = half_angle < 1.4901161193847656e-08 ? sinc_b : sinc_quotient,
      sinc_lo = half_angle < 1.4901161193847656e-08 ? sinc_b_lo : sinc_quotient_lo,
      sinc_size_4 = fabs(sinc_b_lo)
          + KSL_MUL(8.120831909935717e-28, 1.8051943758648296e-276 + sinc_b_size_1)
          + fabs(sinc_b - sinc_quotient),
      sinc_size_5 = fabs(sinc_quotient_lo)
          + KSL_MUL(1.8842277118313698e-29, 1.8051943758648296e-276 + sinc_quotient_size_11)
          + sinc_size_4,
      sinc_size_7 = KSL_MUL(1.2325982855554354e+27, sinc_divisor_bound_1 < sinc_divisor_size_3
          ? 0.0 : sinc_size_5),
      sinc_size_8 = (half_angle < 1.4901161193847656e-08 ? sinc_b_size_1 : sinc_quotient_size_11)
          + sinc_size_7;
  const double series_phi_a = KSL_MUL(5.107725174524775e-32, y),
      series_phi_b = 4.116826490666969e-29 - series_phi_a,
      series_phi_b_right_1 = 4.116826490666969e-29 - series_phi_b,
      series_phi_b_right_rest_1 = ksl_product_rest(5.107725174524775e-32, y, series_phi_a,
          series_phi_b_right_1),
      series_phi_b_lo1_1 = 4.116826490666969e-29 - (series_phi_b + series_phi_b_right_1)
          - series_phi_b_right_rest_1,
      series_phi_b_lo = series_phi_b_lo1_1
          - (KSL_MUL(4.7410392187559056e-48, y) + KSL_MUL(5.107725174524775e-32, y_lo)) +
          -1.8714974010023092e-45, series_phi_c = KSL_MUL(y, series_phi_b),
      series_phi_c_padded_1 = 1.8051943758648296e-276
          + (4.116826490666969e-29 + KSL_MUL(6.843135825984986e-08, y_size_1)),
      series_phi_c_reach_1 = fabs(series_phi_b)
          + KSL_MUL(140737488355328.0, fabs(series_phi_b_lo)
          + KSL_MUL(8.120831909935717e-28, series_phi_c_padded_1)),
      series_phi_d = series_phi_c - 2.86531123750421e-26,
      series_phi_d_right_1 = series_phi_c - series_phi_d,
      series_phi_d_left_rest_1 = ksl_product_rest(y, series_phi_b, series_phi_c, series_phi_d
          + series_phi_d_right_1),
      series_phi_d_lo2_1 = series_phi_d_left_rest_1 - (2.86531123750421e-26 - series_phi_d_right_1)
          - 2.3296034284323186e-42,
      series_phi_d_lo = series_phi_d_lo2_1
          + (KSL_MUL(y_lo, series_phi_b) + KSL_MUL(y, series_phi_b_lo)),
      series_phi_e = KSL_MUL(y, series_phi_d),
      series_phi_d_size_1 = 2.86531123750421e-26
          + (KSL_MUL(half_angle_reach_1, series_phi_c_padded_1)
          + KSL_MUL(half_angle_padded_1, series_phi_c_reach_1)),
      series_phi_e_padded_1 = 1.8051943758648296e-276 + series_phi_d_size_1,
      series_phi_e_reach_1 = fabs(series_phi_d)
          + KSL_MUL(140737488355328.0, fabs(series_phi_d_lo)
          + KSL_MUL(8.17876581047362e-28, series_phi_e_padded_1)),
      series_phi_f = series_phi_e + 1.701994875077501e-23,
      series_phi_f_right_1 = series_phi_f - series_phi_e,
      series_phi_f_left_rest_1 = ksl_product_rest(y, series_phi_d, series_phi_e, series_phi_f
          - series_phi_f_right_1),
      series_phi_f_lo2_1 = series_phi_f_left_rest_1
          + (1.701994875077501e-23 - series_phi_f_right_1) + 3.161967936521494e-40,
      series_phi_f_lo = series_phi_f_lo2_1
          + (KSL_MUL(y_lo, series_phi_d) + KSL_MUL(y, series_phi_d_lo)),
      series_phi_e_size_4 = KSL_MUL(half_angle_reach_1, series_phi_e_padded_1)
          + KSL_MUL(half_angle_padded_1, series_phi_e_reach_1),
      series_phi_g = KSL_MUL(y, series_phi_f),
      series_phi_g_padded_1 = 1.8051943758648296e-276
          + (1.701994875077501e-23 + series_phi_e_size_4),
      series_phi_g_reach_1 = fabs(series_phi_f)
          + KSL_MUL(140737488355328.0, fabs(series_phi_f_lo)
          + KSL_MUL(8.238918382307457e-28, series_phi_g_padded_1)),
      series_phi_h = series_phi_g - 8.509974375387505e-21,
      series_phi_h_right_1 = series_phi_g - series_phi_h,
      series_phi_h_left_rest_1 = ksl_product_rest(y, series_phi_f, series_phi_g, series_phi_h
          + series_phi_h_right_1),
      series_phi_h_lo2_1 = series_phi_h_left_rest_1
          - (8.509974375387505e-21 - series_phi_h_right_1) - 3.2266760594119493e-37,
      series_phi_h_lo = series_phi_h_lo2_1
          + (KSL_MUL(y_lo, series_phi_f) + KSL_MUL(y, series_phi_f_lo)),
      series_phi_g_size_4 = KSL_MUL(half_angle_reach_1, series_phi_g_padded_1)
          + KSL_MUL(half_angle_padded_1, series_phi_g_reach_1),
      series_phi_i = KSL_MUL(y, series_phi_h),
      series_phi_i_padded_1 = 1.8051943758648296e-276
          + (8.509974375387505e-21 + series_phi_g_size_4),
      series_phi_i_reach_1 = fabs(series_phi_h)
          + KSL_MUL(140737488355328.0, fabs(series_phi_h_lo)
          + KSL_MUL(8.301289625437229e-28, series_phi_i_padded_1)),
      series_phi_j = series_phi_i + 3.523129391410427e-18,
      series_phi_j_right_1 = series_phi_j - series_phi_i,
      series_phi_j_left_rest_1 = ksl_product_rest(y, series_phi_h, series_phi_i, series_phi_j
          - series_phi_j_right_1),
      series_phi_j_lo2_1 = series_phi_j_left_rest_1
          + (3.523129391410427e-18 - series_phi_j_right_1) + -1.2521244741738012e-34,
      series_phi_j_lo = series_phi_j_lo2_1
          + (KSL_MUL(y_lo, series_phi_h) + KSL_MUL(y, series_phi_h_lo)),
      series_phi_i_size_4 = KSL_MUL(half_angle_reach_1, series_phi_i_padded_1)
          + KSL_MUL(half_angle_padded_1, series_phi_i_reach_1),
      series_phi_k = KSL_MUL(y, series_phi_j),
      series_phi_k_padded_1 = 1.8051943758648296e-276
          + (3.523129391410427e-18 + series_phi_i_size_4),
      series_phi_k_reach_1 = fabs(series_phi_j)
          + KSL_MUL(140737488355328.0, fabs(series_phi_j_lo)
          + KSL_MUL(8.36587954080333e-28, series_phi_k_padded_1)),
      series_phi_l = series_phi_k - 1.1837714755139035e-15,
      series_phi_l_right_1 = series_phi_k - series_phi_l,
      series_phi_l_left_rest_1 = ksl_product_rest(y, series_phi_j, series_phi_k, series_phi_l
          + series_phi_l_right_1),
      series_phi_l_lo2_1 = series_phi_l_left_rest_1
          - (1.1837714755139035e-15 - series_phi_l_right_1) - 7.23242424407352e-33,
      series_phi_l_lo = series_phi_l_lo2_1
          + (KSL_MUL(y_lo, series_phi_j) + KSL_MUL(y, series_phi_j_lo)),
      series_phi_k_size_4 = KSL_MUL(half_angle_reach_1, series_phi_k_padded_1)
          + KSL_MUL(half_angle_padded_1, series_phi_k_reach_1),
      series_phi_m = KSL_MUL(y, series_phi_l),
      series_phi_m_padded_1 = 1.8051943758648296e-276
          + (1.1837714755139035e-15 + series_phi_k_size_4),
      series_phi_m_reach_1 = fabs(series_phi_l)
          + KSL_MUL(140737488355328.0, fabs(series_phi_l_lo)
          + KSL_MUL(8.432688128405761e-28, series_phi_m_padded_1)),
      series_phi_n = series_phi_m + 3.148832124866983e-13,
      series_phi_n_right_1 = series_phi_n - series_phi_m,
      series_phi_n_left_rest_1 = ksl_product_rest(y, series_phi_l, series_phi_m, series_phi_n
          - series_phi_n_right_1),
      series_phi_n_lo2_1 = series_phi_n_left_rest_1
          + (3.148832124866983e-13 - series_phi_n_right_1) + 5.8681293750286156e-30,
      series_phi_n_lo = series_phi_n_lo2_1
          + (KSL_MUL(y_lo, series_phi_l) + KSL_MUL(y, series_phi_l_lo)),
      series_phi_m_size_4 = KSL_MUL(half_angle_reach_1, series_phi_m_padded_1)
          + KSL_MUL(half_angle_padded_1, series_phi_m_reach_1),
      series_phi_o = KSL_MUL(y, series_phi_n),
      series_phi_o_padded_1 = 1.8051943758648296e-276
          + (3.148832124866983e-13 + series_phi_m_size_4),
      series_phi_o_reach_1 = fabs(series_phi_n)
          + KSL_MUL(140737488355328.0, fabs(series_phi_n_lo)
          + KSL_MUL(8.501715387304126e-28, series_phi_o_padded_1)),
      series_phi_p = series_phi_o - 6.423617534728645e-11,
      series_phi_p_right_1 = series_phi_o - series_phi_p,
      series_phi_p_left_rest_1 = ksl_product_rest(y, series_phi_n, series_phi_o, series_phi_p
          + series_phi_p_right_1),
      series_phi_p_lo2_1 = series_phi_p_left_rest_1
          - (6.423617534728645e-11 - series_phi_p_right_1) - 5.034117835500839e-27,
      series_phi_p_lo = series_phi_p_lo2_1
          + (KSL_MUL(y_lo, series_phi_n) + KSL_MUL(y, series_phi_n_lo)),
      series_phi_o_size_4 = KSL_MUL(half_angle_reach_1, series_phi_o_padded_1)
          + KSL_MUL(half_angle_padded_1, series_phi_o_reach_1),
      series_phi_q = KSL_MUL(y, series_phi_p),
      series_phi_q_padded_1 = 1.8051943758648296e-276
          + (6.423617534728645e-11 + series_phi_o_size_4),
      series_phi_q_reach_1 = fabs(series_phi_p)
          + KSL_MUL(140737488355328.0, fabs(series_phi_p_lo)
          + KSL_MUL(8.572961317498427e-28, series_phi_q_padded_1)),
      series_phi_r = series_phi_q + 9.635426302092969e-09,
      series_phi_r_right_1 = series_phi_r - series_phi_q,
      series_phi_r_left_rest_1 = ksl_product_rest(y, series_phi_p, series_phi_q, series_phi_r
          - series_phi_r_right_1),
      series_phi_r_lo2_1 = series_phi_r_left_rest_1
          + (9.635426302092969e-09 - series_phi_r_right_1) + -1.7546051379703029e-25,
      series_phi_r_lo = series_phi_r_lo2_1
          + (KSL_MUL(y_lo, series_phi_p) + KSL_MUL(y, series_phi_p_lo)),
      series_phi_q_size_4 = KSL_MUL(half_angle_reach_1, series_phi_q_padded_1)
          + KSL_MUL(half_angle_padded_1, series_phi_q_reach_1),
      series_phi_s = KSL_MUL(y, series_phi_r),
      series_phi_s_padded_1 = 1.8051943758648296e-276
          + (9.635426302092969e-09 + series_phi_q_size_4),
      series_phi_s_reach_1 = fabs(series_phi_r)
          + KSL_MUL(140737488355328.0, fabs(series_phi_r_lo)
          + KSL_MUL(8.64642591898866e-28, series_phi_s_padded_1)),
      series_phi_t = series_phi_s - 1.0020843354176687e-06,
      series_phi_t_right_1 = series_phi_s - series_phi_t,
      series_phi_t_left_rest_1 = ksl_product_rest(y, series_phi_r, series_phi_s, series_phi_t
          + series_phi_t_right_1),
      series_phi_t_lo2_1 = series_phi_t_left_rest_1
          - (1.0020843354176687e-06 - series_phi_t_right_1) - 4.7926555569351065e-23,
      series_phi_t_lo = series_phi_t_lo2_1
          + (KSL_MUL(y_lo, series_phi_r) + KSL_MUL(y, series_phi_r_lo)),
      series_phi_s_size_4 = KSL_MUL(half_angle_reach_1, series_phi_s_padded_1)
          + KSL_MUL(half_angle_padded_1, series_phi_s_reach_1),
      series_phi_u = KSL_MUL(y, series_phi_t),
      series_phi_u_padded_1 = 1.8051943758648296e-276
          + (1.0020843354176687e-06 + series_phi_s_size_4),
      series_phi_u_reach_1 = fabs(series_phi_t)
          + KSL_MUL(140737488355328.0, fabs(series_phi_t_lo)
          + KSL_MUL(8.722109191774827e-28, series_phi_u_padded_1)),
      series_phi_v = series_phi_u + 6.613756613756614e-05,
      series_phi_v_right_1 = series_phi_v - series_phi_u,
      series_phi_v_left_rest_1 = ksl_product_rest(y, series_phi_t, series_phi_u, series_phi_v
          - series_phi_v_right_1),
      series_phi_v_lo2_1 = series_phi_v_left_rest_1
          + (6.613756613756614e-05 - series_phi_v_right_1) + -4.460143857711533e-21,
      series_phi_v_lo = series_phi_v_lo2_1
          + (KSL_MUL(y_lo, series_phi_t) + KSL_MUL(y, series_phi_t_lo)),
      series_phi_u_size_4 = KSL_MUL(half_angle_reach_1, series_phi_u_padded_1)
          + KSL_MUL(half_angle_padded_1, series_phi_u_reach_1),
      series_phi_w = KSL_MUL(y, series_phi_v),
      series_phi_w_padded_1 = 1.8051943758648296e-276
          + (6.613756613756614e-05 + series_phi_u_size_4),
      series_phi_w_reach_1 = fabs(series_phi_v)
          + KSL_MUL(140737488355328.0, fabs(series_phi_v_lo)
          + KSL_MUL(8.800011135856928e-28, series_phi_w_padded_1)),
      series_phi_x = series_phi_w - 0.002380952380952381,
      series_phi_x_right_1 = series_phi_w - series_phi_x,
      series_phi_x_left_rest_1 = ksl_product_rest(y, series_phi_v, series_phi_w, series_phi_x
          + series_phi_x_right_1),
      series_phi_x_lo2_1 = series_phi_x_left_rest_1 - (0.002380952380952381 - series_phi_x_right_1)
          - -2.147752875018904e-19,
      series_phi_x_lo = series_phi_x_lo2_1
          + (KSL_MUL(y_lo, series_phi_v) + KSL_MUL(y, series_phi_v_lo)),
      series_phi_y = KSL_MUL(y, series_phi_x),
      series_phi_x_size_1 = 0.002380952380952381
          + (KSL_MUL(half_angle_reach_1, series_phi_w_padded_1)
          + KSL_MUL(half_angle_padded_1, series_phi_w_reach_1)),
      series_phi_y_padded_1 = 1.8051943758648296e-276 + series_phi_x_size_1,
      series_phi_y_reach_1 = fabs(series_phi_x)
          + KSL_MUL(140737488355328.0, fabs(series_phi_x_lo)
          + KSL_MUL(8.880131751234963e-28, series_phi_y_padded_1)),
      series_phi = series_phi_y + 0.03333333333333333,
      series_phi_right_1 = series_phi - series_phi_y,
      series_phi_lo1_1 = ksl_product_rest(y, series_phi_x, series_phi_y, series_phi
          - series_phi_right_1) + (0.03333333333333333 - series_phi_right_1),
      series_phi_lo = series_phi_lo1_1 + 4.625929269271486e-19
          + (KSL_MUL(y_lo, series_phi_x) + KSL_MUL(y, series_phi_x_lo));
  const double f_more_a = KSL_MUL(2.0, y), f_more_a_cross2_1 = KSL_MUL(2.0, y_lo),
      f_more = KSL_MUL(f_more_a, series_phi),
      f_more_padded_1 = 1.8051943758648296e-276 + KSL_MUL(2.0, y_size_1);
  const double series_phi_size_1 = 0.03333333333333333
          + (KSL_MUL(half_angle_reach_1, series_phi_y_padded_1)
          + KSL_MUL(half_angle_padded_1, series_phi_y_reach_1));
  const double f_more_padded_2 = 1.8051943758648296e-276 + series_phi_size_1,
      f_more_reach_1 = fabs(f_more_a)
          + KSL_MUL(140737488355328.0, fabs(f_more_a_cross2_1)
          + KSL_MUL(2.8103175390871538e-30, f_more_padded_1)),
      f_more_reach_2 = fabs(series_phi)
          + KSL_MUL(140737488355328.0, fabs(series_phi_lo)
          + KSL_MUL(8.962471037908933e-28, f_more_padded_2));
  const double near_f_a = KSL_MUL(0.3333333333333333, sinc),
      near_f_b = KSL_MUL(0.3333333333333333, f_more),
      f_more_lo = ksl_product_error(f_more_a, series_phi, f_more)
          + (KSL_MUL(f_more_a_cross2_1, series_phi) + KSL_MUL(f_more_a, series_phi_lo)),
      near_f = near_f_a + near_f_b, near_f_right_1 = near_f - near_f_a,
      near_f_b_cross_1 = KSL_MUL(1.850371707708594e-17, f_more)
          + KSL_MUL(0.3333333333333333, f_more_lo),
      near_f_left_rest_1 = ksl_product_rest(0.3333333333333333, sinc, near_f_a, near_f
          - near_f_right_1),
      near_f_cross_1 = KSL_MUL(1.850371707708594e-17, sinc) + KSL_MUL(0.3333333333333333, sinc_lo)
          + near_f_b_cross_1,
      near_f_lo = near_f_left_rest_1
          + ksl_product_rest(0.3333333333333333, f_more, near_f_b, near_f_right_1) + near_f_cross_1,
      near_f_b_size_1 = KSL_MUL(0.3333333333333333, KSL_MUL(f_more_padded_2, f_more_reach_1)
          + KSL_MUL(f_more_padded_1, f_more_reach_2)),
      near_f_size_1 = KSL_MUL(0.3333333333333333, sinc_size_8) + near_f_b_size_1;
  const double f_rest = sinc - c, f_rest_right_1 = sinc - f_rest;
  const double fine_x = KSL_MUL(4.0, y);
  const double far_y = fine_x < 4.0 ? 1.0 : y, far_y_lo = fine_x < 4.0 ? 0.0 : y_lo,
      far_y_bound_1 = fabs(KSL_MUL(4.0, y_lo))
          + KSL_MUL(2.8103175390871538e-30, 1.8051943758648296e-276 + KSL_MUL(4.0, y_size_1)),
      far_y_size_3 = fabs(fine_x - 4.0), far_y_size_7 = fabs(1.0 - y) + half_angle_bound_1;
  const double closed_f = f_rest / far_y, closed_f_product_1 = KSL_MUL(closed_f, far_y),
      closed_f_exact_1 = f_rest - closed_f_product_1
          - ksl_product_error(closed_f, far_y, closed_f_product_1),
      closed_f_lo = (closed_f_exact_1
          + (sinc - (f_rest + f_rest_right_1) - (c - f_rest_right_1) - c_lo + sinc_lo)
          - KSL_MUL(closed_f, far_y_lo)) / far_y;
  const double far_y_size_10 = (fine_x < 4.0 ? 1.0 : y_size_1)
          + KSL_MUL(6.338251187752959e+28, far_y_bound_1 < far_y_size_3 ? 0.0 : far_y_size_7);
  const double closed_f_padded_2 = 1.8051943758648296e-276 + far_y_size_10,
      closed_f_size_1 = fabs(closed_f), closed_f_size_2 = fabs(far_y),
      closed_f_bound_1 = fabs(far_y_lo) + KSL_MUL(1.6270262376793602e-29, closed_f_padded_2),
      closed_f_size_4 = 1.8051943758648296e-276 + (fine_sine_size_1 + sinc_size_8)
          + KSL_MUL(closed_f_padded_2, closed_f_size_1),
      closed_f_size_8 = closed_f_size_4
          / (KSL_MUL(4.0, closed_f_bound_1) < closed_f_size_2 ? closed_f_size_2 : 0.0),
      closed_f_size_11 = closed_f_size_1
          + KSL_MUL(closed_f_size_2
          + KSL_MUL(140737488355328.0, closed_f_bound_1), closed_f_size_8) / closed_f_size_2;
  const double f = fine_x < 4.0 ? near_f : closed_f,
      f_size_4 = fabs(near_f_lo)
          + KSL_MUL(9.075379655148354e-28, 1.8051943758648296e-276 + near_f_size_1)
          + fabs(near_f - closed_f),
      f_size_5 = fabs(closed_f_lo)
          + KSL_MUL(8.245490617302283e-28, 1.8051943758648296e-276 + closed_f_size_11) + f_size_4;
  const double four_k = KSL_MUL(4.0, sinc), four_k_cross2_1 = KSL_MUL(4.0, sinc_lo);
  const double fine_b = f / four_k, fine_b_product_1 = KSL_MUL(fine_b, four_k),
      fine_b_numerator_1 = f - fine_b_product_1
          - ksl_product_error(fine_b, four_k, fine_b_product_1)
          + (fine_x < 4.0 ? near_f_lo : closed_f_lo),
      fine_b_lo = (fine_b_numerator_1 - KSL_MUL(fine_b, four_k_cross2_1)) / four_k;
  const double f_size_8 = (fine_x < 4.0 ? near_f_size_1 : closed_f_size_11)
          + KSL_MUL(1.1062092690083102e+27, far_y_bound_1 < far_y_size_3 ? 0.0 : f_size_5);
  const double fine_b_padded_2 = 1.8051943758648296e-276 + KSL_MUL(4.0, sinc_size_8),
      fine_b_size_1 = fabs(fine_b), fine_b_size_2 = fabs(four_k),
      fine_b_bound_1 = fabs(four_k_cross2_1) + KSL_MUL(8.125024661305438e-28, fine_b_padded_2),
      fine_b_size_4 = 1.8051943758648296e-276 + f_size_8 + KSL_MUL(fine_b_padded_2, fine_b_size_1),
      fine_b_size_8 = fine_b_size_4
          / (KSL_MUL(4.0, fine_b_bound_1) < fine_b_size_2 ? fine_b_size_2 : 0.0);
  const double fine_b_across = c / sinc, fine_b_across_product_1 = KSL_MUL(fine_b_across, sinc),
      fine_b_across_numerator_1 = c - fine_b_across_product_1
          - ksl_product_error(fine_b_across, sinc, fine_b_across_product_1) + c_lo,
      fine_b_across_lo = (fine_b_across_numerator_1 - KSL_MUL(fine_b_across, sinc_lo)) / sinc,
      fine_b_across_padded_1 = 1.8051943758648296e-276 + sinc_size_8,
      fine_b_across_size_1 = fabs(fine_b_across), fine_b_across_size_2 = fabs(sinc),
      fine_b_across_bound_1 = fabs(sinc_lo)
          + KSL_MUL(8.120832873841084e-28, fine_b_across_padded_1),
      fine_b_across_size_7 = KSL_MUL(4.0, fine_b_across_bound_1) < fine_b_across_size_2
          ? fine_b_across_size_2 : 0.0,
      fine_b_across_size_8 = (KSL_MUL(fine_b_across_padded_1, fine_b_across_size_1)
          + sinc_quotient_padded_1) / fine_b_across_size_7,
      fine_b_across_size_10 = KSL_MUL(fine_b_across_size_2
          + KSL_MUL(140737488355328.0, fine_b_across_bound_1), fine_b_across_size_8)
          / fine_b_across_size_2,
      fine_b_across_size_11 = fine_b_across_size_1 + fine_b_across_size_10;
  const double fine_beta_v_0 = KSL_MUL(v->x, fine_b);
  const double fine_b_size_11 = fine_b_size_1
          + KSL_MUL(fine_b_size_2 + KSL_MUL(140737488355328.0, fine_b_bound_1), fine_b_size_8)
          / fine_b_size_2;
  const double fine_beta_v_padded_1 = 1.8051943758648296e-276 + fine_b_size_11;
  const double fine_beta_v_1 = KSL_MUL(v->y, fine_b);
  const double fine_beta_v_2 = KSL_MUL(v->z, fine_b);
  const double fine_beta_v_lo_1 = ksl_product_error(v->x, fine_b, fine_beta_v_0)
          + KSL_MUL(v->x, fine_b_lo), fine_m_0 = KSL_MUL(v->x, fine_beta_v_0),
      fine_m_cross2_1 = KSL_MUL(v->x, fine_beta_v_lo_1),
      fine_m_padded_1 = 1.8051943758648296e-276 + KSL_MUL(fine_beta_v_padded_1, halved_size_1),
      fine_m_size_1 = KSL_MUL(fine_m_padded_1, halved_size_1);
  const double fine_beta_v_lo_2 = ksl_product_error(v->y, fine_b, fine_beta_v_1)
          + KSL_MUL(v->y, fine_b_lo), fine_m_1 = KSL_MUL(v->y, fine_beta_v_1),
      fine_m_cross2_2 = KSL_MUL(v->y, fine_beta_v_lo_2),
      fine_m_padded_2 = 1.8051943758648296e-276 + KSL_MUL(fine_beta_v_padded_1, halved_size_3),
      fine_m_size_2 = KSL_MUL(fine_m_padded_2, halved_size_3);
  const double fine_m_2 = KSL_MUL(v->z, fine_beta_v_2),
      fine_m_cross2_3 = KSL_MUL(v->z, ksl_product_error(v->z, fine_b, fine_beta_v_2)
          + KSL_MUL(v->z, fine_b_lo)),
      fine_m_size_3 = KSL_MUL(1.8051943758648296e-276
          + KSL_MUL(fine_beta_v_padded_1, halved_size_5), halved_size_5);
  const double fine_m_3 = KSL_MUL(v->y, fine_beta_v_0),
      fine_m_cross2_4 = KSL_MUL(v->y, fine_beta_v_lo_1);
  const double fine_m_4 = KSL_MUL(v->z, fine_beta_v_0),
      fine_m_cross2_5 = KSL_MUL(v->z, fine_beta_v_lo_1);
  const double fine_m_5 = KSL_MUL(v->z, fine_beta_v_1),
      fine_m_cross2_6 = KSL_MUL(v->z, fine_beta_v_lo_2);
  const double fine_others_0 = fine_m_1 + fine_m_2, fine_others_right_1 = fine_others_0 - fine_m_1,
      fine_others_left_rest_1 = ksl_product_rest(v->y, fine_beta_v_1, fine_m_1, fine_others_0
          - fine_others_right_1),
      fine_others_lo1_1 = fine_others_left_rest_1
          + ksl_product_rest(v->z, fine_beta_v_2, fine_m_2, fine_others_right_1),
      fine_others_lo_1 = fine_others_lo1_1 + (fine_m_cross2_2 + fine_m_cross2_3),
      fine_others_size_1 = fine_m_size_2 + fine_m_size_3;
  const double fine_others_1 = fine_m_0 + fine_m_2, fine_others_right_2 = fine_others_1 - fine_m_0,
      fine_others_left_rest_2 = ksl_product_rest(v->x, fine_beta_v_0, fine_m_0, fine_others_1
          - fine_others_right_2),
      fine_others_lo1_2 = fine_others_left_rest_2
          + ksl_product_rest(v->z, fine_beta_v_2, fine_m_2, fine_others_right_2),
      fine_others_lo_2 = fine_others_lo1_2 + (fine_m_cross2_1 + fine_m_cross2_3),
      fine_others_size_2 = fine_m_size_1 + fine_m_size_3;
  const double fine_others_2 = fine_m_0 + fine_m_1, fine_others_right_3 = fine_others_2 - fine_m_0,
      fine_others_left_rest_3 = ksl_product_rest(v->x, fine_beta_v_0, fine_m_0, fine_others_2
          - fine_others_right_3),
      fine_others_lo1_3 = fine_others_left_rest_3
          + ksl_product_rest(v->y, fine_beta_v_1, fine_m_1, fine_others_right_3),
      fine_others_lo_3 = fine_others_lo1_3 + (fine_m_cross2_1 + fine_m_cross2_2),
      fine_others_size_3 = fine_m_size_1 + fine_m_size_2;
  const double fine_diagonal0a = 1.0 - fine_others_0,
      fine_diagonal0a_right_1 = 1.0 - fine_diagonal0a,
      fine_diagonal0a_lo = 1.0 - (fine_diagonal0a + fine_diagonal0a_right_1)
          - (fine_others_0 - fine_diagonal0a_right_1) - fine_others_lo_1,
      fine_diagonal0a_size_1 = 1.0 + fine_others_size_1, fine_diagonal0b = fine_b_across + fine_m_0,
      fine_diagonal0b_right_1 = fine_diagonal0b - fine_b_across,
      fine_diagonal0b_right_rest_1 = ksl_product_rest(v->x, fine_beta_v_0, fine_m_0,
          fine_diagonal0b_right_1),
      fine_diagonal0b_lo = fine_b_across - (fine_diagonal0b - fine_diagonal0b_right_1)
          + fine_diagonal0b_right_rest_1 + fine_m_cross2_1 + fine_b_across_lo,
      fine_diagonal0b_size_1 = fine_b_across_size_11 + fine_m_size_1,
      fine_diagonal0_error_1 = fabs(ksl_product_error(v->x, fine_beta_v_0, fine_m_0)
          + fine_m_cross2_1),
      fine_diagonal0_bound_2 = fabs(fine_others_lo_1)
          + KSL_MUL(9.550468072637709e-28, 1.8051943758648296e-276 + fine_others_size_1),
      fine_diagonal0_bound_3 = fabs(fine_diagonal0b_lo)
          + KSL_MUL(9.550468072637709e-28, 1.8051943758648296e-276 + fine_diagonal0b_size_1),
      fine_diagonal0_bound_4 = fabs(fine_diagonal0a_lo)
          + KSL_MUL(9.58769341332938e-28, 1.8051943758648296e-276 + fine_diagonal0a_size_1),
      fine_diagonal0_size_9 = fine_diagonal0_bound_4
          + (fine_diagonal0_bound_3 + fabs(fine_diagonal0b - fine_diagonal0a)),
      fine_diagonal0_size_2 = fine_diagonal0_error_1
          + KSL_MUL(9.513982289044683e-28, 1.8051943758648296e-276 + fine_m_size_1)
          + fine_diagonal0_bound_2,
      fine_diagonal0_size_11 = KSL_MUL(1.0474204728201347e+27, fine_diagonal0_size_2
          < fabs(fine_m_0 - fine_others_0) ? 0.0 : fine_diagonal0_size_9);
  const double fine_diagonal1a = 1.0 - fine_others_1,
      fine_diagonal1a_right_1 = 1.0 - fine_diagonal1a,
      fine_diagonal1a_lo = 1.0 - (fine_diagonal1a + fine_diagonal1a_right_1)
          - (fine_others_1 - fine_diagonal1a_right_1) - fine_others_lo_2,
      fine_diagonal1a_size_1 = 1.0 + fine_others_size_2, fine_diagonal1b = fine_b_across + fine_m_1,
      fine_diagonal1b_right_1 = fine_diagonal1b - fine_b_across,
      fine_diagonal1b_right_rest_1 = ksl_product_rest(v->y, fine_beta_v_1, fine_m_1,
          fine_diagonal1b_right_1),
      fine_diagonal1b_lo = fine_b_across - (fine_diagonal1b - fine_diagonal1b_right_1)
          + fine_diagonal1b_right_rest_1 + fine_m_cross2_2 + fine_b_across_lo,
      fine_diagonal1b_size_1 = fine_b_across_size_11 + fine_m_size_2,
      fine_diagonal1_error_1 = fabs(ksl_product_error(v->y, fine_beta_v_1, fine_m_1)
          + fine_m_cross2_2),
      fine_diagonal1_bound_2 = fabs(fine_others_lo_2)
          + KSL_MUL(9.550468072637709e-28, 1.8051943758648296e-276 + fine_others_size_2),
      fine_diagonal1_bound_3 = fabs(fine_diagonal1b_lo)
          + KSL_MUL(9.550468072637709e-28, 1.8051943758648296e-276 + fine_diagonal1b_size_1),
      fine_diagonal1_bound_4 = fabs(fine_diagonal1a_lo)
          + KSL_MUL(9.58769341332938e-28, 1.8051943758648296e-276 + fine_diagonal1a_size_1),
      fine_diagonal1_size_9 = fine_diagonal1_bound_4
          + (fine_diagonal1_bound_3 + fabs(fine_diagonal1b - fine_diagonal1a)),
      fine_diagonal1_size_2 = fine_diagonal1_error_1
          + KSL_MUL(9.513982289044683e-28, 1.8051943758648296e-276 + fine_m_size_2)
          + fine_diagonal1_bound_2,
      fine_diagonal1_size_11 = KSL_MUL(1.0474204728201347e+27, fine_diagonal1_size_2
          < fabs(fine_m_1 - fine_others_1) ? 0.0 : fine_diagonal1_size_9);
  const double fine_diagonal2a = 1.0 - fine_others_2,
      fine_diagonal2a_right_1 = 1.0 - fine_diagonal2a,
      fine_diagonal2a_lo = 1.0 - (fine_diagonal2a + fine_diagonal2a_right_1)
          - (fine_others_2 - fine_diagonal2a_right_1) - fine_others_lo_3,
      fine_diagonal2a_size_1 = 1.0 + fine_others_size_3, fine_diagonal2b = fine_b_across + fine_m_2,
      fine_diagonal2b_right_1 = fine_diagonal2b - fine_b_across,
      fine_diagonal2b_right_rest_1 = ksl_product_rest(v->z, fine_beta_v_2, fine_m_2,
          fine_diagonal2b_right_1),
      fine_diagonal2b_lo = fine_b_across - (fine_diagonal2b - fine_diagonal2b_right_1)
          + fine_diagonal2b_right_rest_1 + fine_m_cross2_3 + fine_b_across_lo,
      fine_diagonal2b_size_1 = fine_b_across_size_11 + fine_m_size_3,
      fine_diagonal2_error_1 = fabs(ksl_product_error(v->z, fine_beta_v_2, fine_m_2)
          + fine_m_cross2_3),
      fine_diagonal2_bound_2 = fabs(fine_others_lo_3)
          + KSL_MUL(9.550468072637709e-28, 1.8051943758648296e-276 + fine_others_size_3),
      fine_diagonal2_bound_3 = fabs(fine_diagonal2b_lo)
          + KSL_MUL(9.550468072637709e-28, 1.8051943758648296e-276 + fine_diagonal2b_size_1),
      fine_diagonal2_bound_4 = fabs(fine_diagonal2a_lo)
          + KSL_MUL(9.58769341332938e-28, 1.8051943758648296e-276 + fine_diagonal2a_size_1),
      fine_diagonal2_size_9 = fine_diagonal2_bound_4
          + (fine_diagonal2_bound_3 + fabs(fine_diagonal2b - fine_diagonal2a)),
      fine_diagonal2_size_2 = fine_diagonal2_error_1
          + KSL_MUL(9.513982289044683e-28, 1.8051943758648296e-276 + fine_m_size_3)
          + fine_diagonal2_bound_2,
      fine_diagonal2_size_11 = KSL_MUL(1.0474204728201347e+27, fine_diagonal2_size_2
          < fabs(fine_m_2 - fine_others_2) ? 0.0 : fine_diagonal2_size_9);
  const double fine_alpha_v_0 = -halved_0;
  const double fine_alpha_v_1 = -halved_1;
  const double fine_alpha_v_2 = -halved_2;
  const double fine_R_01 = fine_m_3 - fine_alpha_v_2, fine_R_right_1 = fine_m_3 - fine_R_01;
  const double fine_R_02 = fine_m_4 + fine_alpha_v_1, fine_R_right_2 = fine_R_02 - fine_m_4;
  const double fine_R_10 = fine_m_3 + fine_alpha_v_2, fine_R_right_3 = fine_R_10 - fine_m_3;
  const double fine_R_12 = fine_m_5 - fine_alpha_v_0, fine_R_right_4 = fine_m_5 - fine_R_12;
  const double fine_R_20 = fine_m_4 - fine_alpha_v_1, fine_R_right_5 = fine_m_4 - fine_R_20;
  const double fine_R_21 = fine_m_5 + fine_alpha_v_0, fine_R_right_6 = fine_R_21 - fine_m_5;
  const double diagonal0_apart_1 = (fine_m_0 < fine_others_0 ? fine_diagonal0b : fine_diagonal0a)
          - diagonal0,
      diagonal0_padded_1 = 1.8051943758648296e-276
          + ((fine_m_0 < fine_others_0 ? fine_diagonal0b_size_1 : fine_diagonal0a_size_1)
          + fine_diagonal0_size_11),
      diagonal0_error_2 = KSL_MUL(1.0000000000000009, fabs(diagonal0_apart_1
          + (fine_m_0 < fine_others_0 ? fine_diagonal0b_lo : fine_diagonal0a_lo)));
  const double fine_R_lo_1 = ksl_product_rest(v->y, fine_beta_v_0, fine_m_3, fine_R_01
          + fine_R_right_1) - (fine_alpha_v_2 - fine_R_right_1) + fine_m_cross2_4;
  const double R_rest_1 = KSL_MUL(9.550468072637709e-28, 1.8051943758648296e-276
          + (KSL_MUL(fine_m_padded_1, halved_size_3) + halved_size_6));
  const double fine_R_lo_2 = ksl_product_rest(v->z, fine_beta_v_0, fine_m_4, fine_R_02
          - fine_R_right_2) + (fine_alpha_v_1 - fine_R_right_2) + fine_m_cross2_5;
  const double R_rest_2 = KSL_MUL(9.550468072637709e-28, 1.8051943758648296e-276
          + (KSL_MUL(fine_m_padded_1, halved_size_5) + halved_size_4));
  const double fine_R_lo_3 = ksl_product_rest(v->y, fine_beta_v_0, fine_m_3, fine_R_10
          - fine_R_right_3) + (fine_alpha_v_2 - fine_R_right_3) + fine_m_cross2_4;
  const double diagonal1_apart_1 = (fine_m_1 < fine_others_1 ? fine_diagonal1b : fine_diagonal1a)
          - diagonal1,
      diagonal1_padded_1 = 1.8051943758648296e-276
          + ((fine_m_1 < fine_others_1 ? fine_diagonal1b_size_1 : fine_diagonal1a_size_1)
          + fine_diagonal1_size_11),
      diagonal1_error_2 = KSL_MUL(1.0000000000000009, fabs(diagonal1_apart_1
          + (fine_m_1 < fine_others_1 ? fine_diagonal1b_lo : fine_diagonal1a_lo)));
  const double fine_R_lo_4 = ksl_product_rest(v->z, fine_beta_v_1, fine_m_5, fine_R_12
          + fine_R_right_4) - (fine_alpha_v_0 - fine_R_right_4) + fine_m_cross2_6;
  const double R_rest_3 = KSL_MUL(9.550468072637709e-28, 1.8051943758648296e-276
          + (KSL_MUL(fine_m_padded_2, halved_size_5) + halved_size_2));
  const double fine_R_lo_5 = ksl_product_rest(v->z, fine_beta_v_0, fine_m_4, fine_R_20
          + fine_R_right_5) - (fine_alpha_v_1 - fine_R_right_5) + fine_m_cross2_5;
  const double fine_R_lo_6 = ksl_product_rest(v->z, fine_beta_v_1, fine_m_5, fine_R_21
          - fine_R_right_6) + (fine_alpha_v_0 - fine_R_right_6) + fine_m_cross2_6;
  const double diagonal2_apart_1 = (fine_m_2 < fine_others_2 ? fine_diagonal2b : fine_diagonal2a)
          - diagonal2,
      diagonal2_padded_1 = 1.8051943758648296e-276
          + ((fine_m_2 < fine_others_2 ? fine_diagonal2b_size_1 : fine_diagonal2a_size_1)
          + fine_diagonal2_size_11),
      diagonal2_error_2 = KSL_MUL(1.0000000000000009, fabs(diagonal2_apart_1
          + (fine_m_2 < fine_others_2 ? fine_diagonal2b_lo : fine_diagonal2a_lo))),
      diagonal0_bound_1 = diagonal0_error_2 + KSL_MUL(9.587694380055934e-28, diagonal0_padded_1),
      R_bound_1 = KSL_MUL(1.0000000000000009, fabs(fine_R_01 - R_01 + fine_R_lo_1)) + R_rest_1,
      R_bound_2 = KSL_MUL(1.0000000000000009, fabs(fine_R_02 - R_02 + fine_R_lo_2)) + R_rest_2,
      R_bound_3 = KSL_MUL(1.0000000000000009, fabs(fine_R_10 - R_10 + fine_R_lo_3)) + R_rest_1,
      diagonal1_bound_1 = diagonal1_error_2 + KSL_MUL(9.587694380055934e-28, diagonal1_padded_1),
      R_bound_4 = KSL_MUL(1.0000000000000009, fabs(fine_R_12 - R_12 + fine_R_lo_4)) + R_rest_3,
      R_bound_5 = KSL_MUL(1.0000000000000009, fabs(fine_R_20 - R_20 + fine_R_lo_5)) + R_rest_2,
      R_bound_6 = KSL_MUL(1.0000000000000009, fabs(fine_R_21 - R_21 + fine_R_lo_6)) + R_rest_3,
      diagonal2_bound_1 = diagonal2_error_2 + KSL_MUL(9.587694380055934e-28, diagonal2_padded_1);
  R->m00 = diagonal0;
  R->m01 = R_01;
  R->m02 = R_02;
  R->m10 = R_10;
  R->m11 = diagonal1;
  R->m12 = R_12;
  R->m20 = R_20;
  R->m21 = R_21;
  R->m22 = diagonal2;
  R_bound->m00 = diagonal0_bound_1;
  R_bound->m01 = R_bound_1;
  R_bound->m02 = R_bound_2;
  R_bound->m10 = R_bound_3;
  R_bound->m11 = diagonal1_bound_1;
  R_bound->m12 = R_bound_4;
  R_bound->m20 = R_bound_5;
  R_bound->m21 = R_bound_6;
  R_bound->m22 = diagonal2_bound_1;
}

/* R = J_r(v)^-1 = I + v~/2 + (1 - θ/2 cot θ/2)/θ^2 v~^2, θ = |v|; singular at multiples of 2π
     except 0; |error of R| <= R_bound unless inf or NaN.
   v: vector; R, R_bound: rotation or other 3×3 matrix.
   420 mul, 746 add, 23 product error, 34 product rest, 23 div, 3 sqrt, 93 abs, 23 less, 1 equal,
     47 select. */
static inline void ksl_SO3_rightJacobianInverse_certified(const ksl_vec3_t *v, ksl_mat3x3_t *R,
    ksl_mat3x3_t *R_bound) {
  const double size_0 = fabs(v->x), size_1 = fabs(v->y), size_2 = fabs(v->z);
  const double sizes = size_0 + size_1 + size_2;
  const double grid = KSL_MUL(sizes, 268435456.0);
  const double shifted_0 = v->x + grid, shifted_1 = v->y + grid, shifted_2 = v->z + grid;
  const double high_0 = shifted_0 - grid, high_1 = shifted_1 - grid, high_2 = shifted_2 - grid;
  const double low_0 = v->x - high_0, low_1 = v->y - high_1, low_2 = v->z - high_2;
  const double sum_0 = v->x + high_0, sum_1 = v->y + high_1, sum_2 = v->z + high_2;
  const double squares = KSL_MUL(high_0, high_0) + KSL_MUL(high_1, high_1)
          + KSL_MUL(high_2, high_2);
  const double cross = KSL_MUL(low_0, sum_0) + KSL_MUL(low_1, sum_1) + KSL_MUL(low_2, sum_2);
  const double x = squares + cross;
  const double theta_a = sqrt(x), theta = x < 1.0 ? 1.0 : theta_a;
  const double theta_shifted = grid + theta;
  const double theta_high = theta_shifted - grid;
  const double theta_low = theta - theta_high;
  const double theta_sum = theta + theta_high;
  const double cross_rest = cross - KSL_MUL(theta_low, theta_sum);
  const double exact = squares - KSL_MUL(theta_high, theta_high);
  const double residual = cross_rest + exact;
  const double small = KSL_MUL(0.5, residual) / theta;
  const double delta = fabs(small) < 0.0078125 ? small : 0.0;
  double far_cosine_a; const double far_sine_a = ksl_sincos(theta, &far_cosine_a);
  const double far_sine = x < 1.0 ? 1.0 : far_sine_a;
  const double far_cosine = x < 1.0 ? 0.0 : far_cosine_a;
  const double sine = KSL_MUL(delta, far_cosine) + far_sine;
  const double cosine = far_cosine - KSL_MUL(delta, far_sine);
  const double above_a = cosine + 1.0, above = cosine < 0.0 ? sine : above_a;
  const double below_a = 1.0 - cosine, below = cosine < 0.0 ? below_a : sine;
  const double cotangent = above / below;
  const double half_cotangent = KSL_MUL(KSL_MUL(0.5, theta), cotangent);
  const double b_rest = 1.0 - half_cotangent;
  const double b_divisor = x < 4.0 ? 4.0 : x;
  const double closed_b = b_rest / b_divisor;
  const double b_g = KSL_MUL(x, KSL_MUL(x, KSL_MUL(x, KSL_MUL(1.455172475614865e-27, x)
          + 5.744790668872202e-26) + 2.267952452337683e-24) + 8.953517427037546e-23),
      b_n = KSL_MUL(x, KSL_MUL(x, KSL_MUL(x, b_g + 3.534707039629467e-21) + 1.3954464685812522e-19)
          + 5.5090028283602295e-18) + 2.174868698558062e-16,
      b_u = KSL_MUL(x, KSL_MUL(x, KSL_MUL(x, KSL_MUL(x, b_n) + 8.586062056277845e-15)
          + 3.3896802963225827e-13) + 1.3382536530684679e-11),
      b_ab = KSL_MUL(x, KSL_MUL(x, KSL_MUL(x, b_u + 5.284190138687493e-10) + 2.08767569878681e-08)
          + 8.267195767195768e-07) + 3.306878306878307e-05,
      b_af = KSL_MUL(x, KSL_MUL(x, b_ab) + 0.001388888888888889) + 0.08333333333333333,
      b = x < 4.0 ? b_af : closed_b;
  const double b_across_b = 1.0 - KSL_MUL(x, b), b_across = x < 4.0 ? b_across_b : half_cotangent;
  const double beta_v_0 = KSL_MUL(v->x, b);
  const double beta_v_1 = KSL_MUL(v->y, b);
  const double beta_v_2 = KSL_MUL(v->z, b);
  const double m_0 = KSL_MUL(v->x, beta_v_0);
  const double m_1 = KSL_MUL(v->y, beta_v_1);
  const double m_2 = KSL_MUL(v->z, beta_v_2);
  const double m_3 = KSL_MUL(v->y, beta_v_0);
  const double m_4 = KSL_MUL(v->z, beta_v_0);
  const double m_5 = KSL_MUL(v->z, beta_v_1);
  const double others_0 = m_1 + m_2;
  const double others_1 = m_0 + m_2;
  const double others_2 = m_0 + m_1;
  const double diagonal0a = 1.0 - others_0, diagonal0b = b_across + m_0,
      diagonal0 = m_0 < others_0 ? diagonal0b : diagonal0a;
  const double diagonal1a = 1.0 - others_1, diagonal1b = b_across + m_1,
      diagonal1 = m_1 < others_1 ? diagonal1b : diagonal1a;
  const double diagonal2a = 1.0 - others_2, diagonal2b = b_across + m_2,
      diagonal2 = m_2 < others_2 ? diagonal2b : diagonal2a;
  const double alpha_v_0 = KSL_MUL(0.5, v->x), alpha_v_1 = KSL_MUL(0.5, v->y),
      alpha_v_2 = KSL_MUL(0.5, v->z);
  const double R_01 = m_3 - alpha_v_2;
  const double R_02 = m_4 + alpha_v_1;
  const double R_10 = m_3 + alpha_v_2;
  const double R_12 = m_5 - alpha_v_0;
  const double R_20 = m_4 - alpha_v_1;
  const double R_21 = m_5 + alpha_v_0;
  const double halved_0 = KSL_MUL(0.5, v->x), halved_size_1 = fabs(v->x),
      halved_size_2 = KSL_MUL(0.5, halved_size_1);
  const double halved_1 = KSL_MUL(0.5, v->y), halved_size_3 = fabs(v->y),
      halved_size_4 = KSL_MUL(0.5, halved_size_3);
  const double halved_2 = KSL_MUL(0.5, v->z), halved_size_5 = fabs(v->z),
      halved_size_6 = KSL_MUL(0.5, halved_size_5);
  const double y_a = KSL_MUL(halved_0, halved_0),
      y_a_padded_1 = 1.8051943758648296e-276 + halved_size_2, y_b = KSL_MUL(halved_1, halved_1),
      y_b_padded_1 = 1.8051943758648296e-276 + halved_size_4, y_c = y_a + y_b,
      y_c_right_1 = y_c - y_a, y_d = KSL_MUL(halved_2, halved_2),
      y_d_padded_1 = 1.8051943758648296e-276 + halved_size_6, y = y_c + y_d, y_right_1 = y - y_c,
      y_c_lo = ksl_product_rest(halved_0, halved_0, y_a, y_c - y_c_right_1)
          + ksl_product_rest(halved_1, halved_1, y_b, y_c_right_1),
      y_lo = y_c - (y - y_right_1) + ksl_product_rest(halved_2, halved_2, y_d, y_right_1) + y_c_lo,
      y_size_1 = KSL_MUL(y_a_padded_1, y_a_padded_1) + KSL_MUL(y_b_padded_1, y_b_padded_1)
          + KSL_MUL(y_d_padded_1, y_d_padded_1);
  const double half_angle = sqrt(y), half_angle_product_1 = KSL_MUL(half_angle, half_angle),
      half_angle_twice_1 = half_angle + half_angle,
      half_angle_residual_1 = y - half_angle_product_1
          - ksl_product_error(half_angle, half_angle, half_angle_product_1) + y_lo,
      half_angle_lo = half_angle_residual_1 / (half_angle == 0.0 ? 1.0 : half_angle_twice_1),
      half_angle_padded_1 = 1.8051943758648296e-276 + y_size_1,
      half_angle_bound_1 = fabs(y_lo) + KSL_MUL(2.5021685128863245e-30, half_angle_padded_1),
      half_angle_reach_1 = fabs(y) + KSL_MUL(140737488355328.0, half_angle_bound_1),
      half_angle_size_4 = KSL_MUL(half_angle_reach_1, half_angle_padded_1 / half_angle / y),
      half_angle_size_6 = fabs(half_angle_lo),
      half_angle_size_8 = KSL_MUL(2.567393169377981e+29, sqrt(half_angle_bound_1)
          + half_angle_size_6),
      half_angle_size_12 = half_angle
          + (KSL_MUL(4.0, half_angle_bound_1) < y ? half_angle_size_4 : half_angle_size_8);
  double c; const double fine_sine = ksl_sincos(half_angle, &c);
  double c_own_error_1; const double fine_sine_own_error_1 = ksl_sincos_error(half_angle, fine_sine,
      c, &c_own_error_1);
  const double fine_sine_half_1 = KSL_MUL(half_angle_lo, 0.5);
  double fine_sine_half_cos_1; const double fine_sine_half_sin_1 = ksl_sincos(fine_sine_half_1,
      &fine_sine_half_cos_1);
  const double fine_sine_twice_1 = fine_sine_half_sin_1 + fine_sine_half_sin_1,
      fine_sine_padded_1 = 1.8051943758648296e-276 + half_angle_size_12,
      fine_sine_size_1 = 1.0 + fine_sine_padded_1;
  const double c_lo = c_own_error_1
          - KSL_MUL(KSL_MUL(fine_sine_half_cos_1, fine_sine)
          + KSL_MUL(fine_sine_half_sin_1, c), fine_sine_twice_1);
  const double sinc_divisor = half_angle < 1.4901161193847656e-08 ? 1.4901161193847656e-08
          : half_angle, sinc_divisor_lo = half_angle < 1.4901161193847656e-08 ? 0.0 : half_angle_lo,
      sinc_divisor_bound_1 = half_angle_size_6 + KSL_MUL(4.240128211918887e-30, fine_sine_padded_1),
      sinc_divisor_size_3 = fabs(half_angle - 1.4901161193847656e-08),
      sinc_divisor_size_7 = sinc_divisor_bound_1 + fabs(1.4901161193847656e-08 - half_angle),
      sinc_divisor_size_9 = KSL_MUL(9.054644677292507e+28, sinc_divisor_bound_1
          < sinc_divisor_size_3 ? 0.0 : sinc_divisor_size_7);
  const double sinc_quotient = fine_sine / sinc_divisor,
      sinc_quotient_product_1 = KSL_MUL(sinc_quotient, sinc_divisor);
  const double fine_sine_lo = fine_sine_own_error_1
          + KSL_MUL(KSL_MUL(fine_sine_half_cos_1, c)
          - KSL_MUL(fine_sine_half_sin_1, fine_sine), fine_sine_twice_1);
  const double sinc_quotient_exact_1 = fine_sine - sinc_quotient_product_1
          - ksl_product_error(sinc_quotient, sinc_divisor, sinc_quotient_product_1),
      sinc_quotient_lo = (sinc_quotient_exact_1 + fine_sine_lo
          - KSL_MUL(sinc_quotient, sinc_divisor_lo)) / sinc_divisor,
      sinc_quotient_padded_1 = 1.8051943758648296e-276 + fine_sine_size_1;
  const double sinc_divisor_size_10 = (half_angle < 1.4901161193847656e-08 ? 1.4901161193847656e-08
          : half_angle_size_12) + sinc_divisor_size_9;
  const double sinc_quotient_padded_2 = 1.8051943758648296e-276 + sinc_divisor_size_10,
      sinc_quotient_size_1 = fabs(sinc_quotient), sinc_quotient_size_2 = fabs(sinc_divisor),
      sinc_quotient_bound_1 = fabs(sinc_divisor_lo)
          + KSL_MUL(1.1389183198259759e-29, sinc_quotient_padded_2),
      sinc_quotient_size_7 = KSL_MUL(4.0, sinc_quotient_bound_1) < sinc_quotient_size_2
          ? sinc_quotient_size_2 : 0.0,
      sinc_quotient_size_8 = (sinc_quotient_padded_1
          + KSL_MUL(sinc_quotient_padded_2, sinc_quotient_size_1)) / sinc_quotient_size_7,
      sinc_quotient_size_10 = KSL_MUL(sinc_quotient_size_2
          + KSL_MUL(140737488355328.0, sinc_quotient_bound_1), sinc_quotient_size_8)
          / sinc_quotient_size_2,
      sinc_quotient_size_11 = sinc_quotient_size_1 + sinc_quotient_size_10;
  const double sinc_a = KSL_MUL(0.16666666666666666, y), sinc_b = 1.0 - sinc_a,
      sinc_b_right_1 = 1.0 - sinc_b,
      sinc_b_lo1_1 = 1.0 - (sinc_b + sinc_b_right_1)
          - ksl_product_rest(0.16666666666666666, y, sinc_a, sinc_b_right_1),
      sinc_b_lo = sinc_b_lo1_1
          - (KSL_MUL(9.25185853854297e-18, y) + KSL_MUL(0.16666666666666666, y_lo)),
      sinc_b_size_1 = 1.0 + KSL_MUL(2290649224.7000003, y_size_1),
      sinc = half_angle < 1.4901161193847656e-08 ? sinc_b : sinc_quotient,
      sinc_lo = half_angle < 1.4901161193847656e-08 ? sinc_b_lo : sinc_quotient_lo,
      sinc_size_4 = fabs(sinc_b_lo)
          + KSL_MUL(8.120831909935717e-28, 1.8051943758648296e-276 + sinc_b_size_1)
          + fabs(sinc_b - sinc_quotient),
      sinc_size_5 = fabs(sinc_quotient_lo)
          + KSL_MUL(1.8842277118313698e-29, 1.8051943758648296e-276 + sinc_quotient_size_11)
          + sinc_size_4,
      sinc_size_7 = KSL_MUL(1.2325982855554354e+27, sinc_divisor_bound_1 < sinc_divisor_size_3
          ? 0.0 : sinc_size_5),
      sinc_size_8 = (half_angle < 1.4901161193847656e-08 ? sinc_b_size_1 : sinc_quotient_size_11)
          + sinc_size_7;
  const double series_phi_a = KSL_MUL(5.107725174524775e-32, y),
      series_phi_b = 4.116826490666969e-29 - series_phi_a,
      series_phi_b_right_1 = 4.116826490666969e-29 - series_phi_b,
      series_phi_b_right_rest_1 = ksl_product_rest(5.107725174524775e-32, y, series_phi_a,
          series_phi_b_right_1),
      series_phi_b_lo1_1 = 4.116826490666969e-29 - (series_phi_b + series_phi_b_right_1)
          - series_phi_b_right_rest_1,
      series_phi_b_lo = series_phi_b_lo1_1
          - (KSL_MUL(4.7410392187559056e-48, y) + KSL_MUL(5.107725174524775e-32, y_lo)) +
          -1.8714974010023092e-45, series_phi_c = KSL_MUL(y, series_phi_b),
      series_phi_c_padded_1 = 1.8051943758648296e-276
          + (4.116826490666969e-29 + KSL_MUL(6.843135825984986e-08, y_size_1)),
      series_phi_c_reach_1 = fabs(series_phi_b)
          + KSL_MUL(140737488355328.0, fabs(series_phi_b_lo)
          + KSL_MUL(8.120831909935717e-28, series_phi_c_padded_1)),
      series_phi_d = series_phi_c - 2.86531123750421e-26,
      series_phi_d_right_1 = series_phi_c - series_phi_d,
      series_phi_d_left_rest_1 = ksl_product_rest(y, series_phi_b, series_phi_c, series_phi_d
          + series_phi_d_right_1),
      series_phi_d_lo2_1 = series_phi_d_left_rest_1 - (2.86531123750421e-26 - series_phi_d_right_1)
          - 2.3296034284323186e-42,
      series_phi_d_lo = series_phi_d_lo2_1
          + (KSL_MUL(y_lo, series_phi_b) + KSL_MUL(y, series_phi_b_lo)),
      series_phi_e = KSL_MUL(y, series_phi_d),
      series_phi_d_size_1 = 2.86531123750421e-26
          + (KSL_MUL(half_angle_reach_1, series_phi_c_padded_1)
          + KSL_MUL(half_angle_padded_1, series_phi_c_reach_1)),
      series_phi_e_padded_1 = 1.8051943758648296e-276 + series_phi_d_size_1,
      series_phi_e_reach_1 = fabs(series_phi_d)
          + KSL_MUL(140737488355328.0, fabs(series_phi_d_lo)
          + KSL_MUL(8.17876581047362e-28, series_phi_e_padded_1)),
      series_phi_f = series_phi_e + 1.701994875077501e-23,
      series_phi_f_right_1 = series_phi_f - series_phi_e,
      series_phi_f_left_rest_1 = ksl_product_rest(y, series_phi_d, series_phi_e, series_phi_f
          - series_phi_f_right_1),
      series_phi_f_lo2_1 = series_phi_f_left_rest_1
          + (1.701994875077501e-23 - series_phi_f_right_1) + 3.161967936521494e-40,
      series_phi_f_lo = series_phi_f_lo2_1
          + (KSL_MUL(y_lo, series_phi_d) + KSL_MUL(y, series_phi_d_lo)),
      series_phi_e_size_4 = KSL_MUL(half_angle_reach_1, series_phi_e_padded_1)
          + KSL_MUL(half_angle_padded_1, series_phi_e_reach_1),
      series_phi_g = KSL_MUL(y, series_phi_f),
      series_phi_g_padded_1 = 1.8051943758648296e-276
          + (1.701994875077501e-23 + series_phi_e_size_4),
      series_phi_g_reach_1 = fabs(series_phi_f)
          + KSL_MUL(140737488355328.0, fabs(series_phi_f_lo)
          + KSL_MUL(8.238918382307457e-28, series_phi_g_padded_1)),
      series_phi_h = series_phi_g - 8.509974375387505e-21,
      series_phi_h_right_1 = series_phi_g - series_phi_h,
      series_phi_h_left_rest_1 = ksl_product_rest(y, series_phi_f, series_phi_g, series_phi_h
          + series_phi_h_right_1),
      series_phi_h_lo2_1 = series_phi_h_left_rest_1
          - (8.509974375387505e-21 - series_phi_h_right_1) - 3.2266760594119493e-37,
      series_phi_h_lo = series_phi_h_lo2_1
          + (KSL_MUL(y_lo, series_phi_f) + KSL_MUL(y, series_phi_f_lo)),
      series_phi_g_size_4 = KSL_MUL(half_angle_reach_1, series_phi_g_padded_1)
          + KSL_MUL(half_angle_padded_1, series_phi_g_reach_1),
      series_phi_i = KSL_MUL(y, series_phi_h),
      series_phi_i_padded_1 = 1.8051943758648296e-276
          + (8.509974375387505e-21 + series_phi_g_size_4),
      series_phi_i_reach_1 = fabs(series_phi_h)
          + KSL_MUL(140737488355328.0, fabs(series_phi_h_lo)
          + KSL_MUL(8.301289625437229e-28, series_phi_i_padded_1)),
      series_phi_j = series_phi_i + 3.523129391410427e-18,
      series_phi_j_right_1 = series_phi_j - series_phi_i,
      series_phi_j_left_rest_1 = ksl_product_rest(y, series_phi_h, series_phi_i, series_phi_j
          - series_phi_j_right_1),
      series_phi_j_lo2_1 = series_phi_j_left_rest_1
          + (3.523129391410427e-18 - series_phi_j_right_1) + -1.2521244741738012e-34,
      series_phi_j_lo = series_phi_j_lo2_1
          + (KSL_MUL(y_lo, series_phi_h) + KSL_MUL(y, series_phi_h_lo)),
      series_phi_i_size_4 = KSL_MUL(half_angle_reach_1, series_phi_i_padded_1)
          + KSL_MUL(half_angle_padded_1, series_phi_i_reach_1),
      series_phi_k = KSL_MUL(y, series_phi_j),
      series_phi_k_padded_1 = 1.8051943758648296e-276
          + (3.523129391410427e-18 + series_phi_i_size_4),
      series_phi_k_reach_1 = fabs(series_phi_j)
          + KSL_MUL(140737488355328.0, fabs(series_phi_j_lo)
          + KSL_MUL(8.36587954080333e-28, series_phi_k_padded_1)),
      series_phi_l = series_phi_k - 1.1837714755139035e-15,
      series_phi_l_right_1 = series_phi_k - series_phi_l,
      series_phi_l_left_rest_1 = ksl_product_rest(y, series_phi_j, series_phi_k, series_phi_l
          + series_phi_l_right_1),
      series_phi_l_lo2_1 = series_phi_l_left_rest_1
          - (1.1837714755139035e-15 - series_phi_l_right_1) - 7.23242424407352e-33,
      series_phi_l_lo = series_phi_l_lo2_1
          + (KSL_MUL(y_lo, series_phi_j) + KSL_MUL(y, series_phi_j_lo)),
      series_phi_k_size_4 = KSL_MUL(half_angle_reach_1, series_phi_k_padded_1)
          + KSL_MUL(half_angle_padded_1, series_phi_k_reach_1),
      series_phi_m = KSL_MUL(y, series_phi_l),
      series_phi_m_padded_1 = 1.8051943758648296e-276
          + (1.1837714755139035e-15 + series_phi_k_size_4),
      series_phi_m_reach_1 = fabs(series_phi_l)
          + KSL_MUL(140737488355328.0, fabs(series_phi_l_lo)
          + KSL_MUL(8.432688128405761e-28, series_phi_m_padded_1)),
      series_phi_n = series_phi_m + 3.148832124866983e-13,
      series_phi_n_right_1 = series_phi_n - series_phi_m,
      series_phi_n_left_rest_1 = ksl_product_rest(y, series_phi_l, series_phi_m, series_phi_n
          - series_phi_n_right_1),
      series_phi_n_lo2_1 = series_phi_n_left_rest_1
          + (3.148832124866983e-13 - series_phi_n_right_1) + 5.8681293750286156e-30,
      series_phi_n_lo = series_phi_n_lo2_1
          + (KSL_MUL(y_lo, series_phi_l) + KSL_MUL(y, series_phi_l_lo)),
      series_phi_m_size_4 = KSL_MUL(half_angle_reach_1, series_phi_m_padded_1)
          + KSL_MUL(half_angle_padded_1, series_phi_m_reach_1),
      series_phi_o = KSL_MUL(y, series_phi_n),
      series_phi_o_padded_1 = 1.8051943758648296e-276
          + (3.148832124866983e-13 + series_phi_m_size_4),
      series_phi_o_reach_1 = fabs(series_phi_n)
          + KSL_MUL(140737488355328.0, fabs(series_phi_n_lo)
          + KSL_MUL(8.501715387304126e-28, series_phi_o_padded_1)),
      series_phi_p = series_phi_o - 6.423617534728645e-11,
      series_phi_p_right_1 = series_phi_o - series_phi_p,
      series_phi_p_left_rest_1 = ksl_product_rest(y, series_phi_n, series_phi_o, series_phi_p
          + series_phi_p_right_1),
      series_phi_p_lo2_1 = series_phi_p_left_rest_1
          - (6.423617534728645e-11 - series_phi_p_right_1) - 5.034117835500839e-27,
      series_phi_p_lo = series_phi_p_lo2_1
          + (KSL_MUL(y_lo, series_phi_n) + KSL_MUL(y, series_phi_n_lo)),
      series_phi_o_size_4 = KSL_MUL(half_angle_reach_1, series_phi_o_padded_1)
          + KSL_MUL(half_angle_padded_1, series_phi_o_reach_1),
      series_phi_q = KSL_MUL(y, series_phi_p),
      series_phi_q_padded_1 = 1.8051943758648296e-276
          + (6.423617534728645e-11 + series_phi_o_size_4),
      series_phi_q_reach_1 = fabs(series_phi_p)
          + KSL_MUL(140737488355328.0, fabs(series_phi_p_lo)
          + KSL_MUL(8.572961317498427e-28, series_phi_q_padded_1)),
      series_phi_r = series_phi_q + 9.635426302092969e-09,
      series_phi_r_right_1 = series_phi_r - series_phi_q,
      series_phi_r_left_rest_1 = ksl_product_rest(y, series_phi_p, series_phi_q, series_phi_r
          - series_phi_r_right_1),
      series_phi_r_lo2_1 = series_phi_r_left_rest_1
          + (9.635426302092969e-09 - series_phi_r_right_1) + -1.7546051379703029e-25,
      series_phi_r_lo = series_phi_r_lo2_1
          + (KSL_MUL(y_lo, series_phi_p) + KSL_MUL(y, series_phi_p_lo)),
      series_phi_q_size_4 = KSL_MUL(half_angle_reach_1, series_phi_q_padded_1)
          + KSL_MUL(half_angle_padded_1, series_phi_q_reach_1),
      series_phi_s = KSL_MUL(y, series_phi_r),
      series_phi_s_padded_1 = 1.8051943758648296e-276
          + (9.635426302092969e-09 + series_phi_q_size_4),
      series_phi_s_reach_1 = fabs(series_phi_r)
          + KSL_MUL(140737488355328.0, fabs(series_phi_r_lo)
          + KSL_MUL(8.64642591898866e-28, series_phi_s_padded_1)),
      series_phi_t = series_phi_s - 1.0020843354176687e-06,
      series_phi_t_right_1 = series_phi_s - series_phi_t,
      series_phi_t_left_rest_1 = ksl_product_rest(y, series_phi_r, series_phi_s, series_phi_t
          + series_phi_t_right_1),
      series_phi_t_lo2_1 = series_phi_t_left_rest_1
          - (1.0020843354176687e-06 - series_phi_t_right_1) - 4.7926555569351065e-23,
      series_phi_t_lo = series_phi_t_lo2_1
          + (KSL_MUL(y_lo, series_phi_r) + KSL_MUL(y, series_phi_r_lo)),
      series_phi_s_size_4 = KSL_MUL(half_angle_reach_1, series_phi_s_padded_1)
          + KSL_MUL(half_angle_padded_1, series_phi_s_reach_1),
      series_phi_u = KSL_MUL(y, series_phi_t),
      series_phi_u_padded_1 = 1.8051943758648296e-276
          + (1.0020843354176687e-06 + series_phi_s_size_4),
      series_phi_u_reach_1 = fabs(series_phi_t)
          + KSL_MUL(140737488355328.0, fabs(series_phi_t_lo)
          + KSL_MUL(8.722109191774827e-28, series_phi_u_padded_1)),
      series_phi_v = series_phi_u + 6.613756613756614e-05,
      series_phi_v_right_1 = series_phi_v - series_phi_u,
      series_phi_v_left_rest_1 = ksl_product_rest(y, series_phi_t, series_phi_u, series_phi_v
          - series_phi_v_right_1),
      series_phi_v_lo2_1 = series_phi_v_left_rest_1
          + (6.613756613756614e-05 - series_phi_v_right_1) + -4.460143857711533e-21,
      series_phi_v_lo = series_phi_v_lo2_1
          + (KSL_MUL(y_lo, series_phi_t) + KSL_MUL(y, series_phi_t_lo)),
      series_phi_u_size_4 = KSL_MUL(half_angle_reach_1, series_phi_u_padded_1)
          + KSL_MUL(half_angle_padded_1, series_phi_u_reach_1),
      series_phi_w = KSL_MUL(y, series_phi_v),
      series_phi_w_padded_1 = 1.8051943758648296e-276
          + (6.613756613756614e-05 + series_phi_u_size_4),
      series_phi_w_reach_1 = fabs(series_phi_v)
          + KSL_MUL(140737488355328.0, fabs(series_phi_v_lo)
          + KSL_MUL(8.800011135856928e-28, series_phi_w_padded_1)),
      series_phi_x = series_phi_w - 0.002380952380952381,
      series_phi_x_right_1 = series_phi_w - series_phi_x,
      series_phi_x_left_rest_1 = ksl_product_rest(y, series_phi_v, series_phi_w, series_phi_x
          + series_phi_x_right_1),
      series_phi_x_lo2_1 = series_phi_x_left_rest_1 - (0.002380952380952381 - series_phi_x_right_1)
          - -2.147752875018904e-19,
      series_phi_x_lo = series_phi_x_lo2_1
          + (KSL_MUL(y_lo, series_phi_v) + KSL_MUL(y, series_phi_v_lo)),
      series_phi_y = KSL_MUL(y, series_phi_x),
      series_phi_x_size_1 = 0.002380952380952381
          + (KSL_MUL(half_angle_reach_1, series_phi_w_padded_1)
          + KSL_MUL(half_angle_padded_1, series_phi_w_reach_1)),
      series_phi_y_padded_1 = 1.8051943758648296e-276 + series_phi_x_size_1,
      series_phi_y_reach_1 = fabs(series_phi_x)
          + KSL_MUL(140737488355328.0, fabs(series_phi_x_lo)
          + KSL_MUL(8.880131751234963e-28, series_phi_y_padded_1)),
      series_phi = series_phi_y + 0.03333333333333333,
      series_phi_right_1 = series_phi - series_phi_y,
      series_phi_lo1_1 = ksl_product_rest(y, series_phi_x, series_phi_y, series_phi
          - series_phi_right_1) + (0.03333333333333333 - series_phi_right_1),
      series_phi_lo = series_phi_lo1_1 + 4.625929269271486e-19
          + (KSL_MUL(y_lo, series_phi_x) + KSL_MUL(y, series_phi_x_lo));
  const double f_more_a = KSL_MUL(2.0, y), f_more_a_cross2_1 = KSL_MUL(2.0, y_lo),
      f_more = KSL_MUL(f_more_a, series_phi),
      f_more_padded_1 = 1.8051943758648296e-276 + KSL_MUL(2.0, y_size_1);
  const double series_phi_size_1 = 0.03333333333333333
          + (KSL_MUL(half_angle_reach_1, series_phi_y_padded_1)
          + KSL_MUL(half_angle_padded_1, series_phi_y_reach_1));
  const double f_more_padded_2 = 1.8051943758648296e-276 + series_phi_size_1,
      f_more_reach_1 = fabs(f_more_a)
          + KSL_MUL(140737488355328.0, fabs(f_more_a_cross2_1)
          + KSL_MUL(2.8103175390871538e-30, f_more_padded_1)),
      f_more_reach_2 = fabs(series_phi)
          + KSL_MUL(140737488355328.0, fabs(series_phi_lo)
          + KSL_MUL(8.962471037908933e-28, f_more_padded_2));
  const double near_f_a = KSL_MUL(0.3333333333333333, sinc),
      near_f_b = KSL_MUL(0.3333333333333333, f_more),
      f_more_lo = ksl_product_error(f_more_a, series_phi, f_more)
          + (KSL_MUL(f_more_a_cross2_1, series_phi) + KSL_MUL(f_more_a, series_phi_lo)),
      near_f = near_f_a + near_f_b, near_f_right_1 = near_f - near_f_a,
      near_f_b_cross_1 = KSL_MUL(1.850371707708594e-17, f_more)
          + KSL_MUL(0.3333333333333333, f_more_lo),
      near_f_left_rest_1 = ksl_product_rest(0.3333333333333333, sinc, near_f_a, near_f
          - near_f_right_1),
      near_f_cross_1 = KSL_MUL(1.850371707708594e-17, sinc) + KSL_MUL(0.3333333333333333, sinc_lo)
          + near_f_b_cross_1,
      near_f_lo = near_f_left_rest_1
          + ksl_product_rest(0.3333333333333333, f_more, near_f_b, near_f_right_1) + near_f_cross_1,
      near_f_b_size_1 = KSL_MUL(0.3333333333333333, KSL_MUL(f_more_padded_2, f_more_reach_1)
          + KSL_MUL(f_more_padded_1, f_more_reach_2)),
      near_f_size_1 = KSL_MUL(0.3333333333333333, sinc_size_8) + near_f_b_size_1;
  const double f_rest = sinc - c, f_rest_right_1 = sinc - f_rest;
  const double fine_x = KSL_MUL(4.0, y);
  const double far_y = fine_x < 4.0 ? 1.0 : y, far_y_lo = fine_x < 4.0 ? 0.0 : y_lo,
      far_y_bound_1 = fabs(KSL_MUL(4.0, y_lo))
          + KSL_MUL(2.8103175390871538e-30, 1.8051943758648296e-276 + KSL_MUL(4.0, y_size_1)),
      far_y_size_3 = fabs(fine_x - 4.0), far_y_size_7 = fabs(1.0 - y) + half_angle_bound_1;
  const double closed_f = f_rest / far_y, closed_f_product_1 = KSL_MUL(closed_f, far_y),
      closed_f_exact_1 = f_rest - closed_f_product_1
          - ksl_product_error(closed_f, far_y, closed_f_product_1),
      closed_f_lo = (closed_f_exact_1
          + (sinc - (f_rest + f_rest_right_1) - (c - f_rest_right_1) - c_lo + sinc_lo)
          - KSL_MUL(closed_f, far_y_lo)) / far_y;
  const double far_y_size_10 = (fine_x < 4.0 ? 1.0 : y_size_1)
          + KSL_MUL(6.338251187752959e+28, far_y_bound_1 < far_y_size_3 ? 0.0 : far_y_size_7);
  const double closed_f_padded_2 = 1.8051943758648296e-276 + far_y_size_10,
      closed_f_size_1 = fabs(closed_f), closed_f_size_2 = fabs(far_y),
      closed_f_bound_1 = fabs(far_y_lo) + KSL_MUL(1.6270262376793602e-29, closed_f_padded_2),
      closed_f_size_4 = 1.8051943758648296e-276 + (fine_sine_size_1 + sinc_size_8)
          + KSL_MUL(closed_f_padded_2, closed_f_size_1),
      closed_f_size_8 = closed_f_size_4
          / (KSL_MUL(4.0, closed_f_bound_1) < closed_f_size_2 ? closed_f_size_2 : 0.0),
      closed_f_size_11 = closed_f_size_1
          + KSL_MUL(closed_f_size_2
          + KSL_MUL(140737488355328.0, closed_f_bound_1), closed_f_size_8) / closed_f_size_2;
  const double f = fine_x < 4.0 ? near_f : closed_f,
      f_size_4 = fabs(near_f_lo)
          + KSL_MUL(9.075379655148354e-28, 1.8051943758648296e-276 + near_f_size_1)
          + fabs(near_f - closed_f),
      f_size_5 = fabs(closed_f_lo)
          + KSL_MUL(8.245490617302283e-28, 1.8051943758648296e-276 + closed_f_size_11) + f_size_4;
  const double four_k = KSL_MUL(4.0, sinc), four_k_cross2_1 = KSL_MUL(4.0, sinc_lo);
  const double fine_b = f / four_k, fine_b_product_1 = KSL_MUL(fine_b, four_k),
      fine_b_numerator_1 = f - fine_b_product_1
          - ksl_product_error(fine_b, four_k, fine_b_product_1)
          + (fine_x < 4.0 ? near_f_lo : closed_f_lo),
      fine_b_lo = (fine_b_numerator_1 - KSL_MUL(fine_b, four_k_cross2_1)) / four_k;
  const double f_size_8 = (fine_x < 4.0 ? near_f_size_1 : closed_f_size_11)
          + KSL_MUL(1.1062092690083102e+27, far_y_bound_1 < far_y_size_3 ? 0.0 : f_size_5);
  const double fine_b_padded_2 = 1.8051943758648296e-276 + KSL_MUL(4.0, sinc_size_8),
      fine_b_size_1 = fabs(fine_b), fine_b_size_2 = fabs(four_k),
      fine_b_bound_1 = fabs(four_k_cross2_1) + KSL_MUL(8.125024661305438e-28, fine_b_padded_2),
      fine_b_size_4 = 1.8051943758648296e-276 + f_size_8 + KSL_MUL(fine_b_padded_2, fine_b_size_1),
      fine_b_size_8 = fine_b_size_4
          / (KSL_MUL(4.0, fine_b_bound_1) < fine_b_size_2 ? fine_b_size_2 : 0.0);
  const double fine_b_across = c / sinc, fine_b_across_product_1 = KSL_MUL(fine_b_across, sinc),
      fine_b_across_numerator_1 = c - fine_b_across_product_1
          - ksl_product_error(fine_b_across, sinc, fine_b_across_product_1) + c_lo,
      fine_b_across_lo = (fine_b_across_numerator_1 - KSL_MUL(fine_b_across, sinc_lo)) / sinc,
      fine_b_across_padded_1 = 1.8051943758648296e-276 + sinc_size_8,
      fine_b_across_size_1 = fabs(fine_b_across), fine_b_across_size_2 = fabs(sinc),
      fine_b_across_bound_1 = fabs(sinc_lo)
          + KSL_MUL(8.120832873841084e-28, fine_b_across_padded_1),
      fine_b_across_size_7 = KSL_MUL(4.0, fine_b_across_bound_1) < fine_b_across_size_2
          ? fine_b_across_size_2 : 0.0,
      fine_b_across_size_8 = (KSL_MUL(fine_b_across_padded_1, fine_b_across_size_1)
          + sinc_quotient_padded_1) / fine_b_across_size_7,
      fine_b_across_size_10 = KSL_MUL(fine_b_across_size_2
          + KSL_MUL(140737488355328.0, fine_b_across_bound_1), fine_b_across_size_8)
          / fine_b_across_size_2,
      fine_b_across_size_11 = fine_b_across_size_1 + fine_b_across_size_10;
  const double fine_beta_v_0 = KSL_MUL(v->x, fine_b);
  const double fine_b_size_11 = fine_b_size_1
          + KSL_MUL(fine_b_size_2 + KSL_MUL(140737488355328.0, fine_b_bound_1), fine_b_size_8)
          / fine_b_size_2;
  const double fine_beta_v_padded_1 = 1.8051943758648296e-276 + fine_b_size_11;
  const double fine_beta_v_1 = KSL_MUL(v->y, fine_b);
  const double fine_beta_v_2 = KSL_MUL(v->z, fine_b);
  const double fine_beta_v_lo_1 = ksl_product_error(v->x, fine_b, fine_beta_v_0)
          + KSL_MUL(v->x, fine_b_lo), fine_m_0 = KSL_MUL(v->x, fine_beta_v_0),
      fine_m_cross2_1 = KSL_MUL(v->x, fine_beta_v_lo_1),
      fine_m_padded_1 = 1.8051943758648296e-276 + KSL_MUL(fine_beta_v_padded_1, halved_size_1),
      fine_m_size_1 = KSL_MUL(fine_m_padded_1, halved_size_1);
  const double fine_beta_v_lo_2 = ksl_product_error(v->y, fine_b, fine_beta_v_1)
          + KSL_MUL(v->y, fine_b_lo), fine_m_1 = KSL_MUL(v->y, fine_beta_v_1),
      fine_m_cross2_2 = KSL_MUL(v->y, fine_beta_v_lo_2),
      fine_m_padded_2 = 1.8051943758648296e-276 + KSL_MUL(fine_beta_v_padded_1, halved_size_3),
      fine_m_size_2 = KSL_MUL(fine_m_padded_2, halved_size_3);
  const double fine_m_2 = KSL_MUL(v->z, fine_beta_v_2),
      fine_m_cross2_3 = KSL_MUL(v->z, ksl_product_error(v->z, fine_b, fine_beta_v_2)
          + KSL_MUL(v->z, fine_b_lo)),
      fine_m_size_3 = KSL_MUL(1.8051943758648296e-276
          + KSL_MUL(fine_beta_v_padded_1, halved_size_5), halved_size_5);
  const double fine_m_3 = KSL_MUL(v->y, fine_beta_v_0),
      fine_m_cross2_4 = KSL_MUL(v->y, fine_beta_v_lo_1);
  const double fine_m_4 = KSL_MUL(v->z, fine_beta_v_0),
      fine_m_cross2_5 = KSL_MUL(v->z, fine_beta_v_lo_1);
  const double fine_m_5 = KSL_MUL(v->z, fine_beta_v_1),
      fine_m_cross2_6 = KSL_MUL(v->z, fine_beta_v_lo_2);
  const double fine_others_0 = fine_m_1 + fine_m_2, fine_others_right_1 = fine_others_0 - fine_m_1,
      fine_others_left_rest_1 = ksl_product_rest(v->y, fine_beta_v_1, fine_m_1, fine_others_0
          - fine_others_right_1),
      fine_others_lo1_1 = fine_others_left_rest_1
          + ksl_product_rest(v->z, fine_beta_v_2, fine_m_2, fine_others_right_1),
      fine_others_lo_1 = fine_others_lo1_1 + (fine_m_cross2_2 + fine_m_cross2_3),
      fine_others_size_1 = fine_m_size_2 + fine_m_size_3;
  const double fine_others_1 = fine_m_0 + fine_m_2, fine_others_right_2 = fine_others_1 - fine_m_0,
      fine_others_left_rest_2 = ksl_product_rest(v->x, fine_beta_v_0, fine_m_0, fine_others_1
          - fine_others_right_2),
      fine_others_lo1_2 = fine_others_left_rest_2
          + ksl_product_rest(v->z, fine_beta_v_2, fine_m_2, fine_others_right_2),
      fine_others_lo_2 = fine_others_lo1_2 + (fine_m_cross2_1 + fine_m_cross2_3),
      fine_others_size_2 = fine_m_size_1 + fine_m_size_3;
  const double fine_others_2 = fine_m_0 + fine_m_1, fine_others_right_3 = fine_others_2 - fine_m_0,
      fine_others_left_rest_3 = ksl_product_rest(v->x, fine_beta_v_0, fine_m_0, fine_others_2
          - fine_others_right_3),
      fine_others_lo1_3 = fine_others_left_rest_3
          + ksl_product_rest(v->y, fine_beta_v_1, fine_m_1, fine_others_right_3),
      fine_others_lo_3 = fine_others_lo1_3 + (fine_m_cross2_1 + fine_m_cross2_2),
      fine_others_size_3 = fine_m_size_1 + fine_m_size_2;
  const double fine_diagonal0a = 1.0 - fine_others_0,
      fine_diagonal0a_right_1 = 1.0 - fine_diagonal0a,
      fine_diagonal0a_lo = 1.0 - (fine_diagonal0a + fine_diagonal0a_right_1)
          - (fine_others_0 - fine_diagonal0a_right_1) - fine_others_lo_1,
      fine_diagonal0a_size_1 = 1.0 + fine_others_size_1, fine_diagonal0b = fine_b_across + fine_m_0,
      fine_diagonal0b_right_1 = fine_diagonal0b - fine_b_across,
      fine_diagonal0b_right_rest_1 = ksl_product_rest(v->x, fine_beta_v_0, fine_m_0,
          fine_diagonal0b_right_1),
      fine_diagonal0b_lo = fine_b_across - (fine_diagonal0b - fine_diagonal0b_right_1)
          + fine_diagonal0b_right_rest_1 + fine_m_cross2_1 + fine_b_across_lo,
      fine_diagonal0b_size_1 = fine_b_across_size_11 + fine_m_size_1,
      fine_diagonal0_error_1 = fabs(ksl_product_error(v->x, fine_beta_v_0, fine_m_0)
          + fine_m_cross2_1),
      fine_diagonal0_bound_2 = fabs(fine_others_lo_1)
          + KSL_MUL(9.550468072637709e-28, 1.8051943758648296e-276 + fine_others_size_1),
      fine_diagonal0_bound_3 = fabs(fine_diagonal0b_lo)
          + KSL_MUL(9.550468072637709e-28, 1.8051943758648296e-276 + fine_diagonal0b_size_1),
      fine_diagonal0_bound_4 = fabs(fine_diagonal0a_lo)
          + KSL_MUL(9.58769341332938e-28, 1.8051943758648296e-276 + fine_diagonal0a_size_1),
      fine_diagonal0_size_9 = fine_diagonal0_bound_4
          + (fine_diagonal0_bound_3 + fabs(fine_diagonal0b - fine_diagonal0a)),
      fine_diagonal0_size_2 = fine_diagonal0_error_1
          + KSL_MUL(9.513982289044683e-28, 1.8051943758648296e-276 + fine_m_size_1)
          + fine_diagonal0_bound_2,
      fine_diagonal0_size_11 = KSL_MUL(1.0474204728201347e+27, fine_diagonal0_size_2
          < fabs(fine_m_0 - fine_others_0) ? 0.0 : fine_diagonal0_size_9);
  const double fine_diagonal1a = 1.0 - fine_others_1,
      fine_diagonal1a_right_1 = 1.0 - fine_diagonal1a,
      fine_diagonal1a_lo = 1.0 - (fine_diagonal1a + fine_diagonal1a_right_1)
          - (fine_others_1 - fine_diagonal1a_right_1) - fine_others_lo_2,
      fine_diagonal1a_size_1 = 1.0 + fine_others_size_2, fine_diagonal1b = fine_b_across + fine_m_1,
      fine_diagonal1b_right_1 = fine_diagonal1b - fine_b_across,
      fine_diagonal1b_right_rest_1 = ksl_product_rest(v->y, fine_beta_v_1, fine_m_1,
          fine_diagonal1b_right_1),
      fine_diagonal1b_lo = fine_b_across - (fine_diagonal1b - fine_diagonal1b_right_1)
          + fine_diagonal1b_right_rest_1 + fine_m_cross2_2 + fine_b_across_lo,
      fine_diagonal1b_size_1 = fine_b_across_size_11 + fine_m_size_2,
      fine_diagonal1_error_1 = fabs(ksl_product_error(v->y, fine_beta_v_1, fine_m_1)
          + fine_m_cross2_2),
      fine_diagonal1_bound_2 = fabs(fine_others_lo_2)
          + KSL_MUL(9.550468072637709e-28, 1.8051943758648296e-276 + fine_others_size_2),
      fine_diagonal1_bound_3 = fabs(fine_diagonal1b_lo)
          + KSL_MUL(9.550468072637709e-28, 1.8051943758648296e-276 + fine_diagonal1b_size_1),
      fine_diagonal1_bound_4 = fabs(fine_diagonal1a_lo)
          + KSL_MUL(9.58769341332938e-28, 1.8051943758648296e-276 + fine_diagonal1a_size_1),
      fine_diagonal1_size_9 = fine_diagonal1_bound_4
          + (fine_diagonal1_bound_3 + fabs(fine_diagonal1b - fine_diagonal1a)),
      fine_diagonal1_size_2 = fine_diagonal1_error_1
          + KSL_MUL(9.513982289044683e-28, 1.8051943758648296e-276 + fine_m_size_2)
          + fine_diagonal1_bound_2,
      fine_diagonal1_size_11 = KSL_MUL(1.0474204728201347e+27, fine_diagonal1_size_2
          < fabs(fine_m_1 - fine_others_1) ? 0.0 : fine_diagonal1_size_9);
  const double fine_diagonal2a = 1.0 - fine_others_2,
      fine_diagonal2a_right_1 = 1.0 - fine_diagonal2a,
      fine_diagonal2a_lo = 1.0 - (fine_diagonal2a + fine_diagonal2a_right_1)
          - (fine_others_2 - fine_diagonal2a_right_1) - fine_others_lo_3,
      fine_diagonal2a_size_1 = 1.0 + fine_others_size_3, fine_diagonal2b = fine_b_across + fine_m_2,
      fine_diagonal2b_right_1 = fine_diagonal2b - fine_b_across,
      fine_diagonal2b_right_rest_1 = ksl_product_rest(v->z, fine_beta_v_2, fine_m_2,
          fine_diagonal2b_right_1),
      fine_diagonal2b_lo = fine_b_across - (fine_diagonal2b - fine_diagonal2b_right_1)
          + fine_diagonal2b_right_rest_1 + fine_m_cross2_3 + fine_b_across_lo,
      fine_diagonal2b_size_1 = fine_b_across_size_11 + fine_m_size_3,
      fine_diagonal2_error_1 = fabs(ksl_product_error(v->z, fine_beta_v_2, fine_m_2)
          + fine_m_cross2_3),
      fine_diagonal2_bound_2 = fabs(fine_others_lo_3)
          + KSL_MUL(9.550468072637709e-28, 1.8051943758648296e-276 + fine_others_size_3),
      fine_diagonal2_bound_3 = fabs(fine_diagonal2b_lo)
          + KSL_MUL(9.550468072637709e-28, 1.8051943758648296e-276 + fine_diagonal2b_size_1),
      fine_diagonal2_bound_4 = fabs(fine_diagonal2a_lo)
          + KSL_MUL(9.58769341332938e-28, 1.8051943758648296e-276 + fine_diagonal2a_size_1),
      fine_diagonal2_size_9 = fine_diagonal2_bound_4
          + (fine_diagonal2_bound_3 + fabs(fine_diagonal2b - fine_diagonal2a)),
      fine_diagonal2_size_2 = fine_diagonal2_error_1
          + KSL_MUL(9.513982289044683e-28, 1.8051943758648296e-276 + fine_m_size_3)
          + fine_diagonal2_bound_2,
      fine_diagonal2_size_11 = KSL_MUL(1.0474204728201347e+27, fine_diagonal2_size_2
          < fabs(fine_m_2 - fine_others_2) ? 0.0 : fine_diagonal2_size_9);
  const double fine_R_01 = fine_m_3 - halved_2, fine_R_right_1 = fine_m_3 - fine_R_01;
  const double fine_R_02 = halved_1 + fine_m_4, fine_R_right_2 = fine_R_02 - halved_1;
  const double fine_R_10 = halved_2 + fine_m_3, fine_R_right_3 = fine_R_10 - halved_2;
  const double fine_R_12 = fine_m_5 - halved_0, fine_R_right_4 = fine_m_5 - fine_R_12;
  const double fine_R_20 = fine_m_4 - halved_1, fine_R_right_5 = fine_m_4 - fine_R_20;
  const double fine_R_21 = halved_0 + fine_m_5, fine_R_right_6 = fine_R_21 - halved_0;
  const double diagonal0_apart_1 = (fine_m_0 < fine_others_0 ? fine_diagonal0b : fine_diagonal0a)
          - diagonal0,
      diagonal0_padded_1 = 1.8051943758648296e-276
          + ((fine_m_0 < fine_others_0 ? fine_diagonal0b_size_1 : fine_diagonal0a_size_1)
          + fine_diagonal0_size_11),
      diagonal0_error_2 = KSL_MUL(1.0000000000000009, fabs(diagonal0_apart_1
          + (fine_m_0 < fine_others_0 ? fine_diagonal0b_lo : fine_diagonal0a_lo)));
  const double fine_R_lo_1 = ksl_product_rest(v->y, fine_beta_v_0, fine_m_3, fine_R_01
          + fine_R_right_1) - (halved_2 - fine_R_right_1) + fine_m_cross2_4;
  const double R_rest_1 = KSL_MUL(9.550468072637709e-28, 1.8051943758648296e-276
          + (KSL_MUL(fine_m_padded_1, halved_size_3) + halved_size_6));
  const double fine_R_lo_2 = halved_1 - (fine_R_02 - fine_R_right_2)
          + ksl_product_rest(v->z, fine_beta_v_0, fine_m_4, fine_R_right_2) + fine_m_cross2_5;
  const double R_rest_2 = KSL_MUL(9.550468072637709e-28, 1.8051943758648296e-276
          + (KSL_MUL(fine_m_padded_1, halved_size_5) + halved_size_4));
  const double fine_R_lo_3 = halved_2 - (fine_R_10 - fine_R_right_3)
          + ksl_product_rest(v->y, fine_beta_v_0, fine_m_3, fine_R_right_3) + fine_m_cross2_4;
  const double diagonal1_apart_1 = (fine_m_1 < fine_others_1 ? fine_diagonal1b : fine_diagonal1a)
          - diagonal1,
      diagonal1_padded_1 = 1.8051943758648296e-276
          + ((fine_m_1 < fine_others_1 ? fine_diagonal1b_size_1 : fine_diagonal1a_size_1)
          + fine_diagonal1_size_11),
      diagonal1_error_2 = KSL_MUL(1.0000000000000009, fabs(diagonal1_apart_1
          + (fine_m_1 < fine_others_1 ? fine_diagonal1b_lo : fine_diagonal1a_lo)));
  const double fine_R_lo_4 = ksl_product_rest(v->z, fine_beta_v_1, fine_m_5, fine_R_12
          + fine_R_right_4) - (halved_0 - fine_R_right_4) + fine_m_cross2_6;
  const double R_rest_3 = KSL_MUL(9.550468072637709e-28, 1.8051943758648296e-276
          + (KSL_MUL(fine_m_padded_2, halved_size_5) + halved_size_2));
  const double fine_R_lo_5 = ksl_product_rest(v->z, fine_beta_v_0, fine_m_4, fine_R_20
          + fine_R_right_5) - (halved_1 - fine_R_right_5) + fine_m_cross2_5;
  const double fine_R_lo_6 = halved_0 - (fine_R_21 - fine_R_right_6)
          + ksl_product_rest(v->z, fine_beta_v_1, fine_m_5, fine_R_right_6) + fine_m_cross2_6;
  const double diagonal2_apart_1 = (fine_m_2 < fine_others_2 ? fine_diagonal2b : fine_diagonal2a)
          - diagonal2,
      diagonal2_padded_1 = 1.8051943758648296e-276
          + ((fine_m_2 < fine_others_2 ? fine_diagonal2b_size_1 : fine_diagonal2a_size_1)
          + fine_diagonal2_size_11),
      diagonal2_error_2 = KSL_MUL(1.0000000000000009, fabs(diagonal2_apart_1
          + (fine_m_2 < fine_others_2 ? fine_diagonal2b_lo : fine_diagonal2a_lo))),
      diagonal0_bound_1 = diagonal0_error_2 + KSL_MUL(9.587694380055934e-28, diagonal0_padded_1),
      R_bound_1 = KSL_MUL(1.0000000000000009, fabs(fine_R_01 - R_01 + fine_R_lo_1)) + R_rest_1,
      R_bound_2 = KSL_MUL(1.0000000000000009, fabs(fine_R_02 - R_02 + fine_R_lo_2)) + R_rest_2,
      R_bound_3 = KSL_MUL(1.0000000000000009, fabs(fine_R_10 - R_10 + fine_R_lo_3)) + R_rest_1,
      diagonal1_bound_1 = diagonal1_error_2 + KSL_MUL(9.587694380055934e-28, diagonal1_padded_1),
      R_bound_4 = KSL_MUL(1.0000000000000009, fabs(fine_R_12 - R_12 + fine_R_lo_4)) + R_rest_3,
      R_bound_5 = KSL_MUL(1.0000000000000009, fabs(fine_R_20 - R_20 + fine_R_lo_5)) + R_rest_2,
      R_bound_6 = KSL_MUL(1.0000000000000009, fabs(fine_R_21 - R_21 + fine_R_lo_6)) + R_rest_3,
      diagonal2_bound_1 = diagonal2_error_2 + KSL_MUL(9.587694380055934e-28, diagonal2_padded_1);
  R->m00 = diagonal0;
  R->m01 = R_01;
  R->m02 = R_02;
  R->m10 = R_10;
  R->m11 = diagonal1;
  R->m12 = R_12;
  R->m20 = R_20;
  R->m21 = R_21;
  R->m22 = diagonal2;
  R_bound->m00 = diagonal0_bound_1;
  R_bound->m01 = R_bound_1;
  R_bound->m02 = R_bound_2;
  R_bound->m10 = R_bound_3;
  R_bound->m11 = diagonal1_bound_1;
  R_bound->m12 = R_bound_4;
  R_bound->m20 = R_bound_5;
  R_bound->m21 = R_bound_6;
  R_bound->m22 = diagonal2_bound_1;
}

/* self = R + R (I - R^T R)/2, closer to a rotation: a defect d of R becomes 3/4 d^2; |error of
     self| <= self_bound unless inf or NaN.
   self, self_bound: rotation or other 3×3 matrix.
   93 mul, 105 add, 3 neg, 27 abs. */
static inline void ksl_mat3x3_orthonormalize_certified(ksl_mat3x3_t *self,
    ksl_mat3x3_t *self_bound) {
  const double defect_0a = KSL_MUL(self->m00, self->m00), defect_0c = KSL_MUL(self->m10, self->m10),
      defect_0e = KSL_MUL(self->m20, self->m20), defect_0 = 1.0 - defect_0a - defect_0c - defect_0e;
  const double defect_1a = KSL_MUL(self->m01, self->m01), defect_1c = KSL_MUL(self->m11, self->m11),
      defect_1e = KSL_MUL(self->m21, self->m21), defect_1 = 1.0 - defect_1a - defect_1c - defect_1e;
  const double defect_2a = KSL_MUL(self->m02, self->m02), defect_2c = KSL_MUL(self->m12, self->m12),
      defect_2e = KSL_MUL(self->m22, self->m22), defect_2 = 1.0 - defect_2a - defect_2c - defect_2e;
  const double defect_3a = KSL_MUL(self->m00, self->m01), defect_3b = KSL_MUL(self->m10, self->m11),
      defect_3d = KSL_MUL(self->m20, self->m21), defect_3 = -(defect_3a + defect_3b + defect_3d);
  const double defect_4a = KSL_MUL(self->m00, self->m02), defect_4b = KSL_MUL(self->m10, self->m12),
      defect_4d = KSL_MUL(self->m20, self->m22), defect_4 = -(defect_4a + defect_4b + defect_4d);
  const double defect_5a = KSL_MUL(self->m01, self->m02), defect_5b = KSL_MUL(self->m11, self->m12),
      defect_5d = KSL_MUL(self->m21, self->m22), defect_5 = -(defect_5a + defect_5b + defect_5d);
  const double correction_0 = KSL_MUL(0.5, defect_0), correction_1 = KSL_MUL(0.5, defect_1),
      correction_2 = KSL_MUL(0.5, defect_2), correction_3 = KSL_MUL(0.5, defect_3),
      correction_4 = KSL_MUL(0.5, defect_4), correction_5 = KSL_MUL(0.5, defect_5);
  const double self_00_new = self->m00
          + (KSL_MUL(self->m00, correction_0) + KSL_MUL(self->m01, correction_3)
          + KSL_MUL(self->m02, correction_4));
  const double self_01_new = KSL_MUL(self->m00, correction_3) + KSL_MUL(self->m01, correction_1)
          + KSL_MUL(self->m02, correction_5) + self->m01;
  const double self_02_new = KSL_MUL(self->m00, correction_4) + KSL_MUL(self->m01, correction_5)
          + KSL_MUL(self->m02, correction_2) + self->m02;
  const double self_10_new = self->m10
          + (KSL_MUL(self->m10, correction_0) + KSL_MUL(self->m11, correction_3)
          + KSL_MUL(self->m12, correction_4)),
      self_11_new = KSL_MUL(self->m10, correction_3) + KSL_MUL(self->m11, correction_1)
          + KSL_MUL(self->m12, correction_5) + self->m11,
      self_12_new = KSL_MUL(self->m10, correction_4) + KSL_MUL(self->m11, correction_5)
          + KSL_MUL(self->m12, correction_2) + self->m12,
      self_20_new = self->m20
          + (KSL_MUL(self->m20, correction_0) + KSL_MUL(self->m21, correction_3)
          + KSL_MUL(self->m22, correction_4)),
      self_21_new = KSL_MUL(self->m20, correction_3) + KSL_MUL(self->m21, correction_1)
          + KSL_MUL(self->m22, correction_5) + self->m21,
      self_22_new = KSL_MUL(self->m20, correction_4) + KSL_MUL(self->m21, correction_5)
          + KSL_MUL(self->m22, correction_2) + self->m22;
  const double defect_0_size = 1.0 + fabs(defect_0a) + fabs(defect_0c) + fabs(defect_0e),
      defect_1_size = 1.0 + fabs(defect_1a) + fabs(defect_1c) + fabs(defect_1e),
      defect_2_size = 1.0 + fabs(defect_2a) + fabs(defect_2c) + fabs(defect_2e);
  const double correction_0_size = KSL_MUL(0.5, defect_0_size + 2.004168360008973e-292),
      correction_1_size = KSL_MUL(0.5, defect_1_size + 2.004168360008973e-292),
      correction_2_size = KSL_MUL(0.5, defect_2_size + 2.004168360008973e-292),
      correction_3_size = KSL_MUL(0.5, fabs(defect_3a) + fabs(defect_3b) + fabs(defect_3d)
          + 2.004168360008973e-292),
      correction_4_size = KSL_MUL(0.5, fabs(defect_4a) + fabs(defect_4b) + fabs(defect_4d)
          + 2.004168360008973e-292),
      correction_5_size = KSL_MUL(0.5, fabs(defect_5a) + fabs(defect_5b) + fabs(defect_5d)
          + 2.004168360008973e-292);
  const double correction_0_padded = correction_0_size + 2.004168360008973e-292;
  const double self_00_abs = fabs(self->m00);
  const double correction_3_padded = correction_3_size + 2.004168360008973e-292;
  const double self_01_abs = fabs(self->m01);
  const double correction_4_padded = correction_4_size + 2.004168360008973e-292;
  const double self_02_abs = fabs(self->m02),
      self_00_new_e_size = KSL_MUL(self_00_abs, correction_0_padded)
          + KSL_MUL(self_01_abs, correction_3_padded) + KSL_MUL(self_02_abs, correction_4_padded),
      self_00_new_size = self_00_abs + self_00_new_e_size;
  const double correction_1_padded = correction_1_size + 2.004168360008973e-292,
      correction_5_padded = correction_5_size + 2.004168360008973e-292;
  const double self_01_new_e_size = KSL_MUL(self_00_abs, correction_3_padded)
          + KSL_MUL(self_01_abs, correction_1_padded) + KSL_MUL(self_02_abs, correction_5_padded),
      self_01_new_size = self_01_new_e_size + self_01_abs;
  const double correction_2_padded = correction_2_size + 2.004168360008973e-292;
  const double self_02_new_e_size = KSL_MUL(self_00_abs, correction_4_padded)
          + KSL_MUL(self_01_abs, correction_5_padded) + KSL_MUL(self_02_abs, correction_2_padded),
      self_02_new_size = self_02_new_e_size + self_02_abs;
  const double self_10_abs = fabs(self->m10), self_11_abs = fabs(self->m11),
      self_12_abs = fabs(self->m12),
      self_10_new_e_size = KSL_MUL(self_10_abs, correction_0_padded)
          + KSL_MUL(self_11_abs, correction_3_padded) + KSL_MUL(self_12_abs, correction_4_padded),
      self_10_new_size = self_10_abs + self_10_new_e_size;
  const double self_11_new_e_size = KSL_MUL(self_10_abs, correction_3_padded)
          + KSL_MUL(self_11_abs, correction_1_padded) + KSL_MUL(self_12_abs, correction_5_padded),
      self_11_new_size = self_11_new_e_size + self_11_abs;
  const double self_12_new_e_size = KSL_MUL(self_10_abs, correction_4_padded)
          + KSL_MUL(self_11_abs, correction_5_padded) + KSL_MUL(self_12_abs, correction_2_padded),
      self_12_new_size = self_12_new_e_size + self_12_abs;
  const double self_20_abs = fabs(self->m20), self_21_abs = fabs(self->m21),
      self_22_abs = fabs(self->m22),
      self_20_new_e_size = KSL_MUL(self_20_abs, correction_0_padded)
          + KSL_MUL(self_21_abs, correction_3_padded) + KSL_MUL(self_22_abs, correction_4_padded),
      self_20_new_size = self_20_abs + self_20_new_e_size;
  const double self_21_new_e_size = KSL_MUL(self_20_abs, correction_3_padded)
          + KSL_MUL(self_21_abs, correction_1_padded) + KSL_MUL(self_22_abs, correction_5_padded),
      self_21_new_size = self_21_new_e_size + self_21_abs;
  const double self_22_new_e_size = KSL_MUL(self_20_abs, correction_4_padded)
          + KSL_MUL(self_21_abs, correction_5_padded) + KSL_MUL(self_22_abs, correction_2_padded),
      self_22_new_size = self_22_new_e_size + self_22_abs;
  const double self_00_new_bound = KSL_MUL(9.992007221626415e-16, self_00_new_size
          + 2.004168360008973e-292),
      self_01_new_bound = KSL_MUL(9.992007221626415e-16, self_01_new_size + 2.004168360008973e-292),
      self_02_new_bound = KSL_MUL(8.881784197001258e-16, self_02_new_size + 2.004168360008973e-292),
      self_10_new_bound = KSL_MUL(9.992007221626415e-16, self_10_new_size + 2.004168360008973e-292),
      self_11_new_bound = KSL_MUL(9.992007221626415e-16, self_11_new_size + 2.004168360008973e-292),
      self_12_new_bound = KSL_MUL(8.881784197001258e-16, self_12_new_size + 2.004168360008973e-292),
      self_20_new_bound = KSL_MUL(9.992007221626415e-16, self_20_new_size + 2.004168360008973e-292),
      self_21_new_bound = KSL_MUL(9.992007221626415e-16, self_21_new_size + 2.004168360008973e-292),
      self_22_new_bound = KSL_MUL(8.881784197001258e-16, self_22_new_size + 2.004168360008973e-292);
  self->m00 = self_00_new;
  self->m01 = self_01_new;
  self->m02 = self_02_new;
  self->m10 = self_10_new;
  self->m11 = self_11_new;
  self->m12 = self_12_new;
  self->m20 = self_20_new;
  self->m21 = self_21_new;
  self->m22 = self_22_new;
  self_bound->m00 = self_00_new_bound;
  self_bound->m01 = self_01_new_bound;
  self_bound->m02 = self_02_new_bound;
  self_bound->m10 = self_10_new_bound;
  self_bound->m11 = self_11_new_bound;
  self_bound->m12 = self_12_new_bound;
  self_bound->m20 = self_20_new_bound;
  self_bound->m21 = self_21_new_bound;
  self_bound->m22 = self_22_new_bound;
}

/* Ro = R + R (I - R^T R)/2, closer to a rotation: a defect d of R becomes 3/4 d^2; |error of Ro|
     <= Ro_bound unless inf or NaN.
   R, Ro, Ro_bound: rotation or other 3×3 matrix.
   93 mul, 105 add, 3 neg, 27 abs. */
static inline void ksl_mat3x3_orthonormalized_certified(const ksl_mat3x3_t *R, ksl_mat3x3_t *Ro,
    ksl_mat3x3_t *Ro_bound) {
  const double defect_0a = KSL_MUL(R->m00, R->m00), defect_0c = KSL_MUL(R->m10, R->m10),
      defect_0e = KSL_MUL(R->m20, R->m20), defect_0 = 1.0 - defect_0a - defect_0c - defect_0e;
  const double defect_1a = KSL_MUL(R->m01, R->m01), defect_1c = KSL_MUL(R->m11, R->m11),
      defect_1e = KSL_MUL(R->m21, R->m21), defect_1 = 1.0 - defect_1a - defect_1c - defect_1e;
  const double defect_2a = KSL_MUL(R->m02, R->m02), defect_2c = KSL_MUL(R->m12, R->m12),
      defect_2e = KSL_MUL(R->m22, R->m22), defect_2 = 1.0 - defect_2a - defect_2c - defect_2e;
  const double defect_3a = KSL_MUL(R->m00, R->m01), defect_3b = KSL_MUL(R->m10, R->m11),
      defect_3d = KSL_MUL(R->m20, R->m21), defect_3 = -(defect_3a + defect_3b + defect_3d);
  const double defect_4a = KSL_MUL(R->m00, R->m02), defect_4b = KSL_MUL(R->m10, R->m12),
      defect_4d = KSL_MUL(R->m20, R->m22), defect_4 = -(defect_4a + defect_4b + defect_4d);
  const double defect_5a = KSL_MUL(R->m01, R->m02), defect_5b = KSL_MUL(R->m11, R->m12),
      defect_5d = KSL_MUL(R->m21, R->m22), defect_5 = -(defect_5a + defect_5b + defect_5d);
  const double correction_0 = KSL_MUL(0.5, defect_0), correction_1 = KSL_MUL(0.5, defect_1),
      correction_2 = KSL_MUL(0.5, defect_2), correction_3 = KSL_MUL(0.5, defect_3),
      correction_4 = KSL_MUL(0.5, defect_4), correction_5 = KSL_MUL(0.5, defect_5);
  const double Ro_00 = R->m00
          + (KSL_MUL(R->m00, correction_0) + KSL_MUL(R->m01, correction_3)
          + KSL_MUL(R->m02, correction_4));
  const double Ro_01 = KSL_MUL(R->m00, correction_3) + KSL_MUL(R->m01, correction_1)
          + KSL_MUL(R->m02, correction_5) + R->m01;
  const double Ro_02 = KSL_MUL(R->m00, correction_4) + KSL_MUL(R->m01, correction_5)
          + KSL_MUL(R->m02, correction_2) + R->m02;
  const double Ro_10 = R->m10
          + (KSL_MUL(R->m10, correction_0) + KSL_MUL(R->m11, correction_3)
          + KSL_MUL(R->m12, correction_4)),
      Ro_11 = KSL_MUL(R->m10, correction_3) + KSL_MUL(R->m11, correction_1)
          + KSL_MUL(R->m12, correction_5) + R->m11,
      Ro_12 = KSL_MUL(R->m10, correction_4) + KSL_MUL(R->m11, correction_5)
          + KSL_MUL(R->m12, correction_2) + R->m12,
      Ro_20 = R->m20
          + (KSL_MUL(R->m20, correction_0) + KSL_MUL(R->m21, correction_3)
          + KSL_MUL(R->m22, correction_4)),
      Ro_21 = KSL_MUL(R->m20, correction_3) + KSL_MUL(R->m21, correction_1)
          + KSL_MUL(R->m22, correction_5) + R->m21,
      Ro_22 = KSL_MUL(R->m20, correction_4) + KSL_MUL(R->m21, correction_5)
          + KSL_MUL(R->m22, correction_2) + R->m22;
  const double defect_0_size = 1.0 + fabs(defect_0a) + fabs(defect_0c) + fabs(defect_0e),
      defect_1_size = 1.0 + fabs(defect_1a) + fabs(defect_1c) + fabs(defect_1e),
      defect_2_size = 1.0 + fabs(defect_2a) + fabs(defect_2c) + fabs(defect_2e);
  const double correction_0_size = KSL_MUL(0.5, defect_0_size + 2.004168360008973e-292),
      correction_1_size = KSL_MUL(0.5, defect_1_size + 2.004168360008973e-292),
      correction_2_size = KSL_MUL(0.5, defect_2_size + 2.004168360008973e-292),
      correction_3_size = KSL_MUL(0.5, fabs(defect_3a) + fabs(defect_3b) + fabs(defect_3d)
          + 2.004168360008973e-292),
      correction_4_size = KSL_MUL(0.5, fabs(defect_4a) + fabs(defect_4b) + fabs(defect_4d)
          + 2.004168360008973e-292),
      correction_5_size = KSL_MUL(0.5, fabs(defect_5a) + fabs(defect_5b) + fabs(defect_5d)
          + 2.004168360008973e-292);
  const double correction_0_padded = correction_0_size + 2.004168360008973e-292;
  const double R_00_abs = fabs(R->m00);
  const double correction_3_padded = correction_3_size + 2.004168360008973e-292;
  const double R_01_abs = fabs(R->m01);
  const double correction_4_padded = correction_4_size + 2.004168360008973e-292;
  const double R_02_abs = fabs(R->m02),
      Ro_00_size = R_00_abs
          + (KSL_MUL(R_00_abs, correction_0_padded) + KSL_MUL(R_01_abs, correction_3_padded)
          + KSL_MUL(R_02_abs, correction_4_padded));
  const double correction_1_padded = correction_1_size + 2.004168360008973e-292,
      correction_5_padded = correction_5_size + 2.004168360008973e-292;
  const double Ro_01_size = KSL_MUL(R_00_abs, correction_3_padded)
          + KSL_MUL(R_01_abs, correction_1_padded) + KSL_MUL(R_02_abs, correction_5_padded)
          + R_01_abs;
  const double correction_2_padded = correction_2_size + 2.004168360008973e-292;
  const double Ro_02_size = KSL_MUL(R_00_abs, correction_4_padded)
          + KSL_MUL(R_01_abs, correction_5_padded) + KSL_MUL(R_02_abs, correction_2_padded)
          + R_02_abs;
  const double R_10_abs = fabs(R->m10), R_11_abs = fabs(R->m11), R_12_abs = fabs(R->m12),
      Ro_10_size = R_10_abs
          + (KSL_MUL(R_10_abs, correction_0_padded) + KSL_MUL(R_11_abs, correction_3_padded)
          + KSL_MUL(R_12_abs, correction_4_padded));
  const double Ro_11_size = KSL_MUL(R_10_abs, correction_3_padded)
          + KSL_MUL(R_11_abs, correction_1_padded) + KSL_MUL(R_12_abs, correction_5_padded)
          + R_11_abs,
      Ro_12_size = KSL_MUL(R_10_abs, correction_4_padded) + KSL_MUL(R_11_abs, correction_5_padded)
          + KSL_MUL(R_12_abs, correction_2_padded) + R_12_abs;
  const double R_20_abs = fabs(R->m20), R_21_abs = fabs(R->m21), R_22_abs = fabs(R->m22),
      Ro_20_size = R_20_abs
          + (KSL_MUL(R_20_abs, correction_0_padded) + KSL_MUL(R_21_abs, correction_3_padded)
          + KSL_MUL(R_22_abs, correction_4_padded));
  const double Ro_21_size = KSL_MUL(R_20_abs, correction_3_padded)
          + KSL_MUL(R_21_abs, correction_1_padded) + KSL_MUL(R_22_abs, correction_5_padded)
          + R_21_abs,
      Ro_22_size = KSL_MUL(R_20_abs, correction_4_padded) + KSL_MUL(R_21_abs, correction_5_padded)
          + KSL_MUL(R_22_abs, correction_2_padded) + R_22_abs;
  const double Ro_00_bound = KSL_MUL(9.992007221626415e-16, Ro_00_size + 2.004168360008973e-292),
      Ro_01_bound = KSL_MUL(9.992007221626415e-16, Ro_01_size + 2.004168360008973e-292),
      Ro_02_bound = KSL_MUL(8.881784197001258e-16, Ro_02_size + 2.004168360008973e-292),
      Ro_10_bound = KSL_MUL(9.992007221626415e-16, Ro_10_size + 2.004168360008973e-292),
      Ro_11_bound = KSL_MUL(9.992007221626415e-16, Ro_11_size + 2.004168360008973e-292),
      Ro_12_bound = KSL_MUL(8.881784197001258e-16, Ro_12_size + 2.004168360008973e-292),
      Ro_20_bound = KSL_MUL(9.992007221626415e-16, Ro_20_size + 2.004168360008973e-292),
      Ro_21_bound = KSL_MUL(9.992007221626415e-16, Ro_21_size + 2.004168360008973e-292),
      Ro_22_bound = KSL_MUL(8.881784197001258e-16, Ro_22_size + 2.004168360008973e-292);
  Ro->m00 = Ro_00;
  Ro->m01 = Ro_01;
  Ro->m02 = Ro_02;
  Ro->m10 = Ro_10;
  Ro->m11 = Ro_11;
  Ro->m12 = Ro_12;
  Ro->m20 = Ro_20;
  Ro->m21 = Ro_21;
  Ro->m22 = Ro_22;
  Ro_bound->m00 = Ro_00_bound;
  Ro_bound->m01 = Ro_01_bound;
  Ro_bound->m02 = Ro_02_bound;
  Ro_bound->m10 = Ro_10_bound;
  Ro_bound->m11 = Ro_11_bound;
  Ro_bound->m12 = Ro_12_bound;
  Ro_bound->m20 = Ro_20_bound;
  Ro_bound->m21 = Ro_21_bound;
  Ro_bound->m22 = Ro_22_bound;
}

/* D = exp s = [exp ω~ | J_l(ω) v]; |error of D| <= D_bound unless inf or NaN.
   s: screw (v in m/s; ω in rad/s); D, D_bound: displacement [R | t], R rotation, t in m.
   524 mul, 876 add, 24 product error, 58 product rest, 16 div, 3 sqrt, 102 abs, 20 less, 1
     equal, 46 select. */
static inline void ksl_SE3_exp_certified(const ksl_screw_t *s, ksl_SE3_t *D, ksl_SE3_t *D_bound) {
  const double size_0 = fabs(s->m3), size_1 = fabs(s->m4), size_2 = fabs(s->m5);
  const double sizes = size_0 + size_1 + size_2;
  const double grid = KSL_MUL(sizes, 268435456.0);
  const double shifted_0 = s->m3 + grid, shifted_1 = s->m4 + grid, shifted_2 = s->m5 + grid;
  const double high_0 = shifted_0 - grid, high_1 = shifted_1 - grid, high_2 = shifted_2 - grid;
  const double low_0 = s->m3 - high_0, low_1 = s->m4 - high_1, low_2 = s->m5 - high_2;
  const double sum_0 = s->m3 + high_0, sum_1 = s->m4 + high_1, sum_2 = s->m5 + high_2;
  const double squares = KSL_MUL(high_0, high_0) + KSL_MUL(high_1, high_1)
          + KSL_MUL(high_2, high_2);
  const double cross = KSL_MUL(low_0, sum_0) + KSL_MUL(low_1, sum_1) + KSL_MUL(low_2, sum_2);
  const double x = squares + cross;
  const double theta_a = sqrt(x), theta = x < 1.0 ? 1.0 : theta_a;
  const double theta_shifted = grid + theta;
  const double theta_high = theta_shifted - grid;
  const double theta_low = theta - theta_high;
  const double theta_sum = theta + theta_high;
  const double cross_rest = cross - KSL_MUL(theta_low, theta_sum);
  const double exact = squares - KSL_MUL(theta_high, theta_high);
  const double residual = cross_rest + exact;
  const double small = KSL_MUL(0.5, residual) / theta;
  const double delta = fabs(small) < 0.0078125 ? small : 0.0;
  double far_cosine_a; const double far_sine_a = ksl_sincos(theta, &far_cosine_a);
  const double far_sine = x < 1.0 ? 1.0 : far_sine_a;
  const double far_cosine = x < 1.0 ? 0.0 : far_cosine_a;
  const double sine = KSL_MUL(delta, far_cosine) + far_sine;
  const double cosine = far_cosine - KSL_MUL(delta, far_sine);
  const double far_x = x < 1.0 ? 1.0 : x;
  const double middle_x = x < 4.0 ? 4.0 : x;
  const double closed1 = sine / theta;
  const double versine = 1.0 - cosine;
  const double closed2 = versine / far_x;
  const double rest3 = 1.0 - closed1;
  const double closed3 = rest3 / middle_x;
  const double g1g = KSL_MUL(x, KSL_MUL(x, KSL_MUL(x, KSL_MUL(6.446950284384474e-26, x)
          - 3.868170170630684e-23) + 1.9572941063391263e-20) - 8.22063524662433e-18),
      g1n = KSL_MUL(x, KSL_MUL(x, KSL_MUL(x, g1g + 2.8114572543455206e-15) - 7.647163731819816e-13)
          + 1.6059043836821613e-10) - 2.505210838544172e-08,
      g1u = KSL_MUL(x, KSL_MUL(x, KSL_MUL(x, KSL_MUL(x, g1n) + 2.7557319223985893e-06)
          - 0.0001984126984126984) + 0.008333333333333333),
      g1x = KSL_MUL(x, g1u - 0.16666666666666666) + 1.0, g1 = x < 1.0 ? g1x : closed1;
  const double g2g = KSL_MUL(x, KSL_MUL(x, KSL_MUL(x, KSL_MUL(2.4795962632247976e-27, x)
          - 1.6117375710961184e-24) + 8.896791392450574e-22) - 4.110317623312165e-19),
      g2n = KSL_MUL(x, KSL_MUL(x, KSL_MUL(x, g2g + 1.5619206968586225e-16) - 4.779477332387385e-14)
          + 1.1470745597729725e-11) - 2.08767569878681e-09,
      g2v = KSL_MUL(x, KSL_MUL(x, KSL_MUL(x, KSL_MUL(x, g2n) + 2.755731922398589e-07)
          - 2.48015873015873e-05) + 0.001388888888888889) - 0.041666666666666664,
      g2x = KSL_MUL(x, g2v) + 0.5, g2 = x < 1.0 ? g2x : closed2;
  const double g3g = KSL_MUL(x, KSL_MUL(x, KSL_MUL(x, KSL_MUL(9.183689863795546e-29, x)
          - 6.446950284384474e-26) + 3.868170170630684e-23) - 1.9572941063391263e-20),
      g3n = KSL_MUL(x, KSL_MUL(x, KSL_MUL(x, g3g + 8.22063524662433e-18) - 2.8114572543455206e-15)
          + 7.647163731819816e-13) - 1.6059043836821613e-10,
      g3u = KSL_MUL(x, KSL_MUL(x, KSL_MUL(x, KSL_MUL(x, g3n) + 2.505210838544172e-08)
          - 2.7557319223985893e-06) + 0.0001984126984126984),
      g3x = KSL_MUL(x, g3u - 0.008333333333333333) + 0.16666666666666666,
      g3 = x < 4.0 ? g3x : closed3;
  const double g0b = 1.0 - KSL_MUL(x, g2), g0 = x < 1.0 ? g0b : cosine;
  const double u_0 = KSL_MUL(s->m2, s->m4) - KSL_MUL(s->m1, s->m5);
  const double u_1 = KSL_MUL(s->m0, s->m5) - KSL_MUL(s->m2, s->m3);
  const double u_2 = KSL_MUL(s->m1, s->m3) - KSL_MUL(s->m0, s->m4);
  const double turned_0 = KSL_MUL(g2, u_0);
  const double turned_1 = KSL_MUL(g2, u_1);
  const double turned_2 = KSL_MUL(g2, u_2);
  const double wv = KSL_MUL(s->m0, s->m3) + KSL_MUL(s->m1, s->m4) + KSL_MUL(s->m2, s->m5);
  const double pitch = KSL_MUL(g3, wv);
  const double along_0 = KSL_MUL(s->m3, pitch);
  const double along_1 = KSL_MUL(s->m4, pitch);
  const double along_2 = KSL_MUL(s->m5, pitch);
  const double beta_v_0 = KSL_MUL(s->m3, g2);
  const double beta_v_1 = KSL_MUL(s->m4, g2);
  const double beta_v_2 = KSL_MUL(s->m5, g2);
  const double m_0 = KSL_MUL(s->m3, beta_v_0);
  const double m_1 = KSL_MUL(s->m4, beta_v_1);
  const double m_2 = KSL_MUL(s->m5, beta_v_2);
  const double m_3 = KSL_MUL(s->m4, beta_v_0);
  const double m_4 = KSL_MUL(s->m5, beta_v_0);
  const double m_5 = KSL_MUL(s->m5, beta_v_1);
  const double others_0 = m_1 + m_2;
  const double others_1 = m_0 + m_2;
  const double others_2 = m_0 + m_1;
  const double diagonal0a = 1.0 - others_0, diagonal0b = g0 + m_0,
      diagonal0 = m_0 < others_0 ? diagonal0b : diagonal0a;
  const double diagonal1a = 1.0 - others_1, diagonal1b = g0 + m_1,
      diagonal1 = m_1 < others_1 ? diagonal1b : diagonal1a;
  const double diagonal2a = 1.0 - others_2, diagonal2b = g0 + m_2,
      diagonal2 = m_2 < others_2 ? diagonal2b : diagonal2a;
  const double alpha_v_0 = KSL_MUL(s->m3, g1);
  const double alpha_v_1 = KSL_MUL(s->m4, g1);
  const double alpha_v_2 = KSL_MUL(s->m5, g1);
  const double across_axis_0 = turned_0 + along_0;
  const double across_axis_1 = turned_1 + along_1;
  const double across_axis_2 = turned_2 + along_2;
  const double D_01 = m_3 - alpha_v_2;
  const double D_02 = m_4 + alpha_v_1;
  const double D_03 = KSL_MUL(s->m0, g1) + across_axis_0;
  const double D_10 = m_3 + alpha_v_2;
  const double D_12 = m_5 - alpha_v_0;
  const double D_13 = KSL_MUL(s->m1, g1) + across_axis_1;
  const double D_20 = m_4 - alpha_v_1;
  const double D_21 = m_5 + alpha_v_0;
  const double D_23 = KSL_MUL(s->m2, g1) + across_axis_2;
  const double halved_0 = KSL_MUL(0.5, s->m3), halved_size_1 = fabs(s->m3);
  const double halved_1 = KSL_MUL(0.5, s->m4), halved_size_3 = fabs(s->m4);
  const double halved_2 = KSL_MUL(0.5, s->m5), halved_size_5 = fabs(s->m5);
  const double y_a = KSL_MUL(halved_0, halved_0),
      y_a_padded_1 = 1.8051943758648296e-276 + KSL_MUL(0.5, halved_size_1),
      y_b = KSL_MUL(halved_1, halved_1),
      y_b_padded_1 = 1.8051943758648296e-276 + KSL_MUL(0.5, halved_size_3), y_c = y_a + y_b,
      y_c_right_1 = y_c - y_a, y_d = KSL_MUL(halved_2, halved_2),
      y_d_padded_1 = 1.8051943758648296e-276 + KSL_MUL(0.5, halved_size_5), y = y_c + y_d,
      y_right_1 = y - y_c,
      y_c_lo = ksl_product_rest(halved_0, halved_0, y_a, y_c - y_c_right_1)
          + ksl_product_rest(halved_1, halved_1, y_b, y_c_right_1),
      y_lo = y_c - (y - y_right_1) + ksl_product_rest(halved_2, halved_2, y_d, y_right_1) + y_c_lo,
      y_size_1 = KSL_MUL(y_a_padded_1, y_a_padded_1) + KSL_MUL(y_b_padded_1, y_b_padded_1)
          + KSL_MUL(y_d_padded_1, y_d_padded_1);
  const double half_angle = sqrt(y), half_angle_product_1 = KSL_MUL(half_angle, half_angle),
      half_angle_twice_1 = half_angle + half_angle,
      half_angle_residual_1 = y - half_angle_product_1
          - ksl_product_error(half_angle, half_angle, half_angle_product_1) + y_lo,
      half_angle_lo = half_angle_residual_1 / (half_angle == 0.0 ? 1.0 : half_angle_twice_1),
      half_angle_padded_1 = 1.8051943758648296e-276 + y_size_1,
      half_angle_bound_1 = fabs(y_lo) + KSL_MUL(2.5021685128863245e-30, half_angle_padded_1),
      half_angle_size_4 = KSL_MUL(fabs(y)
          + KSL_MUL(140737488355328.0, half_angle_bound_1), half_angle_padded_1 / half_angle / y),
      half_angle_size_6 = fabs(half_angle_lo),
      half_angle_size_8 = KSL_MUL(2.567393169377981e+29, sqrt(half_angle_bound_1)
          + half_angle_size_6),
      half_angle_size_12 = half_angle
          + (KSL_MUL(4.0, half_angle_bound_1) < y ? half_angle_size_4 : half_angle_size_8);
  double c; const double fine_sine = ksl_sincos(half_angle, &c);
  double c_own_error_1; const double fine_sine_own_error_1 = ksl_sincos_error(half_angle, fine_sine,
      c, &c_own_error_1);
  const double fine_sine_half_1 = KSL_MUL(half_angle_lo, 0.5);
  double fine_sine_half_cos_1; const double fine_sine_half_sin_1 = ksl_sincos(fine_sine_half_1,
      &fine_sine_half_cos_1);
  const double fine_sine_twice_1 = fine_sine_half_sin_1 + fine_sine_half_sin_1,
      fine_sine_lo = fine_sine_own_error_1
          + KSL_MUL(KSL_MUL(fine_sine_half_cos_1, c)
          - KSL_MUL(fine_sine_half_sin_1, fine_sine), fine_sine_twice_1),
      fine_sine_padded_1 = 1.8051943758648296e-276 + half_angle_size_12,
      fine_sine_size_1 = 1.0 + fine_sine_padded_1;
  const double c_lo = c_own_error_1
          - KSL_MUL(KSL_MUL(fine_sine_half_cos_1, fine_sine)
          + KSL_MUL(fine_sine_half_sin_1, c), fine_sine_twice_1);
  const double sinc_divisor = half_angle < 1.4901161193847656e-08 ? 1.4901161193847656e-08
          : half_angle, sinc_divisor_lo = half_angle < 1.4901161193847656e-08 ? 0.0 : half_angle_lo,
      sinc_divisor_bound_1 = half_angle_size_6 + KSL_MUL(4.240128211918887e-30, fine_sine_padded_1),
      sinc_divisor_size_3 = fabs(half_angle - 1.4901161193847656e-08),
      sinc_divisor_size_7 = sinc_divisor_bound_1 + fabs(1.4901161193847656e-08 - half_angle),
      sinc_divisor_size_9 = KSL_MUL(9.054644677292507e+28, sinc_divisor_bound_1
          < sinc_divisor_size_3 ? 0.0 : sinc_divisor_size_7);
  const double sinc_quotient = fine_sine / sinc_divisor,
      sinc_quotient_product_1 = KSL_MUL(sinc_quotient, sinc_divisor),
      sinc_quotient_exact_1 = fine_sine - sinc_quotient_product_1
          - ksl_product_error(sinc_quotient, sinc_divisor, sinc_quotient_product_1),
      sinc_quotient_lo = (sinc_quotient_exact_1 + fine_sine_lo
          - KSL_MUL(sinc_quotient, sinc_divisor_lo)) / sinc_divisor;
  const double sinc_divisor_size_10 = (half_angle < 1.4901161193847656e-08 ? 1.4901161193847656e-08
          : half_angle_size_12) + sinc_divisor_size_9;
  const double sinc_quotient_padded_2 = 1.8051943758648296e-276 + sinc_divisor_size_10,
      sinc_quotient_size_1 = fabs(sinc_quotient), sinc_quotient_size_2 = fabs(sinc_divisor),
      sinc_quotient_bound_1 = fabs(sinc_divisor_lo)
          + KSL_MUL(1.1389183198259759e-29, sinc_quotient_padded_2),
      sinc_quotient_size_4 = 1.8051943758648296e-276 + fine_sine_size_1
          + KSL_MUL(sinc_quotient_padded_2, sinc_quotient_size_1),
      sinc_quotient_size_8 = sinc_quotient_size_4
          / (KSL_MUL(4.0, sinc_quotient_bound_1) < sinc_quotient_size_2 ? sinc_quotient_size_2
          : 0.0),
      sinc_quotient_size_10 = KSL_MUL(sinc_quotient_size_2
          + KSL_MUL(140737488355328.0, sinc_quotient_bound_1), sinc_quotient_size_8)
          / sinc_quotient_size_2,
      sinc_quotient_size_11 = sinc_quotient_size_1 + sinc_quotient_size_10;
  const double sinc_a = KSL_MUL(0.16666666666666666, y), sinc_b = 1.0 - sinc_a,
      sinc_b_right_1 = 1.0 - sinc_b,
      sinc_b_lo1_1 = 1.0 - (sinc_b + sinc_b_right_1)
          - ksl_product_rest(0.16666666666666666, y, sinc_a, sinc_b_right_1),
      sinc_b_lo = sinc_b_lo1_1
          - (KSL_MUL(9.25185853854297e-18, y) + KSL_MUL(0.16666666666666666, y_lo)),
      sinc_b_size_1 = 1.0 + KSL_MUL(2290649224.7000003, y_size_1),
      sinc = half_angle < 1.4901161193847656e-08 ? sinc_b : sinc_quotient,
      sinc_lo = half_angle < 1.4901161193847656e-08 ? sinc_b_lo : sinc_quotient_lo,
      sinc_size_4 = fabs(sinc_b_lo)
          + KSL_MUL(8.120831909935717e-28, 1.8051943758648296e-276 + sinc_b_size_1)
          + fabs(sinc_b - sinc_quotient),
      sinc_size_5 = fabs(sinc_quotient_lo)
          + KSL_MUL(1.8842277118313698e-29, 1.8051943758648296e-276 + sinc_quotient_size_11)
          + sinc_size_4,
      sinc_size_7 = KSL_MUL(1.2325982855554354e+27, sinc_divisor_bound_1 < sinc_divisor_size_3
          ? 0.0 : sinc_size_5);
  const double fine_g1 = KSL_MUL(c, sinc),
      fine_g1_cross_1 = KSL_MUL(c_lo, sinc) + KSL_MUL(c, sinc_lo),
      fine_g1_padded_1 = 1.8051943758648296e-276
          + ((half_angle < 1.4901161193847656e-08 ? sinc_b_size_1 : sinc_quotient_size_11)
          + sinc_size_7), fine_g1_rest_1 = KSL_MUL(8.677471603123253e-30, fine_sine_size_1),
      fine_g1_reach_2 = fabs(sinc)
          + KSL_MUL(140737488355328.0, fabs(sinc_lo)
          + KSL_MUL(8.120832873841084e-28, fine_g1_padded_1)),
      fine_g1_size_2 = KSL_MUL(fine_g1_padded_1, fabs(c)
          + KSL_MUL(140737488355328.0, fabs(c_lo) + fine_g1_rest_1)),
      fine_g1_size_5 = fine_g1_size_2 + KSL_MUL(fine_g1_reach_2, fine_sine_size_1);
  const double fine_g2a = KSL_MUL(sinc, sinc),
      fine_g2a_size_1 = KSL_MUL(fine_g1_padded_1, fine_g1_reach_2),
      fine_g2 = KSL_MUL(0.5, fine_g2a),
      fine_g2_cross2_1 = KSL_MUL(0.5, ksl_product_error(sinc, sinc, fine_g2a)
          + (KSL_MUL(sinc_lo, sinc) + KSL_MUL(sinc, sinc_lo)));
  const double sine_square = KSL_MUL(fine_sine, fine_sine),
      sine_square_size_2 = KSL_MUL(fine_sine_size_1, fabs(fine_sine)
          + KSL_MUL(140737488355328.0, fine_g1_rest_1 + fabs(fine_sine_lo)));
  const double fine_g0a = KSL_MUL(2.0, sine_square),
      sine_square_lo = ksl_product_error(fine_sine, fine_sine, sine_square)
          + (KSL_MUL(fine_sine_lo, fine_sine) + KSL_MUL(fine_sine, fine_sine_lo)),
      fine_g0 = 1.0 - fine_g0a, fine_g0_right_1 = 1.0 - fine_g0,
      fine_g0_lo = 1.0 - (fine_g0 + fine_g0_right_1) - (fine_g0a - fine_g0_right_1)
          - KSL_MUL(2.0, sine_square_lo),
      fine_g0_size_1 = 1.0 + KSL_MUL(2.0, sine_square_size_2 + sine_square_size_2);
  const double fine_rest3 = 1.0 - fine_g1, fine_rest3_right_1 = 1.0 - fine_rest3;
  const double fine_x = KSL_MUL(4.0, y), fine_x_cross2_1 = KSL_MUL(4.0, y_lo),
      fine_x_size_1 = KSL_MUL(4.0, y_size_1);
  const double fine_far_x = fine_x < 1.0 ? 1.0 : fine_x,
      fine_far_x_lo = fine_x < 1.0 ? 0.0 : fine_x_cross2_1,
      fine_far_x_padded_1 = 1.8051943758648296e-276 + fine_x_size_1,
      fine_far_x_bound_1 = fabs(fine_x_cross2_1)
          + KSL_MUL(2.8103175390871538e-30, fine_far_x_padded_1),
      fine_far_x_size_3 = fabs(fine_x - 1.0),
      fine_far_x_size_7 = fine_far_x_bound_1 + fabs(1.0 - fine_x),
      fine_far_x_size_9 = KSL_MUL(5.28187582188787e+28, fine_far_x_bound_1 < fine_far_x_size_3
          ? 0.0 : fine_far_x_size_7);
  const double fine_closed3 = fine_rest3 / fine_far_x,
      fine_closed3_product_1 = KSL_MUL(fine_closed3, fine_far_x);
  const double fine_rest3_lo = 1.0 - (fine_rest3 + fine_rest3_right_1)
          - ksl_product_rest(c, sinc, fine_g1, fine_rest3_right_1) - fine_g1_cross_1;
  const double fine_closed3_numerator_1 = fine_rest3 - fine_closed3_product_1
          - ksl_product_error(fine_closed3, fine_far_x, fine_closed3_product_1) + fine_rest3_lo,
      fine_closed3_lo = (fine_closed3_numerator_1 - KSL_MUL(fine_closed3, fine_far_x_lo))
          / fine_far_x,
      fine_closed3_padded_2 = 1.8051943758648296e-276
          + ((fine_x < 1.0 ? 1.0 : fine_x_size_1) + fine_far_x_size_9),
      fine_closed3_size_1 = fabs(fine_closed3), fine_closed3_size_2 = fabs(fine_far_x),
      fine_closed3_bound_1 = fabs(fine_far_x_lo)
          + KSL_MUL(1.9524315162482833e-29, fine_closed3_padded_2),
      fine_closed3_size_4 = 1.8051943758648296e-276 + (1.0 + fine_g1_size_5)
          + KSL_MUL(fine_closed3_padded_2, fine_closed3_size_1),
      fine_closed3_size_8 = fine_closed3_size_4
          / (KSL_MUL(4.0, fine_closed3_bound_1) < fine_closed3_size_2 ? fine_closed3_size_2 : 0.0),
      fine_closed3_size_10 = KSL_MUL(fine_closed3_size_2
          + KSL_MUL(140737488355328.0, fine_closed3_bound_1), fine_closed3_size_8)
          / fine_closed3_size_2, fine_closed3_size_11 = fine_closed3_size_1 + fine_closed3_size_10;
  const double series5a = KSL_MUL(1.216125041553518e-34, fine_x),
      series5b = 1.1309962886447716e-31 - series5a,
      series5b_right_1 = 1.1309962886447716e-31 - series5b,
      series5b_lo1_1 = 1.1309962886447716e-31 - (series5b + series5b_right_1)
          - ksl_product_rest(1.216125041553518e-34, fine_x, series5a, series5b_right_1),
      series5b_lo = series5b_lo1_1
          - (KSL_MUL(5.586290567888806e-51, fine_x)
          + KSL_MUL(1.216125041553518e-34, fine_x_cross2_1)) + 1.0498015412959506e-47,
      series5c = KSL_MUL(fine_x, series5b),
      series5c_padded_1 = 1.8051943758648296e-276
          + (1.1309962886447716e-31 + KSL_MUL(5.702613188320821e-10, fine_x_size_1)),
      series5c_reach_1 = fabs(fine_x) + KSL_MUL(140737488355328.0, fine_far_x_bound_1),
      series5c_reach_2 = fabs(series5b)
          + KSL_MUL(140737488355328.0, fabs(series5b_lo)
          + KSL_MUL(8.12514599395154e-28, series5c_padded_1)),
      series5d = series5c - 9.183689863795546e-29, series5d_right_1 = series5c - series5d,
      series5d_lo1_1 = ksl_product_rest(fine_x, series5b, series5c, series5d + series5d_right_1)
          - (9.183689863795546e-29 - series5d_right_1),
      series5d_lo = series5d_lo1_1 - 1.4303150396787322e-45
          + (KSL_MUL(fine_x_cross2_1, series5b) + KSL_MUL(fine_x, series5b_lo)),
      series5e = KSL_MUL(fine_x, series5d),
      series5d_size_1 = 9.183689863795546e-29
          + (KSL_MUL(series5c_padded_1, series5c_reach_1)
          + KSL_MUL(fine_far_x_padded_1, series5c_reach_2)),
      series5e_padded_1 = 1.8051943758648296e-276 + series5d_size_1,
      series5e_reach_1 = fabs(series5d)
          + KSL_MUL(140737488355328.0, fabs(series5d_lo)
          + KSL_MUL(8.19207783918962e-28, series5e_padded_1)),
      series5f = series5e + 6.446950284384474e-26, series5f_right_1 = series5f - series5e,
      series5f_lo1_1 = ksl_product_rest(fine_x, series5d, series5e, series5f - series5f_right_1)
          + (6.446950284384474e-26 - series5f_right_1),
      series5f_lo = series5f_lo1_1 + -1.9330404233703465e-42
          + (KSL_MUL(fine_x_cross2_1, series5d) + KSL_MUL(fine_x, series5d_lo)),
      series5g = KSL_MUL(fine_x, series5f),
      series5f_size_1 = 6.446950284384474e-26
          + (KSL_MUL(series5c_reach_1, series5e_padded_1)
          + KSL_MUL(fine_far_x_padded_1, series5e_reach_1)),
      series5g_padded_1 = 1.8051943758648296e-276 + series5f_size_1,
      series5g_reach_1 = fabs(series5f)
          + KSL_MUL(140737488355328.0, fabs(series5f_lo)
          + KSL_MUL(8.261228355723635e-28, series5g_padded_1)),
      series5h = series5g - 3.868170170630684e-23, series5h_right_1 = series5g - series5h,
      series5h_lo1_1 = ksl_product_rest(fine_x, series5f, series5g, series5h + series5h_right_1)
          - (3.868170170630684e-23 - series5h_right_1),
      series5h_lo = series5h_lo1_1 - -8.843177655482344e-40
          + (KSL_MUL(fine_x_cross2_1, series5f) + KSL_MUL(fine_x, series5f_lo)),
      series5i = KSL_MUL(fine_x, series5h),
      series5h_size_1 = 3.868170170630684e-23
          + (KSL_MUL(series5c_reach_1, series5g_padded_1)
          + KSL_MUL(fine_far_x_padded_1, series5g_reach_1)),
      series5i_padded_1 = 1.8051943758648296e-276 + series5h_size_1,
      series5i_reach_1 = fabs(series5h)
          + KSL_MUL(140737488355328.0, fabs(series5h_lo)
          + KSL_MUL(8.332597543553583e-28, series5i_padded_1)),
      series5j = series5i + 1.9572941063391263e-20, series5j_right_1 = series5j - series5i,
      series5j_lo1_1 = ksl_product_rest(fine_x, series5h, series5i, series5j - series5j_right_1)
          + (1.9572941063391263e-20 - series5j_right_1),
      series5j_lo = series5j_lo1_1 + -1.3643503830087908e-36
          + (KSL_MUL(fine_x_cross2_1, series5h) + KSL_MUL(fine_x, series5h_lo)),
      series5k = KSL_MUL(fine_x, series5j),
      series5j_size_1 = 1.9572941063391263e-20
          + (KSL_MUL(series5c_reach_1, series5i_padded_1)
          + KSL_MUL(fine_far_x_padded_1, series5i_reach_1)),
      series5k_padded_1 = 1.8051943758648296e-276 + series5j_size_1,
      series5k_reach_1 = fabs(series5j)
          + KSL_MUL(140737488355328.0, fabs(series5j_lo)
          + KSL_MUL(8.406185404560257e-28, series5k_padded_1)),
      series5l = series5k - 8.22063524662433e-18, series5l_right_1 = series5k - series5l,
      series5l_lo1_1 = ksl_product_rest(fine_x, series5j, series5k, series5l + series5l_right_1)
          - (8.22063524662433e-18 - series5l_right_1),
      series5l_lo = series5l_lo1_1 - 2.2141894119604265e-34
          + (KSL_MUL(fine_x_cross2_1, series5j) + KSL_MUL(fine_x, series5j_lo)),
      series5m = KSL_MUL(fine_x, series5l),
      series5l_size_1 = 8.22063524662433e-18
          + (KSL_MUL(series5c_reach_1, series5k_padded_1)
          + KSL_MUL(fine_far_x_padded_1, series5k_reach_1)),
      series5m_padded_1 = 1.8051943758648296e-276 + series5l_size_1,
      series5m_reach_1 = fabs(series5l)
          + KSL_MUL(140737488355328.0, fabs(series5l_lo)
          + KSL_MUL(8.481991936862865e-28, series5m_padded_1)),
      series5n = series5m + 2.8114572543455206e-15, series5n_right_1 = series5n - series5m,
      series5n_lo1_1 = ksl_product_rest(fine_x, series5l, series5m, series5n - series5n_right_1)
          + (2.8114572543455206e-15 - series5n_right_1),
      series5n_lo = series5n_lo1_1 + 1.6508842730861433e-31
          + (KSL_MUL(fine_x_cross2_1, series5l) + KSL_MUL(fine_x, series5l_lo)),
      series5o = KSL_MUL(fine_x, series5n),
      series5n_size_1 = 2.8114572543455206e-15
          + (KSL_MUL(series5c_reach_1, series5m_padded_1)
          + KSL_MUL(fine_far_x_padded_1, series5m_reach_1)),
      series5o_padded_1 = 1.8051943758648296e-276 + series5n_size_1,
      series5o_reach_1 = fabs(series5n)
          + KSL_MUL(140737488355328.0, fabs(series5n_lo)
          + KSL_MUL(8.560017140461409e-28, series5o_padded_1)),
      series5p = series5o - 7.647163731819816e-13, series5p_right_1 = series5o - series5p,
      series5p_lo1_1 = ksl_product_rest(fine_x, series5n, series5o, series5p + series5p_right_1)
          - (7.647163731819816e-13 - series5p_right_1),
      series5p_lo = series5p_lo1_1 - 7.03872877733453e-30
          + (KSL_MUL(fine_x_cross2_1, series5n) + KSL_MUL(fine_x, series5n_lo)),
      series5q = KSL_MUL(fine_x, series5p),
      series5p_size_1 = 7.647163731819816e-13
          + (KSL_MUL(series5c_reach_1, series5o_padded_1)
          + KSL_MUL(fine_far_x_padded_1, series5o_reach_1)),
      series5q_padded_1 = 1.8051943758648296e-276 + series5p_size_1,
      series5q_reach_1 = fabs(series5p)
          + KSL_MUL(140737488355328.0, fabs(series5p_lo)
          + KSL_MUL(8.640261015355885e-28, series5q_padded_1)),
      series5r = series5q + 1.6059043836821613e-10, series5r_right_1 = series5r - series5q,
      series5r_lo1_1 = ksl_product_rest(fine_x, series5p, series5q, series5r - series5r_right_1)
          + (1.6059043836821613e-10 - series5r_right_1),
      series5r_lo = series5r_lo1_1 + 1.2585294588752098e-26
          + (KSL_MUL(fine_x_cross2_1, series5p) + KSL_MUL(fine_x, series5p_lo)),
      series5s = KSL_MUL(fine_x, series5r),
      series5r_size_1 = 1.6059043836821613e-10
          + (KSL_MUL(series5c_reach_1, series5q_padded_1)
          + KSL_MUL(fine_far_x_padded_1, series5q_reach_1)),
      series5s_padded_1 = 1.8051943758648296e-276 + series5r_size_1,
      series5s_reach_1 = fabs(series5r)
          + KSL_MUL(140737488355328.0, fabs(series5r_lo)
          + KSL_MUL(8.722723561546295e-28, series5s_padded_1)),
      series5t = series5s - 2.505210838544172e-08, series5t_right_1 = series5s - series5t,
      series5t_lo1_1 = ksl_product_rest(fine_x, series5r, series5s, series5t + series5t_right_1)
          - (2.505210838544172e-08 - series5t_right_1),
      series5t_lo = series5t_lo1_1 - -1.448814070935912e-24
          + (KSL_MUL(fine_x_cross2_1, series5r) + KSL_MUL(fine_x, series5r_lo)),
      series5u = KSL_MUL(fine_x, series5t),
      series5t_size_1 = 2.505210838544172e-08
          + (KSL_MUL(series5c_reach_1, series5s_padded_1)
          + KSL_MUL(fine_far_x_padded_1, series5s_reach_1)),
      series5u_padded_1 = 1.8051943758648296e-276 + series5t_size_1,
      series5u_reach_1 = fabs(series5t)
          + KSL_MUL(140737488355328.0, fabs(series5t_lo)
          + KSL_MUL(8.80740477903264e-28, series5u_padded_1)),
      series5v = series5u + 2.7557319223985893e-06, series5v_right_1 = series5v - series5u,
      series5v_lo1_1 = ksl_product_rest(fine_x, series5t, series5u, series5v - series5v_right_1)
          + (2.7557319223985893e-06 - series5v_right_1),
      series5v_lo = series5v_lo1_1 + -1.858393274046472e-22
          + (KSL_MUL(fine_x_cross2_1, series5t) + KSL_MUL(fine_x, series5t_lo)),
      series5w = KSL_MUL(fine_x, series5v),
      series5v_size_1 = 2.7557319223985893e-06
          + (KSL_MUL(series5c_reach_1, series5u_padded_1)
          + KSL_MUL(fine_far_x_padded_1, series5u_reach_1)),
      series5w_padded_1 = 1.8051943758648296e-276 + series5v_size_1,
      series5w_reach_1 = fabs(series5v)
          + KSL_MUL(140737488355328.0, fabs(series5v_lo)
          + KSL_MUL(8.894304667814918e-28, series5w_padded_1)),
      series5x = series5w - 0.0001984126984126984, series5x_right_1 = series5w - series5x,
      series5x_lo1_1 = ksl_product_rest(fine_x, series5v, series5w, series5x + series5x_right_1)
          - (0.0001984126984126984 - series5x_right_1),
      series5x_lo = series5x_lo1_1 - 1.7209558293420705e-22
          + (KSL_MUL(fine_x_cross2_1, series5v) + KSL_MUL(fine_x, series5v_lo)),
      series5y = KSL_MUL(fine_x, series5x),
      series5x_size_1 = 0.0001984126984126984
          + (KSL_MUL(series5c_reach_1, series5w_padded_1)
          + KSL_MUL(fine_far_x_padded_1, series5w_reach_1)),
      series5y_padded_1 = 1.8051943758648296e-276 + series5x_size_1,
      series5y_reach_1 = fabs(series5x)
          + KSL_MUL(140737488355328.0, fabs(series5x_lo)
          + KSL_MUL(8.98342322789313e-28, series5y_padded_1)),
      series5 = series5y + 0.008333333333333333, series5_right_1 = series5 - series5y,
      series5_lo1_1 = ksl_product_rest(fine_x, series5x, series5y, series5 - series5_right_1)
          + (0.008333333333333333 - series5_right_1),
      series5_lo = series5_lo1_1 + 1.1564823173178714e-19
          + (KSL_MUL(fine_x_cross2_1, series5x) + KSL_MUL(fine_x, series5x_lo));
  const double fine_g3a = KSL_MUL(fine_x, series5);
  const double series5_size_1 = 0.008333333333333333
          + (KSL_MUL(series5c_reach_1, series5y_padded_1)
          + KSL_MUL(fine_far_x_padded_1, series5y_reach_1));
  const double fine_g3a_padded_1 = 1.8051943758648296e-276 + series5_size_1,
      fine_g3a_reach_1 = fabs(series5)
          + KSL_MUL(140737488355328.0, fabs(series5_lo)
          + KSL_MUL(9.07476046114807e-28, fine_g3a_padded_1)),
      fine_g3b = 0.16666666666666666 - fine_g3a, fine_g3b_right_1 = 0.16666666666666666 - fine_g3b,
      fine_g3b_lo1_1 = 0.16666666666666666 - (fine_g3b + fine_g3b_right_1)
          - ksl_product_rest(fine_x, series5, fine_g3a, fine_g3b_right_1),
      fine_g3b_lo = fine_g3b_lo1_1
          - (KSL_MUL(fine_x_cross2_1, series5) + KSL_MUL(fine_x, series5_lo))
          + 9.25185853854297e-18,
      fine_g3b_size_1 = 0.16666666666666666
          + (KSL_MUL(fine_g3a_padded_1, series5c_reach_1)
          + KSL_MUL(fine_far_x_padded_1, fine_g3a_reach_1)),
      fine_g3 = fine_x < 1.0 ? fine_g3b : fine_closed3,
      fine_g3_lo = fine_x < 1.0 ? fine_g3b_lo : fine_closed3_lo,
      fine_g3_size_4 = fabs(fine_g3b_lo)
          + KSL_MUL(9.168316367579732e-28, 1.8051943758648296e-276 + fine_g3b_size_1)
          + fabs(fine_g3b - fine_closed3),
      fine_g3_size_5 = fabs(fine_closed3_lo)
          + KSL_MUL(8.304820816109472e-28, 1.8051943758648296e-276 + fine_closed3_size_11)
          + fine_g3_size_4,
      fine_g3_size_7 = KSL_MUL(1.0948341329470242e+27, fine_far_x_bound_1 < fine_far_x_size_3 ? 0.0
          : fine_g3_size_5);
  const double fine_u_0a = KSL_MUL(s->m2, s->m4), fine_u_0a_size_1 = fabs(s->m2),
      fine_u_0b = KSL_MUL(s->m1, s->m5), fine_u_0b_size_1 = fabs(s->m1),
      fine_u_0 = fine_u_0a - fine_u_0b, fine_u_right_1 = fine_u_0a - fine_u_0;
  const double fine_u_1a = KSL_MUL(s->m0, s->m5), fine_u_1a_size_1 = fabs(s->m0),
      fine_u_1b = KSL_MUL(s->m2, s->m3), fine_u_1 = fine_u_1a - fine_u_1b,
      fine_u_right_2 = fine_u_1a - fine_u_1;
  const double fine_u_2a = KSL_MUL(s->m1, s->m3), fine_u_2b = KSL_MUL(s->m0, s->m4),
      fine_u_2 = fine_u_2a - fine_u_2b, fine_u_right_3 = fine_u_2a - fine_u_2;
  const double fine_turned_0 = KSL_MUL(fine_g2, fine_u_0);
  const double fine_u_lo_1 = ksl_product_rest(s->m2, s->m4, fine_u_0a, fine_u_0 + fine_u_right_1)
          - ksl_product_rest(s->m1, s->m5, fine_u_0b, fine_u_right_1);
  const double fine_turned_padded_1 = 1.8051943758648296e-276
          + KSL_MUL(0.5, fine_g2a_size_1 + fine_g2a_size_1),
      fine_turned_padded_2 = 1.8051943758648296e-276
          + (KSL_MUL(fine_u_0a_size_1, halved_size_3) + KSL_MUL(fine_u_0b_size_1, halved_size_5));
  const double fine_turned_1 = KSL_MUL(fine_g2, fine_u_1);
  const double fine_u_lo_2 = ksl_product_rest(s->m0, s->m5, fine_u_1a, fine_u_1 + fine_u_right_2)
          - ksl_product_rest(s->m2, s->m3, fine_u_1b, fine_u_right_2);
  const double fine_turned_padded_3 = 1.8051943758648296e-276
          + (KSL_MUL(fine_u_1a_size_1, halved_size_5) + KSL_MUL(fine_u_0a_size_1, halved_size_1));
  const double fine_turned_2 = KSL_MUL(fine_g2, fine_u_2);
  const double fine_u_lo_3 = ksl_product_rest(s->m1, s->m3, fine_u_2a, fine_u_2 + fine_u_right_3)
          - ksl_product_rest(s->m0, s->m4, fine_u_2b, fine_u_right_3);
  const double fine_turned_padded_4 = 1.8051943758648296e-276
          + (KSL_MUL(fine_u_0b_size_1, halved_size_1) + KSL_MUL(fine_u_1a_size_1, halved_size_3));
  const double fine_wv_a = KSL_MUL(s->m0, s->m3), fine_wv_b = KSL_MUL(s->m1, s->m4),
      fine_wv_c = fine_wv_a + fine_wv_b, fine_wv_c_right_1 = fine_wv_c - fine_wv_a,
      fine_wv_d = KSL_MUL(s->m2, s->m5), fine_wv = fine_wv_c + fine_wv_d,
      fine_wv_right_1 = fine_wv - fine_wv_c,
      fine_wv_c_lo = ksl_product_rest(s->m0, s->m3, fine_wv_a, fine_wv_c - fine_wv_c_right_1)
          + ksl_product_rest(s->m1, s->m4, fine_wv_b, fine_wv_c_right_1),
      fine_wv_lo = fine_wv_c - (fine_wv - fine_wv_right_1)
          + ksl_product_rest(s->m2, s->m5, fine_wv_d, fine_wv_right_1) + fine_wv_c_lo;
  const double fine_pitch = KSL_MUL(fine_g3, fine_wv),
      fine_pitch_padded_1 = 1.8051943758648296e-276
          + ((fine_x < 1.0 ? fine_g3b_size_1 : fine_closed3_size_11) + fine_g3_size_7);
  const double fine_wv_size_1 = KSL_MUL(fine_u_1a_size_1, halved_size_1)
          + KSL_MUL(fine_u_0b_size_1, halved_size_3) + KSL_MUL(fine_u_0a_size_1, halved_size_5);
  const double fine_pitch_padded_2 = 1.8051943758648296e-276 + fine_wv_size_1,
      fine_pitch_reach_1 = fabs(fine_g3)
          + KSL_MUL(140737488355328.0, fabs(fine_g3_lo)
          + KSL_MUL(9.168317334306286e-28, fine_pitch_padded_1)),
      fine_pitch_reach_2 = fabs(fine_wv)
          + KSL_MUL(140737488355328.0, fabs(fine_wv_lo)
          + KSL_MUL(1.8735448849987806e-30, fine_pitch_padded_2));
  const double fine_pitch_lo = ksl_product_error(fine_g3, fine_wv, fine_pitch)
          + (KSL_MUL(fine_g3_lo, fine_wv) + KSL_MUL(fine_g3, fine_wv_lo)),
      fine_along_0 = KSL_MUL(s->m3, fine_pitch),
      fine_along_padded_1 = 1.8051943758648296e-276
          + (KSL_MUL(fine_pitch_padded_2, fine_pitch_reach_1)
          + KSL_MUL(fine_pitch_padded_1, fine_pitch_reach_2));
  const double fine_along_1 = KSL_MUL(s->m4, fine_pitch);
  const double fine_along_2 = KSL_MUL(s->m5, fine_pitch);
  const double fine_beta_v_0 = KSL_MUL(s->m3, fine_g2);
  const double fine_beta_v_1 = KSL_MUL(s->m4, fine_g2);
  const double fine_beta_v_2 = KSL_MUL(s->m5, fine_g2);
  const double fine_beta_v_lo_1 = ksl_product_error(s->m3, fine_g2, fine_beta_v_0)
          + KSL_MUL(s->m3, fine_g2_cross2_1), fine_m_0 = KSL_MUL(s->m3, fine_beta_v_0),
      fine_m_cross2_1 = KSL_MUL(s->m3, fine_beta_v_lo_1),
      fine_m_padded_1 = 1.8051943758648296e-276 + KSL_MUL(fine_turned_padded_1, halved_size_1),
      fine_m_size_1 = KSL_MUL(fine_m_padded_1, halved_size_1);
  const double fine_beta_v_lo_2 = ksl_product_error(s->m4, fine_g2, fine_beta_v_1)
          + KSL_MUL(s->m4, fine_g2_cross2_1), fine_m_1 = KSL_MUL(s->m4, fine_beta_v_1),
      fine_m_cross2_2 = KSL_MUL(s->m4, fine_beta_v_lo_2),
      fine_m_padded_2 = 1.8051943758648296e-276 + KSL_MUL(fine_turned_padded_1, halved_size_3),
      fine_m_size_2 = KSL_MUL(fine_m_padded_2, halved_size_3);
  const double fine_m_2 = KSL_MUL(s->m5, fine_beta_v_2),
      fine_m_cross2_3 = KSL_MUL(s->m5, ksl_product_error(s->m5, fine_g2, fine_beta_v_2)
          + KSL_MUL(s->m5, fine_g2_cross2_1)),
      fine_m_size_3 = KSL_MUL(1.8051943758648296e-276
          + KSL_MUL(fine_turned_padded_1, halved_size_5), halved_size_5);
  const double fine_m_3 = KSL_MUL(s->m4, fine_beta_v_0),
      fine_m_cross2_4 = KSL_MUL(s->m4, fine_beta_v_lo_1);
  const double fine_m_4 = KSL_MUL(s->m5, fine_beta_v_0),
      fine_m_cross2_5 = KSL_MUL(s->m5, fine_beta_v_lo_1);
  const double fine_m_5 = KSL_MUL(s->m5, fine_beta_v_1),
      fine_m_cross2_6 = KSL_MUL(s->m5, fine_beta_v_lo_2);
  const double fine_others_0 = fine_m_1 + fine_m_2, fine_others_right_1 = fine_others_0 - fine_m_1,
      fine_others_left_rest_1 = ksl_product_rest(s->m4, fine_beta_v_1, fine_m_1, fine_others_0
          - fine_others_right_1),
      fine_others_lo1_1 = fine_others_left_rest_1
          + ksl_product_rest(s->m5, fine_beta_v_2, fine_m_2, fine_others_right_1),
      fine_others_lo_1 = fine_others_lo1_1 + (fine_m_cross2_2 + fine_m_cross2_3),
      fine_others_size_1 = fine_m_size_2 + fine_m_size_3;
  const double fine_others_1 = fine_m_0 + fine_m_2, fine_others_right_2 = fine_others_1 - fine_m_0,
      fine_others_left_rest_2 = ksl_product_rest(s->m3, fine_beta_v_0, fine_m_0, fine_others_1
          - fine_others_right_2),
      fine_others_lo1_2 = fine_others_left_rest_2
          + ksl_product_rest(s->m5, fine_beta_v_2, fine_m_2, fine_others_right_2),
      fine_others_lo_2 = fine_others_lo1_2 + (fine_m_cross2_1 + fine_m_cross2_3),
      fine_others_size_2 = fine_m_size_1 + fine_m_size_3;
  const double fine_others_2 = fine_m_0 + fine_m_1, fine_others_right_3 = fine_others_2 - fine_m_0,
      fine_others_left_rest_3 = ksl_product_rest(s->m3, fine_beta_v_0, fine_m_0, fine_others_2
          - fine_others_right_3),
      fine_others_lo1_3 = fine_others_left_rest_3
          + ksl_product_rest(s->m4, fine_beta_v_1, fine_m_1, fine_others_right_3),
      fine_others_lo_3 = fine_others_lo1_3 + (fine_m_cross2_1 + fine_m_cross2_2),
      fine_others_size_3 = fine_m_size_1 + fine_m_size_2;
  const double fine_diagonal0a = 1.0 - fine_others_0,
      fine_diagonal0a_right_1 = 1.0 - fine_diagonal0a,
      fine_diagonal0a_lo = 1.0 - (fine_diagonal0a + fine_diagonal0a_right_1)
          - (fine_others_0 - fine_diagonal0a_right_1) - fine_others_lo_1,
      fine_diagonal0a_size_1 = 1.0 + fine_others_size_1, fine_diagonal0b = fine_g0 + fine_m_0,
      fine_diagonal0b_right_1 = fine_diagonal0b - fine_g0,
      fine_diagonal0b_right_rest_1 = ksl_product_rest(s->m3, fine_beta_v_0, fine_m_0,
          fine_diagonal0b_right_1),
      fine_diagonal0b_lo = fine_g0 - (fine_diagonal0b - fine_diagonal0b_right_1)
          + fine_diagonal0b_right_rest_1 + fine_m_cross2_1 + fine_g0_lo,
      fine_diagonal0b_size_1 = fine_g0_size_1 + fine_m_size_1,
      fine_diagonal0_error_1 = fabs(ksl_product_error(s->m3, fine_beta_v_0, fine_m_0)
          + fine_m_cross2_1),
      fine_diagonal0_bound_2 = fabs(fine_others_lo_1)
          + KSL_MUL(8.219445306520549e-28, 1.8051943758648296e-276 + fine_others_size_1),
      fine_diagonal0_bound_3 = fabs(fine_diagonal0b_lo)
          + KSL_MUL(8.219445306520549e-28, 1.8051943758648296e-276 + fine_diagonal0b_size_1),
      fine_diagonal0_bound_4 = fabs(fine_diagonal0a_lo)
          + KSL_MUL(8.236702602727626e-28, 1.8051943758648296e-276 + fine_diagonal0a_size_1),
      fine_diagonal0_size_9 = fine_diagonal0_bound_4
          + (fine_diagonal0_bound_3 + fabs(fine_diagonal0b - fine_diagonal0a)),
      fine_diagonal0_size_2 = fine_diagonal0_error_1
          + KSL_MUL(8.202927567412116e-28, 1.8051943758648296e-276 + fine_m_size_1)
          + fine_diagonal0_bound_2,
      fine_diagonal0_size_11 = KSL_MUL(1.2161163344889557e+27, fine_diagonal0_size_2
          < fabs(fine_m_0 - fine_others_0) ? 0.0 : fine_diagonal0_size_9);
  const double fine_diagonal1a = 1.0 - fine_others_1,
      fine_diagonal1a_right_1 = 1.0 - fine_diagonal1a,
      fine_diagonal1a_lo = 1.0 - (fine_diagonal1a + fine_diagonal1a_right_1)
          - (fine_others_1 - fine_diagonal1a_right_1) - fine_others_lo_2,
      fine_diagonal1a_size_1 = 1.0 + fine_others_size_2, fine_diagonal1b = fine_g0 + fine_m_1,
      fine_diagonal1b_right_1 = fine_diagonal1b - fine_g0,
      fine_diagonal1b_right_rest_1 = ksl_product_rest(s->m4, fine_beta_v_1, fine_m_1,
          fine_diagonal1b_right_1),
      fine_diagonal1b_lo = fine_g0 - (fine_diagonal1b - fine_diagonal1b_right_1)
          + fine_diagonal1b_right_rest_1 + fine_m_cross2_2 + fine_g0_lo,
      fine_diagonal1b_size_1 = fine_g0_size_1 + fine_m_size_2,
      fine_diagonal1_error_1 = fabs(ksl_product_error(s->m4, fine_beta_v_1, fine_m_1)
          + fine_m_cross2_2),
      fine_diagonal1_bound_2 = fabs(fine_others_lo_2)
          + KSL_MUL(8.219445306520549e-28, 1.8051943758648296e-276 + fine_others_size_2),
      fine_diagonal1_bound_3 = fabs(fine_diagonal1b_lo)
          + KSL_MUL(8.219445306520549e-28, 1.8051943758648296e-276 + fine_diagonal1b_size_1),
      fine_diagonal1_bound_4 = fabs(fine_diagonal1a_lo)
          + KSL_MUL(8.236702602727626e-28, 1.8051943758648296e-276 + fine_diagonal1a_size_1),
      fine_diagonal1_size_9 = fine_diagonal1_bound_4
          + (fine_diagonal1_bound_3 + fabs(fine_diagonal1b - fine_diagonal1a)),
      fine_diagonal1_size_2 = fine_diagonal1_error_1
          + KSL_MUL(8.202927567412116e-28, 1.8051943758648296e-276 + fine_m_size_2)
          + fine_diagonal1_bound_2,
      fine_diagonal1_size_11 = KSL_MUL(1.2161163344889557e+27, fine_diagonal1_size_2
          < fabs(fine_m_1 - fine_others_1) ? 0.0 : fine_diagonal1_size_9);
  const double fine_diagonal2a = 1.0 - fine_others_2,
      fine_diagonal2a_right_1 = 1.0 - fine_diagonal2a,
      fine_diagonal2a_lo = 1.0 - (fine_diagonal2a + fine_diagonal2a_right_1)
          - (fine_others_2 - fine_diagonal2a_right_1) - fine_others_lo_3,
      fine_diagonal2a_size_1 = 1.0 + fine_others_size_3, fine_diagonal2b = fine_g0 + fine_m_2,
      fine_diagonal2b_right_1 = fine_diagonal2b - fine_g0,
      fine_diagonal2b_right_rest_1 = ksl_product_rest(s->m5, fine_beta_v_2, fine_m_2,
          fine_diagonal2b_right_1),
      fine_diagonal2b_lo = fine_g0 - (fine_diagonal2b - fine_diagonal2b_right_1)
          + fine_diagonal2b_right_rest_1 + fine_m_cross2_3 + fine_g0_lo,
      fine_diagonal2b_size_1 = fine_g0_size_1 + fine_m_size_3,
      fine_diagonal2_error_1 = fabs(ksl_product_error(s->m5, fine_beta_v_2, fine_m_2)
          + fine_m_cross2_3),
      fine_diagonal2_bound_2 = fabs(fine_others_lo_3)
          + KSL_MUL(8.219445306520549e-28, 1.8051943758648296e-276 + fine_others_size_3),
      fine_diagonal2_bound_3 = fabs(fine_diagonal2b_lo)
          + KSL_MUL(8.219445306520549e-28, 1.8051943758648296e-276 + fine_diagonal2b_size_1),
      fine_diagonal2_bound_4 = fabs(fine_diagonal2a_lo)
          + KSL_MUL(8.236702602727626e-28, 1.8051943758648296e-276 + fine_diagonal2a_size_1),
      fine_diagonal2_size_9 = fine_diagonal2_bound_4
          + (fine_diagonal2_bound_3 + fabs(fine_diagonal2b - fine_diagonal2a)),
      fine_diagonal2_size_2 = fine_diagonal2_error_1
          + KSL_MUL(8.202927567412116e-28, 1.8051943758648296e-276 + fine_m_size_3)
          + fine_diagonal2_bound_2,
      fine_diagonal2_size_11 = KSL_MUL(1.2161163344889557e+27, fine_diagonal2_size_2
          < fabs(fine_m_2 - fine_others_2) ? 0.0 : fine_diagonal2_size_9);
  const double fine_g1_lo = ksl_product_error(c, sinc, fine_g1) + fine_g1_cross_1,
      fine_alpha_v_0 = KSL_MUL(s->m3, fine_g1), fine_alpha_v_cross2_1 = KSL_MUL(s->m3, fine_g1_lo),
      fine_alpha_v_padded_1 = 1.8051943758648296e-276 + fine_g1_size_5;
  const double fine_alpha_v_1 = KSL_MUL(s->m4, fine_g1),
      fine_alpha_v_cross2_2 = KSL_MUL(s->m4, fine_g1_lo);
  const double fine_alpha_v_2 = KSL_MUL(s->m5, fine_g1),
      fine_alpha_v_cross2_3 = KSL_MUL(s->m5, fine_g1_lo);
  const double fine_across_axis_0 = fine_turned_0 + fine_along_0,
      fine_across_axis_right_1 = fine_across_axis_0 - fine_turned_0,
      fine_across_axis_left_rest_1 = ksl_product_rest(fine_g2, fine_u_0, fine_turned_0,
          fine_across_axis_0 - fine_across_axis_right_1),
      fine_across_axis_lo1_1 = fine_across_axis_left_rest_1
          + ksl_product_rest(s->m3, fine_pitch, fine_along_0, fine_across_axis_right_1);
  const double fine_across_axis_1 = fine_turned_1 + fine_along_1,
      fine_across_axis_right_2 = fine_across_axis_1 - fine_turned_1,
      fine_across_axis_left_rest_2 = ksl_product_rest(fine_g2, fine_u_1, fine_turned_1,
          fine_across_axis_1 - fine_across_axis_right_2),
      fine_across_axis_lo1_2 = fine_across_axis_left_rest_2
          + ksl_product_rest(s->m4, fine_pitch, fine_along_1, fine_across_axis_right_2);
  const double fine_across_axis_2 = fine_turned_2 + fine_along_2,
      fine_across_axis_right_3 = fine_across_axis_2 - fine_turned_2,
      fine_across_axis_left_rest_3 = ksl_product_rest(fine_g2, fine_u_2, fine_turned_2,
          fine_across_axis_2 - fine_across_axis_right_3),
      fine_across_axis_lo1_3 = fine_across_axis_left_rest_3
          + ksl_product_rest(s->m5, fine_pitch, fine_along_2, fine_across_axis_right_3);
  const double fine_D_01 = fine_m_3 - fine_alpha_v_2, fine_D_right_1 = fine_m_3 - fine_D_01,
      fine_D_left_rest_1 = ksl_product_rest(s->m4, fine_beta_v_0, fine_m_3, fine_D_01
          + fine_D_right_1);
  const double fine_D_02 = fine_m_4 + fine_alpha_v_1, fine_D_right_2 = fine_D_02 - fine_m_4,
      fine_D_left_rest_2 = ksl_product_rest(s->m5, fine_beta_v_0, fine_m_4, fine_D_02
          - fine_D_right_2);
  const double fine_D_03a = KSL_MUL(s->m0, fine_g1), fine_D_03 = fine_D_03a + fine_across_axis_0,
      fine_D_right_3 = fine_D_03 - fine_D_03a;
  const double fine_across_axis_lo_1 = fine_across_axis_lo1_1
          + (KSL_MUL(fine_g2_cross2_1, fine_u_0) + KSL_MUL(fine_g2, fine_u_lo_1)
          + KSL_MUL(s->m3, fine_pitch_lo));
  const double fine_D_lo1_3 = ksl_product_rest(s->m0, fine_g1, fine_D_03a, fine_D_03
          - fine_D_right_3) + (fine_across_axis_0 - fine_D_right_3);
  const double fine_across_axis_size_1 = KSL_MUL(fine_along_padded_1, halved_size_1)
          + KSL_MUL(fine_turned_padded_1, fine_turned_padded_2);
  const double fine_D_10 = fine_m_3 + fine_alpha_v_2, fine_D_right_4 = fine_D_10 - fine_m_3,
      fine_D_left_rest_4 = ksl_product_rest(s->m4, fine_beta_v_0, fine_m_3, fine_D_10
          - fine_D_right_4);
  const double fine_D_12 = fine_m_5 - fine_alpha_v_0, fine_D_right_5 = fine_m_5 - fine_D_12,
      fine_D_left_rest_5 = ksl_product_rest(s->m5, fine_beta_v_1, fine_m_5, fine_D_12
          + fine_D_right_5);
  const double fine_D_13a = KSL_MUL(s->m1, fine_g1), fine_D_13 = fine_D_13a + fine_across_axis_1,
      fine_D_right_6 = fine_D_13 - fine_D_13a;
  const double fine_across_axis_lo_2 = fine_across_axis_lo1_2
          + (KSL_MUL(fine_g2_cross2_1, fine_u_1) + KSL_MUL(fine_g2, fine_u_lo_2)
          + KSL_MUL(s->m4, fine_pitch_lo));
  const double fine_D_lo1_6 = ksl_product_rest(s->m1, fine_g1, fine_D_13a, fine_D_13
          - fine_D_right_6) + (fine_across_axis_1 - fine_D_right_6);
  const double fine_across_axis_size_2 = KSL_MUL(fine_along_padded_1, halved_size_3)
          + KSL_MUL(fine_turned_padded_1, fine_turned_padded_3);
  const double fine_D_20 = fine_m_4 - fine_alpha_v_1, fine_D_right_7 = fine_m_4 - fine_D_20,
      fine_D_left_rest_7 = ksl_product_rest(s->m5, fine_beta_v_0, fine_m_4, fine_D_20
          + fine_D_right_7);
  const double fine_D_21 = fine_m_5 + fine_alpha_v_0, fine_D_right_8 = fine_D_21 - fine_m_5,
      fine_D_left_rest_8 = ksl_product_rest(s->m5, fine_beta_v_1, fine_m_5, fine_D_21
          - fine_D_right_8);
  const double fine_D_23a = KSL_MUL(s->m2, fine_g1), fine_D_23 = fine_D_23a + fine_across_axis_2,
      fine_D_right_9 = fine_D_23 - fine_D_23a;
  const double fine_across_axis_lo_3 = fine_across_axis_lo1_3
          + (KSL_MUL(fine_g2_cross2_1, fine_u_2) + KSL_MUL(fine_g2, fine_u_lo_3)
          + KSL_MUL(s->m5, fine_pitch_lo));
  const double fine_D_lo1_9 = ksl_product_rest(s->m2, fine_g1, fine_D_23a, fine_D_23
          - fine_D_right_9) + (fine_across_axis_2 - fine_D_right_9);
  const double fine_across_axis_size_3 = KSL_MUL(fine_along_padded_1, halved_size_5)
          + KSL_MUL(fine_turned_padded_1, fine_turned_padded_4);
  const double diagonal0_apart_1 = (fine_m_0 < fine_others_0 ? fine_diagonal0b : fine_diagonal0a)
          - diagonal0,
      diagonal0_padded_1 = 1.8051943758648296e-276
          + ((fine_m_0 < fine_others_0 ? fine_diagonal0b_size_1 : fine_diagonal0a_size_1)
          + fine_diagonal0_size_11),
      diagonal0_error_2 = KSL_MUL(1.0000000000000009, fabs(diagonal0_apart_1
          + (fine_m_0 < fine_others_0 ? fine_diagonal0b_lo : fine_diagonal0a_lo)));
  const double fine_D_lo_1 = fine_D_left_rest_1
          - ksl_product_rest(s->m5, fine_g1, fine_alpha_v_2, fine_D_right_1)
          + (fine_m_cross2_4 - fine_alpha_v_cross2_3);
  const double D_padded_1 = 1.8051943758648296e-276
          + (KSL_MUL(fine_alpha_v_padded_1, halved_size_5)
          + KSL_MUL(fine_m_padded_1, halved_size_3)),
      D_rest_1 = KSL_MUL(8.219445306520549e-28, D_padded_1);
  const double fine_D_lo_2 = fine_D_left_rest_2
          + ksl_product_rest(s->m4, fine_g1, fine_alpha_v_1, fine_D_right_2)
          + (fine_m_cross2_5 + fine_alpha_v_cross2_2);
  const double D_padded_2 = 1.8051943758648296e-276
          + (KSL_MUL(fine_alpha_v_padded_1, halved_size_3)
          + KSL_MUL(fine_m_padded_1, halved_size_5)),
      D_rest_2 = KSL_MUL(8.219445306520549e-28, D_padded_2),
      D_rest_3 = KSL_MUL(9.291457458136845e-28, 1.8051943758648296e-276
          + (KSL_MUL(fine_alpha_v_padded_1, fine_u_1a_size_1) + fine_across_axis_size_1));
  const double fine_D_lo_4 = fine_D_left_rest_4
          + ksl_product_rest(s->m5, fine_g1, fine_alpha_v_2, fine_D_right_4)
          + (fine_m_cross2_4 + fine_alpha_v_cross2_3);
  const double diagonal1_apart_1 = (fine_m_1 < fine_others_1 ? fine_diagonal1b : fine_diagonal1a)
          - diagonal1,
      diagonal1_padded_1 = 1.8051943758648296e-276
          + ((fine_m_1 < fine_others_1 ? fine_diagonal1b_size_1 : fine_diagonal1a_size_1)
          + fine_diagonal1_size_11),
      diagonal1_error_2 = KSL_MUL(1.0000000000000009, fabs(diagonal1_apart_1
          + (fine_m_1 < fine_others_1 ? fine_diagonal1b_lo : fine_diagonal1a_lo)));
  const double fine_D_lo_5 = fine_D_left_rest_5
          - ksl_product_rest(s->m3, fine_g1, fine_alpha_v_0, fine_D_right_5)
          + (fine_m_cross2_6 - fine_alpha_v_cross2_1);
  const double D_padded_4 = 1.8051943758648296e-276
          + (KSL_MUL(fine_alpha_v_padded_1, halved_size_1)
          + KSL_MUL(fine_m_padded_2, halved_size_5)),
      D_rest_4 = KSL_MUL(8.219445306520549e-28, D_padded_4),
      D_rest_5 = KSL_MUL(9.291457458136845e-28, 1.8051943758648296e-276
          + (KSL_MUL(fine_alpha_v_padded_1, fine_u_0b_size_1) + fine_across_axis_size_2));
  const double fine_D_lo_7 = fine_D_left_rest_7
          - ksl_product_rest(s->m4, fine_g1, fine_alpha_v_1, fine_D_right_7)
          + (fine_m_cross2_5 - fine_alpha_v_cross2_2);
  const double fine_D_lo_8 = fine_D_left_rest_8
          + ksl_product_rest(s->m3, fine_g1, fine_alpha_v_0, fine_D_right_8)
          + (fine_m_cross2_6 + fine_alpha_v_cross2_1);
  const double diagonal2_apart_1 = (fine_m_2 < fine_others_2 ? fine_diagonal2b : fine_diagonal2a)
          - diagonal2,
      diagonal2_padded_1 = 1.8051943758648296e-276
          + ((fine_m_2 < fine_others_2 ? fine_diagonal2b_size_1 : fine_diagonal2a_size_1)
          + fine_diagonal2_size_11),
      diagonal2_error_2 = KSL_MUL(1.0000000000000009, fabs(diagonal2_apart_1
          + (fine_m_2 < fine_others_2 ? fine_diagonal2b_lo : fine_diagonal2a_lo))),
      D_rest_6 = KSL_MUL(9.291457458136845e-28, 1.8051943758648296e-276
          + (KSL_MUL(fine_alpha_v_padded_1, fine_u_0a_size_1) + fine_across_axis_size_3)),
      diagonal0_bound_1 = diagonal0_error_2 + KSL_MUL(8.236703566632994e-28, diagonal0_padded_1),
      D_bound_1 = KSL_MUL(1.0000000000000009, fabs(fine_D_01 - D_01 + fine_D_lo_1)) + D_rest_1,
      D_bound_2 = KSL_MUL(1.0000000000000009, fabs(fine_D_02 - D_02 + fine_D_lo_2)) + D_rest_2,
      D_bound_3 = KSL_MUL(1.0000000000000009, fabs(fine_D_03 - D_03
          + (fine_D_lo1_3 + fine_across_axis_lo_1 + KSL_MUL(s->m0, fine_g1_lo)))) + D_rest_3,
      D_bound_4 = KSL_MUL(1.0000000000000009, fabs(fine_D_10 - D_10 + fine_D_lo_4)) + D_rest_1,
      diagonal1_bound_1 = diagonal1_error_2 + KSL_MUL(8.236703566632994e-28, diagonal1_padded_1),
      D_bound_5 = KSL_MUL(1.0000000000000009, fabs(fine_D_12 - D_12 + fine_D_lo_5)) + D_rest_4,
      D_bound_6 = KSL_MUL(1.0000000000000009, fabs(fine_D_13 - D_13
          + (fine_D_lo1_6 + fine_across_axis_lo_2 + KSL_MUL(s->m1, fine_g1_lo)))) + D_rest_5,
      D_bound_7 = KSL_MUL(1.0000000000000009, fabs(fine_D_20 - D_20 + fine_D_lo_7)) + D_rest_2,
      D_bound_8 = KSL_MUL(1.0000000000000009, fabs(fine_D_21 - D_21 + fine_D_lo_8)) + D_rest_4,
      diagonal2_bound_1 = diagonal2_error_2 + KSL_MUL(8.236703566632994e-28, diagonal2_padded_1),
      D_bound_9 = KSL_MUL(1.0000000000000009, fabs(fine_D_23 - D_23
          + (fine_D_lo1_9 + fine_across_axis_lo_3 + KSL_MUL(s->m2, fine_g1_lo)))) + D_rest_6;
  D->m00 = diagonal0;
  D->m01 = D_01;
  D->m02 = D_02;
  D->m03 = D_03;
  D->m10 = D_10;
  D->m11 = diagonal1;
  D->m12 = D_12;
  D->m13 = D_13;
  D->m20 = D_20;
  D->m21 = D_21;
  D->m22 = diagonal2;
  D->m23 = D_23;
  D_bound->m00 = diagonal0_bound_1;
  D_bound->m01 = D_bound_1;
  D_bound->m02 = D_bound_2;
  D_bound->m03 = D_bound_3;
  D_bound->m10 = D_bound_4;
  D_bound->m11 = diagonal1_bound_1;
  D_bound->m12 = D_bound_5;
  D_bound->m13 = D_bound_6;
  D_bound->m20 = D_bound_7;
  D_bound->m21 = D_bound_8;
  D_bound->m22 = diagonal2_bound_1;
  D_bound->m23 = D_bound_9;
}

/* so with exp so = D, |ω| <= π: (J_l(ω)^-1 t; ω), ω = log R; |error of so| <= so_bound unless
     inf or NaN.
   D: displacement [R | t], R rotation, t in m; so, so_bound: screw (v in m/s; ω in rad/s).
   599 mul, 986 add, 36 product error, 36 product rest, 47 div, 5 sqrt, 15 neg, 155 abs, 6
     copysign, 72 less, 10 equal, 171 select. */
static inline void ksl_SE3_log_certified(const ksl_SE3_t *D, ksl_screw_t *so,
    ksl_screw_t *so_bound) {
  const double p_0 = D->m21 - D->m12;
  const double p_1 = D->m02 - D->m20;
  const double p_2 = D->m10 - D->m01;
  const double s_0 = D->m12 + D->m21;
  const double s_1 = D->m02 + D->m20;
  const double s_2 = D->m01 + D->m10;
  const double first_0 = D->m00 + 1.0;
  const double first_1 = 1.0 - D->m00;
  const double others_0 = D->m11 + D->m22;
  const double others_1 = D->m11 - D->m22;
  const double d_0 = first_0 + others_0;
  const double d_1 = first_0 - others_0;
  const double d_2 = first_1 + others_1;
  const double d_3 = first_1 - others_1;
  const double low_0 = D->m11 < D->m00 ? d_1 : s_2;
  const double low_1 = D->m11 < D->m00 ? s_2 : d_2;
  const double low_2 = D->m11 < D->m00 ? s_1 : s_0;
  const double low_3 = D->m11 < D->m00 ? p_0 : p_1;
  const double high_0a = -D->m11, high_0 = D->m00 < high_0a ? s_1 : p_0;
  const double high_1 = D->m00 < high_0a ? s_0 : p_1;
  const double high_2 = D->m00 < high_0a ? d_3 : p_2;
  const double high_3 = D->m00 < high_0a ? p_2 : d_0;
  const double column_0 = D->m22 < 0.0 ? low_0 : high_0;
  const double column_1 = D->m22 < 0.0 ? low_1 : high_1;
  const double column_2 = D->m22 < 0.0 ? low_2 : high_2;
  const double column_3 = D->m22 < 0.0 ? low_3 : high_3;
  const double upper_0a = -column_0, upper_0 = column_3 < 0.0 ? upper_0a : column_0;
  const double upper_1a = -column_1, upper_1 = column_3 < 0.0 ? upper_1a : column_1;
  const double upper_2a = -column_2, upper_2 = column_3 < 0.0 ? upper_2a : column_2;
  const double upper_3a = -column_3, upper_3 = column_3 < 0.0 ? upper_3a : column_3;
  const double v_s_size_0 = fabs(upper_0);
  const double v_s_size_1 = fabs(upper_1);
  const double v_s_size_2 = fabs(upper_2);
  const double v_s_largest1 = v_s_size_0 < v_s_size_1 ? v_s_size_1 : v_s_size_0;
  const double v_s_largest2 = v_s_largest1 < v_s_size_2 ? v_s_size_2 : v_s_largest1;
  const double v_s_b = 6.703903964971299e+153 < v_s_largest2 ? 3.7291703656001034e-155 : 1.0,
      v_s_d = v_s_largest2 < 256.0 ? 1.3093562431584567e+151 : v_s_b,
      v_s = v_s_largest2 < 1.955159272639747e-149 ? 1.0715086071862673e+301 : v_s_d;
  const double v_y_0 = KSL_MUL(upper_0, v_s);
  const double v_y_1 = KSL_MUL(upper_1, v_s);
  const double v_y_2 = KSL_MUL(upper_2, v_s);
  const double v_n = sqrt(KSL_MUL(v_y_0, v_y_0) + KSL_MUL(v_y_1, v_y_1) + KSL_MUL(v_y_2, v_y_2));
  const double v_r_b = v_s < 1.0 ? 2.6815615859885194e+154 : 1.0,
      v_r_d = 1.0 < v_s ? 7.637340908749012e-152 : v_r_b,
      v_r = 1.3093562431584567e+151 < v_s ? 9.332636185032189e-302 : v_r_d;
  const double n = KSL_MUL(v_n, v_r);
  const double half = ksl_atan2(n, upper_3);
  const double divisor = n == 0.0 ? 1.0 : n;
  const double theta = KSL_MUL(2.0, half);
  const double k = theta / divisor;
  const double vector_0 = KSL_MUL(upper_0, k);
  const double vector_1 = KSL_MUL(upper_1, k);
  const double vector_2 = KSL_MUL(upper_2, k);
  const double x = KSL_MUL(theta, theta);
  const double far_sine = x < 1.0 ? 1.0 : n;
  const double cotangent = upper_3 / far_sine;
  const double half_cotangent = KSL_MUL(KSL_MUL(0.5, theta), cotangent);
  const double b_rest = 1.0 - half_cotangent;
  const double b_divisor = x < 4.0 ? 4.0 : x;
  const double closed_b = b_rest / b_divisor;
  const double b_g = KSL_MUL(x, KSL_MUL(x, KSL_MUL(x, KSL_MUL(1.455172475614865e-27, x)
          + 5.744790668872202e-26) + 2.267952452337683e-24) + 8.953517427037546e-23),
      b_n = KSL_MUL(x, KSL_MUL(x, KSL_MUL(x, b_g + 3.534707039629467e-21) + 1.3954464685812522e-19)
          + 5.5090028283602295e-18) + 2.174868698558062e-16,
      b_u = KSL_MUL(x, KSL_MUL(x, KSL_MUL(x, KSL_MUL(x, b_n) + 8.586062056277845e-15)
          + 3.3896802963225827e-13) + 1.3382536530684679e-11),
      b_ab = KSL_MUL(x, KSL_MUL(x, KSL_MUL(x, b_u + 5.284190138687493e-10) + 2.08767569878681e-08)
          + 8.267195767195768e-07) + 3.306878306878307e-05,
      b_af = KSL_MUL(x, KSL_MUL(x, b_ab) + 0.001388888888888889) + 0.08333333333333333,
      b = x < 4.0 ? b_af : closed_b;
  const double b_across_b = 1.0 - KSL_MUL(x, b), b_across = x < 4.0 ? b_across_b : half_cotangent;
  const double wt = KSL_MUL(D->m03, vector_0) + KSL_MUL(D->m13, vector_1)
          + KSL_MUL(D->m23, vector_2);
  const double pitch = KSL_MUL(b, wt);
  const double along_0 = KSL_MUL(vector_0, pitch);
  const double along_1 = KSL_MUL(vector_1, pitch);
  const double along_2 = KSL_MUL(vector_2, pitch);
  const double u_0 = KSL_MUL(D->m23, vector_1) - KSL_MUL(D->m13, vector_2);
  const double u_1 = KSL_MUL(D->m03, vector_2) - KSL_MUL(D->m23, vector_0);
  const double u_2 = KSL_MUL(D->m13, vector_0) - KSL_MUL(D->m03, vector_1);
  const double turned_0 = KSL_MUL(0.5, u_0);
  const double turned_1 = KSL_MUL(0.5, u_1);
  const double turned_2 = KSL_MUL(0.5, u_2);
  const double across_axis_0 = along_0 - turned_0;
  const double across_axis_1 = along_1 - turned_1;
  const double across_axis_2 = along_2 - turned_2;
  const double so_0 = KSL_MUL(D->m03, b_across) + across_axis_0;
  const double so_1 = KSL_MUL(D->m13, b_across) + across_axis_1;
  const double so_2 = KSL_MUL(D->m23, b_across) + across_axis_2;
  const double fine_p_0 = D->m21 - D->m12, fine_p_right_1 = D->m21 - fine_p_0,
      fine_p_lo_1 = D->m21 - (fine_p_0 + fine_p_right_1) - (D->m12 - fine_p_right_1),
      fine_p_size_3 = fabs(D->m21) + fabs(D->m12);
  const double fine_p_1 = D->m02 - D->m20, fine_p_right_2 = D->m02 - fine_p_1,
      fine_p_lo_2 = D->m02 - (fine_p_1 + fine_p_right_2) - (D->m20 - fine_p_right_2),
      fine_p_size_6 = fabs(D->m02) + fabs(D->m20);
  const double fine_p_2 = D->m10 - D->m01, fine_p_right_3 = D->m10 - fine_p_2,
      fine_p_lo_3 = D->m10 - (fine_p_2 + fine_p_right_3) - (D->m01 - fine_p_right_3),
      fine_p_size_9 = fabs(D->m10) + fabs(D->m01);
  const double fine_s_0 = D->m12 + D->m21, fine_s_right_1 = fine_s_0 - D->m12,
      fine_s_lo_1 = D->m12 - (fine_s_0 - fine_s_right_1) + (D->m21 - fine_s_right_1);
  const double fine_s_1 = D->m02 + D->m20, fine_s_right_2 = fine_s_1 - D->m02,
      fine_s_lo_2 = D->m02 - (fine_s_1 - fine_s_right_2) + (D->m20 - fine_s_right_2);
  const double fine_s_2 = D->m01 + D->m10, fine_s_right_3 = fine_s_2 - D->m01,
      fine_s_lo_3 = D->m01 - (fine_s_2 - fine_s_right_3) + (D->m10 - fine_s_right_3);
  const double fine_first_0 = D->m00 + 1.0, fine_first_right_1 = fine_first_0 - D->m00,
      fine_first_lo_1 = D->m00 - (fine_first_0 - fine_first_right_1) + (1.0 - fine_first_right_1);
  const double fine_first_1 = 1.0 - D->m00, fine_first_right_2 = 1.0 - fine_first_1,
      fine_first_lo_2 = 1.0 - (fine_first_1 + fine_first_right_2) - (D->m00 - fine_first_right_2);
  const double fine_others_0 = D->m11 + D->m22, fine_others_right_1 = fine_others_0 - D->m11,
      fine_others_lo_1 = D->m11 - (fine_others_0 - fine_others_right_1)
          + (D->m22 - fine_others_right_1);
  const double fine_others_1 = D->m11 - D->m22, fine_others_right_2 = D->m11 - fine_others_1,
      fine_others_lo_2 = D->m11 - (fine_others_1 + fine_others_right_2)
          - (D->m22 - fine_others_right_2);
  const double fine_d_0 = fine_first_0 + fine_others_0, fine_d_right_1 = fine_d_0 - fine_first_0,
      fine_d_lo_1 = fine_first_0 - (fine_d_0 - fine_d_right_1) + (fine_others_0 - fine_d_right_1)
          + fine_others_lo_1 + fine_first_lo_1,
      fine_d_size_1 = 1.0 + fabs(D->m00) + (fabs(D->m11) + fabs(D->m22));
  const double fine_d_1 = fine_first_0 - fine_others_0, fine_d_right_2 = fine_first_0 - fine_d_1,
      fine_d_lo_2 = fine_first_0 - (fine_d_1 + fine_d_right_2) - (fine_others_0 - fine_d_right_2)
          - fine_others_lo_1 + fine_first_lo_1;
  const double fine_d_2 = fine_first_1 + fine_others_1, fine_d_right_3 = fine_d_2 - fine_first_1,
      fine_d_lo_3 = fine_first_1 - (fine_d_2 - fine_d_right_3) + (fine_others_1 - fine_d_right_3)
          + fine_others_lo_2 + fine_first_lo_2;
  const double fine_d_3 = fine_first_1 - fine_others_1, fine_d_right_4 = fine_first_1 - fine_d_3,
      fine_d_lo_4 = fine_first_1 - (fine_d_3 + fine_d_right_4) - (fine_others_1 - fine_d_right_4)
          - fine_others_lo_2 + fine_first_lo_2;
  const double fine_low_0 = D->m11 < D->m00 ? fine_d_1 : fine_s_2,
      fine_low_lo_1 = D->m11 < D->m00 ? fine_d_lo_2 : fine_s_lo_3,
      fine_low_size_1 = D->m11 < D->m00 ? fine_d_size_1 : fine_p_size_9;
  const double fine_low_1 = D->m11 < D->m00 ? fine_s_2 : fine_d_2,
      fine_low_lo_2 = D->m11 < D->m00 ? fine_s_lo_3 : fine_d_lo_3,
      fine_low_size_2 = D->m11 < D->m00 ? fine_p_size_9 : fine_d_size_1;
  const double fine_low_2 = D->m11 < D->m00 ? fine_s_1 : fine_s_0,
      fine_low_lo_3 = D->m11 < D->m00 ? fine_s_lo_2 : fine_s_lo_1,
      fine_low_size_3 = D->m11 < D->m00 ? fine_p_size_6 : fine_p_size_3;
  const double fine_low_3 = D->m11 < D->m00 ? fine_p_0 : fine_p_1,
      fine_low_lo_4 = D->m11 < D->m00 ? fine_p_lo_1 : fine_p_lo_2,
      fine_low_size_4 = D->m11 < D->m00 ? fine_p_size_3 : fine_p_size_6;
  const double fine_high_0a = -D->m11, fine_high_0 = D->m00 < fine_high_0a ? fine_s_1 : fine_p_0,
      fine_high_lo_1 = D->m00 < fine_high_0a ? fine_s_lo_2 : fine_p_lo_1,
      fine_high_size_1 = D->m00 < fine_high_0a ? fine_p_size_6 : fine_p_size_3;
  const double fine_high_1 = D->m00 < fine_high_0a ? fine_s_0 : fine_p_1,
      fine_high_lo_2 = D->m00 < fine_high_0a ? fine_s_lo_1 : fine_p_lo_2,
      fine_high_size_2 = D->m00 < fine_high_0a ? fine_p_size_3 : fine_p_size_6;
  const double fine_high_2 = D->m00 < fine_high_0a ? fine_d_3 : fine_p_2,
      fine_high_lo_3 = D->m00 < fine_high_0a ? fine_d_lo_4 : fine_p_lo_3,
      fine_high_size_3 = D->m00 < fine_high_0a ? fine_d_size_1 : fine_p_size_9;
  const double fine_high_3 = D->m00 < fine_high_0a ? fine_p_2 : fine_d_0,
      fine_high_lo_4 = D->m00 < fine_high_0a ? fine_p_lo_3 : fine_d_lo_1,
      fine_high_size_4 = D->m00 < fine_high_0a ? fine_p_size_9 : fine_d_size_1;
  const double fine_column_0 = D->m22 < 0.0 ? fine_low_0 : fine_high_0,
      fine_column_lo_1 = D->m22 < 0.0 ? fine_low_lo_1 : fine_high_lo_1,
      fine_column_size_1 = D->m22 < 0.0 ? fine_low_size_1 : fine_high_size_1;
  const double fine_column_1 = D->m22 < 0.0 ? fine_low_1 : fine_high_1,
      fine_column_lo_2 = D->m22 < 0.0 ? fine_low_lo_2 : fine_high_lo_2,
      fine_column_size_2 = D->m22 < 0.0 ? fine_low_size_2 : fine_high_size_2;
  const double fine_column_2 = D->m22 < 0.0 ? fine_low_2 : fine_high_2,
      fine_column_lo_3 = D->m22 < 0.0 ? fine_low_lo_3 : fine_high_lo_3,
      fine_column_size_3 = D->m22 < 0.0 ? fine_low_size_3 : fine_high_size_3;
  const double fine_column_3 = D->m22 < 0.0 ? fine_low_3 : fine_high_3,
      fine_column_lo_4 = D->m22 < 0.0 ? fine_low_lo_4 : fine_high_lo_4,
      fine_column_size_4 = D->m22 < 0.0 ? fine_low_size_4 : fine_high_size_4;
  const double fine_upper_0a = -fine_column_0, fine_upper_0a_lo = -fine_column_lo_1,
      fine_upper_0 = fine_column_3 < 0.0 ? fine_upper_0a : fine_column_0,
      fine_upper_lo_1 = fine_column_3 < 0.0 ? fine_upper_0a_lo : fine_column_lo_1,
      fine_upper_bound_1 = fabs(fine_column_lo_4)
          + KSL_MUL(1.6023738312796216e-30, 1.8051943758648296e-276 + fine_column_size_4),
      fine_upper_size_2 = fabs(fine_column_3 - 0.0),
      fine_upper_rest_2 = KSL_MUL(1.6023738312796216e-30, 1.8051943758648296e-276
          + fine_column_size_1),
      fine_upper_size_7 = fabs(fine_column_lo_1) + fine_upper_rest_2
          + (fabs(fine_upper_0a_lo) + fine_upper_rest_2 + fabs(fine_upper_0a - fine_column_0));
  const double fine_upper_1a = -fine_column_1, fine_upper_1a_lo = -fine_column_lo_2,
      fine_upper_1 = fine_column_3 < 0.0 ? fine_upper_1a : fine_column_1,
      fine_upper_lo_2 = fine_column_3 < 0.0 ? fine_upper_1a_lo : fine_column_lo_2,
      fine_upper_rest_3 = KSL_MUL(1.6023738312796216e-30, 1.8051943758648296e-276
          + fine_column_size_2),
      fine_upper_size_14 = fabs(fine_column_lo_2) + fine_upper_rest_3
          + (fabs(fine_upper_1a_lo) + fine_upper_rest_3 + fabs(fine_upper_1a - fine_column_1));
  const double fine_upper_2a = -fine_column_2, fine_upper_2a_lo = -fine_column_lo_3,
      fine_upper_2 = fine_column_3 < 0.0 ? fine_upper_2a : fine_column_2,
      fine_upper_lo_3 = fine_column_3 < 0.0 ? fine_upper_2a_lo : fine_column_lo_3,
      fine_upper_rest_4 = KSL_MUL(1.6023738312796216e-30, 1.8051943758648296e-276
          + fine_column_size_3),
      fine_upper_size_21 = fabs(fine_column_lo_3) + fine_upper_rest_4
          + (fabs(fine_upper_2a_lo) + fine_upper_rest_4 + fabs(fine_upper_2a - fine_column_2));
  const double fine_upper_3 = fabs(fine_column_3), fine_upper_opposite_1 = -fine_column_lo_4,
      fine_upper_lo_4 = fine_column_3 < 0.0 ? fine_upper_opposite_1 : fine_column_lo_4,
      fine_upper_size_25 = fine_upper_3 - fine_upper_bound_1;
  const double fine_v_s_size_0 = fabs(fine_upper_0);
  const double fine_upper_size_10 = fine_column_size_1
          + KSL_MUL(1.5845630613906556e+29, fine_upper_bound_1 < fine_upper_size_2 ? 0.0
          : fine_upper_size_7);
  const double fine_v_s_size_padded_1 = 1.8051943758648296e-276 + fine_upper_size_10;
  const double fine_v_s_size_1 = fabs(fine_upper_1);
  const double fine_upper_size_17 = fine_column_size_2
          + KSL_MUL(1.5845630613906556e+29, fine_upper_bound_1 < fine_upper_size_2 ? 0.0
          : fine_upper_size_14);
  const double fine_v_s_size_padded_2 = 1.8051943758648296e-276 + fine_upper_size_17;
  const double fine_v_s_size_2 = fabs(fine_upper_2);
  const double fine_upper_size_24 = fine_column_size_3
          + KSL_MUL(1.5845630613906556e+29, fine_upper_bound_1 < fine_upper_size_2 ? 0.0
          : fine_upper_size_21);
  const double fine_v_s_size_padded_3 = 1.8051943758648296e-276 + fine_upper_size_24;
  const double fine_v_s_largest1 = fine_v_s_size_0 < fine_v_s_size_1 ? fine_v_s_size_1
          : fine_v_s_size_0;
  const double fine_v_s_largest2 = fine_v_s_largest1 < fine_v_s_size_2 ? fine_v_s_size_2
          : fine_v_s_largest1;
  const double fine_v_s_b = 6.703903964971299e+153 < fine_v_s_largest2 ? 3.7291703656001034e-155
          : 1.0,
      fine_v_s_b_size_1 = 6.703903964971299e+153 < fine_v_s_largest2 ? 3.7291703656001034e-155
          : 1.0, fine_v_s_d = fine_v_s_largest2 < 256.0 ? 1.3093562431584567e+151 : fine_v_s_b,
      fine_v_s_d_size_1 = fine_v_s_largest2 < 256.0 ? 1.3093562431584567e+151 : fine_v_s_b_size_1,
      fine_v_s = fine_v_s_largest2 < 1.955159272639747e-149 ? 1.0715086071862673e+301 : fine_v_s_d,
      fine_v_s_size_3 = fine_v_s_largest2 < 1.955159272639747e-149 ? 1.0715086071862673e+301
          : fine_v_s_d_size_1;
  const double fine_v_y_0 = KSL_MUL(fine_upper_0, fine_v_s), fine_v_y_inverse_1 = 1.0 / fine_v_s,
      fine_v_y_lo_1 = KSL_MUL(fine_upper_0 - KSL_MUL(fine_v_y_0, fine_v_y_inverse_1)
          + fine_upper_lo_1, fine_v_s);
  const double fine_v_y_1 = KSL_MUL(fine_upper_1, fine_v_s),
      fine_v_y_lo_2 = KSL_MUL(fine_upper_1 - KSL_MUL(fine_v_y_1, fine_v_y_inverse_1)
          + fine_upper_lo_2, fine_v_s);
  const double fine_v_y_2 = KSL_MUL(fine_upper_2, fine_v_s),
      fine_v_y_lo_3 = KSL_MUL(fine_upper_2 - KSL_MUL(fine_v_y_2, fine_v_y_inverse_1)
          + fine_upper_lo_3, fine_v_s);
  const double fine_v_n_a = KSL_MUL(fine_v_y_0, fine_v_y_0),
      fine_v_n_a_padded_1 = 1.8051943758648296e-276
          + KSL_MUL(fine_v_s_size_3, fine_v_s_size_padded_1),
      fine_v_n_a_reach_1 = fabs(fine_v_y_0)
          + KSL_MUL(140737488355328.0, fabs(fine_v_y_lo_1)
          + KSL_MUL(6.705320021857442e-30, fine_v_n_a_padded_1)),
      fine_v_n_a_size_2 = KSL_MUL(fine_v_n_a_padded_1, fine_v_n_a_reach_1),
      fine_v_n_b = KSL_MUL(fine_v_y_1, fine_v_y_1),
      fine_v_n_b_padded_1 = 1.8051943758648296e-276
          + KSL_MUL(fine_v_s_size_3, fine_v_s_size_padded_2),
      fine_v_n_b_reach_1 = fabs(fine_v_y_1)
          + KSL_MUL(140737488355328.0, fabs(fine_v_y_lo_2)
          + KSL_MUL(6.705320021857442e-30, fine_v_n_b_padded_1)),
      fine_v_n_b_size_2 = KSL_MUL(fine_v_n_b_padded_1, fine_v_n_b_reach_1),
      fine_v_n_c = fine_v_n_a + fine_v_n_b, fine_v_n_c_right_1 = fine_v_n_c - fine_v_n_a,
      fine_v_n_a_cross_1 = KSL_MUL(fine_v_y_lo_1, fine_v_y_0) + KSL_MUL(fine_v_y_0, fine_v_y_lo_1),
      fine_v_n_c_left_rest_1 = ksl_product_rest(fine_v_y_0, fine_v_y_0, fine_v_n_a, fine_v_n_c
          - fine_v_n_c_right_1),
      fine_v_n_c_lo1_1 = fine_v_n_c_left_rest_1
          + ksl_product_rest(fine_v_y_1, fine_v_y_1, fine_v_n_b, fine_v_n_c_right_1),
      fine_v_n_d = KSL_MUL(fine_v_y_2, fine_v_y_2),
      fine_v_n_d_padded_1 = 1.8051943758648296e-276
          + KSL_MUL(fine_v_s_size_3, fine_v_s_size_padded_3),
      fine_v_n_d_reach_1 = fabs(fine_v_y_2)
          + KSL_MUL(140737488355328.0, fabs(fine_v_y_lo_3)
          + KSL_MUL(6.705320021857442e-30, fine_v_n_d_padded_1)),
      fine_v_n_d_size_2 = KSL_MUL(fine_v_n_d_padded_1, fine_v_n_d_reach_1),
      fine_v_n_e = fine_v_n_c + fine_v_n_d, fine_v_n_e_right_1 = fine_v_n_e - fine_v_n_c,
      fine_v_n_e_lo1_1 = fine_v_n_c - (fine_v_n_e - fine_v_n_e_right_1)
          + ksl_product_rest(fine_v_y_2, fine_v_y_2, fine_v_n_d, fine_v_n_e_right_1),
      fine_v_n_c_lo = fine_v_n_c_lo1_1
          + (fine_v_n_a_cross_1
          + (KSL_MUL(fine_v_y_lo_2, fine_v_y_1) + KSL_MUL(fine_v_y_1, fine_v_y_lo_2))),
      fine_v_n_e_lo = fine_v_n_e_lo1_1
          + (KSL_MUL(fine_v_y_lo_3, fine_v_y_2) + KSL_MUL(fine_v_y_2, fine_v_y_lo_3))
          + fine_v_n_c_lo, fine_v_n = sqrt(fine_v_n_e),
      fine_v_n_product_1 = KSL_MUL(fine_v_n, fine_v_n), fine_v_n_twice_1 = fine_v_n + fine_v_n,
      fine_v_n_residual_1 = fine_v_n_e - fine_v_n_product_1
          - ksl_product_error(fine_v_n, fine_v_n, fine_v_n_product_1) + fine_v_n_e_lo,
      fine_v_n_lo = fine_v_n_residual_1 / (fine_v_n == 0.0 ? 1.0 : fine_v_n_twice_1),
      fine_v_n_e_size_1 = fine_v_n_a_size_2 + fine_v_n_a_size_2
          + (fine_v_n_b_size_2 + fine_v_n_b_size_2) + (fine_v_n_d_size_2 + fine_v_n_d_size_2),
      fine_v_n_padded_1 = 1.8051943758648296e-276 + fine_v_n_e_size_1,
      fine_v_n_bound_1 = fabs(fine_v_n_e_lo) + KSL_MUL(1.150011758590251e-29, fine_v_n_padded_1),
      fine_v_n_size_4 = KSL_MUL(fabs(fine_v_n_e)
          + KSL_MUL(140737488355328.0, fine_v_n_bound_1), fine_v_n_padded_1 / fine_v_n
          / fine_v_n_e),
      fine_v_n_size_8 = KSL_MUL(1.1418664350501995e+29, sqrt(fine_v_n_bound_1) + fabs(fine_v_n_lo));
  const double fine_v_r_b = fine_v_s < 1.0 ? 2.6815615859885194e+154 : 1.0,
      fine_v_r_b_size_1 = fine_v_s < 1.0 ? 2.6815615859885194e+154 : 1.0,
      fine_v_r_d = 1.0 < fine_v_s ? 7.637340908749012e-152 : fine_v_r_b,
      fine_v_r_d_size_1 = 1.0 < fine_v_s ? 7.637340908749012e-152 : fine_v_r_b_size_1,
      fine_v_r = 1.3093562431584567e+151 < fine_v_s ? 9.332636185032189e-302 : fine_v_r_d;
  const double fine_n = KSL_MUL(fine_v_n, fine_v_r),
      fine_n_lo = KSL_MUL(fine_v_n - KSL_MUL(fine_n, 1.0 / fine_v_r) + fine_v_n_lo, fine_v_r),
      fine_n_padded_1 = 1.8051943758648296e-276
          + (fine_v_n
          + (KSL_MUL(4.0, fine_v_n_bound_1) < fine_v_n_e ? fine_v_n_size_4 : fine_v_n_size_8)),
      fine_n_size_1 = KSL_MUL(fine_n_padded_1, 1.3093562431584567e+151 < fine_v_s
          ? 9.332636185032189e-302 : fine_v_r_d_size_1);
  const double fine_half = ksl_atan2(fine_n, fine_upper_3), fine_half_size0_1 = fabs(fine_n),
      fine_half_size1_1 = fabs(fine_upper_3),
      fine_half_most_1 = fine_half_size0_1 < fine_half_size1_1 ? fine_half_size1_1
          : fine_half_size0_1,
      fine_half_divisor_1 = fine_half_most_1 == 0.0 ? 1.0 : fine_half_most_1,
      fine_half_part0_1 = fine_n / fine_half_divisor_1,
      fine_half_part1_1 = fine_upper_3 / fine_half_divisor_1,
      fine_half_divisor2_1 = KSL_MUL(fine_half_divisor_1, KSL_MUL(fine_half_part1_1,
          fine_half_part1_1) + KSL_MUL(fine_half_part0_1, fine_half_part0_1)),
      fine_half_cross_1 = KSL_MUL(fine_half_part1_1, fine_n_lo)
          - KSL_MUL(fine_half_part0_1, fine_upper_lo_4),
      fine_half_lo = ksl_atan2_error(fine_n, fine_upper_3, fine_half) + fine_half_cross_1
          / (fine_half_most_1 == 0.0 ? 1.0 : fine_half_divisor2_1),
      fine_half_padded_1 = 1.8051943758648296e-276 + fine_n_size_1,
      fine_half_padded_2 = 1.8051943758648296e-276
          + (fine_column_size_4
          + KSL_MUL(1.5845630613906556e+29, fabs(fine_upper_size_25) - fine_upper_size_25)),
      fine_half_size_2 = fabs(fine_n), fine_half_size_3 = fabs(fine_upper_3),
      fine_half_size_5 = fine_half_size_2 < fine_half_size_3 ? fine_half_size_3 : fine_half_size_2,
      fine_half_bound_1 = fabs(fine_n_lo) + KSL_MUL(9.423194733875307e-30, fine_half_padded_1),
      fine_half_bound_2 = fabs(fine_upper_lo_4)
          + KSL_MUL(6.508104019725916e-30, fine_half_padded_2),
      fine_half_size_11 = (fine_half_bound_2 + (1.8051943758648296e-276 + fine_half_bound_1))
          / fine_half_size_5, fine_half_size_13 = KSL_MUL(fine_half_size_11, fine_half_size_11),
      fine_half_size_15 = 7.0 + fabs(fine_half_lo),
      fine_half_size_18 = fine_half_bound_2 < fine_upper_3 ? fine_half_size_13 : fine_half_size_15,
      fine_half_size_19 = fine_half_bound_1 < fine_half_size_2 ? fine_half_size_13
          : fine_half_size_18,
      fine_half_size_21 = KSL_MUL(4.527322338646221e+28, fine_half_size_11 < 0.25
          ? fine_half_size_19 : fine_half_size_15);
  const double fine_divisor = fine_n == 0.0 ? 1.0 : fine_n,
      fine_divisor_lo = fine_n == 0.0 ? 0.0 : fine_n_lo,
      fine_divisor_size_8 = fabs(1.0 - fine_n) + fine_half_bound_1,
      fine_divisor_size_10 = KSL_MUL(6.338250583290453e+28, fine_half_bound_1 < 5e-324
          + fabs(fine_n - 0.0) ? 0.0 : fine_divisor_size_8);
  const double fine_theta = KSL_MUL(2.0, fine_half),
      fine_theta_cross2_1 = KSL_MUL(2.0, fine_half_lo),
      fine_theta_size_1 = KSL_MUL(2.0, fabs(fine_half) + (fine_half_padded_1 + fine_half_padded_2)
          / fine_half_size_5 + fine_half_size_21);
  const double fine_k = fine_theta / fine_divisor, fine_k_product_1 = KSL_MUL(fine_k, fine_divisor),
      fine_k_numerator_1 = fine_theta - fine_k_product_1
          - ksl_product_error(fine_k, fine_divisor, fine_k_product_1) + fine_theta_cross2_1,
      fine_k_lo = (fine_k_numerator_1 - KSL_MUL(fine_k, fine_divisor_lo)) / fine_divisor,
      fine_k_padded_2 = 1.8051943758648296e-276
          + ((fine_n == 0.0 ? 1.0 : fine_n_size_1) + fine_divisor_size_10),
      fine_k_size_1 = fabs(fine_k), fine_k_size_2 = fabs(fine_divisor),
      fine_k_bound_1 = fabs(fine_divisor_lo) + KSL_MUL(1.6270263928446146e-29, fine_k_padded_2),
      fine_k_size_4 = 1.8051943758648296e-276 + fine_theta_size_1
          + KSL_MUL(fine_k_padded_2, fine_k_size_1),
      fine_k_size_8 = fine_k_size_4
          / (KSL_MUL(4.0, fine_k_bound_1) < fine_k_size_2 ? fine_k_size_2 : 0.0);
  const double fine_vector_0 = KSL_MUL(fine_upper_0, fine_k);
  const double fine_k_size_11 = fine_k_size_1
          + KSL_MUL(fine_k_size_2 + KSL_MUL(140737488355328.0, fine_k_bound_1), fine_k_size_8)
          / fine_k_size_2;
  const double fine_vector_padded_1 = 1.8051943758648296e-276 + fine_k_size_11,
      fine_vector_reach_1 = fabs(fine_upper_0)
          + KSL_MUL(140737488355328.0, fabs(fine_upper_lo_1)
          + KSL_MUL(6.508104019725916e-30, fine_v_s_size_padded_1)),
      fine_vector_reach_2 = fine_k_size_1
          + KSL_MUL(140737488355328.0, fabs(fine_k_lo)
          + KSL_MUL(3.316915129670074e-29, fine_vector_padded_1));
  const double fine_vector_1 = KSL_MUL(fine_upper_1, fine_k),
      fine_vector_reach_3 = fabs(fine_upper_1)
          + KSL_MUL(140737488355328.0, fabs(fine_upper_lo_2)
          + KSL_MUL(6.508104019725916e-30, fine_v_s_size_padded_2));
  const double fine_vector_2 = KSL_MUL(fine_upper_2, fine_k),
      fine_vector_reach_4 = fabs(fine_upper_2)
          + KSL_MUL(140737488355328.0, fabs(fine_upper_lo_3)
          + KSL_MUL(6.508104019725916e-30, fine_v_s_size_padded_3));
  const double half_angle = KSL_MUL(0.5, fine_theta),
      half_angle_cross2_1 = KSL_MUL(0.5, fine_theta_cross2_1),
      half_angle_size_1 = KSL_MUL(0.5, fine_theta_size_1);
  const double length_a = KSL_MUL(fine_n, fine_n),
      length_a_size_1 = KSL_MUL(fine_half_padded_1, fine_half_size_2
          + KSL_MUL(140737488355328.0, fine_half_bound_1)),
      length_b = KSL_MUL(fine_upper_3, fine_upper_3),
      length_b_size_1 = KSL_MUL(fine_half_padded_2, fine_half_size_3
          + KSL_MUL(140737488355328.0, fine_half_bound_2)), length_c = length_a + length_b,
      length_c_right_1 = length_c - length_a,
      length_b_cross_1 = KSL_MUL(fine_upper_lo_4, fine_upper_3)
          + KSL_MUL(fine_upper_3, fine_upper_lo_4),
      length_c_right_rest_1 = ksl_product_rest(fine_upper_3, fine_upper_3, length_b,
          length_c_right_1),
      length_c_lo1_1 = ksl_product_rest(fine_n, fine_n, length_a, length_c - length_c_right_1)
          + length_c_right_rest_1,
      length_c_lo = length_c_lo1_1
          + (KSL_MUL(fine_n_lo, fine_n) + KSL_MUL(fine_n, fine_n_lo) + length_b_cross_1),
      length = sqrt(length_c), length_product_1 = KSL_MUL(length, length),
      length_twice_1 = length + length,
      length_lo = (length_c - length_product_1
          - ksl_product_error(length, length, length_product_1) + length_c_lo)
          / (length == 0.0 ? 1.0 : length_twice_1),
      length_padded_1 = 1.8051943758648296e-276
          + (length_a_size_1 + length_a_size_1 + (length_b_size_1 + length_b_size_1)),
      length_bound_1 = fabs(length_c_lo) + KSL_MUL(1.4883595920139876e-29, length_padded_1),
      length_size_4 = KSL_MUL(fabs(length_c)
          + KSL_MUL(140737488355328.0, length_bound_1), length_padded_1 / length / length_c),
      length_size_6 = fabs(length_lo),
      length_size_8 = KSL_MUL(9.248172776624906e+28, sqrt(length_bound_1) + length_size_6);
  const double sine = fine_n / length, sine_product_1 = KSL_MUL(sine, length),
      sine_padded_1 = 1.8051943758648296e-276
          + (length + (KSL_MUL(4.0, length_bound_1) < length_c ? length_size_4 : length_size_8)),
      sine_size_1 = fabs(sine), sine_size_2 = fabs(length),
      sine_bound_1 = length_size_6 + KSL_MUL(1.1256681545564732e-29, sine_padded_1),
      sine_size_7 = KSL_MUL(4.0, sine_bound_1) < sine_size_2 ? sine_size_2 : 0.0,
      sine_reach_1 = sine_size_2 + KSL_MUL(140737488355328.0, sine_bound_1);
  const double c = fine_upper_3 / length, c_product_1 = KSL_MUL(c, length),
      c_lo = (fine_upper_3 - c_product_1 - ksl_product_error(c, length, c_product_1)
          + fine_upper_lo_4 - KSL_MUL(c, length_lo)) / length, c_size_1 = fabs(c),
      c_size_7 = c_size_1
          + KSL_MUL((KSL_MUL(c_size_1, sine_padded_1) + fine_half_padded_2)
          / sine_size_7, sine_reach_1) / sine_size_2;
  const double y = KSL_MUL(half_angle, half_angle),
      y_padded_1 = 1.8051943758648296e-276 + half_angle_size_1,
      y_bound_1 = fabs(half_angle_cross2_1) + KSL_MUL(2.357955640370947e-29, y_padded_1),
      y_size_2 = KSL_MUL(y_padded_1, fabs(half_angle) + KSL_MUL(140737488355328.0, y_bound_1)),
      y_size_3 = y_size_2 + y_size_2;
  const double sinc_divisor = half_angle < 1.4901161193847656e-08 ? 1.4901161193847656e-08
          : half_angle,
      sinc_divisor_lo = half_angle < 1.4901161193847656e-08 ? 0.0 : half_angle_cross2_1,
      sinc_divisor_size_3 = fabs(half_angle - 1.4901161193847656e-08),
      sinc_divisor_size_7 = fabs(1.4901161193847656e-08 - half_angle) + y_bound_1,
      sinc_divisor_size_9 = KSL_MUL(3.5212501748002707e+28, y_bound_1 < sinc_divisor_size_3 ? 0.0
          : sinc_divisor_size_7);
  const double sinc_quotient = sine / sinc_divisor,
      sinc_quotient_product_1 = KSL_MUL(sinc_quotient, sinc_divisor);
  const double sine_lo = (fine_n - sine_product_1 - ksl_product_error(sine, length, sine_product_1)
          + fine_n_lo - KSL_MUL(sine, length_lo)) / length;
  const double sinc_quotient_numerator_1 = sine - sinc_quotient_product_1
          - ksl_product_error(sinc_quotient, sinc_divisor, sinc_quotient_product_1) + sine_lo,
      sinc_quotient_lo = (sinc_quotient_numerator_1 - KSL_MUL(sinc_quotient, sinc_divisor_lo))
          / sinc_divisor;
  const double sine_size_11 = sine_size_1
          + KSL_MUL(sine_reach_1, (fine_half_padded_1 + KSL_MUL(sine_padded_1, sine_size_1))
          / sine_size_7) / sine_size_2;
  const double sinc_divisor_size_10 = (half_angle < 1.4901161193847656e-08 ? 1.4901161193847656e-08
          : half_angle_size_1) + sinc_divisor_size_9;
  const double sinc_quotient_padded_2 = 1.8051943758648296e-276 + sinc_divisor_size_10,
      sinc_quotient_size_1 = fabs(sinc_quotient), sinc_quotient_size_2 = fabs(sinc_divisor),
      sinc_quotient_bound_1 = fabs(sinc_divisor_lo)
          + KSL_MUL(2.9286476622855606e-29, sinc_quotient_padded_2),
      sinc_quotient_size_4 = 1.8051943758648296e-276 + sine_size_11
          + KSL_MUL(sinc_quotient_padded_2, sinc_quotient_size_1),
      sinc_quotient_size_8 = sinc_quotient_size_4
          / (KSL_MUL(4.0, sinc_quotient_bound_1) < sinc_quotient_size_2 ? sinc_quotient_size_2
          : 0.0),
      sinc_quotient_size_10 = KSL_MUL(sinc_quotient_size_2
          + KSL_MUL(140737488355328.0, sinc_quotient_bound_1), sinc_quotient_size_8)
          / sinc_quotient_size_2,
      sinc_quotient_size_11 = sinc_quotient_size_1 + sinc_quotient_size_10;
  const double y_lo = ksl_product_error(half_angle, half_angle, y)
          + (KSL_MUL(half_angle_cross2_1, half_angle) + KSL_MUL(half_angle, half_angle_cross2_1)),
      sinc_a = KSL_MUL(0.16666666666666666, y), sinc_b = 1.0 - sinc_a,
      sinc_b_right_1 = 1.0 - sinc_b,
      sinc_b_lo1_1 = 1.0 - (sinc_b + sinc_b_right_1)
          - ksl_product_rest(0.16666666666666666, y, sinc_a, sinc_b_right_1),
      sinc_b_lo = sinc_b_lo1_1
          - (KSL_MUL(9.25185853854297e-18, y) + KSL_MUL(0.16666666666666666, y_lo)),
      sinc_b_size_1 = 1.0 + KSL_MUL(2290649224.7000003, y_size_3),
      sinc = half_angle < 1.4901161193847656e-08 ? sinc_b : sinc_quotient,
      sinc_lo = half_angle < 1.4901161193847656e-08 ? sinc_b_lo : sinc_quotient_lo,
      sinc_size_4 = fabs(sinc_b_lo)
          + KSL_MUL(8.413326746211277e-28, 1.8051943758648296e-276 + sinc_b_size_1)
          + fabs(sinc_b - sinc_quotient),
      sinc_size_5 = fabs(sinc_quotient_lo)
          + KSL_MUL(4.0396275823465884e-29, 1.8051943758648296e-276 + sinc_quotient_size_11)
          + sinc_size_4,
      sinc_size_7 = KSL_MUL(1.1904042348031753e+27, y_bound_1 < sinc_divisor_size_3 ? 0.0
          : sinc_size_5),
      sinc_size_8 = (half_angle < 1.4901161193847656e-08 ? sinc_b_size_1 : sinc_quotient_size_11)
          + sinc_size_7;
  const double series_phi_a = KSL_MUL(5.107725174524775e-32, y),
      series_phi_b = 4.116826490666969e-29 - series_phi_a,
      series_phi_b_right_1 = 4.116826490666969e-29 - series_phi_b,
      series_phi_b_right_rest_1 = ksl_product_rest(5.107725174524775e-32, y, series_phi_a,
          series_phi_b_right_1),
      series_phi_b_lo1_1 = 4.116826490666969e-29 - (series_phi_b + series_phi_b_right_1)
          - series_phi_b_right_rest_1,
      series_phi_b_lo = series_phi_b_lo1_1
          - (KSL_MUL(4.7410392187559056e-48, y) + KSL_MUL(5.107725174524775e-32, y_lo)) +
          -1.8714974010023092e-45, series_phi_c = KSL_MUL(y, series_phi_b),
      series_phi_c_padded_1 = 1.8051943758648296e-276 + y_size_3,
      series_phi_c_padded_2 = 1.8051943758648296e-276
          + (4.116826490666969e-29 + KSL_MUL(6.843135825984986e-08, y_size_3)),
      series_phi_c_bound_1 = fabs(y_lo) + KSL_MUL(3.113536936946736e-29, series_phi_c_padded_1),
      series_phi_c_reach_1 = fabs(y) + KSL_MUL(140737488355328.0, series_phi_c_bound_1),
      series_phi_c_reach_2 = fabs(series_phi_b)
          + KSL_MUL(140737488355328.0, fabs(series_phi_b_lo)
          + KSL_MUL(8.413326746211277e-28, series_phi_c_padded_2)),
      series_phi_d = series_phi_c - 2.86531123750421e-26,
      series_phi_d_right_1 = series_phi_c - series_phi_d,
      series_phi_d_left_rest_1 = ksl_product_rest(y, series_phi_b, series_phi_c, series_phi_d
          + series_phi_d_right_1),
      series_phi_d_lo2_1 = series_phi_d_left_rest_1 - (2.86531123750421e-26 - series_phi_d_right_1)
          - 2.3296034284323186e-42,
      series_phi_d_lo = series_phi_d_lo2_1
          + (KSL_MUL(y_lo, series_phi_b) + KSL_MUL(y, series_phi_b_lo)),
      series_phi_c_size_5 = KSL_MUL(series_phi_c_padded_2, series_phi_c_reach_1)
          + KSL_MUL(series_phi_c_padded_1, series_phi_c_reach_2),
      series_phi_e = KSL_MUL(y, series_phi_d),
      series_phi_e_padded_1 = 1.8051943758648296e-276
          + (2.86531123750421e-26 + series_phi_c_size_5),
      series_phi_e_reach_1 = fabs(series_phi_d)
          + KSL_MUL(140737488355328.0, fabs(series_phi_d_lo)
          + KSL_MUL(8.516250370250066e-28, series_phi_e_padded_1)),
      series_phi_f = series_phi_e + 1.701994875077501e-23,
      series_phi_f_right_1 = series_phi_f - series_phi_e,
      series_phi_f_left_rest_1 = ksl_product_rest(y, series_phi_d, series_phi_e, series_phi_f
          - series_phi_f_right_1),
      series_phi_f_lo2_1 = series_phi_f_left_rest_1
          + (1.701994875077501e-23 - series_phi_f_right_1) + 3.161967936521494e-40,
      series_phi_f_lo = series_phi_f_lo2_1
          + (KSL_MUL(y_lo, series_phi_d) + KSL_MUL(y, series_phi_d_lo)),
      series_phi_e_size_4 = KSL_MUL(series_phi_c_reach_1, series_phi_e_padded_1)
          + KSL_MUL(series_phi_c_padded_1, series_phi_e_reach_1),
      series_phi_g = KSL_MUL(y, series_phi_f),
      series_phi_g_padded_1 = 1.8051943758648296e-276
          + (1.701994875077501e-23 + series_phi_e_size_4),
      series_phi_g_reach_1 = fabs(series_phi_f)
          + KSL_MUL(140737488355328.0, fabs(series_phi_f_lo)
          + KSL_MUL(8.621392666525187e-28, series_phi_g_padded_1)),
      series_phi_h = series_phi_g - 8.509974375387505e-21,
      series_phi_h_right_1 = series_phi_g - series_phi_h,
      series_phi_h_left_rest_1 = ksl_product_rest(y, series_phi_f, series_phi_g, series_phi_h
          + series_phi_h_right_1),
      series_phi_h_lo2_1 = series_phi_h_left_rest_1
          - (8.509974375387505e-21 - series_phi_h_right_1) - 3.2266760594119493e-37,
      series_phi_h_lo = series_phi_h_lo2_1
          + (KSL_MUL(y_lo, series_phi_f) + KSL_MUL(y, series_phi_f_lo)),
      series_phi_g_size_4 = KSL_MUL(series_phi_c_reach_1, series_phi_g_padded_1)
          + KSL_MUL(series_phi_c_padded_1, series_phi_g_reach_1),
      series_phi_i = KSL_MUL(y, series_phi_h),
      series_phi_i_padded_1 = 1.8051943758648296e-276
          + (8.509974375387505e-21 + series_phi_g_size_4),
      series_phi_i_reach_1 = fabs(series_phi_h)
          + KSL_MUL(140737488355328.0, fabs(series_phi_h_lo)
          + KSL_MUL(8.728753635036635e-28, series_phi_i_padded_1)),
      series_phi_j = series_phi_i + 3.523129391410427e-18,
      series_phi_j_right_1 = series_phi_j - series_phi_i,
      series_phi_j_left_rest_1 = ksl_product_rest(y, series_phi_h, series_phi_i, series_phi_j
          - series_phi_j_right_1),
      series_phi_j_lo2_1 = series_phi_j_left_rest_1
          + (3.523129391410427e-18 - series_phi_j_right_1) + -1.2521244741738012e-34,
      series_phi_j_lo = series_phi_j_lo2_1
          + (KSL_MUL(y_lo, series_phi_h) + KSL_MUL(y, series_phi_h_lo)),
      series_phi_i_size_4 = KSL_MUL(series_phi_c_reach_1, series_phi_i_padded_1)
          + KSL_MUL(series_phi_c_padded_1, series_phi_i_reach_1),
      series_phi_k = KSL_MUL(y, series_phi_j),
      series_phi_k_padded_1 = 1.8051943758648296e-276
          + (3.523129391410427e-18 + series_phi_i_size_4),
      series_phi_k_reach_1 = fabs(series_phi_j)
          + KSL_MUL(140737488355328.0, fabs(series_phi_j_lo)
          + KSL_MUL(8.838333274844017e-28, series_phi_k_padded_1)),
      series_phi_l = series_phi_k - 1.1837714755139035e-15,
      series_phi_l_right_1 = series_phi_k - series_phi_l,
      series_phi_l_left_rest_1 = ksl_product_rest(y, series_phi_j, series_phi_k, series_phi_l
          + series_phi_l_right_1),
      series_phi_l_lo2_1 = series_phi_l_left_rest_1
          - (1.1837714755139035e-15 - series_phi_l_right_1) - 7.23242424407352e-33,
      series_phi_l_lo = series_phi_l_lo2_1
          + (KSL_MUL(y_lo, series_phi_j) + KSL_MUL(y, series_phi_j_lo)),
      series_phi_k_size_4 = KSL_MUL(series_phi_c_reach_1, series_phi_k_padded_1)
          + KSL_MUL(series_phi_c_padded_1, series_phi_k_reach_1),
      series_phi_m = KSL_MUL(y, series_phi_l),
      series_phi_m_padded_1 = 1.8051943758648296e-276
          + (1.1837714755139035e-15 + series_phi_k_size_4),
      series_phi_m_reach_1 = fabs(series_phi_l)
          + KSL_MUL(140737488355328.0, fabs(series_phi_l_lo)
          + KSL_MUL(8.950131585947334e-28, series_phi_m_padded_1)),
      series_phi_n = series_phi_m + 3.148832124866983e-13,
      series_phi_n_right_1 = series_phi_n - series_phi_m,
      series_phi_n_left_rest_1 = ksl_product_rest(y, series_phi_l, series_phi_m, series_phi_n
          - series_phi_n_right_1),
      series_phi_n_lo2_1 = series_phi_n_left_rest_1
          + (3.148832124866983e-13 - series_phi_n_right_1) + 5.8681293750286156e-30,
      series_phi_n_lo = series_phi_n_lo2_1
          + (KSL_MUL(y_lo, series_phi_l) + KSL_MUL(y, series_phi_l_lo)),
      series_phi_m_size_4 = KSL_MUL(series_phi_c_reach_1, series_phi_m_padded_1)
          + KSL_MUL(series_phi_c_padded_1, series_phi_m_reach_1),
      series_phi_o = KSL_MUL(y, series_phi_n),
      series_phi_o_padded_1 = 1.8051943758648296e-276
          + (3.148832124866983e-13 + series_phi_m_size_4),
      series_phi_o_reach_1 = fabs(series_phi_n)
          + KSL_MUL(140737488355328.0, fabs(series_phi_n_lo)
          + KSL_MUL(9.064148568346586e-28, series_phi_o_padded_1)),
      series_phi_p = series_phi_o - 6.423617534728645e-11,
      series_phi_p_right_1 = series_phi_o - series_phi_p,
      series_phi_p_left_rest_1 = ksl_product_rest(y, series_phi_n, series_phi_o, series_phi_p
          + series_phi_p_right_1),
      series_phi_p_lo2_1 = series_phi_p_left_rest_1
          - (6.423617534728645e-11 - series_phi_p_right_1) - 5.034117835500839e-27,
      series_phi_p_lo = series_phi_p_lo2_1
          + (KSL_MUL(y_lo, series_phi_n) + KSL_MUL(y, series_phi_n_lo)),
      series_phi_o_size_4 = KSL_MUL(series_phi_c_reach_1, series_phi_o_padded_1)
          + KSL_MUL(series_phi_c_padded_1, series_phi_o_reach_1),
      series_phi_q = KSL_MUL(y, series_phi_p),
      series_phi_q_padded_1 = 1.8051943758648296e-276
          + (6.423617534728645e-11 + series_phi_o_size_4),
      series_phi_q_reach_1 = fabs(series_phi_p)
          + KSL_MUL(140737488355328.0, fabs(series_phi_p_lo)
          + KSL_MUL(9.180384222041771e-28, series_phi_q_padded_1)),
      series_phi_r = series_phi_q + 9.635426302092969e-09,
      series_phi_r_right_1 = series_phi_r - series_phi_q,
      series_phi_r_left_rest_1 = ksl_product_rest(y, series_phi_p, series_phi_q, series_phi_r
          - series_phi_r_right_1),
      series_phi_r_lo2_1 = series_phi_r_left_rest_1
          + (9.635426302092969e-09 - series_phi_r_right_1) + -1.7546051379703029e-25,
      series_phi_r_lo = series_phi_r_lo2_1
          + (KSL_MUL(y_lo, series_phi_p) + KSL_MUL(y, series_phi_p_lo)),
      series_phi_q_size_4 = KSL_MUL(series_phi_c_reach_1, series_phi_q_padded_1)
          + KSL_MUL(series_phi_c_padded_1, series_phi_q_reach_1),
      series_phi_s = KSL_MUL(y, series_phi_r),
      series_phi_s_padded_1 = 1.8051943758648296e-276
          + (9.635426302092969e-09 + series_phi_q_size_4),
      series_phi_s_reach_1 = fabs(series_phi_r)
          + KSL_MUL(140737488355328.0, fabs(series_phi_r_lo)
          + KSL_MUL(9.29883854703289e-28, series_phi_s_padded_1)),
      series_phi_t = series_phi_s - 1.0020843354176687e-06,
      series_phi_t_right_1 = series_phi_s - series_phi_t,
      series_phi_t_left_rest_1 = ksl_product_rest(y, series_phi_r, series_phi_s, series_phi_t
          + series_phi_t_right_1),
      series_phi_t_lo2_1 = series_phi_t_left_rest_1
          - (1.0020843354176687e-06 - series_phi_t_right_1) - 4.7926555569351065e-23,
      series_phi_t_lo = series_phi_t_lo2_1
          + (KSL_MUL(y_lo, series_phi_r) + KSL_MUL(y, series_phi_r_lo)),
      series_phi_s_size_4 = KSL_MUL(series_phi_c_reach_1, series_phi_s_padded_1)
          + KSL_MUL(series_phi_c_padded_1, series_phi_s_reach_1),
      series_phi_u = KSL_MUL(y, series_phi_t),
      series_phi_u_padded_1 = 1.8051943758648296e-276
          + (1.0020843354176687e-06 + series_phi_s_size_4),
      series_phi_u_reach_1 = fabs(series_phi_t)
          + KSL_MUL(140737488355328.0, fabs(series_phi_t_lo)
          + KSL_MUL(9.419511543319943e-28, series_phi_u_padded_1)),
      series_phi_v = series_phi_u + 6.613756613756614e-05,
      series_phi_v_right_1 = series_phi_v - series_phi_u,
      series_phi_v_left_rest_1 = ksl_product_rest(y, series_phi_t, series_phi_u, series_phi_v
          - series_phi_v_right_1),
      series_phi_v_lo2_1 = series_phi_v_left_rest_1
          + (6.613756613756614e-05 - series_phi_v_right_1) + -4.460143857711533e-21,
      series_phi_v_lo = series_phi_v_lo2_1
          + (KSL_MUL(y_lo, series_phi_t) + KSL_MUL(y, series_phi_t_lo)),
      series_phi_u_size_4 = KSL_MUL(series_phi_c_reach_1, series_phi_u_padded_1)
          + KSL_MUL(series_phi_c_padded_1, series_phi_u_reach_1),
      series_phi_w = KSL_MUL(y, series_phi_v),
      series_phi_w_padded_1 = 1.8051943758648296e-276
          + (6.613756613756614e-05 + series_phi_u_size_4),
      series_phi_w_reach_1 = fabs(series_phi_v)
          + KSL_MUL(140737488355328.0, fabs(series_phi_v_lo)
          + KSL_MUL(9.542403214664514e-28, series_phi_w_padded_1)),
      series_phi_x = series_phi_w - 0.002380952380952381,
      series_phi_x_right_1 = series_phi_w - series_phi_x,
      series_phi_x_left_rest_1 = ksl_product_rest(y, series_phi_v, series_phi_w, series_phi_x
          + series_phi_x_right_1),
      series_phi_x_lo2_1 = series_phi_x_left_rest_1 - (0.002380952380952381 - series_phi_x_right_1)
          - -2.147752875018904e-19,
      series_phi_x_lo = series_phi_x_lo2_1
          + (KSL_MUL(y_lo, series_phi_v) + KSL_MUL(y, series_phi_v_lo)),
      series_phi_w_size_4 = KSL_MUL(series_phi_c_reach_1, series_phi_w_padded_1)
          + KSL_MUL(series_phi_c_padded_1, series_phi_w_reach_1),
      series_phi_y = KSL_MUL(y, series_phi_x),
      series_phi_y_padded_1 = 1.8051943758648296e-276
          + (0.002380952380952381 + series_phi_w_size_4),
      series_phi_y_reach_1 = fabs(series_phi_x)
          + KSL_MUL(140737488355328.0, fabs(series_phi_x_lo)
          + KSL_MUL(9.667513557305017e-28, series_phi_y_padded_1)),
      series_phi = series_phi_y + 0.03333333333333333,
      series_phi_right_1 = series_phi - series_phi_y,
      series_phi_lo1_1 = ksl_product_rest(y, series_phi_x, series_phi_y, series_phi
          - series_phi_right_1) + (0.03333333333333333 - series_phi_right_1),
      series_phi_lo = series_phi_lo1_1 + 4.625929269271486e-19
          + (KSL_MUL(y_lo, series_phi_x) + KSL_MUL(y, series_phi_x_lo)),
      series_phi_y_size_4 = KSL_MUL(series_phi_c_reach_1, series_phi_y_padded_1)
          + KSL_MUL(series_phi_c_padded_1, series_phi_y_reach_1);
  const double f_more_a = KSL_MUL(2.0, y), f_more_a_cross2_1 = KSL_MUL(2.0, y_lo),
      f_more = KSL_MUL(f_more_a, series_phi),
      f_more_padded_1 = 1.8051943758648296e-276 + KSL_MUL(2.0, y_size_3),
      f_more_padded_2 = 1.8051943758648296e-276 + (0.03333333333333333 + series_phi_y_size_4),
      f_more_reach_1 = fabs(f_more_a)
          + KSL_MUL(140737488355328.0, fabs(f_more_a_cross2_1)
          + KSL_MUL(3.162841053853558e-29, f_more_padded_1)),
      f_more_reach_2 = fabs(series_phi)
          + KSL_MUL(140737488355328.0, fabs(series_phi_lo)
          + KSL_MUL(9.794842571241454e-28, f_more_padded_2));
  const double near_f_a = KSL_MUL(0.3333333333333333, sinc),
      near_f_b = KSL_MUL(0.3333333333333333, f_more),
      f_more_lo = ksl_product_error(f_more_a, series_phi, f_more)
          + (KSL_MUL(f_more_a_cross2_1, series_phi) + KSL_MUL(f_more_a, series_phi_lo)),
      near_f = near_f_a + near_f_b, near_f_right_1 = near_f - near_f_a,
      near_f_b_cross_1 = KSL_MUL(1.850371707708594e-17, f_more)
          + KSL_MUL(0.3333333333333333, f_more_lo),
      near_f_left_rest_1 = ksl_product_rest(0.3333333333333333, sinc, near_f_a, near_f
          - near_f_right_1),
      near_f_cross_1 = KSL_MUL(1.850371707708594e-17, sinc) + KSL_MUL(0.3333333333333333, sinc_lo)
          + near_f_b_cross_1,
      near_f_lo = near_f_left_rest_1
          + ksl_product_rest(0.3333333333333333, f_more, near_f_b, near_f_right_1) + near_f_cross_1,
      near_f_b_size_1 = KSL_MUL(0.3333333333333333, KSL_MUL(f_more_padded_2, f_more_reach_1)
          + KSL_MUL(f_more_padded_1, f_more_reach_2)),
      near_f_size_1 = KSL_MUL(0.3333333333333333, sinc_size_8) + near_f_b_size_1;
  const double f_rest = sinc - c, f_rest_right_1 = sinc - f_rest;
  const double fine_x = KSL_MUL(4.0, y);
  const double far_y = fine_x < 4.0 ? 1.0 : y, far_y_lo = fine_x < 4.0 ? 0.0 : y_lo,
      far_y_bound_1 = fabs(KSL_MUL(4.0, y_lo))
          + KSL_MUL(3.162841053853558e-29, 1.8051943758648296e-276 + KSL_MUL(4.0, y_size_3)),
      far_y_size_3 = fabs(fine_x - 4.0), far_y_size_7 = fabs(1.0 - y) + series_phi_c_bound_1;
  const double closed_f = f_rest / far_y, closed_f_product_1 = KSL_MUL(closed_f, far_y),
      closed_f_exact_1 = f_rest - closed_f_product_1
          - ksl_product_error(closed_f, far_y, closed_f_product_1),
      closed_f_lo = (closed_f_exact_1
          + (sinc - (f_rest + f_rest_right_1) - (c - f_rest_right_1) - c_lo + sinc_lo)
          - KSL_MUL(closed_f, far_y_lo)) / far_y;
  const double far_y_size_10 = (fine_x < 4.0 ? 1.0 : y_size_3)
          + KSL_MUL(3.169124989414031e+28, far_y_bound_1 < far_y_size_3 ? 0.0 : far_y_size_7);
  const double closed_f_padded_2 = 1.8051943758648296e-276 + far_y_size_10,
      closed_f_size_1 = fabs(closed_f), closed_f_size_2 = fabs(far_y),
      closed_f_bound_1 = fabs(far_y_lo) + KSL_MUL(3.254053096019738e-29, closed_f_padded_2),
      closed_f_size_4 = 1.8051943758648296e-276 + (c_size_7 + sinc_size_8)
          + KSL_MUL(closed_f_padded_2, closed_f_size_1),
      closed_f_size_8 = closed_f_size_4
          / (KSL_MUL(4.0, closed_f_bound_1) < closed_f_size_2 ? closed_f_size_2 : 0.0),
      closed_f_size_11 = closed_f_size_1
          + KSL_MUL(closed_f_size_2
          + KSL_MUL(140737488355328.0, closed_f_bound_1), closed_f_size_8) / closed_f_size_2;
  const double f = fine_x < 4.0 ? near_f : closed_f,
      f_size_4 = fabs(near_f_lo)
          + KSL_MUL(9.955206102310575e-28, 1.8051943758648296e-276 + near_f_size_1)
          + fabs(near_f - closed_f),
      f_size_5 = fabs(closed_f_lo)
          + KSL_MUL(8.596739798391267e-28, 1.8051943758648296e-276 + closed_f_size_11) + f_size_4;
  const double four_k = KSL_MUL(4.0, sinc), four_k_cross2_1 = KSL_MUL(4.0, sinc_lo);
  const double fine_b = f / four_k, fine_b_product_1 = KSL_MUL(fine_b, four_k),
      fine_b_numerator_1 = f - fine_b_product_1
          - ksl_product_error(fine_b, four_k, fine_b_product_1)
          + (fine_x < 4.0 ? near_f_lo : closed_f_lo),
      fine_b_lo = (fine_b_numerator_1 - KSL_MUL(fine_b, four_k_cross2_1)) / four_k;
  const double f_size_8 = (fine_x < 4.0 ? near_f_size_1 : closed_f_size_11)
          + KSL_MUL(1.0085955631004589e+27, far_y_bound_1 < far_y_size_3 ? 0.0 : f_size_5);
  const double fine_b_padded_2 = 1.8051943758648296e-276 + KSL_MUL(4.0, sinc_size_8),
      fine_b_size_1 = fabs(fine_b), fine_b_size_2 = fabs(four_k),
      fine_b_bound_1 = fabs(four_k_cross2_1) + KSL_MUL(8.41936839032761e-28, fine_b_padded_2),
      fine_b_size_4 = 1.8051943758648296e-276 + f_size_8 + KSL_MUL(fine_b_padded_2, fine_b_size_1),
      fine_b_size_8 = fine_b_size_4
          / (KSL_MUL(4.0, fine_b_bound_1) < fine_b_size_2 ? fine_b_size_2 : 0.0);
  const double fine_b_across = c / sinc, fine_b_across_product_1 = KSL_MUL(fine_b_across, sinc),
      fine_b_across_numerator_1 = c - fine_b_across_product_1
          - ksl_product_error(fine_b_across, sinc, fine_b_across_product_1) + c_lo,
      fine_b_across_lo = (fine_b_across_numerator_1 - KSL_MUL(fine_b_across, sinc_lo)) / sinc,
      fine_b_across_padded_2 = 1.8051943758648296e-276 + sinc_size_8,
      fine_b_across_size_1 = fabs(fine_b_across), fine_b_across_size_2 = fabs(sinc),
      fine_b_across_bound_1 = fabs(sinc_lo)
          + KSL_MUL(8.413327710116644e-28, fine_b_across_padded_2),
      fine_b_across_size_4 = 1.8051943758648296e-276 + c_size_7
          + KSL_MUL(fine_b_across_padded_2, fine_b_across_size_1),
      fine_b_across_size_8 = fine_b_across_size_4
          / (KSL_MUL(4.0, fine_b_across_bound_1) < fine_b_across_size_2 ? fine_b_across_size_2
          : 0.0),
      fine_b_across_size_10 = KSL_MUL(fine_b_across_size_2
          + KSL_MUL(140737488355328.0, fine_b_across_bound_1), fine_b_across_size_8)
          / fine_b_across_size_2;
  const double fine_vector_lo_1 = ksl_product_error(fine_upper_0, fine_k, fine_vector_0)
          + (KSL_MUL(fine_upper_lo_1, fine_k) + KSL_MUL(fine_upper_0, fine_k_lo)),
      fine_wt_a = KSL_MUL(D->m03, fine_vector_0), fine_wt_a_size_1 = fabs(D->m03);
  const double fine_vector_size_4 = KSL_MUL(fine_vector_padded_1, fine_vector_reach_1)
          + KSL_MUL(fine_v_s_size_padded_1, fine_vector_reach_2);
  const double fine_wt_a_padded_1 = 1.8051943758648296e-276 + fine_vector_size_4,
      fine_vector_lo_2 = ksl_product_error(fine_upper_1, fine_k, fine_vector_1)
          + (KSL_MUL(fine_upper_lo_2, fine_k) + KSL_MUL(fine_upper_1, fine_k_lo)),
      fine_wt_b = KSL_MUL(D->m13, fine_vector_1), fine_wt_b_size_1 = fabs(D->m13);
  const double fine_vector_size_8 = KSL_MUL(fine_vector_padded_1, fine_vector_reach_3)
          + KSL_MUL(fine_v_s_size_padded_2, fine_vector_reach_2);
  const double fine_wt_b_padded_1 = 1.8051943758648296e-276 + fine_vector_size_8,
      fine_wt_c = fine_wt_a + fine_wt_b, fine_wt_c_right_1 = fine_wt_c - fine_wt_a,
      fine_wt_c_left_rest_1 = ksl_product_rest(D->m03, fine_vector_0, fine_wt_a, fine_wt_c
          - fine_wt_c_right_1),
      fine_wt_c_lo1_1 = fine_wt_c_left_rest_1
          + ksl_product_rest(D->m13, fine_vector_1, fine_wt_b, fine_wt_c_right_1),
      fine_vector_lo_3 = ksl_product_error(fine_upper_2, fine_k, fine_vector_2)
          + (KSL_MUL(fine_upper_lo_3, fine_k) + KSL_MUL(fine_upper_2, fine_k_lo)),
      fine_wt_d = KSL_MUL(D->m23, fine_vector_2), fine_wt_d_size_1 = fabs(D->m23);
  const double fine_vector_size_12 = KSL_MUL(fine_vector_padded_1, fine_vector_reach_4)
          + KSL_MUL(fine_v_s_size_padded_3, fine_vector_reach_2);
  const double fine_wt_d_padded_1 = 1.8051943758648296e-276 + fine_vector_size_12,
      fine_wt = fine_wt_c + fine_wt_d, fine_wt_right_1 = fine_wt - fine_wt_c,
      fine_wt_lo1_1 = fine_wt_c - (fine_wt - fine_wt_right_1)
          + ksl_product_rest(D->m23, fine_vector_2, fine_wt_d, fine_wt_right_1),
      fine_wt_c_lo = fine_wt_c_lo1_1
          + (KSL_MUL(D->m03, fine_vector_lo_1) + KSL_MUL(D->m13, fine_vector_lo_2)),
      fine_wt_lo = fine_wt_lo1_1 + KSL_MUL(D->m23, fine_vector_lo_3) + fine_wt_c_lo,
      fine_wt_c_size_1 = KSL_MUL(fine_wt_a_padded_1, fine_wt_a_size_1)
          + KSL_MUL(fine_wt_b_padded_1, fine_wt_b_size_1);
  const double fine_pitch = KSL_MUL(fine_b, fine_wt);
  const double fine_b_size_11 = fine_b_size_1
          + KSL_MUL(fine_b_size_2 + KSL_MUL(140737488355328.0, fine_b_bound_1), fine_b_size_8)
          / fine_b_size_2;
  const double fine_pitch_padded_1 = 1.8051943758648296e-276 + fine_b_size_11,
      fine_pitch_padded_2 = 1.8051943758648296e-276
          + (fine_wt_c_size_1 + KSL_MUL(fine_wt_d_padded_1, fine_wt_d_size_1)),
      fine_pitch_reach_1 = fine_b_size_1
          + KSL_MUL(140737488355328.0, fabs(fine_b_lo)
          + KSL_MUL(1.041866381758103e-27, fine_pitch_padded_1)),
      fine_pitch_reach_2 = fabs(fine_wt)
          + KSL_MUL(140737488355328.0, fabs(fine_wt_lo)
          + KSL_MUL(3.892538312770568e-29, fine_pitch_padded_2));
  const double fine_pitch_lo = ksl_product_error(fine_b, fine_wt, fine_pitch)
          + (KSL_MUL(fine_b_lo, fine_wt) + KSL_MUL(fine_b, fine_wt_lo)),
      fine_along_0 = KSL_MUL(fine_vector_0, fine_pitch),
      fine_along_padded_1 = 1.8051943758648296e-276
          + (KSL_MUL(fine_pitch_padded_2, fine_pitch_reach_1)
          + KSL_MUL(fine_pitch_padded_1, fine_pitch_reach_2)),
      fine_along_rest_1 = KSL_MUL(3.5202936421278755e-29, fine_wt_a_padded_1),
      fine_along_reach_2 = fabs(fine_pitch)
          + KSL_MUL(140737488355328.0, fabs(fine_pitch_lo)
          + KSL_MUL(1.0537979996222264e-27, fine_along_padded_1)),
      fine_along_size_2 = KSL_MUL(fine_along_padded_1, fabs(fine_vector_0)
          + KSL_MUL(140737488355328.0, fabs(fine_vector_lo_1) + fine_along_rest_1));
  const double fine_along_1 = KSL_MUL(fine_vector_1, fine_pitch),
      fine_along_rest_3 = KSL_MUL(3.5202936421278755e-29, fine_wt_b_padded_1),
      fine_along_size_7 = KSL_MUL(fine_along_padded_1, fabs(fine_vector_1)
          + KSL_MUL(140737488355328.0, fabs(fine_vector_lo_2) + fine_along_rest_3));
  const double fine_along_2 = KSL_MUL(fine_vector_2, fine_pitch),
      fine_along_rest_4 = KSL_MUL(3.5202936421278755e-29, fine_wt_d_padded_1),
      fine_along_size_11 = KSL_MUL(fine_along_padded_1, fabs(fine_vector_2)
          + KSL_MUL(140737488355328.0, fabs(fine_vector_lo_3) + fine_along_rest_4));
  const double fine_u_0a = KSL_MUL(D->m23, fine_vector_1),
      fine_u_0b = KSL_MUL(D->m13, fine_vector_2), fine_u_0 = fine_u_0a - fine_u_0b,
      fine_u_right_1 = fine_u_0a - fine_u_0,
      fine_u_left_rest_1 = ksl_product_rest(D->m23, fine_vector_1, fine_u_0a, fine_u_0
          + fine_u_right_1),
      fine_u_lo1_1 = fine_u_left_rest_1
          - ksl_product_rest(D->m13, fine_vector_2, fine_u_0b, fine_u_right_1);
  const double fine_u_1a = KSL_MUL(D->m03, fine_vector_2),
      fine_u_1b = KSL_MUL(D->m23, fine_vector_0), fine_u_1 = fine_u_1a - fine_u_1b,
      fine_u_right_2 = fine_u_1a - fine_u_1,
      fine_u_left_rest_2 = ksl_product_rest(D->m03, fine_vector_2, fine_u_1a, fine_u_1
          + fine_u_right_2),
      fine_u_lo1_2 = fine_u_left_rest_2
          - ksl_product_rest(D->m23, fine_vector_0, fine_u_1b, fine_u_right_2);
  const double fine_u_2a = KSL_MUL(D->m13, fine_vector_0),
      fine_u_2b = KSL_MUL(D->m03, fine_vector_1), fine_u_2 = fine_u_2a - fine_u_2b,
      fine_u_right_3 = fine_u_2a - fine_u_2,
      fine_u_left_rest_3 = ksl_product_rest(D->m13, fine_vector_0, fine_u_2a, fine_u_2
          + fine_u_right_3),
      fine_u_lo1_3 = fine_u_left_rest_3
          - ksl_product_rest(D->m03, fine_vector_1, fine_u_2b, fine_u_right_3);
  const double fine_turned_0 = KSL_MUL(0.5, fine_u_0);
  const double fine_turned_1 = KSL_MUL(0.5, fine_u_1);
  const double fine_turned_2 = KSL_MUL(0.5, fine_u_2);
  const double fine_across_axis_0 = fine_along_0 - fine_turned_0,
      fine_across_axis_right_1 = fine_along_0 - fine_across_axis_0,
      fine_across_axis_left_rest_1 = ksl_product_rest(fine_vector_0, fine_pitch, fine_along_0,
          fine_across_axis_0 + fine_across_axis_right_1);
  const double fine_turned_cross2_1 = KSL_MUL(0.5, fine_u_lo1_1
          + (KSL_MUL(D->m23, fine_vector_lo_2) - KSL_MUL(D->m13, fine_vector_lo_3)));
  const double fine_across_axis_lo2_1 = fine_across_axis_left_rest_1
          - (fine_turned_0 - fine_across_axis_right_1) - fine_turned_cross2_1;
  const double fine_turned_size_1 = KSL_MUL(0.5, KSL_MUL(fine_wt_b_padded_1, fine_wt_d_size_1)
          + KSL_MUL(fine_wt_b_size_1, fine_wt_d_padded_1));
  const double fine_across_axis_1 = fine_along_1 - fine_turned_1,
      fine_across_axis_right_2 = fine_along_1 - fine_across_axis_1,
      fine_across_axis_left_rest_2 = ksl_product_rest(fine_vector_1, fine_pitch, fine_along_1,
          fine_across_axis_1 + fine_across_axis_right_2);
  const double fine_turned_cross2_2 = KSL_MUL(0.5, fine_u_lo1_2
          + (KSL_MUL(D->m03, fine_vector_lo_3) - KSL_MUL(D->m23, fine_vector_lo_1)));
  const double fine_across_axis_lo2_2 = fine_across_axis_left_rest_2
          - (fine_turned_1 - fine_across_axis_right_2) - fine_turned_cross2_2;
  const double fine_turned_size_2 = KSL_MUL(0.5, KSL_MUL(fine_wt_a_size_1, fine_wt_d_padded_1)
          + KSL_MUL(fine_wt_a_padded_1, fine_wt_d_size_1));
  const double fine_across_axis_2 = fine_along_2 - fine_turned_2,
      fine_across_axis_right_3 = fine_along_2 - fine_across_axis_2,
      fine_across_axis_left_rest_3 = ksl_product_rest(fine_vector_2, fine_pitch, fine_along_2,
          fine_across_axis_2 + fine_across_axis_right_3);
  const double fine_turned_cross2_3 = KSL_MUL(0.5, fine_u_lo1_3
          + (KSL_MUL(D->m13, fine_vector_lo_1) - KSL_MUL(D->m03, fine_vector_lo_2)));
  const double fine_across_axis_lo2_3 = fine_across_axis_left_rest_3
          - (fine_turned_2 - fine_across_axis_right_3) - fine_turned_cross2_3;
  const double fine_turned_size_3 = KSL_MUL(0.5, KSL_MUL(fine_wt_a_padded_1, fine_wt_b_size_1)
          + KSL_MUL(fine_wt_a_size_1, fine_wt_b_padded_1));
  const double fine_so_0a = KSL_MUL(D->m03, fine_b_across),
      fine_so_0a_padded_1 = 1.8051943758648296e-276
          + (fine_b_across_size_1 + fine_b_across_size_10),
      fine_so_0 = fine_so_0a + fine_across_axis_0, fine_so_right_1 = fine_so_0 - fine_so_0a,
      fine_so_lo1_1 = ksl_product_rest(D->m03, fine_b_across, fine_so_0a, fine_so_0
          - fine_so_right_1) + (fine_across_axis_0 - fine_so_right_1),
      fine_so_lo2_1 = fine_so_lo1_1
          + (fine_across_axis_lo2_1
          + (KSL_MUL(fine_vector_lo_1, fine_pitch) + KSL_MUL(fine_vector_0, fine_pitch_lo)));
  const double fine_across_axis_size_1 = fine_along_size_2
          + KSL_MUL(fine_along_reach_2, fine_wt_a_padded_1) + fine_turned_size_1;
  const double fine_so_1a = KSL_MUL(D->m13, fine_b_across),
      fine_so_1 = fine_so_1a + fine_across_axis_1, fine_so_right_2 = fine_so_1 - fine_so_1a,
      fine_so_lo1_2 = ksl_product_rest(D->m13, fine_b_across, fine_so_1a, fine_so_1
          - fine_so_right_2) + (fine_across_axis_1 - fine_so_right_2),
      fine_so_lo2_2 = fine_so_lo1_2
          + (fine_across_axis_lo2_2
          + (KSL_MUL(fine_vector_lo_2, fine_pitch) + KSL_MUL(fine_vector_1, fine_pitch_lo)));
  const double fine_across_axis_size_2 = fine_along_size_7
          + KSL_MUL(fine_along_reach_2, fine_wt_b_padded_1) + fine_turned_size_2;
  const double fine_so_2a = KSL_MUL(D->m23, fine_b_across),
      fine_so_2 = fine_so_2a + fine_across_axis_2, fine_so_right_3 = fine_so_2 - fine_so_2a,
      fine_so_lo1_3 = ksl_product_rest(D->m23, fine_b_across, fine_so_2a, fine_so_2
          - fine_so_right_3) + (fine_across_axis_2 - fine_so_right_3),
      fine_so_lo2_3 = fine_so_lo1_3
          + (fine_across_axis_lo2_3
          + (KSL_MUL(fine_vector_lo_3, fine_pitch) + KSL_MUL(fine_vector_2, fine_pitch_lo)));
  const double fine_across_axis_size_3 = fine_along_size_11
          + KSL_MUL(fine_along_reach_2, fine_wt_d_padded_1) + fine_turned_size_3;
  const double so_rest_1 = KSL_MUL(1.0715106821527331e-27, 1.8051943758648296e-276
          + (fine_across_axis_size_1 + KSL_MUL(fine_so_0a_padded_1, fine_wt_a_size_1))),
      so_rest_2 = KSL_MUL(1.0715106821527331e-27, 1.8051943758648296e-276
          + (fine_across_axis_size_2 + KSL_MUL(fine_so_0a_padded_1, fine_wt_b_size_1))),
      so_rest_3 = KSL_MUL(1.0715106821527331e-27, 1.8051943758648296e-276
          + (fine_across_axis_size_3 + KSL_MUL(fine_so_0a_padded_1, fine_wt_d_size_1)));
  const double D_n_0 = KSL_MUL(D->m11, D->m22) - KSL_MUL(D->m12, D->m21),
      D_n_1 = KSL_MUL(D->m02, D->m21) - KSL_MUL(D->m01, D->m22),
      D_n_2 = KSL_MUL(D->m01, D->m12) - KSL_MUL(D->m02, D->m11);
  const double D_det = KSL_MUL(D->m00, D_n_0) + KSL_MUL(D->m10, D_n_1) + KSL_MUL(D->m20, D_n_2);
  const double D_g_0 = KSL_MUL(D->m00, D->m00) + KSL_MUL(D->m10, D->m10) + KSL_MUL(D->m20, D->m20),
      D_g_1 = KSL_MUL(D->m00, D->m01) + KSL_MUL(D->m10, D->m11) + KSL_MUL(D->m20, D->m21),
      D_g_2 = KSL_MUL(D->m00, D->m02) + KSL_MUL(D->m10, D->m12) + KSL_MUL(D->m20, D->m22),
      D_g_3 = KSL_MUL(D->m01, D->m01) + KSL_MUL(D->m11, D->m11) + KSL_MUL(D->m21, D->m21),
      D_g_4 = KSL_MUL(D->m01, D->m02) + KSL_MUL(D->m11, D->m12) + KSL_MUL(D->m21, D->m22),
      D_g_5 = KSL_MUL(D->m02, D->m02) + KSL_MUL(D->m12, D->m12) + KSL_MUL(D->m22, D->m22);
  const double D_off_0 = D_det - 1.0, D_off_1 = D_g_0 - 1.0, D_off_4 = D_g_3 - 1.0,
      D_off_6 = D_g_5 - 1.0;
  const double D_defect_size_0 = fabs(D_off_0), D_defect_size_1 = fabs(D_off_1),
      D_defect_size_2 = fabs(D_g_1), D_defect_size_3 = fabs(D_g_2), D_defect_size_4 = fabs(D_off_4),
      D_defect_size_5 = fabs(D_g_4), D_defect_size_6 = fabs(D_off_6);
  const double D_defect_largest1 = D_defect_size_0 < D_defect_size_1 ? D_defect_size_1
          : D_defect_size_0;
  const double D_defect_largest2 = D_defect_largest1 < D_defect_size_2 ? D_defect_size_2
          : D_defect_largest1;
  const double D_defect_largest3 = D_defect_largest2 < D_defect_size_3 ? D_defect_size_3
          : D_defect_largest2;
  const double D_defect_largest4 = D_defect_largest3 < D_defect_size_4 ? D_defect_size_4
          : D_defect_largest3;
  const double D_defect_largest5 = D_defect_largest4 < D_defect_size_5 ? D_defect_size_5
          : D_defect_largest4;
  const double D_defect_largest6 = D_defect_largest5 < D_defect_size_6 ? D_defect_size_6
          : D_defect_largest5;
  const double D_unless_equal = D_defect_largest6 == 0.001 ? 0.0 : 1.0715086071862673e+301;
  const double D_unless_rotation = D_defect_largest6 < 0.001 ? 0.0 : D_unless_equal;
  const double D_excess = KSL_MUL(D_unless_rotation, 1.0715086071862673e+301),
      D_excess_0 = KSL_MUL(1.0000000000000009, fabs(fine_so_lo2_1
          + KSL_MUL(D->m03, fine_b_across_lo) + (fine_so_0 - so_0))) + so_rest_1 + D_excess,
      D_excess_1 = KSL_MUL(1.0000000000000009, fabs(fine_so_lo2_2
          + KSL_MUL(D->m13, fine_b_across_lo) + (fine_so_1 - so_1))) + so_rest_2 + D_excess,
      D_excess_2 = KSL_MUL(1.0000000000000009, fabs(fine_so_lo2_3
          + KSL_MUL(D->m23, fine_b_across_lo) + (fine_so_2 - so_2))) + so_rest_3 + D_excess,
      D_excess_3 = fine_along_rest_1
          + KSL_MUL(1.0000000000000009, fabs(fine_vector_lo_1 + (fine_vector_0 - vector_0)))
          + D_excess,
      D_excess_4 = fine_along_rest_3
          + KSL_MUL(1.0000000000000009, fabs(fine_vector_lo_2 + (fine_vector_1 - vector_1)))
          + D_excess,
      D_excess_5 = fine_along_rest_4
          + KSL_MUL(1.0000000000000009, fabs(fine_vector_lo_3 + (fine_vector_2 - vector_2)))
          + D_excess;
  so->m0 = so_0;
  so->m1 = so_1;
  so->m2 = so_2;
  so->m3 = vector_0;
  so->m4 = vector_1;
  so->m5 = vector_2;
  so_bound->m0 = D_excess_0;
  so_bound->m1 = D_excess_1;
  so_bound->m2 = D_excess_2;
  so_bound->m3 = D_excess_3;
  so_bound->m4 = D_excess_4;
  so_bound->m5 = D_excess_5;
}

/* R = exp v~ = I + sin θ/θ v~ + (1 - cos θ)/θ^2 v~^2, θ = |v|; |error of R| <= R_bound unless
     inf or NaN.
   v: vector; R, R_bound: rotation or other 3×3 matrix.
   306 mul, 453 add, 14 product error, 22 product rest, 12 div, 3 sqrt, 51 abs, 14 less, 1 equal,
     29 select. */
static inline void ksl_SO3_expf_certified(const ksl_vec3f_t *v, ksl_mat3x3f_t *R,
    ksl_mat3x3f_t *R_bound) {
  const float size_0 = fabsf(v->x), size_1 = fabsf(v->y), size_2 = fabsf(v->z);
  const float sizes = size_0 + size_1 + size_2;
  const float grid = KSL_MULF(sizes, 8192.0f);
  const float shifted_0 = v->x + grid, shifted_1 = v->y + grid, shifted_2 = v->z + grid;
  const float high_0 = shifted_0 - grid, high_1 = shifted_1 - grid, high_2 = shifted_2 - grid;
  const float low_0 = v->x - high_0, low_1 = v->y - high_1, low_2 = v->z - high_2;
  const float sum_0 = v->x + high_0, sum_1 = v->y + high_1, sum_2 = v->z + high_2;
  const float squares = KSL_MULF(high_0, high_0) + KSL_MULF(high_1, high_1)
          + KSL_MULF(high_2, high_2);
  const float cross = KSL_MULF(low_0, sum_0) + KSL_MULF(low_1, sum_1) + KSL_MULF(low_2, sum_2);
  const float x = squares + cross;
  const float theta_a = sqrtf(x), theta = x < 1.0f ? 1.0f : theta_a;
  const float theta_shifted = grid + theta;
  const float theta_high = theta_shifted - grid;
  const float theta_low = theta - theta_high;
  const float theta_sum = theta + theta_high;
  const float cross_rest = cross - KSL_MULF(theta_low, theta_sum);
  const float exact = squares - KSL_MULF(theta_high, theta_high);
  const float residual = cross_rest + exact;
  const float small = KSL_MULF(0.5f, residual) / theta;
  const float delta = fabsf(small) < 0.0078125f ? small : 0.0f;
  float far_cosine_a; const float far_sine_a = ksl_sincosf(theta, &far_cosine_a);
  const float far_sine = x < 1.0f ? 1.0f : far_sine_a;
  const float far_cosine = x < 1.0f ? 0.0f : far_cosine_a;
  const float sine = KSL_MULF(delta, far_cosine) + far_sine;
  const float cosine = far_cosine - KSL_MULF(delta, far_sine);
  const float far_x = x < 1.0f ? 1.0f : x;
  const float closed1 = sine / theta;
  const float versine = 1.0f - cosine;
  const float closed2 = versine / far_x;
  const float g1h = KSL_MULF(x, KSL_MULF(x, KSL_MULF(x, KSL_MULF(6.4469503e-26f, x)
          - 3.8681703e-23f) + 1.9572942e-20f) - 8.220635e-18f) + 2.8114574e-15f,
      g1q = KSL_MULF(x, KSL_MULF(x, KSL_MULF(x, KSL_MULF(x, KSL_MULF(x, g1h) - 7.6471636e-13f)
          + 1.6059044e-10f) - 2.5052108e-08f) + 2.7557319e-06f),
      g1x = KSL_MULF(x, KSL_MULF(x, KSL_MULF(x, g1q - 0.0001984127f) + 0.008333334f) - 0.16666667f)
          + 1.0f, g1 = x < 1.0f ? g1x : closed1;
  const float g2h = KSL_MULF(x, KSL_MULF(x, KSL_MULF(x, KSL_MULF(2.4795963e-27f, x)
          - 1.6117376e-24f) + 8.896791e-22f) - 4.1103176e-19f) + 1.5619207e-16f,
      g2q = KSL_MULF(x, KSL_MULF(x, KSL_MULF(x, KSL_MULF(x, KSL_MULF(x, g2h) - 4.7794773e-14f)
          + 1.1470745e-11f) - 2.0876756e-09f) + 2.755732e-07f),
      g2x = KSL_MULF(x, KSL_MULF(x, KSL_MULF(x, g2q - 2.4801588e-05f) + 0.0013888889f)
          - 0.041666668f) + 0.5f, g2 = x < 1.0f ? g2x : closed2;
  const float g0b = 1.0f - KSL_MULF(x, g2), g0 = x < 1.0f ? g0b : cosine;
  const float beta_v_0 = KSL_MULF(v->x, g2);
  const float beta_v_1 = KSL_MULF(v->y, g2);
  const float beta_v_2 = KSL_MULF(v->z, g2);
  const float m_0 = KSL_MULF(v->x, beta_v_0);
  const float m_1 = KSL_MULF(v->y, beta_v_1);
  const float m_2 = KSL_MULF(v->z, beta_v_2);
  const float m_3 = KSL_MULF(v->y, beta_v_0);
  const float m_4 = KSL_MULF(v->z, beta_v_0);
  const float m_5 = KSL_MULF(v->z, beta_v_1);
  const float others_0 = m_1 + m_2;
  const float others_1 = m_0 + m_2;
  const float others_2 = m_0 + m_1;
  const float diagonal0a = 1.0f - others_0, diagonal0b = g0 + m_0,
      diagonal0 = m_0 < others_0 ? diagonal0b : diagonal0a;
  const float diagonal1a = 1.0f - others_1, diagonal1b = g0 + m_1,
      diagonal1 = m_1 < others_1 ? diagonal1b : diagonal1a;
  const float diagonal2a = 1.0f - others_2, diagonal2b = g0 + m_2,
      diagonal2 = m_2 < others_2 ? diagonal2b : diagonal2a;
  const float alpha_v_0 = KSL_MULF(v->x, g1);
  const float alpha_v_1 = KSL_MULF(v->y, g1);
  const float alpha_v_2 = KSL_MULF(v->z, g1);
  const float R_01 = m_3 - alpha_v_2;
  const float R_02 = m_4 + alpha_v_1;
  const float R_10 = m_3 + alpha_v_2;
  const float R_12 = m_5 - alpha_v_0;
  const float R_20 = m_4 - alpha_v_1;
  const float R_21 = m_5 + alpha_v_0;
  const float halved_0 = KSL_MULF(0.5f, v->x), halved_size_1 = fabsf(v->x);
  const float halved_1 = KSL_MULF(0.5f, v->y), halved_size_3 = fabsf(v->y);
  const float halved_2 = KSL_MULF(0.5f, v->z), halved_size_5 = fabsf(v->z);
  const float h_size_0 = fabsf(halved_0), h_size_1 = fabsf(halved_1), h_size_2 = fabsf(halved_2);
  const float h_largest1 = h_size_0 < h_size_1 ? h_size_1 : h_size_0;
  const float h_largest2 = h_largest1 < h_size_2 ? h_size_2 : h_largest1;
  const float s = 4.611686e+18f < h_largest2 ? 2.7105054e-20f : 1.0f,
      s_size_1 = 4.611686e+18f < h_largest2 ? 2.7105054e-20f : 1.0f;
  const float reduced_0 = KSL_MULF(halved_0, s), reduced_1 = KSL_MULF(halved_1, s),
      reduced_2 = KSL_MULF(halved_2, s);
  const float up = s < 1.0f ? 3.689349e+19f : 1.0f;
  const float reduced_length_a = KSL_MULF(reduced_0, reduced_0),
      reduced_length_a_padded_1 = 3.3087225e-24f
          + KSL_MULF(3.3087225e-24f + KSL_MULF(0.5f, halved_size_1), s_size_1),
      reduced_length_b = KSL_MULF(reduced_1, reduced_1),
      reduced_length_b_padded_1 = 3.3087225e-24f
          + KSL_MULF(3.3087225e-24f + KSL_MULF(0.5f, halved_size_3), s_size_1),
      reduced_length_c = reduced_length_a + reduced_length_b,
      reduced_length_c_right_1 = reduced_length_c - reduced_length_a,
      reduced_length_c_left_rest_1 = ksl_product_restf(reduced_0, reduced_0, reduced_length_a,
          reduced_length_c - reduced_length_c_right_1),
      reduced_length_a_size_1 = KSL_MULF(reduced_length_a_padded_1, reduced_length_a_padded_1),
      reduced_length_d = KSL_MULF(reduced_2, reduced_2),
      reduced_length_d_padded_1 = 3.3087225e-24f
          + KSL_MULF(3.3087225e-24f + KSL_MULF(0.5f, halved_size_5), s_size_1),
      reduced_length_e = reduced_length_c + reduced_length_d,
      reduced_length_e_right_1 = reduced_length_e - reduced_length_c,
      reduced_length_e_right_rest_1 = ksl_product_restf(reduced_2, reduced_2, reduced_length_d,
          reduced_length_e_right_1),
      reduced_length_c_lo = reduced_length_c_left_rest_1
          + ksl_product_restf(reduced_1, reduced_1, reduced_length_b, reduced_length_c_right_1),
      reduced_length_e_lo = reduced_length_c - (reduced_length_e - reduced_length_e_right_1)
          + reduced_length_e_right_rest_1 + reduced_length_c_lo,
      reduced_length_c_size_1 = reduced_length_a_size_1
          + KSL_MULF(reduced_length_b_padded_1, reduced_length_b_padded_1),
      reduced_length = sqrtf(reduced_length_e),
      reduced_length_product_1 = KSL_MULF(reduced_length, reduced_length),
      reduced_length_exact_1 = reduced_length_e - reduced_length_product_1
          - ksl_product_errorf(reduced_length, reduced_length, reduced_length_product_1),
      reduced_length_twice_1 = reduced_length + reduced_length,
      reduced_length_lo = (reduced_length_exact_1 + reduced_length_e_lo)
          / (reduced_length == 0.0f ? 1.0f : reduced_length_twice_1),
      reduced_length_padded_1 = 3.3087225e-24f
          + (reduced_length_c_size_1
          + KSL_MULF(reduced_length_d_padded_1, reduced_length_d_padded_1)),
      reduced_length_bound_1 = fabsf(reduced_length_e_lo)
          + KSL_MULF(9.308236e-13f, reduced_length_padded_1),
      reduced_length_reach_1 = fabsf(reduced_length_e)
          + KSL_MULF(262144.0f, reduced_length_bound_1),
      reduced_length_size_4 = KSL_MULF(reduced_length_reach_1, reduced_length_padded_1
          / reduced_length / reduced_length_e),
      reduced_length_size_8 = KSL_MULF(6.958476e+11f, sqrtf(reduced_length_bound_1)
          + fabsf(reduced_length_lo));
  const float half_angle = KSL_MULF(reduced_length, up),
      half_angle_lo = KSL_MULF(reduced_length - KSL_MULF(half_angle, 1.0f / up)
          + reduced_length_lo, up);
  const float reduced_length_size_12 = reduced_length
          + (KSL_MULF(4.0f, reduced_length_bound_1) < reduced_length_e ? reduced_length_size_4
          : reduced_length_size_8);
  const float half_angle_size_1 = KSL_MULF(3.3087225e-24f + reduced_length_size_12, s < 1.0f
          ? 3.689349e+19f : 1.0f);
  const float y = KSL_MULF(half_angle, half_angle), y_padded_1 = 3.3087225e-24f + half_angle_size_1,
      y_bound_1 = fabsf(half_angle_lo) + KSL_MULF(1.6484983e-12f, y_padded_1),
      y_size_2 = KSL_MULF(y_padded_1, fabsf(half_angle) + KSL_MULF(262144.0f, y_bound_1));
  float c; const float fine_sine = ksl_sincosf(half_angle, &c);
  float c_own_error_1; const float fine_sine_own_error_1 = ksl_sincos_errorf(half_angle, fine_sine,
      c, &c_own_error_1);
  const float fine_sine_half_1 = KSL_MULF(half_angle_lo, 0.5f);
  float fine_sine_half_cos_1; const float fine_sine_half_sin_1 = ksl_sincosf(fine_sine_half_1,
      &fine_sine_half_cos_1);
  const float fine_sine_twice_1 = fine_sine_half_sin_1 + fine_sine_half_sin_1,
      fine_sine_size_1 = 1.0f + y_padded_1;
  const float c_lo = c_own_error_1
          - KSL_MULF(KSL_MULF(fine_sine_half_cos_1, fine_sine)
          + KSL_MULF(fine_sine_half_sin_1, c), fine_sine_twice_1);
  const float sinc_divisor = half_angle < 1.4901161e-08f ? 1.4901161e-08f : half_angle,
      sinc_divisor_lo = half_angle < 1.4901161e-08f ? 0.0f : half_angle_lo,
      sinc_divisor_size_4 = 1e-45f + fabsf(half_angle - 1.4901161e-08f),
      sinc_divisor_size_8 = fabsf(1.4901161e-08f - half_angle) + y_bound_1,
      sinc_divisor_size_10 = KSL_MULF(1.9990821e+11f, y_bound_1 < sinc_divisor_size_4 ? 0.0f
          : sinc_divisor_size_8);
  const float sinc_quotient = fine_sine / sinc_divisor,
      sinc_quotient_product_1 = KSL_MULF(sinc_quotient, sinc_divisor);
  const float fine_sine_lo = fine_sine_own_error_1
          + KSL_MULF(KSL_MULF(fine_sine_half_cos_1, c)
          - KSL_MULF(fine_sine_half_sin_1, fine_sine), fine_sine_twice_1);
  const float sinc_quotient_exact_1 = fine_sine - sinc_quotient_product_1
          - ksl_product_errorf(sinc_quotient, sinc_divisor, sinc_quotient_product_1),
      sinc_quotient_lo = (sinc_quotient_exact_1 + fine_sine_lo
          - KSL_MULF(sinc_quotient, sinc_divisor_lo)) / sinc_divisor,
      sinc_quotient_padded_2 = 3.3087225e-24f
          + ((half_angle < 1.4901161e-08f ? 1.4901161e-08f : half_angle_size_1)
          + sinc_divisor_size_10), sinc_quotient_size_1 = fabsf(sinc_quotient),
      sinc_quotient_size_2 = fabsf(sinc_divisor),
      sinc_quotient_bound_1 = fabsf(sinc_divisor_lo)
          + KSL_MULF(5.1586396e-12f, sinc_quotient_padded_2),
      sinc_quotient_size_4 = 3.3087225e-24f + fine_sine_size_1
          + KSL_MULF(sinc_quotient_padded_2, sinc_quotient_size_1),
      sinc_quotient_size_8 = sinc_quotient_size_4
          / (KSL_MULF(4.0f, sinc_quotient_bound_1) < sinc_quotient_size_2 ? sinc_quotient_size_2
          : 0.0f),
      sinc_quotient_size_10 = KSL_MULF(sinc_quotient_size_2
          + KSL_MULF(262144.0f, sinc_quotient_bound_1), sinc_quotient_size_8)
          / sinc_quotient_size_2,
      sinc_quotient_size_11 = sinc_quotient_size_1 + sinc_quotient_size_10;
  const float sinc_a = KSL_MULF(0.16666667f, y),
      y_lo = ksl_product_errorf(half_angle, half_angle, y)
          + (KSL_MULF(half_angle_lo, half_angle) + KSL_MULF(half_angle, half_angle_lo)),
      sinc_b = 1.0f - sinc_a, sinc_b_right_1 = 1.0f - sinc_b,
      sinc_b_lo1_1 = 1.0f - (sinc_b + sinc_b_right_1)
          - ksl_product_restf(0.16666667f, y, sinc_a, sinc_b_right_1),
      sinc_b_lo = sinc_b_lo1_1 - (KSL_MULF(-4.967054e-09f, y) + KSL_MULF(0.16666667f, y_lo)),
      sinc_b_size_1 = 1.0f + KSL_MULF(0.16666669f, y_size_2 + y_size_2),
      sinc = half_angle < 1.4901161e-08f ? sinc_b : sinc_quotient,
      sinc_lo = half_angle < 1.4901161e-08f ? sinc_b_lo : sinc_quotient_lo,
      sinc_size_4 = fabsf(sinc_b_lo) + KSL_MULF(2.3639474e-10f, 3.3087225e-24f + sinc_b_size_1)
          + fabsf(sinc_b - sinc_quotient),
      sinc_size_5 = fabsf(sinc_quotient_lo)
          + KSL_MULF(7.941701e-12f, 3.3087225e-24f + sinc_quotient_size_11) + sinc_size_4,
      sinc_size_7 = KSL_MULF(4.235067e+09f, y_bound_1 < sinc_divisor_size_4 ? 0.0f : sinc_size_5);
  const float turning_0 = KSL_MULF(v->x, sinc),
      turning_padded_1 = 3.3087225e-24f
          + ((half_angle < 1.4901161e-08f ? sinc_b_size_1 : sinc_quotient_size_11) + sinc_size_7),
      turning_size_1 = KSL_MULF(halved_size_1, turning_padded_1);
  const float turning_1 = KSL_MULF(v->y, sinc),
      turning_size_2 = KSL_MULF(halved_size_3, turning_padded_1);
  const float turning_2 = KSL_MULF(v->z, sinc),
      turning_size_3 = KSL_MULF(halved_size_5, turning_padded_1);
  const float turning_lo_1 = ksl_product_errorf(v->x, sinc, turning_0) + KSL_MULF(v->x, sinc_lo),
      fine_beta_v_0 = KSL_MULF(0.5f, turning_0),
      fine_beta_v_cross2_1 = KSL_MULF(0.5f, turning_lo_1);
  const float turning_lo_2 = ksl_product_errorf(v->y, sinc, turning_1) + KSL_MULF(v->y, sinc_lo),
      fine_beta_v_1 = KSL_MULF(0.5f, turning_1),
      fine_beta_v_cross2_2 = KSL_MULF(0.5f, turning_lo_2);
  const float turning_lo_3 = ksl_product_errorf(v->z, sinc, turning_2) + KSL_MULF(v->z, sinc_lo),
      fine_beta_v_2 = KSL_MULF(0.5f, turning_2),
      fine_beta_v_cross2_3 = KSL_MULF(0.5f, turning_lo_3);
  const float fine_m_0 = KSL_MULF(turning_0, fine_beta_v_0),
      fine_m_cross_1 = KSL_MULF(turning_lo_1, fine_beta_v_0)
          + KSL_MULF(turning_0, fine_beta_v_cross2_1),
      fine_m_padded_1 = 3.3087225e-24f + turning_size_1,
      fine_m_padded_2 = 3.3087225e-24f + KSL_MULF(0.5f, turning_size_1),
      fine_m_reach_1 = fabsf(turning_0)
          + KSL_MULF(262144.0f, fabsf(turning_lo_1) + KSL_MULF(2.3653254e-10f, fine_m_padded_1)),
      fine_m_reach_2 = fabsf(fine_beta_v_0)
          + KSL_MULF(262144.0f, fabsf(fine_beta_v_cross2_1)
          + KSL_MULF(2.366809e-10f, fine_m_padded_2)),
      fine_m_size_5 = KSL_MULF(fine_m_padded_2, fine_m_reach_1)
          + KSL_MULF(fine_m_padded_1, fine_m_reach_2);
  const float fine_m_1 = KSL_MULF(turning_1, fine_beta_v_1),
      fine_m_cross_2 = KSL_MULF(turning_lo_2, fine_beta_v_1)
          + KSL_MULF(turning_1, fine_beta_v_cross2_2),
      fine_m_padded_3 = 3.3087225e-24f + turning_size_2,
      fine_m_padded_4 = 3.3087225e-24f + KSL_MULF(0.5f, turning_size_2),
      fine_m_reach_3 = fabsf(turning_1)
          + KSL_MULF(262144.0f, fabsf(turning_lo_2) + KSL_MULF(2.3653254e-10f, fine_m_padded_3)),
      fine_m_reach_4 = fabsf(fine_beta_v_1)
          + KSL_MULF(262144.0f, fabsf(fine_beta_v_cross2_2)
          + KSL_MULF(2.366809e-10f, fine_m_padded_4)),
      fine_m_size_10 = KSL_MULF(fine_m_padded_4, fine_m_reach_3)
          + KSL_MULF(fine_m_padded_3, fine_m_reach_4);
  const float fine_m_2 = KSL_MULF(turning_2, fine_beta_v_2),
      fine_m_cross_3 = KSL_MULF(turning_lo_3, fine_beta_v_2)
          + KSL_MULF(turning_2, fine_beta_v_cross2_3),
      fine_m_padded_5 = 3.3087225e-24f + turning_size_3,
      fine_m_padded_6 = 3.3087225e-24f + KSL_MULF(0.5f, turning_size_3),
      fine_m_reach_5 = fabsf(turning_2)
          + KSL_MULF(262144.0f, fabsf(turning_lo_3) + KSL_MULF(2.3653254e-10f, fine_m_padded_5)),
      fine_m_reach_6 = fabsf(fine_beta_v_2)
          + KSL_MULF(262144.0f, fabsf(fine_beta_v_cross2_3)
          + KSL_MULF(2.366809e-10f, fine_m_padded_6)),
      fine_m_size_15 = KSL_MULF(fine_m_padded_6, fine_m_reach_5)
          + KSL_MULF(fine_m_padded_5, fine_m_reach_6);
  const float fine_m_3 = KSL_MULF(turning_1, fine_beta_v_0),
      fine_m_cross_4 = KSL_MULF(turning_lo_2, fine_beta_v_0)
          + KSL_MULF(turning_1, fine_beta_v_cross2_1);
  const float fine_m_4 = KSL_MULF(turning_2, fine_beta_v_0),
      fine_m_cross_5 = KSL_MULF(turning_lo_3, fine_beta_v_0)
          + KSL_MULF(turning_2, fine_beta_v_cross2_1);
  const float fine_m_5 = KSL_MULF(turning_2, fine_beta_v_1),
      fine_m_cross_6 = KSL_MULF(turning_lo_3, fine_beta_v_1)
          + KSL_MULF(turning_2, fine_beta_v_cross2_2);
  const float fine_others_0 = fine_m_1 + fine_m_2, fine_others_right_1 = fine_others_0 - fine_m_1,
      fine_others_left_rest_1 = ksl_product_restf(turning_1, fine_beta_v_1, fine_m_1, fine_others_0
          - fine_others_right_1),
      fine_others_lo1_1 = fine_others_left_rest_1
          + ksl_product_restf(turning_2, fine_beta_v_2, fine_m_2, fine_others_right_1);
  const float fine_others_1 = fine_m_0 + fine_m_2, fine_others_right_2 = fine_others_1 - fine_m_0,
      fine_others_left_rest_2 = ksl_product_restf(turning_0, fine_beta_v_0, fine_m_0, fine_others_1
          - fine_others_right_2),
      fine_others_lo1_2 = fine_others_left_rest_2
          + ksl_product_restf(turning_2, fine_beta_v_2, fine_m_2, fine_others_right_2);
  const float fine_others_2 = fine_m_0 + fine_m_1, fine_others_right_3 = fine_others_2 - fine_m_0,
      fine_others_left_rest_3 = ksl_product_restf(turning_0, fine_beta_v_0, fine_m_0, fine_others_2
          - fine_others_right_3),
      fine_others_lo1_3 = fine_others_left_rest_3
          + ksl_product_restf(turning_1, fine_beta_v_1, fine_m_1, fine_others_right_3);
  const float fine_alpha_v_0 = KSL_MULF(c, turning_0),
      fine_alpha_v_cross_1 = KSL_MULF(c_lo, turning_0) + KSL_MULF(c, turning_lo_1),
      fine_alpha_v_reach_1 = fabsf(c)
          + KSL_MULF(262144.0f, fabsf(c_lo) + KSL_MULF(3.0411817e-12f, fine_sine_size_1));
  const float fine_alpha_v_1 = KSL_MULF(c, turning_1),
      fine_alpha_v_cross_2 = KSL_MULF(c_lo, turning_1) + KSL_MULF(c, turning_lo_2);
  const float fine_alpha_v_2 = KSL_MULF(c, turning_2),
      fine_alpha_v_cross_3 = KSL_MULF(c_lo, turning_2) + KSL_MULF(c, turning_lo_3);
  const float R_00 = 1.0f - fine_others_0, R_right_1 = 1.0f - R_00;
  const float fine_R_01 = fine_m_3 - fine_alpha_v_2, fine_R_right_1 = fine_m_3 - fine_R_01,
      fine_R_left_rest_1 = ksl_product_restf(turning_1, fine_beta_v_0, fine_m_3, fine_R_01
          + fine_R_right_1);
  const float fine_alpha_v_size_10 = KSL_MULF(fine_alpha_v_reach_1, fine_m_padded_5)
          + KSL_MULF(fine_m_reach_5, fine_sine_size_1);
  const float fine_R_02 = fine_m_4 + fine_alpha_v_1, fine_R_right_2 = fine_R_02 - fine_m_4,
      fine_R_left_rest_2 = ksl_product_restf(turning_2, fine_beta_v_0, fine_m_4, fine_R_02
          - fine_R_right_2);
  const float fine_alpha_v_size_7 = KSL_MULF(fine_alpha_v_reach_1, fine_m_padded_3)
          + KSL_MULF(fine_m_reach_3, fine_sine_size_1);
  const float fine_R_10 = fine_m_3 + fine_alpha_v_2, fine_R_right_3 = fine_R_10 - fine_m_3,
      fine_R_left_rest_3 = ksl_product_restf(turning_1, fine_beta_v_0, fine_m_3, fine_R_10
          - fine_R_right_3);
  const float R_11 = 1.0f - fine_others_1, R_right_2 = 1.0f - R_11;
  const float fine_R_12 = fine_m_5 - fine_alpha_v_0, fine_R_right_4 = fine_m_5 - fine_R_12,
      fine_R_left_rest_4 = ksl_product_restf(turning_2, fine_beta_v_1, fine_m_5, fine_R_12
          + fine_R_right_4);
  const float fine_alpha_v_size_4 = KSL_MULF(fine_alpha_v_reach_1, fine_m_padded_1)
          + KSL_MULF(fine_m_reach_1, fine_sine_size_1);
  const float fine_R_20 = fine_m_4 - fine_alpha_v_1, fine_R_right_5 = fine_m_4 - fine_R_20,
      fine_R_left_rest_5 = ksl_product_restf(turning_2, fine_beta_v_0, fine_m_4, fine_R_20
          + fine_R_right_5);
  const float fine_R_21 = fine_m_5 + fine_alpha_v_0, fine_R_right_6 = fine_R_21 - fine_m_5,
      fine_R_left_rest_6 = ksl_product_restf(turning_2, fine_beta_v_1, fine_m_5, fine_R_21
          - fine_R_right_6);
  const float R_22 = 1.0f - fine_others_2, R_right_3 = 1.0f - R_22;
  const float R_lo_1 = 1.0f - (R_00 + R_right_1) - (fine_others_0 - R_right_1)
          - (fine_others_lo1_1 + (fine_m_cross_2 + fine_m_cross_3));
  const float diagonal0_rest_1 = KSL_MULF(2.4022587e-10f, 3.3087225e-24f
          + (1.0f + (fine_m_size_10 + fine_m_size_15)));
  const float fine_R_lo_1 = fine_R_left_rest_1
          - ksl_product_restf(c, turning_2, fine_alpha_v_2, fine_R_right_1)
          + (fine_m_cross_4 - fine_alpha_v_cross_3);
  const float R_padded_1 = 3.3087225e-24f
          + (fine_alpha_v_size_10
          + (KSL_MULF(fine_m_padded_2, fine_m_reach_3)
          + KSL_MULF(fine_m_padded_3, fine_m_reach_2))),
      R_rest_1 = KSL_MULF(2.3971689e-10f, R_padded_1);
  const float fine_R_lo_2 = fine_R_left_rest_2
          + ksl_product_restf(c, turning_1, fine_alpha_v_1, fine_R_right_2)
          + (fine_m_cross_5 + fine_alpha_v_cross_2);
  const float R_padded_2 = 3.3087225e-24f
          + (fine_alpha_v_size_7
          + (KSL_MULF(fine_m_padded_2, fine_m_reach_5)
          + KSL_MULF(fine_m_padded_5, fine_m_reach_2))),
      R_rest_2 = KSL_MULF(2.3971689e-10f, R_padded_2);
  const float fine_R_lo_3 = fine_R_left_rest_3
          + ksl_product_restf(c, turning_2, fine_alpha_v_2, fine_R_right_3)
          + (fine_m_cross_4 + fine_alpha_v_cross_3);
  const float R_lo_2 = 1.0f - (R_11 + R_right_2) - (fine_others_1 - R_right_2)
          - (fine_others_lo1_2 + (fine_m_cross_1 + fine_m_cross_3));
  const float diagonal1_rest_1 = KSL_MULF(2.4022587e-10f, 3.3087225e-24f
          + (1.0f + (fine_m_size_15 + fine_m_size_5)));
  const float fine_R_lo_4 = fine_R_left_rest_4
          - ksl_product_restf(c, turning_0, fine_alpha_v_0, fine_R_right_4)
          + (fine_m_cross_6 - fine_alpha_v_cross_1);
  const float R_padded_3 = 3.3087225e-24f
          + (fine_alpha_v_size_4
          + (KSL_MULF(fine_m_padded_4, fine_m_reach_5)
          + KSL_MULF(fine_m_padded_5, fine_m_reach_4))),
      R_rest_3 = KSL_MULF(2.3971689e-10f, R_padded_3);
  const float fine_R_lo_5 = fine_R_left_rest_5
          - ksl_product_restf(c, turning_1, fine_alpha_v_1, fine_R_right_5)
          + (fine_m_cross_5 - fine_alpha_v_cross_2);
  const float fine_R_lo_6 = fine_R_left_rest_6
          + ksl_product_restf(c, turning_0, fine_alpha_v_0, fine_R_right_6)
          + (fine_m_cross_6 + fine_alpha_v_cross_1);
  const float R_lo_3 = 1.0f - (R_22 + R_right_3) - (fine_others_2 - R_right_3)
          - (fine_others_lo1_3 + (fine_m_cross_1 + fine_m_cross_2));
  const float diagonal2_rest_1 = KSL_MULF(2.4022587e-10f, 3.3087225e-24f
          + (1.0f + (fine_m_size_10 + fine_m_size_5))),
      diagonal0_bound_1 = KSL_MULF(1.0000005f, fabsf(R_lo_1 + (R_00 - diagonal0)))
          + diagonal0_rest_1,
      R_bound_1 = KSL_MULF(1.0000005f, fabsf(fine_R_01 - R_01 + fine_R_lo_1)) + R_rest_1,
      R_bound_2 = KSL_MULF(1.0000005f, fabsf(fine_R_02 - R_02 + fine_R_lo_2)) + R_rest_2,
      R_bound_3 = KSL_MULF(1.0000005f, fabsf(fine_R_10 - R_10 + fine_R_lo_3)) + R_rest_1,
      diagonal1_bound_1 = KSL_MULF(1.0000005f, fabsf(R_lo_2 + (R_11 - diagonal1)))
          + diagonal1_rest_1,
      R_bound_4 = KSL_MULF(1.0000005f, fabsf(fine_R_12 - R_12 + fine_R_lo_4)) + R_rest_3,
      R_bound_5 = KSL_MULF(1.0000005f, fabsf(fine_R_20 - R_20 + fine_R_lo_5)) + R_rest_2,
      R_bound_6 = KSL_MULF(1.0000005f, fabsf(fine_R_21 - R_21 + fine_R_lo_6)) + R_rest_3,
      diagonal2_bound_1 = KSL_MULF(1.0000005f, fabsf(R_lo_3 + (R_22 - diagonal2)))
          + diagonal2_rest_1;
  R->m00 = diagonal0;
  R->m01 = R_01;
  R->m02 = R_02;
  R->m10 = R_10;
  R->m11 = diagonal1;
  R->m12 = R_12;
  R->m20 = R_20;
  R->m21 = R_21;
  R->m22 = diagonal2;
  R_bound->m00 = diagonal0_bound_1;
  R_bound->m01 = R_bound_1;
  R_bound->m02 = R_bound_2;
  R_bound->m10 = R_bound_3;
  R_bound->m11 = diagonal1_bound_1;
  R_bound->m12 = R_bound_4;
  R_bound->m20 = R_bound_5;
  R_bound->m21 = R_bound_6;
  R_bound->m22 = diagonal2_bound_1;
}

/* vo with exp vo~ = R, |vo| <= π; if R is not quite a rotation, its defect carries over to vo;
     |error of vo| <= vo_bound unless inf or NaN.
   R: rotation or other 3×3 matrix; vo, vo_bound: vector.
   210 mul, 407 add, 19 product error, 3 product rest, 16 div, 2 sqrt, 10 neg, 72 abs, 4
     copysign, 41 less, 7 equal, 107 select. */
static inline void ksl_SO3_logf_certified(const ksl_mat3x3f_t *R, ksl_vec3f_t *vo,
    ksl_vec3f_t *vo_bound) {
  const float p_0 = R->m21 - R->m12, p_right_1 = R->m21 - p_0,
      p_lo_1 = R->m21 - (p_0 + p_right_1) - (R->m12 - p_right_1),
      p_size_3 = fabsf(R->m21) + fabsf(R->m12);
  const float p_1 = R->m02 - R->m20, p_right_2 = R->m02 - p_1,
      p_lo_2 = R->m02 - (p_1 + p_right_2) - (R->m20 - p_right_2),
      p_size_6 = fabsf(R->m02) + fabsf(R->m20);
  const float p_2 = R->m10 - R->m01, p_right_3 = R->m10 - p_2,
      p_lo_3 = R->m10 - (p_2 + p_right_3) - (R->m01 - p_right_3),
      p_size_9 = fabsf(R->m10) + fabsf(R->m01);
  const float s_0 = R->m12 + R->m21, s_right_1 = s_0 - R->m12,
      s_lo_1 = R->m12 - (s_0 - s_right_1) + (R->m21 - s_right_1);
  const float s_1 = R->m02 + R->m20, s_right_2 = s_1 - R->m02,
      s_lo_2 = R->m02 - (s_1 - s_right_2) + (R->m20 - s_right_2);
  const float s_2 = R->m01 + R->m10, s_right_3 = s_2 - R->m01,
      s_lo_3 = R->m01 - (s_2 - s_right_3) + (R->m10 - s_right_3);
  const float first_0 = R->m00 + 1.0f, first_right_1 = first_0 - R->m00,
      first_lo_1 = R->m00 - (first_0 - first_right_1) + (1.0f - first_right_1);
  const float first_1 = 1.0f - R->m00, first_right_2 = 1.0f - first_1,
      first_lo_2 = 1.0f - (first_1 + first_right_2) - (R->m00 - first_right_2);
  const float others_0 = R->m11 + R->m22, others_right_1 = others_0 - R->m11,
      others_lo_1 = R->m11 - (others_0 - others_right_1) + (R->m22 - others_right_1);
  const float others_1 = R->m11 - R->m22, others_right_2 = R->m11 - others_1,
      others_lo_2 = R->m11 - (others_1 + others_right_2) - (R->m22 - others_right_2);
  const float d_0 = first_0 + others_0, d_right_1 = d_0 - first_0,
      d_lo_1 = first_0 - (d_0 - d_right_1) + (others_0 - d_right_1) + others_lo_1 + first_lo_1,
      d_size_1 = 1.0f + fabsf(R->m00) + (fabsf(R->m11) + fabsf(R->m22));
  const float d_1 = first_0 - others_0, d_right_2 = first_0 - d_1,
      d_lo_2 = first_0 - (d_1 + d_right_2) - (others_0 - d_right_2) - others_lo_1 + first_lo_1;
  const float d_2 = first_1 + others_1, d_right_3 = d_2 - first_1,
      d_lo_3 = first_1 - (d_2 - d_right_3) + (others_1 - d_right_3) + others_lo_2 + first_lo_2;
  const float d_3 = first_1 - others_1, d_right_4 = first_1 - d_3,
      d_lo_4 = first_1 - (d_3 + d_right_4) - (others_1 - d_right_4) - others_lo_2 + first_lo_2;
  const float low_0 = R->m11 < R->m00 ? d_1 : s_2, low_lo_1 = R->m11 < R->m00 ? d_lo_2 : s_lo_3,
      low_size_1 = R->m11 < R->m00 ? d_size_1 : p_size_9;
  const float low_1 = R->m11 < R->m00 ? s_2 : d_2, low_lo_2 = R->m11 < R->m00 ? s_lo_3 : d_lo_3,
      low_size_2 = R->m11 < R->m00 ? p_size_9 : d_size_1;
  const float low_2 = R->m11 < R->m00 ? s_1 : s_0, low_lo_3 = R->m11 < R->m00 ? s_lo_2 : s_lo_1,
      low_size_3 = R->m11 < R->m00 ? p_size_6 : p_size_3;
  const float low_3 = R->m11 < R->m00 ? p_0 : p_1, low_lo_4 = R->m11 < R->m00 ? p_lo_1 : p_lo_2,
      low_size_4 = R->m11 < R->m00 ? p_size_3 : p_size_6;
  const float high_0a = -R->m11, high_0 = R->m00 < high_0a ? s_1 : p_0,
      high_lo_1 = R->m00 < high_0a ? s_lo_2 : p_lo_1,
      high_size_1 = R->m00 < high_0a ? p_size_6 : p_size_3;
  const float high_1 = R->m00 < high_0a ? s_0 : p_1, high_lo_2 = R->m00 < high_0a ? s_lo_1 : p_lo_2,
      high_size_2 = R->m00 < high_0a ? p_size_3 : p_size_6;
  const float high_2 = R->m00 < high_0a ? d_3 : p_2, high_lo_3 = R->m00 < high_0a ? d_lo_4 : p_lo_3,
      high_size_3 = R->m00 < high_0a ? d_size_1 : p_size_9;
  const float high_3 = R->m00 < high_0a ? p_2 : d_0, high_lo_4 = R->m00 < high_0a ? p_lo_3 : d_lo_1,
      high_size_4 = R->m00 < high_0a ? p_size_9 : d_size_1;
  const float column_0 = R->m22 < 0.0f ? low_0 : high_0,
      column_lo_1 = R->m22 < 0.0f ? low_lo_1 : high_lo_1,
      column_size_1 = R->m22 < 0.0f ? low_size_1 : high_size_1;
  const float column_1 = R->m22 < 0.0f ? low_1 : high_1,
      column_lo_2 = R->m22 < 0.0f ? low_lo_2 : high_lo_2,
      column_size_2 = R->m22 < 0.0f ? low_size_2 : high_size_2;
  const float column_2 = R->m22 < 0.0f ? low_2 : high_2,
      column_lo_3 = R->m22 < 0.0f ? low_lo_3 : high_lo_3,
      column_size_3 = R->m22 < 0.0f ? low_size_3 : high_size_3;
  const float column_3 = R->m22 < 0.0f ? low_3 : high_3,
      column_lo_4 = R->m22 < 0.0f ? low_lo_4 : high_lo_4,
      column_size_4 = R->m22 < 0.0f ? low_size_4 : high_size_4;
  const float upper_0a = -column_0, upper_0a_lo = -column_lo_1,
      upper_0 = column_3 < 0.0f ? upper_0a : column_0,
      upper_lo_1 = column_3 < 0.0f ? upper_0a_lo : column_lo_1,
      upper_rest_1 = KSL_MULF(4.6185646e-13f, 3.3087225e-24f + column_size_4),
      upper_bound_1 = fabsf(column_lo_4) + upper_rest_1, upper_size_2 = fabsf(column_3 - 0.0f),
      upper_rest_2 = KSL_MULF(4.6185646e-13f, 3.3087225e-24f + column_size_1),
      upper_size_7 = fabsf(column_lo_1) + upper_rest_2
          + (fabsf(upper_0a_lo) + upper_rest_2 + fabsf(upper_0a - column_0));
  const float upper_1a = -column_1, upper_1a_lo = -column_lo_2,
      upper_1 = column_3 < 0.0f ? upper_1a : column_1,
      upper_lo_2 = column_3 < 0.0f ? upper_1a_lo : column_lo_2,
      upper_rest_3 = KSL_MULF(4.6185646e-13f, 3.3087225e-24f + column_size_2),
      upper_size_14 = fabsf(column_lo_2) + upper_rest_3
          + (fabsf(upper_1a_lo) + upper_rest_3 + fabsf(upper_1a - column_1));
  const float upper_2a = -column_2, upper_2a_lo = -column_lo_3,
      upper_2 = column_3 < 0.0f ? upper_2a : column_2,
      upper_lo_3 = column_3 < 0.0f ? upper_2a_lo : column_lo_3,
      upper_rest_4 = KSL_MULF(4.6185646e-13f, 3.3087225e-24f + column_size_3),
      upper_size_21 = fabsf(column_lo_3) + upper_rest_4
          + (fabsf(upper_2a_lo) + upper_rest_4 + fabsf(upper_2a - column_2));
  const float upper_3a = -column_3, upper_3a_lo = -column_lo_4,
      upper_3 = column_3 < 0.0f ? upper_3a : column_3,
      upper_lo_4 = column_3 < 0.0f ? upper_3a_lo : column_lo_4,
      upper_size_28 = upper_bound_1
          + (fabsf(upper_3a_lo) + upper_rest_1 + fabsf(upper_3a - column_3));
  const float v_s_size_0 = fabsf(upper_0),
      v_s_size_padded_1 = 3.3087225e-24f
          + (column_size_1
          + KSL_MULF(5.497537e+11f, upper_bound_1 < upper_size_2 ? 0.0f : upper_size_7));
  const float v_s_size_1 = fabsf(upper_1),
      v_s_size_padded_2 = 3.3087225e-24f
          + (column_size_2
          + KSL_MULF(5.497537e+11f, upper_bound_1 < upper_size_2 ? 0.0f : upper_size_14));
  const float v_s_size_2 = fabsf(upper_2),
      v_s_size_padded_3 = 3.3087225e-24f
          + (column_size_3
          + KSL_MULF(5.497537e+11f, upper_bound_1 < upper_size_2 ? 0.0f : upper_size_21));
  const float v_s_largest1 = v_s_size_0 < v_s_size_1 ? v_s_size_1 : v_s_size_0;
  const float v_s_largest2 = v_s_largest1 < v_s_size_2 ? v_s_size_2 : v_s_largest1;
  const float v_s_b = 4.611686e+18f < v_s_largest2 ? 2.7105054e-20f : 1.0f,
      v_s_b_size_1 = 4.611686e+18f < v_s_largest2 ? 2.7105054e-20f : 1.0f,
      v_s_d = v_s_largest2 < 256.0f ? 1.8014399e+16f : v_s_b,
      v_s_d_size_1 = v_s_largest2 < 256.0f ? 1.8014399e+16f : v_s_b_size_1,
      v_s = v_s_largest2 < 1.4210855e-14f ? 3.2451855e+32f : v_s_d,
      v_s_size_3 = v_s_largest2 < 1.4210855e-14f ? 3.2451855e+32f : v_s_d_size_1;
  const float v_y_0 = KSL_MULF(upper_0, v_s), v_y_inverse_1 = 1.0f / v_s,
      v_y_lo_1 = KSL_MULF(upper_0 - KSL_MULF(v_y_0, v_y_inverse_1) + upper_lo_1, v_s);
  const float v_y_1 = KSL_MULF(upper_1, v_s),
      v_y_lo_2 = KSL_MULF(upper_1 - KSL_MULF(v_y_1, v_y_inverse_1) + upper_lo_2, v_s);
  const float v_y_2 = KSL_MULF(upper_2, v_s),
      v_y_lo_3 = KSL_MULF(upper_2 - KSL_MULF(v_y_2, v_y_inverse_1) + upper_lo_3, v_s);
  const float v_n_a = KSL_MULF(v_y_0, v_y_0),
      v_n_a_padded_1 = 3.3087225e-24f + KSL_MULF(v_s_size_3, v_s_size_padded_1),
      v_n_a_size_2 = KSL_MULF(v_n_a_padded_1, fabsf(v_y_0)
          + KSL_MULF(262144.0f, fabsf(v_y_lo_1) + KSL_MULF(1.9326999e-12f, v_n_a_padded_1))),
      v_n_b = KSL_MULF(v_y_1, v_y_1),
      v_n_b_padded_1 = 3.3087225e-24f + KSL_MULF(v_s_size_3, v_s_size_padded_2),
      v_n_b_size_2 = KSL_MULF(v_n_b_padded_1, fabsf(v_y_1)
          + KSL_MULF(262144.0f, fabsf(v_y_lo_2) + KSL_MULF(1.9326999e-12f, v_n_b_padded_1))),
      v_n_c = v_n_a + v_n_b, v_n_c_right_1 = v_n_c - v_n_a,
      v_n_c_lo1_1 = ksl_product_restf(v_y_0, v_y_0, v_n_a, v_n_c - v_n_c_right_1)
          + ksl_product_restf(v_y_1, v_y_1, v_n_b, v_n_c_right_1), v_n_d = KSL_MULF(v_y_2, v_y_2),
      v_n_d_padded_1 = 3.3087225e-24f + KSL_MULF(v_s_size_3, v_s_size_padded_3),
      v_n_d_size_2 = KSL_MULF(v_n_d_padded_1, fabsf(v_y_2)
          + KSL_MULF(262144.0f, fabsf(v_y_lo_3) + KSL_MULF(1.9326999e-12f, v_n_d_padded_1))),
      v_n_e = v_n_c + v_n_d, v_n_e_right_1 = v_n_e - v_n_c,
      v_n_e_lo1_1 = v_n_c - (v_n_e - v_n_e_right_1)
          + ksl_product_restf(v_y_2, v_y_2, v_n_d, v_n_e_right_1),
      v_n_c_lo = v_n_c_lo1_1
          + (KSL_MULF(v_y_lo_1, v_y_0) + KSL_MULF(v_y_0, v_y_lo_1)
          + (KSL_MULF(v_y_lo_2, v_y_1) + KSL_MULF(v_y_1, v_y_lo_2))),
      v_n_e_lo = v_n_e_lo1_1 + (KSL_MULF(v_y_lo_3, v_y_2) + KSL_MULF(v_y_2, v_y_lo_3)) + v_n_c_lo,
      v_n = sqrtf(v_n_e), v_n_product_1 = KSL_MULF(v_n, v_n), v_n_twice_1 = v_n + v_n,
      v_n_lo = (v_n_e - v_n_product_1 - ksl_product_errorf(v_n, v_n, v_n_product_1) + v_n_e_lo)
          / (v_n == 0.0f ? 1.0f : v_n_twice_1),
      v_n_padded_1 = 3.3087225e-24f
          + (v_n_a_size_2 + v_n_a_size_2 + (v_n_b_size_2 + v_n_b_size_2)
          + (v_n_d_size_2 + v_n_d_size_2)),
      v_n_bound_1 = fabsf(v_n_e_lo) + KSL_MULF(3.3147653e-12f, v_n_padded_1),
      v_n_size_4 = KSL_MULF(fabsf(v_n_e) + KSL_MULF(262144.0f, v_n_bound_1), v_n_padded_1 / v_n
          / v_n_e), v_n_size_8 = KSL_MULF(3.9615493e+11f, sqrtf(v_n_bound_1) + fabsf(v_n_lo));
  const float v_r_b = v_s < 1.0f ? 3.689349e+19f : 1.0f,
      v_r_b_size_1 = v_s < 1.0f ? 3.689349e+19f : 1.0f, v_r_d = 1.0f < v_s ? 5.551115e-17f : v_r_b,
      v_r_d_size_1 = 1.0f < v_s ? 5.551115e-17f : v_r_b_size_1,
      v_r = 1.8014399e+16f < v_s ? 3.081488e-33f : v_r_d;
  const float n = KSL_MULF(v_n, v_r), n_lo = KSL_MULF(v_n - KSL_MULF(n, 1.0f / v_r) + v_n_lo, v_r),
      n_padded_1 = 3.3087225e-24f
          + (v_n + (KSL_MULF(4.0f, v_n_bound_1) < v_n_e ? v_n_size_4 : v_n_size_8)),
      n_size_1 = KSL_MULF(n_padded_1, 1.8014399e+16f < v_s ? 3.081488e-33f : v_r_d_size_1);
  const float half = ksl_atan2f(n, upper_3), half_size0_1 = fabsf(n), half_size1_1 = fabsf(upper_3),
      half_most_1 = half_size0_1 < half_size1_1 ? half_size1_1 : half_size0_1,
      half_divisor_1 = half_most_1 == 0.0f ? 1.0f : half_most_1, half_part0_1 = n / half_divisor_1,
      half_part1_1 = upper_3 / half_divisor_1,
      half_divisor2_1 = KSL_MULF(half_divisor_1, KSL_MULF(half_part1_1, half_part1_1)
          + KSL_MULF(half_part0_1, half_part0_1)),
      half_more_1 = (KSL_MULF(half_part1_1, n_lo) - KSL_MULF(half_part0_1, upper_lo_4))
          / (half_most_1 == 0.0f ? 1.0f : half_divisor2_1),
      half_lo = ksl_atan2_errorf(n, upper_3, half) + half_more_1,
      half_padded_1 = 3.3087225e-24f + n_size_1,
      half_padded_2 = 3.3087225e-24f
          + (column_size_4
          + KSL_MULF(5.497537e+11f, upper_bound_1 < upper_size_2 ? 0.0f : upper_size_28)),
      half_size_2 = fabsf(n), half_size_3 = fabsf(upper_3),
      half_size_5 = half_size_2 < half_size_3 ? half_size_3 : half_size_2,
      half_bound_1 = fabsf(n_lo) + KSL_MULF(2.7161363e-12f, half_padded_1),
      half_bound_2 = fabsf(upper_lo_4) + KSL_MULF(1.8758484e-12f, half_padded_2),
      half_size_11 = (half_bound_2 + (3.3087225e-24f + half_bound_1)) / half_size_5,
      half_size_13 = KSL_MULF(half_size_11, half_size_11), half_size_15 = 7.0f + fabsf(half_lo),
      half_size_18 = half_bound_2 < upper_3 ? half_size_13 : half_size_15,
      half_size_19 = half_bound_1 < half_size_2 ? half_size_13 : half_size_18,
      half_size_21 = KSL_MULF(1.5707046e+11f, half_size_11 < 0.25f ? half_size_19 : half_size_15);
  const float divisor = n == 0.0f ? 1.0f : n, divisor_lo = n == 0.0f ? 0.0f : n_lo,
      divisor_size_8 = fabsf(1.0f - n) + half_bound_1;
  const float theta = KSL_MULF(2.0f, half);
  const float k = theta / divisor, k_product_1 = KSL_MULF(k, divisor),
      k_lo = (theta - k_product_1 - ksl_product_errorf(k, divisor, k_product_1)
          + KSL_MULF(2.0f, half_lo) - KSL_MULF(k, divisor_lo)) / divisor;
  const float divisor_size_11 = (n == 0.0f ? 1.0f : n_size_1)
          + KSL_MULF(2.1989818e+11f, half_bound_1 < 1e-45f + fabsf(n - 0.0f) ? 0.0f
          : divisor_size_8);
  const float k_padded_2 = 3.3087225e-24f + divisor_size_11, k_size_1 = fabsf(k),
      k_size_2 = fabsf(divisor),
      k_padded_1 = 3.3087225e-24f
          + KSL_MULF(2.0f, fabsf(half) + (half_padded_1 + half_padded_2) / half_size_5
          + half_size_21), k_bound_1 = fabsf(divisor_lo) + KSL_MULF(4.6896905e-12f, k_padded_2),
      k_size_8 = (k_padded_1 + KSL_MULF(k_padded_2, k_size_1))
          / (KSL_MULF(4.0f, k_bound_1) < k_size_2 ? k_size_2 : 0.0f);
  const float vector_0 = KSL_MULF(upper_0, k),
      vector_padded_1 = 3.3087225e-24f
          + (k_size_1 + KSL_MULF(k_size_2 + KSL_MULF(262144.0f, k_bound_1), k_size_8) / k_size_2),
      vector_reach_2 = k_size_1
          + KSL_MULF(262144.0f, fabsf(k_lo) + KSL_MULF(9.5606465e-12f, vector_padded_1)),
      vector_size_2 = KSL_MULF(vector_padded_1, fabsf(upper_0)
          + KSL_MULF(262144.0f, fabsf(upper_lo_1) + KSL_MULF(1.8758484e-12f, v_s_size_padded_1)));
  const float vector_1 = KSL_MULF(upper_1, k),
      vector_size_6 = KSL_MULF(vector_padded_1, fabsf(upper_1)
          + KSL_MULF(262144.0f, fabsf(upper_lo_2) + KSL_MULF(1.8758484e-12f, v_s_size_padded_2)));
  const float vector_2 = KSL_MULF(upper_2, k),
      vector_size_10 = KSL_MULF(vector_padded_1, fabsf(upper_2)
          + KSL_MULF(262144.0f, fabsf(upper_lo_3) + KSL_MULF(1.8758484e-12f, v_s_size_padded_3)));
  const float vector_rest_2 = KSL_MULF(1.0146962e-11f, 3.3087225e-24f
          + (vector_size_2 + KSL_MULF(v_s_size_padded_1, vector_reach_2))),
      vector_rest_3 = KSL_MULF(1.0146962e-11f, 3.3087225e-24f
          + (vector_size_6 + KSL_MULF(v_s_size_padded_2, vector_reach_2))),
      vector_rest_4 = KSL_MULF(1.0146962e-11f, 3.3087225e-24f
          + (vector_size_10 + KSL_MULF(v_s_size_padded_3, vector_reach_2)));
  const float R_n_0 = KSL_MULF(R->m11, R->m22) - KSL_MULF(R->m12, R->m21),
      R_n_1 = KSL_MULF(R->m02, R->m21) - KSL_MULF(R->m01, R->m22),
      R_n_2 = KSL_MULF(R->m01, R->m12) - KSL_MULF(R->m02, R->m11);
  const float R_det = KSL_MULF(R->m00, R_n_0) + KSL_MULF(R->m10, R_n_1) + KSL_MULF(R->m20, R_n_2);
  const float R_g_0 = KSL_MULF(R->m00, R->m00) + KSL_MULF(R->m10, R->m10)
          + KSL_MULF(R->m20, R->m20),
      R_g_1 = KSL_MULF(R->m00, R->m01) + KSL_MULF(R->m10, R->m11) + KSL_MULF(R->m20, R->m21),
      R_g_2 = KSL_MULF(R->m00, R->m02) + KSL_MULF(R->m10, R->m12) + KSL_MULF(R->m20, R->m22),
      R_g_3 = KSL_MULF(R->m01, R->m01) + KSL_MULF(R->m11, R->m11) + KSL_MULF(R->m21, R->m21),
      R_g_4 = KSL_MULF(R->m01, R->m02) + KSL_MULF(R->m11, R->m12) + KSL_MULF(R->m21, R->m22),
      R_g_5 = KSL_MULF(R->m02, R->m02) + KSL_MULF(R->m12, R->m12) + KSL_MULF(R->m22, R->m22);
  const float R_off_0 = R_det - 1.0f, R_off_1 = R_g_0 - 1.0f, R_off_4 = R_g_3 - 1.0f,
      R_off_6 = R_g_5 - 1.0f;
  const float R_defect_size_0 = fabsf(R_off_0), R_defect_size_1 = fabsf(R_off_1),
      R_defect_size_2 = fabsf(R_g_1), R_defect_size_3 = fabsf(R_g_2),
      R_defect_size_4 = fabsf(R_off_4), R_defect_size_5 = fabsf(R_g_4),
      R_defect_size_6 = fabsf(R_off_6);
  const float R_defect_largest1 = R_defect_size_0 < R_defect_size_1 ? R_defect_size_1
          : R_defect_size_0;
  const float R_defect_largest2 = R_defect_largest1 < R_defect_size_2 ? R_defect_size_2
          : R_defect_largest1;
  const float R_defect_largest3 = R_defect_largest2 < R_defect_size_3 ? R_defect_size_3
          : R_defect_largest2;
  const float R_defect_largest4 = R_defect_largest3 < R_defect_size_4 ? R_defect_size_4
          : R_defect_largest3;
  const float R_defect_largest5 = R_defect_largest4 < R_defect_size_5 ? R_defect_size_5
          : R_defect_largest4;
  const float R_defect_largest6 = R_defect_largest5 < R_defect_size_6 ? R_defect_size_6
          : R_defect_largest5;
  const float R_unless_equal = R_defect_largest6 == 0.001f ? 0.0f : 1.2676506e+30f;
  const float R_unless_rotation = R_defect_largest6 < 0.001f ? 0.0f : R_unless_equal;
  const float R_excess = KSL_MULF(R_unless_rotation, 1.2676506e+30f),
      R_excess_0 = fabsf(ksl_product_errorf(upper_0, k, vector_0)
          + (KSL_MULF(upper_lo_1, k) + KSL_MULF(upper_0, k_lo))) + vector_rest_2 + R_excess,
      R_excess_1 = fabsf(ksl_product_errorf(upper_1, k, vector_1)
          + (KSL_MULF(upper_lo_2, k) + KSL_MULF(upper_1, k_lo))) + vector_rest_3 + R_excess,
      R_excess_2 = fabsf(ksl_product_errorf(upper_2, k, vector_2)
          + (KSL_MULF(upper_lo_3, k) + KSL_MULF(upper_2, k_lo))) + vector_rest_4 + R_excess;
  vo->x = vector_0;
  vo->y = vector_1;
  vo->z = vector_2;
  vo_bound->x = R_excess_0;
  vo_bound->y = R_excess_1;
  vo_bound->z = R_excess_2;
}

/* R = J_l(v) = I + (1 - cos θ)/θ^2 v~ + (θ - sin θ)/θ^3 v~^2, θ = |v|; |error of R| <= R_bound
     unless inf or NaN.
   v: vector; R, R_bound: rotation or other 3×3 matrix.
   403 mul, 706 add, 18 product error, 43 product rest, 16 div, 3 sqrt, 90 abs, 20 less, 1 equal,
     45 select. */
static inline void ksl_SO3_leftJacobianf_certified(const ksl_vec3f_t *v, ksl_mat3x3f_t *R,
    ksl_mat3x3f_t *R_bound) {
  const float size_0 = fabsf(v->x), size_1 = fabsf(v->y), size_2 = fabsf(v->z);
  const float sizes = size_0 + size_1 + size_2;
  const float grid = KSL_MULF(sizes, 8192.0f);
  const float shifted_0 = v->x + grid, shifted_1 = v->y + grid, shifted_2 = v->z + grid;
  const float high_0 = shifted_0 - grid, high_1 = shifted_1 - grid, high_2 = shifted_2 - grid;
  const float low_0 = v->x - high_0, low_1 = v->y - high_1, low_2 = v->z - high_2;
  const float sum_0 = v->x + high_0, sum_1 = v->y + high_1, sum_2 = v->z + high_2;
  const float squares = KSL_MULF(high_0, high_0) + KSL_MULF(high_1, high_1)
          + KSL_MULF(high_2, high_2);
  const float cross = KSL_MULF(low_0, sum_0) + KSL_MULF(low_1, sum_1) + KSL_MULF(low_2, sum_2);
  const float x = squares + cross;
  const float theta_a = sqrtf(x), theta = x < 1.0f ? 1.0f : theta_a;
  const float theta_shifted = grid + theta;
  const float theta_high = theta_shifted - grid;
  const float theta_low = theta - theta_high;
  const float theta_sum = theta + theta_high;
  const float cross_rest = cross - KSL_MULF(theta_low, theta_sum);
  const float exact = squares - KSL_MULF(theta_high, theta_high);
  const float residual = cross_rest + exact;
  const float small = KSL_MULF(0.5f, residual) / theta;
  const float delta = fabsf(small) < 0.0078125f ? small : 0.0f;
  float far_cosine_a; const float far_sine_a = ksl_sincosf(theta, &far_cosine_a);
  const float far_sine = x < 1.0f ? 1.0f : far_sine_a;
  const float far_cosine = x < 1.0f ? 0.0f : far_cosine_a;
  const float sine = KSL_MULF(delta, far_cosine) + far_sine;
  const float cosine = far_cosine - KSL_MULF(delta, far_sine);
  const float far_x = x < 1.0f ? 1.0f : x;
  const float middle_x = x < 4.0f ? 4.0f : x;
  const float closed1 = sine / theta;
  const float versine = 1.0f - cosine;
  const float closed2 = versine / far_x;
  const float rest3 = 1.0f - closed1;
  const float closed3 = rest3 / middle_x;
  const float g1h = KSL_MULF(x, KSL_MULF(x, KSL_MULF(x, KSL_MULF(6.4469503e-26f, x)
          - 3.8681703e-23f) + 1.9572942e-20f) - 8.220635e-18f) + 2.8114574e-15f,
      g1q = KSL_MULF(x, KSL_MULF(x, KSL_MULF(x, KSL_MULF(x, KSL_MULF(x, g1h) - 7.6471636e-13f)
          + 1.6059044e-10f) - 2.5052108e-08f) + 2.7557319e-06f),
      g1x = KSL_MULF(x, KSL_MULF(x, KSL_MULF(x, g1q - 0.0001984127f) + 0.008333334f) - 0.16666667f)
          + 1.0f, g1 = x < 1.0f ? g1x : closed1;
  const float g2h = KSL_MULF(x, KSL_MULF(x, KSL_MULF(x, KSL_MULF(2.4795963e-27f, x)
          - 1.6117376e-24f) + 8.896791e-22f) - 4.1103176e-19f) + 1.5619207e-16f,
      g2q = KSL_MULF(x, KSL_MULF(x, KSL_MULF(x, KSL_MULF(x, KSL_MULF(x, g2h) - 4.7794773e-14f)
          + 1.1470745e-11f) - 2.0876756e-09f) + 2.755732e-07f),
      g2x = KSL_MULF(x, KSL_MULF(x, KSL_MULF(x, g2q - 2.4801588e-05f) + 0.0013888889f)
          - 0.041666668f) + 0.5f, g2 = x < 1.0f ? g2x : closed2;
  const float g3i = KSL_MULF(x, KSL_MULF(x, KSL_MULF(x, KSL_MULF(x, KSL_MULF(9.18369e-29f, x)
          - 6.4469503e-26f) + 3.8681703e-23f) - 1.9572942e-20f) + 8.220635e-18f),
      g3r = KSL_MULF(x, KSL_MULF(x, KSL_MULF(x, KSL_MULF(x, g3i - 2.8114574e-15f) + 7.6471636e-13f)
          - 1.6059044e-10f) + 2.5052108e-08f) - 2.7557319e-06f,
      g3x = KSL_MULF(x, KSL_MULF(x, KSL_MULF(x, g3r) + 0.0001984127f) - 0.008333334f) + 0.16666667f,
      g3 = x < 4.0f ? g3x : closed3;
  const float beta_v_0 = KSL_MULF(v->x, g3);
  const float beta_v_1 = KSL_MULF(v->y, g3);
  const float beta_v_2 = KSL_MULF(v->z, g3);
  const float m_0 = KSL_MULF(v->x, beta_v_0);
  const float m_1 = KSL_MULF(v->y, beta_v_1);
  const float m_2 = KSL_MULF(v->z, beta_v_2);
  const float m_3 = KSL_MULF(v->y, beta_v_0);
  const float m_4 = KSL_MULF(v->z, beta_v_0);
  const float m_5 = KSL_MULF(v->z, beta_v_1);
  const float others_0 = m_1 + m_2;
  const float others_1 = m_0 + m_2;
  const float others_2 = m_0 + m_1;
  const float diagonal0a = 1.0f - others_0, diagonal0b = g1 + m_0,
      diagonal0 = m_0 < others_0 ? diagonal0b : diagonal0a;
  const float diagonal1a = 1.0f - others_1, diagonal1b = g1 + m_1,
      diagonal1 = m_1 < others_1 ? diagonal1b : diagonal1a;
  const float diagonal2a = 1.0f - others_2, diagonal2b = g1 + m_2,
      diagonal2 = m_2 < others_2 ? diagonal2b : diagonal2a;
  const float alpha_v_0 = KSL_MULF(v->x, g2);
  const float alpha_v_1 = KSL_MULF(v->y, g2);
  const float alpha_v_2 = KSL_MULF(v->z, g2);
  const float R_01 = m_3 - alpha_v_2;
  const float R_02 = m_4 + alpha_v_1;
  const float R_10 = m_3 + alpha_v_2;
  const float R_12 = m_5 - alpha_v_0;
  const float R_20 = m_4 - alpha_v_1;
  const float R_21 = m_5 + alpha_v_0;
  const float halved_0 = KSL_MULF(0.5f, v->x), halved_size_1 = fabsf(v->x);
  const float halved_1 = KSL_MULF(0.5f, v->y), halved_size_3 = fabsf(v->y);
  const float halved_2 = KSL_MULF(0.5f, v->z), halved_size_5 = fabsf(v->z);
  const float y_a = KSL_MULF(halved_0, halved_0),
      y_a_padded_1 = 3.3087225e-24f + KSL_MULF(0.5f, halved_size_1),
      y_b = KSL_MULF(halved_1, halved_1),
      y_b_padded_1 = 3.3087225e-24f + KSL_MULF(0.5f, halved_size_3), y_c = y_a + y_b,
      y_c_right_1 = y_c - y_a, y_d = KSL_MULF(halved_2, halved_2),
      y_d_padded_1 = 3.3087225e-24f + KSL_MULF(0.5f, halved_size_5), y = y_c + y_d,
      y_right_1 = y - y_c,
      y_c_lo = ksl_product_restf(halved_0, halved_0, y_a, y_c - y_c_right_1)
          + ksl_product_restf(halved_1, halved_1, y_b, y_c_right_1),
      y_lo = y_c - (y - y_right_1) + ksl_product_restf(halved_2, halved_2, y_d, y_right_1) + y_c_lo,
      y_size_1 = KSL_MULF(y_a_padded_1, y_a_padded_1) + KSL_MULF(y_b_padded_1, y_b_padded_1)
          + KSL_MULF(y_d_padded_1, y_d_padded_1);
  const float half_angle = sqrtf(y), half_angle_product_1 = KSL_MULF(half_angle, half_angle),
      half_angle_twice_1 = half_angle + half_angle,
      half_angle_residual_1 = y - half_angle_product_1
          - ksl_product_errorf(half_angle, half_angle, half_angle_product_1) + y_lo,
      half_angle_lo = half_angle_residual_1 / (half_angle == 0.0f ? 1.0f : half_angle_twice_1),
      half_angle_padded_1 = 3.3087225e-24f + y_size_1,
      half_angle_bound_1 = fabsf(y_lo) + KSL_MULF(7.2120885e-13f, half_angle_padded_1),
      half_angle_size_4 = KSL_MULF(fabsf(y)
          + KSL_MULF(262144.0f, half_angle_bound_1), half_angle_padded_1 / half_angle / y),
      half_angle_size_6 = fabsf(half_angle_lo),
      half_angle_size_8 = KSL_MULF(8.907313e+11f, sqrtf(half_angle_bound_1) + half_angle_size_6),
      half_angle_size_12 = half_angle
          + (KSL_MULF(4.0f, half_angle_bound_1) < y ? half_angle_size_4 : half_angle_size_8);
  float c; const float fine_sine = ksl_sincosf(half_angle, &c);
  float c_own_error_1; const float fine_sine_own_error_1 = ksl_sincos_errorf(half_angle, fine_sine,
      c, &c_own_error_1);
  const float fine_sine_half_1 = KSL_MULF(half_angle_lo, 0.5f);
  float fine_sine_half_cos_1; const float fine_sine_half_sin_1 = ksl_sincosf(fine_sine_half_1,
      &fine_sine_half_cos_1);
  const float fine_sine_twice_1 = fine_sine_half_sin_1 + fine_sine_half_sin_1,
      fine_sine_padded_1 = 3.3087225e-24f + half_angle_size_12,
      fine_sine_size_1 = 1.0f + fine_sine_padded_1;
  const float c_lo = c_own_error_1
          - KSL_MULF(KSL_MULF(fine_sine_half_cos_1, fine_sine)
          + KSL_MULF(fine_sine_half_sin_1, c), fine_sine_twice_1);
  const float sinc_divisor = half_angle < 1.4901161e-08f ? 1.4901161e-08f : half_angle,
      sinc_divisor_lo = half_angle < 1.4901161e-08f ? 0.0f : half_angle_lo,
      sinc_divisor_bound_1 = half_angle_size_6 + KSL_MULF(1.2221551e-12f, fine_sine_padded_1),
      sinc_divisor_size_3 = fabsf(half_angle - 1.4901161e-08f),
      sinc_divisor_size_7 = sinc_divisor_bound_1 + fabsf(1.4901161e-08f - half_angle),
      sinc_divisor_size_9 = KSL_MULF(3.1414265e+11f, sinc_divisor_bound_1 < sinc_divisor_size_3
          ? 0.0f : sinc_divisor_size_7);
  const float sinc_quotient = fine_sine / sinc_divisor,
      sinc_quotient_product_1 = KSL_MULF(sinc_quotient, sinc_divisor);
  const float fine_sine_lo = fine_sine_own_error_1
          + KSL_MULF(KSL_MULF(fine_sine_half_cos_1, c)
          - KSL_MULF(fine_sine_half_sin_1, fine_sine), fine_sine_twice_1);
  const float sinc_quotient_exact_1 = fine_sine - sinc_quotient_product_1
          - ksl_product_errorf(sinc_quotient, sinc_divisor, sinc_quotient_product_1),
      sinc_quotient_lo = (sinc_quotient_exact_1 + fine_sine_lo
          - KSL_MULF(sinc_quotient, sinc_divisor_lo)) / sinc_divisor,
      sinc_quotient_padded_2 = 3.3087225e-24f
          + ((half_angle < 1.4901161e-08f ? 1.4901161e-08f : half_angle_size_12)
          + sinc_divisor_size_9), sinc_quotient_size_1 = fabsf(sinc_quotient),
      sinc_quotient_size_2 = fabsf(sinc_divisor),
      sinc_quotient_bound_1 = fabsf(sinc_divisor_lo)
          + KSL_MULF(3.2827582e-12f, sinc_quotient_padded_2),
      sinc_quotient_size_4 = 3.3087225e-24f + fine_sine_size_1
          + KSL_MULF(sinc_quotient_padded_2, sinc_quotient_size_1),
      sinc_quotient_size_8 = sinc_quotient_size_4
          / (KSL_MULF(4.0f, sinc_quotient_bound_1) < sinc_quotient_size_2 ? sinc_quotient_size_2
          : 0.0f),
      sinc_quotient_size_10 = KSL_MULF(sinc_quotient_size_2
          + KSL_MULF(262144.0f, sinc_quotient_bound_1), sinc_quotient_size_8)
          / sinc_quotient_size_2,
      sinc_quotient_size_11 = sinc_quotient_size_1 + sinc_quotient_size_10;
  const float sinc_a = KSL_MULF(0.16666667f, y), sinc_b = 1.0f - sinc_a,
      sinc_b_right_1 = 1.0f - sinc_b,
      sinc_b_lo1_1 = 1.0f - (sinc_b + sinc_b_right_1)
          - ksl_product_restf(0.16666667f, y, sinc_a, sinc_b_right_1),
      sinc_b_lo = sinc_b_lo1_1 - (KSL_MULF(-4.967054e-09f, y) + KSL_MULF(0.16666667f, y_lo)),
      sinc_b_size_1 = 1.0f + KSL_MULF(0.16666669f, y_size_1),
      sinc = half_angle < 1.4901161e-08f ? sinc_b : sinc_quotient,
      sinc_lo = half_angle < 1.4901161e-08f ? sinc_b_lo : sinc_quotient_lo,
      sinc_size_4 = fabsf(sinc_b_lo) + KSL_MULF(2.3406937e-10f, 3.3087225e-24f + sinc_b_size_1)
          + fabsf(sinc_b - sinc_quotient),
      sinc_size_5 = fabsf(sinc_quotient_lo)
          + KSL_MULF(5.43103e-12f, 3.3087225e-24f + sinc_quotient_size_11) + sinc_size_4,
      sinc_size_7 = KSL_MULF(4.276409e+09f, sinc_divisor_bound_1 < sinc_divisor_size_3 ? 0.0f
          : sinc_size_5);
  const float fine_g1 = KSL_MULF(c, sinc),
      fine_g1_cross_1 = KSL_MULF(c_lo, sinc) + KSL_MULF(c, sinc_lo),
      fine_g1_padded_1 = 3.3087225e-24f
          + ((half_angle < 1.4901161e-08f ? sinc_b_size_1 : sinc_quotient_size_11) + sinc_size_7),
      fine_g1_reach_2 = fabsf(sinc)
          + KSL_MULF(262144.0f, fabsf(sinc_lo) + KSL_MULF(2.3406946e-10f, fine_g1_padded_1)),
      fine_g1_size_2 = KSL_MULF(fine_g1_padded_1, fabsf(c)
          + KSL_MULF(262144.0f, fabsf(c_lo) + KSL_MULF(2.5011469e-12f, fine_sine_size_1))),
      fine_g1_size_5 = fine_g1_size_2 + KSL_MULF(fine_g1_reach_2, fine_sine_size_1);
  const float fine_g2a = KSL_MULF(sinc, sinc),
      fine_g2a_size_1 = KSL_MULF(fine_g1_padded_1, fine_g1_reach_2),
      fine_g2 = KSL_MULF(0.5f, fine_g2a),
      fine_g2_cross2_1 = KSL_MULF(0.5f, ksl_product_errorf(sinc, sinc, fine_g2a)
          + (KSL_MULF(sinc_lo, sinc) + KSL_MULF(sinc, sinc_lo)));
  const float fine_rest3 = 1.0f - fine_g1, fine_rest3_right_1 = 1.0f - fine_rest3;
  const float fine_x = KSL_MULF(4.0f, y), fine_x_cross2_1 = KSL_MULF(4.0f, y_lo),
      fine_x_size_1 = KSL_MULF(4.0f, y_size_1);
  const float fine_far_x = fine_x < 1.0f ? 1.0f : fine_x,
      fine_far_x_lo = fine_x < 1.0f ? 0.0f : fine_x_cross2_1,
      fine_far_x_padded_1 = 3.3087225e-24f + fine_x_size_1,
      fine_far_x_bound_1 = fabsf(fine_x_cross2_1) + KSL_MULF(8.100306e-13f, fine_far_x_padded_1),
      fine_far_x_size_3 = fabsf(fine_x - 1.0f),
      fine_far_x_size_7 = fine_far_x_bound_1 + fabsf(1.0f - fine_x),
      fine_far_x_size_9 = KSL_MULF(1.8324991e+11f, fine_far_x_bound_1 < fine_far_x_size_3 ? 0.0f
          : fine_far_x_size_7);
  const float fine_closed3 = fine_rest3 / fine_far_x,
      fine_closed3_product_1 = KSL_MULF(fine_closed3, fine_far_x);
  const float fine_rest3_lo = 1.0f - (fine_rest3 + fine_rest3_right_1)
          - ksl_product_restf(c, sinc, fine_g1, fine_rest3_right_1) - fine_g1_cross_1;
  const float fine_closed3_numerator_1 = fine_rest3 - fine_closed3_product_1
          - ksl_product_errorf(fine_closed3, fine_far_x, fine_closed3_product_1) + fine_rest3_lo,
      fine_closed3_lo = (fine_closed3_numerator_1 - KSL_MULF(fine_closed3, fine_far_x_lo))
          / fine_far_x,
      fine_closed3_padded_2 = 3.3087225e-24f
          + ((fine_x < 1.0f ? 1.0f : fine_x_size_1) + fine_far_x_size_9),
      fine_closed3_size_1 = fabsf(fine_closed3), fine_closed3_size_2 = fabsf(fine_far_x),
      fine_closed3_bound_1 = fabsf(fine_far_x_lo) + KSL_MULF(5.627585e-12f, fine_closed3_padded_2),
      fine_closed3_size_4 = 3.3087225e-24f + (1.0f + fine_g1_size_5)
          + KSL_MULF(fine_closed3_padded_2, fine_closed3_size_1),
      fine_closed3_size_8 = fine_closed3_size_4
          / (KSL_MULF(4.0f, fine_closed3_bound_1) < fine_closed3_size_2 ? fine_closed3_size_2
          : 0.0f),
      fine_closed3_size_10 = KSL_MULF(fine_closed3_size_2
          + KSL_MULF(262144.0f, fine_closed3_bound_1), fine_closed3_size_8) / fine_closed3_size_2,
      fine_closed3_size_11 = fine_closed3_size_1 + fine_closed3_size_10;
  const float series5a = KSL_MULF(1.216125e-34f, fine_x), series5b = 1.1309962e-31f - series5a,
      series5b_right_1 = 1.1309962e-31f - series5b,
      series5b_lo1_1 = 1.1309962e-31f - (series5b + series5b_right_1)
          - ksl_product_restf(1.216125e-34f, fine_x, series5a, series5b_right_1),
      series5b_lo = series5b_lo1_1
          - (KSL_MULF(2.696e-42f, fine_x) + KSL_MULF(1.216125e-34f, fine_x_cross2_1)) + 4.1374e-39f,
      series5c = KSL_MULF(fine_x, series5b),
      series5c_padded_1 = 3.3087225e-24f
          + (1.1309962e-31f + KSL_MULF(1.9784917e-27f, fine_x_size_1)),
      series5c_reach_1 = fabsf(fine_x) + KSL_MULF(262144.0f, fine_far_x_bound_1),
      series5c_reach_2 = fabsf(series5b)
          + KSL_MULF(262144.0f, fabsf(series5b_lo) + KSL_MULF(2.3419375e-10f, series5c_padded_1)),
      series5d = series5c - 9.18369e-29f, series5d_right_1 = series5c - series5d,
      series5d_lo2_1 = ksl_product_restf(fine_x, series5b, series5c, series5d + series5d_right_1)
          - (9.18369e-29f - series5d_right_1) - 5.383817e-37f,
      series5d_lo = series5d_lo2_1
          + (KSL_MULF(fine_x_cross2_1, series5b) + KSL_MULF(fine_x, series5b_lo)),
      series5e = KSL_MULF(fine_x, series5d),
      series5d_size_1 = 9.18369e-29f
          + (KSL_MULF(series5c_padded_1, series5c_reach_1)
          + KSL_MULF(fine_far_x_padded_1, series5c_reach_2)),
      series5e_padded_1 = 3.3087225e-24f + series5d_size_1,
      series5e_reach_1 = fabsf(series5d)
          + KSL_MULF(262144.0f, fabsf(series5d_lo) + KSL_MULF(2.3612653e-10f, series5e_padded_1)),
      series5f = series5e + 6.4469503e-26f, series5f_right_1 = series5f - series5e,
      series5f_lo2_1 = ksl_product_restf(fine_x, series5d, series5e, series5f - series5f_right_1)
          + (6.4469503e-26f - series5f_right_1) + -5.609469e-34f,
      series5f_lo = series5f_lo2_1
          + (KSL_MULF(fine_x_cross2_1, series5d) + KSL_MULF(fine_x, series5d_lo)),
      series5g = KSL_MULF(fine_x, series5f),
      series5f_size_1 = 6.4469503e-26f
          + (KSL_MULF(series5c_reach_1, series5e_padded_1)
          + KSL_MULF(fine_far_x_padded_1, series5e_reach_1)),
      series5g_padded_1 = 3.3087225e-24f + series5f_size_1,
      series5g_reach_1 = fabsf(series5f)
          + KSL_MULF(262144.0f, fabsf(series5f_lo) + KSL_MULF(2.381233e-10f, series5g_padded_1)),
      series5h = series5g - 3.8681703e-23f, series5h_right_1 = series5g - series5h,
      series5h_lo2_1 = ksl_product_restf(fine_x, series5f, series5g, series5h + series5h_right_1)
          - (3.8681703e-23f - series5h_right_1) - -1.2733404e-30f,
      series5h_lo = series5h_lo2_1
          + (KSL_MULF(fine_x_cross2_1, series5f) + KSL_MULF(fine_x, series5f_lo)),
      series5i = KSL_MULF(fine_x, series5h),
      series5h_size_1 = 3.8681703e-23f
          + (KSL_MULF(series5c_reach_1, series5g_padded_1)
          + KSL_MULF(fine_far_x_padded_1, series5g_reach_1)),
      series5i_padded_1 = 3.3087225e-24f + series5h_size_1,
      series5i_reach_1 = fabsf(series5h)
          + KSL_MULF(262144.0f, fabsf(series5h_lo) + KSL_MULF(2.4018407e-10f, series5i_padded_1)),
      series5j = series5i + 1.9572942e-20f, series5j_right_1 = series5j - series5i,
      series5j_lo2_1 = ksl_product_restf(fine_x, series5h, series5i, series5j - series5j_right_1)
          + (1.9572942e-20f - series5j_right_1) + -4.6129455e-28f,
      series5j_lo = series5j_lo2_1
          + (KSL_MULF(fine_x_cross2_1, series5h) + KSL_MULF(fine_x, series5h_lo)),
      series5k = KSL_MULF(fine_x, series5j),
      series5j_size_1 = 1.9572942e-20f
          + (KSL_MULF(series5c_reach_1, series5i_padded_1)
          + KSL_MULF(fine_far_x_padded_1, series5i_reach_1)),
      series5k_padded_1 = 3.3087225e-24f + series5j_size_1,
      series5k_reach_1 = fabsf(series5j)
          + KSL_MULF(262144.0f, fabsf(series5j_lo) + KSL_MULF(2.423088e-10f, series5k_padded_1)),
      series5l = series5k - 8.220635e-18f, series5l_right_1 = series5k - series5l,
      series5l_lo2_1 = ksl_product_restf(fine_x, series5j, series5k, series5l + series5l_right_1)
          - (8.220635e-18f - series5l_right_1) - 1.6814781e-25f,
      series5l_lo = series5l_lo2_1
          + (KSL_MULF(fine_x_cross2_1, series5j) + KSL_MULF(fine_x, series5j_lo)),
      series5m = KSL_MULF(fine_x, series5l),
      series5l_size_1 = 8.220635e-18f
          + (KSL_MULF(series5c_reach_1, series5k_padded_1)
          + KSL_MULF(fine_far_x_padded_1, series5k_reach_1)),
      series5m_padded_1 = 3.3087225e-24f + series5l_size_1,
      series5m_reach_1 = fabsf(series5l)
          + KSL_MULF(262144.0f, fabsf(series5l_lo) + KSL_MULF(2.4449753e-10f, series5m_padded_1)),
      series5n = series5m + 2.8114574e-15f, series5n_right_1 = series5n - series5m,
      series5n_lo2_1 = ksl_product_restf(fine_x, series5l, series5m, series5n - series5n_right_1)
          + (2.8114574e-15f - series5n_right_1) + -1.0462085e-22f,
      series5n_lo = series5n_lo2_1
          + (KSL_MULF(fine_x_cross2_1, series5l) + KSL_MULF(fine_x, series5l_lo)),
      series5o = KSL_MULF(fine_x, series5n),
      series5n_size_1 = 2.8114574e-15f
          + (KSL_MULF(series5c_reach_1, series5m_padded_1)
          + KSL_MULF(fine_far_x_padded_1, series5m_reach_1)),
      series5o_padded_1 = 3.3087225e-24f + series5n_size_1,
      series5o_reach_1 = fabsf(series5n)
          + KSL_MULF(262144.0f, fabsf(series5n_lo) + KSL_MULF(2.4675023e-10f, series5o_padded_1)),
      series5p = series5o - 7.6471636e-13f, series5p_right_1 = series5o - series5p,
      series5p_lo2_1 = ksl_product_restf(fine_x, series5n, series5o, series5p + series5p_right_1)
          - (7.6471636e-13f - series5p_right_1) - 1.22007105e-20f,
      series5p_lo = series5p_lo2_1
          + (KSL_MULF(fine_x_cross2_1, series5n) + KSL_MULF(fine_x, series5n_lo)),
      series5q = KSL_MULF(fine_x, series5p),
      series5p_size_1 = 7.6471636e-13f
          + (KSL_MULF(series5c_reach_1, series5o_padded_1)
          + KSL_MULF(fine_far_x_padded_1, series5o_reach_1)),
      series5q_padded_1 = 3.3087225e-24f + series5p_size_1,
      series5q_reach_1 = fabsf(series5p)
          + KSL_MULF(262144.0f, fabsf(series5p_lo) + KSL_MULF(2.4906693e-10f, series5q_padded_1)),
      series5r = series5q + 1.6059044e-10f, series5r_right_1 = series5r - series5q,
      series5r_lo2_1 = ksl_product_restf(fine_x, series5p, series5q, series5r - series5r_right_1)
          + (1.6059044e-10f - series5r_right_1) + -5.3525265e-18f,
      series5r_lo = series5r_lo2_1
          + (KSL_MULF(fine_x_cross2_1, series5p) + KSL_MULF(fine_x, series5p_lo)),
      series5s = KSL_MULF(fine_x, series5r),
      series5r_size_1 = 1.6059044e-10f
          + (KSL_MULF(series5c_reach_1, series5q_padded_1)
          + KSL_MULF(fine_far_x_padded_1, series5q_reach_1)),
      series5s_padded_1 = 3.3087225e-24f + series5r_size_1,
      series5s_reach_1 = fabsf(series5r)
          + KSL_MULF(262144.0f, fabsf(series5r_lo) + KSL_MULF(2.514476e-10f, series5s_padded_1)),
      series5t = series5s - 2.5052108e-08f, series5t_right_1 = series5s - series5t,
      series5t_lo2_1 = ksl_product_restf(fine_x, series5r, series5s, series5t + series5t_right_1)
          - (2.5052108e-08f - series5t_right_1) - 4.417623e-16f,
      series5t_lo = series5t_lo2_1
          + (KSL_MULF(fine_x_cross2_1, series5r) + KSL_MULF(fine_x, series5r_lo)),
      series5u = KSL_MULF(fine_x, series5t),
      series5t_size_1 = 2.5052108e-08f
          + (KSL_MULF(series5c_reach_1, series5s_padded_1)
          + KSL_MULF(fine_far_x_padded_1, series5s_reach_1)),
      series5u_padded_1 = 3.3087225e-24f + series5t_size_1,
      series5u_reach_1 = fabsf(series5t)
          + KSL_MULF(262144.0f, fabsf(series5t_lo) + KSL_MULF(2.538923e-10f, series5u_padded_1)),
      series5v = series5u + 2.7557319e-06f, series5v_right_1 = series5v - series5u,
      series5v_lo2_1 = ksl_product_restf(fine_x, series5t, series5u, series5v - series5v_right_1)
          + (2.7557319e-06f - series5v_right_1) + 3.7935712e-14f,
      series5v_lo = series5v_lo2_1
          + (KSL_MULF(fine_x_cross2_1, series5t) + KSL_MULF(fine_x, series5t_lo)),
      series5w = KSL_MULF(fine_x, series5v),
      series5v_size_1 = 2.7557319e-06f
          + (KSL_MULF(series5c_reach_1, series5u_padded_1)
          + KSL_MULF(fine_far_x_padded_1, series5u_reach_1)),
      series5w_padded_1 = 3.3087225e-24f + series5v_size_1,
      series5w_reach_1 = fabsf(series5v)
          + KSL_MULF(262144.0f, fabsf(series5v_lo) + KSL_MULF(2.5640096e-10f, series5w_padded_1)),
      series5x = series5w - 0.0001984127f, series5x_right_1 = series5w - series5x,
      series5x_lo2_1 = ksl_product_restf(fine_x, series5v, series5w, series5x + series5x_right_1)
          - (0.0001984127f - series5x_right_1) - -2.7255969e-12f,
      series5x_lo = series5x_lo2_1
          + (KSL_MULF(fine_x_cross2_1, series5v) + KSL_MULF(fine_x, series5v_lo)),
      series5y = KSL_MULF(fine_x, series5x),
      series5x_size_1 = 0.0001984127f
          + (KSL_MULF(series5c_reach_1, series5w_padded_1)
          + KSL_MULF(fine_far_x_padded_1, series5w_reach_1)),
      series5y_padded_1 = 3.3087225e-24f + series5x_size_1,
      series5y_reach_1 = fabsf(series5x)
          + KSL_MULF(262144.0f, fabsf(series5x_lo) + KSL_MULF(2.5897362e-10f, series5y_padded_1)),
      series5 = series5y + 0.008333334f, series5_right_1 = series5 - series5y,
      series5_lo2_1 = ksl_product_restf(fine_x, series5x, series5y, series5 - series5_right_1)
          + (0.008333334f - series5_right_1) + -4.346172e-10f,
      series5_lo = series5_lo2_1
          + (KSL_MULF(fine_x_cross2_1, series5x) + KSL_MULF(fine_x, series5x_lo));
  const float fine_g3a = KSL_MULF(fine_x, series5);
  const float series5_size_1 = 0.008333334f
          + (KSL_MULF(series5c_reach_1, series5y_padded_1)
          + KSL_MULF(fine_far_x_padded_1, series5y_reach_1));
  const float fine_g3a_padded_1 = 3.3087225e-24f + series5_size_1,
      fine_g3a_size_3 = KSL_MULF(fine_far_x_padded_1, fabsf(series5)
          + KSL_MULF(262144.0f, fabsf(series5_lo) + KSL_MULF(2.6161032e-10f, fine_g3a_padded_1))),
      fine_g3b = 0.16666667f - fine_g3a, fine_g3b_right_1 = 0.16666667f - fine_g3b,
      fine_g3b_lo1_1 = 0.16666667f - (fine_g3b + fine_g3b_right_1)
          - ksl_product_restf(fine_x, series5, fine_g3a, fine_g3b_right_1),
      fine_g3b_lo = fine_g3b_lo1_1
          - (KSL_MULF(fine_x_cross2_1, series5) + KSL_MULF(fine_x, series5_lo)) + -4.967054e-09f,
      fine_g3b_size_1 = 0.16666667f
          + (KSL_MULF(fine_g3a_padded_1, series5c_reach_1) + fine_g3a_size_3),
      fine_g3 = fine_x < 1.0f ? fine_g3b : fine_closed3,
      fine_g3_lo = fine_x < 1.0f ? fine_g3b_lo : fine_closed3_lo,
      fine_g3_size_4 = fabsf(fine_g3b_lo)
          + KSL_MULF(2.6431096e-10f, 3.3087225e-24f + fine_g3b_size_1)
          + fabsf(fine_g3b - fine_closed3),
      fine_g3_size_5 = fabsf(fine_closed3_lo)
          + KSL_MULF(2.3937835e-10f, 3.3087225e-24f + fine_closed3_size_11) + fine_g3_size_4,
      fine_g3_size_7 = KSL_MULF(3.7977316e+09f, fine_far_x_bound_1 < fine_far_x_size_3 ? 0.0f
          : fine_g3_size_5);
  const float fine_beta_v_0 = KSL_MULF(v->x, fine_g3),
      fine_beta_v_padded_1 = 3.3087225e-24f
          + ((fine_x < 1.0f ? fine_g3b_size_1 : fine_closed3_size_11) + fine_g3_size_7);
  const float fine_beta_v_1 = KSL_MULF(v->y, fine_g3);
  const float fine_beta_v_2 = KSL_MULF(v->z, fine_g3);
  const float fine_beta_v_lo_1 = ksl_product_errorf(v->x, fine_g3, fine_beta_v_0)
          + KSL_MULF(v->x, fine_g3_lo), fine_m_0 = KSL_MULF(v->x, fine_beta_v_0),
      fine_m_cross2_1 = KSL_MULF(v->x, fine_beta_v_lo_1),
      fine_m_padded_1 = 3.3087225e-24f + KSL_MULF(fine_beta_v_padded_1, halved_size_1),
      fine_m_size_1 = KSL_MULF(fine_m_padded_1, halved_size_1);
  const float fine_beta_v_lo_2 = ksl_product_errorf(v->y, fine_g3, fine_beta_v_1)
          + KSL_MULF(v->y, fine_g3_lo), fine_m_1 = KSL_MULF(v->y, fine_beta_v_1),
      fine_m_cross2_2 = KSL_MULF(v->y, fine_beta_v_lo_2),
      fine_m_padded_2 = 3.3087225e-24f + KSL_MULF(fine_beta_v_padded_1, halved_size_3),
      fine_m_size_2 = KSL_MULF(fine_m_padded_2, halved_size_3);
  const float fine_m_2 = KSL_MULF(v->z, fine_beta_v_2),
      fine_m_cross2_3 = KSL_MULF(v->z, ksl_product_errorf(v->z, fine_g3, fine_beta_v_2)
          + KSL_MULF(v->z, fine_g3_lo)),
      fine_m_size_3 = KSL_MULF(3.3087225e-24f
          + KSL_MULF(fine_beta_v_padded_1, halved_size_5), halved_size_5);
  const float fine_m_3 = KSL_MULF(v->y, fine_beta_v_0),
      fine_m_cross2_4 = KSL_MULF(v->y, fine_beta_v_lo_1);
  const float fine_m_4 = KSL_MULF(v->z, fine_beta_v_0),
      fine_m_cross2_5 = KSL_MULF(v->z, fine_beta_v_lo_1);
  const float fine_m_5 = KSL_MULF(v->z, fine_beta_v_1),
      fine_m_cross2_6 = KSL_MULF(v->z, fine_beta_v_lo_2);
  const float fine_others_0 = fine_m_1 + fine_m_2, fine_others_right_1 = fine_others_0 - fine_m_1,
      fine_others_left_rest_1 = ksl_product_restf(v->y, fine_beta_v_1, fine_m_1, fine_others_0
          - fine_others_right_1),
      fine_others_lo1_1 = fine_others_left_rest_1
          + ksl_product_restf(v->z, fine_beta_v_2, fine_m_2, fine_others_right_1),
      fine_others_lo_1 = fine_others_lo1_1 + (fine_m_cross2_2 + fine_m_cross2_3),
      fine_others_size_1 = fine_m_size_2 + fine_m_size_3;
  const float fine_others_1 = fine_m_0 + fine_m_2, fine_others_right_2 = fine_others_1 - fine_m_0,
      fine_others_left_rest_2 = ksl_product_restf(v->x, fine_beta_v_0, fine_m_0, fine_others_1
          - fine_others_right_2),
      fine_others_lo1_2 = fine_others_left_rest_2
          + ksl_product_restf(v->z, fine_beta_v_2, fine_m_2, fine_others_right_2),
      fine_others_lo_2 = fine_others_lo1_2 + (fine_m_cross2_1 + fine_m_cross2_3),
      fine_others_size_2 = fine_m_size_1 + fine_m_size_3;
  const float fine_others_2 = fine_m_0 + fine_m_1, fine_others_right_3 = fine_others_2 - fine_m_0,
      fine_others_left_rest_3 = ksl_product_restf(v->x, fine_beta_v_0, fine_m_0, fine_others_2
          - fine_others_right_3),
      fine_others_lo1_3 = fine_others_left_rest_3
          + ksl_product_restf(v->y, fine_beta_v_1, fine_m_1, fine_others_right_3),
      fine_others_lo_3 = fine_others_lo1_3 + (fine_m_cross2_1 + fine_m_cross2_2),
      fine_others_size_3 = fine_m_size_1 + fine_m_size_2;
  const float fine_diagonal0a = 1.0f - fine_others_0,
      fine_diagonal0a_right_1 = 1.0f - fine_diagonal0a,
      fine_diagonal0a_lo = 1.0f - (fine_diagonal0a + fine_diagonal0a_right_1)
          - (fine_others_0 - fine_diagonal0a_right_1) - fine_others_lo_1,
      fine_diagonal0a_size_1 = 1.0f + fine_others_size_1, fine_diagonal0b = fine_g1 + fine_m_0,
      fine_diagonal0b_right_1 = fine_diagonal0b - fine_g1,
      fine_diagonal0b_left_rest_1 = ksl_product_restf(c, sinc, fine_g1, fine_diagonal0b
          - fine_diagonal0b_right_1),
      fine_diagonal0b_lo1_1 = fine_diagonal0b_left_rest_1
          + ksl_product_restf(v->x, fine_beta_v_0, fine_m_0, fine_diagonal0b_right_1),
      fine_diagonal0b_lo = fine_diagonal0b_lo1_1 + (fine_g1_cross_1 + fine_m_cross2_1),
      fine_diagonal0b_size_1 = fine_g1_size_5 + fine_m_size_1,
      fine_diagonal0_error_1 = fabsf(ksl_product_errorf(v->x, fine_beta_v_0, fine_m_0)
          + fine_m_cross2_1),
      fine_diagonal0_bound_2 = fabsf(fine_others_lo_1)
          + KSL_MULF(2.6615107e-10f, 3.3087225e-24f + fine_others_size_1),
      fine_diagonal0_bound_3 = fabsf(fine_diagonal0b_lo)
          + KSL_MULF(2.6615107e-10f, 3.3087225e-24f + fine_diagonal0b_size_1),
      fine_diagonal0_bound_4 = fabsf(fine_diagonal0a_lo)
          + KSL_MULF(2.6718244e-10f, 3.3087225e-24f + fine_diagonal0a_size_1),
      fine_diagonal0_size_9 = fine_diagonal0_bound_4
          + (fine_diagonal0_bound_3 + fabsf(fine_diagonal0b - fine_diagonal0a)),
      fine_diagonal0_size_2 = fine_diagonal0_error_1
          + KSL_MULF(2.6514102e-10f, 3.3087225e-24f + fine_m_size_1) + fine_diagonal0_bound_2,
      fine_diagonal0_size_11 = KSL_MULF(3.7583693e+09f, fine_diagonal0_size_2
          < fabsf(fine_m_0 - fine_others_0) ? 0.0f : fine_diagonal0_size_9);
  const float fine_diagonal1a = 1.0f - fine_others_1,
      fine_diagonal1a_right_1 = 1.0f - fine_diagonal1a,
      fine_diagonal1a_lo = 1.0f - (fine_diagonal1a + fine_diagonal1a_right_1)
          - (fine_others_1 - fine_diagonal1a_right_1) - fine_others_lo_2,
      fine_diagonal1a_size_1 = 1.0f + fine_others_size_2, fine_diagonal1b = fine_g1 + fine_m_1,
      fine_diagonal1b_right_1 = fine_diagonal1b - fine_g1,
      fine_diagonal1b_left_rest_1 = ksl_product_restf(c, sinc, fine_g1, fine_diagonal1b
          - fine_diagonal1b_right_1),
      fine_diagonal1b_lo1_1 = fine_diagonal1b_left_rest_1
          + ksl_product_restf(v->y, fine_beta_v_1, fine_m_1, fine_diagonal1b_right_1),
      fine_diagonal1b_lo = fine_diagonal1b_lo1_1 + (fine_g1_cross_1 + fine_m_cross2_2),
      fine_diagonal1b_size_1 = fine_g1_size_5 + fine_m_size_2,
      fine_diagonal1_error_1 = fabsf(ksl_product_errorf(v->y, fine_beta_v_1, fine_m_1)
          + fine_m_cross2_2),
      fine_diagonal1_bound_2 = fabsf(fine_others_lo_2)
          + KSL_MULF(2.6615107e-10f, 3.3087225e-24f + fine_others_size_2),
      fine_diagonal1_bound_3 = fabsf(fine_diagonal1b_lo)
          + KSL_MULF(2.6615107e-10f, 3.3087225e-24f + fine_diagonal1b_size_1),
      fine_diagonal1_bound_4 = fabsf(fine_diagonal1a_lo)
          + KSL_MULF(2.6718244e-10f, 3.3087225e-24f + fine_diagonal1a_size_1),
      fine_diagonal1_size_9 = fine_diagonal1_bound_4
          + (fine_diagonal1_bound_3 + fabsf(fine_diagonal1b - fine_diagonal1a)),
      fine_diagonal1_size_2 = fine_diagonal1_error_1
          + KSL_MULF(2.6514102e-10f, 3.3087225e-24f + fine_m_size_2) + fine_diagonal1_bound_2,
      fine_diagonal1_size_11 = KSL_MULF(3.7583693e+09f, fine_diagonal1_size_2
          < fabsf(fine_m_1 - fine_others_1) ? 0.0f : fine_diagonal1_size_9);
  const float fine_diagonal2a = 1.0f - fine_others_2,
      fine_diagonal2a_right_1 = 1.0f - fine_diagonal2a,
      fine_diagonal2a_lo = 1.0f - (fine_diagonal2a + fine_diagonal2a_right_1)
          - (fine_others_2 - fine_diagonal2a_right_1) - fine_others_lo_3,
      fine_diagonal2a_size_1 = 1.0f + fine_others_size_3, fine_diagonal2b = fine_g1 + fine_m_2,
      fine_diagonal2b_right_1 = fine_diagonal2b - fine_g1,
      fine_diagonal2b_left_rest_1 = ksl_product_restf(c, sinc, fine_g1, fine_diagonal2b
          - fine_diagonal2b_right_1),
      fine_diagonal2b_lo1_1 = fine_diagonal2b_left_rest_1
          + ksl_product_restf(v->z, fine_beta_v_2, fine_m_2, fine_diagonal2b_right_1),
      fine_diagonal2b_lo = fine_diagonal2b_lo1_1 + (fine_g1_cross_1 + fine_m_cross2_3),
      fine_diagonal2b_size_1 = fine_g1_size_5 + fine_m_size_3,
      fine_diagonal2_error_1 = fabsf(ksl_product_errorf(v->z, fine_beta_v_2, fine_m_2)
          + fine_m_cross2_3),
      fine_diagonal2_bound_2 = fabsf(fine_others_lo_3)
          + KSL_MULF(2.6615107e-10f, 3.3087225e-24f + fine_others_size_3),
      fine_diagonal2_bound_3 = fabsf(fine_diagonal2b_lo)
          + KSL_MULF(2.6615107e-10f, 3.3087225e-24f + fine_diagonal2b_size_1),
      fine_diagonal2_bound_4 = fabsf(fine_diagonal2a_lo)
          + KSL_MULF(2.6718244e-10f, 3.3087225e-24f + fine_diagonal2a_size_1),
      fine_diagonal2_size_9 = fine_diagonal2_bound_4
          + (fine_diagonal2_bound_3 + fabsf(fine_diagonal2b - fine_diagonal2a)),
      fine_diagonal2_size_2 = fine_diagonal2_error_1
          + KSL_MULF(2.6514102e-10f, 3.3087225e-24f + fine_m_size_3) + fine_diagonal2_bound_2,
      fine_diagonal2_size_11 = KSL_MULF(3.7583693e+09f, fine_diagonal2_size_2
          < fabsf(fine_m_2 - fine_others_2) ? 0.0f : fine_diagonal2_size_9);
  const float fine_alpha_v_0 = KSL_MULF(v->x, fine_g2),
      fine_alpha_v_cross2_1 = KSL_MULF(v->x, fine_g2_cross2_1),
      fine_alpha_v_padded_1 = 3.3087225e-24f + KSL_MULF(0.5f, fine_g2a_size_1 + fine_g2a_size_1);
  const float fine_alpha_v_1 = KSL_MULF(v->y, fine_g2),
      fine_alpha_v_cross2_2 = KSL_MULF(v->y, fine_g2_cross2_1);
  const float fine_alpha_v_2 = KSL_MULF(v->z, fine_g2),
      fine_alpha_v_cross2_3 = KSL_MULF(v->z, fine_g2_cross2_1);
  const float fine_R_01 = fine_m_3 - fine_alpha_v_2, fine_R_right_1 = fine_m_3 - fine_R_01,
      fine_R_left_rest_1 = ksl_product_restf(v->y, fine_beta_v_0, fine_m_3, fine_R_01
          + fine_R_right_1);
  const float fine_R_02 = fine_m_4 + fine_alpha_v_1, fine_R_right_2 = fine_R_02 - fine_m_4,
      fine_R_left_rest_2 = ksl_product_restf(v->z, fine_beta_v_0, fine_m_4, fine_R_02
          - fine_R_right_2);
  const float fine_R_10 = fine_m_3 + fine_alpha_v_2, fine_R_right_3 = fine_R_10 - fine_m_3,
      fine_R_left_rest_3 = ksl_product_restf(v->y, fine_beta_v_0, fine_m_3, fine_R_10
          - fine_R_right_3);
  const float fine_R_12 = fine_m_5 - fine_alpha_v_0, fine_R_right_4 = fine_m_5 - fine_R_12,
      fine_R_left_rest_4 = ksl_product_restf(v->z, fine_beta_v_1, fine_m_5, fine_R_12
          + fine_R_right_4);
  const float fine_R_20 = fine_m_4 - fine_alpha_v_1, fine_R_right_5 = fine_m_4 - fine_R_20,
      fine_R_left_rest_5 = ksl_product_restf(v->z, fine_beta_v_0, fine_m_4, fine_R_20
          + fine_R_right_5);
  const float fine_R_21 = fine_m_5 + fine_alpha_v_0, fine_R_right_6 = fine_R_21 - fine_m_5,
      fine_R_left_rest_6 = ksl_product_restf(v->z, fine_beta_v_1, fine_m_5, fine_R_21
          - fine_R_right_6);
  const float diagonal0_apart_1 = (fine_m_0 < fine_others_0 ? fine_diagonal0b : fine_diagonal0a)
          - diagonal0,
      diagonal0_padded_1 = 3.3087225e-24f
          + ((fine_m_0 < fine_others_0 ? fine_diagonal0b_size_1 : fine_diagonal0a_size_1)
          + fine_diagonal0_size_11),
      diagonal0_error_2 = KSL_MULF(1.0000005f, fabsf(diagonal0_apart_1
          + (fine_m_0 < fine_others_0 ? fine_diagonal0b_lo : fine_diagonal0a_lo)));
  const float fine_R_lo_1 = fine_R_left_rest_1
          - ksl_product_restf(v->z, fine_g2, fine_alpha_v_2, fine_R_right_1)
          + (fine_m_cross2_4 - fine_alpha_v_cross2_3);
  const float R_rest_1 = KSL_MULF(2.6615107e-10f, 3.3087225e-24f
          + (KSL_MULF(fine_alpha_v_padded_1, halved_size_5)
          + KSL_MULF(fine_m_padded_1, halved_size_3)));
  const float fine_R_lo_2 = fine_R_left_rest_2
          + ksl_product_restf(v->y, fine_g2, fine_alpha_v_1, fine_R_right_2)
          + (fine_m_cross2_5 + fine_alpha_v_cross2_2);
  const float R_rest_2 = KSL_MULF(2.6615107e-10f, 3.3087225e-24f
          + (KSL_MULF(fine_alpha_v_padded_1, halved_size_3)
          + KSL_MULF(fine_m_padded_1, halved_size_5)));
  const float fine_R_lo_3 = fine_R_left_rest_3
          + ksl_product_restf(v->z, fine_g2, fine_alpha_v_2, fine_R_right_3)
          + (fine_m_cross2_4 + fine_alpha_v_cross2_3);
  const float diagonal1_apart_1 = (fine_m_1 < fine_others_1 ? fine_diagonal1b : fine_diagonal1a)
          - diagonal1,
      diagonal1_padded_1 = 3.3087225e-24f
          + ((fine_m_1 < fine_others_1 ? fine_diagonal1b_size_1 : fine_diagonal1a_size_1)
          + fine_diagonal1_size_11),
      diagonal1_error_2 = KSL_MULF(1.0000005f, fabsf(diagonal1_apart_1
          + (fine_m_1 < fine_others_1 ? fine_diagonal1b_lo : fine_diagonal1a_lo)));
  const float fine_R_lo_4 = fine_R_left_rest_4
          - ksl_product_restf(v->x, fine_g2, fine_alpha_v_0, fine_R_right_4)
          + (fine_m_cross2_6 - fine_alpha_v_cross2_1);
  const float R_rest_3 = KSL_MULF(2.6615107e-10f, 3.3087225e-24f
          + (KSL_MULF(fine_alpha_v_padded_1, halved_size_1)
          + KSL_MULF(fine_m_padded_2, halved_size_5)));
  const float fine_R_lo_5 = fine_R_left_rest_5
          - ksl_product_restf(v->y, fine_g2, fine_alpha_v_1, fine_R_right_5)
          + (fine_m_cross2_5 - fine_alpha_v_cross2_2);
  const float fine_R_lo_6 = fine_R_left_rest_6
          + ksl_product_restf(v->x, fine_g2, fine_alpha_v_0, fine_R_right_6)
          + (fine_m_cross2_6 + fine_alpha_v_cross2_1);
  const float diagonal2_apart_1 = (fine_m_2 < fine_others_2 ? fine_diagonal2b : fine_diagonal2a)
          - diagonal2,
      diagonal2_padded_1 = 3.3087225e-24f
          + ((fine_m_2 < fine_others_2 ? fine_diagonal2b_size_1 : fine_diagonal2a_size_1)
          + fine_diagonal2_size_11),
      diagonal2_error_2 = KSL_MULF(1.0000005f, fabsf(diagonal2_apart_1
          + (fine_m_2 < fine_others_2 ? fine_diagonal2b_lo : fine_diagonal2a_lo))),
      diagonal0_bound_1 = diagonal0_error_2 + KSL_MULF(2.6718253e-10f, diagonal0_padded_1),
      R_bound_1 = KSL_MULF(1.0000005f, fabsf(fine_R_01 - R_01 + fine_R_lo_1)) + R_rest_1,
      R_bound_2 = KSL_MULF(1.0000005f, fabsf(fine_R_02 - R_02 + fine_R_lo_2)) + R_rest_2,
      R_bound_3 = KSL_MULF(1.0000005f, fabsf(fine_R_10 - R_10 + fine_R_lo_3)) + R_rest_1,
      diagonal1_bound_1 = diagonal1_error_2 + KSL_MULF(2.6718253e-10f, diagonal1_padded_1),
      R_bound_4 = KSL_MULF(1.0000005f, fabsf(fine_R_12 - R_12 + fine_R_lo_4)) + R_rest_3,
      R_bound_5 = KSL_MULF(1.0000005f, fabsf(fine_R_20 - R_20 + fine_R_lo_5)) + R_rest_2,
      R_bound_6 = KSL_MULF(1.0000005f, fabsf(fine_R_21 - R_21 + fine_R_lo_6)) + R_rest_3,
      diagonal2_bound_1 = diagonal2_error_2 + KSL_MULF(2.6718253e-10f, diagonal2_padded_1);
  R->m00 = diagonal0;
  R->m01 = R_01;
  R->m02 = R_02;
  R->m10 = R_10;
  R->m11 = diagonal1;
  R->m12 = R_12;
  R->m20 = R_20;
  R->m21 = R_21;
  R->m22 = diagonal2;
  R_bound->m00 = diagonal0_bound_1;
  R_bound->m01 = R_bound_1;
  R_bound->m02 = R_bound_2;
  R_bound->m10 = R_bound_3;
  R_bound->m11 = diagonal1_bound_1;
  R_bound->m12 = R_bound_4;
  R_bound->m20 = R_bound_5;
  R_bound->m21 = R_bound_6;
  R_bound->m22 = diagonal2_bound_1;
}

/* R = J_r(v) = I - (1 - cos θ)/θ^2 v~ + (θ - sin θ)/θ^3 v~^2, θ = |v|; |error of R| <= R_bound
     unless inf or NaN.
   v: vector; R, R_bound: rotation or other 3×3 matrix.
   403 mul, 706 add, 18 product error, 43 product rest, 16 div, 3 sqrt, 12 neg, 90 abs, 20 less,
     1 equal, 45 select. */
static inline void ksl_SO3_rightJacobianf_certified(const ksl_vec3f_t *v, ksl_mat3x3f_t *R,
    ksl_mat3x3f_t *R_bound) {
  const float size_0 = fabsf(v->x), size_1 = fabsf(v->y), size_2 = fabsf(v->z);
  const float sizes = size_0 + size_1 + size_2;
  const float grid = KSL_MULF(sizes, 8192.0f);
  const float shifted_0 = v->x + grid, shifted_1 = v->y + grid, shifted_2 = v->z + grid;
  const float high_0 = shifted_0 - grid, high_1 = shifted_1 - grid, high_2 = shifted_2 - grid;
  const float low_0 = v->x - high_0, low_1 = v->y - high_1, low_2 = v->z - high_2;
  const float sum_0 = v->x + high_0, sum_1 = v->y + high_1, sum_2 = v->z + high_2;
  const float squares = KSL_MULF(high_0, high_0) + KSL_MULF(high_1, high_1)
          + KSL_MULF(high_2, high_2);
  const float cross = KSL_MULF(low_0, sum_0) + KSL_MULF(low_1, sum_1) + KSL_MULF(low_2, sum_2);
  const float x = squares + cross;
  const float theta_a = sqrtf(x), theta = x < 1.0f ? 1.0f : theta_a;
  const float theta_shifted = grid + theta;
  const float theta_high = theta_shifted - grid;
  const float theta_low = theta - theta_high;
  const float theta_sum = theta + theta_high;
  const float cross_rest = cross - KSL_MULF(theta_low, theta_sum);
  const float exact = squares - KSL_MULF(theta_high, theta_high);
  const float residual = cross_rest + exact;
  const float small = KSL_MULF(0.5f, residual) / theta;
  const float delta = fabsf(small) < 0.0078125f ? small : 0.0f;
  float far_cosine_a; const float far_sine_a = ksl_sincosf(theta, &far_cosine_a);
  const float far_sine = x < 1.0f ? 1.0f : far_sine_a;
  const float far_cosine = x < 1.0f ? 0.0f : far_cosine_a;
  const float sine = KSL_MULF(delta, far_cosine) + far_sine;
  const float cosine = far_cosine - KSL_MULF(delta, far_sine);
  const float far_x = x < 1.0f ? 1.0f : x;
  const float middle_x = x < 4.0f ? 4.0f : x;
  const float closed1 = sine / theta;
  const float versine = 1.0f - cosine;
  const float closed2 = versine / far_x;
  const float rest3 = 1.0f - closed1;
  const float closed3 = rest3 / middle_x;
  const float g1h = KSL_MULF(x, KSL_MULF(x, KSL_MULF(x, KSL_MULF(6.4469503e-26f, x)
          - 3.8681703e-23f) + 1.9572942e-20f) - 8.220635e-18f) + 2.8114574e-15f,
      g1q = KSL_MULF(x, KSL_MULF(x, KSL_MULF(x, KSL_MULF(x, KSL_MULF(x, g1h) - 7.6471636e-13f)
          + 1.6059044e-10f) - 2.5052108e-08f) + 2.7557319e-06f),
      g1x = KSL_MULF(x, KSL_MULF(x, KSL_MULF(x, g1q - 0.0001984127f) + 0.008333334f) - 0.16666667f)
          + 1.0f, g1 = x < 1.0f ? g1x : closed1;
  const float g2h = KSL_MULF(x, KSL_MULF(x, KSL_MULF(x, KSL_MULF(2.4795963e-27f, x)
          - 1.6117376e-24f) + 8.896791e-22f) - 4.1103176e-19f) + 1.5619207e-16f,
      g2q = KSL_MULF(x, KSL_MULF(x, KSL_MULF(x, KSL_MULF(x, KSL_MULF(x, g2h) - 4.7794773e-14f)
          + 1.1470745e-11f) - 2.0876756e-09f) + 2.755732e-07f),
      g2x = KSL_MULF(x, KSL_MULF(x, KSL_MULF(x, g2q - 2.4801588e-05f) + 0.0013888889f)
          - 0.041666668f) + 0.5f, g2 = x < 1.0f ? g2x : closed2;
  const float g3i = KSL_MULF(x, KSL_MULF(x, KSL_MULF(x, KSL_MULF(x, KSL_MULF(9.18369e-29f, x)
          - 6.4469503e-26f) + 3.8681703e-23f) - 1.9572942e-20f) + 8.220635e-18f),
      g3r = KSL_MULF(x, KSL_MULF(x, KSL_MULF(x, KSL_MULF(x, g3i - 2.8114574e-15f) + 7.6471636e-13f)
          - 1.6059044e-10f) + 2.5052108e-08f) - 2.7557319e-06f,
      g3x = KSL_MULF(x, KSL_MULF(x, KSL_MULF(x, g3r) + 0.0001984127f) - 0.008333334f) + 0.16666667f,
      g3 = x < 4.0f ? g3x : closed3;
  const float beta_v_0 = KSL_MULF(v->x, g3);
  const float beta_v_1 = KSL_MULF(v->y, g3);
  const float beta_v_2 = KSL_MULF(v->z, g3);
  const float m_0 = KSL_MULF(v->x, beta_v_0);
  const float m_1 = KSL_MULF(v->y, beta_v_1);
  const float m_2 = KSL_MULF(v->z, beta_v_2);
  const float m_3 = KSL_MULF(v->y, beta_v_0);
  const float m_4 = KSL_MULF(v->z, beta_v_0);
  const float m_5 = KSL_MULF(v->z, beta_v_1);
  const float others_0 = m_1 + m_2;
  const float others_1 = m_0 + m_2;
  const float others_2 = m_0 + m_1;
  const float diagonal0a = 1.0f - others_0, diagonal0b = g1 + m_0,
      diagonal0 = m_0 < others_0 ? diagonal0b : diagonal0a;
  const float diagonal1a = 1.0f - others_1, diagonal1b = g1 + m_1,
      diagonal1 = m_1 < others_1 ? diagonal1b : diagonal1a;
  const float diagonal2a = 1.0f - others_2, diagonal2b = g1 + m_2,
      diagonal2 = m_2 < others_2 ? diagonal2b : diagonal2a;
  const float alpha_v_0 = -KSL_MULF(v->x, g2);
  const float alpha_v_1 = -KSL_MULF(v->y, g2);
  const float alpha_v_2 = -KSL_MULF(v->z, g2);
  const float R_01 = m_3 - alpha_v_2;
  const float R_02 = m_4 + alpha_v_1;
  const float R_10 = m_3 + alpha_v_2;
  const float R_12 = m_5 - alpha_v_0;
  const float R_20 = m_4 - alpha_v_1;
  const float R_21 = m_5 + alpha_v_0;
  const float halved_0 = KSL_MULF(0.5f, v->x), halved_size_1 = fabsf(v->x);
  const float halved_1 = KSL_MULF(0.5f, v->y), halved_size_3 = fabsf(v->y);
  const float halved_2 = KSL_MULF(0.5f, v->z), halved_size_5 = fabsf(v->z);
  const float y_a = KSL_MULF(halved_0, halved_0),
      y_a_padded_1 = 3.3087225e-24f + KSL_MULF(0.5f, halved_size_1),
      y_b = KSL_MULF(halved_1, halved_1),
      y_b_padded_1 = 3.3087225e-24f + KSL_MULF(0.5f, halved_size_3), y_c = y_a + y_b,
      y_c_right_1 = y_c - y_a, y_d = KSL_MULF(halved_2, halved_2),
      y_d_padded_1 = 3.3087225e-24f + KSL_MULF(0.5f, halved_size_5), y = y_c + y_d,
      y_right_1 = y - y_c,
      y_c_lo = ksl_product_restf(halved_0, halved_0, y_a, y_c - y_c_right_1)
          + ksl_product_restf(halved_1, halved_1, y_b, y_c_right_1),
      y_lo = y_c - (y - y_right_1) + ksl_product_restf(halved_2, halved_2, y_d, y_right_1) + y_c_lo,
      y_size_1 = KSL_MULF(y_a_padded_1, y_a_padded_1) + KSL_MULF(y_b_padded_1, y_b_padded_1)
          + KSL_MULF(y_d_padded_1, y_d_padded_1);
  const float half_angle = sqrtf(y), half_angle_product_1 = KSL_MULF(half_angle, half_angle),
      half_angle_twice_1 = half_angle + half_angle,
      half_angle_residual_1 = y - half_angle_product_1
          - ksl_product_errorf(half_angle, half_angle, half_angle_product_1) + y_lo,
      half_angle_lo = half_angle_residual_1 / (half_angle == 0.0f ? 1.0f : half_angle_twice_1),
      half_angle_padded_1 = 3.3087225e-24f + y_size_1,
      half_angle_bound_1 = fabsf(y_lo) + KSL_MULF(7.2120885e-13f, half_angle_padded_1),
      half_angle_size_4 = KSL_MULF(fabsf(y)
          + KSL_MULF(262144.0f, half_angle_bound_1), half_angle_padded_1 / half_angle / y),
      half_angle_size_6 = fabsf(half_angle_lo),
      half_angle_size_8 = KSL_MULF(8.907313e+11f, sqrtf(half_angle_bound_1) + half_angle_size_6),
      half_angle_size_12 = half_angle
          + (KSL_MULF(4.0f, half_angle_bound_1) < y ? half_angle_size_4 : half_angle_size_8);
  float c; const float fine_sine = ksl_sincosf(half_angle, &c);
  float c_own_error_1; const float fine_sine_own_error_1 = ksl_sincos_errorf(half_angle, fine_sine,
      c, &c_own_error_1);
  const float fine_sine_half_1 = KSL_MULF(half_angle_lo, 0.5f);
  float fine_sine_half_cos_1; const float fine_sine_half_sin_1 = ksl_sincosf(fine_sine_half_1,
      &fine_sine_half_cos_1);
  const float fine_sine_twice_1 = fine_sine_half_sin_1 + fine_sine_half_sin_1,
      fine_sine_padded_1 = 3.3087225e-24f + half_angle_size_12,
      fine_sine_size_1 = 1.0f + fine_sine_padded_1;
  const float c_lo = c_own_error_1
          - KSL_MULF(KSL_MULF(fine_sine_half_cos_1, fine_sine)
          + KSL_MULF(fine_sine_half_sin_1, c), fine_sine_twice_1);
  const float sinc_divisor = half_angle < 1.4901161e-08f ? 1.4901161e-08f : half_angle,
      sinc_divisor_lo = half_angle < 1.4901161e-08f ? 0.0f : half_angle_lo,
      sinc_divisor_bound_1 = half_angle_size_6 + KSL_MULF(1.2221551e-12f, fine_sine_padded_1),
      sinc_divisor_size_3 = fabsf(half_angle - 1.4901161e-08f),
      sinc_divisor_size_7 = sinc_divisor_bound_1 + fabsf(1.4901161e-08f - half_angle),
      sinc_divisor_size_9 = KSL_MULF(3.1414265e+11f, sinc_divisor_bound_1 < sinc_divisor_size_3
          ? 0.0f : sinc_divisor_size_7);
  const float sinc_quotient = fine_sine / sinc_divisor,
      sinc_quotient_product_1 = KSL_MULF(sinc_quotient, sinc_divisor);
  const float fine_sine_lo = fine_sine_own_error_1
          + KSL_MULF(KSL_MULF(fine_sine_half_cos_1, c)
          - KSL_MULF(fine_sine_half_sin_1, fine_sine), fine_sine_twice_1);
  const float sinc_quotient_exact_1 = fine_sine - sinc_quotient_product_1
          - ksl_product_errorf(sinc_quotient, sinc_divisor, sinc_quotient_product_1),
      sinc_quotient_lo = (sinc_quotient_exact_1 + fine_sine_lo
          - KSL_MULF(sinc_quotient, sinc_divisor_lo)) / sinc_divisor,
      sinc_quotient_padded_2 = 3.3087225e-24f
          + ((half_angle < 1.4901161e-08f ? 1.4901161e-08f : half_angle_size_12)
          + sinc_divisor_size_9), sinc_quotient_size_1 = fabsf(sinc_quotient),
      sinc_quotient_size_2 = fabsf(sinc_divisor),
      sinc_quotient_bound_1 = fabsf(sinc_divisor_lo)
          + KSL_MULF(3.2827582e-12f, sinc_quotient_padded_2),
      sinc_quotient_size_4 = 3.3087225e-24f + fine_sine_size_1
          + KSL_MULF(sinc_quotient_padded_2, sinc_quotient_size_1),
      sinc_quotient_size_8 = sinc_quotient_size_4
          / (KSL_MULF(4.0f, sinc_quotient_bound_1) < sinc_quotient_size_2 ? sinc_quotient_size_2
          : 0.0f),
      sinc_quotient_size_10 = KSL_MULF(sinc_quotient_size_2
          + KSL_MULF(262144.0f, sinc_quotient_bound_1), sinc_quotient_size_8)
          / sinc_quotient_size_2,
      sinc_quotient_size_11 = sinc_quotient_size_1 + sinc_quotient_size_10;
  const float sinc_a = KSL_MULF(0.16666667f, y), sinc_b = 1.0f - sinc_a,
      sinc_b_right_1 = 1.0f - sinc_b,
      sinc_b_lo1_1 = 1.0f - (sinc_b + sinc_b_right_1)
          - ksl_product_restf(0.16666667f, y, sinc_a, sinc_b_right_1),
      sinc_b_lo = sinc_b_lo1_1 - (KSL_MULF(-4.967054e-09f, y) + KSL_MULF(0.16666667f, y_lo)),
      sinc_b_size_1 = 1.0f + KSL_MULF(0.16666669f, y_size_1),
      sinc = half_angle < 1.4901161e-08f ? sinc_b : sinc_quotient,
      sinc_lo = half_angle < 1.4901161e-08f ? sinc_b_lo : sinc_quotient_lo,
      sinc_size_4 = fabsf(sinc_b_lo) + KSL_MULF(2.3406937e-10f, 3.3087225e-24f + sinc_b_size_1)
          + fabsf(sinc_b - sinc_quotient),
      sinc_size_5 = fabsf(sinc_quotient_lo)
          + KSL_MULF(5.43103e-12f, 3.3087225e-24f + sinc_quotient_size_11) + sinc_size_4,
      sinc_size_7 = KSL_MULF(4.276409e+09f, sinc_divisor_bound_1 < sinc_divisor_size_3 ? 0.0f
          : sinc_size_5);
  const float fine_g1 = KSL_MULF(c, sinc),
      fine_g1_cross_1 = KSL_MULF(c_lo, sinc) + KSL_MULF(c, sinc_lo),
      fine_g1_padded_1 = 3.3087225e-24f
          + ((half_angle < 1.4901161e-08f ? sinc_b_size_1 : sinc_quotient_size_11) + sinc_size_7),
      fine_g1_reach_2 = fabsf(sinc)
          + KSL_MULF(262144.0f, fabsf(sinc_lo) + KSL_MULF(2.3406946e-10f, fine_g1_padded_1)),
      fine_g1_size_2 = KSL_MULF(fine_g1_padded_1, fabsf(c)
          + KSL_MULF(262144.0f, fabsf(c_lo) + KSL_MULF(2.5011469e-12f, fine_sine_size_1))),
      fine_g1_size_5 = fine_g1_size_2 + KSL_MULF(fine_g1_reach_2, fine_sine_size_1);
  const float fine_g2a = KSL_MULF(sinc, sinc),
      fine_g2a_size_1 = KSL_MULF(fine_g1_padded_1, fine_g1_reach_2),
      fine_g2 = KSL_MULF(0.5f, fine_g2a),
      fine_g2_cross2_1 = KSL_MULF(0.5f, ksl_product_errorf(sinc, sinc, fine_g2a)
          + (KSL_MULF(sinc_lo, sinc) + KSL_MULF(sinc, sinc_lo)));
  const float fine_rest3 = 1.0f - fine_g1, fine_rest3_right_1 = 1.0f - fine_rest3;
  const float fine_x = KSL_MULF(4.0f, y), fine_x_cross2_1 = KSL_MULF(4.0f, y_lo),
      fine_x_size_1 = KSL_MULF(4.0f, y_size_1);
  const float fine_far_x = fine_x < 1.0f ? 1.0f : fine_x,
      fine_far_x_lo = fine_x < 1.0f ? 0.0f : fine_x_cross2_1,
      fine_far_x_padded_1 = 3.3087225e-24f + fine_x_size_1,
      fine_far_x_bound_1 = fabsf(fine_x_cross2_1) + KSL_MULF(8.100306e-13f, fine_far_x_padded_1),
      fine_far_x_size_3 = fabsf(fine_x - 1.0f),
      fine_far_x_size_7 = fine_far_x_bound_1 + fabsf(1.0f - fine_x),
      fine_far_x_size_9 = KSL_MULF(1.8324991e+11f, fine_far_x_bound_1 < fine_far_x_size_3 ? 0.0f
          : fine_far_x_size_7);
  const float fine_closed3 = fine_rest3 / fine_far_x,
      fine_closed3_product_1 = KSL_MULF(fine_closed3, fine_far_x);
  const float fine_rest3_lo = 1.0f - (fine_rest3 + fine_rest3_right_1)
          - ksl_product_restf(c, sinc, fine_g1, fine_rest3_right_1) - fine_g1_cross_1;
  const float fine_closed3_numerator_1 = fine_rest3 - fine_closed3_product_1
          - ksl_product_errorf(fine_closed3, fine_far_x, fine_closed3_product_1) + fine_rest3_lo,
      fine_closed3_lo = (fine_closed3_numerator_1 - KSL_MULF(fine_closed3, fine_far_x_lo))
          / fine_far_x,
      fine_closed3_padded_2 = 3.3087225e-24f
          + ((fine_x < 1.0f ? 1.0f : fine_x_size_1) + fine_far_x_size_9),
      fine_closed3_size_1 = fabsf(fine_closed3), fine_closed3_size_2 = fabsf(fine_far_x),
      fine_closed3_bound_1 = fabsf(fine_far_x_lo) + KSL_MULF(5.627585e-12f, fine_closed3_padded_2),
      fine_closed3_size_4 = 3.3087225e-24f + (1.0f + fine_g1_size_5)
          + KSL_MULF(fine_closed3_padded_2, fine_closed3_size_1),
      fine_closed3_size_8 = fine_closed3_size_4
          / (KSL_MULF(4.0f, fine_closed3_bound_1) < fine_closed3_size_2 ? fine_closed3_size_2
          : 0.0f),
      fine_closed3_size_10 = KSL_MULF(fine_closed3_size_2
          + KSL_MULF(262144.0f, fine_closed3_bound_1), fine_closed3_size_8) / fine_closed3_size_2,
      fine_closed3_size_11 = fine_closed3_size_1 + fine_closed3_size_10;
  const float series5a = KSL_MULF(1.216125e-34f, fine_x), series5b = 1.1309962e-31f - series5a,
      series5b_right_1 = 1.1309962e-31f - series5b,
      series5b_lo1_1 = 1.1309962e-31f - (series5b + series5b_right_1)
          - ksl_product_restf(1.216125e-34f, fine_x, series5a, series5b_right_1),
      series5b_lo = series5b_lo1_1
          - (KSL_MULF(2.696e-42f, fine_x) + KSL_MULF(1.216125e-34f, fine_x_cross2_1)) + 4.1374e-39f,
      series5c = KSL_MULF(fine_x, series5b),
      series5c_padded_1 = 3.3087225e-24f
          + (1.1309962e-31f + KSL_MULF(1.9784917e-27f, fine_x_size_1)),
      series5c_reach_1 = fabsf(fine_x) + KSL_MULF(262144.0f, fine_far_x_bound_1),
      series5c_reach_2 = fabsf(series5b)
          + KSL_MULF(262144.0f, fabsf(series5b_lo) + KSL_MULF(2.3419375e-10f, series5c_padded_1)),
      series5d = series5c - 9.18369e-29f, series5d_right_1 = series5c - series5d,
      series5d_lo2_1 = ksl_product_restf(fine_x, series5b, series5c, series5d + series5d_right_1)
          - (9.18369e-29f - series5d_right_1) - 5.383817e-37f,
      series5d_lo = series5d_lo2_1
          + (KSL_MULF(fine_x_cross2_1, series5b) + KSL_MULF(fine_x, series5b_lo)),
      series5e = KSL_MULF(fine_x, series5d),
      series5d_size_1 = 9.18369e-29f
          + (KSL_MULF(series5c_padded_1, series5c_reach_1)
          + KSL_MULF(fine_far_x_padded_1, series5c_reach_2)),
      series5e_padded_1 = 3.3087225e-24f + series5d_size_1,
      series5e_reach_1 = fabsf(series5d)
          + KSL_MULF(262144.0f, fabsf(series5d_lo) + KSL_MULF(2.3612653e-10f, series5e_padded_1)),
      series5f = series5e + 6.4469503e-26f, series5f_right_1 = series5f - series5e,
      series5f_lo2_1 = ksl_product_restf(fine_x, series5d, series5e, series5f - series5f_right_1)
          + (6.4469503e-26f - series5f_right_1) + -5.609469e-34f,
      series5f_lo = series5f_lo2_1
          + (KSL_MULF(fine_x_cross2_1, series5d) + KSL_MULF(fine_x, series5d_lo)),
      series5g = KSL_MULF(fine_x, series5f),
      series5f_size_1 = 6.4469503e-26f
          + (KSL_MULF(series5c_reach_1, series5e_padded_1)
          + KSL_MULF(fine_far_x_padded_1, series5e_reach_1)),
      series5g_padded_1 = 3.3087225e-24f + series5f_size_1,
      series5g_reach_1 = fabsf(series5f)
          + KSL_MULF(262144.0f, fabsf(series5f_lo) + KSL_MULF(2.381233e-10f, series5g_padded_1)),
      series5h = series5g - 3.8681703e-23f, series5h_right_1 = series5g - series5h,
      series5h_lo2_1 = ksl_product_restf(fine_x, series5f, series5g, series5h + series5h_right_1)
          - (3.8681703e-23f - series5h_right_1) - -1.2733404e-30f,
      series5h_lo = series5h_lo2_1
          + (KSL_MULF(fine_x_cross2_1, series5f) + KSL_MULF(fine_x, series5f_lo)),
      series5i = KSL_MULF(fine_x, series5h),
      series5h_size_1 = 3.8681703e-23f
          + (KSL_MULF(series5c_reach_1, series5g_padded_1)
          + KSL_MULF(fine_far_x_padded_1, series5g_reach_1)),
      series5i_padded_1 = 3.3087225e-24f + series5h_size_1,
      series5i_reach_1 = fabsf(series5h)
          + KSL_MULF(262144.0f, fabsf(series5h_lo) + KSL_MULF(2.4018407e-10f, series5i_padded_1)),
      series5j = series5i + 1.9572942e-20f, series5j_right_1 = series5j - series5i,
      series5j_lo2_1 = ksl_product_restf(fine_x, series5h, series5i, series5j - series5j_right_1)
          + (1.9572942e-20f - series5j_right_1) + -4.6129455e-28f,
      series5j_lo = series5j_lo2_1
          + (KSL_MULF(fine_x_cross2_1, series5h) + KSL_MULF(fine_x, series5h_lo)),
      series5k = KSL_MULF(fine_x, series5j),
      series5j_size_1 = 1.9572942e-20f
          + (KSL_MULF(series5c_reach_1, series5i_padded_1)
          + KSL_MULF(fine_far_x_padded_1, series5i_reach_1)),
      series5k_padded_1 = 3.3087225e-24f + series5j_size_1,
      series5k_reach_1 = fabsf(series5j)
          + KSL_MULF(262144.0f, fabsf(series5j_lo) + KSL_MULF(2.423088e-10f, series5k_padded_1)),
      series5l = series5k - 8.220635e-18f, series5l_right_1 = series5k - series5l,
      series5l_lo2_1 = ksl_product_restf(fine_x, series5j, series5k, series5l + series5l_right_1)
          - (8.220635e-18f - series5l_right_1) - 1.6814781e-25f,
      series5l_lo = series5l_lo2_1
          + (KSL_MULF(fine_x_cross2_1, series5j) + KSL_MULF(fine_x, series5j_lo)),
      series5m = KSL_MULF(fine_x, series5l),
      series5l_size_1 = 8.220635e-18f
          + (KSL_MULF(series5c_reach_1, series5k_padded_1)
          + KSL_MULF(fine_far_x_padded_1, series5k_reach_1)),
      series5m_padded_1 = 3.3087225e-24f + series5l_size_1,
      series5m_reach_1 = fabsf(series5l)
          + KSL_MULF(262144.0f, fabsf(series5l_lo) + KSL_MULF(2.4449753e-10f, series5m_padded_1)),
      series5n = series5m + 2.8114574e-15f, series5n_right_1 = series5n - series5m,
      series5n_lo2_1 = ksl_product_restf(fine_x, series5l, series5m, series5n - series5n_right_1)
          + (2.8114574e-15f - series5n_right_1) + -1.0462085e-22f,
      series5n_lo = series5n_lo2_1
          + (KSL_MULF(fine_x_cross2_1, series5l) + KSL_MULF(fine_x, series5l_lo)),
      series5o = KSL_MULF(fine_x, series5n),
      series5n_size_1 = 2.8114574e-15f
          + (KSL_MULF(series5c_reach_1, series5m_padded_1)
          + KSL_MULF(fine_far_x_padded_1, series5m_reach_1)),
      series5o_padded_1 = 3.3087225e-24f + series5n_size_1,
      series5o_reach_1 = fabsf(series5n)
          + KSL_MULF(262144.0f, fabsf(series5n_lo) + KSL_MULF(2.4675023e-10f, series5o_padded_1)),
      series5p = series5o - 7.6471636e-13f, series5p_right_1 = series5o - series5p,
      series5p_lo2_1 = ksl_product_restf(fine_x, series5n, series5o, series5p + series5p_right_1)
          - (7.6471636e-13f - series5p_right_1) - 1.22007105e-20f,
      series5p_lo = series5p_lo2_1
          + (KSL_MULF(fine_x_cross2_1, series5n) + KSL_MULF(fine_x, series5n_lo)),
      series5q = KSL_MULF(fine_x, series5p),
      series5p_size_1 = 7.6471636e-13f
          + (KSL_MULF(series5c_reach_1, series5o_padded_1)
          + KSL_MULF(fine_far_x_padded_1, series5o_reach_1)),
      series5q_padded_1 = 3.3087225e-24f + series5p_size_1,
      series5q_reach_1 = fabsf(series5p)
          + KSL_MULF(262144.0f, fabsf(series5p_lo) + KSL_MULF(2.4906693e-10f, series5q_padded_1)),
      series5r = series5q + 1.6059044e-10f, series5r_right_1 = series5r - series5q,
      series5r_lo2_1 = ksl_product_restf(fine_x, series5p, series5q, series5r - series5r_right_1)
          + (1.6059044e-10f - series5r_right_1) + -5.3525265e-18f,
      series5r_lo = series5r_lo2_1
          + (KSL_MULF(fine_x_cross2_1, series5p) + KSL_MULF(fine_x, series5p_lo)),
      series5s = KSL_MULF(fine_x, series5r),
      series5r_size_1 = 1.6059044e-10f
          + (KSL_MULF(series5c_reach_1, series5q_padded_1)
          + KSL_MULF(fine_far_x_padded_1, series5q_reach_1)),
      series5s_padded_1 = 3.3087225e-24f + series5r_size_1,
      series5s_reach_1 = fabsf(series5r)
          + KSL_MULF(262144.0f, fabsf(series5r_lo) + KSL_MULF(2.514476e-10f, series5s_padded_1)),
      series5t = series5s - 2.5052108e-08f, series5t_right_1 = series5s - series5t,
      series5t_lo2_1 = ksl_product_restf(fine_x, series5r, series5s, series5t + series5t_right_1)
          - (2.5052108e-08f - series5t_right_1) - 4.417623e-16f,
      series5t_lo = series5t_lo2_1
          + (KSL_MULF(fine_x_cross2_1, series5r) + KSL_MULF(fine_x, series5r_lo)),
      series5u = KSL_MULF(fine_x, series5t),
      series5t_size_1 = 2.5052108e-08f
          + (KSL_MULF(series5c_reach_1, series5s_padded_1)
          + KSL_MULF(fine_far_x_padded_1, series5s_reach_1)),
      series5u_padded_1 = 3.3087225e-24f + series5t_size_1,
      series5u_reach_1 = fabsf(series5t)
          + KSL_MULF(262144.0f, fabsf(series5t_lo) + KSL_MULF(2.538923e-10f, series5u_padded_1)),
      series5v = series5u + 2.7557319e-06f, series5v_right_1 = series5v - series5u,
      series5v_lo2_1 = ksl_product_restf(fine_x, series5t, series5u, series5v - series5v_right_1)
          + (2.7557319e-06f - series5v_right_1) + 3.7935712e-14f,
      series5v_lo = series5v_lo2_1
          + (KSL_MULF(fine_x_cross2_1, series5t) + KSL_MULF(fine_x, series5t_lo)),
      series5w = KSL_MULF(fine_x, series5v),
      series5v_size_1 = 2.7557319e-06f
          + (KSL_MULF(series5c_reach_1, series5u_padded_1)
          + KSL_MULF(fine_far_x_padded_1, series5u_reach_1)),
      series5w_padded_1 = 3.3087225e-24f + series5v_size_1,
      series5w_reach_1 = fabsf(series5v)
          + KSL_MULF(262144.0f, fabsf(series5v_lo) + KSL_MULF(2.5640096e-10f, series5w_padded_1)),
      series5x = series5w - 0.0001984127f, series5x_right_1 = series5w - series5x,
      series5x_lo2_1 = ksl_product_restf(fine_x, series5v, series5w, series5x + series5x_right_1)
          - (0.0001984127f - series5x_right_1) - -2.7255969e-12f,
      series5x_lo = series5x_lo2_1
          + (KSL_MULF(fine_x_cross2_1, series5v) + KSL_MULF(fine_x, series5v_lo)),
      series5y = KSL_MULF(fine_x, series5x),
      series5x_size_1 = 0.0001984127f
          + (KSL_MULF(series5c_reach_1, series5w_padded_1)
          + KSL_MULF(fine_far_x_padded_1, series5w_reach_1)),
      series5y_padded_1 = 3.3087225e-24f + series5x_size_1,
      series5y_reach_1 = fabsf(series5x)
          + KSL_MULF(262144.0f, fabsf(series5x_lo) + KSL_MULF(2.5897362e-10f, series5y_padded_1)),
      series5 = series5y + 0.008333334f, series5_right_1 = series5 - series5y,
      series5_lo2_1 = ksl_product_restf(fine_x, series5x, series5y, series5 - series5_right_1)
          + (0.008333334f - series5_right_1) + -4.346172e-10f,
      series5_lo = series5_lo2_1
          + (KSL_MULF(fine_x_cross2_1, series5x) + KSL_MULF(fine_x, series5x_lo));
  const float fine_g3a = KSL_MULF(fine_x, series5);
  const float series5_size_1 = 0.008333334f
          + (KSL_MULF(series5c_reach_1, series5y_padded_1)
          + KSL_MULF(fine_far_x_padded_1, series5y_reach_1));
  const float fine_g3a_padded_1 = 3.3087225e-24f + series5_size_1,
      fine_g3a_size_3 = KSL_MULF(fine_far_x_padded_1, fabsf(series5)
          + KSL_MULF(262144.0f, fabsf(series5_lo) + KSL_MULF(2.6161032e-10f, fine_g3a_padded_1))),
      fine_g3b = 0.16666667f - fine_g3a, fine_g3b_right_1 = 0.16666667f - fine_g3b,
      fine_g3b_lo1_1 = 0.16666667f - (fine_g3b + fine_g3b_right_1)
          - ksl_product_restf(fine_x, series5, fine_g3a, fine_g3b_right_1),
      fine_g3b_lo = fine_g3b_lo1_1
          - (KSL_MULF(fine_x_cross2_1, series5) + KSL_MULF(fine_x, series5_lo)) + -4.967054e-09f,
      fine_g3b_size_1 = 0.16666667f
          + (KSL_MULF(fine_g3a_padded_1, series5c_reach_1) + fine_g3a_size_3),
      fine_g3 = fine_x < 1.0f ? fine_g3b : fine_closed3,
      fine_g3_lo = fine_x < 1.0f ? fine_g3b_lo : fine_closed3_lo,
      fine_g3_size_4 = fabsf(fine_g3b_lo)
          + KSL_MULF(2.6431096e-10f, 3.3087225e-24f + fine_g3b_size_1)
          + fabsf(fine_g3b - fine_closed3),
      fine_g3_size_5 = fabsf(fine_closed3_lo)
          + KSL_MULF(2.3937835e-10f, 3.3087225e-24f + fine_closed3_size_11) + fine_g3_size_4,
      fine_g3_size_7 = KSL_MULF(3.7977316e+09f, fine_far_x_bound_1 < fine_far_x_size_3 ? 0.0f
          : fine_g3_size_5);
  const float fine_beta_v_0 = KSL_MULF(v->x, fine_g3),
      fine_beta_v_padded_1 = 3.3087225e-24f
          + ((fine_x < 1.0f ? fine_g3b_size_1 : fine_closed3_size_11) + fine_g3_size_7);
  const float fine_beta_v_1 = KSL_MULF(v->y, fine_g3);
  const float fine_beta_v_2 = KSL_MULF(v->z, fine_g3);
  const float fine_beta_v_lo_1 = ksl_product_errorf(v->x, fine_g3, fine_beta_v_0)
          + KSL_MULF(v->x, fine_g3_lo), fine_m_0 = KSL_MULF(v->x, fine_beta_v_0),
      fine_m_cross2_1 = KSL_MULF(v->x, fine_beta_v_lo_1),
      fine_m_padded_1 = 3.3087225e-24f + KSL_MULF(fine_beta_v_padded_1, halved_size_1),
      fine_m_size_1 = KSL_MULF(fine_m_padded_1, halved_size_1);
  const float fine_beta_v_lo_2 = ksl_product_errorf(v->y, fine_g3, fine_beta_v_1)
          + KSL_MULF(v->y, fine_g3_lo), fine_m_1 = KSL_MULF(v->y, fine_beta_v_1),
      fine_m_cross2_2 = KSL_MULF(v->y, fine_beta_v_lo_2),
      fine_m_padded_2 = 3.3087225e-24f + KSL_MULF(fine_beta_v_padded_1, halved_size_3),
      fine_m_size_2 = KSL_MULF(fine_m_padded_2, halved_size_3);
  const float fine_m_2 = KSL_MULF(v->z, fine_beta_v_2),
      fine_m_cross2_3 = KSL_MULF(v->z, ksl_product_errorf(v->z, fine_g3, fine_beta_v_2)
          + KSL_MULF(v->z, fine_g3_lo)),
      fine_m_size_3 = KSL_MULF(3.3087225e-24f
          + KSL_MULF(fine_beta_v_padded_1, halved_size_5), halved_size_5);
  const float fine_m_3 = KSL_MULF(v->y, fine_beta_v_0),
      fine_m_cross2_4 = KSL_MULF(v->y, fine_beta_v_lo_1);
  const float fine_m_4 = KSL_MULF(v->z, fine_beta_v_0),
      fine_m_cross2_5 = KSL_MULF(v->z, fine_beta_v_lo_1);
  const float fine_m_5 = KSL_MULF(v->z, fine_beta_v_1),
      fine_m_cross2_6 = KSL_MULF(v->z, fine_beta_v_lo_2);
  const float fine_others_0 = fine_m_1 + fine_m_2, fine_others_right_1 = fine_others_0 - fine_m_1,
      fine_others_left_rest_1 = ksl_product_restf(v->y, fine_beta_v_1, fine_m_1, fine_others_0
          - fine_others_right_1),
      fine_others_lo1_1 = fine_others_left_rest_1
          + ksl_product_restf(v->z, fine_beta_v_2, fine_m_2, fine_others_right_1),
      fine_others_lo_1 = fine_others_lo1_1 + (fine_m_cross2_2 + fine_m_cross2_3),
      fine_others_size_1 = fine_m_size_2 + fine_m_size_3;
  const float fine_others_1 = fine_m_0 + fine_m_2, fine_others_right_2 = fine_others_1 - fine_m_0,
      fine_others_left_rest_2 = ksl_product_restf(v->x, fine_beta_v_0, fine_m_0, fine_others_1
          - fine_others_right_2),
      fine_others_lo1_2 = fine_others_left_rest_2
          + ksl_product_restf(v->z, fine_beta_v_2, fine_m_2, fine_others_right_2),
      fine_others_lo_2 = fine_others_lo1_2 + (fine_m_cross2_1 + fine_m_cross2_3),
      fine_others_size_2 = fine_m_size_1 + fine_m_size_3;
  const float fine_others_2 = fine_m_0 + fine_m_1, fine_others_right_3 = fine_others_2 - fine_m_0,
      fine_others_left_rest_3 = ksl_product_restf(v->x, fine_beta_v_0, fine_m_0, fine_others_2
          - fine_others_right_3),
      fine_others_lo1_3 = fine_others_left_rest_3
          + ksl_product_restf(v->y, fine_beta_v_1, fine_m_1, fine_others_right_3),
      fine_others_lo_3 = fine_others_lo1_3 + (fine_m_cross2_1 + fine_m_cross2_2),
      fine_others_size_3 = fine_m_size_1 + fine_m_size_2;
  const float fine_diagonal0a = 1.0f - fine_others_0,
      fine_diagonal0a_right_1 = 1.0f - fine_diagonal0a,
      fine_diagonal0a_lo = 1.0f - (fine_diagonal0a + fine_diagonal0a_right_1)
          - (fine_others_0 - fine_diagonal0a_right_1) - fine_others_lo_1,
      fine_diagonal0a_size_1 = 1.0f + fine_others_size_1, fine_diagonal0b = fine_g1 + fine_m_0,
      fine_diagonal0b_right_1 = fine_diagonal0b - fine_g1,
      fine_diagonal0b_left_rest_1 = ksl_product_restf(c, sinc, fine_g1, fine_diagonal0b
          - fine_diagonal0b_right_1),
      fine_diagonal0b_lo1_1 = fine_diagonal0b_left_rest_1
          + ksl_product_restf(v->x, fine_beta_v_0, fine_m_0, fine_diagonal0b_right_1),
      fine_diagonal0b_lo = fine_diagonal0b_lo1_1 + (fine_g1_cross_1 + fine_m_cross2_1),
      fine_diagonal0b_size_1 = fine_g1_size_5 + fine_m_size_1,
      fine_diagonal0_error_1 = fabsf(ksl_product_errorf(v->x, fine_beta_v_0, fine_m_0)
          + fine_m_cross2_1),
      fine_diagonal0_bound_2 = fabsf(fine_others_lo_1)
          + KSL_MULF(2.6615107e-10f, 3.3087225e-24f + fine_others_size_1),
      fine_diagonal0_bound_3 = fabsf(fine_diagonal0b_lo)
          + KSL_MULF(2.6615107e-10f, 3.3087225e-24f + fine_diagonal0b_size_1),
      fine_diagonal0_bound_4 = fabsf(fine_diagonal0a_lo)
          + KSL_MULF(2.6718244e-10f, 3.3087225e-24f + fine_diagonal0a_size_1),
      fine_diagonal0_size_9 = fine_diagonal0_bound_4
          + (fine_diagonal0_bound_3 + fabsf(fine_diagonal0b - fine_diagonal0a)),
      fine_diagonal0_size_2 = fine_diagonal0_error_1
          + KSL_MULF(2.6514102e-10f, 3.3087225e-24f + fine_m_size_1) + fine_diagonal0_bound_2,
      fine_diagonal0_size_11 = KSL_MULF(3.7583693e+09f, fine_diagonal0_size_2
          < fabsf(fine_m_0 - fine_others_0) ? 0.0f : fine_diagonal0_size_9);
  const float fine_diagonal1a = 1.0f - fine_others_1,
      fine_diagonal1a_right_1 = 1.0f - fine_diagonal1a,
      fine_diagonal1a_lo = 1.0f - (fine_diagonal1a + fine_diagonal1a_right_1)
          - (fine_others_1 - fine_diagonal1a_right_1) - fine_others_lo_2,
      fine_diagonal1a_size_1 = 1.0f + fine_others_size_2, fine_diagonal1b = fine_g1 + fine_m_1,
      fine_diagonal1b_right_1 = fine_diagonal1b - fine_g1,
      fine_diagonal1b_left_rest_1 = ksl_product_restf(c, sinc, fine_g1, fine_diagonal1b
          - fine_diagonal1b_right_1),
      fine_diagonal1b_lo1_1 = fine_diagonal1b_left_rest_1
          + ksl_product_restf(v->y, fine_beta_v_1, fine_m_1, fine_diagonal1b_right_1),
      fine_diagonal1b_lo = fine_diagonal1b_lo1_1 + (fine_g1_cross_1 + fine_m_cross2_2),
      fine_diagonal1b_size_1 = fine_g1_size_5 + fine_m_size_2,
      fine_diagonal1_error_1 = fabsf(ksl_product_errorf(v->y, fine_beta_v_1, fine_m_1)
          + fine_m_cross2_2),
      fine_diagonal1_bound_2 = fabsf(fine_others_lo_2)
          + KSL_MULF(2.6615107e-10f, 3.3087225e-24f + fine_others_size_2),
      fine_diagonal1_bound_3 = fabsf(fine_diagonal1b_lo)
          + KSL_MULF(2.6615107e-10f, 3.3087225e-24f + fine_diagonal1b_size_1),
      fine_diagonal1_bound_4 = fabsf(fine_diagonal1a_lo)
          + KSL_MULF(2.6718244e-10f, 3.3087225e-24f + fine_diagonal1a_size_1),
      fine_diagonal1_size_9 = fine_diagonal1_bound_4
          + (fine_diagonal1_bound_3 + fabsf(fine_diagonal1b - fine_diagonal1a)),
      fine_diagonal1_size_2 = fine_diagonal1_error_1
          + KSL_MULF(2.6514102e-10f, 3.3087225e-24f + fine_m_size_2) + fine_diagonal1_bound_2,
      fine_diagonal1_size_11 = KSL_MULF(3.7583693e+09f, fine_diagonal1_size_2
          < fabsf(fine_m_1 - fine_others_1) ? 0.0f : fine_diagonal1_size_9);
  const float fine_diagonal2a = 1.0f - fine_others_2,
      fine_diagonal2a_right_1 = 1.0f - fine_diagonal2a,
      fine_diagonal2a_lo = 1.0f - (fine_diagonal2a + fine_diagonal2a_right_1)
          - (fine_others_2 - fine_diagonal2a_right_1) - fine_others_lo_3,
      fine_diagonal2a_size_1 = 1.0f + fine_others_size_3, fine_diagonal2b = fine_g1 + fine_m_2,
      fine_diagonal2b_right_1 = fine_diagonal2b - fine_g1,
      fine_diagonal2b_left_rest_1 = ksl_product_restf(c, sinc, fine_g1, fine_diagonal2b
          - fine_diagonal2b_right_1),
      fine_diagonal2b_lo1_1 = fine_diagonal2b_left_rest_1
          + ksl_product_restf(v->z, fine_beta_v_2, fine_m_2, fine_diagonal2b_right_1),
      fine_diagonal2b_lo = fine_diagonal2b_lo1_1 + (fine_g1_cross_1 + fine_m_cross2_3),
      fine_diagonal2b_size_1 = fine_g1_size_5 + fine_m_size_3,
      fine_diagonal2_error_1 = fabsf(ksl_product_errorf(v->z, fine_beta_v_2, fine_m_2)
          + fine_m_cross2_3),
      fine_diagonal2_bound_2 = fabsf(fine_others_lo_3)
          + KSL_MULF(2.6615107e-10f, 3.3087225e-24f + fine_others_size_3),
      fine_diagonal2_bound_3 = fabsf(fine_diagonal2b_lo)
          + KSL_MULF(2.6615107e-10f, 3.3087225e-24f + fine_diagonal2b_size_1),
      fine_diagonal2_bound_4 = fabsf(fine_diagonal2a_lo)
          + KSL_MULF(2.6718244e-10f, 3.3087225e-24f + fine_diagonal2a_size_1),
      fine_diagonal2_size_9 = fine_diagonal2_bound_4
          + (fine_diagonal2_bound_3 + fabsf(fine_diagonal2b - fine_diagonal2a)),
      fine_diagonal2_size_2 = fine_diagonal2_error_1
          + KSL_MULF(2.6514102e-10f, 3.3087225e-24f + fine_m_size_3) + fine_diagonal2_bound_2,
      fine_diagonal2_size_11 = KSL_MULF(3.7583693e+09f, fine_diagonal2_size_2
          < fabsf(fine_m_2 - fine_others_2) ? 0.0f : fine_diagonal2_size_9);
  const float fine_alpha_v_0a_padded_1 = 3.3087225e-24f
          + KSL_MULF(0.5f, fine_g2a_size_1 + fine_g2a_size_1),
      fine_alpha_v_0 = -KSL_MULF(v->x, fine_g2),
      fine_alpha_v_cross_1 = -KSL_MULF(v->x, fine_g2_cross2_1), fine_alpha_v_factor_1 = -v->x;
  const float fine_alpha_v_1 = -KSL_MULF(v->y, fine_g2),
      fine_alpha_v_cross_2 = -KSL_MULF(v->y, fine_g2_cross2_1), fine_alpha_v_factor_2 = -v->y;
  const float fine_alpha_v_2 = -KSL_MULF(v->z, fine_g2),
      fine_alpha_v_cross_3 = -KSL_MULF(v->z, fine_g2_cross2_1), fine_alpha_v_factor_3 = -v->z;
  const float fine_R_01 = fine_m_3 - fine_alpha_v_2, fine_R_right_1 = fine_m_3 - fine_R_01,
      fine_R_right_rest_1 = ksl_product_restf(fine_alpha_v_factor_3, fine_g2, fine_alpha_v_2,
          fine_R_right_1),
      fine_R_lo1_1 = ksl_product_restf(v->y, fine_beta_v_0, fine_m_3, fine_R_01 + fine_R_right_1)
          - fine_R_right_rest_1;
  const float fine_R_02 = fine_m_4 + fine_alpha_v_1, fine_R_right_2 = fine_R_02 - fine_m_4,
      fine_R_right_rest_2 = ksl_product_restf(fine_alpha_v_factor_2, fine_g2, fine_alpha_v_1,
          fine_R_right_2),
      fine_R_lo1_2 = ksl_product_restf(v->z, fine_beta_v_0, fine_m_4, fine_R_02 - fine_R_right_2)
          + fine_R_right_rest_2;
  const float fine_R_10 = fine_m_3 + fine_alpha_v_2, fine_R_right_3 = fine_R_10 - fine_m_3,
      fine_R_right_rest_3 = ksl_product_restf(fine_alpha_v_factor_3, fine_g2, fine_alpha_v_2,
          fine_R_right_3),
      fine_R_lo1_3 = ksl_product_restf(v->y, fine_beta_v_0, fine_m_3, fine_R_10 - fine_R_right_3)
          + fine_R_right_rest_3;
  const float fine_R_12 = fine_m_5 - fine_alpha_v_0, fine_R_right_4 = fine_m_5 - fine_R_12,
      fine_R_right_rest_4 = ksl_product_restf(fine_alpha_v_factor_1, fine_g2, fine_alpha_v_0,
          fine_R_right_4),
      fine_R_lo1_4 = ksl_product_restf(v->z, fine_beta_v_1, fine_m_5, fine_R_12 + fine_R_right_4)
          - fine_R_right_rest_4;
  const float fine_R_20 = fine_m_4 - fine_alpha_v_1, fine_R_right_5 = fine_m_4 - fine_R_20,
      fine_R_right_rest_5 = ksl_product_restf(fine_alpha_v_factor_2, fine_g2, fine_alpha_v_1,
          fine_R_right_5),
      fine_R_lo1_5 = ksl_product_restf(v->z, fine_beta_v_0, fine_m_4, fine_R_20 + fine_R_right_5)
          - fine_R_right_rest_5;
  const float fine_R_21 = fine_m_5 + fine_alpha_v_0, fine_R_right_6 = fine_R_21 - fine_m_5,
      fine_R_right_rest_6 = ksl_product_restf(fine_alpha_v_factor_1, fine_g2, fine_alpha_v_0,
          fine_R_right_6),
      fine_R_lo1_6 = ksl_product_restf(v->z, fine_beta_v_1, fine_m_5, fine_R_21 - fine_R_right_6)
          + fine_R_right_rest_6;
  const float diagonal0_apart_1 = (fine_m_0 < fine_others_0 ? fine_diagonal0b : fine_diagonal0a)
          - diagonal0,
      diagonal0_padded_1 = 3.3087225e-24f
          + ((fine_m_0 < fine_others_0 ? fine_diagonal0b_size_1 : fine_diagonal0a_size_1)
          + fine_diagonal0_size_11),
      diagonal0_error_2 = KSL_MULF(1.0000005f, fabsf(diagonal0_apart_1
          + (fine_m_0 < fine_others_0 ? fine_diagonal0b_lo : fine_diagonal0a_lo))),
      R_rest_1 = KSL_MULF(2.6615107e-10f, 3.3087225e-24f
          + (KSL_MULF(fine_alpha_v_0a_padded_1, halved_size_5)
          + KSL_MULF(fine_m_padded_1, halved_size_3))),
      R_rest_2 = KSL_MULF(2.6615107e-10f, 3.3087225e-24f
          + (KSL_MULF(fine_alpha_v_0a_padded_1, halved_size_3)
          + KSL_MULF(fine_m_padded_1, halved_size_5))),
      diagonal1_apart_1 = (fine_m_1 < fine_others_1 ? fine_diagonal1b : fine_diagonal1a)
          - diagonal1,
      diagonal1_padded_1 = 3.3087225e-24f
          + ((fine_m_1 < fine_others_1 ? fine_diagonal1b_size_1 : fine_diagonal1a_size_1)
          + fine_diagonal1_size_11),
      diagonal1_error_2 = KSL_MULF(1.0000005f, fabsf(diagonal1_apart_1
          + (fine_m_1 < fine_others_1 ? fine_diagonal1b_lo : fine_diagonal1a_lo))),
      R_rest_3 = KSL_MULF(2.6615107e-10f, 3.3087225e-24f
          + (KSL_MULF(fine_alpha_v_0a_padded_1, halved_size_1)
          + KSL_MULF(fine_m_padded_2, halved_size_5))),
      diagonal2_apart_1 = (fine_m_2 < fine_others_2 ? fine_diagonal2b : fine_diagonal2a)
          - diagonal2,
      diagonal2_padded_1 = 3.3087225e-24f
          + ((fine_m_2 < fine_others_2 ? fine_diagonal2b_size_1 : fine_diagonal2a_size_1)
          + fine_diagonal2_size_11),
      diagonal2_error_2 = KSL_MULF(1.0000005f, fabsf(diagonal2_apart_1
          + (fine_m_2 < fine_others_2 ? fine_diagonal2b_lo : fine_diagonal2a_lo))),
      diagonal0_bound_1 = diagonal0_error_2 + KSL_MULF(2.6718253e-10f, diagonal0_padded_1),
      R_bound_1 = KSL_MULF(1.0000005f, fabsf(fine_R_01 - R_01
          + (fine_R_lo1_1 + (fine_m_cross2_4 - fine_alpha_v_cross_3)))) + R_rest_1,
      R_bound_2 = KSL_MULF(1.0000005f, fabsf(fine_R_02 - R_02
          + (fine_R_lo1_2 + (fine_m_cross2_5 + fine_alpha_v_cross_2)))) + R_rest_2,
      R_bound_3 = KSL_MULF(1.0000005f, fabsf(fine_R_10 - R_10
          + (fine_R_lo1_3 + (fine_m_cross2_4 + fine_alpha_v_cross_3)))) + R_rest_1,
      diagonal1_bound_1 = diagonal1_error_2 + KSL_MULF(2.6718253e-10f, diagonal1_padded_1),
      R_bound_4 = KSL_MULF(1.0000005f, fabsf(fine_R_12 - R_12
          + (fine_R_lo1_4 + (fine_m_cross2_6 - fine_alpha_v_cross_1)))) + R_rest_3,
      R_bound_5 = KSL_MULF(1.0000005f, fabsf(fine_R_20 - R_20
          + (fine_R_lo1_5 + (fine_m_cross2_5 - fine_alpha_v_cross_2)))) + R_rest_2,
      R_bound_6 = KSL_MULF(1.0000005f, fabsf(fine_R_21 - R_21
          + (fine_R_lo1_6 + (fine_m_cross2_6 + fine_alpha_v_cross_1)))) + R_rest_3,
      diagonal2_bound_1 = diagonal2_error_2 + KSL_MULF(2.6718253e-10f, diagonal2_padded_1);
  R->m00 = diagonal0;
  R->m01 = R_01;
  R->m02 = R_02;
  R->m10 = R_10;
  R->m11 = diagonal1;
  R->m12 = R_12;
  R->m20 = R_20;
  R->m21 = R_21;
  R->m22 = diagonal2;
  R_bound->m00 = diagonal0_bound_1;
  R_bound->m01 = R_bound_1;
  R_bound->m02 = R_bound_2;
  R_bound->m10 = R_bound_3;
  R_bound->m11 = diagonal1_bound_1;
  R_bound->m12 = R_bound_4;
  R_bound->m20 = R_bound_5;
  R_bound->m21 = R_bound_6;
  R_bound->m22 = diagonal2_bound_1;
}

/* R = J_l(v)^-1 = I - v~/2 + (1 - θ/2 cot θ/2)/θ^2 v~^2, θ = |v|; singular at multiples of 2π
     except 0; |error of R| <= R_bound unless inf or NaN.
   v: vector; R, R_bound: rotation or other 3×3 matrix.
   390 mul, 705 add, 20 product error, 34 product rest, 23 div, 3 sqrt, 6 neg, 93 abs, 23 less, 1
     equal, 47 select. */
static inline void ksl_SO3_leftJacobianInversef_certified(const ksl_vec3f_t *v, ksl_mat3x3f_t *R,
    ksl_mat3x3f_t *R_bound) {
  const float size_0 = fabsf(v->x), size_1 = fabsf(v->y), size_2 = fabsf(v->z);
  const float sizes = size_0 + size_1 + size_2;
  const float grid = KSL_MULF(sizes, 8192.0f);
  const float shifted_0 = v->x + grid, shifted_1 = v->y + grid, shifted_2 = v->z + grid;
  const float high_0 = shifted_0 - grid, high_1 = shifted_1 - grid, high_2 = shifted_2 - grid;
  const float low_0 = v->x - high_0, low_1 = v->y - high_1, low_2 = v->z - high_2;
  const float sum_0 = v->x + high_0, sum_1 = v->y + high_1, sum_2 = v->z + high_2;
  const float squares = KSL_MULF(high_0, high_0) + KSL_MULF(high_1, high_1)
          + KSL_MULF(high_2, high_2);
  const float cross = KSL_MULF(low_0, sum_0) + KSL_MULF(low_1, sum_1) + KSL_MULF(low_2, sum_2);
  const float x = squares + cross;
  const float theta_a = sqrtf(x), theta = x < 1.0f ? 1.0f : theta_a;
  const float theta_shifted = grid + theta;
  const float theta_high = theta_shifted - grid;
  const float theta_low = theta - theta_high;
  const float theta_sum = theta + theta_high;
  const float cross_rest = cross - KSL_MULF(theta_low, theta_sum);
  const float exact = squares - KSL_MULF(theta_high, theta_high);
  const float residual = cross_rest + exact;
  const float small = KSL_MULF(0.5f, residual) / theta;
  const float delta = fabsf(small) < 0.0078125f ? small : 0.0f;
  float far_cosine_a; const float far_sine_a = ksl_sincosf(theta, &far_cosine_a);
  const float far_sine = x < 1.0f ? 1.0f : far_sine_a;
  const float far_cosine = x < 1.0f ? 0.0f : far_cosine_a;
  const float sine = KSL_MULF(delta, far_cosine) + far_sine;
  const float cosine = far_cosine - KSL_MULF(delta, far_sine);
  const float above_a = cosine + 1.0f, above = cosine < 0.0f ? sine : above_a;
  const float below_a = 1.0f - cosine, below = cosine < 0.0f ? below_a : sine;
  const float cotangent = above / below;
  const float half_cotangent = KSL_MULF(KSL_MULF(0.5f, theta), cotangent);
  const float b_rest = 1.0f - half_cotangent;
  const float b_divisor = x < 4.0f ? 4.0f : x;
  const float closed_b = b_rest / b_divisor;
  const float b_h = KSL_MULF(x, KSL_MULF(x, KSL_MULF(x, KSL_MULF(1.4551725e-27f, x)
          + 5.744791e-26f) + 2.2679524e-24f) + 8.9535176e-23f) + 3.534707e-21f,
      b_q = KSL_MULF(x, KSL_MULF(x, KSL_MULF(x, KSL_MULF(x, KSL_MULF(x, b_h) + 1.3954465e-19f)
          + 5.509003e-18f) + 2.1748687e-16f) + 8.586062e-15f),
      b_z = KSL_MULF(x, KSL_MULF(x, KSL_MULF(x, KSL_MULF(x, b_q + 3.3896803e-13f) + 1.3382536e-11f)
          + 5.2841903e-10f) + 2.0876756e-08f) + 8.267196e-07f,
      b_af = KSL_MULF(x, KSL_MULF(x, KSL_MULF(x, b_z) + 3.3068784e-05f) + 0.0013888889f)
          + 0.083333336f, b = x < 4.0f ? b_af : closed_b;
  const float b_across_b = 1.0f - KSL_MULF(x, b), b_across = x < 4.0f ? b_across_b : half_cotangent;
  const float beta_v_0 = KSL_MULF(v->x, b);
  const float beta_v_1 = KSL_MULF(v->y, b);
  const float beta_v_2 = KSL_MULF(v->z, b);
  const float m_0 = KSL_MULF(v->x, beta_v_0);
  const float m_1 = KSL_MULF(v->y, beta_v_1);
  const float m_2 = KSL_MULF(v->z, beta_v_2);
  const float m_3 = KSL_MULF(v->y, beta_v_0);
  const float m_4 = KSL_MULF(v->z, beta_v_0);
  const float m_5 = KSL_MULF(v->z, beta_v_1);
  const float others_0 = m_1 + m_2;
  const float others_1 = m_0 + m_2;
  const float others_2 = m_0 + m_1;
  const float diagonal0a = 1.0f - others_0, diagonal0b = b_across + m_0,
      diagonal0 = m_0 < others_0 ? diagonal0b : diagonal0a;
  const float diagonal1a = 1.0f - others_1, diagonal1b = b_across + m_1,
      diagonal1 = m_1 < others_1 ? diagonal1b : diagonal1a;
  const float diagonal2a = 1.0f - others_2, diagonal2b = b_across + m_2,
      diagonal2 = m_2 < others_2 ? diagonal2b : diagonal2a;
  const float alpha_v_0 = -KSL_MULF(0.5f, v->x);
  const float alpha_v_1 = -KSL_MULF(0.5f, v->y);
  const float alpha_v_2 = -KSL_MULF(0.5f, v->z);
  const float R_01 = m_3 - alpha_v_2;
  const float R_02 = m_4 + alpha_v_1;
  const float R_10 = m_3 + alpha_v_2;
  const float R_12 = m_5 - alpha_v_0;
  const float R_20 = m_4 - alpha_v_1;
  const float R_21 = m_5 + alpha_v_0;
  const float halved_0 = KSL_MULF(0.5f, v->x), halved_size_1 = fabsf(v->x),
      halved_size_2 = KSL_MULF(0.5f, halved_size_1);
  const float halved_1 = KSL_MULF(0.5f, v->y), halved_size_3 = fabsf(v->y),
      halved_size_4 = KSL_MULF(0.5f, halved_size_3);
  const float halved_2 = KSL_MULF(0.5f, v->z), halved_size_5 = fabsf(v->z),
      halved_size_6 = KSL_MULF(0.5f, halved_size_5);
  const float y_a = KSL_MULF(halved_0, halved_0), y_a_padded_1 = 3.3087225e-24f + halved_size_2,
      y_b = KSL_MULF(halved_1, halved_1), y_b_padded_1 = 3.3087225e-24f + halved_size_4,
      y_c = y_a + y_b, y_c_right_1 = y_c - y_a, y_d = KSL_MULF(halved_2, halved_2),
      y_d_padded_1 = 3.3087225e-24f + halved_size_6, y = y_c + y_d, y_right_1 = y - y_c,
      y_c_lo = ksl_product_restf(halved_0, halved_0, y_a, y_c - y_c_right_1)
          + ksl_product_restf(halved_1, halved_1, y_b, y_c_right_1),
      y_lo = y_c - (y - y_right_1) + ksl_product_restf(halved_2, halved_2, y_d, y_right_1) + y_c_lo,
      y_size_1 = KSL_MULF(y_a_padded_1, y_a_padded_1) + KSL_MULF(y_b_padded_1, y_b_padded_1)
          + KSL_MULF(y_d_padded_1, y_d_padded_1);
  const float half_angle = sqrtf(y), half_angle_product_1 = KSL_MULF(half_angle, half_angle),
      half_angle_twice_1 = half_angle + half_angle,
      half_angle_residual_1 = y - half_angle_product_1
          - ksl_product_errorf(half_angle, half_angle, half_angle_product_1) + y_lo,
      half_angle_lo = half_angle_residual_1 / (half_angle == 0.0f ? 1.0f : half_angle_twice_1),
      half_angle_padded_1 = 3.3087225e-24f + y_size_1,
      half_angle_bound_1 = fabsf(y_lo) + KSL_MULF(7.2120885e-13f, half_angle_padded_1),
      half_angle_reach_1 = fabsf(y) + KSL_MULF(262144.0f, half_angle_bound_1),
      half_angle_size_4 = KSL_MULF(half_angle_reach_1, half_angle_padded_1 / half_angle / y),
      half_angle_size_6 = fabsf(half_angle_lo),
      half_angle_size_8 = KSL_MULF(8.907313e+11f, sqrtf(half_angle_bound_1) + half_angle_size_6),
      half_angle_size_12 = half_angle
          + (KSL_MULF(4.0f, half_angle_bound_1) < y ? half_angle_size_4 : half_angle_size_8);
  float c; const float fine_sine = ksl_sincosf(half_angle, &c);
  float c_own_error_1; const float fine_sine_own_error_1 = ksl_sincos_errorf(half_angle, fine_sine,
      c, &c_own_error_1);
  const float fine_sine_half_1 = KSL_MULF(half_angle_lo, 0.5f);
  float fine_sine_half_cos_1; const float fine_sine_half_sin_1 = ksl_sincosf(fine_sine_half_1,
      &fine_sine_half_cos_1);
  const float fine_sine_twice_1 = fine_sine_half_sin_1 + fine_sine_half_sin_1,
      fine_sine_padded_1 = 3.3087225e-24f + half_angle_size_12,
      fine_sine_size_1 = 1.0f + fine_sine_padded_1;
  const float c_lo = c_own_error_1
          - KSL_MULF(KSL_MULF(fine_sine_half_cos_1, fine_sine)
          + KSL_MULF(fine_sine_half_sin_1, c), fine_sine_twice_1);
  const float sinc_divisor = half_angle < 1.4901161e-08f ? 1.4901161e-08f : half_angle,
      sinc_divisor_lo = half_angle < 1.4901161e-08f ? 0.0f : half_angle_lo,
      sinc_divisor_bound_1 = half_angle_size_6 + KSL_MULF(1.2221551e-12f, fine_sine_padded_1),
      sinc_divisor_size_3 = fabsf(half_angle - 1.4901161e-08f),
      sinc_divisor_size_7 = sinc_divisor_bound_1 + fabsf(1.4901161e-08f - half_angle),
      sinc_divisor_size_9 = KSL_MULF(3.1414265e+11f, sinc_divisor_bound_1 < sinc_divisor_size_3
          ? 0.0f : sinc_divisor_size_7);
  const float sinc_quotient = fine_sine / sinc_divisor,
      sinc_quotient_product_1 = KSL_MULF(sinc_quotient, sinc_divisor);
  const float fine_sine_lo = fine_sine_own_error_1
          + KSL_MULF(KSL_MULF(fine_sine_half_cos_1, c)
          - KSL_MULF(fine_sine_half_sin_1, fine_sine), fine_sine_twice_1);
  const float sinc_quotient_exact_1 = fine_sine - sinc_quotient_product_1
          - ksl_product_errorf(sinc_quotient, sinc_divisor, sinc_quotient_product_1),
      sinc_quotient_lo = (sinc_quotient_exact_1 + fine_sine_lo
          - KSL_MULF(sinc_quotient, sinc_divisor_lo)) / sinc_divisor,
      sinc_quotient_padded_1 = 3.3087225e-24f + fine_sine_size_1,
      sinc_quotient_padded_2 = 3.3087225e-24f
          + ((half_angle < 1.4901161e-08f ? 1.4901161e-08f : half_angle_size_12)
          + sinc_divisor_size_9), sinc_quotient_size_1 = fabsf(sinc_quotient),
      sinc_quotient_size_2 = fabsf(sinc_divisor),
      sinc_quotient_bound_1 = fabsf(sinc_divisor_lo)
          + KSL_MULF(3.2827582e-12f, sinc_quotient_padded_2),
      sinc_quotient_size_7 = KSL_MULF(4.0f, sinc_quotient_bound_1) < sinc_quotient_size_2
          ? sinc_quotient_size_2 : 0.0f,
      sinc_quotient_size_8 = (sinc_quotient_padded_1
          + KSL_MULF(sinc_quotient_padded_2, sinc_quotient_size_1)) / sinc_quotient_size_7,
      sinc_quotient_size_10 = KSL_MULF(sinc_quotient_size_2
          + KSL_MULF(262144.0f, sinc_quotient_bound_1), sinc_quotient_size_8)
          / sinc_quotient_size_2,
      sinc_quotient_size_11 = sinc_quotient_size_1 + sinc_quotient_size_10;
  const float sinc_a = KSL_MULF(0.16666667f, y), sinc_b = 1.0f - sinc_a,
      sinc_b_right_1 = 1.0f - sinc_b,
      sinc_b_lo1_1 = 1.0f - (sinc_b + sinc_b_right_1)
          - ksl_product_restf(0.16666667f, y, sinc_a, sinc_b_right_1),
      sinc_b_lo = sinc_b_lo1_1 - (KSL_MULF(-4.967054e-09f, y) + KSL_MULF(0.16666667f, y_lo)),
      sinc_b_size_1 = 1.0f + KSL_MULF(0.16666669f, y_size_1),
      sinc = half_angle < 1.4901161e-08f ? sinc_b : sinc_quotient,
      sinc_lo = half_angle < 1.4901161e-08f ? sinc_b_lo : sinc_quotient_lo,
      sinc_size_4 = fabsf(sinc_b_lo) + KSL_MULF(2.3406937e-10f, 3.3087225e-24f + sinc_b_size_1)
          + fabsf(sinc_b - sinc_quotient),
      sinc_size_5 = fabsf(sinc_quotient_lo)
          + KSL_MULF(5.43103e-12f, 3.3087225e-24f + sinc_quotient_size_11) + sinc_size_4,
      sinc_size_7 = KSL_MULF(4.276409e+09f, sinc_divisor_bound_1 < sinc_divisor_size_3 ? 0.0f
          : sinc_size_5),
      sinc_size_8 = (half_angle < 1.4901161e-08f ? sinc_b_size_1 : sinc_quotient_size_11)
          + sinc_size_7;
  const float series_phi_a = KSL_MULF(5.107725e-32f, y),
      series_phi_b = 4.1168266e-29f - series_phi_a,
      series_phi_b_right_1 = 4.1168266e-29f - series_phi_b,
      series_phi_b_lo1_1 = 4.1168266e-29f - (series_phi_b + series_phi_b_right_1)
          - ksl_product_restf(5.107725e-32f, y, series_phi_a, series_phi_b_right_1),
      series_phi_b_lo = series_phi_b_lo1_1
          - (KSL_MULF(3.51736e-40f, y) + KSL_MULF(5.107725e-32f, y_lo)) + -1.3151732e-36f,
      series_phi_c = KSL_MULF(y, series_phi_b),
      series_phi_c_padded_1 = 3.3087225e-24f
          + (4.1168266e-29f + KSL_MULF(2.3741903e-25f, y_size_1)),
      series_phi_c_reach_1 = fabsf(series_phi_b)
          + KSL_MULF(262144.0f, fabsf(series_phi_b_lo)
          + KSL_MULF(2.3406937e-10f, series_phi_c_padded_1)),
      series_phi_d = series_phi_c - 2.8653114e-26f,
      series_phi_d_right_1 = series_phi_c - series_phi_d,
      series_phi_d_lo1_1 = ksl_product_restf(y, series_phi_b, series_phi_c, series_phi_d
          + series_phi_d_right_1) - (2.8653114e-26f - series_phi_d_right_1),
      series_phi_d_lo = series_phi_d_lo1_1 - -1.27647235e-33f
          + (KSL_MULF(y_lo, series_phi_b) + KSL_MULF(y, series_phi_b_lo)),
      series_phi_e = KSL_MULF(y, series_phi_d),
      series_phi_d_size_1 = 2.8653114e-26f
          + (KSL_MULF(half_angle_reach_1, series_phi_c_padded_1)
          + KSL_MULF(half_angle_padded_1, series_phi_c_reach_1)),
      series_phi_e_padded_1 = 3.3087225e-24f + series_phi_d_size_1,
      series_phi_e_reach_1 = fabsf(series_phi_d)
          + KSL_MULF(262144.0f, fabsf(series_phi_d_lo)
          + KSL_MULF(2.3574281e-10f, series_phi_e_padded_1)),
      series_phi_f = series_phi_e + 1.7019949e-23f,
      series_phi_f_right_1 = series_phi_f - series_phi_e,
      series_phi_f_lo1_1 = ksl_product_restf(y, series_phi_d, series_phi_e, series_phi_f
          - series_phi_f_right_1) + (1.7019949e-23f - series_phi_f_right_1),
      series_phi_f_lo = series_phi_f_lo1_1 + 1.9703667e-31f
          + (KSL_MULF(y_lo, series_phi_d) + KSL_MULF(y, series_phi_d_lo)),
      series_phi_g = KSL_MULF(y, series_phi_f),
      series_phi_f_size_1 = 1.7019949e-23f
          + (KSL_MULF(half_angle_reach_1, series_phi_e_padded_1)
          + KSL_MULF(half_angle_padded_1, series_phi_e_reach_1)),
      series_phi_g_padded_1 = 3.3087225e-24f + series_phi_f_size_1,
      series_phi_g_reach_1 = fabsf(series_phi_f)
          + KSL_MULF(262144.0f, fabsf(series_phi_f_lo)
          + KSL_MULF(2.374802e-10f, series_phi_g_padded_1)),
      series_phi_h = series_phi_g - 8.509974e-21f,
      series_phi_h_right_1 = series_phi_g - series_phi_h,
      series_phi_h_lo1_1 = ksl_product_restf(y, series_phi_f, series_phi_g, series_phi_h
          + series_phi_h_right_1) - (8.509974e-21f - series_phi_h_right_1),
      series_phi_h_lo = series_phi_h_lo1_1 - 1.016591e-29f
          + (KSL_MULF(y_lo, series_phi_f) + KSL_MULF(y, series_phi_f_lo)),
      series_phi_i = KSL_MULF(y, series_phi_h),
      series_phi_h_size_1 = 8.509974e-21f
          + (KSL_MULF(half_angle_reach_1, series_phi_g_padded_1)
          + KSL_MULF(half_angle_padded_1, series_phi_g_reach_1)),
      series_phi_i_padded_1 = 3.3087225e-24f + series_phi_h_size_1,
      series_phi_i_reach_1 = fabsf(series_phi_h)
          + KSL_MULF(262144.0f, fabsf(series_phi_h_lo)
          + KSL_MULF(2.392816e-10f, series_phi_i_padded_1)),
      series_phi_j = series_phi_i + 3.5231293e-18f,
      series_phi_j_right_1 = series_phi_j - series_phi_i,
      series_phi_j_lo1_1 = ksl_product_restf(y, series_phi_h, series_phi_i, series_phi_j
          - series_phi_j_right_1) + (3.5231293e-18f - series_phi_j_right_1),
      series_phi_j_lo = series_phi_j_lo1_1 + 7.2063343e-26f
          + (KSL_MULF(y_lo, series_phi_h) + KSL_MULF(y, series_phi_h_lo)),
      series_phi_k = KSL_MULF(y, series_phi_j),
      series_phi_j_size_1 = 3.5231293e-18f
          + (KSL_MULF(half_angle_reach_1, series_phi_i_padded_1)
          + KSL_MULF(half_angle_padded_1, series_phi_i_reach_1)),
      series_phi_k_padded_1 = 3.3087225e-24f + series_phi_j_size_1,
      series_phi_k_reach_1 = fabsf(series_phi_j)
          + KSL_MULF(262144.0f, fabsf(series_phi_j_lo)
          + KSL_MULF(2.41147e-10f, series_phi_k_padded_1)),
      series_phi_l = series_phi_k - 1.1837714e-15f,
      series_phi_l_right_1 = series_phi_k - series_phi_l,
      series_phi_l_lo1_1 = ksl_product_restf(y, series_phi_j, series_phi_k, series_phi_l
          + series_phi_l_right_1) - (1.1837714e-15f - series_phi_l_right_1),
      series_phi_l_lo = series_phi_l_lo1_1 - 5.0683064e-23f
          + (KSL_MULF(y_lo, series_phi_j) + KSL_MULF(y, series_phi_j_lo)),
      series_phi_m = KSL_MULF(y, series_phi_l),
      series_phi_l_size_1 = 1.1837714e-15f
          + (KSL_MULF(half_angle_reach_1, series_phi_k_padded_1)
          + KSL_MULF(half_angle_padded_1, series_phi_k_reach_1)),
      series_phi_m_padded_1 = 3.3087225e-24f + series_phi_l_size_1,
      series_phi_m_reach_1 = fabsf(series_phi_l)
          + KSL_MULF(262144.0f, fabsf(series_phi_l_lo)
          + KSL_MULF(2.4307634e-10f, series_phi_m_padded_1)),
      series_phi_n = series_phi_m + 3.148832e-13f,
      series_phi_n_right_1 = series_phi_n - series_phi_m,
      series_phi_n_lo1_1 = ksl_product_restf(y, series_phi_l, series_phi_m, series_phi_n
          - series_phi_n_right_1) + (3.148832e-13f - series_phi_n_right_1),
      series_phi_n_lo = series_phi_n_lo1_1 + 1.834992e-21f
          + (KSL_MULF(y_lo, series_phi_l) + KSL_MULF(y, series_phi_l_lo)),
      series_phi_o = KSL_MULF(y, series_phi_n),
      series_phi_n_size_1 = 3.148832e-13f
          + (KSL_MULF(half_angle_reach_1, series_phi_m_padded_1)
          + KSL_MULF(half_angle_padded_1, series_phi_m_reach_1)),
      series_phi_o_padded_1 = 3.3087225e-24f + series_phi_n_size_1,
      series_phi_o_reach_1 = fabsf(series_phi_n)
          + KSL_MULF(262144.0f, fabsf(series_phi_n_lo)
          + KSL_MULF(2.4506966e-10f, series_phi_o_padded_1)),
      series_phi_p = series_phi_o - 6.423617e-11f,
      series_phi_p_right_1 = series_phi_o - series_phi_p,
      series_phi_p_lo1_1 = ksl_product_restf(y, series_phi_n, series_phi_o, series_phi_p
          + series_phi_p_right_1) - (6.423617e-11f - series_phi_p_right_1),
      series_phi_p_lo = series_phi_p_lo1_1 - 3.4101044e-18f
          + (KSL_MULF(y_lo, series_phi_n) + KSL_MULF(y, series_phi_n_lo)),
      series_phi_q = KSL_MULF(y, series_phi_p),
      series_phi_p_size_1 = 6.423617e-11f
          + (KSL_MULF(half_angle_reach_1, series_phi_o_padded_1)
          + KSL_MULF(half_angle_padded_1, series_phi_o_reach_1)),
      series_phi_q_padded_1 = 3.3087225e-24f + series_phi_p_size_1,
      series_phi_q_reach_1 = fabsf(series_phi_p)
          + KSL_MULF(262144.0f, fabsf(series_phi_p_lo)
          + KSL_MULF(2.4712699e-10f, series_phi_q_padded_1)),
      series_phi_r = series_phi_q + 9.635427e-09f,
      series_phi_r_right_1 = series_phi_r - series_phi_q,
      series_phi_r_lo1_1 = ksl_product_restf(y, series_phi_p, series_phi_q, series_phi_r
          - series_phi_r_right_1) + (9.635427e-09f - series_phi_r_right_1),
      series_phi_r_lo = series_phi_r_lo1_1 + -3.7666274e-16f
          + (KSL_MULF(y_lo, series_phi_p) + KSL_MULF(y, series_phi_p_lo)),
      series_phi_s = KSL_MULF(y, series_phi_r),
      series_phi_r_size_1 = 9.635427e-09f
          + (KSL_MULF(half_angle_reach_1, series_phi_q_padded_1)
          + KSL_MULF(half_angle_padded_1, series_phi_q_reach_1)),
      series_phi_s_padded_1 = 3.3087225e-24f + series_phi_r_size_1,
      series_phi_s_reach_1 = fabsf(series_phi_r)
          + KSL_MULF(262144.0f, fabsf(series_phi_r_lo)
          + KSL_MULF(2.4924826e-10f, series_phi_s_padded_1)),
      series_phi_t = series_phi_s - 1.0020843e-06f,
      series_phi_t_right_1 = series_phi_s - series_phi_t,
      series_phi_t_lo1_1 = ksl_product_restf(y, series_phi_r, series_phi_s, series_phi_t
          + series_phi_t_right_1) - (1.0020843e-06f - series_phi_t_right_1),
      series_phi_t_lo = series_phi_t_lo1_1 - 3.4596379e-15f
          + (KSL_MULF(y_lo, series_phi_r) + KSL_MULF(y, series_phi_r_lo)),
      series_phi_u = KSL_MULF(y, series_phi_t),
      series_phi_t_size_1 = 1.0020843e-06f
          + (KSL_MULF(half_angle_reach_1, series_phi_s_padded_1)
          + KSL_MULF(half_angle_padded_1, series_phi_s_reach_1)),
      series_phi_u_padded_1 = 3.3087225e-24f + series_phi_t_size_1,
      series_phi_u_reach_1 = fabsf(series_phi_t)
          + KSL_MULF(262144.0f, fabsf(series_phi_t_lo)
          + KSL_MULF(2.5143354e-10f, series_phi_u_padded_1)),
      series_phi_v = series_phi_u + 6.613757e-05f,
      series_phi_v_right_1 = series_phi_v - series_phi_u,
      series_phi_v_lo1_1 = ksl_product_restf(y, series_phi_t, series_phi_u, series_phi_v
          - series_phi_v_right_1) + (6.613757e-05f - series_phi_v_right_1),
      series_phi_v_lo = series_phi_v_lo1_1 + -9.0853226e-13f
          + (KSL_MULF(y_lo, series_phi_t) + KSL_MULF(y, series_phi_t_lo)),
      series_phi_w = KSL_MULF(y, series_phi_v),
      series_phi_v_size_1 = 6.613757e-05f
          + (KSL_MULF(half_angle_reach_1, series_phi_u_padded_1)
          + KSL_MULF(half_angle_padded_1, series_phi_u_reach_1)),
      series_phi_w_padded_1 = 3.3087225e-24f + series_phi_v_size_1,
      series_phi_w_reach_1 = fabsf(series_phi_v)
          + KSL_MULF(262144.0f, fabsf(series_phi_v_lo)
          + KSL_MULF(2.5368282e-10f, series_phi_w_padded_1)),
      series_phi_x = series_phi_w - 0.0023809525f,
      series_phi_x_right_1 = series_phi_w - series_phi_x,
      series_phi_x_lo1_1 = ksl_product_restf(y, series_phi_v, series_phi_w, series_phi_x
          + series_phi_x_right_1) - (0.0023809525f - series_phi_x_right_1),
      series_phi_x_lo = series_phi_x_lo1_1 - -9.0914824e-11f
          + (KSL_MULF(y_lo, series_phi_v) + KSL_MULF(y, series_phi_v_lo)),
      series_phi_y = KSL_MULF(y, series_phi_x),
      series_phi_x_size_1 = 0.0023809525f
          + (KSL_MULF(half_angle_reach_1, series_phi_w_padded_1)
          + KSL_MULF(half_angle_padded_1, series_phi_w_reach_1)),
      series_phi_y_padded_1 = 3.3087225e-24f + series_phi_x_size_1,
      series_phi_y_reach_1 = fabsf(series_phi_x)
          + KSL_MULF(262144.0f, fabsf(series_phi_x_lo)
          + KSL_MULF(2.5599609e-10f, series_phi_y_padded_1)),
      series_phi = series_phi_y + 0.033333335f, series_phi_right_1 = series_phi - series_phi_y,
      series_phi_lo1_1 = ksl_product_restf(y, series_phi_x, series_phi_y, series_phi
          - series_phi_right_1) + (0.033333335f - series_phi_right_1),
      series_phi_lo = series_phi_lo1_1 + -1.7384688e-09f
          + (KSL_MULF(y_lo, series_phi_x) + KSL_MULF(y, series_phi_x_lo));
  const float f_more_a = KSL_MULF(2.0f, y), f_more_a_cross2_1 = KSL_MULF(2.0f, y_lo),
      f_more = KSL_MULF(f_more_a, series_phi),
      f_more_padded_1 = 3.3087225e-24f + KSL_MULF(2.0f, y_size_1);
  const float series_phi_size_1 = 0.033333335f
          + (KSL_MULF(half_angle_reach_1, series_phi_y_padded_1)
          + KSL_MULF(half_angle_padded_1, series_phi_y_reach_1));
  const float f_more_padded_2 = 3.3087225e-24f + series_phi_size_1,
      f_more_size_2 = KSL_MULF(f_more_padded_2, fabsf(f_more_a)
          + KSL_MULF(262144.0f, fabsf(f_more_a_cross2_1)
          + KSL_MULF(8.100306e-13f, f_more_padded_1))),
      f_more_size_4 = KSL_MULF(f_more_padded_1, fabsf(series_phi)
          + KSL_MULF(262144.0f, fabsf(series_phi_lo) + KSL_MULF(2.5837332e-10f, f_more_padded_2)));
  const float near_f_a = KSL_MULF(0.33333334f, sinc), near_f_b = KSL_MULF(0.33333334f, f_more),
      f_more_lo = ksl_product_errorf(f_more_a, series_phi, f_more)
          + (KSL_MULF(f_more_a_cross2_1, series_phi) + KSL_MULF(f_more_a, series_phi_lo)),
      near_f = near_f_a + near_f_b, near_f_right_1 = near_f - near_f_a,
      near_f_b_cross_1 = KSL_MULF(-9.934108e-09f, f_more) + KSL_MULF(0.33333334f, f_more_lo),
      near_f_left_rest_1 = ksl_product_restf(0.33333334f, sinc, near_f_a, near_f - near_f_right_1),
      near_f_lo1_1 = near_f_left_rest_1
          + ksl_product_restf(0.33333334f, f_more, near_f_b, near_f_right_1),
      near_f_lo = near_f_lo1_1
          + (KSL_MULF(-9.934108e-09f, sinc) + KSL_MULF(0.33333334f, sinc_lo) + near_f_b_cross_1),
      near_f_size_1 = KSL_MULF(0.33333334f, sinc_size_8)
          + KSL_MULF(0.33333334f, f_more_size_2 + f_more_size_4);
  const float f_rest = sinc - c, f_rest_right_1 = sinc - f_rest;
  const float fine_x = KSL_MULF(4.0f, y);
  const float far_y = fine_x < 4.0f ? 1.0f : y, far_y_lo = fine_x < 4.0f ? 0.0f : y_lo,
      far_y_bound_1 = fabsf(KSL_MULF(4.0f, y_lo))
          + KSL_MULF(8.100306e-13f, 3.3087225e-24f + KSL_MULF(4.0f, y_size_1)),
      far_y_size_3 = fabsf(fine_x - 4.0f), far_y_size_7 = fabsf(1.0f - y) + half_angle_bound_1;
  const float closed_f = f_rest / far_y, closed_f_product_1 = KSL_MULF(closed_f, far_y),
      closed_f_exact_1 = f_rest - closed_f_product_1
          - ksl_product_errorf(closed_f, far_y, closed_f_product_1),
      closed_f_lo = (closed_f_exact_1
          + (sinc - (f_rest + f_rest_right_1) - (c - f_rest_right_1) - c_lo + sinc_lo)
          - KSL_MULF(closed_f, far_y_lo)) / far_y;
  const float far_y_size_10 = (fine_x < 4.0f ? 1.0f : y_size_1)
          + KSL_MULF(2.1990035e+11f, far_y_bound_1 < far_y_size_3 ? 0.0f : far_y_size_7);
  const float closed_f_padded_2 = 3.3087225e-24f + far_y_size_10, closed_f_size_1 = fabsf(closed_f),
      closed_f_size_2 = fabsf(far_y),
      closed_f_bound_1 = fabsf(far_y_lo) + KSL_MULF(4.6896445e-12f, closed_f_padded_2),
      closed_f_size_4 = 3.3087225e-24f + (fine_sine_size_1 + sinc_size_8)
          + KSL_MULF(closed_f_padded_2, closed_f_size_1),
      closed_f_size_8 = closed_f_size_4
          / (KSL_MULF(4.0f, closed_f_bound_1) < closed_f_size_2 ? closed_f_size_2 : 0.0f),
      closed_f_size_11 = closed_f_size_1
          + KSL_MULF(closed_f_size_2 + KSL_MULF(262144.0f, closed_f_bound_1), closed_f_size_8)
          / closed_f_size_2;
  const float f = fine_x < 4.0f ? near_f : closed_f,
      f_size_4 = fabsf(near_f_lo) + KSL_MULF(2.6163277e-10f, 3.3087225e-24f + near_f_size_1)
          + fabsf(near_f - closed_f),
      f_size_5 = fabsf(closed_f_lo) + KSL_MULF(2.3766553e-10f, 3.3087225e-24f + closed_f_size_11)
          + f_size_4;
  const float four_k = KSL_MULF(4.0f, sinc), four_k_cross2_1 = KSL_MULF(4.0f, sinc_lo);
  const float fine_b = f / four_k, fine_b_product_1 = KSL_MULF(fine_b, four_k),
      fine_b_numerator_1 = f - fine_b_product_1
          - ksl_product_errorf(fine_b, four_k, fine_b_product_1)
          + (fine_x < 4.0f ? near_f_lo : closed_f_lo),
      fine_b_lo = (fine_b_numerator_1 - KSL_MULF(fine_b, four_k_cross2_1)) / four_k;
  const float f_size_8 = (fine_x < 4.0f ? near_f_size_1 : closed_f_size_11)
          + KSL_MULF(3.8371738e+09f, far_y_bound_1 < far_y_size_3 ? 0.0f : f_size_5);
  const float fine_b_padded_2 = 3.3087225e-24f + KSL_MULF(4.0f, sinc_size_8),
      fine_b_size_1 = fabsf(fine_b), fine_b_size_2 = fabsf(four_k),
      fine_b_bound_1 = fabsf(four_k_cross2_1) + KSL_MULF(2.3419117e-10f, fine_b_padded_2),
      fine_b_size_7 = KSL_MULF(4.0f, fine_b_bound_1) < fine_b_size_2 ? fine_b_size_2 : 0.0f,
      fine_b_size_8 = (3.3087225e-24f + f_size_8 + KSL_MULF(fine_b_padded_2, fine_b_size_1))
          / fine_b_size_7;
  const float fine_b_across = c / sinc, fine_b_across_product_1 = KSL_MULF(fine_b_across, sinc),
      fine_b_across_numerator_1 = c - fine_b_across_product_1
          - ksl_product_errorf(fine_b_across, sinc, fine_b_across_product_1) + c_lo,
      fine_b_across_lo = (fine_b_across_numerator_1 - KSL_MULF(fine_b_across, sinc_lo)) / sinc,
      fine_b_across_padded_1 = 3.3087225e-24f + sinc_size_8,
      fine_b_across_size_1 = fabsf(fine_b_across), fine_b_across_size_2 = fabsf(sinc),
      fine_b_across_bound_1 = fabsf(sinc_lo) + KSL_MULF(2.3406946e-10f, fine_b_across_padded_1),
      fine_b_across_size_7 = KSL_MULF(4.0f, fine_b_across_bound_1) < fine_b_across_size_2
          ? fine_b_across_size_2 : 0.0f,
      fine_b_across_size_8 = (KSL_MULF(fine_b_across_padded_1, fine_b_across_size_1)
          + sinc_quotient_padded_1) / fine_b_across_size_7,
      fine_b_across_size_10 = KSL_MULF(fine_b_across_size_2
          + KSL_MULF(262144.0f, fine_b_across_bound_1), fine_b_across_size_8)
          / fine_b_across_size_2,
      fine_b_across_size_11 = fine_b_across_size_1 + fine_b_across_size_10;
  const float fine_beta_v_0 = KSL_MULF(v->x, fine_b),
      fine_beta_v_padded_1 = 3.3087225e-24f
          + (fine_b_size_1
          + KSL_MULF(fine_b_size_2 + KSL_MULF(262144.0f, fine_b_bound_1), fine_b_size_8)
          / fine_b_size_2);
  const float fine_beta_v_1 = KSL_MULF(v->y, fine_b);
  const float fine_beta_v_2 = KSL_MULF(v->z, fine_b);
  const float fine_beta_v_lo_1 = ksl_product_errorf(v->x, fine_b, fine_beta_v_0)
          + KSL_MULF(v->x, fine_b_lo), fine_m_0 = KSL_MULF(v->x, fine_beta_v_0),
      fine_m_cross2_1 = KSL_MULF(v->x, fine_beta_v_lo_1),
      fine_m_padded_1 = 3.3087225e-24f + KSL_MULF(fine_beta_v_padded_1, halved_size_1),
      fine_m_size_1 = KSL_MULF(fine_m_padded_1, halved_size_1);
  const float fine_beta_v_lo_2 = ksl_product_errorf(v->y, fine_b, fine_beta_v_1)
          + KSL_MULF(v->y, fine_b_lo), fine_m_1 = KSL_MULF(v->y, fine_beta_v_1),
      fine_m_cross2_2 = KSL_MULF(v->y, fine_beta_v_lo_2),
      fine_m_padded_2 = 3.3087225e-24f + KSL_MULF(fine_beta_v_padded_1, halved_size_3),
      fine_m_size_2 = KSL_MULF(fine_m_padded_2, halved_size_3);
  const float fine_m_2 = KSL_MULF(v->z, fine_beta_v_2),
      fine_m_cross2_3 = KSL_MULF(v->z, ksl_product_errorf(v->z, fine_b, fine_beta_v_2)
          + KSL_MULF(v->z, fine_b_lo)),
      fine_m_size_3 = KSL_MULF(3.3087225e-24f
          + KSL_MULF(fine_beta_v_padded_1, halved_size_5), halved_size_5);
  const float fine_m_3 = KSL_MULF(v->y, fine_beta_v_0),
      fine_m_cross2_4 = KSL_MULF(v->y, fine_beta_v_lo_1);
  const float fine_m_4 = KSL_MULF(v->z, fine_beta_v_0),
      fine_m_cross2_5 = KSL_MULF(v->z, fine_beta_v_lo_1);
  const float fine_m_5 = KSL_MULF(v->z, fine_beta_v_1),
      fine_m_cross2_6 = KSL_MULF(v->z, fine_beta_v_lo_2);
  const float fine_others_0 = fine_m_1 + fine_m_2, fine_others_right_1 = fine_others_0 - fine_m_1,
      fine_others_left_rest_1 = ksl_product_restf(v->y, fine_beta_v_1, fine_m_1, fine_others_0
          - fine_others_right_1),
      fine_others_lo1_1 = fine_others_left_rest_1
          + ksl_product_restf(v->z, fine_beta_v_2, fine_m_2, fine_others_right_1),
      fine_others_lo_1 = fine_others_lo1_1 + (fine_m_cross2_2 + fine_m_cross2_3),
      fine_others_size_1 = fine_m_size_2 + fine_m_size_3;
  const float fine_others_1 = fine_m_0 + fine_m_2, fine_others_right_2 = fine_others_1 - fine_m_0,
      fine_others_left_rest_2 = ksl_product_restf(v->x, fine_beta_v_0, fine_m_0, fine_others_1
          - fine_others_right_2),
      fine_others_lo1_2 = fine_others_left_rest_2
          + ksl_product_restf(v->z, fine_beta_v_2, fine_m_2, fine_others_right_2),
      fine_others_lo_2 = fine_others_lo1_2 + (fine_m_cross2_1 + fine_m_cross2_3),
      fine_others_size_2 = fine_m_size_1 + fine_m_size_3;
  const float fine_others_2 = fine_m_0 + fine_m_1, fine_others_right_3 = fine_others_2 - fine_m_0,
      fine_others_left_rest_3 = ksl_product_restf(v->x, fine_beta_v_0, fine_m_0, fine_others_2
          - fine_others_right_3),
      fine_others_lo1_3 = fine_others_left_rest_3
          + ksl_product_restf(v->y, fine_beta_v_1, fine_m_1, fine_others_right_3),
      fine_others_lo_3 = fine_others_lo1_3 + (fine_m_cross2_1 + fine_m_cross2_2),
      fine_others_size_3 = fine_m_size_1 + fine_m_size_2;
  const float fine_diagonal0a = 1.0f - fine_others_0,
      fine_diagonal0a_right_1 = 1.0f - fine_diagonal0a,
      fine_diagonal0a_lo = 1.0f - (fine_diagonal0a + fine_diagonal0a_right_1)
          - (fine_others_0 - fine_diagonal0a_right_1) - fine_others_lo_1,
      fine_diagonal0a_size_1 = 1.0f + fine_others_size_1,
      fine_diagonal0b = fine_b_across + fine_m_0,
      fine_diagonal0b_right_1 = fine_diagonal0b - fine_b_across,
      fine_diagonal0b_right_rest_1 = ksl_product_restf(v->x, fine_beta_v_0, fine_m_0,
          fine_diagonal0b_right_1),
      fine_diagonal0b_lo = fine_b_across - (fine_diagonal0b - fine_diagonal0b_right_1)
          + fine_diagonal0b_right_rest_1 + fine_m_cross2_1 + fine_b_across_lo,
      fine_diagonal0b_size_1 = fine_b_across_size_11 + fine_m_size_1,
      fine_diagonal0_error_1 = fabsf(ksl_product_errorf(v->x, fine_beta_v_0, fine_m_0)
          + fine_m_cross2_1),
      fine_diagonal0_bound_2 = fabsf(fine_others_lo_1)
          + KSL_MULF(2.7533278e-10f, 3.3087225e-24f + fine_others_size_1),
      fine_diagonal0_bound_3 = fabsf(fine_diagonal0b_lo)
          + KSL_MULF(2.7533278e-10f, 3.3087225e-24f + fine_diagonal0b_size_1),
      fine_diagonal0_bound_4 = fabsf(fine_diagonal0a_lo)
          + KSL_MULF(2.7640684e-10f, 3.3087225e-24f + fine_diagonal0a_size_1),
      fine_diagonal0_size_9 = fine_diagonal0_bound_4
          + (fine_diagonal0_bound_3 + fabsf(fine_diagonal0b - fine_diagonal0a)),
      fine_diagonal0_size_2 = fine_diagonal0_error_1
          + KSL_MULF(2.7428007e-10f, 3.3087225e-24f + fine_m_size_1) + fine_diagonal0_bound_2,
      fine_diagonal0_size_11 = KSL_MULF(3.633188e+09f, fine_diagonal0_size_2
          < fabsf(fine_m_0 - fine_others_0) ? 0.0f : fine_diagonal0_size_9);
  const float fine_diagonal1a = 1.0f - fine_others_1,
      fine_diagonal1a_right_1 = 1.0f - fine_diagonal1a,
      fine_diagonal1a_lo = 1.0f - (fine_diagonal1a + fine_diagonal1a_right_1)
          - (fine_others_1 - fine_diagonal1a_right_1) - fine_others_lo_2,
      fine_diagonal1a_size_1 = 1.0f + fine_others_size_2,
      fine_diagonal1b = fine_b_across + fine_m_1,
      fine_diagonal1b_right_1 = fine_diagonal1b - fine_b_across,
      fine_diagonal1b_right_rest_1 = ksl_product_restf(v->y, fine_beta_v_1, fine_m_1,
          fine_diagonal1b_right_1),
      fine_diagonal1b_lo = fine_b_across - (fine_diagonal1b - fine_diagonal1b_right_1)
          + fine_diagonal1b_right_rest_1 + fine_m_cross2_2 + fine_b_across_lo,
      fine_diagonal1b_size_1 = fine_b_across_size_11 + fine_m_size_2,
      fine_diagonal1_error_1 = fabsf(ksl_product_errorf(v->y, fine_beta_v_1, fine_m_1)
          + fine_m_cross2_2),
      fine_diagonal1_bound_2 = fabsf(fine_others_lo_2)
          + KSL_MULF(2.7533278e-10f, 3.3087225e-24f + fine_others_size_2),
      fine_diagonal1_bound_3 = fabsf(fine_diagonal1b_lo)
          + KSL_MULF(2.7533278e-10f, 3.3087225e-24f + fine_diagonal1b_size_1),
      fine_diagonal1_bound_4 = fabsf(fine_diagonal1a_lo)
          + KSL_MULF(2.7640684e-10f, 3.3087225e-24f + fine_diagonal1a_size_1),
      fine_diagonal1_size_9 = fine_diagonal1_bound_4
          + (fine_diagonal1_bound_3 + fabsf(fine_diagonal1b - fine_diagonal1a)),
      fine_diagonal1_size_2 = fine_diagonal1_error_1
          + KSL_MULF(2.7428007e-10f, 3.3087225e-24f + fine_m_size_2) + fine_diagonal1_bound_2,
      fine_diagonal1_size_11 = KSL_MULF(3.633188e+09f, fine_diagonal1_size_2
          < fabsf(fine_m_1 - fine_others_1) ? 0.0f : fine_diagonal1_size_9);
  const float fine_diagonal2a = 1.0f - fine_others_2,
      fine_diagonal2a_right_1 = 1.0f - fine_diagonal2a,
      fine_diagonal2a_lo = 1.0f - (fine_diagonal2a + fine_diagonal2a_right_1)
          - (fine_others_2 - fine_diagonal2a_right_1) - fine_others_lo_3,
      fine_diagonal2a_size_1 = 1.0f + fine_others_size_3,
      fine_diagonal2b = fine_b_across + fine_m_2,
      fine_diagonal2b_right_1 = fine_diagonal2b - fine_b_across,
      fine_diagonal2b_right_rest_1 = ksl_product_restf(v->z, fine_beta_v_2, fine_m_2,
          fine_diagonal2b_right_1),
      fine_diagonal2b_lo = fine_b_across - (fine_diagonal2b - fine_diagonal2b_right_1)
          + fine_diagonal2b_right_rest_1 + fine_m_cross2_3 + fine_b_across_lo,
      fine_diagonal2b_size_1 = fine_b_across_size_11 + fine_m_size_3,
      fine_diagonal2_error_1 = fabsf(ksl_product_errorf(v->z, fine_beta_v_2, fine_m_2)
          + fine_m_cross2_3),
      fine_diagonal2_bound_2 = fabsf(fine_others_lo_3)
          + KSL_MULF(2.7533278e-10f, 3.3087225e-24f + fine_others_size_3),
      fine_diagonal2_bound_3 = fabsf(fine_diagonal2b_lo)
          + KSL_MULF(2.7533278e-10f, 3.3087225e-24f + fine_diagonal2b_size_1),
      fine_diagonal2_bound_4 = fabsf(fine_diagonal2a_lo)
          + KSL_MULF(2.7640684e-10f, 3.3087225e-24f + fine_diagonal2a_size_1),
      fine_diagonal2_size_9 = fine_diagonal2_bound_4
          + (fine_diagonal2_bound_3 + fabsf(fine_diagonal2b - fine_diagonal2a)),
      fine_diagonal2_size_2 = fine_diagonal2_error_1
          + KSL_MULF(2.7428007e-10f, 3.3087225e-24f + fine_m_size_3) + fine_diagonal2_bound_2,
      fine_diagonal2_size_11 = KSL_MULF(3.633188e+09f, fine_diagonal2_size_2
          < fabsf(fine_m_2 - fine_others_2) ? 0.0f : fine_diagonal2_size_9);
  const float fine_alpha_v_0 = -halved_0;
  const float fine_alpha_v_1 = -halved_1;
  const float fine_alpha_v_2 = -halved_2;
  const float fine_R_01 = fine_m_3 - fine_alpha_v_2, fine_R_right_1 = fine_m_3 - fine_R_01;
  const float fine_R_02 = fine_m_4 + fine_alpha_v_1, fine_R_right_2 = fine_R_02 - fine_m_4;
  const float fine_R_10 = fine_m_3 + fine_alpha_v_2, fine_R_right_3 = fine_R_10 - fine_m_3;
  const float fine_R_12 = fine_m_5 - fine_alpha_v_0, fine_R_right_4 = fine_m_5 - fine_R_12;
  const float fine_R_20 = fine_m_4 - fine_alpha_v_1, fine_R_right_5 = fine_m_4 - fine_R_20;
  const float fine_R_21 = fine_m_5 + fine_alpha_v_0, fine_R_right_6 = fine_R_21 - fine_m_5;
  const float diagonal0_apart_1 = (fine_m_0 < fine_others_0 ? fine_diagonal0b : fine_diagonal0a)
          - diagonal0,
      diagonal0_padded_1 = 3.3087225e-24f
          + ((fine_m_0 < fine_others_0 ? fine_diagonal0b_size_1 : fine_diagonal0a_size_1)
          + fine_diagonal0_size_11),
      diagonal0_error_2 = KSL_MULF(1.0000005f, fabsf(diagonal0_apart_1
          + (fine_m_0 < fine_others_0 ? fine_diagonal0b_lo : fine_diagonal0a_lo)));
  const float fine_R_lo_1 = ksl_product_restf(v->y, fine_beta_v_0, fine_m_3, fine_R_01
          + fine_R_right_1) - (fine_alpha_v_2 - fine_R_right_1) + fine_m_cross2_4;
  const float R_rest_1 = KSL_MULF(2.7533278e-10f, 3.3087225e-24f
          + (KSL_MULF(fine_m_padded_1, halved_size_3) + halved_size_6));
  const float fine_R_lo_2 = ksl_product_restf(v->z, fine_beta_v_0, fine_m_4, fine_R_02
          - fine_R_right_2) + (fine_alpha_v_1 - fine_R_right_2) + fine_m_cross2_5;
  const float R_rest_2 = KSL_MULF(2.7533278e-10f, 3.3087225e-24f
          + (KSL_MULF(fine_m_padded_1, halved_size_5) + halved_size_4));
  const float fine_R_lo_3 = ksl_product_restf(v->y, fine_beta_v_0, fine_m_3, fine_R_10
          - fine_R_right_3) + (fine_alpha_v_2 - fine_R_right_3) + fine_m_cross2_4;
  const float diagonal1_apart_1 = (fine_m_1 < fine_others_1 ? fine_diagonal1b : fine_diagonal1a)
          - diagonal1,
      diagonal1_padded_1 = 3.3087225e-24f
          + ((fine_m_1 < fine_others_1 ? fine_diagonal1b_size_1 : fine_diagonal1a_size_1)
          + fine_diagonal1_size_11),
      diagonal1_error_2 = KSL_MULF(1.0000005f, fabsf(diagonal1_apart_1
          + (fine_m_1 < fine_others_1 ? fine_diagonal1b_lo : fine_diagonal1a_lo)));
  const float fine_R_lo_4 = ksl_product_restf(v->z, fine_beta_v_1, fine_m_5, fine_R_12
          + fine_R_right_4) - (fine_alpha_v_0 - fine_R_right_4) + fine_m_cross2_6;
  const float R_rest_3 = KSL_MULF(2.7533278e-10f, 3.3087225e-24f
          + (KSL_MULF(fine_m_padded_2, halved_size_5) + halved_size_2));
  const float fine_R_lo_5 = ksl_product_restf(v->z, fine_beta_v_0, fine_m_4, fine_R_20
          + fine_R_right_5) - (fine_alpha_v_1 - fine_R_right_5) + fine_m_cross2_5;
  const float fine_R_lo_6 = ksl_product_restf(v->z, fine_beta_v_1, fine_m_5, fine_R_21
          - fine_R_right_6) + (fine_alpha_v_0 - fine_R_right_6) + fine_m_cross2_6;
  const float diagonal2_apart_1 = (fine_m_2 < fine_others_2 ? fine_diagonal2b : fine_diagonal2a)
          - diagonal2,
      diagonal2_padded_1 = 3.3087225e-24f
          + ((fine_m_2 < fine_others_2 ? fine_diagonal2b_size_1 : fine_diagonal2a_size_1)
          + fine_diagonal2_size_11),
      diagonal2_error_2 = KSL_MULF(1.0000005f, fabsf(diagonal2_apart_1
          + (fine_m_2 < fine_others_2 ? fine_diagonal2b_lo : fine_diagonal2a_lo))),
      diagonal0_bound_1 = diagonal0_error_2 + KSL_MULF(2.7640693e-10f, diagonal0_padded_1),
      R_bound_1 = KSL_MULF(1.0000005f, fabsf(fine_R_01 - R_01 + fine_R_lo_1)) + R_rest_1,
      R_bound_2 = KSL_MULF(1.0000005f, fabsf(fine_R_02 - R_02 + fine_R_lo_2)) + R_rest_2,
      R_bound_3 = KSL_MULF(1.0000005f, fabsf(fine_R_10 - R_10 + fine_R_lo_3)) + R_rest_1,
      diagonal1_bound_1 = diagonal1_error_2 + KSL_MULF(2.7640693e-10f, diagonal1_padded_1),
      R_bound_4 = KSL_MULF(1.0000005f, fabsf(fine_R_12 - R_12 + fine_R_lo_4)) + R_rest_3,
      R_bound_5 = KSL_MULF(1.0000005f, fabsf(fine_R_20 - R_20 + fine_R_lo_5)) + R_rest_2,
      R_bound_6 = KSL_MULF(1.0000005f, fabsf(fine_R_21 - R_21 + fine_R_lo_6)) + R_rest_3,
      diagonal2_bound_1 = diagonal2_error_2 + KSL_MULF(2.7640693e-10f, diagonal2_padded_1);
  R->m00 = diagonal0;
  R->m01 = R_01;
  R->m02 = R_02;
  R->m10 = R_10;
  R->m11 = diagonal1;
  R->m12 = R_12;
  R->m20 = R_20;
  R->m21 = R_21;
  R->m22 = diagonal2;
  R_bound->m00 = diagonal0_bound_1;
  R_bound->m01 = R_bound_1;
  R_bound->m02 = R_bound_2;
  R_bound->m10 = R_bound_3;
  R_bound->m11 = diagonal1_bound_1;
  R_bound->m12 = R_bound_4;
  R_bound->m20 = R_bound_5;
  R_bound->m21 = R_bound_6;
  R_bound->m22 = diagonal2_bound_1;
}

/* R = J_r(v)^-1 = I + v~/2 + (1 - θ/2 cot θ/2)/θ^2 v~^2, θ = |v|; singular at multiples of 2π
     except 0; |error of R| <= R_bound unless inf or NaN.
   v: vector; R, R_bound: rotation or other 3×3 matrix.
   390 mul, 705 add, 20 product error, 34 product rest, 23 div, 3 sqrt, 93 abs, 23 less, 1 equal,
     47 select. */
static inline void ksl_SO3_rightJacobianInversef_certified(const ksl_vec3f_t *v, ksl_mat3x3f_t *R,
    ksl_mat3x3f_t *R_bound) {
  const float size_0 = fabsf(v->x), size_1 = fabsf(v->y), size_2 = fabsf(v->z);
  const float sizes = size_0 + size_1 + size_2;
  const float grid = KSL_MULF(sizes, 8192.0f);
  const float shifted_0 = v->x + grid, shifted_1 = v->y + grid, shifted_2 = v->z + grid;
  const float high_0 = shifted_0 - grid, high_1 = shifted_1 - grid, high_2 = shifted_2 - grid;
  const float low_0 = v->x - high_0, low_1 = v->y - high_1, low_2 = v->z - high_2;
  const float sum_0 = v->x + high_0, sum_1 = v->y + high_1, sum_2 = v->z + high_2;
  const float squares = KSL_MULF(high_0, high_0) + KSL_MULF(high_1, high_1)
          + KSL_MULF(high_2, high_2);
  const float cross = KSL_MULF(low_0, sum_0) + KSL_MULF(low_1, sum_1) + KSL_MULF(low_2, sum_2);
  const float x = squares + cross;
  const float theta_a = sqrtf(x), theta = x < 1.0f ? 1.0f : theta_a;
  const float theta_shifted = grid + theta;
  const float theta_high = theta_shifted - grid;
  const float theta_low = theta - theta_high;
  const float theta_sum = theta + theta_high;
  const float cross_rest = cross - KSL_MULF(theta_low, theta_sum);
  const float exact = squares - KSL_MULF(theta_high, theta_high);
  const float residual = cross_rest + exact;
  const float small = KSL_MULF(0.5f, residual) / theta;
  const float delta = fabsf(small) < 0.0078125f ? small : 0.0f;
  float far_cosine_a; const float far_sine_a = ksl_sincosf(theta, &far_cosine_a);
  const float far_sine = x < 1.0f ? 1.0f : far_sine_a;
  const float far_cosine = x < 1.0f ? 0.0f : far_cosine_a;
  const float sine = KSL_MULF(delta, far_cosine) + far_sine;
  const float cosine = far_cosine - KSL_MULF(delta, far_sine);
  const float above_a = cosine + 1.0f, above = cosine < 0.0f ? sine : above_a;
  const float below_a = 1.0f - cosine, below = cosine < 0.0f ? below_a : sine;
  const float cotangent = above / below;
  const float half_cotangent = KSL_MULF(KSL_MULF(0.5f, theta), cotangent);
  const float b_rest = 1.0f - half_cotangent;
  const float b_divisor = x < 4.0f ? 4.0f : x;
  const float closed_b = b_rest / b_divisor;
  const float b_h = KSL_MULF(x, KSL_MULF(x, KSL_MULF(x, KSL_MULF(1.4551725e-27f, x)
          + 5.744791e-26f) + 2.2679524e-24f) + 8.9535176e-23f) + 3.534707e-21f,
      b_q = KSL_MULF(x, KSL_MULF(x, KSL_MULF(x, KSL_MULF(x, KSL_MULF(x, b_h) + 1.3954465e-19f)
          + 5.509003e-18f) + 2.1748687e-16f) + 8.586062e-15f),
      b_z = KSL_MULF(x, KSL_MULF(x, KSL_MULF(x, KSL_MULF(x, b_q + 3.3896803e-13f) + 1.3382536e-11f)
          + 5.2841903e-10f) + 2.0876756e-08f) + 8.267196e-07f,
      b_af = KSL_MULF(x, KSL_MULF(x, KSL_MULF(x, b_z) + 3.3068784e-05f) + 0.0013888889f)
          + 0.083333336f, b = x < 4.0f ? b_af : closed_b;
  const float b_across_b = 1.0f - KSL_MULF(x, b), b_across = x < 4.0f ? b_across_b : half_cotangent;
  const float beta_v_0 = KSL_MULF(v->x, b);
  const float beta_v_1 = KSL_MULF(v->y, b);
  const float beta_v_2 = KSL_MULF(v->z, b);
  const float m_0 = KSL_MULF(v->x, beta_v_0);
  const float m_1 = KSL_MULF(v->y, beta_v_1);
  const float m_2 = KSL_MULF(v->z, beta_v_2);
  const float m_3 = KSL_MULF(v->y, beta_v_0);
  const float m_4 = KSL_MULF(v->z, beta_v_0);
  const float m_5 = KSL_MULF(v->z, beta_v_1);
  const float others_0 = m_1 + m_2;
  const float others_1 = m_0 + m_2;
  const float others_2 = m_0 + m_1;
  const float diagonal0a = 1.0f - others_0, diagonal0b = b_across + m_0,
      diagonal0 = m_0 < others_0 ? diagonal0b : diagonal0a;
  const float diagonal1a = 1.0f - others_1, diagonal1b = b_across + m_1,
      diagonal1 = m_1 < others_1 ? diagonal1b : diagonal1a;
  const float diagonal2a = 1.0f - others_2, diagonal2b = b_across + m_2,
      diagonal2 = m_2 < others_2 ? diagonal2b : diagonal2a;
  const float alpha_v_0 = KSL_MULF(0.5f, v->x), alpha_v_1 = KSL_MULF(0.5f, v->y),
      alpha_v_2 = KSL_MULF(0.5f, v->z);
  const float R_01 = m_3 - alpha_v_2;
  const float R_02 = m_4 + alpha_v_1;
  const float R_10 = m_3 + alpha_v_2;
  const float R_12 = m_5 - alpha_v_0;
  const float R_20 = m_4 - alpha_v_1;
  const float R_21 = m_5 + alpha_v_0;
  const float halved_0 = KSL_MULF(0.5f, v->x), halved_size_1 = fabsf(v->x),
      halved_size_2 = KSL_MULF(0.5f, halved_size_1);
  const float halved_1 = KSL_MULF(0.5f, v->y), halved_size_3 = fabsf(v->y),
      halved_size_4 = KSL_MULF(0.5f, halved_size_3);
  const float halved_2 = KSL_MULF(0.5f, v->z), halved_size_5 = fabsf(v->z),
      halved_size_6 = KSL_MULF(0.5f, halved_size_5);
  const float y_a = KSL_MULF(halved_0, halved_0), y_a_padded_1 = 3.3087225e-24f + halved_size_2,
      y_b = KSL_MULF(halved_1, halved_1), y_b_padded_1 = 3.3087225e-24f + halved_size_4,
      y_c = y_a + y_b, y_c_right_1 = y_c - y_a, y_d = KSL_MULF(halved_2, halved_2),
      y_d_padded_1 = 3.3087225e-24f + halved_size_6, y = y_c + y_d, y_right_1 = y - y_c,
      y_c_lo = ksl_product_restf(halved_0, halved_0, y_a, y_c - y_c_right_1)
          + ksl_product_restf(halved_1, halved_1, y_b, y_c_right_1),
      y_lo = y_c - (y - y_right_1) + ksl_product_restf(halved_2, halved_2, y_d, y_right_1) + y_c_lo,
      y_size_1 = KSL_MULF(y_a_padded_1, y_a_padded_1) + KSL_MULF(y_b_padded_1, y_b_padded_1)
          + KSL_MULF(y_d_padded_1, y_d_padded_1);
  const float half_angle = sqrtf(y), half_angle_product_1 = KSL_MULF(half_angle, half_angle),
      half_angle_twice_1 = half_angle + half_angle,
      half_angle_residual_1 = y - half_angle_product_1
          - ksl_product_errorf(half_angle, half_angle, half_angle_product_1) + y_lo,
      half_angle_lo = half_angle_residual_1 / (half_angle == 0.0f ? 1.0f : half_angle_twice_1),
      half_angle_padded_1 = 3.3087225e-24f + y_size_1,
      half_angle_bound_1 = fabsf(y_lo) + KSL_MULF(7.2120885e-13f, half_angle_padded_1),
      half_angle_reach_1 = fabsf(y) + KSL_MULF(262144.0f, half_angle_bound_1),
      half_angle_size_4 = KSL_MULF(half_angle_reach_1, half_angle_padded_1 / half_angle / y),
      half_angle_size_6 = fabsf(half_angle_lo),
      half_angle_size_8 = KSL_MULF(8.907313e+11f, sqrtf(half_angle_bound_1) + half_angle_size_6),
      half_angle_size_12 = half_angle
          + (KSL_MULF(4.0f, half_angle_bound_1) < y ? half_angle_size_4 : half_angle_size_8);
  float c; const float fine_sine = ksl_sincosf(half_angle, &c);
  float c_own_error_1; const float fine_sine_own_error_1 = ksl_sincos_errorf(half_angle, fine_sine,
      c, &c_own_error_1);
  const float fine_sine_half_1 = KSL_MULF(half_angle_lo, 0.5f);
  float fine_sine_half_cos_1; const float fine_sine_half_sin_1 = ksl_sincosf(fine_sine_half_1,
      &fine_sine_half_cos_1);
  const float fine_sine_twice_1 = fine_sine_half_sin_1 + fine_sine_half_sin_1,
      fine_sine_padded_1 = 3.3087225e-24f + half_angle_size_12,
      fine_sine_size_1 = 1.0f + fine_sine_padded_1;
  const float c_lo = c_own_error_1
          - KSL_MULF(KSL_MULF(fine_sine_half_cos_1, fine_sine)
          + KSL_MULF(fine_sine_half_sin_1, c), fine_sine_twice_1);
  const float sinc_divisor = half_angle < 1.4901161e-08f ? 1.4901161e-08f : half_angle,
      sinc_divisor_lo = half_angle < 1.4901161e-08f ? 0.0f : half_angle_lo,
      sinc_divisor_bound_1 = half_angle_size_6 + KSL_MULF(1.2221551e-12f, fine_sine_padded_1),
      sinc_divisor_size_3 = fabsf(half_angle - 1.4901161e-08f),
      sinc_divisor_size_7 = sinc_divisor_bound_1 + fabsf(1.4901161e-08f - half_angle),
      sinc_divisor_size_9 = KSL_MULF(3.1414265e+11f, sinc_divisor_bound_1 < sinc_divisor_size_3
          ? 0.0f : sinc_divisor_size_7);
  const float sinc_quotient = fine_sine / sinc_divisor,
      sinc_quotient_product_1 = KSL_MULF(sinc_quotient, sinc_divisor);
  const float fine_sine_lo = fine_sine_own_error_1
          + KSL_MULF(KSL_MULF(fine_sine_half_cos_1, c)
          - KSL_MULF(fine_sine_half_sin_1, fine_sine), fine_sine_twice_1);
  const float sinc_quotient_exact_1 = fine_sine - sinc_quotient_product_1
          - ksl_product_errorf(sinc_quotient, sinc_divisor, sinc_quotient_product_1),
      sinc_quotient_lo = (sinc_quotient_exact_1 + fine_sine_lo
          - KSL_MULF(sinc_quotient, sinc_divisor_lo)) / sinc_divisor,
      sinc_quotient_padded_1 = 3.3087225e-24f + fine_sine_size_1,
      sinc_quotient_padded_2 = 3.3087225e-24f
          + ((half_angle < 1.4901161e-08f ? 1.4901161e-08f : half_angle_size_12)
          + sinc_divisor_size_9), sinc_quotient_size_1 = fabsf(sinc_quotient),
      sinc_quotient_size_2 = fabsf(sinc_divisor),
      sinc_quotient_bound_1 = fabsf(sinc_divisor_lo)
          + KSL_MULF(3.2827582e-12f, sinc_quotient_padded_2),
      sinc_quotient_size_7 = KSL_MULF(4.0f, sinc_quotient_bound_1) < sinc_quotient_size_2
          ? sinc_quotient_size_2 : 0.0f,
      sinc_quotient_size_8 = (sinc_quotient_padded_1
          + KSL_MULF(sinc_quotient_padded_2, sinc_quotient_size_1)) / sinc_quotient_size_7,
      sinc_quotient_size_10 = KSL_MULF(sinc_quotient_size_2
          + KSL_MULF(262144.0f, sinc_quotient_bound_1), sinc_quotient_size_8)
          / sinc_quotient_size_2,
      sinc_quotient_size_11 = sinc_quotient_size_1 + sinc_quotient_size_10;
  const float sinc_a = KSL_MULF(0.16666667f, y), sinc_b = 1.0f - sinc_a,
      sinc_b_right_1 = 1.0f - sinc_b,
      sinc_b_lo1_1 = 1.0f - (sinc_b + sinc_b_right_1)
          - ksl_product_restf(0.16666667f, y, sinc_a, sinc_b_right_1),
      sinc_b_lo = sinc_b_lo1_1 - (KSL_MULF(-4.967054e-09f, y) + KSL_MULF(0.16666667f, y_lo)),
      sinc_b_size_1 = 1.0f + KSL_MULF(0.16666669f, y_size_1),
      sinc = half_angle < 1.4901161e-08f ? sinc_b : sinc_quotient,
      sinc_lo = half_angle < 1.4901161e-08f ? sinc_b_lo : sinc_quotient_lo,
      sinc_size_4 = fabsf(sinc_b_lo) + KSL_MULF(2.3406937e-10f, 3.3087225e-24f + sinc_b_size_1)
          + fabsf(sinc_b - sinc_quotient),
      sinc_size_5 = fabsf(sinc_quotient_lo)
          + KSL_MULF(5.43103e-12f, 3.3087225e-24f + sinc_quotient_size_11) + sinc_size_4,
      sinc_size_7 = KSL_MULF(4.276409e+09f, sinc_divisor_bound_1 < sinc_divisor_size_3 ? 0.0f
          : sinc_size_5),
      sinc_size_8 = (half_angle < 1.4901161e-08f ? sinc_b_size_1 : sinc_quotient_size_11)
          + sinc_size_7;
  const float series_phi_a = KSL_MULF(5.107725e-32f, y),
      series_phi_b = 4.1168266e-29f - series_phi_a,
      series_phi_b_right_1 = 4.1168266e-29f - series_phi_b,
      series_phi_b_lo1_1 = 4.1168266e-29f - (series_phi_b + series_phi_b_right_1)
          - ksl_product_restf(5.107725e-32f, y, series_phi_a, series_phi_b_right_1),
      series_phi_b_lo = series_phi_b_lo1_1
          - (KSL_MULF(3.51736e-40f, y) + KSL_MULF(5.107725e-32f, y_lo)) + -1.3151732e-36f,
      series_phi_c = KSL_MULF(y, series_phi_b),
      series_phi_c_padded_1 = 3.3087225e-24f
          + (4.1168266e-29f + KSL_MULF(2.3741903e-25f, y_size_1)),
      series_phi_c_reach_1 = fabsf(series_phi_b)
          + KSL_MULF(262144.0f, fabsf(series_phi_b_lo)
          + KSL_MULF(2.3406937e-10f, series_phi_c_padded_1)),
      series_phi_d = series_phi_c - 2.8653114e-26f,
      series_phi_d_right_1 = series_phi_c - series_phi_d,
      series_phi_d_lo1_1 = ksl_product_restf(y, series_phi_b, series_phi_c, series_phi_d
          + series_phi_d_right_1) - (2.8653114e-26f - series_phi_d_right_1),
      series_phi_d_lo = series_phi_d_lo1_1 - -1.27647235e-33f
          + (KSL_MULF(y_lo, series_phi_b) + KSL_MULF(y, series_phi_b_lo)),
      series_phi_e = KSL_MULF(y, series_phi_d),
      series_phi_d_size_1 = 2.8653114e-26f
          + (KSL_MULF(half_angle_reach_1, series_phi_c_padded_1)
          + KSL_MULF(half_angle_padded_1, series_phi_c_reach_1)),
      series_phi_e_padded_1 = 3.3087225e-24f + series_phi_d_size_1,
      series_phi_e_reach_1 = fabsf(series_phi_d)
          + KSL_MULF(262144.0f, fabsf(series_phi_d_lo)
          + KSL_MULF(2.3574281e-10f, series_phi_e_padded_1)),
      series_phi_f = series_phi_e + 1.7019949e-23f,
      series_phi_f_right_1 = series_phi_f - series_phi_e,
      series_phi_f_lo1_1 = ksl_product_restf(y, series_phi_d, series_phi_e, series_phi_f
          - series_phi_f_right_1) + (1.7019949e-23f - series_phi_f_right_1),
      series_phi_f_lo = series_phi_f_lo1_1 + 1.9703667e-31f
          + (KSL_MULF(y_lo, series_phi_d) + KSL_MULF(y, series_phi_d_lo)),
      series_phi_g = KSL_MULF(y, series_phi_f),
      series_phi_f_size_1 = 1.7019949e-23f
          + (KSL_MULF(half_angle_reach_1, series_phi_e_padded_1)
          + KSL_MULF(half_angle_padded_1, series_phi_e_reach_1)),
      series_phi_g_padded_1 = 3.3087225e-24f + series_phi_f_size_1,
      series_phi_g_reach_1 = fabsf(series_phi_f)
          + KSL_MULF(262144.0f, fabsf(series_phi_f_lo)
          + KSL_MULF(2.374802e-10f, series_phi_g_padded_1)),
      series_phi_h = series_phi_g - 8.509974e-21f,
      series_phi_h_right_1 = series_phi_g - series_phi_h,
      series_phi_h_lo1_1 = ksl_product_restf(y, series_phi_f, series_phi_g, series_phi_h
          + series_phi_h_right_1) - (8.509974e-21f - series_phi_h_right_1),
      series_phi_h_lo = series_phi_h_lo1_1 - 1.016591e-29f
          + (KSL_MULF(y_lo, series_phi_f) + KSL_MULF(y, series_phi_f_lo)),
      series_phi_i = KSL_MULF(y, series_phi_h),
      series_phi_h_size_1 = 8.509974e-21f
          + (KSL_MULF(half_angle_reach_1, series_phi_g_padded_1)
          + KSL_MULF(half_angle_padded_1, series_phi_g_reach_1)),
      series_phi_i_padded_1 = 3.3087225e-24f + series_phi_h_size_1,
      series_phi_i_reach_1 = fabsf(series_phi_h)
          + KSL_MULF(262144.0f, fabsf(series_phi_h_lo)
          + KSL_MULF(2.392816e-10f, series_phi_i_padded_1)),
      series_phi_j = series_phi_i + 3.5231293e-18f,
      series_phi_j_right_1 = series_phi_j - series_phi_i,
      series_phi_j_lo1_1 = ksl_product_restf(y, series_phi_h, series_phi_i, series_phi_j
          - series_phi_j_right_1) + (3.5231293e-18f - series_phi_j_right_1),
      series_phi_j_lo = series_phi_j_lo1_1 + 7.2063343e-26f
          + (KSL_MULF(y_lo, series_phi_h) + KSL_MULF(y, series_phi_h_lo)),
      series_phi_k = KSL_MULF(y, series_phi_j),
      series_phi_j_size_1 = 3.5231293e-18f
          + (KSL_MULF(half_angle_reach_1, series_phi_i_padded_1)
          + KSL_MULF(half_angle_padded_1, series_phi_i_reach_1)),
      series_phi_k_padded_1 = 3.3087225e-24f + series_phi_j_size_1,
      series_phi_k_reach_1 = fabsf(series_phi_j)
          + KSL_MULF(262144.0f, fabsf(series_phi_j_lo)
          + KSL_MULF(2.41147e-10f, series_phi_k_padded_1)),
      series_phi_l = series_phi_k - 1.1837714e-15f,
      series_phi_l_right_1 = series_phi_k - series_phi_l,
      series_phi_l_lo1_1 = ksl_product_restf(y, series_phi_j, series_phi_k, series_phi_l
          + series_phi_l_right_1) - (1.1837714e-15f - series_phi_l_right_1),
      series_phi_l_lo = series_phi_l_lo1_1 - 5.0683064e-23f
          + (KSL_MULF(y_lo, series_phi_j) + KSL_MULF(y, series_phi_j_lo)),
      series_phi_m = KSL_MULF(y, series_phi_l),
      series_phi_l_size_1 = 1.1837714e-15f
          + (KSL_MULF(half_angle_reach_1, series_phi_k_padded_1)
          + KSL_MULF(half_angle_padded_1, series_phi_k_reach_1)),
      series_phi_m_padded_1 = 3.3087225e-24f + series_phi_l_size_1,
      series_phi_m_reach_1 = fabsf(series_phi_l)
          + KSL_MULF(262144.0f, fabsf(series_phi_l_lo)
          + KSL_MULF(2.4307634e-10f, series_phi_m_padded_1)),
      series_phi_n = series_phi_m + 3.148832e-13f,
      series_phi_n_right_1 = series_phi_n - series_phi_m,
      series_phi_n_lo1_1 = ksl_product_restf(y, series_phi_l, series_phi_m, series_phi_n
          - series_phi_n_right_1) + (3.148832e-13f - series_phi_n_right_1),
      series_phi_n_lo = series_phi_n_lo1_1 + 1.834992e-21f
          + (KSL_MULF(y_lo, series_phi_l) + KSL_MULF(y, series_phi_l_lo)),
      series_phi_o = KSL_MULF(y, series_phi_n),
      series_phi_n_size_1 = 3.148832e-13f
          + (KSL_MULF(half_angle_reach_1, series_phi_m_padded_1)
          + KSL_MULF(half_angle_padded_1, series_phi_m_reach_1)),
      series_phi_o_padded_1 = 3.3087225e-24f + series_phi_n_size_1,
      series_phi_o_reach_1 = fabsf(series_phi_n)
          + KSL_MULF(262144.0f, fabsf(series_phi_n_lo)
          + KSL_MULF(2.4506966e-10f, series_phi_o_padded_1)),
      series_phi_p = series_phi_o - 6.423617e-11f,
      series_phi_p_right_1 = series_phi_o - series_phi_p,
      series_phi_p_lo1_1 = ksl_product_restf(y, series_phi_n, series_phi_o, series_phi_p
          + series_phi_p_right_1) - (6.423617e-11f - series_phi_p_right_1),
      series_phi_p_lo = series_phi_p_lo1_1 - 3.4101044e-18f
          + (KSL_MULF(y_lo, series_phi_n) + KSL_MULF(y, series_phi_n_lo)),
      series_phi_q = KSL_MULF(y, series_phi_p),
      series_phi_p_size_1 = 6.423617e-11f
          + (KSL_MULF(half_angle_reach_1, series_phi_o_padded_1)
          + KSL_MULF(half_angle_padded_1, series_phi_o_reach_1)),
      series_phi_q_padded_1 = 3.3087225e-24f + series_phi_p_size_1,
      series_phi_q_reach_1 = fabsf(series_phi_p)
          + KSL_MULF(262144.0f, fabsf(series_phi_p_lo)
          + KSL_MULF(2.4712699e-10f, series_phi_q_padded_1)),
      series_phi_r = series_phi_q + 9.635427e-09f,
      series_phi_r_right_1 = series_phi_r - series_phi_q,
      series_phi_r_lo1_1 = ksl_product_restf(y, series_phi_p, series_phi_q, series_phi_r
          - series_phi_r_right_1) + (9.635427e-09f - series_phi_r_right_1),
      series_phi_r_lo = series_phi_r_lo1_1 + -3.7666274e-16f
          + (KSL_MULF(y_lo, series_phi_p) + KSL_MULF(y, series_phi_p_lo)),
      series_phi_s = KSL_MULF(y, series_phi_r),
      series_phi_r_size_1 = 9.635427e-09f
          + (KSL_MULF(half_angle_reach_1, series_phi_q_padded_1)
          + KSL_MULF(half_angle_padded_1, series_phi_q_reach_1)),
      series_phi_s_padded_1 = 3.3087225e-24f + series_phi_r_size_1,
      series_phi_s_reach_1 = fabsf(series_phi_r)
          + KSL_MULF(262144.0f, fabsf(series_phi_r_lo)
          + KSL_MULF(2.4924826e-10f, series_phi_s_padded_1)),
      series_phi_t = series_phi_s - 1.0020843e-06f,
      series_phi_t_right_1 = series_phi_s - series_phi_t,
      series_phi_t_lo1_1 = ksl_product_restf(y, series_phi_r, series_phi_s, series_phi_t
          + series_phi_t_right_1) - (1.0020843e-06f - series_phi_t_right_1),
      series_phi_t_lo = series_phi_t_lo1_1 - 3.4596379e-15f
          + (KSL_MULF(y_lo, series_phi_r) + KSL_MULF(y, series_phi_r_lo)),
      series_phi_u = KSL_MULF(y, series_phi_t),
      series_phi_t_size_1 = 1.0020843e-06f
          + (KSL_MULF(half_angle_reach_1, series_phi_s_padded_1)
          + KSL_MULF(half_angle_padded_1, series_phi_s_reach_1)),
      series_phi_u_padded_1 = 3.3087225e-24f + series_phi_t_size_1,
      series_phi_u_reach_1 = fabsf(series_phi_t)
          + KSL_MULF(262144.0f, fabsf(series_phi_t_lo)
          + KSL_MULF(2.5143354e-10f, series_phi_u_padded_1)),
      series_phi_v = series_phi_u + 6.613757e-05f,
      series_phi_v_right_1 = series_phi_v - series_phi_u,
      series_phi_v_lo1_1 = ksl_product_restf(y, series_phi_t, series_phi_u, series_phi_v
          - series_phi_v_right_1) + (6.613757e-05f - series_phi_v_right_1),
      series_phi_v_lo = series_phi_v_lo1_1 + -9.0853226e-13f
          + (KSL_MULF(y_lo, series_phi_t) + KSL_MULF(y, series_phi_t_lo)),
      series_phi_w = KSL_MULF(y, series_phi_v),
      series_phi_v_size_1 = 6.613757e-05f
          + (KSL_MULF(half_angle_reach_1, series_phi_u_padded_1)
          + KSL_MULF(half_angle_padded_1, series_phi_u_reach_1)),
      series_phi_w_padded_1 = 3.3087225e-24f + series_phi_v_size_1,
      series_phi_w_reach_1 = fabsf(series_phi_v)
          + KSL_MULF(262144.0f, fabsf(series_phi_v_lo)
          + KSL_MULF(2.5368282e-10f, series_phi_w_padded_1)),
      series_phi_x = series_phi_w - 0.0023809525f,
      series_phi_x_right_1 = series_phi_w - series_phi_x,
      series_phi_x_lo1_1 = ksl_product_restf(y, series_phi_v, series_phi_w, series_phi_x
          + series_phi_x_right_1) - (0.0023809525f - series_phi_x_right_1),
      series_phi_x_lo = series_phi_x_lo1_1 - -9.0914824e-11f
          + (KSL_MULF(y_lo, series_phi_v) + KSL_MULF(y, series_phi_v_lo)),
      series_phi_y = KSL_MULF(y, series_phi_x),
      series_phi_x_size_1 = 0.0023809525f
          + (KSL_MULF(half_angle_reach_1, series_phi_w_padded_1)
          + KSL_MULF(half_angle_padded_1, series_phi_w_reach_1)),
      series_phi_y_padded_1 = 3.3087225e-24f + series_phi_x_size_1,
      series_phi_y_reach_1 = fabsf(series_phi_x)
          + KSL_MULF(262144.0f, fabsf(series_phi_x_lo)
          + KSL_MULF(2.5599609e-10f, series_phi_y_padded_1)),
      series_phi = series_phi_y + 0.033333335f, series_phi_right_1 = series_phi - series_phi_y,
      series_phi_lo1_1 = ksl_product_restf(y, series_phi_x, series_phi_y, series_phi
          - series_phi_right_1) + (0.033333335f - series_phi_right_1),
      series_phi_lo = series_phi_lo1_1 + -1.7384688e-09f
          + (KSL_MULF(y_lo, series_phi_x) + KSL_MULF(y, series_phi_x_lo));
  const float f_more_a = KSL_MULF(2.0f, y), f_more_a_cross2_1 = KSL_MULF(2.0f, y_lo),
      f_more = KSL_MULF(f_more_a, series_phi),
      f_more_padded_1 = 3.3087225e-24f + KSL_MULF(2.0f, y_size_1);
  const float series_phi_size_1 = 0.033333335f
          + (KSL_MULF(half_angle_reach_1, series_phi_y_padded_1)
          + KSL_MULF(half_angle_padded_1, series_phi_y_reach_1));
  const float f_more_padded_2 = 3.3087225e-24f + series_phi_size_1,
      f_more_size_2 = KSL_MULF(f_more_padded_2, fabsf(f_more_a)
          + KSL_MULF(262144.0f, fabsf(f_more_a_cross2_1)
          + KSL_MULF(8.100306e-13f, f_more_padded_1))),
      f_more_size_4 = KSL_MULF(f_more_padded_1, fabsf(series_phi)
          + KSL_MULF(262144.0f, fabsf(series_phi_lo) + KSL_MULF(2.5837332e-10f, f_more_padded_2)));
  const float near_f_a = KSL_MULF(0.33333334f, sinc), near_f_b = KSL_MULF(0.33333334f, f_more),
      f_more_lo = ksl_product_errorf(f_more_a, series_phi, f_more)
          + (KSL_MULF(f_more_a_cross2_1, series_phi) + KSL_MULF(f_more_a, series_phi_lo)),
      near_f = near_f_a + near_f_b, near_f_right_1 = near_f - near_f_a,
      near_f_b_cross_1 = KSL_MULF(-9.934108e-09f, f_more) + KSL_MULF(0.33333334f, f_more_lo),
      near_f_left_rest_1 = ksl_product_restf(0.33333334f, sinc, near_f_a, near_f - near_f_right_1),
      near_f_lo1_1 = near_f_left_rest_1
          + ksl_product_restf(0.33333334f, f_more, near_f_b, near_f_right_1),
      near_f_lo = near_f_lo1_1
          + (KSL_MULF(-9.934108e-09f, sinc) + KSL_MULF(0.33333334f, sinc_lo) + near_f_b_cross_1),
      near_f_size_1 = KSL_MULF(0.33333334f, sinc_size_8)
          + KSL_MULF(0.33333334f, f_more_size_2 + f_more_size_4);
  const float f_rest = sinc - c, f_rest_right_1 = sinc - f_rest;
  const float fine_x = KSL_MULF(4.0f, y);
  const float far_y = fine_x < 4.0f ? 1.0f : y, far_y_lo = fine_x < 4.0f ? 0.0f : y_lo,
      far_y_bound_1 = fabsf(KSL_MULF(4.0f, y_lo))
          + KSL_MULF(8.100306e-13f, 3.3087225e-24f + KSL_MULF(4.0f, y_size_1)),
      far_y_size_3 = fabsf(fine_x - 4.0f), far_y_size_7 = fabsf(1.0f - y) + half_angle_bound_1;
  const float closed_f = f_rest / far_y, closed_f_product_1 = KSL_MULF(closed_f, far_y),
      closed_f_exact_1 = f_rest - closed_f_product_1
          - ksl_product_errorf(closed_f, far_y, closed_f_product_1),
      closed_f_lo = (closed_f_exact_1
          + (sinc - (f_rest + f_rest_right_1) - (c - f_rest_right_1) - c_lo + sinc_lo)
          - KSL_MULF(closed_f, far_y_lo)) / far_y;
  const float far_y_size_10 = (fine_x < 4.0f ? 1.0f : y_size_1)
          + KSL_MULF(2.1990035e+11f, far_y_bound_1 < far_y_size_3 ? 0.0f : far_y_size_7);
  const float closed_f_padded_2 = 3.3087225e-24f + far_y_size_10, closed_f_size_1 = fabsf(closed_f),
      closed_f_size_2 = fabsf(far_y),
      closed_f_bound_1 = fabsf(far_y_lo) + KSL_MULF(4.6896445e-12f, closed_f_padded_2),
      closed_f_size_4 = 3.3087225e-24f + (fine_sine_size_1 + sinc_size_8)
          + KSL_MULF(closed_f_padded_2, closed_f_size_1),
      closed_f_size_8 = closed_f_size_4
          / (KSL_MULF(4.0f, closed_f_bound_1) < closed_f_size_2 ? closed_f_size_2 : 0.0f),
      closed_f_size_11 = closed_f_size_1
          + KSL_MULF(closed_f_size_2 + KSL_MULF(262144.0f, closed_f_bound_1), closed_f_size_8)
          / closed_f_size_2;
  const float f = fine_x < 4.0f ? near_f : closed_f,
      f_size_4 = fabsf(near_f_lo) + KSL_MULF(2.6163277e-10f, 3.3087225e-24f + near_f_size_1)
          + fabsf(near_f - closed_f),
      f_size_5 = fabsf(closed_f_lo) + KSL_MULF(2.3766553e-10f, 3.3087225e-24f + closed_f_size_11)
          + f_size_4;
  const float four_k = KSL_MULF(4.0f, sinc), four_k_cross2_1 = KSL_MULF(4.0f, sinc_lo);
  const float fine_b = f / four_k, fine_b_product_1 = KSL_MULF(fine_b, four_k),
      fine_b_numerator_1 = f - fine_b_product_1
          - ksl_product_errorf(fine_b, four_k, fine_b_product_1)
          + (fine_x < 4.0f ? near_f_lo : closed_f_lo),
      fine_b_lo = (fine_b_numerator_1 - KSL_MULF(fine_b, four_k_cross2_1)) / four_k;
  const float f_size_8 = (fine_x < 4.0f ? near_f_size_1 : closed_f_size_11)
          + KSL_MULF(3.8371738e+09f, far_y_bound_1 < far_y_size_3 ? 0.0f : f_size_5);
  const float fine_b_padded_2 = 3.3087225e-24f + KSL_MULF(4.0f, sinc_size_8),
      fine_b_size_1 = fabsf(fine_b), fine_b_size_2 = fabsf(four_k),
      fine_b_bound_1 = fabsf(four_k_cross2_1) + KSL_MULF(2.3419117e-10f, fine_b_padded_2),
      fine_b_size_7 = KSL_MULF(4.0f, fine_b_bound_1) < fine_b_size_2 ? fine_b_size_2 : 0.0f,
      fine_b_size_8 = (3.3087225e-24f + f_size_8 + KSL_MULF(fine_b_padded_2, fine_b_size_1))
          / fine_b_size_7;
  const float fine_b_across = c / sinc, fine_b_across_product_1 = KSL_MULF(fine_b_across, sinc),
      fine_b_across_numerator_1 = c - fine_b_across_product_1
          - ksl_product_errorf(fine_b_across, sinc, fine_b_across_product_1) + c_lo,
      fine_b_across_lo = (fine_b_across_numerator_1 - KSL_MULF(fine_b_across, sinc_lo)) / sinc,
      fine_b_across_padded_1 = 3.3087225e-24f + sinc_size_8,
      fine_b_across_size_1 = fabsf(fine_b_across), fine_b_across_size_2 = fabsf(sinc),
      fine_b_across_bound_1 = fabsf(sinc_lo) + KSL_MULF(2.3406946e-10f, fine_b_across_padded_1),
      fine_b_across_size_7 = KSL_MULF(4.0f, fine_b_across_bound_1) < fine_b_across_size_2
          ? fine_b_across_size_2 : 0.0f,
      fine_b_across_size_8 = (KSL_MULF(fine_b_across_padded_1, fine_b_across_size_1)
          + sinc_quotient_padded_1) / fine_b_across_size_7,
      fine_b_across_size_10 = KSL_MULF(fine_b_across_size_2
          + KSL_MULF(262144.0f, fine_b_across_bound_1), fine_b_across_size_8)
          / fine_b_across_size_2,
      fine_b_across_size_11 = fine_b_across_size_1 + fine_b_across_size_10;
  const float fine_beta_v_0 = KSL_MULF(v->x, fine_b),
      fine_beta_v_padded_1 = 3.3087225e-24f
          + (fine_b_size_1
          + KSL_MULF(fine_b_size_2 + KSL_MULF(262144.0f, fine_b_bound_1), fine_b_size_8)
          / fine_b_size_2);
  const float fine_beta_v_1 = KSL_MULF(v->y, fine_b);
  const float fine_beta_v_2 = KSL_MULF(v->z, fine_b);
  const float fine_beta_v_lo_1 = ksl_product_errorf(v->x, fine_b, fine_beta_v_0)
          + KSL_MULF(v->x, fine_b_lo), fine_m_0 = KSL_MULF(v->x, fine_beta_v_0),
      fine_m_cross2_1 = KSL_MULF(v->x, fine_beta_v_lo_1),
      fine_m_padded_1 = 3.3087225e-24f + KSL_MULF(fine_beta_v_padded_1, halved_size_1),
      fine_m_size_1 = KSL_MULF(fine_m_padded_1, halved_size_1);
  const float fine_beta_v_lo_2 = ksl_product_errorf(v->y, fine_b, fine_beta_v_1)
          + KSL_MULF(v->y, fine_b_lo), fine_m_1 = KSL_MULF(v->y, fine_beta_v_1),
      fine_m_cross2_2 = KSL_MULF(v->y, fine_beta_v_lo_2),
      fine_m_padded_2 = 3.3087225e-24f + KSL_MULF(fine_beta_v_padded_1, halved_size_3),
      fine_m_size_2 = KSL_MULF(fine_m_padded_2, halved_size_3);
  const float fine_m_2 = KSL_MULF(v->z, fine_beta_v_2),
      fine_m_cross2_3 = KSL_MULF(v->z, ksl_product_errorf(v->z, fine_b, fine_beta_v_2)
          + KSL_MULF(v->z, fine_b_lo)),
      fine_m_size_3 = KSL_MULF(3.3087225e-24f
          + KSL_MULF(fine_beta_v_padded_1, halved_size_5), halved_size_5);
  const float fine_m_3 = KSL_MULF(v->y, fine_beta_v_0),
      fine_m_cross2_4 = KSL_MULF(v->y, fine_beta_v_lo_1);
  const float fine_m_4 = KSL_MULF(v->z, fine_beta_v_0),
      fine_m_cross2_5 = KSL_MULF(v->z, fine_beta_v_lo_1);
  const float fine_m_5 = KSL_MULF(v->z, fine_beta_v_1),
      fine_m_cross2_6 = KSL_MULF(v->z, fine_beta_v_lo_2);
  const float fine_others_0 = fine_m_1 + fine_m_2, fine_others_right_1 = fine_others_0 - fine_m_1,
      fine_others_left_rest_1 = ksl_product_restf(v->y, fine_beta_v_1, fine_m_1, fine_others_0
          - fine_others_right_1),
      fine_others_lo1_1 = fine_others_left_rest_1
          + ksl_product_restf(v->z, fine_beta_v_2, fine_m_2, fine_others_right_1),
      fine_others_lo_1 = fine_others_lo1_1 + (fine_m_cross2_2 + fine_m_cross2_3),
      fine_others_size_1 = fine_m_size_2 + fine_m_size_3;
  const float fine_others_1 = fine_m_0 + fine_m_2, fine_others_right_2 = fine_others_1 - fine_m_0,
      fine_others_left_rest_2 = ksl_product_restf(v->x, fine_beta_v_0, fine_m_0, fine_others_1
          - fine_others_right_2),
      fine_others_lo1_2 = fine_others_left_rest_2
          + ksl_product_restf(v->z, fine_beta_v_2, fine_m_2, fine_others_right_2),
      fine_others_lo_2 = fine_others_lo1_2 + (fine_m_cross2_1 + fine_m_cross2_3),
      fine_others_size_2 = fine_m_size_1 + fine_m_size_3;
  const float fine_others_2 = fine_m_0 + fine_m_1, fine_others_right_3 = fine_others_2 - fine_m_0,
      fine_others_left_rest_3 = ksl_product_restf(v->x, fine_beta_v_0, fine_m_0, fine_others_2
          - fine_others_right_3),
      fine_others_lo1_3 = fine_others_left_rest_3
          + ksl_product_restf(v->y, fine_beta_v_1, fine_m_1, fine_others_right_3),
      fine_others_lo_3 = fine_others_lo1_3 + (fine_m_cross2_1 + fine_m_cross2_2),
      fine_others_size_3 = fine_m_size_1 + fine_m_size_2;
  const float fine_diagonal0a = 1.0f - fine_others_0,
      fine_diagonal0a_right_1 = 1.0f - fine_diagonal0a,
      fine_diagonal0a_lo = 1.0f - (fine_diagonal0a + fine_diagonal0a_right_1)
          - (fine_others_0 - fine_diagonal0a_right_1) - fine_others_lo_1,
      fine_diagonal0a_size_1 = 1.0f + fine_others_size_1,
      fine_diagonal0b = fine_b_across + fine_m_0,
      fine_diagonal0b_right_1 = fine_diagonal0b - fine_b_across,
      fine_diagonal0b_right_rest_1 = ksl_product_restf(v->x, fine_beta_v_0, fine_m_0,
          fine_diagonal0b_right_1),
      fine_diagonal0b_lo = fine_b_across - (fine_diagonal0b - fine_diagonal0b_right_1)
          + fine_diagonal0b_right_rest_1 + fine_m_cross2_1 + fine_b_across_lo,
      fine_diagonal0b_size_1 = fine_b_across_size_11 + fine_m_size_1,
      fine_diagonal0_error_1 = fabsf(ksl_product_errorf(v->x, fine_beta_v_0, fine_m_0)
          + fine_m_cross2_1),
      fine_diagonal0_bound_2 = fabsf(fine_others_lo_1)
          + KSL_MULF(2.7533278e-10f, 3.3087225e-24f + fine_others_size_1),
      fine_diagonal0_bound_3 = fabsf(fine_diagonal0b_lo)
          + KSL_MULF(2.7533278e-10f, 3.3087225e-24f + fine_diagonal0b_size_1),
      fine_diagonal0_bound_4 = fabsf(fine_diagonal0a_lo)
          + KSL_MULF(2.7640684e-10f, 3.3087225e-24f + fine_diagonal0a_size_1),
      fine_diagonal0_size_9 = fine_diagonal0_bound_4
          + (fine_diagonal0_bound_3 + fabsf(fine_diagonal0b - fine_diagonal0a)),
      fine_diagonal0_size_2 = fine_diagonal0_error_1
          + KSL_MULF(2.7428007e-10f, 3.3087225e-24f + fine_m_size_1) + fine_diagonal0_bound_2,
      fine_diagonal0_size_11 = KSL_MULF(3.633188e+09f, fine_diagonal0_size_2
          < fabsf(fine_m_0 - fine_others_0) ? 0.0f : fine_diagonal0_size_9);
  const float fine_diagonal1a = 1.0f - fine_others_1,
      fine_diagonal1a_right_1 = 1.0f - fine_diagonal1a,
      fine_diagonal1a_lo = 1.0f - (fine_diagonal1a + fine_diagonal1a_right_1)
          - (fine_others_1 - fine_diagonal1a_right_1) - fine_others_lo_2,
      fine_diagonal1a_size_1 = 1.0f + fine_others_size_2,
      fine_diagonal1b = fine_b_across + fine_m_1,
      fine_diagonal1b_right_1 = fine_diagonal1b - fine_b_across,
      fine_diagonal1b_right_rest_1 = ksl_product_restf(v->y, fine_beta_v_1, fine_m_1,
          fine_diagonal1b_right_1),
      fine_diagonal1b_lo = fine_b_across - (fine_diagonal1b - fine_diagonal1b_right_1)
          + fine_diagonal1b_right_rest_1 + fine_m_cross2_2 + fine_b_across_lo,
      fine_diagonal1b_size_1 = fine_b_across_size_11 + fine_m_size_2,
      fine_diagonal1_error_1 = fabsf(ksl_product_errorf(v->y, fine_beta_v_1, fine_m_1)
          + fine_m_cross2_2),
      fine_diagonal1_bound_2 = fabsf(fine_others_lo_2)
          + KSL_MULF(2.7533278e-10f, 3.3087225e-24f + fine_others_size_2),
      fine_diagonal1_bound_3 = fabsf(fine_diagonal1b_lo)
          + KSL_MULF(2.7533278e-10f, 3.3087225e-24f + fine_diagonal1b_size_1),
      fine_diagonal1_bound_4 = fabsf(fine_diagonal1a_lo)
          + KSL_MULF(2.7640684e-10f, 3.3087225e-24f + fine_diagonal1a_size_1),
      fine_diagonal1_size_9 = fine_diagonal1_bound_4
          + (fine_diagonal1_bound_3 + fabsf(fine_diagonal1b - fine_diagonal1a)),
      fine_diagonal1_size_2 = fine_diagonal1_error_1
          + KSL_MULF(2.7428007e-10f, 3.3087225e-24f + fine_m_size_2) + fine_diagonal1_bound_2,
      fine_diagonal1_size_11 = KSL_MULF(3.633188e+09f, fine_diagonal1_size_2
          < fabsf(fine_m_1 - fine_others_1) ? 0.0f : fine_diagonal1_size_9);
  const float fine_diagonal2a = 1.0f - fine_others_2,
      fine_diagonal2a_right_1 = 1.0f - fine_diagonal2a,
      fine_diagonal2a_lo = 1.0f - (fine_diagonal2a + fine_diagonal2a_right_1)
          - (fine_others_2 - fine_diagonal2a_right_1) - fine_others_lo_3,
      fine_diagonal2a_size_1 = 1.0f + fine_others_size_3,
      fine_diagonal2b = fine_b_across + fine_m_2,
      fine_diagonal2b_right_1 = fine_diagonal2b - fine_b_across,
      fine_diagonal2b_right_rest_1 = ksl_product_restf(v->z, fine_beta_v_2, fine_m_2,
          fine_diagonal2b_right_1),
      fine_diagonal2b_lo = fine_b_across - (fine_diagonal2b - fine_diagonal2b_right_1)
          + fine_diagonal2b_right_rest_1 + fine_m_cross2_3 + fine_b_across_lo,
      fine_diagonal2b_size_1 = fine_b_across_size_11 + fine_m_size_3,
      fine_diagonal2_error_1 = fabsf(ksl_product_errorf(v->z, fine_beta_v_2, fine_m_2)
          + fine_m_cross2_3),
      fine_diagonal2_bound_2 = fabsf(fine_others_lo_3)
          + KSL_MULF(2.7533278e-10f, 3.3087225e-24f + fine_others_size_3),
      fine_diagonal2_bound_3 = fabsf(fine_diagonal2b_lo)
          + KSL_MULF(2.7533278e-10f, 3.3087225e-24f + fine_diagonal2b_size_1),
      fine_diagonal2_bound_4 = fabsf(fine_diagonal2a_lo)
          + KSL_MULF(2.7640684e-10f, 3.3087225e-24f + fine_diagonal2a_size_1),
      fine_diagonal2_size_9 = fine_diagonal2_bound_4
          + (fine_diagonal2_bound_3 + fabsf(fine_diagonal2b - fine_diagonal2a)),
      fine_diagonal2_size_2 = fine_diagonal2_error_1
          + KSL_MULF(2.7428007e-10f, 3.3087225e-24f + fine_m_size_3) + fine_diagonal2_bound_2,
      fine_diagonal2_size_11 = KSL_MULF(3.633188e+09f, fine_diagonal2_size_2
          < fabsf(fine_m_2 - fine_others_2) ? 0.0f : fine_diagonal2_size_9);
  const float fine_R_01 = fine_m_3 - halved_2, fine_R_right_1 = fine_m_3 - fine_R_01;
  const float fine_R_02 = halved_1 + fine_m_4, fine_R_right_2 = fine_R_02 - halved_1;
  const float fine_R_10 = halved_2 + fine_m_3, fine_R_right_3 = fine_R_10 - halved_2;
  const float fine_R_12 = fine_m_5 - halved_0, fine_R_right_4 = fine_m_5 - fine_R_12;
  const float fine_R_20 = fine_m_4 - halved_1, fine_R_right_5 = fine_m_4 - fine_R_20;
  const float fine_R_21 = halved_0 + fine_m_5, fine_R_right_6 = fine_R_21 - halved_0;
  const float diagonal0_apart_1 = (fine_m_0 < fine_others_0 ? fine_diagonal0b : fine_diagonal0a)
          - diagonal0,
      diagonal0_padded_1 = 3.3087225e-24f
          + ((fine_m_0 < fine_others_0 ? fine_diagonal0b_size_1 : fine_diagonal0a_size_1)
          + fine_diagonal0_size_11),
      diagonal0_error_2 = KSL_MULF(1.0000005f, fabsf(diagonal0_apart_1
          + (fine_m_0 < fine_others_0 ? fine_diagonal0b_lo : fine_diagonal0a_lo)));
  const float fine_R_lo_1 = ksl_product_restf(v->y, fine_beta_v_0, fine_m_3, fine_R_01
          + fine_R_right_1) - (halved_2 - fine_R_right_1) + fine_m_cross2_4;
  const float R_rest_1 = KSL_MULF(2.7533278e-10f, 3.3087225e-24f
          + (KSL_MULF(fine_m_padded_1, halved_size_3) + halved_size_6));
  const float fine_R_lo_2 = halved_1 - (fine_R_02 - fine_R_right_2)
          + ksl_product_restf(v->z, fine_beta_v_0, fine_m_4, fine_R_right_2) + fine_m_cross2_5;
  const float R_rest_2 = KSL_MULF(2.7533278e-10f, 3.3087225e-24f
          + (KSL_MULF(fine_m_padded_1, halved_size_5) + halved_size_4));
  const float fine_R_lo_3 = halved_2 - (fine_R_10 - fine_R_right_3)
          + ksl_product_restf(v->y, fine_beta_v_0, fine_m_3, fine_R_right_3) + fine_m_cross2_4;
  const float diagonal1_apart_1 = (fine_m_1 < fine_others_1 ? fine_diagonal1b : fine_diagonal1a)
          - diagonal1,
      diagonal1_padded_1 = 3.3087225e-24f
          + ((fine_m_1 < fine_others_1 ? fine_diagonal1b_size_1 : fine_diagonal1a_size_1)
          + fine_diagonal1_size_11),
      diagonal1_error_2 = KSL_MULF(1.0000005f, fabsf(diagonal1_apart_1
          + (fine_m_1 < fine_others_1 ? fine_diagonal1b_lo : fine_diagonal1a_lo)));
  const float fine_R_lo_4 = ksl_product_restf(v->z, fine_beta_v_1, fine_m_5, fine_R_12
          + fine_R_right_4) - (halved_0 - fine_R_right_4) + fine_m_cross2_6;
  const float R_rest_3 = KSL_MULF(2.7533278e-10f, 3.3087225e-24f
          + (KSL_MULF(fine_m_padded_2, halved_size_5) + halved_size_2));
  const float fine_R_lo_5 = ksl_product_restf(v->z, fine_beta_v_0, fine_m_4, fine_R_20
          + fine_R_right_5) - (halved_1 - fine_R_right_5) + fine_m_cross2_5;
  const float fine_R_lo_6 = halved_0 - (fine_R_21 - fine_R_right_6)
          + ksl_product_restf(v->z, fine_beta_v_1, fine_m_5, fine_R_right_6) + fine_m_cross2_6;
  const float diagonal2_apart_1 = (fine_m_2 < fine_others_2 ? fine_diagonal2b : fine_diagonal2a)
          - diagonal2,
      diagonal2_padded_1 = 3.3087225e-24f
          + ((fine_m_2 < fine_others_2 ? fine_diagonal2b_size_1 : fine_diagonal2a_size_1)
          + fine_diagonal2_size_11),
      diagonal2_error_2 = KSL_MULF(1.0000005f, fabsf(diagonal2_apart_1
          + (fine_m_2 < fine_others_2 ? fine_diagonal2b_lo : fine_diagonal2a_lo))),
      diagonal0_bound_1 = diagonal0_error_2 + KSL_MULF(2.7640693e-10f, diagonal0_padded_1),
      R_bound_1 = KSL_MULF(1.0000005f, fabsf(fine_R_01 - R_01 + fine_R_lo_1)) + R_rest_1,
      R_bound_2 = KSL_MULF(1.0000005f, fabsf(fine_R_02 - R_02 + fine_R_lo_2)) + R_rest_2,
      R_bound_3 = KSL_MULF(1.0000005f, fabsf(fine_R_10 - R_10 + fine_R_lo_3)) + R_rest_1,
      diagonal1_bound_1 = diagonal1_error_2 + KSL_MULF(2.7640693e-10f, diagonal1_padded_1),
      R_bound_4 = KSL_MULF(1.0000005f, fabsf(fine_R_12 - R_12 + fine_R_lo_4)) + R_rest_3,
      R_bound_5 = KSL_MULF(1.0000005f, fabsf(fine_R_20 - R_20 + fine_R_lo_5)) + R_rest_2,
      R_bound_6 = KSL_MULF(1.0000005f, fabsf(fine_R_21 - R_21 + fine_R_lo_6)) + R_rest_3,
      diagonal2_bound_1 = diagonal2_error_2 + KSL_MULF(2.7640693e-10f, diagonal2_padded_1);
  R->m00 = diagonal0;
  R->m01 = R_01;
  R->m02 = R_02;
  R->m10 = R_10;
  R->m11 = diagonal1;
  R->m12 = R_12;
  R->m20 = R_20;
  R->m21 = R_21;
  R->m22 = diagonal2;
  R_bound->m00 = diagonal0_bound_1;
  R_bound->m01 = R_bound_1;
  R_bound->m02 = R_bound_2;
  R_bound->m10 = R_bound_3;
  R_bound->m11 = diagonal1_bound_1;
  R_bound->m12 = R_bound_4;
  R_bound->m20 = R_bound_5;
  R_bound->m21 = R_bound_6;
  R_bound->m22 = diagonal2_bound_1;
}

/* self = R + R (I - R^T R)/2, closer to a rotation: a defect d of R becomes 3/4 d^2; |error of
     self| <= self_bound unless inf or NaN.
   self, self_bound: rotation or other 3×3 matrix.
   93 mul, 105 add, 3 neg, 27 abs. */
static inline void ksl_mat3x3f_orthonormalize_certified(ksl_mat3x3f_t *self,
    ksl_mat3x3f_t *self_bound) {
  const float defect_0a = KSL_MULF(self->m00, self->m00),
      defect_0c = KSL_MULF(self->m10, self->m10), defect_0e = KSL_MULF(self->m20, self->m20),
      defect_0 = 1.0f - defect_0a - defect_0c - defect_0e;
  const float defect_1a = KSL_MULF(self->m01, self->m01),
      defect_1c = KSL_MULF(self->m11, self->m11), defect_1e = KSL_MULF(self->m21, self->m21),
      defect_1 = 1.0f - defect_1a - defect_1c - defect_1e;
  const float defect_2a = KSL_MULF(self->m02, self->m02),
      defect_2c = KSL_MULF(self->m12, self->m12), defect_2e = KSL_MULF(self->m22, self->m22),
      defect_2 = 1.0f - defect_2a - defect_2c - defect_2e;
  const float defect_3a = KSL_MULF(self->m00, self->m01),
      defect_3b = KSL_MULF(self->m10, self->m11), defect_3d = KSL_MULF(self->m20, self->m21),
      defect_3 = -(defect_3a + defect_3b + defect_3d);
  const float defect_4a = KSL_MULF(self->m00, self->m02),
      defect_4b = KSL_MULF(self->m10, self->m12), defect_4d = KSL_MULF(self->m20, self->m22),
      defect_4 = -(defect_4a + defect_4b + defect_4d);
  const float defect_5a = KSL_MULF(self->m01, self->m02),
      defect_5b = KSL_MULF(self->m11, self->m12), defect_5d = KSL_MULF(self->m21, self->m22),
      defect_5 = -(defect_5a + defect_5b + defect_5d);
  const float correction_0 = KSL_MULF(0.5f, defect_0), correction_1 = KSL_MULF(0.5f, defect_1),
      correction_2 = KSL_MULF(0.5f, defect_2), correction_3 = KSL_MULF(0.5f, defect_3),
      correction_4 = KSL_MULF(0.5f, defect_4), correction_5 = KSL_MULF(0.5f, defect_5);
  const float self_00_new = self->m00
          + (KSL_MULF(self->m00, correction_0) + KSL_MULF(self->m01, correction_3)
          + KSL_MULF(self->m02, correction_4));
  const float self_01_new = KSL_MULF(self->m00, correction_3) + KSL_MULF(self->m01, correction_1)
          + KSL_MULF(self->m02, correction_5) + self->m01;
  const float self_02_new = KSL_MULF(self->m00, correction_4) + KSL_MULF(self->m01, correction_5)
          + KSL_MULF(self->m02, correction_2) + self->m02;
  const float self_10_new = self->m10
          + (KSL_MULF(self->m10, correction_0) + KSL_MULF(self->m11, correction_3)
          + KSL_MULF(self->m12, correction_4)),
      self_11_new = KSL_MULF(self->m10, correction_3) + KSL_MULF(self->m11, correction_1)
          + KSL_MULF(self->m12, correction_5) + self->m11,
      self_12_new = KSL_MULF(self->m10, correction_4) + KSL_MULF(self->m11, correction_5)
          + KSL_MULF(self->m12, correction_2) + self->m12,
      self_20_new = self->m20
          + (KSL_MULF(self->m20, correction_0) + KSL_MULF(self->m21, correction_3)
          + KSL_MULF(self->m22, correction_4)),
      self_21_new = KSL_MULF(self->m20, correction_3) + KSL_MULF(self->m21, correction_1)
          + KSL_MULF(self->m22, correction_5) + self->m21,
      self_22_new = KSL_MULF(self->m20, correction_4) + KSL_MULF(self->m21, correction_5)
          + KSL_MULF(self->m22, correction_2) + self->m22;
  const float defect_0_size = 1.0f + fabsf(defect_0a) + fabsf(defect_0c) + fabsf(defect_0e),
      defect_1_size = 1.0f + fabsf(defect_1a) + fabsf(defect_1c) + fabsf(defect_1e),
      defect_2_size = 1.0f + fabsf(defect_2a) + fabsf(defect_2c) + fabsf(defect_2e);
  const float correction_0_size = KSL_MULF(0.5f, defect_0_size + 1.9721523e-31f),
      correction_1_size = KSL_MULF(0.5f, defect_1_size + 1.9721523e-31f),
      correction_2_size = KSL_MULF(0.5f, defect_2_size + 1.9721523e-31f),
      correction_3_size = KSL_MULF(0.5f, fabsf(defect_3a) + fabsf(defect_3b) + fabsf(defect_3d)
          + 1.9721523e-31f),
      correction_4_size = KSL_MULF(0.5f, fabsf(defect_4a) + fabsf(defect_4b) + fabsf(defect_4d)
          + 1.9721523e-31f),
      correction_5_size = KSL_MULF(0.5f, fabsf(defect_5a) + fabsf(defect_5b) + fabsf(defect_5d)
          + 1.9721523e-31f);
  const float correction_0_padded = correction_0_size + 1.9721523e-31f;
  const float self_00_abs = fabsf(self->m00);
  const float correction_3_padded = correction_3_size + 1.9721523e-31f;
  const float self_01_abs = fabsf(self->m01);
  const float correction_4_padded = correction_4_size + 1.9721523e-31f;
  const float self_02_abs = fabsf(self->m02),
      self_00_new_c_size = KSL_MULF(self_00_abs, correction_0_padded)
          + KSL_MULF(self_01_abs, correction_3_padded),
      self_00_new_size = self_00_abs
          + (self_00_new_c_size + KSL_MULF(self_02_abs, correction_4_padded));
  const float correction_1_padded = correction_1_size + 1.9721523e-31f,
      correction_5_padded = correction_5_size + 1.9721523e-31f;
  const float self_01_new_c_size = KSL_MULF(self_00_abs, correction_3_padded)
          + KSL_MULF(self_01_abs, correction_1_padded),
      self_01_new_size = self_01_new_c_size + KSL_MULF(self_02_abs, correction_5_padded)
          + self_01_abs;
  const float correction_2_padded = correction_2_size + 1.9721523e-31f;
  const float self_02_new_c_size = KSL_MULF(self_00_abs, correction_4_padded)
          + KSL_MULF(self_01_abs, correction_5_padded),
      self_02_new_size = self_02_new_c_size + KSL_MULF(self_02_abs, correction_2_padded)
          + self_02_abs;
  const float self_10_abs = fabsf(self->m10), self_11_abs = fabsf(self->m11),
      self_12_abs = fabsf(self->m12),
      self_10_new_c_size = KSL_MULF(self_10_abs, correction_0_padded)
          + KSL_MULF(self_11_abs, correction_3_padded),
      self_10_new_size = self_10_abs
          + (self_10_new_c_size + KSL_MULF(self_12_abs, correction_4_padded));
  const float self_11_new_c_size = KSL_MULF(self_10_abs, correction_3_padded)
          + KSL_MULF(self_11_abs, correction_1_padded),
      self_11_new_size = self_11_new_c_size + KSL_MULF(self_12_abs, correction_5_padded)
          + self_11_abs;
  const float self_12_new_c_size = KSL_MULF(self_10_abs, correction_4_padded)
          + KSL_MULF(self_11_abs, correction_5_padded),
      self_12_new_size = self_12_new_c_size + KSL_MULF(self_12_abs, correction_2_padded)
          + self_12_abs;
  const float self_20_abs = fabsf(self->m20), self_21_abs = fabsf(self->m21),
      self_22_abs = fabsf(self->m22),
      self_20_new_c_size = KSL_MULF(self_20_abs, correction_0_padded)
          + KSL_MULF(self_21_abs, correction_3_padded),
      self_20_new_size = self_20_abs
          + (self_20_new_c_size + KSL_MULF(self_22_abs, correction_4_padded));
  const float self_21_new_c_size = KSL_MULF(self_20_abs, correction_3_padded)
          + KSL_MULF(self_21_abs, correction_1_padded),
      self_21_new_size = self_21_new_c_size + KSL_MULF(self_22_abs, correction_5_padded)
          + self_21_abs;
  const float self_22_new_c_size = KSL_MULF(self_20_abs, correction_4_padded)
          + KSL_MULF(self_21_abs, correction_5_padded),
      self_22_new_size = self_22_new_c_size + KSL_MULF(self_22_abs, correction_2_padded)
          + self_22_abs;
  const float self_00_new_bound = KSL_MULF(5.36442e-07f, self_00_new_size + 1.9721523e-31f),
      self_01_new_bound = KSL_MULF(5.36442e-07f, self_01_new_size + 1.9721523e-31f),
      self_02_new_bound = KSL_MULF(4.7683733e-07f, self_02_new_size + 1.9721523e-31f),
      self_10_new_bound = KSL_MULF(5.36442e-07f, self_10_new_size + 1.9721523e-31f),
      self_11_new_bound = KSL_MULF(5.36442e-07f, self_11_new_size + 1.9721523e-31f),
      self_12_new_bound = KSL_MULF(4.7683733e-07f, self_12_new_size + 1.9721523e-31f),
      self_20_new_bound = KSL_MULF(5.36442e-07f, self_20_new_size + 1.9721523e-31f),
      self_21_new_bound = KSL_MULF(5.36442e-07f, self_21_new_size + 1.9721523e-31f),
      self_22_new_bound = KSL_MULF(4.7683733e-07f, self_22_new_size + 1.9721523e-31f);
  self->m00 = self_00_new;
  self->m01 = self_01_new;
  self->m02 = self_02_new;
  self->m10 = self_10_new;
  self->m11 = self_11_new;
  self->m12 = self_12_new;
  self->m20 = self_20_new;
  self->m21 = self_21_new;
  self->m22 = self_22_new;
  self_bound->m00 = self_00_new_bound;
  self_bound->m01 = self_01_new_bound;
  self_bound->m02 = self_02_new_bound;
  self_bound->m10 = self_10_new_bound;
  self_bound->m11 = self_11_new_bound;
  self_bound->m12 = self_12_new_bound;
  self_bound->m20 = self_20_new_bound;
  self_bound->m21 = self_21_new_bound;
  self_bound->m22 = self_22_new_bound;
}

/* Ro = R + R (I - R^T R)/2, closer to a rotation: a defect d of R becomes 3/4 d^2; |error of Ro|
     <= Ro_bound unless inf or NaN.
   R, Ro, Ro_bound: rotation or other 3×3 matrix.
   93 mul, 105 add, 3 neg, 27 abs. */
static inline void ksl_mat3x3f_orthonormalized_certified(const ksl_mat3x3f_t *R,
    ksl_mat3x3f_t *Ro, ksl_mat3x3f_t *Ro_bound) {
  const float defect_0a = KSL_MULF(R->m00, R->m00), defect_0c = KSL_MULF(R->m10, R->m10),
      defect_0e = KSL_MULF(R->m20, R->m20), defect_0 = 1.0f - defect_0a - defect_0c - defect_0e;
  const float defect_1a = KSL_MULF(R->m01, R->m01), defect_1c = KSL_MULF(R->m11, R->m11),
      defect_1e = KSL_MULF(R->m21, R->m21), defect_1 = 1.0f - defect_1a - defect_1c - defect_1e;
  const float defect_2a = KSL_MULF(R->m02, R->m02), defect_2c = KSL_MULF(R->m12, R->m12),
      defect_2e = KSL_MULF(R->m22, R->m22), defect_2 = 1.0f - defect_2a - defect_2c - defect_2e;
  const float defect_3a = KSL_MULF(R->m00, R->m01), defect_3b = KSL_MULF(R->m10, R->m11),
      defect_3d = KSL_MULF(R->m20, R->m21), defect_3 = -(defect_3a + defect_3b + defect_3d);
  const float defect_4a = KSL_MULF(R->m00, R->m02), defect_4b = KSL_MULF(R->m10, R->m12),
      defect_4d = KSL_MULF(R->m20, R->m22), defect_4 = -(defect_4a + defect_4b + defect_4d);
  const float defect_5a = KSL_MULF(R->m01, R->m02), defect_5b = KSL_MULF(R->m11, R->m12),
      defect_5d = KSL_MULF(R->m21, R->m22), defect_5 = -(defect_5a + defect_5b + defect_5d);
  const float correction_0 = KSL_MULF(0.5f, defect_0), correction_1 = KSL_MULF(0.5f, defect_1),
      correction_2 = KSL_MULF(0.5f, defect_2), correction_3 = KSL_MULF(0.5f, defect_3),
      correction_4 = KSL_MULF(0.5f, defect_4), correction_5 = KSL_MULF(0.5f, defect_5);
  const float Ro_00 = R->m00
          + (KSL_MULF(R->m00, correction_0) + KSL_MULF(R->m01, correction_3)
          + KSL_MULF(R->m02, correction_4));
  const float Ro_01 = KSL_MULF(R->m00, correction_3) + KSL_MULF(R->m01, correction_1)
          + KSL_MULF(R->m02, correction_5) + R->m01;
  const float Ro_02 = KSL_MULF(R->m00, correction_4) + KSL_MULF(R->m01, correction_5)
          + KSL_MULF(R->m02, correction_2) + R->m02;
  const float Ro_10 = R->m10
          + (KSL_MULF(R->m10, correction_0) + KSL_MULF(R->m11, correction_3)
          + KSL_MULF(R->m12, correction_4)),
      Ro_11 = KSL_MULF(R->m10, correction_3) + KSL_MULF(R->m11, correction_1)
          + KSL_MULF(R->m12, correction_5) + R->m11,
      Ro_12 = KSL_MULF(R->m10, correction_4) + KSL_MULF(R->m11, correction_5)
          + KSL_MULF(R->m12, correction_2) + R->m12,
      Ro_20 = R->m20
          + (KSL_MULF(R->m20, correction_0) + KSL_MULF(R->m21, correction_3)
          + KSL_MULF(R->m22, correction_4)),
      Ro_21 = KSL_MULF(R->m20, correction_3) + KSL_MULF(R->m21, correction_1)
          + KSL_MULF(R->m22, correction_5) + R->m21,
      Ro_22 = KSL_MULF(R->m20, correction_4) + KSL_MULF(R->m21, correction_5)
          + KSL_MULF(R->m22, correction_2) + R->m22;
  const float defect_0_size = 1.0f + fabsf(defect_0a) + fabsf(defect_0c) + fabsf(defect_0e),
      defect_1_size = 1.0f + fabsf(defect_1a) + fabsf(defect_1c) + fabsf(defect_1e),
      defect_2_size = 1.0f + fabsf(defect_2a) + fabsf(defect_2c) + fabsf(defect_2e);
  const float correction_0_size = KSL_MULF(0.5f, defect_0_size + 1.9721523e-31f),
      correction_1_size = KSL_MULF(0.5f, defect_1_size + 1.9721523e-31f),
      correction_2_size = KSL_MULF(0.5f, defect_2_size + 1.9721523e-31f),
      correction_3_size = KSL_MULF(0.5f, fabsf(defect_3a) + fabsf(defect_3b) + fabsf(defect_3d)
          + 1.9721523e-31f),
      correction_4_size = KSL_MULF(0.5f, fabsf(defect_4a) + fabsf(defect_4b) + fabsf(defect_4d)
          + 1.9721523e-31f),
      correction_5_size = KSL_MULF(0.5f, fabsf(defect_5a) + fabsf(defect_5b) + fabsf(defect_5d)
          + 1.9721523e-31f);
  const float correction_0_padded = correction_0_size + 1.9721523e-31f;
  const float R_00_abs = fabsf(R->m00);
  const float correction_3_padded = correction_3_size + 1.9721523e-31f;
  const float R_01_abs = fabsf(R->m01);
  const float correction_4_padded = correction_4_size + 1.9721523e-31f;
  const float R_02_abs = fabsf(R->m02),
      Ro_00_size = R_00_abs
          + (KSL_MULF(R_00_abs, correction_0_padded) + KSL_MULF(R_01_abs, correction_3_padded)
          + KSL_MULF(R_02_abs, correction_4_padded));
  const float correction_1_padded = correction_1_size + 1.9721523e-31f,
      correction_5_padded = correction_5_size + 1.9721523e-31f;
  const float Ro_01_size = KSL_MULF(R_00_abs, correction_3_padded)
          + KSL_MULF(R_01_abs, correction_1_padded) + KSL_MULF(R_02_abs, correction_5_padded)
          + R_01_abs;
  const float correction_2_padded = correction_2_size + 1.9721523e-31f;
  const float Ro_02_size = KSL_MULF(R_00_abs, correction_4_padded)
          + KSL_MULF(R_01_abs, correction_5_padded) + KSL_MULF(R_02_abs, correction_2_padded)
          + R_02_abs;
  const float R_10_abs = fabsf(R->m10), R_11_abs = fabsf(R->m11), R_12_abs = fabsf(R->m12),
      Ro_10_size = R_10_abs
          + (KSL_MULF(R_10_abs, correction_0_padded) + KSL_MULF(R_11_abs, correction_3_padded)
          + KSL_MULF(R_12_abs, correction_4_padded));
  const float Ro_11_size = KSL_MULF(R_10_abs, correction_3_padded)
          + KSL_MULF(R_11_abs, correction_1_padded) + KSL_MULF(R_12_abs, correction_5_padded)
          + R_11_abs,
      Ro_12_size = KSL_MULF(R_10_abs, correction_4_padded)
          + KSL_MULF(R_11_abs, correction_5_padded) + KSL_MULF(R_12_abs, correction_2_padded)
          + R_12_abs;
  const float R_20_abs = fabsf(R->m20), R_21_abs = fabsf(R->m21), R_22_abs = fabsf(R->m22),
      Ro_20_size = R_20_abs
          + (KSL_MULF(R_20_abs, correction_0_padded) + KSL_MULF(R_21_abs, correction_3_padded)
          + KSL_MULF(R_22_abs, correction_4_padded));
  const float Ro_21_size = KSL_MULF(R_20_abs, correction_3_padded)
          + KSL_MULF(R_21_abs, correction_1_padded) + KSL_MULF(R_22_abs, correction_5_padded)
          + R_21_abs,
      Ro_22_size = KSL_MULF(R_20_abs, correction_4_padded)
          + KSL_MULF(R_21_abs, correction_5_padded) + KSL_MULF(R_22_abs, correction_2_padded)
          + R_22_abs;
  const float Ro_00_bound = KSL_MULF(5.36442e-07f, Ro_00_size + 1.9721523e-31f),
      Ro_01_bound = KSL_MULF(5.36442e-07f, Ro_01_size + 1.9721523e-31f),
      Ro_02_bound = KSL_MULF(4.7683733e-07f, Ro_02_size + 1.9721523e-31f),
      Ro_10_bound = KSL_MULF(5.36442e-07f, Ro_10_size + 1.9721523e-31f),
      Ro_11_bound = KSL_MULF(5.36442e-07f, Ro_11_size + 1.9721523e-31f),
      Ro_12_bound = KSL_MULF(4.7683733e-07f, Ro_12_size + 1.9721523e-31f),
      Ro_20_bound = KSL_MULF(5.36442e-07f, Ro_20_size + 1.9721523e-31f),
      Ro_21_bound = KSL_MULF(5.36442e-07f, Ro_21_size + 1.9721523e-31f),
      Ro_22_bound = KSL_MULF(4.7683733e-07f, Ro_22_size + 1.9721523e-31f);
  Ro->m00 = Ro_00;
  Ro->m01 = Ro_01;
  Ro->m02 = Ro_02;
  Ro->m10 = Ro_10;
  Ro->m11 = Ro_11;
  Ro->m12 = Ro_12;
  Ro->m20 = Ro_20;
  Ro->m21 = Ro_21;
  Ro->m22 = Ro_22;
  Ro_bound->m00 = Ro_00_bound;
  Ro_bound->m01 = Ro_01_bound;
  Ro_bound->m02 = Ro_02_bound;
  Ro_bound->m10 = Ro_10_bound;
  Ro_bound->m11 = Ro_11_bound;
  Ro_bound->m12 = Ro_12_bound;
  Ro_bound->m20 = Ro_20_bound;
  Ro_bound->m21 = Ro_21_bound;
  Ro_bound->m22 = Ro_22_bound;
}

/* D = exp s = [exp ω~ | J_l(ω) v]; |error of D| <= D_bound unless inf or NaN.
   s: screw (v in m/s; ω in rad/s); D, D_bound: displacement [R | t], R rotation, t in m.
   494 mul, 835 add, 21 product error, 58 product rest, 16 div, 3 sqrt, 102 abs, 20 less, 1
     equal, 46 select. */
static inline void ksl_SE3f_exp_certified(const ksl_screwf_t *s, ksl_SE3f_t *D,
    ksl_SE3f_t *D_bound) {
  const float size_0 = fabsf(s->m3), size_1 = fabsf(s->m4), size_2 = fabsf(s->m5);
  const float sizes = size_0 + size_1 + size_2;
  const float grid = KSL_MULF(sizes, 8192.0f);
  const float shifted_0 = s->m3 + grid, shifted_1 = s->m4 + grid, shifted_2 = s->m5 + grid;
  const float high_0 = shifted_0 - grid, high_1 = shifted_1 - grid, high_2 = shifted_2 - grid;
  const float low_0 = s->m3 - high_0, low_1 = s->m4 - high_1, low_2 = s->m5 - high_2;
  const float sum_0 = s->m3 + high_0, sum_1 = s->m4 + high_1, sum_2 = s->m5 + high_2;
  const float squares = KSL_MULF(high_0, high_0) + KSL_MULF(high_1, high_1)
          + KSL_MULF(high_2, high_2);
  const float cross = KSL_MULF(low_0, sum_0) + KSL_MULF(low_1, sum_1) + KSL_MULF(low_2, sum_2);
  const float x = squares + cross;
  const float theta_a = sqrtf(x), theta = x < 1.0f ? 1.0f : theta_a;
  const float theta_shifted = grid + theta;
  const float theta_high = theta_shifted - grid;
  const float theta_low = theta - theta_high;
  const float theta_sum = theta + theta_high;
  const float cross_rest = cross - KSL_MULF(theta_low, theta_sum);
  const float exact = squares - KSL_MULF(theta_high, theta_high);
  const float residual = cross_rest + exact;
  const float small = KSL_MULF(0.5f, residual) / theta;
  const float delta = fabsf(small) < 0.0078125f ? small : 0.0f;
  float far_cosine_a; const float far_sine_a = ksl_sincosf(theta, &far_cosine_a);
  const float far_sine = x < 1.0f ? 1.0f : far_sine_a;
  const float far_cosine = x < 1.0f ? 0.0f : far_cosine_a;
  const float sine = KSL_MULF(delta, far_cosine) + far_sine;
  const float cosine = far_cosine - KSL_MULF(delta, far_sine);
  const float far_x = x < 1.0f ? 1.0f : x;
  const float middle_x = x < 4.0f ? 4.0f : x;
  const float closed1 = sine / theta;
  const float versine = 1.0f - cosine;
  const float closed2 = versine / far_x;
  const float rest3 = 1.0f - closed1;
  const float closed3 = rest3 / middle_x;
  const float g1h = KSL_MULF(x, KSL_MULF(x, KSL_MULF(x, KSL_MULF(6.4469503e-26f, x)
          - 3.8681703e-23f) + 1.9572942e-20f) - 8.220635e-18f) + 2.8114574e-15f,
      g1q = KSL_MULF(x, KSL_MULF(x, KSL_MULF(x, KSL_MULF(x, KSL_MULF(x, g1h) - 7.6471636e-13f)
          + 1.6059044e-10f) - 2.5052108e-08f) + 2.7557319e-06f),
      g1x = KSL_MULF(x, KSL_MULF(x, KSL_MULF(x, g1q - 0.0001984127f) + 0.008333334f) - 0.16666667f)
          + 1.0f, g1 = x < 1.0f ? g1x : closed1;
  const float g2h = KSL_MULF(x, KSL_MULF(x, KSL_MULF(x, KSL_MULF(2.4795963e-27f, x)
          - 1.6117376e-24f) + 8.896791e-22f) - 4.1103176e-19f) + 1.5619207e-16f,
      g2q = KSL_MULF(x, KSL_MULF(x, KSL_MULF(x, KSL_MULF(x, KSL_MULF(x, g2h) - 4.7794773e-14f)
          + 1.1470745e-11f) - 2.0876756e-09f) + 2.755732e-07f),
      g2x = KSL_MULF(x, KSL_MULF(x, KSL_MULF(x, g2q - 2.4801588e-05f) + 0.0013888889f)
          - 0.041666668f) + 0.5f, g2 = x < 1.0f ? g2x : closed2;
  const float g3i = KSL_MULF(x, KSL_MULF(x, KSL_MULF(x, KSL_MULF(x, KSL_MULF(9.18369e-29f, x)
          - 6.4469503e-26f) + 3.8681703e-23f) - 1.9572942e-20f) + 8.220635e-18f),
      g3r = KSL_MULF(x, KSL_MULF(x, KSL_MULF(x, KSL_MULF(x, g3i - 2.8114574e-15f) + 7.6471636e-13f)
          - 1.6059044e-10f) + 2.5052108e-08f) - 2.7557319e-06f,
      g3x = KSL_MULF(x, KSL_MULF(x, KSL_MULF(x, g3r) + 0.0001984127f) - 0.008333334f) + 0.16666667f,
      g3 = x < 4.0f ? g3x : closed3;
  const float g0b = 1.0f - KSL_MULF(x, g2), g0 = x < 1.0f ? g0b : cosine;
  const float u_0 = KSL_MULF(s->m2, s->m4) - KSL_MULF(s->m1, s->m5);
  const float u_1 = KSL_MULF(s->m0, s->m5) - KSL_MULF(s->m2, s->m3);
  const float u_2 = KSL_MULF(s->m1, s->m3) - KSL_MULF(s->m0, s->m4);
  const float turned_0 = KSL_MULF(g2, u_0);
  const float turned_1 = KSL_MULF(g2, u_1);
  const float turned_2 = KSL_MULF(g2, u_2);
  const float wv = KSL_MULF(s->m0, s->m3) + KSL_MULF(s->m1, s->m4) + KSL_MULF(s->m2, s->m5);
  const float pitch = KSL_MULF(g3, wv);
  const float along_0 = KSL_MULF(s->m3, pitch);
  const float along_1 = KSL_MULF(s->m4, pitch);
  const float along_2 = KSL_MULF(s->m5, pitch);
  const float beta_v_0 = KSL_MULF(s->m3, g2);
  const float beta_v_1 = KSL_MULF(s->m4, g2);
  const float beta_v_2 = KSL_MULF(s->m5, g2);
  const float m_0 = KSL_MULF(s->m3, beta_v_0);
  const float m_1 = KSL_MULF(s->m4, beta_v_1);
  const float m_2 = KSL_MULF(s->m5, beta_v_2);
  const float m_3 = KSL_MULF(s->m4, beta_v_0);
  const float m_4 = KSL_MULF(s->m5, beta_v_0);
  const float m_5 = KSL_MULF(s->m5, beta_v_1);
  const float others_0 = m_1 + m_2;
  const float others_1 = m_0 + m_2;
  const float others_2 = m_0 + m_1;
  const float diagonal0a = 1.0f - others_0, diagonal0b = g0 + m_0,
      diagonal0 = m_0 < others_0 ? diagonal0b : diagonal0a;
  const float diagonal1a = 1.0f - others_1, diagonal1b = g0 + m_1,
      diagonal1 = m_1 < others_1 ? diagonal1b : diagonal1a;
  const float diagonal2a = 1.0f - others_2, diagonal2b = g0 + m_2,
      diagonal2 = m_2 < others_2 ? diagonal2b : diagonal2a;
  const float alpha_v_0 = KSL_MULF(s->m3, g1);
  const float alpha_v_1 = KSL_MULF(s->m4, g1);
  const float alpha_v_2 = KSL_MULF(s->m5, g1);
  const float across_axis_0 = turned_0 + along_0;
  const float across_axis_1 = turned_1 + along_1;
  const float across_axis_2 = turned_2 + along_2;
  const float D_01 = m_3 - alpha_v_2;
  const float D_02 = m_4 + alpha_v_1;
  const float D_03 = KSL_MULF(s->m0, g1) + across_axis_0;
  const float D_10 = m_3 + alpha_v_2;
  const float D_12 = m_5 - alpha_v_0;
  const float D_13 = KSL_MULF(s->m1, g1) + across_axis_1;
  const float D_20 = m_4 - alpha_v_1;
  const float D_21 = m_5 + alpha_v_0;
  const float D_23 = KSL_MULF(s->m2, g1) + across_axis_2;
  const float halved_0 = KSL_MULF(0.5f, s->m3), halved_size_1 = fabsf(s->m3);
  const float halved_1 = KSL_MULF(0.5f, s->m4), halved_size_3 = fabsf(s->m4);
  const float halved_2 = KSL_MULF(0.5f, s->m5), halved_size_5 = fabsf(s->m5);
  const float y_a = KSL_MULF(halved_0, halved_0),
      y_a_padded_1 = 3.3087225e-24f + KSL_MULF(0.5f, halved_size_1),
      y_b = KSL_MULF(halved_1, halved_1),
      y_b_padded_1 = 3.3087225e-24f + KSL_MULF(0.5f, halved_size_3), y_c = y_a + y_b,
      y_c_right_1 = y_c - y_a, y_d = KSL_MULF(halved_2, halved_2),
      y_d_padded_1 = 3.3087225e-24f + KSL_MULF(0.5f, halved_size_5), y = y_c + y_d,
      y_right_1 = y - y_c,
      y_c_lo = ksl_product_restf(halved_0, halved_0, y_a, y_c - y_c_right_1)
          + ksl_product_restf(halved_1, halved_1, y_b, y_c_right_1),
      y_lo = y_c - (y - y_right_1) + ksl_product_restf(halved_2, halved_2, y_d, y_right_1) + y_c_lo,
      y_size_1 = KSL_MULF(y_a_padded_1, y_a_padded_1) + KSL_MULF(y_b_padded_1, y_b_padded_1)
          + KSL_MULF(y_d_padded_1, y_d_padded_1);
  const float half_angle = sqrtf(y), half_angle_product_1 = KSL_MULF(half_angle, half_angle),
      half_angle_twice_1 = half_angle + half_angle,
      half_angle_residual_1 = y - half_angle_product_1
          - ksl_product_errorf(half_angle, half_angle, half_angle_product_1) + y_lo,
      half_angle_lo = half_angle_residual_1 / (half_angle == 0.0f ? 1.0f : half_angle_twice_1),
      half_angle_padded_1 = 3.3087225e-24f + y_size_1,
      half_angle_bound_1 = fabsf(y_lo) + KSL_MULF(7.2120885e-13f, half_angle_padded_1),
      half_angle_size_4 = KSL_MULF(fabsf(y)
          + KSL_MULF(262144.0f, half_angle_bound_1), half_angle_padded_1 / half_angle / y),
      half_angle_size_6 = fabsf(half_angle_lo),
      half_angle_size_8 = KSL_MULF(8.907313e+11f, sqrtf(half_angle_bound_1) + half_angle_size_6),
      half_angle_size_12 = half_angle
          + (KSL_MULF(4.0f, half_angle_bound_1) < y ? half_angle_size_4 : half_angle_size_8);
  float c; const float fine_sine = ksl_sincosf(half_angle, &c);
  float c_own_error_1; const float fine_sine_own_error_1 = ksl_sincos_errorf(half_angle, fine_sine,
      c, &c_own_error_1);
  const float fine_sine_half_1 = KSL_MULF(half_angle_lo, 0.5f);
  float fine_sine_half_cos_1; const float fine_sine_half_sin_1 = ksl_sincosf(fine_sine_half_1,
      &fine_sine_half_cos_1);
  const float fine_sine_twice_1 = fine_sine_half_sin_1 + fine_sine_half_sin_1,
      fine_sine_lo = fine_sine_own_error_1
          + KSL_MULF(KSL_MULF(fine_sine_half_cos_1, c)
          - KSL_MULF(fine_sine_half_sin_1, fine_sine), fine_sine_twice_1),
      fine_sine_padded_1 = 3.3087225e-24f + half_angle_size_12,
      fine_sine_size_1 = 1.0f + fine_sine_padded_1;
  const float c_lo = c_own_error_1
          - KSL_MULF(KSL_MULF(fine_sine_half_cos_1, fine_sine)
          + KSL_MULF(fine_sine_half_sin_1, c), fine_sine_twice_1);
  const float sinc_divisor = half_angle < 1.4901161e-08f ? 1.4901161e-08f : half_angle,
      sinc_divisor_lo = half_angle < 1.4901161e-08f ? 0.0f : half_angle_lo,
      sinc_divisor_bound_1 = half_angle_size_6 + KSL_MULF(1.2221551e-12f, fine_sine_padded_1),
      sinc_divisor_size_3 = fabsf(half_angle - 1.4901161e-08f),
      sinc_divisor_size_7 = sinc_divisor_bound_1 + fabsf(1.4901161e-08f - half_angle),
      sinc_divisor_size_9 = KSL_MULF(3.1414265e+11f, sinc_divisor_bound_1 < sinc_divisor_size_3
          ? 0.0f : sinc_divisor_size_7);
  const float sinc_quotient = fine_sine / sinc_divisor,
      sinc_quotient_product_1 = KSL_MULF(sinc_quotient, sinc_divisor),
      sinc_quotient_exact_1 = fine_sine - sinc_quotient_product_1
          - ksl_product_errorf(sinc_quotient, sinc_divisor, sinc_quotient_product_1),
      sinc_quotient_lo = (sinc_quotient_exact_1 + fine_sine_lo
          - KSL_MULF(sinc_quotient, sinc_divisor_lo)) / sinc_divisor,
      sinc_quotient_padded_2 = 3.3087225e-24f
          + ((half_angle < 1.4901161e-08f ? 1.4901161e-08f : half_angle_size_12)
          + sinc_divisor_size_9), sinc_quotient_size_1 = fabsf(sinc_quotient),
      sinc_quotient_size_2 = fabsf(sinc_divisor),
      sinc_quotient_bound_1 = fabsf(sinc_divisor_lo)
          + KSL_MULF(3.2827582e-12f, sinc_quotient_padded_2),
      sinc_quotient_size_4 = 3.3087225e-24f + fine_sine_size_1
          + KSL_MULF(sinc_quotient_padded_2, sinc_quotient_size_1),
      sinc_quotient_size_8 = sinc_quotient_size_4
          / (KSL_MULF(4.0f, sinc_quotient_bound_1) < sinc_quotient_size_2 ? sinc_quotient_size_2
          : 0.0f),
      sinc_quotient_size_10 = KSL_MULF(sinc_quotient_size_2
          + KSL_MULF(262144.0f, sinc_quotient_bound_1), sinc_quotient_size_8)
          / sinc_quotient_size_2,
      sinc_quotient_size_11 = sinc_quotient_size_1 + sinc_quotient_size_10;
  const float sinc_a = KSL_MULF(0.16666667f, y), sinc_b = 1.0f - sinc_a,
      sinc_b_right_1 = 1.0f - sinc_b,
      sinc_b_lo1_1 = 1.0f - (sinc_b + sinc_b_right_1)
          - ksl_product_restf(0.16666667f, y, sinc_a, sinc_b_right_1),
      sinc_b_lo = sinc_b_lo1_1 - (KSL_MULF(-4.967054e-09f, y) + KSL_MULF(0.16666667f, y_lo)),
      sinc_b_size_1 = 1.0f + KSL_MULF(0.16666669f, y_size_1),
      sinc = half_angle < 1.4901161e-08f ? sinc_b : sinc_quotient,
      sinc_lo = half_angle < 1.4901161e-08f ? sinc_b_lo : sinc_quotient_lo,
      sinc_size_4 = fabsf(sinc_b_lo) + KSL_MULF(2.3406937e-10f, 3.3087225e-24f + sinc_b_size_1)
          + fabsf(sinc_b - sinc_quotient),
      sinc_size_5 = fabsf(sinc_quotient_lo)
          + KSL_MULF(5.43103e-12f, 3.3087225e-24f + sinc_quotient_size_11) + sinc_size_4,
      sinc_size_7 = KSL_MULF(4.276409e+09f, sinc_divisor_bound_1 < sinc_divisor_size_3 ? 0.0f
          : sinc_size_5);
  const float fine_g1 = KSL_MULF(c, sinc),
      fine_g1_cross_1 = KSL_MULF(c_lo, sinc) + KSL_MULF(c, sinc_lo),
      fine_g1_padded_1 = 3.3087225e-24f
          + ((half_angle < 1.4901161e-08f ? sinc_b_size_1 : sinc_quotient_size_11) + sinc_size_7),
      fine_g1_rest_1 = KSL_MULF(2.5011469e-12f, fine_sine_size_1),
      fine_g1_reach_2 = fabsf(sinc)
          + KSL_MULF(262144.0f, fabsf(sinc_lo) + KSL_MULF(2.3406946e-10f, fine_g1_padded_1)),
      fine_g1_size_2 = KSL_MULF(fine_g1_padded_1, fabsf(c)
          + KSL_MULF(262144.0f, fabsf(c_lo) + fine_g1_rest_1)),
      fine_g1_size_5 = fine_g1_size_2 + KSL_MULF(fine_g1_reach_2, fine_sine_size_1);
  const float fine_g2a = KSL_MULF(sinc, sinc),
      fine_g2a_size_1 = KSL_MULF(fine_g1_padded_1, fine_g1_reach_2),
      fine_g2 = KSL_MULF(0.5f, fine_g2a),
      fine_g2_cross2_1 = KSL_MULF(0.5f, ksl_product_errorf(sinc, sinc, fine_g2a)
          + (KSL_MULF(sinc_lo, sinc) + KSL_MULF(sinc, sinc_lo)));
  const float sine_square = KSL_MULF(fine_sine, fine_sine),
      sine_square_size_2 = KSL_MULF(fine_sine_size_1, fabsf(fine_sine)
          + KSL_MULF(262144.0f, fine_g1_rest_1 + fabsf(fine_sine_lo)));
  const float fine_g0a = KSL_MULF(2.0f, sine_square),
      sine_square_lo = ksl_product_errorf(fine_sine, fine_sine, sine_square)
          + (KSL_MULF(fine_sine_lo, fine_sine) + KSL_MULF(fine_sine, fine_sine_lo)),
      fine_g0 = 1.0f - fine_g0a, fine_g0_right_1 = 1.0f - fine_g0,
      fine_g0_lo = 1.0f - (fine_g0 + fine_g0_right_1) - (fine_g0a - fine_g0_right_1)
          - KSL_MULF(2.0f, sine_square_lo),
      fine_g0_size_1 = 1.0f + KSL_MULF(2.0f, sine_square_size_2 + sine_square_size_2);
  const float fine_rest3 = 1.0f - fine_g1, fine_rest3_right_1 = 1.0f - fine_rest3;
  const float fine_x = KSL_MULF(4.0f, y), fine_x_cross2_1 = KSL_MULF(4.0f, y_lo),
      fine_x_size_1 = KSL_MULF(4.0f, y_size_1);
  const float fine_far_x = fine_x < 1.0f ? 1.0f : fine_x,
      fine_far_x_lo = fine_x < 1.0f ? 0.0f : fine_x_cross2_1,
      fine_far_x_padded_1 = 3.3087225e-24f + fine_x_size_1,
      fine_far_x_bound_1 = fabsf(fine_x_cross2_1) + KSL_MULF(8.100306e-13f, fine_far_x_padded_1),
      fine_far_x_size_3 = fabsf(fine_x - 1.0f),
      fine_far_x_size_7 = fine_far_x_bound_1 + fabsf(1.0f - fine_x),
      fine_far_x_size_9 = KSL_MULF(1.8324991e+11f, fine_far_x_bound_1 < fine_far_x_size_3 ? 0.0f
          : fine_far_x_size_7);
  const float fine_closed3 = fine_rest3 / fine_far_x,
      fine_closed3_product_1 = KSL_MULF(fine_closed3, fine_far_x);
  const float fine_rest3_lo = 1.0f - (fine_rest3 + fine_rest3_right_1)
          - ksl_product_restf(c, sinc, fine_g1, fine_rest3_right_1) - fine_g1_cross_1;
  const float fine_closed3_numerator_1 = fine_rest3 - fine_closed3_product_1
          - ksl_product_errorf(fine_closed3, fine_far_x, fine_closed3_product_1) + fine_rest3_lo,
      fine_closed3_lo = (fine_closed3_numerator_1 - KSL_MULF(fine_closed3, fine_far_x_lo))
          / fine_far_x,
      fine_closed3_padded_2 = 3.3087225e-24f
          + ((fine_x < 1.0f ? 1.0f : fine_x_size_1) + fine_far_x_size_9),
      fine_closed3_size_1 = fabsf(fine_closed3), fine_closed3_size_2 = fabsf(fine_far_x),
      fine_closed3_bound_1 = fabsf(fine_far_x_lo) + KSL_MULF(5.627585e-12f, fine_closed3_padded_2),
      fine_closed3_size_4 = 3.3087225e-24f + (1.0f + fine_g1_size_5)
          + KSL_MULF(fine_closed3_padded_2, fine_closed3_size_1),
      fine_closed3_size_8 = fine_closed3_size_4
          / (KSL_MULF(4.0f, fine_closed3_bound_1) < fine_closed3_size_2 ? fine_closed3_size_2
          : 0.0f),
      fine_closed3_size_10 = KSL_MULF(fine_closed3_size_2
          + KSL_MULF(262144.0f, fine_closed3_bound_1), fine_closed3_size_8) / fine_closed3_size_2,
      fine_closed3_size_11 = fine_closed3_size_1 + fine_closed3_size_10;
  const float series5a = KSL_MULF(1.216125e-34f, fine_x), series5b = 1.1309962e-31f - series5a,
      series5b_right_1 = 1.1309962e-31f - series5b,
      series5b_lo1_1 = 1.1309962e-31f - (series5b + series5b_right_1)
          - ksl_product_restf(1.216125e-34f, fine_x, series5a, series5b_right_1),
      series5b_lo = series5b_lo1_1
          - (KSL_MULF(2.696e-42f, fine_x) + KSL_MULF(1.216125e-34f, fine_x_cross2_1)) + 4.1374e-39f,
      series5c = KSL_MULF(fine_x, series5b),
      series5c_padded_1 = 3.3087225e-24f
          + (1.1309962e-31f + KSL_MULF(1.9784917e-27f, fine_x_size_1)),
      series5c_reach_1 = fabsf(fine_x) + KSL_MULF(262144.0f, fine_far_x_bound_1),
      series5c_reach_2 = fabsf(series5b)
          + KSL_MULF(262144.0f, fabsf(series5b_lo) + KSL_MULF(2.3419375e-10f, series5c_padded_1)),
      series5d = series5c - 9.18369e-29f, series5d_right_1 = series5c - series5d,
      series5d_lo2_1 = ksl_product_restf(fine_x, series5b, series5c, series5d + series5d_right_1)
          - (9.18369e-29f - series5d_right_1) - 5.383817e-37f,
      series5d_lo = series5d_lo2_1
          + (KSL_MULF(fine_x_cross2_1, series5b) + KSL_MULF(fine_x, series5b_lo)),
      series5e = KSL_MULF(fine_x, series5d),
      series5d_size_1 = 9.18369e-29f
          + (KSL_MULF(series5c_padded_1, series5c_reach_1)
          + KSL_MULF(fine_far_x_padded_1, series5c_reach_2)),
      series5e_padded_1 = 3.3087225e-24f + series5d_size_1,
      series5e_reach_1 = fabsf(series5d)
          + KSL_MULF(262144.0f, fabsf(series5d_lo) + KSL_MULF(2.3612653e-10f, series5e_padded_1)),
      series5f = series5e + 6.4469503e-26f, series5f_right_1 = series5f - series5e,
      series5f_lo2_1 = ksl_product_restf(fine_x, series5d, series5e, series5f - series5f_right_1)
          + (6.4469503e-26f - series5f_right_1) + -5.609469e-34f,
      series5f_lo = series5f_lo2_1
          + (KSL_MULF(fine_x_cross2_1, series5d) + KSL_MULF(fine_x, series5d_lo)),
      series5g = KSL_MULF(fine_x, series5f),
      series5f_size_1 = 6.4469503e-26f
          + (KSL_MULF(series5c_reach_1, series5e_padded_1)
          + KSL_MULF(fine_far_x_padded_1, series5e_reach_1)),
      series5g_padded_1 = 3.3087225e-24f + series5f_size_1,
      series5g_reach_1 = fabsf(series5f)
          + KSL_MULF(262144.0f, fabsf(series5f_lo) + KSL_MULF(2.381233e-10f, series5g_padded_1)),
      series5h = series5g - 3.8681703e-23f, series5h_right_1 = series5g - series5h,
      series5h_lo2_1 = ksl_product_restf(fine_x, series5f, series5g, series5h + series5h_right_1)
          - (3.8681703e-23f - series5h_right_1) - -1.2733404e-30f,
      series5h_lo = series5h_lo2_1
          + (KSL_MULF(fine_x_cross2_1, series5f) + KSL_MULF(fine_x, series5f_lo)),
      series5i = KSL_MULF(fine_x, series5h),
      series5h_size_1 = 3.8681703e-23f
          + (KSL_MULF(series5c_reach_1, series5g_padded_1)
          + KSL_MULF(fine_far_x_padded_1, series5g_reach_1)),
      series5i_padded_1 = 3.3087225e-24f + series5h_size_1,
      series5i_reach_1 = fabsf(series5h)
          + KSL_MULF(262144.0f, fabsf(series5h_lo) + KSL_MULF(2.4018407e-10f, series5i_padded_1)),
      series5j = series5i + 1.9572942e-20f, series5j_right_1 = series5j - series5i,
      series5j_lo2_1 = ksl_product_restf(fine_x, series5h, series5i, series5j - series5j_right_1)
          + (1.9572942e-20f - series5j_right_1) + -4.6129455e-28f,
      series5j_lo = series5j_lo2_1
          + (KSL_MULF(fine_x_cross2_1, series5h) + KSL_MULF(fine_x, series5h_lo)),
      series5k = KSL_MULF(fine_x, series5j),
      series5j_size_1 = 1.9572942e-20f
          + (KSL_MULF(series5c_reach_1, series5i_padded_1)
          + KSL_MULF(fine_far_x_padded_1, series5i_reach_1)),
      series5k_padded_1 = 3.3087225e-24f + series5j_size_1,
      series5k_reach_1 = fabsf(series5j)
          + KSL_MULF(262144.0f, fabsf(series5j_lo) + KSL_MULF(2.423088e-10f, series5k_padded_1)),
      series5l = series5k - 8.220635e-18f, series5l_right_1 = series5k - series5l,
      series5l_lo2_1 = ksl_product_restf(fine_x, series5j, series5k, series5l + series5l_right_1)
          - (8.220635e-18f - series5l_right_1) - 1.6814781e-25f,
      series5l_lo = series5l_lo2_1
          + (KSL_MULF(fine_x_cross2_1, series5j) + KSL_MULF(fine_x, series5j_lo)),
      series5m = KSL_MULF(fine_x, series5l),
      series5l_size_1 = 8.220635e-18f
          + (KSL_MULF(series5c_reach_1, series5k_padded_1)
          + KSL_MULF(fine_far_x_padded_1, series5k_reach_1)),
      series5m_padded_1 = 3.3087225e-24f + series5l_size_1,
      series5m_reach_1 = fabsf(series5l)
          + KSL_MULF(262144.0f, fabsf(series5l_lo) + KSL_MULF(2.4449753e-10f, series5m_padded_1)),
      series5n = series5m + 2.8114574e-15f, series5n_right_1 = series5n - series5m,
      series5n_lo2_1 = ksl_product_restf(fine_x, series5l, series5m, series5n - series5n_right_1)
          + (2.8114574e-15f - series5n_right_1) + -1.0462085e-22f,
      series5n_lo = series5n_lo2_1
          + (KSL_MULF(fine_x_cross2_1, series5l) + KSL_MULF(fine_x, series5l_lo)),
      series5o = KSL_MULF(fine_x, series5n),
      series5n_size_1 = 2.8114574e-15f
          + (KSL_MULF(series5c_reach_1, series5m_padded_1)
          + KSL_MULF(fine_far_x_padded_1, series5m_reach_1)),
      series5o_padded_1 = 3.3087225e-24f + series5n_size_1,
      series5o_reach_1 = fabsf(series5n)
          + KSL_MULF(262144.0f, fabsf(series5n_lo) + KSL_MULF(2.4675023e-10f, series5o_padded_1)),
      series5p = series5o - 7.6471636e-13f, series5p_right_1 = series5o - series5p,
      series5p_lo2_1 = ksl_product_restf(fine_x, series5n, series5o, series5p + series5p_right_1)
          - (7.6471636e-13f - series5p_right_1) - 1.22007105e-20f,
      series5p_lo = series5p_lo2_1
          + (KSL_MULF(fine_x_cross2_1, series5n) + KSL_MULF(fine_x, series5n_lo)),
      series5q = KSL_MULF(fine_x, series5p),
      series5p_size_1 = 7.6471636e-13f
          + (KSL_MULF(series5c_reach_1, series5o_padded_1)
          + KSL_MULF(fine_far_x_padded_1, series5o_reach_1)),
      series5q_padded_1 = 3.3087225e-24f + series5p_size_1,
      series5q_reach_1 = fabsf(series5p)
          + KSL_MULF(262144.0f, fabsf(series5p_lo) + KSL_MULF(2.4906693e-10f, series5q_padded_1)),
      series5r = series5q + 1.6059044e-10f, series5r_right_1 = series5r - series5q,
      series5r_lo2_1 = ksl_product_restf(fine_x, series5p, series5q, series5r - series5r_right_1)
          + (1.6059044e-10f - series5r_right_1) + -5.3525265e-18f,
      series5r_lo = series5r_lo2_1
          + (KSL_MULF(fine_x_cross2_1, series5p) + KSL_MULF(fine_x, series5p_lo)),
      series5s = KSL_MULF(fine_x, series5r),
      series5r_size_1 = 1.6059044e-10f
          + (KSL_MULF(series5c_reach_1, series5q_padded_1)
          + KSL_MULF(fine_far_x_padded_1, series5q_reach_1)),
      series5s_padded_1 = 3.3087225e-24f + series5r_size_1,
      series5s_reach_1 = fabsf(series5r)
          + KSL_MULF(262144.0f, fabsf(series5r_lo) + KSL_MULF(2.514476e-10f, series5s_padded_1)),
      series5t = series5s - 2.5052108e-08f, series5t_right_1 = series5s - series5t,
      series5t_lo2_1 = ksl_product_restf(fine_x, series5r, series5s, series5t + series5t_right_1)
          - (2.5052108e-08f - series5t_right_1) - 4.417623e-16f,
      series5t_lo = series5t_lo2_1
          + (KSL_MULF(fine_x_cross2_1, series5r) + KSL_MULF(fine_x, series5r_lo)),
      series5u = KSL_MULF(fine_x, series5t),
      series5t_size_1 = 2.5052108e-08f
          + (KSL_MULF(series5c_reach_1, series5s_padded_1)
          + KSL_MULF(fine_far_x_padded_1, series5s_reach_1)),
      series5u_padded_1 = 3.3087225e-24f + series5t_size_1,
      series5u_reach_1 = fabsf(series5t)
          + KSL_MULF(262144.0f, fabsf(series5t_lo) + KSL_MULF(2.538923e-10f, series5u_padded_1)),
      series5v = series5u + 2.7557319e-06f, series5v_right_1 = series5v - series5u,
      series5v_lo2_1 = ksl_product_restf(fine_x, series5t, series5u, series5v - series5v_right_1)
          + (2.7557319e-06f - series5v_right_1) + 3.7935712e-14f,
      series5v_lo = series5v_lo2_1
          + (KSL_MULF(fine_x_cross2_1, series5t) + KSL_MULF(fine_x, series5t_lo)),
      series5w = KSL_MULF(fine_x, series5v),
      series5v_size_1 = 2.7557319e-06f
          + (KSL_MULF(series5c_reach_1, series5u_padded_1)
          + KSL_MULF(fine_far_x_padded_1, series5u_reach_1)),
      series5w_padded_1 = 3.3087225e-24f + series5v_size_1,
      series5w_reach_1 = fabsf(series5v)
          + KSL_MULF(262144.0f, fabsf(series5v_lo) + KSL_MULF(2.5640096e-10f, series5w_padded_1)),
      series5x = series5w - 0.0001984127f, series5x_right_1 = series5w - series5x,
      series5x_lo2_1 = ksl_product_restf(fine_x, series5v, series5w, series5x + series5x_right_1)
          - (0.0001984127f - series5x_right_1) - -2.7255969e-12f,
      series5x_lo = series5x_lo2_1
          + (KSL_MULF(fine_x_cross2_1, series5v) + KSL_MULF(fine_x, series5v_lo)),
      series5y = KSL_MULF(fine_x, series5x),
      series5x_size_1 = 0.0001984127f
          + (KSL_MULF(series5c_reach_1, series5w_padded_1)
          + KSL_MULF(fine_far_x_padded_1, series5w_reach_1)),
      series5y_padded_1 = 3.3087225e-24f + series5x_size_1,
      series5y_reach_1 = fabsf(series5x)
          + KSL_MULF(262144.0f, fabsf(series5x_lo) + KSL_MULF(2.5897362e-10f, series5y_padded_1)),
      series5 = series5y + 0.008333334f, series5_right_1 = series5 - series5y,
      series5_lo2_1 = ksl_product_restf(fine_x, series5x, series5y, series5 - series5_right_1)
          + (0.008333334f - series5_right_1) + -4.346172e-10f,
      series5_lo = series5_lo2_1
          + (KSL_MULF(fine_x_cross2_1, series5x) + KSL_MULF(fine_x, series5x_lo));
  const float fine_g3a = KSL_MULF(fine_x, series5);
  const float series5_size_1 = 0.008333334f
          + (KSL_MULF(series5c_reach_1, series5y_padded_1)
          + KSL_MULF(fine_far_x_padded_1, series5y_reach_1));
  const float fine_g3a_padded_1 = 3.3087225e-24f + series5_size_1,
      fine_g3a_size_3 = KSL_MULF(fine_far_x_padded_1, fabsf(series5)
          + KSL_MULF(262144.0f, fabsf(series5_lo) + KSL_MULF(2.6161032e-10f, fine_g3a_padded_1))),
      fine_g3b = 0.16666667f - fine_g3a, fine_g3b_right_1 = 0.16666667f - fine_g3b,
      fine_g3b_lo1_1 = 0.16666667f - (fine_g3b + fine_g3b_right_1)
          - ksl_product_restf(fine_x, series5, fine_g3a, fine_g3b_right_1),
      fine_g3b_lo = fine_g3b_lo1_1
          - (KSL_MULF(fine_x_cross2_1, series5) + KSL_MULF(fine_x, series5_lo)) + -4.967054e-09f,
      fine_g3b_size_1 = 0.16666667f
          + (KSL_MULF(fine_g3a_padded_1, series5c_reach_1) + fine_g3a_size_3),
      fine_g3 = fine_x < 1.0f ? fine_g3b : fine_closed3,
      fine_g3_lo = fine_x < 1.0f ? fine_g3b_lo : fine_closed3_lo,
      fine_g3_size_4 = fabsf(fine_g3b_lo)
          + KSL_MULF(2.6431096e-10f, 3.3087225e-24f + fine_g3b_size_1)
          + fabsf(fine_g3b - fine_closed3),
      fine_g3_size_5 = fabsf(fine_closed3_lo)
          + KSL_MULF(2.3937835e-10f, 3.3087225e-24f + fine_closed3_size_11) + fine_g3_size_4,
      fine_g3_size_7 = KSL_MULF(3.7977316e+09f, fine_far_x_bound_1 < fine_far_x_size_3 ? 0.0f
          : fine_g3_size_5);
  const float fine_u_0a = KSL_MULF(s->m2, s->m4), fine_u_0a_size_1 = fabsf(s->m2),
      fine_u_0b = KSL_MULF(s->m1, s->m5), fine_u_0b_size_1 = fabsf(s->m1),
      fine_u_0 = fine_u_0a - fine_u_0b, fine_u_right_1 = fine_u_0a - fine_u_0;
  const float fine_u_1a = KSL_MULF(s->m0, s->m5), fine_u_1a_size_1 = fabsf(s->m0),
      fine_u_1b = KSL_MULF(s->m2, s->m3), fine_u_1 = fine_u_1a - fine_u_1b,
      fine_u_right_2 = fine_u_1a - fine_u_1;
  const float fine_u_2a = KSL_MULF(s->m1, s->m3), fine_u_2b = KSL_MULF(s->m0, s->m4),
      fine_u_2 = fine_u_2a - fine_u_2b, fine_u_right_3 = fine_u_2a - fine_u_2;
  const float fine_turned_0 = KSL_MULF(fine_g2, fine_u_0);
  const float fine_u_lo_1 = ksl_product_restf(s->m2, s->m4, fine_u_0a, fine_u_0 + fine_u_right_1)
          - ksl_product_restf(s->m1, s->m5, fine_u_0b, fine_u_right_1);
  const float fine_turned_padded_1 = 3.3087225e-24f
          + KSL_MULF(0.5f, fine_g2a_size_1 + fine_g2a_size_1),
      fine_turned_padded_2 = 3.3087225e-24f
          + (KSL_MULF(fine_u_0a_size_1, halved_size_3) + KSL_MULF(fine_u_0b_size_1, halved_size_5));
  const float fine_turned_1 = KSL_MULF(fine_g2, fine_u_1);
  const float fine_u_lo_2 = ksl_product_restf(s->m0, s->m5, fine_u_1a, fine_u_1 + fine_u_right_2)
          - ksl_product_restf(s->m2, s->m3, fine_u_1b, fine_u_right_2);
  const float fine_turned_padded_3 = 3.3087225e-24f
          + (KSL_MULF(fine_u_1a_size_1, halved_size_5) + KSL_MULF(fine_u_0a_size_1, halved_size_1));
  const float fine_turned_2 = KSL_MULF(fine_g2, fine_u_2);
  const float fine_u_lo_3 = ksl_product_restf(s->m1, s->m3, fine_u_2a, fine_u_2 + fine_u_right_3)
          - ksl_product_restf(s->m0, s->m4, fine_u_2b, fine_u_right_3);
  const float fine_turned_padded_4 = 3.3087225e-24f
          + (KSL_MULF(fine_u_0b_size_1, halved_size_1) + KSL_MULF(fine_u_1a_size_1, halved_size_3));
  const float fine_wv_a = KSL_MULF(s->m0, s->m3), fine_wv_b = KSL_MULF(s->m1, s->m4),
      fine_wv_c = fine_wv_a + fine_wv_b, fine_wv_c_right_1 = fine_wv_c - fine_wv_a,
      fine_wv_c_left_rest_1 = ksl_product_restf(s->m0, s->m3, fine_wv_a, fine_wv_c
          - fine_wv_c_right_1), fine_wv_d = KSL_MULF(s->m2, s->m5), fine_wv = fine_wv_c + fine_wv_d,
      fine_wv_right_1 = fine_wv - fine_wv_c,
      fine_wv_lo1_1 = fine_wv_c - (fine_wv - fine_wv_right_1)
          + ksl_product_restf(s->m2, s->m5, fine_wv_d, fine_wv_right_1),
      fine_wv_lo = fine_wv_lo1_1
          + (fine_wv_c_left_rest_1 + ksl_product_restf(s->m1, s->m4, fine_wv_b, fine_wv_c_right_1));
  const float fine_pitch = KSL_MULF(fine_g3, fine_wv),
      fine_pitch_padded_1 = 3.3087225e-24f
          + ((fine_x < 1.0f ? fine_g3b_size_1 : fine_closed3_size_11) + fine_g3_size_7);
  const float fine_wv_size_1 = KSL_MULF(fine_u_1a_size_1, halved_size_1)
          + KSL_MULF(fine_u_0b_size_1, halved_size_3) + KSL_MULF(fine_u_0a_size_1, halved_size_5);
  const float fine_pitch_padded_2 = 3.3087225e-24f + fine_wv_size_1,
      fine_pitch_reach_1 = fabsf(fine_g3)
          + KSL_MULF(262144.0f, fabsf(fine_g3_lo) + KSL_MULF(2.6431105e-10f, fine_pitch_padded_1)),
      fine_pitch_reach_2 = fabsf(fine_wv)
          + KSL_MULF(262144.0f, fabsf(fine_wv_lo) + KSL_MULF(5.4001725e-13f, fine_pitch_padded_2));
  const float fine_pitch_lo = ksl_product_errorf(fine_g3, fine_wv, fine_pitch)
          + (KSL_MULF(fine_g3_lo, fine_wv) + KSL_MULF(fine_g3, fine_wv_lo)),
      fine_along_0 = KSL_MULF(s->m3, fine_pitch),
      fine_along_padded_1 = 3.3087225e-24f
          + (KSL_MULF(fine_pitch_padded_2, fine_pitch_reach_1)
          + KSL_MULF(fine_pitch_padded_1, fine_pitch_reach_2));
  const float fine_along_1 = KSL_MULF(s->m4, fine_pitch);
  const float fine_along_2 = KSL_MULF(s->m5, fine_pitch);
  const float fine_beta_v_0 = KSL_MULF(s->m3, fine_g2);
  const float fine_beta_v_1 = KSL_MULF(s->m4, fine_g2);
  const float fine_beta_v_2 = KSL_MULF(s->m5, fine_g2);
  const float fine_beta_v_lo_1 = ksl_product_errorf(s->m3, fine_g2, fine_beta_v_0)
          + KSL_MULF(s->m3, fine_g2_cross2_1), fine_m_0 = KSL_MULF(s->m3, fine_beta_v_0),
      fine_m_cross2_1 = KSL_MULF(s->m3, fine_beta_v_lo_1),
      fine_m_padded_1 = 3.3087225e-24f + KSL_MULF(fine_turned_padded_1, halved_size_1),
      fine_m_size_1 = KSL_MULF(fine_m_padded_1, halved_size_1);
  const float fine_beta_v_lo_2 = ksl_product_errorf(s->m4, fine_g2, fine_beta_v_1)
          + KSL_MULF(s->m4, fine_g2_cross2_1), fine_m_1 = KSL_MULF(s->m4, fine_beta_v_1),
      fine_m_cross2_2 = KSL_MULF(s->m4, fine_beta_v_lo_2),
      fine_m_padded_2 = 3.3087225e-24f + KSL_MULF(fine_turned_padded_1, halved_size_3),
      fine_m_size_2 = KSL_MULF(fine_m_padded_2, halved_size_3);
  const float fine_m_2 = KSL_MULF(s->m5, fine_beta_v_2),
      fine_m_cross2_3 = KSL_MULF(s->m5, ksl_product_errorf(s->m5, fine_g2, fine_beta_v_2)
          + KSL_MULF(s->m5, fine_g2_cross2_1)),
      fine_m_size_3 = KSL_MULF(3.3087225e-24f
          + KSL_MULF(fine_turned_padded_1, halved_size_5), halved_size_5);
  const float fine_m_3 = KSL_MULF(s->m4, fine_beta_v_0),
      fine_m_cross2_4 = KSL_MULF(s->m4, fine_beta_v_lo_1);
  const float fine_m_4 = KSL_MULF(s->m5, fine_beta_v_0),
      fine_m_cross2_5 = KSL_MULF(s->m5, fine_beta_v_lo_1);
  const float fine_m_5 = KSL_MULF(s->m5, fine_beta_v_1),
      fine_m_cross2_6 = KSL_MULF(s->m5, fine_beta_v_lo_2);
  const float fine_others_0 = fine_m_1 + fine_m_2, fine_others_right_1 = fine_others_0 - fine_m_1,
      fine_others_left_rest_1 = ksl_product_restf(s->m4, fine_beta_v_1, fine_m_1, fine_others_0
          - fine_others_right_1),
      fine_others_lo1_1 = fine_others_left_rest_1
          + ksl_product_restf(s->m5, fine_beta_v_2, fine_m_2, fine_others_right_1),
      fine_others_lo_1 = fine_others_lo1_1 + (fine_m_cross2_2 + fine_m_cross2_3),
      fine_others_size_1 = fine_m_size_2 + fine_m_size_3;
  const float fine_others_1 = fine_m_0 + fine_m_2, fine_others_right_2 = fine_others_1 - fine_m_0,
      fine_others_left_rest_2 = ksl_product_restf(s->m3, fine_beta_v_0, fine_m_0, fine_others_1
          - fine_others_right_2),
      fine_others_lo1_2 = fine_others_left_rest_2
          + ksl_product_restf(s->m5, fine_beta_v_2, fine_m_2, fine_others_right_2),
      fine_others_lo_2 = fine_others_lo1_2 + (fine_m_cross2_1 + fine_m_cross2_3),
      fine_others_size_2 = fine_m_size_1 + fine_m_size_3;
  const float fine_others_2 = fine_m_0 + fine_m_1, fine_others_right_3 = fine_others_2 - fine_m_0,
      fine_others_left_rest_3 = ksl_product_restf(s->m3, fine_beta_v_0, fine_m_0, fine_others_2
          - fine_others_right_3),
      fine_others_lo1_3 = fine_others_left_rest_3
          + ksl_product_restf(s->m4, fine_beta_v_1, fine_m_1, fine_others_right_3),
      fine_others_lo_3 = fine_others_lo1_3 + (fine_m_cross2_1 + fine_m_cross2_2),
      fine_others_size_3 = fine_m_size_1 + fine_m_size_2;
  const float fine_diagonal0a = 1.0f - fine_others_0,
      fine_diagonal0a_right_1 = 1.0f - fine_diagonal0a,
      fine_diagonal0a_lo = 1.0f - (fine_diagonal0a + fine_diagonal0a_right_1)
          - (fine_others_0 - fine_diagonal0a_right_1) - fine_others_lo_1,
      fine_diagonal0a_size_1 = 1.0f + fine_others_size_1, fine_diagonal0b = fine_g0 + fine_m_0,
      fine_diagonal0b_right_1 = fine_diagonal0b - fine_g0,
      fine_diagonal0b_right_rest_1 = ksl_product_restf(s->m3, fine_beta_v_0, fine_m_0,
          fine_diagonal0b_right_1),
      fine_diagonal0b_lo = fine_g0 - (fine_diagonal0b - fine_diagonal0b_right_1)
          + fine_diagonal0b_right_rest_1 + fine_m_cross2_1 + fine_g0_lo,
      fine_diagonal0b_size_1 = fine_g0_size_1 + fine_m_size_1,
      fine_diagonal0_error_1 = fabsf(ksl_product_errorf(s->m3, fine_beta_v_0, fine_m_0)
          + fine_m_cross2_1),
      fine_diagonal0_bound_2 = fabsf(fine_others_lo_1)
          + KSL_MULF(2.369181e-10f, 3.3087225e-24f + fine_others_size_1),
      fine_diagonal0_bound_3 = fabsf(fine_diagonal0b_lo)
          + KSL_MULF(2.369181e-10f, 3.3087225e-24f + fine_diagonal0b_size_1),
      fine_diagonal0_bound_4 = fabsf(fine_diagonal0a_lo)
          + KSL_MULF(2.374164e-10f, 3.3087225e-24f + fine_diagonal0a_size_1),
      fine_diagonal0_size_9 = fine_diagonal0_bound_4
          + (fine_diagonal0_bound_3 + fabsf(fine_diagonal0b - fine_diagonal0a)),
      fine_diagonal0_size_2 = fine_diagonal0_error_1
          + KSL_MULF(2.3644112e-10f, 3.3087225e-24f + fine_m_size_1) + fine_diagonal0_bound_2,
      fine_diagonal0_size_11 = KSL_MULF(4.2190973e+09f, fine_diagonal0_size_2
          < fabsf(fine_m_0 - fine_others_0) ? 0.0f : fine_diagonal0_size_9);
  const float fine_diagonal1a = 1.0f - fine_others_1,
      fine_diagonal1a_right_1 = 1.0f - fine_diagonal1a,
      fine_diagonal1a_lo = 1.0f - (fine_diagonal1a + fine_diagonal1a_right_1)
          - (fine_others_1 - fine_diagonal1a_right_1) - fine_others_lo_2,
      fine_diagonal1a_size_1 = 1.0f + fine_others_size_2, fine_diagonal1b = fine_g0 + fine_m_1,
      fine_diagonal1b_right_1 = fine_diagonal1b - fine_g0,
      fine_diagonal1b_right_rest_1 = ksl_product_restf(s->m4, fine_beta_v_1, fine_m_1,
          fine_diagonal1b_right_1),
      fine_diagonal1b_lo = fine_g0 - (fine_diagonal1b - fine_diagonal1b_right_1)
          + fine_diagonal1b_right_rest_1 + fine_m_cross2_2 + fine_g0_lo,
      fine_diagonal1b_size_1 = fine_g0_size_1 + fine_m_size_2,
      fine_diagonal1_error_1 = fabsf(ksl_product_errorf(s->m4, fine_beta_v_1, fine_m_1)
          + fine_m_cross2_2),
      fine_diagonal1_bound_2 = fabsf(fine_others_lo_2)
          + KSL_MULF(2.369181e-10f, 3.3087225e-24f + fine_others_size_2),
      fine_diagonal1_bound_3 = fabsf(fine_diagonal1b_lo)
          + KSL_MULF(2.369181e-10f, 3.3087225e-24f + fine_diagonal1b_size_1),
      fine_diagonal1_bound_4 = fabsf(fine_diagonal1a_lo)
          + KSL_MULF(2.374164e-10f, 3.3087225e-24f + fine_diagonal1a_size_1),
      fine_diagonal1_size_9 = fine_diagonal1_bound_4
          + (fine_diagonal1_bound_3 + fabsf(fine_diagonal1b - fine_diagonal1a)),
      fine_diagonal1_size_2 = fine_diagonal1_error_1
          + KSL_MULF(2.3644112e-10f, 3.3087225e-24f + fine_m_size_2) + fine_diagonal1_bound_2,
      fine_diagonal1_size_11 = KSL_MULF(4.2190973e+09f, fine_diagonal1_size_2
          < fabsf(fine_m_1 - fine_others_1) ? 0.0f : fine_diagonal1_size_9);
  const float fine_diagonal2a = 1.0f - fine_others_2,
      fine_diagonal2a_right_1 = 1.0f - fine_diagonal2a,
      fine_diagonal2a_lo = 1.0f - (fine_diagonal2a + fine_diagonal2a_right_1)
          - (fine_others_2 - fine_diagonal2a_right_1) - fine_others_lo_3,
      fine_diagonal2a_size_1 = 1.0f + fine_others_size_3, fine_diagonal2b = fine_g0 + fine_m_2,
      fine_diagonal2b_right_1 = fine_diagonal2b - fine_g0,
      fine_diagonal2b_right_rest_1 = ksl_product_restf(s->m5, fine_beta_v_2, fine_m_2,
          fine_diagonal2b_right_1),
      fine_diagonal2b_lo = fine_g0 - (fine_diagonal2b - fine_diagonal2b_right_1)
          + fine_diagonal2b_right_rest_1 + fine_m_cross2_3 + fine_g0_lo,
      fine_diagonal2b_size_1 = fine_g0_size_1 + fine_m_size_3,
      fine_diagonal2_error_1 = fabsf(ksl_product_errorf(s->m5, fine_beta_v_2, fine_m_2)
          + fine_m_cross2_3),
      fine_diagonal2_bound_2 = fabsf(fine_others_lo_3)
          + KSL_MULF(2.369181e-10f, 3.3087225e-24f + fine_others_size_3),
      fine_diagonal2_bound_3 = fabsf(fine_diagonal2b_lo)
          + KSL_MULF(2.369181e-10f, 3.3087225e-24f + fine_diagonal2b_size_1),
      fine_diagonal2_bound_4 = fabsf(fine_diagonal2a_lo)
          + KSL_MULF(2.374164e-10f, 3.3087225e-24f + fine_diagonal2a_size_1),
      fine_diagonal2_size_9 = fine_diagonal2_bound_4
          + (fine_diagonal2_bound_3 + fabsf(fine_diagonal2b - fine_diagonal2a)),
      fine_diagonal2_size_2 = fine_diagonal2_error_1
          + KSL_MULF(2.3644112e-10f, 3.3087225e-24f + fine_m_size_3) + fine_diagonal2_bound_2,
      fine_diagonal2_size_11 = KSL_MULF(4.2190973e+09f, fine_diagonal2_size_2
          < fabsf(fine_m_2 - fine_others_2) ? 0.0f : fine_diagonal2_size_9);
  const float fine_g1_lo = ksl_product_errorf(c, sinc, fine_g1) + fine_g1_cross_1,
      fine_alpha_v_0 = KSL_MULF(s->m3, fine_g1),
      fine_alpha_v_cross2_1 = KSL_MULF(s->m3, fine_g1_lo),
      fine_alpha_v_padded_1 = 3.3087225e-24f + fine_g1_size_5;
  const float fine_alpha_v_1 = KSL_MULF(s->m4, fine_g1),
      fine_alpha_v_cross2_2 = KSL_MULF(s->m4, fine_g1_lo);
  const float fine_alpha_v_2 = KSL_MULF(s->m5, fine_g1),
      fine_alpha_v_cross2_3 = KSL_MULF(s->m5, fine_g1_lo);
  const float fine_across_axis_0 = fine_turned_0 + fine_along_0,
      fine_across_axis_right_1 = fine_across_axis_0 - fine_turned_0,
      fine_across_axis_left_rest_1 = ksl_product_restf(fine_g2, fine_u_0, fine_turned_0,
          fine_across_axis_0 - fine_across_axis_right_1),
      fine_across_axis_lo1_1 = fine_across_axis_left_rest_1
          + ksl_product_restf(s->m3, fine_pitch, fine_along_0, fine_across_axis_right_1),
      fine_across_axis_cross_1 = KSL_MULF(fine_g2_cross2_1, fine_u_0)
          + KSL_MULF(fine_g2, fine_u_lo_1) + KSL_MULF(s->m3, fine_pitch_lo);
  const float fine_across_axis_1 = fine_turned_1 + fine_along_1,
      fine_across_axis_right_2 = fine_across_axis_1 - fine_turned_1,
      fine_across_axis_left_rest_2 = ksl_product_restf(fine_g2, fine_u_1, fine_turned_1,
          fine_across_axis_1 - fine_across_axis_right_2),
      fine_across_axis_lo1_2 = fine_across_axis_left_rest_2
          + ksl_product_restf(s->m4, fine_pitch, fine_along_1, fine_across_axis_right_2),
      fine_across_axis_cross_2 = KSL_MULF(fine_g2_cross2_1, fine_u_1)
          + KSL_MULF(fine_g2, fine_u_lo_2) + KSL_MULF(s->m4, fine_pitch_lo);
  const float fine_across_axis_2 = fine_turned_2 + fine_along_2,
      fine_across_axis_right_3 = fine_across_axis_2 - fine_turned_2,
      fine_across_axis_left_rest_3 = ksl_product_restf(fine_g2, fine_u_2, fine_turned_2,
          fine_across_axis_2 - fine_across_axis_right_3),
      fine_across_axis_lo1_3 = fine_across_axis_left_rest_3
          + ksl_product_restf(s->m5, fine_pitch, fine_along_2, fine_across_axis_right_3),
      fine_across_axis_cross_3 = KSL_MULF(fine_g2_cross2_1, fine_u_2)
          + KSL_MULF(fine_g2, fine_u_lo_3) + KSL_MULF(s->m5, fine_pitch_lo);
  const float fine_D_01 = fine_m_3 - fine_alpha_v_2, fine_D_right_1 = fine_m_3 - fine_D_01,
      fine_D_left_rest_1 = ksl_product_restf(s->m4, fine_beta_v_0, fine_m_3, fine_D_01
          + fine_D_right_1);
  const float fine_D_02 = fine_m_4 + fine_alpha_v_1, fine_D_right_2 = fine_D_02 - fine_m_4,
      fine_D_left_rest_2 = ksl_product_restf(s->m5, fine_beta_v_0, fine_m_4, fine_D_02
          - fine_D_right_2);
  const float fine_D_03a = KSL_MULF(s->m0, fine_g1), fine_D_03 = fine_D_03a + fine_across_axis_0,
      fine_D_right_3 = fine_D_03 - fine_D_03a,
      fine_D_lo1_3 = ksl_product_restf(s->m0, fine_g1, fine_D_03a, fine_D_03 - fine_D_right_3)
          + (fine_across_axis_0 - fine_D_right_3);
  const float fine_across_axis_size_1 = KSL_MULF(fine_along_padded_1, halved_size_1)
          + KSL_MULF(fine_turned_padded_1, fine_turned_padded_2);
  const float fine_D_10 = fine_m_3 + fine_alpha_v_2, fine_D_right_4 = fine_D_10 - fine_m_3,
      fine_D_left_rest_4 = ksl_product_restf(s->m4, fine_beta_v_0, fine_m_3, fine_D_10
          - fine_D_right_4);
  const float fine_D_12 = fine_m_5 - fine_alpha_v_0, fine_D_right_5 = fine_m_5 - fine_D_12,
      fine_D_left_rest_5 = ksl_product_restf(s->m5, fine_beta_v_1, fine_m_5, fine_D_12
          + fine_D_right_5);
  const float fine_D_13a = KSL_MULF(s->m1, fine_g1), fine_D_13 = fine_D_13a + fine_across_axis_1,
      fine_D_right_6 = fine_D_13 - fine_D_13a,
      fine_D_lo1_6 = ksl_product_restf(s->m1, fine_g1, fine_D_13a, fine_D_13 - fine_D_right_6)
          + (fine_across_axis_1 - fine_D_right_6);
  const float fine_across_axis_size_2 = KSL_MULF(fine_along_padded_1, halved_size_3)
          + KSL_MULF(fine_turned_padded_1, fine_turned_padded_3);
  const float fine_D_20 = fine_m_4 - fine_alpha_v_1, fine_D_right_7 = fine_m_4 - fine_D_20,
      fine_D_left_rest_7 = ksl_product_restf(s->m5, fine_beta_v_0, fine_m_4, fine_D_20
          + fine_D_right_7);
  const float fine_D_21 = fine_m_5 + fine_alpha_v_0, fine_D_right_8 = fine_D_21 - fine_m_5,
      fine_D_left_rest_8 = ksl_product_restf(s->m5, fine_beta_v_1, fine_m_5, fine_D_21
          - fine_D_right_8);
  const float fine_D_23a = KSL_MULF(s->m2, fine_g1), fine_D_23 = fine_D_23a + fine_across_axis_2,
      fine_D_right_9 = fine_D_23 - fine_D_23a,
      fine_D_lo1_9 = ksl_product_restf(s->m2, fine_g1, fine_D_23a, fine_D_23 - fine_D_right_9)
          + (fine_across_axis_2 - fine_D_right_9);
  const float fine_across_axis_size_3 = KSL_MULF(fine_along_padded_1, halved_size_5)
          + KSL_MULF(fine_turned_padded_1, fine_turned_padded_4);
  const float diagonal0_apart_1 = (fine_m_0 < fine_others_0 ? fine_diagonal0b : fine_diagonal0a)
          - diagonal0,
      diagonal0_padded_1 = 3.3087225e-24f
          + ((fine_m_0 < fine_others_0 ? fine_diagonal0b_size_1 : fine_diagonal0a_size_1)
          + fine_diagonal0_size_11),
      diagonal0_error_2 = KSL_MULF(1.0000005f, fabsf(diagonal0_apart_1
          + (fine_m_0 < fine_others_0 ? fine_diagonal0b_lo : fine_diagonal0a_lo)));
  const float fine_D_lo_1 = fine_D_left_rest_1
          - ksl_product_restf(s->m5, fine_g1, fine_alpha_v_2, fine_D_right_1)
          + (fine_m_cross2_4 - fine_alpha_v_cross2_3);
  const float D_rest_1 = KSL_MULF(2.369181e-10f, 3.3087225e-24f
          + (KSL_MULF(fine_alpha_v_padded_1, halved_size_5)
          + KSL_MULF(fine_m_padded_1, halved_size_3)));
  const float fine_D_lo_2 = fine_D_left_rest_2
          + ksl_product_restf(s->m4, fine_g1, fine_alpha_v_1, fine_D_right_2)
          + (fine_m_cross2_5 + fine_alpha_v_cross2_2);
  const float D_rest_2 = KSL_MULF(2.369181e-10f, 3.3087225e-24f
          + (KSL_MULF(fine_alpha_v_padded_1, halved_size_3)
          + KSL_MULF(fine_m_padded_1, halved_size_5))),
      D_error_5 = fabsf(fine_D_03 - D_03
          + (fine_D_lo1_3 + (fine_across_axis_lo1_1 + fine_across_axis_cross_1)
          + KSL_MULF(s->m0, fine_g1_lo))),
      D_rest_3 = KSL_MULF(2.6786656e-10f, 3.3087225e-24f
          + (KSL_MULF(fine_alpha_v_padded_1, fine_u_1a_size_1) + fine_across_axis_size_1));
  const float fine_D_lo_4 = fine_D_left_rest_4
          + ksl_product_restf(s->m5, fine_g1, fine_alpha_v_2, fine_D_right_4)
          + (fine_m_cross2_4 + fine_alpha_v_cross2_3);
  const float diagonal1_apart_1 = (fine_m_1 < fine_others_1 ? fine_diagonal1b : fine_diagonal1a)
          - diagonal1,
      diagonal1_padded_1 = 3.3087225e-24f
          + ((fine_m_1 < fine_others_1 ? fine_diagonal1b_size_1 : fine_diagonal1a_size_1)
          + fine_diagonal1_size_11),
      diagonal1_error_2 = KSL_MULF(1.0000005f, fabsf(diagonal1_apart_1
          + (fine_m_1 < fine_others_1 ? fine_diagonal1b_lo : fine_diagonal1a_lo)));
  const float fine_D_lo_5 = fine_D_left_rest_5
          - ksl_product_restf(s->m3, fine_g1, fine_alpha_v_0, fine_D_right_5)
          + (fine_m_cross2_6 - fine_alpha_v_cross2_1);
  const float D_rest_4 = KSL_MULF(2.369181e-10f, 3.3087225e-24f
          + (KSL_MULF(fine_alpha_v_padded_1, halved_size_1)
          + KSL_MULF(fine_m_padded_2, halved_size_5))),
      D_error_11 = fabsf(fine_D_13 - D_13
          + (fine_D_lo1_6 + (fine_across_axis_lo1_2 + fine_across_axis_cross_2)
          + KSL_MULF(s->m1, fine_g1_lo))),
      D_rest_5 = KSL_MULF(2.6786656e-10f, 3.3087225e-24f
          + (KSL_MULF(fine_alpha_v_padded_1, fine_u_0b_size_1) + fine_across_axis_size_2));
  const float fine_D_lo_7 = fine_D_left_rest_7
          - ksl_product_restf(s->m4, fine_g1, fine_alpha_v_1, fine_D_right_7)
          + (fine_m_cross2_5 - fine_alpha_v_cross2_2);
  const float fine_D_lo_8 = fine_D_left_rest_8
          + ksl_product_restf(s->m3, fine_g1, fine_alpha_v_0, fine_D_right_8)
          + (fine_m_cross2_6 + fine_alpha_v_cross2_1);
  const float diagonal2_apart_1 = (fine_m_2 < fine_others_2 ? fine_diagonal2b : fine_diagonal2a)
          - diagonal2,
      diagonal2_padded_1 = 3.3087225e-24f
          + ((fine_m_2 < fine_others_2 ? fine_diagonal2b_size_1 : fine_diagonal2a_size_1)
          + fine_diagonal2_size_11),
      diagonal2_error_2 = KSL_MULF(1.0000005f, fabsf(diagonal2_apart_1
          + (fine_m_2 < fine_others_2 ? fine_diagonal2b_lo : fine_diagonal2a_lo))),
      D_error_17 = fabsf(fine_D_23 - D_23
          + (fine_D_lo1_9 + (fine_across_axis_lo1_3 + fine_across_axis_cross_3)
          + KSL_MULF(s->m2, fine_g1_lo))),
      D_rest_6 = KSL_MULF(2.6786656e-10f, 3.3087225e-24f
          + (KSL_MULF(fine_alpha_v_padded_1, fine_u_0a_size_1) + fine_across_axis_size_3)),
      diagonal0_bound_1 = diagonal0_error_2 + KSL_MULF(2.3741648e-10f, diagonal0_padded_1),
      D_bound_1 = KSL_MULF(1.0000005f, fabsf(fine_D_01 - D_01 + fine_D_lo_1)) + D_rest_1,
      D_bound_2 = KSL_MULF(1.0000005f, fabsf(fine_D_02 - D_02 + fine_D_lo_2)) + D_rest_2,
      D_bound_3 = KSL_MULF(1.0000005f, D_error_5) + D_rest_3,
      D_bound_4 = KSL_MULF(1.0000005f, fabsf(fine_D_10 - D_10 + fine_D_lo_4)) + D_rest_1,
      diagonal1_bound_1 = diagonal1_error_2 + KSL_MULF(2.3741648e-10f, diagonal1_padded_1),
      D_bound_5 = KSL_MULF(1.0000005f, fabsf(fine_D_12 - D_12 + fine_D_lo_5)) + D_rest_4,
      D_bound_6 = KSL_MULF(1.0000005f, D_error_11) + D_rest_5,
      D_bound_7 = KSL_MULF(1.0000005f, fabsf(fine_D_20 - D_20 + fine_D_lo_7)) + D_rest_2,
      D_bound_8 = KSL_MULF(1.0000005f, fabsf(fine_D_21 - D_21 + fine_D_lo_8)) + D_rest_4,
      diagonal2_bound_1 = diagonal2_error_2 + KSL_MULF(2.3741648e-10f, diagonal2_padded_1),
      D_bound_9 = KSL_MULF(1.0000005f, D_error_17) + D_rest_6;
  D->m00 = diagonal0;
  D->m01 = D_01;
  D->m02 = D_02;
  D->m03 = D_03;
  D->m10 = D_10;
  D->m11 = diagonal1;
  D->m12 = D_12;
  D->m13 = D_13;
  D->m20 = D_20;
  D->m21 = D_21;
  D->m22 = diagonal2;
  D->m23 = D_23;
  D_bound->m00 = diagonal0_bound_1;
  D_bound->m01 = D_bound_1;
  D_bound->m02 = D_bound_2;
  D_bound->m03 = D_bound_3;
  D_bound->m10 = D_bound_4;
  D_bound->m11 = diagonal1_bound_1;
  D_bound->m12 = D_bound_5;
  D_bound->m13 = D_bound_6;
  D_bound->m20 = D_bound_7;
  D_bound->m21 = D_bound_8;
  D_bound->m22 = diagonal2_bound_1;
  D_bound->m23 = D_bound_9;
}

/* so with exp so = D, |ω| <= π: (J_l(ω)^-1 t; ω), ω = log R; |error of so| <= so_bound unless
     inf or NaN.
   D: displacement [R | t], R rotation, t in m; so, so_bound: screw (v in m/s; ω in rad/s).
   558 mul, 921 add, 29 product error, 36 product rest, 47 div, 5 sqrt, 15 neg, 155 abs, 6
     copysign, 72 less, 10 equal, 171 select. */
static inline void ksl_SE3f_log_certified(const ksl_SE3f_t *D, ksl_screwf_t *so,
    ksl_screwf_t *so_bound) {
  const float p_0 = D->m21 - D->m12;
  const float p_1 = D->m02 - D->m20;
  const float p_2 = D->m10 - D->m01;
  const float s_0 = D->m12 + D->m21;
  const float s_1 = D->m02 + D->m20;
  const float s_2 = D->m01 + D->m10;
  const float first_0 = D->m00 + 1.0f;
  const float first_1 = 1.0f - D->m00;
  const float others_0 = D->m11 + D->m22;
  const float others_1 = D->m11 - D->m22;
  const float d_0 = first_0 + others_0;
  const float d_1 = first_0 - others_0;
  const float d_2 = first_1 + others_1;
  const float d_3 = first_1 - others_1;
  const float low_0 = D->m11 < D->m00 ? d_1 : s_2;
  const float low_1 = D->m11 < D->m00 ? s_2 : d_2;
  const float low_2 = D->m11 < D->m00 ? s_1 : s_0;
  const float low_3 = D->m11 < D->m00 ? p_0 : p_1;
  const float high_0a = -D->m11, high_0 = D->m00 < high_0a ? s_1 : p_0;
  const float high_1 = D->m00 < high_0a ? s_0 : p_1;
  const float high_2 = D->m00 < high_0a ? d_3 : p_2;
  const float high_3 = D->m00 < high_0a ? p_2 : d_0;
  const float column_0 = D->m22 < 0.0f ? low_0 : high_0;
  const float column_1 = D->m22 < 0.0f ? low_1 : high_1;
  const float column_2 = D->m22 < 0.0f ? low_2 : high_2;
  const float column_3 = D->m22 < 0.0f ? low_3 : high_3;
  const float upper_0a = -column_0, upper_0 = column_3 < 0.0f ? upper_0a : column_0;
  const float upper_1a = -column_1, upper_1 = column_3 < 0.0f ? upper_1a : column_1;
  const float upper_2a = -column_2, upper_2 = column_3 < 0.0f ? upper_2a : column_2;
  const float upper_3a = -column_3, upper_3 = column_3 < 0.0f ? upper_3a : column_3;
  const float v_s_size_0 = fabsf(upper_0);
  const float v_s_size_1 = fabsf(upper_1);
  const float v_s_size_2 = fabsf(upper_2);
  const float v_s_largest1 = v_s_size_0 < v_s_size_1 ? v_s_size_1 : v_s_size_0;
  const float v_s_largest2 = v_s_largest1 < v_s_size_2 ? v_s_size_2 : v_s_largest1;
  const float v_s_b = 4.611686e+18f < v_s_largest2 ? 2.7105054e-20f : 1.0f,
      v_s_d = v_s_largest2 < 256.0f ? 1.8014399e+16f : v_s_b,
      v_s = v_s_largest2 < 1.4210855e-14f ? 3.2451855e+32f : v_s_d;
  const float v_y_0 = KSL_MULF(upper_0, v_s);
  const float v_y_1 = KSL_MULF(upper_1, v_s);
  const float v_y_2 = KSL_MULF(upper_2, v_s);
  const float v_n = sqrtf(KSL_MULF(v_y_0, v_y_0) + KSL_MULF(v_y_1, v_y_1) + KSL_MULF(v_y_2, v_y_2));
  const float v_r_b = v_s < 1.0f ? 3.689349e+19f : 1.0f, v_r_d = 1.0f < v_s ? 5.551115e-17f : v_r_b,
      v_r = 1.8014399e+16f < v_s ? 3.081488e-33f : v_r_d;
  const float n = KSL_MULF(v_n, v_r);
  const float half = ksl_atan2f(n, upper_3);
  const float divisor = n == 0.0f ? 1.0f : n;
  const float theta = KSL_MULF(2.0f, half);
  const float k = theta / divisor;
  const float vector_0 = KSL_MULF(upper_0, k);
  const float vector_1 = KSL_MULF(upper_1, k);
  const float vector_2 = KSL_MULF(upper_2, k);
  const float x = KSL_MULF(theta, theta);
  const float far_sine = x < 1.0f ? 1.0f : n;
  const float cotangent = upper_3 / far_sine;
  const float half_cotangent = KSL_MULF(KSL_MULF(0.5f, theta), cotangent);
  const float b_rest = 1.0f - half_cotangent;
  const float b_divisor = x < 4.0f ? 4.0f : x;
  const float closed_b = b_rest / b_divisor;
  const float b_h = KSL_MULF(x, KSL_MULF(x, KSL_MULF(x, KSL_MULF(1.4551725e-27f, x)
          + 5.744791e-26f) + 2.2679524e-24f) + 8.9535176e-23f) + 3.534707e-21f,
      b_q = KSL_MULF(x, KSL_MULF(x, KSL_MULF(x, KSL_MULF(x, KSL_MULF(x, b_h) + 1.3954465e-19f)
          + 5.509003e-18f) + 2.1748687e-16f) + 8.586062e-15f),
      b_z = KSL_MULF(x, KSL_MULF(x, KSL_MULF(x, KSL_MULF(x, b_q + 3.3896803e-13f) + 1.3382536e-11f)
          + 5.2841903e-10f) + 2.0876756e-08f) + 8.267196e-07f,
      b_af = KSL_MULF(x, KSL_MULF(x, KSL_MULF(x, b_z) + 3.3068784e-05f) + 0.0013888889f)
          + 0.083333336f, b = x < 4.0f ? b_af : closed_b;
  const float b_across_b = 1.0f - KSL_MULF(x, b), b_across = x < 4.0f ? b_across_b : half_cotangent;
  const float wt = KSL_MULF(D->m03, vector_0) + KSL_MULF(D->m13, vector_1)
          + KSL_MULF(D->m23, vector_2);
  const float pitch = KSL_MULF(b, wt);
  const float along_0 = KSL_MULF(vector_0, pitch);
  const float along_1 = KSL_MULF(vector_1, pitch);
  const float along_2 = KSL_MULF(vector_2, pitch);
  const float u_0 = KSL_MULF(D->m23, vector_1) - KSL_MULF(D->m13, vector_2);
  const float u_1 = KSL_MULF(D->m03, vector_2) - KSL_MULF(D->m23, vector_0);
  const float u_2 = KSL_MULF(D->m13, vector_0) - KSL_MULF(D->m03, vector_1);
  const float turned_0 = KSL_MULF(0.5f, u_0);
  const float turned_1 = KSL_MULF(0.5f, u_1);
  const float turned_2 = KSL_MULF(0.5f, u_2);
  const float across_axis_0 = along_0 - turned_0;
  const float across_axis_1 = along_1 - turned_1;
  const float across_axis_2 = along_2 - turned_2;
  const float so_0 = KSL_MULF(D->m03, b_across) + across_axis_0;
  const float so_1 = KSL_MULF(D->m13, b_across) + across_axis_1;
  const float so_2 = KSL_MULF(D->m23, b_across) + across_axis_2;
  const float fine_p_0 = D->m21 - D->m12, fine_p_right_1 = D->m21 - fine_p_0,
      fine_p_lo_1 = D->m21 - (fine_p_0 + fine_p_right_1) - (D->m12 - fine_p_right_1),
      fine_p_size_3 = fabsf(D->m21) + fabsf(D->m12);
  const float fine_p_1 = D->m02 - D->m20, fine_p_right_2 = D->m02 - fine_p_1,
      fine_p_lo_2 = D->m02 - (fine_p_1 + fine_p_right_2) - (D->m20 - fine_p_right_2),
      fine_p_size_6 = fabsf(D->m02) + fabsf(D->m20);
  const float fine_p_2 = D->m10 - D->m01, fine_p_right_3 = D->m10 - fine_p_2,
      fine_p_lo_3 = D->m10 - (fine_p_2 + fine_p_right_3) - (D->m01 - fine_p_right_3),
      fine_p_size_9 = fabsf(D->m10) + fabsf(D->m01);
  const float fine_s_0 = D->m12 + D->m21, fine_s_right_1 = fine_s_0 - D->m12,
      fine_s_lo_1 = D->m12 - (fine_s_0 - fine_s_right_1) + (D->m21 - fine_s_right_1);
  const float fine_s_1 = D->m02 + D->m20, fine_s_right_2 = fine_s_1 - D->m02,
      fine_s_lo_2 = D->m02 - (fine_s_1 - fine_s_right_2) + (D->m20 - fine_s_right_2);
  const float fine_s_2 = D->m01 + D->m10, fine_s_right_3 = fine_s_2 - D->m01,
      fine_s_lo_3 = D->m01 - (fine_s_2 - fine_s_right_3) + (D->m10 - fine_s_right_3);
  const float fine_first_0 = D->m00 + 1.0f, fine_first_right_1 = fine_first_0 - D->m00,
      fine_first_lo_1 = D->m00 - (fine_first_0 - fine_first_right_1) + (1.0f - fine_first_right_1);
  const float fine_first_1 = 1.0f - D->m00, fine_first_right_2 = 1.0f - fine_first_1,
      fine_first_lo_2 = 1.0f - (fine_first_1 + fine_first_right_2) - (D->m00 - fine_first_right_2);
  const float fine_others_0 = D->m11 + D->m22, fine_others_right_1 = fine_others_0 - D->m11,
      fine_others_lo_1 = D->m11 - (fine_others_0 - fine_others_right_1)
          + (D->m22 - fine_others_right_1);
  const float fine_others_1 = D->m11 - D->m22, fine_others_right_2 = D->m11 - fine_others_1,
      fine_others_lo_2 = D->m11 - (fine_others_1 + fine_others_right_2)
          - (D->m22 - fine_others_right_2);
  const float fine_d_0 = fine_first_0 + fine_others_0, fine_d_right_1 = fine_d_0 - fine_first_0,
      fine_d_lo_1 = fine_first_0 - (fine_d_0 - fine_d_right_1) + (fine_others_0 - fine_d_right_1)
          + fine_others_lo_1 + fine_first_lo_1,
      fine_d_size_1 = 1.0f + fabsf(D->m00) + (fabsf(D->m11) + fabsf(D->m22));
  const float fine_d_1 = fine_first_0 - fine_others_0, fine_d_right_2 = fine_first_0 - fine_d_1,
      fine_d_lo_2 = fine_first_0 - (fine_d_1 + fine_d_right_2) - (fine_others_0 - fine_d_right_2)
          - fine_others_lo_1 + fine_first_lo_1;
  const float fine_d_2 = fine_first_1 + fine_others_1, fine_d_right_3 = fine_d_2 - fine_first_1,
      fine_d_lo_3 = fine_first_1 - (fine_d_2 - fine_d_right_3) + (fine_others_1 - fine_d_right_3)
          + fine_others_lo_2 + fine_first_lo_2;
  const float fine_d_3 = fine_first_1 - fine_others_1, fine_d_right_4 = fine_first_1 - fine_d_3,
      fine_d_lo_4 = fine_first_1 - (fine_d_3 + fine_d_right_4) - (fine_others_1 - fine_d_right_4)
          - fine_others_lo_2 + fine_first_lo_2;
  const float fine_low_0 = D->m11 < D->m00 ? fine_d_1 : fine_s_2,
      fine_low_lo_1 = D->m11 < D->m00 ? fine_d_lo_2 : fine_s_lo_3,
      fine_low_size_1 = D->m11 < D->m00 ? fine_d_size_1 : fine_p_size_9;
  const float fine_low_1 = D->m11 < D->m00 ? fine_s_2 : fine_d_2,
      fine_low_lo_2 = D->m11 < D->m00 ? fine_s_lo_3 : fine_d_lo_3,
      fine_low_size_2 = D->m11 < D->m00 ? fine_p_size_9 : fine_d_size_1;
  const float fine_low_2 = D->m11 < D->m00 ? fine_s_1 : fine_s_0,
      fine_low_lo_3 = D->m11 < D->m00 ? fine_s_lo_2 : fine_s_lo_1,
      fine_low_size_3 = D->m11 < D->m00 ? fine_p_size_6 : fine_p_size_3;
  const float fine_low_3 = D->m11 < D->m00 ? fine_p_0 : fine_p_1,
      fine_low_lo_4 = D->m11 < D->m00 ? fine_p_lo_1 : fine_p_lo_2,
      fine_low_size_4 = D->m11 < D->m00 ? fine_p_size_3 : fine_p_size_6;
  const float fine_high_0a = -D->m11, fine_high_0 = D->m00 < fine_high_0a ? fine_s_1 : fine_p_0,
      fine_high_lo_1 = D->m00 < fine_high_0a ? fine_s_lo_2 : fine_p_lo_1,
      fine_high_size_1 = D->m00 < fine_high_0a ? fine_p_size_6 : fine_p_size_3;
  const float fine_high_1 = D->m00 < fine_high_0a ? fine_s_0 : fine_p_1,
      fine_high_lo_2 = D->m00 < fine_high_0a ? fine_s_lo_1 : fine_p_lo_2,
      fine_high_size_2 = D->m00 < fine_high_0a ? fine_p_size_3 : fine_p_size_6;
  const float fine_high_2 = D->m00 < fine_high_0a ? fine_d_3 : fine_p_2,
      fine_high_lo_3 = D->m00 < fine_high_0a ? fine_d_lo_4 : fine_p_lo_3,
      fine_high_size_3 = D->m00 < fine_high_0a ? fine_d_size_1 : fine_p_size_9;
  const float fine_high_3 = D->m00 < fine_high_0a ? fine_p_2 : fine_d_0,
      fine_high_lo_4 = D->m00 < fine_high_0a ? fine_p_lo_3 : fine_d_lo_1,
      fine_high_size_4 = D->m00 < fine_high_0a ? fine_p_size_9 : fine_d_size_1;
  const float fine_column_0 = D->m22 < 0.0f ? fine_low_0 : fine_high_0,
      fine_column_lo_1 = D->m22 < 0.0f ? fine_low_lo_1 : fine_high_lo_1,
      fine_column_size_1 = D->m22 < 0.0f ? fine_low_size_1 : fine_high_size_1;
  const float fine_column_1 = D->m22 < 0.0f ? fine_low_1 : fine_high_1,
      fine_column_lo_2 = D->m22 < 0.0f ? fine_low_lo_2 : fine_high_lo_2,
      fine_column_size_2 = D->m22 < 0.0f ? fine_low_size_2 : fine_high_size_2;
  const float fine_column_2 = D->m22 < 0.0f ? fine_low_2 : fine_high_2,
      fine_column_lo_3 = D->m22 < 0.0f ? fine_low_lo_3 : fine_high_lo_3,
      fine_column_size_3 = D->m22 < 0.0f ? fine_low_size_3 : fine_high_size_3;
  const float fine_column_3 = D->m22 < 0.0f ? fine_low_3 : fine_high_3,
      fine_column_lo_4 = D->m22 < 0.0f ? fine_low_lo_4 : fine_high_lo_4,
      fine_column_size_4 = D->m22 < 0.0f ? fine_low_size_4 : fine_high_size_4;
  const float fine_upper_0a = -fine_column_0, fine_upper_0a_lo = -fine_column_lo_1,
      fine_upper_0 = fine_column_3 < 0.0f ? fine_upper_0a : fine_column_0,
      fine_upper_lo_1 = fine_column_3 < 0.0f ? fine_upper_0a_lo : fine_column_lo_1,
      fine_upper_bound_1 = fabsf(fine_column_lo_4)
          + KSL_MULF(4.6185646e-13f, 3.3087225e-24f + fine_column_size_4),
      fine_upper_size_2 = fabsf(fine_column_3 - 0.0f),
      fine_upper_rest_2 = KSL_MULF(4.6185646e-13f, 3.3087225e-24f + fine_column_size_1),
      fine_upper_size_7 = fabsf(fine_column_lo_1) + fine_upper_rest_2
          + (fabsf(fine_upper_0a_lo) + fine_upper_rest_2 + fabsf(fine_upper_0a - fine_column_0));
  const float fine_upper_1a = -fine_column_1, fine_upper_1a_lo = -fine_column_lo_2,
      fine_upper_1 = fine_column_3 < 0.0f ? fine_upper_1a : fine_column_1,
      fine_upper_lo_2 = fine_column_3 < 0.0f ? fine_upper_1a_lo : fine_column_lo_2,
      fine_upper_rest_3 = KSL_MULF(4.6185646e-13f, 3.3087225e-24f + fine_column_size_2),
      fine_upper_size_13 = fabsf(fine_upper_1a_lo) + fine_upper_rest_3
          + fabsf(fine_upper_1a - fine_column_1),
      fine_upper_size_14 = fabsf(fine_column_lo_2) + fine_upper_rest_3 + fine_upper_size_13;
  const float fine_upper_2a = -fine_column_2, fine_upper_2a_lo = -fine_column_lo_3,
      fine_upper_2 = fine_column_3 < 0.0f ? fine_upper_2a : fine_column_2,
      fine_upper_lo_3 = fine_column_3 < 0.0f ? fine_upper_2a_lo : fine_column_lo_3,
      fine_upper_rest_4 = KSL_MULF(4.6185646e-13f, 3.3087225e-24f + fine_column_size_3),
      fine_upper_size_20 = fabsf(fine_upper_2a_lo) + fine_upper_rest_4
          + fabsf(fine_upper_2a - fine_column_2),
      fine_upper_size_21 = fabsf(fine_column_lo_3) + fine_upper_rest_4 + fine_upper_size_20;
  const float fine_upper_3 = fabsf(fine_column_3), fine_upper_opposite_1 = -fine_column_lo_4,
      fine_upper_lo_4 = fine_column_3 < 0.0f ? fine_upper_opposite_1 : fine_column_lo_4,
      fine_upper_size_25 = fine_upper_3 - fine_upper_bound_1;
  const float fine_v_s_size_0 = fabsf(fine_upper_0);
  const float fine_upper_size_10 = fine_column_size_1
          + KSL_MULF(5.497537e+11f, fine_upper_bound_1 < fine_upper_size_2 ? 0.0f
          : fine_upper_size_7);
  const float fine_v_s_size_padded_1 = 3.3087225e-24f + fine_upper_size_10;
  const float fine_v_s_size_1 = fabsf(fine_upper_1);
  const float fine_upper_size_17 = fine_column_size_2
          + KSL_MULF(5.497537e+11f, fine_upper_bound_1 < fine_upper_size_2 ? 0.0f
          : fine_upper_size_14);
  const float fine_v_s_size_padded_2 = 3.3087225e-24f + fine_upper_size_17;
  const float fine_v_s_size_2 = fabsf(fine_upper_2);
  const float fine_upper_size_24 = fine_column_size_3
          + KSL_MULF(5.497537e+11f, fine_upper_bound_1 < fine_upper_size_2 ? 0.0f
          : fine_upper_size_21);
  const float fine_v_s_size_padded_3 = 3.3087225e-24f + fine_upper_size_24;
  const float fine_v_s_largest1 = fine_v_s_size_0 < fine_v_s_size_1 ? fine_v_s_size_1
          : fine_v_s_size_0;
  const float fine_v_s_largest2 = fine_v_s_largest1 < fine_v_s_size_2 ? fine_v_s_size_2
          : fine_v_s_largest1;
  const float fine_v_s_b = 4.611686e+18f < fine_v_s_largest2 ? 2.7105054e-20f : 1.0f,
      fine_v_s_b_size_1 = 4.611686e+18f < fine_v_s_largest2 ? 2.7105054e-20f : 1.0f,
      fine_v_s_d = fine_v_s_largest2 < 256.0f ? 1.8014399e+16f : fine_v_s_b,
      fine_v_s_d_size_1 = fine_v_s_largest2 < 256.0f ? 1.8014399e+16f : fine_v_s_b_size_1,
      fine_v_s = fine_v_s_largest2 < 1.4210855e-14f ? 3.2451855e+32f : fine_v_s_d,
      fine_v_s_size_3 = fine_v_s_largest2 < 1.4210855e-14f ? 3.2451855e+32f : fine_v_s_d_size_1;
  const float fine_v_y_0 = KSL_MULF(fine_upper_0, fine_v_s), fine_v_y_inverse_1 = 1.0f / fine_v_s,
      fine_v_y_lo_1 = KSL_MULF(fine_upper_0 - KSL_MULF(fine_v_y_0, fine_v_y_inverse_1)
          + fine_upper_lo_1, fine_v_s);
  const float fine_v_y_1 = KSL_MULF(fine_upper_1, fine_v_s),
      fine_v_y_lo_2 = KSL_MULF(fine_upper_1 - KSL_MULF(fine_v_y_1, fine_v_y_inverse_1)
          + fine_upper_lo_2, fine_v_s);
  const float fine_v_y_2 = KSL_MULF(fine_upper_2, fine_v_s),
      fine_v_y_lo_3 = KSL_MULF(fine_upper_2 - KSL_MULF(fine_v_y_2, fine_v_y_inverse_1)
          + fine_upper_lo_3, fine_v_s);
  const float fine_v_n_a = KSL_MULF(fine_v_y_0, fine_v_y_0),
      fine_v_n_a_padded_1 = 3.3087225e-24f + KSL_MULF(fine_v_s_size_3, fine_v_s_size_padded_1),
      fine_v_n_a_reach_1 = fabsf(fine_v_y_0)
          + KSL_MULF(262144.0f, fabsf(fine_v_y_lo_1)
          + KSL_MULF(1.9326999e-12f, fine_v_n_a_padded_1)),
      fine_v_n_a_size_2 = KSL_MULF(fine_v_n_a_padded_1, fine_v_n_a_reach_1),
      fine_v_n_b = KSL_MULF(fine_v_y_1, fine_v_y_1),
      fine_v_n_b_padded_1 = 3.3087225e-24f + KSL_MULF(fine_v_s_size_3, fine_v_s_size_padded_2),
      fine_v_n_b_reach_1 = fabsf(fine_v_y_1)
          + KSL_MULF(262144.0f, fabsf(fine_v_y_lo_2)
          + KSL_MULF(1.9326999e-12f, fine_v_n_b_padded_1)),
      fine_v_n_b_size_2 = KSL_MULF(fine_v_n_b_padded_1, fine_v_n_b_reach_1),
      fine_v_n_c = fine_v_n_a + fine_v_n_b, fine_v_n_c_right_1 = fine_v_n_c - fine_v_n_a,
      fine_v_n_a_cross_1 = KSL_MULF(fine_v_y_lo_1, fine_v_y_0)
          + KSL_MULF(fine_v_y_0, fine_v_y_lo_1),
      fine_v_n_c_left_rest_1 = ksl_product_restf(fine_v_y_0, fine_v_y_0, fine_v_n_a, fine_v_n_c
          - fine_v_n_c_right_1),
      fine_v_n_c_lo1_1 = fine_v_n_c_left_rest_1
          + ksl_product_restf(fine_v_y_1, fine_v_y_1, fine_v_n_b, fine_v_n_c_right_1),
      fine_v_n_d = KSL_MULF(fine_v_y_2, fine_v_y_2),
      fine_v_n_d_padded_1 = 3.3087225e-24f + KSL_MULF(fine_v_s_size_3, fine_v_s_size_padded_3),
      fine_v_n_d_reach_1 = fabsf(fine_v_y_2)
          + KSL_MULF(262144.0f, fabsf(fine_v_y_lo_3)
          + KSL_MULF(1.9326999e-12f, fine_v_n_d_padded_1)),
      fine_v_n_d_size_2 = KSL_MULF(fine_v_n_d_padded_1, fine_v_n_d_reach_1),
      fine_v_n_e = fine_v_n_c + fine_v_n_d, fine_v_n_e_right_1 = fine_v_n_e - fine_v_n_c,
      fine_v_n_e_lo1_1 = fine_v_n_c - (fine_v_n_e - fine_v_n_e_right_1)
          + ksl_product_restf(fine_v_y_2, fine_v_y_2, fine_v_n_d, fine_v_n_e_right_1),
      fine_v_n_c_lo = fine_v_n_c_lo1_1
          + (fine_v_n_a_cross_1
          + (KSL_MULF(fine_v_y_lo_2, fine_v_y_1) + KSL_MULF(fine_v_y_1, fine_v_y_lo_2))),
      fine_v_n_e_lo = fine_v_n_e_lo1_1
          + (KSL_MULF(fine_v_y_lo_3, fine_v_y_2) + KSL_MULF(fine_v_y_2, fine_v_y_lo_3))
          + fine_v_n_c_lo, fine_v_n = sqrtf(fine_v_n_e),
      fine_v_n_product_1 = KSL_MULF(fine_v_n, fine_v_n), fine_v_n_twice_1 = fine_v_n + fine_v_n,
      fine_v_n_residual_1 = fine_v_n_e - fine_v_n_product_1
          - ksl_product_errorf(fine_v_n, fine_v_n, fine_v_n_product_1) + fine_v_n_e_lo,
      fine_v_n_lo = fine_v_n_residual_1 / (fine_v_n == 0.0f ? 1.0f : fine_v_n_twice_1),
      fine_v_n_e_size_1 = fine_v_n_a_size_2 + fine_v_n_a_size_2
          + (fine_v_n_b_size_2 + fine_v_n_b_size_2) + (fine_v_n_d_size_2 + fine_v_n_d_size_2),
      fine_v_n_padded_1 = 3.3087225e-24f + fine_v_n_e_size_1,
      fine_v_n_bound_1 = fabsf(fine_v_n_e_lo) + KSL_MULF(3.3147653e-12f, fine_v_n_padded_1),
      fine_v_n_size_4 = KSL_MULF(fabsf(fine_v_n_e)
          + KSL_MULF(262144.0f, fine_v_n_bound_1), fine_v_n_padded_1 / fine_v_n / fine_v_n_e),
      fine_v_n_size_8 = KSL_MULF(3.9615493e+11f, sqrtf(fine_v_n_bound_1) + fabsf(fine_v_n_lo));
  const float fine_v_r_b = fine_v_s < 1.0f ? 3.689349e+19f : 1.0f,
      fine_v_r_b_size_1 = fine_v_s < 1.0f ? 3.689349e+19f : 1.0f,
      fine_v_r_d = 1.0f < fine_v_s ? 5.551115e-17f : fine_v_r_b,
      fine_v_r_d_size_1 = 1.0f < fine_v_s ? 5.551115e-17f : fine_v_r_b_size_1,
      fine_v_r = 1.8014399e+16f < fine_v_s ? 3.081488e-33f : fine_v_r_d;
  const float fine_n = KSL_MULF(fine_v_n, fine_v_r),
      fine_n_lo = KSL_MULF(fine_v_n - KSL_MULF(fine_n, 1.0f / fine_v_r) + fine_v_n_lo, fine_v_r),
      fine_n_padded_1 = 3.3087225e-24f
          + (fine_v_n
          + (KSL_MULF(4.0f, fine_v_n_bound_1) < fine_v_n_e ? fine_v_n_size_4 : fine_v_n_size_8)),
      fine_n_size_1 = KSL_MULF(fine_n_padded_1, 1.8014399e+16f < fine_v_s ? 3.081488e-33f
          : fine_v_r_d_size_1);
  const float fine_half = ksl_atan2f(fine_n, fine_upper_3), fine_half_size0_1 = fabsf(fine_n),
      fine_half_size1_1 = fabsf(fine_upper_3),
      fine_half_most_1 = fine_half_size0_1 < fine_half_size1_1 ? fine_half_size1_1
          : fine_half_size0_1,
      fine_half_divisor_1 = fine_half_most_1 == 0.0f ? 1.0f : fine_half_most_1,
      fine_half_part0_1 = fine_n / fine_half_divisor_1,
      fine_half_part1_1 = fine_upper_3 / fine_half_divisor_1,
      fine_half_divisor2_1 = KSL_MULF(fine_half_divisor_1, KSL_MULF(fine_half_part1_1,
          fine_half_part1_1) + KSL_MULF(fine_half_part0_1, fine_half_part0_1)),
      fine_half_cross_1 = KSL_MULF(fine_half_part1_1, fine_n_lo)
          - KSL_MULF(fine_half_part0_1, fine_upper_lo_4),
      fine_half_lo = ksl_atan2_errorf(fine_n, fine_upper_3, fine_half) + fine_half_cross_1
          / (fine_half_most_1 == 0.0f ? 1.0f : fine_half_divisor2_1),
      fine_half_padded_1 = 3.3087225e-24f + fine_n_size_1,
      fine_half_padded_2 = 3.3087225e-24f
          + (fine_column_size_4
          + KSL_MULF(5.497537e+11f, fabsf(fine_upper_size_25) - fine_upper_size_25)),
      fine_half_size_2 = fabsf(fine_n), fine_half_size_3 = fabsf(fine_upper_3),
      fine_half_size_5 = fine_half_size_2 < fine_half_size_3 ? fine_half_size_3 : fine_half_size_2,
      fine_half_bound_1 = fabsf(fine_n_lo) + KSL_MULF(2.7161363e-12f, fine_half_padded_1),
      fine_half_bound_2 = fabsf(fine_upper_lo_4) + KSL_MULF(1.8758484e-12f, fine_half_padded_2),
      fine_half_size_11 = (fine_half_bound_2 + (3.3087225e-24f + fine_half_bound_1))
          / fine_half_size_5, fine_half_size_13 = KSL_MULF(fine_half_size_11, fine_half_size_11),
      fine_half_size_15 = 7.0f + fabsf(fine_half_lo),
      fine_half_size_18 = fine_half_bound_2 < fine_upper_3 ? fine_half_size_13 : fine_half_size_15,
      fine_half_size_19 = fine_half_bound_1 < fine_half_size_2 ? fine_half_size_13
          : fine_half_size_18,
      fine_half_size_21 = KSL_MULF(1.5707046e+11f, fine_half_size_11 < 0.25f ? fine_half_size_19
          : fine_half_size_15);
  const float fine_divisor = fine_n == 0.0f ? 1.0f : fine_n,
      fine_divisor_lo = fine_n == 0.0f ? 0.0f : fine_n_lo,
      fine_divisor_size_8 = fabsf(1.0f - fine_n) + fine_half_bound_1,
      fine_divisor_size_10 = KSL_MULF(2.1989818e+11f, fine_half_bound_1 < 1e-45f
          + fabsf(fine_n - 0.0f) ? 0.0f : fine_divisor_size_8);
  const float fine_theta = KSL_MULF(2.0f, fine_half),
      fine_theta_cross2_1 = KSL_MULF(2.0f, fine_half_lo),
      fine_theta_size_1 = KSL_MULF(2.0f, fabsf(fine_half)
          + (fine_half_padded_1 + fine_half_padded_2) / fine_half_size_5 + fine_half_size_21);
  const float fine_k = fine_theta / fine_divisor, fine_k_product_1 = KSL_MULF(fine_k, fine_divisor),
      fine_k_numerator_1 = fine_theta - fine_k_product_1
          - ksl_product_errorf(fine_k, fine_divisor, fine_k_product_1) + fine_theta_cross2_1,
      fine_k_lo = (fine_k_numerator_1 - KSL_MULF(fine_k, fine_divisor_lo)) / fine_divisor,
      fine_k_padded_2 = 3.3087225e-24f
          + ((fine_n == 0.0f ? 1.0f : fine_n_size_1) + fine_divisor_size_10),
      fine_k_size_1 = fabsf(fine_k), fine_k_size_2 = fabsf(fine_divisor),
      fine_k_bound_1 = fabsf(fine_divisor_lo) + KSL_MULF(4.6896905e-12f, fine_k_padded_2),
      fine_k_size_4 = 3.3087225e-24f + fine_theta_size_1 + KSL_MULF(fine_k_padded_2, fine_k_size_1),
      fine_k_size_8 = fine_k_size_4
          / (KSL_MULF(4.0f, fine_k_bound_1) < fine_k_size_2 ? fine_k_size_2 : 0.0f);
  const float fine_vector_0 = KSL_MULF(fine_upper_0, fine_k),
      fine_vector_padded_1 = 3.3087225e-24f
          + (fine_k_size_1
          + KSL_MULF(fine_k_size_2 + KSL_MULF(262144.0f, fine_k_bound_1), fine_k_size_8)
          / fine_k_size_2),
      fine_vector_reach_1 = fabsf(fine_upper_0)
          + KSL_MULF(262144.0f, fabsf(fine_upper_lo_1)
          + KSL_MULF(1.8758484e-12f, fine_v_s_size_padded_1)),
      fine_vector_reach_2 = fine_k_size_1
          + KSL_MULF(262144.0f, fabsf(fine_k_lo) + KSL_MULF(9.5606465e-12f, fine_vector_padded_1));
  const float fine_vector_1 = KSL_MULF(fine_upper_1, fine_k),
      fine_vector_reach_3 = fabsf(fine_upper_1)
          + KSL_MULF(262144.0f, fabsf(fine_upper_lo_2)
          + KSL_MULF(1.8758484e-12f, fine_v_s_size_padded_2));
  const float fine_vector_2 = KSL_MULF(fine_upper_2, fine_k),
      fine_vector_reach_4 = fabsf(fine_upper_2)
          + KSL_MULF(262144.0f, fabsf(fine_upper_lo_3)
          + KSL_MULF(1.8758484e-12f, fine_v_s_size_padded_3));
  const float half_angle = KSL_MULF(0.5f, fine_theta),
      half_angle_cross2_1 = KSL_MULF(0.5f, fine_theta_cross2_1),
      half_angle_size_1 = KSL_MULF(0.5f, fine_theta_size_1);
  const float length_a = KSL_MULF(fine_n, fine_n),
      length_a_size_1 = KSL_MULF(fine_half_padded_1, fine_half_size_2
          + KSL_MULF(262144.0f, fine_half_bound_1)),
      length_b = KSL_MULF(fine_upper_3, fine_upper_3),
      length_b_size_1 = KSL_MULF(fine_half_padded_2, fine_half_size_3
          + KSL_MULF(262144.0f, fine_half_bound_2)), length_c = length_a + length_b,
      length_c_right_1 = length_c - length_a,
      length_b_cross_1 = KSL_MULF(fine_upper_lo_4, fine_upper_3)
          + KSL_MULF(fine_upper_3, fine_upper_lo_4),
      length_c_right_rest_1 = ksl_product_restf(fine_upper_3, fine_upper_3, length_b,
          length_c_right_1),
      length_c_lo1_1 = ksl_product_restf(fine_n, fine_n, length_a, length_c - length_c_right_1)
          + length_c_right_rest_1,
      length_c_lo = length_c_lo1_1
          + (KSL_MULF(fine_n_lo, fine_n) + KSL_MULF(fine_n, fine_n_lo) + length_b_cross_1),
      length = sqrtf(length_c), length_product_1 = KSL_MULF(length, length),
      length_twice_1 = length + length,
      length_residual_1 = length_c - length_product_1
          - ksl_product_errorf(length, length, length_product_1) + length_c_lo,
      length_lo = length_residual_1 / (length == 0.0f ? 1.0f : length_twice_1),
      length_padded_1 = 3.3087225e-24f
          + (length_a_size_1 + length_a_size_1 + (length_b_size_1 + length_b_size_1)),
      length_bound_1 = fabsf(length_c_lo) + KSL_MULF(4.2900713e-12f, length_padded_1),
      length_size_4 = KSL_MULF(fabsf(length_c)
          + KSL_MULF(262144.0f, length_bound_1), length_padded_1 / length / length_c),
      length_size_6 = fabsf(length_lo),
      length_size_8 = KSL_MULF(3.208488e+11f, sqrtf(length_bound_1) + length_size_6);
  const float sine = fine_n / length, sine_product_1 = KSL_MULF(sine, length),
      sine_padded_1 = 3.3087225e-24f
          + (length + (KSL_MULF(4.0f, length_bound_1) < length_c ? length_size_4 : length_size_8)),
      sine_size_1 = fabsf(sine), sine_size_2 = fabsf(length),
      sine_bound_1 = length_size_6 + KSL_MULF(3.2446472e-12f, sine_padded_1),
      sine_size_7 = KSL_MULF(4.0f, sine_bound_1) < sine_size_2 ? sine_size_2 : 0.0f,
      sine_reach_1 = sine_size_2 + KSL_MULF(262144.0f, sine_bound_1);
  const float c = fine_upper_3 / length, c_product_1 = KSL_MULF(c, length),
      c_lo = (fine_upper_3 - c_product_1 - ksl_product_errorf(c, length, c_product_1)
          + fine_upper_lo_4 - KSL_MULF(c, length_lo)) / length, c_size_1 = fabsf(c),
      c_size_7 = c_size_1
          + KSL_MULF((KSL_MULF(c_size_1, sine_padded_1) + fine_half_padded_2)
          / sine_size_7, sine_reach_1) / sine_size_2;
  const float y = KSL_MULF(half_angle, half_angle), y_padded_1 = 3.3087225e-24f + half_angle_size_1,
      y_bound_1 = fabsf(half_angle_cross2_1) + KSL_MULF(6.7965347e-12f, y_padded_1),
      y_size_2 = KSL_MULF(y_padded_1, fabsf(half_angle) + KSL_MULF(262144.0f, y_bound_1)),
      y_size_3 = y_size_2 + y_size_2;
  const float sinc_divisor = half_angle < 1.4901161e-08f ? 1.4901161e-08f : half_angle,
      sinc_divisor_lo = half_angle < 1.4901161e-08f ? 0.0f : half_angle_cross2_1,
      sinc_divisor_size_3 = fabsf(half_angle - 1.4901161e-08f),
      sinc_divisor_size_7 = fabsf(1.4901161e-08f - half_angle) + y_bound_1,
      sinc_divisor_size_9 = KSL_MULF(1.2216549e+11f, y_bound_1 < sinc_divisor_size_3 ? 0.0f
          : sinc_divisor_size_7);
  const float sinc_quotient = sine / sinc_divisor,
      sinc_quotient_product_1 = KSL_MULF(sinc_quotient, sinc_divisor);
  const float sine_lo = (fine_n - sine_product_1 - ksl_product_errorf(sine, length, sine_product_1)
          + fine_n_lo - KSL_MULF(sine, length_lo)) / length;
  const float sinc_quotient_numerator_1 = sine - sinc_quotient_product_1
          - ksl_product_errorf(sinc_quotient, sinc_divisor, sinc_quotient_product_1) + sine_lo,
      sinc_quotient_lo = (sinc_quotient_numerator_1 - KSL_MULF(sinc_quotient, sinc_divisor_lo))
          / sinc_divisor;
  const float sine_size_11 = sine_size_1
          + KSL_MULF(sine_reach_1, (fine_half_padded_1 + KSL_MULF(sine_padded_1, sine_size_1))
          / sine_size_7) / sine_size_2;
  const float sinc_quotient_padded_2 = 3.3087225e-24f
          + ((half_angle < 1.4901161e-08f ? 1.4901161e-08f : half_angle_size_1)
          + sinc_divisor_size_9), sinc_quotient_size_1 = fabsf(sinc_quotient),
      sinc_quotient_size_2 = fabsf(sinc_divisor),
      sinc_quotient_bound_1 = fabsf(sinc_divisor_lo)
          + KSL_MULF(8.441455e-12f, sinc_quotient_padded_2),
      sinc_quotient_size_7 = KSL_MULF(4.0f, sinc_quotient_bound_1) < sinc_quotient_size_2
          ? sinc_quotient_size_2 : 0.0f,
      sinc_quotient_size_8 = (3.3087225e-24f + sine_size_11
          + KSL_MULF(sinc_quotient_padded_2, sinc_quotient_size_1)) / sinc_quotient_size_7,
      sinc_quotient_size_10 = KSL_MULF(sinc_quotient_size_2
          + KSL_MULF(262144.0f, sinc_quotient_bound_1), sinc_quotient_size_8)
          / sinc_quotient_size_2,
      sinc_quotient_size_11 = sinc_quotient_size_1 + sinc_quotient_size_10;
  const float y_lo = ksl_product_errorf(half_angle, half_angle, y)
          + (KSL_MULF(half_angle_cross2_1, half_angle) + KSL_MULF(half_angle, half_angle_cross2_1)),
      sinc_a = KSL_MULF(0.16666667f, y), sinc_b = 1.0f - sinc_a, sinc_b_right_1 = 1.0f - sinc_b,
      sinc_b_lo1_1 = 1.0f - (sinc_b + sinc_b_right_1)
          - ksl_product_restf(0.16666667f, y, sinc_a, sinc_b_right_1),
      sinc_b_lo = sinc_b_lo1_1 - (KSL_MULF(-4.967054e-09f, y) + KSL_MULF(0.16666667f, y_lo)),
      sinc_b_size_1 = 1.0f + KSL_MULF(0.16666669f, y_size_3),
      sinc = half_angle < 1.4901161e-08f ? sinc_b : sinc_quotient,
      sinc_lo = half_angle < 1.4901161e-08f ? sinc_b_lo : sinc_quotient_lo,
      sinc_size_4 = fabsf(sinc_b_lo) + KSL_MULF(2.4250044e-10f, 3.3087225e-24f + sinc_b_size_1)
          + fabsf(sinc_b - sinc_quotient),
      sinc_size_5 = fabsf(sinc_quotient_lo)
          + KSL_MULF(1.1643793e-11f, 3.3087225e-24f + sinc_quotient_size_11) + sinc_size_4,
      sinc_size_7 = KSL_MULF(4.1300134e+09f, y_bound_1 < sinc_divisor_size_3 ? 0.0f : sinc_size_5),
      sinc_size_8 = (half_angle < 1.4901161e-08f ? sinc_b_size_1 : sinc_quotient_size_11)
          + sinc_size_7;
  const float series_phi_a = KSL_MULF(5.107725e-32f, y),
      series_phi_b = 4.1168266e-29f - series_phi_a,
      series_phi_b_right_1 = 4.1168266e-29f - series_phi_b,
      series_phi_b_lo1_1 = 4.1168266e-29f - (series_phi_b + series_phi_b_right_1)
          - ksl_product_restf(5.107725e-32f, y, series_phi_a, series_phi_b_right_1),
      series_phi_b_lo = series_phi_b_lo1_1
          - (KSL_MULF(3.51736e-40f, y) + KSL_MULF(5.107725e-32f, y_lo)) + -1.3151732e-36f,
      series_phi_c = KSL_MULF(y, series_phi_b), series_phi_c_padded_1 = 3.3087225e-24f + y_size_3,
      series_phi_c_padded_2 = 3.3087225e-24f
          + (4.1168266e-29f + KSL_MULF(2.3741903e-25f, y_size_3)),
      series_phi_c_bound_1 = fabsf(y_lo) + KSL_MULF(8.974486e-12f, series_phi_c_padded_1),
      series_phi_c_reach_1 = fabsf(y) + KSL_MULF(262144.0f, series_phi_c_bound_1),
      series_phi_c_reach_2 = fabsf(series_phi_b)
          + KSL_MULF(262144.0f, fabsf(series_phi_b_lo)
          + KSL_MULF(2.4250044e-10f, series_phi_c_padded_2)),
      series_phi_d = series_phi_c - 2.8653114e-26f,
      series_phi_d_right_1 = series_phi_c - series_phi_d,
      series_phi_d_lo1_1 = ksl_product_restf(y, series_phi_b, series_phi_c, series_phi_d
          + series_phi_d_right_1) - (2.8653114e-26f - series_phi_d_right_1),
      series_phi_d_lo = series_phi_d_lo1_1 - -1.27647235e-33f
          + (KSL_MULF(y_lo, series_phi_b) + KSL_MULF(y, series_phi_b_lo)),
      series_phi_e = KSL_MULF(y, series_phi_d),
      series_phi_d_size_1 = 2.8653114e-26f
          + (KSL_MULF(series_phi_c_padded_2, series_phi_c_reach_1)
          + KSL_MULF(series_phi_c_padded_1, series_phi_c_reach_2)),
      series_phi_e_padded_1 = 3.3087225e-24f + series_phi_d_size_1,
      series_phi_e_reach_1 = fabsf(series_phi_d)
          + KSL_MULF(262144.0f, fabsf(series_phi_d_lo)
          + KSL_MULF(2.4547078e-10f, series_phi_e_padded_1)),
      series_phi_f = series_phi_e + 1.7019949e-23f,
      series_phi_f_right_1 = series_phi_f - series_phi_e,
      series_phi_f_lo1_1 = ksl_product_restf(y, series_phi_d, series_phi_e, series_phi_f
          - series_phi_f_right_1) + (1.7019949e-23f - series_phi_f_right_1),
      series_phi_f_lo = series_phi_f_lo1_1 + 1.9703667e-31f
          + (KSL_MULF(y_lo, series_phi_d) + KSL_MULF(y, series_phi_d_lo)),
      series_phi_g = KSL_MULF(y, series_phi_f),
      series_phi_f_size_1 = 1.7019949e-23f
          + (KSL_MULF(series_phi_c_reach_1, series_phi_e_padded_1)
          + KSL_MULF(series_phi_c_padded_1, series_phi_e_reach_1)),
      series_phi_g_padded_1 = 3.3087225e-24f + series_phi_f_size_1,
      series_phi_g_reach_1 = fabsf(series_phi_f)
          + KSL_MULF(262144.0f, fabsf(series_phi_f_lo)
          + KSL_MULF(2.4850513e-10f, series_phi_g_padded_1)),
      series_phi_h = series_phi_g - 8.509974e-21f,
      series_phi_h_right_1 = series_phi_g - series_phi_h,
      series_phi_h_lo1_1 = ksl_product_restf(y, series_phi_f, series_phi_g, series_phi_h
          + series_phi_h_right_1) - (8.509974e-21f - series_phi_h_right_1),
      series_phi_h_lo = series_phi_h_lo1_1 - 1.016591e-29f
          + (KSL_MULF(y_lo, series_phi_f) + KSL_MULF(y, series_phi_f_lo)),
      series_phi_i = KSL_MULF(y, series_phi_h),
      series_phi_h_size_1 = 8.509974e-21f
          + (KSL_MULF(series_phi_c_reach_1, series_phi_g_padded_1)
          + KSL_MULF(series_phi_c_padded_1, series_phi_g_reach_1)),
      series_phi_i_padded_1 = 3.3087225e-24f + series_phi_h_size_1,
      series_phi_i_reach_1 = fabsf(series_phi_h)
          + KSL_MULF(262144.0f, fabsf(series_phi_h_lo)
          + KSL_MULF(2.5160352e-10f, series_phi_i_padded_1)),
      series_phi_j = series_phi_i + 3.5231293e-18f,
      series_phi_j_right_1 = series_phi_j - series_phi_i,
      series_phi_j_lo1_1 = ksl_product_restf(y, series_phi_h, series_phi_i, series_phi_j
          - series_phi_j_right_1) + (3.5231293e-18f - series_phi_j_right_1),
      series_phi_j_lo = series_phi_j_lo1_1 + 7.2063343e-26f
          + (KSL_MULF(y_lo, series_phi_h) + KSL_MULF(y, series_phi_h_lo)),
      series_phi_k = KSL_MULF(y, series_phi_j),
      series_phi_j_size_1 = 3.5231293e-18f
          + (KSL_MULF(series_phi_c_reach_1, series_phi_i_padded_1)
          + KSL_MULF(series_phi_c_padded_1, series_phi_i_reach_1)),
      series_phi_k_padded_1 = 3.3087225e-24f + series_phi_j_size_1,
      series_phi_k_reach_1 = fabsf(series_phi_j)
          + KSL_MULF(262144.0f, fabsf(series_phi_j_lo)
          + KSL_MULF(2.5476588e-10f, series_phi_k_padded_1)),
      series_phi_l = series_phi_k - 1.1837714e-15f,
      series_phi_l_right_1 = series_phi_k - series_phi_l,
      series_phi_l_lo1_1 = ksl_product_restf(y, series_phi_j, series_phi_k, series_phi_l
          + series_phi_l_right_1) - (1.1837714e-15f - series_phi_l_right_1),
      series_phi_l_lo = series_phi_l_lo1_1 - 5.0683064e-23f
          + (KSL_MULF(y_lo, series_phi_j) + KSL_MULF(y, series_phi_j_lo)),
      series_phi_m = KSL_MULF(y, series_phi_l),
      series_phi_l_size_1 = 1.1837714e-15f
          + (KSL_MULF(series_phi_c_reach_1, series_phi_k_padded_1)
          + KSL_MULF(series_phi_c_padded_1, series_phi_k_reach_1)),
      series_phi_m_padded_1 = 3.3087225e-24f + series_phi_l_size_1,
      series_phi_m_reach_1 = fabsf(series_phi_l)
          + KSL_MULF(262144.0f, fabsf(series_phi_l_lo)
          + KSL_MULF(2.5799224e-10f, series_phi_m_padded_1)),
      series_phi_n = series_phi_m + 3.148832e-13f,
      series_phi_n_right_1 = series_phi_n - series_phi_m,
      series_phi_n_lo1_1 = ksl_product_restf(y, series_phi_l, series_phi_m, series_phi_n
          - series_phi_n_right_1) + (3.148832e-13f - series_phi_n_right_1),
      series_phi_n_lo = series_phi_n_lo1_1 + 1.834992e-21f
          + (KSL_MULF(y_lo, series_phi_l) + KSL_MULF(y, series_phi_l_lo)),
      series_phi_o = KSL_MULF(y, series_phi_n),
      series_phi_n_size_1 = 3.148832e-13f
          + (KSL_MULF(series_phi_c_reach_1, series_phi_m_padded_1)
          + KSL_MULF(series_phi_c_padded_1, series_phi_m_reach_1)),
      series_phi_o_padded_1 = 3.3087225e-24f + series_phi_n_size_1,
      series_phi_o_reach_1 = fabsf(series_phi_n)
          + KSL_MULF(262144.0f, fabsf(series_phi_n_lo)
          + KSL_MULF(2.612826e-10f, series_phi_o_padded_1)),
      series_phi_p = series_phi_o - 6.423617e-11f,
      series_phi_p_right_1 = series_phi_o - series_phi_p,
      series_phi_p_lo1_1 = ksl_product_restf(y, series_phi_n, series_phi_o, series_phi_p
          + series_phi_p_right_1) - (6.423617e-11f - series_phi_p_right_1),
      series_phi_p_lo = series_phi_p_lo1_1 - 3.4101044e-18f
          + (KSL_MULF(y_lo, series_phi_n) + KSL_MULF(y, series_phi_n_lo)),
      series_phi_q = KSL_MULF(y, series_phi_p),
      series_phi_p_size_1 = 6.423617e-11f
          + (KSL_MULF(series_phi_c_reach_1, series_phi_o_padded_1)
          + KSL_MULF(series_phi_c_padded_1, series_phi_o_reach_1)),
      series_phi_q_padded_1 = 3.3087225e-24f + series_phi_p_size_1,
      series_phi_q_reach_1 = fabsf(series_phi_p)
          + KSL_MULF(262144.0f, fabsf(series_phi_p_lo)
          + KSL_MULF(2.6463698e-10f, series_phi_q_padded_1)),
      series_phi_r = series_phi_q + 9.635427e-09f,
      series_phi_r_right_1 = series_phi_r - series_phi_q,
      series_phi_r_lo1_1 = ksl_product_restf(y, series_phi_p, series_phi_q, series_phi_r
          - series_phi_r_right_1) + (9.635427e-09f - series_phi_r_right_1),
      series_phi_r_lo = series_phi_r_lo1_1 + -3.7666274e-16f
          + (KSL_MULF(y_lo, series_phi_p) + KSL_MULF(y, series_phi_p_lo)),
      series_phi_s = KSL_MULF(y, series_phi_r),
      series_phi_r_size_1 = 9.635427e-09f
          + (KSL_MULF(series_phi_c_reach_1, series_phi_q_padded_1)
          + KSL_MULF(series_phi_c_padded_1, series_phi_q_reach_1)),
      series_phi_s_padded_1 = 3.3087225e-24f + series_phi_r_size_1,
      series_phi_s_reach_1 = fabsf(series_phi_r)
          + KSL_MULF(262144.0f, fabsf(series_phi_r_lo)
          + KSL_MULF(2.6805536e-10f, series_phi_s_padded_1)),
      series_phi_t = series_phi_s - 1.0020843e-06f,
      series_phi_t_right_1 = series_phi_s - series_phi_t,
      series_phi_t_lo1_1 = ksl_product_restf(y, series_phi_r, series_phi_s, series_phi_t
          + series_phi_t_right_1) - (1.0020843e-06f - series_phi_t_right_1),
      series_phi_t_lo = series_phi_t_lo1_1 - 3.4596379e-15f
          + (KSL_MULF(y_lo, series_phi_r) + KSL_MULF(y, series_phi_r_lo)),
      series_phi_u = KSL_MULF(y, series_phi_t),
      series_phi_t_size_1 = 1.0020843e-06f
          + (KSL_MULF(series_phi_c_reach_1, series_phi_s_padded_1)
          + KSL_MULF(series_phi_c_padded_1, series_phi_s_reach_1)),
      series_phi_u_padded_1 = 3.3087225e-24f + series_phi_t_size_1,
      series_phi_u_reach_1 = fabsf(series_phi_t)
          + KSL_MULF(262144.0f, fabsf(series_phi_t_lo)
          + KSL_MULF(2.7153774e-10f, series_phi_u_padded_1)),
      series_phi_v = series_phi_u + 6.613757e-05f,
      series_phi_v_right_1 = series_phi_v - series_phi_u,
      series_phi_v_lo1_1 = ksl_product_restf(y, series_phi_t, series_phi_u, series_phi_v
          - series_phi_v_right_1) + (6.613757e-05f - series_phi_v_right_1),
      series_phi_v_lo = series_phi_v_lo1_1 + -9.0853226e-13f
          + (KSL_MULF(y_lo, series_phi_t) + KSL_MULF(y, series_phi_t_lo)),
      series_phi_w = KSL_MULF(y, series_phi_v),
      series_phi_v_size_1 = 6.613757e-05f
          + (KSL_MULF(series_phi_c_reach_1, series_phi_u_padded_1)
          + KSL_MULF(series_phi_c_padded_1, series_phi_u_reach_1)),
      series_phi_w_padded_1 = 3.3087225e-24f + series_phi_v_size_1,
      series_phi_w_reach_1 = fabsf(series_phi_v)
          + KSL_MULF(262144.0f, fabsf(series_phi_v_lo)
          + KSL_MULF(2.7508415e-10f, series_phi_w_padded_1)),
      series_phi_x = series_phi_w - 0.0023809525f,
      series_phi_x_right_1 = series_phi_w - series_phi_x,
      series_phi_x_lo1_1 = ksl_product_restf(y, series_phi_v, series_phi_w, series_phi_x
          + series_phi_x_right_1) - (0.0023809525f - series_phi_x_right_1),
      series_phi_x_lo = series_phi_x_lo1_1 - -9.0914824e-11f
          + (KSL_MULF(y_lo, series_phi_v) + KSL_MULF(y, series_phi_v_lo)),
      series_phi_y = KSL_MULF(y, series_phi_x),
      series_phi_x_size_1 = 0.0023809525f
          + (KSL_MULF(series_phi_c_reach_1, series_phi_w_padded_1)
          + KSL_MULF(series_phi_c_padded_1, series_phi_w_reach_1)),
      series_phi_y_padded_1 = 3.3087225e-24f + series_phi_x_size_1,
      series_phi_y_reach_1 = fabsf(series_phi_x)
          + KSL_MULF(262144.0f, fabsf(series_phi_x_lo)
          + KSL_MULF(2.7869454e-10f, series_phi_y_padded_1)),
      series_phi = series_phi_y + 0.033333335f, series_phi_right_1 = series_phi - series_phi_y,
      series_phi_lo1_1 = ksl_product_restf(y, series_phi_x, series_phi_y, series_phi
          - series_phi_right_1) + (0.033333335f - series_phi_right_1),
      series_phi_lo = series_phi_lo1_1 + -1.7384688e-09f
          + (KSL_MULF(y_lo, series_phi_x) + KSL_MULF(y, series_phi_x_lo));
  const float f_more_a = KSL_MULF(2.0f, y), f_more_a_cross2_1 = KSL_MULF(2.0f, y_lo),
      f_more = KSL_MULF(f_more_a, series_phi),
      f_more_padded_1 = 3.3087225e-24f + KSL_MULF(2.0f, y_size_3);
  const float series_phi_size_1 = 0.033333335f
          + (KSL_MULF(series_phi_c_reach_1, series_phi_y_padded_1)
          + KSL_MULF(series_phi_c_padded_1, series_phi_y_reach_1));
  const float f_more_padded_2 = 3.3087225e-24f + series_phi_size_1,
      f_more_size_2 = KSL_MULF(f_more_padded_2, fabsf(f_more_a)
          + KSL_MULF(262144.0f, fabsf(f_more_a_cross2_1)
          + KSL_MULF(9.116633e-12f, f_more_padded_1))),
      f_more_size_4 = KSL_MULF(f_more_padded_1, fabsf(series_phi)
          + KSL_MULF(262144.0f, fabsf(series_phi_lo) + KSL_MULF(2.8236896e-10f, f_more_padded_2)));
  const float near_f_a = KSL_MULF(0.33333334f, sinc), near_f_b = KSL_MULF(0.33333334f, f_more),
      f_more_lo = ksl_product_errorf(f_more_a, series_phi, f_more)
          + (KSL_MULF(f_more_a_cross2_1, series_phi) + KSL_MULF(f_more_a, series_phi_lo)),
      near_f = near_f_a + near_f_b, near_f_right_1 = near_f - near_f_a,
      near_f_b_cross_1 = KSL_MULF(-9.934108e-09f, f_more) + KSL_MULF(0.33333334f, f_more_lo),
      near_f_left_rest_1 = ksl_product_restf(0.33333334f, sinc, near_f_a, near_f - near_f_right_1),
      near_f_lo1_1 = near_f_left_rest_1
          + ksl_product_restf(0.33333334f, f_more, near_f_b, near_f_right_1),
      near_f_lo = near_f_lo1_1
          + (KSL_MULF(-9.934108e-09f, sinc) + KSL_MULF(0.33333334f, sinc_lo) + near_f_b_cross_1),
      near_f_size_1 = KSL_MULF(0.33333334f, sinc_size_8)
          + KSL_MULF(0.33333334f, f_more_size_2 + f_more_size_4);
  const float f_rest = sinc - c, f_rest_right_1 = sinc - f_rest;
  const float fine_x = KSL_MULF(4.0f, y);
  const float far_y = fine_x < 4.0f ? 1.0f : y, far_y_lo = fine_x < 4.0f ? 0.0f : y_lo,
      far_y_bound_1 = fabsf(KSL_MULF(4.0f, y_lo))
          + KSL_MULF(9.116633e-12f, 3.3087225e-24f + KSL_MULF(4.0f, y_size_3)),
      far_y_size_3 = fabsf(fine_x - 4.0f), far_y_size_7 = fabsf(1.0f - y) + series_phi_c_bound_1;
  const float closed_f = f_rest / far_y, closed_f_product_1 = KSL_MULF(closed_f, far_y),
      closed_f_exact_1 = f_rest - closed_f_product_1
          - ksl_product_errorf(closed_f, far_y, closed_f_product_1),
      closed_f_lo = (closed_f_exact_1
          + (sinc - (f_rest + f_rest_right_1) - (c - f_rest_right_1) - c_lo + sinc_lo)
          - KSL_MULF(closed_f, far_y_lo)) / far_y;
  const float far_y_size_10 = (fine_x < 4.0f ? 1.0f : y_size_3)
          + KSL_MULF(1.0994875e+11f, far_y_bound_1 < far_y_size_3 ? 0.0f : far_y_size_7);
  const float closed_f_padded_2 = 3.3087225e-24f + far_y_size_10, closed_f_size_1 = fabsf(closed_f),
      closed_f_size_2 = fabsf(far_y),
      closed_f_bound_1 = fabsf(far_y_lo) + KSL_MULF(9.3794104e-12f, closed_f_padded_2),
      closed_f_size_4 = 3.3087225e-24f + (c_size_7 + sinc_size_8)
          + KSL_MULF(closed_f_padded_2, closed_f_size_1),
      closed_f_size_8 = closed_f_size_4
          / (KSL_MULF(4.0f, closed_f_bound_1) < closed_f_size_2 ? closed_f_size_2 : 0.0f),
      closed_f_size_11 = closed_f_size_1
          + KSL_MULF(closed_f_size_2 + KSL_MULF(262144.0f, closed_f_bound_1), closed_f_size_8)
          / closed_f_size_2;
  const float f = fine_x < 4.0f ? near_f : closed_f,
      f_size_4 = fabsf(near_f_lo) + KSL_MULF(2.8699676e-10f, 3.3087225e-24f + near_f_size_1)
          + fabsf(near_f - closed_f),
      f_size_5 = fabsf(closed_f_lo) + KSL_MULF(2.4779026e-10f, 3.3087225e-24f + closed_f_size_11)
          + f_size_4;
  const float four_k = KSL_MULF(4.0f, sinc), four_k_cross2_1 = KSL_MULF(4.0f, sinc_lo);
  const float fine_b = f / four_k, fine_b_product_1 = KSL_MULF(fine_b, four_k),
      fine_b_numerator_1 = f - fine_b_product_1
          - ksl_product_errorf(fine_b, four_k, fine_b_product_1)
          + (fine_x < 4.0f ? near_f_lo : closed_f_lo),
      fine_b_lo = (fine_b_numerator_1 - KSL_MULF(fine_b, four_k_cross2_1)) / four_k;
  const float f_size_8 = (fine_x < 4.0f ? near_f_size_1 : closed_f_size_11)
          + KSL_MULF(3.4985805e+09f, far_y_bound_1 < far_y_size_3 ? 0.0f : f_size_5);
  const float fine_b_padded_2 = 3.3087225e-24f + KSL_MULF(4.0f, sinc_size_8),
      fine_b_size_1 = fabsf(fine_b), fine_b_size_2 = fabsf(four_k),
      fine_b_bound_1 = fabsf(four_k_cross2_1) + KSL_MULF(2.4267555e-10f, fine_b_padded_2),
      fine_b_size_7 = KSL_MULF(4.0f, fine_b_bound_1) < fine_b_size_2 ? fine_b_size_2 : 0.0f,
      fine_b_size_8 = (3.3087225e-24f + f_size_8 + KSL_MULF(fine_b_padded_2, fine_b_size_1))
          / fine_b_size_7;
  const float fine_b_across = c / sinc, fine_b_across_product_1 = KSL_MULF(fine_b_across, sinc),
      fine_b_across_numerator_1 = c - fine_b_across_product_1
          - ksl_product_errorf(fine_b_across, sinc, fine_b_across_product_1) + c_lo,
      fine_b_across_lo = (fine_b_across_numerator_1 - KSL_MULF(fine_b_across, sinc_lo)) / sinc,
      fine_b_across_padded_2 = 3.3087225e-24f + sinc_size_8,
      fine_b_across_size_1 = fabsf(fine_b_across), fine_b_across_size_2 = fabsf(sinc),
      fine_b_across_bound_1 = fabsf(sinc_lo) + KSL_MULF(2.4250052e-10f, fine_b_across_padded_2),
      fine_b_across_size_7 = KSL_MULF(4.0f, fine_b_across_bound_1) < fine_b_across_size_2
          ? fine_b_across_size_2 : 0.0f,
      fine_b_across_size_8 = (3.3087225e-24f + c_size_7
          + KSL_MULF(fine_b_across_padded_2, fine_b_across_size_1)) / fine_b_across_size_7,
      fine_b_across_size_10 = KSL_MULF(fine_b_across_size_2
          + KSL_MULF(262144.0f, fine_b_across_bound_1), fine_b_across_size_8)
          / fine_b_across_size_2;
  const float fine_vector_lo_1 = ksl_product_errorf(fine_upper_0, fine_k, fine_vector_0)
          + (KSL_MULF(fine_upper_lo_1, fine_k) + KSL_MULF(fine_upper_0, fine_k_lo)),
      fine_wt_a = KSL_MULF(D->m03, fine_vector_0), fine_wt_a_size_1 = fabsf(D->m03),
      fine_wt_a_padded_1 = 3.3087225e-24f
          + (KSL_MULF(fine_vector_padded_1, fine_vector_reach_1)
          + KSL_MULF(fine_v_s_size_padded_1, fine_vector_reach_2)),
      fine_vector_lo_2 = ksl_product_errorf(fine_upper_1, fine_k, fine_vector_1)
          + (KSL_MULF(fine_upper_lo_2, fine_k) + KSL_MULF(fine_upper_1, fine_k_lo)),
      fine_wt_b = KSL_MULF(D->m13, fine_vector_1), fine_wt_b_size_1 = fabsf(D->m13),
      fine_wt_b_padded_1 = 3.3087225e-24f
          + (KSL_MULF(fine_vector_padded_1, fine_vector_reach_3)
          + KSL_MULF(fine_v_s_size_padded_2, fine_vector_reach_2)),
      fine_wt_c = fine_wt_a + fine_wt_b, fine_wt_c_right_1 = fine_wt_c - fine_wt_a,
      fine_wt_c_left_rest_1 = ksl_product_restf(D->m03, fine_vector_0, fine_wt_a, fine_wt_c
          - fine_wt_c_right_1),
      fine_wt_c_lo1_1 = fine_wt_c_left_rest_1
          + ksl_product_restf(D->m13, fine_vector_1, fine_wt_b, fine_wt_c_right_1),
      fine_vector_lo_3 = ksl_product_errorf(fine_upper_2, fine_k, fine_vector_2)
          + (KSL_MULF(fine_upper_lo_3, fine_k) + KSL_MULF(fine_upper_2, fine_k_lo)),
      fine_wt_d = KSL_MULF(D->m23, fine_vector_2), fine_wt_d_size_1 = fabsf(D->m23),
      fine_wt_d_padded_1 = 3.3087225e-24f
          + (KSL_MULF(fine_vector_padded_1, fine_vector_reach_4)
          + KSL_MULF(fine_v_s_size_padded_3, fine_vector_reach_2)), fine_wt = fine_wt_c + fine_wt_d,
      fine_wt_right_1 = fine_wt - fine_wt_c,
      fine_wt_lo1_1 = fine_wt_c - (fine_wt - fine_wt_right_1)
          + ksl_product_restf(D->m23, fine_vector_2, fine_wt_d, fine_wt_right_1),
      fine_wt_c_lo = fine_wt_c_lo1_1
          + (KSL_MULF(D->m03, fine_vector_lo_1) + KSL_MULF(D->m13, fine_vector_lo_2)),
      fine_wt_lo = fine_wt_lo1_1 + KSL_MULF(D->m23, fine_vector_lo_3) + fine_wt_c_lo,
      fine_wt_c_size_1 = KSL_MULF(fine_wt_a_padded_1, fine_wt_a_size_1)
          + KSL_MULF(fine_wt_b_padded_1, fine_wt_b_size_1);
  const float fine_pitch = KSL_MULF(fine_b, fine_wt),
      fine_pitch_padded_1 = 3.3087225e-24f
          + (fine_b_size_1
          + KSL_MULF(fine_b_size_2 + KSL_MULF(262144.0f, fine_b_bound_1), fine_b_size_8)
          / fine_b_size_2),
      fine_pitch_padded_2 = 3.3087225e-24f
          + (fine_wt_c_size_1 + KSL_MULF(fine_wt_d_padded_1, fine_wt_d_size_1)),
      fine_pitch_reach_1 = fine_b_size_1
          + KSL_MULF(262144.0f, fabsf(fine_b_lo) + KSL_MULF(3.0035874e-10f, fine_pitch_padded_1)),
      fine_pitch_reach_2 = fabsf(fine_wt)
          + KSL_MULF(262144.0f, fabsf(fine_wt_lo) + KSL_MULF(1.1220025e-11f, fine_pitch_padded_2));
  const float fine_pitch_lo = ksl_product_errorf(fine_b, fine_wt, fine_pitch)
          + (KSL_MULF(fine_b_lo, fine_wt) + KSL_MULF(fine_b, fine_wt_lo)),
      fine_along_0 = KSL_MULF(fine_vector_0, fine_pitch),
      fine_along_padded_1 = 3.3087225e-24f
          + (KSL_MULF(fine_pitch_padded_2, fine_pitch_reach_1)
          + KSL_MULF(fine_pitch_padded_1, fine_pitch_reach_2)),
      fine_along_rest_1 = KSL_MULF(1.0146962e-11f, fine_wt_a_padded_1),
      fine_along_reach_2 = fabsf(fine_pitch)
          + KSL_MULF(262144.0f, fabsf(fine_pitch_lo)
          + KSL_MULF(3.0380137e-10f, fine_along_padded_1)),
      fine_along_size_2 = KSL_MULF(fine_along_padded_1, fabsf(fine_vector_0)
          + KSL_MULF(262144.0f, fabsf(fine_vector_lo_1) + fine_along_rest_1));
  const float fine_along_1 = KSL_MULF(fine_vector_1, fine_pitch),
      fine_along_rest_3 = KSL_MULF(1.0146962e-11f, fine_wt_b_padded_1),
      fine_along_size_7 = KSL_MULF(fine_along_padded_1, fabsf(fine_vector_1)
          + KSL_MULF(262144.0f, fabsf(fine_vector_lo_2) + fine_along_rest_3));
  const float fine_along_2 = KSL_MULF(fine_vector_2, fine_pitch),
      fine_along_rest_4 = KSL_MULF(1.0146962e-11f, fine_wt_d_padded_1),
      fine_along_size_11 = KSL_MULF(fine_along_padded_1, fabsf(fine_vector_2)
          + KSL_MULF(262144.0f, fabsf(fine_vector_lo_3) + fine_along_rest_4));
  const float fine_u_0a = KSL_MULF(D->m23, fine_vector_1),
      fine_u_0b = KSL_MULF(D->m13, fine_vector_2), fine_u_0 = fine_u_0a - fine_u_0b,
      fine_u_right_1 = fine_u_0a - fine_u_0,
      fine_u_left_rest_1 = ksl_product_restf(D->m23, fine_vector_1, fine_u_0a, fine_u_0
          + fine_u_right_1),
      fine_u_lo1_1 = fine_u_left_rest_1
          - ksl_product_restf(D->m13, fine_vector_2, fine_u_0b, fine_u_right_1);
  const float fine_u_1a = KSL_MULF(D->m03, fine_vector_2),
      fine_u_1b = KSL_MULF(D->m23, fine_vector_0), fine_u_1 = fine_u_1a - fine_u_1b,
      fine_u_right_2 = fine_u_1a - fine_u_1,
      fine_u_left_rest_2 = ksl_product_restf(D->m03, fine_vector_2, fine_u_1a, fine_u_1
          + fine_u_right_2),
      fine_u_lo1_2 = fine_u_left_rest_2
          - ksl_product_restf(D->m23, fine_vector_0, fine_u_1b, fine_u_right_2);
  const float fine_u_2a = KSL_MULF(D->m13, fine_vector_0),
      fine_u_2b = KSL_MULF(D->m03, fine_vector_1), fine_u_2 = fine_u_2a - fine_u_2b,
      fine_u_right_3 = fine_u_2a - fine_u_2,
      fine_u_left_rest_3 = ksl_product_restf(D->m13, fine_vector_0, fine_u_2a, fine_u_2
          + fine_u_right_3),
      fine_u_lo1_3 = fine_u_left_rest_3
          - ksl_product_restf(D->m03, fine_vector_1, fine_u_2b, fine_u_right_3);
  const float fine_turned_0 = KSL_MULF(0.5f, fine_u_0);
  const float fine_turned_1 = KSL_MULF(0.5f, fine_u_1);
  const float fine_turned_2 = KSL_MULF(0.5f, fine_u_2);
  const float fine_across_axis_0 = fine_along_0 - fine_turned_0,
      fine_across_axis_right_1 = fine_along_0 - fine_across_axis_0,
      fine_across_axis_left_rest_1 = ksl_product_restf(fine_vector_0, fine_pitch, fine_along_0,
          fine_across_axis_0 + fine_across_axis_right_1);
  const float fine_turned_cross2_1 = KSL_MULF(0.5f, fine_u_lo1_1
          + (KSL_MULF(D->m23, fine_vector_lo_2) - KSL_MULF(D->m13, fine_vector_lo_3)));
  const float fine_across_axis_lo2_1 = fine_across_axis_left_rest_1
          - (fine_turned_0 - fine_across_axis_right_1) - fine_turned_cross2_1;
  const float fine_turned_size_1 = KSL_MULF(0.5f, KSL_MULF(fine_wt_b_padded_1, fine_wt_d_size_1)
          + KSL_MULF(fine_wt_b_size_1, fine_wt_d_padded_1));
  const float fine_across_axis_1 = fine_along_1 - fine_turned_1,
      fine_across_axis_right_2 = fine_along_1 - fine_across_axis_1,
      fine_across_axis_left_rest_2 = ksl_product_restf(fine_vector_1, fine_pitch, fine_along_1,
          fine_across_axis_1 + fine_across_axis_right_2);
  const float fine_turned_cross2_2 = KSL_MULF(0.5f, fine_u_lo1_2
          + (KSL_MULF(D->m03, fine_vector_lo_3) - KSL_MULF(D->m23, fine_vector_lo_1)));
  const float fine_across_axis_lo2_2 = fine_across_axis_left_rest_2
          - (fine_turned_1 - fine_across_axis_right_2) - fine_turned_cross2_2;
  const float fine_turned_size_2 = KSL_MULF(0.5f, KSL_MULF(fine_wt_a_size_1, fine_wt_d_padded_1)
          + KSL_MULF(fine_wt_a_padded_1, fine_wt_d_size_1));
  const float fine_across_axis_2 = fine_along_2 - fine_turned_2,
      fine_across_axis_right_3 = fine_along_2 - fine_across_axis_2,
      fine_across_axis_left_rest_3 = ksl_product_restf(fine_vector_2, fine_pitch, fine_along_2,
          fine_across_axis_2 + fine_across_axis_right_3);
  const float fine_turned_cross2_3 = KSL_MULF(0.5f, fine_u_lo1_3
          + (KSL_MULF(D->m13, fine_vector_lo_1) - KSL_MULF(D->m03, fine_vector_lo_2)));
  const float fine_across_axis_lo2_3 = fine_across_axis_left_rest_3
          - (fine_turned_2 - fine_across_axis_right_3) - fine_turned_cross2_3;
  const float fine_turned_size_3 = KSL_MULF(0.5f, KSL_MULF(fine_wt_a_padded_1, fine_wt_b_size_1)
          + KSL_MULF(fine_wt_a_size_1, fine_wt_b_padded_1));
  const float fine_so_0a = KSL_MULF(D->m03, fine_b_across),
      fine_so_0a_padded_1 = 3.3087225e-24f + (fine_b_across_size_1 + fine_b_across_size_10),
      fine_so_0 = fine_so_0a + fine_across_axis_0, fine_so_right_1 = fine_so_0 - fine_so_0a,
      fine_so_lo1_1 = ksl_product_restf(D->m03, fine_b_across, fine_so_0a, fine_so_0
          - fine_so_right_1) + (fine_across_axis_0 - fine_so_right_1),
      fine_so_lo2_1 = fine_so_lo1_1
          + (fine_across_axis_lo2_1
          + (KSL_MULF(fine_vector_lo_1, fine_pitch) + KSL_MULF(fine_vector_0, fine_pitch_lo)));
  const float fine_across_axis_size_1 = fine_along_size_2
          + KSL_MULF(fine_along_reach_2, fine_wt_a_padded_1) + fine_turned_size_1;
  const float fine_so_1a = KSL_MULF(D->m13, fine_b_across),
      fine_so_1 = fine_so_1a + fine_across_axis_1, fine_so_right_2 = fine_so_1 - fine_so_1a,
      fine_so_lo1_2 = ksl_product_restf(D->m13, fine_b_across, fine_so_1a, fine_so_1
          - fine_so_right_2) + (fine_across_axis_1 - fine_so_right_2),
      fine_so_lo2_2 = fine_so_lo1_2
          + (fine_across_axis_lo2_2
          + (KSL_MULF(fine_vector_lo_2, fine_pitch) + KSL_MULF(fine_vector_1, fine_pitch_lo)));
  const float fine_across_axis_size_2 = fine_along_size_7
          + KSL_MULF(fine_along_reach_2, fine_wt_b_padded_1) + fine_turned_size_2;
  const float fine_so_2a = KSL_MULF(D->m23, fine_b_across),
      fine_so_2 = fine_so_2a + fine_across_axis_2, fine_so_right_3 = fine_so_2 - fine_so_2a,
      fine_so_lo1_3 = ksl_product_restf(D->m23, fine_b_across, fine_so_2a, fine_so_2
          - fine_so_right_3) + (fine_across_axis_2 - fine_so_right_3),
      fine_so_lo2_3 = fine_so_lo1_3
          + (fine_across_axis_lo2_3
          + (KSL_MULF(fine_vector_lo_3, fine_pitch) + KSL_MULF(fine_vector_2, fine_pitch_lo)));
  const float fine_across_axis_size_3 = fine_along_size_11
          + KSL_MULF(fine_along_reach_2, fine_wt_d_padded_1) + fine_turned_size_3;
  const float so_rest_1 = KSL_MULF(3.0891278e-10f, 3.3087225e-24f
          + (fine_across_axis_size_1 + KSL_MULF(fine_so_0a_padded_1, fine_wt_a_size_1))),
      so_rest_2 = KSL_MULF(3.0891278e-10f, 3.3087225e-24f
          + (fine_across_axis_size_2 + KSL_MULF(fine_so_0a_padded_1, fine_wt_b_size_1))),
      so_rest_3 = KSL_MULF(3.0891278e-10f, 3.3087225e-24f
          + (fine_across_axis_size_3 + KSL_MULF(fine_so_0a_padded_1, fine_wt_d_size_1)));
  const float D_n_0 = KSL_MULF(D->m11, D->m22) - KSL_MULF(D->m12, D->m21),
      D_n_1 = KSL_MULF(D->m02, D->m21) - KSL_MULF(D->m01, D->m22),
      D_n_2 = KSL_MULF(D->m01, D->m12) - KSL_MULF(D->m02, D->m11);
  const float D_det = KSL_MULF(D->m00, D_n_0) + KSL_MULF(D->m10, D_n_1) + KSL_MULF(D->m20, D_n_2);
  const float D_g_0 = KSL_MULF(D->m00, D->m00) + KSL_MULF(D->m10, D->m10)
          + KSL_MULF(D->m20, D->m20),
      D_g_1 = KSL_MULF(D->m00, D->m01) + KSL_MULF(D->m10, D->m11) + KSL_MULF(D->m20, D->m21),
      D_g_2 = KSL_MULF(D->m00, D->m02) + KSL_MULF(D->m10, D->m12) + KSL_MULF(D->m20, D->m22),
      D_g_3 = KSL_MULF(D->m01, D->m01) + KSL_MULF(D->m11, D->m11) + KSL_MULF(D->m21, D->m21),
      D_g_4 = KSL_MULF(D->m01, D->m02) + KSL_MULF(D->m11, D->m12) + KSL_MULF(D->m21, D->m22),
      D_g_5 = KSL_MULF(D->m02, D->m02) + KSL_MULF(D->m12, D->m12) + KSL_MULF(D->m22, D->m22);
  const float D_off_0 = D_det - 1.0f, D_off_1 = D_g_0 - 1.0f, D_off_4 = D_g_3 - 1.0f,
      D_off_6 = D_g_5 - 1.0f;
  const float D_defect_size_0 = fabsf(D_off_0), D_defect_size_1 = fabsf(D_off_1),
      D_defect_size_2 = fabsf(D_g_1), D_defect_size_3 = fabsf(D_g_2),
      D_defect_size_4 = fabsf(D_off_4), D_defect_size_5 = fabsf(D_g_4),
      D_defect_size_6 = fabsf(D_off_6);
  const float D_defect_largest1 = D_defect_size_0 < D_defect_size_1 ? D_defect_size_1
          : D_defect_size_0;
  const float D_defect_largest2 = D_defect_largest1 < D_defect_size_2 ? D_defect_size_2
          : D_defect_largest1;
  const float D_defect_largest3 = D_defect_largest2 < D_defect_size_3 ? D_defect_size_3
          : D_defect_largest2;
  const float D_defect_largest4 = D_defect_largest3 < D_defect_size_4 ? D_defect_size_4
          : D_defect_largest3;
  const float D_defect_largest5 = D_defect_largest4 < D_defect_size_5 ? D_defect_size_5
          : D_defect_largest4;
  const float D_defect_largest6 = D_defect_largest5 < D_defect_size_6 ? D_defect_size_6
          : D_defect_largest5;
  const float D_unless_equal = D_defect_largest6 == 0.001f ? 0.0f : 1.2676506e+30f;
  const float D_unless_rotation = D_defect_largest6 < 0.001f ? 0.0f : D_unless_equal;
  const float D_excess = KSL_MULF(D_unless_rotation, 1.2676506e+30f),
      D_excess_0 = KSL_MULF(1.0000005f, fabsf(fine_so_lo2_1 + KSL_MULF(D->m03, fine_b_across_lo)
          + (fine_so_0 - so_0))) + so_rest_1 + D_excess,
      D_excess_1 = KSL_MULF(1.0000005f, fabsf(fine_so_lo2_2 + KSL_MULF(D->m13, fine_b_across_lo)
          + (fine_so_1 - so_1))) + so_rest_2 + D_excess,
      D_excess_2 = KSL_MULF(1.0000005f, fabsf(fine_so_lo2_3 + KSL_MULF(D->m23, fine_b_across_lo)
          + (fine_so_2 - so_2))) + so_rest_3 + D_excess,
      D_excess_3 = fine_along_rest_1
          + KSL_MULF(1.0000005f, fabsf(fine_vector_lo_1 + (fine_vector_0 - vector_0))) + D_excess,
      D_excess_4 = fine_along_rest_3
          + KSL_MULF(1.0000005f, fabsf(fine_vector_lo_2 + (fine_vector_1 - vector_1))) + D_excess,
      D_excess_5 = fine_along_rest_4
          + KSL_MULF(1.0000005f, fabsf(fine_vector_lo_3 + (fine_vector_2 - vector_2))) + D_excess;
  so->m0 = so_0;
  so->m1 = so_1;
  so->m2 = so_2;
  so->m3 = vector_0;
  so->m4 = vector_1;
  so->m5 = vector_2;
  so_bound->m0 = D_excess_0;
  so_bound->m1 = D_excess_1;
  so_bound->m2 = D_excess_2;
  so_bound->m3 = D_excess_3;
  so_bound->m4 = D_excess_4;
  so_bound->m5 = D_excess_5;
}

#endif
