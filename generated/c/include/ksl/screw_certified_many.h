/* Made by `coscrew generate`; changes are overwritten. */
/* SPDX-License-Identifier: MIT */
/* coscrew 0.2.0.  Copyright (c) 2026 The coscrew authors. */
/* Screws: twists, spatial velocities and accelerations, s = (v; ω).  Many at a time.
   What arguments are, and what loops over them cost, ksl_planes.h says. */
#ifndef KSL_SCREW_CERTIFIED_MANY_H
#define KSL_SCREW_CERTIFIED_MANY_H

#include "screw_certified.h"
#include "ksl_planes.h"

/* ksl_screw_scale_certified of n elements. */
static KSL_INLINED void ksl_screw_scale_certified_many(ptrdiff_t n, ksl_screw_t *self,
    ptrdiff_t self_stride, const double *a, ptrdiff_t a_stride,
    ksl_screw_t *self_bound, ptrdiff_t self_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_screw_scale_certified(self + i * self_stride, a[i * a_stride],
        self_bound + i * self_bound_stride);
  }
}

static KSL_INLINED void ksl_screw_scale_certified_planes(ptrdiff_t n, double *self,
    ptrdiff_t self_plane, ptrdiff_t self_stride, const double *a,
    ptrdiff_t a_stride, double *self_bound, ptrdiff_t self_bound_plane,
    ptrdiff_t self_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_screw_t self_i = ksl_screw_of_planes(self + i * self_stride, self_plane);
    ksl_screw_t self_bound_i;
    ksl_screw_scale_certified(&self_i, a[i * a_stride], &self_bound_i);
    ksl_screw_to_planes(&self_i, self + i * self_stride, self_plane);
    ksl_screw_to_planes(&self_bound_i, self_bound + i * self_bound_stride, self_bound_plane);
  }
}

/* ksl_axpy_ss_certified of n elements. */
static KSL_INLINED void ksl_axpy_ss_certified_many(ptrdiff_t n, const double *a, ptrdiff_t a_stride,
    const ksl_screw_t *x, ptrdiff_t x_stride, ksl_screw_t *y, ptrdiff_t y_stride,
    ksl_screw_t *y_bound, ptrdiff_t y_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_axpy_ss_certified(a[i * a_stride], x + i * x_stride, y + i * y_stride,
        y_bound + i * y_bound_stride);
  }
}

static KSL_INLINED void ksl_axpy_ss_certified_planes(ptrdiff_t n, const double *a,
    ptrdiff_t a_stride, const double *x, ptrdiff_t x_plane, ptrdiff_t x_stride,
    double *y, ptrdiff_t y_plane, ptrdiff_t y_stride, double *y_bound,
    ptrdiff_t y_bound_plane, ptrdiff_t y_bound_stride) {
  KSL_EACH_OF(n) {
    const ksl_screw_t x_i = ksl_screw_of_planes(x + i * x_stride, x_plane);
    ksl_screw_t y_i = ksl_screw_of_planes(y + i * y_stride, y_plane);
    ksl_screw_t y_bound_i;
    ksl_axpy_ss_certified(a[i * a_stride], &x_i, &y_i, &y_bound_i);
    ksl_screw_to_planes(&y_i, y + i * y_stride, y_plane);
    ksl_screw_to_planes(&y_bound_i, y_bound + i * y_bound_stride, y_bound_plane);
  }
}

/* ksl_xpy_ss_certified of n elements. */
static KSL_INLINED void ksl_xpy_ss_certified_many(ptrdiff_t n, const ksl_screw_t *x,
    ptrdiff_t x_stride, ksl_screw_t *y, ptrdiff_t y_stride, ksl_screw_t *y_bound,
    ptrdiff_t y_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_xpy_ss_certified(x + i * x_stride, y + i * y_stride, y_bound + i * y_bound_stride);
  }
}

static KSL_INLINED void ksl_xpy_ss_certified_planes(ptrdiff_t n, const double *x, ptrdiff_t x_plane,
    ptrdiff_t x_stride, double *y, ptrdiff_t y_plane, ptrdiff_t y_stride,
    double *y_bound, ptrdiff_t y_bound_plane, ptrdiff_t y_bound_stride) {
  ksl_screw_t x_i;
  if (n > 0) x_i = ksl_screw_of_planes(x, x_plane);
  KSL_EACH_OF(n) {
    if (x_stride) x_i = ksl_screw_of_planes(x + i * x_stride, x_plane);
    ksl_screw_t y_i = ksl_screw_of_planes(y + i * y_stride, y_plane);
    ksl_screw_t y_bound_i;
    ksl_xpy_ss_certified(&x_i, &y_i, &y_bound_i);
    ksl_screw_to_planes(&y_i, y + i * y_stride, y_plane);
    ksl_screw_to_planes(&y_bound_i, y_bound + i * y_bound_stride, y_bound_plane);
  }
}

/* ksl_nxpy_ss_certified of n elements. */
static KSL_INLINED void ksl_nxpy_ss_certified_many(ptrdiff_t n, const ksl_screw_t *x,
    ptrdiff_t x_stride, ksl_screw_t *y, ptrdiff_t y_stride, ksl_screw_t *y_bound,
    ptrdiff_t y_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_nxpy_ss_certified(x + i * x_stride, y + i * y_stride, y_bound + i * y_bound_stride);
  }
}

static KSL_INLINED void ksl_nxpy_ss_certified_planes(ptrdiff_t n, const double *x,
    ptrdiff_t x_plane, ptrdiff_t x_stride, double *y, ptrdiff_t y_plane,
    ptrdiff_t y_stride, double *y_bound, ptrdiff_t y_bound_plane,
    ptrdiff_t y_bound_stride) {
  ksl_screw_t x_i;
  if (n > 0) x_i = ksl_screw_of_planes(x, x_plane);
  KSL_EACH_OF(n) {
    if (x_stride) x_i = ksl_screw_of_planes(x + i * x_stride, x_plane);
    ksl_screw_t y_i = ksl_screw_of_planes(y + i * y_stride, y_plane);
    ksl_screw_t y_bound_i;
    ksl_nxpy_ss_certified(&x_i, &y_i, &y_bound_i);
    ksl_screw_to_planes(&y_i, y + i * y_stride, y_plane);
    ksl_screw_to_planes(&y_bound_i, y_bound + i * y_bound_stride, y_bound_plane);
  }
}

/* ksl_product_as_certified of n elements. */
static KSL_INLINED void ksl_product_as_certified_many(ptrdiff_t n, const double *a,
    ptrdiff_t a_stride, const ksl_screw_t *si, ptrdiff_t si_stride,
    ksl_screw_t *so, ptrdiff_t so_stride, ksl_screw_t *so_bound,
    ptrdiff_t so_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_product_as_certified(a[i * a_stride], si + i * si_stride, so + i * so_stride,
        so_bound + i * so_bound_stride);
  }
}

static KSL_INLINED void ksl_product_as_certified_planes(ptrdiff_t n, const double *a,
    ptrdiff_t a_stride, const double *si, ptrdiff_t si_plane,
    ptrdiff_t si_stride, double *so, ptrdiff_t so_plane, ptrdiff_t so_stride,
    double *so_bound, ptrdiff_t so_bound_plane, ptrdiff_t so_bound_stride) {
  KSL_EACH_OF(n) {
    const ksl_screw_t si_i = ksl_screw_of_planes(si + i * si_stride, si_plane);
    ksl_screw_t so_i;
    ksl_screw_t so_bound_i;
    ksl_product_as_certified(a[i * a_stride], &si_i, &so_i, &so_bound_i);
    ksl_screw_to_planes(&so_i, so + i * so_stride, so_plane);
    ksl_screw_to_planes(&so_bound_i, so_bound + i * so_bound_stride, so_bound_plane);
  }
}

/* ksl_add_ss_certified of n elements. */
static KSL_INLINED void ksl_add_ss_certified_many(ptrdiff_t n, const ksl_screw_t *s1,
    ptrdiff_t s1_stride, const ksl_screw_t *s2, ptrdiff_t s2_stride,
    ksl_screw_t *so, ptrdiff_t so_stride, ksl_screw_t *so_bound,
    ptrdiff_t so_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_add_ss_certified(s1 + i * s1_stride, s2 + i * s2_stride, so + i * so_stride,
        so_bound + i * so_bound_stride);
  }
}

static KSL_INLINED void ksl_add_ss_certified_planes(ptrdiff_t n, const double *s1,
    ptrdiff_t s1_plane, ptrdiff_t s1_stride, const double *s2,
    ptrdiff_t s2_plane, ptrdiff_t s2_stride, double *so, ptrdiff_t so_plane,
    ptrdiff_t so_stride, double *so_bound, ptrdiff_t so_bound_plane,
    ptrdiff_t so_bound_stride) {
  ksl_screw_t s1_i;
  if (n > 0) s1_i = ksl_screw_of_planes(s1, s1_plane);
  KSL_EACH_OF(n) {
    if (s1_stride) s1_i = ksl_screw_of_planes(s1 + i * s1_stride, s1_plane);
    const ksl_screw_t s2_i = ksl_screw_of_planes(s2 + i * s2_stride, s2_plane);
    ksl_screw_t so_i;
    ksl_screw_t so_bound_i;
    ksl_add_ss_certified(&s1_i, &s2_i, &so_i, &so_bound_i);
    ksl_screw_to_planes(&so_i, so + i * so_stride, so_plane);
    ksl_screw_to_planes(&so_bound_i, so_bound + i * so_bound_stride, so_bound_plane);
  }
}

/* ksl_subtract_ss_certified of n elements. */
static KSL_INLINED void ksl_subtract_ss_certified_many(ptrdiff_t n, const ksl_screw_t *s1,
    ptrdiff_t s1_stride, const ksl_screw_t *s2, ptrdiff_t s2_stride,
    ksl_screw_t *so, ptrdiff_t so_stride, ksl_screw_t *so_bound,
    ptrdiff_t so_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_subtract_ss_certified(s1 + i * s1_stride, s2 + i * s2_stride, so + i * so_stride,
        so_bound + i * so_bound_stride);
  }
}

static KSL_INLINED void ksl_subtract_ss_certified_planes(ptrdiff_t n, const double *s1,
    ptrdiff_t s1_plane, ptrdiff_t s1_stride, const double *s2,
    ptrdiff_t s2_plane, ptrdiff_t s2_stride, double *so, ptrdiff_t so_plane,
    ptrdiff_t so_stride, double *so_bound, ptrdiff_t so_bound_plane,
    ptrdiff_t so_bound_stride) {
  ksl_screw_t s1_i;
  if (n > 0) s1_i = ksl_screw_of_planes(s1, s1_plane);
  KSL_EACH_OF(n) {
    if (s1_stride) s1_i = ksl_screw_of_planes(s1 + i * s1_stride, s1_plane);
    const ksl_screw_t s2_i = ksl_screw_of_planes(s2 + i * s2_stride, s2_plane);
    ksl_screw_t so_i;
    ksl_screw_t so_bound_i;
    ksl_subtract_ss_certified(&s1_i, &s2_i, &so_i, &so_bound_i);
    ksl_screw_to_planes(&so_i, so + i * so_stride, so_plane);
    ksl_screw_to_planes(&so_bound_i, so_bound + i * so_bound_stride, so_bound_plane);
  }
}

/* ksl_add_sst_certified of n elements. */
static KSL_INLINED void ksl_add_sst_certified_many(ptrdiff_t n, const ksl_screw_t *s1,
    ptrdiff_t s1_stride, const ksl_screw_t *s2, ptrdiff_t s2_stride,
    ksl_screw_t *so, ptrdiff_t so_stride, ksl_screw_t *so_bound,
    ptrdiff_t so_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_add_sst_certified(s1 + i * s1_stride, s2 + i * s2_stride, so + i * so_stride,
        so_bound + i * so_bound_stride);
  }
}

