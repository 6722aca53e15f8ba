/* Made by `coscrew generate`; changes are overwritten. */
/* SPDX-License-Identifier: MIT */
/* coscrew 0.2.0.  Copyright (c) 2026 The coscrew authors. */
/* Products between rotations, displacements and vectors.
   Accurate tier: double compensated, single computed in double. */
#ifndef KSL_MATRIX_ACCURATE_H
#define KSL_MATRIX_ACCURATE_H

#include "ksl_exact.h"

/* vo = R v.
   R: rotation or other 3×3 matrix; v, vo: vector.
   9 mul, 33 add, 9 product rest.
   Error <= u |result| + 11 u^2 S, S the sum of the |terms| of the expanded formula; barring
     over- and underflow. */
static inline void ksl_product_drv_accurate(const ksl_mat3x3_t *R, const ksl_vec3_t *v,
    ksl_vec3_t *vo) {
  const double vo_0a = KSL_MUL(R->m00, v->x), vo_0b = KSL_MUL(R->m01, v->y), vo_0c = vo_0a + vo_0b,
      vo_0c_right = vo_0c - vo_0a, vo_0d = KSL_MUL(R->m02, v->z), vo_0 = vo_0c + vo_0d,
      vo_0_right = vo_0 - vo_0c,
      vo_0c_lo = ksl_product_rest(R->m00, v->x, vo_0a, vo_0c - vo_0c_right)
          + ksl_product_rest(R->m01, v->y, vo_0b, vo_0c_right);
  const double vo_1a = KSL_MUL(R->m10, v->x), vo_1b = KSL_MUL(R->m11, v->y), vo_1c = vo_1a + vo_1b,
      vo_1c_right = vo_1c - vo_1a, vo_1d = KSL_MUL(R->m12, v->z), vo_1 = vo_1c + vo_1d,
      vo_1_right = vo_1 - vo_1c,
      vo_1c_lo = ksl_product_rest(R->m10, v->x, vo_1a, vo_1c - vo_1c_right)
          + ksl_product_rest(R->m11, v->y, vo_1b, vo_1c_right);
  const double vo_2a = KSL_MUL(R->m20, v->x), vo_2b = KSL_MUL(R->m21, v->y), vo_2c = vo_2a + vo_2b,
      vo_2c_right = vo_2c - vo_2a, vo_2d = KSL_MUL(R->m22, v->z), vo_2 = vo_2c + vo_2d,
      vo_2_right = vo_2 - vo_2c,
      vo_2c_lo = ksl_product_rest(R->m20, v->x, vo_2a, vo_2c - vo_2c_right)
          + ksl_product_rest(R->m21, v->y, vo_2b, vo_2c_right);
  const double vo_0_rounded = vo_0
          + (vo_0c - (vo_0 - vo_0_right) + ksl_product_rest(R->m02, v->z, vo_0d, vo_0_right)
          + vo_0c_lo),
      vo_1_rounded = vo_1
          + (vo_1c - (vo_1 - vo_1_right) + ksl_product_rest(R->m12, v->z, vo_1d, vo_1_right)
          + vo_1c_lo),
      vo_2_rounded = vo_2
          + (vo_2c - (vo_2 - vo_2_right) + ksl_product_rest(R->m22, v->z, vo_2d, vo_2_right)
          + vo_2c_lo);
  vo->x = vo_0_rounded;
  vo->y = vo_1_rounded;
  vo->z = vo_2_rounded;
}

/* vo = R (-v).
   R: rotation or other 3×3 matrix; v, vo: vector.
   9 mul, 33 add, 9 product rest, 6 neg.
   Error <= u |result| + 11 u^2 S, S the sum of the |terms| of the expanded formula; barring
     over- and underflow. */
static inline void ksl_product_drvinv_accurate(const ksl_mat3x3_t *R, const ksl_vec3_t *v,
    ksl_vec3_t *vo) {
  const double vo_0a = KSL_MUL(R->m00, v->x), vo_0b = KSL_MUL(R->m01, v->y), vo_0c = vo_0a + vo_0b,
      vo_0c_right = vo_0c - vo_0a, vo_0d = KSL_MUL(R->m02, v->z), vo_0e = vo_0c + vo_0d,
      vo_0e_right = vo_0e - vo_0c,
      vo_0c_lo = ksl_product_rest(R->m00, v->x, vo_0a, vo_0c - vo_0c_right)
          + ksl_product_rest(R->m01, v->y, vo_0b, vo_0c_right), vo_0 = -vo_0e;
  const double vo_1a = KSL_MUL(R->m10, v->x), vo_1b = KSL_MUL(R->m11, v->y), vo_1c = vo_1a + vo_1b,
      vo_1c_right = vo_1c - vo_1a, vo_1d = KSL_MUL(R->m12, v->z), vo_1e = vo_1c + vo_1d,
      vo_1e_right = vo_1e - vo_1c,
      vo_1c_lo = ksl_product_rest(R->m10, v->x, vo_1a, vo_1c - vo_1c_right)
          + ksl_product_rest(R->m11, v->y, vo_1b, vo_1c_right), vo_1 = -vo_1e;
  const double vo_2a = KSL_MUL(R->m20, v->x), vo_2b = KSL_MUL(R->m21, v->y), vo_2c = vo_2a + vo_2b,
      vo_2c_right = vo_2c - vo_2a, vo_2d = KSL_MUL(R->m22, v->z), vo_2e = vo_2c + vo_2d,
      vo_2e_right = vo_2e - vo_2c,
      vo_2c_lo = ksl_product_rest(R->m20, v->x, vo_2a, vo_2c - vo_2c_right)
          + ksl_product_rest(R->m21, v->y, vo_2b, vo_2c_right), vo_2 = -vo_2e;
  const double vo_0_rounded = vo_0 +
          -(vo_0c - (vo_0e - vo_0e_right) + ksl_product_rest(R->m02, v->z, vo_0d, vo_0e_right)
          + vo_0c_lo),
      vo_1_rounded = vo_1 +
          -(vo_1c - (vo_1e - vo_1e_right) + ksl_product_rest(R->m12, v->z, vo_1d, vo_1e_right)
          + vo_1c_lo),
      vo_2_rounded = vo_2 +
          -(vo_2c - (vo_2e - vo_2e_right) + ksl_product_rest(R->m22, v->z, vo_2d, vo_2e_right)
          + vo_2c_lo);
  vo->x = vo_0_rounded;
  vo->y = vo_1_rounded;
  vo->z = vo_2_rounded;
}

/* vo = R^T v.
   R: rotation or other 3×3 matrix; v, vo: vector.
   9 mul, 33 add, 9 product rest.
   Error <= u |result| + 11 u^2 S, S the sum of the |terms| of the expanded formula; barring
     over- and underflow. */
static inline void ksl_product_drinvv_accurate(const ksl_mat3x3_t *R, const ksl_vec3_t *v,
    ksl_vec3_t *vo) {
  const double vo_0a = KSL_MUL(R->m00, v->x), vo_0b = KSL_MUL(R->m10, v->y), vo_0c = vo_0a + vo_0b,
      vo_0c_right = vo_0c - vo_0a, vo_0d = KSL_MUL(R->m20, v->z), vo_0 = vo_0c + vo_0d,
      vo_0_right = vo_0 - vo_0c,
      vo_0c_lo = ksl_product_rest(R->m00, v->x, vo_0a, vo_0c - vo_0c_right)
          + ksl_product_rest(R->m10, v->y, vo_0b, vo_0c_right);
  const double vo_1a = KSL_MUL(R->m01, v->x), vo_1b = KSL_MUL(R->m11, v->y), vo_1c = vo_1a + vo_1b,
      vo_1c_right = vo_1c - vo_1a, vo_1d = KSL_MUL(R->m21, v->z), vo_1 = vo_1c + vo_1d,
      vo_1_right = vo_1 - vo_1c,
      vo_1c_lo = ksl_product_rest(R->m01, v->x, vo_1a, vo_1c - vo_1c_right)
          + ksl_product_rest(R->m11, v->y, vo_1b, vo_1c_right);
  const double vo_2a = KSL_MUL(R->m02, v->x), vo_2b = KSL_MUL(R->m12, v->y), vo_2c = vo_2a + vo_2b,
      vo_2c_right = vo_2c - vo_2a, vo_2d = KSL_MUL(R->m22, v->z), vo_2 = vo_2c + vo_2d,
      vo_2_right = vo_2 - vo_2c,
      vo_2c_lo = ksl_product_rest(R->m02, v->x, vo_2a, vo_2c - vo_2c_right)
          + ksl_product_rest(R->m12, v->y, vo_2b, vo_2c_right);
  const double vo_0_rounded = vo_0
          + (vo_0c - (vo_0 - vo_0_right) + ksl_product_rest(R->m20, v->z, vo_0d, vo_0_right)
          + vo_0c_lo),
      vo_1_rounded = vo_1
          + (vo_1c - (vo_1 - vo_1_right) + ksl_product_rest(R->m21, v->z, vo_1d, vo_1_right)
          + vo_1c_lo),
      vo_2_rounded = vo_2
          + (vo_2c - (vo_2 - vo_2_right) + ksl_product_rest(R->m22, v->z, vo_2d, vo_2_right)
          + vo_2c_lo);
  vo->x = vo_0_rounded;
  vo->y = vo_1_rounded;
  vo->z = vo_2_rounded;
}

/* vo = R^T (-v).
   R: rotation or other 3×3 matrix; v, vo: vector.
   9 mul, 33 add, 9 product rest, 6 neg.
   Error <= u |result| + 11 u^2 S, S the sum of the |terms| of the expanded formula; barring
     over- and underflow. */
static inline void ksl_product_drinvvinv_accurate(const ksl_mat3x3_t *R, const ksl_vec3_t *v,
    ksl_vec3_t *vo) {
  const double vo_0a = KSL_MUL(R->m00, v->x), vo_0b = KSL_MUL(R->m10, v->y), vo_0c = vo_0a + vo_0b,
      vo_0c_right = vo_0c - vo_0a, vo_0d = KSL_MUL(R->m20, v->z), vo_0e = vo_0c + vo_0d,
      vo_0e_right = vo_0e - vo_0c,
      vo_0c_lo = ksl_product_rest(R->m00, v->x, vo_0a, vo_0c - vo_0c_right)
          + ksl_product_rest(R->m10, v->y, vo_0b, vo_0c_right), vo_0 = -vo_0e;
  const double vo_1a = KSL_MUL(R->m01, v->x), vo_1b = KSL_MUL(R->m11, v->y), vo_1c = vo_1a + vo_1b,
      vo_1c_right = vo_1c - vo_1a, vo_1d = KSL_MUL(R->m21, v->z), vo_1e = vo_1c + vo_1d,
      vo_1e_right = vo_1e - vo_1c,
      vo_1c_lo = ksl_product_rest(R->m01, v->x, vo_1a, vo_1c - vo_1c_right)
          + ksl_product_rest(R->m11, v->y, vo_1b, vo_1c_right), vo_1 = -vo_1e;
  const double vo_2a = KSL_MUL(R->m02, v->x), vo_2b = KSL_MUL(R->m12, v->y), vo_2c = vo_2a + vo_2b,
      vo_2c_right = vo_2c - vo_2a, vo_2d = KSL_MUL(R->m22, v->z), vo_2e = vo_2c + vo_2d,
      vo_2e_right = vo_2e - vo_2c,
      vo_2c_lo = ksl_product_rest(R->m02, v->x, vo_2a, vo_2c - vo_2c_right)
          + ksl_product_rest(R->m12, v->y, vo_2b, vo_2c_right), vo_2 = -vo_2e;
  const double vo_0_rounded = vo_0 +
          -(vo_0c - (vo_0e - vo_0e_right) + ksl_product_rest(R->m20, v->z, vo_0d, vo_0e_right)
          + vo_0c_lo),
      vo_1_rounded = vo_1 +
          -(vo_1c - (vo_1e - vo_1e_right) + ksl_product_rest(R->m21, v->z, vo_1d, vo_1e_right)
          + vo_1c_lo),
      vo_2_rounded = vo_2 +
          -(vo_2c - (vo_2e - vo_2e_right) + ksl_product_rest(R->m22, v->z, vo_2d, vo_2e_right)
          + vo_2c_lo);
  vo->x = vo_0_rounded;
  vo->y = vo_1_rounded;
  vo->z = vo_2_rounded;
}

/* vo = R v + t.
   D: displacement [R | t], R rotation, t in m; v, vo: vector.
   9 mul, 54 add, 9 product rest.
   Error <= u |result| + 15 u^2 S, S the sum of the |terms| of the expanded formula; barring
     over- and underflow. */
static inline void ksl_product_dv_accurate(const ksl_SE3_t *D, const ksl_vec3_t *v,
    ksl_vec3_t *vo) {
  const double vo_0a = KSL_MUL(D->m00, v->x), vo_0b = KSL_MUL(D->m01, v->y), vo_0c = vo_0a + vo_0b,
      vo_0c_right = vo_0c - vo_0a, vo_0d = KSL_MUL(D->m02, v->z), vo_0e = vo_0c + vo_0d,
      vo_0e_right = vo_0e - vo_0c,
      vo_0c_lo = ksl_product_rest(D->m00, v->x, vo_0a, vo_0c - vo_0c_right)
          + ksl_product_rest(D->m01, v->y, vo_0b, vo_0c_right), vo_0 = vo_0e + D->m03,
      vo_0_right = vo_0 - vo_0e,
      vo_0e_lo = vo_0c - (vo_0e - vo_0e_right) + ksl_product_rest(D->m02, v->z, vo_0d, vo_0e_right)
          + vo_0c_lo;
  const double vo_1a = KSL_MUL(D->m10, v->x), vo_1b = KSL_MUL(D->m11, v->y), vo_1c = vo_1a + vo_1b,
      vo_1c_right = vo_1c - vo_1a, vo_1d = KSL_MUL(D->m12, v->z), vo_1e = vo_1c + vo_1d,
      vo_1e_right = vo_1e - vo_1c,
      vo_1c_lo = ksl_product_rest(D->m10, v->x, vo_1a, vo_1c - vo_1c_right)
          + ksl_product_rest(D->m11, v->y, vo_1b, vo_1c_right), vo_1 = vo_1e + D->m13,
      vo_1_right = vo_1 - vo_1e,
      vo_1e_lo = vo_1c - (vo_1e - vo_1e_right) + ksl_product_rest(D->m12, v->z, vo_1d, vo_1e_right)
          + vo_1c_lo;
  const double vo_2a = KSL_MUL(D->m20, v->x), vo_2b = KSL_MUL(D->m21, v->y), vo_2c = vo_2a + vo_2b,
      vo_2c_right = vo_2c - vo_2a, vo_2d = KSL_MUL(D->m22, v->z), vo_2e = vo_2c + vo_2d,
      vo_2e_right = vo_2e - vo_2c,
      vo_2c_lo = ksl_product_rest(D->m20, v->x, vo_2a, vo_2c - vo_2c_right)
          + ksl_product_rest(D->m21, v->y, vo_2b, vo_2c_right), vo_2 = vo_2e + D->m23,
      vo_2_right = vo_2 - vo_2e,
      vo_2e_lo = vo_2c - (vo_2e - vo_2e_right) + ksl_product_rest(D->m22, v->z, vo_2d, vo_2e_right)
          + vo_2c_lo;
  const double vo_0_rounded = vo_0
          + (vo_0e - (vo_0 - vo_0_right) + (D->m03 - vo_0_right) + vo_0e_lo),
      vo_1_rounded = vo_1 + (vo_1e - (vo_1 - vo_1_right) + (D->m13 - vo_1_right) + vo_1e_lo),
      vo_2_rounded = vo_2 + (vo_2e - (vo_2 - vo_2_right) + (D->m23 - vo_2_right) + vo_2e_lo);
  vo->x = vo_0_rounded;
  vo->y = vo_1_rounded;
  vo->z = vo_2_rounded;
}

/* vo = R^T (v - t).
   D: displacement [R | t], R rotation, t in m; v, vo: vector.
   18 mul, 60 add, 9 product rest.
   Error <= u |result| + 18 u^2 S, S the sum of the |terms| of the expanded formula; barring
     over- and underflow. */
static inline void ksl_product_dinvv_accurate(const ksl_SE3_t *D, const ksl_vec3_t *v,
    ksl_vec3_t *vo) {
  const double p_0 = v->x - D->m03, p_0_right = v->x - p_0,
      p_0_lo = v->x - (p_0 + p_0_right) - (D->m03 - p_0_right);
  const double p_1 = v->y - D->m13, p_1_right = v->y - p_1,
      p_1_lo = v->y - (p_1 + p_1_right) - (D->m13 - p_1_right);
  const double p_2 = v->z - D->m23, p_2_right = v->z - p_2,
      p_2_lo = v->z - (p_2 + p_2_right) - (D->m23 - p_2_right);
  const double vo_0a = KSL_MUL(D->m00, p_0), vo_0b = KSL_MUL(D->m10, p_1), vo_0c = vo_0a + vo_0b,
      vo_0c_right = vo_0c - vo_0a,
      vo_0c_lo1 = ksl_product_rest(D->m00, p_0, vo_0a, vo_0c - vo_0c_right)
          + ksl_product_rest(D->m10, p_1, vo_0b, vo_0c_right), vo_0d = KSL_MUL(D->m20, p_2),
      vo_0 = vo_0c + vo_0d, vo_0_right = vo_0 - vo_0c,
      vo_0_lo2 = vo_0c - (vo_0 - vo_0_right) + ksl_product_rest(D->m20, p_2, vo_0d, vo_0_right)
          + KSL_MUL(D->m20, p_2_lo);
  const double vo_1a = KSL_MUL(D->m01, p_0), vo_1b = KSL_MUL(D->m11, p_1), vo_1c = vo_1a + vo_1b,
      vo_1c_right = vo_1c - vo_1a,
      vo_1c_lo1 = ksl_product_rest(D->m01, p_0, vo_1a, vo_1c - vo_1c_right)
          + ksl_product_rest(D->m11, p_1, vo_1b, vo_1c_right), vo_1d = KSL_MUL(D->m21, p_2),
      vo_1 = vo_1c + vo_1d, vo_1_right = vo_1 - vo_1c,
      vo_1_lo2 = vo_1c - (vo_1 - vo_1_right) + ksl_product_rest(D->m21, p_2, vo_1d, vo_1_right)
          + KSL_MUL(D->m21, p_2_lo);
  const double vo_2a = KSL_MUL(D->m02, p_0), vo_2b = KSL_MUL(D->m12, p_1), vo_2c = vo_2a + vo_2b,
      vo_2c_right = vo_2c - vo_2a,
      vo_2c_lo1 = ksl_product_rest(D->m02, p_0, vo_2a, vo_2c - vo_2c_right)
          + ksl_product_rest(D->m12, p_1, vo_2b, vo_2c_right), vo_2d = KSL_MUL(D->m22, p_2),
      vo_2 = vo_2c + vo_2d, vo_2_right = vo_2 - vo_2c,
      vo_2_lo2 = vo_2c - (vo_2 - vo_2_right) + ksl_product_rest(D->m22, p_2, vo_2d, vo_2_right)
          + KSL_MUL(D->m22, p_2_lo);
  const double vo_0_rounded = vo_0
          + (vo_0_lo2 + (vo_0c_lo1 + (KSL_MUL(D->m00, p_0_lo) + KSL_MUL(D->m10, p_1_lo)))),
      vo_1_rounded = vo_1
          + (vo_1_lo2 + (vo_1c_lo1 + (KSL_MUL(D->m01, p_0_lo) + KSL_MUL(D->m11, p_1_lo)))),
      vo_2_rounded = vo_2
          + (vo_2_lo2 + (vo_2c_lo1 + (KSL_MUL(D->m02, p_0_lo) + KSL_MUL(D->m12, p_1_lo))));
  vo->x = vo_0_rounded;
  vo->y = vo_1_rounded;
  vo->z = vo_2_rounded;
}

/* Ro = R1 R2.
   R1, R2, Ro: rotation or other 3×3 matrix.
   27 mul, 99 add, 27 product rest.
   Error <= u |result| + 11 u^2 S, S the sum of the |terms| of the expanded formula; barring
     over- and underflow. */
static inline void ksl_product_drdr_accurate(const ksl_mat3x3_t *R1, const ksl_mat3x3_t *R2,
    ksl_mat3x3_t *Ro) {
  const double Ro_00a = KSL_MUL(R1->m00, R2->m00), Ro_00b = KSL_MUL(R1->m01, R2->m10),
      Ro_00c = Ro_00a + Ro_00b, Ro_00c_right = Ro_00c - Ro_00a, Ro_00d = KSL_MUL(R1->m02, R2->m20),
      Ro_00 = Ro_00c + Ro_00d, Ro_00_right = Ro_00 - Ro_00c,
      Ro_00c_lo = ksl_product_rest(R1->m00, R2->m00, Ro_00a, Ro_00c - Ro_00c_right)
          + ksl_product_rest(R1->m01, R2->m10, Ro_00b, Ro_00c_right);
  const double Ro_01a = KSL_MUL(R1->m00, R2->m01), Ro_01b = KSL_MUL(R1->m01, R2->m11),
      Ro_01c = Ro_01a + Ro_01b, Ro_01c_right = Ro_01c - Ro_01a, Ro_01d = KSL_MUL(R1->m02, R2->m21),
      Ro_01 = Ro_01c + Ro_01d, Ro_01_right = Ro_01 - Ro_01c,
      Ro_01c_lo = ksl_product_rest(R1->m00, R2->m01, Ro_01a, Ro_01c - Ro_01c_right)
          + ksl_product_rest(R1->m01, R2->m11, Ro_01b, Ro_01c_right);
  const double Ro_02a = KSL_MUL(R1->m00, R2->m02), Ro_02b = KSL_MUL(R1->m01, R2->m12),
      Ro_02c = Ro_02a + Ro_02b, Ro_02c_right = Ro_02c - Ro_02a, Ro_02d = KSL_MUL(R1->m02, R2->m22),
      Ro_02 = Ro_02c + Ro_02d, Ro_02_right = Ro_02 - Ro_02c,
      Ro_02c_lo = ksl_product_rest(R1->m00, R2->m02, Ro_02a, Ro_02c - Ro_02c_right)
          + ksl_product_rest(R1->m01, R2->m12, Ro_02b, Ro_02c_right);
  const double Ro_10a = KSL_MUL(R1->m10, R2->m00), Ro_10b = KSL_MUL(R1->m11, R2->m10),
      Ro_10c = Ro_10a + Ro_10b, Ro_10c_right = Ro_10c - Ro_10a, Ro_10d = KSL_MUL(R1->m12, R2->m20),
      Ro_10 = Ro_10c + Ro_10d, Ro_10_right = Ro_10 - Ro_10c,
      Ro_10c_lo = ksl_product_rest(R1->m10, R2->m00, Ro_10a, Ro_10c - Ro_10c_right)
          + ksl_product_rest(R1->m11, R2->m10, Ro_10b, Ro_10c_right);
  const double Ro_11a = KSL_MUL(R1->m10, R2->m01), Ro_11b = KSL_MUL(R1->m11, R2->m11),
      Ro_11c = Ro_11a + Ro_11b, Ro_11c_right = Ro_11c - Ro_11a, Ro_11d = KSL_MUL(R1->m12, R2->m21),
      Ro_11 = Ro_11c + Ro_11d, Ro_11_right = Ro_11 - Ro_11c,
      Ro_11c_lo = ksl_product_rest(R1->m10, R2->m01, Ro_11a, Ro_11c - Ro_11c_right)
          + ksl_product_rest(R1->m11, R2->m11, Ro_11b, Ro_11c_right);
  const double Ro_12a = KSL_MUL(R1->m10, R2->m02), Ro_12b = KSL_MUL(R1->m11, R2->m12),
      Ro_12c = Ro_12a + Ro_12b, Ro_12c_right = Ro_12c - Ro_12a, Ro_12d = KSL_MUL(R1->m12, R2->m22),
      Ro_12 = Ro_12c + Ro_12d, Ro_12_right = Ro_12 - Ro_12c,
      Ro_12c_lo = ksl_product_rest(R1->m10, R2->m02, Ro_12a, Ro_12c - Ro_12c_right)
          + ksl_product_rest(R1->m11, R2->m12, Ro_12b, Ro_12c_right);
  const double Ro_20a = KSL_MUL(R1->m20, R2->m00), Ro_20b = KSL_MUL(R1->m21, R2->m10),
      Ro_20c = Ro_20a + Ro_20b, Ro_20c_right = Ro_20c - Ro_20a, Ro_20d = KSL_MUL(R1->m22, R2->m20),
      Ro_20 = Ro_20c + Ro_20d, Ro_20_right = Ro_20 - Ro_20c,
      Ro_20c_lo = ksl_product_rest(R1->m20, R2->m00, Ro_20a, Ro_20c - Ro_20c_right)
          + ksl_product_rest(R1->m21, R2->m10, Ro_20b, Ro_20c_right);
  const double Ro_21a = KSL_MUL(R1->m20, R2->m01), Ro_21b = KSL_MUL(R1->m21, R2->m11),
      Ro_21c = Ro_21a + Ro_21b, Ro_21c_right = Ro_21c - Ro_21a, Ro_21d = KSL_MUL(R1->m22, R2->m21),
      Ro_21 = Ro_21c + Ro_21d, Ro_21_right = Ro_21 - Ro_21c,
      Ro_21c_lo = ksl_product_rest(R1->m20, R2->m01, Ro_21a, Ro_21c - Ro_21c_right)
          + ksl_product_rest(R1->m21, R2->m11, Ro_21b, Ro_21c_right);
  const double Ro_22a = KSL_MUL(R1->m20, R2->m02), Ro_22b = KSL_MUL(R1->m21, R2->m12),
      Ro_22c = Ro_22a + Ro_22b, Ro_22c_right = Ro_22c - Ro_22a, Ro_22d = KSL_MUL(R1->m22, R2->m22),
      Ro_22 = Ro_22c + Ro_22d, Ro_22_right = Ro_22 - Ro_22c,
      Ro_22c_lo = ksl_product_rest(R1->m20, R2->m02, Ro_22a, Ro_22c - Ro_22c_right)
          + ksl_product_rest(R1->m21, R2->m12, Ro_22b, Ro_22c_right);
  const double Ro_00_rounded = Ro_00
          + (Ro_00c - (Ro_00 - Ro_00_right)
          + ksl_product_rest(R1->m02, R2->m20, Ro_00d, Ro_00_right) + Ro_00c_lo),
      Ro_01_rounded = Ro_01
          + (Ro_01c - (Ro_01 - Ro_01_right)
          + ksl_product_rest(R1->m02, R2->m21, Ro_01d, Ro_01_right) + Ro_01c_lo),
      Ro_02_rounded = Ro_02
          + (Ro_02c - (Ro_02 - Ro_02_right)
          + ksl_product_rest(R1->m02, R2->m22, Ro_02d, Ro_02_right) + Ro_02c_lo),
      Ro_10_rounded = Ro_10
          + (Ro_10c - (Ro_10 - Ro_10_right)
          + ksl_product_rest(R1->m12, R2->m20, Ro_10d, Ro_10_right) + Ro_10c_lo),
      Ro_11_rounded = Ro_11
          + (Ro_11c - (Ro_11 - Ro_11_right)
          + ksl_product_rest(R1->m12, R2->m21, Ro_11d, Ro_11_right) + Ro_11c_lo),
      Ro_12_rounded = Ro_12
          + (Ro_12c - (Ro_12 - Ro_12_right)
          + ksl_product_rest(R1->m12, R2->m22, Ro_12d, Ro_12_right) + Ro_12c_lo),
      Ro_20_rounded = Ro_20
          + (Ro_20c - (Ro_20 - Ro_20_right)
          + ksl_product_rest(R1->m22, R2->m20, Ro_20d, Ro_20_right) + Ro_20c_lo),
      Ro_21_rounded = Ro_21
          + (Ro_21c - (Ro_21 - Ro_21_right)
          + ksl_product_rest(R1->m22, R2->m21, Ro_21d, Ro_21_right) + Ro_21c_lo),
      Ro_22_rounded = Ro_22
          + (Ro_22c - (Ro_22 - Ro_22_right)
          + ksl_product_rest(R1->m22, R2->m22, Ro_22d, Ro_22_right) + Ro_22c_lo);
  Ro->m00 = Ro_00_rounded;
  Ro->m01 = Ro_01_rounded;
  Ro->m02 = Ro_02_rounded;
  Ro->m10 = Ro_10_rounded;
  Ro->m11 = Ro_11_rounded;
  Ro->m12 = Ro_12_rounded;
  Ro->m20 = Ro_20_rounded;
  Ro->m21 = Ro_21_rounded;
  Ro->m22 = Ro_22_rounded;
}

/* Ro = R1 R2^T.
   R1, R2, Ro: rotation or other 3×3 matrix.
   27 mul, 99 add, 27 product rest.
   Error <= u |result| + 11 u^2 S, S the sum of the |terms| of the expanded formula; barring
     over- and underflow. */
