/* Made by `coscrew generate`; changes are overwritten. */
/* SPDX-License-Identifier: MIT */
/* coscrew 0.2.0.  Copyright (c) 2026 The coscrew authors. */
/* Exponentials and logarithms of rotations and displacements, their Jacobians, interpolation. */
#ifndef KSL_EXPONENTIAL_H
#define KSL_EXPONENTIAL_H

#include "ksl_types.h"
#include "elementary.h"
#include "quaternion.h"
#include "SE3.h"
#include "screw.h"

/* R = exp v~ = I + sin θ/θ v~ + (1 - cos θ)/θ^2 v~^2, θ = |v|.
   v: vector; R: rotation or other 3×3 matrix.
   77 mul, 102 add, 3 div, 1 sqrt, 5 abs, 5 less, 11 select.
   Error <= R: (6 + θ/200) u of its largest component for |v| <= 1e13, in single precision 1e5;
     searched, not proved. */
static inline void ksl_SO3_exp(const ksl_vec3_t *v, ksl_mat3x3_t *R) {
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
  const double beta_v_0 = KSL_MUL(v->x, g2), beta_v_1 = KSL_MUL(v->y, g2),
      beta_v_2 = KSL_MUL(v->z, g2);
  const double m_0 = KSL_MUL(v->x, beta_v_0), m_1 = KSL_MUL(v->y, beta_v_1),
      m_2 = KSL_MUL(v->z, beta_v_2), m_3 = KSL_MUL(v->y, beta_v_0), m_4 = KSL_MUL(v->z, beta_v_0),
      m_5 = KSL_MUL(v->z, beta_v_1);
  const double others_0 = m_1 + m_2, others_1 = m_0 + m_2, others_2 = m_0 + m_1;
  const double diagonal0a = 1.0 - others_0, diagonal0b = g0 + m_0,
      diagonal0 = m_0 < others_0 ? diagonal0b : diagonal0a;
  const double diagonal1a = 1.0 - others_1, diagonal1b = g0 + m_1,
      diagonal1 = m_1 < others_1 ? diagonal1b : diagonal1a;
  const double diagonal2a = 1.0 - others_2, diagonal2b = g0 + m_2,
      diagonal2 = m_2 < others_2 ? diagonal2b : diagonal2a;
  const double alpha_v_0 = KSL_MUL(v->x, g1), alpha_v_1 = KSL_MUL(v->y, g1),
      alpha_v_2 = KSL_MUL(v->z, g1);
  const double R_01 = m_3 - alpha_v_2, R_02 = m_4 + alpha_v_1, R_10 = m_3 + alpha_v_2,
      R_12 = m_5 - alpha_v_0, R_20 = m_4 - alpha_v_1, R_21 = m_5 + alpha_v_0;
  R->m00 = diagonal0;
  R->m01 = R_01;
  R->m02 = R_02;
  R->m10 = R_10;
  R->m11 = diagonal1;
  R->m12 = R_12;
  R->m20 = R_20;
  R->m21 = R_21;
  R->m22 = diagonal2;
}

/* vo with exp vo~ = R, |vo| <= π; if R is not quite a rotation, its defect carries over to vo.
   R: rotation or other 3×3 matrix; vo: vector.
   40 mul, 51 add, 2 div, 1 sqrt, 6 neg, 5 abs, 2 copysign, 18 less, 2 equal, 39 select.
   Error <= vo: 7 u of its largest component for R a rotation; searched, not proved. */
static inline void ksl_SO3_log(const ksl_mat3x3_t *R, ksl_vec3_t *vo) {
  const double p_0 = R->m21 - R->m12, p_1 = R->m02 - R->m20, p_2 = R->m10 - R->m01;
  const double s_0 = R->m12 + R->m21, s_1 = R->m02 + R->m20, s_2 = R->m01 + R->m10;
  const double first_0 = R->m00 + 1.0, first_1 = 1.0 - R->m00;
  const double others_0 = R->m11 + R->m22, others_1 = R->m11 - R->m22;
  const double d_0 = first_0 + others_0, d_1 = first_0 - others_0, d_2 = first_1 + others_1,
      d_3 = first_1 - others_1;
  const double low_0 = R->m11 < R->m00 ? d_1 : s_2, low_1 = R->m11 < R->m00 ? s_2 : d_2,
      low_2 = R->m11 < R->m00 ? s_1 : s_0, low_3 = R->m11 < R->m00 ? p_0 : p_1;
  const double high_0a = -R->m11, high_0 = R->m00 < high_0a ? s_1 : p_0;
  const double high_1 = R->m00 < high_0a ? s_0 : p_1, high_2 = R->m00 < high_0a ? d_3 : p_2,
      high_3 = R->m00 < high_0a ? p_2 : d_0;
  const double column_0 = R->m22 < 0.0 ? low_0 : high_0, column_1 = R->m22 < 0.0 ? low_1 : high_1,
      column_2 = R->m22 < 0.0 ? low_2 : high_2, column_3 = R->m22 < 0.0 ? low_3 : high_3;
  const double upper_0a = -column_0, upper_0 = column_3 < 0.0 ? upper_0a : column_0;
  const double upper_1a = -column_1, upper_1 = column_3 < 0.0 ? upper_1a : column_1;
  const double upper_2a = -column_2, upper_2 = column_3 < 0.0 ? upper_2a : column_2;
  const double upper_3a = -column_3, upper_3 = column_3 < 0.0 ? upper_3a : column_3;
  const double v_s_size_0 = fabs(upper_0), v_s_size_1 = fabs(upper_1), v_s_size_2 = fabs(upper_2);
  const double v_s_largest1 = v_s_size_0 < v_s_size_1 ? v_s_size_1 : v_s_size_0;
  const double v_s_largest2 = v_s_largest1 < v_s_size_2 ? v_s_size_2 : v_s_largest1;
  const double v_s_b = 6.703903964971299e+153 < v_s_largest2 ? 3.7291703656001034e-155 : 1.0,
      v_s_d = v_s_largest2 < 256.0 ? 1.3093562431584567e+151 : v_s_b,
      v_s = v_s_largest2 < 1.955159272639747e-149 ? 1.0715086071862673e+301 : v_s_d;
  const double v_y_0 = KSL_MUL(upper_0, v_s), v_y_1 = KSL_MUL(upper_1, v_s),
      v_y_2 = KSL_MUL(upper_2, v_s);
  const double v_n = sqrt(KSL_MUL(v_y_0, v_y_0) + KSL_MUL(v_y_1, v_y_1) + KSL_MUL(v_y_2, v_y_2));
  const double v_r_b = v_s < 1.0 ? 2.6815615859885194e+154 : 1.0,
      v_r_d = 1.0 < v_s ? 7.637340908749012e-152 : v_r_b,
      v_r = 1.3093562431584567e+151 < v_s ? 9.332636185032189e-302 : v_r_d;
  const double n = KSL_MUL(v_n, v_r);
  const double half = ksl_atan2(n, upper_3);
  const double divisor = n == 0.0 ? 1.0 : n;
  const double theta = KSL_MUL(2.0, half);
  const double k = theta / divisor;
  const double vector_0 = KSL_MUL(upper_0, k), vector_1 = KSL_MUL(upper_1, k),
      vector_2 = KSL_MUL(upper_2, k);
  vo->x = vector_0;
  vo->y = vector_1;
  vo->z = vector_2;
}

/* R = J_l(v) = I + (1 - cos θ)/θ^2 v~ + (θ - sin θ)/θ^3 v~^2, θ = |v|.
   v: vector; R: rotation or other 3×3 matrix.
   88 mul, 114 add, 4 div, 1 sqrt, 5 abs, 6 less, 12 select.
   Error <= R: (7 + θ/200) u of its largest component for |v| <= 1e13, in single precision 1e5;
     searched, not proved. */
static inline void ksl_SO3_leftJacobian(const ksl_vec3_t *v, ksl_mat3x3_t *R) {
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
  const double beta_v_0 = KSL_MUL(v->x, g3), beta_v_1 = KSL_MUL(v->y, g3),
      beta_v_2 = KSL_MUL(v->z, g3);
  const double m_0 = KSL_MUL(v->x, beta_v_0), m_1 = KSL_MUL(v->y, beta_v_1),
      m_2 = KSL_MUL(v->z, beta_v_2), m_3 = KSL_MUL(v->y, beta_v_0), m_4 = KSL_MUL(v->z, beta_v_0),
      m_5 = KSL_MUL(v->z, beta_v_1);
  const double others_0 = m_1 + m_2, others_1 = m_0 + m_2, others_2 = m_0 + m_1;
  const double diagonal0a = 1.0 - others_0, diagonal0b = g1 + m_0,
      diagonal0 = m_0 < others_0 ? diagonal0b : diagonal0a;
  const double diagonal1a = 1.0 - others_1, diagonal1b = g1 + m_1,
      diagonal1 = m_1 < others_1 ? diagonal1b : diagonal1a;
  const double diagonal2a = 1.0 - others_2, diagonal2b = g1 + m_2,
      diagonal2 = m_2 < others_2 ? diagonal2b : diagonal2a;
  const double alpha_v_0 = KSL_MUL(v->x, g2), alpha_v_1 = KSL_MUL(v->y, g2),
      alpha_v_2 = KSL_MUL(v->z, g2);
  const double R_01 = m_3 - alpha_v_2, R_02 = m_4 + alpha_v_1, R_10 = m_3 + alpha_v_2,
      R_12 = m_5 - alpha_v_0, R_20 = m_4 - alpha_v_1, R_21 = m_5 + alpha_v_0;
  R->m00 = diagonal0;
  R->m01 = R_01;
  R->m02 = R_02;
  R->m10 = R_10;
  R->m11 = diagonal1;
  R->m12 = R_12;
  R->m20 = R_20;
  R->m21 = R_21;
  R->m22 = diagonal2;
}

/* R = J_r(v) = I - (1 - cos θ)/θ^2 v~ + (θ - sin θ)/θ^3 v~^2, θ = |v|.
   v: vector; R: rotation or other 3×3 matrix.
   88 mul, 114 add, 4 div, 1 sqrt, 3 neg, 5 abs, 6 less, 12 select.
   Error <= R: (7 + θ/200) u of its largest component for |v| <= 1e13, in single precision 1e5;
     searched, not proved. */
static inline void ksl_SO3_rightJacobian(const ksl_vec3_t *v, ksl_mat3x3_t *R) {
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
  const double beta_v_0 = KSL_MUL(v->x, g3), beta_v_1 = KSL_MUL(v->y, g3),
      beta_v_2 = KSL_MUL(v->z, g3);
  const double m_0 = KSL_MUL(v->x, beta_v_0), m_1 = KSL_MUL(v->y, beta_v_1),
      m_2 = KSL_MUL(v->z, beta_v_2), m_3 = KSL_MUL(v->y, beta_v_0), m_4 = KSL_MUL(v->z, beta_v_0),
      m_5 = KSL_MUL(v->z, beta_v_1);
  const double others_0 = m_1 + m_2, others_1 = m_0 + m_2, others_2 = m_0 + m_1;
  const double diagonal0a = 1.0 - others_0, diagonal0b = g1 + m_0,
      diagonal0 = m_0 < others_0 ? diagonal0b : diagonal0a;
  const double diagonal1a = 1.0 - others_1, diagonal1b = g1 + m_1,
      diagonal1 = m_1 < others_1 ? diagonal1b : diagonal1a;
  const double diagonal2a = 1.0 - others_2, diagonal2b = g1 + m_2,
      diagonal2 = m_2 < others_2 ? diagonal2b : diagonal2a;
  const double alpha_v_0 = -KSL_MUL(v->x, g2), alpha_v_1 = -KSL_MUL(v->y, g2),
      alpha_v_2 = -KSL_MUL(v->z, g2);
  const double R_01 = m_3 - alpha_v_2, R_02 = m_4 + alpha_v_1, R_10 = m_3 + alpha_v_2,
      R_12 = m_5 - alpha_v_0, R_20 = m_4 - alpha_v_1, R_21 = m_5 + alpha_v_0;
  R->m00 = diagonal0;
  R->m01 = R_01;
  R->m02 = R_02;
  R->m10 = R_10;
  R->m11 = diagonal1;
  R->m12 = R_12;
  R->m20 = R_20;
  R->m21 = R_21;
  R->m22 = diagonal2;
}

/* R = J_l(v)^-1 = I - v~/2 + (1 - θ/2 cot θ/2)/θ^2 v~^2, θ = |v|; singular at multiples of 2π
     except 0.
   v: vector; R: rotation or other 3×3 matrix.
   71 mul, 96 add, 3 div, 1 sqrt, 3 neg, 5 abs, 7 less, 12 select.
   Error <= R: 6 u of its largest component for |v| <= π; searched, not proved. */
static inline void ksl_SO3_leftJacobianInverse(const ksl_vec3_t *v, ksl_mat3x3_t *R) {
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
  const double beta_v_0 = KSL_MUL(v->x, b), beta_v_1 = KSL_MUL(v->y, b),
      beta_v_2 = KSL_MUL(v->z, b);
  const double m_0 = KSL_MUL(v->x, beta_v_0), m_1 = KSL_MUL(v->y, beta_v_1),
      m_2 = KSL_MUL(v->z, beta_v_2), m_3 = KSL_MUL(v->y, beta_v_0), m_4 = KSL_MUL(v->z, beta_v_0),
      m_5 = KSL_MUL(v->z, beta_v_1);
  const double others_0 = m_1 + m_2, others_1 = m_0 + m_2, others_2 = m_0 + m_1;
  const double diagonal0a = 1.0 - others_0, diagonal0b = b_across + m_0,
      diagonal0 = m_0 < others_0 ? diagonal0b : diagonal0a;
  const double diagonal1a = 1.0 - others_1, diagonal1b = b_across + m_1,
      diagonal1 = m_1 < others_1 ? diagonal1b : diagonal1a;
  const double diagonal2a = 1.0 - others_2, diagonal2b = b_across + m_2,
      diagonal2 = m_2 < others_2 ? diagonal2b : diagonal2a;
  const double alpha_v_0 = -KSL_MUL(0.5, v->x), alpha_v_1 = -KSL_MUL(0.5, v->y),
      alpha_v_2 = -KSL_MUL(0.5, v->z);
  const double R_01 = m_3 - alpha_v_2, R_02 = m_4 + alpha_v_1, R_10 = m_3 + alpha_v_2,
      R_12 = m_5 - alpha_v_0, R_20 = m_4 - alpha_v_1, R_21 = m_5 + alpha_v_0;
  R->m00 = diagonal0;
  R->m01 = R_01;
  R->m02 = R_02;
  R->m10 = R_10;
  R->m11 = diagonal1;
  R->m12 = R_12;
  R->m20 = R_20;
  R->m21 = R_21;
  R->m22 = diagonal2;
}

/* R = J_r(v)^-1 = I + v~/2 + (1 - θ/2 cot θ/2)/θ^2 v~^2, θ = |v|; singular at multiples of 2π
     except 0.
   v: vector; R: rotation or other 3×3 matrix.
   71 mul, 96 add, 3 div, 1 sqrt, 5 abs, 7 less, 12 select.
   Error <= R: 6 u of its largest component for |v| <= π; searched, not proved. */
static inline void ksl_SO3_rightJacobianInverse(const ksl_vec3_t *v, ksl_mat3x3_t *R) {
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
  const double beta_v_0 = KSL_MUL(v->x, b), beta_v_1 = KSL_MUL(v->y, b),
      beta_v_2 = KSL_MUL(v->z, b);
  const double m_0 = KSL_MUL(v->x, beta_v_0), m_1 = KSL_MUL(v->y, beta_v_1),
      m_2 = KSL_MUL(v->z, beta_v_2), m_3 = KSL_MUL(v->y, beta_v_0), m_4 = KSL_MUL(v->z, beta_v_0),
      m_5 = KSL_MUL(v->z, beta_v_1);
  const double others_0 = m_1 + m_2, others_1 = m_0 + m_2, others_2 = m_0 + m_1;
  const double diagonal0a = 1.0 - others_0, diagonal0b = b_across + m_0,
      diagonal0 = m_0 < others_0 ? diagonal0b : diagonal0a;
  const double diagonal1a = 1.0 - others_1, diagonal1b = b_across + m_1,
      diagonal1 = m_1 < others_1 ? diagonal1b : diagonal1a;
  const double diagonal2a = 1.0 - others_2, diagonal2b = b_across + m_2,
      diagonal2 = m_2 < others_2 ? diagonal2b : diagonal2a;
  const double alpha_v_0 = KSL_MUL(0.5, v->x), alpha_v_1 = KSL_MUL(0.5, v->y),
      alpha_v_2 = KSL_MUL(0.5, v->z);
  const double R_01 = m_3 - alpha_v_2, R_02 = m_4 + alpha_v_1, R_10 = m_3 + alpha_v_2,
      R_12 = m_5 - alpha_v_0, R_20 = m_4 - alpha_v_1, R_21 = m_5 + alpha_v_0;
  R->m00 = diagonal0;
  R->m01 = R_01;
  R->m02 = R_02;
  R->m10 = R_10;
  R->m11 = diagonal1;
  R->m12 = R_12;
  R->m20 = R_20;
  R->m21 = R_21;
  R->m22 = diagonal2;
}

/* self = R + R (I - R^T R)/2, closer to a rotation: a defect d of R becomes 3/4 d^2.
   self: rotation or other 3×3 matrix.
   51 mul, 42 add, 3 neg.
   Error <= u |result| + 7 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_mat3x3_orthonormalize(ksl_mat3x3_t *self) {
  const double defect_0 = 1.0 - KSL_MUL(self->m00, self->m00) - KSL_MUL(self->m10, self->m10)
          - KSL_MUL(self->m20, self->m20),
      defect_1 = 1.0 - KSL_MUL(self->m01, self->m01) - KSL_MUL(self->m11, self->m11)
          - KSL_MUL(self->m21, self->m21),
      defect_2 = 1.0 - KSL_MUL(self->m02, self->m02) - KSL_MUL(self->m12, self->m12)
          - KSL_MUL(self->m22, self->m22),
      defect_3 =
          -(KSL_MUL(self->m00, self->m01) + KSL_MUL(self->m10, self->m11)
          + KSL_MUL(self->m20, self->m21)),
      defect_4 =
          -(KSL_MUL(self->m00, self->m02) + KSL_MUL(self->m10, self->m12)
          + KSL_MUL(self->m20, self->m22)),
      defect_5 =
          -(KSL_MUL(self->m01, self->m02) + KSL_MUL(self->m11, self->m12)
          + KSL_MUL(self->m21, self->m22));
  const double correction_0 = KSL_MUL(0.5, defect_0), correction_1 = KSL_MUL(0.5, defect_1),
      correction_2 = KSL_MUL(0.5, defect_2), correction_3 = KSL_MUL(0.5, defect_3),
      correction_4 = KSL_MUL(0.5, defect_4), correction_5 = KSL_MUL(0.5, defect_5);
  const double self_00_new = self->m00
          + (KSL_MUL(self->m00, correction_0) + KSL_MUL(self->m01, correction_3)
          + KSL_MUL(self->m02, correction_4)),
      self_01_new = KSL_MUL(self->m00, correction_3) + KSL_MUL(self->m01, correction_1)
          + KSL_MUL(self->m02, correction_5) + self->m01,
      self_02_new = KSL_MUL(self->m00, correction_4) + KSL_MUL(self->m01, correction_5)
          + KSL_MUL(self->m02, correction_2) + self->m02,
      self_10_new = self->m10
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
  self->m00 = self_00_new;
  self->m01 = self_01_new;
  self->m02 = self_02_new;
  self->m10 = self_10_new;
  self->m11 = self_11_new;
  self->m12 = self_12_new;
  self->m20 = self_20_new;
  self->m21 = self_21_new;
  self->m22 = self_22_new;
}

/* Ro = R + R (I - R^T R)/2, closer to a rotation: a defect d of R becomes 3/4 d^2.
   R, Ro: rotation or other 3×3 matrix.
   51 mul, 42 add, 3 neg.
   Error <= u |result| + 7 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_mat3x3_orthonormalized(const ksl_mat3x3_t *R, ksl_mat3x3_t *Ro) {
  const double defect_0 = 1.0 - KSL_MUL(R->m00, R->m00) - KSL_MUL(R->m10, R->m10)
          - KSL_MUL(R->m20, R->m20),
      defect_1 = 1.0 - KSL_MUL(R->m01, R->m01) - KSL_MUL(R->m11, R->m11) - KSL_MUL(R->m21, R->m21),
      defect_2 = 1.0 - KSL_MUL(R->m02, R->m02) - KSL_MUL(R->m12, R->m12) - KSL_MUL(R->m22, R->m22),
      defect_3 = -(KSL_MUL(R->m00, R->m01) + KSL_MUL(R->m10, R->m11) + KSL_MUL(R->m20, R->m21)),
      defect_4 = -(KSL_MUL(R->m00, R->m02) + KSL_MUL(R->m10, R->m12) + KSL_MUL(R->m20, R->m22)),
      defect_5 = -(KSL_MUL(R->m01, R->m02) + KSL_MUL(R->m11, R->m12) + KSL_MUL(R->m21, R->m22));
  const double correction_0 = KSL_MUL(0.5, defect_0), correction_1 = KSL_MUL(0.5, defect_1),
      correction_2 = KSL_MUL(0.5, defect_2), correction_3 = KSL_MUL(0.5, defect_3),
      correction_4 = KSL_MUL(0.5, defect_4), correction_5 = KSL_MUL(0.5, defect_5);
  const double Ro_00 = R->m00
          + (KSL_MUL(R->m00, correction_0) + KSL_MUL(R->m01, correction_3)
          + KSL_MUL(R->m02, correction_4)),
      Ro_01 = KSL_MUL(R->m00, correction_3) + KSL_MUL(R->m01, correction_1)
          + KSL_MUL(R->m02, correction_5) + R->m01,
      Ro_02 = KSL_MUL(R->m00, correction_4) + KSL_MUL(R->m01, correction_5)
          + KSL_MUL(R->m02, correction_2) + R->m02,
      Ro_10 = R->m10
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

/* D = exp s = [exp ω~ | J_l(ω) v].
   s: screw (v in m/s; ω in rad/s); D: displacement [R | t], R rotation, t in m.
   108 mul, 126 add, 4 div, 1 sqrt, 5 abs, 6 less, 13 select.
   Error <= R: (6 + θ/200) u, t: (14 + θ/200) u of its largest component, or of s.lin if that is
     larger, for |ω of s| <= 1e13, in single precision 1e5; searched, not proved.  Intermediate
     sums may overflow where |v|, or |ω| |v|, is above 2e306, in single precision 5e36. */
