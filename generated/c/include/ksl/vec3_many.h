/* Made by `coscrew generate`; changes are overwritten. */
/* SPDX-License-Identifier: MIT */
/* coscrew 0.2.0.  Copyright (c) 2026 The coscrew authors. */
/* Vectors of three components.  Many at a time.
   What arguments are, and what loops over them cost, ksl_planes.h says. */
#ifndef KSL_VEC3_MANY_H
#define KSL_VEC3_MANY_H

#include "vec3.h"
#include "ksl_planes.h"

/* ksl_vec3_copy of n elements. */
static KSL_INLINED void ksl_vec3_copy_many(ptrdiff_t n, const ksl_vec3_t *vi, ptrdiff_t vi_stride,
    ksl_vec3_t *vo, ptrdiff_t vo_stride) {
  KSL_EACH_OF(n) {
    ksl_vec3_copy(vi + i * vi_stride, vo + i * vo_stride);
  }
}

static KSL_INLINED void ksl_vec3_copy_planes(ptrdiff_t n, const double *vi, ptrdiff_t vi_plane,
    ptrdiff_t vi_stride, double *vo, ptrdiff_t vo_plane, ptrdiff_t vo_stride) {
  ksl_vec3_t vi_i;
  if (n > 0) vi_i = ksl_vec3_of_planes(vi, vi_plane);
  KSL_EACH_OF(n) {
    if (vi_stride) vi_i = ksl_vec3_of_planes(vi + i * vi_stride, vi_plane);
    ksl_vec3_t vo_i;
    ksl_vec3_copy(&vi_i, &vo_i);
    ksl_vec3_to_planes(&vo_i, vo + i * vo_stride, vo_plane);
  }
}

/* ksl_vec3_scale of n elements. */
static KSL_INLINED void ksl_vec3_scale_many(ptrdiff_t n, ksl_vec3_t *self, ptrdiff_t self_stride,
    const double *a, ptrdiff_t a_stride) {
  KSL_EACH_OF(n) {
    ksl_vec3_scale(self + i * self_stride, a[i * a_stride]);
  }
}

static KSL_INLINED void ksl_vec3_scale_planes(ptrdiff_t n, double *self, ptrdiff_t self_plane,
    ptrdiff_t self_stride, const double *a, ptrdiff_t a_stride) {
  KSL_EACH_OF(n) {
    ksl_vec3_t self_i = ksl_vec3_of_planes(self + i * self_stride, self_plane);
    ksl_vec3_scale(&self_i, a[i * a_stride]);
    ksl_vec3_to_planes(&self_i, self + i * self_stride, self_plane);
  }
}

/* ksl_vec3_inverted of n elements. */
static KSL_INLINED void ksl_vec3_inverted_many(ptrdiff_t n, const ksl_vec3_t *vi,
    ptrdiff_t vi_stride, ksl_vec3_t *vo, ptrdiff_t vo_stride) {
  KSL_EACH_OF(n) {
    ksl_vec3_inverted(vi + i * vi_stride, vo + i * vo_stride);
  }
}

static KSL_INLINED void ksl_vec3_inverted_planes(ptrdiff_t n, const double *vi, ptrdiff_t vi_plane,
    ptrdiff_t vi_stride, double *vo, ptrdiff_t vo_plane, ptrdiff_t vo_stride) {
  ksl_vec3_t vi_i;
  if (n > 0) vi_i = ksl_vec3_of_planes(vi, vi_plane);
  KSL_EACH_OF(n) {
    if (vi_stride) vi_i = ksl_vec3_of_planes(vi + i * vi_stride, vi_plane);
    ksl_vec3_t vo_i;
    ksl_vec3_inverted(&vi_i, &vo_i);
    ksl_vec3_to_planes(&vo_i, vo + i * vo_stride, vo_plane);
  }
}

/* ksl_vec3_invert of n elements. */
static KSL_INLINED void ksl_vec3_invert_many(ptrdiff_t n, ksl_vec3_t *self, ptrdiff_t self_stride) {
  KSL_EACH_OF(n) {
    ksl_vec3_invert(self + i * self_stride);
  }
}

static KSL_INLINED void ksl_vec3_invert_planes(ptrdiff_t n, double *self, ptrdiff_t self_plane,
    ptrdiff_t self_stride) {
  KSL_EACH_OF(n) {
    ksl_vec3_t self_i = ksl_vec3_of_planes(self + i * self_stride, self_plane);
    ksl_vec3_invert(&self_i);
    ksl_vec3_to_planes(&self_i, self + i * self_stride, self_plane);
  }
}

/* ksl_axpy_vv of n elements. */
static KSL_INLINED void ksl_axpy_vv_many(ptrdiff_t n, const double *a, ptrdiff_t a_stride,
    const ksl_vec3_t *x, ptrdiff_t x_stride, ksl_vec3_t *y, ptrdiff_t y_stride) {
  KSL_EACH_OF(n) {
    ksl_axpy_vv(a[i * a_stride], x + i * x_stride, y + i * y_stride);
  }
}

static KSL_INLINED void ksl_axpy_vv_planes(ptrdiff_t n, const double *a, ptrdiff_t a_stride,
    const double *x, ptrdiff_t x_plane, ptrdiff_t x_stride, double *y,
    ptrdiff_t y_plane, ptrdiff_t y_stride) {
  KSL_EACH_OF(n) {
    const ksl_vec3_t x_i = ksl_vec3_of_planes(x + i * x_stride, x_plane);
    ksl_vec3_t y_i = ksl_vec3_of_planes(y + i * y_stride, y_plane);
    ksl_axpy_vv(a[i * a_stride], &x_i, &y_i);
    ksl_vec3_to_planes(&y_i, y + i * y_stride, y_plane);
  }
}

/* ksl_xpy_vv of n elements. */
static KSL_INLINED void ksl_xpy_vv_many(ptrdiff_t n, const ksl_vec3_t *x, ptrdiff_t x_stride,
    ksl_vec3_t *y, ptrdiff_t y_stride) {
  KSL_EACH_OF(n) {
    ksl_xpy_vv(x + i * x_stride, y + i * y_stride);
  }
}

static KSL_INLINED void ksl_xpy_vv_planes(ptrdiff_t n, const double *x, ptrdiff_t x_plane,
    ptrdiff_t x_stride, double *y, ptrdiff_t y_plane, ptrdiff_t y_stride) {
  ksl_vec3_t x_i;
  if (n > 0) x_i = ksl_vec3_of_planes(x, x_plane);
  KSL_EACH_OF(n) {
    if (x_stride) x_i = ksl_vec3_of_planes(x + i * x_stride, x_plane);
    ksl_vec3_t y_i = ksl_vec3_of_planes(y + i * y_stride, y_plane);
    ksl_xpy_vv(&x_i, &y_i);
    ksl_vec3_to_planes(&y_i, y + i * y_stride, y_plane);
  }
}

/* ksl_nxpy_vv of n elements. */
static KSL_INLINED void ksl_nxpy_vv_many(ptrdiff_t n, const ksl_vec3_t *x, ptrdiff_t x_stride,
    ksl_vec3_t *y, ptrdiff_t y_stride) {
  KSL_EACH_OF(n) {
    ksl_nxpy_vv(x + i * x_stride, y + i * y_stride);
  }
}

static KSL_INLINED void ksl_nxpy_vv_planes(ptrdiff_t n, const double *x, ptrdiff_t x_plane,
    ptrdiff_t x_stride, double *y, ptrdiff_t y_plane, ptrdiff_t y_stride) {
  ksl_vec3_t x_i;
  if (n > 0) x_i = ksl_vec3_of_planes(x, x_plane);
  KSL_EACH_OF(n) {
    if (x_stride) x_i = ksl_vec3_of_planes(x + i * x_stride, x_plane);
    ksl_vec3_t y_i = ksl_vec3_of_planes(y + i * y_stride, y_plane);
    ksl_nxpy_vv(&x_i, &y_i);
    ksl_vec3_to_planes(&y_i, y + i * y_stride, y_plane);
  }
}

/* ksl_product_av of n elements. */
static KSL_INLINED void ksl_product_av_many(ptrdiff_t n, const double *a, ptrdiff_t a_stride,
    const ksl_vec3_t *vi, ptrdiff_t vi_stride, ksl_vec3_t *vo,
    ptrdiff_t vo_stride) {
  KSL_EACH_OF(n) {
    ksl_product_av(a[i * a_stride], vi + i * vi_stride, vo + i * vo_stride);
  }
}

