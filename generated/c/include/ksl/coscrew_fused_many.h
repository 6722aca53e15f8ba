/* Made by `coscrew generate`; changes are overwritten. */
/* SPDX-License-Identifier: MIT */
/* coscrew 0.2.0.  Copyright (c) 2026 The coscrew authors. */
/* Coscrews: wrenches and momenta, c = (f; τ).  Many at a time.
   What arguments are, and what loops over them cost, ksl_planes.h says. */
#ifndef KSL_COSCREW_FUSED_MANY_H
#define KSL_COSCREW_FUSED_MANY_H

#include "coscrew_fused.h"
#include "ksl_planes.h"

/* ksl_coscrew_scale_fused of n elements. */
static KSL_INLINED void ksl_coscrew_scale_fused_many(ptrdiff_t n, ksl_coscrew_t *self,
    ptrdiff_t self_stride, const double *a, ptrdiff_t a_stride) {
  KSL_EACH_OF(n) {
    ksl_coscrew_scale_fused(self + i * self_stride, a[i * a_stride]);
  }
}

static KSL_INLINED void ksl_coscrew_scale_fused_planes(ptrdiff_t n, double *self,
    ptrdiff_t self_plane, ptrdiff_t self_stride, const double *a,
    ptrdiff_t a_stride) {
  KSL_EACH_OF(n) {
    ksl_coscrew_t self_i = ksl_coscrew_of_planes(self + i * self_stride, self_plane);
    ksl_coscrew_scale_fused(&self_i, a[i * a_stride]);
    ksl_coscrew_to_planes(&self_i, self + i * self_stride, self_plane);
  }
}

/* ksl_axpy_cc_fused of n elements. */
static KSL_INLINED void ksl_axpy_cc_fused_many(ptrdiff_t n, const double *a, ptrdiff_t a_stride,
    const ksl_coscrew_t *x, ptrdiff_t x_stride, ksl_coscrew_t *y,
    ptrdiff_t y_stride) {
  KSL_EACH_OF(n) {
    ksl_axpy_cc_fused(a[i * a_stride], x + i * x_stride, y + i * y_stride);
  }
}

static KSL_INLINED void ksl_axpy_cc_fused_planes(ptrdiff_t n, const double *a, ptrdiff_t a_stride,
    const double *x, ptrdiff_t x_plane, ptrdiff_t x_stride, double *y,
    ptrdiff_t y_plane, ptrdiff_t y_stride) {
  KSL_EACH_OF(n) {
    const ksl_coscrew_t x_i = ksl_coscrew_of_planes(x + i * x_stride, x_plane);
    ksl_coscrew_t y_i = ksl_coscrew_of_planes(y + i * y_stride, y_plane);
    ksl_axpy_cc_fused(a[i * a_stride], &x_i, &y_i);
    ksl_coscrew_to_planes(&y_i, y + i * y_stride, y_plane);
  }
}

/* ksl_xpy_cc_fused of n elements. */
static KSL_INLINED void ksl_xpy_cc_fused_many(ptrdiff_t n, const ksl_coscrew_t *x,
    ptrdiff_t x_stride, ksl_coscrew_t *y, ptrdiff_t y_stride) {
  KSL_EACH_OF(n) {
    ksl_xpy_cc_fused(x + i * x_stride, y + i * y_stride);
  }
}

static KSL_INLINED void ksl_xpy_cc_fused_planes(ptrdiff_t n, const double *x, ptrdiff_t x_plane,
    ptrdiff_t x_stride, double *y, ptrdiff_t y_plane, ptrdiff_t y_stride) {
  ksl_coscrew_t x_i;
  if (n > 0) x_i = ksl_coscrew_of_planes(x, x_plane);
  KSL_EACH_OF(n) {
    if (x_stride) x_i = ksl_coscrew_of_planes(x + i * x_stride, x_plane);
    ksl_coscrew_t y_i = ksl_coscrew_of_planes(y + i * y_stride, y_plane);
    ksl_xpy_cc_fused(&x_i, &y_i);
    ksl_coscrew_to_planes(&y_i, y + i * y_stride, y_plane);
  }
}

/* ksl_nxpy_cc_fused of n elements. */
static KSL_INLINED void ksl_nxpy_cc_fused_many(ptrdiff_t n, const ksl_coscrew_t *x,
    ptrdiff_t x_stride, ksl_coscrew_t *y, ptrdiff_t y_stride) {
  KSL_EACH_OF(n) {
    ksl_nxpy_cc_fused(x + i * x_stride, y + i * y_stride);
  }
}

static KSL_INLINED void ksl_nxpy_cc_fused_planes(ptrdiff_t n, const double *x, ptrdiff_t x_plane,
    ptrdiff_t x_stride, double *y, ptrdiff_t y_plane, ptrdiff_t y_stride) {
  ksl_coscrew_t x_i;
  if (n > 0) x_i = ksl_coscrew_of_planes(x, x_plane);
  KSL_EACH_OF(n) {
    if (x_stride) x_i = ksl_coscrew_of_planes(x + i * x_stride, x_plane);
    ksl_coscrew_t y_i = ksl_coscrew_of_planes(y + i * y_stride, y_plane);
    ksl_nxpy_cc_fused(&x_i, &y_i);
    ksl_coscrew_to_planes(&y_i, y + i * y_stride, y_plane);
  }
}

/* ksl_product_ac_fused of n elements. */
static KSL_INLINED void ksl_product_ac_fused_many(ptrdiff_t n, const double *a, ptrdiff_t a_stride,
    const ksl_coscrew_t *ci, ptrdiff_t ci_stride, ksl_coscrew_t *co,
    ptrdiff_t co_stride) {
  KSL_EACH_OF(n) {
    ksl_product_ac_fused(a[i * a_stride], ci + i * ci_stride, co + i * co_stride);
  }
}

static KSL_INLINED void ksl_product_ac_fused_planes(ptrdiff_t n, const double *a,
    ptrdiff_t a_stride, const double *ci, ptrdiff_t ci_plane,
    ptrdiff_t ci_stride, double *co, ptrdiff_t co_plane, ptrdiff_t co_stride) {
  KSL_EACH_OF(n) {
    const ksl_coscrew_t ci_i = ksl_coscrew_of_planes(ci + i * ci_stride, ci_plane);
    ksl_coscrew_t co_i;
    ksl_product_ac_fused(a[i * a_stride], &ci_i, &co_i);
    ksl_coscrew_to_planes(&co_i, co + i * co_stride, co_plane);
  }
}

/* ksl_add_cc_fused of n elements. */
static KSL_INLINED void ksl_add_cc_fused_many(ptrdiff_t n, const ksl_coscrew_t *c1,
    ptrdiff_t c1_stride, const ksl_coscrew_t *c2, ptrdiff_t c2_stride,
    ksl_coscrew_t *co, ptrdiff_t co_stride) {
  KSL_EACH_OF(n) {
    ksl_add_cc_fused(c1 + i * c1_stride, c2 + i * c2_stride, co + i * co_stride);
  }
}

static KSL_INLINED void ksl_add_cc_fused_planes(ptrdiff_t n, const double *c1, ptrdiff_t c1_plane,
    ptrdiff_t c1_stride, const double *c2, ptrdiff_t c2_plane,
    ptrdiff_t c2_stride, double *co, ptrdiff_t co_plane, ptrdiff_t co_stride) {
  ksl_coscrew_t c1_i;
  if (n > 0) c1_i = ksl_coscrew_of_planes(c1, c1_plane);
  KSL_EACH_OF(n) {
    if (c1_stride) c1_i = ksl_coscrew_of_planes(c1 + i * c1_stride, c1_plane);
    const ksl_coscrew_t c2_i = ksl_coscrew_of_planes(c2 + i * c2_stride, c2_plane);
    ksl_coscrew_t co_i;
    ksl_add_cc_fused(&c1_i, &c2_i, &co_i);
    ksl_coscrew_to_planes(&co_i, co + i * co_stride, co_plane);
  }
}

/* ksl_subtract_cc_fused of n elements. */
static KSL_INLINED void ksl_subtract_cc_fused_many(ptrdiff_t n, const ksl_coscrew_t *c1,
    ptrdiff_t c1_stride, const ksl_coscrew_t *c2, ptrdiff_t c2_stride,
    ksl_coscrew_t *co, ptrdiff_t co_stride) {
  KSL_EACH_OF(n) {
    ksl_subtract_cc_fused(c1 + i * c1_stride, c2 + i * c2_stride, co + i * co_stride);
  }
}

static KSL_INLINED void ksl_subtract_cc_fused_planes(ptrdiff_t n, const double *c1,
    ptrdiff_t c1_plane, ptrdiff_t c1_stride, const double *c2,
    ptrdiff_t c2_plane, ptrdiff_t c2_stride, double *co, ptrdiff_t co_plane,
    ptrdiff_t co_stride) {
  ksl_coscrew_t c1_i;
  if (n > 0) c1_i = ksl_coscrew_of_planes(c1, c1_plane);
  KSL_EACH_OF(n) {
    if (c1_stride) c1_i = ksl_coscrew_of_planes(c1 + i * c1_stride, c1_plane);
    const ksl_coscrew_t c2_i = ksl_coscrew_of_planes(c2 + i * c2_stride, c2_plane);
    ksl_coscrew_t co_i;
    ksl_subtract_cc_fused(&c1_i, &c2_i, &co_i);
    ksl_coscrew_to_planes(&co_i, co + i * co_stride, co_plane);
  }
}

/* ksl_add_cct_fused of n elements. */
static KSL_INLINED void ksl_add_cct_fused_many(ptrdiff_t n, const ksl_coscrew_t *c1,
    ptrdiff_t c1_stride, const ksl_coscrew_t *c2, ptrdiff_t c2_stride,
    ksl_coscrew_t *co, ptrdiff_t co_stride) {
  KSL_EACH_OF(n) {
    ksl_add_cct_fused(c1 + i * c1_stride, c2 + i * c2_stride, co + i * co_stride);
  }
}

static KSL_INLINED void ksl_add_cct_fused_planes(ptrdiff_t n, const double *c1, ptrdiff_t c1_plane,
    ptrdiff_t c1_stride, const double *c2, ptrdiff_t c2_plane,
    ptrdiff_t c2_stride, double *co, ptrdiff_t co_plane, ptrdiff_t co_stride) {
  ksl_coscrew_t c1_i;
  if (n > 0) c1_i = ksl_coscrew_of_planes(c1, c1_plane);
  KSL_EACH_OF(n) {
    if (c1_stride) c1_i = ksl_coscrew_of_planes(c1 + i * c1_stride, c1_plane);
    const ksl_coscrew_t c2_i = ksl_coscrew_of_planes(c2 + i * c2_stride, c2_plane);
    ksl_coscrew_t co_i;
    ksl_add_cct_fused(&c1_i, &c2_i, &co_i);
    ksl_coscrew_to_planes(&co_i, co + i * co_stride, co_plane);
  }
}

/* ksl_product_CoAdtc_fused of n elements. */
static KSL_INLINED void ksl_product_CoAdtc_fused_many(ptrdiff_t n, const ksl_vec3_t *t,
    ptrdiff_t t_stride, const ksl_coscrew_t *ci, ptrdiff_t ci_stride,
    ksl_coscrew_t *co, ptrdiff_t co_stride) {
  KSL_EACH_OF(n) {
    ksl_product_CoAdtc_fused(t + i * t_stride, ci + i * ci_stride, co + i * co_stride);
  }
}

static KSL_INLINED void ksl_product_CoAdtc_fused_planes(ptrdiff_t n, const double *t,
    ptrdiff_t t_plane, ptrdiff_t t_stride, const double *ci, ptrdiff_t ci_plane,
    ptrdiff_t ci_stride, double *co, ptrdiff_t co_plane, ptrdiff_t co_stride) {
  ksl_vec3_t t_i;
  if (n > 0) t_i = ksl_vec3_of_planes(t, t_plane);
  KSL_EACH_OF(n) {
    if (t_stride) t_i = ksl_vec3_of_planes(t + i * t_stride, t_plane);
    const ksl_coscrew_t ci_i = ksl_coscrew_of_planes(ci + i * ci_stride, ci_plane);
    ksl_coscrew_t co_i;
    ksl_product_CoAdtc_fused(&t_i, &ci_i, &co_i);
    ksl_coscrew_to_planes(&co_i, co + i * co_stride, co_plane);
  }
}

/* ksl_product_CoAdtinvc_fused of n elements. */
static KSL_INLINED void ksl_product_CoAdtinvc_fused_many(ptrdiff_t n, const ksl_vec3_t *t,
    ptrdiff_t t_stride, const ksl_coscrew_t *ci, ptrdiff_t ci_stride,
    ksl_coscrew_t *co, ptrdiff_t co_stride) {
  KSL_EACH_OF(n) {
    ksl_product_CoAdtinvc_fused(t + i * t_stride, ci + i * ci_stride, co + i * co_stride);
  }
}

