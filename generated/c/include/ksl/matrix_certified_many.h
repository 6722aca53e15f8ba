/* Made by `coscrew generate`; changes are overwritten. */
/* SPDX-License-Identifier: MIT */
/* coscrew 0.2.0.  Copyright (c) 2026 The coscrew authors. */
/* Products between rotations, displacements and vectors.  Many at a time.
   What arguments are, and what loops over them cost, ksl_planes.h says. */
#ifndef KSL_MATRIX_CERTIFIED_MANY_H
#define KSL_MATRIX_CERTIFIED_MANY_H

#include "matrix_certified.h"
#include "ksl_planes.h"

/* ksl_product_drv_certified of n elements. */
static KSL_INLINED void ksl_product_drv_certified_many(ptrdiff_t n, const ksl_mat3x3_t *R,
    ptrdiff_t R_stride, const ksl_vec3_t *v, ptrdiff_t v_stride, ksl_vec3_t *vo,
    ptrdiff_t vo_stride, ksl_vec3_t *vo_bound, ptrdiff_t vo_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_product_drv_certified(R + i * R_stride, v + i * v_stride, vo + i * vo_stride,
        vo_bound + i * vo_bound_stride);
  }
}

static KSL_INLINED void ksl_product_drv_certified_planes(ptrdiff_t n, const double *R,
    ptrdiff_t R_plane, ptrdiff_t R_stride, const double *v, ptrdiff_t v_plane,
    ptrdiff_t v_stride, double *vo, ptrdiff_t vo_plane, ptrdiff_t vo_stride,
    double *vo_bound, ptrdiff_t vo_bound_plane, ptrdiff_t vo_bound_stride) {
  ksl_mat3x3_t R_i;
  if (n > 0) R_i = ksl_mat3x3_of_planes(R, R_plane);
  KSL_EACH_OF(n) {
    if (R_stride) R_i = ksl_mat3x3_of_planes(R + i * R_stride, R_plane);
    const ksl_vec3_t v_i = ksl_vec3_of_planes(v + i * v_stride, v_plane);
    ksl_vec3_t vo_i;
    ksl_vec3_t vo_bound_i;
    ksl_product_drv_certified(&R_i, &v_i, &vo_i, &vo_bound_i);
    ksl_vec3_to_planes(&vo_i, vo + i * vo_stride, vo_plane);
    ksl_vec3_to_planes(&vo_bound_i, vo_bound + i * vo_bound_stride, vo_bound_plane);
  }
}

/* ksl_product_drvinv_certified of n elements. */
static KSL_INLINED void ksl_product_drvinv_certified_many(ptrdiff_t n, const ksl_mat3x3_t *R,
    ptrdiff_t R_stride, const ksl_vec3_t *v, ptrdiff_t v_stride, ksl_vec3_t *vo,
    ptrdiff_t vo_stride, ksl_vec3_t *vo_bound, ptrdiff_t vo_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_product_drvinv_certified(R + i * R_stride, v + i * v_stride, vo + i * vo_stride,
        vo_bound + i * vo_bound_stride);
  }
}

static KSL_INLINED void ksl_product_drvinv_certified_planes(ptrdiff_t n, const double *R,
    ptrdiff_t R_plane, ptrdiff_t R_stride, const double *v, ptrdiff_t v_plane,
    ptrdiff_t v_stride, double *vo, ptrdiff_t vo_plane, ptrdiff_t vo_stride,
    double *vo_bound, ptrdiff_t vo_bound_plane, ptrdiff_t vo_bound_stride) {
  ksl_mat3x3_t R_i;
  if (n > 0) R_i = ksl_mat3x3_of_planes(R, R_plane);
  KSL_EACH_OF(n) {
    if (R_stride) R_i = ksl_mat3x3_of_planes(R + i * R_stride, R_plane);
    const ksl_vec3_t v_i = ksl_vec3_of_planes(v + i * v_stride, v_plane);
    ksl_vec3_t vo_i;
    ksl_vec3_t vo_bound_i;
    ksl_product_drvinv_certified(&R_i, &v_i, &vo_i, &vo_bound_i);
    ksl_vec3_to_planes(&vo_i, vo + i * vo_stride, vo_plane);
    ksl_vec3_to_planes(&vo_bound_i, vo_bound + i * vo_bound_stride, vo_bound_plane);
  }
}

/* ksl_product_drinvv_certified of n elements. */
static KSL_INLINED void ksl_product_drinvv_certified_many(ptrdiff_t n, const ksl_mat3x3_t *R,
    ptrdiff_t R_stride, const ksl_vec3_t *v, ptrdiff_t v_stride, ksl_vec3_t *vo,
    ptrdiff_t vo_stride, ksl_vec3_t *vo_bound, ptrdiff_t vo_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_product_drinvv_certified(R + i * R_stride, v + i * v_stride, vo + i * vo_stride,
        vo_bound + i * vo_bound_stride);
  }
}

static KSL_INLINED void ksl_product_drinvv_certified_planes(ptrdiff_t n, const double *R,
    ptrdiff_t R_plane, ptrdiff_t R_stride, const double *v, ptrdiff_t v_plane,
    ptrdiff_t v_stride, double *vo, ptrdiff_t vo_plane, ptrdiff_t vo_stride,
    double *vo_bound, ptrdiff_t vo_bound_plane, ptrdiff_t vo_bound_stride) {
  ksl_mat3x3_t R_i;
  if (n > 0) R_i = ksl_mat3x3_of_planes(R, R_plane);
  KSL_EACH_OF(n) {
    if (R_stride) R_i = ksl_mat3x3_of_planes(R + i * R_stride, R_plane);
    const ksl_vec3_t v_i = ksl_vec3_of_planes(v + i * v_stride, v_plane);
    ksl_vec3_t vo_i;
    ksl_vec3_t vo_bound_i;
    ksl_product_drinvv_certified(&R_i, &v_i, &vo_i, &vo_bound_i);
    ksl_vec3_to_planes(&vo_i, vo + i * vo_stride, vo_plane);
    ksl_vec3_to_planes(&vo_bound_i, vo_bound + i * vo_bound_stride, vo_bound_plane);
  }
}

/* ksl_product_drinvvinv_certified of n elements. */
static KSL_INLINED void ksl_product_drinvvinv_certified_many(ptrdiff_t n, const ksl_mat3x3_t *R,
    ptrdiff_t R_stride, const ksl_vec3_t *v, ptrdiff_t v_stride, ksl_vec3_t *vo,
    ptrdiff_t vo_stride, ksl_vec3_t *vo_bound, ptrdiff_t vo_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_product_drinvvinv_certified(R + i * R_stride, v + i * v_stride, vo + i * vo_stride,
        vo_bound + i * vo_bound_stride);
  }
}

static KSL_INLINED void ksl_product_drinvvinv_certified_planes(ptrdiff_t n, const double *R,
    ptrdiff_t R_plane, ptrdiff_t R_stride, const double *v, ptrdiff_t v_plane,
    ptrdiff_t v_stride, double *vo, ptrdiff_t vo_plane, ptrdiff_t vo_stride,
    double *vo_bound, ptrdiff_t vo_bound_plane, ptrdiff_t vo_bound_stride) {
  ksl_mat3x3_t R_i;
  if (n > 0) R_i = ksl_mat3x3_of_planes(R, R_plane);
  KSL_EACH_OF(n) {
    if (R_stride) R_i = ksl_mat3x3_of_planes(R + i * R_stride, R_plane);
    const ksl_vec3_t v_i = ksl_vec3_of_planes(v + i * v_stride, v_plane);
    ksl_vec3_t vo_i;
    ksl_vec3_t vo_bound_i;
    ksl_product_drinvvinv_certified(&R_i, &v_i, &vo_i, &vo_bound_i);
    ksl_vec3_to_planes(&vo_i, vo + i * vo_stride, vo_plane);
    ksl_vec3_to_planes(&vo_bound_i, vo_bound + i * vo_bound_stride, vo_bound_plane);
  }
}

/* ksl_product_dv_certified of n elements. */
static KSL_INLINED void ksl_product_dv_certified_many(ptrdiff_t n, const ksl_SE3_t *D,
    ptrdiff_t D_stride, const ksl_vec3_t *v, ptrdiff_t v_stride, ksl_vec3_t *vo,
    ptrdiff_t vo_stride, ksl_vec3_t *vo_bound, ptrdiff_t vo_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_product_dv_certified(D + i * D_stride, v + i * v_stride, vo + i * vo_stride,
        vo_bound + i * vo_bound_stride);
  }
}

static KSL_INLINED void ksl_product_dv_certified_planes(ptrdiff_t n, const double *D,
    ptrdiff_t D_plane, ptrdiff_t D_stride, const double *v, ptrdiff_t v_plane,
    ptrdiff_t v_stride, double *vo, ptrdiff_t vo_plane, ptrdiff_t vo_stride,
    double *vo_bound, ptrdiff_t vo_bound_plane, ptrdiff_t vo_bound_stride) {
  ksl_SE3_t D_i;
  if (n > 0) D_i = ksl_SE3_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3_of_planes(D + i * D_stride, D_plane);
    const ksl_vec3_t v_i = ksl_vec3_of_planes(v + i * v_stride, v_plane);
    ksl_vec3_t vo_i;
    ksl_vec3_t vo_bound_i;
    ksl_product_dv_certified(&D_i, &v_i, &vo_i, &vo_bound_i);
    ksl_vec3_to_planes(&vo_i, vo + i * vo_stride, vo_plane);
    ksl_vec3_to_planes(&vo_bound_i, vo_bound + i * vo_bound_stride, vo_bound_plane);
  }
}

/* ksl_product_dinvv_certified of n elements. */
static KSL_INLINED void ksl_product_dinvv_certified_many(ptrdiff_t n, const ksl_SE3_t *D,
    ptrdiff_t D_stride, const ksl_vec3_t *v, ptrdiff_t v_stride, ksl_vec3_t *vo,
    ptrdiff_t vo_stride, ksl_vec3_t *vo_bound, ptrdiff_t vo_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_product_dinvv_certified(D + i * D_stride, v + i * v_stride, vo + i * vo_stride,
        vo_bound + i * vo_bound_stride);
  }
}

static KSL_INLINED void ksl_product_dinvv_certified_planes(ptrdiff_t n, const double *D,
    ptrdiff_t D_plane, ptrdiff_t D_stride, const double *v, ptrdiff_t v_plane,
    ptrdiff_t v_stride, double *vo, ptrdiff_t vo_plane, ptrdiff_t vo_stride,
    double *vo_bound, ptrdiff_t vo_bound_plane, ptrdiff_t vo_bound_stride) {
  ksl_SE3_t D_i;
  if (n > 0) D_i = ksl_SE3_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3_of_planes(D + i * D_stride, D_plane);
    const ksl_vec3_t v_i = ksl_vec3_of_planes(v + i * v_stride, v_plane);
    ksl_vec3_t vo_i;
    ksl_vec3_t vo_bound_i;
    ksl_product_dinvv_certified(&D_i, &v_i, &vo_i, &vo_bound_i);
    ksl_vec3_to_planes(&vo_i, vo + i * vo_stride, vo_plane);
    ksl_vec3_to_planes(&vo_bound_i, vo_bound + i * vo_bound_stride, vo_bound_plane);
  }
}

/* ksl_product_drdr_certified of n elements. */
static KSL_INLINED void ksl_product_drdr_certified_many(ptrdiff_t n, const ksl_mat3x3_t *R1,
    ptrdiff_t R1_stride, const ksl_mat3x3_t *R2, ptrdiff_t R2_stride,
    ksl_mat3x3_t *Ro, ptrdiff_t Ro_stride, ksl_mat3x3_t *Ro_bound,
    ptrdiff_t Ro_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_product_drdr_certified(R1 + i * R1_stride, R2 + i * R2_stride, Ro + i * Ro_stride,
        Ro_bound + i * Ro_bound_stride);
  }
}

static KSL_INLINED void ksl_product_drdr_certified_planes(ptrdiff_t n, const double *R1,
    ptrdiff_t R1_plane, ptrdiff_t R1_stride, const double *R2,
    ptrdiff_t R2_plane, ptrdiff_t R2_stride, double *Ro, ptrdiff_t Ro_plane,
    ptrdiff_t Ro_stride, double *Ro_bound, ptrdiff_t Ro_bound_plane,
    ptrdiff_t Ro_bound_stride) {
  ksl_mat3x3_t R1_i;
  if (n > 0) R1_i = ksl_mat3x3_of_planes(R1, R1_plane);
  KSL_EACH_OF(n) {
    if (R1_stride) R1_i = ksl_mat3x3_of_planes(R1 + i * R1_stride, R1_plane);
    const ksl_mat3x3_t R2_i = ksl_mat3x3_of_planes(R2 + i * R2_stride, R2_plane);
    ksl_mat3x3_t Ro_i;
    ksl_mat3x3_t Ro_bound_i;
    ksl_product_drdr_certified(&R1_i, &R2_i, &Ro_i, &Ro_bound_i);
    ksl_mat3x3_to_planes(&Ro_i, Ro + i * Ro_stride, Ro_plane);
    ksl_mat3x3_to_planes(&Ro_bound_i, Ro_bound + i * Ro_bound_stride, Ro_bound_plane);
  }
}

/* ksl_product_drdrinv_certified of n elements. */
static KSL_INLINED void ksl_product_drdrinv_certified_many(ptrdiff_t n, const ksl_mat3x3_t *R1,
    ptrdiff_t R1_stride, const ksl_mat3x3_t *R2, ptrdiff_t R2_stride,
    ksl_mat3x3_t *Ro, ptrdiff_t Ro_stride, ksl_mat3x3_t *Ro_bound,
    ptrdiff_t Ro_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_product_drdrinv_certified(R1 + i * R1_stride, R2 + i * R2_stride, Ro + i * Ro_stride,
        Ro_bound + i * Ro_bound_stride);
  }
}

static KSL_INLINED void ksl_product_drdrinv_certified_planes(ptrdiff_t n, const double *R1,
    ptrdiff_t R1_plane, ptrdiff_t R1_stride, const double *R2,
    ptrdiff_t R2_plane, ptrdiff_t R2_stride, double *Ro, ptrdiff_t Ro_plane,
    ptrdiff_t Ro_stride, double *Ro_bound, ptrdiff_t Ro_bound_plane,
    ptrdiff_t Ro_bound_stride) {
  ksl_mat3x3_t R1_i;
  if (n > 0) R1_i = ksl_mat3x3_of_planes(R1, R1_plane);
  KSL_EACH_OF(n) {
    if (R1_stride) R1_i = ksl_mat3x3_of_planes(R1 + i * R1_stride, R1_plane);
    const ksl_mat3x3_t R2_i = ksl_mat3x3_of_planes(R2 + i * R2_stride, R2_plane);
    ksl_mat3x3_t Ro_i;
    ksl_mat3x3_t Ro_bound_i;
    ksl_product_drdrinv_certified(&R1_i, &R2_i, &Ro_i, &Ro_bound_i);
    ksl_mat3x3_to_planes(&Ro_i, Ro + i * Ro_stride, Ro_plane);
    ksl_mat3x3_to_planes(&Ro_bound_i, Ro_bound + i * Ro_bound_stride, Ro_bound_plane);
  }
}

/* ksl_product_drinvdr_certified of n elements. */
static KSL_INLINED void ksl_product_drinvdr_certified_many(ptrdiff_t n, const ksl_mat3x3_t *R1,
    ptrdiff_t R1_stride, const ksl_mat3x3_t *R2, ptrdiff_t R2_stride,
    ksl_mat3x3_t *Ro, ptrdiff_t Ro_stride, ksl_mat3x3_t *Ro_bound,
    ptrdiff_t Ro_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_product_drinvdr_certified(R1 + i * R1_stride, R2 + i * R2_stride, Ro + i * Ro_stride,
        Ro_bound + i * Ro_bound_stride);
  }
}

static KSL_INLINED void ksl_product_drinvdr_certified_planes(ptrdiff_t n, const double *R1,
    ptrdiff_t R1_plane, ptrdiff_t R1_stride, const double *R2,
    ptrdiff_t R2_plane, ptrdiff_t R2_stride, double *Ro, ptrdiff_t Ro_plane,
    ptrdiff_t Ro_stride, double *Ro_bound, ptrdiff_t Ro_bound_plane,
    ptrdiff_t Ro_bound_stride) {
  ksl_mat3x3_t R1_i;
  if (n > 0) R1_i = ksl_mat3x3_of_planes(R1, R1_plane);
  KSL_EACH_OF(n) {
    if (R1_stride) R1_i = ksl_mat3x3_of_planes(R1 + i * R1_stride, R1_plane);
    const ksl_mat3x3_t R2_i = ksl_mat3x3_of_planes(R2 + i * R2_stride, R2_plane);
    ksl_mat3x3_t Ro_i;
    ksl_mat3x3_t Ro_bound_i;
    ksl_product_drinvdr_certified(&R1_i, &R2_i, &Ro_i, &Ro_bound_i);
    ksl_mat3x3_to_planes(&Ro_i, Ro + i * Ro_stride, Ro_plane);
    ksl_mat3x3_to_planes(&Ro_bound_i, Ro_bound + i * Ro_bound_stride, Ro_bound_plane);
  }
}

/* ksl_product_dd_certified of n elements. */
static KSL_INLINED void ksl_product_dd_certified_many(ptrdiff_t n, const ksl_SE3_t *D1,
    ptrdiff_t D1_stride, const ksl_SE3_t *D2, ptrdiff_t D2_stride, ksl_SE3_t *Do,
    ptrdiff_t Do_stride, ksl_SE3_t *Do_bound, ptrdiff_t Do_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_product_dd_certified(D1 + i * D1_stride, D2 + i * D2_stride, Do + i * Do_stride,
        Do_bound + i * Do_bound_stride);
  }
}

