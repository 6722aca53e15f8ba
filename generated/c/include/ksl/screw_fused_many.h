/* Made by `coscrew generate`; changes are overwritten. */
/* SPDX-License-Identifier: MIT */
/* coscrew 0.2.0.  Copyright (c) 2026 The coscrew authors. */
/* Screws: twists, spatial velocities and accelerations, s = (v; ω).  Many at a time.
   What arguments are, and what loops over them cost, ksl_planes.h says. */
#ifndef KSL_SCREW_FUSED_MANY_H
#define KSL_SCREW_FUSED_MANY_H

#include "screw_fused.h"
#include "ksl_planes.h"

/* ksl_screw_scale_fused of n elements. */
static KSL_INLINED void ksl_screw_scale_fused_many(ptrdiff_t n, ksl_screw_t *self,
    ptrdiff_t self_stride, const double *a, ptrdiff_t a_stride) {
  KSL_EACH_OF(n) {
    ksl_screw_scale_fused(self + i * self_stride, a[i * a_stride]);
  }
}

static KSL_INLINED void ksl_screw_scale_fused_planes(ptrdiff_t n, double *self,
    ptrdiff_t self_plane, ptrdiff_t self_stride, const double *a,
    ptrdiff_t a_stride) {
  KSL_EACH_OF(n) {
    ksl_screw_t self_i = ksl_screw_of_planes(self + i * self_stride, self_plane);
    ksl_screw_scale_fused(&self_i, a[i * a_stride]);
    ksl_screw_to_planes(&self_i, self + i * self_stride, self_plane);
  }
}

/* ksl_axpy_ss_fused of n elements. */
static KSL_INLINED void ksl_axpy_ss_fused_many(ptrdiff_t n, const double *a, ptrdiff_t a_stride,
    const ksl_screw_t *x, ptrdiff_t x_stride, ksl_screw_t *y, ptrdiff_t y_stride) {
  KSL_EACH_OF(n) {
    ksl_axpy_ss_fused(a[i * a_stride], x + i * x_stride, y + i * y_stride);
  }
}

static KSL_INLINED void ksl_axpy_ss_fused_planes(ptrdiff_t n, const double *a, ptrdiff_t a_stride,
    const double *x, ptrdiff_t x_plane, ptrdiff_t x_stride, double *y,
    ptrdiff_t y_plane, ptrdiff_t y_stride) {
  KSL_EACH_OF(n) {
    const ksl_screw_t x_i = ksl_screw_of_planes(x + i * x_stride, x_plane);
    ksl_screw_t y_i = ksl_screw_of_planes(y + i * y_stride, y_plane);
    ksl_axpy_ss_fused(a[i * a_stride], &x_i, &y_i);
    ksl_screw_to_planes(&y_i, y + i * y_stride, y_plane);
  }
}

/* ksl_xpy_ss_fused of n elements. */
static KSL_INLINED void ksl_xpy_ss_fused_many(ptrdiff_t n, const ksl_screw_t *x, ptrdiff_t x_stride,
    ksl_screw_t *y, ptrdiff_t y_stride) {
  KSL_EACH_OF(n) {
    ksl_xpy_ss_fused(x + i * x_stride, y + i * y_stride);
  }
}

static KSL_INLINED void ksl_xpy_ss_fused_planes(ptrdiff_t n, const double *x, ptrdiff_t x_plane,
    ptrdiff_t x_stride, double *y, ptrdiff_t y_plane, ptrdiff_t y_stride) {
  ksl_screw_t x_i;
  if (n > 0) x_i = ksl_screw_of_planes(x, x_plane);
  KSL_EACH_OF(n) {
    if (x_stride) x_i = ksl_screw_of_planes(x + i * x_stride, x_plane);
    ksl_screw_t y_i = ksl_screw_of_planes(y + i * y_stride, y_plane);
    ksl_xpy_ss_fused(&x_i, &y_i);
    ksl_screw_to_planes(&y_i, y + i * y_stride, y_plane);
  }
}

/* ksl_nxpy_ss_fused of n elements. */
static KSL_INLINED void ksl_nxpy_ss_fused_many(ptrdiff_t n, const ksl_screw_t *x,
    ptrdiff_t x_stride, ksl_screw_t *y, ptrdiff_t y_stride) {
  KSL_EACH_OF(n) {
    ksl_nxpy_ss_fused(x + i * x_stride, y + i * y_stride);
  }
}

static KSL_INLINED void ksl_nxpy_ss_fused_planes(ptrdiff_t n, const double *x, ptrdiff_t x_plane,
    ptrdiff_t x_stride, double *y, ptrdiff_t y_plane, ptrdiff_t y_stride) {
  ksl_screw_t x_i;
  if (n > 0) x_i = ksl_screw_of_planes(x, x_plane);
  KSL_EACH_OF(n) {
    if (x_stride) x_i = ksl_screw_of_planes(x + i * x_stride, x_plane);
    ksl_screw_t y_i = ksl_screw_of_planes(y + i * y_stride, y_plane);
    ksl_nxpy_ss_fused(&x_i, &y_i);
    ksl_screw_to_planes(&y_i, y + i * y_stride, y_plane);
  }
}

/* ksl_product_as_fused of n elements. */
static KSL_INLINED void ksl_product_as_fused_many(ptrdiff_t n, const double *a, ptrdiff_t a_stride,
    const ksl_screw_t *si, ptrdiff_t si_stride, ksl_screw_t *so,
    ptrdiff_t so_stride) {
  KSL_EACH_OF(n) {
    ksl_product_as_fused(a[i * a_stride], si + i * si_stride, so + i * so_stride);
  }
}

static KSL_INLINED void ksl_product_as_fused_planes(ptrdiff_t n, const double *a,
    ptrdiff_t a_stride, const double *si, ptrdiff_t si_plane,
    ptrdiff_t si_stride, double *so, ptrdiff_t so_plane, ptrdiff_t so_stride) {
  KSL_EACH_OF(n) {
    const ksl_screw_t si_i = ksl_screw_of_planes(si + i * si_stride, si_plane);
    ksl_screw_t so_i;
    ksl_product_as_fused(a[i * a_stride], &si_i, &so_i);
    ksl_screw_to_planes(&so_i, so + i * so_stride, so_plane);
  }
}

/* ksl_add_ss_fused of n elements. */
static KSL_INLINED void ksl_add_ss_fused_many(ptrdiff_t n, const ksl_screw_t *s1,
    ptrdiff_t s1_stride, const ksl_screw_t *s2, ptrdiff_t s2_stride,
    ksl_screw_t *so, ptrdiff_t so_stride) {
  KSL_EACH_OF(n) {
    ksl_add_ss_fused(s1 + i * s1_stride, s2 + i * s2_stride, so + i * so_stride);
  }
}

static KSL_INLINED void ksl_add_ss_fused_planes(ptrdiff_t n, const double *s1, ptrdiff_t s1_plane,
    ptrdiff_t s1_stride, const double *s2, ptrdiff_t s2_plane,
    ptrdiff_t s2_stride, double *so, ptrdiff_t so_plane, ptrdiff_t so_stride) {
  ksl_screw_t s1_i;
  if (n > 0) s1_i = ksl_screw_of_planes(s1, s1_plane);
  KSL_EACH_OF(n) {
    if (s1_stride) s1_i = ksl_screw_of_planes(s1 + i * s1_stride, s1_plane);
    const ksl_screw_t s2_i = ksl_screw_of_planes(s2 + i * s2_stride, s2_plane);
    ksl_screw_t so_i;
    ksl_add_ss_fused(&s1_i, &s2_i, &so_i);
    ksl_screw_to_planes(&so_i, so + i * so_stride, so_plane);
  }
}

/* ksl_subtract_ss_fused of n elements. */
static KSL_INLINED void ksl_subtract_ss_fused_many(ptrdiff_t n, const ksl_screw_t *s1,
    ptrdiff_t s1_stride, const ksl_screw_t *s2, ptrdiff_t s2_stride,
    ksl_screw_t *so, ptrdiff_t so_stride) {
  KSL_EACH_OF(n) {
    ksl_subtract_ss_fused(s1 + i * s1_stride, s2 + i * s2_stride, so + i * so_stride);
  }
}

static KSL_INLINED void ksl_subtract_ss_fused_planes(ptrdiff_t n, const double *s1,
    ptrdiff_t s1_plane, ptrdiff_t s1_stride, const double *s2,
    ptrdiff_t s2_plane, ptrdiff_t s2_stride, double *so, ptrdiff_t so_plane,
    ptrdiff_t so_stride) {
  ksl_screw_t s1_i;
  if (n > 0) s1_i = ksl_screw_of_planes(s1, s1_plane);
  KSL_EACH_OF(n) {
    if (s1_stride) s1_i = ksl_screw_of_planes(s1 + i * s1_stride, s1_plane);
    const ksl_screw_t s2_i = ksl_screw_of_planes(s2 + i * s2_stride, s2_plane);
    ksl_screw_t so_i;
    ksl_subtract_ss_fused(&s1_i, &s2_i, &so_i);
    ksl_screw_to_planes(&so_i, so + i * so_stride, so_plane);
  }
}

/* ksl_add_sst_fused of n elements. */
static KSL_INLINED void ksl_add_sst_fused_many(ptrdiff_t n, const ksl_screw_t *s1,
    ptrdiff_t s1_stride, const ksl_screw_t *s2, ptrdiff_t s2_stride,
    ksl_screw_t *so, ptrdiff_t so_stride) {
  KSL_EACH_OF(n) {
    ksl_add_sst_fused(s1 + i * s1_stride, s2 + i * s2_stride, so + i * so_stride);
  }
}

