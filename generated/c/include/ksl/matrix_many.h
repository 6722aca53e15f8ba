/* Made by `coscrew generate`; changes are overwritten. */
/* SPDX-License-Identifier: MIT */
/* coscrew 0.2.0.  Copyright (c) 2026 The coscrew authors. */
/* Products between rotations, displacements and vectors.  Many at a time.
   What arguments are, and what loops over them cost, ksl_planes.h says. */
#ifndef KSL_MATRIX_MANY_H
#define KSL_MATRIX_MANY_H

#include "matrix.h"
#include "ksl_planes.h"

/* ksl_product_drv of n elements. */
static KSL_INLINED void ksl_product_drv_many(ptrdiff_t n, const ksl_mat3x3_t *R, ptrdiff_t R_stride,
    const ksl_vec3_t *v, ptrdiff_t v_stride, ksl_vec3_t *vo, ptrdiff_t vo_stride) {
  KSL_EACH_OF(n) {
    ksl_product_drv(R + i * R_stride, v + i * v_stride, vo + i * vo_stride);
  }
}

static KSL_INLINED void ksl_product_drv_planes(ptrdiff_t n, const double *R, ptrdiff_t R_plane,
    ptrdiff_t R_stride, const double *v, ptrdiff_t v_plane, ptrdiff_t v_stride,
    double *vo, ptrdiff_t vo_plane, ptrdiff_t vo_stride) {
  ksl_mat3x3_t R_i;
  if (n > 0) R_i = ksl_mat3x3_of_planes(R, R_plane);
  KSL_EACH_OF(n) {
    if (R_stride) R_i = ksl_mat3x3_of_planes(R + i * R_stride, R_plane);
    const ksl_vec3_t v_i = ksl_vec3_of_planes(v + i * v_stride, v_plane);
    ksl_vec3_t vo_i;
    ksl_product_drv(&R_i, &v_i, &vo_i);
    ksl_vec3_to_planes(&vo_i, vo + i * vo_stride, vo_plane);
  }
}

/* ksl_product_drvinv of n elements. */
static KSL_INLINED void ksl_product_drvinv_many(ptrdiff_t n, const ksl_mat3x3_t *R,
    ptrdiff_t R_stride, const ksl_vec3_t *v, ptrdiff_t v_stride, ksl_vec3_t *vo,
    ptrdiff_t vo_stride) {
  KSL_EACH_OF(n) {
    ksl_product_drvinv(R + i * R_stride, v + i * v_stride, vo + i * vo_stride);
  }
}

static KSL_INLINED void ksl_product_drvinv_planes(ptrdiff_t n, const double *R, ptrdiff_t R_plane,
    ptrdiff_t R_stride, const double *v, ptrdiff_t v_plane, ptrdiff_t v_stride,
    double *vo, ptrdiff_t vo_plane, ptrdiff_t vo_stride) {
  ksl_mat3x3_t R_i;
  if (n > 0) R_i = ksl_mat3x3_of_planes(R, R_plane);
  KSL_EACH_OF(n) {
    if (R_stride) R_i = ksl_mat3x3_of_planes(R + i * R_stride, R_plane);
    const ksl_vec3_t v_i = ksl_vec3_of_planes(v + i * v_stride, v_plane);
    ksl_vec3_t vo_i;
    ksl_product_drvinv(&R_i, &v_i, &vo_i);
    ksl_vec3_to_planes(&vo_i, vo + i * vo_stride, vo_plane);
  }
}

/* ksl_product_drinvv of n elements. */
static KSL_INLINED void ksl_product_drinvv_many(ptrdiff_t n, const ksl_mat3x3_t *R,
    ptrdiff_t R_stride, const ksl_vec3_t *v, ptrdiff_t v_stride, ksl_vec3_t *vo,
    ptrdiff_t vo_stride) {
  KSL_EACH_OF(n) {
    ksl_product_drinvv(R + i * R_stride, v + i * v_stride, vo + i * vo_stride);
  }
}

static KSL_INLINED void ksl_product_drinvv_planes(ptrdiff_t n, const double *R, ptrdiff_t R_plane,
    ptrdiff_t R_stride, const double *v, ptrdiff_t v_plane, ptrdiff_t v_stride,
    double *vo, ptrdiff_t vo_plane, ptrdiff_t vo_stride) {
  ksl_mat3x3_t R_i;
  if (n > 0) R_i = ksl_mat3x3_of_planes(R, R_plane);
  KSL_EACH_OF(n) {
    if (R_stride) R_i = ksl_mat3x3_of_planes(R + i * R_stride, R_plane);
    const ksl_vec3_t v_i = ksl_vec3_of_planes(v + i * v_stride, v_plane);
    ksl_vec3_t vo_i;
    ksl_product_drinvv(&R_i, &v_i, &vo_i);
    ksl_vec3_to_planes(&vo_i, vo + i * vo_stride, vo_plane);
  }
}

/* ksl_product_drinvvinv of n elements. */
static KSL_INLINED void ksl_product_drinvvinv_many(ptrdiff_t n, const ksl_mat3x3_t *R,
    ptrdiff_t R_stride, const ksl_vec3_t *v, ptrdiff_t v_stride, ksl_vec3_t *vo,
    ptrdiff_t vo_stride) {
  KSL_EACH_OF(n) {
    ksl_product_drinvvinv(R + i * R_stride, v + i * v_stride, vo + i * vo_stride);
  }
}

static KSL_INLINED void ksl_product_drinvvinv_planes(ptrdiff_t n, const double *R,
    ptrdiff_t R_plane, ptrdiff_t R_stride, const double *v, ptrdiff_t v_plane,
    ptrdiff_t v_stride, double *vo, ptrdiff_t vo_plane, ptrdiff_t vo_stride) {
  ksl_mat3x3_t R_i;
  if (n > 0) R_i = ksl_mat3x3_of_planes(R, R_plane);
  KSL_EACH_OF(n) {
    if (R_stride) R_i = ksl_mat3x3_of_planes(R + i * R_stride, R_plane);
    const ksl_vec3_t v_i = ksl_vec3_of_planes(v + i * v_stride, v_plane);
    ksl_vec3_t vo_i;
    ksl_product_drinvvinv(&R_i, &v_i, &vo_i);
    ksl_vec3_to_planes(&vo_i, vo + i * vo_stride, vo_plane);
  }
}

/* ksl_product_dv of n elements. */
static KSL_INLINED void ksl_product_dv_many(ptrdiff_t n, const ksl_SE3_t *D, ptrdiff_t D_stride,
    const ksl_vec3_t *v, ptrdiff_t v_stride, ksl_vec3_t *vo, ptrdiff_t vo_stride) {
  KSL_EACH_OF(n) {
    ksl_product_dv(D + i * D_stride, v + i * v_stride, vo + i * vo_stride);
  }
}

static KSL_INLINED void ksl_product_dv_planes(ptrdiff_t n, const double *D, ptrdiff_t D_plane,
    ptrdiff_t D_stride, const double *v, ptrdiff_t v_plane, ptrdiff_t v_stride,
    double *vo, ptrdiff_t vo_plane, ptrdiff_t vo_stride) {
  ksl_SE3_t D_i;
  if (n > 0) D_i = ksl_SE3_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3_of_planes(D + i * D_stride, D_plane);
    const ksl_vec3_t v_i = ksl_vec3_of_planes(v + i * v_stride, v_plane);
    ksl_vec3_t vo_i;
    ksl_product_dv(&D_i, &v_i, &vo_i);
    ksl_vec3_to_planes(&vo_i, vo + i * vo_stride, vo_plane);
  }
}

/* ksl_product_dinvv of n elements. */
static KSL_INLINED void ksl_product_dinvv_many(ptrdiff_t n, const ksl_SE3_t *D, ptrdiff_t D_stride,
    const ksl_vec3_t *v, ptrdiff_t v_stride, ksl_vec3_t *vo, ptrdiff_t vo_stride) {
  KSL_EACH_OF(n) {
    ksl_product_dinvv(D + i * D_stride, v + i * v_stride, vo + i * vo_stride);
  }
}

static KSL_INLINED void ksl_product_dinvv_planes(ptrdiff_t n, const double *D, ptrdiff_t D_plane,
    ptrdiff_t D_stride, const double *v, ptrdiff_t v_plane, ptrdiff_t v_stride,
    double *vo, ptrdiff_t vo_plane, ptrdiff_t vo_stride) {
  ksl_SE3_t D_i;
  if (n > 0) D_i = ksl_SE3_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3_of_planes(D + i * D_stride, D_plane);
    const ksl_vec3_t v_i = ksl_vec3_of_planes(v + i * v_stride, v_plane);
    ksl_vec3_t vo_i;
    ksl_product_dinvv(&D_i, &v_i, &vo_i);
    ksl_vec3_to_planes(&vo_i, vo + i * vo_stride, vo_plane);
  }
}

/* ksl_product_drdr of n elements. */
static KSL_INLINED void ksl_product_drdr_many(ptrdiff_t n, const ksl_mat3x3_t *R1,
    ptrdiff_t R1_stride, const ksl_mat3x3_t *R2, ptrdiff_t R2_stride,
    ksl_mat3x3_t *Ro, ptrdiff_t Ro_stride) {
  KSL_EACH_OF(n) {
    ksl_product_drdr(R1 + i * R1_stride, R2 + i * R2_stride, Ro + i * Ro_stride);
  }
}

static KSL_INLINED void ksl_product_drdr_planes(ptrdiff_t n, const double *R1, ptrdiff_t R1_plane,
    ptrdiff_t R1_stride, const double *R2, ptrdiff_t R2_plane,
    ptrdiff_t R2_stride, double *Ro, ptrdiff_t Ro_plane, ptrdiff_t Ro_stride) {
  ksl_mat3x3_t R1_i;
  if (n > 0) R1_i = ksl_mat3x3_of_planes(R1, R1_plane);
  KSL_EACH_OF(n) {
    if (R1_stride) R1_i = ksl_mat3x3_of_planes(R1 + i * R1_stride, R1_plane);
    const ksl_mat3x3_t R2_i = ksl_mat3x3_of_planes(R2 + i * R2_stride, R2_plane);
    ksl_mat3x3_t Ro_i;
    ksl_product_drdr(&R1_i, &R2_i, &Ro_i);
    ksl_mat3x3_to_planes(&Ro_i, Ro + i * Ro_stride, Ro_plane);
  }
}

/* ksl_product_drdrinv of n elements. */
static KSL_INLINED void ksl_product_drdrinv_many(ptrdiff_t n, const ksl_mat3x3_t *R1,
    ptrdiff_t R1_stride, const ksl_mat3x3_t *R2, ptrdiff_t R2_stride,
    ksl_mat3x3_t *Ro, ptrdiff_t Ro_stride) {
  KSL_EACH_OF(n) {
    ksl_product_drdrinv(R1 + i * R1_stride, R2 + i * R2_stride, Ro + i * Ro_stride);
  }
}

static KSL_INLINED void ksl_product_drdrinv_planes(ptrdiff_t n, const double *R1,
    ptrdiff_t R1_plane, ptrdiff_t R1_stride, const double *R2,
    ptrdiff_t R2_plane, ptrdiff_t R2_stride, double *Ro, ptrdiff_t Ro_plane,
    ptrdiff_t Ro_stride) {
  ksl_mat3x3_t R1_i;
  if (n > 0) R1_i = ksl_mat3x3_of_planes(R1, R1_plane);
  KSL_EACH_OF(n) {
    if (R1_stride) R1_i = ksl_mat3x3_of_planes(R1 + i * R1_stride, R1_plane);
    const ksl_mat3x3_t R2_i = ksl_mat3x3_of_planes(R2 + i * R2_stride, R2_plane);
    ksl_mat3x3_t Ro_i;
    ksl_product_drdrinv(&R1_i, &R2_i, &Ro_i);
    ksl_mat3x3_to_planes(&Ro_i, Ro + i * Ro_stride, Ro_plane);
  }
}

/* ksl_product_drinvdr of n elements. */
static KSL_INLINED void ksl_product_drinvdr_many(ptrdiff_t n, const ksl_mat3x3_t *R1,
    ptrdiff_t R1_stride, const ksl_mat3x3_t *R2, ptrdiff_t R2_stride,
    ksl_mat3x3_t *Ro, ptrdiff_t Ro_stride) {
  KSL_EACH_OF(n) {
    ksl_product_drinvdr(R1 + i * R1_stride, R2 + i * R2_stride, Ro + i * Ro_stride);
  }
}

static KSL_INLINED void ksl_product_drinvdr_planes(ptrdiff_t n, const double *R1,
    ptrdiff_t R1_plane, ptrdiff_t R1_stride, const double *R2,
    ptrdiff_t R2_plane, ptrdiff_t R2_stride, double *Ro, ptrdiff_t Ro_plane,
    ptrdiff_t Ro_stride) {
  ksl_mat3x3_t R1_i;
  if (n > 0) R1_i = ksl_mat3x3_of_planes(R1, R1_plane);
  KSL_EACH_OF(n) {
    if (R1_stride) R1_i = ksl_mat3x3_of_planes(R1 + i * R1_stride, R1_plane);
    const ksl_mat3x3_t R2_i = ksl_mat3x3_of_planes(R2 + i * R2_stride, R2_plane);
    ksl_mat3x3_t Ro_i;
    ksl_product_drinvdr(&R1_i, &R2_i, &Ro_i);
    ksl_mat3x3_to_planes(&Ro_i, Ro + i * Ro_stride, Ro_plane);
  }
}

/* ksl_product_dd of n elements. */
static KSL_INLINED void ksl_product_dd_many(ptrdiff_t n, const ksl_SE3_t *D1, ptrdiff_t D1_stride,
    const ksl_SE3_t *D2, ptrdiff_t D2_stride, ksl_SE3_t *Do, ptrdiff_t Do_stride) {
  KSL_EACH_OF(n) {
    ksl_product_dd(D1 + i * D1_stride, D2 + i * D2_stride, Do + i * Do_stride);
  }
}