static KSL_INLINED void ksl_add_sst_certified_planes(ptrdiff_t n, const double *s1,
    ptrdiff_t s1_plane, ptrdiff_t s1_stride, const double *s2,
    ptrdiff_t s2_plane, ptrdiff_t s2_stride, double *so, ptrdiff_t so_plane,
    ptrdiff_t so_stride, double *so_bound, ptrdiff_t so_bound_plane,
    ptrdiff_t so_bound_stride) {
  ksl_screw_t s1_i;
  if (n > 0) s1_i = ksl_screw_of_planes(s1, s1_plane);
  KSL_EACH_OF(n) {
    if (s1_stride) s1_i = ksl_screw_of_planes(s1 + i * s1_stride, s1_plane);
    const ksl_screw_t s2_i = ksl_screw_of_planes(s2 + i * s2_stride, s2_plane);
    ksl_screw_t so_i;
    ksl_screw_t so_bound_i;
    ksl_add_sst_certified(&s1_i, &s2_i, &so_i, &so_bound_i);
    ksl_screw_to_planes(&so_i, so + i * so_stride, so_plane);
    ksl_screw_to_planes(&so_bound_i, so_bound + i * so_bound_stride, so_bound_plane);
  }
}

/* ksl_product_Adts_certified of n elements. */
static KSL_INLINED void ksl_product_Adts_certified_many(ptrdiff_t n, const ksl_vec3_t *t,
    ptrdiff_t t_stride, const ksl_screw_t *si, ptrdiff_t si_stride,
    ksl_screw_t *so, ptrdiff_t so_stride, ksl_screw_t *so_bound,
    ptrdiff_t so_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_product_Adts_certified(t + i * t_stride, si + i * si_stride, so + i * so_stride,
        so_bound + i * so_bound_stride);
  }
}

static KSL_INLINED void ksl_product_Adts_certified_planes(ptrdiff_t n, const double *t,
    ptrdiff_t t_plane, ptrdiff_t t_stride, const double *si, ptrdiff_t si_plane,
    ptrdiff_t si_stride, double *so, ptrdiff_t so_plane, ptrdiff_t so_stride,
    double *so_bound, ptrdiff_t so_bound_plane, ptrdiff_t so_bound_stride) {
  ksl_vec3_t t_i;
  if (n > 0) t_i = ksl_vec3_of_planes(t, t_plane);
  KSL_EACH_OF(n) {
    if (t_stride) t_i = ksl_vec3_of_planes(t + i * t_stride, t_plane);
    const ksl_screw_t si_i = ksl_screw_of_planes(si + i * si_stride, si_plane);
    ksl_screw_t so_i;
    ksl_screw_t so_bound_i;
    ksl_product_Adts_certified(&t_i, &si_i, &so_i, &so_bound_i);
    ksl_screw_to_planes(&so_i, so + i * so_stride, so_plane);
    ksl_screw_to_planes(&so_bound_i, so_bound + i * so_bound_stride, so_bound_plane);
  }
}

/* ksl_product_Adtinvs_certified of n elements. */
static KSL_INLINED void ksl_product_Adtinvs_certified_many(ptrdiff_t n, const ksl_vec3_t *t,
    ptrdiff_t t_stride, const ksl_screw_t *si, ptrdiff_t si_stride,
    ksl_screw_t *so, ptrdiff_t so_stride, ksl_screw_t *so_bound,
    ptrdiff_t so_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_product_Adtinvs_certified(t + i * t_stride, si + i * si_stride, so + i * so_stride,
        so_bound + i * so_bound_stride);
  }
}

static KSL_INLINED void ksl_product_Adtinvs_certified_planes(ptrdiff_t n, const double *t,
    ptrdiff_t t_plane, ptrdiff_t t_stride, const double *si, ptrdiff_t si_plane,
    ptrdiff_t si_stride, double *so, ptrdiff_t so_plane, ptrdiff_t so_stride,
    double *so_bound, ptrdiff_t so_bound_plane, ptrdiff_t so_bound_stride) {
  ksl_vec3_t t_i;
  if (n > 0) t_i = ksl_vec3_of_planes(t, t_plane);
  KSL_EACH_OF(n) {
    if (t_stride) t_i = ksl_vec3_of_planes(t + i * t_stride, t_plane);
    const ksl_screw_t si_i = ksl_screw_of_planes(si + i * si_stride, si_plane);
    ksl_screw_t so_i;
    ksl_screw_t so_bound_i;
    ksl_product_Adtinvs_certified(&t_i, &si_i, &so_i, &so_bound_i);
    ksl_screw_to_planes(&so_i, so + i * so_stride, so_plane);
    ksl_screw_to_planes(&so_bound_i, so_bound + i * so_bound_stride, so_bound_plane);
  }
}

/* ksl_product_Adtsinv_certified of n elements. */
static KSL_INLINED void ksl_product_Adtsinv_certified_many(ptrdiff_t n, const ksl_vec3_t *t,
    ptrdiff_t t_stride, const ksl_screw_t *si, ptrdiff_t si_stride,
    ksl_screw_t *so, ptrdiff_t so_stride, ksl_screw_t *so_bound,
    ptrdiff_t so_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_product_Adtsinv_certified(t + i * t_stride, si + i * si_stride, so + i * so_stride,
        so_bound + i * so_bound_stride);
  }
}

static KSL_INLINED void ksl_product_Adtsinv_certified_planes(ptrdiff_t n, const double *t,
    ptrdiff_t t_plane, ptrdiff_t t_stride, const double *si, ptrdiff_t si_plane,
    ptrdiff_t si_stride, double *so, ptrdiff_t so_plane, ptrdiff_t so_stride,
    double *so_bound, ptrdiff_t so_bound_plane, ptrdiff_t so_bound_stride) {
  ksl_vec3_t t_i;
  if (n > 0) t_i = ksl_vec3_of_planes(t, t_plane);
  KSL_EACH_OF(n) {
    if (t_stride) t_i = ksl_vec3_of_planes(t + i * t_stride, t_plane);
    const ksl_screw_t si_i = ksl_screw_of_planes(si + i * si_stride, si_plane);
    ksl_screw_t so_i;
    ksl_screw_t so_bound_i;
    ksl_product_Adtsinv_certified(&t_i, &si_i, &so_i, &so_bound_i);
    ksl_screw_to_planes(&so_i, so + i * so_stride, so_plane);
    ksl_screw_to_planes(&so_bound_i, so_bound + i * so_bound_stride, so_bound_plane);
  }
}

/* ksl_product_Adrs_certified of n elements. */
static KSL_INLINED void ksl_product_Adrs_certified_many(ptrdiff_t n, const ksl_mat3x3_t *R,
    ptrdiff_t R_stride, const ksl_screw_t *si, ptrdiff_t si_stride,
    ksl_screw_t *so, ptrdiff_t so_stride, ksl_screw_t *so_bound,
    ptrdiff_t so_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_product_Adrs_certified(R + i * R_stride, si + i * si_stride, so + i * so_stride,
        so_bound + i * so_bound_stride);
  }
}

static KSL_INLINED void ksl_product_Adrs_certified_planes(ptrdiff_t n, const double *R,
    ptrdiff_t R_plane, ptrdiff_t R_stride, const double *si, ptrdiff_t si_plane,
    ptrdiff_t si_stride, double *so, ptrdiff_t so_plane, ptrdiff_t so_stride,
    double *so_bound, ptrdiff_t so_bound_plane, ptrdiff_t so_bound_stride) {
  ksl_mat3x3_t R_i;
  if (n > 0) R_i = ksl_mat3x3_of_planes(R, R_plane);
  KSL_EACH_OF(n) {
    if (R_stride) R_i = ksl_mat3x3_of_planes(R + i * R_stride, R_plane);
    const ksl_screw_t si_i = ksl_screw_of_planes(si + i * si_stride, si_plane);
    ksl_screw_t so_i;
    ksl_screw_t so_bound_i;
    ksl_product_Adrs_certified(&R_i, &si_i, &so_i, &so_bound_i);
    ksl_screw_to_planes(&so_i, so + i * so_stride, so_plane);
    ksl_screw_to_planes(&so_bound_i, so_bound + i * so_bound_stride, so_bound_plane);
  }
}

/* ksl_product_Adrinvs_certified of n elements. */
static KSL_INLINED void ksl_product_Adrinvs_certified_many(ptrdiff_t n, const ksl_mat3x3_t *R,
    ptrdiff_t R_stride, const ksl_screw_t *si, ptrdiff_t si_stride,
    ksl_screw_t *so, ptrdiff_t so_stride, ksl_screw_t *so_bound,
    ptrdiff_t so_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_product_Adrinvs_certified(R + i * R_stride, si + i * si_stride, so + i * so_stride,
        so_bound + i * so_bound_stride);
  }
}

static KSL_INLINED void ksl_product_Adrinvs_certified_planes(ptrdiff_t n, const double *R,
    ptrdiff_t R_plane, ptrdiff_t R_stride, const double *si, ptrdiff_t si_plane,
    ptrdiff_t si_stride, double *so, ptrdiff_t so_plane, ptrdiff_t so_stride,
    double *so_bound, ptrdiff_t so_bound_plane, ptrdiff_t so_bound_stride) {
  ksl_mat3x3_t R_i;
  if (n > 0) R_i = ksl_mat3x3_of_planes(R, R_plane);
  KSL_EACH_OF(n) {
    if (R_stride) R_i = ksl_mat3x3_of_planes(R + i * R_stride, R_plane);
    const ksl_screw_t si_i = ksl_screw_of_planes(si + i * si_stride, si_plane);
    ksl_screw_t so_i;
    ksl_screw_t so_bound_i;
    ksl_product_Adrinvs_certified(&R_i, &si_i, &so_i, &so_bound_i);
    ksl_screw_to_planes(&so_i, so + i * so_stride, so_plane);
    ksl_screw_to_planes(&so_bound_i, so_bound + i * so_bound_stride, so_bound_plane);
  }
}

/* ksl_product_Adrsinv_certified of n elements. */
static KSL_INLINED void ksl_product_Adrsinv_certified_many(ptrdiff_t n, const ksl_mat3x3_t *R,
    ptrdiff_t R_stride, const ksl_screw_t *si, ptrdiff_t si_stride,
    ksl_screw_t *so, ptrdiff_t so_stride, ksl_screw_t *so_bound,
    ptrdiff_t so_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_product_Adrsinv_certified(R + i * R_stride, si + i * si_stride, so + i * so_stride,
        so_bound + i * so_bound_stride);
  }
}

static KSL_INLINED void ksl_product_Adrsinv_certified_planes(ptrdiff_t n, const double *R,
    ptrdiff_t R_plane, ptrdiff_t R_stride, const double *si, ptrdiff_t si_plane,
    ptrdiff_t si_stride, double *so, ptrdiff_t so_plane, ptrdiff_t so_stride,
    double *so_bound, ptrdiff_t so_bound_plane, ptrdiff_t so_bound_stride) {
  ksl_mat3x3_t R_i;
  if (n > 0) R_i = ksl_mat3x3_of_planes(R, R_plane);
  KSL_EACH_OF(n) {
    if (R_stride) R_i = ksl_mat3x3_of_planes(R + i * R_stride, R_plane);
    const ksl_screw_t si_i = ksl_screw_of_planes(si + i * si_stride, si_plane);
    ksl_screw_t so_i;
    ksl_screw_t so_bound_i;
    ksl_product_Adrsinv_certified(&R_i, &si_i, &so_i, &so_bound_i);
    ksl_screw_to_planes(&so_i, so + i * so_stride, so_plane);
    ksl_screw_to_planes(&so_bound_i, so_bound + i * so_bound_stride, so_bound_plane);
  }
}

/* ksl_product_Ads_certified of n elements. */
static KSL_INLINED void ksl_product_Ads_certified_many(ptrdiff_t n, const ksl_SE3_t *D,
    ptrdiff_t D_stride, const ksl_screw_t *si, ptrdiff_t si_stride,
    ksl_screw_t *so, ptrdiff_t so_stride, ksl_screw_t *so_bound,
    ptrdiff_t so_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_product_Ads_certified(D + i * D_stride, si + i * si_stride, so + i * so_stride,
        so_bound + i * so_bound_stride);
  }
}

static KSL_INLINED void ksl_product_Ads_certified_planes(ptrdiff_t n, const double *D,
    ptrdiff_t D_plane, ptrdiff_t D_stride, const double *si, ptrdiff_t si_plane,
    ptrdiff_t si_stride, double *so, ptrdiff_t so_plane, ptrdiff_t so_stride,
    double *so_bound, ptrdiff_t so_bound_plane, ptrdiff_t so_bound_stride) {
  ksl_SE3_t D_i;
  if (n > 0) D_i = ksl_SE3_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3_of_planes(D + i * D_stride, D_plane);
    const ksl_screw_t si_i = ksl_screw_of_planes(si + i * si_stride, si_plane);
    ksl_screw_t so_i;
    ksl_screw_t so_bound_i;
    ksl_product_Ads_certified(&D_i, &si_i, &so_i, &so_bound_i);
    ksl_screw_to_planes(&so_i, so + i * so_stride, so_plane);
    ksl_screw_to_planes(&so_bound_i, so_bound + i * so_bound_stride, so_bound_plane);
  }
}