static KSL_INLINED void ksl_add_sst_fused_planes(ptrdiff_t n, const double *s1, ptrdiff_t s1_plane,
    ptrdiff_t s1_stride, const double *s2, ptrdiff_t s2_plane,
    ptrdiff_t s2_stride, double *so, ptrdiff_t so_plane, ptrdiff_t so_stride) {
  ksl_screw_t s1_i;
  if (n > 0) s1_i = ksl_screw_of_planes(s1, s1_plane);
  KSL_EACH_OF(n) {
    if (s1_stride) s1_i = ksl_screw_of_planes(s1 + i * s1_stride, s1_plane);
    const ksl_screw_t s2_i = ksl_screw_of_planes(s2 + i * s2_stride, s2_plane);
    ksl_screw_t so_i;
    ksl_add_sst_fused(&s1_i, &s2_i, &so_i);
    ksl_screw_to_planes(&so_i, so + i * so_stride, so_plane);
  }
}

/* ksl_product_Adts_fused of n elements. */
static KSL_INLINED void ksl_product_Adts_fused_many(ptrdiff_t n, const ksl_vec3_t *t,
    ptrdiff_t t_stride, const ksl_screw_t *si, ptrdiff_t si_stride,
    ksl_screw_t *so, ptrdiff_t so_stride) {
  KSL_EACH_OF(n) {
    ksl_product_Adts_fused(t + i * t_stride, si + i * si_stride, so + i * so_stride);
  }
}

static KSL_INLINED void ksl_product_Adts_fused_planes(ptrdiff_t n, const double *t,
    ptrdiff_t t_plane, ptrdiff_t t_stride, const double *si, ptrdiff_t si_plane,
    ptrdiff_t si_stride, double *so, ptrdiff_t so_plane, ptrdiff_t so_stride) {
  ksl_vec3_t t_i;
  if (n > 0) t_i = ksl_vec3_of_planes(t, t_plane);
  KSL_EACH_OF(n) {
    if (t_stride) t_i = ksl_vec3_of_planes(t + i * t_stride, t_plane);
    const ksl_screw_t si_i = ksl_screw_of_planes(si + i * si_stride, si_plane);
    ksl_screw_t so_i;
    ksl_product_Adts_fused(&t_i, &si_i, &so_i);
    ksl_screw_to_planes(&so_i, so + i * so_stride, so_plane);
  }
}

/* ksl_product_Adtinvs_fused of n elements. */
static KSL_INLINED void ksl_product_Adtinvs_fused_many(ptrdiff_t n, const ksl_vec3_t *t,
    ptrdiff_t t_stride, const ksl_screw_t *si, ptrdiff_t si_stride,
    ksl_screw_t *so, ptrdiff_t so_stride) {
  KSL_EACH_OF(n) {
    ksl_product_Adtinvs_fused(t + i * t_stride, si + i * si_stride, so + i * so_stride);
  }
}

static KSL_INLINED void ksl_product_Adtinvs_fused_planes(ptrdiff_t n, const double *t,
    ptrdiff_t t_plane, ptrdiff_t t_stride, const double *si, ptrdiff_t si_plane,
    ptrdiff_t si_stride, double *so, ptrdiff_t so_plane, ptrdiff_t so_stride) {
  ksl_vec3_t t_i;
  if (n > 0) t_i = ksl_vec3_of_planes(t, t_plane);
  KSL_EACH_OF(n) {
    if (t_stride) t_i = ksl_vec3_of_planes(t + i * t_stride, t_plane);
    const ksl_screw_t si_i = ksl_screw_of_planes(si + i * si_stride, si_plane);
    ksl_screw_t so_i;
    ksl_product_Adtinvs_fused(&t_i, &si_i, &so_i);
    ksl_screw_to_planes(&so_i, so + i * so_stride, so_plane);
  }
}

/* ksl_product_Adtsinv_fused of n elements. */
static KSL_INLINED void ksl_product_Adtsinv_fused_many(ptrdiff_t n, const ksl_vec3_t *t,
    ptrdiff_t t_stride, const ksl_screw_t *si, ptrdiff_t si_stride,
    ksl_screw_t *so, ptrdiff_t so_stride) {
  KSL_EACH_OF(n) {
    ksl_product_Adtsinv_fused(t + i * t_stride, si + i * si_stride, so + i * so_stride);
  }
}

static KSL_INLINED void ksl_product_Adtsinv_fused_planes(ptrdiff_t n, const double *t,
    ptrdiff_t t_plane, ptrdiff_t t_stride, const double *si, ptrdiff_t si_plane,
    ptrdiff_t si_stride, double *so, ptrdiff_t so_plane, ptrdiff_t so_stride) {
  ksl_vec3_t t_i;
  if (n > 0) t_i = ksl_vec3_of_planes(t, t_plane);
  KSL_EACH_OF(n) {
    if (t_stride) t_i = ksl_vec3_of_planes(t + i * t_stride, t_plane);
    const ksl_screw_t si_i = ksl_screw_of_planes(si + i * si_stride, si_plane);
    ksl_screw_t so_i;
    ksl_product_Adtsinv_fused(&t_i, &si_i, &so_i);
    ksl_screw_to_planes(&so_i, so + i * so_stride, so_plane);
  }
}

/* ksl_product_Adrs_fused of n elements. */
static KSL_INLINED void ksl_product_Adrs_fused_many(ptrdiff_t n, const ksl_mat3x3_t *R,
    ptrdiff_t R_stride, const ksl_screw_t *si, ptrdiff_t si_stride,
    ksl_screw_t *so, ptrdiff_t so_stride) {
  KSL_EACH_OF(n) {
    ksl_product_Adrs_fused(R + i * R_stride, si + i * si_stride, so + i * so_stride);
  }
}

static KSL_INLINED void ksl_product_Adrs_fused_planes(ptrdiff_t n, const double *R,
    ptrdiff_t R_plane, ptrdiff_t R_stride, const double *si, ptrdiff_t si_plane,
    ptrdiff_t si_stride, double *so, ptrdiff_t so_plane, ptrdiff_t so_stride) {
  ksl_mat3x3_t R_i;
  if (n > 0) R_i = ksl_mat3x3_of_planes(R, R_plane);
  KSL_EACH_OF(n) {
    if (R_stride) R_i = ksl_mat3x3_of_planes(R + i * R_stride, R_plane);
    const ksl_screw_t si_i = ksl_screw_of_planes(si + i * si_stride, si_plane);
    ksl_screw_t so_i;
    ksl_product_Adrs_fused(&R_i, &si_i, &so_i);
    ksl_screw_to_planes(&so_i, so + i * so_stride, so_plane);
  }
}

/* ksl_product_Adrinvs_fused of n elements. */
static KSL_INLINED void ksl_product_Adrinvs_fused_many(ptrdiff_t n, const ksl_mat3x3_t *R,
    ptrdiff_t R_stride, const ksl_screw_t *si, ptrdiff_t si_stride,
    ksl_screw_t *so, ptrdiff_t so_stride) {
  KSL_EACH_OF(n) {
    ksl_product_Adrinvs_fused(R + i * R_stride, si + i * si_stride, so + i * so_stride);
  }
}

static KSL_INLINED void ksl_product_Adrinvs_fused_planes(ptrdiff_t n, const double *R,
    ptrdiff_t R_plane, ptrdiff_t R_stride, const double *si, ptrdiff_t si_plane,
    ptrdiff_t si_stride, double *so, ptrdiff_t so_plane, ptrdiff_t so_stride) {
  ksl_mat3x3_t R_i;
  if (n > 0) R_i = ksl_mat3x3_of_planes(R, R_plane);
  KSL_EACH_OF(n) {
    if (R_stride) R_i = ksl_mat3x3_of_planes(R + i * R_stride, R_plane);
    const ksl_screw_t si_i = ksl_screw_of_planes(si + i * si_stride, si_plane);
    ksl_screw_t so_i;
    ksl_product_Adrinvs_fused(&R_i, &si_i, &so_i);
    ksl_screw_to_planes(&so_i, so + i * so_stride, so_plane);
  }
}

/* ksl_product_Adrsinv_fused of n elements. */
static KSL_INLINED void ksl_product_Adrsinv_fused_many(ptrdiff_t n, const ksl_mat3x3_t *R,
    ptrdiff_t R_stride, const ksl_screw_t *si, ptrdiff_t si_stride,
    ksl_screw_t *so, ptrdiff_t so_stride) {
  KSL_EACH_OF(n) {
    ksl_product_Adrsinv_fused(R + i * R_stride, si + i * si_stride, so + i * so_stride);
  }
}

static KSL_INLINED void ksl_product_Adrsinv_fused_planes(ptrdiff_t n, const double *R,
    ptrdiff_t R_plane, ptrdiff_t R_stride, const double *si, ptrdiff_t si_plane,
    ptrdiff_t si_stride, double *so, ptrdiff_t so_plane, ptrdiff_t so_stride) {
  ksl_mat3x3_t R_i;
  if (n > 0) R_i = ksl_mat3x3_of_planes(R, R_plane);
  KSL_EACH_OF(n) {
    if (R_stride) R_i = ksl_mat3x3_of_planes(R + i * R_stride, R_plane);
    const ksl_screw_t si_i = ksl_screw_of_planes(si + i * si_stride, si_plane);
    ksl_screw_t so_i;
    ksl_product_Adrsinv_fused(&R_i, &si_i, &so_i);
    ksl_screw_to_planes(&so_i, so + i * so_stride, so_plane);
  }
}

/* ksl_product_Ads_fused of n elements. */
static KSL_INLINED void ksl_product_Ads_fused_many(ptrdiff_t n, const ksl_SE3_t *D,
    ptrdiff_t D_stride, const ksl_screw_t *si, ptrdiff_t si_stride,
    ksl_screw_t *so, ptrdiff_t so_stride) {
  KSL_EACH_OF(n) {
    ksl_product_Ads_fused(D + i * D_stride, si + i * si_stride, so + i * so_stride);
  }
}

