/* Made by `coscrew generate`; changes are overwritten. */
/* SPDX-License-Identifier: MIT */
/* coscrew 0.2.0.  Copyright (c) 2026 The coscrew authors. */
/* Coscrews: wrenches and momenta, c = (f; τ).  Many at a time.
   What arguments are, and what loops over them cost, ksl_planes.h says. */
#ifndef KSL_COSCREW_MANY_H
#define KSL_COSCREW_MANY_H

#include "coscrew.h"
#include "ksl_planes.h"

/* ksl_coscrew_copy of n elements. */
static KSL_INLINED void ksl_coscrew_copy_many(ptrdiff_t n, const ksl_coscrew_t *ci,
    ptrdiff_t ci_stride, ksl_coscrew_t *co, ptrdiff_t co_stride) {
  KSL_EACH_OF(n) {
    ksl_coscrew_copy(ci + i * ci_stride, co + i * co_stride);
  }
}

static KSL_INLINED void ksl_coscrew_copy_planes(ptrdiff_t n, const double *ci, ptrdiff_t ci_plane,
    ptrdiff_t ci_stride, double *co, ptrdiff_t co_plane, ptrdiff_t co_stride) {
  ksl_coscrew_t ci_i;
  if (n > 0) ci_i = ksl_coscrew_of_planes(ci, ci_plane);
  KSL_EACH_OF(n) {
    if (ci_stride) ci_i = ksl_coscrew_of_planes(ci + i * ci_stride, ci_plane);
    ksl_coscrew_t co_i;
    ksl_coscrew_copy(&ci_i, &co_i);
    ksl_coscrew_to_planes(&co_i, co + i * co_stride, co_plane);
  }
}

/* ksl_coscrew_scale of n elements. */
static KSL_INLINED void ksl_coscrew_scale_many(ptrdiff_t n, ksl_coscrew_t *self,
    ptrdiff_t self_stride, const double *a, ptrdiff_t a_stride) {
  KSL_EACH_OF(n) {
    ksl_coscrew_scale(self + i * self_stride, a[i * a_stride]);
  }
}

static KSL_INLINED void ksl_coscrew_scale_planes(ptrdiff_t n, double *self, ptrdiff_t self_plane,
    ptrdiff_t self_stride, const double *a, ptrdiff_t a_stride) {
  KSL_EACH_OF(n) {
    ksl_coscrew_t self_i = ksl_coscrew_of_planes(self + i * self_stride, self_plane);
    ksl_coscrew_scale(&self_i, a[i * a_stride]);
    ksl_coscrew_to_planes(&self_i, self + i * self_stride, self_plane);
  }
}

/* ksl_coscrew_inverted of n elements. */
static KSL_INLINED void ksl_coscrew_inverted_many(ptrdiff_t n, const ksl_coscrew_t *ci,
    ptrdiff_t ci_stride, ksl_coscrew_t *co, ptrdiff_t co_stride) {
  KSL_EACH_OF(n) {
    ksl_coscrew_inverted(ci + i * ci_stride, co + i * co_stride);
  }
}

static KSL_INLINED void ksl_coscrew_inverted_planes(ptrdiff_t n, const double *ci,
    ptrdiff_t ci_plane, ptrdiff_t ci_stride, double *co, ptrdiff_t co_plane,
    ptrdiff_t co_stride) {
  ksl_coscrew_t ci_i;
  if (n > 0) ci_i = ksl_coscrew_of_planes(ci, ci_plane);
  KSL_EACH_OF(n) {
    if (ci_stride) ci_i = ksl_coscrew_of_planes(ci + i * ci_stride, ci_plane);
    ksl_coscrew_t co_i;
    ksl_coscrew_inverted(&ci_i, &co_i);
    ksl_coscrew_to_planes(&co_i, co + i * co_stride, co_plane);
  }
}

/* ksl_coscrew_invert of n elements. */
static KSL_INLINED void ksl_coscrew_invert_many(ptrdiff_t n, ksl_coscrew_t *self,
    ptrdiff_t self_stride) {
  KSL_EACH_OF(n) {
    ksl_coscrew_invert(self + i * self_stride);
  }
}

static KSL_INLINED void ksl_coscrew_invert_planes(ptrdiff_t n, double *self, ptrdiff_t self_plane,
    ptrdiff_t self_stride) {
  KSL_EACH_OF(n) {
    ksl_coscrew_t self_i = ksl_coscrew_of_planes(self + i * self_stride, self_plane);
    ksl_coscrew_invert(&self_i);
    ksl_coscrew_to_planes(&self_i, self + i * self_stride, self_plane);
  }
}

/* ksl_axpy_cc of n elements. */
static KSL_INLINED void ksl_axpy_cc_many(ptrdiff_t n, const double *a, ptrdiff_t a_stride,
    const ksl_coscrew_t *x, ptrdiff_t x_stride, ksl_coscrew_t *y,
    ptrdiff_t y_stride) {
  KSL_EACH_OF(n) {
    ksl_axpy_cc(a[i * a_stride], x + i * x_stride, y + i * y_stride);
  }
}

static KSL_INLINED void ksl_axpy_cc_planes(ptrdiff_t n, const double *a, ptrdiff_t a_stride,
    const double *x, ptrdiff_t x_plane, ptrdiff_t x_stride, double *y,
    ptrdiff_t y_plane, ptrdiff_t y_stride) {
  KSL_EACH_OF(n) {
    const ksl_coscrew_t x_i = ksl_coscrew_of_planes(x + i * x_stride, x_plane);
    ksl_coscrew_t y_i = ksl_coscrew_of_planes(y + i * y_stride, y_plane);
    ksl_axpy_cc(a[i * a_stride], &x_i, &y_i);
    ksl_coscrew_to_planes(&y_i, y + i * y_stride, y_plane);
  }
}

/* ksl_xpy_cc of n elements. */
static KSL_INLINED void ksl_xpy_cc_many(ptrdiff_t n, const ksl_coscrew_t *x, ptrdiff_t x_stride,
    ksl_coscrew_t *y, ptrdiff_t y_stride) {
  KSL_EACH_OF(n) {
    ksl_xpy_cc(x + i * x_stride, y + i * y_stride);
  }
}

static KSL_INLINED void ksl_xpy_cc_planes(ptrdiff_t n, const double *x, ptrdiff_t x_plane,
    ptrdiff_t x_stride, double *y, ptrdiff_t y_plane, ptrdiff_t y_stride) {
  ksl_coscrew_t x_i;
  if (n > 0) x_i = ksl_coscrew_of_planes(x, x_plane);
  KSL_EACH_OF(n) {
    if (x_stride) x_i = ksl_coscrew_of_planes(x + i * x_stride, x_plane);
    ksl_coscrew_t y_i = ksl_coscrew_of_planes(y + i * y_stride, y_plane);
    ksl_xpy_cc(&x_i, &y_i);
    ksl_coscrew_to_planes(&y_i, y + i * y_stride, y_plane);
  }
}

/* ksl_nxpy_cc of n elements. */
static KSL_INLINED void ksl_nxpy_cc_many(ptrdiff_t n, const ksl_coscrew_t *x, ptrdiff_t x_stride,
    ksl_coscrew_t *y, ptrdiff_t y_stride) {
  KSL_EACH_OF(n) {
    ksl_nxpy_cc(x + i * x_stride, y + i * y_stride);
  }
}

static KSL_INLINED void ksl_nxpy_cc_planes(ptrdiff_t n, const double *x, ptrdiff_t x_plane,
    ptrdiff_t x_stride, double *y, ptrdiff_t y_plane, ptrdiff_t y_stride) {
  ksl_coscrew_t x_i;
  if (n > 0) x_i = ksl_coscrew_of_planes(x, x_plane);
  KSL_EACH_OF(n) {
    if (x_stride) x_i = ksl_coscrew_of_planes(x + i * x_stride, x_plane);
    ksl_coscrew_t y_i = ksl_coscrew_of_planes(y + i * y_stride, y_plane);
    ksl_nxpy_cc(&x_i, &y_i);
    ksl_coscrew_to_planes(&y_i, y + i * y_stride, y_plane);
  }
}

/* ksl_product_ac of n elements. */
static KSL_INLINED void ksl_product_ac_many(ptrdiff_t n, const double *a, ptrdiff_t a_stride,
    const ksl_coscrew_t *ci, ptrdiff_t ci_stride, ksl_coscrew_t *co,
    ptrdiff_t co_stride) {
  KSL_EACH_OF(n) {
    ksl_product_ac(a[i * a_stride], ci + i * ci_stride, co + i * co_stride);
  }
}

static KSL_INLINED void ksl_product_ac_planes(ptrdiff_t n, const double *a, ptrdiff_t a_stride,
    const double *ci, ptrdiff_t ci_plane, ptrdiff_t ci_stride, double *co,
    ptrdiff_t co_plane, ptrdiff_t co_stride) {
  KSL_EACH_OF(n) {
    const ksl_coscrew_t ci_i = ksl_coscrew_of_planes(ci + i * ci_stride, ci_plane);
    ksl_coscrew_t co_i;
    ksl_product_ac(a[i * a_stride], &ci_i, &co_i);
    ksl_coscrew_to_planes(&co_i, co + i * co_stride, co_plane);
  }
}

/* ksl_add_cc of n elements. */
static KSL_INLINED void ksl_add_cc_many(ptrdiff_t n, const ksl_coscrew_t *c1, ptrdiff_t c1_stride,
    const ksl_coscrew_t *c2, ptrdiff_t c2_stride, ksl_coscrew_t *co,
    ptrdiff_t co_stride) {
  KSL_EACH_OF(n) {
    ksl_add_cc(c1 + i * c1_stride, c2 + i * c2_stride, co + i * co_stride);
  }
}

static KSL_INLINED void ksl_add_cc_planes(ptrdiff_t n, const double *c1, ptrdiff_t c1_plane,
    ptrdiff_t c1_stride, const double *c2, ptrdiff_t c2_plane,
    ptrdiff_t c2_stride, double *co, ptrdiff_t co_plane, ptrdiff_t co_stride) {
  ksl_coscrew_t c1_i;
  if (n > 0) c1_i = ksl_coscrew_of_planes(c1, c1_plane);
  KSL_EACH_OF(n) {
    if (c1_stride) c1_i = ksl_coscrew_of_planes(c1 + i * c1_stride, c1_plane);
    const ksl_coscrew_t c2_i = ksl_coscrew_of_planes(c2 + i * c2_stride, c2_plane);
    ksl_coscrew_t co_i;
    ksl_add_cc(&c1_i, &c2_i, &co_i);
    ksl_coscrew_to_planes(&co_i, co + i * co_stride, co_plane);
  }
}

/* ksl_subtract_cc of n elements. */
static KSL_INLINED void ksl_subtract_cc_many(ptrdiff_t n, const ksl_coscrew_t *c1,
    ptrdiff_t c1_stride, const ksl_coscrew_t *c2, ptrdiff_t c2_stride,
    ksl_coscrew_t *co, ptrdiff_t co_stride) {
  KSL_EACH_OF(n) {
    ksl_subtract_cc(c1 + i * c1_stride, c2 + i * c2_stride, co + i * co_stride);
  }
}

static KSL_INLINED void ksl_subtract_cc_planes(ptrdiff_t n, const double *c1, ptrdiff_t c1_plane,
    ptrdiff_t c1_stride, const double *c2, ptrdiff_t c2_plane,
    ptrdiff_t c2_stride, double *co, ptrdiff_t co_plane, ptrdiff_t co_stride) {
  ksl_coscrew_t c1_i;
  if (n > 0) c1_i = ksl_coscrew_of_planes(c1, c1_plane);
  KSL_EACH_OF(n) {
    if (c1_stride) c1_i = ksl_coscrew_of_planes(c1 + i * c1_stride, c1_plane);
    const ksl_coscrew_t c2_i = ksl_coscrew_of_planes(c2 + i * c2_stride, c2_plane);
    ksl_coscrew_t co_i;
    ksl_subtract_cc(&c1_i, &c2_i, &co_i);
    ksl_coscrew_to_planes(&co_i, co + i * co_stride, co_plane);
  }
}

/* ksl_coscrew_norm of n elements. */
static KSL_INLINED void ksl_coscrew_norm_many(ptrdiff_t n, const ksl_coscrew_t *ci,
    ptrdiff_t ci_stride, double *norm, ptrdiff_t norm_stride) {
  KSL_EACH_OF(n) {
    norm[i * norm_stride] = ksl_coscrew_norm(ci + i * ci_stride);
  }
}

static KSL_INLINED void ksl_coscrew_norm_planes(ptrdiff_t n, const double *ci, ptrdiff_t ci_plane,
    ptrdiff_t ci_stride, double *norm, ptrdiff_t norm_stride) {
  ksl_coscrew_t ci_i;
  if (n > 0) ci_i = ksl_coscrew_of_planes(ci, ci_plane);
  KSL_EACH_OF(n) {
    if (ci_stride) ci_i = ksl_coscrew_of_planes(ci + i * ci_stride, ci_plane);
    norm[i * norm_stride] = ksl_coscrew_norm(&ci_i);
  }
}

/* ksl_coscrew_normalize of n elements. */
static KSL_INLINED void ksl_coscrew_normalize_many(ptrdiff_t n, ksl_coscrew_t *self,
    ptrdiff_t self_stride) {
  KSL_EACH_OF(n) {
    ksl_coscrew_normalize(self + i * self_stride);
  }
}

static KSL_INLINED void ksl_coscrew_normalize_planes(ptrdiff_t n, double *self,
    ptrdiff_t self_plane, ptrdiff_t self_stride) {
  KSL_EACH_OF(n) {
    ksl_coscrew_t self_i = ksl_coscrew_of_planes(self + i * self_stride, self_plane);
    ksl_coscrew_normalize(&self_i);
    ksl_coscrew_to_planes(&self_i, self + i * self_stride, self_plane);
  }
}

/* ksl_coscrew_normalized of n elements. */
static KSL_INLINED void ksl_coscrew_normalized_many(ptrdiff_t n, const ksl_coscrew_t *ci,
    ptrdiff_t ci_stride, ksl_coscrew_t *co, ptrdiff_t co_stride) {
  KSL_EACH_OF(n) {
    ksl_coscrew_normalized(ci + i * ci_stride, co + i * co_stride);
  }
}

static KSL_INLINED void ksl_coscrew_normalized_planes(ptrdiff_t n, const double *ci,
    ptrdiff_t ci_plane, ptrdiff_t ci_stride, double *co, ptrdiff_t co_plane,
    ptrdiff_t co_stride) {
  ksl_coscrew_t ci_i;
  if (n > 0) ci_i = ksl_coscrew_of_planes(ci, ci_plane);
  KSL_EACH_OF(n) {
    if (ci_stride) ci_i = ksl_coscrew_of_planes(ci + i * ci_stride, ci_plane);
    ksl_coscrew_t co_i;
    ksl_coscrew_normalized(&ci_i, &co_i);
    ksl_coscrew_to_planes(&co_i, co + i * co_stride, co_plane);
  }
}

/* ksl_coscrew_from_lin_ang of n elements. */
static KSL_INLINED void ksl_coscrew_from_lin_ang_many(ptrdiff_t n, const ksl_vec3_t *lin,
    ptrdiff_t lin_stride, const ksl_vec3_t *ang, ptrdiff_t ang_stride,
    ksl_coscrew_t *co, ptrdiff_t co_stride) {
  KSL_EACH_OF(n) {
    ksl_coscrew_from_lin_ang(lin + i * lin_stride, ang + i * ang_stride, co + i * co_stride);
  }
}

static KSL_INLINED void ksl_coscrew_from_lin_ang_planes(ptrdiff_t n, const double *lin,
    ptrdiff_t lin_plane, ptrdiff_t lin_stride, const double *ang,
    ptrdiff_t ang_plane, ptrdiff_t ang_stride, double *co, ptrdiff_t co_plane,
    ptrdiff_t co_stride) {
  ksl_vec3_t lin_i;
  if (n > 0) lin_i = ksl_vec3_of_planes(lin, lin_plane);
  KSL_EACH_OF(n) {
    if (lin_stride) lin_i = ksl_vec3_of_planes(lin + i * lin_stride, lin_plane);
    const ksl_vec3_t ang_i = ksl_vec3_of_planes(ang + i * ang_stride, ang_plane);
    ksl_coscrew_t co_i;
    ksl_coscrew_from_lin_ang(&lin_i, &ang_i, &co_i);
    ksl_coscrew_to_planes(&co_i, co + i * co_stride, co_plane);
  }
}

