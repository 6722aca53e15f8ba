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
  const double vo_0a = KSL_MUL(R->m00, v->x), vo_0b = KSL_MUL(R->m01, v->y), vo_0c = vo_0a + vo_0b,
      vo_0d = KSL_MUL(R->m02, v->z), vo_0 = vo_0c + vo_0d;
  const double vo_1a = KSL_MUL(R->m10, v->x), vo_1b = KSL_MUL(R->m11, v->y), vo_1c = vo_1a + vo_1b,
      vo_1d = KSL_MUL(R->m12, v->z), vo_1 = vo_1c + vo_1d;
  const double vo_2a = KSL_MUL(R->m20, v->x), vo_2b = KSL_MUL(R->m21, v->y), vo_2c = vo_2a + vo_2b,
      vo_2d = KSL_MUL(R->m22, v->z), vo_2 = vo_2c + vo_2d;
  const double vo_0a_abs = fabs(vo_0a), vo_0b_abs = fabs(vo_0b), vo_0c_size = vo_0a_abs + vo_0b_abs,
      vo_0d_abs = fabs(vo_0d), vo_0_size = vo_0c_size + vo_0d_abs;
  const double vo_1a_abs = fabs(vo_1a), vo_1b_abs = fabs(vo_1b), vo_1c_size = vo_1a_abs + vo_1b_abs,
      vo_1d_abs = fabs(vo_1d), vo_1_size = vo_1c_size + vo_1d_abs;
  const double vo_2a_abs = fabs(vo_2a), vo_2b_abs = fabs(vo_2b), vo_2c_size = vo_2a_abs + vo_2b_abs,
      vo_2d_abs = fabs(vo_2d), vo_2_size = vo_2c_size + vo_2d_abs;
  const double vo_0_padded = vo_0_size + 2.004168360008973e-292,
      vo_0_error_bound = KSL_MUL(3.3306690738754706e-16, vo_0_padded);
  const double vo_1_padded = vo_1_size + 2.004168360008973e-292,
      vo_1_error_bound = KSL_MUL(3.3306690738754706e-16, vo_1_padded);
  const double vo_2_padded = vo_2_size + 2.004168360008973e-292,
      vo_2_error_bound = KSL_MUL(3.3306690738754706e-16, vo_2_padded);
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
  vo_bound->x = vo_0_error_bound;
  vo_bound->y = vo_1_error_bound;
  vo_bound->z = vo_2_error_bound;
}

/* vo = R (-v); |error of vo| <= vo_bound unless inf or NaN.
   R: rotation or other 3×3 matrix; v, vo, vo_bound: vector.
   12 mul, 15 add, 3 neg, 9 abs. */
static inline void ksl_product_drvinv_certified(const ksl_mat3x3_t *R, const ksl_vec3_t *v,
    ksl_vec3_t *vo, ksl_vec3_t *vo_bound) {
  const double vo_0a = KSL_MUL(R->m00, v->x), vo_0b = KSL_MUL(R->m01, v->y), vo_0c = vo_0a + vo_0b,
      vo_0d = KSL_MUL(R->m02, v->z), vo_0e = vo_0c + vo_0d, vo_0 = -vo_0e;
  const double vo_1a = KSL_MUL(R->m10, v->x), vo_1b = KSL_MUL(R->m11, v->y), vo_1c = vo_1a + vo_1b,
      vo_1d = KSL_MUL(R->m12, v->z), vo_1e = vo_1c + vo_1d, vo_1 = -vo_1e;
  const double vo_2a = KSL_MUL(R->m20, v->x), vo_2b = KSL_MUL(R->m21, v->y), vo_2c = vo_2a + vo_2b,
      vo_2d = KSL_MUL(R->m22, v->z), vo_2e = vo_2c + vo_2d, vo_2 = -vo_2e;
  const double vo_0a_abs = fabs(vo_0a), vo_0b_abs = fabs(vo_0b), vo_0c_size = vo_0a_abs + vo_0b_abs,
      vo_0d_abs = fabs(vo_0d), vo_0e_size = vo_0c_size + vo_0d_abs;
  const double vo_1a_abs = fabs(vo_1a), vo_1b_abs = fabs(vo_1b), vo_1c_size = vo_1a_abs + vo_1b_abs,
      vo_1d_abs = fabs(vo_1d), vo_1e_size = vo_1c_size + vo_1d_abs;
  const double vo_2a_abs = fabs(vo_2a), vo_2b_abs = fabs(vo_2b), vo_2c_size = vo_2a_abs + vo_2b_abs,
      vo_2d_abs = fabs(vo_2d), vo_2e_size = vo_2c_size + vo_2d_abs;
  const double vo_0e_padded = vo_0e_size + 2.004168360008973e-292,
      vo_0e_error_bound = KSL_MUL(3.3306690738754706e-16, vo_0e_padded);
  const double vo_1e_padded = vo_1e_size + 2.004168360008973e-292,
      vo_1e_error_bound = KSL_MUL(3.3306690738754706e-16, vo_1e_padded);
  const double vo_2e_padded = vo_2e_size + 2.004168360008973e-292,
      vo_2e_error_bound = KSL_MUL(3.3306690738754706e-16, vo_2e_padded);
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
  vo_bound->x = vo_0e_error_bound;
  vo_bound->y = vo_1e_error_bound;
  vo_bound->z = vo_2e_error_bound;
}

/* vo = R^T v; |error of vo| <= vo_bound unless inf or NaN.
   R: rotation or other 3×3 matrix; v, vo, vo_bound: vector.
   12 mul, 15 add, 9 abs. */
static inline void ksl_product_drinvv_certified(const ksl_mat3x3_t *R, const ksl_vec3_t *v,
    ksl_vec3_t *vo, ksl_vec3_t *vo_bound) {
  const double vo_0a = KSL_MUL(R->m00, v->x), vo_0b = KSL_MUL(R->m10, v->y), vo_0c = vo_0a + vo_0b,
      vo_0d = KSL_MUL(R->m20, v->z), vo_0 = vo_0c + vo_0d;
  const double vo_1a = KSL_MUL(R->m01, v->x), vo_1b = KSL_MUL(R->m11, v->y), vo_1c = vo_1a + vo_1b,
      vo_1d = KSL_MUL(R->m21, v->z), vo_1 = vo_1c + vo_1d;
  const double vo_2a = KSL_MUL(R->m02, v->x), vo_2b = KSL_MUL(R->m12, v->y), vo_2c = vo_2a + vo_2b,
      vo_2d = KSL_MUL(R->m22, v->z), vo_2 = vo_2c + vo_2d;
  const double vo_0a_abs = fabs(vo_0a), vo_0b_abs = fabs(vo_0b), vo_0c_size = vo_0a_abs + vo_0b_abs,
      vo_0d_abs = fabs(vo_0d), vo_0_size = vo_0c_size + vo_0d_abs;
  const double vo_1a_abs = fabs(vo_1a), vo_1b_abs = fabs(vo_1b), vo_1c_size = vo_1a_abs + vo_1b_abs,
      vo_1d_abs = fabs(vo_1d), vo_1_size = vo_1c_size + vo_1d_abs;
  const double vo_2a_abs = fabs(vo_2a), vo_2b_abs = fabs(vo_2b), vo_2c_size = vo_2a_abs + vo_2b_abs,
      vo_2d_abs = fabs(vo_2d), vo_2_size = vo_2c_size + vo_2d_abs;
  const double vo_0_padded = vo_0_size + 2.004168360008973e-292,
      vo_0_error_bound = KSL_MUL(3.3306690738754706e-16, vo_0_padded);
  const double vo_1_padded = vo_1_size + 2.004168360008973e-292,
      vo_1_error_bound = KSL_MUL(3.3306690738754706e-16, vo_1_padded);
  const double vo_2_padded = vo_2_size + 2.004168360008973e-292,
      vo_2_error_bound = KSL_MUL(3.3306690738754706e-16, vo_2_padded);
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
  vo_bound->x = vo_0_error_bound;
  vo_bound->y = vo_1_error_bound;
  vo_bound->z = vo_2_error_bound;
}

/* vo = R^T (-v); |error of vo| <= vo_bound unless inf or NaN.
   R: rotation or other 3×3 matrix; v, vo, vo_bound: vector.
   12 mul, 15 add, 3 neg, 9 abs. */
static inline void ksl_product_drinvvinv_certified(const ksl_mat3x3_t *R, const ksl_vec3_t *v,
    ksl_vec3_t *vo, ksl_vec3_t *vo_bound) {
  const double vo_0a = KSL_MUL(R->m00, v->x), vo_0b = KSL_MUL(R->m10, v->y), vo_0c = vo_0a + vo_0b,
      vo_0d = KSL_MUL(R->m20, v->z), vo_0e = vo_0c + vo_0d, vo_0 = -vo_0e;
  const double vo_1a = KSL_MUL(R->m01, v->x), vo_1b = KSL_MUL(R->m11, v->y), vo_1c = vo_1a + vo_1b,
      vo_1d = KSL_MUL(R->m21, v->z), vo_1e = vo_1c + vo_1d, vo_1 = -vo_1e;
  const double vo_2a = KSL_MUL(R->m02, v->x), vo_2b = KSL_MUL(R->m12, v->y), vo_2c = vo_2a + vo_2b,
      vo_2d = KSL_MUL(R->m22, v->z), vo_2e = vo_2c + vo_2d, vo_2 = -vo_2e;
  const double vo_0a_abs = fabs(vo_0a), vo_0b_abs = fabs(vo_0b), vo_0c_size = vo_0a_abs + vo_0b_abs,
      vo_0d_abs = fabs(vo_0d), vo_0e_size = vo_0c_size + vo_0d_abs;
  const double vo_1a_abs = fabs(vo_1a), vo_1b_abs = fabs(vo_1b), vo_1c_size = vo_1a_abs + vo_1b_abs,
      vo_1d_abs = fabs(vo_1d), vo_1e_size = vo_1c_size + vo_1d_abs;
  const double vo_2a_abs = fabs(vo_2a), vo_2b_abs = fabs(vo_2b), vo_2c_size = vo_2a_abs + vo_2b_abs,
      vo_2d_abs = fabs(vo_2d), vo_2e_size = vo_2c_size + vo_2d_abs;
  const double vo_0e_padded = vo_0e_size + 2.004168360008973e-292,
      vo_0e_error_bound = KSL_MUL(3.3306690738754706e-16, vo_0e_padded);
  const double vo_1e_padded = vo_1e_size + 2.004168360008973e-292,
      vo_1e_error_bound = KSL_MUL(3.3306690738754706e-16, vo_1e_padded);
  const double vo_2e_padded = vo_2e_size + 2.004168360008973e-292,
      vo_2e_error_bound = KSL_MUL(3.3306690738754706e-16, vo_2e_padded);
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
  vo_bound->x = vo_0e_error_bound;
  vo_bound->y = vo_1e_error_bound;
  vo_bound->z = vo_2e_error_bound;
}

/* vo = R v + t; |error of vo| <= vo_bound unless inf or NaN.
   D: displacement [R | t], R rotation, t in m; v, vo, vo_bound: vector.
   12 mul, 21 add, 12 abs. */
static inline void ksl_product_dv_certified(const ksl_SE3_t *D, const ksl_vec3_t *v,
    ksl_vec3_t *vo, ksl_vec3_t *vo_bound) {
  const double vo_0a = KSL_MUL(D->m00, v->x), vo_0b = KSL_MUL(D->m01, v->y), vo_0c = vo_0a + vo_0b,
      vo_0d = KSL_MUL(D->m02, v->z), vo_0e = vo_0c + vo_0d, vo_0 = vo_0e + D->m03;
  const double vo_1a = KSL_MUL(D->m10, v->x), vo_1b = KSL_MUL(D->m11, v->y), vo_1c = vo_1a + vo_1b,
      vo_1d = KSL_MUL(D->m12, v->z), vo_1e = vo_1c + vo_1d, vo_1 = vo_1e + D->m13;
  const double vo_2a = KSL_MUL(D->m20, v->x), vo_2b = KSL_MUL(D->m21, v->y), vo_2c = vo_2a + vo_2b,
      vo_2d = KSL_MUL(D->m22, v->z), vo_2e = vo_2c + vo_2d, vo_2 = vo_2e + D->m23;
  const double vo_0a_abs = fabs(vo_0a), vo_0b_abs = fabs(vo_0b), vo_0c_size = vo_0a_abs + vo_0b_abs,
      vo_0d_abs = fabs(vo_0d), vo_0e_size = vo_0c_size + vo_0d_abs, D_03_abs = fabs(D->m03),
      vo_0_size = vo_0e_size + D_03_abs;
  const double vo_1a_abs = fabs(vo_1a), vo_1b_abs = fabs(vo_1b), vo_1c_size = vo_1a_abs + vo_1b_abs,
      vo_1d_abs = fabs(vo_1d), vo_1e_size = vo_1c_size + vo_1d_abs, D_13_abs = fabs(D->m13),
      vo_1_size = vo_1e_size + D_13_abs;
  const double vo_2a_abs = fabs(vo_2a), vo_2b_abs = fabs(vo_2b), vo_2c_size = vo_2a_abs + vo_2b_abs,
      vo_2d_abs = fabs(vo_2d), vo_2e_size = vo_2c_size + vo_2d_abs, D_23_abs = fabs(D->m23),
      vo_2_size = vo_2e_size + D_23_abs;
  const double vo_0_padded = vo_0_size + 2.004168360008973e-292,
      vo_0_error_bound = KSL_MUL(4.440892098500628e-16, vo_0_padded);
  const double vo_1_padded = vo_1_size + 2.004168360008973e-292,
      vo_1_error_bound = KSL_MUL(4.440892098500628e-16, vo_1_padded);
  const double vo_2_padded = vo_2_size + 2.004168360008973e-292,
      vo_2_error_bound = KSL_MUL(4.440892098500628e-16, vo_2_padded);
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
  vo_bound->x = vo_0_error_bound;
  vo_bound->y = vo_1_error_bound;
  vo_bound->z = vo_2_error_bound;
}

/* vo = R^T (v - t); |error of vo| <= vo_bound unless inf or NaN.
   D: displacement [R | t], R rotation, t in m; v, vo, vo_bound: vector.
   21 mul, 18 add, 12 abs. */
static inline void ksl_product_dinvv_certified(const ksl_SE3_t *D, const ksl_vec3_t *v,
    ksl_vec3_t *vo, ksl_vec3_t *vo_bound) {
  const double p_0 = v->x - D->m03;
  const double p_1 = v->y - D->m13;
  const double p_2 = v->z - D->m23;
  const double vo_0a = KSL_MUL(D->m00, p_0), vo_0b = KSL_MUL(D->m10, p_1), vo_0c = vo_0a + vo_0b,
      vo_0d = KSL_MUL(D->m20, p_2), vo_0 = vo_0c + vo_0d;
  const double vo_1a = KSL_MUL(D->m01, p_0), vo_1b = KSL_MUL(D->m11, p_1), vo_1c = vo_1a + vo_1b,
      vo_1d = KSL_MUL(D->m21, p_2), vo_1 = vo_1c + vo_1d;
  const double vo_2a = KSL_MUL(D->m02, p_0), vo_2b = KSL_MUL(D->m12, p_1), vo_2c = vo_2a + vo_2b,
      vo_2d = KSL_MUL(D->m22, p_2), vo_2 = vo_2c + vo_2d;
  const double D_00_abs = fabs(D->m00), p_0_abs = fabs(p_0),
      vo_0a_size = KSL_MUL(D_00_abs, p_0_abs), D_10_abs = fabs(D->m10), p_1_abs = fabs(p_1),
      vo_0b_size = KSL_MUL(D_10_abs, p_1_abs), vo_0c_size = vo_0a_size + vo_0b_size,
      D_20_abs = fabs(D->m20), p_2_abs = fabs(p_2), vo_0d_size = KSL_MUL(D_20_abs, p_2_abs),
      vo_0_size = vo_0c_size + vo_0d_size;
  const double D_01_abs = fabs(D->m01), vo_1a_size = KSL_MUL(D_01_abs, p_0_abs),
      D_11_abs = fabs(D->m11), vo_1b_size = KSL_MUL(D_11_abs, p_1_abs),
      vo_1c_size = vo_1a_size + vo_1b_size, D_21_abs = fabs(D->m21),
      vo_1d_size = KSL_MUL(D_21_abs, p_2_abs), vo_1_size = vo_1c_size + vo_1d_size;
  const double D_02_abs = fabs(D->m02), vo_2a_size = KSL_MUL(D_02_abs, p_0_abs),
      D_12_abs = fabs(D->m12), vo_2b_size = KSL_MUL(D_12_abs, p_1_abs),
      vo_2c_size = vo_2a_size + vo_2b_size, D_22_abs = fabs(D->m22),
      vo_2d_size = KSL_MUL(D_22_abs, p_2_abs), vo_2_size = vo_2c_size + vo_2d_size;
  const double vo_0_padded = vo_0_size + 2.004168360008973e-292,
      vo_0_error_bound = KSL_MUL(4.440892098500628e-16, vo_0_padded);
  const double vo_1_padded = vo_1_size + 2.004168360008973e-292,
      vo_1_error_bound = KSL_MUL(4.440892098500628e-16, vo_1_padded);
  const double vo_2_padded = vo_2_size + 2.004168360008973e-292,
      vo_2_error_bound = KSL_MUL(4.440892098500628e-16, vo_2_padded);
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
  vo_bound->x = vo_0_error_bound;
  vo_bound->y = vo_1_error_bound;
  vo_bound->z = vo_2_error_bound;
}

/* Ro = R1 R2; |error of Ro| <= Ro_bound unless inf or NaN.
   R1, R2, Ro, Ro_bound: rotation or other 3×3 matrix.
   36 mul, 45 add, 27 abs. */
static inline void ksl_product_drdr_certified(const ksl_mat3x3_t *R1, const ksl_mat3x3_t *R2,
    ksl_mat3x3_t *Ro, ksl_mat3x3_t *Ro_bound) {
  const double Ro_00a = KSL_MUL(R1->m00, R2->m00), Ro_00b = KSL_MUL(R1->m01, R2->m10),
      Ro_00c = Ro_00a + Ro_00b, Ro_00d = KSL_MUL(R1->m02, R2->m20), Ro_00 = Ro_00c + Ro_00d;
  const double Ro_01a = KSL_MUL(R1->m00, R2->m01), Ro_01b = KSL_MUL(R1->m01, R2->m11),
      Ro_01c = Ro_01a + Ro_01b, Ro_01d = KSL_MUL(R1->m02, R2->m21), Ro_01 = Ro_01c + Ro_01d;
  const double Ro_02a = KSL_MUL(R1->m00, R2->m02), Ro_02b = KSL_MUL(R1->m01, R2->m12),
      Ro_02c = Ro_02a + Ro_02b, Ro_02d = KSL_MUL(R1->m02, R2->m22), Ro_02 = Ro_02c + Ro_02d;
  const double Ro_10a = KSL_MUL(R1->m10, R2->m00), Ro_10b = KSL_MUL(R1->m11, R2->m10),
      Ro_10c = Ro_10a + Ro_10b, Ro_10d = KSL_MUL(R1->m12, R2->m20), Ro_10 = Ro_10c + Ro_10d;
  const double Ro_11a = KSL_MUL(R1->m10, R2->m01), Ro_11b = KSL_MUL(R1->m11, R2->m11),
      Ro_11c = Ro_11a + Ro_11b, Ro_11d = KSL_MUL(R1->m12, R2->m21), Ro_11 = Ro_11c + Ro_11d;
  const double Ro_12a = KSL_MUL(R1->m10, R2->m02), Ro_12b = KSL_MUL(R1->m11, R2->m12),
      Ro_12c = Ro_12a + Ro_12b, Ro_12d = KSL_MUL(R1->m12, R2->m22), Ro_12 = Ro_12c + Ro_12d;
  const double Ro_20a = KSL_MUL(R1->m20, R2->m00), Ro_20b = KSL_MUL(R1->m21, R2->m10),
      Ro_20c = Ro_20a + Ro_20b, Ro_20d = KSL_MUL(R1->m22, R2->m20), Ro_20 = Ro_20c + Ro_20d;
  const double Ro_21a = KSL_MUL(R1->m20, R2->m01), Ro_21b = KSL_MUL(R1->m21, R2->m11),
      Ro_21c = Ro_21a + Ro_21b, Ro_21d = KSL_MUL(R1->m22, R2->m21), Ro_21 = Ro_21c + Ro_21d;
  const double Ro_22a = KSL_MUL(R1->m20, R2->m02), Ro_22b = KSL_MUL(R1->m21, R2->m12),
      Ro_22c = Ro_22a + Ro_22b, Ro_22d = KSL_MUL(R1->m22, R2->m22), Ro_22 = Ro_22c + Ro_22d;
  const double Ro_00a_abs = fabs(Ro_00a), Ro_00b_abs = fabs(Ro_00b),
      Ro_00c_size = Ro_00a_abs + Ro_00b_abs, Ro_00d_abs = fabs(Ro_00d),
      Ro_00_size = Ro_00c_size + Ro_00d_abs;
  const double Ro_01a_abs = fabs(Ro_01a), Ro_01b_abs = fabs(Ro_01b),
      Ro_01c_size = Ro_01a_abs + Ro_01b_abs, Ro_01d_abs = fabs(Ro_01d),
      Ro_01_size = Ro_01c_size + Ro_01d_abs;
  const double Ro_02a_abs = fabs(Ro_02a), Ro_02b_abs = fabs(Ro_02b),
      Ro_02c_size = Ro_02a_abs + Ro_02b_abs, Ro_02d_abs = fabs(Ro_02d),
      Ro_02_size = Ro_02c_size + Ro_02d_abs;
  const double Ro_10a_abs = fabs(Ro_10a), Ro_10b_abs = fabs(Ro_10b),
      Ro_10c_size = Ro_10a_abs + Ro_10b_abs, Ro_10d_abs = fabs(Ro_10d),
      Ro_10_size = Ro_10c_size + Ro_10d_abs;
  const double Ro_11a_abs = fabs(Ro_11a), Ro_11b_abs = fabs(Ro_11b),
      Ro_11c_size = Ro_11a_abs + Ro_11b_abs, Ro_11d_abs = fabs(Ro_11d),
      Ro_11_size = Ro_11c_size + Ro_11d_abs;
  const double Ro_12a_abs = fabs(Ro_12a), Ro_12b_abs = fabs(Ro_12b),
      Ro_12c_size = Ro_12a_abs + Ro_12b_abs, Ro_12d_abs = fabs(Ro_12d),
      Ro_12_size = Ro_12c_size + Ro_12d_abs;
  const double Ro_20a_abs = fabs(Ro_20a), Ro_20b_abs = fabs(Ro_20b),
      Ro_20c_size = Ro_20a_abs + Ro_20b_abs, Ro_20d_abs = fabs(Ro_20d),
      Ro_20_size = Ro_20c_size + Ro_20d_abs;
  const double Ro_21a_abs = fabs(Ro_21a), Ro_21b_abs = fabs(Ro_21b),
      Ro_21c_size = Ro_21a_abs + Ro_21b_abs, Ro_21d_abs = fabs(Ro_21d),
      Ro_21_size = Ro_21c_size + Ro_21d_abs;
  const double Ro_22a_abs = fabs(Ro_22a), Ro_22b_abs = fabs(Ro_22b),
      Ro_22c_size = Ro_22a_abs + Ro_22b_abs, Ro_22d_abs = fabs(Ro_22d),
      Ro_22_size = Ro_22c_size + Ro_22d_abs;
  const double Ro_00_padded = Ro_00_size + 2.004168360008973e-292,
      Ro_00_error_bound = KSL_MUL(3.3306690738754706e-16, Ro_00_padded);
  const double Ro_01_padded = Ro_01_size + 2.004168360008973e-292,
      Ro_01_error_bound = KSL_MUL(3.3306690738754706e-16, Ro_01_padded);
  const double Ro_02_padded = Ro_02_size + 2.004168360008973e-292,
      Ro_02_error_bound = KSL_MUL(3.3306690738754706e-16, Ro_02_padded);
  const double Ro_10_padded = Ro_10_size + 2.004168360008973e-292,
      Ro_10_error_bound = KSL_MUL(3.3306690738754706e-16, Ro_10_padded);
  const double Ro_11_padded = Ro_11_size + 2.004168360008973e-292,
      Ro_11_error_bound = KSL_MUL(3.3306690738754706e-16, Ro_11_padded);
  const double Ro_12_padded = Ro_12_size + 2.004168360008973e-292,
      Ro_12_error_bound = KSL_MUL(3.3306690738754706e-16, Ro_12_padded);
  const double Ro_20_padded = Ro_20_size + 2.004168360008973e-292,
      Ro_20_error_bound = KSL_MUL(3.3306690738754706e-16, Ro_20_padded);
  const double Ro_21_padded = Ro_21_size + 2.004168360008973e-292,
      Ro_21_error_bound = KSL_MUL(3.3306690738754706e-16, Ro_21_padded);
  const double Ro_22_padded = Ro_22_size + 2.004168360008973e-292,
      Ro_22_error_bound = KSL_MUL(3.3306690738754706e-16, Ro_22_padded);
  Ro->m00 = Ro_00;
  Ro->m01 = Ro_01;
  Ro->m02 = Ro_02;
  Ro->m10 = Ro_10;
  Ro->m11 = Ro_11;
  Ro->m12 = Ro_12;
  Ro->m20 = Ro_20;
  Ro->m21 = Ro_21;
  Ro->m22 = Ro_22;
  Ro_bound->m00 = Ro_00_error_bound;
  Ro_bound->m01 = Ro_01_error_bound;
  Ro_bound->m02 = Ro_02_error_bound;
  Ro_bound->m10 = Ro_10_error_bound;
  Ro_bound->m11 = Ro_11_error_bound;
  Ro_bound->m12 = Ro_12_error_bound;
  Ro_bound->m20 = Ro_20_error_bound;
  Ro_bound->m21 = Ro_21_error_bound;
  Ro_bound->m22 = Ro_22_error_bound;
}

/* Ro = R1 R2^T; |error of Ro| <= Ro_bound unless inf or NaN.
   R1, R2, Ro, Ro_bound: rotation or other 3×3 matrix.
   36 mul, 45 add, 27 abs. */
static inline void ksl_product_drdrinv_certified(const ksl_mat3x3_t *R1, const ksl_mat3x3_t *R2,
    ksl_mat3x3_t *Ro, ksl_mat3x3_t *Ro_bound) {
  const double Ro_00a = KSL_MUL(R1->m00, R2->m00), Ro_00b = KSL_MUL(R1->m01, R2->m01),
      Ro_00c = Ro_00a + Ro_00b, Ro_00d = KSL_MUL(R1->m02, R2->m02), Ro_00 = Ro_00c + Ro_00d;
  const double Ro_01a = KSL_MUL(R1->m00, R2->m10), Ro_01b = KSL_MUL(R1->m01, R2->m11),
      Ro_01c = Ro_01a + Ro_01b, Ro_01d = KSL_MUL(R1->m02, R2->m12), Ro_01 = Ro_01c + Ro_01d;
  const double Ro_02a = KSL_MUL(R1->m00, R2->m20), Ro_02b = KSL_MUL(R1->m01, R2->m21),
      Ro_02c = Ro_02a + Ro_02b, Ro_02d = KSL_MUL(R1->m02, R2->m22), Ro_02 = Ro_02c + Ro_02d;
  const double Ro_10a = KSL_MUL(R1->m10, R2->m00), Ro_10b = KSL_MUL(R1->m11, R2->m01),
      Ro_10c = Ro_10a + Ro_10b, Ro_10d = KSL_MUL(R1->m12, R2->m02), Ro_10 = Ro_10c + Ro_10d;
  const double Ro_11a = KSL_MUL(R1->m10, R2->m10), Ro_11b = KSL_MUL(R1->m11, R2->m11),
      Ro_11c = Ro_11a + Ro_11b, Ro_11d = KSL_MUL(R1->m12, R2->m12), Ro_11 = Ro_11c + Ro_11d;
  const double Ro_12a = KSL_MUL(R1->m10, R2->m20), Ro_12b = KSL_MUL(R1->m11, R2->m21),
      Ro_12c = Ro_12a + Ro_12b, Ro_12d = KSL_MUL(R1->m12, R2->m22), Ro_12 = Ro_12c + Ro_12d;
  const double Ro_20a = KSL_MUL(R1->m20, R2->m00), Ro_20b = KSL_MUL(R1->m21, R2->m01),
      Ro_20c = Ro_20a + Ro_20b, Ro_20d = KSL_MUL(R1->m22, R2->m02), Ro_20 = Ro_20c + Ro_20d;
  const double Ro_21a = KSL_MUL(R1->m20, R2->m10), Ro_21b = KSL_MUL(R1->m21, R2->m11),
      Ro_21c = Ro_21a + Ro_21b, Ro_21d = KSL_MUL(R1->m22, R2->m12), Ro_21 = Ro_21c + Ro_21d;
  const double Ro_22a = KSL_MUL(R1->m20, R2->m20), Ro_22b = KSL_MUL(R1->m21, R2->m21),
      Ro_22c = Ro_22a + Ro_22b, Ro_22d = KSL_MUL(R1->m22, R2->m22), Ro_22 = Ro_22c + Ro_22d;
  const double Ro_00a_abs = fabs(Ro_00a), Ro_00b_abs = fabs(Ro_00b),
      Ro_00c_size = Ro_00a_abs + Ro_00b_abs, Ro_00d_abs = fabs(Ro_00d),
      Ro_00_size = Ro_00c_size + Ro_00d_abs;
  const double Ro_01a_abs = fabs(Ro_01a), Ro_01b_abs = fabs(Ro_01b),
      Ro_01c_size = Ro_01a_abs + Ro_01b_abs, Ro_01d_abs = fabs(Ro_01d),
      Ro_01_size = Ro_01c_size + Ro_01d_abs;
  const double Ro_02a_abs = fabs(Ro_02a), Ro_02b_abs = fabs(Ro_02b),
      Ro_02c_size = Ro_02a_abs + Ro_02b_abs, Ro_02d_abs = fabs(Ro_02d),
      Ro_02_size = Ro_02c_size + Ro_02d_abs;
  const double Ro_10a_abs = fabs(Ro_10a), Ro_10b_abs = fabs(Ro_10b),
      Ro_10c_size = Ro_10a_abs + Ro_10b_abs, Ro_10d_abs = fabs(Ro_10d),
      Ro_10_size = Ro_10c_size + Ro_10d_abs;
  const double Ro_11a_abs = fabs(Ro_11a), Ro_11b_abs = fabs(Ro_11b),
      Ro_11c_size = Ro_11a_abs + Ro_11b_abs, Ro_11d_abs = fabs(Ro_11d),
      Ro_11_size = Ro_11c_size + Ro_11d_abs;
  const double Ro_12a_abs = fabs(Ro_12a), Ro_12b_abs = fabs(Ro_12b),
      Ro_12c_size = Ro_12a_abs + Ro_12b_abs, Ro_12d_abs = fabs(Ro_12d),
      Ro_12_size = Ro_12c_size + Ro_12d_abs;
  const double Ro_20a_abs = fabs(Ro_20a), Ro_20b_abs = fabs(Ro_20b),
      Ro_20c_size = Ro_20a_abs + Ro_20b_abs, Ro_20d_abs = fabs(Ro_20d),
      Ro_20_size = Ro_20c_size + Ro_20d_abs;
  const double Ro_21a_abs = fabs(Ro_21a), Ro_21b_abs = fabs(Ro_21b),
      Ro_21c_size = Ro_21a_abs + Ro_21b_abs, Ro_21d_abs = fabs(Ro_21d),
      Ro_21_size = Ro_21c_size + Ro_21d_abs;
  const double Ro_22a_abs = fabs(Ro_22a), Ro_22b_abs = fabs(Ro_22b),
      Ro_22c_size = Ro_22a_abs + Ro_22b_abs, Ro_22d_abs = fabs(Ro_22d),
      Ro_22_size = Ro_22c_size + Ro_22d_abs;
  const double Ro_00_padded = Ro_00_size + 2.004168360008973e-292,
      Ro_00_error_bound = KSL_MUL(3.3306690738754706e-16, Ro_00_padded);
  const double Ro_01_padded = Ro_01_size + 2.004168360008973e-292,
      Ro_01_error_bound = KSL_MUL(3.3306690738754706e-16, Ro_01_padded);
  const double Ro_02_padded = Ro_02_size + 2.004168360008973e-292,
      Ro_02_error_bound = KSL_MUL(3.3306690738754706e-16, Ro_02_padded);
  const double Ro_10_padded = Ro_10_size + 2.004168360008973e-292,
      Ro_10_error_bound = KSL_MUL(3.3306690738754706e-16, Ro_10_padded);
  const double Ro_11_padded = Ro_11_size + 2.004168360008973e-292,
      Ro_11_error_bound = KSL_MUL(3.3306690738754706e-16, Ro_11_padded);
  const double Ro_12_padded = Ro_12_size + 2.004168360008973e-292,
      Ro_12_error_bound = KSL_MUL(3.3306690738754706e-16, Ro_12_padded);
  const double Ro_20_padded = Ro_20_size + 2.004168360008973e-292,
      Ro_20_error_bound = KSL_MUL(3.3306690738754706e-16, Ro_20_padded);
  const double Ro_21_padded = Ro_21_size + 2.004168360008973e-292,
      Ro_21_error_bound = KSL_MUL(3.3306690738754706e-16, Ro_21_padded);
  const double Ro_22_padded = Ro_22_size + 2.004168360008973e-292,
      Ro_22_error_bound = KSL_MUL(3.3306690738754706e-16, Ro_22_padded);
  Ro->m00 = Ro_00;
  Ro->m01 = Ro_01;
  Ro->m02 = Ro_02;
  Ro->m10 = Ro_10;
  Ro->m11 = Ro_11;
  Ro->m12 = Ro_12;
  Ro->m20 = Ro_20;
  Ro->m21 = Ro_21;
  Ro->m22 = Ro_22;
  Ro_bound->m00 = Ro_00_error_bound;
  Ro_bound->m01 = Ro_01_error_bound;
  Ro_bound->m02 = Ro_02_error_bound;
  Ro_bound->m10 = Ro_10_error_bound;
  Ro_bound->m11 = Ro_11_error_bound;
  Ro_bound->m12 = Ro_12_error_bound;
  Ro_bound->m20 = Ro_20_error_bound;
  Ro_bound->m21 = Ro_21_error_bound;
  Ro_bound->m22 = Ro_22_error_bound;
}

/* Ro = R1^T R2; |error of Ro| <= Ro_bound unless inf or NaN.
   R1, R2, Ro, Ro_bound: rotation or other 3×3 matrix.
   36 mul, 45 add, 27 abs. */