static KSL_INLINED void ksl_product_dd_planes(ptrdiff_t n, const double *D1, ptrdiff_t D1_plane,
    ptrdiff_t D1_stride, const double *D2, ptrdiff_t D2_plane,
    ptrdiff_t D2_stride, double *Do, ptrdiff_t Do_plane, ptrdiff_t Do_stride) {
  ksl_SE3_t D1_i;
  if (n > 0) D1_i = ksl_SE3_of_planes(D1, D1_plane);
  KSL_EACH_OF(n) {
    if (D1_stride) D1_i = ksl_SE3_of_planes(D1 + i * D1_stride, D1_plane);
    const ksl_SE3_t D2_i = ksl_SE3_of_planes(D2 + i * D2_stride, D2_plane);
    ksl_SE3_t Do_i;
    ksl_product_dd(&D1_i, &D2_i, &Do_i);
    ksl_SE3_to_planes(&Do_i, Do + i * Do_stride, Do_plane);
  }
}

/* ksl_product_ddinv of n elements. */
static KSL_INLINED void ksl_product_ddinv_many(ptrdiff_t n, const ksl_SE3_t *D1,
    ptrdiff_t D1_stride, const ksl_SE3_t *D2, ptrdiff_t D2_stride, ksl_SE3_t *Do,
    ptrdiff_t Do_stride) {
  KSL_EACH_OF(n) {
    ksl_product_ddinv(D1 + i * D1_stride, D2 + i * D2_stride, Do + i * Do_stride);
  }
}

static KSL_INLINED void ksl_product_ddinv_planes(ptrdiff_t n, const double *D1, ptrdiff_t D1_plane,
    ptrdiff_t D1_stride, const double *D2, ptrdiff_t D2_plane,
    ptrdiff_t D2_stride, double *Do, ptrdiff_t Do_plane, ptrdiff_t Do_stride) {
  ksl_SE3_t D1_i;
  if (n > 0) D1_i = ksl_SE3_of_planes(D1, D1_plane);
  KSL_EACH_OF(n) {
    if (D1_stride) D1_i = ksl_SE3_of_planes(D1 + i * D1_stride, D1_plane);
    const ksl_SE3_t D2_i = ksl_SE3_of_planes(D2 + i * D2_stride, D2_plane);
    ksl_SE3_t Do_i;
    ksl_product_ddinv(&D1_i, &D2_i, &Do_i);
    ksl_SE3_to_planes(&Do_i, Do + i * Do_stride, Do_plane);
  }
}

/* ksl_product_dinvd of n elements. */
static KSL_INLINED void ksl_product_dinvd_many(ptrdiff_t n, const ksl_SE3_t *D1,
    ptrdiff_t D1_stride, const ksl_SE3_t *D2, ptrdiff_t D2_stride, ksl_SE3_t *Do,
    ptrdiff_t Do_stride) {
  KSL_EACH_OF(n) {
    ksl_product_dinvd(D1 + i * D1_stride, D2 + i * D2_stride, Do + i * Do_stride);
  }
}

static KSL_INLINED void ksl_product_dinvd_planes(ptrdiff_t n, const double *D1, ptrdiff_t D1_plane,
    ptrdiff_t D1_stride, const double *D2, ptrdiff_t D2_plane,
    ptrdiff_t D2_stride, double *Do, ptrdiff_t Do_plane, ptrdiff_t Do_stride) {
  ksl_SE3_t D1_i;
  if (n > 0) D1_i = ksl_SE3_of_planes(D1, D1_plane);
  KSL_EACH_OF(n) {
    if (D1_stride) D1_i = ksl_SE3_of_planes(D1 + i * D1_stride, D1_plane);
    const ksl_SE3_t D2_i = ksl_SE3_of_planes(D2 + i * D2_stride, D2_plane);
    ksl_SE3_t Do_i;
    ksl_product_dinvd(&D1_i, &D2_i, &Do_i);
    ksl_SE3_to_planes(&Do_i, Do + i * Do_stride, Do_plane);
  }
}

/* ksl_product_ddr of n elements. */
static KSL_INLINED void ksl_product_ddr_many(ptrdiff_t n, const ksl_SE3_t *D, ptrdiff_t D_stride,
    const ksl_mat3x3_t *R, ptrdiff_t R_stride, ksl_SE3_t *Do,
    ptrdiff_t Do_stride) {
  KSL_EACH_OF(n) {
    ksl_product_ddr(D + i * D_stride, R + i * R_stride, Do + i * Do_stride);
  }
}

static KSL_INLINED void ksl_product_ddr_planes(ptrdiff_t n, const double *D, ptrdiff_t D_plane,
    ptrdiff_t D_stride, const double *R, ptrdiff_t R_plane, ptrdiff_t R_stride,
    double *Do, ptrdiff_t Do_plane, ptrdiff_t Do_stride) {
  ksl_SE3_t D_i;
  if (n > 0) D_i = ksl_SE3_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3_of_planes(D + i * D_stride, D_plane);
    const ksl_mat3x3_t R_i = ksl_mat3x3_of_planes(R + i * R_stride, R_plane);
    ksl_SE3_t Do_i;
    ksl_product_ddr(&D_i, &R_i, &Do_i);
    ksl_SE3_to_planes(&Do_i, Do + i * Do_stride, Do_plane);
  }
}

/* ksl_product_ddrinv of n elements. */
static KSL_INLINED void ksl_product_ddrinv_many(ptrdiff_t n, const ksl_SE3_t *D, ptrdiff_t D_stride,
    const ksl_mat3x3_t *R, ptrdiff_t R_stride, ksl_SE3_t *Do,
    ptrdiff_t Do_stride) {
  KSL_EACH_OF(n) {
    ksl_product_ddrinv(D + i * D_stride, R + i * R_stride, Do + i * Do_stride);
  }
}

static KSL_INLINED void ksl_product_ddrinv_planes(ptrdiff_t n, const double *D, ptrdiff_t D_plane,
    ptrdiff_t D_stride, const double *R, ptrdiff_t R_plane, ptrdiff_t R_stride,
    double *Do, ptrdiff_t Do_plane, ptrdiff_t Do_stride) {
  ksl_SE3_t D_i;
  if (n > 0) D_i = ksl_SE3_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3_of_planes(D + i * D_stride, D_plane);
    const ksl_mat3x3_t R_i = ksl_mat3x3_of_planes(R + i * R_stride, R_plane);
    ksl_SE3_t Do_i;
    ksl_product_ddrinv(&D_i, &R_i, &Do_i);
    ksl_SE3_to_planes(&Do_i, Do + i * Do_stride, Do_plane);
  }
}

/* ksl_product_ddt of n elements. */
static KSL_INLINED void ksl_product_ddt_many(ptrdiff_t n, const ksl_SE3_t *D, ptrdiff_t D_stride,
    const ksl_vec3_t *t, ptrdiff_t t_stride, ksl_SE3_t *Do, ptrdiff_t Do_stride) {
  KSL_EACH_OF(n) {
    ksl_product_ddt(D + i * D_stride, t + i * t_stride, Do + i * Do_stride);
  }
}

static KSL_INLINED void ksl_product_ddt_planes(ptrdiff_t n, const double *D, ptrdiff_t D_plane,
    ptrdiff_t D_stride, const double *t, ptrdiff_t t_plane, ptrdiff_t t_stride,
    double *Do, ptrdiff_t Do_plane, ptrdiff_t Do_stride) {
  ksl_SE3_t D_i;
  if (n > 0) D_i = ksl_SE3_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3_of_planes(D + i * D_stride, D_plane);
    const ksl_vec3_t t_i = ksl_vec3_of_planes(t + i * t_stride, t_plane);
    ksl_SE3_t Do_i;
    ksl_product_ddt(&D_i, &t_i, &Do_i);
    ksl_SE3_to_planes(&Do_i, Do + i * Do_stride, Do_plane);
  }
}

/* ksl_product_ddtinv of n elements. */
static KSL_INLINED void ksl_product_ddtinv_many(ptrdiff_t n, const ksl_SE3_t *D, ptrdiff_t D_stride,
    const ksl_vec3_t *t, ptrdiff_t t_stride, ksl_SE3_t *Do, ptrdiff_t Do_stride) {
  KSL_EACH_OF(n) {
    ksl_product_ddtinv(D + i * D_stride, t + i * t_stride, Do + i * Do_stride);
  }
}

static KSL_INLINED void ksl_product_ddtinv_planes(ptrdiff_t n, const double *D, ptrdiff_t D_plane,
    ptrdiff_t D_stride, const double *t, ptrdiff_t t_plane, ptrdiff_t t_stride,
    double *Do, ptrdiff_t Do_plane, ptrdiff_t Do_stride) {
  ksl_SE3_t D_i;
  if (n > 0) D_i = ksl_SE3_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3_of_planes(D + i * D_stride, D_plane);
    const ksl_vec3_t t_i = ksl_vec3_of_planes(t + i * t_stride, t_plane);
    ksl_SE3_t Do_i;
    ksl_product_ddtinv(&D_i, &t_i, &Do_i);
    ksl_SE3_to_planes(&Do_i, Do + i * Do_stride, Do_plane);
  }
}

/* ksl_product_dinvdt of n elements. */
static KSL_INLINED void ksl_product_dinvdt_many(ptrdiff_t n, const ksl_SE3_t *D, ptrdiff_t D_stride,
    const ksl_vec3_t *t, ptrdiff_t t_stride, ksl_SE3_t *Do, ptrdiff_t Do_stride) {
  KSL_EACH_OF(n) {
    ksl_product_dinvdt(D + i * D_stride, t + i * t_stride, Do + i * Do_stride);
  }
}

static KSL_INLINED void ksl_product_dinvdt_planes(ptrdiff_t n, const double *D, ptrdiff_t D_plane,
    ptrdiff_t D_stride, const double *t, ptrdiff_t t_plane, ptrdiff_t t_stride,
    double *Do, ptrdiff_t Do_plane, ptrdiff_t Do_stride) {
  ksl_SE3_t D_i;
  if (n > 0) D_i = ksl_SE3_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3_of_planes(D + i * D_stride, D_plane);
    const ksl_vec3_t t_i = ksl_vec3_of_planes(t + i * t_stride, t_plane);
    ksl_SE3_t Do_i;
    ksl_product_dinvdt(&D_i, &t_i, &Do_i);
    ksl_SE3_to_planes(&Do_i, Do + i * Do_stride, Do_plane);
  }
}

/* ksl_product_drvtx of n elements. */
static KSL_INLINED void ksl_product_drvtx_many(ptrdiff_t n, const ksl_mat3x3_t *R,
    ptrdiff_t R_stride, const double *k, ptrdiff_t k_stride, ksl_vec3_t *vo,
    ptrdiff_t vo_stride) {
  KSL_EACH_OF(n) {
    ksl_product_drvtx(R + i * R_stride, k[i * k_stride], vo + i * vo_stride);
  }
}

static KSL_INLINED void ksl_product_drvtx_planes(ptrdiff_t n, const double *R, ptrdiff_t R_plane,
    ptrdiff_t R_stride, const double *k, ptrdiff_t k_stride, double *vo,
    ptrdiff_t vo_plane, ptrdiff_t vo_stride) {
  ksl_mat3x3_t R_i;
  if (n > 0) R_i = ksl_mat3x3_of_planes(R, R_plane);
  KSL_EACH_OF(n) {
    if (R_stride) R_i = ksl_mat3x3_of_planes(R + i * R_stride, R_plane);
    ksl_vec3_t vo_i;
    ksl_product_drvtx(&R_i, k[i * k_stride], &vo_i);
    ksl_vec3_to_planes(&vo_i, vo + i * vo_stride, vo_plane);
  }
}

/* ksl_product_drdrx of n elements. */
static KSL_INLINED void ksl_product_drdrx_many(ptrdiff_t n, const ksl_mat3x3_t *R,
    ptrdiff_t R_stride, const double *dc, ptrdiff_t dc_stride, ksl_mat3x3_t *Ro,
    ptrdiff_t Ro_stride) {
  KSL_EACH_OF(n) {
    ksl_product_drdrx(R + i * R_stride, dc + 2 * i * dc_stride, Ro + i * Ro_stride);
  }
}

static KSL_INLINED void ksl_product_drdrx_planes(ptrdiff_t n, const double *R, ptrdiff_t R_plane,
    ptrdiff_t R_stride, const double *dc, ptrdiff_t dc_plane,
    ptrdiff_t dc_stride, double *Ro, ptrdiff_t Ro_plane, ptrdiff_t Ro_stride) {
  ksl_mat3x3_t R_i;
  if (n > 0) R_i = ksl_mat3x3_of_planes(R, R_plane);
  KSL_EACH_OF(n) {
    if (R_stride) R_i = ksl_mat3x3_of_planes(R + i * R_stride, R_plane);
    const double dc_i[2] = {dc[0 + i * dc_stride], dc[dc_plane + i * dc_stride]};
    ksl_mat3x3_t Ro_i;
    ksl_product_drdrx(&R_i, dc_i, &Ro_i);
    ksl_mat3x3_to_planes(&Ro_i, Ro + i * Ro_stride, Ro_plane);
  }
}

/* ksl_product_ddrx of n elements. */
static KSL_INLINED void ksl_product_ddrx_many(ptrdiff_t n, const ksl_SE3_t *D, ptrdiff_t D_stride,
    const double *dc, ptrdiff_t dc_stride, ksl_SE3_t *Do, ptrdiff_t Do_stride) {
  KSL_EACH_OF(n) {
    ksl_product_ddrx(D + i * D_stride, dc + 2 * i * dc_stride, Do + i * Do_stride);
  }
}

static KSL_INLINED void ksl_product_ddrx_planes(ptrdiff_t n, const double *D, ptrdiff_t D_plane,
    ptrdiff_t D_stride, const double *dc, ptrdiff_t dc_plane,
    ptrdiff_t dc_stride, double *Do, ptrdiff_t Do_plane, ptrdiff_t Do_stride) {
  ksl_SE3_t D_i;
  if (n > 0) D_i = ksl_SE3_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3_of_planes(D + i * D_stride, D_plane);
    const double dc_i[2] = {dc[0 + i * dc_stride], dc[dc_plane + i * dc_stride]};
    ksl_SE3_t Do_i;
    ksl_product_ddrx(&D_i, dc_i, &Do_i);
    ksl_SE3_to_planes(&Do_i, Do + i * Do_stride, Do_plane);
  }
}