static inline void ksl_product_drdrinv_accurate(const ksl_mat3x3_t *R1, const ksl_mat3x3_t *R2,
    ksl_mat3x3_t *Ro) {
  const double Ro_00a = KSL_MUL(R1->m00, R2->m00), Ro_00b = KSL_MUL(R1->m01, R2->m01),
      Ro_00c = Ro_00a + Ro_00b, Ro_00c_right = Ro_00c - Ro_00a, Ro_00d = KSL_MUL(R1->m02, R2->m02),
      Ro_00 = Ro_00c + Ro_00d, Ro_00_right = Ro_00 - Ro_00c,
      Ro_00c_lo = ksl_product_rest(R1->m00, R2->m00, Ro_00a, Ro_00c - Ro_00c_right)
          + ksl_product_rest(R1->m01, R2->m01, Ro_00b, Ro_00c_right);
  const double Ro_01a = KSL_MUL(R1->m00, R2->m10), Ro_01b = KSL_MUL(R1->m01, R2->m11),
      Ro_01c = Ro_01a + Ro_01b, Ro_01c_right = Ro_01c - Ro_01a, Ro_01d = KSL_MUL(R1->m02, R2->m12),
      Ro_01 = Ro_01c + Ro_01d, Ro_01_right = Ro_01 - Ro_01c,
      Ro_01c_lo = ksl_product_rest(R1->m00, R2->m10, Ro_01a, Ro_01c - Ro_01c_right)
          + ksl_product_rest(R1->m01, R2->m11, Ro_01b, Ro_01c_right);
  const double Ro_02a = KSL_MUL(R1->m00, R2->m20), Ro_02b = KSL_MUL(R1->m01, R2->m21),
      Ro_02c = Ro_02a + Ro_02b, Ro_02c_right = Ro_02c - Ro_02a, Ro_02d = KSL_MUL(R1->m02, R2->m22),
      Ro_02 = Ro_02c + Ro_02d, Ro_02_right = Ro_02 - Ro_02c,
      Ro_02c_lo = ksl_product_rest(R1->m00, R2->m20, Ro_02a, Ro_02c - Ro_02c_right)
          + ksl_product_rest(R1->m01, R2->m21, Ro_02b, Ro_02c_right);
  const double Ro_10a = KSL_MUL(R1->m10, R2->m00), Ro_10b = KSL_MUL(R1->m11, R2->m01),
      Ro_10c = Ro_10a + Ro_10b, Ro_10c_right = Ro_10c - Ro_10a, Ro_10d = KSL_MUL(R1->m12, R2->m02),
      Ro_10 = Ro_10c + Ro_10d, Ro_10_right = Ro_10 - Ro_10c,
      Ro_10c_lo = ksl_product_rest(R1->m10, R2->m00, Ro_10a, Ro_10c - Ro_10c_right)
          + ksl_product_rest(R1->m11, R2->m01, Ro_10b, Ro_10c_right);
  const double Ro_11a = KSL_MUL(R1->m10, R2->m10), Ro_11b = KSL_MUL(R1->m11, R2->m11),
      Ro_11c = Ro_11a + Ro_11b, Ro_11c_right = Ro_11c - Ro_11a, Ro_11d = KSL_MUL(R1->m12, R2->m12),
      Ro_11 = Ro_11c + Ro_11d, Ro_11_right = Ro_11 - Ro_11c,
      Ro_11c_lo = ksl_product_rest(R1->m10, R2->m10, Ro_11a, Ro_11c - Ro_11c_right)
          + ksl_product_rest(R1->m11, R2->m11, Ro_11b, Ro_11c_right);
  const double Ro_12a = KSL_MUL(R1->m10, R2->m20), Ro_12b = KSL_MUL(R1->m11, R2->m21),
      Ro_12c = Ro_12a + Ro_12b, Ro_12c_right = Ro_12c - Ro_12a, Ro_12d = KSL_MUL(R1->m12, R2->m22),
      Ro_12 = Ro_12c + Ro_12d, Ro_12_right = Ro_12 - Ro_12c,
      Ro_12c_lo = ksl_product_rest(R1->m10, R2->m20, Ro_12a, Ro_12c - Ro_12c_right)
          + ksl_product_rest(R1->m11, R2->m21, Ro_12b, Ro_12c_right);
  const double Ro_20a = KSL_MUL(R1->m20, R2->m00), Ro_20b = KSL_MUL(R1->m21, R2->m01),
      Ro_20c = Ro_20a + Ro_20b, Ro_20c_right = Ro_20c - Ro_20a, Ro_20d = KSL_MUL(R1->m22, R2->m02),
      Ro_20 = Ro_20c + Ro_20d, Ro_20_right = Ro_20 - Ro_20c,
      Ro_20c_lo = ksl_product_rest(R1->m20, R2->m00, Ro_20a, Ro_20c - Ro_20c_right)
          + ksl_product_rest(R1->m21, R2->m01, Ro_20b, Ro_20c_right);
  const double Ro_21a = KSL_MUL(R1->m20, R2->m10), Ro_21b = KSL_MUL(R1->m21, R2->m11),
      Ro_21c = Ro_21a + Ro_21b, Ro_21c_right = Ro_21c - Ro_21a, Ro_21d = KSL_MUL(R1->m22, R2->m12),
      Ro_21 = Ro_21c + Ro_21d, Ro_21_right = Ro_21 - Ro_21c,
      Ro_21c_lo = ksl_product_rest(R1->m20, R2->m10, Ro_21a, Ro_21c - Ro_21c_right)
          + ksl_product_rest(R1->m21, R2->m11, Ro_21b, Ro_21c_right);
  const double Ro_22a = KSL_MUL(R1->m20, R2->m20), Ro_22b = KSL_MUL(R1->m21, R2->m21),
      Ro_22c = Ro_22a + Ro_22b, Ro_22c_right = Ro_22c - Ro_22a, Ro_22d = KSL_MUL(R1->m22, R2->m22),
      Ro_22 = Ro_22c + Ro_22d, Ro_22_right = Ro_22 - Ro_22c,
      Ro_22c_lo = ksl_product_rest(R1->m20, R2->m20, Ro_22a, Ro_22c - Ro_22c_right)
          + ksl_product_rest(R1->m21, R2->m21, Ro_22b, Ro_22c_right);
  const double Ro_00_rounded = Ro_00
          + (Ro_00c - (Ro_00 - Ro_00_right)
          + ksl_product_rest(R1->m02, R2->m02, Ro_00d, Ro_00_right) + Ro_00c_lo),
      Ro_01_rounded = Ro_01
          + (Ro_01c - (Ro_01 - Ro_01_right)
          + ksl_product_rest(R1->m02, R2->m12, Ro_01d, Ro_01_right) + Ro_01c_lo),
      Ro_02_rounded = Ro_02
          + (Ro_02c - (Ro_02 - Ro_02_right)
          + ksl_product_rest(R1->m02, R2->m22, Ro_02d, Ro_02_right) + Ro_02c_lo),
      Ro_10_rounded = Ro_10
          + (Ro_10c - (Ro_10 - Ro_10_right)
          + ksl_product_rest(R1->m12, R2->m02, Ro_10d, Ro_10_right) + Ro_10c_lo),
      Ro_11_rounded = Ro_11
          + (Ro_11c - (Ro_11 - Ro_11_right)
          + ksl_product_rest(R1->m12, R2->m12, Ro_11d, Ro_11_right) + Ro_11c_lo),
      Ro_12_rounded = Ro_12
          + (Ro_12c - (Ro_12 - Ro_12_right)
          + ksl_product_rest(R1->m12, R2->m22, Ro_12d, Ro_12_right) + Ro_12c_lo),
      Ro_20_rounded = Ro_20
          + (Ro_20c - (Ro_20 - Ro_20_right)
          + ksl_product_rest(R1->m22, R2->m02, Ro_20d, Ro_20_right) + Ro_20c_lo),
      Ro_21_rounded = Ro_21
          + (Ro_21c - (Ro_21 - Ro_21_right)
          + ksl_product_rest(R1->m22, R2->m12, Ro_21d, Ro_21_right) + Ro_21c_lo),
      Ro_22_rounded = Ro_22
          + (Ro_22c - (Ro_22 - Ro_22_right)
          + ksl_product_rest(R1->m22, R2->m22, Ro_22d, Ro_22_right) + Ro_22c_lo);
  Ro->m00 = Ro_00_rounded;
  Ro->m01 = Ro_01_rounded;
  Ro->m02 = Ro_02_rounded;
  Ro->m10 = Ro_10_rounded;
  Ro->m11 = Ro_11_rounded;
  Ro->m12 = Ro_12_rounded;
  Ro->m20 = Ro_20_rounded;
  Ro->m21 = Ro_21_rounded;
  Ro->m22 = Ro_22_rounded;
}

/* Ro = R1^T R2.
   R1, R2, Ro: rotation or other 3×3 matrix.
   27 mul, 99 add, 27 product rest.
   Error <= u |result| + 11 u^2 S, S the sum of the |terms| of the expanded formula; barring
     over- and underflow. */
static inline void ksl_product_drinvdr_accurate(const ksl_mat3x3_t *R1, const ksl_mat3x3_t *R2,
    ksl_mat3x3_t *Ro) {
  const double Ro_00a = KSL_MUL(R1->m00, R2->m00), Ro_00b = KSL_MUL(R1->m10, R2->m10),
      Ro_00c = Ro_00a + Ro_00b, Ro_00c_right = Ro_00c - Ro_00a, Ro_00d = KSL_MUL(R1->m20, R2->m20),
      Ro_00 = Ro_00c + Ro_00d, Ro_00_right = Ro_00 - Ro_00c,
      Ro_00c_lo = ksl_product_rest(R1->m00, R2->m00, Ro_00a, Ro_00c - Ro_00c_right)
          + ksl_product_rest(R1->m10, R2->m10, Ro_00b, Ro_00c_right);
  const double Ro_01a = KSL_MUL(R1->m00, R2->m01), Ro_01b = KSL_MUL(R1->m10, R2->m11),
      Ro_01c = Ro_01a + Ro_01b, Ro_01c_right = Ro_01c - Ro_01a, Ro_01d = KSL_MUL(R1->m20, R2->m21),
      Ro_01 = Ro_01c + Ro_01d, Ro_01_right = Ro_01 - Ro_01c,
      Ro_01c_lo = ksl_product_rest(R1->m00, R2->m01, Ro_01a, Ro_01c - Ro_01c_right)
          + ksl_product_rest(R1->m10, R2->m11, Ro_01b, Ro_01c_right);
  const double Ro_02a = KSL_MUL(R1->m00, R2->m02), Ro_02b = KSL_MUL(R1->m10, R2->m12),
      Ro_02c = Ro_02a + Ro_02b, Ro_02c_right = Ro_02c - Ro_02a, Ro_02d = KSL_MUL(R1->m20, R2->m22),
      Ro_02 = Ro_02c + Ro_02d, Ro_02_right = Ro_02 - Ro_02c,
      Ro_02c_lo = ksl_product_rest(R1->m00, R2->m02, Ro_02a, Ro_02c - Ro_02c_right)
          + ksl_product_rest(R1->m10, R2->m12, Ro_02b, Ro_02c_right);
  const double Ro_10a = KSL_MUL(R1->m01, R2->m00), Ro_10b = KSL_MUL(R1->m11, R2->m10),
      Ro_10c = Ro_10a + Ro_10b, Ro_10c_right = Ro_10c - Ro_10a, Ro_10d = KSL_MUL(R1->m21, R2->m20),
      Ro_10 = Ro_10c + Ro_10d, Ro_10_right = Ro_10 - Ro_10c,
      Ro_10c_lo = ksl_product_rest(R1->m01, R2->m00, Ro_10a, Ro_10c - Ro_10c_right)
          + ksl_product_rest(R1->m11, R2->m10, Ro_10b, Ro_10c_right);
  const double Ro_11a = KSL_MUL(R1->m01, R2->m01), Ro_11b = KSL_MUL(R1->m11, R2->m11),
      Ro_11c = Ro_11a + Ro_11b, Ro_11c_right = Ro_11c - Ro_11a, Ro_11d = KSL_MUL(R1->m21, R2->m21),
      Ro_11 = Ro_11c + Ro_11d, Ro_11_right = Ro_11 - Ro_11c,
      Ro_11c_lo = ksl_product_rest(R1->m01, R2->m01, Ro_11a, Ro_11c - Ro_11c_right)
          + ksl_product_rest(R1->m11, R2->m11, Ro_11b, Ro_11c_right);
  const double Ro_12a = KSL_MUL(R1->m01, R2->m02), Ro_12b = KSL_MUL(R1->m11, R2->m12),
      Ro_12c = Ro_12a + Ro_12b, Ro_12c_right = Ro_12c - Ro_12a, Ro_12d = KSL_MUL(R1->m21, R2->m22),
      Ro_12 = Ro_12c + Ro_12d, Ro_12_right = Ro_12 - Ro_12c,
      Ro_12c_lo = ksl_product_rest(R1->m01, R2->m02, Ro_12a, Ro_12c - Ro_12c_right)
          + ksl_product_rest(R1->m11, R2->m12, Ro_12b, Ro_12c_right);
  const double Ro_20a = KSL_MUL(R1->m02, R2->m00), Ro_20b = KSL_MUL(R1->m12, R2->m10),
      Ro_20c = Ro_20a + Ro_20b, Ro_20c_right = Ro_20c - Ro_20a, Ro_20d = KSL_MUL(R1->m22, R2->m20),
      Ro_20 = Ro_20c + Ro_20d, Ro_20_right = Ro_20 - Ro_20c,
      Ro_20c_lo = ksl_product_rest(R1->m02, R2->m00, Ro_20a, Ro_20c - Ro_20c_right)
          + ksl_product_rest(R1->m12, R2->m10, Ro_20b, Ro_20c_right);
  const double Ro_21a = KSL_MUL(R1->m02, R2->m01), Ro_21b = KSL_MUL(R1->m12, R2->m11),
      Ro_21c = Ro_21a + Ro_21b, Ro_21c_right = Ro_21c - Ro_21a, Ro_21d = KSL_MUL(R1->m22, R2->m21),
      Ro_21 = Ro_21c + Ro_21d, Ro_21_right = Ro_21 - Ro_21c,
      Ro_21c_lo = ksl_product_rest(R1->m02, R2->m01, Ro_21a, Ro_21c - Ro_21c_right)
          + ksl_product_rest(R1->m12, R2->m11, Ro_21b, Ro_21c_right);
  const double Ro_22a = KSL_MUL(R1->m02, R2->m02), Ro_22b = KSL_MUL(R1->m12, R2->m12),
      Ro_22c = Ro_22a + Ro_22b, Ro_22c_right = Ro_22c - Ro_22a, Ro_22d = KSL_MUL(R1->m22, R2->m22),
      Ro_22 = Ro_22c + Ro_22d, Ro_22_right = Ro_22 - Ro_22c,
      Ro_22c_lo = ksl_product_rest(R1->m02, R2->m02, Ro_22a, Ro_22c - Ro_22c_right)
          + ksl_product_rest(R1->m12, R2->m12, Ro_22b, Ro_22c_right);
  const double Ro_00_rounded = Ro_00
          + (Ro_00c - (Ro_00 - Ro_00_right)
          + ksl_product_rest(R1->m20, R2->m20, Ro_00d, Ro_00_right) + Ro_00c_lo),
      Ro_01_rounded = Ro_01
          + (Ro_01c - (Ro_01 - Ro_01_right)
          + ksl_product_rest(R1->m20, R2->m21, Ro_01d, Ro_01_right) + Ro_01c_lo),
      Ro_02_rounded = Ro_02
          + (Ro_02c - (Ro_02 - Ro_02_right)
          + ksl_product_rest(R1->m20, R2->m22, Ro_02d, Ro_02_right) + Ro_02c_lo),
      Ro_10_rounded = Ro_10
          + (Ro_10c - (Ro_10 - Ro_10_right)
          + ksl_product_rest(R1->m21, R2->m20, Ro_10d, Ro_10_right) + Ro_10c_lo),
      Ro_11_rounded = Ro_11
          + (Ro_11c - (Ro_11 - Ro_11_right)
          + ksl_product_rest(R1->m21, R2->m21, Ro_11d, Ro_11_right) + Ro_11c_lo),
      Ro_12_rounded = Ro_12
          + (Ro_12c - (Ro_12 - Ro_12_right)
          + ksl_product_rest(R1->m21, R2->m22, Ro_12d, Ro_12_right) + Ro_12c_lo),
      Ro_20_rounded = Ro_20
          + (Ro_20c - (Ro_20 - Ro_20_right)
          + ksl_product_rest(R1->m22, R2->m20, Ro_20d, Ro_20_right) + Ro_20c_lo),
      Ro_21_rounded = Ro_21
          + (Ro_21c - (Ro_21 - Ro_21_right)
          + ksl_product_rest(R1->m22, R2->m21, Ro_21d, Ro_21_right) + Ro_21c_lo),
      Ro_22_rounded = Ro_22
          + (Ro_22c - (Ro_22 - Ro_22_right)
          + ksl_product_rest(R1->m22, R2->m22, Ro_22d, Ro_22_right) + Ro_22c_lo);
  Ro->m00 = Ro_00_rounded;
  Ro->m01 = Ro_01_rounded;
  Ro->m02 = Ro_02_rounded;
  Ro->m10 = Ro_10_rounded;
  Ro->m11 = Ro_11_rounded;
  Ro->m12 = Ro_12_rounded;
  Ro->m20 = Ro_20_rounded;
  Ro->m21 = Ro_21_rounded;
  Ro->m22 = Ro_22_rounded;
}