/* ksl_product_Adinvs_certified of n elements. */
static KSL_INLINED void ksl_product_Adinvs_certified_many(ptrdiff_t n, const ksl_SE3_t *D,
    ptrdiff_t D_stride, const ksl_screw_t *si, ptrdiff_t si_stride,
    ksl_screw_t *so, ptrdiff_t so_stride, ksl_screw_t *so_bound,
    ptrdiff_t so_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_product_Adinvs_certified(D + i * D_stride, si + i * si_stride, so + i * so_stride,
        so_bound + i * so_bound_stride);
  }
}

static KSL_INLINED void ksl_product_Adinvs_certified_planes(ptrdiff_t n, const double *D,
    ptrdiff_t D_plane, ptrdiff_t D_stride, const double *si, ptrdiff_t si_plane,
    ptrdiff_t si_stride, double *so, ptrdiff_t so_plane, ptrdiff_t so_stride,
    double *so_bound, ptrdiff_t so_bound_plane, ptrdiff_t so_bound_stride) {
  ksl_SE3_t D_i;
  if (n > 0) D_i = ksl_SE3_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3_of_planes(D + i * D_stride, D_plane);
    const ksl_screw_t si_i = ksl_screw_of_planes(si + i * si_stride, si_plane);
    ksl_screw_t so_i;
    ksl_screw_t so_bound_i;
    ksl_product_Adinvs_certified(&D_i, &si_i, &so_i, &so_bound_i);
    ksl_screw_to_planes(&so_i, so + i * so_stride, so_plane);
    ksl_screw_to_planes(&so_bound_i, so_bound + i * so_bound_stride, so_bound_plane);
  }
}

/* ksl_product_Adsinv_certified of n elements. */
static KSL_INLINED void ksl_product_Adsinv_certified_many(ptrdiff_t n, const ksl_SE3_t *D,
    ptrdiff_t D_stride, const ksl_screw_t *si, ptrdiff_t si_stride,
    ksl_screw_t *so, ptrdiff_t so_stride, ksl_screw_t *so_bound,
    ptrdiff_t so_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_product_Adsinv_certified(D + i * D_stride, si + i * si_stride, so + i * so_stride,
        so_bound + i * so_bound_stride);
  }
}

static KSL_INLINED void ksl_product_Adsinv_certified_planes(ptrdiff_t n, const double *D,
    ptrdiff_t D_plane, ptrdiff_t D_stride, const double *si, ptrdiff_t si_plane,
    ptrdiff_t si_stride, double *so, ptrdiff_t so_plane, ptrdiff_t so_stride,
    double *so_bound, ptrdiff_t so_bound_plane, ptrdiff_t so_bound_stride) {
  ksl_SE3_t D_i;
  if (n > 0) D_i = ksl_SE3_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3_of_planes(D + i * D_stride, D_plane);
    const ksl_screw_t si_i = ksl_screw_of_planes(si + i * si_stride, si_plane);
    ksl_screw_t so_i;
    ksl_screw_t so_bound_i;
    ksl_product_Adsinv_certified(&D_i, &si_i, &so_i, &so_bound_i);
    ksl_screw_to_planes(&so_i, so + i * so_stride, so_plane);
    ksl_screw_to_planes(&so_bound_i, so_bound + i * so_bound_stride, so_bound_plane);
  }
}

/* ksl_hsrx_certified of n elements. */
static KSL_INLINED void ksl_hsrx_certified_many(ptrdiff_t n, const ksl_SE3_t *D, ptrdiff_t D_stride,
    ksl_screw_t *so, ptrdiff_t so_stride, ksl_screw_t *so_bound,
    ptrdiff_t so_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_hsrx_certified(D + i * D_stride, so + i * so_stride, so_bound + i * so_bound_stride);
  }
}

static KSL_INLINED void ksl_hsrx_certified_planes(ptrdiff_t n, const double *D, ptrdiff_t D_plane,
    ptrdiff_t D_stride, double *so, ptrdiff_t so_plane, ptrdiff_t so_stride,
    double *so_bound, ptrdiff_t so_bound_plane, ptrdiff_t so_bound_stride) {
  ksl_SE3_t D_i;
  if (n > 0) D_i = ksl_SE3_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3_of_planes(D + i * D_stride, D_plane);
    ksl_screw_t so_i;
    ksl_screw_t so_bound_i;
    ksl_hsrx_certified(&D_i, &so_i, &so_bound_i);
    ksl_screw_to_planes(&so_i, so + i * so_stride, so_plane);
    ksl_screw_to_planes(&so_bound_i, so_bound + i * so_bound_stride, so_bound_plane);
  }
}

/* ksl_hsry_certified of n elements. */
static KSL_INLINED void ksl_hsry_certified_many(ptrdiff_t n, const ksl_SE3_t *D, ptrdiff_t D_stride,
    ksl_screw_t *so, ptrdiff_t so_stride, ksl_screw_t *so_bound,
    ptrdiff_t so_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_hsry_certified(D + i * D_stride, so + i * so_stride, so_bound + i * so_bound_stride);
  }
}

static KSL_INLINED void ksl_hsry_certified_planes(ptrdiff_t n, const double *D, ptrdiff_t D_plane,
    ptrdiff_t D_stride, double *so, ptrdiff_t so_plane, ptrdiff_t so_stride,
    double *so_bound, ptrdiff_t so_bound_plane, ptrdiff_t so_bound_stride) {
  ksl_SE3_t D_i;
  if (n > 0) D_i = ksl_SE3_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3_of_planes(D + i * D_stride, D_plane);
    ksl_screw_t so_i;
    ksl_screw_t so_bound_i;
    ksl_hsry_certified(&D_i, &so_i, &so_bound_i);
    ksl_screw_to_planes(&so_i, so + i * so_stride, so_plane);
    ksl_screw_to_planes(&so_bound_i, so_bound + i * so_bound_stride, so_bound_plane);
  }
}

/* ksl_hsrz_certified of n elements. */
static KSL_INLINED void ksl_hsrz_certified_many(ptrdiff_t n, const ksl_SE3_t *D, ptrdiff_t D_stride,
    ksl_screw_t *so, ptrdiff_t so_stride, ksl_screw_t *so_bound,
    ptrdiff_t so_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_hsrz_certified(D + i * D_stride, so + i * so_stride, so_bound + i * so_bound_stride);
  }
}

static KSL_INLINED void ksl_hsrz_certified_planes(ptrdiff_t n, const double *D, ptrdiff_t D_plane,
    ptrdiff_t D_stride, double *so, ptrdiff_t so_plane, ptrdiff_t so_stride,
    double *so_bound, ptrdiff_t so_bound_plane, ptrdiff_t so_bound_stride) {
  ksl_SE3_t D_i;
  if (n > 0) D_i = ksl_SE3_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3_of_planes(D + i * D_stride, D_plane);
    ksl_screw_t so_i;
    ksl_screw_t so_bound_i;
    ksl_hsrz_certified(&D_i, &so_i, &so_bound_i);
    ksl_screw_to_planes(&so_i, so + i * so_stride, so_plane);
    ksl_screw_to_planes(&so_bound_i, so_bound + i * so_bound_stride, so_bound_plane);
  }
}

/* ksl_hsrxinv_certified of n elements. */
static KSL_INLINED void ksl_hsrxinv_certified_many(ptrdiff_t n, const ksl_SE3_t *D,
    ptrdiff_t D_stride, ksl_screw_t *so, ptrdiff_t so_stride,
    ksl_screw_t *so_bound, ptrdiff_t so_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_hsrxinv_certified(D + i * D_stride, so + i * so_stride, so_bound + i * so_bound_stride);
  }
}

static KSL_INLINED void ksl_hsrxinv_certified_planes(ptrdiff_t n, const double *D,
    ptrdiff_t D_plane, ptrdiff_t D_stride, double *so, ptrdiff_t so_plane,
    ptrdiff_t so_stride, double *so_bound, ptrdiff_t so_bound_plane,
    ptrdiff_t so_bound_stride) {
  ksl_SE3_t D_i;
  if (n > 0) D_i = ksl_SE3_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3_of_planes(D + i * D_stride, D_plane);
    ksl_screw_t so_i;
    ksl_screw_t so_bound_i;
    ksl_hsrxinv_certified(&D_i, &so_i, &so_bound_i);
    ksl_screw_to_planes(&so_i, so + i * so_stride, so_plane);
    ksl_screw_to_planes(&so_bound_i, so_bound + i * so_bound_stride, so_bound_plane);
  }
}

/* ksl_hsryinv_certified of n elements. */
static KSL_INLINED void ksl_hsryinv_certified_many(ptrdiff_t n, const ksl_SE3_t *D,
    ptrdiff_t D_stride, ksl_screw_t *so, ptrdiff_t so_stride,
    ksl_screw_t *so_bound, ptrdiff_t so_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_hsryinv_certified(D + i * D_stride, so + i * so_stride, so_bound + i * so_bound_stride);
  }
}

static KSL_INLINED void ksl_hsryinv_certified_planes(ptrdiff_t n, const double *D,
    ptrdiff_t D_plane, ptrdiff_t D_stride, double *so, ptrdiff_t so_plane,
    ptrdiff_t so_stride, double *so_bound, ptrdiff_t so_bound_plane,
    ptrdiff_t so_bound_stride) {
  ksl_SE3_t D_i;
  if (n > 0) D_i = ksl_SE3_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3_of_planes(D + i * D_stride, D_plane);
    ksl_screw_t so_i;
    ksl_screw_t so_bound_i;
    ksl_hsryinv_certified(&D_i, &so_i, &so_bound_i);
    ksl_screw_to_planes(&so_i, so + i * so_stride, so_plane);
    ksl_screw_to_planes(&so_bound_i, so_bound + i * so_bound_stride, so_bound_plane);
  }
}

/* ksl_hsrzinv_certified of n elements. */
static KSL_INLINED void ksl_hsrzinv_certified_many(ptrdiff_t n, const ksl_SE3_t *D,
    ptrdiff_t D_stride, ksl_screw_t *so, ptrdiff_t so_stride,
    ksl_screw_t *so_bound, ptrdiff_t so_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_hsrzinv_certified(D + i * D_stride, so + i * so_stride, so_bound + i * so_bound_stride);
  }
}

static KSL_INLINED void ksl_hsrzinv_certified_planes(ptrdiff_t n, const double *D,
    ptrdiff_t D_plane, ptrdiff_t D_stride, double *so, ptrdiff_t so_plane,
    ptrdiff_t so_stride, double *so_bound, ptrdiff_t so_bound_plane,
    ptrdiff_t so_bound_stride) {
  ksl_SE3_t D_i;
  if (n > 0) D_i = ksl_SE3_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3_of_planes(D + i * D_stride, D_plane);
    ksl_screw_t so_i;
    ksl_screw_t so_bound_i;
    ksl_hsrzinv_certified(&D_i, &so_i, &so_bound_i);
    ksl_screw_to_planes(&so_i, so + i * so_stride, so_plane);
    ksl_screw_to_planes(&so_bound_i, so_bound + i * so_bound_stride, so_bound_plane);
  }
}

/* ksl_Ad_certified of n elements. */
static KSL_INLINED void ksl_Ad_certified_many(ptrdiff_t n, const ksl_SE3_t *D, ptrdiff_t D_stride,
    ksl_mat6x6_t *M, ptrdiff_t M_stride, ksl_mat6x6_t *M_bound,
    ptrdiff_t M_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_Ad_certified(D + i * D_stride, M + i * M_stride, M_bound + i * M_bound_stride);
  }
}

