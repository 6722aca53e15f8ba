/* Made by `coscrew generate`; changes are overwritten. */
/* SPDX-License-Identifier: MIT */
/* coscrew 0.2.0.  Copyright (c) 2026 The coscrew authors. */
/* Vectors of three components.  Many at a time.
   What arguments are, and what loops over them cost, ksl_planes.h says. */
#ifndef KSL_VEC3_FUSED_MANY_H
#define KSL_VEC3_FUSED_MANY_H

#include "vec3_fused.h"
#include "ksl_planes.h"

/* ksl_vec3_scale_fused of n elements. */
static KSL_INLINED void ksl_vec3_scale_fused_many(ptrdiff_t n, ksl_vec3_t *self,
    ptrdiff_t self_stride, const double *a, ptrdiff_t a_stride) {
  KSL_EACH_OF(n) {
    ksl_vec3_scale_fused(self + i * self_stride, a[i * a_stride]);
  }
}

static KSL_INLINED void ksl_vec3_scale_fused_planes(ptrdiff_t n, double *self, ptrdiff_t self_plane,
    ptrdiff_t self_stride, const double *a, ptrdiff_t a_stride) {
  KSL_EACH_OF(n) {
    ksl_vec3_t self_i = ksl_vec3_of_planes(self + i * self_stride, self_plane);
    ksl_vec3_scale_fused(&self_i, a[i * a_stride]);
    ksl_vec3_to_planes(&self_i, self + i * self_stride, self_plane);
  }
}

/* ksl_axpy_vv_fused of n elements. */
static KSL_INLINED void ksl_axpy_vv_fused_many(ptrdiff_t n, const double *a, ptrdiff_t a_stride,
    const ksl_vec3_t *x, ptrdiff_t x_stride, ksl_vec3_t *y, ptrdiff_t y_stride) {
  KSL_EACH_OF(n) {
    ksl_axpy_vv_fused(a[i * a_stride], x + i * x_stride, y + i * y_stride);
  }
}

static KSL_INLINED void ksl_axpy_vv_fused_planes(ptrdiff_t n, const double *a, ptrdiff_t a_stride,
    const double *x, ptrdiff_t x_plane, ptrdiff_t x_stride, double *y,
    ptrdiff_t y_plane, ptrdiff_t y_stride) {
  KSL_EACH_OF(n) {
    const ksl_vec3_t x_i = ksl_vec3_of_planes(x + i * x_stride, x_plane);
    ksl_vec3_t y_i = ksl_vec3_of_planes(y + i * y_stride, y_plane);
    ksl_axpy_vv_fused(a[i * a_stride], &x_i, &y_i);
    ksl_vec3_to_planes(&y_i, y + i * y_stride, y_plane);
  }
}

/* ksl_xpy_vv_fused of n elements. */
static KSL_INLINED void ksl_xpy_vv_fused_many(ptrdiff_t n, const ksl_vec3_t *x, ptrdiff_t x_stride,
    ksl_vec3_t *y, ptrdiff_t y_stride) {
  KSL_EACH_OF(n) {
    ksl_xpy_vv_fused(x + i * x_stride, y + i * y_stride);
  }
}

static KSL_INLINED void ksl_xpy_vv_fused_planes(ptrdiff_t n, const double *x, ptrdiff_t x_plane,
    ptrdiff_t x_stride, double *y, ptrdiff_t y_plane, ptrdiff_t y_stride) {
  ksl_vec3_t x_i;
  if (n > 0) x_i = ksl_vec3_of_planes(x, x_plane);
  KSL_EACH_OF(n) {
    if (x_stride) x_i = ksl_vec3_of_planes(x + i * x_stride, x_plane);
    ksl_vec3_t y_i = ksl_vec3_of_planes(y + i * y_stride, y_plane);
    ksl_xpy_vv_fused(&x_i, &y_i);
    ksl_vec3_to_planes(&y_i, y + i * y_stride, y_plane);
  }
}

/* ksl_nxpy_vv_fused of n elements. */
static KSL_INLINED void ksl_nxpy_vv_fused_many(ptrdiff_t n, const ksl_vec3_t *x, ptrdiff_t x_stride,
    ksl_vec3_t *y, ptrdiff_t y_stride) {
  KSL_EACH_OF(n) {
    ksl_nxpy_vv_fused(x + i * x_stride, y + i * y_stride);
  }
}

static KSL_INLINED void ksl_nxpy_vv_fused_planes(ptrdiff_t n, const double *x, ptrdiff_t x_plane,
    ptrdiff_t x_stride, double *y, ptrdiff_t y_plane, ptrdiff_t y_stride) {
  ksl_vec3_t x_i;
  if (n > 0) x_i = ksl_vec3_of_planes(x, x_plane);
  KSL_EACH_OF(n) {
    if (x_stride) x_i = ksl_vec3_of_planes(x + i * x_stride, x_plane);
    ksl_vec3_t y_i = ksl_vec3_of_planes(y + i * y_stride, y_plane);
    ksl_nxpy_vv_fused(&x_i, &y_i);
    ksl_vec3_to_planes(&y_i, y + i * y_stride, y_plane);
  }
}

/* ksl_product_av_fused of n elements. */
static KSL_INLINED void ksl_product_av_fused_many(ptrdiff_t n, const double *a, ptrdiff_t a_stride,
    const ksl_vec3_t *vi, ptrdiff_t vi_stride, ksl_vec3_t *vo,
    ptrdiff_t vo_stride) {
  KSL_EACH_OF(n) {
    ksl_product_av_fused(a[i * a_stride], vi + i * vi_stride, vo + i * vo_stride);
  }
}

static KSL_INLINED void ksl_product_av_fused_planes(ptrdiff_t n, const double *a,
    ptrdiff_t a_stride, const double *vi, ptrdiff_t vi_plane,
    ptrdiff_t vi_stride, double *vo, ptrdiff_t vo_plane, ptrdiff_t vo_stride) {
  KSL_EACH_OF(n) {
    const ksl_vec3_t vi_i = ksl_vec3_of_planes(vi + i * vi_stride, vi_plane);
    ksl_vec3_t vo_i;
    ksl_product_av_fused(a[i * a_stride], &vi_i, &vo_i);
    ksl_vec3_to_planes(&vo_i, vo + i * vo_stride, vo_plane);
  }
}

