/* Made by `coscrew generate`; changes are overwritten. */
/* SPDX-License-Identifier: MIT */
/* coscrew 0.2.0.  Copyright (c) 2026 The coscrew authors. */
/* Screws: twists, spatial velocities and accelerations, s = (v; ω).  Many at a time.
   What arguments are, and what loops over them cost, ksl_planes.h says. */
#ifndef KSL_SCREW_MANY_H
#define KSL_SCREW_MANY_H

#include "screw.h"
#include "ksl_planes.h"

/* ksl_screw_copy of n elements. */
static KSL_INLINED void ksl_screw_copy_many(ptrdiff_t n, const ksl_screw_t *si, ptrdiff_t si_stride,
    ksl_screw_t *so, ptrdiff_t so_stride) {
  KSL_EACH_OF(n) {
    ksl_screw_copy(si + i * si_stride, so + i * so_stride);
  }
}

static KSL_INLINED void ksl_screw_copy_planes(ptrdiff_t n, const double *si, ptrdiff_t si_plane,
    ptrdiff_t si_stride, double *so, ptrdiff_t so_plane, ptrdiff_t so_stride) {
  ksl_screw_t si_i;
  if (n > 0) si_i = ksl_screw_of_planes(si, si_plane);
  KSL_EACH_OF(n) {
    if (si_stride) si_i = ksl_screw_of_planes(si + i * si_stride, si_plane);
    ksl_screw_t so_i;
    ksl_screw_copy(&si_i, &so_i);
    ksl_screw_to_planes(&so_i, so + i * so_stride, so_plane);
  }
}

/* ksl_screw_scale of n elements. */
static KSL_INLINED void ksl_screw_scale_many(ptrdiff_t n, ksl_screw_t *self, ptrdiff_t self_stride,
    const double *a, ptrdiff_t a_stride) {
  KSL_EACH_OF(n) {
    ksl_screw_scale(self + i * self_stride, a[i * a_stride]);
  }
}

static KSL_INLINED void ksl_screw_scale_planes(ptrdiff_t n, double *self, ptrdiff_t self_plane,
    ptrdiff_t self_stride, const double *a, ptrdiff_t a_stride) {
  KSL_EACH_OF(n) {
    ksl_screw_t self_i = ksl_screw_of_planes(self + i * self_stride, self_plane);
    ksl_screw_scale(&self_i, a[i * a_stride]);
    ksl_screw_to_planes(&self_i, self + i * self_stride, self_plane);
  }
}

/* ksl_screw_inverted of n elements. */
static KSL_INLINED void ksl_screw_inverted_many(ptrdiff_t n, const ksl_screw_t *si,
    ptrdiff_t si_stride, ksl_screw_t *so, ptrdiff_t so_stride) {
  KSL_EACH_OF(n) {
    ksl_screw_inverted(si + i * si_stride, so + i * so_stride);
  }
}

static KSL_INLINED void ksl_screw_inverted_planes(ptrdiff_t n, const double *si, ptrdiff_t si_plane,
    ptrdiff_t si_stride, double *so, ptrdiff_t so_plane, ptrdiff_t so_stride) {
  ksl_screw_t si_i;
  if (n > 0) si_i = ksl_screw_of_planes(si, si_plane);
  KSL_EACH_OF(n) {
    if (si_stride) si_i = ksl_screw_of_planes(si + i * si_stride, si_plane);
    ksl_screw_t so_i;
    ksl_screw_inverted(&si_i, &so_i);
    ksl_screw_to_planes(&so_i, so + i * so_stride, so_plane);
  }
}

/* ksl_screw_invert of n elements. */
static KSL_INLINED void ksl_screw_invert_many(ptrdiff_t n, ksl_screw_t *self, ptrdiff_t self_stride) {
  KSL_EACH_OF(n) {
    ksl_screw_invert(self + i * self_stride);
  }
}

static KSL_INLINED void ksl_screw_invert_planes(ptrdiff_t n, double *self, ptrdiff_t self_plane,
    ptrdiff_t self_stride) {
  KSL_EACH_OF(n) {
    ksl_screw_t self_i = ksl_screw_of_planes(self + i * self_stride, self_plane);
    ksl_screw_invert(&self_i);
    ksl_screw_to_planes(&self_i, self + i * self_stride, self_plane);
  }
}

/* ksl_axpy_ss of n elements. */
static KSL_INLINED void ksl_axpy_ss_many(ptrdiff_t n, const double *a, ptrdiff_t a_stride,
    const ksl_screw_t *x, ptrdiff_t x_stride, ksl_screw_t *y, ptrdiff_t y_stride) {
  KSL_EACH_OF(n) {
    ksl_axpy_ss(a[i * a_stride], x + i * x_stride, y + i * y_stride);
  }
}

static KSL_INLINED void ksl_axpy_ss_planes(ptrdiff_t n, const double *a, ptrdiff_t a_stride,
    const double *x, ptrdiff_t x_plane, ptrdiff_t x_stride, double *y,
    ptrdiff_t y_plane, ptrdiff_t y_stride) {
  KSL_EACH_OF(n) {
    const ksl_screw_t x_i = ksl_screw_of_planes(x + i * x_stride, x_plane);
    ksl_screw_t y_i = ksl_screw_of_planes(y + i * y_stride, y_plane);
    ksl_axpy_ss(a[i * a_stride], &x_i, &y_i);
    ksl_screw_to_planes(&y_i, y + i * y_stride, y_plane);
  }
}

/* ksl_xpy_ss of n elements. */
static KSL_INLINED void ksl_xpy_ss_many(ptrdiff_t n, const ksl_screw_t *x, ptrdiff_t x_stride,
    ksl_screw_t *y, ptrdiff_t y_stride) {
  KSL_EACH_OF(n) {
    ksl_xpy_ss(x + i * x_stride, y + i * y_stride);
  }
}

static KSL_INLINED void ksl_xpy_ss_planes(ptrdiff_t n, const double *x, ptrdiff_t x_plane,
    ptrdiff_t x_stride, double *y, ptrdiff_t y_plane, ptrdiff_t y_stride) {
  ksl_screw_t x_i;
  if (n > 0) x_i = ksl_screw_of_planes(x, x_plane);
  KSL_EACH_OF(n) {
    if (x_stride) x_i = ksl_screw_of_planes(x + i * x_stride, x_plane);
    ksl_screw_t y_i = ksl_screw_of_planes(y + i * y_stride, y_plane);
    ksl_xpy_ss(&x_i, &y_i);
    ksl_screw_to_planes(&y_i, y + i * y_stride, y_plane);
  }
}

/* ksl_nxpy_ss of n elements. */
static KSL_INLINED void ksl_nxpy_ss_many(ptrdiff_t n, const ksl_screw_t *x, ptrdiff_t x_stride,
    ksl_screw_t *y, ptrdiff_t y_stride) {
  KSL_EACH_OF(n) {
    ksl_nxpy_ss(x + i * x_stride, y + i * y_stride);
  }
}

static KSL_INLINED void ksl_nxpy_ss_planes(ptrdiff_t n, const double *x, ptrdiff_t x_plane,
    ptrdiff_t x_stride, double *y, ptrdiff_t y_plane, ptrdiff_t y_stride) {
  ksl_screw_t x_i;
  if (n > 0) x_i = ksl_screw_of_planes(x, x_plane);
  KSL_EACH_OF(n) {
    if (x_stride) x_i = ksl_screw_of_planes(x + i * x_stride, x_plane);
    ksl_screw_t y_i = ksl_screw_of_planes(y + i * y_stride, y_plane);
    ksl_nxpy_ss(&x_i, &y_i);
    ksl_screw_to_planes(&y_i, y + i * y_stride, y_plane);
  }
}

/* ksl_product_as of n elements. */
static KSL_INLINED void ksl_product_as_many(ptrdiff_t n, const double *a, ptrdiff_t a_stride,
    const ksl_screw_t *si, ptrdiff_t si_stride, ksl_screw_t *so,
    ptrdiff_t so_stride) {
  KSL_EACH_OF(n) {
    ksl_product_as(a[i * a_stride], si + i * si_stride, so + i * so_stride);
  }
}

static KSL_INLINED void ksl_product_as_planes(ptrdiff_t n, const double *a, ptrdiff_t a_stride,
    const double *si, ptrdiff_t si_plane, ptrdiff_t si_stride, double *so,
    ptrdiff_t so_plane, ptrdiff_t so_stride) {
  KSL_EACH_OF(n) {
    const ksl_screw_t si_i = ksl_screw_of_planes(si + i * si_stride, si_plane);
    ksl_screw_t so_i;
    ksl_product_as(a[i * a_stride], &si_i, &so_i);
    ksl_screw_to_planes(&so_i, so + i * so_stride, so_plane);
  }
}

/* ksl_add_ss of n elements. */
static KSL_INLINED void ksl_add_ss_many(ptrdiff_t n, const ksl_screw_t *s1, ptrdiff_t s1_stride,
    const ksl_screw_t *s2, ptrdiff_t s2_stride, ksl_screw_t *so,
    ptrdiff_t so_stride) {
  KSL_EACH_OF(n) {
    ksl_add_ss(s1 + i * s1_stride, s2 + i * s2_stride, so + i * so_stride);
  }
}

static KSL_INLINED void ksl_add_ss_planes(ptrdiff_t n, const double *s1, ptrdiff_t s1_plane,
    ptrdiff_t s1_stride, const double *s2, ptrdiff_t s2_plane,
    ptrdiff_t s2_stride, double *so, ptrdiff_t so_plane, ptrdiff_t so_stride) {
  ksl_screw_t s1_i;
  if (n > 0) s1_i = ksl_screw_of_planes(s1, s1_plane);
  KSL_EACH_OF(n) {
    if (s1_stride) s1_i = ksl_screw_of_planes(s1 + i * s1_stride, s1_plane);
    const ksl_screw_t s2_i = ksl_screw_of_planes(s2 + i * s2_stride, s2_plane);
    ksl_screw_t so_i;
    ksl_add_ss(&s1_i, &s2_i, &so_i);
    ksl_screw_to_planes(&so_i, so + i * so_stride, so_plane);
  }
}

/* ksl_subtract_ss of n elements. */
static KSL_INLINED void ksl_subtract_ss_many(ptrdiff_t n, const ksl_screw_t *s1,
    ptrdiff_t s1_stride, const ksl_screw_t *s2, ptrdiff_t s2_stride,
    ksl_screw_t *so, ptrdiff_t so_stride) {
  KSL_EACH_OF(n) {
    ksl_subtract_ss(s1 + i * s1_stride, s2 + i * s2_stride, so + i * so_stride);
  }
}

static KSL_INLINED void ksl_subtract_ss_planes(ptrdiff_t n, const double *s1, ptrdiff_t s1_plane,
    ptrdiff_t s1_stride, const double *s2, ptrdiff_t s2_plane,
    ptrdiff_t s2_stride, double *so, ptrdiff_t so_plane, ptrdiff_t so_stride) {
  ksl_screw_t s1_i;
  if (n > 0) s1_i = ksl_screw_of_planes(s1, s1_plane);
  KSL_EACH_OF(n) {
    if (s1_stride) s1_i = ksl_screw_of_planes(s1 + i * s1_stride, s1_plane);
    const ksl_screw_t s2_i = ksl_screw_of_planes(s2 + i * s2_stride, s2_plane);
    ksl_screw_t so_i;
    ksl_subtract_ss(&s1_i, &s2_i, &so_i);
    ksl_screw_to_planes(&so_i, so + i * so_stride, so_plane);
  }
}

/* ksl_screw_norm of n elements. */
static KSL_INLINED void ksl_screw_norm_many(ptrdiff_t n, const ksl_screw_t *si, ptrdiff_t si_stride,
    double *norm, ptrdiff_t norm_stride) {
  KSL_EACH_OF(n) {
    norm[i * norm_stride] = ksl_screw_norm(si + i * si_stride);
  }
}

static KSL_INLINED void ksl_screw_norm_planes(ptrdiff_t n, const double *si, ptrdiff_t si_plane,
    ptrdiff_t si_stride, double *norm, ptrdiff_t norm_stride) {
  ksl_screw_t si_i;
  if (n > 0) si_i = ksl_screw_of_planes(si, si_plane);
  KSL_EACH_OF(n) {
    if (si_stride) si_i = ksl_screw_of_planes(si + i * si_stride, si_plane);
    norm[i * norm_stride] = ksl_screw_norm(&si_i);
  }
}

/* ksl_screw_normalize of n elements. */
static KSL_INLINED void ksl_screw_normalize_many(ptrdiff_t n, ksl_screw_t *self,
    ptrdiff_t self_stride) {
  KSL_EACH_OF(n) {
    ksl_screw_normalize(self + i * self_stride);
  }
}

static KSL_INLINED void ksl_screw_normalize_planes(ptrdiff_t n, double *self, ptrdiff_t self_plane,
    ptrdiff_t self_stride) {
  KSL_EACH_OF(n) {
    ksl_screw_t self_i = ksl_screw_of_planes(self + i * self_stride, self_plane);
    ksl_screw_normalize(&self_i);
    ksl_screw_to_planes(&self_i, self + i * self_stride, self_plane);
  }
}

/* ksl_screw_normalized of n elements. */
static KSL_INLINED void ksl_screw_normalized_many(ptrdiff_t n, const ksl_screw_t *si,
    ptrdiff_t si_stride, ksl_screw_t *so, ptrdiff_t so_stride) {
  KSL_EACH_OF(n) {
    ksl_screw_normalized(si + i * si_stride, so + i * so_stride);
  }
}