static KSL_INLINED void ksl_product_CoAdtinvc_fused_planes(ptrdiff_t n, const double *t,
    ptrdiff_t t_plane, ptrdiff_t t_stride, const double *ci, ptrdiff_t ci_plane,
    ptrdiff_t ci_stride, double *co, ptrdiff_t co_plane, ptrdiff_t co_stride) {
  ksl_vec3_t t_i;
  if (n > 0) t_i = ksl_vec3_of_planes(t, t_plane);
  KSL_EACH_OF(n) {
    if (t_stride) t_i = ksl_vec3_of_planes(t + i * t_stride, t_plane);
    const ksl_coscrew_t ci_i = ksl_coscrew_of_planes(ci + i * ci_stride, ci_plane);
    ksl_coscrew_t co_i;
    ksl_product_CoAdtinvc_fused(&t_i, &ci_i, &co_i);
    ksl_coscrew_to_planes(&co_i, co + i * co_stride, co_plane);
  }
}

/* ksl_product_CoAdtcinv_fused of n elements. */
static KSL_INLINED void ksl_product_CoAdtcinv_fused_many(ptrdiff_t n, const ksl_vec3_t *t,
    ptrdiff_t t_stride, const ksl_coscrew_t *ci, ptrdiff_t ci_stride,
    ksl_coscrew_t *co, ptrdiff_t co_stride) {
  KSL_EACH_OF(n) {
    ksl_product_CoAdtcinv_fused(t + i * t_stride, ci + i * ci_stride, co + i * co_stride);
  }
}

static KSL_INLINED void ksl_product_CoAdtcinv_fused_planes(ptrdiff_t n, const double *t,
    ptrdiff_t t_plane, ptrdiff_t t_stride, const double *ci, ptrdiff_t ci_plane,
    ptrdiff_t ci_stride, double *co, ptrdiff_t co_plane, ptrdiff_t co_stride) {
  ksl_vec3_t t_i;
  if (n > 0) t_i = ksl_vec3_of_planes(t, t_plane);
  KSL_EACH_OF(n) {
    if (t_stride) t_i = ksl_vec3_of_planes(t + i * t_stride, t_plane);
    const ksl_coscrew_t ci_i = ksl_coscrew_of_planes(ci + i * ci_stride, ci_plane);
    ksl_coscrew_t co_i;
    ksl_product_CoAdtcinv_fused(&t_i, &ci_i, &co_i);
    ksl_coscrew_to_planes(&co_i, co + i * co_stride, co_plane);
  }
}

/* ksl_product_CoAdrc_fused of n elements. */
static KSL_INLINED void ksl_product_CoAdrc_fused_many(ptrdiff_t n, const ksl_mat3x3_t *R,
    ptrdiff_t R_stride, const ksl_coscrew_t *ci, ptrdiff_t ci_stride,
    ksl_coscrew_t *co, ptrdiff_t co_stride) {
  KSL_EACH_OF(n) {
    ksl_product_CoAdrc_fused(R + i * R_stride, ci + i * ci_stride, co + i * co_stride);
  }
}

static KSL_INLINED void ksl_product_CoAdrc_fused_planes(ptrdiff_t n, const double *R,
    ptrdiff_t R_plane, ptrdiff_t R_stride, const double *ci, ptrdiff_t ci_plane,
    ptrdiff_t ci_stride, double *co, ptrdiff_t co_plane, ptrdiff_t co_stride) {
  ksl_mat3x3_t R_i;
  if (n > 0) R_i = ksl_mat3x3_of_planes(R, R_plane);
  KSL_EACH_OF(n) {
    if (R_stride) R_i = ksl_mat3x3_of_planes(R + i * R_stride, R_plane);
    const ksl_coscrew_t ci_i = ksl_coscrew_of_planes(ci + i * ci_stride, ci_plane);
    ksl_coscrew_t co_i;
    ksl_product_CoAdrc_fused(&R_i, &ci_i, &co_i);
    ksl_coscrew_to_planes(&co_i, co + i * co_stride, co_plane);
  }
}

/* ksl_product_CoAdrinvc_fused of n elements. */
static KSL_INLINED void ksl_product_CoAdrinvc_fused_many(ptrdiff_t n, const ksl_mat3x3_t *R,
    ptrdiff_t R_stride, const ksl_coscrew_t *ci, ptrdiff_t ci_stride,
    ksl_coscrew_t *co, ptrdiff_t co_stride) {
  KSL_EACH_OF(n) {
    ksl_product_CoAdrinvc_fused(R + i * R_stride, ci + i * ci_stride, co + i * co_stride);
  }
}

static KSL_INLINED void ksl_product_CoAdrinvc_fused_planes(ptrdiff_t n, const double *R,
    ptrdiff_t R_plane, ptrdiff_t R_stride, const double *ci, ptrdiff_t ci_plane,
    ptrdiff_t ci_stride, double *co, ptrdiff_t co_plane, ptrdiff_t co_stride) {
  ksl_mat3x3_t R_i;
  if (n > 0) R_i = ksl_mat3x3_of_planes(R, R_plane);
  KSL_EACH_OF(n) {
    if (R_stride) R_i = ksl_mat3x3_of_planes(R + i * R_stride, R_plane);
    const ksl_coscrew_t ci_i = ksl_coscrew_of_planes(ci + i * ci_stride, ci_plane);
    ksl_coscrew_t co_i;
    ksl_product_CoAdrinvc_fused(&R_i, &ci_i, &co_i);
    ksl_coscrew_to_planes(&co_i, co + i * co_stride, co_plane);
  }
}

/* ksl_product_CoAdrcinv_fused of n elements. */
static KSL_INLINED void ksl_product_CoAdrcinv_fused_many(ptrdiff_t n, const ksl_mat3x3_t *R,
    ptrdiff_t R_stride, const ksl_coscrew_t *ci, ptrdiff_t ci_stride,
    ksl_coscrew_t *co, ptrdiff_t co_stride) {
  KSL_EACH_OF(n) {
    ksl_product_CoAdrcinv_fused(R + i * R_stride, ci + i * ci_stride, co + i * co_stride);
  }
}

static KSL_INLINED void ksl_product_CoAdrcinv_fused_planes(ptrdiff_t n, const double *R,
    ptrdiff_t R_plane, ptrdiff_t R_stride, const double *ci, ptrdiff_t ci_plane,
    ptrdiff_t ci_stride, double *co, ptrdiff_t co_plane, ptrdiff_t co_stride) {
  ksl_mat3x3_t R_i;
  if (n > 0) R_i = ksl_mat3x3_of_planes(R, R_plane);
  KSL_EACH_OF(n) {
    if (R_stride) R_i = ksl_mat3x3_of_planes(R + i * R_stride, R_plane);
    const ksl_coscrew_t ci_i = ksl_coscrew_of_planes(ci + i * ci_stride, ci_plane);
    ksl_coscrew_t co_i;
    ksl_product_CoAdrcinv_fused(&R_i, &ci_i, &co_i);
    ksl_coscrew_to_planes(&co_i, co + i * co_stride, co_plane);
  }
}

/* ksl_product_CoAdc_fused of n elements. */
static KSL_INLINED void ksl_product_CoAdc_fused_many(ptrdiff_t n, const ksl_SE3_t *D,
    ptrdiff_t D_stride, const ksl_coscrew_t *ci, ptrdiff_t ci_stride,
    ksl_coscrew_t *co, ptrdiff_t co_stride) {
  KSL_EACH_OF(n) {
    ksl_product_CoAdc_fused(D + i * D_stride, ci + i * ci_stride, co + i * co_stride);
  }
}

static KSL_INLINED void ksl_product_CoAdc_fused_planes(ptrdiff_t n, const double *D,
    ptrdiff_t D_plane, ptrdiff_t D_stride, const double *ci, ptrdiff_t ci_plane,
    ptrdiff_t ci_stride, double *co, ptrdiff_t co_plane, ptrdiff_t co_stride) {
  ksl_SE3_t D_i;
  if (n > 0) D_i = ksl_SE3_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3_of_planes(D + i * D_stride, D_plane);
    const ksl_coscrew_t ci_i = ksl_coscrew_of_planes(ci + i * ci_stride, ci_plane);
    ksl_coscrew_t co_i;
    ksl_product_CoAdc_fused(&D_i, &ci_i, &co_i);
    ksl_coscrew_to_planes(&co_i, co + i * co_stride, co_plane);
  }
}

/* ksl_product_CoAdinvc_fused of n elements. */
static KSL_INLINED void ksl_product_CoAdinvc_fused_many(ptrdiff_t n, const ksl_SE3_t *D,
    ptrdiff_t D_stride, const ksl_coscrew_t *ci, ptrdiff_t ci_stride,
    ksl_coscrew_t *co, ptrdiff_t co_stride) {
  KSL_EACH_OF(n) {
    ksl_product_CoAdinvc_fused(D + i * D_stride, ci + i * ci_stride, co + i * co_stride);
  }
}

static KSL_INLINED void ksl_product_CoAdinvc_fused_planes(ptrdiff_t n, const double *D,
    ptrdiff_t D_plane, ptrdiff_t D_stride, const double *ci, ptrdiff_t ci_plane,
    ptrdiff_t ci_stride, double *co, ptrdiff_t co_plane, ptrdiff_t co_stride) {
  ksl_SE3_t D_i;
  if (n > 0) D_i = ksl_SE3_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3_of_planes(D + i * D_stride, D_plane);
    const ksl_coscrew_t ci_i = ksl_coscrew_of_planes(ci + i * ci_stride, ci_plane);
    ksl_coscrew_t co_i;
    ksl_product_CoAdinvc_fused(&D_i, &ci_i, &co_i);
    ksl_coscrew_to_planes(&co_i, co + i * co_stride, co_plane);
  }
}

/* ksl_product_CoAdcinv_fused of n elements. */
static KSL_INLINED void ksl_product_CoAdcinv_fused_many(ptrdiff_t n, const ksl_SE3_t *D,
    ptrdiff_t D_stride, const ksl_coscrew_t *ci, ptrdiff_t ci_stride,
    ksl_coscrew_t *co, ptrdiff_t co_stride) {
  KSL_EACH_OF(n) {
    ksl_product_CoAdcinv_fused(D + i * D_stride, ci + i * ci_stride, co + i * co_stride);
  }
}

static KSL_INLINED void ksl_product_CoAdcinv_fused_planes(ptrdiff_t n, const double *D,
    ptrdiff_t D_plane, ptrdiff_t D_stride, const double *ci, ptrdiff_t ci_plane,
    ptrdiff_t ci_stride, double *co, ptrdiff_t co_plane, ptrdiff_t co_stride) {
  ksl_SE3_t D_i;
  if (n > 0) D_i = ksl_SE3_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3_of_planes(D + i * D_stride, D_plane);
    const ksl_coscrew_t ci_i = ksl_coscrew_of_planes(ci + i * ci_stride, ci_plane);
    ksl_coscrew_t co_i;
    ksl_product_CoAdcinv_fused(&D_i, &ci_i, &co_i);
    ksl_coscrew_to_planes(&co_i, co + i * co_stride, co_plane);
  }
}

/* ksl_hctx_fused of n elements. */
static KSL_INLINED void ksl_hctx_fused_many(ptrdiff_t n, const ksl_SE3_t *D, ptrdiff_t D_stride,
    ksl_coscrew_t *co, ptrdiff_t co_stride) {
  KSL_EACH_OF(n) {
    ksl_hctx_fused(D + i * D_stride, co + i * co_stride);
  }
}

static KSL_INLINED void ksl_hctx_fused_planes(ptrdiff_t n, const double *D, ptrdiff_t D_plane,
    ptrdiff_t D_stride, double *co, ptrdiff_t co_plane, ptrdiff_t co_stride) {
  ksl_SE3_t D_i;
  if (n > 0) D_i = ksl_SE3_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3_of_planes(D + i * D_stride, D_plane);
    ksl_coscrew_t co_i;
    ksl_hctx_fused(&D_i, &co_i);
    ksl_coscrew_to_planes(&co_i, co + i * co_stride, co_plane);
  }
}

/* ksl_hcty_fused of n elements. */
static KSL_INLINED void ksl_hcty_fused_many(ptrdiff_t n, const ksl_SE3_t *D, ptrdiff_t D_stride,
    ksl_coscrew_t *co, ptrdiff_t co_stride) {
  KSL_EACH_OF(n) {
    ksl_hcty_fused(D + i * D_stride, co + i * co_stride);
  }
}