static inline void ksl_product_drinvdr_certified(const ksl_mat3x3_t *R1, const ksl_mat3x3_t *R2,
    ksl_mat3x3_t *Ro, ksl_mat3x3_t *Ro_bound) {
  const double Ro_00a = KSL_MUL(R1->m00, R2->m00), Ro_00b = KSL_MUL(R1->m10, R2->m10),
      Ro_00c = Ro_00a + Ro_00b, Ro_00d = KSL_MUL(R1->m20, R2->m20), Ro_00 = Ro_00c + Ro_00d;
  const double Ro_01a = KSL_MUL(R1->m00, R2->m01), Ro_01b = KSL_MUL(R1->m10, R2->m11),
      Ro_01c = Ro_01a + Ro_01b, Ro_01d = KSL_MUL(R1->m20, R2->m21), Ro_01 = Ro_01c + Ro_01d;
  const double Ro_02a = KSL_MUL(R1->m00, R2->m02), Ro_02b = KSL_MUL(R1->m10, R2->m12),
      Ro_02c = Ro_02a + Ro_02b, Ro_02d = KSL_MUL(R1->m20, R2->m22), Ro_02 = Ro_02c + Ro_02d;
  const double Ro_10a = KSL_MUL(R1->m01, R2->m00), Ro_10b = KSL_MUL(R1->m11, R2->m10),
      Ro_10c = Ro_10a + Ro_10b, Ro_10d = KSL_MUL(R1->m21, R2->m20), Ro_10 = Ro_10c + Ro_10d;
  const double Ro_11a = KSL_MUL(R1->m01, R2->m01), Ro_11b = KSL_MUL(R1->m11, R2->m11),
      Ro_11c = Ro_11a + Ro_11b, Ro_11d = KSL_MUL(R1->m21, R2->m21), Ro_11 = Ro_11c + Ro_11d;
  const double Ro_12a = KSL_MUL(R1->m01, R2->m02), Ro_12b = KSL_MUL(R1->m11, R2->m12),
      Ro_12c = Ro_12a + Ro_12b, Ro_12d = KSL_MUL(R1->m21, R2->m22), Ro_12 = Ro_12c + Ro_12d;
  const double Ro_20a = KSL_MUL(R1->m02, R2->m00), Ro_20b = KSL_MUL(R1->m12, R2->m10),
      Ro_20c = Ro_20a + Ro_20b, Ro_20d = KSL_MUL(R1->m22, R2->m20), Ro_20 = Ro_20c + Ro_20d;
  const double Ro_21a = KSL_MUL(R1->m02, R2->m01), Ro_21b = KSL_MUL(R1->m12, R2->m11),
      Ro_21c = Ro_21a + Ro_21b, Ro_21d = KSL_MUL(R1->m22, R2->m21), Ro_21 = Ro_21c + Ro_21d;
  const double Ro_22a = KSL_MUL(R1->m02, R2->m02), Ro_22b = KSL_MUL(R1->m12, R2->m12),
      Ro_22c = Ro_22a + Ro_22b, Ro_22d = KSL_MUL(R1->m22, R2->m22), Ro_22 = Ro_22c + Ro_22d;
  const double Ro_00a_abs = fabs(Ro_00a), Ro_00b_abs = fabs(Ro_00b),
      Ro_00c_size = Ro_00a_abs + Ro_00b_abs, Ro_00d_abs = fabs(Ro_00d),
      Ro_00_size = Ro_00c_size + Ro_00d_abs;
  const double Ro_01a_abs = fabs(Ro_01a), Ro_01b_abs = fabs(Ro_01b),
      Ro_01c_size = Ro_01a_abs + Ro_01b_abs, Ro_01d_abs = fabs(Ro_01d),
      Ro_01_size = Ro_01c_size + Ro_01d_abs;
  const double Ro_02a_abs = fabs(Ro_02a), Ro_02b_abs = fabs(Ro_02b),
      Ro_02c_size = Ro_02a_abs + Ro_02b_abs, Ro_02d_abs = fabs(Ro_02d),
      Ro_02_size = Ro_02c_size + Ro_02d_abs;
  const double Ro_10a_abs = fabs(Ro_10a), Ro_10b_abs = fabs(Ro_10b),
      Ro_10c_size = Ro_10a_abs + Ro_10b_abs, Ro_10d_abs = fabs(Ro_10d),
      Ro_10_size = Ro_10c_size + Ro_10d_abs;
  const double Ro_11a_abs = fabs(Ro_11a), Ro_11b_abs = fabs(Ro_11b),
      Ro_11c_size = Ro_11a_abs + Ro_11b_abs, Ro_11d_abs = fabs(Ro_11d),
      Ro_11_size = Ro_11c_size + Ro_11d_abs;
  const double Ro_12a_abs = fabs(Ro_12a), Ro_12b_abs = fabs(Ro_12b),
      Ro_12c_size = Ro_12a_abs + Ro_12b_abs, Ro_12d_abs = fabs(Ro_12d),
      Ro_12_size = Ro_12c_size + Ro_12d_abs;
  const double Ro_20a_abs = fabs(Ro_20a), Ro_20b_abs = fabs(Ro_20b),
      Ro_20c_size = Ro_20a_abs + Ro_20b_abs, Ro_20d_abs = fabs(Ro_20d),
      Ro_20_size = Ro_20c_size + Ro_20d_abs;
  const double Ro_21a_abs = fabs(Ro_21a), Ro_21b_abs = fabs(Ro_21b),
      Ro_21c_size = Ro_21a_abs + Ro_21b_abs, Ro_21d_abs = fabs(Ro_21d),
      Ro_21_size = Ro_21c_size + Ro_21d_abs;
  const double Ro_22a_abs = fabs(Ro_22a), Ro_22b_abs = fabs(Ro_22b),
      Ro_22c_size = Ro_22a_abs + Ro_22b_abs, Ro_22d_abs = fabs(Ro_22d),
      Ro_22_size = Ro_22c_size + Ro_22d_abs;
  const double Ro_00_padded = Ro_00_size + 2.004168360008973e-292,
      Ro_00_error_bound = KSL_MUL(3.3306690738754706e-16, Ro_00_padded);
  const double Ro_01_padded = Ro_01_size + 2.004168360008973e-292,
      Ro_01_error_bound = KSL_MUL(3.3306690738754706e-16, Ro_01_padded);
  const double Ro_02_padded = Ro_02_size + 2.004168360008973e-292,
      Ro_02_error_bound = KSL_MUL(3.3306690738754706e-16, Ro_02_padded);
  const double Ro_10_padded = Ro_10_size + 2.004168360008973e-292,
      Ro_10_error_bound = KSL_MUL(3.3306690738754706e-16, Ro_10_padded);
  const double Ro_11_padded = Ro_11_size + 2.004168360008973e-292,
      Ro_11_error_bound = KSL_MUL(3.3306690738754706e-16, Ro_11_padded);
  const double Ro_12_padded = Ro_12_size + 2.004168360008973e-292,
      Ro_12_error_bound = KSL_MUL(3.3306690738754706e-16, Ro_12_padded);
  const double Ro_20_padded = Ro_20_size + 2.004168360008973e-292,
      Ro_20_error_bound = KSL_MUL(3.3306690738754706e-16, Ro_20_padded);
  const double Ro_21_padded = Ro_21_size + 2.004168360008973e-292,
      Ro_21_error_bound = KSL_MUL(3.3306690738754706e-16, Ro_21_padded);
  const double Ro_22_padded = Ro_22_size + 2.004168360008973e-292,
      Ro_22_error_bound = KSL_MUL(3.3306690738754706e-16, Ro_22_padded);
  Ro->m00 = Ro_00;
  Ro->m01 = Ro_01;
  Ro->m02 = Ro_02;
  Ro->m10 = Ro_10;
  Ro->m11 = Ro_11;
  Ro->m12 = Ro_12;
  Ro->m20 = Ro_20;
  Ro->m21 = Ro_21;
  Ro->m22 = Ro_22;
  Ro_bound->m00 = Ro_00_error_bound;
  Ro_bound->m01 = Ro_01_error_bound;
  Ro_bound->m02 = Ro_02_error_bound;
  Ro_bound->m10 = Ro_10_error_bound;
  Ro_bound->m11 = Ro_11_error_bound;
  Ro_bound->m12 = Ro_12_error_bound;
  Ro_bound->m20 = Ro_20_error_bound;
  Ro_bound->m21 = Ro_21_error_bound;
  Ro_bound->m22 = Ro_22_error_bound;
}

/* Do = D1 D2 = [R1 R2 | R1 t2 + t1]; |error of Do| <= Do_bound unless inf or NaN.
   D1, D2, Do, Do_bound: displacement [R | t], R rotation, t in m.
   48 mul, 66 add, 39 abs. */
static inline void ksl_product_dd_certified(const ksl_SE3_t *D1, const ksl_SE3_t *D2,
    ksl_SE3_t *Do, ksl_SE3_t *Do_bound) {
  const double Do_00a = KSL_MUL(D1->m00, D2->m00), Do_00b = KSL_MUL(D1->m01, D2->m10),
      Do_00c = Do_00a + Do_00b, Do_00d = KSL_MUL(D1->m02, D2->m20), Do_00 = Do_00c + Do_00d;
  const double Do_01a = KSL_MUL(D1->m00, D2->m01), Do_01b = KSL_MUL(D1->m01, D2->m11),
      Do_01c = Do_01a + Do_01b, Do_01d = KSL_MUL(D1->m02, D2->m21), Do_01 = Do_01c + Do_01d;
  const double Do_02a = KSL_MUL(D1->m00, D2->m02), Do_02b = KSL_MUL(D1->m01, D2->m12),
      Do_02c = Do_02a + Do_02b, Do_02d = KSL_MUL(D1->m02, D2->m22), Do_02 = Do_02c + Do_02d;
  const double Do_03a = KSL_MUL(D1->m00, D2->m03), Do_03b = KSL_MUL(D1->m01, D2->m13),
      Do_03c = Do_03a + Do_03b, Do_03d = KSL_MUL(D1->m02, D2->m23), Do_03e = Do_03c + Do_03d,
      Do_03 = Do_03e + D1->m03;
  const double Do_10a = KSL_MUL(D1->m10, D2->m00), Do_10b = KSL_MUL(D1->m11, D2->m10),
      Do_10c = Do_10a + Do_10b, Do_10d = KSL_MUL(D1->m12, D2->m20), Do_10 = Do_10c + Do_10d;
  const double Do_11a = KSL_MUL(D1->m10, D2->m01), Do_11b = KSL_MUL(D1->m11, D2->m11),
      Do_11c = Do_11a + Do_11b, Do_11d = KSL_MUL(D1->m12, D2->m21), Do_11 = Do_11c + Do_11d;
  const double Do_12a = KSL_MUL(D1->m10, D2->m02), Do_12b = KSL_MUL(D1->m11, D2->m12),
      Do_12c = Do_12a + Do_12b, Do_12d = KSL_MUL(D1->m12, D2->m22), Do_12 = Do_12c + Do_12d;
  const double Do_13a = KSL_MUL(D1->m10, D2->m03), Do_13b = KSL_MUL(D1->m11, D2->m13),
      Do_13c = Do_13a + Do_13b, Do_13d = KSL_MUL(D1->m12, D2->m23), Do_13e = Do_13c + Do_13d,
      Do_13 = Do_13e + D1->m13;
  const double Do_20a = KSL_MUL(D1->m20, D2->m00), Do_20b = KSL_MUL(D1->m21, D2->m10),
      Do_20c = Do_20a + Do_20b, Do_20d = KSL_MUL(D1->m22, D2->m20), Do_20 = Do_20c + Do_20d;
  const double Do_21a = KSL_MUL(D1->m20, D2->m01), Do_21b = KSL_MUL(D1->m21, D2->m11),
      Do_21c = Do_21a + Do_21b, Do_21d = KSL_MUL(D1->m22, D2->m21), Do_21 = Do_21c + Do_21d;
  const double Do_22a = KSL_MUL(D1->m20, D2->m02), Do_22b = KSL_MUL(D1->m21, D2->m12),
      Do_22c = Do_22a + Do_22b, Do_22d = KSL_MUL(D1->m22, D2->m22), Do_22 = Do_22c + Do_22d;
  const double Do_23a = KSL_MUL(D1->m20, D2->m03), Do_23b = KSL_MUL(D1->m21, D2->m13),
      Do_23c = Do_23a + Do_23b, Do_23d = KSL_MUL(D1->m22, D2->m23), Do_23e = Do_23c + Do_23d,
      Do_23 = Do_23e + D1->m23;
  const double Do_00a_abs = fabs(Do_00a), Do_00b_abs = fabs(Do_00b),
      Do_00c_size = Do_00a_abs + Do_00b_abs, Do_00d_abs = fabs(Do_00d),
      Do_00_size = Do_00c_size + Do_00d_abs;
  const double Do_01a_abs = fabs(Do_01a), Do_01b_abs = fabs(Do_01b),
      Do_01c_size = Do_01a_abs + Do_01b_abs, Do_01d_abs = fabs(Do_01d),
      Do_01_size = Do_01c_size + Do_01d_abs;
  const double Do_02a_abs = fabs(Do_02a), Do_02b_abs = fabs(Do_02b),
      Do_02c_size = Do_02a_abs + Do_02b_abs, Do_02d_abs = fabs(Do_02d),
      Do_02_size = Do_02c_size + Do_02d_abs;
  const double Do_03a_abs = fabs(Do_03a), Do_03b_abs = fabs(Do_03b),
      Do_03c_size = Do_03a_abs + Do_03b_abs, Do_03d_abs = fabs(Do_03d),
      Do_03e_size = Do_03c_size + Do_03d_abs, D1_03_abs = fabs(D1->m03),
      Do_03_size = Do_03e_size + D1_03_abs;
  const double Do_10a_abs = fabs(Do_10a), Do_10b_abs = fabs(Do_10b),
      Do_10c_size = Do_10a_abs + Do_10b_abs, Do_10d_abs = fabs(Do_10d),
      Do_10_size = Do_10c_size + Do_10d_abs;
  const double Do_11a_abs = fabs(Do_11a), Do_11b_abs = fabs(Do_11b),
      Do_11c_size = Do_11a_abs + Do_11b_abs, Do_11d_abs = fabs(Do_11d),
      Do_11_size = Do_11c_size + Do_11d_abs;
  const double Do_12a_abs = fabs(Do_12a), Do_12b_abs = fabs(Do_12b),
      Do_12c_size = Do_12a_abs + Do_12b_abs, Do_12d_abs = fabs(Do_12d),
      Do_12_size = Do_12c_size + Do_12d_abs;
  const double Do_13a_abs = fabs(Do_13a), Do_13b_abs = fabs(Do_13b),
      Do_13c_size = Do_13a_abs + Do_13b_abs, Do_13d_abs = fabs(Do_13d),
      Do_13e_size = Do_13c_size + Do_13d_abs, D1_13_abs = fabs(D1->m13),
      Do_13_size = Do_13e_size + D1_13_abs;
  const double Do_20a_abs = fabs(Do_20a), Do_20b_abs = fabs(Do_20b),
      Do_20c_size = Do_20a_abs + Do_20b_abs, Do_20d_abs = fabs(Do_20d),
      Do_20_size = Do_20c_size + Do_20d_abs;
  const double Do_21a_abs = fabs(Do_21a), Do_21b_abs = fabs(Do_21b),
      Do_21c_size = Do_21a_abs + Do_21b_abs, Do_21d_abs = fabs(Do_21d),
      Do_21_size = Do_21c_size + Do_21d_abs;
  const double Do_22a_abs = fabs(Do_22a), Do_22b_abs = fabs(Do_22b),
      Do_22c_size = Do_22a_abs + Do_22b_abs, Do_22d_abs = fabs(Do_22d),
      Do_22_size = Do_22c_size + Do_22d_abs;
  const double Do_23a_abs = fabs(Do_23a), Do_23b_abs = fabs(Do_23b),
      Do_23c_size = Do_23a_abs + Do_23b_abs, Do_23d_abs = fabs(Do_23d),
      Do_23e_size = Do_23c_size + Do_23d_abs, D1_23_abs = fabs(D1->m23),
      Do_23_size = Do_23e_size + D1_23_abs;
  const double Do_00_padded = Do_00_size + 2.004168360008973e-292,
      Do_00_error_bound = KSL_MUL(3.3306690738754706e-16, Do_00_padded);
  const double Do_01_padded = Do_01_size + 2.004168360008973e-292,
      Do_01_error_bound = KSL_MUL(3.3306690738754706e-16, Do_01_padded);
  const double Do_02_padded = Do_02_size + 2.004168360008973e-292,
      Do_02_error_bound = KSL_MUL(3.3306690738754706e-16, Do_02_padded);
  const double Do_03_padded = Do_03_size + 2.004168360008973e-292,
      Do_03_error_bound = KSL_MUL(4.440892098500628e-16, Do_03_padded);
  const double Do_10_padded = Do_10_size + 2.004168360008973e-292,
      Do_10_error_bound = KSL_MUL(3.3306690738754706e-16, Do_10_padded);
  const double Do_11_padded = Do_11_size + 2.004168360008973e-292,
      Do_11_error_bound = KSL_MUL(3.3306690738754706e-16, Do_11_padded);
  const double Do_12_padded = Do_12_size + 2.004168360008973e-292,
      Do_12_error_bound = KSL_MUL(3.3306690738754706e-16, Do_12_padded);
  const double Do_13_padded = Do_13_size + 2.004168360008973e-292,
      Do_13_error_bound = KSL_MUL(4.440892098500628e-16, Do_13_padded);
  const double Do_20_padded = Do_20_size + 2.004168360008973e-292,
      Do_20_error_bound = KSL_MUL(3.3306690738754706e-16, Do_20_padded);
  const double Do_21_padded = Do_21_size + 2.004168360008973e-292,
      Do_21_error_bound = KSL_MUL(3.3306690738754706e-16, Do_21_padded);
  const double Do_22_padded = Do_22_size + 2.004168360008973e-292,
      Do_22_error_bound = KSL_MUL(3.3306690738754706e-16, Do_22_padded);
  const double Do_23_padded = Do_23_size + 2.004168360008973e-292,
      Do_23_error_bound = KSL_MUL(4.440892098500628e-16, Do_23_padded);
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
  Do_bound->m00 = Do_00_error_bound;
  Do_bound->m01 = Do_01_error_bound;
  Do_bound->m02 = Do_02_error_bound;
  Do_bound->m03 = Do_03_error_bound;
  Do_bound->m10 = Do_10_error_bound;
  Do_bound->m11 = Do_11_error_bound;
  Do_bound->m12 = Do_12_error_bound;
  Do_bound->m13 = Do_13_error_bound;
  Do_bound->m20 = Do_20_error_bound;
  Do_bound->m21 = Do_21_error_bound;
  Do_bound->m22 = Do_22_error_bound;
  Do_bound->m23 = Do_23_error_bound;
}

/* Do = D1 D2^-1 = [R | t1 - R t2], R = R1 R2^T; |error of Do| <= Do_bound unless inf or NaN.
   D1, D2, Do, Do_bound: displacement [R | t], R rotation, t in m.
   57 mul, 66 add, 33 abs. */
static inline void ksl_product_ddinv_certified(const ksl_SE3_t *D1, const ksl_SE3_t *D2,
    ksl_SE3_t *Do, ksl_SE3_t *Do_bound) {
  const double R_0a = KSL_MUL(D1->m00, D2->m00), R_0b = KSL_MUL(D1->m01, D2->m01),
      R_0c = R_0a + R_0b, R_0d = KSL_MUL(D1->m02, D2->m02), R_0 = R_0c + R_0d;
  const double R_1a = KSL_MUL(D1->m00, D2->m10), R_1b = KSL_MUL(D1->m01, D2->m11),
      R_1c = R_1a + R_1b, R_1d = KSL_MUL(D1->m02, D2->m12), R_1 = R_1c + R_1d;
  const double R_2a = KSL_MUL(D1->m00, D2->m20), R_2b = KSL_MUL(D1->m01, D2->m21),
      R_2c = R_2a + R_2b, R_2d = KSL_MUL(D1->m02, D2->m22), R_2 = R_2c + R_2d;
  const double R_3a = KSL_MUL(D1->m10, D2->m00), R_3b = KSL_MUL(D1->m11, D2->m01),
      R_3c = R_3a + R_3b, R_3d = KSL_MUL(D1->m12, D2->m02), R_3 = R_3c + R_3d;
  const double R_4a = KSL_MUL(D1->m10, D2->m10), R_4b = KSL_MUL(D1->m11, D2->m11),
      R_4c = R_4a + R_4b, R_4d = KSL_MUL(D1->m12, D2->m12), R_4 = R_4c + R_4d;
  const double R_5a = KSL_MUL(D1->m10, D2->m20), R_5b = KSL_MUL(D1->m11, D2->m21),
      R_5c = R_5a + R_5b, R_5d = KSL_MUL(D1->m12, D2->m22), R_5 = R_5c + R_5d;
  const double R_6a = KSL_MUL(D1->m20, D2->m00), R_6b = KSL_MUL(D1->m21, D2->m01),
      R_6c = R_6a + R_6b, R_6d = KSL_MUL(D1->m22, D2->m02), R_6 = R_6c + R_6d;
  const double R_7a = KSL_MUL(D1->m20, D2->m10), R_7b = KSL_MUL(D1->m21, D2->m11),
      R_7c = R_7a + R_7b, R_7d = KSL_MUL(D1->m22, D2->m12), R_7 = R_7c + R_7d;
  const double R_8a = KSL_MUL(D1->m20, D2->m20), R_8b = KSL_MUL(D1->m21, D2->m21),
      R_8c = R_8a + R_8b, R_8d = KSL_MUL(D1->m22, D2->m22), R_8 = R_8c + R_8d;
  const double Do_03a = KSL_MUL(D2->m03, R_0), Do_03b = KSL_MUL(D2->m13, R_1),
      Do_03c = Do_03a + Do_03b, Do_03d = KSL_MUL(D2->m23, R_2), Do_03e = Do_03c + Do_03d,
      Do_03 = D1->m03 - Do_03e;
  const double Do_13a = KSL_MUL(D2->m03, R_3), Do_13b = KSL_MUL(D2->m13, R_4),
      Do_13c = Do_13a + Do_13b, Do_13d = KSL_MUL(D2->m23, R_5), Do_13e = Do_13c + Do_13d,
      Do_13 = D1->m13 - Do_13e;
  const double Do_23a = KSL_MUL(D2->m03, R_6), Do_23b = KSL_MUL(D2->m13, R_7),
      Do_23c = Do_23a + Do_23b, Do_23d = KSL_MUL(D2->m23, R_8), Do_23e = Do_23c + Do_23d,
      Do_23 = D1->m23 - Do_23e;
  const double R_0a_abs = fabs(R_0a), R_0b_abs = fabs(R_0b), R_0c_size = R_0a_abs + R_0b_abs,
      R_0d_abs = fabs(R_0d), R_0_size = R_0c_size + R_0d_abs;
  const double R_1a_abs = fabs(R_1a), R_1b_abs = fabs(R_1b), R_1c_size = R_1a_abs + R_1b_abs,
      R_1d_abs = fabs(R_1d), R_1_size = R_1c_size + R_1d_abs;
  const double R_2a_abs = fabs(R_2a), R_2b_abs = fabs(R_2b), R_2c_size = R_2a_abs + R_2b_abs,
      R_2d_abs = fabs(R_2d), R_2_size = R_2c_size + R_2d_abs;
  const double R_3a_abs = fabs(R_3a), R_3b_abs = fabs(R_3b), R_3c_size = R_3a_abs + R_3b_abs,
      R_3d_abs = fabs(R_3d), R_3_size = R_3c_size + R_3d_abs;
  const double R_4a_abs = fabs(R_4a), R_4b_abs = fabs(R_4b), R_4c_size = R_4a_abs + R_4b_abs,
      R_4d_abs = fabs(R_4d), R_4_size = R_4c_size + R_4d_abs;
  const double R_5a_abs = fabs(R_5a), R_5b_abs = fabs(R_5b), R_5c_size = R_5a_abs + R_5b_abs,
      R_5d_abs = fabs(R_5d), R_5_size = R_5c_size + R_5d_abs;
  const double R_6a_abs = fabs(R_6a), R_6b_abs = fabs(R_6b), R_6c_size = R_6a_abs + R_6b_abs,
      R_6d_abs = fabs(R_6d), R_6_size = R_6c_size + R_6d_abs;
  const double R_7a_abs = fabs(R_7a), R_7b_abs = fabs(R_7b), R_7c_size = R_7a_abs + R_7b_abs,
      R_7d_abs = fabs(R_7d), R_7_size = R_7c_size + R_7d_abs;
  const double R_8a_abs = fabs(R_8a), R_8b_abs = fabs(R_8b), R_8c_size = R_8a_abs + R_8b_abs,
      R_8d_abs = fabs(R_8d), R_8_size = R_8c_size + R_8d_abs;
  const double R_0_padded = R_0_size + 2.004168360008973e-292;
  const double D2_03_abs = fabs(D2->m03), Do_03a_size = KSL_MUL(D2_03_abs, R_0_padded);
  const double R_1_padded = R_1_size + 2.004168360008973e-292;
  const double D2_13_abs = fabs(D2->m13), Do_03b_size = KSL_MUL(D2_13_abs, R_1_padded),
      Do_03c_size = Do_03a_size + Do_03b_size;
  const double R_2_padded = R_2_size + 2.004168360008973e-292;
  const double D2_23_abs = fabs(D2->m23), Do_03d_size = KSL_MUL(D2_23_abs, R_2_padded),
      Do_03e_size = Do_03c_size + Do_03d_size, D1_03_abs = fabs(D1->m03),
      Do_03_size = D1_03_abs + Do_03e_size;
  const double R_3_padded = R_3_size + 2.004168360008973e-292;
  const double Do_13a_size = KSL_MUL(D2_03_abs, R_3_padded);
  const double R_4_padded = R_4_size + 2.004168360008973e-292;
  const double Do_13b_size = KSL_MUL(D2_13_abs, R_4_padded),
      Do_13c_size = Do_13a_size + Do_13b_size;
  const double R_5_padded = R_5_size + 2.004168360008973e-292;
  const double Do_13d_size = KSL_MUL(D2_23_abs, R_5_padded),
      Do_13e_size = Do_13c_size + Do_13d_size, D1_13_abs = fabs(D1->m13),
      Do_13_size = D1_13_abs + Do_13e_size;
  const double R_6_padded = R_6_size + 2.004168360008973e-292;
  const double Do_23a_size = KSL_MUL(D2_03_abs, R_6_padded);
  const double R_7_padded = R_7_size + 2.004168360008973e-292;
  const double Do_23b_size = KSL_MUL(D2_13_abs, R_7_padded),
      Do_23c_size = Do_23a_size + Do_23b_size;
  const double R_8_padded = R_8_size + 2.004168360008973e-292;
  const double Do_23d_size = KSL_MUL(D2_23_abs, R_8_padded),
      Do_23e_size = Do_23c_size + Do_23d_size, D1_23_abs = fabs(D1->m23),
      Do_23_size = D1_23_abs + Do_23e_size;
  const double R_0_error_bound = KSL_MUL(3.3306690738754706e-16, R_0_padded);
  const double R_1_error_bound = KSL_MUL(3.3306690738754706e-16, R_1_padded);
  const double R_2_error_bound = KSL_MUL(3.3306690738754706e-16, R_2_padded);
  const double Do_03_padded = Do_03_size + 2.004168360008973e-292,
      Do_03_error_bound = KSL_MUL(7.7715611723761e-16, Do_03_padded);
  const double R_3_error_bound = KSL_MUL(3.3306690738754706e-16, R_3_padded);
  const double R_4_error_bound = KSL_MUL(3.3306690738754706e-16, R_4_padded);
  const double R_5_error_bound = KSL_MUL(3.3306690738754706e-16, R_5_padded);
  const double Do_13_padded = Do_13_size + 2.004168360008973e-292,
      Do_13_error_bound = KSL_MUL(7.7715611723761e-16, Do_13_padded);
  const double R_6_error_bound = KSL_MUL(3.3306690738754706e-16, R_6_padded);
  const double R_7_error_bound = KSL_MUL(3.3306690738754706e-16, R_7_padded);
  const double R_8_error_bound = KSL_MUL(3.3306690738754706e-16, R_8_padded);
  const double Do_23_padded = Do_23_size + 2.004168360008973e-292,
      Do_23_error_bound = KSL_MUL(7.7715611723761e-16, Do_23_padded);
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
  Do_bound->m00 = R_0_error_bound;
  Do_bound->m01 = R_1_error_bound;
  Do_bound->m02 = R_2_error_bound;
  Do_bound->m03 = Do_03_error_bound;
  Do_bound->m10 = R_3_error_bound;
  Do_bound->m11 = R_4_error_bound;
  Do_bound->m12 = R_5_error_bound;
  Do_bound->m13 = Do_13_error_bound;
  Do_bound->m20 = R_6_error_bound;
  Do_bound->m21 = R_7_error_bound;
  Do_bound->m22 = R_8_error_bound;
  Do_bound->m23 = Do_23_error_bound;
}

/* Do = D1^-1 D2 = [R1^T R2 | R1^T (t2 - t1)]; |error of Do| <= Do_bound unless inf or NaN.
   D1, D2, Do, Do_bound: displacement [R | t], R rotation, t in m.
   57 mul, 63 add, 39 abs. */
static inline void ksl_product_dinvd_certified(const ksl_SE3_t *D1, const ksl_SE3_t *D2,
    ksl_SE3_t *Do, ksl_SE3_t *Do_bound) {
  const double p_0 = D2->m03 - D1->m03;
  const double p_1 = D2->m13 - D1->m13;
  const double p_2 = D2->m23 - D1->m23;
  const double Do_00a = KSL_MUL(D1->m00, D2->m00), Do_00b = KSL_MUL(D1->m10, D2->m10),
      Do_00c = Do_00a + Do_00b, Do_00d = KSL_MUL(D1->m20, D2->m20), Do_00 = Do_00c + Do_00d;
  const double Do_01a = KSL_MUL(D1->m00, D2->m01), Do_01b = KSL_MUL(D1->m10, D2->m11),
      Do_01c = Do_01a + Do_01b, Do_01d = KSL_MUL(D1->m20, D2->m21), Do_01 = Do_01c + Do_01d;
  const double Do_02a = KSL_MUL(D1->m00, D2->m02), Do_02b = KSL_MUL(D1->m10, D2->m12),
      Do_02c = Do_02a + Do_02b, Do_02d = KSL_MUL(D1->m20, D2->m22), Do_02 = Do_02c + Do_02d;
  const double Do_03a = KSL_MUL(D1->m00, p_0), Do_03b = KSL_MUL(D1->m10, p_1),
      Do_03c = Do_03a + Do_03b, Do_03d = KSL_MUL(D1->m20, p_2), Do_03 = Do_03c + Do_03d;
  const double Do_10a = KSL_MUL(D1->m01, D2->m00), Do_10b = KSL_MUL(D1->m11, D2->m10),
      Do_10c = Do_10a + Do_10b, Do_10d = KSL_MUL(D1->m21, D2->m20), Do_10 = Do_10c + Do_10d;
  const double Do_11a = KSL_MUL(D1->m01, D2->m01), Do_11b = KSL_MUL(D1->m11, D2->m11),
      Do_11c = Do_11a + Do_11b, Do_11d = KSL_MUL(D1->m21, D2->m21), Do_11 = Do_11c + Do_11d;
  const double Do_12a = KSL_MUL(D1->m01, D2->m02), Do_12b = KSL_MUL(D1->m11, D2->m12),
      Do_12c = Do_12a + Do_12b, Do_12d = KSL_MUL(D1->m21, D2->m22), Do_12 = Do_12c + Do_12d;
  const double Do_13a = KSL_MUL(D1->m01, p_0), Do_13b = KSL_MUL(D1->m11, p_1),
      Do_13c = Do_13a + Do_13b, Do_13d = KSL_MUL(D1->m21, p_2), Do_13 = Do_13c + Do_13d;
  const double Do_20a = KSL_MUL(D1->m02, D2->m00), Do_20b = KSL_MUL(D1->m12, D2->m10),
      Do_20c = Do_20a + Do_20b, Do_20d = KSL_MUL(D1->m22, D2->m20), Do_20 = Do_20c + Do_20d;
  const double Do_21a = KSL_MUL(D1->m02, D2->m01), Do_21b = KSL_MUL(D1->m12, D2->m11),
      Do_21c = Do_21a + Do_21b, Do_21d = KSL_MUL(D1->m22, D2->m21), Do_21 = Do_21c + Do_21d;
  const double Do_22a = KSL_MUL(D1->m02, D2->m02), Do_22b = KSL_MUL(D1->m12, D2->m12),
      Do_22c = Do_22a + Do_22b, Do_22d = KSL_MUL(D1->m22, D2->m22), Do_22 = Do_22c + Do_22d;
  const double Do_23a = KSL_MUL(D1->m02, p_0), Do_23b = KSL_MUL(D1->m12, p_1),
      Do_23c = Do_23a + Do_23b, Do_23d = KSL_MUL(D1->m22, p_2), Do_23 = Do_23c + Do_23d;
  const double Do_00a_abs = fabs(Do_00a), Do_00b_abs = fabs(Do_00b),
      Do_00c_size = Do_00a_abs + Do_00b_abs, Do_00d_abs = fabs(Do_00d),
      Do_00_size = Do_00c_size + Do_00d_abs;
  const double Do_01a_abs = fabs(Do_01a), Do_01b_abs = fabs(Do_01b),
      Do_01c_size = Do_01a_abs + Do_01b_abs, Do_01d_abs = fabs(Do_01d),
      Do_01_size = Do_01c_size + Do_01d_abs;
  const double Do_02a_abs = fabs(Do_02a), Do_02b_abs = fabs(Do_02b),
      Do_02c_size = Do_02a_abs + Do_02b_abs, Do_02d_abs = fabs(Do_02d),
      Do_02_size = Do_02c_size + Do_02d_abs;
  const double D1_00_abs = fabs(D1->m00), p_0_abs = fabs(p_0),
      Do_03a_size = KSL_MUL(D1_00_abs, p_0_abs), D1_10_abs = fabs(D1->m10), p_1_abs = fabs(p_1),
      Do_03b_size = KSL_MUL(D1_10_abs, p_1_abs), Do_03c_size = Do_03a_size + Do_03b_size,
      D1_20_abs = fabs(D1->m20), p_2_abs = fabs(p_2), Do_03d_size = KSL_MUL(D1_20_abs, p_2_abs),
      Do_03_size = Do_03c_size + Do_03d_size;
  const double Do_10a_abs = fabs(Do_10a), Do_10b_abs = fabs(Do_10b),
      Do_10c_size = Do_10a_abs + Do_10b_abs, Do_10d_abs = fabs(Do_10d),
      Do_10_size = Do_10c_size + Do_10d_abs;
  const double Do_11a_abs = fabs(Do_11a), Do_11b_abs = fabs(Do_11b),
      Do_11c_size = Do_11a_abs + Do_11b_abs, Do_11d_abs = fabs(Do_11d),
      Do_11_size = Do_11c_size + Do_11d_abs;
  const double Do_12a_abs = fabs(Do_12a), Do_12b_abs = fabs(Do_12b),
      Do_12c_size = Do_12a_abs + Do_12b_abs, Do_12d_abs = fabs(Do_12d),
      Do_12_size = Do_12c_size + Do_12d_abs;
  const double D1_01_abs = fabs(D1->m01), Do_13a_size = KSL_MUL(D1_01_abs, p_0_abs),
      D1_11_abs = fabs(D1->m11), Do_13b_size = KSL_MUL(D1_11_abs, p_1_abs),
      Do_13c_size = Do_13a_size + Do_13b_size, D1_21_abs = fabs(D1->m21),
      Do_13d_size = KSL_MUL(D1_21_abs, p_2_abs), Do_13_size = Do_13c_size + Do_13d_size;
  const double Do_20a_abs = fabs(Do_20a), Do_20b_abs = fabs(Do_20b),
      Do_20c_size = Do_20a_abs + Do_20b_abs, Do_20d_abs = fabs(Do_20d),
      Do_20_size = Do_20c_size + Do_20d_abs;
  const double Do_21a_abs = fabs(Do_21a), Do_21b_abs = fabs(Do_21b),
      Do_21c_size = Do_21a_abs + Do_21b_abs, Do_21d_abs = fabs(Do_21d),
      Do_21_size = Do_21c_size + Do_21d_abs;
  const double Do_22a_abs = fabs(Do_22a), Do_22b_abs = fabs(Do_22b),
      Do_22c_size = Do_22a_abs + Do_22b_abs, Do_22d_abs = fabs(Do_22d),
      Do_22_size = Do_22c_size + Do_22d_abs;
  const double D1_02_abs = fabs(D1->m02), Do_23a_size = KSL_MUL(D1_02_abs, p_0_abs),
      D1_12_abs = fabs(D1->m12), Do_23b_size = KSL_MUL(D1_12_abs, p_1_abs),
      Do_23c_size = Do_23a_size + Do_23b_size, D1_22_abs = fabs(D1->m22),
      Do_23d_size = KSL_MUL(D1_22_abs, p_2_abs), Do_23_size = Do_23c_size + Do_23d_size;
  const double Do_00_padded = Do_00_size + 2.004168360008973e-292,
      Do_00_error_bound = KSL_MUL(3.3306690738754706e-16, Do_00_padded);
  const double Do_01_padded = Do_01_size + 2.004168360008973e-292,
      Do_01_error_bound = KSL_MUL(3.3306690738754706e-16, Do_01_padded);
  const double Do_02_padded = Do_02_size + 2.004168360008973e-292,
      Do_02_error_bound = KSL_MUL(3.3306690738754706e-16, Do_02_padded);
  const double Do_03_padded = Do_03_size + 2.004168360008973e-292,
      Do_03_error_bound = KSL_MUL(4.440892098500628e-16, Do_03_padded);
  const double Do_10_padded = Do_10_size + 2.004168360008973e-292,
      Do_10_error_bound = KSL_MUL(3.3306690738754706e-16, Do_10_padded);
  const double Do_11_padded = Do_11_size + 2.004168360008973e-292,
      Do_11_error_bound = KSL_MUL(3.3306690738754706e-16, Do_11_padded);
  const double Do_12_padded = Do_12_size + 2.004168360008973e-292,
      Do_12_error_bound = KSL_MUL(3.3306690738754706e-16, Do_12_padded);
  const double Do_13_padded = Do_13_size + 2.004168360008973e-292,
      Do_13_error_bound = KSL_MUL(4.440892098500628e-16, Do_13_padded);
  const double Do_20_padded = Do_20_size + 2.004168360008973e-292,
      Do_20_error_bound = KSL_MUL(3.3306690738754706e-16, Do_20_padded);
  const double Do_21_padded = Do_21_size + 2.004168360008973e-292,
      Do_21_error_bound = KSL_MUL(3.3306690738754706e-16, Do_21_padded);
  const double Do_22_padded = Do_22_size + 2.004168360008973e-292,
      Do_22_error_bound = KSL_MUL(3.3306690738754706e-16, Do_22_padded);
  const double Do_23_padded = Do_23_size + 2.004168360008973e-292,
      Do_23_error_bound = KSL_MUL(4.440892098500628e-16, Do_23_padded);
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
  Do_bound->m00 = Do_00_error_bound;
  Do_bound->m01 = Do_01_error_bound;
  Do_bound->m02 = Do_02_error_bound;
  Do_bound->m03 = Do_03_error_bound;
  Do_bound->m10 = Do_10_error_bound;
  Do_bound->m11 = Do_11_error_bound;
  Do_bound->m12 = Do_12_error_bound;
  Do_bound->m13 = Do_13_error_bound;
  Do_bound->m20 = Do_20_error_bound;
  Do_bound->m21 = Do_21_error_bound;
  Do_bound->m22 = Do_22_error_bound;
  Do_bound->m23 = Do_23_error_bound;
}

