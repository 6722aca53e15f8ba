/* Made by `coscrew generate`; changes are overwritten. */
/* SPDX-License-Identifier: MIT */
/* coscrew 0.2.0.  Copyright (c) 2026 The coscrew authors. */
/* Products between rotations, displacements and vectors. */
#ifndef KSL_MATRIX_H
#define KSL_MATRIX_H

#include "ksl_types.h"
#include "SE3.h"
#include "trig.h"

/* vo = R v.
   R: rotation or other 3×3 matrix; v, vo: vector.
   9 mul, 6 add.
   Error <= u |result| + 2 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_product_drv(const ksl_mat3x3_t *R, const ksl_vec3_t *v, ksl_vec3_t *vo) {
  const double vo_0a = KSL_MUL(R->m00, v->x), vo_0b = KSL_MUL(R->m01, v->y), vo_0c = vo_0a + vo_0b,
      vo_0d = KSL_MUL(R->m02, v->z), vo_0 = vo_0c + vo_0d;
  const double vo_1a = KSL_MUL(R->m10, v->x), vo_1b = KSL_MUL(R->m11, v->y), vo_1c = vo_1a + vo_1b,
      vo_1d = KSL_MUL(R->m12, v->z), vo_1 = vo_1c + vo_1d;
  const double vo_2a = KSL_MUL(R->m20, v->x), vo_2b = KSL_MUL(R->m21, v->y), vo_2c = vo_2a + vo_2b,
      vo_2d = KSL_MUL(R->m22, v->z), vo_2 = vo_2c + vo_2d;
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
}

/* vo = R (-v).
   R: rotation or other 3×3 matrix; v, vo: vector.
   9 mul, 6 add, 3 neg.
   Error <= u |result| + 2 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_product_drvinv(const ksl_mat3x3_t *R, const ksl_vec3_t *v, ksl_vec3_t *vo) {
  const double vo_0a = KSL_MUL(R->m00, v->x), vo_0b = KSL_MUL(R->m01, v->y), vo_0c = vo_0a + vo_0b,
      vo_0d = KSL_MUL(R->m02, v->z), vo_0e = vo_0c + vo_0d, vo_0 = -vo_0e;
  const double vo_1a = KSL_MUL(R->m10, v->x), vo_1b = KSL_MUL(R->m11, v->y), vo_1c = vo_1a + vo_1b,
      vo_1d = KSL_MUL(R->m12, v->z), vo_1e = vo_1c + vo_1d, vo_1 = -vo_1e;
  const double vo_2a = KSL_MUL(R->m20, v->x), vo_2b = KSL_MUL(R->m21, v->y), vo_2c = vo_2a + vo_2b,
      vo_2d = KSL_MUL(R->m22, v->z), vo_2e = vo_2c + vo_2d, vo_2 = -vo_2e;
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
}

/* vo = R^T v.
   R: rotation or other 3×3 matrix; v, vo: vector.
   9 mul, 6 add.
   Error <= u |result| + 2 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_product_drinvv(const ksl_mat3x3_t *R, const ksl_vec3_t *v, ksl_vec3_t *vo) {
  const double vo_0a = KSL_MUL(R->m00, v->x), vo_0b = KSL_MUL(R->m10, v->y), vo_0c = vo_0a + vo_0b,
      vo_0d = KSL_MUL(R->m20, v->z), vo_0 = vo_0c + vo_0d;
  const double vo_1a = KSL_MUL(R->m01, v->x), vo_1b = KSL_MUL(R->m11, v->y), vo_1c = vo_1a + vo_1b,
      vo_1d = KSL_MUL(R->m21, v->z), vo_1 = vo_1c + vo_1d;
  const double vo_2a = KSL_MUL(R->m02, v->x), vo_2b = KSL_MUL(R->m12, v->y), vo_2c = vo_2a + vo_2b,
      vo_2d = KSL_MUL(R->m22, v->z), vo_2 = vo_2c + vo_2d;
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
}

/* vo = R^T (-v).
   R: rotation or other 3×3 matrix; v, vo: vector.
   9 mul, 6 add, 3 neg.
   Error <= u |result| + 2 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_product_drinvvinv(const ksl_mat3x3_t *R, const ksl_vec3_t *v,
    ksl_vec3_t *vo) {
  const double vo_0a = KSL_MUL(R->m00, v->x), vo_0b = KSL_MUL(R->m10, v->y), vo_0c = vo_0a + vo_0b,
      vo_0d = KSL_MUL(R->m20, v->z), vo_0e = vo_0c + vo_0d, vo_0 = -vo_0e;
  const double vo_1a = KSL_MUL(R->m01, v->x), vo_1b = KSL_MUL(R->m11, v->y), vo_1c = vo_1a + vo_1b,
      vo_1d = KSL_MUL(R->m21, v->z), vo_1e = vo_1c + vo_1d, vo_1 = -vo_1e;
  const double vo_2a = KSL_MUL(R->m02, v->x), vo_2b = KSL_MUL(R->m12, v->y), vo_2c = vo_2a + vo_2b,
      vo_2d = KSL_MUL(R->m22, v->z), vo_2e = vo_2c + vo_2d, vo_2 = -vo_2e;
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
}

/* vo = R v + t.
   D: displacement [R | t], R rotation, t in m; v, vo: vector.
   9 mul, 9 add.
   Error <= u |result| + 3 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_product_dv(const ksl_SE3_t *D, const ksl_vec3_t *v, ksl_vec3_t *vo) {
  const double vo_0a = KSL_MUL(D->m00, v->x), vo_0b = KSL_MUL(D->m01, v->y), vo_0c = vo_0a + vo_0b,
      vo_0d = KSL_MUL(D->m02, v->z), vo_0e = vo_0c + vo_0d, vo_0 = vo_0e + D->m03;
  const double vo_1a = KSL_MUL(D->m10, v->x), vo_1b = KSL_MUL(D->m11, v->y), vo_1c = vo_1a + vo_1b,
      vo_1d = KSL_MUL(D->m12, v->z), vo_1e = vo_1c + vo_1d, vo_1 = vo_1e + D->m13;
  const double vo_2a = KSL_MUL(D->m20, v->x), vo_2b = KSL_MUL(D->m21, v->y), vo_2c = vo_2a + vo_2b,
      vo_2d = KSL_MUL(D->m22, v->z), vo_2e = vo_2c + vo_2d, vo_2 = vo_2e + D->m23;
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
}

/* vo = R^T (v - t).
   D: displacement [R | t], R rotation, t in m; v, vo: vector.
   9 mul, 9 add.
   Error <= u |result| + 3 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_product_dinvv(const ksl_SE3_t *D, const ksl_vec3_t *v, ksl_vec3_t *vo) {
  const double p_0 = v->x - D->m03;
  const double p_1 = v->y - D->m13;
  const double p_2 = v->z - D->m23;
  const double vo_0a = KSL_MUL(D->m00, p_0), vo_0b = KSL_MUL(D->m10, p_1), vo_0c = vo_0a + vo_0b,
      vo_0d = KSL_MUL(D->m20, p_2), vo_0 = vo_0c + vo_0d;
  const double vo_1a = KSL_MUL(D->m01, p_0), vo_1b = KSL_MUL(D->m11, p_1), vo_1c = vo_1a + vo_1b,
      vo_1d = KSL_MUL(D->m21, p_2), vo_1 = vo_1c + vo_1d;
  const double vo_2a = KSL_MUL(D->m02, p_0), vo_2b = KSL_MUL(D->m12, p_1), vo_2c = vo_2a + vo_2b,
      vo_2d = KSL_MUL(D->m22, p_2), vo_2 = vo_2c + vo_2d;
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
}

/* Ro = R1 R2.
   R1, R2, Ro: rotation or other 3×3 matrix.
   27 mul, 18 add.
   Error <= u |result| + 2 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_product_drdr(const ksl_mat3x3_t *R1, const ksl_mat3x3_t *R2,
    ksl_mat3x3_t *Ro) {
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
  Ro->m00 = Ro_00;
  Ro->m01 = Ro_01;
  Ro->m02 = Ro_02;
  Ro->m10 = Ro_10;
  Ro->m11 = Ro_11;
  Ro->m12 = Ro_12;
  Ro->m20 = Ro_20;
  Ro->m21 = Ro_21;
  Ro->m22 = Ro_22;
}

/* Ro = R1 R2^T.
   R1, R2, Ro: rotation or other 3×3 matrix.
   27 mul, 18 add.
   Error <= u |result| + 2 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_product_drdrinv(const ksl_mat3x3_t *R1, const ksl_mat3x3_t *R2,
    ksl_mat3x3_t *Ro) {
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
  Ro->m00 = Ro_00;
  Ro->m01 = Ro_01;
  Ro->m02 = Ro_02;
  Ro->m10 = Ro_10;
  Ro->m11 = Ro_11;
  Ro->m12 = Ro_12;
  Ro->m20 = Ro_20;
  Ro->m21 = Ro_21;
  Ro->m22 = Ro_22;
}

/* Ro = R1^T R2.
   R1, R2, Ro: rotation or other 3×3 matrix.
   27 mul, 18 add.
   Error <= u |result| + 2 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_product_drinvdr(const ksl_mat3x3_t *R1, const ksl_mat3x3_t *R2,
    ksl_mat3x3_t *Ro) {
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
  Ro->m00 = Ro_00;
  Ro->m01 = Ro_01;
  Ro->m02 = Ro_02;
  Ro->m10 = Ro_10;
  Ro->m11 = Ro_11;
  Ro->m12 = Ro_12;
  Ro->m20 = Ro_20;
  Ro->m21 = Ro_21;
  Ro->m22 = Ro_22;
}

/* Do = D1 D2 = [R1 R2 | R1 t2 + t1].
   D1, D2, Do: displacement [R | t], R rotation, t in m.
   36 mul, 27 add.
   Error <= u |result| + (R: 2, t: 3) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_dd(const ksl_SE3_t *D1, const ksl_SE3_t *D2, ksl_SE3_t *Do) {
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
}

/* Do = D1 D2^-1 = [R | t1 - R t2], R = R1 R2^T.
   D1, D2, Do: displacement [R | t], R rotation, t in m.
   36 mul, 27 add.
   Error <= u |result| + (R: 2, t: 6) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_ddinv(const ksl_SE3_t *D1, const ksl_SE3_t *D2, ksl_SE3_t *Do) {
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
}

/* Do = D1^-1 D2 = [R1^T R2 | R1^T (t2 - t1)].
   D1, D2, Do: displacement [R | t], R rotation, t in m.
   36 mul, 27 add.
   Error <= u |result| + (R: 2, t: 3) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_dinvd(const ksl_SE3_t *D1, const ksl_SE3_t *D2, ksl_SE3_t *Do) {
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
}

/* Do = D [R | 0].
   D, Do: displacement [R | t], R rotation, t in m; R: rotation or other 3×3 matrix.
   27 mul, 18 add.
   Error <= u |result| + (R: 2, t: 0) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_ddr(const ksl_SE3_t *D, const ksl_mat3x3_t *R, ksl_SE3_t *Do) {
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
}

/* Do = D [R^T | 0].
   D, Do: displacement [R | t], R rotation, t in m; R: rotation or other 3×3 matrix.
   27 mul, 18 add.
   Error <= u |result| + (R: 2, t: 0) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_ddrinv(const ksl_SE3_t *D, const ksl_mat3x3_t *R, ksl_SE3_t *Do) {
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
}

/* Do = D [I | t].
   D, Do: displacement [R | t], R rotation, t in m; t: vector.
   9 mul, 9 add.
   Error <= u |result| + (R: 0, t: 3) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_ddt(const ksl_SE3_t *D, const ksl_vec3_t *t, ksl_SE3_t *Do) {
  const double Do_03a = KSL_MUL(D->m00, t->x), Do_03b = KSL_MUL(D->m01, t->y),
      Do_03c = Do_03a + Do_03b, Do_03d = KSL_MUL(D->m02, t->z), Do_03e = Do_03c + Do_03d,
      Do_03 = Do_03e + D->m03;
  const double Do_13a = KSL_MUL(D->m10, t->x), Do_13b = KSL_MUL(D->m11, t->y),
      Do_13c = Do_13a + Do_13b, Do_13d = KSL_MUL(D->m12, t->z), Do_13e = Do_13c + Do_13d,
      Do_13 = Do_13e + D->m13;
  const double Do_23a = KSL_MUL(D->m20, t->x), Do_23b = KSL_MUL(D->m21, t->y),
      Do_23c = Do_23a + Do_23b, Do_23d = KSL_MUL(D->m22, t->z), Do_23e = Do_23c + Do_23d,
      Do_23 = Do_23e + D->m23;
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
}

/* Do = D [I | -t].
   D, Do: displacement [R | t], R rotation, t in m; t: vector.
   9 mul, 9 add.
   Error <= u |result| + (R: 0, t: 3) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_ddtinv(const ksl_SE3_t *D, const ksl_vec3_t *t, ksl_SE3_t *Do) {
  const double Do_03a = KSL_MUL(D->m00, t->x), Do_03b = KSL_MUL(D->m01, t->y),
      Do_03c = Do_03a + Do_03b, Do_03d = KSL_MUL(D->m02, t->z), Do_03e = Do_03c + Do_03d,
      Do_03 = D->m03 - Do_03e;
  const double Do_13a = KSL_MUL(D->m10, t->x), Do_13b = KSL_MUL(D->m11, t->y),
      Do_13c = Do_13a + Do_13b, Do_13d = KSL_MUL(D->m12, t->z), Do_13e = Do_13c + Do_13d,
      Do_13 = D->m13 - Do_13e;
  const double Do_23a = KSL_MUL(D->m20, t->x), Do_23b = KSL_MUL(D->m21, t->y),
      Do_23c = Do_23a + Do_23b, Do_23d = KSL_MUL(D->m22, t->z), Do_23e = Do_23c + Do_23d,
      Do_23 = D->m23 - Do_23e;
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
}

/* Do = D^-1 [I | t] = [R^T | R^T (t - t_D)].
   D, Do: displacement [R | t], R rotation, t in m; t: vector.
   9 mul, 9 add.
   Error <= u |result| + (R: 0, t: 3) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_dinvdt(const ksl_SE3_t *D, const ksl_vec3_t *t, ksl_SE3_t *Do) {
  const double p_0 = t->x - D->m03;
  const double p_1 = t->y - D->m13;
  const double p_2 = t->z - D->m23;
  const double Do_03a = KSL_MUL(D->m00, p_0), Do_03b = KSL_MUL(D->m10, p_1),
      Do_03c = Do_03a + Do_03b, Do_03d = KSL_MUL(D->m20, p_2), Do_03 = Do_03c + Do_03d;
  const double Do_13a = KSL_MUL(D->m01, p_0), Do_13b = KSL_MUL(D->m11, p_1),
      Do_13c = Do_13a + Do_13b, Do_13d = KSL_MUL(D->m21, p_2), Do_13 = Do_13c + Do_13d;
  const double Do_23a = KSL_MUL(D->m02, p_0), Do_23b = KSL_MUL(D->m12, p_1),
      Do_23c = Do_23a + Do_23b, Do_23d = KSL_MUL(D->m22, p_2), Do_23 = Do_23c + Do_23d;
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
}

/* vo = R (k e_x).
   R: rotation or other 3×3 matrix; k: number; vo: vector.
   3 mul.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_product_drvtx(const ksl_mat3x3_t *R, const double k, ksl_vec3_t *vo) {
  const double vo_0 = KSL_MUL(R->m00, k);
  const double vo_1 = KSL_MUL(R->m10, k);
  const double vo_2 = KSL_MUL(R->m20, k);
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
}

/* Ro = R R_x(θ), dc = (sin θ, cos θ).
   R, Ro: rotation or other 3×3 matrix; dc: (sin θ, cos θ).
   12 mul, 6 add.
   Error <= u |result| + 1 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_product_drdrx(const ksl_mat3x3_t *R, const double dc[2], ksl_mat3x3_t *Ro) {
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
}

/* Do = D [R_x(θ) | 0], dc = (sin θ, cos θ).
   D, Do: displacement [R | t], R rotation, t in m; dc: (sin θ, cos θ).
   12 mul, 6 add.
   Error <= u |result| + (R: 1, t: 0) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_ddrx(const ksl_SE3_t *D, const double dc[2], ksl_SE3_t *Do) {
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
}

/* Do = D [I | k e_x].
   D, Do: displacement [R | t], R rotation, t in m; k: number.
   3 mul, 3 add.
   Error <= u |result| + (R: 0, t: 1) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_ddtx(const ksl_SE3_t *D, const double k, ksl_SE3_t *Do) {
  const double Do_03a = KSL_MUL(D->m00, k), Do_03 = Do_03a + D->m03;
  const double Do_13a = KSL_MUL(D->m10, k), Do_13 = Do_13a + D->m13;
  const double Do_23a = KSL_MUL(D->m20, k), Do_23 = Do_23a + D->m23;
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
}

/* vo = R (-k e_x).
   R: rotation or other 3×3 matrix; k: number; vo: vector.
   3 mul, 3 neg.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_product_drvtxinv(const ksl_mat3x3_t *R, const double k, ksl_vec3_t *vo) {
  const double vo_0a = KSL_MUL(R->m00, k), vo_0 = -vo_0a;
  const double vo_1a = KSL_MUL(R->m10, k), vo_1 = -vo_1a;
  const double vo_2a = KSL_MUL(R->m20, k), vo_2 = -vo_2a;
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
}

/* Ro = R R_x(-θ), dc = (sin θ, cos θ).
   R, Ro: rotation or other 3×3 matrix; dc: (sin θ, cos θ).
   12 mul, 6 add.
   Error <= u |result| + 1 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_product_drdrxinv(const ksl_mat3x3_t *R, const double dc[2],
    ksl_mat3x3_t *Ro) {
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
}

/* Do = D [R_x(-θ) | 0], dc = (sin θ, cos θ).
   D, Do: displacement [R | t], R rotation, t in m; dc: (sin θ, cos θ).
   12 mul, 6 add.
   Error <= u |result| + (R: 1, t: 0) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_ddrxinv(const ksl_SE3_t *D, const double dc[2], ksl_SE3_t *Do) {
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
}

/* Do = D [I | -k e_x].
   D, Do: displacement [R | t], R rotation, t in m; k: number.
   3 mul, 3 add.
   Error <= u |result| + (R: 0, t: 1) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_ddtxinv(const ksl_SE3_t *D, const double k, ksl_SE3_t *Do) {
  const double Do_03a = KSL_MUL(D->m00, k), Do_03 = D->m03 - Do_03a;
  const double Do_13a = KSL_MUL(D->m10, k), Do_13 = D->m13 - Do_13a;
  const double Do_23a = KSL_MUL(D->m20, k), Do_23 = D->m23 - Do_23a;
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
}

/* vo = R (k e_y).
   R: rotation or other 3×3 matrix; k: number; vo: vector.
   3 mul.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_product_drvty(const ksl_mat3x3_t *R, const double k, ksl_vec3_t *vo) {
  const double vo_0 = KSL_MUL(R->m01, k);
  const double vo_1 = KSL_MUL(R->m11, k);
  const double vo_2 = KSL_MUL(R->m21, k);
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
}

/* Ro = R R_y(θ), dc = (sin θ, cos θ).
   R, Ro: rotation or other 3×3 matrix; dc: (sin θ, cos θ).
   12 mul, 6 add.
   Error <= u |result| + 1 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_product_drdry(const ksl_mat3x3_t *R, const double dc[2], ksl_mat3x3_t *Ro) {
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
}

/* Do = D [R_y(θ) | 0], dc = (sin θ, cos θ).
   D, Do: displacement [R | t], R rotation, t in m; dc: (sin θ, cos θ).
   12 mul, 6 add.
   Error <= u |result| + (R: 1, t: 0) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_ddry(const ksl_SE3_t *D, const double dc[2], ksl_SE3_t *Do) {
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
}

/* Do = D [I | k e_y].
   D, Do: displacement [R | t], R rotation, t in m; k: number.
   3 mul, 3 add.
   Error <= u |result| + (R: 0, t: 1) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_ddty(const ksl_SE3_t *D, const double k, ksl_SE3_t *Do) {
  const double Do_03a = KSL_MUL(D->m01, k), Do_03 = Do_03a + D->m03;
  const double Do_13a = KSL_MUL(D->m11, k), Do_13 = Do_13a + D->m13;
  const double Do_23a = KSL_MUL(D->m21, k), Do_23 = Do_23a + D->m23;
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
}

/* vo = R (-k e_y).
   R: rotation or other 3×3 matrix; k: number; vo: vector.
   3 mul, 3 neg.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_product_drvtyinv(const ksl_mat3x3_t *R, const double k, ksl_vec3_t *vo) {
  const double vo_0a = KSL_MUL(R->m01, k), vo_0 = -vo_0a;
  const double vo_1a = KSL_MUL(R->m11, k), vo_1 = -vo_1a;
  const double vo_2a = KSL_MUL(R->m21, k), vo_2 = -vo_2a;
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
}

/* Ro = R R_y(-θ), dc = (sin θ, cos θ).
   R, Ro: rotation or other 3×3 matrix; dc: (sin θ, cos θ).
   12 mul, 6 add.
   Error <= u |result| + 1 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_product_drdryinv(const ksl_mat3x3_t *R, const double dc[2],
    ksl_mat3x3_t *Ro) {
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
}

/* Do = D [R_y(-θ) | 0], dc = (sin θ, cos θ).
   D, Do: displacement [R | t], R rotation, t in m; dc: (sin θ, cos θ).
   12 mul, 6 add.
   Error <= u |result| + (R: 1, t: 0) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_ddryinv(const ksl_SE3_t *D, const double dc[2], ksl_SE3_t *Do) {
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
}

/* Do = D [I | -k e_y].
   D, Do: displacement [R | t], R rotation, t in m; k: number.
   3 mul, 3 add.
   Error <= u |result| + (R: 0, t: 1) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_ddtyinv(const ksl_SE3_t *D, const double k, ksl_SE3_t *Do) {
  const double Do_03a = KSL_MUL(D->m01, k), Do_03 = D->m03 - Do_03a;
  const double Do_13a = KSL_MUL(D->m11, k), Do_13 = D->m13 - Do_13a;
  const double Do_23a = KSL_MUL(D->m21, k), Do_23 = D->m23 - Do_23a;
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
}

/* vo = R (k e_z).
   R: rotation or other 3×3 matrix; k: number; vo: vector.
   3 mul.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_product_drvtz(const ksl_mat3x3_t *R, const double k, ksl_vec3_t *vo) {
  const double vo_0 = KSL_MUL(R->m02, k);
  const double vo_1 = KSL_MUL(R->m12, k);
  const double vo_2 = KSL_MUL(R->m22, k);
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
}

/* Ro = R R_z(θ), dc = (sin θ, cos θ).
   R, Ro: rotation or other 3×3 matrix; dc: (sin θ, cos θ).
   12 mul, 6 add.
   Error <= u |result| + 1 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_product_drdrz(const ksl_mat3x3_t *R, const double dc[2], ksl_mat3x3_t *Ro) {
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
}

/* Do = D [R_z(θ) | 0], dc = (sin θ, cos θ).
   D, Do: displacement [R | t], R rotation, t in m; dc: (sin θ, cos θ).
   12 mul, 6 add.
   Error <= u |result| + (R: 1, t: 0) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_ddrz(const ksl_SE3_t *D, const double dc[2], ksl_SE3_t *Do) {
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
}

/* Do = D [I | k e_z].
   D, Do: displacement [R | t], R rotation, t in m; k: number.
   3 mul, 3 add.
   Error <= u |result| + (R: 0, t: 1) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_ddtz(const ksl_SE3_t *D, const double k, ksl_SE3_t *Do) {
  const double Do_03a = KSL_MUL(D->m02, k), Do_03 = Do_03a + D->m03;
  const double Do_13a = KSL_MUL(D->m12, k), Do_13 = Do_13a + D->m13;
  const double Do_23a = KSL_MUL(D->m22, k), Do_23 = Do_23a + D->m23;
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
}

/* vo = R (-k e_z).
   R: rotation or other 3×3 matrix; k: number; vo: vector.
   3 mul, 3 neg.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_product_drvtzinv(const ksl_mat3x3_t *R, const double k, ksl_vec3_t *vo) {
  const double vo_0a = KSL_MUL(R->m02, k), vo_0 = -vo_0a;
  const double vo_1a = KSL_MUL(R->m12, k), vo_1 = -vo_1a;
  const double vo_2a = KSL_MUL(R->m22, k), vo_2 = -vo_2a;
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
}

/* Ro = R R_z(-θ), dc = (sin θ, cos θ).
   R, Ro: rotation or other 3×3 matrix; dc: (sin θ, cos θ).
   12 mul, 6 add.
   Error <= u |result| + 1 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_product_drdrzinv(const ksl_mat3x3_t *R, const double dc[2],
    ksl_mat3x3_t *Ro) {
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
}

/* Do = D [R_z(-θ) | 0], dc = (sin θ, cos θ).
   D, Do: displacement [R | t], R rotation, t in m; dc: (sin θ, cos θ).
   12 mul, 6 add.
   Error <= u |result| + (R: 1, t: 0) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_ddrzinv(const ksl_SE3_t *D, const double dc[2], ksl_SE3_t *Do) {
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
}

/* Do = D [I | -k e_z].
   D, Do: displacement [R | t], R rotation, t in m; k: number.
   3 mul, 3 add.
   Error <= u |result| + (R: 0, t: 1) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_ddtzinv(const ksl_SE3_t *D, const double k, ksl_SE3_t *Do) {
  const double Do_03a = KSL_MUL(D->m02, k), Do_03 = D->m03 - Do_03a;
  const double Do_13a = KSL_MUL(D->m12, k), Do_13 = D->m13 - Do_13a;
  const double Do_23a = KSL_MUL(D->m22, k), Do_23 = D->m23 - Do_23a;
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
}

/* vo = R v.
   R: rotation or other 3×3 matrix; v, vo: vector.
   9 mul, 6 add.
   Error <= u |result| + 2 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_product_drvf(const ksl_mat3x3f_t *R, const ksl_vec3f_t *v, ksl_vec3f_t *vo) {
  const float vo_0a = KSL_MULF(R->m00, v->x), vo_0b = KSL_MULF(R->m01, v->y), vo_0c = vo_0a + vo_0b,
      vo_0d = KSL_MULF(R->m02, v->z), vo_0 = vo_0c + vo_0d;
  const float vo_1a = KSL_MULF(R->m10, v->x), vo_1b = KSL_MULF(R->m11, v->y), vo_1c = vo_1a + vo_1b,
      vo_1d = KSL_MULF(R->m12, v->z), vo_1 = vo_1c + vo_1d;
  const float vo_2a = KSL_MULF(R->m20, v->x), vo_2b = KSL_MULF(R->m21, v->y), vo_2c = vo_2a + vo_2b,
      vo_2d = KSL_MULF(R->m22, v->z), vo_2 = vo_2c + vo_2d;
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
}

/* vo = R (-v).
   R: rotation or other 3×3 matrix; v, vo: vector.
   9 mul, 6 add, 3 neg.
   Error <= u |result| + 2 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_product_drvinvf(const ksl_mat3x3f_t *R, const ksl_vec3f_t *v,
    ksl_vec3f_t *vo) {
  const float vo_0a = KSL_MULF(R->m00, v->x), vo_0b = KSL_MULF(R->m01, v->y), vo_0c = vo_0a + vo_0b,
      vo_0d = KSL_MULF(R->m02, v->z), vo_0e = vo_0c + vo_0d, vo_0 = -vo_0e;
  const float vo_1a = KSL_MULF(R->m10, v->x), vo_1b = KSL_MULF(R->m11, v->y), vo_1c = vo_1a + vo_1b,
      vo_1d = KSL_MULF(R->m12, v->z), vo_1e = vo_1c + vo_1d, vo_1 = -vo_1e;
  const float vo_2a = KSL_MULF(R->m20, v->x), vo_2b = KSL_MULF(R->m21, v->y), vo_2c = vo_2a + vo_2b,
      vo_2d = KSL_MULF(R->m22, v->z), vo_2e = vo_2c + vo_2d, vo_2 = -vo_2e;
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
}

/* vo = R^T v.
   R: rotation or other 3×3 matrix; v, vo: vector.
   9 mul, 6 add.
   Error <= u |result| + 2 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_product_drinvvf(const ksl_mat3x3f_t *R, const ksl_vec3f_t *v,
    ksl_vec3f_t *vo) {
  const float vo_0a = KSL_MULF(R->m00, v->x), vo_0b = KSL_MULF(R->m10, v->y), vo_0c = vo_0a + vo_0b,
      vo_0d = KSL_MULF(R->m20, v->z), vo_0 = vo_0c + vo_0d;
  const float vo_1a = KSL_MULF(R->m01, v->x), vo_1b = KSL_MULF(R->m11, v->y), vo_1c = vo_1a + vo_1b,
      vo_1d = KSL_MULF(R->m21, v->z), vo_1 = vo_1c + vo_1d;
  const float vo_2a = KSL_MULF(R->m02, v->x), vo_2b = KSL_MULF(R->m12, v->y), vo_2c = vo_2a + vo_2b,
      vo_2d = KSL_MULF(R->m22, v->z), vo_2 = vo_2c + vo_2d;
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
}

/* vo = R^T (-v).
   R: rotation or other 3×3 matrix; v, vo: vector.
   9 mul, 6 add, 3 neg.
   Error <= u |result| + 2 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_product_drinvvinvf(const ksl_mat3x3f_t *R, const ksl_vec3f_t *v,
    ksl_vec3f_t *vo) {
  const float vo_0a = KSL_MULF(R->m00, v->x), vo_0b = KSL_MULF(R->m10, v->y), vo_0c = vo_0a + vo_0b,
      vo_0d = KSL_MULF(R->m20, v->z), vo_0e = vo_0c + vo_0d, vo_0 = -vo_0e;
  const float vo_1a = KSL_MULF(R->m01, v->x), vo_1b = KSL_MULF(R->m11, v->y), vo_1c = vo_1a + vo_1b,
      vo_1d = KSL_MULF(R->m21, v->z), vo_1e = vo_1c + vo_1d, vo_1 = -vo_1e;
  const float vo_2a = KSL_MULF(R->m02, v->x), vo_2b = KSL_MULF(R->m12, v->y), vo_2c = vo_2a + vo_2b,
      vo_2d = KSL_MULF(R->m22, v->z), vo_2e = vo_2c + vo_2d, vo_2 = -vo_2e;
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
}

/* vo = R v + t.
   D: displacement [R | t], R rotation, t in m; v, vo: vector.
   9 mul, 9 add.
   Error <= u |result| + 3 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_product_dvf(const ksl_SE3f_t *D, const ksl_vec3f_t *v, ksl_vec3f_t *vo) {
  const float vo_0a = KSL_MULF(D->m00, v->x), vo_0b = KSL_MULF(D->m01, v->y), vo_0c = vo_0a + vo_0b,
      vo_0d = KSL_MULF(D->m02, v->z), vo_0e = vo_0c + vo_0d, vo_0 = vo_0e + D->m03;
  const float vo_1a = KSL_MULF(D->m10, v->x), vo_1b = KSL_MULF(D->m11, v->y), vo_1c = vo_1a + vo_1b,
      vo_1d = KSL_MULF(D->m12, v->z), vo_1e = vo_1c + vo_1d, vo_1 = vo_1e + D->m13;
  const float vo_2a = KSL_MULF(D->m20, v->x), vo_2b = KSL_MULF(D->m21, v->y), vo_2c = vo_2a + vo_2b,
      vo_2d = KSL_MULF(D->m22, v->z), vo_2e = vo_2c + vo_2d, vo_2 = vo_2e + D->m23;
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
}

/* vo = R^T (v - t).
   D: displacement [R | t], R rotation, t in m; v, vo: vector.
   9 mul, 9 add.
   Error <= u |result| + 3 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_product_dinvvf(const ksl_SE3f_t *D, const ksl_vec3f_t *v, ksl_vec3f_t *vo) {
  const float p_0 = v->x - D->m03;
  const float p_1 = v->y - D->m13;
  const float p_2 = v->z - D->m23;
  const float vo_0a = KSL_MULF(D->m00, p_0), vo_0b = KSL_MULF(D->m10, p_1), vo_0c = vo_0a + vo_0b,
      vo_0d = KSL_MULF(D->m20, p_2), vo_0 = vo_0c + vo_0d;
  const float vo_1a = KSL_MULF(D->m01, p_0), vo_1b = KSL_MULF(D->m11, p_1), vo_1c = vo_1a + vo_1b,
      vo_1d = KSL_MULF(D->m21, p_2), vo_1 = vo_1c + vo_1d;
  const float vo_2a = KSL_MULF(D->m02, p_0), vo_2b = KSL_MULF(D->m12, p_1), vo_2c = vo_2a + vo_2b,
      vo_2d = KSL_MULF(D->m22, p_2), vo_2 = vo_2c + vo_2d;
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
}

/* Ro = R1 R2.
   R1, R2, Ro: rotation or other 3×3 matrix.
   27 mul, 18 add.
   Error <= u |result| + 2 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_product_drdrf(const ksl_mat3x3f_t *R1, const ksl_mat3x3f_t *R2,
    ksl_mat3x3f_t *Ro) {
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
  Ro->m00 = Ro_00;
  Ro->m01 = Ro_01;
  Ro->m02 = Ro_02;
  Ro->m10 = Ro_10;
  Ro->m11 = Ro_11;
  Ro->m12 = Ro_12;
  Ro->m20 = Ro_20;
  Ro->m21 = Ro_21;
  Ro->m22 = Ro_22;
}

/* Ro = R1 R2^T.
   R1, R2, Ro: rotation or other 3×3 matrix.
   27 mul, 18 add.
   Error <= u |result| + 2 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_product_drdrinvf(const ksl_mat3x3f_t *R1, const ksl_mat3x3f_t *R2,
    ksl_mat3x3f_t *Ro) {
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
  Ro->m00 = Ro_00;
  Ro->m01 = Ro_01;
  Ro->m02 = Ro_02;
  Ro->m10 = Ro_10;
  Ro->m11 = Ro_11;
  Ro->m12 = Ro_12;
  Ro->m20 = Ro_20;
  Ro->m21 = Ro_21;
  Ro->m22 = Ro_22;
}

/* Ro = R1^T R2.
   R1, R2, Ro: rotation or other 3×3 matrix.
   27 mul, 18 add.
   Error <= u |result| + 2 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_product_drinvdrf(const ksl_mat3x3f_t *R1, const ksl_mat3x3f_t *R2,
    ksl_mat3x3f_t *Ro) {
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
  Ro->m00 = Ro_00;
  Ro->m01 = Ro_01;
  Ro->m02 = Ro_02;
  Ro->m10 = Ro_10;
  Ro->m11 = Ro_11;
  Ro->m12 = Ro_12;
  Ro->m20 = Ro_20;
  Ro->m21 = Ro_21;
  Ro->m22 = Ro_22;
}

/* Do = D1 D2 = [R1 R2 | R1 t2 + t1].
   D1, D2, Do: displacement [R | t], R rotation, t in m.
   36 mul, 27 add.
   Error <= u |result| + (R: 2, t: 3) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_ddf(const ksl_SE3f_t *D1, const ksl_SE3f_t *D2, ksl_SE3f_t *Do) {
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
}

/* Do = D1 D2^-1 = [R | t1 - R t2], R = R1 R2^T.
   D1, D2, Do: displacement [R | t], R rotation, t in m.
   36 mul, 27 add.
   Error <= u |result| + (R: 2, t: 6) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_ddinvf(const ksl_SE3f_t *D1, const ksl_SE3f_t *D2, ksl_SE3f_t *Do) {
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
}

/* Do = D1^-1 D2 = [R1^T R2 | R1^T (t2 - t1)].
   D1, D2, Do: displacement [R | t], R rotation, t in m.
   36 mul, 27 add.
   Error <= u |result| + (R: 2, t: 3) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_dinvdf(const ksl_SE3f_t *D1, const ksl_SE3f_t *D2, ksl_SE3f_t *Do) {
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
}

/* Do = D [R | 0].
   D, Do: displacement [R | t], R rotation, t in m; R: rotation or other 3×3 matrix.
   27 mul, 18 add.
   Error <= u |result| + (R: 2, t: 0) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_ddrf(const ksl_SE3f_t *D, const ksl_mat3x3f_t *R, ksl_SE3f_t *Do) {
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
}

/* Do = D [R^T | 0].
   D, Do: displacement [R | t], R rotation, t in m; R: rotation or other 3×3 matrix.
   27 mul, 18 add.
   Error <= u |result| + (R: 2, t: 0) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_ddrinvf(const ksl_SE3f_t *D, const ksl_mat3x3f_t *R,
    ksl_SE3f_t *Do) {
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
}

/* Do = D [I | t].
   D, Do: displacement [R | t], R rotation, t in m; t: vector.
   9 mul, 9 add.
   Error <= u |result| + (R: 0, t: 3) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_ddtf(const ksl_SE3f_t *D, const ksl_vec3f_t *t, ksl_SE3f_t *Do) {
  const float Do_03a = KSL_MULF(D->m00, t->x), Do_03b = KSL_MULF(D->m01, t->y),
      Do_03c = Do_03a + Do_03b, Do_03d = KSL_MULF(D->m02, t->z), Do_03e = Do_03c + Do_03d,
      Do_03 = Do_03e + D->m03;
  const float Do_13a = KSL_MULF(D->m10, t->x), Do_13b = KSL_MULF(D->m11, t->y),
      Do_13c = Do_13a + Do_13b, Do_13d = KSL_MULF(D->m12, t->z), Do_13e = Do_13c + Do_13d,
      Do_13 = Do_13e + D->m13;
  const float Do_23a = KSL_MULF(D->m20, t->x), Do_23b = KSL_MULF(D->m21, t->y),
      Do_23c = Do_23a + Do_23b, Do_23d = KSL_MULF(D->m22, t->z), Do_23e = Do_23c + Do_23d,
      Do_23 = Do_23e + D->m23;
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
}

/* Do = D [I | -t].
   D, Do: displacement [R | t], R rotation, t in m; t: vector.
   9 mul, 9 add.
   Error <= u |result| + (R: 0, t: 3) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_ddtinvf(const ksl_SE3f_t *D, const ksl_vec3f_t *t, ksl_SE3f_t *Do) {
  const float Do_03a = KSL_MULF(D->m00, t->x), Do_03b = KSL_MULF(D->m01, t->y),
      Do_03c = Do_03a + Do_03b, Do_03d = KSL_MULF(D->m02, t->z), Do_03e = Do_03c + Do_03d,
      Do_03 = D->m03 - Do_03e;
  const float Do_13a = KSL_MULF(D->m10, t->x), Do_13b = KSL_MULF(D->m11, t->y),
      Do_13c = Do_13a + Do_13b, Do_13d = KSL_MULF(D->m12, t->z), Do_13e = Do_13c + Do_13d,
      Do_13 = D->m13 - Do_13e;
  const float Do_23a = KSL_MULF(D->m20, t->x), Do_23b = KSL_MULF(D->m21, t->y),
      Do_23c = Do_23a + Do_23b, Do_23d = KSL_MULF(D->m22, t->z), Do_23e = Do_23c + Do_23d,
      Do_23 = D->m23 - Do_23e;
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
}

/* Do = D^-1 [I | t] = [R^T | R^T (t - t_D)].
   D, Do: displacement [R | t], R rotation, t in m; t: vector.
   9 mul, 9 add.
   Error <= u |result| + (R: 0, t: 3) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_dinvdtf(const ksl_SE3f_t *D, const ksl_vec3f_t *t, ksl_SE3f_t *Do) {
  const float p_0 = t->x - D->m03;
  const float p_1 = t->y - D->m13;
  const float p_2 = t->z - D->m23;
  const float Do_03a = KSL_MULF(D->m00, p_0), Do_03b = KSL_MULF(D->m10, p_1),
      Do_03c = Do_03a + Do_03b, Do_03d = KSL_MULF(D->m20, p_2), Do_03 = Do_03c + Do_03d;
  const float Do_13a = KSL_MULF(D->m01, p_0), Do_13b = KSL_MULF(D->m11, p_1),
      Do_13c = Do_13a + Do_13b, Do_13d = KSL_MULF(D->m21, p_2), Do_13 = Do_13c + Do_13d;
  const float Do_23a = KSL_MULF(D->m02, p_0), Do_23b = KSL_MULF(D->m12, p_1),
      Do_23c = Do_23a + Do_23b, Do_23d = KSL_MULF(D->m22, p_2), Do_23 = Do_23c + Do_23d;
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
}

/* vo = R (k e_x).
   R: rotation or other 3×3 matrix; k: number; vo: vector.
   3 mul.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_product_drvtxf(const ksl_mat3x3f_t *R, const float k, ksl_vec3f_t *vo) {
  const float vo_0 = KSL_MULF(R->m00, k);
  const float vo_1 = KSL_MULF(R->m10, k);
  const float vo_2 = KSL_MULF(R->m20, k);
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
}

/* Ro = R R_x(θ), dc = (sin θ, cos θ).
   R, Ro: rotation or other 3×3 matrix; dc: (sin θ, cos θ).
   12 mul, 6 add.
   Error <= u |result| + 1 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_product_drdrxf(const ksl_mat3x3f_t *R, const float dc[2],
    ksl_mat3x3f_t *Ro) {
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
}

/* Do = D [R_x(θ) | 0], dc = (sin θ, cos θ).
   D, Do: displacement [R | t], R rotation, t in m; dc: (sin θ, cos θ).
   12 mul, 6 add.
   Error <= u |result| + (R: 1, t: 0) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_ddrxf(const ksl_SE3f_t *D, const float dc[2], ksl_SE3f_t *Do) {
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
}

/* Do = D [I | k e_x].
   D, Do: displacement [R | t], R rotation, t in m; k: number.
   3 mul, 3 add.
   Error <= u |result| + (R: 0, t: 1) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_ddtxf(const ksl_SE3f_t *D, const float k, ksl_SE3f_t *Do) {
  const float Do_03a = KSL_MULF(D->m00, k), Do_03 = Do_03a + D->m03;
  const float Do_13a = KSL_MULF(D->m10, k), Do_13 = Do_13a + D->m13;
  const float Do_23a = KSL_MULF(D->m20, k), Do_23 = Do_23a + D->m23;
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
}

/* vo = R (-k e_x).
   R: rotation or other 3×3 matrix; k: number; vo: vector.
   3 mul, 3 neg.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_product_drvtxinvf(const ksl_mat3x3f_t *R, const float k, ksl_vec3f_t *vo) {
  const float vo_0a = KSL_MULF(R->m00, k), vo_0 = -vo_0a;
  const float vo_1a = KSL_MULF(R->m10, k), vo_1 = -vo_1a;
  const float vo_2a = KSL_MULF(R->m20, k), vo_2 = -vo_2a;
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
}

/* Ro = R R_x(-θ), dc = (sin θ, cos θ).
   R, Ro: rotation or other 3×3 matrix; dc: (sin θ, cos θ).
   12 mul, 6 add.
   Error <= u |result| + 1 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_product_drdrxinvf(const ksl_mat3x3f_t *R, const float dc[2],
    ksl_mat3x3f_t *Ro) {
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
}

/* Do = D [R_x(-θ) | 0], dc = (sin θ, cos θ).
   D, Do: displacement [R | t], R rotation, t in m; dc: (sin θ, cos θ).
   12 mul, 6 add.
   Error <= u |result| + (R: 1, t: 0) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_ddrxinvf(const ksl_SE3f_t *D, const float dc[2], ksl_SE3f_t *Do) {
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
}

/* Do = D [I | -k e_x].
   D, Do: displacement [R | t], R rotation, t in m; k: number.
   3 mul, 3 add.
   Error <= u |result| + (R: 0, t: 1) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_ddtxinvf(const ksl_SE3f_t *D, const float k, ksl_SE3f_t *Do) {
  const float Do_03a = KSL_MULF(D->m00, k), Do_03 = D->m03 - Do_03a;
  const float Do_13a = KSL_MULF(D->m10, k), Do_13 = D->m13 - Do_13a;
  const float Do_23a = KSL_MULF(D->m20, k), Do_23 = D->m23 - Do_23a;
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
}

/* vo = R (k e_y).
   R: rotation or other 3×3 matrix; k: number; vo: vector.
   3 mul.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_product_drvtyf(const ksl_mat3x3f_t *R, const float k, ksl_vec3f_t *vo) {
  const float vo_0 = KSL_MULF(R->m01, k);
  const float vo_1 = KSL_MULF(R->m11, k);
  const float vo_2 = KSL_MULF(R->m21, k);
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
}

/* Ro = R R_y(θ), dc = (sin θ, cos θ).
   R, Ro: rotation or other 3×3 matrix; dc: (sin θ, cos θ).
   12 mul, 6 add.
   Error <= u |result| + 1 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_product_drdryf(const ksl_mat3x3f_t *R, const float dc[2],
    ksl_mat3x3f_t *Ro) {
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
}

/* Do = D [R_y(θ) | 0], dc = (sin θ, cos θ).
   D, Do: displacement [R | t], R rotation, t in m; dc: (sin θ, cos θ).
   12 mul, 6 add.
   Error <= u |result| + (R: 1, t: 0) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_ddryf(const ksl_SE3f_t *D, const float dc[2], ksl_SE3f_t *Do) {
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
}

/* Do = D [I | k e_y].
   D, Do: displacement [R | t], R rotation, t in m; k: number.
   3 mul, 3 add.
   Error <= u |result| + (R: 0, t: 1) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_ddtyf(const ksl_SE3f_t *D, const float k, ksl_SE3f_t *Do) {
  const float Do_03a = KSL_MULF(D->m01, k), Do_03 = Do_03a + D->m03;
  const float Do_13a = KSL_MULF(D->m11, k), Do_13 = Do_13a + D->m13;
  const float Do_23a = KSL_MULF(D->m21, k), Do_23 = Do_23a + D->m23;
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
}

/* vo = R (-k e_y).
   R: rotation or other 3×3 matrix; k: number; vo: vector.
   3 mul, 3 neg.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_product_drvtyinvf(const ksl_mat3x3f_t *R, const float k, ksl_vec3f_t *vo) {
  const float vo_0a = KSL_MULF(R->m01, k), vo_0 = -vo_0a;
  const float vo_1a = KSL_MULF(R->m11, k), vo_1 = -vo_1a;
  const float vo_2a = KSL_MULF(R->m21, k), vo_2 = -vo_2a;
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
}

/* Ro = R R_y(-θ), dc = (sin θ, cos θ).
   R, Ro: rotation or other 3×3 matrix; dc: (sin θ, cos θ).
   12 mul, 6 add.
   Error <= u |result| + 1 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_product_drdryinvf(const ksl_mat3x3f_t *R, const float dc[2],
    ksl_mat3x3f_t *Ro) {
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
}

/* Do = D [R_y(-θ) | 0], dc = (sin θ, cos θ).
   D, Do: displacement [R | t], R rotation, t in m; dc: (sin θ, cos θ).
   12 mul, 6 add.
   Error <= u |result| + (R: 1, t: 0) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_ddryinvf(const ksl_SE3f_t *D, const float dc[2], ksl_SE3f_t *Do) {
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
}

/* Do = D [I | -k e_y].
   D, Do: displacement [R | t], R rotation, t in m; k: number.
   3 mul, 3 add.
   Error <= u |result| + (R: 0, t: 1) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_ddtyinvf(const ksl_SE3f_t *D, const float k, ksl_SE3f_t *Do) {
  const float Do_03a = KSL_MULF(D->m01, k), Do_03 = D->m03 - Do_03a;
  const float Do_13a = KSL_MULF(D->m11, k), Do_13 = D->m13 - Do_13a;
  const float Do_23a = KSL_MULF(D->m21, k), Do_23 = D->m23 - Do_23a;
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
}

/* vo = R (k e_z).
   R: rotation or other 3×3 matrix; k: number; vo: vector.
   3 mul.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_product_drvtzf(const ksl_mat3x3f_t *R, const float k, ksl_vec3f_t *vo) {
  const float vo_0 = KSL_MULF(R->m02, k);
  const float vo_1 = KSL_MULF(R->m12, k);
  const float vo_2 = KSL_MULF(R->m22, k);
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
}

/* Ro = R R_z(θ), dc = (sin θ, cos θ).
   R, Ro: rotation or other 3×3 matrix; dc: (sin θ, cos θ).
   12 mul, 6 add.
   Error <= u |result| + 1 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_product_drdrzf(const ksl_mat3x3f_t *R, const float dc[2],
    ksl_mat3x3f_t *Ro) {
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
}

/* Do = D [R_z(θ) | 0], dc = (sin θ, cos θ).
   D, Do: displacement [R | t], R rotation, t in m; dc: (sin θ, cos θ).
   12 mul, 6 add.
   Error <= u |result| + (R: 1, t: 0) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_ddrzf(const ksl_SE3f_t *D, const float dc[2], ksl_SE3f_t *Do) {
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
}

/* Do = D [I | k e_z].
   D, Do: displacement [R | t], R rotation, t in m; k: number.
   3 mul, 3 add.
   Error <= u |result| + (R: 0, t: 1) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_ddtzf(const ksl_SE3f_t *D, const float k, ksl_SE3f_t *Do) {
  const float Do_03a = KSL_MULF(D->m02, k), Do_03 = Do_03a + D->m03;
  const float Do_13a = KSL_MULF(D->m12, k), Do_13 = Do_13a + D->m13;
  const float Do_23a = KSL_MULF(D->m22, k), Do_23 = Do_23a + D->m23;
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
}

/* vo = R (-k e_z).
   R: rotation or other 3×3 matrix; k: number; vo: vector.
   3 mul, 3 neg.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_product_drvtzinvf(const ksl_mat3x3f_t *R, const float k, ksl_vec3f_t *vo) {
  const float vo_0a = KSL_MULF(R->m02, k), vo_0 = -vo_0a;
  const float vo_1a = KSL_MULF(R->m12, k), vo_1 = -vo_1a;
  const float vo_2a = KSL_MULF(R->m22, k), vo_2 = -vo_2a;
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
}

/* Ro = R R_z(-θ), dc = (sin θ, cos θ).
   R, Ro: rotation or other 3×3 matrix; dc: (sin θ, cos θ).
   12 mul, 6 add.
   Error <= u |result| + 1 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_product_drdrzinvf(const ksl_mat3x3f_t *R, const float dc[2],
    ksl_mat3x3f_t *Ro) {
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
}

/* Do = D [R_z(-θ) | 0], dc = (sin θ, cos θ).
   D, Do: displacement [R | t], R rotation, t in m; dc: (sin θ, cos θ).
   12 mul, 6 add.
   Error <= u |result| + (R: 1, t: 0) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_ddrzinvf(const ksl_SE3f_t *D, const float dc[2], ksl_SE3f_t *Do) {
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
}

/* Do = D [I | -k e_z].
   D, Do: displacement [R | t], R rotation, t in m; k: number.
   3 mul, 3 add.
   Error <= u |result| + (R: 0, t: 1) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_ddtzinvf(const ksl_SE3f_t *D, const float k, ksl_SE3f_t *Do) {
  const float Do_03a = KSL_MULF(D->m02, k), Do_03 = D->m03 - Do_03a;
  const float Do_13a = KSL_MULF(D->m12, k), Do_13 = D->m13 - Do_13a;
  const float Do_23a = KSL_MULF(D->m22, k), Do_23 = D->m23 - Do_23a;
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
}

#endif