static inline void ksl_SE3_exp(const ksl_screw_t *s, ksl_SE3_t *D) {
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
  const double u_0 = KSL_MUL(s->m2, s->m4) - KSL_MUL(s->m1, s->m5),
      u_1 = KSL_MUL(s->m0, s->m5) - KSL_MUL(s->m2, s->m3),
      u_2 = KSL_MUL(s->m1, s->m3) - KSL_MUL(s->m0, s->m4);
  const double turned_0 = KSL_MUL(g2, u_0), turned_1 = KSL_MUL(g2, u_1),
      turned_2 = KSL_MUL(g2, u_2);
  const double wv = KSL_MUL(s->m0, s->m3) + KSL_MUL(s->m1, s->m4) + KSL_MUL(s->m2, s->m5);
  const double pitch = KSL_MUL(g3, wv);
  const double along_0 = KSL_MUL(s->m3, pitch), along_1 = KSL_MUL(s->m4, pitch),
      along_2 = KSL_MUL(s->m5, pitch);
  const double beta_v_0 = KSL_MUL(s->m3, g2), beta_v_1 = KSL_MUL(s->m4, g2),
      beta_v_2 = KSL_MUL(s->m5, g2);
  const double m_0 = KSL_MUL(s->m3, beta_v_0), m_1 = KSL_MUL(s->m4, beta_v_1),
      m_2 = KSL_MUL(s->m5, beta_v_2), m_3 = KSL_MUL(s->m4, beta_v_0),
      m_4 = KSL_MUL(s->m5, beta_v_0), m_5 = KSL_MUL(s->m5, beta_v_1);
  const double others_0 = m_1 + m_2, others_1 = m_0 + m_2, others_2 = m_0 + m_1;
  const double diagonal0a = 1.0 - others_0, diagonal0b = g0 + m_0,
      diagonal0 = m_0 < others_0 ? diagonal0b : diagonal0a;
  const double diagonal1a = 1.0 - others_1, diagonal1b = g0 + m_1,
      diagonal1 = m_1 < others_1 ? diagonal1b : diagonal1a;
  const double diagonal2a = 1.0 - others_2, diagonal2b = g0 + m_2,
      diagonal2 = m_2 < others_2 ? diagonal2b : diagonal2a;
  const double alpha_v_0 = KSL_MUL(s->m3, g1), alpha_v_1 = KSL_MUL(s->m4, g1),
      alpha_v_2 = KSL_MUL(s->m5, g1);
  const double across_axis_0 = turned_0 + along_0, across_axis_1 = turned_1 + along_1,
      across_axis_2 = turned_2 + along_2;
  const double D_01 = m_3 - alpha_v_2, D_02 = m_4 + alpha_v_1,
      D_03 = KSL_MUL(s->m0, g1) + across_axis_0, D_10 = m_3 + alpha_v_2, D_12 = m_5 - alpha_v_0,
      D_13 = KSL_MUL(s->m1, g1) + across_axis_1, D_20 = m_4 - alpha_v_1, D_21 = m_5 + alpha_v_0,
      D_23 = KSL_MUL(s->m2, g1) + across_axis_2;
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
}

/* so with exp so = D, |ω| <= π: (J_l(ω)^-1 t; ω), ω = log R.
   D: displacement [R | t], R rotation, t in m; so: screw (v in m/s; ω in rad/s).
   79 mul, 80 add, 4 div, 1 sqrt, 6 neg, 5 abs, 2 copysign, 20 less, 2 equal, 43 select.
   Error <= lin: 18 u, ang: 8 u of its largest component for R of D a rotation; searched, not
     proved.  Intermediate sums may overflow where |t| is above 2e306, in single precision 5e36. */
static inline void ksl_SE3_log(const ksl_SE3_t *D, ksl_screw_t *so) {
  const double p_0 = D->m21 - D->m12, p_1 = D->m02 - D->m20, p_2 = D->m10 - D->m01;
  const double s_0 = D->m12 + D->m21, s_1 = D->m02 + D->m20, s_2 = D->m01 + D->m10;
  const double first_0 = D->m00 + 1.0, first_1 = 1.0 - D->m00;
  const double others_0 = D->m11 + D->m22, others_1 = D->m11 - D->m22;
  const double d_0 = first_0 + others_0, d_1 = first_0 - others_0, d_2 = first_1 + others_1,
      d_3 = first_1 - others_1;
  const double low_0 = D->m11 < D->m00 ? d_1 : s_2, low_1 = D->m11 < D->m00 ? s_2 : d_2,
      low_2 = D->m11 < D->m00 ? s_1 : s_0, low_3 = D->m11 < D->m00 ? p_0 : p_1;
  const double high_0a = -D->m11, high_0 = D->m00 < high_0a ? s_1 : p_0;
  const double high_1 = D->m00 < high_0a ? s_0 : p_1, high_2 = D->m00 < high_0a ? d_3 : p_2,
      high_3 = D->m00 < high_0a ? p_2 : d_0;
  const double column_0 = D->m22 < 0.0 ? low_0 : high_0, column_1 = D->m22 < 0.0 ? low_1 : high_1,
      column_2 = D->m22 < 0.0 ? low_2 : high_2, column_3 = D->m22 < 0.0 ? low_3 : high_3;
  const double upper_0a = -column_0, upper_0 = column_3 < 0.0 ? upper_0a : column_0;
  const double upper_1a = -column_1, upper_1 = column_3 < 0.0 ? upper_1a : column_1;
  const double upper_2a = -column_2, upper_2 = column_3 < 0.0 ? upper_2a : column_2;
  const double upper_3a = -column_3, upper_3 = column_3 < 0.0 ? upper_3a : column_3;
  const double v_s_size_0 = fabs(upper_0), v_s_size_1 = fabs(upper_1), v_s_size_2 = fabs(upper_2);
  const double v_s_largest1 = v_s_size_0 < v_s_size_1 ? v_s_size_1 : v_s_size_0;
  const double v_s_largest2 = v_s_largest1 < v_s_size_2 ? v_s_size_2 : v_s_largest1;
  const double v_s_b = 6.703903964971299e+153 < v_s_largest2 ? 3.7291703656001034e-155 : 1.0,
      v_s_d = v_s_largest2 < 256.0 ? 1.3093562431584567e+151 : v_s_b,
      v_s = v_s_largest2 < 1.955159272639747e-149 ? 1.0715086071862673e+301 : v_s_d;
  const double v_y_0 = KSL_MUL(upper_0, v_s), v_y_1 = KSL_MUL(upper_1, v_s),
      v_y_2 = KSL_MUL(upper_2, v_s);
  const double v_n = sqrt(KSL_MUL(v_y_0, v_y_0) + KSL_MUL(v_y_1, v_y_1) + KSL_MUL(v_y_2, v_y_2));
  const double v_r_b = v_s < 1.0 ? 2.6815615859885194e+154 : 1.0,
      v_r_d = 1.0 < v_s ? 7.637340908749012e-152 : v_r_b,
      v_r = 1.3093562431584567e+151 < v_s ? 9.332636185032189e-302 : v_r_d;
  const double n = KSL_MUL(v_n, v_r);
  const double half = ksl_atan2(n, upper_3);
  const double divisor = n == 0.0 ? 1.0 : n;
  const double theta = KSL_MUL(2.0, half);
  const double k = theta / divisor;
  const double vector_0 = KSL_MUL(upper_0, k), vector_1 = KSL_MUL(upper_1, k),
      vector_2 = KSL_MUL(upper_2, k);
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
  const double along_0 = KSL_MUL(vector_0, pitch), along_1 = KSL_MUL(vector_1, pitch),
      along_2 = KSL_MUL(vector_2, pitch);
  const double u_0 = KSL_MUL(D->m23, vector_1) - KSL_MUL(D->m13, vector_2),
      u_1 = KSL_MUL(D->m03, vector_2) - KSL_MUL(D->m23, vector_0),
      u_2 = KSL_MUL(D->m13, vector_0) - KSL_MUL(D->m03, vector_1);
  const double turned_0 = KSL_MUL(0.5, u_0), turned_1 = KSL_MUL(0.5, u_1),
      turned_2 = KSL_MUL(0.5, u_2);
  const double across_axis_0 = along_0 - turned_0, across_axis_1 = along_1 - turned_1,
      across_axis_2 = along_2 - turned_2;
  const double so_0 = KSL_MUL(D->m03, b_across) + across_axis_0,
      so_1 = KSL_MUL(D->m13, b_across) + across_axis_1,
      so_2 = KSL_MUL(D->m23, b_across) + across_axis_2;
  so->m0 = so_0;
  so->m1 = so_1;
  so->m2 = so_2;
  so->m3 = vector_0;
  so->m4 = vector_1;
  so->m5 = vector_2;
}

/* M = J_l(s) = Σ ([ad](s))^k / (k+1)!.
   s: screw (v in m/s; ω in rad/s); M: 6×6 operator.
   149 mul, 166 add, 6 div, 1 sqrt, 1 neg, 5 abs, 7 less, 15 select.
   Error <= M: 20 u of its largest component for |ω of s| <= π; searched, not proved.
     Intermediate sums may overflow where |v| is above 2e306, in single precision 5e36. */
static inline void ksl_SE3_leftJacobian(const ksl_screw_t *s, ksl_mat6x6_t *M) {
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
  const double late_x = x < 9.0 ? 1.0 : x;
  const double rate2_rest = g1 - KSL_MUL(2.0, g2);
  const double closed_rate2 = rate2_rest / late_x;
  const double rate3_rest = g2 - KSL_MUL(3.0, g3);
  const double closed_rate3 = rate3_rest / late_x;
  const double rate2g = KSL_MUL(x, KSL_MUL(x, KSL_MUL(x, 5.951031031739514e-26
          - KSL_MUL(8.527712016381578e-29, x)) - 3.54582265641146e-23) + 1.7793582784901146e-20),
      rate2n = KSL_MUL(x, KSL_MUL(x, KSL_MUL(x, rate2g - 7.398571721961897e-18)
          + 2.499073114973796e-15) - 6.691268265342339e-13) + 1.376489471727567e-10,
      rate2u = KSL_MUL(x, KSL_MUL(x, KSL_MUL(x, KSL_MUL(x, rate2n) - 2.08767569878681e-08)
          + 2.204585537918871e-06) - 0.00014880952380952382),
      rate2x = KSL_MUL(x, rate2u + 0.005555555555555556) - 0.08333333333333333,
      rate2 = x < 9.0 ? rate2x : closed_rate2;
  const double rate3f = KSL_MUL(x, KSL_MUL(x, 2.204085567310931e-27
          - KSL_MUL(2.9405903504764064e-30, x)) - 1.4183290625645841e-24) + 7.736340341261368e-22,
      rate3m = KSL_MUL(x, KSL_MUL(x, KSL_MUL(x, KSL_MUL(x, rate3f) - 3.523129391410427e-19)
          + 1.3153016394598927e-16) - 3.936040156083729e-14),
      rate3t = KSL_MUL(x, KSL_MUL(x, KSL_MUL(x, rate3m + 9.17659647818378e-12)
          - 1.6059043836821615e-09) + 2.0041686708353376e-07) - 1.6534391534391536e-05,
      rate3x = KSL_MUL(x, KSL_MUL(x, rate3t) + 0.0007936507936507937) - 0.016666666666666666,
      rate3 = x < 9.0 ? rate3x : closed_rate3;
  const double beta_v_0 = KSL_MUL(s->m3, g3), beta_v_1 = KSL_MUL(s->m4, g3),
      beta_v_2 = KSL_MUL(s->m5, g3);
  const double m_0 = KSL_MUL(s->m3, beta_v_0), m_1 = KSL_MUL(s->m4, beta_v_1),
      m_2 = KSL_MUL(s->m5, beta_v_2), m_3 = KSL_MUL(s->m4, beta_v_0),
      m_4 = KSL_MUL(s->m5, beta_v_0), m_5 = KSL_MUL(s->m5, beta_v_1);
  const double others_0 = m_1 + m_2, others_1 = m_0 + m_2, others_2 = m_0 + m_1;
  const double diagonal0a = 1.0 - others_0, diagonal0b = g1 + m_0,
      diagonal0 = m_0 < others_0 ? diagonal0b : diagonal0a;
  const double diagonal1a = 1.0 - others_1, diagonal1b = g1 + m_1,
      diagonal1 = m_1 < others_1 ? diagonal1b : diagonal1a;
  const double diagonal2a = 1.0 - others_2, diagonal2b = g1 + m_2,
      diagonal2 = m_2 < others_2 ? diagonal2b : diagonal2a;
  const double alpha_v_0 = KSL_MUL(s->m3, g2), alpha_v_1 = KSL_MUL(s->m4, g2),
      alpha_v_2 = KSL_MUL(s->m5, g2);
  const double J_1 = m_3 - alpha_v_2, J_2 = m_4 + alpha_v_1, J_3 = m_3 + alpha_v_2,
      J_5 = m_5 - alpha_v_0, J_6 = m_4 - alpha_v_1, J_7 = m_5 + alpha_v_0;
  const double rate_vw = KSL_MUL(s->m0, s->m3) + KSL_MUL(s->m1, s->m4) + KSL_MUL(s->m2, s->m5);
  const double rate_turn = KSL_MUL(rate2, rate_vw);
  const double rate_bend = -KSL_MUL(rate3, rate_vw);
  const double rate_q_0 = KSL_MUL(s->m0, g2) + KSL_MUL(s->m3, rate_turn),
      rate_q_1 = KSL_MUL(s->m1, g2) + KSL_MUL(s->m4, rate_turn),
      rate_q_2 = KSL_MUL(s->m2, g2) + KSL_MUL(s->m5, rate_turn);
  const double rate_beta_v_0 = KSL_MUL(s->m0, g3), rate_beta_v_1 = KSL_MUL(s->m1, g3),
      rate_beta_v_2 = KSL_MUL(s->m2, g3);
  const double rate_bend_w_0 = KSL_MUL(s->m3, rate_bend), rate_bend_w_1 = KSL_MUL(s->m4, rate_bend),
      rate_bend_w_2 = KSL_MUL(s->m5, rate_bend);
  const double rate_symmetric_0 = KSL_MUL(s->m3, rate_beta_v_1) + KSL_MUL(s->m4, rate_beta_v_0)
          - KSL_MUL(s->m4, rate_bend_w_0),
      rate_symmetric_1 = KSL_MUL(s->m3, rate_beta_v_2) + KSL_MUL(s->m5, rate_beta_v_0)
          - KSL_MUL(s->m5, rate_bend_w_0),
      rate_symmetric_2 = KSL_MUL(s->m4, rate_beta_v_2) + KSL_MUL(s->m5, rate_beta_v_1)
          - KSL_MUL(s->m5, rate_bend_w_1);
  const double rate_diagonal_0a = KSL_MUL(s->m4, rate_bend_w_1),
      rate_diagonal_0b = KSL_MUL(s->m5, rate_bend_w_2),
      rate_diagonal_0e = KSL_MUL(KSL_MUL(2.0, s->m4), rate_beta_v_1),
      rate_diagonal_0g = KSL_MUL(KSL_MUL(2.0, s->m5), rate_beta_v_2),
      rate_diagonal_0 = rate_diagonal_0a + rate_diagonal_0b - (rate_diagonal_0e + rate_diagonal_0g);
  const double rate_diagonal_1a = KSL_MUL(s->m3, rate_bend_w_0),
      rate_diagonal_1d = KSL_MUL(KSL_MUL(2.0, s->m3), rate_beta_v_0),
      rate_diagonal_1 = rate_diagonal_1a + rate_diagonal_0b - (rate_diagonal_1d + rate_diagonal_0g);
  const double rate_diagonal_2 = rate_diagonal_1a + rate_diagonal_0a
          - (rate_diagonal_1d + rate_diagonal_0e);
  const double M_04 = rate_symmetric_0 - rate_q_2, M_05 = rate_q_1 + rate_symmetric_1,
      M_13 = rate_q_2 + rate_symmetric_0, M_15 = rate_symmetric_2 - rate_q_0,
      M_23 = rate_symmetric_1 - rate_q_1, M_24 = rate_q_0 + rate_symmetric_2;
  M->at[0][0] = diagonal0;
  M->at[1][0] = J_1;
  M->at[2][0] = J_2;
  M->at[3][0] = rate_diagonal_0;
  M->at[4][0] = M_04;
  M->at[5][0] = M_05;
  M->at[0][1] = J_3;
  M->at[1][1] = diagonal1;
  M->at[2][1] = J_5;
  M->at[3][1] = M_13;
  M->at[4][1] = rate_diagonal_1;
  M->at[5][1] = M_15;
  M->at[0][2] = J_6;
  M->at[1][2] = J_7;
  M->at[2][2] = diagonal2;
  M->at[3][2] = M_23;
  M->at[4][2] = M_24;
  M->at[5][2] = rate_diagonal_2;
  M->at[0][3] = 0.0;
  M->at[1][3] = 0.0;
  M->at[2][3] = 0.0;
  M->at[3][3] = diagonal0;
  M->at[4][3] = J_1;
  M->at[5][3] = J_2;
  M->at[0][4] = 0.0;
  M->at[1][4] = 0.0;
  M->at[2][4] = 0.0;
  M->at[3][4] = J_3;
  M->at[4][4] = diagonal1;
  M->at[5][4] = J_5;
  M->at[0][5] = 0.0;
  M->at[1][5] = 0.0;
  M->at[2][5] = 0.0;
  M->at[3][5] = J_6;
  M->at[4][5] = J_7;
  M->at[5][5] = diagonal2;
}

/* M = J_r(s) = Σ (-[ad](s))^k / (k+1)!.
   s: screw (v in m/s; ω in rad/s); M: 6×6 operator.
   149 mul, 166 add, 6 div, 1 sqrt, 13 neg, 5 abs, 7 less, 15 select.
   Error <= M: 20 u of its largest component for |ω of s| <= π; searched, not proved.
     Intermediate sums may overflow where |v| is above 2e306, in single precision 5e36. */
