/* Made by `coscrew generate`; changes are overwritten. */
/* SPDX-License-Identifier: MIT */
/* coscrew 0.2.0.  Copyright (c) 2026 The coscrew authors. */
/* Vectors of four components: three dimensions and a homogeneous coordinate.  Many at a time.
   What arguments are, and what loops over them cost, ksl_planes.h says. */
#ifndef KSL_VEC4_MANY_H
#define KSL_VEC4_MANY_H

#include "vec4.h"
#include "ksl_planes.h"

/* ksl_vec4_copy of n elements. */
static KSL_INLINED void ksl_vec4_copy_many(ptrdiff_t n, const ksl_vec4_t *vi, ptrdiff_t vi_stride,
    ksl_vec4_t *vo, ptrdiff_t vo_stride) {
  KSL_EACH_OF(n) {
    ksl_vec4_copy(vi + i * vi_stride, vo + i * vo_stride);
  }
}

static KSL_INLINED void ksl_vec4_copy_planes(ptrdiff_t n, const double *vi, ptrdiff_t vi_plane,
    ptrdiff_t vi_stride, double *vo, ptrdiff_t vo_plane, ptrdiff_t vo_stride) {
  ksl_vec4_t vi_i;
  if (n > 0) vi_i = ksl_vec4_of_planes(vi, vi_plane);
  KSL_EACH_OF(n) {
    if (vi_stride) vi_i = ksl_vec4_of_planes(vi + i * vi_stride, vi_plane);
    ksl_vec4_t vo_i;
    ksl_vec4_copy(&vi_i, &vo_i);
    ksl_vec4_to_planes(&vo_i, vo + i * vo_stride, vo_plane);
  }
}

/* ksl_vec4_scale of n elements. */
static KSL_INLINED void ksl_vec4_scale_many(ptrdiff_t n, ksl_vec4_t *self, ptrdiff_t self_stride,
    const double *a, ptrdiff_t a_stride) {
  KSL_EACH_OF(n) {
    ksl_vec4_scale(self + i * self_stride, a[i * a_stride]);
  }
}

static KSL_INLINED void ksl_vec4_scale_planes(ptrdiff_t n, double *self, ptrdiff_t self_plane,
    ptrdiff_t self_stride, const double *a, ptrdiff_t a_stride) {
  KSL_EACH_OF(n) {
    ksl_vec4_t self_i = ksl_vec4_of_planes(self + i * self_stride, self_plane);
    ksl_vec4_scale(&self_i, a[i * a_stride]);
    ksl_vec4_to_planes(&self_i, self + i * self_stride, self_plane);
  }
}

/* ksl_vec4_inverted of n elements. */
static KSL_INLINED void ksl_vec4_inverted_many(ptrdiff_t n, const ksl_vec4_t *vi,
    ptrdiff_t vi_stride, ksl_vec4_t *vo, ptrdiff_t vo_stride) {
  KSL_EACH_OF(n) {
    ksl_vec4_inverted(vi + i * vi_stride, vo + i * vo_stride);
  }
}

static KSL_INLINED void ksl_vec4_inverted_planes(ptrdiff_t n, const double *vi, ptrdiff_t vi_plane,
    ptrdiff_t vi_stride, double *vo, ptrdiff_t vo_plane, ptrdiff_t vo_stride) {
  ksl_vec4_t vi_i;
  if (n > 0) vi_i = ksl_vec4_of_planes(vi, vi_plane);
  KSL_EACH_OF(n) {
    if (vi_stride) vi_i = ksl_vec4_of_planes(vi + i * vi_stride, vi_plane);
    ksl_vec4_t vo_i;
    ksl_vec4_inverted(&vi_i, &vo_i);
    ksl_vec4_to_planes(&vo_i, vo + i * vo_stride, vo_plane);
  }
}

/* ksl_vec4_invert of n elements. */
static KSL_INLINED void ksl_vec4_invert_many(ptrdiff_t n, ksl_vec4_t *self, ptrdiff_t self_stride) {
  KSL_EACH_OF(n) {
    ksl_vec4_invert(self + i * self_stride);
  }
}