static KSL_INLINED void ksl_product_dd_certified_planes(ptrdiff_t n, const double *D1,
    ptrdiff_t D1_plane, ptrdiff_t D1_stride, const double *D2,
    ptrdiff_t D2_plane, ptrdiff_t D2_stride, double *Do, ptrdiff_t Do_plane,
    ptrdiff_t Do_stride, double *Do_bound, ptrdiff_t Do_bound_plane,
    ptrdiff_t Do_bound_stride) {
  ksl_SE3_t D1_i;
  if (n > 0) D1_i = ksl_SE3_of_planes(D1, D1_plane);
  KSL_EACH_OF(n) {
    if (D1_stride) D1_i = ksl_SE3_of_planes(D1 + i * D1_stride, D1_plane);
    const ksl_SE3_t D2_i = ksl_SE3_of_planes(D2 + i * D2_stride, D2_plane);
    ksl_SE3_t Do_i;
    ksl_SE3_t Do_bound_i;
    ksl_product_dd_certified(&D1_i, &D2_i, &Do_i, &Do_bound_i);
    ksl_SE3_to_planes(&Do_i, Do + i * Do_stride, Do_plane);
    ksl_SE3_to_planes(&Do_bound_i, Do_bound + i * Do_bound_stride, Do_bound_plane);
  }
}

/* ksl_product_ddinv_certified of n elements. */
static KSL_INLINED void ksl_product_ddinv_certified_many(ptrdiff_t n, const ksl_SE3_t *D1,
    ptrdiff_t D1_stride, const ksl_SE3_t *D2, ptrdiff_t D2_stride, ksl_SE3_t *Do,
    ptrdiff_t Do_stride, ksl_SE3_t *Do_bound, ptrdiff_t Do_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_product_ddinv_certified(D1 + i * D1_stride, D2 + i * D2_stride, Do + i * Do_stride,
        Do_bound + i * Do_bound_stride);
  }
}

static KSL_INLINED void ksl_product_ddinv_certified_planes(ptrdiff_t n, const double *D1,
    ptrdiff_t D1_plane, ptrdiff_t D1_stride, const double *D2,
    ptrdiff_t D2_plane, ptrdiff_t D2_stride, double *Do, ptrdiff_t Do_plane,
    ptrdiff_t Do_stride, double *Do_bound, ptrdiff_t Do_bound_plane,
    ptrdiff_t Do_bound_stride) {
  ksl_SE3_t D1_i;
  if (n > 0) D1_i = ksl_SE3_of_planes(D1, D1_plane);
  KSL_EACH_OF(n) {
    if (D1_stride) D1_i = ksl_SE3_of_planes(D1 + i * D1_stride, D1_plane);
    const ksl_SE3_t D2_i = ksl_SE3_of_planes(D2 + i * D2_stride, D2_plane);
    ksl_SE3_t Do_i;
    ksl_SE3_t Do_bound_i;
    ksl_product_ddinv_certified(&D1_i, &D2_i, &Do_i, &Do_bound_i);
    ksl_SE3_to_planes(&Do_i, Do + i * Do_stride, Do_plane);
    ksl_SE3_to_planes(&Do_bound_i, Do_bound + i * Do_bound_stride, Do_bound_plane);
  }
}

/* ksl_product_dinvd_certified of n elements. */
static KSL_INLINED void ksl_product_dinvd_certified_many(ptrdiff_t n, const ksl_SE3_t *D1,
    ptrdiff_t D1_stride, const ksl_SE3_t *D2, ptrdiff_t D2_stride, ksl_SE3_t *Do,
    ptrdiff_t Do_stride, ksl_SE3_t *Do_bound, ptrdiff_t Do_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_product_dinvd_certified(D1 + i * D1_stride, D2 + i * D2_stride, Do + i * Do_stride,
        Do_bound + i * Do_bound_stride);
  }
}

static KSL_INLINED void ksl_product_dinvd_certified_planes(ptrdiff_t n, const double *D1,
    ptrdiff_t D1_plane, ptrdiff_t D1_stride, const double *D2,
    ptrdiff_t D2_plane, ptrdiff_t D2_stride, double *Do, ptrdiff_t Do_plane,
    ptrdiff_t Do_stride, double *Do_bound, ptrdiff_t Do_bound_plane,
    ptrdiff_t Do_bound_stride) {
  ksl_SE3_t D1_i;
  if (n > 0) D1_i = ksl_SE3_of_planes(D1, D1_plane);
  KSL_EACH_OF(n) {
    if (D1_stride) D1_i = ksl_SE3_of_planes(D1 + i * D1_stride, D1_plane);
    const ksl_SE3_t D2_i = ksl_SE3_of_planes(D2 + i * D2_stride, D2_plane);
    ksl_SE3_t Do_i;
    ksl_SE3_t Do_bound_i;
    ksl_product_dinvd_certified(&D1_i, &D2_i, &Do_i, &Do_bound_i);
    ksl_SE3_to_planes(&Do_i, Do + i * Do_stride, Do_plane);
    ksl_SE3_to_planes(&Do_bound_i, Do_bound + i * Do_bound_stride, Do_bound_plane);
  }
}

/* ksl_product_ddr_certified of n elements. */
static KSL_INLINED void ksl_product_ddr_certified_many(ptrdiff_t n, const ksl_SE3_t *D,
    ptrdiff_t D_stride, const ksl_mat3x3_t *R, ptrdiff_t R_stride, ksl_SE3_t *Do,
    ptrdiff_t Do_stride, ksl_SE3_t *Do_bound, ptrdiff_t Do_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_product_ddr_certified(D + i * D_stride, R + i * R_stride, Do + i * Do_stride,
        Do_bound + i * Do_bound_stride);
  }
}

static KSL_INLINED void ksl_product_ddr_certified_planes(ptrdiff_t n, const double *D,
    ptrdiff_t D_plane, ptrdiff_t D_stride, const double *R, ptrdiff_t R_plane,
    ptrdiff_t R_stride, double *Do, ptrdiff_t Do_plane, ptrdiff_t Do_stride,
    double *Do_bound, ptrdiff_t Do_bound_plane, ptrdiff_t Do_bound_stride) {
  ksl_SE3_t D_i;
  if (n > 0) D_i = ksl_SE3_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3_of_planes(D + i * D_stride, D_plane);
    const ksl_mat3x3_t R_i = ksl_mat3x3_of_planes(R + i * R_stride, R_plane);
    ksl_SE3_t Do_i;
    ksl_SE3_t Do_bound_i;
    ksl_product_ddr_certified(&D_i, &R_i, &Do_i, &Do_bound_i);
    ksl_SE3_to_planes(&Do_i, Do + i * Do_stride, Do_plane);
    ksl_SE3_to_planes(&Do_bound_i, Do_bound + i * Do_bound_stride, Do_bound_plane);
  }
}

/* ksl_product_ddrinv_certified of n elements. */
static KSL_INLINED void ksl_product_ddrinv_certified_many(ptrdiff_t n, const ksl_SE3_t *D,
    ptrdiff_t D_stride, const ksl_mat3x3_t *R, ptrdiff_t R_stride, ksl_SE3_t *Do,
    ptrdiff_t Do_stride, ksl_SE3_t *Do_bound, ptrdiff_t Do_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_product_ddrinv_certified(D + i * D_stride, R + i * R_stride, Do + i * Do_stride,
        Do_bound + i * Do_bound_stride);
  }
}

static KSL_INLINED void ksl_product_ddrinv_certified_planes(ptrdiff_t n, const double *D,
    ptrdiff_t D_plane, ptrdiff_t D_stride, const double *R, ptrdiff_t R_plane,
    ptrdiff_t R_stride, double *Do, ptrdiff_t Do_plane, ptrdiff_t Do_stride,
    double *Do_bound, ptrdiff_t Do_bound_plane, ptrdiff_t Do_bound_stride) {
  ksl_SE3_t D_i;
  if (n > 0) D_i = ksl_SE3_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3_of_planes(D + i * D_stride, D_plane);
    const ksl_mat3x3_t R_i = ksl_mat3x3_of_planes(R + i * R_stride, R_plane);
    ksl_SE3_t Do_i;
    ksl_SE3_t Do_bound_i;
    ksl_product_ddrinv_certified(&D_i, &R_i, &Do_i, &Do_bound_i);
    ksl_SE3_to_planes(&Do_i, Do + i * Do_stride, Do_plane);
    ksl_SE3_to_planes(&Do_bound_i, Do_bound + i * Do_bound_stride, Do_bound_plane);
  }
}

/* ksl_product_ddt_certified of n elements. */
static KSL_INLINED void ksl_product_ddt_certified_many(ptrdiff_t n, const ksl_SE3_t *D,
    ptrdiff_t D_stride, const ksl_vec3_t *t, ptrdiff_t t_stride, ksl_SE3_t *Do,
    ptrdiff_t Do_stride, ksl_SE3_t *Do_bound, ptrdiff_t Do_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_product_ddt_certified(D + i * D_stride, t + i * t_stride, Do + i * Do_stride,
        Do_bound + i * Do_bound_stride);
  }
}

static KSL_INLINED void ksl_product_ddt_certified_planes(ptrdiff_t n, const double *D,
    ptrdiff_t D_plane, ptrdiff_t D_stride, const double *t, ptrdiff_t t_plane,
    ptrdiff_t t_stride, double *Do, ptrdiff_t Do_plane, ptrdiff_t Do_stride,
    double *Do_bound, ptrdiff_t Do_bound_plane, ptrdiff_t Do_bound_stride) {
  ksl_SE3_t D_i;
  if (n > 0) D_i = ksl_SE3_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3_of_planes(D + i * D_stride, D_plane);
    const ksl_vec3_t t_i = ksl_vec3_of_planes(t + i * t_stride, t_plane);
    ksl_SE3_t Do_i;
    ksl_SE3_t Do_bound_i;
    ksl_product_ddt_certified(&D_i, &t_i, &Do_i, &Do_bound_i);
    ksl_SE3_to_planes(&Do_i, Do + i * Do_stride, Do_plane);
    ksl_SE3_to_planes(&Do_bound_i, Do_bound + i * Do_bound_stride, Do_bound_plane);
  }
}

/* ksl_product_ddtinv_certified of n elements. */
static KSL_INLINED void ksl_product_ddtinv_certified_many(ptrdiff_t n, const ksl_SE3_t *D,
    ptrdiff_t D_stride, const ksl_vec3_t *t, ptrdiff_t t_stride, ksl_SE3_t *Do,
    ptrdiff_t Do_stride, ksl_SE3_t *Do_bound, ptrdiff_t Do_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_product_ddtinv_certified(D + i * D_stride, t + i * t_stride, Do + i * Do_stride,
        Do_bound + i * Do_bound_stride);
  }
}

static KSL_INLINED void ksl_product_ddtinv_certified_planes(ptrdiff_t n, const double *D,
    ptrdiff_t D_plane, ptrdiff_t D_stride, const double *t, ptrdiff_t t_plane,
    ptrdiff_t t_stride, double *Do, ptrdiff_t Do_plane, ptrdiff_t Do_stride,
    double *Do_bound, ptrdiff_t Do_bound_plane, ptrdiff_t Do_bound_stride) {
  ksl_SE3_t D_i;
  if (n > 0) D_i = ksl_SE3_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3_of_planes(D + i * D_stride, D_plane);
    const ksl_vec3_t t_i = ksl_vec3_of_planes(t + i * t_stride, t_plane);
    ksl_SE3_t Do_i;
    ksl_SE3_t Do_bound_i;
    ksl_product_ddtinv_certified(&D_i, &t_i, &Do_i, &Do_bound_i);
    ksl_SE3_to_planes(&Do_i, Do + i * Do_stride, Do_plane);
    ksl_SE3_to_planes(&Do_bound_i, Do_bound + i * Do_bound_stride, Do_bound_plane);
  }
}

/* ksl_product_dinvdt_certified of n elements. */
static KSL_INLINED void ksl_product_dinvdt_certified_many(ptrdiff_t n, const ksl_SE3_t *D,
    ptrdiff_t D_stride, const ksl_vec3_t *t, ptrdiff_t t_stride, ksl_SE3_t *Do,
    ptrdiff_t Do_stride, ksl_SE3_t *Do_bound, ptrdiff_t Do_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_product_dinvdt_certified(D + i * D_stride, t + i * t_stride, Do + i * Do_stride,
        Do_bound + i * Do_bound_stride);
  }
}

static KSL_INLINED void ksl_product_dinvdt_certified_planes(ptrdiff_t n, const double *D,
    ptrdiff_t D_plane, ptrdiff_t D_stride, const double *t, ptrdiff_t t_plane,
    ptrdiff_t t_stride, double *Do, ptrdiff_t Do_plane, ptrdiff_t Do_stride,
    double *Do_bound, ptrdiff_t Do_bound_plane, ptrdiff_t Do_bound_stride) {
  ksl_SE3_t D_i;
  if (n > 0) D_i = ksl_SE3_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3_of_planes(D + i * D_stride, D_plane);
    const ksl_vec3_t t_i = ksl_vec3_of_planes(t + i * t_stride, t_plane);
    ksl_SE3_t Do_i;
    ksl_SE3_t Do_bound_i;
    ksl_product_dinvdt_certified(&D_i, &t_i, &Do_i, &Do_bound_i);
    ksl_SE3_to_planes(&Do_i, Do + i * Do_stride, Do_plane);
    ksl_SE3_to_planes(&Do_bound_i, Do_bound + i * Do_bound_stride, Do_bound_plane);
  }
}

/* ksl_product_drvtx_certified of n elements. */
static KSL_INLINED void ksl_product_drvtx_certified_many(ptrdiff_t n, const ksl_mat3x3_t *R,
    ptrdiff_t R_stride, const double *k, ptrdiff_t k_stride, ksl_vec3_t *vo,
    ptrdiff_t vo_stride, ksl_vec3_t *vo_bound, ptrdiff_t vo_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_product_drvtx_certified(R + i * R_stride, k[i * k_stride], vo + i * vo_stride,
        vo_bound + i * vo_bound_stride);
  }
}

static KSL_INLINED void ksl_product_drvtx_certified_planes(ptrdiff_t n, const double *R,
    ptrdiff_t R_plane, ptrdiff_t R_stride, const double *k, ptrdiff_t k_stride,
    double *vo, ptrdiff_t vo_plane, ptrdiff_t vo_stride, double *vo_bound,
    ptrdiff_t vo_bound_plane, ptrdiff_t vo_bound_stride) {
  ksl_mat3x3_t R_i;
  if (n > 0) R_i = ksl_mat3x3_of_planes(R, R_plane);
  KSL_EACH_OF(n) {
    if (R_stride) R_i = ksl_mat3x3_of_planes(R + i * R_stride, R_plane);
    ksl_vec3_t vo_i;
    ksl_vec3_t vo_bound_i;
    ksl_product_drvtx_certified(&R_i, k[i * k_stride], &vo_i, &vo_bound_i);
    ksl_vec3_to_planes(&vo_i, vo + i * vo_stride, vo_plane);
    ksl_vec3_to_planes(&vo_bound_i, vo_bound + i * vo_bound_stride, vo_bound_plane);
  }
}

/* ksl_product_drdrx_certified of n elements. */
static KSL_INLINED void ksl_product_drdrx_certified_many(ptrdiff_t n, const ksl_mat3x3_t *R,
    ptrdiff_t R_stride, const double *dc, ptrdiff_t dc_stride, ksl_mat3x3_t *Ro,
    ptrdiff_t Ro_stride, ksl_mat3x3_t *Ro_bound, ptrdiff_t Ro_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_product_drdrx_certified(R + i * R_stride, dc + 2 * i * dc_stride, Ro + i * Ro_stride,
        Ro_bound + i * Ro_bound_stride);
  }
}

static KSL_INLINED void ksl_product_drdrx_certified_planes(ptrdiff_t n, const double *R,
    ptrdiff_t R_plane, ptrdiff_t R_stride, const double *dc, ptrdiff_t dc_plane,
    ptrdiff_t dc_stride, double *Ro, ptrdiff_t Ro_plane, ptrdiff_t Ro_stride,
    double *Ro_bound, ptrdiff_t Ro_bound_plane, ptrdiff_t Ro_bound_stride) {
  ksl_mat3x3_t R_i;
  if (n > 0) R_i = ksl_mat3x3_of_planes(R, R_plane);
  KSL_EACH_OF(n) {
    if (R_stride) R_i = ksl_mat3x3_of_planes(R + i * R_stride, R_plane);
    const double dc_i[2] = {dc[0 + i * dc_stride], dc[dc_plane + i * dc_stride]};
    ksl_mat3x3_t Ro_i;
    ksl_mat3x3_t Ro_bound_i;
    ksl_product_drdrx_certified(&R_i, dc_i, &Ro_i, &Ro_bound_i);
    ksl_mat3x3_to_planes(&Ro_i, Ro + i * Ro_stride, Ro_plane);
    ksl_mat3x3_to_planes(&Ro_bound_i, Ro_bound + i * Ro_bound_stride, Ro_bound_plane);
  }
}

/* ksl_product_ddrx_certified of n elements. */
static KSL_INLINED void ksl_product_ddrx_certified_many(ptrdiff_t n, const ksl_SE3_t *D,
    ptrdiff_t D_stride, const double *dc, ptrdiff_t dc_stride, ksl_SE3_t *Do,
    ptrdiff_t Do_stride, ksl_SE3_t *Do_bound, ptrdiff_t Do_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_product_ddrx_certified(D + i * D_stride, dc + 2 * i * dc_stride, Do + i * Do_stride,
        Do_bound + i * Do_bound_stride);
  }
}

static KSL_INLINED void ksl_product_ddrx_certified_planes(ptrdiff_t n, const double *D,
    ptrdiff_t D_plane, ptrdiff_t D_stride, const double *dc, ptrdiff_t dc_plane,
    ptrdiff_t dc_stride, double *Do, ptrdiff_t Do_plane, ptrdiff_t Do_stride,
    double *Do_bound, ptrdiff_t Do_bound_plane, ptrdiff_t Do_bound_stride) {
  ksl_SE3_t D_i;
  if (n > 0) D_i = ksl_SE3_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3_of_planes(D + i * D_stride, D_plane);
    const double dc_i[2] = {dc[0 + i * dc_stride], dc[dc_plane + i * dc_stride]};
    ksl_SE3_t Do_i;
    ksl_SE3_t Do_bound_i;
    ksl_product_ddrx_certified(&D_i, dc_i, &Do_i, &Do_bound_i);
    ksl_SE3_to_planes(&Do_i, Do + i * Do_stride, Do_plane);
    ksl_SE3_to_planes(&Do_bound_i, Do_bound + i * Do_bound_stride, Do_bound_plane);
  }
}