/* ksl_add_vv_fused of n elements. */
static KSL_INLINED void ksl_add_vv_fused_many(ptrdiff_t n, const ksl_vec3_t *v1,
    ptrdiff_t v1_stride, const ksl_vec3_t *v2, ptrdiff_t v2_stride,
    ksl_vec3_t *vo, ptrdiff_t vo_stride) {
  KSL_EACH_OF(n) {
    ksl_add_vv_fused(v1 + i * v1_stride, v2 + i * v2_stride, vo + i * vo_stride);
  }
}

static KSL_INLINED void ksl_add_vv_fused_planes(ptrdiff_t n, const double *v1, ptrdiff_t v1_plane,
    ptrdiff_t v1_stride, const double *v2, ptrdiff_t v2_plane,
    ptrdiff_t v2_stride, double *vo, ptrdiff_t vo_plane, ptrdiff_t vo_stride) {
  ksl_vec3_t v1_i;
  if (n > 0) v1_i = ksl_vec3_of_planes(v1, v1_plane);
  KSL_EACH_OF(n) {
    if (v1_stride) v1_i = ksl_vec3_of_planes(v1 + i * v1_stride, v1_plane);
    const ksl_vec3_t v2_i = ksl_vec3_of_planes(v2 + i * v2_stride, v2_plane);
    ksl_vec3_t vo_i;
    ksl_add_vv_fused(&v1_i, &v2_i, &vo_i);
    ksl_vec3_to_planes(&vo_i, vo + i * vo_stride, vo_plane);
  }
}

/* ksl_subtract_vv_fused of n elements. */
static KSL_INLINED void ksl_subtract_vv_fused_many(ptrdiff_t n, const ksl_vec3_t *v1,
    ptrdiff_t v1_stride, const ksl_vec3_t *v2, ptrdiff_t v2_stride,
    ksl_vec3_t *vo, ptrdiff_t vo_stride) {
  KSL_EACH_OF(n) {
    ksl_subtract_vv_fused(v1 + i * v1_stride, v2 + i * v2_stride, vo + i * vo_stride);
  }
}

static KSL_INLINED void ksl_subtract_vv_fused_planes(ptrdiff_t n, const double *v1,
    ptrdiff_t v1_plane, ptrdiff_t v1_stride, const double *v2,
    ptrdiff_t v2_plane, ptrdiff_t v2_stride, double *vo, ptrdiff_t vo_plane,
    ptrdiff_t vo_stride) {
  ksl_vec3_t v1_i;
  if (n > 0) v1_i = ksl_vec3_of_planes(v1, v1_plane);
  KSL_EACH_OF(n) {
    if (v1_stride) v1_i = ksl_vec3_of_planes(v1 + i * v1_stride, v1_plane);
    const ksl_vec3_t v2_i = ksl_vec3_of_planes(v2 + i * v2_stride, v2_plane);
    ksl_vec3_t vo_i;
    ksl_subtract_vv_fused(&v1_i, &v2_i, &vo_i);
    ksl_vec3_to_planes(&vo_i, vo + i * vo_stride, vo_plane);
  }
}

/* ksl_vec3_scaled_fused of n elements. */
static KSL_INLINED void ksl_vec3_scaled_fused_many(ptrdiff_t n, const ksl_vec3_t *v,
    ptrdiff_t v_stride, const double *k, ptrdiff_t k_stride, ksl_vec3_t *vo,
    ptrdiff_t vo_stride) {
  KSL_EACH_OF(n) {
    ksl_vec3_scaled_fused(v + i * v_stride, k[i * k_stride], vo + i * vo_stride);
  }
}

static KSL_INLINED void ksl_vec3_scaled_fused_planes(ptrdiff_t n, const double *v,
    ptrdiff_t v_plane, ptrdiff_t v_stride, const double *k, ptrdiff_t k_stride,
    double *vo, ptrdiff_t vo_plane, ptrdiff_t vo_stride) {
  ksl_vec3_t v_i;
  if (n > 0) v_i = ksl_vec3_of_planes(v, v_plane);
  KSL_EACH_OF(n) {
    if (v_stride) v_i = ksl_vec3_of_planes(v + i * v_stride, v_plane);
    ksl_vec3_t vo_i;
    ksl_vec3_scaled_fused(&v_i, k[i * k_stride], &vo_i);
    ksl_vec3_to_planes(&vo_i, vo + i * vo_stride, vo_plane);
  }
}

/* ksl_dot_vv_fused of n elements. */
static KSL_INLINED void ksl_dot_vv_fused_many(ptrdiff_t n, const ksl_vec3_t *v1,
    ptrdiff_t v1_stride, const ksl_vec3_t *v2, ptrdiff_t v2_stride, double *dot,
    ptrdiff_t dot_stride) {
  KSL_EACH_OF(n) {
    dot[i * dot_stride] = ksl_dot_vv_fused(v1 + i * v1_stride, v2 + i * v2_stride);
  }
}

static KSL_INLINED void ksl_dot_vv_fused_planes(ptrdiff_t n, const double *v1, ptrdiff_t v1_plane,
    ptrdiff_t v1_stride, const double *v2, ptrdiff_t v2_plane,
    ptrdiff_t v2_stride, double *dot, ptrdiff_t dot_stride) {
  ksl_vec3_t v1_i;
  if (n > 0) v1_i = ksl_vec3_of_planes(v1, v1_plane);
  KSL_EACH_OF(n) {
    if (v1_stride) v1_i = ksl_vec3_of_planes(v1 + i * v1_stride, v1_plane);
    const ksl_vec3_t v2_i = ksl_vec3_of_planes(v2 + i * v2_stride, v2_plane);
    dot[i * dot_stride] = ksl_dot_vv_fused(&v1_i, &v2_i);
  }
}