/* ksl_product_ddtx of n elements. */
static KSL_INLINED void ksl_product_ddtx_many(ptrdiff_t n, const ksl_SE3_t *D, ptrdiff_t D_stride,
    const double *k, ptrdiff_t k_stride, ksl_SE3_t *Do, ptrdiff_t Do_stride) {
  KSL_EACH_OF(n) {
    ksl_product_ddtx(D + i * D_stride, k[i * k_stride], Do + i * Do_stride);
  }
}

static KSL_INLINED void ksl_product_ddtx_planes(ptrdiff_t n, const double *D, ptrdiff_t D_plane,
    ptrdiff_t D_stride, const double *k, ptrdiff_t k_stride, double *Do,
    ptrdiff_t Do_plane, ptrdiff_t Do_stride) {
  ksl_SE3_t D_i;
  if (n > 0) D_i = ksl_SE3_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3_of_planes(D + i * D_stride, D_plane);
    ksl_SE3_t Do_i;
    ksl_product_ddtx(&D_i, k[i * k_stride], &Do_i);
    ksl_SE3_to_planes(&Do_i, Do + i * Do_stride, Do_plane);
  }
}

/* ksl_product_drvtxinv of n elements. */
static KSL_INLINED void ksl_product_drvtxinv_many(ptrdiff_t n, const ksl_mat3x3_t *R,
    ptrdiff_t R_stride, const double *k, ptrdiff_t k_stride, ksl_vec3_t *vo,
    ptrdiff_t vo_stride) {
  KSL_EACH_OF(n) {
    ksl_product_drvtxinv(R + i * R_stride, k[i * k_stride], vo + i * vo_stride);
  }
}

static KSL_INLINED void ksl_product_drvtxinv_planes(ptrdiff_t n, const double *R, ptrdiff_t R_plane,
    ptrdiff_t R_stride, const double *k, ptrdiff_t k_stride, double *vo,
    ptrdiff_t vo_plane, ptrdiff_t vo_stride) {
  ksl_mat3x3_t R_i;
  if (n > 0) R_i = ksl_mat3x3_of_planes(R, R_plane);
  KSL_EACH_OF(n) {
    if (R_stride) R_i = ksl_mat3x3_of_planes(R + i * R_stride, R_plane);
    ksl_vec3_t vo_i;
    ksl_product_drvtxinv(&R_i, k[i * k_stride], &vo_i);
    ksl_vec3_to_planes(&vo_i, vo + i * vo_stride, vo_plane);
  }
}

/* ksl_product_drdrxinv of n elements. */
static KSL_INLINED void ksl_product_drdrxinv_many(ptrdiff_t n, const ksl_mat3x3_t *R,
    ptrdiff_t R_stride, const double *dc, ptrdiff_t dc_stride, ksl_mat3x3_t *Ro,
    ptrdiff_t Ro_stride) {
  KSL_EACH_OF(n) {
    ksl_product_drdrxinv(R + i * R_stride, dc + 2 * i * dc_stride, Ro + i * Ro_stride);
  }
}

static KSL_INLINED void ksl_product_drdrxinv_planes(ptrdiff_t n, const double *R, ptrdiff_t R_plane,
    ptrdiff_t R_stride, const double *dc, ptrdiff_t dc_plane,
    ptrdiff_t dc_stride, double *Ro, ptrdiff_t Ro_plane, ptrdiff_t Ro_stride) {
  ksl_mat3x3_t R_i;
  if (n > 0) R_i = ksl_mat3x3_of_planes(R, R_plane);
  KSL_EACH_OF(n) {
    if (R_stride) R_i = ksl_mat3x3_of_planes(R + i * R_stride, R_plane);
    const double dc_i[2] = {dc[0 + i * dc_stride], dc[dc_plane + i * dc_stride]};
    ksl_mat3x3_t Ro_i;
    ksl_product_drdrxinv(&R_i, dc_i, &Ro_i);
    ksl_mat3x3_to_planes(&Ro_i, Ro + i * Ro_stride, Ro_plane);
  }
}

/* ksl_product_ddrxinv of n elements. */
static KSL_INLINED void ksl_product_ddrxinv_many(ptrdiff_t n, const ksl_SE3_t *D,
    ptrdiff_t D_stride, const double *dc, ptrdiff_t dc_stride, ksl_SE3_t *Do,
    ptrdiff_t Do_stride) {
  KSL_EACH_OF(n) {
    ksl_product_ddrxinv(D + i * D_stride, dc + 2 * i * dc_stride, Do + i * Do_stride);
  }
}

static KSL_INLINED void ksl_product_ddrxinv_planes(ptrdiff_t n, const double *D, ptrdiff_t D_plane,
    ptrdiff_t D_stride, const double *dc, ptrdiff_t dc_plane,
    ptrdiff_t dc_stride, double *Do, ptrdiff_t Do_plane, ptrdiff_t Do_stride) {
  ksl_SE3_t D_i;
  if (n > 0) D_i = ksl_SE3_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3_of_planes(D + i * D_stride, D_plane);
    const double dc_i[2] = {dc[0 + i * dc_stride], dc[dc_plane + i * dc_stride]};
    ksl_SE3_t Do_i;
    ksl_product_ddrxinv(&D_i, dc_i, &Do_i);
    ksl_SE3_to_planes(&Do_i, Do + i * Do_stride, Do_plane);
  }
}

/* ksl_product_ddtxinv of n elements. */
static KSL_INLINED void ksl_product_ddtxinv_many(ptrdiff_t n, const ksl_SE3_t *D,
    ptrdiff_t D_stride, const double *k, ptrdiff_t k_stride, ksl_SE3_t *Do,
    ptrdiff_t Do_stride) {
  KSL_EACH_OF(n) {
    ksl_product_ddtxinv(D + i * D_stride, k[i * k_stride], Do + i * Do_stride);
  }
}

static KSL_INLINED void ksl_product_ddtxinv_planes(ptrdiff_t n, const double *D, ptrdiff_t D_plane,
    ptrdiff_t D_stride, const double *k, ptrdiff_t k_stride, double *Do,
    ptrdiff_t Do_plane, ptrdiff_t Do_stride) {
  ksl_SE3_t D_i;
  if (n > 0) D_i = ksl_SE3_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3_of_planes(D + i * D_stride, D_plane);
    ksl_SE3_t Do_i;
    ksl_product_ddtxinv(&D_i, k[i * k_stride], &Do_i);
    ksl_SE3_to_planes(&Do_i, Do + i * Do_stride, Do_plane);
  }
}

/* ksl_product_drvty of n elements. */
static KSL_INLINED void ksl_product_drvty_many(ptrdiff_t n, const ksl_mat3x3_t *R,
    ptrdiff_t R_stride, const double *k, ptrdiff_t k_stride, ksl_vec3_t *vo,
    ptrdiff_t vo_stride) {
  KSL_EACH_OF(n) {
    ksl_product_drvty(R + i * R_stride, k[i * k_stride], vo + i * vo_stride);
  }
}

static KSL_INLINED void ksl_product_drvty_planes(ptrdiff_t n, const double *R, ptrdiff_t R_plane,
    ptrdiff_t R_stride, const double *k, ptrdiff_t k_stride, double *vo,
    ptrdiff_t vo_plane, ptrdiff_t vo_stride) {
  ksl_mat3x3_t R_i;
  if (n > 0) R_i = ksl_mat3x3_of_planes(R, R_plane);
  KSL_EACH_OF(n) {
    if (R_stride) R_i = ksl_mat3x3_of_planes(R + i * R_stride, R_plane);
    ksl_vec3_t vo_i;
    ksl_product_drvty(&R_i, k[i * k_stride], &vo_i);
    ksl_vec3_to_planes(&vo_i, vo + i * vo_stride, vo_plane);
  }
}

/* ksl_product_drdry of n elements. */
static KSL_INLINED void ksl_product_drdry_many(ptrdiff_t n, const ksl_mat3x3_t *R,
    ptrdiff_t R_stride, const double *dc, ptrdiff_t dc_stride, ksl_mat3x3_t *Ro,
    ptrdiff_t Ro_stride) {
  KSL_EACH_OF(n) {
    ksl_product_drdry(R + i * R_stride, dc + 2 * i * dc_stride, Ro + i * Ro_stride);
  }
}

static KSL_INLINED void ksl_product_drdry_planes(ptrdiff_t n, const double *R, ptrdiff_t R_plane,
    ptrdiff_t R_stride, const double *dc, ptrdiff_t dc_plane,
    ptrdiff_t dc_stride, double *Ro, ptrdiff_t Ro_plane, ptrdiff_t Ro_stride) {
  ksl_mat3x3_t R_i;
  if (n > 0) R_i = ksl_mat3x3_of_planes(R, R_plane);
  KSL_EACH_OF(n) {
    if (R_stride) R_i = ksl_mat3x3_of_planes(R + i * R_stride, R_plane);
    const double dc_i[2] = {dc[0 + i * dc_stride], dc[dc_plane + i * dc_stride]};
    ksl_mat3x3_t Ro_i;
    ksl_product_drdry(&R_i, dc_i, &Ro_i);
    ksl_mat3x3_to_planes(&Ro_i, Ro + i * Ro_stride, Ro_plane);
  }
}

/* ksl_product_ddry of n elements. */
static KSL_INLINED void ksl_product_ddry_many(ptrdiff_t n, const ksl_SE3_t *D, ptrdiff_t D_stride,
    const double *dc, ptrdiff_t dc_stride, ksl_SE3_t *Do, ptrdiff_t Do_stride) {
  KSL_EACH_OF(n) {
    ksl_product_ddry(D + i * D_stride, dc + 2 * i * dc_stride, Do + i * Do_stride);
  }
}

static KSL_INLINED void ksl_product_ddry_planes(ptrdiff_t n, const double *D, ptrdiff_t D_plane,
    ptrdiff_t D_stride, const double *dc, ptrdiff_t dc_plane,
    ptrdiff_t dc_stride, double *Do, ptrdiff_t Do_plane, ptrdiff_t Do_stride) {
  ksl_SE3_t D_i;
  if (n > 0) D_i = ksl_SE3_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3_of_planes(D + i * D_stride, D_plane);
    const double dc_i[2] = {dc[0 + i * dc_stride], dc[dc_plane + i * dc_stride]};
    ksl_SE3_t Do_i;
    ksl_product_ddry(&D_i, dc_i, &Do_i);
    ksl_SE3_to_planes(&Do_i, Do + i * Do_stride, Do_plane);
  }
}

/* ksl_product_ddty of n elements. */
static KSL_INLINED void ksl_product_ddty_many(ptrdiff_t n, const ksl_SE3_t *D, ptrdiff_t D_stride,
    const double *k, ptrdiff_t k_stride, ksl_SE3_t *Do, ptrdiff_t Do_stride) {
  KSL_EACH_OF(n) {
    ksl_product_ddty(D + i * D_stride, k[i * k_stride], Do + i * Do_stride);
  }
}

static KSL_INLINED void ksl_product_ddty_planes(ptrdiff_t n, const double *D, ptrdiff_t D_plane,
    ptrdiff_t D_stride, const double *k, ptrdiff_t k_stride, double *Do,
    ptrdiff_t Do_plane, ptrdiff_t Do_stride) {
  ksl_SE3_t D_i;
  if (n > 0) D_i = ksl_SE3_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3_of_planes(D + i * D_stride, D_plane);
    ksl_SE3_t Do_i;
    ksl_product_ddty(&D_i, k[i * k_stride], &Do_i);
    ksl_SE3_to_planes(&Do_i, Do + i * Do_stride, Do_plane);
  }
}

/* ksl_product_drvtyinv of n elements. */
static KSL_INLINED void ksl_product_drvtyinv_many(ptrdiff_t n, const ksl_mat3x3_t *R,
    ptrdiff_t R_stride, const double *k, ptrdiff_t k_stride, ksl_vec3_t *vo,
    ptrdiff_t vo_stride) {
  KSL_EACH_OF(n) {
    ksl_product_drvtyinv(R + i * R_stride, k[i * k_stride], vo + i * vo_stride);
  }
}

static KSL_INLINED void ksl_product_drvtyinv_planes(ptrdiff_t n, const double *R, ptrdiff_t R_plane,
    ptrdiff_t R_stride, const double *k, ptrdiff_t k_stride, double *vo,
    ptrdiff_t vo_plane, ptrdiff_t vo_stride) {
  ksl_mat3x3_t R_i;
  if (n > 0) R_i = ksl_mat3x3_of_planes(R, R_plane);
  KSL_EACH_OF(n) {
    if (R_stride) R_i = ksl_mat3x3_of_planes(R + i * R_stride, R_plane);
    ksl_vec3_t vo_i;
    ksl_product_drvtyinv(&R_i, k[i * k_stride], &vo_i);
    ksl_vec3_to_planes(&vo_i, vo + i * vo_stride, vo_plane);
  }
}

/* ksl_product_drdryinv of n elements. */
static KSL_INLINED void ksl_product_drdryinv_many(ptrdiff_t n, const ksl_mat3x3_t *R,
    ptrdiff_t R_stride, const double *dc, ptrdiff_t dc_stride, ksl_mat3x3_t *Ro,
    ptrdiff_t Ro_stride) {
  KSL_EACH_OF(n) {
    ksl_product_drdryinv(R + i * R_stride, dc + 2 * i * dc_stride, Ro + i * Ro_stride);
  }
}