/* ksl_product_ddtx_certified of n elements. */
static KSL_INLINED void ksl_product_ddtx_certified_many(ptrdiff_t n, const ksl_SE3_t *D,
    ptrdiff_t D_stride, const double *k, ptrdiff_t k_stride, ksl_SE3_t *Do,
    ptrdiff_t Do_stride, ksl_SE3_t *Do_bound, ptrdiff_t Do_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_product_ddtx_certified(D + i * D_stride, k[i * k_stride], Do + i * Do_stride,
        Do_bound + i * Do_bound_stride);
  }
}

static KSL_INLINED void ksl_product_ddtx_certified_planes(ptrdiff_t n, const double *D,
    ptrdiff_t D_plane, ptrdiff_t D_stride, const double *k, ptrdiff_t k_stride,
    double *Do, ptrdiff_t Do_plane, ptrdiff_t Do_stride, double *Do_bound,
    ptrdiff_t Do_bound_plane, ptrdiff_t Do_bound_stride) {
  ksl_SE3_t D_i;
  if (n > 0) D_i = ksl_SE3_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3_of_planes(D + i * D_stride, D_plane);
    ksl_SE3_t Do_i;
    ksl_SE3_t Do_bound_i;
    ksl_product_ddtx_certified(&D_i, k[i * k_stride], &Do_i, &Do_bound_i);
    ksl_SE3_to_planes(&Do_i, Do + i * Do_stride, Do_plane);
    ksl_SE3_to_planes(&Do_bound_i, Do_bound + i * Do_bound_stride, Do_bound_plane);
  }
}

/* ksl_product_drvtxinv_certified of n elements. */
static KSL_INLINED void ksl_product_drvtxinv_certified_many(ptrdiff_t n, const ksl_mat3x3_t *R,
    ptrdiff_t R_stride, const double *k, ptrdiff_t k_stride, ksl_vec3_t *vo,
    ptrdiff_t vo_stride, ksl_vec3_t *vo_bound, ptrdiff_t vo_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_product_drvtxinv_certified(R + i * R_stride, k[i * k_stride], vo + i * vo_stride,
        vo_bound + i * vo_bound_stride);
  }
}

static KSL_INLINED void ksl_product_drvtxinv_certified_planes(ptrdiff_t n, const double *R,
    ptrdiff_t R_plane, ptrdiff_t R_stride, const double *k, ptrdiff_t k_stride,
    double *vo, ptrdiff_t vo_plane, ptrdiff_t vo_stride, double *vo_bound,
    ptrdiff_t vo_bound_plane, ptrdiff_t vo_bound_stride) {
  ksl_mat3x3_t R_i;
  if (n > 0) R_i = ksl_mat3x3_of_planes(R, R_plane);
  KSL_EACH_OF(n) {
    if (R_stride) R_i = ksl_mat3x3_of_planes(R + i * R_stride, R_plane);
    ksl_vec3_t vo_i;
    ksl_vec3_t vo_bound_i;
    ksl_product_drvtxinv_certified(&R_i, k[i * k_stride], &vo_i, &vo_bound_i);
    ksl_vec3_to_planes(&vo_i, vo + i * vo_stride, vo_plane);
    ksl_vec3_to_planes(&vo_bound_i, vo_bound + i * vo_bound_stride, vo_bound_plane);
  }
}

/* ksl_product_drdrxinv_certified of n elements. */
static KSL_INLINED void ksl_product_drdrxinv_certified_many(ptrdiff_t n, const ksl_mat3x3_t *R,
    ptrdiff_t R_stride, const double *dc, ptrdiff_t dc_stride, ksl_mat3x3_t *Ro,
    ptrdiff_t Ro_stride, ksl_mat3x3_t *Ro_bound, ptrdiff_t Ro_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_product_drdrxinv_certified(R + i * R_stride, dc + 2 * i * dc_stride, Ro + i * Ro_stride,
        Ro_bound + i * Ro_bound_stride);
  }
}

static KSL_INLINED void ksl_product_drdrxinv_certified_planes(ptrdiff_t n, const double *R,
    ptrdiff_t R_plane, ptrdiff_t R_stride, const double *dc, ptrdiff_t dc_plane,
    ptrdiff_t dc_stride, double *Ro, ptrdiff_t Ro_plane, ptrdiff_t Ro_stride,
    double *Ro_bound, ptrdiff_t Ro_bound_plane, ptrdiff_t Ro_bound_stride) {
  ksl_mat3x3_t R_i;
  if (n > 0) R_i = ksl_mat3x3_of_planes(R, R_plane);
  KSL_EACH_OF(n) {
    if (R_stride) R_i = ksl_mat3x3_of_planes(R + i * R_stride, R_plane);
    const double dc_i[2] = {dc[0 + i * dc_stride], dc[dc_plane + i * dc_stride]};
    ksl_mat3x3_t Ro_i;
    ksl_mat3x3_t Ro_bound_i;
    ksl_product_drdrxinv_certified(&R_i, dc_i, &Ro_i, &Ro_bound_i);
    ksl_mat3x3_to_planes(&Ro_i, Ro + i * Ro_stride, Ro_plane);
    ksl_mat3x3_to_planes(&Ro_bound_i, Ro_bound + i * Ro_bound_stride, Ro_bound_plane);
  }
}

/* ksl_product_ddrxinv_certified of n elements. */
static KSL_INLINED void ksl_product_ddrxinv_certified_many(ptrdiff_t n, const ksl_SE3_t *D,
    ptrdiff_t D_stride, const double *dc, ptrdiff_t dc_stride, ksl_SE3_t *Do,
    ptrdiff_t Do_stride, ksl_SE3_t *Do_bound, ptrdiff_t Do_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_product_ddrxinv_certified(D + i * D_stride, dc + 2 * i * dc_stride, Do + i * Do_stride,
        Do_bound + i * Do_bound_stride);
  }
}

static KSL_INLINED void ksl_product_ddrxinv_certified_planes(ptrdiff_t n, const double *D,
    ptrdiff_t D_plane, ptrdiff_t D_stride, const double *dc, ptrdiff_t dc_plane,
    ptrdiff_t dc_stride, double *Do, ptrdiff_t Do_plane, ptrdiff_t Do_stride,
    double *Do_bound, ptrdiff_t Do_bound_plane, ptrdiff_t Do_bound_stride) {
  ksl_SE3_t D_i;
  if (n > 0) D_i = ksl_SE3_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3_of_planes(D + i * D_stride, D_plane);
    const double dc_i[2] = {dc[0 + i * dc_stride], dc[dc_plane + i * dc_stride]};
    ksl_SE3_t Do_i;
    ksl_SE3_t Do_bound_i;
    ksl_product_ddrxinv_certified(&D_i, dc_i, &Do_i, &Do_bound_i);
    ksl_SE3_to_planes(&Do_i, Do + i * Do_stride, Do_plane);
    ksl_SE3_to_planes(&Do_bound_i, Do_bound + i * Do_bound_stride, Do_bound_plane);
  }
}

/* ksl_product_ddtxinv_certified of n elements. */
static KSL_INLINED void ksl_product_ddtxinv_certified_many(ptrdiff_t n, const ksl_SE3_t *D,
    ptrdiff_t D_stride, const double *k, ptrdiff_t k_stride, ksl_SE3_t *Do,
    ptrdiff_t Do_stride, ksl_SE3_t *Do_bound, ptrdiff_t Do_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_product_ddtxinv_certified(D + i * D_stride, k[i * k_stride], Do + i * Do_stride,
        Do_bound + i * Do_bound_stride);
  }
}

static KSL_INLINED void ksl_product_ddtxinv_certified_planes(ptrdiff_t n, const double *D,
    ptrdiff_t D_plane, ptrdiff_t D_stride, const double *k, ptrdiff_t k_stride,
    double *Do, ptrdiff_t Do_plane, ptrdiff_t Do_stride, double *Do_bound,
    ptrdiff_t Do_bound_plane, ptrdiff_t Do_bound_stride) {
  ksl_SE3_t D_i;
  if (n > 0) D_i = ksl_SE3_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3_of_planes(D + i * D_stride, D_plane);
    ksl_SE3_t Do_i;
    ksl_SE3_t Do_bound_i;
    ksl_product_ddtxinv_certified(&D_i, k[i * k_stride], &Do_i, &Do_bound_i);
    ksl_SE3_to_planes(&Do_i, Do + i * Do_stride, Do_plane);
    ksl_SE3_to_planes(&Do_bound_i, Do_bound + i * Do_bound_stride, Do_bound_plane);
  }
}

/* ksl_product_drvty_certified of n elements. */
static KSL_INLINED void ksl_product_drvty_certified_many(ptrdiff_t n, const ksl_mat3x3_t *R,
    ptrdiff_t R_stride, const double *k, ptrdiff_t k_stride, ksl_vec3_t *vo,
    ptrdiff_t vo_stride, ksl_vec3_t *vo_bound, ptrdiff_t vo_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_product_drvty_certified(R + i * R_stride, k[i * k_stride], vo + i * vo_stride,
        vo_bound + i * vo_bound_stride);
  }
}

static KSL_INLINED void ksl_product_drvty_certified_planes(ptrdiff_t n, const double *R,
    ptrdiff_t R_plane, ptrdiff_t R_stride, const double *k, ptrdiff_t k_stride,
    double *vo, ptrdiff_t vo_plane, ptrdiff_t vo_stride, double *vo_bound,
    ptrdiff_t vo_bound_plane, ptrdiff_t vo_bound_stride) {
  ksl_mat3x3_t R_i;
  if (n > 0) R_i = ksl_mat3x3_of_planes(R, R_plane);
  KSL_EACH_OF(n) {
    if (R_stride) R_i = ksl_mat3x3_of_planes(R + i * R_stride, R_plane);
    ksl_vec3_t vo_i;
    ksl_vec3_t vo_bound_i;
    ksl_product_drvty_certified(&R_i, k[i * k_stride], &vo_i, &vo_bound_i);
    ksl_vec3_to_planes(&vo_i, vo + i * vo_stride, vo_plane);
    ksl_vec3_to_planes(&vo_bound_i, vo_bound + i * vo_bound_stride, vo_bound_plane);
  }
}

/* ksl_product_drdry_certified of n elements. */
static KSL_INLINED void ksl_product_drdry_certified_many(ptrdiff_t n, const ksl_mat3x3_t *R,
    ptrdiff_t R_stride, const double *dc, ptrdiff_t dc_stride, ksl_mat3x3_t *Ro,
    ptrdiff_t Ro_stride, ksl_mat3x3_t *Ro_bound, ptrdiff_t Ro_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_product_drdry_certified(R + i * R_stride, dc + 2 * i * dc_stride, Ro + i * Ro_stride,
        Ro_bound + i * Ro_bound_stride);
  }
}

static KSL_INLINED void ksl_product_drdry_certified_planes(ptrdiff_t n, const double *R,
    ptrdiff_t R_plane, ptrdiff_t R_stride, const double *dc, ptrdiff_t dc_plane,
    ptrdiff_t dc_stride, double *Ro, ptrdiff_t Ro_plane, ptrdiff_t Ro_stride,
    double *Ro_bound, ptrdiff_t Ro_bound_plane, ptrdiff_t Ro_bound_stride) {
  ksl_mat3x3_t R_i;
  if (n > 0) R_i = ksl_mat3x3_of_planes(R, R_plane);
  KSL_EACH_OF(n) {
    if (R_stride) R_i = ksl_mat3x3_of_planes(R + i * R_stride, R_plane);
    const double dc_i[2] = {dc[0 + i * dc_stride], dc[dc_plane + i * dc_stride]};
    ksl_mat3x3_t Ro_i;
    ksl_mat3x3_t Ro_bound_i;
    ksl_product_drdry_certified(&R_i, dc_i, &Ro_i, &Ro_bound_i);
    ksl_mat3x3_to_planes(&Ro_i, Ro + i * Ro_stride, Ro_plane);
    ksl_mat3x3_to_planes(&Ro_bound_i, Ro_bound + i * Ro_bound_stride, Ro_bound_plane);
  }
}

/* ksl_product_ddry_certified of n elements. */
static KSL_INLINED void ksl_product_ddry_certified_many(ptrdiff_t n, const ksl_SE3_t *D,
    ptrdiff_t D_stride, const double *dc, ptrdiff_t dc_stride, ksl_SE3_t *Do,
    ptrdiff_t Do_stride, ksl_SE3_t *Do_bound, ptrdiff_t Do_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_product_ddry_certified(D + i * D_stride, dc + 2 * i * dc_stride, Do + i * Do_stride,
        Do_bound + i * Do_bound_stride);
  }
}

static KSL_INLINED void ksl_product_ddry_certified_planes(ptrdiff_t n, const double *D,
    ptrdiff_t D_plane, ptrdiff_t D_stride, const double *dc, ptrdiff_t dc_plane,
    ptrdiff_t dc_stride, double *Do, ptrdiff_t Do_plane, ptrdiff_t Do_stride,
    double *Do_bound, ptrdiff_t Do_bound_plane, ptrdiff_t Do_bound_stride) {
  ksl_SE3_t D_i;
  if (n > 0) D_i = ksl_SE3_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3_of_planes(D + i * D_stride, D_plane);
    const double dc_i[2] = {dc[0 + i * dc_stride], dc[dc_plane + i * dc_stride]};
    ksl_SE3_t Do_i;
    ksl_SE3_t Do_bound_i;
    ksl_product_ddry_certified(&D_i, dc_i, &Do_i, &Do_bound_i);
    ksl_SE3_to_planes(&Do_i, Do + i * Do_stride, Do_plane);
    ksl_SE3_to_planes(&Do_bound_i, Do_bound + i * Do_bound_stride, Do_bound_plane);
  }
}

/* ksl_product_ddty_certified of n elements. */
static KSL_INLINED void ksl_product_ddty_certified_many(ptrdiff_t n, const ksl_SE3_t *D,
    ptrdiff_t D_stride, const double *k, ptrdiff_t k_stride, ksl_SE3_t *Do,
    ptrdiff_t Do_stride, ksl_SE3_t *Do_bound, ptrdiff_t Do_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_product_ddty_certified(D + i * D_stride, k[i * k_stride], Do + i * Do_stride,
        Do_bound + i * Do_bound_stride);
  }
}

static KSL_INLINED void ksl_product_ddty_certified_planes(ptrdiff_t n, const double *D,
    ptrdiff_t D_plane, ptrdiff_t D_stride, const double *k, ptrdiff_t k_stride,
    double *Do, ptrdiff_t Do_plane, ptrdiff_t Do_stride, double *Do_bound,
    ptrdiff_t Do_bound_plane, ptrdiff_t Do_bound_stride) {
  ksl_SE3_t D_i;
  if (n > 0) D_i = ksl_SE3_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3_of_planes(D + i * D_stride, D_plane);
    ksl_SE3_t Do_i;
    ksl_SE3_t Do_bound_i;
    ksl_product_ddty_certified(&D_i, k[i * k_stride], &Do_i, &Do_bound_i);
    ksl_SE3_to_planes(&Do_i, Do + i * Do_stride, Do_plane);
    ksl_SE3_to_planes(&Do_bound_i, Do_bound + i * Do_bound_stride, Do_bound_plane);
  }
}

/* ksl_product_drvtyinv_certified of n elements. */
static KSL_INLINED void ksl_product_drvtyinv_certified_many(ptrdiff_t n, const ksl_mat3x3_t *R,
    ptrdiff_t R_stride, const double *k, ptrdiff_t k_stride, ksl_vec3_t *vo,
    ptrdiff_t vo_stride, ksl_vec3_t *vo_bound, ptrdiff_t vo_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_product_drvtyinv_certified(R + i * R_stride, k[i * k_stride], vo + i * vo_stride,
        vo_bound + i * vo_bound_stride);
  }
}

static KSL_INLINED void ksl_product_drvtyinv_certified_planes(ptrdiff_t n, const double *R,
    ptrdiff_t R_plane, ptrdiff_t R_stride, const double *k, ptrdiff_t k_stride,
    double *vo, ptrdiff_t vo_plane, ptrdiff_t vo_stride, double *vo_bound,
    ptrdiff_t vo_bound_plane, ptrdiff_t vo_bound_stride) {
  ksl_mat3x3_t R_i;
  if (n > 0) R_i = ksl_mat3x3_of_planes(R, R_plane);
  KSL_EACH_OF(n) {
    if (R_stride) R_i = ksl_mat3x3_of_planes(R + i * R_stride, R_plane);
    ksl_vec3_t vo_i;
    ksl_vec3_t vo_bound_i;
    ksl_product_drvtyinv_certified(&R_i, k[i * k_stride], &vo_i, &vo_bound_i);
    ksl_vec3_to_planes(&vo_i, vo + i * vo_stride, vo_plane);
    ksl_vec3_to_planes(&vo_bound_i, vo_bound + i * vo_bound_stride, vo_bound_plane);
  }
}

/* ksl_product_drdryinv_certified of n elements. */
static KSL_INLINED void ksl_product_drdryinv_certified_many(ptrdiff_t n, const ksl_mat3x3_t *R,
    ptrdiff_t R_stride, const double *dc, ptrdiff_t dc_stride, ksl_mat3x3_t *Ro,
    ptrdiff_t Ro_stride, ksl_mat3x3_t *Ro_bound, ptrdiff_t Ro_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_product_drdryinv_certified(R + i * R_stride, dc + 2 * i * dc_stride, Ro + i * Ro_stride,
        Ro_bound + i * Ro_bound_stride);
  }
}

