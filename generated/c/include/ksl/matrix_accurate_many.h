/* Made by `coscrew generate`; changes are overwritten. */
/* SPDX-License-Identifier: MIT */
/* coscrew 0.2.0.  Copyright (c) 2026 The coscrew authors. */
/* Products between rotations, displacements and vectors.  Many at a time.
   What arguments are, and what loops over them cost, ksl_planes.h says. */
#ifndef KSL_MATRIX_ACCURATE_MANY_H
#define KSL_MATRIX_ACCURATE_MANY_H

#include "matrix_accurate.h"
#include "ksl_planes.h"

/* ksl_product_drv_accurate of n elements. */
static KSL_INLINED void ksl_product_drv_accurate_many(ptrdiff_t n, const ksl_mat3x3_t *R,
    ptrdiff_t R_stride, const ksl_vec3_t *v, ptrdiff_t v_stride, ksl_vec3_t *vo,
    ptrdiff_t vo_stride) {
  KSL_EACH_OF(n) {
    ksl_product_drv_accurate(R + i * R_stride, v + i * v_stride, vo + i * vo_stride);
  }
}

static KSL_INLINED void ksl_product_drv_accurate_planes(ptrdiff_t n, const double *R,
    ptrdiff_t R_plane, ptrdiff_t R_stride, const double *v, ptrdiff_t v_plane,
    ptrdiff_t v_stride, double *vo, ptrdiff_t vo_plane, ptrdiff_t vo_stride) {
  ksl_mat3x3_t R_i;
  if (n > 0) R_i = ksl_mat3x3_of_planes(R, R_plane);
  KSL_EACH_OF(n) {
    if (R_stride) R_i = ksl_mat3x3_of_planes(R + i * R_stride, R_plane);
    const ksl_vec3_t v_i = ksl_vec3_of_planes(v + i * v_stride, v_plane);
    ksl_vec3_t vo_i;
    ksl_product_drv_accurate(&R_i, &v_i, &vo_i);
    ksl_vec3_to_planes(&vo_i, vo + i * vo_stride, vo_plane);
  }
}

/* ksl_product_drvinv_accurate of n elements. */
static KSL_INLINED void ksl_product_drvinv_accurate_many(ptrdiff_t n, const ksl_mat3x3_t *R,
    ptrdiff_t R_stride, const ksl_vec3_t *v, ptrdiff_t v_stride, ksl_vec3_t *vo,
    ptrdiff_t vo_stride) {
  KSL_EACH_OF(n) {
    ksl_product_drvinv_accurate(R + i * R_stride, v + i * v_stride, vo + i * vo_stride);
  }
}

static KSL_INLINED void ksl_product_drvinv_accurate_planes(ptrdiff_t n, const double *R,
    ptrdiff_t R_plane, ptrdiff_t R_stride, const double *v, ptrdiff_t v_plane,
    ptrdiff_t v_stride, double *vo, ptrdiff_t vo_plane, ptrdiff_t vo_stride) {
  ksl_mat3x3_t R_i;
  if (n > 0) R_i = ksl_mat3x3_of_planes(R, R_plane);
  KSL_EACH_OF(n) {
    if (R_stride) R_i = ksl_mat3x3_of_planes(R + i * R_stride, R_plane);
    const ksl_vec3_t v_i = ksl_vec3_of_planes(v + i * v_stride, v_plane);
    ksl_vec3_t vo_i;
    ksl_product_drvinv_accurate(&R_i, &v_i, &vo_i);
    ksl_vec3_to_planes(&vo_i, vo + i * vo_stride, vo_plane);
  }
}

/* ksl_product_drinvv_accurate of n elements. */
static KSL_INLINED void ksl_product_drinvv_accurate_many(ptrdiff_t n, const ksl_mat3x3_t *R,
    ptrdiff_t R_stride, const ksl_vec3_t *v, ptrdiff_t v_stride, ksl_vec3_t *vo,
    ptrdiff_t vo_stride) {
  KSL_EACH_OF(n) {
    ksl_product_drinvv_accurate(R + i * R_stride, v + i * v_stride, vo + i * vo_stride);
  }
}

static KSL_INLINED void ksl_product_drinvv_accurate_planes(ptrdiff_t n, const double *R,
    ptrdiff_t R_plane, ptrdiff_t R_stride, const double *v, ptrdiff_t v_plane,
    ptrdiff_t v_stride, double *vo, ptrdiff_t vo_plane, ptrdiff_t vo_stride) {
  ksl_mat3x3_t R_i;
  if (n > 0) R_i = ksl_mat3x3_of_planes(R, R_plane);
  KSL_EACH_OF(n) {
    if (R_stride) R_i = ksl_mat3x3_of_planes(R + i * R_stride, R_plane);
    const ksl_vec3_t v_i = ksl_vec3_of_planes(v + i * v_stride, v_plane);
    ksl_vec3_t vo_i;
    ksl_product_drinvv_accurate(&R_i, &v_i, &vo_i);
    ksl_vec3_to_planes(&vo_i, vo + i * vo_stride, vo_plane);
  }
}

/* ksl_product_drinvvinv_accurate of n elements. */
static KSL_INLINED void ksl_product_drinvvinv_accurate_many(ptrdiff_t n, const ksl_mat3x3_t *R,
    ptrdiff_t R_stride, const ksl_vec3_t *v, ptrdiff_t v_stride, ksl_vec3_t *vo,
    ptrdiff_t vo_stride) {
  KSL_EACH_OF(n) {
    ksl_product_drinvvinv_accurate(R + i * R_stride, v + i * v_stride, vo + i * vo_stride);
  }
}

static KSL_INLINED void ksl_product_drinvvinv_accurate_planes(ptrdiff_t n, const double *R,
    ptrdiff_t R_plane, ptrdiff_t R_stride, const double *v, ptrdiff_t v_plane,
    ptrdiff_t v_stride, double *vo, ptrdiff_t vo_plane, ptrdiff_t vo_stride) {
  ksl_mat3x3_t R_i;
  if (n > 0) R_i = ksl_mat3x3_of_planes(R, R_plane);
  KSL_EACH_OF(n) {
    if (R_stride) R_i = ksl_mat3x3_of_planes(R + i * R_stride, R_plane);
    const ksl_vec3_t v_i = ksl_vec3_of_planes(v + i * v_stride, v_plane);
    ksl_vec3_t vo_i;
    ksl_product_drinvvinv_accurate(&R_i, &v_i, &vo_i);
    ksl_vec3_to_planes(&vo_i, vo + i * vo_stride, vo_plane);
  }
}

/* ksl_product_dv_accurate of n elements. */
static KSL_INLINED void ksl_product_dv_accurate_many(ptrdiff_t n, const ksl_SE3_t *D,
    ptrdiff_t D_stride, const ksl_vec3_t *v, ptrdiff_t v_stride, ksl_vec3_t *vo,
    ptrdiff_t vo_stride) {
  KSL_EACH_OF(n) {
    ksl_product_dv_accurate(D + i * D_stride, v + i * v_stride, vo + i * vo_stride);
  }
}

static KSL_INLINED void ksl_product_dv_accurate_planes(ptrdiff_t n, const double *D,
    ptrdiff_t D_plane, ptrdiff_t D_stride, const double *v, ptrdiff_t v_plane,
    ptrdiff_t v_stride, double *vo, ptrdiff_t vo_plane, ptrdiff_t vo_stride) {
  ksl_SE3_t D_i;
  if (n > 0) D_i = ksl_SE3_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3_of_planes(D + i * D_stride, D_plane);
    const ksl_vec3_t v_i = ksl_vec3_of_planes(v + i * v_stride, v_plane);
    ksl_vec3_t vo_i;
    ksl_product_dv_accurate(&D_i, &v_i, &vo_i);
    ksl_vec3_to_planes(&vo_i, vo + i * vo_stride, vo_plane);
  }
}

/* ksl_product_dinvv_accurate of n elements. */
static KSL_INLINED void ksl_product_dinvv_accurate_many(ptrdiff_t n, const ksl_SE3_t *D,
    ptrdiff_t D_stride, const ksl_vec3_t *v, ptrdiff_t v_stride, ksl_vec3_t *vo,
    ptrdiff_t vo_stride) {
  KSL_EACH_OF(n) {
    ksl_product_dinvv_accurate(D + i * D_stride, v + i * v_stride, vo + i * vo_stride);
  }
}

static KSL_INLINED void ksl_product_dinvv_accurate_planes(ptrdiff_t n, const double *D,
    ptrdiff_t D_plane, ptrdiff_t D_stride, const double *v, ptrdiff_t v_plane,
    ptrdiff_t v_stride, double *vo, ptrdiff_t vo_plane, ptrdiff_t vo_stride) {
  ksl_SE3_t D_i;
  if (n > 0) D_i = ksl_SE3_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3_of_planes(D + i * D_stride, D_plane);
    const ksl_vec3_t v_i = ksl_vec3_of_planes(v + i * v_stride, v_plane);
    ksl_vec3_t vo_i;
    ksl_product_dinvv_accurate(&D_i, &v_i, &vo_i);
    ksl_vec3_to_planes(&vo_i, vo + i * vo_stride, vo_plane);
  }
}

/* ksl_product_drdr_accurate of n elements. */
static KSL_INLINED void ksl_product_drdr_accurate_many(ptrdiff_t n, const ksl_mat3x3_t *R1,
    ptrdiff_t R1_stride, const ksl_mat3x3_t *R2, ptrdiff_t R2_stride,
    ksl_mat3x3_t *Ro, ptrdiff_t Ro_stride) {
  KSL_EACH_OF(n) {
    ksl_product_drdr_accurate(R1 + i * R1_stride, R2 + i * R2_stride, Ro + i * Ro_stride);
  }
}

static KSL_INLINED void ksl_product_drdr_accurate_planes(ptrdiff_t n, const double *R1,
    ptrdiff_t R1_plane, ptrdiff_t R1_stride, const double *R2,
    ptrdiff_t R2_plane, ptrdiff_t R2_stride, double *Ro, ptrdiff_t Ro_plane,
    ptrdiff_t Ro_stride) {
  ksl_mat3x3_t R1_i;
  if (n > 0) R1_i = ksl_mat3x3_of_planes(R1, R1_plane);
  KSL_EACH_OF(n) {
    if (R1_stride) R1_i = ksl_mat3x3_of_planes(R1 + i * R1_stride, R1_plane);
    const ksl_mat3x3_t R2_i = ksl_mat3x3_of_planes(R2 + i * R2_stride, R2_plane);
    ksl_mat3x3_t Ro_i;
    ksl_product_drdr_accurate(&R1_i, &R2_i, &Ro_i);
    ksl_mat3x3_to_planes(&Ro_i, Ro + i * Ro_stride, Ro_plane);
  }
}

/* ksl_product_drdrinv_accurate of n elements. */
static KSL_INLINED void ksl_product_drdrinv_accurate_many(ptrdiff_t n, const ksl_mat3x3_t *R1,
    ptrdiff_t R1_stride, const ksl_mat3x3_t *R2, ptrdiff_t R2_stride,
    ksl_mat3x3_t *Ro, ptrdiff_t Ro_stride) {
  KSL_EACH_OF(n) {
    ksl_product_drdrinv_accurate(R1 + i * R1_stride, R2 + i * R2_stride, Ro + i * Ro_stride);
  }
}

static KSL_INLINED void ksl_product_drdrinv_accurate_planes(ptrdiff_t n, const double *R1,
    ptrdiff_t R1_plane, ptrdiff_t R1_stride, const double *R2,
    ptrdiff_t R2_plane, ptrdiff_t R2_stride, double *Ro, ptrdiff_t Ro_plane,
    ptrdiff_t Ro_stride) {
  ksl_mat3x3_t R1_i;
  if (n > 0) R1_i = ksl_mat3x3_of_planes(R1, R1_plane);
  KSL_EACH_OF(n) {
    if (R1_stride) R1_i = ksl_mat3x3_of_planes(R1 + i * R1_stride, R1_plane);
    const ksl_mat3x3_t R2_i = ksl_mat3x3_of_planes(R2 + i * R2_stride, R2_plane);
    ksl_mat3x3_t Ro_i;
    ksl_product_drdrinv_accurate(&R1_i, &R2_i, &Ro_i);
    ksl_mat3x3_to_planes(&Ro_i, Ro + i * Ro_stride, Ro_plane);
  }
}

/* ksl_product_drinvdr_accurate of n elements. */
static KSL_INLINED void ksl_product_drinvdr_accurate_many(ptrdiff_t n, const ksl_mat3x3_t *R1,
    ptrdiff_t R1_stride, const ksl_mat3x3_t *R2, ptrdiff_t R2_stride,
    ksl_mat3x3_t *Ro, ptrdiff_t Ro_stride) {
  KSL_EACH_OF(n) {
    ksl_product_drinvdr_accurate(R1 + i * R1_stride, R2 + i * R2_stride, Ro + i * Ro_stride);
  }
}

static KSL_INLINED void ksl_product_drinvdr_accurate_planes(ptrdiff_t n, const double *R1,
    ptrdiff_t R1_plane, ptrdiff_t R1_stride, const double *R2,
    ptrdiff_t R2_plane, ptrdiff_t R2_stride, double *Ro, ptrdiff_t Ro_plane,
    ptrdiff_t Ro_stride) {
  ksl_mat3x3_t R1_i;
  if (n > 0) R1_i = ksl_mat3x3_of_planes(R1, R1_plane);
  KSL_EACH_OF(n) {
    if (R1_stride) R1_i = ksl_mat3x3_of_planes(R1 + i * R1_stride, R1_plane);
    const ksl_mat3x3_t R2_i = ksl_mat3x3_of_planes(R2 + i * R2_stride, R2_plane);
    ksl_mat3x3_t Ro_i;
    ksl_product_drinvdr_accurate(&R1_i, &R2_i, &Ro_i);
    ksl_mat3x3_to_planes(&Ro_i, Ro + i * Ro_stride, Ro_plane);
  }
}

/* ksl_product_dd_accurate of n elements. */
static KSL_INLINED void ksl_product_dd_accurate_many(ptrdiff_t n, const ksl_SE3_t *D1,
    ptrdiff_t D1_stride, const ksl_SE3_t *D2, ptrdiff_t D2_stride, ksl_SE3_t *Do,
    ptrdiff_t Do_stride) {
  KSL_EACH_OF(n) {
    ksl_product_dd_accurate(D1 + i * D1_stride, D2 + i * D2_stride, Do + i * Do_stride);
  }
}

