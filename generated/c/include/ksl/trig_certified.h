/* Made by `coscrew generate`; changes are overwritten. */
/* SPDX-License-Identifier: MIT */
/* coscrew 0.2.0.  Copyright (c) 2026 The coscrew authors. */
/* Sine and cosine of a joint angle.
   Certified tier: plain results, and bounds on their errors that always hold. */
#ifndef KSL_TRIG_CERTIFIED_H
#define KSL_TRIG_CERTIFIED_H

#include "ksl_types.h"
#include "elementary.h"
#include "ksl_elementary_error.h"

/* dc = (sin θ, cos θ), θ in rad; |error of dc| <= dc_bound unless inf or NaN.
   theta: number; dc, dc_bound: (sin θ, cos θ).
   83 mul, 129 add, 11 product error, 1 div, 5 abs, 1 less, 1 select. */
static inline void ksl_dc_certified(const double theta, double dc[2], double dc_bound[2]) {
  double dc_1; const double dc_0 = ksl_sincos(theta, &dc_1);
  double dc_own_error_2; const double dc_own_error_1 = ksl_sincos_error(theta, dc_0, dc_1,
      &dc_own_error_2);
  const double dc_bound_1 = 3.7470896994678994e-30 + fabs(dc_own_error_1),
      dc_bound_2 = 3.7470896994678994e-30 + fabs(dc_own_error_2);
  dc[0] = dc_0;
  dc[1] = dc_1;
  dc_bound[0] = dc_bound_1;
  dc_bound[1] = dc_bound_2;
}

/* dc = (sin θ, cos θ), θ in rad; |error of dc| <= dc_bound unless inf or NaN.
   theta: number; dc, dc_bound: (sin θ, cos θ).
   65 mul, 100 add, 8 product error, 1 div, 5 abs, 1 less, 1 select. */
static inline void ksl_dcf_certified(const float theta, float dc[2], float dc_bound[2]) {
  float dc_1; const float dc_0 = ksl_sincosf(theta, &dc_1);
  float dc_own_error_2; const float dc_own_error_1 = ksl_sincos_errorf(theta, dc_0, dc_1,
      &dc_own_error_2);
  const float dc_bound_1 = 1.0800312e-12f + fabsf(dc_own_error_1),
      dc_bound_2 = 1.0800312e-12f + fabsf(dc_own_error_2);
  dc[0] = dc_0;
  dc[1] = dc_1;
  dc_bound[0] = dc_bound_1;
  dc_bound[1] = dc_bound_2;
}

#endif