/* ksl_coscrew_to_angular_first of n elements. */
static KSL_INLINED void ksl_coscrew_to_angular_first_many(ptrdiff_t n, const ksl_coscrew_t *ci,
    ptrdiff_t ci_stride, double *x, ptrdiff_t x_stride) {
  KSL_EACH_OF(n) {
    ksl_coscrew_to_angular_first(ci + i * ci_stride, x + 6 * i * x_stride);
  }
}

static KSL_INLINED void ksl_coscrew_to_angular_first_planes(ptrdiff_t n, const double *ci,
    ptrdiff_t ci_plane, ptrdiff_t ci_stride, double *x, ptrdiff_t x_plane,
    ptrdiff_t x_stride) {
  ksl_coscrew_t ci_i;
  if (n > 0) ci_i = ksl_coscrew_of_planes(ci, ci_plane);
  KSL_EACH_OF(n) {
    if (ci_stride) ci_i = ksl_coscrew_of_planes(ci + i * ci_stride, ci_plane);
    double x_i[6];
    ksl_coscrew_to_angular_first(&ci_i, x_i);
    x[0 + i * x_stride] = x_i[0];
    x[x_plane + i * x_stride] = x_i[1];
    x[2 * x_plane + i * x_stride] = x_i[2];
    x[3 * x_plane + i * x_stride] = x_i[3];
    x[4 * x_plane + i * x_stride] = x_i[4];
    x[5 * x_plane + i * x_stride] = x_i[5];
  }
}

/* ksl_coscrew_from_angular_first of n elements. */
static KSL_INLINED void ksl_coscrew_from_angular_first_many(ptrdiff_t n, const double *x,
    ptrdiff_t x_stride, ksl_coscrew_t *co, ptrdiff_t co_stride) {
  KSL_EACH_OF(n) {
    ksl_coscrew_from_angular_first(x + 6 * i * x_stride, co + i * co_stride);
  }
}

static KSL_INLINED void ksl_coscrew_from_angular_first_planes(ptrdiff_t n, const double *x,
    ptrdiff_t x_plane, ptrdiff_t x_stride, double *co, ptrdiff_t co_plane,
    ptrdiff_t co_stride) {
  KSL_EACH_OF(n) {
    const double x_i[6] = {x[0 + i * x_stride], x[x_plane + i * x_stride],
        x[2 * x_plane + i * x_stride], x[3 * x_plane + i * x_stride], x[4 * x_plane + i * x_stride],
        x[5 * x_plane + i * x_stride]};
    ksl_coscrew_t co_i;
    ksl_coscrew_from_angular_first(x_i, &co_i);
    ksl_coscrew_to_planes(&co_i, co + i * co_stride, co_plane);
  }
}

/* ksl_add_cct of n elements. */
static KSL_INLINED void ksl_add_cct_many(ptrdiff_t n, const ksl_coscrew_t *c1, ptrdiff_t c1_stride,
    const ksl_coscrew_t *c2, ptrdiff_t c2_stride, ksl_coscrew_t *co,
    ptrdiff_t co_stride) {
  KSL_EACH_OF(n) {
    ksl_add_cct(c1 + i * c1_stride, c2 + i * c2_stride, co + i * co_stride);
  }
}

static KSL_INLINED void ksl_add_cct_planes(ptrdiff_t n, const double *c1, ptrdiff_t c1_plane,
    ptrdiff_t c1_stride, const double *c2, ptrdiff_t c2_plane,
    ptrdiff_t c2_stride, double *co, ptrdiff_t co_plane, ptrdiff_t co_stride) {
  ksl_coscrew_t c1_i;
  if (n > 0) c1_i = ksl_coscrew_of_planes(c1, c1_plane);
  KSL_EACH_OF(n) {
    if (c1_stride) c1_i = ksl_coscrew_of_planes(c1 + i * c1_stride, c1_plane);
    const ksl_coscrew_t c2_i = ksl_coscrew_of_planes(c2 + i * c2_stride, c2_plane);
    ksl_coscrew_t co_i;
    ksl_add_cct(&c1_i, &c2_i, &co_i);
    ksl_coscrew_to_planes(&co_i, co + i * co_stride, co_plane);
  }
}

/* ksl_product_CoAdtc of n elements. */
static KSL_INLINED void ksl_product_CoAdtc_many(ptrdiff_t n, const ksl_vec3_t *t,
    ptrdiff_t t_stride, const ksl_coscrew_t *ci, ptrdiff_t ci_stride,
    ksl_coscrew_t *co, ptrdiff_t co_stride) {
  KSL_EACH_OF(n) {
    ksl_product_CoAdtc(t + i * t_stride, ci + i * ci_stride, co + i * co_stride);
  }
}

static KSL_INLINED void ksl_product_CoAdtc_planes(ptrdiff_t n, const double *t, ptrdiff_t t_plane,
    ptrdiff_t t_stride, const double *ci, ptrdiff_t ci_plane,
    ptrdiff_t ci_stride, double *co, ptrdiff_t co_plane, ptrdiff_t co_stride) {
  ksl_vec3_t t_i;
  if (n > 0) t_i = ksl_vec3_of_planes(t, t_plane);
  KSL_EACH_OF(n) {
    if (t_stride) t_i = ksl_vec3_of_planes(t + i * t_stride, t_plane);
    const ksl_coscrew_t ci_i = ksl_coscrew_of_planes(ci + i * ci_stride, ci_plane);
    ksl_coscrew_t co_i;
    ksl_product_CoAdtc(&t_i, &ci_i, &co_i);
    ksl_coscrew_to_planes(&co_i, co + i * co_stride, co_plane);
  }
}

/* ksl_product_CoAdtinvc of n elements. */
static KSL_INLINED void ksl_product_CoAdtinvc_many(ptrdiff_t n, const ksl_vec3_t *t,
    ptrdiff_t t_stride, const ksl_coscrew_t *ci, ptrdiff_t ci_stride,
    ksl_coscrew_t *co, ptrdiff_t co_stride) {
  KSL_EACH_OF(n) {
    ksl_product_CoAdtinvc(t + i * t_stride, ci + i * ci_stride, co + i * co_stride);
  }
}

static KSL_INLINED void ksl_product_CoAdtinvc_planes(ptrdiff_t n, const double *t,
    ptrdiff_t t_plane, ptrdiff_t t_stride, const double *ci, ptrdiff_t ci_plane,
    ptrdiff_t ci_stride, double *co, ptrdiff_t co_plane, ptrdiff_t co_stride) {
  ksl_vec3_t t_i;
  if (n > 0) t_i = ksl_vec3_of_planes(t, t_plane);
  KSL_EACH_OF(n) {
    if (t_stride) t_i = ksl_vec3_of_planes(t + i * t_stride, t_plane);
    const ksl_coscrew_t ci_i = ksl_coscrew_of_planes(ci + i * ci_stride, ci_plane);
    ksl_coscrew_t co_i;
    ksl_product_CoAdtinvc(&t_i, &ci_i, &co_i);
    ksl_coscrew_to_planes(&co_i, co + i * co_stride, co_plane);
  }
}

/* ksl_product_CoAdtcinv of n elements. */
static KSL_INLINED void ksl_product_CoAdtcinv_many(ptrdiff_t n, const ksl_vec3_t *t,
    ptrdiff_t t_stride, const ksl_coscrew_t *ci, ptrdiff_t ci_stride,
    ksl_coscrew_t *co, ptrdiff_t co_stride) {
  KSL_EACH_OF(n) {
    ksl_product_CoAdtcinv(t + i * t_stride, ci + i * ci_stride, co + i * co_stride);
  }
}

static KSL_INLINED void ksl_product_CoAdtcinv_planes(ptrdiff_t n, const double *t,
    ptrdiff_t t_plane, ptrdiff_t t_stride, const double *ci, ptrdiff_t ci_plane,
    ptrdiff_t ci_stride, double *co, ptrdiff_t co_plane, ptrdiff_t co_stride) {
  ksl_vec3_t t_i;
  if (n > 0) t_i = ksl_vec3_of_planes(t, t_plane);
  KSL_EACH_OF(n) {
    if (t_stride) t_i = ksl_vec3_of_planes(t + i * t_stride, t_plane);
    const ksl_coscrew_t ci_i = ksl_coscrew_of_planes(ci + i * ci_stride, ci_plane);
    ksl_coscrew_t co_i;
    ksl_product_CoAdtcinv(&t_i, &ci_i, &co_i);
    ksl_coscrew_to_planes(&co_i, co + i * co_stride, co_plane);
  }
}

/* ksl_product_CoAdrc of n elements. */
static KSL_INLINED void ksl_product_CoAdrc_many(ptrdiff_t n, const ksl_mat3x3_t *R,
    ptrdiff_t R_stride, const ksl_coscrew_t *ci, ptrdiff_t ci_stride,
    ksl_coscrew_t *co, ptrdiff_t co_stride) {
  KSL_EACH_OF(n) {
    ksl_product_CoAdrc(R + i * R_stride, ci + i * ci_stride, co + i * co_stride);
  }
}

static KSL_INLINED void ksl_product_CoAdrc_planes(ptrdiff_t n, const double *R, ptrdiff_t R_plane,
    ptrdiff_t R_stride, const double *ci, ptrdiff_t ci_plane,
    ptrdiff_t ci_stride, double *co, ptrdiff_t co_plane, ptrdiff_t co_stride) {
  ksl_mat3x3_t R_i;
  if (n > 0) R_i = ksl_mat3x3_of_planes(R, R_plane);
  KSL_EACH_OF(n) {
    if (R_stride) R_i = ksl_mat3x3_of_planes(R + i * R_stride, R_plane);
    const ksl_coscrew_t ci_i = ksl_coscrew_of_planes(ci + i * ci_stride, ci_plane);
    ksl_coscrew_t co_i;
    ksl_product_CoAdrc(&R_i, &ci_i, &co_i);
    ksl_coscrew_to_planes(&co_i, co + i * co_stride, co_plane);
  }
}

/* ksl_product_CoAdrinvc of n elements. */
static KSL_INLINED void ksl_product_CoAdrinvc_many(ptrdiff_t n, const ksl_mat3x3_t *R,
    ptrdiff_t R_stride, const ksl_coscrew_t *ci, ptrdiff_t ci_stride,
    ksl_coscrew_t *co, ptrdiff_t co_stride) {
  KSL_EACH_OF(n) {
    ksl_product_CoAdrinvc(R + i * R_stride, ci + i * ci_stride, co + i * co_stride);
  }
}

static KSL_INLINED void ksl_product_CoAdrinvc_planes(ptrdiff_t n, const double *R,
    ptrdiff_t R_plane, ptrdiff_t R_stride, const double *ci, ptrdiff_t ci_plane,
    ptrdiff_t ci_stride, double *co, ptrdiff_t co_plane, ptrdiff_t co_stride) {
  ksl_mat3x3_t R_i;
  if (n > 0) R_i = ksl_mat3x3_of_planes(R, R_plane);
  KSL_EACH_OF(n) {
    if (R_stride) R_i = ksl_mat3x3_of_planes(R + i * R_stride, R_plane);
    const ksl_coscrew_t ci_i = ksl_coscrew_of_planes(ci + i * ci_stride, ci_plane);
    ksl_coscrew_t co_i;
    ksl_product_CoAdrinvc(&R_i, &ci_i, &co_i);
    ksl_coscrew_to_planes(&co_i, co + i * co_stride, co_plane);
  }
}

/* ksl_product_CoAdrcinv of n elements. */
static KSL_INLINED void ksl_product_CoAdrcinv_many(ptrdiff_t n, const ksl_mat3x3_t *R,
    ptrdiff_t R_stride, const ksl_coscrew_t *ci, ptrdiff_t ci_stride,
    ksl_coscrew_t *co, ptrdiff_t co_stride) {
  KSL_EACH_OF(n) {
    ksl_product_CoAdrcinv(R + i * R_stride, ci + i * ci_stride, co + i * co_stride);
  }
}

static KSL_INLINED void ksl_product_CoAdrcinv_planes(ptrdiff_t n, const double *R,
    ptrdiff_t R_plane, ptrdiff_t R_stride, const double *ci, ptrdiff_t ci_plane,
    ptrdiff_t ci_stride, double *co, ptrdiff_t co_plane, ptrdiff_t co_stride) {
  ksl_mat3x3_t R_i;
  if (n > 0) R_i = ksl_mat3x3_of_planes(R, R_plane);
  KSL_EACH_OF(n) {
    if (R_stride) R_i = ksl_mat3x3_of_planes(R + i * R_stride, R_plane);
    const ksl_coscrew_t ci_i = ksl_coscrew_of_planes(ci + i * ci_stride, ci_plane);
    ksl_coscrew_t co_i;
    ksl_product_CoAdrcinv(&R_i, &ci_i, &co_i);
    ksl_coscrew_to_planes(&co_i, co + i * co_stride, co_plane);
  }
}

/* ksl_product_CoAdc of n elements. */
static KSL_INLINED void ksl_product_CoAdc_many(ptrdiff_t n, const ksl_SE3_t *D, ptrdiff_t D_stride,
    const ksl_coscrew_t *ci, ptrdiff_t ci_stride, ksl_coscrew_t *co,
    ptrdiff_t co_stride) {
  KSL_EACH_OF(n) {
    ksl_product_CoAdc(D + i * D_stride, ci + i * ci_stride, co + i * co_stride);
  }
}

static KSL_INLINED void ksl_product_CoAdc_planes(ptrdiff_t n, const double *D, ptrdiff_t D_plane,
    ptrdiff_t D_stride, const double *ci, ptrdiff_t ci_plane,
    ptrdiff_t ci_stride, double *co, ptrdiff_t co_plane, ptrdiff_t co_stride) {
  ksl_SE3_t D_i;
  if (n > 0) D_i = ksl_SE3_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3_of_planes(D + i * D_stride, D_plane);
    const ksl_coscrew_t ci_i = ksl_coscrew_of_planes(ci + i * ci_stride, ci_plane);
    ksl_coscrew_t co_i;
    ksl_product_CoAdc(&D_i, &ci_i, &co_i);
    ksl_coscrew_to_planes(&co_i, co + i * co_stride, co_plane);
  }
}

/* ksl_product_CoAdinvc of n elements. */
static KSL_INLINED void ksl_product_CoAdinvc_many(ptrdiff_t n, const ksl_SE3_t *D,
    ptrdiff_t D_stride, const ksl_coscrew_t *ci, ptrdiff_t ci_stride,
    ksl_coscrew_t *co, ptrdiff_t co_stride) {
  KSL_EACH_OF(n) {
    ksl_product_CoAdinvc(D + i * D_stride, ci + i * ci_stride, co + i * co_stride);
  }
}

static KSL_INLINED void ksl_product_CoAdinvc_planes(ptrdiff_t n, const double *D, ptrdiff_t D_plane,
    ptrdiff_t D_stride, const double *ci, ptrdiff_t ci_plane,
    ptrdiff_t ci_stride, double *co, ptrdiff_t co_plane, ptrdiff_t co_stride) {
  ksl_SE3_t D_i;
  if (n > 0) D_i = ksl_SE3_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3_of_planes(D + i * D_stride, D_plane);
    const ksl_coscrew_t ci_i = ksl_coscrew_of_planes(ci + i * ci_stride, ci_plane);
    ksl_coscrew_t co_i;
    ksl_product_CoAdinvc(&D_i, &ci_i, &co_i);
    ksl_coscrew_to_planes(&co_i, co + i * co_stride, co_plane);
  }
}

/* ksl_product_CoAdcinv of n elements. */
static KSL_INLINED void ksl_product_CoAdcinv_many(ptrdiff_t n, const ksl_SE3_t *D,
    ptrdiff_t D_stride, const ksl_coscrew_t *ci, ptrdiff_t ci_stride,
    ksl_coscrew_t *co, ptrdiff_t co_stride) {
  KSL_EACH_OF(n) {
    ksl_product_CoAdcinv(D + i * D_stride, ci + i * ci_stride, co + i * co_stride);
  }
}

static KSL_INLINED void ksl_product_CoAdcinv_planes(ptrdiff_t n, const double *D, ptrdiff_t D_plane,
    ptrdiff_t D_stride, const double *ci, ptrdiff_t ci_plane,
    ptrdiff_t ci_stride, double *co, ptrdiff_t co_plane, ptrdiff_t co_stride) {
  ksl_SE3_t D_i;
  if (n > 0) D_i = ksl_SE3_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3_of_planes(D + i * D_stride, D_plane);
    const ksl_coscrew_t ci_i = ksl_coscrew_of_planes(ci + i * ci_stride, ci_plane);
    ksl_coscrew_t co_i;
    ksl_product_CoAdcinv(&D_i, &ci_i, &co_i);
    ksl_coscrew_to_planes(&co_i, co + i * co_stride, co_plane);
  }
}