static inline void ksl_SE3_rightJacobian(const ksl_screw_t *s, ksl_mat6x6_t *M) {
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
  const double late_x = x < 9.0 ? 1.0 : x;
  const double rate2_rest = g1 - KSL_MUL(2.0, g2);
  const double closed_rate2 = rate2_rest / late_x;
  const double rate3_rest = g2 - KSL_MUL(3.0, g3);
  const double closed_rate3 = rate3_rest / late_x;
  const double rate2g = KSL_MUL(x, KSL_MUL(x, KSL_MUL(x, 5.951031031739514e-26
          - KSL_MUL(8.527712016381578e-29, x)) - 3.54582265641146e-23) + 1.7793582784901146e-20),
      rate2n = KSL_MUL(x, KSL_MUL(x, KSL_MUL(x, rate2g - 7.398571721961897e-18)
          + 2.499073114973796e-15) - 6.691268265342339e-13) + 1.376489471727567e-10,
      rate2u = KSL_MUL(x, KSL_MUL(x, KSL_MUL(x, KSL_MUL(x, rate2n) - 2.08767569878681e-08)
          + 2.204585537918871e-06) - 0.00014880952380952382),
      rate2x = KSL_MUL(x, rate2u + 0.005555555555555556) - 0.08333333333333333,
      rate2 = x < 9.0 ? rate2x : closed_rate2;
  const double rate3f = KSL_MUL(x, KSL_MUL(x, 2.204085567310931e-27
          - KSL_MUL(2.9405903504764064e-30, x)) - 1.4183290625645841e-24) + 7.736340341261368e-22,
      rate3m = KSL_MUL(x, KSL_MUL(x, KSL_MUL(x, KSL_MUL(x, rate3f) - 3.523129391410427e-19)
          + 1.3153016394598927e-16) - 3.936040156083729e-14),
      rate3t = KSL_MUL(x, KSL_MUL(x, KSL_MUL(x, rate3m + 9.17659647818378e-12)
          - 1.6059043836821615e-09) + 2.0041686708353376e-07) - 1.6534391534391536e-05,
      rate3x = KSL_MUL(x, KSL_MUL(x, rate3t) + 0.0007936507936507937) - 0.016666666666666666,
      rate3 = x < 9.0 ? rate3x : closed_rate3;
  const double beta_v_0 = KSL_MUL(s->m3, g3), beta_v_1 = KSL_MUL(s->m4, g3),
      beta_v_2 = KSL_MUL(s->m5, g3);
  const double m_0 = KSL_MUL(s->m3, beta_v_0), m_1 = KSL_MUL(s->m4, beta_v_1),
      m_2 = KSL_MUL(s->m5, beta_v_2), m_3 = KSL_MUL(s->m4, beta_v_0),
      m_4 = KSL_MUL(s->m5, beta_v_0), m_5 = KSL_MUL(s->m5, beta_v_1);
  const double others_0 = m_1 + m_2, others_1 = m_0 + m_2, others_2 = m_0 + m_1;
  const double diagonal0a = 1.0 - others_0, diagonal0b = g1 + m_0,
      diagonal0 = m_0 < others_0 ? diagonal0b : diagonal0a;
  const double diagonal1a = 1.0 - others_1, diagonal1b = g1 + m_1,
      diagonal1 = m_1 < others_1 ? diagonal1b : diagonal1a;
  const double diagonal2a = 1.0 - others_2, diagonal2b = g1 + m_2,
      diagonal2 = m_2 < others_2 ? diagonal2b : diagonal2a;
  const double alpha_v_0 = -KSL_MUL(s->m3, g2), alpha_v_1 = -KSL_MUL(s->m4, g2),
      alpha_v_2 = -KSL_MUL(s->m5, g2);
  const double J_1 = m_3 - alpha_v_2, J_2 = m_4 + alpha_v_1, J_3 = m_3 + alpha_v_2,
      J_5 = m_5 - alpha_v_0, J_6 = m_4 - alpha_v_1, J_7 = m_5 + alpha_v_0;
  const double rate_vw = KSL_MUL(s->m0, s->m3) + KSL_MUL(s->m1, s->m4) + KSL_MUL(s->m2, s->m5);
  const double rate_turn = KSL_MUL(rate2, rate_vw);
  const double rate_bend = -KSL_MUL(rate3, rate_vw);
  const double rate_q_0 = -(KSL_MUL(s->m0, g2) + KSL_MUL(s->m3, rate_turn)),
      rate_q_1 = -(KSL_MUL(s->m1, g2) + KSL_MUL(s->m4, rate_turn)),
      rate_q_2 = -(KSL_MUL(s->m2, g2) + KSL_MUL(s->m5, rate_turn));
  const double rate_beta_v_0 = -KSL_MUL(s->m0, g3), rate_beta_v_1 = -KSL_MUL(s->m1, g3),
      rate_beta_v_2 = -KSL_MUL(s->m2, g3);
  const double rate_bend_w_0 = -KSL_MUL(s->m3, rate_bend),
      rate_bend_w_1 = -KSL_MUL(s->m4, rate_bend), rate_bend_w_2 = -KSL_MUL(s->m5, rate_bend);
  const double rate_symmetric_0 = KSL_MUL(s->m4, rate_bend_w_0)
          - (KSL_MUL(s->m3, rate_beta_v_1) + KSL_MUL(s->m4, rate_beta_v_0)),
      rate_symmetric_1 = KSL_MUL(s->m5, rate_bend_w_0)
          - (KSL_MUL(s->m3, rate_beta_v_2) + KSL_MUL(s->m5, rate_beta_v_0)),
      rate_symmetric_2 = KSL_MUL(s->m5, rate_bend_w_1)
          - (KSL_MUL(s->m4, rate_beta_v_2) + KSL_MUL(s->m5, rate_beta_v_1));
  const double rate_diagonal_0b = KSL_MUL(KSL_MUL(2.0, s->m4), rate_beta_v_1),
      rate_diagonal_0d = KSL_MUL(KSL_MUL(2.0, s->m5), rate_beta_v_2),
      rate_diagonal_0f = KSL_MUL(s->m4, rate_bend_w_1),
      rate_diagonal_0g = KSL_MUL(s->m5, rate_bend_w_2),
      rate_diagonal_0 = rate_diagonal_0b + rate_diagonal_0d - (rate_diagonal_0f + rate_diagonal_0g);
  const double rate_diagonal_1b = KSL_MUL(KSL_MUL(2.0, s->m3), rate_beta_v_0),
      rate_diagonal_1d = KSL_MUL(s->m3, rate_bend_w_0),
      rate_diagonal_1 = rate_diagonal_1b + rate_diagonal_0d - (rate_diagonal_1d + rate_diagonal_0g);
  const double rate_diagonal_2 = rate_diagonal_1b + rate_diagonal_0b
          - (rate_diagonal_1d + rate_diagonal_0f);
  const double M_04 = rate_symmetric_0 - rate_q_2, M_05 = rate_q_1 + rate_symmetric_1,
      M_13 = rate_q_2 + rate_symmetric_0, M_15 = rate_symmetric_2 - rate_q_0,
      M_23 = rate_symmetric_1 - rate_q_1, M_24 = rate_q_0 + rate_symmetric_2;
  M->at[0][0] = diagonal0;
  M->at[1][0] = J_1;
  M->at[2][0] = J_2;
  M->at[3][0] = rate_diagonal_0;
  M->at[4][0] = M_04;
  M->at[5][0] = M_05;
  M->at[0][1] = J_3;
  M->at[1][1] = diagonal1;
  M->at[2][1] = J_5;
  M->at[3][1] = M_13;
  M->at[4][1] = rate_diagonal_1;
  M->at[5][1] = M_15;
  M->at[0][2] = J_6;
  M->at[1][2] = J_7;
  M->at[2][2] = diagonal2;
  M->at[3][2] = M_23;
  M->at[4][2] = M_24;
  M->at[5][2] = rate_diagonal_2;
  M->at[0][3] = 0.0;
  M->at[1][3] = 0.0;
  M->at[2][3] = 0.0;
  M->at[3][3] = diagonal0;
  M->at[4][3] = J_1;
  M->at[5][3] = J_2;
  M->at[0][4] = 0.0;
  M->at[1][4] = 0.0;
  M->at[2][4] = 0.0;
  M->at[3][4] = J_3;
  M->at[4][4] = diagonal1;
  M->at[5][4] = J_5;
  M->at[0][5] = 0.0;
  M->at[1][5] = 0.0;
  M->at[2][5] = 0.0;
  M->at[3][5] = J_6;
  M->at[4][5] = J_7;
  M->at[5][5] = diagonal2;
}

/* M = J_l(s)^-1; singular where |ω| is a multiple of 2π except 0.
   s: screw (v in m/s; ω in rad/s); M: 6×6 operator.
   121 mul, 139 add, 5 div, 1 sqrt, 7 neg, 5 abs, 7 less, 13 select.
   Error <= M: 14 u of its largest component for |ω of s| <= π; searched, not proved.
     Intermediate sums may overflow where |v| is above 2e306, in single precision 5e36. */
static inline void ksl_SE3_leftJacobianInverse(const ksl_screw_t *s, ksl_mat6x6_t *M) {
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
  const double beta_v_0 = KSL_MUL(s->m3, b), beta_v_1 = KSL_MUL(s->m4, b),
      beta_v_2 = KSL_MUL(s->m5, b);
  const double m_0 = KSL_MUL(s->m3, beta_v_0), m_1 = KSL_MUL(s->m4, beta_v_1),
      m_2 = KSL_MUL(s->m5, beta_v_2), m_3 = KSL_MUL(s->m4, beta_v_0),
      m_4 = KSL_MUL(s->m5, beta_v_0), m_5 = KSL_MUL(s->m5, beta_v_1);
  const double others_0 = m_1 + m_2, others_1 = m_0 + m_2, others_2 = m_0 + m_1;
  const double diagonal0a = 1.0 - others_0, diagonal0b = b_across + m_0,
      diagonal0 = m_0 < others_0 ? diagonal0b : diagonal0a;
  const double diagonal1a = 1.0 - others_1, diagonal1b = b_across + m_1,
      diagonal1 = m_1 < others_1 ? diagonal1b : diagonal1a;
  const double diagonal2a = 1.0 - others_2, diagonal2b = b_across + m_2,
      diagonal2 = m_2 < others_2 ? diagonal2b : diagonal2a;
  const double alpha_v_0 = -KSL_MUL(0.5, s->m3), alpha_v_1 = -KSL_MUL(0.5, s->m4),
      alpha_v_2 = -KSL_MUL(0.5, s->m5);
  const double J_1 = m_3 - alpha_v_2, J_2 = m_4 + alpha_v_1, J_3 = m_3 + alpha_v_2,
      J_5 = m_5 - alpha_v_0, J_6 = m_4 - alpha_v_1, J_7 = m_5 + alpha_v_0;
  const double b_rate_across = (2.0 - half_cotangent) / b_divisor;
  const double b_rate_square = 0.25 + KSL_MUL(0.25, KSL_MUL(cotangent, cotangent));
  const double b_rate_rest = b_rate_square - b_rate_across;
  const double closed_b_rate = b_rate_rest / b_divisor;
  const double b_rate_f = KSL_MUL(x, KSL_MUL(x, KSL_MUL(3.3612243325542163e-29, x)
          + 1.2532382798262054e-27) + 4.656551921967568e-26) + 1.7234372006616606e-24,
      b_rate_m = KSL_MUL(x, KSL_MUL(x, KSL_MUL(x, KSL_MUL(x, b_rate_f) + 6.350266866545513e-23)
          + 2.327914531029762e-21) + 8.483296895110721e-20),
      b_rate_s = KSL_MUL(x, KSL_MUL(x, KSL_MUL(x, b_rate_m + 3.069982230878755e-18)
          + 1.1018005656720459e-16) + 3.914763657404511e-15),
      b_rate_y = KSL_MUL(x, KSL_MUL(x, KSL_MUL(x, b_rate_s + 1.3737699290044552e-13)
          + 4.745552414851616e-12) + 1.6059043836821613e-10),
      b_rate_ae = KSL_MUL(x, KSL_MUL(x, KSL_MUL(x, b_rate_y + 5.2841901386874934e-09)
          + 1.670140559029448e-07) + 4.96031746031746e-06),
      b_rate_ah = KSL_MUL(x, b_rate_ae + 0.00013227513227513228) + 0.002777777777777778,
      b_rate = x < 4.0 ? b_rate_ah : closed_b_rate;
  const double rate_vw = KSL_MUL(s->m0, s->m3) + KSL_MUL(s->m1, s->m4) + KSL_MUL(s->m2, s->m5);
  const double rate_bend = -KSL_MUL(b_rate, rate_vw);
  const double rate_q_0 = -KSL_MUL(0.5, s->m0), rate_q_1 = -KSL_MUL(0.5, s->m1),
      rate_q_2 = -KSL_MUL(0.5, s->m2);
  const double rate_beta_v_0 = KSL_MUL(s->m0, b), rate_beta_v_1 = KSL_MUL(s->m1, b),
      rate_beta_v_2 = KSL_MUL(s->m2, b);
  const double rate_bend_w_0 = KSL_MUL(s->m3, rate_bend), rate_bend_w_1 = KSL_MUL(s->m4, rate_bend),
      rate_bend_w_2 = KSL_MUL(s->m5, rate_bend);
  const double rate_symmetric_0 = KSL_MUL(s->m3, rate_beta_v_1) + KSL_MUL(s->m4, rate_beta_v_0)
          - KSL_MUL(s->m4, rate_bend_w_0),
      rate_symmetric_1 = KSL_MUL(s->m3, rate_beta_v_2) + KSL_MUL(s->m5, rate_beta_v_0)
          - KSL_MUL(s->m5, rate_bend_w_0),
      rate_symmetric_2 = KSL_MUL(s->m4, rate_beta_v_2) + KSL_MUL(s->m5, rate_beta_v_1)
          - KSL_MUL(s->m5, rate_bend_w_1);
  const double rate_diagonal_0a = KSL_MUL(s->m4, rate_bend_w_1),
      rate_diagonal_0b = KSL_MUL(s->m5, rate_bend_w_2),
      rate_diagonal_0e = KSL_MUL(KSL_MUL(2.0, s->m4), rate_beta_v_1),
      rate_diagonal_0g = KSL_MUL(KSL_MUL(2.0, s->m5), rate_beta_v_2),
      rate_diagonal_0 = rate_diagonal_0a + rate_diagonal_0b - (rate_diagonal_0e + rate_diagonal_0g);
  const double rate_diagonal_1a = KSL_MUL(s->m3, rate_bend_w_0),
      rate_diagonal_1d = KSL_MUL(KSL_MUL(2.0, s->m3), rate_beta_v_0),
      rate_diagonal_1 = rate_diagonal_1a + rate_diagonal_0b - (rate_diagonal_1d + rate_diagonal_0g);
  const double rate_diagonal_2 = rate_diagonal_1a + rate_diagonal_0a
          - (rate_diagonal_1d + rate_diagonal_0e);
  const double M_04 = rate_symmetric_0 - rate_q_2, M_05 = rate_q_1 + rate_symmetric_1,
      M_13 = rate_q_2 + rate_symmetric_0, M_15 = rate_symmetric_2 - rate_q_0,
      M_23 = rate_symmetric_1 - rate_q_1, M_24 = rate_q_0 + rate_symmetric_2;
  M->at[0][0] = diagonal0;
  M->at[1][0] = J_1;
  M->at[2][0] = J_2;
  M->at[3][0] = rate_diagonal_0;
  M->at[4][0] = M_04;
  M->at[5][0] = M_05;
  M->at[0][1] = J_3;
  M->at[1][1] = diagonal1;
  M->at[2][1] = J_5;
  M->at[3][1] = M_13;
  M->at[4][1] = rate_diagonal_1;
  M->at[5][1] = M_15;
  M->at[0][2] = J_6;
  M->at[1][2] = J_7;
  M->at[2][2] = diagonal2;
  M->at[3][2] = M_23;
  M->at[4][2] = M_24;
  M->at[5][2] = rate_diagonal_2;
  M->at[0][3] = 0.0;
  M->at[1][3] = 0.0;
  M->at[2][3] = 0.0;
  M->at[3][3] = diagonal0;
  M->at[4][3] = J_1;
  M->at[5][3] = J_2;
  M->at[0][4] = 0.0;
  M->at[1][4] = 0.0;
  M->at[2][4] = 0.0;
  M->at[3][4] = J_3;
  M->at[4][4] = diagonal1;
  M->at[5][4] = J_5;
  M->at[0][5] = 0.0;
  M->at[1][5] = 0.0;
  M->at[2][5] = 0.0;
  M->at[3][5] = J_6;
  M->at[4][5] = J_7;
  M->at[5][5] = diagonal2;
}

/* M = J_r(s)^-1; singular where |ω| is a multiple of 2π except 0.
   s: screw (v in m/s; ω in rad/s); M: 6×6 operator.
   121 mul, 139 add, 5 div, 1 sqrt, 7 neg, 5 abs, 7 less, 13 select.
   Error <= M: 14 u of its largest component for |ω of s| <= π; searched, not proved.
     Intermediate sums may overflow where |v| is above 2e306, in single precision 5e36. */
static inline void ksl_SE3_rightJacobianInverse(const ksl_screw_t *s, ksl_mat6x6_t *M) {
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
  const double beta_v_0 = KSL_MUL(s->m3, b), beta_v_1 = KSL_MUL(s->m4, b),
      beta_v_2 = KSL_MUL(s->m5, b);
  const double m_0 = KSL_MUL(s->m3, beta_v_0), m_1 = KSL_MUL(s->m4, beta_v_1),
      m_2 = KSL_MUL(s->m5, beta_v_2), m_3 = KSL_MUL(s->m4, beta_v_0),
      m_4 = KSL_MUL(s->m5, beta_v_0), m_5 = KSL_MUL(s->m5, beta_v_1);
  const double others_0 = m_1 + m_2, others_1 = m_0 + m_2, others_2 = m_0 + m_1;
  const double diagonal0a = 1.0 - others_0, diagonal0b = b_across + m_0,
      diagonal0 = m_0 < others_0 ? diagonal0b : diagonal0a;
  const double diagonal1a = 1.0 - others_1, diagonal1b = b_across + m_1,
      diagonal1 = m_1 < others_1 ? diagonal1b : diagonal1a;
  const double diagonal2a = 1.0 - others_2, diagonal2b = b_across + m_2,
      diagonal2 = m_2 < others_2 ? diagonal2b : diagonal2a;
  const double alpha_v_0 = KSL_MUL(0.5, s->m3), alpha_v_1 = KSL_MUL(0.5, s->m4),
      alpha_v_2 = KSL_MUL(0.5, s->m5);
  const double J_1 = m_3 - alpha_v_2, J_2 = m_4 + alpha_v_1, J_3 = m_3 + alpha_v_2,
      J_5 = m_5 - alpha_v_0, J_6 = m_4 - alpha_v_1, J_7 = m_5 + alpha_v_0;
  const double b_rate_across = (2.0 - half_cotangent) / b_divisor;
  const double b_rate_square = 0.25 + KSL_MUL(0.25, KSL_MUL(cotangent, cotangent));
  const double b_rate_rest = b_rate_square - b_rate_across;
  const double closed_b_rate = b_rate_rest / b_divisor;
  const double b_rate_f = KSL_MUL(x, KSL_MUL(x, KSL_MUL(3.3612243325542163e-29, x)
          + 1.2532382798262054e-27) + 4.656551921967568e-26) + 1.7234372006616606e-24,
      b_rate_m = KSL_MUL(x, KSL_MUL(x, KSL_MUL(x, KSL_MUL(x, b_rate_f) + 6.350266866545513e-23)
          + 2.327914531029762e-21) + 8.483296895110721e-20),
      b_rate_s = KSL_MUL(x, KSL_MUL(x, KSL_MUL(x, b_rate_m + 3.069982230878755e-18)
          + 1.1018005656720459e-16) + 3.914763657404511e-15),
      b_rate_y = KSL_MUL(x, KSL_MUL(x, KSL_MUL(x, b_rate_s + 1.3737699290044552e-13)
          + 4.745552414851616e-12) + 1.6059043836821613e-10),
      b_rate_ae = KSL_MUL(x, KSL_MUL(x, KSL_MUL(x, b_rate_y + 5.2841901386874934e-09)
          + 1.670140559029448e-07) + 4.96031746031746e-06),
      b_rate_ah = KSL_MUL(x, b_rate_ae + 0.00013227513227513228) + 0.002777777777777778,
      b_rate = x < 4.0 ? b_rate_ah : closed_b_rate;
  const double rate_vw = KSL_MUL(s->m0, s->m3) + KSL_MUL(s->m1, s->m4) + KSL_MUL(s->m2, s->m5);
  const double rate_bend = -KSL_MUL(b_rate, rate_vw);
  const double rate_q_0 = KSL_MUL(0.5, s->m0), rate_q_1 = KSL_MUL(0.5, s->m1),
      rate_q_2 = KSL_MUL(0.5, s->m2);
  const double rate_beta_v_0 = -KSL_MUL(s->m0, b), rate_beta_v_1 = -KSL_MUL(s->m1, b),
      rate_beta_v_2 = -KSL_MUL(s->m2, b);
  const double rate_bend_w_0 = -KSL_MUL(s->m3, rate_bend),
      rate_bend_w_1 = -KSL_MUL(s->m4, rate_bend), rate_bend_w_2 = -KSL_MUL(s->m5, rate_bend);
  const double rate_symmetric_0 = KSL_MUL(s->m4, rate_bend_w_0)
          - (KSL_MUL(s->m3, rate_beta_v_1) + KSL_MUL(s->m4, rate_beta_v_0)),
      rate_symmetric_1 = KSL_MUL(s->m5, rate_bend_w_0)
          - (KSL_MUL(s->m3, rate_beta_v_2) + KSL_MUL(s->m5, rate_beta_v_0)),
      rate_symmetric_2 = KSL_MUL(s->m5, rate_bend_w_1)
          - (KSL_MUL(s->m4, rate_beta_v_2) + KSL_MUL(s->m5, rate_beta_v_1));
  const double rate_diagonal_0b = KSL_MUL(KSL_MUL(2.0, s->m4), rate_beta_v_1),
      rate_diagonal_0d = KSL_MUL(KSL_MUL(2.0, s->m5), rate_beta_v_2),
      rate_diagonal_0f = KSL_MUL(s->m4, rate_bend_w_1),
      rate_diagonal_0g = KSL_MUL(s->m5, rate_bend_w_2),
      rate_diagonal_0 = rate_diagonal_0b + rate_diagonal_0d - (rate_diagonal_0f + rate_diagonal_0g);
  const double rate_diagonal_1b = KSL_MUL(KSL_MUL(2.0, s->m3), rate_beta_v_0),
      rate_diagonal_1d = KSL_MUL(s->m3, rate_bend_w_0),
      rate_diagonal_1 = rate_diagonal_1b + rate_diagonal_0d - (rate_diagonal_1d + rate_diagonal_0g);
  const double rate_diagonal_2 = rate_diagonal_1b + rate_diagonal_0b
          - (rate_diagonal_1d + rate_diagonal_0f);
  const double M_04 = rate_symmetric_0 - rate_q_2, M_05 = rate_q_1 + rate_symmetric_1,
      M_13 = rate_q_2 + rate_symmetric_0, M_15 = rate_symmetric_2 - rate_q_0,
      M_23 = rate_symmetric_1 - rate_q_1, M_24 = rate_q_0 + rate_symmetric_2;
  M->at[0][0] = diagonal0;
  M->at[1][0] = J_1;
  M->at[2][0] = J_2;
  M->at[3][0] = rate_diagonal_0;
  M->at[4][0] = M_04;
  M->at[5][0] = M_05;
  M->at[0][1] = J_3;
  M->at[1][1] = diagonal1;
  M->at[2][1] = J_5;
  M->at[3][1] = M_13;
  M->at[4][1] = rate_diagonal_1;
  M->at[5][1] = M_15;
  M->at[0][2] = J_6;
  M->at[1][2] = J_7;
  M->at[2][2] = diagonal2;
  M->at[3][2] = M_23;
  M->at[4][2] = M_24;
  M->at[5][2] = rate_diagonal_2;
  M->at[0][3] = 0.0;
  M->at[1][3] = 0.0;
  M->at[2][3] = 0.0;
  M->at[3][3] = diagonal0;
  M->at[4][3] = J_1;
  M->at[5][3] = J_2;
  M->at[0][4] = 0.0;
  M->at[1][4] = 0.0;
  M->at[2][4] = 0.0;
  M->at[3][4] = J_3;
  M->at[4][4] = diagonal1;
  M->at[5][4] = J_5;
  M->at[0][5] = 0.0;
  M->at[1][5] = 0.0;
  M->at[2][5] = 0.0;
  M->at[3][5] = J_6;
  M->at[4][5] = J_7;
  M->at[5][5] = diagonal2;
}

