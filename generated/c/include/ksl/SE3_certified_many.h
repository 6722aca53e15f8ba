/* Made by `coscrew generate`; changes are overwritten. */
/* SPDX-License-Identifier: MIT */
/* coscrew 0.2.0.  Copyright (c) 2026 The coscrew authors. */
/* Displacements D = [R | t].  Many at a time.
   What arguments are, and what loops over them cost, ksl_planes.h says. */
#ifndef KSL_SE3_CERTIFIED_MANY_H
#define KSL_SE3_CERTIFIED_MANY_H

#include "SE3_certified.h"
#include "ksl_planes.h"

/* ksl_SE3_invert_certified of n elements. */
static KSL_INLINED void ksl_SE3_invert_certified_many(ptrdiff_t n, ksl_SE3_t *self,
    ptrdiff_t self_stride, ksl_SE3_t *self_bound, ptrdiff_t self_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_SE3_invert_certified(self + i * self_stride, self_bound + i * self_bound_stride);
  }
}

static KSL_INLINED void ksl_SE3_invert_certified_planes(ptrdiff_t n, double *self,
    ptrdiff_t self_plane, ptrdiff_t self_stride, double *self_bound,
    ptrdiff_t self_bound_plane, ptrdiff_t self_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_SE3_t self_i = ksl_SE3_of_planes(self + i * self_stride, self_plane);
    ksl_SE3_t self_bound_i;
    ksl_SE3_invert_certified(&self_i, &self_bound_i);
    ksl_SE3_to_planes(&self_i, self + i * self_stride, self_plane);
    ksl_SE3_to_planes(&self_bound_i, self_bound + i * self_bound_stride, self_bound_plane);
  }
}

/* ksl_SE3_inverted_certified of n elements. */
static KSL_INLINED void ksl_SE3_inverted_certified_many(ptrdiff_t n, const ksl_SE3_t *D,
    ptrdiff_t D_stride, ksl_SE3_t *Do, ptrdiff_t Do_stride, ksl_SE3_t *Do_bound,
    ptrdiff_t Do_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_SE3_inverted_certified(D + i * D_stride, Do + i * Do_stride, Do_bound + i * Do_bound_stride);
  }
}

static KSL_INLINED void ksl_SE3_inverted_certified_planes(ptrdiff_t n, const double *D,
    ptrdiff_t D_plane, ptrdiff_t D_stride, double *Do, ptrdiff_t Do_plane,
    ptrdiff_t Do_stride, double *Do_bound, ptrdiff_t Do_bound_plane,
    ptrdiff_t Do_bound_stride) {
  ksl_SE3_t D_i;
  if (n > 0) D_i = ksl_SE3_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3_of_planes(D + i * D_stride, D_plane);
    ksl_SE3_t Do_i;
    ksl_SE3_t Do_bound_i;
    ksl_SE3_inverted_certified(&D_i, &Do_i, &Do_bound_i);
    ksl_SE3_to_planes(&Do_i, Do + i * Do_stride, Do_plane);
    ksl_SE3_to_planes(&Do_bound_i, Do_bound + i * Do_bound_stride, Do_bound_plane);
  }
}

/* ksl_SE3f_invert_certified of n elements. */
static KSL_INLINED void ksl_SE3f_invert_certified_many(ptrdiff_t n, ksl_SE3f_t *self,
    ptrdiff_t self_stride, ksl_SE3f_t *self_bound, ptrdiff_t self_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_SE3f_invert_certified(self + i * self_stride, self_bound + i * self_bound_stride);
  }
}

static KSL_INLINED void ksl_SE3f_invert_certified_planes(ptrdiff_t n, float *self,
    ptrdiff_t self_plane, ptrdiff_t self_stride, float *self_bound,
    ptrdiff_t self_bound_plane, ptrdiff_t self_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_SE3f_t self_i = ksl_SE3f_of_planes(self + i * self_stride, self_plane);
    ksl_SE3f_t self_bound_i;
    ksl_SE3f_invert_certified(&self_i, &self_bound_i);
    ksl_SE3f_to_planes(&self_i, self + i * self_stride, self_plane);
    ksl_SE3f_to_planes(&self_bound_i, self_bound + i * self_bound_stride, self_bound_plane);
  }
}

/* ksl_SE3f_inverted_certified of n elements. */
static KSL_INLINED void ksl_SE3f_inverted_certified_many(ptrdiff_t n, const ksl_SE3f_t *D,
    ptrdiff_t D_stride, ksl_SE3f_t *Do, ptrdiff_t Do_stride,
    ksl_SE3f_t *Do_bound, ptrdiff_t Do_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_SE3f_inverted_certified(D + i * D_stride, Do + i * Do_stride,
        Do_bound + i * Do_bound_stride);
  }
}

static KSL_INLINED void ksl_SE3f_inverted_certified_planes(ptrdiff_t n, const float *D,
    ptrdiff_t D_plane, ptrdiff_t D_stride, float *Do, ptrdiff_t Do_plane,
    ptrdiff_t Do_stride, float *Do_bound, ptrdiff_t Do_bound_plane,
    ptrdiff_t Do_bound_stride) {
  ksl_SE3f_t D_i;
  if (n > 0) D_i = ksl_SE3f_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3f_of_planes(D + i * D_stride, D_plane);
    ksl_SE3f_t Do_i;
    ksl_SE3f_t Do_bound_i;
    ksl_SE3f_inverted_certified(&D_i, &Do_i, &Do_bound_i);
    ksl_SE3f_to_planes(&Do_i, Do + i * Do_stride, Do_plane);
    ksl_SE3f_to_planes(&Do_bound_i, Do_bound + i * Do_bound_stride, Do_bound_plane);
  }
}

#endif