/* Do = D1 D2 = [R1 R2 | R1 t2 + t1].
   D1, D2, Do: displacement [R | t], R rotation, t in m.
   36 mul, 153 add, 36 product rest.
   Error <= u |result| + (R: 11, t: 15) u^2 S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_dd_accurate(const ksl_SE3_t *D1, const ksl_SE3_t *D2,
    ksl_SE3_t *Do) {
  const double Do_00a = KSL_MUL(D1->m00, D2->m00), Do_00b = KSL_MUL(D1->m01, D2->m10),
      Do_00c = Do_00a + Do_00b, Do_00c_right = Do_00c - Do_00a, Do_00d = KSL_MUL(D1->m02, D2->m20),
      Do_00 = Do_00c + Do_00d, Do_00_right = Do_00 - Do_00c,
      Do_00c_lo = ksl_product_rest(D1->m00, D2->m00, Do_00a, Do_00c - Do_00c_right)
          + ksl_product_rest(D1->m01, D2->m10, Do_00b, Do_00c_right);
  const double Do_01a = KSL_MUL(D1->m00, D2->m01), Do_01b = KSL_MUL(D1->m01, D2->m11),
      Do_01c = Do_01a + Do_01b, Do_01c_right = Do_01c - Do_01a, Do_01d = KSL_MUL(D1->m02, D2->m21),
      Do_01 = Do_01c + Do_01d, Do_01_right = Do_01 - Do_01c,
      Do_01c_lo = ksl_product_rest(D1->m00, D2->m01, Do_01a, Do_01c - Do_01c_right)
          + ksl_product_rest(D1->m01, D2->m11, Do_01b, Do_01c_right);
  const double Do_02a = KSL_MUL(D1->m00, D2->m02), Do_02b = KSL_MUL(D1->m01, D2->m12),
      Do_02c = Do_02a + Do_02b, Do_02c_right = Do_02c - Do_02a, Do_02d = KSL_MUL(D1->m02, D2->m22),
      Do_02 = Do_02c + Do_02d, Do_02_right = Do_02 - Do_02c,
      Do_02c_lo = ksl_product_rest(D1->m00, D2->m02, Do_02a, Do_02c - Do_02c_right)
          + ksl_product_rest(D1->m01, D2->m12, Do_02b, Do_02c_right);
  const double Do_03a = KSL_MUL(D1->m00, D2->m03), Do_03b = KSL_MUL(D1->m01, D2->m13),
      Do_03c = Do_03a + Do_03b, Do_03c_right = Do_03c - Do_03a, Do_03d = KSL_MUL(D1->m02, D2->m23),
      Do_03e = Do_03c + Do_03d, Do_03e_right = Do_03e - Do_03c,
      Do_03c_lo = ksl_product_rest(D1->m00, D2->m03, Do_03a, Do_03c - Do_03c_right)
          + ksl_product_rest(D1->m01, D2->m13, Do_03b, Do_03c_right), Do_03 = Do_03e + D1->m03,
      Do_03_right = Do_03 - Do_03e,
      Do_03e_lo = Do_03c - (Do_03e - Do_03e_right)
          + ksl_product_rest(D1->m02, D2->m23, Do_03d, Do_03e_right) + Do_03c_lo;
  const double Do_10a = KSL_MUL(D1->m10, D2->m00), Do_10b = KSL_MUL(D1->m11, D2->m10),
      Do_10c = Do_10a + Do_10b, Do_10c_right = Do_10c - Do_10a, Do_10d = KSL_MUL(D1->m12, D2->m20),
      Do_10 = Do_10c + Do_10d, Do_10_right = Do_10 - Do_10c,
      Do_10c_lo = ksl_product_rest(D1->m10, D2->m00, Do_10a, Do_10c - Do_10c_right)
          + ksl_product_rest(D1->m11, D2->m10, Do_10b, Do_10c_right);
  const double Do_11a = KSL_MUL(D1->m10, D2->m01), Do_11b = KSL_MUL(D1->m11, D2->m11),
      Do_11c = Do_11a + Do_11b, Do_11c_right = Do_11c - Do_11a, Do_11d = KSL_MUL(D1->m12, D2->m21),
      Do_11 = Do_11c + Do_11d, Do_11_right = Do_11 - Do_11c,
      Do_11c_lo = ksl_product_rest(D1->m10, D2->m01, Do_11a, Do_11c - Do_11c_right)
          + ksl_product_rest(D1->m11, D2->m11, Do_11b, Do_11c_right);
  const double Do_12a = KSL_MUL(D1->m10, D2->m02), Do_12b = KSL_MUL(D1->m11, D2->m12),
      Do_12c = Do_12a + Do_12b, Do_12c_right = Do_12c - Do_12a, Do_12d = KSL_MUL(D1->m12, D2->m22),
      Do_12 = Do_12c + Do_12d, Do_12_right = Do_12 - Do_12c,
      Do_12c_lo = ksl_product_rest(D1->m10, D2->m02, Do_12a, Do_12c - Do_12c_right)
          + ksl_product_rest(D1->m11, D2->m12, Do_12b, Do_12c_right);
  const double Do_13a = KSL_MUL(D1->m10, D2->m03), Do_13b = KSL_MUL(D1->m11, D2->m13),
      Do_13c = Do_13a + Do_13b, Do_13c_right = Do_13c - Do_13a, Do_13d = KSL_MUL(D1->m12, D2->m23),
      Do_13e = Do_13c + Do_13d, Do_13e_right = Do_13e - Do_13c,
      Do_13c_lo = ksl_product_rest(D1->m10, D2->m03, Do_13a, Do_13c - Do_13c_right)
          + ksl_product_rest(D1->m11, D2->m13, Do_13b, Do_13c_right), Do_13 = Do_13e + D1->m13,
      Do_13_right = Do_13 - Do_13e,
      Do_13e_lo = Do_13c - (Do_13e - Do_13e_right)
          + ksl_product_rest(D1->m12, D2->m23, Do_13d, Do_13e_right) + Do_13c_lo;
  const double Do_20a = KSL_MUL(D1->m20, D2->m00), Do_20b = KSL_MUL(D1->m21, D2->m10),
      Do_20c = Do_20a + Do_20b, Do_20c_right = Do_20c - Do_20a, Do_20d = KSL_MUL(D1->m22, D2->m20),
      Do_20 = Do_20c + Do_20d, Do_20_right = Do_20 - Do_20c,
      Do_20c_lo = ksl_product_rest(D1->m20, D2->m00, Do_20a, Do_20c - Do_20c_right)
          + ksl_product_rest(D1->m21, D2->m10, Do_20b, Do_20c_right);
  const double Do_21a = KSL_MUL(D1->m20, D2->m01), Do_21b = KSL_MUL(D1->m21, D2->m11),
      Do_21c = Do_21a + Do_21b, Do_21c_right = Do_21c - Do_21a, Do_21d = KSL_MUL(D1->m22, D2->m21),
      Do_21 = Do_21c + Do_21d, Do_21_right = Do_21 - Do_21c,
      Do_21c_lo = ksl_product_rest(D1->m20, D2->m01, Do_21a, Do_21c - Do_21c_right)
          + ksl_product_rest(D1->m21, D2->m11, Do_21b, Do_21c_right);
  const double Do_22a = KSL_MUL(D1->m20, D2->m02), Do_22b = KSL_MUL(D1->m21, D2->m12),
      Do_22c = Do_22a + Do_22b, Do_22c_right = Do_22c - Do_22a, Do_22d = KSL_MUL(D1->m22, D2->m22),
      Do_22 = Do_22c + Do_22d, Do_22_right = Do_22 - Do_22c,
      Do_22c_lo = ksl_product_rest(D1->m20, D2->m02, Do_22a, Do_22c - Do_22c_right)
          + ksl_product_rest(D1->m21, D2->m12, Do_22b, Do_22c_right);
  const double Do_23a = KSL_MUL(D1->m20, D2->m03), Do_23b = KSL_MUL(D1->m21, D2->m13),
      Do_23c = Do_23a + Do_23b, Do_23c_right = Do_23c - Do_23a, Do_23d = KSL_MUL(D1->m22, D2->m23),
      Do_23e = Do_23c + Do_23d, Do_23e_right = Do_23e - Do_23c,
      Do_23c_lo = ksl_product_rest(D1->m20, D2->m03, Do_23a, Do_23c - Do_23c_right)
          + ksl_product_rest(D1->m21, D2->m13, Do_23b, Do_23c_right), Do_23 = Do_23e + D1->m23,
      Do_23_right = Do_23 - Do_23e,
      Do_23e_lo = Do_23c - (Do_23e - Do_23e_right)
          + ksl_product_rest(D1->m22, D2->m23, Do_23d, Do_23e_right) + Do_23c_lo;
  const double Do_00_rounded = Do_00
          + (Do_00c - (Do_00 - Do_00_right)
          + ksl_product_rest(D1->m02, D2->m20, Do_00d, Do_00_right) + Do_00c_lo),
      Do_01_rounded = Do_01
          + (Do_01c - (Do_01 - Do_01_right)
          + ksl_product_rest(D1->m02, D2->m21, Do_01d, Do_01_right) + Do_01c_lo),
      Do_02_rounded = Do_02
          + (Do_02c - (Do_02 - Do_02_right)
          + ksl_product_rest(D1->m02, D2->m22, Do_02d, Do_02_right) + Do_02c_lo),
      Do_03_rounded = Do_03
          + (Do_03e - (Do_03 - Do_03_right) + (D1->m03 - Do_03_right) + Do_03e_lo),
      Do_10_rounded = Do_10
          + (Do_10c - (Do_10 - Do_10_right)
          + ksl_product_rest(D1->m12, D2->m20, Do_10d, Do_10_right) + Do_10c_lo),
      Do_11_rounded = Do_11
          + (Do_11c - (Do_11 - Do_11_right)
          + ksl_product_rest(D1->m12, D2->m21, Do_11d, Do_11_right) + Do_11c_lo),
      Do_12_rounded = Do_12
          + (Do_12c - (Do_12 - Do_12_right)
          + ksl_product_rest(D1->m12, D2->m22, Do_12d, Do_12_right) + Do_12c_lo),
      Do_13_rounded = Do_13
          + (Do_13e - (Do_13 - Do_13_right) + (D1->m13 - Do_13_right) + Do_13e_lo),
      Do_20_rounded = Do_20
          + (Do_20c - (Do_20 - Do_20_right)
          + ksl_product_rest(D1->m22, D2->m20, Do_20d, Do_20_right) + Do_20c_lo),
      Do_21_rounded = Do_21
          + (Do_21c - (Do_21 - Do_21_right)
          + ksl_product_rest(D1->m22, D2->m21, Do_21d, Do_21_right) + Do_21c_lo),
      Do_22_rounded = Do_22
          + (Do_22c - (Do_22 - Do_22_right)
          + ksl_product_rest(D1->m22, D2->m22, Do_22d, Do_22_right) + Do_22c_lo),
      Do_23_rounded = Do_23
          + (Do_23e - (Do_23 - Do_23_right) + (D1->m23 - Do_23_right) + Do_23e_lo);
  Do->m00 = Do_00_rounded;
  Do->m01 = Do_01_rounded;
  Do->m02 = Do_02_rounded;
  Do->m03 = Do_03_rounded;
  Do->m10 = Do_10_rounded;
  Do->m11 = Do_11_rounded;
  Do->m12 = Do_12_rounded;
  Do->m13 = Do_13_rounded;
  Do->m20 = Do_20_rounded;
  Do->m21 = Do_21_rounded;
  Do->m22 = Do_22_rounded;
  Do->m23 = Do_23_rounded;
}

/* Do = D1 D2^-1 = [R | t1 - R t2], R = R1 R2^T.
   D1, D2, Do: displacement [R | t], R rotation, t in m.
   45 mul, 162 add, 36 product rest.
   Error <= u |result| + (R: 11, t: 44) u^2 S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_ddinv_accurate(const ksl_SE3_t *D1, const ksl_SE3_t *D2,
    ksl_SE3_t *Do) {
  const double R_0a = KSL_MUL(D1->m00, D2->m00), R_0b = KSL_MUL(D1->m01, D2->m01),
      R_0c = R_0a + R_0b, R_0c_right = R_0c - R_0a, R_0d = KSL_MUL(D1->m02, D2->m02),
      R_0 = R_0c + R_0d, R_0_right = R_0 - R_0c,
      R_0c_lo = ksl_product_rest(D1->m00, D2->m00, R_0a, R_0c - R_0c_right)
          + ksl_product_rest(D1->m01, D2->m01, R_0b, R_0c_right),
      R_0_lo = R_0c - (R_0 - R_0_right) + ksl_product_rest(D1->m02, D2->m02, R_0d, R_0_right)
          + R_0c_lo;
  const double R_1a = KSL_MUL(D1->m00, D2->m10), R_1b = KSL_MUL(D1->m01, D2->m11),
      R_1c = R_1a + R_1b, R_1c_right = R_1c - R_1a, R_1d = KSL_MUL(D1->m02, D2->m12),
      R_1 = R_1c + R_1d, R_1_right = R_1 - R_1c,
      R_1c_lo = ksl_product_rest(D1->m00, D2->m10, R_1a, R_1c - R_1c_right)
          + ksl_product_rest(D1->m01, D2->m11, R_1b, R_1c_right),
      R_1_lo = R_1c - (R_1 - R_1_right) + ksl_product_rest(D1->m02, D2->m12, R_1d, R_1_right)
          + R_1c_lo;
  const double R_2a = KSL_MUL(D1->m00, D2->m20), R_2b = KSL_MUL(D1->m01, D2->m21),
      R_2c = R_2a + R_2b, R_2c_right = R_2c - R_2a, R_2d = KSL_MUL(D1->m02, D2->m22),
      R_2 = R_2c + R_2d, R_2_right = R_2 - R_2c,
      R_2c_lo = ksl_product_rest(D1->m00, D2->m20, R_2a, R_2c - R_2c_right)
          + ksl_product_rest(D1->m01, D2->m21, R_2b, R_2c_right),
      R_2_lo = R_2c - (R_2 - R_2_right) + ksl_product_rest(D1->m02, D2->m22, R_2d, R_2_right)
          + R_2c_lo;
  const double R_3a = KSL_MUL(D1->m10, D2->m00), R_3b = KSL_MUL(D1->m11, D2->m01),
      R_3c = R_3a + R_3b, R_3c_right = R_3c - R_3a, R_3d = KSL_MUL(D1->m12, D2->m02),
      R_3 = R_3c + R_3d, R_3_right = R_3 - R_3c,
      R_3c_lo = ksl_product_rest(D1->m10, D2->m00, R_3a, R_3c - R_3c_right)
          + ksl_product_rest(D1->m11, D2->m01, R_3b, R_3c_right),
      R_3_lo = R_3c - (R_3 - R_3_right) + ksl_product_rest(D1->m12, D2->m02, R_3d, R_3_right)
          + R_3c_lo;
  const double R_4a = KSL_MUL(D1->m10, D2->m10), R_4b = KSL_MUL(D1->m11, D2->m11),
      R_4c = R_4a + R_4b, R_4c_right = R_4c - R_4a, R_4d = KSL_MUL(D1->m12, D2->m12),
      R_4 = R_4c + R_4d, R_4_right = R_4 - R_4c,
      R_4c_lo = ksl_product_rest(D1->m10, D2->m10, R_4a, R_4c - R_4c_right)
          + ksl_product_rest(D1->m11, D2->m11, R_4b, R_4c_right),
      R_4_lo = R_4c - (R_4 - R_4_right) + ksl_product_rest(D1->m12, D2->m12, R_4d, R_4_right)
          + R_4c_lo;
  const double R_5a = KSL_MUL(D1->m10, D2->m20), R_5b = KSL_MUL(D1->m11, D2->m21),
      R_5c = R_5a + R_5b, R_5c_right = R_5c - R_5a, R_5d = KSL_MUL(D1->m12, D2->m22),
      R_5 = R_5c + R_5d, R_5_right = R_5 - R_5c,
      R_5c_lo = ksl_product_rest(D1->m10, D2->m20, R_5a, R_5c - R_5c_right)
          + ksl_product_rest(D1->m11, D2->m21, R_5b, R_5c_right),
      R_5_lo = R_5c - (R_5 - R_5_right) + ksl_product_rest(D1->m12, D2->m22, R_5d, R_5_right)
          + R_5c_lo;
  const double R_6a = KSL_MUL(D1->m20, D2->m00), R_6b = KSL_MUL(D1->m21, D2->m01),
      R_6c = R_6a + R_6b, R_6c_right = R_6c - R_6a, R_6d = KSL_MUL(D1->m22, D2->m02),
      R_6 = R_6c + R_6d, R_6_right = R_6 - R_6c,
      R_6c_lo = ksl_product_rest(D1->m20, D2->m00, R_6a, R_6c - R_6c_right)
          + ksl_product_rest(D1->m21, D2->m01, R_6b, R_6c_right),
      R_6_lo = R_6c - (R_6 - R_6_right) + ksl_product_rest(D1->m22, D2->m02, R_6d, R_6_right)
          + R_6c_lo;
  const double R_7a = KSL_MUL(D1->m20, D2->m10), R_7b = KSL_MUL(D1->m21, D2->m11),
      R_7c = R_7a + R_7b, R_7c_right = R_7c - R_7a, R_7d = KSL_MUL(D1->m22, D2->m12),
      R_7 = R_7c + R_7d, R_7_right = R_7 - R_7c,
      R_7c_lo = ksl_product_rest(D1->m20, D2->m10, R_7a, R_7c - R_7c_right)
          + ksl_product_rest(D1->m21, D2->m11, R_7b, R_7c_right),
      R_7_lo = R_7c - (R_7 - R_7_right) + ksl_product_rest(D1->m22, D2->m12, R_7d, R_7_right)
          + R_7c_lo;
  const double R_8a = KSL_MUL(D1->m20, D2->m20), R_8b = KSL_MUL(D1->m21, D2->m21),
      R_8c = R_8a + R_8b, R_8c_right = R_8c - R_8a, R_8d = KSL_MUL(D1->m22, D2->m22),
      R_8 = R_8c + R_8d, R_8_right = R_8 - R_8c,
      R_8c_lo = ksl_product_rest(D1->m20, D2->m20, R_8a, R_8c - R_8c_right)
          + ksl_product_rest(D1->m21, D2->m21, R_8b, R_8c_right),
      R_8_lo = R_8c - (R_8 - R_8_right) + ksl_product_rest(D1->m22, D2->m22, R_8d, R_8_right)
          + R_8c_lo;
  const double Do_03a = KSL_MUL(D2->m03, R_0), Do_03b = KSL_MUL(D2->m13, R_1),
      Do_03c = Do_03a + Do_03b, Do_03c_right = Do_03c - Do_03a,
      Do_03c_lo1 = ksl_product_rest(D2->m03, R_0, Do_03a, Do_03c - Do_03c_right)
          + ksl_product_rest(D2->m13, R_1, Do_03b, Do_03c_right), Do_03d = KSL_MUL(D2->m23, R_2),
      Do_03e = Do_03c + Do_03d, Do_03e_right = Do_03e - Do_03c,
      Do_03e_lo2 = Do_03c - (Do_03e - Do_03e_right)
          + ksl_product_rest(D2->m23, R_2, Do_03d, Do_03e_right) + KSL_MUL(D2->m23, R_2_lo),
      Do_03 = D1->m03 - Do_03e, Do_03_right = D1->m03 - Do_03,
      Do_03e_lo = Do_03e_lo2 + (Do_03c_lo1 + (KSL_MUL(D2->m03, R_0_lo) + KSL_MUL(D2->m13, R_1_lo)));
  const double Do_13a = KSL_MUL(D2->m03, R_3), Do_13b = KSL_MUL(D2->m13, R_4),
      Do_13c = Do_13a + Do_13b, Do_13c_right = Do_13c - Do_13a,
      Do_13c_lo1 = ksl_product_rest(D2->m03, R_3, Do_13a, Do_13c - Do_13c_right)
          + ksl_product_rest(D2->m13, R_4, Do_13b, Do_13c_right), Do_13d = KSL_MUL(D2->m23, R_5),
      Do_13e = Do_13c + Do_13d, Do_13e_right = Do_13e - Do_13c,
      Do_13e_lo2 = Do_13c - (Do_13e - Do_13e_right)
          + ksl_product_rest(D2->m23, R_5, Do_13d, Do_13e_right) + KSL_MUL(D2->m23, R_5_lo),
      Do_13 = D1->m13 - Do_13e, Do_13_right = D1->m13 - Do_13,
      Do_13e_lo = Do_13e_lo2 + (Do_13c_lo1 + (KSL_MUL(D2->m03, R_3_lo) + KSL_MUL(D2->m13, R_4_lo)));
  const double Do_23a = KSL_MUL(D2->m03, R_6), Do_23b = KSL_MUL(D2->m13, R_7),
      Do_23c = Do_23a + Do_23b, Do_23c_right = Do_23c - Do_23a,
      Do_23c_lo1 = ksl_product_rest(D2->m03, R_6, Do_23a, Do_23c - Do_23c_right)
          + ksl_product_rest(D2->m13, R_7, Do_23b, Do_23c_right), Do_23d = KSL_MUL(D2->m23, R_8),
      Do_23e = Do_23c + Do_23d, Do_23e_right = Do_23e - Do_23c,
      Do_23e_lo2 = Do_23c - (Do_23e - Do_23e_right)
          + ksl_product_rest(D2->m23, R_8, Do_23d, Do_23e_right) + KSL_MUL(D2->m23, R_8_lo),
      Do_23 = D1->m23 - Do_23e, Do_23_right = D1->m23 - Do_23,
      Do_23e_lo = Do_23e_lo2 + (Do_23c_lo1 + (KSL_MUL(D2->m03, R_6_lo) + KSL_MUL(D2->m13, R_7_lo)));
  const double R_0_rounded = R_0 + R_0_lo, R_1_rounded = R_1 + R_1_lo, R_2_rounded = R_2 + R_2_lo;
  const double Do_03_rounded = Do_03
          + (D1->m03 - (Do_03 + Do_03_right) - (Do_03e - Do_03_right) - Do_03e_lo);
  const double R_3_rounded = R_3 + R_3_lo, R_4_rounded = R_4 + R_4_lo, R_5_rounded = R_5 + R_5_lo;
  const double Do_13_rounded = Do_13
          + (D1->m13 - (Do_13 + Do_13_right) - (Do_13e - Do_13_right) - Do_13e_lo);
  const double R_6_rounded = R_6 + R_6_lo, R_7_rounded = R_7 + R_7_lo, R_8_rounded = R_8 + R_8_lo;
  const double Do_23_rounded = Do_23
          + (D1->m23 - (Do_23 + Do_23_right) - (Do_23e - Do_23_right) - Do_23e_lo);
  Do->m00 = R_0_rounded;
  Do->m01 = R_1_rounded;
  Do->m02 = R_2_rounded;
  Do->m03 = Do_03_rounded;
  Do->m10 = R_3_rounded;
  Do->m11 = R_4_rounded;
  Do->m12 = R_5_rounded;
  Do->m13 = Do_13_rounded;
  Do->m20 = R_6_rounded;
  Do->m21 = R_7_rounded;
  Do->m22 = R_8_rounded;
  Do->m23 = Do_23_rounded;
}

/* Do = D1^-1 D2 = [R1^T R2 | R1^T (t2 - t1)].
   D1, D2, Do: displacement [R | t], R rotation, t in m.
   45 mul, 159 add, 36 product rest.
   Error <= u |result| + (R: 11, t: 18) u^2 S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_dinvd_accurate(const ksl_SE3_t *D1, const ksl_SE3_t *D2,
    ksl_SE3_t *Do) {
  const double p_0 = D2->m03 - D1->m03, p_0_right = D2->m03 - p_0,
      p_0_lo = D2->m03 - (p_0 + p_0_right) - (D1->m03 - p_0_right);
  const double p_1 = D2->m13 - D1->m13, p_1_right = D2->m13 - p_1,
      p_1_lo = D2->m13 - (p_1 + p_1_right) - (D1->m13 - p_1_right);
  const double p_2 = D2->m23 - D1->m23, p_2_right = D2->m23 - p_2,
      p_2_lo = D2->m23 - (p_2 + p_2_right) - (D1->m23 - p_2_right);
  const double Do_00a = KSL_MUL(D1->m00, D2->m00), Do_00b = KSL_MUL(D1->m10, D2->m10),
      Do_00c = Do_00a + Do_00b, Do_00c_right = Do_00c - Do_00a, Do_00d = KSL_MUL(D1->m20, D2->m20),
      Do_00 = Do_00c + Do_00d, Do_00_right = Do_00 - Do_00c,
      Do_00c_lo = ksl_product_rest(D1->m00, D2->m00, Do_00a, Do_00c - Do_00c_right)
          + ksl_product_rest(D1->m10, D2->m10, Do_00b, Do_00c_right);
  const double Do_01a = KSL_MUL(D1->m00, D2->m01), Do_01b = KSL_MUL(D1->m10, D2->m11),
      Do_01c = Do_01a + Do_01b, Do_01c_right = Do_01c - Do_01a, Do_01d = KSL_MUL(D1->m20, D2->m21),
      Do_01 = Do_01c + Do_01d, Do_01_right = Do_01 - Do_01c,
      Do_01c_lo = ksl_product_rest(D1->m00, D2->m01, Do_01a, Do_01c - Do_01c_right)
          + ksl_product_rest(D1->m10, D2->m11, Do_01b, Do_01c_right);
  const double Do_02a = KSL_MUL(D1->m00, D2->m02), Do_02b = KSL_MUL(D1->m10, D2->m12),
      Do_02c = Do_02a + Do_02b, Do_02c_right = Do_02c - Do_02a, Do_02d = KSL_MUL(D1->m20, D2->m22),
      Do_02 = Do_02c + Do_02d, Do_02_right = Do_02 - Do_02c,
      Do_02c_lo = ksl_product_rest(D1->m00, D2->m02, Do_02a, Do_02c - Do_02c_right)
          + ksl_product_rest(D1->m10, D2->m12, Do_02b, Do_02c_right);
  const double Do_03a = KSL_MUL(D1->m00, p_0), Do_03b = KSL_MUL(D1->m10, p_1),
      Do_03c = Do_03a + Do_03b, Do_03c_right = Do_03c - Do_03a,
      Do_03c_lo1 = ksl_product_rest(D1->m00, p_0, Do_03a, Do_03c - Do_03c_right)
          + ksl_product_rest(D1->m10, p_1, Do_03b, Do_03c_right), Do_03d = KSL_MUL(D1->m20, p_2),
      Do_03 = Do_03c + Do_03d, Do_03_right = Do_03 - Do_03c,
      Do_03_lo2 = Do_03c - (Do_03 - Do_03_right)
          + ksl_product_rest(D1->m20, p_2, Do_03d, Do_03_right) + KSL_MUL(D1->m20, p_2_lo);
  const double Do_10a = KSL_MUL(D1->m01, D2->m00), Do_10b = KSL_MUL(D1->m11, D2->m10),
      Do_10c = Do_10a + Do_10b, Do_10c_right = Do_10c - Do_10a, Do_10d = KSL_MUL(D1->m21, D2->m20),
      Do_10 = Do_10c + Do_10d, Do_10_right = Do_10 - Do_10c,
      Do_10c_lo = ksl_product_rest(D1->m01, D2->m00, Do_10a, Do_10c - Do_10c_right)
          + ksl_product_rest(D1->m11, D2->m10, Do_10b, Do_10c_right);
  const double Do_11a = KSL_MUL(D1->m01, D2->m01), Do_11b = KSL_MUL(D1->m11, D2->m11),
      Do_11c = Do_11a + Do_11b, Do_11c_right = Do_11c - Do_11a, Do_11d = KSL_MUL(D1->m21, D2->m21),
      Do_11 = Do_11c + Do_11d, Do_11_right = Do_11 - Do_11c,
      Do_11c_lo = ksl_product_rest(D1->m01, D2->m01, Do_11a, Do_11c - Do_11c_right)
          + ksl_product_rest(D1->m11, D2->m11, Do_11b, Do_11c_right);
  const double Do_12a = KSL_MUL(D1->m01, D2->m02), Do_12b = KSL_MUL(D1->m11, D2->m12),
      Do_12c = Do_12a + Do_12b, Do_12c_right = Do_12c - Do_12a, Do_12d = KSL_MUL(D1->m21, D2->m22),
      Do_12 = Do_12c + Do_12d, Do_12_right = Do_12 - Do_12c,
      Do_12c_lo = ksl_product_rest(D1->m01, D2->m02, Do_12a, Do_12c - Do_12c_right)
          + ksl_product_rest(D1->m11, D2->m12, Do_12b, Do_12c_right);
  const double Do_13a = KSL_MUL(D1->m01, p_0), Do_13b = KSL_MUL(D1->m11, p_1),
      Do_13c = Do_13a + Do_13b, Do_13c_right = Do_13c - Do_13a,
      Do_13c_lo1 = ksl_product_rest(D1->m01, p_0, Do_13a, Do_13c - Do_13c_right)
          + ksl_product_rest(D1->m11, p_1, Do_13b, Do_13c_right), Do_13d = KSL_MUL(D1->m21, p_2),
      Do_13 = Do_13c + Do_13d, Do_13_right = Do_13 - Do_13c,
      Do_13_lo2 = Do_13c - (Do_13 - Do_13_right)
          + ksl_product_rest(D1->m21, p_2, Do_13d, Do_13_right) + KSL_MUL(D1->m21, p_2_lo);
  const double Do_20a = KSL_MUL(D1->m02, D2->m00), Do_20b = KSL_MUL(D1->m12, D2->m10),
      Do_20c = Do_20a + Do_20b, Do_20c_right = Do_20c - Do_20a, Do_20d = KSL_MUL(D1->m22, D2->m20),
      Do_20 = Do_20c + Do_20d, Do_20_right = Do_20 - Do_20c,
      Do_20c_lo = ksl_product_rest(D1->m02, D2->m00, Do_20a, Do_20c - Do_20c_right)
          + ksl_product_rest(D1->m12, D2->m10, Do_20b, Do_20c_right);
  const double Do_21a = KSL_MUL(D1->m02, D2->m01), Do_21b = KSL_MUL(D1->m12, D2->m11),
      Do_21c = Do_21a + Do_21b, Do_21c_right = Do_21c - Do_21a, Do_21d = KSL_MUL(D1->m22, D2->m21),
      Do_21 = Do_21c + Do_21d, Do_21_right = Do_21 - Do_21c,
      Do_21c_lo = ksl_product_rest(D1->m02, D2->m01, Do_21a, Do_21c - Do_21c_right)
          + ksl_product_rest(D1->m12, D2->m11, Do_21b, Do_21c_right);
  const double Do_22a = KSL_MUL(D1->m02, D2->m02), Do_22b = KSL_MUL(D1->m12, D2->m12),
      Do_22c = Do_22a + Do_22b, Do_22c_right = Do_22c - Do_22a, Do_22d = KSL_MUL(D1->m22, D2->m22),
      Do_22 = Do_22c + Do_22d, Do_22_right = Do_22 - Do_22c,
      Do_22c_lo = ksl_product_rest(D1->m02, D2->m02, Do_22a, Do_22c - Do_22c_right)
          + ksl_product_rest(D1->m12, D2->m12, Do_22b, Do_22c_right);
  const double Do_23a = KSL_MUL(D1->m02, p_0), Do_23b = KSL_MUL(D1->m12, p_1),
      Do_23c = Do_23a + Do_23b, Do_23c_right = Do_23c - Do_23a,
      Do_23c_lo1 = ksl_product_rest(D1->m02, p_0, Do_23a, Do_23c - Do_23c_right)
          + ksl_product_rest(D1->m12, p_1, Do_23b, Do_23c_right), Do_23d = KSL_MUL(D1->m22, p_2),
      Do_23 = Do_23c + Do_23d, Do_23_right = Do_23 - Do_23c,
      Do_23_lo2 = Do_23c - (Do_23 - Do_23_right)
          + ksl_product_rest(D1->m22, p_2, Do_23d, Do_23_right) + KSL_MUL(D1->m22, p_2_lo);
  const double Do_00_rounded = Do_00
          + (Do_00c - (Do_00 - Do_00_right)
          + ksl_product_rest(D1->m20, D2->m20, Do_00d, Do_00_right) + Do_00c_lo),
      Do_01_rounded = Do_01
          + (Do_01c - (Do_01 - Do_01_right)
          + ksl_product_rest(D1->m20, D2->m21, Do_01d, Do_01_right) + Do_01c_lo),
      Do_02_rounded = Do_02
          + (Do_02c - (Do_02 - Do_02_right)
          + ksl_product_rest(D1->m20, D2->m22, Do_02d, Do_02_right) + Do_02c_lo),
      Do_03_rounded = Do_03
          + (Do_03_lo2 + (Do_03c_lo1 + (KSL_MUL(D1->m00, p_0_lo) + KSL_MUL(D1->m10, p_1_lo)))),
      Do_10_rounded = Do_10
          + (Do_10c - (Do_10 - Do_10_right)
          + ksl_product_rest(D1->m21, D2->m20, Do_10d, Do_10_right) + Do_10c_lo),
      Do_11_rounded = Do_11
          + (Do_11c - (Do_11 - Do_11_right)
          + ksl_product_rest(D1->m21, D2->m21, Do_11d, Do_11_right) + Do_11c_lo),
      Do_12_rounded = Do_12
          + (Do_12c - (Do_12 - Do_12_right)
          + ksl_product_rest(D1->m21, D2->m22, Do_12d, Do_12_right) + Do_12c_lo),
      Do_13_rounded = Do_13
          + (Do_13_lo2 + (Do_13c_lo1 + (KSL_MUL(D1->m01, p_0_lo) + KSL_MUL(D1->m11, p_1_lo)))),
      Do_20_rounded = Do_20
          + (Do_20c - (Do_20 - Do_20_right)
          + ksl_product_rest(D1->m22, D2->m20, Do_20d, Do_20_right) + Do_20c_lo),
      Do_21_rounded = Do_21
          + (Do_21c - (Do_21 - Do_21_right)
          + ksl_product_rest(D1->m22, D2->m21, Do_21d, Do_21_right) + Do_21c_lo),
      Do_22_rounded = Do_22
          + (Do_22c - (Do_22 - Do_22_right)
          + ksl_product_rest(D1->m22, D2->m22, Do_22d, Do_22_right) + Do_22c_lo),
      Do_23_rounded = Do_23
          + (Do_23_lo2 + (Do_23c_lo1 + (KSL_MUL(D1->m02, p_0_lo) + KSL_MUL(D1->m12, p_1_lo))));
  Do->m00 = Do_00_rounded;
  Do->m01 = Do_01_rounded;
  Do->m02 = Do_02_rounded;
  Do->m03 = Do_03_rounded;
  Do->m10 = Do_10_rounded;
  Do->m11 = Do_11_rounded;
  Do->m12 = Do_12_rounded;
  Do->m13 = Do_13_rounded;
  Do->m20 = Do_20_rounded;
  Do->m21 = Do_21_rounded;
  Do->m22 = Do_22_rounded;
  Do->m23 = Do_23_rounded;
}

/* Do = D [R | 0].
   D, Do: displacement [R | t], R rotation, t in m; R: rotation or other 3×3 matrix.
   27 mul, 99 add, 27 product rest.
   Error <= u |result| + (R: 11, t: 0) u^2 S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_ddr_accurate(const ksl_SE3_t *D, const ksl_mat3x3_t *R,
    ksl_SE3_t *Do) {
  const double Do_00a = KSL_MUL(D->m00, R->m00), Do_00b = KSL_MUL(D->m01, R->m10),
      Do_00c = Do_00a + Do_00b, Do_00c_right = Do_00c - Do_00a, Do_00d = KSL_MUL(D->m02, R->m20),
      Do_00 = Do_00c + Do_00d, Do_00_right = Do_00 - Do_00c,
      Do_00c_lo = ksl_product_rest(D->m00, R->m00, Do_00a, Do_00c - Do_00c_right)
          + ksl_product_rest(D->m01, R->m10, Do_00b, Do_00c_right);
  const double Do_01a = KSL_MUL(D->m00, R->m01), Do_01b = KSL_MUL(D->m01, R->m11),
      Do_01c = Do_01a + Do_01b, Do_01c_right = Do_01c - Do_01a, Do_01d = KSL_MUL(D->m02, R->m21),
      Do_01 = Do_01c + Do_01d, Do_01_right = Do_01 - Do_01c,
      Do_01c_lo = ksl_product_rest(D->m00, R->m01, Do_01a, Do_01c - Do_01c_right)
          + ksl_product_rest(D->m01, R->m11, Do_01b, Do_01c_right);
  const double Do_02a = KSL_MUL(D->m00, R->m02), Do_02b = KSL_MUL(D->m01, R->m12),
      Do_02c = Do_02a + Do_02b, Do_02c_right = Do_02c - Do_02a, Do_02d = KSL_MUL(D->m02, R->m22),
      Do_02 = Do_02c + Do_02d, Do_02_right = Do_02 - Do_02c,
      Do_02c_lo = ksl_product_rest(D->m00, R->m02, Do_02a, Do_02c - Do_02c_right)
          + ksl_product_rest(D->m01, R->m12, Do_02b, Do_02c_right);
  const double Do_10a = KSL_MUL(D->m10, R->m00), Do_10b = KSL_MUL(D->m11, R->m10),
      Do_10c = Do_10a + Do_10b, Do_10c_right = Do_10c - Do_10a, Do_10d = KSL_MUL(D->m12, R->m20),
      Do_10 = Do_10c + Do_10d, Do_10_right = Do_10 - Do_10c,
      Do_10c_lo = ksl_product_rest(D->m10, R->m00, Do_10a, Do_10c - Do_10c_right)
          + ksl_product_rest(D->m11, R->m10, Do_10b, Do_10c_right);
  const double Do_11a = KSL_MUL(D->m10, R->m01), Do_11b = KSL_MUL(D->m11, R->m11),
      Do_11c = Do_11a + Do_11b, Do_11c_right = Do_11c - Do_11a, Do_11d = KSL_MUL(D->m12, R->m21),
      Do_11 = Do_11c + Do_11d, Do_11_right = Do_11 - Do_11c,
      Do_11c_lo = ksl_product_rest(D->m10, R->m01, Do_11a, Do_11c - Do_11c_right)
          + ksl_product_rest(D->m11, R->m11, Do_11b, Do_11c_right);
  const double Do_12a = KSL_MUL(D->m10, R->m02), Do_12b = KSL_MUL(D->m11, R->m12),
      Do_12c = Do_12a + Do_12b, Do_12c_right = Do_12c - Do_12a, Do_12d = KSL_MUL(D->m12, R->m22),
      Do_12 = Do_12c + Do_12d, Do_12_right = Do_12 - Do_12c,
      Do_12c_lo = ksl_product_rest(D->m10, R->m02, Do_12a, Do_12c - Do_12c_right)
          + ksl_product_rest(D->m11, R->m12, Do_12b, Do_12c_right);
  const double Do_20a = KSL_MUL(D->m20, R->m00), Do_20b = KSL_MUL(D->m21, R->m10),
      Do_20c = Do_20a + Do_20b, Do_20c_right = Do_20c - Do_20a, Do_20d = KSL_MUL(D->m22, R->m20),
      Do_20 = Do_20c + Do_20d, Do_20_right = Do_20 - Do_20c,
      Do_20c_lo = ksl_product_rest(D->m20, R->m00, Do_20a, Do_20c - Do_20c_right)
          + ksl_product_rest(D->m21, R->m10, Do_20b, Do_20c_right);
  const double Do_21a = KSL_MUL(D->m20, R->m01), Do_21b = KSL_MUL(D->m21, R->m11),
      Do_21c = Do_21a + Do_21b, Do_21c_right = Do_21c - Do_21a, Do_21d = KSL_MUL(D->m22, R->m21),
      Do_21 = Do_21c + Do_21d, Do_21_right = Do_21 - Do_21c,
      Do_21c_lo = ksl_product_rest(D->m20, R->m01, Do_21a, Do_21c - Do_21c_right)
          + ksl_product_rest(D->m21, R->m11, Do_21b, Do_21c_right);
  const double Do_22a = KSL_MUL(D->m20, R->m02), Do_22b = KSL_MUL(D->m21, R->m12),
      Do_22c = Do_22a + Do_22b, Do_22c_right = Do_22c - Do_22a, Do_22d = KSL_MUL(D->m22, R->m22),
      Do_22 = Do_22c + Do_22d, Do_22_right = Do_22 - Do_22c,
      Do_22c_lo = ksl_product_rest(D->m20, R->m02, Do_22a, Do_22c - Do_22c_right)
          + ksl_product_rest(D->m21, R->m12, Do_22b, Do_22c_right);
  const double Do_00_rounded = Do_00
          + (Do_00c - (Do_00 - Do_00_right) + ksl_product_rest(D->m02, R->m20, Do_00d, Do_00_right)
          + Do_00c_lo),
      Do_01_rounded = Do_01
          + (Do_01c - (Do_01 - Do_01_right) + ksl_product_rest(D->m02, R->m21, Do_01d, Do_01_right)
          + Do_01c_lo),
      Do_02_rounded = Do_02
          + (Do_02c - (Do_02 - Do_02_right) + ksl_product_rest(D->m02, R->m22, Do_02d, Do_02_right)
          + Do_02c_lo),
      Do_10_rounded = Do_10
          + (Do_10c - (Do_10 - Do_10_right) + ksl_product_rest(D->m12, R->m20, Do_10d, Do_10_right)
          + Do_10c_lo),
      Do_11_rounded = Do_11
          + (Do_11c - (Do_11 - Do_11_right) + ksl_product_rest(D->m12, R->m21, Do_11d, Do_11_right)
          + Do_11c_lo),
      Do_12_rounded = Do_12
          + (Do_12c - (Do_12 - Do_12_right) + ksl_product_rest(D->m12, R->m22, Do_12d, Do_12_right)
          + Do_12c_lo),
      Do_20_rounded = Do_20
          + (Do_20c - (Do_20 - Do_20_right) + ksl_product_rest(D->m22, R->m20, Do_20d, Do_20_right)
          + Do_20c_lo),
      Do_21_rounded = Do_21
          + (Do_21c - (Do_21 - Do_21_right) + ksl_product_rest(D->m22, R->m21, Do_21d, Do_21_right)
          + Do_21c_lo),
      Do_22_rounded = Do_22
          + (Do_22c - (Do_22 - Do_22_right) + ksl_product_rest(D->m22, R->m22, Do_22d, Do_22_right)
          + Do_22c_lo);
  const double D_m03 = D->m03;
  const double D_m13 = D->m13;
  const double D_m23 = D->m23;
  Do->m00 = Do_00_rounded;
  Do->m01 = Do_01_rounded;
  Do->m02 = Do_02_rounded;
  Do->m03 = D_m03;
  Do->m10 = Do_10_rounded;
  Do->m11 = Do_11_rounded;
  Do->m12 = Do_12_rounded;
  Do->m13 = D_m13;
  Do->m20 = Do_20_rounded;
  Do->m21 = Do_21_rounded;
  Do->m22 = Do_22_rounded;
  Do->m23 = D_m23;
}

/* Do = D [R^T | 0].
   D, Do: displacement [R | t], R rotation, t in m; R: rotation or other 3×3 matrix.
   27 mul, 99 add, 27 product rest.
   Error <= u |result| + (R: 11, t: 0) u^2 S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_ddrinv_accurate(const ksl_SE3_t *D, const ksl_mat3x3_t *R,
    ksl_SE3_t *Do) {
  const double Do_00a = KSL_MUL(D->m00, R->m00), Do_00b = KSL_MUL(D->m01, R->m01),
      Do_00c = Do_00a + Do_00b, Do_00c_right = Do_00c - Do_00a, Do_00d = KSL_MUL(D->m02, R->m02),
      Do_00 = Do_00c + Do_00d, Do_00_right = Do_00 - Do_00c,
      Do_00c_lo = ksl_product_rest(D->m00, R->m00, Do_00a, Do_00c - Do_00c_right)
          + ksl_product_rest(D->m01, R->m01, Do_00b, Do_00c_right);
  const double Do_01a = KSL_MUL(D->m00, R->m10), Do_01b = KSL_MUL(D->m01, R->m11),
      Do_01c = Do_01a + Do_01b, Do_01c_right = Do_01c - Do_01a, Do_01d = KSL_MUL(D->m02, R->m12),
      Do_01 = Do_01c + Do_01d, Do_01_right = Do_01 - Do_01c,
      Do_01c_lo = ksl_product_rest(D->m00, R->m10, Do_01a, Do_01c - Do_01c_right)
          + ksl_product_rest(D->m01, R->m11, Do_01b, Do_01c_right);
  const double Do_02a = KSL_MUL(D->m00, R->m20), Do_02b = KSL_MUL(D->m01, R->m21),
      Do_02c = Do_02a + Do_02b, Do_02c_right = Do_02c - Do_02a, Do_02d = KSL_MUL(D->m02, R->m22),
      Do_02 = Do_02c + Do_02d, Do_02_right = Do_02 - Do_02c,
      Do_02c_lo = ksl_product_rest(D->m00, R->m20, Do_02a, Do_02c - Do_02c_right)
          + ksl_product_rest(D->m01, R->m21, Do_02b, Do_02c_right);
  const double Do_10a = KSL_MUL(D->m10, R->m00), Do_10b = KSL_MUL(D->m11, R->m01),
      Do_10c = Do_10a + Do_10b, Do_10c_right = Do_10c - Do_10a, Do_10d = KSL_MUL(D->m12, R->m02),
      Do_10 = Do_10c + Do_10d, Do_10_right = Do_10 - Do_10c,
      Do_10c_lo = ksl_product_rest(D->m10, R->m00, Do_10a, Do_10c - Do_10c_right)
          + ksl_product_rest(D->m11, R->m01, Do_10b, Do_10c_right);
  const double Do_11a = KSL_MUL(D->m10, R->m10), Do_11b = KSL_MUL(D->m11, R->m11),
      Do_11c = Do_11a + Do_11b, Do_11c_right = Do_11c - Do_11a, Do_11d = KSL_MUL(D->m12, R->m12),
      Do_11 = Do_11c + Do_11d, Do_11_right = Do_11 - Do_11c,
      Do_11c_lo = ksl_product_rest(D->m10, R->m10, Do_11a, Do_11c - Do_11c_right)
          + ksl_product_rest(D->m11, R->m11, Do_11b, Do_11c_right);
  const double Do_12a = KSL_MUL(D->m10, R->m20), Do_12b = KSL_MUL(D->m11, R->m21),
      Do_12c = Do_12a + Do_12b, Do_12c_right = Do_12c - Do_12a, Do_12d = KSL_MUL(D->m12, R->m22),
      Do_12 = Do_12c + Do_12d, Do_12_right = Do_12 - Do_12c,
      Do_12c_lo = ksl_product_rest(D->m10, R->m20, Do_12a, Do_12c - Do_12c_right)
          + ksl_product_rest(D->m11, R->m21, Do_12b, Do_12c_right);
  const double Do_20a = KSL_MUL(D->m20, R->m00), Do_20b = KSL_MUL(D->m21, R->m01),
      Do_20c = Do_20a + Do_20b, Do_20c_right = Do_20c - Do_20a, Do_20d = KSL_MUL(D->m22, R->m02),
      Do_20 = Do_20c + Do_20d, Do_20_right = Do_20 - Do_20c,
      Do_20c_lo = ksl_product_rest(D->m20, R->m00, Do_20a, Do_20c - Do_20c_right)
          + ksl_product_rest(D->m21, R->m01, Do_20b, Do_20c_right);
  const double Do_21a = KSL_MUL(D->m20, R->m10), Do_21b = KSL_MUL(D->m21, R->m11),
      Do_21c = Do_21a + Do_21b, Do_21c_right = Do_21c - Do_21a, Do_21d = KSL_MUL(D->m22, R->m12),
      Do_21 = Do_21c + Do_21d, Do_21_right = Do_21 - Do_21c,
      Do_21c_lo = ksl_product_rest(D->m20, R->m10, Do_21a, Do_21c - Do_21c_right)
          + ksl_product_rest(D->m21, R->m11, Do_21b, Do_21c_right);
  const double Do_22a = KSL_MUL(D->m20, R->m20), Do_22b = KSL_MUL(D->m21, R->m21),
      Do_22c = Do_22a + Do_22b, Do_22c_right = Do_22c - Do_22a, Do_22d = KSL_MUL(D->m22, R->m22),
      Do_22 = Do_22c + Do_22d, Do_22_right = Do_22 - Do_22c,
      Do_22c_lo = ksl_product_rest(D->m20, R->m20, Do_22a, Do_22c - Do_22c_right)
          + ksl_product_rest(D->m21, R->m21, Do_22b, Do_22c_right);
  const double Do_00_rounded = Do_00
          + (Do_00c - (Do_00 - Do_00_right) + ksl_product_rest(D->m02, R->m02, Do_00d, Do_00_right)
          + Do_00c_lo),
      Do_01_rounded = Do_01
          + (Do_01c - (Do_01 - Do_01_right) + ksl_product_rest(D->m02, R->m12, Do_01d, Do_01_right)
          + Do_01c_lo),
      Do_02_rounded = Do_02
          + (Do_02c - (Do_02 - Do_02_right) + ksl_product_rest(D->m02, R->m22, Do_02d, Do_02_right)
          + Do_02c_lo),
      Do_10_rounded = Do_10
          + (Do_10c - (Do_10 - Do_10_right) + ksl_product_rest(D->m12, R->m02, Do_10d, Do_10_right)
          + Do_10c_lo),
      Do_11_rounded = Do_11
          + (Do_11c - (Do_11 - Do_11_right) + ksl_product_rest(D->m12, R->m12, Do_11d, Do_11_right)
          + Do_11c_lo),
      Do_12_rounded = Do_12
          + (Do_12c - (Do_12 - Do_12_right) + ksl_product_rest(D->m12, R->m22, Do_12d, Do_12_right)
          + Do_12c_lo),
      Do_20_rounded = Do_20
          + (Do_20c - (Do_20 - Do_20_right) + ksl_product_rest(D->m22, R->m02, Do_20d, Do_20_right)
          + Do_20c_lo),
      Do_21_rounded = Do_21
          + (Do_21c - (Do_21 - Do_21_right) + ksl_product_rest(D->m22, R->m12, Do_21d, Do_21_right)
          + Do_21c_lo),
      Do_22_rounded = Do_22
          + (Do_22c - (Do_22 - Do_22_right) + ksl_product_rest(D->m22, R->m22, Do_22d, Do_22_right)
          + Do_22c_lo);
  const double D_m03 = D->m03;
  const double D_m13 = D->m13;
  const double D_m23 = D->m23;
  Do->m00 = Do_00_rounded;
  Do->m01 = Do_01_rounded;
  Do->m02 = Do_02_rounded;
  Do->m03 = D_m03;
  Do->m10 = Do_10_rounded;
  Do->m11 = Do_11_rounded;
  Do->m12 = Do_12_rounded;
  Do->m13 = D_m13;
  Do->m20 = Do_20_rounded;
  Do->m21 = Do_21_rounded;
  Do->m22 = Do_22_rounded;
  Do->m23 = D_m23;
}

/* Do = D [I | t].
   D, Do: displacement [R | t], R rotation, t in m; t: vector.
   9 mul, 54 add, 9 product rest.
   Error <= u |result| + (R: 0, t: 15) u^2 S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_ddt_accurate(const ksl_SE3_t *D, const ksl_vec3_t *t,
    ksl_SE3_t *Do) {
  const double Do_03a = KSL_MUL(D->m00, t->x), Do_03b = KSL_MUL(D->m01, t->y),
      Do_03c = Do_03a + Do_03b, Do_03c_right = Do_03c - Do_03a, Do_03d = KSL_MUL(D->m02, t->z),
      Do_03e = Do_03c + Do_03d, Do_03e_right = Do_03e - Do_03c,
      Do_03c_lo = ksl_product_rest(D->m00, t->x, Do_03a, Do_03c - Do_03c_right)
          + ksl_product_rest(D->m01, t->y, Do_03b, Do_03c_right), Do_03 = Do_03e + D->m03,
      Do_03_right = Do_03 - Do_03e,
      Do_03e_lo = Do_03c - (Do_03e - Do_03e_right)
          + ksl_product_rest(D->m02, t->z, Do_03d, Do_03e_right) + Do_03c_lo;
  const double Do_13a = KSL_MUL(D->m10, t->x), Do_13b = KSL_MUL(D->m11, t->y),
      Do_13c = Do_13a + Do_13b, Do_13c_right = Do_13c - Do_13a, Do_13d = KSL_MUL(D->m12, t->z),
      Do_13e = Do_13c + Do_13d, Do_13e_right = Do_13e - Do_13c,
      Do_13c_lo = ksl_product_rest(D->m10, t->x, Do_13a, Do_13c - Do_13c_right)
          + ksl_product_rest(D->m11, t->y, Do_13b, Do_13c_right), Do_13 = Do_13e + D->m13,
      Do_13_right = Do_13 - Do_13e,
      Do_13e_lo = Do_13c - (Do_13e - Do_13e_right)
          + ksl_product_rest(D->m12, t->z, Do_13d, Do_13e_right) + Do_13c_lo;
  const double Do_23a = KSL_MUL(D->m20, t->x), Do_23b = KSL_MUL(D->m21, t->y),
      Do_23c = Do_23a + Do_23b, Do_23c_right = Do_23c - Do_23a, Do_23d = KSL_MUL(D->m22, t->z),
      Do_23e = Do_23c + Do_23d, Do_23e_right = Do_23e - Do_23c,
      Do_23c_lo = ksl_product_rest(D->m20, t->x, Do_23a, Do_23c - Do_23c_right)
          + ksl_product_rest(D->m21, t->y, Do_23b, Do_23c_right), Do_23 = Do_23e + D->m23,
      Do_23_right = Do_23 - Do_23e,
      Do_23e_lo = Do_23c - (Do_23e - Do_23e_right)
          + ksl_product_rest(D->m22, t->z, Do_23d, Do_23e_right) + Do_23c_lo;
  const double Do_03_rounded = Do_03
          + (Do_03e - (Do_03 - Do_03_right) + (D->m03 - Do_03_right) + Do_03e_lo),
      Do_13_rounded = Do_13 + (Do_13e - (Do_13 - Do_13_right) + (D->m13 - Do_13_right) + Do_13e_lo),
      Do_23_rounded = Do_23 + (Do_23e - (Do_23 - Do_23_right) + (D->m23 - Do_23_right) + Do_23e_lo);
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
  Do->m03 = Do_03_rounded;
  Do->m10 = D_m10;
  Do->m11 = D_m11;
  Do->m12 = D_m12;
  Do->m13 = Do_13_rounded;
  Do->m20 = D_m20;
  Do->m21 = D_m21;
  Do->m22 = D_m22;
  Do->m23 = Do_23_rounded;
}

/* Do = D [I | -t].
   D, Do: displacement [R | t], R rotation, t in m; t: vector.
   9 mul, 54 add, 9 product rest.
   Error <= u |result| + (R: 0, t: 15) u^2 S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_ddtinv_accurate(const ksl_SE3_t *D, const ksl_vec3_t *t,
    ksl_SE3_t *Do) {
  const double Do_03a = KSL_MUL(D->m00, t->x), Do_03b = KSL_MUL(D->m01, t->y),
      Do_03c = Do_03a + Do_03b, Do_03c_right = Do_03c - Do_03a, Do_03d = KSL_MUL(D->m02, t->z),
      Do_03e = Do_03c + Do_03d, Do_03e_right = Do_03e - Do_03c,
      Do_03c_lo = ksl_product_rest(D->m00, t->x, Do_03a, Do_03c - Do_03c_right)
          + ksl_product_rest(D->m01, t->y, Do_03b, Do_03c_right), Do_03 = D->m03 - Do_03e,
      Do_03_right = D->m03 - Do_03,
      Do_03e_lo = Do_03c - (Do_03e - Do_03e_right)
          + ksl_product_rest(D->m02, t->z, Do_03d, Do_03e_right) + Do_03c_lo;
  const double Do_13a = KSL_MUL(D->m10, t->x), Do_13b = KSL_MUL(D->m11, t->y),
      Do_13c = Do_13a + Do_13b, Do_13c_right = Do_13c - Do_13a, Do_13d = KSL_MUL(D->m12, t->z),
      Do_13e = Do_13c + Do_13d, Do_13e_right = Do_13e - Do_13c,
      Do_13c_lo = ksl_product_rest(D->m10, t->x, Do_13a, Do_13c - Do_13c_right)
          + ksl_product_rest(D->m11, t->y, Do_13b, Do_13c_right), Do_13 = D->m13 - Do_13e,
      Do_13_right = D->m13 - Do_13,
      Do_13e_lo = Do_13c - (Do_13e - Do_13e_right)
          + ksl_product_rest(D->m12, t->z, Do_13d, Do_13e_right) + Do_13c_lo;
  const double Do_23a = KSL_MUL(D->m20, t->x), Do_23b = KSL_MUL(D->m21, t->y),
      Do_23c = Do_23a + Do_23b, Do_23c_right = Do_23c - Do_23a, Do_23d = KSL_MUL(D->m22, t->z),
      Do_23e = Do_23c + Do_23d, Do_23e_right = Do_23e - Do_23c,
      Do_23c_lo = ksl_product_rest(D->m20, t->x, Do_23a, Do_23c - Do_23c_right)
          + ksl_product_rest(D->m21, t->y, Do_23b, Do_23c_right), Do_23 = D->m23 - Do_23e,
      Do_23_right = D->m23 - Do_23,
      Do_23e_lo = Do_23c - (Do_23e - Do_23e_right)
          + ksl_product_rest(D->m22, t->z, Do_23d, Do_23e_right) + Do_23c_lo;
  const double Do_03_rounded = Do_03
          + (D->m03 - (Do_03 + Do_03_right) - (Do_03e - Do_03_right) - Do_03e_lo),
      Do_13_rounded = Do_13 + (D->m13 - (Do_13 + Do_13_right) - (Do_13e - Do_13_right) - Do_13e_lo),
      Do_23_rounded = Do_23 + (D->m23 - (Do_23 + Do_23_right) - (Do_23e - Do_23_right) - Do_23e_lo);
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
  Do->m03 = Do_03_rounded;
  Do->m10 = D_m10;
  Do->m11 = D_m11;
  Do->m12 = D_m12;
  Do->m13 = Do_13_rounded;
  Do->m20 = D_m20;
  Do->m21 = D_m21;
  Do->m22 = D_m22;
  Do->m23 = Do_23_rounded;
}

/* Do = D^-1 [I | t] = [R^T | R^T (t - t_D)].
   D, Do: displacement [R | t], R rotation, t in m; t: vector.
   18 mul, 60 add, 9 product rest.
   Error <= u |result| + (R: 0, t: 18) u^2 S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_dinvdt_accurate(const ksl_SE3_t *D, const ksl_vec3_t *t,
    ksl_SE3_t *Do) {
  const double p_0 = t->x - D->m03, p_0_right = t->x - p_0,
      p_0_lo = t->x - (p_0 + p_0_right) - (D->m03 - p_0_right);
  const double p_1 = t->y - D->m13, p_1_right = t->y - p_1,
      p_1_lo = t->y - (p_1 + p_1_right) - (D->m13 - p_1_right);
  const double p_2 = t->z - D->m23, p_2_right = t->z - p_2,
      p_2_lo = t->z - (p_2 + p_2_right) - (D->m23 - p_2_right);
  const double Do_03a = KSL_MUL(D->m00, p_0), Do_03b = KSL_MUL(D->m10, p_1),
      Do_03c = Do_03a + Do_03b, Do_03c_right = Do_03c - Do_03a,
      Do_03c_lo1 = ksl_product_rest(D->m00, p_0, Do_03a, Do_03c - Do_03c_right)
          + ksl_product_rest(D->m10, p_1, Do_03b, Do_03c_right), Do_03d = KSL_MUL(D->m20, p_2),
      Do_03 = Do_03c + Do_03d, Do_03_right = Do_03 - Do_03c,
      Do_03_lo2 = Do_03c - (Do_03 - Do_03_right)
          + ksl_product_rest(D->m20, p_2, Do_03d, Do_03_right) + KSL_MUL(D->m20, p_2_lo);
  const double Do_13a = KSL_MUL(D->m01, p_0), Do_13b = KSL_MUL(D->m11, p_1),
      Do_13c = Do_13a + Do_13b, Do_13c_right = Do_13c - Do_13a,
      Do_13c_lo1 = ksl_product_rest(D->m01, p_0, Do_13a, Do_13c - Do_13c_right)
          + ksl_product_rest(D->m11, p_1, Do_13b, Do_13c_right), Do_13d = KSL_MUL(D->m21, p_2),
      Do_13 = Do_13c + Do_13d, Do_13_right = Do_13 - Do_13c,
      Do_13_lo2 = Do_13c - (Do_13 - Do_13_right)
          + ksl_product_rest(D->m21, p_2, Do_13d, Do_13_right) + KSL_MUL(D->m21, p_2_lo);
  const double Do_23a = KSL_MUL(D->m02, p_0), Do_23b = KSL_MUL(D->m12, p_1),
      Do_23c = Do_23a + Do_23b, Do_23c_right = Do_23c - Do_23a,
      Do_23c_lo1 = ksl_product_rest(D->m02, p_0, Do_23a, Do_23c - Do_23c_right)
          + ksl_product_rest(D->m12, p_1, Do_23b, Do_23c_right), Do_23d = KSL_MUL(D->m22, p_2),
      Do_23 = Do_23c + Do_23d, Do_23_right = Do_23 - Do_23c,
      Do_23_lo2 = Do_23c - (Do_23 - Do_23_right)
          + ksl_product_rest(D->m22, p_2, Do_23d, Do_23_right) + KSL_MUL(D->m22, p_2_lo);
  const double Do_03_rounded = Do_03
          + (Do_03_lo2 + (Do_03c_lo1 + (KSL_MUL(D->m00, p_0_lo) + KSL_MUL(D->m10, p_1_lo)))),
      Do_13_rounded = Do_13
          + (Do_13_lo2 + (Do_13c_lo1 + (KSL_MUL(D->m01, p_0_lo) + KSL_MUL(D->m11, p_1_lo)))),
      Do_23_rounded = Do_23
          + (Do_23_lo2 + (Do_23c_lo1 + (KSL_MUL(D->m02, p_0_lo) + KSL_MUL(D->m12, p_1_lo))));
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
  Do->m03 = Do_03_rounded;
  Do->m10 = D_m01;
  Do->m11 = D_m11;
  Do->m12 = D_m21;
  Do->m13 = Do_13_rounded;
  Do->m20 = D_m02;
  Do->m21 = D_m12;
  Do->m22 = D_m22;
  Do->m23 = Do_23_rounded;
}

/* vo = R (k e_x).
   R: rotation or other 3×3 matrix; k: number; vo: vector.
   3 mul, 3 add, 3 product error.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_product_drvtx_accurate(const ksl_mat3x3_t *R, const double k,
    ksl_vec3_t *vo) {
  const double vo_0 = KSL_MUL(R->m00, k), vo_1 = KSL_MUL(R->m10, k), vo_2 = KSL_MUL(R->m20, k);
  const double vo_0_rounded = vo_0 + ksl_product_error(R->m00, k, vo_0),
      vo_1_rounded = vo_1 + ksl_product_error(R->m10, k, vo_1),
      vo_2_rounded = vo_2 + ksl_product_error(R->m20, k, vo_2);
  vo->x = vo_0_rounded;
  vo->y = vo_1_rounded;
  vo->z = vo_2_rounded;
}

/* Ro = R R_x(θ), dc = (sin θ, cos θ).
   R, Ro: rotation or other 3×3 matrix; dc: (sin θ, cos θ).
   12 mul, 30 add, 12 product rest.
   Error <= u |result| + 6 u^2 S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_product_drdrx_accurate(const ksl_mat3x3_t *R, const double dc[2],
    ksl_mat3x3_t *Ro) {
  const double Ro_01a = KSL_MUL(R->m01, dc[1]), Ro_01b = KSL_MUL(R->m02, dc[0]),
      Ro_01 = Ro_01a + Ro_01b, Ro_01_right = Ro_01 - Ro_01a;
  const double Ro_02a = KSL_MUL(R->m02, dc[1]), Ro_02b = KSL_MUL(R->m01, dc[0]),
      Ro_02 = Ro_02a - Ro_02b, Ro_02_right = Ro_02a - Ro_02;
  const double Ro_11a = KSL_MUL(R->m11, dc[1]), Ro_11b = KSL_MUL(R->m12, dc[0]),
      Ro_11 = Ro_11a + Ro_11b, Ro_11_right = Ro_11 - Ro_11a;
  const double Ro_12a = KSL_MUL(R->m12, dc[1]), Ro_12b = KSL_MUL(R->m11, dc[0]),
      Ro_12 = Ro_12a - Ro_12b, Ro_12_right = Ro_12a - Ro_12;
  const double Ro_21a = KSL_MUL(R->m21, dc[1]), Ro_21b = KSL_MUL(R->m22, dc[0]),
      Ro_21 = Ro_21a + Ro_21b, Ro_21_right = Ro_21 - Ro_21a;
  const double Ro_22a = KSL_MUL(R->m22, dc[1]), Ro_22b = KSL_MUL(R->m21, dc[0]),
      Ro_22 = Ro_22a - Ro_22b, Ro_22_right = Ro_22a - Ro_22;
  const double Ro_01_rounded = Ro_01
          + (ksl_product_rest(R->m01, dc[1], Ro_01a, Ro_01 - Ro_01_right)
          + ksl_product_rest(R->m02, dc[0], Ro_01b, Ro_01_right)),
      Ro_02_rounded = Ro_02
          + (ksl_product_rest(R->m02, dc[1], Ro_02a, Ro_02 + Ro_02_right)
          - ksl_product_rest(R->m01, dc[0], Ro_02b, Ro_02_right)),
      Ro_11_rounded = Ro_11
          + (ksl_product_rest(R->m11, dc[1], Ro_11a, Ro_11 - Ro_11_right)
          + ksl_product_rest(R->m12, dc[0], Ro_11b, Ro_11_right)),
      Ro_12_rounded = Ro_12
          + (ksl_product_rest(R->m12, dc[1], Ro_12a, Ro_12 + Ro_12_right)
          - ksl_product_rest(R->m11, dc[0], Ro_12b, Ro_12_right)),
      Ro_21_rounded = Ro_21
          + (ksl_product_rest(R->m21, dc[1], Ro_21a, Ro_21 - Ro_21_right)
          + ksl_product_rest(R->m22, dc[0], Ro_21b, Ro_21_right)),
      Ro_22_rounded = Ro_22
          + (ksl_product_rest(R->m22, dc[1], Ro_22a, Ro_22 + Ro_22_right)
          - ksl_product_rest(R->m21, dc[0], Ro_22b, Ro_22_right));
  const double R_m00 = R->m00;
  const double R_m10 = R->m10;
  const double R_m20 = R->m20;
  Ro->m00 = R_m00;
  Ro->m01 = Ro_01_rounded;
  Ro->m02 = Ro_02_rounded;
  Ro->m10 = R_m10;
  Ro->m11 = Ro_11_rounded;
  Ro->m12 = Ro_12_rounded;
  Ro->m20 = R_m20;
  Ro->m21 = Ro_21_rounded;
  Ro->m22 = Ro_22_rounded;
}

/* Do = D [R_x(θ) | 0], dc = (sin θ, cos θ).
   D, Do: displacement [R | t], R rotation, t in m; dc: (sin θ, cos θ).
   12 mul, 30 add, 12 product rest.
   Error <= u |result| + (R: 6, t: 0) u^2 S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_ddrx_accurate(const ksl_SE3_t *D, const double dc[2],
    ksl_SE3_t *Do) {
  const double Do_01a = KSL_MUL(D->m01, dc[1]), Do_01b = KSL_MUL(D->m02, dc[0]),
      Do_01 = Do_01a + Do_01b, Do_01_right = Do_01 - Do_01a;
  const double Do_02a = KSL_MUL(D->m02, dc[1]), Do_02b = KSL_MUL(D->m01, dc[0]),
      Do_02 = Do_02a - Do_02b, Do_02_right = Do_02a - Do_02;
  const double Do_11a = KSL_MUL(D->m11, dc[1]), Do_11b = KSL_MUL(D->m12, dc[0]),
      Do_11 = Do_11a + Do_11b, Do_11_right = Do_11 - Do_11a;
  const double Do_12a = KSL_MUL(D->m12, dc[1]), Do_12b = KSL_MUL(D->m11, dc[0]),
      Do_12 = Do_12a - Do_12b, Do_12_right = Do_12a - Do_12;
  const double Do_21a = KSL_MUL(D->m21, dc[1]), Do_21b = KSL_MUL(D->m22, dc[0]),
      Do_21 = Do_21a + Do_21b, Do_21_right = Do_21 - Do_21a;
  const double Do_22a = KSL_MUL(D->m22, dc[1]), Do_22b = KSL_MUL(D->m21, dc[0]),
      Do_22 = Do_22a - Do_22b, Do_22_right = Do_22a - Do_22;
  const double Do_01_rounded = Do_01
          + (ksl_product_rest(D->m01, dc[1], Do_01a, Do_01 - Do_01_right)
          + ksl_product_rest(D->m02, dc[0], Do_01b, Do_01_right)),
      Do_02_rounded = Do_02
          + (ksl_product_rest(D->m02, dc[1], Do_02a, Do_02 + Do_02_right)
          - ksl_product_rest(D->m01, dc[0], Do_02b, Do_02_right)),
      Do_11_rounded = Do_11
          + (ksl_product_rest(D->m11, dc[1], Do_11a, Do_11 - Do_11_right)
          + ksl_product_rest(D->m12, dc[0], Do_11b, Do_11_right)),
      Do_12_rounded = Do_12
          + (ksl_product_rest(D->m12, dc[1], Do_12a, Do_12 + Do_12_right)
          - ksl_product_rest(D->m11, dc[0], Do_12b, Do_12_right)),
      Do_21_rounded = Do_21
          + (ksl_product_rest(D->m21, dc[1], Do_21a, Do_21 - Do_21_right)
          + ksl_product_rest(D->m22, dc[0], Do_21b, Do_21_right)),
      Do_22_rounded = Do_22
          + (ksl_product_rest(D->m22, dc[1], Do_22a, Do_22 + Do_22_right)
          - ksl_product_rest(D->m21, dc[0], Do_22b, Do_22_right));
  const double D_m00 = D->m00;
  const double D_m03 = D->m03;
  const double D_m10 = D->m10;
  const double D_m13 = D->m13;
  const double D_m20 = D->m20;
  const double D_m23 = D->m23;
  Do->m00 = D_m00;
  Do->m01 = Do_01_rounded;
  Do->m02 = Do_02_rounded;
  Do->m03 = D_m03;
  Do->m10 = D_m10;
  Do->m11 = Do_11_rounded;
  Do->m12 = Do_12_rounded;
  Do->m13 = D_m13;
  Do->m20 = D_m20;
  Do->m21 = Do_21_rounded;
  Do->m22 = Do_22_rounded;
  Do->m23 = D_m23;
}

/* Do = D [I | k e_x].
   D, Do: displacement [R | t], R rotation, t in m; k: number.
   3 mul, 18 add, 3 product rest.
   Error <= u |result| + (R: 0, t: 3) u^2 S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_ddtx_accurate(const ksl_SE3_t *D, const double k, ksl_SE3_t *Do) {
  const double Do_03a = KSL_MUL(D->m00, k), Do_03 = Do_03a + D->m03, Do_03_right = Do_03 - Do_03a;
  const double Do_13a = KSL_MUL(D->m10, k), Do_13 = Do_13a + D->m13, Do_13_right = Do_13 - Do_13a;
  const double Do_23a = KSL_MUL(D->m20, k), Do_23 = Do_23a + D->m23, Do_23_right = Do_23 - Do_23a;
  const double Do_03_rounded = Do_03
          + (ksl_product_rest(D->m00, k, Do_03a, Do_03 - Do_03_right) + (D->m03 - Do_03_right)),
      Do_13_rounded = Do_13
          + (ksl_product_rest(D->m10, k, Do_13a, Do_13 - Do_13_right) + (D->m13 - Do_13_right)),
      Do_23_rounded = Do_23
          + (ksl_product_rest(D->m20, k, Do_23a, Do_23 - Do_23_right) + (D->m23 - Do_23_right));
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
  Do->m03 = Do_03_rounded;
  Do->m10 = D_m10;
  Do->m11 = D_m11;
  Do->m12 = D_m12;
  Do->m13 = Do_13_rounded;
  Do->m20 = D_m20;
  Do->m21 = D_m21;
  Do->m22 = D_m22;
  Do->m23 = Do_23_rounded;
}

/* vo = R (-k e_x).
   R: rotation or other 3×3 matrix; k: number; vo: vector.
   3 mul, 3 add, 3 product error, 6 neg.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_product_drvtxinv_accurate(const ksl_mat3x3_t *R, const double k,
    ksl_vec3_t *vo) {
  const double vo_0 = -KSL_MUL(R->m00, k), vo_1 = -KSL_MUL(R->m10, k), vo_2 = -KSL_MUL(R->m20, k);
  const double vo_0_rounded = vo_0 + ksl_product_error(-R->m00, k, vo_0),
      vo_1_rounded = vo_1 + ksl_product_error(-R->m10, k, vo_1),
      vo_2_rounded = vo_2 + ksl_product_error(-R->m20, k, vo_2);
  vo->x = vo_0_rounded;
  vo->y = vo_1_rounded;
  vo->z = vo_2_rounded;
}

/* Ro = R R_x(-θ), dc = (sin θ, cos θ).
   R, Ro: rotation or other 3×3 matrix; dc: (sin θ, cos θ).
   12 mul, 30 add, 12 product rest.
   Error <= u |result| + 6 u^2 S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_product_drdrxinv_accurate(const ksl_mat3x3_t *R, const double dc[2],
    ksl_mat3x3_t *Ro) {
  const double Ro_01a = KSL_MUL(R->m01, dc[1]), Ro_01b = KSL_MUL(R->m02, dc[0]),
      Ro_01 = Ro_01a - Ro_01b, Ro_01_right = Ro_01a - Ro_01;
  const double Ro_02a = KSL_MUL(R->m01, dc[0]), Ro_02b = KSL_MUL(R->m02, dc[1]),
      Ro_02 = Ro_02a + Ro_02b, Ro_02_right = Ro_02 - Ro_02a;
  const double Ro_11a = KSL_MUL(R->m11, dc[1]), Ro_11b = KSL_MUL(R->m12, dc[0]),
      Ro_11 = Ro_11a - Ro_11b, Ro_11_right = Ro_11a - Ro_11;
  const double Ro_12a = KSL_MUL(R->m11, dc[0]), Ro_12b = KSL_MUL(R->m12, dc[1]),
      Ro_12 = Ro_12a + Ro_12b, Ro_12_right = Ro_12 - Ro_12a;
  const double Ro_21a = KSL_MUL(R->m21, dc[1]), Ro_21b = KSL_MUL(R->m22, dc[0]),
      Ro_21 = Ro_21a - Ro_21b, Ro_21_right = Ro_21a - Ro_21;
  const double Ro_22a = KSL_MUL(R->m21, dc[0]), Ro_22b = KSL_MUL(R->m22, dc[1]),
      Ro_22 = Ro_22a + Ro_22b, Ro_22_right = Ro_22 - Ro_22a;
  const double Ro_01_rounded = Ro_01
          + (ksl_product_rest(R->m01, dc[1], Ro_01a, Ro_01 + Ro_01_right)
          - ksl_product_rest(R->m02, dc[0], Ro_01b, Ro_01_right)),
      Ro_02_rounded = Ro_02
          + (ksl_product_rest(R->m01, dc[0], Ro_02a, Ro_02 - Ro_02_right)
          + ksl_product_rest(R->m02, dc[1], Ro_02b, Ro_02_right)),
      Ro_11_rounded = Ro_11
          + (ksl_product_rest(R->m11, dc[1], Ro_11a, Ro_11 + Ro_11_right)
          - ksl_product_rest(R->m12, dc[0], Ro_11b, Ro_11_right)),
      Ro_12_rounded = Ro_12
          + (ksl_product_rest(R->m11, dc[0], Ro_12a, Ro_12 - Ro_12_right)
          + ksl_product_rest(R->m12, dc[1], Ro_12b, Ro_12_right)),
      Ro_21_rounded = Ro_21
          + (ksl_product_rest(R->m21, dc[1], Ro_21a, Ro_21 + Ro_21_right)
          - ksl_product_rest(R->m22, dc[0], Ro_21b, Ro_21_right)),
      Ro_22_rounded = Ro_22
          + (ksl_product_rest(R->m21, dc[0], Ro_22a, Ro_22 - Ro_22_right)
          + ksl_product_rest(R->m22, dc[1], Ro_22b, Ro_22_right));
  const double R_m00 = R->m00;
  const double R_m10 = R->m10;
  const double R_m20 = R->m20;
  Ro->m00 = R_m00;
  Ro->m01 = Ro_01_rounded;
  Ro->m02 = Ro_02_rounded;
  Ro->m10 = R_m10;
  Ro->m11 = Ro_11_rounded;
  Ro->m12 = Ro_12_rounded;
  Ro->m20 = R_m20;
  Ro->m21 = Ro_21_rounded;
  Ro->m22 = Ro_22_rounded;
}

/* Do = D [R_x(-θ) | 0], dc = (sin θ, cos θ).
   D, Do: displacement [R | t], R rotation, t in m; dc: (sin θ, cos θ).
   12 mul, 30 add, 12 product rest.
   Error <= u |result| + (R: 6, t: 0) u^2 S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_ddrxinv_accurate(const ksl_SE3_t *D, const double dc[2],
    ksl_SE3_t *Do) {
  const double Do_01a = KSL_MUL(D->m01, dc[1]), Do_01b = KSL_MUL(D->m02, dc[0]),
      Do_01 = Do_01a - Do_01b, Do_01_right = Do_01a - Do_01;
  const double Do_02a = KSL_MUL(D->m01, dc[0]), Do_02b = KSL_MUL(D->m02, dc[1]),
      Do_02 = Do_02a + Do_02b, Do_02_right = Do_02 - Do_02a;
  const double Do_11a = KSL_MUL(D->m11, dc[1]), Do_11b = KSL_MUL(D->m12, dc[0]),
      Do_11 = Do_11a - Do_11b, Do_11_right = Do_11a - Do_11;
  const double Do_12a = KSL_MUL(D->m11, dc[0]), Do_12b = KSL_MUL(D->m12, dc[1]),
      Do_12 = Do_12a + Do_12b, Do_12_right = Do_12 - Do_12a;
  const double Do_21a = KSL_MUL(D->m21, dc[1]), Do_21b = KSL_MUL(D->m22, dc[0]),
      Do_21 = Do_21a - Do_21b, Do_21_right = Do_21a - Do_21;
  const double Do_22a = KSL_MUL(D->m21, dc[0]), Do_22b = KSL_MUL(D->m22, dc[1]),
      Do_22 = Do_22a + Do_22b, Do_22_right = Do_22 - Do_22a;
  const double Do_01_rounded = Do_01
          + (ksl_product_rest(D->m01, dc[1], Do_01a, Do_01 + Do_01_right)
          - ksl_product_rest(D->m02, dc[0], Do_01b, Do_01_right)),
      Do_02_rounded = Do_02
          + (ksl_product_rest(D->m01, dc[0], Do_02a, Do_02 - Do_02_right)
          + ksl_product_rest(D->m02, dc[1], Do_02b, Do_02_right)),
      Do_11_rounded = Do_11
          + (ksl_product_rest(D->m11, dc[1], Do_11a, Do_11 + Do_11_right)
          - ksl_product_rest(D->m12, dc[0], Do_11b, Do_11_right)),
      Do_12_rounded = Do_12
          + (ksl_product_rest(D->m11, dc[0], Do_12a, Do_12 - Do_12_right)
          + ksl_product_rest(D->m12, dc[1], Do_12b, Do_12_right)),
      Do_21_rounded = Do_21
          + (ksl_product_rest(D->m21, dc[1], Do_21a, Do_21 + Do_21_right)
          - ksl_product_rest(D->m22, dc[0], Do_21b, Do_21_right)),
      Do_22_rounded = Do_22
          + (ksl_product_rest(D->m21, dc[0], Do_22a, Do_22 - Do_22_right)
          + ksl_product_rest(D->m22, dc[1], Do_22b, Do_22_right));
  const double D_m00 = D->m00;
  const double D_m03 = D->m03;
  const double D_m10 = D->m10;
  const double D_m13 = D->m13;
  const double D_m20 = D->m20;
  const double D_m23 = D->m23;
  Do->m00 = D_m00;
  Do->m01 = Do_01_rounded;
  Do->m02 = Do_02_rounded;
  Do->m03 = D_m03;
  Do->m10 = D_m10;
  Do->m11 = Do_11_rounded;
  Do->m12 = Do_12_rounded;
  Do->m13 = D_m13;
  Do->m20 = D_m20;
  Do->m21 = Do_21_rounded;
  Do->m22 = Do_22_rounded;
  Do->m23 = D_m23;
}

/* Do = D [I | -k e_x].
   D, Do: displacement [R | t], R rotation, t in m; k: number.
   3 mul, 18 add, 3 product rest.
   Error <= u |result| + (R: 0, t: 5) u^2 S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_ddtxinv_accurate(const ksl_SE3_t *D, const double k, ksl_SE3_t *Do) {
  const double Do_03a = KSL_MUL(D->m00, k), Do_03 = D->m03 - Do_03a, Do_03_right = D->m03 - Do_03;
  const double Do_13a = KSL_MUL(D->m10, k), Do_13 = D->m13 - Do_13a, Do_13_right = D->m13 - Do_13;
  const double Do_23a = KSL_MUL(D->m20, k), Do_23 = D->m23 - Do_23a, Do_23_right = D->m23 - Do_23;
  const double Do_03_rounded = Do_03
          + (D->m03 - (Do_03 + Do_03_right) - ksl_product_rest(D->m00, k, Do_03a, Do_03_right)),
      Do_13_rounded = Do_13
          + (D->m13 - (Do_13 + Do_13_right) - ksl_product_rest(D->m10, k, Do_13a, Do_13_right)),
      Do_23_rounded = Do_23
          + (D->m23 - (Do_23 + Do_23_right) - ksl_product_rest(D->m20, k, Do_23a, Do_23_right));
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
  Do->m03 = Do_03_rounded;
  Do->m10 = D_m10;
  Do->m11 = D_m11;
  Do->m12 = D_m12;
  Do->m13 = Do_13_rounded;
  Do->m20 = D_m20;
  Do->m21 = D_m21;
  Do->m22 = D_m22;
  Do->m23 = Do_23_rounded;
}

/* vo = R (k e_y).
   R: rotation or other 3×3 matrix; k: number; vo: vector.
   3 mul, 3 add, 3 product error.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_product_drvty_accurate(const ksl_mat3x3_t *R, const double k,
    ksl_vec3_t *vo) {
  const double vo_0 = KSL_MUL(R->m01, k), vo_1 = KSL_MUL(R->m11, k), vo_2 = KSL_MUL(R->m21, k);
  const double vo_0_rounded = vo_0 + ksl_product_error(R->m01, k, vo_0),
      vo_1_rounded = vo_1 + ksl_product_error(R->m11, k, vo_1),
      vo_2_rounded = vo_2 + ksl_product_error(R->m21, k, vo_2);
  vo->x = vo_0_rounded;
  vo->y = vo_1_rounded;
  vo->z = vo_2_rounded;
}

/* Ro = R R_y(θ), dc = (sin θ, cos θ).
   R, Ro: rotation or other 3×3 matrix; dc: (sin θ, cos θ).
   12 mul, 30 add, 12 product rest.
   Error <= u |result| + 6 u^2 S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_product_drdry_accurate(const ksl_mat3x3_t *R, const double dc[2],
    ksl_mat3x3_t *Ro) {
  const double Ro_00a = KSL_MUL(R->m00, dc[1]), Ro_00b = KSL_MUL(R->m02, dc[0]),
      Ro_00 = Ro_00a - Ro_00b, Ro_00_right = Ro_00a - Ro_00;
  const double Ro_02a = KSL_MUL(R->m00, dc[0]), Ro_02b = KSL_MUL(R->m02, dc[1]),
      Ro_02 = Ro_02a + Ro_02b, Ro_02_right = Ro_02 - Ro_02a;
  const double Ro_10a = KSL_MUL(R->m10, dc[1]), Ro_10b = KSL_MUL(R->m12, dc[0]),
      Ro_10 = Ro_10a - Ro_10b, Ro_10_right = Ro_10a - Ro_10;
  const double Ro_12a = KSL_MUL(R->m10, dc[0]), Ro_12b = KSL_MUL(R->m12, dc[1]),
      Ro_12 = Ro_12a + Ro_12b, Ro_12_right = Ro_12 - Ro_12a;
  const double Ro_20a = KSL_MUL(R->m20, dc[1]), Ro_20b = KSL_MUL(R->m22, dc[0]),
      Ro_20 = Ro_20a - Ro_20b, Ro_20_right = Ro_20a - Ro_20;
  const double Ro_22a = KSL_MUL(R->m20, dc[0]), Ro_22b = KSL_MUL(R->m22, dc[1]),
      Ro_22 = Ro_22a + Ro_22b, Ro_22_right = Ro_22 - Ro_22a;
  const double Ro_00_rounded = Ro_00
          + (ksl_product_rest(R->m00, dc[1], Ro_00a, Ro_00 + Ro_00_right)
          - ksl_product_rest(R->m02, dc[0], Ro_00b, Ro_00_right)),
      Ro_02_rounded = Ro_02
          + (ksl_product_rest(R->m00, dc[0], Ro_02a, Ro_02 - Ro_02_right)
          + ksl_product_rest(R->m02, dc[1], Ro_02b, Ro_02_right)),
      Ro_10_rounded = Ro_10
          + (ksl_product_rest(R->m10, dc[1], Ro_10a, Ro_10 + Ro_10_right)
          - ksl_product_rest(R->m12, dc[0], Ro_10b, Ro_10_right)),
      Ro_12_rounded = Ro_12
          + (ksl_product_rest(R->m10, dc[0], Ro_12a, Ro_12 - Ro_12_right)
          + ksl_product_rest(R->m12, dc[1], Ro_12b, Ro_12_right)),
      Ro_20_rounded = Ro_20
          + (ksl_product_rest(R->m20, dc[1], Ro_20a, Ro_20 + Ro_20_right)
          - ksl_product_rest(R->m22, dc[0], Ro_20b, Ro_20_right)),
      Ro_22_rounded = Ro_22
          + (ksl_product_rest(R->m20, dc[0], Ro_22a, Ro_22 - Ro_22_right)
          + ksl_product_rest(R->m22, dc[1], Ro_22b, Ro_22_right));
  const double R_m01 = R->m01;
  const double R_m11 = R->m11;
  const double R_m21 = R->m21;
  Ro->m00 = Ro_00_rounded;
  Ro->m01 = R_m01;
  Ro->m02 = Ro_02_rounded;
  Ro->m10 = Ro_10_rounded;
  Ro->m11 = R_m11;
  Ro->m12 = Ro_12_rounded;
  Ro->m20 = Ro_20_rounded;
  Ro->m21 = R_m21;
  Ro->m22 = Ro_22_rounded;
}

/* Do = D [R_y(θ) | 0], dc = (sin θ, cos θ).
   D, Do: displacement [R | t], R rotation, t in m; dc: (sin θ, cos θ).
   12 mul, 30 add, 12 product rest.
   Error <= u |result| + (R: 6, t: 0) u^2 S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_ddry_accurate(const ksl_SE3_t *D, const double dc[2],
    ksl_SE3_t *Do) {
  const double Do_00a = KSL_MUL(D->m00, dc[1]), Do_00b = KSL_MUL(D->m02, dc[0]),
      Do_00 = Do_00a - Do_00b, Do_00_right = Do_00a - Do_00;
  const double Do_02a = KSL_MUL(D->m00, dc[0]), Do_02b = KSL_MUL(D->m02, dc[1]),
      Do_02 = Do_02a + Do_02b, Do_02_right = Do_02 - Do_02a;
  const double Do_10a = KSL_MUL(D->m10, dc[1]), Do_10b = KSL_MUL(D->m12, dc[0]),
      Do_10 = Do_10a - Do_10b, Do_10_right = Do_10a - Do_10;
  const double Do_12a = KSL_MUL(D->m10, dc[0]), Do_12b = KSL_MUL(D->m12, dc[1]),
      Do_12 = Do_12a + Do_12b, Do_12_right = Do_12 - Do_12a;
  const double Do_20a = KSL_MUL(D->m20, dc[1]), Do_20b = KSL_MUL(D->m22, dc[0]),
      Do_20 = Do_20a - Do_20b, Do_20_right = Do_20a - Do_20;
  const double Do_22a = KSL_MUL(D->m20, dc[0]), Do_22b = KSL_MUL(D->m22, dc[1]),
      Do_22 = Do_22a + Do_22b, Do_22_right = Do_22 - Do_22a;
  const double Do_00_rounded = Do_00
          + (ksl_product_rest(D->m00, dc[1], Do_00a, Do_00 + Do_00_right)
          - ksl_product_rest(D->m02, dc[0], Do_00b, Do_00_right)),
      Do_02_rounded = Do_02
          + (ksl_product_rest(D->m00, dc[0], Do_02a, Do_02 - Do_02_right)
          + ksl_product_rest(D->m02, dc[1], Do_02b, Do_02_right)),
      Do_10_rounded = Do_10
          + (ksl_product_rest(D->m10, dc[1], Do_10a, Do_10 + Do_10_right)
          - ksl_product_rest(D->m12, dc[0], Do_10b, Do_10_right)),
      Do_12_rounded = Do_12
          + (ksl_product_rest(D->m10, dc[0], Do_12a, Do_12 - Do_12_right)
          + ksl_product_rest(D->m12, dc[1], Do_12b, Do_12_right)),
      Do_20_rounded = Do_20
          + (ksl_product_rest(D->m20, dc[1], Do_20a, Do_20 + Do_20_right)
          - ksl_product_rest(D->m22, dc[0], Do_20b, Do_20_right)),
      Do_22_rounded = Do_22
          + (ksl_product_rest(D->m20, dc[0], Do_22a, Do_22 - Do_22_right)
          + ksl_product_rest(D->m22, dc[1], Do_22b, Do_22_right));
  const double D_m01 = D->m01;
  const double D_m03 = D->m03;
  const double D_m11 = D->m11;
  const double D_m13 = D->m13;
  const double D_m21 = D->m21;
  const double D_m23 = D->m23;
  Do->m00 = Do_00_rounded;
  Do->m01 = D_m01;
  Do->m02 = Do_02_rounded;
  Do->m03 = D_m03;
  Do->m10 = Do_10_rounded;
  Do->m11 = D_m11;
  Do->m12 = Do_12_rounded;
  Do->m13 = D_m13;
  Do->m20 = Do_20_rounded;
  Do->m21 = D_m21;
  Do->m22 = Do_22_rounded;
  Do->m23 = D_m23;
}

/* Do = D [I | k e_y].
   D, Do: displacement [R | t], R rotation, t in m; k: number.
   3 mul, 18 add, 3 product rest.
   Error <= u |result| + (R: 0, t: 3) u^2 S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_ddty_accurate(const ksl_SE3_t *D, const double k, ksl_SE3_t *Do) {
  const double Do_03a = KSL_MUL(D->m01, k), Do_03 = Do_03a + D->m03, Do_03_right = Do_03 - Do_03a;
  const double Do_13a = KSL_MUL(D->m11, k), Do_13 = Do_13a + D->m13, Do_13_right = Do_13 - Do_13a;
  const double Do_23a = KSL_MUL(D->m21, k), Do_23 = Do_23a + D->m23, Do_23_right = Do_23 - Do_23a;
  const double Do_03_rounded = Do_03
          + (ksl_product_rest(D->m01, k, Do_03a, Do_03 - Do_03_right) + (D->m03 - Do_03_right)),
      Do_13_rounded = Do_13
          + (ksl_product_rest(D->m11, k, Do_13a, Do_13 - Do_13_right) + (D->m13 - Do_13_right)),
      Do_23_rounded = Do_23
          + (ksl_product_rest(D->m21, k, Do_23a, Do_23 - Do_23_right) + (D->m23 - Do_23_right));
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
  Do->m03 = Do_03_rounded;
  Do->m10 = D_m10;
  Do->m11 = D_m11;
  Do->m12 = D_m12;
  Do->m13 = Do_13_rounded;
  Do->m20 = D_m20;
  Do->m21 = D_m21;
  Do->m22 = D_m22;
  Do->m23 = Do_23_rounded;
}

/* vo = R (-k e_y).
   R: rotation or other 3×3 matrix; k: number; vo: vector.
   3 mul, 3 add, 3 product error, 6 neg.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_product_drvtyinv_accurate(const ksl_mat3x3_t *R, const double k,
    ksl_vec3_t *vo) {
  const double vo_0 = -KSL_MUL(R->m01, k), vo_1 = -KSL_MUL(R->m11, k), vo_2 = -KSL_MUL(R->m21, k);
  const double vo_0_rounded = vo_0 + ksl_product_error(-R->m01, k, vo_0),
      vo_1_rounded = vo_1 + ksl_product_error(-R->m11, k, vo_1),
      vo_2_rounded = vo_2 + ksl_product_error(-R->m21, k, vo_2);
  vo->x = vo_0_rounded;
  vo->y = vo_1_rounded;
  vo->z = vo_2_rounded;
}

/* Ro = R R_y(-θ), dc = (sin θ, cos θ).
   R, Ro: rotation or other 3×3 matrix; dc: (sin θ, cos θ).
   12 mul, 30 add, 12 product rest.
   Error <= u |result| + 6 u^2 S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_product_drdryinv_accurate(const ksl_mat3x3_t *R, const double dc[2],
    ksl_mat3x3_t *Ro) {
  const double Ro_00a = KSL_MUL(R->m00, dc[1]), Ro_00b = KSL_MUL(R->m02, dc[0]),
      Ro_00 = Ro_00a + Ro_00b, Ro_00_right = Ro_00 - Ro_00a;
  const double Ro_02a = KSL_MUL(R->m02, dc[1]), Ro_02b = KSL_MUL(R->m00, dc[0]),
      Ro_02 = Ro_02a - Ro_02b, Ro_02_right = Ro_02a - Ro_02;
  const double Ro_10a = KSL_MUL(R->m10, dc[1]), Ro_10b = KSL_MUL(R->m12, dc[0]),
      Ro_10 = Ro_10a + Ro_10b, Ro_10_right = Ro_10 - Ro_10a;
  const double Ro_12a = KSL_MUL(R->m12, dc[1]), Ro_12b = KSL_MUL(R->m10, dc[0]),
      Ro_12 = Ro_12a - Ro_12b, Ro_12_right = Ro_12a - Ro_12;
  const double Ro_20a = KSL_MUL(R->m20, dc[1]), Ro_20b = KSL_MUL(R->m22, dc[0]),
      Ro_20 = Ro_20a + Ro_20b, Ro_20_right = Ro_20 - Ro_20a;
  const double Ro_22a = KSL_MUL(R->m22, dc[1]), Ro_22b = KSL_MUL(R->m20, dc[0]),
      Ro_22 = Ro_22a - Ro_22b, Ro_22_right = Ro_22a - Ro_22;
  const double Ro_00_rounded = Ro_00
          + (ksl_product_rest(R->m00, dc[1], Ro_00a, Ro_00 - Ro_00_right)
          + ksl_product_rest(R->m02, dc[0], Ro_00b, Ro_00_right)),
      Ro_02_rounded = Ro_02
          + (ksl_product_rest(R->m02, dc[1], Ro_02a, Ro_02 + Ro_02_right)
          - ksl_product_rest(R->m00, dc[0], Ro_02b, Ro_02_right)),
      Ro_10_rounded = Ro_10
          + (ksl_product_rest(R->m10, dc[1], Ro_10a, Ro_10 - Ro_10_right)
          + ksl_product_rest(R->m12, dc[0], Ro_10b, Ro_10_right)),
      Ro_12_rounded = Ro_12
          + (ksl_product_rest(R->m12, dc[1], Ro_12a, Ro_12 + Ro_12_right)
          - ksl_product_rest(R->m10, dc[0], Ro_12b, Ro_12_right)),
      Ro_20_rounded = Ro_20
          + (ksl_product_rest(R->m20, dc[1], Ro_20a, Ro_20 - Ro_20_right)
          + ksl_product_rest(R->m22, dc[0], Ro_20b, Ro_20_right)),
      Ro_22_rounded = Ro_22
          + (ksl_product_rest(R->m22, dc[1], Ro_22a, Ro_22 + Ro_22_right)
          - ksl_product_rest(R->m20, dc[0], Ro_22b, Ro_22_right));
  const double R_m01 = R->m01;
  const double R_m11 = R->m11;
  const double R_m21 = R->m21;
  Ro->m00 = Ro_00_rounded;
  Ro->m01 = R_m01;
  Ro->m02 = Ro_02_rounded;
  Ro->m10 = Ro_10_rounded;
  Ro->m11 = R_m11;
  Ro->m12 = Ro_12_rounded;
  Ro->m20 = Ro_20_rounded;
  Ro->m21 = R_m21;
  Ro->m22 = Ro_22_rounded;
}

/* Do = D [R_y(-θ) | 0], dc = (sin θ, cos θ).
   D, Do: displacement [R | t], R rotation, t in m; dc: (sin θ, cos θ).
   12 mul, 30 add, 12 product rest.
   Error <= u |result| + (R: 6, t: 0) u^2 S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_ddryinv_accurate(const ksl_SE3_t *D, const double dc[2],
    ksl_SE3_t *Do) {
  const double Do_00a = KSL_MUL(D->m00, dc[1]), Do_00b = KSL_MUL(D->m02, dc[0]),
      Do_00 = Do_00a + Do_00b, Do_00_right = Do_00 - Do_00a;
  const double Do_02a = KSL_MUL(D->m02, dc[1]), Do_02b = KSL_MUL(D->m00, dc[0]),
      Do_02 = Do_02a - Do_02b, Do_02_right = Do_02a - Do_02;
  const double Do_10a = KSL_MUL(D->m10, dc[1]), Do_10b = KSL_MUL(D->m12, dc[0]),
      Do_10 = Do_10a + Do_10b, Do_10_right = Do_10 - Do_10a;
  const double Do_12a = KSL_MUL(D->m12, dc[1]), Do_12b = KSL_MUL(D->m10, dc[0]),
      Do_12 = Do_12a - Do_12b, Do_12_right = Do_12a - Do_12;
  const double Do_20a = KSL_MUL(D->m20, dc[1]), Do_20b = KSL_MUL(D->m22, dc[0]),
      Do_20 = Do_20a + Do_20b, Do_20_right = Do_20 - Do_20a;
  const double Do_22a = KSL_MUL(D->m22, dc[1]), Do_22b = KSL_MUL(D->m20, dc[0]),
      Do_22 = Do_22a - Do_22b, Do_22_right = Do_22a - Do_22;
  const double Do_00_rounded = Do_00
          + (ksl_product_rest(D->m00, dc[1], Do_00a, Do_00 - Do_00_right)
          + ksl_product_rest(D->m02, dc[0], Do_00b, Do_00_right)),
      Do_02_rounded = Do_02
          + (ksl_product_rest(D->m02, dc[1], Do_02a, Do_02 + Do_02_right)
          - ksl_product_rest(D->m00, dc[0], Do_02b, Do_02_right)),
      Do_10_rounded = Do_10
          + (ksl_product_rest(D->m10, dc[1], Do_10a, Do_10 - Do_10_right)
          + ksl_product_rest(D->m12, dc[0], Do_10b, Do_10_right)),
      Do_12_rounded = Do_12
          + (ksl_product_rest(D->m12, dc[1], Do_12a, Do_12 + Do_12_right)
          - ksl_product_rest(D->m10, dc[0], Do_12b, Do_12_right)),
      Do_20_rounded = Do_20
          + (ksl_product_rest(D->m20, dc[1], Do_20a, Do_20 - Do_20_right)
          + ksl_product_rest(D->m22, dc[0], Do_20b, Do_20_right)),
      Do_22_rounded = Do_22
          + (ksl_product_rest(D->m22, dc[1], Do_22a, Do_22 + Do_22_right)
          - ksl_product_rest(D->m20, dc[0], Do_22b, Do_22_right));
  const double D_m01 = D->m01;
  const double D_m03 = D->m03;
  const double D_m11 = D->m11;
  const double D_m13 = D->m13;
  const double D_m21 = D->m21;
  const double D_m23 = D->m23;
  Do->m00 = Do_00_rounded;
  Do->m01 = D_m01;
  Do->m02 = Do_02_rounded;
  Do->m03 = D_m03;
  Do->m10 = Do_10_rounded;
  Do->m11 = D_m11;
  Do->m12 = Do_12_rounded;
  Do->m13 = D_m13;
  Do->m20 = Do_20_rounded;
  Do->m21 = D_m21;
  Do->m22 = Do_22_rounded;
  Do->m23 = D_m23;
}

/* Do = D [I | -k e_y].
   D, Do: displacement [R | t], R rotation, t in m; k: number.
   3 mul, 18 add, 3 product rest.
   Error <= u |result| + (R: 0, t: 5) u^2 S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_ddtyinv_accurate(const ksl_SE3_t *D, const double k, ksl_SE3_t *Do) {
  const double Do_03a = KSL_MUL(D->m01, k), Do_03 = D->m03 - Do_03a, Do_03_right = D->m03 - Do_03;
  const double Do_13a = KSL_MUL(D->m11, k), Do_13 = D->m13 - Do_13a, Do_13_right = D->m13 - Do_13;
  const double Do_23a = KSL_MUL(D->m21, k), Do_23 = D->m23 - Do_23a, Do_23_right = D->m23 - Do_23;
  const double Do_03_rounded = Do_03
          + (D->m03 - (Do_03 + Do_03_right) - ksl_product_rest(D->m01, k, Do_03a, Do_03_right)),
      Do_13_rounded = Do_13
          + (D->m13 - (Do_13 + Do_13_right) - ksl_product_rest(D->m11, k, Do_13a, Do_13_right)),
      Do_23_rounded = Do_23
          + (D->m23 - (Do_23 + Do_23_right) - ksl_product_rest(D->m21, k, Do_23a, Do_23_right));
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
  Do->m03 = Do_03_rounded;
  Do->m10 = D_m10;
  Do->m11 = D_m11;
  Do->m12 = D_m12;
  Do->m13 = Do_13_rounded;
  Do->m20 = D_m20;
  Do->m21 = D_m21;
  Do->m22 = D_m22;
  Do->m23 = Do_23_rounded;
}

/* vo = R (k e_z).
   R: rotation or other 3×3 matrix; k: number; vo: vector.
   3 mul, 3 add, 3 product error.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_product_drvtz_accurate(const ksl_mat3x3_t *R, const double k,
    ksl_vec3_t *vo) {
  const double vo_0 = KSL_MUL(R->m02, k), vo_1 = KSL_MUL(R->m12, k), vo_2 = KSL_MUL(R->m22, k);
  const double vo_0_rounded = vo_0 + ksl_product_error(R->m02, k, vo_0),
      vo_1_rounded = vo_1 + ksl_product_error(R->m12, k, vo_1),
      vo_2_rounded = vo_2 + ksl_product_error(R->m22, k, vo_2);
  vo->x = vo_0_rounded;
  vo->y = vo_1_rounded;
  vo->z = vo_2_rounded;
}

/* Ro = R R_z(θ), dc = (sin θ, cos θ).
   R, Ro: rotation or other 3×3 matrix; dc: (sin θ, cos θ).
   12 mul, 30 add, 12 product rest.
   Error <= u |result| + 6 u^2 S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_product_drdrz_accurate(const ksl_mat3x3_t *R, const double dc[2],
    ksl_mat3x3_t *Ro) {
  const double Ro_00a = KSL_MUL(R->m00, dc[1]), Ro_00b = KSL_MUL(R->m01, dc[0]),
      Ro_00 = Ro_00a + Ro_00b, Ro_00_right = Ro_00 - Ro_00a;
  const double Ro_01a = KSL_MUL(R->m01, dc[1]), Ro_01b = KSL_MUL(R->m00, dc[0]),
      Ro_01 = Ro_01a - Ro_01b, Ro_01_right = Ro_01a - Ro_01;
  const double Ro_10a = KSL_MUL(R->m10, dc[1]), Ro_10b = KSL_MUL(R->m11, dc[0]),
      Ro_10 = Ro_10a + Ro_10b, Ro_10_right = Ro_10 - Ro_10a;
  const double Ro_11a = KSL_MUL(R->m11, dc[1]), Ro_11b = KSL_MUL(R->m10, dc[0]),
      Ro_11 = Ro_11a - Ro_11b, Ro_11_right = Ro_11a - Ro_11;
  const double Ro_20a = KSL_MUL(R->m20, dc[1]), Ro_20b = KSL_MUL(R->m21, dc[0]),
      Ro_20 = Ro_20a + Ro_20b, Ro_20_right = Ro_20 - Ro_20a;
  const double Ro_21a = KSL_MUL(R->m21, dc[1]), Ro_21b = KSL_MUL(R->m20, dc[0]),
      Ro_21 = Ro_21a - Ro_21b, Ro_21_right = Ro_21a - Ro_21;
  const double Ro_00_rounded = Ro_00
          + (ksl_product_rest(R->m00, dc[1], Ro_00a, Ro_00 - Ro_00_right)
          + ksl_product_rest(R->m01, dc[0], Ro_00b, Ro_00_right)),
      Ro_01_rounded = Ro_01
          + (ksl_product_rest(R->m01, dc[1], Ro_01a, Ro_01 + Ro_01_right)
          - ksl_product_rest(R->m00, dc[0], Ro_01b, Ro_01_right)),
      Ro_10_rounded = Ro_10
          + (ksl_product_rest(R->m10, dc[1], Ro_10a, Ro_10 - Ro_10_right)
          + ksl_product_rest(R->m11, dc[0], Ro_10b, Ro_10_right)),
      Ro_11_rounded = Ro_11
          + (ksl_product_rest(R->m11, dc[1], Ro_11a, Ro_11 + Ro_11_right)
          - ksl_product_rest(R->m10, dc[0], Ro_11b, Ro_11_right)),
      Ro_20_rounded = Ro_20
          + (ksl_product_rest(R->m20, dc[1], Ro_20a, Ro_20 - Ro_20_right)
          + ksl_product_rest(R->m21, dc[0], Ro_20b, Ro_20_right)),
      Ro_21_rounded = Ro_21
          + (ksl_product_rest(R->m21, dc[1], Ro_21a, Ro_21 + Ro_21_right)
          - ksl_product_rest(R->m20, dc[0], Ro_21b, Ro_21_right));
  const double R_m02 = R->m02;
  const double R_m12 = R->m12;
  const double R_m22 = R->m22;
  Ro->m00 = Ro_00_rounded;
  Ro->m01 = Ro_01_rounded;
  Ro->m02 = R_m02;
  Ro->m10 = Ro_10_rounded;
  Ro->m11 = Ro_11_rounded;
  Ro->m12 = R_m12;
  Ro->m20 = Ro_20_rounded;
  Ro->m21 = Ro_21_rounded;
  Ro->m22 = R_m22;
}

/* Do = D [R_z(θ) | 0], dc = (sin θ, cos θ).
   D, Do: displacement [R | t], R rotation, t in m; dc: (sin θ, cos θ).
   12 mul, 30 add, 12 product rest.
   Error <= u |result| + (R: 6, t: 0) u^2 S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_ddrz_accurate(const ksl_SE3_t *D, const double dc[2],
    ksl_SE3_t *Do) {
  const double Do_00a = KSL_MUL(D->m00, dc[1]), Do_00b = KSL_MUL(D->m01, dc[0]),
      Do_00 = Do_00a + Do_00b, Do_00_right = Do_00 - Do_00a;
  const double Do_01a = KSL_MUL(D->m01, dc[1]), Do_01b = KSL_MUL(D->m00, dc[0]),
      Do_01 = Do_01a - Do_01b, Do_01_right = Do_01a - Do_01;
  const double Do_10a = KSL_MUL(D->m10, dc[1]), Do_10b = KSL_MUL(D->m11, dc[0]),
      Do_10 = Do_10a + Do_10b, Do_10_right = Do_10 - Do_10a;
  const double Do_11a = KSL_MUL(D->m11, dc[1]), Do_11b = KSL_MUL(D->m10, dc[0]),
      Do_11 = Do_11a - Do_11b, Do_11_right = Do_11a - Do_11;
  const double Do_20a = KSL_MUL(D->m20, dc[1]), Do_20b = KSL_MUL(D->m21, dc[0]),
      Do_20 = Do_20a + Do_20b, Do_20_right = Do_20 - Do_20a;
  const double Do_21a = KSL_MUL(D->m21, dc[1]), Do_21b = KSL_MUL(D->m20, dc[0]),
      Do_21 = Do_21a - Do_21b, Do_21_right = Do_21a - Do_21;
  const double Do_00_rounded = Do_00
          + (ksl_product_rest(D->m00, dc[1], Do_00a, Do_00 - Do_00_right)
          + ksl_product_rest(D->m01, dc[0], Do_00b, Do_00_right)),
      Do_01_rounded = Do_01
          + (ksl_product_rest(D->m01, dc[1], Do_01a, Do_01 + Do_01_right)
          - ksl_product_rest(D->m00, dc[0], Do_01b, Do_01_right)),
      Do_10_rounded = Do_10
          + (ksl_product_rest(D->m10, dc[1], Do_10a, Do_10 - Do_10_right)
          + ksl_product_rest(D->m11, dc[0], Do_10b, Do_10_right)),
      Do_11_rounded = Do_11
          + (ksl_product_rest(D->m11, dc[1], Do_11a, Do_11 + Do_11_right)
          - ksl_product_rest(D->m10, dc[0], Do_11b, Do_11_right)),
      Do_20_rounded = Do_20
          + (ksl_product_rest(D->m20, dc[1], Do_20a, Do_20 - Do_20_right)
          + ksl_product_rest(D->m21, dc[0], Do_20b, Do_20_right)),
      Do_21_rounded = Do_21
          + (ksl_product_rest(D->m21, dc[1], Do_21a, Do_21 + Do_21_right)
          - ksl_product_rest(D->m20, dc[0], Do_21b, Do_21_right));
  const double D_m02 = D->m02;
  const double D_m03 = D->m03;
  const double D_m12 = D->m12;
  const double D_m13 = D->m13;
  const double D_m22 = D->m22;
  const double D_m23 = D->m23;
  Do->m00 = Do_00_rounded;
  Do->m01 = Do_01_rounded;
  Do->m02 = D_m02;
  Do->m03 = D_m03;
  Do->m10 = Do_10_rounded;
  Do->m11 = Do_11_rounded;
  Do->m12 = D_m12;
  Do->m13 = D_m13;
  Do->m20 = Do_20_rounded;
  Do->m21 = Do_21_rounded;
  Do->m22 = D_m22;
  Do->m23 = D_m23;
}

/* Do = D [I | k e_z].
   D, Do: displacement [R | t], R rotation, t in m; k: number.
   3 mul, 18 add, 3 product rest.
   Error <= u |result| + (R: 0, t: 3) u^2 S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_ddtz_accurate(const ksl_SE3_t *D, const double k, ksl_SE3_t *Do) {
  const double Do_03a = KSL_MUL(D->m02, k), Do_03 = Do_03a + D->m03, Do_03_right = Do_03 - Do_03a;
  const double Do_13a = KSL_MUL(D->m12, k), Do_13 = Do_13a + D->m13, Do_13_right = Do_13 - Do_13a;
  const double Do_23a = KSL_MUL(D->m22, k), Do_23 = Do_23a + D->m23, Do_23_right = Do_23 - Do_23a;
  const double Do_03_rounded = Do_03
          + (ksl_product_rest(D->m02, k, Do_03a, Do_03 - Do_03_right) + (D->m03 - Do_03_right)),
      Do_13_rounded = Do_13
          + (ksl_product_rest(D->m12, k, Do_13a, Do_13 - Do_13_right) + (D->m13 - Do_13_right)),
      Do_23_rounded = Do_23
          + (ksl_product_rest(D->m22, k, Do_23a, Do_23 - Do_23_right) + (D->m23 - Do_23_right));
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
  Do->m03 = Do_03_rounded;
  Do->m10 = D_m10;
  Do->m11 = D_m11;
  Do->m12 = D_m12;
  Do->m13 = Do_13_rounded;
  Do->m20 = D_m20;
  Do->m21 = D_m21;
  Do->m22 = D_m22;
  Do->m23 = Do_23_rounded;
}

/* vo = R (-k e_z).
   R: rotation or other 3×3 matrix; k: number; vo: vector.
   3 mul, 3 add, 3 product error, 6 neg.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_product_drvtzinv_accurate(const ksl_mat3x3_t *R, const double k,
    ksl_vec3_t *vo) {
  const double vo_0 = -KSL_MUL(R->m02, k), vo_1 = -KSL_MUL(R->m12, k), vo_2 = -KSL_MUL(R->m22, k);
  const double vo_0_rounded = vo_0 + ksl_product_error(-R->m02, k, vo_0),
      vo_1_rounded = vo_1 + ksl_product_error(-R->m12, k, vo_1),
      vo_2_rounded = vo_2 + ksl_product_error(-R->m22, k, vo_2);
  vo->x = vo_0_rounded;
  vo->y = vo_1_rounded;
  vo->z = vo_2_rounded;
}

/* Ro = R R_z(-θ), dc = (sin θ, cos θ).
   R, Ro: rotation or other 3×3 matrix; dc: (sin θ, cos θ).
   12 mul, 30 add, 12 product rest.
   Error <= u |result| + 6 u^2 S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_product_drdrzinv_accurate(const ksl_mat3x3_t *R, const double dc[2],
    ksl_mat3x3_t *Ro) {
  const double Ro_00a = KSL_MUL(R->m00, dc[1]), Ro_00b = KSL_MUL(R->m01, dc[0]),
      Ro_00 = Ro_00a - Ro_00b, Ro_00_right = Ro_00a - Ro_00;
  const double Ro_01a = KSL_MUL(R->m00, dc[0]), Ro_01b = KSL_MUL(R->m01, dc[1]),
      Ro_01 = Ro_01a + Ro_01b, Ro_01_right = Ro_01 - Ro_01a;
  const double Ro_10a = KSL_MUL(R->m10, dc[1]), Ro_10b = KSL_MUL(R->m11, dc[0]),
      Ro_10 = Ro_10a - Ro_10b, Ro_10_right = Ro_10a - Ro_10;
  const double Ro_11a = KSL_MUL(R->m10, dc[0]), Ro_11b = KSL_MUL(R->m11, dc[1]),
      Ro_11 = Ro_11a + Ro_11b, Ro_11_right = Ro_11 - Ro_11a;
  const double Ro_20a = KSL_MUL(R->m20, dc[1]), Ro_20b = KSL_MUL(R->m21, dc[0]),
      Ro_20 = Ro_20a - Ro_20b, Ro_20_right = Ro_20a - Ro_20;
  const double Ro_21a = KSL_MUL(R->m20, dc[0]), Ro_21b = KSL_MUL(R->m21, dc[1]),
      Ro_21 = Ro_21a + Ro_21b, Ro_21_right = Ro_21 - Ro_21a;
  const double Ro_00_rounded = Ro_00
          + (ksl_product_rest(R->m00, dc[1], Ro_00a, Ro_00 + Ro_00_right)
          - ksl_product_rest(R->m01, dc[0], Ro_00b, Ro_00_right)),
      Ro_01_rounded = Ro_01
          + (ksl_product_rest(R->m00, dc[0], Ro_01a, Ro_01 - Ro_01_right)
          + ksl_product_rest(R->m01, dc[1], Ro_01b, Ro_01_right)),
      Ro_10_rounded = Ro_10
          + (ksl_product_rest(R->m10, dc[1], Ro_10a, Ro_10 + Ro_10_right)
          - ksl_product_rest(R->m11, dc[0], Ro_10b, Ro_10_right)),
      Ro_11_rounded = Ro_11
          + (ksl_product_rest(R->m10, dc[0], Ro_11a, Ro_11 - Ro_11_right)
          + ksl_product_rest(R->m11, dc[1], Ro_11b, Ro_11_right)),
      Ro_20_rounded = Ro_20
          + (ksl_product_rest(R->m20, dc[1], Ro_20a, Ro_20 + Ro_20_right)
          - ksl_product_rest(R->m21, dc[0], Ro_20b, Ro_20_right)),
      Ro_21_rounded = Ro_21
          + (ksl_product_rest(R->m20, dc[0], Ro_21a, Ro_21 - Ro_21_right)
          + ksl_product_rest(R->m21, dc[1], Ro_21b, Ro_21_right));
  const double R_m02 = R->m02;
  const double R_m12 = R->m12;
  const double R_m22 = R->m22;
  Ro->m00 = Ro_00_rounded;
  Ro->m01 = Ro_01_rounded;
  Ro->m02 = R_m02;
  Ro->m10 = Ro_10_rounded;
  Ro->m11 = Ro_11_rounded;
  Ro->m12 = R_m12;
  Ro->m20 = Ro_20_rounded;
  Ro->m21 = Ro_21_rounded;
  Ro->m22 = R_m22;
}

/* Do = D [R_z(-θ) | 0], dc = (sin θ, cos θ).
   D, Do: displacement [R | t], R rotation, t in m; dc: (sin θ, cos θ).
   12 mul, 30 add, 12 product rest.
   Error <= u |result| + (R: 6, t: 0) u^2 S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_ddrzinv_accurate(const ksl_SE3_t *D, const double dc[2],
    ksl_SE3_t *Do) {
  const double Do_00a = KSL_MUL(D->m00, dc[1]), Do_00b = KSL_MUL(D->m01, dc[0]),
      Do_00 = Do_00a - Do_00b, Do_00_right = Do_00a - Do_00;
  const double Do_01a = KSL_MUL(D->m00, dc[0]), Do_01b = KSL_MUL(D->m01, dc[1]),
      Do_01 = Do_01a + Do_01b, Do_01_right = Do_01 - Do_01a;
  const double Do_10a = KSL_MUL(D->m10, dc[1]), Do_10b = KSL_MUL(D->m11, dc[0]),
      Do_10 = Do_10a - Do_10b, Do_10_right = Do_10a - Do_10;
  const double Do_11a = KSL_MUL(D->m10, dc[0]), Do_11b = KSL_MUL(D->m11, dc[1]),
      Do_11 = Do_11a + Do_11b, Do_11_right = Do_11 - Do_11a;
  const double Do_20a = KSL_MUL(D->m20, dc[1]), Do_20b = KSL_MUL(D->m21, dc[0]),
      Do_20 = Do_20a - Do_20b, Do_20_right = Do_20a - Do_20;
  const double Do_21a = KSL_MUL(D->m20, dc[0]), Do_21b = KSL_MUL(D->m21, dc[1]),
      Do_21 = Do_21a + Do_21b, Do_21_right = Do_21 - Do_21a;
  const double Do_00_rounded = Do_00
          + (ksl_product_rest(D->m00, dc[1], Do_00a, Do_00 + Do_00_right)
          - ksl_product_rest(D->m01, dc[0], Do_00b, Do_00_right)),
      Do_01_rounded = Do_01
          + (ksl_product_rest(D->m00, dc[0], Do_01a, Do_01 - Do_01_right)
          + ksl_product_rest(D->m01, dc[1], Do_01b, Do_01_right)),
      Do_10_rounded = Do_10
          + (ksl_product_rest(D->m10, dc[1], Do_10a, Do_10 + Do_10_right)
          - ksl_product_rest(D->m11, dc[0], Do_10b, Do_10_right)),
      Do_11_rounded = Do_11
          + (ksl_product_rest(D->m10, dc[0], Do_11a, Do_11 - Do_11_right)
          + ksl_product_rest(D->m11, dc[1], Do_11b, Do_11_right)),
      Do_20_rounded = Do_20
          + (ksl_product_rest(D->m20, dc[1], Do_20a, Do_20 + Do_20_right)
          - ksl_product_rest(D->m21, dc[0], Do_20b, Do_20_right)),
      Do_21_rounded = Do_21
          + (ksl_product_rest(D->m20, dc[0], Do_21a, Do_21 - Do_21_right)
          + ksl_product_rest(D->m21, dc[1], Do_21b, Do_21_right));
  const double D_m02 = D->m02;
  const double D_m03 = D->m03;
  const double D_m12 = D->m12;
  const double D_m13 = D->m13;
  const double D_m22 = D->m22;
  const double D_m23 = D->m23;
  Do->m00 = Do_00_rounded;
  Do->m01 = Do_01_rounded;
  Do->m02 = D_m02;
  Do->m03 = D_m03;
  Do->m10 = Do_10_rounded;
  Do->m11 = Do_11_rounded;
  Do->m12 = D_m12;
  Do->m13 = D_m13;
  Do->m20 = Do_20_rounded;
  Do->m21 = Do_21_rounded;
  Do->m22 = D_m22;
  Do->m23 = D_m23;
}

/* Do = D [I | -k e_z].
   D, Do: displacement [R | t], R rotation, t in m; k: number.
   3 mul, 18 add, 3 product rest.
   Error <= u |result| + (R: 0, t: 5) u^2 S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_ddtzinv_accurate(const ksl_SE3_t *D, const double k, ksl_SE3_t *Do) {
  const double Do_03a = KSL_MUL(D->m02, k), Do_03 = D->m03 - Do_03a, Do_03_right = D->m03 - Do_03;
  const double Do_13a = KSL_MUL(D->m12, k), Do_13 = D->m13 - Do_13a, Do_13_right = D->m13 - Do_13;
  const double Do_23a = KSL_MUL(D->m22, k), Do_23 = D->m23 - Do_23a, Do_23_right = D->m23 - Do_23;
  const double Do_03_rounded = Do_03
          + (D->m03 - (Do_03 + Do_03_right) - ksl_product_rest(D->m02, k, Do_03a, Do_03_right)),
      Do_13_rounded = Do_13
          + (D->m13 - (Do_13 + Do_13_right) - ksl_product_rest(D->m12, k, Do_13a, Do_13_right)),
      Do_23_rounded = Do_23
          + (D->m23 - (Do_23 + Do_23_right) - ksl_product_rest(D->m22, k, Do_23a, Do_23_right));
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
  Do->m03 = Do_03_rounded;
  Do->m10 = D_m10;
  Do->m11 = D_m11;
  Do->m12 = D_m12;
  Do->m13 = Do_13_rounded;
  Do->m20 = D_m20;
  Do->m21 = D_m21;
  Do->m22 = D_m22;
  Do->m23 = Do_23_rounded;
}

/* vo = R v.
   R: rotation or other 3×3 matrix; v, vo: vector.
   9 mul, 6 add.
   Error <= u |result| + 3/32 u^2 S, S the sum of the |terms| of the expanded formula; barring
     over- and underflow. */
