/* Made by `coscrew generate`; changes are overwritten. */
/* SPDX-License-Identifier: MIT */
/* coscrew 0.2.0.  Copyright (c) 2026 The coscrew authors. */
/* Quaternions q = (v; w), the scalar last: products, rotations, conversions, interpolation.  On vectors.
   An argument is its components, in the order of structs, each a vector with that of several
   elements: KSL_LANES of them, in single precision KSL_LANESF. */
#ifndef KSL_QUATERNION_STATES_H
#define KSL_QUATERNION_STATES_H

#include "ksl_states.h"

#if KSL_LANE_BYTES
static KSL_INLINE void ksl_quaternion_from_axis_angle_states(const ksl_states *axis,
    const ksl_states *angle, ksl_states *qo) {
  const ksl_states half = 0.5 * angle[0];
  ksl_states qo_4; const ksl_states sine = ksl_sincos_lanes(half, &qo_4);
  const ksl_states qo_1 = KSL_RN_LANES(axis[0] * sine);
  const ksl_states qo_2 = KSL_RN_LANES(axis[1] * sine);
  const ksl_states qo_3 = KSL_RN_LANES(axis[2] * sine);
  qo[0] = qo_1;
  qo[1] = qo_2;
  qo[2] = qo_3;
  qo[3] = qo_4;
}

static KSL_INLINE void ksl_axis_angle_from_quaternion_states(const ksl_states *q,
    ksl_states *angle, ksl_states *axis) {
  const ksl_states s_size_1 = ksl_abs_lanes(q[0]);
  const ksl_states s_size_2 = ksl_abs_lanes(q[1]);
  const ksl_states s_size_3 = ksl_abs_lanes(q[2]);
  const ksl_states s_size_4 = ksl_abs_lanes(q[3]);
  const ksl_tests s_largest1a = ksl_less_lanes(s_size_1, s_size_2);
  const ksl_states s_largest1 = ksl_choice_lanes(s_largest1a, s_size_2, s_size_1);
  const ksl_tests s_largest2a = ksl_less_lanes(s_largest1, s_size_3);
  const ksl_states s_largest2 = ksl_choice_lanes(s_largest2a, s_size_3, s_largest1);
  const ksl_tests s_largest3a = ksl_less_lanes(s_largest2, s_size_4);
  const ksl_states s_largest3 = ksl_choice_lanes(s_largest3a, s_size_4, s_largest2);
  const ksl_tests s_a = ksl_less_lanes(ksl_each_lanes(6.703903964971299e+153), s_largest3);
  const ksl_states s_b = ksl_choice_lanes(s_a, ksl_each_lanes(3.7291703656001034e-155),
      ksl_each_lanes(1.0));
  const ksl_tests s_c = ksl_less_lanes(s_largest3, ksl_each_lanes(256.0));
  const ksl_states s_d = ksl_choice_lanes(s_c, ksl_each_lanes(1.3093562431584567e+151), s_b);
  const ksl_tests s_e = ksl_less_lanes(s_largest3, ksl_each_lanes(1.955159272639747e-149));
  const ksl_states s = ksl_choice_lanes(s_e, ksl_each_lanes(1.0715086071862673e+301), s_d);
  const ksl_states scaled_s_1 = q[0] * s;
  const ksl_states scaled_s_2 = q[1] * s;
  const ksl_states scaled_s_3 = q[2] * s;
  const ksl_states scaled_s_4 = q[3] * s;
  const ksl_states upper_0a = -scaled_s_1;
  const ksl_tests upper_0b = ksl_less_lanes(scaled_s_4, ksl_each_lanes(0.0));
  const ksl_states upper_1 = ksl_choice_lanes(upper_0b, upper_0a, scaled_s_1);
  const ksl_states upper_1a = -scaled_s_2,
      upper_2 = ksl_choice_lanes(upper_0b, upper_1a, scaled_s_2);
  const ksl_states upper_2a = -scaled_s_3,
      upper_3 = ksl_choice_lanes(upper_0b, upper_2a, scaled_s_3);
  const ksl_states upper_3a = -scaled_s_4;
  const ksl_states v_s_size_1 = ksl_abs_lanes(upper_1);
  const ksl_states v_s_size_2 = ksl_abs_lanes(upper_2);
  const ksl_states v_s_size_3 = ksl_abs_lanes(upper_3);
  const ksl_tests v_s_largest1a = ksl_less_lanes(v_s_size_1, v_s_size_2);
  const ksl_states v_s_largest1 = ksl_choice_lanes(v_s_largest1a, v_s_size_2, v_s_size_1);
  const ksl_tests v_s_largest2a = ksl_less_lanes(v_s_largest1, v_s_size_3);
  const ksl_states v_s_largest2 = ksl_choice_lanes(v_s_largest2a, v_s_size_3, v_s_largest1);
  const ksl_tests v_s_a = ksl_less_lanes(v_s_largest2, ksl_each_lanes(256.0));
  const ksl_states v_s_b = ksl_choice_lanes(v_s_a, ksl_each_lanes(1.3093562431584567e+151),
      ksl_each_lanes(1.0));
  const ksl_tests v_s_c = ksl_less_lanes(v_s_largest2, ksl_each_lanes(1.955159272639747e-149));
  const ksl_states v_s = ksl_choice_lanes(v_s_c, ksl_each_lanes(1.0715086071862673e+301), v_s_b);
  const ksl_states v_y_1 = upper_1 * v_s;
  const ksl_states v_y_2 = upper_2 * v_s;
  const ksl_states v_y_3 = upper_3 * v_s;
  const ksl_states v_n_a = KSL_RN_LANES(v_y_1 * v_y_1), v_n_b = KSL_RN_LANES(v_y_2 * v_y_2), v_n_c =
      v_n_a + v_n_b,
      v_n_d = KSL_RN_LANES(v_y_3 * v_y_3), v_n_e = v_n_c + v_n_d, v_n = ksl_sqrt_lanes(v_n_e);
  const ksl_tests v_r_a = ksl_less_lanes(ksl_each_lanes(1.0), v_s);
  const ksl_states v_r_b = ksl_choice_lanes(v_r_a, ksl_each_lanes(7.637340908749012e-152),
      ksl_each_lanes(1.0));
  const ksl_tests v_r_c = ksl_less_lanes(ksl_each_lanes(1.3093562431584567e+151), v_s);
  const ksl_states v_r = ksl_choice_lanes(v_r_c, ksl_each_lanes(9.332636185032189e-302), v_r_b);
  const ksl_states n = v_n * v_r;
  const ksl_states half = ksl_atan2_lanes(n, ksl_choice_lanes(upper_0b, upper_3a, scaled_s_4));
  const ksl_tests divisor_a = ksl_equal_lanes(v_n, ksl_each_lanes(0.0));
  const ksl_states divisor = ksl_choice_lanes(divisor_a, ksl_each_lanes(1.0), v_n);
  const ksl_states unit_1 = v_y_2 / divisor;
  const ksl_states unit_2 = v_y_3 / divisor;
  const ksl_states angle_ = KSL_RN_LANES(2.0 * half);
  const ksl_states axis_1 = ksl_choice_lanes(divisor_a, ksl_each_lanes(1.0), v_y_1 / divisor);
  angle[0] = angle_;
  axis[0] = axis_1;
  axis[1] = unit_1;
  axis[2] = unit_2;
}