/* ksl_product_avinv_fused of n elements. */
static KSL_INLINED void ksl_product_avinv_fused_many(ptrdiff_t n, const double *k,
    ptrdiff_t k_stride, const ksl_vec3_t *v, ptrdiff_t v_stride, ksl_vec3_t *vo,
    ptrdiff_t vo_stride) {
  KSL_EACH_OF(n) {
    ksl_product_avinv_fused(k[i * k_stride], v + i * v_stride, vo + i * vo_stride);
  }
}

static KSL_INLINED void ksl_product_avinv_fused_planes(ptrdiff_t n, const double *k,
    ptrdiff_t k_stride, const double *v, ptrdiff_t v_plane, ptrdiff_t v_stride,
    double *vo, ptrdiff_t vo_plane, ptrdiff_t vo_stride) {
  KSL_EACH_OF(n) {
    const ksl_vec3_t v_i = ksl_vec3_of_planes(v + i * v_stride, v_plane);
    ksl_vec3_t vo_i;
    ksl_product_avinv_fused(k[i * k_stride], &v_i, &vo_i);
    ksl_vec3_to_planes(&vo_i, vo + i * vo_stride, vo_plane);
  }
}

/* ksl_cross_vv_fused of n elements. */
static KSL_INLINED void ksl_cross_vv_fused_many(ptrdiff_t n, const ksl_vec3_t *v1,
    ptrdiff_t v1_stride, const ksl_vec3_t *v2, ptrdiff_t v2_stride,
    ksl_vec3_t *vo, ptrdiff_t vo_stride) {
  KSL_EACH_OF(n) {
    ksl_cross_vv_fused(v1 + i * v1_stride, v2 + i * v2_stride, vo + i * vo_stride);
  }
}

static KSL_INLINED void ksl_cross_vv_fused_planes(ptrdiff_t n, const double *v1, ptrdiff_t v1_plane,
    ptrdiff_t v1_stride, const double *v2, ptrdiff_t v2_plane,
    ptrdiff_t v2_stride, double *vo, ptrdiff_t vo_plane, ptrdiff_t vo_stride) {
  ksl_vec3_t v1_i;
  if (n > 0) v1_i = ksl_vec3_of_planes(v1, v1_plane);
  KSL_EACH_OF(n) {
    if (v1_stride) v1_i = ksl_vec3_of_planes(v1 + i * v1_stride, v1_plane);
    const ksl_vec3_t v2_i = ksl_vec3_of_planes(v2 + i * v2_stride, v2_plane);
    ksl_vec3_t vo_i;
    ksl_cross_vv_fused(&v1_i, &v2_i, &vo_i);
    ksl_vec3_to_planes(&vo_i, vo + i * vo_stride, vo_plane);
  }
}

/* ksl_cross_vvinv_fused of n elements. */
static KSL_INLINED void ksl_cross_vvinv_fused_many(ptrdiff_t n, const ksl_vec3_t *v1,
    ptrdiff_t v1_stride, const ksl_vec3_t *v2, ptrdiff_t v2_stride,
    ksl_vec3_t *vo, ptrdiff_t vo_stride) {
  KSL_EACH_OF(n) {
    ksl_cross_vvinv_fused(v1 + i * v1_stride, v2 + i * v2_stride, vo + i * vo_stride);
  }
}

static KSL_INLINED void ksl_cross_vvinv_fused_planes(ptrdiff_t n, const double *v1,
    ptrdiff_t v1_plane, ptrdiff_t v1_stride, const double *v2,
    ptrdiff_t v2_plane, ptrdiff_t v2_stride, double *vo, ptrdiff_t vo_plane,
    ptrdiff_t vo_stride) {
  ksl_vec3_t v1_i;
  if (n > 0) v1_i = ksl_vec3_of_planes(v1, v1_plane);
  KSL_EACH_OF(n) {
    if (v1_stride) v1_i = ksl_vec3_of_planes(v1 + i * v1_stride, v1_plane);
    const ksl_vec3_t v2_i = ksl_vec3_of_planes(v2 + i * v2_stride, v2_plane);
    ksl_vec3_t vo_i;
    ksl_cross_vvinv_fused(&v1_i, &v2_i, &vo_i);
    ksl_vec3_to_planes(&vo_i, vo + i * vo_stride, vo_plane);
  }
}

/* ksl_add_vvx_fused of n elements. */
static KSL_INLINED void ksl_add_vvx_fused_many(ptrdiff_t n, const ksl_vec3_t *v, ptrdiff_t v_stride,
    const double *k, ptrdiff_t k_stride, ksl_vec3_t *vo, ptrdiff_t vo_stride) {
  KSL_EACH_OF(n) {
    ksl_add_vvx_fused(v + i * v_stride, k[i * k_stride], vo + i * vo_stride);
  }
}

static KSL_INLINED void ksl_add_vvx_fused_planes(ptrdiff_t n, const double *v, ptrdiff_t v_plane,
    ptrdiff_t v_stride, const double *k, ptrdiff_t k_stride, double *vo,
    ptrdiff_t vo_plane, ptrdiff_t vo_stride) {
  ksl_vec3_t v_i;
  if (n > 0) v_i = ksl_vec3_of_planes(v, v_plane);
  KSL_EACH_OF(n) {
    if (v_stride) v_i = ksl_vec3_of_planes(v + i * v_stride, v_plane);
    ksl_vec3_t vo_i;
    ksl_add_vvx_fused(&v_i, k[i * k_stride], &vo_i);
    ksl_vec3_to_planes(&vo_i, vo + i * vo_stride, vo_plane);
  }
}

/* ksl_add_vvxinv_fused of n elements. */
static KSL_INLINED void ksl_add_vvxinv_fused_many(ptrdiff_t n, const ksl_vec3_t *v,
    ptrdiff_t v_stride, const double *k, ptrdiff_t k_stride, ksl_vec3_t *vo,
    ptrdiff_t vo_stride) {
  KSL_EACH_OF(n) {
    ksl_add_vvxinv_fused(v + i * v_stride, k[i * k_stride], vo + i * vo_stride);
  }
}