static KSL_INLINED void ksl_product_dd_accurate_planes(ptrdiff_t n, const double *D1,
    ptrdiff_t D1_plane, ptrdiff_t D1_stride, const double *D2,
    ptrdiff_t D2_plane, ptrdiff_t D2_stride, double *Do, ptrdiff_t Do_plane,
    ptrdiff_t Do_stride) {
  ksl_SE3_t D1_i;
  if (n > 0) D1_i = ksl_SE3_of_planes(D1, D1_plane);
  KSL_EACH_OF(n) {
    if (D1_stride) D1_i = ksl_SE3_of_planes(D1 + i * D1_stride, D1_plane);
    const ksl_SE3_t D2_i = ksl_SE3_of_planes(D2 + i * D2_stride, D2_plane);
    ksl_SE3_t Do_i;
    ksl_product_dd_accurate(&D1_i, &D2_i, &Do_i);
    ksl_SE3_to_planes(&Do_i, Do + i * Do_stride, Do_plane);
  }
}

/* ksl_product_ddinv_accurate of n elements. */
static KSL_INLINED void ksl_product_ddinv_accurate_many(ptrdiff_t n, const ksl_SE3_t *D1,
    ptrdiff_t D1_stride, const ksl_SE3_t *D2, ptrdiff_t D2_stride, ksl_SE3_t *Do,
    ptrdiff_t Do_stride) {
  KSL_EACH_OF(n) {
    ksl_product_ddinv_accurate(D1 + i * D1_stride, D2 + i * D2_stride, Do + i * Do_stride);
  }
}

static KSL_INLINED void ksl_product_ddinv_accurate_planes(ptrdiff_t n, const double *D1,
    ptrdiff_t D1_plane, ptrdiff_t D1_stride, const double *D2,
    ptrdiff_t D2_plane, ptrdiff_t D2_stride, double *Do, ptrdiff_t Do_plane,
    ptrdiff_t Do_stride) {
  ksl_SE3_t D1_i;
  if (n > 0) D1_i = ksl_SE3_of_planes(D1, D1_plane);
  KSL_EACH_OF(n) {
    if (D1_stride) D1_i = ksl_SE3_of_planes(D1 + i * D1_stride, D1_plane);
    const ksl_SE3_t D2_i = ksl_SE3_of_planes(D2 + i * D2_stride, D2_plane);
    ksl_SE3_t Do_i;
    ksl_product_ddinv_accurate(&D1_i, &D2_i, &Do_i);
    ksl_SE3_to_planes(&Do_i, Do + i * Do_stride, Do_plane);
  }
}

/* ksl_product_dinvd_accurate of n elements. */
static KSL_INLINED void ksl_product_dinvd_accurate_many(ptrdiff_t n, const ksl_SE3_t *D1,
    ptrdiff_t D1_stride, const ksl_SE3_t *D2, ptrdiff_t D2_stride, ksl_SE3_t *Do,
    ptrdiff_t Do_stride) {
  KSL_EACH_OF(n) {
    ksl_product_dinvd_accurate(D1 + i * D1_stride, D2 + i * D2_stride, Do + i * Do_stride);
  }
}

static KSL_INLINED void ksl_product_dinvd_accurate_planes(ptrdiff_t n, const double *D1,
    ptrdiff_t D1_plane, ptrdiff_t D1_stride, const double *D2,
    ptrdiff_t D2_plane, ptrdiff_t D2_stride, double *Do, ptrdiff_t Do_plane,
    ptrdiff_t Do_stride) {
  ksl_SE3_t D1_i;
  if (n > 0) D1_i = ksl_SE3_of_planes(D1, D1_plane);
  KSL_EACH_OF(n) {
    if (D1_stride) D1_i = ksl_SE3_of_planes(D1 + i * D1_stride, D1_plane);
    const ksl_SE3_t D2_i = ksl_SE3_of_planes(D2 + i * D2_stride, D2_plane);
    ksl_SE3_t Do_i;
    ksl_product_dinvd_accurate(&D1_i, &D2_i, &Do_i);
    ksl_SE3_to_planes(&Do_i, Do + i * Do_stride, Do_plane);
  }
}

/* ksl_product_ddr_accurate of n elements. */
static KSL_INLINED void ksl_product_ddr_accurate_many(ptrdiff_t n, const ksl_SE3_t *D,
    ptrdiff_t D_stride, const ksl_mat3x3_t *R, ptrdiff_t R_stride, ksl_SE3_t *Do,
    ptrdiff_t Do_stride) {
  KSL_EACH_OF(n) {
    ksl_product_ddr_accurate(D + i * D_stride, R + i * R_stride, Do + i * Do_stride);
  }
}

static KSL_INLINED void ksl_product_ddr_accurate_planes(ptrdiff_t n, const double *D,
    ptrdiff_t D_plane, ptrdiff_t D_stride, const double *R, ptrdiff_t R_plane,
    ptrdiff_t R_stride, double *Do, ptrdiff_t Do_plane, ptrdiff_t Do_stride) {
  ksl_SE3_t D_i;
  if (n > 0) D_i = ksl_SE3_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3_of_planes(D + i * D_stride, D_plane);
    const ksl_mat3x3_t R_i = ksl_mat3x3_of_planes(R + i * R_stride, R_plane);
    ksl_SE3_t Do_i;
    ksl_product_ddr_accurate(&D_i, &R_i, &Do_i);
    ksl_SE3_to_planes(&Do_i, Do + i * Do_stride, Do_plane);
  }
}

/* ksl_product_ddrinv_accurate of n elements. */
static KSL_INLINED void ksl_product_ddrinv_accurate_many(ptrdiff_t n, const ksl_SE3_t *D,
    ptrdiff_t D_stride, const ksl_mat3x3_t *R, ptrdiff_t R_stride, ksl_SE3_t *Do,
    ptrdiff_t Do_stride) {
  KSL_EACH_OF(n) {
    ksl_product_ddrinv_accurate(D + i * D_stride, R + i * R_stride, Do + i * Do_stride);
  }
}

static KSL_INLINED void ksl_product_ddrinv_accurate_planes(ptrdiff_t n, const double *D,
    ptrdiff_t D_plane, ptrdiff_t D_stride, const double *R, ptrdiff_t R_plane,
    ptrdiff_t R_stride, double *Do, ptrdiff_t Do_plane, ptrdiff_t Do_stride) {
  ksl_SE3_t D_i;
  if (n > 0) D_i = ksl_SE3_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3_of_planes(D + i * D_stride, D_plane);
    const ksl_mat3x3_t R_i = ksl_mat3x3_of_planes(R + i * R_stride, R_plane);
    ksl_SE3_t Do_i;
    ksl_product_ddrinv_accurate(&D_i, &R_i, &Do_i);
    ksl_SE3_to_planes(&Do_i, Do + i * Do_stride, Do_plane);
  }
}

/* ksl_product_ddt_accurate of n elements. */
static KSL_INLINED void ksl_product_ddt_accurate_many(ptrdiff_t n, const ksl_SE3_t *D,
    ptrdiff_t D_stride, const ksl_vec3_t *t, ptrdiff_t t_stride, ksl_SE3_t *Do,
    ptrdiff_t Do_stride) {
  KSL_EACH_OF(n) {
    ksl_product_ddt_accurate(D + i * D_stride, t + i * t_stride, Do + i * Do_stride);
  }
}

static KSL_INLINED void ksl_product_ddt_accurate_planes(ptrdiff_t n, const double *D,
    ptrdiff_t D_plane, ptrdiff_t D_stride, const double *t, ptrdiff_t t_plane,
    ptrdiff_t t_stride, double *Do, ptrdiff_t Do_plane, ptrdiff_t Do_stride) {
  ksl_SE3_t D_i;
  if (n > 0) D_i = ksl_SE3_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3_of_planes(D + i * D_stride, D_plane);
    const ksl_vec3_t t_i = ksl_vec3_of_planes(t + i * t_stride, t_plane);
    ksl_SE3_t Do_i;
    ksl_product_ddt_accurate(&D_i, &t_i, &Do_i);
    ksl_SE3_to_planes(&Do_i, Do + i * Do_stride, Do_plane);
  }
}

/* ksl_product_ddtinv_accurate of n elements. */
static KSL_INLINED void ksl_product_ddtinv_accurate_many(ptrdiff_t n, const ksl_SE3_t *D,
    ptrdiff_t D_stride, const ksl_vec3_t *t, ptrdiff_t t_stride, ksl_SE3_t *Do,
    ptrdiff_t Do_stride) {
  KSL_EACH_OF(n) {
    ksl_product_ddtinv_accurate(D + i * D_stride, t + i * t_stride, Do + i * Do_stride);
  }
}

static KSL_INLINED void ksl_product_ddtinv_accurate_planes(ptrdiff_t n, const double *D,
    ptrdiff_t D_plane, ptrdiff_t D_stride, const double *t, ptrdiff_t t_plane,
    ptrdiff_t t_stride, double *Do, ptrdiff_t Do_plane, ptrdiff_t Do_stride) {
  ksl_SE3_t D_i;
  if (n > 0) D_i = ksl_SE3_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3_of_planes(D + i * D_stride, D_plane);
    const ksl_vec3_t t_i = ksl_vec3_of_planes(t + i * t_stride, t_plane);
    ksl_SE3_t Do_i;
    ksl_product_ddtinv_accurate(&D_i, &t_i, &Do_i);
    ksl_SE3_to_planes(&Do_i, Do + i * Do_stride, Do_plane);
  }
}

/* ksl_product_dinvdt_accurate of n elements. */
static KSL_INLINED void ksl_product_dinvdt_accurate_many(ptrdiff_t n, const ksl_SE3_t *D,
    ptrdiff_t D_stride, const ksl_vec3_t *t, ptrdiff_t t_stride, ksl_SE3_t *Do,
    ptrdiff_t Do_stride) {
  KSL_EACH_OF(n) {
    ksl_product_dinvdt_accurate(D + i * D_stride, t + i * t_stride, Do + i * Do_stride);
  }
}

static KSL_INLINED void ksl_product_dinvdt_accurate_planes(ptrdiff_t n, const double *D,
    ptrdiff_t D_plane, ptrdiff_t D_stride, const double *t, ptrdiff_t t_plane,
    ptrdiff_t t_stride, double *Do, ptrdiff_t Do_plane, ptrdiff_t Do_stride) {
  ksl_SE3_t D_i;
  if (n > 0) D_i = ksl_SE3_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3_of_planes(D + i * D_stride, D_plane);
    const ksl_vec3_t t_i = ksl_vec3_of_planes(t + i * t_stride, t_plane);
    ksl_SE3_t Do_i;
    ksl_product_dinvdt_accurate(&D_i, &t_i, &Do_i);
    ksl_SE3_to_planes(&Do_i, Do + i * Do_stride, Do_plane);
  }
}

/* ksl_product_drvtx_accurate of n elements. */
static KSL_INLINED void ksl_product_drvtx_accurate_many(ptrdiff_t n, const ksl_mat3x3_t *R,
    ptrdiff_t R_stride, const double *k, ptrdiff_t k_stride, ksl_vec3_t *vo,
    ptrdiff_t vo_stride) {
  KSL_EACH_OF(n) {
    ksl_product_drvtx_accurate(R + i * R_stride, k[i * k_stride], vo + i * vo_stride);
  }
}

static KSL_INLINED void ksl_product_drvtx_accurate_planes(ptrdiff_t n, const double *R,
    ptrdiff_t R_plane, ptrdiff_t R_stride, const double *k, ptrdiff_t k_stride,
    double *vo, ptrdiff_t vo_plane, ptrdiff_t vo_stride) {
  ksl_mat3x3_t R_i;
  if (n > 0) R_i = ksl_mat3x3_of_planes(R, R_plane);
  KSL_EACH_OF(n) {
    if (R_stride) R_i = ksl_mat3x3_of_planes(R + i * R_stride, R_plane);
    ksl_vec3_t vo_i;
    ksl_product_drvtx_accurate(&R_i, k[i * k_stride], &vo_i);
    ksl_vec3_to_planes(&vo_i, vo + i * vo_stride, vo_plane);
  }
}

/* ksl_product_drdrx_accurate of n elements. */
static KSL_INLINED void ksl_product_drdrx_accurate_many(ptrdiff_t n, const ksl_mat3x3_t *R,
    ptrdiff_t R_stride, const double *dc, ptrdiff_t dc_stride, ksl_mat3x3_t *Ro,
    ptrdiff_t Ro_stride) {
  KSL_EACH_OF(n) {
    ksl_product_drdrx_accurate(R + i * R_stride, dc + 2 * i * dc_stride, Ro + i * Ro_stride);
  }
}

static KSL_INLINED void ksl_product_drdrx_accurate_planes(ptrdiff_t n, const double *R,
    ptrdiff_t R_plane, ptrdiff_t R_stride, const double *dc, ptrdiff_t dc_plane,
    ptrdiff_t dc_stride, double *Ro, ptrdiff_t Ro_plane, ptrdiff_t Ro_stride) {
  ksl_mat3x3_t R_i;
  if (n > 0) R_i = ksl_mat3x3_of_planes(R, R_plane);
  KSL_EACH_OF(n) {
    if (R_stride) R_i = ksl_mat3x3_of_planes(R + i * R_stride, R_plane);
    const double dc_i[2] = {dc[0 + i * dc_stride], dc[dc_plane + i * dc_stride]};
    ksl_mat3x3_t Ro_i;
    ksl_product_drdrx_accurate(&R_i, dc_i, &Ro_i);
    ksl_mat3x3_to_planes(&Ro_i, Ro + i * Ro_stride, Ro_plane);
  }
}

/* ksl_product_ddrx_accurate of n elements. */
static KSL_INLINED void ksl_product_ddrx_accurate_many(ptrdiff_t n, const ksl_SE3_t *D,
    ptrdiff_t D_stride, const double *dc, ptrdiff_t dc_stride, ksl_SE3_t *Do,
    ptrdiff_t Do_stride) {
  KSL_EACH_OF(n) {
    ksl_product_ddrx_accurate(D + i * D_stride, dc + 2 * i * dc_stride, Do + i * Do_stride);
  }
}

static KSL_INLINED void ksl_product_ddrx_accurate_planes(ptrdiff_t n, const double *D,
    ptrdiff_t D_plane, ptrdiff_t D_stride, const double *dc, ptrdiff_t dc_plane,
    ptrdiff_t dc_stride, double *Do, ptrdiff_t Do_plane, ptrdiff_t Do_stride) {
  ksl_SE3_t D_i;
  if (n > 0) D_i = ksl_SE3_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3_of_planes(D + i * D_stride, D_plane);
    const double dc_i[2] = {dc[0 + i * dc_stride], dc[dc_plane + i * dc_stride]};
    ksl_SE3_t Do_i;
    ksl_product_ddrx_accurate(&D_i, dc_i, &Do_i);
    ksl_SE3_to_planes(&Do_i, Do + i * Do_stride, Do_plane);
  }
}