/* Do = D1 exp(k log(D1^-1 D2)), the screw motion from D1 at k = 0 to D2 at k = 1.
   D1, D2, Do: displacement [R | t], R rotation, t in m; k: number.
   265 mul, 260 add, 8 div, 2 sqrt, 6 neg, 10 abs, 2 copysign, 26 less, 2 equal, 56 select.
   Error <= R: 22 u, t: 60 u of its largest component, or of D1.t or D2.t if that is larger, for
     R of D1 a rotation and R of D2 a rotation and 0 <= k <= 1; searched, not proved.
     Intermediate sums may overflow where |t| of D1 or D2 is above 2e306, in single precision
     5e36. */
static inline void ksl_SE3_interpolated(const ksl_SE3_t *D1, const ksl_SE3_t *D2, const double k,
    ksl_SE3_t *Do) {
  const double apart_0 = D2->m03 - D1->m03, apart_1 = D2->m13 - D1->m13,
      apart_2 = D2->m23 - D1->m23;
  const double between_0 = KSL_MUL(D1->m00, D2->m00) + KSL_MUL(D1->m10, D2->m10)
          + KSL_MUL(D1->m20, D2->m20),
      between_1 = KSL_MUL(D1->m00, D2->m01) + KSL_MUL(D1->m10, D2->m11) + KSL_MUL(D1->m20, D2->m21),
      between_2 = KSL_MUL(D1->m00, D2->m02) + KSL_MUL(D1->m10, D2->m12) + KSL_MUL(D1->m20, D2->m22),
      between_3 = KSL_MUL(D1->m00, apart_0) + KSL_MUL(D1->m10, apart_1) + KSL_MUL(D1->m20, apart_2),
      between_4 = KSL_MUL(D1->m01, D2->m00) + KSL_MUL(D1->m11, D2->m10) + KSL_MUL(D1->m21, D2->m20),
      between_5 = KSL_MUL(D1->m01, D2->m01) + KSL_MUL(D1->m11, D2->m11) + KSL_MUL(D1->m21, D2->m21),
      between_6 = KSL_MUL(D1->m01, D2->m02) + KSL_MUL(D1->m11, D2->m12) + KSL_MUL(D1->m21, D2->m22),
      between_7 = KSL_MUL(D1->m01, apart_0) + KSL_MUL(D1->m11, apart_1) + KSL_MUL(D1->m21, apart_2),
      between_8 = KSL_MUL(D1->m02, D2->m00) + KSL_MUL(D1->m12, D2->m10) + KSL_MUL(D1->m22, D2->m20),
      between_9 = KSL_MUL(D1->m02, D2->m01) + KSL_MUL(D1->m12, D2->m11) + KSL_MUL(D1->m22, D2->m21),
      between_10 = KSL_MUL(D1->m02, D2->m02) + KSL_MUL(D1->m12, D2->m12)
          + KSL_MUL(D1->m22, D2->m22),
      between_11 = KSL_MUL(D1->m02, apart_0) + KSL_MUL(D1->m12, apart_1)
          + KSL_MUL(D1->m22, apart_2);
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
  const double log_upper_3a = -log_column_3,
      log_upper_3 = log_column_3 < 0.0 ? log_upper_3a : log_column_3;
  const double log_v_s_size_0 = fabs(log_upper_0), log_v_s_size_1 = fabs(log_upper_1),
      log_v_s_size_2 = fabs(log_upper_2);
  const double log_v_s_largest1 = log_v_s_size_0 < log_v_s_size_1 ? log_v_s_size_1 : log_v_s_size_0;
  const double log_v_s_largest2 = log_v_s_largest1 < log_v_s_size_2 ? log_v_s_size_2
          : log_v_s_largest1;
  const double log_v_s_b = 6.703903964971299e+153 < log_v_s_largest2 ? 3.7291703656001034e-155
          : 1.0, log_v_s_d = log_v_s_largest2 < 256.0 ? 1.3093562431584567e+151 : log_v_s_b,
      log_v_s = log_v_s_largest2 < 1.955159272639747e-149 ? 1.0715086071862673e+301 : log_v_s_d;
  const double log_v_y_0 = KSL_MUL(log_upper_0, log_v_s), log_v_y_1 = KSL_MUL(log_upper_1, log_v_s),
      log_v_y_2 = KSL_MUL(log_upper_2, log_v_s);
  const double log_v_n = sqrt(KSL_MUL(log_v_y_0, log_v_y_0) + KSL_MUL(log_v_y_1, log_v_y_1)
          + KSL_MUL(log_v_y_2, log_v_y_2));
  const double log_v_r_b = log_v_s < 1.0 ? 2.6815615859885194e+154 : 1.0,
      log_v_r_d = 1.0 < log_v_s ? 7.637340908749012e-152 : log_v_r_b,
      log_v_r = 1.3093562431584567e+151 < log_v_s ? 9.332636185032189e-302 : log_v_r_d;
  const double log_n = KSL_MUL(log_v_n, log_v_r);
  const double log_half = ksl_atan2(log_n, log_upper_3);
  const double log_divisor = log_n == 0.0 ? 1.0 : log_n;
  const double log_theta = KSL_MUL(2.0, log_half);
  const double log_k = log_theta / log_divisor;
  const double log_vector_0 = KSL_MUL(log_upper_0, log_k),
      log_vector_1 = KSL_MUL(log_upper_1, log_k), log_vector_2 = KSL_MUL(log_upper_2, log_k);
  const double log_x = KSL_MUL(log_theta, log_theta);
  const double log_far_sine = log_x < 1.0 ? 1.0 : log_n;
  const double log_cotangent = log_upper_3 / log_far_sine;
  const double log_half_cotangent = KSL_MUL(KSL_MUL(0.5, log_theta), log_cotangent);
  const double log_b_rest = 1.0 - log_half_cotangent;
  const double log_b_divisor = log_x < 4.0 ? 4.0 : log_x;
  const double log_closed_b = log_b_rest / log_b_divisor;
  const double log_b_e = KSL_MUL(log_x, KSL_MUL(log_x, KSL_MUL(1.455172475614865e-27, log_x)
          + 5.744790668872202e-26) + 2.267952452337683e-24),
      log_b_k = KSL_MUL(log_x, KSL_MUL(log_x, KSL_MUL(log_x, log_b_e + 8.953517427037546e-23)
          + 3.534707039629467e-21) + 1.3954464685812522e-19),
      log_b_q = KSL_MUL(log_x, KSL_MUL(log_x, KSL_MUL(log_x, log_b_k + 5.5090028283602295e-18)
          + 2.174868698558062e-16) + 8.586062056277845e-15),
      log_b_w = KSL_MUL(log_x, KSL_MUL(log_x, KSL_MUL(log_x, log_b_q + 3.3896802963225827e-13)
          + 1.3382536530684679e-11) + 5.284190138687493e-10),
      log_b_ac = KSL_MUL(log_x, KSL_MUL(log_x, KSL_MUL(log_x, log_b_w + 2.08767569878681e-08)
          + 8.267195767195768e-07) + 3.306878306878307e-05),
      log_b_af = KSL_MUL(log_x, log_b_ac + 0.001388888888888889) + 0.08333333333333333,
      log_b = log_x < 4.0 ? log_b_af : log_closed_b;
  const double log_b_across_b = 1.0 - KSL_MUL(log_x, log_b),
      log_b_across = log_x < 4.0 ? log_b_across_b : log_half_cotangent;
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
  const double screw_0 = KSL_MUL(k, whole_0), screw_1 = KSL_MUL(k, whole_1),
      screw_2 = KSL_MUL(k, whole_2), screw_3 = KSL_MUL(k, log_vector_0),
      screw_4 = KSL_MUL(k, log_vector_1), screw_5 = KSL_MUL(k, log_vector_2);
  const double exp_size_0 = fabs(screw_3), exp_size_1 = fabs(screw_4), exp_size_2 = fabs(screw_5);
  const double exp_sizes = exp_size_0 + exp_size_1 + exp_size_2;
  const double exp_grid = KSL_MUL(exp_sizes, 268435456.0);
  const double exp_shifted_0 = screw_3 + exp_grid, exp_shifted_1 = screw_4 + exp_grid,
      exp_shifted_2 = screw_5 + exp_grid;
  const double exp_high_0 = exp_shifted_0 - exp_grid, exp_high_1 = exp_shifted_1 - exp_grid,
      exp_high_2 = exp_shifted_2 - exp_grid;
  const double exp_low_0 = screw_3 - exp_high_0, exp_low_1 = screw_4 - exp_high_1,
      exp_low_2 = screw_5 - exp_high_2;
  const double exp_sum_0 = screw_3 + exp_high_0, exp_sum_1 = screw_4 + exp_high_1,
      exp_sum_2 = screw_5 + exp_high_2;
  const double exp_squares = KSL_MUL(exp_high_0, exp_high_0) + KSL_MUL(exp_high_1, exp_high_1)
          + KSL_MUL(exp_high_2, exp_high_2);
  const double exp_cross = KSL_MUL(exp_low_0, exp_sum_0) + KSL_MUL(exp_low_1, exp_sum_1)
          + KSL_MUL(exp_low_2, exp_sum_2);
  const double exp_x = exp_squares + exp_cross;
  const double exp_theta_a = sqrt(exp_x), exp_theta = exp_x < 1.0 ? 1.0 : exp_theta_a;
  const double exp_theta_shifted = exp_grid + exp_theta;
  const double exp_theta_high = exp_theta_shifted - exp_grid;
  const double exp_theta_low = exp_theta - exp_theta_high;
  const double exp_theta_sum = exp_theta + exp_theta_high;
  const double exp_cross_rest = exp_cross - KSL_MUL(exp_theta_low, exp_theta_sum);
  const double exp_exact = exp_squares - KSL_MUL(exp_theta_high, exp_theta_high);
  const double exp_residual = exp_cross_rest + exp_exact;
  const double exp_small = KSL_MUL(0.5, exp_residual) / exp_theta;
  const double exp_delta = fabs(exp_small) < 0.0078125 ? exp_small : 0.0;
  double exp_far_cosine_a; const double exp_far_sine_a = ksl_sincos(exp_theta, &exp_far_cosine_a);
  const double exp_far_sine = exp_x < 1.0 ? 1.0 : exp_far_sine_a;
  const double exp_far_cosine = exp_x < 1.0 ? 0.0 : exp_far_cosine_a;
  const double exp_sine = KSL_MUL(exp_delta, exp_far_cosine) + exp_far_sine;
  const double exp_cosine = exp_far_cosine - KSL_MUL(exp_delta, exp_far_sine);
  const double exp_far_x = exp_x < 1.0 ? 1.0 : exp_x;
  const double exp_middle_x = exp_x < 4.0 ? 4.0 : exp_x;
  const double exp_closed1 = exp_sine / exp_theta;
  const double exp_versine = 1.0 - exp_cosine;
  const double exp_closed2 = exp_versine / exp_far_x;
  const double exp_rest3 = 1.0 - exp_closed1;
  const double exp_closed3 = exp_rest3 / exp_middle_x;
  const double exp_g1e = KSL_MUL(exp_x, KSL_MUL(exp_x, KSL_MUL(6.446950284384474e-26, exp_x)
          - 3.868170170630684e-23) + 1.9572941063391263e-20),
      exp_g1k = KSL_MUL(exp_x, KSL_MUL(exp_x, KSL_MUL(exp_x, exp_g1e - 8.22063524662433e-18)
          + 2.8114572543455206e-15) - 7.647163731819816e-13),
      exp_g1q = KSL_MUL(exp_x, KSL_MUL(exp_x, KSL_MUL(exp_x, exp_g1k + 1.6059043836821613e-10)
          - 2.505210838544172e-08) + 2.7557319223985893e-06),
      exp_g1x = KSL_MUL(exp_x, KSL_MUL(exp_x, KSL_MUL(exp_x, exp_g1q - 0.0001984126984126984)
          + 0.008333333333333333) - 0.16666666666666666) + 1.0,
      exp_g1 = exp_x < 1.0 ? exp_g1x : exp_closed1;
  const double exp_g2e = KSL_MUL(exp_x, KSL_MUL(exp_x, KSL_MUL(2.4795962632247976e-27, exp_x)
          - 1.6117375710961184e-24) + 8.896791392450574e-22),
      exp_g2k = KSL_MUL(exp_x, KSL_MUL(exp_x, KSL_MUL(exp_x, exp_g2e - 4.110317623312165e-19)
          + 1.5619206968586225e-16) - 4.779477332387385e-14),
      exp_g2q = KSL_MUL(exp_x, KSL_MUL(exp_x, KSL_MUL(exp_x, exp_g2k + 1.1470745597729725e-11)
          - 2.08767569878681e-09) + 2.755731922398589e-07),
      exp_g2x = KSL_MUL(exp_x, KSL_MUL(exp_x, KSL_MUL(exp_x, exp_g2q - 2.48015873015873e-05)
          + 0.001388888888888889) - 0.041666666666666664) + 0.5,
      exp_g2 = exp_x < 1.0 ? exp_g2x : exp_closed2;
  const double exp_g3e = KSL_MUL(exp_x, KSL_MUL(exp_x, KSL_MUL(9.183689863795546e-29, exp_x)
          - 6.446950284384474e-26) + 3.868170170630684e-23),
      exp_g3k = KSL_MUL(exp_x, KSL_MUL(exp_x, KSL_MUL(exp_x, exp_g3e - 1.9572941063391263e-20)
          + 8.22063524662433e-18) - 2.8114572543455206e-15),
      exp_g3q = KSL_MUL(exp_x, KSL_MUL(exp_x, KSL_MUL(exp_x, exp_g3k + 7.647163731819816e-13)
          - 1.6059043836821613e-10) + 2.505210838544172e-08),
      exp_g3w = KSL_MUL(exp_x, KSL_MUL(exp_x, KSL_MUL(exp_x, exp_g3q - 2.7557319223985893e-06)
          + 0.0001984126984126984) - 0.008333333333333333), exp_g3x = exp_g3w + 0.16666666666666666,
      exp_g3 = exp_x < 4.0 ? exp_g3x : exp_closed3;
  const double exp_g0b = 1.0 - KSL_MUL(exp_x, exp_g2), exp_g0 = exp_x < 1.0 ? exp_g0b : exp_cosine;
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
  const double Do_00 = KSL_MUL(D1->m00, exp_diagonal0)
          + (KSL_MUL(D1->m01, step_4) + KSL_MUL(D1->m02, step_8)),
      Do_01 = KSL_MUL(D1->m00, step_1) + KSL_MUL(D1->m02, step_9) + KSL_MUL(D1->m01, exp_diagonal1),
      Do_02 = KSL_MUL(D1->m00, step_2) + KSL_MUL(D1->m01, step_6) + KSL_MUL(D1->m02, exp_diagonal2),
      Do_03 = KSL_MUL(D1->m00, step_3) + KSL_MUL(D1->m01, step_7) + KSL_MUL(D1->m02, step_11)
          + D1->m03,
      Do_10 = KSL_MUL(D1->m10, exp_diagonal0)
          + (KSL_MUL(D1->m11, step_4) + KSL_MUL(D1->m12, step_8)),
      Do_11 = KSL_MUL(D1->m10, step_1) + KSL_MUL(D1->m12, step_9) + KSL_MUL(D1->m11, exp_diagonal1),
      Do_12 = KSL_MUL(D1->m10, step_2) + KSL_MUL(D1->m11, step_6) + KSL_MUL(D1->m12, exp_diagonal2),
      Do_13 = KSL_MUL(D1->m10, step_3) + KSL_MUL(D1->m11, step_7) + KSL_MUL(D1->m12, step_11)
          + D1->m13,
      Do_20 = KSL_MUL(D1->m20, exp_diagonal0)
          + (KSL_MUL(D1->m21, step_4) + KSL_MUL(D1->m22, step_8)),
      Do_21 = KSL_MUL(D1->m20, step_1) + KSL_MUL(D1->m22, step_9) + KSL_MUL(D1->m21, exp_diagonal1),
      Do_22 = KSL_MUL(D1->m20, step_2) + KSL_MUL(D1->m21, step_6) + KSL_MUL(D1->m22, exp_diagonal2),
      Do_23 = KSL_MUL(D1->m20, step_3) + KSL_MUL(D1->m21, step_7) + KSL_MUL(D1->m22, step_11)
          + D1->m23;
  Do->m00 = Do_00;
  Do->m01 = Do_01;
  Do->m02 = Do_02;
  Do->m03 = Do_03;
  Do->m10 = Do_10;
  Do->m11 = Do_11;
  Do->m12 = Do_12;
  Do->m13 = Do_13;
  Do->m20 = Do_20;
  Do->m21 = Do_21;
  Do->m22 = Do_22;
  Do->m23 = Do_23;
}

/* R = exp v~ = I + sin θ/θ v~ + (1 - cos θ)/θ^2 v~^2, θ = |v|.
   v: vector; R: rotation or other 3×3 matrix.
   71 mul, 96 add, 3 div, 1 sqrt, 5 abs, 5 less, 11 select.
   Error <= R: (6 + θ/200) u of its largest component for |v| <= 1e13, in single precision 1e5;
     searched, not proved. */
static inline void ksl_SO3_expf(const ksl_vec3f_t *v, ksl_mat3x3f_t *R) {
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
  const float beta_v_0 = KSL_MULF(v->x, g2), beta_v_1 = KSL_MULF(v->y, g2),
      beta_v_2 = KSL_MULF(v->z, g2);
  const float m_0 = KSL_MULF(v->x, beta_v_0), m_1 = KSL_MULF(v->y, beta_v_1),
      m_2 = KSL_MULF(v->z, beta_v_2), m_3 = KSL_MULF(v->y, beta_v_0),
      m_4 = KSL_MULF(v->z, beta_v_0), m_5 = KSL_MULF(v->z, beta_v_1);
  const float others_0 = m_1 + m_2, others_1 = m_0 + m_2, others_2 = m_0 + m_1;
  const float diagonal0a = 1.0f - others_0, diagonal0b = g0 + m_0,
      diagonal0 = m_0 < others_0 ? diagonal0b : diagonal0a;
  const float diagonal1a = 1.0f - others_1, diagonal1b = g0 + m_1,
      diagonal1 = m_1 < others_1 ? diagonal1b : diagonal1a;
  const float diagonal2a = 1.0f - others_2, diagonal2b = g0 + m_2,
      diagonal2 = m_2 < others_2 ? diagonal2b : diagonal2a;
  const float alpha_v_0 = KSL_MULF(v->x, g1), alpha_v_1 = KSL_MULF(v->y, g1),
      alpha_v_2 = KSL_MULF(v->z, g1);
  const float R_01 = m_3 - alpha_v_2, R_02 = m_4 + alpha_v_1, R_10 = m_3 + alpha_v_2,
      R_12 = m_5 - alpha_v_0, R_20 = m_4 - alpha_v_1, R_21 = m_5 + alpha_v_0;
  R->m00 = diagonal0;
  R->m01 = R_01;
  R->m02 = R_02;
  R->m10 = R_10;
  R->m11 = diagonal1;
  R->m12 = R_12;
  R->m20 = R_20;
  R->m21 = R_21;
  R->m22 = diagonal2;
}

/* vo with exp vo~ = R, |vo| <= π; if R is not quite a rotation, its defect carries over to vo.
   R: rotation or other 3×3 matrix; vo: vector.
   33 mul, 45 add, 2 div, 1 sqrt, 6 neg, 5 abs, 2 copysign, 18 less, 2 equal, 39 select.
   Error <= vo: 7 u of its largest component for R a rotation; searched, not proved. */