static KSL_INLINED void ksl_Ad_certified_planes(ptrdiff_t n, const double *D, ptrdiff_t D_plane,
    ptrdiff_t D_stride, double *M, ptrdiff_t M_plane, ptrdiff_t M_stride,
    double *M_bound, ptrdiff_t M_bound_plane, ptrdiff_t M_bound_stride) {
  ksl_SE3_t D_i;
  if (n > 0) D_i = ksl_SE3_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3_of_planes(D + i * D_stride, D_plane);
    ksl_mat6x6_t M_i;
    ksl_mat6x6_t M_bound_i;
    ksl_Ad_certified(&D_i, &M_i, &M_bound_i);
    ksl_mat6x6_to_planes(&M_i, M + i * M_stride, M_plane);
    ksl_mat6x6_to_planes(&M_bound_i, M_bound + i * M_bound_stride, M_bound_plane);
  }
}

/* ksl_dot_cs_certified of n elements. */
static KSL_INLINED void ksl_dot_cs_certified_many(ptrdiff_t n, const ksl_coscrew_t *c,
    ptrdiff_t c_stride, const ksl_screw_t *s, ptrdiff_t s_stride,
    double *power_bound, ptrdiff_t power_bound_stride, double *power,
    ptrdiff_t power_stride) {
  KSL_EACH_OF(n) {
    power[i * power_stride] = ksl_dot_cs_certified(c + i * c_stride, s + i * s_stride,
        power_bound + i * power_bound_stride);
  }
}

static KSL_INLINED void ksl_dot_cs_certified_planes(ptrdiff_t n, const double *c, ptrdiff_t c_plane,
    ptrdiff_t c_stride, const double *s, ptrdiff_t s_plane, ptrdiff_t s_stride,
    double *power_bound, ptrdiff_t power_bound_stride, double *power,
    ptrdiff_t power_stride) {
  ksl_coscrew_t c_i;
  if (n > 0) c_i = ksl_coscrew_of_planes(c, c_plane);
  KSL_EACH_OF(n) {
    if (c_stride) c_i = ksl_coscrew_of_planes(c + i * c_stride, c_plane);
    const ksl_screw_t s_i = ksl_screw_of_planes(s + i * s_stride, s_plane);
    power[i * power_stride] = ksl_dot_cs_certified(&c_i, &s_i, power_bound + i * power_bound_stride);
  }
}

/* ksl_cross_ss_certified of n elements. */
static KSL_INLINED void ksl_cross_ss_certified_many(ptrdiff_t n, const ksl_screw_t *s1,
    ptrdiff_t s1_stride, const ksl_screw_t *s2, ptrdiff_t s2_stride,
    ksl_screw_t *so, ptrdiff_t so_stride, ksl_screw_t *so_bound,
    ptrdiff_t so_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_cross_ss_certified(s1 + i * s1_stride, s2 + i * s2_stride, so + i * so_stride,
        so_bound + i * so_bound_stride);
  }
}

static KSL_INLINED void ksl_cross_ss_certified_planes(ptrdiff_t n, const double *s1,
    ptrdiff_t s1_plane, ptrdiff_t s1_stride, const double *s2,
    ptrdiff_t s2_plane, ptrdiff_t s2_stride, double *so, ptrdiff_t so_plane,
    ptrdiff_t so_stride, double *so_bound, ptrdiff_t so_bound_plane,
    ptrdiff_t so_bound_stride) {
  ksl_screw_t s1_i;
  if (n > 0) s1_i = ksl_screw_of_planes(s1, s1_plane);
  KSL_EACH_OF(n) {
    if (s1_stride) s1_i = ksl_screw_of_planes(s1 + i * s1_stride, s1_plane);
    const ksl_screw_t s2_i = ksl_screw_of_planes(s2 + i * s2_stride, s2_plane);
    ksl_screw_t so_i;
    ksl_screw_t so_bound_i;
    ksl_cross_ss_certified(&s1_i, &s2_i, &so_i, &so_bound_i);
    ksl_screw_to_planes(&so_i, so + i * so_stride, so_plane);
    ksl_screw_to_planes(&so_bound_i, so_bound + i * so_bound_stride, so_bound_plane);
  }
}

/* ksl_cross_sst_certified of n elements. */
static KSL_INLINED void ksl_cross_sst_certified_many(ptrdiff_t n, const ksl_screw_t *s1,
    ptrdiff_t s1_stride, const ksl_screw_t *s2, ptrdiff_t s2_stride,
    ksl_screw_t *so, ptrdiff_t so_stride, ksl_screw_t *so_bound,
    ptrdiff_t so_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_cross_sst_certified(s1 + i * s1_stride, s2 + i * s2_stride, so + i * so_stride,
        so_bound + i * so_bound_stride);
  }
}

static KSL_INLINED void ksl_cross_sst_certified_planes(ptrdiff_t n, const double *s1,
    ptrdiff_t s1_plane, ptrdiff_t s1_stride, const double *s2,
    ptrdiff_t s2_plane, ptrdiff_t s2_stride, double *so, ptrdiff_t so_plane,
    ptrdiff_t so_stride, double *so_bound, ptrdiff_t so_bound_plane,
    ptrdiff_t so_bound_stride) {
  ksl_screw_t s1_i;
  if (n > 0) s1_i = ksl_screw_of_planes(s1, s1_plane);
  KSL_EACH_OF(n) {
    if (s1_stride) s1_i = ksl_screw_of_planes(s1 + i * s1_stride, s1_plane);
    const ksl_screw_t s2_i = ksl_screw_of_planes(s2 + i * s2_stride, s2_plane);
    ksl_screw_t so_i;
    ksl_screw_t so_bound_i;
    ksl_cross_sst_certified(&s1_i, &s2_i, &so_i, &so_bound_i);
    ksl_screw_to_planes(&so_i, so + i * so_stride, so_plane);
    ksl_screw_to_planes(&so_bound_i, so_bound + i * so_bound_stride, so_bound_plane);
  }
}

/* ksl_hsra_certified of n elements. */
static KSL_INLINED void ksl_hsra_certified_many(ptrdiff_t n, const ksl_SE3_t *D, ptrdiff_t D_stride,
    const ksl_vec3_t *axis, ptrdiff_t axis_stride, ksl_screw_t *so,
    ptrdiff_t so_stride, ksl_screw_t *so_bound, ptrdiff_t so_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_hsra_certified(D + i * D_stride, axis + i * axis_stride, so + i * so_stride,
        so_bound + i * so_bound_stride);
  }
}

static KSL_INLINED void ksl_hsra_certified_planes(ptrdiff_t n, const double *D, ptrdiff_t D_plane,
    ptrdiff_t D_stride, const double *axis, ptrdiff_t axis_plane,
    ptrdiff_t axis_stride, double *so, ptrdiff_t so_plane, ptrdiff_t so_stride,
    double *so_bound, ptrdiff_t so_bound_plane, ptrdiff_t so_bound_stride) {
  ksl_SE3_t D_i;
  if (n > 0) D_i = ksl_SE3_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3_of_planes(D + i * D_stride, D_plane);
    const ksl_vec3_t axis_i = ksl_vec3_of_planes(axis + i * axis_stride, axis_plane);
    ksl_screw_t so_i;
    ksl_screw_t so_bound_i;
    ksl_hsra_certified(&D_i, &axis_i, &so_i, &so_bound_i);
    ksl_screw_to_planes(&so_i, so + i * so_stride, so_plane);
    ksl_screw_to_planes(&so_bound_i, so_bound + i * so_bound_stride, so_bound_plane);
  }
}

/* ksl_hsta_certified of n elements. */
static KSL_INLINED void ksl_hsta_certified_many(ptrdiff_t n, const ksl_SE3_t *D, ptrdiff_t D_stride,
    const ksl_vec3_t *axis, ptrdiff_t axis_stride, ksl_screw_t *so,
    ptrdiff_t so_stride, ksl_screw_t *so_bound, ptrdiff_t so_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_hsta_certified(D + i * D_stride, axis + i * axis_stride, so + i * so_stride,
        so_bound + i * so_bound_stride);
  }
}

static KSL_INLINED void ksl_hsta_certified_planes(ptrdiff_t n, const double *D, ptrdiff_t D_plane,
    ptrdiff_t D_stride, const double *axis, ptrdiff_t axis_plane,
    ptrdiff_t axis_stride, double *so, ptrdiff_t so_plane, ptrdiff_t so_stride,
    double *so_bound, ptrdiff_t so_bound_plane, ptrdiff_t so_bound_stride) {
  ksl_SE3_t D_i;
  if (n > 0) D_i = ksl_SE3_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3_of_planes(D + i * D_stride, D_plane);
    const ksl_vec3_t axis_i = ksl_vec3_of_planes(axis + i * axis_stride, axis_plane);
    ksl_screw_t so_i;
    ksl_screw_t so_bound_i;
    ksl_hsta_certified(&D_i, &axis_i, &so_i, &so_bound_i);
    ksl_screw_to_planes(&so_i, so + i * so_stride, so_plane);
    ksl_screw_to_planes(&so_bound_i, so_bound + i * so_bound_stride, so_bound_plane);
  }
}

/* ksl_hsrainv_certified of n elements. */
static KSL_INLINED void ksl_hsrainv_certified_many(ptrdiff_t n, const ksl_SE3_t *D,
    ptrdiff_t D_stride, const ksl_vec3_t *axis, ptrdiff_t axis_stride,
    ksl_screw_t *so, ptrdiff_t so_stride, ksl_screw_t *so_bound,
    ptrdiff_t so_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_hsrainv_certified(D + i * D_stride, axis + i * axis_stride, so + i * so_stride,
        so_bound + i * so_bound_stride);
  }
}

static KSL_INLINED void ksl_hsrainv_certified_planes(ptrdiff_t n, const double *D,
    ptrdiff_t D_plane, ptrdiff_t D_stride, const double *axis,
    ptrdiff_t axis_plane, ptrdiff_t axis_stride, double *so, ptrdiff_t so_plane,
    ptrdiff_t so_stride, double *so_bound, ptrdiff_t so_bound_plane,
    ptrdiff_t so_bound_stride) {
  ksl_SE3_t D_i;
  if (n > 0) D_i = ksl_SE3_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3_of_planes(D + i * D_stride, D_plane);
    const ksl_vec3_t axis_i = ksl_vec3_of_planes(axis + i * axis_stride, axis_plane);
    ksl_screw_t so_i;
    ksl_screw_t so_bound_i;
    ksl_hsrainv_certified(&D_i, &axis_i, &so_i, &so_bound_i);
    ksl_screw_to_planes(&so_i, so + i * so_stride, so_plane);
    ksl_screw_to_planes(&so_bound_i, so_bound + i * so_bound_stride, so_bound_plane);
  }
}

/* ksl_hstainv_certified of n elements. */
static KSL_INLINED void ksl_hstainv_certified_many(ptrdiff_t n, const ksl_SE3_t *D,
    ptrdiff_t D_stride, const ksl_vec3_t *axis, ptrdiff_t axis_stride,
    ksl_screw_t *so, ptrdiff_t so_stride, ksl_screw_t *so_bound,
    ptrdiff_t so_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_hstainv_certified(D + i * D_stride, axis + i * axis_stride, so + i * so_stride,
        so_bound + i * so_bound_stride);
  }
}

static KSL_INLINED void ksl_hstainv_certified_planes(ptrdiff_t n, const double *D,
    ptrdiff_t D_plane, ptrdiff_t D_stride, const double *axis,
    ptrdiff_t axis_plane, ptrdiff_t axis_stride, double *so, ptrdiff_t so_plane,
    ptrdiff_t so_stride, double *so_bound, ptrdiff_t so_bound_plane,
    ptrdiff_t so_bound_stride) {
  ksl_SE3_t D_i;
  if (n > 0) D_i = ksl_SE3_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3_of_planes(D + i * D_stride, D_plane);
    const ksl_vec3_t axis_i = ksl_vec3_of_planes(axis + i * axis_stride, axis_plane);
    ksl_screw_t so_i;
    ksl_screw_t so_bound_i;
    ksl_hstainv_certified(&D_i, &axis_i, &so_i, &so_bound_i);
    ksl_screw_to_planes(&so_i, so + i * so_stride, so_plane);
    ksl_screw_to_planes(&so_bound_i, so_bound + i * so_bound_stride, so_bound_plane);
  }
}

/* ksl_screwf_scale_certified of n elements. */
static KSL_INLINED void ksl_screwf_scale_certified_many(ptrdiff_t n, ksl_screwf_t *self,
    ptrdiff_t self_stride, const float *a, ptrdiff_t a_stride,
    ksl_screwf_t *self_bound, ptrdiff_t self_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_screwf_scale_certified(self + i * self_stride, a[i * a_stride],
        self_bound + i * self_bound_stride);
  }
}

