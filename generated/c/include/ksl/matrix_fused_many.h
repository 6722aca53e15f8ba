/* Made by `coscrew generate`; changes are overwritten. */
/* SPDX-License-Identifier: MIT */
/* coscrew 0.2.0.  Copyright (c) 2026 The coscrew authors. */
/* Products between rotations, displacements and vectors.  Many at a time.
   What arguments are, and what loops over them cost, ksl_planes.h says. */
#ifndef KSL_MATRIX_FUSED_MANY_H
#define KSL_MATRIX_FUSED_MANY_H

#include "matrix_fused.h"
#include "ksl_planes.h"

/* ksl_product_drv_fused of n elements. */
static KSL_INLINED void ksl_product_drv_fused_many(ptrdiff_t n, const ksl_mat3x3_t *R,
    ptrdiff_t R_stride, const ksl_vec3_t *v, ptrdiff_t v_stride, ksl_vec3_t *vo,
    ptrdiff_t vo_stride) {
  KSL_EACH_OF(n) {
    ksl_product_drv_fused(R + i * R_stride, v + i * v_stride, vo + i * vo_stride);
  }
}

static KSL_INLINED void ksl_product_drv_fused_planes(ptrdiff_t n, const double *R,
    ptrdiff_t R_plane, ptrdiff_t R_stride, const double *v, ptrdiff_t v_plane,
    ptrdiff_t v_stride, double *vo, ptrdiff_t vo_plane, ptrdiff_t vo_stride) {
  ksl_mat3x3_t R_i;
  if (n > 0) R_i = ksl_mat3x3_of_planes(R, R_plane);
  KSL_EACH_OF(n) {
    if (R_stride) R_i = ksl_mat3x3_of_planes(R + i * R_stride, R_plane);
    const ksl_vec3_t v_i = ksl_vec3_of_planes(v + i * v_stride, v_plane);
    ksl_vec3_t vo_i;
    ksl_product_drv_fused(&R_i, &v_i, &vo_i);
    ksl_vec3_to_planes(&vo_i, vo + i * vo_stride, vo_plane);
  }
}

/* ksl_product_drvinv_fused of n elements. */
static KSL_INLINED void ksl_product_drvinv_fused_many(ptrdiff_t n, const ksl_mat3x3_t *R,
    ptrdiff_t R_stride, const ksl_vec3_t *v, ptrdiff_t v_stride, ksl_vec3_t *vo,
    ptrdiff_t vo_stride) {
  KSL_EACH_OF(n) {
    ksl_product_drvinv_fused(R + i * R_stride, v + i * v_stride, vo + i * vo_stride);
  }
}

static KSL_INLINED void ksl_product_drvinv_fused_planes(ptrdiff_t n, const double *R,
    ptrdiff_t R_plane, ptrdiff_t R_stride, const double *v, ptrdiff_t v_plane,
    ptrdiff_t v_stride, double *vo, ptrdiff_t vo_plane, ptrdiff_t vo_stride) {
  ksl_mat3x3_t R_i;
  if (n > 0) R_i = ksl_mat3x3_of_planes(R, R_plane);
  KSL_EACH_OF(n) {
    if (R_stride) R_i = ksl_mat3x3_of_planes(R + i * R_stride, R_plane);
    const ksl_vec3_t v_i = ksl_vec3_of_planes(v + i * v_stride, v_plane);
    ksl_vec3_t vo_i;
    ksl_product_drvinv_fused(&R_i, &v_i, &vo_i);
    ksl_vec3_to_planes(&vo_i, vo + i * vo_stride, vo_plane);
  }
}

/* ksl_product_drinvv_fused of n elements. */
static KSL_INLINED void ksl_product_drinvv_fused_many(ptrdiff_t n, const ksl_mat3x3_t *R,
    ptrdiff_t R_stride, const ksl_vec3_t *v, ptrdiff_t v_stride, ksl_vec3_t *vo,
    ptrdiff_t vo_stride) {
  KSL_EACH_OF(n) {
    ksl_product_drinvv_fused(R + i * R_stride, v + i * v_stride, vo + i * vo_stride);
  }
}

static KSL_INLINED void ksl_product_drinvv_fused_planes(ptrdiff_t n, const double *R,
    ptrdiff_t R_plane, ptrdiff_t R_stride, const double *v, ptrdiff_t v_plane,
    ptrdiff_t v_stride, double *vo, ptrdiff_t vo_plane, ptrdiff_t vo_stride) {
  ksl_mat3x3_t R_i;
  if (n > 0) R_i = ksl_mat3x3_of_planes(R, R_plane);
  KSL_EACH_OF(n) {
    if (R_stride) R_i = ksl_mat3x3_of_planes(R + i * R_stride, R_plane);
    const ksl_vec3_t v_i = ksl_vec3_of_planes(v + i * v_stride, v_plane);
    ksl_vec3_t vo_i;
    ksl_product_drinvv_fused(&R_i, &v_i, &vo_i);
    ksl_vec3_to_planes(&vo_i, vo + i * vo_stride, vo_plane);
  }
}

/* ksl_product_drinvvinv_fused of n elements. */
static KSL_INLINED void ksl_product_drinvvinv_fused_many(ptrdiff_t n, const ksl_mat3x3_t *R,
    ptrdiff_t R_stride, const ksl_vec3_t *v, ptrdiff_t v_stride, ksl_vec3_t *vo,
    ptrdiff_t vo_stride) {
  KSL_EACH_OF(n) {
    ksl_product_drinvvinv_fused(R + i * R_stride, v + i * v_stride, vo + i * vo_stride);
  }
}

static KSL_INLINED void ksl_product_drinvvinv_fused_planes(ptrdiff_t n, const double *R,
    ptrdiff_t R_plane, ptrdiff_t R_stride, const double *v, ptrdiff_t v_plane,
    ptrdiff_t v_stride, double *vo, ptrdiff_t vo_plane, ptrdiff_t vo_stride) {
  ksl_mat3x3_t R_i;
  if (n > 0) R_i = ksl_mat3x3_of_planes(R, R_plane);
  KSL_EACH_OF(n) {
    if (R_stride) R_i = ksl_mat3x3_of_planes(R + i * R_stride, R_plane);
    const ksl_vec3_t v_i = ksl_vec3_of_planes(v + i * v_stride, v_plane);
    ksl_vec3_t vo_i;
    ksl_product_drinvvinv_fused(&R_i, &v_i, &vo_i);
    ksl_vec3_to_planes(&vo_i, vo + i * vo_stride, vo_plane);
  }
}

/* ksl_product_dv_fused of n elements. */
static KSL_INLINED void ksl_product_dv_fused_many(ptrdiff_t n, const ksl_SE3_t *D,
    ptrdiff_t D_stride, const ksl_vec3_t *v, ptrdiff_t v_stride, ksl_vec3_t *vo,
    ptrdiff_t vo_stride) {
  KSL_EACH_OF(n) {
    ksl_product_dv_fused(D + i * D_stride, v + i * v_stride, vo + i * vo_stride);
  }
}

static KSL_INLINED void ksl_product_dv_fused_planes(ptrdiff_t n, const double *D, ptrdiff_t D_plane,
    ptrdiff_t D_stride, const double *v, ptrdiff_t v_plane, ptrdiff_t v_stride,
    double *vo, ptrdiff_t vo_plane, ptrdiff_t vo_stride) {
  ksl_SE3_t D_i;
  if (n > 0) D_i = ksl_SE3_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3_of_planes(D + i * D_stride, D_plane);
    const ksl_vec3_t v_i = ksl_vec3_of_planes(v + i * v_stride, v_plane);
    ksl_vec3_t vo_i;
    ksl_product_dv_fused(&D_i, &v_i, &vo_i);
    ksl_vec3_to_planes(&vo_i, vo + i * vo_stride, vo_plane);
  }
}

/* ksl_product_dinvv_fused of n elements. */
static KSL_INLINED void ksl_product_dinvv_fused_many(ptrdiff_t n, const ksl_SE3_t *D,
    ptrdiff_t D_stride, const ksl_vec3_t *v, ptrdiff_t v_stride, ksl_vec3_t *vo,
    ptrdiff_t vo_stride) {
  KSL_EACH_OF(n) {
    ksl_product_dinvv_fused(D + i * D_stride, v + i * v_stride, vo + i * vo_stride);
  }
}

static KSL_INLINED void ksl_product_dinvv_fused_planes(ptrdiff_t n, const double *D,
    ptrdiff_t D_plane, ptrdiff_t D_stride, const double *v, ptrdiff_t v_plane,
    ptrdiff_t v_stride, double *vo, ptrdiff_t vo_plane, ptrdiff_t vo_stride) {
  ksl_SE3_t D_i;
  if (n > 0) D_i = ksl_SE3_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3_of_planes(D + i * D_stride, D_plane);
    const ksl_vec3_t v_i = ksl_vec3_of_planes(v + i * v_stride, v_plane);
    ksl_vec3_t vo_i;
    ksl_product_dinvv_fused(&D_i, &v_i, &vo_i);
    ksl_vec3_to_planes(&vo_i, vo + i * vo_stride, vo_plane);
  }
}

/* ksl_product_drdr_fused of n elements. */
static KSL_INLINED void ksl_product_drdr_fused_many(ptrdiff_t n, const ksl_mat3x3_t *R1,
    ptrdiff_t R1_stride, const ksl_mat3x3_t *R2, ptrdiff_t R2_stride,
    ksl_mat3x3_t *Ro, ptrdiff_t Ro_stride) {
  KSL_EACH_OF(n) {
    ksl_product_drdr_fused(R1 + i * R1_stride, R2 + i * R2_stride, Ro + i * Ro_stride);
  }
}

static KSL_INLINED void ksl_product_drdr_fused_planes(ptrdiff_t n, const double *R1,
    ptrdiff_t R1_plane, ptrdiff_t R1_stride, const double *R2,
    ptrdiff_t R2_plane, ptrdiff_t R2_stride, double *Ro, ptrdiff_t Ro_plane,
    ptrdiff_t Ro_stride) {
  ksl_mat3x3_t R1_i;
  if (n > 0) R1_i = ksl_mat3x3_of_planes(R1, R1_plane);
  KSL_EACH_OF(n) {
    if (R1_stride) R1_i = ksl_mat3x3_of_planes(R1 + i * R1_stride, R1_plane);
    const ksl_mat3x3_t R2_i = ksl_mat3x3_of_planes(R2 + i * R2_stride, R2_plane);
    ksl_mat3x3_t Ro_i;
    ksl_product_drdr_fused(&R1_i, &R2_i, &Ro_i);
    ksl_mat3x3_to_planes(&Ro_i, Ro + i * Ro_stride, Ro_plane);
  }
}

/* ksl_product_drdrinv_fused of n elements. */
static KSL_INLINED void ksl_product_drdrinv_fused_many(ptrdiff_t n, const ksl_mat3x3_t *R1,
    ptrdiff_t R1_stride, const ksl_mat3x3_t *R2, ptrdiff_t R2_stride,
    ksl_mat3x3_t *Ro, ptrdiff_t Ro_stride) {
  KSL_EACH_OF(n) {
    ksl_product_drdrinv_fused(R1 + i * R1_stride, R2 + i * R2_stride, Ro + i * Ro_stride);
  }
}

static KSL_INLINED void ksl_product_drdrinv_fused_planes(ptrdiff_t n, const double *R1,
    ptrdiff_t R1_plane, ptrdiff_t R1_stride, const double *R2,
    ptrdiff_t R2_plane, ptrdiff_t R2_stride, double *Ro, ptrdiff_t Ro_plane,
    ptrdiff_t Ro_stride) {
  ksl_mat3x3_t R1_i;
  if (n > 0) R1_i = ksl_mat3x3_of_planes(R1, R1_plane);
  KSL_EACH_OF(n) {
    if (R1_stride) R1_i = ksl_mat3x3_of_planes(R1 + i * R1_stride, R1_plane);
    const ksl_mat3x3_t R2_i = ksl_mat3x3_of_planes(R2 + i * R2_stride, R2_plane);
    ksl_mat3x3_t Ro_i;
    ksl_product_drdrinv_fused(&R1_i, &R2_i, &Ro_i);
    ksl_mat3x3_to_planes(&Ro_i, Ro + i * Ro_stride, Ro_plane);
  }
}

/* ksl_product_drinvdr_fused of n elements. */
static KSL_INLINED void ksl_product_drinvdr_fused_many(ptrdiff_t n, const ksl_mat3x3_t *R1,
    ptrdiff_t R1_stride, const ksl_mat3x3_t *R2, ptrdiff_t R2_stride,
    ksl_mat3x3_t *Ro, ptrdiff_t Ro_stride) {
  KSL_EACH_OF(n) {
    ksl_product_drinvdr_fused(R1 + i * R1_stride, R2 + i * R2_stride, Ro + i * Ro_stride);
  }
}

static KSL_INLINED void ksl_product_drinvdr_fused_planes(ptrdiff_t n, const double *R1,
    ptrdiff_t R1_plane, ptrdiff_t R1_stride, const double *R2,
    ptrdiff_t R2_plane, ptrdiff_t R2_stride, double *Ro, ptrdiff_t Ro_plane,
    ptrdiff_t Ro_stride) {
  ksl_mat3x3_t R1_i;
  if (n > 0) R1_i = ksl_mat3x3_of_planes(R1, R1_plane);
  KSL_EACH_OF(n) {
    if (R1_stride) R1_i = ksl_mat3x3_of_planes(R1 + i * R1_stride, R1_plane);
    const ksl_mat3x3_t R2_i = ksl_mat3x3_of_planes(R2 + i * R2_stride, R2_plane);
    ksl_mat3x3_t Ro_i;
    ksl_product_drinvdr_fused(&R1_i, &R2_i, &Ro_i);
    ksl_mat3x3_to_planes(&Ro_i, Ro + i * Ro_stride, Ro_plane);
  }
}

/* ksl_product_dd_fused of n elements. */
static KSL_INLINED void ksl_product_dd_fused_many(ptrdiff_t n, const ksl_SE3_t *D1,
    ptrdiff_t D1_stride, const ksl_SE3_t *D2, ptrdiff_t D2_stride, ksl_SE3_t *Do,
    ptrdiff_t Do_stride) {
  KSL_EACH_OF(n) {
    ksl_product_dd_fused(D1 + i * D1_stride, D2 + i * D2_stride, Do + i * Do_stride);
  }
}