static inline void ksl_product_drvf_accurate(const ksl_mat3x3f_t *R, const ksl_vec3f_t *v,
    ksl_vec3f_t *vo) {
  const double vo_0 = ksl_product_sum((double)R->m02, (double)v->z, ksl_product_sum((double)R->m01,
      (double)v->y, (double)R->m00 * (double)v->x)),
      vo_1 = ksl_product_sum((double)R->m12, (double)v->z, ksl_product_sum((double)R->m11,
          (double)v->y, (double)R->m10 * (double)v->x)),
      vo_2 = ksl_product_sum((double)R->m22, (double)v->z, ksl_product_sum((double)R->m21,
          (double)v->y, (double)R->m20 * (double)v->x));
  vo->x = (float)vo_0;
  vo->y = (float)vo_1;
  vo->z = (float)vo_2;
}

/* vo = R (-v).
   R: rotation or other 3×3 matrix; v, vo: vector.
   9 mul, 6 add, 3 neg.
   Error <= u |result| + 3/32 u^2 S, S the sum of the |terms| of the expanded formula; barring
     over- and underflow. */
static inline void ksl_product_drvinvf_accurate(const ksl_mat3x3f_t *R, const ksl_vec3f_t *v,
    ksl_vec3f_t *vo) {
  const double vo_0 = ksl_product_sum(-(double)R->m02, (double)v->z,
      ksl_product_sum(-(double)R->m01, (double)v->y, -((double)R->m00 * (double)v->x))),
      vo_1 = ksl_product_sum(-(double)R->m12, (double)v->z, ksl_product_sum(-(double)R->m11,
          (double)v->y, -((double)R->m10 * (double)v->x))),
      vo_2 = ksl_product_sum(-(double)R->m22, (double)v->z, ksl_product_sum(-(double)R->m21,
          (double)v->y, -((double)R->m20 * (double)v->x)));
  vo->x = (float)vo_0;
  vo->y = (float)vo_1;
  vo->z = (float)vo_2;
}

