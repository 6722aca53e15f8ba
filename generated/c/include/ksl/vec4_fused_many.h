/* Made by `coscrew generate`; changes are overwritten. */
/* SPDX-License-Identifier: MIT */
/* coscrew 0.2.0.  Copyright (c) 2026 The coscrew authors. */
/* Vectors of four components: three dimensions and a homogeneous coordinate.  Many at a time.
   What arguments are, and what loops over them cost, ksl_planes.h says. */
#ifndef KSL_VEC4_FUSED_MANY_H
#define KSL_VEC4_FUSED_MANY_H

#include "vec4_fused.h"
#include "ksl_planes.h"

/* ksl_vec4_scale_fused of n elements. */
static KSL_INLINED void ksl_vec4_scale_fused_many(ptrdiff_t n, ksl_vec4_t *self,
    ptrdiff_t self_stride, const double *a, ptrdiff_t a_stride) {
  KSL_EACH_OF(n) {
    ksl_vec4_scale_fused(self + i * self_stride, a[i * a_stride]);
  }
}

static KSL_INLINED void ksl_vec4_scale_fused_planes(ptrdiff_t n, double *self, ptrdiff_t self_plane,
    ptrdiff_t self_stride, const double *a, ptrdiff_t a_stride) {
  KSL_EACH_OF(n) {
    ksl_vec4_t self_i = ksl_vec4_of_planes(self + i * self_stride, self_plane);
    ksl_vec4_scale_fused(&self_i, a[i * a_stride]);
    ksl_vec4_to_planes(&self_i, self + i * self_stride, self_plane);
  }
}

/* ksl_vec4_scaled_fused of n elements. */
static KSL_INLINED void ksl_vec4_scaled_fused_many(ptrdiff_t n, const ksl_vec4_t *v,
    ptrdiff_t v_stride, const double *k, ptrdiff_t k_stride, ksl_vec4_t *vo,
    ptrdiff_t vo_stride) {
  KSL_EACH_OF(n) {
    ksl_vec4_scaled_fused(v + i * v_stride, k[i * k_stride], vo + i * vo_stride);
  }
}

static KSL_INLINED void ksl_vec4_scaled_fused_planes(ptrdiff_t n, const double *v,
    ptrdiff_t v_plane, ptrdiff_t v_stride, const double *k, ptrdiff_t k_stride,
    double *vo, ptrdiff_t vo_plane, ptrdiff_t vo_stride) {
  ksl_vec4_t v_i;
  if (n > 0) v_i = ksl_vec4_of_planes(v, v_plane);
  KSL_EACH_OF(n) {
    if (v_stride) v_i = ksl_vec4_of_planes(v + i * v_stride, v_plane);
    ksl_vec4_t vo_i;
    ksl_vec4_scaled_fused(&v_i, k[i * k_stride], &vo_i);
    ksl_vec4_to_planes(&vo_i, vo + i * vo_stride, vo_plane);
  }
}

/* ksl_vec4f_scale_fused of n elements. */
static KSL_INLINED void ksl_vec4f_scale_fused_many(ptrdiff_t n, ksl_vec4f_t *self,
    ptrdiff_t self_stride, const float *a, ptrdiff_t a_stride) {
  KSL_EACH_OF(n) {
    ksl_vec4f_scale_fused(self + i * self_stride, a[i * a_stride]);
  }
}

static KSL_INLINED void ksl_vec4f_scale_fused_planes(ptrdiff_t n, float *self, ptrdiff_t self_plane,
    ptrdiff_t self_stride, const float *a, ptrdiff_t a_stride) {
  KSL_EACH_OF(n) {
    ksl_vec4f_t self_i = ksl_vec4f_of_planes(self + i * self_stride, self_plane);
    ksl_vec4f_scale_fused(&self_i, a[i * a_stride]);
    ksl_vec4f_to_planes(&self_i, self + i * self_stride, self_plane);
  }
}

/* ksl_vec4f_scaled_fused of n elements. */
static KSL_INLINED void ksl_vec4f_scaled_fused_many(ptrdiff_t n, const ksl_vec4f_t *v,
    ptrdiff_t v_stride, const float *k, ptrdiff_t k_stride, ksl_vec4f_t *vo,
    ptrdiff_t vo_stride) {
  KSL_EACH_OF(n) {
    ksl_vec4f_scaled_fused(v + i * v_stride, k[i * k_stride], vo + i * vo_stride);
  }
}

static KSL_INLINED void ksl_vec4f_scaled_fused_planes(ptrdiff_t n, const float *v,
    ptrdiff_t v_plane, ptrdiff_t v_stride, const float *k, ptrdiff_t k_stride,
    float *vo, ptrdiff_t vo_plane, ptrdiff_t vo_stride) {
  ksl_vec4f_t v_i;
  if (n > 0) v_i = ksl_vec4f_of_planes(v, v_plane);
  KSL_EACH_OF(n) {
    if (v_stride) v_i = ksl_vec4f_of_planes(v + i * v_stride, v_plane);
    ksl_vec4f_t vo_i;
    ksl_vec4f_scaled_fused(&v_i, k[i * k_stride], &vo_i);
    ksl_vec4f_to_planes(&vo_i, vo + i * vo_stride, vo_plane);
  }
}

#endif