/* Do = D [R | 0]; |error of Do| <= Do_bound unless inf or NaN.
   D, Do, Do_bound: displacement [R | t], R rotation, t in m; R: rotation or other 3×3 matrix.
   36 mul, 45 add, 27 abs. */
static inline void ksl_product_ddr_certified(const ksl_SE3_t *D, const ksl_mat3x3_t *R,
    ksl_SE3_t *Do, ksl_SE3_t *Do_bound) {
  const double Do_00a = KSL_MUL(D->m00, R->m00), Do_00b = KSL_MUL(D->m01, R->m10),
      Do_00c = Do_00a + Do_00b, Do_00d = KSL_MUL(D->m02, R->m20), Do_00 = Do_00c + Do_00d;
  const double Do_01a = KSL_MUL(D->m00, R->m01), Do_01b = KSL_MUL(D->m01, R->m11),
      Do_01c = Do_01a + Do_01b, Do_01d = KSL_MUL(D->m02, R->m21), Do_01 = Do_01c + Do_01d;
  const double Do_02a = KSL_MUL(D->m00, R->m02), Do_02b = KSL_MUL(D->m01, R->m12),
      Do_02c = Do_02a + Do_02b, Do_02d = KSL_MUL(D->m02, R->m22), Do_02 = Do_02c + Do_02d;
  const double Do_10a = KSL_MUL(D->m10, R->m00), Do_10b = KSL_MUL(D->m11, R->m10),
      Do_10c = Do_10a + Do_10b, Do_10d = KSL_MUL(D->m12, R->m20), Do_10 = Do_10c + Do_10d;
  const double Do_11a = KSL_MUL(D->m10, R->m01), Do_11b = KSL_MUL(D->m11, R->m11),
      Do_11c = Do_11a + Do_11b, Do_11d = KSL_MUL(D->m12, R->m21), Do_11 = Do_11c + Do_11d;
  const double Do_12a = KSL_MUL(D->m10, R->m02), Do_12b = KSL_MUL(D->m11, R->m12),
      Do_12c = Do_12a + Do_12b, Do_12d = KSL_MUL(D->m12, R->m22), Do_12 = Do_12c + Do_12d;
  const double Do_20a = KSL_MUL(D->m20, R->m00), Do_20b = KSL_MUL(D->m21, R->m10),
      Do_20c = Do_20a + Do_20b, Do_20d = KSL_MUL(D->m22, R->m20), Do_20 = Do_20c + Do_20d;
  const double Do_21a = KSL_MUL(D->m20, R->m01), Do_21b = KSL_MUL(D->m21, R->m11),
      Do_21c = Do_21a + Do_21b, Do_21d = KSL_MUL(D->m22, R->m21), Do_21 = Do_21c + Do_21d;
  const double Do_22a = KSL_MUL(D->m20, R->m02), Do_22b = KSL_MUL(D->m21, R->m12),
      Do_22c = Do_22a + Do_22b, Do_22d = KSL_MUL(D->m22, R->m22), Do_22 = Do_22c + Do_22d;
  const double Do_00a_abs = fabs(Do_00a), Do_00b_abs = fabs(Do_00b),
      Do_00c_size = Do_00a_abs + Do_00b_abs, Do_00d_abs = fabs(Do_00d),
      Do_00_size = Do_00c_size + Do_00d_abs;
  const double Do_01a_abs = fabs(Do_01a), Do_01b_abs = fabs(Do_01b),
      Do_01c_size = Do_01a_abs + Do_01b_abs, Do_01d_abs = fabs(Do_01d),
      Do_01_size = Do_01c_size + Do_01d_abs;
  const double Do_02a_abs = fabs(Do_02a), Do_02b_abs = fabs(Do_02b),
      Do_02c_size = Do_02a_abs + Do_02b_abs, Do_02d_abs = fabs(Do_02d),
      Do_02_size = Do_02c_size + Do_02d_abs;
  const double Do_10a_abs = fabs(Do_10a), Do_10b_abs = fabs(Do_10b),
      Do_10c_size = Do_10a_abs + Do_10b_abs, Do_10d_abs = fabs(Do_10d),
      Do_10_size = Do_10c_size + Do_10d_abs;
  const double Do_11a_abs = fabs(Do_11a), Do_11b_abs = fabs(Do_11b),
      Do_11c_size = Do_11a_abs + Do_11b_abs, Do_11d_abs = fabs(Do_11d),
      Do_11_size = Do_11c_size + Do_11d_abs;
  const double Do_12a_abs = fabs(Do_12a), Do_12b_abs = fabs(Do_12b),
      Do_12c_size = Do_12a_abs + Do_12b_abs, Do_12d_abs = fabs(Do_12d),
      Do_12_size = Do_12c_size + Do_12d_abs;
  const double Do_20a_abs = fabs(Do_20a), Do_20b_abs = fabs(Do_20b),
      Do_20c_size = Do_20a_abs + Do_20b_abs, Do_20d_abs = fabs(Do_20d),
      Do_20_size = Do_20c_size + Do_20d_abs;
  const double Do_21a_abs = fabs(Do_21a), Do_21b_abs = fabs(Do_21b),
      Do_21c_size = Do_21a_abs + Do_21b_abs, Do_21d_abs = fabs(Do_21d),
      Do_21_size = Do_21c_size + Do_21d_abs;
  const double Do_22a_abs = fabs(Do_22a), Do_22b_abs = fabs(Do_22b),
      Do_22c_size = Do_22a_abs + Do_22b_abs, Do_22d_abs = fabs(Do_22d),
      Do_22_size = Do_22c_size + Do_22d_abs;
  const double Do_00_padded = Do_00_size + 2.004168360008973e-292,
      Do_00_error_bound = KSL_MUL(3.3306690738754706e-16, Do_00_padded);
  const double Do_01_padded = Do_01_size + 2.004168360008973e-292,
      Do_01_error_bound = KSL_MUL(3.3306690738754706e-16, Do_01_padded);
  const double Do_02_padded = Do_02_size + 2.004168360008973e-292,
      Do_02_error_bound = KSL_MUL(3.3306690738754706e-16, Do_02_padded);
  const double Do_10_padded = Do_10_size + 2.004168360008973e-292,
      Do_10_error_bound = KSL_MUL(3.3306690738754706e-16, Do_10_padded);
  const double Do_11_padded = Do_11_size + 2.004168360008973e-292,
      Do_11_error_bound = KSL_MUL(3.3306690738754706e-16, Do_11_padded);
  const double Do_12_padded = Do_12_size + 2.004168360008973e-292,
      Do_12_error_bound = KSL_MUL(3.3306690738754706e-16, Do_12_padded);
  const double Do_20_padded = Do_20_size + 2.004168360008973e-292,
      Do_20_error_bound = KSL_MUL(3.3306690738754706e-16, Do_20_padded);
  const double Do_21_padded = Do_21_size + 2.004168360008973e-292,
      Do_21_error_bound = KSL_MUL(3.3306690738754706e-16, Do_21_padded);
  const double Do_22_padded = Do_22_size + 2.004168360008973e-292,
      Do_22_error_bound = KSL_MUL(3.3306690738754706e-16, Do_22_padded);
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
  Do_bound->m00 = Do_00_error_bound;
  Do_bound->m01 = Do_01_error_bound;
  Do_bound->m02 = Do_02_error_bound;
  Do_bound->m03 = 0.0;
  Do_bound->m10 = Do_10_error_bound;
  Do_bound->m11 = Do_11_error_bound;
  Do_bound->m12 = Do_12_error_bound;
  Do_bound->m13 = 0.0;
  Do_bound->m20 = Do_20_error_bound;
  Do_bound->m21 = Do_21_error_bound;
  Do_bound->m22 = Do_22_error_bound;
  Do_bound->m23 = 0.0;
}

/* Do = D [R^T | 0]; |error of Do| <= Do_bound unless inf or NaN.
   D, Do, Do_bound: displacement [R | t], R rotation, t in m; R: rotation or other 3×3 matrix.
   36 mul, 45 add, 27 abs. */
static inline void ksl_product_ddrinv_certified(const ksl_SE3_t *D, const ksl_mat3x3_t *R,
    ksl_SE3_t *Do, ksl_SE3_t *Do_bound) {
  const double Do_00a = KSL_MUL(D->m00, R->m00), Do_00b = KSL_MUL(D->m01, R->m01),
      Do_00c = Do_00a + Do_00b, Do_00d = KSL_MUL(D->m02, R->m02), Do_00 = Do_00c + Do_00d;
  const double Do_01a = KSL_MUL(D->m00, R->m10), Do_01b = KSL_MUL(D->m01, R->m11),
      Do_01c = Do_01a + Do_01b, Do_01d = KSL_MUL(D->m02, R->m12), Do_01 = Do_01c + Do_01d;
  const double Do_02a = KSL_MUL(D->m00, R->m20), Do_02b = KSL_MUL(D->m01, R->m21),
      Do_02c = Do_02a + Do_02b, Do_02d = KSL_MUL(D->m02, R->m22), Do_02 = Do_02c + Do_02d;
  const double Do_10a = KSL_MUL(D->m10, R->m00), Do_10b = KSL_MUL(D->m11, R->m01),
      Do_10c = Do_10a + Do_10b, Do_10d = KSL_MUL(D->m12, R->m02), Do_10 = Do_10c + Do_10d;
  const double Do_11a = KSL_MUL(D->m10, R->m10), Do_11b = KSL_MUL(D->m11, R->m11),
      Do_11c = Do_11a + Do_11b, Do_11d = KSL_MUL(D->m12, R->m12), Do_11 = Do_11c + Do_11d;
  const double Do_12a = KSL_MUL(D->m10, R->m20), Do_12b = KSL_MUL(D->m11, R->m21),
      Do_12c = Do_12a + Do_12b, Do_12d = KSL_MUL(D->m12, R->m22), Do_12 = Do_12c + Do_12d;
  const double Do_20a = KSL_MUL(D->m20, R->m00), Do_20b = KSL_MUL(D->m21, R->m01),
      Do_20c = Do_20a + Do_20b, Do_20d = KSL_MUL(D->m22, R->m02), Do_20 = Do_20c + Do_20d;
  const double Do_21a = KSL_MUL(D->m20, R->m10), Do_21b = KSL_MUL(D->m21, R->m11),
      Do_21c = Do_21a + Do_21b, Do_21d = KSL_MUL(D->m22, R->m12), Do_21 = Do_21c + Do_21d;
  const double Do_22a = KSL_MUL(D->m20, R->m20), Do_22b = KSL_MUL(D->m21, R->m21),
      Do_22c = Do_22a + Do_22b, Do_22d = KSL_MUL(D->m22, R->m22), Do_22 = Do_22c + Do_22d;
  const double Do_00a_abs = fabs(Do_00a), Do_00b_abs = fabs(Do_00b),
      Do_00c_size = Do_00a_abs + Do_00b_abs, Do_00d_abs = fabs(Do_00d),
      Do_00_size = Do_00c_size + Do_00d_abs;
  const double Do_01a_abs = fabs(Do_01a), Do_01b_abs = fabs(Do_01b),
      Do_01c_size = Do_01a_abs + Do_01b_abs, Do_01d_abs = fabs(Do_01d),
      Do_01_size = Do_01c_size + Do_01d_abs;
  const double Do_02a_abs = fabs(Do_02a), Do_02b_abs = fabs(Do_02b),
      Do_02c_size = Do_02a_abs + Do_02b_abs, Do_02d_abs = fabs(Do_02d),
      Do_02_size = Do_02c_size + Do_02d_abs;
  const double Do_10a_abs = fabs(Do_10a), Do_10b_abs = fabs(Do_10b),
      Do_10c_size = Do_10a_abs + Do_10b_abs, Do_10d_abs = fabs(Do_10d),
      Do_10_size = Do_10c_size + Do_10d_abs;
  const double Do_11a_abs = fabs(Do_11a), Do_11b_abs = fabs(Do_11b),
      Do_11c_size = Do_11a_abs + Do_11b_abs, Do_11d_abs = fabs(Do_11d),
      Do_11_size = Do_11c_size + Do_11d_abs;
  const double Do_12a_abs = fabs(Do_12a), Do_12b_abs = fabs(Do_12b),
      Do_12c_size = Do_12a_abs + Do_12b_abs, Do_12d_abs = fabs(Do_12d),
      Do_12_size = Do_12c_size + Do_12d_abs;
  const double Do_20a_abs = fabs(Do_20a), Do_20b_abs = fabs(Do_20b),
      Do_20c_size = Do_20a_abs + Do_20b_abs, Do_20d_abs = fabs(Do_20d),
      Do_20_size = Do_20c_size + Do_20d_abs;
  const double Do_21a_abs = fabs(Do_21a), Do_21b_abs = fabs(Do_21b),
      Do_21c_size = Do_21a_abs + Do_21b_abs, Do_21d_abs = fabs(Do_21d),
      Do_21_size = Do_21c_size + Do_21d_abs;
  const double Do_22a_abs = fabs(Do_22a), Do_22b_abs = fabs(Do_22b),
      Do_22c_size = Do_22a_abs + Do_22b_abs, Do_22d_abs = fabs(Do_22d),
      Do_22_size = Do_22c_size + Do_22d_abs;
  const double Do_00_padded = Do_00_size + 2.004168360008973e-292,
      Do_00_error_bound = KSL_MUL(3.3306690738754706e-16, Do_00_padded);
  const double Do_01_padded = Do_01_size + 2.004168360008973e-292,
      Do_01_error_bound = KSL_MUL(3.3306690738754706e-16, Do_01_padded);
  const double Do_02_padded = Do_02_size + 2.004168360008973e-292,
      Do_02_error_bound = KSL_MUL(3.3306690738754706e-16, Do_02_padded);
  const double Do_10_padded = Do_10_size + 2.004168360008973e-292,
      Do_10_error_bound = KSL_MUL(3.3306690738754706e-16, Do_10_padded);
  const double Do_11_padded = Do_11_size + 2.004168360008973e-292,
      Do_11_error_bound = KSL_MUL(3.3306690738754706e-16, Do_11_padded);
  const double Do_12_padded = Do_12_size + 2.004168360008973e-292,
      Do_12_error_bound = KSL_MUL(3.3306690738754706e-16, Do_12_padded);
  const double Do_20_padded = Do_20_size + 2.004168360008973e-292,
      Do_20_error_bound = KSL_MUL(3.3306690738754706e-16, Do_20_padded);
  const double Do_21_padded = Do_21_size + 2.004168360008973e-292,
      Do_21_error_bound = KSL_MUL(3.3306690738754706e-16, Do_21_padded);
  const double Do_22_padded = Do_22_size + 2.004168360008973e-292,
      Do_22_error_bound = KSL_MUL(3.3306690738754706e-16, Do_22_padded);
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
  Do_bound->m00 = Do_00_error_bound;
  Do_bound->m01 = Do_01_error_bound;
  Do_bound->m02 = Do_02_error_bound;
  Do_bound->m03 = 0.0;
  Do_bound->m10 = Do_10_error_bound;
  Do_bound->m11 = Do_11_error_bound;
  Do_bound->m12 = Do_12_error_bound;
  Do_bound->m13 = 0.0;
  Do_bound->m20 = Do_20_error_bound;
  Do_bound->m21 = Do_21_error_bound;
  Do_bound->m22 = Do_22_error_bound;
  Do_bound->m23 = 0.0;
}

/* Do = D [I | t]; |error of Do| <= Do_bound unless inf or NaN.
   D, Do, Do_bound: displacement [R | t], R rotation, t in m; t: vector.
   12 mul, 21 add, 12 abs. */
static inline void ksl_product_ddt_certified(const ksl_SE3_t *D, const ksl_vec3_t *t,
    ksl_SE3_t *Do, ksl_SE3_t *Do_bound) {
  const double Do_03a = KSL_MUL(D->m00, t->x), Do_03b = KSL_MUL(D->m01, t->y),
      Do_03c = Do_03a + Do_03b, Do_03d = KSL_MUL(D->m02, t->z), Do_03e = Do_03c + Do_03d,
      Do_03 = Do_03e + D->m03;
  const double Do_13a = KSL_MUL(D->m10, t->x), Do_13b = KSL_MUL(D->m11, t->y),
      Do_13c = Do_13a + Do_13b, Do_13d = KSL_MUL(D->m12, t->z), Do_13e = Do_13c + Do_13d,
      Do_13 = Do_13e + D->m13;
  const double Do_23a = KSL_MUL(D->m20, t->x), Do_23b = KSL_MUL(D->m21, t->y),
      Do_23c = Do_23a + Do_23b, Do_23d = KSL_MUL(D->m22, t->z), Do_23e = Do_23c + Do_23d,
      Do_23 = Do_23e + D->m23;
  const double Do_03a_abs = fabs(Do_03a), Do_03b_abs = fabs(Do_03b),
      Do_03c_size = Do_03a_abs + Do_03b_abs, Do_03d_abs = fabs(Do_03d),
      Do_03e_size = Do_03c_size + Do_03d_abs, D_03_abs = fabs(D->m03),
      Do_03_size = Do_03e_size + D_03_abs;
  const double Do_13a_abs = fabs(Do_13a), Do_13b_abs = fabs(Do_13b),
      Do_13c_size = Do_13a_abs + Do_13b_abs, Do_13d_abs = fabs(Do_13d),
      Do_13e_size = Do_13c_size + Do_13d_abs, D_13_abs = fabs(D->m13),
      Do_13_size = Do_13e_size + D_13_abs;
  const double Do_23a_abs = fabs(Do_23a), Do_23b_abs = fabs(Do_23b),
      Do_23c_size = Do_23a_abs + Do_23b_abs, Do_23d_abs = fabs(Do_23d),
      Do_23e_size = Do_23c_size + Do_23d_abs, D_23_abs = fabs(D->m23),
      Do_23_size = Do_23e_size + D_23_abs;
  const double Do_03_padded = Do_03_size + 2.004168360008973e-292,
      Do_03_error_bound = KSL_MUL(4.440892098500628e-16, Do_03_padded);
  const double Do_13_padded = Do_13_size + 2.004168360008973e-292,
      Do_13_error_bound = KSL_MUL(4.440892098500628e-16, Do_13_padded);
  const double Do_23_padded = Do_23_size + 2.004168360008973e-292,
      Do_23_error_bound = KSL_MUL(4.440892098500628e-16, Do_23_padded);
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
  Do_bound->m03 = Do_03_error_bound;
  Do_bound->m10 = 0.0;
  Do_bound->m11 = 0.0;
  Do_bound->m12 = 0.0;
  Do_bound->m13 = Do_13_error_bound;
  Do_bound->m20 = 0.0;
  Do_bound->m21 = 0.0;
  Do_bound->m22 = 0.0;
  Do_bound->m23 = Do_23_error_bound;
}

/* Do = D [I | -t]; |error of Do| <= Do_bound unless inf or NaN.
   D, Do, Do_bound: displacement [R | t], R rotation, t in m; t: vector.
   12 mul, 21 add, 12 abs. */
static inline void ksl_product_ddtinv_certified(const ksl_SE3_t *D, const ksl_vec3_t *t,
    ksl_SE3_t *Do, ksl_SE3_t *Do_bound) {
  const double Do_03a = KSL_MUL(D->m00, t->x), Do_03b = KSL_MUL(D->m01, t->y),
      Do_03c = Do_03a + Do_03b, Do_03d = KSL_MUL(D->m02, t->z), Do_03e = Do_03c + Do_03d,
      Do_03 = D->m03 - Do_03e;
  const double Do_13a = KSL_MUL(D->m10, t->x), Do_13b = KSL_MUL(D->m11, t->y),
      Do_13c = Do_13a + Do_13b, Do_13d = KSL_MUL(D->m12, t->z), Do_13e = Do_13c + Do_13d,
      Do_13 = D->m13 - Do_13e;
  const double Do_23a = KSL_MUL(D->m20, t->x), Do_23b = KSL_MUL(D->m21, t->y),
      Do_23c = Do_23a + Do_23b, Do_23d = KSL_MUL(D->m22, t->z), Do_23e = Do_23c + Do_23d,
      Do_23 = D->m23 - Do_23e;
  const double Do_03a_abs = fabs(Do_03a), Do_03b_abs = fabs(Do_03b),
      Do_03c_size = Do_03a_abs + Do_03b_abs, Do_03d_abs = fabs(Do_03d),
      Do_03e_size = Do_03c_size + Do_03d_abs, D_03_abs = fabs(D->m03),
      Do_03_size = D_03_abs + Do_03e_size;
  const double Do_13a_abs = fabs(Do_13a), Do_13b_abs = fabs(Do_13b),
      Do_13c_size = Do_13a_abs + Do_13b_abs, Do_13d_abs = fabs(Do_13d),
      Do_13e_size = Do_13c_size + Do_13d_abs, D_13_abs = fabs(D->m13),
      Do_13_size = D_13_abs + Do_13e_size;
  const double Do_23a_abs = fabs(Do_23a), Do_23b_abs = fabs(Do_23b),
      Do_23c_size = Do_23a_abs + Do_23b_abs, Do_23d_abs = fabs(Do_23d),
      Do_23e_size = Do_23c_size + Do_23d_abs, D_23_abs = fabs(D->m23),
      Do_23_size = D_23_abs + Do_23e_size;
  const double Do_03_padded = Do_03_size + 2.004168360008973e-292,
      Do_03_error_bound = KSL_MUL(4.440892098500628e-16, Do_03_padded);
  const double Do_13_padded = Do_13_size + 2.004168360008973e-292,
      Do_13_error_bound = KSL_MUL(4.440892098500628e-16, Do_13_padded);
  const double Do_23_padded = Do_23_size + 2.004168360008973e-292,
      Do_23_error_bound = KSL_MUL(4.440892098500628e-16, Do_23_padded);
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
  Do_bound->m03 = Do_03_error_bound;
  Do_bound->m10 = 0.0;
  Do_bound->m11 = 0.0;
  Do_bound->m12 = 0.0;
  Do_bound->m13 = Do_13_error_bound;
  Do_bound->m20 = 0.0;
  Do_bound->m21 = 0.0;
  Do_bound->m22 = 0.0;
  Do_bound->m23 = Do_23_error_bound;
}

/* Do = D^-1 [I | t] = [R^T | R^T (t - t_D)]; |error of Do| <= Do_bound unless inf or NaN.
   D, Do, Do_bound: displacement [R | t], R rotation, t in m; t: vector.
   21 mul, 18 add, 12 abs. */
static inline void ksl_product_dinvdt_certified(const ksl_SE3_t *D, const ksl_vec3_t *t,
    ksl_SE3_t *Do, ksl_SE3_t *Do_bound) {
  const double p_0 = t->x - D->m03;
  const double p_1 = t->y - D->m13;
  const double p_2 = t->z - D->m23;
  const double Do_03a = KSL_MUL(D->m00, p_0), Do_03b = KSL_MUL(D->m10, p_1),
      Do_03c = Do_03a + Do_03b, Do_03d = KSL_MUL(D->m20, p_2), Do_03 = Do_03c + Do_03d;
  const double Do_13a = KSL_MUL(D->m01, p_0), Do_13b = KSL_MUL(D->m11, p_1),
      Do_13c = Do_13a + Do_13b, Do_13d = KSL_MUL(D->m21, p_2), Do_13 = Do_13c + Do_13d;
  const double Do_23a = KSL_MUL(D->m02, p_0), Do_23b = KSL_MUL(D->m12, p_1),
      Do_23c = Do_23a + Do_23b, Do_23d = KSL_MUL(D->m22, p_2), Do_23 = Do_23c + Do_23d;
  const double D_00_abs = fabs(D->m00), p_0_abs = fabs(p_0),
      Do_03a_size = KSL_MUL(D_00_abs, p_0_abs), D_10_abs = fabs(D->m10), p_1_abs = fabs(p_1),
      Do_03b_size = KSL_MUL(D_10_abs, p_1_abs), Do_03c_size = Do_03a_size + Do_03b_size,
      D_20_abs = fabs(D->m20), p_2_abs = fabs(p_2), Do_03d_size = KSL_MUL(D_20_abs, p_2_abs),
      Do_03_size = Do_03c_size + Do_03d_size;
  const double D_01_abs = fabs(D->m01), Do_13a_size = KSL_MUL(D_01_abs, p_0_abs),
      D_11_abs = fabs(D->m11), Do_13b_size = KSL_MUL(D_11_abs, p_1_abs),
      Do_13c_size = Do_13a_size + Do_13b_size, D_21_abs = fabs(D->m21),
      Do_13d_size = KSL_MUL(D_21_abs, p_2_abs), Do_13_size = Do_13c_size + Do_13d_size;
  const double D_02_abs = fabs(D->m02), Do_23a_size = KSL_MUL(D_02_abs, p_0_abs),
      D_12_abs = fabs(D->m12), Do_23b_size = KSL_MUL(D_12_abs, p_1_abs),
      Do_23c_size = Do_23a_size + Do_23b_size, D_22_abs = fabs(D->m22),
      Do_23d_size = KSL_MUL(D_22_abs, p_2_abs), Do_23_size = Do_23c_size + Do_23d_size;
  const double Do_03_padded = Do_03_size + 2.004168360008973e-292,
      Do_03_error_bound = KSL_MUL(4.440892098500628e-16, Do_03_padded);
  const double Do_13_padded = Do_13_size + 2.004168360008973e-292,
      Do_13_error_bound = KSL_MUL(4.440892098500628e-16, Do_13_padded);
  const double Do_23_padded = Do_23_size + 2.004168360008973e-292,
      Do_23_error_bound = KSL_MUL(4.440892098500628e-16, Do_23_padded);
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
  Do_bound->m03 = Do_03_error_bound;
  Do_bound->m10 = 0.0;
  Do_bound->m11 = 0.0;
  Do_bound->m12 = 0.0;
  Do_bound->m13 = Do_13_error_bound;
  Do_bound->m20 = 0.0;
  Do_bound->m21 = 0.0;
  Do_bound->m22 = 0.0;
  Do_bound->m23 = Do_23_error_bound;
}

/* vo = R (k e_x); |error of vo| <= vo_bound unless inf or NaN.
   R: rotation or other 3×3 matrix; k: number; vo, vo_bound: vector.
   6 mul, 3 add, 3 abs. */
static inline void ksl_product_drvtx_certified(const ksl_mat3x3_t *R, const double k,
    ksl_vec3_t *vo, ksl_vec3_t *vo_bound) {
  const double vo_0 = KSL_MUL(R->m00, k);
  const double vo_1 = KSL_MUL(R->m10, k);
  const double vo_2 = KSL_MUL(R->m20, k);
  const double vo_0_abs = fabs(vo_0), vo_0_padded = vo_0_abs + 2.004168360008973e-292,
      vo_0_error_bound = KSL_MUL(1.1102230246251568e-16, vo_0_padded);
  const double vo_1_abs = fabs(vo_1), vo_1_padded = vo_1_abs + 2.004168360008973e-292,
      vo_1_error_bound = KSL_MUL(1.1102230246251568e-16, vo_1_padded);
  const double vo_2_abs = fabs(vo_2), vo_2_padded = vo_2_abs + 2.004168360008973e-292,
      vo_2_error_bound = KSL_MUL(1.1102230246251568e-16, vo_2_padded);
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
  vo_bound->x = vo_0_error_bound;
  vo_bound->y = vo_1_error_bound;
  vo_bound->z = vo_2_error_bound;
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
  const double Ro_01a_abs = fabs(Ro_01a), Ro_01b_abs = fabs(Ro_01b),
      Ro_01_size = Ro_01a_abs + Ro_01b_abs;
  const double Ro_02a_abs = fabs(Ro_02a), Ro_02b_abs = fabs(Ro_02b),
      Ro_02_size = Ro_02a_abs + Ro_02b_abs;
  const double Ro_11a_abs = fabs(Ro_11a), Ro_11b_abs = fabs(Ro_11b),
      Ro_11_size = Ro_11a_abs + Ro_11b_abs;
  const double Ro_12a_abs = fabs(Ro_12a), Ro_12b_abs = fabs(Ro_12b),
      Ro_12_size = Ro_12a_abs + Ro_12b_abs;
  const double Ro_21a_abs = fabs(Ro_21a), Ro_21b_abs = fabs(Ro_21b),
      Ro_21_size = Ro_21a_abs + Ro_21b_abs;
  const double Ro_22a_abs = fabs(Ro_22a), Ro_22b_abs = fabs(Ro_22b),
      Ro_22_size = Ro_22a_abs + Ro_22b_abs;
  const double Ro_01_padded = Ro_01_size + 2.004168360008973e-292,
      Ro_01_error_bound = KSL_MUL(2.2204460492503136e-16, Ro_01_padded);
  const double Ro_02_padded = Ro_02_size + 2.004168360008973e-292,
      Ro_02_error_bound = KSL_MUL(2.2204460492503136e-16, Ro_02_padded);
  const double Ro_11_padded = Ro_11_size + 2.004168360008973e-292,
      Ro_11_error_bound = KSL_MUL(2.2204460492503136e-16, Ro_11_padded);
  const double Ro_12_padded = Ro_12_size + 2.004168360008973e-292,
      Ro_12_error_bound = KSL_MUL(2.2204460492503136e-16, Ro_12_padded);
  const double Ro_21_padded = Ro_21_size + 2.004168360008973e-292,
      Ro_21_error_bound = KSL_MUL(2.2204460492503136e-16, Ro_21_padded);
  const double Ro_22_padded = Ro_22_size + 2.004168360008973e-292,
      Ro_22_error_bound = KSL_MUL(2.2204460492503136e-16, Ro_22_padded);
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
  Ro_bound->m01 = Ro_01_error_bound;
  Ro_bound->m02 = Ro_02_error_bound;
  Ro_bound->m10 = 0.0;
  Ro_bound->m11 = Ro_11_error_bound;
  Ro_bound->m12 = Ro_12_error_bound;
  Ro_bound->m20 = 0.0;
  Ro_bound->m21 = Ro_21_error_bound;
  Ro_bound->m22 = Ro_22_error_bound;
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
  const double Do_01a_abs = fabs(Do_01a), Do_01b_abs = fabs(Do_01b),
      Do_01_size = Do_01a_abs + Do_01b_abs;
  const double Do_02a_abs = fabs(Do_02a), Do_02b_abs = fabs(Do_02b),
      Do_02_size = Do_02a_abs + Do_02b_abs;
  const double Do_11a_abs = fabs(Do_11a), Do_11b_abs = fabs(Do_11b),
      Do_11_size = Do_11a_abs + Do_11b_abs;
  const double Do_12a_abs = fabs(Do_12a), Do_12b_abs = fabs(Do_12b),
      Do_12_size = Do_12a_abs + Do_12b_abs;
  const double Do_21a_abs = fabs(Do_21a), Do_21b_abs = fabs(Do_21b),
      Do_21_size = Do_21a_abs + Do_21b_abs;
  const double Do_22a_abs = fabs(Do_22a), Do_22b_abs = fabs(Do_22b),
      Do_22_size = Do_22a_abs + Do_22b_abs;
  const double Do_01_padded = Do_01_size + 2.004168360008973e-292,
      Do_01_error_bound = KSL_MUL(2.2204460492503136e-16, Do_01_padded);
  const double Do_02_padded = Do_02_size + 2.004168360008973e-292,
      Do_02_error_bound = KSL_MUL(2.2204460492503136e-16, Do_02_padded);
  const double Do_11_padded = Do_11_size + 2.004168360008973e-292,
      Do_11_error_bound = KSL_MUL(2.2204460492503136e-16, Do_11_padded);
  const double Do_12_padded = Do_12_size + 2.004168360008973e-292,
      Do_12_error_bound = KSL_MUL(2.2204460492503136e-16, Do_12_padded);
  const double Do_21_padded = Do_21_size + 2.004168360008973e-292,
      Do_21_error_bound = KSL_MUL(2.2204460492503136e-16, Do_21_padded);
  const double Do_22_padded = Do_22_size + 2.004168360008973e-292,
      Do_22_error_bound = KSL_MUL(2.2204460492503136e-16, Do_22_padded);
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
  Do_bound->m01 = Do_01_error_bound;
  Do_bound->m02 = Do_02_error_bound;
  Do_bound->m03 = 0.0;
  Do_bound->m10 = 0.0;
  Do_bound->m11 = Do_11_error_bound;
  Do_bound->m12 = Do_12_error_bound;
  Do_bound->m13 = 0.0;
  Do_bound->m20 = 0.0;
  Do_bound->m21 = Do_21_error_bound;
  Do_bound->m22 = Do_22_error_bound;
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
  const double Do_03a_abs = fabs(Do_03a), D_03_abs = fabs(D->m03),
      Do_03_size = Do_03a_abs + D_03_abs;
  const double Do_13a_abs = fabs(Do_13a), D_13_abs = fabs(D->m13),
      Do_13_size = Do_13a_abs + D_13_abs;
  const double Do_23a_abs = fabs(Do_23a), D_23_abs = fabs(D->m23),
      Do_23_size = Do_23a_abs + D_23_abs;
  const double Do_03_padded = Do_03_size + 2.004168360008973e-292,
      Do_03_error_bound = KSL_MUL(2.2204460492503136e-16, Do_03_padded);
  const double Do_13_padded = Do_13_size + 2.004168360008973e-292,
      Do_13_error_bound = KSL_MUL(2.2204460492503136e-16, Do_13_padded);
  const double Do_23_padded = Do_23_size + 2.004168360008973e-292,
      Do_23_error_bound = KSL_MUL(2.2204460492503136e-16, Do_23_padded);
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
  Do_bound->m03 = Do_03_error_bound;
  Do_bound->m10 = 0.0;
  Do_bound->m11 = 0.0;
  Do_bound->m12 = 0.0;
  Do_bound->m13 = Do_13_error_bound;
  Do_bound->m20 = 0.0;
  Do_bound->m21 = 0.0;
  Do_bound->m22 = 0.0;
  Do_bound->m23 = Do_23_error_bound;
}

/* vo = R (-k e_x); |error of vo| <= vo_bound unless inf or NaN.
   R: rotation or other 3×3 matrix; k: number; vo, vo_bound: vector.
   6 mul, 3 add, 3 neg, 3 abs. */