/* vo = R^T v.
   R: rotation or other 3×3 matrix; v, vo: vector.
   9 mul, 6 add.
   Error <= u |result| + 3/32 u^2 S, S the sum of the |terms| of the expanded formula; barring
     over- and underflow. */
static inline void ksl_product_drinvvf_accurate(const ksl_mat3x3f_t *R, const ksl_vec3f_t *v,
    ksl_vec3f_t *vo) {
  const double vo_0 = ksl_product_sum((double)R->m20, (double)v->z, ksl_product_sum((double)R->m10,
      (double)v->y, (double)R->m00 * (double)v->x)),
      vo_1 = ksl_product_sum((double)R->m21, (double)v->z, ksl_product_sum((double)R->m11,
          (double)v->y, (double)R->m01 * (double)v->x)),
      vo_2 = ksl_product_sum((double)R->m22, (double)v->z, ksl_product_sum((double)R->m12,
          (double)v->y, (double)R->m02 * (double)v->x));
  vo->x = (float)vo_0;
  vo->y = (float)vo_1;
  vo->z = (float)vo_2;
}

/* vo = R^T (-v).
   R: rotation or other 3×3 matrix; v, vo: vector.
   9 mul, 6 add, 3 neg.
   Error <= u |result| + 3/32 u^2 S, S the sum of the |terms| of the expanded formula; barring
     over- and underflow. */