static KSL_INLINED void ksl_product_dd_fused_planes(ptrdiff_t n, const double *D1,
    ptrdiff_t D1_plane, ptrdiff_t D1_stride, const double *D2,
    ptrdiff_t D2_plane, ptrdiff_t D2_stride, double *Do, ptrdiff_t Do_plane,
    ptrdiff_t Do_stride) {
  ksl_SE3_t D1_i;
  if (n > 0) D1_i = ksl_SE3_of_planes(D1, D1_plane);
  KSL_EACH_OF(n) {
    if (D1_stride) D1_i = ksl_SE3_of_planes(D1 + i * D1_stride, D1_plane);
    const ksl_SE3_t D2_i = ksl_SE3_of_planes(D2 + i * D2_stride, D2_plane);
    ksl_SE3_t Do_i;
    ksl_product_dd_fused(&D1_i, &D2_i, &Do_i);
    ksl_SE3_to_planes(&Do_i, Do + i * Do_stride, Do_plane);
  }
}

/* ksl_product_ddinv_fused of n elements. */
static KSL_INLINED void ksl_product_ddinv_fused_many(ptrdiff_t n, const ksl_SE3_t *D1,
    ptrdiff_t D1_stride, const ksl_SE3_t *D2, ptrdiff_t D2_stride, ksl_SE3_t *Do,
    ptrdiff_t Do_stride) {
  KSL_EACH_OF(n) {
    ksl_product_ddinv_fused(D1 + i * D1_stride, D2 + i * D2_stride, Do + i * Do_stride);
  }
}

static KSL_INLINED void ksl_product_ddinv_fused_planes(ptrdiff_t n, const double *D1,
    ptrdiff_t D1_plane, ptrdiff_t D1_stride, const double *D2,
    ptrdiff_t D2_plane, ptrdiff_t D2_stride, double *Do, ptrdiff_t Do_plane,
    ptrdiff_t Do_stride) {
  ksl_SE3_t D1_i;
  if (n > 0) D1_i = ksl_SE3_of_planes(D1, D1_plane);
  KSL_EACH_OF(n) {
    if (D1_stride) D1_i = ksl_SE3_of_planes(D1 + i * D1_stride, D1_plane);
    const ksl_SE3_t D2_i = ksl_SE3_of_planes(D2 + i * D2_stride, D2_plane);
    ksl_SE3_t Do_i;
    ksl_product_ddinv_fused(&D1_i, &D2_i, &Do_i);
    ksl_SE3_to_planes(&Do_i, Do + i * Do_stride, Do_plane);
  }
}

/* ksl_product_dinvd_fused of n elements. */
static KSL_INLINED void ksl_product_dinvd_fused_many(ptrdiff_t n, const ksl_SE3_t *D1,
    ptrdiff_t D1_stride, const ksl_SE3_t *D2, ptrdiff_t D2_stride, ksl_SE3_t *Do,
    ptrdiff_t Do_stride) {
  KSL_EACH_OF(n) {
    ksl_product_dinvd_fused(D1 + i * D1_stride, D2 + i * D2_stride, Do + i * Do_stride);
  }
}

static KSL_INLINED void ksl_product_dinvd_fused_planes(ptrdiff_t n, const double *D1,
    ptrdiff_t D1_plane, ptrdiff_t D1_stride, const double *D2,
    ptrdiff_t D2_plane, ptrdiff_t D2_stride, double *Do, ptrdiff_t Do_plane,
    ptrdiff_t Do_stride) {
  ksl_SE3_t D1_i;
  if (n > 0) D1_i = ksl_SE3_of_planes(D1, D1_plane);
  KSL_EACH_OF(n) {
    if (D1_stride) D1_i = ksl_SE3_of_planes(D1 + i * D1_stride, D1_plane);
    const ksl_SE3_t D2_i = ksl_SE3_of_planes(D2 + i * D2_stride, D2_plane);
    ksl_SE3_t Do_i;
    ksl_product_dinvd_fused(&D1_i, &D2_i, &Do_i);
    ksl_SE3_to_planes(&Do_i, Do + i * Do_stride, Do_plane);
  }
}

/* ksl_product_ddr_fused of n elements. */
static KSL_INLINED void ksl_product_ddr_fused_many(ptrdiff_t n, const ksl_SE3_t *D,
    ptrdiff_t D_stride, const ksl_mat3x3_t *R, ptrdiff_t R_stride, ksl_SE3_t *Do,
    ptrdiff_t Do_stride) {
  KSL_EACH_OF(n) {
    ksl_product_ddr_fused(D + i * D_stride, R + i * R_stride, Do + i * Do_stride);
  }
}

static KSL_INLINED void ksl_product_ddr_fused_planes(ptrdiff_t n, const double *D,
    ptrdiff_t D_plane, ptrdiff_t D_stride, const double *R, ptrdiff_t R_plane,
    ptrdiff_t R_stride, double *Do, ptrdiff_t Do_plane, ptrdiff_t Do_stride) {
  ksl_SE3_t D_i;
  if (n > 0) D_i = ksl_SE3_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3_of_planes(D + i * D_stride, D_plane);
    const ksl_mat3x3_t R_i = ksl_mat3x3_of_planes(R + i * R_stride, R_plane);
    ksl_SE3_t Do_i;
    ksl_product_ddr_fused(&D_i, &R_i, &Do_i);
    ksl_SE3_to_planes(&Do_i, Do + i * Do_stride, Do_plane);
  }
}

/* ksl_product_ddrinv_fused of n elements. */
static KSL_INLINED void ksl_product_ddrinv_fused_many(ptrdiff_t n, const ksl_SE3_t *D,
    ptrdiff_t D_stride, const ksl_mat3x3_t *R, ptrdiff_t R_stride, ksl_SE3_t *Do,
    ptrdiff_t Do_stride) {
  KSL_EACH_OF(n) {
    ksl_product_ddrinv_fused(D + i * D_stride, R + i * R_stride, Do + i * Do_stride);
  }
}

static KSL_INLINED void ksl_product_ddrinv_fused_planes(ptrdiff_t n, const double *D,
    ptrdiff_t D_plane, ptrdiff_t D_stride, const double *R, ptrdiff_t R_plane,
    ptrdiff_t R_stride, double *Do, ptrdiff_t Do_plane, ptrdiff_t Do_stride) {
  ksl_SE3_t D_i;
  if (n > 0) D_i = ksl_SE3_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3_of_planes(D + i * D_stride, D_plane);
    const ksl_mat3x3_t R_i = ksl_mat3x3_of_planes(R + i * R_stride, R_plane);
    ksl_SE3_t Do_i;
    ksl_product_ddrinv_fused(&D_i, &R_i, &Do_i);
    ksl_SE3_to_planes(&Do_i, Do + i * Do_stride, Do_plane);
  }
}

/* ksl_product_ddt_fused of n elements. */
static KSL_INLINED void ksl_product_ddt_fused_many(ptrdiff_t n, const ksl_SE3_t *D,
    ptrdiff_t D_stride, const ksl_vec3_t *t, ptrdiff_t t_stride, ksl_SE3_t *Do,
    ptrdiff_t Do_stride) {
  KSL_EACH_OF(n) {
    ksl_product_ddt_fused(D + i * D_stride, t + i * t_stride, Do + i * Do_stride);
  }
}

static KSL_INLINED void ksl_product_ddt_fused_planes(ptrdiff_t n, const double *D,
    ptrdiff_t D_plane, ptrdiff_t D_stride, const double *t, ptrdiff_t t_plane,
    ptrdiff_t t_stride, double *Do, ptrdiff_t Do_plane, ptrdiff_t Do_stride) {
  ksl_SE3_t D_i;
  if (n > 0) D_i = ksl_SE3_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3_of_planes(D + i * D_stride, D_plane);
    const ksl_vec3_t t_i = ksl_vec3_of_planes(t + i * t_stride, t_plane);
    ksl_SE3_t Do_i;
    ksl_product_ddt_fused(&D_i, &t_i, &Do_i);
    ksl_SE3_to_planes(&Do_i, Do + i * Do_stride, Do_plane);
  }
}

/* ksl_product_ddtinv_fused of n elements. */
static KSL_INLINED void ksl_product_ddtinv_fused_many(ptrdiff_t n, const ksl_SE3_t *D,
    ptrdiff_t D_stride, const ksl_vec3_t *t, ptrdiff_t t_stride, ksl_SE3_t *Do,
    ptrdiff_t Do_stride) {
  KSL_EACH_OF(n) {
    ksl_product_ddtinv_fused(D + i * D_stride, t + i * t_stride, Do + i * Do_stride);
  }
}

static KSL_INLINED void ksl_product_ddtinv_fused_planes(ptrdiff_t n, const double *D,
    ptrdiff_t D_plane, ptrdiff_t D_stride, const double *t, ptrdiff_t t_plane,
    ptrdiff_t t_stride, double *Do, ptrdiff_t Do_plane, ptrdiff_t Do_stride) {
  ksl_SE3_t D_i;
  if (n > 0) D_i = ksl_SE3_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3_of_planes(D + i * D_stride, D_plane);
    const ksl_vec3_t t_i = ksl_vec3_of_planes(t + i * t_stride, t_plane);
    ksl_SE3_t Do_i;
    ksl_product_ddtinv_fused(&D_i, &t_i, &Do_i);
    ksl_SE3_to_planes(&Do_i, Do + i * Do_stride, Do_plane);
  }
}

/* ksl_product_dinvdt_fused of n elements. */
static KSL_INLINED void ksl_product_dinvdt_fused_many(ptrdiff_t n, const ksl_SE3_t *D,
    ptrdiff_t D_stride, const ksl_vec3_t *t, ptrdiff_t t_stride, ksl_SE3_t *Do,
    ptrdiff_t Do_stride) {
  KSL_EACH_OF(n) {
    ksl_product_dinvdt_fused(D + i * D_stride, t + i * t_stride, Do + i * Do_stride);
  }
}

static KSL_INLINED void ksl_product_dinvdt_fused_planes(ptrdiff_t n, const double *D,
    ptrdiff_t D_plane, ptrdiff_t D_stride, const double *t, ptrdiff_t t_plane,
    ptrdiff_t t_stride, double *Do, ptrdiff_t Do_plane, ptrdiff_t Do_stride) {
  ksl_SE3_t D_i;
  if (n > 0) D_i = ksl_SE3_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3_of_planes(D + i * D_stride, D_plane);
    const ksl_vec3_t t_i = ksl_vec3_of_planes(t + i * t_stride, t_plane);
    ksl_SE3_t Do_i;
    ksl_product_dinvdt_fused(&D_i, &t_i, &Do_i);
    ksl_SE3_to_planes(&Do_i, Do + i * Do_stride, Do_plane);
  }
}

/* ksl_product_drvtx_fused of n elements. */
static KSL_INLINED void ksl_product_drvtx_fused_many(ptrdiff_t n, const ksl_mat3x3_t *R,
    ptrdiff_t R_stride, const double *k, ptrdiff_t k_stride, ksl_vec3_t *vo,
    ptrdiff_t vo_stride) {
  KSL_EACH_OF(n) {
    ksl_product_drvtx_fused(R + i * R_stride, k[i * k_stride], vo + i * vo_stride);
  }
}

static KSL_INLINED void ksl_product_drvtx_fused_planes(ptrdiff_t n, const double *R,
    ptrdiff_t R_plane, ptrdiff_t R_stride, const double *k, ptrdiff_t k_stride,
    double *vo, ptrdiff_t vo_plane, ptrdiff_t vo_stride) {
  ksl_mat3x3_t R_i;
  if (n > 0) R_i = ksl_mat3x3_of_planes(R, R_plane);
  KSL_EACH_OF(n) {
    if (R_stride) R_i = ksl_mat3x3_of_planes(R + i * R_stride, R_plane);
    ksl_vec3_t vo_i;
    ksl_product_drvtx_fused(&R_i, k[i * k_stride], &vo_i);
    ksl_vec3_to_planes(&vo_i, vo + i * vo_stride, vo_plane);
  }
}

/* ksl_product_drdrx_fused of n elements. */
static KSL_INLINED void ksl_product_drdrx_fused_many(ptrdiff_t n, const ksl_mat3x3_t *R,
    ptrdiff_t R_stride, const double *dc, ptrdiff_t dc_stride, ksl_mat3x3_t *Ro,
    ptrdiff_t Ro_stride) {
  KSL_EACH_OF(n) {
    ksl_product_drdrx_fused(R + i * R_stride, dc + 2 * i * dc_stride, Ro + i * Ro_stride);
  }
}

static KSL_INLINED void ksl_product_drdrx_fused_planes(ptrdiff_t n, const double *R,
    ptrdiff_t R_plane, ptrdiff_t R_stride, const double *dc, ptrdiff_t dc_plane,
    ptrdiff_t dc_stride, double *Ro, ptrdiff_t Ro_plane, ptrdiff_t Ro_stride) {
  ksl_mat3x3_t R_i;
  if (n > 0) R_i = ksl_mat3x3_of_planes(R, R_plane);
  KSL_EACH_OF(n) {
    if (R_stride) R_i = ksl_mat3x3_of_planes(R + i * R_stride, R_plane);
    const double dc_i[2] = {dc[0 + i * dc_stride], dc[dc_plane + i * dc_stride]};
    ksl_mat3x3_t Ro_i;
    ksl_product_drdrx_fused(&R_i, dc_i, &Ro_i);
    ksl_mat3x3_to_planes(&Ro_i, Ro + i * Ro_stride, Ro_plane);
  }
}

/* ksl_product_ddrx_fused of n elements. */
static KSL_INLINED void ksl_product_ddrx_fused_many(ptrdiff_t n, const ksl_SE3_t *D,
    ptrdiff_t D_stride, const double *dc, ptrdiff_t dc_stride, ksl_SE3_t *Do,
    ptrdiff_t Do_stride) {
  KSL_EACH_OF(n) {
    ksl_product_ddrx_fused(D + i * D_stride, dc + 2 * i * dc_stride, Do + i * Do_stride);
  }
}

static KSL_INLINED void ksl_product_ddrx_fused_planes(ptrdiff_t n, const double *D,
    ptrdiff_t D_plane, ptrdiff_t D_stride, const double *dc, ptrdiff_t dc_plane,
    ptrdiff_t dc_stride, double *Do, ptrdiff_t Do_plane, ptrdiff_t Do_stride) {
  ksl_SE3_t D_i;
  if (n > 0) D_i = ksl_SE3_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3_of_planes(D + i * D_stride, D_plane);
    const double dc_i[2] = {dc[0 + i * dc_stride], dc[dc_plane + i * dc_stride]};
    ksl_SE3_t Do_i;
    ksl_product_ddrx_fused(&D_i, dc_i, &Do_i);
    ksl_SE3_to_planes(&Do_i, Do + i * Do_stride, Do_plane);
  }
}