static KSL_INLINED void ksl_screw_normalized_planes(ptrdiff_t n, const double *si,
    ptrdiff_t si_plane, ptrdiff_t si_stride, double *so, ptrdiff_t so_plane,
    ptrdiff_t so_stride) {
  ksl_screw_t si_i;
  if (n > 0) si_i = ksl_screw_of_planes(si, si_plane);
  KSL_EACH_OF(n) {
    if (si_stride) si_i = ksl_screw_of_planes(si + i * si_stride, si_plane);
    ksl_screw_t so_i;
    ksl_screw_normalized(&si_i, &so_i);
    ksl_screw_to_planes(&so_i, so + i * so_stride, so_plane);
  }
}

/* ksl_screw_from_lin_ang of n elements. */
static KSL_INLINED void ksl_screw_from_lin_ang_many(ptrdiff_t n, const ksl_vec3_t *lin,
    ptrdiff_t lin_stride, const ksl_vec3_t *ang, ptrdiff_t ang_stride,
    ksl_screw_t *so, ptrdiff_t so_stride) {
  KSL_EACH_OF(n) {
    ksl_screw_from_lin_ang(lin + i * lin_stride, ang + i * ang_stride, so + i * so_stride);
  }
}

static KSL_INLINED void ksl_screw_from_lin_ang_planes(ptrdiff_t n, const double *lin,
    ptrdiff_t lin_plane, ptrdiff_t lin_stride, const double *ang,
    ptrdiff_t ang_plane, ptrdiff_t ang_stride, double *so, ptrdiff_t so_plane,
    ptrdiff_t so_stride) {
  ksl_vec3_t lin_i;
  if (n > 0) lin_i = ksl_vec3_of_planes(lin, lin_plane);
  KSL_EACH_OF(n) {
    if (lin_stride) lin_i = ksl_vec3_of_planes(lin + i * lin_stride, lin_plane);
    const ksl_vec3_t ang_i = ksl_vec3_of_planes(ang + i * ang_stride, ang_plane);
    ksl_screw_t so_i;
    ksl_screw_from_lin_ang(&lin_i, &ang_i, &so_i);
    ksl_screw_to_planes(&so_i, so + i * so_stride, so_plane);
  }
}

/* ksl_screw_to_angular_first of n elements. */
static KSL_INLINED void ksl_screw_to_angular_first_many(ptrdiff_t n, const ksl_screw_t *si,
    ptrdiff_t si_stride, double *x, ptrdiff_t x_stride) {
  KSL_EACH_OF(n) {
    ksl_screw_to_angular_first(si + i * si_stride, x + 6 * i * x_stride);
  }
}

static KSL_INLINED void ksl_screw_to_angular_first_planes(ptrdiff_t n, const double *si,
    ptrdiff_t si_plane, ptrdiff_t si_stride, double *x, ptrdiff_t x_plane,
    ptrdiff_t x_stride) {
  ksl_screw_t si_i;
  if (n > 0) si_i = ksl_screw_of_planes(si, si_plane);
  KSL_EACH_OF(n) {
    if (si_stride) si_i = ksl_screw_of_planes(si + i * si_stride, si_plane);
    double x_i[6];
    ksl_screw_to_angular_first(&si_i, x_i);
    x[0 + i * x_stride] = x_i[0];
    x[x_plane + i * x_stride] = x_i[1];
    x[2 * x_plane + i * x_stride] = x_i[2];
    x[3 * x_plane + i * x_stride] = x_i[3];
    x[4 * x_plane + i * x_stride] = x_i[4];
    x[5 * x_plane + i * x_stride] = x_i[5];
  }
}

/* ksl_screw_from_angular_first of n elements. */
static KSL_INLINED void ksl_screw_from_angular_first_many(ptrdiff_t n, const double *x,
    ptrdiff_t x_stride, ksl_screw_t *so, ptrdiff_t so_stride) {
  KSL_EACH_OF(n) {
    ksl_screw_from_angular_first(x + 6 * i * x_stride, so + i * so_stride);
  }
}

static KSL_INLINED void ksl_screw_from_angular_first_planes(ptrdiff_t n, const double *x,
    ptrdiff_t x_plane, ptrdiff_t x_stride, double *so, ptrdiff_t so_plane,
    ptrdiff_t so_stride) {
  KSL_EACH_OF(n) {
    const double x_i[6] = {x[0 + i * x_stride], x[x_plane + i * x_stride],
        x[2 * x_plane + i * x_stride], x[3 * x_plane + i * x_stride], x[4 * x_plane + i * x_stride],
        x[5 * x_plane + i * x_stride]};
    ksl_screw_t so_i;
    ksl_screw_from_angular_first(x_i, &so_i);
    ksl_screw_to_planes(&so_i, so + i * so_stride, so_plane);
  }
}

/* ksl_add_sst of n elements. */
static KSL_INLINED void ksl_add_sst_many(ptrdiff_t n, const ksl_screw_t *s1, ptrdiff_t s1_stride,
    const ksl_screw_t *s2, ptrdiff_t s2_stride, ksl_screw_t *so,
    ptrdiff_t so_stride) {
  KSL_EACH_OF(n) {
    ksl_add_sst(s1 + i * s1_stride, s2 + i * s2_stride, so + i * so_stride);
  }
}

static KSL_INLINED void ksl_add_sst_planes(ptrdiff_t n, const double *s1, ptrdiff_t s1_plane,
    ptrdiff_t s1_stride, const double *s2, ptrdiff_t s2_plane,
    ptrdiff_t s2_stride, double *so, ptrdiff_t so_plane, ptrdiff_t so_stride) {
  ksl_screw_t s1_i;
  if (n > 0) s1_i = ksl_screw_of_planes(s1, s1_plane);
  KSL_EACH_OF(n) {
    if (s1_stride) s1_i = ksl_screw_of_planes(s1 + i * s1_stride, s1_plane);
    const ksl_screw_t s2_i = ksl_screw_of_planes(s2 + i * s2_stride, s2_plane);
    ksl_screw_t so_i;
    ksl_add_sst(&s1_i, &s2_i, &so_i);
    ksl_screw_to_planes(&so_i, so + i * so_stride, so_plane);
  }
}

/* ksl_product_Adts of n elements. */
static KSL_INLINED void ksl_product_Adts_many(ptrdiff_t n, const ksl_vec3_t *t, ptrdiff_t t_stride,
    const ksl_screw_t *si, ptrdiff_t si_stride, ksl_screw_t *so,
    ptrdiff_t so_stride) {
  KSL_EACH_OF(n) {
    ksl_product_Adts(t + i * t_stride, si + i * si_stride, so + i * so_stride);
  }
}

static KSL_INLINED void ksl_product_Adts_planes(ptrdiff_t n, const double *t, ptrdiff_t t_plane,
    ptrdiff_t t_stride, const double *si, ptrdiff_t si_plane,
    ptrdiff_t si_stride, double *so, ptrdiff_t so_plane, ptrdiff_t so_stride) {
  ksl_vec3_t t_i;
  if (n > 0) t_i = ksl_vec3_of_planes(t, t_plane);
  KSL_EACH_OF(n) {
    if (t_stride) t_i = ksl_vec3_of_planes(t + i * t_stride, t_plane);
    const ksl_screw_t si_i = ksl_screw_of_planes(si + i * si_stride, si_plane);
    ksl_screw_t so_i;
    ksl_product_Adts(&t_i, &si_i, &so_i);
    ksl_screw_to_planes(&so_i, so + i * so_stride, so_plane);
  }
}

/* ksl_product_Adtinvs of n elements. */
static KSL_INLINED void ksl_product_Adtinvs_many(ptrdiff_t n, const ksl_vec3_t *t,
    ptrdiff_t t_stride, const ksl_screw_t *si, ptrdiff_t si_stride,
    ksl_screw_t *so, ptrdiff_t so_stride) {
  KSL_EACH_OF(n) {
    ksl_product_Adtinvs(t + i * t_stride, si + i * si_stride, so + i * so_stride);
  }
}

static KSL_INLINED void ksl_product_Adtinvs_planes(ptrdiff_t n, const double *t, ptrdiff_t t_plane,
    ptrdiff_t t_stride, const double *si, ptrdiff_t si_plane,
    ptrdiff_t si_stride, double *so, ptrdiff_t so_plane, ptrdiff_t so_stride) {
  ksl_vec3_t t_i;
  if (n > 0) t_i = ksl_vec3_of_planes(t, t_plane);
  KSL_EACH_OF(n) {
    if (t_stride) t_i = ksl_vec3_of_planes(t + i * t_stride, t_plane);
    const ksl_screw_t si_i = ksl_screw_of_planes(si + i * si_stride, si_plane);
    ksl_screw_t so_i;
    ksl_product_Adtinvs(&t_i, &si_i, &so_i);
    ksl_screw_to_planes(&so_i, so + i * so_stride, so_plane);
  }
}

/* ksl_product_Adtsinv of n elements. */
static KSL_INLINED void ksl_product_Adtsinv_many(ptrdiff_t n, const ksl_vec3_t *t,
    ptrdiff_t t_stride, const ksl_screw_t *si, ptrdiff_t si_stride,
    ksl_screw_t *so, ptrdiff_t so_stride) {
  KSL_EACH_OF(n) {
    ksl_product_Adtsinv(t + i * t_stride, si + i * si_stride, so + i * so_stride);
  }
}

static KSL_INLINED void ksl_product_Adtsinv_planes(ptrdiff_t n, const double *t, ptrdiff_t t_plane,
    ptrdiff_t t_stride, const double *si, ptrdiff_t si_plane,
    ptrdiff_t si_stride, double *so, ptrdiff_t so_plane, ptrdiff_t so_stride) {
  ksl_vec3_t t_i;
  if (n > 0) t_i = ksl_vec3_of_planes(t, t_plane);
  KSL_EACH_OF(n) {
    if (t_stride) t_i = ksl_vec3_of_planes(t + i * t_stride, t_plane);
    const ksl_screw_t si_i = ksl_screw_of_planes(si + i * si_stride, si_plane);
    ksl_screw_t so_i;
    ksl_product_Adtsinv(&t_i, &si_i, &so_i);
    ksl_screw_to_planes(&so_i, so + i * so_stride, so_plane);
  }
}

/* ksl_product_Adrs of n elements. */
static KSL_INLINED void ksl_product_Adrs_many(ptrdiff_t n, const ksl_mat3x3_t *R,
    ptrdiff_t R_stride, const ksl_screw_t *si, ptrdiff_t si_stride,
    ksl_screw_t *so, ptrdiff_t so_stride) {
  KSL_EACH_OF(n) {
    ksl_product_Adrs(R + i * R_stride, si + i * si_stride, so + i * so_stride);
  }
}

static KSL_INLINED void ksl_product_Adrs_planes(ptrdiff_t n, const double *R, ptrdiff_t R_plane,
    ptrdiff_t R_stride, const double *si, ptrdiff_t si_plane,
    ptrdiff_t si_stride, double *so, ptrdiff_t so_plane, ptrdiff_t so_stride) {
  ksl_mat3x3_t R_i;
  if (n > 0) R_i = ksl_mat3x3_of_planes(R, R_plane);
  KSL_EACH_OF(n) {
    if (R_stride) R_i = ksl_mat3x3_of_planes(R + i * R_stride, R_plane);
    const ksl_screw_t si_i = ksl_screw_of_planes(si + i * si_stride, si_plane);
    ksl_screw_t so_i;
    ksl_product_Adrs(&R_i, &si_i, &so_i);
    ksl_screw_to_planes(&so_i, so + i * so_stride, so_plane);
  }
}

/* ksl_product_Adrinvs of n elements. */
static KSL_INLINED void ksl_product_Adrinvs_many(ptrdiff_t n, const ksl_mat3x3_t *R,
    ptrdiff_t R_stride, const ksl_screw_t *si, ptrdiff_t si_stride,
    ksl_screw_t *so, ptrdiff_t so_stride) {
  KSL_EACH_OF(n) {
    ksl_product_Adrinvs(R + i * R_stride, si + i * si_stride, so + i * so_stride);
  }
}

static KSL_INLINED void ksl_product_Adrinvs_planes(ptrdiff_t n, const double *R, ptrdiff_t R_plane,
    ptrdiff_t R_stride, const double *si, ptrdiff_t si_plane,
    ptrdiff_t si_stride, double *so, ptrdiff_t so_plane, ptrdiff_t so_stride) {
  ksl_mat3x3_t R_i;
  if (n > 0) R_i = ksl_mat3x3_of_planes(R, R_plane);
  KSL_EACH_OF(n) {
    if (R_stride) R_i = ksl_mat3x3_of_planes(R + i * R_stride, R_plane);
    const ksl_screw_t si_i = ksl_screw_of_planes(si + i * si_stride, si_plane);
    ksl_screw_t so_i;
    ksl_product_Adrinvs(&R_i, &si_i, &so_i);
    ksl_screw_to_planes(&so_i, so + i * so_stride, so_plane);
  }
}

/* ksl_product_Adrsinv of n elements. */
static KSL_INLINED void ksl_product_Adrsinv_many(ptrdiff_t n, const ksl_mat3x3_t *R,
    ptrdiff_t R_stride, const ksl_screw_t *si, ptrdiff_t si_stride,
    ksl_screw_t *so, ptrdiff_t so_stride) {
  KSL_EACH_OF(n) {
    ksl_product_Adrsinv(R + i * R_stride, si + i * si_stride, so + i * so_stride);
  }
}