static KSL_INLINED void ksl_product_Ads_fused_planes(ptrdiff_t n, const double *D,
    ptrdiff_t D_plane, ptrdiff_t D_stride, const double *si, ptrdiff_t si_plane,
    ptrdiff_t si_stride, double *so, ptrdiff_t so_plane, ptrdiff_t so_stride) {
  ksl_SE3_t D_i;
  if (n > 0) D_i = ksl_SE3_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3_of_planes(D + i * D_stride, D_plane);
    const ksl_screw_t si_i = ksl_screw_of_planes(si + i * si_stride, si_plane);
    ksl_screw_t so_i;
    ksl_product_Ads_fused(&D_i, &si_i, &so_i);
    ksl_screw_to_planes(&so_i, so + i * so_stride, so_plane);
  }
}

/* ksl_product_Adinvs_fused of n elements. */
static KSL_INLINED void ksl_product_Adinvs_fused_many(ptrdiff_t n, const ksl_SE3_t *D,
    ptrdiff_t D_stride, const ksl_screw_t *si, ptrdiff_t si_stride,
    ksl_screw_t *so, ptrdiff_t so_stride) {
  KSL_EACH_OF(n) {
    ksl_product_Adinvs_fused(D + i * D_stride, si + i * si_stride, so + i * so_stride);
  }
}

static KSL_INLINED void ksl_product_Adinvs_fused_planes(ptrdiff_t n, const double *D,
    ptrdiff_t D_plane, ptrdiff_t D_stride, const double *si, ptrdiff_t si_plane,
    ptrdiff_t si_stride, double *so, ptrdiff_t so_plane, ptrdiff_t so_stride) {
  ksl_SE3_t D_i;
  if (n > 0) D_i = ksl_SE3_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3_of_planes(D + i * D_stride, D_plane);
    const ksl_screw_t si_i = ksl_screw_of_planes(si + i * si_stride, si_plane);
    ksl_screw_t so_i;
    ksl_product_Adinvs_fused(&D_i, &si_i, &so_i);
    ksl_screw_to_planes(&so_i, so + i * so_stride, so_plane);
  }
}

/* ksl_product_Adsinv_fused of n elements. */
static KSL_INLINED void ksl_product_Adsinv_fused_many(ptrdiff_t n, const ksl_SE3_t *D,
    ptrdiff_t D_stride, const ksl_screw_t *si, ptrdiff_t si_stride,
    ksl_screw_t *so, ptrdiff_t so_stride) {
  KSL_EACH_OF(n) {
    ksl_product_Adsinv_fused(D + i * D_stride, si + i * si_stride, so + i * so_stride);
  }
}

static KSL_INLINED void ksl_product_Adsinv_fused_planes(ptrdiff_t n, const double *D,
    ptrdiff_t D_plane, ptrdiff_t D_stride, const double *si, ptrdiff_t si_plane,
    ptrdiff_t si_stride, double *so, ptrdiff_t so_plane, ptrdiff_t so_stride) {
  ksl_SE3_t D_i;
  if (n > 0) D_i = ksl_SE3_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3_of_planes(D + i * D_stride, D_plane);
    const ksl_screw_t si_i = ksl_screw_of_planes(si + i * si_stride, si_plane);
    ksl_screw_t so_i;
    ksl_product_Adsinv_fused(&D_i, &si_i, &so_i);
    ksl_screw_to_planes(&so_i, so + i * so_stride, so_plane);
  }
}

/* ksl_hsrx_fused of n elements. */
static KSL_INLINED void ksl_hsrx_fused_many(ptrdiff_t n, const ksl_SE3_t *D, ptrdiff_t D_stride,
    ksl_screw_t *so, ptrdiff_t so_stride) {
  KSL_EACH_OF(n) {
    ksl_hsrx_fused(D + i * D_stride, so + i * so_stride);
  }
}

static KSL_INLINED void ksl_hsrx_fused_planes(ptrdiff_t n, const double *D, ptrdiff_t D_plane,
    ptrdiff_t D_stride, double *so, ptrdiff_t so_plane, ptrdiff_t so_stride) {
  ksl_SE3_t D_i;
  if (n > 0) D_i = ksl_SE3_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3_of_planes(D + i * D_stride, D_plane);
    ksl_screw_t so_i;
    ksl_hsrx_fused(&D_i, &so_i);
    ksl_screw_to_planes(&so_i, so + i * so_stride, so_plane);
  }
}

/* ksl_hsry_fused of n elements. */
static KSL_INLINED void ksl_hsry_fused_many(ptrdiff_t n, const ksl_SE3_t *D, ptrdiff_t D_stride,
    ksl_screw_t *so, ptrdiff_t so_stride) {
  KSL_EACH_OF(n) {
    ksl_hsry_fused(D + i * D_stride, so + i * so_stride);
  }
}

static KSL_INLINED void ksl_hsry_fused_planes(ptrdiff_t n, const double *D, ptrdiff_t D_plane,
    ptrdiff_t D_stride, double *so, ptrdiff_t so_plane, ptrdiff_t so_stride) {
  ksl_SE3_t D_i;
  if (n > 0) D_i = ksl_SE3_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3_of_planes(D + i * D_stride, D_plane);
    ksl_screw_t so_i;
    ksl_hsry_fused(&D_i, &so_i);
    ksl_screw_to_planes(&so_i, so + i * so_stride, so_plane);
  }
}

/* ksl_hsrz_fused of n elements. */
static KSL_INLINED void ksl_hsrz_fused_many(ptrdiff_t n, const ksl_SE3_t *D, ptrdiff_t D_stride,
    ksl_screw_t *so, ptrdiff_t so_stride) {
  KSL_EACH_OF(n) {
    ksl_hsrz_fused(D + i * D_stride, so + i * so_stride);
  }
}

static KSL_INLINED void ksl_hsrz_fused_planes(ptrdiff_t n, const double *D, ptrdiff_t D_plane,
    ptrdiff_t D_stride, double *so, ptrdiff_t so_plane, ptrdiff_t so_stride) {
  ksl_SE3_t D_i;
  if (n > 0) D_i = ksl_SE3_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3_of_planes(D + i * D_stride, D_plane);
    ksl_screw_t so_i;
    ksl_hsrz_fused(&D_i, &so_i);
    ksl_screw_to_planes(&so_i, so + i * so_stride, so_plane);
  }
}

/* ksl_hsrxinv_fused of n elements. */
static KSL_INLINED void ksl_hsrxinv_fused_many(ptrdiff_t n, const ksl_SE3_t *D, ptrdiff_t D_stride,
    ksl_screw_t *so, ptrdiff_t so_stride) {
  KSL_EACH_OF(n) {
    ksl_hsrxinv_fused(D + i * D_stride, so + i * so_stride);
  }
}

static KSL_INLINED void ksl_hsrxinv_fused_planes(ptrdiff_t n, const double *D, ptrdiff_t D_plane,
    ptrdiff_t D_stride, double *so, ptrdiff_t so_plane, ptrdiff_t so_stride) {
  ksl_SE3_t D_i;
  if (n > 0) D_i = ksl_SE3_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3_of_planes(D + i * D_stride, D_plane);
    ksl_screw_t so_i;
    ksl_hsrxinv_fused(&D_i, &so_i);
    ksl_screw_to_planes(&so_i, so + i * so_stride, so_plane);
  }
}

/* ksl_hsryinv_fused of n elements. */
static KSL_INLINED void ksl_hsryinv_fused_many(ptrdiff_t n, const ksl_SE3_t *D, ptrdiff_t D_stride,
    ksl_screw_t *so, ptrdiff_t so_stride) {
  KSL_EACH_OF(n) {
    ksl_hsryinv_fused(D + i * D_stride, so + i * so_stride);
  }
}

static KSL_INLINED void ksl_hsryinv_fused_planes(ptrdiff_t n, const double *D, ptrdiff_t D_plane,
    ptrdiff_t D_stride, double *so, ptrdiff_t so_plane, ptrdiff_t so_stride) {
  ksl_SE3_t D_i;
  if (n > 0) D_i = ksl_SE3_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3_of_planes(D + i * D_stride, D_plane);
    ksl_screw_t so_i;
    ksl_hsryinv_fused(&D_i, &so_i);
    ksl_screw_to_planes(&so_i, so + i * so_stride, so_plane);
  }
}

/* ksl_hsrzinv_fused of n elements. */
static KSL_INLINED void ksl_hsrzinv_fused_many(ptrdiff_t n, const ksl_SE3_t *D, ptrdiff_t D_stride,
    ksl_screw_t *so, ptrdiff_t so_stride) {
  KSL_EACH_OF(n) {
    ksl_hsrzinv_fused(D + i * D_stride, so + i * so_stride);
  }
}

static KSL_INLINED void ksl_hsrzinv_fused_planes(ptrdiff_t n, const double *D, ptrdiff_t D_plane,
    ptrdiff_t D_stride, double *so, ptrdiff_t so_plane, ptrdiff_t so_stride) {
  ksl_SE3_t D_i;
  if (n > 0) D_i = ksl_SE3_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3_of_planes(D + i * D_stride, D_plane);
    ksl_screw_t so_i;
    ksl_hsrzinv_fused(&D_i, &so_i);
    ksl_screw_to_planes(&so_i, so + i * so_stride, so_plane);
  }
}

/* ksl_Ad_fused of n elements. */
static KSL_INLINED void ksl_Ad_fused_many(ptrdiff_t n, const ksl_SE3_t *D, ptrdiff_t D_stride,
    ksl_mat6x6_t *M, ptrdiff_t M_stride) {
  KSL_EACH_OF(n) {
    ksl_Ad_fused(D + i * D_stride, M + i * M_stride);
  }
}