/* ksl_product_ddtx_fused of n elements. */
static KSL_INLINED void ksl_product_ddtx_fused_many(ptrdiff_t n, const ksl_SE3_t *D,
    ptrdiff_t D_stride, const double *k, ptrdiff_t k_stride, ksl_SE3_t *Do,
    ptrdiff_t Do_stride) {
  KSL_EACH_OF(n) {
    ksl_product_ddtx_fused(D + i * D_stride, k[i * k_stride], Do + i * Do_stride);
  }
}

static KSL_INLINED void ksl_product_ddtx_fused_planes(ptrdiff_t n, const double *D,
    ptrdiff_t D_plane, ptrdiff_t D_stride, const double *k, ptrdiff_t k_stride,
    double *Do, ptrdiff_t Do_plane, ptrdiff_t Do_stride) {
  ksl_SE3_t D_i;
  if (n > 0) D_i = ksl_SE3_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3_of_planes(D + i * D_stride, D_plane);
    ksl_SE3_t Do_i;
    ksl_product_ddtx_fused(&D_i, k[i * k_stride], &Do_i);
    ksl_SE3_to_planes(&Do_i, Do + i * Do_stride, Do_plane);
  }
}

/* ksl_product_drvtxinv_fused of n elements. */
static KSL_INLINED void ksl_product_drvtxinv_fused_many(ptrdiff_t n, const ksl_mat3x3_t *R,
    ptrdiff_t R_stride, const double *k, ptrdiff_t k_stride, ksl_vec3_t *vo,
    ptrdiff_t vo_stride) {
  KSL_EACH_OF(n) {
    ksl_product_drvtxinv_fused(R + i * R_stride, k[i * k_stride], vo + i * vo_stride);
  }
}

static KSL_INLINED void ksl_product_drvtxinv_fused_planes(ptrdiff_t n, const double *R,
    ptrdiff_t R_plane, ptrdiff_t R_stride, const double *k, ptrdiff_t k_stride,
    double *vo, ptrdiff_t vo_plane, ptrdiff_t vo_stride) {
  ksl_mat3x3_t R_i;
  if (n > 0) R_i = ksl_mat3x3_of_planes(R, R_plane);
  KSL_EACH_OF(n) {
    if (R_stride) R_i = ksl_mat3x3_of_planes(R + i * R_stride, R_plane);
    ksl_vec3_t vo_i;
    ksl_product_drvtxinv_fused(&R_i, k[i * k_stride], &vo_i);
    ksl_vec3_to_planes(&vo_i, vo + i * vo_stride, vo_plane);
  }
}

/* ksl_product_drdrxinv_fused of n elements. */
static KSL_INLINED void ksl_product_drdrxinv_fused_many(ptrdiff_t n, const ksl_mat3x3_t *R,
    ptrdiff_t R_stride, const double *dc, ptrdiff_t dc_stride, ksl_mat3x3_t *Ro,
    ptrdiff_t Ro_stride) {
  KSL_EACH_OF(n) {
    ksl_product_drdrxinv_fused(R + i * R_stride, dc + 2 * i * dc_stride, Ro + i * Ro_stride);
  }
}

static KSL_INLINED void ksl_product_drdrxinv_fused_planes(ptrdiff_t n, const double *R,
    ptrdiff_t R_plane, ptrdiff_t R_stride, const double *dc, ptrdiff_t dc_plane,
    ptrdiff_t dc_stride, double *Ro, ptrdiff_t Ro_plane, ptrdiff_t Ro_stride) {
  ksl_mat3x3_t R_i;
  if (n > 0) R_i = ksl_mat3x3_of_planes(R, R_plane);
  KSL_EACH_OF(n) {
    if (R_stride) R_i = ksl_mat3x3_of_planes(R + i * R_stride, R_plane);
    const double dc_i[2] = {dc[0 + i * dc_stride], dc[dc_plane + i * dc_stride]};
    ksl_mat3x3_t Ro_i;
    ksl_product_drdrxinv_fused(&R_i, dc_i, &Ro_i);
    ksl_mat3x3_to_planes(&Ro_i, Ro + i * Ro_stride, Ro_plane);
  }
}

/* ksl_product_ddrxinv_fused of n elements. */
static KSL_INLINED void ksl_product_ddrxinv_fused_many(ptrdiff_t n, const ksl_SE3_t *D,
    ptrdiff_t D_stride, const double *dc, ptrdiff_t dc_stride, ksl_SE3_t *Do,
    ptrdiff_t Do_stride) {
  KSL_EACH_OF(n) {
    ksl_product_ddrxinv_fused(D + i * D_stride, dc + 2 * i * dc_stride, Do + i * Do_stride);
  }
}

static KSL_INLINED void ksl_product_ddrxinv_fused_planes(ptrdiff_t n, const double *D,
    ptrdiff_t D_plane, ptrdiff_t D_stride, const double *dc, ptrdiff_t dc_plane,
    ptrdiff_t dc_stride, double *Do, ptrdiff_t Do_plane, ptrdiff_t Do_stride) {
  ksl_SE3_t D_i;
  if (n > 0) D_i = ksl_SE3_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3_of_planes(D + i * D_stride, D_plane);
    const double dc_i[2] = {dc[0 + i * dc_stride], dc[dc_plane + i * dc_stride]};
    ksl_SE3_t Do_i;
    ksl_product_ddrxinv_fused(&D_i, dc_i, &Do_i);
    ksl_SE3_to_planes(&Do_i, Do + i * Do_stride, Do_plane);
  }
}

/* ksl_product_ddtxinv_fused of n elements. */
static KSL_INLINED void ksl_product_ddtxinv_fused_many(ptrdiff_t n, const ksl_SE3_t *D,
    ptrdiff_t D_stride, const double *k, ptrdiff_t k_stride, ksl_SE3_t *Do,
    ptrdiff_t Do_stride) {
  KSL_EACH_OF(n) {
    ksl_product_ddtxinv_fused(D + i * D_stride, k[i * k_stride], Do + i * Do_stride);
  }
}

static KSL_INLINED void ksl_product_ddtxinv_fused_planes(ptrdiff_t n, const double *D,
    ptrdiff_t D_plane, ptrdiff_t D_stride, const double *k, ptrdiff_t k_stride,
    double *Do, ptrdiff_t Do_plane, ptrdiff_t Do_stride) {
  ksl_SE3_t D_i;
  if (n > 0) D_i = ksl_SE3_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3_of_planes(D + i * D_stride, D_plane);
    ksl_SE3_t Do_i;
    ksl_product_ddtxinv_fused(&D_i, k[i * k_stride], &Do_i);
    ksl_SE3_to_planes(&Do_i, Do + i * Do_stride, Do_plane);
  }
}

/* ksl_product_drvty_fused of n elements. */
static KSL_INLINED void ksl_product_drvty_fused_many(ptrdiff_t n, const ksl_mat3x3_t *R,
    ptrdiff_t R_stride, const double *k, ptrdiff_t k_stride, ksl_vec3_t *vo,
    ptrdiff_t vo_stride) {
  KSL_EACH_OF(n) {
    ksl_product_drvty_fused(R + i * R_stride, k[i * k_stride], vo + i * vo_stride);
  }
}

static KSL_INLINED void ksl_product_drvty_fused_planes(ptrdiff_t n, const double *R,
    ptrdiff_t R_plane, ptrdiff_t R_stride, const double *k, ptrdiff_t k_stride,
    double *vo, ptrdiff_t vo_plane, ptrdiff_t vo_stride) {
  ksl_mat3x3_t R_i;
  if (n > 0) R_i = ksl_mat3x3_of_planes(R, R_plane);
  KSL_EACH_OF(n) {
    if (R_stride) R_i = ksl_mat3x3_of_planes(R + i * R_stride, R_plane);
    ksl_vec3_t vo_i;
    ksl_product_drvty_fused(&R_i, k[i * k_stride], &vo_i);
    ksl_vec3_to_planes(&vo_i, vo + i * vo_stride, vo_plane);
  }
}

/* ksl_product_drdry_fused of n elements. */
static KSL_INLINED void ksl_product_drdry_fused_many(ptrdiff_t n, const ksl_mat3x3_t *R,
    ptrdiff_t R_stride, const double *dc, ptrdiff_t dc_stride, ksl_mat3x3_t *Ro,
    ptrdiff_t Ro_stride) {
  KSL_EACH_OF(n) {
    ksl_product_drdry_fused(R + i * R_stride, dc + 2 * i * dc_stride, Ro + i * Ro_stride);
  }
}

static KSL_INLINED void ksl_product_drdry_fused_planes(ptrdiff_t n, const double *R,
    ptrdiff_t R_plane, ptrdiff_t R_stride, const double *dc, ptrdiff_t dc_plane,
    ptrdiff_t dc_stride, double *Ro, ptrdiff_t Ro_plane, ptrdiff_t Ro_stride) {
  ksl_mat3x3_t R_i;
  if (n > 0) R_i = ksl_mat3x3_of_planes(R, R_plane);
  KSL_EACH_OF(n) {
    if (R_stride) R_i = ksl_mat3x3_of_planes(R + i * R_stride, R_plane);
    const double dc_i[2] = {dc[0 + i * dc_stride], dc[dc_plane + i * dc_stride]};
    ksl_mat3x3_t Ro_i;
    ksl_product_drdry_fused(&R_i, dc_i, &Ro_i);
    ksl_mat3x3_to_planes(&Ro_i, Ro + i * Ro_stride, Ro_plane);
  }
}

/* ksl_product_ddry_fused of n elements. */
static KSL_INLINED void ksl_product_ddry_fused_many(ptrdiff_t n, const ksl_SE3_t *D,
    ptrdiff_t D_stride, const double *dc, ptrdiff_t dc_stride, ksl_SE3_t *Do,
    ptrdiff_t Do_stride) {
  KSL_EACH_OF(n) {
    ksl_product_ddry_fused(D + i * D_stride, dc + 2 * i * dc_stride, Do + i * Do_stride);
  }
}

static KSL_INLINED void ksl_product_ddry_fused_planes(ptrdiff_t n, const double *D,
    ptrdiff_t D_plane, ptrdiff_t D_stride, const double *dc, ptrdiff_t dc_plane,
    ptrdiff_t dc_stride, double *Do, ptrdiff_t Do_plane, ptrdiff_t Do_stride) {
  ksl_SE3_t D_i;
  if (n > 0) D_i = ksl_SE3_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3_of_planes(D + i * D_stride, D_plane);
    const double dc_i[2] = {dc[0 + i * dc_stride], dc[dc_plane + i * dc_stride]};
    ksl_SE3_t Do_i;
    ksl_product_ddry_fused(&D_i, dc_i, &Do_i);
    ksl_SE3_to_planes(&Do_i, Do + i * Do_stride, Do_plane);
  }
}

/* ksl_product_ddty_fused of n elements. */
static KSL_INLINED void ksl_product_ddty_fused_many(ptrdiff_t n, const ksl_SE3_t *D,
    ptrdiff_t D_stride, const double *k, ptrdiff_t k_stride, ksl_SE3_t *Do,
    ptrdiff_t Do_stride) {
  KSL_EACH_OF(n) {
    ksl_product_ddty_fused(D + i * D_stride, k[i * k_stride], Do + i * Do_stride);
  }
}

static KSL_INLINED void ksl_product_ddty_fused_planes(ptrdiff_t n, const double *D,
    ptrdiff_t D_plane, ptrdiff_t D_stride, const double *k, ptrdiff_t k_stride,
    double *Do, ptrdiff_t Do_plane, ptrdiff_t Do_stride) {
  ksl_SE3_t D_i;
  if (n > 0) D_i = ksl_SE3_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3_of_planes(D + i * D_stride, D_plane);
    ksl_SE3_t Do_i;
    ksl_product_ddty_fused(&D_i, k[i * k_stride], &Do_i);
    ksl_SE3_to_planes(&Do_i, Do + i * Do_stride, Do_plane);
  }
}

/* ksl_product_drvtyinv_fused of n elements. */
static KSL_INLINED void ksl_product_drvtyinv_fused_many(ptrdiff_t n, const ksl_mat3x3_t *R,
    ptrdiff_t R_stride, const double *k, ptrdiff_t k_stride, ksl_vec3_t *vo,
    ptrdiff_t vo_stride) {
  KSL_EACH_OF(n) {
    ksl_product_drvtyinv_fused(R + i * R_stride, k[i * k_stride], vo + i * vo_stride);
  }
}

static KSL_INLINED void ksl_product_drvtyinv_fused_planes(ptrdiff_t n, const double *R,
    ptrdiff_t R_plane, ptrdiff_t R_stride, const double *k, ptrdiff_t k_stride,
    double *vo, ptrdiff_t vo_plane, ptrdiff_t vo_stride) {
  ksl_mat3x3_t R_i;
  if (n > 0) R_i = ksl_mat3x3_of_planes(R, R_plane);
  KSL_EACH_OF(n) {
    if (R_stride) R_i = ksl_mat3x3_of_planes(R + i * R_stride, R_plane);
    ksl_vec3_t vo_i;
    ksl_product_drvtyinv_fused(&R_i, k[i * k_stride], &vo_i);
    ksl_vec3_to_planes(&vo_i, vo + i * vo_stride, vo_plane);
  }
}

/* ksl_product_drdryinv_fused of n elements. */
static KSL_INLINED void ksl_product_drdryinv_fused_many(ptrdiff_t n, const ksl_mat3x3_t *R,
    ptrdiff_t R_stride, const double *dc, ptrdiff_t dc_stride, ksl_mat3x3_t *Ro,
    ptrdiff_t Ro_stride) {
  KSL_EACH_OF(n) {
    ksl_product_drdryinv_fused(R + i * R_stride, dc + 2 * i * dc_stride, Ro + i * Ro_stride);
  }
}

