/* Made by `coscrew generate`; changes are overwritten. */
/* SPDX-License-Identifier: MIT */
/* coscrew 0.2.0.  Copyright (c) 2026 The coscrew authors. */
/* Vectors of three components.  Many at a time.
   What arguments are, and what loops over them cost, ksl_planes.h says. */
#ifndef KSL_VEC3_ACCURATE_MANY_H
#define KSL_VEC3_ACCURATE_MANY_H

#include "vec3_accurate.h"
#include "ksl_planes.h"

/* ksl_vec3_scale_accurate of n elements. */
static KSL_INLINED void ksl_vec3_scale_accurate_many(ptrdiff_t n, ksl_vec3_t *self,
    ptrdiff_t self_stride, const double *a, ptrdiff_t a_stride) {
  KSL_EACH_OF(n) {
    ksl_vec3_scale_accurate(self + i * self_stride, a[i * a_stride]);
  }
}

static KSL_INLINED void ksl_vec3_scale_accurate_planes(ptrdiff_t n, double *self,
    ptrdiff_t self_plane, ptrdiff_t self_stride, const double *a,
    ptrdiff_t a_stride) {
  KSL_EACH_OF(n) {
    ksl_vec3_t self_i = ksl_vec3_of_planes(self + i * self_stride, self_plane);
    ksl_vec3_scale_accurate(&self_i, a[i * a_stride]);
    ksl_vec3_to_planes(&self_i, self + i * self_stride, self_plane);
  }
}

/* ksl_axpy_vv_accurate of n elements. */
static KSL_INLINED void ksl_axpy_vv_accurate_many(ptrdiff_t n, const double *a, ptrdiff_t a_stride,
    const ksl_vec3_t *x, ptrdiff_t x_stride, ksl_vec3_t *y, ptrdiff_t y_stride) {
  KSL_EACH_OF(n) {
    ksl_axpy_vv_accurate(a[i * a_stride], x + i * x_stride, y + i * y_stride);
  }
}

static KSL_INLINED void ksl_axpy_vv_accurate_planes(ptrdiff_t n, const double *a,
    ptrdiff_t a_stride, const double *x, ptrdiff_t x_plane, ptrdiff_t x_stride,
    double *y, ptrdiff_t y_plane, ptrdiff_t y_stride) {
  KSL_EACH_OF(n) {
    const ksl_vec3_t x_i = ksl_vec3_of_planes(x + i * x_stride, x_plane);
    ksl_vec3_t y_i = ksl_vec3_of_planes(y + i * y_stride, y_plane);
    ksl_axpy_vv_accurate(a[i * a_stride], &x_i, &y_i);
    ksl_vec3_to_planes(&y_i, y + i * y_stride, y_plane);
  }
}

/* ksl_xpy_vv_accurate of n elements. */
static KSL_INLINED void ksl_xpy_vv_accurate_many(ptrdiff_t n, const ksl_vec3_t *x,
    ptrdiff_t x_stride, ksl_vec3_t *y, ptrdiff_t y_stride) {
  KSL_EACH_OF(n) {
    ksl_xpy_vv_accurate(x + i * x_stride, y + i * y_stride);
  }
}

static KSL_INLINED void ksl_xpy_vv_accurate_planes(ptrdiff_t n, const double *x, ptrdiff_t x_plane,
    ptrdiff_t x_stride, double *y, ptrdiff_t y_plane, ptrdiff_t y_stride) {
  ksl_vec3_t x_i;
  if (n > 0) x_i = ksl_vec3_of_planes(x, x_plane);
  KSL_EACH_OF(n) {
    if (x_stride) x_i = ksl_vec3_of_planes(x + i * x_stride, x_plane);
    ksl_vec3_t y_i = ksl_vec3_of_planes(y + i * y_stride, y_plane);
    ksl_xpy_vv_accurate(&x_i, &y_i);
    ksl_vec3_to_planes(&y_i, y + i * y_stride, y_plane);
  }
}

/* ksl_nxpy_vv_accurate of n elements. */
static KSL_INLINED void ksl_nxpy_vv_accurate_many(ptrdiff_t n, const ksl_vec3_t *x,
    ptrdiff_t x_stride, ksl_vec3_t *y, ptrdiff_t y_stride) {
  KSL_EACH_OF(n) {
    ksl_nxpy_vv_accurate(x + i * x_stride, y + i * y_stride);
  }
}

static KSL_INLINED void ksl_nxpy_vv_accurate_planes(ptrdiff_t n, const double *x, ptrdiff_t x_plane,
    ptrdiff_t x_stride, double *y, ptrdiff_t y_plane, ptrdiff_t y_stride) {
  ksl_vec3_t x_i;
  if (n > 0) x_i = ksl_vec3_of_planes(x, x_plane);
  KSL_EACH_OF(n) {
    if (x_stride) x_i = ksl_vec3_of_planes(x + i * x_stride, x_plane);
    ksl_vec3_t y_i = ksl_vec3_of_planes(y + i * y_stride, y_plane);
    ksl_nxpy_vv_accurate(&x_i, &y_i);
    ksl_vec3_to_planes(&y_i, y + i * y_stride, y_plane);
  }
}

/* ksl_product_av_accurate of n elements. */
static KSL_INLINED void ksl_product_av_accurate_many(ptrdiff_t n, const double *a,
    ptrdiff_t a_stride, const ksl_vec3_t *vi, ptrdiff_t vi_stride,
    ksl_vec3_t *vo, ptrdiff_t vo_stride) {
  KSL_EACH_OF(n) {
    ksl_product_av_accurate(a[i * a_stride], vi + i * vi_stride, vo + i * vo_stride);
  }
}

static KSL_INLINED void ksl_product_av_accurate_planes(ptrdiff_t n, const double *a,
    ptrdiff_t a_stride, const double *vi, ptrdiff_t vi_plane,
    ptrdiff_t vi_stride, double *vo, ptrdiff_t vo_plane, ptrdiff_t vo_stride) {
  KSL_EACH_OF(n) {
    const ksl_vec3_t vi_i = ksl_vec3_of_planes(vi + i * vi_stride, vi_plane);
    ksl_vec3_t vo_i;
    ksl_product_av_accurate(a[i * a_stride], &vi_i, &vo_i);
    ksl_vec3_to_planes(&vo_i, vo + i * vo_stride, vo_plane);
  }
}

/* ksl_add_vv_accurate of n elements. */
static KSL_INLINED void ksl_add_vv_accurate_many(ptrdiff_t n, const ksl_vec3_t *v1,
    ptrdiff_t v1_stride, const ksl_vec3_t *v2, ptrdiff_t v2_stride,
    ksl_vec3_t *vo, ptrdiff_t vo_stride) {
  KSL_EACH_OF(n) {
    ksl_add_vv_accurate(v1 + i * v1_stride, v2 + i * v2_stride, vo + i * vo_stride);
  }
}

static KSL_INLINED void ksl_add_vv_accurate_planes(ptrdiff_t n, const double *v1,
    ptrdiff_t v1_plane, ptrdiff_t v1_stride, const double *v2,
    ptrdiff_t v2_plane, ptrdiff_t v2_stride, double *vo, ptrdiff_t vo_plane,
    ptrdiff_t vo_stride) {
  ksl_vec3_t v1_i;
  if (n > 0) v1_i = ksl_vec3_of_planes(v1, v1_plane);
  KSL_EACH_OF(n) {
    if (v1_stride) v1_i = ksl_vec3_of_planes(v1 + i * v1_stride, v1_plane);
    const ksl_vec3_t v2_i = ksl_vec3_of_planes(v2 + i * v2_stride, v2_plane);
    ksl_vec3_t vo_i;
    ksl_add_vv_accurate(&v1_i, &v2_i, &vo_i);
    ksl_vec3_to_planes(&vo_i, vo + i * vo_stride, vo_plane);
  }
}

