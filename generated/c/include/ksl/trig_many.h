/* Made by `coscrew generate`; changes are overwritten. */
/* SPDX-License-Identifier: MIT */
/* coscrew 0.2.0.  Copyright (c) 2026 The coscrew authors. */
/* Sine and cosine of a joint angle.  Many at a time.
   What arguments are, and what loops over them cost, ksl_planes.h says. */
#ifndef KSL_TRIG_MANY_H
#define KSL_TRIG_MANY_H

#include "trig.h"
#include "ksl_states.h"

#if KSL_LANE_BYTES
/* ksl_dc of KSL_LANES elements, components in the order of structs. */
static KSL_INLINE void ksl_dc_states(const ksl_states *theta, ksl_states *dc) {
  ksl_states dc_2; const ksl_states dc_1 = ksl_sincos_lanes(theta[0], &dc_2);
  dc[0] = dc_1;
  dc[1] = dc_2;
}
#endif

/* ksl_dc of n elements. */
static KSL_INLINED void ksl_dc_planes(ptrdiff_t n, const double *theta, ptrdiff_t theta_stride,
    double *dc, ptrdiff_t dc_plane, ptrdiff_t dc_stride) {
#if KSL_LANE_BYTES
  ksl_states theta_states[1], dc_states[2];
  for (ptrdiff_t i = 0; i < n; i += KSL_LANES) {
    const ptrdiff_t last = n - i < KSL_LANES ? n - i - 1 : KSL_LANES - 1;
    ksl_states_of_planes(theta + i * theta_stride, 1, 1, theta_stride, last, theta_states);
    ksl_dc_states(theta_states, dc_states);
    ksl_states_to_planes(dc_states, 2, dc + i * dc_stride, dc_plane, dc_stride, last);
  }
#else
  KSL_EACH_OF(n) {
    double dc_i[2];
    ksl_dc(theta[i * theta_stride], dc_i);
    dc[0 + i * dc_stride] = dc_i[0];
    dc[dc_plane + i * dc_stride] = dc_i[1];
  }
#endif
}

static KSL_INLINED void ksl_dc_many(ptrdiff_t n, const double *theta, ptrdiff_t theta_stride,
    double *dc, ptrdiff_t dc_stride) {
  ksl_dc_planes(n, theta, theta_stride, dc, 1, 2 * dc_stride);
}

#if KSL_LANE_BYTES
/* ksl_dcf of KSL_LANESF elements, components in the order of structs. */
static KSL_INLINE void ksl_dcf_states(const ksl_statesf *theta, ksl_statesf *dc) {
  ksl_statesf dc_2; const ksl_statesf dc_1 = ksl_sincos_lanesf(theta[0], &dc_2);
  dc[0] = dc_1;
  dc[1] = dc_2;
}
#endif

/* ksl_dcf of n elements. */
static KSL_INLINED void ksl_dcf_planes(ptrdiff_t n, const float *theta, ptrdiff_t theta_stride,
    float *dc, ptrdiff_t dc_plane, ptrdiff_t dc_stride) {
#if KSL_LANE_BYTES
  ksl_statesf theta_states[1], dc_states[2];
  for (ptrdiff_t i = 0; i < n; i += KSL_LANESF) {
    const ptrdiff_t last = n - i < KSL_LANESF ? n - i - 1 : KSL_LANESF - 1;
    ksl_statesf_of_planes(theta + i * theta_stride, 1, 1, theta_stride, last, theta_states);
    ksl_dcf_states(theta_states, dc_states);
    ksl_statesf_to_planes(dc_states, 2, dc + i * dc_stride, dc_plane, dc_stride, last);
  }
#else
  KSL_EACH_OF(n) {
    float dc_i[2];
    ksl_dcf(theta[i * theta_stride], dc_i);
    dc[0 + i * dc_stride] = dc_i[0];
    dc[dc_plane + i * dc_stride] = dc_i[1];
  }
#endif
}

static KSL_INLINED void ksl_dcf_many(ptrdiff_t n, const float *theta, ptrdiff_t theta_stride,
    float *dc, ptrdiff_t dc_stride) {
  ksl_dcf_planes(n, theta, theta_stride, dc, 1, 2 * dc_stride);
}

#endif
