/* Made by `coscrew generate`; changes are overwritten. */
/* SPDX-License-Identifier: MIT */
/* coscrew 0.2.0.  Copyright (c) 2026 The coscrew authors. */
/* Products between rotations, displacements and vectors.
   Certified tier: plain results, and bounds on their errors that always hold. */
#ifndef KSL_MATRIX_CERTIFIED_H
#define KSL_MATRIX_CERTIFIED_H

#include "ksl_types.h"

/* vo = R v; |error of vo| <= vo_bound unless inf or NaN.
   R: rotation or other 3×3 matrix; v, vo, vo_bound: vector.
   12 mul, 15 add, 9 abs. */
static inline void ksl_product_drv_certified(const ksl_mat3x3_t *R, const ksl_vec3_t *v,
    ksl_vec3_t *vo, ksl_vec3_t *vo_bound) {
  const double vo_0a = KSL_MUL(R->m00, v->x), vo_0b = KSL_MUL(R->m01, v->y),
      vo_0d = KSL_MUL(R->m02, v->z), vo_0 = vo_0a + vo_0b + vo_0d;
  const double vo_1a = KSL_MUL(R->m10, v->x), vo_1b = KSL_MUL(R->m11, v->y),
      vo_1d = KSL_MUL(R->m12, v->z), vo_1 = vo_1a + vo_1b + vo_1d;
  const double vo_2a = KSL_MUL(R->m20, v->x), vo_2b = KSL_MUL(R->m21, v->y),
      vo_2d = KSL_MUL(R->m22, v->z), vo_2 = vo_2a + vo_2b + vo_2d;
  const double vo_0_size = fabs(vo_0a) + fabs(vo_0b) + fabs(vo_0d),
      vo_1_size = fabs(vo_1a) + fabs(vo_1b) + fabs(vo_1d),
      vo_2_size = fabs(vo_2a) + fabs(vo_2b) + fabs(vo_2d);
  const double vo_0_bound = KSL_MUL(3.3306690738754706e-16, vo_0_size + 2.004168360008973e-292),
      vo_1_bound = KSL_MUL(3.3306690738754706e-16, vo_1_size + 2.004168360008973e-292),
      vo_2_bound = KSL_MUL(3.3306690738754706e-16, vo_2_size + 2.004168360008973e-292);
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
  vo_bound->x = vo_0_bound;
  vo_bound->y = vo_1_bound;
  vo_bound->z = vo_2_bound;
}

/* vo = R (-v); |error of vo| <= vo_bound unless inf or NaN.
   R: rotation or other 3×3 matrix; v, vo, vo_bound: vector.
   12 mul, 15 add, 3 neg, 9 abs. */
static inline void ksl_product_drvinv_certified(const ksl_mat3x3_t *R, const ksl_vec3_t *v,
    ksl_vec3_t *vo, ksl_vec3_t *vo_bound) {
  const double vo_0a = KSL_MUL(R->m00, v->x), vo_0b = KSL_MUL(R->m01, v->y),
      vo_0d = KSL_MUL(R->m02, v->z), vo_0 = -(vo_0a + vo_0b + vo_0d);
  const double vo_1a = KSL_MUL(R->m10, v->x), vo_1b = KSL_MUL(R->m11, v->y),
      vo_1d = KSL_MUL(R->m12, v->z), vo_1 = -(vo_1a + vo_1b + vo_1d);
  const double vo_2a = KSL_MUL(R->m20, v->x), vo_2b = KSL_MUL(R->m21, v->y),
      vo_2d = KSL_MUL(R->m22, v->z), vo_2 = -(vo_2a + vo_2b + vo_2d);
  const double vo_0e_bound = KSL_MUL(3.3306690738754706e-16, fabs(vo_0a) + fabs(vo_0b)
          + fabs(vo_0d) + 2.004168360008973e-292);
  const double vo_1e_bound = KSL_MUL(3.3306690738754706e-16, fabs(vo_1a) + fabs(vo_1b)
          + fabs(vo_1d) + 2.004168360008973e-292);
  const double vo_2e_bound = KSL_MUL(3.3306690738754706e-16, fabs(vo_2a) + fabs(vo_2b)
          + fabs(vo_2d) + 2.004168360008973e-292);
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
  vo_bound->x = vo_0e_bound;
  vo_bound->y = vo_1e_bound;
  vo_bound->z = vo_2e_bound;
}

/* vo = R^T v; |error of vo| <= vo_bound unless inf or NaN.
   R: rotation or other 3×3 matrix; v, vo, vo_bound: vector.
   12 mul, 15 add, 9 abs. */
static inline void ksl_product_drinvv_certified(const ksl_mat3x3_t *R, const ksl_vec3_t *v,
    ksl_vec3_t *vo, ksl_vec3_t *vo_bound) {
  const double vo_0a = KSL_MUL(R->m00, v->x), vo_0b = KSL_MUL(R->m10, v->y),
      vo_0d = KSL_MUL(R->m20, v->z), vo_0 = vo_0a + vo_0b + vo_0d;
  const double vo_1a = KSL_MUL(R->m01, v->x), vo_1b = KSL_MUL(R->m11, v->y),
      vo_1d = KSL_MUL(R->m21, v->z), vo_1 = vo_1a + vo_1b + vo_1d;
  const double vo_2a = KSL_MUL(R->m02, v->x), vo_2b = KSL_MUL(R->m12, v->y),
      vo_2d = KSL_MUL(R->m22, v->z), vo_2 = vo_2a + vo_2b + vo_2d;
  const double vo_0_size = fabs(vo_0a) + fabs(vo_0b) + fabs(vo_0d),
      vo_1_size = fabs(vo_1a) + fabs(vo_1b) + fabs(vo_1d),
      vo_2_size = fabs(vo_2a) + fabs(vo_2b) + fabs(vo_2d);
  const double vo_0_bound = KSL_MUL(3.3306690738754706e-16, vo_0_size + 2.004168360008973e-292),
      vo_1_bound = KSL_MUL(3.3306690738754706e-16, vo_1_size + 2.004168360008973e-292),
      vo_2_bound = KSL_MUL(3.3306690738754706e-16, vo_2_size + 2.004168360008973e-292);
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
  vo_bound->x = vo_0_bound;
  vo_bound->y = vo_1_bound;
  vo_bound->z = vo_2_bound;
}

/* vo = R^T (-v); |error of vo| <= vo_bound unless inf or NaN.
   R: rotation or other 3×3 matrix; v, vo, vo_bound: vector.
   12 mul, 15 add, 3 neg, 9 abs. */
static inline void ksl_product_drinvvinv_certified(const ksl_mat3x3_t *R, const ksl_vec3_t *v,
    ksl_vec3_t *vo, ksl_vec3_t *vo_bound) {
  const double vo_0a = KSL_MUL(R->m00, v->x), vo_0b = KSL_MUL(R->m10, v->y),
      vo_0d = KSL_MUL(R->m20, v->z), vo_0 = -(vo_0a + vo_0b + vo_0d);
  const double vo_1a = KSL_MUL(R->m01, v->x), vo_1b = KSL_MUL(R->m11, v->y),
      vo_1d = KSL_MUL(R->m21, v->z), vo_1 = -(vo_1a + vo_1b + vo_1d);
  const double vo_2a = KSL_MUL(R->m02, v->x), vo_2b = KSL_MUL(R->m12, v->y),
      vo_2d = KSL_MUL(R->m22, v->z), vo_2 = -(vo_2a + vo_2b + vo_2d);
  const double vo_0e_bound = KSL_MUL(3.3306690738754706e-16, fabs(vo_0a) + fabs(vo_0b)
          + fabs(vo_0d) + 2.004168360008973e-292);
  const double vo_1e_bound = KSL_MUL(3.3306690738754706e-16, fabs(vo_1a) + fabs(vo_1b)
          + fabs(vo_1d) + 2.004168360008973e-292);
  const double vo_2e_bound = KSL_MUL(3.3306690738754706e-16, fabs(vo_2a) + fabs(vo_2b)
          + fabs(vo_2d) + 2.004168360008973e-292);
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
  vo_bound->x = vo_0e_bound;
  vo_bound->y = vo_1e_bound;
  vo_bound->z = vo_2e_bound;
}

/* vo = R v + t; |error of vo| <= vo_bound unless inf or NaN.
   D: displacement [R | t], R rotation, t in m; v, vo, vo_bound: vector.
   12 mul, 21 add, 12 abs. */
static inline void ksl_product_dv_certified(const ksl_SE3_t *D, const ksl_vec3_t *v,
    ksl_vec3_t *vo, ksl_vec3_t *vo_bound) {
  const double vo_0a = KSL_MUL(D->m00, v->x), vo_0b = KSL_MUL(D->m01, v->y),
      vo_0d = KSL_MUL(D->m02, v->z), vo_0 = vo_0a + vo_0b + vo_0d + D->m03;
  const double vo_1a = KSL_MUL(D->m10, v->x), vo_1b = KSL_MUL(D->m11, v->y),
      vo_1d = KSL_MUL(D->m12, v->z), vo_1 = vo_1a + vo_1b + vo_1d + D->m13;
  const double vo_2a = KSL_MUL(D->m20, v->x), vo_2b = KSL_MUL(D->m21, v->y),
      vo_2d = KSL_MUL(D->m22, v->z), vo_2 = vo_2a + vo_2b + vo_2d + D->m23;
  const double vo_0_size = fabs(vo_0a) + fabs(vo_0b) + fabs(vo_0d) + fabs(D->m03),
      vo_1_size = fabs(vo_1a) + fabs(vo_1b) + fabs(vo_1d) + fabs(D->m13),
      vo_2_size = fabs(vo_2a) + fabs(vo_2b) + fabs(vo_2d) + fabs(D->m23);
  const double vo_0_bound = KSL_MUL(4.440892098500628e-16, vo_0_size + 2.004168360008973e-292),
      vo_1_bound = KSL_MUL(4.440892098500628e-16, vo_1_size + 2.004168360008973e-292),
      vo_2_bound = KSL_MUL(4.440892098500628e-16, vo_2_size + 2.004168360008973e-292);
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
  vo_bound->x = vo_0_bound;
  vo_bound->y = vo_1_bound;
  vo_bound->z = vo_2_bound;
}

/* vo = R^T (v - t); |error of vo| <= vo_bound unless inf or NaN.
   D: displacement [R | t], R rotation, t in m; v, vo, vo_bound: vector.
   21 mul, 18 add, 12 abs. */
static inline void ksl_product_dinvv_certified(const ksl_SE3_t *D, const ksl_vec3_t *v,
    ksl_vec3_t *vo, ksl_vec3_t *vo_bound) {
  const double p_0 = v->x - D->m03, p_1 = v->y - D->m13, p_2 = v->z - D->m23;
  const double vo_0 = KSL_MUL(D->m00, p_0) + KSL_MUL(D->m10, p_1) + KSL_MUL(D->m20, p_2),
      vo_1 = KSL_MUL(D->m01, p_0) + KSL_MUL(D->m11, p_1) + KSL_MUL(D->m21, p_2),
      vo_2 = KSL_MUL(D->m02, p_0) + KSL_MUL(D->m12, p_1) + KSL_MUL(D->m22, p_2);
  const double p_0_abs = fabs(p_0), p_1_abs = fabs(p_1), p_2_abs = fabs(p_2),
      vo_0_size = KSL_MUL(fabs(D->m00), p_0_abs) + KSL_MUL(fabs(D->m10), p_1_abs)
          + KSL_MUL(fabs(D->m20), p_2_abs);
  const double vo_1_size = KSL_MUL(fabs(D->m01), p_0_abs) + KSL_MUL(fabs(D->m11), p_1_abs)
          + KSL_MUL(fabs(D->m21), p_2_abs),
      vo_2_size = KSL_MUL(fabs(D->m02), p_0_abs) + KSL_MUL(fabs(D->m12), p_1_abs)
          + KSL_MUL(fabs(D->m22), p_2_abs);
  const double vo_0_bound = KSL_MUL(4.440892098500628e-16, vo_0_size + 2.004168360008973e-292),
      vo_1_bound = KSL_MUL(4.440892098500628e-16, vo_1_size + 2.004168360008973e-292),
      vo_2_bound = KSL_MUL(4.440892098500628e-16, vo_2_size + 2.004168360008973e-292);
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
  vo_bound->x = vo_0_bound;
  vo_bound->y = vo_1_bound;
  vo_bound->z = vo_2_bound;
}

/* Ro = R1 R2; |error of Ro| <= Ro_bound unless inf or NaN.
   R1, R2, Ro, Ro_bound: rotation or other 3×3 matrix.
   36 mul, 45 add, 27 abs. */
static inline void ksl_product_drdr_certified(const ksl_mat3x3_t *R1, const ksl_mat3x3_t *R2,
    ksl_mat3x3_t *Ro, ksl_mat3x3_t *Ro_bound) {
  const double Ro_00a = KSL_MUL(R1->m00, R2->m00), Ro_00b = KSL_MUL(R1->m01, R2->m10),
      Ro_00d = KSL_MUL(R1->m02, R2->m20), Ro_00 = Ro_00a + Ro_00b + Ro_00d;
  const double Ro_01a = KSL_MUL(R1->m00, R2->m01), Ro_01b = KSL_MUL(R1->m01, R2->m11),
      Ro_01d = KSL_MUL(R1->m02, R2->m21), Ro_01 = Ro_01a + Ro_01b + Ro_01d;
  const double Ro_02a = KSL_MUL(R1->m00, R2->m02), Ro_02b = KSL_MUL(R1->m01, R2->m12),
      Ro_02d = KSL_MUL(R1->m02, R2->m22), Ro_02 = Ro_02a + Ro_02b + Ro_02d;
  const double Ro_10a = KSL_MUL(R1->m10, R2->m00), Ro_10b = KSL_MUL(R1->m11, R2->m10),
      Ro_10d = KSL_MUL(R1->m12, R2->m20), Ro_10 = Ro_10a + Ro_10b + Ro_10d;
  const double Ro_11a = KSL_MUL(R1->m10, R2->m01), Ro_11b = KSL_MUL(R1->m11, R2->m11),
      Ro_11d = KSL_MUL(R1->m12, R2->m21), Ro_11 = Ro_11a + Ro_11b + Ro_11d;
  const double Ro_12a = KSL_MUL(R1->m10, R2->m02), Ro_12b = KSL_MUL(R1->m11, R2->m12),
      Ro_12d = KSL_MUL(R1->m12, R2->m22), Ro_12 = Ro_12a + Ro_12b + Ro_12d;
  const double Ro_20a = KSL_MUL(R1->m20, R2->m00), Ro_20b = KSL_MUL(R1->m21, R2->m10),
      Ro_20d = KSL_MUL(R1->m22, R2->m20), Ro_20 = Ro_20a + Ro_20b + Ro_20d;
  const double Ro_21a = KSL_MUL(R1->m20, R2->m01), Ro_21b = KSL_MUL(R1->m21, R2->m11),
      Ro_21d = KSL_MUL(R1->m22, R2->m21), Ro_21 = Ro_21a + Ro_21b + Ro_21d;
  const double Ro_22a = KSL_MUL(R1->m20, R2->m02), Ro_22b = KSL_MUL(R1->m21, R2->m12),
      Ro_22d = KSL_MUL(R1->m22, R2->m22), Ro_22 = Ro_22a + Ro_22b + Ro_22d;
  const double Ro_00_size = fabs(Ro_00a) + fabs(Ro_00b) + fabs(Ro_00d),
      Ro_01_size = fabs(Ro_01a) + fabs(Ro_01b) + fabs(Ro_01d),
      Ro_02_size = fabs(Ro_02a) + fabs(Ro_02b) + fabs(Ro_02d),
      Ro_10_size = fabs(Ro_10a) + fabs(Ro_10b) + fabs(Ro_10d),
      Ro_11_size = fabs(Ro_11a) + fabs(Ro_11b) + fabs(Ro_11d),
      Ro_12_size = fabs(Ro_12a) + fabs(Ro_12b) + fabs(Ro_12d),
      Ro_20_size = fabs(Ro_20a) + fabs(Ro_20b) + fabs(Ro_20d),
      Ro_21_size = fabs(Ro_21a) + fabs(Ro_21b) + fabs(Ro_21d),
      Ro_22_size = fabs(Ro_22a) + fabs(Ro_22b) + fabs(Ro_22d);
  const double Ro_00_bound = KSL_MUL(3.3306690738754706e-16, Ro_00_size + 2.004168360008973e-292),
      Ro_01_bound = KSL_MUL(3.3306690738754706e-16, Ro_01_size + 2.004168360008973e-292),
      Ro_02_bound = KSL_MUL(3.3306690738754706e-16, Ro_02_size + 2.004168360008973e-292),
      Ro_10_bound = KSL_MUL(3.3306690738754706e-16, Ro_10_size + 2.004168360008973e-292),
      Ro_11_bound = KSL_MUL(3.3306690738754706e-16, Ro_11_size + 2.004168360008973e-292),
      Ro_12_bound = KSL_MUL(3.3306690738754706e-16, Ro_12_size + 2.004168360008973e-292),
      Ro_20_bound = KSL_MUL(3.3306690738754706e-16, Ro_20_size + 2.004168360008973e-292),
      Ro_21_bound = KSL_MUL(3.3306690738754706e-16, Ro_21_size + 2.004168360008973e-292),
      Ro_22_bound = KSL_MUL(3.3306690738754706e-16, Ro_22_size + 2.004168360008973e-292);
  Ro->m00 = Ro_00;
  Ro->m01 = Ro_01;
  Ro->m02 = Ro_02;
  Ro->m10 = Ro_10;
  Ro->m11 = Ro_11;
  Ro->m12 = Ro_12;
  Ro->m20 = Ro_20;
  Ro->m21 = Ro_21;
  Ro->m22 = Ro_22;
  Ro_bound->m00 = Ro_00_bound;
  Ro_bound->m01 = Ro_01_bound;
  Ro_bound->m02 = Ro_02_bound;
  Ro_bound->m10 = Ro_10_bound;
  Ro_bound->m11 = Ro_11_bound;
  Ro_bound->m12 = Ro_12_bound;
  Ro_bound->m20 = Ro_20_bound;
  Ro_bound->m21 = Ro_21_bound;
  Ro_bound->m22 = Ro_22_bound;
}

/* Ro = R1 R2^T; |error of Ro| <= Ro_bound unless inf or NaN.
   R1, R2, Ro, Ro_bound: rotation or other 3×3 matrix.
   36 mul, 45 add, 27 abs. */
static inline void ksl_product_drdrinv_certified(const ksl_mat3x3_t *R1, const ksl_mat3x3_t *R2,
    ksl_mat3x3_t *Ro, ksl_mat3x3_t *Ro_bound) {
  const double Ro_00a = KSL_MUL(R1->m00, R2->m00), Ro_00b = KSL_MUL(R1->m01, R2->m01),
      Ro_00d = KSL_MUL(R1->m02, R2->m02), Ro_00 = Ro_00a + Ro_00b + Ro_00d;
  const double Ro_01a = KSL_MUL(R1->m00, R2->m10), Ro_01b = KSL_MUL(R1->m01, R2->m11),
      Ro_01d = KSL_MUL(R1->m02, R2->m12), Ro_01 = Ro_01a + Ro_01b + Ro_01d;
  const double Ro_02a = KSL_MUL(R1->m00, R2->m20), Ro_02b = KSL_MUL(R1->m01, R2->m21),
      Ro_02d = KSL_MUL(R1->m02, R2->m22), Ro_02 = Ro_02a + Ro_02b + Ro_02d;
  const double Ro_10a = KSL_MUL(R1->m10, R2->m00), Ro_10b = KSL_MUL(R1->m11, R2->m01),
      Ro_10d = KSL_MUL(R1->m12, R2->m02), Ro_10 = Ro_10a + Ro_10b + Ro_10d;
  const double Ro_11a = KSL_MUL(R1->m10, R2->m10), Ro_11b = KSL_MUL(R1->m11, R2->m11),
      Ro_11d = KSL_MUL(R1->m12, R2->m12), Ro_11 = Ro_11a + Ro_11b + Ro_11d;
  const double Ro_12a = KSL_MUL(R1->m10, R2->m20), Ro_12b = KSL_MUL(R1->m11, R2->m21),
      Ro_12d = KSL_MUL(R1->m12, R2->m22), Ro_12 = Ro_12a + Ro_12b + Ro_12d;
  const double Ro_20a = KSL_MUL(R1->m20, R2->m00), Ro_20b = KSL_MUL(R1->m21, R2->m01),
      Ro_20d = KSL_MUL(R1->m22, R2->m02), Ro_20 = Ro_20a + Ro_20b + Ro_20d;
  const double Ro_21a = KSL_MUL(R1->m20, R2->m10), Ro_21b = KSL_MUL(R1->m21, R2->m11),
      Ro_21d = KSL_MUL(R1->m22, R2->m12), Ro_21 = Ro_21a + Ro_21b + Ro_21d;
  const double Ro_22a = KSL_MUL(R1->m20, R2->m20), Ro_22b = KSL_MUL(R1->m21, R2->m21),
      Ro_22d = KSL_MUL(R1->m22, R2->m22), Ro_22 = Ro_22a + Ro_22b + Ro_22d;
  const double Ro_00_size = fabs(Ro_00a) + fabs(Ro_00b) + fabs(Ro_00d),
      Ro_01_size = fabs(Ro_01a) + fabs(Ro_01b) + fabs(Ro_01d),
      Ro_02_size = fabs(Ro_02a) + fabs(Ro_02b) + fabs(Ro_02d),
      Ro_10_size = fabs(Ro_10a) + fabs(Ro_10b) + fabs(Ro_10d),
      Ro_11_size = fabs(Ro_11a) + fabs(Ro_11b) + fabs(Ro_11d),
      Ro_12_size = fabs(Ro_12a) + fabs(Ro_12b) + fabs(Ro_12d),
      Ro_20_size = fabs(Ro_20a) + fabs(Ro_20b) + fabs(Ro_20d),
      Ro_21_size = fabs(Ro_21a) + fabs(Ro_21b) + fabs(Ro_21d),
      Ro_22_size = fabs(Ro_22a) + fabs(Ro_22b) + fabs(Ro_22d);
  const double Ro_00_bound = KSL_MUL(3.3306690738754706e-16, Ro_00_size + 2.004168360008973e-292),
      Ro_01_bound = KSL_MUL(3.3306690738754706e-16, Ro_01_size + 2.004168360008973e-292),
      Ro_02_bound = KSL_MUL(3.3306690738754706e-16, Ro_02_size + 2.004168360008973e-292),
      Ro_10_bound = KSL_MUL(3.3306690738754706e-16, Ro_10_size + 2.004168360008973e-292),
      Ro_11_bound = KSL_MUL(3.3306690738754706e-16, Ro_11_size + 2.004168360008973e-292),
      Ro_12_bound = KSL_MUL(3.3306690738754706e-16, Ro_12_size + 2.004168360008973e-292),
      Ro_20_bound = KSL_MUL(3.3306690738754706e-16, Ro_20_size + 2.004168360008973e-292),
      Ro_21_bound = KSL_MUL(3.3306690738754706e-16, Ro_21_size + 2.004168360008973e-292),
      Ro_22_bound = KSL_MUL(3.3306690738754706e-16, Ro_22_size + 2.004168360008973e-292);
  Ro->m00 = Ro_00;
  Ro->m01 = Ro_01;
  Ro->m02 = Ro_02;
  Ro->m10 = Ro_10;
  Ro->m11 = Ro_11;
  Ro->m12 = Ro_12;
  Ro->m20 = Ro_20;
  Ro->m21 = Ro_21;
  Ro->m22 = Ro_22;
  Ro_bound->m00 = Ro_00_bound;
  Ro_bound->m01 = Ro_01_bound;
  Ro_bound->m02 = Ro_02_bound;
  Ro_bound->m10 = Ro_10_bound;
  Ro_bound->m11 = Ro_11_bound;
  Ro_bound->m12 = Ro_12_bound;
  Ro_bound->m20 = Ro_20_bound;
  Ro_bound->m21 = Ro_21_bound;
  Ro_bound->m22 = Ro_22_bound;
}

/* Ro = R1^T R2; |error of Ro| <= Ro_bound unless inf or NaN.
   R1, R2, Ro, Ro_bound: rotation or other 3×3 matrix.
   36 mul, 45 add, 27 abs. */
static inline void ksl_product_drinvdr_certified(const ksl_mat3x3_t *R1, const ksl_mat3x3_t *R2,
    ksl_mat3x3_t *Ro, ksl_mat3x3_t *Ro_bound) {
  const double Ro_00a = KSL_MUL(R1->m00, R2->m00), Ro_00b = KSL_MUL(R1->m10, R2->m10),
      Ro_00d = KSL_MUL(R1->m20, R2->m20), Ro_00 = Ro_00a + Ro_00b + Ro_00d;
  const double Ro_01a = KSL_MUL(R1->m00, R2->m01), Ro_01b = KSL_MUL(R1->m10, R2->m11),
      Ro_01d = KSL_MUL(R1->m20, R2->m21), Ro_01 = Ro_01a + Ro_01b + Ro_01d;
  const double Ro_02a = KSL_MUL(R1->m00, R2->m02), Ro_02b = KSL_MUL(R1->m10, R2->m12),
      Ro_02d = KSL_MUL(R1->m20, R2->m22), Ro_02 = Ro_02a + Ro_02b + Ro_02d;
  const double Ro_10a = KSL_MUL(R1->m01, R2->m00), Ro_10b = KSL_MUL(R1->m11, R2->m10),
      Ro_10d = KSL_MUL(R1->m21, R2->m20), Ro_10 = Ro_10a + Ro_10b + Ro_10d;
  const double Ro_11a = KSL_MUL(R1->m01, R2->m01), Ro_11b = KSL_MUL(R1->m11, R2->m11),
      Ro_11d = KSL_MUL(R1->m21, R2->m21), Ro_11 = Ro_11a + Ro_11b + Ro_11d;
  const double Ro_12a = KSL_MUL(R1->m01, R2->m02), Ro_12b = KSL_MUL(R1->m11, R2->m12),
      Ro_12d = KSL_MUL(R1->m21, R2->m22), Ro_12 = Ro_12a + Ro_12b + Ro_12d;
  const double Ro_20a = KSL_MUL(R1->m02, R2->m00), Ro_20b = KSL_MUL(R1->m12, R2->m10),
      Ro_20d = KSL_MUL(R1->m22, R2->m20), Ro_20 = Ro_20a + Ro_20b + Ro_20d;
  const double Ro_21a = KSL_MUL(R1->m02, R2->m01), Ro_21b = KSL_MUL(R1->m12, R2->m11),
      Ro_21d = KSL_MUL(R1->m22, R2->m21), Ro_21 = Ro_21a + Ro_21b + Ro_21d;
  const double Ro_22a = KSL_MUL(R1->m02, R2->m02), Ro_22b = KSL_MUL(R1->m12, R2->m12),
      Ro_22d = KSL_MUL(R1->m22, R2->m22), Ro_22 = Ro_22a + Ro_22b + Ro_22d;
  const double Ro_00_size = fabs(Ro_00a) + fabs(Ro_00b) + fabs(Ro_00d),
      Ro_01_size = fabs(Ro_01a) + fabs(Ro_01b) + fabs(Ro_01d),
      Ro_02_size = fabs(Ro_02a) + fabs(Ro_02b) + fabs(Ro_02d),
      Ro_10_size = fabs(Ro_10a) + fabs(Ro_10b) + fabs(Ro_10d),
      Ro_11_size = fabs(Ro_11a) + fabs(Ro_11b) + fabs(Ro_11d),
      Ro_12_size = fabs(Ro_12a) + fabs(Ro_12b) + fabs(Ro_12d),
      Ro_20_size = fabs(Ro_20a) + fabs(Ro_20b) + fabs(Ro_20d),
      Ro_21_size = fabs(Ro_21a) + fabs(Ro_21b) + fabs(Ro_21d),
      Ro_22_size = fabs(Ro_22a) + fabs(Ro_22b) + fabs(Ro_22d);
  const double Ro_00_bound = KSL_MUL(3.3306690738754706e-16, Ro_00_size + 2.004168360008973e-292),
      Ro_01_bound = KSL_MUL(3.3306690738754706e-16, Ro_01_size + 2.004168360008973e-292),
      Ro_02_bound = KSL_MUL(3.3306690738754706e-16, Ro_02_size + 2.004168360008973e-292),
      Ro_10_bound = KSL_MUL(3.3306690738754706e-16, Ro_10_size + 2.004168360008973e-292),
      Ro_11_bound = KSL_MUL(3.3306690738754706e-16, Ro_11_size + 2.004168360008973e-292),
      Ro_12_bound = KSL_MUL(3.3306690738754706e-16, Ro_12_size + 2.004168360008973e-292),
      Ro_20_bound = KSL_MUL(3.3306690738754706e-16, Ro_20_size + 2.004168360008973e-292),
      Ro_21_bound = KSL_MUL(3.3306690738754706e-16, Ro_21_size + 2.004168360008973e-292),
      Ro_22_bound = KSL_MUL(3.3306690738754706e-16, Ro_22_size + 2.004168360008973e-292);
  Ro->m00 = Ro_00;
  Ro->m01 = Ro_01;
  Ro->m02 = Ro_02;
  Ro->m10 = Ro_10;
  Ro->m11 = Ro_11;
  Ro->m12 = Ro_12;
  Ro->m20 = Ro_20;
  Ro->m21 = Ro_21;
  Ro->m22 = Ro_22;
  Ro_bound->m00 = Ro_00_bound;
  Ro_bound->m01 = Ro_01_bound;
  Ro_bound->m02 = Ro_02_bound;
  Ro_bound->m10 = Ro_10_bound;
  Ro_bound->m11 = Ro_11_bound;
  Ro_bound->m12 = Ro_12_bound;
  Ro_bound->m20 = Ro_20_bound;
  Ro_bound->m21 = Ro_21_bound;
  Ro_bound->m22 = Ro_22_bound;
}

/* Do = D1 D2 = [R1 R2 | R1 t2 + t1]; |error of Do| <= Do_bound unless inf or NaN.
   D1, D2, Do, Do_bound: displacement [R | t], R rotation, t in m.
   48 mul, 66 add, 39 abs. */
static inline void ksl_product_dd_certified(const ksl_SE3_t *D1, const ksl_SE3_t *D2,
    ksl_SE3_t *Do, ksl_SE3_t *Do_bound) {
  const double Do_00a = KSL_MUL(D1->m00, D2->m00), Do_00b = KSL_MUL(D1->m01, D2->m10),
      Do_00d = KSL_MUL(D1->m02, D2->m20), Do_00 = Do_00a + Do_00b + Do_00d;
  const double Do_01a = KSL_MUL(D1->m00, D2->m01), Do_01b = KSL_MUL(D1->m01, D2->m11),
      Do_01d = KSL_MUL(D1->m02, D2->m21), Do_01 = Do_01a + Do_01b + Do_01d;
  const double Do_02a = KSL_MUL(D1->m00, D2->m02), Do_02b = KSL_MUL(D1->m01, D2->m12),
      Do_02d = KSL_MUL(D1->m02, D2->m22), Do_02 = Do_02a + Do_02b + Do_02d;
  const double Do_03a = KSL_MUL(D1->m00, D2->m03), Do_03b = KSL_MUL(D1->m01, D2->m13),
      Do_03d = KSL_MUL(D1->m02, D2->m23), Do_03 = Do_03a + Do_03b + Do_03d + D1->m03;
  const double Do_10a = KSL_MUL(D1->m10, D2->m00), Do_10b = KSL_MUL(D1->m11, D2->m10),
      Do_10d = KSL_MUL(D1->m12, D2->m20), Do_10 = Do_10a + Do_10b + Do_10d;
  const double Do_11a = KSL_MUL(D1->m10, D2->m01), Do_11b = KSL_MUL(D1->m11, D2->m11),
      Do_11d = KSL_MUL(D1->m12, D2->m21), Do_11 = Do_11a + Do_11b + Do_11d;
  const double Do_12a = KSL_MUL(D1->m10, D2->m02), Do_12b = KSL_MUL(D1->m11, D2->m12),
      Do_12d = KSL_MUL(D1->m12, D2->m22), Do_12 = Do_12a + Do_12b + Do_12d;
  const double Do_13a = KSL_MUL(D1->m10, D2->m03), Do_13b = KSL_MUL(D1->m11, D2->m13),
      Do_13d = KSL_MUL(D1->m12, D2->m23), Do_13 = Do_13a + Do_13b + Do_13d + D1->m13;
  const double Do_20a = KSL_MUL(D1->m20, D2->m00), Do_20b = KSL_MUL(D1->m21, D2->m10),
      Do_20d = KSL_MUL(D1->m22, D2->m20), Do_20 = Do_20a + Do_20b + Do_20d;
  const double Do_21a = KSL_MUL(D1->m20, D2->m01), Do_21b = KSL_MUL(D1->m21, D2->m11),
      Do_21d = KSL_MUL(D1->m22, D2->m21), Do_21 = Do_21a + Do_21b + Do_21d;
  const double Do_22a = KSL_MUL(D1->m20, D2->m02), Do_22b = KSL_MUL(D1->m21, D2->m12),
      Do_22d = KSL_MUL(D1->m22, D2->m22), Do_22 = Do_22a + Do_22b + Do_22d;
  const double Do_23a = KSL_MUL(D1->m20, D2->m03), Do_23b = KSL_MUL(D1->m21, D2->m13),
      Do_23d = KSL_MUL(D1->m22, D2->m23), Do_23 = Do_23a + Do_23b + Do_23d + D1->m23;
  const double Do_00_size = fabs(Do_00a) + fabs(Do_00b) + fabs(Do_00d),
      Do_01_size = fabs(Do_01a) + fabs(Do_01b) + fabs(Do_01d),
      Do_02_size = fabs(Do_02a) + fabs(Do_02b) + fabs(Do_02d),
      Do_03_size = fabs(Do_03a) + fabs(Do_03b) + fabs(Do_03d) + fabs(D1->m03),
      Do_10_size = fabs(Do_10a) + fabs(Do_10b) + fabs(Do_10d),
      Do_11_size = fabs(Do_11a) + fabs(Do_11b) + fabs(Do_11d),
      Do_12_size = fabs(Do_12a) + fabs(Do_12b) + fabs(Do_12d),
      Do_13_size = fabs(Do_13a) + fabs(Do_13b) + fabs(Do_13d) + fabs(D1->m13),
      Do_20_size = fabs(Do_20a) + fabs(Do_20b) + fabs(Do_20d),
      Do_21_size = fabs(Do_21a) + fabs(Do_21b) + fabs(Do_21d),
      Do_22_size = fabs(Do_22a) + fabs(Do_22b) + fabs(Do_22d),
      Do_23_size = fabs(Do_23a) + fabs(Do_23b) + fabs(Do_23d) + fabs(D1->m23);
  const double Do_00_bound = KSL_MUL(3.3306690738754706e-16, Do_00_size + 2.004168360008973e-292),
      Do_01_bound = KSL_MUL(3.3306690738754706e-16, Do_01_size + 2.004168360008973e-292),
      Do_02_bound = KSL_MUL(3.3306690738754706e-16, Do_02_size + 2.004168360008973e-292),
      Do_03_bound = KSL_MUL(4.440892098500628e-16, Do_03_size + 2.004168360008973e-292),
      Do_10_bound = KSL_MUL(3.3306690738754706e-16, Do_10_size + 2.004168360008973e-292),
      Do_11_bound = KSL_MUL(3.3306690738754706e-16, Do_11_size + 2.004168360008973e-292),
      Do_12_bound = KSL_MUL(3.3306690738754706e-16, Do_12_size + 2.004168360008973e-292),
      Do_13_bound = KSL_MUL(4.440892098500628e-16, Do_13_size + 2.004168360008973e-292),
      Do_20_bound = KSL_MUL(3.3306690738754706e-16, Do_20_size + 2.004168360008973e-292),
      Do_21_bound = KSL_MUL(3.3306690738754706e-16, Do_21_size + 2.004168360008973e-292),
      Do_22_bound = KSL_MUL(3.3306690738754706e-16, Do_22_size + 2.004168360008973e-292),
      Do_23_bound = KSL_MUL(4.440892098500628e-16, Do_23_size + 2.004168360008973e-292);
  Do->m00 = Do_00;
  Do->m01 = Do_01;
  Do->m02 = Do_02;
  Do->m03 = Do_03;
  Do->m10 = Do_10;
  Do->m11 = Do_11;
  Do->m12 = Do_12;
  Do->m13 = Do_13;
  Do->m20 = Do_20;
  Do->m21 = Do_21;
  Do->m22 = Do_22;
  Do->m23 = Do_23;
  Do_bound->m00 = Do_00_bound;
  Do_bound->m01 = Do_01_bound;
  Do_bound->m02 = Do_02_bound;
  Do_bound->m03 = Do_03_bound;
  Do_bound->m10 = Do_10_bound;
  Do_bound->m11 = Do_11_bound;
  Do_bound->m12 = Do_12_bound;
  Do_bound->m13 = Do_13_bound;
  Do_bound->m20 = Do_20_bound;
  Do_bound->m21 = Do_21_bound;
  Do_bound->m22 = Do_22_bound;
  Do_bound->m23 = Do_23_bound;
}