static KSL_INLINED void ksl_product_drdryinv_certified_planes(ptrdiff_t n, const double *R,
    ptrdiff_t R_plane, ptrdiff_t R_stride, const double *dc, ptrdiff_t dc_plane,
    ptrdiff_t dc_stride, double *Ro, ptrdiff_t Ro_plane, ptrdiff_t Ro_stride,
    double *Ro_bound, ptrdiff_t Ro_bound_plane, ptrdiff_t Ro_bound_stride) {
  ksl_mat3x3_t R_i;
  if (n > 0) R_i = ksl_mat3x3_of_planes(R, R_plane);
  KSL_EACH_OF(n) {
    if (R_stride) R_i = ksl_mat3x3_of_planes(R + i * R_stride, R_plane);
    const double dc_i[2] = {dc[0 + i * dc_stride], dc[dc_plane + i * dc_stride]};
    ksl_mat3x3_t Ro_i;
    ksl_mat3x3_t Ro_bound_i;
    ksl_product_drdryinv_certified(&R_i, dc_i, &Ro_i, &Ro_bound_i);
    ksl_mat3x3_to_planes(&Ro_i, Ro + i * Ro_stride, Ro_plane);
    ksl_mat3x3_to_planes(&Ro_bound_i, Ro_bound + i * Ro_bound_stride, Ro_bound_plane);
  }
}

/* ksl_product_ddryinv_certified of n elements. */
static KSL_INLINED void ksl_product_ddryinv_certified_many(ptrdiff_t n, const ksl_SE3_t *D,
    ptrdiff_t D_stride, const double *dc, ptrdiff_t dc_stride, ksl_SE3_t *Do,
    ptrdiff_t Do_stride, ksl_SE3_t *Do_bound, ptrdiff_t Do_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_product_ddryinv_certified(D + i * D_stride, dc + 2 * i * dc_stride, Do + i * Do_stride,
        Do_bound + i * Do_bound_stride);
  }
}

static KSL_INLINED void ksl_product_ddryinv_certified_planes(ptrdiff_t n, const double *D,
    ptrdiff_t D_plane, ptrdiff_t D_stride, const double *dc, ptrdiff_t dc_plane,
    ptrdiff_t dc_stride, double *Do, ptrdiff_t Do_plane, ptrdiff_t Do_stride,
    double *Do_bound, ptrdiff_t Do_bound_plane, ptrdiff_t Do_bound_stride) {
  ksl_SE3_t D_i;
  if (n > 0) D_i = ksl_SE3_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3_of_planes(D + i * D_stride, D_plane);
    const double dc_i[2] = {dc[0 + i * dc_stride], dc[dc_plane + i * dc_stride]};
    ksl_SE3_t Do_i;
    ksl_SE3_t Do_bound_i;
    ksl_product_ddryinv_certified(&D_i, dc_i, &Do_i, &Do_bound_i);
    ksl_SE3_to_planes(&Do_i, Do + i * Do_stride, Do_plane);
    ksl_SE3_to_planes(&Do_bound_i, Do_bound + i * Do_bound_stride, Do_bound_plane);
  }
}

/* ksl_product_ddtyinv_certified of n elements. */
static KSL_INLINED void ksl_product_ddtyinv_certified_many(ptrdiff_t n, const ksl_SE3_t *D,
    ptrdiff_t D_stride, const double *k, ptrdiff_t k_stride, ksl_SE3_t *Do,
    ptrdiff_t Do_stride, ksl_SE3_t *Do_bound, ptrdiff_t Do_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_product_ddtyinv_certified(D + i * D_stride, k[i * k_stride], Do + i * Do_stride,
        Do_bound + i * Do_bound_stride);
  }
}

static KSL_INLINED void ksl_product_ddtyinv_certified_planes(ptrdiff_t n, const double *D,
    ptrdiff_t D_plane, ptrdiff_t D_stride, const double *k, ptrdiff_t k_stride,
    double *Do, ptrdiff_t Do_plane, ptrdiff_t Do_stride, double *Do_bound,
    ptrdiff_t Do_bound_plane, ptrdiff_t Do_bound_stride) {
  ksl_SE3_t D_i;
  if (n > 0) D_i = ksl_SE3_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3_of_planes(D + i * D_stride, D_plane);
    ksl_SE3_t Do_i;
    ksl_SE3_t Do_bound_i;
    ksl_product_ddtyinv_certified(&D_i, k[i * k_stride], &Do_i, &Do_bound_i);
    ksl_SE3_to_planes(&Do_i, Do + i * Do_stride, Do_plane);
    ksl_SE3_to_planes(&Do_bound_i, Do_bound + i * Do_bound_stride, Do_bound_plane);
  }
}

/* ksl_product_drvtz_certified of n elements. */
static KSL_INLINED void ksl_product_drvtz_certified_many(ptrdiff_t n, const ksl_mat3x3_t *R,
    ptrdiff_t R_stride, const double *k, ptrdiff_t k_stride, ksl_vec3_t *vo,
    ptrdiff_t vo_stride, ksl_vec3_t *vo_bound, ptrdiff_t vo_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_product_drvtz_certified(R + i * R_stride, k[i * k_stride], vo + i * vo_stride,
        vo_bound + i * vo_bound_stride);
  }
}

static KSL_INLINED void ksl_product_drvtz_certified_planes(ptrdiff_t n, const double *R,
    ptrdiff_t R_plane, ptrdiff_t R_stride, const double *k, ptrdiff_t k_stride,
    double *vo, ptrdiff_t vo_plane, ptrdiff_t vo_stride, double *vo_bound,
    ptrdiff_t vo_bound_plane, ptrdiff_t vo_bound_stride) {
  ksl_mat3x3_t R_i;
  if (n > 0) R_i = ksl_mat3x3_of_planes(R, R_plane);
  KSL_EACH_OF(n) {
    if (R_stride) R_i = ksl_mat3x3_of_planes(R + i * R_stride, R_plane);
    ksl_vec3_t vo_i;
    ksl_vec3_t vo_bound_i;
    ksl_product_drvtz_certified(&R_i, k[i * k_stride], &vo_i, &vo_bound_i);
    ksl_vec3_to_planes(&vo_i, vo + i * vo_stride, vo_plane);
    ksl_vec3_to_planes(&vo_bound_i, vo_bound + i * vo_bound_stride, vo_bound_plane);
  }
}

/* ksl_product_drdrz_certified of n elements. */
static KSL_INLINED void ksl_product_drdrz_certified_many(ptrdiff_t n, const ksl_mat3x3_t *R,
    ptrdiff_t R_stride, const double *dc, ptrdiff_t dc_stride, ksl_mat3x3_t *Ro,
    ptrdiff_t Ro_stride, ksl_mat3x3_t *Ro_bound, ptrdiff_t Ro_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_product_drdrz_certified(R + i * R_stride, dc + 2 * i * dc_stride, Ro + i * Ro_stride,
        Ro_bound + i * Ro_bound_stride);
  }
}

static KSL_INLINED void ksl_product_drdrz_certified_planes(ptrdiff_t n, const double *R,
    ptrdiff_t R_plane, ptrdiff_t R_stride, const double *dc, ptrdiff_t dc_plane,
    ptrdiff_t dc_stride, double *Ro, ptrdiff_t Ro_plane, ptrdiff_t Ro_stride,
    double *Ro_bound, ptrdiff_t Ro_bound_plane, ptrdiff_t Ro_bound_stride) {
  ksl_mat3x3_t R_i;
  if (n > 0) R_i = ksl_mat3x3_of_planes(R, R_plane);
  KSL_EACH_OF(n) {
    if (R_stride) R_i = ksl_mat3x3_of_planes(R + i * R_stride, R_plane);
    const double dc_i[2] = {dc[0 + i * dc_stride], dc[dc_plane + i * dc_stride]};
    ksl_mat3x3_t Ro_i;
    ksl_mat3x3_t Ro_bound_i;
    ksl_product_drdrz_certified(&R_i, dc_i, &Ro_i, &Ro_bound_i);
    ksl_mat3x3_to_planes(&Ro_i, Ro + i * Ro_stride, Ro_plane);
    ksl_mat3x3_to_planes(&Ro_bound_i, Ro_bound + i * Ro_bound_stride, Ro_bound_plane);
  }
}

/* ksl_product_ddrz_certified of n elements. */
static KSL_INLINED void ksl_product_ddrz_certified_many(ptrdiff_t n, const ksl_SE3_t *D,
    ptrdiff_t D_stride, const double *dc, ptrdiff_t dc_stride, ksl_SE3_t *Do,
    ptrdiff_t Do_stride, ksl_SE3_t *Do_bound, ptrdiff_t Do_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_product_ddrz_certified(D + i * D_stride, dc + 2 * i * dc_stride, Do + i * Do_stride,
        Do_bound + i * Do_bound_stride);
  }
}

static KSL_INLINED void ksl_product_ddrz_certified_planes(ptrdiff_t n, const double *D,
    ptrdiff_t D_plane, ptrdiff_t D_stride, const double *dc, ptrdiff_t dc_plane,
    ptrdiff_t dc_stride, double *Do, ptrdiff_t Do_plane, ptrdiff_t Do_stride,
    double *Do_bound, ptrdiff_t Do_bound_plane, ptrdiff_t Do_bound_stride) {
  ksl_SE3_t D_i;
  if (n > 0) D_i = ksl_SE3_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3_of_planes(D + i * D_stride, D_plane);
    const double dc_i[2] = {dc[0 + i * dc_stride], dc[dc_plane + i * dc_stride]};
    ksl_SE3_t Do_i;
    ksl_SE3_t Do_bound_i;
    ksl_product_ddrz_certified(&D_i, dc_i, &Do_i, &Do_bound_i);
    ksl_SE3_to_planes(&Do_i, Do + i * Do_stride, Do_plane);
    ksl_SE3_to_planes(&Do_bound_i, Do_bound + i * Do_bound_stride, Do_bound_plane);
  }
}

/* ksl_product_ddtz_certified of n elements. */
static KSL_INLINED void ksl_product_ddtz_certified_many(ptrdiff_t n, const ksl_SE3_t *D,
    ptrdiff_t D_stride, const double *k, ptrdiff_t k_stride, ksl_SE3_t *Do,
    ptrdiff_t Do_stride, ksl_SE3_t *Do_bound, ptrdiff_t Do_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_product_ddtz_certified(D + i * D_stride, k[i * k_stride], Do + i * Do_stride,
        Do_bound + i * Do_bound_stride);
  }
}

static KSL_INLINED void ksl_product_ddtz_certified_planes(ptrdiff_t n, const double *D,
    ptrdiff_t D_plane, ptrdiff_t D_stride, const double *k, ptrdiff_t k_stride,
    double *Do, ptrdiff_t Do_plane, ptrdiff_t Do_stride, double *Do_bound,
    ptrdiff_t Do_bound_plane, ptrdiff_t Do_bound_stride) {
  ksl_SE3_t D_i;
  if (n > 0) D_i = ksl_SE3_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3_of_planes(D + i * D_stride, D_plane);
    ksl_SE3_t Do_i;
    ksl_SE3_t Do_bound_i;
    ksl_product_ddtz_certified(&D_i, k[i * k_stride], &Do_i, &Do_bound_i);
    ksl_SE3_to_planes(&Do_i, Do + i * Do_stride, Do_plane);
    ksl_SE3_to_planes(&Do_bound_i, Do_bound + i * Do_bound_stride, Do_bound_plane);
  }
}

/* ksl_product_drvtzinv_certified of n elements. */
static KSL_INLINED void ksl_product_drvtzinv_certified_many(ptrdiff_t n, const ksl_mat3x3_t *R,
    ptrdiff_t R_stride, const double *k, ptrdiff_t k_stride, ksl_vec3_t *vo,
    ptrdiff_t vo_stride, ksl_vec3_t *vo_bound, ptrdiff_t vo_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_product_drvtzinv_certified(R + i * R_stride, k[i * k_stride], vo + i * vo_stride,
        vo_bound + i * vo_bound_stride);
  }
}

static KSL_INLINED void ksl_product_drvtzinv_certified_planes(ptrdiff_t n, const double *R,
    ptrdiff_t R_plane, ptrdiff_t R_stride, const double *k, ptrdiff_t k_stride,
    double *vo, ptrdiff_t vo_plane, ptrdiff_t vo_stride, double *vo_bound,
    ptrdiff_t vo_bound_plane, ptrdiff_t vo_bound_stride) {
  ksl_mat3x3_t R_i;
  if (n > 0) R_i = ksl_mat3x3_of_planes(R, R_plane);
  KSL_EACH_OF(n) {
    if (R_stride) R_i = ksl_mat3x3_of_planes(R + i * R_stride, R_plane);
    ksl_vec3_t vo_i;
    ksl_vec3_t vo_bound_i;
    ksl_product_drvtzinv_certified(&R_i, k[i * k_stride], &vo_i, &vo_bound_i);
    ksl_vec3_to_planes(&vo_i, vo + i * vo_stride, vo_plane);
    ksl_vec3_to_planes(&vo_bound_i, vo_bound + i * vo_bound_stride, vo_bound_plane);
  }
}

/* ksl_product_drdrzinv_certified of n elements. */
static KSL_INLINED void ksl_product_drdrzinv_certified_many(ptrdiff_t n, const ksl_mat3x3_t *R,
    ptrdiff_t R_stride, const double *dc, ptrdiff_t dc_stride, ksl_mat3x3_t *Ro,
    ptrdiff_t Ro_stride, ksl_mat3x3_t *Ro_bound, ptrdiff_t Ro_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_product_drdrzinv_certified(R + i * R_stride, dc + 2 * i * dc_stride, Ro + i * Ro_stride,
        Ro_bound + i * Ro_bound_stride);
  }
}

static KSL_INLINED void ksl_product_drdrzinv_certified_planes(ptrdiff_t n, const double *R,
    ptrdiff_t R_plane, ptrdiff_t R_stride, const double *dc, ptrdiff_t dc_plane,
    ptrdiff_t dc_stride, double *Ro, ptrdiff_t Ro_plane, ptrdiff_t Ro_stride,
    double *Ro_bound, ptrdiff_t Ro_bound_plane, ptrdiff_t Ro_bound_stride) {
  ksl_mat3x3_t R_i;
  if (n > 0) R_i = ksl_mat3x3_of_planes(R, R_plane);
  KSL_EACH_OF(n) {
    if (R_stride) R_i = ksl_mat3x3_of_planes(R + i * R_stride, R_plane);
    const double dc_i[2] = {dc[0 + i * dc_stride], dc[dc_plane + i * dc_stride]};
    ksl_mat3x3_t Ro_i;
    ksl_mat3x3_t Ro_bound_i;
    ksl_product_drdrzinv_certified(&R_i, dc_i, &Ro_i, &Ro_bound_i);
    ksl_mat3x3_to_planes(&Ro_i, Ro + i * Ro_stride, Ro_plane);
    ksl_mat3x3_to_planes(&Ro_bound_i, Ro_bound + i * Ro_bound_stride, Ro_bound_plane);
  }
}

/* ksl_product_ddrzinv_certified of n elements. */
static KSL_INLINED void ksl_product_ddrzinv_certified_many(ptrdiff_t n, const ksl_SE3_t *D,
    ptrdiff_t D_stride, const double *dc, ptrdiff_t dc_stride, ksl_SE3_t *Do,
    ptrdiff_t Do_stride, ksl_SE3_t *Do_bound, ptrdiff_t Do_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_product_ddrzinv_certified(D + i * D_stride, dc + 2 * i * dc_stride, Do + i * Do_stride,
        Do_bound + i * Do_bound_stride);
  }
}

static KSL_INLINED void ksl_product_ddrzinv_certified_planes(ptrdiff_t n, const double *D,
    ptrdiff_t D_plane, ptrdiff_t D_stride, const double *dc, ptrdiff_t dc_plane,
    ptrdiff_t dc_stride, double *Do, ptrdiff_t Do_plane, ptrdiff_t Do_stride,
    double *Do_bound, ptrdiff_t Do_bound_plane, ptrdiff_t Do_bound_stride) {
  ksl_SE3_t D_i;
  if (n > 0) D_i = ksl_SE3_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3_of_planes(D + i * D_stride, D_plane);
    const double dc_i[2] = {dc[0 + i * dc_stride], dc[dc_plane + i * dc_stride]};
    ksl_SE3_t Do_i;
    ksl_SE3_t Do_bound_i;
    ksl_product_ddrzinv_certified(&D_i, dc_i, &Do_i, &Do_bound_i);
    ksl_SE3_to_planes(&Do_i, Do + i * Do_stride, Do_plane);
    ksl_SE3_to_planes(&Do_bound_i, Do_bound + i * Do_bound_stride, Do_bound_plane);
  }
}

/* ksl_product_ddtzinv_certified of n elements. */
static KSL_INLINED void ksl_product_ddtzinv_certified_many(ptrdiff_t n, const ksl_SE3_t *D,
    ptrdiff_t D_stride, const double *k, ptrdiff_t k_stride, ksl_SE3_t *Do,
    ptrdiff_t Do_stride, ksl_SE3_t *Do_bound, ptrdiff_t Do_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_product_ddtzinv_certified(D + i * D_stride, k[i * k_stride], Do + i * Do_stride,
        Do_bound + i * Do_bound_stride);
  }
}

static KSL_INLINED void ksl_product_ddtzinv_certified_planes(ptrdiff_t n, const double *D,
    ptrdiff_t D_plane, ptrdiff_t D_stride, const double *k, ptrdiff_t k_stride,
    double *Do, ptrdiff_t Do_plane, ptrdiff_t Do_stride, double *Do_bound,
    ptrdiff_t Do_bound_plane, ptrdiff_t Do_bound_stride) {
  ksl_SE3_t D_i;
  if (n > 0) D_i = ksl_SE3_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3_of_planes(D + i * D_stride, D_plane);
    ksl_SE3_t Do_i;
    ksl_SE3_t Do_bound_i;
    ksl_product_ddtzinv_certified(&D_i, k[i * k_stride], &Do_i, &Do_bound_i);
    ksl_SE3_to_planes(&Do_i, Do + i * Do_stride, Do_plane);
    ksl_SE3_to_planes(&Do_bound_i, Do_bound + i * Do_bound_stride, Do_bound_plane);
  }
}

/* ksl_product_drvf_certified of n elements. */
static KSL_INLINED void ksl_product_drvf_certified_many(ptrdiff_t n, const ksl_mat3x3f_t *R,
    ptrdiff_t R_stride, const ksl_vec3f_t *v, ptrdiff_t v_stride,
    ksl_vec3f_t *vo, ptrdiff_t vo_stride, ksl_vec3f_t *vo_bound,
    ptrdiff_t vo_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_product_drvf_certified(R + i * R_stride, v + i * v_stride, vo + i * vo_stride,
        vo_bound + i * vo_bound_stride);
  }
}