/* ksl_subtract_vv_accurate of n elements. */
static KSL_INLINED void ksl_subtract_vv_accurate_many(ptrdiff_t n, const ksl_vec3_t *v1,
    ptrdiff_t v1_stride, const ksl_vec3_t *v2, ptrdiff_t v2_stride,
    ksl_vec3_t *vo, ptrdiff_t vo_stride) {
  KSL_EACH_OF(n) {
    ksl_subtract_vv_accurate(v1 + i * v1_stride, v2 + i * v2_stride, vo + i * vo_stride);
  }
}

static KSL_INLINED void ksl_subtract_vv_accurate_planes(ptrdiff_t n, const double *v1,
    ptrdiff_t v1_plane, ptrdiff_t v1_stride, const double *v2,
    ptrdiff_t v2_plane, ptrdiff_t v2_stride, double *vo, ptrdiff_t vo_plane,
    ptrdiff_t vo_stride) {
  ksl_vec3_t v1_i;
  if (n > 0) v1_i = ksl_vec3_of_planes(v1, v1_plane);
  KSL_EACH_OF(n) {
    if (v1_stride) v1_i = ksl_vec3_of_planes(v1 + i * v1_stride, v1_plane);
    const ksl_vec3_t v2_i = ksl_vec3_of_planes(v2 + i * v2_stride, v2_plane);
    ksl_vec3_t vo_i;
    ksl_subtract_vv_accurate(&v1_i, &v2_i, &vo_i);
    ksl_vec3_to_planes(&vo_i, vo + i * vo_stride, vo_plane);
  }
}

/* ksl_vec3_scaled_accurate of n elements. */
static KSL_INLINED void ksl_vec3_scaled_accurate_many(ptrdiff_t n, const ksl_vec3_t *v,
    ptrdiff_t v_stride, const double *k, ptrdiff_t k_stride, ksl_vec3_t *vo,
    ptrdiff_t vo_stride) {
  KSL_EACH_OF(n) {
    ksl_vec3_scaled_accurate(v + i * v_stride, k[i * k_stride], vo + i * vo_stride);
  }
}

static KSL_INLINED void ksl_vec3_scaled_accurate_planes(ptrdiff_t n, const double *v,
    ptrdiff_t v_plane, ptrdiff_t v_stride, const double *k, ptrdiff_t k_stride,
    double *vo, ptrdiff_t vo_plane, ptrdiff_t vo_stride) {
  ksl_vec3_t v_i;
  if (n > 0) v_i = ksl_vec3_of_planes(v, v_plane);
  KSL_EACH_OF(n) {
    if (v_stride) v_i = ksl_vec3_of_planes(v + i * v_stride, v_plane);
    ksl_vec3_t vo_i;
    ksl_vec3_scaled_accurate(&v_i, k[i * k_stride], &vo_i);
    ksl_vec3_to_planes(&vo_i, vo + i * vo_stride, vo_plane);
  }
}

/* ksl_vec3_l2norm_accurate of n elements. */
static KSL_INLINED void ksl_vec3_l2norm_accurate_many(ptrdiff_t n, const ksl_vec3_t *v,
    ptrdiff_t v_stride, double *norm, ptrdiff_t norm_stride) {
  KSL_EACH_OF(n) {
    norm[i * norm_stride] = ksl_vec3_l2norm_accurate(v + i * v_stride);
  }
}

static KSL_INLINED void ksl_vec3_l2norm_accurate_planes(ptrdiff_t n, const double *v,
    ptrdiff_t v_plane, ptrdiff_t v_stride, double *norm, ptrdiff_t norm_stride) {
  ksl_vec3_t v_i;
  if (n > 0) v_i = ksl_vec3_of_planes(v, v_plane);
  KSL_EACH_OF(n) {
    if (v_stride) v_i = ksl_vec3_of_planes(v + i * v_stride, v_plane);
    norm[i * norm_stride] = ksl_vec3_l2norm_accurate(&v_i);
  }
}

/* ksl_vec3_normalize_accurate of n elements. */
static KSL_INLINED void ksl_vec3_normalize_accurate_many(ptrdiff_t n, ksl_vec3_t *self,
    ptrdiff_t self_stride) {
  KSL_EACH_OF(n) {
    ksl_vec3_normalize_accurate(self + i * self_stride);
  }
}

static KSL_INLINED void ksl_vec3_normalize_accurate_planes(ptrdiff_t n, double *self,
    ptrdiff_t self_plane, ptrdiff_t self_stride) {
  KSL_EACH_OF(n) {
    ksl_vec3_t self_i = ksl_vec3_of_planes(self + i * self_stride, self_plane);
    ksl_vec3_normalize_accurate(&self_i);
    ksl_vec3_to_planes(&self_i, self + i * self_stride, self_plane);
  }
}

/* ksl_vec3_normalized_accurate of n elements. */
static KSL_INLINED void ksl_vec3_normalized_accurate_many(ptrdiff_t n, const ksl_vec3_t *v,
    ptrdiff_t v_stride, ksl_vec3_t *vo, ptrdiff_t vo_stride) {
  KSL_EACH_OF(n) {
    ksl_vec3_normalized_accurate(v + i * v_stride, vo + i * vo_stride);
  }
}

static KSL_INLINED void ksl_vec3_normalized_accurate_planes(ptrdiff_t n, const double *v,
    ptrdiff_t v_plane, ptrdiff_t v_stride, double *vo, ptrdiff_t vo_plane,
    ptrdiff_t vo_stride) {
  ksl_vec3_t v_i;
  if (n > 0) v_i = ksl_vec3_of_planes(v, v_plane);
  KSL_EACH_OF(n) {
    if (v_stride) v_i = ksl_vec3_of_planes(v + i * v_stride, v_plane);
    ksl_vec3_t vo_i;
    ksl_vec3_normalized_accurate(&v_i, &vo_i);
    ksl_vec3_to_planes(&vo_i, vo + i * vo_stride, vo_plane);
  }
}

/* ksl_angle_vv_accurate of n elements. */
static KSL_INLINED void ksl_angle_vv_accurate_many(ptrdiff_t n, const ksl_vec3_t *v1,
    ptrdiff_t v1_stride, const ksl_vec3_t *v2, ptrdiff_t v2_stride,
    double *angle, ptrdiff_t angle_stride) {
  KSL_EACH_OF(n) {
    angle[i * angle_stride] = ksl_angle_vv_accurate(v1 + i * v1_stride, v2 + i * v2_stride);
  }
}

static KSL_INLINED void ksl_angle_vv_accurate_planes(ptrdiff_t n, const double *v1,
    ptrdiff_t v1_plane, ptrdiff_t v1_stride, const double *v2,
    ptrdiff_t v2_plane, ptrdiff_t v2_stride, double *angle,
    ptrdiff_t angle_stride) {
  ksl_vec3_t v1_i;
  if (n > 0) v1_i = ksl_vec3_of_planes(v1, v1_plane);
  KSL_EACH_OF(n) {
    if (v1_stride) v1_i = ksl_vec3_of_planes(v1 + i * v1_stride, v1_plane);
    const ksl_vec3_t v2_i = ksl_vec3_of_planes(v2 + i * v2_stride, v2_plane);
    angle[i * angle_stride] = ksl_angle_vv_accurate(&v1_i, &v2_i);
  }
}