static KSL_INLINED void ksl_Ad_fused_planes(ptrdiff_t n, const double *D, ptrdiff_t D_plane,
    ptrdiff_t D_stride, double *M, ptrdiff_t M_plane, ptrdiff_t M_stride) {
  ksl_SE3_t D_i;
  if (n > 0) D_i = ksl_SE3_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3_of_planes(D + i * D_stride, D_plane);
    ksl_mat6x6_t M_i;
    ksl_Ad_fused(&D_i, &M_i);
    ksl_mat6x6_to_planes(&M_i, M + i * M_stride, M_plane);
  }
}

/* ksl_dot_cs_fused of n elements. */
static KSL_INLINED void ksl_dot_cs_fused_many(ptrdiff_t n, const ksl_coscrew_t *c,
    ptrdiff_t c_stride, const ksl_screw_t *s, ptrdiff_t s_stride, double *power,
    ptrdiff_t power_stride) {
  KSL_EACH_OF(n) {
    power[i * power_stride] = ksl_dot_cs_fused(c + i * c_stride, s + i * s_stride);
  }
}

static KSL_INLINED void ksl_dot_cs_fused_planes(ptrdiff_t n, const double *c, ptrdiff_t c_plane,
    ptrdiff_t c_stride, const double *s, ptrdiff_t s_plane, ptrdiff_t s_stride,
    double *power, ptrdiff_t power_stride) {
  ksl_coscrew_t c_i;
  if (n > 0) c_i = ksl_coscrew_of_planes(c, c_plane);
  KSL_EACH_OF(n) {
    if (c_stride) c_i = ksl_coscrew_of_planes(c + i * c_stride, c_plane);
    const ksl_screw_t s_i = ksl_screw_of_planes(s + i * s_stride, s_plane);
    power[i * power_stride] = ksl_dot_cs_fused(&c_i, &s_i);
  }
}

/* ksl_cross_ss_fused of n elements. */
static KSL_INLINED void ksl_cross_ss_fused_many(ptrdiff_t n, const ksl_screw_t *s1,
    ptrdiff_t s1_stride, const ksl_screw_t *s2, ptrdiff_t s2_stride,
    ksl_screw_t *so, ptrdiff_t so_stride) {
  KSL_EACH_OF(n) {
    ksl_cross_ss_fused(s1 + i * s1_stride, s2 + i * s2_stride, so + i * so_stride);
  }
}

static KSL_INLINED void ksl_cross_ss_fused_planes(ptrdiff_t n, const double *s1, ptrdiff_t s1_plane,
    ptrdiff_t s1_stride, const double *s2, ptrdiff_t s2_plane,
    ptrdiff_t s2_stride, double *so, ptrdiff_t so_plane, ptrdiff_t so_stride) {
  ksl_screw_t s1_i;
  if (n > 0) s1_i = ksl_screw_of_planes(s1, s1_plane);
  KSL_EACH_OF(n) {
    if (s1_stride) s1_i = ksl_screw_of_planes(s1 + i * s1_stride, s1_plane);
    const ksl_screw_t s2_i = ksl_screw_of_planes(s2 + i * s2_stride, s2_plane);
    ksl_screw_t so_i;
    ksl_cross_ss_fused(&s1_i, &s2_i, &so_i);
    ksl_screw_to_planes(&so_i, so + i * so_stride, so_plane);
  }
}

/* ksl_cross_sst_fused of n elements. */
static KSL_INLINED void ksl_cross_sst_fused_many(ptrdiff_t n, const ksl_screw_t *s1,
    ptrdiff_t s1_stride, const ksl_screw_t *s2, ptrdiff_t s2_stride,
    ksl_screw_t *so, ptrdiff_t so_stride) {
  KSL_EACH_OF(n) {
    ksl_cross_sst_fused(s1 + i * s1_stride, s2 + i * s2_stride, so + i * so_stride);
  }
}

static KSL_INLINED void ksl_cross_sst_fused_planes(ptrdiff_t n, const double *s1,
    ptrdiff_t s1_plane, ptrdiff_t s1_stride, const double *s2,
    ptrdiff_t s2_plane, ptrdiff_t s2_stride, double *so, ptrdiff_t so_plane,
    ptrdiff_t so_stride) {
  ksl_screw_t s1_i;
  if (n > 0) s1_i = ksl_screw_of_planes(s1, s1_plane);
  KSL_EACH_OF(n) {
    if (s1_stride) s1_i = ksl_screw_of_planes(s1 + i * s1_stride, s1_plane);
    const ksl_screw_t s2_i = ksl_screw_of_planes(s2 + i * s2_stride, s2_plane);
    ksl_screw_t so_i;
    ksl_cross_sst_fused(&s1_i, &s2_i, &so_i);
    ksl_screw_to_planes(&so_i, so + i * so_stride, so_plane);
  }
}

/* ksl_hsra_fused of n elements. */
static KSL_INLINED void ksl_hsra_fused_many(ptrdiff_t n, const ksl_SE3_t *D, ptrdiff_t D_stride,
    const ksl_vec3_t *axis, ptrdiff_t axis_stride, ksl_screw_t *so,
    ptrdiff_t so_stride) {
  KSL_EACH_OF(n) {
    ksl_hsra_fused(D + i * D_stride, axis + i * axis_stride, so + i * so_stride);
  }
}

static KSL_INLINED void ksl_hsra_fused_planes(ptrdiff_t n, const double *D, ptrdiff_t D_plane,
    ptrdiff_t D_stride, const double *axis, ptrdiff_t axis_plane,
    ptrdiff_t axis_stride, double *so, ptrdiff_t so_plane, ptrdiff_t so_stride) {
  ksl_SE3_t D_i;
  if (n > 0) D_i = ksl_SE3_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3_of_planes(D + i * D_stride, D_plane);
    const ksl_vec3_t axis_i = ksl_vec3_of_planes(axis + i * axis_stride, axis_plane);
    ksl_screw_t so_i;
    ksl_hsra_fused(&D_i, &axis_i, &so_i);
    ksl_screw_to_planes(&so_i, so + i * so_stride, so_plane);
  }
}

/* ksl_hsta_fused of n elements. */
static KSL_INLINED void ksl_hsta_fused_many(ptrdiff_t n, const ksl_SE3_t *D, ptrdiff_t D_stride,
    const ksl_vec3_t *axis, ptrdiff_t axis_stride, ksl_screw_t *so,
    ptrdiff_t so_stride) {
  KSL_EACH_OF(n) {
    ksl_hsta_fused(D + i * D_stride, axis + i * axis_stride, so + i * so_stride);
  }
}

static KSL_INLINED void ksl_hsta_fused_planes(ptrdiff_t n, const double *D, ptrdiff_t D_plane,
    ptrdiff_t D_stride, const double *axis, ptrdiff_t axis_plane,
    ptrdiff_t axis_stride, double *so, ptrdiff_t so_plane, ptrdiff_t so_stride) {
  ksl_SE3_t D_i;
  if (n > 0) D_i = ksl_SE3_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3_of_planes(D + i * D_stride, D_plane);
    const ksl_vec3_t axis_i = ksl_vec3_of_planes(axis + i * axis_stride, axis_plane);
    ksl_screw_t so_i;
    ksl_hsta_fused(&D_i, &axis_i, &so_i);
    ksl_screw_to_planes(&so_i, so + i * so_stride, so_plane);
  }
}

/* ksl_hsrainv_fused of n elements. */
static KSL_INLINED void ksl_hsrainv_fused_many(ptrdiff_t n, const ksl_SE3_t *D, ptrdiff_t D_stride,
    const ksl_vec3_t *axis, ptrdiff_t axis_stride, ksl_screw_t *so,
    ptrdiff_t so_stride) {
  KSL_EACH_OF(n) {
    ksl_hsrainv_fused(D + i * D_stride, axis + i * axis_stride, so + i * so_stride);
  }
}

static KSL_INLINED void ksl_hsrainv_fused_planes(ptrdiff_t n, const double *D, ptrdiff_t D_plane,
    ptrdiff_t D_stride, const double *axis, ptrdiff_t axis_plane,
    ptrdiff_t axis_stride, double *so, ptrdiff_t so_plane, ptrdiff_t so_stride) {
  ksl_SE3_t D_i;
  if (n > 0) D_i = ksl_SE3_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3_of_planes(D + i * D_stride, D_plane);
    const ksl_vec3_t axis_i = ksl_vec3_of_planes(axis + i * axis_stride, axis_plane);
    ksl_screw_t so_i;
    ksl_hsrainv_fused(&D_i, &axis_i, &so_i);
    ksl_screw_to_planes(&so_i, so + i * so_stride, so_plane);
  }
}

/* ksl_hstainv_fused of n elements. */
static KSL_INLINED void ksl_hstainv_fused_many(ptrdiff_t n, const ksl_SE3_t *D, ptrdiff_t D_stride,
    const ksl_vec3_t *axis, ptrdiff_t axis_stride, ksl_screw_t *so,
    ptrdiff_t so_stride) {
  KSL_EACH_OF(n) {
    ksl_hstainv_fused(D + i * D_stride, axis + i * axis_stride, so + i * so_stride);
  }
}

static KSL_INLINED void ksl_hstainv_fused_planes(ptrdiff_t n, const double *D, ptrdiff_t D_plane,
    ptrdiff_t D_stride, const double *axis, ptrdiff_t axis_plane,
    ptrdiff_t axis_stride, double *so, ptrdiff_t so_plane, ptrdiff_t so_stride) {
  ksl_SE3_t D_i;
  if (n > 0) D_i = ksl_SE3_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3_of_planes(D + i * D_stride, D_plane);
    const ksl_vec3_t axis_i = ksl_vec3_of_planes(axis + i * axis_stride, axis_plane);
    ksl_screw_t so_i;
    ksl_hstainv_fused(&D_i, &axis_i, &so_i);
    ksl_screw_to_planes(&so_i, so + i * so_stride, so_plane);
  }
}

/* ksl_screwf_scale_fused of n elements. */
static KSL_INLINED void ksl_screwf_scale_fused_many(ptrdiff_t n, ksl_screwf_t *self,
    ptrdiff_t self_stride, const float *a, ptrdiff_t a_stride) {
  KSL_EACH_OF(n) {
    ksl_screwf_scale_fused(self + i * self_stride, a[i * a_stride]);
  }
}