static KSL_INLINE void ksl_quaternion_exp_states(const ksl_states *v, ksl_states *qo) {
  const ksl_states h_1 = KSL_RN_LANES(0.5 * v[0]);
  const ksl_states h_2 = KSL_RN_LANES(0.5 * v[1]);
  const ksl_states h_3 = KSL_RN_LANES(0.5 * v[2]);
  const ksl_states sizes_a = ksl_abs_lanes(h_1) + ksl_abs_lanes(h_2),
      sizes = sizes_a + ksl_abs_lanes(h_3);
  const ksl_states grid = KSL_RN_LANES(sizes * 268435456.0);
  const ksl_states high_1 = h_1 + grid - grid;
  const ksl_states high_2 = h_2 + grid - grid;
  const ksl_states high_3 = h_3 + grid - grid;
  const ksl_states squares_a = KSL_RN_LANES(high_1 * high_1), squares_b = KSL_RN_LANES(high_2 *
      high_2),
      squares_c = squares_a + squares_b, squares_d = KSL_RN_LANES(high_3 * high_3),
      squares = squares_c + squares_d;
  const ksl_states cross_a = KSL_RN_LANES((h_1 - high_1) * (h_1 + high_1)),
      cross_b = KSL_RN_LANES((h_2 - high_2) * (h_2 + high_2)), cross_c = cross_a + cross_b,
      cross_d = KSL_RN_LANES((h_3 - high_3) * (h_3 + high_3)), cross = cross_c + cross_d;
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
  const ksl_states far_k = sine / theta;
  const ksl_states k_a = KSL_RN_LANES(6.446950284384474e-26 * x), k_b = k_a - 3.868170170630684e-23,
      k_c = KSL_RN_LANES(x * k_b), k_d = k_c + 1.9572941063391263e-20, k_e = KSL_RN_LANES(x * k_d),
      k_f = k_e - 8.22063524662433e-18, k_g = KSL_RN_LANES(x * k_f), k_h = k_g +
          2.8114572543455206e-15,
      k_i = KSL_RN_LANES(x * k_h), k_j = k_i - 7.647163731819816e-13, k_k = KSL_RN_LANES(x * k_j),
      k_l = k_k + 1.6059043836821613e-10, k_m = KSL_RN_LANES(x * k_l), k_n = k_m -
          2.505210838544172e-08,
      k_o = KSL_RN_LANES(x * k_n), k_p = k_o + 2.7557319223985893e-06, k_q = KSL_RN_LANES(x * k_p),
      k_r = k_q - 0.0001984126984126984, k_s = KSL_RN_LANES(x * k_r), k_t = k_s +
          0.008333333333333333,
      k_u = KSL_RN_LANES(x * k_t), k_v = k_u - 0.16666666666666666, k_w = KSL_RN_LANES(x * k_v), k_x
          = k_w + 1.0,
      k = ksl_choice_lanes(theta_b, k_x, far_k);
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
      g2u = KSL_RN_LANES(x * g2t), g2v = g2u - 0.041666666666666664, g2w = KSL_RN_LANES(x * g2v), g2
          = g2w + 0.5;
  const ksl_states near_a = KSL_RN_LANES(x * g2), near = 1.0 - near_a;
  const ksl_states qo_1 = KSL_RN_LANES(h_1 * k);
  const ksl_states qo_2 = KSL_RN_LANES(h_2 * k);
  const ksl_states qo_3 = KSL_RN_LANES(h_3 * k);
  const ksl_states qo_4 = ksl_choice_lanes(theta_b, near, cosine);
  qo[0] = qo_1;
  qo[1] = qo_2;
  qo[2] = qo_3;
  qo[3] = qo_4;
}