/* ksl_hctx of n elements. */
static KSL_INLINED void ksl_hctx_many(ptrdiff_t n, const ksl_SE3_t *D, ptrdiff_t D_stride,
    ksl_coscrew_t *co, ptrdiff_t co_stride) {
  KSL_EACH_OF(n) {
    ksl_hctx(D + i * D_stride, co + i * co_stride);
  }
}

static KSL_INLINED void ksl_hctx_planes(ptrdiff_t n, const double *D, ptrdiff_t D_plane,
    ptrdiff_t D_stride, double *co, ptrdiff_t co_plane, ptrdiff_t co_stride) {
  ksl_SE3_t D_i;
  if (n > 0) D_i = ksl_SE3_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3_of_planes(D + i * D_stride, D_plane);
    ksl_coscrew_t co_i;
    ksl_hctx(&D_i, &co_i);
    ksl_coscrew_to_planes(&co_i, co + i * co_stride, co_plane);
  }
}

/* ksl_hcty of n elements. */
static KSL_INLINED void ksl_hcty_many(ptrdiff_t n, const ksl_SE3_t *D, ptrdiff_t D_stride,
    ksl_coscrew_t *co, ptrdiff_t co_stride) {
  KSL_EACH_OF(n) {
    ksl_hcty(D + i * D_stride, co + i * co_stride);
  }
}

static KSL_INLINED void ksl_hcty_planes(ptrdiff_t n, const double *D, ptrdiff_t D_plane,
    ptrdiff_t D_stride, double *co, ptrdiff_t co_plane, ptrdiff_t co_stride) {
  ksl_SE3_t D_i;
  if (n > 0) D_i = ksl_SE3_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3_of_planes(D + i * D_stride, D_plane);
    ksl_coscrew_t co_i;
    ksl_hcty(&D_i, &co_i);
    ksl_coscrew_to_planes(&co_i, co + i * co_stride, co_plane);
  }
}

/* ksl_hctz of n elements. */
static KSL_INLINED void ksl_hctz_many(ptrdiff_t n, const ksl_SE3_t *D, ptrdiff_t D_stride,
    ksl_coscrew_t *co, ptrdiff_t co_stride) {
  KSL_EACH_OF(n) {
    ksl_hctz(D + i * D_stride, co + i * co_stride);
  }
}

static KSL_INLINED void ksl_hctz_planes(ptrdiff_t n, const double *D, ptrdiff_t D_plane,
    ptrdiff_t D_stride, double *co, ptrdiff_t co_plane, ptrdiff_t co_stride) {
  ksl_SE3_t D_i;
  if (n > 0) D_i = ksl_SE3_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3_of_planes(D + i * D_stride, D_plane);
    ksl_coscrew_t co_i;
    ksl_hctz(&D_i, &co_i);
    ksl_coscrew_to_planes(&co_i, co + i * co_stride, co_plane);
  }
}

/* ksl_hcrx of n elements. */
static KSL_INLINED void ksl_hcrx_many(ptrdiff_t n, const ksl_SE3_t *D, ptrdiff_t D_stride,
    ksl_coscrew_t *co, ptrdiff_t co_stride) {
  KSL_EACH_OF(n) {
    ksl_hcrx(D + i * D_stride, co + i * co_stride);
  }
}

static KSL_INLINED void ksl_hcrx_planes(ptrdiff_t n, const double *D, ptrdiff_t D_plane,
    ptrdiff_t D_stride, double *co, ptrdiff_t co_plane, ptrdiff_t co_stride) {
  ksl_SE3_t D_i;
  if (n > 0) D_i = ksl_SE3_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3_of_planes(D + i * D_stride, D_plane);
    ksl_coscrew_t co_i;
    ksl_hcrx(&D_i, &co_i);
    ksl_coscrew_to_planes(&co_i, co + i * co_stride, co_plane);
  }
}

/* ksl_hcry of n elements. */
static KSL_INLINED void ksl_hcry_many(ptrdiff_t n, const ksl_SE3_t *D, ptrdiff_t D_stride,
    ksl_coscrew_t *co, ptrdiff_t co_stride) {
  KSL_EACH_OF(n) {
    ksl_hcry(D + i * D_stride, co + i * co_stride);
  }
}

static KSL_INLINED void ksl_hcry_planes(ptrdiff_t n, const double *D, ptrdiff_t D_plane,
    ptrdiff_t D_stride, double *co, ptrdiff_t co_plane, ptrdiff_t co_stride) {
  ksl_SE3_t D_i;
  if (n > 0) D_i = ksl_SE3_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3_of_planes(D + i * D_stride, D_plane);
    ksl_coscrew_t co_i;
    ksl_hcry(&D_i, &co_i);
    ksl_coscrew_to_planes(&co_i, co + i * co_stride, co_plane);
  }
}

/* ksl_hcrz of n elements. */
static KSL_INLINED void ksl_hcrz_many(ptrdiff_t n, const ksl_SE3_t *D, ptrdiff_t D_stride,
    ksl_coscrew_t *co, ptrdiff_t co_stride) {
  KSL_EACH_OF(n) {
    ksl_hcrz(D + i * D_stride, co + i * co_stride);
  }
}

static KSL_INLINED void ksl_hcrz_planes(ptrdiff_t n, const double *D, ptrdiff_t D_plane,
    ptrdiff_t D_stride, double *co, ptrdiff_t co_plane, ptrdiff_t co_stride) {
  ksl_SE3_t D_i;
  if (n > 0) D_i = ksl_SE3_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3_of_planes(D + i * D_stride, D_plane);
    ksl_coscrew_t co_i;
    ksl_hcrz(&D_i, &co_i);
    ksl_coscrew_to_planes(&co_i, co + i * co_stride, co_plane);
  }
}

/* ksl_hctxinv of n elements. */
static KSL_INLINED void ksl_hctxinv_many(ptrdiff_t n, const ksl_SE3_t *D, ptrdiff_t D_stride,
    ksl_coscrew_t *co, ptrdiff_t co_stride) {
  KSL_EACH_OF(n) {
    ksl_hctxinv(D + i * D_stride, co + i * co_stride);
  }
}

static KSL_INLINED void ksl_hctxinv_planes(ptrdiff_t n, const double *D, ptrdiff_t D_plane,
    ptrdiff_t D_stride, double *co, ptrdiff_t co_plane, ptrdiff_t co_stride) {
  ksl_SE3_t D_i;
  if (n > 0) D_i = ksl_SE3_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3_of_planes(D + i * D_stride, D_plane);
    ksl_coscrew_t co_i;
    ksl_hctxinv(&D_i, &co_i);
    ksl_coscrew_to_planes(&co_i, co + i * co_stride, co_plane);
  }
}

/* ksl_hctyinv of n elements. */
static KSL_INLINED void ksl_hctyinv_many(ptrdiff_t n, const ksl_SE3_t *D, ptrdiff_t D_stride,
    ksl_coscrew_t *co, ptrdiff_t co_stride) {
  KSL_EACH_OF(n) {
    ksl_hctyinv(D + i * D_stride, co + i * co_stride);
  }
}

static KSL_INLINED void ksl_hctyinv_planes(ptrdiff_t n, const double *D, ptrdiff_t D_plane,
    ptrdiff_t D_stride, double *co, ptrdiff_t co_plane, ptrdiff_t co_stride) {
  ksl_SE3_t D_i;
  if (n > 0) D_i = ksl_SE3_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3_of_planes(D + i * D_stride, D_plane);
    ksl_coscrew_t co_i;
    ksl_hctyinv(&D_i, &co_i);
    ksl_coscrew_to_planes(&co_i, co + i * co_stride, co_plane);
  }
}

/* ksl_hctzinv of n elements. */
static KSL_INLINED void ksl_hctzinv_many(ptrdiff_t n, const ksl_SE3_t *D, ptrdiff_t D_stride,
    ksl_coscrew_t *co, ptrdiff_t co_stride) {
  KSL_EACH_OF(n) {
    ksl_hctzinv(D + i * D_stride, co + i * co_stride);
  }
}

static KSL_INLINED void ksl_hctzinv_planes(ptrdiff_t n, const double *D, ptrdiff_t D_plane,
    ptrdiff_t D_stride, double *co, ptrdiff_t co_plane, ptrdiff_t co_stride) {
  ksl_SE3_t D_i;
  if (n > 0) D_i = ksl_SE3_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3_of_planes(D + i * D_stride, D_plane);
    ksl_coscrew_t co_i;
    ksl_hctzinv(&D_i, &co_i);
    ksl_coscrew_to_planes(&co_i, co + i * co_stride, co_plane);
  }
}

/* ksl_hcrxinv of n elements. */
static KSL_INLINED void ksl_hcrxinv_many(ptrdiff_t n, const ksl_SE3_t *D, ptrdiff_t D_stride,
    ksl_coscrew_t *co, ptrdiff_t co_stride) {
  KSL_EACH_OF(n) {
    ksl_hcrxinv(D + i * D_stride, co + i * co_stride);
  }
}

static KSL_INLINED void ksl_hcrxinv_planes(ptrdiff_t n, const double *D, ptrdiff_t D_plane,
    ptrdiff_t D_stride, double *co, ptrdiff_t co_plane, ptrdiff_t co_stride) {
  ksl_SE3_t D_i;
  if (n > 0) D_i = ksl_SE3_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3_of_planes(D + i * D_stride, D_plane);
    ksl_coscrew_t co_i;
    ksl_hcrxinv(&D_i, &co_i);
    ksl_coscrew_to_planes(&co_i, co + i * co_stride, co_plane);
  }
}

/* ksl_hcryinv of n elements. */
static KSL_INLINED void ksl_hcryinv_many(ptrdiff_t n, const ksl_SE3_t *D, ptrdiff_t D_stride,
    ksl_coscrew_t *co, ptrdiff_t co_stride) {
  KSL_EACH_OF(n) {
    ksl_hcryinv(D + i * D_stride, co + i * co_stride);
  }
}

static KSL_INLINED void ksl_hcryinv_planes(ptrdiff_t n, const double *D, ptrdiff_t D_plane,
    ptrdiff_t D_stride, double *co, ptrdiff_t co_plane, ptrdiff_t co_stride) {
  ksl_SE3_t D_i;
  if (n > 0) D_i = ksl_SE3_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3_of_planes(D + i * D_stride, D_plane);
    ksl_coscrew_t co_i;
    ksl_hcryinv(&D_i, &co_i);
    ksl_coscrew_to_planes(&co_i, co + i * co_stride, co_plane);
  }
}

/* ksl_hcrzinv of n elements. */
static KSL_INLINED void ksl_hcrzinv_many(ptrdiff_t n, const ksl_SE3_t *D, ptrdiff_t D_stride,
    ksl_coscrew_t *co, ptrdiff_t co_stride) {
  KSL_EACH_OF(n) {
    ksl_hcrzinv(D + i * D_stride, co + i * co_stride);
  }
}

static KSL_INLINED void ksl_hcrzinv_planes(ptrdiff_t n, const double *D, ptrdiff_t D_plane,
    ptrdiff_t D_stride, double *co, ptrdiff_t co_plane, ptrdiff_t co_stride) {
  ksl_SE3_t D_i;
  if (n > 0) D_i = ksl_SE3_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3_of_planes(D + i * D_stride, D_plane);
    ksl_coscrew_t co_i;
    ksl_hcrzinv(&D_i, &co_i);
    ksl_coscrew_to_planes(&co_i, co + i * co_stride, co_plane);
  }
}

/* ksl_CoAd of n elements. */
static KSL_INLINED void ksl_CoAd_many(ptrdiff_t n, const ksl_SE3_t *D, ptrdiff_t D_stride,
    ksl_mat6x6_t *M, ptrdiff_t M_stride) {
  KSL_EACH_OF(n) {
    ksl_CoAd(D + i * D_stride, M + i * M_stride);
  }
}

static KSL_INLINED void ksl_CoAd_planes(ptrdiff_t n, const double *D, ptrdiff_t D_plane,
    ptrdiff_t D_stride, double *M, ptrdiff_t M_plane, ptrdiff_t M_stride) {
  ksl_SE3_t D_i;
  if (n > 0) D_i = ksl_SE3_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3_of_planes(D + i * D_stride, D_plane);
    ksl_mat6x6_t M_i;
    ksl_CoAd(&D_i, &M_i);
    ksl_mat6x6_to_planes(&M_i, M + i * M_stride, M_plane);
  }
}

/* ksl_reciprocal_product of n elements. */
static KSL_INLINED void ksl_reciprocal_product_many(ptrdiff_t n, const ksl_coscrew_t *c,
    ptrdiff_t c_stride, const double *x, ptrdiff_t x_stride, double *power,
    ptrdiff_t power_stride) {
  KSL_EACH_OF(n) {
    power[i * power_stride] = ksl_reciprocal_product(c + i * c_stride, x + 6 * i * x_stride);
  }
}

static KSL_INLINED void ksl_reciprocal_product_planes(ptrdiff_t n, const double *c,
    ptrdiff_t c_plane, ptrdiff_t c_stride, const double *x, ptrdiff_t x_plane,
    ptrdiff_t x_stride, double *power, ptrdiff_t power_stride) {
  ksl_coscrew_t c_i;
  if (n > 0) c_i = ksl_coscrew_of_planes(c, c_plane);
  KSL_EACH_OF(n) {
    if (c_stride) c_i = ksl_coscrew_of_planes(c + i * c_stride, c_plane);
    const double x_i[6] = {x[0 + i * x_stride], x[x_plane + i * x_stride],
        x[2 * x_plane + i * x_stride], x[3 * x_plane + i * x_stride], x[4 * x_plane + i * x_stride],
        x[5 * x_plane + i * x_stride]};
    power[i * power_stride] = ksl_reciprocal_product(&c_i, x_i);
  }
}

/* ksl_cross_sc of n elements. */
static KSL_INLINED void ksl_cross_sc_many(ptrdiff_t n, const ksl_screw_t *s, ptrdiff_t s_stride,
    const ksl_coscrew_t *c, ptrdiff_t c_stride, ksl_coscrew_t *co,
    ptrdiff_t co_stride) {
  KSL_EACH_OF(n) {
    ksl_cross_sc(s + i * s_stride, c + i * c_stride, co + i * co_stride);
  }
}

static KSL_INLINED void ksl_cross_sc_planes(ptrdiff_t n, const double *s, ptrdiff_t s_plane,
    ptrdiff_t s_stride, const double *c, ptrdiff_t c_plane, ptrdiff_t c_stride,
    double *co, ptrdiff_t co_plane, ptrdiff_t co_stride) {
  ksl_screw_t s_i;
  if (n > 0) s_i = ksl_screw_of_planes(s, s_plane);
  KSL_EACH_OF(n) {
    if (s_stride) s_i = ksl_screw_of_planes(s + i * s_stride, s_plane);
    const ksl_coscrew_t c_i = ksl_coscrew_of_planes(c + i * c_stride, c_plane);
    ksl_coscrew_t co_i;
    ksl_cross_sc(&s_i, &c_i, &co_i);
    ksl_coscrew_to_planes(&co_i, co + i * co_stride, co_plane);
  }
}

/* ksl_cross_sca of n elements. */
static KSL_INLINED void ksl_cross_sca_many(ptrdiff_t n, const ksl_screw_t *s, ptrdiff_t s_stride,
    const ksl_coscrew_t *c, ptrdiff_t c_stride, ksl_coscrew_t *co,
    ptrdiff_t co_stride) {
  KSL_EACH_OF(n) {
    ksl_cross_sca(s + i * s_stride, c + i * c_stride, co + i * co_stride);
  }
}

static KSL_INLINED void ksl_cross_sca_planes(ptrdiff_t n, const double *s, ptrdiff_t s_plane,
    ptrdiff_t s_stride, const double *c, ptrdiff_t c_plane, ptrdiff_t c_stride,
    double *co, ptrdiff_t co_plane, ptrdiff_t co_stride) {
  ksl_screw_t s_i;
  if (n > 0) s_i = ksl_screw_of_planes(s, s_plane);
  KSL_EACH_OF(n) {
    if (s_stride) s_i = ksl_screw_of_planes(s + i * s_stride, s_plane);
    const ksl_coscrew_t c_i = ksl_coscrew_of_planes(c + i * c_stride, c_plane);
    ksl_coscrew_t co_i;
    ksl_cross_sca(&s_i, &c_i, &co_i);
    ksl_coscrew_to_planes(&co_i, co + i * co_stride, co_plane);
  }
}