static KSL_INLINED void ksl_screwf_scale_fused_planes(ptrdiff_t n, float *self,
    ptrdiff_t self_plane, ptrdiff_t self_stride, const float *a,
    ptrdiff_t a_stride) {
  KSL_EACH_OF(n) {
    ksl_screwf_t self_i = ksl_screwf_of_planes(self + i * self_stride, self_plane);
    ksl_screwf_scale_fused(&self_i, a[i * a_stride]);
    ksl_screwf_to_planes(&self_i, self + i * self_stride, self_plane);
  }
}

/* ksl_axpy_ssf_fused of n elements. */
static KSL_INLINED void ksl_axpy_ssf_fused_many(ptrdiff_t n, const float *a, ptrdiff_t a_stride,
    const ksl_screwf_t *x, ptrdiff_t x_stride, ksl_screwf_t *y,
    ptrdiff_t y_stride) {
  KSL_EACH_OF(n) {
    ksl_axpy_ssf_fused(a[i * a_stride], x + i * x_stride, y + i * y_stride);
  }
}

static KSL_INLINED void ksl_axpy_ssf_fused_planes(ptrdiff_t n, const float *a, ptrdiff_t a_stride,
    const float *x, ptrdiff_t x_plane, ptrdiff_t x_stride, float *y,
    ptrdiff_t y_plane, ptrdiff_t y_stride) {
  KSL_EACH_OF(n) {
    const ksl_screwf_t x_i = ksl_screwf_of_planes(x + i * x_stride, x_plane);
    ksl_screwf_t y_i = ksl_screwf_of_planes(y + i * y_stride, y_plane);
    ksl_axpy_ssf_fused(a[i * a_stride], &x_i, &y_i);
    ksl_screwf_to_planes(&y_i, y + i * y_stride, y_plane);
  }
}

/* ksl_xpy_ssf_fused of n elements. */
static KSL_INLINED void ksl_xpy_ssf_fused_many(ptrdiff_t n, const ksl_screwf_t *x,
    ptrdiff_t x_stride, ksl_screwf_t *y, ptrdiff_t y_stride) {
  KSL_EACH_OF(n) {
    ksl_xpy_ssf_fused(x + i * x_stride, y + i * y_stride);
  }
}

static KSL_INLINED void ksl_xpy_ssf_fused_planes(ptrdiff_t n, const float *x, ptrdiff_t x_plane,
    ptrdiff_t x_stride, float *y, ptrdiff_t y_plane, ptrdiff_t y_stride) {
  ksl_screwf_t x_i;
  if (n > 0) x_i = ksl_screwf_of_planes(x, x_plane);
  KSL_EACH_OF(n) {
    if (x_stride) x_i = ksl_screwf_of_planes(x + i * x_stride, x_plane);
    ksl_screwf_t y_i = ksl_screwf_of_planes(y + i * y_stride, y_plane);
    ksl_xpy_ssf_fused(&x_i, &y_i);
    ksl_screwf_to_planes(&y_i, y + i * y_stride, y_plane);
  }
}

/* ksl_nxpy_ssf_fused of n elements. */
static KSL_INLINED void ksl_nxpy_ssf_fused_many(ptrdiff_t n, const ksl_screwf_t *x,
    ptrdiff_t x_stride, ksl_screwf_t *y, ptrdiff_t y_stride) {
  KSL_EACH_OF(n) {
    ksl_nxpy_ssf_fused(x + i * x_stride, y + i * y_stride);
  }
}

static KSL_INLINED void ksl_nxpy_ssf_fused_planes(ptrdiff_t n, const float *x, ptrdiff_t x_plane,
    ptrdiff_t x_stride, float *y, ptrdiff_t y_plane, ptrdiff_t y_stride) {
  ksl_screwf_t x_i;
  if (n > 0) x_i = ksl_screwf_of_planes(x, x_plane);
  KSL_EACH_OF(n) {
    if (x_stride) x_i = ksl_screwf_of_planes(x + i * x_stride, x_plane);
    ksl_screwf_t y_i = ksl_screwf_of_planes(y + i * y_stride, y_plane);
    ksl_nxpy_ssf_fused(&x_i, &y_i);
    ksl_screwf_to_planes(&y_i, y + i * y_stride, y_plane);
  }
}

/* ksl_product_asf_fused of n elements. */
static KSL_INLINED void ksl_product_asf_fused_many(ptrdiff_t n, const float *a, ptrdiff_t a_stride,
    const ksl_screwf_t *si, ptrdiff_t si_stride, ksl_screwf_t *so,
    ptrdiff_t so_stride) {
  KSL_EACH_OF(n) {
    ksl_product_asf_fused(a[i * a_stride], si + i * si_stride, so + i * so_stride);
  }
}

static KSL_INLINED void ksl_product_asf_fused_planes(ptrdiff_t n, const float *a,
    ptrdiff_t a_stride, const float *si, ptrdiff_t si_plane, ptrdiff_t si_stride,
    float *so, ptrdiff_t so_plane, ptrdiff_t so_stride) {
  KSL_EACH_OF(n) {
    const ksl_screwf_t si_i = ksl_screwf_of_planes(si + i * si_stride, si_plane);
    ksl_screwf_t so_i;
    ksl_product_asf_fused(a[i * a_stride], &si_i, &so_i);
    ksl_screwf_to_planes(&so_i, so + i * so_stride, so_plane);
  }
}

/* ksl_add_ssf_fused of n elements. */
static KSL_INLINED void ksl_add_ssf_fused_many(ptrdiff_t n, const ksl_screwf_t *s1,
    ptrdiff_t s1_stride, const ksl_screwf_t *s2, ptrdiff_t s2_stride,
    ksl_screwf_t *so, ptrdiff_t so_stride) {
  KSL_EACH_OF(n) {
    ksl_add_ssf_fused(s1 + i * s1_stride, s2 + i * s2_stride, so + i * so_stride);
  }
}

static KSL_INLINED void ksl_add_ssf_fused_planes(ptrdiff_t n, const float *s1, ptrdiff_t s1_plane,
    ptrdiff_t s1_stride, const float *s2, ptrdiff_t s2_plane,
    ptrdiff_t s2_stride, float *so, ptrdiff_t so_plane, ptrdiff_t so_stride) {
  ksl_screwf_t s1_i;
  if (n > 0) s1_i = ksl_screwf_of_planes(s1, s1_plane);
  KSL_EACH_OF(n) {
    if (s1_stride) s1_i = ksl_screwf_of_planes(s1 + i * s1_stride, s1_plane);
    const ksl_screwf_t s2_i = ksl_screwf_of_planes(s2 + i * s2_stride, s2_plane);
    ksl_screwf_t so_i;
    ksl_add_ssf_fused(&s1_i, &s2_i, &so_i);
    ksl_screwf_to_planes(&so_i, so + i * so_stride, so_plane);
  }
}

/* ksl_subtract_ssf_fused of n elements. */
static KSL_INLINED void ksl_subtract_ssf_fused_many(ptrdiff_t n, const ksl_screwf_t *s1,
    ptrdiff_t s1_stride, const ksl_screwf_t *s2, ptrdiff_t s2_stride,
    ksl_screwf_t *so, ptrdiff_t so_stride) {
  KSL_EACH_OF(n) {
    ksl_subtract_ssf_fused(s1 + i * s1_stride, s2 + i * s2_stride, so + i * so_stride);
  }
}

static KSL_INLINED void ksl_subtract_ssf_fused_planes(ptrdiff_t n, const float *s1,
    ptrdiff_t s1_plane, ptrdiff_t s1_stride, const float *s2, ptrdiff_t s2_plane,
    ptrdiff_t s2_stride, float *so, ptrdiff_t so_plane, ptrdiff_t so_stride) {
  ksl_screwf_t s1_i;
  if (n > 0) s1_i = ksl_screwf_of_planes(s1, s1_plane);
  KSL_EACH_OF(n) {
    if (s1_stride) s1_i = ksl_screwf_of_planes(s1 + i * s1_stride, s1_plane);
    const ksl_screwf_t s2_i = ksl_screwf_of_planes(s2 + i * s2_stride, s2_plane);
    ksl_screwf_t so_i;
    ksl_subtract_ssf_fused(&s1_i, &s2_i, &so_i);
    ksl_screwf_to_planes(&so_i, so + i * so_stride, so_plane);
  }
}

/* ksl_add_sstf_fused of n elements. */
static KSL_INLINED void ksl_add_sstf_fused_many(ptrdiff_t n, const ksl_screwf_t *s1,
    ptrdiff_t s1_stride, const ksl_screwf_t *s2, ptrdiff_t s2_stride,
    ksl_screwf_t *so, ptrdiff_t so_stride) {
  KSL_EACH_OF(n) {
    ksl_add_sstf_fused(s1 + i * s1_stride, s2 + i * s2_stride, so + i * so_stride);
  }
}

static KSL_INLINED void ksl_add_sstf_fused_planes(ptrdiff_t n, const float *s1, ptrdiff_t s1_plane,
    ptrdiff_t s1_stride, const float *s2, ptrdiff_t s2_plane,
    ptrdiff_t s2_stride, float *so, ptrdiff_t so_plane, ptrdiff_t so_stride) {
  ksl_screwf_t s1_i;
  if (n > 0) s1_i = ksl_screwf_of_planes(s1, s1_plane);
  KSL_EACH_OF(n) {
    if (s1_stride) s1_i = ksl_screwf_of_planes(s1 + i * s1_stride, s1_plane);
    const ksl_screwf_t s2_i = ksl_screwf_of_planes(s2 + i * s2_stride, s2_plane);
    ksl_screwf_t so_i;
    ksl_add_sstf_fused(&s1_i, &s2_i, &so_i);
    ksl_screwf_to_planes(&so_i, so + i * so_stride, so_plane);
  }
}