/* Do = D1 D2^-1 = [R | t1 - R t2], R = R1 R2^T; |error of Do| <= Do_bound unless inf or NaN.
   D1, D2, Do, Do_bound: displacement [R | t], R rotation, t in m.
   57 mul, 66 add, 33 abs. */
static inline void ksl_product_ddinv_certified(const ksl_SE3_t *D1, const ksl_SE3_t *D2,
    ksl_SE3_t *Do, ksl_SE3_t *Do_bound) {
  const double R_0a = KSL_MUL(D1->m00, D2->m00), R_0b = KSL_MUL(D1->m01, D2->m01),
      R_0d = KSL_MUL(D1->m02, D2->m02), R_0 = R_0a + R_0b + R_0d;
  const double R_1a = KSL_MUL(D1->m00, D2->m10), R_1b = KSL_MUL(D1->m01, D2->m11),
      R_1d = KSL_MUL(D1->m02, D2->m12), R_1 = R_1a + R_1b + R_1d;
  const double R_2a = KSL_MUL(D1->m00, D2->m20), R_2b = KSL_MUL(D1->m01, D2->m21),
      R_2d = KSL_MUL(D1->m02, D2->m22), R_2 = R_2a + R_2b + R_2d;
  const double R_3a = KSL_MUL(D1->m10, D2->m00), R_3b = KSL_MUL(D1->m11, D2->m01),
      R_3d = KSL_MUL(D1->m12, D2->m02), R_3 = R_3a + R_3b + R_3d;
  const double R_4a = KSL_MUL(D1->m10, D2->m10), R_4b = KSL_MUL(D1->m11, D2->m11),
      R_4d = KSL_MUL(D1->m12, D2->m12), R_4 = R_4a + R_4b + R_4d;
  const double R_5a = KSL_MUL(D1->m10, D2->m20), R_5b = KSL_MUL(D1->m11, D2->m21),
      R_5d = KSL_MUL(D1->m12, D2->m22), R_5 = R_5a + R_5b + R_5d;
  const double R_6a = KSL_MUL(D1->m20, D2->m00), R_6b = KSL_MUL(D1->m21, D2->m01),
      R_6d = KSL_MUL(D1->m22, D2->m02), R_6 = R_6a + R_6b + R_6d;
  const double R_7a = KSL_MUL(D1->m20, D2->m10), R_7b = KSL_MUL(D1->m21, D2->m11),
      R_7d = KSL_MUL(D1->m22, D2->m12), R_7 = R_7a + R_7b + R_7d;
  const double R_8a = KSL_MUL(D1->m20, D2->m20), R_8b = KSL_MUL(D1->m21, D2->m21),
      R_8d = KSL_MUL(D1->m22, D2->m22), R_8 = R_8a + R_8b + R_8d;
  const double Do_03 = D1->m03
          - (KSL_MUL(D2->m03, R_0) + KSL_MUL(D2->m13, R_1) + KSL_MUL(D2->m23, R_2));
  const double Do_13 = D1->m13
          - (KSL_MUL(D2->m03, R_3) + KSL_MUL(D2->m13, R_4) + KSL_MUL(D2->m23, R_5));
  const double Do_23 = D1->m23
          - (KSL_MUL(D2->m03, R_6) + KSL_MUL(D2->m13, R_7) + KSL_MUL(D2->m23, R_8));
  const double R_0_size = fabs(R_0a) + fabs(R_0b) + fabs(R_0d),
      R_1_size = fabs(R_1a) + fabs(R_1b) + fabs(R_1d),
      R_2_size = fabs(R_2a) + fabs(R_2b) + fabs(R_2d),
      R_3_size = fabs(R_3a) + fabs(R_3b) + fabs(R_3d),
      R_4_size = fabs(R_4a) + fabs(R_4b) + fabs(R_4d),
      R_5_size = fabs(R_5a) + fabs(R_5b) + fabs(R_5d),
      R_6_size = fabs(R_6a) + fabs(R_6b) + fabs(R_6d),
      R_7_size = fabs(R_7a) + fabs(R_7b) + fabs(R_7d),
      R_8_size = fabs(R_8a) + fabs(R_8b) + fabs(R_8d);
  const double R_0_padded = R_0_size + 2.004168360008973e-292;
  const double D2_03_abs = fabs(D2->m03);
  const double R_1_padded = R_1_size + 2.004168360008973e-292;
  const double D2_13_abs = fabs(D2->m13);
  const double R_2_padded = R_2_size + 2.004168360008973e-292;
  const double D2_23_abs = fabs(D2->m23),
      Do_03_size = fabs(D1->m03)
          + (KSL_MUL(D2_03_abs, R_0_padded) + KSL_MUL(D2_13_abs, R_1_padded)
          + KSL_MUL(D2_23_abs, R_2_padded));
  const double R_3_padded = R_3_size + 2.004168360008973e-292,
      R_4_padded = R_4_size + 2.004168360008973e-292,
      R_5_padded = R_5_size + 2.004168360008973e-292;
  const double Do_13_size = fabs(D1->m13)
          + (KSL_MUL(D2_03_abs, R_3_padded) + KSL_MUL(D2_13_abs, R_4_padded)
          + KSL_MUL(D2_23_abs, R_5_padded));
  const double R_6_padded = R_6_size + 2.004168360008973e-292,
      R_7_padded = R_7_size + 2.004168360008973e-292,
      R_8_padded = R_8_size + 2.004168360008973e-292;
  const double Do_23_size = fabs(D1->m23)
          + (KSL_MUL(D2_03_abs, R_6_padded) + KSL_MUL(D2_13_abs, R_7_padded)
          + KSL_MUL(D2_23_abs, R_8_padded));
  const double R_0_bound = KSL_MUL(3.3306690738754706e-16, R_0_padded),
      R_1_bound = KSL_MUL(3.3306690738754706e-16, R_1_padded),
      R_2_bound = KSL_MUL(3.3306690738754706e-16, R_2_padded);
  const double Do_03_bound = KSL_MUL(7.7715611723761e-16, Do_03_size + 2.004168360008973e-292);
  const double R_3_bound = KSL_MUL(3.3306690738754706e-16, R_3_padded),
      R_4_bound = KSL_MUL(3.3306690738754706e-16, R_4_padded),
      R_5_bound = KSL_MUL(3.3306690738754706e-16, R_5_padded);
  const double Do_13_bound = KSL_MUL(7.7715611723761e-16, Do_13_size + 2.004168360008973e-292);
  const double R_6_bound = KSL_MUL(3.3306690738754706e-16, R_6_padded),
      R_7_bound = KSL_MUL(3.3306690738754706e-16, R_7_padded),
      R_8_bound = KSL_MUL(3.3306690738754706e-16, R_8_padded);
  const double Do_23_bound = KSL_MUL(7.7715611723761e-16, Do_23_size + 2.004168360008973e-292);
  Do->m00 = R_0;
  Do->m01 = R_1;
  Do->m02 = R_2;
  Do->m03 = Do_03;
  Do->m10 = R_3;
  Do->m11 = R_4;
  Do->m12 = R_5;
  Do->m13 = Do_13;
  Do->m20 = R_6;
  Do->m21 = R_7;
  Do->m22 = R_8;
  Do->m23 = Do_23;
  Do_bound->m00 = R_0_bound;
  Do_bound->m01 = R_1_bound;
  Do_bound->m02 = R_2_bound;
  Do_bound->m03 = Do_03_bound;
  Do_bound->m10 = R_3_bound;
  Do_bound->m11 = R_4_bound;
  Do_bound->m12 = R_5_bound;
  Do_bound->m13 = Do_13_bound;
  Do_bound->m20 = R_6_bound;
  Do_bound->m21 = R_7_bound;
  Do_bound->m22 = R_8_bound;
  Do_bound->m23 = Do_23_bound;
}

/* Do = D1^-1 D2 = [R1^T R2 | R1^T (t2 - t1)]; |error of Do| <= Do_bound unless inf or NaN.
   D1, D2, Do, Do_bound: displacement [R | t], R rotation, t in m.
   57 mul, 63 add, 39 abs. */
static inline void ksl_product_dinvd_certified(const ksl_SE3_t *D1, const ksl_SE3_t *D2,
    ksl_SE3_t *Do, ksl_SE3_t *Do_bound) {
  const double p_0 = D2->m03 - D1->m03, p_1 = D2->m13 - D1->m13, p_2 = D2->m23 - D1->m23;
  const double Do_00a = KSL_MUL(D1->m00, D2->m00), Do_00b = KSL_MUL(D1->m10, D2->m10),
      Do_00d = KSL_MUL(D1->m20, D2->m20), Do_00 = Do_00a + Do_00b + Do_00d;
  const double Do_01a = KSL_MUL(D1->m00, D2->m01), Do_01b = KSL_MUL(D1->m10, D2->m11),
      Do_01d = KSL_MUL(D1->m20, D2->m21), Do_01 = Do_01a + Do_01b + Do_01d;
  const double Do_02a = KSL_MUL(D1->m00, D2->m02), Do_02b = KSL_MUL(D1->m10, D2->m12),
      Do_02d = KSL_MUL(D1->m20, D2->m22), Do_02 = Do_02a + Do_02b + Do_02d;
  const double Do_03 = KSL_MUL(D1->m00, p_0) + KSL_MUL(D1->m10, p_1) + KSL_MUL(D1->m20, p_2);
  const double Do_10a = KSL_MUL(D1->m01, D2->m00), Do_10b = KSL_MUL(D1->m11, D2->m10),
      Do_10d = KSL_MUL(D1->m21, D2->m20), Do_10 = Do_10a + Do_10b + Do_10d;
  const double Do_11a = KSL_MUL(D1->m01, D2->m01), Do_11b = KSL_MUL(D1->m11, D2->m11),
      Do_11d = KSL_MUL(D1->m21, D2->m21), Do_11 = Do_11a + Do_11b + Do_11d;
  const double Do_12a = KSL_MUL(D1->m01, D2->m02), Do_12b = KSL_MUL(D1->m11, D2->m12),
      Do_12d = KSL_MUL(D1->m21, D2->m22), Do_12 = Do_12a + Do_12b + Do_12d;
  const double Do_13 = KSL_MUL(D1->m01, p_0) + KSL_MUL(D1->m11, p_1) + KSL_MUL(D1->m21, p_2);
  const double Do_20a = KSL_MUL(D1->m02, D2->m00), Do_20b = KSL_MUL(D1->m12, D2->m10),
      Do_20d = KSL_MUL(D1->m22, D2->m20), Do_20 = Do_20a + Do_20b + Do_20d;
  const double Do_21a = KSL_MUL(D1->m02, D2->m01), Do_21b = KSL_MUL(D1->m12, D2->m11),
      Do_21d = KSL_MUL(D1->m22, D2->m21), Do_21 = Do_21a + Do_21b + Do_21d;
  const double Do_22a = KSL_MUL(D1->m02, D2->m02), Do_22b = KSL_MUL(D1->m12, D2->m12),
      Do_22d = KSL_MUL(D1->m22, D2->m22), Do_22 = Do_22a + Do_22b + Do_22d;
  const double Do_23 = KSL_MUL(D1->m02, p_0) + KSL_MUL(D1->m12, p_1) + KSL_MUL(D1->m22, p_2);
  const double Do_00_size = fabs(Do_00a) + fabs(Do_00b) + fabs(Do_00d),
      Do_01_size = fabs(Do_01a) + fabs(Do_01b) + fabs(Do_01d),
      Do_02_size = fabs(Do_02a) + fabs(Do_02b) + fabs(Do_02d);
  const double p_0_abs = fabs(p_0), p_1_abs = fabs(p_1), p_2_abs = fabs(p_2),
      Do_03_size = KSL_MUL(fabs(D1->m00), p_0_abs) + KSL_MUL(fabs(D1->m10), p_1_abs)
          + KSL_MUL(fabs(D1->m20), p_2_abs);
  const double Do_10_size = fabs(Do_10a) + fabs(Do_10b) + fabs(Do_10d),
      Do_11_size = fabs(Do_11a) + fabs(Do_11b) + fabs(Do_11d),
      Do_12_size = fabs(Do_12a) + fabs(Do_12b) + fabs(Do_12d),
      Do_13_size = KSL_MUL(fabs(D1->m01), p_0_abs) + KSL_MUL(fabs(D1->m11), p_1_abs)
          + KSL_MUL(fabs(D1->m21), p_2_abs),
      Do_20_size = fabs(Do_20a) + fabs(Do_20b) + fabs(Do_20d),
      Do_21_size = fabs(Do_21a) + fabs(Do_21b) + fabs(Do_21d),
      Do_22_size = fabs(Do_22a) + fabs(Do_22b) + fabs(Do_22d),
      Do_23_size = KSL_MUL(fabs(D1->m02), p_0_abs) + KSL_MUL(fabs(D1->m12), p_1_abs)
          + KSL_MUL(fabs(D1->m22), p_2_abs);
  const double Do_00_bound = KSL_MUL(3.3306690738754706e-16, Do_00_size + 2.004168360008973e-292),
      Do_01_bound = KSL_MUL(3.3306690738754706e-16, Do_01_size + 2.004168360008973e-292),
      Do_02_bound = KSL_MUL(3.3306690738754706e-16, Do_02_size + 2.004168360008973e-292),
      Do_03_bound = KSL_MUL(4.440892098500628e-16, Do_03_size + 2.004168360008973e-292),
      Do_10_bound = KSL_MUL(3.3306690738754706e-16, Do_10_size + 2.004168360008973e-292),
      Do_11_bound = KSL_MUL(3.3306690738754706e-16, Do_11_size + 2.004168360008973e-292),
      Do_12_bound = KSL_MUL(3.3306690738754706e-16, Do_12_size + 2.004168360008973e-292),
      Do_13_bound = KSL_MUL(4.440892098500628e-16, Do_13_size + 2.004168360008973e-292),
      Do_20_bound = KSL_MUL(3.3306690738754706e-16, Do_20_size + 2.004168360008973e-292),
      Do_21_bound = KSL_MUL(3.3306690738754706e-16, Do_21_size + 2.004168360008973e-292),
      Do_22_bound = KSL_MUL(3.3306690738754706e-16, Do_22_size + 2.004168360008973e-292),
      Do_23_bound = KSL_MUL(4.440892098500628e-16, Do_23_size + 2.004168360008973e-292);
  Do->m00 = Do_00;
  Do->m01 = Do_01;
  Do->m02 = Do_02;
  Do->m03 = Do_03;
  Do->m10 = Do_10;
  Do->m11 = Do_11;
  Do->m12 = Do_12;
  Do->m13 = Do_13;
  Do->m20 = Do_20;
  Do->m21 = Do_21;
  Do->m22 = Do_22;
  Do->m23 = Do_23;
  Do_bound->m00 = Do_00_bound;
  Do_bound->m01 = Do_01_bound;
  Do_bound->m02 = Do_02_bound;
  Do_bound->m03 = Do_03_bound;
  Do_bound->m10 = Do_10_bound;
  Do_bound->m11 = Do_11_bound;
  Do_bound->m12 = Do_12_bound;
  Do_bound->m13 = Do_13_bound;
  Do_bound->m20 = Do_20_bound;
  Do_bound->m21 = Do_21_bound;
  Do_bound->m22 = Do_22_bound;
  Do_bound->m23 = Do_23_bound;
}

/* Do = D [R | 0]; |error of Do| <= Do_bound unless inf or NaN.
   D, Do, Do_bound: displacement [R | t], R rotation, t in m; R: rotation or other 3×3 matrix.
   36 mul, 45 add, 27 abs. */
static inline void ksl_product_ddr_certified(const ksl_SE3_t *D, const ksl_mat3x3_t *R,
    ksl_SE3_t *Do, ksl_SE3_t *Do_bound) {
  const double Do_00a = KSL_MUL(D->m00, R->m00), Do_00b = KSL_MUL(D->m01, R->m10),
      Do_00d = KSL_MUL(D->m02, R->m20), Do_00 = Do_00a + Do_00b + Do_00d;
  const double Do_01a = KSL_MUL(D->m00, R->m01), Do_01b = KSL_MUL(D->m01, R->m11),
      Do_01d = KSL_MUL(D->m02, R->m21), Do_01 = Do_01a + Do_01b + Do_01d;
  const double Do_02a = KSL_MUL(D->m00, R->m02), Do_02b = KSL_MUL(D->m01, R->m12),
      Do_02d = KSL_MUL(D->m02, R->m22), Do_02 = Do_02a + Do_02b + Do_02d;
  const double Do_10a = KSL_MUL(D->m10, R->m00), Do_10b = KSL_MUL(D->m11, R->m10),
      Do_10d = KSL_MUL(D->m12, R->m20), Do_10 = Do_10a + Do_10b + Do_10d;
  const double Do_11a = KSL_MUL(D->m10, R->m01), Do_11b = KSL_MUL(D->m11, R->m11),
      Do_11d = KSL_MUL(D->m12, R->m21), Do_11 = Do_11a + Do_11b + Do_11d;
  const double Do_12a = KSL_MUL(D->m10, R->m02), Do_12b = KSL_MUL(D->m11, R->m12),
      Do_12d = KSL_MUL(D->m12, R->m22), Do_12 = Do_12a + Do_12b + Do_12d;
  const double Do_20a = KSL_MUL(D->m20, R->m00), Do_20b = KSL_MUL(D->m21, R->m10),
      Do_20d = KSL_MUL(D->m22, R->m20), Do_20 = Do_20a + Do_20b + Do_20d;
  const double Do_21a = KSL_MUL(D->m20, R->m01), Do_21b = KSL_MUL(D->m21, R->m11),
      Do_21d = KSL_MUL(D->m22, R->m21), Do_21 = Do_21a + Do_21b + Do_21d;
  const double Do_22a = KSL_MUL(D->m20, R->m02), Do_22b = KSL_MUL(D->m21, R->m12),
      Do_22d = KSL_MUL(D->m22, R->m22), Do_22 = Do_22a + Do_22b + Do_22d;
  const double Do_00_size = fabs(Do_00a) + fabs(Do_00b) + fabs(Do_00d),
      Do_01_size = fabs(Do_01a) + fabs(Do_01b) + fabs(Do_01d),
      Do_02_size = fabs(Do_02a) + fabs(Do_02b) + fabs(Do_02d),
      Do_10_size = fabs(Do_10a) + fabs(Do_10b) + fabs(Do_10d),
      Do_11_size = fabs(Do_11a) + fabs(Do_11b) + fabs(Do_11d),
      Do_12_size = fabs(Do_12a) + fabs(Do_12b) + fabs(Do_12d),
      Do_20_size = fabs(Do_20a) + fabs(Do_20b) + fabs(Do_20d),
      Do_21_size = fabs(Do_21a) + fabs(Do_21b) + fabs(Do_21d),
      Do_22_size = fabs(Do_22a) + fabs(Do_22b) + fabs(Do_22d);
  const double Do_00_bound = KSL_MUL(3.3306690738754706e-16, Do_00_size + 2.004168360008973e-292),
      Do_01_bound = KSL_MUL(3.3306690738754706e-16, Do_01_size + 2.004168360008973e-292),
      Do_02_bound = KSL_MUL(3.3306690738754706e-16, Do_02_size + 2.004168360008973e-292),
      Do_10_bound = KSL_MUL(3.3306690738754706e-16, Do_10_size + 2.004168360008973e-292),
      Do_11_bound = KSL_MUL(3.3306690738754706e-16, Do_11_size + 2.004168360008973e-292),
      Do_12_bound = KSL_MUL(3.3306690738754706e-16, Do_12_size + 2.004168360008973e-292),
      Do_20_bound = KSL_MUL(3.3306690738754706e-16, Do_20_size + 2.004168360008973e-292),
      Do_21_bound = KSL_MUL(3.3306690738754706e-16, Do_21_size + 2.004168360008973e-292),
      Do_22_bound = KSL_MUL(3.3306690738754706e-16, Do_22_size + 2.004168360008973e-292);
  const double D_m03 = D->m03;
  const double D_m13 = D->m13;
  const double D_m23 = D->m23;
  Do->m00 = Do_00;
  Do->m01 = Do_01;
  Do->m02 = Do_02;
  Do->m03 = D_m03;
  Do->m10 = Do_10;
  Do->m11 = Do_11;
  Do->m12 = Do_12;
  Do->m13 = D_m13;
  Do->m20 = Do_20;
  Do->m21 = Do_21;
  Do->m22 = Do_22;
  Do->m23 = D_m23;
  Do_bound->m00 = Do_00_bound;
  Do_bound->m01 = Do_01_bound;
  Do_bound->m02 = Do_02_bound;
  Do_bound->m03 = 0.0;
  Do_bound->m10 = Do_10_bound;
  Do_bound->m11 = Do_11_bound;
  Do_bound->m12 = Do_12_bound;
  Do_bound->m13 = 0.0;
  Do_bound->m20 = Do_20_bound;
  Do_bound->m21 = Do_21_bound;
  Do_bound->m22 = Do_22_bound;
  Do_bound->m23 = 0.0;
}

/* Do = D [R^T | 0]; |error of Do| <= Do_bound unless inf or NaN.
   D, Do, Do_bound: displacement [R | t], R rotation, t in m; R: rotation or other 3×3 matrix.
   36 mul, 45 add, 27 abs. */
static inline void ksl_product_ddrinv_certified(const ksl_SE3_t *D, const ksl_mat3x3_t *R,
    ksl_SE3_t *Do, ksl_SE3_t *Do_bound) {
  const double Do_00a = KSL_MUL(D->m00, R->m00), Do_00b = KSL_MUL(D->m01, R->m01),
      Do_00d = KSL_MUL(D->m02, R->m02), Do_00 = Do_00a + Do_00b + Do_00d;
  const double Do_01a = KSL_MUL(D->m00, R->m10), Do_01b = KSL_MUL(D->m01, R->m11),
      Do_01d = KSL_MUL(D->m02, R->m12), Do_01 = Do_01a + Do_01b + Do_01d;
  const double Do_02a = KSL_MUL(D->m00, R->m20), Do_02b = KSL_MUL(D->m01, R->m21),
      Do_02d = KSL_MUL(D->m02, R->m22), Do_02 = Do_02a + Do_02b + Do_02d;
  const double Do_10a = KSL_MUL(D->m10, R->m00), Do_10b = KSL_MUL(D->m11, R->m01),
      Do_10d = KSL_MUL(D->m12, R->m02), Do_10 = Do_10a + Do_10b + Do_10d;
  const double Do_11a = KSL_MUL(D->m10, R->m10), Do_11b = KSL_MUL(D->m11, R->m11),
      Do_11d = KSL_MUL(D->m12, R->m12), Do_11 = Do_11a + Do_11b + Do_11d;
  const double Do_12a = KSL_MUL(D->m10, R->m20), Do_12b = KSL_MUL(D->m11, R->m21),
      Do_12d = KSL_MUL(D->m12, R->m22), Do_12 = Do_12a + Do_12b + Do_12d;
  const double Do_20a = KSL_MUL(D->m20, R->m00), Do_20b = KSL_MUL(D->m21, R->m01),
      Do_20d = KSL_MUL(D->m22, R->m02), Do_20 = Do_20a + Do_20b + Do_20d;
  const double Do_21a = KSL_MUL(D->m20, R->m10), Do_21b = KSL_MUL(D->m21, R->m11),
      Do_21d = KSL_MUL(D->m22, R->m12), Do_21 = Do_21a + Do_21b + Do_21d;
  const double Do_22a = KSL_MUL(D->m20, R->m20), Do_22b = KSL_MUL(D->m21, R->m21),
      Do_22d = KSL_MUL(D->m22, R->m22), Do_22 = Do_22a + Do_22b + Do_22d;
  const double Do_00_size = fabs(Do_00a) + fabs(Do_00b) + fabs(Do_00d),
      Do_01_size = fabs(Do_01a) + fabs(Do_01b) + fabs(Do_01d),
      Do_02_size = fabs(Do_02a) + fabs(Do_02b) + fabs(Do_02d),
      Do_10_size = fabs(Do_10a) + fabs(Do_10b) + fabs(Do_10d),
      Do_11_size = fabs(Do_11a) + fabs(Do_11b) + fabs(Do_11d),
      Do_12_size = fabs(Do_12a) + fabs(Do_12b) + fabs(Do_12d),
      Do_20_size = fabs(Do_20a) + fabs(Do_20b) + fabs(Do_20d),
      Do_21_size = fabs(Do_21a) + fabs(Do_21b) + fabs(Do_21d),
      Do_22_size = fabs(Do_22a) + fabs(Do_22b) + fabs(Do_22d);
  const double Do_00_bound = KSL_MUL(3.3306690738754706e-16, Do_00_size + 2.004168360008973e-292),
      Do_01_bound = KSL_MUL(3.3306690738754706e-16, Do_01_size + 2.004168360008973e-292),
      Do_02_bound = KSL_MUL(3.3306690738754706e-16, Do_02_size + 2.004168360008973e-292),
      Do_10_bound = KSL_MUL(3.3306690738754706e-16, Do_10_size + 2.004168360008973e-292),
      Do_11_bound = KSL_MUL(3.3306690738754706e-16, Do_11_size + 2.004168360008973e-292),
      Do_12_bound = KSL_MUL(3.3306690738754706e-16, Do_12_size + 2.004168360008973e-292),
      Do_20_bound = KSL_MUL(3.3306690738754706e-16, Do_20_size + 2.004168360008973e-292),
      Do_21_bound = KSL_MUL(3.3306690738754706e-16, Do_21_size + 2.004168360008973e-292),
      Do_22_bound = KSL_MUL(3.3306690738754706e-16, Do_22_size + 2.004168360008973e-292);
  const double D_m03 = D->m03;
  const double D_m13 = D->m13;
  const double D_m23 = D->m23;
  Do->m00 = Do_00;
  Do->m01 = Do_01;
  Do->m02 = Do_02;
  Do->m03 = D_m03;
  Do->m10 = Do_10;
  Do->m11 = Do_11;
  Do->m12 = Do_12;
  Do->m13 = D_m13;
  Do->m20 = Do_20;
  Do->m21 = Do_21;
  Do->m22 = Do_22;
  Do->m23 = D_m23;
  Do_bound->m00 = Do_00_bound;
  Do_bound->m01 = Do_01_bound;
  Do_bound->m02 = Do_02_bound;
  Do_bound->m03 = 0.0;
  Do_bound->m10 = Do_10_bound;
  Do_bound->m11 = Do_11_bound;
  Do_bound->m12 = Do_12_bound;
  Do_bound->m13 = 0.0;
  Do_bound->m20 = Do_20_bound;
  Do_bound->m21 = Do_21_bound;
  Do_bound->m22 = Do_22_bound;
  Do_bound->m23 = 0.0;
}

/* Do = D [I | t]; |error of Do| <= Do_bound unless inf or NaN.
   D, Do, Do_bound: displacement [R | t], R rotation, t in m; t: vector.
   12 mul, 21 add, 12 abs. */
static inline void ksl_product_ddt_certified(const ksl_SE3_t *D, const ksl_vec3_t *t,
    ksl_SE3_t *Do, ksl_SE3_t *Do_bound) {
  const double Do_03a = KSL_MUL(D->m00, t->x), Do_03b = KSL_MUL(D->m01, t->y),
      Do_03d = KSL_MUL(D->m02, t->z), Do_03 = Do_03a + Do_03b + Do_03d + D->m03;
  const double Do_13a = KSL_MUL(D->m10, t->x), Do_13b = KSL_MUL(D->m11, t->y),
      Do_13d = KSL_MUL(D->m12, t->z), Do_13 = Do_13a + Do_13b + Do_13d + D->m13;
  const double Do_23a = KSL_MUL(D->m20, t->x), Do_23b = KSL_MUL(D->m21, t->y),
      Do_23d = KSL_MUL(D->m22, t->z), Do_23 = Do_23a + Do_23b + Do_23d + D->m23;
  const double Do_03_size = fabs(Do_03a) + fabs(Do_03b) + fabs(Do_03d) + fabs(D->m03),
      Do_13_size = fabs(Do_13a) + fabs(Do_13b) + fabs(Do_13d) + fabs(D->m13),
      Do_23_size = fabs(Do_23a) + fabs(Do_23b) + fabs(Do_23d) + fabs(D->m23);
  const double Do_03_bound = KSL_MUL(4.440892098500628e-16, Do_03_size + 2.004168360008973e-292),
      Do_13_bound = KSL_MUL(4.440892098500628e-16, Do_13_size + 2.004168360008973e-292),
      Do_23_bound = KSL_MUL(4.440892098500628e-16, Do_23_size + 2.004168360008973e-292);
  const double D_m00 = D->m00;
  const double D_m01 = D->m01;
  const double D_m02 = D->m02;
  const double D_m10 = D->m10;
  const double D_m11 = D->m11;
  const double D_m12 = D->m12;
  const double D_m20 = D->m20;
  const double D_m21 = D->m21;
  const double D_m22 = D->m22;
  Do->m00 = D_m00;
  Do->m01 = D_m01;
  Do->m02 = D_m02;
  Do->m03 = Do_03;
  Do->m10 = D_m10;
  Do->m11 = D_m11;
  Do->m12 = D_m12;
  Do->m13 = Do_13;
  Do->m20 = D_m20;
  Do->m21 = D_m21;
  Do->m22 = D_m22;
  Do->m23 = Do_23;
  Do_bound->m00 = 0.0;
  Do_bound->m01 = 0.0;
  Do_bound->m02 = 0.0;
  Do_bound->m03 = Do_03_bound;
  Do_bound->m10 = 0.0;
  Do_bound->m11 = 0.0;
  Do_bound->m12 = 0.0;
  Do_bound->m13 = Do_13_bound;
  Do_bound->m20 = 0.0;
  Do_bound->m21 = 0.0;
  Do_bound->m22 = 0.0;
  Do_bound->m23 = Do_23_bound;
}

/* Do = D [I | -t]; |error of Do| <= Do_bound unless inf or NaN.
   D, Do, Do_bound: displacement [R | t], R rotation, t in m; t: vector.
   12 mul, 21 add, 12 abs. */
static inline void ksl_product_ddtinv_certified(const ksl_SE3_t *D, const ksl_vec3_t *t,
    ksl_SE3_t *Do, ksl_SE3_t *Do_bound) {
  const double Do_03a = KSL_MUL(D->m00, t->x), Do_03b = KSL_MUL(D->m01, t->y),
      Do_03d = KSL_MUL(D->m02, t->z), Do_03 = D->m03 - (Do_03a + Do_03b + Do_03d);
  const double Do_13a = KSL_MUL(D->m10, t->x), Do_13b = KSL_MUL(D->m11, t->y),
      Do_13d = KSL_MUL(D->m12, t->z), Do_13 = D->m13 - (Do_13a + Do_13b + Do_13d);
  const double Do_23a = KSL_MUL(D->m20, t->x), Do_23b = KSL_MUL(D->m21, t->y),
      Do_23d = KSL_MUL(D->m22, t->z), Do_23 = D->m23 - (Do_23a + Do_23b + Do_23d);
  const double Do_03_size = fabs(D->m03) + (fabs(Do_03a) + fabs(Do_03b) + fabs(Do_03d)),
      Do_13_size = fabs(D->m13) + (fabs(Do_13a) + fabs(Do_13b) + fabs(Do_13d)),
      Do_23_size = fabs(D->m23) + (fabs(Do_23a) + fabs(Do_23b) + fabs(Do_23d));
  const double Do_03_bound = KSL_MUL(4.440892098500628e-16, Do_03_size + 2.004168360008973e-292),
      Do_13_bound = KSL_MUL(4.440892098500628e-16, Do_13_size + 2.004168360008973e-292),
      Do_23_bound = KSL_MUL(4.440892098500628e-16, Do_23_size + 2.004168360008973e-292);
  const double D_m00 = D->m00;
  const double D_m01 = D->m01;
  const double D_m02 = D->m02;
  const double D_m10 = D->m10;
  const double D_m11 = D->m11;
  const double D_m12 = D->m12;
  const double D_m20 = D->m20;
  const double D_m21 = D->m21;
  const double D_m22 = D->m22;
  Do->m00 = D_m00;
  Do->m01 = D_m01;
  Do->m02 = D_m02;
  Do->m03 = Do_03;
  Do->m10 = D_m10;
  Do->m11 = D_m11;
  Do->m12 = D_m12;
  Do->m13 = Do_13;
  Do->m20 = D_m20;
  Do->m21 = D_m21;
  Do->m22 = D_m22;
  Do->m23 = Do_23;
  Do_bound->m00 = 0.0;
  Do_bound->m01 = 0.0;
  Do_bound->m02 = 0.0;
  Do_bound->m03 = Do_03_bound;
  Do_bound->m10 = 0.0;
  Do_bound->m11 = 0.0;
  Do_bound->m12 = 0.0;
  Do_bound->m13 = Do_13_bound;
  Do_bound->m20 = 0.0;
  Do_bound->m21 = 0.0;
  Do_bound->m22 = 0.0;
  Do_bound->m23 = Do_23_bound;
}

/* Do = D^-1 [I | t] = [R^T | R^T (t - t_D)]; |error of Do| <= Do_bound unless inf or NaN.
   D, Do, Do_bound: displacement [R | t], R rotation, t in m; t: vector.
   21 mul, 18 add, 12 abs. */