static KSL_INLINED void ksl_product_drdryinv_fused_planes(ptrdiff_t n, const double *R,
    ptrdiff_t R_plane, ptrdiff_t R_stride, const double *dc, ptrdiff_t dc_plane,
    ptrdiff_t dc_stride, double *Ro, ptrdiff_t Ro_plane, ptrdiff_t Ro_stride) {
  ksl_mat3x3_t R_i;
  if (n > 0) R_i = ksl_mat3x3_of_planes(R, R_plane);
  KSL_EACH_OF(n) {
    if (R_stride) R_i = ksl_mat3x3_of_planes(R + i * R_stride, R_plane);
    const double dc_i[2] = {dc[0 + i * dc_stride], dc[dc_plane + i * dc_stride]};
    ksl_mat3x3_t Ro_i;
    ksl_product_drdryinv_fused(&R_i, dc_i, &Ro_i);
    ksl_mat3x3_to_planes(&Ro_i, Ro + i * Ro_stride, Ro_plane);
  }
}

/* ksl_product_ddryinv_fused of n elements. */
static KSL_INLINED void ksl_product_ddryinv_fused_many(ptrdiff_t n, const ksl_SE3_t *D,
    ptrdiff_t D_stride, const double *dc, ptrdiff_t dc_stride, ksl_SE3_t *Do,
    ptrdiff_t Do_stride) {
  KSL_EACH_OF(n) {
    ksl_product_ddryinv_fused(D + i * D_stride, dc + 2 * i * dc_stride, Do + i * Do_stride);
  }
}

static KSL_INLINED void ksl_product_ddryinv_fused_planes(ptrdiff_t n, const double *D,
    ptrdiff_t D_plane, ptrdiff_t D_stride, const double *dc, ptrdiff_t dc_plane,
    ptrdiff_t dc_stride, double *Do, ptrdiff_t Do_plane, ptrdiff_t Do_stride) {
  ksl_SE3_t D_i;
  if (n > 0) D_i = ksl_SE3_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3_of_planes(D + i * D_stride, D_plane);
    const double dc_i[2] = {dc[0 + i * dc_stride], dc[dc_plane + i * dc_stride]};
    ksl_SE3_t Do_i;
    ksl_product_ddryinv_fused(&D_i, dc_i, &Do_i);
    ksl_SE3_to_planes(&Do_i, Do + i * Do_stride, Do_plane);
  }
}

/* ksl_product_ddtyinv_fused of n elements. */
static KSL_INLINED void ksl_product_ddtyinv_fused_many(ptrdiff_t n, const ksl_SE3_t *D,
    ptrdiff_t D_stride, const double *k, ptrdiff_t k_stride, ksl_SE3_t *Do,
    ptrdiff_t Do_stride) {
  KSL_EACH_OF(n) {
    ksl_product_ddtyinv_fused(D + i * D_stride, k[i * k_stride], Do + i * Do_stride);
  }
}

static KSL_INLINED void ksl_product_ddtyinv_fused_planes(ptrdiff_t n, const double *D,
    ptrdiff_t D_plane, ptrdiff_t D_stride, const double *k, ptrdiff_t k_stride,
    double *Do, ptrdiff_t Do_plane, ptrdiff_t Do_stride) {
  ksl_SE3_t D_i;
  if (n > 0) D_i = ksl_SE3_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3_of_planes(D + i * D_stride, D_plane);
    ksl_SE3_t Do_i;
    ksl_product_ddtyinv_fused(&D_i, k[i * k_stride], &Do_i);
    ksl_SE3_to_planes(&Do_i, Do + i * Do_stride, Do_plane);
  }
}

/* ksl_product_drvtz_fused of n elements. */
static KSL_INLINED void ksl_product_drvtz_fused_many(ptrdiff_t n, const ksl_mat3x3_t *R,
    ptrdiff_t R_stride, const double *k, ptrdiff_t k_stride, ksl_vec3_t *vo,
    ptrdiff_t vo_stride) {
  KSL_EACH_OF(n) {
    ksl_product_drvtz_fused(R + i * R_stride, k[i * k_stride], vo + i * vo_stride);
  }
}

static KSL_INLINED void ksl_product_drvtz_fused_planes(ptrdiff_t n, const double *R,
    ptrdiff_t R_plane, ptrdiff_t R_stride, const double *k, ptrdiff_t k_stride,
    double *vo, ptrdiff_t vo_plane, ptrdiff_t vo_stride) {
  ksl_mat3x3_t R_i;
  if (n > 0) R_i = ksl_mat3x3_of_planes(R, R_plane);
  KSL_EACH_OF(n) {
    if (R_stride) R_i = ksl_mat3x3_of_planes(R + i * R_stride, R_plane);
    ksl_vec3_t vo_i;
    ksl_product_drvtz_fused(&R_i, k[i * k_stride], &vo_i);
    ksl_vec3_to_planes(&vo_i, vo + i * vo_stride, vo_plane);
  }
}

/* ksl_product_drdrz_fused of n elements. */
static KSL_INLINED void ksl_product_drdrz_fused_many(ptrdiff_t n, const ksl_mat3x3_t *R,
    ptrdiff_t R_stride, const double *dc, ptrdiff_t dc_stride, ksl_mat3x3_t *Ro,
    ptrdiff_t Ro_stride) {
  KSL_EACH_OF(n) {
    ksl_product_drdrz_fused(R + i * R_stride, dc + 2 * i * dc_stride, Ro + i * Ro_stride);
  }
}

static KSL_INLINED void ksl_product_drdrz_fused_planes(ptrdiff_t n, const double *R,
    ptrdiff_t R_plane, ptrdiff_t R_stride, const double *dc, ptrdiff_t dc_plane,
    ptrdiff_t dc_stride, double *Ro, ptrdiff_t Ro_plane, ptrdiff_t Ro_stride) {
  ksl_mat3x3_t R_i;
  if (n > 0) R_i = ksl_mat3x3_of_planes(R, R_plane);
  KSL_EACH_OF(n) {
    if (R_stride) R_i = ksl_mat3x3_of_planes(R + i * R_stride, R_plane);
    const double dc_i[2] = {dc[0 + i * dc_stride], dc[dc_plane + i * dc_stride]};
    ksl_mat3x3_t Ro_i;
    ksl_product_drdrz_fused(&R_i, dc_i, &Ro_i);
    ksl_mat3x3_to_planes(&Ro_i, Ro + i * Ro_stride, Ro_plane);
  }
}

/* ksl_product_ddrz_fused of n elements. */
static KSL_INLINED void ksl_product_ddrz_fused_many(ptrdiff_t n, const ksl_SE3_t *D,
    ptrdiff_t D_stride, const double *dc, ptrdiff_t dc_stride, ksl_SE3_t *Do,
    ptrdiff_t Do_stride) {
  KSL_EACH_OF(n) {
    ksl_product_ddrz_fused(D + i * D_stride, dc + 2 * i * dc_stride, Do + i * Do_stride);
  }
}

static KSL_INLINED void ksl_product_ddrz_fused_planes(ptrdiff_t n, const double *D,
    ptrdiff_t D_plane, ptrdiff_t D_stride, const double *dc, ptrdiff_t dc_plane,
    ptrdiff_t dc_stride, double *Do, ptrdiff_t Do_plane, ptrdiff_t Do_stride) {
  ksl_SE3_t D_i;
  if (n > 0) D_i = ksl_SE3_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3_of_planes(D + i * D_stride, D_plane);
    const double dc_i[2] = {dc[0 + i * dc_stride], dc[dc_plane + i * dc_stride]};
    ksl_SE3_t Do_i;
    ksl_product_ddrz_fused(&D_i, dc_i, &Do_i);
    ksl_SE3_to_planes(&Do_i, Do + i * Do_stride, Do_plane);
  }
}

/* ksl_product_ddtz_fused of n elements. */
static KSL_INLINED void ksl_product_ddtz_fused_many(ptrdiff_t n, const ksl_SE3_t *D,
    ptrdiff_t D_stride, const double *k, ptrdiff_t k_stride, ksl_SE3_t *Do,
    ptrdiff_t Do_stride) {
  KSL_EACH_OF(n) {
    ksl_product_ddtz_fused(D + i * D_stride, k[i * k_stride], Do + i * Do_stride);
  }
}

static KSL_INLINED void ksl_product_ddtz_fused_planes(ptrdiff_t n, const double *D,
    ptrdiff_t D_plane, ptrdiff_t D_stride, const double *k, ptrdiff_t k_stride,
    double *Do, ptrdiff_t Do_plane, ptrdiff_t Do_stride) {
  ksl_SE3_t D_i;
  if (n > 0) D_i = ksl_SE3_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3_of_planes(D + i * D_stride, D_plane);
    ksl_SE3_t Do_i;
    ksl_product_ddtz_fused(&D_i, k[i * k_stride], &Do_i);
    ksl_SE3_to_planes(&Do_i, Do + i * Do_stride, Do_plane);
  }
}

/* ksl_product_drvtzinv_fused of n elements. */
static KSL_INLINED void ksl_product_drvtzinv_fused_many(ptrdiff_t n, const ksl_mat3x3_t *R,
    ptrdiff_t R_stride, const double *k, ptrdiff_t k_stride, ksl_vec3_t *vo,
    ptrdiff_t vo_stride) {
  KSL_EACH_OF(n) {
    ksl_product_drvtzinv_fused(R + i * R_stride, k[i * k_stride], vo + i * vo_stride);
  }
}

static KSL_INLINED void ksl_product_drvtzinv_fused_planes(ptrdiff_t n, const double *R,
    ptrdiff_t R_plane, ptrdiff_t R_stride, const double *k, ptrdiff_t k_stride,
    double *vo, ptrdiff_t vo_plane, ptrdiff_t vo_stride) {
  ksl_mat3x3_t R_i;
  if (n > 0) R_i = ksl_mat3x3_of_planes(R, R_plane);
  KSL_EACH_OF(n) {
    if (R_stride) R_i = ksl_mat3x3_of_planes(R + i * R_stride, R_plane);
    ksl_vec3_t vo_i;
    ksl_product_drvtzinv_fused(&R_i, k[i * k_stride], &vo_i);
    ksl_vec3_to_planes(&vo_i, vo + i * vo_stride, vo_plane);
  }
}

/* ksl_product_drdrzinv_fused of n elements. */
static KSL_INLINED void ksl_product_drdrzinv_fused_many(ptrdiff_t n, const ksl_mat3x3_t *R,
    ptrdiff_t R_stride, const double *dc, ptrdiff_t dc_stride, ksl_mat3x3_t *Ro,
    ptrdiff_t Ro_stride) {
  KSL_EACH_OF(n) {
    ksl_product_drdrzinv_fused(R + i * R_stride, dc + 2 * i * dc_stride, Ro + i * Ro_stride);
  }
}

static KSL_INLINED void ksl_product_drdrzinv_fused_planes(ptrdiff_t n, const double *R,
    ptrdiff_t R_plane, ptrdiff_t R_stride, const double *dc, ptrdiff_t dc_plane,
    ptrdiff_t dc_stride, double *Ro, ptrdiff_t Ro_plane, ptrdiff_t Ro_stride) {
  ksl_mat3x3_t R_i;
  if (n > 0) R_i = ksl_mat3x3_of_planes(R, R_plane);
  KSL_EACH_OF(n) {
    if (R_stride) R_i = ksl_mat3x3_of_planes(R + i * R_stride, R_plane);
    const double dc_i[2] = {dc[0 + i * dc_stride], dc[dc_plane + i * dc_stride]};
    ksl_mat3x3_t Ro_i;
    ksl_product_drdrzinv_fused(&R_i, dc_i, &Ro_i);
    ksl_mat3x3_to_planes(&Ro_i, Ro + i * Ro_stride, Ro_plane);
  }
}

/* ksl_product_ddrzinv_fused of n elements. */
static KSL_INLINED void ksl_product_ddrzinv_fused_many(ptrdiff_t n, const ksl_SE3_t *D,
    ptrdiff_t D_stride, const double *dc, ptrdiff_t dc_stride, ksl_SE3_t *Do,
    ptrdiff_t Do_stride) {
  KSL_EACH_OF(n) {
    ksl_product_ddrzinv_fused(D + i * D_stride, dc + 2 * i * dc_stride, Do + i * Do_stride);
  }
}

static KSL_INLINED void ksl_product_ddrzinv_fused_planes(ptrdiff_t n, const double *D,
    ptrdiff_t D_plane, ptrdiff_t D_stride, const double *dc, ptrdiff_t dc_plane,
    ptrdiff_t dc_stride, double *Do, ptrdiff_t Do_plane, ptrdiff_t Do_stride) {
  ksl_SE3_t D_i;
  if (n > 0) D_i = ksl_SE3_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3_of_planes(D + i * D_stride, D_plane);
    const double dc_i[2] = {dc[0 + i * dc_stride], dc[dc_plane + i * dc_stride]};
    ksl_SE3_t Do_i;
    ksl_product_ddrzinv_fused(&D_i, dc_i, &Do_i);
    ksl_SE3_to_planes(&Do_i, Do + i * Do_stride, Do_plane);
  }
}

/* ksl_product_ddtzinv_fused of n elements. */
static KSL_INLINED void ksl_product_ddtzinv_fused_many(ptrdiff_t n, const ksl_SE3_t *D,
    ptrdiff_t D_stride, const double *k, ptrdiff_t k_stride, ksl_SE3_t *Do,
    ptrdiff_t Do_stride) {
  KSL_EACH_OF(n) {
    ksl_product_ddtzinv_fused(D + i * D_stride, k[i * k_stride], Do + i * Do_stride);
  }
}

static KSL_INLINED void ksl_product_ddtzinv_fused_planes(ptrdiff_t n, const double *D,
    ptrdiff_t D_plane, ptrdiff_t D_stride, const double *k, ptrdiff_t k_stride,
    double *Do, ptrdiff_t Do_plane, ptrdiff_t Do_stride) {
  ksl_SE3_t D_i;
  if (n > 0) D_i = ksl_SE3_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3_of_planes(D + i * D_stride, D_plane);
    ksl_SE3_t Do_i;
    ksl_product_ddtzinv_fused(&D_i, k[i * k_stride], &Do_i);
    ksl_SE3_to_planes(&Do_i, Do + i * Do_stride, Do_plane);
  }
}

/* ksl_product_drvf_fused of n elements. */
static KSL_INLINED void ksl_product_drvf_fused_many(ptrdiff_t n, const ksl_mat3x3f_t *R,
    ptrdiff_t R_stride, const ksl_vec3f_t *v, ptrdiff_t v_stride,
    ksl_vec3f_t *vo, ptrdiff_t vo_stride) {
  KSL_EACH_OF(n) {
    ksl_product_drvf_fused(R + i * R_stride, v + i * v_stride, vo + i * vo_stride);
  }
}