static KSL_INLINED void ksl_hcty_fused_planes(ptrdiff_t n, const double *D, ptrdiff_t D_plane,
    ptrdiff_t D_stride, double *co, ptrdiff_t co_plane, ptrdiff_t co_stride) {
  ksl_SE3_t D_i;
  if (n > 0) D_i = ksl_SE3_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3_of_planes(D + i * D_stride, D_plane);
    ksl_coscrew_t co_i;
    ksl_hcty_fused(&D_i, &co_i);
    ksl_coscrew_to_planes(&co_i, co + i * co_stride, co_plane);
  }
}

/* ksl_hctz_fused of n elements. */
static KSL_INLINED void ksl_hctz_fused_many(ptrdiff_t n, const ksl_SE3_t *D, ptrdiff_t D_stride,
    ksl_coscrew_t *co, ptrdiff_t co_stride) {
  KSL_EACH_OF(n) {
    ksl_hctz_fused(D + i * D_stride, co + i * co_stride);
  }
}

static KSL_INLINED void ksl_hctz_fused_planes(ptrdiff_t n, const double *D, ptrdiff_t D_plane,
    ptrdiff_t D_stride, double *co, ptrdiff_t co_plane, ptrdiff_t co_stride) {
  ksl_SE3_t D_i;
  if (n > 0) D_i = ksl_SE3_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3_of_planes(D + i * D_stride, D_plane);
    ksl_coscrew_t co_i;
    ksl_hctz_fused(&D_i, &co_i);
    ksl_coscrew_to_planes(&co_i, co + i * co_stride, co_plane);
  }
}

/* ksl_hctxinv_fused of n elements. */
static KSL_INLINED void ksl_hctxinv_fused_many(ptrdiff_t n, const ksl_SE3_t *D, ptrdiff_t D_stride,
    ksl_coscrew_t *co, ptrdiff_t co_stride) {
  KSL_EACH_OF(n) {
    ksl_hctxinv_fused(D + i * D_stride, co + i * co_stride);
  }
}

static KSL_INLINED void ksl_hctxinv_fused_planes(ptrdiff_t n, const double *D, ptrdiff_t D_plane,
    ptrdiff_t D_stride, double *co, ptrdiff_t co_plane, ptrdiff_t co_stride) {
  ksl_SE3_t D_i;
  if (n > 0) D_i = ksl_SE3_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3_of_planes(D + i * D_stride, D_plane);
    ksl_coscrew_t co_i;
    ksl_hctxinv_fused(&D_i, &co_i);
    ksl_coscrew_to_planes(&co_i, co + i * co_stride, co_plane);
  }
}

/* ksl_hctyinv_fused of n elements. */
static KSL_INLINED void ksl_hctyinv_fused_many(ptrdiff_t n, const ksl_SE3_t *D, ptrdiff_t D_stride,
    ksl_coscrew_t *co, ptrdiff_t co_stride) {
  KSL_EACH_OF(n) {
    ksl_hctyinv_fused(D + i * D_stride, co + i * co_stride);
  }
}

static KSL_INLINED void ksl_hctyinv_fused_planes(ptrdiff_t n, const double *D, ptrdiff_t D_plane,
    ptrdiff_t D_stride, double *co, ptrdiff_t co_plane, ptrdiff_t co_stride) {
  ksl_SE3_t D_i;
  if (n > 0) D_i = ksl_SE3_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3_of_planes(D + i * D_stride, D_plane);
    ksl_coscrew_t co_i;
    ksl_hctyinv_fused(&D_i, &co_i);
    ksl_coscrew_to_planes(&co_i, co + i * co_stride, co_plane);
  }
}

/* ksl_hctzinv_fused of n elements. */
static KSL_INLINED void ksl_hctzinv_fused_many(ptrdiff_t n, const ksl_SE3_t *D, ptrdiff_t D_stride,
    ksl_coscrew_t *co, ptrdiff_t co_stride) {
  KSL_EACH_OF(n) {
    ksl_hctzinv_fused(D + i * D_stride, co + i * co_stride);
  }
}

static KSL_INLINED void ksl_hctzinv_fused_planes(ptrdiff_t n, const double *D, ptrdiff_t D_plane,
    ptrdiff_t D_stride, double *co, ptrdiff_t co_plane, ptrdiff_t co_stride) {
  ksl_SE3_t D_i;
  if (n > 0) D_i = ksl_SE3_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3_of_planes(D + i * D_stride, D_plane);
    ksl_coscrew_t co_i;
    ksl_hctzinv_fused(&D_i, &co_i);
    ksl_coscrew_to_planes(&co_i, co + i * co_stride, co_plane);
  }
}

/* ksl_CoAd_fused of n elements. */
static KSL_INLINED void ksl_CoAd_fused_many(ptrdiff_t n, const ksl_SE3_t *D, ptrdiff_t D_stride,
    ksl_mat6x6_t *M, ptrdiff_t M_stride) {
  KSL_EACH_OF(n) {
    ksl_CoAd_fused(D + i * D_stride, M + i * M_stride);
  }
}

static KSL_INLINED void ksl_CoAd_fused_planes(ptrdiff_t n, const double *D, ptrdiff_t D_plane,
    ptrdiff_t D_stride, double *M, ptrdiff_t M_plane, ptrdiff_t M_stride) {
  ksl_SE3_t D_i;
  if (n > 0) D_i = ksl_SE3_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3_of_planes(D + i * D_stride, D_plane);
    ksl_mat6x6_t M_i;
    ksl_CoAd_fused(&D_i, &M_i);
    ksl_mat6x6_to_planes(&M_i, M + i * M_stride, M_plane);
  }
}

/* ksl_reciprocal_product_fused of n elements. */
static KSL_INLINED void ksl_reciprocal_product_fused_many(ptrdiff_t n, const ksl_coscrew_t *c,
    ptrdiff_t c_stride, const double *x, ptrdiff_t x_stride, double *power,
    ptrdiff_t power_stride) {
  KSL_EACH_OF(n) {
    power[i * power_stride] = ksl_reciprocal_product_fused(c + i * c_stride, x + 6 * i * x_stride);
  }
}

static KSL_INLINED void ksl_reciprocal_product_fused_planes(ptrdiff_t n, const double *c,
    ptrdiff_t c_plane, ptrdiff_t c_stride, const double *x, ptrdiff_t x_plane,
    ptrdiff_t x_stride, double *power, ptrdiff_t power_stride) {
  ksl_coscrew_t c_i;
  if (n > 0) c_i = ksl_coscrew_of_planes(c, c_plane);
  KSL_EACH_OF(n) {
    if (c_stride) c_i = ksl_coscrew_of_planes(c + i * c_stride, c_plane);
    const double x_i[6] = {x[0 + i * x_stride], x[x_plane + i * x_stride],
        x[2 * x_plane + i * x_stride], x[3 * x_plane + i * x_stride], x[4 * x_plane + i * x_stride],
        x[5 * x_plane + i * x_stride]};
    power[i * power_stride] = ksl_reciprocal_product_fused(&c_i, x_i);
  }
}

/* ksl_cross_sc_fused of n elements. */
static KSL_INLINED void ksl_cross_sc_fused_many(ptrdiff_t n, const ksl_screw_t *s,
    ptrdiff_t s_stride, const ksl_coscrew_t *c, ptrdiff_t c_stride,
    ksl_coscrew_t *co, ptrdiff_t co_stride) {
  KSL_EACH_OF(n) {
    ksl_cross_sc_fused(s + i * s_stride, c + i * c_stride, co + i * co_stride);
  }
}

static KSL_INLINED void ksl_cross_sc_fused_planes(ptrdiff_t n, const double *s, ptrdiff_t s_plane,
    ptrdiff_t s_stride, const double *c, ptrdiff_t c_plane, ptrdiff_t c_stride,
    double *co, ptrdiff_t co_plane, ptrdiff_t co_stride) {
  ksl_screw_t s_i;
  if (n > 0) s_i = ksl_screw_of_planes(s, s_plane);
  KSL_EACH_OF(n) {
    if (s_stride) s_i = ksl_screw_of_planes(s + i * s_stride, s_plane);
    const ksl_coscrew_t c_i = ksl_coscrew_of_planes(c + i * c_stride, c_plane);
    ksl_coscrew_t co_i;
    ksl_cross_sc_fused(&s_i, &c_i, &co_i);
    ksl_coscrew_to_planes(&co_i, co + i * co_stride, co_plane);
  }
}

/* ksl_cross_sca_fused of n elements. */
static KSL_INLINED void ksl_cross_sca_fused_many(ptrdiff_t n, const ksl_screw_t *s,
    ptrdiff_t s_stride, const ksl_coscrew_t *c, ptrdiff_t c_stride,
    ksl_coscrew_t *co, ptrdiff_t co_stride) {
  KSL_EACH_OF(n) {
    ksl_cross_sca_fused(s + i * s_stride, c + i * c_stride, co + i * co_stride);
  }
}

static KSL_INLINED void ksl_cross_sca_fused_planes(ptrdiff_t n, const double *s, ptrdiff_t s_plane,
    ptrdiff_t s_stride, const double *c, ptrdiff_t c_plane, ptrdiff_t c_stride,
    double *co, ptrdiff_t co_plane, ptrdiff_t co_stride) {
  ksl_screw_t s_i;
  if (n > 0) s_i = ksl_screw_of_planes(s, s_plane);
  KSL_EACH_OF(n) {
    if (s_stride) s_i = ksl_screw_of_planes(s + i * s_stride, s_plane);
    const ksl_coscrew_t c_i = ksl_coscrew_of_planes(c + i * c_stride, c_plane);
    ksl_coscrew_t co_i;
    ksl_cross_sca_fused(&s_i, &c_i, &co_i);
    ksl_coscrew_to_planes(&co_i, co + i * co_stride, co_plane);
  }
}

/* ksl_constraint_ctx_fused of n elements. */
static KSL_INLINED void ksl_constraint_ctx_fused_many(ptrdiff_t n, const ksl_SE3_t *D,
    ptrdiff_t D_stride, const ksl_coscrew_t *c, ptrdiff_t c_stride,
    ksl_coscrew_t *co, ptrdiff_t co_stride) {
  KSL_EACH_OF(n) {
    ksl_constraint_ctx_fused(D + i * D_stride, c + i * c_stride, co + i * co_stride);
  }
}

static KSL_INLINED void ksl_constraint_ctx_fused_planes(ptrdiff_t n, const double *D,
    ptrdiff_t D_plane, ptrdiff_t D_stride, const double *c, ptrdiff_t c_plane,
    ptrdiff_t c_stride, double *co, ptrdiff_t co_plane, ptrdiff_t co_stride) {
  ksl_SE3_t D_i;
  if (n > 0) D_i = ksl_SE3_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3_of_planes(D + i * D_stride, D_plane);
    const ksl_coscrew_t c_i = ksl_coscrew_of_planes(c + i * c_stride, c_plane);
    ksl_coscrew_t co_i;
    ksl_constraint_ctx_fused(&D_i, &c_i, &co_i);
    ksl_coscrew_to_planes(&co_i, co + i * co_stride, co_plane);
  }
}

/* ksl_constraint_cty_fused of n elements. */
static KSL_INLINED void ksl_constraint_cty_fused_many(ptrdiff_t n, const ksl_SE3_t *D,
    ptrdiff_t D_stride, const ksl_coscrew_t *c, ptrdiff_t c_stride,
    ksl_coscrew_t *co, ptrdiff_t co_stride) {
  KSL_EACH_OF(n) {
    ksl_constraint_cty_fused(D + i * D_stride, c + i * c_stride, co + i * co_stride);
  }
}

static KSL_INLINED void ksl_constraint_cty_fused_planes(ptrdiff_t n, const double *D,
    ptrdiff_t D_plane, ptrdiff_t D_stride, const double *c, ptrdiff_t c_plane,
    ptrdiff_t c_stride, double *co, ptrdiff_t co_plane, ptrdiff_t co_stride) {
  ksl_SE3_t D_i;
  if (n > 0) D_i = ksl_SE3_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3_of_planes(D + i * D_stride, D_plane);
    const ksl_coscrew_t c_i = ksl_coscrew_of_planes(c + i * c_stride, c_plane);
    ksl_coscrew_t co_i;
    ksl_constraint_cty_fused(&D_i, &c_i, &co_i);
    ksl_coscrew_to_planes(&co_i, co + i * co_stride, co_plane);
  }
}

/* ksl_constraint_ctz_fused of n elements. */
static KSL_INLINED void ksl_constraint_ctz_fused_many(ptrdiff_t n, const ksl_SE3_t *D,
    ptrdiff_t D_stride, const ksl_coscrew_t *c, ptrdiff_t c_stride,
    ksl_coscrew_t *co, ptrdiff_t co_stride) {
  KSL_EACH_OF(n) {
    ksl_constraint_ctz_fused(D + i * D_stride, c + i * c_stride, co + i * co_stride);
  }
}