/* ksl_dot_vv_accurate of n elements. */
static KSL_INLINED void ksl_dot_vv_accurate_many(ptrdiff_t n, const ksl_vec3_t *v1,
    ptrdiff_t v1_stride, const ksl_vec3_t *v2, ptrdiff_t v2_stride, double *dot,
    ptrdiff_t dot_stride) {
  KSL_EACH_OF(n) {
    dot[i * dot_stride] = ksl_dot_vv_accurate(v1 + i * v1_stride, v2 + i * v2_stride);
  }
}

static KSL_INLINED void ksl_dot_vv_accurate_planes(ptrdiff_t n, const double *v1,
    ptrdiff_t v1_plane, ptrdiff_t v1_stride, const double *v2,
    ptrdiff_t v2_plane, ptrdiff_t v2_stride, double *dot, ptrdiff_t dot_stride) {
  ksl_vec3_t v1_i;
  if (n > 0) v1_i = ksl_vec3_of_planes(v1, v1_plane);
  KSL_EACH_OF(n) {
    if (v1_stride) v1_i = ksl_vec3_of_planes(v1 + i * v1_stride, v1_plane);
    const ksl_vec3_t v2_i = ksl_vec3_of_planes(v2 + i * v2_stride, v2_plane);
    dot[i * dot_stride] = ksl_dot_vv_accurate(&v1_i, &v2_i);
  }
}

/* ksl_product_avinv_accurate of n elements. */
static KSL_INLINED void ksl_product_avinv_accurate_many(ptrdiff_t n, const double *k,
    ptrdiff_t k_stride, const ksl_vec3_t *v, ptrdiff_t v_stride, ksl_vec3_t *vo,
    ptrdiff_t vo_stride) {
  KSL_EACH_OF(n) {
    ksl_product_avinv_accurate(k[i * k_stride], v + i * v_stride, vo + i * vo_stride);
  }
}

static KSL_INLINED void ksl_product_avinv_accurate_planes(ptrdiff_t n, const double *k,
    ptrdiff_t k_stride, const double *v, ptrdiff_t v_plane, ptrdiff_t v_stride,
    double *vo, ptrdiff_t vo_plane, ptrdiff_t vo_stride) {
  KSL_EACH_OF(n) {
    const ksl_vec3_t v_i = ksl_vec3_of_planes(v + i * v_stride, v_plane);
    ksl_vec3_t vo_i;
    ksl_product_avinv_accurate(k[i * k_stride], &v_i, &vo_i);
    ksl_vec3_to_planes(&vo_i, vo + i * vo_stride, vo_plane);
  }
}

/* ksl_product_ainvv_accurate of n elements. */
static KSL_INLINED void ksl_product_ainvv_accurate_many(ptrdiff_t n, const double *k,
    ptrdiff_t k_stride, const ksl_vec3_t *v, ptrdiff_t v_stride, ksl_vec3_t *vo,
    ptrdiff_t vo_stride) {
  KSL_EACH_OF(n) {
    ksl_product_ainvv_accurate(k[i * k_stride], v + i * v_stride, vo + i * vo_stride);
  }
}

static KSL_INLINED void ksl_product_ainvv_accurate_planes(ptrdiff_t n, const double *k,
    ptrdiff_t k_stride, const double *v, ptrdiff_t v_plane, ptrdiff_t v_stride,
    double *vo, ptrdiff_t vo_plane, ptrdiff_t vo_stride) {
  KSL_EACH_OF(n) {
    const ksl_vec3_t v_i = ksl_vec3_of_planes(v + i * v_stride, v_plane);
    ksl_vec3_t vo_i;
    ksl_product_ainvv_accurate(k[i * k_stride], &v_i, &vo_i);
    ksl_vec3_to_planes(&vo_i, vo + i * vo_stride, vo_plane);
  }
}

/* ksl_cross_vv_accurate of n elements. */
static KSL_INLINED void ksl_cross_vv_accurate_many(ptrdiff_t n, const ksl_vec3_t *v1,
    ptrdiff_t v1_stride, const ksl_vec3_t *v2, ptrdiff_t v2_stride,
    ksl_vec3_t *vo, ptrdiff_t vo_stride) {
  KSL_EACH_OF(n) {
    ksl_cross_vv_accurate(v1 + i * v1_stride, v2 + i * v2_stride, vo + i * vo_stride);
  }
}

static KSL_INLINED void ksl_cross_vv_accurate_planes(ptrdiff_t n, const double *v1,
    ptrdiff_t v1_plane, ptrdiff_t v1_stride, const double *v2,
    ptrdiff_t v2_plane, ptrdiff_t v2_stride, double *vo, ptrdiff_t vo_plane,
    ptrdiff_t vo_stride) {
  ksl_vec3_t v1_i;
  if (n > 0) v1_i = ksl_vec3_of_planes(v1, v1_plane);
  KSL_EACH_OF(n) {
    if (v1_stride) v1_i = ksl_vec3_of_planes(v1 + i * v1_stride, v1_plane);
    const ksl_vec3_t v2_i = ksl_vec3_of_planes(v2 + i * v2_stride, v2_plane);
    ksl_vec3_t vo_i;
    ksl_cross_vv_accurate(&v1_i, &v2_i, &vo_i);
    ksl_vec3_to_planes(&vo_i, vo + i * vo_stride, vo_plane);
  }
}

/* ksl_cross_vvinv_accurate of n elements. */
static KSL_INLINED void ksl_cross_vvinv_accurate_many(ptrdiff_t n, const ksl_vec3_t *v1,
    ptrdiff_t v1_stride, const ksl_vec3_t *v2, ptrdiff_t v2_stride,
    ksl_vec3_t *vo, ptrdiff_t vo_stride) {
  KSL_EACH_OF(n) {
    ksl_cross_vvinv_accurate(v1 + i * v1_stride, v2 + i * v2_stride, vo + i * vo_stride);
  }
}

static KSL_INLINED void ksl_cross_vvinv_accurate_planes(ptrdiff_t n, const double *v1,
    ptrdiff_t v1_plane, ptrdiff_t v1_stride, const double *v2,
    ptrdiff_t v2_plane, ptrdiff_t v2_stride, double *vo, ptrdiff_t vo_plane,
    ptrdiff_t vo_stride) {
  ksl_vec3_t v1_i;
  if (n > 0) v1_i = ksl_vec3_of_planes(v1, v1_plane);
  KSL_EACH_OF(n) {
    if (v1_stride) v1_i = ksl_vec3_of_planes(v1 + i * v1_stride, v1_plane);
    const ksl_vec3_t v2_i = ksl_vec3_of_planes(v2 + i * v2_stride, v2_plane);
    ksl_vec3_t vo_i;
    ksl_cross_vvinv_accurate(&v1_i, &v2_i, &vo_i);
    ksl_vec3_to_planes(&vo_i, vo + i * vo_stride, vo_plane);
  }
}

/* ksl_add_vvx_accurate of n elements. */
static KSL_INLINED void ksl_add_vvx_accurate_many(ptrdiff_t n, const ksl_vec3_t *v,
    ptrdiff_t v_stride, const double *k, ptrdiff_t k_stride, ksl_vec3_t *vo,
    ptrdiff_t vo_stride) {
  KSL_EACH_OF(n) {
    ksl_add_vvx_accurate(v + i * v_stride, k[i * k_stride], vo + i * vo_stride);
  }
}

