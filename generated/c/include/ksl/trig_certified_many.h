/* Made by `coscrew generate`; changes are overwritten. */
/* SPDX-License-Identifier: MIT */
/* coscrew 0.2.0.  Copyright (c) 2026 The coscrew authors. */
/* Sine and cosine of a joint angle.  Many at a time.
   What arguments are, and what loops over them cost, ksl_planes.h says. */
#ifndef KSL_TRIG_CERTIFIED_MANY_H
#define KSL_TRIG_CERTIFIED_MANY_H

#include "trig_certified.h"
#include "ksl_planes.h"

/* ksl_dc_certified of n elements. */
static KSL_INLINED void ksl_dc_certified_many(ptrdiff_t n, const double *theta,
    ptrdiff_t theta_stride, double *dc, ptrdiff_t dc_stride, double *dc_bound,
    ptrdiff_t dc_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_dc_certified(theta[i * theta_stride], dc + 2 * i * dc_stride,
        dc_bound + 2 * i * dc_bound_stride);
  }
}

static KSL_INLINED void ksl_dc_certified_planes(ptrdiff_t n, const double *theta,
    ptrdiff_t theta_stride, double *dc, ptrdiff_t dc_plane, ptrdiff_t dc_stride,
    double *dc_bound, ptrdiff_t dc_bound_plane, ptrdiff_t dc_bound_stride) {
  KSL_EACH_OF(n) {
    double dc_i[2];
    double dc_bound_i[2];
    ksl_dc_certified(theta[i * theta_stride], dc_i, dc_bound_i);
    dc[0 + i * dc_stride] = dc_i[0];
    dc[dc_plane + i * dc_stride] = dc_i[1];
    dc_bound[0 + i * dc_bound_stride] = dc_bound_i[0];
    dc_bound[dc_bound_plane + i * dc_bound_stride] = dc_bound_i[1];
  }
}

/* ksl_dcf_certified of n elements. */
static KSL_INLINED void ksl_dcf_certified_many(ptrdiff_t n, const float *theta,
    ptrdiff_t theta_stride, float *dc, ptrdiff_t dc_stride, float *dc_bound,
    ptrdiff_t dc_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_dcf_certified(theta[i * theta_stride], dc + 2 * i * dc_stride,
        dc_bound + 2 * i * dc_bound_stride);
  }
}

static KSL_INLINED void ksl_dcf_certified_planes(ptrdiff_t n, const float *theta,
    ptrdiff_t theta_stride, float *dc, ptrdiff_t dc_plane, ptrdiff_t dc_stride,
    float *dc_bound, ptrdiff_t dc_bound_plane, ptrdiff_t dc_bound_stride) {
  KSL_EACH_OF(n) {
    float dc_i[2];
    float dc_bound_i[2];
    ksl_dcf_certified(theta[i * theta_stride], dc_i, dc_bound_i);
    dc[0 + i * dc_stride] = dc_i[0];
    dc[dc_plane + i * dc_stride] = dc_i[1];
    dc_bound[0 + i * dc_bound_stride] = dc_bound_i[0];
    dc_bound[dc_bound_plane + i * dc_bound_stride] = dc_bound_i[1];
  }
}

#endif