/* ksl_product_ddtx_accurate of n elements. */
static KSL_INLINED void ksl_product_ddtx_accurate_many(ptrdiff_t n, const ksl_SE3_t *D,
    ptrdiff_t D_stride, const double *k, ptrdiff_t k_stride, ksl_SE3_t *Do,
    ptrdiff_t Do_stride) {
  KSL_EACH_OF(n) {
    ksl_product_ddtx_accurate(D + i * D_stride, k[i * k_stride], Do + i * Do_stride);
  }
}

static KSL_INLINED void ksl_product_ddtx_accurate_planes(ptrdiff_t n, const double *D,
    ptrdiff_t D_plane, ptrdiff_t D_stride, const double *k, ptrdiff_t k_stride,
    double *Do, ptrdiff_t Do_plane, ptrdiff_t Do_stride) {
  ksl_SE3_t D_i;
  if (n > 0) D_i = ksl_SE3_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3_of_planes(D + i * D_stride, D_plane);
    ksl_SE3_t Do_i;
    ksl_product_ddtx_accurate(&D_i, k[i * k_stride], &Do_i);
    ksl_SE3_to_planes(&Do_i, Do + i * Do_stride, Do_plane);
  }
}

/* ksl_product_drvtxinv_accurate of n elements. */
static KSL_INLINED void ksl_product_drvtxinv_accurate_many(ptrdiff_t n, const ksl_mat3x3_t *R,
    ptrdiff_t R_stride, const double *k, ptrdiff_t k_stride, ksl_vec3_t *vo,
    ptrdiff_t vo_stride) {
  KSL_EACH_OF(n) {
    ksl_product_drvtxinv_accurate(R + i * R_stride, k[i * k_stride], vo + i * vo_stride);
  }
}

static KSL_INLINED void ksl_product_drvtxinv_accurate_planes(ptrdiff_t n, const double *R,
    ptrdiff_t R_plane, ptrdiff_t R_stride, const double *k, ptrdiff_t k_stride,
    double *vo, ptrdiff_t vo_plane, ptrdiff_t vo_stride) {
  ksl_mat3x3_t R_i;
  if (n > 0) R_i = ksl_mat3x3_of_planes(R, R_plane);
  KSL_EACH_OF(n) {
    if (R_stride) R_i = ksl_mat3x3_of_planes(R + i * R_stride, R_plane);
    ksl_vec3_t vo_i;
    ksl_product_drvtxinv_accurate(&R_i, k[i * k_stride], &vo_i);
    ksl_vec3_to_planes(&vo_i, vo + i * vo_stride, vo_plane);
  }
}

/* ksl_product_drdrxinv_accurate of n elements. */
static KSL_INLINED void ksl_product_drdrxinv_accurate_many(ptrdiff_t n, const ksl_mat3x3_t *R,
    ptrdiff_t R_stride, const double *dc, ptrdiff_t dc_stride, ksl_mat3x3_t *Ro,
    ptrdiff_t Ro_stride) {
  KSL_EACH_OF(n) {
    ksl_product_drdrxinv_accurate(R + i * R_stride, dc + 2 * i * dc_stride, Ro + i * Ro_stride);
  }
}

static KSL_INLINED void ksl_product_drdrxinv_accurate_planes(ptrdiff_t n, const double *R,
    ptrdiff_t R_plane, ptrdiff_t R_stride, const double *dc, ptrdiff_t dc_plane,
    ptrdiff_t dc_stride, double *Ro, ptrdiff_t Ro_plane, ptrdiff_t Ro_stride) {
  ksl_mat3x3_t R_i;
  if (n > 0) R_i = ksl_mat3x3_of_planes(R, R_plane);
  KSL_EACH_OF(n) {
    if (R_stride) R_i = ksl_mat3x3_of_planes(R + i * R_stride, R_plane);
    const double dc_i[2] = {dc[0 + i * dc_stride], dc[dc_plane + i * dc_stride]};
    ksl_mat3x3_t Ro_i;
    ksl_product_drdrxinv_accurate(&R_i, dc_i, &Ro_i);
    ksl_mat3x3_to_planes(&Ro_i, Ro + i * Ro_stride, Ro_plane);
  }
}

/* ksl_product_ddrxinv_accurate of n elements. */
static KSL_INLINED void ksl_product_ddrxinv_accurate_many(ptrdiff_t n, const ksl_SE3_t *D,
    ptrdiff_t D_stride, const double *dc, ptrdiff_t dc_stride, ksl_SE3_t *Do,
    ptrdiff_t Do_stride) {
  KSL_EACH_OF(n) {
    ksl_product_ddrxinv_accurate(D + i * D_stride, dc + 2 * i * dc_stride, Do + i * Do_stride);
  }
}

static KSL_INLINED void ksl_product_ddrxinv_accurate_planes(ptrdiff_t n, const double *D,
    ptrdiff_t D_plane, ptrdiff_t D_stride, const double *dc, ptrdiff_t dc_plane,
    ptrdiff_t dc_stride, double *Do, ptrdiff_t Do_plane, ptrdiff_t Do_stride) {
  ksl_SE3_t D_i;
  if (n > 0) D_i = ksl_SE3_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3_of_planes(D + i * D_stride, D_plane);
    const double dc_i[2] = {dc[0 + i * dc_stride], dc[dc_plane + i * dc_stride]};
    ksl_SE3_t Do_i;
    ksl_product_ddrxinv_accurate(&D_i, dc_i, &Do_i);
    ksl_SE3_to_planes(&Do_i, Do + i * Do_stride, Do_plane);
  }
}

/* ksl_product_ddtxinv_accurate of n elements. */
static KSL_INLINED void ksl_product_ddtxinv_accurate_many(ptrdiff_t n, const ksl_SE3_t *D,
    ptrdiff_t D_stride, const double *k, ptrdiff_t k_stride, ksl_SE3_t *Do,
    ptrdiff_t Do_stride) {
  KSL_EACH_OF(n) {
    ksl_product_ddtxinv_accurate(D + i * D_stride, k[i * k_stride], Do + i * Do_stride);
  }
}

static KSL_INLINED void ksl_product_ddtxinv_accurate_planes(ptrdiff_t n, const double *D,
    ptrdiff_t D_plane, ptrdiff_t D_stride, const double *k, ptrdiff_t k_stride,
    double *Do, ptrdiff_t Do_plane, ptrdiff_t Do_stride) {
  ksl_SE3_t D_i;
  if (n > 0) D_i = ksl_SE3_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3_of_planes(D + i * D_stride, D_plane);
    ksl_SE3_t Do_i;
    ksl_product_ddtxinv_accurate(&D_i, k[i * k_stride], &Do_i);
    ksl_SE3_to_planes(&Do_i, Do + i * Do_stride, Do_plane);
  }
}

/* ksl_product_drvty_accurate of n elements. */
static KSL_INLINED void ksl_product_drvty_accurate_many(ptrdiff_t n, const ksl_mat3x3_t *R,
    ptrdiff_t R_stride, const double *k, ptrdiff_t k_stride, ksl_vec3_t *vo,
    ptrdiff_t vo_stride) {
  KSL_EACH_OF(n) {
    ksl_product_drvty_accurate(R + i * R_stride, k[i * k_stride], vo + i * vo_stride);
  }
}

static KSL_INLINED void ksl_product_drvty_accurate_planes(ptrdiff_t n, const double *R,
    ptrdiff_t R_plane, ptrdiff_t R_stride, const double *k, ptrdiff_t k_stride,
    double *vo, ptrdiff_t vo_plane, ptrdiff_t vo_stride) {
  ksl_mat3x3_t R_i;
  if (n > 0) R_i = ksl_mat3x3_of_planes(R, R_plane);
  KSL_EACH_OF(n) {
    if (R_stride) R_i = ksl_mat3x3_of_planes(R + i * R_stride, R_plane);
    ksl_vec3_t vo_i;
    ksl_product_drvty_accurate(&R_i, k[i * k_stride], &vo_i);
    ksl_vec3_to_planes(&vo_i, vo + i * vo_stride, vo_plane);
  }
}

/* ksl_product_drdry_accurate of n elements. */
static KSL_INLINED void ksl_product_drdry_accurate_many(ptrdiff_t n, const ksl_mat3x3_t *R,
    ptrdiff_t R_stride, const double *dc, ptrdiff_t dc_stride, ksl_mat3x3_t *Ro,
    ptrdiff_t Ro_stride) {
  KSL_EACH_OF(n) {
    ksl_product_drdry_accurate(R + i * R_stride, dc + 2 * i * dc_stride, Ro + i * Ro_stride);
  }
}

static KSL_INLINED void ksl_product_drdry_accurate_planes(ptrdiff_t n, const double *R,
    ptrdiff_t R_plane, ptrdiff_t R_stride, const double *dc, ptrdiff_t dc_plane,
    ptrdiff_t dc_stride, double *Ro, ptrdiff_t Ro_plane, ptrdiff_t Ro_stride) {
  ksl_mat3x3_t R_i;
  if (n > 0) R_i = ksl_mat3x3_of_planes(R, R_plane);
  KSL_EACH_OF(n) {
    if (R_stride) R_i = ksl_mat3x3_of_planes(R + i * R_stride, R_plane);
    const double dc_i[2] = {dc[0 + i * dc_stride], dc[dc_plane + i * dc_stride]};
    ksl_mat3x3_t Ro_i;
    ksl_product_drdry_accurate(&R_i, dc_i, &Ro_i);
    ksl_mat3x3_to_planes(&Ro_i, Ro + i * Ro_stride, Ro_plane);
  }
}

/* ksl_product_ddry_accurate of n elements. */
static KSL_INLINED void ksl_product_ddry_accurate_many(ptrdiff_t n, const ksl_SE3_t *D,
    ptrdiff_t D_stride, const double *dc, ptrdiff_t dc_stride, ksl_SE3_t *Do,
    ptrdiff_t Do_stride) {
  KSL_EACH_OF(n) {
    ksl_product_ddry_accurate(D + i * D_stride, dc + 2 * i * dc_stride, Do + i * Do_stride);
  }
}

static KSL_INLINED void ksl_product_ddry_accurate_planes(ptrdiff_t n, const double *D,
    ptrdiff_t D_plane, ptrdiff_t D_stride, const double *dc, ptrdiff_t dc_plane,
    ptrdiff_t dc_stride, double *Do, ptrdiff_t Do_plane, ptrdiff_t Do_stride) {
  ksl_SE3_t D_i;
  if (n > 0) D_i = ksl_SE3_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3_of_planes(D + i * D_stride, D_plane);
    const double dc_i[2] = {dc[0 + i * dc_stride], dc[dc_plane + i * dc_stride]};
    ksl_SE3_t Do_i;
    ksl_product_ddry_accurate(&D_i, dc_i, &Do_i);
    ksl_SE3_to_planes(&Do_i, Do + i * Do_stride, Do_plane);
  }
}

/* ksl_product_ddty_accurate of n elements. */
static KSL_INLINED void ksl_product_ddty_accurate_many(ptrdiff_t n, const ksl_SE3_t *D,
    ptrdiff_t D_stride, const double *k, ptrdiff_t k_stride, ksl_SE3_t *Do,
    ptrdiff_t Do_stride) {
  KSL_EACH_OF(n) {
    ksl_product_ddty_accurate(D + i * D_stride, k[i * k_stride], Do + i * Do_stride);
  }
}

static KSL_INLINED void ksl_product_ddty_accurate_planes(ptrdiff_t n, const double *D,
    ptrdiff_t D_plane, ptrdiff_t D_stride, const double *k, ptrdiff_t k_stride,
    double *Do, ptrdiff_t Do_plane, ptrdiff_t Do_stride) {
  ksl_SE3_t D_i;
  if (n > 0) D_i = ksl_SE3_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3_of_planes(D + i * D_stride, D_plane);
    ksl_SE3_t Do_i;
    ksl_product_ddty_accurate(&D_i, k[i * k_stride], &Do_i);
    ksl_SE3_to_planes(&Do_i, Do + i * Do_stride, Do_plane);
  }
}

/* ksl_product_drvtyinv_accurate of n elements. */
static KSL_INLINED void ksl_product_drvtyinv_accurate_many(ptrdiff_t n, const ksl_mat3x3_t *R,
    ptrdiff_t R_stride, const double *k, ptrdiff_t k_stride, ksl_vec3_t *vo,
    ptrdiff_t vo_stride) {
  KSL_EACH_OF(n) {
    ksl_product_drvtyinv_accurate(R + i * R_stride, k[i * k_stride], vo + i * vo_stride);
  }
}

static KSL_INLINED void ksl_product_drvtyinv_accurate_planes(ptrdiff_t n, const double *R,
    ptrdiff_t R_plane, ptrdiff_t R_stride, const double *k, ptrdiff_t k_stride,
    double *vo, ptrdiff_t vo_plane, ptrdiff_t vo_stride) {
  ksl_mat3x3_t R_i;
  if (n > 0) R_i = ksl_mat3x3_of_planes(R, R_plane);
  KSL_EACH_OF(n) {
    if (R_stride) R_i = ksl_mat3x3_of_planes(R + i * R_stride, R_plane);
    ksl_vec3_t vo_i;
    ksl_product_drvtyinv_accurate(&R_i, k[i * k_stride], &vo_i);
    ksl_vec3_to_planes(&vo_i, vo + i * vo_stride, vo_plane);
  }
}

/* ksl_product_drdryinv_accurate of n elements. */
static KSL_INLINED void ksl_product_drdryinv_accurate_many(ptrdiff_t n, const ksl_mat3x3_t *R,
    ptrdiff_t R_stride, const double *dc, ptrdiff_t dc_stride, ksl_mat3x3_t *Ro,
    ptrdiff_t Ro_stride) {
  KSL_EACH_OF(n) {
    ksl_product_drdryinv_accurate(R + i * R_stride, dc + 2 * i * dc_stride, Ro + i * Ro_stride);
  }
}