static KSL_INLINED void ksl_screwf_scale_certified_planes(ptrdiff_t n, float *self,
    ptrdiff_t self_plane, ptrdiff_t self_stride, const float *a,
    ptrdiff_t a_stride, float *self_bound, ptrdiff_t self_bound_plane,
    ptrdiff_t self_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_screwf_t self_i = ksl_screwf_of_planes(self + i * self_stride, self_plane);
    ksl_screwf_t self_bound_i;
    ksl_screwf_scale_certified(&self_i, a[i * a_stride], &self_bound_i);
    ksl_screwf_to_planes(&self_i, self + i * self_stride, self_plane);
    ksl_screwf_to_planes(&self_bound_i, self_bound + i * self_bound_stride, self_bound_plane);
  }
}

/* ksl_axpy_ssf_certified of n elements. */
static KSL_INLINED void ksl_axpy_ssf_certified_many(ptrdiff_t n, const float *a, ptrdiff_t a_stride,
    const ksl_screwf_t *x, ptrdiff_t x_stride, ksl_screwf_t *y,
    ptrdiff_t y_stride, ksl_screwf_t *y_bound, ptrdiff_t y_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_axpy_ssf_certified(a[i * a_stride], x + i * x_stride, y + i * y_stride,
        y_bound + i * y_bound_stride);
  }
}

static KSL_INLINED void ksl_axpy_ssf_certified_planes(ptrdiff_t n, const float *a,
    ptrdiff_t a_stride, const float *x, ptrdiff_t x_plane, ptrdiff_t x_stride,
    float *y, ptrdiff_t y_plane, ptrdiff_t y_stride, float *y_bound,
    ptrdiff_t y_bound_plane, ptrdiff_t y_bound_stride) {
  KSL_EACH_OF(n) {
    const ksl_screwf_t x_i = ksl_screwf_of_planes(x + i * x_stride, x_plane);
    ksl_screwf_t y_i = ksl_screwf_of_planes(y + i * y_stride, y_plane);
    ksl_screwf_t y_bound_i;
    ksl_axpy_ssf_certified(a[i * a_stride], &x_i, &y_i, &y_bound_i);
    ksl_screwf_to_planes(&y_i, y + i * y_stride, y_plane);
    ksl_screwf_to_planes(&y_bound_i, y_bound + i * y_bound_stride, y_bound_plane);
  }
}

/* ksl_xpy_ssf_certified of n elements. */
static KSL_INLINED void ksl_xpy_ssf_certified_many(ptrdiff_t n, const ksl_screwf_t *x,
    ptrdiff_t x_stride, ksl_screwf_t *y, ptrdiff_t y_stride,
    ksl_screwf_t *y_bound, ptrdiff_t y_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_xpy_ssf_certified(x + i * x_stride, y + i * y_stride, y_bound + i * y_bound_stride);
  }
}

static KSL_INLINED void ksl_xpy_ssf_certified_planes(ptrdiff_t n, const float *x, ptrdiff_t x_plane,
    ptrdiff_t x_stride, float *y, ptrdiff_t y_plane, ptrdiff_t y_stride,
    float *y_bound, ptrdiff_t y_bound_plane, ptrdiff_t y_bound_stride) {
  ksl_screwf_t x_i;
  if (n > 0) x_i = ksl_screwf_of_planes(x, x_plane);
  KSL_EACH_OF(n) {
    if (x_stride) x_i = ksl_screwf_of_planes(x + i * x_stride, x_plane);
    ksl_screwf_t y_i = ksl_screwf_of_planes(y + i * y_stride, y_plane);
    ksl_screwf_t y_bound_i;
    ksl_xpy_ssf_certified(&x_i, &y_i, &y_bound_i);
    ksl_screwf_to_planes(&y_i, y + i * y_stride, y_plane);
    ksl_screwf_to_planes(&y_bound_i, y_bound + i * y_bound_stride, y_bound_plane);
  }
}

/* ksl_nxpy_ssf_certified of n elements. */
static KSL_INLINED void ksl_nxpy_ssf_certified_many(ptrdiff_t n, const ksl_screwf_t *x,
    ptrdiff_t x_stride, ksl_screwf_t *y, ptrdiff_t y_stride,
    ksl_screwf_t *y_bound, ptrdiff_t y_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_nxpy_ssf_certified(x + i * x_stride, y + i * y_stride, y_bound + i * y_bound_stride);
  }
}

static KSL_INLINED void ksl_nxpy_ssf_certified_planes(ptrdiff_t n, const float *x,
    ptrdiff_t x_plane, ptrdiff_t x_stride, float *y, ptrdiff_t y_plane,
    ptrdiff_t y_stride, float *y_bound, ptrdiff_t y_bound_plane,
    ptrdiff_t y_bound_stride) {
  ksl_screwf_t x_i;
  if (n > 0) x_i = ksl_screwf_of_planes(x, x_plane);
  KSL_EACH_OF(n) {
    if (x_stride) x_i = ksl_screwf_of_planes(x + i * x_stride, x_plane);
    ksl_screwf_t y_i = ksl_screwf_of_planes(y + i * y_stride, y_plane);
    ksl_screwf_t y_bound_i;
    ksl_nxpy_ssf_certified(&x_i, &y_i, &y_bound_i);
    ksl_screwf_to_planes(&y_i, y + i * y_stride, y_plane);
    ksl_screwf_to_planes(&y_bound_i, y_bound + i * y_bound_stride, y_bound_plane);
  }
}

/* ksl_product_asf_certified of n elements. */
static KSL_INLINED void ksl_product_asf_certified_many(ptrdiff_t n, const float *a,
    ptrdiff_t a_stride, const ksl_screwf_t *si, ptrdiff_t si_stride,
    ksl_screwf_t *so, ptrdiff_t so_stride, ksl_screwf_t *so_bound,
    ptrdiff_t so_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_product_asf_certified(a[i * a_stride], si + i * si_stride, so + i * so_stride,
        so_bound + i * so_bound_stride);
  }
}

static KSL_INLINED void ksl_product_asf_certified_planes(ptrdiff_t n, const float *a,
    ptrdiff_t a_stride, const float *si, ptrdiff_t si_plane, ptrdiff_t si_stride,
    float *so, ptrdiff_t so_plane, ptrdiff_t so_stride, float *so_bound,
    ptrdiff_t so_bound_plane, ptrdiff_t so_bound_stride) {
  KSL_EACH_OF(n) {
    const ksl_screwf_t si_i = ksl_screwf_of_planes(si + i * si_stride, si_plane);
    ksl_screwf_t so_i;
    ksl_screwf_t so_bound_i;
    ksl_product_asf_certified(a[i * a_stride], &si_i, &so_i, &so_bound_i);
    ksl_screwf_to_planes(&so_i, so + i * so_stride, so_plane);
    ksl_screwf_to_planes(&so_bound_i, so_bound + i * so_bound_stride, so_bound_plane);
  }
}

/* ksl_add_ssf_certified of n elements. */
static KSL_INLINED void ksl_add_ssf_certified_many(ptrdiff_t n, const ksl_screwf_t *s1,
    ptrdiff_t s1_stride, const ksl_screwf_t *s2, ptrdiff_t s2_stride,
    ksl_screwf_t *so, ptrdiff_t so_stride, ksl_screwf_t *so_bound,
    ptrdiff_t so_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_add_ssf_certified(s1 + i * s1_stride, s2 + i * s2_stride, so + i * so_stride,
        so_bound + i * so_bound_stride);
  }
}

static KSL_INLINED void ksl_add_ssf_certified_planes(ptrdiff_t n, const float *s1,
    ptrdiff_t s1_plane, ptrdiff_t s1_stride, const float *s2, ptrdiff_t s2_plane,
    ptrdiff_t s2_stride, float *so, ptrdiff_t so_plane, ptrdiff_t so_stride,
    float *so_bound, ptrdiff_t so_bound_plane, ptrdiff_t so_bound_stride) {
  ksl_screwf_t s1_i;
  if (n > 0) s1_i = ksl_screwf_of_planes(s1, s1_plane);
  KSL_EACH_OF(n) {
    if (s1_stride) s1_i = ksl_screwf_of_planes(s1 + i * s1_stride, s1_plane);
    const ksl_screwf_t s2_i = ksl_screwf_of_planes(s2 + i * s2_stride, s2_plane);
    ksl_screwf_t so_i;
    ksl_screwf_t so_bound_i;
    ksl_add_ssf_certified(&s1_i, &s2_i, &so_i, &so_bound_i);
    ksl_screwf_to_planes(&so_i, so + i * so_stride, so_plane);
    ksl_screwf_to_planes(&so_bound_i, so_bound + i * so_bound_stride, so_bound_plane);
  }
}

/* ksl_subtract_ssf_certified of n elements. */
static KSL_INLINED void ksl_subtract_ssf_certified_many(ptrdiff_t n, const ksl_screwf_t *s1,
    ptrdiff_t s1_stride, const ksl_screwf_t *s2, ptrdiff_t s2_stride,
    ksl_screwf_t *so, ptrdiff_t so_stride, ksl_screwf_t *so_bound,
    ptrdiff_t so_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_subtract_ssf_certified(s1 + i * s1_stride, s2 + i * s2_stride, so + i * so_stride,
        so_bound + i * so_bound_stride);
  }
}

static KSL_INLINED void ksl_subtract_ssf_certified_planes(ptrdiff_t n, const float *s1,
    ptrdiff_t s1_plane, ptrdiff_t s1_stride, const float *s2, ptrdiff_t s2_plane,
    ptrdiff_t s2_stride, float *so, ptrdiff_t so_plane, ptrdiff_t so_stride,
    float *so_bound, ptrdiff_t so_bound_plane, ptrdiff_t so_bound_stride) {
  ksl_screwf_t s1_i;
  if (n > 0) s1_i = ksl_screwf_of_planes(s1, s1_plane);
  KSL_EACH_OF(n) {
    if (s1_stride) s1_i = ksl_screwf_of_planes(s1 + i * s1_stride, s1_plane);
    const ksl_screwf_t s2_i = ksl_screwf_of_planes(s2 + i * s2_stride, s2_plane);
    ksl_screwf_t so_i;
    ksl_screwf_t so_bound_i;
    ksl_subtract_ssf_certified(&s1_i, &s2_i, &so_i, &so_bound_i);
    ksl_screwf_to_planes(&so_i, so + i * so_stride, so_plane);
    ksl_screwf_to_planes(&so_bound_i, so_bound + i * so_bound_stride, so_bound_plane);
  }
}

/* ksl_add_sstf_certified of n elements. */
static KSL_INLINED void ksl_add_sstf_certified_many(ptrdiff_t n, const ksl_screwf_t *s1,
    ptrdiff_t s1_stride, const ksl_screwf_t *s2, ptrdiff_t s2_stride,
    ksl_screwf_t *so, ptrdiff_t so_stride, ksl_screwf_t *so_bound,
    ptrdiff_t so_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_add_sstf_certified(s1 + i * s1_stride, s2 + i * s2_stride, so + i * so_stride,
        so_bound + i * so_bound_stride);
  }
}

static KSL_INLINED void ksl_add_sstf_certified_planes(ptrdiff_t n, const float *s1,
    ptrdiff_t s1_plane, ptrdiff_t s1_stride, const float *s2, ptrdiff_t s2_plane,
    ptrdiff_t s2_stride, float *so, ptrdiff_t so_plane, ptrdiff_t so_stride,
    float *so_bound, ptrdiff_t so_bound_plane, ptrdiff_t so_bound_stride) {
  ksl_screwf_t s1_i;
  if (n > 0) s1_i = ksl_screwf_of_planes(s1, s1_plane);
  KSL_EACH_OF(n) {
    if (s1_stride) s1_i = ksl_screwf_of_planes(s1 + i * s1_stride, s1_plane);
    const ksl_screwf_t s2_i = ksl_screwf_of_planes(s2 + i * s2_stride, s2_plane);
    ksl_screwf_t so_i;
    ksl_screwf_t so_bound_i;
    ksl_add_sstf_certified(&s1_i, &s2_i, &so_i, &so_bound_i);
    ksl_screwf_to_planes(&so_i, so + i * so_stride, so_plane);
    ksl_screwf_to_planes(&so_bound_i, so_bound + i * so_bound_stride, so_bound_plane);
  }
}