static KSL_INLINED void ksl_product_drvf_fused_planes(ptrdiff_t n, const float *R,
    ptrdiff_t R_plane, ptrdiff_t R_stride, const float *v, ptrdiff_t v_plane,
    ptrdiff_t v_stride, float *vo, ptrdiff_t vo_plane, ptrdiff_t vo_stride) {
  ksl_mat3x3f_t R_i;
  if (n > 0) R_i = ksl_mat3x3f_of_planes(R, R_plane);
  KSL_EACH_OF(n) {
    if (R_stride) R_i = ksl_mat3x3f_of_planes(R + i * R_stride, R_plane);
    const ksl_vec3f_t v_i = ksl_vec3f_of_planes(v + i * v_stride, v_plane);
    ksl_vec3f_t vo_i;
    ksl_product_drvf_fused(&R_i, &v_i, &vo_i);
    ksl_vec3f_to_planes(&vo_i, vo + i * vo_stride, vo_plane);
  }
}

/* ksl_product_drvinvf_fused of n elements. */
static KSL_INLINED void ksl_product_drvinvf_fused_many(ptrdiff_t n, const ksl_mat3x3f_t *R,
    ptrdiff_t R_stride, const ksl_vec3f_t *v, ptrdiff_t v_stride,
    ksl_vec3f_t *vo, ptrdiff_t vo_stride) {
  KSL_EACH_OF(n) {
    ksl_product_drvinvf_fused(R + i * R_stride, v + i * v_stride, vo + i * vo_stride);
  }
}

static KSL_INLINED void ksl_product_drvinvf_fused_planes(ptrdiff_t n, const float *R,
    ptrdiff_t R_plane, ptrdiff_t R_stride, const float *v, ptrdiff_t v_plane,
    ptrdiff_t v_stride, float *vo, ptrdiff_t vo_plane, ptrdiff_t vo_stride) {
  ksl_mat3x3f_t R_i;
  if (n > 0) R_i = ksl_mat3x3f_of_planes(R, R_plane);
  KSL_EACH_OF(n) {
    if (R_stride) R_i = ksl_mat3x3f_of_planes(R + i * R_stride, R_plane);
    const ksl_vec3f_t v_i = ksl_vec3f_of_planes(v + i * v_stride, v_plane);
    ksl_vec3f_t vo_i;
    ksl_product_drvinvf_fused(&R_i, &v_i, &vo_i);
    ksl_vec3f_to_planes(&vo_i, vo + i * vo_stride, vo_plane);
  }
}

/* ksl_product_drinvvf_fused of n elements. */
static KSL_INLINED void ksl_product_drinvvf_fused_many(ptrdiff_t n, const ksl_mat3x3f_t *R,
    ptrdiff_t R_stride, const ksl_vec3f_t *v, ptrdiff_t v_stride,
    ksl_vec3f_t *vo, ptrdiff_t vo_stride) {
  KSL_EACH_OF(n) {
    ksl_product_drinvvf_fused(R + i * R_stride, v + i * v_stride, vo + i * vo_stride);
  }
}

static KSL_INLINED void ksl_product_drinvvf_fused_planes(ptrdiff_t n, const float *R,
    ptrdiff_t R_plane, ptrdiff_t R_stride, const float *v, ptrdiff_t v_plane,
    ptrdiff_t v_stride, float *vo, ptrdiff_t vo_plane, ptrdiff_t vo_stride) {
  ksl_mat3x3f_t R_i;
  if (n > 0) R_i = ksl_mat3x3f_of_planes(R, R_plane);
  KSL_EACH_OF(n) {
    if (R_stride) R_i = ksl_mat3x3f_of_planes(R + i * R_stride, R_plane);
    const ksl_vec3f_t v_i = ksl_vec3f_of_planes(v + i * v_stride, v_plane);
    ksl_vec3f_t vo_i;
    ksl_product_drinvvf_fused(&R_i, &v_i, &vo_i);
    ksl_vec3f_to_planes(&vo_i, vo + i * vo_stride, vo_plane);
  }
}

/* ksl_product_drinvvinvf_fused of n elements. */
static KSL_INLINED void ksl_product_drinvvinvf_fused_many(ptrdiff_t n, const ksl_mat3x3f_t *R,
    ptrdiff_t R_stride, const ksl_vec3f_t *v, ptrdiff_t v_stride,
    ksl_vec3f_t *vo, ptrdiff_t vo_stride) {
  KSL_EACH_OF(n) {
    ksl_product_drinvvinvf_fused(R + i * R_stride, v + i * v_stride, vo + i * vo_stride);
  }
}

static KSL_INLINED void ksl_product_drinvvinvf_fused_planes(ptrdiff_t n, const float *R,
    ptrdiff_t R_plane, ptrdiff_t R_stride, const float *v, ptrdiff_t v_plane,
    ptrdiff_t v_stride, float *vo, ptrdiff_t vo_plane, ptrdiff_t vo_stride) {
  ksl_mat3x3f_t R_i;
  if (n > 0) R_i = ksl_mat3x3f_of_planes(R, R_plane);
  KSL_EACH_OF(n) {
    if (R_stride) R_i = ksl_mat3x3f_of_planes(R + i * R_stride, R_plane);
    const ksl_vec3f_t v_i = ksl_vec3f_of_planes(v + i * v_stride, v_plane);
    ksl_vec3f_t vo_i;
    ksl_product_drinvvinvf_fused(&R_i, &v_i, &vo_i);
    ksl_vec3f_to_planes(&vo_i, vo + i * vo_stride, vo_plane);
  }
}

/* ksl_product_dvf_fused of n elements. */
static KSL_INLINED void ksl_product_dvf_fused_many(ptrdiff_t n, const ksl_SE3f_t *D,
    ptrdiff_t D_stride, const ksl_vec3f_t *v, ptrdiff_t v_stride,
    ksl_vec3f_t *vo, ptrdiff_t vo_stride) {
  KSL_EACH_OF(n) {
    ksl_product_dvf_fused(D + i * D_stride, v + i * v_stride, vo + i * vo_stride);
  }
}

static KSL_INLINED void ksl_product_dvf_fused_planes(ptrdiff_t n, const float *D, ptrdiff_t D_plane,
    ptrdiff_t D_stride, const float *v, ptrdiff_t v_plane, ptrdiff_t v_stride,
    float *vo, ptrdiff_t vo_plane, ptrdiff_t vo_stride) {
  ksl_SE3f_t D_i;
  if (n > 0) D_i = ksl_SE3f_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3f_of_planes(D + i * D_stride, D_plane);
    const ksl_vec3f_t v_i = ksl_vec3f_of_planes(v + i * v_stride, v_plane);
    ksl_vec3f_t vo_i;
    ksl_product_dvf_fused(&D_i, &v_i, &vo_i);
    ksl_vec3f_to_planes(&vo_i, vo + i * vo_stride, vo_plane);
  }
}

/* ksl_product_dinvvf_fused of n elements. */
static KSL_INLINED void ksl_product_dinvvf_fused_many(ptrdiff_t n, const ksl_SE3f_t *D,
    ptrdiff_t D_stride, const ksl_vec3f_t *v, ptrdiff_t v_stride,
    ksl_vec3f_t *vo, ptrdiff_t vo_stride) {
  KSL_EACH_OF(n) {
    ksl_product_dinvvf_fused(D + i * D_stride, v + i * v_stride, vo + i * vo_stride);
  }
}

static KSL_INLINED void ksl_product_dinvvf_fused_planes(ptrdiff_t n, const float *D,
    ptrdiff_t D_plane, ptrdiff_t D_stride, const float *v, ptrdiff_t v_plane,
    ptrdiff_t v_stride, float *vo, ptrdiff_t vo_plane, ptrdiff_t vo_stride) {
  ksl_SE3f_t D_i;
  if (n > 0) D_i = ksl_SE3f_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3f_of_planes(D + i * D_stride, D_plane);
    const ksl_vec3f_t v_i = ksl_vec3f_of_planes(v + i * v_stride, v_plane);
    ksl_vec3f_t vo_i;
    ksl_product_dinvvf_fused(&D_i, &v_i, &vo_i);
    ksl_vec3f_to_planes(&vo_i, vo + i * vo_stride, vo_plane);
  }
}

/* ksl_product_drdrf_fused of n elements. */
static KSL_INLINED void ksl_product_drdrf_fused_many(ptrdiff_t n, const ksl_mat3x3f_t *R1,
    ptrdiff_t R1_stride, const ksl_mat3x3f_t *R2, ptrdiff_t R2_stride,
    ksl_mat3x3f_t *Ro, ptrdiff_t Ro_stride) {
  KSL_EACH_OF(n) {
    ksl_product_drdrf_fused(R1 + i * R1_stride, R2 + i * R2_stride, Ro + i * Ro_stride);
  }
}

static KSL_INLINED void ksl_product_drdrf_fused_planes(ptrdiff_t n, const float *R1,
    ptrdiff_t R1_plane, ptrdiff_t R1_stride, const float *R2, ptrdiff_t R2_plane,
    ptrdiff_t R2_stride, float *Ro, ptrdiff_t Ro_plane, ptrdiff_t Ro_stride) {
  ksl_mat3x3f_t R1_i;
  if (n > 0) R1_i = ksl_mat3x3f_of_planes(R1, R1_plane);
  KSL_EACH_OF(n) {
    if (R1_stride) R1_i = ksl_mat3x3f_of_planes(R1 + i * R1_stride, R1_plane);
    const ksl_mat3x3f_t R2_i = ksl_mat3x3f_of_planes(R2 + i * R2_stride, R2_plane);
    ksl_mat3x3f_t Ro_i;
    ksl_product_drdrf_fused(&R1_i, &R2_i, &Ro_i);
    ksl_mat3x3f_to_planes(&Ro_i, Ro + i * Ro_stride, Ro_plane);
  }
}

/* ksl_product_drdrinvf_fused of n elements. */
static KSL_INLINED void ksl_product_drdrinvf_fused_many(ptrdiff_t n, const ksl_mat3x3f_t *R1,
    ptrdiff_t R1_stride, const ksl_mat3x3f_t *R2, ptrdiff_t R2_stride,
    ksl_mat3x3f_t *Ro, ptrdiff_t Ro_stride) {
  KSL_EACH_OF(n) {
    ksl_product_drdrinvf_fused(R1 + i * R1_stride, R2 + i * R2_stride, Ro + i * Ro_stride);
  }
}

static KSL_INLINED void ksl_product_drdrinvf_fused_planes(ptrdiff_t n, const float *R1,
    ptrdiff_t R1_plane, ptrdiff_t R1_stride, const float *R2, ptrdiff_t R2_plane,
    ptrdiff_t R2_stride, float *Ro, ptrdiff_t Ro_plane, ptrdiff_t Ro_stride) {
  ksl_mat3x3f_t R1_i;
  if (n > 0) R1_i = ksl_mat3x3f_of_planes(R1, R1_plane);
  KSL_EACH_OF(n) {
    if (R1_stride) R1_i = ksl_mat3x3f_of_planes(R1 + i * R1_stride, R1_plane);
    const ksl_mat3x3f_t R2_i = ksl_mat3x3f_of_planes(R2 + i * R2_stride, R2_plane);
    ksl_mat3x3f_t Ro_i;
    ksl_product_drdrinvf_fused(&R1_i, &R2_i, &Ro_i);
    ksl_mat3x3f_to_planes(&Ro_i, Ro + i * Ro_stride, Ro_plane);
  }
}

/* ksl_product_drinvdrf_fused of n elements. */
static KSL_INLINED void ksl_product_drinvdrf_fused_many(ptrdiff_t n, const ksl_mat3x3f_t *R1,
    ptrdiff_t R1_stride, const ksl_mat3x3f_t *R2, ptrdiff_t R2_stride,
    ksl_mat3x3f_t *Ro, ptrdiff_t Ro_stride) {
  KSL_EACH_OF(n) {
    ksl_product_drinvdrf_fused(R1 + i * R1_stride, R2 + i * R2_stride, Ro + i * Ro_stride);
  }
}

static KSL_INLINED void ksl_product_drinvdrf_fused_planes(ptrdiff_t n, const float *R1,
    ptrdiff_t R1_plane, ptrdiff_t R1_stride, const float *R2, ptrdiff_t R2_plane,
    ptrdiff_t R2_stride, float *Ro, ptrdiff_t Ro_plane, ptrdiff_t Ro_stride) {
  ksl_mat3x3f_t R1_i;
  if (n > 0) R1_i = ksl_mat3x3f_of_planes(R1, R1_plane);
  KSL_EACH_OF(n) {
    if (R1_stride) R1_i = ksl_mat3x3f_of_planes(R1 + i * R1_stride, R1_plane);
    const ksl_mat3x3f_t R2_i = ksl_mat3x3f_of_planes(R2 + i * R2_stride, R2_plane);
    ksl_mat3x3f_t Ro_i;
    ksl_product_drinvdrf_fused(&R1_i, &R2_i, &Ro_i);
    ksl_mat3x3f_to_planes(&Ro_i, Ro + i * Ro_stride, Ro_plane);
  }
}

/* ksl_product_ddf_fused of n elements. */
static KSL_INLINED void ksl_product_ddf_fused_many(ptrdiff_t n, const ksl_SE3f_t *D1,
    ptrdiff_t D1_stride, const ksl_SE3f_t *D2, ptrdiff_t D2_stride,
    ksl_SE3f_t *Do, ptrdiff_t Do_stride) {
  KSL_EACH_OF(n) {
    ksl_product_ddf_fused(D1 + i * D1_stride, D2 + i * D2_stride, Do + i * Do_stride);
  }
}

static KSL_INLINED void ksl_product_ddf_fused_planes(ptrdiff_t n, const float *D1,
    ptrdiff_t D1_plane, ptrdiff_t D1_stride, const float *D2, ptrdiff_t D2_plane,
    ptrdiff_t D2_stride, float *Do, ptrdiff_t Do_plane, ptrdiff_t Do_stride) {
  ksl_SE3f_t D1_i;
  if (n > 0) D1_i = ksl_SE3f_of_planes(D1, D1_plane);
  KSL_EACH_OF(n) {
    if (D1_stride) D1_i = ksl_SE3f_of_planes(D1 + i * D1_stride, D1_plane);
    const ksl_SE3f_t D2_i = ksl_SE3f_of_planes(D2 + i * D2_stride, D2_plane);
    ksl_SE3f_t Do_i;
    ksl_product_ddf_fused(&D1_i, &D2_i, &Do_i);
    ksl_SE3f_to_planes(&Do_i, Do + i * Do_stride, Do_plane);
  }
}