/* ksl_product_Adtsf_fused of n elements. */
static KSL_INLINED void ksl_product_Adtsf_fused_many(ptrdiff_t n, const ksl_vec3f_t *t,
    ptrdiff_t t_stride, const ksl_screwf_t *si, ptrdiff_t si_stride,
    ksl_screwf_t *so, ptrdiff_t so_stride) {
  KSL_EACH_OF(n) {
    ksl_product_Adtsf_fused(t + i * t_stride, si + i * si_stride, so + i * so_stride);
  }
}

static KSL_INLINED void ksl_product_Adtsf_fused_planes(ptrdiff_t n, const float *t,
    ptrdiff_t t_plane, ptrdiff_t t_stride, const float *si, ptrdiff_t si_plane,
    ptrdiff_t si_stride, float *so, ptrdiff_t so_plane, ptrdiff_t so_stride) {
  ksl_vec3f_t t_i;
  if (n > 0) t_i = ksl_vec3f_of_planes(t, t_plane);
  KSL_EACH_OF(n) {
    if (t_stride) t_i = ksl_vec3f_of_planes(t + i * t_stride, t_plane);
    const ksl_screwf_t si_i = ksl_screwf_of_planes(si + i * si_stride, si_plane);
    ksl_screwf_t so_i;
    ksl_product_Adtsf_fused(&t_i, &si_i, &so_i);
    ksl_screwf_to_planes(&so_i, so + i * so_stride, so_plane);
  }
}

/* ksl_product_Adtinvsf_fused of n elements. */
static KSL_INLINED void ksl_product_Adtinvsf_fused_many(ptrdiff_t n, const ksl_vec3f_t *t,
    ptrdiff_t t_stride, const ksl_screwf_t *si, ptrdiff_t si_stride,
    ksl_screwf_t *so, ptrdiff_t so_stride) {
  KSL_EACH_OF(n) {
    ksl_product_Adtinvsf_fused(t + i * t_stride, si + i * si_stride, so + i * so_stride);
  }
}

static KSL_INLINED void ksl_product_Adtinvsf_fused_planes(ptrdiff_t n, const float *t,
    ptrdiff_t t_plane, ptrdiff_t t_stride, const float *si, ptrdiff_t si_plane,
    ptrdiff_t si_stride, float *so, ptrdiff_t so_plane, ptrdiff_t so_stride) {
  ksl_vec3f_t t_i;
  if (n > 0) t_i = ksl_vec3f_of_planes(t, t_plane);
  KSL_EACH_OF(n) {
    if (t_stride) t_i = ksl_vec3f_of_planes(t + i * t_stride, t_plane);
    const ksl_screwf_t si_i = ksl_screwf_of_planes(si + i * si_stride, si_plane);
    ksl_screwf_t so_i;
    ksl_product_Adtinvsf_fused(&t_i, &si_i, &so_i);
    ksl_screwf_to_planes(&so_i, so + i * so_stride, so_plane);
  }
}

/* ksl_product_Adtsinvf_fused of n elements. */
static KSL_INLINED void ksl_product_Adtsinvf_fused_many(ptrdiff_t n, const ksl_vec3f_t *t,
    ptrdiff_t t_stride, const ksl_screwf_t *si, ptrdiff_t si_stride,
    ksl_screwf_t *so, ptrdiff_t so_stride) {
  KSL_EACH_OF(n) {
    ksl_product_Adtsinvf_fused(t + i * t_stride, si + i * si_stride, so + i * so_stride);
  }
}

static KSL_INLINED void ksl_product_Adtsinvf_fused_planes(ptrdiff_t n, const float *t,
    ptrdiff_t t_plane, ptrdiff_t t_stride, const float *si, ptrdiff_t si_plane,
    ptrdiff_t si_stride, float *so, ptrdiff_t so_plane, ptrdiff_t so_stride) {
  ksl_vec3f_t t_i;
  if (n > 0) t_i = ksl_vec3f_of_planes(t, t_plane);
  KSL_EACH_OF(n) {
    if (t_stride) t_i = ksl_vec3f_of_planes(t + i * t_stride, t_plane);
    const ksl_screwf_t si_i = ksl_screwf_of_planes(si + i * si_stride, si_plane);
    ksl_screwf_t so_i;
    ksl_product_Adtsinvf_fused(&t_i, &si_i, &so_i);
    ksl_screwf_to_planes(&so_i, so + i * so_stride, so_plane);
  }
}

/* ksl_product_Adrsf_fused of n elements. */
static KSL_INLINED void ksl_product_Adrsf_fused_many(ptrdiff_t n, const ksl_mat3x3f_t *R,
    ptrdiff_t R_stride, const ksl_screwf_t *si, ptrdiff_t si_stride,
    ksl_screwf_t *so, ptrdiff_t so_stride) {
  KSL_EACH_OF(n) {
    ksl_product_Adrsf_fused(R + i * R_stride, si + i * si_stride, so + i * so_stride);
  }
}

static KSL_INLINED void ksl_product_Adrsf_fused_planes(ptrdiff_t n, const float *R,
    ptrdiff_t R_plane, ptrdiff_t R_stride, const float *si, ptrdiff_t si_plane,
    ptrdiff_t si_stride, float *so, ptrdiff_t so_plane, ptrdiff_t so_stride) {
  ksl_mat3x3f_t R_i;
  if (n > 0) R_i = ksl_mat3x3f_of_planes(R, R_plane);
  KSL_EACH_OF(n) {
    if (R_stride) R_i = ksl_mat3x3f_of_planes(R + i * R_stride, R_plane);
    const ksl_screwf_t si_i = ksl_screwf_of_planes(si + i * si_stride, si_plane);
    ksl_screwf_t so_i;
    ksl_product_Adrsf_fused(&R_i, &si_i, &so_i);
    ksl_screwf_to_planes(&so_i, so + i * so_stride, so_plane);
  }
}

/* ksl_product_Adrinvsf_fused of n elements. */
static KSL_INLINED void ksl_product_Adrinvsf_fused_many(ptrdiff_t n, const ksl_mat3x3f_t *R,
    ptrdiff_t R_stride, const ksl_screwf_t *si, ptrdiff_t si_stride,
    ksl_screwf_t *so, ptrdiff_t so_stride) {
  KSL_EACH_OF(n) {
    ksl_product_Adrinvsf_fused(R + i * R_stride, si + i * si_stride, so + i * so_stride);
  }
}

static KSL_INLINED void ksl_product_Adrinvsf_fused_planes(ptrdiff_t n, const float *R,
    ptrdiff_t R_plane, ptrdiff_t R_stride, const float *si, ptrdiff_t si_plane,
    ptrdiff_t si_stride, float *so, ptrdiff_t so_plane, ptrdiff_t so_stride) {
  ksl_mat3x3f_t R_i;
  if (n > 0) R_i = ksl_mat3x3f_of_planes(R, R_plane);
  KSL_EACH_OF(n) {
    if (R_stride) R_i = ksl_mat3x3f_of_planes(R + i * R_stride, R_plane);
    const ksl_screwf_t si_i = ksl_screwf_of_planes(si + i * si_stride, si_plane);
    ksl_screwf_t so_i;
    ksl_product_Adrinvsf_fused(&R_i, &si_i, &so_i);
    ksl_screwf_to_planes(&so_i, so + i * so_stride, so_plane);
  }
}

/* ksl_product_Adrsinvf_fused of n elements. */
static KSL_INLINED void ksl_product_Adrsinvf_fused_many(ptrdiff_t n, const ksl_mat3x3f_t *R,
    ptrdiff_t R_stride, const ksl_screwf_t *si, ptrdiff_t si_stride,
    ksl_screwf_t *so, ptrdiff_t so_stride) {
  KSL_EACH_OF(n) {
    ksl_product_Adrsinvf_fused(R + i * R_stride, si + i * si_stride, so + i * so_stride);
  }
}

static KSL_INLINED void ksl_product_Adrsinvf_fused_planes(ptrdiff_t n, const float *R,
    ptrdiff_t R_plane, ptrdiff_t R_stride, const float *si, ptrdiff_t si_plane,
    ptrdiff_t si_stride, float *so, ptrdiff_t so_plane, ptrdiff_t so_stride) {
  ksl_mat3x3f_t R_i;
  if (n > 0) R_i = ksl_mat3x3f_of_planes(R, R_plane);
  KSL_EACH_OF(n) {
    if (R_stride) R_i = ksl_mat3x3f_of_planes(R + i * R_stride, R_plane);
    const ksl_screwf_t si_i = ksl_screwf_of_planes(si + i * si_stride, si_plane);
    ksl_screwf_t so_i;
    ksl_product_Adrsinvf_fused(&R_i, &si_i, &so_i);
    ksl_screwf_to_planes(&so_i, so + i * so_stride, so_plane);
  }
}

/* ksl_product_Adsf_fused of n elements. */
static KSL_INLINED void ksl_product_Adsf_fused_many(ptrdiff_t n, const ksl_SE3f_t *D,
    ptrdiff_t D_stride, const ksl_screwf_t *si, ptrdiff_t si_stride,
    ksl_screwf_t *so, ptrdiff_t so_stride) {
  KSL_EACH_OF(n) {
    ksl_product_Adsf_fused(D + i * D_stride, si + i * si_stride, so + i * so_stride);
  }
}

static KSL_INLINED void ksl_product_Adsf_fused_planes(ptrdiff_t n, const float *D,
    ptrdiff_t D_plane, ptrdiff_t D_stride, const float *si, ptrdiff_t si_plane,
    ptrdiff_t si_stride, float *so, ptrdiff_t so_plane, ptrdiff_t so_stride) {
  ksl_SE3f_t D_i;
  if (n > 0) D_i = ksl_SE3f_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3f_of_planes(D + i * D_stride, D_plane);
    const ksl_screwf_t si_i = ksl_screwf_of_planes(si + i * si_stride, si_plane);
    ksl_screwf_t so_i;
    ksl_product_Adsf_fused(&D_i, &si_i, &so_i);
    ksl_screwf_to_planes(&so_i, so + i * so_stride, so_plane);
  }
}