static KSL_INLINED void ksl_add_vvx_accurate_planes(ptrdiff_t n, const double *v, ptrdiff_t v_plane,
    ptrdiff_t v_stride, const double *k, ptrdiff_t k_stride, double *vo,
    ptrdiff_t vo_plane, ptrdiff_t vo_stride) {
  ksl_vec3_t v_i;
  if (n > 0) v_i = ksl_vec3_of_planes(v, v_plane);
  KSL_EACH_OF(n) {
    if (v_stride) v_i = ksl_vec3_of_planes(v + i * v_stride, v_plane);
    ksl_vec3_t vo_i;
    ksl_add_vvx_accurate(&v_i, k[i * k_stride], &vo_i);
    ksl_vec3_to_planes(&vo_i, vo + i * vo_stride, vo_plane);
  }
}

/* ksl_add_vvxinv_accurate of n elements. */
static KSL_INLINED void ksl_add_vvxinv_accurate_many(ptrdiff_t n, const ksl_vec3_t *v,
    ptrdiff_t v_stride, const double *k, ptrdiff_t k_stride, ksl_vec3_t *vo,
    ptrdiff_t vo_stride) {
  KSL_EACH_OF(n) {
    ksl_add_vvxinv_accurate(v + i * v_stride, k[i * k_stride], vo + i * vo_stride);
  }
}

static KSL_INLINED void ksl_add_vvxinv_accurate_planes(ptrdiff_t n, const double *v,
    ptrdiff_t v_plane, ptrdiff_t v_stride, const double *k, ptrdiff_t k_stride,
    double *vo, ptrdiff_t vo_plane, ptrdiff_t vo_stride) {
  ksl_vec3_t v_i;
  if (n > 0) v_i = ksl_vec3_of_planes(v, v_plane);
  KSL_EACH_OF(n) {
    if (v_stride) v_i = ksl_vec3_of_planes(v + i * v_stride, v_plane);
    ksl_vec3_t vo_i;
    ksl_add_vvxinv_accurate(&v_i, k[i * k_stride], &vo_i);
    ksl_vec3_to_planes(&vo_i, vo + i * vo_stride, vo_plane);
  }
}

/* ksl_add_vvy_accurate of n elements. */
static KSL_INLINED void ksl_add_vvy_accurate_many(ptrdiff_t n, const ksl_vec3_t *v,
    ptrdiff_t v_stride, const double *k, ptrdiff_t k_stride, ksl_vec3_t *vo,
    ptrdiff_t vo_stride) {
  KSL_EACH_OF(n) {
    ksl_add_vvy_accurate(v + i * v_stride, k[i * k_stride], vo + i * vo_stride);
  }
}

static KSL_INLINED void ksl_add_vvy_accurate_planes(ptrdiff_t n, const double *v, ptrdiff_t v_plane,
    ptrdiff_t v_stride, const double *k, ptrdiff_t k_stride, double *vo,
    ptrdiff_t vo_plane, ptrdiff_t vo_stride) {
  ksl_vec3_t v_i;
  if (n > 0) v_i = ksl_vec3_of_planes(v, v_plane);
  KSL_EACH_OF(n) {
    if (v_stride) v_i = ksl_vec3_of_planes(v + i * v_stride, v_plane);
    ksl_vec3_t vo_i;
    ksl_add_vvy_accurate(&v_i, k[i * k_stride], &vo_i);
    ksl_vec3_to_planes(&vo_i, vo + i * vo_stride, vo_plane);
  }
}

/* ksl_add_vvyinv_accurate of n elements. */
static KSL_INLINED void ksl_add_vvyinv_accurate_many(ptrdiff_t n, const ksl_vec3_t *v,
    ptrdiff_t v_stride, const double *k, ptrdiff_t k_stride, ksl_vec3_t *vo,
    ptrdiff_t vo_stride) {
  KSL_EACH_OF(n) {
    ksl_add_vvyinv_accurate(v + i * v_stride, k[i * k_stride], vo + i * vo_stride);
  }
}

static KSL_INLINED void ksl_add_vvyinv_accurate_planes(ptrdiff_t n, const double *v,
    ptrdiff_t v_plane, ptrdiff_t v_stride, const double *k, ptrdiff_t k_stride,
    double *vo, ptrdiff_t vo_plane, ptrdiff_t vo_stride) {
  ksl_vec3_t v_i;
  if (n > 0) v_i = ksl_vec3_of_planes(v, v_plane);
  KSL_EACH_OF(n) {
    if (v_stride) v_i = ksl_vec3_of_planes(v + i * v_stride, v_plane);
    ksl_vec3_t vo_i;
    ksl_add_vvyinv_accurate(&v_i, k[i * k_stride], &vo_i);
    ksl_vec3_to_planes(&vo_i, vo + i * vo_stride, vo_plane);
  }
}

/* ksl_add_vvz_accurate of n elements. */
static KSL_INLINED void ksl_add_vvz_accurate_many(ptrdiff_t n, const ksl_vec3_t *v,
    ptrdiff_t v_stride, const double *k, ptrdiff_t k_stride, ksl_vec3_t *vo,
    ptrdiff_t vo_stride) {
  KSL_EACH_OF(n) {
    ksl_add_vvz_accurate(v + i * v_stride, k[i * k_stride], vo + i * vo_stride);
  }
}

static KSL_INLINED void ksl_add_vvz_accurate_planes(ptrdiff_t n, const double *v, ptrdiff_t v_plane,
    ptrdiff_t v_stride, const double *k, ptrdiff_t k_stride, double *vo,
    ptrdiff_t vo_plane, ptrdiff_t vo_stride) {
  ksl_vec3_t v_i;
  if (n > 0) v_i = ksl_vec3_of_planes(v, v_plane);
  KSL_EACH_OF(n) {
    if (v_stride) v_i = ksl_vec3_of_planes(v + i * v_stride, v_plane);
    ksl_vec3_t vo_i;
    ksl_add_vvz_accurate(&v_i, k[i * k_stride], &vo_i);
    ksl_vec3_to_planes(&vo_i, vo + i * vo_stride, vo_plane);
  }
}

/* ksl_add_vvzinv_accurate of n elements. */
static KSL_INLINED void ksl_add_vvzinv_accurate_many(ptrdiff_t n, const ksl_vec3_t *v,
    ptrdiff_t v_stride, const double *k, ptrdiff_t k_stride, ksl_vec3_t *vo,
    ptrdiff_t vo_stride) {
  KSL_EACH_OF(n) {
    ksl_add_vvzinv_accurate(v + i * v_stride, k[i * k_stride], vo + i * vo_stride);
  }
}

static KSL_INLINED void ksl_add_vvzinv_accurate_planes(ptrdiff_t n, const double *v,
    ptrdiff_t v_plane, ptrdiff_t v_stride, const double *k, ptrdiff_t k_stride,
    double *vo, ptrdiff_t vo_plane, ptrdiff_t vo_stride) {
  ksl_vec3_t v_i;
  if (n > 0) v_i = ksl_vec3_of_planes(v, v_plane);
  KSL_EACH_OF(n) {
    if (v_stride) v_i = ksl_vec3_of_planes(v + i * v_stride, v_plane);
    ksl_vec3_t vo_i;
    ksl_add_vvzinv_accurate(&v_i, k[i * k_stride], &vo_i);
    ksl_vec3_to_planes(&vo_i, vo + i * vo_stride, vo_plane);
  }
}