static KSL_INLINED void ksl_product_av_planes(ptrdiff_t n, const double *a, ptrdiff_t a_stride,
    const double *vi, ptrdiff_t vi_plane, ptrdiff_t vi_stride, double *vo,
    ptrdiff_t vo_plane, ptrdiff_t vo_stride) {
  KSL_EACH_OF(n) {
    const ksl_vec3_t vi_i = ksl_vec3_of_planes(vi + i * vi_stride, vi_plane);
    ksl_vec3_t vo_i;
    ksl_product_av(a[i * a_stride], &vi_i, &vo_i);
    ksl_vec3_to_planes(&vo_i, vo + i * vo_stride, vo_plane);
  }
}

/* ksl_add_vv of n elements. */
static KSL_INLINED void ksl_add_vv_many(ptrdiff_t n, const ksl_vec3_t *v1, ptrdiff_t v1_stride,
    const ksl_vec3_t *v2, ptrdiff_t v2_stride, ksl_vec3_t *vo,
    ptrdiff_t vo_stride) {
  KSL_EACH_OF(n) {
    ksl_add_vv(v1 + i * v1_stride, v2 + i * v2_stride, vo + i * vo_stride);
  }
}

static KSL_INLINED void ksl_add_vv_planes(ptrdiff_t n, const double *v1, ptrdiff_t v1_plane,
    ptrdiff_t v1_stride, const double *v2, ptrdiff_t v2_plane,
    ptrdiff_t v2_stride, double *vo, ptrdiff_t vo_plane, ptrdiff_t vo_stride) {
  ksl_vec3_t v1_i;
  if (n > 0) v1_i = ksl_vec3_of_planes(v1, v1_plane);
  KSL_EACH_OF(n) {
    if (v1_stride) v1_i = ksl_vec3_of_planes(v1 + i * v1_stride, v1_plane);
    const ksl_vec3_t v2_i = ksl_vec3_of_planes(v2 + i * v2_stride, v2_plane);
    ksl_vec3_t vo_i;
    ksl_add_vv(&v1_i, &v2_i, &vo_i);
    ksl_vec3_to_planes(&vo_i, vo + i * vo_stride, vo_plane);
  }
}

/* ksl_subtract_vv of n elements. */
static KSL_INLINED void ksl_subtract_vv_many(ptrdiff_t n, const ksl_vec3_t *v1, ptrdiff_t v1_stride,
    const ksl_vec3_t *v2, ptrdiff_t v2_stride, ksl_vec3_t *vo,
    ptrdiff_t vo_stride) {
  KSL_EACH_OF(n) {
    ksl_subtract_vv(v1 + i * v1_stride, v2 + i * v2_stride, vo + i * vo_stride);
  }
}

static KSL_INLINED void ksl_subtract_vv_planes(ptrdiff_t n, const double *v1, ptrdiff_t v1_plane,
    ptrdiff_t v1_stride, const double *v2, ptrdiff_t v2_plane,
    ptrdiff_t v2_stride, double *vo, ptrdiff_t vo_plane, ptrdiff_t vo_stride) {
  ksl_vec3_t v1_i;
  if (n > 0) v1_i = ksl_vec3_of_planes(v1, v1_plane);
  KSL_EACH_OF(n) {
    if (v1_stride) v1_i = ksl_vec3_of_planes(v1 + i * v1_stride, v1_plane);
    const ksl_vec3_t v2_i = ksl_vec3_of_planes(v2 + i * v2_stride, v2_plane);
    ksl_vec3_t vo_i;
    ksl_subtract_vv(&v1_i, &v2_i, &vo_i);
    ksl_vec3_to_planes(&vo_i, vo + i * vo_stride, vo_plane);
  }
}

/* ksl_vec3_scaled of n elements. */
static KSL_INLINED void ksl_vec3_scaled_many(ptrdiff_t n, const ksl_vec3_t *v, ptrdiff_t v_stride,
    const double *k, ptrdiff_t k_stride, ksl_vec3_t *vo, ptrdiff_t vo_stride) {
  KSL_EACH_OF(n) {
    ksl_vec3_scaled(v + i * v_stride, k[i * k_stride], vo + i * vo_stride);
  }
}

static KSL_INLINED void ksl_vec3_scaled_planes(ptrdiff_t n, const double *v, ptrdiff_t v_plane,
    ptrdiff_t v_stride, const double *k, ptrdiff_t k_stride, double *vo,
    ptrdiff_t vo_plane, ptrdiff_t vo_stride) {
  ksl_vec3_t v_i;
  if (n > 0) v_i = ksl_vec3_of_planes(v, v_plane);
  KSL_EACH_OF(n) {
    if (v_stride) v_i = ksl_vec3_of_planes(v + i * v_stride, v_plane);
    ksl_vec3_t vo_i;
    ksl_vec3_scaled(&v_i, k[i * k_stride], &vo_i);
    ksl_vec3_to_planes(&vo_i, vo + i * vo_stride, vo_plane);
  }
}

/* ksl_vec3_swap of n elements. */
static KSL_INLINED void ksl_vec3_swap_many(ptrdiff_t n, ksl_vec3_t *v1, ptrdiff_t v1_stride,
    ksl_vec3_t *v2, ptrdiff_t v2_stride) {
  KSL_EACH_OF(n) {
    ksl_vec3_swap(v1 + i * v1_stride, v2 + i * v2_stride);
  }
}

static KSL_INLINED void ksl_vec3_swap_planes(ptrdiff_t n, double *v1, ptrdiff_t v1_plane,
    ptrdiff_t v1_stride, double *v2, ptrdiff_t v2_plane, ptrdiff_t v2_stride) {
  KSL_EACH_OF(n) {
    ksl_vec3_t v1_i = ksl_vec3_of_planes(v1 + i * v1_stride, v1_plane);
    ksl_vec3_t v2_i = ksl_vec3_of_planes(v2 + i * v2_stride, v2_plane);
    ksl_vec3_swap(&v1_i, &v2_i);
    ksl_vec3_to_planes(&v1_i, v1 + i * v1_stride, v1_plane);
    ksl_vec3_to_planes(&v2_i, v2 + i * v2_stride, v2_plane);
  }
}

/* ksl_vec3_l2norm of n elements. */
static KSL_INLINED void ksl_vec3_l2norm_many(ptrdiff_t n, const ksl_vec3_t *v, ptrdiff_t v_stride,
    double *norm, ptrdiff_t norm_stride) {
  KSL_EACH_OF(n) {
    norm[i * norm_stride] = ksl_vec3_l2norm(v + i * v_stride);
  }
}

static KSL_INLINED void ksl_vec3_l2norm_planes(ptrdiff_t n, const double *v, ptrdiff_t v_plane,
    ptrdiff_t v_stride, double *norm, ptrdiff_t norm_stride) {
  ksl_vec3_t v_i;
  if (n > 0) v_i = ksl_vec3_of_planes(v, v_plane);
  KSL_EACH_OF(n) {
    if (v_stride) v_i = ksl_vec3_of_planes(v + i * v_stride, v_plane);
    norm[i * norm_stride] = ksl_vec3_l2norm(&v_i);
  }
}

/* ksl_vec3_normalize of n elements. */
static KSL_INLINED void ksl_vec3_normalize_many(ptrdiff_t n, ksl_vec3_t *self,
    ptrdiff_t self_stride) {
  KSL_EACH_OF(n) {
    ksl_vec3_normalize(self + i * self_stride);
  }
}

static KSL_INLINED void ksl_vec3_normalize_planes(ptrdiff_t n, double *self, ptrdiff_t self_plane,
    ptrdiff_t self_stride) {
  KSL_EACH_OF(n) {
    ksl_vec3_t self_i = ksl_vec3_of_planes(self + i * self_stride, self_plane);
    ksl_vec3_normalize(&self_i);
    ksl_vec3_to_planes(&self_i, self + i * self_stride, self_plane);
  }
}