static KSL_INLINED void ksl_add_vvxinv_fused_planes(ptrdiff_t n, const double *v, ptrdiff_t v_plane,
    ptrdiff_t v_stride, const double *k, ptrdiff_t k_stride, double *vo,
    ptrdiff_t vo_plane, ptrdiff_t vo_stride) {
  ksl_vec3_t v_i;
  if (n > 0) v_i = ksl_vec3_of_planes(v, v_plane);
  KSL_EACH_OF(n) {
    if (v_stride) v_i = ksl_vec3_of_planes(v + i * v_stride, v_plane);
    ksl_vec3_t vo_i;
    ksl_add_vvxinv_fused(&v_i, k[i * k_stride], &vo_i);
    ksl_vec3_to_planes(&vo_i, vo + i * vo_stride, vo_plane);
  }
}

/* ksl_add_vvy_fused of n elements. */
static KSL_INLINED void ksl_add_vvy_fused_many(ptrdiff_t n, const ksl_vec3_t *v, ptrdiff_t v_stride,
    const double *k, ptrdiff_t k_stride, ksl_vec3_t *vo, ptrdiff_t vo_stride) {
  KSL_EACH_OF(n) {
    ksl_add_vvy_fused(v + i * v_stride, k[i * k_stride], vo + i * vo_stride);
  }
}

static KSL_INLINED void ksl_add_vvy_fused_planes(ptrdiff_t n, const double *v, ptrdiff_t v_plane,
    ptrdiff_t v_stride, const double *k, ptrdiff_t k_stride, double *vo,
    ptrdiff_t vo_plane, ptrdiff_t vo_stride) {
  ksl_vec3_t v_i;
  if (n > 0) v_i = ksl_vec3_of_planes(v, v_plane);
  KSL_EACH_OF(n) {
    if (v_stride) v_i = ksl_vec3_of_planes(v + i * v_stride, v_plane);
    ksl_vec3_t vo_i;
    ksl_add_vvy_fused(&v_i, k[i * k_stride], &vo_i);
    ksl_vec3_to_planes(&vo_i, vo + i * vo_stride, vo_plane);
  }
}

/* ksl_add_vvyinv_fused of n elements. */
static KSL_INLINED void ksl_add_vvyinv_fused_many(ptrdiff_t n, const ksl_vec3_t *v,
    ptrdiff_t v_stride, const double *k, ptrdiff_t k_stride, ksl_vec3_t *vo,
    ptrdiff_t vo_stride) {
  KSL_EACH_OF(n) {
    ksl_add_vvyinv_fused(v + i * v_stride, k[i * k_stride], vo + i * vo_stride);
  }
}

static KSL_INLINED void ksl_add_vvyinv_fused_planes(ptrdiff_t n, const double *v, ptrdiff_t v_plane,
    ptrdiff_t v_stride, const double *k, ptrdiff_t k_stride, double *vo,
    ptrdiff_t vo_plane, ptrdiff_t vo_stride) {
  ksl_vec3_t v_i;
  if (n > 0) v_i = ksl_vec3_of_planes(v, v_plane);
  KSL_EACH_OF(n) {
    if (v_stride) v_i = ksl_vec3_of_planes(v + i * v_stride, v_plane);
    ksl_vec3_t vo_i;
    ksl_add_vvyinv_fused(&v_i, k[i * k_stride], &vo_i);
    ksl_vec3_to_planes(&vo_i, vo + i * vo_stride, vo_plane);
  }
}

/* ksl_add_vvz_fused of n elements. */
static KSL_INLINED void ksl_add_vvz_fused_many(ptrdiff_t n, const ksl_vec3_t *v, ptrdiff_t v_stride,
    const double *k, ptrdiff_t k_stride, ksl_vec3_t *vo, ptrdiff_t vo_stride) {
  KSL_EACH_OF(n) {
    ksl_add_vvz_fused(v + i * v_stride, k[i * k_stride], vo + i * vo_stride);
  }
}

static KSL_INLINED void ksl_add_vvz_fused_planes(ptrdiff_t n, const double *v, ptrdiff_t v_plane,
    ptrdiff_t v_stride, const double *k, ptrdiff_t k_stride, double *vo,
    ptrdiff_t vo_plane, ptrdiff_t vo_stride) {
  ksl_vec3_t v_i;
  if (n > 0) v_i = ksl_vec3_of_planes(v, v_plane);
  KSL_EACH_OF(n) {
    if (v_stride) v_i = ksl_vec3_of_planes(v + i * v_stride, v_plane);
    ksl_vec3_t vo_i;
    ksl_add_vvz_fused(&v_i, k[i * k_stride], &vo_i);
    ksl_vec3_to_planes(&vo_i, vo + i * vo_stride, vo_plane);
  }
}

/* ksl_add_vvzinv_fused of n elements. */
static KSL_INLINED void ksl_add_vvzinv_fused_many(ptrdiff_t n, const ksl_vec3_t *v,
    ptrdiff_t v_stride, const double *k, ptrdiff_t k_stride, ksl_vec3_t *vo,
    ptrdiff_t vo_stride) {
  KSL_EACH_OF(n) {
    ksl_add_vvzinv_fused(v + i * v_stride, k[i * k_stride], vo + i * vo_stride);
  }
}

static KSL_INLINED void ksl_add_vvzinv_fused_planes(ptrdiff_t n, const double *v, ptrdiff_t v_plane,
    ptrdiff_t v_stride, const double *k, ptrdiff_t k_stride, double *vo,
    ptrdiff_t vo_plane, ptrdiff_t vo_stride) {
  ksl_vec3_t v_i;
  if (n > 0) v_i = ksl_vec3_of_planes(v, v_plane);
  KSL_EACH_OF(n) {
    if (v_stride) v_i = ksl_vec3_of_planes(v + i * v_stride, v_plane);
    ksl_vec3_t vo_i;
    ksl_add_vvzinv_fused(&v_i, k[i * k_stride], &vo_i);
    ksl_vec3_to_planes(&vo_i, vo + i * vo_stride, vo_plane);
  }
}

