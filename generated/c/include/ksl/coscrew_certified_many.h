/* Made by `coscrew generate`; changes are overwritten. */
/* SPDX-License-Identifier: MIT */
/* coscrew 0.2.0.  Copyright (c) 2026 The coscrew authors. */
/* Coscrews: wrenches and momenta, c = (f; τ).  Many at a time.
   What arguments are, and what loops over them cost, ksl_planes.h says. */
#ifndef KSL_COSCREW_CERTIFIED_MANY_H
#define KSL_COSCREW_CERTIFIED_MANY_H

#include "coscrew_certified.h"
#include "ksl_planes.h"

/* ksl_coscrew_scale_certified of n elements. */
static KSL_INLINED void ksl_coscrew_scale_certified_many(ptrdiff_t n, ksl_coscrew_t *self,
    ptrdiff_t self_stride, const double *a, ptrdiff_t a_stride,
    ksl_coscrew_t *self_bound, ptrdiff_t self_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_coscrew_scale_certified(self + i * self_stride, a[i * a_stride],
        self_bound + i * self_bound_stride);
  }
}

static KSL_INLINED void ksl_coscrew_scale_certified_planes(ptrdiff_t n, double *self,
    ptrdiff_t self_plane, ptrdiff_t self_stride, const double *a,
    ptrdiff_t a_stride, double *self_bound, ptrdiff_t self_bound_plane,
    ptrdiff_t self_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_coscrew_t self_i = ksl_coscrew_of_planes(self + i * self_stride, self_plane);
    ksl_coscrew_t self_bound_i;
    ksl_coscrew_scale_certified(&self_i, a[i * a_stride], &self_bound_i);
    ksl_coscrew_to_planes(&self_i, self + i * self_stride, self_plane);
    ksl_coscrew_to_planes(&self_bound_i, self_bound + i * self_bound_stride, self_bound_plane);
  }
}

/* ksl_axpy_cc_certified of n elements. */
static KSL_INLINED void ksl_axpy_cc_certified_many(ptrdiff_t n, const double *a, ptrdiff_t a_stride,
    const ksl_coscrew_t *x, ptrdiff_t x_stride, ksl_coscrew_t *y,
    ptrdiff_t y_stride, ksl_coscrew_t *y_bound, ptrdiff_t y_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_axpy_cc_certified(a[i * a_stride], x + i * x_stride, y + i * y_stride,
        y_bound + i * y_bound_stride);
  }
}

static KSL_INLINED void ksl_axpy_cc_certified_planes(ptrdiff_t n, const double *a,
    ptrdiff_t a_stride, const double *x, ptrdiff_t x_plane, ptrdiff_t x_stride,
    double *y, ptrdiff_t y_plane, ptrdiff_t y_stride, double *y_bound,
    ptrdiff_t y_bound_plane, ptrdiff_t y_bound_stride) {
  KSL_EACH_OF(n) {
    const ksl_coscrew_t x_i = ksl_coscrew_of_planes(x + i * x_stride, x_plane);
    ksl_coscrew_t y_i = ksl_coscrew_of_planes(y + i * y_stride, y_plane);
    ksl_coscrew_t y_bound_i;
    ksl_axpy_cc_certified(a[i * a_stride], &x_i, &y_i, &y_bound_i);
    ksl_coscrew_to_planes(&y_i, y + i * y_stride, y_plane);
    ksl_coscrew_to_planes(&y_bound_i, y_bound + i * y_bound_stride, y_bound_plane);
  }
}

/* ksl_xpy_cc_certified of n elements. */
static KSL_INLINED void ksl_xpy_cc_certified_many(ptrdiff_t n, const ksl_coscrew_t *x,
    ptrdiff_t x_stride, ksl_coscrew_t *y, ptrdiff_t y_stride,
    ksl_coscrew_t *y_bound, ptrdiff_t y_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_xpy_cc_certified(x + i * x_stride, y + i * y_stride, y_bound + i * y_bound_stride);
  }
}

static KSL_INLINED void ksl_xpy_cc_certified_planes(ptrdiff_t n, const double *x, ptrdiff_t x_plane,
    ptrdiff_t x_stride, double *y, ptrdiff_t y_plane, ptrdiff_t y_stride,
    double *y_bound, ptrdiff_t y_bound_plane, ptrdiff_t y_bound_stride) {
  ksl_coscrew_t x_i;
  if (n > 0) x_i = ksl_coscrew_of_planes(x, x_plane);
  KSL_EACH_OF(n) {
    if (x_stride) x_i = ksl_coscrew_of_planes(x + i * x_stride, x_plane);
    ksl_coscrew_t y_i = ksl_coscrew_of_planes(y + i * y_stride, y_plane);
    ksl_coscrew_t y_bound_i;
    ksl_xpy_cc_certified(&x_i, &y_i, &y_bound_i);
    ksl_coscrew_to_planes(&y_i, y + i * y_stride, y_plane);
    ksl_coscrew_to_planes(&y_bound_i, y_bound + i * y_bound_stride, y_bound_plane);
  }
}

/* ksl_nxpy_cc_certified of n elements. */
static KSL_INLINED void ksl_nxpy_cc_certified_many(ptrdiff_t n, const ksl_coscrew_t *x,
    ptrdiff_t x_stride, ksl_coscrew_t *y, ptrdiff_t y_stride,
    ksl_coscrew_t *y_bound, ptrdiff_t y_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_nxpy_cc_certified(x + i * x_stride, y + i * y_stride, y_bound + i * y_bound_stride);
  }
}

static KSL_INLINED void ksl_nxpy_cc_certified_planes(ptrdiff_t n, const double *x,
    ptrdiff_t x_plane, ptrdiff_t x_stride, double *y, ptrdiff_t y_plane,
    ptrdiff_t y_stride, double *y_bound, ptrdiff_t y_bound_plane,
    ptrdiff_t y_bound_stride) {
  ksl_coscrew_t x_i;
  if (n > 0) x_i = ksl_coscrew_of_planes(x, x_plane);
  KSL_EACH_OF(n) {
    if (x_stride) x_i = ksl_coscrew_of_planes(x + i * x_stride, x_plane);
    ksl_coscrew_t y_i = ksl_coscrew_of_planes(y + i * y_stride, y_plane);
    ksl_coscrew_t y_bound_i;
    ksl_nxpy_cc_certified(&x_i, &y_i, &y_bound_i);
    ksl_coscrew_to_planes(&y_i, y + i * y_stride, y_plane);
    ksl_coscrew_to_planes(&y_bound_i, y_bound + i * y_bound_stride, y_bound_plane);
  }
}

/* ksl_product_ac_certified of n elements. */
static KSL_INLINED void ksl_product_ac_certified_many(ptrdiff_t n, const double *a,
    ptrdiff_t a_stride, const ksl_coscrew_t *ci, ptrdiff_t ci_stride,
    ksl_coscrew_t *co, ptrdiff_t co_stride, ksl_coscrew_t *co_bound,
    ptrdiff_t co_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_product_ac_certified(a[i * a_stride], ci + i * ci_stride, co + i * co_stride,
        co_bound + i * co_bound_stride);
  }
}

static KSL_INLINED void ksl_product_ac_certified_planes(ptrdiff_t n, const double *a,
    ptrdiff_t a_stride, const double *ci, ptrdiff_t ci_plane,
    ptrdiff_t ci_stride, double *co, ptrdiff_t co_plane, ptrdiff_t co_stride,
    double *co_bound, ptrdiff_t co_bound_plane, ptrdiff_t co_bound_stride) {
  KSL_EACH_OF(n) {
    const ksl_coscrew_t ci_i = ksl_coscrew_of_planes(ci + i * ci_stride, ci_plane);
    ksl_coscrew_t co_i;
    ksl_coscrew_t co_bound_i;
    ksl_product_ac_certified(a[i * a_stride], &ci_i, &co_i, &co_bound_i);
    ksl_coscrew_to_planes(&co_i, co + i * co_stride, co_plane);
    ksl_coscrew_to_planes(&co_bound_i, co_bound + i * co_bound_stride, co_bound_plane);
  }
}

/* ksl_add_cc_certified of n elements. */
static KSL_INLINED void ksl_add_cc_certified_many(ptrdiff_t n, const ksl_coscrew_t *c1,
    ptrdiff_t c1_stride, const ksl_coscrew_t *c2, ptrdiff_t c2_stride,
    ksl_coscrew_t *co, ptrdiff_t co_stride, ksl_coscrew_t *co_bound,
    ptrdiff_t co_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_add_cc_certified(c1 + i * c1_stride, c2 + i * c2_stride, co + i * co_stride,
        co_bound + i * co_bound_stride);
  }
}

static KSL_INLINED void ksl_add_cc_certified_planes(ptrdiff_t n, const double *c1,
    ptrdiff_t c1_plane, ptrdiff_t c1_stride, const double *c2,
    ptrdiff_t c2_plane, ptrdiff_t c2_stride, double *co, ptrdiff_t co_plane,
    ptrdiff_t co_stride, double *co_bound, ptrdiff_t co_bound_plane,
    ptrdiff_t co_bound_stride) {
  ksl_coscrew_t c1_i;
  if (n > 0) c1_i = ksl_coscrew_of_planes(c1, c1_plane);
  KSL_EACH_OF(n) {
    if (c1_stride) c1_i = ksl_coscrew_of_planes(c1 + i * c1_stride, c1_plane);
    const ksl_coscrew_t c2_i = ksl_coscrew_of_planes(c2 + i * c2_stride, c2_plane);
    ksl_coscrew_t co_i;
    ksl_coscrew_t co_bound_i;
    ksl_add_cc_certified(&c1_i, &c2_i, &co_i, &co_bound_i);
    ksl_coscrew_to_planes(&co_i, co + i * co_stride, co_plane);
    ksl_coscrew_to_planes(&co_bound_i, co_bound + i * co_bound_stride, co_bound_plane);
  }
}

/* ksl_subtract_cc_certified of n elements. */
static KSL_INLINED void ksl_subtract_cc_certified_many(ptrdiff_t n, const ksl_coscrew_t *c1,
    ptrdiff_t c1_stride, const ksl_coscrew_t *c2, ptrdiff_t c2_stride,
    ksl_coscrew_t *co, ptrdiff_t co_stride, ksl_coscrew_t *co_bound,
    ptrdiff_t co_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_subtract_cc_certified(c1 + i * c1_stride, c2 + i * c2_stride, co + i * co_stride,
        co_bound + i * co_bound_stride);
  }
}

static KSL_INLINED void ksl_subtract_cc_certified_planes(ptrdiff_t n, const double *c1,
    ptrdiff_t c1_plane, ptrdiff_t c1_stride, const double *c2,
    ptrdiff_t c2_plane, ptrdiff_t c2_stride, double *co, ptrdiff_t co_plane,
    ptrdiff_t co_stride, double *co_bound, ptrdiff_t co_bound_plane,
    ptrdiff_t co_bound_stride) {
  ksl_coscrew_t c1_i;
  if (n > 0) c1_i = ksl_coscrew_of_planes(c1, c1_plane);
  KSL_EACH_OF(n) {
    if (c1_stride) c1_i = ksl_coscrew_of_planes(c1 + i * c1_stride, c1_plane);
    const ksl_coscrew_t c2_i = ksl_coscrew_of_planes(c2 + i * c2_stride, c2_plane);
    ksl_coscrew_t co_i;
    ksl_coscrew_t co_bound_i;
    ksl_subtract_cc_certified(&c1_i, &c2_i, &co_i, &co_bound_i);
    ksl_coscrew_to_planes(&co_i, co + i * co_stride, co_plane);
    ksl_coscrew_to_planes(&co_bound_i, co_bound + i * co_bound_stride, co_bound_plane);
  }
}

/* ksl_add_cct_certified of n elements. */
static KSL_INLINED void ksl_add_cct_certified_many(ptrdiff_t n, const ksl_coscrew_t *c1,
    ptrdiff_t c1_stride, const ksl_coscrew_t *c2, ptrdiff_t c2_stride,
    ksl_coscrew_t *co, ptrdiff_t co_stride, ksl_coscrew_t *co_bound,
    ptrdiff_t co_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_add_cct_certified(c1 + i * c1_stride, c2 + i * c2_stride, co + i * co_stride,
        co_bound + i * co_bound_stride);
  }
}

static KSL_INLINED void ksl_add_cct_certified_planes(ptrdiff_t n, const double *c1,
    ptrdiff_t c1_plane, ptrdiff_t c1_stride, const double *c2,
    ptrdiff_t c2_plane, ptrdiff_t c2_stride, double *co, ptrdiff_t co_plane,
    ptrdiff_t co_stride, double *co_bound, ptrdiff_t co_bound_plane,
    ptrdiff_t co_bound_stride) {
  ksl_coscrew_t c1_i;
  if (n > 0) c1_i = ksl_coscrew_of_planes(c1, c1_plane);
  KSL_EACH_OF(n) {
    if (c1_stride) c1_i = ksl_coscrew_of_planes(c1 + i * c1_stride, c1_plane);
    const ksl_coscrew_t c2_i = ksl_coscrew_of_planes(c2 + i * c2_stride, c2_plane);
    ksl_coscrew_t co_i;
    ksl_coscrew_t co_bound_i;
    ksl_add_cct_certified(&c1_i, &c2_i, &co_i, &co_bound_i);
    ksl_coscrew_to_planes(&co_i, co + i * co_stride, co_plane);
    ksl_coscrew_to_planes(&co_bound_i, co_bound + i * co_bound_stride, co_bound_plane);
  }
}

/* ksl_product_CoAdtc_certified of n elements. */
static KSL_INLINED void ksl_product_CoAdtc_certified_many(ptrdiff_t n, const ksl_vec3_t *t,
    ptrdiff_t t_stride, const ksl_coscrew_t *ci, ptrdiff_t ci_stride,
    ksl_coscrew_t *co, ptrdiff_t co_stride, ksl_coscrew_t *co_bound,
    ptrdiff_t co_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_product_CoAdtc_certified(t + i * t_stride, ci + i * ci_stride, co + i * co_stride,
        co_bound + i * co_bound_stride);
  }
}

static KSL_INLINED void ksl_product_CoAdtc_certified_planes(ptrdiff_t n, const double *t,
    ptrdiff_t t_plane, ptrdiff_t t_stride, const double *ci, ptrdiff_t ci_plane,
    ptrdiff_t ci_stride, double *co, ptrdiff_t co_plane, ptrdiff_t co_stride,
    double *co_bound, ptrdiff_t co_bound_plane, ptrdiff_t co_bound_stride) {
  ksl_vec3_t t_i;
  if (n > 0) t_i = ksl_vec3_of_planes(t, t_plane);
  KSL_EACH_OF(n) {
    if (t_stride) t_i = ksl_vec3_of_planes(t + i * t_stride, t_plane);
    const ksl_coscrew_t ci_i = ksl_coscrew_of_planes(ci + i * ci_stride, ci_plane);
    ksl_coscrew_t co_i;
    ksl_coscrew_t co_bound_i;
    ksl_product_CoAdtc_certified(&t_i, &ci_i, &co_i, &co_bound_i);
    ksl_coscrew_to_planes(&co_i, co + i * co_stride, co_plane);
    ksl_coscrew_to_planes(&co_bound_i, co_bound + i * co_bound_stride, co_bound_plane);
  }
}

/* ksl_product_CoAdtinvc_certified of n elements. */
static KSL_INLINED void ksl_product_CoAdtinvc_certified_many(ptrdiff_t n, const ksl_vec3_t *t,
    ptrdiff_t t_stride, const ksl_coscrew_t *ci, ptrdiff_t ci_stride,
    ksl_coscrew_t *co, ptrdiff_t co_stride, ksl_coscrew_t *co_bound,
    ptrdiff_t co_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_product_CoAdtinvc_certified(t + i * t_stride, ci + i * ci_stride, co + i * co_stride,
        co_bound + i * co_bound_stride);
  }
}