static KSL_INLINED void ksl_constraint_ctz_fused_planes(ptrdiff_t n, const double *D,
    ptrdiff_t D_plane, ptrdiff_t D_stride, const double *c, ptrdiff_t c_plane,
    ptrdiff_t c_stride, double *co, ptrdiff_t co_plane, ptrdiff_t co_stride) {
  ksl_SE3_t D_i;
  if (n > 0) D_i = ksl_SE3_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3_of_planes(D + i * D_stride, D_plane);
    const ksl_coscrew_t c_i = ksl_coscrew_of_planes(c + i * c_stride, c_plane);
    ksl_coscrew_t co_i;
    ksl_constraint_ctz_fused(&D_i, &c_i, &co_i);
    ksl_coscrew_to_planes(&co_i, co + i * co_stride, co_plane);
  }
}

/* ksl_constraint_crx_fused of n elements. */
static KSL_INLINED void ksl_constraint_crx_fused_many(ptrdiff_t n, const ksl_SE3_t *D,
    ptrdiff_t D_stride, const ksl_coscrew_t *c, ptrdiff_t c_stride,
    ksl_coscrew_t *co, ptrdiff_t co_stride) {
  KSL_EACH_OF(n) {
    ksl_constraint_crx_fused(D + i * D_stride, c + i * c_stride, co + i * co_stride);
  }
}

static KSL_INLINED void ksl_constraint_crx_fused_planes(ptrdiff_t n, const double *D,
    ptrdiff_t D_plane, ptrdiff_t D_stride, const double *c, ptrdiff_t c_plane,
    ptrdiff_t c_stride, double *co, ptrdiff_t co_plane, ptrdiff_t co_stride) {
  ksl_SE3_t D_i;
  if (n > 0) D_i = ksl_SE3_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3_of_planes(D + i * D_stride, D_plane);
    const ksl_coscrew_t c_i = ksl_coscrew_of_planes(c + i * c_stride, c_plane);
    ksl_coscrew_t co_i;
    ksl_constraint_crx_fused(&D_i, &c_i, &co_i);
    ksl_coscrew_to_planes(&co_i, co + i * co_stride, co_plane);
  }
}

/* ksl_constraint_cry_fused of n elements. */
static KSL_INLINED void ksl_constraint_cry_fused_many(ptrdiff_t n, const ksl_SE3_t *D,
    ptrdiff_t D_stride, const ksl_coscrew_t *c, ptrdiff_t c_stride,
    ksl_coscrew_t *co, ptrdiff_t co_stride) {
  KSL_EACH_OF(n) {
    ksl_constraint_cry_fused(D + i * D_stride, c + i * c_stride, co + i * co_stride);
  }
}

static KSL_INLINED void ksl_constraint_cry_fused_planes(ptrdiff_t n, const double *D,
    ptrdiff_t D_plane, ptrdiff_t D_stride, const double *c, ptrdiff_t c_plane,
    ptrdiff_t c_stride, double *co, ptrdiff_t co_plane, ptrdiff_t co_stride) {
  ksl_SE3_t D_i;
  if (n > 0) D_i = ksl_SE3_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3_of_planes(D + i * D_stride, D_plane);
    const ksl_coscrew_t c_i = ksl_coscrew_of_planes(c + i * c_stride, c_plane);
    ksl_coscrew_t co_i;
    ksl_constraint_cry_fused(&D_i, &c_i, &co_i);
    ksl_coscrew_to_planes(&co_i, co + i * co_stride, co_plane);
  }
}

/* ksl_constraint_crz_fused of n elements. */
static KSL_INLINED void ksl_constraint_crz_fused_many(ptrdiff_t n, const ksl_SE3_t *D,
    ptrdiff_t D_stride, const ksl_coscrew_t *c, ptrdiff_t c_stride,
    ksl_coscrew_t *co, ptrdiff_t co_stride) {
  KSL_EACH_OF(n) {
    ksl_constraint_crz_fused(D + i * D_stride, c + i * c_stride, co + i * co_stride);
  }
}

static KSL_INLINED void ksl_constraint_crz_fused_planes(ptrdiff_t n, const double *D,
    ptrdiff_t D_plane, ptrdiff_t D_stride, const double *c, ptrdiff_t c_plane,
    ptrdiff_t c_stride, double *co, ptrdiff_t co_plane, ptrdiff_t co_stride) {
  ksl_SE3_t D_i;
  if (n > 0) D_i = ksl_SE3_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3_of_planes(D + i * D_stride, D_plane);
    const ksl_coscrew_t c_i = ksl_coscrew_of_planes(c + i * c_stride, c_plane);
    ksl_coscrew_t co_i;
    ksl_constraint_crz_fused(&D_i, &c_i, &co_i);
    ksl_coscrew_to_planes(&co_i, co + i * co_stride, co_plane);
  }
}

/* ksl_working_ctx_fused of n elements. */
static KSL_INLINED void ksl_working_ctx_fused_many(ptrdiff_t n, const ksl_SE3_t *D,
    ptrdiff_t D_stride, const ksl_coscrew_t *c, ptrdiff_t c_stride,
    ksl_coscrew_t *co, ptrdiff_t co_stride) {
  KSL_EACH_OF(n) {
    ksl_working_ctx_fused(D + i * D_stride, c + i * c_stride, co + i * co_stride);
  }
}

static KSL_INLINED void ksl_working_ctx_fused_planes(ptrdiff_t n, const double *D,
    ptrdiff_t D_plane, ptrdiff_t D_stride, const double *c, ptrdiff_t c_plane,
    ptrdiff_t c_stride, double *co, ptrdiff_t co_plane, ptrdiff_t co_stride) {
  ksl_SE3_t D_i;
  if (n > 0) D_i = ksl_SE3_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3_of_planes(D + i * D_stride, D_plane);
    const ksl_coscrew_t c_i = ksl_coscrew_of_planes(c + i * c_stride, c_plane);
    ksl_coscrew_t co_i;
    ksl_working_ctx_fused(&D_i, &c_i, &co_i);
    ksl_coscrew_to_planes(&co_i, co + i * co_stride, co_plane);
  }
}

/* ksl_working_cty_fused of n elements. */
static KSL_INLINED void ksl_working_cty_fused_many(ptrdiff_t n, const ksl_SE3_t *D,
    ptrdiff_t D_stride, const ksl_coscrew_t *c, ptrdiff_t c_stride,
    ksl_coscrew_t *co, ptrdiff_t co_stride) {
  KSL_EACH_OF(n) {
    ksl_working_cty_fused(D + i * D_stride, c + i * c_stride, co + i * co_stride);
  }
}

static KSL_INLINED void ksl_working_cty_fused_planes(ptrdiff_t n, const double *D,
    ptrdiff_t D_plane, ptrdiff_t D_stride, const double *c, ptrdiff_t c_plane,
    ptrdiff_t c_stride, double *co, ptrdiff_t co_plane, ptrdiff_t co_stride) {
  ksl_SE3_t D_i;
  if (n > 0) D_i = ksl_SE3_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3_of_planes(D + i * D_stride, D_plane);
    const ksl_coscrew_t c_i = ksl_coscrew_of_planes(c + i * c_stride, c_plane);
    ksl_coscrew_t co_i;
    ksl_working_cty_fused(&D_i, &c_i, &co_i);
    ksl_coscrew_to_planes(&co_i, co + i * co_stride, co_plane);
  }
}

/* ksl_working_ctz_fused of n elements. */
static KSL_INLINED void ksl_working_ctz_fused_many(ptrdiff_t n, const ksl_SE3_t *D,
    ptrdiff_t D_stride, const ksl_coscrew_t *c, ptrdiff_t c_stride,
    ksl_coscrew_t *co, ptrdiff_t co_stride) {
  KSL_EACH_OF(n) {
    ksl_working_ctz_fused(D + i * D_stride, c + i * c_stride, co + i * co_stride);
  }
}

static KSL_INLINED void ksl_working_ctz_fused_planes(ptrdiff_t n, const double *D,
    ptrdiff_t D_plane, ptrdiff_t D_stride, const double *c, ptrdiff_t c_plane,
    ptrdiff_t c_stride, double *co, ptrdiff_t co_plane, ptrdiff_t co_stride) {
  ksl_SE3_t D_i;
  if (n > 0) D_i = ksl_SE3_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3_of_planes(D + i * D_stride, D_plane);
    const ksl_coscrew_t c_i = ksl_coscrew_of_planes(c + i * c_stride, c_plane);
    ksl_coscrew_t co_i;
    ksl_working_ctz_fused(&D_i, &c_i, &co_i);
    ksl_coscrew_to_planes(&co_i, co + i * co_stride, co_plane);
  }
}

/* ksl_working_crx_fused of n elements. */
static KSL_INLINED void ksl_working_crx_fused_many(ptrdiff_t n, const ksl_SE3_t *D,
    ptrdiff_t D_stride, const ksl_coscrew_t *c, ptrdiff_t c_stride,
    ksl_coscrew_t *co, ptrdiff_t co_stride) {
  KSL_EACH_OF(n) {
    ksl_working_crx_fused(D + i * D_stride, c + i * c_stride, co + i * co_stride);
  }
}

static KSL_INLINED void ksl_working_crx_fused_planes(ptrdiff_t n, const double *D,
    ptrdiff_t D_plane, ptrdiff_t D_stride, const double *c, ptrdiff_t c_plane,
    ptrdiff_t c_stride, double *co, ptrdiff_t co_plane, ptrdiff_t co_stride) {
  ksl_SE3_t D_i;
  if (n > 0) D_i = ksl_SE3_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3_of_planes(D + i * D_stride, D_plane);
    const ksl_coscrew_t c_i = ksl_coscrew_of_planes(c + i * c_stride, c_plane);
    ksl_coscrew_t co_i;
    ksl_working_crx_fused(&D_i, &c_i, &co_i);
    ksl_coscrew_to_planes(&co_i, co + i * co_stride, co_plane);
  }
}

/* ksl_working_cry_fused of n elements. */
static KSL_INLINED void ksl_working_cry_fused_many(ptrdiff_t n, const ksl_SE3_t *D,
    ptrdiff_t D_stride, const ksl_coscrew_t *c, ptrdiff_t c_stride,
    ksl_coscrew_t *co, ptrdiff_t co_stride) {
  KSL_EACH_OF(n) {
    ksl_working_cry_fused(D + i * D_stride, c + i * c_stride, co + i * co_stride);
  }
}

static KSL_INLINED void ksl_working_cry_fused_planes(ptrdiff_t n, const double *D,
    ptrdiff_t D_plane, ptrdiff_t D_stride, const double *c, ptrdiff_t c_plane,
    ptrdiff_t c_stride, double *co, ptrdiff_t co_plane, ptrdiff_t co_stride) {
  ksl_SE3_t D_i;
  if (n > 0) D_i = ksl_SE3_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3_of_planes(D + i * D_stride, D_plane);
    const ksl_coscrew_t c_i = ksl_coscrew_of_planes(c + i * c_stride, c_plane);
    ksl_coscrew_t co_i;
    ksl_working_cry_fused(&D_i, &c_i, &co_i);
    ksl_coscrew_to_planes(&co_i, co + i * co_stride, co_plane);
  }
}

/* ksl_working_crz_fused of n elements. */
static KSL_INLINED void ksl_working_crz_fused_many(ptrdiff_t n, const ksl_SE3_t *D,
    ptrdiff_t D_stride, const ksl_coscrew_t *c, ptrdiff_t c_stride,
    ksl_coscrew_t *co, ptrdiff_t co_stride) {
  KSL_EACH_OF(n) {
    ksl_working_crz_fused(D + i * D_stride, c + i * c_stride, co + i * co_stride);
  }
}

static KSL_INLINED void ksl_working_crz_fused_planes(ptrdiff_t n, const double *D,
    ptrdiff_t D_plane, ptrdiff_t D_stride, const double *c, ptrdiff_t c_plane,
    ptrdiff_t c_stride, double *co, ptrdiff_t co_plane, ptrdiff_t co_stride) {
  ksl_SE3_t D_i;
  if (n > 0) D_i = ksl_SE3_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3_of_planes(D + i * D_stride, D_plane);
    const ksl_coscrew_t c_i = ksl_coscrew_of_planes(c + i * c_stride, c_plane);
    ksl_coscrew_t co_i;
    ksl_working_crz_fused(&D_i, &c_i, &co_i);
    ksl_coscrew_to_planes(&co_i, co + i * co_stride, co_plane);
  }
}

/* ksl_coscrewf_scale_fused of n elements. */
static KSL_INLINED void ksl_coscrewf_scale_fused_many(ptrdiff_t n, ksl_coscrewf_t *self,
    ptrdiff_t self_stride, const float *a, ptrdiff_t a_stride) {
  KSL_EACH_OF(n) {
    ksl_coscrewf_scale_fused(self + i * self_stride, a[i * a_stride]);
  }
}