static KSL_INLINED void ksl_product_drdryinv_accurate_planes(ptrdiff_t n, const double *R,
    ptrdiff_t R_plane, ptrdiff_t R_stride, const double *dc, ptrdiff_t dc_plane,
    ptrdiff_t dc_stride, double *Ro, ptrdiff_t Ro_plane, ptrdiff_t Ro_stride) {
  ksl_mat3x3_t R_i;
  if (n > 0) R_i = ksl_mat3x3_of_planes(R, R_plane);
  KSL_EACH_OF(n) {
    if (R_stride) R_i = ksl_mat3x3_of_planes(R + i * R_stride, R_plane);
    const double dc_i[2] = {dc[0 + i * dc_stride], dc[dc_plane + i * dc_stride]};
    ksl_mat3x3_t Ro_i;
    ksl_product_drdryinv_accurate(&R_i, dc_i, &Ro_i);
    ksl_mat3x3_to_planes(&Ro_i, Ro + i * Ro_stride, Ro_plane);
  }
}

/* ksl_product_ddryinv_accurate of n elements. */
static KSL_INLINED void ksl_product_ddryinv_accurate_many(ptrdiff_t n, const ksl_SE3_t *D,
    ptrdiff_t D_stride, const double *dc, ptrdiff_t dc_stride, ksl_SE3_t *Do,
    ptrdiff_t Do_stride) {
  KSL_EACH_OF(n) {
    ksl_product_ddryinv_accurate(D + i * D_stride, dc + 2 * i * dc_stride, Do + i * Do_stride);
  }
}

static KSL_INLINED void ksl_product_ddryinv_accurate_planes(ptrdiff_t n, const double *D,
    ptrdiff_t D_plane, ptrdiff_t D_stride, const double *dc, ptrdiff_t dc_plane,
    ptrdiff_t dc_stride, double *Do, ptrdiff_t Do_plane, ptrdiff_t Do_stride) {
  ksl_SE3_t D_i;
  if (n > 0) D_i = ksl_SE3_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3_of_planes(D + i * D_stride, D_plane);
    const double dc_i[2] = {dc[0 + i * dc_stride], dc[dc_plane + i * dc_stride]};
    ksl_SE3_t Do_i;
    ksl_product_ddryinv_accurate(&D_i, dc_i, &Do_i);
    ksl_SE3_to_planes(&Do_i, Do + i * Do_stride, Do_plane);
  }
}

/* ksl_product_ddtyinv_accurate of n elements. */
static KSL_INLINED void ksl_product_ddtyinv_accurate_many(ptrdiff_t n, const ksl_SE3_t *D,
    ptrdiff_t D_stride, const double *k, ptrdiff_t k_stride, ksl_SE3_t *Do,
    ptrdiff_t Do_stride) {
  KSL_EACH_OF(n) {
    ksl_product_ddtyinv_accurate(D + i * D_stride, k[i * k_stride], Do + i * Do_stride);
  }
}

static KSL_INLINED void ksl_product_ddtyinv_accurate_planes(ptrdiff_t n, const double *D,
    ptrdiff_t D_plane, ptrdiff_t D_stride, const double *k, ptrdiff_t k_stride,
    double *Do, ptrdiff_t Do_plane, ptrdiff_t Do_stride) {
  ksl_SE3_t D_i;
  if (n > 0) D_i = ksl_SE3_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3_of_planes(D + i * D_stride, D_plane);
    ksl_SE3_t Do_i;
    ksl_product_ddtyinv_accurate(&D_i, k[i * k_stride], &Do_i);
    ksl_SE3_to_planes(&Do_i, Do + i * Do_stride, Do_plane);
  }
}

/* ksl_product_drvtz_accurate of n elements. */
static KSL_INLINED void ksl_product_drvtz_accurate_many(ptrdiff_t n, const ksl_mat3x3_t *R,
    ptrdiff_t R_stride, const double *k, ptrdiff_t k_stride, ksl_vec3_t *vo,
    ptrdiff_t vo_stride) {
  KSL_EACH_OF(n) {
    ksl_product_drvtz_accurate(R + i * R_stride, k[i * k_stride], vo + i * vo_stride);
  }
}

static KSL_INLINED void ksl_product_drvtz_accurate_planes(ptrdiff_t n, const double *R,
    ptrdiff_t R_plane, ptrdiff_t R_stride, const double *k, ptrdiff_t k_stride,
    double *vo, ptrdiff_t vo_plane, ptrdiff_t vo_stride) {
  ksl_mat3x3_t R_i;
  if (n > 0) R_i = ksl_mat3x3_of_planes(R, R_plane);
  KSL_EACH_OF(n) {
    if (R_stride) R_i = ksl_mat3x3_of_planes(R + i * R_stride, R_plane);
    ksl_vec3_t vo_i;
    ksl_product_drvtz_accurate(&R_i, k[i * k_stride], &vo_i);
    ksl_vec3_to_planes(&vo_i, vo + i * vo_stride, vo_plane);
  }
}

/* ksl_product_drdrz_accurate of n elements. */
static KSL_INLINED void ksl_product_drdrz_accurate_many(ptrdiff_t n, const ksl_mat3x3_t *R,
    ptrdiff_t R_stride, const double *dc, ptrdiff_t dc_stride, ksl_mat3x3_t *Ro,
    ptrdiff_t Ro_stride) {
  KSL_EACH_OF(n) {
    ksl_product_drdrz_accurate(R + i * R_stride, dc + 2 * i * dc_stride, Ro + i * Ro_stride);
  }
}

static KSL_INLINED void ksl_product_drdrz_accurate_planes(ptrdiff_t n, const double *R,
    ptrdiff_t R_plane, ptrdiff_t R_stride, const double *dc, ptrdiff_t dc_plane,
    ptrdiff_t dc_stride, double *Ro, ptrdiff_t Ro_plane, ptrdiff_t Ro_stride) {
  ksl_mat3x3_t R_i;
  if (n > 0) R_i = ksl_mat3x3_of_planes(R, R_plane);
  KSL_EACH_OF(n) {
    if (R_stride) R_i = ksl_mat3x3_of_planes(R + i * R_stride, R_plane);
    const double dc_i[2] = {dc[0 + i * dc_stride], dc[dc_plane + i * dc_stride]};
    ksl_mat3x3_t Ro_i;
    ksl_product_drdrz_accurate(&R_i, dc_i, &Ro_i);
    ksl_mat3x3_to_planes(&Ro_i, Ro + i * Ro_stride, Ro_plane);
  }
}

/* ksl_product_ddrz_accurate of n elements. */
static KSL_INLINED void ksl_product_ddrz_accurate_many(ptrdiff_t n, const ksl_SE3_t *D,
    ptrdiff_t D_stride, const double *dc, ptrdiff_t dc_stride, ksl_SE3_t *Do,
    ptrdiff_t Do_stride) {
  KSL_EACH_OF(n) {
    ksl_product_ddrz_accurate(D + i * D_stride, dc + 2 * i * dc_stride, Do + i * Do_stride);
  }
}

static KSL_INLINED void ksl_product_ddrz_accurate_planes(ptrdiff_t n, const double *D,
    ptrdiff_t D_plane, ptrdiff_t D_stride, const double *dc, ptrdiff_t dc_plane,
    ptrdiff_t dc_stride, double *Do, ptrdiff_t Do_plane, ptrdiff_t Do_stride) {
  ksl_SE3_t D_i;
  if (n > 0) D_i = ksl_SE3_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3_of_planes(D + i * D_stride, D_plane);
    const double dc_i[2] = {dc[0 + i * dc_stride], dc[dc_plane + i * dc_stride]};
    ksl_SE3_t Do_i;
    ksl_product_ddrz_accurate(&D_i, dc_i, &Do_i);
    ksl_SE3_to_planes(&Do_i, Do + i * Do_stride, Do_plane);
  }
}

/* ksl_product_ddtz_accurate of n elements. */
static KSL_INLINED void ksl_product_ddtz_accurate_many(ptrdiff_t n, const ksl_SE3_t *D,
    ptrdiff_t D_stride, const double *k, ptrdiff_t k_stride, ksl_SE3_t *Do,
    ptrdiff_t Do_stride) {
  KSL_EACH_OF(n) {
    ksl_product_ddtz_accurate(D + i * D_stride, k[i * k_stride], Do + i * Do_stride);
  }
}

static KSL_INLINED void ksl_product_ddtz_accurate_planes(ptrdiff_t n, const double *D,
    ptrdiff_t D_plane, ptrdiff_t D_stride, const double *k, ptrdiff_t k_stride,
    double *Do, ptrdiff_t Do_plane, ptrdiff_t Do_stride) {
  ksl_SE3_t D_i;
  if (n > 0) D_i = ksl_SE3_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3_of_planes(D + i * D_stride, D_plane);
    ksl_SE3_t Do_i;
    ksl_product_ddtz_accurate(&D_i, k[i * k_stride], &Do_i);
    ksl_SE3_to_planes(&Do_i, Do + i * Do_stride, Do_plane);
  }
}

/* ksl_product_drvtzinv_accurate of n elements. */
static KSL_INLINED void ksl_product_drvtzinv_accurate_many(ptrdiff_t n, const ksl_mat3x3_t *R,
    ptrdiff_t R_stride, const double *k, ptrdiff_t k_stride, ksl_vec3_t *vo,
    ptrdiff_t vo_stride) {
  KSL_EACH_OF(n) {
    ksl_product_drvtzinv_accurate(R + i * R_stride, k[i * k_stride], vo + i * vo_stride);
  }
}

static KSL_INLINED void ksl_product_drvtzinv_accurate_planes(ptrdiff_t n, const double *R,
    ptrdiff_t R_plane, ptrdiff_t R_stride, const double *k, ptrdiff_t k_stride,
    double *vo, ptrdiff_t vo_plane, ptrdiff_t vo_stride) {
  ksl_mat3x3_t R_i;
  if (n > 0) R_i = ksl_mat3x3_of_planes(R, R_plane);
  KSL_EACH_OF(n) {
    if (R_stride) R_i = ksl_mat3x3_of_planes(R + i * R_stride, R_plane);
    ksl_vec3_t vo_i;
    ksl_product_drvtzinv_accurate(&R_i, k[i * k_stride], &vo_i);
    ksl_vec3_to_planes(&vo_i, vo + i * vo_stride, vo_plane);
  }
}

/* ksl_product_drdrzinv_accurate of n elements. */
static KSL_INLINED void ksl_product_drdrzinv_accurate_many(ptrdiff_t n, const ksl_mat3x3_t *R,
    ptrdiff_t R_stride, const double *dc, ptrdiff_t dc_stride, ksl_mat3x3_t *Ro,
    ptrdiff_t Ro_stride) {
  KSL_EACH_OF(n) {
    ksl_product_drdrzinv_accurate(R + i * R_stride, dc + 2 * i * dc_stride, Ro + i * Ro_stride);
  }
}

static KSL_INLINED void ksl_product_drdrzinv_accurate_planes(ptrdiff_t n, const double *R,
    ptrdiff_t R_plane, ptrdiff_t R_stride, const double *dc, ptrdiff_t dc_plane,
    ptrdiff_t dc_stride, double *Ro, ptrdiff_t Ro_plane, ptrdiff_t Ro_stride) {
  ksl_mat3x3_t R_i;
  if (n > 0) R_i = ksl_mat3x3_of_planes(R, R_plane);
  KSL_EACH_OF(n) {
    if (R_stride) R_i = ksl_mat3x3_of_planes(R + i * R_stride, R_plane);
    const double dc_i[2] = {dc[0 + i * dc_stride], dc[dc_plane + i * dc_stride]};
    ksl_mat3x3_t Ro_i;
    ksl_product_drdrzinv_accurate(&R_i, dc_i, &Ro_i);
    ksl_mat3x3_to_planes(&Ro_i, Ro + i * Ro_stride, Ro_plane);
  }
}

/* ksl_product_ddrzinv_accurate of n elements. */
static KSL_INLINED void ksl_product_ddrzinv_accurate_many(ptrdiff_t n, const ksl_SE3_t *D,
    ptrdiff_t D_stride, const double *dc, ptrdiff_t dc_stride, ksl_SE3_t *Do,
    ptrdiff_t Do_stride) {
  KSL_EACH_OF(n) {
    ksl_product_ddrzinv_accurate(D + i * D_stride, dc + 2 * i * dc_stride, Do + i * Do_stride);
  }
}

static KSL_INLINED void ksl_product_ddrzinv_accurate_planes(ptrdiff_t n, const double *D,
    ptrdiff_t D_plane, ptrdiff_t D_stride, const double *dc, ptrdiff_t dc_plane,
    ptrdiff_t dc_stride, double *Do, ptrdiff_t Do_plane, ptrdiff_t Do_stride) {
  ksl_SE3_t D_i;
  if (n > 0) D_i = ksl_SE3_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3_of_planes(D + i * D_stride, D_plane);
    const double dc_i[2] = {dc[0 + i * dc_stride], dc[dc_plane + i * dc_stride]};
    ksl_SE3_t Do_i;
    ksl_product_ddrzinv_accurate(&D_i, dc_i, &Do_i);
    ksl_SE3_to_planes(&Do_i, Do + i * Do_stride, Do_plane);
  }
}

/* ksl_product_ddtzinv_accurate of n elements. */
static KSL_INLINED void ksl_product_ddtzinv_accurate_many(ptrdiff_t n, const ksl_SE3_t *D,
    ptrdiff_t D_stride, const double *k, ptrdiff_t k_stride, ksl_SE3_t *Do,
    ptrdiff_t Do_stride) {
  KSL_EACH_OF(n) {
    ksl_product_ddtzinv_accurate(D + i * D_stride, k[i * k_stride], Do + i * Do_stride);
  }
}

static KSL_INLINED void ksl_product_ddtzinv_accurate_planes(ptrdiff_t n, const double *D,
    ptrdiff_t D_plane, ptrdiff_t D_stride, const double *k, ptrdiff_t k_stride,
    double *Do, ptrdiff_t Do_plane, ptrdiff_t Do_stride) {
  ksl_SE3_t D_i;
  if (n > 0) D_i = ksl_SE3_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3_of_planes(D + i * D_stride, D_plane);
    ksl_SE3_t Do_i;
    ksl_product_ddtzinv_accurate(&D_i, k[i * k_stride], &Do_i);
    ksl_SE3_to_planes(&Do_i, Do + i * Do_stride, Do_plane);
  }
}

/* ksl_product_drvf_accurate of n elements. */
static KSL_INLINED void ksl_product_drvf_accurate_many(ptrdiff_t n, const ksl_mat3x3f_t *R,
    ptrdiff_t R_stride, const ksl_vec3f_t *v, ptrdiff_t v_stride,
    ksl_vec3f_t *vo, ptrdiff_t vo_stride) {
  KSL_EACH_OF(n) {
    ksl_product_drvf_accurate(R + i * R_stride, v + i * v_stride, vo + i * vo_stride);
  }
}