static inline void ksl_product_dinvdt_certified(const ksl_SE3_t *D, const ksl_vec3_t *t,
    ksl_SE3_t *Do, ksl_SE3_t *Do_bound) {
  const double p_0 = t->x - D->m03, p_1 = t->y - D->m13, p_2 = t->z - D->m23;
  const double Do_03 = KSL_MUL(D->m00, p_0) + KSL_MUL(D->m10, p_1) + KSL_MUL(D->m20, p_2),
      Do_13 = KSL_MUL(D->m01, p_0) + KSL_MUL(D->m11, p_1) + KSL_MUL(D->m21, p_2),
      Do_23 = KSL_MUL(D->m02, p_0) + KSL_MUL(D->m12, p_1) + KSL_MUL(D->m22, p_2);
  const double p_0_abs = fabs(p_0), p_1_abs = fabs(p_1), p_2_abs = fabs(p_2),
      Do_03_size = KSL_MUL(fabs(D->m00), p_0_abs) + KSL_MUL(fabs(D->m10), p_1_abs)
          + KSL_MUL(fabs(D->m20), p_2_abs);
  const double Do_13_size = KSL_MUL(fabs(D->m01), p_0_abs) + KSL_MUL(fabs(D->m11), p_1_abs)
          + KSL_MUL(fabs(D->m21), p_2_abs),
      Do_23_size = KSL_MUL(fabs(D->m02), p_0_abs) + KSL_MUL(fabs(D->m12), p_1_abs)
          + KSL_MUL(fabs(D->m22), p_2_abs);
  const double Do_03_bound = KSL_MUL(4.440892098500628e-16, Do_03_size + 2.004168360008973e-292),
      Do_13_bound = KSL_MUL(4.440892098500628e-16, Do_13_size + 2.004168360008973e-292),
      Do_23_bound = KSL_MUL(4.440892098500628e-16, Do_23_size + 2.004168360008973e-292);
  const double D_m00 = D->m00;
  const double D_m10 = D->m10;
  const double D_m20 = D->m20;
  const double D_m01 = D->m01;
  const double D_m11 = D->m11;
  const double D_m21 = D->m21;
  const double D_m02 = D->m02;
  const double D_m12 = D->m12;
  const double D_m22 = D->m22;
  Do->m00 = D_m00;
  Do->m01 = D_m10;
  Do->m02 = D_m20;
  Do->m03 = Do_03;
  Do->m10 = D_m01;
  Do->m11 = D_m11;
  Do->m12 = D_m21;
  Do->m13 = Do_13;
  Do->m20 = D_m02;
  Do->m21 = D_m12;
  Do->m22 = D_m22;
  Do->m23 = Do_23;
  Do_bound->m00 = 0.0;
  Do_bound->m01 = 0.0;
  Do_bound->m02 = 0.0;
  Do_bound->m03 = Do_03_bound;
  Do_bound->m10 = 0.0;
  Do_bound->m11 = 0.0;
  Do_bound->m12 = 0.0;
  Do_bound->m13 = Do_13_bound;
  Do_bound->m20 = 0.0;
  Do_bound->m21 = 0.0;
  Do_bound->m22 = 0.0;
  Do_bound->m23 = Do_23_bound;
}

/* vo = R (k e_x); |error of vo| <= vo_bound unless inf or NaN.
   R: rotation or other 3×3 matrix; k: number; vo, vo_bound: vector.
   6 mul, 3 add, 3 abs. */
static inline void ksl_product_drvtx_certified(const ksl_mat3x3_t *R, const double k,
    ksl_vec3_t *vo, ksl_vec3_t *vo_bound) {
  const double vo_0 = KSL_MUL(R->m00, k), vo_1 = KSL_MUL(R->m10, k), vo_2 = KSL_MUL(R->m20, k);
  const double vo_0_bound = KSL_MUL(1.1102230246251568e-16, fabs(vo_0) + 2.004168360008973e-292),
      vo_1_bound = KSL_MUL(1.1102230246251568e-16, fabs(vo_1) + 2.004168360008973e-292),
      vo_2_bound = KSL_MUL(1.1102230246251568e-16, fabs(vo_2) + 2.004168360008973e-292);
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
  vo_bound->x = vo_0_bound;
  vo_bound->y = vo_1_bound;
  vo_bound->z = vo_2_bound;
}

/* Ro = R R_x(θ), dc = (sin θ, cos θ); |error of Ro| <= Ro_bound unless inf or NaN.
   R, Ro, Ro_bound: rotation or other 3×3 matrix; dc: (sin θ, cos θ).
   18 mul, 18 add, 12 abs. */
static inline void ksl_product_drdrx_certified(const ksl_mat3x3_t *R, const double dc[2],
    ksl_mat3x3_t *Ro, ksl_mat3x3_t *Ro_bound) {
  const double Ro_01a = KSL_MUL(R->m01, dc[1]), Ro_01b = KSL_MUL(R->m02, dc[0]),
      Ro_01 = Ro_01a + Ro_01b;
  const double Ro_02a = KSL_MUL(R->m02, dc[1]), Ro_02b = KSL_MUL(R->m01, dc[0]),
      Ro_02 = Ro_02a - Ro_02b;
  const double Ro_11a = KSL_MUL(R->m11, dc[1]), Ro_11b = KSL_MUL(R->m12, dc[0]),
      Ro_11 = Ro_11a + Ro_11b;
  const double Ro_12a = KSL_MUL(R->m12, dc[1]), Ro_12b = KSL_MUL(R->m11, dc[0]),
      Ro_12 = Ro_12a - Ro_12b;
  const double Ro_21a = KSL_MUL(R->m21, dc[1]), Ro_21b = KSL_MUL(R->m22, dc[0]),
      Ro_21 = Ro_21a + Ro_21b;
  const double Ro_22a = KSL_MUL(R->m22, dc[1]), Ro_22b = KSL_MUL(R->m21, dc[0]),
      Ro_22 = Ro_22a - Ro_22b;
  const double Ro_01_size = fabs(Ro_01a) + fabs(Ro_01b), Ro_02_size = fabs(Ro_02a) + fabs(Ro_02b),
      Ro_11_size = fabs(Ro_11a) + fabs(Ro_11b), Ro_12_size = fabs(Ro_12a) + fabs(Ro_12b),
      Ro_21_size = fabs(Ro_21a) + fabs(Ro_21b), Ro_22_size = fabs(Ro_22a) + fabs(Ro_22b);
  const double Ro_01_bound = KSL_MUL(2.2204460492503136e-16, Ro_01_size + 2.004168360008973e-292),
      Ro_02_bound = KSL_MUL(2.2204460492503136e-16, Ro_02_size + 2.004168360008973e-292),
      Ro_11_bound = KSL_MUL(2.2204460492503136e-16, Ro_11_size + 2.004168360008973e-292),
      Ro_12_bound = KSL_MUL(2.2204460492503136e-16, Ro_12_size + 2.004168360008973e-292),
      Ro_21_bound = KSL_MUL(2.2204460492503136e-16, Ro_21_size + 2.004168360008973e-292),
      Ro_22_bound = KSL_MUL(2.2204460492503136e-16, Ro_22_size + 2.004168360008973e-292);
  const double R_m00 = R->m00;
  const double R_m10 = R->m10;
  const double R_m20 = R->m20;
  Ro->m00 = R_m00;
  Ro->m01 = Ro_01;
  Ro->m02 = Ro_02;
  Ro->m10 = R_m10;
  Ro->m11 = Ro_11;
  Ro->m12 = Ro_12;
  Ro->m20 = R_m20;
  Ro->m21 = Ro_21;
  Ro->m22 = Ro_22;
  Ro_bound->m00 = 0.0;
  Ro_bound->m01 = Ro_01_bound;
  Ro_bound->m02 = Ro_02_bound;
  Ro_bound->m10 = 0.0;
  Ro_bound->m11 = Ro_11_bound;
  Ro_bound->m12 = Ro_12_bound;
  Ro_bound->m20 = 0.0;
  Ro_bound->m21 = Ro_21_bound;
  Ro_bound->m22 = Ro_22_bound;
}

/* Do = D [R_x(θ) | 0], dc = (sin θ, cos θ); |error of Do| <= Do_bound unless inf or NaN.
   D, Do, Do_bound: displacement [R | t], R rotation, t in m; dc: (sin θ, cos θ).
   18 mul, 18 add, 12 abs. */
static inline void ksl_product_ddrx_certified(const ksl_SE3_t *D, const double dc[2],
    ksl_SE3_t *Do, ksl_SE3_t *Do_bound) {
  const double Do_01a = KSL_MUL(D->m01, dc[1]), Do_01b = KSL_MUL(D->m02, dc[0]),
      Do_01 = Do_01a + Do_01b;
  const double Do_02a = KSL_MUL(D->m02, dc[1]), Do_02b = KSL_MUL(D->m01, dc[0]),
      Do_02 = Do_02a - Do_02b;
  const double Do_11a = KSL_MUL(D->m11, dc[1]), Do_11b = KSL_MUL(D->m12, dc[0]),
      Do_11 = Do_11a + Do_11b;
  const double Do_12a = KSL_MUL(D->m12, dc[1]), Do_12b = KSL_MUL(D->m11, dc[0]),
      Do_12 = Do_12a - Do_12b;
  const double Do_21a = KSL_MUL(D->m21, dc[1]), Do_21b = KSL_MUL(D->m22, dc[0]),
      Do_21 = Do_21a + Do_21b;
  const double Do_22a = KSL_MUL(D->m22, dc[1]), Do_22b = KSL_MUL(D->m21, dc[0]),
      Do_22 = Do_22a - Do_22b;
  const double Do_01_size = fabs(Do_01a) + fabs(Do_01b), Do_02_size = fabs(Do_02a) + fabs(Do_02b),
      Do_11_size = fabs(Do_11a) + fabs(Do_11b), Do_12_size = fabs(Do_12a) + fabs(Do_12b),
      Do_21_size = fabs(Do_21a) + fabs(Do_21b), Do_22_size = fabs(Do_22a) + fabs(Do_22b);
  const double Do_01_bound = KSL_MUL(2.2204460492503136e-16, Do_01_size + 2.004168360008973e-292),
      Do_02_bound = KSL_MUL(2.2204460492503136e-16, Do_02_size + 2.004168360008973e-292),
      Do_11_bound = KSL_MUL(2.2204460492503136e-16, Do_11_size + 2.004168360008973e-292),
      Do_12_bound = KSL_MUL(2.2204460492503136e-16, Do_12_size + 2.004168360008973e-292),
      Do_21_bound = KSL_MUL(2.2204460492503136e-16, Do_21_size + 2.004168360008973e-292),
      Do_22_bound = KSL_MUL(2.2204460492503136e-16, Do_22_size + 2.004168360008973e-292);
  const double D_m00 = D->m00;
  const double D_m03 = D->m03;
  const double D_m10 = D->m10;
  const double D_m13 = D->m13;
  const double D_m20 = D->m20;
  const double D_m23 = D->m23;
  Do->m00 = D_m00;
  Do->m01 = Do_01;
  Do->m02 = Do_02;
  Do->m03 = D_m03;
  Do->m10 = D_m10;
  Do->m11 = Do_11;
  Do->m12 = Do_12;
  Do->m13 = D_m13;
  Do->m20 = D_m20;
  Do->m21 = Do_21;
  Do->m22 = Do_22;
  Do->m23 = D_m23;
  Do_bound->m00 = 0.0;
  Do_bound->m01 = Do_01_bound;
  Do_bound->m02 = Do_02_bound;
  Do_bound->m03 = 0.0;
  Do_bound->m10 = 0.0;
  Do_bound->m11 = Do_11_bound;
  Do_bound->m12 = Do_12_bound;
  Do_bound->m13 = 0.0;
  Do_bound->m20 = 0.0;
  Do_bound->m21 = Do_21_bound;
  Do_bound->m22 = Do_22_bound;
  Do_bound->m23 = 0.0;
}

/* Do = D [I | k e_x]; |error of Do| <= Do_bound unless inf or NaN.
   D, Do, Do_bound: displacement [R | t], R rotation, t in m; k: number.
   6 mul, 9 add, 6 abs. */
static inline void ksl_product_ddtx_certified(const ksl_SE3_t *D, const double k, ksl_SE3_t *Do,
    ksl_SE3_t *Do_bound) {
  const double Do_03a = KSL_MUL(D->m00, k), Do_03 = Do_03a + D->m03;
  const double Do_13a = KSL_MUL(D->m10, k), Do_13 = Do_13a + D->m13;
  const double Do_23a = KSL_MUL(D->m20, k), Do_23 = Do_23a + D->m23;
  const double Do_03_size = fabs(Do_03a) + fabs(D->m03), Do_13_size = fabs(Do_13a) + fabs(D->m13),
      Do_23_size = fabs(Do_23a) + fabs(D->m23);
  const double Do_03_bound = KSL_MUL(2.2204460492503136e-16, Do_03_size + 2.004168360008973e-292),
      Do_13_bound = KSL_MUL(2.2204460492503136e-16, Do_13_size + 2.004168360008973e-292),
      Do_23_bound = KSL_MUL(2.2204460492503136e-16, Do_23_size + 2.004168360008973e-292);
  const double D_m00 = D->m00;
  const double D_m01 = D->m01;
  const double D_m02 = D->m02;
  const double D_m10 = D->m10;
  const double D_m11 = D->m11;
  const double D_m12 = D->m12;
  const double D_m20 = D->m20;
  const double D_m21 = D->m21;
  const double D_m22 = D->m22;
  Do->m00 = D_m00;
  Do->m01 = D_m01;
  Do->m02 = D_m02;
  Do->m03 = Do_03;
  Do->m10 = D_m10;
  Do->m11 = D_m11;
  Do->m12 = D_m12;
  Do->m13 = Do_13;
  Do->m20 = D_m20;
  Do->m21 = D_m21;
  Do->m22 = D_m22;
  Do->m23 = Do_23;
  Do_bound->m00 = 0.0;
  Do_bound->m01 = 0.0;
  Do_bound->m02 = 0.0;
  Do_bound->m03 = Do_03_bound;
  Do_bound->m10 = 0.0;
  Do_bound->m11 = 0.0;
  Do_bound->m12 = 0.0;
  Do_bound->m13 = Do_13_bound;
  Do_bound->m20 = 0.0;
  Do_bound->m21 = 0.0;
  Do_bound->m22 = 0.0;
  Do_bound->m23 = Do_23_bound;
}

/* vo = R (-k e_x); |error of vo| <= vo_bound unless inf or NaN.
   R: rotation or other 3×3 matrix; k: number; vo, vo_bound: vector.
   6 mul, 3 add, 3 neg, 3 abs. */
static inline void ksl_product_drvtxinv_certified(const ksl_mat3x3_t *R, const double k,
    ksl_vec3_t *vo, ksl_vec3_t *vo_bound) {
  const double vo_0a = KSL_MUL(R->m00, k), vo_0 = -vo_0a;
  const double vo_1a = KSL_MUL(R->m10, k), vo_1 = -vo_1a;
  const double vo_2a = KSL_MUL(R->m20, k), vo_2 = -vo_2a;
  const double vo_0a_bound = KSL_MUL(1.1102230246251568e-16, fabs(vo_0a) + 2.004168360008973e-292);
  const double vo_1a_bound = KSL_MUL(1.1102230246251568e-16, fabs(vo_1a) + 2.004168360008973e-292);
  const double vo_2a_bound = KSL_MUL(1.1102230246251568e-16, fabs(vo_2a) + 2.004168360008973e-292);
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
  vo_bound->x = vo_0a_bound;
  vo_bound->y = vo_1a_bound;
  vo_bound->z = vo_2a_bound;
}

/* Ro = R R_x(-θ), dc = (sin θ, cos θ); |error of Ro| <= Ro_bound unless inf or NaN.
   R, Ro, Ro_bound: rotation or other 3×3 matrix; dc: (sin θ, cos θ).
   18 mul, 18 add, 12 abs. */
static inline void ksl_product_drdrxinv_certified(const ksl_mat3x3_t *R, const double dc[2],
    ksl_mat3x3_t *Ro, ksl_mat3x3_t *Ro_bound) {
  const double Ro_01a = KSL_MUL(R->m01, dc[1]), Ro_01b = KSL_MUL(R->m02, dc[0]),
      Ro_01 = Ro_01a - Ro_01b;
  const double Ro_02a = KSL_MUL(R->m01, dc[0]), Ro_02b = KSL_MUL(R->m02, dc[1]),
      Ro_02 = Ro_02a + Ro_02b;
  const double Ro_11a = KSL_MUL(R->m11, dc[1]), Ro_11b = KSL_MUL(R->m12, dc[0]),
      Ro_11 = Ro_11a - Ro_11b;
  const double Ro_12a = KSL_MUL(R->m11, dc[0]), Ro_12b = KSL_MUL(R->m12, dc[1]),
      Ro_12 = Ro_12a + Ro_12b;
  const double Ro_21a = KSL_MUL(R->m21, dc[1]), Ro_21b = KSL_MUL(R->m22, dc[0]),
      Ro_21 = Ro_21a - Ro_21b;
  const double Ro_22a = KSL_MUL(R->m21, dc[0]), Ro_22b = KSL_MUL(R->m22, dc[1]),
      Ro_22 = Ro_22a + Ro_22b;
  const double Ro_01_size = fabs(Ro_01a) + fabs(Ro_01b), Ro_02_size = fabs(Ro_02a) + fabs(Ro_02b),
      Ro_11_size = fabs(Ro_11a) + fabs(Ro_11b), Ro_12_size = fabs(Ro_12a) + fabs(Ro_12b),
      Ro_21_size = fabs(Ro_21a) + fabs(Ro_21b), Ro_22_size = fabs(Ro_22a) + fabs(Ro_22b);
  const double Ro_01_bound = KSL_MUL(2.2204460492503136e-16, Ro_01_size + 2.004168360008973e-292),
      Ro_02_bound = KSL_MUL(2.2204460492503136e-16, Ro_02_size + 2.004168360008973e-292),
      Ro_11_bound = KSL_MUL(2.2204460492503136e-16, Ro_11_size + 2.004168360008973e-292),
      Ro_12_bound = KSL_MUL(2.2204460492503136e-16, Ro_12_size + 2.004168360008973e-292),
      Ro_21_bound = KSL_MUL(2.2204460492503136e-16, Ro_21_size + 2.004168360008973e-292),
      Ro_22_bound = KSL_MUL(2.2204460492503136e-16, Ro_22_size + 2.004168360008973e-292);
  const double R_m00 = R->m00;
  const double R_m10 = R->m10;
  const double R_m20 = R->m20;
  Ro->m00 = R_m00;
  Ro->m01 = Ro_01;
  Ro->m02 = Ro_02;
  Ro->m10 = R_m10;
  Ro->m11 = Ro_11;
  Ro->m12 = Ro_12;
  Ro->m20 = R_m20;
  Ro->m21 = Ro_21;
  Ro->m22 = Ro_22;
  Ro_bound->m00 = 0.0;
  Ro_bound->m01 = Ro_01_bound;
  Ro_bound->m02 = Ro_02_bound;
  Ro_bound->m10 = 0.0;
  Ro_bound->m11 = Ro_11_bound;
  Ro_bound->m12 = Ro_12_bound;
  Ro_bound->m20 = 0.0;
  Ro_bound->m21 = Ro_21_bound;
  Ro_bound->m22 = Ro_22_bound;
}

/* Do = D [R_x(-θ) | 0], dc = (sin θ, cos θ); |error of Do| <= Do_bound unless inf or NaN.
   D, Do, Do_bound: displacement [R | t], R rotation, t in m; dc: (sin θ, cos θ).
   18 mul, 18 add, 12 abs. */
static inline void ksl_product_ddrxinv_certified(const ksl_SE3_t *D, const double dc[2],
    ksl_SE3_t *Do, ksl_SE3_t *Do_bound) {
  const double Do_01a = KSL_MUL(D->m01, dc[1]), Do_01b = KSL_MUL(D->m02, dc[0]),
      Do_01 = Do_01a - Do_01b;
  const double Do_02a = KSL_MUL(D->m01, dc[0]), Do_02b = KSL_MUL(D->m02, dc[1]),
      Do_02 = Do_02a + Do_02b;
  const double Do_11a = KSL_MUL(D->m11, dc[1]), Do_11b = KSL_MUL(D->m12, dc[0]),
      Do_11 = Do_11a - Do_11b;
  const double Do_12a = KSL_MUL(D->m11, dc[0]), Do_12b = KSL_MUL(D->m12, dc[1]),
      Do_12 = Do_12a + Do_12b;
  const double Do_21a = KSL_MUL(D->m21, dc[1]), Do_21b = KSL_MUL(D->m22, dc[0]),
      Do_21 = Do_21a - Do_21b;
  const double Do_22a = KSL_MUL(D->m21, dc[0]), Do_22b = KSL_MUL(D->m22, dc[1]),
      Do_22 = Do_22a + Do_22b;
  const double Do_01_size = fabs(Do_01a) + fabs(Do_01b), Do_02_size = fabs(Do_02a) + fabs(Do_02b),
      Do_11_size = fabs(Do_11a) + fabs(Do_11b), Do_12_size = fabs(Do_12a) + fabs(Do_12b),
      Do_21_size = fabs(Do_21a) + fabs(Do_21b), Do_22_size = fabs(Do_22a) + fabs(Do_22b);
  const double Do_01_bound = KSL_MUL(2.2204460492503136e-16, Do_01_size + 2.004168360008973e-292),
      Do_02_bound = KSL_MUL(2.2204460492503136e-16, Do_02_size + 2.004168360008973e-292),
      Do_11_bound = KSL_MUL(2.2204460492503136e-16, Do_11_size + 2.004168360008973e-292),
      Do_12_bound = KSL_MUL(2.2204460492503136e-16, Do_12_size + 2.004168360008973e-292),
      Do_21_bound = KSL_MUL(2.2204460492503136e-16, Do_21_size + 2.004168360008973e-292),
      Do_22_bound = KSL_MUL(2.2204460492503136e-16, Do_22_size + 2.004168360008973e-292);
  const double D_m00 = D->m00;
  const double D_m03 = D->m03;
  const double D_m10 = D->m10;
  const double D_m13 = D->m13;
  const double D_m20 = D->m20;
  const double D_m23 = D->m23;
  Do->m00 = D_m00;
  Do->m01 = Do_01;
  Do->m02 = Do_02;
  Do->m03 = D_m03;
  Do->m10 = D_m10;
  Do->m11 = Do_11;
  Do->m12 = Do_12;
  Do->m13 = D_m13;
  Do->m20 = D_m20;
  Do->m21 = Do_21;
  Do->m22 = Do_22;
  Do->m23 = D_m23;
  Do_bound->m00 = 0.0;
  Do_bound->m01 = Do_01_bound;
  Do_bound->m02 = Do_02_bound;
  Do_bound->m03 = 0.0;
  Do_bound->m10 = 0.0;
  Do_bound->m11 = Do_11_bound;
  Do_bound->m12 = Do_12_bound;
  Do_bound->m13 = 0.0;
  Do_bound->m20 = 0.0;
  Do_bound->m21 = Do_21_bound;
  Do_bound->m22 = Do_22_bound;
  Do_bound->m23 = 0.0;
}

/* Do = D [I | -k e_x]; |error of Do| <= Do_bound unless inf or NaN.
   D, Do, Do_bound: displacement [R | t], R rotation, t in m; k: number.
   6 mul, 9 add, 6 abs. */
static inline void ksl_product_ddtxinv_certified(const ksl_SE3_t *D, const double k,
    ksl_SE3_t *Do, ksl_SE3_t *Do_bound) {
  const double Do_03a = KSL_MUL(D->m00, k), Do_03 = D->m03 - Do_03a;
  const double Do_13a = KSL_MUL(D->m10, k), Do_13 = D->m13 - Do_13a;
  const double Do_23a = KSL_MUL(D->m20, k), Do_23 = D->m23 - Do_23a;
  const double Do_03_size = fabs(D->m03) + fabs(Do_03a), Do_13_size = fabs(D->m13) + fabs(Do_13a),
      Do_23_size = fabs(D->m23) + fabs(Do_23a);
  const double Do_03_bound = KSL_MUL(2.2204460492503136e-16, Do_03_size + 2.004168360008973e-292),
      Do_13_bound = KSL_MUL(2.2204460492503136e-16, Do_13_size + 2.004168360008973e-292),
      Do_23_bound = KSL_MUL(2.2204460492503136e-16, Do_23_size + 2.004168360008973e-292);
  const double D_m00 = D->m00;
  const double D_m01 = D->m01;
  const double D_m02 = D->m02;
  const double D_m10 = D->m10;
  const double D_m11 = D->m11;
  const double D_m12 = D->m12;
  const double D_m20 = D->m20;
  const double D_m21 = D->m21;
  const double D_m22 = D->m22;
  Do->m00 = D_m00;
  Do->m01 = D_m01;
  Do->m02 = D_m02;
  Do->m03 = Do_03;
  Do->m10 = D_m10;
  Do->m11 = D_m11;
  Do->m12 = D_m12;
  Do->m13 = Do_13;
  Do->m20 = D_m20;
  Do->m21 = D_m21;
  Do->m22 = D_m22;
  Do->m23 = Do_23;
  Do_bound->m00 = 0.0;
  Do_bound->m01 = 0.0;
  Do_bound->m02 = 0.0;
  Do_bound->m03 = Do_03_bound;
  Do_bound->m10 = 0.0;
  Do_bound->m11 = 0.0;
  Do_bound->m12 = 0.0;
  Do_bound->m13 = Do_13_bound;
  Do_bound->m20 = 0.0;
  Do_bound->m21 = 0.0;
  Do_bound->m22 = 0.0;
  Do_bound->m23 = Do_23_bound;
}

/* vo = R (k e_y); |error of vo| <= vo_bound unless inf or NaN.
   R: rotation or other 3×3 matrix; k: number; vo, vo_bound: vector.
   6 mul, 3 add, 3 abs. */
static inline void ksl_product_drvty_certified(const ksl_mat3x3_t *R, const double k,
    ksl_vec3_t *vo, ksl_vec3_t *vo_bound) {
  const double vo_0 = KSL_MUL(R->m01, k), vo_1 = KSL_MUL(R->m11, k), vo_2 = KSL_MUL(R->m21, k);
  const double vo_0_bound = KSL_MUL(1.1102230246251568e-16, fabs(vo_0) + 2.004168360008973e-292),
      vo_1_bound = KSL_MUL(1.1102230246251568e-16, fabs(vo_1) + 2.004168360008973e-292),
      vo_2_bound = KSL_MUL(1.1102230246251568e-16, fabs(vo_2) + 2.004168360008973e-292);
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
  vo_bound->x = vo_0_bound;
  vo_bound->y = vo_1_bound;
  vo_bound->z = vo_2_bound;
}

/* Ro = R R_y(θ), dc = (sin θ, cos θ); |error of Ro| <= Ro_bound unless inf or NaN.
   R, Ro, Ro_bound: rotation or other 3×3 matrix; dc: (sin θ, cos θ).
   18 mul, 18 add, 12 abs. */
static inline void ksl_product_drdry_certified(const ksl_mat3x3_t *R, const double dc[2],
    ksl_mat3x3_t *Ro, ksl_mat3x3_t *Ro_bound) {
  const double Ro_00a = KSL_MUL(R->m00, dc[1]), Ro_00b = KSL_MUL(R->m02, dc[0]),
      Ro_00 = Ro_00a - Ro_00b;
  const double Ro_02a = KSL_MUL(R->m00, dc[0]), Ro_02b = KSL_MUL(R->m02, dc[1]),
      Ro_02 = Ro_02a + Ro_02b;
  const double Ro_10a = KSL_MUL(R->m10, dc[1]), Ro_10b = KSL_MUL(R->m12, dc[0]),
      Ro_10 = Ro_10a - Ro_10b;
  const double Ro_12a = KSL_MUL(R->m10, dc[0]), Ro_12b = KSL_MUL(R->m12, dc[1]),
      Ro_12 = Ro_12a + Ro_12b;
  const double Ro_20a = KSL_MUL(R->m20, dc[1]), Ro_20b = KSL_MUL(R->m22, dc[0]),
      Ro_20 = Ro_20a - Ro_20b;
  const double Ro_22a = KSL_MUL(R->m20, dc[0]), Ro_22b = KSL_MUL(R->m22, dc[1]),
      Ro_22 = Ro_22a + Ro_22b;
  const double Ro_00_size = fabs(Ro_00a) + fabs(Ro_00b), Ro_02_size = fabs(Ro_02a) + fabs(Ro_02b),
      Ro_10_size = fabs(Ro_10a) + fabs(Ro_10b), Ro_12_size = fabs(Ro_12a) + fabs(Ro_12b),
      Ro_20_size = fabs(Ro_20a) + fabs(Ro_20b), Ro_22_size = fabs(Ro_22a) + fabs(Ro_22b);
  const double Ro_00_bound = KSL_MUL(2.2204460492503136e-16, Ro_00_size + 2.004168360008973e-292),
      Ro_02_bound = KSL_MUL(2.2204460492503136e-16, Ro_02_size + 2.004168360008973e-292),
      Ro_10_bound = KSL_MUL(2.2204460492503136e-16, Ro_10_size + 2.004168360008973e-292),
      Ro_12_bound = KSL_MUL(2.2204460492503136e-16, Ro_12_size + 2.004168360008973e-292),
      Ro_20_bound = KSL_MUL(2.2204460492503136e-16, Ro_20_size + 2.004168360008973e-292),
      Ro_22_bound = KSL_MUL(2.2204460492503136e-16, Ro_22_size + 2.004168360008973e-292);
  const double R_m01 = R->m01;
  const double R_m11 = R->m11;
  const double R_m21 = R->m21;
  Ro->m00 = Ro_00;
  Ro->m01 = R_m01;
  Ro->m02 = Ro_02;
  Ro->m10 = Ro_10;
  Ro->m11 = R_m11;
  Ro->m12 = Ro_12;
  Ro->m20 = Ro_20;
  Ro->m21 = R_m21;
  Ro->m22 = Ro_22;
  Ro_bound->m00 = Ro_00_bound;
  Ro_bound->m01 = 0.0;
  Ro_bound->m02 = Ro_02_bound;
  Ro_bound->m10 = Ro_10_bound;
  Ro_bound->m11 = 0.0;
  Ro_bound->m12 = Ro_12_bound;
  Ro_bound->m20 = Ro_20_bound;
  Ro_bound->m21 = 0.0;
  Ro_bound->m22 = Ro_22_bound;
}

/* Do = D [R_y(θ) | 0], dc = (sin θ, cos θ); |error of Do| <= Do_bound unless inf or NaN.
   D, Do, Do_bound: displacement [R | t], R rotation, t in m; dc: (sin θ, cos θ).
   18 mul, 18 add, 12 abs. */
static inline void ksl_product_ddry_certified(const ksl_SE3_t *D, const double dc[2],
    ksl_SE3_t *Do, ksl_SE3_t *Do_bound) {
  const double Do_00a = KSL_MUL(D->m00, dc[1]), Do_00b = KSL_MUL(D->m02, dc[0]),
      Do_00 = Do_00a - Do_00b;
  const double Do_02a = KSL_MUL(D->m00, dc[0]), Do_02b = KSL_MUL(D->m02, dc[1]),
      Do_02 = Do_02a + Do_02b;
  const double Do_10a = KSL_MUL(D->m10, dc[1]), Do_10b = KSL_MUL(D->m12, dc[0]),
      Do_10 = Do_10a - Do_10b;
  const double Do_12a = KSL_MUL(D->m10, dc[0]), Do_12b = KSL_MUL(D->m12, dc[1]),
      Do_12 = Do_12a + Do_12b;
  const double Do_20a = KSL_MUL(D->m20, dc[1]), Do_20b = KSL_MUL(D->m22, dc[0]),
      Do_20 = Do_20a - Do_20b;
  const double Do_22a = KSL_MUL(D->m20, dc[0]), Do_22b = KSL_MUL(D->m22, dc[1]),
      Do_22 = Do_22a + Do_22b;
  const double Do_00_size = fabs(Do_00a) + fabs(Do_00b), Do_02_size = fabs(Do_02a) + fabs(Do_02b),
      Do_10_size = fabs(Do_10a) + fabs(Do_10b), Do_12_size = fabs(Do_12a) + fabs(Do_12b),
      Do_20_size = fabs(Do_20a) + fabs(Do_20b), Do_22_size = fabs(Do_22a) + fabs(Do_22b);
  const double Do_00_bound = KSL_MUL(2.2204460492503136e-16, Do_00_size + 2.004168360008973e-292),
      Do_02_bound = KSL_MUL(2.2204460492503136e-16, Do_02_size + 2.004168360008973e-292),
      Do_10_bound = KSL_MUL(2.2204460492503136e-16, Do_10_size + 2.004168360008973e-292),
      Do_12_bound = KSL_MUL(2.2204460492503136e-16, Do_12_size + 2.004168360008973e-292),
      Do_20_bound = KSL_MUL(2.2204460492503136e-16, Do_20_size + 2.004168360008973e-292),
      Do_22_bound = KSL_MUL(2.2204460492503136e-16, Do_22_size + 2.004168360008973e-292);
  const double D_m01 = D->m01;
  const double D_m03 = D->m03;
  const double D_m11 = D->m11;
  const double D_m13 = D->m13;
  const double D_m21 = D->m21;
  const double D_m23 = D->m23;
  Do->m00 = Do_00;
  Do->m01 = D_m01;
  Do->m02 = Do_02;
  Do->m03 = D_m03;
  Do->m10 = Do_10;
  Do->m11 = D_m11;
  Do->m12 = Do_12;
  Do->m13 = D_m13;
  Do->m20 = Do_20;
  Do->m21 = D_m21;
  Do->m22 = Do_22;
  Do->m23 = D_m23;
  Do_bound->m00 = Do_00_bound;
  Do_bound->m01 = 0.0;
  Do_bound->m02 = Do_02_bound;
  Do_bound->m03 = 0.0;
  Do_bound->m10 = Do_10_bound;
  Do_bound->m11 = 0.0;
  Do_bound->m12 = Do_12_bound;
  Do_bound->m13 = 0.0;
  Do_bound->m20 = Do_20_bound;
  Do_bound->m21 = 0.0;
  Do_bound->m22 = Do_22_bound;
  Do_bound->m23 = 0.0;
}

/* Do = D [I | k e_y]; |error of Do| <= Do_bound unless inf or NaN.
   D, Do, Do_bound: displacement [R | t], R rotation, t in m; k: number.
   6 mul, 9 add, 6 abs. */