static KSL_INLINED void ksl_product_drdryinv_planes(ptrdiff_t n, const double *R, ptrdiff_t R_plane,
    ptrdiff_t R_stride, const double *dc, ptrdiff_t dc_plane,
    ptrdiff_t dc_stride, double *Ro, ptrdiff_t Ro_plane, ptrdiff_t Ro_stride) {
  ksl_mat3x3_t R_i;
  if (n > 0) R_i = ksl_mat3x3_of_planes(R, R_plane);
  KSL_EACH_OF(n) {
    if (R_stride) R_i = ksl_mat3x3_of_planes(R + i * R_stride, R_plane);
    const double dc_i[2] = {dc[0 + i * dc_stride], dc[dc_plane + i * dc_stride]};
    ksl_mat3x3_t Ro_i;
    ksl_product_drdryinv(&R_i, dc_i, &Ro_i);
    ksl_mat3x3_to_planes(&Ro_i, Ro + i * Ro_stride, Ro_plane);
  }
}

/* ksl_product_ddryinv of n elements. */
static KSL_INLINED void ksl_product_ddryinv_many(ptrdiff_t n, const ksl_SE3_t *D,
    ptrdiff_t D_stride, const double *dc, ptrdiff_t dc_stride, ksl_SE3_t *Do,
    ptrdiff_t Do_stride) {
  KSL_EACH_OF(n) {
    ksl_product_ddryinv(D + i * D_stride, dc + 2 * i * dc_stride, Do + i * Do_stride);
  }
}

static KSL_INLINED void ksl_product_ddryinv_planes(ptrdiff_t n, const double *D, ptrdiff_t D_plane,
    ptrdiff_t D_stride, const double *dc, ptrdiff_t dc_plane,
    ptrdiff_t dc_stride, double *Do, ptrdiff_t Do_plane, ptrdiff_t Do_stride) {
  ksl_SE3_t D_i;
  if (n > 0) D_i = ksl_SE3_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3_of_planes(D + i * D_stride, D_plane);
    const double dc_i[2] = {dc[0 + i * dc_stride], dc[dc_plane + i * dc_stride]};
    ksl_SE3_t Do_i;
    ksl_product_ddryinv(&D_i, dc_i, &Do_i);
    ksl_SE3_to_planes(&Do_i, Do + i * Do_stride, Do_plane);
  }
}

/* ksl_product_ddtyinv of n elements. */
static KSL_INLINED void ksl_product_ddtyinv_many(ptrdiff_t n, const ksl_SE3_t *D,
    ptrdiff_t D_stride, const double *k, ptrdiff_t k_stride, ksl_SE3_t *Do,
    ptrdiff_t Do_stride) {
  KSL_EACH_OF(n) {
    ksl_product_ddtyinv(D + i * D_stride, k[i * k_stride], Do + i * Do_stride);
  }
}

static KSL_INLINED void ksl_product_ddtyinv_planes(ptrdiff_t n, const double *D, ptrdiff_t D_plane,
    ptrdiff_t D_stride, const double *k, ptrdiff_t k_stride, double *Do,
    ptrdiff_t Do_plane, ptrdiff_t Do_stride) {
  ksl_SE3_t D_i;
  if (n > 0) D_i = ksl_SE3_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3_of_planes(D + i * D_stride, D_plane);
    ksl_SE3_t Do_i;
    ksl_product_ddtyinv(&D_i, k[i * k_stride], &Do_i);
    ksl_SE3_to_planes(&Do_i, Do + i * Do_stride, Do_plane);
  }
}

/* ksl_product_drvtz of n elements. */
static KSL_INLINED void ksl_product_drvtz_many(ptrdiff_t n, const ksl_mat3x3_t *R,
    ptrdiff_t R_stride, const double *k, ptrdiff_t k_stride, ksl_vec3_t *vo,
    ptrdiff_t vo_stride) {
  KSL_EACH_OF(n) {
    ksl_product_drvtz(R + i * R_stride, k[i * k_stride], vo + i * vo_stride);
  }
}

static KSL_INLINED void ksl_product_drvtz_planes(ptrdiff_t n, const double *R, ptrdiff_t R_plane,
    ptrdiff_t R_stride, const double *k, ptrdiff_t k_stride, double *vo,
    ptrdiff_t vo_plane, ptrdiff_t vo_stride) {
  ksl_mat3x3_t R_i;
  if (n > 0) R_i = ksl_mat3x3_of_planes(R, R_plane);
  KSL_EACH_OF(n) {
    if (R_stride) R_i = ksl_mat3x3_of_planes(R + i * R_stride, R_plane);
    ksl_vec3_t vo_i;
    ksl_product_drvtz(&R_i, k[i * k_stride], &vo_i);
    ksl_vec3_to_planes(&vo_i, vo + i * vo_stride, vo_plane);
  }
}

/* ksl_product_drdrz of n elements. */
static KSL_INLINED void ksl_product_drdrz_many(ptrdiff_t n, const ksl_mat3x3_t *R,
    ptrdiff_t R_stride, const double *dc, ptrdiff_t dc_stride, ksl_mat3x3_t *Ro,
    ptrdiff_t Ro_stride) {
  KSL_EACH_OF(n) {
    ksl_product_drdrz(R + i * R_stride, dc + 2 * i * dc_stride, Ro + i * Ro_stride);
  }
}

static KSL_INLINED void ksl_product_drdrz_planes(ptrdiff_t n, const double *R, ptrdiff_t R_plane,
    ptrdiff_t R_stride, const double *dc, ptrdiff_t dc_plane,
    ptrdiff_t dc_stride, double *Ro, ptrdiff_t Ro_plane, ptrdiff_t Ro_stride) {
  ksl_mat3x3_t R_i;
  if (n > 0) R_i = ksl_mat3x3_of_planes(R, R_plane);
  KSL_EACH_OF(n) {
    if (R_stride) R_i = ksl_mat3x3_of_planes(R + i * R_stride, R_plane);
    const double dc_i[2] = {dc[0 + i * dc_stride], dc[dc_plane + i * dc_stride]};
    ksl_mat3x3_t Ro_i;
    ksl_product_drdrz(&R_i, dc_i, &Ro_i);
    ksl_mat3x3_to_planes(&Ro_i, Ro + i * Ro_stride, Ro_plane);
  }
}

/* ksl_product_ddrz of n elements. */
static KSL_INLINED void ksl_product_ddrz_many(ptrdiff_t n, const ksl_SE3_t *D, ptrdiff_t D_stride,
    const double *dc, ptrdiff_t dc_stride, ksl_SE3_t *Do, ptrdiff_t Do_stride) {
  KSL_EACH_OF(n) {
    ksl_product_ddrz(D + i * D_stride, dc + 2 * i * dc_stride, Do + i * Do_stride);
  }
}

static KSL_INLINED void ksl_product_ddrz_planes(ptrdiff_t n, const double *D, ptrdiff_t D_plane,
    ptrdiff_t D_stride, const double *dc, ptrdiff_t dc_plane,
    ptrdiff_t dc_stride, double *Do, ptrdiff_t Do_plane, ptrdiff_t Do_stride) {
  ksl_SE3_t D_i;
  if (n > 0) D_i = ksl_SE3_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3_of_planes(D + i * D_stride, D_plane);
    const double dc_i[2] = {dc[0 + i * dc_stride], dc[dc_plane + i * dc_stride]};
    ksl_SE3_t Do_i;
    ksl_product_ddrz(&D_i, dc_i, &Do_i);
    ksl_SE3_to_planes(&Do_i, Do + i * Do_stride, Do_plane);
  }
}

/* ksl_product_ddtz of n elements. */
static KSL_INLINED void ksl_product_ddtz_many(ptrdiff_t n, const ksl_SE3_t *D, ptrdiff_t D_stride,
    const double *k, ptrdiff_t k_stride, ksl_SE3_t *Do, ptrdiff_t Do_stride) {
  KSL_EACH_OF(n) {
    ksl_product_ddtz(D + i * D_stride, k[i * k_stride], Do + i * Do_stride);
  }
}

static KSL_INLINED void ksl_product_ddtz_planes(ptrdiff_t n, const double *D, ptrdiff_t D_plane,
    ptrdiff_t D_stride, const double *k, ptrdiff_t k_stride, double *Do,
    ptrdiff_t Do_plane, ptrdiff_t Do_stride) {
  ksl_SE3_t D_i;
  if (n > 0) D_i = ksl_SE3_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3_of_planes(D + i * D_stride, D_plane);
    ksl_SE3_t Do_i;
    ksl_product_ddtz(&D_i, k[i * k_stride], &Do_i);
    ksl_SE3_to_planes(&Do_i, Do + i * Do_stride, Do_plane);
  }
}

/* ksl_product_drvtzinv of n elements. */
static KSL_INLINED void ksl_product_drvtzinv_many(ptrdiff_t n, const ksl_mat3x3_t *R,
    ptrdiff_t R_stride, const double *k, ptrdiff_t k_stride, ksl_vec3_t *vo,
    ptrdiff_t vo_stride) {
  KSL_EACH_OF(n) {
    ksl_product_drvtzinv(R + i * R_stride, k[i * k_stride], vo + i * vo_stride);
  }
}

static KSL_INLINED void ksl_product_drvtzinv_planes(ptrdiff_t n, const double *R, ptrdiff_t R_plane,
    ptrdiff_t R_stride, const double *k, ptrdiff_t k_stride, double *vo,
    ptrdiff_t vo_plane, ptrdiff_t vo_stride) {
  ksl_mat3x3_t R_i;
  if (n > 0) R_i = ksl_mat3x3_of_planes(R, R_plane);
  KSL_EACH_OF(n) {
    if (R_stride) R_i = ksl_mat3x3_of_planes(R + i * R_stride, R_plane);
    ksl_vec3_t vo_i;
    ksl_product_drvtzinv(&R_i, k[i * k_stride], &vo_i);
    ksl_vec3_to_planes(&vo_i, vo + i * vo_stride, vo_plane);
  }
}

/* ksl_product_drdrzinv of n elements. */
static KSL_INLINED void ksl_product_drdrzinv_many(ptrdiff_t n, const ksl_mat3x3_t *R,
    ptrdiff_t R_stride, const double *dc, ptrdiff_t dc_stride, ksl_mat3x3_t *Ro,
    ptrdiff_t Ro_stride) {
  KSL_EACH_OF(n) {
    ksl_product_drdrzinv(R + i * R_stride, dc + 2 * i * dc_stride, Ro + i * Ro_stride);
  }
}

static KSL_INLINED void ksl_product_drdrzinv_planes(ptrdiff_t n, const double *R, ptrdiff_t R_plane,
    ptrdiff_t R_stride, const double *dc, ptrdiff_t dc_plane,
    ptrdiff_t dc_stride, double *Ro, ptrdiff_t Ro_plane, ptrdiff_t Ro_stride) {
  ksl_mat3x3_t R_i;
  if (n > 0) R_i = ksl_mat3x3_of_planes(R, R_plane);
  KSL_EACH_OF(n) {
    if (R_stride) R_i = ksl_mat3x3_of_planes(R + i * R_stride, R_plane);
    const double dc_i[2] = {dc[0 + i * dc_stride], dc[dc_plane + i * dc_stride]};
    ksl_mat3x3_t Ro_i;
    ksl_product_drdrzinv(&R_i, dc_i, &Ro_i);
    ksl_mat3x3_to_planes(&Ro_i, Ro + i * Ro_stride, Ro_plane);
  }
}

/* ksl_product_ddrzinv of n elements. */
static KSL_INLINED void ksl_product_ddrzinv_many(ptrdiff_t n, const ksl_SE3_t *D,
    ptrdiff_t D_stride, const double *dc, ptrdiff_t dc_stride, ksl_SE3_t *Do,
    ptrdiff_t Do_stride) {
  KSL_EACH_OF(n) {
    ksl_product_ddrzinv(D + i * D_stride, dc + 2 * i * dc_stride, Do + i * Do_stride);
  }
}

static KSL_INLINED void ksl_product_ddrzinv_planes(ptrdiff_t n, const double *D, ptrdiff_t D_plane,
    ptrdiff_t D_stride, const double *dc, ptrdiff_t dc_plane,
    ptrdiff_t dc_stride, double *Do, ptrdiff_t Do_plane, ptrdiff_t Do_stride) {
  ksl_SE3_t D_i;
  if (n > 0) D_i = ksl_SE3_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3_of_planes(D + i * D_stride, D_plane);
    const double dc_i[2] = {dc[0 + i * dc_stride], dc[dc_plane + i * dc_stride]};
    ksl_SE3_t Do_i;
    ksl_product_ddrzinv(&D_i, dc_i, &Do_i);
    ksl_SE3_to_planes(&Do_i, Do + i * Do_stride, Do_plane);
  }
}

/* ksl_product_ddtzinv of n elements. */
static KSL_INLINED void ksl_product_ddtzinv_many(ptrdiff_t n, const ksl_SE3_t *D,
    ptrdiff_t D_stride, const double *k, ptrdiff_t k_stride, ksl_SE3_t *Do,
    ptrdiff_t Do_stride) {
  KSL_EACH_OF(n) {
    ksl_product_ddtzinv(D + i * D_stride, k[i * k_stride], Do + i * Do_stride);
  }
}

static KSL_INLINED void ksl_product_ddtzinv_planes(ptrdiff_t n, const double *D, ptrdiff_t D_plane,
    ptrdiff_t D_stride, const double *k, ptrdiff_t k_stride, double *Do,
    ptrdiff_t Do_plane, ptrdiff_t Do_stride) {
  ksl_SE3_t D_i;
  if (n > 0) D_i = ksl_SE3_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3_of_planes(D + i * D_stride, D_plane);
    ksl_SE3_t Do_i;
    ksl_product_ddtzinv(&D_i, k[i * k_stride], &Do_i);
    ksl_SE3_to_planes(&Do_i, Do + i * Do_stride, Do_plane);
  }
}

/* ksl_product_drvf of n elements. */
static KSL_INLINED void ksl_product_drvf_many(ptrdiff_t n, const ksl_mat3x3f_t *R,
    ptrdiff_t R_stride, const ksl_vec3f_t *v, ptrdiff_t v_stride,
    ksl_vec3f_t *vo, ptrdiff_t vo_stride) {
  KSL_EACH_OF(n) {
    ksl_product_drvf(R + i * R_stride, v + i * v_stride, vo + i * vo_stride);
  }
}