static KSL_INLINED void ksl_product_CoAdtinvc_certified_planes(ptrdiff_t n, const double *t,
    ptrdiff_t t_plane, ptrdiff_t t_stride, const double *ci, ptrdiff_t ci_plane,
    ptrdiff_t ci_stride, double *co, ptrdiff_t co_plane, ptrdiff_t co_stride,
    double *co_bound, ptrdiff_t co_bound_plane, ptrdiff_t co_bound_stride) {
  ksl_vec3_t t_i;
  if (n > 0) t_i = ksl_vec3_of_planes(t, t_plane);
  KSL_EACH_OF(n) {
    if (t_stride) t_i = ksl_vec3_of_planes(t + i * t_stride, t_plane);
    const ksl_coscrew_t ci_i = ksl_coscrew_of_planes(ci + i * ci_stride, ci_plane);
    ksl_coscrew_t co_i;
    ksl_coscrew_t co_bound_i;
    ksl_product_CoAdtinvc_certified(&t_i, &ci_i, &co_i, &co_bound_i);
    ksl_coscrew_to_planes(&co_i, co + i * co_stride, co_plane);
    ksl_coscrew_to_planes(&co_bound_i, co_bound + i * co_bound_stride, co_bound_plane);
  }
}

/* ksl_product_CoAdtcinv_certified of n elements. */
static KSL_INLINED void ksl_product_CoAdtcinv_certified_many(ptrdiff_t n, const ksl_vec3_t *t,
    ptrdiff_t t_stride, const ksl_coscrew_t *ci, ptrdiff_t ci_stride,
    ksl_coscrew_t *co, ptrdiff_t co_stride, ksl_coscrew_t *co_bound,
    ptrdiff_t co_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_product_CoAdtcinv_certified(t + i * t_stride, ci + i * ci_stride, co + i * co_stride,
        co_bound + i * co_bound_stride);
  }
}

static KSL_INLINED void ksl_product_CoAdtcinv_certified_planes(ptrdiff_t n, const double *t,
    ptrdiff_t t_plane, ptrdiff_t t_stride, const double *ci, ptrdiff_t ci_plane,
    ptrdiff_t ci_stride, double *co, ptrdiff_t co_plane, ptrdiff_t co_stride,
    double *co_bound, ptrdiff_t co_bound_plane, ptrdiff_t co_bound_stride) {
  ksl_vec3_t t_i;
  if (n > 0) t_i = ksl_vec3_of_planes(t, t_plane);
  KSL_EACH_OF(n) {
    if (t_stride) t_i = ksl_vec3_of_planes(t + i * t_stride, t_plane);
    const ksl_coscrew_t ci_i = ksl_coscrew_of_planes(ci + i * ci_stride, ci_plane);
    ksl_coscrew_t co_i;
    ksl_coscrew_t co_bound_i;
    ksl_product_CoAdtcinv_certified(&t_i, &ci_i, &co_i, &co_bound_i);
    ksl_coscrew_to_planes(&co_i, co + i * co_stride, co_plane);
    ksl_coscrew_to_planes(&co_bound_i, co_bound + i * co_bound_stride, co_bound_plane);
  }
}

/* ksl_product_CoAdrc_certified of n elements. */
static KSL_INLINED void ksl_product_CoAdrc_certified_many(ptrdiff_t n, const ksl_mat3x3_t *R,
    ptrdiff_t R_stride, const ksl_coscrew_t *ci, ptrdiff_t ci_stride,
    ksl_coscrew_t *co, ptrdiff_t co_stride, ksl_coscrew_t *co_bound,
    ptrdiff_t co_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_product_CoAdrc_certified(R + i * R_stride, ci + i * ci_stride, co + i * co_stride,
        co_bound + i * co_bound_stride);
  }
}

static KSL_INLINED void ksl_product_CoAdrc_certified_planes(ptrdiff_t n, const double *R,
    ptrdiff_t R_plane, ptrdiff_t R_stride, const double *ci, ptrdiff_t ci_plane,
    ptrdiff_t ci_stride, double *co, ptrdiff_t co_plane, ptrdiff_t co_stride,
    double *co_bound, ptrdiff_t co_bound_plane, ptrdiff_t co_bound_stride) {
  ksl_mat3x3_t R_i;
  if (n > 0) R_i = ksl_mat3x3_of_planes(R, R_plane);
  KSL_EACH_OF(n) {
    if (R_stride) R_i = ksl_mat3x3_of_planes(R + i * R_stride, R_plane);
    const ksl_coscrew_t ci_i = ksl_coscrew_of_planes(ci + i * ci_stride, ci_plane);
    ksl_coscrew_t co_i;
    ksl_coscrew_t co_bound_i;
    ksl_product_CoAdrc_certified(&R_i, &ci_i, &co_i, &co_bound_i);
    ksl_coscrew_to_planes(&co_i, co + i * co_stride, co_plane);
    ksl_coscrew_to_planes(&co_bound_i, co_bound + i * co_bound_stride, co_bound_plane);
  }
}

/* ksl_product_CoAdrinvc_certified of n elements. */
static KSL_INLINED void ksl_product_CoAdrinvc_certified_many(ptrdiff_t n, const ksl_mat3x3_t *R,
    ptrdiff_t R_stride, const ksl_coscrew_t *ci, ptrdiff_t ci_stride,
    ksl_coscrew_t *co, ptrdiff_t co_stride, ksl_coscrew_t *co_bound,
    ptrdiff_t co_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_product_CoAdrinvc_certified(R + i * R_stride, ci + i * ci_stride, co + i * co_stride,
        co_bound + i * co_bound_stride);
  }
}

static KSL_INLINED void ksl_product_CoAdrinvc_certified_planes(ptrdiff_t n, const double *R,
    ptrdiff_t R_plane, ptrdiff_t R_stride, const double *ci, ptrdiff_t ci_plane,
    ptrdiff_t ci_stride, double *co, ptrdiff_t co_plane, ptrdiff_t co_stride,
    double *co_bound, ptrdiff_t co_bound_plane, ptrdiff_t co_bound_stride) {
  ksl_mat3x3_t R_i;
  if (n > 0) R_i = ksl_mat3x3_of_planes(R, R_plane);
  KSL_EACH_OF(n) {
    if (R_stride) R_i = ksl_mat3x3_of_planes(R + i * R_stride, R_plane);
    const ksl_coscrew_t ci_i = ksl_coscrew_of_planes(ci + i * ci_stride, ci_plane);
    ksl_coscrew_t co_i;
    ksl_coscrew_t co_bound_i;
    ksl_product_CoAdrinvc_certified(&R_i, &ci_i, &co_i, &co_bound_i);
    ksl_coscrew_to_planes(&co_i, co + i * co_stride, co_plane);
    ksl_coscrew_to_planes(&co_bound_i, co_bound + i * co_bound_stride, co_bound_plane);
  }
}

/* ksl_product_CoAdrcinv_certified of n elements. */
static KSL_INLINED void ksl_product_CoAdrcinv_certified_many(ptrdiff_t n, const ksl_mat3x3_t *R,
    ptrdiff_t R_stride, const ksl_coscrew_t *ci, ptrdiff_t ci_stride,
    ksl_coscrew_t *co, ptrdiff_t co_stride, ksl_coscrew_t *co_bound,
    ptrdiff_t co_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_product_CoAdrcinv_certified(R + i * R_stride, ci + i * ci_stride, co + i * co_stride,
        co_bound + i * co_bound_stride);
  }
}

static KSL_INLINED void ksl_product_CoAdrcinv_certified_planes(ptrdiff_t n, const double *R,
    ptrdiff_t R_plane, ptrdiff_t R_stride, const double *ci, ptrdiff_t ci_plane,
    ptrdiff_t ci_stride, double *co, ptrdiff_t co_plane, ptrdiff_t co_stride,
    double *co_bound, ptrdiff_t co_bound_plane, ptrdiff_t co_bound_stride) {
  ksl_mat3x3_t R_i;
  if (n > 0) R_i = ksl_mat3x3_of_planes(R, R_plane);
  KSL_EACH_OF(n) {
    if (R_stride) R_i = ksl_mat3x3_of_planes(R + i * R_stride, R_plane);
    const ksl_coscrew_t ci_i = ksl_coscrew_of_planes(ci + i * ci_stride, ci_plane);
    ksl_coscrew_t co_i;
    ksl_coscrew_t co_bound_i;
    ksl_product_CoAdrcinv_certified(&R_i, &ci_i, &co_i, &co_bound_i);
    ksl_coscrew_to_planes(&co_i, co + i * co_stride, co_plane);
    ksl_coscrew_to_planes(&co_bound_i, co_bound + i * co_bound_stride, co_bound_plane);
  }
}

/* ksl_product_CoAdc_certified of n elements. */
static KSL_INLINED void ksl_product_CoAdc_certified_many(ptrdiff_t n, const ksl_SE3_t *D,
    ptrdiff_t D_stride, const ksl_coscrew_t *ci, ptrdiff_t ci_stride,
    ksl_coscrew_t *co, ptrdiff_t co_stride, ksl_coscrew_t *co_bound,
    ptrdiff_t co_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_product_CoAdc_certified(D + i * D_stride, ci + i * ci_stride, co + i * co_stride,
        co_bound + i * co_bound_stride);
  }
}

static KSL_INLINED void ksl_product_CoAdc_certified_planes(ptrdiff_t n, const double *D,
    ptrdiff_t D_plane, ptrdiff_t D_stride, const double *ci, ptrdiff_t ci_plane,
    ptrdiff_t ci_stride, double *co, ptrdiff_t co_plane, ptrdiff_t co_stride,
    double *co_bound, ptrdiff_t co_bound_plane, ptrdiff_t co_bound_stride) {
  ksl_SE3_t D_i;
  if (n > 0) D_i = ksl_SE3_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3_of_planes(D + i * D_stride, D_plane);
    const ksl_coscrew_t ci_i = ksl_coscrew_of_planes(ci + i * ci_stride, ci_plane);
    ksl_coscrew_t co_i;
    ksl_coscrew_t co_bound_i;
    ksl_product_CoAdc_certified(&D_i, &ci_i, &co_i, &co_bound_i);
    ksl_coscrew_to_planes(&co_i, co + i * co_stride, co_plane);
    ksl_coscrew_to_planes(&co_bound_i, co_bound + i * co_bound_stride, co_bound_plane);
  }
}

/* ksl_product_CoAdinvc_certified of n elements. */
static KSL_INLINED void ksl_product_CoAdinvc_certified_many(ptrdiff_t n, const ksl_SE3_t *D,
    ptrdiff_t D_stride, const ksl_coscrew_t *ci, ptrdiff_t ci_stride,
    ksl_coscrew_t *co, ptrdiff_t co_stride, ksl_coscrew_t *co_bound,
    ptrdiff_t co_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_product_CoAdinvc_certified(D + i * D_stride, ci + i * ci_stride, co + i * co_stride,
        co_bound + i * co_bound_stride);
  }
}

static KSL_INLINED void ksl_product_CoAdinvc_certified_planes(ptrdiff_t n, const double *D,
    ptrdiff_t D_plane, ptrdiff_t D_stride, const double *ci, ptrdiff_t ci_plane,
    ptrdiff_t ci_stride, double *co, ptrdiff_t co_plane, ptrdiff_t co_stride,
    double *co_bound, ptrdiff_t co_bound_plane, ptrdiff_t co_bound_stride) {
  ksl_SE3_t D_i;
  if (n > 0) D_i = ksl_SE3_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3_of_planes(D + i * D_stride, D_plane);
    const ksl_coscrew_t ci_i = ksl_coscrew_of_planes(ci + i * ci_stride, ci_plane);
    ksl_coscrew_t co_i;
    ksl_coscrew_t co_bound_i;
    ksl_product_CoAdinvc_certified(&D_i, &ci_i, &co_i, &co_bound_i);
    ksl_coscrew_to_planes(&co_i, co + i * co_stride, co_plane);
    ksl_coscrew_to_planes(&co_bound_i, co_bound + i * co_bound_stride, co_bound_plane);
  }
}

/* ksl_product_CoAdcinv_certified of n elements. */
static KSL_INLINED void ksl_product_CoAdcinv_certified_many(ptrdiff_t n, const ksl_SE3_t *D,
    ptrdiff_t D_stride, const ksl_coscrew_t *ci, ptrdiff_t ci_stride,
    ksl_coscrew_t *co, ptrdiff_t co_stride, ksl_coscrew_t *co_bound,
    ptrdiff_t co_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_product_CoAdcinv_certified(D + i * D_stride, ci + i * ci_stride, co + i * co_stride,
        co_bound + i * co_bound_stride);
  }
}

static KSL_INLINED void ksl_product_CoAdcinv_certified_planes(ptrdiff_t n, const double *D,
    ptrdiff_t D_plane, ptrdiff_t D_stride, const double *ci, ptrdiff_t ci_plane,
    ptrdiff_t ci_stride, double *co, ptrdiff_t co_plane, ptrdiff_t co_stride,
    double *co_bound, ptrdiff_t co_bound_plane, ptrdiff_t co_bound_stride) {
  ksl_SE3_t D_i;
  if (n > 0) D_i = ksl_SE3_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3_of_planes(D + i * D_stride, D_plane);
    const ksl_coscrew_t ci_i = ksl_coscrew_of_planes(ci + i * ci_stride, ci_plane);
    ksl_coscrew_t co_i;
    ksl_coscrew_t co_bound_i;
    ksl_product_CoAdcinv_certified(&D_i, &ci_i, &co_i, &co_bound_i);
    ksl_coscrew_to_planes(&co_i, co + i * co_stride, co_plane);
    ksl_coscrew_to_planes(&co_bound_i, co_bound + i * co_bound_stride, co_bound_plane);
  }
}

/* ksl_hctx_certified of n elements. */
static KSL_INLINED void ksl_hctx_certified_many(ptrdiff_t n, const ksl_SE3_t *D, ptrdiff_t D_stride,
    ksl_coscrew_t *co, ptrdiff_t co_stride, ksl_coscrew_t *co_bound,
    ptrdiff_t co_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_hctx_certified(D + i * D_stride, co + i * co_stride, co_bound + i * co_bound_stride);
  }
}

static KSL_INLINED void ksl_hctx_certified_planes(ptrdiff_t n, const double *D, ptrdiff_t D_plane,
    ptrdiff_t D_stride, double *co, ptrdiff_t co_plane, ptrdiff_t co_stride,
    double *co_bound, ptrdiff_t co_bound_plane, ptrdiff_t co_bound_stride) {
  ksl_SE3_t D_i;
  if (n > 0) D_i = ksl_SE3_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3_of_planes(D + i * D_stride, D_plane);
    ksl_coscrew_t co_i;
    ksl_coscrew_t co_bound_i;
    ksl_hctx_certified(&D_i, &co_i, &co_bound_i);
    ksl_coscrew_to_planes(&co_i, co + i * co_stride, co_plane);
    ksl_coscrew_to_planes(&co_bound_i, co_bound + i * co_bound_stride, co_bound_plane);
  }
}

/* ksl_hcty_certified of n elements. */
static KSL_INLINED void ksl_hcty_certified_many(ptrdiff_t n, const ksl_SE3_t *D, ptrdiff_t D_stride,
    ksl_coscrew_t *co, ptrdiff_t co_stride, ksl_coscrew_t *co_bound,
    ptrdiff_t co_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_hcty_certified(D + i * D_stride, co + i * co_stride, co_bound + i * co_bound_stride);
  }
}

static KSL_INLINED void ksl_hcty_certified_planes(ptrdiff_t n, const double *D, ptrdiff_t D_plane,
    ptrdiff_t D_stride, double *co, ptrdiff_t co_plane, ptrdiff_t co_stride,
    double *co_bound, ptrdiff_t co_bound_plane, ptrdiff_t co_bound_stride) {
  ksl_SE3_t D_i;
  if (n > 0) D_i = ksl_SE3_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3_of_planes(D + i * D_stride, D_plane);
    ksl_coscrew_t co_i;
    ksl_coscrew_t co_bound_i;
    ksl_hcty_certified(&D_i, &co_i, &co_bound_i);
    ksl_coscrew_to_planes(&co_i, co + i * co_stride, co_plane);
    ksl_coscrew_to_planes(&co_bound_i, co_bound + i * co_bound_stride, co_bound_plane);
  }
}