static KSL_INLINED void ksl_coscrewf_scale_fused_planes(ptrdiff_t n, float *self,
    ptrdiff_t self_plane, ptrdiff_t self_stride, const float *a,
    ptrdiff_t a_stride) {
  KSL_EACH_OF(n) {
    ksl_coscrewf_t self_i = ksl_coscrewf_of_planes(self + i * self_stride, self_plane);
    ksl_coscrewf_scale_fused(&self_i, a[i * a_stride]);
    ksl_coscrewf_to_planes(&self_i, self + i * self_stride, self_plane);
  }
}

/* ksl_axpy_ccf_fused of n elements. */
static KSL_INLINED void ksl_axpy_ccf_fused_many(ptrdiff_t n, const float *a, ptrdiff_t a_stride,
    const ksl_coscrewf_t *x, ptrdiff_t x_stride, ksl_coscrewf_t *y,
    ptrdiff_t y_stride) {
  KSL_EACH_OF(n) {
    ksl_axpy_ccf_fused(a[i * a_stride], x + i * x_stride, y + i * y_stride);
  }
}

static KSL_INLINED void ksl_axpy_ccf_fused_planes(ptrdiff_t n, const float *a, ptrdiff_t a_stride,
    const float *x, ptrdiff_t x_plane, ptrdiff_t x_stride, float *y,
    ptrdiff_t y_plane, ptrdiff_t y_stride) {
  KSL_EACH_OF(n) {
    const ksl_coscrewf_t x_i = ksl_coscrewf_of_planes(x + i * x_stride, x_plane);
    ksl_coscrewf_t y_i = ksl_coscrewf_of_planes(y + i * y_stride, y_plane);
    ksl_axpy_ccf_fused(a[i * a_stride], &x_i, &y_i);
    ksl_coscrewf_to_planes(&y_i, y + i * y_stride, y_plane);
  }
}

/* ksl_xpy_ccf_fused of n elements. */
static KSL_INLINED void ksl_xpy_ccf_fused_many(ptrdiff_t n, const ksl_coscrewf_t *x,
    ptrdiff_t x_stride, ksl_coscrewf_t *y, ptrdiff_t y_stride) {
  KSL_EACH_OF(n) {
    ksl_xpy_ccf_fused(x + i * x_stride, y + i * y_stride);
  }
}

static KSL_INLINED void ksl_xpy_ccf_fused_planes(ptrdiff_t n, const float *x, ptrdiff_t x_plane,
    ptrdiff_t x_stride, float *y, ptrdiff_t y_plane, ptrdiff_t y_stride) {
  ksl_coscrewf_t x_i;
  if (n > 0) x_i = ksl_coscrewf_of_planes(x, x_plane);
  KSL_EACH_OF(n) {
    if (x_stride) x_i = ksl_coscrewf_of_planes(x + i * x_stride, x_plane);
    ksl_coscrewf_t y_i = ksl_coscrewf_of_planes(y + i * y_stride, y_plane);
    ksl_xpy_ccf_fused(&x_i, &y_i);
    ksl_coscrewf_to_planes(&y_i, y + i * y_stride, y_plane);
  }
}

/* ksl_nxpy_ccf_fused of n elements. */
static KSL_INLINED void ksl_nxpy_ccf_fused_many(ptrdiff_t n, const ksl_coscrewf_t *x,
    ptrdiff_t x_stride, ksl_coscrewf_t *y, ptrdiff_t y_stride) {
  KSL_EACH_OF(n) {
    ksl_nxpy_ccf_fused(x + i * x_stride, y + i * y_stride);
  }
}

static KSL_INLINED void ksl_nxpy_ccf_fused_planes(ptrdiff_t n, const float *x, ptrdiff_t x_plane,
    ptrdiff_t x_stride, float *y, ptrdiff_t y_plane, ptrdiff_t y_stride) {
  ksl_coscrewf_t x_i;
  if (n > 0) x_i = ksl_coscrewf_of_planes(x, x_plane);
  KSL_EACH_OF(n) {
    if (x_stride) x_i = ksl_coscrewf_of_planes(x + i * x_stride, x_plane);
    ksl_coscrewf_t y_i = ksl_coscrewf_of_planes(y + i * y_stride, y_plane);
    ksl_nxpy_ccf_fused(&x_i, &y_i);
    ksl_coscrewf_to_planes(&y_i, y + i * y_stride, y_plane);
  }
}

/* ksl_product_acf_fused of n elements. */
static KSL_INLINED void ksl_product_acf_fused_many(ptrdiff_t n, const float *a, ptrdiff_t a_stride,
    const ksl_coscrewf_t *ci, ptrdiff_t ci_stride, ksl_coscrewf_t *co,
    ptrdiff_t co_stride) {
  KSL_EACH_OF(n) {
    ksl_product_acf_fused(a[i * a_stride], ci + i * ci_stride, co + i * co_stride);
  }
}

static KSL_INLINED void ksl_product_acf_fused_planes(ptrdiff_t n, const float *a,
    ptrdiff_t a_stride, const float *ci, ptrdiff_t ci_plane, ptrdiff_t ci_stride,
    float *co, ptrdiff_t co_plane, ptrdiff_t co_stride) {
  KSL_EACH_OF(n) {
    const ksl_coscrewf_t ci_i = ksl_coscrewf_of_planes(ci + i * ci_stride, ci_plane);
    ksl_coscrewf_t co_i;
    ksl_product_acf_fused(a[i * a_stride], &ci_i, &co_i);
    ksl_coscrewf_to_planes(&co_i, co + i * co_stride, co_plane);
  }
}

/* ksl_add_ccf_fused of n elements. */
static KSL_INLINED void ksl_add_ccf_fused_many(ptrdiff_t n, const ksl_coscrewf_t *c1,
    ptrdiff_t c1_stride, const ksl_coscrewf_t *c2, ptrdiff_t c2_stride,
    ksl_coscrewf_t *co, ptrdiff_t co_stride) {
  KSL_EACH_OF(n) {
    ksl_add_ccf_fused(c1 + i * c1_stride, c2 + i * c2_stride, co + i * co_stride);
  }
}

static KSL_INLINED void ksl_add_ccf_fused_planes(ptrdiff_t n, const float *c1, ptrdiff_t c1_plane,
    ptrdiff_t c1_stride, const float *c2, ptrdiff_t c2_plane,
    ptrdiff_t c2_stride, float *co, ptrdiff_t co_plane, ptrdiff_t co_stride) {
  ksl_coscrewf_t c1_i;
  if (n > 0) c1_i = ksl_coscrewf_of_planes(c1, c1_plane);
  KSL_EACH_OF(n) {
    if (c1_stride) c1_i = ksl_coscrewf_of_planes(c1 + i * c1_stride, c1_plane);
    const ksl_coscrewf_t c2_i = ksl_coscrewf_of_planes(c2 + i * c2_stride, c2_plane);
    ksl_coscrewf_t co_i;
    ksl_add_ccf_fused(&c1_i, &c2_i, &co_i);
    ksl_coscrewf_to_planes(&co_i, co + i * co_stride, co_plane);
  }
}

/* ksl_subtract_ccf_fused of n elements. */
static KSL_INLINED void ksl_subtract_ccf_fused_many(ptrdiff_t n, const ksl_coscrewf_t *c1,
    ptrdiff_t c1_stride, const ksl_coscrewf_t *c2, ptrdiff_t c2_stride,
    ksl_coscrewf_t *co, ptrdiff_t co_stride) {
  KSL_EACH_OF(n) {
    ksl_subtract_ccf_fused(c1 + i * c1_stride, c2 + i * c2_stride, co + i * co_stride);
  }
}

static KSL_INLINED void ksl_subtract_ccf_fused_planes(ptrdiff_t n, const float *c1,
    ptrdiff_t c1_plane, ptrdiff_t c1_stride, const float *c2, ptrdiff_t c2_plane,
    ptrdiff_t c2_stride, float *co, ptrdiff_t co_plane, ptrdiff_t co_stride) {
  ksl_coscrewf_t c1_i;
  if (n > 0) c1_i = ksl_coscrewf_of_planes(c1, c1_plane);
  KSL_EACH_OF(n) {
    if (c1_stride) c1_i = ksl_coscrewf_of_planes(c1 + i * c1_stride, c1_plane);
    const ksl_coscrewf_t c2_i = ksl_coscrewf_of_planes(c2 + i * c2_stride, c2_plane);
    ksl_coscrewf_t co_i;
    ksl_subtract_ccf_fused(&c1_i, &c2_i, &co_i);
    ksl_coscrewf_to_planes(&co_i, co + i * co_stride, co_plane);
  }
}

/* ksl_add_cctf_fused of n elements. */
static KSL_INLINED void ksl_add_cctf_fused_many(ptrdiff_t n, const ksl_coscrewf_t *c1,
    ptrdiff_t c1_stride, const ksl_coscrewf_t *c2, ptrdiff_t c2_stride,
    ksl_coscrewf_t *co, ptrdiff_t co_stride) {
  KSL_EACH_OF(n) {
    ksl_add_cctf_fused(c1 + i * c1_stride, c2 + i * c2_stride, co + i * co_stride);
  }
}

static KSL_INLINED void ksl_add_cctf_fused_planes(ptrdiff_t n, const float *c1, ptrdiff_t c1_plane,
    ptrdiff_t c1_stride, const float *c2, ptrdiff_t c2_plane,
    ptrdiff_t c2_stride, float *co, ptrdiff_t co_plane, ptrdiff_t co_stride) {
  ksl_coscrewf_t c1_i;
  if (n > 0) c1_i = ksl_coscrewf_of_planes(c1, c1_plane);
  KSL_EACH_OF(n) {
    if (c1_stride) c1_i = ksl_coscrewf_of_planes(c1 + i * c1_stride, c1_plane);
    const ksl_coscrewf_t c2_i = ksl_coscrewf_of_planes(c2 + i * c2_stride, c2_plane);
    ksl_coscrewf_t co_i;
    ksl_add_cctf_fused(&c1_i, &c2_i, &co_i);
    ksl_coscrewf_to_planes(&co_i, co + i * co_stride, co_plane);
  }
}

/* ksl_product_CoAdtcf_fused of n elements. */
static KSL_INLINED void ksl_product_CoAdtcf_fused_many(ptrdiff_t n, const ksl_vec3f_t *t,
    ptrdiff_t t_stride, const ksl_coscrewf_t *ci, ptrdiff_t ci_stride,
    ksl_coscrewf_t *co, ptrdiff_t co_stride) {
  KSL_EACH_OF(n) {
    ksl_product_CoAdtcf_fused(t + i * t_stride, ci + i * ci_stride, co + i * co_stride);
  }
}

static KSL_INLINED void ksl_product_CoAdtcf_fused_planes(ptrdiff_t n, const float *t,
    ptrdiff_t t_plane, ptrdiff_t t_stride, const float *ci, ptrdiff_t ci_plane,
    ptrdiff_t ci_stride, float *co, ptrdiff_t co_plane, ptrdiff_t co_stride) {
  ksl_vec3f_t t_i;
  if (n > 0) t_i = ksl_vec3f_of_planes(t, t_plane);
  KSL_EACH_OF(n) {
    if (t_stride) t_i = ksl_vec3f_of_planes(t + i * t_stride, t_plane);
    const ksl_coscrewf_t ci_i = ksl_coscrewf_of_planes(ci + i * ci_stride, ci_plane);
    ksl_coscrewf_t co_i;
    ksl_product_CoAdtcf_fused(&t_i, &ci_i, &co_i);
    ksl_coscrewf_to_planes(&co_i, co + i * co_stride, co_plane);
  }
}

/* ksl_product_CoAdtinvcf_fused of n elements. */
static KSL_INLINED void ksl_product_CoAdtinvcf_fused_many(ptrdiff_t n, const ksl_vec3f_t *t,
    ptrdiff_t t_stride, const ksl_coscrewf_t *ci, ptrdiff_t ci_stride,
    ksl_coscrewf_t *co, ptrdiff_t co_stride) {
  KSL_EACH_OF(n) {
    ksl_product_CoAdtinvcf_fused(t + i * t_stride, ci + i * ci_stride, co + i * co_stride);
  }
}

static KSL_INLINED void ksl_product_CoAdtinvcf_fused_planes(ptrdiff_t n, const float *t,
    ptrdiff_t t_plane, ptrdiff_t t_stride, const float *ci, ptrdiff_t ci_plane,
    ptrdiff_t ci_stride, float *co, ptrdiff_t co_plane, ptrdiff_t co_stride) {
  ksl_vec3f_t t_i;
  if (n > 0) t_i = ksl_vec3f_of_planes(t, t_plane);
  KSL_EACH_OF(n) {
    if (t_stride) t_i = ksl_vec3f_of_planes(t + i * t_stride, t_plane);
    const ksl_coscrewf_t ci_i = ksl_coscrewf_of_planes(ci + i * ci_stride, ci_plane);
    ksl_coscrewf_t co_i;
    ksl_product_CoAdtinvcf_fused(&t_i, &ci_i, &co_i);
    ksl_coscrewf_to_planes(&co_i, co + i * co_stride, co_plane);
  }
}