/* ksl_product_ddinvf_fused of n elements. */
static KSL_INLINED void ksl_product_ddinvf_fused_many(ptrdiff_t n, const ksl_SE3f_t *D1,
    ptrdiff_t D1_stride, const ksl_SE3f_t *D2, ptrdiff_t D2_stride,
    ksl_SE3f_t *Do, ptrdiff_t Do_stride) {
  KSL_EACH_OF(n) {
    ksl_product_ddinvf_fused(D1 + i * D1_stride, D2 + i * D2_stride, Do + i * Do_stride);
  }
}

static KSL_INLINED void ksl_product_ddinvf_fused_planes(ptrdiff_t n, const float *D1,
    ptrdiff_t D1_plane, ptrdiff_t D1_stride, const float *D2, ptrdiff_t D2_plane,
    ptrdiff_t D2_stride, float *Do, ptrdiff_t Do_plane, ptrdiff_t Do_stride) {
  ksl_SE3f_t D1_i;
  if (n > 0) D1_i = ksl_SE3f_of_planes(D1, D1_plane);
  KSL_EACH_OF(n) {
    if (D1_stride) D1_i = ksl_SE3f_of_planes(D1 + i * D1_stride, D1_plane);
    const ksl_SE3f_t D2_i = ksl_SE3f_of_planes(D2 + i * D2_stride, D2_plane);
    ksl_SE3f_t Do_i;
    ksl_product_ddinvf_fused(&D1_i, &D2_i, &Do_i);
    ksl_SE3f_to_planes(&Do_i, Do + i * Do_stride, Do_plane);
  }
}

/* ksl_product_dinvdf_fused of n elements. */
static KSL_INLINED void ksl_product_dinvdf_fused_many(ptrdiff_t n, const ksl_SE3f_t *D1,
    ptrdiff_t D1_stride, const ksl_SE3f_t *D2, ptrdiff_t D2_stride,
    ksl_SE3f_t *Do, ptrdiff_t Do_stride) {
  KSL_EACH_OF(n) {
    ksl_product_dinvdf_fused(D1 + i * D1_stride, D2 + i * D2_stride, Do + i * Do_stride);
  }
}

static KSL_INLINED void ksl_product_dinvdf_fused_planes(ptrdiff_t n, const float *D1,
    ptrdiff_t D1_plane, ptrdiff_t D1_stride, const float *D2, ptrdiff_t D2_plane,
    ptrdiff_t D2_stride, float *Do, ptrdiff_t Do_plane, ptrdiff_t Do_stride) {
  ksl_SE3f_t D1_i;
  if (n > 0) D1_i = ksl_SE3f_of_planes(D1, D1_plane);
  KSL_EACH_OF(n) {
    if (D1_stride) D1_i = ksl_SE3f_of_planes(D1 + i * D1_stride, D1_plane);
    const ksl_SE3f_t D2_i = ksl_SE3f_of_planes(D2 + i * D2_stride, D2_plane);
    ksl_SE3f_t Do_i;
    ksl_product_dinvdf_fused(&D1_i, &D2_i, &Do_i);
    ksl_SE3f_to_planes(&Do_i, Do + i * Do_stride, Do_plane);
  }
}

/* ksl_product_ddrf_fused of n elements. */
static KSL_INLINED void ksl_product_ddrf_fused_many(ptrdiff_t n, const ksl_SE3f_t *D,
    ptrdiff_t D_stride, const ksl_mat3x3f_t *R, ptrdiff_t R_stride,
    ksl_SE3f_t *Do, ptrdiff_t Do_stride) {
  KSL_EACH_OF(n) {
    ksl_product_ddrf_fused(D + i * D_stride, R + i * R_stride, Do + i * Do_stride);
  }
}

static KSL_INLINED void ksl_product_ddrf_fused_planes(ptrdiff_t n, const float *D,
    ptrdiff_t D_plane, ptrdiff_t D_stride, const float *R, ptrdiff_t R_plane,
    ptrdiff_t R_stride, float *Do, ptrdiff_t Do_plane, ptrdiff_t Do_stride) {
  ksl_SE3f_t D_i;
  if (n > 0) D_i = ksl_SE3f_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3f_of_planes(D + i * D_stride, D_plane);
    const ksl_mat3x3f_t R_i = ksl_mat3x3f_of_planes(R + i * R_stride, R_plane);
    ksl_SE3f_t Do_i;
    ksl_product_ddrf_fused(&D_i, &R_i, &Do_i);
    ksl_SE3f_to_planes(&Do_i, Do + i * Do_stride, Do_plane);
  }
}

/* ksl_product_ddrinvf_fused of n elements. */
static KSL_INLINED void ksl_product_ddrinvf_fused_many(ptrdiff_t n, const ksl_SE3f_t *D,
    ptrdiff_t D_stride, const ksl_mat3x3f_t *R, ptrdiff_t R_stride,
    ksl_SE3f_t *Do, ptrdiff_t Do_stride) {
  KSL_EACH_OF(n) {
    ksl_product_ddrinvf_fused(D + i * D_stride, R + i * R_stride, Do + i * Do_stride);
  }
}

static KSL_INLINED void ksl_product_ddrinvf_fused_planes(ptrdiff_t n, const float *D,
    ptrdiff_t D_plane, ptrdiff_t D_stride, const float *R, ptrdiff_t R_plane,
    ptrdiff_t R_stride, float *Do, ptrdiff_t Do_plane, ptrdiff_t Do_stride) {
  ksl_SE3f_t D_i;
  if (n > 0) D_i = ksl_SE3f_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3f_of_planes(D + i * D_stride, D_plane);
    const ksl_mat3x3f_t R_i = ksl_mat3x3f_of_planes(R + i * R_stride, R_plane);
    ksl_SE3f_t Do_i;
    ksl_product_ddrinvf_fused(&D_i, &R_i, &Do_i);
    ksl_SE3f_to_planes(&Do_i, Do + i * Do_stride, Do_plane);
  }
}

/* ksl_product_ddtf_fused of n elements. */
static KSL_INLINED void ksl_product_ddtf_fused_many(ptrdiff_t n, const ksl_SE3f_t *D,
    ptrdiff_t D_stride, const ksl_vec3f_t *t, ptrdiff_t t_stride, ksl_SE3f_t *Do,
    ptrdiff_t Do_stride) {
  KSL_EACH_OF(n) {
    ksl_product_ddtf_fused(D + i * D_stride, t + i * t_stride, Do + i * Do_stride);
  }
}

static KSL_INLINED void ksl_product_ddtf_fused_planes(ptrdiff_t n, const float *D,
    ptrdiff_t D_plane, ptrdiff_t D_stride, const float *t, ptrdiff_t t_plane,
    ptrdiff_t t_stride, float *Do, ptrdiff_t Do_plane, ptrdiff_t Do_stride) {
  ksl_SE3f_t D_i;
  if (n > 0) D_i = ksl_SE3f_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3f_of_planes(D + i * D_stride, D_plane);
    const ksl_vec3f_t t_i = ksl_vec3f_of_planes(t + i * t_stride, t_plane);
    ksl_SE3f_t Do_i;
    ksl_product_ddtf_fused(&D_i, &t_i, &Do_i);
    ksl_SE3f_to_planes(&Do_i, Do + i * Do_stride, Do_plane);
  }
}

/* ksl_product_ddtinvf_fused of n elements. */
static KSL_INLINED void ksl_product_ddtinvf_fused_many(ptrdiff_t n, const ksl_SE3f_t *D,
    ptrdiff_t D_stride, const ksl_vec3f_t *t, ptrdiff_t t_stride, ksl_SE3f_t *Do,
    ptrdiff_t Do_stride) {
  KSL_EACH_OF(n) {
    ksl_product_ddtinvf_fused(D + i * D_stride, t + i * t_stride, Do + i * Do_stride);
  }
}

static KSL_INLINED void ksl_product_ddtinvf_fused_planes(ptrdiff_t n, const float *D,
    ptrdiff_t D_plane, ptrdiff_t D_stride, const float *t, ptrdiff_t t_plane,
    ptrdiff_t t_stride, float *Do, ptrdiff_t Do_plane, ptrdiff_t Do_stride) {
  ksl_SE3f_t D_i;
  if (n > 0) D_i = ksl_SE3f_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3f_of_planes(D + i * D_stride, D_plane);
    const ksl_vec3f_t t_i = ksl_vec3f_of_planes(t + i * t_stride, t_plane);
    ksl_SE3f_t Do_i;
    ksl_product_ddtinvf_fused(&D_i, &t_i, &Do_i);
    ksl_SE3f_to_planes(&Do_i, Do + i * Do_stride, Do_plane);
  }
}

/* ksl_product_dinvdtf_fused of n elements. */
static KSL_INLINED void ksl_product_dinvdtf_fused_many(ptrdiff_t n, const ksl_SE3f_t *D,
    ptrdiff_t D_stride, const ksl_vec3f_t *t, ptrdiff_t t_stride, ksl_SE3f_t *Do,
    ptrdiff_t Do_stride) {
  KSL_EACH_OF(n) {
    ksl_product_dinvdtf_fused(D + i * D_stride, t + i * t_stride, Do + i * Do_stride);
  }
}

static KSL_INLINED void ksl_product_dinvdtf_fused_planes(ptrdiff_t n, const float *D,
    ptrdiff_t D_plane, ptrdiff_t D_stride, const float *t, ptrdiff_t t_plane,
    ptrdiff_t t_stride, float *Do, ptrdiff_t Do_plane, ptrdiff_t Do_stride) {
  ksl_SE3f_t D_i;
  if (n > 0) D_i = ksl_SE3f_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3f_of_planes(D + i * D_stride, D_plane);
    const ksl_vec3f_t t_i = ksl_vec3f_of_planes(t + i * t_stride, t_plane);
    ksl_SE3f_t Do_i;
    ksl_product_dinvdtf_fused(&D_i, &t_i, &Do_i);
    ksl_SE3f_to_planes(&Do_i, Do + i * Do_stride, Do_plane);
  }
}

/* ksl_product_drvtxf_fused of n elements. */
static KSL_INLINED void ksl_product_drvtxf_fused_many(ptrdiff_t n, const ksl_mat3x3f_t *R,
    ptrdiff_t R_stride, const float *k, ptrdiff_t k_stride, ksl_vec3f_t *vo,
    ptrdiff_t vo_stride) {
  KSL_EACH_OF(n) {
    ksl_product_drvtxf_fused(R + i * R_stride, k[i * k_stride], vo + i * vo_stride);
  }
}

static KSL_INLINED void ksl_product_drvtxf_fused_planes(ptrdiff_t n, const float *R,
    ptrdiff_t R_plane, ptrdiff_t R_stride, const float *k, ptrdiff_t k_stride,
    float *vo, ptrdiff_t vo_plane, ptrdiff_t vo_stride) {
  ksl_mat3x3f_t R_i;
  if (n > 0) R_i = ksl_mat3x3f_of_planes(R, R_plane);
  KSL_EACH_OF(n) {
    if (R_stride) R_i = ksl_mat3x3f_of_planes(R + i * R_stride, R_plane);
    ksl_vec3f_t vo_i;
    ksl_product_drvtxf_fused(&R_i, k[i * k_stride], &vo_i);
    ksl_vec3f_to_planes(&vo_i, vo + i * vo_stride, vo_plane);
  }
}

/* ksl_product_drdrxf_fused of n elements. */
static KSL_INLINED void ksl_product_drdrxf_fused_many(ptrdiff_t n, const ksl_mat3x3f_t *R,
    ptrdiff_t R_stride, const float *dc, ptrdiff_t dc_stride, ksl_mat3x3f_t *Ro,
    ptrdiff_t Ro_stride) {
  KSL_EACH_OF(n) {
    ksl_product_drdrxf_fused(R + i * R_stride, dc + 2 * i * dc_stride, Ro + i * Ro_stride);
  }
}

static KSL_INLINED void ksl_product_drdrxf_fused_planes(ptrdiff_t n, const float *R,
    ptrdiff_t R_plane, ptrdiff_t R_stride, const float *dc, ptrdiff_t dc_plane,
    ptrdiff_t dc_stride, float *Ro, ptrdiff_t Ro_plane, ptrdiff_t Ro_stride) {
  ksl_mat3x3f_t R_i;
  if (n > 0) R_i = ksl_mat3x3f_of_planes(R, R_plane);
  KSL_EACH_OF(n) {
    if (R_stride) R_i = ksl_mat3x3f_of_planes(R + i * R_stride, R_plane);
    const float dc_i[2] = {dc[0 + i * dc_stride], dc[dc_plane + i * dc_stride]};
    ksl_mat3x3f_t Ro_i;
    ksl_product_drdrxf_fused(&R_i, dc_i, &Ro_i);
    ksl_mat3x3f_to_planes(&Ro_i, Ro + i * Ro_stride, Ro_plane);
  }
}

/* ksl_product_ddrxf_fused of n elements. */
static KSL_INLINED void ksl_product_ddrxf_fused_many(ptrdiff_t n, const ksl_SE3f_t *D,
    ptrdiff_t D_stride, const float *dc, ptrdiff_t dc_stride, ksl_SE3f_t *Do,
    ptrdiff_t Do_stride) {
  KSL_EACH_OF(n) {
    ksl_product_ddrxf_fused(D + i * D_stride, dc + 2 * i * dc_stride, Do + i * Do_stride);
  }
}

static KSL_INLINED void ksl_product_ddrxf_fused_planes(ptrdiff_t n, const float *D,
    ptrdiff_t D_plane, ptrdiff_t D_stride, const float *dc, ptrdiff_t dc_plane,
    ptrdiff_t dc_stride, float *Do, ptrdiff_t Do_plane, ptrdiff_t Do_stride) {
  ksl_SE3f_t D_i;
  if (n > 0) D_i = ksl_SE3f_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3f_of_planes(D + i * D_stride, D_plane);
    const float dc_i[2] = {dc[0 + i * dc_stride], dc[dc_plane + i * dc_stride]};
    ksl_SE3f_t Do_i;
    ksl_product_ddrxf_fused(&D_i, dc_i, &Do_i);
    ksl_SE3f_to_planes(&Do_i, Do + i * Do_stride, Do_plane);
  }
}