/* ksl_vec3f_scale_accurate of n elements. */
static KSL_INLINED void ksl_vec3f_scale_accurate_many(ptrdiff_t n, ksl_vec3f_t *self,
    ptrdiff_t self_stride, const float *a, ptrdiff_t a_stride) {
  KSL_EACH_OF(n) {
    ksl_vec3f_scale_accurate(self + i * self_stride, a[i * a_stride]);
  }
}

static KSL_INLINED void ksl_vec3f_scale_accurate_planes(ptrdiff_t n, float *self,
    ptrdiff_t self_plane, ptrdiff_t self_stride, const float *a,
    ptrdiff_t a_stride) {
  KSL_EACH_OF(n) {
    ksl_vec3f_t self_i = ksl_vec3f_of_planes(self + i * self_stride, self_plane);
    ksl_vec3f_scale_accurate(&self_i, a[i * a_stride]);
    ksl_vec3f_to_planes(&self_i, self + i * self_stride, self_plane);
  }
}

/* ksl_axpy_vvf_accurate of n elements. */
static KSL_INLINED void ksl_axpy_vvf_accurate_many(ptrdiff_t n, const float *a, ptrdiff_t a_stride,
    const ksl_vec3f_t *x, ptrdiff_t x_stride, ksl_vec3f_t *y, ptrdiff_t y_stride) {
  KSL_EACH_OF(n) {
    ksl_axpy_vvf_accurate(a[i * a_stride], x + i * x_stride, y + i * y_stride);
  }
}

static KSL_INLINED void ksl_axpy_vvf_accurate_planes(ptrdiff_t n, const float *a,
    ptrdiff_t a_stride, const float *x, ptrdiff_t x_plane, ptrdiff_t x_stride,
    float *y, ptrdiff_t y_plane, ptrdiff_t y_stride) {
  KSL_EACH_OF(n) {
    const ksl_vec3f_t x_i = ksl_vec3f_of_planes(x + i * x_stride, x_plane);
    ksl_vec3f_t y_i = ksl_vec3f_of_planes(y + i * y_stride, y_plane);
    ksl_axpy_vvf_accurate(a[i * a_stride], &x_i, &y_i);
    ksl_vec3f_to_planes(&y_i, y + i * y_stride, y_plane);
  }
}

/* ksl_xpy_vvf_accurate of n elements. */
static KSL_INLINED void ksl_xpy_vvf_accurate_many(ptrdiff_t n, const ksl_vec3f_t *x,
    ptrdiff_t x_stride, ksl_vec3f_t *y, ptrdiff_t y_stride) {
  KSL_EACH_OF(n) {
    ksl_xpy_vvf_accurate(x + i * x_stride, y + i * y_stride);
  }
}

static KSL_INLINED void ksl_xpy_vvf_accurate_planes(ptrdiff_t n, const float *x, ptrdiff_t x_plane,
    ptrdiff_t x_stride, float *y, ptrdiff_t y_plane, ptrdiff_t y_stride) {
  ksl_vec3f_t x_i;
  if (n > 0) x_i = ksl_vec3f_of_planes(x, x_plane);
  KSL_EACH_OF(n) {
    if (x_stride) x_i = ksl_vec3f_of_planes(x + i * x_stride, x_plane);
    ksl_vec3f_t y_i = ksl_vec3f_of_planes(y + i * y_stride, y_plane);
    ksl_xpy_vvf_accurate(&x_i, &y_i);
    ksl_vec3f_to_planes(&y_i, y + i * y_stride, y_plane);
  }
}

/* ksl_nxpy_vvf_accurate of n elements. */
static KSL_INLINED void ksl_nxpy_vvf_accurate_many(ptrdiff_t n, const ksl_vec3f_t *x,
    ptrdiff_t x_stride, ksl_vec3f_t *y, ptrdiff_t y_stride) {
  KSL_EACH_OF(n) {
    ksl_nxpy_vvf_accurate(x + i * x_stride, y + i * y_stride);
  }
}

static KSL_INLINED void ksl_nxpy_vvf_accurate_planes(ptrdiff_t n, const float *x, ptrdiff_t x_plane,
    ptrdiff_t x_stride, float *y, ptrdiff_t y_plane, ptrdiff_t y_stride) {
  ksl_vec3f_t x_i;
  if (n > 0) x_i = ksl_vec3f_of_planes(x, x_plane);
  KSL_EACH_OF(n) {
    if (x_stride) x_i = ksl_vec3f_of_planes(x + i * x_stride, x_plane);
    ksl_vec3f_t y_i = ksl_vec3f_of_planes(y + i * y_stride, y_plane);
    ksl_nxpy_vvf_accurate(&x_i, &y_i);
    ksl_vec3f_to_planes(&y_i, y + i * y_stride, y_plane);
  }
}

/* ksl_product_avf_accurate of n elements. */
static KSL_INLINED void ksl_product_avf_accurate_many(ptrdiff_t n, const float *a,
    ptrdiff_t a_stride, const ksl_vec3f_t *vi, ptrdiff_t vi_stride,
    ksl_vec3f_t *vo, ptrdiff_t vo_stride) {
  KSL_EACH_OF(n) {
    ksl_product_avf_accurate(a[i * a_stride], vi + i * vi_stride, vo + i * vo_stride);
  }
}

static KSL_INLINED void ksl_product_avf_accurate_planes(ptrdiff_t n, const float *a,
    ptrdiff_t a_stride, const float *vi, ptrdiff_t vi_plane, ptrdiff_t vi_stride,
    float *vo, ptrdiff_t vo_plane, ptrdiff_t vo_stride) {
  KSL_EACH_OF(n) {
    const ksl_vec3f_t vi_i = ksl_vec3f_of_planes(vi + i * vi_stride, vi_plane);
    ksl_vec3f_t vo_i;
    ksl_product_avf_accurate(a[i * a_stride], &vi_i, &vo_i);
    ksl_vec3f_to_planes(&vo_i, vo + i * vo_stride, vo_plane);
  }
}

/* ksl_add_vvf_accurate of n elements. */
static KSL_INLINED void ksl_add_vvf_accurate_many(ptrdiff_t n, const ksl_vec3f_t *v1,
    ptrdiff_t v1_stride, const ksl_vec3f_t *v2, ptrdiff_t v2_stride,
    ksl_vec3f_t *vo, ptrdiff_t vo_stride) {
  KSL_EACH_OF(n) {
    ksl_add_vvf_accurate(v1 + i * v1_stride, v2 + i * v2_stride, vo + i * vo_stride);
  }
}

static KSL_INLINED void ksl_add_vvf_accurate_planes(ptrdiff_t n, const float *v1,
    ptrdiff_t v1_plane, ptrdiff_t v1_stride, const float *v2, ptrdiff_t v2_plane,
    ptrdiff_t v2_stride, float *vo, ptrdiff_t vo_plane, ptrdiff_t vo_stride) {
  ksl_vec3f_t v1_i;
  if (n > 0) v1_i = ksl_vec3f_of_planes(v1, v1_plane);
  KSL_EACH_OF(n) {
    if (v1_stride) v1_i = ksl_vec3f_of_planes(v1 + i * v1_stride, v1_plane);
    const ksl_vec3f_t v2_i = ksl_vec3f_of_planes(v2 + i * v2_stride, v2_plane);
    ksl_vec3f_t vo_i;
    ksl_add_vvf_accurate(&v1_i, &v2_i, &vo_i);
    ksl_vec3f_to_planes(&vo_i, vo + i * vo_stride, vo_plane);
  }
}