static inline void ksl_product_ddty_certified(const ksl_SE3_t *D, const double k, ksl_SE3_t *Do,
    ksl_SE3_t *Do_bound) {
  const double Do_03a = KSL_MUL(D->m01, k), Do_03 = Do_03a + D->m03;
  const double Do_13a = KSL_MUL(D->m11, k), Do_13 = Do_13a + D->m13;
  const double Do_23a = KSL_MUL(D->m21, k), Do_23 = Do_23a + D->m23;
  const double Do_03_size = fabs(Do_03a) + fabs(D->m03), Do_13_size = fabs(Do_13a) + fabs(D->m13),
      Do_23_size = fabs(Do_23a) + fabs(D->m23);
  const double Do_03_bound = KSL_MUL(2.2204460492503136e-16, Do_03_size + 2.004168360008973e-292),
      Do_13_bound = KSL_MUL(2.2204460492503136e-16, Do_13_size + 2.004168360008973e-292),
      Do_23_bound = KSL_MUL(2.2204460492503136e-16, Do_23_size + 2.004168360008973e-292);
  const double D_m00 = D->m00;
  const double D_m01 = D->m01;
  const double D_m02 = D->m02;
  const double D_m10 = D->m10;
  const double D_m11 = D->m11;
  const double D_m12 = D->m12;
  const double D_m20 = D->m20;
  const double D_m21 = D->m21;
  const double D_m22 = D->m22;
  Do->m00 = D_m00;
  Do->m01 = D_m01;
  Do->m02 = D_m02;
  Do->m03 = Do_03;
  Do->m10 = D_m10;
  Do->m11 = D_m11;
  Do->m12 = D_m12;
  Do->m13 = Do_13;
  Do->m20 = D_m20;
  Do->m21 = D_m21;
  Do->m22 = D_m22;
  Do->m23 = Do_23;
  Do_bound->m00 = 0.0;
  Do_bound->m01 = 0.0;
  Do_bound->m02 = 0.0;
  Do_bound->m03 = Do_03_bound;
  Do_bound->m10 = 0.0;
  Do_bound->m11 = 0.0;
  Do_bound->m12 = 0.0;
  Do_bound->m13 = Do_13_bound;
  Do_bound->m20 = 0.0;
  Do_bound->m21 = 0.0;
  Do_bound->m22 = 0.0;
  Do_bound->m23 = Do_23_bound;
}

/* vo = R (-k e_y); |error of vo| <= vo_bound unless inf or NaN.
   R: rotation or other 3×3 matrix; k: number; vo, vo_bound: vector.
   6 mul, 3 add, 3 neg, 3 abs. */
static inline void ksl_product_drvtyinv_certified(const ksl_mat3x3_t *R, const double k,
    ksl_vec3_t *vo, ksl_vec3_t *vo_bound) {
  const double vo_0a = KSL_MUL(R->m01, k), vo_0 = -vo_0a;
  const double vo_1a = KSL_MUL(R->m11, k), vo_1 = -vo_1a;
  const double vo_2a = KSL_MUL(R->m21, k), vo_2 = -vo_2a;
  const double vo_0a_bound = KSL_MUL(1.1102230246251568e-16, fabs(vo_0a) + 2.004168360008973e-292);
  const double vo_1a_bound = KSL_MUL(1.1102230246251568e-16, fabs(vo_1a) + 2.004168360008973e-292);
  const double vo_2a_bound = KSL_MUL(1.1102230246251568e-16, fabs(vo_2a) + 2.004168360008973e-292);
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
  vo_bound->x = vo_0a_bound;
  vo_bound->y = vo_1a_bound;
  vo_bound->z = vo_2a_bound;
}

/* Ro = R R_y(-θ), dc = (sin θ, cos θ); |error of Ro| <= Ro_bound unless inf or NaN.
   R, Ro, Ro_bound: rotation or other 3×3 matrix; dc: (sin θ, cos θ).
   18 mul, 18 add, 12 abs. */
static inline void ksl_product_drdryinv_certified(const ksl_mat3x3_t *R, const double dc[2],
    ksl_mat3x3_t *Ro, ksl_mat3x3_t *Ro_bound) {
  const double Ro_00a = KSL_MUL(R->m00, dc[1]), Ro_00b = KSL_MUL(R->m02, dc[0]),
      Ro_00 = Ro_00a + Ro_00b;
  const double Ro_02a = KSL_MUL(R->m02, dc[1]), Ro_02b = KSL_MUL(R->m00, dc[0]),
      Ro_02 = Ro_02a - Ro_02b;
  const double Ro_10a = KSL_MUL(R->m10, dc[1]), Ro_10b = KSL_MUL(R->m12, dc[0]),
      Ro_10 = Ro_10a + Ro_10b;
  const double Ro_12a = KSL_MUL(R->m12, dc[1]), Ro_12b = KSL_MUL(R->m10, dc[0]),
      Ro_12 = Ro_12a - Ro_12b;
  const double Ro_20a = KSL_MUL(R->m20, dc[1]), Ro_20b = KSL_MUL(R->m22, dc[0]),
      Ro_20 = Ro_20a + Ro_20b;
  const double Ro_22a = KSL_MUL(R->m22, dc[1]), Ro_22b = KSL_MUL(R->m20, dc[0]),
      Ro_22 = Ro_22a - Ro_22b;
  const double Ro_00_size = fabs(Ro_00a) + fabs(Ro_00b), Ro_02_size = fabs(Ro_02a) + fabs(Ro_02b),
      Ro_10_size = fabs(Ro_10a) + fabs(Ro_10b), Ro_12_size = fabs(Ro_12a) + fabs(Ro_12b),
      Ro_20_size = fabs(Ro_20a) + fabs(Ro_20b), Ro_22_size = fabs(Ro_22a) + fabs(Ro_22b);
  const double Ro_00_bound = KSL_MUL(2.2204460492503136e-16, Ro_00_size + 2.004168360008973e-292),
      Ro_02_bound = KSL_MUL(2.2204460492503136e-16, Ro_02_size + 2.004168360008973e-292),
      Ro_10_bound = KSL_MUL(2.2204460492503136e-16, Ro_10_size + 2.004168360008973e-292),
      Ro_12_bound = KSL_MUL(2.2204460492503136e-16, Ro_12_size + 2.004168360008973e-292),
      Ro_20_bound = KSL_MUL(2.2204460492503136e-16, Ro_20_size + 2.004168360008973e-292),
      Ro_22_bound = KSL_MUL(2.2204460492503136e-16, Ro_22_size + 2.004168360008973e-292);
  const double R_m01 = R->m01;
  const double R_m11 = R->m11;
  const double R_m21 = R->m21;
  Ro->m00 = Ro_00;
  Ro->m01 = R_m01;
  Ro->m02 = Ro_02;
  Ro->m10 = Ro_10;
  Ro->m11 = R_m11;
  Ro->m12 = Ro_12;
  Ro->m20 = Ro_20;
  Ro->m21 = R_m21;
  Ro->m22 = Ro_22;
  Ro_bound->m00 = Ro_00_bound;
  Ro_bound->m01 = 0.0;
  Ro_bound->m02 = Ro_02_bound;
  Ro_bound->m10 = Ro_10_bound;
  Ro_bound->m11 = 0.0;
  Ro_bound->m12 = Ro_12_bound;
  Ro_bound->m20 = Ro_20_bound;
  Ro_bound->m21 = 0.0;
  Ro_bound->m22 = Ro_22_bound;
}

/* Do = D [R_y(-θ) | 0], dc = (sin θ, cos θ); |error of Do| <= Do_bound unless inf or NaN.
   D, Do, Do_bound: displacement [R | t], R rotation, t in m; dc: (sin θ, cos θ).
   18 mul, 18 add, 12 abs. */
static inline void ksl_product_ddryinv_certified(const ksl_SE3_t *D, const double dc[2],
    ksl_SE3_t *Do, ksl_SE3_t *Do_bound) {
  const double Do_00a = KSL_MUL(D->m00, dc[1]), Do_00b = KSL_MUL(D->m02, dc[0]),
      Do_00 = Do_00a + Do_00b;
  const double Do_02a = KSL_MUL(D->m02, dc[1]), Do_02b = KSL_MUL(D->m00, dc[0]),
      Do_02 = Do_02a - Do_02b;
  const double Do_10a = KSL_MUL(D->m10, dc[1]), Do_10b = KSL_MUL(D->m12, dc[0]),
      Do_10 = Do_10a + Do_10b;
  const double Do_12a = KSL_MUL(D->m12, dc[1]), Do_12b = KSL_MUL(D->m10, dc[0]),
      Do_12 = Do_12a - Do_12b;
  const double Do_20a = KSL_MUL(D->m20, dc[1]), Do_20b = KSL_MUL(D->m22, dc[0]),
      Do_20 = Do_20a + Do_20b;
  const double Do_22a = KSL_MUL(D->m22, dc[1]), Do_22b = KSL_MUL(D->m20, dc[0]),
      Do_22 = Do_22a - Do_22b;
  const double Do_00_size = fabs(Do_00a) + fabs(Do_00b), Do_02_size = fabs(Do_02a) + fabs(Do_02b),
      Do_10_size = fabs(Do_10a) + fabs(Do_10b), Do_12_size = fabs(Do_12a) + fabs(Do_12b),
      Do_20_size = fabs(Do_20a) + fabs(Do_20b), Do_22_size = fabs(Do_22a) + fabs(Do_22b);
  const double Do_00_bound = KSL_MUL(2.2204460492503136e-16, Do_00_size + 2.004168360008973e-292),
      Do_02_bound = KSL_MUL(2.2204460492503136e-16, Do_02_size + 2.004168360008973e-292),
      Do_10_bound = KSL_MUL(2.2204460492503136e-16, Do_10_size + 2.004168360008973e-292),
      Do_12_bound = KSL_MUL(2.2204460492503136e-16, Do_12_size + 2.004168360008973e-292),
      Do_20_bound = KSL_MUL(2.2204460492503136e-16, Do_20_size + 2.004168360008973e-292),
      Do_22_bound = KSL_MUL(2.2204460492503136e-16, Do_22_size + 2.004168360008973e-292);
  const double D_m01 = D->m01;
  const double D_m03 = D->m03;
  const double D_m11 = D->m11;
  const double D_m13 = D->m13;
  const double D_m21 = D->m21;
  const double D_m23 = D->m23;
  Do->m00 = Do_00;
  Do->m01 = D_m01;
  Do->m02 = Do_02;
  Do->m03 = D_m03;
  Do->m10 = Do_10;
  Do->m11 = D_m11;
  Do->m12 = Do_12;
  Do->m13 = D_m13;
  Do->m20 = Do_20;
  Do->m21 = D_m21;
  Do->m22 = Do_22;
  Do->m23 = D_m23;
  Do_bound->m00 = Do_00_bound;
  Do_bound->m01 = 0.0;
  Do_bound->m02 = Do_02_bound;
  Do_bound->m03 = 0.0;
  Do_bound->m10 = Do_10_bound;
  Do_bound->m11 = 0.0;
  Do_bound->m12 = Do_12_bound;
  Do_bound->m13 = 0.0;
  Do_bound->m20 = Do_20_bound;
  Do_bound->m21 = 0.0;
  Do_bound->m22 = Do_22_bound;
  Do_bound->m23 = 0.0;
}

/* Do = D [I | -k e_y]; |error of Do| <= Do_bound unless inf or NaN.
   D, Do, Do_bound: displacement [R | t], R rotation, t in m; k: number.
   6 mul, 9 add, 6 abs. */
static inline void ksl_product_ddtyinv_certified(const ksl_SE3_t *D, const double k,
    ksl_SE3_t *Do, ksl_SE3_t *Do_bound) {
  const double Do_03a = KSL_MUL(D->m01, k), Do_03 = D->m03 - Do_03a;
  const double Do_13a = KSL_MUL(D->m11, k), Do_13 = D->m13 - Do_13a;
  const double Do_23a = KSL_MUL(D->m21, k), Do_23 = D->m23 - Do_23a;
  const double Do_03_size = fabs(D->m03) + fabs(Do_03a), Do_13_size = fabs(D->m13) + fabs(Do_13a),
      Do_23_size = fabs(D->m23) + fabs(Do_23a);
  const double Do_03_bound = KSL_MUL(2.2204460492503136e-16, Do_03_size + 2.004168360008973e-292),
      Do_13_bound = KSL_MUL(2.2204460492503136e-16, Do_13_size + 2.004168360008973e-292),
      Do_23_bound = KSL_MUL(2.2204460492503136e-16, Do_23_size + 2.004168360008973e-292);
  const double D_m00 = D->m00;
  const double D_m01 = D->m01;
  const double D_m02 = D->m02;
  const double D_m10 = D->m10;
  const double D_m11 = D->m11;
  const double D_m12 = D->m12;
  const double D_m20 = D->m20;
  const double D_m21 = D->m21;
  const double D_m22 = D->m22;
  Do->m00 = D_m00;
  Do->m01 = D_m01;
  Do->m02 = D_m02;
  Do->m03 = Do_03;
  Do->m10 = D_m10;
  Do->m11 = D_m11;
  Do->m12 = D_m12;
  Do->m13 = Do_13;
  Do->m20 = D_m20;
  Do->m21 = D_m21;
  Do->m22 = D_m22;
  Do->m23 = Do_23;
  Do_bound->m00 = 0.0;
  Do_bound->m01 = 0.0;
  Do_bound->m02 = 0.0;
  Do_bound->m03 = Do_03_bound;
  Do_bound->m10 = 0.0;
  Do_bound->m11 = 0.0;
  Do_bound->m12 = 0.0;
  Do_bound->m13 = Do_13_bound;
  Do_bound->m20 = 0.0;
  Do_bound->m21 = 0.0;
  Do_bound->m22 = 0.0;
  Do_bound->m23 = Do_23_bound;
}

/* vo = R (k e_z); |error of vo| <= vo_bound unless inf or NaN.
   R: rotation or other 3×3 matrix; k: number; vo, vo_bound: vector.
   6 mul, 3 add, 3 abs. */
static inline void ksl_product_drvtz_certified(const ksl_mat3x3_t *R, const double k,
    ksl_vec3_t *vo, ksl_vec3_t *vo_bound) {
  const double vo_0 = KSL_MUL(R->m02, k), vo_1 = KSL_MUL(R->m12, k), vo_2 = KSL_MUL(R->m22, k);
  const double vo_0_bound = KSL_MUL(1.1102230246251568e-16, fabs(vo_0) + 2.004168360008973e-292),
      vo_1_bound = KSL_MUL(1.1102230246251568e-16, fabs(vo_1) + 2.004168360008973e-292),
      vo_2_bound = KSL_MUL(1.1102230246251568e-16, fabs(vo_2) + 2.004168360008973e-292);
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
  vo_bound->x = vo_0_bound;
  vo_bound->y = vo_1_bound;
  vo_bound->z = vo_2_bound;
}

/* Ro = R R_z(θ), dc = (sin θ, cos θ); |error of Ro| <= Ro_bound unless inf or NaN.
   R, Ro, Ro_bound: rotation or other 3×3 matrix; dc: (sin θ, cos θ).
   18 mul, 18 add, 12 abs. */
static inline void ksl_product_drdrz_certified(const ksl_mat3x3_t *R, const double dc[2],
    ksl_mat3x3_t *Ro, ksl_mat3x3_t *Ro_bound) {
  const double Ro_00a = KSL_MUL(R->m00, dc[1]), Ro_00b = KSL_MUL(R->m01, dc[0]),
      Ro_00 = Ro_00a + Ro_00b;
  const double Ro_01a = KSL_MUL(R->m01, dc[1]), Ro_01b = KSL_MUL(R->m00, dc[0]),
      Ro_01 = Ro_01a - Ro_01b;
  const double Ro_10a = KSL_MUL(R->m10, dc[1]), Ro_10b = KSL_MUL(R->m11, dc[0]),
      Ro_10 = Ro_10a + Ro_10b;
  const double Ro_11a = KSL_MUL(R->m11, dc[1]), Ro_11b = KSL_MUL(R->m10, dc[0]),
      Ro_11 = Ro_11a - Ro_11b;
  const double Ro_20a = KSL_MUL(R->m20, dc[1]), Ro_20b = KSL_MUL(R->m21, dc[0]),
      Ro_20 = Ro_20a + Ro_20b;
  const double Ro_21a = KSL_MUL(R->m21, dc[1]), Ro_21b = KSL_MUL(R->m20, dc[0]),
      Ro_21 = Ro_21a - Ro_21b;
  const double Ro_00_size = fabs(Ro_00a) + fabs(Ro_00b), Ro_01_size = fabs(Ro_01a) + fabs(Ro_01b),
      Ro_10_size = fabs(Ro_10a) + fabs(Ro_10b), Ro_11_size = fabs(Ro_11a) + fabs(Ro_11b),
      Ro_20_size = fabs(Ro_20a) + fabs(Ro_20b), Ro_21_size = fabs(Ro_21a) + fabs(Ro_21b);
  const double Ro_00_bound = KSL_MUL(2.2204460492503136e-16, Ro_00_size + 2.004168360008973e-292),
      Ro_01_bound = KSL_MUL(2.2204460492503136e-16, Ro_01_size + 2.004168360008973e-292),
      Ro_10_bound = KSL_MUL(2.2204460492503136e-16, Ro_10_size + 2.004168360008973e-292),
      Ro_11_bound = KSL_MUL(2.2204460492503136e-16, Ro_11_size + 2.004168360008973e-292),
      Ro_20_bound = KSL_MUL(2.2204460492503136e-16, Ro_20_size + 2.004168360008973e-292),
      Ro_21_bound = KSL_MUL(2.2204460492503136e-16, Ro_21_size + 2.004168360008973e-292);
  const double R_m02 = R->m02;
  const double R_m12 = R->m12;
  const double R_m22 = R->m22;
  Ro->m00 = Ro_00;
  Ro->m01 = Ro_01;
  Ro->m02 = R_m02;
  Ro->m10 = Ro_10;
  Ro->m11 = Ro_11;
  Ro->m12 = R_m12;
  Ro->m20 = Ro_20;
  Ro->m21 = Ro_21;
  Ro->m22 = R_m22;
  Ro_bound->m00 = Ro_00_bound;
  Ro_bound->m01 = Ro_01_bound;
  Ro_bound->m02 = 0.0;
  Ro_bound->m10 = Ro_10_bound;
  Ro_bound->m11 = Ro_11_bound;
  Ro_bound->m12 = 0.0;
  Ro_bound->m20 = Ro_20_bound;
  Ro_bound->m21 = Ro_21_bound;
  Ro_bound->m22 = 0.0;
}

/* Do = D [R_z(θ) | 0], dc = (sin θ, cos θ); |error of Do| <= Do_bound unless inf or NaN.
   D, Do, Do_bound: displacement [R | t], R rotation, t in m; dc: (sin θ, cos θ).
   18 mul, 18 add, 12 abs. */
static inline void ksl_product_ddrz_certified(const ksl_SE3_t *D, const double dc[2],
    ksl_SE3_t *Do, ksl_SE3_t *Do_bound) {
  const double Do_00a = KSL_MUL(D->m00, dc[1]), Do_00b = KSL_MUL(D->m01, dc[0]),
      Do_00 = Do_00a + Do_00b;
  const double Do_01a = KSL_MUL(D->m01, dc[1]), Do_01b = KSL_MUL(D->m00, dc[0]),
      Do_01 = Do_01a - Do_01b;
  const double Do_10a = KSL_MUL(D->m10, dc[1]), Do_10b = KSL_MUL(D->m11, dc[0]),
      Do_10 = Do_10a + Do_10b;
  const double Do_11a = KSL_MUL(D->m11, dc[1]), Do_11b = KSL_MUL(D->m10, dc[0]),
      Do_11 = Do_11a - Do_11b;
  const double Do_20a = KSL_MUL(D->m20, dc[1]), Do_20b = KSL_MUL(D->m21, dc[0]),
      Do_20 = Do_20a + Do_20b;
  const double Do_21a = KSL_MUL(D->m21, dc[1]), Do_21b = KSL_MUL(D->m20, dc[0]),
      Do_21 = Do_21a - Do_21b;
  const double Do_00_size = fabs(Do_00a) + fabs(Do_00b), Do_01_size = fabs(Do_01a) + fabs(Do_01b),
      Do_10_size = fabs(Do_10a) + fabs(Do_10b), Do_11_size = fabs(Do_11a) + fabs(Do_11b),
      Do_20_size = fabs(Do_20a) + fabs(Do_20b), Do_21_size = fabs(Do_21a) + fabs(Do_21b);
  const double Do_00_bound = KSL_MUL(2.2204460492503136e-16, Do_00_size + 2.004168360008973e-292),
      Do_01_bound = KSL_MUL(2.2204460492503136e-16, Do_01_size + 2.004168360008973e-292),
      Do_10_bound = KSL_MUL(2.2204460492503136e-16, Do_10_size + 2.004168360008973e-292),
      Do_11_bound = KSL_MUL(2.2204460492503136e-16, Do_11_size + 2.004168360008973e-292),
      Do_20_bound = KSL_MUL(2.2204460492503136e-16, Do_20_size + 2.004168360008973e-292),
      Do_21_bound = KSL_MUL(2.2204460492503136e-16, Do_21_size + 2.004168360008973e-292);
  const double D_m02 = D->m02;
  const double D_m03 = D->m03;
  const double D_m12 = D->m12;
  const double D_m13 = D->m13;
  const double D_m22 = D->m22;
  const double D_m23 = D->m23;
  Do->m00 = Do_00;
  Do->m01 = Do_01;
  Do->m02 = D_m02;
  Do->m03 = D_m03;
  Do->m10 = Do_10;
  Do->m11 = Do_11;
  Do->m12 = D_m12;
  Do->m13 = D_m13;
  Do->m20 = Do_20;
  Do->m21 = Do_21;
  Do->m22 = D_m22;
  Do->m23 = D_m23;
  Do_bound->m00 = Do_00_bound;
  Do_bound->m01 = Do_01_bound;
  Do_bound->m02 = 0.0;
  Do_bound->m03 = 0.0;
  Do_bound->m10 = Do_10_bound;
  Do_bound->m11 = Do_11_bound;
  Do_bound->m12 = 0.0;
  Do_bound->m13 = 0.0;
  Do_bound->m20 = Do_20_bound;
  Do_bound->m21 = Do_21_bound;
  Do_bound->m22 = 0.0;
  Do_bound->m23 = 0.0;
}

/* Do = D [I | k e_z]; |error of Do| <= Do_bound unless inf or NaN.
   D, Do, Do_bound: displacement [R | t], R rotation, t in m; k: number.
   6 mul, 9 add, 6 abs. */
static inline void ksl_product_ddtz_certified(const ksl_SE3_t *D, const double k, ksl_SE3_t *Do,
    ksl_SE3_t *Do_bound) {
  const double Do_03a = KSL_MUL(D->m02, k), Do_03 = Do_03a + D->m03;
  const double Do_13a = KSL_MUL(D->m12, k), Do_13 = Do_13a + D->m13;
  const double Do_23a = KSL_MUL(D->m22, k), Do_23 = Do_23a + D->m23;
  const double Do_03_size = fabs(Do_03a) + fabs(D->m03), Do_13_size = fabs(Do_13a) + fabs(D->m13),
      Do_23_size = fabs(Do_23a) + fabs(D->m23);
  const double Do_03_bound = KSL_MUL(2.2204460492503136e-16, Do_03_size + 2.004168360008973e-292),
      Do_13_bound = KSL_MUL(2.2204460492503136e-16, Do_13_size + 2.004168360008973e-292),
      Do_23_bound = KSL_MUL(2.2204460492503136e-16, Do_23_size + 2.004168360008973e-292);
  const double D_m00 = D->m00;
  const double D_m01 = D->m01;
  const double D_m02 = D->m02;
  const double D_m10 = D->m10;
  const double D_m11 = D->m11;
  const double D_m12 = D->m12;
  const double D_m20 = D->m20;
  const double D_m21 = D->m21;
  const double D_m22 = D->m22;
  Do->m00 = D_m00;
  Do->m01 = D_m01;
  Do->m02 = D_m02;
  Do->m03 = Do_03;
  Do->m10 = D_m10;
  Do->m11 = D_m11;
  Do->m12 = D_m12;
  Do->m13 = Do_13;
  Do->m20 = D_m20;
  Do->m21 = D_m21;
  Do->m22 = D_m22;
  Do->m23 = Do_23;
  Do_bound->m00 = 0.0;
  Do_bound->m01 = 0.0;
  Do_bound->m02 = 0.0;
  Do_bound->m03 = Do_03_bound;
  Do_bound->m10 = 0.0;
  Do_bound->m11 = 0.0;
  Do_bound->m12 = 0.0;
  Do_bound->m13 = Do_13_bound;
  Do_bound->m20 = 0.0;
  Do_bound->m21 = 0.0;
  Do_bound->m22 = 0.0;
  Do_bound->m23 = Do_23_bound;
}

/* vo = R (-k e_z); |error of vo| <= vo_bound unless inf or NaN.
   R: rotation or other 3×3 matrix; k: number; vo, vo_bound: vector.
   6 mul, 3 add, 3 neg, 3 abs. */
static inline void ksl_product_drvtzinv_certified(const ksl_mat3x3_t *R, const double k,
    ksl_vec3_t *vo, ksl_vec3_t *vo_bound) {
  const double vo_0a = KSL_MUL(R->m02, k), vo_0 = -vo_0a;
  const double vo_1a = KSL_MUL(R->m12, k), vo_1 = -vo_1a;
  const double vo_2a = KSL_MUL(R->m22, k), vo_2 = -vo_2a;
  const double vo_0a_bound = KSL_MUL(1.1102230246251568e-16, fabs(vo_0a) + 2.004168360008973e-292);
  const double vo_1a_bound = KSL_MUL(1.1102230246251568e-16, fabs(vo_1a) + 2.004168360008973e-292);
  const double vo_2a_bound = KSL_MUL(1.1102230246251568e-16, fabs(vo_2a) + 2.004168360008973e-292);
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
  vo_bound->x = vo_0a_bound;
  vo_bound->y = vo_1a_bound;
  vo_bound->z = vo_2a_bound;
}

/* Ro = R R_z(-θ), dc = (sin θ, cos θ); |error of Ro| <= Ro_bound unless inf or NaN.
   R, Ro, Ro_bound: rotation or other 3×3 matrix; dc: (sin θ, cos θ).
   18 mul, 18 add, 12 abs. */
static inline void ksl_product_drdrzinv_certified(const ksl_mat3x3_t *R, const double dc[2],
    ksl_mat3x3_t *Ro, ksl_mat3x3_t *Ro_bound) {
  const double Ro_00a = KSL_MUL(R->m00, dc[1]), Ro_00b = KSL_MUL(R->m01, dc[0]),
      Ro_00 = Ro_00a - Ro_00b;
  const double Ro_01a = KSL_MUL(R->m00, dc[0]), Ro_01b = KSL_MUL(R->m01, dc[1]),
      Ro_01 = Ro_01a + Ro_01b;
  const double Ro_10a = KSL_MUL(R->m10, dc[1]), Ro_10b = KSL_MUL(R->m11, dc[0]),
      Ro_10 = Ro_10a - Ro_10b;
  const double Ro_11a = KSL_MUL(R->m10, dc[0]), Ro_11b = KSL_MUL(R->m11, dc[1]),
      Ro_11 = Ro_11a + Ro_11b;
  const double Ro_20a = KSL_MUL(R->m20, dc[1]), Ro_20b = KSL_MUL(R->m21, dc[0]),
      Ro_20 = Ro_20a - Ro_20b;
  const double Ro_21a = KSL_MUL(R->m20, dc[0]), Ro_21b = KSL_MUL(R->m21, dc[1]),
      Ro_21 = Ro_21a + Ro_21b;
  const double Ro_00_size = fabs(Ro_00a) + fabs(Ro_00b), Ro_01_size = fabs(Ro_01a) + fabs(Ro_01b),
      Ro_10_size = fabs(Ro_10a) + fabs(Ro_10b), Ro_11_size = fabs(Ro_11a) + fabs(Ro_11b),
      Ro_20_size = fabs(Ro_20a) + fabs(Ro_20b), Ro_21_size = fabs(Ro_21a) + fabs(Ro_21b);
  const double Ro_00_bound = KSL_MUL(2.2204460492503136e-16, Ro_00_size + 2.004168360008973e-292),
      Ro_01_bound = KSL_MUL(2.2204460492503136e-16, Ro_01_size + 2.004168360008973e-292),
      Ro_10_bound = KSL_MUL(2.2204460492503136e-16, Ro_10_size + 2.004168360008973e-292),
      Ro_11_bound = KSL_MUL(2.2204460492503136e-16, Ro_11_size + 2.004168360008973e-292),
      Ro_20_bound = KSL_MUL(2.2204460492503136e-16, Ro_20_size + 2.004168360008973e-292),
      Ro_21_bound = KSL_MUL(2.2204460492503136e-16, Ro_21_size + 2.004168360008973e-292);
  const double R_m02 = R->m02;
  const double R_m12 = R->m12;
  const double R_m22 = R->m22;
  Ro->m00 = Ro_00;
  Ro->m01 = Ro_01;
  Ro->m02 = R_m02;
  Ro->m10 = Ro_10;
  Ro->m11 = Ro_11;
  Ro->m12 = R_m12;
  Ro->m20 = Ro_20;
  Ro->m21 = Ro_21;
  Ro->m22 = R_m22;
  Ro_bound->m00 = Ro_00_bound;
  Ro_bound->m01 = Ro_01_bound;
  Ro_bound->m02 = 0.0;
  Ro_bound->m10 = Ro_10_bound;
  Ro_bound->m11 = Ro_11_bound;
  Ro_bound->m12 = 0.0;
  Ro_bound->m20 = Ro_20_bound;
  Ro_bound->m21 = Ro_21_bound;
  Ro_bound->m22 = 0.0;
}

/* Do = D [R_z(-θ) | 0], dc = (sin θ, cos θ); |error of Do| <= Do_bound unless inf or NaN.
   D, Do, Do_bound: displacement [R | t], R rotation, t in m; dc: (sin θ, cos θ).
   18 mul, 18 add, 12 abs. */
static inline void ksl_product_ddrzinv_certified(const ksl_SE3_t *D, const double dc[2],
    ksl_SE3_t *Do, ksl_SE3_t *Do_bound) {
  const double Do_00a = KSL_MUL(D->m00, dc[1]), Do_00b = KSL_MUL(D->m01, dc[0]),
      Do_00 = Do_00a - Do_00b;
  const double Do_01a = KSL_MUL(D->m00, dc[0]), Do_01b = KSL_MUL(D->m01, dc[1]),
      Do_01 = Do_01a + Do_01b;
  const double Do_10a = KSL_MUL(D->m10, dc[1]), Do_10b = KSL_MUL(D->m11, dc[0]),
      Do_10 = Do_10a - Do_10b;
  const double Do_11a = KSL_MUL(D->m10, dc[0]), Do_11b = KSL_MUL(D->m11, dc[1]),
      Do_11 = Do_11a + Do_11b;
  const double Do_20a = KSL_MUL(D->m20, dc[1]), Do_20b = KSL_MUL(D->m21, dc[0]),
      Do_20 = Do_20a - Do_20b;
  const double Do_21a = KSL_MUL(D->m20, dc[0]), Do_21b = KSL_MUL(D->m21, dc[1]),
      Do_21 = Do_21a + Do_21b;
  const double Do_00_size = fabs(Do_00a) + fabs(Do_00b), Do_01_size = fabs(Do_01a) + fabs(Do_01b),
      Do_10_size = fabs(Do_10a) + fabs(Do_10b), Do_11_size = fabs(Do_11a) + fabs(Do_11b),
      Do_20_size = fabs(Do_20a) + fabs(Do_20b), Do_21_size = fabs(Do_21a) + fabs(Do_21b);
  const double Do_00_bound = KSL_MUL(2.2204460492503136e-16, Do_00_size + 2.004168360008973e-292),
      Do_01_bound = KSL_MUL(2.2204460492503136e-16, Do_01_size + 2.004168360008973e-292),
      Do_10_bound = KSL_MUL(2.2204460492503136e-16, Do_10_size + 2.004168360008973e-292),
      Do_11_bound = KSL_MUL(2.2204460492503136e-16, Do_11_size + 2.004168360008973e-292),
      Do_20_bound = KSL_MUL(2.2204460492503136e-16, Do_20_size + 2.004168360008973e-292),
      Do_21_bound = KSL_MUL(2.2204460492503136e-16, Do_21_size + 2.004168360008973e-292);
  const double D_m02 = D->m02;
  const double D_m03 = D->m03;
  const double D_m12 = D->m12;
  const double D_m13 = D->m13;
  const double D_m22 = D->m22;
  const double D_m23 = D->m23;
  Do->m00 = Do_00;
  Do->m01 = Do_01;
  Do->m02 = D_m02;
  Do->m03 = D_m03;
  Do->m10 = Do_10;
  Do->m11 = Do_11;
  Do->m12 = D_m12;
  Do->m13 = D_m13;
  Do->m20 = Do_20;
  Do->m21 = Do_21;
  Do->m22 = D_m22;
  Do->m23 = D_m23;
  Do_bound->m00 = Do_00_bound;
  Do_bound->m01 = Do_01_bound;
  Do_bound->m02 = 0.0;
  Do_bound->m03 = 0.0;
  Do_bound->m10 = Do_10_bound;
  Do_bound->m11 = Do_11_bound;
  Do_bound->m12 = 0.0;
  Do_bound->m13 = 0.0;
  Do_bound->m20 = Do_20_bound;
  Do_bound->m21 = Do_21_bound;
  Do_bound->m22 = 0.0;
  Do_bound->m23 = 0.0;
}

/* Do = D [I | -k e_z]; |error of Do| <= Do_bound unless inf or NaN.
   D, Do, Do_bound: displacement [R | t], R rotation, t in m; k: number.
   6 mul, 9 add, 6 abs. */
static inline void ksl_product_ddtzinv_certified(const ksl_SE3_t *D, const double k,
    ksl_SE3_t *Do, ksl_SE3_t *Do_bound) {
  const double Do_03a = KSL_MUL(D->m02, k), Do_03 = D->m03 - Do_03a;
  const double Do_13a = KSL_MUL(D->m12, k), Do_13 = D->m13 - Do_13a;
  const double Do_23a = KSL_MUL(D->m22, k), Do_23 = D->m23 - Do_23a;
  const double Do_03_size = fabs(D->m03) + fabs(Do_03a), Do_13_size = fabs(D->m13) + fabs(Do_13a),
      Do_23_size = fabs(D->m23) + fabs(Do_23a);
  const double Do_03_bound = KSL_MUL(2.2204460492503136e-16, Do_03_size + 2.004168360008973e-292),
      Do_13_bound = KSL_MUL(2.2204460492503136e-16, Do_13_size + 2.004168360008973e-292),
      Do_23_bound = KSL_MUL(2.2204460492503136e-16, Do_23_size + 2.004168360008973e-292);
  const double D_m00 = D->m00;
  const double D_m01 = D->m01;
  const double D_m02 = D->m02;
  const double D_m10 = D->m10;
  const double D_m11 = D->m11;
  const double D_m12 = D->m12;
  const double D_m20 = D->m20;
  const double D_m21 = D->m21;
  const double D_m22 = D->m22;
  Do->m00 = D_m00;
  Do->m01 = D_m01;
  Do->m02 = D_m02;
  Do->m03 = Do_03;
  Do->m10 = D_m10;
  Do->m11 = D_m11;
  Do->m12 = D_m12;
  Do->m13 = Do_13;
  Do->m20 = D_m20;
  Do->m21 = D_m21;
  Do->m22 = D_m22;
  Do->m23 = Do_23;
  Do_bound->m00 = 0.0;
  Do_bound->m01 = 0.0;
  Do_bound->m02 = 0.0;
  Do_bound->m03 = Do_03_bound;
  Do_bound->m10 = 0.0;
  Do_bound->m11 = 0.0;
  Do_bound->m12 = 0.0;
  Do_bound->m13 = Do_13_bound;
  Do_bound->m20 = 0.0;
  Do_bound->m21 = 0.0;
  Do_bound->m22 = 0.0;
  Do_bound->m23 = Do_23_bound;
}