static KSL_INLINED void ksl_product_drvf_certified_planes(ptrdiff_t n, const float *R,
    ptrdiff_t R_plane, ptrdiff_t R_stride, const float *v, ptrdiff_t v_plane,
    ptrdiff_t v_stride, float *vo, ptrdiff_t vo_plane, ptrdiff_t vo_stride,
    float *vo_bound, ptrdiff_t vo_bound_plane, ptrdiff_t vo_bound_stride) {
  ksl_mat3x3f_t R_i;
  if (n > 0) R_i = ksl_mat3x3f_of_planes(R, R_plane);
  KSL_EACH_OF(n) {
    if (R_stride) R_i = ksl_mat3x3f_of_planes(R + i * R_stride, R_plane);
    const ksl_vec3f_t v_i = ksl_vec3f_of_planes(v + i * v_stride, v_plane);
    ksl_vec3f_t vo_i;
    ksl_vec3f_t vo_bound_i;
    ksl_product_drvf_certified(&R_i, &v_i, &vo_i, &vo_bound_i);
    ksl_vec3f_to_planes(&vo_i, vo + i * vo_stride, vo_plane);
    ksl_vec3f_to_planes(&vo_bound_i, vo_bound + i * vo_bound_stride, vo_bound_plane);
  }
}

/* ksl_product_drvinvf_certified of n elements. */
static KSL_INLINED void ksl_product_drvinvf_certified_many(ptrdiff_t n, const ksl_mat3x3f_t *R,
    ptrdiff_t R_stride, const ksl_vec3f_t *v, ptrdiff_t v_stride,
    ksl_vec3f_t *vo, ptrdiff_t vo_stride, ksl_vec3f_t *vo_bound,
    ptrdiff_t vo_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_product_drvinvf_certified(R + i * R_stride, v + i * v_stride, vo + i * vo_stride,
        vo_bound + i * vo_bound_stride);
  }
}

static KSL_INLINED void ksl_product_drvinvf_certified_planes(ptrdiff_t n, const float *R,
    ptrdiff_t R_plane, ptrdiff_t R_stride, const float *v, ptrdiff_t v_plane,
    ptrdiff_t v_stride, float *vo, ptrdiff_t vo_plane, ptrdiff_t vo_stride,
    float *vo_bound, ptrdiff_t vo_bound_plane, ptrdiff_t vo_bound_stride) {
  ksl_mat3x3f_t R_i;
  if (n > 0) R_i = ksl_mat3x3f_of_planes(R, R_plane);
  KSL_EACH_OF(n) {
    if (R_stride) R_i = ksl_mat3x3f_of_planes(R + i * R_stride, R_plane);
    const ksl_vec3f_t v_i = ksl_vec3f_of_planes(v + i * v_stride, v_plane);
    ksl_vec3f_t vo_i;
    ksl_vec3f_t vo_bound_i;
    ksl_product_drvinvf_certified(&R_i, &v_i, &vo_i, &vo_bound_i);
    ksl_vec3f_to_planes(&vo_i, vo + i * vo_stride, vo_plane);
    ksl_vec3f_to_planes(&vo_bound_i, vo_bound + i * vo_bound_stride, vo_bound_plane);
  }
}

/* ksl_product_drinvvf_certified of n elements. */
static KSL_INLINED void ksl_product_drinvvf_certified_many(ptrdiff_t n, const ksl_mat3x3f_t *R,
    ptrdiff_t R_stride, const ksl_vec3f_t *v, ptrdiff_t v_stride,
    ksl_vec3f_t *vo, ptrdiff_t vo_stride, ksl_vec3f_t *vo_bound,
    ptrdiff_t vo_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_product_drinvvf_certified(R + i * R_stride, v + i * v_stride, vo + i * vo_stride,
        vo_bound + i * vo_bound_stride);
  }
}

static KSL_INLINED void ksl_product_drinvvf_certified_planes(ptrdiff_t n, const float *R,
    ptrdiff_t R_plane, ptrdiff_t R_stride, const float *v, ptrdiff_t v_plane,
    ptrdiff_t v_stride, float *vo, ptrdiff_t vo_plane, ptrdiff_t vo_stride,
    float *vo_bound, ptrdiff_t vo_bound_plane, ptrdiff_t vo_bound_stride) {
  ksl_mat3x3f_t R_i;
  if (n > 0) R_i = ksl_mat3x3f_of_planes(R, R_plane);
  KSL_EACH_OF(n) {
    if (R_stride) R_i = ksl_mat3x3f_of_planes(R + i * R_stride, R_plane);
    const ksl_vec3f_t v_i = ksl_vec3f_of_planes(v + i * v_stride, v_plane);
    ksl_vec3f_t vo_i;
    ksl_vec3f_t vo_bound_i;
    ksl_product_drinvvf_certified(&R_i, &v_i, &vo_i, &vo_bound_i);
    ksl_vec3f_to_planes(&vo_i, vo + i * vo_stride, vo_plane);
    ksl_vec3f_to_planes(&vo_bound_i, vo_bound + i * vo_bound_stride, vo_bound_plane);
  }
}

/* ksl_product_drinvvinvf_certified of n elements. */
static KSL_INLINED void ksl_product_drinvvinvf_certified_many(ptrdiff_t n, const ksl_mat3x3f_t *R,
    ptrdiff_t R_stride, const ksl_vec3f_t *v, ptrdiff_t v_stride,
    ksl_vec3f_t *vo, ptrdiff_t vo_stride, ksl_vec3f_t *vo_bound,
    ptrdiff_t vo_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_product_drinvvinvf_certified(R + i * R_stride, v + i * v_stride, vo + i * vo_stride,
        vo_bound + i * vo_bound_stride);
  }
}

static KSL_INLINED void ksl_product_drinvvinvf_certified_planes(ptrdiff_t n, const float *R,
    ptrdiff_t R_plane, ptrdiff_t R_stride, const float *v, ptrdiff_t v_plane,
    ptrdiff_t v_stride, float *vo, ptrdiff_t vo_plane, ptrdiff_t vo_stride,
    float *vo_bound, ptrdiff_t vo_bound_plane, ptrdiff_t vo_bound_stride) {
  ksl_mat3x3f_t R_i;
  if (n > 0) R_i = ksl_mat3x3f_of_planes(R, R_plane);
  KSL_EACH_OF(n) {
    if (R_stride) R_i = ksl_mat3x3f_of_planes(R + i * R_stride, R_plane);
    const ksl_vec3f_t v_i = ksl_vec3f_of_planes(v + i * v_stride, v_plane);
    ksl_vec3f_t vo_i;
    ksl_vec3f_t vo_bound_i;
    ksl_product_drinvvinvf_certified(&R_i, &v_i, &vo_i, &vo_bound_i);
    ksl_vec3f_to_planes(&vo_i, vo + i * vo_stride, vo_plane);
    ksl_vec3f_to_planes(&vo_bound_i, vo_bound + i * vo_bound_stride, vo_bound_plane);
  }
}

/* ksl_product_dvf_certified of n elements. */
static KSL_INLINED void ksl_product_dvf_certified_many(ptrdiff_t n, const ksl_SE3f_t *D,
    ptrdiff_t D_stride, const ksl_vec3f_t *v, ptrdiff_t v_stride,
    ksl_vec3f_t *vo, ptrdiff_t vo_stride, ksl_vec3f_t *vo_bound,
    ptrdiff_t vo_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_product_dvf_certified(D + i * D_stride, v + i * v_stride, vo + i * vo_stride,
        vo_bound + i * vo_bound_stride);
  }
}

static KSL_INLINED void ksl_product_dvf_certified_planes(ptrdiff_t n, const float *D,
    ptrdiff_t D_plane, ptrdiff_t D_stride, const float *v, ptrdiff_t v_plane,
    ptrdiff_t v_stride, float *vo, ptrdiff_t vo_plane, ptrdiff_t vo_stride,
    float *vo_bound, ptrdiff_t vo_bound_plane, ptrdiff_t vo_bound_stride) {
  ksl_SE3f_t D_i;
  if (n > 0) D_i = ksl_SE3f_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3f_of_planes(D + i * D_stride, D_plane);
    const ksl_vec3f_t v_i = ksl_vec3f_of_planes(v + i * v_stride, v_plane);
    ksl_vec3f_t vo_i;
    ksl_vec3f_t vo_bound_i;
    ksl_product_dvf_certified(&D_i, &v_i, &vo_i, &vo_bound_i);
    ksl_vec3f_to_planes(&vo_i, vo + i * vo_stride, vo_plane);
    ksl_vec3f_to_planes(&vo_bound_i, vo_bound + i * vo_bound_stride, vo_bound_plane);
  }
}

/* ksl_product_dinvvf_certified of n elements. */
static KSL_INLINED void ksl_product_dinvvf_certified_many(ptrdiff_t n, const ksl_SE3f_t *D,
    ptrdiff_t D_stride, const ksl_vec3f_t *v, ptrdiff_t v_stride,
    ksl_vec3f_t *vo, ptrdiff_t vo_stride, ksl_vec3f_t *vo_bound,
    ptrdiff_t vo_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_product_dinvvf_certified(D + i * D_stride, v + i * v_stride, vo + i * vo_stride,
        vo_bound + i * vo_bound_stride);
  }
}

static KSL_INLINED void ksl_product_dinvvf_certified_planes(ptrdiff_t n, const float *D,
    ptrdiff_t D_plane, ptrdiff_t D_stride, const float *v, ptrdiff_t v_plane,
    ptrdiff_t v_stride, float *vo, ptrdiff_t vo_plane, ptrdiff_t vo_stride,
    float *vo_bound, ptrdiff_t vo_bound_plane, ptrdiff_t vo_bound_stride) {
  ksl_SE3f_t D_i;
  if (n > 0) D_i = ksl_SE3f_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3f_of_planes(D + i * D_stride, D_plane);
    const ksl_vec3f_t v_i = ksl_vec3f_of_planes(v + i * v_stride, v_plane);
    ksl_vec3f_t vo_i;
    ksl_vec3f_t vo_bound_i;
    ksl_product_dinvvf_certified(&D_i, &v_i, &vo_i, &vo_bound_i);
    ksl_vec3f_to_planes(&vo_i, vo + i * vo_stride, vo_plane);
    ksl_vec3f_to_planes(&vo_bound_i, vo_bound + i * vo_bound_stride, vo_bound_plane);
  }
}

/* ksl_product_drdrf_certified of n elements. */
static KSL_INLINED void ksl_product_drdrf_certified_many(ptrdiff_t n, const ksl_mat3x3f_t *R1,
    ptrdiff_t R1_stride, const ksl_mat3x3f_t *R2, ptrdiff_t R2_stride,
    ksl_mat3x3f_t *Ro, ptrdiff_t Ro_stride, ksl_mat3x3f_t *Ro_bound,
    ptrdiff_t Ro_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_product_drdrf_certified(R1 + i * R1_stride, R2 + i * R2_stride, Ro + i * Ro_stride,
        Ro_bound + i * Ro_bound_stride);
  }
}

static KSL_INLINED void ksl_product_drdrf_certified_planes(ptrdiff_t n, const float *R1,
    ptrdiff_t R1_plane, ptrdiff_t R1_stride, const float *R2, ptrdiff_t R2_plane,
    ptrdiff_t R2_stride, float *Ro, ptrdiff_t Ro_plane, ptrdiff_t Ro_stride,
    float *Ro_bound, ptrdiff_t Ro_bound_plane, ptrdiff_t Ro_bound_stride) {
  ksl_mat3x3f_t R1_i;
  if (n > 0) R1_i = ksl_mat3x3f_of_planes(R1, R1_plane);
  KSL_EACH_OF(n) {
    if (R1_stride) R1_i = ksl_mat3x3f_of_planes(R1 + i * R1_stride, R1_plane);
    const ksl_mat3x3f_t R2_i = ksl_mat3x3f_of_planes(R2 + i * R2_stride, R2_plane);
    ksl_mat3x3f_t Ro_i;
    ksl_mat3x3f_t Ro_bound_i;
    ksl_product_drdrf_certified(&R1_i, &R2_i, &Ro_i, &Ro_bound_i);
    ksl_mat3x3f_to_planes(&Ro_i, Ro + i * Ro_stride, Ro_plane);
    ksl_mat3x3f_to_planes(&Ro_bound_i, Ro_bound + i * Ro_bound_stride, Ro_bound_plane);
  }
}

/* ksl_product_drdrinvf_certified of n elements. */
static KSL_INLINED void ksl_product_drdrinvf_certified_many(ptrdiff_t n, const ksl_mat3x3f_t *R1,
    ptrdiff_t R1_stride, const ksl_mat3x3f_t *R2, ptrdiff_t R2_stride,
    ksl_mat3x3f_t *Ro, ptrdiff_t Ro_stride, ksl_mat3x3f_t *Ro_bound,
    ptrdiff_t Ro_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_product_drdrinvf_certified(R1 + i * R1_stride, R2 + i * R2_stride, Ro + i * Ro_stride,
        Ro_bound + i * Ro_bound_stride);
  }
}

static KSL_INLINED void ksl_product_drdrinvf_certified_planes(ptrdiff_t n, const float *R1,
    ptrdiff_t R1_plane, ptrdiff_t R1_stride, const float *R2, ptrdiff_t R2_plane,
    ptrdiff_t R2_stride, float *Ro, ptrdiff_t Ro_plane, ptrdiff_t Ro_stride,
    float *Ro_bound, ptrdiff_t Ro_bound_plane, ptrdiff_t Ro_bound_stride) {
  ksl_mat3x3f_t R1_i;
  if (n > 0) R1_i = ksl_mat3x3f_of_planes(R1, R1_plane);
  KSL_EACH_OF(n) {
    if (R1_stride) R1_i = ksl_mat3x3f_of_planes(R1 + i * R1_stride, R1_plane);
    const ksl_mat3x3f_t R2_i = ksl_mat3x3f_of_planes(R2 + i * R2_stride, R2_plane);
    ksl_mat3x3f_t Ro_i;
    ksl_mat3x3f_t Ro_bound_i;
    ksl_product_drdrinvf_certified(&R1_i, &R2_i, &Ro_i, &Ro_bound_i);
    ksl_mat3x3f_to_planes(&Ro_i, Ro + i * Ro_stride, Ro_plane);
    ksl_mat3x3f_to_planes(&Ro_bound_i, Ro_bound + i * Ro_bound_stride, Ro_bound_plane);
  }
}

/* ksl_product_drinvdrf_certified of n elements. */
static KSL_INLINED void ksl_product_drinvdrf_certified_many(ptrdiff_t n, const ksl_mat3x3f_t *R1,
    ptrdiff_t R1_stride, const ksl_mat3x3f_t *R2, ptrdiff_t R2_stride,
    ksl_mat3x3f_t *Ro, ptrdiff_t Ro_stride, ksl_mat3x3f_t *Ro_bound,
    ptrdiff_t Ro_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_product_drinvdrf_certified(R1 + i * R1_stride, R2 + i * R2_stride, Ro + i * Ro_stride,
        Ro_bound + i * Ro_bound_stride);
  }
}

static KSL_INLINED void ksl_product_drinvdrf_certified_planes(ptrdiff_t n, const float *R1,
    ptrdiff_t R1_plane, ptrdiff_t R1_stride, const float *R2, ptrdiff_t R2_plane,
    ptrdiff_t R2_stride, float *Ro, ptrdiff_t Ro_plane, ptrdiff_t Ro_stride,
    float *Ro_bound, ptrdiff_t Ro_bound_plane, ptrdiff_t Ro_bound_stride) {
  ksl_mat3x3f_t R1_i;
  if (n > 0) R1_i = ksl_mat3x3f_of_planes(R1, R1_plane);
  KSL_EACH_OF(n) {
    if (R1_stride) R1_i = ksl_mat3x3f_of_planes(R1 + i * R1_stride, R1_plane);
    const ksl_mat3x3f_t R2_i = ksl_mat3x3f_of_planes(R2 + i * R2_stride, R2_plane);
    ksl_mat3x3f_t Ro_i;
    ksl_mat3x3f_t Ro_bound_i;
    ksl_product_drinvdrf_certified(&R1_i, &R2_i, &Ro_i, &Ro_bound_i);
    ksl_mat3x3f_to_planes(&Ro_i, Ro + i * Ro_stride, Ro_plane);
    ksl_mat3x3f_to_planes(&Ro_bound_i, Ro_bound + i * Ro_bound_stride, Ro_bound_plane);
  }
}

/* ksl_product_ddf_certified of n elements. */
static KSL_INLINED void ksl_product_ddf_certified_many(ptrdiff_t n, const ksl_SE3f_t *D1,
    ptrdiff_t D1_stride, const ksl_SE3f_t *D2, ptrdiff_t D2_stride,
    ksl_SE3f_t *Do, ptrdiff_t Do_stride, ksl_SE3f_t *Do_bound,
    ptrdiff_t Do_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_product_ddf_certified(D1 + i * D1_stride, D2 + i * D2_stride, Do + i * Do_stride,
        Do_bound + i * Do_bound_stride);
  }
}

static KSL_INLINED void ksl_product_ddf_certified_planes(ptrdiff_t n, const float *D1,
    ptrdiff_t D1_plane, ptrdiff_t D1_stride, const float *D2, ptrdiff_t D2_plane,
    ptrdiff_t D2_stride, float *Do, ptrdiff_t Do_plane, ptrdiff_t Do_stride,
    float *Do_bound, ptrdiff_t Do_bound_plane, ptrdiff_t Do_bound_stride) {
  ksl_SE3f_t D1_i;
  if (n > 0) D1_i = ksl_SE3f_of_planes(D1, D1_plane);
  KSL_EACH_OF(n) {
    if (D1_stride) D1_i = ksl_SE3f_of_planes(D1 + i * D1_stride, D1_plane);
    const ksl_SE3f_t D2_i = ksl_SE3f_of_planes(D2 + i * D2_stride, D2_plane);
    ksl_SE3f_t Do_i;
    ksl_SE3f_t Do_bound_i;
    ksl_product_ddf_certified(&D1_i, &D2_i, &Do_i, &Do_bound_i);
    ksl_SE3f_to_planes(&Do_i, Do + i * Do_stride, Do_plane);
    ksl_SE3f_to_planes(&Do_bound_i, Do_bound + i * Do_bound_stride, Do_bound_plane);
  }
}