/* ksl_product_Adtsf_certified of n elements. */
static KSL_INLINED void ksl_product_Adtsf_certified_many(ptrdiff_t n, const ksl_vec3f_t *t,
    ptrdiff_t t_stride, const ksl_screwf_t *si, ptrdiff_t si_stride,
    ksl_screwf_t *so, ptrdiff_t so_stride, ksl_screwf_t *so_bound,
    ptrdiff_t so_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_product_Adtsf_certified(t + i * t_stride, si + i * si_stride, so + i * so_stride,
        so_bound + i * so_bound_stride);
  }
}

static KSL_INLINED void ksl_product_Adtsf_certified_planes(ptrdiff_t n, const float *t,
    ptrdiff_t t_plane, ptrdiff_t t_stride, const float *si, ptrdiff_t si_plane,
    ptrdiff_t si_stride, float *so, ptrdiff_t so_plane, ptrdiff_t so_stride,
    float *so_bound, ptrdiff_t so_bound_plane, ptrdiff_t so_bound_stride) {
  ksl_vec3f_t t_i;
  if (n > 0) t_i = ksl_vec3f_of_planes(t, t_plane);
  KSL_EACH_OF(n) {
    if (t_stride) t_i = ksl_vec3f_of_planes(t + i * t_stride, t_plane);
    const ksl_screwf_t si_i = ksl_screwf_of_planes(si + i * si_stride, si_plane);
    ksl_screwf_t so_i;
    ksl_screwf_t so_bound_i;
    ksl_product_Adtsf_certified(&t_i, &si_i, &so_i, &so_bound_i);
    ksl_screwf_to_planes(&so_i, so + i * so_stride, so_plane);
    ksl_screwf_to_planes(&so_bound_i, so_bound + i * so_bound_stride, so_bound_plane);
  }
}

/* ksl_product_Adtinvsf_certified of n elements. */
static KSL_INLINED void ksl_product_Adtinvsf_certified_many(ptrdiff_t n, const ksl_vec3f_t *t,
    ptrdiff_t t_stride, const ksl_screwf_t *si, ptrdiff_t si_stride,
    ksl_screwf_t *so, ptrdiff_t so_stride, ksl_screwf_t *so_bound,
    ptrdiff_t so_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_product_Adtinvsf_certified(t + i * t_stride, si + i * si_stride, so + i * so_stride,
        so_bound + i * so_bound_stride);
  }
}

static KSL_INLINED void ksl_product_Adtinvsf_certified_planes(ptrdiff_t n, const float *t,
    ptrdiff_t t_plane, ptrdiff_t t_stride, const float *si, ptrdiff_t si_plane,
    ptrdiff_t si_stride, float *so, ptrdiff_t so_plane, ptrdiff_t so_stride,
    float *so_bound, ptrdiff_t so_bound_plane, ptrdiff_t so_bound_stride) {
  ksl_vec3f_t t_i;
  if (n > 0) t_i = ksl_vec3f_of_planes(t, t_plane);
  KSL_EACH_OF(n) {
    if (t_stride) t_i = ksl_vec3f_of_planes(t + i * t_stride, t_plane);
    const ksl_screwf_t si_i = ksl_screwf_of_planes(si + i * si_stride, si_plane);
    ksl_screwf_t so_i;
    ksl_screwf_t so_bound_i;
    ksl_product_Adtinvsf_certified(&t_i, &si_i, &so_i, &so_bound_i);
    ksl_screwf_to_planes(&so_i, so + i * so_stride, so_plane);
    ksl_screwf_to_planes(&so_bound_i, so_bound + i * so_bound_stride, so_bound_plane);
  }
}

/* ksl_product_Adtsinvf_certified of n elements. */
static KSL_INLINED void ksl_product_Adtsinvf_certified_many(ptrdiff_t n, const ksl_vec3f_t *t,
    ptrdiff_t t_stride, const ksl_screwf_t *si, ptrdiff_t si_stride,
    ksl_screwf_t *so, ptrdiff_t so_stride, ksl_screwf_t *so_bound,
    ptrdiff_t so_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_product_Adtsinvf_certified(t + i * t_stride, si + i * si_stride, so + i * so_stride,
        so_bound + i * so_bound_stride);
  }
}

static KSL_INLINED void ksl_product_Adtsinvf_certified_planes(ptrdiff_t n, const float *t,
    ptrdiff_t t_plane, ptrdiff_t t_stride, const float *si, ptrdiff_t si_plane,
    ptrdiff_t si_stride, float *so, ptrdiff_t so_plane, ptrdiff_t so_stride,
    float *so_bound, ptrdiff_t so_bound_plane, ptrdiff_t so_bound_stride) {
  ksl_vec3f_t t_i;
  if (n > 0) t_i = ksl_vec3f_of_planes(t, t_plane);
  KSL_EACH_OF(n) {
    if (t_stride) t_i = ksl_vec3f_of_planes(t + i * t_stride, t_plane);
    const ksl_screwf_t si_i = ksl_screwf_of_planes(si + i * si_stride, si_plane);
    ksl_screwf_t so_i;
    ksl_screwf_t so_bound_i;
    ksl_product_Adtsinvf_certified(&t_i, &si_i, &so_i, &so_bound_i);
    ksl_screwf_to_planes(&so_i, so + i * so_stride, so_plane);
    ksl_screwf_to_planes(&so_bound_i, so_bound + i * so_bound_stride, so_bound_plane);
  }
}

/* ksl_product_Adrsf_certified of n elements. */
static KSL_INLINED void ksl_product_Adrsf_certified_many(ptrdiff_t n, const ksl_mat3x3f_t *R,
    ptrdiff_t R_stride, const ksl_screwf_t *si, ptrdiff_t si_stride,
    ksl_screwf_t *so, ptrdiff_t so_stride, ksl_screwf_t *so_bound,
    ptrdiff_t so_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_product_Adrsf_certified(R + i * R_stride, si + i * si_stride, so + i * so_stride,
        so_bound + i * so_bound_stride);
  }
}

static KSL_INLINED void ksl_product_Adrsf_certified_planes(ptrdiff_t n, const float *R,
    ptrdiff_t R_plane, ptrdiff_t R_stride, const float *si, ptrdiff_t si_plane,
    ptrdiff_t si_stride, float *so, ptrdiff_t so_plane, ptrdiff_t so_stride,
    float *so_bound, ptrdiff_t so_bound_plane, ptrdiff_t so_bound_stride) {
  ksl_mat3x3f_t R_i;
  if (n > 0) R_i = ksl_mat3x3f_of_planes(R, R_plane);
  KSL_EACH_OF(n) {
    if (R_stride) R_i = ksl_mat3x3f_of_planes(R + i * R_stride, R_plane);
    const ksl_screwf_t si_i = ksl_screwf_of_planes(si + i * si_stride, si_plane);
    ksl_screwf_t so_i;
    ksl_screwf_t so_bound_i;
    ksl_product_Adrsf_certified(&R_i, &si_i, &so_i, &so_bound_i);
    ksl_screwf_to_planes(&so_i, so + i * so_stride, so_plane);
    ksl_screwf_to_planes(&so_bound_i, so_bound + i * so_bound_stride, so_bound_plane);
  }
}

/* ksl_product_Adrinvsf_certified of n elements. */
static KSL_INLINED void ksl_product_Adrinvsf_certified_many(ptrdiff_t n, const ksl_mat3x3f_t *R,
    ptrdiff_t R_stride, const ksl_screwf_t *si, ptrdiff_t si_stride,
    ksl_screwf_t *so, ptrdiff_t so_stride, ksl_screwf_t *so_bound,
    ptrdiff_t so_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_product_Adrinvsf_certified(R + i * R_stride, si + i * si_stride, so + i * so_stride,
        so_bound + i * so_bound_stride);
  }
}

static KSL_INLINED void ksl_product_Adrinvsf_certified_planes(ptrdiff_t n, const float *R,
    ptrdiff_t R_plane, ptrdiff_t R_stride, const float *si, ptrdiff_t si_plane,
    ptrdiff_t si_stride, float *so, ptrdiff_t so_plane, ptrdiff_t so_stride,
    float *so_bound, ptrdiff_t so_bound_plane, ptrdiff_t so_bound_stride) {
  ksl_mat3x3f_t R_i;
  if (n > 0) R_i = ksl_mat3x3f_of_planes(R, R_plane);
  KSL_EACH_OF(n) {
    if (R_stride) R_i = ksl_mat3x3f_of_planes(R + i * R_stride, R_plane);
    const ksl_screwf_t si_i = ksl_screwf_of_planes(si + i * si_stride, si_plane);
    ksl_screwf_t so_i;
    ksl_screwf_t so_bound_i;
    ksl_product_Adrinvsf_certified(&R_i, &si_i, &so_i, &so_bound_i);
    ksl_screwf_to_planes(&so_i, so + i * so_stride, so_plane);
    ksl_screwf_to_planes(&so_bound_i, so_bound + i * so_bound_stride, so_bound_plane);
  }
}

/* ksl_product_Adrsinvf_certified of n elements. */
static KSL_INLINED void ksl_product_Adrsinvf_certified_many(ptrdiff_t n, const ksl_mat3x3f_t *R,
    ptrdiff_t R_stride, const ksl_screwf_t *si, ptrdiff_t si_stride,
    ksl_screwf_t *so, ptrdiff_t so_stride, ksl_screwf_t *so_bound,
    ptrdiff_t so_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_product_Adrsinvf_certified(R + i * R_stride, si + i * si_stride, so + i * so_stride,
        so_bound + i * so_bound_stride);
  }
}

static KSL_INLINED void ksl_product_Adrsinvf_certified_planes(ptrdiff_t n, const float *R,
    ptrdiff_t R_plane, ptrdiff_t R_stride, const float *si, ptrdiff_t si_plane,
    ptrdiff_t si_stride, float *so, ptrdiff_t so_plane, ptrdiff_t so_stride,
    float *so_bound, ptrdiff_t so_bound_plane, ptrdiff_t so_bound_stride) {
  ksl_mat3x3f_t R_i;
  if (n > 0) R_i = ksl_mat3x3f_of_planes(R, R_plane);
  KSL_EACH_OF(n) {
    if (R_stride) R_i = ksl_mat3x3f_of_planes(R + i * R_stride, R_plane);
    const ksl_screwf_t si_i = ksl_screwf_of_planes(si + i * si_stride, si_plane);
    ksl_screwf_t so_i;
    ksl_screwf_t so_bound_i;
    ksl_product_Adrsinvf_certified(&R_i, &si_i, &so_i, &so_bound_i);
    ksl_screwf_to_planes(&so_i, so + i * so_stride, so_plane);
    ksl_screwf_to_planes(&so_bound_i, so_bound + i * so_bound_stride, so_bound_plane);
  }
}

/* ksl_product_Adsf_certified of n elements. */
static KSL_INLINED void ksl_product_Adsf_certified_many(ptrdiff_t n, const ksl_SE3f_t *D,
    ptrdiff_t D_stride, const ksl_screwf_t *si, ptrdiff_t si_stride,
    ksl_screwf_t *so, ptrdiff_t so_stride, ksl_screwf_t *so_bound,
    ptrdiff_t so_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_product_Adsf_certified(D + i * D_stride, si + i * si_stride, so + i * so_stride,
        so_bound + i * so_bound_stride);
  }
}

static KSL_INLINED void ksl_product_Adsf_certified_planes(ptrdiff_t n, const float *D,
    ptrdiff_t D_plane, ptrdiff_t D_stride, const float *si, ptrdiff_t si_plane,
    ptrdiff_t si_stride, float *so, ptrdiff_t so_plane, ptrdiff_t so_stride,
    float *so_bound, ptrdiff_t so_bound_plane, ptrdiff_t so_bound_stride) {
  ksl_SE3f_t D_i;
  if (n > 0) D_i = ksl_SE3f_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3f_of_planes(D + i * D_stride, D_plane);
    const ksl_screwf_t si_i = ksl_screwf_of_planes(si + i * si_stride, si_plane);
    ksl_screwf_t so_i;
    ksl_screwf_t so_bound_i;
    ksl_product_Adsf_certified(&D_i, &si_i, &so_i, &so_bound_i);
    ksl_screwf_to_planes(&so_i, so + i * so_stride, so_plane);
    ksl_screwf_to_planes(&so_bound_i, so_bound + i * so_bound_stride, so_bound_plane);
  }
}