/* ksl_product_ddtxf_fused of n elements. */
static KSL_INLINED void ksl_product_ddtxf_fused_many(ptrdiff_t n, const ksl_SE3f_t *D,
    ptrdiff_t D_stride, const float *k, ptrdiff_t k_stride, ksl_SE3f_t *Do,
    ptrdiff_t Do_stride) {
  KSL_EACH_OF(n) {
    ksl_product_ddtxf_fused(D + i * D_stride, k[i * k_stride], Do + i * Do_stride);
  }
}

static KSL_INLINED void ksl_product_ddtxf_fused_planes(ptrdiff_t n, const float *D,
    ptrdiff_t D_plane, ptrdiff_t D_stride, const float *k, ptrdiff_t k_stride,
    float *Do, ptrdiff_t Do_plane, ptrdiff_t Do_stride) {
  ksl_SE3f_t D_i;
  if (n > 0) D_i = ksl_SE3f_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3f_of_planes(D + i * D_stride, D_plane);
    ksl_SE3f_t Do_i;
    ksl_product_ddtxf_fused(&D_i, k[i * k_stride], &Do_i);
    ksl_SE3f_to_planes(&Do_i, Do + i * Do_stride, Do_plane);
  }
}

/* ksl_product_drvtxinvf_fused of n elements. */
static KSL_INLINED void ksl_product_drvtxinvf_fused_many(ptrdiff_t n, const ksl_mat3x3f_t *R,
    ptrdiff_t R_stride, const float *k, ptrdiff_t k_stride, ksl_vec3f_t *vo,
    ptrdiff_t vo_stride) {
  KSL_EACH_OF(n) {
    ksl_product_drvtxinvf_fused(R + i * R_stride, k[i * k_stride], vo + i * vo_stride);
  }
}

static KSL_INLINED void ksl_product_drvtxinvf_fused_planes(ptrdiff_t n, const float *R,
    ptrdiff_t R_plane, ptrdiff_t R_stride, const float *k, ptrdiff_t k_stride,
    float *vo, ptrdiff_t vo_plane, ptrdiff_t vo_stride) {
  ksl_mat3x3f_t R_i;
  if (n > 0) R_i = ksl_mat3x3f_of_planes(R, R_plane);
  KSL_EACH_OF(n) {
    if (R_stride) R_i = ksl_mat3x3f_of_planes(R + i * R_stride, R_plane);
    ksl_vec3f_t vo_i;
    ksl_product_drvtxinvf_fused(&R_i, k[i * k_stride], &vo_i);
    ksl_vec3f_to_planes(&vo_i, vo + i * vo_stride, vo_plane);
  }
}

/* ksl_product_drdrxinvf_fused of n elements. */
static KSL_INLINED void ksl_product_drdrxinvf_fused_many(ptrdiff_t n, const ksl_mat3x3f_t *R,
    ptrdiff_t R_stride, const float *dc, ptrdiff_t dc_stride, ksl_mat3x3f_t *Ro,
    ptrdiff_t Ro_stride) {
  KSL_EACH_OF(n) {
    ksl_product_drdrxinvf_fused(R + i * R_stride, dc + 2 * i * dc_stride, Ro + i * Ro_stride);
  }
}

static KSL_INLINED void ksl_product_drdrxinvf_fused_planes(ptrdiff_t n, const float *R,
    ptrdiff_t R_plane, ptrdiff_t R_stride, const float *dc, ptrdiff_t dc_plane,
    ptrdiff_t dc_stride, float *Ro, ptrdiff_t Ro_plane, ptrdiff_t Ro_stride) {
  ksl_mat3x3f_t R_i;
  if (n > 0) R_i = ksl_mat3x3f_of_planes(R, R_plane);
  KSL_EACH_OF(n) {
    if (R_stride) R_i = ksl_mat3x3f_of_planes(R + i * R_stride, R_plane);
    const float dc_i[2] = {dc[0 + i * dc_stride], dc[dc_plane + i * dc_stride]};
    ksl_mat3x3f_t Ro_i;
    ksl_product_drdrxinvf_fused(&R_i, dc_i, &Ro_i);
    ksl_mat3x3f_to_planes(&Ro_i, Ro + i * Ro_stride, Ro_plane);
  }
}

/* ksl_product_ddrxinvf_fused of n elements. */
static KSL_INLINED void ksl_product_ddrxinvf_fused_many(ptrdiff_t n, const ksl_SE3f_t *D,
    ptrdiff_t D_stride, const float *dc, ptrdiff_t dc_stride, ksl_SE3f_t *Do,
    ptrdiff_t Do_stride) {
  KSL_EACH_OF(n) {
    ksl_product_ddrxinvf_fused(D + i * D_stride, dc + 2 * i * dc_stride, Do + i * Do_stride);
  }
}

static KSL_INLINED void ksl_product_ddrxinvf_fused_planes(ptrdiff_t n, const float *D,
    ptrdiff_t D_plane, ptrdiff_t D_stride, const float *dc, ptrdiff_t dc_plane,
    ptrdiff_t dc_stride, float *Do, ptrdiff_t Do_plane, ptrdiff_t Do_stride) {
  ksl_SE3f_t D_i;
  if (n > 0) D_i = ksl_SE3f_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3f_of_planes(D + i * D_stride, D_plane);
    const float dc_i[2] = {dc[0 + i * dc_stride], dc[dc_plane + i * dc_stride]};
    ksl_SE3f_t Do_i;
    ksl_product_ddrxinvf_fused(&D_i, dc_i, &Do_i);
    ksl_SE3f_to_planes(&Do_i, Do + i * Do_stride, Do_plane);
  }
}

/* ksl_product_ddtxinvf_fused of n elements. */
static KSL_INLINED void ksl_product_ddtxinvf_fused_many(ptrdiff_t n, const ksl_SE3f_t *D,
    ptrdiff_t D_stride, const float *k, ptrdiff_t k_stride, ksl_SE3f_t *Do,
    ptrdiff_t Do_stride) {
  KSL_EACH_OF(n) {
    ksl_product_ddtxinvf_fused(D + i * D_stride, k[i * k_stride], Do + i * Do_stride);
  }
}

static KSL_INLINED void ksl_product_ddtxinvf_fused_planes(ptrdiff_t n, const float *D,
    ptrdiff_t D_plane, ptrdiff_t D_stride, const float *k, ptrdiff_t k_stride,
    float *Do, ptrdiff_t Do_plane, ptrdiff_t Do_stride) {
  ksl_SE3f_t D_i;
  if (n > 0) D_i = ksl_SE3f_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3f_of_planes(D + i * D_stride, D_plane);
    ksl_SE3f_t Do_i;
    ksl_product_ddtxinvf_fused(&D_i, k[i * k_stride], &Do_i);
    ksl_SE3f_to_planes(&Do_i, Do + i * Do_stride, Do_plane);
  }
}

/* ksl_product_drvtyf_fused of n elements. */
static KSL_INLINED void ksl_product_drvtyf_fused_many(ptrdiff_t n, const ksl_mat3x3f_t *R,
    ptrdiff_t R_stride, const float *k, ptrdiff_t k_stride, ksl_vec3f_t *vo,
    ptrdiff_t vo_stride) {
  KSL_EACH_OF(n) {
    ksl_product_drvtyf_fused(R + i * R_stride, k[i * k_stride], vo + i * vo_stride);
  }
}

static KSL_INLINED void ksl_product_drvtyf_fused_planes(ptrdiff_t n, const float *R,
    ptrdiff_t R_plane, ptrdiff_t R_stride, const float *k, ptrdiff_t k_stride,
    float *vo, ptrdiff_t vo_plane, ptrdiff_t vo_stride) {
  ksl_mat3x3f_t R_i;
  if (n > 0) R_i = ksl_mat3x3f_of_planes(R, R_plane);
  KSL_EACH_OF(n) {
    if (R_stride) R_i = ksl_mat3x3f_of_planes(R + i * R_stride, R_plane);
    ksl_vec3f_t vo_i;
    ksl_product_drvtyf_fused(&R_i, k[i * k_stride], &vo_i);
    ksl_vec3f_to_planes(&vo_i, vo + i * vo_stride, vo_plane);
  }
}

/* ksl_product_drdryf_fused of n elements. */
static KSL_INLINED void ksl_product_drdryf_fused_many(ptrdiff_t n, const ksl_mat3x3f_t *R,
    ptrdiff_t R_stride, const float *dc, ptrdiff_t dc_stride, ksl_mat3x3f_t *Ro,
    ptrdiff_t Ro_stride) {
  KSL_EACH_OF(n) {
    ksl_product_drdryf_fused(R + i * R_stride, dc + 2 * i * dc_stride, Ro + i * Ro_stride);
  }
}

static KSL_INLINED void ksl_product_drdryf_fused_planes(ptrdiff_t n, const float *R,
    ptrdiff_t R_plane, ptrdiff_t R_stride, const float *dc, ptrdiff_t dc_plane,
    ptrdiff_t dc_stride, float *Ro, ptrdiff_t Ro_plane, ptrdiff_t Ro_stride) {
  ksl_mat3x3f_t R_i;
  if (n > 0) R_i = ksl_mat3x3f_of_planes(R, R_plane);
  KSL_EACH_OF(n) {
    if (R_stride) R_i = ksl_mat3x3f_of_planes(R + i * R_stride, R_plane);
    const float dc_i[2] = {dc[0 + i * dc_stride], dc[dc_plane + i * dc_stride]};
    ksl_mat3x3f_t Ro_i;
    ksl_product_drdryf_fused(&R_i, dc_i, &Ro_i);
    ksl_mat3x3f_to_planes(&Ro_i, Ro + i * Ro_stride, Ro_plane);
  }
}

/* ksl_product_ddryf_fused of n elements. */
static KSL_INLINED void ksl_product_ddryf_fused_many(ptrdiff_t n, const ksl_SE3f_t *D,
    ptrdiff_t D_stride, const float *dc, ptrdiff_t dc_stride, ksl_SE3f_t *Do,
    ptrdiff_t Do_stride) {
  KSL_EACH_OF(n) {
    ksl_product_ddryf_fused(D + i * D_stride, dc + 2 * i * dc_stride, Do + i * Do_stride);
  }
}

static KSL_INLINED void ksl_product_ddryf_fused_planes(ptrdiff_t n, const float *D,
    ptrdiff_t D_plane, ptrdiff_t D_stride, const float *dc, ptrdiff_t dc_plane,
    ptrdiff_t dc_stride, float *Do, ptrdiff_t Do_plane, ptrdiff_t Do_stride) {
  ksl_SE3f_t D_i;
  if (n > 0) D_i = ksl_SE3f_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3f_of_planes(D + i * D_stride, D_plane);
    const float dc_i[2] = {dc[0 + i * dc_stride], dc[dc_plane + i * dc_stride]};
    ksl_SE3f_t Do_i;
    ksl_product_ddryf_fused(&D_i, dc_i, &Do_i);
    ksl_SE3f_to_planes(&Do_i, Do + i * Do_stride, Do_plane);
  }
}

/* ksl_product_ddtyf_fused of n elements. */
static KSL_INLINED void ksl_product_ddtyf_fused_many(ptrdiff_t n, const ksl_SE3f_t *D,
    ptrdiff_t D_stride, const float *k, ptrdiff_t k_stride, ksl_SE3f_t *Do,
    ptrdiff_t Do_stride) {
  KSL_EACH_OF(n) {
    ksl_product_ddtyf_fused(D + i * D_stride, k[i * k_stride], Do + i * Do_stride);
  }
}

static KSL_INLINED void ksl_product_ddtyf_fused_planes(ptrdiff_t n, const float *D,
    ptrdiff_t D_plane, ptrdiff_t D_stride, const float *k, ptrdiff_t k_stride,
    float *Do, ptrdiff_t Do_plane, ptrdiff_t Do_stride) {
  ksl_SE3f_t D_i;
  if (n > 0) D_i = ksl_SE3f_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3f_of_planes(D + i * D_stride, D_plane);
    ksl_SE3f_t Do_i;
    ksl_product_ddtyf_fused(&D_i, k[i * k_stride], &Do_i);
    ksl_SE3f_to_planes(&Do_i, Do + i * Do_stride, Do_plane);
  }
}

/* ksl_product_drvtyinvf_fused of n elements. */
static KSL_INLINED void ksl_product_drvtyinvf_fused_many(ptrdiff_t n, const ksl_mat3x3f_t *R,
    ptrdiff_t R_stride, const float *k, ptrdiff_t k_stride, ksl_vec3f_t *vo,
    ptrdiff_t vo_stride) {
  KSL_EACH_OF(n) {
    ksl_product_drvtyinvf_fused(R + i * R_stride, k[i * k_stride], vo + i * vo_stride);
  }
}

static KSL_INLINED void ksl_product_drvtyinvf_fused_planes(ptrdiff_t n, const float *R,
    ptrdiff_t R_plane, ptrdiff_t R_stride, const float *k, ptrdiff_t k_stride,
    float *vo, ptrdiff_t vo_plane, ptrdiff_t vo_stride) {
  ksl_mat3x3f_t R_i;
  if (n > 0) R_i = ksl_mat3x3f_of_planes(R, R_plane);
  KSL_EACH_OF(n) {
    if (R_stride) R_i = ksl_mat3x3f_of_planes(R + i * R_stride, R_plane);
    ksl_vec3f_t vo_i;
    ksl_product_drvtyinvf_fused(&R_i, k[i * k_stride], &vo_i);
    ksl_vec3f_to_planes(&vo_i, vo + i * vo_stride, vo_plane);
  }
}

/* ksl_product_drdryinvf_fused of n elements. */
static KSL_INLINED void ksl_product_drdryinvf_fused_many(ptrdiff_t n, const ksl_mat3x3f_t *R,
    ptrdiff_t R_stride, const float *dc, ptrdiff_t dc_stride, ksl_mat3x3f_t *Ro,
    ptrdiff_t Ro_stride) {
  KSL_EACH_OF(n) {
    ksl_product_drdryinvf_fused(R + i * R_stride, dc + 2 * i * dc_stride, Ro + i * Ro_stride);
  }
}