/* ksl_product_Adinvsf_fused of n elements. */
static KSL_INLINED void ksl_product_Adinvsf_fused_many(ptrdiff_t n, const ksl_SE3f_t *D,
    ptrdiff_t D_stride, const ksl_screwf_t *si, ptrdiff_t si_stride,
    ksl_screwf_t *so, ptrdiff_t so_stride) {
  KSL_EACH_OF(n) {
    ksl_product_Adinvsf_fused(D + i * D_stride, si + i * si_stride, so + i * so_stride);
  }
}

static KSL_INLINED void ksl_product_Adinvsf_fused_planes(ptrdiff_t n, const float *D,
    ptrdiff_t D_plane, ptrdiff_t D_stride, const float *si, ptrdiff_t si_plane,
    ptrdiff_t si_stride, float *so, ptrdiff_t so_plane, ptrdiff_t so_stride) {
  ksl_SE3f_t D_i;
  if (n > 0) D_i = ksl_SE3f_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3f_of_planes(D + i * D_stride, D_plane);
    const ksl_screwf_t si_i = ksl_screwf_of_planes(si + i * si_stride, si_plane);
    ksl_screwf_t so_i;
    ksl_product_Adinvsf_fused(&D_i, &si_i, &so_i);
    ksl_screwf_to_planes(&so_i, so + i * so_stride, so_plane);
  }
}

/* ksl_product_Adsinvf_fused of n elements. */
static KSL_INLINED void ksl_product_Adsinvf_fused_many(ptrdiff_t n, const ksl_SE3f_t *D,
    ptrdiff_t D_stride, const ksl_screwf_t *si, ptrdiff_t si_stride,
    ksl_screwf_t *so, ptrdiff_t so_stride) {
  KSL_EACH_OF(n) {
    ksl_product_Adsinvf_fused(D + i * D_stride, si + i * si_stride, so + i * so_stride);
  }
}

static KSL_INLINED void ksl_product_Adsinvf_fused_planes(ptrdiff_t n, const float *D,
    ptrdiff_t D_plane, ptrdiff_t D_stride, const float *si, ptrdiff_t si_plane,
    ptrdiff_t si_stride, float *so, ptrdiff_t so_plane, ptrdiff_t so_stride) {
  ksl_SE3f_t D_i;
  if (n > 0) D_i = ksl_SE3f_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3f_of_planes(D + i * D_stride, D_plane);
    const ksl_screwf_t si_i = ksl_screwf_of_planes(si + i * si_stride, si_plane);
    ksl_screwf_t so_i;
    ksl_product_Adsinvf_fused(&D_i, &si_i, &so_i);
    ksl_screwf_to_planes(&so_i, so + i * so_stride, so_plane);
  }
}

/* ksl_hsrxf_fused of n elements. */
static KSL_INLINED void ksl_hsrxf_fused_many(ptrdiff_t n, const ksl_SE3f_t *D, ptrdiff_t D_stride,
    ksl_screwf_t *so, ptrdiff_t so_stride) {
  KSL_EACH_OF(n) {
    ksl_hsrxf_fused(D + i * D_stride, so + i * so_stride);
  }
}

static KSL_INLINED void ksl_hsrxf_fused_planes(ptrdiff_t n, const float *D, ptrdiff_t D_plane,
    ptrdiff_t D_stride, float *so, ptrdiff_t so_plane, ptrdiff_t so_stride) {
  ksl_SE3f_t D_i;
  if (n > 0) D_i = ksl_SE3f_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3f_of_planes(D + i * D_stride, D_plane);
    ksl_screwf_t so_i;
    ksl_hsrxf_fused(&D_i, &so_i);
    ksl_screwf_to_planes(&so_i, so + i * so_stride, so_plane);
  }
}

/* ksl_hsryf_fused of n elements. */
static KSL_INLINED void ksl_hsryf_fused_many(ptrdiff_t n, const ksl_SE3f_t *D, ptrdiff_t D_stride,
    ksl_screwf_t *so, ptrdiff_t so_stride) {
  KSL_EACH_OF(n) {
    ksl_hsryf_fused(D + i * D_stride, so + i * so_stride);
  }
}

static KSL_INLINED void ksl_hsryf_fused_planes(ptrdiff_t n, const float *D, ptrdiff_t D_plane,
    ptrdiff_t D_stride, float *so, ptrdiff_t so_plane, ptrdiff_t so_stride) {
  ksl_SE3f_t D_i;
  if (n > 0) D_i = ksl_SE3f_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3f_of_planes(D + i * D_stride, D_plane);
    ksl_screwf_t so_i;
    ksl_hsryf_fused(&D_i, &so_i);
    ksl_screwf_to_planes(&so_i, so + i * so_stride, so_plane);
  }
}

/* ksl_hsrzf_fused of n elements. */
static KSL_INLINED void ksl_hsrzf_fused_many(ptrdiff_t n, const ksl_SE3f_t *D, ptrdiff_t D_stride,
    ksl_screwf_t *so, ptrdiff_t so_stride) {
  KSL_EACH_OF(n) {
    ksl_hsrzf_fused(D + i * D_stride, so + i * so_stride);
  }
}

static KSL_INLINED void ksl_hsrzf_fused_planes(ptrdiff_t n, const float *D, ptrdiff_t D_plane,
    ptrdiff_t D_stride, float *so, ptrdiff_t so_plane, ptrdiff_t so_stride) {
  ksl_SE3f_t D_i;
  if (n > 0) D_i = ksl_SE3f_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3f_of_planes(D + i * D_stride, D_plane);
    ksl_screwf_t so_i;
    ksl_hsrzf_fused(&D_i, &so_i);
    ksl_screwf_to_planes(&so_i, so + i * so_stride, so_plane);
  }
}

/* ksl_hsrxinvf_fused of n elements. */
static KSL_INLINED void ksl_hsrxinvf_fused_many(ptrdiff_t n, const ksl_SE3f_t *D,
    ptrdiff_t D_stride, ksl_screwf_t *so, ptrdiff_t so_stride) {
  KSL_EACH_OF(n) {
    ksl_hsrxinvf_fused(D + i * D_stride, so + i * so_stride);
  }
}

static KSL_INLINED void ksl_hsrxinvf_fused_planes(ptrdiff_t n, const float *D, ptrdiff_t D_plane,
    ptrdiff_t D_stride, float *so, ptrdiff_t so_plane, ptrdiff_t so_stride) {
  ksl_SE3f_t D_i;
  if (n > 0) D_i = ksl_SE3f_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3f_of_planes(D + i * D_stride, D_plane);
    ksl_screwf_t so_i;
    ksl_hsrxinvf_fused(&D_i, &so_i);
    ksl_screwf_to_planes(&so_i, so + i * so_stride, so_plane);
  }
}

/* ksl_hsryinvf_fused of n elements. */
static KSL_INLINED void ksl_hsryinvf_fused_many(ptrdiff_t n, const ksl_SE3f_t *D,
    ptrdiff_t D_stride, ksl_screwf_t *so, ptrdiff_t so_stride) {
  KSL_EACH_OF(n) {
    ksl_hsryinvf_fused(D + i * D_stride, so + i * so_stride);
  }
}

static KSL_INLINED void ksl_hsryinvf_fused_planes(ptrdiff_t n, const float *D, ptrdiff_t D_plane,
    ptrdiff_t D_stride, float *so, ptrdiff_t so_plane, ptrdiff_t so_stride) {
  ksl_SE3f_t D_i;
  if (n > 0) D_i = ksl_SE3f_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3f_of_planes(D + i * D_stride, D_plane);
    ksl_screwf_t so_i;
    ksl_hsryinvf_fused(&D_i, &so_i);
    ksl_screwf_to_planes(&so_i, so + i * so_stride, so_plane);
  }
}

/* ksl_hsrzinvf_fused of n elements. */
static KSL_INLINED void ksl_hsrzinvf_fused_many(ptrdiff_t n, const ksl_SE3f_t *D,
    ptrdiff_t D_stride, ksl_screwf_t *so, ptrdiff_t so_stride) {
  KSL_EACH_OF(n) {
    ksl_hsrzinvf_fused(D + i * D_stride, so + i * so_stride);
  }
}

static KSL_INLINED void ksl_hsrzinvf_fused_planes(ptrdiff_t n, const float *D, ptrdiff_t D_plane,
    ptrdiff_t D_stride, float *so, ptrdiff_t so_plane, ptrdiff_t so_stride) {
  ksl_SE3f_t D_i;
  if (n > 0) D_i = ksl_SE3f_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3f_of_planes(D + i * D_stride, D_plane);
    ksl_screwf_t so_i;
    ksl_hsrzinvf_fused(&D_i, &so_i);
    ksl_screwf_to_planes(&so_i, so + i * so_stride, so_plane);
  }
}

/* ksl_Adf_fused of n elements. */
static KSL_INLINED void ksl_Adf_fused_many(ptrdiff_t n, const ksl_SE3f_t *D, ptrdiff_t D_stride,
    ksl_mat6x6f_t *M, ptrdiff_t M_stride) {
  KSL_EACH_OF(n) {
    ksl_Adf_fused(D + i * D_stride, M + i * M_stride);
  }
}

static KSL_INLINED void ksl_Adf_fused_planes(ptrdiff_t n, const float *D, ptrdiff_t D_plane,
    ptrdiff_t D_stride, float *M, ptrdiff_t M_plane, ptrdiff_t M_stride) {
  ksl_SE3f_t D_i;
  if (n > 0) D_i = ksl_SE3f_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3f_of_planes(D + i * D_stride, D_plane);
    ksl_mat6x6f_t M_i;
    ksl_Adf_fused(&D_i, &M_i);
    ksl_mat6x6f_to_planes(&M_i, M + i * M_stride, M_plane);
  }
}