static KSL_INLINED void ksl_product_Adrsinv_planes(ptrdiff_t n, const double *R, ptrdiff_t R_plane,
    ptrdiff_t R_stride, const double *si, ptrdiff_t si_plane,
    ptrdiff_t si_stride, double *so, ptrdiff_t so_plane, ptrdiff_t so_stride) {
  ksl_mat3x3_t R_i;
  if (n > 0) R_i = ksl_mat3x3_of_planes(R, R_plane);
  KSL_EACH_OF(n) {
    if (R_stride) R_i = ksl_mat3x3_of_planes(R + i * R_stride, R_plane);
    const ksl_screw_t si_i = ksl_screw_of_planes(si + i * si_stride, si_plane);
    ksl_screw_t so_i;
    ksl_product_Adrsinv(&R_i, &si_i, &so_i);
    ksl_screw_to_planes(&so_i, so + i * so_stride, so_plane);
  }
}

/* ksl_product_Ads of n elements. */
static KSL_INLINED void ksl_product_Ads_many(ptrdiff_t n, const ksl_SE3_t *D, ptrdiff_t D_stride,
    const ksl_screw_t *si, ptrdiff_t si_stride, ksl_screw_t *so,
    ptrdiff_t so_stride) {
  KSL_EACH_OF(n) {
    ksl_product_Ads(D + i * D_stride, si + i * si_stride, so + i * so_stride);
  }
}

static KSL_INLINED void ksl_product_Ads_planes(ptrdiff_t n, const double *D, ptrdiff_t D_plane,
    ptrdiff_t D_stride, const double *si, ptrdiff_t si_plane,
    ptrdiff_t si_stride, double *so, ptrdiff_t so_plane, ptrdiff_t so_stride) {
  ksl_SE3_t D_i;
  if (n > 0) D_i = ksl_SE3_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3_of_planes(D + i * D_stride, D_plane);
    const ksl_screw_t si_i = ksl_screw_of_planes(si + i * si_stride, si_plane);
    ksl_screw_t so_i;
    ksl_product_Ads(&D_i, &si_i, &so_i);
    ksl_screw_to_planes(&so_i, so + i * so_stride, so_plane);
  }
}

/* ksl_product_Adinvs of n elements. */
static KSL_INLINED void ksl_product_Adinvs_many(ptrdiff_t n, const ksl_SE3_t *D, ptrdiff_t D_stride,
    const ksl_screw_t *si, ptrdiff_t si_stride, ksl_screw_t *so,
    ptrdiff_t so_stride) {
  KSL_EACH_OF(n) {
    ksl_product_Adinvs(D + i * D_stride, si + i * si_stride, so + i * so_stride);
  }
}

static KSL_INLINED void ksl_product_Adinvs_planes(ptrdiff_t n, const double *D, ptrdiff_t D_plane,
    ptrdiff_t D_stride, const double *si, ptrdiff_t si_plane,
    ptrdiff_t si_stride, double *so, ptrdiff_t so_plane, ptrdiff_t so_stride) {
  ksl_SE3_t D_i;
  if (n > 0) D_i = ksl_SE3_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3_of_planes(D + i * D_stride, D_plane);
    const ksl_screw_t si_i = ksl_screw_of_planes(si + i * si_stride, si_plane);
    ksl_screw_t so_i;
    ksl_product_Adinvs(&D_i, &si_i, &so_i);
    ksl_screw_to_planes(&so_i, so + i * so_stride, so_plane);
  }
}

/* ksl_product_Adsinv of n elements. */
static KSL_INLINED void ksl_product_Adsinv_many(ptrdiff_t n, const ksl_SE3_t *D, ptrdiff_t D_stride,
    const ksl_screw_t *si, ptrdiff_t si_stride, ksl_screw_t *so,
    ptrdiff_t so_stride) {
  KSL_EACH_OF(n) {
    ksl_product_Adsinv(D + i * D_stride, si + i * si_stride, so + i * so_stride);
  }
}

static KSL_INLINED void ksl_product_Adsinv_planes(ptrdiff_t n, const double *D, ptrdiff_t D_plane,
    ptrdiff_t D_stride, const double *si, ptrdiff_t si_plane,
    ptrdiff_t si_stride, double *so, ptrdiff_t so_plane, ptrdiff_t so_stride) {
  ksl_SE3_t D_i;
  if (n > 0) D_i = ksl_SE3_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3_of_planes(D + i * D_stride, D_plane);
    const ksl_screw_t si_i = ksl_screw_of_planes(si + i * si_stride, si_plane);
    ksl_screw_t so_i;
    ksl_product_Adsinv(&D_i, &si_i, &so_i);
    ksl_screw_to_planes(&so_i, so + i * so_stride, so_plane);
  }
}

/* ksl_hstx of n elements. */
static KSL_INLINED void ksl_hstx_many(ptrdiff_t n, const ksl_SE3_t *D, ptrdiff_t D_stride,
    ksl_screw_t *so, ptrdiff_t so_stride) {
  KSL_EACH_OF(n) {
    ksl_hstx(D + i * D_stride, so + i * so_stride);
  }
}

static KSL_INLINED void ksl_hstx_planes(ptrdiff_t n, const double *D, ptrdiff_t D_plane,
    ptrdiff_t D_stride, double *so, ptrdiff_t so_plane, ptrdiff_t so_stride) {
  ksl_SE3_t D_i;
  if (n > 0) D_i = ksl_SE3_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3_of_planes(D + i * D_stride, D_plane);
    ksl_screw_t so_i;
    ksl_hstx(&D_i, &so_i);
    ksl_screw_to_planes(&so_i, so + i * so_stride, so_plane);
  }
}

/* ksl_hsty of n elements. */
static KSL_INLINED void ksl_hsty_many(ptrdiff_t n, const ksl_SE3_t *D, ptrdiff_t D_stride,
    ksl_screw_t *so, ptrdiff_t so_stride) {
  KSL_EACH_OF(n) {
    ksl_hsty(D + i * D_stride, so + i * so_stride);
  }
}

static KSL_INLINED void ksl_hsty_planes(ptrdiff_t n, const double *D, ptrdiff_t D_plane,
    ptrdiff_t D_stride, double *so, ptrdiff_t so_plane, ptrdiff_t so_stride) {
  ksl_SE3_t D_i;
  if (n > 0) D_i = ksl_SE3_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3_of_planes(D + i * D_stride, D_plane);
    ksl_screw_t so_i;
    ksl_hsty(&D_i, &so_i);
    ksl_screw_to_planes(&so_i, so + i * so_stride, so_plane);
  }
}

/* ksl_hstz of n elements. */
static KSL_INLINED void ksl_hstz_many(ptrdiff_t n, const ksl_SE3_t *D, ptrdiff_t D_stride,
    ksl_screw_t *so, ptrdiff_t so_stride) {
  KSL_EACH_OF(n) {
    ksl_hstz(D + i * D_stride, so + i * so_stride);
  }
}

static KSL_INLINED void ksl_hstz_planes(ptrdiff_t n, const double *D, ptrdiff_t D_plane,
    ptrdiff_t D_stride, double *so, ptrdiff_t so_plane, ptrdiff_t so_stride) {
  ksl_SE3_t D_i;
  if (n > 0) D_i = ksl_SE3_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3_of_planes(D + i * D_stride, D_plane);
    ksl_screw_t so_i;
    ksl_hstz(&D_i, &so_i);
    ksl_screw_to_planes(&so_i, so + i * so_stride, so_plane);
  }
}

/* ksl_hsrx of n elements. */
static KSL_INLINED void ksl_hsrx_many(ptrdiff_t n, const ksl_SE3_t *D, ptrdiff_t D_stride,
    ksl_screw_t *so, ptrdiff_t so_stride) {
  KSL_EACH_OF(n) {
    ksl_hsrx(D + i * D_stride, so + i * so_stride);
  }
}

static KSL_INLINED void ksl_hsrx_planes(ptrdiff_t n, const double *D, ptrdiff_t D_plane,
    ptrdiff_t D_stride, double *so, ptrdiff_t so_plane, ptrdiff_t so_stride) {
  ksl_SE3_t D_i;
  if (n > 0) D_i = ksl_SE3_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3_of_planes(D + i * D_stride, D_plane);
    ksl_screw_t so_i;
    ksl_hsrx(&D_i, &so_i);
    ksl_screw_to_planes(&so_i, so + i * so_stride, so_plane);
  }
}

/* ksl_hsry of n elements. */
static KSL_INLINED void ksl_hsry_many(ptrdiff_t n, const ksl_SE3_t *D, ptrdiff_t D_stride,
    ksl_screw_t *so, ptrdiff_t so_stride) {
  KSL_EACH_OF(n) {
    ksl_hsry(D + i * D_stride, so + i * so_stride);
  }
}

static KSL_INLINED void ksl_hsry_planes(ptrdiff_t n, const double *D, ptrdiff_t D_plane,
    ptrdiff_t D_stride, double *so, ptrdiff_t so_plane, ptrdiff_t so_stride) {
  ksl_SE3_t D_i;
  if (n > 0) D_i = ksl_SE3_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3_of_planes(D + i * D_stride, D_plane);
    ksl_screw_t so_i;
    ksl_hsry(&D_i, &so_i);
    ksl_screw_to_planes(&so_i, so + i * so_stride, so_plane);
  }
}

/* ksl_hsrz of n elements. */
static KSL_INLINED void ksl_hsrz_many(ptrdiff_t n, const ksl_SE3_t *D, ptrdiff_t D_stride,
    ksl_screw_t *so, ptrdiff_t so_stride) {
  KSL_EACH_OF(n) {
    ksl_hsrz(D + i * D_stride, so + i * so_stride);
  }
}

static KSL_INLINED void ksl_hsrz_planes(ptrdiff_t n, const double *D, ptrdiff_t D_plane,
    ptrdiff_t D_stride, double *so, ptrdiff_t so_plane, ptrdiff_t so_stride) {
  ksl_SE3_t D_i;
  if (n > 0) D_i = ksl_SE3_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3_of_planes(D + i * D_stride, D_plane);
    ksl_screw_t so_i;
    ksl_hsrz(&D_i, &so_i);
    ksl_screw_to_planes(&so_i, so + i * so_stride, so_plane);
  }
}

/* ksl_hstxinv of n elements. */
static KSL_INLINED void ksl_hstxinv_many(ptrdiff_t n, const ksl_SE3_t *D, ptrdiff_t D_stride,
    ksl_screw_t *so, ptrdiff_t so_stride) {
  KSL_EACH_OF(n) {
    ksl_hstxinv(D + i * D_stride, so + i * so_stride);
  }
}

static KSL_INLINED void ksl_hstxinv_planes(ptrdiff_t n, const double *D, ptrdiff_t D_plane,
    ptrdiff_t D_stride, double *so, ptrdiff_t so_plane, ptrdiff_t so_stride) {
  ksl_SE3_t D_i;
  if (n > 0) D_i = ksl_SE3_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3_of_planes(D + i * D_stride, D_plane);
    ksl_screw_t so_i;
    ksl_hstxinv(&D_i, &so_i);
    ksl_screw_to_planes(&so_i, so + i * so_stride, so_plane);
  }
}

/* ksl_hstyinv of n elements. */
static KSL_INLINED void ksl_hstyinv_many(ptrdiff_t n, const ksl_SE3_t *D, ptrdiff_t D_stride,
    ksl_screw_t *so, ptrdiff_t so_stride) {
  KSL_EACH_OF(n) {
    ksl_hstyinv(D + i * D_stride, so + i * so_stride);
  }
}

static KSL_INLINED void ksl_hstyinv_planes(ptrdiff_t n, const double *D, ptrdiff_t D_plane,
    ptrdiff_t D_stride, double *so, ptrdiff_t so_plane, ptrdiff_t so_stride) {
  ksl_SE3_t D_i;
  if (n > 0) D_i = ksl_SE3_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3_of_planes(D + i * D_stride, D_plane);
    ksl_screw_t so_i;
    ksl_hstyinv(&D_i, &so_i);
    ksl_screw_to_planes(&so_i, so + i * so_stride, so_plane);
  }
}

/* ksl_hstzinv of n elements. */
static KSL_INLINED void ksl_hstzinv_many(ptrdiff_t n, const ksl_SE3_t *D, ptrdiff_t D_stride,
    ksl_screw_t *so, ptrdiff_t so_stride) {
  KSL_EACH_OF(n) {
    ksl_hstzinv(D + i * D_stride, so + i * so_stride);
  }
}

static KSL_INLINED void ksl_hstzinv_planes(ptrdiff_t n, const double *D, ptrdiff_t D_plane,
    ptrdiff_t D_stride, double *so, ptrdiff_t so_plane, ptrdiff_t so_stride) {
  ksl_SE3_t D_i;
  if (n > 0) D_i = ksl_SE3_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3_of_planes(D + i * D_stride, D_plane);
    ksl_screw_t so_i;
    ksl_hstzinv(&D_i, &so_i);
    ksl_screw_to_planes(&so_i, so + i * so_stride, so_plane);
  }
}

/* ksl_hsrxinv of n elements. */
static KSL_INLINED void ksl_hsrxinv_many(ptrdiff_t n, const ksl_SE3_t *D, ptrdiff_t D_stride,
    ksl_screw_t *so, ptrdiff_t so_stride) {
  KSL_EACH_OF(n) {
    ksl_hsrxinv(D + i * D_stride, so + i * so_stride);
  }
}

static KSL_INLINED void ksl_hsrxinv_planes(ptrdiff_t n, const double *D, ptrdiff_t D_plane,
    ptrdiff_t D_stride, double *so, ptrdiff_t so_plane, ptrdiff_t so_stride) {
  ksl_SE3_t D_i;
  if (n > 0) D_i = ksl_SE3_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3_of_planes(D + i * D_stride, D_plane);
    ksl_screw_t so_i;
    ksl_hsrxinv(&D_i, &so_i);
    ksl_screw_to_planes(&so_i, so + i * so_stride, so_plane);
  }
}