/* ksl_product_ddinvf_certified of n elements. */
static KSL_INLINED void ksl_product_ddinvf_certified_many(ptrdiff_t n, const ksl_SE3f_t *D1,
    ptrdiff_t D1_stride, const ksl_SE3f_t *D2, ptrdiff_t D2_stride,
    ksl_SE3f_t *Do, ptrdiff_t Do_stride, ksl_SE3f_t *Do_bound,
    ptrdiff_t Do_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_product_ddinvf_certified(D1 + i * D1_stride, D2 + i * D2_stride, Do + i * Do_stride,
        Do_bound + i * Do_bound_stride);
  }
}

static KSL_INLINED void ksl_product_ddinvf_certified_planes(ptrdiff_t n, const float *D1,
    ptrdiff_t D1_plane, ptrdiff_t D1_stride, const float *D2, ptrdiff_t D2_plane,
    ptrdiff_t D2_stride, float *Do, ptrdiff_t Do_plane, ptrdiff_t Do_stride,
    float *Do_bound, ptrdiff_t Do_bound_plane, ptrdiff_t Do_bound_stride) {
  ksl_SE3f_t D1_i;
  if (n > 0) D1_i = ksl_SE3f_of_planes(D1, D1_plane);
  KSL_EACH_OF(n) {
    if (D1_stride) D1_i = ksl_SE3f_of_planes(D1 + i * D1_stride, D1_plane);
    const ksl_SE3f_t D2_i = ksl_SE3f_of_planes(D2 + i * D2_stride, D2_plane);
    ksl_SE3f_t Do_i;
    ksl_SE3f_t Do_bound_i;
    ksl_product_ddinvf_certified(&D1_i, &D2_i, &Do_i, &Do_bound_i);
    ksl_SE3f_to_planes(&Do_i, Do + i * Do_stride, Do_plane);
    ksl_SE3f_to_planes(&Do_bound_i, Do_bound + i * Do_bound_stride, Do_bound_plane);
  }
}

/* ksl_product_dinvdf_certified of n elements. */
static KSL_INLINED void ksl_product_dinvdf_certified_many(ptrdiff_t n, const ksl_SE3f_t *D1,
    ptrdiff_t D1_stride, const ksl_SE3f_t *D2, ptrdiff_t D2_stride,
    ksl_SE3f_t *Do, ptrdiff_t Do_stride, ksl_SE3f_t *Do_bound,
    ptrdiff_t Do_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_product_dinvdf_certified(D1 + i * D1_stride, D2 + i * D2_stride, Do + i * Do_stride,
        Do_bound + i * Do_bound_stride);
  }
}

static KSL_INLINED void ksl_product_dinvdf_certified_planes(ptrdiff_t n, const float *D1,
    ptrdiff_t D1_plane, ptrdiff_t D1_stride, const float *D2, ptrdiff_t D2_plane,
    ptrdiff_t D2_stride, float *Do, ptrdiff_t Do_plane, ptrdiff_t Do_stride,
    float *Do_bound, ptrdiff_t Do_bound_plane, ptrdiff_t Do_bound_stride) {
  ksl_SE3f_t D1_i;
  if (n > 0) D1_i = ksl_SE3f_of_planes(D1, D1_plane);
  KSL_EACH_OF(n) {
    if (D1_stride) D1_i = ksl_SE3f_of_planes(D1 + i * D1_stride, D1_plane);
    const ksl_SE3f_t D2_i = ksl_SE3f_of_planes(D2 + i * D2_stride, D2_plane);
    ksl_SE3f_t Do_i;
    ksl_SE3f_t Do_bound_i;
    ksl_product_dinvdf_certified(&D1_i, &D2_i, &Do_i, &Do_bound_i);
    ksl_SE3f_to_planes(&Do_i, Do + i * Do_stride, Do_plane);
    ksl_SE3f_to_planes(&Do_bound_i, Do_bound + i * Do_bound_stride, Do_bound_plane);
  }
}

/* ksl_product_ddrf_certified of n elements. */
static KSL_INLINED void ksl_product_ddrf_certified_many(ptrdiff_t n, const ksl_SE3f_t *D,
    ptrdiff_t D_stride, const ksl_mat3x3f_t *R, ptrdiff_t R_stride,
    ksl_SE3f_t *Do, ptrdiff_t Do_stride, ksl_SE3f_t *Do_bound,
    ptrdiff_t Do_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_product_ddrf_certified(D + i * D_stride, R + i * R_stride, Do + i * Do_stride,
        Do_bound + i * Do_bound_stride);
  }
}

static KSL_INLINED void ksl_product_ddrf_certified_planes(ptrdiff_t n, const float *D,
    ptrdiff_t D_plane, ptrdiff_t D_stride, const float *R, ptrdiff_t R_plane,
    ptrdiff_t R_stride, float *Do, ptrdiff_t Do_plane, ptrdiff_t Do_stride,
    float *Do_bound, ptrdiff_t Do_bound_plane, ptrdiff_t Do_bound_stride) {
  ksl_SE3f_t D_i;
  if (n > 0) D_i = ksl_SE3f_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3f_of_planes(D + i * D_stride, D_plane);
    const ksl_mat3x3f_t R_i = ksl_mat3x3f_of_planes(R + i * R_stride, R_plane);
    ksl_SE3f_t Do_i;
    ksl_SE3f_t Do_bound_i;
    ksl_product_ddrf_certified(&D_i, &R_i, &Do_i, &Do_bound_i);
    ksl_SE3f_to_planes(&Do_i, Do + i * Do_stride, Do_plane);
    ksl_SE3f_to_planes(&Do_bound_i, Do_bound + i * Do_bound_stride, Do_bound_plane);
  }
}

/* ksl_product_ddrinvf_certified of n elements. */
static KSL_INLINED void ksl_product_ddrinvf_certified_many(ptrdiff_t n, const ksl_SE3f_t *D,
    ptrdiff_t D_stride, const ksl_mat3x3f_t *R, ptrdiff_t R_stride,
    ksl_SE3f_t *Do, ptrdiff_t Do_stride, ksl_SE3f_t *Do_bound,
    ptrdiff_t Do_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_product_ddrinvf_certified(D + i * D_stride, R + i * R_stride, Do + i * Do_stride,
        Do_bound + i * Do_bound_stride);
  }
}

static KSL_INLINED void ksl_product_ddrinvf_certified_planes(ptrdiff_t n, const float *D,
    ptrdiff_t D_plane, ptrdiff_t D_stride, const float *R, ptrdiff_t R_plane,
    ptrdiff_t R_stride, float *Do, ptrdiff_t Do_plane, ptrdiff_t Do_stride,
    float *Do_bound, ptrdiff_t Do_bound_plane, ptrdiff_t Do_bound_stride) {
  ksl_SE3f_t D_i;
  if (n > 0) D_i = ksl_SE3f_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3f_of_planes(D + i * D_stride, D_plane);
    const ksl_mat3x3f_t R_i = ksl_mat3x3f_of_planes(R + i * R_stride, R_plane);
    ksl_SE3f_t Do_i;
    ksl_SE3f_t Do_bound_i;
    ksl_product_ddrinvf_certified(&D_i, &R_i, &Do_i, &Do_bound_i);
    ksl_SE3f_to_planes(&Do_i, Do + i * Do_stride, Do_plane);
    ksl_SE3f_to_planes(&Do_bound_i, Do_bound + i * Do_bound_stride, Do_bound_plane);
  }
}

/* ksl_product_ddtf_certified of n elements. */
static KSL_INLINED void ksl_product_ddtf_certified_many(ptrdiff_t n, const ksl_SE3f_t *D,
    ptrdiff_t D_stride, const ksl_vec3f_t *t, ptrdiff_t t_stride, ksl_SE3f_t *Do,
    ptrdiff_t Do_stride, ksl_SE3f_t *Do_bound, ptrdiff_t Do_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_product_ddtf_certified(D + i * D_stride, t + i * t_stride, Do + i * Do_stride,
        Do_bound + i * Do_bound_stride);
  }
}

static KSL_INLINED void ksl_product_ddtf_certified_planes(ptrdiff_t n, const float *D,
    ptrdiff_t D_plane, ptrdiff_t D_stride, const float *t, ptrdiff_t t_plane,
    ptrdiff_t t_stride, float *Do, ptrdiff_t Do_plane, ptrdiff_t Do_stride,
    float *Do_bound, ptrdiff_t Do_bound_plane, ptrdiff_t Do_bound_stride) {
  ksl_SE3f_t D_i;
  if (n > 0) D_i = ksl_SE3f_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3f_of_planes(D + i * D_stride, D_plane);
    const ksl_vec3f_t t_i = ksl_vec3f_of_planes(t + i * t_stride, t_plane);
    ksl_SE3f_t Do_i;
    ksl_SE3f_t Do_bound_i;
    ksl_product_ddtf_certified(&D_i, &t_i, &Do_i, &Do_bound_i);
    ksl_SE3f_to_planes(&Do_i, Do + i * Do_stride, Do_plane);
    ksl_SE3f_to_planes(&Do_bound_i, Do_bound + i * Do_bound_stride, Do_bound_plane);
  }
}

/* ksl_product_ddtinvf_certified of n elements. */
static KSL_INLINED void ksl_product_ddtinvf_certified_many(ptrdiff_t n, const ksl_SE3f_t *D,
    ptrdiff_t D_stride, const ksl_vec3f_t *t, ptrdiff_t t_stride, ksl_SE3f_t *Do,
    ptrdiff_t Do_stride, ksl_SE3f_t *Do_bound, ptrdiff_t Do_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_product_ddtinvf_certified(D + i * D_stride, t + i * t_stride, Do + i * Do_stride,
        Do_bound + i * Do_bound_stride);
  }
}

static KSL_INLINED void ksl_product_ddtinvf_certified_planes(ptrdiff_t n, const float *D,
    ptrdiff_t D_plane, ptrdiff_t D_stride, const float *t, ptrdiff_t t_plane,
    ptrdiff_t t_stride, float *Do, ptrdiff_t Do_plane, ptrdiff_t Do_stride,
    float *Do_bound, ptrdiff_t Do_bound_plane, ptrdiff_t Do_bound_stride) {
  ksl_SE3f_t D_i;
  if (n > 0) D_i = ksl_SE3f_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3f_of_planes(D + i * D_stride, D_plane);
    const ksl_vec3f_t t_i = ksl_vec3f_of_planes(t + i * t_stride, t_plane);
    ksl_SE3f_t Do_i;
    ksl_SE3f_t Do_bound_i;
    ksl_product_ddtinvf_certified(&D_i, &t_i, &Do_i, &Do_bound_i);
    ksl_SE3f_to_planes(&Do_i, Do + i * Do_stride, Do_plane);
    ksl_SE3f_to_planes(&Do_bound_i, Do_bound + i * Do_bound_stride, Do_bound_plane);
  }
}

/* ksl_product_dinvdtf_certified of n elements. */
static KSL_INLINED void ksl_product_dinvdtf_certified_many(ptrdiff_t n, const ksl_SE3f_t *D,
    ptrdiff_t D_stride, const ksl_vec3f_t *t, ptrdiff_t t_stride, ksl_SE3f_t *Do,
    ptrdiff_t Do_stride, ksl_SE3f_t *Do_bound, ptrdiff_t Do_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_product_dinvdtf_certified(D + i * D_stride, t + i * t_stride, Do + i * Do_stride,
        Do_bound + i * Do_bound_stride);
  }
}

static KSL_INLINED void ksl_product_dinvdtf_certified_planes(ptrdiff_t n, const float *D,
    ptrdiff_t D_plane, ptrdiff_t D_stride, const float *t, ptrdiff_t t_plane,
    ptrdiff_t t_stride, float *Do, ptrdiff_t Do_plane, ptrdiff_t Do_stride,
    float *Do_bound, ptrdiff_t Do_bound_plane, ptrdiff_t Do_bound_stride) {
  ksl_SE3f_t D_i;
  if (n > 0) D_i = ksl_SE3f_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3f_of_planes(D + i * D_stride, D_plane);
    const ksl_vec3f_t t_i = ksl_vec3f_of_planes(t + i * t_stride, t_plane);
    ksl_SE3f_t Do_i;
    ksl_SE3f_t Do_bound_i;
    ksl_product_dinvdtf_certified(&D_i, &t_i, &Do_i, &Do_bound_i);
    ksl_SE3f_to_planes(&Do_i, Do + i * Do_stride, Do_plane);
    ksl_SE3f_to_planes(&Do_bound_i, Do_bound + i * Do_bound_stride, Do_bound_plane);
  }
}

/* ksl_product_drvtxf_certified of n elements. */
static KSL_INLINED void ksl_product_drvtxf_certified_many(ptrdiff_t n, const ksl_mat3x3f_t *R,
    ptrdiff_t R_stride, const float *k, ptrdiff_t k_stride, ksl_vec3f_t *vo,
    ptrdiff_t vo_stride, ksl_vec3f_t *vo_bound, ptrdiff_t vo_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_product_drvtxf_certified(R + i * R_stride, k[i * k_stride], vo + i * vo_stride,
        vo_bound + i * vo_bound_stride);
  }
}

static KSL_INLINED void ksl_product_drvtxf_certified_planes(ptrdiff_t n, const float *R,
    ptrdiff_t R_plane, ptrdiff_t R_stride, const float *k, ptrdiff_t k_stride,
    float *vo, ptrdiff_t vo_plane, ptrdiff_t vo_stride, float *vo_bound,
    ptrdiff_t vo_bound_plane, ptrdiff_t vo_bound_stride) {
  ksl_mat3x3f_t R_i;
  if (n > 0) R_i = ksl_mat3x3f_of_planes(R, R_plane);
  KSL_EACH_OF(n) {
    if (R_stride) R_i = ksl_mat3x3f_of_planes(R + i * R_stride, R_plane);
    ksl_vec3f_t vo_i;
    ksl_vec3f_t vo_bound_i;
    ksl_product_drvtxf_certified(&R_i, k[i * k_stride], &vo_i, &vo_bound_i);
    ksl_vec3f_to_planes(&vo_i, vo + i * vo_stride, vo_plane);
    ksl_vec3f_to_planes(&vo_bound_i, vo_bound + i * vo_bound_stride, vo_bound_plane);
  }
}

/* ksl_product_drdrxf_certified of n elements. */
static KSL_INLINED void ksl_product_drdrxf_certified_many(ptrdiff_t n, const ksl_mat3x3f_t *R,
    ptrdiff_t R_stride, const float *dc, ptrdiff_t dc_stride, ksl_mat3x3f_t *Ro,
    ptrdiff_t Ro_stride, ksl_mat3x3f_t *Ro_bound, ptrdiff_t Ro_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_product_drdrxf_certified(R + i * R_stride, dc + 2 * i * dc_stride, Ro + i * Ro_stride,
        Ro_bound + i * Ro_bound_stride);
  }
}

static KSL_INLINED void ksl_product_drdrxf_certified_planes(ptrdiff_t n, const float *R,
    ptrdiff_t R_plane, ptrdiff_t R_stride, const float *dc, ptrdiff_t dc_plane,
    ptrdiff_t dc_stride, float *Ro, ptrdiff_t Ro_plane, ptrdiff_t Ro_stride,
    float *Ro_bound, ptrdiff_t Ro_bound_plane, ptrdiff_t Ro_bound_stride) {
  ksl_mat3x3f_t R_i;
  if (n > 0) R_i = ksl_mat3x3f_of_planes(R, R_plane);
  KSL_EACH_OF(n) {
    if (R_stride) R_i = ksl_mat3x3f_of_planes(R + i * R_stride, R_plane);
    const float dc_i[2] = {dc[0 + i * dc_stride], dc[dc_plane + i * dc_stride]};
    ksl_mat3x3f_t Ro_i;
    ksl_mat3x3f_t Ro_bound_i;
    ksl_product_drdrxf_certified(&R_i, dc_i, &Ro_i, &Ro_bound_i);
    ksl_mat3x3f_to_planes(&Ro_i, Ro + i * Ro_stride, Ro_plane);
    ksl_mat3x3f_to_planes(&Ro_bound_i, Ro_bound + i * Ro_bound_stride, Ro_bound_plane);
  }
}

/* ksl_product_ddrxf_certified of n elements. */
static KSL_INLINED void ksl_product_ddrxf_certified_many(ptrdiff_t n, const ksl_SE3f_t *D,
    ptrdiff_t D_stride, const float *dc, ptrdiff_t dc_stride, ksl_SE3f_t *Do,
    ptrdiff_t Do_stride, ksl_SE3f_t *Do_bound, ptrdiff_t Do_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_product_ddrxf_certified(D + i * D_stride, dc + 2 * i * dc_stride, Do + i * Do_stride,
        Do_bound + i * Do_bound_stride);
  }
}

static KSL_INLINED void ksl_product_ddrxf_certified_planes(ptrdiff_t n, const float *D,
    ptrdiff_t D_plane, ptrdiff_t D_stride, const float *dc, ptrdiff_t dc_plane,
    ptrdiff_t dc_stride, float *Do, ptrdiff_t Do_plane, ptrdiff_t Do_stride,
    float *Do_bound, ptrdiff_t Do_bound_plane, ptrdiff_t Do_bound_stride) {
  ksl_SE3f_t D_i;
  if (n > 0) D_i = ksl_SE3f_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3f_of_planes(D + i * D_stride, D_plane);
    const float dc_i[2] = {dc[0 + i * dc_stride], dc[dc_plane + i * dc_stride]};
    ksl_SE3f_t Do_i;
    ksl_SE3f_t Do_bound_i;
    ksl_product_ddrxf_certified(&D_i, dc_i, &Do_i, &Do_bound_i);
    ksl_SE3f_to_planes(&Do_i, Do + i * Do_stride, Do_plane);
    ksl_SE3f_to_planes(&Do_bound_i, Do_bound + i * Do_bound_stride, Do_bound_plane);
  }
}