static KSL_INLINED void ksl_product_drvf_planes(ptrdiff_t n, const float *R, ptrdiff_t R_plane,
    ptrdiff_t R_stride, const float *v, ptrdiff_t v_plane, ptrdiff_t v_stride,
    float *vo, ptrdiff_t vo_plane, ptrdiff_t vo_stride) {
  ksl_mat3x3f_t R_i;
  if (n > 0) R_i = ksl_mat3x3f_of_planes(R, R_plane);
  KSL_EACH_OF(n) {
    if (R_stride) R_i = ksl_mat3x3f_of_planes(R + i * R_stride, R_plane);
    const ksl_vec3f_t v_i = ksl_vec3f_of_planes(v + i * v_stride, v_plane);
    ksl_vec3f_t vo_i;
    ksl_product_drvf(&R_i, &v_i, &vo_i);
    ksl_vec3f_to_planes(&vo_i, vo + i * vo_stride, vo_plane);
  }
}

/* ksl_product_drvinvf of n elements. */
static KSL_INLINED void ksl_product_drvinvf_many(ptrdiff_t n, const ksl_mat3x3f_t *R,
    ptrdiff_t R_stride, const ksl_vec3f_t *v, ptrdiff_t v_stride,
    ksl_vec3f_t *vo, ptrdiff_t vo_stride) {
  KSL_EACH_OF(n) {
    ksl_product_drvinvf(R + i * R_stride, v + i * v_stride, vo + i * vo_stride);
  }
}

static KSL_INLINED void ksl_product_drvinvf_planes(ptrdiff_t n, const float *R, ptrdiff_t R_plane,
    ptrdiff_t R_stride, const float *v, ptrdiff_t v_plane, ptrdiff_t v_stride,
    float *vo, ptrdiff_t vo_plane, ptrdiff_t vo_stride) {
  ksl_mat3x3f_t R_i;
  if (n > 0) R_i = ksl_mat3x3f_of_planes(R, R_plane);
  KSL_EACH_OF(n) {
    if (R_stride) R_i = ksl_mat3x3f_of_planes(R + i * R_stride, R_plane);
    const ksl_vec3f_t v_i = ksl_vec3f_of_planes(v + i * v_stride, v_plane);
    ksl_vec3f_t vo_i;
    ksl_product_drvinvf(&R_i, &v_i, &vo_i);
    ksl_vec3f_to_planes(&vo_i, vo + i * vo_stride, vo_plane);
  }
}

/* ksl_product_drinvvf of n elements. */
static KSL_INLINED void ksl_product_drinvvf_many(ptrdiff_t n, const ksl_mat3x3f_t *R,
    ptrdiff_t R_stride, const ksl_vec3f_t *v, ptrdiff_t v_stride,
    ksl_vec3f_t *vo, ptrdiff_t vo_stride) {
  KSL_EACH_OF(n) {
    ksl_product_drinvvf(R + i * R_stride, v + i * v_stride, vo + i * vo_stride);
  }
}

static KSL_INLINED void ksl_product_drinvvf_planes(ptrdiff_t n, const float *R, ptrdiff_t R_plane,
    ptrdiff_t R_stride, const float *v, ptrdiff_t v_plane, ptrdiff_t v_stride,
    float *vo, ptrdiff_t vo_plane, ptrdiff_t vo_stride) {
  ksl_mat3x3f_t R_i;
  if (n > 0) R_i = ksl_mat3x3f_of_planes(R, R_plane);
  KSL_EACH_OF(n) {
    if (R_stride) R_i = ksl_mat3x3f_of_planes(R + i * R_stride, R_plane);
    const ksl_vec3f_t v_i = ksl_vec3f_of_planes(v + i * v_stride, v_plane);
    ksl_vec3f_t vo_i;
    ksl_product_drinvvf(&R_i, &v_i, &vo_i);
    ksl_vec3f_to_planes(&vo_i, vo + i * vo_stride, vo_plane);
  }
}

/* ksl_product_drinvvinvf of n elements. */
static KSL_INLINED void ksl_product_drinvvinvf_many(ptrdiff_t n, const ksl_mat3x3f_t *R,
    ptrdiff_t R_stride, const ksl_vec3f_t *v, ptrdiff_t v_stride,
    ksl_vec3f_t *vo, ptrdiff_t vo_stride) {
  KSL_EACH_OF(n) {
    ksl_product_drinvvinvf(R + i * R_stride, v + i * v_stride, vo + i * vo_stride);
  }
}

static KSL_INLINED void ksl_product_drinvvinvf_planes(ptrdiff_t n, const float *R,
    ptrdiff_t R_plane, ptrdiff_t R_stride, const float *v, ptrdiff_t v_plane,
    ptrdiff_t v_stride, float *vo, ptrdiff_t vo_plane, ptrdiff_t vo_stride) {
  ksl_mat3x3f_t R_i;
  if (n > 0) R_i = ksl_mat3x3f_of_planes(R, R_plane);
  KSL_EACH_OF(n) {
    if (R_stride) R_i = ksl_mat3x3f_of_planes(R + i * R_stride, R_plane);
    const ksl_vec3f_t v_i = ksl_vec3f_of_planes(v + i * v_stride, v_plane);
    ksl_vec3f_t vo_i;
    ksl_product_drinvvinvf(&R_i, &v_i, &vo_i);
    ksl_vec3f_to_planes(&vo_i, vo + i * vo_stride, vo_plane);
  }
}

/* ksl_product_dvf of n elements. */
static KSL_INLINED void ksl_product_dvf_many(ptrdiff_t n, const ksl_SE3f_t *D, ptrdiff_t D_stride,
    const ksl_vec3f_t *v, ptrdiff_t v_stride, ksl_vec3f_t *vo,
    ptrdiff_t vo_stride) {
  KSL_EACH_OF(n) {
    ksl_product_dvf(D + i * D_stride, v + i * v_stride, vo + i * vo_stride);
  }
}

static KSL_INLINED void ksl_product_dvf_planes(ptrdiff_t n, const float *D, ptrdiff_t D_plane,
    ptrdiff_t D_stride, const float *v, ptrdiff_t v_plane, ptrdiff_t v_stride,
    float *vo, ptrdiff_t vo_plane, ptrdiff_t vo_stride) {
  ksl_SE3f_t D_i;
  if (n > 0) D_i = ksl_SE3f_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3f_of_planes(D + i * D_stride, D_plane);
    const ksl_vec3f_t v_i = ksl_vec3f_of_planes(v + i * v_stride, v_plane);
    ksl_vec3f_t vo_i;
    ksl_product_dvf(&D_i, &v_i, &vo_i);
    ksl_vec3f_to_planes(&vo_i, vo + i * vo_stride, vo_plane);
  }
}

/* ksl_product_dinvvf of n elements. */
static KSL_INLINED void ksl_product_dinvvf_many(ptrdiff_t n, const ksl_SE3f_t *D,
    ptrdiff_t D_stride, const ksl_vec3f_t *v, ptrdiff_t v_stride,
    ksl_vec3f_t *vo, ptrdiff_t vo_stride) {
  KSL_EACH_OF(n) {
    ksl_product_dinvvf(D + i * D_stride, v + i * v_stride, vo + i * vo_stride);
  }
}

static KSL_INLINED void ksl_product_dinvvf_planes(ptrdiff_t n, const float *D, ptrdiff_t D_plane,
    ptrdiff_t D_stride, const float *v, ptrdiff_t v_plane, ptrdiff_t v_stride,
    float *vo, ptrdiff_t vo_plane, ptrdiff_t vo_stride) {
  ksl_SE3f_t D_i;
  if (n > 0) D_i = ksl_SE3f_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3f_of_planes(D + i * D_stride, D_plane);
    const ksl_vec3f_t v_i = ksl_vec3f_of_planes(v + i * v_stride, v_plane);
    ksl_vec3f_t vo_i;
    ksl_product_dinvvf(&D_i, &v_i, &vo_i);
    ksl_vec3f_to_planes(&vo_i, vo + i * vo_stride, vo_plane);
  }
}

/* ksl_product_drdrf of n elements. */
static KSL_INLINED void ksl_product_drdrf_many(ptrdiff_t n, const ksl_mat3x3f_t *R1,
    ptrdiff_t R1_stride, const ksl_mat3x3f_t *R2, ptrdiff_t R2_stride,
    ksl_mat3x3f_t *Ro, ptrdiff_t Ro_stride) {
  KSL_EACH_OF(n) {
    ksl_product_drdrf(R1 + i * R1_stride, R2 + i * R2_stride, Ro + i * Ro_stride);
  }
}

static KSL_INLINED void ksl_product_drdrf_planes(ptrdiff_t n, const float *R1, ptrdiff_t R1_plane,
    ptrdiff_t R1_stride, const float *R2, ptrdiff_t R2_plane,
    ptrdiff_t R2_stride, float *Ro, ptrdiff_t Ro_plane, ptrdiff_t Ro_stride) {
  ksl_mat3x3f_t R1_i;
  if (n > 0) R1_i = ksl_mat3x3f_of_planes(R1, R1_plane);
  KSL_EACH_OF(n) {
    if (R1_stride) R1_i = ksl_mat3x3f_of_planes(R1 + i * R1_stride, R1_plane);
    const ksl_mat3x3f_t R2_i = ksl_mat3x3f_of_planes(R2 + i * R2_stride, R2_plane);
    ksl_mat3x3f_t Ro_i;
    ksl_product_drdrf(&R1_i, &R2_i, &Ro_i);
    ksl_mat3x3f_to_planes(&Ro_i, Ro + i * Ro_stride, Ro_plane);
  }
}

/* ksl_product_drdrinvf of n elements. */
static KSL_INLINED void ksl_product_drdrinvf_many(ptrdiff_t n, const ksl_mat3x3f_t *R1,
    ptrdiff_t R1_stride, const ksl_mat3x3f_t *R2, ptrdiff_t R2_stride,
    ksl_mat3x3f_t *Ro, ptrdiff_t Ro_stride) {
  KSL_EACH_OF(n) {
    ksl_product_drdrinvf(R1 + i * R1_stride, R2 + i * R2_stride, Ro + i * Ro_stride);
  }
}

static KSL_INLINED void ksl_product_drdrinvf_planes(ptrdiff_t n, const float *R1,
    ptrdiff_t R1_plane, ptrdiff_t R1_stride, const float *R2, ptrdiff_t R2_plane,
    ptrdiff_t R2_stride, float *Ro, ptrdiff_t Ro_plane, ptrdiff_t Ro_stride) {
  ksl_mat3x3f_t R1_i;
  if (n > 0) R1_i = ksl_mat3x3f_of_planes(R1, R1_plane);
  KSL_EACH_OF(n) {
    if (R1_stride) R1_i = ksl_mat3x3f_of_planes(R1 + i * R1_stride, R1_plane);
    const ksl_mat3x3f_t R2_i = ksl_mat3x3f_of_planes(R2 + i * R2_stride, R2_plane);
    ksl_mat3x3f_t Ro_i;
    ksl_product_drdrinvf(&R1_i, &R2_i, &Ro_i);
    ksl_mat3x3f_to_planes(&Ro_i, Ro + i * Ro_stride, Ro_plane);
  }
}

/* ksl_product_drinvdrf of n elements. */
static KSL_INLINED void ksl_product_drinvdrf_many(ptrdiff_t n, const ksl_mat3x3f_t *R1,
    ptrdiff_t R1_stride, const ksl_mat3x3f_t *R2, ptrdiff_t R2_stride,
    ksl_mat3x3f_t *Ro, ptrdiff_t Ro_stride) {
  KSL_EACH_OF(n) {
    ksl_product_drinvdrf(R1 + i * R1_stride, R2 + i * R2_stride, Ro + i * Ro_stride);
  }
}

static KSL_INLINED void ksl_product_drinvdrf_planes(ptrdiff_t n, const float *R1,
    ptrdiff_t R1_plane, ptrdiff_t R1_stride, const float *R2, ptrdiff_t R2_plane,
    ptrdiff_t R2_stride, float *Ro, ptrdiff_t Ro_plane, ptrdiff_t Ro_stride) {
  ksl_mat3x3f_t R1_i;
  if (n > 0) R1_i = ksl_mat3x3f_of_planes(R1, R1_plane);
  KSL_EACH_OF(n) {
    if (R1_stride) R1_i = ksl_mat3x3f_of_planes(R1 + i * R1_stride, R1_plane);
    const ksl_mat3x3f_t R2_i = ksl_mat3x3f_of_planes(R2 + i * R2_stride, R2_plane);
    ksl_mat3x3f_t Ro_i;
    ksl_product_drinvdrf(&R1_i, &R2_i, &Ro_i);
    ksl_mat3x3f_to_planes(&Ro_i, Ro + i * Ro_stride, Ro_plane);
  }
}

/* ksl_product_ddf of n elements. */
static KSL_INLINED void ksl_product_ddf_many(ptrdiff_t n, const ksl_SE3f_t *D1, ptrdiff_t D1_stride,
    const ksl_SE3f_t *D2, ptrdiff_t D2_stride, ksl_SE3f_t *Do,
    ptrdiff_t Do_stride) {
  KSL_EACH_OF(n) {
    ksl_product_ddf(D1 + i * D1_stride, D2 + i * D2_stride, Do + i * Do_stride);
  }
}

static KSL_INLINED void ksl_product_ddf_planes(ptrdiff_t n, const float *D1, ptrdiff_t D1_plane,
    ptrdiff_t D1_stride, const float *D2, ptrdiff_t D2_plane,
    ptrdiff_t D2_stride, float *Do, ptrdiff_t Do_plane, ptrdiff_t Do_stride) {
  ksl_SE3f_t D1_i;
  if (n > 0) D1_i = ksl_SE3f_of_planes(D1, D1_plane);
  KSL_EACH_OF(n) {
    if (D1_stride) D1_i = ksl_SE3f_of_planes(D1 + i * D1_stride, D1_plane);
    const ksl_SE3f_t D2_i = ksl_SE3f_of_planes(D2 + i * D2_stride, D2_plane);
    ksl_SE3f_t Do_i;
    ksl_product_ddf(&D1_i, &D2_i, &Do_i);
    ksl_SE3f_to_planes(&Do_i, Do + i * Do_stride, Do_plane);
  }
}