static KSL_INLINED void ksl_product_drvf_accurate_planes(ptrdiff_t n, const float *R,
    ptrdiff_t R_plane, ptrdiff_t R_stride, const float *v, ptrdiff_t v_plane,
    ptrdiff_t v_stride, float *vo, ptrdiff_t vo_plane, ptrdiff_t vo_stride) {
  ksl_mat3x3f_t R_i;
  if (n > 0) R_i = ksl_mat3x3f_of_planes(R, R_plane);
  KSL_EACH_OF(n) {
    if (R_stride) R_i = ksl_mat3x3f_of_planes(R + i * R_stride, R_plane);
    const ksl_vec3f_t v_i = ksl_vec3f_of_planes(v + i * v_stride, v_plane);
    ksl_vec3f_t vo_i;
    ksl_product_drvf_accurate(&R_i, &v_i, &vo_i);
    ksl_vec3f_to_planes(&vo_i, vo + i * vo_stride, vo_plane);
  }
}

/* ksl_product_drvinvf_accurate of n elements. */
static KSL_INLINED void ksl_product_drvinvf_accurate_many(ptrdiff_t n, const ksl_mat3x3f_t *R,
    ptrdiff_t R_stride, const ksl_vec3f_t *v, ptrdiff_t v_stride,
    ksl_vec3f_t *vo, ptrdiff_t vo_stride) {
  KSL_EACH_OF(n) {
    ksl_product_drvinvf_accurate(R + i * R_stride, v + i * v_stride, vo + i * vo_stride);
  }
}

static KSL_INLINED void ksl_product_drvinvf_accurate_planes(ptrdiff_t n, const float *R,
    ptrdiff_t R_plane, ptrdiff_t R_stride, const float *v, ptrdiff_t v_plane,
    ptrdiff_t v_stride, float *vo, ptrdiff_t vo_plane, ptrdiff_t vo_stride) {
  ksl_mat3x3f_t R_i;
  if (n > 0) R_i = ksl_mat3x3f_of_planes(R, R_plane);
  KSL_EACH_OF(n) {
    if (R_stride) R_i = ksl_mat3x3f_of_planes(R + i * R_stride, R_plane);
    const ksl_vec3f_t v_i = ksl_vec3f_of_planes(v + i * v_stride, v_plane);
    ksl_vec3f_t vo_i;
    ksl_product_drvinvf_accurate(&R_i, &v_i, &vo_i);
    ksl_vec3f_to_planes(&vo_i, vo + i * vo_stride, vo_plane);
  }
}

/* ksl_product_drinvvf_accurate of n elements. */
static KSL_INLINED void ksl_product_drinvvf_accurate_many(ptrdiff_t n, const ksl_mat3x3f_t *R,
    ptrdiff_t R_stride, const ksl_vec3f_t *v, ptrdiff_t v_stride,
    ksl_vec3f_t *vo, ptrdiff_t vo_stride) {
  KSL_EACH_OF(n) {
    ksl_product_drinvvf_accurate(R + i * R_stride, v + i * v_stride, vo + i * vo_stride);
  }
}

static KSL_INLINED void ksl_product_drinvvf_accurate_planes(ptrdiff_t n, const float *R,
    ptrdiff_t R_plane, ptrdiff_t R_stride, const float *v, ptrdiff_t v_plane,
    ptrdiff_t v_stride, float *vo, ptrdiff_t vo_plane, ptrdiff_t vo_stride) {
  ksl_mat3x3f_t R_i;
  if (n > 0) R_i = ksl_mat3x3f_of_planes(R, R_plane);
  KSL_EACH_OF(n) {
    if (R_stride) R_i = ksl_mat3x3f_of_planes(R + i * R_stride, R_plane);
    const ksl_vec3f_t v_i = ksl_vec3f_of_planes(v + i * v_stride, v_plane);
    ksl_vec3f_t vo_i;
    ksl_product_drinvvf_accurate(&R_i, &v_i, &vo_i);
    ksl_vec3f_to_planes(&vo_i, vo + i * vo_stride, vo_plane);
  }
}

/* ksl_product_drinvvinvf_accurate of n elements. */
static KSL_INLINED void ksl_product_drinvvinvf_accurate_many(ptrdiff_t n, const ksl_mat3x3f_t *R,
    ptrdiff_t R_stride, const ksl_vec3f_t *v, ptrdiff_t v_stride,
    ksl_vec3f_t *vo, ptrdiff_t vo_stride) {
  KSL_EACH_OF(n) {
    ksl_product_drinvvinvf_accurate(R + i * R_stride, v + i * v_stride, vo + i * vo_stride);
  }
}

static KSL_INLINED void ksl_product_drinvvinvf_accurate_planes(ptrdiff_t n, const float *R,
    ptrdiff_t R_plane, ptrdiff_t R_stride, const float *v, ptrdiff_t v_plane,
    ptrdiff_t v_stride, float *vo, ptrdiff_t vo_plane, ptrdiff_t vo_stride) {
  ksl_mat3x3f_t R_i;
  if (n > 0) R_i = ksl_mat3x3f_of_planes(R, R_plane);
  KSL_EACH_OF(n) {
    if (R_stride) R_i = ksl_mat3x3f_of_planes(R + i * R_stride, R_plane);
    const ksl_vec3f_t v_i = ksl_vec3f_of_planes(v + i * v_stride, v_plane);
    ksl_vec3f_t vo_i;
    ksl_product_drinvvinvf_accurate(&R_i, &v_i, &vo_i);
    ksl_vec3f_to_planes(&vo_i, vo + i * vo_stride, vo_plane);
  }
}

/* ksl_product_dvf_accurate of n elements. */
static KSL_INLINED void ksl_product_dvf_accurate_many(ptrdiff_t n, const ksl_SE3f_t *D,
    ptrdiff_t D_stride, const ksl_vec3f_t *v, ptrdiff_t v_stride,
    ksl_vec3f_t *vo, ptrdiff_t vo_stride) {
  KSL_EACH_OF(n) {
    ksl_product_dvf_accurate(D + i * D_stride, v + i * v_stride, vo + i * vo_stride);
  }
}

static KSL_INLINED void ksl_product_dvf_accurate_planes(ptrdiff_t n, const float *D,
    ptrdiff_t D_plane, ptrdiff_t D_stride, const float *v, ptrdiff_t v_plane,
    ptrdiff_t v_stride, float *vo, ptrdiff_t vo_plane, ptrdiff_t vo_stride) {
  ksl_SE3f_t D_i;
  if (n > 0) D_i = ksl_SE3f_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3f_of_planes(D + i * D_stride, D_plane);
    const ksl_vec3f_t v_i = ksl_vec3f_of_planes(v + i * v_stride, v_plane);
    ksl_vec3f_t vo_i;
    ksl_product_dvf_accurate(&D_i, &v_i, &vo_i);
    ksl_vec3f_to_planes(&vo_i, vo + i * vo_stride, vo_plane);
  }
}

/* ksl_product_dinvvf_accurate of n elements. */
static KSL_INLINED void ksl_product_dinvvf_accurate_many(ptrdiff_t n, const ksl_SE3f_t *D,
    ptrdiff_t D_stride, const ksl_vec3f_t *v, ptrdiff_t v_stride,
    ksl_vec3f_t *vo, ptrdiff_t vo_stride) {
  KSL_EACH_OF(n) {
    ksl_product_dinvvf_accurate(D + i * D_stride, v + i * v_stride, vo + i * vo_stride);
  }
}

static KSL_INLINED void ksl_product_dinvvf_accurate_planes(ptrdiff_t n, const float *D,
    ptrdiff_t D_plane, ptrdiff_t D_stride, const float *v, ptrdiff_t v_plane,
    ptrdiff_t v_stride, float *vo, ptrdiff_t vo_plane, ptrdiff_t vo_stride) {
  ksl_SE3f_t D_i;
  if (n > 0) D_i = ksl_SE3f_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3f_of_planes(D + i * D_stride, D_plane);
    const ksl_vec3f_t v_i = ksl_vec3f_of_planes(v + i * v_stride, v_plane);
    ksl_vec3f_t vo_i;
    ksl_product_dinvvf_accurate(&D_i, &v_i, &vo_i);
    ksl_vec3f_to_planes(&vo_i, vo + i * vo_stride, vo_plane);
  }
}

/* ksl_product_drdrf_accurate of n elements. */
static KSL_INLINED void ksl_product_drdrf_accurate_many(ptrdiff_t n, const ksl_mat3x3f_t *R1,
    ptrdiff_t R1_stride, const ksl_mat3x3f_t *R2, ptrdiff_t R2_stride,
    ksl_mat3x3f_t *Ro, ptrdiff_t Ro_stride) {
  KSL_EACH_OF(n) {
    ksl_product_drdrf_accurate(R1 + i * R1_stride, R2 + i * R2_stride, Ro + i * Ro_stride);
  }
}

static KSL_INLINED void ksl_product_drdrf_accurate_planes(ptrdiff_t n, const float *R1,
    ptrdiff_t R1_plane, ptrdiff_t R1_stride, const float *R2, ptrdiff_t R2_plane,
    ptrdiff_t R2_stride, float *Ro, ptrdiff_t Ro_plane, ptrdiff_t Ro_stride) {
  ksl_mat3x3f_t R1_i;
  if (n > 0) R1_i = ksl_mat3x3f_of_planes(R1, R1_plane);
  KSL_EACH_OF(n) {
    if (R1_stride) R1_i = ksl_mat3x3f_of_planes(R1 + i * R1_stride, R1_plane);
    const ksl_mat3x3f_t R2_i = ksl_mat3x3f_of_planes(R2 + i * R2_stride, R2_plane);
    ksl_mat3x3f_t Ro_i;
    ksl_product_drdrf_accurate(&R1_i, &R2_i, &Ro_i);
    ksl_mat3x3f_to_planes(&Ro_i, Ro + i * Ro_stride, Ro_plane);
  }
}

/* ksl_product_drdrinvf_accurate of n elements. */
static KSL_INLINED void ksl_product_drdrinvf_accurate_many(ptrdiff_t n, const ksl_mat3x3f_t *R1,
    ptrdiff_t R1_stride, const ksl_mat3x3f_t *R2, ptrdiff_t R2_stride,
    ksl_mat3x3f_t *Ro, ptrdiff_t Ro_stride) {
  KSL_EACH_OF(n) {
    ksl_product_drdrinvf_accurate(R1 + i * R1_stride, R2 + i * R2_stride, Ro + i * Ro_stride);
  }
}

static KSL_INLINED void ksl_product_drdrinvf_accurate_planes(ptrdiff_t n, const float *R1,
    ptrdiff_t R1_plane, ptrdiff_t R1_stride, const float *R2, ptrdiff_t R2_plane,
    ptrdiff_t R2_stride, float *Ro, ptrdiff_t Ro_plane, ptrdiff_t Ro_stride) {
  ksl_mat3x3f_t R1_i;
  if (n > 0) R1_i = ksl_mat3x3f_of_planes(R1, R1_plane);
  KSL_EACH_OF(n) {
    if (R1_stride) R1_i = ksl_mat3x3f_of_planes(R1 + i * R1_stride, R1_plane);
    const ksl_mat3x3f_t R2_i = ksl_mat3x3f_of_planes(R2 + i * R2_stride, R2_plane);
    ksl_mat3x3f_t Ro_i;
    ksl_product_drdrinvf_accurate(&R1_i, &R2_i, &Ro_i);
    ksl_mat3x3f_to_planes(&Ro_i, Ro + i * Ro_stride, Ro_plane);
  }
}

/* ksl_product_drinvdrf_accurate of n elements. */
static KSL_INLINED void ksl_product_drinvdrf_accurate_many(ptrdiff_t n, const ksl_mat3x3f_t *R1,
    ptrdiff_t R1_stride, const ksl_mat3x3f_t *R2, ptrdiff_t R2_stride,
    ksl_mat3x3f_t *Ro, ptrdiff_t Ro_stride) {
  KSL_EACH_OF(n) {
    ksl_product_drinvdrf_accurate(R1 + i * R1_stride, R2 + i * R2_stride, Ro + i * Ro_stride);
  }
}

static KSL_INLINED void ksl_product_drinvdrf_accurate_planes(ptrdiff_t n, const float *R1,
    ptrdiff_t R1_plane, ptrdiff_t R1_stride, const float *R2, ptrdiff_t R2_plane,
    ptrdiff_t R2_stride, float *Ro, ptrdiff_t Ro_plane, ptrdiff_t Ro_stride) {
  ksl_mat3x3f_t R1_i;
  if (n > 0) R1_i = ksl_mat3x3f_of_planes(R1, R1_plane);
  KSL_EACH_OF(n) {
    if (R1_stride) R1_i = ksl_mat3x3f_of_planes(R1 + i * R1_stride, R1_plane);
    const ksl_mat3x3f_t R2_i = ksl_mat3x3f_of_planes(R2 + i * R2_stride, R2_plane);
    ksl_mat3x3f_t Ro_i;
    ksl_product_drinvdrf_accurate(&R1_i, &R2_i, &Ro_i);
    ksl_mat3x3f_to_planes(&Ro_i, Ro + i * Ro_stride, Ro_plane);
  }
}

/* ksl_product_ddf_accurate of n elements. */
static KSL_INLINED void ksl_product_ddf_accurate_many(ptrdiff_t n, const ksl_SE3f_t *D1,
    ptrdiff_t D1_stride, const ksl_SE3f_t *D2, ptrdiff_t D2_stride,
    ksl_SE3f_t *Do, ptrdiff_t Do_stride) {
  KSL_EACH_OF(n) {
    ksl_product_ddf_accurate(D1 + i * D1_stride, D2 + i * D2_stride, Do + i * Do_stride);
  }
}

static KSL_INLINED void ksl_product_ddf_accurate_planes(ptrdiff_t n, const float *D1,
    ptrdiff_t D1_plane, ptrdiff_t D1_stride, const float *D2, ptrdiff_t D2_plane,
    ptrdiff_t D2_stride, float *Do, ptrdiff_t Do_plane, ptrdiff_t Do_stride) {
  ksl_SE3f_t D1_i;
  if (n > 0) D1_i = ksl_SE3f_of_planes(D1, D1_plane);
  KSL_EACH_OF(n) {
    if (D1_stride) D1_i = ksl_SE3f_of_planes(D1 + i * D1_stride, D1_plane);
    const ksl_SE3f_t D2_i = ksl_SE3f_of_planes(D2 + i * D2_stride, D2_plane);
    ksl_SE3f_t Do_i;
    ksl_product_ddf_accurate(&D1_i, &D2_i, &Do_i);
    ksl_SE3f_to_planes(&Do_i, Do + i * Do_stride, Do_plane);
  }
}