static KSL_INLINED void ksl_vec4_invert_planes(ptrdiff_t n, double *self, ptrdiff_t self_plane,
    ptrdiff_t self_stride) {
  KSL_EACH_OF(n) {
    ksl_vec4_t self_i = ksl_vec4_of_planes(self + i * self_stride, self_plane);
    ksl_vec4_invert(&self_i);
    ksl_vec4_to_planes(&self_i, self + i * self_stride, self_plane);
  }
}

/* ksl_vec4_scaled of n elements. */
static KSL_INLINED void ksl_vec4_scaled_many(ptrdiff_t n, const ksl_vec4_t *v, ptrdiff_t v_stride,
    const double *k, ptrdiff_t k_stride, ksl_vec4_t *vo, ptrdiff_t vo_stride) {
  KSL_EACH_OF(n) {
    ksl_vec4_scaled(v + i * v_stride, k[i * k_stride], vo + i * vo_stride);
  }
}

static KSL_INLINED void ksl_vec4_scaled_planes(ptrdiff_t n, const double *v, ptrdiff_t v_plane,
    ptrdiff_t v_stride, const double *k, ptrdiff_t k_stride, double *vo,
    ptrdiff_t vo_plane, ptrdiff_t vo_stride) {
  ksl_vec4_t v_i;
  if (n > 0) v_i = ksl_vec4_of_planes(v, v_plane);
  KSL_EACH_OF(n) {
    if (v_stride) v_i = ksl_vec4_of_planes(v + i * v_stride, v_plane);
    ksl_vec4_t vo_i;
    ksl_vec4_scaled(&v_i, k[i * k_stride], &vo_i);
    ksl_vec4_to_planes(&vo_i, vo + i * vo_stride, vo_plane);
  }
}

/* ksl_vec4_swap of n elements. */
static KSL_INLINED void ksl_vec4_swap_many(ptrdiff_t n, ksl_vec4_t *v1, ptrdiff_t v1_stride,
    ksl_vec4_t *v2, ptrdiff_t v2_stride) {
  KSL_EACH_OF(n) {
    ksl_vec4_swap(v1 + i * v1_stride, v2 + i * v2_stride);
  }
}

static KSL_INLINED void ksl_vec4_swap_planes(ptrdiff_t n, double *v1, ptrdiff_t v1_plane,
    ptrdiff_t v1_stride, double *v2, ptrdiff_t v2_plane, ptrdiff_t v2_stride) {
  KSL_EACH_OF(n) {
    ksl_vec4_t v1_i = ksl_vec4_of_planes(v1 + i * v1_stride, v1_plane);
    ksl_vec4_t v2_i = ksl_vec4_of_planes(v2 + i * v2_stride, v2_plane);
    ksl_vec4_swap(&v1_i, &v2_i);
    ksl_vec4_to_planes(&v1_i, v1 + i * v1_stride, v1_plane);
    ksl_vec4_to_planes(&v2_i, v2 + i * v2_stride, v2_plane);
  }
}

/* ksl_vec4_l2norm of n elements. */
static KSL_INLINED void ksl_vec4_l2norm_many(ptrdiff_t n, const ksl_vec4_t *v, ptrdiff_t v_stride,
    double *norm, ptrdiff_t norm_stride) {
  KSL_EACH_OF(n) {
    norm[i * norm_stride] = ksl_vec4_l2norm(v + i * v_stride);
  }
}

static KSL_INLINED void ksl_vec4_l2norm_planes(ptrdiff_t n, const double *v, ptrdiff_t v_plane,
    ptrdiff_t v_stride, double *norm, ptrdiff_t norm_stride) {
  ksl_vec4_t v_i;
  if (n > 0) v_i = ksl_vec4_of_planes(v, v_plane);
  KSL_EACH_OF(n) {
    if (v_stride) v_i = ksl_vec4_of_planes(v + i * v_stride, v_plane);
    norm[i * norm_stride] = ksl_vec4_l2norm(&v_i);
  }
}

