/* Made by `coscrew generate`; changes are overwritten. */
/* SPDX-License-Identifier: MIT */
/* coscrew 0.2.0.  Copyright (c) 2026 The coscrew authors. */
/* 3×3 matrices: rotations, and matrices in general.  On vectors.
   An argument is its components, in the order of structs, each a vector with that of several
   elements: KSL_LANES of them, in single precision KSL_LANESF. */
#ifndef KSL_MAT3X3_STATES_H
#define KSL_MAT3X3_STATES_H

#include "ksl_states.h"

#if KSL_LANE_BYTES
static KSL_INLINE void ksl_mat3x3_from_euler_xyz_states(const ksl_states *angles, ksl_states *R) {
  ksl_states c_1; const ksl_states s_1 = ksl_sincos_lanes(angles[0], &c_1);
  ksl_states c_2; const ksl_states s_2 = ksl_sincos_lanes(angles[1], &c_2);
  ksl_states c_3; const ksl_states s_3 = ksl_sincos_lanes(angles[2], &c_3);
  const ksl_states first_1 = KSL_RN_LANES(c_2 * c_3);
  const ksl_states first_1a = KSL_RN_LANES(s_3 * c_2), first_2 = -first_1a;
  const ksl_states first_6a = s_2 * c_3, first_3 = -first_6a;
  const ksl_states first_4 = s_2 * s_3;
  const ksl_states last_3a = KSL_RN_LANES(s_3 * c_1), last_3b = KSL_RN_LANES(s_1 * first_3), last_1
      = last_3a - last_3b;
  const ksl_states last_4a = KSL_RN_LANES(c_1 * c_3), last_4b = KSL_RN_LANES(s_1 * first_4), last_2
      = last_4a - last_4b;
  const ksl_states last_5a = KSL_RN_LANES(s_1 * c_2), last_3 = -last_5a;
  const ksl_states last_6a = KSL_RN_LANES(s_1 * s_3), last_6b = KSL_RN_LANES(c_1 * first_3), last_4
      = last_6a + last_6b;
  const ksl_states last_7a = KSL_RN_LANES(s_1 * c_3), last_7b = KSL_RN_LANES(c_1 * first_4), last_5
      = last_7a + last_7b;
  const ksl_states last_6 = KSL_RN_LANES(c_1 * c_2);
  R[0] = first_1;
  R[3] = first_2;
  R[6] = s_2;
  R[1] = last_1;
  R[4] = last_2;
  R[7] = last_3;
  R[2] = last_4;
  R[5] = last_5;
  R[8] = last_6;
}

static KSL_INLINE void ksl_euler_xyz_from_mat3x3_states(const ksl_states *R, ksl_states *angles) {
  const ksl_states n_a = KSL_RN_LANES(R[0] * R[0]), n_b = KSL_RN_LANES(R[3] * R[3]), n_c = n_a +
      n_b,
      n = ksl_sqrt_lanes(n_c);
  const ksl_tests divisor_a = ksl_equal_lanes(n, ksl_each_lanes(0.0));
  const ksl_states divisor = ksl_choice_lanes(divisor_a, ksl_each_lanes(1.0), n);
  const ksl_states cosine_a = R[0] / divisor,
      cosine = ksl_choice_lanes(divisor_a, ksl_each_lanes(1.0), cosine_a);
  const ksl_states sine_a = -R[3], sine = sine_a / divisor;
  const ksl_states polar = ksl_atan2_lanes(sine_a, R[0]);
  const ksl_states third = ksl_choice_lanes(divisor_a, ksl_each_lanes(0.0), polar);
  const ksl_states left_1a = KSL_RN_LANES(R[1] * sine), left_1b = KSL_RN_LANES(R[4] * cosine);
  const ksl_states left_2a = KSL_RN_LANES(R[2] * sine), left_2b = KSL_RN_LANES(R[5] * cosine);
  const ksl_states rest = R[7] + R[8];
  const ksl_states first = ksl_atan2_lanes(left_2a + left_2b, left_1a + left_1b);
  const ksl_tests angles_0a = ksl_less_lanes(rest, ksl_each_lanes(1.2676506002282294e+30));
  const ksl_states angles_1 = ksl_choice_lanes(angles_0a, first, rest);
  const ksl_states angles_2 = ksl_atan2_lanes(R[6], n);
  angles[0] = angles_1;
  angles[1] = angles_2;
  angles[2] = third;
}