/* ksl_subtract_vvf_accurate of n elements. */
static KSL_INLINED void ksl_subtract_vvf_accurate_many(ptrdiff_t n, const ksl_vec3f_t *v1,
    ptrdiff_t v1_stride, const ksl_vec3f_t *v2, ptrdiff_t v2_stride,
    ksl_vec3f_t *vo, ptrdiff_t vo_stride) {
  KSL_EACH_OF(n) {
    ksl_subtract_vvf_accurate(v1 + i * v1_stride, v2 + i * v2_stride, vo + i * vo_stride);
  }
}

static KSL_INLINED void ksl_subtract_vvf_accurate_planes(ptrdiff_t n, const float *v1,
    ptrdiff_t v1_plane, ptrdiff_t v1_stride, const float *v2, ptrdiff_t v2_plane,
    ptrdiff_t v2_stride, float *vo, ptrdiff_t vo_plane, ptrdiff_t vo_stride) {
  ksl_vec3f_t v1_i;
  if (n > 0) v1_i = ksl_vec3f_of_planes(v1, v1_plane);
  KSL_EACH_OF(n) {
    if (v1_stride) v1_i = ksl_vec3f_of_planes(v1 + i * v1_stride, v1_plane);
    const ksl_vec3f_t v2_i = ksl_vec3f_of_planes(v2 + i * v2_stride, v2_plane);
    ksl_vec3f_t vo_i;
    ksl_subtract_vvf_accurate(&v1_i, &v2_i, &vo_i);
    ksl_vec3f_to_planes(&vo_i, vo + i * vo_stride, vo_plane);
  }
}

/* ksl_vec3f_scaled_accurate of n elements. */
static KSL_INLINED void ksl_vec3f_scaled_accurate_many(ptrdiff_t n, const ksl_vec3f_t *v,
    ptrdiff_t v_stride, const float *k, ptrdiff_t k_stride, ksl_vec3f_t *vo,
    ptrdiff_t vo_stride) {
  KSL_EACH_OF(n) {
    ksl_vec3f_scaled_accurate(v + i * v_stride, k[i * k_stride], vo + i * vo_stride);
  }
}

static KSL_INLINED void ksl_vec3f_scaled_accurate_planes(ptrdiff_t n, const float *v,
    ptrdiff_t v_plane, ptrdiff_t v_stride, const float *k, ptrdiff_t k_stride,
    float *vo, ptrdiff_t vo_plane, ptrdiff_t vo_stride) {
  ksl_vec3f_t v_i;
  if (n > 0) v_i = ksl_vec3f_of_planes(v, v_plane);
  KSL_EACH_OF(n) {
    if (v_stride) v_i = ksl_vec3f_of_planes(v + i * v_stride, v_plane);
    ksl_vec3f_t vo_i;
    ksl_vec3f_scaled_accurate(&v_i, k[i * k_stride], &vo_i);
    ksl_vec3f_to_planes(&vo_i, vo + i * vo_stride, vo_plane);
  }
}

/* ksl_vec3f_l2norm_accurate of n elements. */
static KSL_INLINED void ksl_vec3f_l2norm_accurate_many(ptrdiff_t n, const ksl_vec3f_t *v,
    ptrdiff_t v_stride, float *norm, ptrdiff_t norm_stride) {
  KSL_EACH_OF(n) {
    norm[i * norm_stride] = ksl_vec3f_l2norm_accurate(v + i * v_stride);
  }
}

static KSL_INLINED void ksl_vec3f_l2norm_accurate_planes(ptrdiff_t n, const float *v,
    ptrdiff_t v_plane, ptrdiff_t v_stride, float *norm, ptrdiff_t norm_stride) {
  ksl_vec3f_t v_i;
  if (n > 0) v_i = ksl_vec3f_of_planes(v, v_plane);
  KSL_EACH_OF(n) {
    if (v_stride) v_i = ksl_vec3f_of_planes(v + i * v_stride, v_plane);
    norm[i * norm_stride] = ksl_vec3f_l2norm_accurate(&v_i);
  }
}

/* ksl_vec3f_normalize_accurate of n elements. */
static KSL_INLINED void ksl_vec3f_normalize_accurate_many(ptrdiff_t n, ksl_vec3f_t *self,
    ptrdiff_t self_stride) {
  KSL_EACH_OF(n) {
    ksl_vec3f_normalize_accurate(self + i * self_stride);
  }
}

static KSL_INLINED void ksl_vec3f_normalize_accurate_planes(ptrdiff_t n, float *self,
    ptrdiff_t self_plane, ptrdiff_t self_stride) {
  KSL_EACH_OF(n) {
    ksl_vec3f_t self_i = ksl_vec3f_of_planes(self + i * self_stride, self_plane);
    ksl_vec3f_normalize_accurate(&self_i);
    ksl_vec3f_to_planes(&self_i, self + i * self_stride, self_plane);
  }
}

/* ksl_vec3f_normalized_accurate of n elements. */
static KSL_INLINED void ksl_vec3f_normalized_accurate_many(ptrdiff_t n, const ksl_vec3f_t *v,
    ptrdiff_t v_stride, ksl_vec3f_t *vo, ptrdiff_t vo_stride) {
  KSL_EACH_OF(n) {
    ksl_vec3f_normalized_accurate(v + i * v_stride, vo + i * vo_stride);
  }
}

static KSL_INLINED void ksl_vec3f_normalized_accurate_planes(ptrdiff_t n, const float *v,
    ptrdiff_t v_plane, ptrdiff_t v_stride, float *vo, ptrdiff_t vo_plane,
    ptrdiff_t vo_stride) {
  ksl_vec3f_t v_i;
  if (n > 0) v_i = ksl_vec3f_of_planes(v, v_plane);
  KSL_EACH_OF(n) {
    if (v_stride) v_i = ksl_vec3f_of_planes(v + i * v_stride, v_plane);
    ksl_vec3f_t vo_i;
    ksl_vec3f_normalized_accurate(&v_i, &vo_i);
    ksl_vec3f_to_planes(&vo_i, vo + i * vo_stride, vo_plane);
  }
}

/* ksl_angle_vvf_accurate of n elements. */
static KSL_INLINED void ksl_angle_vvf_accurate_many(ptrdiff_t n, const ksl_vec3f_t *v1,
    ptrdiff_t v1_stride, const ksl_vec3f_t *v2, ptrdiff_t v2_stride,
    float *angle, ptrdiff_t angle_stride) {
  KSL_EACH_OF(n) {
    angle[i * angle_stride] = ksl_angle_vvf_accurate(v1 + i * v1_stride, v2 + i * v2_stride);
  }
}

static KSL_INLINED void ksl_angle_vvf_accurate_planes(ptrdiff_t n, const float *v1,
    ptrdiff_t v1_plane, ptrdiff_t v1_stride, const float *v2, ptrdiff_t v2_plane,
    ptrdiff_t v2_stride, float *angle, ptrdiff_t angle_stride) {
  ksl_vec3f_t v1_i;
  if (n > 0) v1_i = ksl_vec3f_of_planes(v1, v1_plane);
  KSL_EACH_OF(n) {
    if (v1_stride) v1_i = ksl_vec3f_of_planes(v1 + i * v1_stride, v1_plane);
    const ksl_vec3f_t v2_i = ksl_vec3f_of_planes(v2 + i * v2_stride, v2_plane);
    angle[i * angle_stride] = ksl_angle_vvf_accurate(&v1_i, &v2_i);
  }
}