/* ksl_vec3_normalized of n elements. */
static KSL_INLINED void ksl_vec3_normalized_many(ptrdiff_t n, const ksl_vec3_t *v,
    ptrdiff_t v_stride, ksl_vec3_t *vo, ptrdiff_t vo_stride) {
  KSL_EACH_OF(n) {
    ksl_vec3_normalized(v + i * v_stride, vo + i * vo_stride);
  }
}

static KSL_INLINED void ksl_vec3_normalized_planes(ptrdiff_t n, const double *v, ptrdiff_t v_plane,
    ptrdiff_t v_stride, double *vo, ptrdiff_t vo_plane, ptrdiff_t vo_stride) {
  ksl_vec3_t v_i;
  if (n > 0) v_i = ksl_vec3_of_planes(v, v_plane);
  KSL_EACH_OF(n) {
    if (v_stride) v_i = ksl_vec3_of_planes(v + i * v_stride, v_plane);
    ksl_vec3_t vo_i;
    ksl_vec3_normalized(&v_i, &vo_i);
    ksl_vec3_to_planes(&vo_i, vo + i * vo_stride, vo_plane);
  }
}

/* ksl_angle_vv of n elements. */
static KSL_INLINED void ksl_angle_vv_many(ptrdiff_t n, const ksl_vec3_t *v1, ptrdiff_t v1_stride,
    const ksl_vec3_t *v2, ptrdiff_t v2_stride, double *angle,
    ptrdiff_t angle_stride) {
  KSL_EACH_OF(n) {
    angle[i * angle_stride] = ksl_angle_vv(v1 + i * v1_stride, v2 + i * v2_stride);
  }
}

static KSL_INLINED void ksl_angle_vv_planes(ptrdiff_t n, const double *v1, ptrdiff_t v1_plane,
    ptrdiff_t v1_stride, const double *v2, ptrdiff_t v2_plane,
    ptrdiff_t v2_stride, double *angle, ptrdiff_t angle_stride) {
  ksl_vec3_t v1_i;
  if (n > 0) v1_i = ksl_vec3_of_planes(v1, v1_plane);
  KSL_EACH_OF(n) {
    if (v1_stride) v1_i = ksl_vec3_of_planes(v1 + i * v1_stride, v1_plane);
    const ksl_vec3_t v2_i = ksl_vec3_of_planes(v2 + i * v2_stride, v2_plane);
    angle[i * angle_stride] = ksl_angle_vv(&v1_i, &v2_i);
  }
}

/* ksl_dot_vv of n elements. */
static KSL_INLINED void ksl_dot_vv_many(ptrdiff_t n, const ksl_vec3_t *v1, ptrdiff_t v1_stride,
    const ksl_vec3_t *v2, ptrdiff_t v2_stride, double *dot, ptrdiff_t dot_stride) {
  KSL_EACH_OF(n) {
    dot[i * dot_stride] = ksl_dot_vv(v1 + i * v1_stride, v2 + i * v2_stride);
  }
}

static KSL_INLINED void ksl_dot_vv_planes(ptrdiff_t n, const double *v1, ptrdiff_t v1_plane,
    ptrdiff_t v1_stride, const double *v2, ptrdiff_t v2_plane,
    ptrdiff_t v2_stride, double *dot, ptrdiff_t dot_stride) {
  ksl_vec3_t v1_i;
  if (n > 0) v1_i = ksl_vec3_of_planes(v1, v1_plane);
  KSL_EACH_OF(n) {
    if (v1_stride) v1_i = ksl_vec3_of_planes(v1 + i * v1_stride, v1_plane);
    const ksl_vec3_t v2_i = ksl_vec3_of_planes(v2 + i * v2_stride, v2_plane);
    dot[i * dot_stride] = ksl_dot_vv(&v1_i, &v2_i);
  }
}

/* ksl_product_avinv of n elements. */
static KSL_INLINED void ksl_product_avinv_many(ptrdiff_t n, const double *k, ptrdiff_t k_stride,
    const ksl_vec3_t *v, ptrdiff_t v_stride, ksl_vec3_t *vo, ptrdiff_t vo_stride) {
  KSL_EACH_OF(n) {
    ksl_product_avinv(k[i * k_stride], v + i * v_stride, vo + i * vo_stride);
  }
}

static KSL_INLINED void ksl_product_avinv_planes(ptrdiff_t n, const double *k, ptrdiff_t k_stride,
    const double *v, ptrdiff_t v_plane, ptrdiff_t v_stride, double *vo,
    ptrdiff_t vo_plane, ptrdiff_t vo_stride) {
  KSL_EACH_OF(n) {
    const ksl_vec3_t v_i = ksl_vec3_of_planes(v + i * v_stride, v_plane);
    ksl_vec3_t vo_i;
    ksl_product_avinv(k[i * k_stride], &v_i, &vo_i);
    ksl_vec3_to_planes(&vo_i, vo + i * vo_stride, vo_plane);
  }
}

/* ksl_product_ainvv of n elements. */
static KSL_INLINED void ksl_product_ainvv_many(ptrdiff_t n, const double *k, ptrdiff_t k_stride,
    const ksl_vec3_t *v, ptrdiff_t v_stride, ksl_vec3_t *vo, ptrdiff_t vo_stride) {
  KSL_EACH_OF(n) {
    ksl_product_ainvv(k[i * k_stride], v + i * v_stride, vo + i * vo_stride);
  }
}

static KSL_INLINED void ksl_product_ainvv_planes(ptrdiff_t n, const double *k, ptrdiff_t k_stride,
    const double *v, ptrdiff_t v_plane, ptrdiff_t v_stride, double *vo,
    ptrdiff_t vo_plane, ptrdiff_t vo_stride) {
  KSL_EACH_OF(n) {
    const ksl_vec3_t v_i = ksl_vec3_of_planes(v + i * v_stride, v_plane);
    ksl_vec3_t vo_i;
    ksl_product_ainvv(k[i * k_stride], &v_i, &vo_i);
    ksl_vec3_to_planes(&vo_i, vo + i * vo_stride, vo_plane);
  }
}

/* ksl_cross_vv of n elements. */
static KSL_INLINED void ksl_cross_vv_many(ptrdiff_t n, const ksl_vec3_t *v1, ptrdiff_t v1_stride,
    const ksl_vec3_t *v2, ptrdiff_t v2_stride, ksl_vec3_t *vo,
    ptrdiff_t vo_stride) {
  KSL_EACH_OF(n) {
    ksl_cross_vv(v1 + i * v1_stride, v2 + i * v2_stride, vo + i * vo_stride);
  }
}

static KSL_INLINED void ksl_cross_vv_planes(ptrdiff_t n, const double *v1, ptrdiff_t v1_plane,
    ptrdiff_t v1_stride, const double *v2, ptrdiff_t v2_plane,
    ptrdiff_t v2_stride, double *vo, ptrdiff_t vo_plane, ptrdiff_t vo_stride) {
  ksl_vec3_t v1_i;
  if (n > 0) v1_i = ksl_vec3_of_planes(v1, v1_plane);
  KSL_EACH_OF(n) {
    if (v1_stride) v1_i = ksl_vec3_of_planes(v1 + i * v1_stride, v1_plane);
    const ksl_vec3_t v2_i = ksl_vec3_of_planes(v2 + i * v2_stride, v2_plane);
    ksl_vec3_t vo_i;
    ksl_cross_vv(&v1_i, &v2_i, &vo_i);
    ksl_vec3_to_planes(&vo_i, vo + i * vo_stride, vo_plane);
  }
}

/* ksl_cross_vvinv of n elements. */
static KSL_INLINED void ksl_cross_vvinv_many(ptrdiff_t n, const ksl_vec3_t *v1, ptrdiff_t v1_stride,
    const ksl_vec3_t *v2, ptrdiff_t v2_stride, ksl_vec3_t *vo,
    ptrdiff_t vo_stride) {
  KSL_EACH_OF(n) {
    ksl_cross_vvinv(v1 + i * v1_stride, v2 + i * v2_stride, vo + i * vo_stride);
  }
}