/* ksl_hctz_certified of n elements. */
static KSL_INLINED void ksl_hctz_certified_many(ptrdiff_t n, const ksl_SE3_t *D, ptrdiff_t D_stride,
    ksl_coscrew_t *co, ptrdiff_t co_stride, ksl_coscrew_t *co_bound,
    ptrdiff_t co_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_hctz_certified(D + i * D_stride, co + i * co_stride, co_bound + i * co_bound_stride);
  }
}

static KSL_INLINED void ksl_hctz_certified_planes(ptrdiff_t n, const double *D, ptrdiff_t D_plane,
    ptrdiff_t D_stride, double *co, ptrdiff_t co_plane, ptrdiff_t co_stride,
    double *co_bound, ptrdiff_t co_bound_plane, ptrdiff_t co_bound_stride) {
  ksl_SE3_t D_i;
  if (n > 0) D_i = ksl_SE3_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3_of_planes(D + i * D_stride, D_plane);
    ksl_coscrew_t co_i;
    ksl_coscrew_t co_bound_i;
    ksl_hctz_certified(&D_i, &co_i, &co_bound_i);
    ksl_coscrew_to_planes(&co_i, co + i * co_stride, co_plane);
    ksl_coscrew_to_planes(&co_bound_i, co_bound + i * co_bound_stride, co_bound_plane);
  }
}

/* ksl_hctxinv_certified of n elements. */
static KSL_INLINED void ksl_hctxinv_certified_many(ptrdiff_t n, const ksl_SE3_t *D,
    ptrdiff_t D_stride, ksl_coscrew_t *co, ptrdiff_t co_stride,
    ksl_coscrew_t *co_bound, ptrdiff_t co_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_hctxinv_certified(D + i * D_stride, co + i * co_stride, co_bound + i * co_bound_stride);
  }
}

static KSL_INLINED void ksl_hctxinv_certified_planes(ptrdiff_t n, const double *D,
    ptrdiff_t D_plane, ptrdiff_t D_stride, double *co, ptrdiff_t co_plane,
    ptrdiff_t co_stride, double *co_bound, ptrdiff_t co_bound_plane,
    ptrdiff_t co_bound_stride) {
  ksl_SE3_t D_i;
  if (n > 0) D_i = ksl_SE3_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3_of_planes(D + i * D_stride, D_plane);
    ksl_coscrew_t co_i;
    ksl_coscrew_t co_bound_i;
    ksl_hctxinv_certified(&D_i, &co_i, &co_bound_i);
    ksl_coscrew_to_planes(&co_i, co + i * co_stride, co_plane);
    ksl_coscrew_to_planes(&co_bound_i, co_bound + i * co_bound_stride, co_bound_plane);
  }
}

/* ksl_hctyinv_certified of n elements. */
static KSL_INLINED void ksl_hctyinv_certified_many(ptrdiff_t n, const ksl_SE3_t *D,
    ptrdiff_t D_stride, ksl_coscrew_t *co, ptrdiff_t co_stride,
    ksl_coscrew_t *co_bound, ptrdiff_t co_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_hctyinv_certified(D + i * D_stride, co + i * co_stride, co_bound + i * co_bound_stride);
  }
}

static KSL_INLINED void ksl_hctyinv_certified_planes(ptrdiff_t n, const double *D,
    ptrdiff_t D_plane, ptrdiff_t D_stride, double *co, ptrdiff_t co_plane,
    ptrdiff_t co_stride, double *co_bound, ptrdiff_t co_bound_plane,
    ptrdiff_t co_bound_stride) {
  ksl_SE3_t D_i;
  if (n > 0) D_i = ksl_SE3_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3_of_planes(D + i * D_stride, D_plane);
    ksl_coscrew_t co_i;
    ksl_coscrew_t co_bound_i;
    ksl_hctyinv_certified(&D_i, &co_i, &co_bound_i);
    ksl_coscrew_to_planes(&co_i, co + i * co_stride, co_plane);
    ksl_coscrew_to_planes(&co_bound_i, co_bound + i * co_bound_stride, co_bound_plane);
  }
}

/* ksl_hctzinv_certified of n elements. */
static KSL_INLINED void ksl_hctzinv_certified_many(ptrdiff_t n, const ksl_SE3_t *D,
    ptrdiff_t D_stride, ksl_coscrew_t *co, ptrdiff_t co_stride,
    ksl_coscrew_t *co_bound, ptrdiff_t co_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_hctzinv_certified(D + i * D_stride, co + i * co_stride, co_bound + i * co_bound_stride);
  }
}

static KSL_INLINED void ksl_hctzinv_certified_planes(ptrdiff_t n, const double *D,
    ptrdiff_t D_plane, ptrdiff_t D_stride, double *co, ptrdiff_t co_plane,
    ptrdiff_t co_stride, double *co_bound, ptrdiff_t co_bound_plane,
    ptrdiff_t co_bound_stride) {
  ksl_SE3_t D_i;
  if (n > 0) D_i = ksl_SE3_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3_of_planes(D + i * D_stride, D_plane);
    ksl_coscrew_t co_i;
    ksl_coscrew_t co_bound_i;
    ksl_hctzinv_certified(&D_i, &co_i, &co_bound_i);
    ksl_coscrew_to_planes(&co_i, co + i * co_stride, co_plane);
    ksl_coscrew_to_planes(&co_bound_i, co_bound + i * co_bound_stride, co_bound_plane);
  }
}

/* ksl_CoAd_certified of n elements. */
static KSL_INLINED void ksl_CoAd_certified_many(ptrdiff_t n, const ksl_SE3_t *D, ptrdiff_t D_stride,
    ksl_mat6x6_t *M, ptrdiff_t M_stride, ksl_mat6x6_t *M_bound,
    ptrdiff_t M_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_CoAd_certified(D + i * D_stride, M + i * M_stride, M_bound + i * M_bound_stride);
  }
}

static KSL_INLINED void ksl_CoAd_certified_planes(ptrdiff_t n, const double *D, ptrdiff_t D_plane,
    ptrdiff_t D_stride, double *M, ptrdiff_t M_plane, ptrdiff_t M_stride,
    double *M_bound, ptrdiff_t M_bound_plane, ptrdiff_t M_bound_stride) {
  ksl_SE3_t D_i;
  if (n > 0) D_i = ksl_SE3_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3_of_planes(D + i * D_stride, D_plane);
    ksl_mat6x6_t M_i;
    ksl_mat6x6_t M_bound_i;
    ksl_CoAd_certified(&D_i, &M_i, &M_bound_i);
    ksl_mat6x6_to_planes(&M_i, M + i * M_stride, M_plane);
    ksl_mat6x6_to_planes(&M_bound_i, M_bound + i * M_bound_stride, M_bound_plane);
  }
}

/* ksl_reciprocal_product_certified of n elements. */
static KSL_INLINED void ksl_reciprocal_product_certified_many(ptrdiff_t n, const ksl_coscrew_t *c,
    ptrdiff_t c_stride, const double *x, ptrdiff_t x_stride, double *power_bound,
    ptrdiff_t power_bound_stride, double *power, ptrdiff_t power_stride) {
  KSL_EACH_OF(n) {
    power[i * power_stride] = ksl_reciprocal_product_certified(c + i * c_stride,
        x + 6 * i * x_stride, power_bound + i * power_bound_stride);
  }
}

static KSL_INLINED void ksl_reciprocal_product_certified_planes(ptrdiff_t n, const double *c,
    ptrdiff_t c_plane, ptrdiff_t c_stride, const double *x, ptrdiff_t x_plane,
    ptrdiff_t x_stride, double *power_bound, ptrdiff_t power_bound_stride,
    double *power, ptrdiff_t power_stride) {
  ksl_coscrew_t c_i;
  if (n > 0) c_i = ksl_coscrew_of_planes(c, c_plane);
  KSL_EACH_OF(n) {
    if (c_stride) c_i = ksl_coscrew_of_planes(c + i * c_stride, c_plane);
    const double x_i[6] = {x[0 + i * x_stride], x[x_plane + i * x_stride],
        x[2 * x_plane + i * x_stride], x[3 * x_plane + i * x_stride], x[4 * x_plane + i * x_stride],
        x[5 * x_plane + i * x_stride]};
    power[i * power_stride] = ksl_reciprocal_product_certified(&c_i, x_i,
        power_bound + i * power_bound_stride);
  }
}

/* ksl_cross_sc_certified of n elements. */
static KSL_INLINED void ksl_cross_sc_certified_many(ptrdiff_t n, const ksl_screw_t *s,
    ptrdiff_t s_stride, const ksl_coscrew_t *c, ptrdiff_t c_stride,
    ksl_coscrew_t *co, ptrdiff_t co_stride, ksl_coscrew_t *co_bound,
    ptrdiff_t co_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_cross_sc_certified(s + i * s_stride, c + i * c_stride, co + i * co_stride,
        co_bound + i * co_bound_stride);
  }
}

static KSL_INLINED void ksl_cross_sc_certified_planes(ptrdiff_t n, const double *s,
    ptrdiff_t s_plane, ptrdiff_t s_stride, const double *c, ptrdiff_t c_plane,
    ptrdiff_t c_stride, double *co, ptrdiff_t co_plane, ptrdiff_t co_stride,
    double *co_bound, ptrdiff_t co_bound_plane, ptrdiff_t co_bound_stride) {
  ksl_screw_t s_i;
  if (n > 0) s_i = ksl_screw_of_planes(s, s_plane);
  KSL_EACH_OF(n) {
    if (s_stride) s_i = ksl_screw_of_planes(s + i * s_stride, s_plane);
    const ksl_coscrew_t c_i = ksl_coscrew_of_planes(c + i * c_stride, c_plane);
    ksl_coscrew_t co_i;
    ksl_coscrew_t co_bound_i;
    ksl_cross_sc_certified(&s_i, &c_i, &co_i, &co_bound_i);
    ksl_coscrew_to_planes(&co_i, co + i * co_stride, co_plane);
    ksl_coscrew_to_planes(&co_bound_i, co_bound + i * co_bound_stride, co_bound_plane);
  }
}

/* ksl_cross_sca_certified of n elements. */
static KSL_INLINED void ksl_cross_sca_certified_many(ptrdiff_t n, const ksl_screw_t *s,
    ptrdiff_t s_stride, const ksl_coscrew_t *c, ptrdiff_t c_stride,
    ksl_coscrew_t *co, ptrdiff_t co_stride, ksl_coscrew_t *co_bound,
    ptrdiff_t co_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_cross_sca_certified(s + i * s_stride, c + i * c_stride, co + i * co_stride,
        co_bound + i * co_bound_stride);
  }
}

static KSL_INLINED void ksl_cross_sca_certified_planes(ptrdiff_t n, const double *s,
    ptrdiff_t s_plane, ptrdiff_t s_stride, const double *c, ptrdiff_t c_plane,
    ptrdiff_t c_stride, double *co, ptrdiff_t co_plane, ptrdiff_t co_stride,
    double *co_bound, ptrdiff_t co_bound_plane, ptrdiff_t co_bound_stride) {
  ksl_screw_t s_i;
  if (n > 0) s_i = ksl_screw_of_planes(s, s_plane);
  KSL_EACH_OF(n) {
    if (s_stride) s_i = ksl_screw_of_planes(s + i * s_stride, s_plane);
    const ksl_coscrew_t c_i = ksl_coscrew_of_planes(c + i * c_stride, c_plane);
    ksl_coscrew_t co_i;
    ksl_coscrew_t co_bound_i;
    ksl_cross_sca_certified(&s_i, &c_i, &co_i, &co_bound_i);
    ksl_coscrew_to_planes(&co_i, co + i * co_stride, co_plane);
    ksl_coscrew_to_planes(&co_bound_i, co_bound + i * co_bound_stride, co_bound_plane);
  }
}

/* ksl_constraint_ctx_certified of n elements. */
static KSL_INLINED void ksl_constraint_ctx_certified_many(ptrdiff_t n, const ksl_SE3_t *D,
    ptrdiff_t D_stride, const ksl_coscrew_t *c, ptrdiff_t c_stride,
    ksl_coscrew_t *co, ptrdiff_t co_stride, ksl_coscrew_t *co_bound,
    ptrdiff_t co_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_constraint_ctx_certified(D + i * D_stride, c + i * c_stride, co + i * co_stride,
        co_bound + i * co_bound_stride);
  }
}

static KSL_INLINED void ksl_constraint_ctx_certified_planes(ptrdiff_t n, const double *D,
    ptrdiff_t D_plane, ptrdiff_t D_stride, const double *c, ptrdiff_t c_plane,
    ptrdiff_t c_stride, double *co, ptrdiff_t co_plane, ptrdiff_t co_stride,
    double *co_bound, ptrdiff_t co_bound_plane, ptrdiff_t co_bound_stride) {
  ksl_SE3_t D_i;
  if (n > 0) D_i = ksl_SE3_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3_of_planes(D + i * D_stride, D_plane);
    const ksl_coscrew_t c_i = ksl_coscrew_of_planes(c + i * c_stride, c_plane);
    ksl_coscrew_t co_i;
    ksl_coscrew_t co_bound_i;
    ksl_constraint_ctx_certified(&D_i, &c_i, &co_i, &co_bound_i);
    ksl_coscrew_to_planes(&co_i, co + i * co_stride, co_plane);
    ksl_coscrew_to_planes(&co_bound_i, co_bound + i * co_bound_stride, co_bound_plane);
  }
}

/* ksl_constraint_cty_certified of n elements. */
static KSL_INLINED void ksl_constraint_cty_certified_many(ptrdiff_t n, const ksl_SE3_t *D,
    ptrdiff_t D_stride, const ksl_coscrew_t *c, ptrdiff_t c_stride,
    ksl_coscrew_t *co, ptrdiff_t co_stride, ksl_coscrew_t *co_bound,
    ptrdiff_t co_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_constraint_cty_certified(D + i * D_stride, c + i * c_stride, co + i * co_stride,
        co_bound + i * co_bound_stride);
  }
}

static KSL_INLINED void ksl_constraint_cty_certified_planes(ptrdiff_t n, const double *D,
    ptrdiff_t D_plane, ptrdiff_t D_stride, const double *c, ptrdiff_t c_plane,
    ptrdiff_t c_stride, double *co, ptrdiff_t co_plane, ptrdiff_t co_stride,
    double *co_bound, ptrdiff_t co_bound_plane, ptrdiff_t co_bound_stride) {
  ksl_SE3_t D_i;
  if (n > 0) D_i = ksl_SE3_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3_of_planes(D + i * D_stride, D_plane);
    const ksl_coscrew_t c_i = ksl_coscrew_of_planes(c + i * c_stride, c_plane);
    ksl_coscrew_t co_i;
    ksl_coscrew_t co_bound_i;
    ksl_constraint_cty_certified(&D_i, &c_i, &co_i, &co_bound_i);
    ksl_coscrew_to_planes(&co_i, co + i * co_stride, co_plane);
    ksl_coscrew_to_planes(&co_bound_i, co_bound + i * co_bound_stride, co_bound_plane);
  }
}

/* ksl_constraint_ctz_certified of n elements. */
static KSL_INLINED void ksl_constraint_ctz_certified_many(ptrdiff_t n, const ksl_SE3_t *D,
    ptrdiff_t D_stride, const ksl_coscrew_t *c, ptrdiff_t c_stride,
    ksl_coscrew_t *co, ptrdiff_t co_stride, ksl_coscrew_t *co_bound,
    ptrdiff_t co_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_constraint_ctz_certified(D + i * D_stride, c + i * c_stride, co + i * co_stride,
        co_bound + i * co_bound_stride);
  }
}