static inline void ksl_product_drinvvinvf_accurate(const ksl_mat3x3f_t *R, const ksl_vec3f_t *v,
    ksl_vec3f_t *vo) {
  const double vo_0 = ksl_product_sum(-(double)R->m20, (double)v->z,
      ksl_product_sum(-(double)R->m10, (double)v->y, -((double)R->m00 * (double)v->x))),
      vo_1 = ksl_product_sum(-(double)R->m21, (double)v->z, ksl_product_sum(-(double)R->m11,
          (double)v->y, -((double)R->m01 * (double)v->x))),
      vo_2 = ksl_product_sum(-(double)R->m22, (double)v->z, ksl_product_sum(-(double)R->m12,
          (double)v->y, -((double)R->m02 * (double)v->x)));
  vo->x = (float)vo_0;
  vo->y = (float)vo_1;
  vo->z = (float)vo_2;
}

/* vo = R v + t.
   D: displacement [R | t], R rotation, t in m; v, vo: vector.
   9 mul, 9 add.
   Error <= u |result| + 1/8 u^2 S, S the sum of the |terms| of the expanded formula; barring
     over- and underflow. */
static inline void ksl_product_dvf_accurate(const ksl_SE3f_t *D, const ksl_vec3f_t *v,
    ksl_vec3f_t *vo) {
  const double vo_0 = ksl_product_sum((double)D->m02, (double)v->z, ksl_product_sum((double)D->m01,
      (double)v->y, (double)D->m00 * (double)v->x)) + (double)D->m03,
      vo_1 = ksl_product_sum((double)D->m12, (double)v->z, ksl_product_sum((double)D->m11,
          (double)v->y, (double)D->m10 * (double)v->x)) + (double)D->m13,
      vo_2 = ksl_product_sum((double)D->m22, (double)v->z, ksl_product_sum((double)D->m21,
          (double)v->y, (double)D->m20 * (double)v->x)) + (double)D->m23;
  vo->x = (float)vo_0;
  vo->y = (float)vo_1;
  vo->z = (float)vo_2;
}

/* vo = R^T (v - t).
   D: displacement [R | t], R rotation, t in m; v, vo: vector.
   9 mul, 9 add.
   Error <= u |result| + 1/8 u^2 S, S the sum of the |terms| of the expanded formula; barring
     over- and underflow. */
static inline void ksl_product_dinvvf_accurate(const ksl_SE3f_t *D, const ksl_vec3f_t *v,
    ksl_vec3f_t *vo) {
  const double p_0 = (double)v->x - (double)D->m03, p_1 = (double)v->y - (double)D->m13,
      p_2 = (double)v->z - (double)D->m23;
  const double vo_0 = KSL_MUL((double)D->m00, p_0) + KSL_MUL((double)D->m10, p_1)
          + KSL_MUL((double)D->m20, p_2),
      vo_1 = KSL_MUL((double)D->m01, p_0) + KSL_MUL((double)D->m11, p_1)
          + KSL_MUL((double)D->m21, p_2),
      vo_2 = KSL_MUL((double)D->m02, p_0) + KSL_MUL((double)D->m12, p_1)
          + KSL_MUL((double)D->m22, p_2);
  vo->x = (float)vo_0;
  vo->y = (float)vo_1;
  vo->z = (float)vo_2;
}