/* ksl_vec3f_scale_fused of n elements. */
static KSL_INLINED void ksl_vec3f_scale_fused_many(ptrdiff_t n, ksl_vec3f_t *self,
    ptrdiff_t self_stride, const float *a, ptrdiff_t a_stride) {
  KSL_EACH_OF(n) {
    ksl_vec3f_scale_fused(self + i * self_stride, a[i * a_stride]);
  }
}

static KSL_INLINED void ksl_vec3f_scale_fused_planes(ptrdiff_t n, float *self, ptrdiff_t self_plane,
    ptrdiff_t self_stride, const float *a, ptrdiff_t a_stride) {
  KSL_EACH_OF(n) {
    ksl_vec3f_t self_i = ksl_vec3f_of_planes(self + i * self_stride, self_plane);
    ksl_vec3f_scale_fused(&self_i, a[i * a_stride]);
    ksl_vec3f_to_planes(&self_i, self + i * self_stride, self_plane);
  }
}

/* ksl_axpy_vvf_fused of n elements. */
static KSL_INLINED void ksl_axpy_vvf_fused_many(ptrdiff_t n, const float *a, ptrdiff_t a_stride,
    const ksl_vec3f_t *x, ptrdiff_t x_stride, ksl_vec3f_t *y, ptrdiff_t y_stride) {
  KSL_EACH_OF(n) {
    ksl_axpy_vvf_fused(a[i * a_stride], x + i * x_stride, y + i * y_stride);
  }
}

static KSL_INLINED void ksl_axpy_vvf_fused_planes(ptrdiff_t n, const float *a, ptrdiff_t a_stride,
    const float *x, ptrdiff_t x_plane, ptrdiff_t x_stride, float *y,
    ptrdiff_t y_plane, ptrdiff_t y_stride) {
  KSL_EACH_OF(n) {
    const ksl_vec3f_t x_i = ksl_vec3f_of_planes(x + i * x_stride, x_plane);
    ksl_vec3f_t y_i = ksl_vec3f_of_planes(y + i * y_stride, y_plane);
    ksl_axpy_vvf_fused(a[i * a_stride], &x_i, &y_i);
    ksl_vec3f_to_planes(&y_i, y + i * y_stride, y_plane);
  }
}

/* ksl_xpy_vvf_fused of n elements. */
static KSL_INLINED void ksl_xpy_vvf_fused_many(ptrdiff_t n, const ksl_vec3f_t *x,
    ptrdiff_t x_stride, ksl_vec3f_t *y, ptrdiff_t y_stride) {
  KSL_EACH_OF(n) {
    ksl_xpy_vvf_fused(x + i * x_stride, y + i * y_stride);
  }
}

static KSL_INLINED void ksl_xpy_vvf_fused_planes(ptrdiff_t n, const float *x, ptrdiff_t x_plane,
    ptrdiff_t x_stride, float *y, ptrdiff_t y_plane, ptrdiff_t y_stride) {
  ksl_vec3f_t x_i;
  if (n > 0) x_i = ksl_vec3f_of_planes(x, x_plane);
  KSL_EACH_OF(n) {
    if (x_stride) x_i = ksl_vec3f_of_planes(x + i * x_stride, x_plane);
    ksl_vec3f_t y_i = ksl_vec3f_of_planes(y + i * y_stride, y_plane);
    ksl_xpy_vvf_fused(&x_i, &y_i);
    ksl_vec3f_to_planes(&y_i, y + i * y_stride, y_plane);
  }
}

/* ksl_nxpy_vvf_fused of n elements. */
static KSL_INLINED void ksl_nxpy_vvf_fused_many(ptrdiff_t n, const ksl_vec3f_t *x,
    ptrdiff_t x_stride, ksl_vec3f_t *y, ptrdiff_t y_stride) {
  KSL_EACH_OF(n) {
    ksl_nxpy_vvf_fused(x + i * x_stride, y + i * y_stride);
  }
}

static KSL_INLINED void ksl_nxpy_vvf_fused_planes(ptrdiff_t n, const float *x, ptrdiff_t x_plane,
    ptrdiff_t x_stride, float *y, ptrdiff_t y_plane, ptrdiff_t y_stride) {
  ksl_vec3f_t x_i;
  if (n > 0) x_i = ksl_vec3f_of_planes(x, x_plane);
  KSL_EACH_OF(n) {
    if (x_stride) x_i = ksl_vec3f_of_planes(x + i * x_stride, x_plane);
    ksl_vec3f_t y_i = ksl_vec3f_of_planes(y + i * y_stride, y_plane);
    ksl_nxpy_vvf_fused(&x_i, &y_i);
    ksl_vec3f_to_planes(&y_i, y + i * y_stride, y_plane);
  }
}

/* ksl_product_avf_fused of n elements. */
static KSL_INLINED void ksl_product_avf_fused_many(ptrdiff_t n, const float *a, ptrdiff_t a_stride,
    const ksl_vec3f_t *vi, ptrdiff_t vi_stride, ksl_vec3f_t *vo,
    ptrdiff_t vo_stride) {
  KSL_EACH_OF(n) {
    ksl_product_avf_fused(a[i * a_stride], vi + i * vi_stride, vo + i * vo_stride);
  }
}

static KSL_INLINED void ksl_product_avf_fused_planes(ptrdiff_t n, const float *a,
    ptrdiff_t a_stride, const float *vi, ptrdiff_t vi_plane, ptrdiff_t vi_stride,
    float *vo, ptrdiff_t vo_plane, ptrdiff_t vo_stride) {
  KSL_EACH_OF(n) {
    const ksl_vec3f_t vi_i = ksl_vec3f_of_planes(vi + i * vi_stride, vi_plane);
    ksl_vec3f_t vo_i;
    ksl_product_avf_fused(a[i * a_stride], &vi_i, &vo_i);
    ksl_vec3f_to_planes(&vo_i, vo + i * vo_stride, vo_plane);
  }
}