static KSL_INLINED void ksl_product_drdryinvf_fused_planes(ptrdiff_t n, const float *R,
    ptrdiff_t R_plane, ptrdiff_t R_stride, const float *dc, ptrdiff_t dc_plane,
    ptrdiff_t dc_stride, float *Ro, ptrdiff_t Ro_plane, ptrdiff_t Ro_stride) {
  ksl_mat3x3f_t R_i;
  if (n > 0) R_i = ksl_mat3x3f_of_planes(R, R_plane);
  KSL_EACH_OF(n) {
    if (R_stride) R_i = ksl_mat3x3f_of_planes(R + i * R_stride, R_plane);
    const float dc_i[2] = {dc[0 + i * dc_stride], dc[dc_plane + i * dc_stride]};
    ksl_mat3x3f_t Ro_i;
    ksl_product_drdryinvf_fused(&R_i, dc_i, &Ro_i);
    ksl_mat3x3f_to_planes(&Ro_i, Ro + i * Ro_stride, Ro_plane);
  }
}

/* ksl_product_ddryinvf_fused of n elements. */
static KSL_INLINED void ksl_product_ddryinvf_fused_many(ptrdiff_t n, const ksl_SE3f_t *D,
    ptrdiff_t D_stride, const float *dc, ptrdiff_t dc_stride, ksl_SE3f_t *Do,
    ptrdiff_t Do_stride) {
  KSL_EACH_OF(n) {
    ksl_product_ddryinvf_fused(D + i * D_stride, dc + 2 * i * dc_stride, Do + i * Do_stride);
  }
}

static KSL_INLINED void ksl_product_ddryinvf_fused_planes(ptrdiff_t n, const float *D,
    ptrdiff_t D_plane, ptrdiff_t D_stride, const float *dc, ptrdiff_t dc_plane,
    ptrdiff_t dc_stride, float *Do, ptrdiff_t Do_plane, ptrdiff_t Do_stride) {
  ksl_SE3f_t D_i;
  if (n > 0) D_i = ksl_SE3f_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3f_of_planes(D + i * D_stride, D_plane);
    const float dc_i[2] = {dc[0 + i * dc_stride], dc[dc_plane + i * dc_stride]};
    ksl_SE3f_t Do_i;
    ksl_product_ddryinvf_fused(&D_i, dc_i, &Do_i);
    ksl_SE3f_to_planes(&Do_i, Do + i * Do_stride, Do_plane);
  }
}

/* ksl_product_ddtyinvf_fused of n elements. */
static KSL_INLINED void ksl_product_ddtyinvf_fused_many(ptrdiff_t n, const ksl_SE3f_t *D,
    ptrdiff_t D_stride, const float *k, ptrdiff_t k_stride, ksl_SE3f_t *Do,
    ptrdiff_t Do_stride) {
  KSL_EACH_OF(n) {
    ksl_product_ddtyinvf_fused(D + i * D_stride, k[i * k_stride], Do + i * Do_stride);
  }
}

static KSL_INLINED void ksl_product_ddtyinvf_fused_planes(ptrdiff_t n, const float *D,
    ptrdiff_t D_plane, ptrdiff_t D_stride, const float *k, ptrdiff_t k_stride,
    float *Do, ptrdiff_t Do_plane, ptrdiff_t Do_stride) {
  ksl_SE3f_t D_i;
  if (n > 0) D_i = ksl_SE3f_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3f_of_planes(D + i * D_stride, D_plane);
    ksl_SE3f_t Do_i;
    ksl_product_ddtyinvf_fused(&D_i, k[i * k_stride], &Do_i);
    ksl_SE3f_to_planes(&Do_i, Do + i * Do_stride, Do_plane);
  }
}

/* ksl_product_drvtzf_fused of n elements. */
static KSL_INLINED void ksl_product_drvtzf_fused_many(ptrdiff_t n, const ksl_mat3x3f_t *R,
    ptrdiff_t R_stride, const float *k, ptrdiff_t k_stride, ksl_vec3f_t *vo,
    ptrdiff_t vo_stride) {
  KSL_EACH_OF(n) {
    ksl_product_drvtzf_fused(R + i * R_stride, k[i * k_stride], vo + i * vo_stride);
  }
}

static KSL_INLINED void ksl_product_drvtzf_fused_planes(ptrdiff_t n, const float *R,
    ptrdiff_t R_plane, ptrdiff_t R_stride, const float *k, ptrdiff_t k_stride,
    float *vo, ptrdiff_t vo_plane, ptrdiff_t vo_stride) {
  ksl_mat3x3f_t R_i;
  if (n > 0) R_i = ksl_mat3x3f_of_planes(R, R_plane);
  KSL_EACH_OF(n) {
    if (R_stride) R_i = ksl_mat3x3f_of_planes(R + i * R_stride, R_plane);
    ksl_vec3f_t vo_i;
    ksl_product_drvtzf_fused(&R_i, k[i * k_stride], &vo_i);
    ksl_vec3f_to_planes(&vo_i, vo + i * vo_stride, vo_plane);
  }
}

/* ksl_product_drdrzf_fused of n elements. */
static KSL_INLINED void ksl_product_drdrzf_fused_many(ptrdiff_t n, const ksl_mat3x3f_t *R,
    ptrdiff_t R_stride, const float *dc, ptrdiff_t dc_stride, ksl_mat3x3f_t *Ro,
    ptrdiff_t Ro_stride) {
  KSL_EACH_OF(n) {
    ksl_product_drdrzf_fused(R + i * R_stride, dc + 2 * i * dc_stride, Ro + i * Ro_stride);
  }
}

static KSL_INLINED void ksl_product_drdrzf_fused_planes(ptrdiff_t n, const float *R,
    ptrdiff_t R_plane, ptrdiff_t R_stride, const float *dc, ptrdiff_t dc_plane,
    ptrdiff_t dc_stride, float *Ro, ptrdiff_t Ro_plane, ptrdiff_t Ro_stride) {
  ksl_mat3x3f_t R_i;
  if (n > 0) R_i = ksl_mat3x3f_of_planes(R, R_plane);
  KSL_EACH_OF(n) {
    if (R_stride) R_i = ksl_mat3x3f_of_planes(R + i * R_stride, R_plane);
    const float dc_i[2] = {dc[0 + i * dc_stride], dc[dc_plane + i * dc_stride]};
    ksl_mat3x3f_t Ro_i;
    ksl_product_drdrzf_fused(&R_i, dc_i, &Ro_i);
    ksl_mat3x3f_to_planes(&Ro_i, Ro + i * Ro_stride, Ro_plane);
  }
}

/* ksl_product_ddrzf_fused of n elements. */
static KSL_INLINED void ksl_product_ddrzf_fused_many(ptrdiff_t n, const ksl_SE3f_t *D,
    ptrdiff_t D_stride, const float *dc, ptrdiff_t dc_stride, ksl_SE3f_t *Do,
    ptrdiff_t Do_stride) {
  KSL_EACH_OF(n) {
    ksl_product_ddrzf_fused(D + i * D_stride, dc + 2 * i * dc_stride, Do + i * Do_stride);
  }
}

static KSL_INLINED void ksl_product_ddrzf_fused_planes(ptrdiff_t n, const float *D,
    ptrdiff_t D_plane, ptrdiff_t D_stride, const float *dc, ptrdiff_t dc_plane,
    ptrdiff_t dc_stride, float *Do, ptrdiff_t Do_plane, ptrdiff_t Do_stride) {
  ksl_SE3f_t D_i;
  if (n > 0) D_i = ksl_SE3f_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3f_of_planes(D + i * D_stride, D_plane);
    const float dc_i[2] = {dc[0 + i * dc_stride], dc[dc_plane + i * dc_stride]};
    ksl_SE3f_t Do_i;
    ksl_product_ddrzf_fused(&D_i, dc_i, &Do_i);
    ksl_SE3f_to_planes(&Do_i, Do + i * Do_stride, Do_plane);
  }
}

/* ksl_product_ddtzf_fused of n elements. */
static KSL_INLINED void ksl_product_ddtzf_fused_many(ptrdiff_t n, const ksl_SE3f_t *D,
    ptrdiff_t D_stride, const float *k, ptrdiff_t k_stride, ksl_SE3f_t *Do,
    ptrdiff_t Do_stride) {
  KSL_EACH_OF(n) {
    ksl_product_ddtzf_fused(D + i * D_stride, k[i * k_stride], Do + i * Do_stride);
  }
}

static KSL_INLINED void ksl_product_ddtzf_fused_planes(ptrdiff_t n, const float *D,
    ptrdiff_t D_plane, ptrdiff_t D_stride, const float *k, ptrdiff_t k_stride,
    float *Do, ptrdiff_t Do_plane, ptrdiff_t Do_stride) {
  ksl_SE3f_t D_i;
  if (n > 0) D_i = ksl_SE3f_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3f_of_planes(D + i * D_stride, D_plane);
    ksl_SE3f_t Do_i;
    ksl_product_ddtzf_fused(&D_i, k[i * k_stride], &Do_i);
    ksl_SE3f_to_planes(&Do_i, Do + i * Do_stride, Do_plane);
  }
}

/* ksl_product_drvtzinvf_fused of n elements. */
static KSL_INLINED void ksl_product_drvtzinvf_fused_many(ptrdiff_t n, const ksl_mat3x3f_t *R,
    ptrdiff_t R_stride, const float *k, ptrdiff_t k_stride, ksl_vec3f_t *vo,
    ptrdiff_t vo_stride) {
  KSL_EACH_OF(n) {
    ksl_product_drvtzinvf_fused(R + i * R_stride, k[i * k_stride], vo + i * vo_stride);
  }
}

static KSL_INLINED void ksl_product_drvtzinvf_fused_planes(ptrdiff_t n, const float *R,
    ptrdiff_t R_plane, ptrdiff_t R_stride, const float *k, ptrdiff_t k_stride,
    float *vo, ptrdiff_t vo_plane, ptrdiff_t vo_stride) {
  ksl_mat3x3f_t R_i;
  if (n > 0) R_i = ksl_mat3x3f_of_planes(R, R_plane);
  KSL_EACH_OF(n) {
    if (R_stride) R_i = ksl_mat3x3f_of_planes(R + i * R_stride, R_plane);
    ksl_vec3f_t vo_i;
    ksl_product_drvtzinvf_fused(&R_i, k[i * k_stride], &vo_i);
    ksl_vec3f_to_planes(&vo_i, vo + i * vo_stride, vo_plane);
  }
}

/* ksl_product_drdrzinvf_fused of n elements. */
static KSL_INLINED void ksl_product_drdrzinvf_fused_many(ptrdiff_t n, const ksl_mat3x3f_t *R,
    ptrdiff_t R_stride, const float *dc, ptrdiff_t dc_stride, ksl_mat3x3f_t *Ro,
    ptrdiff_t Ro_stride) {
  KSL_EACH_OF(n) {
    ksl_product_drdrzinvf_fused(R + i * R_stride, dc + 2 * i * dc_stride, Ro + i * Ro_stride);
  }
}

static KSL_INLINED void ksl_product_drdrzinvf_fused_planes(ptrdiff_t n, const float *R,
    ptrdiff_t R_plane, ptrdiff_t R_stride, const float *dc, ptrdiff_t dc_plane,
    ptrdiff_t dc_stride, float *Ro, ptrdiff_t Ro_plane, ptrdiff_t Ro_stride) {
  ksl_mat3x3f_t R_i;
  if (n > 0) R_i = ksl_mat3x3f_of_planes(R, R_plane);
  KSL_EACH_OF(n) {
    if (R_stride) R_i = ksl_mat3x3f_of_planes(R + i * R_stride, R_plane);
    const float dc_i[2] = {dc[0 + i * dc_stride], dc[dc_plane + i * dc_stride]};
    ksl_mat3x3f_t Ro_i;
    ksl_product_drdrzinvf_fused(&R_i, dc_i, &Ro_i);
    ksl_mat3x3f_to_planes(&Ro_i, Ro + i * Ro_stride, Ro_plane);
  }
}

/* ksl_product_ddrzinvf_fused of n elements. */
static KSL_INLINED void ksl_product_ddrzinvf_fused_many(ptrdiff_t n, const ksl_SE3f_t *D,
    ptrdiff_t D_stride, const float *dc, ptrdiff_t dc_stride, ksl_SE3f_t *Do,
    ptrdiff_t Do_stride) {
  KSL_EACH_OF(n) {
    ksl_product_ddrzinvf_fused(D + i * D_stride, dc + 2 * i * dc_stride, Do + i * Do_stride);
  }
}

static KSL_INLINED void ksl_product_ddrzinvf_fused_planes(ptrdiff_t n, const float *D,
    ptrdiff_t D_plane, ptrdiff_t D_stride, const float *dc, ptrdiff_t dc_plane,
    ptrdiff_t dc_stride, float *Do, ptrdiff_t Do_plane, ptrdiff_t Do_stride) {
  ksl_SE3f_t D_i;
  if (n > 0) D_i = ksl_SE3f_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3f_of_planes(D + i * D_stride, D_plane);
    const float dc_i[2] = {dc[0 + i * dc_stride], dc[dc_plane + i * dc_stride]};
    ksl_SE3f_t Do_i;
    ksl_product_ddrzinvf_fused(&D_i, dc_i, &Do_i);
    ksl_SE3f_to_planes(&Do_i, Do + i * Do_stride, Do_plane);
  }
}

/* ksl_product_ddtzinvf_fused of n elements. */
static KSL_INLINED void ksl_product_ddtzinvf_fused_many(ptrdiff_t n, const ksl_SE3f_t *D,
    ptrdiff_t D_stride, const float *k, ptrdiff_t k_stride, ksl_SE3f_t *Do,
    ptrdiff_t Do_stride) {
  KSL_EACH_OF(n) {
    ksl_product_ddtzinvf_fused(D + i * D_stride, k[i * k_stride], Do + i * Do_stride);
  }
}

static KSL_INLINED void ksl_product_ddtzinvf_fused_planes(ptrdiff_t n, const float *D,
    ptrdiff_t D_plane, ptrdiff_t D_stride, const float *k, ptrdiff_t k_stride,
    float *Do, ptrdiff_t Do_plane, ptrdiff_t Do_stride) {
  ksl_SE3f_t D_i;
  if (n > 0) D_i = ksl_SE3f_of_planes(D, D_plane);
  KSL_EACH_OF(n) {
    if (D_stride) D_i = ksl_SE3f_of_planes(D + i * D_stride, D_plane);
    ksl_SE3f_t Do_i;
    ksl_product_ddtzinvf_fused(&D_i, k[i * k_stride], &Do_i);
    ksl_SE3f_to_planes(&Do_i, Do + i * Do_stride, Do_plane);
  }
}

#endif