static KSL_INLINED void ksl_constraint_ctz_certified_planes(ptrdiff_t n, const double *D,
    ptrdiff_t D_plane, ptrdiff_t D_stride, const double *c, ptrdiff_t c_plane,
    ptrdiff_t c_stride, double *co, ptrdiff_t co_plane, ptrdiff_t co_stride,
    double *co_bound, ptrdiff_t co_bound_plane, ptrdiff_t co_bound_stride) {
  ksl_SE3_t D_i;
  if (n > 0) D_i = ksl_SE3_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3_of_planes(D + i * D_stride, D_plane);
    const ksl_coscrew_t c_i = ksl_coscrew_of_planes(c + i * c_stride, c_plane);
    ksl_coscrew_t co_i;
    ksl_coscrew_t co_bound_i;
    ksl_constraint_ctz_certified(&D_i, &c_i, &co_i, &co_bound_i);
    ksl_coscrew_to_planes(&co_i, co + i * co_stride, co_plane);
    ksl_coscrew_to_planes(&co_bound_i, co_bound + i * co_bound_stride, co_bound_plane);
  }
}

/* ksl_constraint_crx_certified of n elements. */
static KSL_INLINED void ksl_constraint_crx_certified_many(ptrdiff_t n, const ksl_SE3_t *D,
    ptrdiff_t D_stride, const ksl_coscrew_t *c, ptrdiff_t c_stride,
    ksl_coscrew_t *co, ptrdiff_t co_stride, ksl_coscrew_t *co_bound,
    ptrdiff_t co_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_constraint_crx_certified(D + i * D_stride, c + i * c_stride, co + i * co_stride,
        co_bound + i * co_bound_stride);
  }
}

static KSL_INLINED void ksl_constraint_crx_certified_planes(ptrdiff_t n, const double *D,
    ptrdiff_t D_plane, ptrdiff_t D_stride, const double *c, ptrdiff_t c_plane,
    ptrdiff_t c_stride, double *co, ptrdiff_t co_plane, ptrdiff_t co_stride,
    double *co_bound, ptrdiff_t co_bound_plane, ptrdiff_t co_bound_stride) {
  ksl_SE3_t D_i;
  if (n > 0) D_i = ksl_SE3_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3_of_planes(D + i * D_stride, D_plane);
    const ksl_coscrew_t c_i = ksl_coscrew_of_planes(c + i * c_stride, c_plane);
    ksl_coscrew_t co_i;
    ksl_coscrew_t co_bound_i;
    ksl_constraint_crx_certified(&D_i, &c_i, &co_i, &co_bound_i);
    ksl_coscrew_to_planes(&co_i, co + i * co_stride, co_plane);
    ksl_coscrew_to_planes(&co_bound_i, co_bound + i * co_bound_stride, co_bound_plane);
  }
}

/* ksl_constraint_cry_certified of n elements. */
static KSL_INLINED void ksl_constraint_cry_certified_many(ptrdiff_t n, const ksl_SE3_t *D,
    ptrdiff_t D_stride, const ksl_coscrew_t *c, ptrdiff_t c_stride,
    ksl_coscrew_t *co, ptrdiff_t co_stride, ksl_coscrew_t *co_bound,
    ptrdiff_t co_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_constraint_cry_certified(D + i * D_stride, c + i * c_stride, co + i * co_stride,
        co_bound + i * co_bound_stride);
  }
}

static KSL_INLINED void ksl_constraint_cry_certified_planes(ptrdiff_t n, const double *D,
    ptrdiff_t D_plane, ptrdiff_t D_stride, const double *c, ptrdiff_t c_plane,
    ptrdiff_t c_stride, double *co, ptrdiff_t co_plane, ptrdiff_t co_stride,
    double *co_bound, ptrdiff_t co_bound_plane, ptrdiff_t co_bound_stride) {
  ksl_SE3_t D_i;
  if (n > 0) D_i = ksl_SE3_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3_of_planes(D + i * D_stride, D_plane);
    const ksl_coscrew_t c_i = ksl_coscrew_of_planes(c + i * c_stride, c_plane);
    ksl_coscrew_t co_i;
    ksl_coscrew_t co_bound_i;
    ksl_constraint_cry_certified(&D_i, &c_i, &co_i, &co_bound_i);
    ksl_coscrew_to_planes(&co_i, co + i * co_stride, co_plane);
    ksl_coscrew_to_planes(&co_bound_i, co_bound + i * co_bound_stride, co_bound_plane);
  }
}

/* ksl_constraint_crz_certified of n elements. */
static KSL_INLINED void ksl_constraint_crz_certified_many(ptrdiff_t n, const ksl_SE3_t *D,
    ptrdiff_t D_stride, const ksl_coscrew_t *c, ptrdiff_t c_stride,
    ksl_coscrew_t *co, ptrdiff_t co_stride, ksl_coscrew_t *co_bound,
    ptrdiff_t co_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_constraint_crz_certified(D + i * D_stride, c + i * c_stride, co + i * co_stride,
        co_bound + i * co_bound_stride);
  }
}

static KSL_INLINED void ksl_constraint_crz_certified_planes(ptrdiff_t n, const double *D,
    ptrdiff_t D_plane, ptrdiff_t D_stride, const double *c, ptrdiff_t c_plane,
    ptrdiff_t c_stride, double *co, ptrdiff_t co_plane, ptrdiff_t co_stride,
    double *co_bound, ptrdiff_t co_bound_plane, ptrdiff_t co_bound_stride) {
  ksl_SE3_t D_i;
  if (n > 0) D_i = ksl_SE3_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3_of_planes(D + i * D_stride, D_plane);
    const ksl_coscrew_t c_i = ksl_coscrew_of_planes(c + i * c_stride, c_plane);
    ksl_coscrew_t co_i;
    ksl_coscrew_t co_bound_i;
    ksl_constraint_crz_certified(&D_i, &c_i, &co_i, &co_bound_i);
    ksl_coscrew_to_planes(&co_i, co + i * co_stride, co_plane);
    ksl_coscrew_to_planes(&co_bound_i, co_bound + i * co_bound_stride, co_bound_plane);
  }
}

/* ksl_working_ctx_certified of n elements. */
static KSL_INLINED void ksl_working_ctx_certified_many(ptrdiff_t n, const ksl_SE3_t *D,
    ptrdiff_t D_stride, const ksl_coscrew_t *c, ptrdiff_t c_stride,
    ksl_coscrew_t *co, ptrdiff_t co_stride, ksl_coscrew_t *co_bound,
    ptrdiff_t co_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_working_ctx_certified(D + i * D_stride, c + i * c_stride, co + i * co_stride,
        co_bound + i * co_bound_stride);
  }
}

static KSL_INLINED void ksl_working_ctx_certified_planes(ptrdiff_t n, const double *D,
    ptrdiff_t D_plane, ptrdiff_t D_stride, const double *c, ptrdiff_t c_plane,
    ptrdiff_t c_stride, double *co, ptrdiff_t co_plane, ptrdiff_t co_stride,
    double *co_bound, ptrdiff_t co_bound_plane, ptrdiff_t co_bound_stride) {
  ksl_SE3_t D_i;
  if (n > 0) D_i = ksl_SE3_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3_of_planes(D + i * D_stride, D_plane);
    const ksl_coscrew_t c_i = ksl_coscrew_of_planes(c + i * c_stride, c_plane);
    ksl_coscrew_t co_i;
    ksl_coscrew_t co_bound_i;
    ksl_working_ctx_certified(&D_i, &c_i, &co_i, &co_bound_i);
    ksl_coscrew_to_planes(&co_i, co + i * co_stride, co_plane);
    ksl_coscrew_to_planes(&co_bound_i, co_bound + i * co_bound_stride, co_bound_plane);
  }
}

/* ksl_working_cty_certified of n elements. */
static KSL_INLINED void ksl_working_cty_certified_many(ptrdiff_t n, const ksl_SE3_t *D,
    ptrdiff_t D_stride, const ksl_coscrew_t *c, ptrdiff_t c_stride,
    ksl_coscrew_t *co, ptrdiff_t co_stride, ksl_coscrew_t *co_bound,
    ptrdiff_t co_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_working_cty_certified(D + i * D_stride, c + i * c_stride, co + i * co_stride,
        co_bound + i * co_bound_stride);
  }
}

static KSL_INLINED void ksl_working_cty_certified_planes(ptrdiff_t n, const double *D,
    ptrdiff_t D_plane, ptrdiff_t D_stride, const double *c, ptrdiff_t c_plane,
    ptrdiff_t c_stride, double *co, ptrdiff_t co_plane, ptrdiff_t co_stride,
    double *co_bound, ptrdiff_t co_bound_plane, ptrdiff_t co_bound_stride) {
  ksl_SE3_t D_i;
  if (n > 0) D_i = ksl_SE3_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3_of_planes(D + i * D_stride, D_plane);
    const ksl_coscrew_t c_i = ksl_coscrew_of_planes(c + i * c_stride, c_plane);
    ksl_coscrew_t co_i;
    ksl_coscrew_t co_bound_i;
    ksl_working_cty_certified(&D_i, &c_i, &co_i, &co_bound_i);
    ksl_coscrew_to_planes(&co_i, co + i * co_stride, co_plane);
    ksl_coscrew_to_planes(&co_bound_i, co_bound + i * co_bound_stride, co_bound_plane);
  }
}

/* ksl_working_ctz_certified of n elements. */
static KSL_INLINED void ksl_working_ctz_certified_many(ptrdiff_t n, const ksl_SE3_t *D,
    ptrdiff_t D_stride, const ksl_coscrew_t *c, ptrdiff_t c_stride,
    ksl_coscrew_t *co, ptrdiff_t co_stride, ksl_coscrew_t *co_bound,
    ptrdiff_t co_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_working_ctz_certified(D + i * D_stride, c + i * c_stride, co + i * co_stride,
        co_bound + i * co_bound_stride);
  }
}

static KSL_INLINED void ksl_working_ctz_certified_planes(ptrdiff_t n, const double *D,
    ptrdiff_t D_plane, ptrdiff_t D_stride, const double *c, ptrdiff_t c_plane,
    ptrdiff_t c_stride, double *co, ptrdiff_t co_plane, ptrdiff_t co_stride,
    double *co_bound, ptrdiff_t co_bound_plane, ptrdiff_t co_bound_stride) {
  ksl_SE3_t D_i;
  if (n > 0) D_i = ksl_SE3_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3_of_planes(D + i * D_stride, D_plane);
    const ksl_coscrew_t c_i = ksl_coscrew_of_planes(c + i * c_stride, c_plane);
    ksl_coscrew_t co_i;
    ksl_coscrew_t co_bound_i;
    ksl_working_ctz_certified(&D_i, &c_i, &co_i, &co_bound_i);
    ksl_coscrew_to_planes(&co_i, co + i * co_stride, co_plane);
    ksl_coscrew_to_planes(&co_bound_i, co_bound + i * co_bound_stride, co_bound_plane);
  }
}

/* ksl_working_crx_certified of n elements. */
static KSL_INLINED void ksl_working_crx_certified_many(ptrdiff_t n, const ksl_SE3_t *D,
    ptrdiff_t D_stride, const ksl_coscrew_t *c, ptrdiff_t c_stride,
    ksl_coscrew_t *co, ptrdiff_t co_stride, ksl_coscrew_t *co_bound,
    ptrdiff_t co_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_working_crx_certified(D + i * D_stride, c + i * c_stride, co + i * co_stride,
        co_bound + i * co_bound_stride);
  }
}

static KSL_INLINED void ksl_working_crx_certified_planes(ptrdiff_t n, const double *D,
    ptrdiff_t D_plane, ptrdiff_t D_stride, const double *c, ptrdiff_t c_plane,
    ptrdiff_t c_stride, double *co, ptrdiff_t co_plane, ptrdiff_t co_stride,
    double *co_bound, ptrdiff_t co_bound_plane, ptrdiff_t co_bound_stride) {
  ksl_SE3_t D_i;
  if (n > 0) D_i = ksl_SE3_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3_of_planes(D + i * D_stride, D_plane);
    const ksl_coscrew_t c_i = ksl_coscrew_of_planes(c + i * c_stride, c_plane);
    ksl_coscrew_t co_i;
    ksl_coscrew_t co_bound_i;
    ksl_working_crx_certified(&D_i, &c_i, &co_i, &co_bound_i);
    ksl_coscrew_to_planes(&co_i, co + i * co_stride, co_plane);
    ksl_coscrew_to_planes(&co_bound_i, co_bound + i * co_bound_stride, co_bound_plane);
  }
}

/* ksl_working_cry_certified of n elements. */
static KSL_INLINED void ksl_working_cry_certified_many(ptrdiff_t n, const ksl_SE3_t *D,
    ptrdiff_t D_stride, const ksl_coscrew_t *c, ptrdiff_t c_stride,
    ksl_coscrew_t *co, ptrdiff_t co_stride, ksl_coscrew_t *co_bound,
    ptrdiff_t co_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_working_cry_certified(D + i * D_stride, c + i * c_stride, co + i * co_stride,
        co_bound + i * co_bound_stride);
  }
}

static KSL_INLINED void ksl_working_cry_certified_planes(ptrdiff_t n, const double *D,
    ptrdiff_t D_plane, ptrdiff_t D_stride, const double *c, ptrdiff_t c_plane,
    ptrdiff_t c_stride, double *co, ptrdiff_t co_plane, ptrdiff_t co_stride,
    double *co_bound, ptrdiff_t co_bound_plane, ptrdiff_t co_bound_stride) {
  ksl_SE3_t D_i;
  if (n > 0) D_i = ksl_SE3_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3_of_planes(D + i * D_stride, D_plane);
    const ksl_coscrew_t c_i = ksl_coscrew_of_planes(c + i * c_stride, c_plane);
    ksl_coscrew_t co_i;
    ksl_coscrew_t co_bound_i;
    ksl_working_cry_certified(&D_i, &c_i, &co_i, &co_bound_i);
    ksl_coscrew_to_planes(&co_i, co + i * co_stride, co_plane);
    ksl_coscrew_to_planes(&co_bound_i, co_bound + i * co_bound_stride, co_bound_plane);
  }
}

/* ksl_working_crz_certified of n elements. */
static KSL_INLINED void ksl_working_crz_certified_many(ptrdiff_t n, const ksl_SE3_t *D,
    ptrdiff_t D_stride, const ksl_coscrew_t *c, ptrdiff_t c_stride,
    ksl_coscrew_t *co, ptrdiff_t co_stride, ksl_coscrew_t *co_bound,
    ptrdiff_t co_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_working_crz_certified(D + i * D_stride, c + i * c_stride, co + i * co_stride,
        co_bound + i * co_bound_stride);
  }
}

static KSL_INLINED void ksl_working_crz_certified_planes(ptrdiff_t n, const double *D,
    ptrdiff_t D_plane, ptrdiff_t D_stride, const double *c, ptrdiff_t c_plane,
    ptrdiff_t c_stride, double *co, ptrdiff_t co_plane, ptrdiff_t co_stride,
    double *co_bound, ptrdiff_t co_bound_plane, ptrdiff_t co_bound_stride) {
  ksl_SE3_t D_i;
  if (n > 0) D_i = ksl_SE3_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3_of_planes(D + i * D_stride, D_plane);
    const ksl_coscrew_t c_i = ksl_coscrew_of_planes(c + i * c_stride, c_plane);
    ksl_coscrew_t co_i;
    ksl_coscrew_t co_bound_i;
    ksl_working_crz_certified(&D_i, &c_i, &co_i, &co_bound_i);
    ksl_coscrew_to_planes(&co_i, co + i * co_stride, co_plane);
    ksl_coscrew_to_planes(&co_bound_i, co_bound + i * co_bound_stride, co_bound_plane);
  }
}

/* ksl_coscrewf_scale_certified of n elements. */
static KSL_INLINED void ksl_coscrewf_scale_certified_many(ptrdiff_t n, ksl_coscrewf_t *self,
    ptrdiff_t self_stride, const float *a, ptrdiff_t a_stride,
    ksl_coscrewf_t *self_bound, ptrdiff_t self_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_coscrewf_scale_certified(self + i * self_stride, a[i * a_stride],
        self_bound + i * self_bound_stride);
  }
}