/* ksl_dot_csf_fused of n elements. */
static KSL_INLINED void ksl_dot_csf_fused_many(ptrdiff_t n, const ksl_coscrewf_t *c,
    ptrdiff_t c_stride, const ksl_screwf_t *s, ptrdiff_t s_stride, float *power,
    ptrdiff_t power_stride) {
  KSL_EACH_OF(n) {
    power[i * power_stride] = ksl_dot_csf_fused(c + i * c_stride, s + i * s_stride);
  }
}

static KSL_INLINED void ksl_dot_csf_fused_planes(ptrdiff_t n, const float *c, ptrdiff_t c_plane,
    ptrdiff_t c_stride, const float *s, ptrdiff_t s_plane, ptrdiff_t s_stride,
    float *power, ptrdiff_t power_stride) {
  ksl_coscrewf_t c_i;
  if (n > 0) c_i = ksl_coscrewf_of_planes(c, c_plane);
  KSL_EACH_OF(n) {
    if (c_stride) c_i = ksl_coscrewf_of_planes(c + i * c_stride, c_plane);
    const ksl_screwf_t s_i = ksl_screwf_of_planes(s + i * s_stride, s_plane);
    power[i * power_stride] = ksl_dot_csf_fused(&c_i, &s_i);
  }
}

/* ksl_cross_ssf_fused of n elements. */
static KSL_INLINED void ksl_cross_ssf_fused_many(ptrdiff_t n, const ksl_screwf_t *s1,
    ptrdiff_t s1_stride, const ksl_screwf_t *s2, ptrdiff_t s2_stride,
    ksl_screwf_t *so, ptrdiff_t so_stride) {
  KSL_EACH_OF(n) {
    ksl_cross_ssf_fused(s1 + i * s1_stride, s2 + i * s2_stride, so + i * so_stride);
  }
}

static KSL_INLINED void ksl_cross_ssf_fused_planes(ptrdiff_t n, const float *s1, ptrdiff_t s1_plane,
    ptrdiff_t s1_stride, const float *s2, ptrdiff_t s2_plane,
    ptrdiff_t s2_stride, float *so, ptrdiff_t so_plane, ptrdiff_t so_stride) {
  ksl_screwf_t s1_i;
  if (n > 0) s1_i = ksl_screwf_of_planes(s1, s1_plane);
  KSL_EACH_OF(n) {
    if (s1_stride) s1_i = ksl_screwf_of_planes(s1 + i * s1_stride, s1_plane);
    const ksl_screwf_t s2_i = ksl_screwf_of_planes(s2 + i * s2_stride, s2_plane);
    ksl_screwf_t so_i;
    ksl_cross_ssf_fused(&s1_i, &s2_i, &so_i);
    ksl_screwf_to_planes(&so_i, so + i * so_stride, so_plane);
  }
}

/* ksl_cross_sstf_fused of n elements. */
static KSL_INLINED void ksl_cross_sstf_fused_many(ptrdiff_t n, const ksl_screwf_t *s1,
    ptrdiff_t s1_stride, const ksl_screwf_t *s2, ptrdiff_t s2_stride,
    ksl_screwf_t *so, ptrdiff_t so_stride) {
  KSL_EACH_OF(n) {
    ksl_cross_sstf_fused(s1 + i * s1_stride, s2 + i * s2_stride, so + i * so_stride);
  }
}

static KSL_INLINED void ksl_cross_sstf_fused_planes(ptrdiff_t n, const float *s1,
    ptrdiff_t s1_plane, ptrdiff_t s1_stride, const float *s2, ptrdiff_t s2_plane,
    ptrdiff_t s2_stride, float *so, ptrdiff_t so_plane, ptrdiff_t so_stride) {
  ksl_screwf_t s1_i;
  if (n > 0) s1_i = ksl_screwf_of_planes(s1, s1_plane);
  KSL_EACH_OF(n) {
    if (s1_stride) s1_i = ksl_screwf_of_planes(s1 + i * s1_stride, s1_plane);
    const ksl_screwf_t s2_i = ksl_screwf_of_planes(s2 + i * s2_stride, s2_plane);
    ksl_screwf_t so_i;
    ksl_cross_sstf_fused(&s1_i, &s2_i, &so_i);
    ksl_screwf_to_planes(&so_i, so + i * so_stride, so_plane);
  }
}

/* ksl_hsraf_fused of n elements. */
static KSL_INLINED void ksl_hsraf_fused_many(ptrdiff_t n, const ksl_SE3f_t *D, ptrdiff_t D_stride,
    const ksl_vec3f_t *axis, ptrdiff_t axis_stride, ksl_screwf_t *so,
    ptrdiff_t so_stride) {
  KSL_EACH_OF(n) {
    ksl_hsraf_fused(D + i * D_stride, axis + i * axis_stride, so + i * so_stride);
  }
}

static KSL_INLINED void ksl_hsraf_fused_planes(ptrdiff_t n, const float *D, ptrdiff_t D_plane,
    ptrdiff_t D_stride, const float *axis, ptrdiff_t axis_plane,
    ptrdiff_t axis_stride, float *so, ptrdiff_t so_plane, ptrdiff_t so_stride) {
  ksl_SE3f_t D_i;
  if (n > 0) D_i = ksl_SE3f_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3f_of_planes(D + i * D_stride, D_plane);
    const ksl_vec3f_t axis_i = ksl_vec3f_of_planes(axis + i * axis_stride, axis_plane);
    ksl_screwf_t so_i;
    ksl_hsraf_fused(&D_i, &axis_i, &so_i);
    ksl_screwf_to_planes(&so_i, so + i * so_stride, so_plane);
  }
}

/* ksl_hstaf_fused of n elements. */
static KSL_INLINED void ksl_hstaf_fused_many(ptrdiff_t n, const ksl_SE3f_t *D, ptrdiff_t D_stride,
    const ksl_vec3f_t *axis, ptrdiff_t axis_stride, ksl_screwf_t *so,
    ptrdiff_t so_stride) {
  KSL_EACH_OF(n) {
    ksl_hstaf_fused(D + i * D_stride, axis + i * axis_stride, so + i * so_stride);
  }
}

static KSL_INLINED void ksl_hstaf_fused_planes(ptrdiff_t n, const float *D, ptrdiff_t D_plane,
    ptrdiff_t D_stride, const float *axis, ptrdiff_t axis_plane,
    ptrdiff_t axis_stride, float *so, ptrdiff_t so_plane, ptrdiff_t so_stride) {
  ksl_SE3f_t D_i;
  if (n > 0) D_i = ksl_SE3f_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3f_of_planes(D + i * D_stride, D_plane);
    const ksl_vec3f_t axis_i = ksl_vec3f_of_planes(axis + i * axis_stride, axis_plane);
    ksl_screwf_t so_i;
    ksl_hstaf_fused(&D_i, &axis_i, &so_i);
    ksl_screwf_to_planes(&so_i, so + i * so_stride, so_plane);
  }
}

/* ksl_hsrainvf_fused of n elements. */
static KSL_INLINED void ksl_hsrainvf_fused_many(ptrdiff_t n, const ksl_SE3f_t *D,
    ptrdiff_t D_stride, const ksl_vec3f_t *axis, ptrdiff_t axis_stride,
    ksl_screwf_t *so, ptrdiff_t so_stride) {
  KSL_EACH_OF(n) {
    ksl_hsrainvf_fused(D + i * D_stride, axis + i * axis_stride, so + i * so_stride);
  }
}

static KSL_INLINED void ksl_hsrainvf_fused_planes(ptrdiff_t n, const float *D, ptrdiff_t D_plane,
    ptrdiff_t D_stride, const float *axis, ptrdiff_t axis_plane,
    ptrdiff_t axis_stride, float *so, ptrdiff_t so_plane, ptrdiff_t so_stride) {
  ksl_SE3f_t D_i;
  if (n > 0) D_i = ksl_SE3f_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3f_of_planes(D + i * D_stride, D_plane);
    const ksl_vec3f_t axis_i = ksl_vec3f_of_planes(axis + i * axis_stride, axis_plane);
    ksl_screwf_t so_i;
    ksl_hsrainvf_fused(&D_i, &axis_i, &so_i);
    ksl_screwf_to_planes(&so_i, so + i * so_stride, so_plane);
  }
}

/* ksl_hstainvf_fused of n elements. */
static KSL_INLINED void ksl_hstainvf_fused_many(ptrdiff_t n, const ksl_SE3f_t *D,
    ptrdiff_t D_stride, const ksl_vec3f_t *axis, ptrdiff_t axis_stride,
    ksl_screwf_t *so, ptrdiff_t so_stride) {
  KSL_EACH_OF(n) {
    ksl_hstainvf_fused(D + i * D_stride, axis + i * axis_stride, so + i * so_stride);
  }
}

static KSL_INLINED void ksl_hstainvf_fused_planes(ptrdiff_t n, const float *D, ptrdiff_t D_plane,
    ptrdiff_t D_stride, const float *axis, ptrdiff_t axis_plane,
    ptrdiff_t axis_stride, float *so, ptrdiff_t so_plane, ptrdiff_t so_stride) {
  ksl_SE3f_t D_i;
  if (n > 0) D_i = ksl_SE3f_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3f_of_planes(D + i * D_stride, D_plane);
    const ksl_vec3f_t axis_i = ksl_vec3f_of_planes(axis + i * axis_stride, axis_plane);
    ksl_screwf_t so_i;
    ksl_hstainvf_fused(&D_i, &axis_i, &so_i);
    ksl_screwf_to_planes(&so_i, so + i * so_stride, so_plane);
  }
}

#endif