/* ksl_product_CoAdtcinvf_fused of n elements. */
static KSL_INLINED void ksl_product_CoAdtcinvf_fused_many(ptrdiff_t n, const ksl_vec3f_t *t,
    ptrdiff_t t_stride, const ksl_coscrewf_t *ci, ptrdiff_t ci_stride,
    ksl_coscrewf_t *co, ptrdiff_t co_stride) {
  KSL_EACH_OF(n) {
    ksl_product_CoAdtcinvf_fused(t + i * t_stride, ci + i * ci_stride, co + i * co_stride);
  }
}

static KSL_INLINED void ksl_product_CoAdtcinvf_fused_planes(ptrdiff_t n, const float *t,
    ptrdiff_t t_plane, ptrdiff_t t_stride, const float *ci, ptrdiff_t ci_plane,
    ptrdiff_t ci_stride, float *co, ptrdiff_t co_plane, ptrdiff_t co_stride) {
  ksl_vec3f_t t_i;
  if (n > 0) t_i = ksl_vec3f_of_planes(t, t_plane);
  KSL_EACH_OF(n) {
    if (t_stride) t_i = ksl_vec3f_of_planes(t + i * t_stride, t_plane);
    const ksl_coscrewf_t ci_i = ksl_coscrewf_of_planes(ci + i * ci_stride, ci_plane);
    ksl_coscrewf_t co_i;
    ksl_product_CoAdtcinvf_fused(&t_i, &ci_i, &co_i);
    ksl_coscrewf_to_planes(&co_i, co + i * co_stride, co_plane);
  }
}

/* ksl_product_CoAdrcf_fused of n elements. */
static KSL_INLINED void ksl_product_CoAdrcf_fused_many(ptrdiff_t n, const ksl_mat3x3f_t *R,
    ptrdiff_t R_stride, const ksl_coscrewf_t *ci, ptrdiff_t ci_stride,
    ksl_coscrewf_t *co, ptrdiff_t co_stride) {
  KSL_EACH_OF(n) {
    ksl_product_CoAdrcf_fused(R + i * R_stride, ci + i * ci_stride, co + i * co_stride);
  }
}

static KSL_INLINED void ksl_product_CoAdrcf_fused_planes(ptrdiff_t n, const float *R,
    ptrdiff_t R_plane, ptrdiff_t R_stride, const float *ci, ptrdiff_t ci_plane,
    ptrdiff_t ci_stride, float *co, ptrdiff_t co_plane, ptrdiff_t co_stride) {
  ksl_mat3x3f_t R_i;
  if (n > 0) R_i = ksl_mat3x3f_of_planes(R, R_plane);
  KSL_EACH_OF(n) {
    if (R_stride) R_i = ksl_mat3x3f_of_planes(R + i * R_stride, R_plane);
    const ksl_coscrewf_t ci_i = ksl_coscrewf_of_planes(ci + i * ci_stride, ci_plane);
    ksl_coscrewf_t co_i;
    ksl_product_CoAdrcf_fused(&R_i, &ci_i, &co_i);
    ksl_coscrewf_to_planes(&co_i, co + i * co_stride, co_plane);
  }
}

/* ksl_product_CoAdrinvcf_fused of n elements. */
static KSL_INLINED void ksl_product_CoAdrinvcf_fused_many(ptrdiff_t n, const ksl_mat3x3f_t *R,
    ptrdiff_t R_stride, const ksl_coscrewf_t *ci, ptrdiff_t ci_stride,
    ksl_coscrewf_t *co, ptrdiff_t co_stride) {
  KSL_EACH_OF(n) {
    ksl_product_CoAdrinvcf_fused(R + i * R_stride, ci + i * ci_stride, co + i * co_stride);
  }
}

static KSL_INLINED void ksl_product_CoAdrinvcf_fused_planes(ptrdiff_t n, const float *R,
    ptrdiff_t R_plane, ptrdiff_t R_stride, const float *ci, ptrdiff_t ci_plane,
    ptrdiff_t ci_stride, float *co, ptrdiff_t co_plane, ptrdiff_t co_stride) {
  ksl_mat3x3f_t R_i;
  if (n > 0) R_i = ksl_mat3x3f_of_planes(R, R_plane);
  KSL_EACH_OF(n) {
    if (R_stride) R_i = ksl_mat3x3f_of_planes(R + i * R_stride, R_plane);
    const ksl_coscrewf_t ci_i = ksl_coscrewf_of_planes(ci + i * ci_stride, ci_plane);
    ksl_coscrewf_t co_i;
    ksl_product_CoAdrinvcf_fused(&R_i, &ci_i, &co_i);
    ksl_coscrewf_to_planes(&co_i, co + i * co_stride, co_plane);
  }
}

/* ksl_product_CoAdrcinvf_fused of n elements. */
static KSL_INLINED void ksl_product_CoAdrcinvf_fused_many(ptrdiff_t n, const ksl_mat3x3f_t *R,
    ptrdiff_t R_stride, const ksl_coscrewf_t *ci, ptrdiff_t ci_stride,
    ksl_coscrewf_t *co, ptrdiff_t co_stride) {
  KSL_EACH_OF(n) {
    ksl_product_CoAdrcinvf_fused(R + i * R_stride, ci + i * ci_stride, co + i * co_stride);
  }
}

static KSL_INLINED void ksl_product_CoAdrcinvf_fused_planes(ptrdiff_t n, const float *R,
    ptrdiff_t R_plane, ptrdiff_t R_stride, const float *ci, ptrdiff_t ci_plane,
    ptrdiff_t ci_stride, float *co, ptrdiff_t co_plane, ptrdiff_t co_stride) {
  ksl_mat3x3f_t R_i;
  if (n > 0) R_i = ksl_mat3x3f_of_planes(R, R_plane);
  KSL_EACH_OF(n) {
    if (R_stride) R_i = ksl_mat3x3f_of_planes(R + i * R_stride, R_plane);
    const ksl_coscrewf_t ci_i = ksl_coscrewf_of_planes(ci + i * ci_stride, ci_plane);
    ksl_coscrewf_t co_i;
    ksl_product_CoAdrcinvf_fused(&R_i, &ci_i, &co_i);
    ksl_coscrewf_to_planes(&co_i, co + i * co_stride, co_plane);
  }
}

/* ksl_product_CoAdcf_fused of n elements. */
static KSL_INLINED void ksl_product_CoAdcf_fused_many(ptrdiff_t n, const ksl_SE3f_t *D,
    ptrdiff_t D_stride, const ksl_coscrewf_t *ci, ptrdiff_t ci_stride,
    ksl_coscrewf_t *co, ptrdiff_t co_stride) {
  KSL_EACH_OF(n) {
    ksl_product_CoAdcf_fused(D + i * D_stride, ci + i * ci_stride, co + i * co_stride);
  }
}

static KSL_INLINED void ksl_product_CoAdcf_fused_planes(ptrdiff_t n, const float *D,
    ptrdiff_t D_plane, ptrdiff_t D_stride, const float *ci, ptrdiff_t ci_plane,
    ptrdiff_t ci_stride, float *co, ptrdiff_t co_plane, ptrdiff_t co_stride) {
  ksl_SE3f_t D_i;
  if (n > 0) D_i = ksl_SE3f_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3f_of_planes(D + i * D_stride, D_plane);
    const ksl_coscrewf_t ci_i = ksl_coscrewf_of_planes(ci + i * ci_stride, ci_plane);
    ksl_coscrewf_t co_i;
    ksl_product_CoAdcf_fused(&D_i, &ci_i, &co_i);
    ksl_coscrewf_to_planes(&co_i, co + i * co_stride, co_plane);
  }
}

/* ksl_product_CoAdinvcf_fused of n elements. */
static KSL_INLINED void ksl_product_CoAdinvcf_fused_many(ptrdiff_t n, const ksl_SE3f_t *D,
    ptrdiff_t D_stride, const ksl_coscrewf_t *ci, ptrdiff_t ci_stride,
    ksl_coscrewf_t *co, ptrdiff_t co_stride) {
  KSL_EACH_OF(n) {
    ksl_product_CoAdinvcf_fused(D + i * D_stride, ci + i * ci_stride, co + i * co_stride);
  }
}

static KSL_INLINED void ksl_product_CoAdinvcf_fused_planes(ptrdiff_t n, const float *D,
    ptrdiff_t D_plane, ptrdiff_t D_stride, const float *ci, ptrdiff_t ci_plane,
    ptrdiff_t ci_stride, float *co, ptrdiff_t co_plane, ptrdiff_t co_stride) {
  ksl_SE3f_t D_i;
  if (n > 0) D_i = ksl_SE3f_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3f_of_planes(D + i * D_stride, D_plane);
    const ksl_coscrewf_t ci_i = ksl_coscrewf_of_planes(ci + i * ci_stride, ci_plane);
    ksl_coscrewf_t co_i;
    ksl_product_CoAdinvcf_fused(&D_i, &ci_i, &co_i);
    ksl_coscrewf_to_planes(&co_i, co + i * co_stride, co_plane);
  }
}

/* ksl_product_CoAdcinvf_fused of n elements. */
static KSL_INLINED void ksl_product_CoAdcinvf_fused_many(ptrdiff_t n, const ksl_SE3f_t *D,
    ptrdiff_t D_stride, const ksl_coscrewf_t *ci, ptrdiff_t ci_stride,
    ksl_coscrewf_t *co, ptrdiff_t co_stride) {
  KSL_EACH_OF(n) {
    ksl_product_CoAdcinvf_fused(D + i * D_stride, ci + i * ci_stride, co + i * co_stride);
  }
}

static KSL_INLINED void ksl_product_CoAdcinvf_fused_planes(ptrdiff_t n, const float *D,
    ptrdiff_t D_plane, ptrdiff_t D_stride, const float *ci, ptrdiff_t ci_plane,
    ptrdiff_t ci_stride, float *co, ptrdiff_t co_plane, ptrdiff_t co_stride) {
  ksl_SE3f_t D_i;
  if (n > 0) D_i = ksl_SE3f_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3f_of_planes(D + i * D_stride, D_plane);
    const ksl_coscrewf_t ci_i = ksl_coscrewf_of_planes(ci + i * ci_stride, ci_plane);
    ksl_coscrewf_t co_i;
    ksl_product_CoAdcinvf_fused(&D_i, &ci_i, &co_i);
    ksl_coscrewf_to_planes(&co_i, co + i * co_stride, co_plane);
  }
}

/* ksl_hctxf_fused of n elements. */
static KSL_INLINED void ksl_hctxf_fused_many(ptrdiff_t n, const ksl_SE3f_t *D, ptrdiff_t D_stride,
    ksl_coscrewf_t *co, ptrdiff_t co_stride) {
  KSL_EACH_OF(n) {
    ksl_hctxf_fused(D + i * D_stride, co + i * co_stride);
  }
}

static KSL_INLINED void ksl_hctxf_fused_planes(ptrdiff_t n, const float *D, ptrdiff_t D_plane,
    ptrdiff_t D_stride, float *co, ptrdiff_t co_plane, ptrdiff_t co_stride) {
  ksl_SE3f_t D_i;
  if (n > 0) D_i = ksl_SE3f_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3f_of_planes(D + i * D_stride, D_plane);
    ksl_coscrewf_t co_i;
    ksl_hctxf_fused(&D_i, &co_i);
    ksl_coscrewf_to_planes(&co_i, co + i * co_stride, co_plane);
  }
}

/* ksl_hctyf_fused of n elements. */
static KSL_INLINED void ksl_hctyf_fused_many(ptrdiff_t n, const ksl_SE3f_t *D, ptrdiff_t D_stride,
    ksl_coscrewf_t *co, ptrdiff_t co_stride) {
  KSL_EACH_OF(n) {
    ksl_hctyf_fused(D + i * D_stride, co + i * co_stride);
  }
}

static KSL_INLINED void ksl_hctyf_fused_planes(ptrdiff_t n, const float *D, ptrdiff_t D_plane,
    ptrdiff_t D_stride, float *co, ptrdiff_t co_plane, ptrdiff_t co_stride) {
  ksl_SE3f_t D_i;
  if (n > 0) D_i = ksl_SE3f_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3f_of_planes(D + i * D_stride, D_plane);
    ksl_coscrewf_t co_i;
    ksl_hctyf_fused(&D_i, &co_i);
    ksl_coscrewf_to_planes(&co_i, co + i * co_stride, co_plane);
  }
}