/* ksl_product_ddtxf_certified of n elements. */
static KSL_INLINED void ksl_product_ddtxf_certified_many(ptrdiff_t n, const ksl_SE3f_t *D,
    ptrdiff_t D_stride, const float *k, ptrdiff_t k_stride, ksl_SE3f_t *Do,
    ptrdiff_t Do_stride, ksl_SE3f_t *Do_bound, ptrdiff_t Do_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_product_ddtxf_certified(D + i * D_stride, k[i * k_stride], Do + i * Do_stride,
        Do_bound + i * Do_bound_stride);
  }
}

static KSL_INLINED void ksl_product_ddtxf_certified_planes(ptrdiff_t n, const float *D,
    ptrdiff_t D_plane, ptrdiff_t D_stride, const float *k, ptrdiff_t k_stride,
    float *Do, ptrdiff_t Do_plane, ptrdiff_t Do_stride, float *Do_bound,
    ptrdiff_t Do_bound_plane, ptrdiff_t Do_bound_stride) {
  ksl_SE3f_t D_i;
  if (n > 0) D_i = ksl_SE3f_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3f_of_planes(D + i * D_stride, D_plane);
    ksl_SE3f_t Do_i;
    ksl_SE3f_t Do_bound_i;
    ksl_product_ddtxf_certified(&D_i, k[i * k_stride], &Do_i, &Do_bound_i);
    ksl_SE3f_to_planes(&Do_i, Do + i * Do_stride, Do_plane);
    ksl_SE3f_to_planes(&Do_bound_i, Do_bound + i * Do_bound_stride, Do_bound_plane);
  }
}

/* ksl_product_drvtxinvf_certified of n elements. */
static KSL_INLINED void ksl_product_drvtxinvf_certified_many(ptrdiff_t n, const ksl_mat3x3f_t *R,
    ptrdiff_t R_stride, const float *k, ptrdiff_t k_stride, ksl_vec3f_t *vo,
    ptrdiff_t vo_stride, ksl_vec3f_t *vo_bound, ptrdiff_t vo_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_product_drvtxinvf_certified(R + i * R_stride, k[i * k_stride], vo + i * vo_stride,
        vo_bound + i * vo_bound_stride);
  }
}

static KSL_INLINED void ksl_product_drvtxinvf_certified_planes(ptrdiff_t n, const float *R,
    ptrdiff_t R_plane, ptrdiff_t R_stride, const float *k, ptrdiff_t k_stride,
    float *vo, ptrdiff_t vo_plane, ptrdiff_t vo_stride, float *vo_bound,
    ptrdiff_t vo_bound_plane, ptrdiff_t vo_bound_stride) {
  ksl_mat3x3f_t R_i;
  if (n > 0) R_i = ksl_mat3x3f_of_planes(R, R_plane);
  KSL_EACH_OF(n) {
    if (R_stride) R_i = ksl_mat3x3f_of_planes(R + i * R_stride, R_plane);
    ksl_vec3f_t vo_i;
    ksl_vec3f_t vo_bound_i;
    ksl_product_drvtxinvf_certified(&R_i, k[i * k_stride], &vo_i, &vo_bound_i);
    ksl_vec3f_to_planes(&vo_i, vo + i * vo_stride, vo_plane);
    ksl_vec3f_to_planes(&vo_bound_i, vo_bound + i * vo_bound_stride, vo_bound_plane);
  }
}

/* ksl_product_drdrxinvf_certified of n elements. */
static KSL_INLINED void ksl_product_drdrxinvf_certified_many(ptrdiff_t n, const ksl_mat3x3f_t *R,
    ptrdiff_t R_stride, const float *dc, ptrdiff_t dc_stride, ksl_mat3x3f_t *Ro,
    ptrdiff_t Ro_stride, ksl_mat3x3f_t *Ro_bound, ptrdiff_t Ro_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_product_drdrxinvf_certified(R + i * R_stride, dc + 2 * i * dc_stride, Ro + i * Ro_stride,
        Ro_bound + i * Ro_bound_stride);
  }
}

static KSL_INLINED void ksl_product_drdrxinvf_certified_planes(ptrdiff_t n, const float *R,
    ptrdiff_t R_plane, ptrdiff_t R_stride, const float *dc, ptrdiff_t dc_plane,
    ptrdiff_t dc_stride, float *Ro, ptrdiff_t Ro_plane, ptrdiff_t Ro_stride,
    float *Ro_bound, ptrdiff_t Ro_bound_plane, ptrdiff_t Ro_bound_stride) {
  ksl_mat3x3f_t R_i;
  if (n > 0) R_i = ksl_mat3x3f_of_planes(R, R_plane);
  KSL_EACH_OF(n) {
    if (R_stride) R_i = ksl_mat3x3f_of_planes(R + i * R_stride, R_plane);
    const float dc_i[2] = {dc[0 + i * dc_stride], dc[dc_plane + i * dc_stride]};
    ksl_mat3x3f_t Ro_i;
    ksl_mat3x3f_t Ro_bound_i;
    ksl_product_drdrxinvf_certified(&R_i, dc_i, &Ro_i, &Ro_bound_i);
    ksl_mat3x3f_to_planes(&Ro_i, Ro + i * Ro_stride, Ro_plane);
    ksl_mat3x3f_to_planes(&Ro_bound_i, Ro_bound + i * Ro_bound_stride, Ro_bound_plane);
  }
}

/* ksl_product_ddrxinvf_certified of n elements. */
static KSL_INLINED void ksl_product_ddrxinvf_certified_many(ptrdiff_t n, const ksl_SE3f_t *D,
    ptrdiff_t D_stride, const float *dc, ptrdiff_t dc_stride, ksl_SE3f_t *Do,
    ptrdiff_t Do_stride, ksl_SE3f_t *Do_bound, ptrdiff_t Do_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_product_ddrxinvf_certified(D + i * D_stride, dc + 2 * i * dc_stride, Do + i * Do_stride,
        Do_bound + i * Do_bound_stride);
  }
}

static KSL_INLINED void ksl_product_ddrxinvf_certified_planes(ptrdiff_t n, const float *D,
    ptrdiff_t D_plane, ptrdiff_t D_stride, const float *dc, ptrdiff_t dc_plane,
    ptrdiff_t dc_stride, float *Do, ptrdiff_t Do_plane, ptrdiff_t Do_stride,
    float *Do_bound, ptrdiff_t Do_bound_plane, ptrdiff_t Do_bound_stride) {
  ksl_SE3f_t D_i;
  if (n > 0) D_i = ksl_SE3f_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3f_of_planes(D + i * D_stride, D_plane);
    const float dc_i[2] = {dc[0 + i * dc_stride], dc[dc_plane + i * dc_stride]};
    ksl_SE3f_t Do_i;
    ksl_SE3f_t Do_bound_i;
    ksl_product_ddrxinvf_certified(&D_i, dc_i, &Do_i, &Do_bound_i);
    ksl_SE3f_to_planes(&Do_i, Do + i * Do_stride, Do_plane);
    ksl_SE3f_to_planes(&Do_bound_i, Do_bound + i * Do_bound_stride, Do_bound_plane);
  }
}

/* ksl_product_ddtxinvf_certified of n elements. */
static KSL_INLINED void ksl_product_ddtxinvf_certified_many(ptrdiff_t n, const ksl_SE3f_t *D,
    ptrdiff_t D_stride, const float *k, ptrdiff_t k_stride, ksl_SE3f_t *Do,
    ptrdiff_t Do_stride, ksl_SE3f_t *Do_bound, ptrdiff_t Do_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_product_ddtxinvf_certified(D + i * D_stride, k[i * k_stride], Do + i * Do_stride,
        Do_bound + i * Do_bound_stride);
  }
}

static KSL_INLINED void ksl_product_ddtxinvf_certified_planes(ptrdiff_t n, const float *D,
    ptrdiff_t D_plane, ptrdiff_t D_stride, const float *k, ptrdiff_t k_stride,
    float *Do, ptrdiff_t Do_plane, ptrdiff_t Do_stride, float *Do_bound,
    ptrdiff_t Do_bound_plane, ptrdiff_t Do_bound_stride) {
  ksl_SE3f_t D_i;
  if (n > 0) D_i = ksl_SE3f_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3f_of_planes(D + i * D_stride, D_plane);
    ksl_SE3f_t Do_i;
    ksl_SE3f_t Do_bound_i;
    ksl_product_ddtxinvf_certified(&D_i, k[i * k_stride], &Do_i, &Do_bound_i);
    ksl_SE3f_to_planes(&Do_i, Do + i * Do_stride, Do_plane);
    ksl_SE3f_to_planes(&Do_bound_i, Do_bound + i * Do_bound_stride, Do_bound_plane);
  }
}

/* ksl_product_drvtyf_certified of n elements. */
static KSL_INLINED void ksl_product_drvtyf_certified_many(ptrdiff_t n, const ksl_mat3x3f_t *R,
    ptrdiff_t R_stride, const float *k, ptrdiff_t k_stride, ksl_vec3f_t *vo,
    ptrdiff_t vo_stride, ksl_vec3f_t *vo_bound, ptrdiff_t vo_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_product_drvtyf_certified(R + i * R_stride, k[i * k_stride], vo + i * vo_stride,
        vo_bound + i * vo_bound_stride);
  }
}

static KSL_INLINED void ksl_product_drvtyf_certified_planes(ptrdiff_t n, const float *R,
    ptrdiff_t R_plane, ptrdiff_t R_stride, const float *k, ptrdiff_t k_stride,
    float *vo, ptrdiff_t vo_plane, ptrdiff_t vo_stride, float *vo_bound,
    ptrdiff_t vo_bound_plane, ptrdiff_t vo_bound_stride) {
  ksl_mat3x3f_t R_i;
  if (n > 0) R_i = ksl_mat3x3f_of_planes(R, R_plane);
  KSL_EACH_OF(n) {
    if (R_stride) R_i = ksl_mat3x3f_of_planes(R + i * R_stride, R_plane);
    ksl_vec3f_t vo_i;
    ksl_vec3f_t vo_bound_i;
    ksl_product_drvtyf_certified(&R_i, k[i * k_stride], &vo_i, &vo_bound_i);
    ksl_vec3f_to_planes(&vo_i, vo + i * vo_stride, vo_plane);
    ksl_vec3f_to_planes(&vo_bound_i, vo_bound + i * vo_bound_stride, vo_bound_plane);
  }
}

/* ksl_product_drdryf_certified of n elements. */
static KSL_INLINED void ksl_product_drdryf_certified_many(ptrdiff_t n, const ksl_mat3x3f_t *R,
    ptrdiff_t R_stride, const float *dc, ptrdiff_t dc_stride, ksl_mat3x3f_t *Ro,
    ptrdiff_t Ro_stride, ksl_mat3x3f_t *Ro_bound, ptrdiff_t Ro_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_product_drdryf_certified(R + i * R_stride, dc + 2 * i * dc_stride, Ro + i * Ro_stride,
        Ro_bound + i * Ro_bound_stride);
  }
}

static KSL_INLINED void ksl_product_drdryf_certified_planes(ptrdiff_t n, const float *R,
    ptrdiff_t R_plane, ptrdiff_t R_stride, const float *dc, ptrdiff_t dc_plane,
    ptrdiff_t dc_stride, float *Ro, ptrdiff_t Ro_plane, ptrdiff_t Ro_stride,
    float *Ro_bound, ptrdiff_t Ro_bound_plane, ptrdiff_t Ro_bound_stride) {
  ksl_mat3x3f_t R_i;
  if (n > 0) R_i = ksl_mat3x3f_of_planes(R, R_plane);
  KSL_EACH_OF(n) {
    if (R_stride) R_i = ksl_mat3x3f_of_planes(R + i * R_stride, R_plane);
    const float dc_i[2] = {dc[0 + i * dc_stride], dc[dc_plane + i * dc_stride]};
    ksl_mat3x3f_t Ro_i;
    ksl_mat3x3f_t Ro_bound_i;
    ksl_product_drdryf_certified(&R_i, dc_i, &Ro_i, &Ro_bound_i);
    ksl_mat3x3f_to_planes(&Ro_i, Ro + i * Ro_stride, Ro_plane);
    ksl_mat3x3f_to_planes(&Ro_bound_i, Ro_bound + i * Ro_bound_stride, Ro_bound_plane);
  }
}

/* ksl_product_ddryf_certified of n elements. */
static KSL_INLINED void ksl_product_ddryf_certified_many(ptrdiff_t n, const ksl_SE3f_t *D,
    ptrdiff_t D_stride, const float *dc, ptrdiff_t dc_stride, ksl_SE3f_t *Do,
    ptrdiff_t Do_stride, ksl_SE3f_t *Do_bound, ptrdiff_t Do_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_product_ddryf_certified(D + i * D_stride, dc + 2 * i * dc_stride, Do + i * Do_stride,
        Do_bound + i * Do_bound_stride);
  }
}

static KSL_INLINED void ksl_product_ddryf_certified_planes(ptrdiff_t n, const float *D,
    ptrdiff_t D_plane, ptrdiff_t D_stride, const float *dc, ptrdiff_t dc_plane,
    ptrdiff_t dc_stride, float *Do, ptrdiff_t Do_plane, ptrdiff_t Do_stride,
    float *Do_bound, ptrdiff_t Do_bound_plane, ptrdiff_t Do_bound_stride) {
  ksl_SE3f_t D_i;
  if (n > 0) D_i = ksl_SE3f_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3f_of_planes(D + i * D_stride, D_plane);
    const float dc_i[2] = {dc[0 + i * dc_stride], dc[dc_plane + i * dc_stride]};
    ksl_SE3f_t Do_i;
    ksl_SE3f_t Do_bound_i;
    ksl_product_ddryf_certified(&D_i, dc_i, &Do_i, &Do_bound_i);
    ksl_SE3f_to_planes(&Do_i, Do + i * Do_stride, Do_plane);
    ksl_SE3f_to_planes(&Do_bound_i, Do_bound + i * Do_bound_stride, Do_bound_plane);
  }
}

/* ksl_product_ddtyf_certified of n elements. */
static KSL_INLINED void ksl_product_ddtyf_certified_many(ptrdiff_t n, const ksl_SE3f_t *D,
    ptrdiff_t D_stride, const float *k, ptrdiff_t k_stride, ksl_SE3f_t *Do,
    ptrdiff_t Do_stride, ksl_SE3f_t *Do_bound, ptrdiff_t Do_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_product_ddtyf_certified(D + i * D_stride, k[i * k_stride], Do + i * Do_stride,
        Do_bound + i * Do_bound_stride);
  }
}

static KSL_INLINED void ksl_product_ddtyf_certified_planes(ptrdiff_t n, const float *D,
    ptrdiff_t D_plane, ptrdiff_t D_stride, const float *k, ptrdiff_t k_stride,
    float *Do, ptrdiff_t Do_plane, ptrdiff_t Do_stride, float *Do_bound,
    ptrdiff_t Do_bound_plane, ptrdiff_t Do_bound_stride) {
  ksl_SE3f_t D_i;
  if (n > 0) D_i = ksl_SE3f_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3f_of_planes(D + i * D_stride, D_plane);
    ksl_SE3f_t Do_i;
    ksl_SE3f_t Do_bound_i;
    ksl_product_ddtyf_certified(&D_i, k[i * k_stride], &Do_i, &Do_bound_i);
    ksl_SE3f_to_planes(&Do_i, Do + i * Do_stride, Do_plane);
    ksl_SE3f_to_planes(&Do_bound_i, Do_bound + i * Do_bound_stride, Do_bound_plane);
  }
}

/* ksl_product_drvtyinvf_certified of n elements. */
static KSL_INLINED void ksl_product_drvtyinvf_certified_many(ptrdiff_t n, const ksl_mat3x3f_t *R,
    ptrdiff_t R_stride, const float *k, ptrdiff_t k_stride, ksl_vec3f_t *vo,
    ptrdiff_t vo_stride, ksl_vec3f_t *vo_bound, ptrdiff_t vo_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_product_drvtyinvf_certified(R + i * R_stride, k[i * k_stride], vo + i * vo_stride,
        vo_bound + i * vo_bound_stride);
  }
}

static KSL_INLINED void ksl_product_drvtyinvf_certified_planes(ptrdiff_t n, const float *R,
    ptrdiff_t R_plane, ptrdiff_t R_stride, const float *k, ptrdiff_t k_stride,
    float *vo, ptrdiff_t vo_plane, ptrdiff_t vo_stride, float *vo_bound,
    ptrdiff_t vo_bound_plane, ptrdiff_t vo_bound_stride) {
  ksl_mat3x3f_t R_i;
  if (n > 0) R_i = ksl_mat3x3f_of_planes(R, R_plane);
  KSL_EACH_OF(n) {
    if (R_stride) R_i = ksl_mat3x3f_of_planes(R + i * R_stride, R_plane);
    ksl_vec3f_t vo_i;
    ksl_vec3f_t vo_bound_i;
    ksl_product_drvtyinvf_certified(&R_i, k[i * k_stride], &vo_i, &vo_bound_i);
    ksl_vec3f_to_planes(&vo_i, vo + i * vo_stride, vo_plane);
    ksl_vec3f_to_planes(&vo_bound_i, vo_bound + i * vo_bound_stride, vo_bound_plane);
  }
}

/* ksl_product_drdryinvf_certified of n elements. */
static KSL_INLINED void ksl_product_drdryinvf_certified_many(ptrdiff_t n, const ksl_mat3x3f_t *R,
    ptrdiff_t R_stride, const float *dc, ptrdiff_t dc_stride, ksl_mat3x3f_t *Ro,
    ptrdiff_t Ro_stride, ksl_mat3x3f_t *Ro_bound, ptrdiff_t Ro_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_product_drdryinvf_certified(R + i * R_stride, dc + 2 * i * dc_stride, Ro + i * Ro_stride,
        Ro_bound + i * Ro_bound_stride);
  }
}