/* vo = R v; |error of vo| <= vo_bound unless inf or NaN.
   R: rotation or other 3×3 matrix; v, vo, vo_bound: vector.
   12 mul, 15 add, 9 abs. */
static inline void ksl_product_drvf_certified(const ksl_mat3x3f_t *R, const ksl_vec3f_t *v,
    ksl_vec3f_t *vo, ksl_vec3f_t *vo_bound) {
  const float vo_0a = KSL_MULF(R->m00, v->x), vo_0b = KSL_MULF(R->m01, v->y),
      vo_0d = KSL_MULF(R->m02, v->z), vo_0 = vo_0a + vo_0b + vo_0d;
  const float vo_1a = KSL_MULF(R->m10, v->x), vo_1b = KSL_MULF(R->m11, v->y),
      vo_1d = KSL_MULF(R->m12, v->z), vo_1 = vo_1a + vo_1b + vo_1d;
  const float vo_2a = KSL_MULF(R->m20, v->x), vo_2b = KSL_MULF(R->m21, v->y),
      vo_2d = KSL_MULF(R->m22, v->z), vo_2 = vo_2a + vo_2b + vo_2d;
  const float vo_0_size = fabsf(vo_0a) + fabsf(vo_0b) + fabsf(vo_0d),
      vo_1_size = fabsf(vo_1a) + fabsf(vo_1b) + fabsf(vo_1d),
      vo_2_size = fabsf(vo_2a) + fabsf(vo_2b) + fabsf(vo_2d);
  const float vo_0_bound = KSL_MULF(1.7881396e-07f, vo_0_size + 1.9721523e-31f),
      vo_1_bound = KSL_MULF(1.7881396e-07f, vo_1_size + 1.9721523e-31f),
      vo_2_bound = KSL_MULF(1.7881396e-07f, vo_2_size + 1.9721523e-31f);
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
  vo_bound->x = vo_0_bound;
  vo_bound->y = vo_1_bound;
  vo_bound->z = vo_2_bound;
}

/* vo = R (-v); |error of vo| <= vo_bound unless inf or NaN.
   R: rotation or other 3×3 matrix; v, vo, vo_bound: vector.
   12 mul, 15 add, 3 neg, 9 abs. */
static inline void ksl_product_drvinvf_certified(const ksl_mat3x3f_t *R, const ksl_vec3f_t *v,
    ksl_vec3f_t *vo, ksl_vec3f_t *vo_bound) {
  const float vo_0a = KSL_MULF(R->m00, v->x), vo_0b = KSL_MULF(R->m01, v->y),
      vo_0d = KSL_MULF(R->m02, v->z), vo_0 = -(vo_0a + vo_0b + vo_0d);
  const float vo_1a = KSL_MULF(R->m10, v->x), vo_1b = KSL_MULF(R->m11, v->y),
      vo_1d = KSL_MULF(R->m12, v->z), vo_1 = -(vo_1a + vo_1b + vo_1d);
  const float vo_2a = KSL_MULF(R->m20, v->x), vo_2b = KSL_MULF(R->m21, v->y),
      vo_2d = KSL_MULF(R->m22, v->z), vo_2 = -(vo_2a + vo_2b + vo_2d);
  const float vo_0e_bound = KSL_MULF(1.7881396e-07f, fabsf(vo_0a) + fabsf(vo_0b) + fabsf(vo_0d)
          + 1.9721523e-31f);
  const float vo_1e_bound = KSL_MULF(1.7881396e-07f, fabsf(vo_1a) + fabsf(vo_1b) + fabsf(vo_1d)
          + 1.9721523e-31f);
  const float vo_2e_bound = KSL_MULF(1.7881396e-07f, fabsf(vo_2a) + fabsf(vo_2b) + fabsf(vo_2d)
          + 1.9721523e-31f);
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
  vo_bound->x = vo_0e_bound;
  vo_bound->y = vo_1e_bound;
  vo_bound->z = vo_2e_bound;
}

/* vo = R^T v; |error of vo| <= vo_bound unless inf or NaN.
   R: rotation or other 3×3 matrix; v, vo, vo_bound: vector.
   12 mul, 15 add, 9 abs. */
static inline void ksl_product_drinvvf_certified(const ksl_mat3x3f_t *R, const ksl_vec3f_t *v,
    ksl_vec3f_t *vo, ksl_vec3f_t *vo_bound) {
  const float vo_0a = KSL_MULF(R->m00, v->x), vo_0b = KSL_MULF(R->m10, v->y),
      vo_0d = KSL_MULF(R->m20, v->z), vo_0 = vo_0a + vo_0b + vo_0d;
  const float vo_1a = KSL_MULF(R->m01, v->x), vo_1b = KSL_MULF(R->m11, v->y),
      vo_1d = KSL_MULF(R->m21, v->z), vo_1 = vo_1a + vo_1b + vo_1d;
  const float vo_2a = KSL_MULF(R->m02, v->x), vo_2b = KSL_MULF(R->m12, v->y),
      vo_2d = KSL_MULF(R->m22, v->z), vo_2 = vo_2a + vo_2b + vo_2d;
  const float vo_0_size = fabsf(vo_0a) + fabsf(vo_0b) + fabsf(vo_0d),
      vo_1_size = fabsf(vo_1a) + fabsf(vo_1b) + fabsf(vo_1d),
      vo_2_size = fabsf(vo_2a) + fabsf(vo_2b) + fabsf(vo_2d);
  const float vo_0_bound = KSL_MULF(1.7881396e-07f, vo_0_size + 1.9721523e-31f),
      vo_1_bound = KSL_MULF(1.7881396e-07f, vo_1_size + 1.9721523e-31f),
      vo_2_bound = KSL_MULF(1.7881396e-07f, vo_2_size + 1.9721523e-31f);
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
  vo_bound->x = vo_0_bound;
  vo_bound->y = vo_1_bound;
  vo_bound->z = vo_2_bound;
}

/* vo = R^T (-v); |error of vo| <= vo_bound unless inf or NaN.
   R: rotation or other 3×3 matrix; v, vo, vo_bound: vector.
   12 mul, 15 add, 3 neg, 9 abs. */
static inline void ksl_product_drinvvinvf_certified(const ksl_mat3x3f_t *R, const ksl_vec3f_t *v,
    ksl_vec3f_t *vo, ksl_vec3f_t *vo_bound) {
  const float vo_0a = KSL_MULF(R->m00, v->x), vo_0b = KSL_MULF(R->m10, v->y),
      vo_0d = KSL_MULF(R->m20, v->z), vo_0 = -(vo_0a + vo_0b + vo_0d);
  const float vo_1a = KSL_MULF(R->m01, v->x), vo_1b = KSL_MULF(R->m11, v->y),
      vo_1d = KSL_MULF(R->m21, v->z), vo_1 = -(vo_1a + vo_1b + vo_1d);
  const float vo_2a = KSL_MULF(R->m02, v->x), vo_2b = KSL_MULF(R->m12, v->y),
      vo_2d = KSL_MULF(R->m22, v->z), vo_2 = -(vo_2a + vo_2b + vo_2d);
  const float vo_0e_bound = KSL_MULF(1.7881396e-07f, fabsf(vo_0a) + fabsf(vo_0b) + fabsf(vo_0d)
          + 1.9721523e-31f);
  const float vo_1e_bound = KSL_MULF(1.7881396e-07f, fabsf(vo_1a) + fabsf(vo_1b) + fabsf(vo_1d)
          + 1.9721523e-31f);
  const float vo_2e_bound = KSL_MULF(1.7881396e-07f, fabsf(vo_2a) + fabsf(vo_2b) + fabsf(vo_2d)
          + 1.9721523e-31f);
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
  vo_bound->x = vo_0e_bound;
  vo_bound->y = vo_1e_bound;
  vo_bound->z = vo_2e_bound;
}

/* vo = R v + t; |error of vo| <= vo_bound unless inf or NaN.
   D: displacement [R | t], R rotation, t in m; v, vo, vo_bound: vector.
   12 mul, 21 add, 12 abs. */
static inline void ksl_product_dvf_certified(const ksl_SE3f_t *D, const ksl_vec3f_t *v,
    ksl_vec3f_t *vo, ksl_vec3f_t *vo_bound) {
  const float vo_0a = KSL_MULF(D->m00, v->x), vo_0b = KSL_MULF(D->m01, v->y),
      vo_0d = KSL_MULF(D->m02, v->z), vo_0 = vo_0a + vo_0b + vo_0d + D->m03;
  const float vo_1a = KSL_MULF(D->m10, v->x), vo_1b = KSL_MULF(D->m11, v->y),
      vo_1d = KSL_MULF(D->m12, v->z), vo_1 = vo_1a + vo_1b + vo_1d + D->m13;
  const float vo_2a = KSL_MULF(D->m20, v->x), vo_2b = KSL_MULF(D->m21, v->y),
      vo_2d = KSL_MULF(D->m22, v->z), vo_2 = vo_2a + vo_2b + vo_2d + D->m23;
  const float vo_0_size = fabsf(vo_0a) + fabsf(vo_0b) + fabsf(vo_0d) + fabsf(D->m03),
      vo_1_size = fabsf(vo_1a) + fabsf(vo_1b) + fabsf(vo_1d) + fabsf(D->m13),
      vo_2_size = fabsf(vo_2a) + fabsf(vo_2b) + fabsf(vo_2d) + fabsf(D->m23);
  const float vo_0_bound = KSL_MULF(2.3841864e-07f, vo_0_size + 1.9721523e-31f),
      vo_1_bound = KSL_MULF(2.3841864e-07f, vo_1_size + 1.9721523e-31f),
      vo_2_bound = KSL_MULF(2.3841864e-07f, vo_2_size + 1.9721523e-31f);
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
  vo_bound->x = vo_0_bound;
  vo_bound->y = vo_1_bound;
  vo_bound->z = vo_2_bound;
}

/* vo = R^T (v - t); |error of vo| <= vo_bound unless inf or NaN.
   D: displacement [R | t], R rotation, t in m; v, vo, vo_bound: vector.
   21 mul, 18 add, 12 abs. */
static inline void ksl_product_dinvvf_certified(const ksl_SE3f_t *D, const ksl_vec3f_t *v,
    ksl_vec3f_t *vo, ksl_vec3f_t *vo_bound) {
  const float p_0 = v->x - D->m03, p_1 = v->y - D->m13, p_2 = v->z - D->m23;
  const float vo_0 = KSL_MULF(D->m00, p_0) + KSL_MULF(D->m10, p_1) + KSL_MULF(D->m20, p_2),
      vo_1 = KSL_MULF(D->m01, p_0) + KSL_MULF(D->m11, p_1) + KSL_MULF(D->m21, p_2),
      vo_2 = KSL_MULF(D->m02, p_0) + KSL_MULF(D->m12, p_1) + KSL_MULF(D->m22, p_2);
  const float p_0_abs = fabsf(p_0), p_1_abs = fabsf(p_1), p_2_abs = fabsf(p_2),
      vo_0_size = KSL_MULF(fabsf(D->m00), p_0_abs) + KSL_MULF(fabsf(D->m10), p_1_abs)
          + KSL_MULF(fabsf(D->m20), p_2_abs);
  const float vo_1_size = KSL_MULF(fabsf(D->m01), p_0_abs) + KSL_MULF(fabsf(D->m11), p_1_abs)
          + KSL_MULF(fabsf(D->m21), p_2_abs),
      vo_2_size = KSL_MULF(fabsf(D->m02), p_0_abs) + KSL_MULF(fabsf(D->m12), p_1_abs)
          + KSL_MULF(fabsf(D->m22), p_2_abs);
  const float vo_0_bound = KSL_MULF(2.3841864e-07f, vo_0_size + 1.9721523e-31f),
      vo_1_bound = KSL_MULF(2.3841864e-07f, vo_1_size + 1.9721523e-31f),
      vo_2_bound = KSL_MULF(2.3841864e-07f, vo_2_size + 1.9721523e-31f);
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
  vo_bound->x = vo_0_bound;
  vo_bound->y = vo_1_bound;
  vo_bound->z = vo_2_bound;
}

/* Ro = R1 R2; |error of Ro| <= Ro_bound unless inf or NaN.
   R1, R2, Ro, Ro_bound: rotation or other 3×3 matrix.
   36 mul, 45 add, 27 abs. */
static inline void ksl_product_drdrf_certified(const ksl_mat3x3f_t *R1, const ksl_mat3x3f_t *R2,
    ksl_mat3x3f_t *Ro, ksl_mat3x3f_t *Ro_bound) {
  const float Ro_00a = KSL_MULF(R1->m00, R2->m00), Ro_00b = KSL_MULF(R1->m01, R2->m10),
      Ro_00d = KSL_MULF(R1->m02, R2->m20), Ro_00 = Ro_00a + Ro_00b + Ro_00d;
  const float Ro_01a = KSL_MULF(R1->m00, R2->m01), Ro_01b = KSL_MULF(R1->m01, R2->m11),
      Ro_01d = KSL_MULF(R1->m02, R2->m21), Ro_01 = Ro_01a + Ro_01b + Ro_01d;
  const float Ro_02a = KSL_MULF(R1->m00, R2->m02), Ro_02b = KSL_MULF(R1->m01, R2->m12),
      Ro_02d = KSL_MULF(R1->m02, R2->m22), Ro_02 = Ro_02a + Ro_02b + Ro_02d;
  const float Ro_10a = KSL_MULF(R1->m10, R2->m00), Ro_10b = KSL_MULF(R1->m11, R2->m10),
      Ro_10d = KSL_MULF(R1->m12, R2->m20), Ro_10 = Ro_10a + Ro_10b + Ro_10d;
  const float Ro_11a = KSL_MULF(R1->m10, R2->m01), Ro_11b = KSL_MULF(R1->m11, R2->m11),
      Ro_11d = KSL_MULF(R1->m12, R2->m21), Ro_11 = Ro_11a + Ro_11b + Ro_11d;
  const float Ro_12a = KSL_MULF(R1->m10, R2->m02), Ro_12b = KSL_MULF(R1->m11, R2->m12),
      Ro_12d = KSL_MULF(R1->m12, R2->m22), Ro_12 = Ro_12a + Ro_12b + Ro_12d;
  const float Ro_20a = KSL_MULF(R1->m20, R2->m00), Ro_20b = KSL_MULF(R1->m21, R2->m10),
      Ro_20d = KSL_MULF(R1->m22, R2->m20), Ro_20 = Ro_20a + Ro_20b + Ro_20d;
  const float Ro_21a = KSL_MULF(R1->m20, R2->m01), Ro_21b = KSL_MULF(R1->m21, R2->m11),
      Ro_21d = KSL_MULF(R1->m22, R2->m21), Ro_21 = Ro_21a + Ro_21b + Ro_21d;
  const float Ro_22a = KSL_MULF(R1->m20, R2->m02), Ro_22b = KSL_MULF(R1->m21, R2->m12),
      Ro_22d = KSL_MULF(R1->m22, R2->m22), Ro_22 = Ro_22a + Ro_22b + Ro_22d;
  const float Ro_00_size = fabsf(Ro_00a) + fabsf(Ro_00b) + fabsf(Ro_00d),
      Ro_01_size = fabsf(Ro_01a) + fabsf(Ro_01b) + fabsf(Ro_01d),
      Ro_02_size = fabsf(Ro_02a) + fabsf(Ro_02b) + fabsf(Ro_02d),
      Ro_10_size = fabsf(Ro_10a) + fabsf(Ro_10b) + fabsf(Ro_10d),
      Ro_11_size = fabsf(Ro_11a) + fabsf(Ro_11b) + fabsf(Ro_11d),
      Ro_12_size = fabsf(Ro_12a) + fabsf(Ro_12b) + fabsf(Ro_12d),
      Ro_20_size = fabsf(Ro_20a) + fabsf(Ro_20b) + fabsf(Ro_20d),
      Ro_21_size = fabsf(Ro_21a) + fabsf(Ro_21b) + fabsf(Ro_21d),
      Ro_22_size = fabsf(Ro_22a) + fabsf(Ro_22b) + fabsf(Ro_22d);
  const float Ro_00_bound = KSL_MULF(1.7881396e-07f, Ro_00_size + 1.9721523e-31f),
      Ro_01_bound = KSL_MULF(1.7881396e-07f, Ro_01_size + 1.9721523e-31f),
      Ro_02_bound = KSL_MULF(1.7881396e-07f, Ro_02_size + 1.9721523e-31f),
      Ro_10_bound = KSL_MULF(1.7881396e-07f, Ro_10_size + 1.9721523e-31f),
      Ro_11_bound = KSL_MULF(1.7881396e-07f, Ro_11_size + 1.9721523e-31f),
      Ro_12_bound = KSL_MULF(1.7881396e-07f, Ro_12_size + 1.9721523e-31f),
      Ro_20_bound = KSL_MULF(1.7881396e-07f, Ro_20_size + 1.9721523e-31f),
      Ro_21_bound = KSL_MULF(1.7881396e-07f, Ro_21_size + 1.9721523e-31f),
      Ro_22_bound = KSL_MULF(1.7881396e-07f, Ro_22_size + 1.9721523e-31f);
  Ro->m00 = Ro_00;
  Ro->m01 = Ro_01;
  Ro->m02 = Ro_02;
  Ro->m10 = Ro_10;
  Ro->m11 = Ro_11;
  Ro->m12 = Ro_12;
  Ro->m20 = Ro_20;
  Ro->m21 = Ro_21;
  Ro->m22 = Ro_22;
  Ro_bound->m00 = Ro_00_bound;
  Ro_bound->m01 = Ro_01_bound;
  Ro_bound->m02 = Ro_02_bound;
  Ro_bound->m10 = Ro_10_bound;
  Ro_bound->m11 = Ro_11_bound;
  Ro_bound->m12 = Ro_12_bound;
  Ro_bound->m20 = Ro_20_bound;
  Ro_bound->m21 = Ro_21_bound;
  Ro_bound->m22 = Ro_22_bound;
}

/* Ro = R1 R2^T; |error of Ro| <= Ro_bound unless inf or NaN.
   R1, R2, Ro, Ro_bound: rotation or other 3×3 matrix.
   36 mul, 45 add, 27 abs. */
static inline void ksl_product_drdrinvf_certified(const ksl_mat3x3f_t *R1,
    const ksl_mat3x3f_t *R2, ksl_mat3x3f_t *Ro, ksl_mat3x3f_t *Ro_bound) {
  const float Ro_00a = KSL_MULF(R1->m00, R2->m00), Ro_00b = KSL_MULF(R1->m01, R2->m01),
      Ro_00d = KSL_MULF(R1->m02, R2->m02), Ro_00 = Ro_00a + Ro_00b + Ro_00d;
  const float Ro_01a = KSL_MULF(R1->m00, R2->m10), Ro_01b = KSL_MULF(R1->m01, R2->m11),
      Ro_01d = KSL_MULF(R1->m02, R2->m12), Ro_01 = Ro_01a + Ro_01b + Ro_01d;
  const float Ro_02a = KSL_MULF(R1->m00, R2->m20), Ro_02b = KSL_MULF(R1->m01, R2->m21),
      Ro_02d = KSL_MULF(R1->m02, R2->m22), Ro_02 = Ro_02a + Ro_02b + Ro_02d;
  const float Ro_10a = KSL_MULF(R1->m10, R2->m00), Ro_10b = KSL_MULF(R1->m11, R2->m01),
      Ro_10d = KSL_MULF(R1->m12, R2->m02), Ro_10 = Ro_10a + Ro_10b + Ro_10d;
  const float Ro_11a = KSL_MULF(R1->m10, R2->m10), Ro_11b = KSL_MULF(R1->m11, R2->m11),
      Ro_11d = KSL_MULF(R1->m12, R2->m12), Ro_11 = Ro_11a + Ro_11b + Ro_11d;
  const float Ro_12a = KSL_MULF(R1->m10, R2->m20), Ro_12b = KSL_MULF(R1->m11, R2->m21),
      Ro_12d = KSL_MULF(R1->m12, R2->m22), Ro_12 = Ro_12a + Ro_12b + Ro_12d;
  const float Ro_20a = KSL_MULF(R1->m20, R2->m00), Ro_20b = KSL_MULF(R1->m21, R2->m01),
      Ro_20d = KSL_MULF(R1->m22, R2->m02), Ro_20 = Ro_20a + Ro_20b + Ro_20d;
  const float Ro_21a = KSL_MULF(R1->m20, R2->m10), Ro_21b = KSL_MULF(R1->m21, R2->m11),
      Ro_21d = KSL_MULF(R1->m22, R2->m12), Ro_21 = Ro_21a + Ro_21b + Ro_21d;
  const float Ro_22a = KSL_MULF(R1->m20, R2->m20), Ro_22b = KSL_MULF(R1->m21, R2->m21),
      Ro_22d = KSL_MULF(R1->m22, R2->m22), Ro_22 = Ro_22a + Ro_22b + Ro_22d;
  const float Ro_00_size = fabsf(Ro_00a) + fabsf(Ro_00b) + fabsf(Ro_00d),
      Ro_01_size = fabsf(Ro_01a) + fabsf(Ro_01b) + fabsf(Ro_01d),
      Ro_02_size = fabsf(Ro_02a) + fabsf(Ro_02b) + fabsf(Ro_02d),
      Ro_10_size = fabsf(Ro_10a) + fabsf(Ro_10b) + fabsf(Ro_10d),
      Ro_11_size = fabsf(Ro_11a) + fabsf(Ro_11b) + fabsf(Ro_11d),
      Ro_12_size = fabsf(Ro_12a) + fabsf(Ro_12b) + fabsf(Ro_12d),
      Ro_20_size = fabsf(Ro_20a) + fabsf(Ro_20b) + fabsf(Ro_20d),
      Ro_21_size = fabsf(Ro_21a) + fabsf(Ro_21b) + fabsf(Ro_21d),
      Ro_22_size = fabsf(Ro_22a) + fabsf(Ro_22b) + fabsf(Ro_22d);
  const float Ro_00_bound = KSL_MULF(1.7881396e-07f, Ro_00_size + 1.9721523e-31f),
      Ro_01_bound = KSL_MULF(1.7881396e-07f, Ro_01_size + 1.9721523e-31f),
      Ro_02_bound = KSL_MULF(1.7881396e-07f, Ro_02_size + 1.9721523e-31f),
      Ro_10_bound = KSL_MULF(1.7881396e-07f, Ro_10_size + 1.9721523e-31f),
      Ro_11_bound = KSL_MULF(1.7881396e-07f, Ro_11_size + 1.9721523e-31f),
      Ro_12_bound = KSL_MULF(1.7881396e-07f, Ro_12_size + 1.9721523e-31f),
      Ro_20_bound = KSL_MULF(1.7881396e-07f, Ro_20_size + 1.9721523e-31f),
      Ro_21_bound = KSL_MULF(1.7881396e-07f, Ro_21_size + 1.9721523e-31f),
      Ro_22_bound = KSL_MULF(1.7881396e-07f, Ro_22_size + 1.9721523e-31f);
  Ro->m00 = Ro_00;
  Ro->m01 = Ro_01;
  Ro->m02 = Ro_02;
  Ro->m10 = Ro_10;
  Ro->m11 = Ro_11;
  Ro->m12 = Ro_12;
  Ro->m20 = Ro_20;
  Ro->m21 = Ro_21;
  Ro->m22 = Ro_22;
  Ro_bound->m00 = Ro_00_bound;
  Ro_bound->m01 = Ro_01_bound;
  Ro_bound->m02 = Ro_02_bound;
  Ro_bound->m10 = Ro_10_bound;
  Ro_bound->m11 = Ro_11_bound;
  Ro_bound->m12 = Ro_12_bound;
  Ro_bound->m20 = Ro_20_bound;
  Ro_bound->m21 = Ro_21_bound;
  Ro_bound->m22 = Ro_22_bound;
}

/* Ro = R1^T R2; |error of Ro| <= Ro_bound unless inf or NaN.
   R1, R2, Ro, Ro_bound: rotation or other 3×3 matrix.
   36 mul, 45 add, 27 abs. */
static inline void ksl_product_drinvdrf_certified(const ksl_mat3x3f_t *R1,
    const ksl_mat3x3f_t *R2, ksl_mat3x3f_t *Ro, ksl_mat3x3f_t *Ro_bound) {
  const float Ro_00a = KSL_MULF(R1->m00, R2->m00), Ro_00b = KSL_MULF(R1->m10, R2->m10),
      Ro_00d = KSL_MULF(R1->m20, R2->m20), Ro_00 = Ro_00a + Ro_00b + Ro_00d;
  const float Ro_01a = KSL_MULF(R1->m00, R2->m01), Ro_01b = KSL_MULF(R1->m10, R2->m11),
      Ro_01d = KSL_MULF(R1->m20, R2->m21), Ro_01 = Ro_01a + Ro_01b + Ro_01d;
  const float Ro_02a = KSL_MULF(R1->m00, R2->m02), Ro_02b = KSL_MULF(R1->m10, R2->m12),
      Ro_02d = KSL_MULF(R1->m20, R2->m22), Ro_02 = Ro_02a + Ro_02b + Ro_02d;
  const float Ro_10a = KSL_MULF(R1->m01, R2->m00), Ro_10b = KSL_MULF(R1->m11, R2->m10),
      Ro_10d = KSL_MULF(R1->m21, R2->m20), Ro_10 = Ro_10a + Ro_10b + Ro_10d;
  const float Ro_11a = KSL_MULF(R1->m01, R2->m01), Ro_11b = KSL_MULF(R1->m11, R2->m11),
      Ro_11d = KSL_MULF(R1->m21, R2->m21), Ro_11 = Ro_11a + Ro_11b + Ro_11d;
  const float Ro_12a = KSL_MULF(R1->m01, R2->m02), Ro_12b = KSL_MULF(R1->m11, R2->m12),
      Ro_12d = KSL_MULF(R1->m21, R2->m22), Ro_12 = Ro_12a + Ro_12b + Ro_12d;
  const float Ro_20a = KSL_MULF(R1->m02, R2->m00), Ro_20b = KSL_MULF(R1->m12, R2->m10),
      Ro_20d = KSL_MULF(R1->m22, R2->m20), Ro_20 = Ro_20a + Ro_20b + Ro_20d;
  const float Ro_21a = KSL_MULF(R1->m02, R2->m01), Ro_21b = KSL_MULF(R1->m12, R2->m11),
      Ro_21d = KSL_MULF(R1->m22, R2->m21), Ro_21 = Ro_21a + Ro_21b + Ro_21d;
  const float Ro_22a = KSL_MULF(R1->m02, R2->m02), Ro_22b = KSL_MULF(R1->m12, R2->m12),
      Ro_22d = KSL_MULF(R1->m22, R2->m22), Ro_22 = Ro_22a + Ro_22b + Ro_22d;
  const float Ro_00_size = fabsf(Ro_00a) + fabsf(Ro_00b) + fabsf(Ro_00d),
      Ro_01_size = fabsf(Ro_01a) + fabsf(Ro_01b) + fabsf(Ro_01d),
      Ro_02_size = fabsf(Ro_02a) + fabsf(Ro_02b) + fabsf(Ro_02d),
      Ro_10_size = fabsf(Ro_10a) + fabsf(Ro_10b) + fabsf(Ro_10d),
      Ro_11_size = fabsf(Ro_11a) + fabsf(Ro_11b) + fabsf(Ro_11d),
      Ro_12_size = fabsf(Ro_12a) + fabsf(Ro_12b) + fabsf(Ro_12d),
      Ro_20_size = fabsf(Ro_20a) + fabsf(Ro_20b) + fabsf(Ro_20d),
      Ro_21_size = fabsf(Ro_21a) + fabsf(Ro_21b) + fabsf(Ro_21d),
      Ro_22_size = fabsf(Ro_22a) + fabsf(Ro_22b) + fabsf(Ro_22d);
  const float Ro_00_bound = KSL_MULF(1.7881396e-07f, Ro_00_size + 1.9721523e-31f),
      Ro_01_bound = KSL_MULF(1.7881396e-07f, Ro_01_size + 1.9721523e-31f),
      Ro_02_bound = KSL_MULF(1.7881396e-07f, Ro_02_size + 1.9721523e-31f),
      Ro_10_bound = KSL_MULF(1.7881396e-07f, Ro_10_size + 1.9721523e-31f),
      Ro_11_bound = KSL_MULF(1.7881396e-07f, Ro_11_size + 1.9721523e-31f),
      Ro_12_bound = KSL_MULF(1.7881396e-07f, Ro_12_size + 1.9721523e-31f),
      Ro_20_bound = KSL_MULF(1.7881396e-07f, Ro_20_size + 1.9721523e-31f),
      Ro_21_bound = KSL_MULF(1.7881396e-07f, Ro_21_size + 1.9721523e-31f),
      Ro_22_bound = KSL_MULF(1.7881396e-07f, Ro_22_size + 1.9721523e-31f);
  Ro->m00 = Ro_00;
  Ro->m01 = Ro_01;
  Ro->m02 = Ro_02;
  Ro->m10 = Ro_10;
  Ro->m11 = Ro_11;
  Ro->m12 = Ro_12;
  Ro->m20 = Ro_20;
  Ro->m21 = Ro_21;
  Ro->m22 = Ro_22;
  Ro_bound->m00 = Ro_00_bound;
  Ro_bound->m01 = Ro_01_bound;
  Ro_bound->m02 = Ro_02_bound;
  Ro_bound->m10 = Ro_10_bound;
  Ro_bound->m11 = Ro_11_bound;
  Ro_bound->m12 = Ro_12_bound;
  Ro_bound->m20 = Ro_20_bound;
  Ro_bound->m21 = Ro_21_bound;
  Ro_bound->m22 = Ro_22_bound;
}

/* Do = D1 D2 = [R1 R2 | R1 t2 + t1]; |error of Do| <= Do_bound unless inf or NaN.
   D1, D2, Do, Do_bound: displacement [R | t], R rotation, t in m.
   48 mul, 66 add, 39 abs. */
static inline void ksl_product_ddf_certified(const ksl_SE3f_t *D1, const ksl_SE3f_t *D2,
    ksl_SE3f_t *Do, ksl_SE3f_t *Do_bound) {
  const float Do_00a = KSL_MULF(D1->m00, D2->m00), Do_00b = KSL_MULF(D1->m01, D2->m10),
      Do_00d = KSL_MULF(D1->m02, D2->m20), Do_00 = Do_00a + Do_00b + Do_00d;
  const float Do_01a = KSL_MULF(D1->m00, D2->m01), Do_01b = KSL_MULF(D1->m01, D2->m11),
      Do_01d = KSL_MULF(D1->m02, D2->m21), Do_01 = Do_01a + Do_01b + Do_01d;
  const float Do_02a = KSL_MULF(D1->m00, D2->m02), Do_02b = KSL_MULF(D1->m01, D2->m12),
      Do_02d = KSL_MULF(D1->m02, D2->m22), Do_02 = Do_02a + Do_02b + Do_02d;
  const float Do_03a = KSL_MULF(D1->m00, D2->m03), Do_03b = KSL_MULF(D1->m01, D2->m13),
      Do_03d = KSL_MULF(D1->m02, D2->m23), Do_03 = Do_03a + Do_03b + Do_03d + D1->m03;
  const float Do_10a = KSL_MULF(D1->m10, D2->m00), Do_10b = KSL_MULF(D1->m11, D2->m10),
      Do_10d = KSL_MULF(D1->m12, D2->m20), Do_10 = Do_10a + Do_10b + Do_10d;
  const float Do_11a = KSL_MULF(D1->m10, D2->m01), Do_11b = KSL_MULF(D1->m11, D2->m11),
      Do_11d = KSL_MULF(D1->m12, D2->m21), Do_11 = Do_11a + Do_11b + Do_11d;
  const float Do_12a = KSL_MULF(D1->m10, D2->m02), Do_12b = KSL_MULF(D1->m11, D2->m12),
      Do_12d = KSL_MULF(D1->m12, D2->m22), Do_12 = Do_12a + Do_12b + Do_12d;
  const float Do_13a = KSL_MULF(D1->m10, D2->m03), Do_13b = KSL_MULF(D1->m11, D2->m13),
      Do_13d = KSL_MULF(D1->m12, D2->m23), Do_13 = Do_13a + Do_13b + Do_13d + D1->m13;
  const float Do_20a = KSL_MULF(D1->m20, D2->m00), Do_20b = KSL_MULF(D1->m21, D2->m10),
      Do_20d = KSL_MULF(D1->m22, D2->m20), Do_20 = Do_20a + Do_20b + Do_20d;
  const float Do_21a = KSL_MULF(D1->m20, D2->m01), Do_21b = KSL_MULF(D1->m21, D2->m11),
      Do_21d = KSL_MULF(D1->m22, D2->m21), Do_21 = Do_21a + Do_21b + Do_21d;
  const float Do_22a = KSL_MULF(D1->m20, D2->m02), Do_22b = KSL_MULF(D1->m21, D2->m12),
      Do_22d = KSL_MULF(D1->m22, D2->m22), Do_22 = Do_22a + Do_22b + Do_22d;
  const float Do_23a = KSL_MULF(D1->m20, D2->m03), Do_23b = KSL_MULF(D1->m21, D2->m13),
      Do_23d = KSL_MULF(D1->m22, D2->m23), Do_23 = Do_23a + Do_23b + Do_23d + D1->m23;
  const float Do_00_size = fabsf(Do_00a) + fabsf(Do_00b) + fabsf(Do_00d),
      Do_01_size = fabsf(Do_01a) + fabsf(Do_01b) + fabsf(Do_01d),
      Do_02_size = fabsf(Do_02a) + fabsf(Do_02b) + fabsf(Do_02d),
      Do_03_size = fabsf(Do_03a) + fabsf(Do_03b) + fabsf(Do_03d) + fabsf(D1->m03),
      Do_10_size = fabsf(Do_10a) + fabsf(Do_10b) + fabsf(Do_10d),
      Do_11_size = fabsf(Do_11a) + fabsf(Do_11b) + fabsf(Do_11d),
      Do_12_size = fabsf(Do_12a) + fabsf(Do_12b) + fabsf(Do_12d),
      Do_13_size = fabsf(Do_13a) + fabsf(Do_13b) + fabsf(Do_13d) + fabsf(D1->m13),
      Do_20_size = fabsf(Do_20a) + fabsf(Do_20b) + fabsf(Do_20d),
      Do_21_size = fabsf(Do_21a) + fabsf(Do_21b) + fabsf(Do_21d),
      Do_22_size = fabsf(Do_22a) + fabsf(Do_22b) + fabsf(Do_22d),
      Do_23_size = fabsf(Do_23a) + fabsf(Do_23b) + fabsf(Do_23d) + fabsf(D1->m23);
  const float Do_00_bound = KSL_MULF(1.7881396e-07f, Do_00_size + 1.9721523e-31f),
      Do_01_bound = KSL_MULF(1.7881396e-07f, Do_01_size + 1.9721523e-31f),
      Do_02_bound = KSL_MULF(1.7881396e-07f, Do_02_size + 1.9721523e-31f),
      Do_03_bound = KSL_MULF(2.3841864e-07f, Do_03_size + 1.9721523e-31f),
      Do_10_bound = KSL_MULF(1.7881396e-07f, Do_10_size + 1.9721523e-31f),
      Do_11_bound = KSL_MULF(1.7881396e-07f, Do_11_size + 1.9721523e-31f),
      Do_12_bound = KSL_MULF(1.7881396e-07f, Do_12_size + 1.9721523e-31f),
      Do_13_bound = KSL_MULF(2.3841864e-07f, Do_13_size + 1.9721523e-31f),
      Do_20_bound = KSL_MULF(1.7881396e-07f, Do_20_size + 1.9721523e-31f),
      Do_21_bound = KSL_MULF(1.7881396e-07f, Do_21_size + 1.9721523e-31f),
      Do_22_bound = KSL_MULF(1.7881396e-07f, Do_22_size + 1.9721523e-31f),
      Do_23_bound = KSL_MULF(2.3841864e-07f, Do_23_size + 1.9721523e-31f);
  Do->m00 = Do_00;
  Do->m01 = Do_01;
  Do->m02 = Do_02;
  Do->m03 = Do_03;
  Do->m10 = Do_10;
  Do->m11 = Do_11;
  Do->m12 = Do_12;
  Do->m13 = Do_13;
  Do->m20 = Do_20;
  Do->m21 = Do_21;
  Do->m22 = Do_22;
  Do->m23 = Do_23;
  Do_bound->m00 = Do_00_bound;
  Do_bound->m01 = Do_01_bound;
  Do_bound->m02 = Do_02_bound;
  Do_bound->m03 = Do_03_bound;
  Do_bound->m10 = Do_10_bound;
  Do_bound->m11 = Do_11_bound;
  Do_bound->m12 = Do_12_bound;
  Do_bound->m13 = Do_13_bound;
  Do_bound->m20 = Do_20_bound;
  Do_bound->m21 = Do_21_bound;
  Do_bound->m22 = Do_22_bound;
  Do_bound->m23 = Do_23_bound;
}