/* ksl_vec4_normalize of n elements. */
static KSL_INLINED void ksl_vec4_normalize_many(ptrdiff_t n, ksl_vec4_t *self,
    ptrdiff_t self_stride) {
  KSL_EACH_OF(n) {
    ksl_vec4_normalize(self + i * self_stride);
  }
}

static KSL_INLINED void ksl_vec4_normalize_planes(ptrdiff_t n, double *self, ptrdiff_t self_plane,
    ptrdiff_t self_stride) {
  KSL_EACH_OF(n) {
    ksl_vec4_t self_i = ksl_vec4_of_planes(self + i * self_stride, self_plane);
    ksl_vec4_normalize(&self_i);
    ksl_vec4_to_planes(&self_i, self + i * self_stride, self_plane);
  }
}

/* ksl_vec4_normalized of n elements. */
static KSL_INLINED void ksl_vec4_normalized_many(ptrdiff_t n, const ksl_vec4_t *v,
    ptrdiff_t v_stride, ksl_vec4_t *vo, ptrdiff_t vo_stride) {
  KSL_EACH_OF(n) {
    ksl_vec4_normalized(v + i * v_stride, vo + i * vo_stride);
  }
}

static KSL_INLINED void ksl_vec4_normalized_planes(ptrdiff_t n, const double *v, ptrdiff_t v_plane,
    ptrdiff_t v_stride, double *vo, ptrdiff_t vo_plane, ptrdiff_t vo_stride) {
  ksl_vec4_t v_i;
  if (n > 0) v_i = ksl_vec4_of_planes(v, v_plane);
  KSL_EACH_OF(n) {
    if (v_stride) v_i = ksl_vec4_of_planes(v + i * v_stride, v_plane);
    ksl_vec4_t vo_i;
    ksl_vec4_normalized(&v_i, &vo_i);
    ksl_vec4_to_planes(&vo_i, vo + i * vo_stride, vo_plane);
  }
}

/* ksl_vec4f_copy of n elements. */
static KSL_INLINED void ksl_vec4f_copy_many(ptrdiff_t n, const ksl_vec4f_t *vi, ptrdiff_t vi_stride,
    ksl_vec4f_t *vo, ptrdiff_t vo_stride) {
  KSL_EACH_OF(n) {
    ksl_vec4f_copy(vi + i * vi_stride, vo + i * vo_stride);
  }
}

static KSL_INLINED void ksl_vec4f_copy_planes(ptrdiff_t n, const float *vi, ptrdiff_t vi_plane,
    ptrdiff_t vi_stride, float *vo, ptrdiff_t vo_plane, ptrdiff_t vo_stride) {
  ksl_vec4f_t vi_i;
  if (n > 0) vi_i = ksl_vec4f_of_planes(vi, vi_plane);
  KSL_EACH_OF(n) {
    if (vi_stride) vi_i = ksl_vec4f_of_planes(vi + i * vi_stride, vi_plane);
    ksl_vec4f_t vo_i;
    ksl_vec4f_copy(&vi_i, &vo_i);
    ksl_vec4f_to_planes(&vo_i, vo + i * vo_stride, vo_plane);
  }
}

/* ksl_vec4f_scale of n elements. */
static KSL_INLINED void ksl_vec4f_scale_many(ptrdiff_t n, ksl_vec4f_t *self, ptrdiff_t self_stride,
    const float *a, ptrdiff_t a_stride) {
  KSL_EACH_OF(n) {
    ksl_vec4f_scale(self + i * self_stride, a[i * a_stride]);
  }
}

