/* Made by `coscrew generate`; changes are overwritten. */
/* SPDX-License-Identifier: MIT */
/* coscrew 0.2.0.  Copyright (c) 2026 The coscrew authors. */
/* Sine and cosine of a joint angle.  Many at a time.
   What arguments are, and what loops over them cost, ksl_planes.h says. */
#ifndef KSL_TRIG_ACCURATE_MANY_H
#define KSL_TRIG_ACCURATE_MANY_H

#include "trig_accurate.h"
#include "ksl_planes.h"

/* ksl_dc_accurate of n elements. */
static KSL_INLINED void ksl_dc_accurate_many(ptrdiff_t n, const double *theta,
    ptrdiff_t theta_stride, double *dc, ptrdiff_t dc_stride) {
  KSL_EACH_OF(n) {
    ksl_dc_accurate(theta[i * theta_stride], dc + 2 * i * dc_stride);
  }
}

static KSL_INLINED void ksl_dc_accurate_planes(ptrdiff_t n, const double *theta,
    ptrdiff_t theta_stride, double *dc, ptrdiff_t dc_plane, ptrdiff_t dc_stride) {
  KSL_EACH_OF(n) {
    double dc_i[2];
    ksl_dc_accurate(theta[i * theta_stride], dc_i);
    dc[0 + i * dc_stride] = dc_i[0];
    dc[dc_plane + i * dc_stride] = dc_i[1];
  }
}

/* ksl_dcf_accurate of n elements. */
static KSL_INLINED void ksl_dcf_accurate_many(ptrdiff_t n, const float *theta,
    ptrdiff_t theta_stride, float *dc, ptrdiff_t dc_stride) {
  KSL_EACH_OF(n) {
    ksl_dcf_accurate(theta[i * theta_stride], dc + 2 * i * dc_stride);
  }
}

static KSL_INLINED void ksl_dcf_accurate_planes(ptrdiff_t n, const float *theta,
    ptrdiff_t theta_stride, float *dc, ptrdiff_t dc_plane, ptrdiff_t dc_stride) {
  KSL_EACH_OF(n) {
    float dc_i[2];
    ksl_dcf_accurate(theta[i * theta_stride], dc_i);
    dc[0 + i * dc_stride] = dc_i[0];
    dc[dc_plane + i * dc_stride] = dc_i[1];
  }
}

#endif