/* ksl_dot_vvf_accurate of n elements. */
static KSL_INLINED void ksl_dot_vvf_accurate_many(ptrdiff_t n, const ksl_vec3f_t *v1,
    ptrdiff_t v1_stride, const ksl_vec3f_t *v2, ptrdiff_t v2_stride, float *dot,
    ptrdiff_t dot_stride) {
  KSL_EACH_OF(n) {
    dot[i * dot_stride] = ksl_dot_vvf_accurate(v1 + i * v1_stride, v2 + i * v2_stride);
  }
}

static KSL_INLINED void ksl_dot_vvf_accurate_planes(ptrdiff_t n, const float *v1,
    ptrdiff_t v1_plane, ptrdiff_t v1_stride, const float *v2, ptrdiff_t v2_plane,
    ptrdiff_t v2_stride, float *dot, ptrdiff_t dot_stride) {
  ksl_vec3f_t v1_i;
  if (n > 0) v1_i = ksl_vec3f_of_planes(v1, v1_plane);
  KSL_EACH_OF(n) {
    if (v1_stride) v1_i = ksl_vec3f_of_planes(v1 + i * v1_stride, v1_plane);
    const ksl_vec3f_t v2_i = ksl_vec3f_of_planes(v2 + i * v2_stride, v2_plane);
    dot[i * dot_stride] = ksl_dot_vvf_accurate(&v1_i, &v2_i);
  }
}

/* ksl_product_avinvf_accurate of n elements. */
static KSL_INLINED void ksl_product_avinvf_accurate_many(ptrdiff_t n, const float *k,
    ptrdiff_t k_stride, const ksl_vec3f_t *v, ptrdiff_t v_stride,
    ksl_vec3f_t *vo, ptrdiff_t vo_stride) {
  KSL_EACH_OF(n) {
    ksl_product_avinvf_accurate(k[i * k_stride], v + i * v_stride, vo + i * vo_stride);
  }
}

static KSL_INLINED void ksl_product_avinvf_accurate_planes(ptrdiff_t n, const float *k,
    ptrdiff_t k_stride, const float *v, ptrdiff_t v_plane, ptrdiff_t v_stride,
    float *vo, ptrdiff_t vo_plane, ptrdiff_t vo_stride) {
  KSL_EACH_OF(n) {
    const ksl_vec3f_t v_i = ksl_vec3f_of_planes(v + i * v_stride, v_plane);
    ksl_vec3f_t vo_i;
    ksl_product_avinvf_accurate(k[i * k_stride], &v_i, &vo_i);
    ksl_vec3f_to_planes(&vo_i, vo + i * vo_stride, vo_plane);
  }
}

/* ksl_product_ainvvf_accurate of n elements. */
static KSL_INLINED void ksl_product_ainvvf_accurate_many(ptrdiff_t n, const float *k,
    ptrdiff_t k_stride, const ksl_vec3f_t *v, ptrdiff_t v_stride,
    ksl_vec3f_t *vo, ptrdiff_t vo_stride) {
  KSL_EACH_OF(n) {
    ksl_product_ainvvf_accurate(k[i * k_stride], v + i * v_stride, vo + i * vo_stride);
  }
}

static KSL_INLINED void ksl_product_ainvvf_accurate_planes(ptrdiff_t n, const float *k,
    ptrdiff_t k_stride, const float *v, ptrdiff_t v_plane, ptrdiff_t v_stride,
    float *vo, ptrdiff_t vo_plane, ptrdiff_t vo_stride) {
  KSL_EACH_OF(n) {
    const ksl_vec3f_t v_i = ksl_vec3f_of_planes(v + i * v_stride, v_plane);
    ksl_vec3f_t vo_i;
    ksl_product_ainvvf_accurate(k[i * k_stride], &v_i, &vo_i);
    ksl_vec3f_to_planes(&vo_i, vo + i * vo_stride, vo_plane);
  }
}

/* ksl_cross_vvf_accurate of n elements. */
static KSL_INLINED void ksl_cross_vvf_accurate_many(ptrdiff_t n, const ksl_vec3f_t *v1,
    ptrdiff_t v1_stride, const ksl_vec3f_t *v2, ptrdiff_t v2_stride,
    ksl_vec3f_t *vo, ptrdiff_t vo_stride) {
  KSL_EACH_OF(n) {
    ksl_cross_vvf_accurate(v1 + i * v1_stride, v2 + i * v2_stride, vo + i * vo_stride);
  }
}

static KSL_INLINED void ksl_cross_vvf_accurate_planes(ptrdiff_t n, const float *v1,
    ptrdiff_t v1_plane, ptrdiff_t v1_stride, const float *v2, ptrdiff_t v2_plane,
    ptrdiff_t v2_stride, float *vo, ptrdiff_t vo_plane, ptrdiff_t vo_stride) {
  ksl_vec3f_t v1_i;
  if (n > 0) v1_i = ksl_vec3f_of_planes(v1, v1_plane);
  KSL_EACH_OF(n) {
    if (v1_stride) v1_i = ksl_vec3f_of_planes(v1 + i * v1_stride, v1_plane);
    const ksl_vec3f_t v2_i = ksl_vec3f_of_planes(v2 + i * v2_stride, v2_plane);
    ksl_vec3f_t vo_i;
    ksl_cross_vvf_accurate(&v1_i, &v2_i, &vo_i);
    ksl_vec3f_to_planes(&vo_i, vo + i * vo_stride, vo_plane);
  }
}

/* ksl_cross_vvinvf_accurate of n elements. */
static KSL_INLINED void ksl_cross_vvinvf_accurate_many(ptrdiff_t n, const ksl_vec3f_t *v1,
    ptrdiff_t v1_stride, const ksl_vec3f_t *v2, ptrdiff_t v2_stride,
    ksl_vec3f_t *vo, ptrdiff_t vo_stride) {
  KSL_EACH_OF(n) {
    ksl_cross_vvinvf_accurate(v1 + i * v1_stride, v2 + i * v2_stride, vo + i * vo_stride);
  }
}

static KSL_INLINED void ksl_cross_vvinvf_accurate_planes(ptrdiff_t n, const float *v1,
    ptrdiff_t v1_plane, ptrdiff_t v1_stride, const float *v2, ptrdiff_t v2_plane,
    ptrdiff_t v2_stride, float *vo, ptrdiff_t vo_plane, ptrdiff_t vo_stride) {
  ksl_vec3f_t v1_i;
  if (n > 0) v1_i = ksl_vec3f_of_planes(v1, v1_plane);
  KSL_EACH_OF(n) {
    if (v1_stride) v1_i = ksl_vec3f_of_planes(v1 + i * v1_stride, v1_plane);
    const ksl_vec3f_t v2_i = ksl_vec3f_of_planes(v2 + i * v2_stride, v2_plane);
    ksl_vec3f_t vo_i;
    ksl_cross_vvinvf_accurate(&v1_i, &v2_i, &vo_i);
    ksl_vec3f_to_planes(&vo_i, vo + i * vo_stride, vo_plane);
  }
}

/* ksl_add_vvxf_accurate of n elements. */
static KSL_INLINED void ksl_add_vvxf_accurate_many(ptrdiff_t n, const ksl_vec3f_t *v,
    ptrdiff_t v_stride, const float *k, ptrdiff_t k_stride, ksl_vec3f_t *vo,
    ptrdiff_t vo_stride) {
  KSL_EACH_OF(n) {
    ksl_add_vvxf_accurate(v + i * v_stride, k[i * k_stride], vo + i * vo_stride);
  }
}