/* ksl_hsryinv of n elements. */
static KSL_INLINED void ksl_hsryinv_many(ptrdiff_t n, const ksl_SE3_t *D, ptrdiff_t D_stride,
    ksl_screw_t *so, ptrdiff_t so_stride) {
  KSL_EACH_OF(n) {
    ksl_hsryinv(D + i * D_stride, so + i * so_stride);
  }
}

static KSL_INLINED void ksl_hsryinv_planes(ptrdiff_t n, const double *D, ptrdiff_t D_plane,
    ptrdiff_t D_stride, double *so, ptrdiff_t so_plane, ptrdiff_t so_stride) {
  ksl_SE3_t D_i;
  if (n > 0) D_i = ksl_SE3_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3_of_planes(D + i * D_stride, D_plane);
    ksl_screw_t so_i;
    ksl_hsryinv(&D_i, &so_i);
    ksl_screw_to_planes(&so_i, so + i * so_stride, so_plane);
  }
}

/* ksl_hsrzinv of n elements. */
static KSL_INLINED void ksl_hsrzinv_many(ptrdiff_t n, const ksl_SE3_t *D, ptrdiff_t D_stride,
    ksl_screw_t *so, ptrdiff_t so_stride) {
  KSL_EACH_OF(n) {
    ksl_hsrzinv(D + i * D_stride, so + i * so_stride);
  }
}

static KSL_INLINED void ksl_hsrzinv_planes(ptrdiff_t n, const double *D, ptrdiff_t D_plane,
    ptrdiff_t D_stride, double *so, ptrdiff_t so_plane, ptrdiff_t so_stride) {
  ksl_SE3_t D_i;
  if (n > 0) D_i = ksl_SE3_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3_of_planes(D + i * D_stride, D_plane);
    ksl_screw_t so_i;
    ksl_hsrzinv(&D_i, &so_i);
    ksl_screw_to_planes(&so_i, so + i * so_stride, so_plane);
  }
}

/* ksl_Ad of n elements. */
static KSL_INLINED void ksl_Ad_many(ptrdiff_t n, const ksl_SE3_t *D, ptrdiff_t D_stride,
    ksl_mat6x6_t *M, ptrdiff_t M_stride) {
  KSL_EACH_OF(n) {
    ksl_Ad(D + i * D_stride, M + i * M_stride);
  }
}

static KSL_INLINED void ksl_Ad_planes(ptrdiff_t n, const double *D, ptrdiff_t D_plane,
    ptrdiff_t D_stride, double *M, ptrdiff_t M_plane, ptrdiff_t M_stride) {
  ksl_SE3_t D_i;
  if (n > 0) D_i = ksl_SE3_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3_of_planes(D + i * D_stride, D_plane);
    ksl_mat6x6_t M_i;
    ksl_Ad(&D_i, &M_i);
    ksl_mat6x6_to_planes(&M_i, M + i * M_stride, M_plane);
  }
}

/* ksl_dot_cs of n elements. */
static KSL_INLINED void ksl_dot_cs_many(ptrdiff_t n, const ksl_coscrew_t *c, ptrdiff_t c_stride,
    const ksl_screw_t *s, ptrdiff_t s_stride, double *power,
    ptrdiff_t power_stride) {
  KSL_EACH_OF(n) {
    power[i * power_stride] = ksl_dot_cs(c + i * c_stride, s + i * s_stride);
  }
}

static KSL_INLINED void ksl_dot_cs_planes(ptrdiff_t n, const double *c, ptrdiff_t c_plane,
    ptrdiff_t c_stride, const double *s, ptrdiff_t s_plane, ptrdiff_t s_stride,
    double *power, ptrdiff_t power_stride) {
  ksl_coscrew_t c_i;
  if (n > 0) c_i = ksl_coscrew_of_planes(c, c_plane);
  KSL_EACH_OF(n) {
    if (c_stride) c_i = ksl_coscrew_of_planes(c + i * c_stride, c_plane);
    const ksl_screw_t s_i = ksl_screw_of_planes(s + i * s_stride, s_plane);
    power[i * power_stride] = ksl_dot_cs(&c_i, &s_i);
  }
}

/* ksl_cross_ss of n elements. */
static KSL_INLINED void ksl_cross_ss_many(ptrdiff_t n, const ksl_screw_t *s1, ptrdiff_t s1_stride,
    const ksl_screw_t *s2, ptrdiff_t s2_stride, ksl_screw_t *so,
    ptrdiff_t so_stride) {
  KSL_EACH_OF(n) {
    ksl_cross_ss(s1 + i * s1_stride, s2 + i * s2_stride, so + i * so_stride);
  }
}

static KSL_INLINED void ksl_cross_ss_planes(ptrdiff_t n, const double *s1, ptrdiff_t s1_plane,
    ptrdiff_t s1_stride, const double *s2, ptrdiff_t s2_plane,
    ptrdiff_t s2_stride, double *so, ptrdiff_t so_plane, ptrdiff_t so_stride) {
  ksl_screw_t s1_i;
  if (n > 0) s1_i = ksl_screw_of_planes(s1, s1_plane);
  KSL_EACH_OF(n) {
    if (s1_stride) s1_i = ksl_screw_of_planes(s1 + i * s1_stride, s1_plane);
    const ksl_screw_t s2_i = ksl_screw_of_planes(s2 + i * s2_stride, s2_plane);
    ksl_screw_t so_i;
    ksl_cross_ss(&s1_i, &s2_i, &so_i);
    ksl_screw_to_planes(&so_i, so + i * so_stride, so_plane);
  }
}

/* ksl_cross_sst of n elements. */
static KSL_INLINED void ksl_cross_sst_many(ptrdiff_t n, const ksl_screw_t *s1, ptrdiff_t s1_stride,
    const ksl_screw_t *s2, ptrdiff_t s2_stride, ksl_screw_t *so,
    ptrdiff_t so_stride) {
  KSL_EACH_OF(n) {
    ksl_cross_sst(s1 + i * s1_stride, s2 + i * s2_stride, so + i * so_stride);
  }
}

static KSL_INLINED void ksl_cross_sst_planes(ptrdiff_t n, const double *s1, ptrdiff_t s1_plane,
    ptrdiff_t s1_stride, const double *s2, ptrdiff_t s2_plane,
    ptrdiff_t s2_stride, double *so, ptrdiff_t so_plane, ptrdiff_t so_stride) {
  ksl_screw_t s1_i;
  if (n > 0) s1_i = ksl_screw_of_planes(s1, s1_plane);
  KSL_EACH_OF(n) {
    if (s1_stride) s1_i = ksl_screw_of_planes(s1 + i * s1_stride, s1_plane);
    const ksl_screw_t s2_i = ksl_screw_of_planes(s2 + i * s2_stride, s2_plane);
    ksl_screw_t so_i;
    ksl_cross_sst(&s1_i, &s2_i, &so_i);
    ksl_screw_to_planes(&so_i, so + i * so_stride, so_plane);
  }
}

/* ksl_hsra of n elements. */
static KSL_INLINED void ksl_hsra_many(ptrdiff_t n, const ksl_SE3_t *D, ptrdiff_t D_stride,
    const ksl_vec3_t *axis, ptrdiff_t axis_stride, ksl_screw_t *so,
    ptrdiff_t so_stride) {
  KSL_EACH_OF(n) {
    ksl_hsra(D + i * D_stride, axis + i * axis_stride, so + i * so_stride);
  }
}

static KSL_INLINED void ksl_hsra_planes(ptrdiff_t n, const double *D, ptrdiff_t D_plane,
    ptrdiff_t D_stride, const double *axis, ptrdiff_t axis_plane,
    ptrdiff_t axis_stride, double *so, ptrdiff_t so_plane, ptrdiff_t so_stride) {
  ksl_SE3_t D_i;
  if (n > 0) D_i = ksl_SE3_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3_of_planes(D + i * D_stride, D_plane);
    const ksl_vec3_t axis_i = ksl_vec3_of_planes(axis + i * axis_stride, axis_plane);
    ksl_screw_t so_i;
    ksl_hsra(&D_i, &axis_i, &so_i);
    ksl_screw_to_planes(&so_i, so + i * so_stride, so_plane);
  }
}

/* ksl_hsta of n elements. */
static KSL_INLINED void ksl_hsta_many(ptrdiff_t n, const ksl_SE3_t *D, ptrdiff_t D_stride,
    const ksl_vec3_t *axis, ptrdiff_t axis_stride, ksl_screw_t *so,
    ptrdiff_t so_stride) {
  KSL_EACH_OF(n) {
    ksl_hsta(D + i * D_stride, axis + i * axis_stride, so + i * so_stride);
  }
}

static KSL_INLINED void ksl_hsta_planes(ptrdiff_t n, const double *D, ptrdiff_t D_plane,
    ptrdiff_t D_stride, const double *axis, ptrdiff_t axis_plane,
    ptrdiff_t axis_stride, double *so, ptrdiff_t so_plane, ptrdiff_t so_stride) {
  ksl_SE3_t D_i;
  if (n > 0) D_i = ksl_SE3_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3_of_planes(D + i * D_stride, D_plane);
    const ksl_vec3_t axis_i = ksl_vec3_of_planes(axis + i * axis_stride, axis_plane);
    ksl_screw_t so_i;
    ksl_hsta(&D_i, &axis_i, &so_i);
    ksl_screw_to_planes(&so_i, so + i * so_stride, so_plane);
  }
}

/* ksl_hsrainv of n elements. */
static KSL_INLINED void ksl_hsrainv_many(ptrdiff_t n, const ksl_SE3_t *D, ptrdiff_t D_stride,
    const ksl_vec3_t *axis, ptrdiff_t axis_stride, ksl_screw_t *so,
    ptrdiff_t so_stride) {
  KSL_EACH_OF(n) {
    ksl_hsrainv(D + i * D_stride, axis + i * axis_stride, so + i * so_stride);
  }
}

static KSL_INLINED void ksl_hsrainv_planes(ptrdiff_t n, const double *D, ptrdiff_t D_plane,
    ptrdiff_t D_stride, const double *axis, ptrdiff_t axis_plane,
    ptrdiff_t axis_stride, double *so, ptrdiff_t so_plane, ptrdiff_t so_stride) {
  ksl_SE3_t D_i;
  if (n > 0) D_i = ksl_SE3_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3_of_planes(D + i * D_stride, D_plane);
    const ksl_vec3_t axis_i = ksl_vec3_of_planes(axis + i * axis_stride, axis_plane);
    ksl_screw_t so_i;
    ksl_hsrainv(&D_i, &axis_i, &so_i);
    ksl_screw_to_planes(&so_i, so + i * so_stride, so_plane);
  }
}

/* ksl_hstainv of n elements. */
static KSL_INLINED void ksl_hstainv_many(ptrdiff_t n, const ksl_SE3_t *D, ptrdiff_t D_stride,
    const ksl_vec3_t *axis, ptrdiff_t axis_stride, ksl_screw_t *so,
    ptrdiff_t so_stride) {
  KSL_EACH_OF(n) {
    ksl_hstainv(D + i * D_stride, axis + i * axis_stride, so + i * so_stride);
  }
}

static KSL_INLINED void ksl_hstainv_planes(ptrdiff_t n, const double *D, ptrdiff_t D_plane,
    ptrdiff_t D_stride, const double *axis, ptrdiff_t axis_plane,
    ptrdiff_t axis_stride, double *so, ptrdiff_t so_plane, ptrdiff_t so_stride) {
  ksl_SE3_t D_i;
  if (n > 0) D_i = ksl_SE3_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3_of_planes(D + i * D_stride, D_plane);
    const ksl_vec3_t axis_i = ksl_vec3_of_planes(axis + i * axis_stride, axis_plane);
    ksl_screw_t so_i;
    ksl_hstainv(&D_i, &axis_i, &so_i);
    ksl_screw_to_planes(&so_i, so + i * so_stride, so_plane);
  }
}

/* ksl_ad of n elements. */
static KSL_INLINED void ksl_ad_many(ptrdiff_t n, const ksl_screw_t *s, ptrdiff_t s_stride,
    ksl_mat6x6_t *M, ptrdiff_t M_stride) {
  KSL_EACH_OF(n) {
    ksl_ad(s + i * s_stride, M + i * M_stride);
  }
}

static KSL_INLINED void ksl_ad_planes(ptrdiff_t n, const double *s, ptrdiff_t s_plane,
    ptrdiff_t s_stride, double *M, ptrdiff_t M_plane, ptrdiff_t M_stride) {
  ksl_screw_t s_i;
  if (n > 0) s_i = ksl_screw_of_planes(s, s_plane);
  KSL_EACH_OF(n) {
    if (s_stride) s_i = ksl_screw_of_planes(s + i * s_stride, s_plane);
    ksl_mat6x6_t M_i;
    ksl_ad(&s_i, &M_i);
    ksl_mat6x6_to_planes(&M_i, M + i * M_stride, M_plane);
  }
}

/* ksl_screwf_copy of n elements. */
static KSL_INLINED void ksl_screwf_copy_many(ptrdiff_t n, const ksl_screwf_t *si,
    ptrdiff_t si_stride, ksl_screwf_t *so, ptrdiff_t so_stride) {
  KSL_EACH_OF(n) {
    ksl_screwf_copy(si + i * si_stride, so + i * so_stride);
  }
}