/* ksl_product_Adinvsf_certified of n elements. */
static KSL_INLINED void ksl_product_Adinvsf_certified_many(ptrdiff_t n, const ksl_SE3f_t *D,
    ptrdiff_t D_stride, const ksl_screwf_t *si, ptrdiff_t si_stride,
    ksl_screwf_t *so, ptrdiff_t so_stride, ksl_screwf_t *so_bound,
    ptrdiff_t so_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_product_Adinvsf_certified(D + i * D_stride, si + i * si_stride, so + i * so_stride,
        so_bound + i * so_bound_stride);
  }
}

static KSL_INLINED void ksl_product_Adinvsf_certified_planes(ptrdiff_t n, const float *D,
    ptrdiff_t D_plane, ptrdiff_t D_stride, const float *si, ptrdiff_t si_plane,
    ptrdiff_t si_stride, float *so, ptrdiff_t so_plane, ptrdiff_t so_stride,
    float *so_bound, ptrdiff_t so_bound_plane, ptrdiff_t so_bound_stride) {
  ksl_SE3f_t D_i;
  if (n > 0) D_i = ksl_SE3f_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3f_of_planes(D + i * D_stride, D_plane);
    const ksl_screwf_t si_i = ksl_screwf_of_planes(si + i * si_stride, si_plane);
    ksl_screwf_t so_i;
    ksl_screwf_t so_bound_i;
    ksl_product_Adinvsf_certified(&D_i, &si_i, &so_i, &so_bound_i);
    ksl_screwf_to_planes(&so_i, so + i * so_stride, so_plane);
    ksl_screwf_to_planes(&so_bound_i, so_bound + i * so_bound_stride, so_bound_plane);
  }
}

/* ksl_product_Adsinvf_certified of n elements. */
static KSL_INLINED void ksl_product_Adsinvf_certified_many(ptrdiff_t n, const ksl_SE3f_t *D,
    ptrdiff_t D_stride, const ksl_screwf_t *si, ptrdiff_t si_stride,
    ksl_screwf_t *so, ptrdiff_t so_stride, ksl_screwf_t *so_bound,
    ptrdiff_t so_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_product_Adsinvf_certified(D + i * D_stride, si + i * si_stride, so + i * so_stride,
        so_bound + i * so_bound_stride);
  }
}

static KSL_INLINED void ksl_product_Adsinvf_certified_planes(ptrdiff_t n, const float *D,
    ptrdiff_t D_plane, ptrdiff_t D_stride, const float *si, ptrdiff_t si_plane,
    ptrdiff_t si_stride, float *so, ptrdiff_t so_plane, ptrdiff_t so_stride,
    float *so_bound, ptrdiff_t so_bound_plane, ptrdiff_t so_bound_stride) {
  ksl_SE3f_t D_i;
  if (n > 0) D_i = ksl_SE3f_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3f_of_planes(D + i * D_stride, D_plane);
    const ksl_screwf_t si_i = ksl_screwf_of_planes(si + i * si_stride, si_plane);
    ksl_screwf_t so_i;
    ksl_screwf_t so_bound_i;
    ksl_product_Adsinvf_certified(&D_i, &si_i, &so_i, &so_bound_i);
    ksl_screwf_to_planes(&so_i, so + i * so_stride, so_plane);
    ksl_screwf_to_planes(&so_bound_i, so_bound + i * so_bound_stride, so_bound_plane);
  }
}

/* ksl_hsrxf_certified of n elements. */
static KSL_INLINED void ksl_hsrxf_certified_many(ptrdiff_t n, const ksl_SE3f_t *D,
    ptrdiff_t D_stride, ksl_screwf_t *so, ptrdiff_t so_stride,
    ksl_screwf_t *so_bound, ptrdiff_t so_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_hsrxf_certified(D + i * D_stride, so + i * so_stride, so_bound + i * so_bound_stride);
  }
}

static KSL_INLINED void ksl_hsrxf_certified_planes(ptrdiff_t n, const float *D, ptrdiff_t D_plane,
    ptrdiff_t D_stride, float *so, ptrdiff_t so_plane, ptrdiff_t so_stride,
    float *so_bound, ptrdiff_t so_bound_plane, ptrdiff_t so_bound_stride) {
  ksl_SE3f_t D_i;
  if (n > 0) D_i = ksl_SE3f_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3f_of_planes(D + i * D_stride, D_plane);
    ksl_screwf_t so_i;
    ksl_screwf_t so_bound_i;
    ksl_hsrxf_certified(&D_i, &so_i, &so_bound_i);
    ksl_screwf_to_planes(&so_i, so + i * so_stride, so_plane);
    ksl_screwf_to_planes(&so_bound_i, so_bound + i * so_bound_stride, so_bound_plane);
  }
}

/* ksl_hsryf_certified of n elements. */
static KSL_INLINED void ksl_hsryf_certified_many(ptrdiff_t n, const ksl_SE3f_t *D,
    ptrdiff_t D_stride, ksl_screwf_t *so, ptrdiff_t so_stride,
    ksl_screwf_t *so_bound, ptrdiff_t so_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_hsryf_certified(D + i * D_stride, so + i * so_stride, so_bound + i * so_bound_stride);
  }
}

static KSL_INLINED void ksl_hsryf_certified_planes(ptrdiff_t n, const float *D, ptrdiff_t D_plane,
    ptrdiff_t D_stride, float *so, ptrdiff_t so_plane, ptrdiff_t so_stride,
    float *so_bound, ptrdiff_t so_bound_plane, ptrdiff_t so_bound_stride) {
  ksl_SE3f_t D_i;
  if (n > 0) D_i = ksl_SE3f_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3f_of_planes(D + i * D_stride, D_plane);
    ksl_screwf_t so_i;
    ksl_screwf_t so_bound_i;
    ksl_hsryf_certified(&D_i, &so_i, &so_bound_i);
    ksl_screwf_to_planes(&so_i, so + i * so_stride, so_plane);
    ksl_screwf_to_planes(&so_bound_i, so_bound + i * so_bound_stride, so_bound_plane);
  }
}

/* ksl_hsrzf_certified of n elements. */
static KSL_INLINED void ksl_hsrzf_certified_many(ptrdiff_t n, const ksl_SE3f_t *D,
    ptrdiff_t D_stride, ksl_screwf_t *so, ptrdiff_t so_stride,
    ksl_screwf_t *so_bound, ptrdiff_t so_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_hsrzf_certified(D + i * D_stride, so + i * so_stride, so_bound + i * so_bound_stride);
  }
}

static KSL_INLINED void ksl_hsrzf_certified_planes(ptrdiff_t n, const float *D, ptrdiff_t D_plane,
    ptrdiff_t D_stride, float *so, ptrdiff_t so_plane, ptrdiff_t so_stride,
    float *so_bound, ptrdiff_t so_bound_plane, ptrdiff_t so_bound_stride) {
  ksl_SE3f_t D_i;
  if (n > 0) D_i = ksl_SE3f_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3f_of_planes(D + i * D_stride, D_plane);
    ksl_screwf_t so_i;
    ksl_screwf_t so_bound_i;
    ksl_hsrzf_certified(&D_i, &so_i, &so_bound_i);
    ksl_screwf_to_planes(&so_i, so + i * so_stride, so_plane);
    ksl_screwf_to_planes(&so_bound_i, so_bound + i * so_bound_stride, so_bound_plane);
  }
}

/* ksl_hsrxinvf_certified of n elements. */
static KSL_INLINED void ksl_hsrxinvf_certified_many(ptrdiff_t n, const ksl_SE3f_t *D,
    ptrdiff_t D_stride, ksl_screwf_t *so, ptrdiff_t so_stride,
    ksl_screwf_t *so_bound, ptrdiff_t so_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_hsrxinvf_certified(D + i * D_stride, so + i * so_stride, so_bound + i * so_bound_stride);
  }
}

static KSL_INLINED void ksl_hsrxinvf_certified_planes(ptrdiff_t n, const float *D,
    ptrdiff_t D_plane, ptrdiff_t D_stride, float *so, ptrdiff_t so_plane,
    ptrdiff_t so_stride, float *so_bound, ptrdiff_t so_bound_plane,
    ptrdiff_t so_bound_stride) {
  ksl_SE3f_t D_i;
  if (n > 0) D_i = ksl_SE3f_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3f_of_planes(D + i * D_stride, D_plane);
    ksl_screwf_t so_i;
    ksl_screwf_t so_bound_i;
    ksl_hsrxinvf_certified(&D_i, &so_i, &so_bound_i);
    ksl_screwf_to_planes(&so_i, so + i * so_stride, so_plane);
    ksl_screwf_to_planes(&so_bound_i, so_bound + i * so_bound_stride, so_bound_plane);
  }
}

/* ksl_hsryinvf_certified of n elements. */
static KSL_INLINED void ksl_hsryinvf_certified_many(ptrdiff_t n, const ksl_SE3f_t *D,
    ptrdiff_t D_stride, ksl_screwf_t *so, ptrdiff_t so_stride,
    ksl_screwf_t *so_bound, ptrdiff_t so_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_hsryinvf_certified(D + i * D_stride, so + i * so_stride, so_bound + i * so_bound_stride);
  }
}

static KSL_INLINED void ksl_hsryinvf_certified_planes(ptrdiff_t n, const float *D,
    ptrdiff_t D_plane, ptrdiff_t D_stride, float *so, ptrdiff_t so_plane,
    ptrdiff_t so_stride, float *so_bound, ptrdiff_t so_bound_plane,
    ptrdiff_t so_bound_stride) {
  ksl_SE3f_t D_i;
  if (n > 0) D_i = ksl_SE3f_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3f_of_planes(D + i * D_stride, D_plane);
    ksl_screwf_t so_i;
    ksl_screwf_t so_bound_i;
    ksl_hsryinvf_certified(&D_i, &so_i, &so_bound_i);
    ksl_screwf_to_planes(&so_i, so + i * so_stride, so_plane);
    ksl_screwf_to_planes(&so_bound_i, so_bound + i * so_bound_stride, so_bound_plane);
  }
}

/* ksl_hsrzinvf_certified of n elements. */
static KSL_INLINED void ksl_hsrzinvf_certified_many(ptrdiff_t n, const ksl_SE3f_t *D,
    ptrdiff_t D_stride, ksl_screwf_t *so, ptrdiff_t so_stride,
    ksl_screwf_t *so_bound, ptrdiff_t so_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_hsrzinvf_certified(D + i * D_stride, so + i * so_stride, so_bound + i * so_bound_stride);
  }
}

static KSL_INLINED void ksl_hsrzinvf_certified_planes(ptrdiff_t n, const float *D,
    ptrdiff_t D_plane, ptrdiff_t D_stride, float *so, ptrdiff_t so_plane,
    ptrdiff_t so_stride, float *so_bound, ptrdiff_t so_bound_plane,
    ptrdiff_t so_bound_stride) {
  ksl_SE3f_t D_i;
  if (n > 0) D_i = ksl_SE3f_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3f_of_planes(D + i * D_stride, D_plane);
    ksl_screwf_t so_i;
    ksl_screwf_t so_bound_i;
    ksl_hsrzinvf_certified(&D_i, &so_i, &so_bound_i);
    ksl_screwf_to_planes(&so_i, so + i * so_stride, so_plane);
    ksl_screwf_to_planes(&so_bound_i, so_bound + i * so_bound_stride, so_bound_plane);
  }
}

/* ksl_Adf_certified of n elements. */
static KSL_INLINED void ksl_Adf_certified_many(ptrdiff_t n, const ksl_SE3f_t *D, ptrdiff_t D_stride,
    ksl_mat6x6f_t *M, ptrdiff_t M_stride, ksl_mat6x6f_t *M_bound,
    ptrdiff_t M_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_Adf_certified(D + i * D_stride, M + i * M_stride, M_bound + i * M_bound_stride);
  }
}