/* Do = D1 D2^-1 = [R | t1 - R t2], R = R1 R2^T; |error of Do| <= Do_bound unless inf or NaN.
   D1, D2, Do, Do_bound: displacement [R | t], R rotation, t in m.
   57 mul, 66 add, 33 abs. */
static inline void ksl_product_ddinvf_certified(const ksl_SE3f_t *D1, const ksl_SE3f_t *D2,
    ksl_SE3f_t *Do, ksl_SE3f_t *Do_bound) {
  const float R_0a = KSL_MULF(D1->m00, D2->m00), R_0b = KSL_MULF(D1->m01, D2->m01),
      R_0d = KSL_MULF(D1->m02, D2->m02), R_0 = R_0a + R_0b + R_0d;
  const float R_1a = KSL_MULF(D1->m00, D2->m10), R_1b = KSL_MULF(D1->m01, D2->m11),
      R_1d = KSL_MULF(D1->m02, D2->m12), R_1 = R_1a + R_1b + R_1d;
  const float R_2a = KSL_MULF(D1->m00, D2->m20), R_2b = KSL_MULF(D1->m01, D2->m21),
      R_2d = KSL_MULF(D1->m02, D2->m22), R_2 = R_2a + R_2b + R_2d;
  const float R_3a = KSL_MULF(D1->m10, D2->m00), R_3b = KSL_MULF(D1->m11, D2->m01),
      R_3d = KSL_MULF(D1->m12, D2->m02), R_3 = R_3a + R_3b + R_3d;
  const float R_4a = KSL_MULF(D1->m10, D2->m10), R_4b = KSL_MULF(D1->m11, D2->m11),
      R_4d = KSL_MULF(D1->m12, D2->m12), R_4 = R_4a + R_4b + R_4d;
  const float R_5a = KSL_MULF(D1->m10, D2->m20), R_5b = KSL_MULF(D1->m11, D2->m21),
      R_5d = KSL_MULF(D1->m12, D2->m22), R_5 = R_5a + R_5b + R_5d;
  const float R_6a = KSL_MULF(D1->m20, D2->m00), R_6b = KSL_MULF(D1->m21, D2->m01),
      R_6d = KSL_MULF(D1->m22, D2->m02), R_6 = R_6a + R_6b + R_6d;
  const float R_7a = KSL_MULF(D1->m20, D2->m10), R_7b = KSL_MULF(D1->m21, D2->m11),
      R_7d = KSL_MULF(D1->m22, D2->m12), R_7 = R_7a + R_7b + R_7d;
  const float R_8a = KSL_MULF(D1->m20, D2->m20), R_8b = KSL_MULF(D1->m21, D2->m21),
      R_8d = KSL_MULF(D1->m22, D2->m22), R_8 = R_8a + R_8b + R_8d;
  const float Do_03 = D1->m03
          - (KSL_MULF(D2->m03, R_0) + KSL_MULF(D2->m13, R_1) + KSL_MULF(D2->m23, R_2));
  const float Do_13 = D1->m13
          - (KSL_MULF(D2->m03, R_3) + KSL_MULF(D2->m13, R_4) + KSL_MULF(D2->m23, R_5));
  const float Do_23 = D1->m23
          - (KSL_MULF(D2->m03, R_6) + KSL_MULF(D2->m13, R_7) + KSL_MULF(D2->m23, R_8));
  const float R_0_size = fabsf(R_0a) + fabsf(R_0b) + fabsf(R_0d),
      R_1_size = fabsf(R_1a) + fabsf(R_1b) + fabsf(R_1d),
      R_2_size = fabsf(R_2a) + fabsf(R_2b) + fabsf(R_2d),
      R_3_size = fabsf(R_3a) + fabsf(R_3b) + fabsf(R_3d),
      R_4_size = fabsf(R_4a) + fabsf(R_4b) + fabsf(R_4d),
      R_5_size = fabsf(R_5a) + fabsf(R_5b) + fabsf(R_5d),
      R_6_size = fabsf(R_6a) + fabsf(R_6b) + fabsf(R_6d),
      R_7_size = fabsf(R_7a) + fabsf(R_7b) + fabsf(R_7d),
      R_8_size = fabsf(R_8a) + fabsf(R_8b) + fabsf(R_8d);
  const float R_0_padded = R_0_size + 1.9721523e-31f;
  const float D2_03_abs = fabsf(D2->m03);
  const float R_1_padded = R_1_size + 1.9721523e-31f;
  const float D2_13_abs = fabsf(D2->m13);
  const float R_2_padded = R_2_size + 1.9721523e-31f;
  const float D2_23_abs = fabsf(D2->m23),
      Do_03_size = fabsf(D1->m03)
          + (KSL_MULF(D2_03_abs, R_0_padded) + KSL_MULF(D2_13_abs, R_1_padded)
          + KSL_MULF(D2_23_abs, R_2_padded));
  const float R_3_padded = R_3_size + 1.9721523e-31f, R_4_padded = R_4_size + 1.9721523e-31f,
      R_5_padded = R_5_size + 1.9721523e-31f;
  const float Do_13_size = fabsf(D1->m13)
          + (KSL_MULF(D2_03_abs, R_3_padded) + KSL_MULF(D2_13_abs, R_4_padded)
          + KSL_MULF(D2_23_abs, R_5_padded));
  const float R_6_padded = R_6_size + 1.9721523e-31f, R_7_padded = R_7_size + 1.9721523e-31f,
      R_8_padded = R_8_size + 1.9721523e-31f;
  const float Do_23_size = fabsf(D1->m23)
          + (KSL_MULF(D2_03_abs, R_6_padded) + KSL_MULF(D2_13_abs, R_7_padded)
          + KSL_MULF(D2_23_abs, R_8_padded));
  const float R_0_bound = KSL_MULF(1.7881396e-07f, R_0_padded),
      R_1_bound = KSL_MULF(1.7881396e-07f, R_1_padded),
      R_2_bound = KSL_MULF(1.7881396e-07f, R_2_padded);
  const float Do_03_bound = KSL_MULF(4.1723263e-07f, Do_03_size + 1.9721523e-31f);
  const float R_3_bound = KSL_MULF(1.7881396e-07f, R_3_padded),
      R_4_bound = KSL_MULF(1.7881396e-07f, R_4_padded),
      R_5_bound = KSL_MULF(1.7881396e-07f, R_5_padded);
  const float Do_13_bound = KSL_MULF(4.1723263e-07f, Do_13_size + 1.9721523e-31f);
  const float R_6_bound = KSL_MULF(1.7881396e-07f, R_6_padded),
      R_7_bound = KSL_MULF(1.7881396e-07f, R_7_padded),
      R_8_bound = KSL_MULF(1.7881396e-07f, R_8_padded);
  const float Do_23_bound = KSL_MULF(4.1723263e-07f, Do_23_size + 1.9721523e-31f);
  Do->m00 = R_0;
  Do->m01 = R_1;
  Do->m02 = R_2;
  Do->m03 = Do_03;
  Do->m10 = R_3;
  Do->m11 = R_4;
  Do->m12 = R_5;
  Do->m13 = Do_13;
  Do->m20 = R_6;
  Do->m21 = R_7;
  Do->m22 = R_8;
  Do->m23 = Do_23;
  Do_bound->m00 = R_0_bound;
  Do_bound->m01 = R_1_bound;
  Do_bound->m02 = R_2_bound;
  Do_bound->m03 = Do_03_bound;
  Do_bound->m10 = R_3_bound;
  Do_bound->m11 = R_4_bound;
  Do_bound->m12 = R_5_bound;
  Do_bound->m13 = Do_13_bound;
  Do_bound->m20 = R_6_bound;
  Do_bound->m21 = R_7_bound;
  Do_bound->m22 = R_8_bound;
  Do_bound->m23 = Do_23_bound;
}

/* Do = D1^-1 D2 = [R1^T R2 | R1^T (t2 - t1)]; |error of Do| <= Do_bound unless inf or NaN.
   D1, D2, Do, Do_bound: displacement [R | t], R rotation, t in m.
   57 mul, 63 add, 39 abs. */
static inline void ksl_product_dinvdf_certified(const ksl_SE3f_t *D1, const ksl_SE3f_t *D2,
    ksl_SE3f_t *Do, ksl_SE3f_t *Do_bound) {
  const float p_0 = D2->m03 - D1->m03, p_1 = D2->m13 - D1->m13, p_2 = D2->m23 - D1->m23;
  const float Do_00a = KSL_MULF(D1->m00, D2->m00), Do_00b = KSL_MULF(D1->m10, D2->m10),
      Do_00d = KSL_MULF(D1->m20, D2->m20), Do_00 = Do_00a + Do_00b + Do_00d;
  const float Do_01a = KSL_MULF(D1->m00, D2->m01), Do_01b = KSL_MULF(D1->m10, D2->m11),
      Do_01d = KSL_MULF(D1->m20, D2->m21), Do_01 = Do_01a + Do_01b + Do_01d;
  const float Do_02a = KSL_MULF(D1->m00, D2->m02), Do_02b = KSL_MULF(D1->m10, D2->m12),
      Do_02d = KSL_MULF(D1->m20, D2->m22), Do_02 = Do_02a + Do_02b + Do_02d;
  const float Do_03 = KSL_MULF(D1->m00, p_0) + KSL_MULF(D1->m10, p_1) + KSL_MULF(D1->m20, p_2);
  const float Do_10a = KSL_MULF(D1->m01, D2->m00), Do_10b = KSL_MULF(D1->m11, D2->m10),
      Do_10d = KSL_MULF(D1->m21, D2->m20), Do_10 = Do_10a + Do_10b + Do_10d;
  const float Do_11a = KSL_MULF(D1->m01, D2->m01), Do_11b = KSL_MULF(D1->m11, D2->m11),
      Do_11d = KSL_MULF(D1->m21, D2->m21), Do_11 = Do_11a + Do_11b + Do_11d;
  const float Do_12a = KSL_MULF(D1->m01, D2->m02), Do_12b = KSL_MULF(D1->m11, D2->m12),
      Do_12d = KSL_MULF(D1->m21, D2->m22), Do_12 = Do_12a + Do_12b + Do_12d;
  const float Do_13 = KSL_MULF(D1->m01, p_0) + KSL_MULF(D1->m11, p_1) + KSL_MULF(D1->m21, p_2);
  const float Do_20a = KSL_MULF(D1->m02, D2->m00), Do_20b = KSL_MULF(D1->m12, D2->m10),
      Do_20d = KSL_MULF(D1->m22, D2->m20), Do_20 = Do_20a + Do_20b + Do_20d;
  const float Do_21a = KSL_MULF(D1->m02, D2->m01), Do_21b = KSL_MULF(D1->m12, D2->m11),
      Do_21d = KSL_MULF(D1->m22, D2->m21), Do_21 = Do_21a + Do_21b + Do_21d;
  const float Do_22a = KSL_MULF(D1->m02, D2->m02), Do_22b = KSL_MULF(D1->m12, D2->m12),
      Do_22d = KSL_MULF(D1->m22, D2->m22), Do_22 = Do_22a + Do_22b + Do_22d;
  const float Do_23 = KSL_MULF(D1->m02, p_0) + KSL_MULF(D1->m12, p_1) + KSL_MULF(D1->m22, p_2);
  const float Do_00_size = fabsf(Do_00a) + fabsf(Do_00b) + fabsf(Do_00d),
      Do_01_size = fabsf(Do_01a) + fabsf(Do_01b) + fabsf(Do_01d),
      Do_02_size = fabsf(Do_02a) + fabsf(Do_02b) + fabsf(Do_02d);
  const float p_0_abs = fabsf(p_0), p_1_abs = fabsf(p_1), p_2_abs = fabsf(p_2),
      Do_03_size = KSL_MULF(fabsf(D1->m00), p_0_abs) + KSL_MULF(fabsf(D1->m10), p_1_abs)
          + KSL_MULF(fabsf(D1->m20), p_2_abs);
  const float Do_10_size = fabsf(Do_10a) + fabsf(Do_10b) + fabsf(Do_10d),
      Do_11_size = fabsf(Do_11a) + fabsf(Do_11b) + fabsf(Do_11d),
      Do_12_size = fabsf(Do_12a) + fabsf(Do_12b) + fabsf(Do_12d),
      Do_13_size = KSL_MULF(fabsf(D1->m01), p_0_abs) + KSL_MULF(fabsf(D1->m11), p_1_abs)
          + KSL_MULF(fabsf(D1->m21), p_2_abs),
      Do_20_size = fabsf(Do_20a) + fabsf(Do_20b) + fabsf(Do_20d),
      Do_21_size = fabsf(Do_21a) + fabsf(Do_21b) + fabsf(Do_21d),
      Do_22_size = fabsf(Do_22a) + fabsf(Do_22b) + fabsf(Do_22d),
      Do_23_size = KSL_MULF(fabsf(D1->m02), p_0_abs) + KSL_MULF(fabsf(D1->m12), p_1_abs)
          + KSL_MULF(fabsf(D1->m22), p_2_abs);
  const float Do_00_bound = KSL_MULF(1.7881396e-07f, Do_00_size + 1.9721523e-31f),
      Do_01_bound = KSL_MULF(1.7881396e-07f, Do_01_size + 1.9721523e-31f),
      Do_02_bound = KSL_MULF(1.7881396e-07f, Do_02_size + 1.9721523e-31f),
      Do_03_bound = KSL_MULF(2.3841864e-07f, Do_03_size + 1.9721523e-31f),
      Do_10_bound = KSL_MULF(1.7881396e-07f, Do_10_size + 1.9721523e-31f),
      Do_11_bound = KSL_MULF(1.7881396e-07f, Do_11_size + 1.9721523e-31f),
      Do_12_bound = KSL_MULF(1.7881396e-07f, Do_12_size + 1.9721523e-31f),
      Do_13_bound = KSL_MULF(2.3841864e-07f, Do_13_size + 1.9721523e-31f),
      Do_20_bound = KSL_MULF(1.7881396e-07f, Do_20_size + 1.9721523e-31f),
      Do_21_bound = KSL_MULF(1.7881396e-07f, Do_21_size + 1.9721523e-31f),
      Do_22_bound = KSL_MULF(1.7881396e-07f, Do_22_size + 1.9721523e-31f),
      Do_23_bound = KSL_MULF(2.3841864e-07f, Do_23_size + 1.9721523e-31f);
  Do->m00 = Do_00;
  Do->m01 = Do_01;
  Do->m02 = Do_02;
  Do->m03 = Do_03;
  Do->m10 = Do_10;
  Do->m11 = Do_11;
  Do->m12 = Do_12;
  Do->m13 = Do_13;
  Do->m20 = Do_20;
  Do->m21 = Do_21;
  Do->m22 = Do_22;
  Do->m23 = Do_23;
  Do_bound->m00 = Do_00_bound;
  Do_bound->m01 = Do_01_bound;
  Do_bound->m02 = Do_02_bound;
  Do_bound->m03 = Do_03_bound;
  Do_bound->m10 = Do_10_bound;
  Do_bound->m11 = Do_11_bound;
  Do_bound->m12 = Do_12_bound;
  Do_bound->m13 = Do_13_bound;
  Do_bound->m20 = Do_20_bound;
  Do_bound->m21 = Do_21_bound;
  Do_bound->m22 = Do_22_bound;
  Do_bound->m23 = Do_23_bound;
}

/* Do = D [R | 0]; |error of Do| <= Do_bound unless inf or NaN.
   D, Do, Do_bound: displacement [R | t], R rotation, t in m; R: rotation or other 3×3 matrix.
   36 mul, 45 add, 27 abs. */
static inline void ksl_product_ddrf_certified(const ksl_SE3f_t *D, const ksl_mat3x3f_t *R,
    ksl_SE3f_t *Do, ksl_SE3f_t *Do_bound) {
  const float Do_00a = KSL_MULF(D->m00, R->m00), Do_00b = KSL_MULF(D->m01, R->m10),
      Do_00d = KSL_MULF(D->m02, R->m20), Do_00 = Do_00a + Do_00b + Do_00d;
  const float Do_01a = KSL_MULF(D->m00, R->m01), Do_01b = KSL_MULF(D->m01, R->m11),
      Do_01d = KSL_MULF(D->m02, R->m21), Do_01 = Do_01a + Do_01b + Do_01d;
  const float Do_02a = KSL_MULF(D->m00, R->m02), Do_02b = KSL_MULF(D->m01, R->m12),
      Do_02d = KSL_MULF(D->m02, R->m22), Do_02 = Do_02a + Do_02b + Do_02d;
  const float Do_10a = KSL_MULF(D->m10, R->m00), Do_10b = KSL_MULF(D->m11, R->m10),
      Do_10d = KSL_MULF(D->m12, R->m20), Do_10 = Do_10a + Do_10b + Do_10d;
  const float Do_11a = KSL_MULF(D->m10, R->m01), Do_11b = KSL_MULF(D->m11, R->m11),
      Do_11d = KSL_MULF(D->m12, R->m21), Do_11 = Do_11a + Do_11b + Do_11d;
  const float Do_12a = KSL_MULF(D->m10, R->m02), Do_12b = KSL_MULF(D->m11, R->m12),
      Do_12d = KSL_MULF(D->m12, R->m22), Do_12 = Do_12a + Do_12b + Do_12d;
  const float Do_20a = KSL_MULF(D->m20, R->m00), Do_20b = KSL_MULF(D->m21, R->m10),
      Do_20d = KSL_MULF(D->m22, R->m20), Do_20 = Do_20a + Do_20b + Do_20d;
  const float Do_21a = KSL_MULF(D->m20, R->m01), Do_21b = KSL_MULF(D->m21, R->m11),
      Do_21d = KSL_MULF(D->m22, R->m21), Do_21 = Do_21a + Do_21b + Do_21d;
  const float Do_22a = KSL_MULF(D->m20, R->m02), Do_22b = KSL_MULF(D->m21, R->m12),
      Do_22d = KSL_MULF(D->m22, R->m22), Do_22 = Do_22a + Do_22b + Do_22d;
  const float Do_00_size = fabsf(Do_00a) + fabsf(Do_00b) + fabsf(Do_00d),
      Do_01_size = fabsf(Do_01a) + fabsf(Do_01b) + fabsf(Do_01d),
      Do_02_size = fabsf(Do_02a) + fabsf(Do_02b) + fabsf(Do_02d),
      Do_10_size = fabsf(Do_10a) + fabsf(Do_10b) + fabsf(Do_10d),
      Do_11_size = fabsf(Do_11a) + fabsf(Do_11b) + fabsf(Do_11d),
      Do_12_size = fabsf(Do_12a) + fabsf(Do_12b) + fabsf(Do_12d),
      Do_20_size = fabsf(Do_20a) + fabsf(Do_20b) + fabsf(Do_20d),
      Do_21_size = fabsf(Do_21a) + fabsf(Do_21b) + fabsf(Do_21d),
      Do_22_size = fabsf(Do_22a) + fabsf(Do_22b) + fabsf(Do_22d);
  const float Do_00_bound = KSL_MULF(1.7881396e-07f, Do_00_size + 1.9721523e-31f),
      Do_01_bound = KSL_MULF(1.7881396e-07f, Do_01_size + 1.9721523e-31f),
      Do_02_bound = KSL_MULF(1.7881396e-07f, Do_02_size + 1.9721523e-31f),
      Do_10_bound = KSL_MULF(1.7881396e-07f, Do_10_size + 1.9721523e-31f),
      Do_11_bound = KSL_MULF(1.7881396e-07f, Do_11_size + 1.9721523e-31f),
      Do_12_bound = KSL_MULF(1.7881396e-07f, Do_12_size + 1.9721523e-31f),
      Do_20_bound = KSL_MULF(1.7881396e-07f, Do_20_size + 1.9721523e-31f),
      Do_21_bound = KSL_MULF(1.7881396e-07f, Do_21_size + 1.9721523e-31f),
      Do_22_bound = KSL_MULF(1.7881396e-07f, Do_22_size + 1.9721523e-31f);
  const float D_m03 = D->m03;
  const float D_m13 = D->m13;
  const float D_m23 = D->m23;
  Do->m00 = Do_00;
  Do->m01 = Do_01;
  Do->m02 = Do_02;
  Do->m03 = D_m03;
  Do->m10 = Do_10;
  Do->m11 = Do_11;
  Do->m12 = Do_12;
  Do->m13 = D_m13;
  Do->m20 = Do_20;
  Do->m21 = Do_21;
  Do->m22 = Do_22;
  Do->m23 = D_m23;
  Do_bound->m00 = Do_00_bound;
  Do_bound->m01 = Do_01_bound;
  Do_bound->m02 = Do_02_bound;
  Do_bound->m03 = 0.0f;
  Do_bound->m10 = Do_10_bound;
  Do_bound->m11 = Do_11_bound;
  Do_bound->m12 = Do_12_bound;
  Do_bound->m13 = 0.0f;
  Do_bound->m20 = Do_20_bound;
  Do_bound->m21 = Do_21_bound;
  Do_bound->m22 = Do_22_bound;
  Do_bound->m23 = 0.0f;
}

/* Do = D [R^T | 0]; |error of Do| <= Do_bound unless inf or NaN.
   D, Do, Do_bound: displacement [R | t], R rotation, t in m; R: rotation or other 3×3 matrix.
   36 mul, 45 add, 27 abs. */
static inline void ksl_product_ddrinvf_certified(const ksl_SE3f_t *D, const ksl_mat3x3f_t *R,
    ksl_SE3f_t *Do, ksl_SE3f_t *Do_bound) {
  const float Do_00a = KSL_MULF(D->m00, R->m00), Do_00b = KSL_MULF(D->m01, R->m01),
      Do_00d = KSL_MULF(D->m02, R->m02), Do_00 = Do_00a + Do_00b + Do_00d;
  const float Do_01a = KSL_MULF(D->m00, R->m10), Do_01b = KSL_MULF(D->m01, R->m11),
      Do_01d = KSL_MULF(D->m02, R->m12), Do_01 = Do_01a + Do_01b + Do_01d;
  const float Do_02a = KSL_MULF(D->m00, R->m20), Do_02b = KSL_MULF(D->m01, R->m21),
      Do_02d = KSL_MULF(D->m02, R->m22), Do_02 = Do_02a + Do_02b + Do_02d;
  const float Do_10a = KSL_MULF(D->m10, R->m00), Do_10b = KSL_MULF(D->m11, R->m01),
      Do_10d = KSL_MULF(D->m12, R->m02), Do_10 = Do_10a + Do_10b + Do_10d;
  const float Do_11a = KSL_MULF(D->m10, R->m10), Do_11b = KSL_MULF(D->m11, R->m11),
      Do_11d = KSL_MULF(D->m12, R->m12), Do_11 = Do_11a + Do_11b + Do_11d;
  const float Do_12a = KSL_MULF(D->m10, R->m20), Do_12b = KSL_MULF(D->m11, R->m21),
      Do_12d = KSL_MULF(D->m12, R->m22), Do_12 = Do_12a + Do_12b + Do_12d;
  const float Do_20a = KSL_MULF(D->m20, R->m00), Do_20b = KSL_MULF(D->m21, R->m01),
      Do_20d = KSL_MULF(D->m22, R->m02), Do_20 = Do_20a + Do_20b + Do_20d;
  const float Do_21a = KSL_MULF(D->m20, R->m10), Do_21b = KSL_MULF(D->m21, R->m11),
      Do_21d = KSL_MULF(D->m22, R->m12), Do_21 = Do_21a + Do_21b + Do_21d;
  const float Do_22a = KSL_MULF(D->m20, R->m20), Do_22b = KSL_MULF(D->m21, R->m21),
      Do_22d = KSL_MULF(D->m22, R->m22), Do_22 = Do_22a + Do_22b + Do_22d;
  const float Do_00_size = fabsf(Do_00a) + fabsf(Do_00b) + fabsf(Do_00d),
      Do_01_size = fabsf(Do_01a) + fabsf(Do_01b) + fabsf(Do_01d),
      Do_02_size = fabsf(Do_02a) + fabsf(Do_02b) + fabsf(Do_02d),
      Do_10_size = fabsf(Do_10a) + fabsf(Do_10b) + fabsf(Do_10d),
      Do_11_size = fabsf(Do_11a) + fabsf(Do_11b) + fabsf(Do_11d),
      Do_12_size = fabsf(Do_12a) + fabsf(Do_12b) + fabsf(Do_12d),
      Do_20_size = fabsf(Do_20a) + fabsf(Do_20b) + fabsf(Do_20d),
      Do_21_size = fabsf(Do_21a) + fabsf(Do_21b) + fabsf(Do_21d),
      Do_22_size = fabsf(Do_22a) + fabsf(Do_22b) + fabsf(Do_22d);
  const float Do_00_bound = KSL_MULF(1.7881396e-07f, Do_00_size + 1.9721523e-31f),
      Do_01_bound = KSL_MULF(1.7881396e-07f, Do_01_size + 1.9721523e-31f),
      Do_02_bound = KSL_MULF(1.7881396e-07f, Do_02_size + 1.9721523e-31f),
      Do_10_bound = KSL_MULF(1.7881396e-07f, Do_10_size + 1.9721523e-31f),
      Do_11_bound = KSL_MULF(1.7881396e-07f, Do_11_size + 1.9721523e-31f),
      Do_12_bound = KSL_MULF(1.7881396e-07f, Do_12_size + 1.9721523e-31f),
      Do_20_bound = KSL_MULF(1.7881396e-07f, Do_20_size + 1.9721523e-31f),
      Do_21_bound = KSL_MULF(1.7881396e-07f, Do_21_size + 1.9721523e-31f),
      Do_22_bound = KSL_MULF(1.7881396e-07f, Do_22_size + 1.9721523e-31f);
  const float D_m03 = D->m03;
  const float D_m13 = D->m13;
  const float D_m23 = D->m23;
  Do->m00 = Do_00;
  Do->m01 = Do_01;
  Do->m02 = Do_02;
  Do->m03 = D_m03;
  Do->m10 = Do_10;
  Do->m11 = Do_11;
  Do->m12 = Do_12;
  Do->m13 = D_m13;
  Do->m20 = Do_20;
  Do->m21 = Do_21;
  Do->m22 = Do_22;
  Do->m23 = D_m23;
  Do_bound->m00 = Do_00_bound;
  Do_bound->m01 = Do_01_bound;
  Do_bound->m02 = Do_02_bound;
  Do_bound->m03 = 0.0f;
  Do_bound->m10 = Do_10_bound;
  Do_bound->m11 = Do_11_bound;
  Do_bound->m12 = Do_12_bound;
  Do_bound->m13 = 0.0f;
  Do_bound->m20 = Do_20_bound;
  Do_bound->m21 = Do_21_bound;
  Do_bound->m22 = Do_22_bound;
  Do_bound->m23 = 0.0f;
}

/* Do = D [I | t]; |error of Do| <= Do_bound unless inf or NaN.
   D, Do, Do_bound: displacement [R | t], R rotation, t in m; t: vector.
   12 mul, 21 add, 12 abs. */
static inline void ksl_product_ddtf_certified(const ksl_SE3f_t *D, const ksl_vec3f_t *t,
    ksl_SE3f_t *Do, ksl_SE3f_t *Do_bound) {
  const float Do_03a = KSL_MULF(D->m00, t->x), Do_03b = KSL_MULF(D->m01, t->y),
      Do_03d = KSL_MULF(D->m02, t->z), Do_03 = Do_03a + Do_03b + Do_03d + D->m03;
  const float Do_13a = KSL_MULF(D->m10, t->x), Do_13b = KSL_MULF(D->m11, t->y),
      Do_13d = KSL_MULF(D->m12, t->z), Do_13 = Do_13a + Do_13b + Do_13d + D->m13;
  const float Do_23a = KSL_MULF(D->m20, t->x), Do_23b = KSL_MULF(D->m21, t->y),
      Do_23d = KSL_MULF(D->m22, t->z), Do_23 = Do_23a + Do_23b + Do_23d + D->m23;
  const float Do_03_size = fabsf(Do_03a) + fabsf(Do_03b) + fabsf(Do_03d) + fabsf(D->m03),
      Do_13_size = fabsf(Do_13a) + fabsf(Do_13b) + fabsf(Do_13d) + fabsf(D->m13),
      Do_23_size = fabsf(Do_23a) + fabsf(Do_23b) + fabsf(Do_23d) + fabsf(D->m23);
  const float Do_03_bound = KSL_MULF(2.3841864e-07f, Do_03_size + 1.9721523e-31f),
      Do_13_bound = KSL_MULF(2.3841864e-07f, Do_13_size + 1.9721523e-31f),
      Do_23_bound = KSL_MULF(2.3841864e-07f, Do_23_size + 1.9721523e-31f);
  const float D_m00 = D->m00;
  const float D_m01 = D->m01;
  const float D_m02 = D->m02;
  const float D_m10 = D->m10;
  const float D_m11 = D->m11;
  const float D_m12 = D->m12;
  const float D_m20 = D->m20;
  const float D_m21 = D->m21;
  const float D_m22 = D->m22;
  Do->m00 = D_m00;
  Do->m01 = D_m01;
  Do->m02 = D_m02;
  Do->m03 = Do_03;
  Do->m10 = D_m10;
  Do->m11 = D_m11;
  Do->m12 = D_m12;
  Do->m13 = Do_13;
  Do->m20 = D_m20;
  Do->m21 = D_m21;
  Do->m22 = D_m22;
  Do->m23 = Do_23;
  Do_bound->m00 = 0.0f;
  Do_bound->m01 = 0.0f;
  Do_bound->m02 = 0.0f;
  Do_bound->m03 = Do_03_bound;
  Do_bound->m10 = 0.0f;
  Do_bound->m11 = 0.0f;
  Do_bound->m12 = 0.0f;
  Do_bound->m13 = Do_13_bound;
  Do_bound->m20 = 0.0f;
  Do_bound->m21 = 0.0f;
  Do_bound->m22 = 0.0f;
  Do_bound->m23 = Do_23_bound;
}

/* Do = D [I | -t]; |error of Do| <= Do_bound unless inf or NaN.
   D, Do, Do_bound: displacement [R | t], R rotation, t in m; t: vector.
   12 mul, 21 add, 12 abs. */
static inline void ksl_product_ddtinvf_certified(const ksl_SE3f_t *D, const ksl_vec3f_t *t,
    ksl_SE3f_t *Do, ksl_SE3f_t *Do_bound) {
  const float Do_03a = KSL_MULF(D->m00, t->x), Do_03b = KSL_MULF(D->m01, t->y),
      Do_03d = KSL_MULF(D->m02, t->z), Do_03 = D->m03 - (Do_03a + Do_03b + Do_03d);
  const float Do_13a = KSL_MULF(D->m10, t->x), Do_13b = KSL_MULF(D->m11, t->y),
      Do_13d = KSL_MULF(D->m12, t->z), Do_13 = D->m13 - (Do_13a + Do_13b + Do_13d);
  const float Do_23a = KSL_MULF(D->m20, t->x), Do_23b = KSL_MULF(D->m21, t->y),
      Do_23d = KSL_MULF(D->m22, t->z), Do_23 = D->m23 - (Do_23a + Do_23b + Do_23d);
  const float Do_03_size = fabsf(D->m03) + (fabsf(Do_03a) + fabsf(Do_03b) + fabsf(Do_03d)),
      Do_13_size = fabsf(D->m13) + (fabsf(Do_13a) + fabsf(Do_13b) + fabsf(Do_13d)),
      Do_23_size = fabsf(D->m23) + (fabsf(Do_23a) + fabsf(Do_23b) + fabsf(Do_23d));
  const float Do_03_bound = KSL_MULF(2.3841864e-07f, Do_03_size + 1.9721523e-31f),
      Do_13_bound = KSL_MULF(2.3841864e-07f, Do_13_size + 1.9721523e-31f),
      Do_23_bound = KSL_MULF(2.3841864e-07f, Do_23_size + 1.9721523e-31f);
  const float D_m00 = D->m00;
  const float D_m01 = D->m01;
  const float D_m02 = D->m02;
  const float D_m10 = D->m10;
  const float D_m11 = D->m11;
  const float D_m12 = D->m12;
  const float D_m20 = D->m20;
  const float D_m21 = D->m21;
  const float D_m22 = D->m22;
  Do->m00 = D_m00;
  Do->m01 = D_m01;
  Do->m02 = D_m02;
  Do->m03 = Do_03;
  Do->m10 = D_m10;
  Do->m11 = D_m11;
  Do->m12 = D_m12;
  Do->m13 = Do_13;
  Do->m20 = D_m20;
  Do->m21 = D_m21;
  Do->m22 = D_m22;
  Do->m23 = Do_23;
  Do_bound->m00 = 0.0f;
  Do_bound->m01 = 0.0f;
  Do_bound->m02 = 0.0f;
  Do_bound->m03 = Do_03_bound;
  Do_bound->m10 = 0.0f;
  Do_bound->m11 = 0.0f;
  Do_bound->m12 = 0.0f;
  Do_bound->m13 = Do_13_bound;
  Do_bound->m20 = 0.0f;
  Do_bound->m21 = 0.0f;
  Do_bound->m22 = 0.0f;
  Do_bound->m23 = Do_23_bound;
}

/* Do = D^-1 [I | t] = [R^T | R^T (t - t_D)]; |error of Do| <= Do_bound unless inf or NaN.
   D, Do, Do_bound: displacement [R | t], R rotation, t in m; t: vector.
   21 mul, 18 add, 12 abs. */