/* ksl_constraint_ctx of n elements. */
static KSL_INLINED void ksl_constraint_ctx_many(ptrdiff_t n, const ksl_SE3_t *D, ptrdiff_t D_stride,
    const ksl_coscrew_t *c, ptrdiff_t c_stride, ksl_coscrew_t *co,
    ptrdiff_t co_stride) {
  KSL_EACH_OF(n) {
    ksl_constraint_ctx(D + i * D_stride, c + i * c_stride, co + i * co_stride);
  }
}

static KSL_INLINED void ksl_constraint_ctx_planes(ptrdiff_t n, const double *D, ptrdiff_t D_plane,
    ptrdiff_t D_stride, const double *c, ptrdiff_t c_plane, ptrdiff_t c_stride,
    double *co, ptrdiff_t co_plane, ptrdiff_t co_stride) {
  ksl_SE3_t D_i;
  if (n > 0) D_i = ksl_SE3_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3_of_planes(D + i * D_stride, D_plane);
    const ksl_coscrew_t c_i = ksl_coscrew_of_planes(c + i * c_stride, c_plane);
    ksl_coscrew_t co_i;
    ksl_constraint_ctx(&D_i, &c_i, &co_i);
    ksl_coscrew_to_planes(&co_i, co + i * co_stride, co_plane);
  }
}

/* ksl_constraint_cty of n elements. */
static KSL_INLINED void ksl_constraint_cty_many(ptrdiff_t n, const ksl_SE3_t *D, ptrdiff_t D_stride,
    const ksl_coscrew_t *c, ptrdiff_t c_stride, ksl_coscrew_t *co,
    ptrdiff_t co_stride) {
  KSL_EACH_OF(n) {
    ksl_constraint_cty(D + i * D_stride, c + i * c_stride, co + i * co_stride);
  }
}

static KSL_INLINED void ksl_constraint_cty_planes(ptrdiff_t n, const double *D, ptrdiff_t D_plane,
    ptrdiff_t D_stride, const double *c, ptrdiff_t c_plane, ptrdiff_t c_stride,
    double *co, ptrdiff_t co_plane, ptrdiff_t co_stride) {
  ksl_SE3_t D_i;
  if (n > 0) D_i = ksl_SE3_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3_of_planes(D + i * D_stride, D_plane);
    const ksl_coscrew_t c_i = ksl_coscrew_of_planes(c + i * c_stride, c_plane);
    ksl_coscrew_t co_i;
    ksl_constraint_cty(&D_i, &c_i, &co_i);
    ksl_coscrew_to_planes(&co_i, co + i * co_stride, co_plane);
  }
}

/* ksl_constraint_ctz of n elements. */
static KSL_INLINED void ksl_constraint_ctz_many(ptrdiff_t n, const ksl_SE3_t *D, ptrdiff_t D_stride,
    const ksl_coscrew_t *c, ptrdiff_t c_stride, ksl_coscrew_t *co,
    ptrdiff_t co_stride) {
  KSL_EACH_OF(n) {
    ksl_constraint_ctz(D + i * D_stride, c + i * c_stride, co + i * co_stride);
  }
}

static KSL_INLINED void ksl_constraint_ctz_planes(ptrdiff_t n, const double *D, ptrdiff_t D_plane,
    ptrdiff_t D_stride, const double *c, ptrdiff_t c_plane, ptrdiff_t c_stride,
    double *co, ptrdiff_t co_plane, ptrdiff_t co_stride) {
  ksl_SE3_t D_i;
  if (n > 0) D_i = ksl_SE3_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3_of_planes(D + i * D_stride, D_plane);
    const ksl_coscrew_t c_i = ksl_coscrew_of_planes(c + i * c_stride, c_plane);
    ksl_coscrew_t co_i;
    ksl_constraint_ctz(&D_i, &c_i, &co_i);
    ksl_coscrew_to_planes(&co_i, co + i * co_stride, co_plane);
  }
}

/* ksl_constraint_crx of n elements. */
static KSL_INLINED void ksl_constraint_crx_many(ptrdiff_t n, const ksl_SE3_t *D, ptrdiff_t D_stride,
    const ksl_coscrew_t *c, ptrdiff_t c_stride, ksl_coscrew_t *co,
    ptrdiff_t co_stride) {
  KSL_EACH_OF(n) {
    ksl_constraint_crx(D + i * D_stride, c + i * c_stride, co + i * co_stride);
  }
}

static KSL_INLINED void ksl_constraint_crx_planes(ptrdiff_t n, const double *D, ptrdiff_t D_plane,
    ptrdiff_t D_stride, const double *c, ptrdiff_t c_plane, ptrdiff_t c_stride,
    double *co, ptrdiff_t co_plane, ptrdiff_t co_stride) {
  ksl_SE3_t D_i;
  if (n > 0) D_i = ksl_SE3_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3_of_planes(D + i * D_stride, D_plane);
    const ksl_coscrew_t c_i = ksl_coscrew_of_planes(c + i * c_stride, c_plane);
    ksl_coscrew_t co_i;
    ksl_constraint_crx(&D_i, &c_i, &co_i);
    ksl_coscrew_to_planes(&co_i, co + i * co_stride, co_plane);
  }
}

/* ksl_constraint_cry of n elements. */
static KSL_INLINED void ksl_constraint_cry_many(ptrdiff_t n, const ksl_SE3_t *D, ptrdiff_t D_stride,
    const ksl_coscrew_t *c, ptrdiff_t c_stride, ksl_coscrew_t *co,
    ptrdiff_t co_stride) {
  KSL_EACH_OF(n) {
    ksl_constraint_cry(D + i * D_stride, c + i * c_stride, co + i * co_stride);
  }
}

static KSL_INLINED void ksl_constraint_cry_planes(ptrdiff_t n, const double *D, ptrdiff_t D_plane,
    ptrdiff_t D_stride, const double *c, ptrdiff_t c_plane, ptrdiff_t c_stride,
    double *co, ptrdiff_t co_plane, ptrdiff_t co_stride) {
  ksl_SE3_t D_i;
  if (n > 0) D_i = ksl_SE3_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3_of_planes(D + i * D_stride, D_plane);
    const ksl_coscrew_t c_i = ksl_coscrew_of_planes(c + i * c_stride, c_plane);
    ksl_coscrew_t co_i;
    ksl_constraint_cry(&D_i, &c_i, &co_i);
    ksl_coscrew_to_planes(&co_i, co + i * co_stride, co_plane);
  }
}

/* ksl_constraint_crz of n elements. */
static KSL_INLINED void ksl_constraint_crz_many(ptrdiff_t n, const ksl_SE3_t *D, ptrdiff_t D_stride,
    const ksl_coscrew_t *c, ptrdiff_t c_stride, ksl_coscrew_t *co,
    ptrdiff_t co_stride) {
  KSL_EACH_OF(n) {
    ksl_constraint_crz(D + i * D_stride, c + i * c_stride, co + i * co_stride);
  }
}

static KSL_INLINED void ksl_constraint_crz_planes(ptrdiff_t n, const double *D, ptrdiff_t D_plane,
    ptrdiff_t D_stride, const double *c, ptrdiff_t c_plane, ptrdiff_t c_stride,
    double *co, ptrdiff_t co_plane, ptrdiff_t co_stride) {
  ksl_SE3_t D_i;
  if (n > 0) D_i = ksl_SE3_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3_of_planes(D + i * D_stride, D_plane);
    const ksl_coscrew_t c_i = ksl_coscrew_of_planes(c + i * c_stride, c_plane);
    ksl_coscrew_t co_i;
    ksl_constraint_crz(&D_i, &c_i, &co_i);
    ksl_coscrew_to_planes(&co_i, co + i * co_stride, co_plane);
  }
}

/* ksl_working_ctx of n elements. */
static KSL_INLINED void ksl_working_ctx_many(ptrdiff_t n, const ksl_SE3_t *D, ptrdiff_t D_stride,
    const ksl_coscrew_t *c, ptrdiff_t c_stride, ksl_coscrew_t *co,
    ptrdiff_t co_stride) {
  KSL_EACH_OF(n) {
    ksl_working_ctx(D + i * D_stride, c + i * c_stride, co + i * co_stride);
  }
}

static KSL_INLINED void ksl_working_ctx_planes(ptrdiff_t n, const double *D, ptrdiff_t D_plane,
    ptrdiff_t D_stride, const double *c, ptrdiff_t c_plane, ptrdiff_t c_stride,
    double *co, ptrdiff_t co_plane, ptrdiff_t co_stride) {
  ksl_SE3_t D_i;
  if (n > 0) D_i = ksl_SE3_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3_of_planes(D + i * D_stride, D_plane);
    const ksl_coscrew_t c_i = ksl_coscrew_of_planes(c + i * c_stride, c_plane);
    ksl_coscrew_t co_i;
    ksl_working_ctx(&D_i, &c_i, &co_i);
    ksl_coscrew_to_planes(&co_i, co + i * co_stride, co_plane);
  }
}

/* ksl_working_cty of n elements. */
static KSL_INLINED void ksl_working_cty_many(ptrdiff_t n, const ksl_SE3_t *D, ptrdiff_t D_stride,
    const ksl_coscrew_t *c, ptrdiff_t c_stride, ksl_coscrew_t *co,
    ptrdiff_t co_stride) {
  KSL_EACH_OF(n) {
    ksl_working_cty(D + i * D_stride, c + i * c_stride, co + i * co_stride);
  }
}

static KSL_INLINED void ksl_working_cty_planes(ptrdiff_t n, const double *D, ptrdiff_t D_plane,
    ptrdiff_t D_stride, const double *c, ptrdiff_t c_plane, ptrdiff_t c_stride,
    double *co, ptrdiff_t co_plane, ptrdiff_t co_stride) {
  ksl_SE3_t D_i;
  if (n > 0) D_i = ksl_SE3_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3_of_planes(D + i * D_stride, D_plane);
    const ksl_coscrew_t c_i = ksl_coscrew_of_planes(c + i * c_stride, c_plane);
    ksl_coscrew_t co_i;
    ksl_working_cty(&D_i, &c_i, &co_i);
    ksl_coscrew_to_planes(&co_i, co + i * co_stride, co_plane);
  }
}

/* ksl_working_ctz of n elements. */
static KSL_INLINED void ksl_working_ctz_many(ptrdiff_t n, const ksl_SE3_t *D, ptrdiff_t D_stride,
    const ksl_coscrew_t *c, ptrdiff_t c_stride, ksl_coscrew_t *co,
    ptrdiff_t co_stride) {
  KSL_EACH_OF(n) {
    ksl_working_ctz(D + i * D_stride, c + i * c_stride, co + i * co_stride);
  }
}

static KSL_INLINED void ksl_working_ctz_planes(ptrdiff_t n, const double *D, ptrdiff_t D_plane,
    ptrdiff_t D_stride, const double *c, ptrdiff_t c_plane, ptrdiff_t c_stride,
    double *co, ptrdiff_t co_plane, ptrdiff_t co_stride) {
  ksl_SE3_t D_i;
  if (n > 0) D_i = ksl_SE3_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3_of_planes(D + i * D_stride, D_plane);
    const ksl_coscrew_t c_i = ksl_coscrew_of_planes(c + i * c_stride, c_plane);
    ksl_coscrew_t co_i;
    ksl_working_ctz(&D_i, &c_i, &co_i);
    ksl_coscrew_to_planes(&co_i, co + i * co_stride, co_plane);
  }
}

/* ksl_working_crx of n elements. */
static KSL_INLINED void ksl_working_crx_many(ptrdiff_t n, const ksl_SE3_t *D, ptrdiff_t D_stride,
    const ksl_coscrew_t *c, ptrdiff_t c_stride, ksl_coscrew_t *co,
    ptrdiff_t co_stride) {
  KSL_EACH_OF(n) {
    ksl_working_crx(D + i * D_stride, c + i * c_stride, co + i * co_stride);
  }
}

static KSL_INLINED void ksl_working_crx_planes(ptrdiff_t n, const double *D, ptrdiff_t D_plane,
    ptrdiff_t D_stride, const double *c, ptrdiff_t c_plane, ptrdiff_t c_stride,
    double *co, ptrdiff_t co_plane, ptrdiff_t co_stride) {
  ksl_SE3_t D_i;
  if (n > 0) D_i = ksl_SE3_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3_of_planes(D + i * D_stride, D_plane);
    const ksl_coscrew_t c_i = ksl_coscrew_of_planes(c + i * c_stride, c_plane);
    ksl_coscrew_t co_i;
    ksl_working_crx(&D_i, &c_i, &co_i);
    ksl_coscrew_to_planes(&co_i, co + i * co_stride, co_plane);
  }
}

/* ksl_working_cry of n elements. */
static KSL_INLINED void ksl_working_cry_many(ptrdiff_t n, const ksl_SE3_t *D, ptrdiff_t D_stride,
    const ksl_coscrew_t *c, ptrdiff_t c_stride, ksl_coscrew_t *co,
    ptrdiff_t co_stride) {
  KSL_EACH_OF(n) {
    ksl_working_cry(D + i * D_stride, c + i * c_stride, co + i * co_stride);
  }
}

static KSL_INLINED void ksl_working_cry_planes(ptrdiff_t n, const double *D, ptrdiff_t D_plane,
    ptrdiff_t D_stride, const double *c, ptrdiff_t c_plane, ptrdiff_t c_stride,
    double *co, ptrdiff_t co_plane, ptrdiff_t co_stride) {
  ksl_SE3_t D_i;
  if (n > 0) D_i = ksl_SE3_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3_of_planes(D + i * D_stride, D_plane);
    const ksl_coscrew_t c_i = ksl_coscrew_of_planes(c + i * c_stride, c_plane);
    ksl_coscrew_t co_i;
    ksl_working_cry(&D_i, &c_i, &co_i);
    ksl_coscrew_to_planes(&co_i, co + i * co_stride, co_plane);
  }
}

/* ksl_working_crz of n elements. */
static KSL_INLINED void ksl_working_crz_many(ptrdiff_t n, const ksl_SE3_t *D, ptrdiff_t D_stride,
    const ksl_coscrew_t *c, ptrdiff_t c_stride, ksl_coscrew_t *co,
    ptrdiff_t co_stride) {
  KSL_EACH_OF(n) {
    ksl_working_crz(D + i * D_stride, c + i * c_stride, co + i * co_stride);
  }
}

static KSL_INLINED void ksl_working_crz_planes(ptrdiff_t n, const double *D, ptrdiff_t D_plane,
    ptrdiff_t D_stride, const double *c, ptrdiff_t c_plane, ptrdiff_t c_stride,
    double *co, ptrdiff_t co_plane, ptrdiff_t co_stride) {
  ksl_SE3_t D_i;
  if (n > 0) D_i = ksl_SE3_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3_of_planes(D + i * D_stride, D_plane);
    const ksl_coscrew_t c_i = ksl_coscrew_of_planes(c + i * c_stride, c_plane);
    ksl_coscrew_t co_i;
    ksl_working_crz(&D_i, &c_i, &co_i);
    ksl_coscrew_to_planes(&co_i, co + i * co_stride, co_plane);
  }
}

/* ksl_coad of n elements. */
static KSL_INLINED void ksl_coad_many(ptrdiff_t n, const ksl_screw_t *s, ptrdiff_t s_stride,
    ksl_mat6x6_t *M, ptrdiff_t M_stride) {
  KSL_EACH_OF(n) {
    ksl_coad(s + i * s_stride, M + i * M_stride);
  }
}

static KSL_INLINED void ksl_coad_planes(ptrdiff_t n, const double *s, ptrdiff_t s_plane,
    ptrdiff_t s_stride, double *M, ptrdiff_t M_plane, ptrdiff_t M_stride) {
  ksl_screw_t s_i;
  if (n > 0) s_i = ksl_screw_of_planes(s, s_plane);
  KSL_EACH_OF(n) {
    if (s_stride) s_i = ksl_screw_of_planes(s + i * s_stride, s_plane);
    ksl_mat6x6_t M_i;
    ksl_coad(&s_i, &M_i);
    ksl_mat6x6_to_planes(&M_i, M + i * M_stride, M_plane);
  }
}

/* ksl_coscrewf_copy of n elements. */
static KSL_INLINED void ksl_coscrewf_copy_many(ptrdiff_t n, const ksl_coscrewf_t *ci,
    ptrdiff_t ci_stride, ksl_coscrewf_t *co, ptrdiff_t co_stride) {
  KSL_EACH_OF(n) {
    ksl_coscrewf_copy(ci + i * ci_stride, co + i * co_stride);
  }
}