static inline void ksl_product_drvtxinv_certified(const ksl_mat3x3_t *R, const double k,
    ksl_vec3_t *vo, ksl_vec3_t *vo_bound) {
  const double vo_0a = KSL_MUL(R->m00, k), vo_0 = -vo_0a;
  const double vo_1a = KSL_MUL(R->m10, k), vo_1 = -vo_1a;
  const double vo_2a = KSL_MUL(R->m20, k), vo_2 = -vo_2a;
  const double vo_0a_abs = fabs(vo_0a), vo_0a_padded = vo_0a_abs + 2.004168360008973e-292,
      vo_0a_error_bound = KSL_MUL(1.1102230246251568e-16, vo_0a_padded);
  const double vo_1a_abs = fabs(vo_1a), vo_1a_padded = vo_1a_abs + 2.004168360008973e-292,
      vo_1a_error_bound = KSL_MUL(1.1102230246251568e-16, vo_1a_padded);
  const double vo_2a_abs = fabs(vo_2a), vo_2a_padded = vo_2a_abs + 2.004168360008973e-292,
      vo_2a_error_bound = KSL_MUL(1.1102230246251568e-16, vo_2a_padded);
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
  vo_bound->x = vo_0a_error_bound;
  vo_bound->y = vo_1a_error_bound;
  vo_bound->z = vo_2a_error_bound;
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
  const double Ro_01a_abs = fabs(Ro_01a), Ro_01b_abs = fabs(Ro_01b),
      Ro_01_size = Ro_01a_abs + Ro_01b_abs;
  const double Ro_02a_abs = fabs(Ro_02a), Ro_02b_abs = fabs(Ro_02b),
      Ro_02_size = Ro_02a_abs + Ro_02b_abs;
  const double Ro_11a_abs = fabs(Ro_11a), Ro_11b_abs = fabs(Ro_11b),
      Ro_11_size = Ro_11a_abs + Ro_11b_abs;
  const double Ro_12a_abs = fabs(Ro_12a), Ro_12b_abs = fabs(Ro_12b),
      Ro_12_size = Ro_12a_abs + Ro_12b_abs;
  const double Ro_21a_abs = fabs(Ro_21a), Ro_21b_abs = fabs(Ro_21b),
      Ro_21_size = Ro_21a_abs + Ro_21b_abs;
  const double Ro_22a_abs = fabs(Ro_22a), Ro_22b_abs = fabs(Ro_22b),
      Ro_22_size = Ro_22a_abs + Ro_22b_abs;
  const double Ro_01_padded = Ro_01_size + 2.004168360008973e-292,
      Ro_01_error_bound = KSL_MUL(2.2204460492503136e-16, Ro_01_padded);
  const double Ro_02_padded = Ro_02_size + 2.004168360008973e-292,
      Ro_02_error_bound = KSL_MUL(2.2204460492503136e-16, Ro_02_padded);
  const double Ro_11_padded = Ro_11_size + 2.004168360008973e-292,
      Ro_11_error_bound = KSL_MUL(2.2204460492503136e-16, Ro_11_padded);
  const double Ro_12_padded = Ro_12_size + 2.004168360008973e-292,
      Ro_12_error_bound = KSL_MUL(2.2204460492503136e-16, Ro_12_padded);
  const double Ro_21_padded = Ro_21_size + 2.004168360008973e-292,
      Ro_21_error_bound = KSL_MUL(2.2204460492503136e-16, Ro_21_padded);
  const double Ro_22_padded = Ro_22_size + 2.004168360008973e-292,
      Ro_22_error_bound = KSL_MUL(2.2204460492503136e-16, Ro_22_padded);
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
  Ro_bound->m01 = Ro_01_error_bound;
  Ro_bound->m02 = Ro_02_error_bound;
  Ro_bound->m10 = 0.0;
  Ro_bound->m11 = Ro_11_error_bound;
  Ro_bound->m12 = Ro_12_error_bound;
  Ro_bound->m20 = 0.0;
  Ro_bound->m21 = Ro_21_error_bound;
  Ro_bound->m22 = Ro_22_error_bound;
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
  const double Do_01a_abs = fabs(Do_01a), Do_01b_abs = fabs(Do_01b),
      Do_01_size = Do_01a_abs + Do_01b_abs;
  const double Do_02a_abs = fabs(Do_02a), Do_02b_abs = fabs(Do_02b),
      Do_02_size = Do_02a_abs + Do_02b_abs;
  const double Do_11a_abs = fabs(Do_11a), Do_11b_abs = fabs(Do_11b),
      Do_11_size = Do_11a_abs + Do_11b_abs;
  const double Do_12a_abs = fabs(Do_12a), Do_12b_abs = fabs(Do_12b),
      Do_12_size = Do_12a_abs + Do_12b_abs;
  const double Do_21a_abs = fabs(Do_21a), Do_21b_abs = fabs(Do_21b),
      Do_21_size = Do_21a_abs + Do_21b_abs;
  const double Do_22a_abs = fabs(Do_22a), Do_22b_abs = fabs(Do_22b),
      Do_22_size = Do_22a_abs + Do_22b_abs;
  const double Do_01_padded = Do_01_size + 2.004168360008973e-292,
      Do_01_error_bound = KSL_MUL(2.2204460492503136e-16, Do_01_padded);
  const double Do_02_padded = Do_02_size + 2.004168360008973e-292,
      Do_02_error_bound = KSL_MUL(2.2204460492503136e-16, Do_02_padded);
  const double Do_11_padded = Do_11_size + 2.004168360008973e-292,
      Do_11_error_bound = KSL_MUL(2.2204460492503136e-16, Do_11_padded);
  const double Do_12_padded = Do_12_size + 2.004168360008973e-292,
      Do_12_error_bound = KSL_MUL(2.2204460492503136e-16, Do_12_padded);
  const double Do_21_padded = Do_21_size + 2.004168360008973e-292,
      Do_21_error_bound = KSL_MUL(2.2204460492503136e-16, Do_21_padded);
  const double Do_22_padded = Do_22_size + 2.004168360008973e-292,
      Do_22_error_bound = KSL_MUL(2.2204460492503136e-16, Do_22_padded);
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
  Do_bound->m01 = Do_01_error_bound;
  Do_bound->m02 = Do_02_error_bound;
  Do_bound->m03 = 0.0;
  Do_bound->m10 = 0.0;
  Do_bound->m11 = Do_11_error_bound;
  Do_bound->m12 = Do_12_error_bound;
  Do_bound->m13 = 0.0;
  Do_bound->m20 = 0.0;
  Do_bound->m21 = Do_21_error_bound;
  Do_bound->m22 = Do_22_error_bound;
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
  const double D_03_abs = fabs(D->m03), Do_03a_abs = fabs(Do_03a),
      Do_03_size = D_03_abs + Do_03a_abs;
  const double D_13_abs = fabs(D->m13), Do_13a_abs = fabs(Do_13a),
      Do_13_size = D_13_abs + Do_13a_abs;
  const double D_23_abs = fabs(D->m23), Do_23a_abs = fabs(Do_23a),
      Do_23_size = D_23_abs + Do_23a_abs;
  const double Do_03_padded = Do_03_size + 2.004168360008973e-292,
      Do_03_error_bound = KSL_MUL(2.2204460492503136e-16, Do_03_padded);
  const double Do_13_padded = Do_13_size + 2.004168360008973e-292,
      Do_13_error_bound = KSL_MUL(2.2204460492503136e-16, Do_13_padded);
  const double Do_23_padded = Do_23_size + 2.004168360008973e-292,
      Do_23_error_bound = KSL_MUL(2.2204460492503136e-16, Do_23_padded);
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
  Do_bound->m03 = Do_03_error_bound;
  Do_bound->m10 = 0.0;
  Do_bound->m11 = 0.0;
  Do_bound->m12 = 0.0;
  Do_bound->m13 = Do_13_error_bound;
  Do_bound->m20 = 0.0;
  Do_bound->m21 = 0.0;
  Do_bound->m22 = 0.0;
  Do_bound->m23 = Do_23_error_bound;
}

/* vo = R (k e_y); |error of vo| <= vo_bound unless inf or NaN.
   R: rotation or other 3×3 matrix; k: number; vo, vo_bound: vector.
   6 mul, 3 add, 3 abs. */
static inline void ksl_product_drvty_certified(const ksl_mat3x3_t *R, const double k,
    ksl_vec3_t *vo, ksl_vec3_t *vo_bound) {
  const double vo_0 = KSL_MUL(R->m01, k);
  const double vo_1 = KSL_MUL(R->m11, k);
  const double vo_2 = KSL_MUL(R->m21, k);
  const double vo_0_abs = fabs(vo_0), vo_0_padded = vo_0_abs + 2.004168360008973e-292,
      vo_0_error_bound = KSL_MUL(1.1102230246251568e-16, vo_0_padded);
  const double vo_1_abs = fabs(vo_1), vo_1_padded = vo_1_abs + 2.004168360008973e-292,
      vo_1_error_bound = KSL_MUL(1.1102230246251568e-16, vo_1_padded);
  const double vo_2_abs = fabs(vo_2), vo_2_padded = vo_2_abs + 2.004168360008973e-292,
      vo_2_error_bound = KSL_MUL(1.1102230246251568e-16, vo_2_padded);
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
  vo_bound->x = vo_0_error_bound;
  vo_bound->y = vo_1_error_bound;
  vo_bound->z = vo_2_error_bound;
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
  const double Ro_00a_abs = fabs(Ro_00a), Ro_00b_abs = fabs(Ro_00b),
      Ro_00_size = Ro_00a_abs + Ro_00b_abs;
  const double Ro_02a_abs = fabs(Ro_02a), Ro_02b_abs = fabs(Ro_02b),
      Ro_02_size = Ro_02a_abs + Ro_02b_abs;
  const double Ro_10a_abs = fabs(Ro_10a), Ro_10b_abs = fabs(Ro_10b),
      Ro_10_size = Ro_10a_abs + Ro_10b_abs;
  const double Ro_12a_abs = fabs(Ro_12a), Ro_12b_abs = fabs(Ro_12b),
      Ro_12_size = Ro_12a_abs + Ro_12b_abs;
  const double Ro_20a_abs = fabs(Ro_20a), Ro_20b_abs = fabs(Ro_20b),
      Ro_20_size = Ro_20a_abs + Ro_20b_abs;
  const double Ro_22a_abs = fabs(Ro_22a), Ro_22b_abs = fabs(Ro_22b),
      Ro_22_size = Ro_22a_abs + Ro_22b_abs;
  const double Ro_00_padded = Ro_00_size + 2.004168360008973e-292,
      Ro_00_error_bound = KSL_MUL(2.2204460492503136e-16, Ro_00_padded);
  const double Ro_02_padded = Ro_02_size + 2.004168360008973e-292,
      Ro_02_error_bound = KSL_MUL(2.2204460492503136e-16, Ro_02_padded);
  const double Ro_10_padded = Ro_10_size + 2.004168360008973e-292,
      Ro_10_error_bound = KSL_MUL(2.2204460492503136e-16, Ro_10_padded);
  const double Ro_12_padded = Ro_12_size + 2.004168360008973e-292,
      Ro_12_error_bound = KSL_MUL(2.2204460492503136e-16, Ro_12_padded);
  const double Ro_20_padded = Ro_20_size + 2.004168360008973e-292,
      Ro_20_error_bound = KSL_MUL(2.2204460492503136e-16, Ro_20_padded);
  const double Ro_22_padded = Ro_22_size + 2.004168360008973e-292,
      Ro_22_error_bound = KSL_MUL(2.2204460492503136e-16, Ro_22_padded);
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
  Ro_bound->m00 = Ro_00_error_bound;
  Ro_bound->m01 = 0.0;
  Ro_bound->m02 = Ro_02_error_bound;
  Ro_bound->m10 = Ro_10_error_bound;
  Ro_bound->m11 = 0.0;
  Ro_bound->m12 = Ro_12_error_bound;
  Ro_bound->m20 = Ro_20_error_bound;
  Ro_bound->m21 = 0.0;
  Ro_bound->m22 = Ro_22_error_bound;
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
  const double Do_00a_abs = fabs(Do_00a), Do_00b_abs = fabs(Do_00b),
      Do_00_size = Do_00a_abs + Do_00b_abs;
  const double Do_02a_abs = fabs(Do_02a), Do_02b_abs = fabs(Do_02b),
      Do_02_size = Do_02a_abs + Do_02b_abs;
  const double Do_10a_abs = fabs(Do_10a), Do_10b_abs = fabs(Do_10b),
      Do_10_size = Do_10a_abs + Do_10b_abs;
  const double Do_12a_abs = fabs(Do_12a), Do_12b_abs = fabs(Do_12b),
      Do_12_size = Do_12a_abs + Do_12b_abs;
  const double Do_20a_abs = fabs(Do_20a), Do_20b_abs = fabs(Do_20b),
      Do_20_size = Do_20a_abs + Do_20b_abs;
  const double Do_22a_abs = fabs(Do_22a), Do_22b_abs = fabs(Do_22b),
      Do_22_size = Do_22a_abs + Do_22b_abs;
  const double Do_00_padded = Do_00_size + 2.004168360008973e-292,
      Do_00_error_bound = KSL_MUL(2.2204460492503136e-16, Do_00_padded);
  const double Do_02_padded = Do_02_size + 2.004168360008973e-292,
      Do_02_error_bound = KSL_MUL(2.2204460492503136e-16, Do_02_padded);
  const double Do_10_padded = Do_10_size + 2.004168360008973e-292,
      Do_10_error_bound = KSL_MUL(2.2204460492503136e-16, Do_10_padded);
  const double Do_12_padded = Do_12_size + 2.004168360008973e-292,
      Do_12_error_bound = KSL_MUL(2.2204460492503136e-16, Do_12_padded);
  const double Do_20_padded = Do_20_size + 2.004168360008973e-292,
      Do_20_error_bound = KSL_MUL(2.2204460492503136e-16, Do_20_padded);
  const double Do_22_padded = Do_22_size + 2.004168360008973e-292,
      Do_22_error_bound = KSL_MUL(2.2204460492503136e-16, Do_22_padded);
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
  Do_bound->m00 = Do_00_error_bound;
  Do_bound->m01 = 0.0;
  Do_bound->m02 = Do_02_error_bound;
  Do_bound->m03 = 0.0;
  Do_bound->m10 = Do_10_error_bound;
  Do_bound->m11 = 0.0;
  Do_bound->m12 = Do_12_error_bound;
  Do_bound->m13 = 0.0;
  Do_bound->m20 = Do_20_error_bound;
  Do_bound->m21 = 0.0;
  Do_bound->m22 = Do_22_error_bound;
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
  const double Do_03a_abs = fabs(Do_03a), D_03_abs = fabs(D->m03),
      Do_03_size = Do_03a_abs + D_03_abs;
  const double Do_13a_abs = fabs(Do_13a), D_13_abs = fabs(D->m13),
      Do_13_size = Do_13a_abs + D_13_abs;
  const double Do_23a_abs = fabs(Do_23a), D_23_abs = fabs(D->m23),
      Do_23_size = Do_23a_abs + D_23_abs;
  const double Do_03_padded = Do_03_size + 2.004168360008973e-292,
      Do_03_error_bound = KSL_MUL(2.2204460492503136e-16, Do_03_padded);
  const double Do_13_padded = Do_13_size + 2.004168360008973e-292,
      Do_13_error_bound = KSL_MUL(2.2204460492503136e-16, Do_13_padded);
  const double Do_23_padded = Do_23_size + 2.004168360008973e-292,
      Do_23_error_bound = KSL_MUL(2.2204460492503136e-16, Do_23_padded);
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
  Do_bound->m03 = Do_03_error_bound;
  Do_bound->m10 = 0.0;
  Do_bound->m11 = 0.0;
  Do_bound->m12 = 0.0;
  Do_bound->m13 = Do_13_error_bound;
  Do_bound->m20 = 0.0;
  Do_bound->m21 = 0.0;
  Do_bound->m22 = 0.0;
  Do_bound->m23 = Do_23_error_bound;
}

/* vo = R (-k e_y); |error of vo| <= vo_bound unless inf or NaN.
   R: rotation or other 3×3 matrix; k: number; vo, vo_bound: vector.
   6 mul, 3 add, 3 neg, 3 abs. */
static inline void ksl_product_drvtyinv_certified(const ksl_mat3x3_t *R, const double k,
    ksl_vec3_t *vo, ksl_vec3_t *vo_bound) {
  const double vo_0a = KSL_MUL(R->m01, k), vo_0 = -vo_0a;
  const double vo_1a = KSL_MUL(R->m11, k), vo_1 = -vo_1a;
  const double vo_2a = KSL_MUL(R->m21, k), vo_2 = -vo_2a;
  const double vo_0a_abs = fabs(vo_0a), vo_0a_padded = vo_0a_abs + 2.004168360008973e-292,
      vo_0a_error_bound = KSL_MUL(1.1102230246251568e-16, vo_0a_padded);
  const double vo_1a_abs = fabs(vo_1a), vo_1a_padded = vo_1a_abs + 2.004168360008973e-292,
      vo_1a_error_bound = KSL_MUL(1.1102230246251568e-16, vo_1a_padded);
  const double vo_2a_abs = fabs(vo_2a), vo_2a_padded = vo_2a_abs + 2.004168360008973e-292,
      vo_2a_error_bound = KSL_MUL(1.1102230246251568e-16, vo_2a_padded);
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
  vo_bound->x = vo_0a_error_bound;
  vo_bound->y = vo_1a_error_bound;
  vo_bound->z = vo_2a_error_bound;
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
  const double Ro_00a_abs = fabs(Ro_00a), Ro_00b_abs = fabs(Ro_00b),
      Ro_00_size = Ro_00a_abs + Ro_00b_abs;
  const double Ro_02a_abs = fabs(Ro_02a), Ro_02b_abs = fabs(Ro_02b),
      Ro_02_size = Ro_02a_abs + Ro_02b_abs;
  const double Ro_10a_abs = fabs(Ro_10a), Ro_10b_abs = fabs(Ro_10b),
      Ro_10_size = Ro_10a_abs + Ro_10b_abs;
  const double Ro_12a_abs = fabs(Ro_12a), Ro_12b_abs = fabs(Ro_12b),
      Ro_12_size = Ro_12a_abs + Ro_12b_abs;
  const double Ro_20a_abs = fabs(Ro_20a), Ro_20b_abs = fabs(Ro_20b),
      Ro_20_size = Ro_20a_abs + Ro_20b_abs;
  const double Ro_22a_abs = fabs(Ro_22a), Ro_22b_abs = fabs(Ro_22b),
      Ro_22_size = Ro_22a_abs + Ro_22b_abs;
  const double Ro_00_padded = Ro_00_size + 2.004168360008973e-292,
      Ro_00_error_bound = KSL_MUL(2.2204460492503136e-16, Ro_00_padded);
  const double Ro_02_padded = Ro_02_size + 2.004168360008973e-292,
      Ro_02_error_bound = KSL_MUL(2.2204460492503136e-16, Ro_02_padded);
  const double Ro_10_padded = Ro_10_size + 2.004168360008973e-292,
      Ro_10_error_bound = KSL_MUL(2.2204460492503136e-16, Ro_10_padded);
  const double Ro_12_padded = Ro_12_size + 2.004168360008973e-292,
      Ro_12_error_bound = KSL_MUL(2.2204460492503136e-16, Ro_12_padded);
  const double Ro_20_padded = Ro_20_size + 2.004168360008973e-292,
      Ro_20_error_bound = KSL_MUL(2.2204460492503136e-16, Ro_20_padded);
  const double Ro_22_padded = Ro_22_size + 2.004168360008973e-292,
      Ro_22_error_bound = KSL_MUL(2.2204460492503136e-16, Ro_22_padded);
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
  Ro_bound->m00 = Ro_00_error_bound;
  Ro_bound->m01 = 0.0;
  Ro_bound->m02 = Ro_02_error_bound;
  Ro_bound->m10 = Ro_10_error_bound;
  Ro_bound->m11 = 0.0;
  Ro_bound->m12 = Ro_12_error_bound;
  Ro_bound->m20 = Ro_20_error_bound;
  Ro_bound->m21 = 0.0;
  Ro_bound->m22 = Ro_22_error_bound;
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
  const double Do_00a_abs = fabs(Do_00a), Do_00b_abs = fabs(Do_00b),
      Do_00_size = Do_00a_abs + Do_00b_abs;
  const double Do_02a_abs = fabs(Do_02a), Do_02b_abs = fabs(Do_02b),
      Do_02_size = Do_02a_abs + Do_02b_abs;
  const double Do_10a_abs = fabs(Do_10a), Do_10b_abs = fabs(Do_10b),
      Do_10_size = Do_10a_abs + Do_10b_abs;
  const double Do_12a_abs = fabs(Do_12a), Do_12b_abs = fabs(Do_12b),
      Do_12_size = Do_12a_abs + Do_12b_abs;
  const double Do_20a_abs = fabs(Do_20a), Do_20b_abs = fabs(Do_20b),
      Do_20_size = Do_20a_abs + Do_20b_abs;
  const double Do_22a_abs = fabs(Do_22a), Do_22b_abs = fabs(Do_22b),
      Do_22_size = Do_22a_abs + Do_22b_abs;
  const double Do_00_padded = Do_00_size + 2.004168360008973e-292,
      Do_00_error_bound = KSL_MUL(2.2204460492503136e-16, Do_00_padded);
  const double Do_02_padded = Do_02_size + 2.004168360008973e-292,
      Do_02_error_bound = KSL_MUL(2.2204460492503136e-16, Do_02_padded);
  const double Do_10_padded = Do_10_size + 2.004168360008973e-292,
      Do_10_error_bound = KSL_MUL(2.2204460492503136e-16, Do_10_padded);
  const double Do_12_padded = Do_12_size + 2.004168360008973e-292,
      Do_12_error_bound = KSL_MUL(2.2204460492503136e-16, Do_12_padded);
  const double Do_20_padded = Do_20_size + 2.004168360008973e-292,
      Do_20_error_bound = KSL_MUL(2.2204460492503136e-16, Do_20_padded);
  const double Do_22_padded = Do_22_size + 2.004168360008973e-292,
      Do_22_error_bound = KSL_MUL(2.2204460492503136e-16, Do_22_padded);
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
  Do_bound->m00 = Do_00_error_bound;
  Do_bound->m01 = 0.0;
  Do_bound->m02 = Do_02_error_bound;
  Do_bound->m03 = 0.0;
  Do_bound->m10 = Do_10_error_bound;
  Do_bound->m11 = 0.0;
  Do_bound->m12 = Do_12_error_bound;
  Do_bound->m13 = 0.0;
  Do_bound->m20 = Do_20_error_bound;
  Do_bound->m21 = 0.0;
  Do_bound->m22 = Do_22_error_bound;
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
  const double D_03_abs = fabs(D->m03), Do_03a_abs = fabs(Do_03a),
      Do_03_size = D_03_abs + Do_03a_abs;
  const double D_13_abs = fabs(D->m13), Do_13a_abs = fabs(Do_13a),
      Do_13_size = D_13_abs + Do_13a_abs;
  const double D_23_abs = fabs(D->m23), Do_23a_abs = fabs(Do_23a),
      Do_23_size = D_23_abs + Do_23a_abs;
  const double Do_03_padded = Do_03_size + 2.004168360008973e-292,
      Do_03_error_bound = KSL_MUL(2.2204460492503136e-16, Do_03_padded);
  const double Do_13_padded = Do_13_size + 2.004168360008973e-292,
      Do_13_error_bound = KSL_MUL(2.2204460492503136e-16, Do_13_padded);
  const double Do_23_padded = Do_23_size + 2.004168360008973e-292,
      Do_23_error_bound = KSL_MUL(2.2204460492503136e-16, Do_23_padded);
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
  Do_bound->m03 = Do_03_error_bound;
  Do_bound->m10 = 0.0;
  Do_bound->m11 = 0.0;
  Do_bound->m12 = 0.0;
  Do_bound->m13 = Do_13_error_bound;
  Do_bound->m20 = 0.0;
  Do_bound->m21 = 0.0;
  Do_bound->m22 = 0.0;
  Do_bound->m23 = Do_23_error_bound;
}

/* vo = R (k e_z); |error of vo| <= vo_bound unless inf or NaN.
   R: rotation or other 3×3 matrix; k: number; vo, vo_bound: vector.
   6 mul, 3 add, 3 abs. */
static inline void ksl_product_drvtz_certified(const ksl_mat3x3_t *R, const double k,
    ksl_vec3_t *vo, ksl_vec3_t *vo_bound) {
  const double vo_0 = KSL_MUL(R->m02, k);
  const double vo_1 = KSL_MUL(R->m12, k);
  const double vo_2 = KSL_MUL(R->m22, k);
  const double vo_0_abs = fabs(vo_0), vo_0_padded = vo_0_abs + 2.004168360008973e-292,
      vo_0_error_bound = KSL_MUL(1.1102230246251568e-16, vo_0_padded);
  const double vo_1_abs = fabs(vo_1), vo_1_padded = vo_1_abs + 2.004168360008973e-292,
      vo_1_error_bound = KSL_MUL(1.1102230246251568e-16, vo_1_padded);
  const double vo_2_abs = fabs(vo_2), vo_2_padded = vo_2_abs + 2.004168360008973e-292,
      vo_2_error_bound = KSL_MUL(1.1102230246251568e-16, vo_2_padded);
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
  vo_bound->x = vo_0_error_bound;
  vo_bound->y = vo_1_error_bound;
  vo_bound->z = vo_2_error_bound;
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
  const double Ro_00a_abs = fabs(Ro_00a), Ro_00b_abs = fabs(Ro_00b),
      Ro_00_size = Ro_00a_abs + Ro_00b_abs;
  const double Ro_01a_abs = fabs(Ro_01a), Ro_01b_abs = fabs(Ro_01b),
      Ro_01_size = Ro_01a_abs + Ro_01b_abs;
  const double Ro_10a_abs = fabs(Ro_10a), Ro_10b_abs = fabs(Ro_10b),
      Ro_10_size = Ro_10a_abs + Ro_10b_abs;
  const double Ro_11a_abs = fabs(Ro_11a), Ro_11b_abs = fabs(Ro_11b),
      Ro_11_size = Ro_11a_abs + Ro_11b_abs;
  const double Ro_20a_abs = fabs(Ro_20a), Ro_20b_abs = fabs(Ro_20b),
      Ro_20_size = Ro_20a_abs + Ro_20b_abs;
  const double Ro_21a_abs = fabs(Ro_21a), Ro_21b_abs = fabs(Ro_21b),
      Ro_21_size = Ro_21a_abs + Ro_21b_abs;
  const double Ro_00_padded = Ro_00_size + 2.004168360008973e-292,
      Ro_00_error_bound = KSL_MUL(2.2204460492503136e-16, Ro_00_padded);
  const double Ro_01_padded = Ro_01_size + 2.004168360008973e-292,
      Ro_01_error_bound = KSL_MUL(2.2204460492503136e-16, Ro_01_padded);
  const double Ro_10_padded = Ro_10_size + 2.004168360008973e-292,
      Ro_10_error_bound = KSL_MUL(2.2204460492503136e-16, Ro_10_padded);
  const double Ro_11_padded = Ro_11_size + 2.004168360008973e-292,
      Ro_11_error_bound = KSL_MUL(2.2204460492503136e-16, Ro_11_padded);
  const double Ro_20_padded = Ro_20_size + 2.004168360008973e-292,
      Ro_20_error_bound = KSL_MUL(2.2204460492503136e-16, Ro_20_padded);
  const double Ro_21_padded = Ro_21_size + 2.004168360008973e-292,
      Ro_21_error_bound = KSL_MUL(2.2204460492503136e-16, Ro_21_padded);
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
  Ro_bound->m00 = Ro_00_error_bound;
  Ro_bound->m01 = Ro_01_error_bound;
  Ro_bound->m02 = 0.0;
  Ro_bound->m10 = Ro_10_error_bound;
  Ro_bound->m11 = Ro_11_error_bound;
  Ro_bound->m12 = 0.0;
  Ro_bound->m20 = Ro_20_error_bound;
  Ro_bound->m21 = Ro_21_error_bound;
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
  const double Do_00a_abs = fabs(Do_00a), Do_00b_abs = fabs(Do_00b),
      Do_00_size = Do_00a_abs + Do_00b_abs;
  const double Do_01a_abs = fabs(Do_01a), Do_01b_abs = fabs(Do_01b),
      Do_01_size = Do_01a_abs + Do_01b_abs;
  const double Do_10a_abs = fabs(Do_10a), Do_10b_abs = fabs(Do_10b),
      Do_10_size = Do_10a_abs + Do_10b_abs;
  const double Do_11a_abs = fabs(Do_11a), Do_11b_abs = fabs(Do_11b),
      Do_11_size = Do_11a_abs + Do_11b_abs;
  const double Do_20a_abs = fabs(Do_20a), Do_20b_abs = fabs(Do_20b),
      Do_20_size = Do_20a_abs + Do_20b_abs;
  const double Do_21a_abs = fabs(Do_21a), Do_21b_abs = fabs(Do_21b),
      Do_21_size = Do_21a_abs + Do_21b_abs;
  const double Do_00_padded = Do_00_size + 2.004168360008973e-292,
      Do_00_error_bound = KSL_MUL(2.2204460492503136e-16, Do_00_padded);
  const double Do_01_padded = Do_01_size + 2.004168360008973e-292,
      Do_01_error_bound = KSL_MUL(2.2204460492503136e-16, Do_01_padded);
  const double Do_10_padded = Do_10_size + 2.004168360008973e-292,
      Do_10_error_bound = KSL_MUL(2.2204460492503136e-16, Do_10_padded);
  const double Do_11_padded = Do_11_size + 2.004168360008973e-292,
      Do_11_error_bound = KSL_MUL(2.2204460492503136e-16, Do_11_padded);
  const double Do_20_padded = Do_20_size + 2.004168360008973e-292,
      Do_20_error_bound = KSL_MUL(2.2204460492503136e-16, Do_20_padded);
  const double Do_21_padded = Do_21_size + 2.004168360008973e-292,
      Do_21_error_bound = KSL_MUL(2.2204460492503136e-16, Do_21_padded);
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
  Do_bound->m00 = Do_00_error_bound;
  Do_bound->m01 = Do_01_error_bound;
  Do_bound->m02 = 0.0;
  Do_bound->m03 = 0.0;
  Do_bound->m10 = Do_10_error_bound;
  Do_bound->m11 = Do_11_error_bound;
  Do_bound->m12 = 0.0;
  Do_bound->m13 = 0.0;
  Do_bound->m20 = Do_20_error_bound;
  Do_bound->m21 = Do_21_error_bound;
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
  const double Do_03a_abs = fabs(Do_03a), D_03_abs = fabs(D->m03),
      Do_03_size = Do_03a_abs + D_03_abs;
  const double Do_13a_abs = fabs(Do_13a), D_13_abs = fabs(D->m13),
      Do_13_size = Do_13a_abs + D_13_abs;
  const double Do_23a_abs = fabs(Do_23a), D_23_abs = fabs(D->m23),
      Do_23_size = Do_23a_abs + D_23_abs;
  const double Do_03_padded = Do_03_size + 2.004168360008973e-292,
      Do_03_error_bound = KSL_MUL(2.2204460492503136e-16, Do_03_padded);
  const double Do_13_padded = Do_13_size + 2.004168360008973e-292,
      Do_13_error_bound = KSL_MUL(2.2204460492503136e-16, Do_13_padded);
  const double Do_23_padded = Do_23_size + 2.004168360008973e-292,
      Do_23_error_bound = KSL_MUL(2.2204460492503136e-16, Do_23_padded);
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
  Do_bound->m03 = Do_03_error_bound;
  Do_bound->m10 = 0.0;
  Do_bound->m11 = 0.0;
  Do_bound->m12 = 0.0;
  Do_bound->m13 = Do_13_error_bound;
  Do_bound->m20 = 0.0;
  Do_bound->m21 = 0.0;
  Do_bound->m22 = 0.0;
  Do_bound->m23 = Do_23_error_bound;
}

/* vo = R (-k e_z); |error of vo| <= vo_bound unless inf or NaN.
   R: rotation or other 3×3 matrix; k: number; vo, vo_bound: vector.
   6 mul, 3 add, 3 neg, 3 abs. */
static inline void ksl_product_drvtzinv_certified(const ksl_mat3x3_t *R, const double k,
    ksl_vec3_t *vo, ksl_vec3_t *vo_bound) {
  const double vo_0a = KSL_MUL(R->m02, k), vo_0 = -vo_0a;
  const double vo_1a = KSL_MUL(R->m12, k), vo_1 = -vo_1a;
  const double vo_2a = KSL_MUL(R->m22, k), vo_2 = -vo_2a;
  const double vo_0a_abs = fabs(vo_0a), vo_0a_padded = vo_0a_abs + 2.004168360008973e-292,
      vo_0a_error_bound = KSL_MUL(1.1102230246251568e-16, vo_0a_padded);
  const double vo_1a_abs = fabs(vo_1a), vo_1a_padded = vo_1a_abs + 2.004168360008973e-292,
      vo_1a_error_bound = KSL_MUL(1.1102230246251568e-16, vo_1a_padded);
  const double vo_2a_abs = fabs(vo_2a), vo_2a_padded = vo_2a_abs + 2.004168360008973e-292,
      vo_2a_error_bound = KSL_MUL(1.1102230246251568e-16, vo_2a_padded);
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
  vo_bound->x = vo_0a_error_bound;
  vo_bound->y = vo_1a_error_bound;
  vo_bound->z = vo_2a_error_bound;
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
  const double Ro_00a_abs = fabs(Ro_00a), Ro_00b_abs = fabs(Ro_00b),
      Ro_00_size = Ro_00a_abs + Ro_00b_abs;
  const double Ro_01a_abs = fabs(Ro_01a), Ro_01b_abs = fabs(Ro_01b),
      Ro_01_size = Ro_01a_abs + Ro_01b_abs;
  const double Ro_10a_abs = fabs(Ro_10a), Ro_10b_abs = fabs(Ro_10b),
      Ro_10_size = Ro_10a_abs + Ro_10b_abs;
  const double Ro_11a_abs = fabs(Ro_11a), Ro_11b_abs = fabs(Ro_11b),
      Ro_11_size = Ro_11a_abs + Ro_11b_abs;
  const double Ro_20a_abs = fabs(Ro_20a), Ro_20b_abs = fabs(Ro_20b),
      Ro_20_size = Ro_20a_abs + Ro_20b_abs;
  const double Ro_21a_abs = fabs(Ro_21a), Ro_21b_abs = fabs(Ro_21b),
      Ro_21_size = Ro_21a_abs + Ro_21b_abs;
  const double Ro_00_padded = Ro_00_size + 2.004168360008973e-292,
      Ro_00_error_bound = KSL_MUL(2.2204460492503136e-16, Ro_00_padded);
  const double Ro_01_padded = Ro_01_size + 2.004168360008973e-292,
      Ro_01_error_bound = KSL_MUL(2.2204460492503136e-16, Ro_01_padded);
  const double Ro_10_padded = Ro_10_size + 2.004168360008973e-292,
      Ro_10_error_bound = KSL_MUL(2.2204460492503136e-16, Ro_10_padded);
  const double Ro_11_padded = Ro_11_size + 2.004168360008973e-292,
      Ro_11_error_bound = KSL_MUL(2.2204460492503136e-16, Ro_11_padded);
  const double Ro_20_padded = Ro_20_size + 2.004168360008973e-292,
      Ro_20_error_bound = KSL_MUL(2.2204460492503136e-16, Ro_20_padded);
  const double Ro_21_padded = Ro_21_size + 2.004168360008973e-292,
      Ro_21_error_bound = KSL_MUL(2.2204460492503136e-16, Ro_21_padded);
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
  Ro_bound->m00 = Ro_00_error_bound;
  Ro_bound->m01 = Ro_01_error_bound;
  Ro_bound->m02 = 0.0;
  Ro_bound->m10 = Ro_10_error_bound;
  Ro_bound->m11 = Ro_11_error_bound;
  Ro_bound->m12 = 0.0;
  Ro_bound->m20 = Ro_20_error_bound;
  Ro_bound->m21 = Ro_21_error_bound;
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
  const double Do_00a_abs = fabs(Do_00a), Do_00b_abs = fabs(Do_00b),
      Do_00_size = Do_00a_abs + Do_00b_abs;
  const double Do_01a_abs = fabs(Do_01a), Do_01b_abs = fabs(Do_01b),
      Do_01_size = Do_01a_abs + Do_01b_abs;
  const double Do_10a_abs = fabs(Do_10a), Do_10b_abs = fabs(Do_10b),
      Do_10_size = Do_10a_abs + Do_10b_abs;
  const double Do_11a_abs = fabs(Do_11a), Do_11b_abs = fabs(Do_11b),
      Do_11_size = Do_11a_abs + Do_11b_abs;
  const double Do_20a_abs = fabs(Do_20a), Do_20b_abs = fabs(Do_20b),
      Do_20_size = Do_20a_abs + Do_20b_abs;
  const double Do_21a_abs = fabs(Do_21a), Do_21b_abs = fabs(Do_21b),
      Do_21_size = Do_21a_abs + Do_21b_abs;
  const double Do_00_padded = Do_00_size + 2.004168360008973e-292,
      Do_00_error_bound = KSL_MUL(2.2204460492503136e-16, Do_00_padded);
  const double Do_01_padded = Do_01_size + 2.004168360008973e-292,
      Do_01_error_bound = KSL_MUL(2.2204460492503136e-16, Do_01_padded);
  const double Do_10_padded = Do_10_size + 2.004168360008973e-292,
      Do_10_error_bound = KSL_MUL(2.2204460492503136e-16, Do_10_padded);
  const double Do_11_padded = Do_11_size + 2.004168360008973e-292,
      Do_11_error_bound = KSL_MUL(2.2204460492503136e-16, Do_11_padded);
  const double Do_20_padded = Do_20_size + 2.004168360008973e-292,
      Do_20_error_bound = KSL_MUL(2.2204460492503136e-16, Do_20_padded);
  const double Do_21_padded = Do_21_size + 2.004168360008973e-292,
      Do_21_error_bound = KSL_MUL(2.2204460492503136e-16, Do_21_padded);
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
  Do_bound->m00 = Do_00_error_bound;
  Do_bound->m01 = Do_01_error_bound;
  Do_bound->m02 = 0.0;
  Do_bound->m03 = 0.0;
  Do_bound->m10 = Do_10_error_bound;
  Do_bound->m11 = Do_11_error_bound;
  Do_bound->m12 = 0.0;
  Do_bound->m13 = 0.0;
  Do_bound->m20 = Do_20_error_bound;
  Do_bound->m21 = Do_21_error_bound;
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
  const double D_03_abs = fabs(D->m03), Do_03a_abs = fabs(Do_03a),
      Do_03_size = D_03_abs + Do_03a_abs;
  const double D_13_abs = fabs(D->m13), Do_13a_abs = fabs(Do_13a),
      Do_13_size = D_13_abs + Do_13a_abs;
  const double D_23_abs = fabs(D->m23), Do_23a_abs = fabs(Do_23a),
      Do_23_size = D_23_abs + Do_23a_abs;
  const double Do_03_padded = Do_03_size + 2.004168360008973e-292,
      Do_03_error_bound = KSL_MUL(2.2204460492503136e-16, Do_03_padded);
  const double Do_13_padded = Do_13_size + 2.004168360008973e-292,
      Do_13_error_bound = KSL_MUL(2.2204460492503136e-16, Do_13_padded);
  const double Do_23_padded = Do_23_size + 2.004168360008973e-292,
      Do_23_error_bound = KSL_MUL(2.2204460492503136e-16, Do_23_padded);
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
  Do_bound->m03 = Do_03_error_bound;
  Do_bound->m10 = 0.0;
  Do_bound->m11 = 0.0;
  Do_bound->m12 = 0.0;
  Do_bound->m13 = Do_13_error_bound;
  Do_bound->m20 = 0.0;
  Do_bound->m21 = 0.0;
  Do_bound->m22 = 0.0;
  Do_bound->m23 = Do_23_error_bound;
}

/* vo = R v; |error of vo| <= vo_bound unless inf or NaN.
   R: rotation or other 3×3 matrix; v, vo, vo_bound: vector.
   12 mul, 15 add, 9 abs. */