static KSL_INLINED void ksl_Adf_certified_planes(ptrdiff_t n, const float *D, ptrdiff_t D_plane,
    ptrdiff_t D_stride, float *M, ptrdiff_t M_plane, ptrdiff_t M_stride,
    float *M_bound, ptrdiff_t M_bound_plane, ptrdiff_t M_bound_stride) {
  ksl_SE3f_t D_i;
  if (n > 0) D_i = ksl_SE3f_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3f_of_planes(D + i * D_stride, D_plane);
    ksl_mat6x6f_t M_i;
    ksl_mat6x6f_t M_bound_i;
    ksl_Adf_certified(&D_i, &M_i, &M_bound_i);
    ksl_mat6x6f_to_planes(&M_i, M + i * M_stride, M_plane);
    ksl_mat6x6f_to_planes(&M_bound_i, M_bound + i * M_bound_stride, M_bound_plane);
  }
}

/* ksl_dot_csf_certified of n elements. */
static KSL_INLINED void ksl_dot_csf_certified_many(ptrdiff_t n, const ksl_coscrewf_t *c,
    ptrdiff_t c_stride, const ksl_screwf_t *s, ptrdiff_t s_stride,
    float *power_bound, ptrdiff_t power_bound_stride, float *power,
    ptrdiff_t power_stride) {
  KSL_EACH_OF(n) {
    power[i * power_stride] = ksl_dot_csf_certified(c + i * c_stride, s + i * s_stride,
        power_bound + i * power_bound_stride);
  }
}

static KSL_INLINED void ksl_dot_csf_certified_planes(ptrdiff_t n, const float *c, ptrdiff_t c_plane,
    ptrdiff_t c_stride, const float *s, ptrdiff_t s_plane, ptrdiff_t s_stride,
    float *power_bound, ptrdiff_t power_bound_stride, float *power,
    ptrdiff_t power_stride) {
  ksl_coscrewf_t c_i;
  if (n > 0) c_i = ksl_coscrewf_of_planes(c, c_plane);
  KSL_EACH_OF(n) {
    if (c_stride) c_i = ksl_coscrewf_of_planes(c + i * c_stride, c_plane);
    const ksl_screwf_t s_i = ksl_screwf_of_planes(s + i * s_stride, s_plane);
    power[i * power_stride] = ksl_dot_csf_certified(&c_i, &s_i,
        power_bound + i * power_bound_stride);
  }
}

/* ksl_cross_ssf_certified of n elements. */
static KSL_INLINED void ksl_cross_ssf_certified_many(ptrdiff_t n, const ksl_screwf_t *s1,
    ptrdiff_t s1_stride, const ksl_screwf_t *s2, ptrdiff_t s2_stride,
    ksl_screwf_t *so, ptrdiff_t so_stride, ksl_screwf_t *so_bound,
    ptrdiff_t so_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_cross_ssf_certified(s1 + i * s1_stride, s2 + i * s2_stride, so + i * so_stride,
        so_bound + i * so_bound_stride);
  }
}

static KSL_INLINED void ksl_cross_ssf_certified_planes(ptrdiff_t n, const float *s1,
    ptrdiff_t s1_plane, ptrdiff_t s1_stride, const float *s2, ptrdiff_t s2_plane,
    ptrdiff_t s2_stride, float *so, ptrdiff_t so_plane, ptrdiff_t so_stride,
    float *so_bound, ptrdiff_t so_bound_plane, ptrdiff_t so_bound_stride) {
  ksl_screwf_t s1_i;
  if (n > 0) s1_i = ksl_screwf_of_planes(s1, s1_plane);
  KSL_EACH_OF(n) {
    if (s1_stride) s1_i = ksl_screwf_of_planes(s1 + i * s1_stride, s1_plane);
    const ksl_screwf_t s2_i = ksl_screwf_of_planes(s2 + i * s2_stride, s2_plane);
    ksl_screwf_t so_i;
    ksl_screwf_t so_bound_i;
    ksl_cross_ssf_certified(&s1_i, &s2_i, &so_i, &so_bound_i);
    ksl_screwf_to_planes(&so_i, so + i * so_stride, so_plane);
    ksl_screwf_to_planes(&so_bound_i, so_bound + i * so_bound_stride, so_bound_plane);
  }
}

/* ksl_cross_sstf_certified of n elements. */
static KSL_INLINED void ksl_cross_sstf_certified_many(ptrdiff_t n, const ksl_screwf_t *s1,
    ptrdiff_t s1_stride, const ksl_screwf_t *s2, ptrdiff_t s2_stride,
    ksl_screwf_t *so, ptrdiff_t so_stride, ksl_screwf_t *so_bound,
    ptrdiff_t so_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_cross_sstf_certified(s1 + i * s1_stride, s2 + i * s2_stride, so + i * so_stride,
        so_bound + i * so_bound_stride);
  }
}

static KSL_INLINED void ksl_cross_sstf_certified_planes(ptrdiff_t n, const float *s1,
    ptrdiff_t s1_plane, ptrdiff_t s1_stride, const float *s2, ptrdiff_t s2_plane,
    ptrdiff_t s2_stride, float *so, ptrdiff_t so_plane, ptrdiff_t so_stride,
    float *so_bound, ptrdiff_t so_bound_plane, ptrdiff_t so_bound_stride) {
  ksl_screwf_t s1_i;
  if (n > 0) s1_i = ksl_screwf_of_planes(s1, s1_plane);
  KSL_EACH_OF(n) {
    if (s1_stride) s1_i = ksl_screwf_of_planes(s1 + i * s1_stride, s1_plane);
    const ksl_screwf_t s2_i = ksl_screwf_of_planes(s2 + i * s2_stride, s2_plane);
    ksl_screwf_t so_i;
    ksl_screwf_t so_bound_i;
    ksl_cross_sstf_certified(&s1_i, &s2_i, &so_i, &so_bound_i);
    ksl_screwf_to_planes(&so_i, so + i * so_stride, so_plane);
    ksl_screwf_to_planes(&so_bound_i, so_bound + i * so_bound_stride, so_bound_plane);
  }
}

/* ksl_hsraf_certified of n elements. */
static KSL_INLINED void ksl_hsraf_certified_many(ptrdiff_t n, const ksl_SE3f_t *D,
    ptrdiff_t D_stride, const ksl_vec3f_t *axis, ptrdiff_t axis_stride,
    ksl_screwf_t *so, ptrdiff_t so_stride, ksl_screwf_t *so_bound,
    ptrdiff_t so_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_hsraf_certified(D + i * D_stride, axis + i * axis_stride, so + i * so_stride,
        so_bound + i * so_bound_stride);
  }
}

static KSL_INLINED void ksl_hsraf_certified_planes(ptrdiff_t n, const float *D, ptrdiff_t D_plane,
    ptrdiff_t D_stride, const float *axis, ptrdiff_t axis_plane,
    ptrdiff_t axis_stride, float *so, ptrdiff_t so_plane, ptrdiff_t so_stride,
    float *so_bound, ptrdiff_t so_bound_plane, ptrdiff_t so_bound_stride) {
  ksl_SE3f_t D_i;
  if (n > 0) D_i = ksl_SE3f_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3f_of_planes(D + i * D_stride, D_plane);
    const ksl_vec3f_t axis_i = ksl_vec3f_of_planes(axis + i * axis_stride, axis_plane);
    ksl_screwf_t so_i;
    ksl_screwf_t so_bound_i;
    ksl_hsraf_certified(&D_i, &axis_i, &so_i, &so_bound_i);
    ksl_screwf_to_planes(&so_i, so + i * so_stride, so_plane);
    ksl_screwf_to_planes(&so_bound_i, so_bound + i * so_bound_stride, so_bound_plane);
  }
}

/* ksl_hstaf_certified of n elements. */
static KSL_INLINED void ksl_hstaf_certified_many(ptrdiff_t n, const ksl_SE3f_t *D,
    ptrdiff_t D_stride, const ksl_vec3f_t *axis, ptrdiff_t axis_stride,
    ksl_screwf_t *so, ptrdiff_t so_stride, ksl_screwf_t *so_bound,
    ptrdiff_t so_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_hstaf_certified(D + i * D_stride, axis + i * axis_stride, so + i * so_stride,
        so_bound + i * so_bound_stride);
  }
}

static KSL_INLINED void ksl_hstaf_certified_planes(ptrdiff_t n, const float *D, ptrdiff_t D_plane,
    ptrdiff_t D_stride, const float *axis, ptrdiff_t axis_plane,
    ptrdiff_t axis_stride, float *so, ptrdiff_t so_plane, ptrdiff_t so_stride,
    float *so_bound, ptrdiff_t so_bound_plane, ptrdiff_t so_bound_stride) {
  ksl_SE3f_t D_i;
  if (n > 0) D_i = ksl_SE3f_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3f_of_planes(D + i * D_stride, D_plane);
    const ksl_vec3f_t axis_i = ksl_vec3f_of_planes(axis + i * axis_stride, axis_plane);
    ksl_screwf_t so_i;
    ksl_screwf_t so_bound_i;
    ksl_hstaf_certified(&D_i, &axis_i, &so_i, &so_bound_i);
    ksl_screwf_to_planes(&so_i, so + i * so_stride, so_plane);
    ksl_screwf_to_planes(&so_bound_i, so_bound + i * so_bound_stride, so_bound_plane);
  }
}

/* ksl_hsrainvf_certified of n elements. */
static KSL_INLINED void ksl_hsrainvf_certified_many(ptrdiff_t n, const ksl_SE3f_t *D,
    ptrdiff_t D_stride, const ksl_vec3f_t *axis, ptrdiff_t axis_stride,
    ksl_screwf_t *so, ptrdiff_t so_stride, ksl_screwf_t *so_bound,
    ptrdiff_t so_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_hsrainvf_certified(D + i * D_stride, axis + i * axis_stride, so + i * so_stride,
        so_bound + i * so_bound_stride);
  }
}

static KSL_INLINED void ksl_hsrainvf_certified_planes(ptrdiff_t n, const float *D,
    ptrdiff_t D_plane, ptrdiff_t D_stride, const float *axis,
    ptrdiff_t axis_plane, ptrdiff_t axis_stride, float *so, ptrdiff_t so_plane,
    ptrdiff_t so_stride, float *so_bound, ptrdiff_t so_bound_plane,
    ptrdiff_t so_bound_stride) {
  ksl_SE3f_t D_i;
  if (n > 0) D_i = ksl_SE3f_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3f_of_planes(D + i * D_stride, D_plane);
    const ksl_vec3f_t axis_i = ksl_vec3f_of_planes(axis + i * axis_stride, axis_plane);
    ksl_screwf_t so_i;
    ksl_screwf_t so_bound_i;
    ksl_hsrainvf_certified(&D_i, &axis_i, &so_i, &so_bound_i);
    ksl_screwf_to_planes(&so_i, so + i * so_stride, so_plane);
    ksl_screwf_to_planes(&so_bound_i, so_bound + i * so_bound_stride, so_bound_plane);
  }
}

/* ksl_hstainvf_certified of n elements. */
static KSL_INLINED void ksl_hstainvf_certified_many(ptrdiff_t n, const ksl_SE3f_t *D,
    ptrdiff_t D_stride, const ksl_vec3f_t *axis, ptrdiff_t axis_stride,
    ksl_screwf_t *so, ptrdiff_t so_stride, ksl_screwf_t *so_bound,
    ptrdiff_t so_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_hstainvf_certified(D + i * D_stride, axis + i * axis_stride, so + i * so_stride,
        so_bound + i * so_bound_stride);
  }
}

static KSL_INLINED void ksl_hstainvf_certified_planes(ptrdiff_t n, const float *D,
    ptrdiff_t D_plane, ptrdiff_t D_stride, const float *axis,
    ptrdiff_t axis_plane, ptrdiff_t axis_stride, float *so, ptrdiff_t so_plane,
    ptrdiff_t so_stride, float *so_bound, ptrdiff_t so_bound_plane,
    ptrdiff_t so_bound_stride) {
  ksl_SE3f_t D_i;
  if (n > 0) D_i = ksl_SE3f_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3f_of_planes(D + i * D_stride, D_plane);
    const ksl_vec3f_t axis_i = ksl_vec3f_of_planes(axis + i * axis_stride, axis_plane);
    ksl_screwf_t so_i;
    ksl_screwf_t so_bound_i;
    ksl_hstainvf_certified(&D_i, &axis_i, &so_i, &so_bound_i);
    ksl_screwf_to_planes(&so_i, so + i * so_stride, so_plane);
    ksl_screwf_to_planes(&so_bound_i, so_bound + i * so_bound_stride, so_bound_plane);
  }
}

#endif