static inline void ksl_SO3_logf(const ksl_mat3x3f_t *R, ksl_vec3f_t *vo) {
  const float p_0 = R->m21 - R->m12, p_1 = R->m02 - R->m20, p_2 = R->m10 - R->m01;
  const float s_0 = R->m12 + R->m21, s_1 = R->m02 + R->m20, s_2 = R->m01 + R->m10;
  const float first_0 = R->m00 + 1.0f, first_1 = 1.0f - R->m00;
  const float others_0 = R->m11 + R->m22, others_1 = R->m11 - R->m22;
  const float d_0 = first_0 + others_0, d_1 = first_0 - others_0, d_2 = first_1 + others_1,
      d_3 = first_1 - others_1;
  const float low_0 = R->m11 < R->m00 ? d_1 : s_2, low_1 = R->m11 < R->m00 ? s_2 : d_2,
      low_2 = R->m11 < R->m00 ? s_1 : s_0, low_3 = R->m11 < R->m00 ? p_0 : p_1;
  const float high_0a = -R->m11, high_0 = R->m00 < high_0a ? s_1 : p_0;
  const float high_1 = R->m00 < high_0a ? s_0 : p_1, high_2 = R->m00 < high_0a ? d_3 : p_2,
      high_3 = R->m00 < high_0a ? p_2 : d_0;
  const float column_0 = R->m22 < 0.0f ? low_0 : high_0, column_1 = R->m22 < 0.0f ? low_1 : high_1,
      column_2 = R->m22 < 0.0f ? low_2 : high_2, column_3 = R->m22 < 0.0f ? low_3 : high_3;
  const float upper_0a = -column_0, upper_0 = column_3 < 0.0f ? upper_0a : column_0;
  const float upper_1a = -column_1, upper_1 = column_3 < 0.0f ? upper_1a : column_1;
  const float upper_2a = -column_2, upper_2 = column_3 < 0.0f ? upper_2a : column_2;
  const float upper_3a = -column_3, upper_3 = column_3 < 0.0f ? upper_3a : column_3;
  const float v_s_size_0 = fabsf(upper_0), v_s_size_1 = fabsf(upper_1), v_s_size_2 = fabsf(upper_2);
  const float v_s_largest1 = v_s_size_0 < v_s_size_1 ? v_s_size_1 : v_s_size_0;
  const float v_s_largest2 = v_s_largest1 < v_s_size_2 ? v_s_size_2 : v_s_largest1;
  const float v_s_b = 4.611686e+18f < v_s_largest2 ? 2.7105054e-20f : 1.0f,
      v_s_d = v_s_largest2 < 256.0f ? 1.8014399e+16f : v_s_b,
      v_s = v_s_largest2 < 1.4210855e-14f ? 3.2451855e+32f : v_s_d;
  const float v_y_0 = KSL_MULF(upper_0, v_s), v_y_1 = KSL_MULF(upper_1, v_s),
      v_y_2 = KSL_MULF(upper_2, v_s);
  const float v_n = sqrtf(KSL_MULF(v_y_0, v_y_0) + KSL_MULF(v_y_1, v_y_1) + KSL_MULF(v_y_2, v_y_2));
  const float v_r_b = v_s < 1.0f ? 3.689349e+19f : 1.0f, v_r_d = 1.0f < v_s ? 5.551115e-17f : v_r_b,
      v_r = 1.8014399e+16f < v_s ? 3.081488e-33f : v_r_d;
  const float n = KSL_MULF(v_n, v_r);
  const float half = ksl_atan2f(n, upper_3);
  const float divisor = n == 0.0f ? 1.0f : n;
  const float theta = KSL_MULF(2.0f, half);
  const float k = theta / divisor;
  const float vector_0 = KSL_MULF(upper_0, k), vector_1 = KSL_MULF(upper_1, k),
      vector_2 = KSL_MULF(upper_2, k);
  vo->x = vector_0;
  vo->y = vector_1;
  vo->z = vector_2;
}

/* R = J_l(v) = I + (1 - cos θ)/θ^2 v~ + (θ - sin θ)/θ^3 v~^2, θ = |v|.
   v: vector; R: rotation or other 3×3 matrix.
   82 mul, 108 add, 4 div, 1 sqrt, 5 abs, 6 less, 12 select.
   Error <= R: (7 + θ/200) u of its largest component for |v| <= 1e13, in single precision 1e5;
     searched, not proved. */
static inline void ksl_SO3_leftJacobianf(const ksl_vec3f_t *v, ksl_mat3x3f_t *R) {
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
  const float beta_v_0 = KSL_MULF(v->x, g3), beta_v_1 = KSL_MULF(v->y, g3),
      beta_v_2 = KSL_MULF(v->z, g3);
  const float m_0 = KSL_MULF(v->x, beta_v_0), m_1 = KSL_MULF(v->y, beta_v_1),
      m_2 = KSL_MULF(v->z, beta_v_2), m_3 = KSL_MULF(v->y, beta_v_0),
      m_4 = KSL_MULF(v->z, beta_v_0), m_5 = KSL_MULF(v->z, beta_v_1);
  const float others_0 = m_1 + m_2, others_1 = m_0 + m_2, others_2 = m_0 + m_1;
  const float diagonal0a = 1.0f - others_0, diagonal0b = g1 + m_0,
      diagonal0 = m_0 < others_0 ? diagonal0b : diagonal0a;
  const float diagonal1a = 1.0f - others_1, diagonal1b = g1 + m_1,
      diagonal1 = m_1 < others_1 ? diagonal1b : diagonal1a;
  const float diagonal2a = 1.0f - others_2, diagonal2b = g1 + m_2,
      diagonal2 = m_2 < others_2 ? diagonal2b : diagonal2a;
  const float alpha_v_0 = KSL_MULF(v->x, g2), alpha_v_1 = KSL_MULF(v->y, g2),
      alpha_v_2 = KSL_MULF(v->z, g2);
  const float R_01 = m_3 - alpha_v_2, R_02 = m_4 + alpha_v_1, R_10 = m_3 + alpha_v_2,
      R_12 = m_5 - alpha_v_0, R_20 = m_4 - alpha_v_1, R_21 = m_5 + alpha_v_0;
  R->m00 = diagonal0;
  R->m01 = R_01;
  R->m02 = R_02;
  R->m10 = R_10;
  R->m11 = diagonal1;
  R->m12 = R_12;
  R->m20 = R_20;
  R->m21 = R_21;
  R->m22 = diagonal2;
}

/* R = J_r(v) = I - (1 - cos θ)/θ^2 v~ + (θ - sin θ)/θ^3 v~^2, θ = |v|.
   v: vector; R: rotation or other 3×3 matrix.
   82 mul, 108 add, 4 div, 1 sqrt, 3 neg, 5 abs, 6 less, 12 select.
   Error <= R: (7 + θ/200) u of its largest component for |v| <= 1e13, in single precision 1e5;
     searched, not proved. */
static inline void ksl_SO3_rightJacobianf(const ksl_vec3f_t *v, ksl_mat3x3f_t *R) {
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
  const float beta_v_0 = KSL_MULF(v->x, g3), beta_v_1 = KSL_MULF(v->y, g3),
      beta_v_2 = KSL_MULF(v->z, g3);
  const float m_0 = KSL_MULF(v->x, beta_v_0), m_1 = KSL_MULF(v->y, beta_v_1),
      m_2 = KSL_MULF(v->z, beta_v_2), m_3 = KSL_MULF(v->y, beta_v_0),
      m_4 = KSL_MULF(v->z, beta_v_0), m_5 = KSL_MULF(v->z, beta_v_1);
  const float others_0 = m_1 + m_2, others_1 = m_0 + m_2, others_2 = m_0 + m_1;
  const float diagonal0a = 1.0f - others_0, diagonal0b = g1 + m_0,
      diagonal0 = m_0 < others_0 ? diagonal0b : diagonal0a;
  const float diagonal1a = 1.0f - others_1, diagonal1b = g1 + m_1,
      diagonal1 = m_1 < others_1 ? diagonal1b : diagonal1a;
  const float diagonal2a = 1.0f - others_2, diagonal2b = g1 + m_2,
      diagonal2 = m_2 < others_2 ? diagonal2b : diagonal2a;
  const float alpha_v_0 = -KSL_MULF(v->x, g2), alpha_v_1 = -KSL_MULF(v->y, g2),
      alpha_v_2 = -KSL_MULF(v->z, g2);
  const float R_01 = m_3 - alpha_v_2, R_02 = m_4 + alpha_v_1, R_10 = m_3 + alpha_v_2,
      R_12 = m_5 - alpha_v_0, R_20 = m_4 - alpha_v_1, R_21 = m_5 + alpha_v_0;
  R->m00 = diagonal0;
  R->m01 = R_01;
  R->m02 = R_02;
  R->m10 = R_10;
  R->m11 = diagonal1;
  R->m12 = R_12;
  R->m20 = R_20;
  R->m21 = R_21;
  R->m22 = diagonal2;
}

/* R = J_l(v)^-1 = I - v~/2 + (1 - θ/2 cot θ/2)/θ^2 v~^2, θ = |v|; singular at multiples of 2π
     except 0.
   v: vector; R: rotation or other 3×3 matrix.
   65 mul, 90 add, 3 div, 1 sqrt, 3 neg, 5 abs, 7 less, 12 select.
   Error <= R: 6 u of its largest component for |v| <= π; searched, not proved. */
static inline void ksl_SO3_leftJacobianInversef(const ksl_vec3f_t *v, ksl_mat3x3f_t *R) {
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
  const float beta_v_0 = KSL_MULF(v->x, b), beta_v_1 = KSL_MULF(v->y, b),
      beta_v_2 = KSL_MULF(v->z, b);
  const float m_0 = KSL_MULF(v->x, beta_v_0), m_1 = KSL_MULF(v->y, beta_v_1),
      m_2 = KSL_MULF(v->z, beta_v_2), m_3 = KSL_MULF(v->y, beta_v_0),
      m_4 = KSL_MULF(v->z, beta_v_0), m_5 = KSL_MULF(v->z, beta_v_1);
  const float others_0 = m_1 + m_2, others_1 = m_0 + m_2, others_2 = m_0 + m_1;
  const float diagonal0a = 1.0f - others_0, diagonal0b = b_across + m_0,
      diagonal0 = m_0 < others_0 ? diagonal0b : diagonal0a;
  const float diagonal1a = 1.0f - others_1, diagonal1b = b_across + m_1,
      diagonal1 = m_1 < others_1 ? diagonal1b : diagonal1a;
  const float diagonal2a = 1.0f - others_2, diagonal2b = b_across + m_2,
      diagonal2 = m_2 < others_2 ? diagonal2b : diagonal2a;
  const float alpha_v_0 = -KSL_MULF(0.5f, v->x), alpha_v_1 = -KSL_MULF(0.5f, v->y),
      alpha_v_2 = -KSL_MULF(0.5f, v->z);
  const float R_01 = m_3 - alpha_v_2, R_02 = m_4 + alpha_v_1, R_10 = m_3 + alpha_v_2,
      R_12 = m_5 - alpha_v_0, R_20 = m_4 - alpha_v_1, R_21 = m_5 + alpha_v_0;
  R->m00 = diagonal0;
  R->m01 = R_01;
  R->m02 = R_02;
  R->m10 = R_10;
  R->m11 = diagonal1;
  R->m12 = R_12;
  R->m20 = R_20;
  R->m21 = R_21;
  R->m22 = diagonal2;
}

/* R = J_r(v)^-1 = I + v~/2 + (1 - θ/2 cot θ/2)/θ^2 v~^2, θ = |v|; singular at multiples of 2π
     except 0.
   v: vector; R: rotation or other 3×3 matrix.
   65 mul, 90 add, 3 div, 1 sqrt, 5 abs, 7 less, 12 select.
   Error <= R: 6 u of its largest component for |v| <= π; searched, not proved. */
static inline void ksl_SO3_rightJacobianInversef(const ksl_vec3f_t *v, ksl_mat3x3f_t *R) {
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
  const float beta_v_0 = KSL_MULF(v->x, b), beta_v_1 = KSL_MULF(v->y, b),
      beta_v_2 = KSL_MULF(v->z, b);
  const float m_0 = KSL_MULF(v->x, beta_v_0), m_1 = KSL_MULF(v->y, beta_v_1),
      m_2 = KSL_MULF(v->z, beta_v_2), m_3 = KSL_MULF(v->y, beta_v_0),
      m_4 = KSL_MULF(v->z, beta_v_0), m_5 = KSL_MULF(v->z, beta_v_1);
  const float others_0 = m_1 + m_2, others_1 = m_0 + m_2, others_2 = m_0 + m_1;
  const float diagonal0a = 1.0f - others_0, diagonal0b = b_across + m_0,
      diagonal0 = m_0 < others_0 ? diagonal0b : diagonal0a;
  const float diagonal1a = 1.0f - others_1, diagonal1b = b_across + m_1,
      diagonal1 = m_1 < others_1 ? diagonal1b : diagonal1a;
  const float diagonal2a = 1.0f - others_2, diagonal2b = b_across + m_2,
      diagonal2 = m_2 < others_2 ? diagonal2b : diagonal2a;
  const float alpha_v_0 = KSL_MULF(0.5f, v->x), alpha_v_1 = KSL_MULF(0.5f, v->y),
      alpha_v_2 = KSL_MULF(0.5f, v->z);
  const float R_01 = m_3 - alpha_v_2, R_02 = m_4 + alpha_v_1, R_10 = m_3 + alpha_v_2,
      R_12 = m_5 - alpha_v_0, R_20 = m_4 - alpha_v_1, R_21 = m_5 + alpha_v_0;
  R->m00 = diagonal0;
  R->m01 = R_01;
  R->m02 = R_02;
  R->m10 = R_10;
  R->m11 = diagonal1;
  R->m12 = R_12;
  R->m20 = R_20;
  R->m21 = R_21;
  R->m22 = diagonal2;
}

/* self = R + R (I - R^T R)/2, closer to a rotation: a defect d of R becomes 3/4 d^2.
   self: rotation or other 3×3 matrix.
   51 mul, 42 add, 3 neg.
   Error <= u |result| + 7 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_mat3x3f_orthonormalize(ksl_mat3x3f_t *self) {
  const float defect_0 = 1.0f - KSL_MULF(self->m00, self->m00) - KSL_MULF(self->m10, self->m10)
          - KSL_MULF(self->m20, self->m20),
      defect_1 = 1.0f - KSL_MULF(self->m01, self->m01) - KSL_MULF(self->m11, self->m11)
          - KSL_MULF(self->m21, self->m21),
      defect_2 = 1.0f - KSL_MULF(self->m02, self->m02) - KSL_MULF(self->m12, self->m12)
          - KSL_MULF(self->m22, self->m22),
      defect_3 =
          -(KSL_MULF(self->m00, self->m01) + KSL_MULF(self->m10, self->m11)
          + KSL_MULF(self->m20, self->m21)),
      defect_4 =
          -(KSL_MULF(self->m00, self->m02) + KSL_MULF(self->m10, self->m12)
          + KSL_MULF(self->m20, self->m22)),
      defect_5 =
          -(KSL_MULF(self->m01, self->m02) + KSL_MULF(self->m11, self->m12)
          + KSL_MULF(self->m21, self->m22));
  const float correction_0 = KSL_MULF(0.5f, defect_0), correction_1 = KSL_MULF(0.5f, defect_1),
      correction_2 = KSL_MULF(0.5f, defect_2), correction_3 = KSL_MULF(0.5f, defect_3),
      correction_4 = KSL_MULF(0.5f, defect_4), correction_5 = KSL_MULF(0.5f, defect_5);
  const float self_00_new = self->m00
          + (KSL_MULF(self->m00, correction_0) + KSL_MULF(self->m01, correction_3)
          + KSL_MULF(self->m02, correction_4)),
      self_01_new = KSL_MULF(self->m00, correction_3) + KSL_MULF(self->m01, correction_1)
          + KSL_MULF(self->m02, correction_5) + self->m01,
      self_02_new = KSL_MULF(self->m00, correction_4) + KSL_MULF(self->m01, correction_5)
          + KSL_MULF(self->m02, correction_2) + self->m02,
      self_10_new = self->m10
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
  self->m00 = self_00_new;
  self->m01 = self_01_new;
  self->m02 = self_02_new;
  self->m10 = self_10_new;
  self->m11 = self_11_new;
  self->m12 = self_12_new;
  self->m20 = self_20_new;
  self->m21 = self_21_new;
  self->m22 = self_22_new;
}

/* Ro = R + R (I - R^T R)/2, closer to a rotation: a defect d of R becomes 3/4 d^2.
   R, Ro: rotation or other 3×3 matrix.
   51 mul, 42 add, 3 neg.
   Error <= u |result| + 7 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_mat3x3f_orthonormalized(const ksl_mat3x3f_t *R, ksl_mat3x3f_t *Ro) {
  const float defect_0 = 1.0f - KSL_MULF(R->m00, R->m00) - KSL_MULF(R->m10, R->m10)
          - KSL_MULF(R->m20, R->m20),
      defect_1 = 1.0f - KSL_MULF(R->m01, R->m01) - KSL_MULF(R->m11, R->m11)
          - KSL_MULF(R->m21, R->m21),
      defect_2 = 1.0f - KSL_MULF(R->m02, R->m02) - KSL_MULF(R->m12, R->m12)
          - KSL_MULF(R->m22, R->m22),
      defect_3 = -(KSL_MULF(R->m00, R->m01) + KSL_MULF(R->m10, R->m11) + KSL_MULF(R->m20, R->m21)),
      defect_4 = -(KSL_MULF(R->m00, R->m02) + KSL_MULF(R->m10, R->m12) + KSL_MULF(R->m20, R->m22)),
      defect_5 = -(KSL_MULF(R->m01, R->m02) + KSL_MULF(R->m11, R->m12) + KSL_MULF(R->m21, R->m22));
  const float correction_0 = KSL_MULF(0.5f, defect_0), correction_1 = KSL_MULF(0.5f, defect_1),
      correction_2 = KSL_MULF(0.5f, defect_2), correction_3 = KSL_MULF(0.5f, defect_3),
      correction_4 = KSL_MULF(0.5f, defect_4), correction_5 = KSL_MULF(0.5f, defect_5);
  const float Ro_00 = R->m00
          + (KSL_MULF(R->m00, correction_0) + KSL_MULF(R->m01, correction_3)
          + KSL_MULF(R->m02, correction_4)),
      Ro_01 = KSL_MULF(R->m00, correction_3) + KSL_MULF(R->m01, correction_1)
          + KSL_MULF(R->m02, correction_5) + R->m01,
      Ro_02 = KSL_MULF(R->m00, correction_4) + KSL_MULF(R->m01, correction_5)
          + KSL_MULF(R->m02, correction_2) + R->m02,
      Ro_10 = R->m10
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

/* D = exp s = [exp ω~ | J_l(ω) v].
   s: screw (v in m/s; ω in rad/s); D: displacement [R | t], R rotation, t in m.
   102 mul, 120 add, 4 div, 1 sqrt, 5 abs, 6 less, 13 select.
   Error <= R: (6 + θ/200) u, t: (14 + θ/200) u of its largest component, or of s.lin if that is
     larger, for |ω of s| <= 1e13, in single precision 1e5; searched, not proved.  Intermediate
     sums may overflow where |v|, or |ω| |v|, is above 2e306, in single precision 5e36. */
static inline void ksl_SE3f_exp(const ksl_screwf_t *s, ksl_SE3f_t *D) {
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
  const float u_0 = KSL_MULF(s->m2, s->m4) - KSL_MULF(s->m1, s->m5),
      u_1 = KSL_MULF(s->m0, s->m5) - KSL_MULF(s->m2, s->m3),
      u_2 = KSL_MULF(s->m1, s->m3) - KSL_MULF(s->m0, s->m4);
  const float turned_0 = KSL_MULF(g2, u_0), turned_1 = KSL_MULF(g2, u_1),
      turned_2 = KSL_MULF(g2, u_2);
  const float wv = KSL_MULF(s->m0, s->m3) + KSL_MULF(s->m1, s->m4) + KSL_MULF(s->m2, s->m5);
  const float pitch = KSL_MULF(g3, wv);
  const float along_0 = KSL_MULF(s->m3, pitch), along_1 = KSL_MULF(s->m4, pitch),
      along_2 = KSL_MULF(s->m5, pitch);
  const float beta_v_0 = KSL_MULF(s->m3, g2), beta_v_1 = KSL_MULF(s->m4, g2),
      beta_v_2 = KSL_MULF(s->m5, g2);
  const float m_0 = KSL_MULF(s->m3, beta_v_0), m_1 = KSL_MULF(s->m4, beta_v_1),
      m_2 = KSL_MULF(s->m5, beta_v_2), m_3 = KSL_MULF(s->m4, beta_v_0),
      m_4 = KSL_MULF(s->m5, beta_v_0), m_5 = KSL_MULF(s->m5, beta_v_1);
  const float others_0 = m_1 + m_2, others_1 = m_0 + m_2, others_2 = m_0 + m_1;
  const float diagonal0a = 1.0f - others_0, diagonal0b = g0 + m_0,
      diagonal0 = m_0 < others_0 ? diagonal0b : diagonal0a;
  const float diagonal1a = 1.0f - others_1, diagonal1b = g0 + m_1,
      diagonal1 = m_1 < others_1 ? diagonal1b : diagonal1a;
  const float diagonal2a = 1.0f - others_2, diagonal2b = g0 + m_2,
      diagonal2 = m_2 < others_2 ? diagonal2b : diagonal2a;
  const float alpha_v_0 = KSL_MULF(s->m3, g1), alpha_v_1 = KSL_MULF(s->m4, g1),
      alpha_v_2 = KSL_MULF(s->m5, g1);
  const float across_axis_0 = turned_0 + along_0, across_axis_1 = turned_1 + along_1,
      across_axis_2 = turned_2 + along_2;
  const float D_01 = m_3 - alpha_v_2, D_02 = m_4 + alpha_v_1,
      D_03 = KSL_MULF(s->m0, g1) + across_axis_0, D_10 = m_3 + alpha_v_2, D_12 = m_5 - alpha_v_0,
      D_13 = KSL_MULF(s->m1, g1) + across_axis_1, D_20 = m_4 - alpha_v_1, D_21 = m_5 + alpha_v_0,
      D_23 = KSL_MULF(s->m2, g1) + across_axis_2;
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
}