static KSL_INLINED void ksl_coscrewf_scale_certified_planes(ptrdiff_t n, float *self,
    ptrdiff_t self_plane, ptrdiff_t self_stride, const float *a,
    ptrdiff_t a_stride, float *self_bound, ptrdiff_t self_bound_plane,
    ptrdiff_t self_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_coscrewf_t self_i = ksl_coscrewf_of_planes(self + i * self_stride, self_plane);
    ksl_coscrewf_t self_bound_i;
    ksl_coscrewf_scale_certified(&self_i, a[i * a_stride], &self_bound_i);
    ksl_coscrewf_to_planes(&self_i, self + i * self_stride, self_plane);
    ksl_coscrewf_to_planes(&self_bound_i, self_bound + i * self_bound_stride, self_bound_plane);
  }
}

/* ksl_axpy_ccf_certified of n elements. */
static KSL_INLINED void ksl_axpy_ccf_certified_many(ptrdiff_t n, const float *a, ptrdiff_t a_stride,
    const ksl_coscrewf_t *x, ptrdiff_t x_stride, ksl_coscrewf_t *y,
    ptrdiff_t y_stride, ksl_coscrewf_t *y_bound, ptrdiff_t y_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_axpy_ccf_certified(a[i * a_stride], x + i * x_stride, y + i * y_stride,
        y_bound + i * y_bound_stride);
  }
}

static KSL_INLINED void ksl_axpy_ccf_certified_planes(ptrdiff_t n, const float *a,
    ptrdiff_t a_stride, const float *x, ptrdiff_t x_plane, ptrdiff_t x_stride,
    float *y, ptrdiff_t y_plane, ptrdiff_t y_stride, float *y_bound,
    ptrdiff_t y_bound_plane, ptrdiff_t y_bound_stride) {
  KSL_EACH_OF(n) {
    const ksl_coscrewf_t x_i = ksl_coscrewf_of_planes(x + i * x_stride, x_plane);
    ksl_coscrewf_t y_i = ksl_coscrewf_of_planes(y + i * y_stride, y_plane);
    ksl_coscrewf_t y_bound_i;
    ksl_axpy_ccf_certified(a[i * a_stride], &x_i, &y_i, &y_bound_i);
    ksl_coscrewf_to_planes(&y_i, y + i * y_stride, y_plane);
    ksl_coscrewf_to_planes(&y_bound_i, y_bound + i * y_bound_stride, y_bound_plane);
  }
}

/* ksl_xpy_ccf_certified of n elements. */
static KSL_INLINED void ksl_xpy_ccf_certified_many(ptrdiff_t n, const ksl_coscrewf_t *x,
    ptrdiff_t x_stride, ksl_coscrewf_t *y, ptrdiff_t y_stride,
    ksl_coscrewf_t *y_bound, ptrdiff_t y_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_xpy_ccf_certified(x + i * x_stride, y + i * y_stride, y_bound + i * y_bound_stride);
  }
}

static KSL_INLINED void ksl_xpy_ccf_certified_planes(ptrdiff_t n, const float *x, ptrdiff_t x_plane,
    ptrdiff_t x_stride, float *y, ptrdiff_t y_plane, ptrdiff_t y_stride,
    float *y_bound, ptrdiff_t y_bound_plane, ptrdiff_t y_bound_stride) {
  ksl_coscrewf_t x_i;
  if (n > 0) x_i = ksl_coscrewf_of_planes(x, x_plane);
  KSL_EACH_OF(n) {
    if (x_stride) x_i = ksl_coscrewf_of_planes(x + i * x_stride, x_plane);
    ksl_coscrewf_t y_i = ksl_coscrewf_of_planes(y + i * y_stride, y_plane);
    ksl_coscrewf_t y_bound_i;
    ksl_xpy_ccf_certified(&x_i, &y_i, &y_bound_i);
    ksl_coscrewf_to_planes(&y_i, y + i * y_stride, y_plane);
    ksl_coscrewf_to_planes(&y_bound_i, y_bound + i * y_bound_stride, y_bound_plane);
  }
}

/* ksl_nxpy_ccf_certified of n elements. */
static KSL_INLINED void ksl_nxpy_ccf_certified_many(ptrdiff_t n, const ksl_coscrewf_t *x,
    ptrdiff_t x_stride, ksl_coscrewf_t *y, ptrdiff_t y_stride,
    ksl_coscrewf_t *y_bound, ptrdiff_t y_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_nxpy_ccf_certified(x + i * x_stride, y + i * y_stride, y_bound + i * y_bound_stride);
  }
}

static KSL_INLINED void ksl_nxpy_ccf_certified_planes(ptrdiff_t n, const float *x,
    ptrdiff_t x_plane, ptrdiff_t x_stride, float *y, ptrdiff_t y_plane,
    ptrdiff_t y_stride, float *y_bound, ptrdiff_t y_bound_plane,
    ptrdiff_t y_bound_stride) {
  ksl_coscrewf_t x_i;
  if (n > 0) x_i = ksl_coscrewf_of_planes(x, x_plane);
  KSL_EACH_OF(n) {
    if (x_stride) x_i = ksl_coscrewf_of_planes(x + i * x_stride, x_plane);
    ksl_coscrewf_t y_i = ksl_coscrewf_of_planes(y + i * y_stride, y_plane);
    ksl_coscrewf_t y_bound_i;
    ksl_nxpy_ccf_certified(&x_i, &y_i, &y_bound_i);
    ksl_coscrewf_to_planes(&y_i, y + i * y_stride, y_plane);
    ksl_coscrewf_to_planes(&y_bound_i, y_bound + i * y_bound_stride, y_bound_plane);
  }
}

/* ksl_product_acf_certified of n elements. */
static KSL_INLINED void ksl_product_acf_certified_many(ptrdiff_t n, const float *a,
    ptrdiff_t a_stride, const ksl_coscrewf_t *ci, ptrdiff_t ci_stride,
    ksl_coscrewf_t *co, ptrdiff_t co_stride, ksl_coscrewf_t *co_bound,
    ptrdiff_t co_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_product_acf_certified(a[i * a_stride], ci + i * ci_stride, co + i * co_stride,
        co_bound + i * co_bound_stride);
  }
}

static KSL_INLINED void ksl_product_acf_certified_planes(ptrdiff_t n, const float *a,
    ptrdiff_t a_stride, const float *ci, ptrdiff_t ci_plane, ptrdiff_t ci_stride,
    float *co, ptrdiff_t co_plane, ptrdiff_t co_stride, float *co_bound,
    ptrdiff_t co_bound_plane, ptrdiff_t co_bound_stride) {
  KSL_EACH_OF(n) {
    const ksl_coscrewf_t ci_i = ksl_coscrewf_of_planes(ci + i * ci_stride, ci_plane);
    ksl_coscrewf_t co_i;
    ksl_coscrewf_t co_bound_i;
    ksl_product_acf_certified(a[i * a_stride], &ci_i, &co_i, &co_bound_i);
    ksl_coscrewf_to_planes(&co_i, co + i * co_stride, co_plane);
    ksl_coscrewf_to_planes(&co_bound_i, co_bound + i * co_bound_stride, co_bound_plane);
  }
}

/* ksl_add_ccf_certified of n elements. */
static KSL_INLINED void ksl_add_ccf_certified_many(ptrdiff_t n, const ksl_coscrewf_t *c1,
    ptrdiff_t c1_stride, const ksl_coscrewf_t *c2, ptrdiff_t c2_stride,
    ksl_coscrewf_t *co, ptrdiff_t co_stride, ksl_coscrewf_t *co_bound,
    ptrdiff_t co_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_add_ccf_certified(c1 + i * c1_stride, c2 + i * c2_stride, co + i * co_stride,
        co_bound + i * co_bound_stride);
  }
}

static KSL_INLINED void ksl_add_ccf_certified_planes(ptrdiff_t n, const float *c1,
    ptrdiff_t c1_plane, ptrdiff_t c1_stride, const float *c2, ptrdiff_t c2_plane,
    ptrdiff_t c2_stride, float *co, ptrdiff_t co_plane, ptrdiff_t co_stride,
    float *co_bound, ptrdiff_t co_bound_plane, ptrdiff_t co_bound_stride) {
  ksl_coscrewf_t c1_i;
  if (n > 0) c1_i = ksl_coscrewf_of_planes(c1, c1_plane);
  KSL_EACH_OF(n) {
    if (c1_stride) c1_i = ksl_coscrewf_of_planes(c1 + i * c1_stride, c1_plane);
    const ksl_coscrewf_t c2_i = ksl_coscrewf_of_planes(c2 + i * c2_stride, c2_plane);
    ksl_coscrewf_t co_i;
    ksl_coscrewf_t co_bound_i;
    ksl_add_ccf_certified(&c1_i, &c2_i, &co_i, &co_bound_i);
    ksl_coscrewf_to_planes(&co_i, co + i * co_stride, co_plane);
    ksl_coscrewf_to_planes(&co_bound_i, co_bound + i * co_bound_stride, co_bound_plane);
  }
}

/* ksl_subtract_ccf_certified of n elements. */
static KSL_INLINED void ksl_subtract_ccf_certified_many(ptrdiff_t n, const ksl_coscrewf_t *c1,
    ptrdiff_t c1_stride, const ksl_coscrewf_t *c2, ptrdiff_t c2_stride,
    ksl_coscrewf_t *co, ptrdiff_t co_stride, ksl_coscrewf_t *co_bound,
    ptrdiff_t co_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_subtract_ccf_certified(c1 + i * c1_stride, c2 + i * c2_stride, co + i * co_stride,
        co_bound + i * co_bound_stride);
  }
}

static KSL_INLINED void ksl_subtract_ccf_certified_planes(ptrdiff_t n, const float *c1,
    ptrdiff_t c1_plane, ptrdiff_t c1_stride, const float *c2, ptrdiff_t c2_plane,
    ptrdiff_t c2_stride, float *co, ptrdiff_t co_plane, ptrdiff_t co_stride,
    float *co_bound, ptrdiff_t co_bound_plane, ptrdiff_t co_bound_stride) {
  ksl_coscrewf_t c1_i;
  if (n > 0) c1_i = ksl_coscrewf_of_planes(c1, c1_plane);
  KSL_EACH_OF(n) {
    if (c1_stride) c1_i = ksl_coscrewf_of_planes(c1 + i * c1_stride, c1_plane);
    const ksl_coscrewf_t c2_i = ksl_coscrewf_of_planes(c2 + i * c2_stride, c2_plane);
    ksl_coscrewf_t co_i;
    ksl_coscrewf_t co_bound_i;
    ksl_subtract_ccf_certified(&c1_i, &c2_i, &co_i, &co_bound_i);
    ksl_coscrewf_to_planes(&co_i, co + i * co_stride, co_plane);
    ksl_coscrewf_to_planes(&co_bound_i, co_bound + i * co_bound_stride, co_bound_plane);
  }
}

/* ksl_add_cctf_certified of n elements. */
static KSL_INLINED void ksl_add_cctf_certified_many(ptrdiff_t n, const ksl_coscrewf_t *c1,
    ptrdiff_t c1_stride, const ksl_coscrewf_t *c2, ptrdiff_t c2_stride,
    ksl_coscrewf_t *co, ptrdiff_t co_stride, ksl_coscrewf_t *co_bound,
    ptrdiff_t co_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_add_cctf_certified(c1 + i * c1_stride, c2 + i * c2_stride, co + i * co_stride,
        co_bound + i * co_bound_stride);
  }
}

static KSL_INLINED void ksl_add_cctf_certified_planes(ptrdiff_t n, const float *c1,
    ptrdiff_t c1_plane, ptrdiff_t c1_stride, const float *c2, ptrdiff_t c2_plane,
    ptrdiff_t c2_stride, float *co, ptrdiff_t co_plane, ptrdiff_t co_stride,
    float *co_bound, ptrdiff_t co_bound_plane, ptrdiff_t co_bound_stride) {
  ksl_coscrewf_t c1_i;
  if (n > 0) c1_i = ksl_coscrewf_of_planes(c1, c1_plane);
  KSL_EACH_OF(n) {
    if (c1_stride) c1_i = ksl_coscrewf_of_planes(c1 + i * c1_stride, c1_plane);
    const ksl_coscrewf_t c2_i = ksl_coscrewf_of_planes(c2 + i * c2_stride, c2_plane);
    ksl_coscrewf_t co_i;
    ksl_coscrewf_t co_bound_i;
    ksl_add_cctf_certified(&c1_i, &c2_i, &co_i, &co_bound_i);
    ksl_coscrewf_to_planes(&co_i, co + i * co_stride, co_plane);
    ksl_coscrewf_to_planes(&co_bound_i, co_bound + i * co_bound_stride, co_bound_plane);
  }
}

/* ksl_product_CoAdtcf_certified of n elements. */
static KSL_INLINED void ksl_product_CoAdtcf_certified_many(ptrdiff_t n, const ksl_vec3f_t *t,
    ptrdiff_t t_stride, const ksl_coscrewf_t *ci, ptrdiff_t ci_stride,
    ksl_coscrewf_t *co, ptrdiff_t co_stride, ksl_coscrewf_t *co_bound,
    ptrdiff_t co_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_product_CoAdtcf_certified(t + i * t_stride, ci + i * ci_stride, co + i * co_stride,
        co_bound + i * co_bound_stride);
  }
}

static KSL_INLINED void ksl_product_CoAdtcf_certified_planes(ptrdiff_t n, const float *t,
    ptrdiff_t t_plane, ptrdiff_t t_stride, const float *ci, ptrdiff_t ci_plane,
    ptrdiff_t ci_stride, float *co, ptrdiff_t co_plane, ptrdiff_t co_stride,
    float *co_bound, ptrdiff_t co_bound_plane, ptrdiff_t co_bound_stride) {
  ksl_vec3f_t t_i;
  if (n > 0) t_i = ksl_vec3f_of_planes(t, t_plane);
  KSL_EACH_OF(n) {
    if (t_stride) t_i = ksl_vec3f_of_planes(t + i * t_stride, t_plane);
    const ksl_coscrewf_t ci_i = ksl_coscrewf_of_planes(ci + i * ci_stride, ci_plane);
    ksl_coscrewf_t co_i;
    ksl_coscrewf_t co_bound_i;
    ksl_product_CoAdtcf_certified(&t_i, &ci_i, &co_i, &co_bound_i);
    ksl_coscrewf_to_planes(&co_i, co + i * co_stride, co_plane);
    ksl_coscrewf_to_planes(&co_bound_i, co_bound + i * co_bound_stride, co_bound_plane);
  }
}

/* ksl_product_CoAdtinvcf_certified of n elements. */
static KSL_INLINED void ksl_product_CoAdtinvcf_certified_many(ptrdiff_t n, const ksl_vec3f_t *t,
    ptrdiff_t t_stride, const ksl_coscrewf_t *ci, ptrdiff_t ci_stride,
    ksl_coscrewf_t *co, ptrdiff_t co_stride, ksl_coscrewf_t *co_bound,
    ptrdiff_t co_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_product_CoAdtinvcf_certified(t + i * t_stride, ci + i * ci_stride, co + i * co_stride,
        co_bound + i * co_bound_stride);
  }
}

static KSL_INLINED void ksl_product_CoAdtinvcf_certified_planes(ptrdiff_t n, const float *t,
    ptrdiff_t t_plane, ptrdiff_t t_stride, const float *ci, ptrdiff_t ci_plane,
    ptrdiff_t ci_stride, float *co, ptrdiff_t co_plane, ptrdiff_t co_stride,
    float *co_bound, ptrdiff_t co_bound_plane, ptrdiff_t co_bound_stride) {
  ksl_vec3f_t t_i;
  if (n > 0) t_i = ksl_vec3f_of_planes(t, t_plane);
  KSL_EACH_OF(n) {
    if (t_stride) t_i = ksl_vec3f_of_planes(t + i * t_stride, t_plane);
    const ksl_coscrewf_t ci_i = ksl_coscrewf_of_planes(ci + i * ci_stride, ci_plane);
    ksl_coscrewf_t co_i;
    ksl_coscrewf_t co_bound_i;
    ksl_product_CoAdtinvcf_certified(&t_i, &ci_i, &co_i, &co_bound_i);
    ksl_coscrewf_to_planes(&co_i, co + i * co_stride, co_plane);
    ksl_coscrewf_to_planes(&co_bound_i, co_bound + i * co_bound_stride, co_bound_plane);
  }
}