static KSL_INLINED void ksl_vec4f_scale_planes(ptrdiff_t n, float *self, ptrdiff_t self_plane,
    ptrdiff_t self_stride, const float *a, ptrdiff_t a_stride) {
  KSL_EACH_OF(n) {
    ksl_vec4f_t self_i = ksl_vec4f_of_planes(self + i * self_stride, self_plane);
    ksl_vec4f_scale(&self_i, a[i * a_stride]);
    ksl_vec4f_to_planes(&self_i, self + i * self_stride, self_plane);
  }
}

/* ksl_vec4f_inverted of n elements. */
static KSL_INLINED void ksl_vec4f_inverted_many(ptrdiff_t n, const ksl_vec4f_t *vi,
    ptrdiff_t vi_stride, ksl_vec4f_t *vo, ptrdiff_t vo_stride) {
  KSL_EACH_OF(n) {
    ksl_vec4f_inverted(vi + i * vi_stride, vo + i * vo_stride);
  }
}

static KSL_INLINED void ksl_vec4f_inverted_planes(ptrdiff_t n, const float *vi, ptrdiff_t vi_plane,
    ptrdiff_t vi_stride, float *vo, ptrdiff_t vo_plane, ptrdiff_t vo_stride) {
  ksl_vec4f_t vi_i;
  if (n > 0) vi_i = ksl_vec4f_of_planes(vi, vi_plane);
  KSL_EACH_OF(n) {
    if (vi_stride) vi_i = ksl_vec4f_of_planes(vi + i * vi_stride, vi_plane);
    ksl_vec4f_t vo_i;
    ksl_vec4f_inverted(&vi_i, &vo_i);
    ksl_vec4f_to_planes(&vo_i, vo + i * vo_stride, vo_plane);
  }
}

/* ksl_vec4f_invert of n elements. */
static KSL_INLINED void ksl_vec4f_invert_many(ptrdiff_t n, ksl_vec4f_t *self, ptrdiff_t self_stride) {
  KSL_EACH_OF(n) {
    ksl_vec4f_invert(self + i * self_stride);
  }
}

static KSL_INLINED void ksl_vec4f_invert_planes(ptrdiff_t n, float *self, ptrdiff_t self_plane,
    ptrdiff_t self_stride) {
  KSL_EACH_OF(n) {
    ksl_vec4f_t self_i = ksl_vec4f_of_planes(self + i * self_stride, self_plane);
    ksl_vec4f_invert(&self_i);
    ksl_vec4f_to_planes(&self_i, self + i * self_stride, self_plane);
  }
}

/* ksl_vec4f_scaled of n elements. */
static KSL_INLINED void ksl_vec4f_scaled_many(ptrdiff_t n, const ksl_vec4f_t *v, ptrdiff_t v_stride,
    const float *k, ptrdiff_t k_stride, ksl_vec4f_t *vo, ptrdiff_t vo_stride) {
  KSL_EACH_OF(n) {
    ksl_vec4f_scaled(v + i * v_stride, k[i * k_stride], vo + i * vo_stride);
  }
}

static KSL_INLINED void ksl_vec4f_scaled_planes(ptrdiff_t n, const float *v, ptrdiff_t v_plane,
    ptrdiff_t v_stride, const float *k, ptrdiff_t k_stride, float *vo,
    ptrdiff_t vo_plane, ptrdiff_t vo_stride) {
  ksl_vec4f_t v_i;
  if (n > 0) v_i = ksl_vec4f_of_planes(v, v_plane);
  KSL_EACH_OF(n) {
    if (v_stride) v_i = ksl_vec4f_of_planes(v + i * v_stride, v_plane);
    ksl_vec4f_t vo_i;
    ksl_vec4f_scaled(&v_i, k[i * k_stride], &vo_i);
    ksl_vec4f_to_planes(&vo_i, vo + i * vo_stride, vo_plane);
  }
}

/* ksl_vec4f_swap of n elements. */
static KSL_INLINED void ksl_vec4f_swap_many(ptrdiff_t n, ksl_vec4f_t *v1, ptrdiff_t v1_stride,
    ksl_vec4f_t *v2, ptrdiff_t v2_stride) {
  KSL_EACH_OF(n) {
    ksl_vec4f_swap(v1 + i * v1_stride, v2 + i * v2_stride);
  }
}