static inline void ksl_product_drvf_certified(const ksl_mat3x3f_t *R, const ksl_vec3f_t *v,
    ksl_vec3f_t *vo, ksl_vec3f_t *vo_bound) {
  const float vo_0a = KSL_MULF(R->m00, v->x), vo_0b = KSL_MULF(R->m01, v->y), vo_0c = vo_0a + vo_0b,
      vo_0d = KSL_MULF(R->m02, v->z), vo_0 = vo_0c + vo_0d;
  const float vo_1a = KSL_MULF(R->m10, v->x), vo_1b = KSL_MULF(R->m11, v->y), vo_1c = vo_1a + vo_1b,
      vo_1d = KSL_MULF(R->m12, v->z), vo_1 = vo_1c + vo_1d;
  const float vo_2a = KSL_MULF(R->m20, v->x), vo_2b = KSL_MULF(R->m21, v->y), vo_2c = vo_2a + vo_2b,
      vo_2d = KSL_MULF(R->m22, v->z), vo_2 = vo_2c + vo_2d;
  const float vo_0a_abs = fabsf(vo_0a), vo_0b_abs = fabsf(vo_0b),
      vo_0c_size = vo_0a_abs + vo_0b_abs, vo_0d_abs = fabsf(vo_0d),
      vo_0_size = vo_0c_size + vo_0d_abs;
  const float vo_1a_abs = fabsf(vo_1a), vo_1b_abs = fabsf(vo_1b),
      vo_1c_size = vo_1a_abs + vo_1b_abs, vo_1d_abs = fabsf(vo_1d),
      vo_1_size = vo_1c_size + vo_1d_abs;
  const float vo_2a_abs = fabsf(vo_2a), vo_2b_abs = fabsf(vo_2b),
      vo_2c_size = vo_2a_abs + vo_2b_abs, vo_2d_abs = fabsf(vo_2d),
      vo_2_size = vo_2c_size + vo_2d_abs;
  const float vo_0_padded = vo_0_size + 1.9721523e-31f,
      vo_0_error_bound = KSL_MULF(1.7881396e-07f, vo_0_padded);
  const float vo_1_padded = vo_1_size + 1.9721523e-31f,
      vo_1_error_bound = KSL_MULF(1.7881396e-07f, vo_1_padded);
  const float vo_2_padded = vo_2_size + 1.9721523e-31f,
      vo_2_error_bound = KSL_MULF(1.7881396e-07f, vo_2_padded);
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
  vo_bound->x = vo_0_error_bound;
  vo_bound->y = vo_1_error_bound;
  vo_bound->z = vo_2_error_bound;
}

/* vo = R (-v); |error of vo| <= vo_bound unless inf or NaN.
   R: rotation or other 3×3 matrix; v, vo, vo_bound: vector.
   12 mul, 15 add, 3 neg, 9 abs. */
static inline void ksl_product_drvinvf_certified(const ksl_mat3x3f_t *R, const ksl_vec3f_t *v,
    ksl_vec3f_t *vo, ksl_vec3f_t *vo_bound) {
  const float vo_0a = KSL_MULF(R->m00, v->x), vo_0b = KSL_MULF(R->m01, v->y), vo_0c = vo_0a + vo_0b,
      vo_0d = KSL_MULF(R->m02, v->z), vo_0e = vo_0c + vo_0d, vo_0 = -vo_0e;
  const float vo_1a = KSL_MULF(R->m10, v->x), vo_1b = KSL_MULF(R->m11, v->y), vo_1c = vo_1a + vo_1b,
      vo_1d = KSL_MULF(R->m12, v->z), vo_1e = vo_1c + vo_1d, vo_1 = -vo_1e;
  const float vo_2a = KSL_MULF(R->m20, v->x), vo_2b = KSL_MULF(R->m21, v->y), vo_2c = vo_2a + vo_2b,
      vo_2d = KSL_MULF(R->m22, v->z), vo_2e = vo_2c + vo_2d, vo_2 = -vo_2e;
  const float vo_0a_abs = fabsf(vo_0a), vo_0b_abs = fabsf(vo_0b),
      vo_0c_size = vo_0a_abs + vo_0b_abs, vo_0d_abs = fabsf(vo_0d),
      vo_0e_size = vo_0c_size + vo_0d_abs;
  const float vo_1a_abs = fabsf(vo_1a), vo_1b_abs = fabsf(vo_1b),
      vo_1c_size = vo_1a_abs + vo_1b_abs, vo_1d_abs = fabsf(vo_1d),
      vo_1e_size = vo_1c_size + vo_1d_abs;
  const float vo_2a_abs = fabsf(vo_2a), vo_2b_abs = fabsf(vo_2b),
      vo_2c_size = vo_2a_abs + vo_2b_abs, vo_2d_abs = fabsf(vo_2d),
      vo_2e_size = vo_2c_size + vo_2d_abs;
  const float vo_0e_padded = vo_0e_size + 1.9721523e-31f,
      vo_0e_error_bound = KSL_MULF(1.7881396e-07f, vo_0e_padded);
  const float vo_1e_padded = vo_1e_size + 1.9721523e-31f,
      vo_1e_error_bound = KSL_MULF(1.7881396e-07f, vo_1e_padded);
  const float vo_2e_padded = vo_2e_size + 1.9721523e-31f,
      vo_2e_error_bound = KSL_MULF(1.7881396e-07f, vo_2e_padded);
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
  vo_bound->x = vo_0e_error_bound;
  vo_bound->y = vo_1e_error_bound;
  vo_bound->z = vo_2e_error_bound;
}

/* vo = R^T v; |error of vo| <= vo_bound unless inf or NaN.
   R: rotation or other 3×3 matrix; v, vo, vo_bound: vector.
   12 mul, 15 add, 9 abs. */
static inline void ksl_product_drinvvf_certified(const ksl_mat3x3f_t *R, const ksl_vec3f_t *v,
    ksl_vec3f_t *vo, ksl_vec3f_t *vo_bound) {
  const float vo_0a = KSL_MULF(R->m00, v->x), vo_0b = KSL_MULF(R->m10, v->y), vo_0c = vo_0a + vo_0b,
      vo_0d = KSL_MULF(R->m20, v->z), vo_0 = vo_0c + vo_0d;
  const float vo_1a = KSL_MULF(R->m01, v->x), vo_1b = KSL_MULF(R->m11, v->y), vo_1c = vo_1a + vo_1b,
      vo_1d = KSL_MULF(R->m21, v->z), vo_1 = vo_1c + vo_1d;
  const float vo_2a = KSL_MULF(R->m02, v->x), vo_2b = KSL_MULF(R->m12, v->y), vo_2c = vo_2a + vo_2b,
      vo_2d = KSL_MULF(R->m22, v->z), vo_2 = vo_2c + vo_2d;
  const float vo_0a_abs = fabsf(vo_0a), vo_0b_abs = fabsf(vo_0b),
      vo_0c_size = vo_0a_abs + vo_0b_abs, vo_0d_abs = fabsf(vo_0d),
      vo_0_size = vo_0c_size + vo_0d_abs;
  const float vo_1a_abs = fabsf(vo_1a), vo_1b_abs = fabsf(vo_1b),
      vo_1c_size = vo_1a_abs + vo_1b_abs, vo_1d_abs = fabsf(vo_1d),
      vo_1_size = vo_1c_size + vo_1d_abs;
  const float vo_2a_abs = fabsf(vo_2a), vo_2b_abs = fabsf(vo_2b),
      vo_2c_size = vo_2a_abs + vo_2b_abs, vo_2d_abs = fabsf(vo_2d),
      vo_2_size = vo_2c_size + vo_2d_abs;
  const float vo_0_padded = vo_0_size + 1.9721523e-31f,
      vo_0_error_bound = KSL_MULF(1.7881396e-07f, vo_0_padded);
  const float vo_1_padded = vo_1_size + 1.9721523e-31f,
      vo_1_error_bound = KSL_MULF(1.7881396e-07f, vo_1_padded);
  const float vo_2_padded = vo_2_size + 1.9721523e-31f,
      vo_2_error_bound = KSL_MULF(1.7881396e-07f, vo_2_padded);
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
  vo_bound->x = vo_0_error_bound;
  vo_bound->y = vo_1_error_bound;
  vo_bound->z = vo_2_error_bound;
}

/* vo = R^T (-v); |error of vo| <= vo_bound unless inf or NaN.
   R: rotation or other 3×3 matrix; v, vo, vo_bound: vector.
   12 mul, 15 add, 3 neg, 9 abs. */
static inline void ksl_product_drinvvinvf_certified(const ksl_mat3x3f_t *R, const ksl_vec3f_t *v,
    ksl_vec3f_t *vo, ksl_vec3f_t *vo_bound) {
  const float vo_0a = KSL_MULF(R->m00, v->x), vo_0b = KSL_MULF(R->m10, v->y), vo_0c = vo_0a + vo_0b,
      vo_0d = KSL_MULF(R->m20, v->z), vo_0e = vo_0c + vo_0d, vo_0 = -vo_0e;
  const float vo_1a = KSL_MULF(R->m01, v->x), vo_1b = KSL_MULF(R->m11, v->y), vo_1c = vo_1a + vo_1b,
      vo_1d = KSL_MULF(R->m21, v->z), vo_1e = vo_1c + vo_1d, vo_1 = -vo_1e;
  const float vo_2a = KSL_MULF(R->m02, v->x), vo_2b = KSL_MULF(R->m12, v->y), vo_2c = vo_2a + vo_2b,
      vo_2d = KSL_MULF(R->m22, v->z), vo_2e = vo_2c + vo_2d, vo_2 = -vo_2e;
  const float vo_0a_abs = fabsf(vo_0a), vo_0b_abs = fabsf(vo_0b),
      vo_0c_size = vo_0a_abs + vo_0b_abs, vo_0d_abs = fabsf(vo_0d),
      vo_0e_size = vo_0c_size + vo_0d_abs;
  const float vo_1a_abs = fabsf(vo_1a), vo_1b_abs = fabsf(vo_1b),
      vo_1c_size = vo_1a_abs + vo_1b_abs, vo_1d_abs = fabsf(vo_1d),
      vo_1e_size = vo_1c_size + vo_1d_abs;
  const float vo_2a_abs = fabsf(vo_2a), vo_2b_abs = fabsf(vo_2b),
      vo_2c_size = vo_2a_abs + vo_2b_abs, vo_2d_abs = fabsf(vo_2d),
      vo_2e_size = vo_2c_size + vo_2d_abs;
  const float vo_0e_padded = vo_0e_size + 1.9721523e-31f,
      vo_0e_error_bound = KSL_MULF(1.7881396e-07f, vo_0e_padded);
  const float vo_1e_padded = vo_1e_size + 1.9721523e-31f,
      vo_1e_error_bound = KSL_MULF(1.7881396e-07f, vo_1e_padded);
  const float vo_2e_padded = vo_2e_size + 1.9721523e-31f,
      vo_2e_error_bound = KSL_MULF(1.7881396e-07f, vo_2e_padded);
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
  vo_bound->x = vo_0e_error_bound;
  vo_bound->y = vo_1e_error_bound;
  vo_bound->z = vo_2e_error_bound;
}

/* vo = R v + t; |error of vo| <= vo_bound unless inf or NaN.
   D: displacement [R | t], R rotation, t in m; v, vo, vo_bound: vector.
   12 mul, 21 add, 12 abs. */
static inline void ksl_product_dvf_certified(const ksl_SE3f_t *D, const ksl_vec3f_t *v,
    ksl_vec3f_t *vo, ksl_vec3f_t *vo_bound) {
  const float vo_0a = KSL_MULF(D->m00, v->x), vo_0b = KSL_MULF(D->m01, v->y), vo_0c = vo_0a + vo_0b,
      vo_0d = KSL_MULF(D->m02, v->z), vo_0e = vo_0c + vo_0d, vo_0 = vo_0e + D->m03;
  const float vo_1a = KSL_MULF(D->m10, v->x), vo_1b = KSL_MULF(D->m11, v->y), vo_1c = vo_1a + vo_1b,
      vo_1d = KSL_MULF(D->m12, v->z), vo_1e = vo_1c + vo_1d, vo_1 = vo_1e + D->m13;
  const float vo_2a = KSL_MULF(D->m20, v->x), vo_2b = KSL_MULF(D->m21, v->y), vo_2c = vo_2a + vo_2b,
      vo_2d = KSL_MULF(D->m22, v->z), vo_2e = vo_2c + vo_2d, vo_2 = vo_2e + D->m23;
  const float vo_0a_abs = fabsf(vo_0a), vo_0b_abs = fabsf(vo_0b),
      vo_0c_size = vo_0a_abs + vo_0b_abs, vo_0d_abs = fabsf(vo_0d),
      vo_0e_size = vo_0c_size + vo_0d_abs, D_03_abs = fabsf(D->m03),
      vo_0_size = vo_0e_size + D_03_abs;
  const float vo_1a_abs = fabsf(vo_1a), vo_1b_abs = fabsf(vo_1b),
      vo_1c_size = vo_1a_abs + vo_1b_abs, vo_1d_abs = fabsf(vo_1d),
      vo_1e_size = vo_1c_size + vo_1d_abs, D_13_abs = fabsf(D->m13),
      vo_1_size = vo_1e_size + D_13_abs;
  const float vo_2a_abs = fabsf(vo_2a), vo_2b_abs = fabsf(vo_2b),
      vo_2c_size = vo_2a_abs + vo_2b_abs, vo_2d_abs = fabsf(vo_2d),
      vo_2e_size = vo_2c_size + vo_2d_abs, D_23_abs = fabsf(D->m23),
      vo_2_size = vo_2e_size + D_23_abs;
  const float vo_0_padded = vo_0_size + 1.9721523e-31f,
      vo_0_error_bound = KSL_MULF(2.3841864e-07f, vo_0_padded);
  const float vo_1_padded = vo_1_size + 1.9721523e-31f,
      vo_1_error_bound = KSL_MULF(2.3841864e-07f, vo_1_padded);
  const float vo_2_padded = vo_2_size + 1.9721523e-31f,
      vo_2_error_bound = KSL_MULF(2.3841864e-07f, vo_2_padded);
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
  vo_bound->x = vo_0_error_bound;
  vo_bound->y = vo_1_error_bound;
  vo_bound->z = vo_2_error_bound;
}

/* vo = R^T (v - t); |error of vo| <= vo_bound unless inf or NaN.
   D: displacement [R | t], R rotation, t in m; v, vo, vo_bound: vector.
   21 mul, 18 add, 12 abs. */
static inline void ksl_product_dinvvf_certified(const ksl_SE3f_t *D, const ksl_vec3f_t *v,
    ksl_vec3f_t *vo, ksl_vec3f_t *vo_bound) {
  const float p_0 = v->x - D->m03;
  const float p_1 = v->y - D->m13;
  const float p_2 = v->z - D->m23;
  const float vo_0a = KSL_MULF(D->m00, p_0), vo_0b = KSL_MULF(D->m10, p_1), vo_0c = vo_0a + vo_0b,
      vo_0d = KSL_MULF(D->m20, p_2), vo_0 = vo_0c + vo_0d;
  const float vo_1a = KSL_MULF(D->m01, p_0), vo_1b = KSL_MULF(D->m11, p_1), vo_1c = vo_1a + vo_1b,
      vo_1d = KSL_MULF(D->m21, p_2), vo_1 = vo_1c + vo_1d;
  const float vo_2a = KSL_MULF(D->m02, p_0), vo_2b = KSL_MULF(D->m12, p_1), vo_2c = vo_2a + vo_2b,
      vo_2d = KSL_MULF(D->m22, p_2), vo_2 = vo_2c + vo_2d;
  const float D_00_abs = fabsf(D->m00), p_0_abs = fabsf(p_0),
      vo_0a_size = KSL_MULF(D_00_abs, p_0_abs), D_10_abs = fabsf(D->m10), p_1_abs = fabsf(p_1),
      vo_0b_size = KSL_MULF(D_10_abs, p_1_abs), vo_0c_size = vo_0a_size + vo_0b_size,
      D_20_abs = fabsf(D->m20), p_2_abs = fabsf(p_2), vo_0d_size = KSL_MULF(D_20_abs, p_2_abs),
      vo_0_size = vo_0c_size + vo_0d_size;
  const float D_01_abs = fabsf(D->m01), vo_1a_size = KSL_MULF(D_01_abs, p_0_abs),
      D_11_abs = fabsf(D->m11), vo_1b_size = KSL_MULF(D_11_abs, p_1_abs),
      vo_1c_size = vo_1a_size + vo_1b_size, D_21_abs = fabsf(D->m21),
      vo_1d_size = KSL_MULF(D_21_abs, p_2_abs), vo_1_size = vo_1c_size + vo_1d_size;
  const float D_02_abs = fabsf(D->m02), vo_2a_size = KSL_MULF(D_02_abs, p_0_abs),
      D_12_abs = fabsf(D->m12), vo_2b_size = KSL_MULF(D_12_abs, p_1_abs),
      vo_2c_size = vo_2a_size + vo_2b_size, D_22_abs = fabsf(D->m22),
      vo_2d_size = KSL_MULF(D_22_abs, p_2_abs), vo_2_size = vo_2c_size + vo_2d_size;
  const float vo_0_padded = vo_0_size + 1.9721523e-31f,
      vo_0_error_bound = KSL_MULF(2.3841864e-07f, vo_0_padded);
  const float vo_1_padded = vo_1_size + 1.9721523e-31f,
      vo_1_error_bound = KSL_MULF(2.3841864e-07f, vo_1_padded);
  const float vo_2_padded = vo_2_size + 1.9721523e-31f,
      vo_2_error_bound = KSL_MULF(2.3841864e-07f, vo_2_padded);
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
  vo_bound->x = vo_0_error_bound;
  vo_bound->y = vo_1_error_bound;
  vo_bound->z = vo_2_error_bound;
}

/* Ro = R1 R2; |error of Ro| <= Ro_bound unless inf or NaN.
   R1, R2, Ro, Ro_bound: rotation or other 3×3 matrix.
   36 mul, 45 add, 27 abs. */
static inline void ksl_product_drdrf_certified(const ksl_mat3x3f_t *R1, const ksl_mat3x3f_t *R2,
    ksl_mat3x3f_t *Ro, ksl_mat3x3f_t *Ro_bound) {
  const float Ro_00a = KSL_MULF(R1->m00, R2->m00), Ro_00b = KSL_MULF(R1->m01, R2->m10),
      Ro_00c = Ro_00a + Ro_00b, Ro_00d = KSL_MULF(R1->m02, R2->m20), Ro_00 = Ro_00c + Ro_00d;
  const float Ro_01a = KSL_MULF(R1->m00, R2->m01), Ro_01b = KSL_MULF(R1->m01, R2->m11),
      Ro_01c = Ro_01a + Ro_01b, Ro_01d = KSL_MULF(R1->m02, R2->m21), Ro_01 = Ro_01c + Ro_01d;
  const float Ro_02a = KSL_MULF(R1->m00, R2->m02), Ro_02b = KSL_MULF(R1->m01, R2->m12),
      Ro_02c = Ro_02a + Ro_02b, Ro_02d = KSL_MULF(R1->m02, R2->m22), Ro_02 = Ro_02c + Ro_02d;
  const float Ro_10a = KSL_MULF(R1->m10, R2->m00), Ro_10b = KSL_MULF(R1->m11, R2->m10),
      Ro_10c = Ro_10a + Ro_10b, Ro_10d = KSL_MULF(R1->m12, R2->m20), Ro_10 = Ro_10c + Ro_10d;
  const float Ro_11a = KSL_MULF(R1->m10, R2->m01), Ro_11b = KSL_MULF(R1->m11, R2->m11),
      Ro_11c = Ro_11a + Ro_11b, Ro_11d = KSL_MULF(R1->m12, R2->m21), Ro_11 = Ro_11c + Ro_11d;
  const float Ro_12a = KSL_MULF(R1->m10, R2->m02), Ro_12b = KSL_MULF(R1->m11, R2->m12),
      Ro_12c = Ro_12a + Ro_12b, Ro_12d = KSL_MULF(R1->m12, R2->m22), Ro_12 = Ro_12c + Ro_12d;
  const float Ro_20a = KSL_MULF(R1->m20, R2->m00), Ro_20b = KSL_MULF(R1->m21, R2->m10),
      Ro_20c = Ro_20a + Ro_20b, Ro_20d = KSL_MULF(R1->m22, R2->m20), Ro_20 = Ro_20c + Ro_20d;
  const float Ro_21a = KSL_MULF(R1->m20, R2->m01), Ro_21b = KSL_MULF(R1->m21, R2->m11),
      Ro_21c = Ro_21a + Ro_21b, Ro_21d = KSL_MULF(R1->m22, R2->m21), Ro_21 = Ro_21c + Ro_21d;
  const float Ro_22a = KSL_MULF(R1->m20, R2->m02), Ro_22b = KSL_MULF(R1->m21, R2->m12),
      Ro_22c = Ro_22a + Ro_22b, Ro_22d = KSL_MULF(R1->m22, R2->m22), Ro_22 = Ro_22c + Ro_22d;
  const float Ro_00a_abs = fabsf(Ro_00a), Ro_00b_abs = fabsf(Ro_00b),
      Ro_00c_size = Ro_00a_abs + Ro_00b_abs, Ro_00d_abs = fabsf(Ro_00d),
      Ro_00_size = Ro_00c_size + Ro_00d_abs;
  const float Ro_01a_abs = fabsf(Ro_01a), Ro_01b_abs = fabsf(Ro_01b),
      Ro_01c_size = Ro_01a_abs + Ro_01b_abs, Ro_01d_abs = fabsf(Ro_01d),
      Ro_01_size = Ro_01c_size + Ro_01d_abs;
  const float Ro_02a_abs = fabsf(Ro_02a), Ro_02b_abs = fabsf(Ro_02b),
      Ro_02c_size = Ro_02a_abs + Ro_02b_abs, Ro_02d_abs = fabsf(Ro_02d),
      Ro_02_size = Ro_02c_size + Ro_02d_abs;
  const float Ro_10a_abs = fabsf(Ro_10a), Ro_10b_abs = fabsf(Ro_10b),
      Ro_10c_size = Ro_10a_abs + Ro_10b_abs, Ro_10d_abs = fabsf(Ro_10d),
      Ro_10_size = Ro_10c_size + Ro_10d_abs;
  const float Ro_11a_abs = fabsf(Ro_11a), Ro_11b_abs = fabsf(Ro_11b),
      Ro_11c_size = Ro_11a_abs + Ro_11b_abs, Ro_11d_abs = fabsf(Ro_11d),
      Ro_11_size = Ro_11c_size + Ro_11d_abs;
  const float Ro_12a_abs = fabsf(Ro_12a), Ro_12b_abs = fabsf(Ro_12b),
      Ro_12c_size = Ro_12a_abs + Ro_12b_abs, Ro_12d_abs = fabsf(Ro_12d),
      Ro_12_size = Ro_12c_size + Ro_12d_abs;
  const float Ro_20a_abs = fabsf(Ro_20a), Ro_20b_abs = fabsf(Ro_20b),
      Ro_20c_size = Ro_20a_abs + Ro_20b_abs, Ro_20d_abs = fabsf(Ro_20d),
      Ro_20_size = Ro_20c_size + Ro_20d_abs;
  const float Ro_21a_abs = fabsf(Ro_21a), Ro_21b_abs = fabsf(Ro_21b),
      Ro_21c_size = Ro_21a_abs + Ro_21b_abs, Ro_21d_abs = fabsf(Ro_21d),
      Ro_21_size = Ro_21c_size + Ro_21d_abs;
  const float Ro_22a_abs = fabsf(Ro_22a), Ro_22b_abs = fabsf(Ro_22b),
      Ro_22c_size = Ro_22a_abs + Ro_22b_abs, Ro_22d_abs = fabsf(Ro_22d),
      Ro_22_size = Ro_22c_size + Ro_22d_abs;
  const float Ro_00_padded = Ro_00_size + 1.9721523e-31f,
      Ro_00_error_bound = KSL_MULF(1.7881396e-07f, Ro_00_padded);
  const float Ro_01_padded = Ro_01_size + 1.9721523e-31f,
      Ro_01_error_bound = KSL_MULF(1.7881396e-07f, Ro_01_padded);
  const float Ro_02_padded = Ro_02_size + 1.9721523e-31f,
      Ro_02_error_bound = KSL_MULF(1.7881396e-07f, Ro_02_padded);
  const float Ro_10_padded = Ro_10_size + 1.9721523e-31f,
      Ro_10_error_bound = KSL_MULF(1.7881396e-07f, Ro_10_padded);
  const float Ro_11_padded = Ro_11_size + 1.9721523e-31f,
      Ro_11_error_bound = KSL_MULF(1.7881396e-07f, Ro_11_padded);
  const float Ro_12_padded = Ro_12_size + 1.9721523e-31f,
      Ro_12_error_bound = KSL_MULF(1.7881396e-07f, Ro_12_padded);
  const float Ro_20_padded = Ro_20_size + 1.9721523e-31f,
      Ro_20_error_bound = KSL_MULF(1.7881396e-07f, Ro_20_padded);
  const float Ro_21_padded = Ro_21_size + 1.9721523e-31f,
      Ro_21_error_bound = KSL_MULF(1.7881396e-07f, Ro_21_padded);
  const float Ro_22_padded = Ro_22_size + 1.9721523e-31f,
      Ro_22_error_bound = KSL_MULF(1.7881396e-07f, Ro_22_padded);
  Ro->m00 = Ro_00;
  Ro->m01 = Ro_01;
  Ro->m02 = Ro_02;
  Ro->m10 = Ro_10;
  Ro->m11 = Ro_11;
  Ro->m12 = Ro_12;
  Ro->m20 = Ro_20;
  Ro->m21 = Ro_21;
  Ro->m22 = Ro_22;
  Ro_bound->m00 = Ro_00_error_bound;
  Ro_bound->m01 = Ro_01_error_bound;
  Ro_bound->m02 = Ro_02_error_bound;
  Ro_bound->m10 = Ro_10_error_bound;
  Ro_bound->m11 = Ro_11_error_bound;
  Ro_bound->m12 = Ro_12_error_bound;
  Ro_bound->m20 = Ro_20_error_bound;
  Ro_bound->m21 = Ro_21_error_bound;
  Ro_bound->m22 = Ro_22_error_bound;
}

/* Ro = R1 R2^T; |error of Ro| <= Ro_bound unless inf or NaN.
   R1, R2, Ro, Ro_bound: rotation or other 3×3 matrix.
   36 mul, 45 add, 27 abs. */
static inline void ksl_product_drdrinvf_certified(const ksl_mat3x3f_t *R1,
    const ksl_mat3x3f_t *R2, ksl_mat3x3f_t *Ro, ksl_mat3x3f_t *Ro_bound) {
  const float Ro_00a = KSL_MULF(R1->m00, R2->m00), Ro_00b = KSL_MULF(R1->m01, R2->m01),
      Ro_00c = Ro_00a + Ro_00b, Ro_00d = KSL_MULF(R1->m02, R2->m02), Ro_00 = Ro_00c + Ro_00d;
  const float Ro_01a = KSL_MULF(R1->m00, R2->m10), Ro_01b = KSL_MULF(R1->m01, R2->m11),
      Ro_01c = Ro_01a + Ro_01b, Ro_01d = KSL_MULF(R1->m02, R2->m12), Ro_01 = Ro_01c + Ro_01d;
  const float Ro_02a = KSL_MULF(R1->m00, R2->m20), Ro_02b = KSL_MULF(R1->m01, R2->m21),
      Ro_02c = Ro_02a + Ro_02b, Ro_02d = KSL_MULF(R1->m02, R2->m22), Ro_02 = Ro_02c + Ro_02d;
  const float Ro_10a = KSL_MULF(R1->m10, R2->m00), Ro_10b = KSL_MULF(R1->m11, R2->m01),
      Ro_10c = Ro_10a + Ro_10b, Ro_10d = KSL_MULF(R1->m12, R2->m02), Ro_10 = Ro_10c + Ro_10d;
  const float Ro_11a = KSL_MULF(R1->m10, R2->m10), Ro_11b = KSL_MULF(R1->m11, R2->m11),
      Ro_11c = Ro_11a + Ro_11b, Ro_11d = KSL_MULF(R1->m12, R2->m12), Ro_11 = Ro_11c + Ro_11d;
  const float Ro_12a = KSL_MULF(R1->m10, R2->m20), Ro_12b = KSL_MULF(R1->m11, R2->m21),
      Ro_12c = Ro_12a + Ro_12b, Ro_12d = KSL_MULF(R1->m12, R2->m22), Ro_12 = Ro_12c + Ro_12d;
  const float Ro_20a = KSL_MULF(R1->m20, R2->m00), Ro_20b = KSL_MULF(R1->m21, R2->m01),
      Ro_20c = Ro_20a + Ro_20b, Ro_20d = KSL_MULF(R1->m22, R2->m02), Ro_20 = Ro_20c + Ro_20d;
  const float Ro_21a = KSL_MULF(R1->m20, R2->m10), Ro_21b = KSL_MULF(R1->m21, R2->m11),
      Ro_21c = Ro_21a + Ro_21b, Ro_21d = KSL_MULF(R1->m22, R2->m12), Ro_21 = Ro_21c + Ro_21d;
  const float Ro_22a = KSL_MULF(R1->m20, R2->m20), Ro_22b = KSL_MULF(R1->m21, R2->m21),
      Ro_22c = Ro_22a + Ro_22b, Ro_22d = KSL_MULF(R1->m22, R2->m22), Ro_22 = Ro_22c + Ro_22d;
  const float Ro_00a_abs = fabsf(Ro_00a), Ro_00b_abs = fabsf(Ro_00b),
      Ro_00c_size = Ro_00a_abs + Ro_00b_abs, Ro_00d_abs = fabsf(Ro_00d),
      Ro_00_size = Ro_00c_size + Ro_00d_abs;
  const float Ro_01a_abs = fabsf(Ro_01a), Ro_01b_abs = fabsf(Ro_01b),
      Ro_01c_size = Ro_01a_abs + Ro_01b_abs, Ro_01d_abs = fabsf(Ro_01d),
      Ro_01_size = Ro_01c_size + Ro_01d_abs;
  const float Ro_02a_abs = fabsf(Ro_02a), Ro_02b_abs = fabsf(Ro_02b),
      Ro_02c_size = Ro_02a_abs + Ro_02b_abs, Ro_02d_abs = fabsf(Ro_02d),
      Ro_02_size = Ro_02c_size + Ro_02d_abs;
  const float Ro_10a_abs = fabsf(Ro_10a), Ro_10b_abs = fabsf(Ro_10b),
      Ro_10c_size = Ro_10a_abs + Ro_10b_abs, Ro_10d_abs = fabsf(Ro_10d),
      Ro_10_size = Ro_10c_size + Ro_10d_abs;
  const float Ro_11a_abs = fabsf(Ro_11a), Ro_11b_abs = fabsf(Ro_11b),
      Ro_11c_size = Ro_11a_abs + Ro_11b_abs, Ro_11d_abs = fabsf(Ro_11d),
      Ro_11_size = Ro_11c_size + Ro_11d_abs;
  const float Ro_12a_abs = fabsf(Ro_12a), Ro_12b_abs = fabsf(Ro_12b),
      Ro_12c_size = Ro_12a_abs + Ro_12b_abs, Ro_12d_abs = fabsf(Ro_12d),
      Ro_12_size = Ro_12c_size + Ro_12d_abs;
  const float Ro_20a_abs = fabsf(Ro_20a), Ro_20b_abs = fabsf(Ro_20b),
      Ro_20c_size = Ro_20a_abs + Ro_20b_abs, Ro_20d_abs = fabsf(Ro_20d),
      Ro_20_size = Ro_20c_size + Ro_20d_abs;
  const float Ro_21a_abs = fabsf(Ro_21a), Ro_21b_abs = fabsf(Ro_21b),
      Ro_21c_size = Ro_21a_abs + Ro_21b_abs, Ro_21d_abs = fabsf(Ro_21d),
      Ro_21_size = Ro_21c_size + Ro_21d_abs;
  const float Ro_22a_abs = fabsf(Ro_22a), Ro_22b_abs = fabsf(Ro_22b),
      Ro_22c_size = Ro_22a_abs + Ro_22b_abs, Ro_22d_abs = fabsf(Ro_22d),
      Ro_22_size = Ro_22c_size + Ro_22d_abs;
  const float Ro_00_padded = Ro_00_size + 1.9721523e-31f,
      Ro_00_error_bound = KSL_MULF(1.7881396e-07f, Ro_00_padded);
  const float Ro_01_padded = Ro_01_size + 1.9721523e-31f,
      Ro_01_error_bound = KSL_MULF(1.7881396e-07f, Ro_01_padded);
  const float Ro_02_padded = Ro_02_size + 1.9721523e-31f,
      Ro_02_error_bound = KSL_MULF(1.7881396e-07f, Ro_02_padded);
  const float Ro_10_padded = Ro_10_size + 1.9721523e-31f,
      Ro_10_error_bound = KSL_MULF(1.7881396e-07f, Ro_10_padded);
  const float Ro_11_padded = Ro_11_size + 1.9721523e-31f,
      Ro_11_error_bound = KSL_MULF(1.7881396e-07f, Ro_11_padded);
  const float Ro_12_padded = Ro_12_size + 1.9721523e-31f,
      Ro_12_error_bound = KSL_MULF(1.7881396e-07f, Ro_12_padded);
  const float Ro_20_padded = Ro_20_size + 1.9721523e-31f,
      Ro_20_error_bound = KSL_MULF(1.7881396e-07f, Ro_20_padded);
  const float Ro_21_padded = Ro_21_size + 1.9721523e-31f,
      Ro_21_error_bound = KSL_MULF(1.7881396e-07f, Ro_21_padded);
  const float Ro_22_padded = Ro_22_size + 1.9721523e-31f,
      Ro_22_error_bound = KSL_MULF(1.7881396e-07f, Ro_22_padded);
  Ro->m00 = Ro_00;
  Ro->m01 = Ro_01;
  Ro->m02 = Ro_02;
  Ro->m10 = Ro_10;
  Ro->m11 = Ro_11;
  Ro->m12 = Ro_12;
  Ro->m20 = Ro_20;
  Ro->m21 = Ro_21;
  Ro->m22 = Ro_22;
  Ro_bound->m00 = Ro_00_error_bound;
  Ro_bound->m01 = Ro_01_error_bound;
  Ro_bound->m02 = Ro_02_error_bound;
  Ro_bound->m10 = Ro_10_error_bound;
  Ro_bound->m11 = Ro_11_error_bound;
  Ro_bound->m12 = Ro_12_error_bound;
  Ro_bound->m20 = Ro_20_error_bound;
  Ro_bound->m21 = Ro_21_error_bound;
  Ro_bound->m22 = Ro_22_error_bound;
}

/* Ro = R1^T R2; |error of Ro| <= Ro_bound unless inf or NaN.
   R1, R2, Ro, Ro_bound: rotation or other 3×3 matrix.
   36 mul, 45 add, 27 abs. */