/* ksl_product_ddinvf of n elements. */
static KSL_INLINED void ksl_product_ddinvf_many(ptrdiff_t n, const ksl_SE3f_t *D1,
    ptrdiff_t D1_stride, const ksl_SE3f_t *D2, ptrdiff_t D2_stride,
    ksl_SE3f_t *Do, ptrdiff_t Do_stride) {
  KSL_EACH_OF(n) {
    ksl_product_ddinvf(D1 + i * D1_stride, D2 + i * D2_stride, Do + i * Do_stride);
  }
}

static KSL_INLINED void ksl_product_ddinvf_planes(ptrdiff_t n, const float *D1, ptrdiff_t D1_plane,
    ptrdiff_t D1_stride, const float *D2, ptrdiff_t D2_plane,
    ptrdiff_t D2_stride, float *Do, ptrdiff_t Do_plane, ptrdiff_t Do_stride) {
  ksl_SE3f_t D1_i;
  if (n > 0) D1_i = ksl_SE3f_of_planes(D1, D1_plane);
  KSL_EACH_OF(n) {
    if (D1_stride) D1_i = ksl_SE3f_of_planes(D1 + i * D1_stride, D1_plane);
    const ksl_SE3f_t D2_i = ksl_SE3f_of_planes(D2 + i * D2_stride, D2_plane);
    ksl_SE3f_t Do_i;
    ksl_product_ddinvf(&D1_i, &D2_i, &Do_i);
    ksl_SE3f_to_planes(&Do_i, Do + i * Do_stride, Do_plane);
  }
}

/* ksl_product_dinvdf of n elements. */
static KSL_INLINED void ksl_product_dinvdf_many(ptrdiff_t n, const ksl_SE3f_t *D1,
    ptrdiff_t D1_stride, const ksl_SE3f_t *D2, ptrdiff_t D2_stride,
    ksl_SE3f_t *Do, ptrdiff_t Do_stride) {
  KSL_EACH_OF(n) {
    ksl_product_dinvdf(D1 + i * D1_stride, D2 + i * D2_stride, Do + i * Do_stride);
  }
}

static KSL_INLINED void ksl_product_dinvdf_planes(ptrdiff_t n, const float *D1, ptrdiff_t D1_plane,
    ptrdiff_t D1_stride, const float *D2, ptrdiff_t D2_plane,
    ptrdiff_t D2_stride, float *Do, ptrdiff_t Do_plane, ptrdiff_t Do_stride) {
  ksl_SE3f_t D1_i;
  if (n > 0) D1_i = ksl_SE3f_of_planes(D1, D1_plane);
  KSL_EACH_OF(n) {
    if (D1_stride) D1_i = ksl_SE3f_of_planes(D1 + i * D1_stride, D1_plane);
    const ksl_SE3f_t D2_i = ksl_SE3f_of_planes(D2 + i * D2_stride, D2_plane);
    ksl_SE3f_t Do_i;
    ksl_product_dinvdf(&D1_i, &D2_i, &Do_i);
    ksl_SE3f_to_planes(&Do_i, Do + i * Do_stride, Do_plane);
  }
}

/* ksl_product_ddrf of n elements. */
static KSL_INLINED void ksl_product_ddrf_many(ptrdiff_t n, const ksl_SE3f_t *D, ptrdiff_t D_stride,
    const ksl_mat3x3f_t *R, ptrdiff_t R_stride, ksl_SE3f_t *Do,
    ptrdiff_t Do_stride) {
  KSL_EACH_OF(n) {
    ksl_product_ddrf(D + i * D_stride, R + i * R_stride, Do + i * Do_stride);
  }
}

static KSL_INLINED void ksl_product_ddrf_planes(ptrdiff_t n, const float *D, ptrdiff_t D_plane,
    ptrdiff_t D_stride, const float *R, ptrdiff_t R_plane, ptrdiff_t R_stride,
    float *Do, ptrdiff_t Do_plane, ptrdiff_t Do_stride) {
  ksl_SE3f_t D_i;
  if (n > 0) D_i = ksl_SE3f_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3f_of_planes(D + i * D_stride, D_plane);
    const ksl_mat3x3f_t R_i = ksl_mat3x3f_of_planes(R + i * R_stride, R_plane);
    ksl_SE3f_t Do_i;
    ksl_product_ddrf(&D_i, &R_i, &Do_i);
    ksl_SE3f_to_planes(&Do_i, Do + i * Do_stride, Do_plane);
  }
}

/* ksl_product_ddrinvf of n elements. */
static KSL_INLINED void ksl_product_ddrinvf_many(ptrdiff_t n, const ksl_SE3f_t *D,
    ptrdiff_t D_stride, const ksl_mat3x3f_t *R, ptrdiff_t R_stride,
    ksl_SE3f_t *Do, ptrdiff_t Do_stride) {
  KSL_EACH_OF(n) {
    ksl_product_ddrinvf(D + i * D_stride, R + i * R_stride, Do + i * Do_stride);
  }
}

static KSL_INLINED void ksl_product_ddrinvf_planes(ptrdiff_t n, const float *D, ptrdiff_t D_plane,
    ptrdiff_t D_stride, const float *R, ptrdiff_t R_plane, ptrdiff_t R_stride,
    float *Do, ptrdiff_t Do_plane, ptrdiff_t Do_stride) {
  ksl_SE3f_t D_i;
  if (n > 0) D_i = ksl_SE3f_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3f_of_planes(D + i * D_stride, D_plane);
    const ksl_mat3x3f_t R_i = ksl_mat3x3f_of_planes(R + i * R_stride, R_plane);
    ksl_SE3f_t Do_i;
    ksl_product_ddrinvf(&D_i, &R_i, &Do_i);
    ksl_SE3f_to_planes(&Do_i, Do + i * Do_stride, Do_plane);
  }
}

/* ksl_product_ddtf of n elements. */
static KSL_INLINED void ksl_product_ddtf_many(ptrdiff_t n, const ksl_SE3f_t *D, ptrdiff_t D_stride,
    const ksl_vec3f_t *t, ptrdiff_t t_stride, ksl_SE3f_t *Do,
    ptrdiff_t Do_stride) {
  KSL_EACH_OF(n) {
    ksl_product_ddtf(D + i * D_stride, t + i * t_stride, Do + i * Do_stride);
  }
}

static KSL_INLINED void ksl_product_ddtf_planes(ptrdiff_t n, const float *D, ptrdiff_t D_plane,
    ptrdiff_t D_stride, const float *t, ptrdiff_t t_plane, ptrdiff_t t_stride,
    float *Do, ptrdiff_t Do_plane, ptrdiff_t Do_stride) {
  ksl_SE3f_t D_i;
  if (n > 0) D_i = ksl_SE3f_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3f_of_planes(D + i * D_stride, D_plane);
    const ksl_vec3f_t t_i = ksl_vec3f_of_planes(t + i * t_stride, t_plane);
    ksl_SE3f_t Do_i;
    ksl_product_ddtf(&D_i, &t_i, &Do_i);
    ksl_SE3f_to_planes(&Do_i, Do + i * Do_stride, Do_plane);
  }
}

/* ksl_product_ddtinvf of n elements. */
static KSL_INLINED void ksl_product_ddtinvf_many(ptrdiff_t n, const ksl_SE3f_t *D,
    ptrdiff_t D_stride, const ksl_vec3f_t *t, ptrdiff_t t_stride, ksl_SE3f_t *Do,
    ptrdiff_t Do_stride) {
  KSL_EACH_OF(n) {
    ksl_product_ddtinvf(D + i * D_stride, t + i * t_stride, Do + i * Do_stride);
  }
}

static KSL_INLINED void ksl_product_ddtinvf_planes(ptrdiff_t n, const float *D, ptrdiff_t D_plane,
    ptrdiff_t D_stride, const float *t, ptrdiff_t t_plane, ptrdiff_t t_stride,
    float *Do, ptrdiff_t Do_plane, ptrdiff_t Do_stride) {
  ksl_SE3f_t D_i;
  if (n > 0) D_i = ksl_SE3f_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3f_of_planes(D + i * D_stride, D_plane);
    const ksl_vec3f_t t_i = ksl_vec3f_of_planes(t + i * t_stride, t_plane);
    ksl_SE3f_t Do_i;
    ksl_product_ddtinvf(&D_i, &t_i, &Do_i);
    ksl_SE3f_to_planes(&Do_i, Do + i * Do_stride, Do_plane);
  }
}

/* ksl_product_dinvdtf of n elements. */
static KSL_INLINED void ksl_product_dinvdtf_many(ptrdiff_t n, const ksl_SE3f_t *D,
    ptrdiff_t D_stride, const ksl_vec3f_t *t, ptrdiff_t t_stride, ksl_SE3f_t *Do,
    ptrdiff_t Do_stride) {
  KSL_EACH_OF(n) {
    ksl_product_dinvdtf(D + i * D_stride, t + i * t_stride, Do + i * Do_stride);
  }
}

static KSL_INLINED void ksl_product_dinvdtf_planes(ptrdiff_t n, const float *D, ptrdiff_t D_plane,
    ptrdiff_t D_stride, const float *t, ptrdiff_t t_plane, ptrdiff_t t_stride,
    float *Do, ptrdiff_t Do_plane, ptrdiff_t Do_stride) {
  ksl_SE3f_t D_i;
  if (n > 0) D_i = ksl_SE3f_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3f_of_planes(D + i * D_stride, D_plane);
    const ksl_vec3f_t t_i = ksl_vec3f_of_planes(t + i * t_stride, t_plane);
    ksl_SE3f_t Do_i;
    ksl_product_dinvdtf(&D_i, &t_i, &Do_i);
    ksl_SE3f_to_planes(&Do_i, Do + i * Do_stride, Do_plane);
  }
}

/* ksl_product_drvtxf of n elements. */
static KSL_INLINED void ksl_product_drvtxf_many(ptrdiff_t n, const ksl_mat3x3f_t *R,
    ptrdiff_t R_stride, const float *k, ptrdiff_t k_stride, ksl_vec3f_t *vo,
    ptrdiff_t vo_stride) {
  KSL_EACH_OF(n) {
    ksl_product_drvtxf(R + i * R_stride, k[i * k_stride], vo + i * vo_stride);
  }
}

static KSL_INLINED void ksl_product_drvtxf_planes(ptrdiff_t n, const float *R, ptrdiff_t R_plane,
    ptrdiff_t R_stride, const float *k, ptrdiff_t k_stride, float *vo,
    ptrdiff_t vo_plane, ptrdiff_t vo_stride) {
  ksl_mat3x3f_t R_i;
  if (n > 0) R_i = ksl_mat3x3f_of_planes(R, R_plane);
  KSL_EACH_OF(n) {
    if (R_stride) R_i = ksl_mat3x3f_of_planes(R + i * R_stride, R_plane);
    ksl_vec3f_t vo_i;
    ksl_product_drvtxf(&R_i, k[i * k_stride], &vo_i);
    ksl_vec3f_to_planes(&vo_i, vo + i * vo_stride, vo_plane);
  }
}

/* ksl_product_drdrxf of n elements. */
static KSL_INLINED void ksl_product_drdrxf_many(ptrdiff_t n, const ksl_mat3x3f_t *R,
    ptrdiff_t R_stride, const float *dc, ptrdiff_t dc_stride, ksl_mat3x3f_t *Ro,
    ptrdiff_t Ro_stride) {
  KSL_EACH_OF(n) {
    ksl_product_drdrxf(R + i * R_stride, dc + 2 * i * dc_stride, Ro + i * Ro_stride);
  }
}

static KSL_INLINED void ksl_product_drdrxf_planes(ptrdiff_t n, const float *R, ptrdiff_t R_plane,
    ptrdiff_t R_stride, const float *dc, ptrdiff_t dc_plane, ptrdiff_t dc_stride,
    float *Ro, ptrdiff_t Ro_plane, ptrdiff_t Ro_stride) {
  ksl_mat3x3f_t R_i;
  if (n > 0) R_i = ksl_mat3x3f_of_planes(R, R_plane);
  KSL_EACH_OF(n) {
    if (R_stride) R_i = ksl_mat3x3f_of_planes(R + i * R_stride, R_plane);
    const float dc_i[2] = {dc[0 + i * dc_stride], dc[dc_plane + i * dc_stride]};
    ksl_mat3x3f_t Ro_i;
    ksl_product_drdrxf(&R_i, dc_i, &Ro_i);
    ksl_mat3x3f_to_planes(&Ro_i, Ro + i * Ro_stride, Ro_plane);
  }
}

/* ksl_product_ddrxf of n elements. */
static KSL_INLINED void ksl_product_ddrxf_many(ptrdiff_t n, const ksl_SE3f_t *D, ptrdiff_t D_stride,
    const float *dc, ptrdiff_t dc_stride, ksl_SE3f_t *Do, ptrdiff_t Do_stride) {
  KSL_EACH_OF(n) {
    ksl_product_ddrxf(D + i * D_stride, dc + 2 * i * dc_stride, Do + i * Do_stride);
  }
}

static KSL_INLINED void ksl_product_ddrxf_planes(ptrdiff_t n, const float *D, ptrdiff_t D_plane,
    ptrdiff_t D_stride, const float *dc, ptrdiff_t dc_plane, ptrdiff_t dc_stride,
    float *Do, ptrdiff_t Do_plane, ptrdiff_t Do_stride) {
  ksl_SE3f_t D_i;
  if (n > 0) D_i = ksl_SE3f_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3f_of_planes(D + i * D_stride, D_plane);
    const float dc_i[2] = {dc[0 + i * dc_stride], dc[dc_plane + i * dc_stride]};
    ksl_SE3f_t Do_i;
    ksl_product_ddrxf(&D_i, dc_i, &Do_i);
    ksl_SE3f_to_planes(&Do_i, Do + i * Do_stride, Do_plane);
  }
}