static KSL_INLINED void ksl_cross_vvinv_planes(ptrdiff_t n, const double *v1, ptrdiff_t v1_plane,
    ptrdiff_t v1_stride, const double *v2, ptrdiff_t v2_plane,
    ptrdiff_t v2_stride, double *vo, ptrdiff_t vo_plane, ptrdiff_t vo_stride) {
  ksl_vec3_t v1_i;
  if (n > 0) v1_i = ksl_vec3_of_planes(v1, v1_plane);
  KSL_EACH_OF(n) {
    if (v1_stride) v1_i = ksl_vec3_of_planes(v1 + i * v1_stride, v1_plane);
    const ksl_vec3_t v2_i = ksl_vec3_of_planes(v2 + i * v2_stride, v2_plane);
    ksl_vec3_t vo_i;
    ksl_cross_vvinv(&v1_i, &v2_i, &vo_i);
    ksl_vec3_to_planes(&vo_i, vo + i * vo_stride, vo_plane);
  }
}

/* ksl_add_vvx of n elements. */
static KSL_INLINED void ksl_add_vvx_many(ptrdiff_t n, const ksl_vec3_t *v, ptrdiff_t v_stride,
    const double *k, ptrdiff_t k_stride, ksl_vec3_t *vo, ptrdiff_t vo_stride) {
  KSL_EACH_OF(n) {
    ksl_add_vvx(v + i * v_stride, k[i * k_stride], vo + i * vo_stride);
  }
}

static KSL_INLINED void ksl_add_vvx_planes(ptrdiff_t n, const double *v, ptrdiff_t v_plane,
    ptrdiff_t v_stride, const double *k, ptrdiff_t k_stride, double *vo,
    ptrdiff_t vo_plane, ptrdiff_t vo_stride) {
  ksl_vec3_t v_i;
  if (n > 0) v_i = ksl_vec3_of_planes(v, v_plane);
  KSL_EACH_OF(n) {
    if (v_stride) v_i = ksl_vec3_of_planes(v + i * v_stride, v_plane);
    ksl_vec3_t vo_i;
    ksl_add_vvx(&v_i, k[i * k_stride], &vo_i);
    ksl_vec3_to_planes(&vo_i, vo + i * vo_stride, vo_plane);
  }
}

/* ksl_add_vvxinv of n elements. */
static KSL_INLINED void ksl_add_vvxinv_many(ptrdiff_t n, const ksl_vec3_t *v, ptrdiff_t v_stride,
    const double *k, ptrdiff_t k_stride, ksl_vec3_t *vo, ptrdiff_t vo_stride) {
  KSL_EACH_OF(n) {
    ksl_add_vvxinv(v + i * v_stride, k[i * k_stride], vo + i * vo_stride);
  }
}

static KSL_INLINED void ksl_add_vvxinv_planes(ptrdiff_t n, const double *v, ptrdiff_t v_plane,
    ptrdiff_t v_stride, const double *k, ptrdiff_t k_stride, double *vo,
    ptrdiff_t vo_plane, ptrdiff_t vo_stride) {
  ksl_vec3_t v_i;
  if (n > 0) v_i = ksl_vec3_of_planes(v, v_plane);
  KSL_EACH_OF(n) {
    if (v_stride) v_i = ksl_vec3_of_planes(v + i * v_stride, v_plane);
    ksl_vec3_t vo_i;
    ksl_add_vvxinv(&v_i, k[i * k_stride], &vo_i);
    ksl_vec3_to_planes(&vo_i, vo + i * vo_stride, vo_plane);
  }
}

/* ksl_add_vvy of n elements. */
static KSL_INLINED void ksl_add_vvy_many(ptrdiff_t n, const ksl_vec3_t *v, ptrdiff_t v_stride,
    const double *k, ptrdiff_t k_stride, ksl_vec3_t *vo, ptrdiff_t vo_stride) {
  KSL_EACH_OF(n) {
    ksl_add_vvy(v + i * v_stride, k[i * k_stride], vo + i * vo_stride);
  }
}

static KSL_INLINED void ksl_add_vvy_planes(ptrdiff_t n, const double *v, ptrdiff_t v_plane,
    ptrdiff_t v_stride, const double *k, ptrdiff_t k_stride, double *vo,
    ptrdiff_t vo_plane, ptrdiff_t vo_stride) {
  ksl_vec3_t v_i;
  if (n > 0) v_i = ksl_vec3_of_planes(v, v_plane);
  KSL_EACH_OF(n) {
    if (v_stride) v_i = ksl_vec3_of_planes(v + i * v_stride, v_plane);
    ksl_vec3_t vo_i;
    ksl_add_vvy(&v_i, k[i * k_stride], &vo_i);
    ksl_vec3_to_planes(&vo_i, vo + i * vo_stride, vo_plane);
  }
}

/* ksl_add_vvyinv of n elements. */
static KSL_INLINED void ksl_add_vvyinv_many(ptrdiff_t n, const ksl_vec3_t *v, ptrdiff_t v_stride,
    const double *k, ptrdiff_t k_stride, ksl_vec3_t *vo, ptrdiff_t vo_stride) {
  KSL_EACH_OF(n) {
    ksl_add_vvyinv(v + i * v_stride, k[i * k_stride], vo + i * vo_stride);
  }
}

static KSL_INLINED void ksl_add_vvyinv_planes(ptrdiff_t n, const double *v, ptrdiff_t v_plane,
    ptrdiff_t v_stride, const double *k, ptrdiff_t k_stride, double *vo,
    ptrdiff_t vo_plane, ptrdiff_t vo_stride) {
  ksl_vec3_t v_i;
  if (n > 0) v_i = ksl_vec3_of_planes(v, v_plane);
  KSL_EACH_OF(n) {
    if (v_stride) v_i = ksl_vec3_of_planes(v + i * v_stride, v_plane);
    ksl_vec3_t vo_i;
    ksl_add_vvyinv(&v_i, k[i * k_stride], &vo_i);
    ksl_vec3_to_planes(&vo_i, vo + i * vo_stride, vo_plane);
  }
}

/* ksl_add_vvz of n elements. */
static KSL_INLINED void ksl_add_vvz_many(ptrdiff_t n, const ksl_vec3_t *v, ptrdiff_t v_stride,
    const double *k, ptrdiff_t k_stride, ksl_vec3_t *vo, ptrdiff_t vo_stride) {
  KSL_EACH_OF(n) {
    ksl_add_vvz(v + i * v_stride, k[i * k_stride], vo + i * vo_stride);
  }
}

static KSL_INLINED void ksl_add_vvz_planes(ptrdiff_t n, const double *v, ptrdiff_t v_plane,
    ptrdiff_t v_stride, const double *k, ptrdiff_t k_stride, double *vo,
    ptrdiff_t vo_plane, ptrdiff_t vo_stride) {
  ksl_vec3_t v_i;
  if (n > 0) v_i = ksl_vec3_of_planes(v, v_plane);
  KSL_EACH_OF(n) {
    if (v_stride) v_i = ksl_vec3_of_planes(v + i * v_stride, v_plane);
    ksl_vec3_t vo_i;
    ksl_add_vvz(&v_i, k[i * k_stride], &vo_i);
    ksl_vec3_to_planes(&vo_i, vo + i * vo_stride, vo_plane);
  }
}

/* ksl_add_vvzinv of n elements. */
static KSL_INLINED void ksl_add_vvzinv_many(ptrdiff_t n, const ksl_vec3_t *v, ptrdiff_t v_stride,
    const double *k, ptrdiff_t k_stride, ksl_vec3_t *vo, ptrdiff_t vo_stride) {
  KSL_EACH_OF(n) {
    ksl_add_vvzinv(v + i * v_stride, k[i * k_stride], vo + i * vo_stride);
  }
}

static KSL_INLINED void ksl_add_vvzinv_planes(ptrdiff_t n, const double *v, ptrdiff_t v_plane,
    ptrdiff_t v_stride, const double *k, ptrdiff_t k_stride, double *vo,
    ptrdiff_t vo_plane, ptrdiff_t vo_stride) {
  ksl_vec3_t v_i;
  if (n > 0) v_i = ksl_vec3_of_planes(v, v_plane);
  KSL_EACH_OF(n) {
    if (v_stride) v_i = ksl_vec3_of_planes(v + i * v_stride, v_plane);
    ksl_vec3_t vo_i;
    ksl_add_vvzinv(&v_i, k[i * k_stride], &vo_i);
    ksl_vec3_to_planes(&vo_i, vo + i * vo_stride, vo_plane);
  }
}