static KSL_INLINED void ksl_coscrewf_copy_planes(ptrdiff_t n, const float *ci, ptrdiff_t ci_plane,
    ptrdiff_t ci_stride, float *co, ptrdiff_t co_plane, ptrdiff_t co_stride) {
  ksl_coscrewf_t ci_i;
  if (n > 0) ci_i = ksl_coscrewf_of_planes(ci, ci_plane);
  KSL_EACH_OF(n) {
    if (ci_stride) ci_i = ksl_coscrewf_of_planes(ci + i * ci_stride, ci_plane);
    ksl_coscrewf_t co_i;
    ksl_coscrewf_copy(&ci_i, &co_i);
    ksl_coscrewf_to_planes(&co_i, co + i * co_stride, co_plane);
  }
}

/* ksl_coscrewf_scale of n elements. */
static KSL_INLINED void ksl_coscrewf_scale_many(ptrdiff_t n, ksl_coscrewf_t *self,
    ptrdiff_t self_stride, const float *a, ptrdiff_t a_stride) {
  KSL_EACH_OF(n) {
    ksl_coscrewf_scale(self + i * self_stride, a[i * a_stride]);
  }
}

static KSL_INLINED void ksl_coscrewf_scale_planes(ptrdiff_t n, float *self, ptrdiff_t self_plane,
    ptrdiff_t self_stride, const float *a, ptrdiff_t a_stride) {
  KSL_EACH_OF(n) {
    ksl_coscrewf_t self_i = ksl_coscrewf_of_planes(self + i * self_stride, self_plane);
    ksl_coscrewf_scale(&self_i, a[i * a_stride]);
    ksl_coscrewf_to_planes(&self_i, self + i * self_stride, self_plane);
  }
}

/* ksl_coscrewf_inverted of n elements. */
static KSL_INLINED void ksl_coscrewf_inverted_many(ptrdiff_t n, const ksl_coscrewf_t *ci,
    ptrdiff_t ci_stride, ksl_coscrewf_t *co, ptrdiff_t co_stride) {
  KSL_EACH_OF(n) {
    ksl_coscrewf_inverted(ci + i * ci_stride, co + i * co_stride);
  }
}

static KSL_INLINED void ksl_coscrewf_inverted_planes(ptrdiff_t n, const float *ci,
    ptrdiff_t ci_plane, ptrdiff_t ci_stride, float *co, ptrdiff_t co_plane,
    ptrdiff_t co_stride) {
  ksl_coscrewf_t ci_i;
  if (n > 0) ci_i = ksl_coscrewf_of_planes(ci, ci_plane);
  KSL_EACH_OF(n) {
    if (ci_stride) ci_i = ksl_coscrewf_of_planes(ci + i * ci_stride, ci_plane);
    ksl_coscrewf_t co_i;
    ksl_coscrewf_inverted(&ci_i, &co_i);
    ksl_coscrewf_to_planes(&co_i, co + i * co_stride, co_plane);
  }
}

/* ksl_coscrewf_invert of n elements. */
static KSL_INLINED void ksl_coscrewf_invert_many(ptrdiff_t n, ksl_coscrewf_t *self,
    ptrdiff_t self_stride) {
  KSL_EACH_OF(n) {
    ksl_coscrewf_invert(self + i * self_stride);
  }
}

static KSL_INLINED void ksl_coscrewf_invert_planes(ptrdiff_t n, float *self, ptrdiff_t self_plane,
    ptrdiff_t self_stride) {
  KSL_EACH_OF(n) {
    ksl_coscrewf_t self_i = ksl_coscrewf_of_planes(self + i * self_stride, self_plane);
    ksl_coscrewf_invert(&self_i);
    ksl_coscrewf_to_planes(&self_i, self + i * self_stride, self_plane);
  }
}

/* ksl_axpy_ccf of n elements. */
static KSL_INLINED void ksl_axpy_ccf_many(ptrdiff_t n, const float *a, ptrdiff_t a_stride,
    const ksl_coscrewf_t *x, ptrdiff_t x_stride, ksl_coscrewf_t *y,
    ptrdiff_t y_stride) {
  KSL_EACH_OF(n) {
    ksl_axpy_ccf(a[i * a_stride], x + i * x_stride, y + i * y_stride);
  }
}

static KSL_INLINED void ksl_axpy_ccf_planes(ptrdiff_t n, const float *a, ptrdiff_t a_stride,
    const float *x, ptrdiff_t x_plane, ptrdiff_t x_stride, float *y,
    ptrdiff_t y_plane, ptrdiff_t y_stride) {
  KSL_EACH_OF(n) {
    const ksl_coscrewf_t x_i = ksl_coscrewf_of_planes(x + i * x_stride, x_plane);
    ksl_coscrewf_t y_i = ksl_coscrewf_of_planes(y + i * y_stride, y_plane);
    ksl_axpy_ccf(a[i * a_stride], &x_i, &y_i);
    ksl_coscrewf_to_planes(&y_i, y + i * y_stride, y_plane);
  }
}

/* ksl_xpy_ccf of n elements. */
static KSL_INLINED void ksl_xpy_ccf_many(ptrdiff_t n, const ksl_coscrewf_t *x, ptrdiff_t x_stride,
    ksl_coscrewf_t *y, ptrdiff_t y_stride) {
  KSL_EACH_OF(n) {
    ksl_xpy_ccf(x + i * x_stride, y + i * y_stride);
  }
}

static KSL_INLINED void ksl_xpy_ccf_planes(ptrdiff_t n, const float *x, ptrdiff_t x_plane,
    ptrdiff_t x_stride, float *y, ptrdiff_t y_plane, ptrdiff_t y_stride) {
  ksl_coscrewf_t x_i;
  if (n > 0) x_i = ksl_coscrewf_of_planes(x, x_plane);
  KSL_EACH_OF(n) {
    if (x_stride) x_i = ksl_coscrewf_of_planes(x + i * x_stride, x_plane);
    ksl_coscrewf_t y_i = ksl_coscrewf_of_planes(y + i * y_stride, y_plane);
    ksl_xpy_ccf(&x_i, &y_i);
    ksl_coscrewf_to_planes(&y_i, y + i * y_stride, y_plane);
  }
}

/* ksl_nxpy_ccf of n elements. */
static KSL_INLINED void ksl_nxpy_ccf_many(ptrdiff_t n, const ksl_coscrewf_t *x, ptrdiff_t x_stride,
    ksl_coscrewf_t *y, ptrdiff_t y_stride) {
  KSL_EACH_OF(n) {
    ksl_nxpy_ccf(x + i * x_stride, y + i * y_stride);
  }
}

static KSL_INLINED void ksl_nxpy_ccf_planes(ptrdiff_t n, const float *x, ptrdiff_t x_plane,
    ptrdiff_t x_stride, float *y, ptrdiff_t y_plane, ptrdiff_t y_stride) {
  ksl_coscrewf_t x_i;
  if (n > 0) x_i = ksl_coscrewf_of_planes(x, x_plane);
  KSL_EACH_OF(n) {
    if (x_stride) x_i = ksl_coscrewf_of_planes(x + i * x_stride, x_plane);
    ksl_coscrewf_t y_i = ksl_coscrewf_of_planes(y + i * y_stride, y_plane);
    ksl_nxpy_ccf(&x_i, &y_i);
    ksl_coscrewf_to_planes(&y_i, y + i * y_stride, y_plane);
  }
}

/* ksl_product_acf of n elements. */
static KSL_INLINED void ksl_product_acf_many(ptrdiff_t n, const float *a, ptrdiff_t a_stride,
    const ksl_coscrewf_t *ci, ptrdiff_t ci_stride, ksl_coscrewf_t *co,
    ptrdiff_t co_stride) {
  KSL_EACH_OF(n) {
    ksl_product_acf(a[i * a_stride], ci + i * ci_stride, co + i * co_stride);
  }
}

static KSL_INLINED void ksl_product_acf_planes(ptrdiff_t n, const float *a, ptrdiff_t a_stride,
    const float *ci, ptrdiff_t ci_plane, ptrdiff_t ci_stride, float *co,
    ptrdiff_t co_plane, ptrdiff_t co_stride) {
  KSL_EACH_OF(n) {
    const ksl_coscrewf_t ci_i = ksl_coscrewf_of_planes(ci + i * ci_stride, ci_plane);
    ksl_coscrewf_t co_i;
    ksl_product_acf(a[i * a_stride], &ci_i, &co_i);
    ksl_coscrewf_to_planes(&co_i, co + i * co_stride, co_plane);
  }
}

/* ksl_add_ccf of n elements. */
static KSL_INLINED void ksl_add_ccf_many(ptrdiff_t n, const ksl_coscrewf_t *c1, ptrdiff_t c1_stride,
    const ksl_coscrewf_t *c2, ptrdiff_t c2_stride, ksl_coscrewf_t *co,
    ptrdiff_t co_stride) {
  KSL_EACH_OF(n) {
    ksl_add_ccf(c1 + i * c1_stride, c2 + i * c2_stride, co + i * co_stride);
  }
}

static KSL_INLINED void ksl_add_ccf_planes(ptrdiff_t n, const float *c1, ptrdiff_t c1_plane,
    ptrdiff_t c1_stride, const float *c2, ptrdiff_t c2_plane,
    ptrdiff_t c2_stride, float *co, ptrdiff_t co_plane, ptrdiff_t co_stride) {
  ksl_coscrewf_t c1_i;
  if (n > 0) c1_i = ksl_coscrewf_of_planes(c1, c1_plane);
  KSL_EACH_OF(n) {
    if (c1_stride) c1_i = ksl_coscrewf_of_planes(c1 + i * c1_stride, c1_plane);
    const ksl_coscrewf_t c2_i = ksl_coscrewf_of_planes(c2 + i * c2_stride, c2_plane);
    ksl_coscrewf_t co_i;
    ksl_add_ccf(&c1_i, &c2_i, &co_i);
    ksl_coscrewf_to_planes(&co_i, co + i * co_stride, co_plane);
  }
}

/* ksl_subtract_ccf of n elements. */
static KSL_INLINED void ksl_subtract_ccf_many(ptrdiff_t n, const ksl_coscrewf_t *c1,
    ptrdiff_t c1_stride, const ksl_coscrewf_t *c2, ptrdiff_t c2_stride,
    ksl_coscrewf_t *co, ptrdiff_t co_stride) {
  KSL_EACH_OF(n) {
    ksl_subtract_ccf(c1 + i * c1_stride, c2 + i * c2_stride, co + i * co_stride);
  }
}

static KSL_INLINED void ksl_subtract_ccf_planes(ptrdiff_t n, const float *c1, ptrdiff_t c1_plane,
    ptrdiff_t c1_stride, const float *c2, ptrdiff_t c2_plane,
    ptrdiff_t c2_stride, float *co, ptrdiff_t co_plane, ptrdiff_t co_stride) {
  ksl_coscrewf_t c1_i;
  if (n > 0) c1_i = ksl_coscrewf_of_planes(c1, c1_plane);
  KSL_EACH_OF(n) {
    if (c1_stride) c1_i = ksl_coscrewf_of_planes(c1 + i * c1_stride, c1_plane);
    const ksl_coscrewf_t c2_i = ksl_coscrewf_of_planes(c2 + i * c2_stride, c2_plane);
    ksl_coscrewf_t co_i;
    ksl_subtract_ccf(&c1_i, &c2_i, &co_i);
    ksl_coscrewf_to_planes(&co_i, co + i * co_stride, co_plane);
  }
}

/* ksl_coscrewf_norm of n elements. */
static KSL_INLINED void ksl_coscrewf_norm_many(ptrdiff_t n, const ksl_coscrewf_t *ci,
    ptrdiff_t ci_stride, float *norm, ptrdiff_t norm_stride) {
  KSL_EACH_OF(n) {
    norm[i * norm_stride] = ksl_coscrewf_norm(ci + i * ci_stride);
  }
}

static KSL_INLINED void ksl_coscrewf_norm_planes(ptrdiff_t n, const float *ci, ptrdiff_t ci_plane,
    ptrdiff_t ci_stride, float *norm, ptrdiff_t norm_stride) {
  ksl_coscrewf_t ci_i;
  if (n > 0) ci_i = ksl_coscrewf_of_planes(ci, ci_plane);
  KSL_EACH_OF(n) {
    if (ci_stride) ci_i = ksl_coscrewf_of_planes(ci + i * ci_stride, ci_plane);
    norm[i * norm_stride] = ksl_coscrewf_norm(&ci_i);
  }
}

/* ksl_coscrewf_normalize of n elements. */
static KSL_INLINED void ksl_coscrewf_normalize_many(ptrdiff_t n, ksl_coscrewf_t *self,
    ptrdiff_t self_stride) {
  KSL_EACH_OF(n) {
    ksl_coscrewf_normalize(self + i * self_stride);
  }
}

static KSL_INLINED void ksl_coscrewf_normalize_planes(ptrdiff_t n, float *self,
    ptrdiff_t self_plane, ptrdiff_t self_stride) {
  KSL_EACH_OF(n) {
    ksl_coscrewf_t self_i = ksl_coscrewf_of_planes(self + i * self_stride, self_plane);
    ksl_coscrewf_normalize(&self_i);
    ksl_coscrewf_to_planes(&self_i, self + i * self_stride, self_plane);
  }
}

/* ksl_coscrewf_normalized of n elements. */
static KSL_INLINED void ksl_coscrewf_normalized_many(ptrdiff_t n, const ksl_coscrewf_t *ci,
    ptrdiff_t ci_stride, ksl_coscrewf_t *co, ptrdiff_t co_stride) {
  KSL_EACH_OF(n) {
    ksl_coscrewf_normalized(ci + i * ci_stride, co + i * co_stride);
  }
}

static KSL_INLINED void ksl_coscrewf_normalized_planes(ptrdiff_t n, const float *ci,
    ptrdiff_t ci_plane, ptrdiff_t ci_stride, float *co, ptrdiff_t co_plane,
    ptrdiff_t co_stride) {
  ksl_coscrewf_t ci_i;
  if (n > 0) ci_i = ksl_coscrewf_of_planes(ci, ci_plane);
  KSL_EACH_OF(n) {
    if (ci_stride) ci_i = ksl_coscrewf_of_planes(ci + i * ci_stride, ci_plane);
    ksl_coscrewf_t co_i;
    ksl_coscrewf_normalized(&ci_i, &co_i);
    ksl_coscrewf_to_planes(&co_i, co + i * co_stride, co_plane);
  }
}

/* ksl_coscrewf_from_lin_ang of n elements. */
static KSL_INLINED void ksl_coscrewf_from_lin_ang_many(ptrdiff_t n, const ksl_vec3f_t *lin,
    ptrdiff_t lin_stride, const ksl_vec3f_t *ang, ptrdiff_t ang_stride,
    ksl_coscrewf_t *co, ptrdiff_t co_stride) {
  KSL_EACH_OF(n) {
    ksl_coscrewf_from_lin_ang(lin + i * lin_stride, ang + i * ang_stride, co + i * co_stride);
  }
}

static KSL_INLINED void ksl_coscrewf_from_lin_ang_planes(ptrdiff_t n, const float *lin,
    ptrdiff_t lin_plane, ptrdiff_t lin_stride, const float *ang,
    ptrdiff_t ang_plane, ptrdiff_t ang_stride, float *co, ptrdiff_t co_plane,
    ptrdiff_t co_stride) {
  ksl_vec3f_t lin_i;
  if (n > 0) lin_i = ksl_vec3f_of_planes(lin, lin_plane);
  KSL_EACH_OF(n) {
    if (lin_stride) lin_i = ksl_vec3f_of_planes(lin + i * lin_stride, lin_plane);
    const ksl_vec3f_t ang_i = ksl_vec3f_of_planes(ang + i * ang_stride, ang_plane);
    ksl_coscrewf_t co_i;
    ksl_coscrewf_from_lin_ang(&lin_i, &ang_i, &co_i);
    ksl_coscrewf_to_planes(&co_i, co + i * co_stride, co_plane);
  }
}

/* ksl_coscrewf_to_angular_first of n elements. */
static KSL_INLINED void ksl_coscrewf_to_angular_first_many(ptrdiff_t n, const ksl_coscrewf_t *ci,
    ptrdiff_t ci_stride, float *x, ptrdiff_t x_stride) {
  KSL_EACH_OF(n) {
    ksl_coscrewf_to_angular_first(ci + i * ci_stride, x + 6 * i * x_stride);
  }
}