static inline void ksl_product_dinvdtf_certified(const ksl_SE3f_t *D, const ksl_vec3f_t *t,
    ksl_SE3f_t *Do, ksl_SE3f_t *Do_bound) {
  const float p_0 = t->x - D->m03, p_1 = t->y - D->m13, p_2 = t->z - D->m23;
  const float Do_03 = KSL_MULF(D->m00, p_0) + KSL_MULF(D->m10, p_1) + KSL_MULF(D->m20, p_2),
      Do_13 = KSL_MULF(D->m01, p_0) + KSL_MULF(D->m11, p_1) + KSL_MULF(D->m21, p_2),
      Do_23 = KSL_MULF(D->m02, p_0) + KSL_MULF(D->m12, p_1) + KSL_MULF(D->m22, p_2);
  const float p_0_abs = fabsf(p_0), p_1_abs = fabsf(p_1), p_2_abs = fabsf(p_2),
      Do_03_size = KSL_MULF(fabsf(D->m00), p_0_abs) + KSL_MULF(fabsf(D->m10), p_1_abs)
          + KSL_MULF(fabsf(D->m20), p_2_abs);
  const float Do_13_size = KSL_MULF(fabsf(D->m01), p_0_abs) + KSL_MULF(fabsf(D->m11), p_1_abs)
          + KSL_MULF(fabsf(D->m21), p_2_abs),
      Do_23_size = KSL_MULF(fabsf(D->m02), p_0_abs) + KSL_MULF(fabsf(D->m12), p_1_abs)
          + KSL_MULF(fabsf(D->m22), p_2_abs);
  const float Do_03_bound = KSL_MULF(2.3841864e-07f, Do_03_size + 1.9721523e-31f),
      Do_13_bound = KSL_MULF(2.3841864e-07f, Do_13_size + 1.9721523e-31f),
      Do_23_bound = KSL_MULF(2.3841864e-07f, Do_23_size + 1.9721523e-31f);
  const float D_m00 = D->m00;
  const float D_m10 = D->m10;
  const float D_m20 = D->m20;
  const float D_m01 = D->m01;
  const float D_m11 = D->m11;
  const float D_m21 = D->m21;
  const float D_m02 = D->m02;
  const float D_m12 = D->m12;
  const float D_m22 = D->m22;
  Do->m00 = D_m00;
  Do->m01 = D_m10;
  Do->m02 = D_m20;
  Do->m03 = Do_03;
  Do->m10 = D_m01;
  Do->m11 = D_m11;
  Do->m12 = D_m21;
  Do->m13 = Do_13;
  Do->m20 = D_m02;
  Do->m21 = D_m12;
  Do->m22 = D_m22;
  Do->m23 = Do_23;
  Do_bound->m00 = 0.0f;
  Do_bound->m01 = 0.0f;
  Do_bound->m02 = 0.0f;
  Do_bound->m03 = Do_03_bound;
  Do_bound->m10 = 0.0f;
  Do_bound->m11 = 0.0f;
  Do_bound->m12 = 0.0f;
  Do_bound->m13 = Do_13_bound;
  Do_bound->m20 = 0.0f;
  Do_bound->m21 = 0.0f;
  Do_bound->m22 = 0.0f;
  Do_bound->m23 = Do_23_bound;
}

/* vo = R (k e_x); |error of vo| <= vo_bound unless inf or NaN.
   R: rotation or other 3×3 matrix; k: number; vo, vo_bound: vector.
   6 mul, 3 add, 3 abs. */
static inline void ksl_product_drvtxf_certified(const ksl_mat3x3f_t *R, const float k,
    ksl_vec3f_t *vo, ksl_vec3f_t *vo_bound) {
  const float vo_0 = KSL_MULF(R->m00, k), vo_1 = KSL_MULF(R->m10, k), vo_2 = KSL_MULF(R->m20, k);
  const float vo_0_bound = KSL_MULF(5.960465e-08f, fabsf(vo_0) + 1.9721523e-31f),
      vo_1_bound = KSL_MULF(5.960465e-08f, fabsf(vo_1) + 1.9721523e-31f),
      vo_2_bound = KSL_MULF(5.960465e-08f, fabsf(vo_2) + 1.9721523e-31f);
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
  vo_bound->x = vo_0_bound;
  vo_bound->y = vo_1_bound;
  vo_bound->z = vo_2_bound;
}

/* Ro = R R_x(θ), dc = (sin θ, cos θ); |error of Ro| <= Ro_bound unless inf or NaN.
   R, Ro, Ro_bound: rotation or other 3×3 matrix; dc: (sin θ, cos θ).
   18 mul, 18 add, 12 abs. */
static inline void ksl_product_drdrxf_certified(const ksl_mat3x3f_t *R, const float dc[2],
    ksl_mat3x3f_t *Ro, ksl_mat3x3f_t *Ro_bound) {
  const float Ro_01a = KSL_MULF(R->m01, dc[1]), Ro_01b = KSL_MULF(R->m02, dc[0]),
      Ro_01 = Ro_01a + Ro_01b;
  const float Ro_02a = KSL_MULF(R->m02, dc[1]), Ro_02b = KSL_MULF(R->m01, dc[0]),
      Ro_02 = Ro_02a - Ro_02b;
  const float Ro_11a = KSL_MULF(R->m11, dc[1]), Ro_11b = KSL_MULF(R->m12, dc[0]),
      Ro_11 = Ro_11a + Ro_11b;
  const float Ro_12a = KSL_MULF(R->m12, dc[1]), Ro_12b = KSL_MULF(R->m11, dc[0]),
      Ro_12 = Ro_12a - Ro_12b;
  const float Ro_21a = KSL_MULF(R->m21, dc[1]), Ro_21b = KSL_MULF(R->m22, dc[0]),
      Ro_21 = Ro_21a + Ro_21b;
  const float Ro_22a = KSL_MULF(R->m22, dc[1]), Ro_22b = KSL_MULF(R->m21, dc[0]),
      Ro_22 = Ro_22a - Ro_22b;
  const float Ro_01_size = fabsf(Ro_01a) + fabsf(Ro_01b),
      Ro_02_size = fabsf(Ro_02a) + fabsf(Ro_02b), Ro_11_size = fabsf(Ro_11a) + fabsf(Ro_11b),
      Ro_12_size = fabsf(Ro_12a) + fabsf(Ro_12b), Ro_21_size = fabsf(Ro_21a) + fabsf(Ro_21b),
      Ro_22_size = fabsf(Ro_22a) + fabsf(Ro_22b);
  const float Ro_01_bound = KSL_MULF(1.192093e-07f, Ro_01_size + 1.9721523e-31f),
      Ro_02_bound = KSL_MULF(1.192093e-07f, Ro_02_size + 1.9721523e-31f),
      Ro_11_bound = KSL_MULF(1.192093e-07f, Ro_11_size + 1.9721523e-31f),
      Ro_12_bound = KSL_MULF(1.192093e-07f, Ro_12_size + 1.9721523e-31f),
      Ro_21_bound = KSL_MULF(1.192093e-07f, Ro_21_size + 1.9721523e-31f),
      Ro_22_bound = KSL_MULF(1.192093e-07f, Ro_22_size + 1.9721523e-31f);
  const float R_m00 = R->m00;
  const float R_m10 = R->m10;
  const float R_m20 = R->m20;
  Ro->m00 = R_m00;
  Ro->m01 = Ro_01;
  Ro->m02 = Ro_02;
  Ro->m10 = R_m10;
  Ro->m11 = Ro_11;
  Ro->m12 = Ro_12;
  Ro->m20 = R_m20;
  Ro->m21 = Ro_21;
  Ro->m22 = Ro_22;
  Ro_bound->m00 = 0.0f;
  Ro_bound->m01 = Ro_01_bound;
  Ro_bound->m02 = Ro_02_bound;
  Ro_bound->m10 = 0.0f;
  Ro_bound->m11 = Ro_11_bound;
  Ro_bound->m12 = Ro_12_bound;
  Ro_bound->m20 = 0.0f;
  Ro_bound->m21 = Ro_21_bound;
  Ro_bound->m22 = Ro_22_bound;
}

/* Do = D [R_x(θ) | 0], dc = (sin θ, cos θ); |error of Do| <= Do_bound unless inf or NaN.
   D, Do, Do_bound: displacement [R | t], R rotation, t in m; dc: (sin θ, cos θ).
   18 mul, 18 add, 12 abs. */
static inline void ksl_product_ddrxf_certified(const ksl_SE3f_t *D, const float dc[2],
    ksl_SE3f_t *Do, ksl_SE3f_t *Do_bound) {
  const float Do_01a = KSL_MULF(D->m01, dc[1]), Do_01b = KSL_MULF(D->m02, dc[0]),
      Do_01 = Do_01a + Do_01b;
  const float Do_02a = KSL_MULF(D->m02, dc[1]), Do_02b = KSL_MULF(D->m01, dc[0]),
      Do_02 = Do_02a - Do_02b;
  const float Do_11a = KSL_MULF(D->m11, dc[1]), Do_11b = KSL_MULF(D->m12, dc[0]),
      Do_11 = Do_11a + Do_11b;
  const float Do_12a = KSL_MULF(D->m12, dc[1]), Do_12b = KSL_MULF(D->m11, dc[0]),
      Do_12 = Do_12a - Do_12b;
  const float Do_21a = KSL_MULF(D->m21, dc[1]), Do_21b = KSL_MULF(D->m22, dc[0]),
      Do_21 = Do_21a + Do_21b;
  const float Do_22a = KSL_MULF(D->m22, dc[1]), Do_22b = KSL_MULF(D->m21, dc[0]),
      Do_22 = Do_22a - Do_22b;
  const float Do_01_size = fabsf(Do_01a) + fabsf(Do_01b),
      Do_02_size = fabsf(Do_02a) + fabsf(Do_02b), Do_11_size = fabsf(Do_11a) + fabsf(Do_11b),
      Do_12_size = fabsf(Do_12a) + fabsf(Do_12b), Do_21_size = fabsf(Do_21a) + fabsf(Do_21b),
      Do_22_size = fabsf(Do_22a) + fabsf(Do_22b);
  const float Do_01_bound = KSL_MULF(1.192093e-07f, Do_01_size + 1.9721523e-31f),
      Do_02_bound = KSL_MULF(1.192093e-07f, Do_02_size + 1.9721523e-31f),
      Do_11_bound = KSL_MULF(1.192093e-07f, Do_11_size + 1.9721523e-31f),
      Do_12_bound = KSL_MULF(1.192093e-07f, Do_12_size + 1.9721523e-31f),
      Do_21_bound = KSL_MULF(1.192093e-07f, Do_21_size + 1.9721523e-31f),
      Do_22_bound = KSL_MULF(1.192093e-07f, Do_22_size + 1.9721523e-31f);
  const float D_m00 = D->m00;
  const float D_m03 = D->m03;
  const float D_m10 = D->m10;
  const float D_m13 = D->m13;
  const float D_m20 = D->m20;
  const float D_m23 = D->m23;
  Do->m00 = D_m00;
  Do->m01 = Do_01;
  Do->m02 = Do_02;
  Do->m03 = D_m03;
  Do->m10 = D_m10;
  Do->m11 = Do_11;
  Do->m12 = Do_12;
  Do->m13 = D_m13;
  Do->m20 = D_m20;
  Do->m21 = Do_21;
  Do->m22 = Do_22;
  Do->m23 = D_m23;
  Do_bound->m00 = 0.0f;
  Do_bound->m01 = Do_01_bound;
  Do_bound->m02 = Do_02_bound;
  Do_bound->m03 = 0.0f;
  Do_bound->m10 = 0.0f;
  Do_bound->m11 = Do_11_bound;
  Do_bound->m12 = Do_12_bound;
  Do_bound->m13 = 0.0f;
  Do_bound->m20 = 0.0f;
  Do_bound->m21 = Do_21_bound;
  Do_bound->m22 = Do_22_bound;
  Do_bound->m23 = 0.0f;
}

/* Do = D [I | k e_x]; |error of Do| <= Do_bound unless inf or NaN.
   D, Do, Do_bound: displacement [R | t], R rotation, t in m; k: number.
   6 mul, 9 add, 6 abs. */
static inline void ksl_product_ddtxf_certified(const ksl_SE3f_t *D, const float k, ksl_SE3f_t *Do,
    ksl_SE3f_t *Do_bound) {
  const float Do_03a = KSL_MULF(D->m00, k), Do_03 = Do_03a + D->m03;
  const float Do_13a = KSL_MULF(D->m10, k), Do_13 = Do_13a + D->m13;
  const float Do_23a = KSL_MULF(D->m20, k), Do_23 = Do_23a + D->m23;
  const float Do_03_size = fabsf(Do_03a) + fabsf(D->m03),
      Do_13_size = fabsf(Do_13a) + fabsf(D->m13), Do_23_size = fabsf(Do_23a) + fabsf(D->m23);
  const float Do_03_bound = KSL_MULF(1.192093e-07f, Do_03_size + 1.9721523e-31f),
      Do_13_bound = KSL_MULF(1.192093e-07f, Do_13_size + 1.9721523e-31f),
      Do_23_bound = KSL_MULF(1.192093e-07f, Do_23_size + 1.9721523e-31f);
  const float D_m00 = D->m00;
  const float D_m01 = D->m01;
  const float D_m02 = D->m02;
  const float D_m10 = D->m10;
  const float D_m11 = D->m11;
  const float D_m12 = D->m12;
  const float D_m20 = D->m20;
  const float D_m21 = D->m21;
  const float D_m22 = D->m22;
  Do->m00 = D_m00;
  Do->m01 = D_m01;
  Do->m02 = D_m02;
  Do->m03 = Do_03;
  Do->m10 = D_m10;
  Do->m11 = D_m11;
  Do->m12 = D_m12;
  Do->m13 = Do_13;
  Do->m20 = D_m20;
  Do->m21 = D_m21;
  Do->m22 = D_m22;
  Do->m23 = Do_23;
  Do_bound->m00 = 0.0f;
  Do_bound->m01 = 0.0f;
  Do_bound->m02 = 0.0f;
  Do_bound->m03 = Do_03_bound;
  Do_bound->m10 = 0.0f;
  Do_bound->m11 = 0.0f;
  Do_bound->m12 = 0.0f;
  Do_bound->m13 = Do_13_bound;
  Do_bound->m20 = 0.0f;
  Do_bound->m21 = 0.0f;
  Do_bound->m22 = 0.0f;
  Do_bound->m23 = Do_23_bound;
}

/* vo = R (-k e_x); |error of vo| <= vo_bound unless inf or NaN.
   R: rotation or other 3×3 matrix; k: number; vo, vo_bound: vector.
   6 mul, 3 add, 3 neg, 3 abs. */
static inline void ksl_product_drvtxinvf_certified(const ksl_mat3x3f_t *R, const float k,
    ksl_vec3f_t *vo, ksl_vec3f_t *vo_bound) {
  const float vo_0a = KSL_MULF(R->m00, k), vo_0 = -vo_0a;
  const float vo_1a = KSL_MULF(R->m10, k), vo_1 = -vo_1a;
  const float vo_2a = KSL_MULF(R->m20, k), vo_2 = -vo_2a;
  const float vo_0a_bound = KSL_MULF(5.960465e-08f, fabsf(vo_0a) + 1.9721523e-31f);
  const float vo_1a_bound = KSL_MULF(5.960465e-08f, fabsf(vo_1a) + 1.9721523e-31f);
  const float vo_2a_bound = KSL_MULF(5.960465e-08f, fabsf(vo_2a) + 1.9721523e-31f);
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
  vo_bound->x = vo_0a_bound;
  vo_bound->y = vo_1a_bound;
  vo_bound->z = vo_2a_bound;
}

/* Ro = R R_x(-θ), dc = (sin θ, cos θ); |error of Ro| <= Ro_bound unless inf or NaN.
   R, Ro, Ro_bound: rotation or other 3×3 matrix; dc: (sin θ, cos θ).
   18 mul, 18 add, 12 abs. */
static inline void ksl_product_drdrxinvf_certified(const ksl_mat3x3f_t *R, const float dc[2],
    ksl_mat3x3f_t *Ro, ksl_mat3x3f_t *Ro_bound) {
  const float Ro_01a = KSL_MULF(R->m01, dc[1]), Ro_01b = KSL_MULF(R->m02, dc[0]),
      Ro_01 = Ro_01a - Ro_01b;
  const float Ro_02a = KSL_MULF(R->m01, dc[0]), Ro_02b = KSL_MULF(R->m02, dc[1]),
      Ro_02 = Ro_02a + Ro_02b;
  const float Ro_11a = KSL_MULF(R->m11, dc[1]), Ro_11b = KSL_MULF(R->m12, dc[0]),
      Ro_11 = Ro_11a - Ro_11b;
  const float Ro_12a = KSL_MULF(R->m11, dc[0]), Ro_12b = KSL_MULF(R->m12, dc[1]),
      Ro_12 = Ro_12a + Ro_12b;
  const float Ro_21a = KSL_MULF(R->m21, dc[1]), Ro_21b = KSL_MULF(R->m22, dc[0]),
      Ro_21 = Ro_21a - Ro_21b;
  const float Ro_22a = KSL_MULF(R->m21, dc[0]), Ro_22b = KSL_MULF(R->m22, dc[1]),
      Ro_22 = Ro_22a + Ro_22b;
  const float Ro_01_size = fabsf(Ro_01a) + fabsf(Ro_01b),
      Ro_02_size = fabsf(Ro_02a) + fabsf(Ro_02b), Ro_11_size = fabsf(Ro_11a) + fabsf(Ro_11b),
      Ro_12_size = fabsf(Ro_12a) + fabsf(Ro_12b), Ro_21_size = fabsf(Ro_21a) + fabsf(Ro_21b),
      Ro_22_size = fabsf(Ro_22a) + fabsf(Ro_22b);
  const float Ro_01_bound = KSL_MULF(1.192093e-07f, Ro_01_size + 1.9721523e-31f),
      Ro_02_bound = KSL_MULF(1.192093e-07f, Ro_02_size + 1.9721523e-31f),
      Ro_11_bound = KSL_MULF(1.192093e-07f, Ro_11_size + 1.9721523e-31f),
      Ro_12_bound = KSL_MULF(1.192093e-07f, Ro_12_size + 1.9721523e-31f),
      Ro_21_bound = KSL_MULF(1.192093e-07f, Ro_21_size + 1.9721523e-31f),
      Ro_22_bound = KSL_MULF(1.192093e-07f, Ro_22_size + 1.9721523e-31f);
  const float R_m00 = R->m00;
  const float R_m10 = R->m10;
  const float R_m20 = R->m20;
  Ro->m00 = R_m00;
  Ro->m01 = Ro_01;
  Ro->m02 = Ro_02;
  Ro->m10 = R_m10;
  Ro->m11 = Ro_11;
  Ro->m12 = Ro_12;
  Ro->m20 = R_m20;
  Ro->m21 = Ro_21;
  Ro->m22 = Ro_22;
  Ro_bound->m00 = 0.0f;
  Ro_bound->m01 = Ro_01_bound;
  Ro_bound->m02 = Ro_02_bound;
  Ro_bound->m10 = 0.0f;
  Ro_bound->m11 = Ro_11_bound;
  Ro_bound->m12 = Ro_12_bound;
  Ro_bound->m20 = 0.0f;
  Ro_bound->m21 = Ro_21_bound;
  Ro_bound->m22 = Ro_22_bound;
}

/* Do = D [R_x(-θ) | 0], dc = (sin θ, cos θ); |error of Do| <= Do_bound unless inf or NaN.
   D, Do, Do_bound: displacement [R | t], R rotation, t in m; dc: (sin θ, cos θ).
   18 mul, 18 add, 12 abs. */
static inline void ksl_product_ddrxinvf_certified(const ksl_SE3f_t *D, const float dc[2],
    ksl_SE3f_t *Do, ksl_SE3f_t *Do_bound) {
  const float Do_01a = KSL_MULF(D->m01, dc[1]), Do_01b = KSL_MULF(D->m02, dc[0]),
      Do_01 = Do_01a - Do_01b;
  const float Do_02a = KSL_MULF(D->m01, dc[0]), Do_02b = KSL_MULF(D->m02, dc[1]),
      Do_02 = Do_02a + Do_02b;
  const float Do_11a = KSL_MULF(D->m11, dc[1]), Do_11b = KSL_MULF(D->m12, dc[0]),
      Do_11 = Do_11a - Do_11b;
  const float Do_12a = KSL_MULF(D->m11, dc[0]), Do_12b = KSL_MULF(D->m12, dc[1]),
      Do_12 = Do_12a + Do_12b;
  const float Do_21a = KSL_MULF(D->m21, dc[1]), Do_21b = KSL_MULF(D->m22, dc[0]),
      Do_21 = Do_21a - Do_21b;
  const float Do_22a = KSL_MULF(D->m21, dc[0]), Do_22b = KSL_MULF(D->m22, dc[1]),
      Do_22 = Do_22a + Do_22b;
  const float Do_01_size = fabsf(Do_01a) + fabsf(Do_01b),
      Do_02_size = fabsf(Do_02a) + fabsf(Do_02b), Do_11_size = fabsf(Do_11a) + fabsf(Do_11b),
      Do_12_size = fabsf(Do_12a) + fabsf(Do_12b), Do_21_size = fabsf(Do_21a) + fabsf(Do_21b),
      Do_22_size = fabsf(Do_22a) + fabsf(Do_22b);
  const float Do_01_bound = KSL_MULF(1.192093e-07f, Do_01_size + 1.9721523e-31f),
      Do_02_bound = KSL_MULF(1.192093e-07f, Do_02_size + 1.9721523e-31f),
      Do_11_bound = KSL_MULF(1.192093e-07f, Do_11_size + 1.9721523e-31f),
      Do_12_bound = KSL_MULF(1.192093e-07f, Do_12_size + 1.9721523e-31f),
      Do_21_bound = KSL_MULF(1.192093e-07f, Do_21_size + 1.9721523e-31f),
      Do_22_bound = KSL_MULF(1.192093e-07f, Do_22_size + 1.9721523e-31f);
  const float D_m00 = D->m00;
  const float D_m03 = D->m03;
  const float D_m10 = D->m10;
  const float D_m13 = D->m13;
  const float D_m20 = D->m20;
  const float D_m23 = D->m23;
  Do->m00 = D_m00;
  Do->m01 = Do_01;
  Do->m02 = Do_02;
  Do->m03 = D_m03;
  Do->m10 = D_m10;
  Do->m11 = Do_11;
  Do->m12 = Do_12;
  Do->m13 = D_m13;
  Do->m20 = D_m20;
  Do->m21 = Do_21;
  Do->m22 = Do_22;
  Do->m23 = D_m23;
  Do_bound->m00 = 0.0f;
  Do_bound->m01 = Do_01_bound;
  Do_bound->m02 = Do_02_bound;
  Do_bound->m03 = 0.0f;
  Do_bound->m10 = 0.0f;
  Do_bound->m11 = Do_11_bound;
  Do_bound->m12 = Do_12_bound;
  Do_bound->m13 = 0.0f;
  Do_bound->m20 = 0.0f;
  Do_bound->m21 = Do_21_bound;
  Do_bound->m22 = Do_22_bound;
  Do_bound->m23 = 0.0f;
}

/* Do = D [I | -k e_x]; |error of Do| <= Do_bound unless inf or NaN.
   D, Do, Do_bound: displacement [R | t], R rotation, t in m; k: number.
   6 mul, 9 add, 6 abs. */
static inline void ksl_product_ddtxinvf_certified(const ksl_SE3f_t *D, const float k,
    ksl_SE3f_t *Do, ksl_SE3f_t *Do_bound) {
  const float Do_03a = KSL_MULF(D->m00, k), Do_03 = D->m03 - Do_03a;
  const float Do_13a = KSL_MULF(D->m10, k), Do_13 = D->m13 - Do_13a;
  const float Do_23a = KSL_MULF(D->m20, k), Do_23 = D->m23 - Do_23a;
  const float Do_03_size = fabsf(D->m03) + fabsf(Do_03a),
      Do_13_size = fabsf(D->m13) + fabsf(Do_13a), Do_23_size = fabsf(D->m23) + fabsf(Do_23a);
  const float Do_03_bound = KSL_MULF(1.192093e-07f, Do_03_size + 1.9721523e-31f),
      Do_13_bound = KSL_MULF(1.192093e-07f, Do_13_size + 1.9721523e-31f),
      Do_23_bound = KSL_MULF(1.192093e-07f, Do_23_size + 1.9721523e-31f);
  const float D_m00 = D->m00;
  const float D_m01 = D->m01;
  const float D_m02 = D->m02;
  const float D_m10 = D->m10;
  const float D_m11 = D->m11;
  const float D_m12 = D->m12;
  const float D_m20 = D->m20;
  const float D_m21 = D->m21;
  const float D_m22 = D->m22;
  Do->m00 = D_m00;
  Do->m01 = D_m01;
  Do->m02 = D_m02;
  Do->m03 = Do_03;
  Do->m10 = D_m10;
  Do->m11 = D_m11;
  Do->m12 = D_m12;
  Do->m13 = Do_13;
  Do->m20 = D_m20;
  Do->m21 = D_m21;
  Do->m22 = D_m22;
  Do->m23 = Do_23;
  Do_bound->m00 = 0.0f;
  Do_bound->m01 = 0.0f;
  Do_bound->m02 = 0.0f;
  Do_bound->m03 = Do_03_bound;
  Do_bound->m10 = 0.0f;
  Do_bound->m11 = 0.0f;
  Do_bound->m12 = 0.0f;
  Do_bound->m13 = Do_13_bound;
  Do_bound->m20 = 0.0f;
  Do_bound->m21 = 0.0f;
  Do_bound->m22 = 0.0f;
  Do_bound->m23 = Do_23_bound;
}

/* vo = R (k e_y); |error of vo| <= vo_bound unless inf or NaN.
   R: rotation or other 3×3 matrix; k: number; vo, vo_bound: vector.
   6 mul, 3 add, 3 abs. */
static inline void ksl_product_drvtyf_certified(const ksl_mat3x3f_t *R, const float k,
    ksl_vec3f_t *vo, ksl_vec3f_t *vo_bound) {
  const float vo_0 = KSL_MULF(R->m01, k), vo_1 = KSL_MULF(R->m11, k), vo_2 = KSL_MULF(R->m21, k);
  const float vo_0_bound = KSL_MULF(5.960465e-08f, fabsf(vo_0) + 1.9721523e-31f),
      vo_1_bound = KSL_MULF(5.960465e-08f, fabsf(vo_1) + 1.9721523e-31f),
      vo_2_bound = KSL_MULF(5.960465e-08f, fabsf(vo_2) + 1.9721523e-31f);
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
  vo_bound->x = vo_0_bound;
  vo_bound->y = vo_1_bound;
  vo_bound->z = vo_2_bound;
}

/* Ro = R R_y(θ), dc = (sin θ, cos θ); |error of Ro| <= Ro_bound unless inf or NaN.
   R, Ro, Ro_bound: rotation or other 3×3 matrix; dc: (sin θ, cos θ).
   18 mul, 18 add, 12 abs. */
static inline void ksl_product_drdryf_certified(const ksl_mat3x3f_t *R, const float dc[2],
    ksl_mat3x3f_t *Ro, ksl_mat3x3f_t *Ro_bound) {
  const float Ro_00a = KSL_MULF(R->m00, dc[1]), Ro_00b = KSL_MULF(R->m02, dc[0]),
      Ro_00 = Ro_00a - Ro_00b;
  const float Ro_02a = KSL_MULF(R->m00, dc[0]), Ro_02b = KSL_MULF(R->m02, dc[1]),
      Ro_02 = Ro_02a + Ro_02b;
  const float Ro_10a = KSL_MULF(R->m10, dc[1]), Ro_10b = KSL_MULF(R->m12, dc[0]),
      Ro_10 = Ro_10a - Ro_10b;
  const float Ro_12a = KSL_MULF(R->m10, dc[0]), Ro_12b = KSL_MULF(R->m12, dc[1]),
      Ro_12 = Ro_12a + Ro_12b;
  const float Ro_20a = KSL_MULF(R->m20, dc[1]), Ro_20b = KSL_MULF(R->m22, dc[0]),
      Ro_20 = Ro_20a - Ro_20b;
  const float Ro_22a = KSL_MULF(R->m20, dc[0]), Ro_22b = KSL_MULF(R->m22, dc[1]),
      Ro_22 = Ro_22a + Ro_22b;
  const float Ro_00_size = fabsf(Ro_00a) + fabsf(Ro_00b),
      Ro_02_size = fabsf(Ro_02a) + fabsf(Ro_02b), Ro_10_size = fabsf(Ro_10a) + fabsf(Ro_10b),
      Ro_12_size = fabsf(Ro_12a) + fabsf(Ro_12b), Ro_20_size = fabsf(Ro_20a) + fabsf(Ro_20b),
      Ro_22_size = fabsf(Ro_22a) + fabsf(Ro_22b);
  const float Ro_00_bound = KSL_MULF(1.192093e-07f, Ro_00_size + 1.9721523e-31f),
      Ro_02_bound = KSL_MULF(1.192093e-07f, Ro_02_size + 1.9721523e-31f),
      Ro_10_bound = KSL_MULF(1.192093e-07f, Ro_10_size + 1.9721523e-31f),
      Ro_12_bound = KSL_MULF(1.192093e-07f, Ro_12_size + 1.9721523e-31f),
      Ro_20_bound = KSL_MULF(1.192093e-07f, Ro_20_size + 1.9721523e-31f),
      Ro_22_bound = KSL_MULF(1.192093e-07f, Ro_22_size + 1.9721523e-31f);
  const float R_m01 = R->m01;
  const float R_m11 = R->m11;
  const float R_m21 = R->m21;
  Ro->m00 = Ro_00;
  Ro->m01 = R_m01;
  Ro->m02 = Ro_02;
  Ro->m10 = Ro_10;
  Ro->m11 = R_m11;
  Ro->m12 = Ro_12;
  Ro->m20 = Ro_20;
  Ro->m21 = R_m21;
  Ro->m22 = Ro_22;
  Ro_bound->m00 = Ro_00_bound;
  Ro_bound->m01 = 0.0f;
  Ro_bound->m02 = Ro_02_bound;
  Ro_bound->m10 = Ro_10_bound;
  Ro_bound->m11 = 0.0f;
  Ro_bound->m12 = Ro_12_bound;
  Ro_bound->m20 = Ro_20_bound;
  Ro_bound->m21 = 0.0f;
  Ro_bound->m22 = Ro_22_bound;
}

/* Do = D [R_y(θ) | 0], dc = (sin θ, cos θ); |error of Do| <= Do_bound unless inf or NaN.
   D, Do, Do_bound: displacement [R | t], R rotation, t in m; dc: (sin θ, cos θ).
   18 mul, 18 add, 12 abs. */
static inline void ksl_product_ddryf_certified(const ksl_SE3f_t *D, const float dc[2],
    ksl_SE3f_t *Do, ksl_SE3f_t *Do_bound) {
  const float Do_00a = KSL_MULF(D->m00, dc[1]), Do_00b = KSL_MULF(D->m02, dc[0]),
      Do_00 = Do_00a - Do_00b;
  const float Do_02a = KSL_MULF(D->m00, dc[0]), Do_02b = KSL_MULF(D->m02, dc[1]),
      Do_02 = Do_02a + Do_02b;
  const float Do_10a = KSL_MULF(D->m10, dc[1]), Do_10b = KSL_MULF(D->m12, dc[0]),
      Do_10 = Do_10a - Do_10b;
  const float Do_12a = KSL_MULF(D->m10, dc[0]), Do_12b = KSL_MULF(D->m12, dc[1]),
      Do_12 = Do_12a + Do_12b;
  const float Do_20a = KSL_MULF(D->m20, dc[1]), Do_20b = KSL_MULF(D->m22, dc[0]),
      Do_20 = Do_20a - Do_20b;
  const float Do_22a = KSL_MULF(D->m20, dc[0]), Do_22b = KSL_MULF(D->m22, dc[1]),
      Do_22 = Do_22a + Do_22b;
  const float Do_00_size = fabsf(Do_00a) + fabsf(Do_00b),
      Do_02_size = fabsf(Do_02a) + fabsf(Do_02b), Do_10_size = fabsf(Do_10a) + fabsf(Do_10b),
      Do_12_size = fabsf(Do_12a) + fabsf(Do_12b), Do_20_size = fabsf(Do_20a) + fabsf(Do_20b),
      Do_22_size = fabsf(Do_22a) + fabsf(Do_22b);
  const float Do_00_bound = KSL_MULF(1.192093e-07f, Do_00_size + 1.9721523e-31f),
      Do_02_bound = KSL_MULF(1.192093e-07f, Do_02_size + 1.9721523e-31f),
      Do_10_bound = KSL_MULF(1.192093e-07f, Do_10_size + 1.9721523e-31f),
      Do_12_bound = KSL_MULF(1.192093e-07f, Do_12_size + 1.9721523e-31f),
      Do_20_bound = KSL_MULF(1.192093e-07f, Do_20_size + 1.9721523e-31f),
      Do_22_bound = KSL_MULF(1.192093e-07f, Do_22_size + 1.9721523e-31f);
  const float D_m01 = D->m01;
  const float D_m03 = D->m03;
  const float D_m11 = D->m11;
  const float D_m13 = D->m13;
  const float D_m21 = D->m21;
  const float D_m23 = D->m23;
  Do->m00 = Do_00;
  Do->m01 = D_m01;
  Do->m02 = Do_02;
  Do->m03 = D_m03;
  Do->m10 = Do_10;
  Do->m11 = D_m11;
  Do->m12 = Do_12;
  Do->m13 = D_m13;
  Do->m20 = Do_20;
  Do->m21 = D_m21;
  Do->m22 = Do_22;
  Do->m23 = D_m23;
  Do_bound->m00 = Do_00_bound;
  Do_bound->m01 = 0.0f;
  Do_bound->m02 = Do_02_bound;
  Do_bound->m03 = 0.0f;
  Do_bound->m10 = Do_10_bound;
  Do_bound->m11 = 0.0f;
  Do_bound->m12 = Do_12_bound;
  Do_bound->m13 = 0.0f;
  Do_bound->m20 = Do_20_bound;
  Do_bound->m21 = 0.0f;
  Do_bound->m22 = Do_22_bound;
  Do_bound->m23 = 0.0f;
}

/* Do = D [I | k e_y]; |error of Do| <= Do_bound unless inf or NaN.
   D, Do, Do_bound: displacement [R | t], R rotation, t in m; k: number.
   6 mul, 9 add, 6 abs. */