static KSL_INLINED void ksl_screwf_copy_planes(ptrdiff_t n, const float *si, ptrdiff_t si_plane,
    ptrdiff_t si_stride, float *so, ptrdiff_t so_plane, ptrdiff_t so_stride) {
  ksl_screwf_t si_i;
  if (n > 0) si_i = ksl_screwf_of_planes(si, si_plane);
  KSL_EACH_OF(n) {
    if (si_stride) si_i = ksl_screwf_of_planes(si + i * si_stride, si_plane);
    ksl_screwf_t so_i;
    ksl_screwf_copy(&si_i, &so_i);
    ksl_screwf_to_planes(&so_i, so + i * so_stride, so_plane);
  }
}

/* ksl_screwf_scale of n elements. */
static KSL_INLINED void ksl_screwf_scale_many(ptrdiff_t n, ksl_screwf_t *self,
    ptrdiff_t self_stride, const float *a, ptrdiff_t a_stride) {
  KSL_EACH_OF(n) {
    ksl_screwf_scale(self + i * self_stride, a[i * a_stride]);
  }
}

static KSL_INLINED void ksl_screwf_scale_planes(ptrdiff_t n, float *self, ptrdiff_t self_plane,
    ptrdiff_t self_stride, const float *a, ptrdiff_t a_stride) {
  KSL_EACH_OF(n) {
    ksl_screwf_t self_i = ksl_screwf_of_planes(self + i * self_stride, self_plane);
    ksl_screwf_scale(&self_i, a[i * a_stride]);
    ksl_screwf_to_planes(&self_i, self + i * self_stride, self_plane);
  }
}

/* ksl_screwf_inverted of n elements. */
static KSL_INLINED void ksl_screwf_inverted_many(ptrdiff_t n, const ksl_screwf_t *si,
    ptrdiff_t si_stride, ksl_screwf_t *so, ptrdiff_t so_stride) {
  KSL_EACH_OF(n) {
    ksl_screwf_inverted(si + i * si_stride, so + i * so_stride);
  }
}

static KSL_INLINED void ksl_screwf_inverted_planes(ptrdiff_t n, const float *si, ptrdiff_t si_plane,
    ptrdiff_t si_stride, float *so, ptrdiff_t so_plane, ptrdiff_t so_stride) {
  ksl_screwf_t si_i;
  if (n > 0) si_i = ksl_screwf_of_planes(si, si_plane);
  KSL_EACH_OF(n) {
    if (si_stride) si_i = ksl_screwf_of_planes(si + i * si_stride, si_plane);
    ksl_screwf_t so_i;
    ksl_screwf_inverted(&si_i, &so_i);
    ksl_screwf_to_planes(&so_i, so + i * so_stride, so_plane);
  }
}

/* ksl_screwf_invert of n elements. */
static KSL_INLINED void ksl_screwf_invert_many(ptrdiff_t n, ksl_screwf_t *self,
    ptrdiff_t self_stride) {
  KSL_EACH_OF(n) {
    ksl_screwf_invert(self + i * self_stride);
  }
}

static KSL_INLINED void ksl_screwf_invert_planes(ptrdiff_t n, float *self, ptrdiff_t self_plane,
    ptrdiff_t self_stride) {
  KSL_EACH_OF(n) {
    ksl_screwf_t self_i = ksl_screwf_of_planes(self + i * self_stride, self_plane);
    ksl_screwf_invert(&self_i);
    ksl_screwf_to_planes(&self_i, self + i * self_stride, self_plane);
  }
}

/* ksl_axpy_ssf of n elements. */
static KSL_INLINED void ksl_axpy_ssf_many(ptrdiff_t n, const float *a, ptrdiff_t a_stride,
    const ksl_screwf_t *x, ptrdiff_t x_stride, ksl_screwf_t *y,
    ptrdiff_t y_stride) {
  KSL_EACH_OF(n) {
    ksl_axpy_ssf(a[i * a_stride], x + i * x_stride, y + i * y_stride);
  }
}

static KSL_INLINED void ksl_axpy_ssf_planes(ptrdiff_t n, const float *a, ptrdiff_t a_stride,
    const float *x, ptrdiff_t x_plane, ptrdiff_t x_stride, float *y,
    ptrdiff_t y_plane, ptrdiff_t y_stride) {
  KSL_EACH_OF(n) {
    const ksl_screwf_t x_i = ksl_screwf_of_planes(x + i * x_stride, x_plane);
    ksl_screwf_t y_i = ksl_screwf_of_planes(y + i * y_stride, y_plane);
    ksl_axpy_ssf(a[i * a_stride], &x_i, &y_i);
    ksl_screwf_to_planes(&y_i, y + i * y_stride, y_plane);
  }
}

/* ksl_xpy_ssf of n elements. */
static KSL_INLINED void ksl_xpy_ssf_many(ptrdiff_t n, const ksl_screwf_t *x, ptrdiff_t x_stride,
    ksl_screwf_t *y, ptrdiff_t y_stride) {
  KSL_EACH_OF(n) {
    ksl_xpy_ssf(x + i * x_stride, y + i * y_stride);
  }
}

static KSL_INLINED void ksl_xpy_ssf_planes(ptrdiff_t n, const float *x, ptrdiff_t x_plane,
    ptrdiff_t x_stride, float *y, ptrdiff_t y_plane, ptrdiff_t y_stride) {
  ksl_screwf_t x_i;
  if (n > 0) x_i = ksl_screwf_of_planes(x, x_plane);
  KSL_EACH_OF(n) {
    if (x_stride) x_i = ksl_screwf_of_planes(x + i * x_stride, x_plane);
    ksl_screwf_t y_i = ksl_screwf_of_planes(y + i * y_stride, y_plane);
    ksl_xpy_ssf(&x_i, &y_i);
    ksl_screwf_to_planes(&y_i, y + i * y_stride, y_plane);
  }
}

/* ksl_nxpy_ssf of n elements. */
static KSL_INLINED void ksl_nxpy_ssf_many(ptrdiff_t n, const ksl_screwf_t *x, ptrdiff_t x_stride,
    ksl_screwf_t *y, ptrdiff_t y_stride) {
  KSL_EACH_OF(n) {
    ksl_nxpy_ssf(x + i * x_stride, y + i * y_stride);
  }
}

static KSL_INLINED void ksl_nxpy_ssf_planes(ptrdiff_t n, const float *x, ptrdiff_t x_plane,
    ptrdiff_t x_stride, float *y, ptrdiff_t y_plane, ptrdiff_t y_stride) {
  ksl_screwf_t x_i;
  if (n > 0) x_i = ksl_screwf_of_planes(x, x_plane);
  KSL_EACH_OF(n) {
    if (x_stride) x_i = ksl_screwf_of_planes(x + i * x_stride, x_plane);
    ksl_screwf_t y_i = ksl_screwf_of_planes(y + i * y_stride, y_plane);
    ksl_nxpy_ssf(&x_i, &y_i);
    ksl_screwf_to_planes(&y_i, y + i * y_stride, y_plane);
  }
}

/* ksl_product_asf of n elements. */
static KSL_INLINED void ksl_product_asf_many(ptrdiff_t n, const float *a, ptrdiff_t a_stride,
    const ksl_screwf_t *si, ptrdiff_t si_stride, ksl_screwf_t *so,
    ptrdiff_t so_stride) {
  KSL_EACH_OF(n) {
    ksl_product_asf(a[i * a_stride], si + i * si_stride, so + i * so_stride);
  }
}

static KSL_INLINED void ksl_product_asf_planes(ptrdiff_t n, const float *a, ptrdiff_t a_stride,
    const float *si, ptrdiff_t si_plane, ptrdiff_t si_stride, float *so,
    ptrdiff_t so_plane, ptrdiff_t so_stride) {
  KSL_EACH_OF(n) {
    const ksl_screwf_t si_i = ksl_screwf_of_planes(si + i * si_stride, si_plane);
    ksl_screwf_t so_i;
    ksl_product_asf(a[i * a_stride], &si_i, &so_i);
    ksl_screwf_to_planes(&so_i, so + i * so_stride, so_plane);
  }
}

/* ksl_add_ssf of n elements. */
static KSL_INLINED void ksl_add_ssf_many(ptrdiff_t n, const ksl_screwf_t *s1, ptrdiff_t s1_stride,
    const ksl_screwf_t *s2, ptrdiff_t s2_stride, ksl_screwf_t *so,
    ptrdiff_t so_stride) {
  KSL_EACH_OF(n) {
    ksl_add_ssf(s1 + i * s1_stride, s2 + i * s2_stride, so + i * so_stride);
  }
}

static KSL_INLINED void ksl_add_ssf_planes(ptrdiff_t n, const float *s1, ptrdiff_t s1_plane,
    ptrdiff_t s1_stride, const float *s2, ptrdiff_t s2_plane,
    ptrdiff_t s2_stride, float *so, ptrdiff_t so_plane, ptrdiff_t so_stride) {
  ksl_screwf_t s1_i;
  if (n > 0) s1_i = ksl_screwf_of_planes(s1, s1_plane);
  KSL_EACH_OF(n) {
    if (s1_stride) s1_i = ksl_screwf_of_planes(s1 + i * s1_stride, s1_plane);
    const ksl_screwf_t s2_i = ksl_screwf_of_planes(s2 + i * s2_stride, s2_plane);
    ksl_screwf_t so_i;
    ksl_add_ssf(&s1_i, &s2_i, &so_i);
    ksl_screwf_to_planes(&so_i, so + i * so_stride, so_plane);
  }
}

/* ksl_subtract_ssf of n elements. */
static KSL_INLINED void ksl_subtract_ssf_many(ptrdiff_t n, const ksl_screwf_t *s1,
    ptrdiff_t s1_stride, const ksl_screwf_t *s2, ptrdiff_t s2_stride,
    ksl_screwf_t *so, ptrdiff_t so_stride) {
  KSL_EACH_OF(n) {
    ksl_subtract_ssf(s1 + i * s1_stride, s2 + i * s2_stride, so + i * so_stride);
  }
}

static KSL_INLINED void ksl_subtract_ssf_planes(ptrdiff_t n, const float *s1, ptrdiff_t s1_plane,
    ptrdiff_t s1_stride, const float *s2, ptrdiff_t s2_plane,
    ptrdiff_t s2_stride, float *so, ptrdiff_t so_plane, ptrdiff_t so_stride) {
  ksl_screwf_t s1_i;
  if (n > 0) s1_i = ksl_screwf_of_planes(s1, s1_plane);
  KSL_EACH_OF(n) {
    if (s1_stride) s1_i = ksl_screwf_of_planes(s1 + i * s1_stride, s1_plane);
    const ksl_screwf_t s2_i = ksl_screwf_of_planes(s2 + i * s2_stride, s2_plane);
    ksl_screwf_t so_i;
    ksl_subtract_ssf(&s1_i, &s2_i, &so_i);
    ksl_screwf_to_planes(&so_i, so + i * so_stride, so_plane);
  }
}

/* ksl_screwf_norm of n elements. */
static KSL_INLINED void ksl_screwf_norm_many(ptrdiff_t n, const ksl_screwf_t *si,
    ptrdiff_t si_stride, float *norm, ptrdiff_t norm_stride) {
  KSL_EACH_OF(n) {
    norm[i * norm_stride] = ksl_screwf_norm(si + i * si_stride);
  }
}

static KSL_INLINED void ksl_screwf_norm_planes(ptrdiff_t n, const float *si, ptrdiff_t si_plane,
    ptrdiff_t si_stride, float *norm, ptrdiff_t norm_stride) {
  ksl_screwf_t si_i;
  if (n > 0) si_i = ksl_screwf_of_planes(si, si_plane);
  KSL_EACH_OF(n) {
    if (si_stride) si_i = ksl_screwf_of_planes(si + i * si_stride, si_plane);
    norm[i * norm_stride] = ksl_screwf_norm(&si_i);
  }
}

/* ksl_screwf_normalize of n elements. */
static KSL_INLINED void ksl_screwf_normalize_many(ptrdiff_t n, ksl_screwf_t *self,
    ptrdiff_t self_stride) {
  KSL_EACH_OF(n) {
    ksl_screwf_normalize(self + i * self_stride);
  }
}

static KSL_INLINED void ksl_screwf_normalize_planes(ptrdiff_t n, float *self, ptrdiff_t self_plane,
    ptrdiff_t self_stride) {
  KSL_EACH_OF(n) {
    ksl_screwf_t self_i = ksl_screwf_of_planes(self + i * self_stride, self_plane);
    ksl_screwf_normalize(&self_i);
    ksl_screwf_to_planes(&self_i, self + i * self_stride, self_plane);
  }
}

/* ksl_screwf_normalized of n elements. */
static KSL_INLINED void ksl_screwf_normalized_many(ptrdiff_t n, const ksl_screwf_t *si,
    ptrdiff_t si_stride, ksl_screwf_t *so, ptrdiff_t so_stride) {
  KSL_EACH_OF(n) {
    ksl_screwf_normalized(si + i * si_stride, so + i * so_stride);
  }
}

static KSL_INLINED void ksl_screwf_normalized_planes(ptrdiff_t n, const float *si,
    ptrdiff_t si_plane, ptrdiff_t si_stride, float *so, ptrdiff_t so_plane,
    ptrdiff_t so_stride) {
  ksl_screwf_t si_i;
  if (n > 0) si_i = ksl_screwf_of_planes(si, si_plane);
  KSL_EACH_OF(n) {
    if (si_stride) si_i = ksl_screwf_of_planes(si + i * si_stride, si_plane);
    ksl_screwf_t so_i;
    ksl_screwf_normalized(&si_i, &so_i);
    ksl_screwf_to_planes(&so_i, so + i * so_stride, so_plane);
  }
}