static KSL_INLINED void ksl_coscrewf_to_angular_first_planes(ptrdiff_t n, const float *ci,
    ptrdiff_t ci_plane, ptrdiff_t ci_stride, float *x, ptrdiff_t x_plane,
    ptrdiff_t x_stride) {
  ksl_coscrewf_t ci_i;
  if (n > 0) ci_i = ksl_coscrewf_of_planes(ci, ci_plane);
  KSL_EACH_OF(n) {
    if (ci_stride) ci_i = ksl_coscrewf_of_planes(ci + i * ci_stride, ci_plane);
    float x_i[6];
    ksl_coscrewf_to_angular_first(&ci_i, x_i);
    x[0 + i * x_stride] = x_i[0];
    x[x_plane + i * x_stride] = x_i[1];
    x[2 * x_plane + i * x_stride] = x_i[2];
    x[3 * x_plane + i * x_stride] = x_i[3];
    x[4 * x_plane + i * x_stride] = x_i[4];
    x[5 * x_plane + i * x_stride] = x_i[5];
  }
}

/* ksl_coscrewf_from_angular_first of n elements. */
static KSL_INLINED void ksl_coscrewf_from_angular_first_many(ptrdiff_t n, const float *x,
    ptrdiff_t x_stride, ksl_coscrewf_t *co, ptrdiff_t co_stride) {
  KSL_EACH_OF(n) {
    ksl_coscrewf_from_angular_first(x + 6 * i * x_stride, co + i * co_stride);
  }
}

static KSL_INLINED void ksl_coscrewf_from_angular_first_planes(ptrdiff_t n, const float *x,
    ptrdiff_t x_plane, ptrdiff_t x_stride, float *co, ptrdiff_t co_plane,
    ptrdiff_t co_stride) {
  KSL_EACH_OF(n) {
    const float x_i[6] = {x[0 + i * x_stride], x[x_plane + i * x_stride],
        x[2 * x_plane + i * x_stride], x[3 * x_plane + i * x_stride], x[4 * x_plane + i * x_stride],
        x[5 * x_plane + i * x_stride]};
    ksl_coscrewf_t co_i;
    ksl_coscrewf_from_angular_first(x_i, &co_i);
    ksl_coscrewf_to_planes(&co_i, co + i * co_stride, co_plane);
  }
}

/* ksl_add_cctf of n elements. */
static KSL_INLINED void ksl_add_cctf_many(ptrdiff_t n, const ksl_coscrewf_t *c1,
    ptrdiff_t c1_stride, const ksl_coscrewf_t *c2, ptrdiff_t c2_stride,
    ksl_coscrewf_t *co, ptrdiff_t co_stride) {
  KSL_EACH_OF(n) {
    ksl_add_cctf(c1 + i * c1_stride, c2 + i * c2_stride, co + i * co_stride);
  }
}

static KSL_INLINED void ksl_add_cctf_planes(ptrdiff_t n, const float *c1, ptrdiff_t c1_plane,
    ptrdiff_t c1_stride, const float *c2, ptrdiff_t c2_plane,
    ptrdiff_t c2_stride, float *co, ptrdiff_t co_plane, ptrdiff_t co_stride) {
  ksl_coscrewf_t c1_i;
  if (n > 0) c1_i = ksl_coscrewf_of_planes(c1, c1_plane);
  KSL_EACH_OF(n) {
    if (c1_stride) c1_i = ksl_coscrewf_of_planes(c1 + i * c1_stride, c1_plane);
    const ksl_coscrewf_t c2_i = ksl_coscrewf_of_planes(c2 + i * c2_stride, c2_plane);
    ksl_coscrewf_t co_i;
    ksl_add_cctf(&c1_i, &c2_i, &co_i);
    ksl_coscrewf_to_planes(&co_i, co + i * co_stride, co_plane);
  }
}

/* ksl_product_CoAdtcf of n elements. */
static KSL_INLINED void ksl_product_CoAdtcf_many(ptrdiff_t n, const ksl_vec3f_t *t,
    ptrdiff_t t_stride, const ksl_coscrewf_t *ci, ptrdiff_t ci_stride,
    ksl_coscrewf_t *co, ptrdiff_t co_stride) {
  KSL_EACH_OF(n) {
    ksl_product_CoAdtcf(t + i * t_stride, ci + i * ci_stride, co + i * co_stride);
  }
}

static KSL_INLINED void ksl_product_CoAdtcf_planes(ptrdiff_t n, const float *t, ptrdiff_t t_plane,
    ptrdiff_t t_stride, const float *ci, ptrdiff_t ci_plane, ptrdiff_t ci_stride,
    float *co, ptrdiff_t co_plane, ptrdiff_t co_stride) {
  ksl_vec3f_t t_i;
  if (n > 0) t_i = ksl_vec3f_of_planes(t, t_plane);
  KSL_EACH_OF(n) {
    if (t_stride) t_i = ksl_vec3f_of_planes(t + i * t_stride, t_plane);
    const ksl_coscrewf_t ci_i = ksl_coscrewf_of_planes(ci + i * ci_stride, ci_plane);
    ksl_coscrewf_t co_i;
    ksl_product_CoAdtcf(&t_i, &ci_i, &co_i);
    ksl_coscrewf_to_planes(&co_i, co + i * co_stride, co_plane);
  }
}

/* ksl_product_CoAdtinvcf of n elements. */
static KSL_INLINED void ksl_product_CoAdtinvcf_many(ptrdiff_t n, const ksl_vec3f_t *t,
    ptrdiff_t t_stride, const ksl_coscrewf_t *ci, ptrdiff_t ci_stride,
    ksl_coscrewf_t *co, ptrdiff_t co_stride) {
  KSL_EACH_OF(n) {
    ksl_product_CoAdtinvcf(t + i * t_stride, ci + i * ci_stride, co + i * co_stride);
  }
}

static KSL_INLINED void ksl_product_CoAdtinvcf_planes(ptrdiff_t n, const float *t,
    ptrdiff_t t_plane, ptrdiff_t t_stride, const float *ci, ptrdiff_t ci_plane,
    ptrdiff_t ci_stride, float *co, ptrdiff_t co_plane, ptrdiff_t co_stride) {
  ksl_vec3f_t t_i;
  if (n > 0) t_i = ksl_vec3f_of_planes(t, t_plane);
  KSL_EACH_OF(n) {
    if (t_stride) t_i = ksl_vec3f_of_planes(t + i * t_stride, t_plane);
    const ksl_coscrewf_t ci_i = ksl_coscrewf_of_planes(ci + i * ci_stride, ci_plane);
    ksl_coscrewf_t co_i;
    ksl_product_CoAdtinvcf(&t_i, &ci_i, &co_i);
    ksl_coscrewf_to_planes(&co_i, co + i * co_stride, co_plane);
  }
}

/* ksl_product_CoAdtcinvf of n elements. */
static KSL_INLINED void ksl_product_CoAdtcinvf_many(ptrdiff_t n, const ksl_vec3f_t *t,
    ptrdiff_t t_stride, const ksl_coscrewf_t *ci, ptrdiff_t ci_stride,
    ksl_coscrewf_t *co, ptrdiff_t co_stride) {
  KSL_EACH_OF(n) {
    ksl_product_CoAdtcinvf(t + i * t_stride, ci + i * ci_stride, co + i * co_stride);
  }
}

static KSL_INLINED void ksl_product_CoAdtcinvf_planes(ptrdiff_t n, const float *t,
    ptrdiff_t t_plane, ptrdiff_t t_stride, const float *ci, ptrdiff_t ci_plane,
    ptrdiff_t ci_stride, float *co, ptrdiff_t co_plane, ptrdiff_t co_stride) {
  ksl_vec3f_t t_i;
  if (n > 0) t_i = ksl_vec3f_of_planes(t, t_plane);
  KSL_EACH_OF(n) {
    if (t_stride) t_i = ksl_vec3f_of_planes(t + i * t_stride, t_plane);
    const ksl_coscrewf_t ci_i = ksl_coscrewf_of_planes(ci + i * ci_stride, ci_plane);
    ksl_coscrewf_t co_i;
    ksl_product_CoAdtcinvf(&t_i, &ci_i, &co_i);
    ksl_coscrewf_to_planes(&co_i, co + i * co_stride, co_plane);
  }
}

/* ksl_product_CoAdrcf of n elements. */
static KSL_INLINED void ksl_product_CoAdrcf_many(ptrdiff_t n, const ksl_mat3x3f_t *R,
    ptrdiff_t R_stride, const ksl_coscrewf_t *ci, ptrdiff_t ci_stride,
    ksl_coscrewf_t *co, ptrdiff_t co_stride) {
  KSL_EACH_OF(n) {
    ksl_product_CoAdrcf(R + i * R_stride, ci + i * ci_stride, co + i * co_stride);
  }
}

static KSL_INLINED void ksl_product_CoAdrcf_planes(ptrdiff_t n, const float *R, ptrdiff_t R_plane,
    ptrdiff_t R_stride, const float *ci, ptrdiff_t ci_plane, ptrdiff_t ci_stride,
    float *co, ptrdiff_t co_plane, ptrdiff_t co_stride) {
  ksl_mat3x3f_t R_i;
  if (n > 0) R_i = ksl_mat3x3f_of_planes(R, R_plane);
  KSL_EACH_OF(n) {
    if (R_stride) R_i = ksl_mat3x3f_of_planes(R + i * R_stride, R_plane);
    const ksl_coscrewf_t ci_i = ksl_coscrewf_of_planes(ci + i * ci_stride, ci_plane);
    ksl_coscrewf_t co_i;
    ksl_product_CoAdrcf(&R_i, &ci_i, &co_i);
    ksl_coscrewf_to_planes(&co_i, co + i * co_stride, co_plane);
  }
}

/* ksl_product_CoAdrinvcf of n elements. */
static KSL_INLINED void ksl_product_CoAdrinvcf_many(ptrdiff_t n, const ksl_mat3x3f_t *R,
    ptrdiff_t R_stride, const ksl_coscrewf_t *ci, ptrdiff_t ci_stride,
    ksl_coscrewf_t *co, ptrdiff_t co_stride) {
  KSL_EACH_OF(n) {
    ksl_product_CoAdrinvcf(R + i * R_stride, ci + i * ci_stride, co + i * co_stride);
  }
}

static KSL_INLINED void ksl_product_CoAdrinvcf_planes(ptrdiff_t n, const float *R,
    ptrdiff_t R_plane, ptrdiff_t R_stride, const float *ci, ptrdiff_t ci_plane,
    ptrdiff_t ci_stride, float *co, ptrdiff_t co_plane, ptrdiff_t co_stride) {
  ksl_mat3x3f_t R_i;
  if (n > 0) R_i = ksl_mat3x3f_of_planes(R, R_plane);
  KSL_EACH_OF(n) {
    if (R_stride) R_i = ksl_mat3x3f_of_planes(R + i * R_stride, R_plane);
    const ksl_coscrewf_t ci_i = ksl_coscrewf_of_planes(ci + i * ci_stride, ci_plane);
    ksl_coscrewf_t co_i;
    ksl_product_CoAdrinvcf(&R_i, &ci_i, &co_i);
    ksl_coscrewf_to_planes(&co_i, co + i * co_stride, co_plane);
  }
}

/* ksl_product_CoAdrcinvf of n elements. */
static KSL_INLINED void ksl_product_CoAdrcinvf_many(ptrdiff_t n, const ksl_mat3x3f_t *R,
    ptrdiff_t R_stride, const ksl_coscrewf_t *ci, ptrdiff_t ci_stride,
    ksl_coscrewf_t *co, ptrdiff_t co_stride) {
  KSL_EACH_OF(n) {
    ksl_product_CoAdrcinvf(R + i * R_stride, ci + i * ci_stride, co + i * co_stride);
  }
}

static KSL_INLINED void ksl_product_CoAdrcinvf_planes(ptrdiff_t n, const float *R,
    ptrdiff_t R_plane, ptrdiff_t R_stride, const float *ci, ptrdiff_t ci_plane,
    ptrdiff_t ci_stride, float *co, ptrdiff_t co_plane, ptrdiff_t co_stride) {
  ksl_mat3x3f_t R_i;
  if (n > 0) R_i = ksl_mat3x3f_of_planes(R, R_plane);
  KSL_EACH_OF(n) {
    if (R_stride) R_i = ksl_mat3x3f_of_planes(R + i * R_stride, R_plane);
    const ksl_coscrewf_t ci_i = ksl_coscrewf_of_planes(ci + i * ci_stride, ci_plane);
    ksl_coscrewf_t co_i;
    ksl_product_CoAdrcinvf(&R_i, &ci_i, &co_i);
    ksl_coscrewf_to_planes(&co_i, co + i * co_stride, co_plane);
  }
}

/* ksl_product_CoAdcf of n elements. */
static KSL_INLINED void ksl_product_CoAdcf_many(ptrdiff_t n, const ksl_SE3f_t *D,
    ptrdiff_t D_stride, const ksl_coscrewf_t *ci, ptrdiff_t ci_stride,
    ksl_coscrewf_t *co, ptrdiff_t co_stride) {
  KSL_EACH_OF(n) {
    ksl_product_CoAdcf(D + i * D_stride, ci + i * ci_stride, co + i * co_stride);
  }
}

static KSL_INLINED void ksl_product_CoAdcf_planes(ptrdiff_t n, const float *D, ptrdiff_t D_plane,
    ptrdiff_t D_stride, const float *ci, ptrdiff_t ci_plane, ptrdiff_t ci_stride,
    float *co, ptrdiff_t co_plane, ptrdiff_t co_stride) {
  ksl_SE3f_t D_i;
  if (n > 0) D_i = ksl_SE3f_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3f_of_planes(D + i * D_stride, D_plane);
    const ksl_coscrewf_t ci_i = ksl_coscrewf_of_planes(ci + i * ci_stride, ci_plane);
    ksl_coscrewf_t co_i;
    ksl_product_CoAdcf(&D_i, &ci_i, &co_i);
    ksl_coscrewf_to_planes(&co_i, co + i * co_stride, co_plane);
  }
}

/* ksl_product_CoAdinvcf of n elements. */
static KSL_INLINED void ksl_product_CoAdinvcf_many(ptrdiff_t n, const ksl_SE3f_t *D,
    ptrdiff_t D_stride, const ksl_coscrewf_t *ci, ptrdiff_t ci_stride,
    ksl_coscrewf_t *co, ptrdiff_t co_stride) {
  KSL_EACH_OF(n) {
    ksl_product_CoAdinvcf(D + i * D_stride, ci + i * ci_stride, co + i * co_stride);
  }
}

static KSL_INLINED void ksl_product_CoAdinvcf_planes(ptrdiff_t n, const float *D, ptrdiff_t D_plane,
    ptrdiff_t D_stride, const float *ci, ptrdiff_t ci_plane, ptrdiff_t ci_stride,
    float *co, ptrdiff_t co_plane, ptrdiff_t co_stride) {
  ksl_SE3f_t D_i;
  if (n > 0) D_i = ksl_SE3f_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3f_of_planes(D + i * D_stride, D_plane);
    const ksl_coscrewf_t ci_i = ksl_coscrewf_of_planes(ci + i * ci_stride, ci_plane);
    ksl_coscrewf_t co_i;
    ksl_product_CoAdinvcf(&D_i, &ci_i, &co_i);
    ksl_coscrewf_to_planes(&co_i, co + i * co_stride, co_plane);
  }
}

/* ksl_product_CoAdcinvf of n elements. */
static KSL_INLINED void ksl_product_CoAdcinvf_many(ptrdiff_t n, const ksl_SE3f_t *D,
    ptrdiff_t D_stride, const ksl_coscrewf_t *ci, ptrdiff_t ci_stride,
    ksl_coscrewf_t *co, ptrdiff_t co_stride) {
  KSL_EACH_OF(n) {
    ksl_product_CoAdcinvf(D + i * D_stride, ci + i * ci_stride, co + i * co_stride);
  }
}

static KSL_INLINED void ksl_product_CoAdcinvf_planes(ptrdiff_t n, const float *D, ptrdiff_t D_plane,
    ptrdiff_t D_stride, const float *ci, ptrdiff_t ci_plane, ptrdiff_t ci_stride,
    float *co, ptrdiff_t co_plane, ptrdiff_t co_stride) {
  ksl_SE3f_t D_i;
  if (n > 0) D_i = ksl_SE3f_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3f_of_planes(D + i * D_stride, D_plane);
    const ksl_coscrewf_t ci_i = ksl_coscrewf_of_planes(ci + i * ci_stride, ci_plane);
    ksl_coscrewf_t co_i;
    ksl_product_CoAdcinvf(&D_i, &ci_i, &co_i);
    ksl_coscrewf_to_planes(&co_i, co + i * co_stride, co_plane);
  }
}

/* ksl_hctxf of n elements. */
static KSL_INLINED void ksl_hctxf_many(ptrdiff_t n, const ksl_SE3f_t *D, ptrdiff_t D_stride,
    ksl_coscrewf_t *co, ptrdiff_t co_stride) {
  KSL_EACH_OF(n) {
    ksl_hctxf(D + i * D_stride, co + i * co_stride);
  }
}

