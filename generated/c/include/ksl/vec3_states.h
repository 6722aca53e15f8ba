/* Made by `coscrew generate`; changes are overwritten. */
/* SPDX-License-Identifier: MIT */
/* coscrew 0.2.0.  Copyright (c) 2026 The coscrew authors. */
/* Vectors of three components.  On vectors.
   An argument is its components, in the order of structs, each a vector with that of several
   elements: KSL_LANES of them, in single precision KSL_LANESF. */
#ifndef KSL_VEC3_STATES_H
#define KSL_VEC3_STATES_H

#include "ksl_states.h"

#if KSL_LANE_BYTES
static KSL_INLINE void ksl_angle_vv_states(const ksl_states *v1, const ksl_states *v2,
    ksl_states *angle) {
  const ksl_states s1_size_1 = ksl_abs_lanes(v1[0]);
  const ksl_states s1_size_2 = ksl_abs_lanes(v1[1]);
  const ksl_states s1_size_3 = ksl_abs_lanes(v1[2]);
  const ksl_tests s1_largest1a = ksl_less_lanes(s1_size_1, s1_size_2);
  const ksl_states s1_largest1 = ksl_choice_lanes(s1_largest1a, s1_size_2, s1_size_1);
  const ksl_tests s1_largest2a = ksl_less_lanes(s1_largest1, s1_size_3);
  const ksl_states s1_largest2 = ksl_choice_lanes(s1_largest2a, s1_size_3, s1_largest1);
  const ksl_tests s1a = ksl_less_lanes(ksl_each_lanes(6.703903964971299e+153), s1_largest2);
  const ksl_states s1b = ksl_choice_lanes(s1a, ksl_each_lanes(3.7291703656001034e-155),
      ksl_each_lanes(1.0));
  const ksl_tests s1c = ksl_less_lanes(s1_largest2, ksl_each_lanes(256.0));
  const ksl_states s1d = ksl_choice_lanes(s1c, ksl_each_lanes(1.3093562431584567e+151), s1b);
  const ksl_tests s1e = ksl_less_lanes(s1_largest2, ksl_each_lanes(1.955159272639747e-149));
  const ksl_states s1 = ksl_choice_lanes(s1e, ksl_each_lanes(1.0715086071862673e+301), s1d);
  const ksl_states scaled_s1_1 = v1[0] * s1;
  const ksl_states scaled_s1_2 = v1[1] * s1;
  const ksl_states scaled_s1_3 = v1[2] * s1;
  const ksl_states s2_size_1 = ksl_abs_lanes(v2[0]);
  const ksl_states s2_size_2 = ksl_abs_lanes(v2[1]);
  const ksl_states s2_size_3 = ksl_abs_lanes(v2[2]);
  const ksl_tests s2_largest1a = ksl_less_lanes(s2_size_1, s2_size_2);
  const ksl_states s2_largest1 = ksl_choice_lanes(s2_largest1a, s2_size_2, s2_size_1);
  const ksl_tests s2_largest2a = ksl_less_lanes(s2_largest1, s2_size_3);
  const ksl_states s2_largest2 = ksl_choice_lanes(s2_largest2a, s2_size_3, s2_largest1);
  const ksl_tests s2a = ksl_less_lanes(ksl_each_lanes(6.703903964971299e+153), s2_largest2);
  const ksl_states s2b = ksl_choice_lanes(s2a, ksl_each_lanes(3.7291703656001034e-155),
      ksl_each_lanes(1.0));
  const ksl_tests s2c = ksl_less_lanes(s2_largest2, ksl_each_lanes(256.0));
  const ksl_states s2d = ksl_choice_lanes(s2c, ksl_each_lanes(1.3093562431584567e+151), s2b);
  const ksl_tests s2e = ksl_less_lanes(s2_largest2, ksl_each_lanes(1.955159272639747e-149));
  const ksl_states s2 = ksl_choice_lanes(s2e, ksl_each_lanes(1.0715086071862673e+301), s2d);
  const ksl_states scaled_s2_1 = v2[0] * s2;
  const ksl_states scaled_s2_2 = v2[1] * s2;
  const ksl_states scaled_s2_3 = v2[2] * s2;
  const ksl_states c_0a = KSL_RN_LANES(scaled_s1_2 * scaled_s2_3), c_0b = KSL_RN_LANES(scaled_s1_3 *
      scaled_s2_2),
      c_1 = c_0a - c_0b;
  const ksl_states c_1a = KSL_RN_LANES(scaled_s1_3 * scaled_s2_1), c_1b = KSL_RN_LANES(scaled_s1_1 *
      scaled_s2_3),
      c_2 = c_1a - c_1b;
  const ksl_states c_2a = KSL_RN_LANES(scaled_s1_1 * scaled_s2_2), c_2b = KSL_RN_LANES(scaled_s1_2 *
      scaled_s2_1),
      c_3 = c_2a - c_2b;
  const ksl_states s_size_1 = ksl_abs_lanes(c_1);
  const ksl_states s_size_2 = ksl_abs_lanes(c_2);
  const ksl_states s_size_3 = ksl_abs_lanes(c_3);
  const ksl_tests s_largest1a = ksl_less_lanes(s_size_1, s_size_2);
  const ksl_states s_largest1 = ksl_choice_lanes(s_largest1a, s_size_2, s_size_1);
  const ksl_tests s_largest2a = ksl_less_lanes(s_largest1, s_size_3);
  const ksl_states s_largest2 = ksl_choice_lanes(s_largest2a, s_size_3, s_largest1);
  const ksl_tests s_a = ksl_less_lanes(ksl_each_lanes(6.703903964971299e+153), s_largest2);
  const ksl_states s_b = ksl_choice_lanes(s_a, ksl_each_lanes(3.7291703656001034e-155),
      ksl_each_lanes(1.0));
  const ksl_tests s_c = ksl_less_lanes(s_largest2, ksl_each_lanes(256.0));
  const ksl_states s_d = ksl_choice_lanes(s_c, ksl_each_lanes(1.3093562431584567e+151), s_b);
  const ksl_tests s_e = ksl_less_lanes(s_largest2, ksl_each_lanes(1.955159272639747e-149));
  const ksl_states s = ksl_choice_lanes(s_e, ksl_each_lanes(1.0715086071862673e+301), s_d);
  const ksl_states y_1 = c_1 * s;
  const ksl_states y_2 = c_2 * s;
  const ksl_states y_3 = c_3 * s;
  const ksl_states n_a = KSL_RN_LANES(y_1 * y_1), n_b = KSL_RN_LANES(y_2 * y_2), n_c = n_a + n_b,
      n_d = KSL_RN_LANES(y_3 * y_3),
      n_e = n_c + n_d, n = ksl_sqrt_lanes(n_e);
  const ksl_tests r_a = ksl_less_lanes(s, ksl_each_lanes(1.0));
  const ksl_states r_b = ksl_choice_lanes(r_a, ksl_each_lanes(2.6815615859885194e+154),
      ksl_each_lanes(1.0));
  const ksl_tests r_c = ksl_less_lanes(ksl_each_lanes(1.0), s);
  const ksl_states r_d = ksl_choice_lanes(r_c, ksl_each_lanes(7.637340908749012e-152), r_b);
  const ksl_tests r_e = ksl_less_lanes(ksl_each_lanes(1.3093562431584567e+151), s);
  const ksl_states r = ksl_choice_lanes(r_e, ksl_each_lanes(9.332636185032189e-302), r_d);
  const ksl_states cross = n * r;
  const ksl_states dot__a = KSL_RN_LANES(scaled_s1_1 * scaled_s2_1), dot__b =
      KSL_RN_LANES(scaled_s1_2 * scaled_s2_2),
      dot__c = dot__a + dot__b, dot__d = KSL_RN_LANES(scaled_s1_3 * scaled_s2_3), dot_ = dot__c +
          dot__d;
  const ksl_states angle_ = ksl_atan2_lanes(cross, dot_);
  angle[0] = angle_;
}