/* so with exp so = D, |ω| <= π: (J_l(ω)^-1 t; ω), ω = log R.
   D: displacement [R | t], R rotation, t in m; so: screw (v in m/s; ω in rad/s).
   72 mul, 74 add, 4 div, 1 sqrt, 6 neg, 5 abs, 2 copysign, 20 less, 2 equal, 43 select.
   Error <= lin: 18 u, ang: 8 u of its largest component for R of D a rotation; searched, not
     proved.  Intermediate sums may overflow where |t| is above 2e306, in single precision 5e36. */
static inline void ksl_SE3f_log(const ksl_SE3f_t *D, ksl_screwf_t *so) {
  const float p_0 = D->m21 - D->m12, p_1 = D->m02 - D->m20, p_2 = D->m10 - D->m01;
  const float s_0 = D->m12 + D->m21, s_1 = D->m02 + D->m20, s_2 = D->m01 + D->m10;
  const float first_0 = D->m00 + 1.0f, first_1 = 1.0f - D->m00;
  const float others_0 = D->m11 + D->m22, others_1 = D->m11 - D->m22;
  const float d_0 = first_0 + others_0, d_1 = first_0 - others_0, d_2 = first_1 + others_1,
      d_3 = first_1 - others_1;
  const float low_0 = D->m11 < D->m00 ? d_1 : s_2, low_1 = D->m11 < D->m00 ? s_2 : d_2,
      low_2 = D->m11 < D->m00 ? s_1 : s_0, low_3 = D->m11 < D->m00 ? p_0 : p_1;
  const float high_0a = -D->m11, high_0 = D->m00 < high_0a ? s_1 : p_0;
  const float high_1 = D->m00 < high_0a ? s_0 : p_1, high_2 = D->m00 < high_0a ? d_3 : p_2,
      high_3 = D->m00 < high_0a ? p_2 : d_0;
  const float column_0 = D->m22 < 0.0f ? low_0 : high_0, column_1 = D->m22 < 0.0f ? low_1 : high_1,
      column_2 = D->m22 < 0.0f ? low_2 : high_2, column_3 = D->m22 < 0.0f ? low_3 : high_3;
  const float upper_0a = -column_0, upper_0 = column_3 < 0.0f ? upper_0a : column_0;
  const float upper_1a = -column_1, upper_1 = column_3 < 0.0f ? upper_1a : column_1;
  const float upper_2a = -column_2, upper_2 = column_3 < 0.0f ? upper_2a : column_2;
  const float upper_3a = -column_3, upper_3 = column_3 < 0.0f ? upper_3a : column_3;
  const float v_s_size_0 = fabsf(upper_0), v_s_size_1 = fabsf(upper_1), v_s_size_2 = fabsf(upper_2);
  const float v_s_largest1 = v_s_size_0 < v_s_size_1 ? v_s_size_1 : v_s_size_0;
  const float v_s_largest2 = v_s_largest1 < v_s_size_2 ? v_s_size_2 : v_s_largest1;
  const float v_s_b = 4.611686e+18f < v_s_largest2 ? 2.7105054e-20f : 1.0f,
      v_s_d = v_s_largest2 < 256.0f ? 1.8014399e+16f : v_s_b,
      v_s = v_s_largest2 < 1.4210855e-14f ? 3.2451855e+32f : v_s_d;
  const float v_y_0 = KSL_MULF(upper_0, v_s), v_y_1 = KSL_MULF(upper_1, v_s),
      v_y_2 = KSL_MULF(upper_2, v_s);
  const float v_n = sqrtf(KSL_MULF(v_y_0, v_y_0) + KSL_MULF(v_y_1, v_y_1) + KSL_MULF(v_y_2, v_y_2));
  const float v_r_b = v_s < 1.0f ? 3.689349e+19f : 1.0f, v_r_d = 1.0f < v_s ? 5.551115e-17f : v_r_b,
      v_r = 1.8014399e+16f < v_s ? 3.081488e-33f : v_r_d;
  const float n = KSL_MULF(v_n, v_r);
  const float half = ksl_atan2f(n, upper_3);
  const float divisor = n == 0.0f ? 1.0f : n;
  const float theta = KSL_MULF(2.0f, half);
  const float k = theta / divisor;
  const float vector_0 = KSL_MULF(upper_0, k), vector_1 = KSL_MULF(upper_1, k),
      vector_2 = KSL_MULF(upper_2, k);
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
  const float along_0 = KSL_MULF(vector_0, pitch), along_1 = KSL_MULF(vector_1, pitch),
      along_2 = KSL_MULF(vector_2, pitch);
  const float u_0 = KSL_MULF(D->m23, vector_1) - KSL_MULF(D->m13, vector_2),
      u_1 = KSL_MULF(D->m03, vector_2) - KSL_MULF(D->m23, vector_0),
      u_2 = KSL_MULF(D->m13, vector_0) - KSL_MULF(D->m03, vector_1);
  const float turned_0 = KSL_MULF(0.5f, u_0), turned_1 = KSL_MULF(0.5f, u_1),
      turned_2 = KSL_MULF(0.5f, u_2);
  const float across_axis_0 = along_0 - turned_0, across_axis_1 = along_1 - turned_1,
      across_axis_2 = along_2 - turned_2;
  const float so_0 = KSL_MULF(D->m03, b_across) + across_axis_0,
      so_1 = KSL_MULF(D->m13, b_across) + across_axis_1,
      so_2 = KSL_MULF(D->m23, b_across) + across_axis_2;
  so->m0 = so_0;
  so->m1 = so_1;
  so->m2 = so_2;
  so->m3 = vector_0;
  so->m4 = vector_1;
  so->m5 = vector_2;
}

/* M = J_l(s) = Σ ([ad](s))^k / (k+1)!.
   s: screw (v in m/s; ω in rad/s); M: 6×6 operator.
   143 mul, 160 add, 6 div, 1 sqrt, 1 neg, 5 abs, 7 less, 15 select.
   Error <= M: 20 u of its largest component for |ω of s| <= π; searched, not proved.
     Intermediate sums may overflow where |v| is above 2e306, in single precision 5e36. */
static inline void ksl_SE3f_leftJacobian(const ksl_screwf_t *s, ksl_mat6x6f_t *M) {
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
  const float late_x = x < 9.0f ? 1.0f : x;
  const float rate2_rest = g1 - KSL_MULF(2.0f, g2);
  const float closed_rate2 = rate2_rest / late_x;
  const float rate3_rest = g2 - KSL_MULF(3.0f, g3);
  const float closed_rate3 = rate3_rest / late_x;
  const float rate2h = KSL_MULF(x, KSL_MULF(x, KSL_MULF(x, 5.951031e-26f
          - KSL_MULF(8.527712e-29f, x)) - 3.5458228e-23f) + 1.7793582e-20f) - 7.398571e-18f,
      rate2q = KSL_MULF(x, KSL_MULF(x, KSL_MULF(x, KSL_MULF(x, KSL_MULF(x, rate2h) + 2.499073e-15f)
          - 6.691268e-13f) + 1.3764895e-10f) - 2.0876756e-08f),
      rate2x = KSL_MULF(x, KSL_MULF(x, KSL_MULF(x, rate2q + 2.2045856e-06f) - 0.00014880953f)
          + 0.0055555557f) - 0.083333336f, rate2 = x < 9.0f ? rate2x : closed_rate2;
  const float rate3h = KSL_MULF(x, KSL_MULF(x, KSL_MULF(x, 2.2040857e-27f
          - KSL_MULF(2.9405903e-30f, x)) - 1.418329e-24f) + 7.7363405e-22f) - 3.5231295e-19f,
      rate3q = KSL_MULF(x, KSL_MULF(x, KSL_MULF(x, KSL_MULF(x, KSL_MULF(x, rate3h)
          + 1.3153016e-16f) - 3.93604e-14f) + 9.176596e-12f) - 1.6059044e-09f),
      rate3x = KSL_MULF(x, KSL_MULF(x, KSL_MULF(x, rate3q + 2.0041686e-07f) - 1.6534392e-05f)
          + 0.0007936508f) - 0.016666668f, rate3 = x < 9.0f ? rate3x : closed_rate3;
  const float beta_v_0 = KSL_MULF(s->m3, g3), beta_v_1 = KSL_MULF(s->m4, g3),
      beta_v_2 = KSL_MULF(s->m5, g3);
  const float m_0 = KSL_MULF(s->m3, beta_v_0), m_1 = KSL_MULF(s->m4, beta_v_1),
      m_2 = KSL_MULF(s->m5, beta_v_2), m_3 = KSL_MULF(s->m4, beta_v_0),
      m_4 = KSL_MULF(s->m5, beta_v_0), m_5 = KSL_MULF(s->m5, beta_v_1);
  const float others_0 = m_1 + m_2, others_1 = m_0 + m_2, others_2 = m_0 + m_1;
  const float diagonal0a = 1.0f - others_0, diagonal0b = g1 + m_0,
      diagonal0 = m_0 < others_0 ? diagonal0b : diagonal0a;
  const float diagonal1a = 1.0f - others_1, diagonal1b = g1 + m_1,
      diagonal1 = m_1 < others_1 ? diagonal1b : diagonal1a;
  const float diagonal2a = 1.0f - others_2, diagonal2b = g1 + m_2,
      diagonal2 = m_2 < others_2 ? diagonal2b : diagonal2a;
  const float alpha_v_0 = KSL_MULF(s->m3, g2), alpha_v_1 = KSL_MULF(s->m4, g2),
      alpha_v_2 = KSL_MULF(s->m5, g2);
  const float J_1 = m_3 - alpha_v_2, J_2 = m_4 + alpha_v_1, J_3 = m_3 + alpha_v_2,
      J_5 = m_5 - alpha_v_0, J_6 = m_4 - alpha_v_1, J_7 = m_5 + alpha_v_0;
  const float rate_vw = KSL_MULF(s->m0, s->m3) + KSL_MULF(s->m1, s->m4) + KSL_MULF(s->m2, s->m5);
  const float rate_turn = KSL_MULF(rate2, rate_vw);
  const float rate_bend = -KSL_MULF(rate3, rate_vw);
  const float rate_q_0 = KSL_MULF(s->m0, g2) + KSL_MULF(s->m3, rate_turn),
      rate_q_1 = KSL_MULF(s->m1, g2) + KSL_MULF(s->m4, rate_turn),
      rate_q_2 = KSL_MULF(s->m2, g2) + KSL_MULF(s->m5, rate_turn);
  const float rate_beta_v_0 = KSL_MULF(s->m0, g3), rate_beta_v_1 = KSL_MULF(s->m1, g3),
      rate_beta_v_2 = KSL_MULF(s->m2, g3);
  const float rate_bend_w_0 = KSL_MULF(s->m3, rate_bend),
      rate_bend_w_1 = KSL_MULF(s->m4, rate_bend), rate_bend_w_2 = KSL_MULF(s->m5, rate_bend);
  const float rate_symmetric_0 = KSL_MULF(s->m3, rate_beta_v_1) + KSL_MULF(s->m4, rate_beta_v_0)
          - KSL_MULF(s->m4, rate_bend_w_0),
      rate_symmetric_1 = KSL_MULF(s->m3, rate_beta_v_2) + KSL_MULF(s->m5, rate_beta_v_0)
          - KSL_MULF(s->m5, rate_bend_w_0),
      rate_symmetric_2 = KSL_MULF(s->m4, rate_beta_v_2) + KSL_MULF(s->m5, rate_beta_v_1)
          - KSL_MULF(s->m5, rate_bend_w_1);
  const float rate_diagonal_0a = KSL_MULF(s->m4, rate_bend_w_1),
      rate_diagonal_0b = KSL_MULF(s->m5, rate_bend_w_2),
      rate_diagonal_0e = KSL_MULF(KSL_MULF(2.0f, s->m4), rate_beta_v_1),
      rate_diagonal_0g = KSL_MULF(KSL_MULF(2.0f, s->m5), rate_beta_v_2),
      rate_diagonal_0 = rate_diagonal_0a + rate_diagonal_0b - (rate_diagonal_0e + rate_diagonal_0g);
  const float rate_diagonal_1a = KSL_MULF(s->m3, rate_bend_w_0),
      rate_diagonal_1d = KSL_MULF(KSL_MULF(2.0f, s->m3), rate_beta_v_0),
      rate_diagonal_1 = rate_diagonal_1a + rate_diagonal_0b - (rate_diagonal_1d + rate_diagonal_0g);
  const float rate_diagonal_2 = rate_diagonal_1a + rate_diagonal_0a
          - (rate_diagonal_1d + rate_diagonal_0e);
  const float M_04 = rate_symmetric_0 - rate_q_2, M_05 = rate_q_1 + rate_symmetric_1,
      M_13 = rate_q_2 + rate_symmetric_0, M_15 = rate_symmetric_2 - rate_q_0,
      M_23 = rate_symmetric_1 - rate_q_1, M_24 = rate_q_0 + rate_symmetric_2;
  M->at[0][0] = diagonal0;
  M->at[1][0] = J_1;
  M->at[2][0] = J_2;
  M->at[3][0] = rate_diagonal_0;
  M->at[4][0] = M_04;
  M->at[5][0] = M_05;
  M->at[0][1] = J_3;
  M->at[1][1] = diagonal1;
  M->at[2][1] = J_5;
  M->at[3][1] = M_13;
  M->at[4][1] = rate_diagonal_1;
  M->at[5][1] = M_15;
  M->at[0][2] = J_6;
  M->at[1][2] = J_7;
  M->at[2][2] = diagonal2;
  M->at[3][2] = M_23;
  M->at[4][2] = M_24;
  M->at[5][2] = rate_diagonal_2;
  M->at[0][3] = 0.0f;
  M->at[1][3] = 0.0f;
  M->at[2][3] = 0.0f;
  M->at[3][3] = diagonal0;
  M->at[4][3] = J_1;
  M->at[5][3] = J_2;
  M->at[0][4] = 0.0f;
  M->at[1][4] = 0.0f;
  M->at[2][4] = 0.0f;
  M->at[3][4] = J_3;
  M->at[4][4] = diagonal1;
  M->at[5][4] = J_5;
  M->at[0][5] = 0.0f;
  M->at[1][5] = 0.0f;
  M->at[2][5] = 0.0f;
  M->at[3][5] = J_6;
  M->at[4][5] = J_7;
  M->at[5][5] = diagonal2;
}

/* M = J_r(s) = Σ (-[ad](s))^k / (k+1)!.
   s: screw (v in m/s; ω in rad/s); M: 6×6 operator.
   143 mul, 160 add, 6 div, 1 sqrt, 13 neg, 5 abs, 7 less, 15 select.
   Error <= M: 20 u of its largest component for |ω of s| <= π; searched, not proved.
     Intermediate sums may overflow where |v| is above 2e306, in single precision 5e36. */
static inline void ksl_SE3f_rightJacobian(const ksl_screwf_t *s, ksl_mat6x6f_t *M) {
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
  const float late_x = x < 9.0f ? 1.0f : x;
  const float rate2_rest = g1 - KSL_MULF(2.0f, g2);
  const float closed_rate2 = rate2_rest / late_x;
  const float rate3_rest = g2 - KSL_MULF(3.0f, g3);
  const float closed_rate3 = rate3_rest / late_x;
  const float rate2h = KSL_MULF(x, KSL_MULF(x, KSL_MULF(x, 5.951031e-26f
          - KSL_MULF(8.527712e-29f, x)) - 3.5458228e-23f) + 1.7793582e-20f) - 7.398571e-18f,
      rate2q = KSL_MULF(x, KSL_MULF(x, KSL_MULF(x, KSL_MULF(x, KSL_MULF(x, rate2h) + 2.499073e-15f)
          - 6.691268e-13f) + 1.3764895e-10f) - 2.0876756e-08f),
      rate2x = KSL_MULF(x, KSL_MULF(x, KSL_MULF(x, rate2q + 2.2045856e-06f) - 0.00014880953f)
          + 0.0055555557f) - 0.083333336f, rate2 = x < 9.0f ? rate2x : closed_rate2;
  const float rate3h = KSL_MULF(x, KSL_MULF(x, KSL_MULF(x, 2.2040857e-27f
          - KSL_MULF(2.9405903e-30f, x)) - 1.418329e-24f) + 7.7363405e-22f) - 3.5231295e-19f,
      rate3q = KSL_MULF(x, KSL_MULF(x, KSL_MULF(x, KSL_MULF(x, KSL_MULF(x, rate3h)
          + 1.3153016e-16f) - 3.93604e-14f) + 9.176596e-12f) - 1.6059044e-09f),
      rate3x = KSL_MULF(x, KSL_MULF(x, KSL_MULF(x, rate3q + 2.0041686e-07f) - 1.6534392e-05f)
          + 0.0007936508f) - 0.016666668f, rate3 = x < 9.0f ? rate3x : closed_rate3;
  const float beta_v_0 = KSL_MULF(s->m3, g3), beta_v_1 = KSL_MULF(s->m4, g3),
      beta_v_2 = KSL_MULF(s->m5, g3);
  const float m_0 = KSL_MULF(s->m3, beta_v_0), m_1 = KSL_MULF(s->m4, beta_v_1),
      m_2 = KSL_MULF(s->m5, beta_v_2), m_3 = KSL_MULF(s->m4, beta_v_0),
      m_4 = KSL_MULF(s->m5, beta_v_0), m_5 = KSL_MULF(s->m5, beta_v_1);
  const float others_0 = m_1 + m_2, others_1 = m_0 + m_2, others_2 = m_0 + m_1;
  const float diagonal0a = 1.0f - others_0, diagonal0b = g1 + m_0,
      diagonal0 = m_0 < others_0 ? diagonal0b : diagonal0a;
  const float diagonal1a = 1.0f - others_1, diagonal1b = g1 + m_1,
      diagonal1 = m_1 < others_1 ? diagonal1b : diagonal1a;
  const float diagonal2a = 1.0f - others_2, diagonal2b = g1 + m_2,
      diagonal2 = m_2 < others_2 ? diagonal2b : diagonal2a;
  const float alpha_v_0 = -KSL_MULF(s->m3, g2), alpha_v_1 = -KSL_MULF(s->m4, g2),
      alpha_v_2 = -KSL_MULF(s->m5, g2);
  const float J_1 = m_3 - alpha_v_2, J_2 = m_4 + alpha_v_1, J_3 = m_3 + alpha_v_2,
      J_5 = m_5 - alpha_v_0, J_6 = m_4 - alpha_v_1, J_7 = m_5 + alpha_v_0;
  const float rate_vw = KSL_MULF(s->m0, s->m3) + KSL_MULF(s->m1, s->m4) + KSL_MULF(s->m2, s->m5);
  const float rate_turn = KSL_MULF(rate2, rate_vw);
  const float rate_bend = -KSL_MULF(rate3, rate_vw);
  const float rate_q_0 = -(KSL_MULF(s->m0, g2) + KSL_MULF(s->m3, rate_turn)),
      rate_q_1 = -(KSL_MULF(s->m1, g2) + KSL_MULF(s->m4, rate_turn)),
      rate_q_2 = -(KSL_MULF(s->m2, g2) + KSL_MULF(s->m5, rate_turn));
  const float rate_beta_v_0 = -KSL_MULF(s->m0, g3), rate_beta_v_1 = -KSL_MULF(s->m1, g3),
      rate_beta_v_2 = -KSL_MULF(s->m2, g3);
  const float rate_bend_w_0 = -KSL_MULF(s->m3, rate_bend),
      rate_bend_w_1 = -KSL_MULF(s->m4, rate_bend), rate_bend_w_2 = -KSL_MULF(s->m5, rate_bend);
  const float rate_symmetric_0 = KSL_MULF(s->m4, rate_bend_w_0)
          - (KSL_MULF(s->m3, rate_beta_v_1) + KSL_MULF(s->m4, rate_beta_v_0)),
      rate_symmetric_1 = KSL_MULF(s->m5, rate_bend_w_0)
          - (KSL_MULF(s->m3, rate_beta_v_2) + KSL_MULF(s->m5, rate_beta_v_0)),
      rate_symmetric_2 = KSL_MULF(s->m5, rate_bend_w_1)
          - (KSL_MULF(s->m4, rate_beta_v_2) + KSL_MULF(s->m5, rate_beta_v_1));
  const float rate_diagonal_0b = KSL_MULF(KSL_MULF(2.0f, s->m4), rate_beta_v_1),
      rate_diagonal_0d = KSL_MULF(KSL_MULF(2.0f, s->m5), rate_beta_v_2),
      rate_diagonal_0f = KSL_MULF(s->m4, rate_bend_w_1),
      rate_diagonal_0g = KSL_MULF(s->m5, rate_bend_w_2),
      rate_diagonal_0 = rate_diagonal_0b + rate_diagonal_0d - (rate_diagonal_0f + rate_diagonal_0g);
  const float rate_diagonal_1b = KSL_MULF(KSL_MULF(2.0f, s->m3), rate_beta_v_0),
      rate_diagonal_1d = KSL_MULF(s->m3, rate_bend_w_0),
      rate_diagonal_1 = rate_diagonal_1b + rate_diagonal_0d - (rate_diagonal_1d + rate_diagonal_0g);
  const float rate_diagonal_2 = rate_diagonal_1b + rate_diagonal_0b
          - (rate_diagonal_1d + rate_diagonal_0f);
  const float M_04 = rate_symmetric_0 - rate_q_2, M_05 = rate_q_1 + rate_symmetric_1,
      M_13 = rate_q_2 + rate_symmetric_0, M_15 = rate_symmetric_2 - rate_q_0,
      M_23 = rate_symmetric_1 - rate_q_1, M_24 = rate_q_0 + rate_symmetric_2;
  M->at[0][0] = diagonal0;
  M->at[1][0] = J_1;
  M->at[2][0] = J_2;
  M->at[3][0] = rate_diagonal_0;
  M->at[4][0] = M_04;
  M->at[5][0] = M_05;
  M->at[0][1] = J_3;
  M->at[1][1] = diagonal1;
  M->at[2][1] = J_5;
  M->at[3][1] = M_13;
  M->at[4][1] = rate_diagonal_1;
  M->at[5][1] = M_15;
  M->at[0][2] = J_6;
  M->at[1][2] = J_7;
  M->at[2][2] = diagonal2;
  M->at[3][2] = M_23;
  M->at[4][2] = M_24;
  M->at[5][2] = rate_diagonal_2;
  M->at[0][3] = 0.0f;
  M->at[1][3] = 0.0f;
  M->at[2][3] = 0.0f;
  M->at[3][3] = diagonal0;
  M->at[4][3] = J_1;
  M->at[5][3] = J_2;
  M->at[0][4] = 0.0f;
  M->at[1][4] = 0.0f;
  M->at[2][4] = 0.0f;
  M->at[3][4] = J_3;
  M->at[4][4] = diagonal1;
  M->at[5][4] = J_5;
  M->at[0][5] = 0.0f;
  M->at[1][5] = 0.0f;
  M->at[2][5] = 0.0f;
  M->at[3][5] = J_6;
  M->at[4][5] = J_7;
  M->at[5][5] = diagonal2;
}