static KSL_INLINED void ksl_hctxf_planes(ptrdiff_t n, const float *D, ptrdiff_t D_plane,
    ptrdiff_t D_stride, float *co, ptrdiff_t co_plane, ptrdiff_t co_stride) {
  ksl_SE3f_t D_i;
  if (n > 0) D_i = ksl_SE3f_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3f_of_planes(D + i * D_stride, D_plane);
    ksl_coscrewf_t co_i;
    ksl_hctxf(&D_i, &co_i);
    ksl_coscrewf_to_planes(&co_i, co + i * co_stride, co_plane);
  }
}

/* ksl_hctyf of n elements. */
static KSL_INLINED void ksl_hctyf_many(ptrdiff_t n, const ksl_SE3f_t *D, ptrdiff_t D_stride,
    ksl_coscrewf_t *co, ptrdiff_t co_stride) {
  KSL_EACH_OF(n) {
    ksl_hctyf(D + i * D_stride, co + i * co_stride);
  }
}

static KSL_INLINED void ksl_hctyf_planes(ptrdiff_t n, const float *D, ptrdiff_t D_plane,
    ptrdiff_t D_stride, float *co, ptrdiff_t co_plane, ptrdiff_t co_stride) {
  ksl_SE3f_t D_i;
  if (n > 0) D_i = ksl_SE3f_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3f_of_planes(D + i * D_stride, D_plane);
    ksl_coscrewf_t co_i;
    ksl_hctyf(&D_i, &co_i);
    ksl_coscrewf_to_planes(&co_i, co + i * co_stride, co_plane);
  }
}

/* ksl_hctzf of n elements. */
static KSL_INLINED void ksl_hctzf_many(ptrdiff_t n, const ksl_SE3f_t *D, ptrdiff_t D_stride,
    ksl_coscrewf_t *co, ptrdiff_t co_stride) {
  KSL_EACH_OF(n) {
    ksl_hctzf(D + i * D_stride, co + i * co_stride);
  }
}

static KSL_INLINED void ksl_hctzf_planes(ptrdiff_t n, const float *D, ptrdiff_t D_plane,
    ptrdiff_t D_stride, float *co, ptrdiff_t co_plane, ptrdiff_t co_stride) {
  ksl_SE3f_t D_i;
  if (n > 0) D_i = ksl_SE3f_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3f_of_planes(D + i * D_stride, D_plane);
    ksl_coscrewf_t co_i;
    ksl_hctzf(&D_i, &co_i);
    ksl_coscrewf_to_planes(&co_i, co + i * co_stride, co_plane);
  }
}

/* ksl_hcrxf of n elements. */
static KSL_INLINED void ksl_hcrxf_many(ptrdiff_t n, const ksl_SE3f_t *D, ptrdiff_t D_stride,
    ksl_coscrewf_t *co, ptrdiff_t co_stride) {
  KSL_EACH_OF(n) {
    ksl_hcrxf(D + i * D_stride, co + i * co_stride);
  }
}

static KSL_INLINED void ksl_hcrxf_planes(ptrdiff_t n, const float *D, ptrdiff_t D_plane,
    ptrdiff_t D_stride, float *co, ptrdiff_t co_plane, ptrdiff_t co_stride) {
  ksl_SE3f_t D_i;
  if (n > 0) D_i = ksl_SE3f_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3f_of_planes(D + i * D_stride, D_plane);
    ksl_coscrewf_t co_i;
    ksl_hcrxf(&D_i, &co_i);
    ksl_coscrewf_to_planes(&co_i, co + i * co_stride, co_plane);
  }
}

/* ksl_hcryf of n elements. */
static KSL_INLINED void ksl_hcryf_many(ptrdiff_t n, const ksl_SE3f_t *D, ptrdiff_t D_stride,
    ksl_coscrewf_t *co, ptrdiff_t co_stride) {
  KSL_EACH_OF(n) {
    ksl_hcryf(D + i * D_stride, co + i * co_stride);
  }
}

static KSL_INLINED void ksl_hcryf_planes(ptrdiff_t n, const float *D, ptrdiff_t D_plane,
    ptrdiff_t D_stride, float *co, ptrdiff_t co_plane, ptrdiff_t co_stride) {
  ksl_SE3f_t D_i;
  if (n > 0) D_i = ksl_SE3f_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3f_of_planes(D + i * D_stride, D_plane);
    ksl_coscrewf_t co_i;
    ksl_hcryf(&D_i, &co_i);
    ksl_coscrewf_to_planes(&co_i, co + i * co_stride, co_plane);
  }
}

/* ksl_hcrzf of n elements. */
static KSL_INLINED void ksl_hcrzf_many(ptrdiff_t n, const ksl_SE3f_t *D, ptrdiff_t D_stride,
    ksl_coscrewf_t *co, ptrdiff_t co_stride) {
  KSL_EACH_OF(n) {
    ksl_hcrzf(D + i * D_stride, co + i * co_stride);
  }
}

static KSL_INLINED void ksl_hcrzf_planes(ptrdiff_t n, const float *D, ptrdiff_t D_plane,
    ptrdiff_t D_stride, float *co, ptrdiff_t co_plane, ptrdiff_t co_stride) {
  ksl_SE3f_t D_i;
  if (n > 0) D_i = ksl_SE3f_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3f_of_planes(D + i * D_stride, D_plane);
    ksl_coscrewf_t co_i;
    ksl_hcrzf(&D_i, &co_i);
    ksl_coscrewf_to_planes(&co_i, co + i * co_stride, co_plane);
  }
}

/* ksl_hctxinvf of n elements. */
static KSL_INLINED void ksl_hctxinvf_many(ptrdiff_t n, const ksl_SE3f_t *D, ptrdiff_t D_stride,
    ksl_coscrewf_t *co, ptrdiff_t co_stride) {
  KSL_EACH_OF(n) {
    ksl_hctxinvf(D + i * D_stride, co + i * co_stride);
  }
}

static KSL_INLINED void ksl_hctxinvf_planes(ptrdiff_t n, const float *D, ptrdiff_t D_plane,
    ptrdiff_t D_stride, float *co, ptrdiff_t co_plane, ptrdiff_t co_stride) {
  ksl_SE3f_t D_i;
  if (n > 0) D_i = ksl_SE3f_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3f_of_planes(D + i * D_stride, D_plane);
    ksl_coscrewf_t co_i;
    ksl_hctxinvf(&D_i, &co_i);
    ksl_coscrewf_to_planes(&co_i, co + i * co_stride, co_plane);
  }
}

/* ksl_hctyinvf of n elements. */
static KSL_INLINED void ksl_hctyinvf_many(ptrdiff_t n, const ksl_SE3f_t *D, ptrdiff_t D_stride,
    ksl_coscrewf_t *co, ptrdiff_t co_stride) {
  KSL_EACH_OF(n) {
    ksl_hctyinvf(D + i * D_stride, co + i * co_stride);
  }
}

static KSL_INLINED void ksl_hctyinvf_planes(ptrdiff_t n, const float *D, ptrdiff_t D_plane,
    ptrdiff_t D_stride, float *co, ptrdiff_t co_plane, ptrdiff_t co_stride) {
  ksl_SE3f_t D_i;
  if (n > 0) D_i = ksl_SE3f_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3f_of_planes(D + i * D_stride, D_plane);
    ksl_coscrewf_t co_i;
    ksl_hctyinvf(&D_i, &co_i);
    ksl_coscrewf_to_planes(&co_i, co + i * co_stride, co_plane);
  }
}

/* ksl_hctzinvf of n elements. */
static KSL_INLINED void ksl_hctzinvf_many(ptrdiff_t n, const ksl_SE3f_t *D, ptrdiff_t D_stride,
    ksl_coscrewf_t *co, ptrdiff_t co_stride) {
  KSL_EACH_OF(n) {
    ksl_hctzinvf(D + i * D_stride, co + i * co_stride);
  }
}

static KSL_INLINED void ksl_hctzinvf_planes(ptrdiff_t n, const float *D, ptrdiff_t D_plane,
    ptrdiff_t D_stride, float *co, ptrdiff_t co_plane, ptrdiff_t co_stride) {
  ksl_SE3f_t D_i;
  if (n > 0) D_i = ksl_SE3f_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3f_of_planes(D + i * D_stride, D_plane);
    ksl_coscrewf_t co_i;
    ksl_hctzinvf(&D_i, &co_i);
    ksl_coscrewf_to_planes(&co_i, co + i * co_stride, co_plane);
  }
}

/* ksl_hcrxinvf of n elements. */
static KSL_INLINED void ksl_hcrxinvf_many(ptrdiff_t n, const ksl_SE3f_t *D, ptrdiff_t D_stride,
    ksl_coscrewf_t *co, ptrdiff_t co_stride) {
  KSL_EACH_OF(n) {
    ksl_hcrxinvf(D + i * D_stride, co + i * co_stride);
  }
}

static KSL_INLINED void ksl_hcrxinvf_planes(ptrdiff_t n, const float *D, ptrdiff_t D_plane,
    ptrdiff_t D_stride, float *co, ptrdiff_t co_plane, ptrdiff_t co_stride) {
  ksl_SE3f_t D_i;
  if (n > 0) D_i = ksl_SE3f_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3f_of_planes(D + i * D_stride, D_plane);
    ksl_coscrewf_t co_i;
    ksl_hcrxinvf(&D_i, &co_i);
    ksl_coscrewf_to_planes(&co_i, co + i * co_stride, co_plane);
  }
}

/* ksl_hcryinvf of n elements. */
static KSL_INLINED void ksl_hcryinvf_many(ptrdiff_t n, const ksl_SE3f_t *D, ptrdiff_t D_stride,
    ksl_coscrewf_t *co, ptrdiff_t co_stride) {
  KSL_EACH_OF(n) {
    ksl_hcryinvf(D + i * D_stride, co + i * co_stride);
  }
}

static KSL_INLINED void ksl_hcryinvf_planes(ptrdiff_t n, const float *D, ptrdiff_t D_plane,
    ptrdiff_t D_stride, float *co, ptrdiff_t co_plane, ptrdiff_t co_stride) {
  ksl_SE3f_t D_i;
  if (n > 0) D_i = ksl_SE3f_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3f_of_planes(D + i * D_stride, D_plane);
    ksl_coscrewf_t co_i;
    ksl_hcryinvf(&D_i, &co_i);
    ksl_coscrewf_to_planes(&co_i, co + i * co_stride, co_plane);
  }
}

/* ksl_hcrzinvf of n elements. */
static KSL_INLINED void ksl_hcrzinvf_many(ptrdiff_t n, const ksl_SE3f_t *D, ptrdiff_t D_stride,
    ksl_coscrewf_t *co, ptrdiff_t co_stride) {
  KSL_EACH_OF(n) {
    ksl_hcrzinvf(D + i * D_stride, co + i * co_stride);
  }
}

static KSL_INLINED void ksl_hcrzinvf_planes(ptrdiff_t n, const float *D, ptrdiff_t D_plane,
    ptrdiff_t D_stride, float *co, ptrdiff_t co_plane, ptrdiff_t co_stride) {
  ksl_SE3f_t D_i;
  if (n > 0) D_i = ksl_SE3f_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3f_of_planes(D + i * D_stride, D_plane);
    ksl_coscrewf_t co_i;
    ksl_hcrzinvf(&D_i, &co_i);
    ksl_coscrewf_to_planes(&co_i, co + i * co_stride, co_plane);
  }
}

/* ksl_CoAdf of n elements. */
static KSL_INLINED void ksl_CoAdf_many(ptrdiff_t n, const ksl_SE3f_t *D, ptrdiff_t D_stride,
    ksl_mat6x6f_t *M, ptrdiff_t M_stride) {
  KSL_EACH_OF(n) {
    ksl_CoAdf(D + i * D_stride, M + i * M_stride);
  }
}

static KSL_INLINED void ksl_CoAdf_planes(ptrdiff_t n, const float *D, ptrdiff_t D_plane,
    ptrdiff_t D_stride, float *M, ptrdiff_t M_plane, ptrdiff_t M_stride) {
  ksl_SE3f_t D_i;
  if (n > 0) D_i = ksl_SE3f_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3f_of_planes(D + i * D_stride, D_plane);
    ksl_mat6x6f_t M_i;
    ksl_CoAdf(&D_i, &M_i);
    ksl_mat6x6f_to_planes(&M_i, M + i * M_stride, M_plane);
  }
}

/* ksl_reciprocal_productf of n elements. */
static KSL_INLINED void ksl_reciprocal_productf_many(ptrdiff_t n, const ksl_coscrewf_t *c,
    ptrdiff_t c_stride, const float *x, ptrdiff_t x_stride, float *power,
    ptrdiff_t power_stride) {
  KSL_EACH_OF(n) {
    power[i * power_stride] = ksl_reciprocal_productf(c + i * c_stride, x + 6 * i * x_stride);
  }
}

static KSL_INLINED void ksl_reciprocal_productf_planes(ptrdiff_t n, const float *c,
    ptrdiff_t c_plane, ptrdiff_t c_stride, const float *x, ptrdiff_t x_plane,
    ptrdiff_t x_stride, float *power, ptrdiff_t power_stride) {
  ksl_coscrewf_t c_i;
  if (n > 0) c_i = ksl_coscrewf_of_planes(c, c_plane);
  KSL_EACH_OF(n) {
    if (c_stride) c_i = ksl_coscrewf_of_planes(c + i * c_stride, c_plane);
    const float x_i[6] = {x[0 + i * x_stride], x[x_plane + i * x_stride],
        x[2 * x_plane + i * x_stride], x[3 * x_plane + i * x_stride], x[4 * x_plane + i * x_stride],
        x[5 * x_plane + i * x_stride]};
    power[i * power_stride] = ksl_reciprocal_productf(&c_i, x_i);
  }
}

/* ksl_cross_scf of n elements. */
static KSL_INLINED void ksl_cross_scf_many(ptrdiff_t n, const ksl_screwf_t *s, ptrdiff_t s_stride,
    const ksl_coscrewf_t *c, ptrdiff_t c_stride, ksl_coscrewf_t *co,
    ptrdiff_t co_stride) {
  KSL_EACH_OF(n) {
    ksl_cross_scf(s + i * s_stride, c + i * c_stride, co + i * co_stride);
  }
}

static KSL_INLINED void ksl_cross_scf_planes(ptrdiff_t n, const float *s, ptrdiff_t s_plane,
    ptrdiff_t s_stride, const float *c, ptrdiff_t c_plane, ptrdiff_t c_stride,
    float *co, ptrdiff_t co_plane, ptrdiff_t co_stride) {
  ksl_screwf_t s_i;
  if (n > 0) s_i = ksl_screwf_of_planes(s, s_plane);
  KSL_EACH_OF(n) {
    if (s_stride) s_i = ksl_screwf_of_planes(s + i * s_stride, s_plane);
    const ksl_coscrewf_t c_i = ksl_coscrewf_of_planes(c + i * c_stride, c_plane);
    ksl_coscrewf_t co_i;
    ksl_cross_scf(&s_i, &c_i, &co_i);
    ksl_coscrewf_to_planes(&co_i, co + i * co_stride, co_plane);
  }
}

/* ksl_cross_scaf of n elements. */
static KSL_INLINED void ksl_cross_scaf_many(ptrdiff_t n, const ksl_screwf_t *s, ptrdiff_t s_stride,
    const ksl_coscrewf_t *c, ptrdiff_t c_stride, ksl_coscrewf_t *co,
    ptrdiff_t co_stride) {
  KSL_EACH_OF(n) {
    ksl_cross_scaf(s + i * s_stride, c + i * c_stride, co + i * co_stride);
  }
}

static KSL_INLINED void ksl_cross_scaf_planes(ptrdiff_t n, const float *s, ptrdiff_t s_plane,
    ptrdiff_t s_stride, const float *c, ptrdiff_t c_plane, ptrdiff_t c_stride,
    float *co, ptrdiff_t co_plane, ptrdiff_t co_stride) {
  ksl_screwf_t s_i;
  if (n > 0) s_i = ksl_screwf_of_planes(s, s_plane);
  KSL_EACH_OF(n) {
    if (s_stride) s_i = ksl_screwf_of_planes(s + i * s_stride, s_plane);
    const ksl_coscrewf_t c_i = ksl_coscrewf_of_planes(c + i * c_stride, c_plane);
    ksl_coscrewf_t co_i;
    ksl_cross_scaf(&s_i, &c_i, &co_i);
    ksl_coscrewf_to_planes(&co_i, co + i * co_stride, co_plane);
  }
}