static inline void ksl_product_drinvdrf_certified(const ksl_mat3x3f_t *R1,
    const ksl_mat3x3f_t *R2, ksl_mat3x3f_t *Ro, ksl_mat3x3f_t *Ro_bound) {
  const float Ro_00a = KSL_MULF(R1->m00, R2->m00), Ro_00b = KSL_MULF(R1->m10, R2->m10),
      Ro_00c = Ro_00a + Ro_00b, Ro_00d = KSL_MULF(R1->m20, R2->m20), Ro_00 = Ro_00c + Ro_00d;
  const float Ro_01a = KSL_MULF(R1->m00, R2->m01), Ro_01b = KSL_MULF(R1->m10, R2->m11),
      Ro_01c = Ro_01a + Ro_01b, Ro_01d = KSL_MULF(R1->m20, R2->m21), Ro_01 = Ro_01c + Ro_01d;
  const float Ro_02a = KSL_MULF(R1->m00, R2->m02), Ro_02b = KSL_MULF(R1->m10, R2->m12),
      Ro_02c = Ro_02a + Ro_02b, Ro_02d = KSL_MULF(R1->m20, R2->m22), Ro_02 = Ro_02c + Ro_02d;
  const float Ro_10a = KSL_MULF(R1->m01, R2->m00), Ro_10b = KSL_MULF(R1->m11, R2->m10),
      Ro_10c = Ro_10a + Ro_10b, Ro_10d = KSL_MULF(R1->m21, R2->m20), Ro_10 = Ro_10c + Ro_10d;
  const float Ro_11a = KSL_MULF(R1->m01, R2->m01), Ro_11b = KSL_MULF(R1->m11, R2->m11),
      Ro_11c = Ro_11a + Ro_11b, Ro_11d = KSL_MULF(R1->m21, R2->m21), Ro_11 = Ro_11c + Ro_11d;
  const float Ro_12a = KSL_MULF(R1->m01, R2->m02), Ro_12b = KSL_MULF(R1->m11, R2->m12),
      Ro_12c = Ro_12a + Ro_12b, Ro_12d = KSL_MULF(R1->m21, R2->m22), Ro_12 = Ro_12c + Ro_12d;
  const float Ro_20a = KSL_MULF(R1->m02, R2->m00), Ro_20b = KSL_MULF(R1->m12, R2->m10),
      Ro_20c = Ro_20a + Ro_20b, Ro_20d = KSL_MULF(R1->m22, R2->m20), Ro_20 = Ro_20c + Ro_20d;
  const float Ro_21a = KSL_MULF(R1->m02, R2->m01), Ro_21b = KSL_MULF(R1->m12, R2->m11),
      Ro_21c = Ro_21a + Ro_21b, Ro_21d = KSL_MULF(R1->m22, R2->m21), Ro_21 = Ro_21c + Ro_21d;
  const float Ro_22a = KSL_MULF(R1->m02, R2->m02), Ro_22b = KSL_MULF(R1->m12, R2->m12),
      Ro_22c = Ro_22a + Ro_22b, Ro_22d = KSL_MULF(R1->m22, R2->m22), Ro_22 = Ro_22c + Ro_22d;
  const float Ro_00a_abs = fabsf(Ro_00a), Ro_00b_abs = fabsf(Ro_00b),
      Ro_00c_size = Ro_00a_abs + Ro_00b_abs, Ro_00d_abs = fabsf(Ro_00d),
      Ro_00_size = Ro_00c_size + Ro_00d_abs;
  const float Ro_01a_abs = fabsf(Ro_01a), Ro_01b_abs = fabsf(Ro_01b),
      Ro_01c_size = Ro_01a_abs + Ro_01b_abs, Ro_01d_abs = fabsf(Ro_01d),
      Ro_01_size = Ro_01c_size + Ro_01d_abs;
  const float Ro_02a_abs = fabsf(Ro_02a), Ro_02b_abs = fabsf(Ro_02b),
      Ro_02c_size = Ro_02a_abs + Ro_02b_abs, Ro_02d_abs = fabsf(Ro_02d),
      Ro_02_size = Ro_02c_size + Ro_02d_abs;
  const float Ro_10a_abs = fabsf(Ro_10a), Ro_10b_abs = fabsf(Ro_10b),
      Ro_10c_size = Ro_10a_abs + Ro_10b_abs, Ro_10d_abs = fabsf(Ro_10d),
      Ro_10_size = Ro_10c_size + Ro_10d_abs;
  const float Ro_11a_abs = fabsf(Ro_11a), Ro_11b_abs = fabsf(Ro_11b),
      Ro_11c_size = Ro_11a_abs + Ro_11b_abs, Ro_11d_abs = fabsf(Ro_11d),
      Ro_11_size = Ro_11c_size + Ro_11d_abs;
  const float Ro_12a_abs = fabsf(Ro_12a), Ro_12b_abs = fabsf(Ro_12b),
      Ro_12c_size = Ro_12a_abs + Ro_12b_abs, Ro_12d_abs = fabsf(Ro_12d),
      Ro_12_size = Ro_12c_size + Ro_12d_abs;
  const float Ro_20a_abs = fabsf(Ro_20a), Ro_20b_abs = fabsf(Ro_20b),
      Ro_20c_size = Ro_20a_abs + Ro_20b_abs, Ro_20d_abs = fabsf(Ro_20d),
      Ro_20_size = Ro_20c_size + Ro_20d_abs;
  const float Ro_21a_abs = fabsf(Ro_21a), Ro_21b_abs = fabsf(Ro_21b),
      Ro_21c_size = Ro_21a_abs + Ro_21b_abs, Ro_21d_abs = fabsf(Ro_21d),
      Ro_21_size = Ro_21c_size + Ro_21d_abs;
  const float Ro_22a_abs = fabsf(Ro_22a), Ro_22b_abs = fabsf(Ro_22b),
      Ro_22c_size = Ro_22a_abs + Ro_22b_abs, Ro_22d_abs = fabsf(Ro_22d),
      Ro_22_size = Ro_22c_size + Ro_22d_abs;
  const float Ro_00_padded = Ro_00_size + 1.9721523e-31f,
      Ro_00_error_bound = KSL_MULF(1.7881396e-07f, Ro_00_padded);
  const float Ro_01_padded = Ro_01_size + 1.9721523e-31f,
      Ro_01_error_bound = KSL_MULF(1.7881396e-07f, Ro_01_padded);
  const float Ro_02_padded = Ro_02_size + 1.9721523e-31f,
      Ro_02_error_bound = KSL_MULF(1.7881396e-07f, Ro_02_padded);
  const float Ro_10_padded = Ro_10_size + 1.9721523e-31f,
      Ro_10_error_bound = KSL_MULF(1.7881396e-07f, Ro_10_padded);
  const float Ro_11_padded = Ro_11_size + 1.9721523e-31f,
      Ro_11_error_bound = KSL_MULF(1.7881396e-07f, Ro_11_padded);
  const float Ro_12_padded = Ro_12_size + 1.9721523e-31f,
      Ro_12_error_bound = KSL_MULF(1.7881396e-07f, Ro_12_padded);
  const float Ro_20_padded = Ro_20_size + 1.9721523e-31f,
      Ro_20_error_bound = KSL_MULF(1.7881396e-07f, Ro_20_padded);
  const float Ro_21_padded = Ro_21_size + 1.9721523e-31f,
      Ro_21_error_bound = KSL_MULF(1.7881396e-07f, Ro_21_padded);
  const float Ro_22_padded = Ro_22_size + 1.9721523e-31f,
      Ro_22_error_bound = KSL_MULF(1.7881396e-07f, Ro_22_padded);
  Ro->m00 = Ro_00;
  Ro->m01 = Ro_01;
  Ro->m02 = Ro_02;
  Ro->m10 = Ro_10;
  Ro->m11 = Ro_11;
  Ro->m12 = Ro_12;
  Ro->m20 = Ro_20;
  Ro->m21 = Ro_21;
  Ro->m22 = Ro_22;
  Ro_bound->m00 = Ro_00_error_bound;
  Ro_bound->m01 = Ro_01_error_bound;
  Ro_bound->m02 = Ro_02_error_bound;
  Ro_bound->m10 = Ro_10_error_bound;
  Ro_bound->m11 = Ro_11_error_bound;
  Ro_bound->m12 = Ro_12_error_bound;
  Ro_bound->m20 = Ro_20_error_bound;
  Ro_bound->m21 = Ro_21_error_bound;
  Ro_bound->m22 = Ro_22_error_bound;
}

/* Do = D1 D2 = [R1 R2 | R1 t2 + t1]; |error of Do| <= Do_bound unless inf or NaN.
   D1, D2, Do, Do_bound: displacement [R | t], R rotation, t in m.
   48 mul, 66 add, 39 abs. */
static inline void ksl_product_ddf_certified(const ksl_SE3f_t *D1, const ksl_SE3f_t *D2,
    ksl_SE3f_t *Do, ksl_SE3f_t *Do_bound) {
  const float Do_00a = KSL_MULF(D1->m00, D2->m00), Do_00b = KSL_MULF(D1->m01, D2->m10),
      Do_00c = Do_00a + Do_00b, Do_00d = KSL_MULF(D1->m02, D2->m20), Do_00 = Do_00c + Do_00d;
  const float Do_01a = KSL_MULF(D1->m00, D2->m01), Do_01b = KSL_MULF(D1->m01, D2->m11),
      Do_01c = Do_01a + Do_01b, Do_01d = KSL_MULF(D1->m02, D2->m21), Do_01 = Do_01c + Do_01d;
  const float Do_02a = KSL_MULF(D1->m00, D2->m02), Do_02b = KSL_MULF(D1->m01, D2->m12),
      Do_02c = Do_02a + Do_02b, Do_02d = KSL_MULF(D1->m02, D2->m22), Do_02 = Do_02c + Do_02d;
  const float Do_03a = KSL_MULF(D1->m00, D2->m03), Do_03b = KSL_MULF(D1->m01, D2->m13),
      Do_03c = Do_03a + Do_03b, Do_03d = KSL_MULF(D1->m02, D2->m23), Do_03e = Do_03c + Do_03d,
      Do_03 = Do_03e + D1->m03;
  const float Do_10a = KSL_MULF(D1->m10, D2->m00), Do_10b = KSL_MULF(D1->m11, D2->m10),
      Do_10c = Do_10a + Do_10b, Do_10d = KSL_MULF(D1->m12, D2->m20), Do_10 = Do_10c + Do_10d;
  const float Do_11a = KSL_MULF(D1->m10, D2->m01), Do_11b = KSL_MULF(D1->m11, D2->m11),
      Do_11c = Do_11a + Do_11b, Do_11d = KSL_MULF(D1->m12, D2->m21), Do_11 = Do_11c + Do_11d;
  const float Do_12a = KSL_MULF(D1->m10, D2->m02), Do_12b = KSL_MULF(D1->m11, D2->m12),
      Do_12c = Do_12a + Do_12b, Do_12d = KSL_MULF(D1->m12, D2->m22), Do_12 = Do_12c + Do_12d;
  const float Do_13a = KSL_MULF(D1->m10, D2->m03), Do_13b = KSL_MULF(D1->m11, D2->m13),
      Do_13c = Do_13a + Do_13b, Do_13d = KSL_MULF(D1->m12, D2->m23), Do_13e = Do_13c + Do_13d,
      Do_13 = Do_13e + D1->m13;
  const float Do_20a = KSL_MULF(D1->m20, D2->m00), Do_20b = KSL_MULF(D1->m21, D2->m10),
      Do_20c = Do_20a + Do_20b, Do_20d = KSL_MULF(D1->m22, D2->m20), Do_20 = Do_20c + Do_20d;
  const float Do_21a = KSL_MULF(D1->m20, D2->m01), Do_21b = KSL_MULF(D1->m21, D2->m11),
      Do_21c = Do_21a + Do_21b, Do_21d = KSL_MULF(D1->m22, D2->m21), Do_21 = Do_21c + Do_21d;
  const float Do_22a = KSL_MULF(D1->m20, D2->m02), Do_22b = KSL_MULF(D1->m21, D2->m12),
      Do_22c = Do_22a + Do_22b, Do_22d = KSL_MULF(D1->m22, D2->m22), Do_22 = Do_22c + Do_22d;
  const float Do_23a = KSL_MULF(D1->m20, D2->m03), Do_23b = KSL_MULF(D1->m21, D2->m13),
      Do_23c = Do_23a + Do_23b, Do_23d = KSL_MULF(D1->m22, D2->m23), Do_23e = Do_23c + Do_23d,
      Do_23 = Do_23e + D1->m23;
  const float Do_00a_abs = fabsf(Do_00a), Do_00b_abs = fabsf(Do_00b),
      Do_00c_size = Do_00a_abs + Do_00b_abs, Do_00d_abs = fabsf(Do_00d),
      Do_00_size = Do_00c_size + Do_00d_abs;
  const float Do_01a_abs = fabsf(Do_01a), Do_01b_abs = fabsf(Do_01b),
      Do_01c_size = Do_01a_abs + Do_01b_abs, Do_01d_abs = fabsf(Do_01d),
      Do_01_size = Do_01c_size + Do_01d_abs;
  const float Do_02a_abs = fabsf(Do_02a), Do_02b_abs = fabsf(Do_02b),
      Do_02c_size = Do_02a_abs + Do_02b_abs, Do_02d_abs = fabsf(Do_02d),
      Do_02_size = Do_02c_size + Do_02d_abs;
  const float Do_03a_abs = fabsf(Do_03a), Do_03b_abs = fabsf(Do_03b),
      Do_03c_size = Do_03a_abs + Do_03b_abs, Do_03d_abs = fabsf(Do_03d),
      Do_03e_size = Do_03c_size + Do_03d_abs, D1_03_abs = fabsf(D1->m03),
      Do_03_size = Do_03e_size + D1_03_abs;
  const float Do_10a_abs = fabsf(Do_10a), Do_10b_abs = fabsf(Do_10b),
      Do_10c_size = Do_10a_abs + Do_10b_abs, Do_10d_abs = fabsf(Do_10d),
      Do_10_size = Do_10c_size + Do_10d_abs;
  const float Do_11a_abs = fabsf(Do_11a), Do_11b_abs = fabsf(Do_11b),
      Do_11c_size = Do_11a_abs + Do_11b_abs, Do_11d_abs = fabsf(Do_11d),
      Do_11_size = Do_11c_size + Do_11d_abs;
  const float Do_12a_abs = fabsf(Do_12a), Do_12b_abs = fabsf(Do_12b),
      Do_12c_size = Do_12a_abs + Do_12b_abs, Do_12d_abs = fabsf(Do_12d),
      Do_12_size = Do_12c_size + Do_12d_abs;
  const float Do_13a_abs = fabsf(Do_13a), Do_13b_abs = fabsf(Do_13b),
      Do_13c_size = Do_13a_abs + Do_13b_abs, Do_13d_abs = fabsf(Do_13d),
      Do_13e_size = Do_13c_size + Do_13d_abs, D1_13_abs = fabsf(D1->m13),
      Do_13_size = Do_13e_size + D1_13_abs;
  const float Do_20a_abs = fabsf(Do_20a), Do_20b_abs = fabsf(Do_20b),
      Do_20c_size = Do_20a_abs + Do_20b_abs, Do_20d_abs = fabsf(Do_20d),
      Do_20_size = Do_20c_size + Do_20d_abs;
  const float Do_21a_abs = fabsf(Do_21a), Do_21b_abs = fabsf(Do_21b),
      Do_21c_size = Do_21a_abs + Do_21b_abs, Do_21d_abs = fabsf(Do_21d),
      Do_21_size = Do_21c_size + Do_21d_abs;
  const float Do_22a_abs = fabsf(Do_22a), Do_22b_abs = fabsf(Do_22b),
      Do_22c_size = Do_22a_abs + Do_22b_abs, Do_22d_abs = fabsf(Do_22d),
      Do_22_size = Do_22c_size + Do_22d_abs;
  const float Do_23a_abs = fabsf(Do_23a), Do_23b_abs = fabsf(Do_23b),
      Do_23c_size = Do_23a_abs + Do_23b_abs, Do_23d_abs = fabsf(Do_23d),
      Do_23e_size = Do_23c_size + Do_23d_abs, D1_23_abs = fabsf(D1->m23),
      Do_23_size = Do_23e_size + D1_23_abs;
  const float Do_00_padded = Do_00_size + 1.9721523e-31f,
      Do_00_error_bound = KSL_MULF(1.7881396e-07f, Do_00_padded);
  const float Do_01_padded = Do_01_size + 1.9721523e-31f,
      Do_01_error_bound = KSL_MULF(1.7881396e-07f, Do_01_padded);
  const float Do_02_padded = Do_02_size + 1.9721523e-31f,
      Do_02_error_bound = KSL_MULF(1.7881396e-07f, Do_02_padded);
  const float Do_03_padded = Do_03_size + 1.9721523e-31f,
      Do_03_error_bound = KSL_MULF(2.3841864e-07f, Do_03_padded);
  const float Do_10_padded = Do_10_size + 1.9721523e-31f,
      Do_10_error_bound = KSL_MULF(1.7881396e-07f, Do_10_padded);
  const float Do_11_padded = Do_11_size + 1.9721523e-31f,
      Do_11_error_bound = KSL_MULF(1.7881396e-07f, Do_11_padded);
  const float Do_12_padded = Do_12_size + 1.9721523e-31f,
      Do_12_error_bound = KSL_MULF(1.7881396e-07f, Do_12_padded);
  const float Do_13_padded = Do_13_size + 1.9721523e-31f,
      Do_13_error_bound = KSL_MULF(2.3841864e-07f, Do_13_padded);
  const float Do_20_padded = Do_20_size + 1.9721523e-31f,
      Do_20_error_bound = KSL_MULF(1.7881396e-07f, Do_20_padded);
  const float Do_21_padded = Do_21_size + 1.9721523e-31f,
      Do_21_error_bound = KSL_MULF(1.7881396e-07f, Do_21_padded);
  const float Do_22_padded = Do_22_size + 1.9721523e-31f,
      Do_22_error_bound = KSL_MULF(1.7881396e-07f, Do_22_padded);
  const float Do_23_padded = Do_23_size + 1.9721523e-31f,
      Do_23_error_bound = KSL_MULF(2.3841864e-07f, Do_23_padded);
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
  Do_bound->m00 = Do_00_error_bound;
  Do_bound->m01 = Do_01_error_bound;
  Do_bound->m02 = Do_02_error_bound;
  Do_bound->m03 = Do_03_error_bound;
  Do_bound->m10 = Do_10_error_bound;
  Do_bound->m11 = Do_11_error_bound;
  Do_bound->m12 = Do_12_error_bound;
  Do_bound->m13 = Do_13_error_bound;
  Do_bound->m20 = Do_20_error_bound;
  Do_bound->m21 = Do_21_error_bound;
  Do_bound->m22 = Do_22_error_bound;
  Do_bound->m23 = Do_23_error_bound;
}

/* Do = D1 D2^-1 = [R | t1 - R t2], R = R1 R2^T; |error of Do| <= Do_bound unless inf or NaN.
   D1, D2, Do, Do_bound: displacement [R | t], R rotation, t in m.
   57 mul, 66 add, 33 abs. */
static inline void ksl_product_ddinvf_certified(const ksl_SE3f_t *D1, const ksl_SE3f_t *D2,
    ksl_SE3f_t *Do, ksl_SE3f_t *Do_bound) {
  const float R_0a = KSL_MULF(D1->m00, D2->m00), R_0b = KSL_MULF(D1->m01, D2->m01),
      R_0c = R_0a + R_0b, R_0d = KSL_MULF(D1->m02, D2->m02), R_0 = R_0c + R_0d;
  const float R_1a = KSL_MULF(D1->m00, D2->m10), R_1b = KSL_MULF(D1->m01, D2->m11),
      R_1c = R_1a + R_1b, R_1d = KSL_MULF(D1->m02, D2->m12), R_1 = R_1c + R_1d;
  const float R_2a = KSL_MULF(D1->m00, D2->m20), R_2b = KSL_MULF(D1->m01, D2->m21),
      R_2c = R_2a + R_2b, R_2d = KSL_MULF(D1->m02, D2->m22), R_2 = R_2c + R_2d;
  const float R_3a = KSL_MULF(D1->m10, D2->m00), R_3b = KSL_MULF(D1->m11, D2->m01),
      R_3c = R_3a + R_3b, R_3d = KSL_MULF(D1->m12, D2->m02), R_3 = R_3c + R_3d;
  const float R_4a = KSL_MULF(D1->m10, D2->m10), R_4b = KSL_MULF(D1->m11, D2->m11),
      R_4c = R_4a + R_4b, R_4d = KSL_MULF(D1->m12, D2->m12), R_4 = R_4c + R_4d;
  const float R_5a = KSL_MULF(D1->m10, D2->m20), R_5b = KSL_MULF(D1->m11, D2->m21),
      R_5c = R_5a + R_5b, R_5d = KSL_MULF(D1->m12, D2->m22), R_5 = R_5c + R_5d;
  const float R_6a = KSL_MULF(D1->m20, D2->m00), R_6b = KSL_MULF(D1->m21, D2->m01),
      R_6c = R_6a + R_6b, R_6d = KSL_MULF(D1->m22, D2->m02), R_6 = R_6c + R_6d;
  const float R_7a = KSL_MULF(D1->m20, D2->m10), R_7b = KSL_MULF(D1->m21, D2->m11),
      R_7c = R_7a + R_7b, R_7d = KSL_MULF(D1->m22, D2->m12), R_7 = R_7c + R_7d;
  const float R_8a = KSL_MULF(D1->m20, D2->m20), R_8b = KSL_MULF(D1->m21, D2->m21),
      R_8c = R_8a + R_8b, R_8d = KSL_MULF(D1->m22, D2->m22), R_8 = R_8c + R_8d;
  const float Do_03a = KSL_MULF(D2->m03, R_0), Do_03b = KSL_MULF(D2->m13, R_1),
      Do_03c = Do_03a + Do_03b, Do_03d = KSL_MULF(D2->m23, R_2), Do_03e = Do_03c + Do_03d,
      Do_03 = D1->m03 - Do_03e;
  const float Do_13a = KSL_MULF(D2->m03, R_3), Do_13b = KSL_MULF(D2->m13, R_4),
      Do_13c = Do_13a + Do_13b, Do_13d = KSL_MULF(D2->m23, R_5), Do_13e = Do_13c + Do_13d,
      Do_13 = D1->m13 - Do_13e;
  const float Do_23a = KSL_MULF(D2->m03, R_6), Do_23b = KSL_MULF(D2->m13, R_7),
      Do_23c = Do_23a + Do_23b, Do_23d = KSL_MULF(D2->m23, R_8), Do_23e = Do_23c + Do_23d,
      Do_23 = D1->m23 - Do_23e;
  const float R_0a_abs = fabsf(R_0a), R_0b_abs = fabsf(R_0b), R_0c_size = R_0a_abs + R_0b_abs,
      R_0d_abs = fabsf(R_0d), R_0_size = R_0c_size + R_0d_abs;
  const float R_1a_abs = fabsf(R_1a), R_1b_abs = fabsf(R_1b), R_1c_size = R_1a_abs + R_1b_abs,
      R_1d_abs = fabsf(R_1d), R_1_size = R_1c_size + R_1d_abs;
  const float R_2a_abs = fabsf(R_2a), R_2b_abs = fabsf(R_2b), R_2c_size = R_2a_abs + R_2b_abs,
      R_2d_abs = fabsf(R_2d), R_2_size = R_2c_size + R_2d_abs;
  const float R_3a_abs = fabsf(R_3a), R_3b_abs = fabsf(R_3b), R_3c_size = R_3a_abs + R_3b_abs,
      R_3d_abs = fabsf(R_3d), R_3_size = R_3c_size + R_3d_abs;
  const float R_4a_abs = fabsf(R_4a), R_4b_abs = fabsf(R_4b), R_4c_size = R_4a_abs + R_4b_abs,
      R_4d_abs = fabsf(R_4d), R_4_size = R_4c_size + R_4d_abs;
  const float R_5a_abs = fabsf(R_5a), R_5b_abs = fabsf(R_5b), R_5c_size = R_5a_abs + R_5b_abs,
      R_5d_abs = fabsf(R_5d), R_5_size = R_5c_size + R_5d_abs;
  const float R_6a_abs = fabsf(R_6a), R_6b_abs = fabsf(R_6b), R_6c_size = R_6a_abs + R_6b_abs,
      R_6d_abs = fabsf(R_6d), R_6_size = R_6c_size + R_6d_abs;
  const float R_7a_abs = fabsf(R_7a), R_7b_abs = fabsf(R_7b), R_7c_size = R_7a_abs + R_7b_abs,
      R_7d_abs = fabsf(R_7d), R_7_size = R_7c_size + R_7d_abs;
  const float R_8a_abs = fabsf(R_8a), R_8b_abs = fabsf(R_8b), R_8c_size = R_8a_abs + R_8b_abs,
      R_8d_abs = fabsf(R_8d), R_8_size = R_8c_size + R_8d_abs;
  const float R_0_padded = R_0_size + 1.9721523e-31f;
  const float D2_03_abs = fabsf(D2->m03), Do_03a_size = KSL_MULF(D2_03_abs, R_0_padded);
  const float R_1_padded = R_1_size + 1.9721523e-31f;
  const float D2_13_abs = fabsf(D2->m13), Do_03b_size = KSL_MULF(D2_13_abs, R_1_padded),
      Do_03c_size = Do_03a_size + Do_03b_size;
  const float R_2_padded = R_2_size + 1.9721523e-31f;
  const float D2_23_abs = fabsf(D2->m23), Do_03d_size = KSL_MULF(D2_23_abs, R_2_padded),
      Do_03e_size = Do_03c_size + Do_03d_size, D1_03_abs = fabsf(D1->m03),
      Do_03_size = D1_03_abs + Do_03e_size;
  const float R_3_padded = R_3_size + 1.9721523e-31f;
  const float Do_13a_size = KSL_MULF(D2_03_abs, R_3_padded);
  const float R_4_padded = R_4_size + 1.9721523e-31f;
  const float Do_13b_size = KSL_MULF(D2_13_abs, R_4_padded),
      Do_13c_size = Do_13a_size + Do_13b_size;
  const float R_5_padded = R_5_size + 1.9721523e-31f;
  const float Do_13d_size = KSL_MULF(D2_23_abs, R_5_padded),
      Do_13e_size = Do_13c_size + Do_13d_size, D1_13_abs = fabsf(D1->m13),
      Do_13_size = D1_13_abs + Do_13e_size;
  const float R_6_padded = R_6_size + 1.9721523e-31f;
  const float Do_23a_size = KSL_MULF(D2_03_abs, R_6_padded);
  const float R_7_padded = R_7_size + 1.9721523e-31f;
  const float Do_23b_size = KSL_MULF(D2_13_abs, R_7_padded),
      Do_23c_size = Do_23a_size + Do_23b_size;
  const float R_8_padded = R_8_size + 1.9721523e-31f;
  const float Do_23d_size = KSL_MULF(D2_23_abs, R_8_padded),
      Do_23e_size = Do_23c_size + Do_23d_size, D1_23_abs = fabsf(D1->m23),
      Do_23_size = D1_23_abs + Do_23e_size;
  const float R_0_error_bound = KSL_MULF(1.7881396e-07f, R_0_padded);
  const float R_1_error_bound = KSL_MULF(1.7881396e-07f, R_1_padded);
  const float R_2_error_bound = KSL_MULF(1.7881396e-07f, R_2_padded);
  const float Do_03_padded = Do_03_size + 1.9721523e-31f,
      Do_03_error_bound = KSL_MULF(4.1723263e-07f, Do_03_padded);
  const float R_3_error_bound = KSL_MULF(1.7881396e-07f, R_3_padded);
  const float R_4_error_bound = KSL_MULF(1.7881396e-07f, R_4_padded);
  const float R_5_error_bound = KSL_MULF(1.7881396e-07f, R_5_padded);
  const float Do_13_padded = Do_13_size + 1.9721523e-31f,
      Do_13_error_bound = KSL_MULF(4.1723263e-07f, Do_13_padded);
  const float R_6_error_bound = KSL_MULF(1.7881396e-07f, R_6_padded);
  const float R_7_error_bound = KSL_MULF(1.7881396e-07f, R_7_padded);
  const float R_8_error_bound = KSL_MULF(1.7881396e-07f, R_8_padded);
  const float Do_23_padded = Do_23_size + 1.9721523e-31f,
      Do_23_error_bound = KSL_MULF(4.1723263e-07f, Do_23_padded);
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
  Do_bound->m00 = R_0_error_bound;
  Do_bound->m01 = R_1_error_bound;
  Do_bound->m02 = R_2_error_bound;
  Do_bound->m03 = Do_03_error_bound;
  Do_bound->m10 = R_3_error_bound;
  Do_bound->m11 = R_4_error_bound;
  Do_bound->m12 = R_5_error_bound;
  Do_bound->m13 = Do_13_error_bound;
  Do_bound->m20 = R_6_error_bound;
  Do_bound->m21 = R_7_error_bound;
  Do_bound->m22 = R_8_error_bound;
  Do_bound->m23 = Do_23_error_bound;
}

/* Do = D1^-1 D2 = [R1^T R2 | R1^T (t2 - t1)]; |error of Do| <= Do_bound unless inf or NaN.
   D1, D2, Do, Do_bound: displacement [R | t], R rotation, t in m.
   57 mul, 63 add, 39 abs. */
static inline void ksl_product_dinvdf_certified(const ksl_SE3f_t *D1, const ksl_SE3f_t *D2,
    ksl_SE3f_t *Do, ksl_SE3f_t *Do_bound) {
  const float p_0 = D2->m03 - D1->m03;
  const float p_1 = D2->m13 - D1->m13;
  const float p_2 = D2->m23 - D1->m23;
  const float Do_00a = KSL_MULF(D1->m00, D2->m00), Do_00b = KSL_MULF(D1->m10, D2->m10),
      Do_00c = Do_00a + Do_00b, Do_00d = KSL_MULF(D1->m20, D2->m20), Do_00 = Do_00c + Do_00d;
  const float Do_01a = KSL_MULF(D1->m00, D2->m01), Do_01b = KSL_MULF(D1->m10, D2->m11),
      Do_01c = Do_01a + Do_01b, Do_01d = KSL_MULF(D1->m20, D2->m21), Do_01 = Do_01c + Do_01d;
  const float Do_02a = KSL_MULF(D1->m00, D2->m02), Do_02b = KSL_MULF(D1->m10, D2->m12),
      Do_02c = Do_02a + Do_02b, Do_02d = KSL_MULF(D1->m20, D2->m22), Do_02 = Do_02c + Do_02d;
  const float Do_03a = KSL_MULF(D1->m00, p_0), Do_03b = KSL_MULF(D1->m10, p_1),
      Do_03c = Do_03a + Do_03b, Do_03d = KSL_MULF(D1->m20, p_2), Do_03 = Do_03c + Do_03d;
  const float Do_10a = KSL_MULF(D1->m01, D2->m00), Do_10b = KSL_MULF(D1->m11, D2->m10),
      Do_10c = Do_10a + Do_10b, Do_10d = KSL_MULF(D1->m21, D2->m20), Do_10 = Do_10c + Do_10d;
  const float Do_11a = KSL_MULF(D1->m01, D2->m01), Do_11b = KSL_MULF(D1->m11, D2->m11),
      Do_11c = Do_11a + Do_11b, Do_11d = KSL_MULF(D1->m21, D2->m21), Do_11 = Do_11c + Do_11d;
  const float Do_12a = KSL_MULF(D1->m01, D2->m02), Do_12b = KSL_MULF(D1->m11, D2->m12),
      Do_12c = Do_12a + Do_12b, Do_12d = KSL_MULF(D1->m21, D2->m22), Do_12 = Do_12c + Do_12d;
  const float Do_13a = KSL_MULF(D1->m01, p_0), Do_13b = KSL_MULF(D1->m11, p_1),
      Do_13c = Do_13a + Do_13b, Do_13d = KSL_MULF(D1->m21, p_2), Do_13 = Do_13c + Do_13d;
  const float Do_20a = KSL_MULF(D1->m02, D2->m00), Do_20b = KSL_MULF(D1->m12, D2->m10),
      Do_20c = Do_20a + Do_20b, Do_20d = KSL_MULF(D1->m22, D2->m20), Do_20 = Do_20c + Do_20d;
  const float Do_21a = KSL_MULF(D1->m02, D2->m01), Do_21b = KSL_MULF(D1->m12, D2->m11),
      Do_21c = Do_21a + Do_21b, Do_21d = KSL_MULF(D1->m22, D2->m21), Do_21 = Do_21c + Do_21d;
  const float Do_22a = KSL_MULF(D1->m02, D2->m02), Do_22b = KSL_MULF(D1->m12, D2->m12),
      Do_22c = Do_22a + Do_22b, Do_22d = KSL_MULF(D1->m22, D2->m22), Do_22 = Do_22c + Do_22d;
  const float Do_23a = KSL_MULF(D1->m02, p_0), Do_23b = KSL_MULF(D1->m12, p_1),
      Do_23c = Do_23a + Do_23b, Do_23d = KSL_MULF(D1->m22, p_2), Do_23 = Do_23c + Do_23d;
  const float Do_00a_abs = fabsf(Do_00a), Do_00b_abs = fabsf(Do_00b),
      Do_00c_size = Do_00a_abs + Do_00b_abs, Do_00d_abs = fabsf(Do_00d),
      Do_00_size = Do_00c_size + Do_00d_abs;
  const float Do_01a_abs = fabsf(Do_01a), Do_01b_abs = fabsf(Do_01b),
      Do_01c_size = Do_01a_abs + Do_01b_abs, Do_01d_abs = fabsf(Do_01d),
      Do_01_size = Do_01c_size + Do_01d_abs;
  const float Do_02a_abs = fabsf(Do_02a), Do_02b_abs = fabsf(Do_02b),
      Do_02c_size = Do_02a_abs + Do_02b_abs, Do_02d_abs = fabsf(Do_02d),
      Do_02_size = Do_02c_size + Do_02d_abs;
  const float D1_00_abs = fabsf(D1->m00), p_0_abs = fabsf(p_0),
      Do_03a_size = KSL_MULF(D1_00_abs, p_0_abs), D1_10_abs = fabsf(D1->m10), p_1_abs = fabsf(p_1),
      Do_03b_size = KSL_MULF(D1_10_abs, p_1_abs), Do_03c_size = Do_03a_size + Do_03b_size,
      D1_20_abs = fabsf(D1->m20), p_2_abs = fabsf(p_2), Do_03d_size = KSL_MULF(D1_20_abs, p_2_abs),
      Do_03_size = Do_03c_size + Do_03d_size;
  const float Do_10a_abs = fabsf(Do_10a), Do_10b_abs = fabsf(Do_10b),
      Do_10c_size = Do_10a_abs + Do_10b_abs, Do_10d_abs = fabsf(Do_10d),
      Do_10_size = Do_10c_size + Do_10d_abs;
  const float Do_11a_abs = fabsf(Do_11a), Do_11b_abs = fabsf(Do_11b),
      Do_11c_size = Do_11a_abs + Do_11b_abs, Do_11d_abs = fabsf(Do_11d),
      Do_11_size = Do_11c_size + Do_11d_abs;
  const float Do_12a_abs = fabsf(Do_12a), Do_12b_abs = fabsf(Do_12b),
      Do_12c_size = Do_12a_abs + Do_12b_abs, Do_12d_abs = fabsf(Do_12d),
      Do_12_size = Do_12c_size + Do_12d_abs;
  const float D1_01_abs = fabsf(D1->m01), Do_13a_size = KSL_MULF(D1_01_abs, p_0_abs),
      D1_11_abs = fabsf(D1->m11), Do_13b_size = KSL_MULF(D1_11_abs, p_1_abs),
      Do_13c_size = Do_13a_size + Do_13b_size, D1_21_abs = fabsf(D1->m21),
      Do_13d_size = KSL_MULF(D1_21_abs, p_2_abs), Do_13_size = Do_13c_size + Do_13d_size;
  const float Do_20a_abs = fabsf(Do_20a), Do_20b_abs = fabsf(Do_20b),
      Do_20c_size = Do_20a_abs + Do_20b_abs, Do_20d_abs = fabsf(Do_20d),
      Do_20_size = Do_20c_size + Do_20d_abs;
  const float Do_21a_abs = fabsf(Do_21a), Do_21b_abs = fabsf(Do_21b),
      Do_21c_size = Do_21a_abs + Do_21b_abs, Do_21d_abs = fabsf(Do_21d),
      Do_21_size = Do_21c_size + Do_21d_abs;
  const float Do_22a_abs = fabsf(Do_22a), Do_22b_abs = fabsf(Do_22b),
      Do_22c_size = Do_22a_abs + Do_22b_abs, Do_22d_abs = fabsf(Do_22d),
      Do_22_size = Do_22c_size + Do_22d_abs;
  const float D1_02_abs = fabsf(D1->m02), Do_23a_size = KSL_MULF(D1_02_abs, p_0_abs),
      D1_12_abs = fabsf(D1->m12), Do_23b_size = KSL_MULF(D1_12_abs, p_1_abs),
      Do_23c_size = Do_23a_size + Do_23b_size, D1_22_abs = fabsf(D1->m22),
      Do_23d_size = KSL_MULF(D1_22_abs, p_2_abs), Do_23_size = Do_23c_size + Do_23d_size;
  const float Do_00_padded = Do_00_size + 1.9721523e-31f,
      Do_00_error_bound = KSL_MULF(1.7881396e-07f, Do_00_padded);
  const float Do_01_padded = Do_01_size + 1.9721523e-31f,
      Do_01_error_bound = KSL_MULF(1.7881396e-07f, Do_01_padded);
  const float Do_02_padded = Do_02_size + 1.9721523e-31f,
      Do_02_error_bound = KSL_MULF(1.7881396e-07f, Do_02_padded);
  const float Do_03_padded = Do_03_size + 1.9721523e-31f,
      Do_03_error_bound = KSL_MULF(2.3841864e-07f, Do_03_padded);
  const float Do_10_padded = Do_10_size + 1.9721523e-31f,
      Do_10_error_bound = KSL_MULF(1.7881396e-07f, Do_10_padded);
  const float Do_11_padded = Do_11_size + 1.9721523e-31f,
      Do_11_error_bound = KSL_MULF(1.7881396e-07f, Do_11_padded);
  const float Do_12_padded = Do_12_size + 1.9721523e-31f,
      Do_12_error_bound = KSL_MULF(1.7881396e-07f, Do_12_padded);
  const float Do_13_padded = Do_13_size + 1.9721523e-31f,
      Do_13_error_bound = KSL_MULF(2.3841864e-07f, Do_13_padded);
  const float Do_20_padded = Do_20_size + 1.9721523e-31f,
      Do_20_error_bound = KSL_MULF(1.7881396e-07f, Do_20_padded);
  const float Do_21_padded = Do_21_size + 1.9721523e-31f,
      Do_21_error_bound = KSL_MULF(1.7881396e-07f, Do_21_padded);
  const float Do_22_padded = Do_22_size + 1.9721523e-31f,
      Do_22_error_bound = KSL_MULF(1.7881396e-07f, Do_22_padded);
  const float Do_23_padded = Do_23_size + 1.9721523e-31f,
      Do_23_error_bound = KSL_MULF(2.3841864e-07f, Do_23_padded);
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
  Do_bound->m00 = Do_00_error_bound;
  Do_bound->m01 = Do_01_error_bound;
  Do_bound->m02 = Do_02_error_bound;
  Do_bound->m03 = Do_03_error_bound;
  Do_bound->m10 = Do_10_error_bound;
  Do_bound->m11 = Do_11_error_bound;
  Do_bound->m12 = Do_12_error_bound;
  Do_bound->m13 = Do_13_error_bound;
  Do_bound->m20 = Do_20_error_bound;
  Do_bound->m21 = Do_21_error_bound;
  Do_bound->m22 = Do_22_error_bound;
  Do_bound->m23 = Do_23_error_bound;
}

