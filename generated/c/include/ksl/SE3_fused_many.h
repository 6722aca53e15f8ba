/* Made by `coscrew generate`; changes are overwritten. */
/* SPDX-License-Identifier: MIT */
/* coscrew 0.2.0.  Copyright (c) 2026 The coscrew authors. */
/* Displacements D = [R | t].  Many at a time.
   What arguments are, and what loops over them cost, ksl_planes.h says. */
#ifndef KSL_SE3_FUSED_MANY_H
#define KSL_SE3_FUSED_MANY_H

#include "SE3_fused.h"
#include "ksl_planes.h"

/* ksl_SE3_invert_fused of n elements. */
static KSL_INLINED void ksl_SE3_invert_fused_many(ptrdiff_t n, ksl_SE3_t *self,
    ptrdiff_t self_stride) {
  KSL_EACH_OF(n) {
    ksl_SE3_invert_fused(self + i * self_stride);
  }
}

static KSL_INLINED void ksl_SE3_invert_fused_planes(ptrdiff_t n, double *self, ptrdiff_t self_plane,
    ptrdiff_t self_stride) {
  KSL_EACH_OF(n) {
    ksl_SE3_t self_i = ksl_SE3_of_planes(self + i * self_stride, self_plane);
    ksl_SE3_invert_fused(&self_i);
    ksl_SE3_to_planes(&self_i, self + i * self_stride, self_plane);
  }
}

/* ksl_SE3_inverted_fused of n elements. */
static KSL_INLINED void ksl_SE3_inverted_fused_many(ptrdiff_t n, const ksl_SE3_t *D,
    ptrdiff_t D_stride, ksl_SE3_t *Do, ptrdiff_t Do_stride) {
  KSL_EACH_OF(n) {
    ksl_SE3_inverted_fused(D + i * D_stride, Do + i * Do_stride);
  }
}

static KSL_INLINED void ksl_SE3_inverted_fused_planes(ptrdiff_t n, const double *D,
    ptrdiff_t D_plane, ptrdiff_t D_stride, double *Do, ptrdiff_t Do_plane,
    ptrdiff_t Do_stride) {
  ksl_SE3_t D_i;
  if (n > 0) D_i = ksl_SE3_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3_of_planes(D + i * D_stride, D_plane);
    ksl_SE3_t Do_i;
    ksl_SE3_inverted_fused(&D_i, &Do_i);
    ksl_SE3_to_planes(&Do_i, Do + i * Do_stride, Do_plane);
  }
}

/* ksl_SE3f_invert_fused of n elements. */
static KSL_INLINED void ksl_SE3f_invert_fused_many(ptrdiff_t n, ksl_SE3f_t *self,
    ptrdiff_t self_stride) {
  KSL_EACH_OF(n) {
    ksl_SE3f_invert_fused(self + i * self_stride);
  }
}

static KSL_INLINED void ksl_SE3f_invert_fused_planes(ptrdiff_t n, float *self, ptrdiff_t self_plane,
    ptrdiff_t self_stride) {
  KSL_EACH_OF(n) {
    ksl_SE3f_t self_i = ksl_SE3f_of_planes(self + i * self_stride, self_plane);
    ksl_SE3f_invert_fused(&self_i);
    ksl_SE3f_to_planes(&self_i, self + i * self_stride, self_plane);
  }
}

/* ksl_SE3f_inverted_fused of n elements. */
static KSL_INLINED void ksl_SE3f_inverted_fused_many(ptrdiff_t n, const ksl_SE3f_t *D,
    ptrdiff_t D_stride, ksl_SE3f_t *Do, ptrdiff_t Do_stride) {
  KSL_EACH_OF(n) {
    ksl_SE3f_inverted_fused(D + i * D_stride, Do + i * Do_stride);
  }
}

static KSL_INLINED void ksl_SE3f_inverted_fused_planes(ptrdiff_t n, const float *D,
    ptrdiff_t D_plane, ptrdiff_t D_stride, float *Do, ptrdiff_t Do_plane,
    ptrdiff_t Do_stride) {
  ksl_SE3f_t D_i;
  if (n > 0) D_i = ksl_SE3f_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3f_of_planes(D + i * D_stride, D_plane);
    ksl_SE3f_t Do_i;
    ksl_SE3f_inverted_fused(&D_i, &Do_i);
    ksl_SE3f_to_planes(&Do_i, Do + i * Do_stride, Do_plane);
  }
}

#endif