/* ksl_product_CoAdtcinvf_certified of n elements. */
static KSL_INLINED void ksl_product_CoAdtcinvf_certified_many(ptrdiff_t n, const ksl_vec3f_t *t,
    ptrdiff_t t_stride, const ksl_coscrewf_t *ci, ptrdiff_t ci_stride,
    ksl_coscrewf_t *co, ptrdiff_t co_stride, ksl_coscrewf_t *co_bound,
    ptrdiff_t co_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_product_CoAdtcinvf_certified(t + i * t_stride, ci + i * ci_stride, co + i * co_stride,
        co_bound + i * co_bound_stride);
  }
}

static KSL_INLINED void ksl_product_CoAdtcinvf_certified_planes(ptrdiff_t n, const float *t,
    ptrdiff_t t_plane, ptrdiff_t t_stride, const float *ci, ptrdiff_t ci_plane,
    ptrdiff_t ci_stride, float *co, ptrdiff_t co_plane, ptrdiff_t co_stride,
    float *co_bound, ptrdiff_t co_bound_plane, ptrdiff_t co_bound_stride) {
  ksl_vec3f_t t_i;
  if (n > 0) t_i = ksl_vec3f_of_planes(t, t_plane);
  KSL_EACH_OF(n) {
    if (t_stride) t_i = ksl_vec3f_of_planes(t + i * t_stride, t_plane);
    const ksl_coscrewf_t ci_i = ksl_coscrewf_of_planes(ci + i * ci_stride, ci_plane);
    ksl_coscrewf_t co_i;
    ksl_coscrewf_t co_bound_i;
    ksl_product_CoAdtcinvf_certified(&t_i, &ci_i, &co_i, &co_bound_i);
    ksl_coscrewf_to_planes(&co_i, co + i * co_stride, co_plane);
    ksl_coscrewf_to_planes(&co_bound_i, co_bound + i * co_bound_stride, co_bound_plane);
  }
}

/* ksl_product_CoAdrcf_certified of n elements. */
static KSL_INLINED void ksl_product_CoAdrcf_certified_many(ptrdiff_t n, const ksl_mat3x3f_t *R,
    ptrdiff_t R_stride, const ksl_coscrewf_t *ci, ptrdiff_t ci_stride,
    ksl_coscrewf_t *co, ptrdiff_t co_stride, ksl_coscrewf_t *co_bound,
    ptrdiff_t co_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_product_CoAdrcf_certified(R + i * R_stride, ci + i * ci_stride, co + i * co_stride,
        co_bound + i * co_bound_stride);
  }
}

static KSL_INLINED void ksl_product_CoAdrcf_certified_planes(ptrdiff_t n, const float *R,
    ptrdiff_t R_plane, ptrdiff_t R_stride, const float *ci, ptrdiff_t ci_plane,
    ptrdiff_t ci_stride, float *co, ptrdiff_t co_plane, ptrdiff_t co_stride,
    float *co_bound, ptrdiff_t co_bound_plane, ptrdiff_t co_bound_stride) {
  ksl_mat3x3f_t R_i;
  if (n > 0) R_i = ksl_mat3x3f_of_planes(R, R_plane);
  KSL_EACH_OF(n) {
    if (R_stride) R_i = ksl_mat3x3f_of_planes(R + i * R_stride, R_plane);
    const ksl_coscrewf_t ci_i = ksl_coscrewf_of_planes(ci + i * ci_stride, ci_plane);
    ksl_coscrewf_t co_i;
    ksl_coscrewf_t co_bound_i;
    ksl_product_CoAdrcf_certified(&R_i, &ci_i, &co_i, &co_bound_i);
    ksl_coscrewf_to_planes(&co_i, co + i * co_stride, co_plane);
    ksl_coscrewf_to_planes(&co_bound_i, co_bound + i * co_bound_stride, co_bound_plane);
  }
}

/* ksl_product_CoAdrinvcf_certified of n elements. */
static KSL_INLINED void ksl_product_CoAdrinvcf_certified_many(ptrdiff_t n, const ksl_mat3x3f_t *R,
    ptrdiff_t R_stride, const ksl_coscrewf_t *ci, ptrdiff_t ci_stride,
    ksl_coscrewf_t *co, ptrdiff_t co_stride, ksl_coscrewf_t *co_bound,
    ptrdiff_t co_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_product_CoAdrinvcf_certified(R + i * R_stride, ci + i * ci_stride, co + i * co_stride,
        co_bound + i * co_bound_stride);
  }
}

static KSL_INLINED void ksl_product_CoAdrinvcf_certified_planes(ptrdiff_t n, const float *R,
    ptrdiff_t R_plane, ptrdiff_t R_stride, const float *ci, ptrdiff_t ci_plane,
    ptrdiff_t ci_stride, float *co, ptrdiff_t co_plane, ptrdiff_t co_stride,
    float *co_bound, ptrdiff_t co_bound_plane, ptrdiff_t co_bound_stride) {
  ksl_mat3x3f_t R_i;
  if (n > 0) R_i = ksl_mat3x3f_of_planes(R, R_plane);
  KSL_EACH_OF(n) {
    if (R_stride) R_i = ksl_mat3x3f_of_planes(R + i * R_stride, R_plane);
    const ksl_coscrewf_t ci_i = ksl_coscrewf_of_planes(ci + i * ci_stride, ci_plane);
    ksl_coscrewf_t co_i;
    ksl_coscrewf_t co_bound_i;
    ksl_product_CoAdrinvcf_certified(&R_i, &ci_i, &co_i, &co_bound_i);
    ksl_coscrewf_to_planes(&co_i, co + i * co_stride, co_plane);
    ksl_coscrewf_to_planes(&co_bound_i, co_bound + i * co_bound_stride, co_bound_plane);
  }
}

/* ksl_product_CoAdrcinvf_certified of n elements. */
static KSL_INLINED void ksl_product_CoAdrcinvf_certified_many(ptrdiff_t n, const ksl_mat3x3f_t *R,
    ptrdiff_t R_stride, const ksl_coscrewf_t *ci, ptrdiff_t ci_stride,
    ksl_coscrewf_t *co, ptrdiff_t co_stride, ksl_coscrewf_t *co_bound,
    ptrdiff_t co_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_product_CoAdrcinvf_certified(R + i * R_stride, ci + i * ci_stride, co + i * co_stride,
        co_bound + i * co_bound_stride);
  }
}

static KSL_INLINED void ksl_product_CoAdrcinvf_certified_planes(ptrdiff_t n, const float *R,
    ptrdiff_t R_plane, ptrdiff_t R_stride, const float *ci, ptrdiff_t ci_plane,
    ptrdiff_t ci_stride, float *co, ptrdiff_t co_plane, ptrdiff_t co_stride,
    float *co_bound, ptrdiff_t co_bound_plane, ptrdiff_t co_bound_stride) {
  ksl_mat3x3f_t R_i;
  if (n > 0) R_i = ksl_mat3x3f_of_planes(R, R_plane);
  KSL_EACH_OF(n) {
    if (R_stride) R_i = ksl_mat3x3f_of_planes(R + i * R_stride, R_plane);
    const ksl_coscrewf_t ci_i = ksl_coscrewf_of_planes(ci + i * ci_stride, ci_plane);
    ksl_coscrewf_t co_i;
    ksl_coscrewf_t co_bound_i;
    ksl_product_CoAdrcinvf_certified(&R_i, &ci_i, &co_i, &co_bound_i);
    ksl_coscrewf_to_planes(&co_i, co + i * co_stride, co_plane);
    ksl_coscrewf_to_planes(&co_bound_i, co_bound + i * co_bound_stride, co_bound_plane);
  }
}

/* ksl_product_CoAdcf_certified of n elements. */
static KSL_INLINED void ksl_product_CoAdcf_certified_many(ptrdiff_t n, const ksl_SE3f_t *D,
    ptrdiff_t D_stride, const ksl_coscrewf_t *ci, ptrdiff_t ci_stride,
    ksl_coscrewf_t *co, ptrdiff_t co_stride, ksl_coscrewf_t *co_bound,
    ptrdiff_t co_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_product_CoAdcf_certified(D + i * D_stride, ci + i * ci_stride, co + i * co_stride,
        co_bound + i * co_bound_stride);
  }
}

static KSL_INLINED void ksl_product_CoAdcf_certified_planes(ptrdiff_t n, const float *D,
    ptrdiff_t D_plane, ptrdiff_t D_stride, const float *ci, ptrdiff_t ci_plane,
    ptrdiff_t ci_stride, float *co, ptrdiff_t co_plane, ptrdiff_t co_stride,
    float *co_bound, ptrdiff_t co_bound_plane, ptrdiff_t co_bound_stride) {
  ksl_SE3f_t D_i;
  if (n > 0) D_i = ksl_SE3f_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3f_of_planes(D + i * D_stride, D_plane);
    const ksl_coscrewf_t ci_i = ksl_coscrewf_of_planes(ci + i * ci_stride, ci_plane);
    ksl_coscrewf_t co_i;
    ksl_coscrewf_t co_bound_i;
    ksl_product_CoAdcf_certified(&D_i, &ci_i, &co_i, &co_bound_i);
    ksl_coscrewf_to_planes(&co_i, co + i * co_stride, co_plane);
    ksl_coscrewf_to_planes(&co_bound_i, co_bound + i * co_bound_stride, co_bound_plane);
  }
}

/* ksl_product_CoAdinvcf_certified of n elements. */
static KSL_INLINED void ksl_product_CoAdinvcf_certified_many(ptrdiff_t n, const ksl_SE3f_t *D,
    ptrdiff_t D_stride, const ksl_coscrewf_t *ci, ptrdiff_t ci_stride,
    ksl_coscrewf_t *co, ptrdiff_t co_stride, ksl_coscrewf_t *co_bound,
    ptrdiff_t co_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_product_CoAdinvcf_certified(D + i * D_stride, ci + i * ci_stride, co + i * co_stride,
        co_bound + i * co_bound_stride);
  }
}

static KSL_INLINED void ksl_product_CoAdinvcf_certified_planes(ptrdiff_t n, const float *D,
    ptrdiff_t D_plane, ptrdiff_t D_stride, const float *ci, ptrdiff_t ci_plane,
    ptrdiff_t ci_stride, float *co, ptrdiff_t co_plane, ptrdiff_t co_stride,
    float *co_bound, ptrdiff_t co_bound_plane, ptrdiff_t co_bound_stride) {
  ksl_SE3f_t D_i;
  if (n > 0) D_i = ksl_SE3f_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3f_of_planes(D + i * D_stride, D_plane);
    const ksl_coscrewf_t ci_i = ksl_coscrewf_of_planes(ci + i * ci_stride, ci_plane);
    ksl_coscrewf_t co_i;
    ksl_coscrewf_t co_bound_i;
    ksl_product_CoAdinvcf_certified(&D_i, &ci_i, &co_i, &co_bound_i);
    ksl_coscrewf_to_planes(&co_i, co + i * co_stride, co_plane);
    ksl_coscrewf_to_planes(&co_bound_i, co_bound + i * co_bound_stride, co_bound_plane);
  }
}

/* ksl_product_CoAdcinvf_certified of n elements. */
static KSL_INLINED void ksl_product_CoAdcinvf_certified_many(ptrdiff_t n, const ksl_SE3f_t *D,
    ptrdiff_t D_stride, const ksl_coscrewf_t *ci, ptrdiff_t ci_stride,
    ksl_coscrewf_t *co, ptrdiff_t co_stride, ksl_coscrewf_t *co_bound,
    ptrdiff_t co_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_product_CoAdcinvf_certified(D + i * D_stride, ci + i * ci_stride, co + i * co_stride,
        co_bound + i * co_bound_stride);
  }
}

static KSL_INLINED void ksl_product_CoAdcinvf_certified_planes(ptrdiff_t n, const float *D,
    ptrdiff_t D_plane, ptrdiff_t D_stride, const float *ci, ptrdiff_t ci_plane,
    ptrdiff_t ci_stride, float *co, ptrdiff_t co_plane, ptrdiff_t co_stride,
    float *co_bound, ptrdiff_t co_bound_plane, ptrdiff_t co_bound_stride) {
  ksl_SE3f_t D_i;
  if (n > 0) D_i = ksl_SE3f_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3f_of_planes(D + i * D_stride, D_plane);
    const ksl_coscrewf_t ci_i = ksl_coscrewf_of_planes(ci + i * ci_stride, ci_plane);
    ksl_coscrewf_t co_i;
    ksl_coscrewf_t co_bound_i;
    ksl_product_CoAdcinvf_certified(&D_i, &ci_i, &co_i, &co_bound_i);
    ksl_coscrewf_to_planes(&co_i, co + i * co_stride, co_plane);
    ksl_coscrewf_to_planes(&co_bound_i, co_bound + i * co_bound_stride, co_bound_plane);
  }
}

/* ksl_hctxf_certified of n elements. */
static KSL_INLINED void ksl_hctxf_certified_many(ptrdiff_t n, const ksl_SE3f_t *D,
    ptrdiff_t D_stride, ksl_coscrewf_t *co, ptrdiff_t co_stride,
    ksl_coscrewf_t *co_bound, ptrdiff_t co_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_hctxf_certified(D + i * D_stride, co + i * co_stride, co_bound + i * co_bound_stride);
  }
}

static KSL_INLINED void ksl_hctxf_certified_planes(ptrdiff_t n, const float *D, ptrdiff_t D_plane,
    ptrdiff_t D_stride, float *co, ptrdiff_t co_plane, ptrdiff_t co_stride,
    float *co_bound, ptrdiff_t co_bound_plane, ptrdiff_t co_bound_stride) {
  ksl_SE3f_t D_i;
  if (n > 0) D_i = ksl_SE3f_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3f_of_planes(D + i * D_stride, D_plane);
    ksl_coscrewf_t co_i;
    ksl_coscrewf_t co_bound_i;
    ksl_hctxf_certified(&D_i, &co_i, &co_bound_i);
    ksl_coscrewf_to_planes(&co_i, co + i * co_stride, co_plane);
    ksl_coscrewf_to_planes(&co_bound_i, co_bound + i * co_bound_stride, co_bound_plane);
  }
}

/* ksl_hctyf_certified of n elements. */
static KSL_INLINED void ksl_hctyf_certified_many(ptrdiff_t n, const ksl_SE3f_t *D,
    ptrdiff_t D_stride, ksl_coscrewf_t *co, ptrdiff_t co_stride,
    ksl_coscrewf_t *co_bound, ptrdiff_t co_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_hctyf_certified(D + i * D_stride, co + i * co_stride, co_bound + i * co_bound_stride);
  }
}

static KSL_INLINED void ksl_hctyf_certified_planes(ptrdiff_t n, const float *D, ptrdiff_t D_plane,
    ptrdiff_t D_stride, float *co, ptrdiff_t co_plane, ptrdiff_t co_stride,
    float *co_bound, ptrdiff_t co_bound_plane, ptrdiff_t co_bound_stride) {
  ksl_SE3f_t D_i;
  if (n > 0) D_i = ksl_SE3f_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3f_of_planes(D + i * D_stride, D_plane);
    ksl_coscrewf_t co_i;
    ksl_coscrewf_t co_bound_i;
    ksl_hctyf_certified(&D_i, &co_i, &co_bound_i);
    ksl_coscrewf_to_planes(&co_i, co + i * co_stride, co_plane);
    ksl_coscrewf_to_planes(&co_bound_i, co_bound + i * co_bound_stride, co_bound_plane);
  }
}