static KSL_INLINE void ksl_angle_vvf_states(const ksl_statesf *v1, const ksl_statesf *v2,
    ksl_statesf *angle) {
  const ksl_statesf s1_size_1 = ksl_abs_lanesf(v1[0]);
  const ksl_statesf s1_size_2 = ksl_abs_lanesf(v1[1]);
  const ksl_statesf s1_size_3 = ksl_abs_lanesf(v1[2]);
  const ksl_testsf s1_largest1a = ksl_less_lanesf(s1_size_1, s1_size_2);
  const ksl_statesf s1_largest1 = ksl_choice_lanesf(s1_largest1a, s1_size_2, s1_size_1);
  const ksl_testsf s1_largest2a = ksl_less_lanesf(s1_largest1, s1_size_3);
  const ksl_statesf s1_largest2 = ksl_choice_lanesf(s1_largest2a, s1_size_3, s1_largest1);
  const ksl_testsf s1a = ksl_less_lanesf(ksl_each_lanesf(4.611686e+18f), s1_largest2);
  const ksl_statesf s1b = ksl_choice_lanesf(s1a, ksl_each_lanesf(2.7105054e-20f),
      ksl_each_lanesf(1.0f));
  const ksl_testsf s1c = ksl_less_lanesf(s1_largest2, ksl_each_lanesf(256.0f));
  const ksl_statesf s1d = ksl_choice_lanesf(s1c, ksl_each_lanesf(1.8014399e+16f), s1b);
  const ksl_testsf s1e = ksl_less_lanesf(s1_largest2, ksl_each_lanesf(1.4210855e-14f));
  const ksl_statesf s1 = ksl_choice_lanesf(s1e, ksl_each_lanesf(3.2451855e+32f), s1d);
  const ksl_statesf scaled_s1_1 = v1[0] * s1;
  const ksl_statesf scaled_s1_2 = v1[1] * s1;
  const ksl_statesf scaled_s1_3 = v1[2] * s1;
  const ksl_statesf s2_size_1 = ksl_abs_lanesf(v2[0]);
  const ksl_statesf s2_size_2 = ksl_abs_lanesf(v2[1]);
  const ksl_statesf s2_size_3 = ksl_abs_lanesf(v2[2]);
  const ksl_testsf s2_largest1a = ksl_less_lanesf(s2_size_1, s2_size_2);
  const ksl_statesf s2_largest1 = ksl_choice_lanesf(s2_largest1a, s2_size_2, s2_size_1);
  const ksl_testsf s2_largest2a = ksl_less_lanesf(s2_largest1, s2_size_3);
  const ksl_statesf s2_largest2 = ksl_choice_lanesf(s2_largest2a, s2_size_3, s2_largest1);
  const ksl_testsf s2a = ksl_less_lanesf(ksl_each_lanesf(4.611686e+18f), s2_largest2);
  const ksl_statesf s2b = ksl_choice_lanesf(s2a, ksl_each_lanesf(2.7105054e-20f),
      ksl_each_lanesf(1.0f));
  const ksl_testsf s2c = ksl_less_lanesf(s2_largest2, ksl_each_lanesf(256.0f));
  const ksl_statesf s2d = ksl_choice_lanesf(s2c, ksl_each_lanesf(1.8014399e+16f), s2b);
  const ksl_testsf s2e = ksl_less_lanesf(s2_largest2, ksl_each_lanesf(1.4210855e-14f));
  const ksl_statesf s2 = ksl_choice_lanesf(s2e, ksl_each_lanesf(3.2451855e+32f), s2d);
  const ksl_statesf scaled_s2_1 = v2[0] * s2;
  const ksl_statesf scaled_s2_2 = v2[1] * s2;
  const ksl_statesf scaled_s2_3 = v2[2] * s2;
  const ksl_statesf c_0a = KSL_RN_LANESF(scaled_s1_2 * scaled_s2_3), c_0b =
      KSL_RN_LANESF(scaled_s1_3 * scaled_s2_2),
      c_1 = c_0a - c_0b;
  const ksl_statesf c_1a = KSL_RN_LANESF(scaled_s1_3 * scaled_s2_1), c_1b =
      KSL_RN_LANESF(scaled_s1_1 * scaled_s2_3),
      c_2 = c_1a - c_1b;
  const ksl_statesf c_2a = KSL_RN_LANESF(scaled_s1_1 * scaled_s2_2), c_2b =
      KSL_RN_LANESF(scaled_s1_2 * scaled_s2_1),
      c_3 = c_2a - c_2b;
  const ksl_statesf s_size_1 = ksl_abs_lanesf(c_1);
  const ksl_statesf s_size_2 = ksl_abs_lanesf(c_2);
  const ksl_statesf s_size_3 = ksl_abs_lanesf(c_3);
  const ksl_testsf s_largest1a = ksl_less_lanesf(s_size_1, s_size_2);
  const ksl_statesf s_largest1 = ksl_choice_lanesf(s_largest1a, s_size_2, s_size_1);
  const ksl_testsf s_largest2a = ksl_less_lanesf(s_largest1, s_size_3);
  const ksl_statesf s_largest2 = ksl_choice_lanesf(s_largest2a, s_size_3, s_largest1);
  const ksl_testsf s_a = ksl_less_lanesf(ksl_each_lanesf(4.611686e+18f), s_largest2);
  const ksl_statesf s_b = ksl_choice_lanesf(s_a, ksl_each_lanesf(2.7105054e-20f),
      ksl_each_lanesf(1.0f));
  const ksl_testsf s_c = ksl_less_lanesf(s_largest2, ksl_each_lanesf(256.0f));
  const ksl_statesf s_d = ksl_choice_lanesf(s_c, ksl_each_lanesf(1.8014399e+16f), s_b);
  const ksl_testsf s_e = ksl_less_lanesf(s_largest2, ksl_each_lanesf(1.4210855e-14f));
  const ksl_statesf s = ksl_choice_lanesf(s_e, ksl_each_lanesf(3.2451855e+32f), s_d);
  const ksl_statesf y_1 = c_1 * s;
  const ksl_statesf y_2 = c_2 * s;
  const ksl_statesf y_3 = c_3 * s;
  const ksl_statesf n_a = KSL_RN_LANESF(y_1 * y_1), n_b = KSL_RN_LANESF(y_2 * y_2), n_c = n_a + n_b,
      n_d = KSL_RN_LANESF(y_3 * y_3),
      n_e = n_c + n_d, n = ksl_sqrt_lanesf(n_e);
  const ksl_testsf r_a = ksl_less_lanesf(s, ksl_each_lanesf(1.0f));
  const ksl_statesf r_b = ksl_choice_lanesf(r_a, ksl_each_lanesf(3.689349e+19f),
      ksl_each_lanesf(1.0f));
  const ksl_testsf r_c = ksl_less_lanesf(ksl_each_lanesf(1.0f), s);
  const ksl_statesf r_d = ksl_choice_lanesf(r_c, ksl_each_lanesf(5.551115e-17f), r_b);
  const ksl_testsf r_e = ksl_less_lanesf(ksl_each_lanesf(1.8014399e+16f), s);
  const ksl_statesf r = ksl_choice_lanesf(r_e, ksl_each_lanesf(3.081488e-33f), r_d);
  const ksl_statesf cross = n * r;
  const ksl_statesf dot__a = KSL_RN_LANESF(scaled_s1_1 * scaled_s2_1), dot__b =
      KSL_RN_LANESF(scaled_s1_2 * scaled_s2_2),
      dot__c = dot__a + dot__b, dot__d = KSL_RN_LANESF(scaled_s1_3 * scaled_s2_3), dot_ = dot__c +
          dot__d;
  const ksl_statesf angle_ = ksl_atan2_lanesf(cross, dot_);
  angle[0] = angle_;
}

#endif
#endif