static KSL_INLINE void ksl_quaternion_log_states(const ksl_states *q, ksl_states *vo) {
  const ksl_states s_size_1 = ksl_abs_lanes(q[0]);
  const ksl_states s_size_2 = ksl_abs_lanes(q[1]);
  const ksl_states s_size_3 = ksl_abs_lanes(q[2]);
  const ksl_states s_size_4 = ksl_abs_lanes(q[3]);
  const ksl_tests s_largest1a = ksl_less_lanes(s_size_1, s_size_2);
  const ksl_states s_largest1 = ksl_choice_lanes(s_largest1a, s_size_2, s_size_1);
  const ksl_tests s_largest2a = ksl_less_lanes(s_largest1, s_size_3);
  const ksl_states s_largest2 = ksl_choice_lanes(s_largest2a, s_size_3, s_largest1);
  const ksl_tests s_largest3a = ksl_less_lanes(s_largest2, s_size_4);
  const ksl_states s_largest3 = ksl_choice_lanes(s_largest3a, s_size_4, s_largest2);
  const ksl_tests s_a = ksl_less_lanes(ksl_each_lanes(6.703903964971299e+153), s_largest3);
  const ksl_states s_b = ksl_choice_lanes(s_a, ksl_each_lanes(3.7291703656001034e-155),
      ksl_each_lanes(1.0));
  const ksl_tests s_c = ksl_less_lanes(s_largest3, ksl_each_lanes(256.0));
  const ksl_states s_d = ksl_choice_lanes(s_c, ksl_each_lanes(1.3093562431584567e+151), s_b);
  const ksl_tests s_e = ksl_less_lanes(s_largest3, ksl_each_lanes(1.955159272639747e-149));
  const ksl_states s = ksl_choice_lanes(s_e, ksl_each_lanes(1.0715086071862673e+301), s_d);
  const ksl_states scaled_s_1 = q[0] * s;
  const ksl_states scaled_s_2 = q[1] * s;
  const ksl_states scaled_s_3 = q[2] * s;
  const ksl_states scaled_s_4 = q[3] * s;
  const ksl_states upper_0a = -scaled_s_1;
  const ksl_tests upper_0b = ksl_less_lanes(scaled_s_4, ksl_each_lanes(0.0));
  const ksl_states upper_1 = ksl_choice_lanes(upper_0b, upper_0a, scaled_s_1);
  const ksl_states upper_1a = -scaled_s_2,
      upper_2 = ksl_choice_lanes(upper_0b, upper_1a, scaled_s_2);
  const ksl_states upper_2a = -scaled_s_3,
      upper_3 = ksl_choice_lanes(upper_0b, upper_2a, scaled_s_3);
  const ksl_states upper_3a = -scaled_s_4;
  const ksl_states v_s_size_1 = ksl_abs_lanes(upper_1);
  const ksl_states v_s_size_2 = ksl_abs_lanes(upper_2);
  const ksl_states v_s_size_3 = ksl_abs_lanes(upper_3);
  const ksl_tests v_s_largest1a = ksl_less_lanes(v_s_size_1, v_s_size_2);
  const ksl_states v_s_largest1 = ksl_choice_lanes(v_s_largest1a, v_s_size_2, v_s_size_1);
  const ksl_tests v_s_largest2a = ksl_less_lanes(v_s_largest1, v_s_size_3);
  const ksl_states v_s_largest2 = ksl_choice_lanes(v_s_largest2a, v_s_size_3, v_s_largest1);
  const ksl_tests v_s_a = ksl_less_lanes(v_s_largest2, ksl_each_lanes(256.0));
  const ksl_states v_s_b = ksl_choice_lanes(v_s_a, ksl_each_lanes(1.3093562431584567e+151),
      ksl_each_lanes(1.0));
  const ksl_tests v_s_c = ksl_less_lanes(v_s_largest2, ksl_each_lanes(1.955159272639747e-149));
  const ksl_states v_s = ksl_choice_lanes(v_s_c, ksl_each_lanes(1.0715086071862673e+301), v_s_b);
  const ksl_states v_y_1 = upper_1 * v_s;
  const ksl_states v_y_2 = upper_2 * v_s;
  const ksl_states v_y_3 = upper_3 * v_s;
  const ksl_states v_n_a = KSL_RN_LANES(v_y_1 * v_y_1), v_n_b = KSL_RN_LANES(v_y_2 * v_y_2), v_n_c =
      v_n_a + v_n_b,
      v_n_d = KSL_RN_LANES(v_y_3 * v_y_3), v_n_e = v_n_c + v_n_d, v_n = ksl_sqrt_lanes(v_n_e);
  const ksl_tests v_r_a = ksl_less_lanes(ksl_each_lanes(1.0), v_s);
  const ksl_states v_r_b = ksl_choice_lanes(v_r_a, ksl_each_lanes(7.637340908749012e-152),
      ksl_each_lanes(1.0));
  const ksl_tests v_r_c = ksl_less_lanes(ksl_each_lanes(1.3093562431584567e+151), v_s);
  const ksl_states v_r = ksl_choice_lanes(v_r_c, ksl_each_lanes(9.332636185032189e-302), v_r_b);
  const ksl_states n = v_n * v_r;
  const ksl_states half = ksl_atan2_lanes(n, ksl_choice_lanes(upper_0b, upper_3a, scaled_s_4));
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

static KSL_INLINE void ksl_quaternion_interpolated_states(const ksl_states *q1,
    const ksl_states *q2, const ksl_states *k, ksl_states *qo) {
  const ksl_states between_0a = KSL_RN_LANES(q1[3] * q2[0]), between_0b = KSL_RN_LANES(q1[0] *
      q2[3]),
      between_0c = between_0a - between_0b, between_0d = KSL_RN_LANES(q1[2] * q2[1]),
      between_0e = KSL_RN_LANES(q1[1] * q2[2]), between_0f = between_0d - between_0e,
      between_1 = between_0c + between_0f;
  const ksl_states between_1a = KSL_RN_LANES(q1[0] * q2[2]), between_1b = KSL_RN_LANES(q1[2] *
      q2[0]),
      between_1c = between_1a - between_1b, between_1d = KSL_RN_LANES(q1[3] * q2[1]),
      between_1e = KSL_RN_LANES(q1[1] * q2[3]), between_1f = between_1d - between_1e,
      between_2 = between_1c + between_1f;
  const ksl_states between_2a = KSL_RN_LANES(q1[1] * q2[0]), between_2b = KSL_RN_LANES(q1[0] *
      q2[1]),
      between_2c = between_2a - between_2b, between_2d = KSL_RN_LANES(q1[3] * q2[2]),
      between_2e = KSL_RN_LANES(q1[2] * q2[3]), between_2f = between_2d - between_2e,
      between_3 = between_2c + between_2f;
  const ksl_states between_3a = KSL_RN_LANES(q1[0] * q2[0]), between_3b = KSL_RN_LANES(q1[1] *
      q2[1]),
      between_3c = between_3a + between_3b, between_3d = KSL_RN_LANES(q1[2] * q2[2]),
      between_3e = between_3c + between_3d, between_3f = KSL_RN_LANES(q1[3] * q2[3]),
      between_4 = between_3e + between_3f;
  const ksl_states upper_0a = -between_1;
  const ksl_tests upper_0b = ksl_less_lanes(between_4, ksl_each_lanes(0.0));
  const ksl_states upper_1 = ksl_choice_lanes(upper_0b, upper_0a, between_1);
  const ksl_states upper_1a = -between_2, upper_2 = ksl_choice_lanes(upper_0b, upper_1a, between_2);
  const ksl_states upper_2a = -between_3, upper_3 = ksl_choice_lanes(upper_0b, upper_2a, between_3);
  const ksl_states upper_3a = -between_4;
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
  const ksl_states half = ksl_atan2_lanes(n, ksl_choice_lanes(upper_0b, upper_3a, between_4));
  const ksl_tests divisor_a = ksl_equal_lanes(n, ksl_each_lanes(0.0));
  const ksl_states divisor = ksl_choice_lanes(divisor_a, ksl_each_lanes(1.0), n);
  const ksl_states rate = half / divisor;
  const ksl_states step_1 = KSL_RN_LANES(rate * (k[0] * upper_1));
  const ksl_states step_2 = KSL_RN_LANES(rate * (k[0] * upper_2));
  const ksl_states step_3 = KSL_RN_LANES(rate * (k[0] * upper_3));
  const ksl_states exp_sizes_a = ksl_abs_lanes(step_1) + ksl_abs_lanes(step_2),
      exp_sizes = exp_sizes_a + ksl_abs_lanes(step_3);
  const ksl_states exp_grid = KSL_RN_LANES(exp_sizes * 268435456.0);
  const ksl_states exp_high_1 = step_1 + exp_grid - exp_grid;
  const ksl_states exp_high_2 = step_2 + exp_grid - exp_grid;
  const ksl_states exp_high_3 = step_3 + exp_grid - exp_grid;
  const ksl_states exp_squares_a = KSL_RN_LANES(exp_high_1 * exp_high_1),
      exp_squares_b = KSL_RN_LANES(exp_high_2 * exp_high_2), exp_squares_c = exp_squares_a +
          exp_squares_b,
      exp_squares_d = KSL_RN_LANES(exp_high_3 * exp_high_3), exp_squares = exp_squares_c +
          exp_squares_d;
  const ksl_states exp_cross_a = KSL_RN_LANES((step_1 - exp_high_1) * (step_1 + exp_high_1)),
      exp_cross_b = KSL_RN_LANES((step_2 - exp_high_2) * (step_2 + exp_high_2)),
      exp_cross_c = exp_cross_a + exp_cross_b,
      exp_cross_d = KSL_RN_LANES((step_3 - exp_high_3) * (step_3 + exp_high_3)),
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
  const ksl_states exp_far_k = exp_sine / exp_theta;
  const ksl_states exp_k_a = KSL_RN_LANES(6.446950284384474e-26 * exp_x),
      exp_k_b = exp_k_a - 3.868170170630684e-23, exp_k_c = KSL_RN_LANES(exp_x * exp_k_b),
      exp_k_d = exp_k_c + 1.9572941063391263e-20, exp_k_e = KSL_RN_LANES(exp_x * exp_k_d),
      exp_k_f = exp_k_e - 8.22063524662433e-18, exp_k_g = KSL_RN_LANES(exp_x * exp_k_f),
      exp_k_h = exp_k_g + 2.8114572543455206e-15, exp_k_i = KSL_RN_LANES(exp_x * exp_k_h),
      exp_k_j = exp_k_i - 7.647163731819816e-13, exp_k_k = KSL_RN_LANES(exp_x * exp_k_j),
      exp_k_l = exp_k_k + 1.6059043836821613e-10, exp_k_m = KSL_RN_LANES(exp_x * exp_k_l),
      exp_k_n = exp_k_m - 2.505210838544172e-08, exp_k_o = KSL_RN_LANES(exp_x * exp_k_n),
      exp_k_p = exp_k_o + 2.7557319223985893e-06, exp_k_q = KSL_RN_LANES(exp_x * exp_k_p),
      exp_k_r = exp_k_q - 0.0001984126984126984, exp_k_s = KSL_RN_LANES(exp_x * exp_k_r),
      exp_k_t = exp_k_s + 0.008333333333333333, exp_k_u = KSL_RN_LANES(exp_x * exp_k_t),
      exp_k_v = exp_k_u - 0.16666666666666666, exp_k_w = KSL_RN_LANES(exp_x * exp_k_v),
      exp_k_x = exp_k_w + 1.0, exp_k = ksl_choice_lanes(exp_theta_b, exp_k_x, exp_far_k);
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
      exp_g2 = exp_g2w + 0.5;
  const ksl_states exp_near_a = KSL_RN_LANES(exp_x * exp_g2), exp_near = 1.0 - exp_near_a;
  const ksl_states power_1 = step_1 * exp_k;
  const ksl_states power_2 = step_2 * exp_k;
  const ksl_states power_3 = step_3 * exp_k;
  const ksl_states power_4 = ksl_choice_lanes(exp_theta_b, exp_near, exp_cosine);
  const ksl_states qo_0a = KSL_RN_LANES(q1[0] * power_4), qo_0b = KSL_RN_LANES(q1[1] * power_3),
      qo_0c = KSL_RN_LANES(q1[2] * power_2), qo_0d = qo_0b - qo_0c, qo_0e = qo_0a + qo_0d,
      qo_0f = KSL_RN_LANES(q1[3] * power_1), qo_1 = qo_0e + qo_0f;
  const ksl_states qo_1a = KSL_RN_LANES(q1[2] * power_1), qo_1b = KSL_RN_LANES(q1[0] * power_3),
      qo_1c = qo_1a - qo_1b,
      qo_1d = KSL_RN_LANES(q1[1] * power_4), qo_1e = qo_1c + qo_1d, qo_1f = KSL_RN_LANES(q1[3] *
          power_2),
      qo_2 = qo_1e + qo_1f;
  const ksl_states qo_2a = KSL_RN_LANES(q1[0] * power_2), qo_2b = KSL_RN_LANES(q1[1] * power_1),
      qo_2c = qo_2a - qo_2b,
      qo_2d = KSL_RN_LANES(q1[2] * power_4), qo_2e = qo_2c + qo_2d, qo_2f = KSL_RN_LANES(q1[3] *
          power_3),
      qo_3 = qo_2e + qo_2f;
  const ksl_states qo_3a = KSL_RN_LANES(q1[3] * power_4), qo_3b = KSL_RN_LANES(q1[0] * power_1),
      qo_3c = KSL_RN_LANES(q1[1] * power_2), qo_3d = qo_3b + qo_3c, qo_3e = KSL_RN_LANES(q1[2] *
          power_3),
      qo_3f = qo_3d + qo_3e, qo_4 = qo_3a - qo_3f;
  qo[0] = qo_1;
  qo[1] = qo_2;
  qo[2] = qo_3;
  qo[3] = qo_4;
}

static KSL_INLINE void ksl_quaternionf_from_axis_angle_states(const ksl_statesf *axis,
    const ksl_statesf *angle, ksl_statesf *qo) {
  const ksl_statesf half = 0.5f * angle[0];
  ksl_statesf qo_4; const ksl_statesf sine = ksl_sincos_lanesf(half, &qo_4);
  const ksl_statesf qo_1 = KSL_RN_LANESF(axis[0] * sine);
  const ksl_statesf qo_2 = KSL_RN_LANESF(axis[1] * sine);
  const ksl_statesf qo_3 = KSL_RN_LANESF(axis[2] * sine);
  qo[0] = qo_1;
  qo[1] = qo_2;
  qo[2] = qo_3;
  qo[3] = qo_4;
}

static KSL_INLINE void ksl_axis_angle_from_quaternionf_states(const ksl_statesf *q,
    ksl_statesf *angle, ksl_statesf *axis) {
  const ksl_statesf s_size_1 = ksl_abs_lanesf(q[0]);
  const ksl_statesf s_size_2 = ksl_abs_lanesf(q[1]);
  const ksl_statesf s_size_3 = ksl_abs_lanesf(q[2]);
  const ksl_statesf s_size_4 = ksl_abs_lanesf(q[3]);
  const ksl_testsf s_largest1a = ksl_less_lanesf(s_size_1, s_size_2);
  const ksl_statesf s_largest1 = ksl_choice_lanesf(s_largest1a, s_size_2, s_size_1);
  const ksl_testsf s_largest2a = ksl_less_lanesf(s_largest1, s_size_3);
  const ksl_statesf s_largest2 = ksl_choice_lanesf(s_largest2a, s_size_3, s_largest1);
  const ksl_testsf s_largest3a = ksl_less_lanesf(s_largest2, s_size_4);
  const ksl_statesf s_largest3 = ksl_choice_lanesf(s_largest3a, s_size_4, s_largest2);
  const ksl_testsf s_a = ksl_less_lanesf(ksl_each_lanesf(4.611686e+18f), s_largest3);
  const ksl_statesf s_b = ksl_choice_lanesf(s_a, ksl_each_lanesf(2.7105054e-20f),
      ksl_each_lanesf(1.0f));
  const ksl_testsf s_c = ksl_less_lanesf(s_largest3, ksl_each_lanesf(256.0f));
  const ksl_statesf s_d = ksl_choice_lanesf(s_c, ksl_each_lanesf(1.8014399e+16f), s_b);
  const ksl_testsf s_e = ksl_less_lanesf(s_largest3, ksl_each_lanesf(1.4210855e-14f));
  const ksl_statesf s = ksl_choice_lanesf(s_e, ksl_each_lanesf(3.2451855e+32f), s_d);
  const ksl_statesf scaled_s_1 = q[0] * s;
  const ksl_statesf scaled_s_2 = q[1] * s;
  const ksl_statesf scaled_s_3 = q[2] * s;
  const ksl_statesf scaled_s_4 = q[3] * s;
  const ksl_statesf upper_0a = -scaled_s_1;
  const ksl_testsf upper_0b = ksl_less_lanesf(scaled_s_4, ksl_each_lanesf(0.0f));
  const ksl_statesf upper_1 = ksl_choice_lanesf(upper_0b, upper_0a, scaled_s_1);
  const ksl_statesf upper_1a = -scaled_s_2,
      upper_2 = ksl_choice_lanesf(upper_0b, upper_1a, scaled_s_2);
  const ksl_statesf upper_2a = -scaled_s_3,
      upper_3 = ksl_choice_lanesf(upper_0b, upper_2a, scaled_s_3);
  const ksl_statesf upper_3a = -scaled_s_4;
  const ksl_statesf v_s_size_1 = ksl_abs_lanesf(upper_1);
  const ksl_statesf v_s_size_2 = ksl_abs_lanesf(upper_2);
  const ksl_statesf v_s_size_3 = ksl_abs_lanesf(upper_3);
  const ksl_testsf v_s_largest1a = ksl_less_lanesf(v_s_size_1, v_s_size_2);
  const ksl_statesf v_s_largest1 = ksl_choice_lanesf(v_s_largest1a, v_s_size_2, v_s_size_1);
  const ksl_testsf v_s_largest2a = ksl_less_lanesf(v_s_largest1, v_s_size_3);
  const ksl_statesf v_s_largest2 = ksl_choice_lanesf(v_s_largest2a, v_s_size_3, v_s_largest1);
  const ksl_testsf v_s_a = ksl_less_lanesf(v_s_largest2, ksl_each_lanesf(256.0f));
  const ksl_statesf v_s_b = ksl_choice_lanesf(v_s_a, ksl_each_lanesf(1.8014399e+16f),
      ksl_each_lanesf(1.0f));
  const ksl_testsf v_s_c = ksl_less_lanesf(v_s_largest2, ksl_each_lanesf(1.4210855e-14f));
  const ksl_statesf v_s = ksl_choice_lanesf(v_s_c, ksl_each_lanesf(3.2451855e+32f), v_s_b);
  const ksl_statesf v_y_1 = upper_1 * v_s;
  const ksl_statesf v_y_2 = upper_2 * v_s;
  const ksl_statesf v_y_3 = upper_3 * v_s;
  const ksl_statesf v_n_a = KSL_RN_LANESF(v_y_1 * v_y_1), v_n_b = KSL_RN_LANESF(v_y_2 * v_y_2),
      v_n_c = v_n_a + v_n_b,
      v_n_d = KSL_RN_LANESF(v_y_3 * v_y_3), v_n_e = v_n_c + v_n_d, v_n = ksl_sqrt_lanesf(v_n_e);
  const ksl_testsf v_r_a = ksl_less_lanesf(ksl_each_lanesf(1.0f), v_s);
  const ksl_statesf v_r_b = ksl_choice_lanesf(v_r_a, ksl_each_lanesf(5.551115e-17f),
      ksl_each_lanesf(1.0f));
  const ksl_testsf v_r_c = ksl_less_lanesf(ksl_each_lanesf(1.8014399e+16f), v_s);
  const ksl_statesf v_r = ksl_choice_lanesf(v_r_c, ksl_each_lanesf(3.081488e-33f), v_r_b);
  const ksl_statesf n = v_n * v_r;
  const ksl_statesf half = ksl_atan2_lanesf(n, ksl_choice_lanesf(upper_0b, upper_3a, scaled_s_4));
  const ksl_testsf divisor_a = ksl_equal_lanesf(v_n, ksl_each_lanesf(0.0f));
  const ksl_statesf divisor = ksl_choice_lanesf(divisor_a, ksl_each_lanesf(1.0f), v_n);
  const ksl_statesf unit_1 = v_y_2 / divisor;
  const ksl_statesf unit_2 = v_y_3 / divisor;
  const ksl_statesf angle_ = KSL_RN_LANESF(2.0f * half);
  const ksl_statesf axis_1 = ksl_choice_lanesf(divisor_a, ksl_each_lanesf(1.0f), v_y_1 / divisor);
  angle[0] = angle_;
  axis[0] = axis_1;
  axis[1] = unit_1;
  axis[2] = unit_2;
}

static KSL_INLINE void ksl_quaternionf_exp_states(const ksl_statesf *v, ksl_statesf *qo) {
  const ksl_statesf h_1 = KSL_RN_LANESF(0.5f * v[0]);
  const ksl_statesf h_2 = KSL_RN_LANESF(0.5f * v[1]);
  const ksl_statesf h_3 = KSL_RN_LANESF(0.5f * v[2]);
  const ksl_statesf sizes_a = ksl_abs_lanesf(h_1) + ksl_abs_lanesf(h_2),
      sizes = sizes_a + ksl_abs_lanesf(h_3);
  const ksl_statesf grid = KSL_RN_LANESF(sizes * 8192.0f);
  const ksl_statesf high_1 = h_1 + grid - grid;
  const ksl_statesf high_2 = h_2 + grid - grid;
  const ksl_statesf high_3 = h_3 + grid - grid;
  const ksl_statesf squares_a = KSL_RN_LANESF(high_1 * high_1), squares_b = KSL_RN_LANESF(high_2 *
      high_2),
      squares_c = squares_a + squares_b, squares_d = KSL_RN_LANESF(high_3 * high_3),
      squares = squares_c + squares_d;
  const ksl_statesf cross_a = KSL_RN_LANESF((h_1 - high_1) * (h_1 + high_1)),
      cross_b = KSL_RN_LANESF((h_2 - high_2) * (h_2 + high_2)), cross_c = cross_a + cross_b,
      cross_d = KSL_RN_LANESF((h_3 - high_3) * (h_3 + high_3)), cross = cross_c + cross_d;
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
  const ksl_statesf far_k = sine / theta;
  const ksl_statesf k_a = KSL_RN_LANESF(6.4469503e-26f * x), k_b = k_a - 3.8681703e-23f, k_c =
      KSL_RN_LANESF(x * k_b),
      k_d = k_c + 1.9572942e-20f, k_e = KSL_RN_LANESF(x * k_d), k_f = k_e - 8.220635e-18f, k_g =
          KSL_RN_LANESF(x * k_f),
      k_h = k_g + 2.8114574e-15f, k_i = KSL_RN_LANESF(x * k_h), k_j = k_i - 7.6471636e-13f, k_k =
          KSL_RN_LANESF(x * k_j),
      k_l = k_k + 1.6059044e-10f, k_m = KSL_RN_LANESF(x * k_l), k_n = k_m - 2.5052108e-08f, k_o =
          KSL_RN_LANESF(x * k_n),
      k_p = k_o + 2.7557319e-06f, k_q = KSL_RN_LANESF(x * k_p), k_r = k_q - 0.0001984127f, k_s =
          KSL_RN_LANESF(x * k_r),
      k_t = k_s + 0.008333334f, k_u = KSL_RN_LANESF(x * k_t), k_v = k_u - 0.16666667f, k_w =
          KSL_RN_LANESF(x * k_v),
      k_x = k_w + 1.0f, k = ksl_choice_lanesf(theta_b, k_x, far_k);
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
      g2 = g2w + 0.5f;
  const ksl_statesf near_a = KSL_RN_LANESF(x * g2), near = 1.0f - near_a;
  const ksl_statesf qo_1 = KSL_RN_LANESF(h_1 * k);
  const ksl_statesf qo_2 = KSL_RN_LANESF(h_2 * k);
  const ksl_statesf qo_3 = KSL_RN_LANESF(h_3 * k);
  const ksl_statesf qo_4 = ksl_choice_lanesf(theta_b, near, cosine);
  qo[0] = qo_1;
  qo[1] = qo_2;
  qo[2] = qo_3;
  qo[3] = qo_4;
}

static KSL_INLINE void ksl_quaternionf_log_states(const ksl_statesf *q, ksl_statesf *vo) {
  const ksl_statesf s_size_1 = ksl_abs_lanesf(q[0]);
  const ksl_statesf s_size_2 = ksl_abs_lanesf(q[1]);
  const ksl_statesf s_size_3 = ksl_abs_lanesf(q[2]);
  const ksl_statesf s_size_4 = ksl_abs_lanesf(q[3]);
  const ksl_testsf s_largest1a = ksl_less_lanesf(s_size_1, s_size_2);
  const ksl_statesf s_largest1 = ksl_choice_lanesf(s_largest1a, s_size_2, s_size_1);
  const ksl_testsf s_largest2a = ksl_less_lanesf(s_largest1, s_size_3);
  const ksl_statesf s_largest2 = ksl_choice_lanesf(s_largest2a, s_size_3, s_largest1);
  const ksl_testsf s_largest3a = ksl_less_lanesf(s_largest2, s_size_4);
  const ksl_statesf s_largest3 = ksl_choice_lanesf(s_largest3a, s_size_4, s_largest2);
  const ksl_testsf s_a = ksl_less_lanesf(ksl_each_lanesf(4.611686e+18f), s_largest3);
  const ksl_statesf s_b = ksl_choice_lanesf(s_a, ksl_each_lanesf(2.7105054e-20f),
      ksl_each_lanesf(1.0f));
  const ksl_testsf s_c = ksl_less_lanesf(s_largest3, ksl_each_lanesf(256.0f));
  const ksl_statesf s_d = ksl_choice_lanesf(s_c, ksl_each_lanesf(1.8014399e+16f), s_b);
  const ksl_testsf s_e = ksl_less_lanesf(s_largest3, ksl_each_lanesf(1.4210855e-14f));
  const ksl_statesf s = ksl_choice_lanesf(s_e, ksl_each_lanesf(3.2451855e+32f), s_d);
  const ksl_statesf scaled_s_1 = q[0] * s;
  const ksl_statesf scaled_s_2 = q[1] * s;
  const ksl_statesf scaled_s_3 = q[2] * s;
  const ksl_statesf scaled_s_4 = q[3] * s;
  const ksl_statesf upper_0a = -scaled_s_1;
  const ksl_testsf upper_0b = ksl_less_lanesf(scaled_s_4, ksl_each_lanesf(0.0f));
  const ksl_statesf upper_1 = ksl_choice_lanesf(upper_0b, upper_0a, scaled_s_1);
  const ksl_statesf upper_1a = -scaled_s_2,
      upper_2 = ksl_choice_lanesf(upper_0b, upper_1a, scaled_s_2);
  const ksl_statesf upper_2a = -scaled_s_3,
      upper_3 = ksl_choice_lanesf(upper_0b, upper_2a, scaled_s_3);
  const ksl_statesf upper_3a = -scaled_s_4;
  const ksl_statesf v_s_size_1 = ksl_abs_lanesf(upper_1);
  const ksl_statesf v_s_size_2 = ksl_abs_lanesf(upper_2);
  const ksl_statesf v_s_size_3 = ksl_abs_lanesf(upper_3);
  const ksl_testsf v_s_largest1a = ksl_less_lanesf(v_s_size_1, v_s_size_2);
  const ksl_statesf v_s_largest1 = ksl_choice_lanesf(v_s_largest1a, v_s_size_2, v_s_size_1);
  const ksl_testsf v_s_largest2a = ksl_less_lanesf(v_s_largest1, v_s_size_3);
  const ksl_statesf v_s_largest2 = ksl_choice_lanesf(v_s_largest2a, v_s_size_3, v_s_largest1);
  const ksl_testsf v_s_a = ksl_less_lanesf(v_s_largest2, ksl_each_lanesf(256.0f));
  const ksl_statesf v_s_b = ksl_choice_lanesf(v_s_a, ksl_each_lanesf(1.8014399e+16f),
      ksl_each_lanesf(1.0f));
  const ksl_testsf v_s_c = ksl_less_lanesf(v_s_largest2, ksl_each_lanesf(1.4210855e-14f));
  const ksl_statesf v_s = ksl_choice_lanesf(v_s_c, ksl_each_lanesf(3.2451855e+32f), v_s_b);
  const ksl_statesf v_y_1 = upper_1 * v_s;
  const ksl_statesf v_y_2 = upper_2 * v_s;
  const ksl_statesf v_y_3 = upper_3 * v_s;
  const ksl_statesf v_n_a = KSL_RN_LANESF(v_y_1 * v_y_1), v_n_b = KSL_RN_LANESF(v_y_2 * v_y_2),
      v_n_c = v_n_a + v_n_b,
      v_n_d = KSL_RN_LANESF(v_y_3 * v_y_3), v_n_e = v_n_c + v_n_d, v_n = ksl_sqrt_lanesf(v_n_e);
  const ksl_testsf v_r_a = ksl_less_lanesf(ksl_each_lanesf(1.0f), v_s);
  const ksl_statesf v_r_b = ksl_choice_lanesf(v_r_a, ksl_each_lanesf(5.551115e-17f),
      ksl_each_lanesf(1.0f));
  const ksl_testsf v_r_c = ksl_less_lanesf(ksl_each_lanesf(1.8014399e+16f), v_s);
  const ksl_statesf v_r = ksl_choice_lanesf(v_r_c, ksl_each_lanesf(3.081488e-33f), v_r_b);
  const ksl_statesf n = v_n * v_r;
  const ksl_statesf half = ksl_atan2_lanesf(n, ksl_choice_lanesf(upper_0b, upper_3a, scaled_s_4));
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

static KSL_INLINE void ksl_quaternionf_interpolated_states(const ksl_statesf *q1,
    const ksl_statesf *q2, const ksl_statesf *k, ksl_statesf *qo) {
  const ksl_statesf between_0a = KSL_RN_LANESF(q1[3] * q2[0]), between_0b = KSL_RN_LANESF(q1[0] *
      q2[3]),
      between_0c = between_0a - between_0b, between_0d = KSL_RN_LANESF(q1[2] * q2[1]),
      between_0e = KSL_RN_LANESF(q1[1] * q2[2]), between_0f = between_0d - between_0e,
      between_1 = between_0c + between_0f;
  const ksl_statesf between_1a = KSL_RN_LANESF(q1[0] * q2[2]), between_1b = KSL_RN_LANESF(q1[2] *
      q2[0]),
      between_1c = between_1a - between_1b, between_1d = KSL_RN_LANESF(q1[3] * q2[1]),
      between_1e = KSL_RN_LANESF(q1[1] * q2[3]), between_1f = between_1d - between_1e,
      between_2 = between_1c + between_1f;
  const ksl_statesf between_2a = KSL_RN_LANESF(q1[1] * q2[0]), between_2b = KSL_RN_LANESF(q1[0] *
      q2[1]),
      between_2c = between_2a - between_2b, between_2d = KSL_RN_LANESF(q1[3] * q2[2]),
      between_2e = KSL_RN_LANESF(q1[2] * q2[3]), between_2f = between_2d - between_2e,
      between_3 = between_2c + between_2f;
  const ksl_statesf between_3a = KSL_RN_LANESF(q1[0] * q2[0]), between_3b = KSL_RN_LANESF(q1[1] *
      q2[1]),
      between_3c = between_3a + between_3b, between_3d = KSL_RN_LANESF(q1[2] * q2[2]),
      between_3e = between_3c + between_3d, between_3f = KSL_RN_LANESF(q1[3] * q2[3]),
      between_4 = between_3e + between_3f;
  const ksl_statesf upper_0a = -between_1;
  const ksl_testsf upper_0b = ksl_less_lanesf(between_4, ksl_each_lanesf(0.0f));
  const ksl_statesf upper_1 = ksl_choice_lanesf(upper_0b, upper_0a, between_1);
  const ksl_statesf upper_1a = -between_2,
      upper_2 = ksl_choice_lanesf(upper_0b, upper_1a, between_2);
  const ksl_statesf upper_2a = -between_3,
      upper_3 = ksl_choice_lanesf(upper_0b, upper_2a, between_3);
  const ksl_statesf upper_3a = -between_4;
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
  const ksl_statesf half = ksl_atan2_lanesf(n, ksl_choice_lanesf(upper_0b, upper_3a, between_4));
  const ksl_testsf divisor_a = ksl_equal_lanesf(n, ksl_each_lanesf(0.0f));
  const ksl_statesf divisor = ksl_choice_lanesf(divisor_a, ksl_each_lanesf(1.0f), n);
  const ksl_statesf rate = half / divisor;
  const ksl_statesf step_1 = KSL_RN_LANESF(rate * (k[0] * upper_1));
  const ksl_statesf step_2 = KSL_RN_LANESF(rate * (k[0] * upper_2));
  const ksl_statesf step_3 = KSL_RN_LANESF(rate * (k[0] * upper_3));
  const ksl_statesf exp_sizes_a = ksl_abs_lanesf(step_1) + ksl_abs_lanesf(step_2),
      exp_sizes = exp_sizes_a + ksl_abs_lanesf(step_3);
  const ksl_statesf exp_grid = KSL_RN_LANESF(exp_sizes * 8192.0f);
  const ksl_statesf exp_high_1 = step_1 + exp_grid - exp_grid;
  const ksl_statesf exp_high_2 = step_2 + exp_grid - exp_grid;
  const ksl_statesf exp_high_3 = step_3 + exp_grid - exp_grid;
  const ksl_statesf exp_squares_a = KSL_RN_LANESF(exp_high_1 * exp_high_1),
      exp_squares_b = KSL_RN_LANESF(exp_high_2 * exp_high_2), exp_squares_c = exp_squares_a +
          exp_squares_b,
      exp_squares_d = KSL_RN_LANESF(exp_high_3 * exp_high_3), exp_squares = exp_squares_c +
          exp_squares_d;
  const ksl_statesf exp_cross_a = KSL_RN_LANESF((step_1 - exp_high_1) * (step_1 + exp_high_1)),
      exp_cross_b = KSL_RN_LANESF((step_2 - exp_high_2) * (step_2 + exp_high_2)),
      exp_cross_c = exp_cross_a + exp_cross_b,
      exp_cross_d = KSL_RN_LANESF((step_3 - exp_high_3) * (step_3 + exp_high_3)),
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
  const ksl_statesf exp_far_k = exp_sine / exp_theta;
  const ksl_statesf exp_k_a = KSL_RN_LANESF(6.4469503e-26f * exp_x), exp_k_b = exp_k_a -
      3.8681703e-23f,
      exp_k_c = KSL_RN_LANESF(exp_x * exp_k_b), exp_k_d = exp_k_c + 1.9572942e-20f,
      exp_k_e = KSL_RN_LANESF(exp_x * exp_k_d), exp_k_f = exp_k_e - 8.220635e-18f,
      exp_k_g = KSL_RN_LANESF(exp_x * exp_k_f), exp_k_h = exp_k_g + 2.8114574e-15f,
      exp_k_i = KSL_RN_LANESF(exp_x * exp_k_h), exp_k_j = exp_k_i - 7.6471636e-13f,
      exp_k_k = KSL_RN_LANESF(exp_x * exp_k_j), exp_k_l = exp_k_k + 1.6059044e-10f,
      exp_k_m = KSL_RN_LANESF(exp_x * exp_k_l), exp_k_n = exp_k_m - 2.5052108e-08f,
      exp_k_o = KSL_RN_LANESF(exp_x * exp_k_n), exp_k_p = exp_k_o + 2.7557319e-06f,
      exp_k_q = KSL_RN_LANESF(exp_x * exp_k_p), exp_k_r = exp_k_q - 0.0001984127f,
      exp_k_s = KSL_RN_LANESF(exp_x * exp_k_r), exp_k_t = exp_k_s + 0.008333334f,
      exp_k_u = KSL_RN_LANESF(exp_x * exp_k_t), exp_k_v = exp_k_u - 0.16666667f, exp_k_w =
          KSL_RN_LANESF(exp_x * exp_k_v),
      exp_k_x = exp_k_w + 1.0f, exp_k = ksl_choice_lanesf(exp_theta_b, exp_k_x, exp_far_k);
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
      exp_g2w = KSL_RN_LANESF(exp_x * exp_g2v), exp_g2 = exp_g2w + 0.5f;
  const ksl_statesf exp_near_a = KSL_RN_LANESF(exp_x * exp_g2), exp_near = 1.0f - exp_near_a;
  const ksl_statesf power_1 = step_1 * exp_k;
  const ksl_statesf power_2 = step_2 * exp_k;
  const ksl_statesf power_3 = step_3 * exp_k;
  const ksl_statesf power_4 = ksl_choice_lanesf(exp_theta_b, exp_near, exp_cosine);
  const ksl_statesf qo_0a = KSL_RN_LANESF(q1[0] * power_4), qo_0b = KSL_RN_LANESF(q1[1] * power_3),
      qo_0c = KSL_RN_LANESF(q1[2] * power_2), qo_0d = qo_0b - qo_0c, qo_0e = qo_0a + qo_0d,
      qo_0f = KSL_RN_LANESF(q1[3] * power_1), qo_1 = qo_0e + qo_0f;
  const ksl_statesf qo_1a = KSL_RN_LANESF(q1[2] * power_1), qo_1b = KSL_RN_LANESF(q1[0] * power_3),
      qo_1c = qo_1a - qo_1b,
      qo_1d = KSL_RN_LANESF(q1[1] * power_4), qo_1e = qo_1c + qo_1d, qo_1f = KSL_RN_LANESF(q1[3] *
          power_2),
      qo_2 = qo_1e + qo_1f;
  const ksl_statesf qo_2a = KSL_RN_LANESF(q1[0] * power_2), qo_2b = KSL_RN_LANESF(q1[1] * power_1),
      qo_2c = qo_2a - qo_2b,
      qo_2d = KSL_RN_LANESF(q1[2] * power_4), qo_2e = qo_2c + qo_2d, qo_2f = KSL_RN_LANESF(q1[3] *
          power_3),
      qo_3 = qo_2e + qo_2f;
  const ksl_statesf qo_3a = KSL_RN_LANESF(q1[3] * power_4), qo_3b = KSL_RN_LANESF(q1[0] * power_1),
      qo_3c = KSL_RN_LANESF(q1[1] * power_2), qo_3d = qo_3b + qo_3c, qo_3e = KSL_RN_LANESF(q1[2] *
          power_3),
      qo_3f = qo_3d + qo_3e, qo_4 = qo_3a - qo_3f;
  qo[0] = qo_1;
  qo[1] = qo_2;
  qo[2] = qo_3;
  qo[3] = qo_4;
}

#endif
#endif
