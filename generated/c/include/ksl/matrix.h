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
  const double vo_0 = KSL_MUL(R->m00, v->x) + KSL_MUL(R->m01, v->y) + KSL_MUL(R->m02, v->z),
      vo_1 = KSL_MUL(R->m10, v->x) + KSL_MUL(R->m11, v->y) + KSL_MUL(R->m12, v->z),
      vo_2 = KSL_MUL(R->m20, v->x) + KSL_MUL(R->m21, v->y) + KSL_MUL(R->m22, v->z);
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
  const double vo_0 = -(KSL_MUL(R->m00, v->x) + KSL_MUL(R->m01, v->y) + KSL_MUL(R->m02, v->z)),
      vo_1 = -(KSL_MUL(R->m10, v->x) + KSL_MUL(R->m11, v->y) + KSL_MUL(R->m12, v->z)),
      vo_2 = -(KSL_MUL(R->m20, v->x) + KSL_MUL(R->m21, v->y) + KSL_MUL(R->m22, v->z));
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
  const double vo_0 = KSL_MUL(R->m00, v->x) + KSL_MUL(R->m10, v->y) + KSL_MUL(R->m20, v->z),
      vo_1 = KSL_MUL(R->m01, v->x) + KSL_MUL(R->m11, v->y) + KSL_MUL(R->m21, v->z),
      vo_2 = KSL_MUL(R->m02, v->x) + KSL_MUL(R->m12, v->y) + KSL_MUL(R->m22, v->z);
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
  const double vo_0 = -(KSL_MUL(R->m00, v->x) + KSL_MUL(R->m10, v->y) + KSL_MUL(R->m20, v->z)),
      vo_1 = -(KSL_MUL(R->m01, v->x) + KSL_MUL(R->m11, v->y) + KSL_MUL(R->m21, v->z)),
      vo_2 = -(KSL_MUL(R->m02, v->x) + KSL_MUL(R->m12, v->y) + KSL_MUL(R->m22, v->z));
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
  const double vo_0 = KSL_MUL(D->m00, v->x) + KSL_MUL(D->m01, v->y) + KSL_MUL(D->m02, v->z)
          + D->m03,
      vo_1 = KSL_MUL(D->m10, v->x) + KSL_MUL(D->m11, v->y) + KSL_MUL(D->m12, v->z) + D->m13,
      vo_2 = KSL_MUL(D->m20, v->x) + KSL_MUL(D->m21, v->y) + KSL_MUL(D->m22, v->z) + D->m23;
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
  const double p_0 = v->x - D->m03, p_1 = v->y - D->m13, p_2 = v->z - D->m23;
  const double vo_0 = KSL_MUL(D->m00, p_0) + KSL_MUL(D->m10, p_1) + KSL_MUL(D->m20, p_2),
      vo_1 = KSL_MUL(D->m01, p_0) + KSL_MUL(D->m11, p_1) + KSL_MUL(D->m21, p_2),
      vo_2 = KSL_MUL(D->m02, p_0) + KSL_MUL(D->m12, p_1) + KSL_MUL(D->m22, p_2);
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
  const double Ro_00 = KSL_MUL(R1->m00, R2->m00) + KSL_MUL(R1->m01, R2->m10)
          + KSL_MUL(R1->m02, R2->m20),
      Ro_01 = KSL_MUL(R1->m00, R2->m01) + KSL_MUL(R1->m01, R2->m11) + KSL_MUL(R1->m02, R2->m21),
      Ro_02 = KSL_MUL(R1->m00, R2->m02) + KSL_MUL(R1->m01, R2->m12) + KSL_MUL(R1->m02, R2->m22),
      Ro_10 = KSL_MUL(R1->m10, R2->m00) + KSL_MUL(R1->m11, R2->m10) + KSL_MUL(R1->m12, R2->m20),
      Ro_11 = KSL_MUL(R1->m10, R2->m01) + KSL_MUL(R1->m11, R2->m11) + KSL_MUL(R1->m12, R2->m21),
      Ro_12 = KSL_MUL(R1->m10, R2->m02) + KSL_MUL(R1->m11, R2->m12) + KSL_MUL(R1->m12, R2->m22),
      Ro_20 = KSL_MUL(R1->m20, R2->m00) + KSL_MUL(R1->m21, R2->m10) + KSL_MUL(R1->m22, R2->m20),
      Ro_21 = KSL_MUL(R1->m20, R2->m01) + KSL_MUL(R1->m21, R2->m11) + KSL_MUL(R1->m22, R2->m21),
      Ro_22 = KSL_MUL(R1->m20, R2->m02) + KSL_MUL(R1->m21, R2->m12) + KSL_MUL(R1->m22, R2->m22);
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
  const double Ro_00 = KSL_MUL(R1->m00, R2->m00) + KSL_MUL(R1->m01, R2->m01)
          + KSL_MUL(R1->m02, R2->m02),
      Ro_01 = KSL_MUL(R1->m00, R2->m10) + KSL_MUL(R1->m01, R2->m11) + KSL_MUL(R1->m02, R2->m12),
      Ro_02 = KSL_MUL(R1->m00, R2->m20) + KSL_MUL(R1->m01, R2->m21) + KSL_MUL(R1->m02, R2->m22),
      Ro_10 = KSL_MUL(R1->m10, R2->m00) + KSL_MUL(R1->m11, R2->m01) + KSL_MUL(R1->m12, R2->m02),
      Ro_11 = KSL_MUL(R1->m10, R2->m10) + KSL_MUL(R1->m11, R2->m11) + KSL_MUL(R1->m12, R2->m12),
      Ro_12 = KSL_MUL(R1->m10, R2->m20) + KSL_MUL(R1->m11, R2->m21) + KSL_MUL(R1->m12, R2->m22),
      Ro_20 = KSL_MUL(R1->m20, R2->m00) + KSL_MUL(R1->m21, R2->m01) + KSL_MUL(R1->m22, R2->m02),
      Ro_21 = KSL_MUL(R1->m20, R2->m10) + KSL_MUL(R1->m21, R2->m11) + KSL_MUL(R1->m22, R2->m12),
      Ro_22 = KSL_MUL(R1->m20, R2->m20) + KSL_MUL(R1->m21, R2->m21) + KSL_MUL(R1->m22, R2->m22);
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
  const double Ro_00 = KSL_MUL(R1->m00, R2->m00) + KSL_MUL(R1->m10, R2->m10)
          + KSL_MUL(R1->m20, R2->m20),
      Ro_01 = KSL_MUL(R1->m00, R2->m01) + KSL_MUL(R1->m10, R2->m11) + KSL_MUL(R1->m20, R2->m21),
      Ro_02 = KSL_MUL(R1->m00, R2->m02) + KSL_MUL(R1->m10, R2->m12) + KSL_MUL(R1->m20, R2->m22),
      Ro_10 = KSL_MUL(R1->m01, R2->m00) + KSL_MUL(R1->m11, R2->m10) + KSL_MUL(R1->m21, R2->m20),
      Ro_11 = KSL_MUL(R1->m01, R2->m01) + KSL_MUL(R1->m11, R2->m11) + KSL_MUL(R1->m21, R2->m21),
      Ro_12 = KSL_MUL(R1->m01, R2->m02) + KSL_MUL(R1->m11, R2->m12) + KSL_MUL(R1->m21, R2->m22),
      Ro_20 = KSL_MUL(R1->m02, R2->m00) + KSL_MUL(R1->m12, R2->m10) + KSL_MUL(R1->m22, R2->m20),
      Ro_21 = KSL_MUL(R1->m02, R2->m01) + KSL_MUL(R1->m12, R2->m11) + KSL_MUL(R1->m22, R2->m21),
      Ro_22 = KSL_MUL(R1->m02, R2->m02) + KSL_MUL(R1->m12, R2->m12) + KSL_MUL(R1->m22, R2->m22);
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
  const double Do_00 = KSL_MUL(D1->m00, D2->m00) + KSL_MUL(D1->m01, D2->m10)
          + KSL_MUL(D1->m02, D2->m20),
      Do_01 = KSL_MUL(D1->m00, D2->m01) + KSL_MUL(D1->m01, D2->m11) + KSL_MUL(D1->m02, D2->m21),
      Do_02 = KSL_MUL(D1->m00, D2->m02) + KSL_MUL(D1->m01, D2->m12) + KSL_MUL(D1->m02, D2->m22),
      Do_03 = KSL_MUL(D1->m00, D2->m03) + KSL_MUL(D1->m01, D2->m13) + KSL_MUL(D1->m02, D2->m23)
          + D1->m03,
      Do_10 = KSL_MUL(D1->m10, D2->m00) + KSL_MUL(D1->m11, D2->m10) + KSL_MUL(D1->m12, D2->m20),
      Do_11 = KSL_MUL(D1->m10, D2->m01) + KSL_MUL(D1->m11, D2->m11) + KSL_MUL(D1->m12, D2->m21),
      Do_12 = KSL_MUL(D1->m10, D2->m02) + KSL_MUL(D1->m11, D2->m12) + KSL_MUL(D1->m12, D2->m22),
      Do_13 = KSL_MUL(D1->m10, D2->m03) + KSL_MUL(D1->m11, D2->m13) + KSL_MUL(D1->m12, D2->m23)
          + D1->m13,
      Do_20 = KSL_MUL(D1->m20, D2->m00) + KSL_MUL(D1->m21, D2->m10) + KSL_MUL(D1->m22, D2->m20),
      Do_21 = KSL_MUL(D1->m20, D2->m01) + KSL_MUL(D1->m21, D2->m11) + KSL_MUL(D1->m22, D2->m21),
      Do_22 = KSL_MUL(D1->m20, D2->m02) + KSL_MUL(D1->m21, D2->m12) + KSL_MUL(D1->m22, D2->m22),
      Do_23 = KSL_MUL(D1->m20, D2->m03) + KSL_MUL(D1->m21, D2->m13) + KSL_MUL(D1->m22, D2->m23)
          + D1->m23;
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
  const double R_0 = KSL_MUL(D1->m00, D2->m00) + KSL_MUL(D1->m01, D2->m01)
          + KSL_MUL(D1->m02, D2->m02),
      R_1 = KSL_MUL(D1->m00, D2->m10) + KSL_MUL(D1->m01, D2->m11) + KSL_MUL(D1->m02, D2->m12),
      R_2 = KSL_MUL(D1->m00, D2->m20) + KSL_MUL(D1->m01, D2->m21) + KSL_MUL(D1->m02, D2->m22),
      R_3 = KSL_MUL(D1->m10, D2->m00) + KSL_MUL(D1->m11, D2->m01) + KSL_MUL(D1->m12, D2->m02),
      R_4 = KSL_MUL(D1->m10, D2->m10) + KSL_MUL(D1->m11, D2->m11) + KSL_MUL(D1->m12, D2->m12),
      R_5 = KSL_MUL(D1->m10, D2->m20) + KSL_MUL(D1->m11, D2->m21) + KSL_MUL(D1->m12, D2->m22),
      R_6 = KSL_MUL(D1->m20, D2->m00) + KSL_MUL(D1->m21, D2->m01) + KSL_MUL(D1->m22, D2->m02),
      R_7 = KSL_MUL(D1->m20, D2->m10) + KSL_MUL(D1->m21, D2->m11) + KSL_MUL(D1->m22, D2->m12),
      R_8 = KSL_MUL(D1->m20, D2->m20) + KSL_MUL(D1->m21, D2->m21) + KSL_MUL(D1->m22, D2->m22);
  const double Do_03 = D1->m03
          - (KSL_MUL(D2->m03, R_0) + KSL_MUL(D2->m13, R_1) + KSL_MUL(D2->m23, R_2)),
      Do_13 = D1->m13 - (KSL_MUL(D2->m03, R_3) + KSL_MUL(D2->m13, R_4) + KSL_MUL(D2->m23, R_5)),
      Do_23 = D1->m23 - (KSL_MUL(D2->m03, R_6) + KSL_MUL(D2->m13, R_7) + KSL_MUL(D2->m23, R_8));
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
  const double p_0 = D2->m03 - D1->m03, p_1 = D2->m13 - D1->m13, p_2 = D2->m23 - D1->m23;
  const double Do_00 = KSL_MUL(D1->m00, D2->m00) + KSL_MUL(D1->m10, D2->m10)
          + KSL_MUL(D1->m20, D2->m20),
      Do_01 = KSL_MUL(D1->m00, D2->m01) + KSL_MUL(D1->m10, D2->m11) + KSL_MUL(D1->m20, D2->m21),
      Do_02 = KSL_MUL(D1->m00, D2->m02) + KSL_MUL(D1->m10, D2->m12) + KSL_MUL(D1->m20, D2->m22),
      Do_03 = KSL_MUL(D1->m00, p_0) + KSL_MUL(D1->m10, p_1) + KSL_MUL(D1->m20, p_2),
      Do_10 = KSL_MUL(D1->m01, D2->m00) + KSL_MUL(D1->m11, D2->m10) + KSL_MUL(D1->m21, D2->m20),
      Do_11 = KSL_MUL(D1->m01, D2->m01) + KSL_MUL(D1->m11, D2->m11) + KSL_MUL(D1->m21, D2->m21),
      Do_12 = KSL_MUL(D1->m01, D2->m02) + KSL_MUL(D1->m11, D2->m12) + KSL_MUL(D1->m21, D2->m22),
      Do_13 = KSL_MUL(D1->m01, p_0) + KSL_MUL(D1->m11, p_1) + KSL_MUL(D1->m21, p_2),
      Do_20 = KSL_MUL(D1->m02, D2->m00) + KSL_MUL(D1->m12, D2->m10) + KSL_MUL(D1->m22, D2->m20),
      Do_21 = KSL_MUL(D1->m02, D2->m01) + KSL_MUL(D1->m12, D2->m11) + KSL_MUL(D1->m22, D2->m21),
      Do_22 = KSL_MUL(D1->m02, D2->m02) + KSL_MUL(D1->m12, D2->m12) + KSL_MUL(D1->m22, D2->m22),
      Do_23 = KSL_MUL(D1->m02, p_0) + KSL_MUL(D1->m12, p_1) + KSL_MUL(D1->m22, p_2);
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
  const double Do_00 = KSL_MUL(D->m00, R->m00) + KSL_MUL(D->m01, R->m10) + KSL_MUL(D->m02, R->m20),
      Do_01 = KSL_MUL(D->m00, R->m01) + KSL_MUL(D->m01, R->m11) + KSL_MUL(D->m02, R->m21),
      Do_02 = KSL_MUL(D->m00, R->m02) + KSL_MUL(D->m01, R->m12) + KSL_MUL(D->m02, R->m22),
      Do_10 = KSL_MUL(D->m10, R->m00) + KSL_MUL(D->m11, R->m10) + KSL_MUL(D->m12, R->m20),
      Do_11 = KSL_MUL(D->m10, R->m01) + KSL_MUL(D->m11, R->m11) + KSL_MUL(D->m12, R->m21),
      Do_12 = KSL_MUL(D->m10, R->m02) + KSL_MUL(D->m11, R->m12) + KSL_MUL(D->m12, R->m22),
      Do_20 = KSL_MUL(D->m20, R->m00) + KSL_MUL(D->m21, R->m10) + KSL_MUL(D->m22, R->m20),
      Do_21 = KSL_MUL(D->m20, R->m01) + KSL_MUL(D->m21, R->m11) + KSL_MUL(D->m22, R->m21),
      Do_22 = KSL_MUL(D->m20, R->m02) + KSL_MUL(D->m21, R->m12) + KSL_MUL(D->m22, R->m22);
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
  const double Do_00 = KSL_MUL(D->m00, R->m00) + KSL_MUL(D->m01, R->m01) + KSL_MUL(D->m02, R->m02),
      Do_01 = KSL_MUL(D->m00, R->m10) + KSL_MUL(D->m01, R->m11) + KSL_MUL(D->m02, R->m12),
      Do_02 = KSL_MUL(D->m00, R->m20) + KSL_MUL(D->m01, R->m21) + KSL_MUL(D->m02, R->m22),
      Do_10 = KSL_MUL(D->m10, R->m00) + KSL_MUL(D->m11, R->m01) + KSL_MUL(D->m12, R->m02),
      Do_11 = KSL_MUL(D->m10, R->m10) + KSL_MUL(D->m11, R->m11) + KSL_MUL(D->m12, R->m12),
      Do_12 = KSL_MUL(D->m10, R->m20) + KSL_MUL(D->m11, R->m21) + KSL_MUL(D->m12, R->m22),
      Do_20 = KSL_MUL(D->m20, R->m00) + KSL_MUL(D->m21, R->m01) + KSL_MUL(D->m22, R->m02),
      Do_21 = KSL_MUL(D->m20, R->m10) + KSL_MUL(D->m21, R->m11) + KSL_MUL(D->m22, R->m12),
      Do_22 = KSL_MUL(D->m20, R->m20) + KSL_MUL(D->m21, R->m21) + KSL_MUL(D->m22, R->m22);
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
  const double Do_03 = KSL_MUL(D->m00, t->x) + KSL_MUL(D->m01, t->y) + KSL_MUL(D->m02, t->z)
          + D->m03,
      Do_13 = KSL_MUL(D->m10, t->x) + KSL_MUL(D->m11, t->y) + KSL_MUL(D->m12, t->z) + D->m13,
      Do_23 = KSL_MUL(D->m20, t->x) + KSL_MUL(D->m21, t->y) + KSL_MUL(D->m22, t->z) + D->m23;
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
  const double Do_03 = D->m03
          - (KSL_MUL(D->m00, t->x) + KSL_MUL(D->m01, t->y) + KSL_MUL(D->m02, t->z)),
      Do_13 = D->m13 - (KSL_MUL(D->m10, t->x) + KSL_MUL(D->m11, t->y) + KSL_MUL(D->m12, t->z)),
      Do_23 = D->m23 - (KSL_MUL(D->m20, t->x) + KSL_MUL(D->m21, t->y) + KSL_MUL(D->m22, t->z));
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
  const double p_0 = t->x - D->m03, p_1 = t->y - D->m13, p_2 = t->z - D->m23;
  const double Do_03 = KSL_MUL(D->m00, p_0) + KSL_MUL(D->m10, p_1) + KSL_MUL(D->m20, p_2),
      Do_13 = KSL_MUL(D->m01, p_0) + KSL_MUL(D->m11, p_1) + KSL_MUL(D->m21, p_2),
      Do_23 = KSL_MUL(D->m02, p_0) + KSL_MUL(D->m12, p_1) + KSL_MUL(D->m22, p_2);
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
  const double vo_0 = KSL_MUL(R->m00, k), vo_1 = KSL_MUL(R->m10, k), vo_2 = KSL_MUL(R->m20, k);
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
  const double Ro_01 = KSL_MUL(R->m01, dc[1]) + KSL_MUL(R->m02, dc[0]),
      Ro_02 = KSL_MUL(R->m02, dc[1]) - KSL_MUL(R->m01, dc[0]),
      Ro_11 = KSL_MUL(R->m11, dc[1]) + KSL_MUL(R->m12, dc[0]),
      Ro_12 = KSL_MUL(R->m12, dc[1]) - KSL_MUL(R->m11, dc[0]),
      Ro_21 = KSL_MUL(R->m21, dc[1]) + KSL_MUL(R->m22, dc[0]),
      Ro_22 = KSL_MUL(R->m22, dc[1]) - KSL_MUL(R->m21, dc[0]);
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
  const double Do_01 = KSL_MUL(D->m01, dc[1]) + KSL_MUL(D->m02, dc[0]),
      Do_02 = KSL_MUL(D->m02, dc[1]) - KSL_MUL(D->m01, dc[0]),
      Do_11 = KSL_MUL(D->m11, dc[1]) + KSL_MUL(D->m12, dc[0]),
      Do_12 = KSL_MUL(D->m12, dc[1]) - KSL_MUL(D->m11, dc[0]),
      Do_21 = KSL_MUL(D->m21, dc[1]) + KSL_MUL(D->m22, dc[0]),
      Do_22 = KSL_MUL(D->m22, dc[1]) - KSL_MUL(D->m21, dc[0]);
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
  const double Do_03 = KSL_MUL(D->m00, k) + D->m03, Do_13 = KSL_MUL(D->m10, k) + D->m13,
      Do_23 = KSL_MUL(D->m20, k) + D->m23;
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
  const double vo_0 = -KSL_MUL(R->m00, k), vo_1 = -KSL_MUL(R->m10, k), vo_2 = -KSL_MUL(R->m20, k);
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
  const double Ro_01 = KSL_MUL(R->m01, dc[1]) - KSL_MUL(R->m02, dc[0]),
      Ro_02 = KSL_MUL(R->m01, dc[0]) + KSL_MUL(R->m02, dc[1]),
      Ro_11 = KSL_MUL(R->m11, dc[1]) - KSL_MUL(R->m12, dc[0]),
      Ro_12 = KSL_MUL(R->m11, dc[0]) + KSL_MUL(R->m12, dc[1]),
      Ro_21 = KSL_MUL(R->m21, dc[1]) - KSL_MUL(R->m22, dc[0]),
      Ro_22 = KSL_MUL(R->m21, dc[0]) + KSL_MUL(R->m22, dc[1]);
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
  const double Do_01 = KSL_MUL(D->m01, dc[1]) - KSL_MUL(D->m02, dc[0]),
      Do_02 = KSL_MUL(D->m01, dc[0]) + KSL_MUL(D->m02, dc[1]),
      Do_11 = KSL_MUL(D->m11, dc[1]) - KSL_MUL(D->m12, dc[0]),
      Do_12 = KSL_MUL(D->m11, dc[0]) + KSL_MUL(D->m12, dc[1]),
      Do_21 = KSL_MUL(D->m21, dc[1]) - KSL_MUL(D->m22, dc[0]),
      Do_22 = KSL_MUL(D->m21, dc[0]) + KSL_MUL(D->m22, dc[1]);
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
  const double Do_03 = D->m03 - KSL_MUL(D->m00, k), Do_13 = D->m13 - KSL_MUL(D->m10, k),
      Do_23 = D->m23 - KSL_MUL(D->m20, k);
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
  const double vo_0 = KSL_MUL(R->m01, k), vo_1 = KSL_MUL(R->m11, k), vo_2 = KSL_MUL(R->m21, k);
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
  const double Ro_00 = KSL_MUL(R->m00, dc[1]) - KSL_MUL(R->m02, dc[0]),
      Ro_02 = KSL_MUL(R->m00, dc[0]) + KSL_MUL(R->m02, dc[1]),
      Ro_10 = KSL_MUL(R->m10, dc[1]) - KSL_MUL(R->m12, dc[0]),
      Ro_12 = KSL_MUL(R->m10, dc[0]) + KSL_MUL(R->m12, dc[1]),
      Ro_20 = KSL_MUL(R->m20, dc[1]) - KSL_MUL(R->m22, dc[0]),
      Ro_22 = KSL_MUL(R->m20, dc[0]) + KSL_MUL(R->m22, dc[1]);
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
  const double Do_00 = KSL_MUL(D->m00, dc[1]) - KSL_MUL(D->m02, dc[0]),
      Do_02 = KSL_MUL(D->m00, dc[0]) + KSL_MUL(D->m02, dc[1]),
      Do_10 = KSL_MUL(D->m10, dc[1]) - KSL_MUL(D->m12, dc[0]),
      Do_12 = KSL_MUL(D->m10, dc[0]) + KSL_MUL(D->m12, dc[1]),
      Do_20 = KSL_MUL(D->m20, dc[1]) - KSL_MUL(D->m22, dc[0]),
      Do_22 = KSL_MUL(D->m20, dc[0]) + KSL_MUL(D->m22, dc[1]);
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
  const double Do_03 = KSL_MUL(D->m01, k) + D->m03, Do_13 = KSL_MUL(D->m11, k) + D->m13,
      Do_23 = KSL_MUL(D->m21, k) + D->m23;
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
  const double vo_0 = -KSL_MUL(R->m01, k), vo_1 = -KSL_MUL(R->m11, k), vo_2 = -KSL_MUL(R->m21, k);
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
  const double Ro_00 = KSL_MUL(R->m00, dc[1]) + KSL_MUL(R->m02, dc[0]),
      Ro_02 = KSL_MUL(R->m02, dc[1]) - KSL_MUL(R->m00, dc[0]),
      Ro_10 = KSL_MUL(R->m10, dc[1]) + KSL_MUL(R->m12, dc[0]),
      Ro_12 = KSL_MUL(R->m12, dc[1]) - KSL_MUL(R->m10, dc[0]),
      Ro_20 = KSL_MUL(R->m20, dc[1]) + KSL_MUL(R->m22, dc[0]),
      Ro_22 = KSL_MUL(R->m22, dc[1]) - KSL_MUL(R->m20, dc[0]);
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
  const double Do_00 = KSL_MUL(D->m00, dc[1]) + KSL_MUL(D->m02, dc[0]),
      Do_02 = KSL_MUL(D->m02, dc[1]) - KSL_MUL(D->m00, dc[0]),
      Do_10 = KSL_MUL(D->m10, dc[1]) + KSL_MUL(D->m12, dc[0]),
      Do_12 = KSL_MUL(D->m12, dc[1]) - KSL_MUL(D->m10, dc[0]),
      Do_20 = KSL_MUL(D->m20, dc[1]) + KSL_MUL(D->m22, dc[0]),
      Do_22 = KSL_MUL(D->m22, dc[1]) - KSL_MUL(D->m20, dc[0]);
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
  const double Do_03 = D->m03 - KSL_MUL(D->m01, k), Do_13 = D->m13 - KSL_MUL(D->m11, k),
      Do_23 = D->m23 - KSL_MUL(D->m21, k);
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
  const double vo_0 = KSL_MUL(R->m02, k), vo_1 = KSL_MUL(R->m12, k), vo_2 = KSL_MUL(R->m22, k);
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
  const double Ro_00 = KSL_MUL(R->m00, dc[1]) + KSL_MUL(R->m01, dc[0]),
      Ro_01 = KSL_MUL(R->m01, dc[1]) - KSL_MUL(R->m00, dc[0]),
      Ro_10 = KSL_MUL(R->m10, dc[1]) + KSL_MUL(R->m11, dc[0]),
      Ro_11 = KSL_MUL(R->m11, dc[1]) - KSL_MUL(R->m10, dc[0]),
      Ro_20 = KSL_MUL(R->m20, dc[1]) + KSL_MUL(R->m21, dc[0]),
      Ro_21 = KSL_MUL(R->m21, dc[1]) - KSL_MUL(R->m20, dc[0]);
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
  const double Do_00 = KSL_MUL(D->m00, dc[1]) + KSL_MUL(D->m01, dc[0]),
      Do_01 = KSL_MUL(D->m01, dc[1]) - KSL_MUL(D->m00, dc[0]),
      Do_10 = KSL_MUL(D->m10, dc[1]) + KSL_MUL(D->m11, dc[0]),
      Do_11 = KSL_MUL(D->m11, dc[1]) - KSL_MUL(D->m10, dc[0]),
      Do_20 = KSL_MUL(D->m20, dc[1]) + KSL_MUL(D->m21, dc[0]),
      Do_21 = KSL_MUL(D->m21, dc[1]) - KSL_MUL(D->m20, dc[0]);
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
  const double Do_03 = KSL_MUL(D->m02, k) + D->m03, Do_13 = KSL_MUL(D->m12, k) + D->m13,
      Do_23 = KSL_MUL(D->m22, k) + D->m23;
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
  const double vo_0 = -KSL_MUL(R->m02, k), vo_1 = -KSL_MUL(R->m12, k), vo_2 = -KSL_MUL(R->m22, k);
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
  const double Ro_00 = KSL_MUL(R->m00, dc[1]) - KSL_MUL(R->m01, dc[0]),
      Ro_01 = KSL_MUL(R->m00, dc[0]) + KSL_MUL(R->m01, dc[1]),
      Ro_10 = KSL_MUL(R->m10, dc[1]) - KSL_MUL(R->m11, dc[0]),
      Ro_11 = KSL_MUL(R->m10, dc[0]) + KSL_MUL(R->m11, dc[1]),
      Ro_20 = KSL_MUL(R->m20, dc[1]) - KSL_MUL(R->m21, dc[0]),
      Ro_21 = KSL_MUL(R->m20, dc[0]) + KSL_MUL(R->m21, dc[1]);
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
  const double Do_00 = KSL_MUL(D->m00, dc[1]) - KSL_MUL(D->m01, dc[0]),
      Do_01 = KSL_MUL(D->m00, dc[0]) + KSL_MUL(D->m01, dc[1]),
      Do_10 = KSL_MUL(D->m10, dc[1]) - KSL_MUL(D->m11, dc[0]),
      Do_11 = KSL_MUL(D->m10, dc[0]) + KSL_MUL(D->m11, dc[1]),
      Do_20 = KSL_MUL(D->m20, dc[1]) - KSL_MUL(D->m21, dc[0]),
      Do_21 = KSL_MUL(D->m20, dc[0]) + KSL_MUL(D->m21, dc[1]);
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
  const double Do_03 = D->m03 - KSL_MUL(D->m02, k), Do_13 = D->m13 - KSL_MUL(D->m12, k),
      Do_23 = D->m23 - KSL_MUL(D->m22, k);
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
  const float vo_0 = KSL_MULF(R->m00, v->x) + KSL_MULF(R->m01, v->y) + KSL_MULF(R->m02, v->z),
      vo_1 = KSL_MULF(R->m10, v->x) + KSL_MULF(R->m11, v->y) + KSL_MULF(R->m12, v->z),
      vo_2 = KSL_MULF(R->m20, v->x) + KSL_MULF(R->m21, v->y) + KSL_MULF(R->m22, v->z);
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
  const float vo_0 = -(KSL_MULF(R->m00, v->x) + KSL_MULF(R->m01, v->y) + KSL_MULF(R->m02, v->z)),
      vo_1 = -(KSL_MULF(R->m10, v->x) + KSL_MULF(R->m11, v->y) + KSL_MULF(R->m12, v->z)),
      vo_2 = -(KSL_MULF(R->m20, v->x) + KSL_MULF(R->m21, v->y) + KSL_MULF(R->m22, v->z));
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
  const float vo_0 = KSL_MULF(R->m00, v->x) + KSL_MULF(R->m10, v->y) + KSL_MULF(R->m20, v->z),
      vo_1 = KSL_MULF(R->m01, v->x) + KSL_MULF(R->m11, v->y) + KSL_MULF(R->m21, v->z),
      vo_2 = KSL_MULF(R->m02, v->x) + KSL_MULF(R->m12, v->y) + KSL_MULF(R->m22, v->z);
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
  const float vo_0 = -(KSL_MULF(R->m00, v->x) + KSL_MULF(R->m10, v->y) + KSL_MULF(R->m20, v->z)),
      vo_1 = -(KSL_MULF(R->m01, v->x) + KSL_MULF(R->m11, v->y) + KSL_MULF(R->m21, v->z)),
      vo_2 = -(KSL_MULF(R->m02, v->x) + KSL_MULF(R->m12, v->y) + KSL_MULF(R->m22, v->z));
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
  const float vo_0 = KSL_MULF(D->m00, v->x) + KSL_MULF(D->m01, v->y) + KSL_MULF(D->m02, v->z)
          + D->m03,
      vo_1 = KSL_MULF(D->m10, v->x) + KSL_MULF(D->m11, v->y) + KSL_MULF(D->m12, v->z) + D->m13,
      vo_2 = KSL_MULF(D->m20, v->x) + KSL_MULF(D->m21, v->y) + KSL_MULF(D->m22, v->z) + D->m23;
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
  const float p_0 = v->x - D->m03, p_1 = v->y - D->m13, p_2 = v->z - D->m23;
  const float vo_0 = KSL_MULF(D->m00, p_0) + KSL_MULF(D->m10, p_1) + KSL_MULF(D->m20, p_2),
      vo_1 = KSL_MULF(D->m01, p_0) + KSL_MULF(D->m11, p_1) + KSL_MULF(D->m21, p_2),
      vo_2 = KSL_MULF(D->m02, p_0) + KSL_MULF(D->m12, p_1) + KSL_MULF(D->m22, p_2);
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
  const float Ro_00 = KSL_MULF(R1->m00, R2->m00) + KSL_MULF(R1->m01, R2->m10)
          + KSL_MULF(R1->m02, R2->m20),
      Ro_01 = KSL_MULF(R1->m00, R2->m01) + KSL_MULF(R1->m01, R2->m11) + KSL_MULF(R1->m02, R2->m21),
      Ro_02 = KSL_MULF(R1->m00, R2->m02) + KSL_MULF(R1->m01, R2->m12) + KSL_MULF(R1->m02, R2->m22),
      Ro_10 = KSL_MULF(R1->m10, R2->m00) + KSL_MULF(R1->m11, R2->m10) + KSL_MULF(R1->m12, R2->m20),
      Ro_11 = KSL_MULF(R1->m10, R2->m01) + KSL_MULF(R1->m11, R2->m11) + KSL_MULF(R1->m12, R2->m21),
      Ro_12 = KSL_MULF(R1->m10, R2->m02) + KSL_MULF(R1->m11, R2->m12) + KSL_MULF(R1->m12, R2->m22),
      Ro_20 = KSL_MULF(R1->m20, R2->m00) + KSL_MULF(R1->m21, R2->m10) + KSL_MULF(R1->m22, R2->m20),
      Ro_21 = KSL_MULF(R1->m20, R2->m01) + KSL_MULF(R1->m21, R2->m11) + KSL_MULF(R1->m22, R2->m21),
      Ro_22 = KSL_MULF(R1->m20, R2->m02) + KSL_MULF(R1->m21, R2->m12) + KSL_MULF(R1->m22, R2->m22);
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
  const float Ro_00 = KSL_MULF(R1->m00, R2->m00) + KSL_MULF(R1->m01, R2->m01)
          + KSL_MULF(R1->m02, R2->m02),
      Ro_01 = KSL_MULF(R1->m00, R2->m10) + KSL_MULF(R1->m01, R2->m11) + KSL_MULF(R1->m02, R2->m12),
      Ro_02 = KSL_MULF(R1->m00, R2->m20) + KSL_MULF(R1->m01, R2->m21) + KSL_MULF(R1->m02, R2->m22),
      Ro_10 = KSL_MULF(R1->m10, R2->m00) + KSL_MULF(R1->m11, R2->m01) + KSL_MULF(R1->m12, R2->m02),
      Ro_11 = KSL_MULF(R1->m10, R2->m10) + KSL_MULF(R1->m11, R2->m11) + KSL_MULF(R1->m12, R2->m12),
      Ro_12 = KSL_MULF(R1->m10, R2->m20) + KSL_MULF(R1->m11, R2->m21) + KSL_MULF(R1->m12, R2->m22),
      Ro_20 = KSL_MULF(R1->m20, R2->m00) + KSL_MULF(R1->m21, R2->m01) + KSL_MULF(R1->m22, R2->m02),
      Ro_21 = KSL_MULF(R1->m20, R2->m10) + KSL_MULF(R1->m21, R2->m11) + KSL_MULF(R1->m22, R2->m12),
      Ro_22 = KSL_MULF(R1->m20, R2->m20) + KSL_MULF(R1->m21, R2->m21) + KSL_MULF(R1->m22, R2->m22);
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
  const float Ro_00 = KSL_MULF(R1->m00, R2->m00) + KSL_MULF(R1->m10, R2->m10)
          + KSL_MULF(R1->m20, R2->m20),
      Ro_01 = KSL_MULF(R1->m00, R2->m01) + KSL_MULF(R1->m10, R2->m11) + KSL_MULF(R1->m20, R2->m21),
      Ro_02 = KSL_MULF(R1->m00, R2->m02) + KSL_MULF(R1->m10, R2->m12) + KSL_MULF(R1->m20, R2->m22),
      Ro_10 = KSL_MULF(R1->m01, R2->m00) + KSL_MULF(R1->m11, R2->m10) + KSL_MULF(R1->m21, R2->m20),
      Ro_11 = KSL_MULF(R1->m01, R2->m01) + KSL_MULF(R1->m11, R2->m11) + KSL_MULF(R1->m21, R2->m21),
      Ro_12 = KSL_MULF(R1->m01, R2->m02) + KSL_MULF(R1->m11, R2->m12) + KSL_MULF(R1->m21, R2->m22),
      Ro_20 = KSL_MULF(R1->m02, R2->m00) + KSL_MULF(R1->m12, R2->m10) + KSL_MULF(R1->m22, R2->m20),
      Ro_21 = KSL_MULF(R1->m02, R2->m01) + KSL_MULF(R1->m12, R2->m11) + KSL_MULF(R1->m22, R2->m21),
      Ro_22 = KSL_MULF(R1->m02, R2->m02) + KSL_MULF(R1->m12, R2->m12) + KSL_MULF(R1->m22, R2->m22);
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
  const float Do_00 = KSL_MULF(D1->m00, D2->m00) + KSL_MULF(D1->m01, D2->m10)
          + KSL_MULF(D1->m02, D2->m20),
      Do_01 = KSL_MULF(D1->m00, D2->m01) + KSL_MULF(D1->m01, D2->m11) + KSL_MULF(D1->m02, D2->m21),
      Do_02 = KSL_MULF(D1->m00, D2->m02) + KSL_MULF(D1->m01, D2->m12) + KSL_MULF(D1->m02, D2->m22),
      Do_03 = KSL_MULF(D1->m00, D2->m03) + KSL_MULF(D1->m01, D2->m13) + KSL_MULF(D1->m02, D2->m23)
          + D1->m03,
      Do_10 = KSL_MULF(D1->m10, D2->m00) + KSL_MULF(D1->m11, D2->m10) + KSL_MULF(D1->m12, D2->m20),
      Do_11 = KSL_MULF(D1->m10, D2->m01) + KSL_MULF(D1->m11, D2->m11) + KSL_MULF(D1->m12, D2->m21),
      Do_12 = KSL_MULF(D1->m10, D2->m02) + KSL_MULF(D1->m11, D2->m12) + KSL_MULF(D1->m12, D2->m22),
      Do_13 = KSL_MULF(D1->m10, D2->m03) + KSL_MULF(D1->m11, D2->m13) + KSL_MULF(D1->m12, D2->m23)
          + D1->m13,
      Do_20 = KSL_MULF(D1->m20, D2->m00) + KSL_MULF(D1->m21, D2->m10) + KSL_MULF(D1->m22, D2->m20),
      Do_21 = KSL_MULF(D1->m20, D2->m01) + KSL_MULF(D1->m21, D2->m11) + KSL_MULF(D1->m22, D2->m21),
      Do_22 = KSL_MULF(D1->m20, D2->m02) + KSL_MULF(D1->m21, D2->m12) + KSL_MULF(D1->m22, D2->m22),
      Do_23 = KSL_MULF(D1->m20, D2->m03) + KSL_MULF(D1->m21, D2->m13) + KSL_MULF(D1->m22, D2->m23)
          + D1->m23;
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
  const float R_0 = KSL_MULF(D1->m00, D2->m00) + KSL_MULF(D1->m01, D2->m01)
          + KSL_MULF(D1->m02, D2->m02),
      R_1 = KSL_MULF(D1->m00, D2->m10) + KSL_MULF(D1->m01, D2->m11) + KSL_MULF(D1->m02, D2->m12),
      R_2 = KSL_MULF(D1->m00, D2->m20) + KSL_MULF(D1->m01, D2->m21) + KSL_MULF(D1->m02, D2->m22),
      R_3 = KSL_MULF(D1->m10, D2->m00) + KSL_MULF(D1->m11, D2->m01) + KSL_MULF(D1->m12, D2->m02),
      R_4 = KSL_MULF(D1->m10, D2->m10) + KSL_MULF(D1->m11, D2->m11) + KSL_MULF(D1->m12, D2->m12),
      R_5 = KSL_MULF(D1->m10, D2->m20) + KSL_MULF(D1->m11, D2->m21) + KSL_MULF(D1->m12, D2->m22),
      R_6 = KSL_MULF(D1->m20, D2->m00) + KSL_MULF(D1->m21, D2->m01) + KSL_MULF(D1->m22, D2->m02),
      R_7 = KSL_MULF(D1->m20, D2->m10) + KSL_MULF(D1->m21, D2->m11) + KSL_MULF(D1->m22, D2->m12),
      R_8 = KSL_MULF(D1->m20, D2->m20) + KSL_MULF(D1->m21, D2->m21) + KSL_MULF(D1->m22, D2->m22);
  const float Do_03 = D1->m03
          - (KSL_MULF(D2->m03, R_0) + KSL_MULF(D2->m13, R_1) + KSL_MULF(D2->m23, R_2)),
      Do_13 = D1->m13 - (KSL_MULF(D2->m03, R_3) + KSL_MULF(D2->m13, R_4) + KSL_MULF(D2->m23, R_5)),
      Do_23 = D1->m23 - (KSL_MULF(D2->m03, R_6) + KSL_MULF(D2->m13, R_7) + KSL_MULF(D2->m23, R_8));
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
  const float p_0 = D2->m03 - D1->m03, p_1 = D2->m13 - D1->m13, p_2 = D2->m23 - D1->m23;
  const float Do_00 = KSL_MULF(D1->m00, D2->m00) + KSL_MULF(D1->m10, D2->m10)
          + KSL_MULF(D1->m20, D2->m20),
      Do_01 = KSL_MULF(D1->m00, D2->m01) + KSL_MULF(D1->m10, D2->m11) + KSL_MULF(D1->m20, D2->m21),
      Do_02 = KSL_MULF(D1->m00, D2->m02) + KSL_MULF(D1->m10, D2->m12) + KSL_MULF(D1->m20, D2->m22),
      Do_03 = KSL_MULF(D1->m00, p_0) + KSL_MULF(D1->m10, p_1) + KSL_MULF(D1->m20, p_2),
      Do_10 = KSL_MULF(D1->m01, D2->m00) + KSL_MULF(D1->m11, D2->m10) + KSL_MULF(D1->m21, D2->m20),
      Do_11 = KSL_MULF(D1->m01, D2->m01) + KSL_MULF(D1->m11, D2->m11) + KSL_MULF(D1->m21, D2->m21),
      Do_12 = KSL_MULF(D1->m01, D2->m02) + KSL_MULF(D1->m11, D2->m12) + KSL_MULF(D1->m21, D2->m22),
      Do_13 = KSL_MULF(D1->m01, p_0) + KSL_MULF(D1->m11, p_1) + KSL_MULF(D1->m21, p_2),
      Do_20 = KSL_MULF(D1->m02, D2->m00) + KSL_MULF(D1->m12, D2->m10) + KSL_MULF(D1->m22, D2->m20),
      Do_21 = KSL_MULF(D1->m02, D2->m01) + KSL_MULF(D1->m12, D2->m11) + KSL_MULF(D1->m22, D2->m21),
      Do_22 = KSL_MULF(D1->m02, D2->m02) + KSL_MULF(D1->m12, D2->m12) + KSL_MULF(D1->m22, D2->m22),
      Do_23 = KSL_MULF(D1->m02, p_0) + KSL_MULF(D1->m12, p_1) + KSL_MULF(D1->m22, p_2);
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
  const float Do_00 = KSL_MULF(D->m00, R->m00) + KSL_MULF(D->m01, R->m10)
          + KSL_MULF(D->m02, R->m20),
      Do_01 = KSL_MULF(D->m00, R->m01) + KSL_MULF(D->m01, R->m11) + KSL_MULF(D->m02, R->m21),
      Do_02 = KSL_MULF(D->m00, R->m02) + KSL_MULF(D->m01, R->m12) + KSL_MULF(D->m02, R->m22),
      Do_10 = KSL_MULF(D->m10, R->m00) + KSL_MULF(D->m11, R->m10) + KSL_MULF(D->m12, R->m20),
      Do_11 = KSL_MULF(D->m10, R->m01) + KSL_MULF(D->m11, R->m11) + KSL_MULF(D->m12, R->m21),
      Do_12 = KSL_MULF(D->m10, R->m02) + KSL_MULF(D->m11, R->m12) + KSL_MULF(D->m12, R->m22),
      Do_20 = KSL_MULF(D->m20, R->m00) + KSL_MULF(D->m21, R->m10) + KSL_MULF(D->m22, R->m20),
      Do_21 = KSL_MULF(D->m20, R->m01) + KSL_MULF(D->m21, R->m11) + KSL_MULF(D->m22, R->m21),
      Do_22 = KSL_MULF(D->m20, R->m02) + KSL_MULF(D->m21, R->m12) + KSL_MULF(D->m22, R->m22);
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
  const float Do_00 = KSL_MULF(D->m00, R->m00) + KSL_MULF(D->m01, R->m01)
          + KSL_MULF(D->m02, R->m02),
      Do_01 = KSL_MULF(D->m00, R->m10) + KSL_MULF(D->m01, R->m11) + KSL_MULF(D->m02, R->m12),
      Do_02 = KSL_MULF(D->m00, R->m20) + KSL_MULF(D->m01, R->m21) + KSL_MULF(D->m02, R->m22),
      Do_10 = KSL_MULF(D->m10, R->m00) + KSL_MULF(D->m11, R->m01) + KSL_MULF(D->m12, R->m02),
      Do_11 = KSL_MULF(D->m10, R->m10) + KSL_MULF(D->m11, R->m11) + KSL_MULF(D->m12, R->m12),
      Do_12 = KSL_MULF(D->m10, R->m20) + KSL_MULF(D->m11, R->m21) + KSL_MULF(D->m12, R->m22),
      Do_20 = KSL_MULF(D->m20, R->m00) + KSL_MULF(D->m21, R->m01) + KSL_MULF(D->m22, R->m02),
      Do_21 = KSL_MULF(D->m20, R->m10) + KSL_MULF(D->m21, R->m11) + KSL_MULF(D->m22, R->m12),
      Do_22 = KSL_MULF(D->m20, R->m20) + KSL_MULF(D->m21, R->m21) + KSL_MULF(D->m22, R->m22);
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
  const float Do_03 = KSL_MULF(D->m00, t->x) + KSL_MULF(D->m01, t->y) + KSL_MULF(D->m02, t->z)
          + D->m03,
      Do_13 = KSL_MULF(D->m10, t->x) + KSL_MULF(D->m11, t->y) + KSL_MULF(D->m12, t->z) + D->m13,
      Do_23 = KSL_MULF(D->m20, t->x) + KSL_MULF(D->m21, t->y) + KSL_MULF(D->m22, t->z) + D->m23;
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
  const float Do_03 = D->m03
          - (KSL_MULF(D->m00, t->x) + KSL_MULF(D->m01, t->y) + KSL_MULF(D->m02, t->z)),
      Do_13 = D->m13 - (KSL_MULF(D->m10, t->x) + KSL_MULF(D->m11, t->y) + KSL_MULF(D->m12, t->z)),
      Do_23 = D->m23 - (KSL_MULF(D->m20, t->x) + KSL_MULF(D->m21, t->y) + KSL_MULF(D->m22, t->z));
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
  const float p_0 = t->x - D->m03, p_1 = t->y - D->m13, p_2 = t->z - D->m23;
  const float Do_03 = KSL_MULF(D->m00, p_0) + KSL_MULF(D->m10, p_1) + KSL_MULF(D->m20, p_2),
      Do_13 = KSL_MULF(D->m01, p_0) + KSL_MULF(D->m11, p_1) + KSL_MULF(D->m21, p_2),
      Do_23 = KSL_MULF(D->m02, p_0) + KSL_MULF(D->m12, p_1) + KSL_MULF(D->m22, p_2);
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
  const float vo_0 = KSL_MULF(R->m00, k), vo_1 = KSL_MULF(R->m10, k), vo_2 = KSL_MULF(R->m20, k);
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
  const float Ro_01 = KSL_MULF(R->m01, dc[1]) + KSL_MULF(R->m02, dc[0]),
      Ro_02 = KSL_MULF(R->m02, dc[1]) - KSL_MULF(R->m01, dc[0]),
      Ro_11 = KSL_MULF(R->m11, dc[1]) + KSL_MULF(R->m12, dc[0]),
      Ro_12 = KSL_MULF(R->m12, dc[1]) - KSL_MULF(R->m11, dc[0]),
      Ro_21 = KSL_MULF(R->m21, dc[1]) + KSL_MULF(R->m22, dc[0]),
      Ro_22 = KSL_MULF(R->m22, dc[1]) - KSL_MULF(R->m21, dc[0]);
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
  const float Do_01 = KSL_MULF(D->m01, dc[1]) + KSL_MULF(D->m02, dc[0]),
      Do_02 = KSL_MULF(D->m02, dc[1]) - KSL_MULF(D->m01, dc[0]),
      Do_11 = KSL_MULF(D->m11, dc[1]) + KSL_MULF(D->m12, dc[0]),
      Do_12 = KSL_MULF(D->m12, dc[1]) - KSL_MULF(D->m11, dc[0]),
      Do_21 = KSL_MULF(D->m21, dc[1]) + KSL_MULF(D->m22, dc[0]),
      Do_22 = KSL_MULF(D->m22, dc[1]) - KSL_MULF(D->m21, dc[0]);
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
  const float Do_03 = KSL_MULF(D->m00, k) + D->m03, Do_13 = KSL_MULF(D->m10, k) + D->m13,
      Do_23 = KSL_MULF(D->m20, k) + D->m23;
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
  const float vo_0 = -KSL_MULF(R->m00, k), vo_1 = -KSL_MULF(R->m10, k), vo_2 = -KSL_MULF(R->m20, k);
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
  const float Ro_01 = KSL_MULF(R->m01, dc[1]) - KSL_MULF(R->m02, dc[0]),
      Ro_02 = KSL_MULF(R->m01, dc[0]) + KSL_MULF(R->m02, dc[1]),
      Ro_11 = KSL_MULF(R->m11, dc[1]) - KSL_MULF(R->m12, dc[0]),
      Ro_12 = KSL_MULF(R->m11, dc[0]) + KSL_MULF(R->m12, dc[1]),
      Ro_21 = KSL_MULF(R->m21, dc[1]) - KSL_MULF(R->m22, dc[0]),
      Ro_22 = KSL_MULF(R->m21, dc[0]) + KSL_MULF(R->m22, dc[1]);
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
  const float Do_01 = KSL_MULF(D->m01, dc[1]) - KSL_MULF(D->m02, dc[0]),
      Do_02 = KSL_MULF(D->m01, dc[0]) + KSL_MULF(D->m02, dc[1]),
      Do_11 = KSL_MULF(D->m11, dc[1]) - KSL_MULF(D->m12, dc[0]),
      Do_12 = KSL_MULF(D->m11, dc[0]) + KSL_MULF(D->m12, dc[1]),
      Do_21 = KSL_MULF(D->m21, dc[1]) - KSL_MULF(D->m22, dc[0]),
      Do_22 = KSL_MULF(D->m21, dc[0]) + KSL_MULF(D->m22, dc[1]);
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
  const float Do_03 = D->m03 - KSL_MULF(D->m00, k), Do_13 = D->m13 - KSL_MULF(D->m10, k),
      Do_23 = D->m23 - KSL_MULF(D->m20, k);
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
  const float vo_0 = KSL_MULF(R->m01, k), vo_1 = KSL_MULF(R->m11, k), vo_2 = KSL_MULF(R->m21, k);
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
  const float Ro_00 = KSL_MULF(R->m00, dc[1]) - KSL_MULF(R->m02, dc[0]),
      Ro_02 = KSL_MULF(R->m00, dc[0]) + KSL_MULF(R->m02, dc[1]),
      Ro_10 = KSL_MULF(R->m10, dc[1]) - KSL_MULF(R->m12, dc[0]),
      Ro_12 = KSL_MULF(R->m10, dc[0]) + KSL_MULF(R->m12, dc[1]),
      Ro_20 = KSL_MULF(R->m20, dc[1]) - KSL_MULF(R->m22, dc[0]),
      Ro_22 = KSL_MULF(R->m20, dc[0]) + KSL_MULF(R->m22, dc[1]);
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
  const float Do_00 = KSL_MULF(D->m00, dc[1]) - KSL_MULF(D->m02, dc[0]),
      Do_02 = KSL_MULF(D->m00, dc[0]) + KSL_MULF(D->m02, dc[1]),
      Do_10 = KSL_MULF(D->m10, dc[1]) - KSL_MULF(D->m12, dc[0]),
      Do_12 = KSL_MULF(D->m10, dc[0]) + KSL_MULF(D->m12, dc[1]),
      Do_20 = KSL_MULF(D->m20, dc[1]) - KSL_MULF(D->m22, dc[0]),
      Do_22 = KSL_MULF(D->m20, dc[0]) + KSL_MULF(D->m22, dc[1]);
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
  const float Do_03 = KSL_MULF(D->m01, k) + D->m03, Do_13 = KSL_MULF(D->m11, k) + D->m13,
      Do_23 = KSL_MULF(D->m21, k) + D->m23;
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
  const float vo_0 = -KSL_MULF(R->m01, k), vo_1 = -KSL_MULF(R->m11, k), vo_2 = -KSL_MULF(R->m21, k);
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
  const float Ro_00 = KSL_MULF(R->m00, dc[1]) + KSL_MULF(R->m02, dc[0]),
      Ro_02 = KSL_MULF(R->m02, dc[1]) - KSL_MULF(R->m00, dc[0]),
      Ro_10 = KSL_MULF(R->m10, dc[1]) + KSL_MULF(R->m12, dc[0]),
      Ro_12 = KSL_MULF(R->m12, dc[1]) - KSL_MULF(R->m10, dc[0]),
      Ro_20 = KSL_MULF(R->m20, dc[1]) + KSL_MULF(R->m22, dc[0]),
      Ro_22 = KSL_MULF(R->m22, dc[1]) - KSL_MULF(R->m20, dc[0]);
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
  const float Do_00 = KSL_MULF(D->m00, dc[1]) + KSL_MULF(D->m02, dc[0]),
      Do_02 = KSL_MULF(D->m02, dc[1]) - KSL_MULF(D->m00, dc[0]),
      Do_10 = KSL_MULF(D->m10, dc[1]) + KSL_MULF(D->m12, dc[0]),
      Do_12 = KSL_MULF(D->m12, dc[1]) - KSL_MULF(D->m10, dc[0]),
      Do_20 = KSL_MULF(D->m20, dc[1]) + KSL_MULF(D->m22, dc[0]),
      Do_22 = KSL_MULF(D->m22, dc[1]) - KSL_MULF(D->m20, dc[0]);
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
  const float Do_03 = D->m03 - KSL_MULF(D->m01, k), Do_13 = D->m13 - KSL_MULF(D->m11, k),
      Do_23 = D->m23 - KSL_MULF(D->m21, k);
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
  const float vo_0 = KSL_MULF(R->m02, k), vo_1 = KSL_MULF(R->m12, k), vo_2 = KSL_MULF(R->m22, k);
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
  const float Ro_00 = KSL_MULF(R->m00, dc[1]) + KSL_MULF(R->m01, dc[0]),
      Ro_01 = KSL_MULF(R->m01, dc[1]) - KSL_MULF(R->m00, dc[0]),
      Ro_10 = KSL_MULF(R->m10, dc[1]) + KSL_MULF(R->m11, dc[0]),
      Ro_11 = KSL_MULF(R->m11, dc[1]) - KSL_MULF(R->m10, dc[0]),
      Ro_20 = KSL_MULF(R->m20, dc[1]) + KSL_MULF(R->m21, dc[0]),
      Ro_21 = KSL_MULF(R->m21, dc[1]) - KSL_MULF(R->m20, dc[0]);
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
  const float Do_00 = KSL_MULF(D->m00, dc[1]) + KSL_MULF(D->m01, dc[0]),
      Do_01 = KSL_MULF(D->m01, dc[1]) - KSL_MULF(D->m00, dc[0]),
      Do_10 = KSL_MULF(D->m10, dc[1]) + KSL_MULF(D->m11, dc[0]),
      Do_11 = KSL_MULF(D->m11, dc[1]) - KSL_MULF(D->m10, dc[0]),
      Do_20 = KSL_MULF(D->m20, dc[1]) + KSL_MULF(D->m21, dc[0]),
      Do_21 = KSL_MULF(D->m21, dc[1]) - KSL_MULF(D->m20, dc[0]);
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
  const float Do_03 = KSL_MULF(D->m02, k) + D->m03, Do_13 = KSL_MULF(D->m12, k) + D->m13,
      Do_23 = KSL_MULF(D->m22, k) + D->m23;
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
  const float vo_0 = -KSL_MULF(R->m02, k), vo_1 = -KSL_MULF(R->m12, k), vo_2 = -KSL_MULF(R->m22, k);
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
  const float Ro_00 = KSL_MULF(R->m00, dc[1]) - KSL_MULF(R->m01, dc[0]),
      Ro_01 = KSL_MULF(R->m00, dc[0]) + KSL_MULF(R->m01, dc[1]),
      Ro_10 = KSL_MULF(R->m10, dc[1]) - KSL_MULF(R->m11, dc[0]),
      Ro_11 = KSL_MULF(R->m10, dc[0]) + KSL_MULF(R->m11, dc[1]),
      Ro_20 = KSL_MULF(R->m20, dc[1]) - KSL_MULF(R->m21, dc[0]),
      Ro_21 = KSL_MULF(R->m20, dc[0]) + KSL_MULF(R->m21, dc[1]);
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
  const float Do_00 = KSL_MULF(D->m00, dc[1]) - KSL_MULF(D->m01, dc[0]),
      Do_01 = KSL_MULF(D->m00, dc[0]) + KSL_MULF(D->m01, dc[1]),
      Do_10 = KSL_MULF(D->m10, dc[1]) - KSL_MULF(D->m11, dc[0]),
      Do_11 = KSL_MULF(D->m10, dc[0]) + KSL_MULF(D->m11, dc[1]),
      Do_20 = KSL_MULF(D->m20, dc[1]) - KSL_MULF(D->m21, dc[0]),
      Do_21 = KSL_MULF(D->m20, dc[0]) + KSL_MULF(D->m21, dc[1]);
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
  const float Do_03 = D->m03 - KSL_MULF(D->m02, k), Do_13 = D->m13 - KSL_MULF(D->m12, k),
      Do_23 = D->m23 - KSL_MULF(D->m22, k);
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