/* Do = D [R | 0]; |error of Do| <= Do_bound unless inf or NaN.
   D, Do, Do_bound: displacement [R | t], R rotation, t in m; R: rotation or other 3×3 matrix.
   36 mul, 45 add, 27 abs. */
static inline void ksl_product_ddrf_certified(const ksl_SE3f_t *D, const ksl_mat3x3f_t *R,
    ksl_SE3f_t *Do, ksl_SE3f_t *Do_bound) {
  const float Do_00a = KSL_MULF(D->m00, R->m00), Do_00b = KSL_MULF(D->m01, R->m10),
      Do_00c = Do_00a + Do_00b, Do_00d = KSL_MULF(D->m02, R->m20), Do_00 = Do_00c + Do_00d;
  const float Do_01a = KSL_MULF(D->m00, R->m01), Do_01b = KSL_MULF(D->m01, R->m11),
      Do_01c = Do_01a + Do_01b, Do_01d = KSL_MULF(D->m02, R->m21), Do_01 = Do_01c + Do_01d;
  const float Do_02a = KSL_MULF(D->m00, R->m02), Do_02b = KSL_MULF(D->m01, R->m12),
      Do_02c = Do_02a + Do_02b, Do_02d = KSL_MULF(D->m02, R->m22), Do_02 = Do_02c + Do_02d;
  const float Do_10a = KSL_MULF(D->m10, R->m00), Do_10b = KSL_MULF(D->m11, R->m10),
      Do_10c = Do_10a + Do_10b, Do_10d = KSL_MULF(D->m12, R->m20), Do_10 = Do_10c + Do_10d;
  const float Do_11a = KSL_MULF(D->m10, R->m01), Do_11b = KSL_MULF(D->m11, R->m11),
      Do_11c = Do_11a + Do_11b, Do_11d = KSL_MULF(D->m12, R->m21), Do_11 = Do_11c + Do_11d;
  const float Do_12a = KSL_MULF(D->m10, R->m02), Do_12b = KSL_MULF(D->m11, R->m12),
      Do_12c = Do_12a + Do_12b, Do_12d = KSL_MULF(D->m12, R->m22), Do_12 = Do_12c + Do_12d;
  const float Do_20a = KSL_MULF(D->m20, R->m00), Do_20b = KSL_MULF(D->m21, R->m10),
      Do_20c = Do_20a + Do_20b, Do_20d = KSL_MULF(D->m22, R->m20), Do_20 = Do_20c + Do_20d;
  const float Do_21a = KSL_MULF(D->m20, R->m01), Do_21b = KSL_MULF(D->m21, R->m11),
      Do_21c = Do_21a + Do_21b, Do_21d = KSL_MULF(D->m22, R->m21), Do_21 = Do_21c + Do_21d;
  const float Do_22a = KSL_MULF(D->m20, R->m02), Do_22b = KSL_MULF(D->m21, R->m12),
      Do_22c = Do_22a + Do_22b, Do_22d = KSL_MULF(D->m22, R->m22), Do_22 = Do_22c + Do_22d;
  const float Do_00a_abs = fabsf(Do_00a), Do_00b_abs = fabsf(Do_00b),
      Do_00c_size = Do_00a_abs + Do_00b_abs, Do_00d_abs = fabsf(Do_00d),
      Do_00_size = Do_00c_size + Do_00d_abs;
  const float Do_01a_abs = fabsf(Do_01a), Do_01b_abs = fabsf(Do_01b),
      Do_01c_size = Do_01a_abs + Do_01b_abs, Do_01d_abs = fabsf(Do_01d),
      Do_01_size = Do_01c_size + Do_01d_abs;
  const float Do_02a_abs = fabsf(Do_02a), Do_02b_abs = fabsf(Do_02b),
      Do_02c_size = Do_02a_abs + Do_02b_abs, Do_02d_abs = fabsf(Do_02d),
      Do_02_size = Do_02c_size + Do_02d_abs;
  const float Do_10a_abs = fabsf(Do_10a), Do_10b_abs = fabsf(Do_10b),
      Do_10c_size = Do_10a_abs + Do_10b_abs, Do_10d_abs = fabsf(Do_10d),
      Do_10_size = Do_10c_size + Do_10d_abs;
  const float Do_11a_abs = fabsf(Do_11a), Do_11b_abs = fabsf(Do_11b),
      Do_11c_size = Do_11a_abs + Do_11b_abs, Do_11d_abs = fabsf(Do_11d),
      Do_11_size = Do_11c_size + Do_11d_abs;
  const float Do_12a_abs = fabsf(Do_12a), Do_12b_abs = fabsf(Do_12b),
      Do_12c_size = Do_12a_abs + Do_12b_abs, Do_12d_abs = fabsf(Do_12d),
      Do_12_size = Do_12c_size + Do_12d_abs;
  const float Do_20a_abs = fabsf(Do_20a), Do_20b_abs = fabsf(Do_20b),
      Do_20c_size = Do_20a_abs + Do_20b_abs, Do_20d_abs = fabsf(Do_20d),
      Do_20_size = Do_20c_size + Do_20d_abs;
  const float Do_21a_abs = fabsf(Do_21a), Do_21b_abs = fabsf(Do_21b),
      Do_21c_size = Do_21a_abs + Do_21b_abs, Do_21d_abs = fabsf(Do_21d),
      Do_21_size = Do_21c_size + Do_21d_abs;
  const float Do_22a_abs = fabsf(Do_22a), Do_22b_abs = fabsf(Do_22b),
      Do_22c_size = Do_22a_abs + Do_22b_abs, Do_22d_abs = fabsf(Do_22d),
      Do_22_size = Do_22c_size + Do_22d_abs;
  const float Do_00_padded = Do_00_size + 1.9721523e-31f,
      Do_00_error_bound = KSL_MULF(1.7881396e-07f, Do_00_padded);
  const float Do_01_padded = Do_01_size + 1.9721523e-31f,
      Do_01_error_bound = KSL_MULF(1.7881396e-07f, Do_01_padded);
  const float Do_02_padded = Do_02_size + 1.9721523e-31f,
      Do_02_error_bound = KSL_MULF(1.7881396e-07f, Do_02_padded);
  const float Do_10_padded = Do_10_size + 1.9721523e-31f,
      Do_10_error_bound = KSL_MULF(1.7881396e-07f, Do_10_padded);
  const float Do_11_padded = Do_11_size + 1.9721523e-31f,
      Do_11_error_bound = KSL_MULF(1.7881396e-07f, Do_11_padded);
  const float Do_12_padded = Do_12_size + 1.9721523e-31f,
      Do_12_error_bound = KSL_MULF(1.7881396e-07f, Do_12_padded);
  const float Do_20_padded = Do_20_size + 1.9721523e-31f,
      Do_20_error_bound = KSL_MULF(1.7881396e-07f, Do_20_padded);
  const float Do_21_padded = Do_21_size + 1.9721523e-31f,
      Do_21_error_bound = KSL_MULF(1.7881396e-07f, Do_21_padded);
  const float Do_22_padded = Do_22_size + 1.9721523e-31f,
      Do_22_error_bound = KSL_MULF(1.7881396e-07f, Do_22_padded);
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
  Do_bound->m00 = Do_00_error_bound;
  Do_bound->m01 = Do_01_error_bound;
  Do_bound->m02 = Do_02_error_bound;
  Do_bound->m03 = 0.0f;
  Do_bound->m10 = Do_10_error_bound;
  Do_bound->m11 = Do_11_error_bound;
  Do_bound->m12 = Do_12_error_bound;
  Do_bound->m13 = 0.0f;
  Do_bound->m20 = Do_20_error_bound;
  Do_bound->m21 = Do_21_error_bound;
  Do_bound->m22 = Do_22_error_bound;
  Do_bound->m23 = 0.0f;
}

/* Do = D [R^T | 0]; |error of Do| <= Do_bound unless inf or NaN.
   D, Do, Do_bound: displacement [R | t], R rotation, t in m; R: rotation or other 3×3 matrix.
   36 mul, 45 add, 27 abs. */
static inline void ksl_product_ddrinvf_certified(const ksl_SE3f_t *D, const ksl_mat3x3f_t *R,
    ksl_SE3f_t *Do, ksl_SE3f_t *Do_bound) {
  const float Do_00a = KSL_MULF(D->m00, R->m00), Do_00b = KSL_MULF(D->m01, R->m01),
      Do_00c = Do_00a + Do_00b, Do_00d = KSL_MULF(D->m02, R->m02), Do_00 = Do_00c + Do_00d;
  const float Do_01a = KSL_MULF(D->m00, R->m10), Do_01b = KSL_MULF(D->m01, R->m11),
      Do_01c = Do_01a + Do_01b, Do_01d = KSL_MULF(D->m02, R->m12), Do_01 = Do_01c + Do_01d;
  const float Do_02a = KSL_MULF(D->m00, R->m20), Do_02b = KSL_MULF(D->m01, R->m21),
      Do_02c = Do_02a + Do_02b, Do_02d = KSL_MULF(D->m02, R->m22), Do_02 = Do_02c + Do_02d;
  const float Do_10a = KSL_MULF(D->m10, R->m00), Do_10b = KSL_MULF(D->m11, R->m01),
      Do_10c = Do_10a + Do_10b, Do_10d = KSL_MULF(D->m12, R->m02), Do_10 = Do_10c + Do_10d;
  const float Do_11a = KSL_MULF(D->m10, R->m10), Do_11b = KSL_MULF(D->m11, R->m11),
      Do_11c = Do_11a + Do_11b, Do_11d = KSL_MULF(D->m12, R->m12), Do_11 = Do_11c + Do_11d;
  const float Do_12a = KSL_MULF(D->m10, R->m20), Do_12b = KSL_MULF(D->m11, R->m21),
      Do_12c = Do_12a + Do_12b, Do_12d = KSL_MULF(D->m12, R->m22), Do_12 = Do_12c + Do_12d;
  const float Do_20a = KSL_MULF(D->m20, R->m00), Do_20b = KSL_MULF(D->m21, R->m01),
      Do_20c = Do_20a + Do_20b, Do_20d = KSL_MULF(D->m22, R->m02), Do_20 = Do_20c + Do_20d;
  const float Do_21a = KSL_MULF(D->m20, R->m10), Do_21b = KSL_MULF(D->m21, R->m11),
      Do_21c = Do_21a + Do_21b, Do_21d = KSL_MULF(D->m22, R->m12), Do_21 = Do_21c + Do_21d;
  const float Do_22a = KSL_MULF(D->m20, R->m20), Do_22b = KSL_MULF(D->m21, R->m21),
      Do_22c = Do_22a + Do_22b, Do_22d = KSL_MULF(D->m22, R->m22), Do_22 = Do_22c + Do_22d;
  const float Do_00a_abs = fabsf(Do_00a), Do_00b_abs = fabsf(Do_00b),
      Do_00c_size = Do_00a_abs + Do_00b_abs, Do_00d_abs = fabsf(Do_00d),
      Do_00_size = Do_00c_size + Do_00d_abs;
  const float Do_01a_abs = fabsf(Do_01a), Do_01b_abs = fabsf(Do_01b),
      Do_01c_size = Do_01a_abs + Do_01b_abs, Do_01d_abs = fabsf(Do_01d),
      Do_01_size = Do_01c_size + Do_01d_abs;
  const float Do_02a_abs = fabsf(Do_02a), Do_02b_abs = fabsf(Do_02b),
      Do_02c_size = Do_02a_abs + Do_02b_abs, Do_02d_abs = fabsf(Do_02d),
      Do_02_size = Do_02c_size + Do_02d_abs;
  const float Do_10a_abs = fabsf(Do_10a), Do_10b_abs = fabsf(Do_10b),
      Do_10c_size = Do_10a_abs + Do_10b_abs, Do_10d_abs = fabsf(Do_10d),
      Do_10_size = Do_10c_size + Do_10d_abs;
  const float Do_11a_abs = fabsf(Do_11a), Do_11b_abs = fabsf(Do_11b),
      Do_11c_size = Do_11a_abs + Do_11b_abs, Do_11d_abs = fabsf(Do_11d),
      Do_11_size = Do_11c_size + Do_11d_abs;
  const float Do_12a_abs = fabsf(Do_12a), Do_12b_abs = fabsf(Do_12b),
      Do_12c_size = Do_12a_abs + Do_12b_abs, Do_12d_abs = fabsf(Do_12d),
      Do_12_size = Do_12c_size + Do_12d_abs;
  const float Do_20a_abs = fabsf(Do_20a), Do_20b_abs = fabsf(Do_20b),
      Do_20c_size = Do_20a_abs + Do_20b_abs, Do_20d_abs = fabsf(Do_20d),
      Do_20_size = Do_20c_size + Do_20d_abs;
  const float Do_21a_abs = fabsf(Do_21a), Do_21b_abs = fabsf(Do_21b),
      Do_21c_size = Do_21a_abs + Do_21b_abs, Do_21d_abs = fabsf(Do_21d),
      Do_21_size = Do_21c_size + Do_21d_abs;
  const float Do_22a_abs = fabsf(Do_22a), Do_22b_abs = fabsf(Do_22b),
      Do_22c_size = Do_22a_abs + Do_22b_abs, Do_22d_abs = fabsf(Do_22d),
      Do_22_size = Do_22c_size + Do_22d_abs;
  const float Do_00_padded = Do_00_size + 1.9721523e-31f,
      Do_00_error_bound = KSL_MULF(1.7881396e-07f, Do_00_padded);
  const float Do_01_padded = Do_01_size + 1.9721523e-31f,
      Do_01_error_bound = KSL_MULF(1.7881396e-07f, Do_01_padded);
  const float Do_02_padded = Do_02_size + 1.9721523e-31f,
      Do_02_error_bound = KSL_MULF(1.7881396e-07f, Do_02_padded);
  const float Do_10_padded = Do_10_size + 1.9721523e-31f,
      Do_10_error_bound = KSL_MULF(1.7881396e-07f, Do_10_padded);
  const float Do_11_padded = Do_11_size + 1.9721523e-31f,
      Do_11_error_bound = KSL_MULF(1.7881396e-07f, Do_11_padded);
  const float Do_12_padded = Do_12_size + 1.9721523e-31f,
      Do_12_error_bound = KSL_MULF(1.7881396e-07f, Do_12_padded);
  const float Do_20_padded = Do_20_size + 1.9721523e-31f,
      Do_20_error_bound = KSL_MULF(1.7881396e-07f, Do_20_padded);
  const float Do_21_padded = Do_21_size + 1.9721523e-31f,
      Do_21_error_bound = KSL_MULF(1.7881396e-07f, Do_21_padded);
  const float Do_22_padded = Do_22_size + 1.9721523e-31f,
      Do_22_error_bound = KSL_MULF(1.7881396e-07f, Do_22_padded);
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
  Do_bound->m00 = Do_00_error_bound;
  Do_bound->m01 = Do_01_error_bound;
  Do_bound->m02 = Do_02_error_bound;
  Do_bound->m03 = 0.0f;
  Do_bound->m10 = Do_10_error_bound;
  Do_bound->m11 = Do_11_error_bound;
  Do_bound->m12 = Do_12_error_bound;
  Do_bound->m13 = 0.0f;
  Do_bound->m20 = Do_20_error_bound;
  Do_bound->m21 = Do_21_error_bound;
  Do_bound->m22 = Do_22_error_bound;
  Do_bound->m23 = 0.0f;
}

/* Do = D [I | t]; |error of Do| <= Do_bound unless inf or NaN.
   D, Do, Do_bound: displacement [R | t], R rotation, t in m; t: vector.
   12 mul, 21 add, 12 abs. */
static inline void ksl_product_ddtf_certified(const ksl_SE3f_t *D, const ksl_vec3f_t *t,
    ksl_SE3f_t *Do, ksl_SE3f_t *Do_bound) {
  const float Do_03a = KSL_MULF(D->m00, t->x), Do_03b = KSL_MULF(D->m01, t->y),
      Do_03c = Do_03a + Do_03b, Do_03d = KSL_MULF(D->m02, t->z), Do_03e = Do_03c + Do_03d,
      Do_03 = Do_03e + D->m03;
  const float Do_13a = KSL_MULF(D->m10, t->x), Do_13b = KSL_MULF(D->m11, t->y),
      Do_13c = Do_13a + Do_13b, Do_13d = KSL_MULF(D->m12, t->z), Do_13e = Do_13c + Do_13d,
      Do_13 = Do_13e + D->m13;
  const float Do_23a = KSL_MULF(D->m20, t->x), Do_23b = KSL_MULF(D->m21, t->y),
      Do_23c = Do_23a + Do_23b, Do_23d = KSL_MULF(D->m22, t->z), Do_23e = Do_23c + Do_23d,
      Do_23 = Do_23e + D->m23;
  const float Do_03a_abs = fabsf(Do_03a), Do_03b_abs = fabsf(Do_03b),
      Do_03c_size = Do_03a_abs + Do_03b_abs, Do_03d_abs = fabsf(Do_03d),
      Do_03e_size = Do_03c_size + Do_03d_abs, D_03_abs = fabsf(D->m03),
      Do_03_size = Do_03e_size + D_03_abs;
  const float Do_13a_abs = fabsf(Do_13a), Do_13b_abs = fabsf(Do_13b),
      Do_13c_size = Do_13a_abs + Do_13b_abs, Do_13d_abs = fabsf(Do_13d),
      Do_13e_size = Do_13c_size + Do_13d_abs, D_13_abs = fabsf(D->m13),
      Do_13_size = Do_13e_size + D_13_abs;
  const float Do_23a_abs = fabsf(Do_23a), Do_23b_abs = fabsf(Do_23b),
      Do_23c_size = Do_23a_abs + Do_23b_abs, Do_23d_abs = fabsf(Do_23d),
      Do_23e_size = Do_23c_size + Do_23d_abs, D_23_abs = fabsf(D->m23),
      Do_23_size = Do_23e_size + D_23_abs;
  const float Do_03_padded = Do_03_size + 1.9721523e-31f,
      Do_03_error_bound = KSL_MULF(2.3841864e-07f, Do_03_padded);
  const float Do_13_padded = Do_13_size + 1.9721523e-31f,
      Do_13_error_bound = KSL_MULF(2.3841864e-07f, Do_13_padded);
  const float Do_23_padded = Do_23_size + 1.9721523e-31f,
      Do_23_error_bound = KSL_MULF(2.3841864e-07f, Do_23_padded);
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
  Do_bound->m03 = Do_03_error_bound;
  Do_bound->m10 = 0.0f;
  Do_bound->m11 = 0.0f;
  Do_bound->m12 = 0.0f;
  Do_bound->m13 = Do_13_error_bound;
  Do_bound->m20 = 0.0f;
  Do_bound->m21 = 0.0f;
  Do_bound->m22 = 0.0f;
  Do_bound->m23 = Do_23_error_bound;
}

/* Do = D [I | -t]; |error of Do| <= Do_bound unless inf or NaN.
   D, Do, Do_bound: displacement [R | t], R rotation, t in m; t: vector.
   12 mul, 21 add, 12 abs. */
static inline void ksl_product_ddtinvf_certified(const ksl_SE3f_t *D, const ksl_vec3f_t *t,
    ksl_SE3f_t *Do, ksl_SE3f_t *Do_bound) {
  const float Do_03a = KSL_MULF(D->m00, t->x), Do_03b = KSL_MULF(D->m01, t->y),
      Do_03c = Do_03a + Do_03b, Do_03d = KSL_MULF(D->m02, t->z), Do_03e = Do_03c + Do_03d,
      Do_03 = D->m03 - Do_03e;
  const float Do_13a = KSL_MULF(D->m10, t->x), Do_13b = KSL_MULF(D->m11, t->y),
      Do_13c = Do_13a + Do_13b, Do_13d = KSL_MULF(D->m12, t->z), Do_13e = Do_13c + Do_13d,
      Do_13 = D->m13 - Do_13e;
  const float Do_23a = KSL_MULF(D->m20, t->x), Do_23b = KSL_MULF(D->m21, t->y),
      Do_23c = Do_23a + Do_23b, Do_23d = KSL_MULF(D->m22, t->z), Do_23e = Do_23c + Do_23d,
      Do_23 = D->m23 - Do_23e;
  const float Do_03a_abs = fabsf(Do_03a), Do_03b_abs = fabsf(Do_03b),
      Do_03c_size = Do_03a_abs + Do_03b_abs, Do_03d_abs = fabsf(Do_03d),
      Do_03e_size = Do_03c_size + Do_03d_abs, D_03_abs = fabsf(D->m03),
      Do_03_size = D_03_abs + Do_03e_size;
  const float Do_13a_abs = fabsf(Do_13a), Do_13b_abs = fabsf(Do_13b),
      Do_13c_size = Do_13a_abs + Do_13b_abs, Do_13d_abs = fabsf(Do_13d),
      Do_13e_size = Do_13c_size + Do_13d_abs, D_13_abs = fabsf(D->m13),
      Do_13_size = D_13_abs + Do_13e_size;
  const float Do_23a_abs = fabsf(Do_23a), Do_23b_abs = fabsf(Do_23b),
      Do_23c_size = Do_23a_abs + Do_23b_abs, Do_23d_abs = fabsf(Do_23d),
      Do_23e_size = Do_23c_size + Do_23d_abs, D_23_abs = fabsf(D->m23),
      Do_23_size = D_23_abs + Do_23e_size;
  const float Do_03_padded = Do_03_size + 1.9721523e-31f,
      Do_03_error_bound = KSL_MULF(2.3841864e-07f, Do_03_padded);
  const float Do_13_padded = Do_13_size + 1.9721523e-31f,
      Do_13_error_bound = KSL_MULF(2.3841864e-07f, Do_13_padded);
  const float Do_23_padded = Do_23_size + 1.9721523e-31f,
      Do_23_error_bound = KSL_MULF(2.3841864e-07f, Do_23_padded);
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
  Do_bound->m03 = Do_03_error_bound;
  Do_bound->m10 = 0.0f;
  Do_bound->m11 = 0.0f;
  Do_bound->m12 = 0.0f;
  Do_bound->m13 = Do_13_error_bound;
  Do_bound->m20 = 0.0f;
  Do_bound->m21 = 0.0f;
  Do_bound->m22 = 0.0f;
  Do_bound->m23 = Do_23_error_bound;
}

/* Do = D^-1 [I | t] = [R^T | R^T (t - t_D)]; |error of Do| <= Do_bound unless inf or NaN.
   D, Do, Do_bound: displacement [R | t], R rotation, t in m; t: vector.
   21 mul, 18 add, 12 abs. */
static inline void ksl_product_dinvdtf_certified(const ksl_SE3f_t *D, const ksl_vec3f_t *t,
    ksl_SE3f_t *Do, ksl_SE3f_t *Do_bound) {
  const float p_0 = t->x - D->m03;
  const float p_1 = t->y - D->m13;
  const float p_2 = t->z - D->m23;
  const float Do_03a = KSL_MULF(D->m00, p_0), Do_03b = KSL_MULF(D->m10, p_1),
      Do_03c = Do_03a + Do_03b, Do_03d = KSL_MULF(D->m20, p_2), Do_03 = Do_03c + Do_03d;
  const float Do_13a = KSL_MULF(D->m01, p_0), Do_13b = KSL_MULF(D->m11, p_1),
      Do_13c = Do_13a + Do_13b, Do_13d = KSL_MULF(D->m21, p_2), Do_13 = Do_13c + Do_13d;
  const float Do_23a = KSL_MULF(D->m02, p_0), Do_23b = KSL_MULF(D->m12, p_1),
      Do_23c = Do_23a + Do_23b, Do_23d = KSL_MULF(D->m22, p_2), Do_23 = Do_23c + Do_23d;
  const float D_00_abs = fabsf(D->m00), p_0_abs = fabsf(p_0),
      Do_03a_size = KSL_MULF(D_00_abs, p_0_abs), D_10_abs = fabsf(D->m10), p_1_abs = fabsf(p_1),
      Do_03b_size = KSL_MULF(D_10_abs, p_1_abs), Do_03c_size = Do_03a_size + Do_03b_size,
      D_20_abs = fabsf(D->m20), p_2_abs = fabsf(p_2), Do_03d_size = KSL_MULF(D_20_abs, p_2_abs),
      Do_03_size = Do_03c_size + Do_03d_size;
  const float D_01_abs = fabsf(D->m01), Do_13a_size = KSL_MULF(D_01_abs, p_0_abs),
      D_11_abs = fabsf(D->m11), Do_13b_size = KSL_MULF(D_11_abs, p_1_abs),
      Do_13c_size = Do_13a_size + Do_13b_size, D_21_abs = fabsf(D->m21),
      Do_13d_size = KSL_MULF(D_21_abs, p_2_abs), Do_13_size = Do_13c_size + Do_13d_size;
  const float D_02_abs = fabsf(D->m02), Do_23a_size = KSL_MULF(D_02_abs, p_0_abs),
      D_12_abs = fabsf(D->m12), Do_23b_size = KSL_MULF(D_12_abs, p_1_abs),
      Do_23c_size = Do_23a_size + Do_23b_size, D_22_abs = fabsf(D->m22),
      Do_23d_size = KSL_MULF(D_22_abs, p_2_abs), Do_23_size = Do_23c_size + Do_23d_size;
  const float Do_03_padded = Do_03_size + 1.9721523e-31f,
      Do_03_error_bound = KSL_MULF(2.3841864e-07f, Do_03_padded);
  const float Do_13_padded = Do_13_size + 1.9721523e-31f,
      Do_13_error_bound = KSL_MULF(2.3841864e-07f, Do_13_padded);
  const float Do_23_padded = Do_23_size + 1.9721523e-31f,
      Do_23_error_bound = KSL_MULF(2.3841864e-07f, Do_23_padded);
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
  Do_bound->m03 = Do_03_error_bound;
  Do_bound->m10 = 0.0f;
  Do_bound->m11 = 0.0f;
  Do_bound->m12 = 0.0f;
  Do_bound->m13 = Do_13_error_bound;
  Do_bound->m20 = 0.0f;
  Do_bound->m21 = 0.0f;
  Do_bound->m22 = 0.0f;
  Do_bound->m23 = Do_23_error_bound;
}

/* vo = R (k e_x); |error of vo| <= vo_bound unless inf or NaN.
   R: rotation or other 3×3 matrix; k: number; vo, vo_bound: vector.
   6 mul, 3 add, 3 abs. */
static inline void ksl_product_drvtxf_certified(const ksl_mat3x3f_t *R, const float k,
    ksl_vec3f_t *vo, ksl_vec3f_t *vo_bound) {
  const float vo_0 = KSL_MULF(R->m00, k);
  const float vo_1 = KSL_MULF(R->m10, k);
  const float vo_2 = KSL_MULF(R->m20, k);
  const float vo_0_abs = fabsf(vo_0), vo_0_padded = vo_0_abs + 1.9721523e-31f,
      vo_0_error_bound = KSL_MULF(5.960465e-08f, vo_0_padded);
  const float vo_1_abs = fabsf(vo_1), vo_1_padded = vo_1_abs + 1.9721523e-31f,
      vo_1_error_bound = KSL_MULF(5.960465e-08f, vo_1_padded);
  const float vo_2_abs = fabsf(vo_2), vo_2_padded = vo_2_abs + 1.9721523e-31f,
      vo_2_error_bound = KSL_MULF(5.960465e-08f, vo_2_padded);
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
  vo_bound->x = vo_0_error_bound;
  vo_bound->y = vo_1_error_bound;
  vo_bound->z = vo_2_error_bound;
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
  const float Ro_01a_abs = fabsf(Ro_01a), Ro_01b_abs = fabsf(Ro_01b),
      Ro_01_size = Ro_01a_abs + Ro_01b_abs;
  const float Ro_02a_abs = fabsf(Ro_02a), Ro_02b_abs = fabsf(Ro_02b),
      Ro_02_size = Ro_02a_abs + Ro_02b_abs;
  const float Ro_11a_abs = fabsf(Ro_11a), Ro_11b_abs = fabsf(Ro_11b),
      Ro_11_size = Ro_11a_abs + Ro_11b_abs;
  const float Ro_12a_abs = fabsf(Ro_12a), Ro_12b_abs = fabsf(Ro_12b),
      Ro_12_size = Ro_12a_abs + Ro_12b_abs;
  const float Ro_21a_abs = fabsf(Ro_21a), Ro_21b_abs = fabsf(Ro_21b),
      Ro_21_size = Ro_21a_abs + Ro_21b_abs;
  const float Ro_22a_abs = fabsf(Ro_22a), Ro_22b_abs = fabsf(Ro_22b),
      Ro_22_size = Ro_22a_abs + Ro_22b_abs;
  const float Ro_01_padded = Ro_01_size + 1.9721523e-31f,
      Ro_01_error_bound = KSL_MULF(1.192093e-07f, Ro_01_padded);
  const float Ro_02_padded = Ro_02_size + 1.9721523e-31f,
      Ro_02_error_bound = KSL_MULF(1.192093e-07f, Ro_02_padded);
  const float Ro_11_padded = Ro_11_size + 1.9721523e-31f,
      Ro_11_error_bound = KSL_MULF(1.192093e-07f, Ro_11_padded);
  const float Ro_12_padded = Ro_12_size + 1.9721523e-31f,
      Ro_12_error_bound = KSL_MULF(1.192093e-07f, Ro_12_padded);
  const float Ro_21_padded = Ro_21_size + 1.9721523e-31f,
      Ro_21_error_bound = KSL_MULF(1.192093e-07f, Ro_21_padded);
  const float Ro_22_padded = Ro_22_size + 1.9721523e-31f,
      Ro_22_error_bound = KSL_MULF(1.192093e-07f, Ro_22_padded);
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
  Ro_bound->m01 = Ro_01_error_bound;
  Ro_bound->m02 = Ro_02_error_bound;
  Ro_bound->m10 = 0.0f;
  Ro_bound->m11 = Ro_11_error_bound;
  Ro_bound->m12 = Ro_12_error_bound;
  Ro_bound->m20 = 0.0f;
  Ro_bound->m21 = Ro_21_error_bound;
  Ro_bound->m22 = Ro_22_error_bound;
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
  const float Do_01a_abs = fabsf(Do_01a), Do_01b_abs = fabsf(Do_01b),
      Do_01_size = Do_01a_abs + Do_01b_abs;
  const float Do_02a_abs = fabsf(Do_02a), Do_02b_abs = fabsf(Do_02b),
      Do_02_size = Do_02a_abs + Do_02b_abs;
  const float Do_11a_abs = fabsf(Do_11a), Do_11b_abs = fabsf(Do_11b),
      Do_11_size = Do_11a_abs + Do_11b_abs;
  const float Do_12a_abs = fabsf(Do_12a), Do_12b_abs = fabsf(Do_12b),
      Do_12_size = Do_12a_abs + Do_12b_abs;
  const float Do_21a_abs = fabsf(Do_21a), Do_21b_abs = fabsf(Do_21b),
      Do_21_size = Do_21a_abs + Do_21b_abs;
  const float Do_22a_abs = fabsf(Do_22a), Do_22b_abs = fabsf(Do_22b),
      Do_22_size = Do_22a_abs + Do_22b_abs;
  const float Do_01_padded = Do_01_size + 1.9721523e-31f,
      Do_01_error_bound = KSL_MULF(1.192093e-07f, Do_01_padded);
  const float Do_02_padded = Do_02_size + 1.9721523e-31f,
      Do_02_error_bound = KSL_MULF(1.192093e-07f, Do_02_padded);
  const float Do_11_padded = Do_11_size + 1.9721523e-31f,
      Do_11_error_bound = KSL_MULF(1.192093e-07f, Do_11_padded);
  const float Do_12_padded = Do_12_size + 1.9721523e-31f,
      Do_12_error_bound = KSL_MULF(1.192093e-07f, Do_12_padded);
  const float Do_21_padded = Do_21_size + 1.9721523e-31f,
      Do_21_error_bound = KSL_MULF(1.192093e-07f, Do_21_padded);
  const float Do_22_padded = Do_22_size + 1.9721523e-31f,
      Do_22_error_bound = KSL_MULF(1.192093e-07f, Do_22_padded);
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
  Do_bound->m01 = Do_01_error_bound;
  Do_bound->m02 = Do_02_error_bound;
  Do_bound->m03 = 0.0f;
  Do_bound->m10 = 0.0f;
  Do_bound->m11 = Do_11_error_bound;
  Do_bound->m12 = Do_12_error_bound;
  Do_bound->m13 = 0.0f;
  Do_bound->m20 = 0.0f;
  Do_bound->m21 = Do_21_error_bound;
  Do_bound->m22 = Do_22_error_bound;
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
  const float Do_03a_abs = fabsf(Do_03a), D_03_abs = fabsf(D->m03),
      Do_03_size = Do_03a_abs + D_03_abs;
  const float Do_13a_abs = fabsf(Do_13a), D_13_abs = fabsf(D->m13),
      Do_13_size = Do_13a_abs + D_13_abs;
  const float Do_23a_abs = fabsf(Do_23a), D_23_abs = fabsf(D->m23),
      Do_23_size = Do_23a_abs + D_23_abs;
  const float Do_03_padded = Do_03_size + 1.9721523e-31f,
      Do_03_error_bound = KSL_MULF(1.192093e-07f, Do_03_padded);
  const float Do_13_padded = Do_13_size + 1.9721523e-31f,
      Do_13_error_bound = KSL_MULF(1.192093e-07f, Do_13_padded);
  const float Do_23_padded = Do_23_size + 1.9721523e-31f,
      Do_23_error_bound = KSL_MULF(1.192093e-07f, Do_23_padded);
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
  Do_bound->m03 = Do_03_error_bound;
  Do_bound->m10 = 0.0f;
  Do_bound->m11 = 0.0f;
  Do_bound->m12 = 0.0f;
  Do_bound->m13 = Do_13_error_bound;
  Do_bound->m20 = 0.0f;
  Do_bound->m21 = 0.0f;
  Do_bound->m22 = 0.0f;
  Do_bound->m23 = Do_23_error_bound;
}

/* vo = R (-k e_x); |error of vo| <= vo_bound unless inf or NaN.
   R: rotation or other 3×3 matrix; k: number; vo, vo_bound: vector.
   6 mul, 3 add, 3 neg, 3 abs. */