static KSL_INLINE void ksl_mat3x3_from_euler_xyx_states(const ksl_states *angles, ksl_states *R) {
  ksl_states c_1; const ksl_states s_1 = ksl_sincos_lanes(angles[0], &c_1);
  ksl_states c_2; const ksl_states s_2 = ksl_sincos_lanes(angles[1], &c_2);
  ksl_states c_3; const ksl_states s_3 = ksl_sincos_lanes(angles[2], &c_3);
  const ksl_states first_1 = KSL_RN_LANES(s_2 * s_3);
  const ksl_states first_2 = KSL_RN_LANES(s_2 * c_3);
  const ksl_states first_3 = s_3 * c_2;
  const ksl_states first_4 = c_2 * c_3;
  const ksl_states last_1 = KSL_RN_LANES(s_1 * s_2);
  const ksl_states last_4a = KSL_RN_LANES(c_1 * c_3), last_4b = KSL_RN_LANES(s_1 * first_3), last_2
      = last_4a - last_4b;
  const ksl_states last_5a = KSL_RN_LANES(s_1 * first_4), last_5b = KSL_RN_LANES(s_3 * c_1),
      last_5c = last_5a + last_5b, last_3 = -last_5c;
  const ksl_states last_6a = KSL_RN_LANES(s_2 * c_1), last_4 = -last_6a;
  const ksl_states last_7a = KSL_RN_LANES(s_1 * c_3), last_7b = KSL_RN_LANES(c_1 * first_3), last_5
      = last_7a + last_7b;
  const ksl_states last_8a = KSL_RN_LANES(c_1 * first_4), last_8b = KSL_RN_LANES(s_1 * s_3), last_6
      = last_8a - last_8b;
  R[0] = c_2;
  R[3] = first_1;
  R[6] = first_2;
  R[1] = last_1;
  R[4] = last_2;
  R[7] = last_3;
  R[2] = last_4;
  R[5] = last_5;
  R[8] = last_6;
}

static KSL_INLINE void ksl_euler_xyx_from_mat3x3_states(const ksl_states *R, ksl_states *angles) {
  const ksl_states n_a = KSL_RN_LANES(R[3] * R[3]), n_b = KSL_RN_LANES(R[6] * R[6]), n_c = n_a +
      n_b,
      n = ksl_sqrt_lanes(n_c);
  const ksl_tests divisor_a = ksl_equal_lanes(n, ksl_each_lanes(0.0));
  const ksl_states divisor = ksl_choice_lanes(divisor_a, ksl_each_lanes(1.0), n);
  const ksl_states cosine_a = R[6] / divisor,
      cosine = ksl_choice_lanes(divisor_a, ksl_each_lanes(1.0), cosine_a);
  const ksl_states sine = R[3] / divisor;
  const ksl_states polar = ksl_atan2_lanes(R[3], R[6]);
  const ksl_states third = ksl_choice_lanes(divisor_a, ksl_each_lanes(0.0), polar);
  const ksl_states left_1a = KSL_RN_LANES(R[4] * cosine), left_1b = KSL_RN_LANES(R[7] * sine);
  const ksl_states left_2a = KSL_RN_LANES(R[5] * cosine), left_2b = KSL_RN_LANES(R[8] * sine);
  const ksl_states rest = R[1] + R[2];
  const ksl_states first = ksl_atan2_lanes(left_2a - left_2b, left_1a - left_1b);
  const ksl_tests angles_0a = ksl_less_lanes(rest, ksl_each_lanes(1.2676506002282294e+30));
  const ksl_states angles_1 = ksl_choice_lanes(angles_0a, first, rest);
  const ksl_states angles_2 = ksl_atan2_lanes(n, R[0]);
  angles[0] = angles_1;
  angles[1] = angles_2;
  angles[2] = third;
}