/* M = J_l(s)^-1; singular where |ω| is a multiple of 2π except 0.
   s: screw (v in m/s; ω in rad/s); M: 6×6 operator.
   115 mul, 133 add, 5 div, 1 sqrt, 7 neg, 5 abs, 7 less, 13 select.
   Error <= M: 14 u of its largest component for |ω of s| <= π; searched, not proved.
     Intermediate sums may overflow where |v| is above 2e306, in single precision 5e36. */
static inline void ksl_SE3f_leftJacobianInverse(const ksl_screwf_t *s, ksl_mat6x6f_t *M) {
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
  const float beta_v_0 = KSL_MULF(s->m3, b), beta_v_1 = KSL_MULF(s->m4, b),
      beta_v_2 = KSL_MULF(s->m5, b);
  const float m_0 = KSL_MULF(s->m3, beta_v_0), m_1 = KSL_MULF(s->m4, beta_v_1),
      m_2 = KSL_MULF(s->m5, beta_v_2), m_3 = KSL_MULF(s->m4, beta_v_0),
      m_4 = KSL_MULF(s->m5, beta_v_0), m_5 = KSL_MULF(s->m5, beta_v_1);
  const float others_0 = m_1 + m_2, others_1 = m_0 + m_2, others_2 = m_0 + m_1;
  const float diagonal0a = 1.0f - others_0, diagonal0b = b_across + m_0,
      diagonal0 = m_0 < others_0 ? diagonal0b : diagonal0a;
  const float diagonal1a = 1.0f - others_1, diagonal1b = b_across + m_1,
      diagonal1 = m_1 < others_1 ? diagonal1b : diagonal1a;
  const float diagonal2a = 1.0f - others_2, diagonal2b = b_across + m_2,
      diagonal2 = m_2 < others_2 ? diagonal2b : diagonal2a;
  const float alpha_v_0 = -KSL_MULF(0.5f, s->m3), alpha_v_1 = -KSL_MULF(0.5f, s->m4),
      alpha_v_2 = -KSL_MULF(0.5f, s->m5);
  const float J_1 = m_3 - alpha_v_2, J_2 = m_4 + alpha_v_1, J_3 = m_3 + alpha_v_2,
      J_5 = m_5 - alpha_v_0, J_6 = m_4 - alpha_v_1, J_7 = m_5 + alpha_v_0;
  const float b_rate_across = (2.0f - half_cotangent) / b_divisor;
  const float b_rate_square = 0.25f + KSL_MULF(0.25f, KSL_MULF(cotangent, cotangent));
  const float b_rate_rest = b_rate_square - b_rate_across;
  const float closed_b_rate = b_rate_rest / b_divisor;
  const float b_rate_h = KSL_MULF(x, KSL_MULF(x, KSL_MULF(x, KSL_MULF(3.3612244e-29f, x)
          + 1.2532382e-27f) + 4.656552e-26f) + 1.7234372e-24f) + 6.350267e-23f,
      b_rate_p = KSL_MULF(x, KSL_MULF(x, KSL_MULF(x, KSL_MULF(x, b_rate_h) + 2.3279144e-21f)
          + 8.483297e-20f) + 3.0699822e-18f) + 1.10180054e-16f,
      b_rate_y = KSL_MULF(x, KSL_MULF(x, KSL_MULF(x, KSL_MULF(x, KSL_MULF(x, b_rate_p)
          + 3.9147635e-15f) + 1.37377e-13f) + 4.7455525e-12f) + 1.6059044e-10f),
      b_rate_ag = KSL_MULF(x, KSL_MULF(x, KSL_MULF(x, KSL_MULF(x, b_rate_y + 5.28419e-09f)
          + 1.6701405e-07f) + 4.9603173e-06f) + 0.00013227513f),
      b_rate_ah = b_rate_ag + 0.0027777778f, b_rate = x < 4.0f ? b_rate_ah : closed_b_rate;
  const float rate_vw = KSL_MULF(s->m0, s->m3) + KSL_MULF(s->m1, s->m4) + KSL_MULF(s->m2, s->m5);
  const float rate_bend = -KSL_MULF(b_rate, rate_vw);
  const float rate_q_0 = -KSL_MULF(0.5f, s->m0), rate_q_1 = -KSL_MULF(0.5f, s->m1),
      rate_q_2 = -KSL_MULF(0.5f, s->m2);
  const float rate_beta_v_0 = KSL_MULF(s->m0, b), rate_beta_v_1 = KSL_MULF(s->m1, b),
      rate_beta_v_2 = KSL_MULF(s->m2, b);
  const float rate_bend_w_0 = KSL_MULF(s->m3, rate_bend),
      rate_bend_w_1 = KSL_MULF(s->m4, rate_bend), rate_bend_w_2 = KSL_MULF(s->m5, rate_bend);
  const float rate_symmetric_0 = KSL_MULF(s->m3, rate_beta_v_1) + KSL_MULF(s->m4, rate_beta_v_0)
          - KSL_MULF(s->m4, rate_bend_w_0),
      rate_symmetric_1 = KSL_MULF(s->m3, rate_beta_v_2) + KSL_MULF(s->m5, rate_beta_v_0)
          - KSL_MULF(s->m5, rate_bend_w_0),
      rate_symmetric_2 = KSL_MULF(s->m4, rate_beta_v_2) + KSL_MULF(s->m5, rate_beta_v_1)
          - KSL_MULF(s->m5, rate_bend_w_1);
  const float rate_diagonal_0a = KSL_MULF(s->m4, rate_bend_w_1),
      rate_diagonal_0b = KSL_MULF(s->m5, rate_bend_w_2),
      rate_diagonal_0e = KSL_MULF(KSL_MULF(2.0f, s->m4), rate_beta_v_1),
      rate_diagonal_0g = KSL_MULF(KSL_MULF(2.0f, s->m5), rate_beta_v_2),
      rate_diagonal_0 = rate_diagonal_0a + rate_diagonal_0b - (rate_diagonal_0e + rate_diagonal_0g);
  const float rate_diagonal_1a = KSL_MULF(s->m3, rate_bend_w_0),
      rate_diagonal_1d = KSL_MULF(KSL_MULF(2.0f, s->m3), rate_beta_v_0),
      rate_diagonal_1 = rate_diagonal_1a + rate_diagonal_0b - (rate_diagonal_1d + rate_diagonal_0g);
  const float rate_diagonal_2 = rate_diagonal_1a + rate_diagonal_0a
          - (rate_diagonal_1d + rate_diagonal_0e);
  const float M_04 = rate_symmetric_0 - rate_q_2, M_05 = rate_q_1 + rate_symmetric_1,
      M_13 = rate_q_2 + rate_symmetric_0, M_15 = rate_symmetric_2 - rate_q_0,
      M_23 = rate_symmetric_1 - rate_q_1, M_24 = rate_q_0 + rate_symmetric_2;
  M->at[0][0] = diagonal0;
  M->at[1][0] = J_1;
  M->at[2][0] = J_2;
  M->at[3][0] = rate_diagonal_0;
  M->at[4][0] = M_04;
  M->at[5][0] = M_05;
  M->at[0][1] = J_3;
  M->at[1][1] = diagonal1;
  M->at[2][1] = J_5;
  M->at[3][1] = M_13;
  M->at[4][1] = rate_diagonal_1;
  M->at[5][1] = M_15;
  M->at[0][2] = J_6;
  M->at[1][2] = J_7;
  M->at[2][2] = diagonal2;
  M->at[3][2] = M_23;
  M->at[4][2] = M_24;
  M->at[5][2] = rate_diagonal_2;
  M->at[0][3] = 0.0f;
  M->at[1][3] = 0.0f;
  M->at[2][3] = 0.0f;
  M->at[3][3] = diagonal0;
  M->at[4][3] = J_1;
  M->at[5][3] = J_2;
  M->at[0][4] = 0.0f;
  M->at[1][4] = 0.0f;
  M->at[2][4] = 0.0f;
  M->at[3][4] = J_3;
  M->at[4][4] = diagonal1;
  M->at[5][4] = J_5;
  M->at[0][5] = 0.0f;
  M->at[1][5] = 0.0f;
  M->at[2][5] = 0.0f;
  M->at[3][5] = J_6;
  M->at[4][5] = J_7;
  M->at[5][5] = diagonal2;
}

/* M = J_r(s)^-1; singular where |ω| is a multiple of 2π except 0.
   s: screw (v in m/s; ω in rad/s); M: 6×6 operator.
   115 mul, 133 add, 5 div, 1 sqrt, 7 neg, 5 abs, 7 less, 13 select.
   Error <= M: 14 u of its largest component for |ω of s| <= π; searched, not proved.
     Intermediate sums may overflow where |v| is above 2e306, in single precision 5e36. */
static inline void ksl_SE3f_rightJacobianInverse(const ksl_screwf_t *s, ksl_mat6x6f_t *M) {
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
  const float beta_v_0 = KSL_MULF(s->m3, b), beta_v_1 = KSL_MULF(s->m4, b),
      beta_v_2 = KSL_MULF(s->m5, b);
  const float m_0 = KSL_MULF(s->m3, beta_v_0), m_1 = KSL_MULF(s->m4, beta_v_1),
      m_2 = KSL_MULF(s->m5, beta_v_2), m_3 = KSL_MULF(s->m4, beta_v_0),
      m_4 = KSL_MULF(s->m5, beta_v_0), m_5 = KSL_MULF(s->m5, beta_v_1);
  const float others_0 = m_1 + m_2, others_1 = m_0 + m_2, others_2 = m_0 + m_1;
  const float diagonal0a = 1.0f - others_0, diagonal0b = b_across + m_0,
      diagonal0 = m_0 < others_0 ? diagonal0b : diagonal0a;
  const float diagonal1a = 1.0f - others_1, diagonal1b = b_across + m_1,
      diagonal1 = m_1 < others_1 ? diagonal1b : diagonal1a;
  const float diagonal2a = 1.0f - others_2, diagonal2b = b_across + m_2,
      diagonal2 = m_2 < others_2 ? diagonal2b : diagonal2a;
  const float alpha_v_0 = KSL_MULF(0.5f, s->m3), alpha_v_1 = KSL_MULF(0.5f, s->m4),
      alpha_v_2 = KSL_MULF(0.5f, s->m5);
  const float J_1 = m_3 - alpha_v_2, J_2 = m_4 + alpha_v_1, J_3 = m_3 + alpha_v_2,
      J_5 = m_5 - alpha_v_0, J_6 = m_4 - alpha_v_1, J_7 = m_5 + alpha_v_0;
  const float b_rate_across = (2.0f - half_cotangent) / b_divisor;
  const float b_rate_square = 0.25f + KSL_MULF(0.25f, KSL_MULF(cotangent, cotangent));
  const float b_rate_rest = b_rate_square - b_rate_across;
  const float closed_b_rate = b_rate_rest / b_divisor;
  const float b_rate_h = KSL_MULF(x, KSL_MULF(x, KSL_MULF(x, KSL_MULF(3.3612244e-29f, x)
          + 1.2532382e-27f) + 4.656552e-26f) + 1.7234372e-24f) + 6.350267e-23f,
      b_rate_p = KSL_MULF(x, KSL_MULF(x, KSL_MULF(x, KSL_MULF(x, b_rate_h) + 2.3279144e-21f)
          + 8.483297e-20f) + 3.0699822e-18f) + 1.10180054e-16f,
      b_rate_y = KSL_MULF(x, KSL_MULF(x, KSL_MULF(x, KSL_MULF(x, KSL_MULF(x, b_rate_p)
          + 3.9147635e-15f) + 1.37377e-13f) + 4.7455525e-12f) + 1.6059044e-10f),
      b_rate_ag = KSL_MULF(x, KSL_MULF(x, KSL_MULF(x, KSL_MULF(x, b_rate_y + 5.28419e-09f)
          + 1.6701405e-07f) + 4.9603173e-06f) + 0.00013227513f),
      b_rate_ah = b_rate_ag + 0.0027777778f, b_rate = x < 4.0f ? b_rate_ah : closed_b_rate;
  const float rate_vw = KSL_MULF(s->m0, s->m3) + KSL_MULF(s->m1, s->m4) + KSL_MULF(s->m2, s->m5);
  const float rate_bend = -KSL_MULF(b_rate, rate_vw);
  const float rate_q_0 = KSL_MULF(0.5f, s->m0), rate_q_1 = KSL_MULF(0.5f, s->m1),
      rate_q_2 = KSL_MULF(0.5f, s->m2);
  const float rate_beta_v_0 = -KSL_MULF(s->m0, b), rate_beta_v_1 = -KSL_MULF(s->m1, b),
      rate_beta_v_2 = -KSL_MULF(s->m2, b);
  const float rate_bend_w_0 = -KSL_MULF(s->m3, rate_bend),
      rate_bend_w_1 = -KSL_MULF(s->m4, rate_bend), rate_bend_w_2 = -KSL_MULF(s->m5, rate_bend);
  const float rate_symmetric_0 = KSL_MULF(s->m4, rate_bend_w_0)
          - (KSL_MULF(s->m3, rate_beta_v_1) + KSL_MULF(s->m4, rate_beta_v_0)),
      rate_symmetric_1 = KSL_MULF(s->m5, rate_bend_w_0)
          - (KSL_MULF(s->m3, rate_beta_v_2) + KSL_MULF(s->m5, rate_beta_v_0)),
      rate_symmetric_2 = KSL_MULF(s->m5, rate_bend_w_1)
          - (KSL_MULF(s->m4, rate_beta_v_2) + KSL_MULF(s->m5, rate_beta_v_1));
  const float rate_diagonal_0b = KSL_MULF(KSL_MULF(2.0f, s->m4), rate_beta_v_1),
      rate_diagonal_0d = KSL_MULF(KSL_MULF(2.0f, s->m5), rate_beta_v_2),
      rate_diagonal_0f = KSL_MULF(s->m4, rate_bend_w_1),
      rate_diagonal_0g = KSL_MULF(s->m5, rate_bend_w_2),
      rate_diagonal_0 = rate_diagonal_0b + rate_diagonal_0d - (rate_diagonal_0f + rate_diagonal_0g);
  const float rate_diagonal_1b = KSL_MULF(KSL_MULF(2.0f, s->m3), rate_beta_v_0),
      rate_diagonal_1d = KSL_MULF(s->m3, rate_bend_w_0),
      rate_diagonal_1 = rate_diagonal_1b + rate_diagonal_0d - (rate_diagonal_1d + rate_diagonal_0g);
  const float rate_diagonal_2 = rate_diagonal_1b + rate_diagonal_0b
          - (rate_diagonal_1d + rate_diagonal_0f);
  const float M_04 = rate_symmetric_0 - rate_q_2, M_05 = rate_q_1 + rate_symmetric_1,
      M_13 = rate_q_2 + rate_symmetric_0, M_15 = rate_symmetric_2 - rate_q_0,
      M_23 = rate_symmetric_1 - rate_q_1, M_24 = rate_q_0 + rate_symmetric_2;
  M->at[0][0] = diagonal0;
  M->at[1][0] = J_1;
  M->at[2][0] = J_2;
  M->at[3][0] = rate_diagonal_0;
  M->at[4][0] = M_04;
  M->at[5][0] = M_05;
  M->at[0][1] = J_3;
  M->at[1][1] = diagonal1;
  M->at[2][1] = J_5;
  M->at[3][1] = M_13;
  M->at[4][1] = rate_diagonal_1;
  M->at[5][1] = M_15;
  M->at[0][2] = J_6;
  M->at[1][2] = J_7;
  M->at[2][2] = diagonal2;
  M->at[3][2] = M_23;
  M->at[4][2] = M_24;
  M->at[5][2] = rate_diagonal_2;
  M->at[0][3] = 0.0f;
  M->at[1][3] = 0.0f;
  M->at[2][3] = 0.0f;
  M->at[3][3] = diagonal0;
  M->at[4][3] = J_1;
  M->at[5][3] = J_2;
  M->at[0][4] = 0.0f;
  M->at[1][4] = 0.0f;
  M->at[2][4] = 0.0f;
  M->at[3][4] = J_3;
  M->at[4][4] = diagonal1;
  M->at[5][4] = J_5;
  M->at[0][5] = 0.0f;
  M->at[1][5] = 0.0f;
  M->at[2][5] = 0.0f;
  M->at[3][5] = J_6;
  M->at[4][5] = J_7;
  M->at[5][5] = diagonal2;
}

/* Do = D1 exp(k log(D1^-1 D2)), the screw motion from D1 at k = 0 to D2 at k = 1.
   D1, D2, Do: displacement [R | t], R rotation, t in m; k: number.
   252 mul, 248 add, 8 div, 2 sqrt, 6 neg, 10 abs, 2 copysign, 26 less, 2 equal, 56 select.
   Error <= R: 22 u, t: 60 u of its largest component, or of D1.t or D2.t if that is larger, for
     R of D1 a rotation and R of D2 a rotation and 0 <= k <= 1; searched, not proved.
     Intermediate sums may overflow where |t| of D1 or D2 is above 2e306, in single precision
     5e36. */