/* Ro = R1 R2.
   R1, R2, Ro: rotation or other 3×3 matrix.
   27 mul, 18 add.
   Error <= u |result| + 3/32 u^2 S, S the sum of the |terms| of the expanded formula; barring
     over- and underflow. */
static inline void ksl_product_drdrf_accurate(const ksl_mat3x3f_t *R1, const ksl_mat3x3f_t *R2,
    ksl_mat3x3f_t *Ro) {
  const double Ro_00 = ksl_product_sum((double)R1->m02, (double)R2->m20,
      ksl_product_sum((double)R1->m01, (double)R2->m10, (double)R1->m00 * (double)R2->m00)),
      Ro_01 = ksl_product_sum((double)R1->m02, (double)R2->m21, ksl_product_sum((double)R1->m01,
          (double)R2->m11, (double)R1->m00 * (double)R2->m01)),
      Ro_02 = ksl_product_sum((double)R1->m02, (double)R2->m22, ksl_product_sum((double)R1->m01,
          (double)R2->m12, (double)R1->m00 * (double)R2->m02)),
      Ro_10 = ksl_product_sum((double)R1->m12, (double)R2->m20, ksl_product_sum((double)R1->m11,
          (double)R2->m10, (double)R1->m10 * (double)R2->m00)),
      Ro_11 = ksl_product_sum((double)R1->m12, (double)R2->m21, ksl_product_sum((double)R1->m11,
          (double)R2->m11, (double)R1->m10 * (double)R2->m01)),
      Ro_12 = ksl_product_sum((double)R1->m12, (double)R2->m22, ksl_product_sum((double)R1->m11,
          (double)R2->m12, (double)R1->m10 * (double)R2->m02)),
      Ro_20 = ksl_product_sum((double)R1->m22, (double)R2->m20, ksl_product_sum((double)R1->m21,
          (double)R2->m10, (double)R1->m20 * (double)R2->m00)),
      Ro_21 = ksl_product_sum((double)R1->m22, (double)R2->m21, ksl_product_sum((double)R1->m21,
          (double)R2->m11, (double)R1->m20 * (double)R2->m01)),
      Ro_22 = ksl_product_sum((double)R1->m22, (double)R2->m22, ksl_product_sum((double)R1->m21,
          (double)R2->m12, (double)R1->m20 * (double)R2->m02));
  Ro->m00 = (float)Ro_00;
  Ro->m01 = (float)Ro_01;
  Ro->m02 = (float)Ro_02;
  Ro->m10 = (float)Ro_10;
  Ro->m11 = (float)Ro_11;
  Ro->m12 = (float)Ro_12;
  Ro->m20 = (float)Ro_20;
  Ro->m21 = (float)Ro_21;
  Ro->m22 = (float)Ro_22;
}

/* Ro = R1 R2^T.
   R1, R2, Ro: rotation or other 3×3 matrix.
   27 mul, 18 add.
   Error <= u |result| + 3/32 u^2 S, S the sum of the |terms| of the expanded formula; barring
     over- and underflow. */
static inline void ksl_product_drdrinvf_accurate(const ksl_mat3x3f_t *R1, const ksl_mat3x3f_t *R2,
    ksl_mat3x3f_t *Ro) {
  const double Ro_00 = ksl_product_sum((double)R1->m02, (double)R2->m02,
      ksl_product_sum((double)R1->m01, (double)R2->m01, (double)R1->m00 * (double)R2->m00)),
      Ro_01 = ksl_product_sum((double)R1->m02, (double)R2->m12, ksl_product_sum((double)R1->m01,
          (double)R2->m11, (double)R1->m00 * (double)R2->m10)),
      Ro_02 = ksl_product_sum((double)R1->m02, (double)R2->m22, ksl_product_sum((double)R1->m01,
          (double)R2->m21, (double)R1->m00 * (double)R2->m20)),
      Ro_10 = ksl_product_sum((double)R1->m12, (double)R2->m02, ksl_product_sum((double)R1->m11,
          (double)R2->m01, (double)R1->m10 * (double)R2->m00)),
      Ro_11 = ksl_product_sum((double)R1->m12, (double)R2->m12, ksl_product_sum((double)R1->m11,
          (double)R2->m11, (double)R1->m10 * (double)R2->m10)),
      Ro_12 = ksl_product_sum((double)R1->m12, (double)R2->m22, ksl_product_sum((double)R1->m11,
          (double)R2->m21, (double)R1->m10 * (double)R2->m20)),
      Ro_20 = ksl_product_sum((double)R1->m22, (double)R2->m02, ksl_product_sum((double)R1->m21,
          (double)R2->m01, (double)R1->m20 * (double)R2->m00)),
      Ro_21 = ksl_product_sum((double)R1->m22, (double)R2->m12, ksl_product_sum((double)R1->m21,
          (double)R2->m11, (double)R1->m20 * (double)R2->m10)),
      Ro_22 = ksl_product_sum((double)R1->m22, (double)R2->m22, ksl_product_sum((double)R1->m21,
          (double)R2->m21, (double)R1->m20 * (double)R2->m20));
  Ro->m00 = (float)Ro_00;
  Ro->m01 = (float)Ro_01;
  Ro->m02 = (float)Ro_02;
  Ro->m10 = (float)Ro_10;
  Ro->m11 = (float)Ro_11;
  Ro->m12 = (float)Ro_12;
  Ro->m20 = (float)Ro_20;
  Ro->m21 = (float)Ro_21;
  Ro->m22 = (float)Ro_22;
}

/* Ro = R1^T R2.
   R1, R2, Ro: rotation or other 3×3 matrix.
   27 mul, 18 add.
   Error <= u |result| + 3/32 u^2 S, S the sum of the |terms| of the expanded formula; barring
     over- and underflow. */
static inline void ksl_product_drinvdrf_accurate(const ksl_mat3x3f_t *R1, const ksl_mat3x3f_t *R2,
    ksl_mat3x3f_t *Ro) {
  const double Ro_00 = ksl_product_sum((double)R1->m20, (double)R2->m20,
      ksl_product_sum((double)R1->m10, (double)R2->m10, (double)R1->m00 * (double)R2->m00)),
      Ro_01 = ksl_product_sum((double)R1->m20, (double)R2->m21, ksl_product_sum((double)R1->m10,
          (double)R2->m11, (double)R1->m00 * (double)R2->m01)),
      Ro_02 = ksl_product_sum((double)R1->m20, (double)R2->m22, ksl_product_sum((double)R1->m10,
          (double)R2->m12, (double)R1->m00 * (double)R2->m02)),
      Ro_10 = ksl_product_sum((double)R1->m21, (double)R2->m20, ksl_product_sum((double)R1->m11,
          (double)R2->m10, (double)R1->m01 * (double)R2->m00)),
      Ro_11 = ksl_product_sum((double)R1->m21, (double)R2->m21, ksl_product_sum((double)R1->m11,
          (double)R2->m11, (double)R1->m01 * (double)R2->m01)),
      Ro_12 = ksl_product_sum((double)R1->m21, (double)R2->m22, ksl_product_sum((double)R1->m11,
          (double)R2->m12, (double)R1->m01 * (double)R2->m02)),
      Ro_20 = ksl_product_sum((double)R1->m22, (double)R2->m20, ksl_product_sum((double)R1->m12,
          (double)R2->m10, (double)R1->m02 * (double)R2->m00)),
      Ro_21 = ksl_product_sum((double)R1->m22, (double)R2->m21, ksl_product_sum((double)R1->m12,
          (double)R2->m11, (double)R1->m02 * (double)R2->m01)),
      Ro_22 = ksl_product_sum((double)R1->m22, (double)R2->m22, ksl_product_sum((double)R1->m12,
          (double)R2->m12, (double)R1->m02 * (double)R2->m02));
  Ro->m00 = (float)Ro_00;
  Ro->m01 = (float)Ro_01;
  Ro->m02 = (float)Ro_02;
  Ro->m10 = (float)Ro_10;
  Ro->m11 = (float)Ro_11;
  Ro->m12 = (float)Ro_12;
  Ro->m20 = (float)Ro_20;
  Ro->m21 = (float)Ro_21;
  Ro->m22 = (float)Ro_22;
}

/* Do = D1 D2 = [R1 R2 | R1 t2 + t1].
   D1, D2, Do: displacement [R | t], R rotation, t in m.
   36 mul, 27 add.
   Error <= u |result| + (R: 3/32, t: 1/8) u^2 S, S the sum of the |terms| of the expanded
     formula; barring over- and underflow. */
static inline void ksl_product_ddf_accurate(const ksl_SE3f_t *D1, const ksl_SE3f_t *D2,
    ksl_SE3f_t *Do) {
  const double Do_00 = ksl_product_sum((double)D1->m02, (double)D2->m20,
      ksl_product_sum((double)D1->m01, (double)D2->m10, (double)D1->m00 * (double)D2->m00)),
      Do_01 = ksl_product_sum((double)D1->m02, (double)D2->m21, ksl_product_sum((double)D1->m01,
          (double)D2->m11, (double)D1->m00 * (double)D2->m01)),
      Do_02 = ksl_product_sum((double)D1->m02, (double)D2->m22, ksl_product_sum((double)D1->m01,
          (double)D2->m12, (double)D1->m00 * (double)D2->m02));
  const double Do_03e = ksl_product_sum((double)D1->m02, (double)D2->m23,
      ksl_product_sum((double)D1->m01, (double)D2->m13, (double)D1->m00 * (double)D2->m03)),
      Do_03 = Do_03e + (double)D1->m03;
  const double Do_10 = ksl_product_sum((double)D1->m12, (double)D2->m20,
      ksl_product_sum((double)D1->m11, (double)D2->m10, (double)D1->m10 * (double)D2->m00)),
      Do_11 = ksl_product_sum((double)D1->m12, (double)D2->m21, ksl_product_sum((double)D1->m11,
          (double)D2->m11, (double)D1->m10 * (double)D2->m01)),
      Do_12 = ksl_product_sum((double)D1->m12, (double)D2->m22, ksl_product_sum((double)D1->m11,
          (double)D2->m12, (double)D1->m10 * (double)D2->m02));
  const double Do_13e = ksl_product_sum((double)D1->m12, (double)D2->m23,
      ksl_product_sum((double)D1->m11, (double)D2->m13, (double)D1->m10 * (double)D2->m03)),
      Do_13 = Do_13e + (double)D1->m13;
  const double Do_20 = ksl_product_sum((double)D1->m22, (double)D2->m20,
      ksl_product_sum((double)D1->m21, (double)D2->m10, (double)D1->m20 * (double)D2->m00)),
      Do_21 = ksl_product_sum((double)D1->m22, (double)D2->m21, ksl_product_sum((double)D1->m21,
          (double)D2->m11, (double)D1->m20 * (double)D2->m01)),
      Do_22 = ksl_product_sum((double)D1->m22, (double)D2->m22, ksl_product_sum((double)D1->m21,
          (double)D2->m12, (double)D1->m20 * (double)D2->m02));
  const double Do_23e = ksl_product_sum((double)D1->m22, (double)D2->m23,
      ksl_product_sum((double)D1->m21, (double)D2->m13, (double)D1->m20 * (double)D2->m03)),
      Do_23 = Do_23e + (double)D1->m23;
  Do->m00 = (float)Do_00;
  Do->m01 = (float)Do_01;
  Do->m02 = (float)Do_02;
  Do->m03 = (float)Do_03;
  Do->m10 = (float)Do_10;
  Do->m11 = (float)Do_11;
  Do->m12 = (float)Do_12;
  Do->m13 = (float)Do_13;
  Do->m20 = (float)Do_20;
  Do->m21 = (float)Do_21;
  Do->m22 = (float)Do_22;
  Do->m23 = (float)Do_23;
}

/* Do = D1 D2^-1 = [R | t1 - R t2], R = R1 R2^T.
   D1, D2, Do: displacement [R | t], R rotation, t in m.
   36 mul, 27 add.
   Error <= u |result| + (R: 3/32, t: 7/32) u^2 S, S the sum of the |terms| of the expanded
     formula; barring over- and underflow. */
static inline void ksl_product_ddinvf_accurate(const ksl_SE3f_t *D1, const ksl_SE3f_t *D2,
    ksl_SE3f_t *Do) {
  const double R_0 = ksl_product_sum((double)D1->m02, (double)D2->m02,
      ksl_product_sum((double)D1->m01, (double)D2->m01, (double)D1->m00 * (double)D2->m00)),
      R_1 = ksl_product_sum((double)D1->m02, (double)D2->m12, ksl_product_sum((double)D1->m01,
          (double)D2->m11, (double)D1->m00 * (double)D2->m10)),
      R_2 = ksl_product_sum((double)D1->m02, (double)D2->m22, ksl_product_sum((double)D1->m01,
          (double)D2->m21, (double)D1->m00 * (double)D2->m20)),
      R_3 = ksl_product_sum((double)D1->m12, (double)D2->m02, ksl_product_sum((double)D1->m11,
          (double)D2->m01, (double)D1->m10 * (double)D2->m00)),
      R_4 = ksl_product_sum((double)D1->m12, (double)D2->m12, ksl_product_sum((double)D1->m11,
          (double)D2->m11, (double)D1->m10 * (double)D2->m10)),
      R_5 = ksl_product_sum((double)D1->m12, (double)D2->m22, ksl_product_sum((double)D1->m11,
          (double)D2->m21, (double)D1->m10 * (double)D2->m20)),
      R_6 = ksl_product_sum((double)D1->m22, (double)D2->m02, ksl_product_sum((double)D1->m21,
          (double)D2->m01, (double)D1->m20 * (double)D2->m00)),
      R_7 = ksl_product_sum((double)D1->m22, (double)D2->m12, ksl_product_sum((double)D1->m21,
          (double)D2->m11, (double)D1->m20 * (double)D2->m10)),
      R_8 = ksl_product_sum((double)D1->m22, (double)D2->m22, ksl_product_sum((double)D1->m21,
          (double)D2->m21, (double)D1->m20 * (double)D2->m20));
  const double Do_03 = (double)D1->m03
          - (KSL_MUL((double)D2->m03, R_0) + KSL_MUL((double)D2->m13, R_1)
          + KSL_MUL((double)D2->m23, R_2)),
      Do_13 = (double)D1->m13
          - (KSL_MUL((double)D2->m03, R_3) + KSL_MUL((double)D2->m13, R_4)
          + KSL_MUL((double)D2->m23, R_5)),
      Do_23 = (double)D1->m23
          - (KSL_MUL((double)D2->m03, R_6) + KSL_MUL((double)D2->m13, R_7)
          + KSL_MUL((double)D2->m23, R_8));
  Do->m00 = (float)R_0;
  Do->m01 = (float)R_1;
  Do->m02 = (float)R_2;
  Do->m03 = (float)Do_03;
  Do->m10 = (float)R_3;
  Do->m11 = (float)R_4;
  Do->m12 = (float)R_5;
  Do->m13 = (float)Do_13;
  Do->m20 = (float)R_6;
  Do->m21 = (float)R_7;
  Do->m22 = (float)R_8;
  Do->m23 = (float)Do_23;
}

/* Do = D1^-1 D2 = [R1^T R2 | R1^T (t2 - t1)].
   D1, D2, Do: displacement [R | t], R rotation, t in m.
   36 mul, 27 add.
   Error <= u |result| + (R: 3/32, t: 1/8) u^2 S, S the sum of the |terms| of the expanded
     formula; barring over- and underflow. */
static inline void ksl_product_dinvdf_accurate(const ksl_SE3f_t *D1, const ksl_SE3f_t *D2,
    ksl_SE3f_t *Do) {
  const double p_0 = (double)D2->m03 - (double)D1->m03, p_1 = (double)D2->m13 - (double)D1->m13,
      p_2 = (double)D2->m23 - (double)D1->m23;
  const double Do_00 = ksl_product_sum((double)D1->m20, (double)D2->m20,
      ksl_product_sum((double)D1->m10, (double)D2->m10, (double)D1->m00 * (double)D2->m00)),
      Do_01 = ksl_product_sum((double)D1->m20, (double)D2->m21, ksl_product_sum((double)D1->m10,
          (double)D2->m11, (double)D1->m00 * (double)D2->m01)),
      Do_02 = ksl_product_sum((double)D1->m20, (double)D2->m22, ksl_product_sum((double)D1->m10,
          (double)D2->m12, (double)D1->m00 * (double)D2->m02)),
      Do_03 = KSL_MUL((double)D1->m00, p_0) + KSL_MUL((double)D1->m10, p_1)
          + KSL_MUL((double)D1->m20, p_2),
      Do_10 = ksl_product_sum((double)D1->m21, (double)D2->m20, ksl_product_sum((double)D1->m11,
          (double)D2->m10, (double)D1->m01 * (double)D2->m00)),
      Do_11 = ksl_product_sum((double)D1->m21, (double)D2->m21, ksl_product_sum((double)D1->m11,
          (double)D2->m11, (double)D1->m01 * (double)D2->m01)),
      Do_12 = ksl_product_sum((double)D1->m21, (double)D2->m22, ksl_product_sum((double)D1->m11,
          (double)D2->m12, (double)D1->m01 * (double)D2->m02)),
      Do_13 = KSL_MUL((double)D1->m01, p_0) + KSL_MUL((double)D1->m11, p_1)
          + KSL_MUL((double)D1->m21, p_2),
      Do_20 = ksl_product_sum((double)D1->m22, (double)D2->m20, ksl_product_sum((double)D1->m12,
          (double)D2->m10, (double)D1->m02 * (double)D2->m00)),
      Do_21 = ksl_product_sum((double)D1->m22, (double)D2->m21, ksl_product_sum((double)D1->m12,
          (double)D2->m11, (double)D1->m02 * (double)D2->m01)),
      Do_22 = ksl_product_sum((double)D1->m22, (double)D2->m22, ksl_product_sum((double)D1->m12,
          (double)D2->m12, (double)D1->m02 * (double)D2->m02)),
      Do_23 = KSL_MUL((double)D1->m02, p_0) + KSL_MUL((double)D1->m12, p_1)
          + KSL_MUL((double)D1->m22, p_2);
  Do->m00 = (float)Do_00;
  Do->m01 = (float)Do_01;
  Do->m02 = (float)Do_02;
  Do->m03 = (float)Do_03;
  Do->m10 = (float)Do_10;
  Do->m11 = (float)Do_11;
  Do->m12 = (float)Do_12;
  Do->m13 = (float)Do_13;
  Do->m20 = (float)Do_20;
  Do->m21 = (float)Do_21;
  Do->m22 = (float)Do_22;
  Do->m23 = (float)Do_23;
}

/* Do = D [R | 0].
   D, Do: displacement [R | t], R rotation, t in m; R: rotation or other 3×3 matrix.
   27 mul, 18 add.
   Error <= u |result| + (R: 3/32, t: 0) u^2 S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_ddrf_accurate(const ksl_SE3f_t *D, const ksl_mat3x3f_t *R,
    ksl_SE3f_t *Do) {
  const double Do_00 = ksl_product_sum((double)D->m02, (double)R->m20,
      ksl_product_sum((double)D->m01, (double)R->m10, (double)D->m00 * (double)R->m00)),
      Do_01 = ksl_product_sum((double)D->m02, (double)R->m21, ksl_product_sum((double)D->m01,
          (double)R->m11, (double)D->m00 * (double)R->m01)),
      Do_02 = ksl_product_sum((double)D->m02, (double)R->m22, ksl_product_sum((double)D->m01,
          (double)R->m12, (double)D->m00 * (double)R->m02)),
      Do_10 = ksl_product_sum((double)D->m12, (double)R->m20, ksl_product_sum((double)D->m11,
          (double)R->m10, (double)D->m10 * (double)R->m00)),
      Do_11 = ksl_product_sum((double)D->m12, (double)R->m21, ksl_product_sum((double)D->m11,
          (double)R->m11, (double)D->m10 * (double)R->m01)),
      Do_12 = ksl_product_sum((double)D->m12, (double)R->m22, ksl_product_sum((double)D->m11,
          (double)R->m12, (double)D->m10 * (double)R->m02)),
      Do_20 = ksl_product_sum((double)D->m22, (double)R->m20, ksl_product_sum((double)D->m21,
          (double)R->m10, (double)D->m20 * (double)R->m00)),
      Do_21 = ksl_product_sum((double)D->m22, (double)R->m21, ksl_product_sum((double)D->m21,
          (double)R->m11, (double)D->m20 * (double)R->m01)),
      Do_22 = ksl_product_sum((double)D->m22, (double)R->m22, ksl_product_sum((double)D->m21,
          (double)R->m12, (double)D->m20 * (double)R->m02));
  const float D_m03 = D->m03;
  const float D_m13 = D->m13;
  const float D_m23 = D->m23;
  Do->m00 = (float)Do_00;
  Do->m01 = (float)Do_01;
  Do->m02 = (float)Do_02;
  Do->m03 = D_m03;
  Do->m10 = (float)Do_10;
  Do->m11 = (float)Do_11;
  Do->m12 = (float)Do_12;
  Do->m13 = D_m13;
  Do->m20 = (float)Do_20;
  Do->m21 = (float)Do_21;
  Do->m22 = (float)Do_22;
  Do->m23 = D_m23;
}

/* Do = D [R^T | 0].
   D, Do: displacement [R | t], R rotation, t in m; R: rotation or other 3×3 matrix.
   27 mul, 18 add.
   Error <= u |result| + (R: 3/32, t: 0) u^2 S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_ddrinvf_accurate(const ksl_SE3f_t *D, const ksl_mat3x3f_t *R,
    ksl_SE3f_t *Do) {
  const double Do_00 = ksl_product_sum((double)D->m02, (double)R->m02,
      ksl_product_sum((double)D->m01, (double)R->m01, (double)D->m00 * (double)R->m00)),
      Do_01 = ksl_product_sum((double)D->m02, (double)R->m12, ksl_product_sum((double)D->m01,
          (double)R->m11, (double)D->m00 * (double)R->m10)),
      Do_02 = ksl_product_sum((double)D->m02, (double)R->m22, ksl_product_sum((double)D->m01,
          (double)R->m21, (double)D->m00 * (double)R->m20)),
      Do_10 = ksl_product_sum((double)D->m12, (double)R->m02, ksl_product_sum((double)D->m11,
          (double)R->m01, (double)D->m10 * (double)R->m00)),
      Do_11 = ksl_product_sum((double)D->m12, (double)R->m12, ksl_product_sum((double)D->m11,
          (double)R->m11, (double)D->m10 * (double)R->m10)),
      Do_12 = ksl_product_sum((double)D->m12, (double)R->m22, ksl_product_sum((double)D->m11,
          (double)R->m21, (double)D->m10 * (double)R->m20)),
      Do_20 = ksl_product_sum((double)D->m22, (double)R->m02, ksl_product_sum((double)D->m21,
          (double)R->m01, (double)D->m20 * (double)R->m00)),
      Do_21 = ksl_product_sum((double)D->m22, (double)R->m12, ksl_product_sum((double)D->m21,
          (double)R->m11, (double)D->m20 * (double)R->m10)),
      Do_22 = ksl_product_sum((double)D->m22, (double)R->m22, ksl_product_sum((double)D->m21,
          (double)R->m21, (double)D->m20 * (double)R->m20));
  const float D_m03 = D->m03;
  const float D_m13 = D->m13;
  const float D_m23 = D->m23;
  Do->m00 = (float)Do_00;
  Do->m01 = (float)Do_01;
  Do->m02 = (float)Do_02;
  Do->m03 = D_m03;
  Do->m10 = (float)Do_10;
  Do->m11 = (float)Do_11;
  Do->m12 = (float)Do_12;
  Do->m13 = D_m13;
  Do->m20 = (float)Do_20;
  Do->m21 = (float)Do_21;
  Do->m22 = (float)Do_22;
  Do->m23 = D_m23;
}

/* Do = D [I | t].
   D, Do: displacement [R | t], R rotation, t in m; t: vector.
   9 mul, 9 add.
   Error <= u |result| + (R: 0, t: 1/8) u^2 S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_ddtf_accurate(const ksl_SE3f_t *D, const ksl_vec3f_t *t,
    ksl_SE3f_t *Do) {
  const double Do_03 = ksl_product_sum((double)D->m02, (double)t->z, ksl_product_sum((double)D->m01,
      (double)t->y, (double)D->m00 * (double)t->x)) + (double)D->m03,
      Do_13 = ksl_product_sum((double)D->m12, (double)t->z, ksl_product_sum((double)D->m11,
          (double)t->y, (double)D->m10 * (double)t->x)) + (double)D->m13,
      Do_23 = ksl_product_sum((double)D->m22, (double)t->z, ksl_product_sum((double)D->m21,
          (double)t->y, (double)D->m20 * (double)t->x)) + (double)D->m23;
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
  Do->m03 = (float)Do_03;
  Do->m10 = D_m10;
  Do->m11 = D_m11;
  Do->m12 = D_m12;
  Do->m13 = (float)Do_13;
  Do->m20 = D_m20;
  Do->m21 = D_m21;
  Do->m22 = D_m22;
  Do->m23 = (float)Do_23;
}

/* Do = D [I | -t].
   D, Do: displacement [R | t], R rotation, t in m; t: vector.
   9 mul, 9 add.
   Error <= u |result| + (R: 0, t: 1/8) u^2 S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_ddtinvf_accurate(const ksl_SE3f_t *D, const ksl_vec3f_t *t,
    ksl_SE3f_t *Do) {
  const double Do_03 = (double)D->m03
          - ksl_product_sum((double)D->m02, (double)t->z, ksl_product_sum((double)D->m01,
              (double)t->y, (double)D->m00 * (double)t->x)),
      Do_13 = (double)D->m13
          - ksl_product_sum((double)D->m12, (double)t->z, ksl_product_sum((double)D->m11,
              (double)t->y, (double)D->m10 * (double)t->x)),
      Do_23 = (double)D->m23
          - ksl_product_sum((double)D->m22, (double)t->z, ksl_product_sum((double)D->m21,
              (double)t->y, (double)D->m20 * (double)t->x));
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
  Do->m03 = (float)Do_03;
  Do->m10 = D_m10;
  Do->m11 = D_m11;
  Do->m12 = D_m12;
  Do->m13 = (float)Do_13;
  Do->m20 = D_m20;
  Do->m21 = D_m21;
  Do->m22 = D_m22;
  Do->m23 = (float)Do_23;
}

/* Do = D^-1 [I | t] = [R^T | R^T (t - t_D)].
   D, Do: displacement [R | t], R rotation, t in m; t: vector.
   9 mul, 9 add.
   Error <= u |result| + (R: 0, t: 1/8) u^2 S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_dinvdtf_accurate(const ksl_SE3f_t *D, const ksl_vec3f_t *t,
    ksl_SE3f_t *Do) {
  const double p_0 = (double)t->x - (double)D->m03, p_1 = (double)t->y - (double)D->m13,
      p_2 = (double)t->z - (double)D->m23;
  const double Do_03 = KSL_MUL((double)D->m00, p_0) + KSL_MUL((double)D->m10, p_1)
          + KSL_MUL((double)D->m20, p_2),
      Do_13 = KSL_MUL((double)D->m01, p_0) + KSL_MUL((double)D->m11, p_1)
          + KSL_MUL((double)D->m21, p_2),
      Do_23 = KSL_MUL((double)D->m02, p_0) + KSL_MUL((double)D->m12, p_1)
          + KSL_MUL((double)D->m22, p_2);
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
  Do->m03 = (float)Do_03;
  Do->m10 = D_m01;
  Do->m11 = D_m11;
  Do->m12 = D_m21;
  Do->m13 = (float)Do_13;
  Do->m20 = D_m02;
  Do->m21 = D_m12;
  Do->m22 = D_m22;
  Do->m23 = (float)Do_23;
}

/* vo = R (k e_x).
   R: rotation or other 3×3 matrix; k: number; vo: vector.
   3 mul.
   Error <= u |result| + 1/32 u^2 S, S the sum of the |terms| of the expanded formula; barring
     over- and underflow. */
static inline void ksl_product_drvtxf_accurate(const ksl_mat3x3f_t *R, const float k,
    ksl_vec3f_t *vo) {
  const double vo_0 = (double)R->m00 * (double)k, vo_1 = (double)R->m10 * (double)k,
      vo_2 = (double)R->m20 * (double)k;
  vo->x = (float)vo_0;
  vo->y = (float)vo_1;
  vo->z = (float)vo_2;
}

/* Ro = R R_x(θ), dc = (sin θ, cos θ).
   R, Ro: rotation or other 3×3 matrix; dc: (sin θ, cos θ).
   12 mul, 6 add.
   Error <= u |result| + 1/16 u^2 S, S the sum of the |terms| of the expanded formula; barring
     over- and underflow. */