/* ksl_constraint_ctxf of n elements. */
static KSL_INLINED void ksl_constraint_ctxf_many(ptrdiff_t n, const ksl_SE3f_t *D,
    ptrdiff_t D_stride, const ksl_coscrewf_t *c, ptrdiff_t c_stride,
    ksl_coscrewf_t *co, ptrdiff_t co_stride) {
  KSL_EACH_OF(n) {
    ksl_constraint_ctxf(D + i * D_stride, c + i * c_stride, co + i * co_stride);
  }
}

static KSL_INLINED void ksl_constraint_ctxf_planes(ptrdiff_t n, const float *D, ptrdiff_t D_plane,
    ptrdiff_t D_stride, const float *c, ptrdiff_t c_plane, ptrdiff_t c_stride,
    float *co, ptrdiff_t co_plane, ptrdiff_t co_stride) {
  ksl_SE3f_t D_i;
  if (n > 0) D_i = ksl_SE3f_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3f_of_planes(D + i * D_stride, D_plane);
    const ksl_coscrewf_t c_i = ksl_coscrewf_of_planes(c + i * c_stride, c_plane);
    ksl_coscrewf_t co_i;
    ksl_constraint_ctxf(&D_i, &c_i, &co_i);
    ksl_coscrewf_to_planes(&co_i, co + i * co_stride, co_plane);
  }
}

/* ksl_constraint_ctyf of n elements. */
static KSL_INLINED void ksl_constraint_ctyf_many(ptrdiff_t n, const ksl_SE3f_t *D,
    ptrdiff_t D_stride, const ksl_coscrewf_t *c, ptrdiff_t c_stride,
    ksl_coscrewf_t *co, ptrdiff_t co_stride) {
  KSL_EACH_OF(n) {
    ksl_constraint_ctyf(D + i * D_stride, c + i * c_stride, co + i * co_stride);
  }
}

static KSL_INLINED void ksl_constraint_ctyf_planes(ptrdiff_t n, const float *D, ptrdiff_t D_plane,
    ptrdiff_t D_stride, const float *c, ptrdiff_t c_plane, ptrdiff_t c_stride,
    float *co, ptrdiff_t co_plane, ptrdiff_t co_stride) {
  ksl_SE3f_t D_i;
  if (n > 0) D_i = ksl_SE3f_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3f_of_planes(D + i * D_stride, D_plane);
    const ksl_coscrewf_t c_i = ksl_coscrewf_of_planes(c + i * c_stride, c_plane);
    ksl_coscrewf_t co_i;
    ksl_constraint_ctyf(&D_i, &c_i, &co_i);
    ksl_coscrewf_to_planes(&co_i, co + i * co_stride, co_plane);
  }
}

/* ksl_constraint_ctzf of n elements. */
static KSL_INLINED void ksl_constraint_ctzf_many(ptrdiff_t n, const ksl_SE3f_t *D,
    ptrdiff_t D_stride, const ksl_coscrewf_t *c, ptrdiff_t c_stride,
    ksl_coscrewf_t *co, ptrdiff_t co_stride) {
  KSL_EACH_OF(n) {
    ksl_constraint_ctzf(D + i * D_stride, c + i * c_stride, co + i * co_stride);
  }
}

static KSL_INLINED void ksl_constraint_ctzf_planes(ptrdiff_t n, const float *D, ptrdiff_t D_plane,
    ptrdiff_t D_stride, const float *c, ptrdiff_t c_plane, ptrdiff_t c_stride,
    float *co, ptrdiff_t co_plane, ptrdiff_t co_stride) {
  ksl_SE3f_t D_i;
  if (n > 0) D_i = ksl_SE3f_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3f_of_planes(D + i * D_stride, D_plane);
    const ksl_coscrewf_t c_i = ksl_coscrewf_of_planes(c + i * c_stride, c_plane);
    ksl_coscrewf_t co_i;
    ksl_constraint_ctzf(&D_i, &c_i, &co_i);
    ksl_coscrewf_to_planes(&co_i, co + i * co_stride, co_plane);
  }
}

/* ksl_constraint_crxf of n elements. */
static KSL_INLINED void ksl_constraint_crxf_many(ptrdiff_t n, const ksl_SE3f_t *D,
    ptrdiff_t D_stride, const ksl_coscrewf_t *c, ptrdiff_t c_stride,
    ksl_coscrewf_t *co, ptrdiff_t co_stride) {
  KSL_EACH_OF(n) {
    ksl_constraint_crxf(D + i * D_stride, c + i * c_stride, co + i * co_stride);
  }
}

static KSL_INLINED void ksl_constraint_crxf_planes(ptrdiff_t n, const float *D, ptrdiff_t D_plane,
    ptrdiff_t D_stride, const float *c, ptrdiff_t c_plane, ptrdiff_t c_stride,
    float *co, ptrdiff_t co_plane, ptrdiff_t co_stride) {
  ksl_SE3f_t D_i;
  if (n > 0) D_i = ksl_SE3f_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3f_of_planes(D + i * D_stride, D_plane);
    const ksl_coscrewf_t c_i = ksl_coscrewf_of_planes(c + i * c_stride, c_plane);
    ksl_coscrewf_t co_i;
    ksl_constraint_crxf(&D_i, &c_i, &co_i);
    ksl_coscrewf_to_planes(&co_i, co + i * co_stride, co_plane);
  }
}

/* ksl_constraint_cryf of n elements. */
static KSL_INLINED void ksl_constraint_cryf_many(ptrdiff_t n, const ksl_SE3f_t *D,
    ptrdiff_t D_stride, const ksl_coscrewf_t *c, ptrdiff_t c_stride,
    ksl_coscrewf_t *co, ptrdiff_t co_stride) {
  KSL_EACH_OF(n) {
    ksl_constraint_cryf(D + i * D_stride, c + i * c_stride, co + i * co_stride);
  }
}

static KSL_INLINED void ksl_constraint_cryf_planes(ptrdiff_t n, const float *D, ptrdiff_t D_plane,
    ptrdiff_t D_stride, const float *c, ptrdiff_t c_plane, ptrdiff_t c_stride,
    float *co, ptrdiff_t co_plane, ptrdiff_t co_stride) {
  ksl_SE3f_t D_i;
  if (n > 0) D_i = ksl_SE3f_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3f_of_planes(D + i * D_stride, D_plane);
    const ksl_coscrewf_t c_i = ksl_coscrewf_of_planes(c + i * c_stride, c_plane);
    ksl_coscrewf_t co_i;
    ksl_constraint_cryf(&D_i, &c_i, &co_i);
    ksl_coscrewf_to_planes(&co_i, co + i * co_stride, co_plane);
  }
}

/* ksl_constraint_crzf of n elements. */
static KSL_INLINED void ksl_constraint_crzf_many(ptrdiff_t n, const ksl_SE3f_t *D,
    ptrdiff_t D_stride, const ksl_coscrewf_t *c, ptrdiff_t c_stride,
    ksl_coscrewf_t *co, ptrdiff_t co_stride) {
  KSL_EACH_OF(n) {
    ksl_constraint_crzf(D + i * D_stride, c + i * c_stride, co + i * co_stride);
  }
}

static KSL_INLINED void ksl_constraint_crzf_planes(ptrdiff_t n, const float *D, ptrdiff_t D_plane,
    ptrdiff_t D_stride, const float *c, ptrdiff_t c_plane, ptrdiff_t c_stride,
    float *co, ptrdiff_t co_plane, ptrdiff_t co_stride) {
  ksl_SE3f_t D_i;
  if (n > 0) D_i = ksl_SE3f_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3f_of_planes(D + i * D_stride, D_plane);
    const ksl_coscrewf_t c_i = ksl_coscrewf_of_planes(c + i * c_stride, c_plane);
    ksl_coscrewf_t co_i;
    ksl_constraint_crzf(&D_i, &c_i, &co_i);
    ksl_coscrewf_to_planes(&co_i, co + i * co_stride, co_plane);
  }
}

/* ksl_working_ctxf of n elements. */
static KSL_INLINED void ksl_working_ctxf_many(ptrdiff_t n, const ksl_SE3f_t *D, ptrdiff_t D_stride,
    const ksl_coscrewf_t *c, ptrdiff_t c_stride, ksl_coscrewf_t *co,
    ptrdiff_t co_stride) {
  KSL_EACH_OF(n) {
    ksl_working_ctxf(D + i * D_stride, c + i * c_stride, co + i * co_stride);
  }
}

static KSL_INLINED void ksl_working_ctxf_planes(ptrdiff_t n, const float *D, ptrdiff_t D_plane,
    ptrdiff_t D_stride, const float *c, ptrdiff_t c_plane, ptrdiff_t c_stride,
    float *co, ptrdiff_t co_plane, ptrdiff_t co_stride) {
  ksl_SE3f_t D_i;
  if (n > 0) D_i = ksl_SE3f_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3f_of_planes(D + i * D_stride, D_plane);
    const ksl_coscrewf_t c_i = ksl_coscrewf_of_planes(c + i * c_stride, c_plane);
    ksl_coscrewf_t co_i;
    ksl_working_ctxf(&D_i, &c_i, &co_i);
    ksl_coscrewf_to_planes(&co_i, co + i * co_stride, co_plane);
  }
}

/* ksl_working_ctyf of n elements. */
static KSL_INLINED void ksl_working_ctyf_many(ptrdiff_t n, const ksl_SE3f_t *D, ptrdiff_t D_stride,
    const ksl_coscrewf_t *c, ptrdiff_t c_stride, ksl_coscrewf_t *co,
    ptrdiff_t co_stride) {
  KSL_EACH_OF(n) {
    ksl_working_ctyf(D + i * D_stride, c + i * c_stride, co + i * co_stride);
  }
}

static KSL_INLINED void ksl_working_ctyf_planes(ptrdiff_t n, const float *D, ptrdiff_t D_plane,
    ptrdiff_t D_stride, const float *c, ptrdiff_t c_plane, ptrdiff_t c_stride,
    float *co, ptrdiff_t co_plane, ptrdiff_t co_stride) {
  ksl_SE3f_t D_i;
  if (n > 0) D_i = ksl_SE3f_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3f_of_planes(D + i * D_stride, D_plane);
    const ksl_coscrewf_t c_i = ksl_coscrewf_of_planes(c + i * c_stride, c_plane);
    ksl_coscrewf_t co_i;
    ksl_working_ctyf(&D_i, &c_i, &co_i);
    ksl_coscrewf_to_planes(&co_i, co + i * co_stride, co_plane);
  }
}

/* ksl_working_ctzf of n elements. */
static KSL_INLINED void ksl_working_ctzf_many(ptrdiff_t n, const ksl_SE3f_t *D, ptrdiff_t D_stride,
    const ksl_coscrewf_t *c, ptrdiff_t c_stride, ksl_coscrewf_t *co,
    ptrdiff_t co_stride) {
  KSL_EACH_OF(n) {
    ksl_working_ctzf(D + i * D_stride, c + i * c_stride, co + i * co_stride);
  }
}

static KSL_INLINED void ksl_working_ctzf_planes(ptrdiff_t n, const float *D, ptrdiff_t D_plane,
    ptrdiff_t D_stride, const float *c, ptrdiff_t c_plane, ptrdiff_t c_stride,
    float *co, ptrdiff_t co_plane, ptrdiff_t co_stride) {
  ksl_SE3f_t D_i;
  if (n > 0) D_i = ksl_SE3f_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3f_of_planes(D + i * D_stride, D_plane);
    const ksl_coscrewf_t c_i = ksl_coscrewf_of_planes(c + i * c_stride, c_plane);
    ksl_coscrewf_t co_i;
    ksl_working_ctzf(&D_i, &c_i, &co_i);
    ksl_coscrewf_to_planes(&co_i, co + i * co_stride, co_plane);
  }
}

/* ksl_working_crxf of n elements. */
static KSL_INLINED void ksl_working_crxf_many(ptrdiff_t n, const ksl_SE3f_t *D, ptrdiff_t D_stride,
    const ksl_coscrewf_t *c, ptrdiff_t c_stride, ksl_coscrewf_t *co,
    ptrdiff_t co_stride) {
  KSL_EACH_OF(n) {
    ksl_working_crxf(D + i * D_stride, c + i * c_stride, co + i * co_stride);
  }
}

static KSL_INLINED void ksl_working_crxf_planes(ptrdiff_t n, const float *D, ptrdiff_t D_plane,
    ptrdiff_t D_stride, const float *c, ptrdiff_t c_plane, ptrdiff_t c_stride,
    float *co, ptrdiff_t co_plane, ptrdiff_t co_stride) {
  ksl_SE3f_t D_i;
  if (n > 0) D_i = ksl_SE3f_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3f_of_planes(D + i * D_stride, D_plane);
    const ksl_coscrewf_t c_i = ksl_coscrewf_of_planes(c + i * c_stride, c_plane);
    ksl_coscrewf_t co_i;
    ksl_working_crxf(&D_i, &c_i, &co_i);
    ksl_coscrewf_to_planes(&co_i, co + i * co_stride, co_plane);
  }
}

/* ksl_working_cryf of n elements. */
static KSL_INLINED void ksl_working_cryf_many(ptrdiff_t n, const ksl_SE3f_t *D, ptrdiff_t D_stride,
    const ksl_coscrewf_t *c, ptrdiff_t c_stride, ksl_coscrewf_t *co,
    ptrdiff_t co_stride) {
  KSL_EACH_OF(n) {
    ksl_working_cryf(D + i * D_stride, c + i * c_stride, co + i * co_stride);
  }
}

static KSL_INLINED void ksl_working_cryf_planes(ptrdiff_t n, const float *D, ptrdiff_t D_plane,
    ptrdiff_t D_stride, const float *c, ptrdiff_t c_plane, ptrdiff_t c_stride,
    float *co, ptrdiff_t co_plane, ptrdiff_t co_stride) {
  ksl_SE3f_t D_i;
  if (n > 0) D_i = ksl_SE3f_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3f_of_planes(D + i * D_stride, D_plane);
    const ksl_coscrewf_t c_i = ksl_coscrewf_of_planes(c + i * c_stride, c_plane);
    ksl_coscrewf_t co_i;
    ksl_working_cryf(&D_i, &c_i, &co_i);
    ksl_coscrewf_to_planes(&co_i, co + i * co_stride, co_plane);
  }
}

/* ksl_working_crzf of n elements. */
static KSL_INLINED void ksl_working_crzf_many(ptrdiff_t n, const ksl_SE3f_t *D, ptrdiff_t D_stride,
    const ksl_coscrewf_t *c, ptrdiff_t c_stride, ksl_coscrewf_t *co,
    ptrdiff_t co_stride) {
  KSL_EACH_OF(n) {
    ksl_working_crzf(D + i * D_stride, c + i * c_stride, co + i * co_stride);
  }
}

static KSL_INLINED void ksl_working_crzf_planes(ptrdiff_t n, const float *D, ptrdiff_t D_plane,
    ptrdiff_t D_stride, const float *c, ptrdiff_t c_plane, ptrdiff_t c_stride,
    float *co, ptrdiff_t co_plane, ptrdiff_t co_stride) {
  ksl_SE3f_t D_i;
  if (n > 0) D_i = ksl_SE3f_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3f_of_planes(D + i * D_stride, D_plane);
    const ksl_coscrewf_t c_i = ksl_coscrewf_of_planes(c + i * c_stride, c_plane);
    ksl_coscrewf_t co_i;
    ksl_working_crzf(&D_i, &c_i, &co_i);
    ksl_coscrewf_to_planes(&co_i, co + i * co_stride, co_plane);
  }
}

/* ksl_coadf of n elements. */
static KSL_INLINED void ksl_coadf_many(ptrdiff_t n, const ksl_screwf_t *s, ptrdiff_t s_stride,
    ksl_mat6x6f_t *M, ptrdiff_t M_stride) {
  KSL_EACH_OF(n) {
    ksl_coadf(s + i * s_stride, M + i * M_stride);
  }
}

static KSL_INLINED void ksl_coadf_planes(ptrdiff_t n, const float *s, ptrdiff_t s_plane,
    ptrdiff_t s_stride, float *M, ptrdiff_t M_plane, ptrdiff_t M_stride) {
  ksl_screwf_t s_i;
  if (n > 0) s_i = ksl_screwf_of_planes(s, s_plane);
  KSL_EACH_OF(n) {
    if (s_stride) s_i = ksl_screwf_of_planes(s + i * s_stride, s_plane);
    ksl_mat6x6f_t M_i;
    ksl_coadf(&s_i, &M_i);
    ksl_mat6x6f_to_planes(&M_i, M + i * M_stride, M_plane);
  }
}

#endif