/* ksl_screwf_from_lin_ang of n elements. */
static KSL_INLINED void ksl_screwf_from_lin_ang_many(ptrdiff_t n, const ksl_vec3f_t *lin,
    ptrdiff_t lin_stride, const ksl_vec3f_t *ang, ptrdiff_t ang_stride,
    ksl_screwf_t *so, ptrdiff_t so_stride) {
  KSL_EACH_OF(n) {
    ksl_screwf_from_lin_ang(lin + i * lin_stride, ang + i * ang_stride, so + i * so_stride);
  }
}

static KSL_INLINED void ksl_screwf_from_lin_ang_planes(ptrdiff_t n, const float *lin,
    ptrdiff_t lin_plane, ptrdiff_t lin_stride, const float *ang,
    ptrdiff_t ang_plane, ptrdiff_t ang_stride, float *so, ptrdiff_t so_plane,
    ptrdiff_t so_stride) {
  ksl_vec3f_t lin_i;
  if (n > 0) lin_i = ksl_vec3f_of_planes(lin, lin_plane);
  KSL_EACH_OF(n) {
    if (lin_stride) lin_i = ksl_vec3f_of_planes(lin + i * lin_stride, lin_plane);
    const ksl_vec3f_t ang_i = ksl_vec3f_of_planes(ang + i * ang_stride, ang_plane);
    ksl_screwf_t so_i;
    ksl_screwf_from_lin_ang(&lin_i, &ang_i, &so_i);
    ksl_screwf_to_planes(&so_i, so + i * so_stride, so_plane);
  }
}

/* ksl_screwf_to_angular_first of n elements. */
static KSL_INLINED void ksl_screwf_to_angular_first_many(ptrdiff_t n, const ksl_screwf_t *si,
    ptrdiff_t si_stride, float *x, ptrdiff_t x_stride) {
  KSL_EACH_OF(n) {
    ksl_screwf_to_angular_first(si + i * si_stride, x + 6 * i * x_stride);
  }
}

static KSL_INLINED void ksl_screwf_to_angular_first_planes(ptrdiff_t n, const float *si,
    ptrdiff_t si_plane, ptrdiff_t si_stride, float *x, ptrdiff_t x_plane,
    ptrdiff_t x_stride) {
  ksl_screwf_t si_i;
  if (n > 0) si_i = ksl_screwf_of_planes(si, si_plane);
  KSL_EACH_OF(n) {
    if (si_stride) si_i = ksl_screwf_of_planes(si + i * si_stride, si_plane);
    float x_i[6];
    ksl_screwf_to_angular_first(&si_i, x_i);
    x[0 + i * x_stride] = x_i[0];
    x[x_plane + i * x_stride] = x_i[1];
    x[2 * x_plane + i * x_stride] = x_i[2];
    x[3 * x_plane + i * x_stride] = x_i[3];
    x[4 * x_plane + i * x_stride] = x_i[4];
    x[5 * x_plane + i * x_stride] = x_i[5];
  }
}

/* ksl_screwf_from_angular_first of n elements. */
static KSL_INLINED void ksl_screwf_from_angular_first_many(ptrdiff_t n, const float *x,
    ptrdiff_t x_stride, ksl_screwf_t *so, ptrdiff_t so_stride) {
  KSL_EACH_OF(n) {
    ksl_screwf_from_angular_first(x + 6 * i * x_stride, so + i * so_stride);
  }
}

static KSL_INLINED void ksl_screwf_from_angular_first_planes(ptrdiff_t n, const float *x,
    ptrdiff_t x_plane, ptrdiff_t x_stride, float *so, ptrdiff_t so_plane,
    ptrdiff_t so_stride) {
  KSL_EACH_OF(n) {
    const float x_i[6] = {x[0 + i * x_stride], x[x_plane + i * x_stride],
        x[2 * x_plane + i * x_stride], x[3 * x_plane + i * x_stride], x[4 * x_plane + i * x_stride],
        x[5 * x_plane + i * x_stride]};
    ksl_screwf_t so_i;
    ksl_screwf_from_angular_first(x_i, &so_i);
    ksl_screwf_to_planes(&so_i, so + i * so_stride, so_plane);
  }
}

/* ksl_add_sstf of n elements. */
static KSL_INLINED void ksl_add_sstf_many(ptrdiff_t n, const ksl_screwf_t *s1, ptrdiff_t s1_stride,
    const ksl_screwf_t *s2, ptrdiff_t s2_stride, ksl_screwf_t *so,
    ptrdiff_t so_stride) {
  KSL_EACH_OF(n) {
    ksl_add_sstf(s1 + i * s1_stride, s2 + i * s2_stride, so + i * so_stride);
  }
}

static KSL_INLINED void ksl_add_sstf_planes(ptrdiff_t n, const float *s1, ptrdiff_t s1_plane,
    ptrdiff_t s1_stride, const float *s2, ptrdiff_t s2_plane,
    ptrdiff_t s2_stride, float *so, ptrdiff_t so_plane, ptrdiff_t so_stride) {
  ksl_screwf_t s1_i;
  if (n > 0) s1_i = ksl_screwf_of_planes(s1, s1_plane);
  KSL_EACH_OF(n) {
    if (s1_stride) s1_i = ksl_screwf_of_planes(s1 + i * s1_stride, s1_plane);
    const ksl_screwf_t s2_i = ksl_screwf_of_planes(s2 + i * s2_stride, s2_plane);
    ksl_screwf_t so_i;
    ksl_add_sstf(&s1_i, &s2_i, &so_i);
    ksl_screwf_to_planes(&so_i, so + i * so_stride, so_plane);
  }
}

/* ksl_product_Adtsf of n elements. */
static KSL_INLINED void ksl_product_Adtsf_many(ptrdiff_t n, const ksl_vec3f_t *t,
    ptrdiff_t t_stride, const ksl_screwf_t *si, ptrdiff_t si_stride,
    ksl_screwf_t *so, ptrdiff_t so_stride) {
  KSL_EACH_OF(n) {
    ksl_product_Adtsf(t + i * t_stride, si + i * si_stride, so + i * so_stride);
  }
}

static KSL_INLINED void ksl_product_Adtsf_planes(ptrdiff_t n, const float *t, ptrdiff_t t_plane,
    ptrdiff_t t_stride, const float *si, ptrdiff_t si_plane, ptrdiff_t si_stride,
    float *so, ptrdiff_t so_plane, ptrdiff_t so_stride) {
  ksl_vec3f_t t_i;
  if (n > 0) t_i = ksl_vec3f_of_planes(t, t_plane);
  KSL_EACH_OF(n) {
    if (t_stride) t_i = ksl_vec3f_of_planes(t + i * t_stride, t_plane);
    const ksl_screwf_t si_i = ksl_screwf_of_planes(si + i * si_stride, si_plane);
    ksl_screwf_t so_i;
    ksl_product_Adtsf(&t_i, &si_i, &so_i);
    ksl_screwf_to_planes(&so_i, so + i * so_stride, so_plane);
  }
}

/* ksl_product_Adtinvsf of n elements. */
static KSL_INLINED void ksl_product_Adtinvsf_many(ptrdiff_t n, const ksl_vec3f_t *t,
    ptrdiff_t t_stride, const ksl_screwf_t *si, ptrdiff_t si_stride,
    ksl_screwf_t *so, ptrdiff_t so_stride) {
  KSL_EACH_OF(n) {
    ksl_product_Adtinvsf(t + i * t_stride, si + i * si_stride, so + i * so_stride);
  }
}

static KSL_INLINED void ksl_product_Adtinvsf_planes(ptrdiff_t n, const float *t, ptrdiff_t t_plane,
    ptrdiff_t t_stride, const float *si, ptrdiff_t si_plane, ptrdiff_t si_stride,
    float *so, ptrdiff_t so_plane, ptrdiff_t so_stride) {
  ksl_vec3f_t t_i;
  if (n > 0) t_i = ksl_vec3f_of_planes(t, t_plane);
  KSL_EACH_OF(n) {
    if (t_stride) t_i = ksl_vec3f_of_planes(t + i * t_stride, t_plane);
    const ksl_screwf_t si_i = ksl_screwf_of_planes(si + i * si_stride, si_plane);
    ksl_screwf_t so_i;
    ksl_product_Adtinvsf(&t_i, &si_i, &so_i);
    ksl_screwf_to_planes(&so_i, so + i * so_stride, so_plane);
  }
}

/* ksl_product_Adtsinvf of n elements. */
static KSL_INLINED void ksl_product_Adtsinvf_many(ptrdiff_t n, const ksl_vec3f_t *t,
    ptrdiff_t t_stride, const ksl_screwf_t *si, ptrdiff_t si_stride,
    ksl_screwf_t *so, ptrdiff_t so_stride) {
  KSL_EACH_OF(n) {
    ksl_product_Adtsinvf(t + i * t_stride, si + i * si_stride, so + i * so_stride);
  }
}

static KSL_INLINED void ksl_product_Adtsinvf_planes(ptrdiff_t n, const float *t, ptrdiff_t t_plane,
    ptrdiff_t t_stride, const float *si, ptrdiff_t si_plane, ptrdiff_t si_stride,
    float *so, ptrdiff_t so_plane, ptrdiff_t so_stride) {
  ksl_vec3f_t t_i;
  if (n > 0) t_i = ksl_vec3f_of_planes(t, t_plane);
  KSL_EACH_OF(n) {
    if (t_stride) t_i = ksl_vec3f_of_planes(t + i * t_stride, t_plane);
    const ksl_screwf_t si_i = ksl_screwf_of_planes(si + i * si_stride, si_plane);
    ksl_screwf_t so_i;
    ksl_product_Adtsinvf(&t_i, &si_i, &so_i);
    ksl_screwf_to_planes(&so_i, so + i * so_stride, so_plane);
  }
}

/* ksl_product_Adrsf of n elements. */
static KSL_INLINED void ksl_product_Adrsf_many(ptrdiff_t n, const ksl_mat3x3f_t *R,
    ptrdiff_t R_stride, const ksl_screwf_t *si, ptrdiff_t si_stride,
    ksl_screwf_t *so, ptrdiff_t so_stride) {
  KSL_EACH_OF(n) {
    ksl_product_Adrsf(R + i * R_stride, si + i * si_stride, so + i * so_stride);
  }
}

static KSL_INLINED void ksl_product_Adrsf_planes(ptrdiff_t n, const float *R, ptrdiff_t R_plane,
    ptrdiff_t R_stride, const float *si, ptrdiff_t si_plane, ptrdiff_t si_stride,
    float *so, ptrdiff_t so_plane, ptrdiff_t so_stride) {
  ksl_mat3x3f_t R_i;
  if (n > 0) R_i = ksl_mat3x3f_of_planes(R, R_plane);
  KSL_EACH_OF(n) {
    if (R_stride) R_i = ksl_mat3x3f_of_planes(R + i * R_stride, R_plane);
    const ksl_screwf_t si_i = ksl_screwf_of_planes(si + i * si_stride, si_plane);
    ksl_screwf_t so_i;
    ksl_product_Adrsf(&R_i, &si_i, &so_i);
    ksl_screwf_to_planes(&so_i, so + i * so_stride, so_plane);
  }
}

/* ksl_product_Adrinvsf of n elements. */
static KSL_INLINED void ksl_product_Adrinvsf_many(ptrdiff_t n, const ksl_mat3x3f_t *R,
    ptrdiff_t R_stride, const ksl_screwf_t *si, ptrdiff_t si_stride,
    ksl_screwf_t *so, ptrdiff_t so_stride) {
  KSL_EACH_OF(n) {
    ksl_product_Adrinvsf(R + i * R_stride, si + i * si_stride, so + i * so_stride);
  }
}

static KSL_INLINED void ksl_product_Adrinvsf_planes(ptrdiff_t n, const float *R, ptrdiff_t R_plane,
    ptrdiff_t R_stride, const float *si, ptrdiff_t si_plane, ptrdiff_t si_stride,
    float *so, ptrdiff_t so_plane, ptrdiff_t so_stride) {
  ksl_mat3x3f_t R_i;
  if (n > 0) R_i = ksl_mat3x3f_of_planes(R, R_plane);
  KSL_EACH_OF(n) {
    if (R_stride) R_i = ksl_mat3x3f_of_planes(R + i * R_stride, R_plane);
    const ksl_screwf_t si_i = ksl_screwf_of_planes(si + i * si_stride, si_plane);
    ksl_screwf_t so_i;
    ksl_product_Adrinvsf(&R_i, &si_i, &so_i);
    ksl_screwf_to_planes(&so_i, so + i * so_stride, so_plane);
  }
}

/* ksl_product_Adrsinvf of n elements. */
static KSL_INLINED void ksl_product_Adrsinvf_many(ptrdiff_t n, const ksl_mat3x3f_t *R,
    ptrdiff_t R_stride, const ksl_screwf_t *si, ptrdiff_t si_stride,
    ksl_screwf_t *so, ptrdiff_t so_stride) {
  KSL_EACH_OF(n) {
    ksl_product_Adrsinvf(R + i * R_stride, si + i * si_stride, so + i * so_stride);
  }
}

static KSL_INLINED void ksl_product_Adrsinvf_planes(ptrdiff_t n, const float *R, ptrdiff_t R_plane,
    ptrdiff_t R_stride, const float *si, ptrdiff_t si_plane, ptrdiff_t si_stride,
    float *so, ptrdiff_t so_plane, ptrdiff_t so_stride) {
  ksl_mat3x3f_t R_i;
  if (n > 0) R_i = ksl_mat3x3f_of_planes(R, R_plane);
  KSL_EACH_OF(n) {
    if (R_stride) R_i = ksl_mat3x3f_of_planes(R + i * R_stride, R_plane);
    const ksl_screwf_t si_i = ksl_screwf_of_planes(si + i * si_stride, si_plane);
    ksl_screwf_t so_i;
    ksl_product_Adrsinvf(&R_i, &si_i, &so_i);
    ksl_screwf_to_planes(&so_i, so + i * so_stride, so_plane);
  }
}