/* ksl_hctzf_fused of n elements. */
static KSL_INLINED void ksl_hctzf_fused_many(ptrdiff_t n, const ksl_SE3f_t *D, ptrdiff_t D_stride,
    ksl_coscrewf_t *co, ptrdiff_t co_stride) {
  KSL_EACH_OF(n) {
    ksl_hctzf_fused(D + i * D_stride, co + i * co_stride);
  }
}

static KSL_INLINED void ksl_hctzf_fused_planes(ptrdiff_t n, const float *D, ptrdiff_t D_plane,
    ptrdiff_t D_stride, float *co, ptrdiff_t co_plane, ptrdiff_t co_stride) {
  ksl_SE3f_t D_i;
  if (n > 0) D_i = ksl_SE3f_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3f_of_planes(D + i * D_stride, D_plane);
    ksl_coscrewf_t co_i;
    ksl_hctzf_fused(&D_i, &co_i);
    ksl_coscrewf_to_planes(&co_i, co + i * co_stride, co_plane);
  }
}

/* ksl_hctxinvf_fused of n elements. */
static KSL_INLINED void ksl_hctxinvf_fused_many(ptrdiff_t n, const ksl_SE3f_t *D,
    ptrdiff_t D_stride, ksl_coscrewf_t *co, ptrdiff_t co_stride) {
  KSL_EACH_OF(n) {
    ksl_hctxinvf_fused(D + i * D_stride, co + i * co_stride);
  }
}

static KSL_INLINED void ksl_hctxinvf_fused_planes(ptrdiff_t n, const float *D, ptrdiff_t D_plane,
    ptrdiff_t D_stride, float *co, ptrdiff_t co_plane, ptrdiff_t co_stride) {
  ksl_SE3f_t D_i;
  if (n > 0) D_i = ksl_SE3f_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3f_of_planes(D + i * D_stride, D_plane);
    ksl_coscrewf_t co_i;
    ksl_hctxinvf_fused(&D_i, &co_i);
    ksl_coscrewf_to_planes(&co_i, co + i * co_stride, co_plane);
  }
}

/* ksl_hctyinvf_fused of n elements. */
static KSL_INLINED void ksl_hctyinvf_fused_many(ptrdiff_t n, const ksl_SE3f_t *D,
    ptrdiff_t D_stride, ksl_coscrewf_t *co, ptrdiff_t co_stride) {
  KSL_EACH_OF(n) {
    ksl_hctyinvf_fused(D + i * D_stride, co + i * co_stride);
  }
}

static KSL_INLINED void ksl_hctyinvf_fused_planes(ptrdiff_t n, const float *D, ptrdiff_t D_plane,
    ptrdiff_t D_stride, float *co, ptrdiff_t co_plane, ptrdiff_t co_stride) {
  ksl_SE3f_t D_i;
  if (n > 0) D_i = ksl_SE3f_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3f_of_planes(D + i * D_stride, D_plane);
    ksl_coscrewf_t co_i;
    ksl_hctyinvf_fused(&D_i, &co_i);
    ksl_coscrewf_to_planes(&co_i, co + i * co_stride, co_plane);
  }
}

/* ksl_hctzinvf_fused of n elements. */
static KSL_INLINED void ksl_hctzinvf_fused_many(ptrdiff_t n, const ksl_SE3f_t *D,
    ptrdiff_t D_stride, ksl_coscrewf_t *co, ptrdiff_t co_stride) {
  KSL_EACH_OF(n) {
    ksl_hctzinvf_fused(D + i * D_stride, co + i * co_stride);
  }
}

static KSL_INLINED void ksl_hctzinvf_fused_planes(ptrdiff_t n, const float *D, ptrdiff_t D_plane,
    ptrdiff_t D_stride, float *co, ptrdiff_t co_plane, ptrdiff_t co_stride) {
  ksl_SE3f_t D_i;
  if (n > 0) D_i = ksl_SE3f_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3f_of_planes(D + i * D_stride, D_plane);
    ksl_coscrewf_t co_i;
    ksl_hctzinvf_fused(&D_i, &co_i);
    ksl_coscrewf_to_planes(&co_i, co + i * co_stride, co_plane);
  }
}

/* ksl_CoAdf_fused of n elements. */
static KSL_INLINED void ksl_CoAdf_fused_many(ptrdiff_t n, const ksl_SE3f_t *D, ptrdiff_t D_stride,
    ksl_mat6x6f_t *M, ptrdiff_t M_stride) {
  KSL_EACH_OF(n) {
    ksl_CoAdf_fused(D + i * D_stride, M + i * M_stride);
  }
}

static KSL_INLINED void ksl_CoAdf_fused_planes(ptrdiff_t n, const float *D, ptrdiff_t D_plane,
    ptrdiff_t D_stride, float *M, ptrdiff_t M_plane, ptrdiff_t M_stride) {
  ksl_SE3f_t D_i;
  if (n > 0) D_i = ksl_SE3f_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3f_of_planes(D + i * D_stride, D_plane);
    ksl_mat6x6f_t M_i;
    ksl_CoAdf_fused(&D_i, &M_i);
    ksl_mat6x6f_to_planes(&M_i, M + i * M_stride, M_plane);
  }
}

/* ksl_reciprocal_productf_fused of n elements. */
static KSL_INLINED void ksl_reciprocal_productf_fused_many(ptrdiff_t n, const ksl_coscrewf_t *c,
    ptrdiff_t c_stride, const float *x, ptrdiff_t x_stride, float *power,
    ptrdiff_t power_stride) {
  KSL_EACH_OF(n) {
    power[i * power_stride] = ksl_reciprocal_productf_fused(c + i * c_stride, x + 6 * i * x_stride);
  }
}

static KSL_INLINED void ksl_reciprocal_productf_fused_planes(ptrdiff_t n, const float *c,
    ptrdiff_t c_plane, ptrdiff_t c_stride, const float *x, ptrdiff_t x_plane,
    ptrdiff_t x_stride, float *power, ptrdiff_t power_stride) {
  ksl_coscrewf_t c_i;
  if (n > 0) c_i = ksl_coscrewf_of_planes(c, c_plane);
  KSL_EACH_OF(n) {
    if (c_stride) c_i = ksl_coscrewf_of_planes(c + i * c_stride, c_plane);
    const float x_i[6] = {x[0 + i * x_stride], x[x_plane + i * x_stride],
        x[2 * x_plane + i * x_stride], x[3 * x_plane + i * x_stride], x[4 * x_plane + i * x_stride],
        x[5 * x_plane + i * x_stride]};
    power[i * power_stride] = ksl_reciprocal_productf_fused(&c_i, x_i);
  }
}

/* ksl_cross_scf_fused of n elements. */
static KSL_INLINED void ksl_cross_scf_fused_many(ptrdiff_t n, const ksl_screwf_t *s,
    ptrdiff_t s_stride, const ksl_coscrewf_t *c, ptrdiff_t c_stride,
    ksl_coscrewf_t *co, ptrdiff_t co_stride) {
  KSL_EACH_OF(n) {
    ksl_cross_scf_fused(s + i * s_stride, c + i * c_stride, co + i * co_stride);
  }
}

static KSL_INLINED void ksl_cross_scf_fused_planes(ptrdiff_t n, const float *s, ptrdiff_t s_plane,
    ptrdiff_t s_stride, const float *c, ptrdiff_t c_plane, ptrdiff_t c_stride,
    float *co, ptrdiff_t co_plane, ptrdiff_t co_stride) {
  ksl_screwf_t s_i;
  if (n > 0) s_i = ksl_screwf_of_planes(s, s_plane);
  KSL_EACH_OF(n) {
    if (s_stride) s_i = ksl_screwf_of_planes(s + i * s_stride, s_plane);
    const ksl_coscrewf_t c_i = ksl_coscrewf_of_planes(c + i * c_stride, c_plane);
    ksl_coscrewf_t co_i;
    ksl_cross_scf_fused(&s_i, &c_i, &co_i);
    ksl_coscrewf_to_planes(&co_i, co + i * co_stride, co_plane);
  }
}

/* ksl_cross_scaf_fused of n elements. */
static KSL_INLINED void ksl_cross_scaf_fused_many(ptrdiff_t n, const ksl_screwf_t *s,
    ptrdiff_t s_stride, const ksl_coscrewf_t *c, ptrdiff_t c_stride,
    ksl_coscrewf_t *co, ptrdiff_t co_stride) {
  KSL_EACH_OF(n) {
    ksl_cross_scaf_fused(s + i * s_stride, c + i * c_stride, co + i * co_stride);
  }
}

static KSL_INLINED void ksl_cross_scaf_fused_planes(ptrdiff_t n, const float *s, ptrdiff_t s_plane,
    ptrdiff_t s_stride, const float *c, ptrdiff_t c_plane, ptrdiff_t c_stride,
    float *co, ptrdiff_t co_plane, ptrdiff_t co_stride) {
  ksl_screwf_t s_i;
  if (n > 0) s_i = ksl_screwf_of_planes(s, s_plane);
  KSL_EACH_OF(n) {
    if (s_stride) s_i = ksl_screwf_of_planes(s + i * s_stride, s_plane);
    const ksl_coscrewf_t c_i = ksl_coscrewf_of_planes(c + i * c_stride, c_plane);
    ksl_coscrewf_t co_i;
    ksl_cross_scaf_fused(&s_i, &c_i, &co_i);
    ksl_coscrewf_to_planes(&co_i, co + i * co_stride, co_plane);
  }
}

/* ksl_constraint_ctxf_fused of n elements. */
static KSL_INLINED void ksl_constraint_ctxf_fused_many(ptrdiff_t n, const ksl_SE3f_t *D,
    ptrdiff_t D_stride, const ksl_coscrewf_t *c, ptrdiff_t c_stride,
    ksl_coscrewf_t *co, ptrdiff_t co_stride) {
  KSL_EACH_OF(n) {
    ksl_constraint_ctxf_fused(D + i * D_stride, c + i * c_stride, co + i * co_stride);
  }
}

static KSL_INLINED void ksl_constraint_ctxf_fused_planes(ptrdiff_t n, const float *D,
    ptrdiff_t D_plane, ptrdiff_t D_stride, const float *c, ptrdiff_t c_plane,
    ptrdiff_t c_stride, float *co, ptrdiff_t co_plane, ptrdiff_t co_stride) {
  ksl_SE3f_t D_i;
  if (n > 0) D_i = ksl_SE3f_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3f_of_planes(D + i * D_stride, D_plane);
    const ksl_coscrewf_t c_i = ksl_coscrewf_of_planes(c + i * c_stride, c_plane);
    ksl_coscrewf_t co_i;
    ksl_constraint_ctxf_fused(&D_i, &c_i, &co_i);
    ksl_coscrewf_to_planes(&co_i, co + i * co_stride, co_plane);
  }
}

/* ksl_constraint_ctyf_fused of n elements. */
static KSL_INLINED void ksl_constraint_ctyf_fused_many(ptrdiff_t n, const ksl_SE3f_t *D,
    ptrdiff_t D_stride, const ksl_coscrewf_t *c, ptrdiff_t c_stride,
    ksl_coscrewf_t *co, ptrdiff_t co_stride) {
  KSL_EACH_OF(n) {
    ksl_constraint_ctyf_fused(D + i * D_stride, c + i * c_stride, co + i * co_stride);
  }
}

static KSL_INLINED void ksl_constraint_ctyf_fused_planes(ptrdiff_t n, const float *D,
    ptrdiff_t D_plane, ptrdiff_t D_stride, const float *c, ptrdiff_t c_plane,
    ptrdiff_t c_stride, float *co, ptrdiff_t co_plane, ptrdiff_t co_stride) {
  ksl_SE3f_t D_i;
  if (n > 0) D_i = ksl_SE3f_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3f_of_planes(D + i * D_stride, D_plane);
    const ksl_coscrewf_t c_i = ksl_coscrewf_of_planes(c + i * c_stride, c_plane);
    ksl_coscrewf_t co_i;
    ksl_constraint_ctyf_fused(&D_i, &c_i, &co_i);
    ksl_coscrewf_to_planes(&co_i, co + i * co_stride, co_plane);
  }
}

/* ksl_constraint_ctzf_fused of n elements. */
static KSL_INLINED void ksl_constraint_ctzf_fused_many(ptrdiff_t n, const ksl_SE3f_t *D,
    ptrdiff_t D_stride, const ksl_coscrewf_t *c, ptrdiff_t c_stride,
    ksl_coscrewf_t *co, ptrdiff_t co_stride) {
  KSL_EACH_OF(n) {
    ksl_constraint_ctzf_fused(D + i * D_stride, c + i * c_stride, co + i * co_stride);
  }
}