static inline void ksl_product_drdrxf_accurate(const ksl_mat3x3f_t *R, const float dc[2],
    ksl_mat3x3f_t *Ro) {
  const double Ro_01 = ksl_product_sum((double)R->m02, (double)dc[0], (double)R->m01
          * (double)dc[1]),
      Ro_02 = ksl_product_sum(-(double)R->m01, (double)dc[0], (double)R->m02 * (double)dc[1]),
      Ro_11 = ksl_product_sum((double)R->m12, (double)dc[0], (double)R->m11 * (double)dc[1]),
      Ro_12 = ksl_product_sum(-(double)R->m11, (double)dc[0], (double)R->m12 * (double)dc[1]),
      Ro_21 = ksl_product_sum((double)R->m22, (double)dc[0], (double)R->m21 * (double)dc[1]),
      Ro_22 = ksl_product_sum(-(double)R->m21, (double)dc[0], (double)R->m22 * (double)dc[1]);
  const float R_m00 = R->m00;
  const float R_m10 = R->m10;
  const float R_m20 = R->m20;
  Ro->m00 = R_m00;
  Ro->m01 = (float)Ro_01;
  Ro->m02 = (float)Ro_02;
  Ro->m10 = R_m10;
  Ro->m11 = (float)Ro_11;
  Ro->m12 = (float)Ro_12;
  Ro->m20 = R_m20;
  Ro->m21 = (float)Ro_21;
  Ro->m22 = (float)Ro_22;
}

/* Do = D [R_x(θ) | 0], dc = (sin θ, cos θ).
   D, Do: displacement [R | t], R rotation, t in m; dc: (sin θ, cos θ).
   12 mul, 6 add.
   Error <= u |result| + (R: 1/16, t: 0) u^2 S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_ddrxf_accurate(const ksl_SE3f_t *D, const float dc[2],
    ksl_SE3f_t *Do) {
  const double Do_01 = ksl_product_sum((double)D->m02, (double)dc[0], (double)D->m01
          * (double)dc[1]),
      Do_02 = ksl_product_sum(-(double)D->m01, (double)dc[0], (double)D->m02 * (double)dc[1]),
      Do_11 = ksl_product_sum((double)D->m12, (double)dc[0], (double)D->m11 * (double)dc[1]),
      Do_12 = ksl_product_sum(-(double)D->m11, (double)dc[0], (double)D->m12 * (double)dc[1]),
      Do_21 = ksl_product_sum((double)D->m22, (double)dc[0], (double)D->m21 * (double)dc[1]),
      Do_22 = ksl_product_sum(-(double)D->m21, (double)dc[0], (double)D->m22 * (double)dc[1]);
  const float D_m00 = D->m00;
  const float D_m03 = D->m03;
  const float D_m10 = D->m10;
  const float D_m13 = D->m13;
  const float D_m20 = D->m20;
  const float D_m23 = D->m23;
  Do->m00 = D_m00;
  Do->m01 = (float)Do_01;
  Do->m02 = (float)Do_02;
  Do->m03 = D_m03;
  Do->m10 = D_m10;
  Do->m11 = (float)Do_11;
  Do->m12 = (float)Do_12;
  Do->m13 = D_m13;
  Do->m20 = D_m20;
  Do->m21 = (float)Do_21;
  Do->m22 = (float)Do_22;
  Do->m23 = D_m23;
}

/* Do = D [I | k e_x].
   D, Do: displacement [R | t], R rotation, t in m; k: number.
   3 mul, 3 add.
   Error <= u |result| + (R: 0, t: 1/16) u^2 S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_ddtxf_accurate(const ksl_SE3f_t *D, const float k, ksl_SE3f_t *Do) {
  const double Do_03 = ksl_product_sum((double)D->m00, (double)k, (double)D->m03),
      Do_13 = ksl_product_sum((double)D->m10, (double)k, (double)D->m13),
      Do_23 = ksl_product_sum((double)D->m20, (double)k, (double)D->m23);
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
  Do->m03 = (float)Do_03;
  Do->m10 = D_m10;
  Do->m11 = D_m11;
  Do->m12 = D_m12;
  Do->m13 = (float)Do_13;
  Do->m20 = D_m20;
  Do->m21 = D_m21;
  Do->m22 = D_m22;
  Do->m23 = (float)Do_23;
}

/* vo = R (-k e_x).
   R: rotation or other 3×3 matrix; k: number; vo: vector.
   3 mul, 3 neg.
   Error <= u |result| + 1/32 u^2 S, S the sum of the |terms| of the expanded formula; barring
     over- and underflow. */
static inline void ksl_product_drvtxinvf_accurate(const ksl_mat3x3f_t *R, const float k,
    ksl_vec3f_t *vo) {
  const double vo_0 = -((double)R->m00 * (double)k), vo_1 = -((double)R->m10 * (double)k),
      vo_2 = -((double)R->m20 * (double)k);
  vo->x = (float)vo_0;
  vo->y = (float)vo_1;
  vo->z = (float)vo_2;
}

/* Ro = R R_x(-θ), dc = (sin θ, cos θ).
   R, Ro: rotation or other 3×3 matrix; dc: (sin θ, cos θ).
   12 mul, 6 add.
   Error <= u |result| + 1/16 u^2 S, S the sum of the |terms| of the expanded formula; barring
     over- and underflow. */
static inline void ksl_product_drdrxinvf_accurate(const ksl_mat3x3f_t *R, const float dc[2],
    ksl_mat3x3f_t *Ro) {
  const double Ro_01 = ksl_product_sum(-(double)R->m02, (double)dc[0], (double)R->m01
          * (double)dc[1]),
      Ro_02 = ksl_product_sum((double)R->m02, (double)dc[1], (double)R->m01 * (double)dc[0]),
      Ro_11 = ksl_product_sum(-(double)R->m12, (double)dc[0], (double)R->m11 * (double)dc[1]),
      Ro_12 = ksl_product_sum((double)R->m12, (double)dc[1], (double)R->m11 * (double)dc[0]),
      Ro_21 = ksl_product_sum(-(double)R->m22, (double)dc[0], (double)R->m21 * (double)dc[1]),
      Ro_22 = ksl_product_sum((double)R->m22, (double)dc[1], (double)R->m21 * (double)dc[0]);
  const float R_m00 = R->m00;
  const float R_m10 = R->m10;
  const float R_m20 = R->m20;
  Ro->m00 = R_m00;
  Ro->m01 = (float)Ro_01;
  Ro->m02 = (float)Ro_02;
  Ro->m10 = R_m10;
  Ro->m11 = (float)Ro_11;
  Ro->m12 = (float)Ro_12;
  Ro->m20 = R_m20;
  Ro->m21 = (float)Ro_21;
  Ro->m22 = (float)Ro_22;
}

/* Do = D [R_x(-θ) | 0], dc = (sin θ, cos θ).
   D, Do: displacement [R | t], R rotation, t in m; dc: (sin θ, cos θ).
   12 mul, 6 add.
   Error <= u |result| + (R: 1/16, t: 0) u^2 S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_ddrxinvf_accurate(const ksl_SE3f_t *D, const float dc[2],
    ksl_SE3f_t *Do) {
  const double Do_01 = ksl_product_sum(-(double)D->m02, (double)dc[0], (double)D->m01
          * (double)dc[1]),
      Do_02 = ksl_product_sum((double)D->m02, (double)dc[1], (double)D->m01 * (double)dc[0]),
      Do_11 = ksl_product_sum(-(double)D->m12, (double)dc[0], (double)D->m11 * (double)dc[1]),
      Do_12 = ksl_product_sum((double)D->m12, (double)dc[1], (double)D->m11 * (double)dc[0]),
      Do_21 = ksl_product_sum(-(double)D->m22, (double)dc[0], (double)D->m21 * (double)dc[1]),
      Do_22 = ksl_product_sum((double)D->m22, (double)dc[1], (double)D->m21 * (double)dc[0]);
  const float D_m00 = D->m00;
  const float D_m03 = D->m03;
  const float D_m10 = D->m10;
  const float D_m13 = D->m13;
  const float D_m20 = D->m20;
  const float D_m23 = D->m23;
  Do->m00 = D_m00;
  Do->m01 = (float)Do_01;
  Do->m02 = (float)Do_02;
  Do->m03 = D_m03;
  Do->m10 = D_m10;
  Do->m11 = (float)Do_11;
  Do->m12 = (float)Do_12;
  Do->m13 = D_m13;
  Do->m20 = D_m20;
  Do->m21 = (float)Do_21;
  Do->m22 = (float)Do_22;
  Do->m23 = D_m23;
}

/* Do = D [I | -k e_x].
   D, Do: displacement [R | t], R rotation, t in m; k: number.
   3 mul, 3 add.
   Error <= u |result| + (R: 0, t: 1/16) u^2 S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_ddtxinvf_accurate(const ksl_SE3f_t *D, const float k,
    ksl_SE3f_t *Do) {
  const double Do_03 = ksl_product_sum(-(double)D->m00, (double)k, (double)D->m03),
      Do_13 = ksl_product_sum(-(double)D->m10, (double)k, (double)D->m13),
      Do_23 = ksl_product_sum(-(double)D->m20, (double)k, (double)D->m23);
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
  Do->m03 = (float)Do_03;
  Do->m10 = D_m10;
  Do->m11 = D_m11;
  Do->m12 = D_m12;
  Do->m13 = (float)Do_13;
  Do->m20 = D_m20;
  Do->m21 = D_m21;
  Do->m22 = D_m22;
  Do->m23 = (float)Do_23;
}

/* vo = R (k e_y).
   R: rotation or other 3×3 matrix; k: number; vo: vector.
   3 mul.
   Error <= u |result| + 1/32 u^2 S, S the sum of the |terms| of the expanded formula; barring
     over- and underflow. */
static inline void ksl_product_drvtyf_accurate(const ksl_mat3x3f_t *R, const float k,
    ksl_vec3f_t *vo) {
  const double vo_0 = (double)R->m01 * (double)k, vo_1 = (double)R->m11 * (double)k,
      vo_2 = (double)R->m21 * (double)k;
  vo->x = (float)vo_0;
  vo->y = (float)vo_1;
  vo->z = (float)vo_2;
}

/* Ro = R R_y(θ), dc = (sin θ, cos θ).
   R, Ro: rotation or other 3×3 matrix; dc: (sin θ, cos θ).
   12 mul, 6 add.
   Error <= u |result| + 1/16 u^2 S, S the sum of the |terms| of the expanded formula; barring
     over- and underflow. */
static inline void ksl_product_drdryf_accurate(const ksl_mat3x3f_t *R, const float dc[2],
    ksl_mat3x3f_t *Ro) {
  const double Ro_00 = ksl_product_sum(-(double)R->m02, (double)dc[0], (double)R->m00
          * (double)dc[1]),
      Ro_02 = ksl_product_sum((double)R->m02, (double)dc[1], (double)R->m00 * (double)dc[0]),
      Ro_10 = ksl_product_sum(-(double)R->m12, (double)dc[0], (double)R->m10 * (double)dc[1]),
      Ro_12 = ksl_product_sum((double)R->m12, (double)dc[1], (double)R->m10 * (double)dc[0]),
      Ro_20 = ksl_product_sum(-(double)R->m22, (double)dc[0], (double)R->m20 * (double)dc[1]),
      Ro_22 = ksl_product_sum((double)R->m22, (double)dc[1], (double)R->m20 * (double)dc[0]);
  const float R_m01 = R->m01;
  const float R_m11 = R->m11;
  const float R_m21 = R->m21;
  Ro->m00 = (float)Ro_00;
  Ro->m01 = R_m01;
  Ro->m02 = (float)Ro_02;
  Ro->m10 = (float)Ro_10;
  Ro->m11 = R_m11;
  Ro->m12 = (float)Ro_12;
  Ro->m20 = (float)Ro_20;
  Ro->m21 = R_m21;
  Ro->m22 = (float)Ro_22;
}

/* Do = D [R_y(θ) | 0], dc = (sin θ, cos θ).
   D, Do: displacement [R | t], R rotation, t in m; dc: (sin θ, cos θ).
   12 mul, 6 add.
   Error <= u |result| + (R: 1/16, t: 0) u^2 S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_ddryf_accurate(const ksl_SE3f_t *D, const float dc[2],
    ksl_SE3f_t *Do) {
  const double Do_00 = ksl_product_sum(-(double)D->m02, (double)dc[0], (double)D->m00
          * (double)dc[1]),
      Do_02 = ksl_product_sum((double)D->m02, (double)dc[1], (double)D->m00 * (double)dc[0]),
      Do_10 = ksl_product_sum(-(double)D->m12, (double)dc[0], (double)D->m10 * (double)dc[1]),
      Do_12 = ksl_product_sum((double)D->m12, (double)dc[1], (double)D->m10 * (double)dc[0]),
      Do_20 = ksl_product_sum(-(double)D->m22, (double)dc[0], (double)D->m20 * (double)dc[1]),
      Do_22 = ksl_product_sum((double)D->m22, (double)dc[1], (double)D->m20 * (double)dc[0]);
  const float D_m01 = D->m01;
  const float D_m03 = D->m03;
  const float D_m11 = D->m11;
  const float D_m13 = D->m13;
  const float D_m21 = D->m21;
  const float D_m23 = D->m23;
  Do->m00 = (float)Do_00;
  Do->m01 = D_m01;
  Do->m02 = (float)Do_02;
  Do->m03 = D_m03;
  Do->m10 = (float)Do_10;
  Do->m11 = D_m11;
  Do->m12 = (float)Do_12;
  Do->m13 = D_m13;
  Do->m20 = (float)Do_20;
  Do->m21 = D_m21;
  Do->m22 = (float)Do_22;
  Do->m23 = D_m23;
}

/* Do = D [I | k e_y].
   D, Do: displacement [R | t], R rotation, t in m; k: number.
   3 mul, 3 add.
   Error <= u |result| + (R: 0, t: 1/16) u^2 S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_ddtyf_accurate(const ksl_SE3f_t *D, const float k, ksl_SE3f_t *Do) {
  const double Do_03 = ksl_product_sum((double)D->m01, (double)k, (double)D->m03),
      Do_13 = ksl_product_sum((double)D->m11, (double)k, (double)D->m13),
      Do_23 = ksl_product_sum((double)D->m21, (double)k, (double)D->m23);
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
  Do->m03 = (float)Do_03;
  Do->m10 = D_m10;
  Do->m11 = D_m11;
  Do->m12 = D_m12;
  Do->m13 = (float)Do_13;
  Do->m20 = D_m20;
  Do->m21 = D_m21;
  Do->m22 = D_m22;
  Do->m23 = (float)Do_23;
}

/* vo = R (-k e_y).
   R: rotation or other 3×3 matrix; k: number; vo: vector.
   3 mul, 3 neg.
   Error <= u |result| + 1/32 u^2 S, S the sum of the |terms| of the expanded formula; barring
     over- and underflow. */
static inline void ksl_product_drvtyinvf_accurate(const ksl_mat3x3f_t *R, const float k,
    ksl_vec3f_t *vo) {
  const double vo_0 = -((double)R->m01 * (double)k), vo_1 = -((double)R->m11 * (double)k),
      vo_2 = -((double)R->m21 * (double)k);
  vo->x = (float)vo_0;
  vo->y = (float)vo_1;
  vo->z = (float)vo_2;
}

/* Ro = R R_y(-θ), dc = (sin θ, cos θ).
   R, Ro: rotation or other 3×3 matrix; dc: (sin θ, cos θ).
   12 mul, 6 add.
   Error <= u |result| + 1/16 u^2 S, S the sum of the |terms| of the expanded formula; barring
     over- and underflow. */
static inline void ksl_product_drdryinvf_accurate(const ksl_mat3x3f_t *R, const float dc[2],
    ksl_mat3x3f_t *Ro) {
  const double Ro_00 = ksl_product_sum((double)R->m02, (double)dc[0], (double)R->m00
          * (double)dc[1]),
      Ro_02 = ksl_product_sum(-(double)R->m00, (double)dc[0], (double)R->m02 * (double)dc[1]),
      Ro_10 = ksl_product_sum((double)R->m12, (double)dc[0], (double)R->m10 * (double)dc[1]),
      Ro_12 = ksl_product_sum(-(double)R->m10, (double)dc[0], (double)R->m12 * (double)dc[1]),
      Ro_20 = ksl_product_sum((double)R->m22, (double)dc[0], (double)R->m20 * (double)dc[1]),
      Ro_22 = ksl_product_sum(-(double)R->m20, (double)dc[0], (double)R->m22 * (double)dc[1]);
  const float R_m01 = R->m01;
  const float R_m11 = R->m11;
  const float R_m21 = R->m21;
  Ro->m00 = (float)Ro_00;
  Ro->m01 = R_m01;
  Ro->m02 = (float)Ro_02;
  Ro->m10 = (float)Ro_10;
  Ro->m11 = R_m11;
  Ro->m12 = (float)Ro_12;
  Ro->m20 = (float)Ro_20;
  Ro->m21 = R_m21;
  Ro->m22 = (float)Ro_22;
}

/* Do = D [R_y(-θ) | 0], dc = (sin θ, cos θ).
   D, Do: displacement [R | t], R rotation, t in m; dc: (sin θ, cos θ).
   12 mul, 6 add.
   Error <= u |result| + (R: 1/16, t: 0) u^2 S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_ddryinvf_accurate(const ksl_SE3f_t *D, const float dc[2],
    ksl_SE3f_t *Do) {
  const double Do_00 = ksl_product_sum((double)D->m02, (double)dc[0], (double)D->m00
          * (double)dc[1]),
      Do_02 = ksl_product_sum(-(double)D->m00, (double)dc[0], (double)D->m02 * (double)dc[1]),
      Do_10 = ksl_product_sum((double)D->m12, (double)dc[0], (double)D->m10 * (double)dc[1]),
      Do_12 = ksl_product_sum(-(double)D->m10, (double)dc[0], (double)D->m12 * (double)dc[1]),
      Do_20 = ksl_product_sum((double)D->m22, (double)dc[0], (double)D->m20 * (double)dc[1]),
      Do_22 = ksl_product_sum(-(double)D->m20, (double)dc[0], (double)D->m22 * (double)dc[1]);
  const float D_m01 = D->m01;
  const float D_m03 = D->m03;
  const float D_m11 = D->m11;
  const float D_m13 = D->m13;
  const float D_m21 = D->m21;
  const float D_m23 = D->m23;
  Do->m00 = (float)Do_00;
  Do->m01 = D_m01;
  Do->m02 = (float)Do_02;
  Do->m03 = D_m03;
  Do->m10 = (float)Do_10;
  Do->m11 = D_m11;
  Do->m12 = (float)Do_12;
  Do->m13 = D_m13;
  Do->m20 = (float)Do_20;
  Do->m21 = D_m21;
  Do->m22 = (float)Do_22;
  Do->m23 = D_m23;
}

/* Do = D [I | -k e_y].
   D, Do: displacement [R | t], R rotation, t in m; k: number.
   3 mul, 3 add.
   Error <= u |result| + (R: 0, t: 1/16) u^2 S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_ddtyinvf_accurate(const ksl_SE3f_t *D, const float k,
    ksl_SE3f_t *Do) {
  const double Do_03 = ksl_product_sum(-(double)D->m01, (double)k, (double)D->m03),
      Do_13 = ksl_product_sum(-(double)D->m11, (double)k, (double)D->m13),
      Do_23 = ksl_product_sum(-(double)D->m21, (double)k, (double)D->m23);
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
  Do->m03 = (float)Do_03;
  Do->m10 = D_m10;
  Do->m11 = D_m11;
  Do->m12 = D_m12;
  Do->m13 = (float)Do_13;
  Do->m20 = D_m20;
  Do->m21 = D_m21;
  Do->m22 = D_m22;
  Do->m23 = (float)Do_23;
}

/* vo = R (k e_z).
   R: rotation or other 3×3 matrix; k: number; vo: vector.
   3 mul.
   Error <= u |result| + 1/32 u^2 S, S the sum of the |terms| of the expanded formula; barring
     over- and underflow. */
static inline void ksl_product_drvtzf_accurate(const ksl_mat3x3f_t *R, const float k,
    ksl_vec3f_t *vo) {
  const double vo_0 = (double)R->m02 * (double)k, vo_1 = (double)R->m12 * (double)k,
      vo_2 = (double)R->m22 * (double)k;
  vo->x = (float)vo_0;
  vo->y = (float)vo_1;
  vo->z = (float)vo_2;
}

/* Ro = R R_z(θ), dc = (sin θ, cos θ).
   R, Ro: rotation or other 3×3 matrix; dc: (sin θ, cos θ).
   12 mul, 6 add.
   Error <= u |result| + 1/16 u^2 S, S the sum of the |terms| of the expanded formula; barring
     over- and underflow. */
static inline void ksl_product_drdrzf_accurate(const ksl_mat3x3f_t *R, const float dc[2],
    ksl_mat3x3f_t *Ro) {
  const double Ro_00 = ksl_product_sum((double)R->m01, (double)dc[0], (double)R->m00
          * (double)dc[1]),
      Ro_01 = ksl_product_sum(-(double)R->m00, (double)dc[0], (double)R->m01 * (double)dc[1]),
      Ro_10 = ksl_product_sum((double)R->m11, (double)dc[0], (double)R->m10 * (double)dc[1]),
      Ro_11 = ksl_product_sum(-(double)R->m10, (double)dc[0], (double)R->m11 * (double)dc[1]),
      Ro_20 = ksl_product_sum((double)R->m21, (double)dc[0], (double)R->m20 * (double)dc[1]),
      Ro_21 = ksl_product_sum(-(double)R->m20, (double)dc[0], (double)R->m21 * (double)dc[1]);
  const float R_m02 = R->m02;
  const float R_m12 = R->m12;
  const float R_m22 = R->m22;
  Ro->m00 = (float)Ro_00;
  Ro->m01 = (float)Ro_01;
  Ro->m02 = R_m02;
  Ro->m10 = (float)Ro_10;
  Ro->m11 = (float)Ro_11;
  Ro->m12 = R_m12;
  Ro->m20 = (float)Ro_20;
  Ro->m21 = (float)Ro_21;
  Ro->m22 = R_m22;
}

/* Do = D [R_z(θ) | 0], dc = (sin θ, cos θ).
   D, Do: displacement [R | t], R rotation, t in m; dc: (sin θ, cos θ).
   12 mul, 6 add.
   Error <= u |result| + (R: 1/16, t: 0) u^2 S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_ddrzf_accurate(const ksl_SE3f_t *D, const float dc[2],
    ksl_SE3f_t *Do) {
  const double Do_00 = ksl_product_sum((double)D->m01, (double)dc[0], (double)D->m00
          * (double)dc[1]),
      Do_01 = ksl_product_sum(-(double)D->m00, (double)dc[0], (double)D->m01 * (double)dc[1]),
      Do_10 = ksl_product_sum((double)D->m11, (double)dc[0], (double)D->m10 * (double)dc[1]),
      Do_11 = ksl_product_sum(-(double)D->m10, (double)dc[0], (double)D->m11 * (double)dc[1]),
      Do_20 = ksl_product_sum((double)D->m21, (double)dc[0], (double)D->m20 * (double)dc[1]),
      Do_21 = ksl_product_sum(-(double)D->m20, (double)dc[0], (double)D->m21 * (double)dc[1]);
  const float D_m02 = D->m02;
  const float D_m03 = D->m03;
  const float D_m12 = D->m12;
  const float D_m13 = D->m13;
  const float D_m22 = D->m22;
  const float D_m23 = D->m23;
  Do->m00 = (float)Do_00;
  Do->m01 = (float)Do_01;
  Do->m02 = D_m02;
  Do->m03 = D_m03;
  Do->m10 = (float)Do_10;
  Do->m11 = (float)Do_11;
  Do->m12 = D_m12;
  Do->m13 = D_m13;
  Do->m20 = (float)Do_20;
  Do->m21 = (float)Do_21;
  Do->m22 = D_m22;
  Do->m23 = D_m23;
}

/* Do = D [I | k e_z].
   D, Do: displacement [R | t], R rotation, t in m; k: number.
   3 mul, 3 add.
   Error <= u |result| + (R: 0, t: 1/16) u^2 S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_ddtzf_accurate(const ksl_SE3f_t *D, const float k, ksl_SE3f_t *Do) {
  const double Do_03 = ksl_product_sum((double)D->m02, (double)k, (double)D->m03),
      Do_13 = ksl_product_sum((double)D->m12, (double)k, (double)D->m13),
      Do_23 = ksl_product_sum((double)D->m22, (double)k, (double)D->m23);
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
  Do->m03 = (float)Do_03;
  Do->m10 = D_m10;
  Do->m11 = D_m11;
  Do->m12 = D_m12;
  Do->m13 = (float)Do_13;
  Do->m20 = D_m20;
  Do->m21 = D_m21;
  Do->m22 = D_m22;
  Do->m23 = (float)Do_23;
}

/* vo = R (-k e_z).
   R: rotation or other 3×3 matrix; k: number; vo: vector.
   3 mul, 3 neg.
   Error <= u |result| + 1/32 u^2 S, S the sum of the |terms| of the expanded formula; barring
     over- and underflow. */
static inline void ksl_product_drvtzinvf_accurate(const ksl_mat3x3f_t *R, const float k,
    ksl_vec3f_t *vo) {
  const double vo_0 = -((double)R->m02 * (double)k), vo_1 = -((double)R->m12 * (double)k),
      vo_2 = -((double)R->m22 * (double)k);
  vo->x = (float)vo_0;
  vo->y = (float)vo_1;
  vo->z = (float)vo_2;
}

/* Ro = R R_z(-θ), dc = (sin θ, cos θ).
   R, Ro: rotation or other 3×3 matrix; dc: (sin θ, cos θ).
   12 mul, 6 add.
   Error <= u |result| + 1/16 u^2 S, S the sum of the |terms| of the expanded formula; barring
     over- and underflow. */
static inline void ksl_product_drdrzinvf_accurate(const ksl_mat3x3f_t *R, const float dc[2],
    ksl_mat3x3f_t *Ro) {
  const double Ro_00 = ksl_product_sum(-(double)R->m01, (double)dc[0], (double)R->m00
          * (double)dc[1]),
      Ro_01 = ksl_product_sum((double)R->m01, (double)dc[1], (double)R->m00 * (double)dc[0]),
      Ro_10 = ksl_product_sum(-(double)R->m11, (double)dc[0], (double)R->m10 * (double)dc[1]),
      Ro_11 = ksl_product_sum((double)R->m11, (double)dc[1], (double)R->m10 * (double)dc[0]),
      Ro_20 = ksl_product_sum(-(double)R->m21, (double)dc[0], (double)R->m20 * (double)dc[1]),
      Ro_21 = ksl_product_sum((double)R->m21, (double)dc[1], (double)R->m20 * (double)dc[0]);
  const float R_m02 = R->m02;
  const float R_m12 = R->m12;
  const float R_m22 = R->m22;
  Ro->m00 = (float)Ro_00;
  Ro->m01 = (float)Ro_01;
  Ro->m02 = R_m02;
  Ro->m10 = (float)Ro_10;
  Ro->m11 = (float)Ro_11;
  Ro->m12 = R_m12;
  Ro->m20 = (float)Ro_20;
  Ro->m21 = (float)Ro_21;
  Ro->m22 = R_m22;
}

/* Do = D [R_z(-θ) | 0], dc = (sin θ, cos θ).
   D, Do: displacement [R | t], R rotation, t in m; dc: (sin θ, cos θ).
   12 mul, 6 add.
   Error <= u |result| + (R: 1/16, t: 0) u^2 S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_ddrzinvf_accurate(const ksl_SE3f_t *D, const float dc[2],
    ksl_SE3f_t *Do) {
  const double Do_00 = ksl_product_sum(-(double)D->m01, (double)dc[0], (double)D->m00
          * (double)dc[1]),
      Do_01 = ksl_product_sum((double)D->m01, (double)dc[1], (double)D->m00 * (double)dc[0]),
      Do_10 = ksl_product_sum(-(double)D->m11, (double)dc[0], (double)D->m10 * (double)dc[1]),
      Do_11 = ksl_product_sum((double)D->m11, (double)dc[1], (double)D->m10 * (double)dc[0]),
      Do_20 = ksl_product_sum(-(double)D->m21, (double)dc[0], (double)D->m20 * (double)dc[1]),
      Do_21 = ksl_product_sum((double)D->m21, (double)dc[1], (double)D->m20 * (double)dc[0]);
  const float D_m02 = D->m02;
  const float D_m03 = D->m03;
  const float D_m12 = D->m12;
  const float D_m13 = D->m13;
  const float D_m22 = D->m22;
  const float D_m23 = D->m23;
  Do->m00 = (float)Do_00;
  Do->m01 = (float)Do_01;
  Do->m02 = D_m02;
  Do->m03 = D_m03;
  Do->m10 = (float)Do_10;
  Do->m11 = (float)Do_11;
  Do->m12 = D_m12;
  Do->m13 = D_m13;
  Do->m20 = (float)Do_20;
  Do->m21 = (float)Do_21;
  Do->m22 = D_m22;
  Do->m23 = D_m23;
}

/* Do = D [I | -k e_z].
   D, Do: displacement [R | t], R rotation, t in m; k: number.
   3 mul, 3 add.
   Error <= u |result| + (R: 0, t: 1/16) u^2 S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_ddtzinvf_accurate(const ksl_SE3f_t *D, const float k,
    ksl_SE3f_t *Do) {
  const double Do_03 = ksl_product_sum(-(double)D->m02, (double)k, (double)D->m03),
      Do_13 = ksl_product_sum(-(double)D->m12, (double)k, (double)D->m13),
      Do_23 = ksl_product_sum(-(double)D->m22, (double)k, (double)D->m23);
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
  Do->m03 = (float)Do_03;
  Do->m10 = D_m10;
  Do->m11 = D_m11;
  Do->m12 = D_m12;
  Do->m13 = (float)Do_13;
  Do->m20 = D_m20;
  Do->m21 = D_m21;
  Do->m22 = D_m22;
  Do->m23 = (float)Do_23;
}

#endif