/* ksl_hctzf_certified of n elements. */
static KSL_INLINED void ksl_hctzf_certified_many(ptrdiff_t n, const ksl_SE3f_t *D,
    ptrdiff_t D_stride, ksl_coscrewf_t *co, ptrdiff_t co_stride,
    ksl_coscrewf_t *co_bound, ptrdiff_t co_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_hctzf_certified(D + i * D_stride, co + i * co_stride, co_bound + i * co_bound_stride);
  }
}

static KSL_INLINED void ksl_hctzf_certified_planes(ptrdiff_t n, const float *D, ptrdiff_t D_plane,
    ptrdiff_t D_stride, float *co, ptrdiff_t co_plane, ptrdiff_t co_stride,
    float *co_bound, ptrdiff_t co_bound_plane, ptrdiff_t co_bound_stride) {
  ksl_SE3f_t D_i;
  if (n > 0) D_i = ksl_SE3f_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3f_of_planes(D + i * D_stride, D_plane);
    ksl_coscrewf_t co_i;
    ksl_coscrewf_t co_bound_i;
    ksl_hctzf_certified(&D_i, &co_i, &co_bound_i);
    ksl_coscrewf_to_planes(&co_i, co + i * co_stride, co_plane);
    ksl_coscrewf_to_planes(&co_bound_i, co_bound + i * co_bound_stride, co_bound_plane);
  }
}

/* ksl_hctxinvf_certified of n elements. */
static KSL_INLINED void ksl_hctxinvf_certified_many(ptrdiff_t n, const ksl_SE3f_t *D,
    ptrdiff_t D_stride, ksl_coscrewf_t *co, ptrdiff_t co_stride,
    ksl_coscrewf_t *co_bound, ptrdiff_t co_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_hctxinvf_certified(D + i * D_stride, co + i * co_stride, co_bound + i * co_bound_stride);
  }
}

static KSL_INLINED void ksl_hctxinvf_certified_planes(ptrdiff_t n, const float *D,
    ptrdiff_t D_plane, ptrdiff_t D_stride, float *co, ptrdiff_t co_plane,
    ptrdiff_t co_stride, float *co_bound, ptrdiff_t co_bound_plane,
    ptrdiff_t co_bound_stride) {
  ksl_SE3f_t D_i;
  if (n > 0) D_i = ksl_SE3f_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3f_of_planes(D + i * D_stride, D_plane);
    ksl_coscrewf_t co_i;
    ksl_coscrewf_t co_bound_i;
    ksl_hctxinvf_certified(&D_i, &co_i, &co_bound_i);
    ksl_coscrewf_to_planes(&co_i, co + i * co_stride, co_plane);
    ksl_coscrewf_to_planes(&co_bound_i, co_bound + i * co_bound_stride, co_bound_plane);
  }
}

/* ksl_hctyinvf_certified of n elements. */
static KSL_INLINED void ksl_hctyinvf_certified_many(ptrdiff_t n, const ksl_SE3f_t *D,
    ptrdiff_t D_stride, ksl_coscrewf_t *co, ptrdiff_t co_stride,
    ksl_coscrewf_t *co_bound, ptrdiff_t co_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_hctyinvf_certified(D + i * D_stride, co + i * co_stride, co_bound + i * co_bound_stride);
  }
}

static KSL_INLINED void ksl_hctyinvf_certified_planes(ptrdiff_t n, const float *D,
    ptrdiff_t D_plane, ptrdiff_t D_stride, float *co, ptrdiff_t co_plane,
    ptrdiff_t co_stride, float *co_bound, ptrdiff_t co_bound_plane,
    ptrdiff_t co_bound_stride) {
  ksl_SE3f_t D_i;
  if (n > 0) D_i = ksl_SE3f_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3f_of_planes(D + i * D_stride, D_plane);
    ksl_coscrewf_t co_i;
    ksl_coscrewf_t co_bound_i;
    ksl_hctyinvf_certified(&D_i, &co_i, &co_bound_i);
    ksl_coscrewf_to_planes(&co_i, co + i * co_stride, co_plane);
    ksl_coscrewf_to_planes(&co_bound_i, co_bound + i * co_bound_stride, co_bound_plane);
  }
}

/* ksl_hctzinvf_certified of n elements. */
static KSL_INLINED void ksl_hctzinvf_certified_many(ptrdiff_t n, const ksl_SE3f_t *D,
    ptrdiff_t D_stride, ksl_coscrewf_t *co, ptrdiff_t co_stride,
    ksl_coscrewf_t *co_bound, ptrdiff_t co_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_hctzinvf_certified(D + i * D_stride, co + i * co_stride, co_bound + i * co_bound_stride);
  }
}

static KSL_INLINED void ksl_hctzinvf_certified_planes(ptrdiff_t n, const float *D,
    ptrdiff_t D_plane, ptrdiff_t D_stride, float *co, ptrdiff_t co_plane,
    ptrdiff_t co_stride, float *co_bound, ptrdiff_t co_bound_plane,
    ptrdiff_t co_bound_stride) {
  ksl_SE3f_t D_i;
  if (n > 0) D_i = ksl_SE3f_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3f_of_planes(D + i * D_stride, D_plane);
    ksl_coscrewf_t co_i;
    ksl_coscrewf_t co_bound_i;
    ksl_hctzinvf_certified(&D_i, &co_i, &co_bound_i);
    ksl_coscrewf_to_planes(&co_i, co + i * co_stride, co_plane);
    ksl_coscrewf_to_planes(&co_bound_i, co_bound + i * co_bound_stride, co_bound_plane);
  }
}

/* ksl_CoAdf_certified of n elements. */
static KSL_INLINED void ksl_CoAdf_certified_many(ptrdiff_t n, const ksl_SE3f_t *D,
    ptrdiff_t D_stride, ksl_mat6x6f_t *M, ptrdiff_t M_stride,
    ksl_mat6x6f_t *M_bound, ptrdiff_t M_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_CoAdf_certified(D + i * D_stride, M + i * M_stride, M_bound + i * M_bound_stride);
  }
}

static KSL_INLINED void ksl_CoAdf_certified_planes(ptrdiff_t n, const float *D, ptrdiff_t D_plane,
    ptrdiff_t D_stride, float *M, ptrdiff_t M_plane, ptrdiff_t M_stride,
    float *M_bound, ptrdiff_t M_bound_plane, ptrdiff_t M_bound_stride) {
  ksl_SE3f_t D_i;
  if (n > 0) D_i = ksl_SE3f_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3f_of_planes(D + i * D_stride, D_plane);
    ksl_mat6x6f_t M_i;
    ksl_mat6x6f_t M_bound_i;
    ksl_CoAdf_certified(&D_i, &M_i, &M_bound_i);
    ksl_mat6x6f_to_planes(&M_i, M + i * M_stride, M_plane);
    ksl_mat6x6f_to_planes(&M_bound_i, M_bound + i * M_bound_stride, M_bound_plane);
  }
}

/* ksl_reciprocal_productf_certified of n elements. */
static KSL_INLINED void ksl_reciprocal_productf_certified_many(ptrdiff_t n, const ksl_coscrewf_t *c,
    ptrdiff_t c_stride, const float *x, ptrdiff_t x_stride, float *power_bound,
    ptrdiff_t power_bound_stride, float *power, ptrdiff_t power_stride) {
  KSL_EACH_OF(n) {
    power[i * power_stride] = ksl_reciprocal_productf_certified(c + i * c_stride,
        x + 6 * i * x_stride, power_bound + i * power_bound_stride);
  }
}

static KSL_INLINED void ksl_reciprocal_productf_certified_planes(ptrdiff_t n, const float *c,
    ptrdiff_t c_plane, ptrdiff_t c_stride, const float *x, ptrdiff_t x_plane,
    ptrdiff_t x_stride, float *power_bound, ptrdiff_t power_bound_stride,
    float *power, ptrdiff_t power_stride) {
  ksl_coscrewf_t c_i;
  if (n > 0) c_i = ksl_coscrewf_of_planes(c, c_plane);
  KSL_EACH_OF(n) {
    if (c_stride) c_i = ksl_coscrewf_of_planes(c + i * c_stride, c_plane);
    const float x_i[6] = {x[0 + i * x_stride], x[x_plane + i * x_stride],
        x[2 * x_plane + i * x_stride], x[3 * x_plane + i * x_stride], x[4 * x_plane + i * x_stride],
        x[5 * x_plane + i * x_stride]};
    power[i * power_stride] = ksl_reciprocal_productf_certified(&c_i, x_i,
        power_bound + i * power_bound_stride);
  }
}

/* ksl_cross_scf_certified of n elements. */
static KSL_INLINED void ksl_cross_scf_certified_many(ptrdiff_t n, const ksl_screwf_t *s,
    ptrdiff_t s_stride, const ksl_coscrewf_t *c, ptrdiff_t c_stride,
    ksl_coscrewf_t *co, ptrdiff_t co_stride, ksl_coscrewf_t *co_bound,
    ptrdiff_t co_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_cross_scf_certified(s + i * s_stride, c + i * c_stride, co + i * co_stride,
        co_bound + i * co_bound_stride);
  }
}

static KSL_INLINED void ksl_cross_scf_certified_planes(ptrdiff_t n, const float *s,
    ptrdiff_t s_plane, ptrdiff_t s_stride, const float *c, ptrdiff_t c_plane,
    ptrdiff_t c_stride, float *co, ptrdiff_t co_plane, ptrdiff_t co_stride,
    float *co_bound, ptrdiff_t co_bound_plane, ptrdiff_t co_bound_stride) {
  ksl_screwf_t s_i;
  if (n > 0) s_i = ksl_screwf_of_planes(s, s_plane);
  KSL_EACH_OF(n) {
    if (s_stride) s_i = ksl_screwf_of_planes(s + i * s_stride, s_plane);
    const ksl_coscrewf_t c_i = ksl_coscrewf_of_planes(c + i * c_stride, c_plane);
    ksl_coscrewf_t co_i;
    ksl_coscrewf_t co_bound_i;
    ksl_cross_scf_certified(&s_i, &c_i, &co_i, &co_bound_i);
    ksl_coscrewf_to_planes(&co_i, co + i * co_stride, co_plane);
    ksl_coscrewf_to_planes(&co_bound_i, co_bound + i * co_bound_stride, co_bound_plane);
  }
}

/* ksl_cross_scaf_certified of n elements. */
static KSL_INLINED void ksl_cross_scaf_certified_many(ptrdiff_t n, const ksl_screwf_t *s,
    ptrdiff_t s_stride, const ksl_coscrewf_t *c, ptrdiff_t c_stride,
    ksl_coscrewf_t *co, ptrdiff_t co_stride, ksl_coscrewf_t *co_bound,
    ptrdiff_t co_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_cross_scaf_certified(s + i * s_stride, c + i * c_stride, co + i * co_stride,
        co_bound + i * co_bound_stride);
  }
}

static KSL_INLINED void ksl_cross_scaf_certified_planes(ptrdiff_t n, const float *s,
    ptrdiff_t s_plane, ptrdiff_t s_stride, const float *c, ptrdiff_t c_plane,
    ptrdiff_t c_stride, float *co, ptrdiff_t co_plane, ptrdiff_t co_stride,
    float *co_bound, ptrdiff_t co_bound_plane, ptrdiff_t co_bound_stride) {
  ksl_screwf_t s_i;
  if (n > 0) s_i = ksl_screwf_of_planes(s, s_plane);
  KSL_EACH_OF(n) {
    if (s_stride) s_i = ksl_screwf_of_planes(s + i * s_stride, s_plane);
    const ksl_coscrewf_t c_i = ksl_coscrewf_of_planes(c + i * c_stride, c_plane);
    ksl_coscrewf_t co_i;
    ksl_coscrewf_t co_bound_i;
    ksl_cross_scaf_certified(&s_i, &c_i, &co_i, &co_bound_i);
    ksl_coscrewf_to_planes(&co_i, co + i * co_stride, co_plane);
    ksl_coscrewf_to_planes(&co_bound_i, co_bound + i * co_bound_stride, co_bound_plane);
  }
}

/* ksl_constraint_ctxf_certified of n elements. */
static KSL_INLINED void ksl_constraint_ctxf_certified_many(ptrdiff_t n, const ksl_SE3f_t *D,
    ptrdiff_t D_stride, const ksl_coscrewf_t *c, ptrdiff_t c_stride,
    ksl_coscrewf_t *co, ptrdiff_t co_stride, ksl_coscrewf_t *co_bound,
    ptrdiff_t co_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_constraint_ctxf_certified(D + i * D_stride, c + i * c_stride, co + i * co_stride,
        co_bound + i * co_bound_stride);
  }
}

static KSL_INLINED void ksl_constraint_ctxf_certified_planes(ptrdiff_t n, const float *D,
    ptrdiff_t D_plane, ptrdiff_t D_stride, const float *c, ptrdiff_t c_plane,
    ptrdiff_t c_stride, float *co, ptrdiff_t co_plane, ptrdiff_t co_stride,
    float *co_bound, ptrdiff_t co_bound_plane, ptrdiff_t co_bound_stride) {
  ksl_SE3f_t D_i;
  if (n > 0) D_i = ksl_SE3f_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3f_of_planes(D + i * D_stride, D_plane);
    const ksl_coscrewf_t c_i = ksl_coscrewf_of_planes(c + i * c_stride, c_plane);
    ksl_coscrewf_t co_i;
    ksl_coscrewf_t co_bound_i;
    ksl_constraint_ctxf_certified(&D_i, &c_i, &co_i, &co_bound_i);
    ksl_coscrewf_to_planes(&co_i, co + i * co_stride, co_plane);
    ksl_coscrewf_to_planes(&co_bound_i, co_bound + i * co_bound_stride, co_bound_plane);
  }
}

/* ksl_constraint_ctyf_certified of n elements. */
static KSL_INLINED void ksl_constraint_ctyf_certified_many(ptrdiff_t n, const ksl_SE3f_t *D,
    ptrdiff_t D_stride, const ksl_coscrewf_t *c, ptrdiff_t c_stride,
    ksl_coscrewf_t *co, ptrdiff_t co_stride, ksl_coscrewf_t *co_bound,
    ptrdiff_t co_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_constraint_ctyf_certified(D + i * D_stride, c + i * c_stride, co + i * co_stride,
        co_bound + i * co_bound_stride);
  }
}

static KSL_INLINED void ksl_constraint_ctyf_certified_planes(ptrdiff_t n, const float *D,
    ptrdiff_t D_plane, ptrdiff_t D_stride, const float *c, ptrdiff_t c_plane,
    ptrdiff_t c_stride, float *co, ptrdiff_t co_plane, ptrdiff_t co_stride,
    float *co_bound, ptrdiff_t co_bound_plane, ptrdiff_t co_bound_stride) {
  ksl_SE3f_t D_i;
  if (n > 0) D_i = ksl_SE3f_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3f_of_planes(D + i * D_stride, D_plane);
    const ksl_coscrewf_t c_i = ksl_coscrewf_of_planes(c + i * c_stride, c_plane);
    ksl_coscrewf_t co_i;
    ksl_coscrewf_t co_bound_i;
    ksl_constraint_ctyf_certified(&D_i, &c_i, &co_i, &co_bound_i);
    ksl_coscrewf_to_planes(&co_i, co + i * co_stride, co_plane);
    ksl_coscrewf_to_planes(&co_bound_i, co_bound + i * co_bound_stride, co_bound_plane);
  }
}

/* ksl_constraint_ctzf_certified of n elements. */
static KSL_INLINED void ksl_constraint_ctzf_certified_many(ptrdiff_t n, const ksl_SE3f_t *D,
    ptrdiff_t D_stride, const ksl_coscrewf_t *c, ptrdiff_t c_stride,
    ksl_coscrewf_t *co, ptrdiff_t co_stride, ksl_coscrewf_t *co_bound,
    ptrdiff_t co_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_constraint_ctzf_certified(D + i * D_stride, c + i * c_stride, co + i * co_stride,
        co_bound + i * co_bound_stride);
  }
}