/* ksl_add_vvf_fused of n elements. */
static KSL_INLINED void ksl_add_vvf_fused_many(ptrdiff_t n, const ksl_vec3f_t *v1,
    ptrdiff_t v1_stride, const ksl_vec3f_t *v2, ptrdiff_t v2_stride,
    ksl_vec3f_t *vo, ptrdiff_t vo_stride) {
  KSL_EACH_OF(n) {
    ksl_add_vvf_fused(v1 + i * v1_stride, v2 + i * v2_stride, vo + i * vo_stride);
  }
}

static KSL_INLINED void ksl_add_vvf_fused_planes(ptrdiff_t n, const float *v1, ptrdiff_t v1_plane,
    ptrdiff_t v1_stride, const float *v2, ptrdiff_t v2_plane,
    ptrdiff_t v2_stride, float *vo, ptrdiff_t vo_plane, ptrdiff_t vo_stride) {
  ksl_vec3f_t v1_i;
  if (n > 0) v1_i = ksl_vec3f_of_planes(v1, v1_plane);
  KSL_EACH_OF(n) {
    if (v1_stride) v1_i = ksl_vec3f_of_planes(v1 + i * v1_stride, v1_plane);
    const ksl_vec3f_t v2_i = ksl_vec3f_of_planes(v2 + i * v2_stride, v2_plane);
    ksl_vec3f_t vo_i;
    ksl_add_vvf_fused(&v1_i, &v2_i, &vo_i);
    ksl_vec3f_to_planes(&vo_i, vo + i * vo_stride, vo_plane);
  }
}

/* ksl_subtract_vvf_fused of n elements. */
static KSL_INLINED void ksl_subtract_vvf_fused_many(ptrdiff_t n, const ksl_vec3f_t *v1,
    ptrdiff_t v1_stride, const ksl_vec3f_t *v2, ptrdiff_t v2_stride,
    ksl_vec3f_t *vo, ptrdiff_t vo_stride) {
  KSL_EACH_OF(n) {
    ksl_subtract_vvf_fused(v1 + i * v1_stride, v2 + i * v2_stride, vo + i * vo_stride);
  }
}

static KSL_INLINED void ksl_subtract_vvf_fused_planes(ptrdiff_t n, const float *v1,
    ptrdiff_t v1_plane, ptrdiff_t v1_stride, const float *v2, ptrdiff_t v2_plane,
    ptrdiff_t v2_stride, float *vo, ptrdiff_t vo_plane, ptrdiff_t vo_stride) {
  ksl_vec3f_t v1_i;
  if (n > 0) v1_i = ksl_vec3f_of_planes(v1, v1_plane);
  KSL_EACH_OF(n) {
    if (v1_stride) v1_i = ksl_vec3f_of_planes(v1 + i * v1_stride, v1_plane);
    const ksl_vec3f_t v2_i = ksl_vec3f_of_planes(v2 + i * v2_stride, v2_plane);
    ksl_vec3f_t vo_i;
    ksl_subtract_vvf_fused(&v1_i, &v2_i, &vo_i);
    ksl_vec3f_to_planes(&vo_i, vo + i * vo_stride, vo_plane);
  }
}

/* ksl_vec3f_scaled_fused of n elements. */
static KSL_INLINED void ksl_vec3f_scaled_fused_many(ptrdiff_t n, const ksl_vec3f_t *v,
    ptrdiff_t v_stride, const float *k, ptrdiff_t k_stride, ksl_vec3f_t *vo,
    ptrdiff_t vo_stride) {
  KSL_EACH_OF(n) {
    ksl_vec3f_scaled_fused(v + i * v_stride, k[i * k_stride], vo + i * vo_stride);
  }
}

static KSL_INLINED void ksl_vec3f_scaled_fused_planes(ptrdiff_t n, const float *v,
    ptrdiff_t v_plane, ptrdiff_t v_stride, const float *k, ptrdiff_t k_stride,
    float *vo, ptrdiff_t vo_plane, ptrdiff_t vo_stride) {
  ksl_vec3f_t v_i;
  if (n > 0) v_i = ksl_vec3f_of_planes(v, v_plane);
  KSL_EACH_OF(n) {
    if (v_stride) v_i = ksl_vec3f_of_planes(v + i * v_stride, v_plane);
    ksl_vec3f_t vo_i;
    ksl_vec3f_scaled_fused(&v_i, k[i * k_stride], &vo_i);
    ksl_vec3f_to_planes(&vo_i, vo + i * vo_stride, vo_plane);
  }
}

/* ksl_dot_vvf_fused of n elements. */
static KSL_INLINED void ksl_dot_vvf_fused_many(ptrdiff_t n, const ksl_vec3f_t *v1,
    ptrdiff_t v1_stride, const ksl_vec3f_t *v2, ptrdiff_t v2_stride, float *dot,
    ptrdiff_t dot_stride) {
  KSL_EACH_OF(n) {
    dot[i * dot_stride] = ksl_dot_vvf_fused(v1 + i * v1_stride, v2 + i * v2_stride);
  }
}

static KSL_INLINED void ksl_dot_vvf_fused_planes(ptrdiff_t n, const float *v1, ptrdiff_t v1_plane,
    ptrdiff_t v1_stride, const float *v2, ptrdiff_t v2_plane,
    ptrdiff_t v2_stride, float *dot, ptrdiff_t dot_stride) {
  ksl_vec3f_t v1_i;
  if (n > 0) v1_i = ksl_vec3f_of_planes(v1, v1_plane);
  KSL_EACH_OF(n) {
    if (v1_stride) v1_i = ksl_vec3f_of_planes(v1 + i * v1_stride, v1_plane);
    const ksl_vec3f_t v2_i = ksl_vec3f_of_planes(v2 + i * v2_stride, v2_plane);
    dot[i * dot_stride] = ksl_dot_vvf_fused(&v1_i, &v2_i);
  }
}

/* ksl_product_avinvf_fused of n elements. */
static KSL_INLINED void ksl_product_avinvf_fused_many(ptrdiff_t n, const float *k,
    ptrdiff_t k_stride, const ksl_vec3f_t *v, ptrdiff_t v_stride,
    ksl_vec3f_t *vo, ptrdiff_t vo_stride) {
  KSL_EACH_OF(n) {
    ksl_product_avinvf_fused(k[i * k_stride], v + i * v_stride, vo + i * vo_stride);
  }
}