/* ksl_vec3f_copy of n elements. */
static KSL_INLINED void ksl_vec3f_copy_many(ptrdiff_t n, const ksl_vec3f_t *vi, ptrdiff_t vi_stride,
    ksl_vec3f_t *vo, ptrdiff_t vo_stride) {
  KSL_EACH_OF(n) {
    ksl_vec3f_copy(vi + i * vi_stride, vo + i * vo_stride);
  }
}

static KSL_INLINED void ksl_vec3f_copy_planes(ptrdiff_t n, const float *vi, ptrdiff_t vi_plane,
    ptrdiff_t vi_stride, float *vo, ptrdiff_t vo_plane, ptrdiff_t vo_stride) {
  ksl_vec3f_t vi_i;
  if (n > 0) vi_i = ksl_vec3f_of_planes(vi, vi_plane);
  KSL_EACH_OF(n) {
    if (vi_stride) vi_i = ksl_vec3f_of_planes(vi + i * vi_stride, vi_plane);
    ksl_vec3f_t vo_i;
    ksl_vec3f_copy(&vi_i, &vo_i);
    ksl_vec3f_to_planes(&vo_i, vo + i * vo_stride, vo_plane);
  }
}

/* ksl_vec3f_scale of n elements. */
static KSL_INLINED void ksl_vec3f_scale_many(ptrdiff_t n, ksl_vec3f_t *self, ptrdiff_t self_stride,
    const float *a, ptrdiff_t a_stride) {
  KSL_EACH_OF(n) {
    ksl_vec3f_scale(self + i * self_stride, a[i * a_stride]);
  }
}

static KSL_INLINED void ksl_vec3f_scale_planes(ptrdiff_t n, float *self, ptrdiff_t self_plane,
    ptrdiff_t self_stride, const float *a, ptrdiff_t a_stride) {
  KSL_EACH_OF(n) {
    ksl_vec3f_t self_i = ksl_vec3f_of_planes(self + i * self_stride, self_plane);
    ksl_vec3f_scale(&self_i, a[i * a_stride]);
    ksl_vec3f_to_planes(&self_i, self + i * self_stride, self_plane);
  }
}

/* ksl_vec3f_inverted of n elements. */
static KSL_INLINED void ksl_vec3f_inverted_many(ptrdiff_t n, const ksl_vec3f_t *vi,
    ptrdiff_t vi_stride, ksl_vec3f_t *vo, ptrdiff_t vo_stride) {
  KSL_EACH_OF(n) {
    ksl_vec3f_inverted(vi + i * vi_stride, vo + i * vo_stride);
  }
}

static KSL_INLINED void ksl_vec3f_inverted_planes(ptrdiff_t n, const float *vi, ptrdiff_t vi_plane,
    ptrdiff_t vi_stride, float *vo, ptrdiff_t vo_plane, ptrdiff_t vo_stride) {
  ksl_vec3f_t vi_i;
  if (n > 0) vi_i = ksl_vec3f_of_planes(vi, vi_plane);
  KSL_EACH_OF(n) {
    if (vi_stride) vi_i = ksl_vec3f_of_planes(vi + i * vi_stride, vi_plane);
    ksl_vec3f_t vo_i;
    ksl_vec3f_inverted(&vi_i, &vo_i);
    ksl_vec3f_to_planes(&vo_i, vo + i * vo_stride, vo_plane);
  }
}

/* ksl_vec3f_invert of n elements. */
static KSL_INLINED void ksl_vec3f_invert_many(ptrdiff_t n, ksl_vec3f_t *self, ptrdiff_t self_stride) {
  KSL_EACH_OF(n) {
    ksl_vec3f_invert(self + i * self_stride);
  }
}

static KSL_INLINED void ksl_vec3f_invert_planes(ptrdiff_t n, float *self, ptrdiff_t self_plane,
    ptrdiff_t self_stride) {
  KSL_EACH_OF(n) {
    ksl_vec3f_t self_i = ksl_vec3f_of_planes(self + i * self_stride, self_plane);
    ksl_vec3f_invert(&self_i);
    ksl_vec3f_to_planes(&self_i, self + i * self_stride, self_plane);
  }
}

/* ksl_axpy_vvf of n elements. */
static KSL_INLINED void ksl_axpy_vvf_many(ptrdiff_t n, const float *a, ptrdiff_t a_stride,
    const ksl_vec3f_t *x, ptrdiff_t x_stride, ksl_vec3f_t *y, ptrdiff_t y_stride) {
  KSL_EACH_OF(n) {
    ksl_axpy_vvf(a[i * a_stride], x + i * x_stride, y + i * y_stride);
  }
}

static KSL_INLINED void ksl_axpy_vvf_planes(ptrdiff_t n, const float *a, ptrdiff_t a_stride,
    const float *x, ptrdiff_t x_plane, ptrdiff_t x_stride, float *y,
    ptrdiff_t y_plane, ptrdiff_t y_stride) {
  KSL_EACH_OF(n) {
    const ksl_vec3f_t x_i = ksl_vec3f_of_planes(x + i * x_stride, x_plane);
    ksl_vec3f_t y_i = ksl_vec3f_of_planes(y + i * y_stride, y_plane);
    ksl_axpy_vvf(a[i * a_stride], &x_i, &y_i);
    ksl_vec3f_to_planes(&y_i, y + i * y_stride, y_plane);
  }
}

/* ksl_xpy_vvf of n elements. */
static KSL_INLINED void ksl_xpy_vvf_many(ptrdiff_t n, const ksl_vec3f_t *x, ptrdiff_t x_stride,
    ksl_vec3f_t *y, ptrdiff_t y_stride) {
  KSL_EACH_OF(n) {
    ksl_xpy_vvf(x + i * x_stride, y + i * y_stride);
  }
}

static KSL_INLINED void ksl_xpy_vvf_planes(ptrdiff_t n, const float *x, ptrdiff_t x_plane,
    ptrdiff_t x_stride, float *y, ptrdiff_t y_plane, ptrdiff_t y_stride) {
  ksl_vec3f_t x_i;
  if (n > 0) x_i = ksl_vec3f_of_planes(x, x_plane);
  KSL_EACH_OF(n) {
    if (x_stride) x_i = ksl_vec3f_of_planes(x + i * x_stride, x_plane);
    ksl_vec3f_t y_i = ksl_vec3f_of_planes(y + i * y_stride, y_plane);
    ksl_xpy_vvf(&x_i, &y_i);
    ksl_vec3f_to_planes(&y_i, y + i * y_stride, y_plane);
  }
}

/* ksl_nxpy_vvf of n elements. */
static KSL_INLINED void ksl_nxpy_vvf_many(ptrdiff_t n, const ksl_vec3f_t *x, ptrdiff_t x_stride,
    ksl_vec3f_t *y, ptrdiff_t y_stride) {
  KSL_EACH_OF(n) {
    ksl_nxpy_vvf(x + i * x_stride, y + i * y_stride);
  }
}

static KSL_INLINED void ksl_nxpy_vvf_planes(ptrdiff_t n, const float *x, ptrdiff_t x_plane,
    ptrdiff_t x_stride, float *y, ptrdiff_t y_plane, ptrdiff_t y_stride) {
  ksl_vec3f_t x_i;
  if (n > 0) x_i = ksl_vec3f_of_planes(x, x_plane);
  KSL_EACH_OF(n) {
    if (x_stride) x_i = ksl_vec3f_of_planes(x + i * x_stride, x_plane);
    ksl_vec3f_t y_i = ksl_vec3f_of_planes(y + i * y_stride, y_plane);
    ksl_nxpy_vvf(&x_i, &y_i);
    ksl_vec3f_to_planes(&y_i, y + i * y_stride, y_plane);
  }
}

/* ksl_product_avf of n elements. */
static KSL_INLINED void ksl_product_avf_many(ptrdiff_t n, const float *a, ptrdiff_t a_stride,
    const ksl_vec3f_t *vi, ptrdiff_t vi_stride, ksl_vec3f_t *vo,
    ptrdiff_t vo_stride) {
  KSL_EACH_OF(n) {
    ksl_product_avf(a[i * a_stride], vi + i * vi_stride, vo + i * vo_stride);
  }
}