static KSL_INLINED void ksl_constraint_ctzf_fused_planes(ptrdiff_t n, const float *D,
    ptrdiff_t D_plane, ptrdiff_t D_stride, const float *c, ptrdiff_t c_plane,
    ptrdiff_t c_stride, float *co, ptrdiff_t co_plane, ptrdiff_t co_stride) {
  ksl_SE3f_t D_i;
  if (n > 0) D_i = ksl_SE3f_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3f_of_planes(D + i * D_stride, D_plane);
    const ksl_coscrewf_t c_i = ksl_coscrewf_of_planes(c + i * c_stride, c_plane);
    ksl_coscrewf_t co_i;
    ksl_constraint_ctzf_fused(&D_i, &c_i, &co_i);
    ksl_coscrewf_to_planes(&co_i, co + i * co_stride, co_plane);
  }
}

/* ksl_constraint_crxf_fused of n elements. */
static KSL_INLINED void ksl_constraint_crxf_fused_many(ptrdiff_t n, const ksl_SE3f_t *D,
    ptrdiff_t D_stride, const ksl_coscrewf_t *c, ptrdiff_t c_stride,
    ksl_coscrewf_t *co, ptrdiff_t co_stride) {
  KSL_EACH_OF(n) {
    ksl_constraint_crxf_fused(D + i * D_stride, c + i * c_stride, co + i * co_stride);
  }
}

static KSL_INLINED void ksl_constraint_crxf_fused_planes(ptrdiff_t n, const float *D,
    ptrdiff_t D_plane, ptrdiff_t D_stride, const float *c, ptrdiff_t c_plane,
    ptrdiff_t c_stride, float *co, ptrdiff_t co_plane, ptrdiff_t co_stride) {
  ksl_SE3f_t D_i;
  if (n > 0) D_i = ksl_SE3f_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3f_of_planes(D + i * D_stride, D_plane);
    const ksl_coscrewf_t c_i = ksl_coscrewf_of_planes(c + i * c_stride, c_plane);
    ksl_coscrewf_t co_i;
    ksl_constraint_crxf_fused(&D_i, &c_i, &co_i);
    ksl_coscrewf_to_planes(&co_i, co + i * co_stride, co_plane);
  }
}

/* ksl_constraint_cryf_fused of n elements. */
static KSL_INLINED void ksl_constraint_cryf_fused_many(ptrdiff_t n, const ksl_SE3f_t *D,
    ptrdiff_t D_stride, const ksl_coscrewf_t *c, ptrdiff_t c_stride,
    ksl_coscrewf_t *co, ptrdiff_t co_stride) {
  KSL_EACH_OF(n) {
    ksl_constraint_cryf_fused(D + i * D_stride, c + i * c_stride, co + i * co_stride);
  }
}

static KSL_INLINED void ksl_constraint_cryf_fused_planes(ptrdiff_t n, const float *D,
    ptrdiff_t D_plane, ptrdiff_t D_stride, const float *c, ptrdiff_t c_plane,
    ptrdiff_t c_stride, float *co, ptrdiff_t co_plane, ptrdiff_t co_stride) {
  ksl_SE3f_t D_i;
  if (n > 0) D_i = ksl_SE3f_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3f_of_planes(D + i * D_stride, D_plane);
    const ksl_coscrewf_t c_i = ksl_coscrewf_of_planes(c + i * c_stride, c_plane);
    ksl_coscrewf_t co_i;
    ksl_constraint_cryf_fused(&D_i, &c_i, &co_i);
    ksl_coscrewf_to_planes(&co_i, co + i * co_stride, co_plane);
  }
}

/* ksl_constraint_crzf_fused of n elements. */
static KSL_INLINED void ksl_constraint_crzf_fused_many(ptrdiff_t n, const ksl_SE3f_t *D,
    ptrdiff_t D_stride, const ksl_coscrewf_t *c, ptrdiff_t c_stride,
    ksl_coscrewf_t *co, ptrdiff_t co_stride) {
  KSL_EACH_OF(n) {
    ksl_constraint_crzf_fused(D + i * D_stride, c + i * c_stride, co + i * co_stride);
  }
}

static KSL_INLINED void ksl_constraint_crzf_fused_planes(ptrdiff_t n, const float *D,
    ptrdiff_t D_plane, ptrdiff_t D_stride, const float *c, ptrdiff_t c_plane,
    ptrdiff_t c_stride, float *co, ptrdiff_t co_plane, ptrdiff_t co_stride) {
  ksl_SE3f_t D_i;
  if (n > 0) D_i = ksl_SE3f_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3f_of_planes(D + i * D_stride, D_plane);
    const ksl_coscrewf_t c_i = ksl_coscrewf_of_planes(c + i * c_stride, c_plane);
    ksl_coscrewf_t co_i;
    ksl_constraint_crzf_fused(&D_i, &c_i, &co_i);
    ksl_coscrewf_to_planes(&co_i, co + i * co_stride, co_plane);
  }
}

/* ksl_working_ctxf_fused of n elements. */
static KSL_INLINED void ksl_working_ctxf_fused_many(ptrdiff_t n, const ksl_SE3f_t *D,
    ptrdiff_t D_stride, const ksl_coscrewf_t *c, ptrdiff_t c_stride,
    ksl_coscrewf_t *co, ptrdiff_t co_stride) {
  KSL_EACH_OF(n) {
    ksl_working_ctxf_fused(D + i * D_stride, c + i * c_stride, co + i * co_stride);
  }
}

static KSL_INLINED void ksl_working_ctxf_fused_planes(ptrdiff_t n, const float *D,
    ptrdiff_t D_plane, ptrdiff_t D_stride, const float *c, ptrdiff_t c_plane,
    ptrdiff_t c_stride, float *co, ptrdiff_t co_plane, ptrdiff_t co_stride) {
  ksl_SE3f_t D_i;
  if (n > 0) D_i = ksl_SE3f_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3f_of_planes(D + i * D_stride, D_plane);
    const ksl_coscrewf_t c_i = ksl_coscrewf_of_planes(c + i * c_stride, c_plane);
    ksl_coscrewf_t co_i;
    ksl_working_ctxf_fused(&D_i, &c_i, &co_i);
    ksl_coscrewf_to_planes(&co_i, co + i * co_stride, co_plane);
  }
}

/* ksl_working_ctyf_fused of n elements. */
static KSL_INLINED void ksl_working_ctyf_fused_many(ptrdiff_t n, const ksl_SE3f_t *D,
    ptrdiff_t D_stride, const ksl_coscrewf_t *c, ptrdiff_t c_stride,
    ksl_coscrewf_t *co, ptrdiff_t co_stride) {
  KSL_EACH_OF(n) {
    ksl_working_ctyf_fused(D + i * D_stride, c + i * c_stride, co + i * co_stride);
  }
}

static KSL_INLINED void ksl_working_ctyf_fused_planes(ptrdiff_t n, const float *D,
    ptrdiff_t D_plane, ptrdiff_t D_stride, const float *c, ptrdiff_t c_plane,
    ptrdiff_t c_stride, float *co, ptrdiff_t co_plane, ptrdiff_t co_stride) {
  ksl_SE3f_t D_i;
  if (n > 0) D_i = ksl_SE3f_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3f_of_planes(D + i * D_stride, D_plane);
    const ksl_coscrewf_t c_i = ksl_coscrewf_of_planes(c + i * c_stride, c_plane);
    ksl_coscrewf_t co_i;
    ksl_working_ctyf_fused(&D_i, &c_i, &co_i);
    ksl_coscrewf_to_planes(&co_i, co + i * co_stride, co_plane);
  }
}

/* ksl_working_ctzf_fused of n elements. */
static KSL_INLINED void ksl_working_ctzf_fused_many(ptrdiff_t n, const ksl_SE3f_t *D,
    ptrdiff_t D_stride, const ksl_coscrewf_t *c, ptrdiff_t c_stride,
    ksl_coscrewf_t *co, ptrdiff_t co_stride) {
  KSL_EACH_OF(n) {
    ksl_working_ctzf_fused(D + i * D_stride, c + i * c_stride, co + i * co_stride);
  }
}

static KSL_INLINED void ksl_working_ctzf_fused_planes(ptrdiff_t n, const float *D,
    ptrdiff_t D_plane, ptrdiff_t D_stride, const float *c, ptrdiff_t c_plane,
    ptrdiff_t c_stride, float *co, ptrdiff_t co_plane, ptrdiff_t co_stride) {
  ksl_SE3f_t D_i;
  if (n > 0) D_i = ksl_SE3f_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3f_of_planes(D + i * D_stride, D_plane);
    const ksl_coscrewf_t c_i = ksl_coscrewf_of_planes(c + i * c_stride, c_plane);
    ksl_coscrewf_t co_i;
    ksl_working_ctzf_fused(&D_i, &c_i, &co_i);
    ksl_coscrewf_to_planes(&co_i, co + i * co_stride, co_plane);
  }
}

/* ksl_working_crxf_fused of n elements. */
static KSL_INLINED void ksl_working_crxf_fused_many(ptrdiff_t n, const ksl_SE3f_t *D,
    ptrdiff_t D_stride, const ksl_coscrewf_t *c, ptrdiff_t c_stride,
    ksl_coscrewf_t *co, ptrdiff_t co_stride) {
  KSL_EACH_OF(n) {
    ksl_working_crxf_fused(D + i * D_stride, c + i * c_stride, co + i * co_stride);
  }
}

static KSL_INLINED void ksl_working_crxf_fused_planes(ptrdiff_t n, const float *D,
    ptrdiff_t D_plane, ptrdiff_t D_stride, const float *c, ptrdiff_t c_plane,
    ptrdiff_t c_stride, float *co, ptrdiff_t co_plane, ptrdiff_t co_stride) {
  ksl_SE3f_t D_i;
  if (n > 0) D_i = ksl_SE3f_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3f_of_planes(D + i * D_stride, D_plane);
    const ksl_coscrewf_t c_i = ksl_coscrewf_of_planes(c + i * c_stride, c_plane);
    ksl_coscrewf_t co_i;
    ksl_working_crxf_fused(&D_i, &c_i, &co_i);
    ksl_coscrewf_to_planes(&co_i, co + i * co_stride, co_plane);
  }
}

/* ksl_working_cryf_fused of n elements. */
static KSL_INLINED void ksl_working_cryf_fused_many(ptrdiff_t n, const ksl_SE3f_t *D,
    ptrdiff_t D_stride, const ksl_coscrewf_t *c, ptrdiff_t c_stride,
    ksl_coscrewf_t *co, ptrdiff_t co_stride) {
  KSL_EACH_OF(n) {
    ksl_working_cryf_fused(D + i * D_stride, c + i * c_stride, co + i * co_stride);
  }
}

static KSL_INLINED void ksl_working_cryf_fused_planes(ptrdiff_t n, const float *D,
    ptrdiff_t D_plane, ptrdiff_t D_stride, const float *c, ptrdiff_t c_plane,
    ptrdiff_t c_stride, float *co, ptrdiff_t co_plane, ptrdiff_t co_stride) {
  ksl_SE3f_t D_i;
  if (n > 0) D_i = ksl_SE3f_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3f_of_planes(D + i * D_stride, D_plane);
    const ksl_coscrewf_t c_i = ksl_coscrewf_of_planes(c + i * c_stride, c_plane);
    ksl_coscrewf_t co_i;
    ksl_working_cryf_fused(&D_i, &c_i, &co_i);
    ksl_coscrewf_to_planes(&co_i, co + i * co_stride, co_plane);
  }
}

/* ksl_working_crzf_fused of n elements. */
static KSL_INLINED void ksl_working_crzf_fused_many(ptrdiff_t n, const ksl_SE3f_t *D,
    ptrdiff_t D_stride, const ksl_coscrewf_t *c, ptrdiff_t c_stride,
    ksl_coscrewf_t *co, ptrdiff_t co_stride) {
  KSL_EACH_OF(n) {
    ksl_working_crzf_fused(D + i * D_stride, c + i * c_stride, co + i * co_stride);
  }
}

static KSL_INLINED void ksl_working_crzf_fused_planes(ptrdiff_t n, const float *D,
    ptrdiff_t D_plane, ptrdiff_t D_stride, const float *c, ptrdiff_t c_plane,
    ptrdiff_t c_stride, float *co, ptrdiff_t co_plane, ptrdiff_t co_stride) {
  ksl_SE3f_t D_i;
  if (n > 0) D_i = ksl_SE3f_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3f_of_planes(D + i * D_stride, D_plane);
    const ksl_coscrewf_t c_i = ksl_coscrewf_of_planes(c + i * c_stride, c_plane);
    ksl_coscrewf_t co_i;
    ksl_working_crzf_fused(&D_i, &c_i, &co_i);
    ksl_coscrewf_to_planes(&co_i, co + i * co_stride, co_plane);
  }
}

#endif