static KSL_INLINED void ksl_product_avinvf_fused_planes(ptrdiff_t n, const float *k,
    ptrdiff_t k_stride, const float *v, ptrdiff_t v_plane, ptrdiff_t v_stride,
    float *vo, ptrdiff_t vo_plane, ptrdiff_t vo_stride) {
  KSL_EACH_OF(n) {
    const ksl_vec3f_t v_i = ksl_vec3f_of_planes(v + i * v_stride, v_plane);
    ksl_vec3f_t vo_i;
    ksl_product_avinvf_fused(k[i * k_stride], &v_i, &vo_i);
    ksl_vec3f_to_planes(&vo_i, vo + i * vo_stride, vo_plane);
  }
}

/* ksl_cross_vvf_fused of n elements. */
static KSL_INLINED void ksl_cross_vvf_fused_many(ptrdiff_t n, const ksl_vec3f_t *v1,
    ptrdiff_t v1_stride, const ksl_vec3f_t *v2, ptrdiff_t v2_stride,
    ksl_vec3f_t *vo, ptrdiff_t vo_stride) {
  KSL_EACH_OF(n) {
    ksl_cross_vvf_fused(v1 + i * v1_stride, v2 + i * v2_stride, vo + i * vo_stride);
  }
}

static KSL_INLINED void ksl_cross_vvf_fused_planes(ptrdiff_t n, const float *v1, ptrdiff_t v1_plane,
    ptrdiff_t v1_stride, const float *v2, ptrdiff_t v2_plane,
    ptrdiff_t v2_stride, float *vo, ptrdiff_t vo_plane, ptrdiff_t vo_stride) {
  ksl_vec3f_t v1_i;
  if (n > 0) v1_i = ksl_vec3f_of_planes(v1, v1_plane);
  KSL_EACH_OF(n) {
    if (v1_stride) v1_i = ksl_vec3f_of_planes(v1 + i * v1_stride, v1_plane);
    const ksl_vec3f_t v2_i = ksl_vec3f_of_planes(v2 + i * v2_stride, v2_plane);
    ksl_vec3f_t vo_i;
    ksl_cross_vvf_fused(&v1_i, &v2_i, &vo_i);
    ksl_vec3f_to_planes(&vo_i, vo + i * vo_stride, vo_plane);
  }
}

/* ksl_cross_vvinvf_fused of n elements. */
static KSL_INLINED void ksl_cross_vvinvf_fused_many(ptrdiff_t n, const ksl_vec3f_t *v1,
    ptrdiff_t v1_stride, const ksl_vec3f_t *v2, ptrdiff_t v2_stride,
    ksl_vec3f_t *vo, ptrdiff_t vo_stride) {
  KSL_EACH_OF(n) {
    ksl_cross_vvinvf_fused(v1 + i * v1_stride, v2 + i * v2_stride, vo + i * vo_stride);
  }
}

static KSL_INLINED void ksl_cross_vvinvf_fused_planes(ptrdiff_t n, const float *v1,
    ptrdiff_t v1_plane, ptrdiff_t v1_stride, const float *v2, ptrdiff_t v2_plane,
    ptrdiff_t v2_stride, float *vo, ptrdiff_t vo_plane, ptrdiff_t vo_stride) {
  ksl_vec3f_t v1_i;
  if (n > 0) v1_i = ksl_vec3f_of_planes(v1, v1_plane);
  KSL_EACH_OF(n) {
    if (v1_stride) v1_i = ksl_vec3f_of_planes(v1 + i * v1_stride, v1_plane);
    const ksl_vec3f_t v2_i = ksl_vec3f_of_planes(v2 + i * v2_stride, v2_plane);
    ksl_vec3f_t vo_i;
    ksl_cross_vvinvf_fused(&v1_i, &v2_i, &vo_i);
    ksl_vec3f_to_planes(&vo_i, vo + i * vo_stride, vo_plane);
  }
}

/* ksl_add_vvxf_fused of n elements. */
static KSL_INLINED void ksl_add_vvxf_fused_many(ptrdiff_t n, const ksl_vec3f_t *v,
    ptrdiff_t v_stride, const float *k, ptrdiff_t k_stride, ksl_vec3f_t *vo,
    ptrdiff_t vo_stride) {
  KSL_EACH_OF(n) {
    ksl_add_vvxf_fused(v + i * v_stride, k[i * k_stride], vo + i * vo_stride);
  }
}

static KSL_INLINED void ksl_add_vvxf_fused_planes(ptrdiff_t n, const float *v, ptrdiff_t v_plane,
    ptrdiff_t v_stride, const float *k, ptrdiff_t k_stride, float *vo,
    ptrdiff_t vo_plane, ptrdiff_t vo_stride) {
  ksl_vec3f_t v_i;
  if (n > 0) v_i = ksl_vec3f_of_planes(v, v_plane);
  KSL_EACH_OF(n) {
    if (v_stride) v_i = ksl_vec3f_of_planes(v + i * v_stride, v_plane);
    ksl_vec3f_t vo_i;
    ksl_add_vvxf_fused(&v_i, k[i * k_stride], &vo_i);
    ksl_vec3f_to_planes(&vo_i, vo + i * vo_stride, vo_plane);
  }
}

/* ksl_add_vvxinvf_fused of n elements. */
static KSL_INLINED void ksl_add_vvxinvf_fused_many(ptrdiff_t n, const ksl_vec3f_t *v,
    ptrdiff_t v_stride, const float *k, ptrdiff_t k_stride, ksl_vec3f_t *vo,
    ptrdiff_t vo_stride) {
  KSL_EACH_OF(n) {
    ksl_add_vvxinvf_fused(v + i * v_stride, k[i * k_stride], vo + i * vo_stride);
  }
}

