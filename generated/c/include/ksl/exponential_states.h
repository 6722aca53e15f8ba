/* Made by `coscrew generate`; changes are overwritten. */
/* SPDX-License-Identifier: MIT */
/* coscrew 0.2.0.  Copyright (c) 2026 The coscrew authors. */
/* Exponentials and logarithms of rotations and displacements, their Jacobians, interpolation.  On vectors.
   An argument is its components, in the order of structs, each a vector with that of several
   elements: KSL_LANES of them, in single precision KSL_LANESF. */
#ifndef KSL_EXPONENTIAL_STATES_H
#define KSL_EXPONENTIAL_STATES_H

#include "ksl_states.h"

#if KSL_LANE_BYTES
static KSL_INLINE void ksl_SO3_exp_states(const ksl_states *v, ksl_states *R) {
  const ksl_states sizes_a = ksl_abs_lanes(v[0]) + ksl_abs_lanes(v[1]),
      sizes = sizes_a + ksl_abs_lanes(v[2]);
  const ksl_states grid = KSL_RN_LANES(sizes * 268435456.0);
  const ksl_states high_1 = v[0] + grid - grid;
  const ksl_states high_2 = v[1] + grid - grid;
  const ksl_states high_3 = v[2] + grid - grid;
  const ksl_states squares_a = KSL_RN_LANES(high_1 * high_1), squares_b = KSL_RN_LANES(high_2 *
      high_2),
      squares_c = squares_a + squares_b, squares_d = KSL_RN_LANES(high_3 * high_3),
      squares = squares_c + squares_d;
  const ksl_states cross_a = KSL_RN_LANES((v[0] - high_1) * (v[0] + high_1)),
      cross_b = KSL_RN_LANES((v[1] - high_2) * (v[1] + high_2)), cross_c = cross_a + cross_b,
      cross_d = KSL_RN_LANES((v[2] - high_3) * (v[2] + high_3)), cross = cross_c + cross_d;
  const ksl_states x = squares + cross;
  const ksl_states theta_a = ksl_sqrt_lanes(x);
  const ksl_tests theta_b = ksl_less_lanes(x, ksl_each_lanes(1.0));
  const ksl_states theta = ksl_choice_lanes(theta_b, ksl_each_lanes(1.0), theta_a);
  const ksl_states theta_shifted = grid + theta;
  const ksl_states theta_high = theta_shifted - grid;
  const ksl_states theta_low = theta - theta_high;
  const ksl_states theta_sum = theta + theta_high;
  const ksl_states cross_rest_a = KSL_RN_LANES(theta_low * theta_sum), cross_rest = cross -
      cross_rest_a;
  const ksl_states exact_a = KSL_RN_LANES(theta_high * theta_high), exact = squares - exact_a;
  const ksl_states residual = cross_rest + exact;
  const ksl_states small_a = 0.5 * residual, small = small_a / theta;
  const ksl_states delta_a = ksl_abs_lanes(small);
  const ksl_tests delta_b = ksl_less_lanes(delta_a, ksl_each_lanes(0.0078125));
  const ksl_states delta = ksl_choice_lanes(delta_b, small, ksl_each_lanes(0.0));
  ksl_states far_cosine_a; const ksl_states far_sine_a = ksl_sincos_lanes(theta, &far_cosine_a);
  const ksl_states far_sine = ksl_choice_lanes(theta_b, ksl_each_lanes(1.0), far_sine_a);
  const ksl_states far_cosine = ksl_choice_lanes(theta_b, ksl_each_lanes(0.0), far_cosine_a);
  const ksl_states sine_a = KSL_RN_LANES(delta * far_cosine), sine = sine_a + far_sine;
  const ksl_states cosine_a = KSL_RN_LANES(delta * far_sine), cosine = far_cosine - cosine_a;
  const ksl_states far_x = ksl_choice_lanes(theta_b, ksl_each_lanes(1.0), x);
  const ksl_states closed1 = sine / theta;
  const ksl_states versine = 1.0 - cosine;
  const ksl_states closed2 = versine / far_x;
  const ksl_states g1a = KSL_RN_LANES(6.446950284384474e-26 * x), g1b = g1a - 3.868170170630684e-23,
      g1c = KSL_RN_LANES(x * g1b), g1d = g1c + 1.9572941063391263e-20, g1e = KSL_RN_LANES(x * g1d),
      g1f = g1e - 8.22063524662433e-18, g1g = KSL_RN_LANES(x * g1f), g1h = g1g +
          2.8114572543455206e-15,
      g1i = KSL_RN_LANES(x * g1h), g1j = g1i - 7.647163731819816e-13, g1k = KSL_RN_LANES(x * g1j),
      g1l = g1k + 1.6059043836821613e-10, g1m = KSL_RN_LANES(x * g1l), g1n = g1m -
          2.505210838544172e-08,
      g1o = KSL_RN_LANES(x * g1n), g1p = g1o + 2.7557319223985893e-06, g1q = KSL_RN_LANES(x * g1p),
      g1r = g1q - 0.0001984126984126984, g1s = KSL_RN_LANES(x * g1r), g1t = g1s +
          0.008333333333333333,
      g1u = KSL_RN_LANES(x * g1t), g1v = g1u - 0.16666666666666666, g1w = KSL_RN_LANES(x * g1v), g1x
          = g1w + 1.0,
      g1 = ksl_choice_lanes(theta_b, g1x, closed1);
  const ksl_states g2a = KSL_RN_LANES(2.4795962632247976e-27 * x), g2b = g2a -
      1.6117375710961184e-24,
      g2c = KSL_RN_LANES(x * g2b), g2d = g2c + 8.896791392450574e-22, g2e = KSL_RN_LANES(x * g2d),
      g2f = g2e - 4.110317623312165e-19, g2g = KSL_RN_LANES(x * g2f), g2h = g2g +
          1.5619206968586225e-16,
      g2i = KSL_RN_LANES(x * g2h), g2j = g2i - 4.779477332387385e-14, g2k = KSL_RN_LANES(x * g2j),
      g2l = g2k + 1.1470745597729725e-11, g2m = KSL_RN_LANES(x * g2l), g2n = g2m -
          2.08767569878681e-09,
      g2o = KSL_RN_LANES(x * g2n), g2p = g2o + 2.755731922398589e-07, g2q = KSL_RN_LANES(x * g2p),
      g2r = g2q - 2.48015873015873e-05, g2s = KSL_RN_LANES(x * g2r), g2t = g2s +
          0.001388888888888889,
      g2u = KSL_RN_LANES(x * g2t), g2v = g2u - 0.041666666666666664, g2w = KSL_RN_LANES(x * g2v),
          g2x = g2w + 0.5,
      g2 = ksl_choice_lanes(theta_b, g2x, closed2);
  const ksl_states g0a = KSL_RN_LANES(x * g2), g0b = 1.0 - g0a, g0 = ksl_choice_lanes(theta_b, g0b,
      cosine);
  const ksl_states beta_v_1 = v[0] * g2;
  const ksl_states beta_v_2 = v[1] * g2;
  const ksl_states m_1 = KSL_RN_LANES(v[0] * beta_v_1);
  const ksl_states m_2 = KSL_RN_LANES(v[1] * beta_v_2);
  const ksl_states m_3 = KSL_RN_LANES(v[2] * (v[2] * g2));
  const ksl_states m_4 = KSL_RN_LANES(v[1] * beta_v_1);
  const ksl_states m_5 = KSL_RN_LANES(v[2] * beta_v_1);
  const ksl_states m_6 = KSL_RN_LANES(v[2] * beta_v_2);
  const ksl_states others_1 = m_2 + m_3;
  const ksl_states others_2 = m_1 + m_3;
  const ksl_states others_3 = m_1 + m_2;
  const ksl_states diagonal0a = 1.0 - others_1, diagonal0b = g0 + m_1;
  const ksl_tests diagonal0c = ksl_less_lanes(m_1, others_1);
  const ksl_states diagonal0 = ksl_choice_lanes(diagonal0c, diagonal0b, diagonal0a);
  const ksl_states diagonal1a = 1.0 - others_2, diagonal1b = g0 + m_2;
  const ksl_tests diagonal1c = ksl_less_lanes(m_2, others_2);
  const ksl_states diagonal1 = ksl_choice_lanes(diagonal1c, diagonal1b, diagonal1a);
  const ksl_states diagonal2a = 1.0 - others_3, diagonal2b = g0 + m_3;
  const ksl_tests diagonal2c = ksl_less_lanes(m_3, others_3);
  const ksl_states diagonal2 = ksl_choice_lanes(diagonal2c, diagonal2b, diagonal2a);
  const ksl_states alpha_v_1 = KSL_RN_LANES(v[0] * g1);
  const ksl_states alpha_v_2 = KSL_RN_LANES(v[1] * g1);
  const ksl_states alpha_v_3 = KSL_RN_LANES(v[2] * g1);
  const ksl_states R_1 = m_4 - alpha_v_3;
  const ksl_states R_2 = m_5 + alpha_v_2;
  const ksl_states R_3 = m_4 + alpha_v_3;
  const ksl_states R_4 = m_6 - alpha_v_1;
  const ksl_states R_5 = m_5 - alpha_v_2;
  const ksl_states R_6 = m_6 + alpha_v_1;
  R[0] = diagonal0;
  R[3] = R_1;
  R[6] = R_2;
  R[1] = R_3;
  R[4] = diagonal1;
  R[7] = R_4;
  R[2] = R_5;
  R[5] = R_6;
  R[8] = diagonal2;
}

static KSL_INLINE void ksl_SO3_log_states(const ksl_states *R, ksl_states *vo) {
  const ksl_states p_1 = R[5] - R[7];
  const ksl_states p_2 = R[6] - R[2];
  const ksl_states p_3 = R[1] - R[3];
  const ksl_states s_1 = R[7] + R[5];
  const ksl_states s_2 = R[6] + R[2];
  const ksl_states s_3 = R[3] + R[1];
  const ksl_states first_1 = R[0] + 1.0;
  const ksl_states first_2 = 1.0 - R[0];
  const ksl_states others_1 = R[4] + R[8];
  const ksl_states others_2 = R[4] - R[8];
  const ksl_tests low_0a = ksl_less_lanes(R[4], R[0]);
  const ksl_states high_0a = -R[4];
  const ksl_tests high_0b = ksl_less_lanes(R[0], high_0a);
  const ksl_tests column_0a = ksl_less_lanes(R[8], ksl_each_lanes(0.0));
  const ksl_states column_1 = ksl_choice_lanes(column_0a, ksl_choice_lanes(low_0a, first_1
          - others_1, s_3), ksl_choice_lanes(high_0b, s_2, p_1));
  const ksl_states column_2 = ksl_choice_lanes(column_0a, ksl_choice_lanes(low_0a, s_3, first_2
          + others_2), ksl_choice_lanes(high_0b, s_1, p_2));
  const ksl_states column_3 = ksl_choice_lanes(column_0a, ksl_choice_lanes(low_0a, s_2, s_1),
      ksl_choice_lanes(high_0b, first_2 - others_2, p_3));
  const ksl_states column_4 = ksl_choice_lanes(column_0a, ksl_choice_lanes(low_0a, p_1, p_2),
      ksl_choice_lanes(high_0b, p_3, first_1 + others_1));
  const ksl_states upper_0a = -column_1;
  const ksl_tests upper_0b = ksl_less_lanes(column_4, ksl_each_lanes(0.0));
  const ksl_states upper_1 = ksl_choice_lanes(upper_0b, upper_0a, column_1);
  const ksl_states upper_1a = -column_2, upper_2 = ksl_choice_lanes(upper_0b, upper_1a, column_2);
  const ksl_states upper_2a = -column_3, upper_3 = ksl_choice_lanes(upper_0b, upper_2a, column_3);
  const ksl_states upper_3a = -column_4;
  const ksl_states v_s_size_1 = ksl_abs_lanes(upper_1);
  const ksl_states v_s_size_2 = ksl_abs_lanes(upper_2);
  const ksl_states v_s_size_3 = ksl_abs_lanes(upper_3);
  const ksl_tests v_s_largest1a = ksl_less_lanes(v_s_size_1, v_s_size_2);
  const ksl_states v_s_largest1 = ksl_choice_lanes(v_s_largest1a, v_s_size_2, v_s_size_1);
  const ksl_tests v_s_largest2a = ksl_less_lanes(v_s_largest1, v_s_size_3);
  const ksl_states v_s_largest2 = ksl_choice_lanes(v_s_largest2a, v_s_size_3, v_s_largest1);
  const ksl_tests v_s_a = ksl_less_lanes(ksl_each_lanes(6.703903964971299e+153), v_s_largest2);
  const ksl_states v_s_b = ksl_choice_lanes(v_s_a, ksl_each_lanes(3.7291703656001034e-155),
      ksl_each_lanes(1.0));
  const ksl_tests v_s_c = ksl_less_lanes(v_s_largest2, ksl_each_lanes(256.0));
  const ksl_states v_s_d = ksl_choice_lanes(v_s_c, ksl_each_lanes(1.3093562431584567e+151), v_s_b);
  const ksl_tests v_s_e = ksl_less_lanes(v_s_largest2, ksl_each_lanes(1.955159272639747e-149));
  const ksl_states v_s = ksl_choice_lanes(v_s_e, ksl_each_lanes(1.0715086071862673e+301), v_s_d);
  const ksl_states v_y_1 = upper_1 * v_s;
  const ksl_states v_y_2 = upper_2 * v_s;
  const ksl_states v_y_3 = upper_3 * v_s;
  const ksl_states v_n_a = KSL_RN_LANES(v_y_1 * v_y_1), v_n_b = KSL_RN_LANES(v_y_2 * v_y_2), v_n_c =
      v_n_a + v_n_b,
      v_n_d = KSL_RN_LANES(v_y_3 * v_y_3), v_n_e = v_n_c + v_n_d, v_n = ksl_sqrt_lanes(v_n_e);
  const ksl_tests v_r_a = ksl_less_lanes(v_s, ksl_each_lanes(1.0));
  const ksl_states v_r_b = ksl_choice_lanes(v_r_a, ksl_each_lanes(2.6815615859885194e+154),
      ksl_each_lanes(1.0));
  const ksl_tests v_r_c = ksl_less_lanes(ksl_each_lanes(1.0), v_s);
  const ksl_states v_r_d = ksl_choice_lanes(v_r_c, ksl_each_lanes(7.637340908749012e-152), v_r_b);
  const ksl_tests v_r_e = ksl_less_lanes(ksl_each_lanes(1.3093562431584567e+151), v_s);
  const ksl_states v_r = ksl_choice_lanes(v_r_e, ksl_each_lanes(9.332636185032189e-302), v_r_d);
  const ksl_states n = v_n * v_r;
  const ksl_states half = ksl_atan2_lanes(n, ksl_choice_lanes(upper_0b, upper_3a, column_4));
  const ksl_tests divisor_a = ksl_equal_lanes(n, ksl_each_lanes(0.0));
  const ksl_states divisor = ksl_choice_lanes(divisor_a, ksl_each_lanes(1.0), n);
  const ksl_states theta = 2.0 * half;
  const ksl_states k = theta / divisor;
  const ksl_states vector_1 = KSL_RN_LANES(upper_1 * k);
  const ksl_states vector_2 = KSL_RN_LANES(upper_2 * k);
  const ksl_states vector_3 = KSL_RN_LANES(upper_3 * k);
  vo[0] = vector_1;
  vo[1] = vector_2;
  vo[2] = vector_3;
}

static KSL_INLINE void ksl_SO3_leftJacobian_states(const ksl_states *v, ksl_states *R) {
  const ksl_states sizes_a = ksl_abs_lanes(v[0]) + ksl_abs_lanes(v[1]),
      sizes = sizes_a + ksl_abs_lanes(v[2]);
  const ksl_states grid = KSL_RN_LANES(sizes * 268435456.0);
  const ksl_states high_1 = v[0] + grid - grid;
  const ksl_states high_2 = v[1] + grid - grid;
  const ksl_states high_3 = v[2] + grid - grid;
  const ksl_states squares_a = KSL_RN_LANES(high_1 * high_1), squares_b = KSL_RN_LANES(high_2 *
      high_2),
      squares_c = squares_a + squares_b, squares_d = KSL_RN_LANES(high_3 * high_3),
      squares = squares_c + squares_d;
  const ksl_states cross_a = KSL_RN_LANES((v[0] - high_1) * (v[0] + high_1)),
      cross_b = KSL_RN_LANES((v[1] - high_2) * (v[1] + high_2)), cross_c = cross_a + cross_b,
      cross_d = KSL_RN_LANES((v[2] - high_3) * (v[2] + high_3)), cross = cross_c + cross_d;
  const ksl_states x = squares + cross;
  const ksl_states theta_a = ksl_sqrt_lanes(x);
  const ksl_tests theta_b = ksl_less_lanes(x, ksl_each_lanes(1.0));
  const ksl_states theta = ksl_choice_lanes(theta_b, ksl_each_lanes(1.0), theta_a);
  const ksl_states theta_shifted = grid + theta;
  const ksl_states theta_high = theta_shifted - grid;
  const ksl_states theta_low = theta - theta_high;
  const ksl_states theta_sum = theta + theta_high;
  const ksl_states cross_rest_a = KSL_RN_LANES(theta_low * theta_sum), cross_rest = cross -
      cross_rest_a;
  const ksl_states exact_a = KSL_RN_LANES(theta_high * theta_high), exact = squares - exact_a;
  const ksl_states residual = cross_rest + exact;
  const ksl_states small_a = 0.5 * residual, small = small_a / theta;
  const ksl_states delta_a = ksl_abs_lanes(small);
  const ksl_tests delta_b = ksl_less_lanes(delta_a, ksl_each_lanes(0.0078125));
  const ksl_states delta = ksl_choice_lanes(delta_b, small, ksl_each_lanes(0.0));
  ksl_states far_cosine_a; const ksl_states far_sine_a = ksl_sincos_lanes(theta, &far_cosine_a);
  const ksl_states far_sine = ksl_choice_lanes(theta_b, ksl_each_lanes(1.0), far_sine_a);
  const ksl_states far_cosine = ksl_choice_lanes(theta_b, ksl_each_lanes(0.0), far_cosine_a);
  const ksl_states sine_a = KSL_RN_LANES(delta * far_cosine), sine = sine_a + far_sine;
  const ksl_states cosine_a = KSL_RN_LANES(delta * far_sine), cosine = far_cosine - cosine_a;
  const ksl_states far_x = ksl_choice_lanes(theta_b, ksl_each_lanes(1.0), x);
  const ksl_tests middle_x_a = ksl_less_lanes(x, ksl_each_lanes(4.0));
  const ksl_states middle_x = ksl_choice_lanes(middle_x_a, ksl_each_lanes(4.0), x);
  const ksl_states closed1 = sine / theta;
  const ksl_states versine = 1.0 - cosine;
  const ksl_states closed2 = versine / far_x;
  const ksl_states rest3 = 1.0 - closed1;
  const ksl_states closed3 = rest3 / middle_x;
  const ksl_states g1a = KSL_RN_LANES(6.446950284384474e-26 * x), g1b = g1a - 3.868170170630684e-23,
      g1c = KSL_RN_LANES(x * g1b), g1d = g1c + 1.9572941063391263e-20, g1e = KSL_RN_LANES(x * g1d),
      g1f = g1e - 8.22063524662433e-18, g1g = KSL_RN_LANES(x * g1f), g1h = g1g +
          2.8114572543455206e-15,
      g1i = KSL_RN_LANES(x * g1h), g1j = g1i - 7.647163731819816e-13, g1k = KSL_RN_LANES(x * g1j),
      g1l = g1k + 1.6059043836821613e-10, g1m = KSL_RN_LANES(x * g1l), g1n = g1m -
          2.505210838544172e-08,
      g1o = KSL_RN_LANES(x * g1n), g1p = g1o + 2.7557319223985893e-06, g1q = KSL_RN_LANES(x * g1p),
      g1r = g1q - 0.0001984126984126984, g1s = KSL_RN_LANES(x * g1r), g1t = g1s +
          0.008333333333333333,
      g1u = KSL_RN_LANES(x * g1t), g1v = g1u - 0.16666666666666666, g1w = KSL_RN_LANES(x * g1v), g1x
          = g1w + 1.0,
      g1 = ksl_choice_lanes(theta_b, g1x, closed1);
  const ksl_states g2a = KSL_RN_LANES(2.4795962632247976e-27 * x), g2b = g2a -
      1.6117375710961184e-24,
      g2c = KSL_RN_LANES(x * g2b), g2d = g2c + 8.896791392450574e-22, g2e = KSL_RN_LANES(x * g2d),
      g2f = g2e - 4.110317623312165e-19, g2g = KSL_RN_LANES(x * g2f), g2h = g2g +
          1.5619206968586225e-16,
      g2i = KSL_RN_LANES(x * g2h), g2j = g2i - 4.779477332387385e-14, g2k = KSL_RN_LANES(x * g2j),
      g2l = g2k + 1.1470745597729725e-11, g2m = KSL_RN_LANES(x * g2l), g2n = g2m -
          2.08767569878681e-09,
      g2o = KSL_RN_LANES(x * g2n), g2p = g2o + 2.755731922398589e-07, g2q = KSL_RN_LANES(x * g2p),
      g2r = g2q - 2.48015873015873e-05, g2s = KSL_RN_LANES(x * g2r), g2t = g2s +
          0.001388888888888889,
      g2u = KSL_RN_LANES(x * g2t), g2v = g2u - 0.041666666666666664, g2w = KSL_RN_LANES(x * g2v),
          g2x = g2w + 0.5,
      g2 = ksl_choice_lanes(theta_b, g2x, closed2);
  const ksl_states g3a = KSL_RN_LANES(9.183689863795546e-29 * x), g3b = g3a - 6.446950284384474e-26,
      g3c = KSL_RN_LANES(x * g3b), g3d = g3c + 3.868170170630684e-23, g3e = KSL_RN_LANES(x * g3d),
      g3f = g3e - 1.9572941063391263e-20, g3g = KSL_RN_LANES(x * g3f), g3h = g3g +
          8.22063524662433e-18,
      g3i = KSL_RN_LANES(x * g3h), g3j = g3i - 2.8114572543455206e-15, g3k = KSL_RN_LANES(x * g3j),
      g3l = g3k + 7.647163731819816e-13, g3m = KSL_RN_LANES(x * g3l), g3n = g3m -
          1.6059043836821613e-10,
      g3o = KSL_RN_LANES(x * g3n), g3p = g3o + 2.505210838544172e-08, g3q = KSL_RN_LANES(x * g3p),
      g3r = g3q - 2.7557319223985893e-06, g3s = KSL_RN_LANES(x * g3r), g3t = g3s +
          0.0001984126984126984,
      g3u = KSL_RN_LANES(x * g3t), g3v = g3u - 0.008333333333333333, g3w = KSL_RN_LANES(x * g3v),
      g3x = g3w + 0.16666666666666666, g3 = ksl_choice_lanes(middle_x_a, g3x, closed3);
  const ksl_states beta_v_1 = v[0] * g3;
  const ksl_states beta_v_2 = v[1] * g3;
  const ksl_states m_1 = KSL_RN_LANES(v[0] * beta_v_1);
  const ksl_states m_2 = KSL_RN_LANES(v[1] * beta_v_2);
  const ksl_states m_3 = KSL_RN_LANES(v[2] * (v[2] * g3));
  const ksl_states m_4 = KSL_RN_LANES(v[1] * beta_v_1);
  const ksl_states m_5 = KSL_RN_LANES(v[2] * beta_v_1);
  const ksl_states m_6 = KSL_RN_LANES(v[2] * beta_v_2);
  const ksl_states others_1 = m_2 + m_3;
  const ksl_states others_2 = m_1 + m_3;
  const ksl_states others_3 = m_1 + m_2;
  const ksl_states diagonal0a = 1.0 - others_1, diagonal0b = g1 + m_1;
  const ksl_tests diagonal0c = ksl_less_lanes(m_1, others_1);
  const ksl_states diagonal0 = ksl_choice_lanes(diagonal0c, diagonal0b, diagonal0a);
  const ksl_states diagonal1a = 1.0 - others_2, diagonal1b = g1 + m_2;
  const ksl_tests diagonal1c = ksl_less_lanes(m_2, others_2);
  const ksl_states diagonal1 = ksl_choice_lanes(diagonal1c, diagonal1b, diagonal1a);
  const ksl_states diagonal2a = 1.0 - others_3, diagonal2b = g1 + m_3;
  const ksl_tests diagonal2c = ksl_less_lanes(m_3, others_3);
  const ksl_states diagonal2 = ksl_choice_lanes(diagonal2c, diagonal2b, diagonal2a);
  const ksl_states alpha_v_1 = KSL_RN_LANES(v[0] * g2);
  const ksl_states alpha_v_2 = KSL_RN_LANES(v[1] * g2);
  const ksl_states alpha_v_3 = KSL_RN_LANES(v[2] * g2);
  const ksl_states R_1 = m_4 - alpha_v_3;
  const ksl_states R_2 = m_5 + alpha_v_2;
  const ksl_states R_3 = m_4 + alpha_v_3;
  const ksl_states R_4 = m_6 - alpha_v_1;
  const ksl_states R_5 = m_5 - alpha_v_2;
  const ksl_states R_6 = m_6 + alpha_v_1;
  R[0] = diagonal0;
  R[3] = R_1;
  R[6] = R_2;
  R[1] = R_3;
  R[4] = diagonal1;
  R[7] = R_4;
  R[2] = R_5;
  R[5] = R_6;
  R[8] = diagonal2;
}

static KSL_INLINE void ksl_SO3_rightJacobian_states(const ksl_states *v, ksl_states *R) {
  const ksl_states sizes_a = ksl_abs_lanes(v[0]) + ksl_abs_lanes(v[1]),
      sizes = sizes_a + ksl_abs_lanes(v[2]);
  const ksl_states grid = KSL_RN_LANES(sizes * 268435456.0);
  const ksl_states high_1 = v[0] + grid - grid;
  const ksl_states high_2 = v[1] + grid - grid;
  const ksl_states high_3 = v[2] + grid - grid;
  const ksl_states squares_a = KSL_RN_LANES(high_1 * high_1), squares_b = KSL_RN_LANES(high_2 *
      high_2),
      squares_c = squares_a + squares_b, squares_d = KSL_RN_LANES(high_3 * high_3),
      squares = squares_c + squares_d;
  const ksl_states cross_a = KSL_RN_LANES((v[0] - high_1) * (v[0] + high_1)),
      cross_b = KSL_RN_LANES((v[1] - high_2) * (v[1] + high_2)), cross_c = cross_a + cross_b,
      cross_d = KSL_RN_LANES((v[2] - high_3) * (v[2] + high_3)), cross = cross_c + cross_d;
  const ksl_states x = squares + cross;
  const ksl_states theta_a = ksl_sqrt_lanes(x);
  const ksl_tests theta_b = ksl_less_lanes(x, ksl_each_lanes(1.0));
  const ksl_states theta = ksl_choice_lanes(theta_b, ksl_each_lanes(1.0), theta_a);
  const ksl_states theta_shifted = grid + theta;
  const ksl_states theta_high = theta_shifted - grid;
  const ksl_states theta_low = theta - theta_high;
  const ksl_states theta_sum = theta + theta_high;
  const ksl_states cross_rest_a = KSL_RN_LANES(theta_low * theta_sum), cross_rest = cross -
      cross_rest_a;
  const ksl_states exact_a = KSL_RN_LANES(theta_high * theta_high), exact = squares - exact_a;
  const ksl_states residual = cross_rest + exact;
  const ksl_states small_a = 0.5 * residual, small = small_a / theta;
  const ksl_states delta_a = ksl_abs_lanes(small);
  const ksl_tests delta_b = ksl_less_lanes(delta_a, ksl_each_lanes(0.0078125));
  const ksl_states delta = ksl_choice_lanes(delta_b, small, ksl_each_lanes(0.0));
  ksl_states far_cosine_a; const ksl_states far_sine_a = ksl_sincos_lanes(theta, &far_cosine_a);
  const ksl_states far_sine = ksl_choice_lanes(theta_b, ksl_each_lanes(1.0), far_sine_a);
  const ksl_states far_cosine = ksl_choice_lanes(theta_b, ksl_each_lanes(0.0), far_cosine_a);
  const ksl_states sine_a = KSL_RN_LANES(delta * far_cosine), sine = sine_a + far_sine;
  const ksl_states cosine_a = KSL_RN_LANES(delta * far_sine), cosine = far_cosine - cosine_a;
  const ksl_states far_x = ksl_choice_lanes(theta_b, ksl_each_lanes(1.0), x);
  const ksl_tests middle_x_a = ksl_less_lanes(x, ksl_each_lanes(4.0));
  const ksl_states middle_x = ksl_choice_lanes(middle_x_a, ksl_each_lanes(4.0), x);
  const ksl_states closed1 = sine / theta;
  const ksl_states versine = 1.0 - cosine;
  const ksl_states closed2 = versine / far_x;
  const ksl_states rest3 = 1.0 - closed1;
  const ksl_states closed3 = rest3 / middle_x;
  const ksl_states g1a = KSL_RN_LANES(6.446950284384474e-26 * x), g1b = g1a - 3.868170170630684e-23,
      g1c = KSL_RN_LANES(x * g1b), g1d = g1c + 1.9572941063391263e-20, g1e = KSL_RN_LANES(x * g1d),
      g1f = g1e - 8.22063524662433e-18, g1g = KSL_RN_LANES(x * g1f), g1h = g1g +
          2.8114572543455206e-15,
      g1i = KSL_RN_LANES(x * g1h), g1j = g1i - 7.647163731819816e-13, g1k = KSL_RN_LANES(x * g1j),
      g1l = g1k + 1.6059043836821613e-10, g1m = KSL_RN_LANES(x * g1l), g1n = g1m -
          2.505210838544172e-08,
      g1o = KSL_RN_LANES(x * g1n), g1p = g1o + 2.7557319223985893e-06, g1q = KSL_RN_LANES(x * g1p),
      g1r = g1q - 0.0001984126984126984, g1s = KSL_RN_LANES(x * g1r), g1t = g1s +
          0.008333333333333333,
      g1u = KSL_RN_LANES(x * g1t), g1v = g1u - 0.16666666666666666, g1w = KSL_RN_LANES(x * g1v), g1x
          = g1w + 1.0,
      g1 = ksl_choice_lanes(theta_b, g1x, closed1);
  const ksl_states g2a = KSL_RN_LANES(2.4795962632247976e-27 * x), g2b = g2a -
      1.6117375710961184e-24,
      g2c = KSL_RN_LANES(x * g2b), g2d = g2c + 8.896791392450574e-22, g2e = KSL_RN_LANES(x * g2d),
      g2f = g2e - 4.110317623312165e-19, g2g = KSL_RN_LANES(x * g2f), g2h = g2g +
          1.5619206968586225e-16,
      g2i = KSL_RN_LANES(x * g2h), g2j = g2i - 4.779477332387385e-14, g2k = KSL_RN_LANES(x * g2j),
      g2l = g2k + 1.1470745597729725e-11, g2m = KSL_RN_LANES(x * g2l), g2n = g2m -
          2.08767569878681e-09,
      g2o = KSL_RN_LANES(x * g2n), g2p = g2o + 2.755731922398589e-07, g2q = KSL_RN_LANES(x * g2p),
      g2r = g2q - 2.48015873015873e-05, g2s = KSL_RN_LANES(x * g2r), g2t = g2s +
          0.001388888888888889,
      g2u = KSL_RN_LANES(x * g2t), g2v = g2u - 0.041666666666666664, g2w = KSL_RN_LANES(x * g2v),
          g2x = g2w + 0.5,
      g2 = ksl_choice_lanes(theta_b, g2x, closed2);
  const ksl_states g3a = KSL_RN_LANES(9.183689863795546e-29 * x), g3b = g3a - 6.446950284384474e-26,
      g3c = KSL_RN_LANES(x * g3b), g3d = g3c + 3.868170170630684e-23, g3e = KSL_RN_LANES(x * g3d),
      g3f = g3e - 1.9572941063391263e-20, g3g = KSL_RN_LANES(x * g3f), g3h = g3g +
          8.22063524662433e-18,
      g3i = KSL_RN_LANES(x * g3h), g3j = g3i - 2.8114572543455206e-15, g3k = KSL_RN_LANES(x * g3j),
      g3l = g3k + 7.647163731819816e-13, g3m = KSL_RN_LANES(x * g3l), g3n = g3m -
          1.6059043836821613e-10,
      g3o = KSL_RN_LANES(x * g3n), g3p = g3o + 2.505210838544172e-08, g3q = KSL_RN_LANES(x * g3p),
      g3r = g3q - 2.7557319223985893e-06, g3s = KSL_RN_LANES(x * g3r), g3t = g3s +
          0.0001984126984126984,
      g3u = KSL_RN_LANES(x * g3t), g3v = g3u - 0.008333333333333333, g3w = KSL_RN_LANES(x * g3v),
      g3x = g3w + 0.16666666666666666, g3 = ksl_choice_lanes(middle_x_a, g3x, closed3);
  const ksl_states beta_v_1 = v[0] * g3;
  const ksl_states beta_v_2 = v[1] * g3;
  const ksl_states m_1 = KSL_RN_LANES(v[0] * beta_v_1);
  const ksl_states m_2 = KSL_RN_LANES(v[1] * beta_v_2);
  const ksl_states m_3 = KSL_RN_LANES(v[2] * (v[2] * g3));
  const ksl_states m_4 = KSL_RN_LANES(v[1] * beta_v_1);
  const ksl_states m_5 = KSL_RN_LANES(v[2] * beta_v_1);
  const ksl_states m_6 = KSL_RN_LANES(v[2] * beta_v_2);
  const ksl_states others_1 = m_2 + m_3;
  const ksl_states others_2 = m_1 + m_3;
  const ksl_states others_3 = m_1 + m_2;
  const ksl_states diagonal0a = 1.0 - others_1, diagonal0b = g1 + m_1;
  const ksl_tests diagonal0c = ksl_less_lanes(m_1, others_1);
  const ksl_states diagonal0 = ksl_choice_lanes(diagonal0c, diagonal0b, diagonal0a);
  const ksl_states diagonal1a = 1.0 - others_2, diagonal1b = g1 + m_2;
  const ksl_tests diagonal1c = ksl_less_lanes(m_2, others_2);
  const ksl_states diagonal1 = ksl_choice_lanes(diagonal1c, diagonal1b, diagonal1a);
  const ksl_states diagonal2a = 1.0 - others_3, diagonal2b = g1 + m_3;
  const ksl_tests diagonal2c = ksl_less_lanes(m_3, others_3);
  const ksl_states diagonal2 = ksl_choice_lanes(diagonal2c, diagonal2b, diagonal2a);
  const ksl_states alpha_v_0a = KSL_RN_LANES(v[0] * g2), alpha_v_1 = -alpha_v_0a;
  const ksl_states alpha_v_1a = KSL_RN_LANES(v[1] * g2), alpha_v_2 = -alpha_v_1a;
  const ksl_states alpha_v_2a = KSL_RN_LANES(v[2] * g2), alpha_v_3 = -alpha_v_2a;
  const ksl_states R_1 = m_4 - alpha_v_3;
  const ksl_states R_2 = m_5 + alpha_v_2;
  const ksl_states R_3 = m_4 + alpha_v_3;
  const ksl_states R_4 = m_6 - alpha_v_1;
  const ksl_states R_5 = m_5 - alpha_v_2;
  const ksl_states R_6 = m_6 + alpha_v_1;
  R[0] = diagonal0;
  R[3] = R_1;
  R[6] = R_2;
  R[1] = R_3;
  R[4] = diagonal1;
  R[7] = R_4;
  R[2] = R_5;
  R[5] = R_6;
  R[8] = diagonal2;
}

static KSL_INLINE void ksl_SO3_leftJacobianInverse_states(const ksl_states *v, ksl_states *R) {
  const ksl_states sizes_a = ksl_abs_lanes(v[0]) + ksl_abs_lanes(v[1]),
      sizes = sizes_a + ksl_abs_lanes(v[2]);
  const ksl_states grid = KSL_RN_LANES(sizes * 268435456.0);
  const ksl_states high_1 = v[0] + grid - grid;
  const ksl_states high_2 = v[1] + grid - grid;
  const ksl_states high_3 = v[2] + grid - grid;
  const ksl_states squares_a = KSL_RN_LANES(high_1 * high_1), squares_b = KSL_RN_LANES(high_2 *
      high_2),
      squares_c = squares_a + squares_b, squares_d = KSL_RN_LANES(high_3 * high_3),
      squares = squares_c + squares_d;
  const ksl_states cross_a = KSL_RN_LANES((v[0] - high_1) * (v[0] + high_1)),
      cross_b = KSL_RN_LANES((v[1] - high_2) * (v[1] + high_2)), cross_c = cross_a + cross_b,
      cross_d = KSL_RN_LANES((v[2] - high_3) * (v[2] + high_3)), cross = cross_c + cross_d;
  const ksl_states x = squares + cross;
  const ksl_states theta_a = ksl_sqrt_lanes(x);
  const ksl_tests theta_b = ksl_less_lanes(x, ksl_each_lanes(1.0));
  const ksl_states theta = ksl_choice_lanes(theta_b, ksl_each_lanes(1.0), theta_a);
  const ksl_states theta_shifted = grid + theta;
  const ksl_states theta_high = theta_shifted - grid;
  const ksl_states theta_low = theta - theta_high;
  const ksl_states theta_sum = theta + theta_high;
  const ksl_states cross_rest_a = KSL_RN_LANES(theta_low * theta_sum), cross_rest = cross -
      cross_rest_a;
  const ksl_states exact_a = KSL_RN_LANES(theta_high * theta_high), exact = squares - exact_a;
  const ksl_states residual = cross_rest + exact;
  const ksl_states small_a = 0.5 * residual, small = small_a / theta;
  const ksl_states delta_a = ksl_abs_lanes(small);
  const ksl_tests delta_b = ksl_less_lanes(delta_a, ksl_each_lanes(0.0078125));
  const ksl_states delta = ksl_choice_lanes(delta_b, small, ksl_each_lanes(0.0));
  ksl_states far_cosine_a; const ksl_states far_sine_a = ksl_sincos_lanes(theta, &far_cosine_a);
  const ksl_states far_sine = ksl_choice_lanes(theta_b, ksl_each_lanes(1.0), far_sine_a);
  const ksl_states far_cosine = ksl_choice_lanes(theta_b, ksl_each_lanes(0.0), far_cosine_a);
  const ksl_states sine_a = KSL_RN_LANES(delta * far_cosine), sine = sine_a + far_sine;
  const ksl_states cosine_a = KSL_RN_LANES(delta * far_sine), cosine = far_cosine - cosine_a;
  const ksl_states above_a = cosine + 1.0;
  const ksl_tests above_b = ksl_less_lanes(cosine, ksl_each_lanes(0.0));
  const ksl_states above = ksl_choice_lanes(above_b, sine, above_a);
  const ksl_states below_a = 1.0 - cosine, below = ksl_choice_lanes(above_b, below_a, sine);
  const ksl_states cotangent = above / below;
  const ksl_states half_cotangent_a = 0.5 * theta,
      half_cotangent = KSL_RN_LANES(half_cotangent_a * cotangent);
  const ksl_states b_rest = 1.0 - half_cotangent;
  const ksl_tests b_divisor_a = ksl_less_lanes(x, ksl_each_lanes(4.0));
  const ksl_states b_divisor = ksl_choice_lanes(b_divisor_a, ksl_each_lanes(4.0), x);
  const ksl_states closed_b = b_rest / b_divisor;
  const ksl_states b_a = KSL_RN_LANES(1.455172475614865e-27 * x), b_b = b_a + 5.744790668872202e-26,
      b_c = KSL_RN_LANES(x * b_b), b_d = b_c + 2.267952452337683e-24, b_e = KSL_RN_LANES(x * b_d),
      b_f = b_e + 8.953517427037546e-23, b_g = KSL_RN_LANES(x * b_f), b_h = b_g +
          3.534707039629467e-21,
      b_i = KSL_RN_LANES(x * b_h), b_j = b_i + 1.3954464685812522e-19, b_k = KSL_RN_LANES(x * b_j),
      b_l = b_k + 5.5090028283602295e-18, b_m = KSL_RN_LANES(x * b_l), b_n = b_m +
          2.174868698558062e-16,
      b_o = KSL_RN_LANES(x * b_n), b_p = b_o + 8.586062056277845e-15, b_q = KSL_RN_LANES(x * b_p),
      b_r = b_q + 3.3896802963225827e-13, b_s = KSL_RN_LANES(x * b_r), b_t = b_s +
          1.3382536530684679e-11,
      b_u = KSL_RN_LANES(x * b_t), b_v = b_u + 5.284190138687493e-10, b_w = KSL_RN_LANES(x * b_v),
      b_x = b_w + 2.08767569878681e-08, b_y = KSL_RN_LANES(x * b_x), b_z = b_y +
          8.267195767195768e-07,
      b_aa = KSL_RN_LANES(x * b_z), b_ab = b_aa + 3.306878306878307e-05, b_ac = KSL_RN_LANES(x *
          b_ab),
      b_ad = b_ac + 0.001388888888888889, b_ae = KSL_RN_LANES(x * b_ad), b_af = b_ae +
          0.08333333333333333,
      b = ksl_choice_lanes(b_divisor_a, b_af, closed_b);
  const ksl_states b_across_a = KSL_RN_LANES(x * b), b_across_b = 1.0 - b_across_a,
      b_across = ksl_choice_lanes(b_divisor_a, b_across_b, half_cotangent);
  const ksl_states beta_v_1 = v[0] * b;
  const ksl_states beta_v_2 = v[1] * b;
  const ksl_states m_1 = KSL_RN_LANES(v[0] * beta_v_1);
  const ksl_states m_2 = KSL_RN_LANES(v[1] * beta_v_2);
  const ksl_states m_3 = KSL_RN_LANES(v[2] * (v[2] * b));
  const ksl_states m_4 = KSL_RN_LANES(v[1] * beta_v_1);
  const ksl_states m_5 = KSL_RN_LANES(v[2] * beta_v_1);
  const ksl_states m_6 = KSL_RN_LANES(v[2] * beta_v_2);
  const ksl_states others_1 = m_2 + m_3;
  const ksl_states others_2 = m_1 + m_3;
  const ksl_states others_3 = m_1 + m_2;
  const ksl_states diagonal0a = 1.0 - others_1, diagonal0b = b_across + m_1;
  const ksl_tests diagonal0c = ksl_less_lanes(m_1, others_1);
  const ksl_states diagonal0 = ksl_choice_lanes(diagonal0c, diagonal0b, diagonal0a);
  const ksl_states diagonal1a = 1.0 - others_2, diagonal1b = b_across + m_2;
  const ksl_tests diagonal1c = ksl_less_lanes(m_2, others_2);
  const ksl_states diagonal1 = ksl_choice_lanes(diagonal1c, diagonal1b, diagonal1a);
  const ksl_states diagonal2a = 1.0 - others_3, diagonal2b = b_across + m_3;
  const ksl_tests diagonal2c = ksl_less_lanes(m_3, others_3);
  const ksl_states diagonal2 = ksl_choice_lanes(diagonal2c, diagonal2b, diagonal2a);
  const ksl_states alpha_v_0a = KSL_RN_LANES(0.5 * v[0]), alpha_v_1 = -alpha_v_0a;
  const ksl_states alpha_v_1a = KSL_RN_LANES(0.5 * v[1]), alpha_v_2 = -alpha_v_1a;
  const ksl_states alpha_v_2a = KSL_RN_LANES(0.5 * v[2]), alpha_v_3 = -alpha_v_2a;
  const ksl_states R_1 = m_4 - alpha_v_3;
  const ksl_states R_2 = m_5 + alpha_v_2;
  const ksl_states R_3 = m_4 + alpha_v_3;
  const ksl_states R_4 = m_6 - alpha_v_1;
  const ksl_states R_5 = m_5 - alpha_v_2;
  const ksl_states R_6 = m_6 + alpha_v_1;
  R[0] = diagonal0;
  R[3] = R_1;
  R[6] = R_2;
  R[1] = R_3;
  R[4] = diagonal1;
  R[7] = R_4;
  R[2] = R_5;
  R[5] = R_6;
  R[8] = diagonal2;
}

static KSL_INLINE void ksl_SO3_rightJacobianInverse_states(const ksl_states *v, ksl_states *R) {
  const ksl_states sizes_a = ksl_abs_lanes(v[0]) + ksl_abs_lanes(v[1]),
      sizes = sizes_a + ksl_abs_lanes(v[2]);
  const ksl_states grid = KSL_RN_LANES(sizes * 268435456.0);
  const ksl_states high_1 = v[0] + grid - grid;
  const ksl_states high_2 = v[1] + grid - grid;
  const ksl_states high_3 = v[2] + grid - grid;
  const ksl_states squares_a = KSL_RN_LANES(high_1 * high_1), squares_b = KSL_RN_LANES(high_2 *
      high_2),
      squares_c = squares_a + squares_b, squares_d = KSL_RN_LANES(high_3 * high_3),
      squares = squares_c + squares_d;
  const ksl_states cross_a = KSL_RN_LANES((v[0] - high_1) * (v[0] + high_1)),
      cross_b = KSL_RN_LANES((v[1] - high_2) * (v[1] + high_2)), cross_c = cross_a + cross_b,
      cross_d = KSL_RN_LANES((v[2] - high_3) * (v[2] + high_3)), cross = cross_c + cross_d;
  const ksl_states x = squares + cross;
  const ksl_states theta_a = ksl_sqrt_lanes(x);
  const ksl_tests theta_b = ksl_less_lanes(x, ksl_each_lanes(1.0));
  const ksl_states theta = ksl_choice_lanes(theta_b, ksl_each_lanes(1.0), theta_a);
  const ksl_states theta_shifted = grid + theta;
  const ksl_states theta_high = theta_shifted - grid;
  const ksl_states theta_low = theta - theta_high;
  const ksl_states theta_sum = theta + theta_high;
  const ksl_states cross_rest_a = KSL_RN_LANES(theta_low * theta_sum), cross_rest = cross -
      cross_rest_a;
  const ksl_states exact_a = KSL_RN_LANES(theta_high * theta_high), exact = squares - exact_a;
  const ksl_states residual = cross_rest + exact;
  const ksl_states small_a = 0.5 * residual, small = small_a / theta;
  const ksl_states delta_a = ksl_abs_lanes(small);
  const ksl_tests delta_b = ksl_less_lanes(delta_a, ksl_each_lanes(0.0078125));
  const ksl_states delta = ksl_choice_lanes(delta_b, small, ksl_each_lanes(0.0));
  ksl_states far_cosine_a; const ksl_states far_sine_a = ksl_sincos_lanes(theta, &far_cosine_a);
  const ksl_states far_sine = ksl_choice_lanes(theta_b, ksl_each_lanes(1.0), far_sine_a);
  const ksl_states far_cosine = ksl_choice_lanes(theta_b, ksl_each_lanes(0.0), far_cosine_a);
  const ksl_states sine_a = KSL_RN_LANES(delta * far_cosine), sine = sine_a + far_sine;
  const ksl_states cosine_a = KSL_RN_LANES(delta * far_sine), cosine = far_cosine - cosine_a;
  const ksl_states above_a = cosine + 1.0;
  const ksl_tests above_b = ksl_less_lanes(cosine, ksl_each_lanes(0.0));
  const ksl_states above = ksl_choice_lanes(above_b, sine, above_a);
  const ksl_states below_a = 1.0 - cosine, below = ksl_choice_lanes(above_b, below_a, sine);
  const ksl_states cotangent = above / below;
  const ksl_states half_cotangent_a = 0.5 * theta,
      half_cotangent = KSL_RN_LANES(half_cotangent_a * cotangent);
  const ksl_states b_rest = 1.0 - half_cotangent;
  const ksl_tests b_divisor_a = ksl_less_lanes(x, ksl_each_lanes(4.0));
  const ksl_states b_divisor = ksl_choice_lanes(b_divisor_a, ksl_each_lanes(4.0), x);
  const ksl_states closed_b = b_rest / b_divisor;
  const ksl_states b_a = KSL_RN_LANES(1.455172475614865e-27 * x), b_b = b_a + 5.744790668872202e-26,
      b_c = KSL_RN_LANES(x * b_b), b_d = b_c + 2.267952452337683e-24, b_e = KSL_RN_LANES(x * b_d),
      b_f = b_e + 8.953517427037546e-23, b_g = KSL_RN_LANES(x * b_f), b_h = b_g +
          3.534707039629467e-21,
      b_i = KSL_RN_LANES(x * b_h), b_j = b_i + 1.3954464685812522e-19, b_k = KSL_RN_LANES(x * b_j),
      b_l = b_k + 5.5090028283602295e-18, b_m = KSL_RN_LANES(x * b_l), b_n = b_m +
          2.174868698558062e-16,
      b_o = KSL_RN_LANES(x * b_n), b_p = b_o + 8.586062056277845e-15, b_q = KSL_RN_LANES(x * b_p),
      b_r = b_q + 3.3896802963225827e-13, b_s = KSL_RN_LANES(x * b_r), b_t = b_s +
          1.3382536530684679e-11,
      b_u = KSL_RN_LANES(x * b_t), b_v = b_u + 5.284190138687493e-10, b_w = KSL_RN_LANES(x * b_v),
      b_x = b_w + 2.08767569878681e-08, b_y = KSL_RN_LANES(x * b_x), b_z = b_y +
          8.267195767195768e-07,
      b_aa = KSL_RN_LANES(x * b_z), b_ab = b_aa + 3.306878306878307e-05, b_ac = KSL_RN_LANES(x *
          b_ab),
      b_ad = b_ac + 0.001388888888888889, b_ae = KSL_RN_LANES(x * b_ad), b_af = b_ae +
          0.08333333333333333,
      b = ksl_choice_lanes(b_divisor_a, b_af, closed_b);
  const ksl_states b_across_a = KSL_RN_LANES(x * b), b_across_b = 1.0 - b_across_a,
      b_across = ksl_choice_lanes(b_divisor_a, b_across_b, half_cotangent);
  const ksl_states beta_v_1 = v[0] * b;
  const ksl_states beta_v_2 = v[1] * b;
  const ksl_states m_1 = KSL_RN_LANES(v[0] * beta_v_1);
  const ksl_states m_2 = KSL_RN_LANES(v[1] * beta_v_2);
  const ksl_states m_3 = KSL_RN_LANES(v[2] * (v[2] * b));
  const ksl_states m_4 = KSL_RN_LANES(v[1] * beta_v_1);
  const ksl_states m_5 = KSL_RN_LANES(v[2] * beta_v_1);
  const ksl_states m_6 = KSL_RN_LANES(v[2] * beta_v_2);
  const ksl_states others_1 = m_2 + m_3;
  const ksl_states others_2 = m_1 + m_3;
  const ksl_states others_3 = m_1 + m_2;
  const ksl_states diagonal0a = 1.0 - others_1, diagonal0b = b_across + m_1;
  const ksl_tests diagonal0c = ksl_less_lanes(m_1, others_1);
  const ksl_states diagonal0 = ksl_choice_lanes(diagonal0c, diagonal0b, diagonal0a);
  const ksl_states diagonal1a = 1.0 - others_2, diagonal1b = b_across + m_2;
  const ksl_tests diagonal1c = ksl_less_lanes(m_2, others_2);
  const ksl_states diagonal1 = ksl_choice_lanes(diagonal1c, diagonal1b, diagonal1a);
  const ksl_states diagonal2a = 1.0 - others_3, diagonal2b = b_across + m_3;
  const ksl_tests diagonal2c = ksl_less_lanes(m_3, others_3);
  const ksl_states diagonal2 = ksl_choice_lanes(diagonal2c, diagonal2b, diagonal2a);
  const ksl_states alpha_v_1 = KSL_RN_LANES(0.5 * v[0]);
  const ksl_states alpha_v_2 = KSL_RN_LANES(0.5 * v[1]);
  const ksl_states alpha_v_3 = KSL_RN_LANES(0.5 * v[2]);
  const ksl_states R_1 = m_4 - alpha_v_3;
  const ksl_states R_2 = m_5 + alpha_v_2;
  const ksl_states R_3 = m_4 + alpha_v_3;
  const ksl_states R_4 = m_6 - alpha_v_1;
  const ksl_states R_5 = m_5 - alpha_v_2;
  const ksl_states R_6 = m_6 + alpha_v_1;
  R[0] = diagonal0;
  R[3] = R_1;
  R[6] = R_2;
  R[1] = R_3;
  R[4] = diagonal1;
  R[7] = R_4;
  R[2] = R_5;
  R[5] = R_6;
  R[8] = diagonal2;
}

static KSL_INLINE void ksl_SE3_exp_states(const ksl_states *s, ksl_states *D) {
  const ksl_states sizes_a = ksl_abs_lanes(s[3]) + ksl_abs_lanes(s[4]),
      sizes = sizes_a + ksl_abs_lanes(s[5]);
  const ksl_states grid = KSL_RN_LANES(sizes * 268435456.0);
  const ksl_states high_1 = s[3] + grid - grid;
  const ksl_states high_2 = s[4] + grid - grid;
  const ksl_states high_3 = s[5] + grid - grid;
  const ksl_states squares_a = KSL_RN_LANES(high_1 * high_1), squares_b = KSL_RN_LANES(high_2 *
      high_2),
      squares_c = squares_a + squares_b, squares_d = KSL_RN_LANES(high_3 * high_3),
      squares = squares_c + squares_d;
  const ksl_states cross_a = KSL_RN_LANES((s[3] - high_1) * (s[3] + high_1)),
      cross_b = KSL_RN_LANES((s[4] - high_2) * (s[4] + high_2)), cross_c = cross_a + cross_b,
      cross_d = KSL_RN_LANES((s[5] - high_3) * (s[5] + high_3)), cross = cross_c + cross_d;
  const ksl_states x = squares + cross;
  const ksl_states theta_a = ksl_sqrt_lanes(x);
  const ksl_tests theta_b = ksl_less_lanes(x, ksl_each_lanes(1.0));
  const ksl_states theta = ksl_choice_lanes(theta_b, ksl_each_lanes(1.0), theta_a);
  const ksl_states theta_shifted = grid + theta;
  const ksl_states theta_high = theta_shifted - grid;
  const ksl_states theta_low = theta - theta_high;
  const ksl_states theta_sum = theta + theta_high;
  const ksl_states cross_rest_a = KSL_RN_LANES(theta_low * theta_sum), cross_rest = cross -
      cross_rest_a;
  const ksl_states exact_a = KSL_RN_LANES(theta_high * theta_high), exact = squares - exact_a;
  const ksl_states residual = cross_rest + exact;
  const ksl_states small_a = 0.5 * residual, small = small_a / theta;
  const ksl_states delta_a = ksl_abs_lanes(small);
  const ksl_tests delta_b = ksl_less_lanes(delta_a, ksl_each_lanes(0.0078125));
  const ksl_states delta = ksl_choice_lanes(delta_b, small, ksl_each_lanes(0.0));
  ksl_states far_cosine_a; const ksl_states far_sine_a = ksl_sincos_lanes(theta, &far_cosine_a);
  const ksl_states far_sine = ksl_choice_lanes(theta_b, ksl_each_lanes(1.0), far_sine_a);
  const ksl_states far_cosine = ksl_choice_lanes(theta_b, ksl_each_lanes(0.0), far_cosine_a);
  const ksl_states sine_a = KSL_RN_LANES(delta * far_cosine), sine = sine_a + far_sine;
  const ksl_states cosine_a = KSL_RN_LANES(delta * far_sine), cosine = far_cosine - cosine_a;
  const ksl_states far_x = ksl_choice_lanes(theta_b, ksl_each_lanes(1.0), x);
  const ksl_tests middle_x_a = ksl_less_lanes(x, ksl_each_lanes(4.0));
  const ksl_states middle_x = ksl_choice_lanes(middle_x_a, ksl_each_lanes(4.0), x);
  const ksl_states closed1 = sine / theta;
  const ksl_states versine = 1.0 - cosine;
  const ksl_states closed2 = versine / far_x;
  const ksl_states rest3 = 1.0 - closed1;
  const ksl_states closed3 = rest3 / middle_x;
  const ksl_states g1a = KSL_RN_LANES(6.446950284384474e-26 * x), g1b = g1a - 3.868170170630684e-23,
      g1c = KSL_RN_LANES(x * g1b), g1d = g1c + 1.9572941063391263e-20, g1e = KSL_RN_LANES(x * g1d),
      g1f = g1e - 8.22063524662433e-18, g1g = KSL_RN_LANES(x * g1f), g1h = g1g +
          2.8114572543455206e-15,
      g1i = KSL_RN_LANES(x * g1h), g1j = g1i - 7.647163731819816e-13, g1k = KSL_RN_LANES(x * g1j),
      g1l = g1k + 1.6059043836821613e-10, g1m = KSL_RN_LANES(x * g1l), g1n = g1m -
          2.505210838544172e-08,
      g1o = KSL_RN_LANES(x * g1n), g1p = g1o + 2.7557319223985893e-06, g1q = KSL_RN_LANES(x * g1p),
      g1r = g1q - 0.0001984126984126984, g1s = KSL_RN_LANES(x * g1r), g1t = g1s +
          0.008333333333333333,
      g1u = KSL_RN_LANES(x * g1t), g1v = g1u - 0.16666666666666666, g1w = KSL_RN_LANES(x * g1v), g1x
          = g1w + 1.0,
      g1 = ksl_choice_lanes(theta_b, g1x, closed1);
  const ksl_states g2a = KSL_RN_LANES(2.4795962632247976e-27 * x), g2b = g2a -
      1.6117375710961184e-24,
      g2c = KSL_RN_LANES(x * g2b), g2d = g2c + 8.896791392450574e-22, g2e = KSL_RN_LANES(x * g2d),
      g2f = g2e - 4.110317623312165e-19, g2g = KSL_RN_LANES(x * g2f), g2h = g2g +
          1.5619206968586225e-16,
      g2i = KSL_RN_LANES(x * g2h), g2j = g2i - 4.779477332387385e-14, g2k = KSL_RN_LANES(x * g2j),
      g2l = g2k + 1.1470745597729725e-11, g2m = KSL_RN_LANES(x * g2l), g2n = g2m -
          2.08767569878681e-09,
      g2o = KSL_RN_LANES(x * g2n), g2p = g2o + 2.755731922398589e-07, g2q = KSL_RN_LANES(x * g2p),
      g2r = g2q - 2.48015873015873e-05, g2s = KSL_RN_LANES(x * g2r), g2t = g2s +
          0.001388888888888889,
      g2u = KSL_RN_LANES(x * g2t), g2v = g2u - 0.041666666666666664, g2w = KSL_RN_LANES(x * g2v),
          g2x = g2w + 0.5,
      g2 = ksl_choice_lanes(theta_b, g2x, closed2);
  const ksl_states g3a = KSL_RN_LANES(9.183689863795546e-29 * x), g3b = g3a - 6.446950284384474e-26,
      g3c = KSL_RN_LANES(x * g3b), g3d = g3c + 3.868170170630684e-23, g3e = KSL_RN_LANES(x * g3d),
      g3f = g3e - 1.9572941063391263e-20, g3g = KSL_RN_LANES(x * g3f), g3h = g3g +
          8.22063524662433e-18,
      g3i = KSL_RN_LANES(x * g3h), g3j = g3i - 2.8114572543455206e-15, g3k = KSL_RN_LANES(x * g3j),
      g3l = g3k + 7.647163731819816e-13, g3m = KSL_RN_LANES(x * g3l), g3n = g3m -
          1.6059043836821613e-10,
      g3o = KSL_RN_LANES(x * g3n), g3p = g3o + 2.505210838544172e-08, g3q = KSL_RN_LANES(x * g3p),
      g3r = g3q - 2.7557319223985893e-06, g3s = KSL_RN_LANES(x * g3r), g3t = g3s +
          0.0001984126984126984,
      g3u = KSL_RN_LANES(x * g3t), g3v = g3u - 0.008333333333333333, g3w = KSL_RN_LANES(x * g3v),
      g3x = g3w + 0.16666666666666666, g3 = ksl_choice_lanes(middle_x_a, g3x, closed3);
  const ksl_states g0a = KSL_RN_LANES(x * g2), g0b = 1.0 - g0a, g0 = ksl_choice_lanes(theta_b, g0b,
      cosine);
  const ksl_states u_0a = KSL_RN_LANES(s[2] * s[4]), u_0b = KSL_RN_LANES(s[1] * s[5]);
  const ksl_states u_1a = KSL_RN_LANES(s[0] * s[5]), u_1b = KSL_RN_LANES(s[2] * s[3]);
  const ksl_states u_2a = KSL_RN_LANES(s[1] * s[3]), u_2b = KSL_RN_LANES(s[0] * s[4]);
  const ksl_states wv_a = KSL_RN_LANES(s[0] * s[3]), wv_b = KSL_RN_LANES(s[1] * s[4]), wv_c = wv_a +
      wv_b,
      wv_d = KSL_RN_LANES(s[2] * s[5]), wv = wv_c + wv_d;
  const ksl_states pitch = g3 * wv;
  const ksl_states beta_v_1 = s[3] * g2;
  const ksl_states beta_v_2 = s[4] * g2;
  const ksl_states m_1 = KSL_RN_LANES(s[3] * beta_v_1);
  const ksl_states m_2 = KSL_RN_LANES(s[4] * beta_v_2);
  const ksl_states m_3 = KSL_RN_LANES(s[5] * (s[5] * g2));
  const ksl_states m_4 = KSL_RN_LANES(s[4] * beta_v_1);
  const ksl_states m_5 = KSL_RN_LANES(s[5] * beta_v_1);
  const ksl_states m_6 = KSL_RN_LANES(s[5] * beta_v_2);
  const ksl_states others_1 = m_2 + m_3;
  const ksl_states others_2 = m_1 + m_3;
  const ksl_states others_3 = m_1 + m_2;
  const ksl_states diagonal0a = 1.0 - others_1, diagonal0b = g0 + m_1;
  const ksl_tests diagonal0c = ksl_less_lanes(m_1, others_1);
  const ksl_states diagonal0 = ksl_choice_lanes(diagonal0c, diagonal0b, diagonal0a);
  const ksl_states diagonal1a = 1.0 - others_2, diagonal1b = g0 + m_2;
  const ksl_tests diagonal1c = ksl_less_lanes(m_2, others_2);
  const ksl_states diagonal1 = ksl_choice_lanes(diagonal1c, diagonal1b, diagonal1a);
  const ksl_states diagonal2a = 1.0 - others_3, diagonal2b = g0 + m_3;
  const ksl_tests diagonal2c = ksl_less_lanes(m_3, others_3);
  const ksl_states diagonal2 = ksl_choice_lanes(diagonal2c, diagonal2b, diagonal2a);
  const ksl_states alpha_v_1 = KSL_RN_LANES(s[3] * g1);
  const ksl_states alpha_v_2 = KSL_RN_LANES(s[4] * g1);
  const ksl_states alpha_v_3 = KSL_RN_LANES(s[5] * g1);
  const ksl_states D_1 = m_4 - alpha_v_3;
  const ksl_states D_2 = m_5 + alpha_v_2;
  const ksl_states D_03a = KSL_RN_LANES(s[0] * g1), D_3 = D_03a + (KSL_RN_LANES(g2 * (u_0a - u_0b))
      + KSL_RN_LANES(s[3] * pitch));
  const ksl_states D_4 = m_4 + alpha_v_3;
  const ksl_states D_5 = m_6 - alpha_v_1;
  const ksl_states D_13a = KSL_RN_LANES(s[1] * g1), D_6 = D_13a + (KSL_RN_LANES(g2 * (u_1a - u_1b))
      + KSL_RN_LANES(s[4] * pitch));
  const ksl_states D_7 = m_5 - alpha_v_2;
  const ksl_states D_8 = m_6 + alpha_v_1;
  const ksl_states D_23a = KSL_RN_LANES(s[2] * g1), D_9 = D_23a + (KSL_RN_LANES(g2 * (u_2a - u_2b))
      + KSL_RN_LANES(s[5] * pitch));
  D[0] = diagonal0;
  D[3] = D_1;
  D[6] = D_2;
  D[9] = D_3;
  D[1] = D_4;
  D[4] = diagonal1;
  D[7] = D_5;
  D[10] = D_6;
  D[2] = D_7;
  D[5] = D_8;
  D[8] = diagonal2;
  D[11] = D_9;
}

static KSL_INLINE void ksl_SE3_log_states(const ksl_states *D, ksl_states *so) {
  const ksl_states p_1 = D[5] - D[7];
  const ksl_states p_2 = D[6] - D[2];
  const ksl_states p_3 = D[1] - D[3];
  const ksl_states s_1 = D[7] + D[5];
  const ksl_states s_2 = D[6] + D[2];
  const ksl_states s_3 = D[3] + D[1];
  const ksl_states first_1 = D[0] + 1.0;
  const ksl_states first_2 = 1.0 - D[0];
  const ksl_states others_1 = D[4] + D[8];
  const ksl_states others_2 = D[4] - D[8];
  const ksl_tests low_0a = ksl_less_lanes(D[4], D[0]);
  const ksl_states high_0a = -D[4];
  const ksl_tests high_0b = ksl_less_lanes(D[0], high_0a);
  const ksl_tests column_0a = ksl_less_lanes(D[8], ksl_each_lanes(0.0));
  const ksl_states column_1 = ksl_choice_lanes(column_0a, ksl_choice_lanes(low_0a, first_1
          - others_1, s_3), ksl_choice_lanes(high_0b, s_2, p_1));
  const ksl_states column_2 = ksl_choice_lanes(column_0a, ksl_choice_lanes(low_0a, s_3, first_2
          + others_2), ksl_choice_lanes(high_0b, s_1, p_2));
  const ksl_states column_3 = ksl_choice_lanes(column_0a, ksl_choice_lanes(low_0a, s_2, s_1),
      ksl_choice_lanes(high_0b, first_2 - others_2, p_3));
  const ksl_states column_4 = ksl_choice_lanes(column_0a, ksl_choice_lanes(low_0a, p_1, p_2),
      ksl_choice_lanes(high_0b, p_3, first_1 + others_1));
  const ksl_states upper_0a = -column_1;
  const ksl_tests upper_0b = ksl_less_lanes(column_4, ksl_each_lanes(0.0));
  const ksl_states upper_1 = ksl_choice_lanes(upper_0b, upper_0a, column_1);
  const ksl_states upper_1a = -column_2, upper_2 = ksl_choice_lanes(upper_0b, upper_1a, column_2);
  const ksl_states upper_2a = -column_3, upper_3 = ksl_choice_lanes(upper_0b, upper_2a, column_3);
  const ksl_states upper_3a = -column_4, upper_4 = ksl_choice_lanes(upper_0b, upper_3a, column_4);
  const ksl_states v_s_size_1 = ksl_abs_lanes(upper_1);
  const ksl_states v_s_size_2 = ksl_abs_lanes(upper_2);
  const ksl_states v_s_size_3 = ksl_abs_lanes(upper_3);
  const ksl_tests v_s_largest1a = ksl_less_lanes(v_s_size_1, v_s_size_2);
  const ksl_states v_s_largest1 = ksl_choice_lanes(v_s_largest1a, v_s_size_2, v_s_size_1);
  const ksl_tests v_s_largest2a = ksl_less_lanes(v_s_largest1, v_s_size_3);
  const ksl_states v_s_largest2 = ksl_choice_lanes(v_s_largest2a, v_s_size_3, v_s_largest1);
  const ksl_tests v_s_a = ksl_less_lanes(ksl_each_lanes(6.703903964971299e+153), v_s_largest2);
  const ksl_states v_s_b = ksl_choice_lanes(v_s_a, ksl_each_lanes(3.7291703656001034e-155),
      ksl_each_lanes(1.0));
  const ksl_tests v_s_c = ksl_less_lanes(v_s_largest2, ksl_each_lanes(256.0));
  const ksl_states v_s_d = ksl_choice_lanes(v_s_c, ksl_each_lanes(1.3093562431584567e+151), v_s_b);
  const ksl_tests v_s_e = ksl_less_lanes(v_s_largest2, ksl_each_lanes(1.955159272639747e-149));
  const ksl_states v_s = ksl_choice_lanes(v_s_e, ksl_each_lanes(1.0715086071862673e+301), v_s_d);
  const ksl_states v_y_1 = upper_1 * v_s;
  const ksl_states v_y_2 = upper_2 * v_s;
  const ksl_states v_y_3 = upper_3 * v_s;
  const ksl_states v_n_a = KSL_RN_LANES(v_y_1 * v_y_1), v_n_b = KSL_RN_LANES(v_y_2 * v_y_2), v_n_c =
      v_n_a + v_n_b,
      v_n_d = KSL_RN_LANES(v_y_3 * v_y_3), v_n_e = v_n_c + v_n_d, v_n = ksl_sqrt_lanes(v_n_e);
  const ksl_tests v_r_a = ksl_less_lanes(v_s, ksl_each_lanes(1.0));
  const ksl_states v_r_b = ksl_choice_lanes(v_r_a, ksl_each_lanes(2.6815615859885194e+154),
      ksl_each_lanes(1.0));
  const ksl_tests v_r_c = ksl_less_lanes(ksl_each_lanes(1.0), v_s);
  const ksl_states v_r_d = ksl_choice_lanes(v_r_c, ksl_each_lanes(7.637340908749012e-152), v_r_b);
  const ksl_tests v_r_e = ksl_less_lanes(ksl_each_lanes(1.3093562431584567e+151), v_s);
  const ksl_states v_r = ksl_choice_lanes(v_r_e, ksl_each_lanes(9.332636185032189e-302), v_r_d);
  const ksl_states n = v_n * v_r;
  const ksl_states half = ksl_atan2_lanes(n, upper_4);
  const ksl_tests divisor_a = ksl_equal_lanes(n, ksl_each_lanes(0.0));
  const ksl_states divisor = ksl_choice_lanes(divisor_a, ksl_each_lanes(1.0), n);
  const ksl_states theta = 2.0 * half;
  const ksl_states k = theta / divisor;
  const ksl_states vector_1 = KSL_RN_LANES(upper_1 * k);
  const ksl_states vector_2 = KSL_RN_LANES(upper_2 * k);
  const ksl_states vector_3 = KSL_RN_LANES(upper_3 * k);
  const ksl_states x = theta * theta;
  const ksl_tests far_sine_a = ksl_less_lanes(x, ksl_each_lanes(1.0));
  const ksl_states far_sine = ksl_choice_lanes(far_sine_a, ksl_each_lanes(1.0), n);
  const ksl_states cotangent = upper_4 / far_sine;
  const ksl_states half_cotangent_a = 0.5 * theta,
      half_cotangent = KSL_RN_LANES(half_cotangent_a * cotangent);
  const ksl_states b_rest = 1.0 - half_cotangent;
  const ksl_tests b_divisor_a = ksl_less_lanes(x, ksl_each_lanes(4.0));
  const ksl_states b_divisor = ksl_choice_lanes(b_divisor_a, ksl_each_lanes(4.0), x);
  const ksl_states closed_b = b_rest / b_divisor;
  const ksl_states b_a = KSL_RN_LANES(1.455172475614865e-27 * x), b_b = b_a + 5.744790668872202e-26,
      b_c = KSL_RN_LANES(x * b_b), b_d = b_c + 2.267952452337683e-24, b_e = KSL_RN_LANES(x * b_d),
      b_f = b_e + 8.953517427037546e-23, b_g = KSL_RN_LANES(x * b_f), b_h = b_g +
          3.534707039629467e-21,
      b_i = KSL_RN_LANES(x * b_h), b_j = b_i + 1.3954464685812522e-19, b_k = KSL_RN_LANES(x * b_j),
      b_l = b_k + 5.5090028283602295e-18, b_m = KSL_RN_LANES(x * b_l), b_n = b_m +
          2.174868698558062e-16,
      b_o = KSL_RN_LANES(x * b_n), b_p = b_o + 8.586062056277845e-15, b_q = KSL_RN_LANES(x * b_p),
      b_r = b_q + 3.3896802963225827e-13, b_s = KSL_RN_LANES(x * b_r), b_t = b_s +
          1.3382536530684679e-11,
      b_u = KSL_RN_LANES(x * b_t), b_v = b_u + 5.284190138687493e-10, b_w = KSL_RN_LANES(x * b_v),
      b_x = b_w + 2.08767569878681e-08, b_y = KSL_RN_LANES(x * b_x), b_z = b_y +
          8.267195767195768e-07,
      b_aa = KSL_RN_LANES(x * b_z), b_ab = b_aa + 3.306878306878307e-05, b_ac = KSL_RN_LANES(x *
          b_ab),
      b_ad = b_ac + 0.001388888888888889, b_ae = KSL_RN_LANES(x * b_ad), b_af = b_ae +
          0.08333333333333333,
      b = ksl_choice_lanes(b_divisor_a, b_af, closed_b);
  const ksl_states b_across_a = KSL_RN_LANES(x * b), b_across_b = 1.0 - b_across_a,
      b_across = ksl_choice_lanes(b_divisor_a, b_across_b, half_cotangent);
  const ksl_states wt_a = KSL_RN_LANES(D[9] * vector_1), wt_b = KSL_RN_LANES(D[10] * vector_2), wt_c
      = wt_a + wt_b,
      wt_d = KSL_RN_LANES(D[11] * vector_3), wt = wt_c + wt_d;
  const ksl_states pitch = b * wt;
  const ksl_states u_0a = KSL_RN_LANES(D[11] * vector_2), u_0b = KSL_RN_LANES(D[10] * vector_3);
  const ksl_states u_1a = KSL_RN_LANES(D[9] * vector_3), u_1b = KSL_RN_LANES(D[11] * vector_1);
  const ksl_states u_2a = KSL_RN_LANES(D[10] * vector_1), u_2b = KSL_RN_LANES(D[9] * vector_2);
  const ksl_states so_0a = KSL_RN_LANES(D[9] * b_across),
      so_1 = so_0a + (KSL_RN_LANES(vector_1 * pitch) - KSL_RN_LANES(0.5 * (u_0a - u_0b)));
  const ksl_states so_1a = KSL_RN_LANES(D[10] * b_across),
      so_2 = so_1a + (KSL_RN_LANES(vector_2 * pitch) - KSL_RN_LANES(0.5 * (u_1a - u_1b)));
  const ksl_states so_2a = KSL_RN_LANES(D[11] * b_across),
      so_3 = so_2a + (KSL_RN_LANES(vector_3 * pitch) - KSL_RN_LANES(0.5 * (u_2a - u_2b)));
  so[0] = so_1;
  so[1] = so_2;
  so[2] = so_3;
  so[3] = vector_1;
  so[4] = vector_2;
  so[5] = vector_3;
}

static KSL_INLINE void ksl_SE3_leftJacobian_states(const ksl_states *s, ksl_states *M) {
  const ksl_states sizes_a = ksl_abs_lanes(s[3]) + ksl_abs_lanes(s[4]),
      sizes = sizes_a + ksl_abs_lanes(s[5]);
  const ksl_states grid = KSL_RN_LANES(sizes * 268435456.0);
  const ksl_states high_1 = s[3] + grid - grid;
  const ksl_states high_2 = s[4] + grid - grid;
  const ksl_states high_3 = s[5] + grid - grid;
  const ksl_states squares_a = KSL_RN_LANES(high_1 * high_1), squares_b = KSL_RN_LANES(high_2 *
      high_2),
      squares_c = squares_a + squares_b, squares_d = KSL_RN_LANES(high_3 * high_3),
      squares = squares_c + squares_d;
  const ksl_states cross_a = KSL_RN_LANES((s[3] - high_1) * (s[3] + high_1)),
      cross_b = KSL_RN_LANES((s[4] - high_2) * (s[4] + high_2)), cross_c = cross_a + cross_b,
      cross_d = KSL_RN_LANES((s[5] - high_3) * (s[5] + high_3)), cross = cross_c + cross_d;
  const ksl_states x = squares + cross;
  const ksl_states theta_a = ksl_sqrt_lanes(x);
  const ksl_tests theta_b = ksl_less_lanes(x, ksl_each_lanes(1.0));
  const ksl_states theta = ksl_choice_lanes(theta_b, ksl_each_lanes(1.0), theta_a);
  const ksl_states theta_shifted = grid + theta;
  const ksl_states theta_high = theta_shifted - grid;
  const ksl_states theta_low = theta - theta_high;
  const ksl_states theta_sum = theta + theta_high;
  const ksl_states cross_rest_a = KSL_RN_LANES(theta_low * theta_sum), cross_rest = cross -
      cross_rest_a;
  const ksl_states exact_a = KSL_RN_LANES(theta_high * theta_high), exact = squares - exact_a;
  const ksl_states residual = cross_rest + exact;
  const ksl_states small_a = 0.5 * residual, small = small_a / theta;
  const ksl_states delta_a = ksl_abs_lanes(small);
  const ksl_tests delta_b = ksl_less_lanes(delta_a, ksl_each_lanes(0.0078125));
  const ksl_states delta = ksl_choice_lanes(delta_b, small, ksl_each_lanes(0.0));
  ksl_states far_cosine_a; const ksl_states far_sine_a = ksl_sincos_lanes(theta, &far_cosine_a);
  const ksl_states far_sine = ksl_choice_lanes(theta_b, ksl_each_lanes(1.0), far_sine_a);
  const ksl_states far_cosine = ksl_choice_lanes(theta_b, ksl_each_lanes(0.0), far_cosine_a);
  const ksl_states sine_a = KSL_RN_LANES(delta * far_cosine), sine = sine_a + far_sine;
  const ksl_states cosine_a = KSL_RN_LANES(delta * far_sine), cosine = far_cosine - cosine_a;
  const ksl_states far_x = ksl_choice_lanes(theta_b, ksl_each_lanes(1.0), x);
  const ksl_tests middle_x_a = ksl_less_lanes(x, ksl_each_lanes(4.0));
  const ksl_states middle_x = ksl_choice_lanes(middle_x_a, ksl_each_lanes(4.0), x);
  const ksl_states closed1 = sine / theta;
  const ksl_states versine = 1.0 - cosine;
  const ksl_states closed2 = versine / far_x;
  const ksl_states rest3 = 1.0 - closed1;
  const ksl_states closed3 = rest3 / middle_x;
  const ksl_states g1a = KSL_RN_LANES(6.446950284384474e-26 * x), g1b = g1a - 3.868170170630684e-23,
      g1c = KSL_RN_LANES(x * g1b), g1d = g1c + 1.9572941063391263e-20, g1e = KSL_RN_LANES(x * g1d),
      g1f = g1e - 8.22063524662433e-18, g1g = KSL_RN_LANES(x * g1f), g1h = g1g +
          2.8114572543455206e-15,
      g1i = KSL_RN_LANES(x * g1h), g1j = g1i - 7.647163731819816e-13, g1k = KSL_RN_LANES(x * g1j),
      g1l = g1k + 1.6059043836821613e-10, g1m = KSL_RN_LANES(x * g1l), g1n = g1m -
          2.505210838544172e-08,
      g1o = KSL_RN_LANES(x * g1n), g1p = g1o + 2.7557319223985893e-06, g1q = KSL_RN_LANES(x * g1p),
      g1r = g1q - 0.0001984126984126984, g1s = KSL_RN_LANES(x * g1r), g1t = g1s +
          0.008333333333333333,
      g1u = KSL_RN_LANES(x * g1t), g1v = g1u - 0.16666666666666666, g1w = KSL_RN_LANES(x * g1v), g1x
          = g1w + 1.0,
      g1 = ksl_choice_lanes(theta_b, g1x, closed1);
  const ksl_states g2a = KSL_RN_LANES(2.4795962632247976e-27 * x), g2b = g2a -
      1.6117375710961184e-24,
      g2c = KSL_RN_LANES(x * g2b), g2d = g2c + 8.896791392450574e-22, g2e = KSL_RN_LANES(x * g2d),
      g2f = g2e - 4.110317623312165e-19, g2g = KSL_RN_LANES(x * g2f), g2h = g2g +
          1.5619206968586225e-16,
      g2i = KSL_RN_LANES(x * g2h), g2j = g2i - 4.779477332387385e-14, g2k = KSL_RN_LANES(x * g2j),
      g2l = g2k + 1.1470745597729725e-11, g2m = KSL_RN_LANES(x * g2l), g2n = g2m -
          2.08767569878681e-09,
      g2o = KSL_RN_LANES(x * g2n), g2p = g2o + 2.755731922398589e-07, g2q = KSL_RN_LANES(x * g2p),
      g2r = g2q - 2.48015873015873e-05, g2s = KSL_RN_LANES(x * g2r), g2t = g2s +
          0.001388888888888889,
      g2u = KSL_RN_LANES(x * g2t), g2v = g2u - 0.041666666666666664, g2w = KSL_RN_LANES(x * g2v),
          g2x = g2w + 0.5,
      g2 = ksl_choice_lanes(theta_b, g2x, closed2);
  const ksl_states g3a = KSL_RN_LANES(9.183689863795546e-29 * x), g3b = g3a - 6.446950284384474e-26,
      g3c = KSL_RN_LANES(x * g3b), g3d = g3c + 3.868170170630684e-23, g3e = KSL_RN_LANES(x * g3d),
      g3f = g3e - 1.9572941063391263e-20, g3g = KSL_RN_LANES(x * g3f), g3h = g3g +
          8.22063524662433e-18,
      g3i = KSL_RN_LANES(x * g3h), g3j = g3i - 2.8114572543455206e-15, g3k = KSL_RN_LANES(x * g3j),
      g3l = g3k + 7.647163731819816e-13, g3m = KSL_RN_LANES(x * g3l), g3n = g3m -
          1.6059043836821613e-10,
      g3o = KSL_RN_LANES(x * g3n), g3p = g3o + 2.505210838544172e-08, g3q = KSL_RN_LANES(x * g3p),
      g3r = g3q - 2.7557319223985893e-06, g3s = KSL_RN_LANES(x * g3r), g3t = g3s +
          0.0001984126984126984,
      g3u = KSL_RN_LANES(x * g3t), g3v = g3u - 0.008333333333333333, g3w = KSL_RN_LANES(x * g3v),
      g3x = g3w + 0.16666666666666666, g3 = ksl_choice_lanes(middle_x_a, g3x, closed3);
  const ksl_tests late_x_a = ksl_less_lanes(x, ksl_each_lanes(9.0));
  const ksl_states late_x = ksl_choice_lanes(late_x_a, ksl_each_lanes(1.0), x);
  const ksl_states rate2_rest_a = KSL_RN_LANES(2.0 * g2), rate2_rest = g1 - rate2_rest_a;
  const ksl_states closed_rate2 = rate2_rest / late_x;
  const ksl_states rate3_rest_a = KSL_RN_LANES(3.0 * g3), rate3_rest = g2 - rate3_rest_a;
  const ksl_states closed_rate3 = rate3_rest / late_x;
  const ksl_states rate2a = KSL_RN_LANES(8.527712016381578e-29 * x), rate2b = 5.951031031739514e-26
      - rate2a,
      rate2c = KSL_RN_LANES(x * rate2b), rate2d = rate2c - 3.54582265641146e-23, rate2e =
          KSL_RN_LANES(x * rate2d),
      rate2f = rate2e + 1.7793582784901146e-20, rate2g = KSL_RN_LANES(x * rate2f),
      rate2h = rate2g - 7.398571721961897e-18, rate2i = KSL_RN_LANES(x * rate2h),
      rate2j = rate2i + 2.499073114973796e-15, rate2k = KSL_RN_LANES(x * rate2j),
      rate2l = rate2k - 6.691268265342339e-13, rate2m = KSL_RN_LANES(x * rate2l),
      rate2n = rate2m + 1.376489471727567e-10, rate2o = KSL_RN_LANES(x * rate2n),
      rate2p = rate2o - 2.08767569878681e-08, rate2q = KSL_RN_LANES(x * rate2p),
      rate2r = rate2q + 2.204585537918871e-06, rate2s = KSL_RN_LANES(x * rate2r),
      rate2t = rate2s - 0.00014880952380952382, rate2u = KSL_RN_LANES(x * rate2t),
      rate2v = rate2u + 0.005555555555555556, rate2w = KSL_RN_LANES(x * rate2v),
      rate2x = rate2w - 0.08333333333333333,
      rate2 = ksl_choice_lanes(late_x_a, rate2x, closed_rate2);
  const ksl_states rate3a = KSL_RN_LANES(2.9405903504764064e-30 * x), rate3b = 2.204085567310931e-27
      - rate3a,
      rate3c = KSL_RN_LANES(x * rate3b), rate3d = rate3c - 1.4183290625645841e-24, rate3e =
          KSL_RN_LANES(x * rate3d),
      rate3f = rate3e + 7.736340341261368e-22, rate3g = KSL_RN_LANES(x * rate3f),
      rate3h = rate3g - 3.523129391410427e-19, rate3i = KSL_RN_LANES(x * rate3h),
      rate3j = rate3i + 1.3153016394598927e-16, rate3k = KSL_RN_LANES(x * rate3j),
      rate3l = rate3k - 3.936040156083729e-14, rate3m = KSL_RN_LANES(x * rate3l),
      rate3n = rate3m + 9.17659647818378e-12, rate3o = KSL_RN_LANES(x * rate3n),
      rate3p = rate3o - 1.6059043836821615e-09, rate3q = KSL_RN_LANES(x * rate3p),
      rate3r = rate3q + 2.0041686708353376e-07, rate3s = KSL_RN_LANES(x * rate3r),
      rate3t = rate3s - 1.6534391534391536e-05, rate3u = KSL_RN_LANES(x * rate3t),
      rate3v = rate3u + 0.0007936507936507937, rate3w = KSL_RN_LANES(x * rate3v),
      rate3x = rate3w - 0.016666666666666666,
      rate3 = ksl_choice_lanes(late_x_a, rate3x, closed_rate3);
  const ksl_states beta_v_1 = s[3] * g3;
  const ksl_states beta_v_2 = s[4] * g3;
  const ksl_states m_1 = KSL_RN_LANES(s[3] * beta_v_1);
  const ksl_states m_2 = KSL_RN_LANES(s[4] * beta_v_2);
  const ksl_states m_3 = KSL_RN_LANES(s[5] * (s[5] * g3));
  const ksl_states m_4 = KSL_RN_LANES(s[4] * beta_v_1);
  const ksl_states m_5 = KSL_RN_LANES(s[5] * beta_v_1);
  const ksl_states m_6 = KSL_RN_LANES(s[5] * beta_v_2);
  const ksl_states others_1 = m_2 + m_3;
  const ksl_states others_2 = m_1 + m_3;
  const ksl_states others_3 = m_1 + m_2;
  const ksl_states diagonal0a = 1.0 - others_1, diagonal0b = g1 + m_1;
  const ksl_tests diagonal0c = ksl_less_lanes(m_1, others_1);
  const ksl_states diagonal0 = ksl_choice_lanes(diagonal0c, diagonal0b, diagonal0a);
  const ksl_states diagonal1a = 1.0 - others_2, diagonal1b = g1 + m_2;
  const ksl_tests diagonal1c = ksl_less_lanes(m_2, others_2);
  const ksl_states diagonal1 = ksl_choice_lanes(diagonal1c, diagonal1b, diagonal1a);
  const ksl_states diagonal2a = 1.0 - others_3, diagonal2b = g1 + m_3;
  const ksl_tests diagonal2c = ksl_less_lanes(m_3, others_3);
  const ksl_states diagonal2 = ksl_choice_lanes(diagonal2c, diagonal2b, diagonal2a);
  const ksl_states alpha_v_1 = KSL_RN_LANES(s[3] * g2);
  const ksl_states alpha_v_2 = KSL_RN_LANES(s[4] * g2);
  const ksl_states alpha_v_3 = KSL_RN_LANES(s[5] * g2);
  const ksl_states J_1 = m_4 - alpha_v_3;
  const ksl_states J_2 = m_5 + alpha_v_2;
  const ksl_states J_3 = m_4 + alpha_v_3;
  const ksl_states J_4 = m_6 - alpha_v_1;
  const ksl_states J_5 = m_5 - alpha_v_2;
  const ksl_states J_6 = m_6 + alpha_v_1;
  const ksl_states rate_vw_a = KSL_RN_LANES(s[0] * s[3]), rate_vw_b = KSL_RN_LANES(s[1] * s[4]),
      rate_vw_c = rate_vw_a + rate_vw_b, rate_vw_d = KSL_RN_LANES(s[2] * s[5]),
      rate_vw = rate_vw_c + rate_vw_d;
  const ksl_states rate_turn = rate2 * rate_vw;
  const ksl_states rate_bend_a = rate3 * rate_vw, rate_bend = -rate_bend_a;
  const ksl_states rate_q_0a = KSL_RN_LANES(s[0] * g2), rate_q_0b = KSL_RN_LANES(s[3] * rate_turn),
      rate_q_1 = rate_q_0a + rate_q_0b;
  const ksl_states rate_q_1a = KSL_RN_LANES(s[1] * g2), rate_q_1b = KSL_RN_LANES(s[4] * rate_turn),
      rate_q_2 = rate_q_1a + rate_q_1b;
  const ksl_states rate_q_2a = KSL_RN_LANES(s[2] * g2), rate_q_2b = KSL_RN_LANES(s[5] * rate_turn),
      rate_q_3 = rate_q_2a + rate_q_2b;
  const ksl_states rate_beta_v_1 = s[0] * g3;
  const ksl_states rate_beta_v_2 = s[1] * g3;
  const ksl_states rate_beta_v_3 = s[2] * g3;
  const ksl_states rate_bend_w_1 = s[3] * rate_bend;
  const ksl_states rate_bend_w_2 = s[4] * rate_bend;
  const ksl_states rate_symmetric_0a = KSL_RN_LANES(s[3] * rate_beta_v_2),
      rate_symmetric_0b = KSL_RN_LANES(s[4] * rate_beta_v_1),
      rate_symmetric_0c = rate_symmetric_0a + rate_symmetric_0b,
      rate_symmetric_0d = KSL_RN_LANES(s[4] * rate_bend_w_1),
      rate_symmetric_1 = rate_symmetric_0c - rate_symmetric_0d;
  const ksl_states rate_symmetric_1a = KSL_RN_LANES(s[3] * rate_beta_v_3),
      rate_symmetric_1b = KSL_RN_LANES(s[5] * rate_beta_v_1),
      rate_symmetric_1c = rate_symmetric_1a + rate_symmetric_1b,
      rate_symmetric_1d = KSL_RN_LANES(s[5] * rate_bend_w_1),
      rate_symmetric_2 = rate_symmetric_1c - rate_symmetric_1d;
  const ksl_states rate_symmetric_2a = KSL_RN_LANES(s[4] * rate_beta_v_3),
      rate_symmetric_2b = KSL_RN_LANES(s[5] * rate_beta_v_2),
      rate_symmetric_2c = rate_symmetric_2a + rate_symmetric_2b,
      rate_symmetric_2d = KSL_RN_LANES(s[5] * rate_bend_w_2),
      rate_symmetric_3 = rate_symmetric_2c - rate_symmetric_2d;
  const ksl_states rate_diagonal_0a = KSL_RN_LANES(s[4] * rate_bend_w_2),
      rate_diagonal_0b = KSL_RN_LANES(s[5] * (s[5] * rate_bend)),
      rate_diagonal_0c = rate_diagonal_0a + rate_diagonal_0b, rate_diagonal_0d = 2.0 * s[4],
      rate_diagonal_0e = KSL_RN_LANES(rate_diagonal_0d * rate_beta_v_2), rate_diagonal_0f = 2.0 *
          s[5],
      rate_diagonal_0g = KSL_RN_LANES(rate_diagonal_0f * rate_beta_v_3),
      rate_diagonal_0h = rate_diagonal_0e + rate_diagonal_0g,
      rate_diagonal_1 = rate_diagonal_0c - rate_diagonal_0h;
  const ksl_states rate_diagonal_1a = KSL_RN_LANES(s[3] * rate_bend_w_1),
      rate_diagonal_1b = rate_diagonal_1a + rate_diagonal_0b, rate_diagonal_1c = 2.0 * s[3],
      rate_diagonal_1d = KSL_RN_LANES(rate_diagonal_1c * rate_beta_v_1),
      rate_diagonal_1e = rate_diagonal_1d + rate_diagonal_0g,
      rate_diagonal_2 = rate_diagonal_1b - rate_diagonal_1e;
  const ksl_states rate_diagonal_2a = rate_diagonal_1a + rate_diagonal_0a,
      rate_diagonal_2b = rate_diagonal_1d + rate_diagonal_0e,
      rate_diagonal_3 = rate_diagonal_2a - rate_diagonal_2b;
  const ksl_states M_1 = rate_symmetric_1 - rate_q_3;
  const ksl_states M_2 = rate_q_2 + rate_symmetric_2;
  const ksl_states M_3 = rate_q_3 + rate_symmetric_1;
  const ksl_states M_4 = rate_symmetric_3 - rate_q_1;
  const ksl_states M_5 = rate_symmetric_2 - rate_q_2;
  const ksl_states M_6 = rate_q_1 + rate_symmetric_3;
  M[0] = diagonal0;
  M[6] = J_1;
  M[12] = J_2;
  M[18] = rate_diagonal_1;
  M[24] = M_1;
  M[30] = M_2;
  M[1] = J_3;
  M[7] = diagonal1;
  M[13] = J_4;
  M[19] = M_3;
  M[25] = rate_diagonal_2;
  M[31] = M_4;
  M[2] = J_5;
  M[8] = J_6;
  M[14] = diagonal2;
  M[20] = M_5;
  M[26] = M_6;
  M[32] = rate_diagonal_3;
  M[3] = ksl_each_lanes(0.0);
  M[9] = ksl_each_lanes(0.0);
  M[15] = ksl_each_lanes(0.0);
  M[21] = diagonal0;
  M[27] = J_1;
  M[33] = J_2;
  M[4] = ksl_each_lanes(0.0);
  M[10] = ksl_each_lanes(0.0);
  M[16] = ksl_each_lanes(0.0);
  M[22] = J_3;
  M[28] = diagonal1;
  M[34] = J_4;
  M[5] = ksl_each_lanes(0.0);
  M[11] = ksl_each_lanes(0.0);
  M[17] = ksl_each_lanes(0.0);
  M[23] = J_5;
  M[29] = J_6;
  M[35] = diagonal2;
}

static KSL_INLINE void ksl_SE3_rightJacobian_states(const ksl_states *s, ksl_states *M) {
  const ksl_states sizes_a = ksl_abs_lanes(s[3]) + ksl_abs_lanes(s[4]),
      sizes = sizes_a + ksl_abs_lanes(s[5]);
  const ksl_states grid = KSL_RN_LANES(sizes * 268435456.0);
  const ksl_states high_1 = s[3] + grid - grid;
  const ksl_states high_2 = s[4] + grid - grid;
  const ksl_states high_3 = s[5] + grid - grid;
  const ksl_states squares_a = KSL_RN_LANES(high_1 * high_1), squares_b = KSL_RN_LANES(high_2 *
      high_2),
      squares_c = squares_a + squares_b, squares_d = KSL_RN_LANES(high_3 * high_3),
      squares = squares_c + squares_d;
  const ksl_states cross_a = KSL_RN_LANES((s[3] - high_1) * (s[3] + high_1)),
      cross_b = KSL_RN_LANES((s[4] - high_2) * (s[4] + high_2)), cross_c = cross_a + cross_b,
      cross_d = KSL_RN_LANES((s[5] - high_3) * (s[5] + high_3)), cross = cross_c + cross_d;
  const ksl_states x = squares + cross;
  const ksl_states theta_a = ksl_sqrt_lanes(x);
  const ksl_tests theta_b = ksl_less_lanes(x, ksl_each_lanes(1.0));
  const ksl_states theta = ksl_choice_lanes(theta_b, ksl_each_lanes(1.0), theta_a);
  const ksl_states theta_shifted = grid + theta;
  const ksl_states theta_high = theta_shifted - grid;
  const ksl_states theta_low = theta - theta_high;
  const ksl_states theta_sum = theta + theta_high;
  const ksl_states cross_rest_a = KSL_RN_LANES(theta_low * theta_sum), cross_rest = cross -
      cross_rest_a;
  const ksl_states exact_a = KSL_RN_LANES(theta_high * theta_high), exact = squares - exact_a;
  const ksl_states residual = cross_rest + exact;
  const ksl_states small_a = 0.5 * residual, small = small_a / theta;
  const ksl_states delta_a = ksl_abs_lanes(small);
  const ksl_tests delta_b = ksl_less_lanes(delta_a, ksl_each_lanes(0.0078125));
  const ksl_states delta = ksl_choice_lanes(delta_b, small, ksl_each_lanes(0.0));
  ksl_states far_cosine_a; const ksl_states far_sine_a = ksl_sincos_lanes(theta, &far_cosine_a);
  const ksl_states far_sine = ksl_choice_lanes(theta_b, ksl_each_lanes(1.0), far_sine_a);
  const ksl_states far_cosine = ksl_choice_lanes(theta_b, ksl_each_lanes(0.0), far_cosine_a);
  const ksl_states sine_a = KSL_RN_LANES(delta * far_cosine), sine = sine_a + far_sine;
  const ksl_states cosine_a = KSL_RN_LANES(delta * far_sine), cosine = far_cosine - cosine_a;
  const ksl_states far_x = ksl_choice_lanes(theta_b, ksl_each_lanes(1.0), x);
  const ksl_tests middle_x_a = ksl_less_lanes(x, ksl_each_lanes(4.0));
  const ksl_states middle_x = ksl_choice_lanes(middle_x_a, ksl_each_lanes(4.0), x);
  const ksl_states closed1 = sine / theta;
  const ksl_states versine = 1.0 - cosine;
  const ksl_states closed2 = versine / far_x;
  const ksl_states rest3 = 1.0 - closed1;
  const ksl_states closed3 = rest3 / middle_x;
  const ksl_states g1a = KSL_RN_LANES(6.446950284384474e-26 * x), g1b = g1a - 3.868170170630684e-23,
      g1c = KSL_RN_LANES(x * g1b), g1d = g1c + 1.9572941063391263e-20, g1e = KSL_RN_LANES(x * g1d),
      g1f = g1e - 8.22063524662433e-18, g1g = KSL_RN_LANES(x * g1f), g1h = g1g +
          2.8114572543455206e-15,
      g1i = KSL_RN_LANES(x * g1h), g1j = g1i - 7.647163731819816e-13, g1k = KSL_RN_LANES(x * g1j),
      g1l = g1k + 1.6059043836821613e-10, g1m = KSL_RN_LANES(x * g1l), g1n = g1m -
          2.505210838544172e-08,
      g1o = KSL_RN_LANES(x * g1n), g1p = g1o + 2.7557319223985893e-06, g1q = KSL_RN_LANES(x * g1p),
      g1r = g1q - 0.0001984126984126984, g1s = KSL_RN_LANES(x * g1r), g1t = g1s +
          0.008333333333333333,
      g1u = KSL_RN_LANES(x * g1t), g1v = g1u - 0.16666666666666666, g1w = KSL_RN_LANES(x * g1v), g1x
          = g1w + 1.0,
      g1 = ksl_choice_lanes(theta_b, g1x, closed1);
  const ksl_states g2a = KSL_RN_LANES(2.4795962632247976e-27 * x), g2b = g2a -
      1.6117375710961184e-24,
      g2c = KSL_RN_LANES(x * g2b), g2d = g2c + 8.896791392450574e-22, g2e = KSL_RN_LANES(x * g2d),
      g2f = g2e - 4.110317623312165e-19, g2g = KSL_RN_LANES(x * g2f), g2h = g2g +
          1.5619206968586225e-16,
      g2i = KSL_RN_LANES(x * g2h), g2j = g2i - 4.779477332387385e-14, g2k = KSL_RN_LANES(x * g2j),
      g2l = g2k + 1.1470745597729725e-11, g2m = KSL_RN_LANES(x * g2l), g2n = g2m -
          2.08767569878681e-09,
      g2o = KSL_RN_LANES(x * g2n), g2p = g2o + 2.755731922398589e-07, g2q = KSL_RN_LANES(x * g2p),
      g2r = g2q - 2.48015873015873e-05, g2s = KSL_RN_LANES(x * g2r), g2t = g2s +
          0.001388888888888889,
      g2u = KSL_RN_LANES(x * g2t), g2v = g2u - 0.041666666666666664, g2w = KSL_RN_LANES(x * g2v),
          g2x = g2w + 0.5,
      g2 = ksl_choice_lanes(theta_b, g2x, closed2);
  const ksl_states g3a = KSL_RN_LANES(9.183689863795546e-29 * x), g3b = g3a - 6.446950284384474e-26,
      g3c = KSL_RN_LANES(x * g3b), g3d = g3c + 3.868170170630684e-23, g3e = KSL_RN_LANES(x * g3d),
      g3f = g3e - 1.9572941063391263e-20, g3g = KSL_RN_LANES(x * g3f), g3h = g3g +
          8.22063524662433e-18,
      g3i = KSL_RN_LANES(x * g3h), g3j = g3i - 2.8114572543455206e-15, g3k = KSL_RN_LANES(x * g3j),
      g3l = g3k + 7.647163731819816e-13, g3m = KSL_RN_LANES(x * g3l), g3n = g3m -
          1.6059043836821613e-10,
      g3o = KSL_RN_LANES(x * g3n), g3p = g3o + 2.505210838544172e-08, g3q = KSL_RN_LANES(x * g3p),
      g3r = g3q - 2.7557319223985893e-06, g3s = KSL_RN_LANES(x * g3r), g3t = g3s +
          0.0001984126984126984,
      g3u = KSL_RN_LANES(x * g3t), g3v = g3u - 0.008333333333333333, g3w = KSL_RN_LANES(x * g3v),
      g3x = g3w + 0.16666666666666666, g3 = ksl_choice_lanes(middle_x_a, g3x, closed3);
  const ksl_tests late_x_a = ksl_less_lanes(x, ksl_each_lanes(9.0));
  const ksl_states late_x = ksl_choice_lanes(late_x_a, ksl_each_lanes(1.0), x);
  const ksl_states rate2_rest_a = KSL_RN_LANES(2.0 * g2), rate2_rest = g1 - rate2_rest_a;
  const ksl_states closed_rate2 = rate2_rest / late_x;
  const ksl_states rate3_rest_a = KSL_RN_LANES(3.0 * g3), rate3_rest = g2 - rate3_rest_a;
  const ksl_states closed_rate3 = rate3_rest / late_x;
  const ksl_states rate2a = KSL_RN_LANES(8.527712016381578e-29 * x), rate2b = 5.951031031739514e-26
      - rate2a,
      rate2c = KSL_RN_LANES(x * rate2b), rate2d = rate2c - 3.54582265641146e-23, rate2e =
          KSL_RN_LANES(x * rate2d),
      rate2f = rate2e + 1.7793582784901146e-20, rate2g = KSL_RN_LANES(x * rate2f),
      rate2h = rate2g - 7.398571721961897e-18, rate2i = KSL_RN_LANES(x * rate2h),
      rate2j = rate2i + 2.499073114973796e-15, rate2k = KSL_RN_LANES(x * rate2j),
      rate2l = rate2k - 6.691268265342339e-13, rate2m = KSL_RN_LANES(x * rate2l),
      rate2n = rate2m + 1.376489471727567e-10, rate2o = KSL_RN_LANES(x * rate2n),
      rate2p = rate2o - 2.08767569878681e-08, rate2q = KSL_RN_LANES(x * rate2p),
      rate2r = rate2q + 2.204585537918871e-06, rate2s = KSL_RN_LANES(x * rate2r),
      rate2t = rate2s - 0.00014880952380952382, rate2u = KSL_RN_LANES(x * rate2t),
      rate2v = rate2u + 0.005555555555555556, rate2w = KSL_RN_LANES(x * rate2v),
      rate2x = rate2w - 0.08333333333333333,
      rate2 = ksl_choice_lanes(late_x_a, rate2x, closed_rate2);
  const ksl_states rate3a = KSL_RN_LANES(2.9405903504764064e-30 * x), rate3b = 2.204085567310931e-27
      - rate3a,
      rate3c = KSL_RN_LANES(x * rate3b), rate3d = rate3c - 1.4183290625645841e-24, rate3e =
          KSL_RN_LANES(x * rate3d),
      rate3f = rate3e + 7.736340341261368e-22, rate3g = KSL_RN_LANES(x * rate3f),
      rate3h = rate3g - 3.523129391410427e-19, rate3i = KSL_RN_LANES(x * rate3h),
      rate3j = rate3i + 1.3153016394598927e-16, rate3k = KSL_RN_LANES(x * rate3j),
      rate3l = rate3k - 3.936040156083729e-14, rate3m = KSL_RN_LANES(x * rate3l),
      rate3n = rate3m + 9.17659647818378e-12, rate3o = KSL_RN_LANES(x * rate3n),
      rate3p = rate3o - 1.6059043836821615e-09, rate3q = KSL_RN_LANES(x * rate3p),
      rate3r = rate3q + 2.0041686708353376e-07, rate3s = KSL_RN_LANES(x * rate3r),
      rate3t = rate3s - 1.6534391534391536e-05, rate3u = KSL_RN_LANES(x * rate3t),
      rate3v = rate3u + 0.0007936507936507937, rate3w = KSL_RN_LANES(x * rate3v),
      rate3x = rate3w - 0.016666666666666666,
      rate3 = ksl_choice_lanes(late_x_a, rate3x, closed_rate3);
  const ksl_states beta_v_1 = s[3] * g3;
  const ksl_states beta_v_2 = s[4] * g3;
  const ksl_states m_1 = KSL_RN_LANES(s[3] * beta_v_1);
  const ksl_states m_2 = KSL_RN_LANES(s[4] * beta_v_2);
  const ksl_states m_3 = KSL_RN_LANES(s[5] * (s[5] * g3));
  const ksl_states m_4 = KSL_RN_LANES(s[4] * beta_v_1);
  const ksl_states m_5 = KSL_RN_LANES(s[5] * beta_v_1);
  const ksl_states m_6 = KSL_RN_LANES(s[5] * beta_v_2);
  const ksl_states others_1 = m_2 + m_3;
  const ksl_states others_2 = m_1 + m_3;
  const ksl_states others_3 = m_1 + m_2;
  const ksl_states diagonal0a = 1.0 - others_1, diagonal0b = g1 + m_1;
  const ksl_tests diagonal0c = ksl_less_lanes(m_1, others_1);
  const ksl_states diagonal0 = ksl_choice_lanes(diagonal0c, diagonal0b, diagonal0a);
  const ksl_states diagonal1a = 1.0 - others_2, diagonal1b = g1 + m_2;
  const ksl_tests diagonal1c = ksl_less_lanes(m_2, others_2);
  const ksl_states diagonal1 = ksl_choice_lanes(diagonal1c, diagonal1b, diagonal1a);
  const ksl_states diagonal2a = 1.0 - others_3, diagonal2b = g1 + m_3;
  const ksl_tests diagonal2c = ksl_less_lanes(m_3, others_3);
  const ksl_states diagonal2 = ksl_choice_lanes(diagonal2c, diagonal2b, diagonal2a);
  const ksl_states alpha_v_0a = KSL_RN_LANES(s[3] * g2), alpha_v_1 = -alpha_v_0a;
  const ksl_states alpha_v_1a = KSL_RN_LANES(s[4] * g2), alpha_v_2 = -alpha_v_1a;
  const ksl_states alpha_v_2a = KSL_RN_LANES(s[5] * g2), alpha_v_3 = -alpha_v_2a;
  const ksl_states J_1 = m_4 - alpha_v_3;
  const ksl_states J_2 = m_5 + alpha_v_2;
  const ksl_states J_3 = m_4 + alpha_v_3;
  const ksl_states J_4 = m_6 - alpha_v_1;
  const ksl_states J_5 = m_5 - alpha_v_2;
  const ksl_states J_6 = m_6 + alpha_v_1;
  const ksl_states rate_vw_a = KSL_RN_LANES(s[0] * s[3]), rate_vw_b = KSL_RN_LANES(s[1] * s[4]),
      rate_vw_c = rate_vw_a + rate_vw_b, rate_vw_d = KSL_RN_LANES(s[2] * s[5]),
      rate_vw = rate_vw_c + rate_vw_d;
  const ksl_states rate_turn = rate2 * rate_vw;
  const ksl_states rate_bend_a = rate3 * rate_vw, rate_bend = -rate_bend_a;
  const ksl_states rate_q_0a = KSL_RN_LANES(s[0] * g2), rate_q_0b = KSL_RN_LANES(s[3] * rate_turn),
      rate_q_0c = rate_q_0a + rate_q_0b, rate_q_1 = -rate_q_0c;
  const ksl_states rate_q_1a = KSL_RN_LANES(s[1] * g2), rate_q_1b = KSL_RN_LANES(s[4] * rate_turn),
      rate_q_1c = rate_q_1a + rate_q_1b, rate_q_2 = -rate_q_1c;
  const ksl_states rate_q_2a = KSL_RN_LANES(s[2] * g2), rate_q_2b = KSL_RN_LANES(s[5] * rate_turn),
      rate_q_2c = rate_q_2a + rate_q_2b, rate_q_3 = -rate_q_2c;
  const ksl_states rate_beta_v_0a = s[0] * g3, rate_beta_v_1 = -rate_beta_v_0a;
  const ksl_states rate_beta_v_1a = s[1] * g3, rate_beta_v_2 = -rate_beta_v_1a;
  const ksl_states rate_beta_v_2a = s[2] * g3, rate_beta_v_3 = -rate_beta_v_2a;
  const ksl_states rate_bend_w_0a = s[3] * rate_bend, rate_bend_w_1 = -rate_bend_w_0a;
  const ksl_states rate_bend_w_1a = s[4] * rate_bend, rate_bend_w_2 = -rate_bend_w_1a;
  const ksl_states rate_bend_w_2a = s[5] * rate_bend;
  const ksl_states rate_symmetric_0a = KSL_RN_LANES(s[4] * rate_bend_w_1),
      rate_symmetric_0b = KSL_RN_LANES(s[3] * rate_beta_v_2), rate_symmetric_0c = KSL_RN_LANES(s[4]
          * rate_beta_v_1),
      rate_symmetric_0d = rate_symmetric_0b + rate_symmetric_0c,
      rate_symmetric_1 = rate_symmetric_0a - rate_symmetric_0d;
  const ksl_states rate_symmetric_1a = KSL_RN_LANES(s[5] * rate_bend_w_1),
      rate_symmetric_1b = KSL_RN_LANES(s[3] * rate_beta_v_3), rate_symmetric_1c = KSL_RN_LANES(s[5]
          * rate_beta_v_1),
      rate_symmetric_1d = rate_symmetric_1b + rate_symmetric_1c,
      rate_symmetric_2 = rate_symmetric_1a - rate_symmetric_1d;
  const ksl_states rate_symmetric_2a = KSL_RN_LANES(s[5] * rate_bend_w_2),
      rate_symmetric_2b = KSL_RN_LANES(s[4] * rate_beta_v_3), rate_symmetric_2c = KSL_RN_LANES(s[5]
          * rate_beta_v_2),
      rate_symmetric_2d = rate_symmetric_2b + rate_symmetric_2c,
      rate_symmetric_3 = rate_symmetric_2a - rate_symmetric_2d;
  const ksl_states rate_diagonal_0a = 2.0 * s[4],
      rate_diagonal_0b = KSL_RN_LANES(rate_diagonal_0a * rate_beta_v_2), rate_diagonal_0c = 2.0 *
          s[5],
      rate_diagonal_0d = KSL_RN_LANES(rate_diagonal_0c * rate_beta_v_3),
      rate_diagonal_0e = rate_diagonal_0b + rate_diagonal_0d,
      rate_diagonal_0f = KSL_RN_LANES(s[4] * rate_bend_w_2), rate_diagonal_0g = KSL_RN_LANES(s[5] *
          -rate_bend_w_2a),
      rate_diagonal_0h = rate_diagonal_0f + rate_diagonal_0g,
      rate_diagonal_1 = rate_diagonal_0e - rate_diagonal_0h;
  const ksl_states rate_diagonal_1a = 2.0 * s[3],
      rate_diagonal_1b = KSL_RN_LANES(rate_diagonal_1a * rate_beta_v_1),
      rate_diagonal_1c = rate_diagonal_1b + rate_diagonal_0d,
      rate_diagonal_1d = KSL_RN_LANES(s[3] * rate_bend_w_1),
      rate_diagonal_1e = rate_diagonal_1d + rate_diagonal_0g,
      rate_diagonal_2 = rate_diagonal_1c - rate_diagonal_1e;
  const ksl_states rate_diagonal_2a = rate_diagonal_1b + rate_diagonal_0b,
      rate_diagonal_2b = rate_diagonal_1d + rate_diagonal_0f,
      rate_diagonal_3 = rate_diagonal_2a - rate_diagonal_2b;
  const ksl_states M_1 = rate_symmetric_1 - rate_q_3;
  const ksl_states M_2 = rate_q_2 + rate_symmetric_2;
  const ksl_states M_3 = rate_q_3 + rate_symmetric_1;
  const ksl_states M_4 = rate_symmetric_3 - rate_q_1;
  const ksl_states M_5 = rate_symmetric_2 - rate_q_2;
  const ksl_states M_6 = rate_q_1 + rate_symmetric_3;
  M[0] = diagonal0;
  M[6] = J_1;
  M[12] = J_2;
  M[18] = rate_diagonal_1;
  M[24] = M_1;
  M[30] = M_2;
  M[1] = J_3;
  M[7] = diagonal1;
  M[13] = J_4;
  M[19] = M_3;
  M[25] = rate_diagonal_2;
  M[31] = M_4;
  M[2] = J_5;
  M[8] = J_6;
  M[14] = diagonal2;
  M[20] = M_5;
  M[26] = M_6;
  M[32] = rate_diagonal_3;
  M[3] = ksl_each_lanes(0.0);
  M[9] = ksl_each_lanes(0.0);
  M[15] = ksl_each_lanes(0.0);
  M[21] = diagonal0;
  M[27] = J_1;
  M[33] = J_2;
  M[4] = ksl_each_lanes(0.0);
  M[10] = ksl_each_lanes(0.0);
  M[16] = ksl_each_lanes(0.0);
  M[22] = J_3;
  M[28] = diagonal1;
  M[34] = J_4;
  M[5] = ksl_each_lanes(0.0);
  M[11] = ksl_each_lanes(0.0);
  M[17] = ksl_each_lanes(0.0);
  M[23] = J_5;
  M[29] = J_6;
  M[35] = diagonal2;
}

static KSL_INLINE void ksl_SE3_leftJacobianInverse_states(const ksl_states *s, ksl_states *M) {
  const ksl_states sizes_a = ksl_abs_lanes(s[3]) + ksl_abs_lanes(s[4]),
      sizes = sizes_a + ksl_abs_lanes(s[5]);
  const ksl_states grid = KSL_RN_LANES(sizes * 268435456.0);
  const ksl_states high_1 = s[3] + grid - grid;
  const ksl_states high_2 = s[4] + grid - grid;
  const ksl_states high_3 = s[5] + grid - grid;
  const ksl_states squares_a = KSL_RN_LANES(high_1 * high_1), squares_b = KSL_RN_LANES(high_2 *
      high_2),
      squares_c = squares_a + squares_b, squares_d = KSL_RN_LANES(high_3 * high_3),
      squares = squares_c + squares_d;
  const ksl_states cross_a = KSL_RN_LANES((s[3] - high_1) * (s[3] + high_1)),
      cross_b = KSL_RN_LANES((s[4] - high_2) * (s[4] + high_2)), cross_c = cross_a + cross_b,
      cross_d = KSL_RN_LANES((s[5] - high_3) * (s[5] + high_3)), cross = cross_c + cross_d;
  const ksl_states x = squares + cross;
  const ksl_states theta_a = ksl_sqrt_lanes(x);
  const ksl_tests theta_b = ksl_less_lanes(x, ksl_each_lanes(1.0));
  const ksl_states theta = ksl_choice_lanes(theta_b, ksl_each_lanes(1.0), theta_a);
  const ksl_states theta_shifted = grid + theta;
  const ksl_states theta_high = theta_shifted - grid;
  const ksl_states theta_low = theta - theta_high;
  const ksl_states theta_sum = theta + theta_high;
  const ksl_states cross_rest_a = KSL_RN_LANES(theta_low * theta_sum), cross_rest = cross -
      cross_rest_a;
  const ksl_states exact_a = KSL_RN_LANES(theta_high * theta_high), exact = squares - exact_a;
  const ksl_states residual = cross_rest + exact;
  const ksl_states small_a = 0.5 * residual, small = small_a / theta;
  const ksl_states delta_a = ksl_abs_lanes(small);
  const ksl_tests delta_b = ksl_less_lanes(delta_a, ksl_each_lanes(0.0078125));
  const ksl_states delta = ksl_choice_lanes(delta_b, small, ksl_each_lanes(0.0));
  ksl_states far_cosine_a; const ksl_states far_sine_a = ksl_sincos_lanes(theta, &far_cosine_a);
  const ksl_states far_sine = ksl_choice_lanes(theta_b, ksl_each_lanes(1.0), far_sine_a);
  const ksl_states far_cosine = ksl_choice_lanes(theta_b, ksl_each_lanes(0.0), far_cosine_a);
  const ksl_states sine_a = KSL_RN_LANES(delta * far_cosine), sine = sine_a + far_sine;
  const ksl_states cosine_a = KSL_RN_LANES(delta * far_sine), cosine = far_cosine - cosine_a;
  const ksl_states above_a = cosine + 1.0;
  const ksl_tests above_b = ksl_less_lanes(cosine, ksl_each_lanes(0.0));
  const ksl_states above = ksl_choice_lanes(above_b, sine, above_a);
  const ksl_states below_a = 1.0 - cosine, below = ksl_choice_lanes(above_b, below_a, sine);
  const ksl_states cotangent = above / below;
  const ksl_states half_cotangent_a = 0.5 * theta,
      half_cotangent = KSL_RN_LANES(half_cotangent_a * cotangent);
  const ksl_states b_rest = 1.0 - half_cotangent;
  const ksl_tests b_divisor_a = ksl_less_lanes(x, ksl_each_lanes(4.0));
  const ksl_states b_divisor = ksl_choice_lanes(b_divisor_a, ksl_each_lanes(4.0), x);
  const ksl_states closed_b = b_rest / b_divisor;
  const ksl_states b_a = KSL_RN_LANES(1.455172475614865e-27 * x), b_b = b_a + 5.744790668872202e-26,
      b_c = KSL_RN_LANES(x * b_b), b_d = b_c + 2.267952452337683e-24, b_e = KSL_RN_LANES(x * b_d),
      b_f = b_e + 8.953517427037546e-23, b_g = KSL_RN_LANES(x * b_f), b_h = b_g +
          3.534707039629467e-21,
      b_i = KSL_RN_LANES(x * b_h), b_j = b_i + 1.3954464685812522e-19, b_k = KSL_RN_LANES(x * b_j),
      b_l = b_k + 5.5090028283602295e-18, b_m = KSL_RN_LANES(x * b_l), b_n = b_m +
          2.174868698558062e-16,
      b_o = KSL_RN_LANES(x * b_n), b_p = b_o + 8.586062056277845e-15, b_q = KSL_RN_LANES(x * b_p),
      b_r = b_q + 3.3896802963225827e-13, b_s = KSL_RN_LANES(x * b_r), b_t = b_s +
          1.3382536530684679e-11,
      b_u = KSL_RN_LANES(x * b_t), b_v = b_u + 5.284190138687493e-10, b_w = KSL_RN_LANES(x * b_v),
      b_x = b_w + 2.08767569878681e-08, b_y = KSL_RN_LANES(x * b_x), b_z = b_y +
          8.267195767195768e-07,
      b_aa = KSL_RN_LANES(x * b_z), b_ab = b_aa + 3.306878306878307e-05, b_ac = KSL_RN_LANES(x *
          b_ab),
      b_ad = b_ac + 0.001388888888888889, b_ae = KSL_RN_LANES(x * b_ad), b_af = b_ae +
          0.08333333333333333,
      b = ksl_choice_lanes(b_divisor_a, b_af, closed_b);
  const ksl_states b_across_a = KSL_RN_LANES(x * b), b_across_b = 1.0 - b_across_a,
      b_across = ksl_choice_lanes(b_divisor_a, b_across_b, half_cotangent);
  const ksl_states beta_v_1 = s[3] * b;
  const ksl_states beta_v_2 = s[4] * b;
  const ksl_states m_1 = KSL_RN_LANES(s[3] * beta_v_1);
  const ksl_states m_2 = KSL_RN_LANES(s[4] * beta_v_2);
  const ksl_states m_3 = KSL_RN_LANES(s[5] * (s[5] * b));
  const ksl_states m_4 = KSL_RN_LANES(s[4] * beta_v_1);
  const ksl_states m_5 = KSL_RN_LANES(s[5] * beta_v_1);
  const ksl_states m_6 = KSL_RN_LANES(s[5] * beta_v_2);
  const ksl_states others_1 = m_2 + m_3;
  const ksl_states others_2 = m_1 + m_3;
  const ksl_states others_3 = m_1 + m_2;
  const ksl_states diagonal0a = 1.0 - others_1, diagonal0b = b_across + m_1;
  const ksl_tests diagonal0c = ksl_less_lanes(m_1, others_1);
  const ksl_states diagonal0 = ksl_choice_lanes(diagonal0c, diagonal0b, diagonal0a);
  const ksl_states diagonal1a = 1.0 - others_2, diagonal1b = b_across + m_2;
  const ksl_tests diagonal1c = ksl_less_lanes(m_2, others_2);
  const ksl_states diagonal1 = ksl_choice_lanes(diagonal1c, diagonal1b, diagonal1a);
  const ksl_states diagonal2a = 1.0 - others_3, diagonal2b = b_across + m_3;
  const ksl_tests diagonal2c = ksl_less_lanes(m_3, others_3);
  const ksl_states diagonal2 = ksl_choice_lanes(diagonal2c, diagonal2b, diagonal2a);
  const ksl_states alpha_v_0a = KSL_RN_LANES(0.5 * s[3]), alpha_v_1 = -alpha_v_0a;
  const ksl_states alpha_v_1a = KSL_RN_LANES(0.5 * s[4]), alpha_v_2 = -alpha_v_1a;
  const ksl_states alpha_v_2a = KSL_RN_LANES(0.5 * s[5]), alpha_v_3 = -alpha_v_2a;
  const ksl_states J_1 = m_4 - alpha_v_3;
  const ksl_states J_2 = m_5 + alpha_v_2;
  const ksl_states J_3 = m_4 + alpha_v_3;
  const ksl_states J_4 = m_6 - alpha_v_1;
  const ksl_states J_5 = m_5 - alpha_v_2;
  const ksl_states J_6 = m_6 + alpha_v_1;
  const ksl_states b_rate_across_a = 2.0 - half_cotangent,
      b_rate_across = b_rate_across_a / b_divisor;
  const ksl_states b_rate_square_a = cotangent * cotangent,
      b_rate_square_b = KSL_RN_LANES(0.25 * b_rate_square_a), b_rate_square = 0.25 +
          b_rate_square_b;
  const ksl_states b_rate_rest = b_rate_square - b_rate_across;
  const ksl_states closed_b_rate = b_rate_rest / b_divisor;
  const ksl_states b_rate_a = KSL_RN_LANES(3.3612243325542163e-29 * x),
      b_rate_b = b_rate_a + 1.2532382798262054e-27, b_rate_c = KSL_RN_LANES(x * b_rate_b),
      b_rate_d = b_rate_c + 4.656551921967568e-26, b_rate_e = KSL_RN_LANES(x * b_rate_d),
      b_rate_f = b_rate_e + 1.7234372006616606e-24, b_rate_g = KSL_RN_LANES(x * b_rate_f),
      b_rate_h = b_rate_g + 6.350266866545513e-23, b_rate_i = KSL_RN_LANES(x * b_rate_h),
      b_rate_j = b_rate_i + 2.327914531029762e-21, b_rate_k = KSL_RN_LANES(x * b_rate_j),
      b_rate_l = b_rate_k + 8.483296895110721e-20, b_rate_m = KSL_RN_LANES(x * b_rate_l),
      b_rate_n = b_rate_m + 3.069982230878755e-18, b_rate_o = KSL_RN_LANES(x * b_rate_n),
      b_rate_p = b_rate_o + 1.1018005656720459e-16, b_rate_q = KSL_RN_LANES(x * b_rate_p),
      b_rate_r = b_rate_q + 3.914763657404511e-15, b_rate_s = KSL_RN_LANES(x * b_rate_r),
      b_rate_t = b_rate_s + 1.3737699290044552e-13, b_rate_u = KSL_RN_LANES(x * b_rate_t),
      b_rate_v = b_rate_u + 4.745552414851616e-12, b_rate_w = KSL_RN_LANES(x * b_rate_v),
      b_rate_x = b_rate_w + 1.6059043836821613e-10, b_rate_y = KSL_RN_LANES(x * b_rate_x),
      b_rate_z = b_rate_y + 5.2841901386874934e-09, b_rate_aa = KSL_RN_LANES(x * b_rate_z),
      b_rate_ab = b_rate_aa + 1.670140559029448e-07, b_rate_ac = KSL_RN_LANES(x * b_rate_ab),
      b_rate_ad = b_rate_ac + 4.96031746031746e-06, b_rate_ae = KSL_RN_LANES(x * b_rate_ad),
      b_rate_af = b_rate_ae + 0.00013227513227513228, b_rate_ag = KSL_RN_LANES(x * b_rate_af),
      b_rate_ah = b_rate_ag + 0.002777777777777778,
      b_rate = ksl_choice_lanes(b_divisor_a, b_rate_ah, closed_b_rate);
  const ksl_states rate_vw_a = KSL_RN_LANES(s[0] * s[3]), rate_vw_b = KSL_RN_LANES(s[1] * s[4]),
      rate_vw_c = rate_vw_a + rate_vw_b, rate_vw_d = KSL_RN_LANES(s[2] * s[5]),
      rate_vw = rate_vw_c + rate_vw_d;
  const ksl_states rate_bend_a = b_rate * rate_vw, rate_bend = -rate_bend_a;
  const ksl_states rate_q_0a = KSL_RN_LANES(0.5 * s[0]), rate_q_1 = -rate_q_0a;
  const ksl_states rate_q_1a = KSL_RN_LANES(0.5 * s[1]), rate_q_2 = -rate_q_1a;
  const ksl_states rate_q_2a = KSL_RN_LANES(0.5 * s[2]), rate_q_3 = -rate_q_2a;
  const ksl_states rate_beta_v_1 = s[0] * b;
  const ksl_states rate_beta_v_2 = s[1] * b;
  const ksl_states rate_beta_v_3 = s[2] * b;
  const ksl_states rate_bend_w_1 = s[3] * rate_bend;
  const ksl_states rate_bend_w_2 = s[4] * rate_bend;
  const ksl_states rate_symmetric_0a = KSL_RN_LANES(s[3] * rate_beta_v_2),
      rate_symmetric_0b = KSL_RN_LANES(s[4] * rate_beta_v_1),
      rate_symmetric_0c = rate_symmetric_0a + rate_symmetric_0b,
      rate_symmetric_0d = KSL_RN_LANES(s[4] * rate_bend_w_1),
      rate_symmetric_1 = rate_symmetric_0c - rate_symmetric_0d;
  const ksl_states rate_symmetric_1a = KSL_RN_LANES(s[3] * rate_beta_v_3),
      rate_symmetric_1b = KSL_RN_LANES(s[5] * rate_beta_v_1),
      rate_symmetric_1c = rate_symmetric_1a + rate_symmetric_1b,
      rate_symmetric_1d = KSL_RN_LANES(s[5] * rate_bend_w_1),
      rate_symmetric_2 = rate_symmetric_1c - rate_symmetric_1d;
  const ksl_states rate_symmetric_2a = KSL_RN_LANES(s[4] * rate_beta_v_3),
      rate_symmetric_2b = KSL_RN_LANES(s[5] * rate_beta_v_2),
      rate_symmetric_2c = rate_symmetric_2a + rate_symmetric_2b,
      rate_symmetric_2d = KSL_RN_LANES(s[5] * rate_bend_w_2),
      rate_symmetric_3 = rate_symmetric_2c - rate_symmetric_2d;
  const ksl_states rate_diagonal_0a = KSL_RN_LANES(s[4] * rate_bend_w_2),
      rate_diagonal_0b = KSL_RN_LANES(s[5] * (s[5] * rate_bend)),
      rate_diagonal_0c = rate_diagonal_0a + rate_diagonal_0b, rate_diagonal_0d = 2.0 * s[4],
      rate_diagonal_0e = KSL_RN_LANES(rate_diagonal_0d * rate_beta_v_2), rate_diagonal_0f = 2.0 *
          s[5],
      rate_diagonal_0g = KSL_RN_LANES(rate_diagonal_0f * rate_beta_v_3),
      rate_diagonal_0h = rate_diagonal_0e + rate_diagonal_0g,
      rate_diagonal_1 = rate_diagonal_0c - rate_diagonal_0h;
  const ksl_states rate_diagonal_1a = KSL_RN_LANES(s[3] * rate_bend_w_1),
      rate_diagonal_1b = rate_diagonal_1a + rate_diagonal_0b, rate_diagonal_1c = 2.0 * s[3],
      rate_diagonal_1d = KSL_RN_LANES(rate_diagonal_1c * rate_beta_v_1),
      rate_diagonal_1e = rate_diagonal_1d + rate_diagonal_0g,
      rate_diagonal_2 = rate_diagonal_1b - rate_diagonal_1e;
  const ksl_states rate_diagonal_2a = rate_diagonal_1a + rate_diagonal_0a,
      rate_diagonal_2b = rate_diagonal_1d + rate_diagonal_0e,
      rate_diagonal_3 = rate_diagonal_2a - rate_diagonal_2b;
  const ksl_states M_1 = rate_symmetric_1 - rate_q_3;
  const ksl_states M_2 = rate_q_2 + rate_symmetric_2;
  const ksl_states M_3 = rate_q_3 + rate_symmetric_1;
  const ksl_states M_4 = rate_symmetric_3 - rate_q_1;
  const ksl_states M_5 = rate_symmetric_2 - rate_q_2;
  const ksl_states M_6 = rate_q_1 + rate_symmetric_3;
  M[0] = diagonal0;
  M[6] = J_1;
  M[12] = J_2;
  M[18] = rate_diagonal_1;
  M[24] = M_1;
  M[30] = M_2;
  M[1] = J_3;
  M[7] = diagonal1;
  M[13] = J_4;
  M[19] = M_3;
  M[25] = rate_diagonal_2;
  M[31] = M_4;
  M[2] = J_5;
  M[8] = J_6;
  M[14] = diagonal2;
  M[20] = M_5;
  M[26] = M_6;
  M[32] = rate_diagonal_3;
  M[3] = ksl_each_lanes(0.0);
  M[9] = ksl_each_lanes(0.0);
  M[15] = ksl_each_lanes(0.0);
  M[21] = diagonal0;
  M[27] = J_1;
  M[33] = J_2;
  M[4] = ksl_each_lanes(0.0);
  M[10] = ksl_each_lanes(0.0);
  M[16] = ksl_each_lanes(0.0);
  M[22] = J_3;
  M[28] = diagonal1;
  M[34] = J_4;
  M[5] = ksl_each_lanes(0.0);
  M[11] = ksl_each_lanes(0.0);
  M[17] = ksl_each_lanes(0.0);
  M[23] = J_5;
  M[29] = J_6;
  M[35] = diagonal2;
}

static KSL_INLINE void ksl_SE3_rightJacobianInverse_states(const ksl_states *s, ksl_states *M) {
  const ksl_states sizes_a = ksl_abs_lanes(s[3]) + ksl_abs_lanes(s[4]),
      sizes = sizes_a + ksl_abs_lanes(s[5]);
  const ksl_states grid = KSL_RN_LANES(sizes * 268435456.0);
  const ksl_states high_1 = s[3] + grid - grid;
  const ksl_states high_2 = s[4] + grid - grid;
  const ksl_states high_3 = s[5] + grid - grid;
  const ksl_states squares_a = KSL_RN_LANES(high_1 * high_1), squares_b = KSL_RN_LANES(high_2 *
      high_2),
      squares_c = squares_a + squares_b, squares_d = KSL_RN_LANES(high_3 * high_3),
      squares = squares_c + squares_d;
  const ksl_states cross_a = KSL_RN_LANES((s[3] - high_1) * (s[3] + high_1)),
      cross_b = KSL_RN_LANES((s[4] - high_2) * (s[4] + high_2)), cross_c = cross_a + cross_b,
      cross_d = KSL_RN_LANES((s[5] - high_3) * (s[5] + high_3)), cross = cross_c + cross_d;
  const ksl_states x = squares + cross;
  const ksl_states theta_a = ksl_sqrt_lanes(x);
  const ksl_tests theta_b = ksl_less_lanes(x, ksl_each_lanes(1.0));
  const ksl_states theta = ksl_choice_lanes(theta_b, ksl_each_lanes(1.0), theta_a);
  const ksl_states theta_shifted = grid + theta;
  const ksl_states theta_high = theta_shifted - grid;
  const ksl_states theta_low = theta - theta_high;
  const ksl_states theta_sum = theta + theta_high;
  const ksl_states cross_rest_a = KSL_RN_LANES(theta_low * theta_sum), cross_rest = cross -
      cross_rest_a;
  const ksl_states exact_a = KSL_RN_LANES(theta_high * theta_high), exact = squares - exact_a;
  const ksl_states residual = cross_rest + exact;
  const ksl_states small_a = 0.5 * residual, small = small_a / theta;
  const ksl_states delta_a = ksl_abs_lanes(small);
  const ksl_tests delta_b = ksl_less_lanes(delta_a, ksl_each_lanes(0.0078125));
  const ksl_states delta = ksl_choice_lanes(delta_b, small, ksl_each_lanes(0.0));
  ksl_states far_cosine_a; const ksl_states far_sine_a = ksl_sincos_lanes(theta, &far_cosine_a);
  const ksl_states far_sine = ksl_choice_lanes(theta_b, ksl_each_lanes(1.0), far_sine_a);
  const ksl_states far_cosine = ksl_choice_lanes(theta_b, ksl_each_lanes(0.0), far_cosine_a);
  const ksl_states sine_a = KSL_RN_LANES(delta * far_cosine), sine = sine_a + far_sine;
  const ksl_states cosine_a = KSL_RN_LANES(delta * far_sine), cosine = far_cosine - cosine_a;
  const ksl_states above_a = cosine + 1.0;
  const ksl_tests above_b = ksl_less_lanes(cosine, ksl_each_lanes(0.0));
  const ksl_states above = ksl_choice_lanes(above_b, sine, above_a);
  const ksl_states below_a = 1.0 - cosine, below = ksl_choice_lanes(above_b, below_a, sine);
  const ksl_states cotangent = above / below;
  const ksl_states half_cotangent_a = 0.5 * theta,
      half_cotangent = KSL_RN_LANES(half_cotangent_a * cotangent);
  const ksl_states b_rest = 1.0 - half_cotangent;
  const ksl_tests b_divisor_a = ksl_less_lanes(x, ksl_each_lanes(4.0));
  const ksl_states b_divisor = ksl_choice_lanes(b_divisor_a, ksl_each_lanes(4.0), x);
  const ksl_states closed_b = b_rest / b_divisor;
  const ksl_states b_a = KSL_RN_LANES(1.455172475614865e-27 * x), b_b = b_a + 5.744790668872202e-26,
      b_c = KSL_RN_LANES(x * b_b), b_d = b_c + 2.267952452337683e-24, b_e = KSL_RN_LANES(x * b_d),
      b_f = b_e + 8.953517427037546e-23, b_g = KSL_RN_LANES(x * b_f), b_h = b_g +
          3.534707039629467e-21,
      b_i = KSL_RN_LANES(x * b_h), b_j = b_i + 1.3954464685812522e-19, b_k = KSL_RN_LANES(x * b_j),
      b_l = b_k + 5.5090028283602295e-18, b_m = KSL_RN_LANES(x * b_l), b_n = b_m +
          2.174868698558062e-16,
      b_o = KSL_RN_LANES(x * b_n), b_p = b_o + 8.586062056277845e-15, b_q = KSL_RN_LANES(x * b_p),
      b_r = b_q + 3.3896802963225827e-13, b_s = KSL_RN_LANES(x * b_r), b_t = b_s +
          1.3382536530684679e-11,
      b_u = KSL_RN_LANES(x * b_t), b_v = b_u + 5.284190138687493e-10, b_w = KSL_RN_LANES(x * b_v),
      b_x = b_w + 2.08767569878681e-08, b_y = KSL_RN_LANES(x * b_x), b_z = b_y +
          8.267195767195768e-07,
      b_aa = KSL_RN_LANES(x * b_z), b_ab = b_aa + 3.306878306878307e-05, b_ac = KSL_RN_LANES(x *
          b_ab),
      b_ad = b_ac + 0.001388888888888889, b_ae = KSL_RN_LANES(x * b_ad), b_af = b_ae +
          0.08333333333333333,
      b = ksl_choice_lanes(b_divisor_a, b_af, closed_b);
  const ksl_states b_across_a = KSL_RN_LANES(x * b), b_across_b = 1.0 - b_across_a,
      b_across = ksl_choice_lanes(b_divisor_a, b_across_b, half_cotangent);
  const ksl_states beta_v_1 = s[3] * b;
  const ksl_states beta_v_2 = s[4] * b;
  const ksl_states m_1 = KSL_RN_LANES(s[3] * beta_v_1);
  const ksl_states m_2 = KSL_RN_LANES(s[4] * beta_v_2);
  const ksl_states m_3 = KSL_RN_LANES(s[5] * (s[5] * b));
  const ksl_states m_4 = KSL_RN_LANES(s[4] * beta_v_1);
  const ksl_states m_5 = KSL_RN_LANES(s[5] * beta_v_1);
  const ksl_states m_6 = KSL_RN_LANES(s[5] * beta_v_2);
  const ksl_states others_1 = m_2 + m_3;
  const ksl_states others_2 = m_1 + m_3;
  const ksl_states others_3 = m_1 + m_2;
  const ksl_states diagonal0a = 1.0 - others_1, diagonal0b = b_across + m_1;
  const ksl_tests diagonal0c = ksl_less_lanes(m_1, others_1);
  const ksl_states diagonal0 = ksl_choice_lanes(diagonal0c, diagonal0b, diagonal0a);
  const ksl_states diagonal1a = 1.0 - others_2, diagonal1b = b_across + m_2;
  const ksl_tests diagonal1c = ksl_less_lanes(m_2, others_2);
  const ksl_states diagonal1 = ksl_choice_lanes(diagonal1c, diagonal1b, diagonal1a);
  const ksl_states diagonal2a = 1.0 - others_3, diagonal2b = b_across + m_3;
  const ksl_tests diagonal2c = ksl_less_lanes(m_3, others_3);
  const ksl_states diagonal2 = ksl_choice_lanes(diagonal2c, diagonal2b, diagonal2a);
  const ksl_states alpha_v_1 = KSL_RN_LANES(0.5 * s[3]);
  const ksl_states alpha_v_2 = KSL_RN_LANES(0.5 * s[4]);
  const ksl_states alpha_v_3 = KSL_RN_LANES(0.5 * s[5]);
  const ksl_states J_1 = m_4 - alpha_v_3;
  const ksl_states J_2 = m_5 + alpha_v_2;
  const ksl_states J_3 = m_4 + alpha_v_3;
  const ksl_states J_4 = m_6 - alpha_v_1;
  const ksl_states J_5 = m_5 - alpha_v_2;
  const ksl_states J_6 = m_6 + alpha_v_1;
  const ksl_states b_rate_across_a = 2.0 - half_cotangent,
      b_rate_across = b_rate_across_a / b_divisor;
  const ksl_states b_rate_square_a = cotangent * cotangent,
      b_rate_square_b = KSL_RN_LANES(0.25 * b_rate_square_a), b_rate_square = 0.25 +
          b_rate_square_b;
  const ksl_states b_rate_rest = b_rate_square - b_rate_across;
  const ksl_states closed_b_rate = b_rate_rest / b_divisor;
  const ksl_states b_rate_a = KSL_RN_LANES(3.3612243325542163e-29 * x),
      b_rate_b = b_rate_a + 1.2532382798262054e-27, b_rate_c = KSL_RN_LANES(x * b_rate_b),
      b_rate_d = b_rate_c + 4.656551921967568e-26, b_rate_e = KSL_RN_LANES(x * b_rate_d),
      b_rate_f = b_rate_e + 1.7234372006616606e-24, b_rate_g = KSL_RN_LANES(x * b_rate_f),
      b_rate_h = b_rate_g + 6.350266866545513e-23, b_rate_i = KSL_RN_LANES(x * b_rate_h),
      b_rate_j = b_rate_i + 2.327914531029762e-21, b_rate_k = KSL_RN_LANES(x * b_rate_j),
      b_rate_l = b_rate_k + 8.483296895110721e-20, b_rate_m = KSL_RN_LANES(x * b_rate_l),
      b_rate_n = b_rate_m + 3.069982230878755e-18, b_rate_o = KSL_RN_LANES(x * b_rate_n),
      b_rate_p = b_rate_o + 1.1018005656720459e-16, b_rate_q = KSL_RN_LANES(x * b_rate_p),
      b_rate_r = b_rate_q + 3.914763657404511e-15, b_rate_s = KSL_RN_LANES(x * b_rate_r),
      b_rate_t = b_rate_s + 1.3737699290044552e-13, b_rate_u = KSL_RN_LANES(x * b_rate_t),
      b_rate_v = b_rate_u + 4.745552414851616e-12, b_rate_w = KSL_RN_LANES(x * b_rate_v),
      b_rate_x = b_rate_w + 1.6059043836821613e-10, b_rate_y = KSL_RN_LANES(x * b_rate_x),
      b_rate_z = b_rate_y + 5.2841901386874934e-09, b_rate_aa = KSL_RN_LANES(x * b_rate_z),
      b_rate_ab = b_rate_aa + 1.670140559029448e-07, b_rate_ac = KSL_RN_LANES(x * b_rate_ab),
      b_rate_ad = b_rate_ac + 4.96031746031746e-06, b_rate_ae = KSL_RN_LANES(x * b_rate_ad),
      b_rate_af = b_rate_ae + 0.00013227513227513228, b_rate_ag = KSL_RN_LANES(x * b_rate_af),
      b_rate_ah = b_rate_ag + 0.002777777777777778,
      b_rate = ksl_choice_lanes(b_divisor_a, b_rate_ah, closed_b_rate);
  const ksl_states rate_vw_a = KSL_RN_LANES(s[0] * s[3]), rate_vw_b = KSL_RN_LANES(s[1] * s[4]),
      rate_vw_c = rate_vw_a + rate_vw_b, rate_vw_d = KSL_RN_LANES(s[2] * s[5]),
      rate_vw = rate_vw_c + rate_vw_d;
  const ksl_states rate_bend_a = b_rate * rate_vw, rate_bend = -rate_bend_a;
  const ksl_states rate_q_1 = KSL_RN_LANES(0.5 * s[0]);
  const ksl_states rate_q_2 = KSL_RN_LANES(0.5 * s[1]);
  const ksl_states rate_q_3 = KSL_RN_LANES(0.5 * s[2]);
  const ksl_states rate_beta_v_0a = s[0] * b, rate_beta_v_1 = -rate_beta_v_0a;
  const ksl_states rate_beta_v_1a = s[1] * b, rate_beta_v_2 = -rate_beta_v_1a;
  const ksl_states rate_beta_v_2a = s[2] * b, rate_beta_v_3 = -rate_beta_v_2a;
  const ksl_states rate_bend_w_0a = s[3] * rate_bend, rate_bend_w_1 = -rate_bend_w_0a;
  const ksl_states rate_bend_w_1a = s[4] * rate_bend, rate_bend_w_2 = -rate_bend_w_1a;
  const ksl_states rate_bend_w_2a = s[5] * rate_bend;
  const ksl_states rate_symmetric_0a = KSL_RN_LANES(s[4] * rate_bend_w_1),
      rate_symmetric_0b = KSL_RN_LANES(s[3] * rate_beta_v_2), rate_symmetric_0c = KSL_RN_LANES(s[4]
          * rate_beta_v_1),
      rate_symmetric_0d = rate_symmetric_0b + rate_symmetric_0c,
      rate_symmetric_1 = rate_symmetric_0a - rate_symmetric_0d;
  const ksl_states rate_symmetric_1a = KSL_RN_LANES(s[5] * rate_bend_w_1),
      rate_symmetric_1b = KSL_RN_LANES(s[3] * rate_beta_v_3), rate_symmetric_1c = KSL_RN_LANES(s[5]
          * rate_beta_v_1),
      rate_symmetric_1d = rate_symmetric_1b + rate_symmetric_1c,
      rate_symmetric_2 = rate_symmetric_1a - rate_symmetric_1d;
  const ksl_states rate_symmetric_2a = KSL_RN_LANES(s[5] * rate_bend_w_2),
      rate_symmetric_2b = KSL_RN_LANES(s[4] * rate_beta_v_3), rate_symmetric_2c = KSL_RN_LANES(s[5]
          * rate_beta_v_2),
      rate_symmetric_2d = rate_symmetric_2b + rate_symmetric_2c,
      rate_symmetric_3 = rate_symmetric_2a - rate_symmetric_2d;
  const ksl_states rate_diagonal_0a = 2.0 * s[4],
      rate_diagonal_0b = KSL_RN_LANES(rate_diagonal_0a * rate_beta_v_2), rate_diagonal_0c = 2.0 *
          s[5],
      rate_diagonal_0d = KSL_RN_LANES(rate_diagonal_0c * rate_beta_v_3),
      rate_diagonal_0e = rate_diagonal_0b + rate_diagonal_0d,
      rate_diagonal_0f = KSL_RN_LANES(s[4] * rate_bend_w_2), rate_diagonal_0g = KSL_RN_LANES(s[5] *
          -rate_bend_w_2a),
      rate_diagonal_0h = rate_diagonal_0f + rate_diagonal_0g,
      rate_diagonal_1 = rate_diagonal_0e - rate_diagonal_0h;
  const ksl_states rate_diagonal_1a = 2.0 * s[3],
      rate_diagonal_1b = KSL_RN_LANES(rate_diagonal_1a * rate_beta_v_1),
      rate_diagonal_1c = rate_diagonal_1b + rate_diagonal_0d,
      rate_diagonal_1d = KSL_RN_LANES(s[3] * rate_bend_w_1),
      rate_diagonal_1e = rate_diagonal_1d + rate_diagonal_0g,
      rate_diagonal_2 = rate_diagonal_1c - rate_diagonal_1e;
  const ksl_states rate_diagonal_2a = rate_diagonal_1b + rate_diagonal_0b,
      rate_diagonal_2b = rate_diagonal_1d + rate_diagonal_0f,
      rate_diagonal_3 = rate_diagonal_2a - rate_diagonal_2b;
  const ksl_states M_1 = rate_symmetric_1 - rate_q_3;
  const ksl_states M_2 = rate_q_2 + rate_symmetric_2;
  const ksl_states M_3 = rate_q_3 + rate_symmetric_1;
  const ksl_states M_4 = rate_symmetric_3 - rate_q_1;
  const ksl_states M_5 = rate_symmetric_2 - rate_q_2;
  const ksl_states M_6 = rate_q_1 + rate_symmetric_3;
  M[0] = diagonal0;
  M[6] = J_1;
  M[12] = J_2;
  M[18] = rate_diagonal_1;
  M[24] = M_1;
  M[30] = M_2;
  M[1] = J_3;
  M[7] = diagonal1;
  M[13] = J_4;
  M[19] = M_3;
  M[25] = rate_diagonal_2;
  M[31] = M_4;
  M[2] = J_5;
  M[8] = J_6;
  M[14] = diagonal2;
  M[20] = M_5;
  M[26] = M_6;
  M[32] = rate_diagonal_3;
  M[3] = ksl_each_lanes(0.0);
  M[9] = ksl_each_lanes(0.0);
  M[15] = ksl_each_lanes(0.0);
  M[21] = diagonal0;
  M[27] = J_1;
  M[33] = J_2;
  M[4] = ksl_each_lanes(0.0);
  M[10] = ksl_each_lanes(0.0);
  M[16] = ksl_each_lanes(0.0);
  M[22] = J_3;
  M[28] = diagonal1;
  M[34] = J_4;
  M[5] = ksl_each_lanes(0.0);
  M[11] = ksl_each_lanes(0.0);
  M[17] = ksl_each_lanes(0.0);
  M[23] = J_5;
  M[29] = J_6;
  M[35] = diagonal2;
}

static KSL_INLINE void ksl_SE3_interpolated_states(const ksl_states *D1, const ksl_states *D2,
    const ksl_states *k, ksl_states *Do) {
  const ksl_states apart_1 = D2[9] - D1[9];
  const ksl_states apart_2 = D2[10] - D1[10];
  const ksl_states apart_3 = D2[11] - D1[11];
  const ksl_states between_0a = KSL_RN_LANES(D1[0] * D2[0]), between_0b = KSL_RN_LANES(D1[1] *
      D2[1]),
      between_0c = between_0a + between_0b, between_0d = KSL_RN_LANES(D1[2] * D2[2]),
      between_1 = between_0c + between_0d;
  const ksl_states between_1a = KSL_RN_LANES(D1[0] * D2[3]), between_1b = KSL_RN_LANES(D1[1] *
      D2[4]),
      between_1c = between_1a + between_1b, between_1d = KSL_RN_LANES(D1[2] * D2[5]),
      between_2 = between_1c + between_1d;
  const ksl_states between_2a = KSL_RN_LANES(D1[0] * D2[6]), between_2b = KSL_RN_LANES(D1[1] *
      D2[7]),
      between_2c = between_2a + between_2b, between_2d = KSL_RN_LANES(D1[2] * D2[8]),
      between_3 = between_2c + between_2d;
  const ksl_states between_3a = KSL_RN_LANES(D1[0] * apart_1), between_3b = KSL_RN_LANES(D1[1] *
      apart_2),
      between_3c = between_3a + between_3b, between_3d = KSL_RN_LANES(D1[2] * apart_3),
      between_4 = between_3c + between_3d;
  const ksl_states between_4a = KSL_RN_LANES(D1[3] * D2[0]), between_4b = KSL_RN_LANES(D1[4] *
      D2[1]),
      between_4c = between_4a + between_4b, between_4d = KSL_RN_LANES(D1[5] * D2[2]),
      between_5 = between_4c + between_4d;
  const ksl_states between_5a = KSL_RN_LANES(D1[3] * D2[3]), between_5b = KSL_RN_LANES(D1[4] *
      D2[4]),
      between_5c = between_5a + between_5b, between_5d = KSL_RN_LANES(D1[5] * D2[5]),
      between_6 = between_5c + between_5d;
  const ksl_states between_6a = KSL_RN_LANES(D1[3] * D2[6]), between_6b = KSL_RN_LANES(D1[4] *
      D2[7]),
      between_6c = between_6a + between_6b, between_6d = KSL_RN_LANES(D1[5] * D2[8]),
      between_7 = between_6c + between_6d;
  const ksl_states between_7a = KSL_RN_LANES(D1[3] * apart_1), between_7b = KSL_RN_LANES(D1[4] *
      apart_2),
      between_7c = between_7a + between_7b, between_7d = KSL_RN_LANES(D1[5] * apart_3),
      between_8 = between_7c + between_7d;
  const ksl_states between_8a = KSL_RN_LANES(D1[6] * D2[0]), between_8b = KSL_RN_LANES(D1[7] *
      D2[1]),
      between_8c = between_8a + between_8b, between_8d = KSL_RN_LANES(D1[8] * D2[2]),
      between_9 = between_8c + between_8d;
  const ksl_states between_9a = KSL_RN_LANES(D1[6] * D2[3]), between_9b = KSL_RN_LANES(D1[7] *
      D2[4]),
      between_9c = between_9a + between_9b, between_9d = KSL_RN_LANES(D1[8] * D2[5]),
      between_10 = between_9c + between_9d;
  const ksl_states between_10a = KSL_RN_LANES(D1[6] * D2[6]), between_10b = KSL_RN_LANES(D1[7] *
      D2[7]),
      between_10c = between_10a + between_10b, between_10d = KSL_RN_LANES(D1[8] * D2[8]),
      between_11 = between_10c + between_10d;
  const ksl_states between_11a = KSL_RN_LANES(D1[6] * apart_1), between_11b = KSL_RN_LANES(D1[7] *
      apart_2),
      between_11c = between_11a + between_11b, between_11d = KSL_RN_LANES(D1[8] * apart_3),
      between_12 = between_11c + between_11d;
  const ksl_states log_p_1 = between_10 - between_7;
  const ksl_states log_p_2 = between_3 - between_9;
  const ksl_states log_p_3 = between_5 - between_2;
  const ksl_states log_s_1 = between_7 + between_10;
  const ksl_states log_s_2 = between_3 + between_9;
  const ksl_states log_s_3 = between_2 + between_5;
  const ksl_states log_first_1 = between_1 + 1.0;
  const ksl_states log_first_2 = 1.0 - between_1;
  const ksl_states log_others_1 = between_6 + between_11;
  const ksl_states log_others_2 = between_6 - between_11;
  const ksl_tests log_low_0a = ksl_less_lanes(between_6, between_1);
  const ksl_states log_high_0a = -between_6;
  const ksl_tests log_high_0b = ksl_less_lanes(between_1, log_high_0a);
  const ksl_tests log_column_0a = ksl_less_lanes(between_11, ksl_each_lanes(0.0));
  const ksl_states log_column_1 = ksl_choice_lanes(log_column_0a, ksl_choice_lanes(log_low_0a,
      log_first_1 - log_others_1, log_s_3), ksl_choice_lanes(log_high_0b, log_s_2, log_p_1));
  const ksl_states log_column_2 = ksl_choice_lanes(log_column_0a, ksl_choice_lanes(log_low_0a,
      log_s_3, log_first_2 + log_others_2), ksl_choice_lanes(log_high_0b, log_s_1, log_p_2));
  const ksl_states log_column_3 = ksl_choice_lanes(log_column_0a, ksl_choice_lanes(log_low_0a,
      log_s_2, log_s_1), ksl_choice_lanes(log_high_0b, log_first_2 - log_others_2, log_p_3));
  const ksl_states log_column_4 = ksl_choice_lanes(log_column_0a, ksl_choice_lanes(log_low_0a,
      log_p_1, log_p_2), ksl_choice_lanes(log_high_0b, log_p_3, log_first_1 + log_others_1));
  const ksl_states log_upper_0a = -log_column_1;
  const ksl_tests log_upper_0b = ksl_less_lanes(log_column_4, ksl_each_lanes(0.0));
  const ksl_states log_upper_1 = ksl_choice_lanes(log_upper_0b, log_upper_0a, log_column_1);
  const ksl_states log_upper_1a = -log_column_2,
      log_upper_2 = ksl_choice_lanes(log_upper_0b, log_upper_1a, log_column_2);
  const ksl_states log_upper_2a = -log_column_3,
      log_upper_3 = ksl_choice_lanes(log_upper_0b, log_upper_2a, log_column_3);
  const ksl_states log_upper_3a = -log_column_4,
      log_upper_4 = ksl_choice_lanes(log_upper_0b, log_upper_3a, log_column_4);
  const ksl_states log_v_s_size_1 = ksl_abs_lanes(log_upper_1);
  const ksl_states log_v_s_size_2 = ksl_abs_lanes(log_upper_2);
  const ksl_states log_v_s_size_3 = ksl_abs_lanes(log_upper_3);
  const ksl_tests log_v_s_largest1a = ksl_less_lanes(log_v_s_size_1, log_v_s_size_2);
  const ksl_states log_v_s_largest1 = ksl_choice_lanes(log_v_s_largest1a, log_v_s_size_2,
      log_v_s_size_1);
  const ksl_tests log_v_s_largest2a = ksl_less_lanes(log_v_s_largest1, log_v_s_size_3);
  const ksl_states log_v_s_largest2 = ksl_choice_lanes(log_v_s_largest2a, log_v_s_size_3,
      log_v_s_largest1);
  const ksl_tests log_v_s_a = ksl_less_lanes(ksl_each_lanes(6.703903964971299e+153),
      log_v_s_largest2);
  const ksl_states log_v_s_b = ksl_choice_lanes(log_v_s_a, ksl_each_lanes(3.7291703656001034e-155),
      ksl_each_lanes(1.0));
  const ksl_tests log_v_s_c = ksl_less_lanes(log_v_s_largest2, ksl_each_lanes(256.0));
  const ksl_states log_v_s_d = ksl_choice_lanes(log_v_s_c, ksl_each_lanes(1.3093562431584567e+151),
      log_v_s_b);
  const ksl_tests log_v_s_e = ksl_less_lanes(log_v_s_largest2,
      ksl_each_lanes(1.955159272639747e-149));
  const ksl_states log_v_s = ksl_choice_lanes(log_v_s_e, ksl_each_lanes(1.0715086071862673e+301),
      log_v_s_d);
  const ksl_states log_v_y_1 = log_upper_1 * log_v_s;
  const ksl_states log_v_y_2 = log_upper_2 * log_v_s;
  const ksl_states log_v_y_3 = log_upper_3 * log_v_s;
  const ksl_states log_v_n_a = KSL_RN_LANES(log_v_y_1 * log_v_y_1), log_v_n_b =
      KSL_RN_LANES(log_v_y_2 * log_v_y_2),
      log_v_n_c = log_v_n_a + log_v_n_b, log_v_n_d = KSL_RN_LANES(log_v_y_3 * log_v_y_3),
      log_v_n_e = log_v_n_c + log_v_n_d, log_v_n = ksl_sqrt_lanes(log_v_n_e);
  const ksl_tests log_v_r_a = ksl_less_lanes(log_v_s, ksl_each_lanes(1.0));
  const ksl_states log_v_r_b = ksl_choice_lanes(log_v_r_a, ksl_each_lanes(2.6815615859885194e+154),
      ksl_each_lanes(1.0));
  const ksl_tests log_v_r_c = ksl_less_lanes(ksl_each_lanes(1.0), log_v_s);
  const ksl_states log_v_r_d = ksl_choice_lanes(log_v_r_c, ksl_each_lanes(7.637340908749012e-152),
      log_v_r_b);
  const ksl_tests log_v_r_e = ksl_less_lanes(ksl_each_lanes(1.3093562431584567e+151), log_v_s);
  const ksl_states log_v_r = ksl_choice_lanes(log_v_r_e, ksl_each_lanes(9.332636185032189e-302),
      log_v_r_d);
  const ksl_states log_n = log_v_n * log_v_r;
  const ksl_states log_half = ksl_atan2_lanes(log_n, log_upper_4);
  const ksl_tests log_divisor_a = ksl_equal_lanes(log_n, ksl_each_lanes(0.0));
  const ksl_states log_divisor = ksl_choice_lanes(log_divisor_a, ksl_each_lanes(1.0), log_n);
  const ksl_states log_theta = 2.0 * log_half;
  const ksl_states log_k = log_theta / log_divisor;
  const ksl_states log_vector_1 = log_upper_1 * log_k;
  const ksl_states log_vector_2 = log_upper_2 * log_k;
  const ksl_states log_vector_3 = log_upper_3 * log_k;
  const ksl_states log_x = log_theta * log_theta;
  const ksl_tests log_far_sine_a = ksl_less_lanes(log_x, ksl_each_lanes(1.0));
  const ksl_states log_far_sine = ksl_choice_lanes(log_far_sine_a, ksl_each_lanes(1.0), log_n);
  const ksl_states log_cotangent = log_upper_4 / log_far_sine;
  const ksl_states log_half_cotangent_a = 0.5 * log_theta,
      log_half_cotangent = KSL_RN_LANES(log_half_cotangent_a * log_cotangent);
  const ksl_states log_b_rest = 1.0 - log_half_cotangent;
  const ksl_tests log_b_divisor_a = ksl_less_lanes(log_x, ksl_each_lanes(4.0));
  const ksl_states log_b_divisor = ksl_choice_lanes(log_b_divisor_a, ksl_each_lanes(4.0), log_x);
  const ksl_states log_closed_b = log_b_rest / log_b_divisor;
  const ksl_states log_b_a = KSL_RN_LANES(1.455172475614865e-27 * log_x),
      log_b_b = log_b_a + 5.744790668872202e-26, log_b_c = KSL_RN_LANES(log_x * log_b_b),
      log_b_d = log_b_c + 2.267952452337683e-24, log_b_e = KSL_RN_LANES(log_x * log_b_d),
      log_b_f = log_b_e + 8.953517427037546e-23, log_b_g = KSL_RN_LANES(log_x * log_b_f),
      log_b_h = log_b_g + 3.534707039629467e-21, log_b_i = KSL_RN_LANES(log_x * log_b_h),
      log_b_j = log_b_i + 1.3954464685812522e-19, log_b_k = KSL_RN_LANES(log_x * log_b_j),
      log_b_l = log_b_k + 5.5090028283602295e-18, log_b_m = KSL_RN_LANES(log_x * log_b_l),
      log_b_n = log_b_m + 2.174868698558062e-16, log_b_o = KSL_RN_LANES(log_x * log_b_n),
      log_b_p = log_b_o + 8.586062056277845e-15, log_b_q = KSL_RN_LANES(log_x * log_b_p),
      log_b_r = log_b_q + 3.3896802963225827e-13, log_b_s = KSL_RN_LANES(log_x * log_b_r),
      log_b_t = log_b_s + 1.3382536530684679e-11, log_b_u = KSL_RN_LANES(log_x * log_b_t),
      log_b_v = log_b_u + 5.284190138687493e-10, log_b_w = KSL_RN_LANES(log_x * log_b_v),
      log_b_x = log_b_w + 2.08767569878681e-08, log_b_y = KSL_RN_LANES(log_x * log_b_x),
      log_b_z = log_b_y + 8.267195767195768e-07, log_b_aa = KSL_RN_LANES(log_x * log_b_z),
      log_b_ab = log_b_aa + 3.306878306878307e-05, log_b_ac = KSL_RN_LANES(log_x * log_b_ab),
      log_b_ad = log_b_ac + 0.001388888888888889, log_b_ae = KSL_RN_LANES(log_x * log_b_ad),
      log_b_af = log_b_ae + 0.08333333333333333,
      log_b = ksl_choice_lanes(log_b_divisor_a, log_b_af, log_closed_b);
  const ksl_states log_b_across_a = KSL_RN_LANES(log_x * log_b), log_b_across_b = 1.0 -
      log_b_across_a,
      log_b_across = ksl_choice_lanes(log_b_divisor_a, log_b_across_b, log_half_cotangent);
  const ksl_states log_wt_a = KSL_RN_LANES(between_4 * log_vector_1), log_wt_b =
      KSL_RN_LANES(between_8 * log_vector_2),
      log_wt_c = log_wt_a + log_wt_b, log_wt_d = KSL_RN_LANES(between_12 * log_vector_3),
      log_wt = log_wt_c + log_wt_d;
  const ksl_states log_pitch = log_b * log_wt;
  const ksl_states log_u_0a = KSL_RN_LANES(between_12 * log_vector_2),
      log_u_0b = KSL_RN_LANES(between_8 * log_vector_3);
  const ksl_states log_u_1a = KSL_RN_LANES(between_4 * log_vector_3),
      log_u_1b = KSL_RN_LANES(between_12 * log_vector_1);
  const ksl_states log_u_2a = KSL_RN_LANES(between_8 * log_vector_1), log_u_2b =
      KSL_RN_LANES(between_4 * log_vector_2);
  const ksl_states whole_0a = KSL_RN_LANES(between_4 * log_b_across);
  const ksl_states whole_1a = KSL_RN_LANES(between_8 * log_b_across);
  const ksl_states whole_2a = KSL_RN_LANES(between_12 * log_b_across);
  const ksl_states screw_1 = k[0]
          * (whole_0a + (KSL_RN_LANES(log_vector_1 * log_pitch) - KSL_RN_LANES(0.5 * (log_u_0a -
              log_u_0b))));
  const ksl_states screw_2 = k[0]
          * (whole_1a + (KSL_RN_LANES(log_vector_2 * log_pitch) - KSL_RN_LANES(0.5 * (log_u_1a -
              log_u_1b))));
  const ksl_states screw_3 = k[0]
          * (whole_2a + (KSL_RN_LANES(log_vector_3 * log_pitch) - KSL_RN_LANES(0.5 * (log_u_2a -
              log_u_2b))));
  const ksl_states screw_4 = KSL_RN_LANES(k[0] * log_vector_1);
  const ksl_states screw_5 = KSL_RN_LANES(k[0] * log_vector_2);
  const ksl_states screw_6 = KSL_RN_LANES(k[0] * log_vector_3);
  const ksl_states exp_sizes_a = ksl_abs_lanes(screw_4) + ksl_abs_lanes(screw_5),
      exp_sizes = exp_sizes_a + ksl_abs_lanes(screw_6);
  const ksl_states exp_grid = KSL_RN_LANES(exp_sizes * 268435456.0);
  const ksl_states exp_high_1 = screw_4 + exp_grid - exp_grid;
  const ksl_states exp_high_2 = screw_5 + exp_grid - exp_grid;
  const ksl_states exp_high_3 = screw_6 + exp_grid - exp_grid;
  const ksl_states exp_squares_a = KSL_RN_LANES(exp_high_1 * exp_high_1),
      exp_squares_b = KSL_RN_LANES(exp_high_2 * exp_high_2), exp_squares_c = exp_squares_a +
          exp_squares_b,
      exp_squares_d = KSL_RN_LANES(exp_high_3 * exp_high_3), exp_squares = exp_squares_c +
          exp_squares_d;
  const ksl_states exp_cross_a = KSL_RN_LANES((screw_4 - exp_high_1) * (screw_4 + exp_high_1)),
      exp_cross_b = KSL_RN_LANES((screw_5 - exp_high_2) * (screw_5 + exp_high_2)),
      exp_cross_c = exp_cross_a + exp_cross_b,
      exp_cross_d = KSL_RN_LANES((screw_6 - exp_high_3) * (screw_6 + exp_high_3)),
      exp_cross = exp_cross_c + exp_cross_d;
  const ksl_states exp_x = exp_squares + exp_cross;
  const ksl_states exp_theta_a = ksl_sqrt_lanes(exp_x);
  const ksl_tests exp_theta_b = ksl_less_lanes(exp_x, ksl_each_lanes(1.0));
  const ksl_states exp_theta = ksl_choice_lanes(exp_theta_b, ksl_each_lanes(1.0), exp_theta_a);
  const ksl_states exp_theta_shifted = exp_grid + exp_theta;
  const ksl_states exp_theta_high = exp_theta_shifted - exp_grid;
  const ksl_states exp_theta_low = exp_theta - exp_theta_high;
  const ksl_states exp_theta_sum = exp_theta + exp_theta_high;
  const ksl_states exp_cross_rest_a = KSL_RN_LANES(exp_theta_low * exp_theta_sum),
      exp_cross_rest = exp_cross - exp_cross_rest_a;
  const ksl_states exp_exact_a = KSL_RN_LANES(exp_theta_high * exp_theta_high),
      exp_exact = exp_squares - exp_exact_a;
  const ksl_states exp_residual = exp_cross_rest + exp_exact;
  const ksl_states exp_small_a = 0.5 * exp_residual, exp_small = exp_small_a / exp_theta;
  const ksl_states exp_delta_a = ksl_abs_lanes(exp_small);
  const ksl_tests exp_delta_b = ksl_less_lanes(exp_delta_a, ksl_each_lanes(0.0078125));
  const ksl_states exp_delta = ksl_choice_lanes(exp_delta_b, exp_small, ksl_each_lanes(0.0));
  ksl_states exp_far_cosine_a; const ksl_states exp_far_sine_a = ksl_sincos_lanes(exp_theta,
      &exp_far_cosine_a);
  const ksl_states exp_far_sine = ksl_choice_lanes(exp_theta_b, ksl_each_lanes(1.0),
      exp_far_sine_a);
  const ksl_states exp_far_cosine = ksl_choice_lanes(exp_theta_b, ksl_each_lanes(0.0),
      exp_far_cosine_a);
  const ksl_states exp_sine_a = KSL_RN_LANES(exp_delta * exp_far_cosine),
      exp_sine = exp_sine_a + exp_far_sine;
  const ksl_states exp_cosine_a = KSL_RN_LANES(exp_delta * exp_far_sine),
      exp_cosine = exp_far_cosine - exp_cosine_a;
  const ksl_states exp_far_x = ksl_choice_lanes(exp_theta_b, ksl_each_lanes(1.0), exp_x);
  const ksl_tests exp_middle_x_a = ksl_less_lanes(exp_x, ksl_each_lanes(4.0));
  const ksl_states exp_middle_x = ksl_choice_lanes(exp_middle_x_a, ksl_each_lanes(4.0), exp_x);
  const ksl_states exp_closed1 = exp_sine / exp_theta;
  const ksl_states exp_versine = 1.0 - exp_cosine;
  const ksl_states exp_closed2 = exp_versine / exp_far_x;
  const ksl_states exp_rest3 = 1.0 - exp_closed1;
  const ksl_states exp_closed3 = exp_rest3 / exp_middle_x;
  const ksl_states exp_g1a = KSL_RN_LANES(6.446950284384474e-26 * exp_x),
      exp_g1b = exp_g1a - 3.868170170630684e-23, exp_g1c = KSL_RN_LANES(exp_x * exp_g1b),
      exp_g1d = exp_g1c + 1.9572941063391263e-20, exp_g1e = KSL_RN_LANES(exp_x * exp_g1d),
      exp_g1f = exp_g1e - 8.22063524662433e-18, exp_g1g = KSL_RN_LANES(exp_x * exp_g1f),
      exp_g1h = exp_g1g + 2.8114572543455206e-15, exp_g1i = KSL_RN_LANES(exp_x * exp_g1h),
      exp_g1j = exp_g1i - 7.647163731819816e-13, exp_g1k = KSL_RN_LANES(exp_x * exp_g1j),
      exp_g1l = exp_g1k + 1.6059043836821613e-10, exp_g1m = KSL_RN_LANES(exp_x * exp_g1l),
      exp_g1n = exp_g1m - 2.505210838544172e-08, exp_g1o = KSL_RN_LANES(exp_x * exp_g1n),
      exp_g1p = exp_g1o + 2.7557319223985893e-06, exp_g1q = KSL_RN_LANES(exp_x * exp_g1p),
      exp_g1r = exp_g1q - 0.0001984126984126984, exp_g1s = KSL_RN_LANES(exp_x * exp_g1r),
      exp_g1t = exp_g1s + 0.008333333333333333, exp_g1u = KSL_RN_LANES(exp_x * exp_g1t),
      exp_g1v = exp_g1u - 0.16666666666666666, exp_g1w = KSL_RN_LANES(exp_x * exp_g1v),
      exp_g1x = exp_g1w + 1.0, exp_g1 = ksl_choice_lanes(exp_theta_b, exp_g1x, exp_closed1);
  const ksl_states exp_g2a = KSL_RN_LANES(2.4795962632247976e-27 * exp_x),
      exp_g2b = exp_g2a - 1.6117375710961184e-24, exp_g2c = KSL_RN_LANES(exp_x * exp_g2b),
      exp_g2d = exp_g2c + 8.896791392450574e-22, exp_g2e = KSL_RN_LANES(exp_x * exp_g2d),
      exp_g2f = exp_g2e - 4.110317623312165e-19, exp_g2g = KSL_RN_LANES(exp_x * exp_g2f),
      exp_g2h = exp_g2g + 1.5619206968586225e-16, exp_g2i = KSL_RN_LANES(exp_x * exp_g2h),
      exp_g2j = exp_g2i - 4.779477332387385e-14, exp_g2k = KSL_RN_LANES(exp_x * exp_g2j),
      exp_g2l = exp_g2k + 1.1470745597729725e-11, exp_g2m = KSL_RN_LANES(exp_x * exp_g2l),
      exp_g2n = exp_g2m - 2.08767569878681e-09, exp_g2o = KSL_RN_LANES(exp_x * exp_g2n),
      exp_g2p = exp_g2o + 2.755731922398589e-07, exp_g2q = KSL_RN_LANES(exp_x * exp_g2p),
      exp_g2r = exp_g2q - 2.48015873015873e-05, exp_g2s = KSL_RN_LANES(exp_x * exp_g2r),
      exp_g2t = exp_g2s + 0.001388888888888889, exp_g2u = KSL_RN_LANES(exp_x * exp_g2t),
      exp_g2v = exp_g2u - 0.041666666666666664, exp_g2w = KSL_RN_LANES(exp_x * exp_g2v),
      exp_g2x = exp_g2w + 0.5, exp_g2 = ksl_choice_lanes(exp_theta_b, exp_g2x, exp_closed2);
  const ksl_states exp_g3a = KSL_RN_LANES(9.183689863795546e-29 * exp_x),
      exp_g3b = exp_g3a - 6.446950284384474e-26, exp_g3c = KSL_RN_LANES(exp_x * exp_g3b),
      exp_g3d = exp_g3c + 3.868170170630684e-23, exp_g3e = KSL_RN_LANES(exp_x * exp_g3d),
      exp_g3f = exp_g3e - 1.9572941063391263e-20, exp_g3g = KSL_RN_LANES(exp_x * exp_g3f),
      exp_g3h = exp_g3g + 8.22063524662433e-18, exp_g3i = KSL_RN_LANES(exp_x * exp_g3h),
      exp_g3j = exp_g3i - 2.8114572543455206e-15, exp_g3k = KSL_RN_LANES(exp_x * exp_g3j),
      exp_g3l = exp_g3k + 7.647163731819816e-13, exp_g3m = KSL_RN_LANES(exp_x * exp_g3l),
      exp_g3n = exp_g3m - 1.6059043836821613e-10, exp_g3o = KSL_RN_LANES(exp_x * exp_g3n),
      exp_g3p = exp_g3o + 2.505210838544172e-08, exp_g3q = KSL_RN_LANES(exp_x * exp_g3p),
      exp_g3r = exp_g3q - 2.7557319223985893e-06, exp_g3s = KSL_RN_LANES(exp_x * exp_g3r),
      exp_g3t = exp_g3s + 0.0001984126984126984, exp_g3u = KSL_RN_LANES(exp_x * exp_g3t),
      exp_g3v = exp_g3u - 0.008333333333333333, exp_g3w = KSL_RN_LANES(exp_x * exp_g3v),
      exp_g3x = exp_g3w + 0.16666666666666666,
      exp_g3 = ksl_choice_lanes(exp_middle_x_a, exp_g3x, exp_closed3);
  const ksl_states exp_g0a = KSL_RN_LANES(exp_x * exp_g2), exp_g0b = 1.0 - exp_g0a,
      exp_g0 = ksl_choice_lanes(exp_theta_b, exp_g0b, exp_cosine);
  const ksl_states exp_u_0a = KSL_RN_LANES(screw_3 * screw_5), exp_u_0b = KSL_RN_LANES(screw_2 *
      screw_6);
  const ksl_states exp_u_1a = KSL_RN_LANES(screw_1 * screw_6), exp_u_1b = KSL_RN_LANES(screw_3 *
      screw_4);
  const ksl_states exp_u_2a = KSL_RN_LANES(screw_2 * screw_4), exp_u_2b = KSL_RN_LANES(screw_1 *
      screw_5);
  const ksl_states exp_wv_a = KSL_RN_LANES(screw_1 * screw_4), exp_wv_b = KSL_RN_LANES(screw_2 *
      screw_5),
      exp_wv_c = exp_wv_a + exp_wv_b, exp_wv_d = KSL_RN_LANES(screw_3 * screw_6),
      exp_wv = exp_wv_c + exp_wv_d;
  const ksl_states exp_pitch = exp_g3 * exp_wv;
  const ksl_states exp_beta_v_1 = screw_4 * exp_g2;
  const ksl_states exp_beta_v_2 = screw_5 * exp_g2;
  const ksl_states exp_m_1 = KSL_RN_LANES(screw_4 * exp_beta_v_1);
  const ksl_states exp_m_2 = KSL_RN_LANES(screw_5 * exp_beta_v_2);
  const ksl_states exp_m_3 = KSL_RN_LANES(screw_6 * (screw_6 * exp_g2));
  const ksl_states exp_m_4 = KSL_RN_LANES(screw_5 * exp_beta_v_1);
  const ksl_states exp_m_5 = KSL_RN_LANES(screw_6 * exp_beta_v_1);
  const ksl_states exp_m_6 = KSL_RN_LANES(screw_6 * exp_beta_v_2);
  const ksl_states exp_others_1 = exp_m_2 + exp_m_3;
  const ksl_states exp_others_2 = exp_m_1 + exp_m_3;
  const ksl_states exp_others_3 = exp_m_1 + exp_m_2;
  const ksl_states exp_diagonal0a = 1.0 - exp_others_1, exp_diagonal0b = exp_g0 + exp_m_1;
  const ksl_tests exp_diagonal0c = ksl_less_lanes(exp_m_1, exp_others_1);
  const ksl_states exp_diagonal0 = ksl_choice_lanes(exp_diagonal0c, exp_diagonal0b, exp_diagonal0a);
  const ksl_states exp_diagonal1a = 1.0 - exp_others_2, exp_diagonal1b = exp_g0 + exp_m_2;
  const ksl_tests exp_diagonal1c = ksl_less_lanes(exp_m_2, exp_others_2);
  const ksl_states exp_diagonal1 = ksl_choice_lanes(exp_diagonal1c, exp_diagonal1b, exp_diagonal1a);
  const ksl_states exp_diagonal2a = 1.0 - exp_others_3, exp_diagonal2b = exp_g0 + exp_m_3;
  const ksl_tests exp_diagonal2c = ksl_less_lanes(exp_m_3, exp_others_3);
  const ksl_states exp_diagonal2 = ksl_choice_lanes(exp_diagonal2c, exp_diagonal2b, exp_diagonal2a);
  const ksl_states exp_alpha_v_1 = KSL_RN_LANES(screw_4 * exp_g1);
  const ksl_states exp_alpha_v_2 = KSL_RN_LANES(screw_5 * exp_g1);
  const ksl_states exp_alpha_v_3 = KSL_RN_LANES(screw_6 * exp_g1);
  const ksl_states step_1 = exp_m_4 - exp_alpha_v_3;
  const ksl_states step_2 = exp_m_5 + exp_alpha_v_2;
  const ksl_states step_3a = KSL_RN_LANES(screw_1 * exp_g1),
      step_3 = step_3a + (KSL_RN_LANES(exp_g2 * (exp_u_0a - exp_u_0b)) + KSL_RN_LANES(screw_4 *
          exp_pitch));
  const ksl_states step_4 = exp_m_4 + exp_alpha_v_3;
  const ksl_states step_5 = exp_m_6 - exp_alpha_v_1;
  const ksl_states step_7a = KSL_RN_LANES(screw_2 * exp_g1),
      step_6 = step_7a + (KSL_RN_LANES(exp_g2 * (exp_u_1a - exp_u_1b)) + KSL_RN_LANES(screw_5 *
          exp_pitch));
  const ksl_states step_7 = exp_m_5 - exp_alpha_v_2;
  const ksl_states step_8 = exp_m_6 + exp_alpha_v_1;
  const ksl_states step_11a = KSL_RN_LANES(screw_3 * exp_g1),
      step_9 = step_11a + (KSL_RN_LANES(exp_g2 * (exp_u_2a - exp_u_2b)) + KSL_RN_LANES(screw_6 *
          exp_pitch));
  const ksl_states Do_00a = KSL_RN_LANES(D1[0] * exp_diagonal0), Do_00b = KSL_RN_LANES(D1[3] *
      step_4),
      Do_00c = KSL_RN_LANES(D1[6] * step_7), Do_00d = Do_00b + Do_00c, Do_1 = Do_00a + Do_00d;
  const ksl_states Do_01a = KSL_RN_LANES(D1[0] * step_1), Do_01b = KSL_RN_LANES(D1[6] * step_8),
      Do_01c = Do_01a + Do_01b, Do_01d = KSL_RN_LANES(D1[3] * exp_diagonal1), Do_2 = Do_01c +
          Do_01d;
  const ksl_states Do_02a = KSL_RN_LANES(D1[0] * step_2), Do_02b = KSL_RN_LANES(D1[3] * step_5),
      Do_02c = Do_02a + Do_02b, Do_02d = KSL_RN_LANES(D1[6] * exp_diagonal2), Do_3 = Do_02c +
          Do_02d;
  const ksl_states Do_03a = KSL_RN_LANES(D1[0] * step_3), Do_03b = KSL_RN_LANES(D1[3] * step_6),
      Do_03c = Do_03a + Do_03b, Do_03d = KSL_RN_LANES(D1[6] * step_9), Do_03e = Do_03c + Do_03d,
      Do_4 = Do_03e + D1[9];
  const ksl_states Do_10a = KSL_RN_LANES(D1[1] * exp_diagonal0), Do_10b = KSL_RN_LANES(D1[4] *
      step_4),
      Do_10c = KSL_RN_LANES(D1[7] * step_7), Do_10d = Do_10b + Do_10c, Do_5 = Do_10a + Do_10d;
  const ksl_states Do_11a = KSL_RN_LANES(D1[1] * step_1), Do_11b = KSL_RN_LANES(D1[7] * step_8),
      Do_11c = Do_11a + Do_11b, Do_11d = KSL_RN_LANES(D1[4] * exp_diagonal1), Do_6 = Do_11c +
          Do_11d;
  const ksl_states Do_12a = KSL_RN_LANES(D1[1] * step_2), Do_12b = KSL_RN_LANES(D1[4] * step_5),
      Do_12c = Do_12a + Do_12b, Do_12d = KSL_RN_LANES(D1[7] * exp_diagonal2), Do_7 = Do_12c +
          Do_12d;
  const ksl_states Do_13a = KSL_RN_LANES(D1[1] * step_3), Do_13b = KSL_RN_LANES(D1[4] * step_6),
      Do_13c = Do_13a + Do_13b, Do_13d = KSL_RN_LANES(D1[7] * step_9), Do_13e = Do_13c + Do_13d,
      Do_8 = Do_13e + D1[10];
  const ksl_states Do_20a = KSL_RN_LANES(D1[2] * exp_diagonal0), Do_20b = KSL_RN_LANES(D1[5] *
      step_4),
      Do_20c = KSL_RN_LANES(D1[8] * step_7), Do_20d = Do_20b + Do_20c, Do_9 = Do_20a + Do_20d;
  const ksl_states Do_21a = KSL_RN_LANES(D1[2] * step_1), Do_21b = KSL_RN_LANES(D1[8] * step_8),
      Do_21c = Do_21a + Do_21b, Do_21d = KSL_RN_LANES(D1[5] * exp_diagonal1), Do_10 = Do_21c +
          Do_21d;
  const ksl_states Do_22a = KSL_RN_LANES(D1[2] * step_2), Do_22b = KSL_RN_LANES(D1[5] * step_5),
      Do_22c = Do_22a + Do_22b, Do_22d = KSL_RN_LANES(D1[8] * exp_diagonal2), Do_11 = Do_22c +
          Do_22d;
  const ksl_states Do_23a = KSL_RN_LANES(D1[2] * step_3), Do_23b = KSL_RN_LANES(D1[5] * step_6),
      Do_23c = Do_23a + Do_23b, Do_23d = KSL_RN_LANES(D1[8] * step_9), Do_23e = Do_23c + Do_23d,
      Do_12 = Do_23e + D1[11];
  Do[0] = Do_1;
  Do[3] = Do_2;
  Do[6] = Do_3;
  Do[9] = Do_4;
  Do[1] = Do_5;
  Do[4] = Do_6;
  Do[7] = Do_7;
  Do[10] = Do_8;
  Do[2] = Do_9;
  Do[5] = Do_10;
  Do[8] = Do_11;
  Do[11] = Do_12;
}

static KSL_INLINE void ksl_SO3_expf_states(const ksl_statesf *v, ksl_statesf *R) {
  const ksl_statesf sizes_a = ksl_abs_lanesf(v[0]) + ksl_abs_lanesf(v[1]),
      sizes = sizes_a + ksl_abs_lanesf(v[2]);
  const ksl_statesf grid = KSL_RN_LANESF(sizes * 8192.0f);
  const ksl_statesf high_1 = v[0] + grid - grid;
  const ksl_statesf high_2 = v[1] + grid - grid;
  const ksl_statesf high_3 = v[2] + grid - grid;
  const ksl_statesf squares_a = KSL_RN_LANESF(high_1 * high_1), squares_b = KSL_RN_LANESF(high_2 *
      high_2),
      squares_c = squares_a + squares_b, squares_d = KSL_RN_LANESF(high_3 * high_3),
      squares = squares_c + squares_d;
  const ksl_statesf cross_a = KSL_RN_LANESF((v[0] - high_1) * (v[0] + high_1)),
      cross_b = KSL_RN_LANESF((v[1] - high_2) * (v[1] + high_2)), cross_c = cross_a + cross_b,
      cross_d = KSL_RN_LANESF((v[2] - high_3) * (v[2] + high_3)), cross = cross_c + cross_d;
  const ksl_statesf x = squares + cross;
  const ksl_statesf theta_a = ksl_sqrt_lanesf(x);
  const ksl_testsf theta_b = ksl_less_lanesf(x, ksl_each_lanesf(1.0f));
  const ksl_statesf theta = ksl_choice_lanesf(theta_b, ksl_each_lanesf(1.0f), theta_a);
  const ksl_statesf theta_shifted = grid + theta;
  const ksl_statesf theta_high = theta_shifted - grid;
  const ksl_statesf theta_low = theta - theta_high;
  const ksl_statesf theta_sum = theta + theta_high;
  const ksl_statesf cross_rest_a = KSL_RN_LANESF(theta_low * theta_sum), cross_rest = cross -
      cross_rest_a;
  const ksl_statesf exact_a = KSL_RN_LANESF(theta_high * theta_high), exact = squares - exact_a;
  const ksl_statesf residual = cross_rest + exact;
  const ksl_statesf small_a = 0.5f * residual, small = small_a / theta;
  const ksl_statesf delta_a = ksl_abs_lanesf(small);
  const ksl_testsf delta_b = ksl_less_lanesf(delta_a, ksl_each_lanesf(0.0078125f));
  const ksl_statesf delta = ksl_choice_lanesf(delta_b, small, ksl_each_lanesf(0.0f));
  ksl_statesf far_cosine_a; const ksl_statesf far_sine_a = ksl_sincos_lanesf(theta, &far_cosine_a);
  const ksl_statesf far_sine = ksl_choice_lanesf(theta_b, ksl_each_lanesf(1.0f), far_sine_a);
  const ksl_statesf far_cosine = ksl_choice_lanesf(theta_b, ksl_each_lanesf(0.0f), far_cosine_a);
  const ksl_statesf sine_a = KSL_RN_LANESF(delta * far_cosine), sine = sine_a + far_sine;
  const ksl_statesf cosine_a = KSL_RN_LANESF(delta * far_sine), cosine = far_cosine - cosine_a;
  const ksl_statesf far_x = ksl_choice_lanesf(theta_b, ksl_each_lanesf(1.0f), x);
  const ksl_statesf closed1 = sine / theta;
  const ksl_statesf versine = 1.0f - cosine;
  const ksl_statesf closed2 = versine / far_x;
  const ksl_statesf g1a = KSL_RN_LANESF(6.4469503e-26f * x), g1b = g1a - 3.8681703e-23f, g1c =
      KSL_RN_LANESF(x * g1b),
      g1d = g1c + 1.9572942e-20f, g1e = KSL_RN_LANESF(x * g1d), g1f = g1e - 8.220635e-18f, g1g =
          KSL_RN_LANESF(x * g1f),
      g1h = g1g + 2.8114574e-15f, g1i = KSL_RN_LANESF(x * g1h), g1j = g1i - 7.6471636e-13f, g1k =
          KSL_RN_LANESF(x * g1j),
      g1l = g1k + 1.6059044e-10f, g1m = KSL_RN_LANESF(x * g1l), g1n = g1m - 2.5052108e-08f, g1o =
          KSL_RN_LANESF(x * g1n),
      g1p = g1o + 2.7557319e-06f, g1q = KSL_RN_LANESF(x * g1p), g1r = g1q - 0.0001984127f, g1s =
          KSL_RN_LANESF(x * g1r),
      g1t = g1s + 0.008333334f, g1u = KSL_RN_LANESF(x * g1t), g1v = g1u - 0.16666667f, g1w =
          KSL_RN_LANESF(x * g1v),
      g1x = g1w + 1.0f, g1 = ksl_choice_lanesf(theta_b, g1x, closed1);
  const ksl_statesf g2a = KSL_RN_LANESF(2.4795963e-27f * x), g2b = g2a - 1.6117376e-24f, g2c =
      KSL_RN_LANESF(x * g2b),
      g2d = g2c + 8.896791e-22f, g2e = KSL_RN_LANESF(x * g2d), g2f = g2e - 4.1103176e-19f, g2g =
          KSL_RN_LANESF(x * g2f),
      g2h = g2g + 1.5619207e-16f, g2i = KSL_RN_LANESF(x * g2h), g2j = g2i - 4.7794773e-14f, g2k =
          KSL_RN_LANESF(x * g2j),
      g2l = g2k + 1.1470745e-11f, g2m = KSL_RN_LANESF(x * g2l), g2n = g2m - 2.0876756e-09f, g2o =
          KSL_RN_LANESF(x * g2n),
      g2p = g2o + 2.755732e-07f, g2q = KSL_RN_LANESF(x * g2p), g2r = g2q - 2.4801588e-05f, g2s =
          KSL_RN_LANESF(x * g2r),
      g2t = g2s + 0.0013888889f, g2u = KSL_RN_LANESF(x * g2t), g2v = g2u - 0.041666668f, g2w =
          KSL_RN_LANESF(x * g2v),
      g2x = g2w + 0.5f, g2 = ksl_choice_lanesf(theta_b, g2x, closed2);
  const ksl_statesf g0a = KSL_RN_LANESF(x * g2), g0b = 1.0f - g0a,
      g0 = ksl_choice_lanesf(theta_b, g0b, cosine);
  const ksl_statesf beta_v_1 = v[0] * g2;
  const ksl_statesf beta_v_2 = v[1] * g2;
  const ksl_statesf m_1 = KSL_RN_LANESF(v[0] * beta_v_1);
  const ksl_statesf m_2 = KSL_RN_LANESF(v[1] * beta_v_2);
  const ksl_statesf m_3 = KSL_RN_LANESF(v[2] * (v[2] * g2));
  const ksl_statesf m_4 = KSL_RN_LANESF(v[1] * beta_v_1);
  const ksl_statesf m_5 = KSL_RN_LANESF(v[2] * beta_v_1);
  const ksl_statesf m_6 = KSL_RN_LANESF(v[2] * beta_v_2);
  const ksl_statesf others_1 = m_2 + m_3;
  const ksl_statesf others_2 = m_1 + m_3;
  const ksl_statesf others_3 = m_1 + m_2;
  const ksl_statesf diagonal0a = 1.0f - others_1, diagonal0b = g0 + m_1;
  const ksl_testsf diagonal0c = ksl_less_lanesf(m_1, others_1);
  const ksl_statesf diagonal0 = ksl_choice_lanesf(diagonal0c, diagonal0b, diagonal0a);
  const ksl_statesf diagonal1a = 1.0f - others_2, diagonal1b = g0 + m_2;
  const ksl_testsf diagonal1c = ksl_less_lanesf(m_2, others_2);
  const ksl_statesf diagonal1 = ksl_choice_lanesf(diagonal1c, diagonal1b, diagonal1a);
  const ksl_statesf diagonal2a = 1.0f - others_3, diagonal2b = g0 + m_3;
  const ksl_testsf diagonal2c = ksl_less_lanesf(m_3, others_3);
  const ksl_statesf diagonal2 = ksl_choice_lanesf(diagonal2c, diagonal2b, diagonal2a);
  const ksl_statesf alpha_v_1 = KSL_RN_LANESF(v[0] * g1);
  const ksl_statesf alpha_v_2 = KSL_RN_LANESF(v[1] * g1);
  const ksl_statesf alpha_v_3 = KSL_RN_LANESF(v[2] * g1);
  const ksl_statesf R_1 = m_4 - alpha_v_3;
  const ksl_statesf R_2 = m_5 + alpha_v_2;
  const ksl_statesf R_3 = m_4 + alpha_v_3;
  const ksl_statesf R_4 = m_6 - alpha_v_1;
  const ksl_statesf R_5 = m_5 - alpha_v_2;
  const ksl_statesf R_6 = m_6 + alpha_v_1;
  R[0] = diagonal0;
  R[3] = R_1;
  R[6] = R_2;
  R[1] = R_3;
  R[4] = diagonal1;
  R[7] = R_4;
  R[2] = R_5;
  R[5] = R_6;
  R[8] = diagonal2;
}

static KSL_INLINE void ksl_SO3_logf_states(const ksl_statesf *R, ksl_statesf *vo) {
  const ksl_statesf p_1 = R[5] - R[7];
  const ksl_statesf p_2 = R[6] - R[2];
  const ksl_statesf p_3 = R[1] - R[3];
  const ksl_statesf s_1 = R[7] + R[5];
  const ksl_statesf s_2 = R[6] + R[2];
  const ksl_statesf s_3 = R[3] + R[1];
  const ksl_statesf first_1 = R[0] + 1.0f;
  const ksl_statesf first_2 = 1.0f - R[0];
  const ksl_statesf others_1 = R[4] + R[8];
  const ksl_statesf others_2 = R[4] - R[8];
  const ksl_testsf low_0a = ksl_less_lanesf(R[4], R[0]);
  const ksl_statesf high_0a = -R[4];
  const ksl_testsf high_0b = ksl_less_lanesf(R[0], high_0a);
  const ksl_testsf column_0a = ksl_less_lanesf(R[8], ksl_each_lanesf(0.0f));
  const ksl_statesf column_1 = ksl_choice_lanesf(column_0a, ksl_choice_lanesf(low_0a, first_1
          - others_1, s_3), ksl_choice_lanesf(high_0b, s_2, p_1));
  const ksl_statesf column_2 = ksl_choice_lanesf(column_0a, ksl_choice_lanesf(low_0a, s_3, first_2
          + others_2), ksl_choice_lanesf(high_0b, s_1, p_2));
  const ksl_statesf column_3 = ksl_choice_lanesf(column_0a, ksl_choice_lanesf(low_0a, s_2, s_1),
      ksl_choice_lanesf(high_0b, first_2 - others_2, p_3));
  const ksl_statesf column_4 = ksl_choice_lanesf(column_0a, ksl_choice_lanesf(low_0a, p_1, p_2),
      ksl_choice_lanesf(high_0b, p_3, first_1 + others_1));
  const ksl_statesf upper_0a = -column_1;
  const ksl_testsf upper_0b = ksl_less_lanesf(column_4, ksl_each_lanesf(0.0f));
  const ksl_statesf upper_1 = ksl_choice_lanesf(upper_0b, upper_0a, column_1);
  const ksl_statesf upper_1a = -column_2, upper_2 = ksl_choice_lanesf(upper_0b, upper_1a, column_2);
  const ksl_statesf upper_2a = -column_3, upper_3 = ksl_choice_lanesf(upper_0b, upper_2a, column_3);
  const ksl_statesf upper_3a = -column_4;
  const ksl_statesf v_s_size_1 = ksl_abs_lanesf(upper_1);
  const ksl_statesf v_s_size_2 = ksl_abs_lanesf(upper_2);
  const ksl_statesf v_s_size_3 = ksl_abs_lanesf(upper_3);
  const ksl_testsf v_s_largest1a = ksl_less_lanesf(v_s_size_1, v_s_size_2);
  const ksl_statesf v_s_largest1 = ksl_choice_lanesf(v_s_largest1a, v_s_size_2, v_s_size_1);
  const ksl_testsf v_s_largest2a = ksl_less_lanesf(v_s_largest1, v_s_size_3);
  const ksl_statesf v_s_largest2 = ksl_choice_lanesf(v_s_largest2a, v_s_size_3, v_s_largest1);
  const ksl_testsf v_s_a = ksl_less_lanesf(ksl_each_lanesf(4.611686e+18f), v_s_largest2);
  const ksl_statesf v_s_b = ksl_choice_lanesf(v_s_a, ksl_each_lanesf(2.7105054e-20f),
      ksl_each_lanesf(1.0f));
  const ksl_testsf v_s_c = ksl_less_lanesf(v_s_largest2, ksl_each_lanesf(256.0f));
  const ksl_statesf v_s_d = ksl_choice_lanesf(v_s_c, ksl_each_lanesf(1.8014399e+16f), v_s_b);
  const ksl_testsf v_s_e = ksl_less_lanesf(v_s_largest2, ksl_each_lanesf(1.4210855e-14f));
  const ksl_statesf v_s = ksl_choice_lanesf(v_s_e, ksl_each_lanesf(3.2451855e+32f), v_s_d);
  const ksl_statesf v_y_1 = upper_1 * v_s;
  const ksl_statesf v_y_2 = upper_2 * v_s;
  const ksl_statesf v_y_3 = upper_3 * v_s;
  const ksl_statesf v_n_a = KSL_RN_LANESF(v_y_1 * v_y_1), v_n_b = KSL_RN_LANESF(v_y_2 * v_y_2),
      v_n_c = v_n_a + v_n_b,
      v_n_d = KSL_RN_LANESF(v_y_3 * v_y_3), v_n_e = v_n_c + v_n_d, v_n = ksl_sqrt_lanesf(v_n_e);
  const ksl_testsf v_r_a = ksl_less_lanesf(v_s, ksl_each_lanesf(1.0f));
  const ksl_statesf v_r_b = ksl_choice_lanesf(v_r_a, ksl_each_lanesf(3.689349e+19f),
      ksl_each_lanesf(1.0f));
  const ksl_testsf v_r_c = ksl_less_lanesf(ksl_each_lanesf(1.0f), v_s);
  const ksl_statesf v_r_d = ksl_choice_lanesf(v_r_c, ksl_each_lanesf(5.551115e-17f), v_r_b);
  const ksl_testsf v_r_e = ksl_less_lanesf(ksl_each_lanesf(1.8014399e+16f), v_s);
  const ksl_statesf v_r = ksl_choice_lanesf(v_r_e, ksl_each_lanesf(3.081488e-33f), v_r_d);
  const ksl_statesf n = v_n * v_r;
  const ksl_statesf half = ksl_atan2_lanesf(n, ksl_choice_lanesf(upper_0b, upper_3a, column_4));
  const ksl_testsf divisor_a = ksl_equal_lanesf(n, ksl_each_lanesf(0.0f));
  const ksl_statesf divisor = ksl_choice_lanesf(divisor_a, ksl_each_lanesf(1.0f), n);
  const ksl_statesf theta = 2.0f * half;
  const ksl_statesf k = theta / divisor;
  const ksl_statesf vector_1 = KSL_RN_LANESF(upper_1 * k);
  const ksl_statesf vector_2 = KSL_RN_LANESF(upper_2 * k);
  const ksl_statesf vector_3 = KSL_RN_LANESF(upper_3 * k);
  vo[0] = vector_1;
  vo[1] = vector_2;
  vo[2] = vector_3;
}

static KSL_INLINE void ksl_SO3_leftJacobianf_states(const ksl_statesf *v, ksl_statesf *R) {
  const ksl_statesf sizes_a = ksl_abs_lanesf(v[0]) + ksl_abs_lanesf(v[1]),
      sizes = sizes_a + ksl_abs_lanesf(v[2]);
  const ksl_statesf grid = KSL_RN_LANESF(sizes * 8192.0f);
  const ksl_statesf high_1 = v[0] + grid - grid;
  const ksl_statesf high_2 = v[1] + grid - grid;
  const ksl_statesf high_3 = v[2] + grid - grid;
  const ksl_statesf squares_a = KSL_RN_LANESF(high_1 * high_1), squares_b = KSL_RN_LANESF(high_2 *
      high_2),
      squares_c = squares_a + squares_b, squares_d = KSL_RN_LANESF(high_3 * high_3),
      squares = squares_c + squares_d;
  const ksl_statesf cross_a = KSL_RN_LANESF((v[0] - high_1) * (v[0] + high_1)),
      cross_b = KSL_RN_LANESF((v[1] - high_2) * (v[1] + high_2)), cross_c = cross_a + cross_b,
      cross_d = KSL_RN_LANESF((v[2] - high_3) * (v[2] + high_3)), cross = cross_c + cross_d;
  const ksl_statesf x = squares + cross;
  const ksl_statesf theta_a = ksl_sqrt_lanesf(x);
  const ksl_testsf theta_b = ksl_less_lanesf(x, ksl_each_lanesf(1.0f));
  const ksl_statesf theta = ksl_choice_lanesf(theta_b, ksl_each_lanesf(1.0f), theta_a);
  const ksl_statesf theta_shifted = grid + theta;
  const ksl_statesf theta_high = theta_shifted - grid;
  const ksl_statesf theta_low = theta - theta_high;
  const ksl_statesf theta_sum = theta + theta_high;
  const ksl_statesf cross_rest_a = KSL_RN_LANESF(theta_low * theta_sum), cross_rest = cross -
      cross_rest_a;
  const ksl_statesf exact_a = KSL_RN_LANESF(theta_high * theta_high), exact = squares - exact_a;
  const ksl_statesf residual = cross_rest + exact;
  const ksl_statesf small_a = 0.5f * residual, small = small_a / theta;
  const ksl_statesf delta_a = ksl_abs_lanesf(small);
  const ksl_testsf delta_b = ksl_less_lanesf(delta_a, ksl_each_lanesf(0.0078125f));
  const ksl_statesf delta = ksl_choice_lanesf(delta_b, small, ksl_each_lanesf(0.0f));
  ksl_statesf far_cosine_a; const ksl_statesf far_sine_a = ksl_sincos_lanesf(theta, &far_cosine_a);
  const ksl_statesf far_sine = ksl_choice_lanesf(theta_b, ksl_each_lanesf(1.0f), far_sine_a);
  const ksl_statesf far_cosine = ksl_choice_lanesf(theta_b, ksl_each_lanesf(0.0f), far_cosine_a);
  const ksl_statesf sine_a = KSL_RN_LANESF(delta * far_cosine), sine = sine_a + far_sine;
  const ksl_statesf cosine_a = KSL_RN_LANESF(delta * far_sine), cosine = far_cosine - cosine_a;
  const ksl_statesf far_x = ksl_choice_lanesf(theta_b, ksl_each_lanesf(1.0f), x);
  const ksl_testsf middle_x_a = ksl_less_lanesf(x, ksl_each_lanesf(4.0f));
  const ksl_statesf middle_x = ksl_choice_lanesf(middle_x_a, ksl_each_lanesf(4.0f), x);
  const ksl_statesf closed1 = sine / theta;
  const ksl_statesf versine = 1.0f - cosine;
  const ksl_statesf closed2 = versine / far_x;
  const ksl_statesf rest3 = 1.0f - closed1;
  const ksl_statesf closed3 = rest3 / middle_x;
  const ksl_statesf g1a = KSL_RN_LANESF(6.4469503e-26f * x), g1b = g1a - 3.8681703e-23f, g1c =
      KSL_RN_LANESF(x * g1b),
      g1d = g1c + 1.9572942e-20f, g1e = KSL_RN_LANESF(x * g1d), g1f = g1e - 8.220635e-18f, g1g =
          KSL_RN_LANESF(x * g1f),
      g1h = g1g + 2.8114574e-15f, g1i = KSL_RN_LANESF(x * g1h), g1j = g1i - 7.6471636e-13f, g1k =
          KSL_RN_LANESF(x * g1j),
      g1l = g1k + 1.6059044e-10f, g1m = KSL_RN_LANESF(x * g1l), g1n = g1m - 2.5052108e-08f, g1o =
          KSL_RN_LANESF(x * g1n),
      g1p = g1o + 2.7557319e-06f, g1q = KSL_RN_LANESF(x * g1p), g1r = g1q - 0.0001984127f, g1s =
          KSL_RN_LANESF(x * g1r),
      g1t = g1s + 0.008333334f, g1u = KSL_RN_LANESF(x * g1t), g1v = g1u - 0.16666667f, g1w =
          KSL_RN_LANESF(x * g1v),
      g1x = g1w + 1.0f, g1 = ksl_choice_lanesf(theta_b, g1x, closed1);
  const ksl_statesf g2a = KSL_RN_LANESF(2.4795963e-27f * x), g2b = g2a - 1.6117376e-24f, g2c =
      KSL_RN_LANESF(x * g2b),
      g2d = g2c + 8.896791e-22f, g2e = KSL_RN_LANESF(x * g2d), g2f = g2e - 4.1103176e-19f, g2g =
          KSL_RN_LANESF(x * g2f),
      g2h = g2g + 1.5619207e-16f, g2i = KSL_RN_LANESF(x * g2h), g2j = g2i - 4.7794773e-14f, g2k =
          KSL_RN_LANESF(x * g2j),
      g2l = g2k + 1.1470745e-11f, g2m = KSL_RN_LANESF(x * g2l), g2n = g2m - 2.0876756e-09f, g2o =
          KSL_RN_LANESF(x * g2n),
      g2p = g2o + 2.755732e-07f, g2q = KSL_RN_LANESF(x * g2p), g2r = g2q - 2.4801588e-05f, g2s =
          KSL_RN_LANESF(x * g2r),
      g2t = g2s + 0.0013888889f, g2u = KSL_RN_LANESF(x * g2t), g2v = g2u - 0.041666668f, g2w =
          KSL_RN_LANESF(x * g2v),
      g2x = g2w + 0.5f, g2 = ksl_choice_lanesf(theta_b, g2x, closed2);
  const ksl_statesf g3a = KSL_RN_LANESF(9.18369e-29f * x), g3b = g3a - 6.4469503e-26f, g3c =
      KSL_RN_LANESF(x * g3b),
      g3d = g3c + 3.8681703e-23f, g3e = KSL_RN_LANESF(x * g3d), g3f = g3e - 1.9572942e-20f, g3g =
          KSL_RN_LANESF(x * g3f),
      g3h = g3g + 8.220635e-18f, g3i = KSL_RN_LANESF(x * g3h), g3j = g3i - 2.8114574e-15f, g3k =
          KSL_RN_LANESF(x * g3j),
      g3l = g3k + 7.6471636e-13f, g3m = KSL_RN_LANESF(x * g3l), g3n = g3m - 1.6059044e-10f, g3o =
          KSL_RN_LANESF(x * g3n),
      g3p = g3o + 2.5052108e-08f, g3q = KSL_RN_LANESF(x * g3p), g3r = g3q - 2.7557319e-06f, g3s =
          KSL_RN_LANESF(x * g3r),
      g3t = g3s + 0.0001984127f, g3u = KSL_RN_LANESF(x * g3t), g3v = g3u - 0.008333334f, g3w =
          KSL_RN_LANESF(x * g3v),
      g3x = g3w + 0.16666667f, g3 = ksl_choice_lanesf(middle_x_a, g3x, closed3);
  const ksl_statesf beta_v_1 = v[0] * g3;
  const ksl_statesf beta_v_2 = v[1] * g3;
  const ksl_statesf m_1 = KSL_RN_LANESF(v[0] * beta_v_1);
  const ksl_statesf m_2 = KSL_RN_LANESF(v[1] * beta_v_2);
  const ksl_statesf m_3 = KSL_RN_LANESF(v[2] * (v[2] * g3));
  const ksl_statesf m_4 = KSL_RN_LANESF(v[1] * beta_v_1);
  const ksl_statesf m_5 = KSL_RN_LANESF(v[2] * beta_v_1);
  const ksl_statesf m_6 = KSL_RN_LANESF(v[2] * beta_v_2);
  const ksl_statesf others_1 = m_2 + m_3;
  const ksl_statesf others_2 = m_1 + m_3;
  const ksl_statesf others_3 = m_1 + m_2;
  const ksl_statesf diagonal0a = 1.0f - others_1, diagonal0b = g1 + m_1;
  const ksl_testsf diagonal0c = ksl_less_lanesf(m_1, others_1);
  const ksl_statesf diagonal0 = ksl_choice_lanesf(diagonal0c, diagonal0b, diagonal0a);
  const ksl_statesf diagonal1a = 1.0f - others_2, diagonal1b = g1 + m_2;
  const ksl_testsf diagonal1c = ksl_less_lanesf(m_2, others_2);
  const ksl_statesf diagonal1 = ksl_choice_lanesf(diagonal1c, diagonal1b, diagonal1a);
  const ksl_statesf diagonal2a = 1.0f - others_3, diagonal2b = g1 + m_3;
  const ksl_testsf diagonal2c = ksl_less_lanesf(m_3, others_3);
  const ksl_statesf diagonal2 = ksl_choice_lanesf(diagonal2c, diagonal2b, diagonal2a);
  const ksl_statesf alpha_v_1 = KSL_RN_LANESF(v[0] * g2);
  const ksl_statesf alpha_v_2 = KSL_RN_LANESF(v[1] * g2);
  const ksl_statesf alpha_v_3 = KSL_RN_LANESF(v[2] * g2);
  const ksl_statesf R_1 = m_4 - alpha_v_3;
  const ksl_statesf R_2 = m_5 + alpha_v_2;
  const ksl_statesf R_3 = m_4 + alpha_v_3;
  const ksl_statesf R_4 = m_6 - alpha_v_1;
  const ksl_statesf R_5 = m_5 - alpha_v_2;
  const ksl_statesf R_6 = m_6 + alpha_v_1;
  R[0] = diagonal0;
  R[3] = R_1;
  R[6] = R_2;
  R[1] = R_3;
  R[4] = diagonal1;
  R[7] = R_4;
  R[2] = R_5;
  R[5] = R_6;
  R[8] = diagonal2;
}

static KSL_INLINE void ksl_SO3_rightJacobianf_states(const ksl_statesf *v, ksl_statesf *R) {
  const ksl_statesf sizes_a = ksl_abs_lanesf(v[0]) + ksl_abs_lanesf(v[1]),
      sizes = sizes_a + ksl_abs_lanesf(v[2]);
  const ksl_statesf grid = KSL_RN_LANESF(sizes * 8192.0f);
  const ksl_statesf high_1 = v[0] + grid - grid;
  const ksl_statesf high_2 = v[1] + grid - grid;
  const ksl_statesf high_3 = v[2] + grid - grid;
  const ksl_statesf squares_a = KSL_RN_LANESF(high_1 * high_1), squares_b = KSL_RN_LANESF(high_2 *
      high_2),
      squares_c = squares_a + squares_b, squares_d = KSL_RN_LANESF(high_3 * high_3),
      squares = squares_c + squares_d;
  const ksl_statesf cross_a = KSL_RN_LANESF((v[0] - high_1) * (v[0] + high_1)),
      cross_b = KSL_RN_LANESF((v[1] - high_2) * (v[1] + high_2)), cross_c = cross_a + cross_b,
      cross_d = KSL_RN_LANESF((v[2] - high_3) * (v[2] + high_3)), cross = cross_c + cross_d;
  const ksl_statesf x = squares + cross;
  const ksl_statesf theta_a = ksl_sqrt_lanesf(x);
  const ksl_testsf theta_b = ksl_less_lanesf(x, ksl_each_lanesf(1.0f));
  const ksl_statesf theta = ksl_choice_lanesf(theta_b, ksl_each_lanesf(1.0f), theta_a);
  const ksl_statesf theta_shifted = grid + theta;
  const ksl_statesf theta_high = theta_shifted - grid;
  const ksl_statesf theta_low = theta - theta_high;
  const ksl_statesf theta_sum = theta + theta_high;
  const ksl_statesf cross_rest_a = KSL_RN_LANESF(theta_low * theta_sum), cross_rest = cross -
      cross_rest_a;
  const ksl_statesf exact_a = KSL_RN_LANESF(theta_high * theta_high), exact = squares - exact_a;
  const ksl_statesf residual = cross_rest + exact;
  const ksl_statesf small_a = 0.5f * residual, small = small_a / theta;
  const ksl_statesf delta_a = ksl_abs_lanesf(small);
  const ksl_testsf delta_b = ksl_less_lanesf(delta_a, ksl_each_lanesf(0.0078125f));
  const ksl_statesf delta = ksl_choice_lanesf(delta_b, small, ksl_each_lanesf(0.0f));
  ksl_statesf far_cosine_a; const ksl_statesf far_sine_a = ksl_sincos_lanesf(theta, &far_cosine_a);
  const ksl_statesf far_sine = ksl_choice_lanesf(theta_b, ksl_each_lanesf(1.0f), far_sine_a);
  const ksl_statesf far_cosine = ksl_choice_lanesf(theta_b, ksl_each_lanesf(0.0f), far_cosine_a);
  const ksl_statesf sine_a = KSL_RN_LANESF(delta * far_cosine), sine = sine_a + far_sine;
  const ksl_statesf cosine_a = KSL_RN_LANESF(delta * far_sine), cosine = far_cosine - cosine_a;
  const ksl_statesf far_x = ksl_choice_lanesf(theta_b, ksl_each_lanesf(1.0f), x);
  const ksl_testsf middle_x_a = ksl_less_lanesf(x, ksl_each_lanesf(4.0f));
  const ksl_statesf middle_x = ksl_choice_lanesf(middle_x_a, ksl_each_lanesf(4.0f), x);
  const ksl_statesf closed1 = sine / theta;
  const ksl_statesf versine = 1.0f - cosine;
  const ksl_statesf closed2 = versine / far_x;
  const ksl_statesf rest3 = 1.0f - closed1;
  const ksl_statesf closed3 = rest3 / middle_x;
  const ksl_statesf g1a = KSL_RN_LANESF(6.4469503e-26f * x), g1b = g1a - 3.8681703e-23f, g1c =
      KSL_RN_LANESF(x * g1b),
      g1d = g1c + 1.9572942e-20f, g1e = KSL_RN_LANESF(x * g1d), g1f = g1e - 8.220635e-18f, g1g =
          KSL_RN_LANESF(x * g1f),
      g1h = g1g + 2.8114574e-15f, g1i = KSL_RN_LANESF(x * g1h), g1j = g1i - 7.6471636e-13f, g1k =
          KSL_RN_LANESF(x * g1j),
      g1l = g1k + 1.6059044e-10f, g1m = KSL_RN_LANESF(x * g1l), g1n = g1m - 2.5052108e-08f, g1o =
          KSL_RN_LANESF(x * g1n),
      g1p = g1o + 2.7557319e-06f, g1q = KSL_RN_LANESF(x * g1p), g1r = g1q - 0.0001984127f, g1s =
          KSL_RN_LANESF(x * g1r),
      g1t = g1s + 0.008333334f, g1u = KSL_RN_LANESF(x * g1t), g1v = g1u - 0.16666667f, g1w =
          KSL_RN_LANESF(x * g1v),
      g1x = g1w + 1.0f, g1 = ksl_choice_lanesf(theta_b, g1x, closed1);
  const ksl_statesf g2a = KSL_RN_LANESF(2.4795963e-27f * x), g2b = g2a - 1.6117376e-24f, g2c =
      KSL_RN_LANESF(x * g2b),
      g2d = g2c + 8.896791e-22f, g2e = KSL_RN_LANESF(x * g2d), g2f = g2e - 4.1103176e-19f, g2g =
          KSL_RN_LANESF(x * g2f),
      g2h = g2g + 1.5619207e-16f, g2i = KSL_RN_LANESF(x * g2h), g2j = g2i - 4.7794773e-14f, g2k =
          KSL_RN_LANESF(x * g2j),
      g2l = g2k + 1.1470745e-11f, g2m = KSL_RN_LANESF(x * g2l), g2n = g2m - 2.0876756e-09f, g2o =
          KSL_RN_LANESF(x * g2n),
      g2p = g2o + 2.755732e-07f, g2q = KSL_RN_LANESF(x * g2p), g2r = g2q - 2.4801588e-05f, g2s =
          KSL_RN_LANESF(x * g2r),
      g2t = g2s + 0.0013888889f, g2u = KSL_RN_LANESF(x * g2t), g2v = g2u - 0.041666668f, g2w =
          KSL_RN_LANESF(x * g2v),
      g2x = g2w + 0.5f, g2 = ksl_choice_lanesf(theta_b, g2x, closed2);
  const ksl_statesf g3a = KSL_RN_LANESF(9.18369e-29f * x), g3b = g3a - 6.4469503e-26f, g3c =
      KSL_RN_LANESF(x * g3b),
      g3d = g3c + 3.8681703e-23f, g3e = KSL_RN_LANESF(x * g3d), g3f = g3e - 1.9572942e-20f, g3g =
          KSL_RN_LANESF(x * g3f),
      g3h = g3g + 8.220635e-18f, g3i = KSL_RN_LANESF(x * g3h), g3j = g3i - 2.8114574e-15f, g3k =
          KSL_RN_LANESF(x * g3j),
      g3l = g3k + 7.6471636e-13f, g3m = KSL_RN_LANESF(x * g3l), g3n = g3m - 1.6059044e-10f, g3o =
          KSL_RN_LANESF(x * g3n),
      g3p = g3o + 2.5052108e-08f, g3q = KSL_RN_LANESF(x * g3p), g3r = g3q - 2.7557319e-06f, g3s =
          KSL_RN_LANESF(x * g3r),
      g3t = g3s + 0.0001984127f, g3u = KSL_RN_LANESF(x * g3t), g3v = g3u - 0.008333334f, g3w =
          KSL_RN_LANESF(x * g3v),
      g3x = g3w + 0.16666667f, g3 = ksl_choice_lanesf(middle_x_a, g3x, closed3);
  const ksl_statesf beta_v_1 = v[0] * g3;
  const ksl_statesf beta_v_2 = v[1] * g3;
  const ksl_statesf m_1 = KSL_RN_LANESF(v[0] * beta_v_1);
  const ksl_statesf m_2 = KSL_RN_LANESF(v[1] * beta_v_2);
  const ksl_statesf m_3 = KSL_RN_LANESF(v[2] * (v[2] * g3));
  const ksl_statesf m_4 = KSL_RN_LANESF(v[1] * beta_v_1);
  const ksl_statesf m_5 = KSL_RN_LANESF(v[2] * beta_v_1);
  const ksl_statesf m_6 = KSL_RN_LANESF(v[2] * beta_v_2);
  const ksl_statesf others_1 = m_2 + m_3;
  const ksl_statesf others_2 = m_1 + m_3;
  const ksl_statesf others_3 = m_1 + m_2;
  const ksl_statesf diagonal0a = 1.0f - others_1, diagonal0b = g1 + m_1;
  const ksl_testsf diagonal0c = ksl_less_lanesf(m_1, others_1);
  const ksl_statesf diagonal0 = ksl_choice_lanesf(diagonal0c, diagonal0b, diagonal0a);
  const ksl_statesf diagonal1a = 1.0f - others_2, diagonal1b = g1 + m_2;
  const ksl_testsf diagonal1c = ksl_less_lanesf(m_2, others_2);
  const ksl_statesf diagonal1 = ksl_choice_lanesf(diagonal1c, diagonal1b, diagonal1a);
  const ksl_statesf diagonal2a = 1.0f - others_3, diagonal2b = g1 + m_3;
  const ksl_testsf diagonal2c = ksl_less_lanesf(m_3, others_3);
  const ksl_statesf diagonal2 = ksl_choice_lanesf(diagonal2c, diagonal2b, diagonal2a);
  const ksl_statesf alpha_v_0a = KSL_RN_LANESF(v[0] * g2), alpha_v_1 = -alpha_v_0a;
  const ksl_statesf alpha_v_1a = KSL_RN_LANESF(v[1] * g2), alpha_v_2 = -alpha_v_1a;
  const ksl_statesf alpha_v_2a = KSL_RN_LANESF(v[2] * g2), alpha_v_3 = -alpha_v_2a;
  const ksl_statesf R_1 = m_4 - alpha_v_3;
  const ksl_statesf R_2 = m_5 + alpha_v_2;
  const ksl_statesf R_3 = m_4 + alpha_v_3;
  const ksl_statesf R_4 = m_6 - alpha_v_1;
  const ksl_statesf R_5 = m_5 - alpha_v_2;
  const ksl_statesf R_6 = m_6 + alpha_v_1;
  R[0] = diagonal0;
  R[3] = R_1;
  R[6] = R_2;
  R[1] = R_3;
  R[4] = diagonal1;
  R[7] = R_4;
  R[2] = R_5;
  R[5] = R_6;
  R[8] = diagonal2;
}

static KSL_INLINE void ksl_SO3_leftJacobianInversef_states(const ksl_statesf *v, ksl_statesf *R) {
  const ksl_statesf sizes_a = ksl_abs_lanesf(v[0]) + ksl_abs_lanesf(v[1]),
      sizes = sizes_a + ksl_abs_lanesf(v[2]);
  const ksl_statesf grid = KSL_RN_LANESF(sizes * 8192.0f);
  const ksl_statesf high_1 = v[0] + grid - grid;
  const ksl_statesf high_2 = v[1] + grid - grid;
  const ksl_statesf high_3 = v[2] + grid - grid;
  const ksl_statesf squares_a = KSL_RN_LANESF(high_1 * high_1), squares_b = KSL_RN_LANESF(high_2 *
      high_2),
      squares_c = squares_a + squares_b, squares_d = KSL_RN_LANESF(high_3 * high_3),
      squares = squares_c + squares_d;
  const ksl_statesf cross_a = KSL_RN_LANESF((v[0] - high_1) * (v[0] + high_1)),
      cross_b = KSL_RN_LANESF((v[1] - high_2) * (v[1] + high_2)), cross_c = cross_a + cross_b,
      cross_d = KSL_RN_LANESF((v[2] - high_3) * (v[2] + high_3)), cross = cross_c + cross_d;
  const ksl_statesf x = squares + cross;
  const ksl_statesf theta_a = ksl_sqrt_lanesf(x);
  const ksl_testsf theta_b = ksl_less_lanesf(x, ksl_each_lanesf(1.0f));
  const ksl_statesf theta = ksl_choice_lanesf(theta_b, ksl_each_lanesf(1.0f), theta_a);
  const ksl_statesf theta_shifted = grid + theta;
  const ksl_statesf theta_high = theta_shifted - grid;
  const ksl_statesf theta_low = theta - theta_high;
  const ksl_statesf theta_sum = theta + theta_high;
  const ksl_statesf cross_rest_a = KSL_RN_LANESF(theta_low * theta_sum), cross_rest = cross -
      cross_rest_a;
  const ksl_statesf exact_a = KSL_RN_LANESF(theta_high * theta_high), exact = squares - exact_a;
  const ksl_statesf residual = cross_rest + exact;
  const ksl_statesf small_a = 0.5f * residual, small = small_a / theta;
  const ksl_statesf delta_a = ksl_abs_lanesf(small);
  const ksl_testsf delta_b = ksl_less_lanesf(delta_a, ksl_each_lanesf(0.0078125f));
  const ksl_statesf delta = ksl_choice_lanesf(delta_b, small, ksl_each_lanesf(0.0f));
  ksl_statesf far_cosine_a; const ksl_statesf far_sine_a = ksl_sincos_lanesf(theta, &far_cosine_a);
  const ksl_statesf far_sine = ksl_choice_lanesf(theta_b, ksl_each_lanesf(1.0f), far_sine_a);
  const ksl_statesf far_cosine = ksl_choice_lanesf(theta_b, ksl_each_lanesf(0.0f), far_cosine_a);
  const ksl_statesf sine_a = KSL_RN_LANESF(delta * far_cosine), sine = sine_a + far_sine;
  const ksl_statesf cosine_a = KSL_RN_LANESF(delta * far_sine), cosine = far_cosine - cosine_a;
  const ksl_statesf above_a = cosine + 1.0f;
  const ksl_testsf above_b = ksl_less_lanesf(cosine, ksl_each_lanesf(0.0f));
  const ksl_statesf above = ksl_choice_lanesf(above_b, sine, above_a);
  const ksl_statesf below_a = 1.0f - cosine, below = ksl_choice_lanesf(above_b, below_a, sine);
  const ksl_statesf cotangent = above / below;
  const ksl_statesf half_cotangent_a = 0.5f * theta,
      half_cotangent = KSL_RN_LANESF(half_cotangent_a * cotangent);
  const ksl_statesf b_rest = 1.0f - half_cotangent;
  const ksl_testsf b_divisor_a = ksl_less_lanesf(x, ksl_each_lanesf(4.0f));
  const ksl_statesf b_divisor = ksl_choice_lanesf(b_divisor_a, ksl_each_lanesf(4.0f), x);
  const ksl_statesf closed_b = b_rest / b_divisor;
  const ksl_statesf b_a = KSL_RN_LANESF(1.4551725e-27f * x), b_b = b_a + 5.744791e-26f, b_c =
      KSL_RN_LANESF(x * b_b),
      b_d = b_c + 2.2679524e-24f, b_e = KSL_RN_LANESF(x * b_d), b_f = b_e + 8.9535176e-23f, b_g =
          KSL_RN_LANESF(x * b_f),
      b_h = b_g + 3.534707e-21f, b_i = KSL_RN_LANESF(x * b_h), b_j = b_i + 1.3954465e-19f, b_k =
          KSL_RN_LANESF(x * b_j),
      b_l = b_k + 5.509003e-18f, b_m = KSL_RN_LANESF(x * b_l), b_n = b_m + 2.1748687e-16f, b_o =
          KSL_RN_LANESF(x * b_n),
      b_p = b_o + 8.586062e-15f, b_q = KSL_RN_LANESF(x * b_p), b_r = b_q + 3.3896803e-13f, b_s =
          KSL_RN_LANESF(x * b_r),
      b_t = b_s + 1.3382536e-11f, b_u = KSL_RN_LANESF(x * b_t), b_v = b_u + 5.2841903e-10f, b_w =
          KSL_RN_LANESF(x * b_v),
      b_x = b_w + 2.0876756e-08f, b_y = KSL_RN_LANESF(x * b_x), b_z = b_y + 8.267196e-07f, b_aa =
          KSL_RN_LANESF(x * b_z),
      b_ab = b_aa + 3.3068784e-05f, b_ac = KSL_RN_LANESF(x * b_ab), b_ad = b_ac + 0.0013888889f,
      b_ae = KSL_RN_LANESF(x * b_ad), b_af = b_ae + 0.083333336f,
      b = ksl_choice_lanesf(b_divisor_a, b_af, closed_b);
  const ksl_statesf b_across_a = KSL_RN_LANESF(x * b), b_across_b = 1.0f - b_across_a,
      b_across = ksl_choice_lanesf(b_divisor_a, b_across_b, half_cotangent);
  const ksl_statesf beta_v_1 = v[0] * b;
  const ksl_statesf beta_v_2 = v[1] * b;
  const ksl_statesf m_1 = KSL_RN_LANESF(v[0] * beta_v_1);
  const ksl_statesf m_2 = KSL_RN_LANESF(v[1] * beta_v_2);
  const ksl_statesf m_3 = KSL_RN_LANESF(v[2] * (v[2] * b));
  const ksl_statesf m_4 = KSL_RN_LANESF(v[1] * beta_v_1);
  const ksl_statesf m_5 = KSL_RN_LANESF(v[2] * beta_v_1);
  const ksl_statesf m_6 = KSL_RN_LANESF(v[2] * beta_v_2);
  const ksl_statesf others_1 = m_2 + m_3;
  const ksl_statesf others_2 = m_1 + m_3;
  const ksl_statesf others_3 = m_1 + m_2;
  const ksl_statesf diagonal0a = 1.0f - others_1, diagonal0b = b_across + m_1;
  const ksl_testsf diagonal0c = ksl_less_lanesf(m_1, others_1);
  const ksl_statesf diagonal0 = ksl_choice_lanesf(diagonal0c, diagonal0b, diagonal0a);
  const ksl_statesf diagonal1a = 1.0f - others_2, diagonal1b = b_across + m_2;
  const ksl_testsf diagonal1c = ksl_less_lanesf(m_2, others_2);
  const ksl_statesf diagonal1 = ksl_choice_lanesf(diagonal1c, diagonal1b, diagonal1a);
  const ksl_statesf diagonal2a = 1.0f - others_3, diagonal2b = b_across + m_3;
  const ksl_testsf diagonal2c = ksl_less_lanesf(m_3, others_3);
  const ksl_statesf diagonal2 = ksl_choice_lanesf(diagonal2c, diagonal2b, diagonal2a);
  const ksl_statesf alpha_v_0a = KSL_RN_LANESF(0.5f * v[0]), alpha_v_1 = -alpha_v_0a;
  const ksl_statesf alpha_v_1a = KSL_RN_LANESF(0.5f * v[1]), alpha_v_2 = -alpha_v_1a;
  const ksl_statesf alpha_v_2a = KSL_RN_LANESF(0.5f * v[2]), alpha_v_3 = -alpha_v_2a;
  const ksl_statesf R_1 = m_4 - alpha_v_3;
  const ksl_statesf R_2 = m_5 + alpha_v_2;
  const ksl_statesf R_3 = m_4 + alpha_v_3;
  const ksl_statesf R_4 = m_6 - alpha_v_1;
  const ksl_statesf R_5 = m_5 - alpha_v_2;
  const ksl_statesf R_6 = m_6 + alpha_v_1;
  R[0] = diagonal0;
  R[3] = R_1;
  R[6] = R_2;
  R[1] = R_3;
  R[4] = diagonal1;
  R[7] = R_4;
  R[2] = R_5;
  R[5] = R_6;
  R[8] = diagonal2;
}

static KSL_INLINE void ksl_SO3_rightJacobianInversef_states(const ksl_statesf *v, ksl_statesf *R) {
  const ksl_statesf sizes_a = ksl_abs_lanesf(v[0]) + ksl_abs_lanesf(v[1]),
      sizes = sizes_a + ksl_abs_lanesf(v[2]);
  const ksl_statesf grid = KSL_RN_LANESF(sizes * 8192.0f);
  const ksl_statesf high_1 = v[0] + grid - grid;
  const ksl_statesf high_2 = v[1] + grid - grid;
  const ksl_statesf high_3 = v[2] + grid - grid;
  const ksl_statesf squares_a = KSL_RN_LANESF(high_1 * high_1), squares_b = KSL_RN_LANESF(high_2 *
      high_2),
      squares_c = squares_a + squares_b, squares_d = KSL_RN_LANESF(high_3 * high_3),
      squares = squares_c + squares_d;
  const ksl_statesf cross_a = KSL_RN_LANESF((v[0] - high_1) * (v[0] + high_1)),
      cross_b = KSL_RN_LANESF((v[1] - high_2) * (v[1] + high_2)), cross_c = cross_a + cross_b,
      cross_d = KSL_RN_LANESF((v[2] - high_3) * (v[2] + high_3)), cross = cross_c + cross_d;
  const ksl_statesf x = squares + cross;
  const ksl_statesf theta_a = ksl_sqrt_lanesf(x);
  const ksl_testsf theta_b = ksl_less_lanesf(x, ksl_each_lanesf(1.0f));
  const ksl_statesf theta = ksl_choice_lanesf(theta_b, ksl_each_lanesf(1.0f), theta_a);
  const ksl_statesf theta_shifted = grid + theta;
  const ksl_statesf theta_high = theta_shifted - grid;
  const ksl_statesf theta_low = theta - theta_high;
  const ksl_statesf theta_sum = theta + theta_high;
  const ksl_statesf cross_rest_a = KSL_RN_LANESF(theta_low * theta_sum), cross_rest = cross -
      cross_rest_a;
  const ksl_statesf exact_a = KSL_RN_LANESF(theta_high * theta_high), exact = squares - exact_a;
  const ksl_statesf residual = cross_rest + exact;
  const ksl_statesf small_a = 0.5f * residual, small = small_a / theta;
  const ksl_statesf delta_a = ksl_abs_lanesf(small);
  const ksl_testsf delta_b = ksl_less_lanesf(delta_a, ksl_each_lanesf(0.0078125f));
  const ksl_statesf delta = ksl_choice_lanesf(delta_b, small, ksl_each_lanesf(0.0f));
  ksl_statesf far_cosine_a; const ksl_statesf far_sine_a = ksl_sincos_lanesf(theta, &far_cosine_a);
  const ksl_statesf far_sine = ksl_choice_lanesf(theta_b, ksl_each_lanesf(1.0f), far_sine_a);
  const ksl_statesf far_cosine = ksl_choice_lanesf(theta_b, ksl_each_lanesf(0.0f), far_cosine_a);
  const ksl_statesf sine_a = KSL_RN_LANESF(delta * far_cosine), sine = sine_a + far_sine;
  const ksl_statesf cosine_a = KSL_RN_LANESF(delta * far_sine), cosine = far_cosine - cosine_a;
  const ksl_statesf above_a = cosine + 1.0f;
  const ksl_testsf above_b = ksl_less_lanesf(cosine, ksl_each_lanesf(0.0f));
  const ksl_statesf above = ksl_choice_lanesf(above_b, sine, above_a);
  const ksl_statesf below_a = 1.0f - cosine, below = ksl_choice_lanesf(above_b, below_a, sine);
  const ksl_statesf cotangent = above / below;
  const ksl_statesf half_cotangent_a = 0.5f * theta,
      half_cotangent = KSL_RN_LANESF(half_cotangent_a * cotangent);
  const ksl_statesf b_rest = 1.0f - half_cotangent;
  const ksl_testsf b_divisor_a = ksl_less_lanesf(x, ksl_each_lanesf(4.0f));
  const ksl_statesf b_divisor = ksl_choice_lanesf(b_divisor_a, ksl_each_lanesf(4.0f), x);
  const ksl_statesf closed_b = b_rest / b_divisor;
  const ksl_statesf b_a = KSL_RN_LANESF(1.4551725e-27f * x), b_b = b_a + 5.744791e-26f, b_c =
      KSL_RN_LANESF(x * b_b),
      b_d = b_c + 2.2679524e-24f, b_e = KSL_RN_LANESF(x * b_d), b_f = b_e + 8.9535176e-23f, b_g =
          KSL_RN_LANESF(x * b_f),
      b_h = b_g + 3.534707e-21f, b_i = KSL_RN_LANESF(x * b_h), b_j = b_i + 1.3954465e-19f, b_k =
          KSL_RN_LANESF(x * b_j),
      b_l = b_k + 5.509003e-18f, b_m = KSL_RN_LANESF(x * b_l), b_n = b_m + 2.1748687e-16f, b_o =
          KSL_RN_LANESF(x * b_n),
      b_p = b_o + 8.586062e-15f, b_q = KSL_RN_LANESF(x * b_p), b_r = b_q + 3.3896803e-13f, b_s =
          KSL_RN_LANESF(x * b_r),
      b_t = b_s + 1.3382536e-11f, b_u = KSL_RN_LANESF(x * b_t), b_v = b_u + 5.2841903e-10f, b_w =
          KSL_RN_LANESF(x * b_v),
      b_x = b_w + 2.0876756e-08f, b_y = KSL_RN_LANESF(x * b_x), b_z = b_y + 8.267196e-07f, b_aa =
          KSL_RN_LANESF(x * b_z),
      b_ab = b_aa + 3.3068784e-05f, b_ac = KSL_RN_LANESF(x * b_ab), b_ad = b_ac + 0.0013888889f,
      b_ae = KSL_RN_LANESF(x * b_ad), b_af = b_ae + 0.083333336f,
      b = ksl_choice_lanesf(b_divisor_a, b_af, closed_b);
  const ksl_statesf b_across_a = KSL_RN_LANESF(x * b), b_across_b = 1.0f - b_across_a,
      b_across = ksl_choice_lanesf(b_divisor_a, b_across_b, half_cotangent);
  const ksl_statesf beta_v_1 = v[0] * b;
  const ksl_statesf beta_v_2 = v[1] * b;
  const ksl_statesf m_1 = KSL_RN_LANESF(v[0] * beta_v_1);
  const ksl_statesf m_2 = KSL_RN_LANESF(v[1] * beta_v_2);
  const ksl_statesf m_3 = KSL_RN_LANESF(v[2] * (v[2] * b));
  const ksl_statesf m_4 = KSL_RN_LANESF(v[1] * beta_v_1);
  const ksl_statesf m_5 = KSL_RN_LANESF(v[2] * beta_v_1);
  const ksl_statesf m_6 = KSL_RN_LANESF(v[2] * beta_v_2);
  const ksl_statesf others_1 = m_2 + m_3;
  const ksl_statesf others_2 = m_1 + m_3;
  const ksl_statesf others_3 = m_1 + m_2;
  const ksl_statesf diagonal0a = 1.0f - others_1, diagonal0b = b_across + m_1;
  const ksl_testsf diagonal0c = ksl_less_lanesf(m_1, others_1);
  const ksl_statesf diagonal0 = ksl_choice_lanesf(diagonal0c, diagonal0b, diagonal0a);
  const ksl_statesf diagonal1a = 1.0f - others_2, diagonal1b = b_across + m_2;
  const ksl_testsf diagonal1c = ksl_less_lanesf(m_2, others_2);
  const ksl_statesf diagonal1 = ksl_choice_lanesf(diagonal1c, diagonal1b, diagonal1a);
  const ksl_statesf diagonal2a = 1.0f - others_3, diagonal2b = b_across + m_3;
  const ksl_testsf diagonal2c = ksl_less_lanesf(m_3, others_3);
  const ksl_statesf diagonal2 = ksl_choice_lanesf(diagonal2c, diagonal2b, diagonal2a);
  const ksl_statesf alpha_v_1 = KSL_RN_LANESF(0.5f * v[0]);
  const ksl_statesf alpha_v_2 = KSL_RN_LANESF(0.5f * v[1]);
  const ksl_statesf alpha_v_3 = KSL_RN_LANESF(0.5f * v[2]);
  const ksl_statesf R_1 = m_4 - alpha_v_3;
  const ksl_statesf R_2 = m_5 + alpha_v_2;
  const ksl_statesf R_3 = m_4 + alpha_v_3;
  const ksl_statesf R_4 = m_6 - alpha_v_1;
  const ksl_statesf R_5 = m_5 - alpha_v_2;
  const ksl_statesf R_6 = m_6 + alpha_v_1;
  R[0] = diagonal0;
  R[3] = R_1;
  R[6] = R_2;
  R[1] = R_3;
  R[4] = diagonal1;
  R[7] = R_4;
  R[2] = R_5;
  R[5] = R_6;
  R[8] = diagonal2;
}

static KSL_INLINE void ksl_SE3f_exp_states(const ksl_statesf *s, ksl_statesf *D) {
  const ksl_statesf sizes_a = ksl_abs_lanesf(s[3]) + ksl_abs_lanesf(s[4]),
      sizes = sizes_a + ksl_abs_lanesf(s[5]);
  const ksl_statesf grid = KSL_RN_LANESF(sizes * 8192.0f);
  const ksl_statesf high_1 = s[3] + grid - grid;
  const ksl_statesf high_2 = s[4] + grid - grid;
  const ksl_statesf high_3 = s[5] + grid - grid;
  const ksl_statesf squares_a = KSL_RN_LANESF(high_1 * high_1), squares_b = KSL_RN_LANESF(high_2 *
      high_2),
      squares_c = squares_a + squares_b, squares_d = KSL_RN_LANESF(high_3 * high_3),
      squares = squares_c + squares_d;
  const ksl_statesf cross_a = KSL_RN_LANESF((s[3] - high_1) * (s[3] + high_1)),
      cross_b = KSL_RN_LANESF((s[4] - high_2) * (s[4] + high_2)), cross_c = cross_a + cross_b,
      cross_d = KSL_RN_LANESF((s[5] - high_3) * (s[5] + high_3)), cross = cross_c + cross_d;
  const ksl_statesf x = squares + cross;
  const ksl_statesf theta_a = ksl_sqrt_lanesf(x);
  const ksl_testsf theta_b = ksl_less_lanesf(x, ksl_each_lanesf(1.0f));
  const ksl_statesf theta = ksl_choice_lanesf(theta_b, ksl_each_lanesf(1.0f), theta_a);
  const ksl_statesf theta_shifted = grid + theta;
  const ksl_statesf theta_high = theta_shifted - grid;
  const ksl_statesf theta_low = theta - theta_high;
  const ksl_statesf theta_sum = theta + theta_high;
  const ksl_statesf cross_rest_a = KSL_RN_LANESF(theta_low * theta_sum), cross_rest = cross -
      cross_rest_a;
  const ksl_statesf exact_a = KSL_RN_LANESF(theta_high * theta_high), exact = squares - exact_a;
  const ksl_statesf residual = cross_rest + exact;
  const ksl_statesf small_a = 0.5f * residual, small = small_a / theta;
  const ksl_statesf delta_a = ksl_abs_lanesf(small);
  const ksl_testsf delta_b = ksl_less_lanesf(delta_a, ksl_each_lanesf(0.0078125f));
  const ksl_statesf delta = ksl_choice_lanesf(delta_b, small, ksl_each_lanesf(0.0f));
  ksl_statesf far_cosine_a; const ksl_statesf far_sine_a = ksl_sincos_lanesf(theta, &far_cosine_a);
  const ksl_statesf far_sine = ksl_choice_lanesf(theta_b, ksl_each_lanesf(1.0f), far_sine_a);
  const ksl_statesf far_cosine = ksl_choice_lanesf(theta_b, ksl_each_lanesf(0.0f), far_cosine_a);
  const ksl_statesf sine_a = KSL_RN_LANESF(delta * far_cosine), sine = sine_a + far_sine;
  const ksl_statesf cosine_a = KSL_RN_LANESF(delta * far_sine), cosine = far_cosine - cosine_a;
  const ksl_statesf far_x = ksl_choice_lanesf(theta_b, ksl_each_lanesf(1.0f), x);
  const ksl_testsf middle_x_a = ksl_less_lanesf(x, ksl_each_lanesf(4.0f));
  const ksl_statesf middle_x = ksl_choice_lanesf(middle_x_a, ksl_each_lanesf(4.0f), x);
  const ksl_statesf closed1 = sine / theta;
  const ksl_statesf versine = 1.0f - cosine;
  const ksl_statesf closed2 = versine / far_x;
  const ksl_statesf rest3 = 1.0f - closed1;
  const ksl_statesf closed3 = rest3 / middle_x;
  const ksl_statesf g1a = KSL_RN_LANESF(6.4469503e-26f * x), g1b = g1a - 3.8681703e-23f, g1c =
      KSL_RN_LANESF(x * g1b),
      g1d = g1c + 1.9572942e-20f, g1e = KSL_RN_LANESF(x * g1d), g1f = g1e - 8.220635e-18f, g1g =
          KSL_RN_LANESF(x * g1f),
      g1h = g1g + 2.8114574e-15f, g1i = KSL_RN_LANESF(x * g1h), g1j = g1i - 7.6471636e-13f, g1k =
          KSL_RN_LANESF(x * g1j),
      g1l = g1k + 1.6059044e-10f, g1m = KSL_RN_LANESF(x * g1l), g1n = g1m - 2.5052108e-08f, g1o =
          KSL_RN_LANESF(x * g1n),
      g1p = g1o + 2.7557319e-06f, g1q = KSL_RN_LANESF(x * g1p), g1r = g1q - 0.0001984127f, g1s =
          KSL_RN_LANESF(x * g1r),
      g1t = g1s + 0.008333334f, g1u = KSL_RN_LANESF(x * g1t), g1v = g1u - 0.16666667f, g1w =
          KSL_RN_LANESF(x * g1v),
      g1x = g1w + 1.0f, g1 = ksl_choice_lanesf(theta_b, g1x, closed1);
  const ksl_statesf g2a = KSL_RN_LANESF(2.4795963e-27f * x), g2b = g2a - 1.6117376e-24f, g2c =
      KSL_RN_LANESF(x * g2b),
      g2d = g2c + 8.896791e-22f, g2e = KSL_RN_LANESF(x * g2d), g2f = g2e - 4.1103176e-19f, g2g =
          KSL_RN_LANESF(x * g2f),
      g2h = g2g + 1.5619207e-16f, g2i = KSL_RN_LANESF(x * g2h), g2j = g2i - 4.7794773e-14f, g2k =
          KSL_RN_LANESF(x * g2j),
      g2l = g2k + 1.1470745e-11f, g2m = KSL_RN_LANESF(x * g2l), g2n = g2m - 2.0876756e-09f, g2o =
          KSL_RN_LANESF(x * g2n),
      g2p = g2o + 2.755732e-07f, g2q = KSL_RN_LANESF(x * g2p), g2r = g2q - 2.4801588e-05f, g2s =
          KSL_RN_LANESF(x * g2r),
      g2t = g2s + 0.0013888889f, g2u = KSL_RN_LANESF(x * g2t), g2v = g2u - 0.041666668f, g2w =
          KSL_RN_LANESF(x * g2v),
      g2x = g2w + 0.5f, g2 = ksl_choice_lanesf(theta_b, g2x, closed2);
  const ksl_statesf g3a = KSL_RN_LANESF(9.18369e-29f * x), g3b = g3a - 6.4469503e-26f, g3c =
      KSL_RN_LANESF(x * g3b),
      g3d = g3c + 3.8681703e-23f, g3e = KSL_RN_LANESF(x * g3d), g3f = g3e - 1.9572942e-20f, g3g =
          KSL_RN_LANESF(x * g3f),
      g3h = g3g + 8.220635e-18f, g3i = KSL_RN_LANESF(x * g3h), g3j = g3i - 2.8114574e-15f, g3k =
          KSL_RN_LANESF(x * g3j),
      g3l = g3k + 7.6471636e-13f, g3m = KSL_RN_LANESF(x * g3l), g3n = g3m - 1.6059044e-10f, g3o =
          KSL_RN_LANESF(x * g3n),
      g3p = g3o + 2.5052108e-08f, g3q = KSL_RN_LANESF(x * g3p), g3r = g3q - 2.7557319e-06f, g3s =
          KSL_RN_LANESF(x * g3r),
      g3t = g3s + 0.0001984127f, g3u = KSL_RN_LANESF(x * g3t), g3v = g3u - 0.008333334f, g3w =
          KSL_RN_LANESF(x * g3v),
      g3x = g3w + 0.16666667f, g3 = ksl_choice_lanesf(middle_x_a, g3x, closed3);
  const ksl_statesf g0a = KSL_RN_LANESF(x * g2), g0b = 1.0f - g0a,
      g0 = ksl_choice_lanesf(theta_b, g0b, cosine);
  const ksl_statesf u_0a = KSL_RN_LANESF(s[2] * s[4]), u_0b = KSL_RN_LANESF(s[1] * s[5]);
  const ksl_statesf u_1a = KSL_RN_LANESF(s[0] * s[5]), u_1b = KSL_RN_LANESF(s[2] * s[3]);
  const ksl_statesf u_2a = KSL_RN_LANESF(s[1] * s[3]), u_2b = KSL_RN_LANESF(s[0] * s[4]);
  const ksl_statesf wv_a = KSL_RN_LANESF(s[0] * s[3]), wv_b = KSL_RN_LANESF(s[1] * s[4]), wv_c =
      wv_a + wv_b,
      wv_d = KSL_RN_LANESF(s[2] * s[5]), wv = wv_c + wv_d;
  const ksl_statesf pitch = g3 * wv;
  const ksl_statesf beta_v_1 = s[3] * g2;
  const ksl_statesf beta_v_2 = s[4] * g2;
  const ksl_statesf m_1 = KSL_RN_LANESF(s[3] * beta_v_1);
  const ksl_statesf m_2 = KSL_RN_LANESF(s[4] * beta_v_2);
  const ksl_statesf m_3 = KSL_RN_LANESF(s[5] * (s[5] * g2));
  const ksl_statesf m_4 = KSL_RN_LANESF(s[4] * beta_v_1);
  const ksl_statesf m_5 = KSL_RN_LANESF(s[5] * beta_v_1);
  const ksl_statesf m_6 = KSL_RN_LANESF(s[5] * beta_v_2);
  const ksl_statesf others_1 = m_2 + m_3;
  const ksl_statesf others_2 = m_1 + m_3;
  const ksl_statesf others_3 = m_1 + m_2;
  const ksl_statesf diagonal0a = 1.0f - others_1, diagonal0b = g0 + m_1;
  const ksl_testsf diagonal0c = ksl_less_lanesf(m_1, others_1);
  const ksl_statesf diagonal0 = ksl_choice_lanesf(diagonal0c, diagonal0b, diagonal0a);
  const ksl_statesf diagonal1a = 1.0f - others_2, diagonal1b = g0 + m_2;
  const ksl_testsf diagonal1c = ksl_less_lanesf(m_2, others_2);
  const ksl_statesf diagonal1 = ksl_choice_lanesf(diagonal1c, diagonal1b, diagonal1a);
  const ksl_statesf diagonal2a = 1.0f - others_3, diagonal2b = g0 + m_3;
  const ksl_testsf diagonal2c = ksl_less_lanesf(m_3, others_3);
  const ksl_statesf diagonal2 = ksl_choice_lanesf(diagonal2c, diagonal2b, diagonal2a);
  const ksl_statesf alpha_v_1 = KSL_RN_LANESF(s[3] * g1);
  const ksl_statesf alpha_v_2 = KSL_RN_LANESF(s[4] * g1);
  const ksl_statesf alpha_v_3 = KSL_RN_LANESF(s[5] * g1);
  const ksl_statesf D_1 = m_4 - alpha_v_3;
  const ksl_statesf D_2 = m_5 + alpha_v_2;
  const ksl_statesf D_03a = KSL_RN_LANESF(s[0] * g1),
      D_3 = D_03a + (KSL_RN_LANESF(g2 * (u_0a - u_0b)) + KSL_RN_LANESF(s[3] * pitch));
  const ksl_statesf D_4 = m_4 + alpha_v_3;
  const ksl_statesf D_5 = m_6 - alpha_v_1;
  const ksl_statesf D_13a = KSL_RN_LANESF(s[1] * g1),
      D_6 = D_13a + (KSL_RN_LANESF(g2 * (u_1a - u_1b)) + KSL_RN_LANESF(s[4] * pitch));
  const ksl_statesf D_7 = m_5 - alpha_v_2;
  const ksl_statesf D_8 = m_6 + alpha_v_1;
  const ksl_statesf D_23a = KSL_RN_LANESF(s[2] * g1),
      D_9 = D_23a + (KSL_RN_LANESF(g2 * (u_2a - u_2b)) + KSL_RN_LANESF(s[5] * pitch));
  D[0] = diagonal0;
  D[3] = D_1;
  D[6] = D_2;
  D[9] = D_3;
  D[1] = D_4;
  D[4] = diagonal1;
  D[7] = D_5;
  D[10] = D_6;
  D[2] = D_7;
  D[5] = D_8;
  D[8] = diagonal2;
  D[11] = D_9;
}

static KSL_INLINE void ksl_SE3f_log_states(const ksl_statesf *D, ksl_statesf *so) {
  const ksl_statesf p_1 = D[5] - D[7];
  const ksl_statesf p_2 = D[6] - D[2];
  const ksl_statesf p_3 = D[1] - D[3];
  const ksl_statesf s_1 = D[7] + D[5];
  const ksl_statesf s_2 = D[6] + D[2];
  const ksl_statesf s_3 = D[3] + D[1];
  const ksl_statesf first_1 = D[0] + 1.0f;
  const ksl_statesf first_2 = 1.0f - D[0];
  const ksl_statesf others_1 = D[4] + D[8];
  const ksl_statesf others_2 = D[4] - D[8];
  const ksl_testsf low_0a = ksl_less_lanesf(D[4], D[0]);
  const ksl_statesf high_0a = -D[4];
  const ksl_testsf high_0b = ksl_less_lanesf(D[0], high_0a);
  const ksl_testsf column_0a = ksl_less_lanesf(D[8], ksl_each_lanesf(0.0f));
  const ksl_statesf column_1 = ksl_choice_lanesf(column_0a, ksl_choice_lanesf(low_0a, first_1
          - others_1, s_3), ksl_choice_lanesf(high_0b, s_2, p_1));
  const ksl_statesf column_2 = ksl_choice_lanesf(column_0a, ksl_choice_lanesf(low_0a, s_3, first_2
          + others_2), ksl_choice_lanesf(high_0b, s_1, p_2));
  const ksl_statesf column_3 = ksl_choice_lanesf(column_0a, ksl_choice_lanesf(low_0a, s_2, s_1),
      ksl_choice_lanesf(high_0b, first_2 - others_2, p_3));
  const ksl_statesf column_4 = ksl_choice_lanesf(column_0a, ksl_choice_lanesf(low_0a, p_1, p_2),
      ksl_choice_lanesf(high_0b, p_3, first_1 + others_1));
  const ksl_statesf upper_0a = -column_1;
  const ksl_testsf upper_0b = ksl_less_lanesf(column_4, ksl_each_lanesf(0.0f));
  const ksl_statesf upper_1 = ksl_choice_lanesf(upper_0b, upper_0a, column_1);
  const ksl_statesf upper_1a = -column_2, upper_2 = ksl_choice_lanesf(upper_0b, upper_1a, column_2);
  const ksl_statesf upper_2a = -column_3, upper_3 = ksl_choice_lanesf(upper_0b, upper_2a, column_3);
  const ksl_statesf upper_3a = -column_4, upper_4 = ksl_choice_lanesf(upper_0b, upper_3a, column_4);
  const ksl_statesf v_s_size_1 = ksl_abs_lanesf(upper_1);
  const ksl_statesf v_s_size_2 = ksl_abs_lanesf(upper_2);
  const ksl_statesf v_s_size_3 = ksl_abs_lanesf(upper_3);
  const ksl_testsf v_s_largest1a = ksl_less_lanesf(v_s_size_1, v_s_size_2);
  const ksl_statesf v_s_largest1 = ksl_choice_lanesf(v_s_largest1a, v_s_size_2, v_s_size_1);
  const ksl_testsf v_s_largest2a = ksl_less_lanesf(v_s_largest1, v_s_size_3);
  const ksl_statesf v_s_largest2 = ksl_choice_lanesf(v_s_largest2a, v_s_size_3, v_s_largest1);
  const ksl_testsf v_s_a = ksl_less_lanesf(ksl_each_lanesf(4.611686e+18f), v_s_largest2);
  const ksl_statesf v_s_b = ksl_choice_lanesf(v_s_a, ksl_each_lanesf(2.7105054e-20f),
      ksl_each_lanesf(1.0f));
  const ksl_testsf v_s_c = ksl_less_lanesf(v_s_largest2, ksl_each_lanesf(256.0f));
  const ksl_statesf v_s_d = ksl_choice_lanesf(v_s_c, ksl_each_lanesf(1.8014399e+16f), v_s_b);
  const ksl_testsf v_s_e = ksl_less_lanesf(v_s_largest2, ksl_each_lanesf(1.4210855e-14f));
  const ksl_statesf v_s = ksl_choice_lanesf(v_s_e, ksl_each_lanesf(3.2451855e+32f), v_s_d);
  const ksl_statesf v_y_1 = upper_1 * v_s;
  const ksl_statesf v_y_2 = upper_2 * v_s;
  const ksl_statesf v_y_3 = upper_3 * v_s;
  const ksl_statesf v_n_a = KSL_RN_LANESF(v_y_1 * v_y_1), v_n_b = KSL_RN_LANESF(v_y_2 * v_y_2),
      v_n_c = v_n_a + v_n_b,
      v_n_d = KSL_RN_LANESF(v_y_3 * v_y_3), v_n_e = v_n_c + v_n_d, v_n = ksl_sqrt_lanesf(v_n_e);
  const ksl_testsf v_r_a = ksl_less_lanesf(v_s, ksl_each_lanesf(1.0f));
  const ksl_statesf v_r_b = ksl_choice_lanesf(v_r_a, ksl_each_lanesf(3.689349e+19f),
      ksl_each_lanesf(1.0f));
  const ksl_testsf v_r_c = ksl_less_lanesf(ksl_each_lanesf(1.0f), v_s);
  const ksl_statesf v_r_d = ksl_choice_lanesf(v_r_c, ksl_each_lanesf(5.551115e-17f), v_r_b);
  const ksl_testsf v_r_e = ksl_less_lanesf(ksl_each_lanesf(1.8014399e+16f), v_s);
  const ksl_statesf v_r = ksl_choice_lanesf(v_r_e, ksl_each_lanesf(3.081488e-33f), v_r_d);
  const ksl_statesf n = v_n * v_r;
  const ksl_statesf half = ksl_atan2_lanesf(n, upper_4);
  const ksl_testsf divisor_a = ksl_equal_lanesf(n, ksl_each_lanesf(0.0f));
  const ksl_statesf divisor = ksl_choice_lanesf(divisor_a, ksl_each_lanesf(1.0f), n);
  const ksl_statesf theta = 2.0f * half;
  const ksl_statesf k = theta / divisor;
  const ksl_statesf vector_1 = KSL_RN_LANESF(upper_1 * k);
  const ksl_statesf vector_2 = KSL_RN_LANESF(upper_2 * k);
  const ksl_statesf vector_3 = KSL_RN_LANESF(upper_3 * k);
  const ksl_statesf x = theta * theta;
  const ksl_testsf far_sine_a = ksl_less_lanesf(x, ksl_each_lanesf(1.0f));
  const ksl_statesf far_sine = ksl_choice_lanesf(far_sine_a, ksl_each_lanesf(1.0f), n);
  const ksl_statesf cotangent = upper_4 / far_sine;
  const ksl_statesf half_cotangent_a = 0.5f * theta,
      half_cotangent = KSL_RN_LANESF(half_cotangent_a * cotangent);
  const ksl_statesf b_rest = 1.0f - half_cotangent;
  const ksl_testsf b_divisor_a = ksl_less_lanesf(x, ksl_each_lanesf(4.0f));
  const ksl_statesf b_divisor = ksl_choice_lanesf(b_divisor_a, ksl_each_lanesf(4.0f), x);
  const ksl_statesf closed_b = b_rest / b_divisor;
  const ksl_statesf b_a = KSL_RN_LANESF(1.4551725e-27f * x), b_b = b_a + 5.744791e-26f, b_c =
      KSL_RN_LANESF(x * b_b),
      b_d = b_c + 2.2679524e-24f, b_e = KSL_RN_LANESF(x * b_d), b_f = b_e + 8.9535176e-23f, b_g =
          KSL_RN_LANESF(x * b_f),
      b_h = b_g + 3.534707e-21f, b_i = KSL_RN_LANESF(x * b_h), b_j = b_i + 1.3954465e-19f, b_k =
          KSL_RN_LANESF(x * b_j),
      b_l = b_k + 5.509003e-18f, b_m = KSL_RN_LANESF(x * b_l), b_n = b_m + 2.1748687e-16f, b_o =
          KSL_RN_LANESF(x * b_n),
      b_p = b_o + 8.586062e-15f, b_q = KSL_RN_LANESF(x * b_p), b_r = b_q + 3.3896803e-13f, b_s =
          KSL_RN_LANESF(x * b_r),
      b_t = b_s + 1.3382536e-11f, b_u = KSL_RN_LANESF(x * b_t), b_v = b_u + 5.2841903e-10f, b_w =
          KSL_RN_LANESF(x * b_v),
      b_x = b_w + 2.0876756e-08f, b_y = KSL_RN_LANESF(x * b_x), b_z = b_y + 8.267196e-07f, b_aa =
          KSL_RN_LANESF(x * b_z),
      b_ab = b_aa + 3.3068784e-05f, b_ac = KSL_RN_LANESF(x * b_ab), b_ad = b_ac + 0.0013888889f,
      b_ae = KSL_RN_LANESF(x * b_ad), b_af = b_ae + 0.083333336f,
      b = ksl_choice_lanesf(b_divisor_a, b_af, closed_b);
  const ksl_statesf b_across_a = KSL_RN_LANESF(x * b), b_across_b = 1.0f - b_across_a,
      b_across = ksl_choice_lanesf(b_divisor_a, b_across_b, half_cotangent);
  const ksl_statesf wt_a = KSL_RN_LANESF(D[9] * vector_1), wt_b = KSL_RN_LANESF(D[10] * vector_2),
      wt_c = wt_a + wt_b,
      wt_d = KSL_RN_LANESF(D[11] * vector_3), wt = wt_c + wt_d;
  const ksl_statesf pitch = b * wt;
  const ksl_statesf u_0a = KSL_RN_LANESF(D[11] * vector_2), u_0b = KSL_RN_LANESF(D[10] * vector_3);
  const ksl_statesf u_1a = KSL_RN_LANESF(D[9] * vector_3), u_1b = KSL_RN_LANESF(D[11] * vector_1);
  const ksl_statesf u_2a = KSL_RN_LANESF(D[10] * vector_1), u_2b = KSL_RN_LANESF(D[9] * vector_2);
  const ksl_statesf so_0a = KSL_RN_LANESF(D[9] * b_across),
      so_1 = so_0a + (KSL_RN_LANESF(vector_1 * pitch) - KSL_RN_LANESF(0.5f * (u_0a - u_0b)));
  const ksl_statesf so_1a = KSL_RN_LANESF(D[10] * b_across),
      so_2 = so_1a + (KSL_RN_LANESF(vector_2 * pitch) - KSL_RN_LANESF(0.5f * (u_1a - u_1b)));
  const ksl_statesf so_2a = KSL_RN_LANESF(D[11] * b_across),
      so_3 = so_2a + (KSL_RN_LANESF(vector_3 * pitch) - KSL_RN_LANESF(0.5f * (u_2a - u_2b)));
  so[0] = so_1;
  so[1] = so_2;
  so[2] = so_3;
  so[3] = vector_1;
  so[4] = vector_2;
  so[5] = vector_3;
}

static KSL_INLINE void ksl_SE3f_leftJacobian_states(const ksl_statesf *s, ksl_statesf *M) {
  const ksl_statesf sizes_a = ksl_abs_lanesf(s[3]) + ksl_abs_lanesf(s[4]),
      sizes = sizes_a + ksl_abs_lanesf(s[5]);
  const ksl_statesf grid = KSL_RN_LANESF(sizes * 8192.0f);
  const ksl_statesf high_1 = s[3] + grid - grid;
  const ksl_statesf high_2 = s[4] + grid - grid;
  const ksl_statesf high_3 = s[5] + grid - grid;
  const ksl_statesf squares_a = KSL_RN_LANESF(high_1 * high_1), squares_b = KSL_RN_LANESF(high_2 *
      high_2),
      squares_c = squares_a + squares_b, squares_d = KSL_RN_LANESF(high_3 * high_3),
      squares = squares_c + squares_d;
  const ksl_statesf cross_a = KSL_RN_LANESF((s[3] - high_1) * (s[3] + high_1)),
      cross_b = KSL_RN_LANESF((s[4] - high_2) * (s[4] + high_2)), cross_c = cross_a + cross_b,
      cross_d = KSL_RN_LANESF((s[5] - high_3) * (s[5] + high_3)), cross = cross_c + cross_d;
  const ksl_statesf x = squares + cross;
  const ksl_statesf theta_a = ksl_sqrt_lanesf(x);
  const ksl_testsf theta_b = ksl_less_lanesf(x, ksl_each_lanesf(1.0f));
  const ksl_statesf theta = ksl_choice_lanesf(theta_b, ksl_each_lanesf(1.0f), theta_a);
  const ksl_statesf theta_shifted = grid + theta;
  const ksl_statesf theta_high = theta_shifted - grid;
  const ksl_statesf theta_low = theta - theta_high;
  const ksl_statesf theta_sum = theta + theta_high;
  const ksl_statesf cross_rest_a = KSL_RN_LANESF(theta_low * theta_sum), cross_rest = cross -
      cross_rest_a;
  const ksl_statesf exact_a = KSL_RN_LANESF(theta_high * theta_high), exact = squares - exact_a;
  const ksl_statesf residual = cross_rest + exact;
  const ksl_statesf small_a = 0.5f * residual, small = small_a / theta;
  const ksl_statesf delta_a = ksl_abs_lanesf(small);
  const ksl_testsf delta_b = ksl_less_lanesf(delta_a, ksl_each_lanesf(0.0078125f));
  const ksl_statesf delta = ksl_choice_lanesf(delta_b, small, ksl_each_lanesf(0.0f));
  ksl_statesf far_cosine_a; const ksl_statesf far_sine_a = ksl_sincos_lanesf(theta, &far_cosine_a);
  const ksl_statesf far_sine = ksl_choice_lanesf(theta_b, ksl_each_lanesf(1.0f), far_sine_a);
  const ksl_statesf far_cosine = ksl_choice_lanesf(theta_b, ksl_each_lanesf(0.0f), far_cosine_a);
  const ksl_statesf sine_a = KSL_RN_LANESF(delta * far_cosine), sine = sine_a + far_sine;
  const ksl_statesf cosine_a = KSL_RN_LANESF(delta * far_sine), cosine = far_cosine - cosine_a;
  const ksl_statesf far_x = ksl_choice_lanesf(theta_b, ksl_each_lanesf(1.0f), x);
  const ksl_testsf middle_x_a = ksl_less_lanesf(x, ksl_each_lanesf(4.0f));
  const ksl_statesf middle_x = ksl_choice_lanesf(middle_x_a, ksl_each_lanesf(4.0f), x);
  const ksl_statesf closed1 = sine / theta;
  const ksl_statesf versine = 1.0f - cosine;
  const ksl_statesf closed2 = versine / far_x;
  const ksl_statesf rest3 = 1.0f - closed1;
  const ksl_statesf closed3 = rest3 / middle_x;
  const ksl_statesf g1a = KSL_RN_LANESF(6.4469503e-26f * x), g1b = g1a - 3.8681703e-23f, g1c =
      KSL_RN_LANESF(x * g1b),
      g1d = g1c + 1.9572942e-20f, g1e = KSL_RN_LANESF(x * g1d), g1f = g1e - 8.220635e-18f, g1g =
          KSL_RN_LANESF(x * g1f),
      g1h = g1g + 2.8114574e-15f, g1i = KSL_RN_LANESF(x * g1h), g1j = g1i - 7.6471636e-13f, g1k =
          KSL_RN_LANESF(x * g1j),
      g1l = g1k + 1.6059044e-10f, g1m = KSL_RN_LANESF(x * g1l), g1n = g1m - 2.5052108e-08f, g1o =
          KSL_RN_LANESF(x * g1n),
      g1p = g1o + 2.7557319e-06f, g1q = KSL_RN_LANESF(x * g1p), g1r = g1q - 0.0001984127f, g1s =
          KSL_RN_LANESF(x * g1r),
      g1t = g1s + 0.008333334f, g1u = KSL_RN_LANESF(x * g1t), g1v = g1u - 0.16666667f, g1w =
          KSL_RN_LANESF(x * g1v),
      g1x = g1w + 1.0f, g1 = ksl_choice_lanesf(theta_b, g1x, closed1);
  const ksl_statesf g2a = KSL_RN_LANESF(2.4795963e-27f * x), g2b = g2a - 1.6117376e-24f, g2c =
      KSL_RN_LANESF(x * g2b),
      g2d = g2c + 8.896791e-22f, g2e = KSL_RN_LANESF(x * g2d), g2f = g2e - 4.1103176e-19f, g2g =
          KSL_RN_LANESF(x * g2f),
      g2h = g2g + 1.5619207e-16f, g2i = KSL_RN_LANESF(x * g2h), g2j = g2i - 4.7794773e-14f, g2k =
          KSL_RN_LANESF(x * g2j),
      g2l = g2k + 1.1470745e-11f, g2m = KSL_RN_LANESF(x * g2l), g2n = g2m - 2.0876756e-09f, g2o =
          KSL_RN_LANESF(x * g2n),
      g2p = g2o + 2.755732e-07f, g2q = KSL_RN_LANESF(x * g2p), g2r = g2q - 2.4801588e-05f, g2s =
          KSL_RN_LANESF(x * g2r),
      g2t = g2s + 0.0013888889f, g2u = KSL_RN_LANESF(x * g2t), g2v = g2u - 0.041666668f, g2w =
          KSL_RN_LANESF(x * g2v),
      g2x = g2w + 0.5f, g2 = ksl_choice_lanesf(theta_b, g2x, closed2);
  const ksl_statesf g3a = KSL_RN_LANESF(9.18369e-29f * x), g3b = g3a - 6.4469503e-26f, g3c =
      KSL_RN_LANESF(x * g3b),
      g3d = g3c + 3.8681703e-23f, g3e = KSL_RN_LANESF(x * g3d), g3f = g3e - 1.9572942e-20f, g3g =
          KSL_RN_LANESF(x * g3f),
      g3h = g3g + 8.220635e-18f, g3i = KSL_RN_LANESF(x * g3h), g3j = g3i - 2.8114574e-15f, g3k =
          KSL_RN_LANESF(x * g3j),
      g3l = g3k + 7.6471636e-13f, g3m = KSL_RN_LANESF(x * g3l), g3n = g3m - 1.6059044e-10f, g3o =
          KSL_RN_LANESF(x * g3n),
      g3p = g3o + 2.5052108e-08f, g3q = KSL_RN_LANESF(x * g3p), g3r = g3q - 2.7557319e-06f, g3s =
          KSL_RN_LANESF(x * g3r),
      g3t = g3s + 0.0001984127f, g3u = KSL_RN_LANESF(x * g3t), g3v = g3u - 0.008333334f, g3w =
          KSL_RN_LANESF(x * g3v),
      g3x = g3w + 0.16666667f, g3 = ksl_choice_lanesf(middle_x_a, g3x, closed3);
  const ksl_testsf late_x_a = ksl_less_lanesf(x, ksl_each_lanesf(9.0f));
  const ksl_statesf late_x = ksl_choice_lanesf(late_x_a, ksl_each_lanesf(1.0f), x);
  const ksl_statesf rate2_rest_a = KSL_RN_LANESF(2.0f * g2), rate2_rest = g1 - rate2_rest_a;
  const ksl_statesf closed_rate2 = rate2_rest / late_x;
  const ksl_statesf rate3_rest_a = KSL_RN_LANESF(3.0f * g3), rate3_rest = g2 - rate3_rest_a;
  const ksl_statesf closed_rate3 = rate3_rest / late_x;
  const ksl_statesf rate2a = KSL_RN_LANESF(8.527712e-29f * x), rate2b = 5.951031e-26f - rate2a,
      rate2c = KSL_RN_LANESF(x * rate2b), rate2d = rate2c - 3.5458228e-23f, rate2e = KSL_RN_LANESF(x
          * rate2d),
      rate2f = rate2e + 1.7793582e-20f, rate2g = KSL_RN_LANESF(x * rate2f), rate2h = rate2g -
          7.398571e-18f,
      rate2i = KSL_RN_LANESF(x * rate2h), rate2j = rate2i + 2.499073e-15f, rate2k = KSL_RN_LANESF(x
          * rate2j),
      rate2l = rate2k - 6.691268e-13f, rate2m = KSL_RN_LANESF(x * rate2l), rate2n = rate2m +
          1.3764895e-10f,
      rate2o = KSL_RN_LANESF(x * rate2n), rate2p = rate2o - 2.0876756e-08f, rate2q = KSL_RN_LANESF(x
          * rate2p),
      rate2r = rate2q + 2.2045856e-06f, rate2s = KSL_RN_LANESF(x * rate2r), rate2t = rate2s -
          0.00014880953f,
      rate2u = KSL_RN_LANESF(x * rate2t), rate2v = rate2u + 0.0055555557f, rate2w = KSL_RN_LANESF(x
          * rate2v),
      rate2x = rate2w - 0.083333336f, rate2 = ksl_choice_lanesf(late_x_a, rate2x, closed_rate2);
  const ksl_statesf rate3a = KSL_RN_LANESF(2.9405903e-30f * x), rate3b = 2.2040857e-27f - rate3a,
      rate3c = KSL_RN_LANESF(x * rate3b), rate3d = rate3c - 1.418329e-24f, rate3e = KSL_RN_LANESF(x
          * rate3d),
      rate3f = rate3e + 7.7363405e-22f, rate3g = KSL_RN_LANESF(x * rate3f), rate3h = rate3g -
          3.5231295e-19f,
      rate3i = KSL_RN_LANESF(x * rate3h), rate3j = rate3i + 1.3153016e-16f, rate3k = KSL_RN_LANESF(x
          * rate3j),
      rate3l = rate3k - 3.93604e-14f, rate3m = KSL_RN_LANESF(x * rate3l), rate3n = rate3m +
          9.176596e-12f,
      rate3o = KSL_RN_LANESF(x * rate3n), rate3p = rate3o - 1.6059044e-09f, rate3q = KSL_RN_LANESF(x
          * rate3p),
      rate3r = rate3q + 2.0041686e-07f, rate3s = KSL_RN_LANESF(x * rate3r), rate3t = rate3s -
          1.6534392e-05f,
      rate3u = KSL_RN_LANESF(x * rate3t), rate3v = rate3u + 0.0007936508f, rate3w = KSL_RN_LANESF(x
          * rate3v),
      rate3x = rate3w - 0.016666668f, rate3 = ksl_choice_lanesf(late_x_a, rate3x, closed_rate3);
  const ksl_statesf beta_v_1 = s[3] * g3;
  const ksl_statesf beta_v_2 = s[4] * g3;
  const ksl_statesf m_1 = KSL_RN_LANESF(s[3] * beta_v_1);
  const ksl_statesf m_2 = KSL_RN_LANESF(s[4] * beta_v_2);
  const ksl_statesf m_3 = KSL_RN_LANESF(s[5] * (s[5] * g3));
  const ksl_statesf m_4 = KSL_RN_LANESF(s[4] * beta_v_1);
  const ksl_statesf m_5 = KSL_RN_LANESF(s[5] * beta_v_1);
  const ksl_statesf m_6 = KSL_RN_LANESF(s[5] * beta_v_2);
  const ksl_statesf others_1 = m_2 + m_3;
  const ksl_statesf others_2 = m_1 + m_3;
  const ksl_statesf others_3 = m_1 + m_2;
  const ksl_statesf diagonal0a = 1.0f - others_1, diagonal0b = g1 + m_1;
  const ksl_testsf diagonal0c = ksl_less_lanesf(m_1, others_1);
  const ksl_statesf diagonal0 = ksl_choice_lanesf(diagonal0c, diagonal0b, diagonal0a);
  const ksl_statesf diagonal1a = 1.0f - others_2, diagonal1b = g1 + m_2;
  const ksl_testsf diagonal1c = ksl_less_lanesf(m_2, others_2);
  const ksl_statesf diagonal1 = ksl_choice_lanesf(diagonal1c, diagonal1b, diagonal1a);
  const ksl_statesf diagonal2a = 1.0f - others_3, diagonal2b = g1 + m_3;
  const ksl_testsf diagonal2c = ksl_less_lanesf(m_3, others_3);
  const ksl_statesf diagonal2 = ksl_choice_lanesf(diagonal2c, diagonal2b, diagonal2a);
  const ksl_statesf alpha_v_1 = KSL_RN_LANESF(s[3] * g2);
  const ksl_statesf alpha_v_2 = KSL_RN_LANESF(s[4] * g2);
  const ksl_statesf alpha_v_3 = KSL_RN_LANESF(s[5] * g2);
  const ksl_statesf J_1 = m_4 - alpha_v_3;
  const ksl_statesf J_2 = m_5 + alpha_v_2;
  const ksl_statesf J_3 = m_4 + alpha_v_3;
  const ksl_statesf J_4 = m_6 - alpha_v_1;
  const ksl_statesf J_5 = m_5 - alpha_v_2;
  const ksl_statesf J_6 = m_6 + alpha_v_1;
  const ksl_statesf rate_vw_a = KSL_RN_LANESF(s[0] * s[3]), rate_vw_b = KSL_RN_LANESF(s[1] * s[4]),
      rate_vw_c = rate_vw_a + rate_vw_b, rate_vw_d = KSL_RN_LANESF(s[2] * s[5]),
      rate_vw = rate_vw_c + rate_vw_d;
  const ksl_statesf rate_turn = rate2 * rate_vw;
  const ksl_statesf rate_bend_a = rate3 * rate_vw, rate_bend = -rate_bend_a;
  const ksl_statesf rate_q_0a = KSL_RN_LANESF(s[0] * g2), rate_q_0b = KSL_RN_LANESF(s[3] *
      rate_turn),
      rate_q_1 = rate_q_0a + rate_q_0b;
  const ksl_statesf rate_q_1a = KSL_RN_LANESF(s[1] * g2), rate_q_1b = KSL_RN_LANESF(s[4] *
      rate_turn),
      rate_q_2 = rate_q_1a + rate_q_1b;
  const ksl_statesf rate_q_2a = KSL_RN_LANESF(s[2] * g2), rate_q_2b = KSL_RN_LANESF(s[5] *
      rate_turn),
      rate_q_3 = rate_q_2a + rate_q_2b;
  const ksl_statesf rate_beta_v_1 = s[0] * g3;
  const ksl_statesf rate_beta_v_2 = s[1] * g3;
  const ksl_statesf rate_beta_v_3 = s[2] * g3;
  const ksl_statesf rate_bend_w_1 = s[3] * rate_bend;
  const ksl_statesf rate_bend_w_2 = s[4] * rate_bend;
  const ksl_statesf rate_symmetric_0a = KSL_RN_LANESF(s[3] * rate_beta_v_2),
      rate_symmetric_0b = KSL_RN_LANESF(s[4] * rate_beta_v_1),
      rate_symmetric_0c = rate_symmetric_0a + rate_symmetric_0b,
      rate_symmetric_0d = KSL_RN_LANESF(s[4] * rate_bend_w_1),
      rate_symmetric_1 = rate_symmetric_0c - rate_symmetric_0d;
  const ksl_statesf rate_symmetric_1a = KSL_RN_LANESF(s[3] * rate_beta_v_3),
      rate_symmetric_1b = KSL_RN_LANESF(s[5] * rate_beta_v_1),
      rate_symmetric_1c = rate_symmetric_1a + rate_symmetric_1b,
      rate_symmetric_1d = KSL_RN_LANESF(s[5] * rate_bend_w_1),
      rate_symmetric_2 = rate_symmetric_1c - rate_symmetric_1d;
  const ksl_statesf rate_symmetric_2a = KSL_RN_LANESF(s[4] * rate_beta_v_3),
      rate_symmetric_2b = KSL_RN_LANESF(s[5] * rate_beta_v_2),
      rate_symmetric_2c = rate_symmetric_2a + rate_symmetric_2b,
      rate_symmetric_2d = KSL_RN_LANESF(s[5] * rate_bend_w_2),
      rate_symmetric_3 = rate_symmetric_2c - rate_symmetric_2d;
  const ksl_statesf rate_diagonal_0a = KSL_RN_LANESF(s[4] * rate_bend_w_2),
      rate_diagonal_0b = KSL_RN_LANESF(s[5] * (s[5] * rate_bend)),
      rate_diagonal_0c = rate_diagonal_0a + rate_diagonal_0b, rate_diagonal_0d = 2.0f * s[4],
      rate_diagonal_0e = KSL_RN_LANESF(rate_diagonal_0d * rate_beta_v_2), rate_diagonal_0f = 2.0f *
          s[5],
      rate_diagonal_0g = KSL_RN_LANESF(rate_diagonal_0f * rate_beta_v_3),
      rate_diagonal_0h = rate_diagonal_0e + rate_diagonal_0g,
      rate_diagonal_1 = rate_diagonal_0c - rate_diagonal_0h;
  const ksl_statesf rate_diagonal_1a = KSL_RN_LANESF(s[3] * rate_bend_w_1),
      rate_diagonal_1b = rate_diagonal_1a + rate_diagonal_0b, rate_diagonal_1c = 2.0f * s[3],
      rate_diagonal_1d = KSL_RN_LANESF(rate_diagonal_1c * rate_beta_v_1),
      rate_diagonal_1e = rate_diagonal_1d + rate_diagonal_0g,
      rate_diagonal_2 = rate_diagonal_1b - rate_diagonal_1e;
  const ksl_statesf rate_diagonal_2a = rate_diagonal_1a + rate_diagonal_0a,
      rate_diagonal_2b = rate_diagonal_1d + rate_diagonal_0e,
      rate_diagonal_3 = rate_diagonal_2a - rate_diagonal_2b;
  const ksl_statesf M_1 = rate_symmetric_1 - rate_q_3;
  const ksl_statesf M_2 = rate_q_2 + rate_symmetric_2;
  const ksl_statesf M_3 = rate_q_3 + rate_symmetric_1;
  const ksl_statesf M_4 = rate_symmetric_3 - rate_q_1;
  const ksl_statesf M_5 = rate_symmetric_2 - rate_q_2;
  const ksl_statesf M_6 = rate_q_1 + rate_symmetric_3;
  M[0] = diagonal0;
  M[6] = J_1;
  M[12] = J_2;
  M[18] = rate_diagonal_1;
  M[24] = M_1;
  M[30] = M_2;
  M[1] = J_3;
  M[7] = diagonal1;
  M[13] = J_4;
  M[19] = M_3;
  M[25] = rate_diagonal_2;
  M[31] = M_4;
  M[2] = J_5;
  M[8] = J_6;
  M[14] = diagonal2;
  M[20] = M_5;
  M[26] = M_6;
  M[32] = rate_diagonal_3;
  M[3] = ksl_each_lanesf(0.0f);
  M[9] = ksl_each_lanesf(0.0f);
  M[15] = ksl_each_lanesf(0.0f);
  M[21] = diagonal0;
  M[27] = J_1;
  M[33] = J_2;
  M[4] = ksl_each_lanesf(0.0f);
  M[10] = ksl_each_lanesf(0.0f);
  M[16] = ksl_each_lanesf(0.0f);
  M[22] = J_3;
  M[28] = diagonal1;
  M[34] = J_4;
  M[5] = ksl_each_lanesf(0.0f);
  M[11] = ksl_each_lanesf(0.0f);
  M[17] = ksl_each_lanesf(0.0f);
  M[23] = J_5;
  M[29] = J_6;
  M[35] = diagonal2;
}

static KSL_INLINE void ksl_SE3f_rightJacobian_states(const ksl_statesf *s, ksl_statesf *M) {
  const ksl_statesf sizes_a = ksl_abs_lanesf(s[3]) + ksl_abs_lanesf(s[4]),
      sizes = sizes_a + ksl_abs_lanesf(s[5]);
  const ksl_statesf grid = KSL_RN_LANESF(sizes * 8192.0f);
  const ksl_statesf high_1 = s[3] + grid - grid;
  const ksl_statesf high_2 = s[4] + grid - grid;
  const ksl_statesf high_3 = s[5] + grid - grid;
  const ksl_statesf squares_a = KSL_RN_LANESF(high_1 * high_1), squares_b = KSL_RN_LANESF(high_2 *
      high_2),
      squares_c = squares_a + squares_b, squares_d = KSL_RN_LANESF(high_3 * high_3),
      squares = squares_c + squares_d;
  const ksl_statesf cross_a = KSL_RN_LANESF((s[3] - high_1) * (s[3] + high_1)),
      cross_b = KSL_RN_LANESF((s[4] - high_2) * (s[4] + high_2)), cross_c = cross_a + cross_b,
      cross_d = KSL_RN_LANESF((s[5] - high_3) * (s[5] + high_3)), cross = cross_c + cross_d;
  const ksl_statesf x = squares + cross;
  const ksl_statesf theta_a = ksl_sqrt_lanesf(x);
  const ksl_testsf theta_b = ksl_less_lanesf(x, ksl_each_lanesf(1.0f));
  const ksl_statesf theta = ksl_choice_lanesf(theta_b, ksl_each_lanesf(1.0f), theta_a);
  const ksl_statesf theta_shifted = grid + theta;
  const ksl_statesf theta_high = theta_shifted - grid;
  const ksl_statesf theta_low = theta - theta_high;
  const ksl_statesf theta_sum = theta + theta_high;
  const ksl_statesf cross_rest_a = KSL_RN_LANESF(theta_low * theta_sum), cross_rest = cross -
      cross_rest_a;
  const ksl_statesf exact_a = KSL_RN_LANESF(theta_high * theta_high), exact = squares - exact_a;
  const ksl_statesf residual = cross_rest + exact;
  const ksl_statesf small_a = 0.5f * residual, small = small_a / theta;
  const ksl_statesf delta_a = ksl_abs_lanesf(small);
  const ksl_testsf delta_b = ksl_less_lanesf(delta_a, ksl_each_lanesf(0.0078125f));
  const ksl_statesf delta = ksl_choice_lanesf(delta_b, small, ksl_each_lanesf(0.0f));
  ksl_statesf far_cosine_a; const ksl_statesf far_sine_a = ksl_sincos_lanesf(theta, &far_cosine_a);
  const ksl_statesf far_sine = ksl_choice_lanesf(theta_b, ksl_each_lanesf(1.0f), far_sine_a);
  const ksl_statesf far_cosine = ksl_choice_lanesf(theta_b, ksl_each_lanesf(0.0f), far_cosine_a);
  const ksl_statesf sine_a = KSL_RN_LANESF(delta * far_cosine), sine = sine_a + far_sine;
  const ksl_statesf cosine_a = KSL_RN_LANESF(delta * far_sine), cosine = far_cosine - cosine_a;
  const ksl_statesf far_x = ksl_choice_lanesf(theta_b, ksl_each_lanesf(1.0f), x);
  const ksl_testsf middle_x_a = ksl_less_lanesf(x, ksl_each_lanesf(4.0f));
  const ksl_statesf middle_x = ksl_choice_lanesf(middle_x_a, ksl_each_lanesf(4.0f), x);
  const ksl_statesf closed1 = sine / theta;
  const ksl_statesf versine = 1.0f - cosine;
  const ksl_statesf closed2 = versine / far_x;
  const ksl_statesf rest3 = 1.0f - closed1;
  const ksl_statesf closed3 = rest3 / middle_x;
  const ksl_statesf g1a = KSL_RN_LANESF(6.4469503e-26f * x), g1b = g1a - 3.8681703e-23f, g1c =
      KSL_RN_LANESF(x * g1b),
      g1d = g1c + 1.9572942e-20f, g1e = KSL_RN_LANESF(x * g1d), g1f = g1e - 8.220635e-18f, g1g =
          KSL_RN_LANESF(x * g1f),
      g1h = g1g + 2.8114574e-15f, g1i = KSL_RN_LANESF(x * g1h), g1j = g1i - 7.6471636e-13f, g1k =
          KSL_RN_LANESF(x * g1j),
      g1l = g1k + 1.6059044e-10f, g1m = KSL_RN_LANESF(x * g1l), g1n = g1m - 2.5052108e-08f, g1o =
          KSL_RN_LANESF(x * g1n),
      g1p = g1o + 2.7557319e-06f, g1q = KSL_RN_LANESF(x * g1p), g1r = g1q - 0.0001984127f, g1s =
          KSL_RN_LANESF(x * g1r),
      g1t = g1s + 0.008333334f, g1u = KSL_RN_LANESF(x * g1t), g1v = g1u - 0.16666667f, g1w =
          KSL_RN_LANESF(x * g1v),
      g1x = g1w + 1.0f, g1 = ksl_choice_lanesf(theta_b, g1x, closed1);
  const ksl_statesf g2a = KSL_RN_LANESF(2.4795963e-27f * x), g2b = g2a - 1.6117376e-24f, g2c =
      KSL_RN_LANESF(x * g2b),
      g2d = g2c + 8.896791e-22f, g2e = KSL_RN_LANESF(x * g2d), g2f = g2e - 4.1103176e-19f, g2g =
          KSL_RN_LANESF(x * g2f),
      g2h = g2g + 1.5619207e-16f, g2i = KSL_RN_LANESF(x * g2h), g2j = g2i - 4.7794773e-14f, g2k =
          KSL_RN_LANESF(x * g2j),
      g2l = g2k + 1.1470745e-11f, g2m = KSL_RN_LANESF(x * g2l), g2n = g2m - 2.0876756e-09f, g2o =
          KSL_RN_LANESF(x * g2n),
      g2p = g2o + 2.755732e-07f, g2q = KSL_RN_LANESF(x * g2p), g2r = g2q - 2.4801588e-05f, g2s =
          KSL_RN_LANESF(x * g2r),
      g2t = g2s + 0.0013888889f, g2u = KSL_RN_LANESF(x * g2t), g2v = g2u - 0.041666668f, g2w =
          KSL_RN_LANESF(x * g2v),
      g2x = g2w + 0.5f, g2 = ksl_choice_lanesf(theta_b, g2x, closed2);
  const ksl_statesf g3a = KSL_RN_LANESF(9.18369e-29f * x), g3b = g3a - 6.4469503e-26f, g3c =
      KSL_RN_LANESF(x * g3b),
      g3d = g3c + 3.8681703e-23f, g3e = KSL_RN_LANESF(x * g3d), g3f = g3e - 1.9572942e-20f, g3g =
          KSL_RN_LANESF(x * g3f),
      g3h = g3g + 8.220635e-18f, g3i = KSL_RN_LANESF(x * g3h), g3j = g3i - 2.8114574e-15f, g3k =
          KSL_RN_LANESF(x * g3j),
      g3l = g3k + 7.6471636e-13f, g3m = KSL_RN_LANESF(x * g3l), g3n = g3m - 1.6059044e-10f, g3o =
          KSL_RN_LANESF(x * g3n),
      g3p = g3o + 2.5052108e-08f, g3q = KSL_RN_LANESF(x * g3p), g3r = g3q - 2.7557319e-06f, g3s =
          KSL_RN_LANESF(x * g3r),
      g3t = g3s + 0.0001984127f, g3u = KSL_RN_LANESF(x * g3t), g3v = g3u - 0.008333334f, g3w =
          KSL_RN_LANESF(x * g3v),
      g3x = g3w + 0.16666667f, g3 = ksl_choice_lanesf(middle_x_a, g3x, closed3);
  const ksl_testsf late_x_a = ksl_less_lanesf(x, ksl_each_lanesf(9.0f));
  const ksl_statesf late_x = ksl_choice_lanesf(late_x_a, ksl_each_lanesf(1.0f), x);
  const ksl_statesf rate2_rest_a = KSL_RN_LANESF(2.0f * g2), rate2_rest = g1 - rate2_rest_a;
  const ksl_statesf closed_rate2 = rate2_rest / late_x;
  const ksl_statesf rate3_rest_a = KSL_RN_LANESF(3.0f * g3), rate3_rest = g2 - rate3_rest_a;
  const ksl_statesf closed_rate3 = rate3_rest / late_x;
  const ksl_statesf rate2a = KSL_RN_LANESF(8.527712e-29f * x), rate2b = 5.951031e-26f - rate2a,
      rate2c = KSL_RN_LANESF(x * rate2b), rate2d = rate2c - 3.5458228e-23f, rate2e = KSL_RN_LANESF(x
          * rate2d),
      rate2f = rate2e + 1.7793582e-20f, rate2g = KSL_RN_LANESF(x * rate2f), rate2h = rate2g -
          7.398571e-18f,
      rate2i = KSL_RN_LANESF(x * rate2h), rate2j = rate2i + 2.499073e-15f, rate2k = KSL_RN_LANESF(x
          * rate2j),
      rate2l = rate2k - 6.691268e-13f, rate2m = KSL_RN_LANESF(x * rate2l), rate2n = rate2m +
          1.3764895e-10f,
      rate2o = KSL_RN_LANESF(x * rate2n), rate2p = rate2o - 2.0876756e-08f, rate2q = KSL_RN_LANESF(x
          * rate2p),
      rate2r = rate2q + 2.2045856e-06f, rate2s = KSL_RN_LANESF(x * rate2r), rate2t = rate2s -
          0.00014880953f,
      rate2u = KSL_RN_LANESF(x * rate2t), rate2v = rate2u + 0.0055555557f, rate2w = KSL_RN_LANESF(x
          * rate2v),
      rate2x = rate2w - 0.083333336f, rate2 = ksl_choice_lanesf(late_x_a, rate2x, closed_rate2);
  const ksl_statesf rate3a = KSL_RN_LANESF(2.9405903e-30f * x), rate3b = 2.2040857e-27f - rate3a,
      rate3c = KSL_RN_LANESF(x * rate3b), rate3d = rate3c - 1.418329e-24f, rate3e = KSL_RN_LANESF(x
          * rate3d),
      rate3f = rate3e + 7.7363405e-22f, rate3g = KSL_RN_LANESF(x * rate3f), rate3h = rate3g -
          3.5231295e-19f,
      rate3i = KSL_RN_LANESF(x * rate3h), rate3j = rate3i + 1.3153016e-16f, rate3k = KSL_RN_LANESF(x
          * rate3j),
      rate3l = rate3k - 3.93604e-14f, rate3m = KSL_RN_LANESF(x * rate3l), rate3n = rate3m +
          9.176596e-12f,
      rate3o = KSL_RN_LANESF(x * rate3n), rate3p = rate3o - 1.6059044e-09f, rate3q = KSL_RN_LANESF(x
          * rate3p),
      rate3r = rate3q + 2.0041686e-07f, rate3s = KSL_RN_LANESF(x * rate3r), rate3t = rate3s -
          1.6534392e-05f,
      rate3u = KSL_RN_LANESF(x * rate3t), rate3v = rate3u + 0.0007936508f, rate3w = KSL_RN_LANESF(x
          * rate3v),
      rate3x = rate3w - 0.016666668f, rate3 = ksl_choice_lanesf(late_x_a, rate3x, closed_rate3);
  const ksl_statesf beta_v_1 = s[3] * g3;
  const ksl_statesf beta_v_2 = s[4] * g3;
  const ksl_statesf m_1 = KSL_RN_LANESF(s[3] * beta_v_1);
  const ksl_statesf m_2 = KSL_RN_LANESF(s[4] * beta_v_2);
  const ksl_statesf m_3 = KSL_RN_LANESF(s[5] * (s[5] * g3));
  const ksl_statesf m_4 = KSL_RN_LANESF(s[4] * beta_v_1);
  const ksl_statesf m_5 = KSL_RN_LANESF(s[5] * beta_v_1);
  const ksl_statesf m_6 = KSL_RN_LANESF(s[5] * beta_v_2);
  const ksl_statesf others_1 = m_2 + m_3;
  const ksl_statesf others_2 = m_1 + m_3;
  const ksl_statesf others_3 = m_1 + m_2;
  const ksl_statesf diagonal0a = 1.0f - others_1, diagonal0b = g1 + m_1;
  const ksl_testsf diagonal0c = ksl_less_lanesf(m_1, others_1);
  const ksl_statesf diagonal0 = ksl_choice_lanesf(diagonal0c, diagonal0b, diagonal0a);
  const ksl_statesf diagonal1a = 1.0f - others_2, diagonal1b = g1 + m_2;
  const ksl_testsf diagonal1c = ksl_less_lanesf(m_2, others_2);
  const ksl_statesf diagonal1 = ksl_choice_lanesf(diagonal1c, diagonal1b, diagonal1a);
  const ksl_statesf diagonal2a = 1.0f - others_3, diagonal2b = g1 + m_3;
  const ksl_testsf diagonal2c = ksl_less_lanesf(m_3, others_3);
  const ksl_statesf diagonal2 = ksl_choice_lanesf(diagonal2c, diagonal2b, diagonal2a);
  const ksl_statesf alpha_v_0a = KSL_RN_LANESF(s[3] * g2), alpha_v_1 = -alpha_v_0a;
  const ksl_statesf alpha_v_1a = KSL_RN_LANESF(s[4] * g2), alpha_v_2 = -alpha_v_1a;
  const ksl_statesf alpha_v_2a = KSL_RN_LANESF(s[5] * g2), alpha_v_3 = -alpha_v_2a;
  const ksl_statesf J_1 = m_4 - alpha_v_3;
  const ksl_statesf J_2 = m_5 + alpha_v_2;
  const ksl_statesf J_3 = m_4 + alpha_v_3;
  const ksl_statesf J_4 = m_6 - alpha_v_1;
  const ksl_statesf J_5 = m_5 - alpha_v_2;
  const ksl_statesf J_6 = m_6 + alpha_v_1;
  const ksl_statesf rate_vw_a = KSL_RN_LANESF(s[0] * s[3]), rate_vw_b = KSL_RN_LANESF(s[1] * s[4]),
      rate_vw_c = rate_vw_a + rate_vw_b, rate_vw_d = KSL_RN_LANESF(s[2] * s[5]),
      rate_vw = rate_vw_c + rate_vw_d;
  const ksl_statesf rate_turn = rate2 * rate_vw;
  const ksl_statesf rate_bend_a = rate3 * rate_vw, rate_bend = -rate_bend_a;
  const ksl_statesf rate_q_0a = KSL_RN_LANESF(s[0] * g2), rate_q_0b = KSL_RN_LANESF(s[3] *
      rate_turn),
      rate_q_0c = rate_q_0a + rate_q_0b, rate_q_1 = -rate_q_0c;
  const ksl_statesf rate_q_1a = KSL_RN_LANESF(s[1] * g2), rate_q_1b = KSL_RN_LANESF(s[4] *
      rate_turn),
      rate_q_1c = rate_q_1a + rate_q_1b, rate_q_2 = -rate_q_1c;
  const ksl_statesf rate_q_2a = KSL_RN_LANESF(s[2] * g2), rate_q_2b = KSL_RN_LANESF(s[5] *
      rate_turn),
      rate_q_2c = rate_q_2a + rate_q_2b, rate_q_3 = -rate_q_2c;
  const ksl_statesf rate_beta_v_0a = s[0] * g3, rate_beta_v_1 = -rate_beta_v_0a;
  const ksl_statesf rate_beta_v_1a = s[1] * g3, rate_beta_v_2 = -rate_beta_v_1a;
  const ksl_statesf rate_beta_v_2a = s[2] * g3, rate_beta_v_3 = -rate_beta_v_2a;
  const ksl_statesf rate_bend_w_0a = s[3] * rate_bend, rate_bend_w_1 = -rate_bend_w_0a;
  const ksl_statesf rate_bend_w_1a = s[4] * rate_bend, rate_bend_w_2 = -rate_bend_w_1a;
  const ksl_statesf rate_bend_w_2a = s[5] * rate_bend;
  const ksl_statesf rate_symmetric_0a = KSL_RN_LANESF(s[4] * rate_bend_w_1),
      rate_symmetric_0b = KSL_RN_LANESF(s[3] * rate_beta_v_2), rate_symmetric_0c =
          KSL_RN_LANESF(s[4] * rate_beta_v_1),
      rate_symmetric_0d = rate_symmetric_0b + rate_symmetric_0c,
      rate_symmetric_1 = rate_symmetric_0a - rate_symmetric_0d;
  const ksl_statesf rate_symmetric_1a = KSL_RN_LANESF(s[5] * rate_bend_w_1),
      rate_symmetric_1b = KSL_RN_LANESF(s[3] * rate_beta_v_3), rate_symmetric_1c =
          KSL_RN_LANESF(s[5] * rate_beta_v_1),
      rate_symmetric_1d = rate_symmetric_1b + rate_symmetric_1c,
      rate_symmetric_2 = rate_symmetric_1a - rate_symmetric_1d;
  const ksl_statesf rate_symmetric_2a = KSL_RN_LANESF(s[5] * rate_bend_w_2),
      rate_symmetric_2b = KSL_RN_LANESF(s[4] * rate_beta_v_3), rate_symmetric_2c =
          KSL_RN_LANESF(s[5] * rate_beta_v_2),
      rate_symmetric_2d = rate_symmetric_2b + rate_symmetric_2c,
      rate_symmetric_3 = rate_symmetric_2a - rate_symmetric_2d;
  const ksl_statesf rate_diagonal_0a = 2.0f * s[4],
      rate_diagonal_0b = KSL_RN_LANESF(rate_diagonal_0a * rate_beta_v_2), rate_diagonal_0c = 2.0f *
          s[5],
      rate_diagonal_0d = KSL_RN_LANESF(rate_diagonal_0c * rate_beta_v_3),
      rate_diagonal_0e = rate_diagonal_0b + rate_diagonal_0d,
      rate_diagonal_0f = KSL_RN_LANESF(s[4] * rate_bend_w_2), rate_diagonal_0g = KSL_RN_LANESF(s[5]
          * -rate_bend_w_2a),
      rate_diagonal_0h = rate_diagonal_0f + rate_diagonal_0g,
      rate_diagonal_1 = rate_diagonal_0e - rate_diagonal_0h;
  const ksl_statesf rate_diagonal_1a = 2.0f * s[3],
      rate_diagonal_1b = KSL_RN_LANESF(rate_diagonal_1a * rate_beta_v_1),
      rate_diagonal_1c = rate_diagonal_1b + rate_diagonal_0d,
      rate_diagonal_1d = KSL_RN_LANESF(s[3] * rate_bend_w_1),
      rate_diagonal_1e = rate_diagonal_1d + rate_diagonal_0g,
      rate_diagonal_2 = rate_diagonal_1c - rate_diagonal_1e;
  const ksl_statesf rate_diagonal_2a = rate_diagonal_1b + rate_diagonal_0b,
      rate_diagonal_2b = rate_diagonal_1d + rate_diagonal_0f,
      rate_diagonal_3 = rate_diagonal_2a - rate_diagonal_2b;
  const ksl_statesf M_1 = rate_symmetric_1 - rate_q_3;
  const ksl_statesf M_2 = rate_q_2 + rate_symmetric_2;
  const ksl_statesf M_3 = rate_q_3 + rate_symmetric_1;
  const ksl_statesf M_4 = rate_symmetric_3 - rate_q_1;
  const ksl_statesf M_5 = rate_symmetric_2 - rate_q_2;
  const ksl_statesf M_6 = rate_q_1 + rate_symmetric_3;
  M[0] = diagonal0;
  M[6] = J_1;
  M[12] = J_2;
  M[18] = rate_diagonal_1;
  M[24] = M_1;
  M[30] = M_2;
  M[1] = J_3;
  M[7] = diagonal1;
  M[13] = J_4;
  M[19] = M_3;
  M[25] = rate_diagonal_2;
  M[31] = M_4;
  M[2] = J_5;
  M[8] = J_6;
  M[14] = diagonal2;
  M[20] = M_5;
  M[26] = M_6;
  M[32] = rate_diagonal_3;
  M[3] = ksl_each_lanesf(0.0f);
  M[9] = ksl_each_lanesf(0.0f);
  M[15] = ksl_each_lanesf(0.0f);
  M[21] = diagonal0;
  M[27] = J_1;
  M[33] = J_2;
  M[4] = ksl_each_lanesf(0.0f);
  M[10] = ksl_each_lanesf(0.0f);
  M[16] = ksl_each_lanesf(0.0f);
  M[22] = J_3;
  M[28] = diagonal1;
  M[34] = J_4;
  M[5] = ksl_each_lanesf(0.0f);
  M[11] = ksl_each_lanesf(0.0f);
  M[17] = ksl_each_lanesf(0.0f);
  M[23] = J_5;
  M[29] = J_6;
  M[35] = diagonal2;
}

static KSL_INLINE void ksl_SE3f_leftJacobianInverse_states(const ksl_statesf *s, ksl_statesf *M) {
  const ksl_statesf sizes_a = ksl_abs_lanesf(s[3]) + ksl_abs_lanesf(s[4]),
      sizes = sizes_a + ksl_abs_lanesf(s[5]);
  const ksl_statesf grid = KSL_RN_LANESF(sizes * 8192.0f);
  const ksl_statesf high_1 = s[3] + grid - grid;
  const ksl_statesf high_2 = s[4] + grid - grid;
  const ksl_statesf high_3 = s[5] + grid - grid;
  const ksl_statesf squares_a = KSL_RN_LANESF(high_1 * high_1), squares_b = KSL_RN_LANESF(high_2 *
      high_2),
      squares_c = squares_a + squares_b, squares_d = KSL_RN_LANESF(high_3 * high_3),
      squares = squares_c + squares_d;
  const ksl_statesf cross_a = KSL_RN_LANESF((s[3] - high_1) * (s[3] + high_1)),
      cross_b = KSL_RN_LANESF((s[4] - high_2) * (s[4] + high_2)), cross_c = cross_a + cross_b,
      cross_d = KSL_RN_LANESF((s[5] - high_3) * (s[5] + high_3)), cross = cross_c + cross_d;
  const ksl_statesf x = squares + cross;
  const ksl_statesf theta_a = ksl_sqrt_lanesf(x);
  const ksl_testsf theta_b = ksl_less_lanesf(x, ksl_each_lanesf(1.0f));
  const ksl_statesf theta = ksl_choice_lanesf(theta_b, ksl_each_lanesf(1.0f), theta_a);
  const ksl_statesf theta_shifted = grid + theta;
  const ksl_statesf theta_high = theta_shifted - grid;
  const ksl_statesf theta_low = theta - theta_high;
  const ksl_statesf theta_sum = theta + theta_high;
  const ksl_statesf cross_rest_a = KSL_RN_LANESF(theta_low * theta_sum), cross_rest = cross -
      cross_rest_a;
  const ksl_statesf exact_a = KSL_RN_LANESF(theta_high * theta_high), exact = squares - exact_a;
  const ksl_statesf residual = cross_rest + exact;
  const ksl_statesf small_a = 0.5f * residual, small = small_a / theta;
  const ksl_statesf delta_a = ksl_abs_lanesf(small);
  const ksl_testsf delta_b = ksl_less_lanesf(delta_a, ksl_each_lanesf(0.0078125f));
  const ksl_statesf delta = ksl_choice_lanesf(delta_b, small, ksl_each_lanesf(0.0f));
  ksl_statesf far_cosine_a; const ksl_statesf far_sine_a = ksl_sincos_lanesf(theta, &far_cosine_a);
  const ksl_statesf far_sine = ksl_choice_lanesf(theta_b, ksl_each_lanesf(1.0f), far_sine_a);
  const ksl_statesf far_cosine = ksl_choice_lanesf(theta_b, ksl_each_lanesf(0.0f), far_cosine_a);
  const ksl_statesf sine_a = KSL_RN_LANESF(delta * far_cosine), sine = sine_a + far_sine;
  const ksl_statesf cosine_a = KSL_RN_LANESF(delta * far_sine), cosine = far_cosine - cosine_a;
  const ksl_statesf above_a = cosine + 1.0f;
  const ksl_testsf above_b = ksl_less_lanesf(cosine, ksl_each_lanesf(0.0f));
  const ksl_statesf above = ksl_choice_lanesf(above_b, sine, above_a);
  const ksl_statesf below_a = 1.0f - cosine, below = ksl_choice_lanesf(above_b, below_a, sine);
  const ksl_statesf cotangent = above / below;
  const ksl_statesf half_cotangent_a = 0.5f * theta,
      half_cotangent = KSL_RN_LANESF(half_cotangent_a * cotangent);
  const ksl_statesf b_rest = 1.0f - half_cotangent;
  const ksl_testsf b_divisor_a = ksl_less_lanesf(x, ksl_each_lanesf(4.0f));
  const ksl_statesf b_divisor = ksl_choice_lanesf(b_divisor_a, ksl_each_lanesf(4.0f), x);
  const ksl_statesf closed_b = b_rest / b_divisor;
  const ksl_statesf b_a = KSL_RN_LANESF(1.4551725e-27f * x), b_b = b_a + 5.744791e-26f, b_c =
      KSL_RN_LANESF(x * b_b),
      b_d = b_c + 2.2679524e-24f, b_e = KSL_RN_LANESF(x * b_d), b_f = b_e + 8.9535176e-23f, b_g =
          KSL_RN_LANESF(x * b_f),
      b_h = b_g + 3.534707e-21f, b_i = KSL_RN_LANESF(x * b_h), b_j = b_i + 1.3954465e-19f, b_k =
          KSL_RN_LANESF(x * b_j),
      b_l = b_k + 5.509003e-18f, b_m = KSL_RN_LANESF(x * b_l), b_n = b_m + 2.1748687e-16f, b_o =
          KSL_RN_LANESF(x * b_n),
      b_p = b_o + 8.586062e-15f, b_q = KSL_RN_LANESF(x * b_p), b_r = b_q + 3.3896803e-13f, b_s =
          KSL_RN_LANESF(x * b_r),
      b_t = b_s + 1.3382536e-11f, b_u = KSL_RN_LANESF(x * b_t), b_v = b_u + 5.2841903e-10f, b_w =
          KSL_RN_LANESF(x * b_v),
      b_x = b_w + 2.0876756e-08f, b_y = KSL_RN_LANESF(x * b_x), b_z = b_y + 8.267196e-07f, b_aa =
          KSL_RN_LANESF(x * b_z),
      b_ab = b_aa + 3.3068784e-05f, b_ac = KSL_RN_LANESF(x * b_ab), b_ad = b_ac + 0.0013888889f,
      b_ae = KSL_RN_LANESF(x * b_ad), b_af = b_ae + 0.083333336f,
      b = ksl_choice_lanesf(b_divisor_a, b_af, closed_b);
  const ksl_statesf b_across_a = KSL_RN_LANESF(x * b), b_across_b = 1.0f - b_across_a,
      b_across = ksl_choice_lanesf(b_divisor_a, b_across_b, half_cotangent);
  const ksl_statesf beta_v_1 = s[3] * b;
  const ksl_statesf beta_v_2 = s[4] * b;
  const ksl_statesf m_1 = KSL_RN_LANESF(s[3] * beta_v_1);
  const ksl_statesf m_2 = KSL_RN_LANESF(s[4] * beta_v_2);
  const ksl_statesf m_3 = KSL_RN_LANESF(s[5] * (s[5] * b));
  const ksl_statesf m_4 = KSL_RN_LANESF(s[4] * beta_v_1);
  const ksl_statesf m_5 = KSL_RN_LANESF(s[5] * beta_v_1);
  const ksl_statesf m_6 = KSL_RN_LANESF(s[5] * beta_v_2);
  const ksl_statesf others_1 = m_2 + m_3;
  const ksl_statesf others_2 = m_1 + m_3;
  const ksl_statesf others_3 = m_1 + m_2;
  const ksl_statesf diagonal0a = 1.0f - others_1, diagonal0b = b_across + m_1;
  const ksl_testsf diagonal0c = ksl_less_lanesf(m_1, others_1);
  const ksl_statesf diagonal0 = ksl_choice_lanesf(diagonal0c, diagonal0b, diagonal0a);
  const ksl_statesf diagonal1a = 1.0f - others_2, diagonal1b = b_across + m_2;
  const ksl_testsf diagonal1c = ksl_less_lanesf(m_2, others_2);
  const ksl_statesf diagonal1 = ksl_choice_lanesf(diagonal1c, diagonal1b, diagonal1a);
  const ksl_statesf diagonal2a = 1.0f - others_3, diagonal2b = b_across + m_3;
  const ksl_testsf diagonal2c = ksl_less_lanesf(m_3, others_3);
  const ksl_statesf diagonal2 = ksl_choice_lanesf(diagonal2c, diagonal2b, diagonal2a);
  const ksl_statesf alpha_v_0a = KSL_RN_LANESF(0.5f * s[3]), alpha_v_1 = -alpha_v_0a;
  const ksl_statesf alpha_v_1a = KSL_RN_LANESF(0.5f * s[4]), alpha_v_2 = -alpha_v_1a;
  const ksl_statesf alpha_v_2a = KSL_RN_LANESF(0.5f * s[5]), alpha_v_3 = -alpha_v_2a;
  const ksl_statesf J_1 = m_4 - alpha_v_3;
  const ksl_statesf J_2 = m_5 + alpha_v_2;
  const ksl_statesf J_3 = m_4 + alpha_v_3;
  const ksl_statesf J_4 = m_6 - alpha_v_1;
  const ksl_statesf J_5 = m_5 - alpha_v_2;
  const ksl_statesf J_6 = m_6 + alpha_v_1;
  const ksl_statesf b_rate_across_a = 2.0f - half_cotangent,
      b_rate_across = b_rate_across_a / b_divisor;
  const ksl_statesf b_rate_square_a = cotangent * cotangent,
      b_rate_square_b = KSL_RN_LANESF(0.25f * b_rate_square_a), b_rate_square = 0.25f +
          b_rate_square_b;
  const ksl_statesf b_rate_rest = b_rate_square - b_rate_across;
  const ksl_statesf closed_b_rate = b_rate_rest / b_divisor;
  const ksl_statesf b_rate_a = KSL_RN_LANESF(3.3612244e-29f * x), b_rate_b = b_rate_a +
      1.2532382e-27f,
      b_rate_c = KSL_RN_LANESF(x * b_rate_b), b_rate_d = b_rate_c + 4.656552e-26f, b_rate_e =
          KSL_RN_LANESF(x * b_rate_d),
      b_rate_f = b_rate_e + 1.7234372e-24f, b_rate_g = KSL_RN_LANESF(x * b_rate_f),
      b_rate_h = b_rate_g + 6.350267e-23f, b_rate_i = KSL_RN_LANESF(x * b_rate_h),
      b_rate_j = b_rate_i + 2.3279144e-21f, b_rate_k = KSL_RN_LANESF(x * b_rate_j),
      b_rate_l = b_rate_k + 8.483297e-20f, b_rate_m = KSL_RN_LANESF(x * b_rate_l),
      b_rate_n = b_rate_m + 3.0699822e-18f, b_rate_o = KSL_RN_LANESF(x * b_rate_n),
      b_rate_p = b_rate_o + 1.10180054e-16f, b_rate_q = KSL_RN_LANESF(x * b_rate_p),
      b_rate_r = b_rate_q + 3.9147635e-15f, b_rate_s = KSL_RN_LANESF(x * b_rate_r),
      b_rate_t = b_rate_s + 1.37377e-13f, b_rate_u = KSL_RN_LANESF(x * b_rate_t),
      b_rate_v = b_rate_u + 4.7455525e-12f, b_rate_w = KSL_RN_LANESF(x * b_rate_v),
      b_rate_x = b_rate_w + 1.6059044e-10f, b_rate_y = KSL_RN_LANESF(x * b_rate_x),
      b_rate_z = b_rate_y + 5.28419e-09f, b_rate_aa = KSL_RN_LANESF(x * b_rate_z),
      b_rate_ab = b_rate_aa + 1.6701405e-07f, b_rate_ac = KSL_RN_LANESF(x * b_rate_ab),
      b_rate_ad = b_rate_ac + 4.9603173e-06f, b_rate_ae = KSL_RN_LANESF(x * b_rate_ad),
      b_rate_af = b_rate_ae + 0.00013227513f, b_rate_ag = KSL_RN_LANESF(x * b_rate_af),
      b_rate_ah = b_rate_ag + 0.0027777778f,
      b_rate = ksl_choice_lanesf(b_divisor_a, b_rate_ah, closed_b_rate);
  const ksl_statesf rate_vw_a = KSL_RN_LANESF(s[0] * s[3]), rate_vw_b = KSL_RN_LANESF(s[1] * s[4]),
      rate_vw_c = rate_vw_a + rate_vw_b, rate_vw_d = KSL_RN_LANESF(s[2] * s[5]),
      rate_vw = rate_vw_c + rate_vw_d;
  const ksl_statesf rate_bend_a = b_rate * rate_vw, rate_bend = -rate_bend_a;
  const ksl_statesf rate_q_0a = KSL_RN_LANESF(0.5f * s[0]), rate_q_1 = -rate_q_0a;
  const ksl_statesf rate_q_1a = KSL_RN_LANESF(0.5f * s[1]), rate_q_2 = -rate_q_1a;
  const ksl_statesf rate_q_2a = KSL_RN_LANESF(0.5f * s[2]), rate_q_3 = -rate_q_2a;
  const ksl_statesf rate_beta_v_1 = s[0] * b;
  const ksl_statesf rate_beta_v_2 = s[1] * b;
  const ksl_statesf rate_beta_v_3 = s[2] * b;
  const ksl_statesf rate_bend_w_1 = s[3] * rate_bend;
  const ksl_statesf rate_bend_w_2 = s[4] * rate_bend;
  const ksl_statesf rate_symmetric_0a = KSL_RN_LANESF(s[3] * rate_beta_v_2),
      rate_symmetric_0b = KSL_RN_LANESF(s[4] * rate_beta_v_1),
      rate_symmetric_0c = rate_symmetric_0a + rate_symmetric_0b,
      rate_symmetric_0d = KSL_RN_LANESF(s[4] * rate_bend_w_1),
      rate_symmetric_1 = rate_symmetric_0c - rate_symmetric_0d;
  const ksl_statesf rate_symmetric_1a = KSL_RN_LANESF(s[3] * rate_beta_v_3),
      rate_symmetric_1b = KSL_RN_LANESF(s[5] * rate_beta_v_1),
      rate_symmetric_1c = rate_symmetric_1a + rate_symmetric_1b,
      rate_symmetric_1d = KSL_RN_LANESF(s[5] * rate_bend_w_1),
      rate_symmetric_2 = rate_symmetric_1c - rate_symmetric_1d;
  const ksl_statesf rate_symmetric_2a = KSL_RN_LANESF(s[4] * rate_beta_v_3),
      rate_symmetric_2b = KSL_RN_LANESF(s[5] * rate_beta_v_2),
      rate_symmetric_2c = rate_symmetric_2a + rate_symmetric_2b,
      rate_symmetric_2d = KSL_RN_LANESF(s[5] * rate_bend_w_2),
      rate_symmetric_3 = rate_symmetric_2c - rate_symmetric_2d;
  const ksl_statesf rate_diagonal_0a = KSL_RN_LANESF(s[4] * rate_bend_w_2),
      rate_diagonal_0b = KSL_RN_LANESF(s[5] * (s[5] * rate_bend)),
      rate_diagonal_0c = rate_diagonal_0a + rate_diagonal_0b, rate_diagonal_0d = 2.0f * s[4],
      rate_diagonal_0e = KSL_RN_LANESF(rate_diagonal_0d * rate_beta_v_2), rate_diagonal_0f = 2.0f *
          s[5],
      rate_diagonal_0g = KSL_RN_LANESF(rate_diagonal_0f * rate_beta_v_3),
      rate_diagonal_0h = rate_diagonal_0e + rate_diagonal_0g,
      rate_diagonal_1 = rate_diagonal_0c - rate_diagonal_0h;
  const ksl_statesf rate_diagonal_1a = KSL_RN_LANESF(s[3] * rate_bend_w_1),
      rate_diagonal_1b = rate_diagonal_1a + rate_diagonal_0b, rate_diagonal_1c = 2.0f * s[3],
      rate_diagonal_1d = KSL_RN_LANESF(rate_diagonal_1c * rate_beta_v_1),
      rate_diagonal_1e = rate_diagonal_1d + rate_diagonal_0g,
      rate_diagonal_2 = rate_diagonal_1b - rate_diagonal_1e;
  const ksl_statesf rate_diagonal_2a = rate_diagonal_1a + rate_diagonal_0a,
      rate_diagonal_2b = rate_diagonal_1d + rate_diagonal_0e,
      rate_diagonal_3 = rate_diagonal_2a - rate_diagonal_2b;
  const ksl_statesf M_1 = rate_symmetric_1 - rate_q_3;
  const ksl_statesf M_2 = rate_q_2 + rate_symmetric_2;
  const ksl_statesf M_3 = rate_q_3 + rate_symmetric_1;
  const ksl_statesf M_4 = rate_symmetric_3 - rate_q_1;
  const ksl_statesf M_5 = rate_symmetric_2 - rate_q_2;
  const ksl_statesf M_6 = rate_q_1 + rate_symmetric_3;
  M[0] = diagonal0;
  M[6] = J_1;
  M[12] = J_2;
  M[18] = rate_diagonal_1;
  M[24] = M_1;
  M[30] = M_2;
  M[1] = J_3;
  M[7] = diagonal1;
  M[13] = J_4;
  M[19] = M_3;
  M[25] = rate_diagonal_2;
  M[31] = M_4;
  M[2] = J_5;
  M[8] = J_6;
  M[14] = diagonal2;
  M[20] = M_5;
  M[26] = M_6;
  M[32] = rate_diagonal_3;
  M[3] = ksl_each_lanesf(0.0f);
  M[9] = ksl_each_lanesf(0.0f);
  M[15] = ksl_each_lanesf(0.0f);
  M[21] = diagonal0;
  M[27] = J_1;
  M[33] = J_2;
  M[4] = ksl_each_lanesf(0.0f);
  M[10] = ksl_each_lanesf(0.0f);
  M[16] = ksl_each_lanesf(0.0f);
  M[22] = J_3;
  M[28] = diagonal1;
  M[34] = J_4;
  M[5] = ksl_each_lanesf(0.0f);
  M[11] = ksl_each_lanesf(0.0f);
  M[17] = ksl_each_lanesf(0.0f);
  M[23] = J_5;
  M[29] = J_6;
  M[35] = diagonal2;
}

static KSL_INLINE void ksl_SE3f_rightJacobianInverse_states(const ksl_statesf *s, ksl_statesf *M) {
  const ksl_statesf sizes_a = ksl_abs_lanesf(s[3]) + ksl_abs_lanesf(s[4]),
      sizes = sizes_a + ksl_abs_lanesf(s[5]);
  const ksl_statesf grid = KSL_RN_LANESF(sizes * 8192.0f);
  const ksl_statesf high_1 = s[3] + grid - grid;
  const ksl_statesf high_2 = s[4] + grid - grid;
  const ksl_statesf high_3 = s[5] + grid - grid;
  const ksl_statesf squares_a = KSL_RN_LANESF(high_1 * high_1), squares_b = KSL_RN_LANESF(high_2 *
      high_2),
      squares_c = squares_a + squares_b, squares_d = KSL_RN_LANESF(high_3 * high_3),
      squares = squares_c + squares_d;
  const ksl_statesf cross_a = KSL_RN_LANESF((s[3] - high_1) * (s[3] + high_1)),
      cross_b = KSL_RN_LANESF((s[4] - high_2) * (s[4] + high_2)), cross_c = cross_a + cross_b,
      cross_d = KSL_RN_LANESF((s[5] - high_3) * (s[5] + high_3)), cross = cross_c + cross_d;
  const ksl_statesf x = squares + cross;
  const ksl_statesf theta_a = ksl_sqrt_lanesf(x);
  const ksl_testsf theta_b = ksl_less_lanesf(x, ksl_each_lanesf(1.0f));
  const ksl_statesf theta = ksl_choice_lanesf(theta_b, ksl_each_lanesf(1.0f), theta_a);
  const ksl_statesf theta_shifted = grid + theta;
  const ksl_statesf theta_high = theta_shifted - grid;
  const ksl_statesf theta_low = theta - theta_high;
  const ksl_statesf theta_sum = theta + theta_high;
  const ksl_statesf cross_rest_a = KSL_RN_LANESF(theta_low * theta_sum), cross_rest = cross -
      cross_rest_a;
  const ksl_statesf exact_a = KSL_RN_LANESF(theta_high * theta_high), exact = squares - exact_a;
  const ksl_statesf residual = cross_rest + exact;
  const ksl_statesf small_a = 0.5f * residual, small = small_a / theta;
  const ksl_statesf delta_a = ksl_abs_lanesf(small);
  const ksl_testsf delta_b = ksl_less_lanesf(delta_a, ksl_each_lanesf(0.0078125f));
  const ksl_statesf delta = ksl_choice_lanesf(delta_b, small, ksl_each_lanesf(0.0f));
  ksl_statesf far_cosine_a; const ksl_statesf far_sine_a = ksl_sincos_lanesf(theta, &far_cosine_a);
  const ksl_statesf far_sine = ksl_choice_lanesf(theta_b, ksl_each_lanesf(1.0f), far_sine_a);
  const ksl_statesf far_cosine = ksl_choice_lanesf(theta_b, ksl_each_lanesf(0.0f), far_cosine_a);
  const ksl_statesf sine_a = KSL_RN_LANESF(delta * far_cosine), sine = sine_a + far_sine;
  const ksl_statesf cosine_a = KSL_RN_LANESF(delta * far_sine), cosine = far_cosine - cosine_a;
  const ksl_statesf above_a = cosine + 1.0f;
  const ksl_testsf above_b = ksl_less_lanesf(cosine, ksl_each_lanesf(0.0f));
  const ksl_statesf above = ksl_choice_lanesf(above_b, sine, above_a);
  const ksl_statesf below_a = 1.0f - cosine, below = ksl_choice_lanesf(above_b, below_a, sine);
  const ksl_statesf cotangent = above / below;
  const ksl_statesf half_cotangent_a = 0.5f * theta,
      half_cotangent = KSL_RN_LANESF(half_cotangent_a * cotangent);
  const ksl_statesf b_rest = 1.0f - half_cotangent;
  const ksl_testsf b_divisor_a = ksl_less_lanesf(x, ksl_each_lanesf(4.0f));
  const ksl_statesf b_divisor = ksl_choice_lanesf(b_divisor_a, ksl_each_lanesf(4.0f), x);
  const ksl_statesf closed_b = b_rest / b_divisor;
  const ksl_statesf b_a = KSL_RN_LANESF(1.4551725e-27f * x), b_b = b_a + 5.744791e-26f, b_c =
      KSL_RN_LANESF(x * b_b),
      b_d = b_c + 2.2679524e-24f, b_e = KSL_RN_LANESF(x * b_d), b_f = b_e + 8.9535176e-23f, b_g =
          KSL_RN_LANESF(x * b_f),
      b_h = b_g + 3.534707e-21f, b_i = KSL_RN_LANESF(x * b_h), b_j = b_i + 1.3954465e-19f, b_k =
          KSL_RN_LANESF(x * b_j),
      b_l = b_k + 5.509003e-18f, b_m = KSL_RN_LANESF(x * b_l), b_n = b_m + 2.1748687e-16f, b_o =
          KSL_RN_LANESF(x * b_n),
      b_p = b_o + 8.586062e-15f, b_q = KSL_RN_LANESF(x * b_p), b_r = b_q + 3.3896803e-13f, b_s =
          KSL_RN_LANESF(x * b_r),
      b_t = b_s + 1.3382536e-11f, b_u = KSL_RN_LANESF(x * b_t), b_v = b_u + 5.2841903e-10f, b_w =
          KSL_RN_LANESF(x * b_v),
      b_x = b_w + 2.0876756e-08f, b_y = KSL_RN_LANESF(x * b_x), b_z = b_y + 8.267196e-07f, b_aa =
          KSL_RN_LANESF(x * b_z),
      b_ab = b_aa + 3.3068784e-05f, b_ac = KSL_RN_LANESF(x * b_ab), b_ad = b_ac + 0.0013888889f,
      b_ae = KSL_RN_LANESF(x * b_ad), b_af = b_ae + 0.083333336f,
      b = ksl_choice_lanesf(b_divisor_a, b_af, closed_b);
  const ksl_statesf b_across_a = KSL_RN_LANESF(x * b), b_across_b = 1.0f - b_across_a,
      b_across = ksl_choice_lanesf(b_divisor_a, b_across_b, half_cotangent);
  const ksl_statesf beta_v_1 = s[3] * b;
  const ksl_statesf beta_v_2 = s[4] * b;
  const ksl_statesf m_1 = KSL_RN_LANESF(s[3] * beta_v_1);
  const ksl_statesf m_2 = KSL_RN_LANESF(s[4] * beta_v_2);
  const ksl_statesf m_3 = KSL_RN_LANESF(s[5] * (s[5] * b));
  const ksl_statesf m_4 = KSL_RN_LANESF(s[4] * beta_v_1);
  const ksl_statesf m_5 = KSL_RN_LANESF(s[5] * beta_v_1);
  const ksl_statesf m_6 = KSL_RN_LANESF(s[5] * beta_v_2);
  const ksl_statesf others_1 = m_2 + m_3;
  const ksl_statesf others_2 = m_1 + m_3;
  const ksl_statesf others_3 = m_1 + m_2;
  const ksl_statesf diagonal0a = 1.0f - others_1, diagonal0b = b_across + m_1;
  const ksl_testsf diagonal0c = ksl_less_lanesf(m_1, others_1);
  const ksl_statesf diagonal0 = ksl_choice_lanesf(diagonal0c, diagonal0b, diagonal0a);
  const ksl_statesf diagonal1a = 1.0f - others_2, diagonal1b = b_across + m_2;
  const ksl_testsf diagonal1c = ksl_less_lanesf(m_2, others_2);
  const ksl_statesf diagonal1 = ksl_choice_lanesf(diagonal1c, diagonal1b, diagonal1a);
  const ksl_statesf diagonal2a = 1.0f - others_3, diagonal2b = b_across + m_3;
  const ksl_testsf diagonal2c = ksl_less_lanesf(m_3, others_3);
  const ksl_statesf diagonal2 = ksl_choice_lanesf(diagonal2c, diagonal2b, diagonal2a);
  const ksl_statesf alpha_v_1 = KSL_RN_LANESF(0.5f * s[3]);
  const ksl_statesf alpha_v_2 = KSL_RN_LANESF(0.5f * s[4]);
  const ksl_statesf alpha_v_3 = KSL_RN_LANESF(0.5f * s[5]);
  const ksl_statesf J_1 = m_4 - alpha_v_3;
  const ksl_statesf J_2 = m_5 + alpha_v_2;
  const ksl_statesf J_3 = m_4 + alpha_v_3;
  const ksl_statesf J_4 = m_6 - alpha_v_1;
  const ksl_statesf J_5 = m_5 - alpha_v_2;
  const ksl_statesf J_6 = m_6 + alpha_v_1;
  const ksl_statesf b_rate_across_a = 2.0f - half_cotangent,
      b_rate_across = b_rate_across_a / b_divisor;
  const ksl_statesf b_rate_square_a = cotangent * cotangent,
      b_rate_square_b = KSL_RN_LANESF(0.25f * b_rate_square_a), b_rate_square = 0.25f +
          b_rate_square_b;
  const ksl_statesf b_rate_rest = b_rate_square - b_rate_across;
  const ksl_statesf closed_b_rate = b_rate_rest / b_divisor;
  const ksl_statesf b_rate_a = KSL_RN_LANESF(3.3612244e-29f * x), b_rate_b = b_rate_a +
      1.2532382e-27f,
      b_rate_c = KSL_RN_LANESF(x * b_rate_b), b_rate_d = b_rate_c + 4.656552e-26f, b_rate_e =
          KSL_RN_LANESF(x * b_rate_d),
      b_rate_f = b_rate_e + 1.7234372e-24f, b_rate_g = KSL_RN_LANESF(x * b_rate_f),
      b_rate_h = b_rate_g + 6.350267e-23f, b_rate_i = KSL_RN_LANESF(x * b_rate_h),
      b_rate_j = b_rate_i + 2.3279144e-21f, b_rate_k = KSL_RN_LANESF(x * b_rate_j),
      b_rate_l = b_rate_k + 8.483297e-20f, b_rate_m = KSL_RN_LANESF(x * b_rate_l),
      b_rate_n = b_rate_m + 3.0699822e-18f, b_rate_o = KSL_RN_LANESF(x * b_rate_n),
      b_rate_p = b_rate_o + 1.10180054e-16f, b_rate_q = KSL_RN_LANESF(x * b_rate_p),
      b_rate_r = b_rate_q + 3.9147635e-15f, b_rate_s = KSL_RN_LANESF(x * b_rate_r),
      b_rate_t = b_rate_s + 1.37377e-13f, b_rate_u = KSL_RN_LANESF(x * b_rate_t),
      b_rate_v = b_rate_u + 4.7455525e-12f, b_rate_w = KSL_RN_LANESF(x * b_rate_v),
      b_rate_x = b_rate_w + 1.6059044e-10f, b_rate_y = KSL_RN_LANESF(x * b_rate_x),
      b_rate_z = b_rate_y + 5.28419e-09f, b_rate_aa = KSL_RN_LANESF(x * b_rate_z),
      b_rate_ab = b_rate_aa + 1.6701405e-07f, b_rate_ac = KSL_RN_LANESF(x * b_rate_ab),
      b_rate_ad = b_rate_ac + 4.9603173e-06f, b_rate_ae = KSL_RN_LANESF(x * b_rate_ad),
      b_rate_af = b_rate_ae + 0.00013227513f, b_rate_ag = KSL_RN_LANESF(x * b_rate_af),
      b_rate_ah = b_rate_ag + 0.0027777778f,
      b_rate = ksl_choice_lanesf(b_divisor_a, b_rate_ah, closed_b_rate);
  const ksl_statesf rate_vw_a = KSL_RN_LANESF(s[0] * s[3]), rate_vw_b = KSL_RN_LANESF(s[1] * s[4]),
      rate_vw_c = rate_vw_a + rate_vw_b, rate_vw_d = KSL_RN_LANESF(s[2] * s[5]),
      rate_vw = rate_vw_c + rate_vw_d;
  const ksl_statesf rate_bend_a = b_rate * rate_vw, rate_bend = -rate_bend_a;
  const ksl_statesf rate_q_1 = KSL_RN_LANESF(0.5f * s[0]);
  const ksl_statesf rate_q_2 = KSL_RN_LANESF(0.5f * s[1]);
  const ksl_statesf rate_q_3 = KSL_RN_LANESF(0.5f * s[2]);
  const ksl_statesf rate_beta_v_0a = s[0] * b, rate_beta_v_1 = -rate_beta_v_0a;
  const ksl_statesf rate_beta_v_1a = s[1] * b, rate_beta_v_2 = -rate_beta_v_1a;
  const ksl_statesf rate_beta_v_2a = s[2] * b, rate_beta_v_3 = -rate_beta_v_2a;
  const ksl_statesf rate_bend_w_0a = s[3] * rate_bend, rate_bend_w_1 = -rate_bend_w_0a;
  const ksl_statesf rate_bend_w_1a = s[4] * rate_bend, rate_bend_w_2 = -rate_bend_w_1a;
  const ksl_statesf rate_bend_w_2a = s[5] * rate_bend;
  const ksl_statesf rate_symmetric_0a = KSL_RN_LANESF(s[4] * rate_bend_w_1),
      rate_symmetric_0b = KSL_RN_LANESF(s[3] * rate_beta_v_2), rate_symmetric_0c =
          KSL_RN_LANESF(s[4] * rate_beta_v_1),
      rate_symmetric_0d = rate_symmetric_0b + rate_symmetric_0c,
      rate_symmetric_1 = rate_symmetric_0a - rate_symmetric_0d;
  const ksl_statesf rate_symmetric_1a = KSL_RN_LANESF(s[5] * rate_bend_w_1),
      rate_symmetric_1b = KSL_RN_LANESF(s[3] * rate_beta_v_3), rate_symmetric_1c =
          KSL_RN_LANESF(s[5] * rate_beta_v_1),
      rate_symmetric_1d = rate_symmetric_1b + rate_symmetric_1c,
      rate_symmetric_2 = rate_symmetric_1a - rate_symmetric_1d;
  const ksl_statesf rate_symmetric_2a = KSL_RN_LANESF(s[5] * rate_bend_w_2),
      rate_symmetric_2b = KSL_RN_LANESF(s[4] * rate_beta_v_3), rate_symmetric_2c =
          KSL_RN_LANESF(s[5] * rate_beta_v_2),
      rate_symmetric_2d = rate_symmetric_2b + rate_symmetric_2c,
      rate_symmetric_3 = rate_symmetric_2a - rate_symmetric_2d;
  const ksl_statesf rate_diagonal_0a = 2.0f * s[4],
      rate_diagonal_0b = KSL_RN_LANESF(rate_diagonal_0a * rate_beta_v_2), rate_diagonal_0c = 2.0f *
          s[5],
      rate_diagonal_0d = KSL_RN_LANESF(rate_diagonal_0c * rate_beta_v_3),
      rate_diagonal_0e = rate_diagonal_0b + rate_diagonal_0d,
      rate_diagonal_0f = KSL_RN_LANESF(s[4] * rate_bend_w_2), rate_diagonal_0g = KSL_RN_LANESF(s[5]
          * -rate_bend_w_2a),
      rate_diagonal_0h = rate_diagonal_0f + rate_diagonal_0g,
      rate_diagonal_1 = rate_diagonal_0e - rate_diagonal_0h;
  const ksl_statesf rate_diagonal_1a = 2.0f * s[3],
      rate_diagonal_1b = KSL_RN_LANESF(rate_diagonal_1a * rate_beta_v_1),
      rate_diagonal_1c = rate_diagonal_1b + rate_diagonal_0d,
      rate_diagonal_1d = KSL_RN_LANESF(s[3] * rate_bend_w_1),
      rate_diagonal_1e = rate_diagonal_1d + rate_diagonal_0g,
      rate_diagonal_2 = rate_diagonal_1c - rate_diagonal_1e;
  const ksl_statesf rate_diagonal_2a = rate_diagonal_1b + rate_diagonal_0b,
      rate_diagonal_2b = rate_diagonal_1d + rate_diagonal_0f,
      rate_diagonal_3 = rate_diagonal_2a - rate_diagonal_2b;
  const ksl_statesf M_1 = rate_symmetric_1 - rate_q_3;
  const ksl_statesf M_2 = rate_q_2 + rate_symmetric_2;
  const ksl_statesf M_3 = rate_q_3 + rate_symmetric_1;
  const ksl_statesf M_4 = rate_symmetric_3 - rate_q_1;
  const ksl_statesf M_5 = rate_symmetric_2 - rate_q_2;
  const ksl_statesf M_6 = rate_q_1 + rate_symmetric_3;
  M[0] = diagonal0;
  M[6] = J_1;
  M[12] = J_2;
  M[18] = rate_diagonal_1;
  M[24] = M_1;
  M[30] = M_2;
  M[1] = J_3;
  M[7] = diagonal1;
  M[13] = J_4;
  M[19] = M_3;
  M[25] = rate_diagonal_2;
  M[31] = M_4;
  M[2] = J_5;
  M[8] = J_6;
  M[14] = diagonal2;
  M[20] = M_5;
  M[26] = M_6;
  M[32] = rate_diagonal_3;
  M[3] = ksl_each_lanesf(0.0f);
  M[9] = ksl_each_lanesf(0.0f);
  M[15] = ksl_each_lanesf(0.0f);
  M[21] = diagonal0;
  M[27] = J_1;
  M[33] = J_2;
  M[4] = ksl_each_lanesf(0.0f);
  M[10] = ksl_each_lanesf(0.0f);
  M[16] = ksl_each_lanesf(0.0f);
  M[22] = J_3;
  M[28] = diagonal1;
  M[34] = J_4;
  M[5] = ksl_each_lanesf(0.0f);
  M[11] = ksl_each_lanesf(0.0f);
  M[17] = ksl_each_lanesf(0.0f);
  M[23] = J_5;
  M[29] = J_6;
  M[35] = diagonal2;
}

static KSL_INLINE void ksl_SE3f_interpolated_states(const ksl_statesf *D1, const ksl_statesf *D2,
    const ksl_statesf *k, ksl_statesf *Do) {
  const ksl_statesf apart_1 = D2[9] - D1[9];
  const ksl_statesf apart_2 = D2[10] - D1[10];
  const ksl_statesf apart_3 = D2[11] - D1[11];
  const ksl_statesf between_0a = KSL_RN_LANESF(D1[0] * D2[0]), between_0b = KSL_RN_LANESF(D1[1] *
      D2[1]),
      between_0c = between_0a + between_0b, between_0d = KSL_RN_LANESF(D1[2] * D2[2]),
      between_1 = between_0c + between_0d;
  const ksl_statesf between_1a = KSL_RN_LANESF(D1[0] * D2[3]), between_1b = KSL_RN_LANESF(D1[1] *
      D2[4]),
      between_1c = between_1a + between_1b, between_1d = KSL_RN_LANESF(D1[2] * D2[5]),
      between_2 = between_1c + between_1d;
  const ksl_statesf between_2a = KSL_RN_LANESF(D1[0] * D2[6]), between_2b = KSL_RN_LANESF(D1[1] *
      D2[7]),
      between_2c = between_2a + between_2b, between_2d = KSL_RN_LANESF(D1[2] * D2[8]),
      between_3 = between_2c + between_2d;
  const ksl_statesf between_3a = KSL_RN_LANESF(D1[0] * apart_1), between_3b = KSL_RN_LANESF(D1[1] *
      apart_2),
      between_3c = between_3a + between_3b, between_3d = KSL_RN_LANESF(D1[2] * apart_3),
      between_4 = between_3c + between_3d;
  const ksl_statesf between_4a = KSL_RN_LANESF(D1[3] * D2[0]), between_4b = KSL_RN_LANESF(D1[4] *
      D2[1]),
      between_4c = between_4a + between_4b, between_4d = KSL_RN_LANESF(D1[5] * D2[2]),
      between_5 = between_4c + between_4d;
  const ksl_statesf between_5a = KSL_RN_LANESF(D1[3] * D2[3]), between_5b = KSL_RN_LANESF(D1[4] *
      D2[4]),
      between_5c = between_5a + between_5b, between_5d = KSL_RN_LANESF(D1[5] * D2[5]),
      between_6 = between_5c + between_5d;
  const ksl_statesf between_6a = KSL_RN_LANESF(D1[3] * D2[6]), between_6b = KSL_RN_LANESF(D1[4] *
      D2[7]),
      between_6c = between_6a + between_6b, between_6d = KSL_RN_LANESF(D1[5] * D2[8]),
      between_7 = between_6c + between_6d;
  const ksl_statesf between_7a = KSL_RN_LANESF(D1[3] * apart_1), between_7b = KSL_RN_LANESF(D1[4] *
      apart_2),
      between_7c = between_7a + between_7b, between_7d = KSL_RN_LANESF(D1[5] * apart_3),
      between_8 = between_7c + between_7d;
  const ksl_statesf between_8a = KSL_RN_LANESF(D1[6] * D2[0]), between_8b = KSL_RN_LANESF(D1[7] *
      D2[1]),
      between_8c = between_8a + between_8b, between_8d = KSL_RN_LANESF(D1[8] * D2[2]),
      between_9 = between_8c + between_8d;
  const ksl_statesf between_9a = KSL_RN_LANESF(D1[6] * D2[3]), between_9b = KSL_RN_LANESF(D1[7] *
      D2[4]),
      between_9c = between_9a + between_9b, between_9d = KSL_RN_LANESF(D1[8] * D2[5]),
      between_10 = between_9c + between_9d;
  const ksl_statesf between_10a = KSL_RN_LANESF(D1[6] * D2[6]), between_10b = KSL_RN_LANESF(D1[7] *
      D2[7]),
      between_10c = between_10a + between_10b, between_10d = KSL_RN_LANESF(D1[8] * D2[8]),
      between_11 = between_10c + between_10d;
  const ksl_statesf between_11a = KSL_RN_LANESF(D1[6] * apart_1), between_11b = KSL_RN_LANESF(D1[7]
      * apart_2),
      between_11c = between_11a + between_11b, between_11d = KSL_RN_LANESF(D1[8] * apart_3),
      between_12 = between_11c + between_11d;
  const ksl_statesf log_p_1 = between_10 - between_7;
  const ksl_statesf log_p_2 = between_3 - between_9;
  const ksl_statesf log_p_3 = between_5 - between_2;
  const ksl_statesf log_s_1 = between_7 + between_10;
  const ksl_statesf log_s_2 = between_3 + between_9;
  const ksl_statesf log_s_3 = between_2 + between_5;
  const ksl_statesf log_first_1 = between_1 + 1.0f;
  const ksl_statesf log_first_2 = 1.0f - between_1;
  const ksl_statesf log_others_1 = between_6 + between_11;
  const ksl_statesf log_others_2 = between_6 - between_11;
  const ksl_testsf log_low_0a = ksl_less_lanesf(between_6, between_1);
  const ksl_statesf log_high_0a = -between_6;
  const ksl_testsf log_high_0b = ksl_less_lanesf(between_1, log_high_0a);
  const ksl_testsf log_column_0a = ksl_less_lanesf(between_11, ksl_each_lanesf(0.0f));
  const ksl_statesf log_column_1 = ksl_choice_lanesf(log_column_0a, ksl_choice_lanesf(log_low_0a,
      log_first_1 - log_others_1, log_s_3), ksl_choice_lanesf(log_high_0b, log_s_2, log_p_1));
  const ksl_statesf log_column_2 = ksl_choice_lanesf(log_column_0a, ksl_choice_lanesf(log_low_0a,
      log_s_3, log_first_2 + log_others_2), ksl_choice_lanesf(log_high_0b, log_s_1, log_p_2));
  const ksl_statesf log_column_3 = ksl_choice_lanesf(log_column_0a, ksl_choice_lanesf(log_low_0a,
      log_s_2, log_s_1), ksl_choice_lanesf(log_high_0b, log_first_2 - log_others_2, log_p_3));
  const ksl_statesf log_column_4 = ksl_choice_lanesf(log_column_0a, ksl_choice_lanesf(log_low_0a,
      log_p_1, log_p_2), ksl_choice_lanesf(log_high_0b, log_p_3, log_first_1 + log_others_1));
  const ksl_statesf log_upper_0a = -log_column_1;
  const ksl_testsf log_upper_0b = ksl_less_lanesf(log_column_4, ksl_each_lanesf(0.0f));
  const ksl_statesf log_upper_1 = ksl_choice_lanesf(log_upper_0b, log_upper_0a, log_column_1);
  const ksl_statesf log_upper_1a = -log_column_2,
      log_upper_2 = ksl_choice_lanesf(log_upper_0b, log_upper_1a, log_column_2);
  const ksl_statesf log_upper_2a = -log_column_3,
      log_upper_3 = ksl_choice_lanesf(log_upper_0b, log_upper_2a, log_column_3);
  const ksl_statesf log_upper_3a = -log_column_4,
      log_upper_4 = ksl_choice_lanesf(log_upper_0b, log_upper_3a, log_column_4);
  const ksl_statesf log_v_s_size_1 = ksl_abs_lanesf(log_upper_1);
  const ksl_statesf log_v_s_size_2 = ksl_abs_lanesf(log_upper_2);
  const ksl_statesf log_v_s_size_3 = ksl_abs_lanesf(log_upper_3);
  const ksl_testsf log_v_s_largest1a = ksl_less_lanesf(log_v_s_size_1, log_v_s_size_2);
  const ksl_statesf log_v_s_largest1 = ksl_choice_lanesf(log_v_s_largest1a, log_v_s_size_2,
      log_v_s_size_1);
  const ksl_testsf log_v_s_largest2a = ksl_less_lanesf(log_v_s_largest1, log_v_s_size_3);
  const ksl_statesf log_v_s_largest2 = ksl_choice_lanesf(log_v_s_largest2a, log_v_s_size_3,
      log_v_s_largest1);
  const ksl_testsf log_v_s_a = ksl_less_lanesf(ksl_each_lanesf(4.611686e+18f), log_v_s_largest2);
  const ksl_statesf log_v_s_b = ksl_choice_lanesf(log_v_s_a, ksl_each_lanesf(2.7105054e-20f),
      ksl_each_lanesf(1.0f));
  const ksl_testsf log_v_s_c = ksl_less_lanesf(log_v_s_largest2, ksl_each_lanesf(256.0f));
  const ksl_statesf log_v_s_d = ksl_choice_lanesf(log_v_s_c, ksl_each_lanesf(1.8014399e+16f),
      log_v_s_b);
  const ksl_testsf log_v_s_e = ksl_less_lanesf(log_v_s_largest2, ksl_each_lanesf(1.4210855e-14f));
  const ksl_statesf log_v_s = ksl_choice_lanesf(log_v_s_e, ksl_each_lanesf(3.2451855e+32f),
      log_v_s_d);
  const ksl_statesf log_v_y_1 = log_upper_1 * log_v_s;
  const ksl_statesf log_v_y_2 = log_upper_2 * log_v_s;
  const ksl_statesf log_v_y_3 = log_upper_3 * log_v_s;
  const ksl_statesf log_v_n_a = KSL_RN_LANESF(log_v_y_1 * log_v_y_1), log_v_n_b =
      KSL_RN_LANESF(log_v_y_2 * log_v_y_2),
      log_v_n_c = log_v_n_a + log_v_n_b, log_v_n_d = KSL_RN_LANESF(log_v_y_3 * log_v_y_3),
      log_v_n_e = log_v_n_c + log_v_n_d, log_v_n = ksl_sqrt_lanesf(log_v_n_e);
  const ksl_testsf log_v_r_a = ksl_less_lanesf(log_v_s, ksl_each_lanesf(1.0f));
  const ksl_statesf log_v_r_b = ksl_choice_lanesf(log_v_r_a, ksl_each_lanesf(3.689349e+19f),
      ksl_each_lanesf(1.0f));
  const ksl_testsf log_v_r_c = ksl_less_lanesf(ksl_each_lanesf(1.0f), log_v_s);
  const ksl_statesf log_v_r_d = ksl_choice_lanesf(log_v_r_c, ksl_each_lanesf(5.551115e-17f),
      log_v_r_b);
  const ksl_testsf log_v_r_e = ksl_less_lanesf(ksl_each_lanesf(1.8014399e+16f), log_v_s);
  const ksl_statesf log_v_r = ksl_choice_lanesf(log_v_r_e, ksl_each_lanesf(3.081488e-33f),
      log_v_r_d);
  const ksl_statesf log_n = log_v_n * log_v_r;
  const ksl_statesf log_half = ksl_atan2_lanesf(log_n, log_upper_4);
  const ksl_testsf log_divisor_a = ksl_equal_lanesf(log_n, ksl_each_lanesf(0.0f));
  const ksl_statesf log_divisor = ksl_choice_lanesf(log_divisor_a, ksl_each_lanesf(1.0f), log_n);
  const ksl_statesf log_theta = 2.0f * log_half;
  const ksl_statesf log_k = log_theta / log_divisor;
  const ksl_statesf log_vector_1 = log_upper_1 * log_k;
  const ksl_statesf log_vector_2 = log_upper_2 * log_k;
  const ksl_statesf log_vector_3 = log_upper_3 * log_k;
  const ksl_statesf log_x = log_theta * log_theta;
  const ksl_testsf log_far_sine_a = ksl_less_lanesf(log_x, ksl_each_lanesf(1.0f));
  const ksl_statesf log_far_sine = ksl_choice_lanesf(log_far_sine_a, ksl_each_lanesf(1.0f), log_n);
  const ksl_statesf log_cotangent = log_upper_4 / log_far_sine;
  const ksl_statesf log_half_cotangent_a = 0.5f * log_theta,
      log_half_cotangent = KSL_RN_LANESF(log_half_cotangent_a * log_cotangent);
  const ksl_statesf log_b_rest = 1.0f - log_half_cotangent;
  const ksl_testsf log_b_divisor_a = ksl_less_lanesf(log_x, ksl_each_lanesf(4.0f));
  const ksl_statesf log_b_divisor = ksl_choice_lanesf(log_b_divisor_a, ksl_each_lanesf(4.0f),
      log_x);
  const ksl_statesf log_closed_b = log_b_rest / log_b_divisor;
  const ksl_statesf log_b_a = KSL_RN_LANESF(1.4551725e-27f * log_x), log_b_b = log_b_a +
      5.744791e-26f,
      log_b_c = KSL_RN_LANESF(log_x * log_b_b), log_b_d = log_b_c + 2.2679524e-24f,
      log_b_e = KSL_RN_LANESF(log_x * log_b_d), log_b_f = log_b_e + 8.9535176e-23f,
      log_b_g = KSL_RN_LANESF(log_x * log_b_f), log_b_h = log_b_g + 3.534707e-21f,
      log_b_i = KSL_RN_LANESF(log_x * log_b_h), log_b_j = log_b_i + 1.3954465e-19f,
      log_b_k = KSL_RN_LANESF(log_x * log_b_j), log_b_l = log_b_k + 5.509003e-18f,
      log_b_m = KSL_RN_LANESF(log_x * log_b_l), log_b_n = log_b_m + 2.1748687e-16f,
      log_b_o = KSL_RN_LANESF(log_x * log_b_n), log_b_p = log_b_o + 8.586062e-15f,
      log_b_q = KSL_RN_LANESF(log_x * log_b_p), log_b_r = log_b_q + 3.3896803e-13f,
      log_b_s = KSL_RN_LANESF(log_x * log_b_r), log_b_t = log_b_s + 1.3382536e-11f,
      log_b_u = KSL_RN_LANESF(log_x * log_b_t), log_b_v = log_b_u + 5.2841903e-10f,
      log_b_w = KSL_RN_LANESF(log_x * log_b_v), log_b_x = log_b_w + 2.0876756e-08f,
      log_b_y = KSL_RN_LANESF(log_x * log_b_x), log_b_z = log_b_y + 8.267196e-07f,
      log_b_aa = KSL_RN_LANESF(log_x * log_b_z), log_b_ab = log_b_aa + 3.3068784e-05f,
      log_b_ac = KSL_RN_LANESF(log_x * log_b_ab), log_b_ad = log_b_ac + 0.0013888889f,
      log_b_ae = KSL_RN_LANESF(log_x * log_b_ad), log_b_af = log_b_ae + 0.083333336f,
      log_b = ksl_choice_lanesf(log_b_divisor_a, log_b_af, log_closed_b);
  const ksl_statesf log_b_across_a = KSL_RN_LANESF(log_x * log_b), log_b_across_b = 1.0f -
      log_b_across_a,
      log_b_across = ksl_choice_lanesf(log_b_divisor_a, log_b_across_b, log_half_cotangent);
  const ksl_statesf log_wt_a = KSL_RN_LANESF(between_4 * log_vector_1),
      log_wt_b = KSL_RN_LANESF(between_8 * log_vector_2), log_wt_c = log_wt_a + log_wt_b,
      log_wt_d = KSL_RN_LANESF(between_12 * log_vector_3), log_wt = log_wt_c + log_wt_d;
  const ksl_statesf log_pitch = log_b * log_wt;
  const ksl_statesf log_u_0a = KSL_RN_LANESF(between_12 * log_vector_2),
      log_u_0b = KSL_RN_LANESF(between_8 * log_vector_3);
  const ksl_statesf log_u_1a = KSL_RN_LANESF(between_4 * log_vector_3),
      log_u_1b = KSL_RN_LANESF(between_12 * log_vector_1);
  const ksl_statesf log_u_2a = KSL_RN_LANESF(between_8 * log_vector_1),
      log_u_2b = KSL_RN_LANESF(between_4 * log_vector_2);
  const ksl_statesf whole_0a = KSL_RN_LANESF(between_4 * log_b_across);
  const ksl_statesf whole_1a = KSL_RN_LANESF(between_8 * log_b_across);
  const ksl_statesf whole_2a = KSL_RN_LANESF(between_12 * log_b_across);
  const ksl_statesf screw_1 = k[0]
          * (whole_0a + (KSL_RN_LANESF(log_vector_1 * log_pitch) - KSL_RN_LANESF(0.5f * (log_u_0a -
              log_u_0b))));
  const ksl_statesf screw_2 = k[0]
          * (whole_1a + (KSL_RN_LANESF(log_vector_2 * log_pitch) - KSL_RN_LANESF(0.5f * (log_u_1a -
              log_u_1b))));
  const ksl_statesf screw_3 = k[0]
          * (whole_2a + (KSL_RN_LANESF(log_vector_3 * log_pitch) - KSL_RN_LANESF(0.5f * (log_u_2a -
              log_u_2b))));
  const ksl_statesf screw_4 = KSL_RN_LANESF(k[0] * log_vector_1);
  const ksl_statesf screw_5 = KSL_RN_LANESF(k[0] * log_vector_2);
  const ksl_statesf screw_6 = KSL_RN_LANESF(k[0] * log_vector_3);
  const ksl_statesf exp_sizes_a = ksl_abs_lanesf(screw_4) + ksl_abs_lanesf(screw_5),
      exp_sizes = exp_sizes_a + ksl_abs_lanesf(screw_6);
  const ksl_statesf exp_grid = KSL_RN_LANESF(exp_sizes * 8192.0f);
  const ksl_statesf exp_high_1 = screw_4 + exp_grid - exp_grid;
  const ksl_statesf exp_high_2 = screw_5 + exp_grid - exp_grid;
  const ksl_statesf exp_high_3 = screw_6 + exp_grid - exp_grid;
  const ksl_statesf exp_squares_a = KSL_RN_LANESF(exp_high_1 * exp_high_1),
      exp_squares_b = KSL_RN_LANESF(exp_high_2 * exp_high_2), exp_squares_c = exp_squares_a +
          exp_squares_b,
      exp_squares_d = KSL_RN_LANESF(exp_high_3 * exp_high_3), exp_squares = exp_squares_c +
          exp_squares_d;
  const ksl_statesf exp_cross_a = KSL_RN_LANESF((screw_4 - exp_high_1) * (screw_4 + exp_high_1)),
      exp_cross_b = KSL_RN_LANESF((screw_5 - exp_high_2) * (screw_5 + exp_high_2)),
      exp_cross_c = exp_cross_a + exp_cross_b,
      exp_cross_d = KSL_RN_LANESF((screw_6 - exp_high_3) * (screw_6 + exp_high_3)),
      exp_cross = exp_cross_c + exp_cross_d;
  const ksl_statesf exp_x = exp_squares + exp_cross;
  const ksl_statesf exp_theta_a = ksl_sqrt_lanesf(exp_x);
  const ksl_testsf exp_theta_b = ksl_less_lanesf(exp_x, ksl_each_lanesf(1.0f));
  const ksl_statesf exp_theta = ksl_choice_lanesf(exp_theta_b, ksl_each_lanesf(1.0f), exp_theta_a);
  const ksl_statesf exp_theta_shifted = exp_grid + exp_theta;
  const ksl_statesf exp_theta_high = exp_theta_shifted - exp_grid;
  const ksl_statesf exp_theta_low = exp_theta - exp_theta_high;
  const ksl_statesf exp_theta_sum = exp_theta + exp_theta_high;
  const ksl_statesf exp_cross_rest_a = KSL_RN_LANESF(exp_theta_low * exp_theta_sum),
      exp_cross_rest = exp_cross - exp_cross_rest_a;
  const ksl_statesf exp_exact_a = KSL_RN_LANESF(exp_theta_high * exp_theta_high),
      exp_exact = exp_squares - exp_exact_a;
  const ksl_statesf exp_residual = exp_cross_rest + exp_exact;
  const ksl_statesf exp_small_a = 0.5f * exp_residual, exp_small = exp_small_a / exp_theta;
  const ksl_statesf exp_delta_a = ksl_abs_lanesf(exp_small);
  const ksl_testsf exp_delta_b = ksl_less_lanesf(exp_delta_a, ksl_each_lanesf(0.0078125f));
  const ksl_statesf exp_delta = ksl_choice_lanesf(exp_delta_b, exp_small, ksl_each_lanesf(0.0f));
  ksl_statesf exp_far_cosine_a; const ksl_statesf exp_far_sine_a = ksl_sincos_lanesf(exp_theta,
      &exp_far_cosine_a);
  const ksl_statesf exp_far_sine = ksl_choice_lanesf(exp_theta_b, ksl_each_lanesf(1.0f),
      exp_far_sine_a);
  const ksl_statesf exp_far_cosine = ksl_choice_lanesf(exp_theta_b, ksl_each_lanesf(0.0f),
      exp_far_cosine_a);
  const ksl_statesf exp_sine_a = KSL_RN_LANESF(exp_delta * exp_far_cosine),
      exp_sine = exp_sine_a + exp_far_sine;
  const ksl_statesf exp_cosine_a = KSL_RN_LANESF(exp_delta * exp_far_sine),
      exp_cosine = exp_far_cosine - exp_cosine_a;
  const ksl_statesf exp_far_x = ksl_choice_lanesf(exp_theta_b, ksl_each_lanesf(1.0f), exp_x);
  const ksl_testsf exp_middle_x_a = ksl_less_lanesf(exp_x, ksl_each_lanesf(4.0f));
  const ksl_statesf exp_middle_x = ksl_choice_lanesf(exp_middle_x_a, ksl_each_lanesf(4.0f), exp_x);
  const ksl_statesf exp_closed1 = exp_sine / exp_theta;
  const ksl_statesf exp_versine = 1.0f - exp_cosine;
  const ksl_statesf exp_closed2 = exp_versine / exp_far_x;
  const ksl_statesf exp_rest3 = 1.0f - exp_closed1;
  const ksl_statesf exp_closed3 = exp_rest3 / exp_middle_x;
  const ksl_statesf exp_g1a = KSL_RN_LANESF(6.4469503e-26f * exp_x), exp_g1b = exp_g1a -
      3.8681703e-23f,
      exp_g1c = KSL_RN_LANESF(exp_x * exp_g1b), exp_g1d = exp_g1c + 1.9572942e-20f,
      exp_g1e = KSL_RN_LANESF(exp_x * exp_g1d), exp_g1f = exp_g1e - 8.220635e-18f,
      exp_g1g = KSL_RN_LANESF(exp_x * exp_g1f), exp_g1h = exp_g1g + 2.8114574e-15f,
      exp_g1i = KSL_RN_LANESF(exp_x * exp_g1h), exp_g1j = exp_g1i - 7.6471636e-13f,
      exp_g1k = KSL_RN_LANESF(exp_x * exp_g1j), exp_g1l = exp_g1k + 1.6059044e-10f,
      exp_g1m = KSL_RN_LANESF(exp_x * exp_g1l), exp_g1n = exp_g1m - 2.5052108e-08f,
      exp_g1o = KSL_RN_LANESF(exp_x * exp_g1n), exp_g1p = exp_g1o + 2.7557319e-06f,
      exp_g1q = KSL_RN_LANESF(exp_x * exp_g1p), exp_g1r = exp_g1q - 0.0001984127f,
      exp_g1s = KSL_RN_LANESF(exp_x * exp_g1r), exp_g1t = exp_g1s + 0.008333334f,
      exp_g1u = KSL_RN_LANESF(exp_x * exp_g1t), exp_g1v = exp_g1u - 0.16666667f, exp_g1w =
          KSL_RN_LANESF(exp_x * exp_g1v),
      exp_g1x = exp_g1w + 1.0f, exp_g1 = ksl_choice_lanesf(exp_theta_b, exp_g1x, exp_closed1);
  const ksl_statesf exp_g2a = KSL_RN_LANESF(2.4795963e-27f * exp_x), exp_g2b = exp_g2a -
      1.6117376e-24f,
      exp_g2c = KSL_RN_LANESF(exp_x * exp_g2b), exp_g2d = exp_g2c + 8.896791e-22f,
      exp_g2e = KSL_RN_LANESF(exp_x * exp_g2d), exp_g2f = exp_g2e - 4.1103176e-19f,
      exp_g2g = KSL_RN_LANESF(exp_x * exp_g2f), exp_g2h = exp_g2g + 1.5619207e-16f,
      exp_g2i = KSL_RN_LANESF(exp_x * exp_g2h), exp_g2j = exp_g2i - 4.7794773e-14f,
      exp_g2k = KSL_RN_LANESF(exp_x * exp_g2j), exp_g2l = exp_g2k + 1.1470745e-11f,
      exp_g2m = KSL_RN_LANESF(exp_x * exp_g2l), exp_g2n = exp_g2m - 2.0876756e-09f,
      exp_g2o = KSL_RN_LANESF(exp_x * exp_g2n), exp_g2p = exp_g2o + 2.755732e-07f,
      exp_g2q = KSL_RN_LANESF(exp_x * exp_g2p), exp_g2r = exp_g2q - 2.4801588e-05f,
      exp_g2s = KSL_RN_LANESF(exp_x * exp_g2r), exp_g2t = exp_g2s + 0.0013888889f,
      exp_g2u = KSL_RN_LANESF(exp_x * exp_g2t), exp_g2v = exp_g2u - 0.041666668f,
      exp_g2w = KSL_RN_LANESF(exp_x * exp_g2v), exp_g2x = exp_g2w + 0.5f,
      exp_g2 = ksl_choice_lanesf(exp_theta_b, exp_g2x, exp_closed2);
  const ksl_statesf exp_g3a = KSL_RN_LANESF(9.18369e-29f * exp_x), exp_g3b = exp_g3a -
      6.4469503e-26f,
      exp_g3c = KSL_RN_LANESF(exp_x * exp_g3b), exp_g3d = exp_g3c + 3.8681703e-23f,
      exp_g3e = KSL_RN_LANESF(exp_x * exp_g3d), exp_g3f = exp_g3e - 1.9572942e-20f,
      exp_g3g = KSL_RN_LANESF(exp_x * exp_g3f), exp_g3h = exp_g3g + 8.220635e-18f,
      exp_g3i = KSL_RN_LANESF(exp_x * exp_g3h), exp_g3j = exp_g3i - 2.8114574e-15f,
      exp_g3k = KSL_RN_LANESF(exp_x * exp_g3j), exp_g3l = exp_g3k + 7.6471636e-13f,
      exp_g3m = KSL_RN_LANESF(exp_x * exp_g3l), exp_g3n = exp_g3m - 1.6059044e-10f,
      exp_g3o = KSL_RN_LANESF(exp_x * exp_g3n), exp_g3p = exp_g3o + 2.5052108e-08f,
      exp_g3q = KSL_RN_LANESF(exp_x * exp_g3p), exp_g3r = exp_g3q - 2.7557319e-06f,
      exp_g3s = KSL_RN_LANESF(exp_x * exp_g3r), exp_g3t = exp_g3s + 0.0001984127f,
      exp_g3u = KSL_RN_LANESF(exp_x * exp_g3t), exp_g3v = exp_g3u - 0.008333334f,
      exp_g3w = KSL_RN_LANESF(exp_x * exp_g3v), exp_g3x = exp_g3w + 0.16666667f,
      exp_g3 = ksl_choice_lanesf(exp_middle_x_a, exp_g3x, exp_closed3);
  const ksl_statesf exp_g0a = KSL_RN_LANESF(exp_x * exp_g2), exp_g0b = 1.0f - exp_g0a,
      exp_g0 = ksl_choice_lanesf(exp_theta_b, exp_g0b, exp_cosine);
  const ksl_statesf exp_u_0a = KSL_RN_LANESF(screw_3 * screw_5), exp_u_0b = KSL_RN_LANESF(screw_2 *
      screw_6);
  const ksl_statesf exp_u_1a = KSL_RN_LANESF(screw_1 * screw_6), exp_u_1b = KSL_RN_LANESF(screw_3 *
      screw_4);
  const ksl_statesf exp_u_2a = KSL_RN_LANESF(screw_2 * screw_4), exp_u_2b = KSL_RN_LANESF(screw_1 *
      screw_5);
  const ksl_statesf exp_wv_a = KSL_RN_LANESF(screw_1 * screw_4), exp_wv_b = KSL_RN_LANESF(screw_2 *
      screw_5),
      exp_wv_c = exp_wv_a + exp_wv_b, exp_wv_d = KSL_RN_LANESF(screw_3 * screw_6),
      exp_wv = exp_wv_c + exp_wv_d;
  const ksl_statesf exp_pitch = exp_g3 * exp_wv;
  const ksl_statesf exp_beta_v_1 = screw_4 * exp_g2;
  const ksl_statesf exp_beta_v_2 = screw_5 * exp_g2;
  const ksl_statesf exp_m_1 = KSL_RN_LANESF(screw_4 * exp_beta_v_1);
  const ksl_statesf exp_m_2 = KSL_RN_LANESF(screw_5 * exp_beta_v_2);
  const ksl_statesf exp_m_3 = KSL_RN_LANESF(screw_6 * (screw_6 * exp_g2));
  const ksl_statesf exp_m_4 = KSL_RN_LANESF(screw_5 * exp_beta_v_1);
  const ksl_statesf exp_m_5 = KSL_RN_LANESF(screw_6 * exp_beta_v_1);
  const ksl_statesf exp_m_6 = KSL_RN_LANESF(screw_6 * exp_beta_v_2);
  const ksl_statesf exp_others_1 = exp_m_2 + exp_m_3;
  const ksl_statesf exp_others_2 = exp_m_1 + exp_m_3;
  const ksl_statesf exp_others_3 = exp_m_1 + exp_m_2;
  const ksl_statesf exp_diagonal0a = 1.0f - exp_others_1, exp_diagonal0b = exp_g0 + exp_m_1;
  const ksl_testsf exp_diagonal0c = ksl_less_lanesf(exp_m_1, exp_others_1);
  const ksl_statesf exp_diagonal0 = ksl_choice_lanesf(exp_diagonal0c, exp_diagonal0b,
      exp_diagonal0a);
  const ksl_statesf exp_diagonal1a = 1.0f - exp_others_2, exp_diagonal1b = exp_g0 + exp_m_2;
  const ksl_testsf exp_diagonal1c = ksl_less_lanesf(exp_m_2, exp_others_2);
  const ksl_statesf exp_diagonal1 = ksl_choice_lanesf(exp_diagonal1c, exp_diagonal1b,
      exp_diagonal1a);
  const ksl_statesf exp_diagonal2a = 1.0f - exp_others_3, exp_diagonal2b = exp_g0 + exp_m_3;
  const ksl_testsf exp_diagonal2c = ksl_less_lanesf(exp_m_3, exp_others_3);
  const ksl_statesf exp_diagonal2 = ksl_choice_lanesf(exp_diagonal2c, exp_diagonal2b,
      exp_diagonal2a);
  const ksl_statesf exp_alpha_v_1 = KSL_RN_LANESF(screw_4 * exp_g1);
  const ksl_statesf exp_alpha_v_2 = KSL_RN_LANESF(screw_5 * exp_g1);
  const ksl_statesf exp_alpha_v_3 = KSL_RN_LANESF(screw_6 * exp_g1);
  const ksl_statesf step_1 = exp_m_4 - exp_alpha_v_3;
  const ksl_statesf step_2 = exp_m_5 + exp_alpha_v_2;
  const ksl_statesf step_3a = KSL_RN_LANESF(screw_1 * exp_g1),
      step_3 = step_3a + (KSL_RN_LANESF(exp_g2 * (exp_u_0a - exp_u_0b)) + KSL_RN_LANESF(screw_4 *
          exp_pitch));
  const ksl_statesf step_4 = exp_m_4 + exp_alpha_v_3;
  const ksl_statesf step_5 = exp_m_6 - exp_alpha_v_1;
  const ksl_statesf step_7a = KSL_RN_LANESF(screw_2 * exp_g1),
      step_6 = step_7a + (KSL_RN_LANESF(exp_g2 * (exp_u_1a - exp_u_1b)) + KSL_RN_LANESF(screw_5 *
          exp_pitch));
  const ksl_statesf step_7 = exp_m_5 - exp_alpha_v_2;
  const ksl_statesf step_8 = exp_m_6 + exp_alpha_v_1;
  const ksl_statesf step_11a = KSL_RN_LANESF(screw_3 * exp_g1),
      step_9 = step_11a + (KSL_RN_LANESF(exp_g2 * (exp_u_2a - exp_u_2b)) + KSL_RN_LANESF(screw_6 *
          exp_pitch));
  const ksl_statesf Do_00a = KSL_RN_LANESF(D1[0] * exp_diagonal0), Do_00b = KSL_RN_LANESF(D1[3] *
      step_4),
      Do_00c = KSL_RN_LANESF(D1[6] * step_7), Do_00d = Do_00b + Do_00c, Do_1 = Do_00a + Do_00d;
  const ksl_statesf Do_01a = KSL_RN_LANESF(D1[0] * step_1), Do_01b = KSL_RN_LANESF(D1[6] * step_8),
      Do_01c = Do_01a + Do_01b, Do_01d = KSL_RN_LANESF(D1[3] * exp_diagonal1), Do_2 = Do_01c +
          Do_01d;
  const ksl_statesf Do_02a = KSL_RN_LANESF(D1[0] * step_2), Do_02b = KSL_RN_LANESF(D1[3] * step_5),
      Do_02c = Do_02a + Do_02b, Do_02d = KSL_RN_LANESF(D1[6] * exp_diagonal2), Do_3 = Do_02c +
          Do_02d;
  const ksl_statesf Do_03a = KSL_RN_LANESF(D1[0] * step_3), Do_03b = KSL_RN_LANESF(D1[3] * step_6),
      Do_03c = Do_03a + Do_03b, Do_03d = KSL_RN_LANESF(D1[6] * step_9), Do_03e = Do_03c + Do_03d,
      Do_4 = Do_03e + D1[9];
  const ksl_statesf Do_10a = KSL_RN_LANESF(D1[1] * exp_diagonal0), Do_10b = KSL_RN_LANESF(D1[4] *
      step_4),
      Do_10c = KSL_RN_LANESF(D1[7] * step_7), Do_10d = Do_10b + Do_10c, Do_5 = Do_10a + Do_10d;
  const ksl_statesf Do_11a = KSL_RN_LANESF(D1[1] * step_1), Do_11b = KSL_RN_LANESF(D1[7] * step_8),
      Do_11c = Do_11a + Do_11b, Do_11d = KSL_RN_LANESF(D1[4] * exp_diagonal1), Do_6 = Do_11c +
          Do_11d;
  const ksl_statesf Do_12a = KSL_RN_LANESF(D1[1] * step_2), Do_12b = KSL_RN_LANESF(D1[4] * step_5),
      Do_12c = Do_12a + Do_12b, Do_12d = KSL_RN_LANESF(D1[7] * exp_diagonal2), Do_7 = Do_12c +
          Do_12d;
  const ksl_statesf Do_13a = KSL_RN_LANESF(D1[1] * step_3), Do_13b = KSL_RN_LANESF(D1[4] * step_6),
      Do_13c = Do_13a + Do_13b, Do_13d = KSL_RN_LANESF(D1[7] * step_9), Do_13e = Do_13c + Do_13d,
      Do_8 = Do_13e + D1[10];
  const ksl_statesf Do_20a = KSL_RN_LANESF(D1[2] * exp_diagonal0), Do_20b = KSL_RN_LANESF(D1[5] *
      step_4),
      Do_20c = KSL_RN_LANESF(D1[8] * step_7), Do_20d = Do_20b + Do_20c, Do_9 = Do_20a + Do_20d;
  const ksl_statesf Do_21a = KSL_RN_LANESF(D1[2] * step_1), Do_21b = KSL_RN_LANESF(D1[8] * step_8),
      Do_21c = Do_21a + Do_21b, Do_21d = KSL_RN_LANESF(D1[5] * exp_diagonal1), Do_10 = Do_21c +
          Do_21d;
  const ksl_statesf Do_22a = KSL_RN_LANESF(D1[2] * step_2), Do_22b = KSL_RN_LANESF(D1[5] * step_5),
      Do_22c = Do_22a + Do_22b, Do_22d = KSL_RN_LANESF(D1[8] * exp_diagonal2), Do_11 = Do_22c +
          Do_22d;
  const ksl_statesf Do_23a = KSL_RN_LANESF(D1[2] * step_3), Do_23b = KSL_RN_LANESF(D1[5] * step_6),
      Do_23c = Do_23a + Do_23b, Do_23d = KSL_RN_LANESF(D1[8] * step_9), Do_23e = Do_23c + Do_23d,
      Do_12 = Do_23e + D1[11];
  Do[0] = Do_1;
  Do[3] = Do_2;
  Do[6] = Do_3;
  Do[9] = Do_4;
  Do[1] = Do_5;
  Do[4] = Do_6;
  Do[7] = Do_7;
  Do[10] = Do_8;
  Do[2] = Do_9;
  Do[5] = Do_10;
  Do[8] = Do_11;
  Do[11] = Do_12;
}

#endif
#endif