static KSL_INLINED void ksl_add_vvxf_accurate_planes(ptrdiff_t n, const float *v, ptrdiff_t v_plane,
    ptrdiff_t v_stride, const float *k, ptrdiff_t k_stride, float *vo,
    ptrdiff_t vo_plane, ptrdiff_t vo_stride) {
  ksl_vec3f_t v_i;
  if (n > 0) v_i = ksl_vec3f_of_planes(v, v_plane);
  KSL_EACH_OF(n) {
    if (v_stride) v_i = ksl_vec3f_of_planes(v + i * v_stride, v_plane);
    ksl_vec3f_t vo_i;
    ksl_add_vvxf_accurate(&v_i, k[i * k_stride], &vo_i);
    ksl_vec3f_to_planes(&vo_i, vo + i * vo_stride, vo_plane);
  }
}

/* ksl_add_vvxinvf_accurate of n elements. */
static KSL_INLINED void ksl_add_vvxinvf_accurate_many(ptrdiff_t n, const ksl_vec3f_t *v,
    ptrdiff_t v_stride, const float *k, ptrdiff_t k_stride, ksl_vec3f_t *vo,
    ptrdiff_t vo_stride) {
  KSL_EACH_OF(n) {
    ksl_add_vvxinvf_accurate(v + i * v_stride, k[i * k_stride], vo + i * vo_stride);
  }
}

static KSL_INLINED void ksl_add_vvxinvf_accurate_planes(ptrdiff_t n, const float *v,
    ptrdiff_t v_plane, ptrdiff_t v_stride, const float *k, ptrdiff_t k_stride,
    float *vo, ptrdiff_t vo_plane, ptrdiff_t vo_stride) {
  ksl_vec3f_t v_i;
  if (n > 0) v_i = ksl_vec3f_of_planes(v, v_plane);
  KSL_EACH_OF(n) {
    if (v_stride) v_i = ksl_vec3f_of_planes(v + i * v_stride, v_plane);
    ksl_vec3f_t vo_i;
    ksl_add_vvxinvf_accurate(&v_i, k[i * k_stride], &vo_i);
    ksl_vec3f_to_planes(&vo_i, vo + i * vo_stride, vo_plane);
  }
}

/* ksl_add_vvyf_accurate of n elements. */
static KSL_INLINED void ksl_add_vvyf_accurate_many(ptrdiff_t n, const ksl_vec3f_t *v,
    ptrdiff_t v_stride, const float *k, ptrdiff_t k_stride, ksl_vec3f_t *vo,
    ptrdiff_t vo_stride) {
  KSL_EACH_OF(n) {
    ksl_add_vvyf_accurate(v + i * v_stride, k[i * k_stride], vo + i * vo_stride);
  }
}

static KSL_INLINED void ksl_add_vvyf_accurate_planes(ptrdiff_t n, const float *v, ptrdiff_t v_plane,
    ptrdiff_t v_stride, const float *k, ptrdiff_t k_stride, float *vo,
    ptrdiff_t vo_plane, ptrdiff_t vo_stride) {
  ksl_vec3f_t v_i;
  if (n > 0) v_i = ksl_vec3f_of_planes(v, v_plane);
  KSL_EACH_OF(n) {
    if (v_stride) v_i = ksl_vec3f_of_planes(v + i * v_stride, v_plane);
    ksl_vec3f_t vo_i;
    ksl_add_vvyf_accurate(&v_i, k[i * k_stride], &vo_i);
    ksl_vec3f_to_planes(&vo_i, vo + i * vo_stride, vo_plane);
  }
}

/* ksl_add_vvyinvf_accurate of n elements. */
static KSL_INLINED void ksl_add_vvyinvf_accurate_many(ptrdiff_t n, const ksl_vec3f_t *v,
    ptrdiff_t v_stride, const float *k, ptrdiff_t k_stride, ksl_vec3f_t *vo,
    ptrdiff_t vo_stride) {
  KSL_EACH_OF(n) {
    ksl_add_vvyinvf_accurate(v + i * v_stride, k[i * k_stride], vo + i * vo_stride);
  }
}

static KSL_INLINED void ksl_add_vvyinvf_accurate_planes(ptrdiff_t n, const float *v,
    ptrdiff_t v_plane, ptrdiff_t v_stride, const float *k, ptrdiff_t k_stride,
    float *vo, ptrdiff_t vo_plane, ptrdiff_t vo_stride) {
  ksl_vec3f_t v_i;
  if (n > 0) v_i = ksl_vec3f_of_planes(v, v_plane);
  KSL_EACH_OF(n) {
    if (v_stride) v_i = ksl_vec3f_of_planes(v + i * v_stride, v_plane);
    ksl_vec3f_t vo_i;
    ksl_add_vvyinvf_accurate(&v_i, k[i * k_stride], &vo_i);
    ksl_vec3f_to_planes(&vo_i, vo + i * vo_stride, vo_plane);
  }
}

/* ksl_add_vvzf_accurate of n elements. */
static KSL_INLINED void ksl_add_vvzf_accurate_many(ptrdiff_t n, const ksl_vec3f_t *v,
    ptrdiff_t v_stride, const float *k, ptrdiff_t k_stride, ksl_vec3f_t *vo,
    ptrdiff_t vo_stride) {
  KSL_EACH_OF(n) {
    ksl_add_vvzf_accurate(v + i * v_stride, k[i * k_stride], vo + i * vo_stride);
  }
}

static KSL_INLINED void ksl_add_vvzf_accurate_planes(ptrdiff_t n, const float *v, ptrdiff_t v_plane,
    ptrdiff_t v_stride, const float *k, ptrdiff_t k_stride, float *vo,
    ptrdiff_t vo_plane, ptrdiff_t vo_stride) {
  ksl_vec3f_t v_i;
  if (n > 0) v_i = ksl_vec3f_of_planes(v, v_plane);
  KSL_EACH_OF(n) {
    if (v_stride) v_i = ksl_vec3f_of_planes(v + i * v_stride, v_plane);
    ksl_vec3f_t vo_i;
    ksl_add_vvzf_accurate(&v_i, k[i * k_stride], &vo_i);
    ksl_vec3f_to_planes(&vo_i, vo + i * vo_stride, vo_plane);
  }
}

/* ksl_add_vvzinvf_accurate of n elements. */
static KSL_INLINED void ksl_add_vvzinvf_accurate_many(ptrdiff_t n, const ksl_vec3f_t *v,
    ptrdiff_t v_stride, const float *k, ptrdiff_t k_stride, ksl_vec3f_t *vo,
    ptrdiff_t vo_stride) {
  KSL_EACH_OF(n) {
    ksl_add_vvzinvf_accurate(v + i * v_stride, k[i * k_stride], vo + i * vo_stride);
  }
}

static KSL_INLINED void ksl_add_vvzinvf_accurate_planes(ptrdiff_t n, const float *v,
    ptrdiff_t v_plane, ptrdiff_t v_stride, const float *k, ptrdiff_t k_stride,
    float *vo, ptrdiff_t vo_plane, ptrdiff_t vo_stride) {
  ksl_vec3f_t v_i;
  if (n > 0) v_i = ksl_vec3f_of_planes(v, v_plane);
  KSL_EACH_OF(n) {
    if (v_stride) v_i = ksl_vec3f_of_planes(v + i * v_stride, v_plane);
    ksl_vec3f_t vo_i;
    ksl_add_vvzinvf_accurate(&v_i, k[i * k_stride], &vo_i);
    ksl_vec3f_to_planes(&vo_i, vo + i * vo_stride, vo_plane);
  }
}

#endif