static inline void ksl_product_drvtxinvf_certified(const ksl_mat3x3f_t *R, const float k,
    ksl_vec3f_t *vo, ksl_vec3f_t *vo_bound) {
  const float vo_0a = KSL_MULF(R->m00, k), vo_0 = -vo_0a;
  const float vo_1a = KSL_MULF(R->m10, k), vo_1 = -vo_1a;
  const float vo_2a = KSL_MULF(R->m20, k), vo_2 = -vo_2a;
  const float vo_0a_abs = fabsf(vo_0a), vo_0a_padded = vo_0a_abs + 1.9721523e-31f,
      vo_0a_error_bound = KSL_MULF(5.960465e-08f, vo_0a_padded);
  const float vo_1a_abs = fabsf(vo_1a), vo_1a_padded = vo_1a_abs + 1.9721523e-31f,
      vo_1a_error_bound = KSL_MULF(5.960465e-08f, vo_1a_padded);
  const float vo_2a_abs = fabsf(vo_2a), vo_2a_padded = vo_2a_abs + 1.9721523e-31f,
      vo_2a_error_bound = KSL_MULF(5.960465e-08f, vo_2a_padded);
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
  vo_bound->x = vo_0a_error_bound;
  vo_bound->y = vo_1a_error_bound;
  vo_bound->z = vo_2a_error_bound;
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
  const float Ro_01a_abs = fabsf(Ro_01a), Ro_01b_abs = fabsf(Ro_01b),
      Ro_01_size = Ro_01a_abs + Ro_01b_abs;
  const float Ro_02a_abs = fabsf(Ro_02a), Ro_02b_abs = fabsf(Ro_02b),
      Ro_02_size = Ro_02a_abs + Ro_02b_abs;
  const float Ro_11a_abs = fabsf(Ro_11a), Ro_11b_abs = fabsf(Ro_11b),
      Ro_11_size = Ro_11a_abs + Ro_11b_abs;
  const float Ro_12a_abs = fabsf(Ro_12a), Ro_12b_abs = fabsf(Ro_12b),
      Ro_12_size = Ro_12a_abs + Ro_12b_abs;
  const float Ro_21a_abs = fabsf(Ro_21a), Ro_21b_abs = fabsf(Ro_21b),
      Ro_21_size = Ro_21a_abs + Ro_21b_abs;
  const float Ro_22a_abs = fabsf(Ro_22a), Ro_22b_abs = fabsf(Ro_22b),
      Ro_22_size = Ro_22a_abs + Ro_22b_abs;
  const float Ro_01_padded = Ro_01_size + 1.9721523e-31f,
      Ro_01_error_bound = KSL_MULF(1.192093e-07f, Ro_01_padded);
  const float Ro_02_padded = Ro_02_size + 1.9721523e-31f,
      Ro_02_error_bound = KSL_MULF(1.192093e-07f, Ro_02_padded);
  const float Ro_11_padded = Ro_11_size + 1.9721523e-31f,
      Ro_11_error_bound = KSL_MULF(1.192093e-07f, Ro_11_padded);
  const float Ro_12_padded = Ro_12_size + 1.9721523e-31f,
      Ro_12_error_bound = KSL_MULF(1.192093e-07f, Ro_12_padded);
  const float Ro_21_padded = Ro_21_size + 1.9721523e-31f,
      Ro_21_error_bound = KSL_MULF(1.192093e-07f, Ro_21_padded);
  const float Ro_22_padded = Ro_22_size + 1.9721523e-31f,
      Ro_22_error_bound = KSL_MULF(1.192093e-07f, Ro_22_padded);
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
  Ro_bound->m01 = Ro_01_error_bound;
  Ro_bound->m02 = Ro_02_error_bound;
  Ro_bound->m10 = 0.0f;
  Ro_bound->m11 = Ro_11_error_bound;
  Ro_bound->m12 = Ro_12_error_bound;
  Ro_bound->m20 = 0.0f;
  Ro_bound->m21 = Ro_21_error_bound;
  Ro_bound->m22 = Ro_22_error_bound;
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
  const float Do_01a_abs = fabsf(Do_01a), Do_01b_abs = fabsf(Do_01b),
      Do_01_size = Do_01a_abs + Do_01b_abs;
  const float Do_02a_abs = fabsf(Do_02a), Do_02b_abs = fabsf(Do_02b),
      Do_02_size = Do_02a_abs + Do_02b_abs;
  const float Do_11a_abs = fabsf(Do_11a), Do_11b_abs = fabsf(Do_11b),
      Do_11_size = Do_11a_abs + Do_11b_abs;
  const float Do_12a_abs = fabsf(Do_12a), Do_12b_abs = fabsf(Do_12b),
      Do_12_size = Do_12a_abs + Do_12b_abs;
  const float Do_21a_abs = fabsf(Do_21a), Do_21b_abs = fabsf(Do_21b),
      Do_21_size = Do_21a_abs + Do_21b_abs;
  const float Do_22a_abs = fabsf(Do_22a), Do_22b_abs = fabsf(Do_22b),
      Do_22_size = Do_22a_abs + Do_22b_abs;
  const float Do_01_padded = Do_01_size + 1.9721523e-31f,
      Do_01_error_bound = KSL_MULF(1.192093e-07f, Do_01_padded);
  const float Do_02_padded = Do_02_size + 1.9721523e-31f,
      Do_02_error_bound = KSL_MULF(1.192093e-07f, Do_02_padded);
  const float Do_11_padded = Do_11_size + 1.9721523e-31f,
      Do_11_error_bound = KSL_MULF(1.192093e-07f, Do_11_padded);
  const float Do_12_padded = Do_12_size + 1.9721523e-31f,
      Do_12_error_bound = KSL_MULF(1.192093e-07f, Do_12_padded);
  const float Do_21_padded = Do_21_size + 1.9721523e-31f,
      Do_21_error_bound = KSL_MULF(1.192093e-07f, Do_21_padded);
  const float Do_22_padded = Do_22_size + 1.9721523e-31f,
      Do_22_error_bound = KSL_MULF(1.192093e-07f, Do_22_padded);
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
  Do_bound->m01 = Do_01_error_bound;
  Do_bound->m02 = Do_02_error_bound;
  Do_bound->m03 = 0.0f;
  Do_bound->m10 = 0.0f;
  Do_bound->m11 = Do_11_error_bound;
  Do_bound->m12 = Do_12_error_bound;
  Do_bound->m13 = 0.0f;
  Do_bound->m20 = 0.0f;
  Do_bound->m21 = Do_21_error_bound;
  Do_bound->m22 = Do_22_error_bound;
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
  const float D_03_abs = fabsf(D->m03), Do_03a_abs = fabsf(Do_03a),
      Do_03_size = D_03_abs + Do_03a_abs;
  const float D_13_abs = fabsf(D->m13), Do_13a_abs = fabsf(Do_13a),
      Do_13_size = D_13_abs + Do_13a_abs;
  const float D_23_abs = fabsf(D->m23), Do_23a_abs = fabsf(Do_23a),
      Do_23_size = D_23_abs + Do_23a_abs;
  const float Do_03_padded = Do_03_size + 1.9721523e-31f,
      Do_03_error_bound = KSL_MULF(1.192093e-07f, Do_03_padded);
  const float Do_13_padded = Do_13_size + 1.9721523e-31f,
      Do_13_error_bound = KSL_MULF(1.192093e-07f, Do_13_padded);
  const float Do_23_padded = Do_23_size + 1.9721523e-31f,
      Do_23_error_bound = KSL_MULF(1.192093e-07f, Do_23_padded);
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
  Do_bound->m03 = Do_03_error_bound;
  Do_bound->m10 = 0.0f;
  Do_bound->m11 = 0.0f;
  Do_bound->m12 = 0.0f;
  Do_bound->m13 = Do_13_error_bound;
  Do_bound->m20 = 0.0f;
  Do_bound->m21 = 0.0f;
  Do_bound->m22 = 0.0f;
  Do_bound->m23 = Do_23_error_bound;
}

/* vo = R (k e_y); |error of vo| <= vo_bound unless inf or NaN.
   R: rotation or other 3×3 matrix; k: number; vo, vo_bound: vector.
   6 mul, 3 add, 3 abs. */
static inline void ksl_product_drvtyf_certified(const ksl_mat3x3f_t *R, const float k,
    ksl_vec3f_t *vo, ksl_vec3f_t *vo_bound) {
  const float vo_0 = KSL_MULF(R->m01, k);
  const float vo_1 = KSL_MULF(R->m11, k);
  const float vo_2 = KSL_MULF(R->m21, k);
  const float vo_0_abs = fabsf(vo_0), vo_0_padded = vo_0_abs + 1.9721523e-31f,
      vo_0_error_bound = KSL_MULF(5.960465e-08f, vo_0_padded);
  const float vo_1_abs = fabsf(vo_1), vo_1_padded = vo_1_abs + 1.9721523e-31f,
      vo_1_error_bound = KSL_MULF(5.960465e-08f, vo_1_padded);
  const float vo_2_abs = fabsf(vo_2), vo_2_padded = vo_2_abs + 1.9721523e-31f,
      vo_2_error_bound = KSL_MULF(5.960465e-08f, vo_2_padded);
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
  vo_bound->x = vo_0_error_bound;
  vo_bound->y = vo_1_error_bound;
  vo_bound->z = vo_2_error_bound;
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
  const float Ro_00a_abs = fabsf(Ro_00a), Ro_00b_abs = fabsf(Ro_00b),
      Ro_00_size = Ro_00a_abs + Ro_00b_abs;
  const float Ro_02a_abs = fabsf(Ro_02a), Ro_02b_abs = fabsf(Ro_02b),
      Ro_02_size = Ro_02a_abs + Ro_02b_abs;
  const float Ro_10a_abs = fabsf(Ro_10a), Ro_10b_abs = fabsf(Ro_10b),
      Ro_10_size = Ro_10a_abs + Ro_10b_abs;
  const float Ro_12a_abs = fabsf(Ro_12a), Ro_12b_abs = fabsf(Ro_12b),
      Ro_12_size = Ro_12a_abs + Ro_12b_abs;
  const float Ro_20a_abs = fabsf(Ro_20a), Ro_20b_abs = fabsf(Ro_20b),
      Ro_20_size = Ro_20a_abs + Ro_20b_abs;
  const float Ro_22a_abs = fabsf(Ro_22a), Ro_22b_abs = fabsf(Ro_22b),
      Ro_22_size = Ro_22a_abs + Ro_22b_abs;
  const float Ro_00_padded = Ro_00_size + 1.9721523e-31f,
      Ro_00_error_bound = KSL_MULF(1.192093e-07f, Ro_00_padded);
  const float Ro_02_padded = Ro_02_size + 1.9721523e-31f,
      Ro_02_error_bound = KSL_MULF(1.192093e-07f, Ro_02_padded);
  const float Ro_10_padded = Ro_10_size + 1.9721523e-31f,
      Ro_10_error_bound = KSL_MULF(1.192093e-07f, Ro_10_padded);
  const float Ro_12_padded = Ro_12_size + 1.9721523e-31f,
      Ro_12_error_bound = KSL_MULF(1.192093e-07f, Ro_12_padded);
  const float Ro_20_padded = Ro_20_size + 1.9721523e-31f,
      Ro_20_error_bound = KSL_MULF(1.192093e-07f, Ro_20_padded);
  const float Ro_22_padded = Ro_22_size + 1.9721523e-31f,
      Ro_22_error_bound = KSL_MULF(1.192093e-07f, Ro_22_padded);
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
  Ro_bound->m00 = Ro_00_error_bound;
  Ro_bound->m01 = 0.0f;
  Ro_bound->m02 = Ro_02_error_bound;
  Ro_bound->m10 = Ro_10_error_bound;
  Ro_bound->m11 = 0.0f;
  Ro_bound->m12 = Ro_12_error_bound;
  Ro_bound->m20 = Ro_20_error_bound;
  Ro_bound->m21 = 0.0f;
  Ro_bound->m22 = Ro_22_error_bound;
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
  const float Do_00a_abs = fabsf(Do_00a), Do_00b_abs = fabsf(Do_00b),
      Do_00_size = Do_00a_abs + Do_00b_abs;
  const float Do_02a_abs = fabsf(Do_02a), Do_02b_abs = fabsf(Do_02b),
      Do_02_size = Do_02a_abs + Do_02b_abs;
  const float Do_10a_abs = fabsf(Do_10a), Do_10b_abs = fabsf(Do_10b),
      Do_10_size = Do_10a_abs + Do_10b_abs;
  const float Do_12a_abs = fabsf(Do_12a), Do_12b_abs = fabsf(Do_12b),
      Do_12_size = Do_12a_abs + Do_12b_abs;
  const float Do_20a_abs = fabsf(Do_20a), Do_20b_abs = fabsf(Do_20b),
      Do_20_size = Do_20a_abs + Do_20b_abs;
  const float Do_22a_abs = fabsf(Do_22a), Do_22b_abs = fabsf(Do_22b),
      Do_22_size = Do_22a_abs + Do_22b_abs;
  const float Do_00_padded = Do_00_size + 1.9721523e-31f,
      Do_00_error_bound = KSL_MULF(1.192093e-07f, Do_00_padded);
  const float Do_02_padded = Do_02_size + 1.9721523e-31f,
      Do_02_error_bound = KSL_MULF(1.192093e-07f, Do_02_padded);
  const float Do_10_padded = Do_10_size + 1.9721523e-31f,
      Do_10_error_bound = KSL_MULF(1.192093e-07f, Do_10_padded);
  const float Do_12_padded = Do_12_size + 1.9721523e-31f,
      Do_12_error_bound = KSL_MULF(1.192093e-07f, Do_12_padded);
  const float Do_20_padded = Do_20_size + 1.9721523e-31f,
      Do_20_error_bound = KSL_MULF(1.192093e-07f, Do_20_padded);
  const float Do_22_padded = Do_22_size + 1.9721523e-31f,
      Do_22_error_bound = KSL_MULF(1.192093e-07f, Do_22_padded);
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
  Do_bound->m00 = Do_00_error_bound;
  Do_bound->m01 = 0.0f;
  Do_bound->m02 = Do_02_error_bound;
  Do_bound->m03 = 0.0f;
  Do_bound->m10 = Do_10_error_bound;
  Do_bound->m11 = 0.0f;
  Do_bound->m12 = Do_12_error_bound;
  Do_bound->m13 = 0.0f;
  Do_bound->m20 = Do_20_error_bound;
  Do_bound->m21 = 0.0f;
  Do_bound->m22 = Do_22_error_bound;
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
  const float Do_03a_abs = fabsf(Do_03a), D_03_abs = fabsf(D->m03),
      Do_03_size = Do_03a_abs + D_03_abs;
  const float Do_13a_abs = fabsf(Do_13a), D_13_abs = fabsf(D->m13),
      Do_13_size = Do_13a_abs + D_13_abs;
  const float Do_23a_abs = fabsf(Do_23a), D_23_abs = fabsf(D->m23),
      Do_23_size = Do_23a_abs + D_23_abs;
  const float Do_03_padded = Do_03_size + 1.9721523e-31f,
      Do_03_error_bound = KSL_MULF(1.192093e-07f, Do_03_padded);
  const float Do_13_padded = Do_13_size + 1.9721523e-31f,
      Do_13_error_bound = KSL_MULF(1.192093e-07f, Do_13_padded);
  const float Do_23_padded = Do_23_size + 1.9721523e-31f,
      Do_23_error_bound = KSL_MULF(1.192093e-07f, Do_23_padded);
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
  Do_bound->m03 = Do_03_error_bound;
  Do_bound->m10 = 0.0f;
  Do_bound->m11 = 0.0f;
  Do_bound->m12 = 0.0f;
  Do_bound->m13 = Do_13_error_bound;
  Do_bound->m20 = 0.0f;
  Do_bound->m21 = 0.0f;
  Do_bound->m22 = 0.0f;
  Do_bound->m23 = Do_23_error_bound;
}

/* vo = R (-k e_y); |error of vo| <= vo_bound unless inf or NaN.
   R: rotation or other 3×3 matrix; k: number; vo, vo_bound: vector.
   6 mul, 3 add, 3 neg, 3 abs. */
static inline void ksl_product_drvtyinvf_certified(const ksl_mat3x3f_t *R, const float k,
    ksl_vec3f_t *vo, ksl_vec3f_t *vo_bound) {
  const float vo_0a = KSL_MULF(R->m01, k), vo_0 = -vo_0a;
  const float vo_1a = KSL_MULF(R->m11, k), vo_1 = -vo_1a;
  const float vo_2a = KSL_MULF(R->m21, k), vo_2 = -vo_2a;
  const float vo_0a_abs = fabsf(vo_0a), vo_0a_padded = vo_0a_abs + 1.9721523e-31f,
      vo_0a_error_bound = KSL_MULF(5.960465e-08f, vo_0a_padded);
  const float vo_1a_abs = fabsf(vo_1a), vo_1a_padded = vo_1a_abs + 1.9721523e-31f,
      vo_1a_error_bound = KSL_MULF(5.960465e-08f, vo_1a_padded);
  const float vo_2a_abs = fabsf(vo_2a), vo_2a_padded = vo_2a_abs + 1.9721523e-31f,
      vo_2a_error_bound = KSL_MULF(5.960465e-08f, vo_2a_padded);
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
  vo_bound->x = vo_0a_error_bound;
  vo_bound->y = vo_1a_error_bound;
  vo_bound->z = vo_2a_error_bound;
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
  const float Ro_00a_abs = fabsf(Ro_00a), Ro_00b_abs = fabsf(Ro_00b),
      Ro_00_size = Ro_00a_abs + Ro_00b_abs;
  const float Ro_02a_abs = fabsf(Ro_02a), Ro_02b_abs = fabsf(Ro_02b),
      Ro_02_size = Ro_02a_abs + Ro_02b_abs;
  const float Ro_10a_abs = fabsf(Ro_10a), Ro_10b_abs = fabsf(Ro_10b),
      Ro_10_size = Ro_10a_abs + Ro_10b_abs;
  const float Ro_12a_abs = fabsf(Ro_12a), Ro_12b_abs = fabsf(Ro_12b),
      Ro_12_size = Ro_12a_abs + Ro_12b_abs;
  const float Ro_20a_abs = fabsf(Ro_20a), Ro_20b_abs = fabsf(Ro_20b),
      Ro_20_size = Ro_20a_abs + Ro_20b_abs;
  const float Ro_22a_abs = fabsf(Ro_22a), Ro_22b_abs = fabsf(Ro_22b),
      Ro_22_size = Ro_22a_abs + Ro_22b_abs;
  const float Ro_00_padded = Ro_00_size + 1.9721523e-31f,
      Ro_00_error_bound = KSL_MULF(1.192093e-07f, Ro_00_padded);
  const float Ro_02_padded = Ro_02_size + 1.9721523e-31f,
      Ro_02_error_bound = KSL_MULF(1.192093e-07f, Ro_02_padded);
  const float Ro_10_padded = Ro_10_size + 1.9721523e-31f,
      Ro_10_error_bound = KSL_MULF(1.192093e-07f, Ro_10_padded);
  const float Ro_12_padded = Ro_12_size + 1.9721523e-31f,
      Ro_12_error_bound = KSL_MULF(1.192093e-07f, Ro_12_padded);
  const float Ro_20_padded = Ro_20_size + 1.9721523e-31f,
      Ro_20_error_bound = KSL_MULF(1.192093e-07f, Ro_20_padded);
  const float Ro_22_padded = Ro_22_size + 1.9721523e-31f,
      Ro_22_error_bound = KSL_MULF(1.192093e-07f, Ro_22_padded);
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
  Ro_bound->m00 = Ro_00_error_bound;
  Ro_bound->m01 = 0.0f;
  Ro_bound->m02 = Ro_02_error_bound;
  Ro_bound->m10 = Ro_10_error_bound;
  Ro_bound->m11 = 0.0f;
  Ro_bound->m12 = Ro_12_error_bound;
  Ro_bound->m20 = Ro_20_error_bound;
  Ro_bound->m21 = 0.0f;
  Ro_bound->m22 = Ro_22_error_bound;
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
  const float Do_00a_abs = fabsf(Do_00a), Do_00b_abs = fabsf(Do_00b),
      Do_00_size = Do_00a_abs + Do_00b_abs;
  const float Do_02a_abs = fabsf(Do_02a), Do_02b_abs = fabsf(Do_02b),
      Do_02_size = Do_02a_abs + Do_02b_abs;
  const float Do_10a_abs = fabsf(Do_10a), Do_10b_abs = fabsf(Do_10b),
      Do_10_size = Do_10a_abs + Do_10b_abs;
  const float Do_12a_abs = fabsf(Do_12a), Do_12b_abs = fabsf(Do_12b),
      Do_12_size = Do_12a_abs + Do_12b_abs;
  const float Do_20a_abs = fabsf(Do_20a), Do_20b_abs = fabsf(Do_20b),
      Do_20_size = Do_20a_abs + Do_20b_abs;
  const float Do_22a_abs = fabsf(Do_22a), Do_22b_abs = fabsf(Do_22b),
      Do_22_size = Do_22a_abs + Do_22b_abs;
  const float Do_00_padded = Do_00_size + 1.9721523e-31f,
      Do_00_error_bound = KSL_MULF(1.192093e-07f, Do_00_padded);
  const float Do_02_padded = Do_02_size + 1.9721523e-31f,
      Do_02_error_bound = KSL_MULF(1.192093e-07f, Do_02_padded);
  const float Do_10_padded = Do_10_size + 1.9721523e-31f,
      Do_10_error_bound = KSL_MULF(1.192093e-07f, Do_10_padded);
  const float Do_12_padded = Do_12_size + 1.9721523e-31f,
      Do_12_error_bound = KSL_MULF(1.192093e-07f, Do_12_padded);
  const float Do_20_padded = Do_20_size + 1.9721523e-31f,
      Do_20_error_bound = KSL_MULF(1.192093e-07f, Do_20_padded);
  const float Do_22_padded = Do_22_size + 1.9721523e-31f,
      Do_22_error_bound = KSL_MULF(1.192093e-07f, Do_22_padded);
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
  Do_bound->m00 = Do_00_error_bound;
  Do_bound->m01 = 0.0f;
  Do_bound->m02 = Do_02_error_bound;
  Do_bound->m03 = 0.0f;
  Do_bound->m10 = Do_10_error_bound;
  Do_bound->m11 = 0.0f;
  Do_bound->m12 = Do_12_error_bound;
  Do_bound->m13 = 0.0f;
  Do_bound->m20 = Do_20_error_bound;
  Do_bound->m21 = 0.0f;
  Do_bound->m22 = Do_22_error_bound;
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
  const float D_03_abs = fabsf(D->m03), Do_03a_abs = fabsf(Do_03a),
      Do_03_size = D_03_abs + Do_03a_abs;
  const float D_13_abs = fabsf(D->m13), Do_13a_abs = fabsf(Do_13a),
      Do_13_size = D_13_abs + Do_13a_abs;
  const float D_23_abs = fabsf(D->m23), Do_23a_abs = fabsf(Do_23a),
      Do_23_size = D_23_abs + Do_23a_abs;
  const float Do_03_padded = Do_03_size + 1.9721523e-31f,
      Do_03_error_bound = KSL_MULF(1.192093e-07f, Do_03_padded);
  const float Do_13_padded = Do_13_size + 1.9721523e-31f,
      Do_13_error_bound = KSL_MULF(1.192093e-07f, Do_13_padded);
  const float Do_23_padded = Do_23_size + 1.9721523e-31f,
      Do_23_error_bound = KSL_MULF(1.192093e-07f, Do_23_padded);
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
  Do_bound->m03 = Do_03_error_bound;
  Do_bound->m10 = 0.0f;
  Do_bound->m11 = 0.0f;
  Do_bound->m12 = 0.0f;
  Do_bound->m13 = Do_13_error_bound;
  Do_bound->m20 = 0.0f;
  Do_bound->m21 = 0.0f;
  Do_bound->m22 = 0.0f;
  Do_bound->m23 = Do_23_error_bound;
}

/* vo = R (k e_z); |error of vo| <= vo_bound unless inf or NaN.
   R: rotation or other 3×3 matrix; k: number; vo, vo_bound: vector.
   6 mul, 3 add, 3 abs. */
static inline void ksl_product_drvtzf_certified(const ksl_mat3x3f_t *R, const float k,
    ksl_vec3f_t *vo, ksl_vec3f_t *vo_bound) {
  const float vo_0 = KSL_MULF(R->m02, k);
  const float vo_1 = KSL_MULF(R->m12, k);
  const float vo_2 = KSL_MULF(R->m22, k);
  const float vo_0_abs = fabsf(vo_0), vo_0_padded = vo_0_abs + 1.9721523e-31f,
      vo_0_error_bound = KSL_MULF(5.960465e-08f, vo_0_padded);
  const float vo_1_abs = fabsf(vo_1), vo_1_padded = vo_1_abs + 1.9721523e-31f,
      vo_1_error_bound = KSL_MULF(5.960465e-08f, vo_1_padded);
  const float vo_2_abs = fabsf(vo_2), vo_2_padded = vo_2_abs + 1.9721523e-31f,
      vo_2_error_bound = KSL_MULF(5.960465e-08f, vo_2_padded);
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
  vo_bound->x = vo_0_error_bound;
  vo_bound->y = vo_1_error_bound;
  vo_bound->z = vo_2_error_bound;
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
  const float Ro_00a_abs = fabsf(Ro_00a), Ro_00b_abs = fabsf(Ro_00b),
      Ro_00_size = Ro_00a_abs + Ro_00b_abs;
  const float Ro_01a_abs = fabsf(Ro_01a), Ro_01b_abs = fabsf(Ro_01b),
      Ro_01_size = Ro_01a_abs + Ro_01b_abs;
  const float Ro_10a_abs = fabsf(Ro_10a), Ro_10b_abs = fabsf(Ro_10b),
      Ro_10_size = Ro_10a_abs + Ro_10b_abs;
  const float Ro_11a_abs = fabsf(Ro_11a), Ro_11b_abs = fabsf(Ro_11b),
      Ro_11_size = Ro_11a_abs + Ro_11b_abs;
  const float Ro_20a_abs = fabsf(Ro_20a), Ro_20b_abs = fabsf(Ro_20b),
      Ro_20_size = Ro_20a_abs + Ro_20b_abs;
  const float Ro_21a_abs = fabsf(Ro_21a), Ro_21b_abs = fabsf(Ro_21b),
      Ro_21_size = Ro_21a_abs + Ro_21b_abs;
  const float Ro_00_padded = Ro_00_size + 1.9721523e-31f,
      Ro_00_error_bound = KSL_MULF(1.192093e-07f, Ro_00_padded);
  const float Ro_01_padded = Ro_01_size + 1.9721523e-31f,
      Ro_01_error_bound = KSL_MULF(1.192093e-07f, Ro_01_padded);
  const float Ro_10_padded = Ro_10_size + 1.9721523e-31f,
      Ro_10_error_bound = KSL_MULF(1.192093e-07f, Ro_10_padded);
  const float Ro_11_padded = Ro_11_size + 1.9721523e-31f,
      Ro_11_error_bound = KSL_MULF(1.192093e-07f, Ro_11_padded);
  const float Ro_20_padded = Ro_20_size + 1.9721523e-31f,
      Ro_20_error_bound = KSL_MULF(1.192093e-07f, Ro_20_padded);
  const float Ro_21_padded = Ro_21_size + 1.9721523e-31f,
      Ro_21_error_bound = KSL_MULF(1.192093e-07f, Ro_21_padded);
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
  Ro_bound->m00 = Ro_00_error_bound;
  Ro_bound->m01 = Ro_01_error_bound;
  Ro_bound->m02 = 0.0f;
  Ro_bound->m10 = Ro_10_error_bound;
  Ro_bound->m11 = Ro_11_error_bound;
  Ro_bound->m12 = 0.0f;
  Ro_bound->m20 = Ro_20_error_bound;
  Ro_bound->m21 = Ro_21_error_bound;
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
  const float Do_00a_abs = fabsf(Do_00a), Do_00b_abs = fabsf(Do_00b),
      Do_00_size = Do_00a_abs + Do_00b_abs;
  const float Do_01a_abs = fabsf(Do_01a), Do_01b_abs = fabsf(Do_01b),
      Do_01_size = Do_01a_abs + Do_01b_abs;
  const float Do_10a_abs = fabsf(Do_10a), Do_10b_abs = fabsf(Do_10b),
      Do_10_size = Do_10a_abs + Do_10b_abs;
  const float Do_11a_abs = fabsf(Do_11a), Do_11b_abs = fabsf(Do_11b),
      Do_11_size = Do_11a_abs + Do_11b_abs;
  const float Do_20a_abs = fabsf(Do_20a), Do_20b_abs = fabsf(Do_20b),
      Do_20_size = Do_20a_abs + Do_20b_abs;
  const float Do_21a_abs = fabsf(Do_21a), Do_21b_abs = fabsf(Do_21b),
      Do_21_size = Do_21a_abs + Do_21b_abs;
  const float Do_00_padded = Do_00_size + 1.9721523e-31f,
      Do_00_error_bound = KSL_MULF(1.192093e-07f, Do_00_padded);
  const float Do_01_padded = Do_01_size + 1.9721523e-31f,
      Do_01_error_bound = KSL_MULF(1.192093e-07f, Do_01_padded);
  const float Do_10_padded = Do_10_size + 1.9721523e-31f,
      Do_10_error_bound = KSL_MULF(1.192093e-07f, Do_10_padded);
  const float Do_11_padded = Do_11_size + 1.9721523e-31f,
      Do_11_error_bound = KSL_MULF(1.192093e-07f, Do_11_padded);
  const float Do_20_padded = Do_20_size + 1.9721523e-31f,
      Do_20_error_bound = KSL_MULF(1.192093e-07f, Do_20_padded);
  const float Do_21_padded = Do_21_size + 1.9721523e-31f,
      Do_21_error_bound = KSL_MULF(1.192093e-07f, Do_21_padded);
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
  Do_bound->m00 = Do_00_error_bound;
  Do_bound->m01 = Do_01_error_bound;
  Do_bound->m02 = 0.0f;
  Do_bound->m03 = 0.0f;
  Do_bound->m10 = Do_10_error_bound;
  Do_bound->m11 = Do_11_error_bound;
  Do_bound->m12 = 0.0f;
  Do_bound->m13 = 0.0f;
  Do_bound->m20 = Do_20_error_bound;
  Do_bound->m21 = Do_21_error_bound;
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
  const float Do_03a_abs = fabsf(Do_03a), D_03_abs = fabsf(D->m03),
      Do_03_size = Do_03a_abs + D_03_abs;
  const float Do_13a_abs = fabsf(Do_13a), D_13_abs = fabsf(D->m13),
      Do_13_size = Do_13a_abs + D_13_abs;
  const float Do_23a_abs = fabsf(Do_23a), D_23_abs = fabsf(D->m23),
      Do_23_size = Do_23a_abs + D_23_abs;
  const float Do_03_padded = Do_03_size + 1.9721523e-31f,
      Do_03_error_bound = KSL_MULF(1.192093e-07f, Do_03_padded);
  const float Do_13_padded = Do_13_size + 1.9721523e-31f,
      Do_13_error_bound = KSL_MULF(1.192093e-07f, Do_13_padded);
  const float Do_23_padded = Do_23_size + 1.9721523e-31f,
      Do_23_error_bound = KSL_MULF(1.192093e-07f, Do_23_padded);
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
  Do_bound->m03 = Do_03_error_bound;
  Do_bound->m10 = 0.0f;
  Do_bound->m11 = 0.0f;
  Do_bound->m12 = 0.0f;
  Do_bound->m13 = Do_13_error_bound;
  Do_bound->m20 = 0.0f;
  Do_bound->m21 = 0.0f;
  Do_bound->m22 = 0.0f;
  Do_bound->m23 = Do_23_error_bound;
}

/* vo = R (-k e_z); |error of vo| <= vo_bound unless inf or NaN.
   R: rotation or other 3×3 matrix; k: number; vo, vo_bound: vector.
   6 mul, 3 add, 3 neg, 3 abs. */
static inline void ksl_product_drvtzinvf_certified(const ksl_mat3x3f_t *R, const float k,
    ksl_vec3f_t *vo, ksl_vec3f_t *vo_bound) {
  const float vo_0a = KSL_MULF(R->m02, k), vo_0 = -vo_0a;
  const float vo_1a = KSL_MULF(R->m12, k), vo_1 = -vo_1a;
  const float vo_2a = KSL_MULF(R->m22, k), vo_2 = -vo_2a;
  const float vo_0a_abs = fabsf(vo_0a), vo_0a_padded = vo_0a_abs + 1.9721523e-31f,
      vo_0a_error_bound = KSL_MULF(5.960465e-08f, vo_0a_padded);
  const float vo_1a_abs = fabsf(vo_1a), vo_1a_padded = vo_1a_abs + 1.9721523e-31f,
      vo_1a_error_bound = KSL_MULF(5.960465e-08f, vo_1a_padded);
  const float vo_2a_abs = fabsf(vo_2a), vo_2a_padded = vo_2a_abs + 1.9721523e-31f,
      vo_2a_error_bound = KSL_MULF(5.960465e-08f, vo_2a_padded);
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
  vo_bound->x = vo_0a_error_bound;
  vo_bound->y = vo_1a_error_bound;
  vo_bound->z = vo_2a_error_bound;
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
  const float Ro_00a_abs = fabsf(Ro_00a), Ro_00b_abs = fabsf(Ro_00b),
      Ro_00_size = Ro_00a_abs + Ro_00b_abs;
  const float Ro_01a_abs = fabsf(Ro_01a), Ro_01b_abs = fabsf(Ro_01b),
      Ro_01_size = Ro_01a_abs + Ro_01b_abs;
  const float Ro_10a_abs = fabsf(Ro_10a), Ro_10b_abs = fabsf(Ro_10b),
      Ro_10_size = Ro_10a_abs + Ro_10b_abs;
  const float Ro_11a_abs = fabsf(Ro_11a), Ro_11b_abs = fabsf(Ro_11b),
      Ro_11_size = Ro_11a_abs + Ro_11b_abs;
  const float Ro_20a_abs = fabsf(Ro_20a), Ro_20b_abs = fabsf(Ro_20b),
      Ro_20_size = Ro_20a_abs + Ro_20b_abs;
  const float Ro_21a_abs = fabsf(Ro_21a), Ro_21b_abs = fabsf(Ro_21b),
      Ro_21_size = Ro_21a_abs + Ro_21b_abs;
  const float Ro_00_padded = Ro_00_size + 1.9721523e-31f,
      Ro_00_error_bound = KSL_MULF(1.192093e-07f, Ro_00_padded);
  const float Ro_01_padded = Ro_01_size + 1.9721523e-31f,
      Ro_01_error_bound = KSL_MULF(1.192093e-07f, Ro_01_padded);
  const float Ro_10_padded = Ro_10_size + 1.9721523e-31f,
      Ro_10_error_bound = KSL_MULF(1.192093e-07f, Ro_10_padded);
  const float Ro_11_padded = Ro_11_size + 1.9721523e-31f,
      Ro_11_error_bound = KSL_MULF(1.192093e-07f, Ro_11_padded);
  const float Ro_20_padded = Ro_20_size + 1.9721523e-31f,
      Ro_20_error_bound = KSL_MULF(1.192093e-07f, Ro_20_padded);
  const float Ro_21_padded = Ro_21_size + 1.9721523e-31f,
      Ro_21_error_bound = KSL_MULF(1.192093e-07f, Ro_21_padded);
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
  Ro_bound->m00 = Ro_00_error_bound;
  Ro_bound->m01 = Ro_01_error_bound;
  Ro_bound->m02 = 0.0f;
  Ro_bound->m10 = Ro_10_error_bound;
  Ro_bound->m11 = Ro_11_error_bound;
  Ro_bound->m12 = 0.0f;
  Ro_bound->m20 = Ro_20_error_bound;
  Ro_bound->m21 = Ro_21_error_bound;
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
  const float Do_00a_abs = fabsf(Do_00a), Do_00b_abs = fabsf(Do_00b),
      Do_00_size = Do_00a_abs + Do_00b_abs;
  const float Do_01a_abs = fabsf(Do_01a), Do_01b_abs = fabsf(Do_01b),
      Do_01_size = Do_01a_abs + Do_01b_abs;
  const float Do_10a_abs = fabsf(Do_10a), Do_10b_abs = fabsf(Do_10b),
      Do_10_size = Do_10a_abs + Do_10b_abs;
  const float Do_11a_abs = fabsf(Do_11a), Do_11b_abs = fabsf(Do_11b),
      Do_11_size = Do_11a_abs + Do_11b_abs;
  const float Do_20a_abs = fabsf(Do_20a), Do_20b_abs = fabsf(Do_20b),
      Do_20_size = Do_20a_abs + Do_20b_abs;
  const float Do_21a_abs = fabsf(Do_21a), Do_21b_abs = fabsf(Do_21b),
      Do_21_size = Do_21a_abs + Do_21b_abs;
  const float Do_00_padded = Do_00_size + 1.9721523e-31f,
      Do_00_error_bound = KSL_MULF(1.192093e-07f, Do_00_padded);
  const float Do_01_padded = Do_01_size + 1.9721523e-31f,
      Do_01_error_bound = KSL_MULF(1.192093e-07f, Do_01_padded);
  const float Do_10_padded = Do_10_size + 1.9721523e-31f,
      Do_10_error_bound = KSL_MULF(1.192093e-07f, Do_10_padded);
  const float Do_11_padded = Do_11_size + 1.9721523e-31f,
      Do_11_error_bound = KSL_MULF(1.192093e-07f, Do_11_padded);
  const float Do_20_padded = Do_20_size + 1.9721523e-31f,
      Do_20_error_bound = KSL_MULF(1.192093e-07f, Do_20_padded);
  const float Do_21_padded = Do_21_size + 1.9721523e-31f,
      Do_21_error_bound = KSL_MULF(1.192093e-07f, Do_21_padded);
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
  Do_bound->m00 = Do_00_error_bound;
  Do_bound->m01 = Do_01_error_bound;
  Do_bound->m02 = 0.0f;
  Do_bound->m03 = 0.0f;
  Do_bound->m10 = Do_10_error_bound;
  Do_bound->m11 = Do_11_error_bound;
  Do_bound->m12 = 0.0f;
  Do_bound->m13 = 0.0f;
  Do_bound->m20 = Do_20_error_bound;
  Do_bound->m21 = Do_21_error_bound;
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
  const float D_03_abs = fabsf(D->m03), Do_03a_abs = fabsf(Do_03a),
      Do_03_size = D_03_abs + Do_03a_abs;
  const float D_13_abs = fabsf(D->m13), Do_13a_abs = fabsf(Do_13a),
      Do_13_size = D_13_abs + Do_13a_abs;
  const float D_23_abs = fabsf(D->m23), Do_23a_abs = fabsf(Do_23a),
      Do_23_size = D_23_abs + Do_23a_abs;
  const float Do_03_padded = Do_03_size + 1.9721523e-31f,
      Do_03_error_bound = KSL_MULF(1.192093e-07f, Do_03_padded);
  const float Do_13_padded = Do_13_size + 1.9721523e-31f,
      Do_13_error_bound = KSL_MULF(1.192093e-07f, Do_13_padded);
  const float Do_23_padded = Do_23_size + 1.9721523e-31f,
      Do_23_error_bound = KSL_MULF(1.192093e-07f, Do_23_padded);
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
  Do_bound->m03 = Do_03_error_bound;
  Do_bound->m10 = 0.0f;
  Do_bound->m11 = 0.0f;
  Do_bound->m12 = 0.0f;
  Do_bound->m13 = Do_13_error_bound;
  Do_bound->m20 = 0.0f;
  Do_bound->m21 = 0.0f;
  Do_bound->m22 = 0.0f;
  Do_bound->m23 = Do_23_error_bound;
}

#endif