static KSL_INLINED void ksl_product_avf_planes(ptrdiff_t n, const float *a, ptrdiff_t a_stride,
    const float *vi, ptrdiff_t vi_plane, ptrdiff_t vi_stride, float *vo,
    ptrdiff_t vo_plane, ptrdiff_t vo_stride) {
  KSL_EACH_OF(n) {
    const ksl_vec3f_t vi_i = ksl_vec3f_of_planes(vi + i * vi_stride, vi_plane);
    ksl_vec3f_t vo_i;
    ksl_product_avf(a[i * a_stride], &vi_i, &vo_i);
    ksl_vec3f_to_planes(&vo_i, vo + i * vo_stride, vo_plane);
  }
}

/* ksl_add_vvf of n elements. */
static KSL_INLINED void ksl_add_vvf_many(ptrdiff_t n, const ksl_vec3f_t *v1, ptrdiff_t v1_stride,
    const ksl_vec3f_t *v2, ptrdiff_t v2_stride, ksl_vec3f_t *vo,
    ptrdiff_t vo_stride) {
  KSL_EACH_OF(n) {
    ksl_add_vvf(v1 + i * v1_stride, v2 + i * v2_stride, vo + i * vo_stride);
  }
}

static KSL_INLINED void ksl_add_vvf_planes(ptrdiff_t n, const float *v1, ptrdiff_t v1_plane,
    ptrdiff_t v1_stride, const float *v2, ptrdiff_t v2_plane,
    ptrdiff_t v2_stride, float *vo, ptrdiff_t vo_plane, ptrdiff_t vo_stride) {
  ksl_vec3f_t v1_i;
  if (n > 0) v1_i = ksl_vec3f_of_planes(v1, v1_plane);
  KSL_EACH_OF(n) {
    if (v1_stride) v1_i = ksl_vec3f_of_planes(v1 + i * v1_stride, v1_plane);
    const ksl_vec3f_t v2_i = ksl_vec3f_of_planes(v2 + i * v2_stride, v2_plane);
    ksl_vec3f_t vo_i;
    ksl_add_vvf(&v1_i, &v2_i, &vo_i);
    ksl_vec3f_to_planes(&vo_i, vo + i * vo_stride, vo_plane);
  }
}

/* ksl_subtract_vvf of n elements. */
static KSL_INLINED void ksl_subtract_vvf_many(ptrdiff_t n, const ksl_vec3f_t *v1,
    ptrdiff_t v1_stride, const ksl_vec3f_t *v2, ptrdiff_t v2_stride,
    ksl_vec3f_t *vo, ptrdiff_t vo_stride) {
  KSL_EACH_OF(n) {
    ksl_subtract_vvf(v1 + i * v1_stride, v2 + i * v2_stride, vo + i * vo_stride);
  }
}

static KSL_INLINED void ksl_subtract_vvf_planes(ptrdiff_t n, const float *v1, ptrdiff_t v1_plane,
    ptrdiff_t v1_stride, const float *v2, ptrdiff_t v2_plane,
    ptrdiff_t v2_stride, float *vo, ptrdiff_t vo_plane, ptrdiff_t vo_stride) {
  ksl_vec3f_t v1_i;
  if (n > 0) v1_i = ksl_vec3f_of_planes(v1, v1_plane);
  KSL_EACH_OF(n) {
    if (v1_stride) v1_i = ksl_vec3f_of_planes(v1 + i * v1_stride, v1_plane);
    const ksl_vec3f_t v2_i = ksl_vec3f_of_planes(v2 + i * v2_stride, v2_plane);
    ksl_vec3f_t vo_i;
    ksl_subtract_vvf(&v1_i, &v2_i, &vo_i);
    ksl_vec3f_to_planes(&vo_i, vo + i * vo_stride, vo_plane);
  }
}

/* ksl_vec3f_scaled of n elements. */
static KSL_INLINED void ksl_vec3f_scaled_many(ptrdiff_t n, const ksl_vec3f_t *v, ptrdiff_t v_stride,
    const float *k, ptrdiff_t k_stride, ksl_vec3f_t *vo, ptrdiff_t vo_stride) {
  KSL_EACH_OF(n) {
    ksl_vec3f_scaled(v + i * v_stride, k[i * k_stride], vo + i * vo_stride);
  }
}

static KSL_INLINED void ksl_vec3f_scaled_planes(ptrdiff_t n, const float *v, ptrdiff_t v_plane,
    ptrdiff_t v_stride, const float *k, ptrdiff_t k_stride, float *vo,
    ptrdiff_t vo_plane, ptrdiff_t vo_stride) {
  ksl_vec3f_t v_i;
  if (n > 0) v_i = ksl_vec3f_of_planes(v, v_plane);
  KSL_EACH_OF(n) {
    if (v_stride) v_i = ksl_vec3f_of_planes(v + i * v_stride, v_plane);
    ksl_vec3f_t vo_i;
    ksl_vec3f_scaled(&v_i, k[i * k_stride], &vo_i);
    ksl_vec3f_to_planes(&vo_i, vo + i * vo_stride, vo_plane);
  }
}

/* ksl_vec3f_swap of n elements. */
static KSL_INLINED void ksl_vec3f_swap_many(ptrdiff_t n, ksl_vec3f_t *v1, ptrdiff_t v1_stride,
    ksl_vec3f_t *v2, ptrdiff_t v2_stride) {
  KSL_EACH_OF(n) {
    ksl_vec3f_swap(v1 + i * v1_stride, v2 + i * v2_stride);
  }
}

static KSL_INLINED void ksl_vec3f_swap_planes(ptrdiff_t n, float *v1, ptrdiff_t v1_plane,
    ptrdiff_t v1_stride, float *v2, ptrdiff_t v2_plane, ptrdiff_t v2_stride) {
  KSL_EACH_OF(n) {
    ksl_vec3f_t v1_i = ksl_vec3f_of_planes(v1 + i * v1_stride, v1_plane);
    ksl_vec3f_t v2_i = ksl_vec3f_of_planes(v2 + i * v2_stride, v2_plane);
    ksl_vec3f_swap(&v1_i, &v2_i);
    ksl_vec3f_to_planes(&v1_i, v1 + i * v1_stride, v1_plane);
    ksl_vec3f_to_planes(&v2_i, v2 + i * v2_stride, v2_plane);
  }
}

/* ksl_vec3f_l2norm of n elements. */
static KSL_INLINED void ksl_vec3f_l2norm_many(ptrdiff_t n, const ksl_vec3f_t *v, ptrdiff_t v_stride,
    float *norm, ptrdiff_t norm_stride) {
  KSL_EACH_OF(n) {
    norm[i * norm_stride] = ksl_vec3f_l2norm(v + i * v_stride);
  }
}

static KSL_INLINED void ksl_vec3f_l2norm_planes(ptrdiff_t n, const float *v, ptrdiff_t v_plane,
    ptrdiff_t v_stride, float *norm, ptrdiff_t norm_stride) {
  ksl_vec3f_t v_i;
  if (n > 0) v_i = ksl_vec3f_of_planes(v, v_plane);
  KSL_EACH_OF(n) {
    if (v_stride) v_i = ksl_vec3f_of_planes(v + i * v_stride, v_plane);
    norm[i * norm_stride] = ksl_vec3f_l2norm(&v_i);
  }
}

/* ksl_vec3f_normalize of n elements. */
static KSL_INLINED void ksl_vec3f_normalize_many(ptrdiff_t n, ksl_vec3f_t *self,
    ptrdiff_t self_stride) {
  KSL_EACH_OF(n) {
    ksl_vec3f_normalize(self + i * self_stride);
  }
}

static KSL_INLINED void ksl_vec3f_normalize_planes(ptrdiff_t n, float *self, ptrdiff_t self_plane,
    ptrdiff_t self_stride) {
  KSL_EACH_OF(n) {
    ksl_vec3f_t self_i = ksl_vec3f_of_planes(self + i * self_stride, self_plane);
    ksl_vec3f_normalize(&self_i);
    ksl_vec3f_to_planes(&self_i, self + i * self_stride, self_plane);
  }
}

/* ksl_vec3f_normalized of n elements. */
static KSL_INLINED void ksl_vec3f_normalized_many(ptrdiff_t n, const ksl_vec3f_t *v,
    ptrdiff_t v_stride, ksl_vec3f_t *vo, ptrdiff_t vo_stride) {
  KSL_EACH_OF(n) {
    ksl_vec3f_normalized(v + i * v_stride, vo + i * vo_stride);
  }
}