/* ksl_product_ddtxf of n elements. */
static KSL_INLINED void ksl_product_ddtxf_many(ptrdiff_t n, const ksl_SE3f_t *D, ptrdiff_t D_stride,
    const float *k, ptrdiff_t k_stride, ksl_SE3f_t *Do, ptrdiff_t Do_stride) {
  KSL_EACH_OF(n) {
    ksl_product_ddtxf(D + i * D_stride, k[i * k_stride], Do + i * Do_stride);
  }
}

static KSL_INLINED void ksl_product_ddtxf_planes(ptrdiff_t n, const float *D, ptrdiff_t D_plane,
    ptrdiff_t D_stride, const float *k, ptrdiff_t k_stride, float *Do,
    ptrdiff_t Do_plane, ptrdiff_t Do_stride) {
  ksl_SE3f_t D_i;
  if (n > 0) D_i = ksl_SE3f_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3f_of_planes(D + i * D_stride, D_plane);
    ksl_SE3f_t Do_i;
    ksl_product_ddtxf(&D_i, k[i * k_stride], &Do_i);
    ksl_SE3f_to_planes(&Do_i, Do + i * Do_stride, Do_plane);
  }
}

/* ksl_product_drvtxinvf of n elements. */
static KSL_INLINED void ksl_product_drvtxinvf_many(ptrdiff_t n, const ksl_mat3x3f_t *R,
    ptrdiff_t R_stride, const float *k, ptrdiff_t k_stride, ksl_vec3f_t *vo,
    ptrdiff_t vo_stride) {
  KSL_EACH_OF(n) {
    ksl_product_drvtxinvf(R + i * R_stride, k[i * k_stride], vo + i * vo_stride);
  }
}

static KSL_INLINED void ksl_product_drvtxinvf_planes(ptrdiff_t n, const float *R, ptrdiff_t R_plane,
    ptrdiff_t R_stride, const float *k, ptrdiff_t k_stride, float *vo,
    ptrdiff_t vo_plane, ptrdiff_t vo_stride) {
  ksl_mat3x3f_t R_i;
  if (n > 0) R_i = ksl_mat3x3f_of_planes(R, R_plane);
  KSL_EACH_OF(n) {
    if (R_stride) R_i = ksl_mat3x3f_of_planes(R + i * R_stride, R_plane);
    ksl_vec3f_t vo_i;
    ksl_product_drvtxinvf(&R_i, k[i * k_stride], &vo_i);
    ksl_vec3f_to_planes(&vo_i, vo + i * vo_stride, vo_plane);
  }
}

/* ksl_product_drdrxinvf of n elements. */
static KSL_INLINED void ksl_product_drdrxinvf_many(ptrdiff_t n, const ksl_mat3x3f_t *R,
    ptrdiff_t R_stride, const float *dc, ptrdiff_t dc_stride, ksl_mat3x3f_t *Ro,
    ptrdiff_t Ro_stride) {
  KSL_EACH_OF(n) {
    ksl_product_drdrxinvf(R + i * R_stride, dc + 2 * i * dc_stride, Ro + i * Ro_stride);
  }
}

static KSL_INLINED void ksl_product_drdrxinvf_planes(ptrdiff_t n, const float *R, ptrdiff_t R_plane,
    ptrdiff_t R_stride, const float *dc, ptrdiff_t dc_plane, ptrdiff_t dc_stride,
    float *Ro, ptrdiff_t Ro_plane, ptrdiff_t Ro_stride) {
  ksl_mat3x3f_t R_i;
  if (n > 0) R_i = ksl_mat3x3f_of_planes(R, R_plane);
  KSL_EACH_OF(n) {
    if (R_stride) R_i = ksl_mat3x3f_of_planes(R + i * R_stride, R_plane);
    const float dc_i[2] = {dc[0 + i * dc_stride], dc[dc_plane + i * dc_stride]};
    ksl_mat3x3f_t Ro_i;
    ksl_product_drdrxinvf(&R_i, dc_i, &Ro_i);
    ksl_mat3x3f_to_planes(&Ro_i, Ro + i * Ro_stride, Ro_plane);
  }
}

/* ksl_product_ddrxinvf of n elements. */
static KSL_INLINED void ksl_product_ddrxinvf_many(ptrdiff_t n, const ksl_SE3f_t *D,
    ptrdiff_t D_stride, const float *dc, ptrdiff_t dc_stride, ksl_SE3f_t *Do,
    ptrdiff_t Do_stride) {
  KSL_EACH_OF(n) {
    ksl_product_ddrxinvf(D + i * D_stride, dc + 2 * i * dc_stride, Do + i * Do_stride);
  }
}

static KSL_INLINED void ksl_product_ddrxinvf_planes(ptrdiff_t n, const float *D, ptrdiff_t D_plane,
    ptrdiff_t D_stride, const float *dc, ptrdiff_t dc_plane, ptrdiff_t dc_stride,
    float *Do, ptrdiff_t Do_plane, ptrdiff_t Do_stride) {
  ksl_SE3f_t D_i;
  if (n > 0) D_i = ksl_SE3f_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3f_of_planes(D + i * D_stride, D_plane);
    const float dc_i[2] = {dc[0 + i * dc_stride], dc[dc_plane + i * dc_stride]};
    ksl_SE3f_t Do_i;
    ksl_product_ddrxinvf(&D_i, dc_i, &Do_i);
    ksl_SE3f_to_planes(&Do_i, Do + i * Do_stride, Do_plane);
  }
}

/* ksl_product_ddtxinvf of n elements. */
static KSL_INLINED void ksl_product_ddtxinvf_many(ptrdiff_t n, const ksl_SE3f_t *D,
    ptrdiff_t D_stride, const float *k, ptrdiff_t k_stride, ksl_SE3f_t *Do,
    ptrdiff_t Do_stride) {
  KSL_EACH_OF(n) {
    ksl_product_ddtxinvf(D + i * D_stride, k[i * k_stride], Do + i * Do_stride);
  }
}

static KSL_INLINED void ksl_product_ddtxinvf_planes(ptrdiff_t n, const float *D, ptrdiff_t D_plane,
    ptrdiff_t D_stride, const float *k, ptrdiff_t k_stride, float *Do,
    ptrdiff_t Do_plane, ptrdiff_t Do_stride) {
  ksl_SE3f_t D_i;
  if (n > 0) D_i = ksl_SE3f_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3f_of_planes(D + i * D_stride, D_plane);
    ksl_SE3f_t Do_i;
    ksl_product_ddtxinvf(&D_i, k[i * k_stride], &Do_i);
    ksl_SE3f_to_planes(&Do_i, Do + i * Do_stride, Do_plane);
  }
}

/* ksl_product_drvtyf of n elements. */
static KSL_INLINED void ksl_product_drvtyf_many(ptrdiff_t n, const ksl_mat3x3f_t *R,
    ptrdiff_t R_stride, const float *k, ptrdiff_t k_stride, ksl_vec3f_t *vo,
    ptrdiff_t vo_stride) {
  KSL_EACH_OF(n) {
    ksl_product_drvtyf(R + i * R_stride, k[i * k_stride], vo + i * vo_stride);
  }
}

static KSL_INLINED void ksl_product_drvtyf_planes(ptrdiff_t n, const float *R, ptrdiff_t R_plane,
    ptrdiff_t R_stride, const float *k, ptrdiff_t k_stride, float *vo,
    ptrdiff_t vo_plane, ptrdiff_t vo_stride) {
  ksl_mat3x3f_t R_i;
  if (n > 0) R_i = ksl_mat3x3f_of_planes(R, R_plane);
  KSL_EACH_OF(n) {
    if (R_stride) R_i = ksl_mat3x3f_of_planes(R + i * R_stride, R_plane);
    ksl_vec3f_t vo_i;
    ksl_product_drvtyf(&R_i, k[i * k_stride], &vo_i);
    ksl_vec3f_to_planes(&vo_i, vo + i * vo_stride, vo_plane);
  }
}

/* ksl_product_drdryf of n elements. */
static KSL_INLINED void ksl_product_drdryf_many(ptrdiff_t n, const ksl_mat3x3f_t *R,
    ptrdiff_t R_stride, const float *dc, ptrdiff_t dc_stride, ksl_mat3x3f_t *Ro,
    ptrdiff_t Ro_stride) {
  KSL_EACH_OF(n) {
    ksl_product_drdryf(R + i * R_stride, dc + 2 * i * dc_stride, Ro + i * Ro_stride);
  }
}

static KSL_INLINED void ksl_product_drdryf_planes(ptrdiff_t n, const float *R, ptrdiff_t R_plane,
    ptrdiff_t R_stride, const float *dc, ptrdiff_t dc_plane, ptrdiff_t dc_stride,
    float *Ro, ptrdiff_t Ro_plane, ptrdiff_t Ro_stride) {
  ksl_mat3x3f_t R_i;
  if (n > 0) R_i = ksl_mat3x3f_of_planes(R, R_plane);
  KSL_EACH_OF(n) {
    if (R_stride) R_i = ksl_mat3x3f_of_planes(R + i * R_stride, R_plane);
    const float dc_i[2] = {dc[0 + i * dc_stride], dc[dc_plane + i * dc_stride]};
    ksl_mat3x3f_t Ro_i;
    ksl_product_drdryf(&R_i, dc_i, &Ro_i);
    ksl_mat3x3f_to_planes(&Ro_i, Ro + i * Ro_stride, Ro_plane);
  }
}

/* ksl_product_ddryf of n elements. */
static KSL_INLINED void ksl_product_ddryf_many(ptrdiff_t n, const ksl_SE3f_t *D, ptrdiff_t D_stride,
    const float *dc, ptrdiff_t dc_stride, ksl_SE3f_t *Do, ptrdiff_t Do_stride) {
  KSL_EACH_OF(n) {
    ksl_product_ddryf(D + i * D_stride, dc + 2 * i * dc_stride, Do + i * Do_stride);
  }
}

static KSL_INLINED void ksl_product_ddryf_planes(ptrdiff_t n, const float *D, ptrdiff_t D_plane,
    ptrdiff_t D_stride, const float *dc, ptrdiff_t dc_plane, ptrdiff_t dc_stride,
    float *Do, ptrdiff_t Do_plane, ptrdiff_t Do_stride) {
  ksl_SE3f_t D_i;
  if (n > 0) D_i = ksl_SE3f_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3f_of_planes(D + i * D_stride, D_plane);
    const float dc_i[2] = {dc[0 + i * dc_stride], dc[dc_plane + i * dc_stride]};
    ksl_SE3f_t Do_i;
    ksl_product_ddryf(&D_i, dc_i, &Do_i);
    ksl_SE3f_to_planes(&Do_i, Do + i * Do_stride, Do_plane);
  }
}

/* ksl_product_ddtyf of n elements. */
static KSL_INLINED void ksl_product_ddtyf_many(ptrdiff_t n, const ksl_SE3f_t *D, ptrdiff_t D_stride,
    const float *k, ptrdiff_t k_stride, ksl_SE3f_t *Do, ptrdiff_t Do_stride) {
  KSL_EACH_OF(n) {
    ksl_product_ddtyf(D + i * D_stride, k[i * k_stride], Do + i * Do_stride);
  }
}

static KSL_INLINED void ksl_product_ddtyf_planes(ptrdiff_t n, const float *D, ptrdiff_t D_plane,
    ptrdiff_t D_stride, const float *k, ptrdiff_t k_stride, float *Do,
    ptrdiff_t Do_plane, ptrdiff_t Do_stride) {
  ksl_SE3f_t D_i;
  if (n > 0) D_i = ksl_SE3f_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3f_of_planes(D + i * D_stride, D_plane);
    ksl_SE3f_t Do_i;
    ksl_product_ddtyf(&D_i, k[i * k_stride], &Do_i);
    ksl_SE3f_to_planes(&Do_i, Do + i * Do_stride, Do_plane);
  }
}

/* ksl_product_drvtyinvf of n elements. */
static KSL_INLINED void ksl_product_drvtyinvf_many(ptrdiff_t n, const ksl_mat3x3f_t *R,
    ptrdiff_t R_stride, const float *k, ptrdiff_t k_stride, ksl_vec3f_t *vo,
    ptrdiff_t vo_stride) {
  KSL_EACH_OF(n) {
    ksl_product_drvtyinvf(R + i * R_stride, k[i * k_stride], vo + i * vo_stride);
  }
}

static KSL_INLINED void ksl_product_drvtyinvf_planes(ptrdiff_t n, const float *R, ptrdiff_t R_plane,
    ptrdiff_t R_stride, const float *k, ptrdiff_t k_stride, float *vo,
    ptrdiff_t vo_plane, ptrdiff_t vo_stride) {
  ksl_mat3x3f_t R_i;
  if (n > 0) R_i = ksl_mat3x3f_of_planes(R, R_plane);
  KSL_EACH_OF(n) {
    if (R_stride) R_i = ksl_mat3x3f_of_planes(R + i * R_stride, R_plane);
    ksl_vec3f_t vo_i;
    ksl_product_drvtyinvf(&R_i, k[i * k_stride], &vo_i);
    ksl_vec3f_to_planes(&vo_i, vo + i * vo_stride, vo_plane);
  }
}

/* ksl_product_drdryinvf of n elements. */
static KSL_INLINED void ksl_product_drdryinvf_many(ptrdiff_t n, const ksl_mat3x3f_t *R,
    ptrdiff_t R_stride, const float *dc, ptrdiff_t dc_stride, ksl_mat3x3f_t *Ro,
    ptrdiff_t Ro_stride) {
  KSL_EACH_OF(n) {
    ksl_product_drdryinvf(R + i * R_stride, dc + 2 * i * dc_stride, Ro + i * Ro_stride);
  }
}