/* ksl_product_ddinvf_accurate of n elements. */
static KSL_INLINED void ksl_product_ddinvf_accurate_many(ptrdiff_t n, const ksl_SE3f_t *D1,
    ptrdiff_t D1_stride, const ksl_SE3f_t *D2, ptrdiff_t D2_stride,
    ksl_SE3f_t *Do, ptrdiff_t Do_stride) {
  KSL_EACH_OF(n) {
    ksl_product_ddinvf_accurate(D1 + i * D1_stride, D2 + i * D2_stride, Do + i * Do_stride);
  }
}

static KSL_INLINED void ksl_product_ddinvf_accurate_planes(ptrdiff_t n, const float *D1,
    ptrdiff_t D1_plane, ptrdiff_t D1_stride, const float *D2, ptrdiff_t D2_plane,
    ptrdiff_t D2_stride, float *Do, ptrdiff_t Do_plane, ptrdiff_t Do_stride) {
  ksl_SE3f_t D1_i;
  if (n > 0) D1_i = ksl_SE3f_of_planes(D1, D1_plane);
  KSL_EACH_OF(n) {
    if (D1_stride) D1_i = ksl_SE3f_of_planes(D1 + i * D1_stride, D1_plane);
    const ksl_SE3f_t D2_i = ksl_SE3f_of_planes(D2 + i * D2_stride, D2_plane);
    ksl_SE3f_t Do_i;
    ksl_product_ddinvf_accurate(&D1_i, &D2_i, &Do_i);
    ksl_SE3f_to_planes(&Do_i, Do + i * Do_stride, Do_plane);
  }
}

/* ksl_product_dinvdf_accurate of n elements. */
static KSL_INLINED void ksl_product_dinvdf_accurate_many(ptrdiff_t n, const ksl_SE3f_t *D1,
    ptrdiff_t D1_stride, const ksl_SE3f_t *D2, ptrdiff_t D2_stride,
    ksl_SE3f_t *Do, ptrdiff_t Do_stride) {
  KSL_EACH_OF(n) {
    ksl_product_dinvdf_accurate(D1 + i * D1_stride, D2 + i * D2_stride, Do + i * Do_stride);
  }
}

static KSL_INLINED void ksl_product_dinvdf_accurate_planes(ptrdiff_t n, const float *D1,
    ptrdiff_t D1_plane, ptrdiff_t D1_stride, const float *D2, ptrdiff_t D2_plane,
    ptrdiff_t D2_stride, float *Do, ptrdiff_t Do_plane, ptrdiff_t Do_stride) {
  ksl_SE3f_t D1_i;
  if (n > 0) D1_i = ksl_SE3f_of_planes(D1, D1_plane);
  KSL_EACH_OF(n) {
    if (D1_stride) D1_i = ksl_SE3f_of_planes(D1 + i * D1_stride, D1_plane);
    const ksl_SE3f_t D2_i = ksl_SE3f_of_planes(D2 + i * D2_stride, D2_plane);
    ksl_SE3f_t Do_i;
    ksl_product_dinvdf_accurate(&D1_i, &D2_i, &Do_i);
    ksl_SE3f_to_planes(&Do_i, Do + i * Do_stride, Do_plane);
  }
}

/* ksl_product_ddrf_accurate of n elements. */
static KSL_INLINED void ksl_product_ddrf_accurate_many(ptrdiff_t n, const ksl_SE3f_t *D,
    ptrdiff_t D_stride, const ksl_mat3x3f_t *R, ptrdiff_t R_stride,
    ksl_SE3f_t *Do, ptrdiff_t Do_stride) {
  KSL_EACH_OF(n) {
    ksl_product_ddrf_accurate(D + i * D_stride, R + i * R_stride, Do + i * Do_stride);
  }
}

static KSL_INLINED void ksl_product_ddrf_accurate_planes(ptrdiff_t n, const float *D,
    ptrdiff_t D_plane, ptrdiff_t D_stride, const float *R, ptrdiff_t R_plane,
    ptrdiff_t R_stride, float *Do, ptrdiff_t Do_plane, ptrdiff_t Do_stride) {
  ksl_SE3f_t D_i;
  if (n > 0) D_i = ksl_SE3f_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3f_of_planes(D + i * D_stride, D_plane);
    const ksl_mat3x3f_t R_i = ksl_mat3x3f_of_planes(R + i * R_stride, R_plane);
    ksl_SE3f_t Do_i;
    ksl_product_ddrf_accurate(&D_i, &R_i, &Do_i);
    ksl_SE3f_to_planes(&Do_i, Do + i * Do_stride, Do_plane);
  }
}

/* ksl_product_ddrinvf_accurate of n elements. */
static KSL_INLINED void ksl_product_ddrinvf_accurate_many(ptrdiff_t n, const ksl_SE3f_t *D,
    ptrdiff_t D_stride, const ksl_mat3x3f_t *R, ptrdiff_t R_stride,
    ksl_SE3f_t *Do, ptrdiff_t Do_stride) {
  KSL_EACH_OF(n) {
    ksl_product_ddrinvf_accurate(D + i * D_stride, R + i * R_stride, Do + i * Do_stride);
  }
}

static KSL_INLINED void ksl_product_ddrinvf_accurate_planes(ptrdiff_t n, const float *D,
    ptrdiff_t D_plane, ptrdiff_t D_stride, const float *R, ptrdiff_t R_plane,
    ptrdiff_t R_stride, float *Do, ptrdiff_t Do_plane, ptrdiff_t Do_stride) {
  ksl_SE3f_t D_i;
  if (n > 0) D_i = ksl_SE3f_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3f_of_planes(D + i * D_stride, D_plane);
    const ksl_mat3x3f_t R_i = ksl_mat3x3f_of_planes(R + i * R_stride, R_plane);
    ksl_SE3f_t Do_i;
    ksl_product_ddrinvf_accurate(&D_i, &R_i, &Do_i);
    ksl_SE3f_to_planes(&Do_i, Do + i * Do_stride, Do_plane);
  }
}

/* ksl_product_ddtf_accurate of n elements. */
static KSL_INLINED void ksl_product_ddtf_accurate_many(ptrdiff_t n, const ksl_SE3f_t *D,
    ptrdiff_t D_stride, const ksl_vec3f_t *t, ptrdiff_t t_stride, ksl_SE3f_t *Do,
    ptrdiff_t Do_stride) {
  KSL_EACH_OF(n) {
    ksl_product_ddtf_accurate(D + i * D_stride, t + i * t_stride, Do + i * Do_stride);
  }
}

static KSL_INLINED void ksl_product_ddtf_accurate_planes(ptrdiff_t n, const float *D,
    ptrdiff_t D_plane, ptrdiff_t D_stride, const float *t, ptrdiff_t t_plane,
    ptrdiff_t t_stride, float *Do, ptrdiff_t Do_plane, ptrdiff_t Do_stride) {
  ksl_SE3f_t D_i;
  if (n > 0) D_i = ksl_SE3f_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3f_of_planes(D + i * D_stride, D_plane);
    const ksl_vec3f_t t_i = ksl_vec3f_of_planes(t + i * t_stride, t_plane);
    ksl_SE3f_t Do_i;
    ksl_product_ddtf_accurate(&D_i, &t_i, &Do_i);
    ksl_SE3f_to_planes(&Do_i, Do + i * Do_stride, Do_plane);
  }
}

/* ksl_product_ddtinvf_accurate of n elements. */
static KSL_INLINED void ksl_product_ddtinvf_accurate_many(ptrdiff_t n, const ksl_SE3f_t *D,
    ptrdiff_t D_stride, const ksl_vec3f_t *t, ptrdiff_t t_stride, ksl_SE3f_t *Do,
    ptrdiff_t Do_stride) {
  KSL_EACH_OF(n) {
    ksl_product_ddtinvf_accurate(D + i * D_stride, t + i * t_stride, Do + i * Do_stride);
  }
}

static KSL_INLINED void ksl_product_ddtinvf_accurate_planes(ptrdiff_t n, const float *D,
    ptrdiff_t D_plane, ptrdiff_t D_stride, const float *t, ptrdiff_t t_plane,
    ptrdiff_t t_stride, float *Do, ptrdiff_t Do_plane, ptrdiff_t Do_stride) {
  ksl_SE3f_t D_i;
  if (n > 0) D_i = ksl_SE3f_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3f_of_planes(D + i * D_stride, D_plane);
    const ksl_vec3f_t t_i = ksl_vec3f_of_planes(t + i * t_stride, t_plane);
    ksl_SE3f_t Do_i;
    ksl_product_ddtinvf_accurate(&D_i, &t_i, &Do_i);
    ksl_SE3f_to_planes(&Do_i, Do + i * Do_stride, Do_plane);
  }
}

/* ksl_product_dinvdtf_accurate of n elements. */
static KSL_INLINED void ksl_product_dinvdtf_accurate_many(ptrdiff_t n, const ksl_SE3f_t *D,
    ptrdiff_t D_stride, const ksl_vec3f_t *t, ptrdiff_t t_stride, ksl_SE3f_t *Do,
    ptrdiff_t Do_stride) {
  KSL_EACH_OF(n) {
    ksl_product_dinvdtf_accurate(D + i * D_stride, t + i * t_stride, Do + i * Do_stride);
  }
}

static KSL_INLINED void ksl_product_dinvdtf_accurate_planes(ptrdiff_t n, const float *D,
    ptrdiff_t D_plane, ptrdiff_t D_stride, const float *t, ptrdiff_t t_plane,
    ptrdiff_t t_stride, float *Do, ptrdiff_t Do_plane, ptrdiff_t Do_stride) {
  ksl_SE3f_t D_i;
  if (n > 0) D_i = ksl_SE3f_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3f_of_planes(D + i * D_stride, D_plane);
    const ksl_vec3f_t t_i = ksl_vec3f_of_planes(t + i * t_stride, t_plane);
    ksl_SE3f_t Do_i;
    ksl_product_dinvdtf_accurate(&D_i, &t_i, &Do_i);
    ksl_SE3f_to_planes(&Do_i, Do + i * Do_stride, Do_plane);
  }
}

/* ksl_product_drvtxf_accurate of n elements. */
static KSL_INLINED void ksl_product_drvtxf_accurate_many(ptrdiff_t n, const ksl_mat3x3f_t *R,
    ptrdiff_t R_stride, const float *k, ptrdiff_t k_stride, ksl_vec3f_t *vo,
    ptrdiff_t vo_stride) {
  KSL_EACH_OF(n) {
    ksl_product_drvtxf_accurate(R + i * R_stride, k[i * k_stride], vo + i * vo_stride);
  }
}

static KSL_INLINED void ksl_product_drvtxf_accurate_planes(ptrdiff_t n, const float *R,
    ptrdiff_t R_plane, ptrdiff_t R_stride, const float *k, ptrdiff_t k_stride,
    float *vo, ptrdiff_t vo_plane, ptrdiff_t vo_stride) {
  ksl_mat3x3f_t R_i;
  if (n > 0) R_i = ksl_mat3x3f_of_planes(R, R_plane);
  KSL_EACH_OF(n) {
    if (R_stride) R_i = ksl_mat3x3f_of_planes(R + i * R_stride, R_plane);
    ksl_vec3f_t vo_i;
    ksl_product_drvtxf_accurate(&R_i, k[i * k_stride], &vo_i);
    ksl_vec3f_to_planes(&vo_i, vo + i * vo_stride, vo_plane);
  }
}

/* ksl_product_drdrxf_accurate of n elements. */
static KSL_INLINED void ksl_product_drdrxf_accurate_many(ptrdiff_t n, const ksl_mat3x3f_t *R,
    ptrdiff_t R_stride, const float *dc, ptrdiff_t dc_stride, ksl_mat3x3f_t *Ro,
    ptrdiff_t Ro_stride) {
  KSL_EACH_OF(n) {
    ksl_product_drdrxf_accurate(R + i * R_stride, dc + 2 * i * dc_stride, Ro + i * Ro_stride);
  }
}

static KSL_INLINED void ksl_product_drdrxf_accurate_planes(ptrdiff_t n, const float *R,
    ptrdiff_t R_plane, ptrdiff_t R_stride, const float *dc, ptrdiff_t dc_plane,
    ptrdiff_t dc_stride, float *Ro, ptrdiff_t Ro_plane, ptrdiff_t Ro_stride) {
  ksl_mat3x3f_t R_i;
  if (n > 0) R_i = ksl_mat3x3f_of_planes(R, R_plane);
  KSL_EACH_OF(n) {
    if (R_stride) R_i = ksl_mat3x3f_of_planes(R + i * R_stride, R_plane);
    const float dc_i[2] = {dc[0 + i * dc_stride], dc[dc_plane + i * dc_stride]};
    ksl_mat3x3f_t Ro_i;
    ksl_product_drdrxf_accurate(&R_i, dc_i, &Ro_i);
    ksl_mat3x3f_to_planes(&Ro_i, Ro + i * Ro_stride, Ro_plane);
  }
}

/* ksl_product_ddrxf_accurate of n elements. */
static KSL_INLINED void ksl_product_ddrxf_accurate_many(ptrdiff_t n, const ksl_SE3f_t *D,
    ptrdiff_t D_stride, const float *dc, ptrdiff_t dc_stride, ksl_SE3f_t *Do,
    ptrdiff_t Do_stride) {
  KSL_EACH_OF(n) {
    ksl_product_ddrxf_accurate(D + i * D_stride, dc + 2 * i * dc_stride, Do + i * Do_stride);
  }
}

static KSL_INLINED void ksl_product_ddrxf_accurate_planes(ptrdiff_t n, const float *D,
    ptrdiff_t D_plane, ptrdiff_t D_stride, const float *dc, ptrdiff_t dc_plane,
    ptrdiff_t dc_stride, float *Do, ptrdiff_t Do_plane, ptrdiff_t Do_stride) {
  ksl_SE3f_t D_i;
  if (n > 0) D_i = ksl_SE3f_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3f_of_planes(D + i * D_stride, D_plane);
    const float dc_i[2] = {dc[0 + i * dc_stride], dc[dc_plane + i * dc_stride]};
    ksl_SE3f_t Do_i;
    ksl_product_ddrxf_accurate(&D_i, dc_i, &Do_i);
    ksl_SE3f_to_planes(&Do_i, Do + i * Do_stride, Do_plane);
  }
}