static KSL_INLINED void ksl_add_vvxinvf_fused_planes(ptrdiff_t n, const float *v, ptrdiff_t v_plane,
    ptrdiff_t v_stride, const float *k, ptrdiff_t k_stride, float *vo,
    ptrdiff_t vo_plane, ptrdiff_t vo_stride) {
  ksl_vec3f_t v_i;
  if (n > 0) v_i = ksl_vec3f_of_planes(v, v_plane);
  KSL_EACH_OF(n) {
    if (v_stride) v_i = ksl_vec3f_of_planes(v + i * v_stride, v_plane);
    ksl_vec3f_t vo_i;
    ksl_add_vvxinvf_fused(&v_i, k[i * k_stride], &vo_i);
    ksl_vec3f_to_planes(&vo_i, vo + i * vo_stride, vo_plane);
  }
}

/* ksl_add_vvyf_fused of n elements. */
static KSL_INLINED void ksl_add_vvyf_fused_many(ptrdiff_t n, const ksl_vec3f_t *v,
    ptrdiff_t v_stride, const float *k, ptrdiff_t k_stride, ksl_vec3f_t *vo,
    ptrdiff_t vo_stride) {
  KSL_EACH_OF(n) {
    ksl_add_vvyf_fused(v + i * v_stride, k[i * k_stride], vo + i * vo_stride);
  }
}

static KSL_INLINED void ksl_add_vvyf_fused_planes(ptrdiff_t n, const float *v, ptrdiff_t v_plane,
    ptrdiff_t v_stride, const float *k, ptrdiff_t k_stride, float *vo,
    ptrdiff_t vo_plane, ptrdiff_t vo_stride) {
  ksl_vec3f_t v_i;
  if (n > 0) v_i = ksl_vec3f_of_planes(v, v_plane);
  KSL_EACH_OF(n) {
    if (v_stride) v_i = ksl_vec3f_of_planes(v + i * v_stride, v_plane);
    ksl_vec3f_t vo_i;
    ksl_add_vvyf_fused(&v_i, k[i * k_stride], &vo_i);
    ksl_vec3f_to_planes(&vo_i, vo + i * vo_stride, vo_plane);
  }
}

/* ksl_add_vvyinvf_fused of n elements. */
static KSL_INLINED void ksl_add_vvyinvf_fused_many(ptrdiff_t n, const ksl_vec3f_t *v,
    ptrdiff_t v_stride, const float *k, ptrdiff_t k_stride, ksl_vec3f_t *vo,
    ptrdiff_t vo_stride) {
  KSL_EACH_OF(n) {
    ksl_add_vvyinvf_fused(v + i * v_stride, k[i * k_stride], vo + i * vo_stride);
  }
}

static KSL_INLINED void ksl_add_vvyinvf_fused_planes(ptrdiff_t n, const float *v, ptrdiff_t v_plane,
    ptrdiff_t v_stride, const float *k, ptrdiff_t k_stride, float *vo,
    ptrdiff_t vo_plane, ptrdiff_t vo_stride) {
  ksl_vec3f_t v_i;
  if (n > 0) v_i = ksl_vec3f_of_planes(v, v_plane);
  KSL_EACH_OF(n) {
    if (v_stride) v_i = ksl_vec3f_of_planes(v + i * v_stride, v_plane);
    ksl_vec3f_t vo_i;
    ksl_add_vvyinvf_fused(&v_i, k[i * k_stride], &vo_i);
    ksl_vec3f_to_planes(&vo_i, vo + i * vo_stride, vo_plane);
  }
}

/* ksl_add_vvzf_fused of n elements. */
static KSL_INLINED void ksl_add_vvzf_fused_many(ptrdiff_t n, const ksl_vec3f_t *v,
    ptrdiff_t v_stride, const float *k, ptrdiff_t k_stride, ksl_vec3f_t *vo,
    ptrdiff_t vo_stride) {
  KSL_EACH_OF(n) {
    ksl_add_vvzf_fused(v + i * v_stride, k[i * k_stride], vo + i * vo_stride);
  }
}

static KSL_INLINED void ksl_add_vvzf_fused_planes(ptrdiff_t n, const float *v, ptrdiff_t v_plane,
    ptrdiff_t v_stride, const float *k, ptrdiff_t k_stride, float *vo,
    ptrdiff_t vo_plane, ptrdiff_t vo_stride) {
  ksl_vec3f_t v_i;
  if (n > 0) v_i = ksl_vec3f_of_planes(v, v_plane);
  KSL_EACH_OF(n) {
    if (v_stride) v_i = ksl_vec3f_of_planes(v + i * v_stride, v_plane);
    ksl_vec3f_t vo_i;
    ksl_add_vvzf_fused(&v_i, k[i * k_stride], &vo_i);
    ksl_vec3f_to_planes(&vo_i, vo + i * vo_stride, vo_plane);
  }
}

/* ksl_add_vvzinvf_fused of n elements. */
static KSL_INLINED void ksl_add_vvzinvf_fused_many(ptrdiff_t n, const ksl_vec3f_t *v,
    ptrdiff_t v_stride, const float *k, ptrdiff_t k_stride, ksl_vec3f_t *vo,
    ptrdiff_t vo_stride) {
  KSL_EACH_OF(n) {
    ksl_add_vvzinvf_fused(v + i * v_stride, k[i * k_stride], vo + i * vo_stride);
  }
}

static KSL_INLINED void ksl_add_vvzinvf_fused_planes(ptrdiff_t n, const float *v, ptrdiff_t v_plane,
    ptrdiff_t v_stride, const float *k, ptrdiff_t k_stride, float *vo,
    ptrdiff_t vo_plane, ptrdiff_t vo_stride) {
  ksl_vec3f_t v_i;
  if (n > 0) v_i = ksl_vec3f_of_planes(v, v_plane);
  KSL_EACH_OF(n) {
    if (v_stride) v_i = ksl_vec3f_of_planes(v + i * v_stride, v_plane);
    ksl_vec3f_t vo_i;
    ksl_add_vvzinvf_fused(&v_i, k[i * k_stride], &vo_i);
    ksl_vec3f_to_planes(&vo_i, vo + i * vo_stride, vo_plane);
  }
}

#endif