static KSL_INLINE void ksl_mat3x3_from_axis_angle_states(const ksl_states *axis,
    const ksl_states *angle, ksl_states *R) {
  ksl_states cosine; const ksl_states sine = ksl_sincos_lanes(angle[0], &cosine);
  const ksl_states half = 0.5 * angle[0];
  const ksl_states h = ksl_sin_lanes(half);
  const ksl_states versine_a = KSL_RN_LANES(h * h), versine_b = 2.0 * versine_a, versine_c = 1.0 -
      cosine;
  const ksl_tests versine_d = ksl_less_lanes(cosine, ksl_each_lanes(0.0));
  const ksl_states versine = ksl_choice_lanes(versine_d, versine_c, versine_b);
  const ksl_states beta_v_1 = axis[0] * versine;
  const ksl_states beta_v_2 = axis[1] * versine;
  const ksl_states m_1 = KSL_RN_LANES(axis[0] * beta_v_1);
  const ksl_states m_2 = KSL_RN_LANES(axis[1] * beta_v_2);
  const ksl_states m_3 = KSL_RN_LANES(axis[2] * (axis[2] * versine));
  const ksl_states m_4 = KSL_RN_LANES(axis[1] * beta_v_1);
  const ksl_states m_5 = KSL_RN_LANES(axis[2] * beta_v_1);
  const ksl_states m_6 = KSL_RN_LANES(axis[2] * beta_v_2);
  const ksl_states alpha_v_1 = KSL_RN_LANES(axis[0] * sine);
  const ksl_states alpha_v_2 = KSL_RN_LANES(axis[1] * sine);
  const ksl_states alpha_v_3 = KSL_RN_LANES(axis[2] * sine);
  const ksl_states R_1 = 1.0 - (m_2 + m_3);
  const ksl_states R_2 = m_4 - alpha_v_3;
  const ksl_states R_3 = m_5 + alpha_v_2;
  const ksl_states R_4 = m_4 + alpha_v_3;
  const ksl_states R_5 = 1.0 - (m_1 + m_3);
  const ksl_states R_6 = m_6 - alpha_v_1;
  const ksl_states R_7 = m_5 - alpha_v_2;
  const ksl_states R_8 = m_6 + alpha_v_1;
  const ksl_states R_9 = 1.0 - (m_1 + m_2);
  R[0] = R_1;
  R[3] = R_2;
  R[6] = R_3;
  R[1] = R_4;
  R[4] = R_5;
  R[7] = R_6;
  R[2] = R_7;
  R[5] = R_8;
  R[8] = R_9;
}