static KSL_INLINED void ksl_product_drdryinvf_certified_planes(ptrdiff_t n, const float *R,
    ptrdiff_t R_plane, ptrdiff_t R_stride, const float *dc, ptrdiff_t dc_plane,
    ptrdiff_t dc_stride, float *Ro, ptrdiff_t Ro_plane, ptrdiff_t Ro_stride,
    float *Ro_bound, ptrdiff_t Ro_bound_plane, ptrdiff_t Ro_bound_stride) {
  ksl_mat3x3f_t R_i;
  if (n > 0) R_i = ksl_mat3x3f_of_planes(R, R_plane);
  KSL_EACH_OF(n) {
    if (R_stride) R_i = ksl_mat3x3f_of_planes(R + i * R_stride, R_plane);
    const float dc_i[2] = {dc[0 + i * dc_stride], dc[dc_plane + i * dc_stride]};
    ksl_mat3x3f_t Ro_i;
    ksl_mat3x3f_t Ro_bound_i;
    ksl_product_drdryinvf_certified(&R_i, dc_i, &Ro_i, &Ro_bound_i);
    ksl_mat3x3f_to_planes(&Ro_i, Ro + i * Ro_stride, Ro_plane);
    ksl_mat3x3f_to_planes(&Ro_bound_i, Ro_bound + i * Ro_bound_stride, Ro_bound_plane);
  }
}

/* ksl_product_ddryinvf_certified of n elements. */
static KSL_INLINED void ksl_product_ddryinvf_certified_many(ptrdiff_t n, const ksl_SE3f_t *D,
    ptrdiff_t D_stride, const float *dc, ptrdiff_t dc_stride, ksl_SE3f_t *Do,
    ptrdiff_t Do_stride, ksl_SE3f_t *Do_bound, ptrdiff_t Do_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_product_ddryinvf_certified(D + i * D_stride, dc + 2 * i * dc_stride, Do + i * Do_stride,
        Do_bound + i * Do_bound_stride);
  }
}

static KSL_INLINED void ksl_product_ddryinvf_certified_planes(ptrdiff_t n, const float *D,
    ptrdiff_t D_plane, ptrdiff_t D_stride, const float *dc, ptrdiff_t dc_plane,
    ptrdiff_t dc_stride, float *Do, ptrdiff_t Do_plane, ptrdiff_t Do_stride,
    float *Do_bound, ptrdiff_t Do_bound_plane, ptrdiff_t Do_bound_stride) {
  ksl_SE3f_t D_i;
  if (n > 0) D_i = ksl_SE3f_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3f_of_planes(D + i * D_stride, D_plane);
    const float dc_i[2] = {dc[0 + i * dc_stride], dc[dc_plane + i * dc_stride]};
    ksl_SE3f_t Do_i;
    ksl_SE3f_t Do_bound_i;
    ksl_product_ddryinvf_certified(&D_i, dc_i, &Do_i, &Do_bound_i);
    ksl_SE3f_to_planes(&Do_i, Do + i * Do_stride, Do_plane);
    ksl_SE3f_to_planes(&Do_bound_i, Do_bound + i * Do_bound_stride, Do_bound_plane);
  }
}

/* ksl_product_ddtyinvf_certified of n elements. */
static KSL_INLINED void ksl_product_ddtyinvf_certified_many(ptrdiff_t n, const ksl_SE3f_t *D,
    ptrdiff_t D_stride, const float *k, ptrdiff_t k_stride, ksl_SE3f_t *Do,
    ptrdiff_t Do_stride, ksl_SE3f_t *Do_bound, ptrdiff_t Do_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_product_ddtyinvf_certified(D + i * D_stride, k[i * k_stride], Do + i * Do_stride,
        Do_bound + i * Do_bound_stride);
  }
}

static KSL_INLINED void ksl_product_ddtyinvf_certified_planes(ptrdiff_t n, const float *D,
    ptrdiff_t D_plane, ptrdiff_t D_stride, const float *k, ptrdiff_t k_stride,
    float *Do, ptrdiff_t Do_plane, ptrdiff_t Do_stride, float *Do_bound,
    ptrdiff_t Do_bound_plane, ptrdiff_t Do_bound_stride) {
  ksl_SE3f_t D_i;
  if (n > 0) D_i = ksl_SE3f_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3f_of_planes(D + i * D_stride, D_plane);
    ksl_SE3f_t Do_i;
    ksl_SE3f_t Do_bound_i;
    ksl_product_ddtyinvf_certified(&D_i, k[i * k_stride], &Do_i, &Do_bound_i);
    ksl_SE3f_to_planes(&Do_i, Do + i * Do_stride, Do_plane);
    ksl_SE3f_to_planes(&Do_bound_i, Do_bound + i * Do_bound_stride, Do_bound_plane);
  }
}

/* ksl_product_drvtzf_certified of n elements. */
static KSL_INLINED void ksl_product_drvtzf_certified_many(ptrdiff_t n, const ksl_mat3x3f_t *R,
    ptrdiff_t R_stride, const float *k, ptrdiff_t k_stride, ksl_vec3f_t *vo,
    ptrdiff_t vo_stride, ksl_vec3f_t *vo_bound, ptrdiff_t vo_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_product_drvtzf_certified(R + i * R_stride, k[i * k_stride], vo + i * vo_stride,
        vo_bound + i * vo_bound_stride);
  }
}

static KSL_INLINED void ksl_product_drvtzf_certified_planes(ptrdiff_t n, const float *R,
    ptrdiff_t R_plane, ptrdiff_t R_stride, const float *k, ptrdiff_t k_stride,
    float *vo, ptrdiff_t vo_plane, ptrdiff_t vo_stride, float *vo_bound,
    ptrdiff_t vo_bound_plane, ptrdiff_t vo_bound_stride) {
  ksl_mat3x3f_t R_i;
  if (n > 0) R_i = ksl_mat3x3f_of_planes(R, R_plane);
  KSL_EACH_OF(n) {
    if (R_stride) R_i = ksl_mat3x3f_of_planes(R + i * R_stride, R_plane);
    ksl_vec3f_t vo_i;
    ksl_vec3f_t vo_bound_i;
    ksl_product_drvtzf_certified(&R_i, k[i * k_stride], &vo_i, &vo_bound_i);
    ksl_vec3f_to_planes(&vo_i, vo + i * vo_stride, vo_plane);
    ksl_vec3f_to_planes(&vo_bound_i, vo_bound + i * vo_bound_stride, vo_bound_plane);
  }
}

/* ksl_product_drdrzf_certified of n elements. */
static KSL_INLINED void ksl_product_drdrzf_certified_many(ptrdiff_t n, const ksl_mat3x3f_t *R,
    ptrdiff_t R_stride, const float *dc, ptrdiff_t dc_stride, ksl_mat3x3f_t *Ro,
    ptrdiff_t Ro_stride, ksl_mat3x3f_t *Ro_bound, ptrdiff_t Ro_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_product_drdrzf_certified(R + i * R_stride, dc + 2 * i * dc_stride, Ro + i * Ro_stride,
        Ro_bound + i * Ro_bound_stride);
  }
}

static KSL_INLINED void ksl_product_drdrzf_certified_planes(ptrdiff_t n, const float *R,
    ptrdiff_t R_plane, ptrdiff_t R_stride, const float *dc, ptrdiff_t dc_plane,
    ptrdiff_t dc_stride, float *Ro, ptrdiff_t Ro_plane, ptrdiff_t Ro_stride,
    float *Ro_bound, ptrdiff_t Ro_bound_plane, ptrdiff_t Ro_bound_stride) {
  ksl_mat3x3f_t R_i;
  if (n > 0) R_i = ksl_mat3x3f_of_planes(R, R_plane);
  KSL_EACH_OF(n) {
    if (R_stride) R_i = ksl_mat3x3f_of_planes(R + i * R_stride, R_plane);
    const float dc_i[2] = {dc[0 + i * dc_stride], dc[dc_plane + i * dc_stride]};
    ksl_mat3x3f_t Ro_i;
    ksl_mat3x3f_t Ro_bound_i;
    ksl_product_drdrzf_certified(&R_i, dc_i, &Ro_i, &Ro_bound_i);
    ksl_mat3x3f_to_planes(&Ro_i, Ro + i * Ro_stride, Ro_plane);
    ksl_mat3x3f_to_planes(&Ro_bound_i, Ro_bound + i * Ro_bound_stride, Ro_bound_plane);
  }
}

/* ksl_product_ddrzf_certified of n elements. */
static KSL_INLINED void ksl_product_ddrzf_certified_many(ptrdiff_t n, const ksl_SE3f_t *D,
    ptrdiff_t D_stride, const float *dc, ptrdiff_t dc_stride, ksl_SE3f_t *Do,
    ptrdiff_t Do_stride, ksl_SE3f_t *Do_bound, ptrdiff_t Do_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_product_ddrzf_certified(D + i * D_stride, dc + 2 * i * dc_stride, Do + i * Do_stride,
        Do_bound + i * Do_bound_stride);
  }
}

static KSL_INLINED void ksl_product_ddrzf_certified_planes(ptrdiff_t n, const float *D,
    ptrdiff_t D_plane, ptrdiff_t D_stride, const float *dc, ptrdiff_t dc_plane,
    ptrdiff_t dc_stride, float *Do, ptrdiff_t Do_plane, ptrdiff_t Do_stride,
    float *Do_bound, ptrdiff_t Do_bound_plane, ptrdiff_t Do_bound_stride) {
  ksl_SE3f_t D_i;
  if (n > 0) D_i = ksl_SE3f_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3f_of_planes(D + i * D_stride, D_plane);
    const float dc_i[2] = {dc[0 + i * dc_stride], dc[dc_plane + i * dc_stride]};
    ksl_SE3f_t Do_i;
    ksl_SE3f_t Do_bound_i;
    ksl_product_ddrzf_certified(&D_i, dc_i, &Do_i, &Do_bound_i);
    ksl_SE3f_to_planes(&Do_i, Do + i * Do_stride, Do_plane);
    ksl_SE3f_to_planes(&Do_bound_i, Do_bound + i * Do_bound_stride, Do_bound_plane);
  }
}

/* ksl_product_ddtzf_certified of n elements. */
static KSL_INLINED void ksl_product_ddtzf_certified_many(ptrdiff_t n, const ksl_SE3f_t *D,
    ptrdiff_t D_stride, const float *k, ptrdiff_t k_stride, ksl_SE3f_t *Do,
    ptrdiff_t Do_stride, ksl_SE3f_t *Do_bound, ptrdiff_t Do_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_product_ddtzf_certified(D + i * D_stride, k[i * k_stride], Do + i * Do_stride,
        Do_bound + i * Do_bound_stride);
  }
}

static KSL_INLINED void ksl_product_ddtzf_certified_planes(ptrdiff_t n, const float *D,
    ptrdiff_t D_plane, ptrdiff_t D_stride, const float *k, ptrdiff_t k_stride,
    float *Do, ptrdiff_t Do_plane, ptrdiff_t Do_stride, float *Do_bound,
    ptrdiff_t Do_bound_plane, ptrdiff_t Do_bound_stride) {
  ksl_SE3f_t D_i;
  if (n > 0) D_i = ksl_SE3f_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3f_of_planes(D + i * D_stride, D_plane);
    ksl_SE3f_t Do_i;
    ksl_SE3f_t Do_bound_i;
    ksl_product_ddtzf_certified(&D_i, k[i * k_stride], &Do_i, &Do_bound_i);
    ksl_SE3f_to_planes(&Do_i, Do + i * Do_stride, Do_plane);
    ksl_SE3f_to_planes(&Do_bound_i, Do_bound + i * Do_bound_stride, Do_bound_plane);
  }
}

/* ksl_product_drvtzinvf_certified of n elements. */
static KSL_INLINED void ksl_product_drvtzinvf_certified_many(ptrdiff_t n, const ksl_mat3x3f_t *R,
    ptrdiff_t R_stride, const float *k, ptrdiff_t k_stride, ksl_vec3f_t *vo,
    ptrdiff_t vo_stride, ksl_vec3f_t *vo_bound, ptrdiff_t vo_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_product_drvtzinvf_certified(R + i * R_stride, k[i * k_stride], vo + i * vo_stride,
        vo_bound + i * vo_bound_stride);
  }
}

static KSL_INLINED void ksl_product_drvtzinvf_certified_planes(ptrdiff_t n, const float *R,
    ptrdiff_t R_plane, ptrdiff_t R_stride, const float *k, ptrdiff_t k_stride,
    float *vo, ptrdiff_t vo_plane, ptrdiff_t vo_stride, float *vo_bound,
    ptrdiff_t vo_bound_plane, ptrdiff_t vo_bound_stride) {
  ksl_mat3x3f_t R_i;
  if (n > 0) R_i = ksl_mat3x3f_of_planes(R, R_plane);
  KSL_EACH_OF(n) {
    if (R_stride) R_i = ksl_mat3x3f_of_planes(R + i * R_stride, R_plane);
    ksl_vec3f_t vo_i;
    ksl_vec3f_t vo_bound_i;
    ksl_product_drvtzinvf_certified(&R_i, k[i * k_stride], &vo_i, &vo_bound_i);
    ksl_vec3f_to_planes(&vo_i, vo + i * vo_stride, vo_plane);
    ksl_vec3f_to_planes(&vo_bound_i, vo_bound + i * vo_bound_stride, vo_bound_plane);
  }
}

/* ksl_product_drdrzinvf_certified of n elements. */
static KSL_INLINED void ksl_product_drdrzinvf_certified_many(ptrdiff_t n, const ksl_mat3x3f_t *R,
    ptrdiff_t R_stride, const float *dc, ptrdiff_t dc_stride, ksl_mat3x3f_t *Ro,
    ptrdiff_t Ro_stride, ksl_mat3x3f_t *Ro_bound, ptrdiff_t Ro_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_product_drdrzinvf_certified(R + i * R_stride, dc + 2 * i * dc_stride, Ro + i * Ro_stride,
        Ro_bound + i * Ro_bound_stride);
  }
}

static KSL_INLINED void ksl_product_drdrzinvf_certified_planes(ptrdiff_t n, const float *R,
    ptrdiff_t R_plane, ptrdiff_t R_stride, const float *dc, ptrdiff_t dc_plane,
    ptrdiff_t dc_stride, float *Ro, ptrdiff_t Ro_plane, ptrdiff_t Ro_stride,
    float *Ro_bound, ptrdiff_t Ro_bound_plane, ptrdiff_t Ro_bound_stride) {
  ksl_mat3x3f_t R_i;
  if (n > 0) R_i = ksl_mat3x3f_of_planes(R, R_plane);
  KSL_EACH_OF(n) {
    if (R_stride) R_i = ksl_mat3x3f_of_planes(R + i * R_stride, R_plane);
    const float dc_i[2] = {dc[0 + i * dc_stride], dc[dc_plane + i * dc_stride]};
    ksl_mat3x3f_t Ro_i;
    ksl_mat3x3f_t Ro_bound_i;
    ksl_product_drdrzinvf_certified(&R_i, dc_i, &Ro_i, &Ro_bound_i);
    ksl_mat3x3f_to_planes(&Ro_i, Ro + i * Ro_stride, Ro_plane);
    ksl_mat3x3f_to_planes(&Ro_bound_i, Ro_bound + i * Ro_bound_stride, Ro_bound_plane);
  }
}

/* ksl_product_ddrzinvf_certified of n elements. */
static KSL_INLINED void ksl_product_ddrzinvf_certified_many(ptrdiff_t n, const ksl_SE3f_t *D,
    ptrdiff_t D_stride, const float *dc, ptrdiff_t dc_stride, ksl_SE3f_t *Do,
    ptrdiff_t Do_stride, ksl_SE3f_t *Do_bound, ptrdiff_t Do_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_product_ddrzinvf_certified(D + i * D_stride, dc + 2 * i * dc_stride, Do + i * Do_stride,
        Do_bound + i * Do_bound_stride);
  }
}

static KSL_INLINED void ksl_product_ddrzinvf_certified_planes(ptrdiff_t n, const float *D,
    ptrdiff_t D_plane, ptrdiff_t D_stride, const float *dc, ptrdiff_t dc_plane,
    ptrdiff_t dc_stride, float *Do, ptrdiff_t Do_plane, ptrdiff_t Do_stride,
    float *Do_bound, ptrdiff_t Do_bound_plane, ptrdiff_t Do_bound_stride) {
  ksl_SE3f_t D_i;
  if (n > 0) D_i = ksl_SE3f_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3f_of_planes(D + i * D_stride, D_plane);
    const float dc_i[2] = {dc[0 + i * dc_stride], dc[dc_plane + i * dc_stride]};
    ksl_SE3f_t Do_i;
    ksl_SE3f_t Do_bound_i;
    ksl_product_ddrzinvf_certified(&D_i, dc_i, &Do_i, &Do_bound_i);
    ksl_SE3f_to_planes(&Do_i, Do + i * Do_stride, Do_plane);
    ksl_SE3f_to_planes(&Do_bound_i, Do_bound + i * Do_bound_stride, Do_bound_plane);
  }
}

/* ksl_product_ddtzinvf_certified of n elements. */
static KSL_INLINED void ksl_product_ddtzinvf_certified_many(ptrdiff_t n, const ksl_SE3f_t *D,
    ptrdiff_t D_stride, const float *k, ptrdiff_t k_stride, ksl_SE3f_t *Do,
    ptrdiff_t Do_stride, ksl_SE3f_t *Do_bound, ptrdiff_t Do_bound_stride) {
  KSL_EACH_OF(n) {
    ksl_product_ddtzinvf_certified(D + i * D_stride, k[i * k_stride], Do + i * Do_stride,
        Do_bound + i * Do_bound_stride);
  }
}

static KSL_INLINED void ksl_product_ddtzinvf_certified_planes(ptrdiff_t n, const float *D,
    ptrdiff_t D_plane, ptrdiff_t D_stride, const float *k, ptrdiff_t k_stride,
    float *Do, ptrdiff_t Do_plane, ptrdiff_t Do_stride, float *Do_bound,
    ptrdiff_t Do_bound_plane, ptrdiff_t Do_bound_stride) {
  ksl_SE3f_t D_i;
  if (n > 0) D_i = ksl_SE3f_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3f_of_planes(D + i * D_stride, D_plane);
    ksl_SE3f_t Do_i;
    ksl_SE3f_t Do_bound_i;
    ksl_product_ddtzinvf_certified(&D_i, k[i * k_stride], &Do_i, &Do_bound_i);
    ksl_SE3f_to_planes(&Do_i, Do + i * Do_stride, Do_plane);
    ksl_SE3f_to_planes(&Do_bound_i, Do_bound + i * Do_bound_stride, Do_bound_plane);
  }
}

#endif