static KSL_INLINED void ksl_product_drdryinvf_planes(ptrdiff_t n, const float *R, ptrdiff_t R_plane,
    ptrdiff_t R_stride, const float *dc, ptrdiff_t dc_plane, ptrdiff_t dc_stride,
    float *Ro, ptrdiff_t Ro_plane, ptrdiff_t Ro_stride) {
  ksl_mat3x3f_t R_i;
  if (n > 0) R_i = ksl_mat3x3f_of_planes(R, R_plane);
  KSL_EACH_OF(n) {
    if (R_stride) R_i = ksl_mat3x3f_of_planes(R + i * R_stride, R_plane);
    const float dc_i[2] = {dc[0 + i * dc_stride], dc[dc_plane + i * dc_stride]};
    ksl_mat3x3f_t Ro_i;
    ksl_product_drdryinvf(&R_i, dc_i, &Ro_i);
    ksl_mat3x3f_to_planes(&Ro_i, Ro + i * Ro_stride, Ro_plane);
  }
}

/* ksl_product_ddryinvf of n elements. */
static KSL_INLINED void ksl_product_ddryinvf_many(ptrdiff_t n, const ksl_SE3f_t *D,
    ptrdiff_t D_stride, const float *dc, ptrdiff_t dc_stride, ksl_SE3f_t *Do,
    ptrdiff_t Do_stride) {
  KSL_EACH_OF(n) {
    ksl_product_ddryinvf(D + i * D_stride, dc + 2 * i * dc_stride, Do + i * Do_stride);
  }
}

static KSL_INLINED void ksl_product_ddryinvf_planes(ptrdiff_t n, const float *D, ptrdiff_t D_plane,
    ptrdiff_t D_stride, const float *dc, ptrdiff_t dc_plane, ptrdiff_t dc_stride,
    float *Do, ptrdiff_t Do_plane, ptrdiff_t Do_stride) {
  ksl_SE3f_t D_i;
  if (n > 0) D_i = ksl_SE3f_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3f_of_planes(D + i * D_stride, D_plane);
    const float dc_i[2] = {dc[0 + i * dc_stride], dc[dc_plane + i * dc_stride]};
    ksl_SE3f_t Do_i;
    ksl_product_ddryinvf(&D_i, dc_i, &Do_i);
    ksl_SE3f_to_planes(&Do_i, Do + i * Do_stride, Do_plane);
  }
}

/* ksl_product_ddtyinvf of n elements. */
static KSL_INLINED void ksl_product_ddtyinvf_many(ptrdiff_t n, const ksl_SE3f_t *D,
    ptrdiff_t D_stride, const float *k, ptrdiff_t k_stride, ksl_SE3f_t *Do,
    ptrdiff_t Do_stride) {
  KSL_EACH_OF(n) {
    ksl_product_ddtyinvf(D + i * D_stride, k[i * k_stride], Do + i * Do_stride);
  }
}

static KSL_INLINED void ksl_product_ddtyinvf_planes(ptrdiff_t n, const float *D, ptrdiff_t D_plane,
    ptrdiff_t D_stride, const float *k, ptrdiff_t k_stride, float *Do,
    ptrdiff_t Do_plane, ptrdiff_t Do_stride) {
  ksl_SE3f_t D_i;
  if (n > 0) D_i = ksl_SE3f_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3f_of_planes(D + i * D_stride, D_plane);
    ksl_SE3f_t Do_i;
    ksl_product_ddtyinvf(&D_i, k[i * k_stride], &Do_i);
    ksl_SE3f_to_planes(&Do_i, Do + i * Do_stride, Do_plane);
  }
}

/* ksl_product_drvtzf of n elements. */
static KSL_INLINED void ksl_product_drvtzf_many(ptrdiff_t n, const ksl_mat3x3f_t *R,
    ptrdiff_t R_stride, const float *k, ptrdiff_t k_stride, ksl_vec3f_t *vo,
    ptrdiff_t vo_stride) {
  KSL_EACH_OF(n) {
    ksl_product_drvtzf(R + i * R_stride, k[i * k_stride], vo + i * vo_stride);
  }
}

static KSL_INLINED void ksl_product_drvtzf_planes(ptrdiff_t n, const float *R, ptrdiff_t R_plane,
    ptrdiff_t R_stride, const float *k, ptrdiff_t k_stride, float *vo,
    ptrdiff_t vo_plane, ptrdiff_t vo_stride) {
  ksl_mat3x3f_t R_i;
  if (n > 0) R_i = ksl_mat3x3f_of_planes(R, R_plane);
  KSL_EACH_OF(n) {
    if (R_stride) R_i = ksl_mat3x3f_of_planes(R + i * R_stride, R_plane);
    ksl_vec3f_t vo_i;
    ksl_product_drvtzf(&R_i, k[i * k_stride], &vo_i);
    ksl_vec3f_to_planes(&vo_i, vo + i * vo_stride, vo_plane);
  }
}

/* ksl_product_drdrzf of n elements. */
static KSL_INLINED void ksl_product_drdrzf_many(ptrdiff_t n, const ksl_mat3x3f_t *R,
    ptrdiff_t R_stride, const float *dc, ptrdiff_t dc_stride, ksl_mat3x3f_t *Ro,
    ptrdiff_t Ro_stride) {
  KSL_EACH_OF(n) {
    ksl_product_drdrzf(R + i * R_stride, dc + 2 * i * dc_stride, Ro + i * Ro_stride);
  }
}

static KSL_INLINED void ksl_product_drdrzf_planes(ptrdiff_t n, const float *R, ptrdiff_t R_plane,
    ptrdiff_t R_stride, const float *dc, ptrdiff_t dc_plane, ptrdiff_t dc_stride,
    float *Ro, ptrdiff_t Ro_plane, ptrdiff_t Ro_stride) {
  ksl_mat3x3f_t R_i;
  if (n > 0) R_i = ksl_mat3x3f_of_planes(R, R_plane);
  KSL_EACH_OF(n) {
    if (R_stride) R_i = ksl_mat3x3f_of_planes(R + i * R_stride, R_plane);
    const float dc_i[2] = {dc[0 + i * dc_stride], dc[dc_plane + i * dc_stride]};
    ksl_mat3x3f_t Ro_i;
    ksl_product_drdrzf(&R_i, dc_i, &Ro_i);
    ksl_mat3x3f_to_planes(&Ro_i, Ro + i * Ro_stride, Ro_plane);
  }
}

/* ksl_product_ddrzf of n elements. */
static KSL_INLINED void ksl_product_ddrzf_many(ptrdiff_t n, const ksl_SE3f_t *D, ptrdiff_t D_stride,
    const float *dc, ptrdiff_t dc_stride, ksl_SE3f_t *Do, ptrdiff_t Do_stride) {
  KSL_EACH_OF(n) {
    ksl_product_ddrzf(D + i * D_stride, dc + 2 * i * dc_stride, Do + i * Do_stride);
  }
}

static KSL_INLINED void ksl_product_ddrzf_planes(ptrdiff_t n, const float *D, ptrdiff_t D_plane,
    ptrdiff_t D_stride, const float *dc, ptrdiff_t dc_plane, ptrdiff_t dc_stride,
    float *Do, ptrdiff_t Do_plane, ptrdiff_t Do_stride) {
  ksl_SE3f_t D_i;
  if (n > 0) D_i = ksl_SE3f_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3f_of_planes(D + i * D_stride, D_plane);
    const float dc_i[2] = {dc[0 + i * dc_stride], dc[dc_plane + i * dc_stride]};
    ksl_SE3f_t Do_i;
    ksl_product_ddrzf(&D_i, dc_i, &Do_i);
    ksl_SE3f_to_planes(&Do_i, Do + i * Do_stride, Do_plane);
  }
}

/* ksl_product_ddtzf of n elements. */
static KSL_INLINED void ksl_product_ddtzf_many(ptrdiff_t n, const ksl_SE3f_t *D, ptrdiff_t D_stride,
    const float *k, ptrdiff_t k_stride, ksl_SE3f_t *Do, ptrdiff_t Do_stride) {
  KSL_EACH_OF(n) {
    ksl_product_ddtzf(D + i * D_stride, k[i * k_stride], Do + i * Do_stride);
  }
}

static KSL_INLINED void ksl_product_ddtzf_planes(ptrdiff_t n, const float *D, ptrdiff_t D_plane,
    ptrdiff_t D_stride, const float *k, ptrdiff_t k_stride, float *Do,
    ptrdiff_t Do_plane, ptrdiff_t Do_stride) {
  ksl_SE3f_t D_i;
  if (n > 0) D_i = ksl_SE3f_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3f_of_planes(D + i * D_stride, D_plane);
    ksl_SE3f_t Do_i;
    ksl_product_ddtzf(&D_i, k[i * k_stride], &Do_i);
    ksl_SE3f_to_planes(&Do_i, Do + i * Do_stride, Do_plane);
  }
}

/* ksl_product_drvtzinvf of n elements. */
static KSL_INLINED void ksl_product_drvtzinvf_many(ptrdiff_t n, const ksl_mat3x3f_t *R,
    ptrdiff_t R_stride, const float *k, ptrdiff_t k_stride, ksl_vec3f_t *vo,
    ptrdiff_t vo_stride) {
  KSL_EACH_OF(n) {
    ksl_product_drvtzinvf(R + i * R_stride, k[i * k_stride], vo + i * vo_stride);
  }
}

static KSL_INLINED void ksl_product_drvtzinvf_planes(ptrdiff_t n, const float *R, ptrdiff_t R_plane,
    ptrdiff_t R_stride, const float *k, ptrdiff_t k_stride, float *vo,
    ptrdiff_t vo_plane, ptrdiff_t vo_stride) {
  ksl_mat3x3f_t R_i;
  if (n > 0) R_i = ksl_mat3x3f_of_planes(R, R_plane);
  KSL_EACH_OF(n) {
    if (R_stride) R_i = ksl_mat3x3f_of_planes(R + i * R_stride, R_plane);
    ksl_vec3f_t vo_i;
    ksl_product_drvtzinvf(&R_i, k[i * k_stride], &vo_i);
    ksl_vec3f_to_planes(&vo_i, vo + i * vo_stride, vo_plane);
  }
}

/* ksl_product_drdrzinvf of n elements. */
static KSL_INLINED void ksl_product_drdrzinvf_many(ptrdiff_t n, const ksl_mat3x3f_t *R,
    ptrdiff_t R_stride, const float *dc, ptrdiff_t dc_stride, ksl_mat3x3f_t *Ro,
    ptrdiff_t Ro_stride) {
  KSL_EACH_OF(n) {
    ksl_product_drdrzinvf(R + i * R_stride, dc + 2 * i * dc_stride, Ro + i * Ro_stride);
  }
}

static KSL_INLINED void ksl_product_drdrzinvf_planes(ptrdiff_t n, const float *R, ptrdiff_t R_plane,
    ptrdiff_t R_stride, const float *dc, ptrdiff_t dc_plane, ptrdiff_t dc_stride,
    float *Ro, ptrdiff_t Ro_plane, ptrdiff_t Ro_stride) {
  ksl_mat3x3f_t R_i;
  if (n > 0) R_i = ksl_mat3x3f_of_planes(R, R_plane);
  KSL_EACH_OF(n) {
    if (R_stride) R_i = ksl_mat3x3f_of_planes(R + i * R_stride, R_plane);
    const float dc_i[2] = {dc[0 + i * dc_stride], dc[dc_plane + i * dc_stride]};
    ksl_mat3x3f_t Ro_i;
    ksl_product_drdrzinvf(&R_i, dc_i, &Ro_i);
    ksl_mat3x3f_to_planes(&Ro_i, Ro + i * Ro_stride, Ro_plane);
  }
}

/* ksl_product_ddrzinvf of n elements. */
static KSL_INLINED void ksl_product_ddrzinvf_many(ptrdiff_t n, const ksl_SE3f_t *D,
    ptrdiff_t D_stride, const float *dc, ptrdiff_t dc_stride, ksl_SE3f_t *Do,
    ptrdiff_t Do_stride) {
  KSL_EACH_OF(n) {
    ksl_product_ddrzinvf(D + i * D_stride, dc + 2 * i * dc_stride, Do + i * Do_stride);
  }
}

static KSL_INLINED void ksl_product_ddrzinvf_planes(ptrdiff_t n, const float *D, ptrdiff_t D_plane,
    ptrdiff_t D_stride, const float *dc, ptrdiff_t dc_plane, ptrdiff_t dc_stride,
    float *Do, ptrdiff_t Do_plane, ptrdiff_t Do_stride) {
  ksl_SE3f_t D_i;
  if (n > 0) D_i = ksl_SE3f_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3f_of_planes(D + i * D_stride, D_plane);
    const float dc_i[2] = {dc[0 + i * dc_stride], dc[dc_plane + i * dc_stride]};
    ksl_SE3f_t Do_i;
    ksl_product_ddrzinvf(&D_i, dc_i, &Do_i);
    ksl_SE3f_to_planes(&Do_i, Do + i * Do_stride, Do_plane);
  }
}

/* ksl_product_ddtzinvf of n elements. */
static KSL_INLINED void ksl_product_ddtzinvf_many(ptrdiff_t n, const ksl_SE3f_t *D,
    ptrdiff_t D_stride, const float *k, ptrdiff_t k_stride, ksl_SE3f_t *Do,
    ptrdiff_t Do_stride) {
  KSL_EACH_OF(n) {
    ksl_product_ddtzinvf(D + i * D_stride, k[i * k_stride], Do + i * Do_stride);
  }
}

static KSL_INLINED void ksl_product_ddtzinvf_planes(ptrdiff_t n, const float *D, ptrdiff_t D_plane,
    ptrdiff_t D_stride, const float *k, ptrdiff_t k_stride, float *Do,
    ptrdiff_t Do_plane, ptrdiff_t Do_stride) {
  ksl_SE3f_t D_i;
  if (n > 0) D_i = ksl_SE3f_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3f_of_planes(D + i * D_stride, D_plane);
    ksl_SE3f_t Do_i;
    ksl_product_ddtzinvf(&D_i, k[i * k_stride], &Do_i);
    ksl_SE3f_to_planes(&Do_i, Do + i * Do_stride, Do_plane);
  }
}

#endif