/* ksl_product_Adsf of n elements. */
static KSL_INLINED void ksl_product_Adsf_many(ptrdiff_t n, const ksl_SE3f_t *D, ptrdiff_t D_stride,
    const ksl_screwf_t *si, ptrdiff_t si_stride, ksl_screwf_t *so,
    ptrdiff_t so_stride) {
  KSL_EACH_OF(n) {
    ksl_product_Adsf(D + i * D_stride, si + i * si_stride, so + i * so_stride);
  }
}

static KSL_INLINED void ksl_product_Adsf_planes(ptrdiff_t n, const float *D, ptrdiff_t D_plane,
    ptrdiff_t D_stride, const float *si, ptrdiff_t si_plane, ptrdiff_t si_stride,
    float *so, ptrdiff_t so_plane, ptrdiff_t so_stride) {
  ksl_SE3f_t D_i;
  if (n > 0) D_i = ksl_SE3f_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3f_of_planes(D + i * D_stride, D_plane);
    const ksl_screwf_t si_i = ksl_screwf_of_planes(si + i * si_stride, si_plane);
    ksl_screwf_t so_i;
    ksl_product_Adsf(&D_i, &si_i, &so_i);
    ksl_screwf_to_planes(&so_i, so + i * so_stride, so_plane);
  }
}

/* ksl_product_Adinvsf of n elements. */
static KSL_INLINED void ksl_product_Adinvsf_many(ptrdiff_t n, const ksl_SE3f_t *D,
    ptrdiff_t D_stride, const ksl_screwf_t *si, ptrdiff_t si_stride,
    ksl_screwf_t *so, ptrdiff_t so_stride) {
  KSL_EACH_OF(n) {
    ksl_product_Adinvsf(D + i * D_stride, si + i * si_stride, so + i * so_stride);
  }
}

static KSL_INLINED void ksl_product_Adinvsf_planes(ptrdiff_t n, const float *D, ptrdiff_t D_plane,
    ptrdiff_t D_stride, const float *si, ptrdiff_t si_plane, ptrdiff_t si_stride,
    float *so, ptrdiff_t so_plane, ptrdiff_t so_stride) {
  ksl_SE3f_t D_i;
  if (n > 0) D_i = ksl_SE3f_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3f_of_planes(D + i * D_stride, D_plane);
    const ksl_screwf_t si_i = ksl_screwf_of_planes(si + i * si_stride, si_plane);
    ksl_screwf_t so_i;
    ksl_product_Adinvsf(&D_i, &si_i, &so_i);
    ksl_screwf_to_planes(&so_i, so + i * so_stride, so_plane);
  }
}

/* ksl_product_Adsinvf of n elements. */
static KSL_INLINED void ksl_product_Adsinvf_many(ptrdiff_t n, const ksl_SE3f_t *D,
    ptrdiff_t D_stride, const ksl_screwf_t *si, ptrdiff_t si_stride,
    ksl_screwf_t *so, ptrdiff_t so_stride) {
  KSL_EACH_OF(n) {
    ksl_product_Adsinvf(D + i * D_stride, si + i * si_stride, so + i * so_stride);
  }
}

static KSL_INLINED void ksl_product_Adsinvf_planes(ptrdiff_t n, const float *D, ptrdiff_t D_plane,
    ptrdiff_t D_stride, const float *si, ptrdiff_t si_plane, ptrdiff_t si_stride,
    float *so, ptrdiff_t so_plane, ptrdiff_t so_stride) {
  ksl_SE3f_t D_i;
  if (n > 0) D_i = ksl_SE3f_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3f_of_planes(D + i * D_stride, D_plane);
    const ksl_screwf_t si_i = ksl_screwf_of_planes(si + i * si_stride, si_plane);
    ksl_screwf_t so_i;
    ksl_product_Adsinvf(&D_i, &si_i, &so_i);
    ksl_screwf_to_planes(&so_i, so + i * so_stride, so_plane);
  }
}

/* ksl_hstxf of n elements. */
static KSL_INLINED void ksl_hstxf_many(ptrdiff_t n, const ksl_SE3f_t *D, ptrdiff_t D_stride,
    ksl_screwf_t *so, ptrdiff_t so_stride) {
  KSL_EACH_OF(n) {
    ksl_hstxf(D + i * D_stride, so + i * so_stride);
  }
}

static KSL_INLINED void ksl_hstxf_planes(ptrdiff_t n, const float *D, ptrdiff_t D_plane,
    ptrdiff_t D_stride, float *so, ptrdiff_t so_plane, ptrdiff_t so_stride) {
  ksl_SE3f_t D_i;
  if (n > 0) D_i = ksl_SE3f_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3f_of_planes(D + i * D_stride, D_plane);
    ksl_screwf_t so_i;
    ksl_hstxf(&D_i, &so_i);
    ksl_screwf_to_planes(&so_i, so + i * so_stride, so_plane);
  }
}

/* ksl_hstyf of n elements. */
static KSL_INLINED void ksl_hstyf_many(ptrdiff_t n, const ksl_SE3f_t *D, ptrdiff_t D_stride,
    ksl_screwf_t *so, ptrdiff_t so_stride) {
  KSL_EACH_OF(n) {
    ksl_hstyf(D + i * D_stride, so + i * so_stride);
  }
}

static KSL_INLINED void ksl_hstyf_planes(ptrdiff_t n, const float *D, ptrdiff_t D_plane,
    ptrdiff_t D_stride, float *so, ptrdiff_t so_plane, ptrdiff_t so_stride) {
  ksl_SE3f_t D_i;
  if (n > 0) D_i = ksl_SE3f_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3f_of_planes(D + i * D_stride, D_plane);
    ksl_screwf_t so_i;
    ksl_hstyf(&D_i, &so_i);
    ksl_screwf_to_planes(&so_i, so + i * so_stride, so_plane);
  }
}

/* ksl_hstzf of n elements. */
static KSL_INLINED void ksl_hstzf_many(ptrdiff_t n, const ksl_SE3f_t *D, ptrdiff_t D_stride,
    ksl_screwf_t *so, ptrdiff_t so_stride) {
  KSL_EACH_OF(n) {
    ksl_hstzf(D + i * D_stride, so + i * so_stride);
  }
}

static KSL_INLINED void ksl_hstzf_planes(ptrdiff_t n, const float *D, ptrdiff_t D_plane,
    ptrdiff_t D_stride, float *so, ptrdiff_t so_plane, ptrdiff_t so_stride) {
  ksl_SE3f_t D_i;
  if (n > 0) D_i = ksl_SE3f_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3f_of_planes(D + i * D_stride, D_plane);
    ksl_screwf_t so_i;
    ksl_hstzf(&D_i, &so_i);
    ksl_screwf_to_planes(&so_i, so + i * so_stride, so_plane);
  }
}

/* ksl_hsrxf of n elements. */
static KSL_INLINED void ksl_hsrxf_many(ptrdiff_t n, const ksl_SE3f_t *D, ptrdiff_t D_stride,
    ksl_screwf_t *so, ptrdiff_t so_stride) {
  KSL_EACH_OF(n) {
    ksl_hsrxf(D + i * D_stride, so + i * so_stride);
  }
}

static KSL_INLINED void ksl_hsrxf_planes(ptrdiff_t n, const float *D, ptrdiff_t D_plane,
    ptrdiff_t D_stride, float *so, ptrdiff_t so_plane, ptrdiff_t so_stride) {
  ksl_SE3f_t D_i;
  if (n > 0) D_i = ksl_SE3f_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3f_of_planes(D + i * D_stride, D_plane);
    ksl_screwf_t so_i;
    ksl_hsrxf(&D_i, &so_i);
    ksl_screwf_to_planes(&so_i, so + i * so_stride, so_plane);
  }
}

/* ksl_hsryf of n elements. */
static KSL_INLINED void ksl_hsryf_many(ptrdiff_t n, const ksl_SE3f_t *D, ptrdiff_t D_stride,
    ksl_screwf_t *so, ptrdiff_t so_stride) {
  KSL_EACH_OF(n) {
    ksl_hsryf(D + i * D_stride, so + i * so_stride);
  }
}

static KSL_INLINED void ksl_hsryf_planes(ptrdiff_t n, const float *D, ptrdiff_t D_plane,
    ptrdiff_t D_stride, float *so, ptrdiff_t so_plane, ptrdiff_t so_stride) {
  ksl_SE3f_t D_i;
  if (n > 0) D_i = ksl_SE3f_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3f_of_planes(D + i * D_stride, D_plane);
    ksl_screwf_t so_i;
    ksl_hsryf(&D_i, &so_i);
    ksl_screwf_to_planes(&so_i, so + i * so_stride, so_plane);
  }
}

/* ksl_hsrzf of n elements. */
static KSL_INLINED void ksl_hsrzf_many(ptrdiff_t n, const ksl_SE3f_t *D, ptrdiff_t D_stride,
    ksl_screwf_t *so, ptrdiff_t so_stride) {
  KSL_EACH_OF(n) {
    ksl_hsrzf(D + i * D_stride, so + i * so_stride);
  }
}

static KSL_INLINED void ksl_hsrzf_planes(ptrdiff_t n, const float *D, ptrdiff_t D_plane,
    ptrdiff_t D_stride, float *so, ptrdiff_t so_plane, ptrdiff_t so_stride) {
  ksl_SE3f_t D_i;
  if (n > 0) D_i = ksl_SE3f_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3f_of_planes(D + i * D_stride, D_plane);
    ksl_screwf_t so_i;
    ksl_hsrzf(&D_i, &so_i);
    ksl_screwf_to_planes(&so_i, so + i * so_stride, so_plane);
  }
}

/* ksl_hstxinvf of n elements. */
static KSL_INLINED void ksl_hstxinvf_many(ptrdiff_t n, const ksl_SE3f_t *D, ptrdiff_t D_stride,
    ksl_screwf_t *so, ptrdiff_t so_stride) {
  KSL_EACH_OF(n) {
    ksl_hstxinvf(D + i * D_stride, so + i * so_stride);
  }
}

static KSL_INLINED void ksl_hstxinvf_planes(ptrdiff_t n, const float *D, ptrdiff_t D_plane,
    ptrdiff_t D_stride, float *so, ptrdiff_t so_plane, ptrdiff_t so_stride) {
  ksl_SE3f_t D_i;
  if (n > 0) D_i = ksl_SE3f_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3f_of_planes(D + i * D_stride, D_plane);
    ksl_screwf_t so_i;
    ksl_hstxinvf(&D_i, &so_i);
    ksl_screwf_to_planes(&so_i, so + i * so_stride, so_plane);
  }
}

/* ksl_hstyinvf of n elements. */
static KSL_INLINED void ksl_hstyinvf_many(ptrdiff_t n, const ksl_SE3f_t *D, ptrdiff_t D_stride,
    ksl_screwf_t *so, ptrdiff_t so_stride) {
  KSL_EACH_OF(n) {
    ksl_hstyinvf(D + i * D_stride, so + i * so_stride);
  }
}

static KSL_INLINED void ksl_hstyinvf_planes(ptrdiff_t n, const float *D, ptrdiff_t D_plane,
    ptrdiff_t D_stride, float *so, ptrdiff_t so_plane, ptrdiff_t so_stride) {
  ksl_SE3f_t D_i;
  if (n > 0) D_i = ksl_SE3f_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3f_of_planes(D + i * D_stride, D_plane);
    ksl_screwf_t so_i;
    ksl_hstyinvf(&D_i, &so_i);
    ksl_screwf_to_planes(&so_i, so + i * so_stride, so_plane);
  }
}

/* ksl_hstzinvf of n elements. */
static KSL_INLINED void ksl_hstzinvf_many(ptrdiff_t n, const ksl_SE3f_t *D, ptrdiff_t D_stride,
    ksl_screwf_t *so, ptrdiff_t so_stride) {
  KSL_EACH_OF(n) {
    ksl_hstzinvf(D + i * D_stride, so + i * so_stride);
  }
}

static KSL_INLINED void ksl_hstzinvf_planes(ptrdiff_t n, const float *D, ptrdiff_t D_plane,
    ptrdiff_t D_stride, float *so, ptrdiff_t so_plane, ptrdiff_t so_stride) {
  ksl_SE3f_t D_i;
  if (n > 0) D_i = ksl_SE3f_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3f_of_planes(D + i * D_stride, D_plane);
    ksl_screwf_t so_i;
    ksl_hstzinvf(&D_i, &so_i);
    ksl_screwf_to_planes(&so_i, so + i * so_stride, so_plane);
  }
}

/* ksl_hsrxinvf of n elements. */
static KSL_INLINED void ksl_hsrxinvf_many(ptrdiff_t n, const ksl_SE3f_t *D, ptrdiff_t D_stride,
    ksl_screwf_t *so, ptrdiff_t so_stride) {
  KSL_EACH_OF(n) {
    ksl_hsrxinvf(D + i * D_stride, so + i * so_stride);
  }
}