static KSL_INLINED void ksl_vec3f_normalized_planes(ptrdiff_t n, const float *v, ptrdiff_t v_plane,
    ptrdiff_t v_stride, float *vo, ptrdiff_t vo_plane, ptrdiff_t vo_stride) {
  ksl_vec3f_t v_i;
  if (n > 0) v_i = ksl_vec3f_of_planes(v, v_plane);
  KSL_EACH_OF(n) {
    if (v_stride) v_i = ksl_vec3f_of_planes(v + i * v_stride, v_plane);
    ksl_vec3f_t vo_i;
    ksl_vec3f_normalized(&v_i, &vo_i);
    ksl_vec3f_to_planes(&vo_i, vo + i * vo_stride, vo_plane);
  }
}

/* ksl_angle_vvf of n elements. */
static KSL_INLINED void ksl_angle_vvf_many(ptrdiff_t n, const ksl_vec3f_t *v1, ptrdiff_t v1_stride,
    const ksl_vec3f_t *v2, ptrdiff_t v2_stride, float *angle,
    ptrdiff_t angle_stride) {
  KSL_EACH_OF(n) {
    angle[i * angle_stride] = ksl_angle_vvf(v1 + i * v1_stride, v2 + i * v2_stride);
  }
}

static KSL_INLINED void ksl_angle_vvf_planes(ptrdiff_t n, const float *v1, ptrdiff_t v1_plane,
    ptrdiff_t v1_stride, const float *v2, ptrdiff_t v2_plane,
    ptrdiff_t v2_stride, float *angle, ptrdiff_t angle_stride) {
  ksl_vec3f_t v1_i;
  if (n > 0) v1_i = ksl_vec3f_of_planes(v1, v1_plane);
  KSL_EACH_OF(n) {
    if (v1_stride) v1_i = ksl_vec3f_of_planes(v1 + i * v1_stride, v1_plane);
    const ksl_vec3f_t v2_i = ksl_vec3f_of_planes(v2 + i * v2_stride, v2_plane);
    angle[i * angle_stride] = ksl_angle_vvf(&v1_i, &v2_i);
  }
}

/* ksl_dot_vvf of n elements. */
static KSL_INLINED void ksl_dot_vvf_many(ptrdiff_t n, const ksl_vec3f_t *v1, ptrdiff_t v1_stride,
    const ksl_vec3f_t *v2, ptrdiff_t v2_stride, float *dot, ptrdiff_t dot_stride) {
  KSL_EACH_OF(n) {
    dot[i * dot_stride] = ksl_dot_vvf(v1 + i * v1_stride, v2 + i * v2_stride);
  }
}

static KSL_INLINED void ksl_dot_vvf_planes(ptrdiff_t n, const float *v1, ptrdiff_t v1_plane,
    ptrdiff_t v1_stride, const float *v2, ptrdiff_t v2_plane,
    ptrdiff_t v2_stride, float *dot, ptrdiff_t dot_stride) {
  ksl_vec3f_t v1_i;
  if (n > 0) v1_i = ksl_vec3f_of_planes(v1, v1_plane);
  KSL_EACH_OF(n) {
    if (v1_stride) v1_i = ksl_vec3f_of_planes(v1 + i * v1_stride, v1_plane);
    const ksl_vec3f_t v2_i = ksl_vec3f_of_planes(v2 + i * v2_stride, v2_plane);
    dot[i * dot_stride] = ksl_dot_vvf(&v1_i, &v2_i);
  }
}

/* ksl_product_avinvf of n elements. */
static KSL_INLINED void ksl_product_avinvf_many(ptrdiff_t n, const float *k, ptrdiff_t k_stride,
    const ksl_vec3f_t *v, ptrdiff_t v_stride, ksl_vec3f_t *vo,
    ptrdiff_t vo_stride) {
  KSL_EACH_OF(n) {
    ksl_product_avinvf(k[i * k_stride], v + i * v_stride, vo + i * vo_stride);
  }
}

static KSL_INLINED void ksl_product_avinvf_planes(ptrdiff_t n, const float *k, ptrdiff_t k_stride,
    const float *v, ptrdiff_t v_plane, ptrdiff_t v_stride, float *vo,
    ptrdiff_t vo_plane, ptrdiff_t vo_stride) {
  KSL_EACH_OF(n) {
    const ksl_vec3f_t v_i = ksl_vec3f_of_planes(v + i * v_stride, v_plane);
    ksl_vec3f_t vo_i;
    ksl_product_avinvf(k[i * k_stride], &v_i, &vo_i);
    ksl_vec3f_to_planes(&vo_i, vo + i * vo_stride, vo_plane);
  }
}

/* ksl_product_ainvvf of n elements. */
static KSL_INLINED void ksl_product_ainvvf_many(ptrdiff_t n, const float *k, ptrdiff_t k_stride,
    const ksl_vec3f_t *v, ptrdiff_t v_stride, ksl_vec3f_t *vo,
    ptrdiff_t vo_stride) {
  KSL_EACH_OF(n) {
    ksl_product_ainvvf(k[i * k_stride], v + i * v_stride, vo + i * vo_stride);
  }
}

static KSL_INLINED void ksl_product_ainvvf_planes(ptrdiff_t n, const float *k, ptrdiff_t k_stride,
    const float *v, ptrdiff_t v_plane, ptrdiff_t v_stride, float *vo,
    ptrdiff_t vo_plane, ptrdiff_t vo_stride) {
  KSL_EACH_OF(n) {
    const ksl_vec3f_t v_i = ksl_vec3f_of_planes(v + i * v_stride, v_plane);
    ksl_vec3f_t vo_i;
    ksl_product_ainvvf(k[i * k_stride], &v_i, &vo_i);
    ksl_vec3f_to_planes(&vo_i, vo + i * vo_stride, vo_plane);
  }
}

/* ksl_cross_vvf of n elements. */
static KSL_INLINED void ksl_cross_vvf_many(ptrdiff_t n, const ksl_vec3f_t *v1, ptrdiff_t v1_stride,
    const ksl_vec3f_t *v2, ptrdiff_t v2_stride, ksl_vec3f_t *vo,
    ptrdiff_t vo_stride) {
  KSL_EACH_OF(n) {
    ksl_cross_vvf(v1 + i * v1_stride, v2 + i * v2_stride, vo + i * vo_stride);
  }
}

static KSL_INLINED void ksl_cross_vvf_planes(ptrdiff_t n, const float *v1, ptrdiff_t v1_plane,
    ptrdiff_t v1_stride, const float *v2, ptrdiff_t v2_plane,
    ptrdiff_t v2_stride, float *vo, ptrdiff_t vo_plane, ptrdiff_t vo_stride) {
  ksl_vec3f_t v1_i;
  if (n > 0) v1_i = ksl_vec3f_of_planes(v1, v1_plane);
  KSL_EACH_OF(n) {
    if (v1_stride) v1_i = ksl_vec3f_of_planes(v1 + i * v1_stride, v1_plane);
    const ksl_vec3f_t v2_i = ksl_vec3f_of_planes(v2 + i * v2_stride, v2_plane);
    ksl_vec3f_t vo_i;
    ksl_cross_vvf(&v1_i, &v2_i, &vo_i);
    ksl_vec3f_to_planes(&vo_i, vo + i * vo_stride, vo_plane);
  }
}

/* ksl_cross_vvinvf of n elements. */
static KSL_INLINED void ksl_cross_vvinvf_many(ptrdiff_t n, const ksl_vec3f_t *v1,
    ptrdiff_t v1_stride, const ksl_vec3f_t *v2, ptrdiff_t v2_stride,
    ksl_vec3f_t *vo, ptrdiff_t vo_stride) {
  KSL_EACH_OF(n) {
    ksl_cross_vvinvf(v1 + i * v1_stride, v2 + i * v2_stride, vo + i * vo_stride);
  }
}