static KSL_INLINE void ksl_axis_angle_from_mat3x3_states(const ksl_states *R, ksl_states *angle,
    ksl_states *axis) {
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

static KSL_INLINE void ksl_mat3x3f_from_euler_xyz_states(const ksl_statesf *angles, ksl_statesf *R) {
  ksl_statesf c_1; const ksl_statesf s_1 = ksl_sincos_lanesf(angles[0], &c_1);
  ksl_statesf c_2; const ksl_statesf s_2 = ksl_sincos_lanesf(angles[1], &c_2);
  ksl_statesf c_3; const ksl_statesf s_3 = ksl_sincos_lanesf(angles[2], &c_3);
  const ksl_statesf first_1 = KSL_RN_LANESF(c_2 * c_3);
  const ksl_statesf first_1a = KSL_RN_LANESF(s_3 * c_2), first_2 = -first_1a;
  const ksl_statesf first_6a = s_2 * c_3, first_3 = -first_6a;
  const ksl_statesf first_4 = s_2 * s_3;
  const ksl_statesf last_3a = KSL_RN_LANESF(s_3 * c_1), last_3b = KSL_RN_LANESF(s_1 * first_3),
      last_1 = last_3a - last_3b;
  const ksl_statesf last_4a = KSL_RN_LANESF(c_1 * c_3), last_4b = KSL_RN_LANESF(s_1 * first_4),
      last_2 = last_4a - last_4b;
  const ksl_statesf last_5a = KSL_RN_LANESF(s_1 * c_2), last_3 = -last_5a;
  const ksl_statesf last_6a = KSL_RN_LANESF(s_1 * s_3), last_6b = KSL_RN_LANESF(c_1 * first_3),
      last_4 = last_6a + last_6b;
  const ksl_statesf last_7a = KSL_RN_LANESF(s_1 * c_3), last_7b = KSL_RN_LANESF(c_1 * first_4),
      last_5 = last_7a + last_7b;
  const ksl_statesf last_6 = KSL_RN_LANESF(c_1 * c_2);
  R[0] = first_1;
  R[3] = first_2;
  R[6] = s_2;
  R[1] = last_1;
  R[4] = last_2;
  R[7] = last_3;
  R[2] = last_4;
  R[5] = last_5;
  R[8] = last_6;
}

static KSL_INLINE void ksl_euler_xyz_from_mat3x3f_states(const ksl_statesf *R, ksl_statesf *angles) {
  const ksl_statesf n_a = KSL_RN_LANESF(R[0] * R[0]), n_b = KSL_RN_LANESF(R[3] * R[3]), n_c = n_a +
      n_b,
      n = ksl_sqrt_lanesf(n_c);
  const ksl_testsf divisor_a = ksl_equal_lanesf(n, ksl_each_lanesf(0.0f));
  const ksl_statesf divisor = ksl_choice_lanesf(divisor_a, ksl_each_lanesf(1.0f), n);
  const ksl_statesf cosine_a = R[0] / divisor,
      cosine = ksl_choice_lanesf(divisor_a, ksl_each_lanesf(1.0f), cosine_a);
  const ksl_statesf sine_a = -R[3], sine = sine_a / divisor;
  const ksl_statesf polar = ksl_atan2_lanesf(sine_a, R[0]);
  const ksl_statesf third = ksl_choice_lanesf(divisor_a, ksl_each_lanesf(0.0f), polar);
  const ksl_statesf left_1a = KSL_RN_LANESF(R[1] * sine), left_1b = KSL_RN_LANESF(R[4] * cosine);
  const ksl_statesf left_2a = KSL_RN_LANESF(R[2] * sine), left_2b = KSL_RN_LANESF(R[5] * cosine);
  const ksl_statesf rest = R[7] + R[8];
  const ksl_statesf first = ksl_atan2_lanesf(left_2a + left_2b, left_1a + left_1b);
  const ksl_testsf angles_0a = ksl_less_lanesf(rest, ksl_each_lanesf(1.2676506e+30f));
  const ksl_statesf angles_1 = ksl_choice_lanesf(angles_0a, first, rest);
  const ksl_statesf angles_2 = ksl_atan2_lanesf(R[6], n);
  angles[0] = angles_1;
  angles[1] = angles_2;
  angles[2] = third;
}

static KSL_INLINE void ksl_mat3x3f_from_euler_xyx_states(const ksl_statesf *angles, ksl_statesf *R) {
  ksl_statesf c_1; const ksl_statesf s_1 = ksl_sincos_lanesf(angles[0], &c_1);
  ksl_statesf c_2; const ksl_statesf s_2 = ksl_sincos_lanesf(angles[1], &c_2);
  ksl_statesf c_3; const ksl_statesf s_3 = ksl_sincos_lanesf(angles[2], &c_3);
  const ksl_statesf first_1 = KSL_RN_LANESF(s_2 * s_3);
  const ksl_statesf first_2 = KSL_RN_LANESF(s_2 * c_3);
  const ksl_statesf first_3 = s_3 * c_2;
  const ksl_statesf first_4 = c_2 * c_3;
  const ksl_statesf last_1 = KSL_RN_LANESF(s_1 * s_2);
  const ksl_statesf last_4a = KSL_RN_LANESF(c_1 * c_3), last_4b = KSL_RN_LANESF(s_1 * first_3),
      last_2 = last_4a - last_4b;
  const ksl_statesf last_5a = KSL_RN_LANESF(s_1 * first_4), last_5b = KSL_RN_LANESF(s_3 * c_1),
      last_5c = last_5a + last_5b, last_3 = -last_5c;
  const ksl_statesf last_6a = KSL_RN_LANESF(s_2 * c_1), last_4 = -last_6a;
  const ksl_statesf last_7a = KSL_RN_LANESF(s_1 * c_3), last_7b = KSL_RN_LANESF(c_1 * first_3),
      last_5 = last_7a + last_7b;
  const ksl_statesf last_8a = KSL_RN_LANESF(c_1 * first_4), last_8b = KSL_RN_LANESF(s_1 * s_3),
      last_6 = last_8a - last_8b;
  R[0] = c_2;
  R[3] = first_1;
  R[6] = first_2;
  R[1] = last_1;
  R[4] = last_2;
  R[7] = last_3;
  R[2] = last_4;
  R[5] = last_5;
  R[8] = last_6;
}

static KSL_INLINE void ksl_euler_xyx_from_mat3x3f_states(const ksl_statesf *R, ksl_statesf *angles) {
  const ksl_statesf n_a = KSL_RN_LANESF(R[3] * R[3]), n_b = KSL_RN_LANESF(R[6] * R[6]), n_c = n_a +
      n_b,
      n = ksl_sqrt_lanesf(n_c);
  const ksl_testsf divisor_a = ksl_equal_lanesf(n, ksl_each_lanesf(0.0f));
  const ksl_statesf divisor = ksl_choice_lanesf(divisor_a, ksl_each_lanesf(1.0f), n);
  const ksl_statesf cosine_a = R[6] / divisor,
      cosine = ksl_choice_lanesf(divisor_a, ksl_each_lanesf(1.0f), cosine_a);
  const ksl_statesf sine = R[3] / divisor;
  const ksl_statesf polar = ksl_atan2_lanesf(R[3], R[6]);
  const ksl_statesf third = ksl_choice_lanesf(divisor_a, ksl_each_lanesf(0.0f), polar);
  const ksl_statesf left_1a = KSL_RN_LANESF(R[4] * cosine), left_1b = KSL_RN_LANESF(R[7] * sine);
  const ksl_statesf left_2a = KSL_RN_LANESF(R[5] * cosine), left_2b = KSL_RN_LANESF(R[8] * sine);
  const ksl_statesf rest = R[1] + R[2];
  const ksl_statesf first = ksl_atan2_lanesf(left_2a - left_2b, left_1a - left_1b);
  const ksl_testsf angles_0a = ksl_less_lanesf(rest, ksl_each_lanesf(1.2676506e+30f));
  const ksl_statesf angles_1 = ksl_choice_lanesf(angles_0a, first, rest);
  const ksl_statesf angles_2 = ksl_atan2_lanesf(n, R[0]);
  angles[0] = angles_1;
  angles[1] = angles_2;
  angles[2] = third;
}

static KSL_INLINE void ksl_mat3x3f_from_axis_angle_states(const ksl_statesf *axis,
    const ksl_statesf *angle, ksl_statesf *R) {
  ksl_statesf cosine; const ksl_statesf sine = ksl_sincos_lanesf(angle[0], &cosine);
  const ksl_statesf half = 0.5f * angle[0];
  const ksl_statesf h = ksl_sin_lanesf(half);
  const ksl_statesf versine_a = KSL_RN_LANESF(h * h), versine_b = 2.0f * versine_a, versine_c = 1.0f
      - cosine;
  const ksl_testsf versine_d = ksl_less_lanesf(cosine, ksl_each_lanesf(0.0f));
  const ksl_statesf versine = ksl_choice_lanesf(versine_d, versine_c, versine_b);
  const ksl_statesf beta_v_1 = axis[0] * versine;
  const ksl_statesf beta_v_2 = axis[1] * versine;
  const ksl_statesf m_1 = KSL_RN_LANESF(axis[0] * beta_v_1);
  const ksl_statesf m_2 = KSL_RN_LANESF(axis[1] * beta_v_2);
  const ksl_statesf m_3 = KSL_RN_LANESF(axis[2] * (axis[2] * versine));
  const ksl_statesf m_4 = KSL_RN_LANESF(axis[1] * beta_v_1);
  const ksl_statesf m_5 = KSL_RN_LANESF(axis[2] * beta_v_1);
  const ksl_statesf m_6 = KSL_RN_LANESF(axis[2] * beta_v_2);
  const ksl_statesf alpha_v_1 = KSL_RN_LANESF(axis[0] * sine);
  const ksl_statesf alpha_v_2 = KSL_RN_LANESF(axis[1] * sine);
  const ksl_statesf alpha_v_3 = KSL_RN_LANESF(axis[2] * sine);
  const ksl_statesf R_1 = 1.0f - (m_2 + m_3);
  const ksl_statesf R_2 = m_4 - alpha_v_3;
  const ksl_statesf R_3 = m_5 + alpha_v_2;
  const ksl_statesf R_4 = m_4 + alpha_v_3;
  const ksl_statesf R_5 = 1.0f - (m_1 + m_3);
  const ksl_statesf R_6 = m_6 - alpha_v_1;
  const ksl_statesf R_7 = m_5 - alpha_v_2;
  const ksl_statesf R_8 = m_6 + alpha_v_1;
  const ksl_statesf R_9 = 1.0f - (m_1 + m_2);
  R[0] = R_1;
  R[3] = R_2;
  R[6] = R_3;
  R[1] = R_4;
  R[4] = R_5;
  R[7] = R_6;
  R[2] = R_7;
  R[5] = R_8;
  R[8] = R_9;
}

static KSL_INLINE void ksl_axis_angle_from_mat3x3f_states(const ksl_statesf *R, ksl_statesf *angle,
    ksl_statesf *axis) {
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

#endif
#endif