static inline void ksl_SE3f_interpolated(const ksl_SE3f_t *D1, const ksl_SE3f_t *D2,
    const float k, ksl_SE3f_t *Do) {
  const float apart_0 = D2->m03 - D1->m03, apart_1 = D2->m13 - D1->m13, apart_2 = D2->m23 - D1->m23;
  const float between_0 = KSL_MULF(D1->m00, D2->m00) + KSL_MULF(D1->m10, D2->m10)
          + KSL_MULF(D1->m20, D2->m20),
      between_1 = KSL_MULF(D1->m00, D2->m01) + KSL_MULF(D1->m10, D2->m11)
          + KSL_MULF(D1->m20, D2->m21),
      between_2 = KSL_MULF(D1->m00, D2->m02) + KSL_MULF(D1->m10, D2->m12)
          + KSL_MULF(D1->m20, D2->m22),
      between_3 = KSL_MULF(D1->m00, apart_0) + KSL_MULF(D1->m10, apart_1)
          + KSL_MULF(D1->m20, apart_2),
      between_4 = KSL_MULF(D1->m01, D2->m00) + KSL_MULF(D1->m11, D2->m10)
          + KSL_MULF(D1->m21, D2->m20),
      between_5 = KSL_MULF(D1->m01, D2->m01) + KSL_MULF(D1->m11, D2->m11)
          + KSL_MULF(D1->m21, D2->m21),
      between_6 = KSL_MULF(D1->m01, D2->m02) + KSL_MULF(D1->m11, D2->m12)
          + KSL_MULF(D1->m21, D2->m22),
      between_7 = KSL_MULF(D1->m01, apart_0) + KSL_MULF(D1->m11, apart_1)
          + KSL_MULF(D1->m21, apart_2),
      between_8 = KSL_MULF(D1->m02, D2->m00) + KSL_MULF(D1->m12, D2->m10)
          + KSL_MULF(D1->m22, D2->m20),
      between_9 = KSL_MULF(D1->m02, D2->m01) + KSL_MULF(D1->m12, D2->m11)
          + KSL_MULF(D1->m22, D2->m21),
      between_10 = KSL_MULF(D1->m02, D2->m02) + KSL_MULF(D1->m12, D2->m12)
          + KSL_MULF(D1->m22, D2->m22),
      between_11 = KSL_MULF(D1->m02, apart_0) + KSL_MULF(D1->m12, apart_1)
          + KSL_MULF(D1->m22, apart_2);
  const float log_p_0 = between_9 - between_6, log_p_1 = between_2 - between_8,
      log_p_2 = between_4 - between_1;
  const float log_s_0 = between_6 + between_9, log_s_1 = between_2 + between_8,
      log_s_2 = between_1 + between_4;
  const float log_first_0 = between_0 + 1.0f, log_first_1 = 1.0f - between_0;
  const float log_others_0 = between_5 + between_10, log_others_1 = between_5 - between_10;
  const float log_d_0 = log_first_0 + log_others_0, log_d_1 = log_first_0 - log_others_0,
      log_d_2 = log_first_1 + log_others_1, log_d_3 = log_first_1 - log_others_1;
  const float log_low_0 = between_5 < between_0 ? log_d_1 : log_s_2,
      log_low_1 = between_5 < between_0 ? log_s_2 : log_d_2,
      log_low_2 = between_5 < between_0 ? log_s_1 : log_s_0,
      log_low_3 = between_5 < between_0 ? log_p_0 : log_p_1;
  const float log_high_0a = -between_5, log_high_0 = between_0 < log_high_0a ? log_s_1 : log_p_0;
  const float log_high_1 = between_0 < log_high_0a ? log_s_0 : log_p_1,
      log_high_2 = between_0 < log_high_0a ? log_d_3 : log_p_2,
      log_high_3 = between_0 < log_high_0a ? log_p_2 : log_d_0;
  const float log_column_0 = between_10 < 0.0f ? log_low_0 : log_high_0,
      log_column_1 = between_10 < 0.0f ? log_low_1 : log_high_1,
      log_column_2 = between_10 < 0.0f ? log_low_2 : log_high_2,
      log_column_3 = between_10 < 0.0f ? log_low_3 : log_high_3;
  const float log_upper_0a = -log_column_0,
      log_upper_0 = log_column_3 < 0.0f ? log_upper_0a : log_column_0;
  const float log_upper_1a = -log_column_1,
      log_upper_1 = log_column_3 < 0.0f ? log_upper_1a : log_column_1;
  const float log_upper_2a = -log_column_2,
      log_upper_2 = log_column_3 < 0.0f ? log_upper_2a : log_column_2;
  const float log_upper_3a = -log_column_3,
      log_upper_3 = log_column_3 < 0.0f ? log_upper_3a : log_column_3;
  const float log_v_s_size_0 = fabsf(log_upper_0), log_v_s_size_1 = fabsf(log_upper_1),
      log_v_s_size_2 = fabsf(log_upper_2);
  const float log_v_s_largest1 = log_v_s_size_0 < log_v_s_size_1 ? log_v_s_size_1 : log_v_s_size_0;
  const float log_v_s_largest2 = log_v_s_largest1 < log_v_s_size_2 ? log_v_s_size_2
          : log_v_s_largest1;
  const float log_v_s_b = 4.611686e+18f < log_v_s_largest2 ? 2.7105054e-20f : 1.0f,
      log_v_s_d = log_v_s_largest2 < 256.0f ? 1.8014399e+16f : log_v_s_b,
      log_v_s = log_v_s_largest2 < 1.4210855e-14f ? 3.2451855e+32f : log_v_s_d;
  const float log_v_y_0 = KSL_MULF(log_upper_0, log_v_s),
      log_v_y_1 = KSL_MULF(log_upper_1, log_v_s), log_v_y_2 = KSL_MULF(log_upper_2, log_v_s);
  const float log_v_n = sqrtf(KSL_MULF(log_v_y_0, log_v_y_0) + KSL_MULF(log_v_y_1, log_v_y_1)
          + KSL_MULF(log_v_y_2, log_v_y_2));
  const float log_v_r_b = log_v_s < 1.0f ? 3.689349e+19f : 1.0f,
      log_v_r_d = 1.0f < log_v_s ? 5.551115e-17f : log_v_r_b,
      log_v_r = 1.8014399e+16f < log_v_s ? 3.081488e-33f : log_v_r_d;
  const float log_n = KSL_MULF(log_v_n, log_v_r);
  const float log_half = ksl_atan2f(log_n, log_upper_3);
  const float log_divisor = log_n == 0.0f ? 1.0f : log_n;
  const float log_theta = KSL_MULF(2.0f, log_half);
  const float log_k = log_theta / log_divisor;
  const float log_vector_0 = KSL_MULF(log_upper_0, log_k),
      log_vector_1 = KSL_MULF(log_upper_1, log_k), log_vector_2 = KSL_MULF(log_upper_2, log_k);
  const float log_x = KSL_MULF(log_theta, log_theta);
  const float log_far_sine = log_x < 1.0f ? 1.0f : log_n;
  const float log_cotangent = log_upper_3 / log_far_sine;
  const float log_half_cotangent = KSL_MULF(KSL_MULF(0.5f, log_theta), log_cotangent);
  const float log_b_rest = 1.0f - log_half_cotangent;
  const float log_b_divisor = log_x < 4.0f ? 4.0f : log_x;
  const float log_closed_b = log_b_rest / log_b_divisor;
  const float log_b_g = KSL_MULF(log_x, KSL_MULF(log_x, KSL_MULF(log_x, KSL_MULF(1.4551725e-27f,
      log_x) + 5.744791e-26f) + 2.2679524e-24f) + 8.9535176e-23f),
      log_b_n = KSL_MULF(log_x, KSL_MULF(log_x, KSL_MULF(log_x, log_b_g + 3.534707e-21f)
          + 1.3954465e-19f) + 5.509003e-18f) + 2.1748687e-16f,
      log_b_u = KSL_MULF(log_x, KSL_MULF(log_x, KSL_MULF(log_x, KSL_MULF(log_x, log_b_n)
          + 8.586062e-15f) + 3.3896803e-13f) + 1.3382536e-11f),
      log_b_ab = KSL_MULF(log_x, KSL_MULF(log_x, KSL_MULF(log_x, log_b_u + 5.2841903e-10f)
          + 2.0876756e-08f) + 8.267196e-07f) + 3.3068784e-05f,
      log_b_af = KSL_MULF(log_x, KSL_MULF(log_x, log_b_ab) + 0.0013888889f) + 0.083333336f,
      log_b = log_x < 4.0f ? log_b_af : log_closed_b;
  const float log_b_across_b = 1.0f - KSL_MULF(log_x, log_b),
      log_b_across = log_x < 4.0f ? log_b_across_b : log_half_cotangent;
  const float log_wt = KSL_MULF(between_3, log_vector_0) + KSL_MULF(between_7, log_vector_1)
          + KSL_MULF(between_11, log_vector_2);
  const float log_pitch = KSL_MULF(log_b, log_wt);
  const float log_along_0 = KSL_MULF(log_vector_0, log_pitch),
      log_along_1 = KSL_MULF(log_vector_1, log_pitch),
      log_along_2 = KSL_MULF(log_vector_2, log_pitch);
  const float log_u_0 = KSL_MULF(between_11, log_vector_1) - KSL_MULF(between_7, log_vector_2),
      log_u_1 = KSL_MULF(between_3, log_vector_2) - KSL_MULF(between_11, log_vector_0),
      log_u_2 = KSL_MULF(between_7, log_vector_0) - KSL_MULF(between_3, log_vector_1);
  const float log_turned_0 = KSL_MULF(0.5f, log_u_0), log_turned_1 = KSL_MULF(0.5f, log_u_1),
      log_turned_2 = KSL_MULF(0.5f, log_u_2);
  const float log_across_axis_0 = log_along_0 - log_turned_0,
      log_across_axis_1 = log_along_1 - log_turned_1,
      log_across_axis_2 = log_along_2 - log_turned_2;
  const float whole_0 = KSL_MULF(between_3, log_b_across) + log_across_axis_0,
      whole_1 = KSL_MULF(between_7, log_b_across) + log_across_axis_1,
      whole_2 = KSL_MULF(between_11, log_b_across) + log_across_axis_2;
  const float screw_0 = KSL_MULF(k, whole_0), screw_1 = KSL_MULF(k, whole_1),
      screw_2 = KSL_MULF(k, whole_2), screw_3 = KSL_MULF(k, log_vector_0),
      screw_4 = KSL_MULF(k, log_vector_1), screw_5 = KSL_MULF(k, log_vector_2);
  const float exp_size_0 = fabsf(screw_3), exp_size_1 = fabsf(screw_4), exp_size_2 = fabsf(screw_5);
  const float exp_sizes = exp_size_0 + exp_size_1 + exp_size_2;
  const float exp_grid = KSL_MULF(exp_sizes, 8192.0f);
  const float exp_shifted_0 = screw_3 + exp_grid, exp_shifted_1 = screw_4 + exp_grid,
      exp_shifted_2 = screw_5 + exp_grid;
  const float exp_high_0 = exp_shifted_0 - exp_grid, exp_high_1 = exp_shifted_1 - exp_grid,
      exp_high_2 = exp_shifted_2 - exp_grid;
  const float exp_low_0 = screw_3 - exp_high_0, exp_low_1 = screw_4 - exp_high_1,
      exp_low_2 = screw_5 - exp_high_2;
  const float exp_sum_0 = screw_3 + exp_high_0, exp_sum_1 = screw_4 + exp_high_1,
      exp_sum_2 = screw_5 + exp_high_2;
  const float exp_squares = KSL_MULF(exp_high_0, exp_high_0) + KSL_MULF(exp_high_1, exp_high_1)
          + KSL_MULF(exp_high_2, exp_high_2);
  const float exp_cross = KSL_MULF(exp_low_0, exp_sum_0) + KSL_MULF(exp_low_1, exp_sum_1)
          + KSL_MULF(exp_low_2, exp_sum_2);
  const float exp_x = exp_squares + exp_cross;
  const float exp_theta_a = sqrtf(exp_x), exp_theta = exp_x < 1.0f ? 1.0f : exp_theta_a;
  const float exp_theta_shifted = exp_grid + exp_theta;
  const float exp_theta_high = exp_theta_shifted - exp_grid;
  const float exp_theta_low = exp_theta - exp_theta_high;
  const float exp_theta_sum = exp_theta + exp_theta_high;
  const float exp_cross_rest = exp_cross - KSL_MULF(exp_theta_low, exp_theta_sum);
  const float exp_exact = exp_squares - KSL_MULF(exp_theta_high, exp_theta_high);
  const float exp_residual = exp_cross_rest + exp_exact;
  const float exp_small = KSL_MULF(0.5f, exp_residual) / exp_theta;
  const float exp_delta = fabsf(exp_small) < 0.0078125f ? exp_small : 0.0f;
  float exp_far_cosine_a; const float exp_far_sine_a = ksl_sincosf(exp_theta, &exp_far_cosine_a);
  const float exp_far_sine = exp_x < 1.0f ? 1.0f : exp_far_sine_a;
  const float exp_far_cosine = exp_x < 1.0f ? 0.0f : exp_far_cosine_a;
  const float exp_sine = KSL_MULF(exp_delta, exp_far_cosine) + exp_far_sine;
  const float exp_cosine = exp_far_cosine - KSL_MULF(exp_delta, exp_far_sine);
  const float exp_far_x = exp_x < 1.0f ? 1.0f : exp_x;
  const float exp_middle_x = exp_x < 4.0f ? 4.0f : exp_x;
  const float exp_closed1 = exp_sine / exp_theta;
  const float exp_versine = 1.0f - exp_cosine;
  const float exp_closed2 = exp_versine / exp_far_x;
  const float exp_rest3 = 1.0f - exp_closed1;
  const float exp_closed3 = exp_rest3 / exp_middle_x;
  const float exp_g1g = KSL_MULF(exp_x, KSL_MULF(exp_x, KSL_MULF(exp_x, KSL_MULF(6.4469503e-26f,
      exp_x) - 3.8681703e-23f) + 1.9572942e-20f) - 8.220635e-18f),
      exp_g1n = KSL_MULF(exp_x, KSL_MULF(exp_x, KSL_MULF(exp_x, exp_g1g + 2.8114574e-15f)
          - 7.6471636e-13f) + 1.6059044e-10f) - 2.5052108e-08f,
      exp_g1v = KSL_MULF(exp_x, KSL_MULF(exp_x, KSL_MULF(exp_x, KSL_MULF(exp_x, exp_g1n)
          + 2.7557319e-06f) - 0.0001984127f) + 0.008333334f) - 0.16666667f,
      exp_g1x = KSL_MULF(exp_x, exp_g1v) + 1.0f, exp_g1 = exp_x < 1.0f ? exp_g1x : exp_closed1;
  const float exp_g2g = KSL_MULF(exp_x, KSL_MULF(exp_x, KSL_MULF(exp_x, KSL_MULF(2.4795963e-27f,
      exp_x) - 1.6117376e-24f) + 8.896791e-22f) - 4.1103176e-19f),
      exp_g2n = KSL_MULF(exp_x, KSL_MULF(exp_x, KSL_MULF(exp_x, exp_g2g + 1.5619207e-16f)
          - 4.7794773e-14f) + 1.1470745e-11f) - 2.0876756e-09f,
      exp_g2v = KSL_MULF(exp_x, KSL_MULF(exp_x, KSL_MULF(exp_x, KSL_MULF(exp_x, exp_g2n)
          + 2.755732e-07f) - 2.4801588e-05f) + 0.0013888889f) - 0.041666668f,
      exp_g2x = KSL_MULF(exp_x, exp_g2v) + 0.5f, exp_g2 = exp_x < 1.0f ? exp_g2x : exp_closed2;
  const float exp_g3g = KSL_MULF(exp_x, KSL_MULF(exp_x, KSL_MULF(exp_x, KSL_MULF(9.18369e-29f,
      exp_x) - 6.4469503e-26f) + 3.8681703e-23f) - 1.9572942e-20f),
      exp_g3n = KSL_MULF(exp_x, KSL_MULF(exp_x, KSL_MULF(exp_x, exp_g3g + 8.220635e-18f)
          - 2.8114574e-15f) + 7.6471636e-13f) - 1.6059044e-10f,
      exp_g3v = KSL_MULF(exp_x, KSL_MULF(exp_x, KSL_MULF(exp_x, KSL_MULF(exp_x, exp_g3n)
          + 2.5052108e-08f) - 2.7557319e-06f) + 0.0001984127f) - 0.008333334f,
      exp_g3x = KSL_MULF(exp_x, exp_g3v) + 0.16666667f,
      exp_g3 = exp_x < 4.0f ? exp_g3x : exp_closed3;
  const float exp_g0b = 1.0f - KSL_MULF(exp_x, exp_g2),
      exp_g0 = exp_x < 1.0f ? exp_g0b : exp_cosine;
  const float exp_u_0 = KSL_MULF(screw_2, screw_4) - KSL_MULF(screw_1, screw_5),
      exp_u_1 = KSL_MULF(screw_0, screw_5) - KSL_MULF(screw_2, screw_3),
      exp_u_2 = KSL_MULF(screw_1, screw_3) - KSL_MULF(screw_0, screw_4);
  const float exp_turned_0 = KSL_MULF(exp_g2, exp_u_0), exp_turned_1 = KSL_MULF(exp_g2, exp_u_1),
      exp_turned_2 = KSL_MULF(exp_g2, exp_u_2);
  const float exp_wv = KSL_MULF(screw_0, screw_3) + KSL_MULF(screw_1, screw_4)
          + KSL_MULF(screw_2, screw_5);
  const float exp_pitch = KSL_MULF(exp_g3, exp_wv);
  const float exp_along_0 = KSL_MULF(screw_3, exp_pitch),
      exp_along_1 = KSL_MULF(screw_4, exp_pitch), exp_along_2 = KSL_MULF(screw_5, exp_pitch);
  const float exp_beta_v_0 = KSL_MULF(screw_3, exp_g2), exp_beta_v_1 = KSL_MULF(screw_4, exp_g2),
      exp_beta_v_2 = KSL_MULF(screw_5, exp_g2);
  const float exp_m_0 = KSL_MULF(screw_3, exp_beta_v_0), exp_m_1 = KSL_MULF(screw_4, exp_beta_v_1),
      exp_m_2 = KSL_MULF(screw_5, exp_beta_v_2), exp_m_3 = KSL_MULF(screw_4, exp_beta_v_0),
      exp_m_4 = KSL_MULF(screw_5, exp_beta_v_0), exp_m_5 = KSL_MULF(screw_5, exp_beta_v_1);
  const float exp_others_0 = exp_m_1 + exp_m_2, exp_others_1 = exp_m_0 + exp_m_2,
      exp_others_2 = exp_m_0 + exp_m_1;
  const float exp_diagonal0a = 1.0f - exp_others_0, exp_diagonal0b = exp_g0 + exp_m_0,
      exp_diagonal0 = exp_m_0 < exp_others_0 ? exp_diagonal0b : exp_diagonal0a;
  const float exp_diagonal1a = 1.0f - exp_others_1, exp_diagonal1b = exp_g0 + exp_m_1,
      exp_diagonal1 = exp_m_1 < exp_others_1 ? exp_diagonal1b : exp_diagonal1a;
  const float exp_diagonal2a = 1.0f - exp_others_2, exp_diagonal2b = exp_g0 + exp_m_2,
      exp_diagonal2 = exp_m_2 < exp_others_2 ? exp_diagonal2b : exp_diagonal2a;
  const float exp_alpha_v_0 = KSL_MULF(screw_3, exp_g1), exp_alpha_v_1 = KSL_MULF(screw_4, exp_g1),
      exp_alpha_v_2 = KSL_MULF(screw_5, exp_g1);
  const float exp_across_axis_0 = exp_turned_0 + exp_along_0,
      exp_across_axis_1 = exp_turned_1 + exp_along_1,
      exp_across_axis_2 = exp_turned_2 + exp_along_2;
  const float step_1 = exp_m_3 - exp_alpha_v_2, step_2 = exp_m_4 + exp_alpha_v_1,
      step_3 = KSL_MULF(screw_0, exp_g1) + exp_across_axis_0, step_4 = exp_m_3 + exp_alpha_v_2,
      step_6 = exp_m_5 - exp_alpha_v_0, step_7 = KSL_MULF(screw_1, exp_g1) + exp_across_axis_1,
      step_8 = exp_m_4 - exp_alpha_v_1, step_9 = exp_m_5 + exp_alpha_v_0,
      step_11 = KSL_MULF(screw_2, exp_g1) + exp_across_axis_2;
  const float Do_00 = KSL_MULF(D1->m00, exp_diagonal0)
          + (KSL_MULF(D1->m01, step_4) + KSL_MULF(D1->m02, step_8)),
      Do_01 = KSL_MULF(D1->m00, step_1) + KSL_MULF(D1->m02, step_9)
          + KSL_MULF(D1->m01, exp_diagonal1),
      Do_02 = KSL_MULF(D1->m00, step_2) + KSL_MULF(D1->m01, step_6)
          + KSL_MULF(D1->m02, exp_diagonal2),
      Do_03 = KSL_MULF(D1->m00, step_3) + KSL_MULF(D1->m01, step_7) + KSL_MULF(D1->m02, step_11)
          + D1->m03,
      Do_10 = KSL_MULF(D1->m10, exp_diagonal0)
          + (KSL_MULF(D1->m11, step_4) + KSL_MULF(D1->m12, step_8)),
      Do_11 = KSL_MULF(D1->m10, step_1) + KSL_MULF(D1->m12, step_9)
          + KSL_MULF(D1->m11, exp_diagonal1),
      Do_12 = KSL_MULF(D1->m10, step_2) + KSL_MULF(D1->m11, step_6)
          + KSL_MULF(D1->m12, exp_diagonal2),
      Do_13 = KSL_MULF(D1->m10, step_3) + KSL_MULF(D1->m11, step_7) + KSL_MULF(D1->m12, step_11)
          + D1->m13,
      Do_20 = KSL_MULF(D1->m20, exp_diagonal0)
          + (KSL_MULF(D1->m21, step_4) + KSL_MULF(D1->m22, step_8)),
      Do_21 = KSL_MULF(D1->m20, step_1) + KSL_MULF(D1->m22, step_9)
          + KSL_MULF(D1->m21, exp_diagonal1),
      Do_22 = KSL_MULF(D1->m20, step_2) + KSL_MULF(D1->m21, step_6)
          + KSL_MULF(D1->m22, exp_diagonal2),
      Do_23 = KSL_MULF(D1->m20, step_3) + KSL_MULF(D1->m21, step_7) + KSL_MULF(D1->m22, step_11)
          + D1->m23;
  Do->m00 = Do_00;
  Do->m01 = Do_01;
  Do->m02 = Do_02;
  Do->m03 = Do_03;
  Do->m10 = Do_10;
  Do->m11 = Do_11;
  Do->m12 = Do_12;
  Do->m13 = Do_13;
  Do->m20 = Do_20;
  Do->m21 = Do_21;
  Do->m22 = Do_22;
  Do->m23 = Do_23;
}

#endif
