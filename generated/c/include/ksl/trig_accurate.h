/* Made by `coscrew generate`; changes are overwritten. */
/* SPDX-License-Identifier: MIT */
/* coscrew 0.2.0.  Copyright (c) 2026 The coscrew authors. */
/* Sine and cosine of a joint angle.
   Accurate tier: double compensated, single computed in double. */
#ifndef KSL_TRIG_ACCURATE_H
#define KSL_TRIG_ACCURATE_H

#include "ksl_exact.h"
#include "elementary.h"
#include "ksl_elementary_error.h"

/* dc = (sin θ, cos θ), θ in rad.
   theta: number; dc: (sin θ, cos θ).
   83 mul, 129 add, 11 product error, 1 div, 3 abs, 1 less, 2 equal, 3 select.
   Error <= 0.501 ulp, unless a result is subnormal; proved. */
static inline void ksl_dc_accurate(const double theta, double dc[2]) {
  double dc_1; const double dc_0 = ksl_sincos(theta, &dc_1);
  double dc_1_own_error; const double dc_0_own_error = ksl_sincos_error(theta, dc_0, dc_1,
      &dc_1_own_error);
  const double dc_0_rounded = dc_0 + dc_0_own_error;
  const double dc_1_rounded = dc_1 + dc_1_own_error;
  const double dc_0_final = dc_0_rounded == dc_0_rounded ? dc_0_rounded : dc_0;
  const double dc_1_final = dc_1_rounded == dc_1_rounded ? dc_1_rounded : dc_1;
  dc[0] = dc_0_final;
  dc[1] = dc_1_final;
}

/* dc = (sin θ, cos θ), θ in rad.
   theta: number; dc: (sin θ, cos θ).
   28 mul, 33 add, 1 abs.
   Error <= 0.501 ulp, unless a result is subnormal; proved. */
static inline void ksl_dcf_accurate(const float theta, float dc[2]) {
  double dc_1; const double dc_0 = ksl_sincos((double)theta, &dc_1);
  dc[0] = (float)dc_0;
  dc[1] = (float)dc_1;
}

#endif