static KSL_INLINED void ksl_vec4f_swap_planes(ptrdiff_t n, float *v1, ptrdiff_t v1_plane,
    ptrdiff_t v1_stride, float *v2, ptrdiff_t v2_plane, ptrdiff_t v2_stride) {
  KSL_EACH_OF(n) {
    ksl_vec4f_t v1_i = ksl_vec4f_of_planes(v1 + i * v1_stride, v1_plane);
    ksl_vec4f_t v2_i = ksl_vec4f_of_planes(v2 + i * v2_stride, v2_plane);
    ksl_vec4f_swap(&v1_i, &v2_i);
    ksl_vec4f_to_planes(&v1_i, v1 + i * v1_stride, v1_plane);
    ksl_vec4f_to_planes(&v2_i, v2 + i * v2_stride, v2_plane);
  }
}

/* ksl_vec4f_l2norm of n elements. */
static KSL_INLINED void ksl_vec4f_l2norm_many(ptrdiff_t n, const ksl_vec4f_t *v, ptrdiff_t v_stride,
    float *norm, ptrdiff_t norm_stride) {
  KSL_EACH_OF(n) {
    norm[i * norm_stride] = ksl_vec4f_l2norm(v + i * v_stride);
  }
}

static KSL_INLINED void ksl_vec4f_l2norm_planes(ptrdiff_t n, const float *v, ptrdiff_t v_plane,
    ptrdiff_t v_stride, float *norm, ptrdiff_t norm_stride) {
  ksl_vec4f_t v_i;
  if (n > 0) v_i = ksl_vec4f_of_planes(v, v_plane);
  KSL_EACH_OF(n) {
    if (v_stride) v_i = ksl_vec4f_of_planes(v + i * v_stride, v_plane);
    norm[i * norm_stride] = ksl_vec4f_l2norm(&v_i);
  }
}

/* ksl_vec4f_normalize of n elements. */
static KSL_INLINED void ksl_vec4f_normalize_many(ptrdiff_t n, ksl_vec4f_t *self,
    ptrdiff_t self_stride) {
  KSL_EACH_OF(n) {
    ksl_vec4f_normalize(self + i * self_stride);
  }
}

static KSL_INLINED void ksl_vec4f_normalize_planes(ptrdiff_t n, float *self, ptrdiff_t self_plane,
    ptrdiff_t self_stride) {
  KSL_EACH_OF(n) {
    ksl_vec4f_t self_i = ksl_vec4f_of_planes(self + i * self_stride, self_plane);
    ksl_vec4f_normalize(&self_i);
    ksl_vec4f_to_planes(&self_i, self + i * self_stride, self_plane);
  }
}

/* ksl_vec4f_normalized of n elements. */
static KSL_INLINED void ksl_vec4f_normalized_many(ptrdiff_t n, const ksl_vec4f_t *v,
    ptrdiff_t v_stride, ksl_vec4f_t *vo, ptrdiff_t vo_stride) {
  KSL_EACH_OF(n) {
    ksl_vec4f_normalized(v + i * v_stride, vo + i * vo_stride);
  }
}

static KSL_INLINED void ksl_vec4f_normalized_planes(ptrdiff_t n, const float *v, ptrdiff_t v_plane,
    ptrdiff_t v_stride, float *vo, ptrdiff_t vo_plane, ptrdiff_t vo_stride) {
  ksl_vec4f_t v_i;
  if (n > 0) v_i = ksl_vec4f_of_planes(v, v_plane);
  KSL_EACH_OF(n) {
    if (v_stride) v_i = ksl_vec4f_of_planes(v + i * v_stride, v_plane);
    ksl_vec4f_t vo_i;
    ksl_vec4f_normalized(&v_i, &vo_i);
    ksl_vec4f_to_planes(&vo_i, vo + i * vo_stride, vo_plane);
  }
}

#endif