static KSL_INLINED void ksl_constraint_ctzf_certified_planes(ptrdiff_t n, const float *D,
    ptrdiff_t D_plane, ptrdiff_t D_stride, const float *c, ptrdiff_t c_plane,
    ptrdiff_t c_stride, float *co, ptrdiff_t co_plane, ptrdiff_t co_stride,
    float *co_bound, ptrdiff_t co_bound_plane, ptrdiff_t co_bound_stride) {
  ksl_SE3f_t D_i;
  if (n > 0) D_i = ksl_SE3f_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3f_of_planes(D + i * D_stride, D_plane);
    const ksl_coscrewf_t c_i = ksl_coscrewf_of_planes(c + i * c_stride, c_plane);
    ksl_coscrewf_t co_i;
    ksl_coscrewf_t co_bound_i;
    ksl_constraint_ctzf_certified(&D_i, &c_i, &co_i, &co_bound_i);
    ksl_coscrewf_to_planes(&co_i, co + i * co_stride, co_plane);
    ksl_coscrewf_to_planes(&co_bound_i, co_bound + i * co_bound_stride, co_bound_plane);
  }
}

/* ksl_constraint_crxf_certified of n elements. */
static KSL_INLINED void ksl_constraint_crxf_certified_many(ptrdiff_t n, const ksl_SE3f_t *D,
    ptrdiff_t D_stride, const ksl_coscrewf_t *c, ptrdiff_t c_stride,
    ksl_coscrewf_t *co, ptrdiff_t co_stride, ksl_coscrewf_t *co_bound,
    ptrdiff_t co_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_constraint_crxf_certified(D + i * D_stride, c + i * c_stride, co + i * co_stride,
        co_bound + i * co_bound_stride);
  }
}

static KSL_INLINED void ksl_constraint_crxf_certified_planes(ptrdiff_t n, const float *D,
    ptrdiff_t D_plane, ptrdiff_t D_stride, const float *c, ptrdiff_t c_plane,
    ptrdiff_t c_stride, float *co, ptrdiff_t co_plane, ptrdiff_t co_stride,
    float *co_bound, ptrdiff_t co_bound_plane, ptrdiff_t co_bound_stride) {
  ksl_SE3f_t D_i;
  if (n > 0) D_i = ksl_SE3f_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3f_of_planes(D + i * D_stride, D_plane);
    const ksl_coscrewf_t c_i = ksl_coscrewf_of_planes(c + i * c_stride, c_plane);
    ksl_coscrewf_t co_i;
    ksl_coscrewf_t co_bound_i;
    ksl_constraint_crxf_certified(&D_i, &c_i, &co_i, &co_bound_i);
    ksl_coscrewf_to_planes(&co_i, co + i * co_stride, co_plane);
    ksl_coscrewf_to_planes(&co_bound_i, co_bound + i * co_bound_stride, co_bound_plane);
  }
}

/* ksl_constraint_cryf_certified of n elements. */
static KSL_INLINED void ksl_constraint_cryf_certified_many(ptrdiff_t n, const ksl_SE3f_t *D,
    ptrdiff_t D_stride, const ksl_coscrewf_t *c, ptrdiff_t c_stride,
    ksl_coscrewf_t *co, ptrdiff_t co_stride, ksl_coscrewf_t *co_bound,
    ptrdiff_t co_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_constraint_cryf_certified(D + i * D_stride, c + i * c_stride, co + i * co_stride,
        co_bound + i * co_bound_stride);
  }
}

static KSL_INLINED void ksl_constraint_cryf_certified_planes(ptrdiff_t n, const float *D,
    ptrdiff_t D_plane, ptrdiff_t D_stride, const float *c, ptrdiff_t c_plane,
    ptrdiff_t c_stride, float *co, ptrdiff_t co_plane, ptrdiff_t co_stride,
    float *co_bound, ptrdiff_t co_bound_plane, ptrdiff_t co_bound_stride) {
  ksl_SE3f_t D_i;
  if (n > 0) D_i = ksl_SE3f_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3f_of_planes(D + i * D_stride, D_plane);
    const ksl_coscrewf_t c_i = ksl_coscrewf_of_planes(c + i * c_stride, c_plane);
    ksl_coscrewf_t co_i;
    ksl_coscrewf_t co_bound_i;
    ksl_constraint_cryf_certified(&D_i, &c_i, &co_i, &co_bound_i);
    ksl_coscrewf_to_planes(&co_i, co + i * co_stride, co_plane);
    ksl_coscrewf_to_planes(&co_bound_i, co_bound + i * co_bound_stride, co_bound_plane);
  }
}

/* ksl_constraint_crzf_certified of n elements. */
static KSL_INLINED void ksl_constraint_crzf_certified_many(ptrdiff_t n, const ksl_SE3f_t *D,
    ptrdiff_t D_stride, const ksl_coscrewf_t *c, ptrdiff_t c_stride,
    ksl_coscrewf_t *co, ptrdiff_t co_stride, ksl_coscrewf_t *co_bound,
    ptrdiff_t co_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_constraint_crzf_certified(D + i * D_stride, c + i * c_stride, co + i * co_stride,
        co_bound + i * co_bound_stride);
  }
}

static KSL_INLINED void ksl_constraint_crzf_certified_planes(ptrdiff_t n, const float *D,
    ptrdiff_t D_plane, ptrdiff_t D_stride, const float *c, ptrdiff_t c_plane,
    ptrdiff_t c_stride, float *co, ptrdiff_t co_plane, ptrdiff_t co_stride,
    float *co_bound, ptrdiff_t co_bound_plane, ptrdiff_t co_bound_stride) {
  ksl_SE3f_t D_i;
  if (n > 0) D_i = ksl_SE3f_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3f_of_planes(D + i * D_stride, D_plane);
    const ksl_coscrewf_t c_i = ksl_coscrewf_of_planes(c + i * c_stride, c_plane);
    ksl_coscrewf_t co_i;
    ksl_coscrewf_t co_bound_i;
    ksl_constraint_crzf_certified(&D_i, &c_i, &co_i, &co_bound_i);
    ksl_coscrewf_to_planes(&co_i, co + i * co_stride, co_plane);
    ksl_coscrewf_to_planes(&co_bound_i, co_bound + i * co_bound_stride, co_bound_plane);
  }
}

/* ksl_working_ctxf_certified of n elements. */
static KSL_INLINED void ksl_working_ctxf_certified_many(ptrdiff_t n, const ksl_SE3f_t *D,
    ptrdiff_t D_stride, const ksl_coscrewf_t *c, ptrdiff_t c_stride,
    ksl_coscrewf_t *co, ptrdiff_t co_stride, ksl_coscrewf_t *co_bound,
    ptrdiff_t co_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_working_ctxf_certified(D + i * D_stride, c + i * c_stride, co + i * co_stride,
        co_bound + i * co_bound_stride);
  }
}

static KSL_INLINED void ksl_working_ctxf_certified_planes(ptrdiff_t n, const float *D,
    ptrdiff_t D_plane, ptrdiff_t D_stride, const float *c, ptrdiff_t c_plane,
    ptrdiff_t c_stride, float *co, ptrdiff_t co_plane, ptrdiff_t co_stride,
    float *co_bound, ptrdiff_t co_bound_plane, ptrdiff_t co_bound_stride) {
  ksl_SE3f_t D_i;
  if (n > 0) D_i = ksl_SE3f_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3f_of_planes(D + i * D_stride, D_plane);
    const ksl_coscrewf_t c_i = ksl_coscrewf_of_planes(c + i * c_stride, c_plane);
    ksl_coscrewf_t co_i;
    ksl_coscrewf_t co_bound_i;
    ksl_working_ctxf_certified(&D_i, &c_i, &co_i, &co_bound_i);
    ksl_coscrewf_to_planes(&co_i, co + i * co_stride, co_plane);
    ksl_coscrewf_to_planes(&co_bound_i, co_bound + i * co_bound_stride, co_bound_plane);
  }
}

/* ksl_working_ctyf_certified of n elements. */
static KSL_INLINED void ksl_working_ctyf_certified_many(ptrdiff_t n, const ksl_SE3f_t *D,
    ptrdiff_t D_stride, const ksl_coscrewf_t *c, ptrdiff_t c_stride,
    ksl_coscrewf_t *co, ptrdiff_t co_stride, ksl_coscrewf_t *co_bound,
    ptrdiff_t co_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_working_ctyf_certified(D + i * D_stride, c + i * c_stride, co + i * co_stride,
        co_bound + i * co_bound_stride);
  }
}

static KSL_INLINED void ksl_working_ctyf_certified_planes(ptrdiff_t n, const float *D,
    ptrdiff_t D_plane, ptrdiff_t D_stride, const float *c, ptrdiff_t c_plane,
    ptrdiff_t c_stride, float *co, ptrdiff_t co_plane, ptrdiff_t co_stride,
    float *co_bound, ptrdiff_t co_bound_plane, ptrdiff_t co_bound_stride) {
  ksl_SE3f_t D_i;
  if (n > 0) D_i = ksl_SE3f_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3f_of_planes(D + i * D_stride, D_plane);
    const ksl_coscrewf_t c_i = ksl_coscrewf_of_planes(c + i * c_stride, c_plane);
    ksl_coscrewf_t co_i;
    ksl_coscrewf_t co_bound_i;
    ksl_working_ctyf_certified(&D_i, &c_i, &co_i, &co_bound_i);
    ksl_coscrewf_to_planes(&co_i, co + i * co_stride, co_plane);
    ksl_coscrewf_to_planes(&co_bound_i, co_bound + i * co_bound_stride, co_bound_plane);
  }
}

/* ksl_working_ctzf_certified of n elements. */
static KSL_INLINED void ksl_working_ctzf_certified_many(ptrdiff_t n, const ksl_SE3f_t *D,
    ptrdiff_t D_stride, const ksl_coscrewf_t *c, ptrdiff_t c_stride,
    ksl_coscrewf_t *co, ptrdiff_t co_stride, ksl_coscrewf_t *co_bound,
    ptrdiff_t co_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_working_ctzf_certified(D + i * D_stride, c + i * c_stride, co + i * co_stride,
        co_bound + i * co_bound_stride);
  }
}

static KSL_INLINED void ksl_working_ctzf_certified_planes(ptrdiff_t n, const float *D,
    ptrdiff_t D_plane, ptrdiff_t D_stride, const float *c, ptrdiff_t c_plane,
    ptrdiff_t c_stride, float *co, ptrdiff_t co_plane, ptrdiff_t co_stride,
    float *co_bound, ptrdiff_t co_bound_plane, ptrdiff_t co_bound_stride) {
  ksl_SE3f_t D_i;
  if (n > 0) D_i = ksl_SE3f_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3f_of_planes(D + i * D_stride, D_plane);
    const ksl_coscrewf_t c_i = ksl_coscrewf_of_planes(c + i * c_stride, c_plane);
    ksl_coscrewf_t co_i;
    ksl_coscrewf_t co_bound_i;
    ksl_working_ctzf_certified(&D_i, &c_i, &co_i, &co_bound_i);
    ksl_coscrewf_to_planes(&co_i, co + i * co_stride, co_plane);
    ksl_coscrewf_to_planes(&co_bound_i, co_bound + i * co_bound_stride, co_bound_plane);
  }
}

/* ksl_working_crxf_certified of n elements. */
static KSL_INLINED void ksl_working_crxf_certified_many(ptrdiff_t n, const ksl_SE3f_t *D,
    ptrdiff_t D_stride, const ksl_coscrewf_t *c, ptrdiff_t c_stride,
    ksl_coscrewf_t *co, ptrdiff_t co_stride, ksl_coscrewf_t *co_bound,
    ptrdiff_t co_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_working_crxf_certified(D + i * D_stride, c + i * c_stride, co + i * co_stride,
        co_bound + i * co_bound_stride);
  }
}

static KSL_INLINED void ksl_working_crxf_certified_planes(ptrdiff_t n, const float *D,
    ptrdiff_t D_plane, ptrdiff_t D_stride, const float *c, ptrdiff_t c_plane,
    ptrdiff_t c_stride, float *co, ptrdiff_t co_plane, ptrdiff_t co_stride,
    float *co_bound, ptrdiff_t co_bound_plane, ptrdiff_t co_bound_stride) {
  ksl_SE3f_t D_i;
  if (n > 0) D_i = ksl_SE3f_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3f_of_planes(D + i * D_stride, D_plane);
    const ksl_coscrewf_t c_i = ksl_coscrewf_of_planes(c + i * c_stride, c_plane);
    ksl_coscrewf_t co_i;
    ksl_coscrewf_t co_bound_i;
    ksl_working_crxf_certified(&D_i, &c_i, &co_i, &co_bound_i);
    ksl_coscrewf_to_planes(&co_i, co + i * co_stride, co_plane);
    ksl_coscrewf_to_planes(&co_bound_i, co_bound + i * co_bound_stride, co_bound_plane);
  }
}

/* ksl_working_cryf_certified of n elements. */
static KSL_INLINED void ksl_working_cryf_certified_many(ptrdiff_t n, const ksl_SE3f_t *D,
    ptrdiff_t D_stride, const ksl_coscrewf_t *c, ptrdiff_t c_stride,
    ksl_coscrewf_t *co, ptrdiff_t co_stride, ksl_coscrewf_t *co_bound,
    ptrdiff_t co_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_working_cryf_certified(D + i * D_stride, c + i * c_stride, co + i * co_stride,
        co_bound + i * co_bound_stride);
  }
}

static KSL_INLINED void ksl_working_cryf_certified_planes(ptrdiff_t n, const float *D,
    ptrdiff_t D_plane, ptrdiff_t D_stride, const float *c, ptrdiff_t c_plane,
    ptrdiff_t c_stride, float *co, ptrdiff_t co_plane, ptrdiff_t co_stride,
    float *co_bound, ptrdiff_t co_bound_plane, ptrdiff_t co_bound_stride) {
  ksl_SE3f_t D_i;
  if (n > 0) D_i = ksl_SE3f_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3f_of_planes(D + i * D_stride, D_plane);
    const ksl_coscrewf_t c_i = ksl_coscrewf_of_planes(c + i * c_stride, c_plane);
    ksl_coscrewf_t co_i;
    ksl_coscrewf_t co_bound_i;
    ksl_working_cryf_certified(&D_i, &c_i, &co_i, &co_bound_i);
    ksl_coscrewf_to_planes(&co_i, co + i * co_stride, co_plane);
    ksl_coscrewf_to_planes(&co_bound_i, co_bound + i * co_bound_stride, co_bound_plane);
  }
}

/* ksl_working_crzf_certified of n elements. */
static KSL_INLINED void ksl_working_crzf_certified_many(ptrdiff_t n, const ksl_SE3f_t *D,
    ptrdiff_t D_stride, const ksl_coscrewf_t *c, ptrdiff_t c_stride,
    ksl_coscrewf_t *co, ptrdiff_t co_stride, ksl_coscrewf_t *co_bound,
    ptrdiff_t co_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_working_crzf_certified(D + i * D_stride, c + i * c_stride, co + i * co_stride,
        co_bound + i * co_bound_stride);
  }
}

static KSL_INLINED void ksl_working_crzf_certified_planes(ptrdiff_t n, const float *D,
    ptrdiff_t D_plane, ptrdiff_t D_stride, const float *c, ptrdiff_t c_plane,
    ptrdiff_t c_stride, float *co, ptrdiff_t co_plane, ptrdiff_t co_stride,
    float *co_bound, ptrdiff_t co_bound_plane, ptrdiff_t co_bound_stride) {
  ksl_SE3f_t D_i;
  if (n > 0) D_i = ksl_SE3f_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3f_of_planes(D + i * D_stride, D_plane);
    const ksl_coscrewf_t c_i = ksl_coscrewf_of_planes(c + i * c_stride, c_plane);
    ksl_coscrewf_t co_i;
    ksl_coscrewf_t co_bound_i;
    ksl_working_crzf_certified(&D_i, &c_i, &co_i, &co_bound_i);
    ksl_coscrewf_to_planes(&co_i, co + i * co_stride, co_plane);
    ksl_coscrewf_to_planes(&co_bound_i, co_bound + i * co_bound_stride, co_bound_plane);
  }
}

#endif