/* ksl_product_ddtxf_accurate of n elements. */
static KSL_INLINED void ksl_product_ddtxf_accurate_many(ptrdiff_t n, const ksl_SE3f_t *D,
    ptrdiff_t D_stride, const float *k, ptrdiff_t k_stride, ksl_SE3f_t *Do,
    ptrdiff_t Do_stride) {
  KSL_EACH_OF(n) {
    ksl_product_ddtxf_accurate(D + i * D_stride, k[i * k_stride], Do + i * Do_stride);
  }
}

static KSL_INLINED void ksl_product_ddtxf_accurate_planes(ptrdiff_t n, const float *D,
    ptrdiff_t D_plane, ptrdiff_t D_stride, const float *k, ptrdiff_t k_stride,
    float *Do, ptrdiff_t Do_plane, ptrdiff_t Do_stride) {
  ksl_SE3f_t D_i;
  if (n > 0) D_i = ksl_SE3f_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3f_of_planes(D + i * D_stride, D_plane);
    ksl_SE3f_t Do_i;
    ksl_product_ddtxf_accurate(&D_i, k[i * k_stride], &Do_i);
    ksl_SE3f_to_planes(&Do_i, Do + i * Do_stride, Do_plane);
  }
}

/* ksl_product_drvtxinvf_accurate of n elements. */
static KSL_INLINED void ksl_product_drvtxinvf_accurate_many(ptrdiff_t n, const ksl_mat3x3f_t *R,
    ptrdiff_t R_stride, const float *k, ptrdiff_t k_stride, ksl_vec3f_t *vo,
    ptrdiff_t vo_stride) {
  KSL_EACH_OF(n) {
    ksl_product_drvtxinvf_accurate(R + i * R_stride, k[i * k_stride], vo + i * vo_stride);
  }
}

static KSL_INLINED void ksl_product_drvtxinvf_accurate_planes(ptrdiff_t n, const float *R,
    ptrdiff_t R_plane, ptrdiff_t R_stride, const float *k, ptrdiff_t k_stride,
    float *vo, ptrdiff_t vo_plane, ptrdiff_t vo_stride) {
  ksl_mat3x3f_t R_i;
  if (n > 0) R_i = ksl_mat3x3f_of_planes(R, R_plane);
  KSL_EACH_OF(n) {
    if (R_stride) R_i = ksl_mat3x3f_of_planes(R + i * R_stride, R_plane);
    ksl_vec3f_t vo_i;
    ksl_product_drvtxinvf_accurate(&R_i, k[i * k_stride], &vo_i);
    ksl_vec3f_to_planes(&vo_i, vo + i * vo_stride, vo_plane);
  }
}

/* ksl_product_drdrxinvf_accurate of n elements. */
static KSL_INLINED void ksl_product_drdrxinvf_accurate_many(ptrdiff_t n, const ksl_mat3x3f_t *R,
    ptrdiff_t R_stride, const float *dc, ptrdiff_t dc_stride, ksl_mat3x3f_t *Ro,
    ptrdiff_t Ro_stride) {
  KSL_EACH_OF(n) {
    ksl_product_drdrxinvf_accurate(R + i * R_stride, dc + 2 * i * dc_stride, Ro + i * Ro_stride);
  }
}

static KSL_INLINED void ksl_product_drdrxinvf_accurate_planes(ptrdiff_t n, const float *R,
    ptrdiff_t R_plane, ptrdiff_t R_stride, const float *dc, ptrdiff_t dc_plane,
    ptrdiff_t dc_stride, float *Ro, ptrdiff_t Ro_plane, ptrdiff_t Ro_stride) {
  ksl_mat3x3f_t R_i;
  if (n > 0) R_i = ksl_mat3x3f_of_planes(R, R_plane);
  KSL_EACH_OF(n) {
    if (R_stride) R_i = ksl_mat3x3f_of_planes(R + i * R_stride, R_plane);
    const float dc_i[2] = {dc[0 + i * dc_stride], dc[dc_plane + i * dc_stride]};
    ksl_mat3x3f_t Ro_i;
    ksl_product_drdrxinvf_accurate(&R_i, dc_i, &Ro_i);
    ksl_mat3x3f_to_planes(&Ro_i, Ro + i * Ro_stride, Ro_plane);
  }
}

/* ksl_product_ddrxinvf_accurate of n elements. */
static KSL_INLINED void ksl_product_ddrxinvf_accurate_many(ptrdiff_t n, const ksl_SE3f_t *D,
    ptrdiff_t D_stride, const float *dc, ptrdiff_t dc_stride, ksl_SE3f_t *Do,
    ptrdiff_t Do_stride) {
  KSL_EACH_OF(n) {
    ksl_product_ddrxinvf_accurate(D + i * D_stride, dc + 2 * i * dc_stride, Do + i * Do_stride);
  }
}

static KSL_INLINED void ksl_product_ddrxinvf_accurate_planes(ptrdiff_t n, const float *D,
    ptrdiff_t D_plane, ptrdiff_t D_stride, const float *dc, ptrdiff_t dc_plane,
    ptrdiff_t dc_stride, float *Do, ptrdiff_t Do_plane, ptrdiff_t Do_stride) {
  ksl_SE3f_t D_i;
  if (n > 0) D_i = ksl_SE3f_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3f_of_planes(D + i * D_stride, D_plane);
    const float dc_i[2] = {dc[0 + i * dc_stride], dc[dc_plane + i * dc_stride]};
    ksl_SE3f_t Do_i;
    ksl_product_ddrxinvf_accurate(&D_i, dc_i, &Do_i);
    ksl_SE3f_to_planes(&Do_i, Do + i * Do_stride, Do_plane);
  }
}

/* ksl_product_ddtxinvf_accurate of n elements. */
static KSL_INLINED void ksl_product_ddtxinvf_accurate_many(ptrdiff_t n, const ksl_SE3f_t *D,
    ptrdiff_t D_stride, const float *k, ptrdiff_t k_stride, ksl_SE3f_t *Do,
    ptrdiff_t Do_stride) {
  KSL_EACH_OF(n) {
    ksl_product_ddtxinvf_accurate(D + i * D_stride, k[i * k_stride], Do + i * Do_stride);
  }
}

static KSL_INLINED void ksl_product_ddtxinvf_accurate_planes(ptrdiff_t n, const float *D,
    ptrdiff_t D_plane, ptrdiff_t D_stride, const float *k, ptrdiff_t k_stride,
    float *Do, ptrdiff_t Do_plane, ptrdiff_t Do_stride) {
  ksl_SE3f_t D_i;
  if (n > 0) D_i = ksl_SE3f_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3f_of_planes(D + i * D_stride, D_plane);
    ksl_SE3f_t Do_i;
    ksl_product_ddtxinvf_accurate(&D_i, k[i * k_stride], &Do_i);
    ksl_SE3f_to_planes(&Do_i, Do + i * Do_stride, Do_plane);
  }
}

/* ksl_product_drvtyf_accurate of n elements. */
static KSL_INLINED void ksl_product_drvtyf_accurate_many(ptrdiff_t n, const ksl_mat3x3f_t *R,
    ptrdiff_t R_stride, const float *k, ptrdiff_t k_stride, ksl_vec3f_t *vo,
    ptrdiff_t vo_stride) {
  KSL_EACH_OF(n) {
    ksl_product_drvtyf_accurate(R + i * R_stride, k[i * k_stride], vo + i * vo_stride);
  }
}

static KSL_INLINED void ksl_product_drvtyf_accurate_planes(ptrdiff_t n, const float *R,
    ptrdiff_t R_plane, ptrdiff_t R_stride, const float *k, ptrdiff_t k_stride,
    float *vo, ptrdiff_t vo_plane, ptrdiff_t vo_stride) {
  ksl_mat3x3f_t R_i;
  if (n > 0) R_i = ksl_mat3x3f_of_planes(R, R_plane);
  KSL_EACH_OF(n) {
    if (R_stride) R_i = ksl_mat3x3f_of_planes(R + i * R_stride, R_plane);
    ksl_vec3f_t vo_i;
    ksl_product_drvtyf_accurate(&R_i, k[i * k_stride], &vo_i);
    ksl_vec3f_to_planes(&vo_i, vo + i * vo_stride, vo_plane);
  }
}

/* ksl_product_drdryf_accurate of n elements. */
static KSL_INLINED void ksl_product_drdryf_accurate_many(ptrdiff_t n, const ksl_mat3x3f_t *R,
    ptrdiff_t R_stride, const float *dc, ptrdiff_t dc_stride, ksl_mat3x3f_t *Ro,
    ptrdiff_t Ro_stride) {
  KSL_EACH_OF(n) {
    ksl_product_drdryf_accurate(R + i * R_stride, dc + 2 * i * dc_stride, Ro + i * Ro_stride);
  }
}

static KSL_INLINED void ksl_product_drdryf_accurate_planes(ptrdiff_t n, const float *R,
    ptrdiff_t R_plane, ptrdiff_t R_stride, const float *dc, ptrdiff_t dc_plane,
    ptrdiff_t dc_stride, float *Ro, ptrdiff_t Ro_plane, ptrdiff_t Ro_stride) {
  ksl_mat3x3f_t R_i;
  if (n > 0) R_i = ksl_mat3x3f_of_planes(R, R_plane);
  KSL_EACH_OF(n) {
    if (R_stride) R_i = ksl_mat3x3f_of_planes(R + i * R_stride, R_plane);
    const float dc_i[2] = {dc[0 + i * dc_stride], dc[dc_plane + i * dc_stride]};
    ksl_mat3x3f_t Ro_i;
    ksl_product_drdryf_accurate(&R_i, dc_i, &Ro_i);
    ksl_mat3x3f_to_planes(&Ro_i, Ro + i * Ro_stride, Ro_plane);
  }
}

/* ksl_product_ddryf_accurate of n elements. */
static KSL_INLINED void ksl_product_ddryf_accurate_many(ptrdiff_t n, const ksl_SE3f_t *D,
    ptrdiff_t D_stride, const float *dc, ptrdiff_t dc_stride, ksl_SE3f_t *Do,
    ptrdiff_t Do_stride) {
  KSL_EACH_OF(n) {
    ksl_product_ddryf_accurate(D + i * D_stride, dc + 2 * i * dc_stride, Do + i * Do_stride);
  }
}

static KSL_INLINED void ksl_product_ddryf_accurate_planes(ptrdiff_t n, const float *D,
    ptrdiff_t D_plane, ptrdiff_t D_stride, const float *dc, ptrdiff_t dc_plane,
    ptrdiff_t dc_stride, float *Do, ptrdiff_t Do_plane, ptrdiff_t Do_stride) {
  ksl_SE3f_t D_i;
  if (n > 0) D_i = ksl_SE3f_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3f_of_planes(D + i * D_stride, D_plane);
    const float dc_i[2] = {dc[0 + i * dc_stride], dc[dc_plane + i * dc_stride]};
    ksl_SE3f_t Do_i;
    ksl_product_ddryf_accurate(&D_i, dc_i, &Do_i);
    ksl_SE3f_to_planes(&Do_i, Do + i * Do_stride, Do_plane);
  }
}

/* ksl_product_ddtyf_accurate of n elements. */
static KSL_INLINED void ksl_product_ddtyf_accurate_many(ptrdiff_t n, const ksl_SE3f_t *D,
    ptrdiff_t D_stride, const float *k, ptrdiff_t k_stride, ksl_SE3f_t *Do,
    ptrdiff_t Do_stride) {
  KSL_EACH_OF(n) {
    ksl_product_ddtyf_accurate(D + i * D_stride, k[i * k_stride], Do + i * Do_stride);
  }
}

static KSL_INLINED void ksl_product_ddtyf_accurate_planes(ptrdiff_t n, const float *D,
    ptrdiff_t D_plane, ptrdiff_t D_stride, const float *k, ptrdiff_t k_stride,
    float *Do, ptrdiff_t Do_plane, ptrdiff_t Do_stride) {
  ksl_SE3f_t D_i;
  if (n > 0) D_i = ksl_SE3f_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3f_of_planes(D + i * D_stride, D_plane);
    ksl_SE3f_t Do_i;
    ksl_product_ddtyf_accurate(&D_i, k[i * k_stride], &Do_i);
    ksl_SE3f_to_planes(&Do_i, Do + i * Do_stride, Do_plane);
  }
}

/* ksl_product_drvtyinvf_accurate of n elements. */
static KSL_INLINED void ksl_product_drvtyinvf_accurate_many(ptrdiff_t n, const ksl_mat3x3f_t *R,
    ptrdiff_t R_stride, const float *k, ptrdiff_t k_stride, ksl_vec3f_t *vo,
    ptrdiff_t vo_stride) {
  KSL_EACH_OF(n) {
    ksl_product_drvtyinvf_accurate(R + i * R_stride, k[i * k_stride], vo + i * vo_stride);
  }
}

static KSL_INLINED void ksl_product_drvtyinvf_accurate_planes(ptrdiff_t n, const float *R,
    ptrdiff_t R_plane, ptrdiff_t R_stride, const float *k, ptrdiff_t k_stride,
    float *vo, ptrdiff_t vo_plane, ptrdiff_t vo_stride) {
  ksl_mat3x3f_t R_i;
  if (n > 0) R_i = ksl_mat3x3f_of_planes(R, R_plane);
  KSL_EACH_OF(n) {
    if (R_stride) R_i = ksl_mat3x3f_of_planes(R + i * R_stride, R_plane);
    ksl_vec3f_t vo_i;
    ksl_product_drvtyinvf_accurate(&R_i, k[i * k_stride], &vo_i);
    ksl_vec3f_to_planes(&vo_i, vo + i * vo_stride, vo_plane);
  }
}

/* ksl_product_drdryinvf_accurate of n elements. */
static KSL_INLINED void ksl_product_drdryinvf_accurate_many(ptrdiff_t n, const ksl_mat3x3f_t *R,
    ptrdiff_t R_stride, const float *dc, ptrdiff_t dc_stride, ksl_mat3x3f_t *Ro,
    ptrdiff_t Ro_stride) {
  KSL_EACH_OF(n) {
    ksl_product_drdryinvf_accurate(R + i * R_stride, dc + 2 * i * dc_stride, Ro + i * Ro_stride);
  }
}