static inline void ksl_product_ddtyf_certified(const ksl_SE3f_t *D, const float k, ksl_SE3f_t *Do,
    ksl_SE3f_t *Do_bound) {
  const float Do_03a = KSL_MULF(D->m01, k), Do_03 = Do_03a + D->m03;
  const float Do_13a = KSL_MULF(D->m11, k), Do_13 = Do_13a + D->m13;
  const float Do_23a = KSL_MULF(D->m21, k), Do_23 = Do_23a + D->m23;
  const float Do_03_size = fabsf(Do_03a) + fabsf(D->m03),
      Do_13_size = fabsf(Do_13a) + fabsf(D->m13), Do_23_size = fabsf(Do_23a) + fabsf(D->m23);
  const float Do_03_bound = KSL_MULF(1.192093e-07f, Do_03_size + 1.9721523e-31f),
      Do_13_bound = KSL_MULF(1.192093e-07f, Do_13_size + 1.9721523e-31f),
      Do_23_bound = KSL_MULF(1.192093e-07f, Do_23_size + 1.9721523e-31f);
  const float D_m00 = D->m00;
  const float D_m01 = D->m01;
  const float D_m02 = D->m02;
  const float D_m10 = D->m10;
  const float D_m11 = D->m11;
  const float D_m12 = D->m12;
  const float D_m20 = D->m20;
  const float D_m21 = D->m21;
  const float D_m22 = D->m22;
  Do->m00 = D_m00;
  Do->m01 = D_m01;
  Do->m02 = D_m02;
  Do->m03 = Do_03;
  Do->m10 = D_m10;
  Do->m11 = D_m11;
  Do->m12 = D_m12;
  Do->m13 = Do_13;
  Do->m20 = D_m20;
  Do->m21 = D_m21;
  Do->m22 = D_m22;
  Do->m23 = Do_23;
  Do_bound->m00 = 0.0f;
  Do_bound->m01 = 0.0f;
  Do_bound->m02 = 0.0f;
  Do_bound->m03 = Do_03_bound;
  Do_bound->m10 = 0.0f;
  Do_bound->m11 = 0.0f;
  Do_bound->m12 = 0.0f;
  Do_bound->m13 = Do_13_bound;
  Do_bound->m20 = 0.0f;
  Do_bound->m21 = 0.0f;
  Do_bound->m22 = 0.0f;
  Do_bound->m23 = Do_23_bound;
}

/* vo = R (-k e_y); |error of vo| <= vo_bound unless inf or NaN.
   R: rotation or other 3×3 matrix; k: number; vo, vo_bound: vector.
   6 mul, 3 add, 3 neg, 3 abs. */
static inline void ksl_product_drvtyinvf_certified(const ksl_mat3x3f_t *R, const float k,
    ksl_vec3f_t *vo, ksl_vec3f_t *vo_bound) {
  const float vo_0a = KSL_MULF(R->m01, k), vo_0 = -vo_0a;
  const float vo_1a = KSL_MULF(R->m11, k), vo_1 = -vo_1a;
  const float vo_2a = KSL_MULF(R->m21, k), vo_2 = -vo_2a;
  const float vo_0a_bound = KSL_MULF(5.960465e-08f, fabsf(vo_0a) + 1.9721523e-31f);
  const float vo_1a_bound = KSL_MULF(5.960465e-08f, fabsf(vo_1a) + 1.9721523e-31f);
  const float vo_2a_bound = KSL_MULF(5.960465e-08f, fabsf(vo_2a) + 1.9721523e-31f);
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
  vo_bound->x = vo_0a_bound;
  vo_bound->y = vo_1a_bound;
  vo_bound->z = vo_2a_bound;
}

/* Ro = R R_y(-θ), dc = (sin θ, cos θ); |error of Ro| <= Ro_bound unless inf or NaN.
   R, Ro, Ro_bound: rotation or other 3×3 matrix; dc: (sin θ, cos θ).
   18 mul, 18 add, 12 abs. */
static inline void ksl_product_drdryinvf_certified(const ksl_mat3x3f_t *R, const float dc[2],
    ksl_mat3x3f_t *Ro, ksl_mat3x3f_t *Ro_bound) {
  const float Ro_00a = KSL_MULF(R->m00, dc[1]), Ro_00b = KSL_MULF(R->m02, dc[0]),
      Ro_00 = Ro_00a + Ro_00b;
  const float Ro_02a = KSL_MULF(R->m02, dc[1]), Ro_02b = KSL_MULF(R->m00, dc[0]),
      Ro_02 = Ro_02a - Ro_02b;
  const float Ro_10a = KSL_MULF(R->m10, dc[1]), Ro_10b = KSL_MULF(R->m12, dc[0]),
      Ro_10 = Ro_10a + Ro_10b;
  const float Ro_12a = KSL_MULF(R->m12, dc[1]), Ro_12b = KSL_MULF(R->m10, dc[0]),
      Ro_12 = Ro_12a - Ro_12b;
  const float Ro_20a = KSL_MULF(R->m20, dc[1]), Ro_20b = KSL_MULF(R->m22, dc[0]),
      Ro_20 = Ro_20a + Ro_20b;
  const float Ro_22a = KSL_MULF(R->m22, dc[1]), Ro_22b = KSL_MULF(R->m20, dc[0]),
      Ro_22 = Ro_22a - Ro_22b;
  const float Ro_00_size = fabsf(Ro_00a) + fabsf(Ro_00b),
      Ro_02_size = fabsf(Ro_02a) + fabsf(Ro_02b), Ro_10_size = fabsf(Ro_10a) + fabsf(Ro_10b),
      Ro_12_size = fabsf(Ro_12a) + fabsf(Ro_12b), Ro_20_size = fabsf(Ro_20a) + fabsf(Ro_20b),
      Ro_22_size = fabsf(Ro_22a) + fabsf(Ro_22b);
  const float Ro_00_bound = KSL_MULF(1.192093e-07f, Ro_00_size + 1.9721523e-31f),
      Ro_02_bound = KSL_MULF(1.192093e-07f, Ro_02_size + 1.9721523e-31f),
      Ro_10_bound = KSL_MULF(1.192093e-07f, Ro_10_size + 1.9721523e-31f),
      Ro_12_bound = KSL_MULF(1.192093e-07f, Ro_12_size + 1.9721523e-31f),
      Ro_20_bound = KSL_MULF(1.192093e-07f, Ro_20_size + 1.9721523e-31f),
      Ro_22_bound = KSL_MULF(1.192093e-07f, Ro_22_size + 1.9721523e-31f);
  const float R_m01 = R->m01;
  const float R_m11 = R->m11;
  const float R_m21 = R->m21;
  Ro->m00 = Ro_00;
  Ro->m01 = R_m01;
  Ro->m02 = Ro_02;
  Ro->m10 = Ro_10;
  Ro->m11 = R_m11;
  Ro->m12 = Ro_12;
  Ro->m20 = Ro_20;
  Ro->m21 = R_m21;
  Ro->m22 = Ro_22;
  Ro_bound->m00 = Ro_00_bound;
  Ro_bound->m01 = 0.0f;
  Ro_bound->m02 = Ro_02_bound;
  Ro_bound->m10 = Ro_10_bound;
  Ro_bound->m11 = 0.0f;
  Ro_bound->m12 = Ro_12_bound;
  Ro_bound->m20 = Ro_20_bound;
  Ro_bound->m21 = 0.0f;
  Ro_bound->m22 = Ro_22_bound;
}

/* Do = D [R_y(-θ) | 0], dc = (sin θ, cos θ); |error of Do| <= Do_bound unless inf or NaN.
   D, Do, Do_bound: displacement [R | t], R rotation, t in m; dc: (sin θ, cos θ).
   18 mul, 18 add, 12 abs. */
static inline void ksl_product_ddryinvf_certified(const ksl_SE3f_t *D, const float dc[2],
    ksl_SE3f_t *Do, ksl_SE3f_t *Do_bound) {
  const float Do_00a = KSL_MULF(D->m00, dc[1]), Do_00b = KSL_MULF(D->m02, dc[0]),
      Do_00 = Do_00a + Do_00b;
  const float Do_02a = KSL_MULF(D->m02, dc[1]), Do_02b = KSL_MULF(D->m00, dc[0]),
      Do_02 = Do_02a - Do_02b;
  const float Do_10a = KSL_MULF(D->m10, dc[1]), Do_10b = KSL_MULF(D->m12, dc[0]),
      Do_10 = Do_10a + Do_10b;
  const float Do_12a = KSL_MULF(D->m12, dc[1]), Do_12b = KSL_MULF(D->m10, dc[0]),
      Do_12 = Do_12a - Do_12b;
  const float Do_20a = KSL_MULF(D->m20, dc[1]), Do_20b = KSL_MULF(D->m22, dc[0]),
      Do_20 = Do_20a + Do_20b;
  const float Do_22a = KSL_MULF(D->m22, dc[1]), Do_22b = KSL_MULF(D->m20, dc[0]),
      Do_22 = Do_22a - Do_22b;
  const float Do_00_size = fabsf(Do_00a) + fabsf(Do_00b),
      Do_02_size = fabsf(Do_02a) + fabsf(Do_02b), Do_10_size = fabsf(Do_10a) + fabsf(Do_10b),
      Do_12_size = fabsf(Do_12a) + fabsf(Do_12b), Do_20_size = fabsf(Do_20a) + fabsf(Do_20b),
      Do_22_size = fabsf(Do_22a) + fabsf(Do_22b);
  const float Do_00_bound = KSL_MULF(1.192093e-07f, Do_00_size + 1.9721523e-31f),
      Do_02_bound = KSL_MULF(1.192093e-07f, Do_02_size + 1.9721523e-31f),
      Do_10_bound = KSL_MULF(1.192093e-07f, Do_10_size + 1.9721523e-31f),
      Do_12_bound = KSL_MULF(1.192093e-07f, Do_12_size + 1.9721523e-31f),
      Do_20_bound = KSL_MULF(1.192093e-07f, Do_20_size + 1.9721523e-31f),
      Do_22_bound = KSL_MULF(1.192093e-07f, Do_22_size + 1.9721523e-31f);
  const float D_m01 = D->m01;
  const float D_m03 = D->m03;
  const float D_m11 = D->m11;
  const float D_m13 = D->m13;
  const float D_m21 = D->m21;
  const float D_m23 = D->m23;
  Do->m00 = Do_00;
  Do->m01 = D_m01;
  Do->m02 = Do_02;
  Do->m03 = D_m03;
  Do->m10 = Do_10;
  Do->m11 = D_m11;
  Do->m12 = Do_12;
  Do->m13 = D_m13;
  Do->m20 = Do_20;
  Do->m21 = D_m21;
  Do->m22 = Do_22;
  Do->m23 = D_m23;
  Do_bound->m00 = Do_00_bound;
  Do_bound->m01 = 0.0f;
  Do_bound->m02 = Do_02_bound;
  Do_bound->m03 = 0.0f;
  Do_bound->m10 = Do_10_bound;
  Do_bound->m11 = 0.0f;
  Do_bound->m12 = Do_12_bound;
  Do_bound->m13 = 0.0f;
  Do_bound->m20 = Do_20_bound;
  Do_bound->m21 = 0.0f;
  Do_bound->m22 = Do_22_bound;
  Do_bound->m23 = 0.0f;
}

/* Do = D [I | -k e_y]; |error of Do| <= Do_bound unless inf or NaN.
   D, Do, Do_bound: displacement [R | t], R rotation, t in m; k: number.
   6 mul, 9 add, 6 abs. */
static inline void ksl_product_ddtyinvf_certified(const ksl_SE3f_t *D, const float k,
    ksl_SE3f_t *Do, ksl_SE3f_t *Do_bound) {
  const float Do_03a = KSL_MULF(D->m01, k), Do_03 = D->m03 - Do_03a;
  const float Do_13a = KSL_MULF(D->m11, k), Do_13 = D->m13 - Do_13a;
  const float Do_23a = KSL_MULF(D->m21, k), Do_23 = D->m23 - Do_23a;
  const float Do_03_size = fabsf(D->m03) + fabsf(Do_03a),
      Do_13_size = fabsf(D->m13) + fabsf(Do_13a), Do_23_size = fabsf(D->m23) + fabsf(Do_23a);
  const float Do_03_bound = KSL_MULF(1.192093e-07f, Do_03_size + 1.9721523e-31f),
      Do_13_bound = KSL_MULF(1.192093e-07f, Do_13_size + 1.9721523e-31f),
      Do_23_bound = KSL_MULF(1.192093e-07f, Do_23_size + 1.9721523e-31f);
  const float D_m00 = D->m00;
  const float D_m01 = D->m01;
  const float D_m02 = D->m02;
  const float D_m10 = D->m10;
  const float D_m11 = D->m11;
  const float D_m12 = D->m12;
  const float D_m20 = D->m20;
  const float D_m21 = D->m21;
  const float D_m22 = D->m22;
  Do->m00 = D_m00;
  Do->m01 = D_m01;
  Do->m02 = D_m02;
  Do->m03 = Do_03;
  Do->m10 = D_m10;
  Do->m11 = D_m11;
  Do->m12 = D_m12;
  Do->m13 = Do_13;
  Do->m20 = D_m20;
  Do->m21 = D_m21;
  Do->m22 = D_m22;
  Do->m23 = Do_23;
  Do_bound->m00 = 0.0f;
  Do_bound->m01 = 0.0f;
  Do_bound->m02 = 0.0f;
  Do_bound->m03 = Do_03_bound;
  Do_bound->m10 = 0.0f;
  Do_bound->m11 = 0.0f;
  Do_bound->m12 = 0.0f;
  Do_bound->m13 = Do_13_bound;
  Do_bound->m20 = 0.0f;
  Do_bound->m21 = 0.0f;
  Do_bound->m22 = 0.0f;
  Do_bound->m23 = Do_23_bound;
}

/* vo = R (k e_z); |error of vo| <= vo_bound unless inf or NaN.
   R: rotation or other 3×3 matrix; k: number; vo, vo_bound: vector.
   6 mul, 3 add, 3 abs. */
static inline void ksl_product_drvtzf_certified(const ksl_mat3x3f_t *R, const float k,
    ksl_vec3f_t *vo, ksl_vec3f_t *vo_bound) {
  const float vo_0 = KSL_MULF(R->m02, k), vo_1 = KSL_MULF(R->m12, k), vo_2 = KSL_MULF(R->m22, k);
  const float vo_0_bound = KSL_MULF(5.960465e-08f, fabsf(vo_0) + 1.9721523e-31f),
      vo_1_bound = KSL_MULF(5.960465e-08f, fabsf(vo_1) + 1.9721523e-31f),
      vo_2_bound = KSL_MULF(5.960465e-08f, fabsf(vo_2) + 1.9721523e-31f);
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
  vo_bound->x = vo_0_bound;
  vo_bound->y = vo_1_bound;
  vo_bound->z = vo_2_bound;
}

/* Ro = R R_z(θ), dc = (sin θ, cos θ); |error of Ro| <= Ro_bound unless inf or NaN.
   R, Ro, Ro_bound: rotation or other 3×3 matrix; dc: (sin θ, cos θ).
   18 mul, 18 add, 12 abs. */
static inline void ksl_product_drdrzf_certified(const ksl_mat3x3f_t *R, const float dc[2],
    ksl_mat3x3f_t *Ro, ksl_mat3x3f_t *Ro_bound) {
  const float Ro_00a = KSL_MULF(R->m00, dc[1]), Ro_00b = KSL_MULF(R->m01, dc[0]),
      Ro_00 = Ro_00a + Ro_00b;
  const float Ro_01a = KSL_MULF(R->m01, dc[1]), Ro_01b = KSL_MULF(R->m00, dc[0]),
      Ro_01 = Ro_01a - Ro_01b;
  const float Ro_10a = KSL_MULF(R->m10, dc[1]), Ro_10b = KSL_MULF(R->m11, dc[0]),
      Ro_10 = Ro_10a + Ro_10b;
  const float Ro_11a = KSL_MULF(R->m11, dc[1]), Ro_11b = KSL_MULF(R->m10, dc[0]),
      Ro_11 = Ro_11a - Ro_11b;
  const float Ro_20a = KSL_MULF(R->m20, dc[1]), Ro_20b = KSL_MULF(R->m21, dc[0]),
      Ro_20 = Ro_20a + Ro_20b;
  const float Ro_21a = KSL_MULF(R->m21, dc[1]), Ro_21b = KSL_MULF(R->m20, dc[0]),
      Ro_21 = Ro_21a - Ro_21b;
  const float Ro_00_size = fabsf(Ro_00a) + fabsf(Ro_00b),
      Ro_01_size = fabsf(Ro_01a) + fabsf(Ro_01b), Ro_10_size = fabsf(Ro_10a) + fabsf(Ro_10b),
      Ro_11_size = fabsf(Ro_11a) + fabsf(Ro_11b), Ro_20_size = fabsf(Ro_20a) + fabsf(Ro_20b),
      Ro_21_size = fabsf(Ro_21a) + fabsf(Ro_21b);
  const float Ro_00_bound = KSL_MULF(1.192093e-07f, Ro_00_size + 1.9721523e-31f),
      Ro_01_bound = KSL_MULF(1.192093e-07f, Ro_01_size + 1.9721523e-31f),
      Ro_10_bound = KSL_MULF(1.192093e-07f, Ro_10_size + 1.9721523e-31f),
      Ro_11_bound = KSL_MULF(1.192093e-07f, Ro_11_size + 1.9721523e-31f),
      Ro_20_bound = KSL_MULF(1.192093e-07f, Ro_20_size + 1.9721523e-31f),
      Ro_21_bound = KSL_MULF(1.192093e-07f, Ro_21_size + 1.9721523e-31f);
  const float R_m02 = R->m02;
  const float R_m12 = R->m12;
  const float R_m22 = R->m22;
  Ro->m00 = Ro_00;
  Ro->m01 = Ro_01;
  Ro->m02 = R_m02;
  Ro->m10 = Ro_10;
  Ro->m11 = Ro_11;
  Ro->m12 = R_m12;
  Ro->m20 = Ro_20;
  Ro->m21 = Ro_21;
  Ro->m22 = R_m22;
  Ro_bound->m00 = Ro_00_bound;
  Ro_bound->m01 = Ro_01_bound;
  Ro_bound->m02 = 0.0f;
  Ro_bound->m10 = Ro_10_bound;
  Ro_bound->m11 = Ro_11_bound;
  Ro_bound->m12 = 0.0f;
  Ro_bound->m20 = Ro_20_bound;
  Ro_bound->m21 = Ro_21_bound;
  Ro_bound->m22 = 0.0f;
}

/* Do = D [R_z(θ) | 0], dc = (sin θ, cos θ); |error of Do| <= Do_bound unless inf or NaN.
   D, Do, Do_bound: displacement [R | t], R rotation, t in m; dc: (sin θ, cos θ).
   18 mul, 18 add, 12 abs. */
static inline void ksl_product_ddrzf_certified(const ksl_SE3f_t *D, const float dc[2],
    ksl_SE3f_t *Do, ksl_SE3f_t *Do_bound) {
  const float Do_00a = KSL_MULF(D->m00, dc[1]), Do_00b = KSL_MULF(D->m01, dc[0]),
      Do_00 = Do_00a + Do_00b;
  const float Do_01a = KSL_MULF(D->m01, dc[1]), Do_01b = KSL_MULF(D->m00, dc[0]),
      Do_01 = Do_01a - Do_01b;
  const float Do_10a = KSL_MULF(D->m10, dc[1]), Do_10b = KSL_MULF(D->m11, dc[0]),
      Do_10 = Do_10a + Do_10b;
  const float Do_11a = KSL_MULF(D->m11, dc[1]), Do_11b = KSL_MULF(D->m10, dc[0]),
      Do_11 = Do_11a - Do_11b;
  const float Do_20a = KSL_MULF(D->m20, dc[1]), Do_20b = KSL_MULF(D->m21, dc[0]),
      Do_20 = Do_20a + Do_20b;
  const float Do_21a = KSL_MULF(D->m21, dc[1]), Do_21b = KSL_MULF(D->m20, dc[0]),
      Do_21 = Do_21a - Do_21b;
  const float Do_00_size = fabsf(Do_00a) + fabsf(Do_00b),
      Do_01_size = fabsf(Do_01a) + fabsf(Do_01b), Do_10_size = fabsf(Do_10a) + fabsf(Do_10b),
      Do_11_size = fabsf(Do_11a) + fabsf(Do_11b), Do_20_size = fabsf(Do_20a) + fabsf(Do_20b),
      Do_21_size = fabsf(Do_21a) + fabsf(Do_21b);
  const float Do_00_bound = KSL_MULF(1.192093e-07f, Do_00_size + 1.9721523e-31f),
      Do_01_bound = KSL_MULF(1.192093e-07f, Do_01_size + 1.9721523e-31f),
      Do_10_bound = KSL_MULF(1.192093e-07f, Do_10_size + 1.9721523e-31f),
      Do_11_bound = KSL_MULF(1.192093e-07f, Do_11_size + 1.9721523e-31f),
      Do_20_bound = KSL_MULF(1.192093e-07f, Do_20_size + 1.9721523e-31f),
      Do_21_bound = KSL_MULF(1.192093e-07f, Do_21_size + 1.9721523e-31f);
  const float D_m02 = D->m02;
  const float D_m03 = D->m03;
  const float D_m12 = D->m12;
  const float D_m13 = D->m13;
  const float D_m22 = D->m22;
  const float D_m23 = D->m23;
  Do->m00 = Do_00;
  Do->m01 = Do_01;
  Do->m02 = D_m02;
  Do->m03 = D_m03;
  Do->m10 = Do_10;
  Do->m11 = Do_11;
  Do->m12 = D_m12;
  Do->m13 = D_m13;
  Do->m20 = Do_20;
  Do->m21 = Do_21;
  Do->m22 = D_m22;
  Do->m23 = D_m23;
  Do_bound->m00 = Do_00_bound;
  Do_bound->m01 = Do_01_bound;
  Do_bound->m02 = 0.0f;
  Do_bound->m03 = 0.0f;
  Do_bound->m10 = Do_10_bound;
  Do_bound->m11 = Do_11_bound;
  Do_bound->m12 = 0.0f;
  Do_bound->m13 = 0.0f;
  Do_bound->m20 = Do_20_bound;
  Do_bound->m21 = Do_21_bound;
  Do_bound->m22 = 0.0f;
  Do_bound->m23 = 0.0f;
}

/* Do = D [I | k e_z]; |error of Do| <= Do_bound unless inf or NaN.
   D, Do, Do_bound: displacement [R | t], R rotation, t in m; k: number.
   6 mul, 9 add, 6 abs. */
static inline void ksl_product_ddtzf_certified(const ksl_SE3f_t *D, const float k, ksl_SE3f_t *Do,
    ksl_SE3f_t *Do_bound) {
  const float Do_03a = KSL_MULF(D->m02, k), Do_03 = Do_03a + D->m03;
  const float Do_13a = KSL_MULF(D->m12, k), Do_13 = Do_13a + D->m13;
  const float Do_23a = KSL_MULF(D->m22, k), Do_23 = Do_23a + D->m23;
  const float Do_03_size = fabsf(Do_03a) + fabsf(D->m03),
      Do_13_size = fabsf(Do_13a) + fabsf(D->m13), Do_23_size = fabsf(Do_23a) + fabsf(D->m23);
  const float Do_03_bound = KSL_MULF(1.192093e-07f, Do_03_size + 1.9721523e-31f),
      Do_13_bound = KSL_MULF(1.192093e-07f, Do_13_size + 1.9721523e-31f),
      Do_23_bound = KSL_MULF(1.192093e-07f, Do_23_size + 1.9721523e-31f);
  const float D_m00 = D->m00;
  const float D_m01 = D->m01;
  const float D_m02 = D->m02;
  const float D_m10 = D->m10;
  const float D_m11 = D->m11;
  const float D_m12 = D->m12;
  const float D_m20 = D->m20;
  const float D_m21 = D->m21;
  const float D_m22 = D->m22;
  Do->m00 = D_m00;
  Do->m01 = D_m01;
  Do->m02 = D_m02;
  Do->m03 = Do_03;
  Do->m10 = D_m10;
  Do->m11 = D_m11;
  Do->m12 = D_m12;
  Do->m13 = Do_13;
  Do->m20 = D_m20;
  Do->m21 = D_m21;
  Do->m22 = D_m22;
  Do->m23 = Do_23;
  Do_bound->m00 = 0.0f;
  Do_bound->m01 = 0.0f;
  Do_bound->m02 = 0.0f;
  Do_bound->m03 = Do_03_bound;
  Do_bound->m10 = 0.0f;
  Do_bound->m11 = 0.0f;
  Do_bound->m12 = 0.0f;
  Do_bound->m13 = Do_13_bound;
  Do_bound->m20 = 0.0f;
  Do_bound->m21 = 0.0f;
  Do_bound->m22 = 0.0f;
  Do_bound->m23 = Do_23_bound;
}

/* vo = R (-k e_z); |error of vo| <= vo_bound unless inf or NaN.
   R: rotation or other 3×3 matrix; k: number; vo, vo_bound: vector.
   6 mul, 3 add, 3 neg, 3 abs. */
static inline void ksl_product_drvtzinvf_certified(const ksl_mat3x3f_t *R, const float k,
    ksl_vec3f_t *vo, ksl_vec3f_t *vo_bound) {
  const float vo_0a = KSL_MULF(R->m02, k), vo_0 = -vo_0a;
  const float vo_1a = KSL_MULF(R->m12, k), vo_1 = -vo_1a;
  const float vo_2a = KSL_MULF(R->m22, k), vo_2 = -vo_2a;
  const float vo_0a_bound = KSL_MULF(5.960465e-08f, fabsf(vo_0a) + 1.9721523e-31f);
  const float vo_1a_bound = KSL_MULF(5.960465e-08f, fabsf(vo_1a) + 1.9721523e-31f);
  const float vo_2a_bound = KSL_MULF(5.960465e-08f, fabsf(vo_2a) + 1.9721523e-31f);
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
  vo_bound->x = vo_0a_bound;
  vo_bound->y = vo_1a_bound;
  vo_bound->z = vo_2a_bound;
}

/* Ro = R R_z(-θ), dc = (sin θ, cos θ); |error of Ro| <= Ro_bound unless inf or NaN.
   R, Ro, Ro_bound: rotation or other 3×3 matrix; dc: (sin θ, cos θ).
   18 mul, 18 add, 12 abs. */
static inline void ksl_product_drdrzinvf_certified(const ksl_mat3x3f_t *R, const float dc[2],
    ksl_mat3x3f_t *Ro, ksl_mat3x3f_t *Ro_bound) {
  const float Ro_00a = KSL_MULF(R->m00, dc[1]), Ro_00b = KSL_MULF(R->m01, dc[0]),
      Ro_00 = Ro_00a - Ro_00b;
  const float Ro_01a = KSL_MULF(R->m00, dc[0]), Ro_01b = KSL_MULF(R->m01, dc[1]),
      Ro_01 = Ro_01a + Ro_01b;
  const float Ro_10a = KSL_MULF(R->m10, dc[1]), Ro_10b = KSL_MULF(R->m11, dc[0]),
      Ro_10 = Ro_10a - Ro_10b;
  const float Ro_11a = KSL_MULF(R->m10, dc[0]), Ro_11b = KSL_MULF(R->m11, dc[1]),
      Ro_11 = Ro_11a + Ro_11b;
  const float Ro_20a = KSL_MULF(R->m20, dc[1]), Ro_20b = KSL_MULF(R->m21, dc[0]),
      Ro_20 = Ro_20a - Ro_20b;
  const float Ro_21a = KSL_MULF(R->m20, dc[0]), Ro_21b = KSL_MULF(R->m21, dc[1]),
      Ro_21 = Ro_21a + Ro_21b;
  const float Ro_00_size = fabsf(Ro_00a) + fabsf(Ro_00b),
      Ro_01_size = fabsf(Ro_01a) + fabsf(Ro_01b), Ro_10_size = fabsf(Ro_10a) + fabsf(Ro_10b),
      Ro_11_size = fabsf(Ro_11a) + fabsf(Ro_11b), Ro_20_size = fabsf(Ro_20a) + fabsf(Ro_20b),
      Ro_21_size = fabsf(Ro_21a) + fabsf(Ro_21b);
  const float Ro_00_bound = KSL_MULF(1.192093e-07f, Ro_00_size + 1.9721523e-31f),
      Ro_01_bound = KSL_MULF(1.192093e-07f, Ro_01_size + 1.9721523e-31f),
      Ro_10_bound = KSL_MULF(1.192093e-07f, Ro_10_size + 1.9721523e-31f),
      Ro_11_bound = KSL_MULF(1.192093e-07f, Ro_11_size + 1.9721523e-31f),
      Ro_20_bound = KSL_MULF(1.192093e-07f, Ro_20_size + 1.9721523e-31f),
      Ro_21_bound = KSL_MULF(1.192093e-07f, Ro_21_size + 1.9721523e-31f);
  const float R_m02 = R->m02;
  const float R_m12 = R->m12;
  const float R_m22 = R->m22;
  Ro->m00 = Ro_00;
  Ro->m01 = Ro_01;
  Ro->m02 = R_m02;
  Ro->m10 = Ro_10;
  Ro->m11 = Ro_11;
  Ro->m12 = R_m12;
  Ro->m20 = Ro_20;
  Ro->m21 = Ro_21;
  Ro->m22 = R_m22;
  Ro_bound->m00 = Ro_00_bound;
  Ro_bound->m01 = Ro_01_bound;
  Ro_bound->m02 = 0.0f;
  Ro_bound->m10 = Ro_10_bound;
  Ro_bound->m11 = Ro_11_bound;
  Ro_bound->m12 = 0.0f;
  Ro_bound->m20 = Ro_20_bound;
  Ro_bound->m21 = Ro_21_bound;
  Ro_bound->m22 = 0.0f;
}

/* Do = D [R_z(-θ) | 0], dc = (sin θ, cos θ); |error of Do| <= Do_bound unless inf or NaN.
   D, Do, Do_bound: displacement [R | t], R rotation, t in m; dc: (sin θ, cos θ).
   18 mul, 18 add, 12 abs. */
static inline void ksl_product_ddrzinvf_certified(const ksl_SE3f_t *D, const float dc[2],
    ksl_SE3f_t *Do, ksl_SE3f_t *Do_bound) {
  const float Do_00a = KSL_MULF(D->m00, dc[1]), Do_00b = KSL_MULF(D->m01, dc[0]),
      Do_00 = Do_00a - Do_00b;
  const float Do_01a = KSL_MULF(D->m00, dc[0]), Do_01b = KSL_MULF(D->m01, dc[1]),
      Do_01 = Do_01a + Do_01b;
  const float Do_10a = KSL_MULF(D->m10, dc[1]), Do_10b = KSL_MULF(D->m11, dc[0]),
      Do_10 = Do_10a - Do_10b;
  const float Do_11a = KSL_MULF(D->m10, dc[0]), Do_11b = KSL_MULF(D->m11, dc[1]),
      Do_11 = Do_11a + Do_11b;
  const float Do_20a = KSL_MULF(D->m20, dc[1]), Do_20b = KSL_MULF(D->m21, dc[0]),
      Do_20 = Do_20a - Do_20b;
  const float Do_21a = KSL_MULF(D->m20, dc[0]), Do_21b = KSL_MULF(D->m21, dc[1]),
      Do_21 = Do_21a + Do_21b;
  const float Do_00_size = fabsf(Do_00a) + fabsf(Do_00b),
      Do_01_size = fabsf(Do_01a) + fabsf(Do_01b), Do_10_size = fabsf(Do_10a) + fabsf(Do_10b),
      Do_11_size = fabsf(Do_11a) + fabsf(Do_11b), Do_20_size = fabsf(Do_20a) + fabsf(Do_20b),
      Do_21_size = fabsf(Do_21a) + fabsf(Do_21b);
  const float Do_00_bound = KSL_MULF(1.192093e-07f, Do_00_size + 1.9721523e-31f),
      Do_01_bound = KSL_MULF(1.192093e-07f, Do_01_size + 1.9721523e-31f),
      Do_10_bound = KSL_MULF(1.192093e-07f, Do_10_size + 1.9721523e-31f),
      Do_11_bound = KSL_MULF(1.192093e-07f, Do_11_size + 1.9721523e-31f),
      Do_20_bound = KSL_MULF(1.192093e-07f, Do_20_size + 1.9721523e-31f),
      Do_21_bound = KSL_MULF(1.192093e-07f, Do_21_size + 1.9721523e-31f);
  const float D_m02 = D->m02;
  const float D_m03 = D->m03;
  const float D_m12 = D->m12;
  const float D_m13 = D->m13;
  const float D_m22 = D->m22;
  const float D_m23 = D->m23;
  Do->m00 = Do_00;
  Do->m01 = Do_01;
  Do->m02 = D_m02;
  Do->m03 = D_m03;
  Do->m10 = Do_10;
  Do->m11 = Do_11;
  Do->m12 = D_m12;
  Do->m13 = D_m13;
  Do->m20 = Do_20;
  Do->m21 = Do_21;
  Do->m22 = D_m22;
  Do->m23 = D_m23;
  Do_bound->m00 = Do_00_bound;
  Do_bound->m01 = Do_01_bound;
  Do_bound->m02 = 0.0f;
  Do_bound->m03 = 0.0f;
  Do_bound->m10 = Do_10_bound;
  Do_bound->m11 = Do_11_bound;
  Do_bound->m12 = 0.0f;
  Do_bound->m13 = 0.0f;
  Do_bound->m20 = Do_20_bound;
  Do_bound->m21 = Do_21_bound;
  Do_bound->m22 = 0.0f;
  Do_bound->m23 = 0.0f;
}

/* Do = D [I | -k e_z]; |error of Do| <= Do_bound unless inf or NaN.
   D, Do, Do_bound: displacement [R | t], R rotation, t in m; k: number.
   6 mul, 9 add, 6 abs. */
static inline void ksl_product_ddtzinvf_certified(const ksl_SE3f_t *D, const float k,
    ksl_SE3f_t *Do, ksl_SE3f_t *Do_bound) {
  const float Do_03a = KSL_MULF(D->m02, k), Do_03 = D->m03 - Do_03a;
  const float Do_13a = KSL_MULF(D->m12, k), Do_13 = D->m13 - Do_13a;
  const float Do_23a = KSL_MULF(D->m22, k), Do_23 = D->m23 - Do_23a;
  const float Do_03_size = fabsf(D->m03) + fabsf(Do_03a),
      Do_13_size = fabsf(D->m13) + fabsf(Do_13a), Do_23_size = fabsf(D->m23) + fabsf(Do_23a);
  const float Do_03_bound = KSL_MULF(1.192093e-07f, Do_03_size + 1.9721523e-31f),
      Do_13_bound = KSL_MULF(1.192093e-07f, Do_13_size + 1.9721523e-31f),
      Do_23_bound = KSL_MULF(1.192093e-07f, Do_23_size + 1.9721523e-31f);
  const float D_m00 = D->m00;
  const float D_m01 = D->m01;
  const float D_m02 = D->m02;
  const float D_m10 = D->m10;
  const float D_m11 = D->m11;
  const float D_m12 = D->m12;
  const float D_m20 = D->m20;
  const float D_m21 = D->m21;
  const float D_m22 = D->m22;
  Do->m00 = D_m00;
  Do->m01 = D_m01;
  Do->m02 = D_m02;
  Do->m03 = Do_03;
  Do->m10 = D_m10;
  Do->m11 = D_m11;
  Do->m12 = D_m12;
  Do->m13 = Do_13;
  Do->m20 = D_m20;
  Do->m21 = D_m21;
  Do->m22 = D_m22;
  Do->m23 = Do_23;
  Do_bound->m00 = 0.0f;
  Do_bound->m01 = 0.0f;
  Do_bound->m02 = 0.0f;
  Do_bound->m03 = Do_03_bound;
  Do_bound->m10 = 0.0f;
  Do_bound->m11 = 0.0f;
  Do_bound->m12 = 0.0f;
  Do_bound->m13 = Do_13_bound;
  Do_bound->m20 = 0.0f;
  Do_bound->m21 = 0.0f;
  Do_bound->m22 = 0.0f;
  Do_bound->m23 = Do_23_bound;
}

#endif