static KSL_INLINED void ksl_hsrxinvf_planes(ptrdiff_t n, const float *D, ptrdiff_t D_plane,
    ptrdiff_t D_stride, float *so, ptrdiff_t so_plane, ptrdiff_t so_stride) {
  ksl_SE3f_t D_i;
  if (n > 0) D_i = ksl_SE3f_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3f_of_planes(D + i * D_stride, D_plane);
    ksl_screwf_t so_i;
    ksl_hsrxinvf(&D_i, &so_i);
    ksl_screwf_to_planes(&so_i, so + i * so_stride, so_plane);
  }
}

/* ksl_hsryinvf of n elements. */
static KSL_INLINED void ksl_hsryinvf_many(ptrdiff_t n, const ksl_SE3f_t *D, ptrdiff_t D_stride,
    ksl_screwf_t *so, ptrdiff_t so_stride) {
  KSL_EACH_OF(n) {
    ksl_hsryinvf(D + i * D_stride, so + i * so_stride);
  }
}

static KSL_INLINED void ksl_hsryinvf_planes(ptrdiff_t n, const float *D, ptrdiff_t D_plane,
    ptrdiff_t D_stride, float *so, ptrdiff_t so_plane, ptrdiff_t so_stride) {
  ksl_SE3f_t D_i;
  if (n > 0) D_i = ksl_SE3f_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3f_of_planes(D + i * D_stride, D_plane);
    ksl_screwf_t so_i;
    ksl_hsryinvf(&D_i, &so_i);
    ksl_screwf_to_planes(&so_i, so + i * so_stride, so_plane);
  }
}

/* ksl_hsrzinvf of n elements. */
static KSL_INLINED void ksl_hsrzinvf_many(ptrdiff_t n, const ksl_SE3f_t *D, ptrdiff_t D_stride,
    ksl_screwf_t *so, ptrdiff_t so_stride) {
  KSL_EACH_OF(n) {
    ksl_hsrzinvf(D + i * D_stride, so + i * so_stride);
  }
}

static KSL_INLINED void ksl_hsrzinvf_planes(ptrdiff_t n, const float *D, ptrdiff_t D_plane,
    ptrdiff_t D_stride, float *so, ptrdiff_t so_plane, ptrdiff_t so_stride) {
  ksl_SE3f_t D_i;
  if (n > 0) D_i = ksl_SE3f_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3f_of_planes(D + i * D_stride, D_plane);
    ksl_screwf_t so_i;
    ksl_hsrzinvf(&D_i, &so_i);
    ksl_screwf_to_planes(&so_i, so + i * so_stride, so_plane);
  }
}

/* ksl_Adf of n elements. */
static KSL_INLINED void ksl_Adf_many(ptrdiff_t n, const ksl_SE3f_t *D, ptrdiff_t D_stride,
    ksl_mat6x6f_t *M, ptrdiff_t M_stride) {
  KSL_EACH_OF(n) {
    ksl_Adf(D + i * D_stride, M + i * M_stride);
  }
}

static KSL_INLINED void ksl_Adf_planes(ptrdiff_t n, const float *D, ptrdiff_t D_plane,
    ptrdiff_t D_stride, float *M, ptrdiff_t M_plane, ptrdiff_t M_stride) {
  ksl_SE3f_t D_i;
  if (n > 0) D_i = ksl_SE3f_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3f_of_planes(D + i * D_stride, D_plane);
    ksl_mat6x6f_t M_i;
    ksl_Adf(&D_i, &M_i);
    ksl_mat6x6f_to_planes(&M_i, M + i * M_stride, M_plane);
  }
}

/* ksl_dot_csf of n elements. */
static KSL_INLINED void ksl_dot_csf_many(ptrdiff_t n, const ksl_coscrewf_t *c, ptrdiff_t c_stride,
    const ksl_screwf_t *s, ptrdiff_t s_stride, float *power,
    ptrdiff_t power_stride) {
  KSL_EACH_OF(n) {
    power[i * power_stride] = ksl_dot_csf(c + i * c_stride, s + i * s_stride);
  }
}

static KSL_INLINED void ksl_dot_csf_planes(ptrdiff_t n, const float *c, ptrdiff_t c_plane,
    ptrdiff_t c_stride, const float *s, ptrdiff_t s_plane, ptrdiff_t s_stride,
    float *power, ptrdiff_t power_stride) {
  ksl_coscrewf_t c_i;
  if (n > 0) c_i = ksl_coscrewf_of_planes(c, c_plane);
  KSL_EACH_OF(n) {
    if (c_stride) c_i = ksl_coscrewf_of_planes(c + i * c_stride, c_plane);
    const ksl_screwf_t s_i = ksl_screwf_of_planes(s + i * s_stride, s_plane);
    power[i * power_stride] = ksl_dot_csf(&c_i, &s_i);
  }
}

/* ksl_cross_ssf of n elements. */
static KSL_INLINED void ksl_cross_ssf_many(ptrdiff_t n, const ksl_screwf_t *s1, ptrdiff_t s1_stride,
    const ksl_screwf_t *s2, ptrdiff_t s2_stride, ksl_screwf_t *so,
    ptrdiff_t so_stride) {
  KSL_EACH_OF(n) {
    ksl_cross_ssf(s1 + i * s1_stride, s2 + i * s2_stride, so + i * so_stride);
  }
}

static KSL_INLINED void ksl_cross_ssf_planes(ptrdiff_t n, const float *s1, ptrdiff_t s1_plane,
    ptrdiff_t s1_stride, const float *s2, ptrdiff_t s2_plane,
    ptrdiff_t s2_stride, float *so, ptrdiff_t so_plane, ptrdiff_t so_stride) {
  ksl_screwf_t s1_i;
  if (n > 0) s1_i = ksl_screwf_of_planes(s1, s1_plane);
  KSL_EACH_OF(n) {
    if (s1_stride) s1_i = ksl_screwf_of_planes(s1 + i * s1_stride, s1_plane);
    const ksl_screwf_t s2_i = ksl_screwf_of_planes(s2 + i * s2_stride, s2_plane);
    ksl_screwf_t so_i;
    ksl_cross_ssf(&s1_i, &s2_i, &so_i);
    ksl_screwf_to_planes(&so_i, so + i * so_stride, so_plane);
  }
}

/* ksl_cross_sstf of n elements. */
static KSL_INLINED void ksl_cross_sstf_many(ptrdiff_t n, const ksl_screwf_t *s1,
    ptrdiff_t s1_stride, const ksl_screwf_t *s2, ptrdiff_t s2_stride,
    ksl_screwf_t *so, ptrdiff_t so_stride) {
  KSL_EACH_OF(n) {
    ksl_cross_sstf(s1 + i * s1_stride, s2 + i * s2_stride, so + i * so_stride);
  }
}

static KSL_INLINED void ksl_cross_sstf_planes(ptrdiff_t n, const float *s1, ptrdiff_t s1_plane,
    ptrdiff_t s1_stride, const float *s2, ptrdiff_t s2_plane,
    ptrdiff_t s2_stride, float *so, ptrdiff_t so_plane, ptrdiff_t so_stride) {
  ksl_screwf_t s1_i;
  if (n > 0) s1_i = ksl_screwf_of_planes(s1, s1_plane);
  KSL_EACH_OF(n) {
    if (s1_stride) s1_i = ksl_screwf_of_planes(s1 + i * s1_stride, s1_plane);
    const ksl_screwf_t s2_i = ksl_screwf_of_planes(s2 + i * s2_stride, s2_plane);
    ksl_screwf_t so_i;
    ksl_cross_sstf(&s1_i, &s2_i, &so_i);
    ksl_screwf_to_planes(&so_i, so + i * so_stride, so_plane);
  }
}

/* ksl_hsraf of n elements. */
static KSL_INLINED void ksl_hsraf_many(ptrdiff_t n, const ksl_SE3f_t *D, ptrdiff_t D_stride,
    const ksl_vec3f_t *axis, ptrdiff_t axis_stride, ksl_screwf_t *so,
    ptrdiff_t so_stride) {
  KSL_EACH_OF(n) {
    ksl_hsraf(D + i * D_stride, axis + i * axis_stride, so + i * so_stride);
  }
}

static KSL_INLINED void ksl_hsraf_planes(ptrdiff_t n, const float *D, ptrdiff_t D_plane,
    ptrdiff_t D_stride, const float *axis, ptrdiff_t axis_plane,
    ptrdiff_t axis_stride, float *so, ptrdiff_t so_plane, ptrdiff_t so_stride) {
  ksl_SE3f_t D_i;
  if (n > 0) D_i = ksl_SE3f_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3f_of_planes(D + i * D_stride, D_plane);
    const ksl_vec3f_t axis_i = ksl_vec3f_of_planes(axis + i * axis_stride, axis_plane);
    ksl_screwf_t so_i;
    ksl_hsraf(&D_i, &axis_i, &so_i);
    ksl_screwf_to_planes(&so_i, so + i * so_stride, so_plane);
  }
}

/* ksl_hstaf of n elements. */
static KSL_INLINED void ksl_hstaf_many(ptrdiff_t n, const ksl_SE3f_t *D, ptrdiff_t D_stride,
    const ksl_vec3f_t *axis, ptrdiff_t axis_stride, ksl_screwf_t *so,
    ptrdiff_t so_stride) {
  KSL_EACH_OF(n) {
    ksl_hstaf(D + i * D_stride, axis + i * axis_stride, so + i * so_stride);
  }
}

static KSL_INLINED void ksl_hstaf_planes(ptrdiff_t n, const float *D, ptrdiff_t D_plane,
    ptrdiff_t D_stride, const float *axis, ptrdiff_t axis_plane,
    ptrdiff_t axis_stride, float *so, ptrdiff_t so_plane, ptrdiff_t so_stride) {
  ksl_SE3f_t D_i;
  if (n > 0) D_i = ksl_SE3f_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3f_of_planes(D + i * D_stride, D_plane);
    const ksl_vec3f_t axis_i = ksl_vec3f_of_planes(axis + i * axis_stride, axis_plane);
    ksl_screwf_t so_i;
    ksl_hstaf(&D_i, &axis_i, &so_i);
    ksl_screwf_to_planes(&so_i, so + i * so_stride, so_plane);
  }
}

/* ksl_hsrainvf of n elements. */
static KSL_INLINED void ksl_hsrainvf_many(ptrdiff_t n, const ksl_SE3f_t *D, ptrdiff_t D_stride,
    const ksl_vec3f_t *axis, ptrdiff_t axis_stride, ksl_screwf_t *so,
    ptrdiff_t so_stride) {
  KSL_EACH_OF(n) {
    ksl_hsrainvf(D + i * D_stride, axis + i * axis_stride, so + i * so_stride);
  }
}

static KSL_INLINED void ksl_hsrainvf_planes(ptrdiff_t n, const float *D, ptrdiff_t D_plane,
    ptrdiff_t D_stride, const float *axis, ptrdiff_t axis_plane,
    ptrdiff_t axis_stride, float *so, ptrdiff_t so_plane, ptrdiff_t so_stride) {
  ksl_SE3f_t D_i;
  if (n > 0) D_i = ksl_SE3f_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3f_of_planes(D + i * D_stride, D_plane);
    const ksl_vec3f_t axis_i = ksl_vec3f_of_planes(axis + i * axis_stride, axis_plane);
    ksl_screwf_t so_i;
    ksl_hsrainvf(&D_i, &axis_i, &so_i);
    ksl_screwf_to_planes(&so_i, so + i * so_stride, so_plane);
  }
}

/* ksl_hstainvf of n elements. */
static KSL_INLINED void ksl_hstainvf_many(ptrdiff_t n, const ksl_SE3f_t *D, ptrdiff_t D_stride,
    const ksl_vec3f_t *axis, ptrdiff_t axis_stride, ksl_screwf_t *so,
    ptrdiff_t so_stride) {
  KSL_EACH_OF(n) {
    ksl_hstainvf(D + i * D_stride, axis + i * axis_stride, so + i * so_stride);
  }
}

static KSL_INLINED void ksl_hstainvf_planes(ptrdiff_t n, const float *D, ptrdiff_t D_plane,
    ptrdiff_t D_stride, const float *axis, ptrdiff_t axis_plane,
    ptrdiff_t axis_stride, float *so, ptrdiff_t so_plane, ptrdiff_t so_stride) {
  ksl_SE3f_t D_i;
  if (n > 0) D_i = ksl_SE3f_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3f_of_planes(D + i * D_stride, D_plane);
    const ksl_vec3f_t axis_i = ksl_vec3f_of_planes(axis + i * axis_stride, axis_plane);
    ksl_screwf_t so_i;
    ksl_hstainvf(&D_i, &axis_i, &so_i);
    ksl_screwf_to_planes(&so_i, so + i * so_stride, so_plane);
  }
}

/* ksl_adf of n elements. */
static KSL_INLINED void ksl_adf_many(ptrdiff_t n, const ksl_screwf_t *s, ptrdiff_t s_stride,
    ksl_mat6x6f_t *M, ptrdiff_t M_stride) {
  KSL_EACH_OF(n) {
    ksl_adf(s + i * s_stride, M + i * M_stride);
  }
}

static KSL_INLINED void ksl_adf_planes(ptrdiff_t n, const float *s, ptrdiff_t s_plane,
    ptrdiff_t s_stride, float *M, ptrdiff_t M_plane, ptrdiff_t M_stride) {
  ksl_screwf_t s_i;
  if (n > 0) s_i = ksl_screwf_of_planes(s, s_plane);
  KSL_EACH_OF(n) {
    if (s_stride) s_i = ksl_screwf_of_planes(s + i * s_stride, s_plane);
    ksl_mat6x6f_t M_i;
    ksl_adf(&s_i, &M_i);
    ksl_mat6x6f_to_planes(&M_i, M + i * M_stride, M_plane);
  }
}

#endif