static KSL_INLINED void ksl_product_drdryinvf_accurate_planes(ptrdiff_t n, const float *R,
    ptrdiff_t R_plane, ptrdiff_t R_stride, const float *dc, ptrdiff_t dc_plane,
    ptrdiff_t dc_stride, float *Ro, ptrdiff_t Ro_plane, ptrdiff_t Ro_stride) {
  ksl_mat3x3f_t R_i;
  if (n > 0) R_i = ksl_mat3x3f_of_planes(R, R_plane);
  KSL_EACH_OF(n) {
    if (R_stride) R_i = ksl_mat3x3f_of_planes(R + i * R_stride, R_plane);
    const float dc_i[2] = {dc[0 + i * dc_stride], dc[dc_plane + i * dc_stride]};
    ksl_mat3x3f_t Ro_i;
    ksl_product_drdryinvf_accurate(&R_i, dc_i, &Ro_i);
    ksl_mat3x3f_to_planes(&Ro_i, Ro + i * Ro_stride, Ro_plane);
  }
}

/* ksl_product_ddryinvf_accurate of n elements. */
static KSL_INLINED void ksl_product_ddryinvf_accurate_many(ptrdiff_t n, const ksl_SE3f_t *D,
    ptrdiff_t D_stride, const float *dc, ptrdiff_t dc_stride, ksl_SE3f_t *Do,
    ptrdiff_t Do_stride) {
  KSL_EACH_OF(n) {
    ksl_product_ddryinvf_accurate(D + i * D_stride, dc + 2 * i * dc_stride, Do + i * Do_stride);
  }
}

static KSL_INLINED void ksl_product_ddryinvf_accurate_planes(ptrdiff_t n, const float *D,
    ptrdiff_t D_plane, ptrdiff_t D_stride, const float *dc, ptrdiff_t dc_plane,
    ptrdiff_t dc_stride, float *Do, ptrdiff_t Do_plane, ptrdiff_t Do_stride) {
  ksl_SE3f_t D_i;
  if (n > 0) D_i = ksl_SE3f_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3f_of_planes(D + i * D_stride, D_plane);
    const float dc_i[2] = {dc[0 + i * dc_stride], dc[dc_plane + i * dc_stride]};
    ksl_SE3f_t Do_i;
    ksl_product_ddryinvf_accurate(&D_i, dc_i, &Do_i);
    ksl_SE3f_to_planes(&Do_i, Do + i * Do_stride, Do_plane);
  }
}

/* ksl_product_ddtyinvf_accurate of n elements. */
static KSL_INLINED void ksl_product_ddtyinvf_accurate_many(ptrdiff_t n, const ksl_SE3f_t *D,
    ptrdiff_t D_stride, const float *k, ptrdiff_t k_stride, ksl_SE3f_t *Do,
    ptrdiff_t Do_stride) {
  KSL_EACH_OF(n) {
    ksl_product_ddtyinvf_accurate(D + i * D_stride, k[i * k_stride], Do + i * Do_stride);
  }
}

static KSL_INLINED void ksl_product_ddtyinvf_accurate_planes(ptrdiff_t n, const float *D,
    ptrdiff_t D_plane, ptrdiff_t D_stride, const float *k, ptrdiff_t k_stride,
    float *Do, ptrdiff_t Do_plane, ptrdiff_t Do_stride) {
  ksl_SE3f_t D_i;
  if (n > 0) D_i = ksl_SE3f_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3f_of_planes(D + i * D_stride, D_plane);
    ksl_SE3f_t Do_i;
    ksl_product_ddtyinvf_accurate(&D_i, k[i * k_stride], &Do_i);
    ksl_SE3f_to_planes(&Do_i, Do + i * Do_stride, Do_plane);
  }
}

/* ksl_product_drvtzf_accurate of n elements. */
static KSL_INLINED void ksl_product_drvtzf_accurate_many(ptrdiff_t n, const ksl_mat3x3f_t *R,
    ptrdiff_t R_stride, const float *k, ptrdiff_t k_stride, ksl_vec3f_t *vo,
    ptrdiff_t vo_stride) {
  KSL_EACH_OF(n) {
    ksl_product_drvtzf_accurate(R + i * R_stride, k[i * k_stride], vo + i * vo_stride);
  }
}

static KSL_INLINED void ksl_product_drvtzf_accurate_planes(ptrdiff_t n, const float *R,
    ptrdiff_t R_plane, ptrdiff_t R_stride, const float *k, ptrdiff_t k_stride,
    float *vo, ptrdiff_t vo_plane, ptrdiff_t vo_stride) {
  ksl_mat3x3f_t R_i;
  if (n > 0) R_i = ksl_mat3x3f_of_planes(R, R_plane);
  KSL_EACH_OF(n) {
    if (R_stride) R_i = ksl_mat3x3f_of_planes(R + i * R_stride, R_plane);
    ksl_vec3f_t vo_i;
    ksl_product_drvtzf_accurate(&R_i, k[i * k_stride], &vo_i);
    ksl_vec3f_to_planes(&vo_i, vo + i * vo_stride, vo_plane);
  }
}

/* ksl_product_drdrzf_accurate of n elements. */
static KSL_INLINED void ksl_product_drdrzf_accurate_many(ptrdiff_t n, const ksl_mat3x3f_t *R,
    ptrdiff_t R_stride, const float *dc, ptrdiff_t dc_stride, ksl_mat3x3f_t *Ro,
    ptrdiff_t Ro_stride) {
  KSL_EACH_OF(n) {
    ksl_product_drdrzf_accurate(R + i * R_stride, dc + 2 * i * dc_stride, Ro + i * Ro_stride);
  }
}

static KSL_INLINED void ksl_product_drdrzf_accurate_planes(ptrdiff_t n, const float *R,
    ptrdiff_t R_plane, ptrdiff_t R_stride, const float *dc, ptrdiff_t dc_plane,
    ptrdiff_t dc_stride, float *Ro, ptrdiff_t Ro_plane, ptrdiff_t Ro_stride) {
  ksl_mat3x3f_t R_i;
  if (n > 0) R_i = ksl_mat3x3f_of_planes(R, R_plane);
  KSL_EACH_OF(n) {
    if (R_stride) R_i = ksl_mat3x3f_of_planes(R + i * R_stride, R_plane);
    const float dc_i[2] = {dc[0 + i * dc_stride], dc[dc_plane + i * dc_stride]};
    ksl_mat3x3f_t Ro_i;
    ksl_product_drdrzf_accurate(&R_i, dc_i, &Ro_i);
    ksl_mat3x3f_to_planes(&Ro_i, Ro + i * Ro_stride, Ro_plane);
  }
}

/* ksl_product_ddrzf_accurate of n elements. */
static KSL_INLINED void ksl_product_ddrzf_accurate_many(ptrdiff_t n, const ksl_SE3f_t *D,
    ptrdiff_t D_stride, const float *dc, ptrdiff_t dc_stride, ksl_SE3f_t *Do,
    ptrdiff_t Do_stride) {
  KSL_EACH_OF(n) {
    ksl_product_ddrzf_accurate(D + i * D_stride, dc + 2 * i * dc_stride, Do + i * Do_stride);
  }
}

static KSL_INLINED void ksl_product_ddrzf_accurate_planes(ptrdiff_t n, const float *D,
    ptrdiff_t D_plane, ptrdiff_t D_stride, const float *dc, ptrdiff_t dc_plane,
    ptrdiff_t dc_stride, float *Do, ptrdiff_t Do_plane, ptrdiff_t Do_stride) {
  ksl_SE3f_t D_i;
  if (n > 0) D_i = ksl_SE3f_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3f_of_planes(D + i * D_stride, D_plane);
    const float dc_i[2] = {dc[0 + i * dc_stride], dc[dc_plane + i * dc_stride]};
    ksl_SE3f_t Do_i;
    ksl_product_ddrzf_accurate(&D_i, dc_i, &Do_i);
    ksl_SE3f_to_planes(&Do_i, Do + i * Do_stride, Do_plane);
  }
}

/* ksl_product_ddtzf_accurate of n elements. */
static KSL_INLINED void ksl_product_ddtzf_accurate_many(ptrdiff_t n, const ksl_SE3f_t *D,
    ptrdiff_t D_stride, const float *k, ptrdiff_t k_stride, ksl_SE3f_t *Do,
    ptrdiff_t Do_stride) {
  KSL_EACH_OF(n) {
    ksl_product_ddtzf_accurate(D + i * D_stride, k[i * k_stride], Do + i * Do_stride);
  }
}

static KSL_INLINED void ksl_product_ddtzf_accurate_planes(ptrdiff_t n, const float *D,
    ptrdiff_t D_plane, ptrdiff_t D_stride, const float *k, ptrdiff_t k_stride,
    float *Do, ptrdiff_t Do_plane, ptrdiff_t Do_stride) {
  ksl_SE3f_t D_i;
  if (n > 0) D_i = ksl_SE3f_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3f_of_planes(D + i * D_stride, D_plane);
    ksl_SE3f_t Do_i;
    ksl_product_ddtzf_accurate(&D_i, k[i * k_stride], &Do_i);
    ksl_SE3f_to_planes(&Do_i, Do + i * Do_stride, Do_plane);
  }
}

/* ksl_product_drvtzinvf_accurate of n elements. */
static KSL_INLINED void ksl_product_drvtzinvf_accurate_many(ptrdiff_t n, const ksl_mat3x3f_t *R,
    ptrdiff_t R_stride, const float *k, ptrdiff_t k_stride, ksl_vec3f_t *vo,
    ptrdiff_t vo_stride) {
  KSL_EACH_OF(n) {
    ksl_product_drvtzinvf_accurate(R + i * R_stride, k[i * k_stride], vo + i * vo_stride);
  }
}

static KSL_INLINED void ksl_product_drvtzinvf_accurate_planes(ptrdiff_t n, const float *R,
    ptrdiff_t R_plane, ptrdiff_t R_stride, const float *k, ptrdiff_t k_stride,
    float *vo, ptrdiff_t vo_plane, ptrdiff_t vo_stride) {
  ksl_mat3x3f_t R_i;
  if (n > 0) R_i = ksl_mat3x3f_of_planes(R, R_plane);
  KSL_EACH_OF(n) {
    if (R_stride) R_i = ksl_mat3x3f_of_planes(R + i * R_stride, R_plane);
    ksl_vec3f_t vo_i;
    ksl_product_drvtzinvf_accurate(&R_i, k[i * k_stride], &vo_i);
    ksl_vec3f_to_planes(&vo_i, vo + i * vo_stride, vo_plane);
  }
}

/* ksl_product_drdrzinvf_accurate of n elements. */
static KSL_INLINED void ksl_product_drdrzinvf_accurate_many(ptrdiff_t n, const ksl_mat3x3f_t *R,
    ptrdiff_t R_stride, const float *dc, ptrdiff_t dc_stride, ksl_mat3x3f_t *Ro,
    ptrdiff_t Ro_stride) {
  KSL_EACH_OF(n) {
    ksl_product_drdrzinvf_accurate(R + i * R_stride, dc + 2 * i * dc_stride, Ro + i * Ro_stride);
  }
}

static KSL_INLINED void ksl_product_drdrzinvf_accurate_planes(ptrdiff_t n, const float *R,
    ptrdiff_t R_plane, ptrdiff_t R_stride, const float *dc, ptrdiff_t dc_plane,
    ptrdiff_t dc_stride, float *Ro, ptrdiff_t Ro_plane, ptrdiff_t Ro_stride) {
  ksl_mat3x3f_t R_i;
  if (n > 0) R_i = ksl_mat3x3f_of_planes(R, R_plane);
  KSL_EACH_OF(n) {
    if (R_stride) R_i = ksl_mat3x3f_of_planes(R + i * R_stride, R_plane);
    const float dc_i[2] = {dc[0 + i * dc_stride], dc[dc_plane + i * dc_stride]};
    ksl_mat3x3f_t Ro_i;
    ksl_product_drdrzinvf_accurate(&R_i, dc_i, &Ro_i);
    ksl_mat3x3f_to_planes(&Ro_i, Ro + i * Ro_stride, Ro_plane);
  }
}

/* ksl_product_ddrzinvf_accurate of n elements. */
static KSL_INLINED void ksl_product_ddrzinvf_accurate_many(ptrdiff_t n, const ksl_SE3f_t *D,
    ptrdiff_t D_stride, const float *dc, ptrdiff_t dc_stride, ksl_SE3f_t *Do,
    ptrdiff_t Do_stride) {
  KSL_EACH_OF(n) {
    ksl_product_ddrzinvf_accurate(D + i * D_stride, dc + 2 * i * dc_stride, Do + i * Do_stride);
  }
}

static KSL_INLINED void ksl_product_ddrzinvf_accurate_planes(ptrdiff_t n, const float *D,
    ptrdiff_t D_plane, ptrdiff_t D_stride, const float *dc, ptrdiff_t dc_plane,
    ptrdiff_t dc_stride, float *Do, ptrdiff_t Do_plane, ptrdiff_t Do_stride) {
  ksl_SE3f_t D_i;
  if (n > 0) D_i = ksl_SE3f_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3f_of_planes(D + i * D_stride, D_plane);
    const float dc_i[2] = {dc[0 + i * dc_stride], dc[dc_plane + i * dc_stride]};
    ksl_SE3f_t Do_i;
    ksl_product_ddrzinvf_accurate(&D_i, dc_i, &Do_i);
    ksl_SE3f_to_planes(&Do_i, Do + i * Do_stride, Do_plane);
  }
}

/* ksl_product_ddtzinvf_accurate of n elements. */
static KSL_INLINED void ksl_product_ddtzinvf_accurate_many(ptrdiff_t n, const ksl_SE3f_t *D,
    ptrdiff_t D_stride, const float *k, ptrdiff_t k_stride, ksl_SE3f_t *Do,
    ptrdiff_t Do_stride) {
  KSL_EACH_OF(n) {
    ksl_product_ddtzinvf_accurate(D + i * D_stride, k[i * k_stride], Do + i * Do_stride);
  }
}

static KSL_INLINED void ksl_product_ddtzinvf_accurate_planes(ptrdiff_t n, const float *D,
    ptrdiff_t D_plane, ptrdiff_t D_stride, const float *k, ptrdiff_t k_stride,
    float *Do, ptrdiff_t Do_plane, ptrdiff_t Do_stride) {
  ksl_SE3f_t D_i;
  if (n > 0) D_i = ksl_SE3f_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3f_of_planes(D + i * D_stride, D_plane);
    ksl_SE3f_t Do_i;
    ksl_product_ddtzinvf_accurate(&D_i, k[i * k_stride], &Do_i);
    ksl_SE3f_to_planes(&Do_i, Do + i * Do_stride, Do_plane);
  }
}

#endif