static KSL_INLINED void ksl_cross_vvinvf_planes(ptrdiff_t n, const float *v1, ptrdiff_t v1_plane,
    ptrdiff_t v1_stride, const float *v2, ptrdiff_t v2_plane,
    ptrdiff_t v2_stride, float *vo, ptrdiff_t vo_plane, ptrdiff_t vo_stride) {
  ksl_vec3f_t v1_i;
  if (n > 0) v1_i = ksl_vec3f_of_planes(v1, v1_plane);
  KSL_EACH_OF(n) {
    if (v1_stride) v1_i = ksl_vec3f_of_planes(v1 + i * v1_stride, v1_plane);
    const ksl_vec3f_t v2_i = ksl_vec3f_of_planes(v2 + i * v2_stride, v2_plane);
    ksl_vec3f_t vo_i;
    ksl_cross_vvinvf(&v1_i, &v2_i, &vo_i);
    ksl_vec3f_to_planes(&vo_i, vo + i * vo_stride, vo_plane);
  }
}

/* ksl_add_vvxf of n elements. */
static KSL_INLINED void ksl_add_vvxf_many(ptrdiff_t n, const ksl_vec3f_t *v, ptrdiff_t v_stride,
    const float *k, ptrdiff_t k_stride, ksl_vec3f_t *vo, ptrdiff_t vo_stride) {
  KSL_EACH_OF(n) {
    ksl_add_vvxf(v + i * v_stride, k[i * k_stride], vo + i * vo_stride);
  }
}

static KSL_INLINED void ksl_add_vvxf_planes(ptrdiff_t n, const float *v, ptrdiff_t v_plane,
    ptrdiff_t v_stride, const float *k, ptrdiff_t k_stride, float *vo,
    ptrdiff_t vo_plane, ptrdiff_t vo_stride) {
  ksl_vec3f_t v_i;
  if (n > 0) v_i = ksl_vec3f_of_planes(v, v_plane);
  KSL_EACH_OF(n) {
    if (v_stride) v_i = ksl_vec3f_of_planes(v + i * v_stride, v_plane);
    ksl_vec3f_t vo_i;
    ksl_add_vvxf(&v_i, k[i * k_stride], &vo_i);
    ksl_vec3f_to_planes(&vo_i, vo + i * vo_stride, vo_plane);
  }
}

/* ksl_add_vvxinvf of n elements. */
static KSL_INLINED void ksl_add_vvxinvf_many(ptrdiff_t n, const ksl_vec3f_t *v, ptrdiff_t v_stride,
    const float *k, ptrdiff_t k_stride, ksl_vec3f_t *vo, ptrdiff_t vo_stride) {
  KSL_EACH_OF(n) {
    ksl_add_vvxinvf(v + i * v_stride, k[i * k_stride], vo + i * vo_stride);
  }
}

static KSL_INLINED void ksl_add_vvxinvf_planes(ptrdiff_t n, const float *v, ptrdiff_t v_plane,
    ptrdiff_t v_stride, const float *k, ptrdiff_t k_stride, float *vo,
    ptrdiff_t vo_plane, ptrdiff_t vo_stride) {
  ksl_vec3f_t v_i;
  if (n > 0) v_i = ksl_vec3f_of_planes(v, v_plane);
  KSL_EACH_OF(n) {
    if (v_stride) v_i = ksl_vec3f_of_planes(v + i * v_stride, v_plane);
    ksl_vec3f_t vo_i;
    ksl_add_vvxinvf(&v_i, k[i * k_stride], &vo_i);
    ksl_vec3f_to_planes(&vo_i, vo + i * vo_stride, vo_plane);
  }
}

/* ksl_add_vvyf of n elements. */
static KSL_INLINED void ksl_add_vvyf_many(ptrdiff_t n, const ksl_vec3f_t *v, ptrdiff_t v_stride,
    const float *k, ptrdiff_t k_stride, ksl_vec3f_t *vo, ptrdiff_t vo_stride) {
  KSL_EACH_OF(n) {
    ksl_add_vvyf(v + i * v_stride, k[i * k_stride], vo + i * vo_stride);
  }
}

static KSL_INLINED void ksl_add_vvyf_planes(ptrdiff_t n, const float *v, ptrdiff_t v_plane,
    ptrdiff_t v_stride, const float *k, ptrdiff_t k_stride, float *vo,
    ptrdiff_t vo_plane, ptrdiff_t vo_stride) {
  ksl_vec3f_t v_i;
  if (n > 0) v_i = ksl_vec3f_of_planes(v, v_plane);
  KSL_EACH_OF(n) {
    if (v_stride) v_i = ksl_vec3f_of_planes(v + i * v_stride, v_plane);
    ksl_vec3f_t vo_i;
    ksl_add_vvyf(&v_i, k[i * k_stride], &vo_i);
    ksl_vec3f_to_planes(&vo_i, vo + i * vo_stride, vo_plane);
  }
}

/* ksl_add_vvyinvf of n elements. */
static KSL_INLINED void ksl_add_vvyinvf_many(ptrdiff_t n, const ksl_vec3f_t *v, ptrdiff_t v_stride,
    const float *k, ptrdiff_t k_stride, ksl_vec3f_t *vo, ptrdiff_t vo_stride) {
  KSL_EACH_OF(n) {
    ksl_add_vvyinvf(v + i * v_stride, k[i * k_stride], vo + i * vo_stride);
  }
}

static KSL_INLINED void ksl_add_vvyinvf_planes(ptrdiff_t n, const float *v, ptrdiff_t v_plane,
    ptrdiff_t v_stride, const float *k, ptrdiff_t k_stride, float *vo,
    ptrdiff_t vo_plane, ptrdiff_t vo_stride) {
  ksl_vec3f_t v_i;
  if (n > 0) v_i = ksl_vec3f_of_planes(v, v_plane);
  KSL_EACH_OF(n) {
    if (v_stride) v_i = ksl_vec3f_of_planes(v + i * v_stride, v_plane);
    ksl_vec3f_t vo_i;
    ksl_add_vvyinvf(&v_i, k[i * k_stride], &vo_i);
    ksl_vec3f_to_planes(&vo_i, vo + i * vo_stride, vo_plane);
  }
}

/* ksl_add_vvzf of n elements. */
static KSL_INLINED void ksl_add_vvzf_many(ptrdiff_t n, const ksl_vec3f_t *v, ptrdiff_t v_stride,
    const float *k, ptrdiff_t k_stride, ksl_vec3f_t *vo, ptrdiff_t vo_stride) {
  KSL_EACH_OF(n) {
    ksl_add_vvzf(v + i * v_stride, k[i * k_stride], vo + i * vo_stride);
  }
}

static KSL_INLINED void ksl_add_vvzf_planes(ptrdiff_t n, const float *v, ptrdiff_t v_plane,
    ptrdiff_t v_stride, const float *k, ptrdiff_t k_stride, float *vo,
    ptrdiff_t vo_plane, ptrdiff_t vo_stride) {
  ksl_vec3f_t v_i;
  if (n > 0) v_i = ksl_vec3f_of_planes(v, v_plane);
  KSL_EACH_OF(n) {
    if (v_stride) v_i = ksl_vec3f_of_planes(v + i * v_stride, v_plane);
    ksl_vec3f_t vo_i;
    ksl_add_vvzf(&v_i, k[i * k_stride], &vo_i);
    ksl_vec3f_to_planes(&vo_i, vo + i * vo_stride, vo_plane);
  }
}

/* ksl_add_vvzinvf of n elements. */
static KSL_INLINED void ksl_add_vvzinvf_many(ptrdiff_t n, const ksl_vec3f_t *v, ptrdiff_t v_stride,
    const float *k, ptrdiff_t k_stride, ksl_vec3f_t *vo, ptrdiff_t vo_stride) {
  KSL_EACH_OF(n) {
    ksl_add_vvzinvf(v + i * v_stride, k[i * k_stride], vo + i * vo_stride);
  }
}

static KSL_INLINED void ksl_add_vvzinvf_planes(ptrdiff_t n, const float *v, ptrdiff_t v_plane,
    ptrdiff_t v_stride, const float *k, ptrdiff_t k_stride, float *vo,
    ptrdiff_t vo_plane, ptrdiff_t vo_stride) {
  ksl_vec3f_t v_i;
  if (n > 0) v_i = ksl_vec3f_of_planes(v, v_plane);
  KSL_EACH_OF(n) {
    if (v_stride) v_i = ksl_vec3f_of_planes(v + i * v_stride, v_plane);
    ksl_vec3f_t vo_i;
    ksl_add_vvzinvf(&v_i, k[i * k_stride], &vo_i);
    ksl_vec3f_to_planes(&vo_i, vo + i * vo_stride, vo_plane);
  }
}

#endif
