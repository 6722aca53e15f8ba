/* Made by `coscrew generate`; changes are overwritten. */
/* SPDX-License-Identifier: MIT */
/* coscrew 0.2.0.  Copyright (c) 2026 The coscrew authors. */
/* Products between rotations, displacements and vectors.
   Fused tier: products fused into sums. */
#ifndef KSL_MATRIX_FUSED_H
#define KSL_MATRIX_FUSED_H

#include "ksl_types.h"

/* vo = R v.
   R: rotation or other 3×3 matrix; v, vo: vector.
   3 mul, 6 fma.
   Error <= u |result| + 2 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_product_drv_fused(const ksl_mat3x3_t *R, const ksl_vec3_t *v,
    ksl_vec3_t *vo) {
  const double vo_0a = KSL_MUL(R->m00, v->x), vo_0c = fma(R->m01, v->y, vo_0a),
      vo_0 = fma(R->m02, v->z, vo_0c);
  const double vo_1a = KSL_MUL(R->m10, v->x), vo_1c = fma(R->m11, v->y, vo_1a),
      vo_1 = fma(R->m12, v->z, vo_1c);
  const double vo_2a = KSL_MUL(R->m20, v->x), vo_2c = fma(R->m21, v->y, vo_2a),
      vo_2 = fma(R->m22, v->z, vo_2c);
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
}

/* vo = R (-v).
   R: rotation or other 3×3 matrix; v, vo: vector.
   3 mul, 6 fma, 3 neg.
   Error <= u |result| + 2 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_product_drvinv_fused(const ksl_mat3x3_t *R, const ksl_vec3_t *v,
    ksl_vec3_t *vo) {
  const double vo_0a = KSL_MUL(R->m00, v->x), vo_0c_lead = -vo_0a,
      vo_0c = fma(-R->m01, v->y, vo_0c_lead), vo_0 = fma(-R->m02, v->z, vo_0c);
  const double vo_1a = KSL_MUL(R->m10, v->x), vo_1c_lead = -vo_1a,
      vo_1c = fma(-R->m11, v->y, vo_1c_lead), vo_1 = fma(-R->m12, v->z, vo_1c);
  const double vo_2a = KSL_MUL(R->m20, v->x), vo_2c_lead = -vo_2a,
      vo_2c = fma(-R->m21, v->y, vo_2c_lead), vo_2 = fma(-R->m22, v->z, vo_2c);
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
}

/* vo = R^T v.
   R: rotation or other 3×3 matrix; v, vo: vector.
   3 mul, 6 fma.
   Error <= u |result| + 2 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_product_drinvv_fused(const ksl_mat3x3_t *R, const ksl_vec3_t *v,
    ksl_vec3_t *vo) {
  const double vo_0a = KSL_MUL(R->m00, v->x), vo_0c = fma(R->m10, v->y, vo_0a),
      vo_0 = fma(R->m20, v->z, vo_0c);
  const double vo_1a = KSL_MUL(R->m01, v->x), vo_1c = fma(R->m11, v->y, vo_1a),
      vo_1 = fma(R->m21, v->z, vo_1c);
  const double vo_2a = KSL_MUL(R->m02, v->x), vo_2c = fma(R->m12, v->y, vo_2a),
      vo_2 = fma(R->m22, v->z, vo_2c);
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
}

/* vo = R^T (-v).
   R: rotation or other 3×3 matrix; v, vo: vector.
   3 mul, 6 fma, 3 neg.
   Error <= u |result| + 2 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_product_drinvvinv_fused(const ksl_mat3x3_t *R, const ksl_vec3_t *v,
    ksl_vec3_t *vo) {
  const double vo_0a = KSL_MUL(R->m00, v->x), vo_0c_lead = -vo_0a,
      vo_0c = fma(-R->m10, v->y, vo_0c_lead), vo_0 = fma(-R->m20, v->z, vo_0c);
  const double vo_1a = KSL_MUL(R->m01, v->x), vo_1c_lead = -vo_1a,
      vo_1c = fma(-R->m11, v->y, vo_1c_lead), vo_1 = fma(-R->m21, v->z, vo_1c);
  const double vo_2a = KSL_MUL(R->m02, v->x), vo_2c_lead = -vo_2a,
      vo_2c = fma(-R->m12, v->y, vo_2c_lead), vo_2 = fma(-R->m22, v->z, vo_2c);
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
}

/* vo = R v + t.
   D: displacement [R | t], R rotation, t in m; v, vo: vector.
   3 mul, 3 add, 6 fma.
   Error <= u |result| + 3 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_product_dv_fused(const ksl_SE3_t *D, const ksl_vec3_t *v, ksl_vec3_t *vo) {
  const double vo_0a = KSL_MUL(D->m00, v->x), vo_0c = fma(D->m01, v->y, vo_0a),
      vo_0e = fma(D->m02, v->z, vo_0c), vo_0 = vo_0e + D->m03;
  const double vo_1a = KSL_MUL(D->m10, v->x), vo_1c = fma(D->m11, v->y, vo_1a),
      vo_1e = fma(D->m12, v->z, vo_1c), vo_1 = vo_1e + D->m13;
  const double vo_2a = KSL_MUL(D->m20, v->x), vo_2c = fma(D->m21, v->y, vo_2a),
      vo_2e = fma(D->m22, v->z, vo_2c), vo_2 = vo_2e + D->m23;
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
}

/* vo = R^T (v - t).
   D: displacement [R | t], R rotation, t in m; v, vo: vector.
   3 mul, 3 add, 6 fma.
   Error <= u |result| + 3 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_product_dinvv_fused(const ksl_SE3_t *D, const ksl_vec3_t *v,
    ksl_vec3_t *vo) {
  const double p_0 = v->x - D->m03;
  const double p_1 = v->y - D->m13;
  const double p_2 = v->z - D->m23;
  const double vo_0a = KSL_MUL(D->m00, p_0), vo_0c = fma(D->m10, p_1, vo_0a),
      vo_0 = fma(D->m20, p_2, vo_0c);
  const double vo_1a = KSL_MUL(D->m01, p_0), vo_1c = fma(D->m11, p_1, vo_1a),
      vo_1 = fma(D->m21, p_2, vo_1c);
  const double vo_2a = KSL_MUL(D->m02, p_0), vo_2c = fma(D->m12, p_1, vo_2a),
      vo_2 = fma(D->m22, p_2, vo_2c);
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
}

/* Ro = R1 R2.
   R1, R2, Ro: rotation or other 3×3 matrix.
   9 mul, 18 fma.
   Error <= u |result| + 2 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_product_drdr_fused(const ksl_mat3x3_t *R1, const ksl_mat3x3_t *R2,
    ksl_mat3x3_t *Ro) {
  const double Ro_00a = KSL_MUL(R1->m00, R2->m00), Ro_00c = fma(R1->m01, R2->m10, Ro_00a),
      Ro_00 = fma(R1->m02, R2->m20, Ro_00c);
  const double Ro_01a = KSL_MUL(R1->m00, R2->m01), Ro_01c = fma(R1->m01, R2->m11, Ro_01a),
      Ro_01 = fma(R1->m02, R2->m21, Ro_01c);
  const double Ro_02a = KSL_MUL(R1->m00, R2->m02), Ro_02c = fma(R1->m01, R2->m12, Ro_02a),
      Ro_02 = fma(R1->m02, R2->m22, Ro_02c);
  const double Ro_10a = KSL_MUL(R1->m10, R2->m00), Ro_10c = fma(R1->m11, R2->m10, Ro_10a),
      Ro_10 = fma(R1->m12, R2->m20, Ro_10c);
  const double Ro_11a = KSL_MUL(R1->m10, R2->m01), Ro_11c = fma(R1->m11, R2->m11, Ro_11a),
      Ro_11 = fma(R1->m12, R2->m21, Ro_11c);
  const double Ro_12a = KSL_MUL(R1->m10, R2->m02), Ro_12c = fma(R1->m11, R2->m12, Ro_12a),
      Ro_12 = fma(R1->m12, R2->m22, Ro_12c);
  const double Ro_20a = KSL_MUL(R1->m20, R2->m00), Ro_20c = fma(R1->m21, R2->m10, Ro_20a),
      Ro_20 = fma(R1->m22, R2->m20, Ro_20c);
  const double Ro_21a = KSL_MUL(R1->m20, R2->m01), Ro_21c = fma(R1->m21, R2->m11, Ro_21a),
      Ro_21 = fma(R1->m22, R2->m21, Ro_21c);
  const double Ro_22a = KSL_MUL(R1->m20, R2->m02), Ro_22c = fma(R1->m21, R2->m12, Ro_22a),
      Ro_22 = fma(R1->m22, R2->m22, Ro_22c);
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
   9 mul, 18 fma.
   Error <= u |result| + 2 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_product_drdrinv_fused(const ksl_mat3x3_t *R1, const ksl_mat3x3_t *R2,
    ksl_mat3x3_t *Ro) {
  const double Ro_00a = KSL_MUL(R1->m00, R2->m00), Ro_00c = fma(R1->m01, R2->m01, Ro_00a),
      Ro_00 = fma(R1->m02, R2->m02, Ro_00c);
  const double Ro_01a = KSL_MUL(R1->m00, R2->m10), Ro_01c = fma(R1->m01, R2->m11, Ro_01a),
      Ro_01 = fma(R1->m02, R2->m12, Ro_01c);
  const double Ro_02a = KSL_MUL(R1->m00, R2->m20), Ro_02c = fma(R1->m01, R2->m21, Ro_02a),
      Ro_02 = fma(R1->m02, R2->m22, Ro_02c);
  const double Ro_10a = KSL_MUL(R1->m10, R2->m00), Ro_10c = fma(R1->m11, R2->m01, Ro_10a),
      Ro_10 = fma(R1->m12, R2->m02, Ro_10c);
  const double Ro_11a = KSL_MUL(R1->m10, R2->m10), Ro_11c = fma(R1->m11, R2->m11, Ro_11a),
      Ro_11 = fma(R1->m12, R2->m12, Ro_11c);
  const double Ro_12a = KSL_MUL(R1->m10, R2->m20), Ro_12c = fma(R1->m11, R2->m21, Ro_12a),
      Ro_12 = fma(R1->m12, R2->m22, Ro_12c);
  const double Ro_20a = KSL_MUL(R1->m20, R2->m00), Ro_20c = fma(R1->m21, R2->m01, Ro_20a),
      Ro_20 = fma(R1->m22, R2->m02, Ro_20c);
  const double Ro_21a = KSL_MUL(R1->m20, R2->m10), Ro_21c = fma(R1->m21, R2->m11, Ro_21a),
      Ro_21 = fma(R1->m22, R2->m12, Ro_21c);
  const double Ro_22a = KSL_MUL(R1->m20, R2->m20), Ro_22c = fma(R1->m21, R2->m21, Ro_22a),
      Ro_22 = fma(R1->m22, R2->m22, Ro_22c);
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
   9 mul, 18 fma.
   Error <= u |result| + 2 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_product_drinvdr_fused(const ksl_mat3x3_t *R1, const ksl_mat3x3_t *R2,
    ksl_mat3x3_t *Ro) {
  const double Ro_00a = KSL_MUL(R1->m00, R2->m00), Ro_00c = fma(R1->m10, R2->m10, Ro_00a),
      Ro_00 = fma(R1->m20, R2->m20, Ro_00c);
  const double Ro_01a = KSL_MUL(R1->m00, R2->m01), Ro_01c = fma(R1->m10, R2->m11, Ro_01a),
      Ro_01 = fma(R1->m20, R2->m21, Ro_01c);
  const double Ro_02a = KSL_MUL(R1->m00, R2->m02), Ro_02c = fma(R1->m10, R2->m12, Ro_02a),
      Ro_02 = fma(R1->m20, R2->m22, Ro_02c);
  const double Ro_10a = KSL_MUL(R1->m01, R2->m00), Ro_10c = fma(R1->m11, R2->m10, Ro_10a),
      Ro_10 = fma(R1->m21, R2->m20, Ro_10c);
  const double Ro_11a = KSL_MUL(R1->m01, R2->m01), Ro_11c = fma(R1->m11, R2->m11, Ro_11a),
      Ro_11 = fma(R1->m21, R2->m21, Ro_11c);
  const double Ro_12a = KSL_MUL(R1->m01, R2->m02), Ro_12c = fma(R1->m11, R2->m12, Ro_12a),
      Ro_12 = fma(R1->m21, R2->m22, Ro_12c);
  const double Ro_20a = KSL_MUL(R1->m02, R2->m00), Ro_20c = fma(R1->m12, R2->m10, Ro_20a),
      Ro_20 = fma(R1->m22, R2->m20, Ro_20c);
  const double Ro_21a = KSL_MUL(R1->m02, R2->m01), Ro_21c = fma(R1->m12, R2->m11, Ro_21a),
      Ro_21 = fma(R1->m22, R2->m21, Ro_21c);
  const double Ro_22a = KSL_MUL(R1->m02, R2->m02), Ro_22c = fma(R1->m12, R2->m12, Ro_22a),
      Ro_22 = fma(R1->m22, R2->m22, Ro_22c);
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
   12 mul, 3 add, 24 fma.
   Error <= u |result| + (R: 2, t: 3) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_dd_fused(const ksl_SE3_t *D1, const ksl_SE3_t *D2, ksl_SE3_t *Do) {
  const double Do_00a = KSL_MUL(D1->m00, D2->m00), Do_00c = fma(D1->m01, D2->m10, Do_00a),
      Do_00 = fma(D1->m02, D2->m20, Do_00c);
  const double Do_01a = KSL_MUL(D1->m00, D2->m01), Do_01c = fma(D1->m01, D2->m11, Do_01a),
      Do_01 = fma(D1->m02, D2->m21, Do_01c);
  const double Do_02a = KSL_MUL(D1->m00, D2->m02), Do_02c = fma(D1->m01, D2->m12, Do_02a),
      Do_02 = fma(D1->m02, D2->m22, Do_02c);
  const double Do_03a = KSL_MUL(D1->m00, D2->m03), Do_03c = fma(D1->m01, D2->m13, Do_03a),
      Do_03e = fma(D1->m02, D2->m23, Do_03c), Do_03 = Do_03e + D1->m03;
  const double Do_10a = KSL_MUL(D1->m10, D2->m00), Do_10c = fma(D1->m11, D2->m10, Do_10a),
      Do_10 = fma(D1->m12, D2->m20, Do_10c);
  const double Do_11a = KSL_MUL(D1->m10, D2->m01), Do_11c = fma(D1->m11, D2->m11, Do_11a),
      Do_11 = fma(D1->m12, D2->m21, Do_11c);
  const double Do_12a = KSL_MUL(D1->m10, D2->m02), Do_12c = fma(D1->m11, D2->m12, Do_12a),
      Do_12 = fma(D1->m12, D2->m22, Do_12c);
  const double Do_13a = KSL_MUL(D1->m10, D2->m03), Do_13c = fma(D1->m11, D2->m13, Do_13a),
      Do_13e = fma(D1->m12, D2->m23, Do_13c), Do_13 = Do_13e + D1->m13;
  const double Do_20a = KSL_MUL(D1->m20, D2->m00), Do_20c = fma(D1->m21, D2->m10, Do_20a),
      Do_20 = fma(D1->m22, D2->m20, Do_20c);
  const double Do_21a = KSL_MUL(D1->m20, D2->m01), Do_21c = fma(D1->m21, D2->m11, Do_21a),
      Do_21 = fma(D1->m22, D2->m21, Do_21c);
  const double Do_22a = KSL_MUL(D1->m20, D2->m02), Do_22c = fma(D1->m21, D2->m12, Do_22a),
      Do_22 = fma(D1->m22, D2->m22, Do_22c);
  const double Do_23a = KSL_MUL(D1->m20, D2->m03), Do_23c = fma(D1->m21, D2->m13, Do_23a),
      Do_23e = fma(D1->m22, D2->m23, Do_23c), Do_23 = Do_23e + D1->m23;
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
   12 mul, 3 add, 24 fma.
   Error <= u |result| + (R: 2, t: 6) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_ddinv_fused(const ksl_SE3_t *D1, const ksl_SE3_t *D2,
    ksl_SE3_t *Do) {
  const double R_0a = KSL_MUL(D1->m00, D2->m00), R_0c = fma(D1->m01, D2->m01, R_0a),
      R_0 = fma(D1->m02, D2->m02, R_0c);
  const double R_1a = KSL_MUL(D1->m00, D2->m10), R_1c = fma(D1->m01, D2->m11, R_1a),
      R_1 = fma(D1->m02, D2->m12, R_1c);
  const double R_2a = KSL_MUL(D1->m00, D2->m20), R_2c = fma(D1->m01, D2->m21, R_2a),
      R_2 = fma(D1->m02, D2->m22, R_2c);
  const double R_3a = KSL_MUL(D1->m10, D2->m00), R_3c = fma(D1->m11, D2->m01, R_3a),
      R_3 = fma(D1->m12, D2->m02, R_3c);
  const double R_4a = KSL_MUL(D1->m10, D2->m10), R_4c = fma(D1->m11, D2->m11, R_4a),
      R_4 = fma(D1->m12, D2->m12, R_4c);
  const double R_5a = KSL_MUL(D1->m10, D2->m20), R_5c = fma(D1->m11, D2->m21, R_5a),
      R_5 = fma(D1->m12, D2->m22, R_5c);
  const double R_6a = KSL_MUL(D1->m20, D2->m00), R_6c = fma(D1->m21, D2->m01, R_6a),
      R_6 = fma(D1->m22, D2->m02, R_6c);
  const double R_7a = KSL_MUL(D1->m20, D2->m10), R_7c = fma(D1->m21, D2->m11, R_7a),
      R_7 = fma(D1->m22, D2->m12, R_7c);
  const double R_8a = KSL_MUL(D1->m20, D2->m20), R_8c = fma(D1->m21, D2->m21, R_8a),
      R_8 = fma(D1->m22, D2->m22, R_8c);
  const double Do_03a = KSL_MUL(D2->m03, R_0), Do_03c = fma(D2->m13, R_1, Do_03a),
      Do_03e = fma(D2->m23, R_2, Do_03c), Do_03 = D1->m03 - Do_03e;
  const double Do_13a = KSL_MUL(D2->m03, R_3), Do_13c = fma(D2->m13, R_4, Do_13a),
      Do_13e = fma(D2->m23, R_5, Do_13c), Do_13 = D1->m13 - Do_13e;
  const double Do_23a = KSL_MUL(D2->m03, R_6), Do_23c = fma(D2->m13, R_7, Do_23a),
      Do_23e = fma(D2->m23, R_8, Do_23c), Do_23 = D1->m23 - Do_23e;
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
   12 mul, 3 add, 24 fma.
   Error <= u |result| + (R: 2, t: 3) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_dinvd_fused(const ksl_SE3_t *D1, const ksl_SE3_t *D2,
    ksl_SE3_t *Do) {
  const double p_0 = D2->m03 - D1->m03;
  const double p_1 = D2->m13 - D1->m13;
  const double p_2 = D2->m23 - D1->m23;
  const double Do_00a = KSL_MUL(D1->m00, D2->m00), Do_00c = fma(D1->m10, D2->m10, Do_00a),
      Do_00 = fma(D1->m20, D2->m20, Do_00c);
  const double Do_01a = KSL_MUL(D1->m00, D2->m01), Do_01c = fma(D1->m10, D2->m11, Do_01a),
      Do_01 = fma(D1->m20, D2->m21, Do_01c);
  const double Do_02a = KSL_MUL(D1->m00, D2->m02), Do_02c = fma(D1->m10, D2->m12, Do_02a),
      Do_02 = fma(D1->m20, D2->m22, Do_02c);
  const double Do_03a = KSL_MUL(D1->m00, p_0), Do_03c = fma(D1->m10, p_1, Do_03a),
      Do_03 = fma(D1->m20, p_2, Do_03c);
  const double Do_10a = KSL_MUL(D1->m01, D2->m00), Do_10c = fma(D1->m11, D2->m10, Do_10a),
      Do_10 = fma(D1->m21, D2->m20, Do_10c);
  const double Do_11a = KSL_MUL(D1->m01, D2->m01), Do_11c = fma(D1->m11, D2->m11, Do_11a),
      Do_11 = fma(D1->m21, D2->m21, Do_11c);
  const double Do_12a = KSL_MUL(D1->m01, D2->m02), Do_12c = fma(D1->m11, D2->m12, Do_12a),
      Do_12 = fma(D1->m21, D2->m22, Do_12c);
  const double Do_13a = KSL_MUL(D1->m01, p_0), Do_13c = fma(D1->m11, p_1, Do_13a),
      Do_13 = fma(D1->m21, p_2, Do_13c);
  const double Do_20a = KSL_MUL(D1->m02, D2->m00), Do_20c = fma(D1->m12, D2->m10, Do_20a),
      Do_20 = fma(D1->m22, D2->m20, Do_20c);
  const double Do_21a = KSL_MUL(D1->m02, D2->m01), Do_21c = fma(D1->m12, D2->m11, Do_21a),
      Do_21 = fma(D1->m22, D2->m21, Do_21c);
  const double Do_22a = KSL_MUL(D1->m02, D2->m02), Do_22c = fma(D1->m12, D2->m12, Do_22a),
      Do_22 = fma(D1->m22, D2->m22, Do_22c);
  const double Do_23a = KSL_MUL(D1->m02, p_0), Do_23c = fma(D1->m12, p_1, Do_23a),
      Do_23 = fma(D1->m22, p_2, Do_23c);
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
   9 mul, 18 fma.
   Error <= u |result| + (R: 2, t: 0) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_ddr_fused(const ksl_SE3_t *D, const ksl_mat3x3_t *R, ksl_SE3_t *Do) {
  const double Do_00a = KSL_MUL(D->m00, R->m00), Do_00c = fma(D->m01, R->m10, Do_00a),
      Do_00 = fma(D->m02, R->m20, Do_00c);
  const double Do_01a = KSL_MUL(D->m00, R->m01), Do_01c = fma(D->m01, R->m11, Do_01a),
      Do_01 = fma(D->m02, R->m21, Do_01c);
  const double Do_02a = KSL_MUL(D->m00, R->m02), Do_02c = fma(D->m01, R->m12, Do_02a),
      Do_02 = fma(D->m02, R->m22, Do_02c);
  const double Do_10a = KSL_MUL(D->m10, R->m00), Do_10c = fma(D->m11, R->m10, Do_10a),
      Do_10 = fma(D->m12, R->m20, Do_10c);
  const double Do_11a = KSL_MUL(D->m10, R->m01), Do_11c = fma(D->m11, R->m11, Do_11a),
      Do_11 = fma(D->m12, R->m21, Do_11c);
  const double Do_12a = KSL_MUL(D->m10, R->m02), Do_12c = fma(D->m11, R->m12, Do_12a),
      Do_12 = fma(D->m12, R->m22, Do_12c);
  const double Do_20a = KSL_MUL(D->m20, R->m00), Do_20c = fma(D->m21, R->m10, Do_20a),
      Do_20 = fma(D->m22, R->m20, Do_20c);
  const double Do_21a = KSL_MUL(D->m20, R->m01), Do_21c = fma(D->m21, R->m11, Do_21a),
      Do_21 = fma(D->m22, R->m21, Do_21c);
  const double Do_22a = KSL_MUL(D->m20, R->m02), Do_22c = fma(D->m21, R->m12, Do_22a),
      Do_22 = fma(D->m22, R->m22, Do_22c);
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
   9 mul, 18 fma.
   Error <= u |result| + (R: 2, t: 0) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_ddrinv_fused(const ksl_SE3_t *D, const ksl_mat3x3_t *R,
    ksl_SE3_t *Do) {
  const double Do_00a = KSL_MUL(D->m00, R->m00), Do_00c = fma(D->m01, R->m01, Do_00a),
      Do_00 = fma(D->m02, R->m02, Do_00c);
  const double Do_01a = KSL_MUL(D->m00, R->m10), Do_01c = fma(D->m01, R->m11, Do_01a),
      Do_01 = fma(D->m02, R->m12, Do_01c);
  const double Do_02a = KSL_MUL(D->m00, R->m20), Do_02c = fma(D->m01, R->m21, Do_02a),
      Do_02 = fma(D->m02, R->m22, Do_02c);
  const double Do_10a = KSL_MUL(D->m10, R->m00), Do_10c = fma(D->m11, R->m01, Do_10a),
      Do_10 = fma(D->m12, R->m02, Do_10c);
  const double Do_11a = KSL_MUL(D->m10, R->m10), Do_11c = fma(D->m11, R->m11, Do_11a),
      Do_11 = fma(D->m12, R->m12, Do_11c);
  const double Do_12a = KSL_MUL(D->m10, R->m20), Do_12c = fma(D->m11, R->m21, Do_12a),
      Do_12 = fma(D->m12, R->m22, Do_12c);
  const double Do_20a = KSL_MUL(D->m20, R->m00), Do_20c = fma(D->m21, R->m01, Do_20a),
      Do_20 = fma(D->m22, R->m02, Do_20c);
  const double Do_21a = KSL_MUL(D->m20, R->m10), Do_21c = fma(D->m21, R->m11, Do_21a),
      Do_21 = fma(D->m22, R->m12, Do_21c);
  const double Do_22a = KSL_MUL(D->m20, R->m20), Do_22c = fma(D->m21, R->m21, Do_22a),
      Do_22 = fma(D->m22, R->m22, Do_22c);
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
   3 mul, 3 add, 6 fma.
   Error <= u |result| + (R: 0, t: 3) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_ddt_fused(const ksl_SE3_t *D, const ksl_vec3_t *t, ksl_SE3_t *Do) {
  const double Do_03a = KSL_MUL(D->m00, t->x), Do_03c = fma(D->m01, t->y, Do_03a),
      Do_03e = fma(D->m02, t->z, Do_03c), Do_03 = Do_03e + D->m03;
  const double Do_13a = KSL_MUL(D->m10, t->x), Do_13c = fma(D->m11, t->y, Do_13a),
      Do_13e = fma(D->m12, t->z, Do_13c), Do_13 = Do_13e + D->m13;
  const double Do_23a = KSL_MUL(D->m20, t->x), Do_23c = fma(D->m21, t->y, Do_23a),
      Do_23e = fma(D->m22, t->z, Do_23c), Do_23 = Do_23e + D->m23;
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
   3 mul, 3 add, 6 fma.
   Error <= u |result| + (R: 0, t: 3) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_ddtinv_fused(const ksl_SE3_t *D, const ksl_vec3_t *t,
    ksl_SE3_t *Do) {
  const double Do_03a = KSL_MUL(D->m00, t->x), Do_03c = fma(D->m01, t->y, Do_03a),
      Do_03e = fma(D->m02, t->z, Do_03c), Do_03 = D->m03 - Do_03e;
  const double Do_13a = KSL_MUL(D->m10, t->x), Do_13c = fma(D->m11, t->y, Do_13a),
      Do_13e = fma(D->m12, t->z, Do_13c), Do_13 = D->m13 - Do_13e;
  const double Do_23a = KSL_MUL(D->m20, t->x), Do_23c = fma(D->m21, t->y, Do_23a),
      Do_23e = fma(D->m22, t->z, Do_23c), Do_23 = D->m23 - Do_23e;
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
   3 mul, 3 add, 6 fma.
   Error <= u |result| + (R: 0, t: 3) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_dinvdt_fused(const ksl_SE3_t *D, const ksl_vec3_t *t,
    ksl_SE3_t *Do) {
  const double p_0 = t->x - D->m03;
  const double p_1 = t->y - D->m13;
  const double p_2 = t->z - D->m23;
  const double Do_03a = KSL_MUL(D->m00, p_0), Do_03c = fma(D->m10, p_1, Do_03a),
      Do_03 = fma(D->m20, p_2, Do_03c);
  const double Do_13a = KSL_MUL(D->m01, p_0), Do_13c = fma(D->m11, p_1, Do_13a),
      Do_13 = fma(D->m21, p_2, Do_13c);
  const double Do_23a = KSL_MUL(D->m02, p_0), Do_23c = fma(D->m12, p_1, Do_23a),
      Do_23 = fma(D->m22, p_2, Do_23c);
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
static inline void ksl_product_drvtx_fused(const ksl_mat3x3_t *R, const double k, ksl_vec3_t *vo) {
  const double vo_0 = KSL_MUL(R->m00, k);
  const double vo_1 = KSL_MUL(R->m10, k);
  const double vo_2 = KSL_MUL(R->m20, k);
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
}

/* Ro = R R_x(θ), dc = (sin θ, cos θ).
   R, Ro: rotation or other 3×3 matrix; dc: (sin θ, cos θ).
   6 mul, 6 fma.
   Error <= u |result| + 1 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_product_drdrx_fused(const ksl_mat3x3_t *R, const double dc[2],
    ksl_mat3x3_t *Ro) {
  const double Ro_01a = KSL_MUL(R->m01, dc[1]), Ro_01 = fma(R->m02, dc[0], Ro_01a);
  const double Ro_02a = KSL_MUL(R->m02, dc[1]), Ro_02 = fma(-R->m01, dc[0], Ro_02a);
  const double Ro_11a = KSL_MUL(R->m11, dc[1]), Ro_11 = fma(R->m12, dc[0], Ro_11a);
  const double Ro_12a = KSL_MUL(R->m12, dc[1]), Ro_12 = fma(-R->m11, dc[0], Ro_12a);
  const double Ro_21a = KSL_MUL(R->m21, dc[1]), Ro_21 = fma(R->m22, dc[0], Ro_21a);
  const double Ro_22a = KSL_MUL(R->m22, dc[1]), Ro_22 = fma(-R->m21, dc[0], Ro_22a);
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
   6 mul, 6 fma.
   Error <= u |result| + (R: 1, t: 0) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_ddrx_fused(const ksl_SE3_t *D, const double dc[2], ksl_SE3_t *Do) {
  const double Do_01a = KSL_MUL(D->m01, dc[1]), Do_01 = fma(D->m02, dc[0], Do_01a);
  const double Do_02a = KSL_MUL(D->m02, dc[1]), Do_02 = fma(-D->m01, dc[0], Do_02a);
  const double Do_11a = KSL_MUL(D->m11, dc[1]), Do_11 = fma(D->m12, dc[0], Do_11a);
  const double Do_12a = KSL_MUL(D->m12, dc[1]), Do_12 = fma(-D->m11, dc[0], Do_12a);
  const double Do_21a = KSL_MUL(D->m21, dc[1]), Do_21 = fma(D->m22, dc[0], Do_21a);
  const double Do_22a = KSL_MUL(D->m22, dc[1]), Do_22 = fma(-D->m21, dc[0], Do_22a);
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
   3 fma.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_product_ddtx_fused(const ksl_SE3_t *D, const double k, ksl_SE3_t *Do) {
  const double Do_03 = fma(D->m00, k, D->m03);
  const double Do_13 = fma(D->m10, k, D->m13);
  const double Do_23 = fma(D->m20, k, D->m23);
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
static inline void ksl_product_drvtxinv_fused(const ksl_mat3x3_t *R, const double k,
    ksl_vec3_t *vo) {
  const double vo_0a = KSL_MUL(R->m00, k), vo_0 = -vo_0a;
  const double vo_1a = KSL_MUL(R->m10, k), vo_1 = -vo_1a;
  const double vo_2a = KSL_MUL(R->m20, k), vo_2 = -vo_2a;
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
}

/* Ro = R R_x(-θ), dc = (sin θ, cos θ).
   R, Ro: rotation or other 3×3 matrix; dc: (sin θ, cos θ).
   6 mul, 6 fma.
   Error <= u |result| + 1 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_product_drdrxinv_fused(const ksl_mat3x3_t *R, const double dc[2],
    ksl_mat3x3_t *Ro) {
  const double Ro_01a = KSL_MUL(R->m01, dc[1]), Ro_01 = fma(-R->m02, dc[0], Ro_01a);
  const double Ro_02a = KSL_MUL(R->m01, dc[0]), Ro_02 = fma(R->m02, dc[1], Ro_02a);
  const double Ro_11a = KSL_MUL(R->m11, dc[1]), Ro_11 = fma(-R->m12, dc[0], Ro_11a);
  const double Ro_12a = KSL_MUL(R->m11, dc[0]), Ro_12 = fma(R->m12, dc[1], Ro_12a);
  const double Ro_21a = KSL_MUL(R->m21, dc[1]), Ro_21 = fma(-R->m22, dc[0], Ro_21a);
  const double Ro_22a = KSL_MUL(R->m21, dc[0]), Ro_22 = fma(R->m22, dc[1], Ro_22a);
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
   6 mul, 6 fma.
   Error <= u |result| + (R: 1, t: 0) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_ddrxinv_fused(const ksl_SE3_t *D, const double dc[2],
    ksl_SE3_t *Do) {
  const double Do_01a = KSL_MUL(D->m01, dc[1]), Do_01 = fma(-D->m02, dc[0], Do_01a);
  const double Do_02a = KSL_MUL(D->m01, dc[0]), Do_02 = fma(D->m02, dc[1], Do_02a);
  const double Do_11a = KSL_MUL(D->m11, dc[1]), Do_11 = fma(-D->m12, dc[0], Do_11a);
  const double Do_12a = KSL_MUL(D->m11, dc[0]), Do_12 = fma(D->m12, dc[1], Do_12a);
  const double Do_21a = KSL_MUL(D->m21, dc[1]), Do_21 = fma(-D->m22, dc[0], Do_21a);
  const double Do_22a = KSL_MUL(D->m21, dc[0]), Do_22 = fma(D->m22, dc[1], Do_22a);
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
   3 fma.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_product_ddtxinv_fused(const ksl_SE3_t *D, const double k, ksl_SE3_t *Do) {
  const double Do_03 = fma(-D->m00, k, D->m03);
  const double Do_13 = fma(-D->m10, k, D->m13);
  const double Do_23 = fma(-D->m20, k, D->m23);
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
static inline void ksl_product_drvty_fused(const ksl_mat3x3_t *R, const double k, ksl_vec3_t *vo) {
  const double vo_0 = KSL_MUL(R->m01, k);
  const double vo_1 = KSL_MUL(R->m11, k);
  const double vo_2 = KSL_MUL(R->m21, k);
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
}

/* Ro = R R_y(θ), dc = (sin θ, cos θ).
   R, Ro: rotation or other 3×3 matrix; dc: (sin θ, cos θ).
   6 mul, 6 fma.
   Error <= u |result| + 1 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_product_drdry_fused(const ksl_mat3x3_t *R, const double dc[2],
    ksl_mat3x3_t *Ro) {
  const double Ro_00a = KSL_MUL(R->m00, dc[1]), Ro_00 = fma(-R->m02, dc[0], Ro_00a);
  const double Ro_02a = KSL_MUL(R->m00, dc[0]), Ro_02 = fma(R->m02, dc[1], Ro_02a);
  const double Ro_10a = KSL_MUL(R->m10, dc[1]), Ro_10 = fma(-R->m12, dc[0], Ro_10a);
  const double Ro_12a = KSL_MUL(R->m10, dc[0]), Ro_12 = fma(R->m12, dc[1], Ro_12a);
  const double Ro_20a = KSL_MUL(R->m20, dc[1]), Ro_20 = fma(-R->m22, dc[0], Ro_20a);
  const double Ro_22a = KSL_MUL(R->m20, dc[0]), Ro_22 = fma(R->m22, dc[1], Ro_22a);
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
   6 mul, 6 fma.
   Error <= u |result| + (R: 1, t: 0) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_ddry_fused(const ksl_SE3_t *D, const double dc[2], ksl_SE3_t *Do) {
  const double Do_00a = KSL_MUL(D->m00, dc[1]), Do_00 = fma(-D->m02, dc[0], Do_00a);
  const double Do_02a = KSL_MUL(D->m00, dc[0]), Do_02 = fma(D->m02, dc[1], Do_02a);
  const double Do_10a = KSL_MUL(D->m10, dc[1]), Do_10 = fma(-D->m12, dc[0], Do_10a);
  const double Do_12a = KSL_MUL(D->m10, dc[0]), Do_12 = fma(D->m12, dc[1], Do_12a);
  const double Do_20a = KSL_MUL(D->m20, dc[1]), Do_20 = fma(-D->m22, dc[0], Do_20a);
  const double Do_22a = KSL_MUL(D->m20, dc[0]), Do_22 = fma(D->m22, dc[1], Do_22a);
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
   3 fma.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_product_ddty_fused(const ksl_SE3_t *D, const double k, ksl_SE3_t *Do) {
  const double Do_03 = fma(D->m01, k, D->m03);
  const double Do_13 = fma(D->m11, k, D->m13);
  const double Do_23 = fma(D->m21, k, D->m23);
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
static inline void ksl_product_drvtyinv_fused(const ksl_mat3x3_t *R, const double k,
    ksl_vec3_t *vo) {
  const double vo_0a = KSL_MUL(R->m01, k), vo_0 = -vo_0a;
  const double vo_1a = KSL_MUL(R->m11, k), vo_1 = -vo_1a;
  const double vo_2a = KSL_MUL(R->m21, k), vo_2 = -vo_2a;
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
}

/* Ro = R R_y(-θ), dc = (sin θ, cos θ).
   R, Ro: rotation or other 3×3 matrix; dc: (sin θ, cos θ).
   6 mul, 6 fma.
   Error <= u |result| + 1 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_product_drdryinv_fused(const ksl_mat3x3_t *R, const double dc[2],
    ksl_mat3x3_t *Ro) {
  const double Ro_00a = KSL_MUL(R->m00, dc[1]), Ro_00 = fma(R->m02, dc[0], Ro_00a);
  const double Ro_02a = KSL_MUL(R->m02, dc[1]), Ro_02 = fma(-R->m00, dc[0], Ro_02a);
  const double Ro_10a = KSL_MUL(R->m10, dc[1]), Ro_10 = fma(R->m12, dc[0], Ro_10a);
  const double Ro_12a = KSL_MUL(R->m12, dc[1]), Ro_12 = fma(-R->m10, dc[0], Ro_12a);
  const double Ro_20a = KSL_MUL(R->m20, dc[1]), Ro_20 = fma(R->m22, dc[0], Ro_20a);
  const double Ro_22a = KSL_MUL(R->m22, dc[1]), Ro_22 = fma(-R->m20, dc[0], Ro_22a);
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
   6 mul, 6 fma.
   Error <= u |result| + (R: 1, t: 0) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_ddryinv_fused(const ksl_SE3_t *D, const double dc[2],
    ksl_SE3_t *Do) {
  const double Do_00a = KSL_MUL(D->m00, dc[1]), Do_00 = fma(D->m02, dc[0], Do_00a);
  const double Do_02a = KSL_MUL(D->m02, dc[1]), Do_02 = fma(-D->m00, dc[0], Do_02a);
  const double Do_10a = KSL_MUL(D->m10, dc[1]), Do_10 = fma(D->m12, dc[0], Do_10a);
  const double Do_12a = KSL_MUL(D->m12, dc[1]), Do_12 = fma(-D->m10, dc[0], Do_12a);
  const double Do_20a = KSL_MUL(D->m20, dc[1]), Do_20 = fma(D->m22, dc[0], Do_20a);
  const double Do_22a = KSL_MUL(D->m22, dc[1]), Do_22 = fma(-D->m20, dc[0], Do_22a);
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
   3 fma.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_product_ddtyinv_fused(const ksl_SE3_t *D, const double k, ksl_SE3_t *Do) {
  const double Do_03 = fma(-D->m01, k, D->m03);
  const double Do_13 = fma(-D->m11, k, D->m13);
  const double Do_23 = fma(-D->m21, k, D->m23);
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
static inline void ksl_product_drvtz_fused(const ksl_mat3x3_t *R, const double k, ksl_vec3_t *vo) {
  const double vo_0 = KSL_MUL(R->m02, k);
  const double vo_1 = KSL_MUL(R->m12, k);
  const double vo_2 = KSL_MUL(R->m22, k);
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
}

/* Ro = R R_z(θ), dc = (sin θ, cos θ).
   R, Ro: rotation or other 3×3 matrix; dc: (sin θ, cos θ).
   6 mul, 6 fma.
   Error <= u |result| + 1 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_product_drdrz_fused(const ksl_mat3x3_t *R, const double dc[2],
    ksl_mat3x3_t *Ro) {
  const double Ro_00a = KSL_MUL(R->m00, dc[1]), Ro_00 = fma(R->m01, dc[0], Ro_00a);
  const double Ro_01a = KSL_MUL(R->m01, dc[1]), Ro_01 = fma(-R->m00, dc[0], Ro_01a);
  const double Ro_10a = KSL_MUL(R->m10, dc[1]), Ro_10 = fma(R->m11, dc[0], Ro_10a);
  const double Ro_11a = KSL_MUL(R->m11, dc[1]), Ro_11 = fma(-R->m10, dc[0], Ro_11a);
  const double Ro_20a = KSL_MUL(R->m20, dc[1]), Ro_20 = fma(R->m21, dc[0], Ro_20a);
  const double Ro_21a = KSL_MUL(R->m21, dc[1]), Ro_21 = fma(-R->m20, dc[0], Ro_21a);
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
   6 mul, 6 fma.
   Error <= u |result| + (R: 1, t: 0) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_ddrz_fused(const ksl_SE3_t *D, const double dc[2], ksl_SE3_t *Do) {
  const double Do_00a = KSL_MUL(D->m00, dc[1]), Do_00 = fma(D->m01, dc[0], Do_00a);
  const double Do_01a = KSL_MUL(D->m01, dc[1]), Do_01 = fma(-D->m00, dc[0], Do_01a);
  const double Do_10a = KSL_MUL(D->m10, dc[1]), Do_10 = fma(D->m11, dc[0], Do_10a);
  const double Do_11a = KSL_MUL(D->m11, dc[1]), Do_11 = fma(-D->m10, dc[0], Do_11a);
  const double Do_20a = KSL_MUL(D->m20, dc[1]), Do_20 = fma(D->m21, dc[0], Do_20a);
  const double Do_21a = KSL_MUL(D->m21, dc[1]), Do_21 = fma(-D->m20, dc[0], Do_21a);
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
   3 fma.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_product_ddtz_fused(const ksl_SE3_t *D, const double k, ksl_SE3_t *Do) {
  const double Do_03 = fma(D->m02, k, D->m03);
  const double Do_13 = fma(D->m12, k, D->m13);
  const double Do_23 = fma(D->m22, k, D->m23);
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
static inline void ksl_product_drvtzinv_fused(const ksl_mat3x3_t *R, const double k,
    ksl_vec3_t *vo) {
  const double vo_0a = KSL_MUL(R->m02, k), vo_0 = -vo_0a;
  const double vo_1a = KSL_MUL(R->m12, k), vo_1 = -vo_1a;
  const double vo_2a = KSL_MUL(R->m22, k), vo_2 = -vo_2a;
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
}

/* Ro = R R_z(-θ), dc = (sin θ, cos θ).
   R, Ro: rotation or other 3×3 matrix; dc: (sin θ, cos θ).
   6 mul, 6 fma.
   Error <= u |result| + 1 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_product_drdrzinv_fused(const ksl_mat3x3_t *R, const double dc[2],
    ksl_mat3x3_t *Ro) {
  const double Ro_00a = KSL_MUL(R->m00, dc[1]), Ro_00 = fma(-R->m01, dc[0], Ro_00a);
  const double Ro_01a = KSL_MUL(R->m00, dc[0]), Ro_01 = fma(R->m01, dc[1], Ro_01a);
  const double Ro_10a = KSL_MUL(R->m10, dc[1]), Ro_10 = fma(-R->m11, dc[0], Ro_10a);
  const double Ro_11a = KSL_MUL(R->m10, dc[0]), Ro_11 = fma(R->m11, dc[1], Ro_11a);
  const double Ro_20a = KSL_MUL(R->m20, dc[1]), Ro_20 = fma(-R->m21, dc[0], Ro_20a);
  const double Ro_21a = KSL_MUL(R->m20, dc[0]), Ro_21 = fma(R->m21, dc[1], Ro_21a);
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
   6 mul, 6 fma.
   Error <= u |result| + (R: 1, t: 0) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_ddrzinv_fused(const ksl_SE3_t *D, const double dc[2],
    ksl_SE3_t *Do) {
  const double Do_00a = KSL_MUL(D->m00, dc[1]), Do_00 = fma(-D->m01, dc[0], Do_00a);
  const double Do_01a = KSL_MUL(D->m00, dc[0]), Do_01 = fma(D->m01, dc[1], Do_01a);
  const double Do_10a = KSL_MUL(D->m10, dc[1]), Do_10 = fma(-D->m11, dc[0], Do_10a);
  const double Do_11a = KSL_MUL(D->m10, dc[0]), Do_11 = fma(D->m11, dc[1], Do_11a);
  const double Do_20a = KSL_MUL(D->m20, dc[1]), Do_20 = fma(-D->m21, dc[0], Do_20a);
  const double Do_21a = KSL_MUL(D->m20, dc[0]), Do_21 = fma(D->m21, dc[1], Do_21a);
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
   3 fma.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_product_ddtzinv_fused(const ksl_SE3_t *D, const double k, ksl_SE3_t *Do) {
  const double Do_03 = fma(-D->m02, k, D->m03);
  const double Do_13 = fma(-D->m12, k, D->m13);
  const double Do_23 = fma(-D->m22, k, D->m23);
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
   3 mul, 6 fma.
   Error <= u |result| + 2 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_product_drvf_fused(const ksl_mat3x3f_t *R, const ksl_vec3f_t *v,
    ksl_vec3f_t *vo) {
  const float vo_0a = KSL_MULF(R->m00, v->x), vo_0c = fmaf(R->m01, v->y, vo_0a),
      vo_0 = fmaf(R->m02, v->z, vo_0c);
  const float vo_1a = KSL_MULF(R->m10, v->x), vo_1c = fmaf(R->m11, v->y, vo_1a),
      vo_1 = fmaf(R->m12, v->z, vo_1c);
  const float vo_2a = KSL_MULF(R->m20, v->x), vo_2c = fmaf(R->m21, v->y, vo_2a),
      vo_2 = fmaf(R->m22, v->z, vo_2c);
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
}

/* vo = R (-v).
   R: rotation or other 3×3 matrix; v, vo: vector.
   3 mul, 6 fma, 3 neg.
   Error <= u |result| + 2 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_product_drvinvf_fused(const ksl_mat3x3f_t *R, const ksl_vec3f_t *v,
    ksl_vec3f_t *vo) {
  const float vo_0a = KSL_MULF(R->m00, v->x), vo_0c_lead = -vo_0a,
      vo_0c = fmaf(-R->m01, v->y, vo_0c_lead), vo_0 = fmaf(-R->m02, v->z, vo_0c);
  const float vo_1a = KSL_MULF(R->m10, v->x), vo_1c_lead = -vo_1a,
      vo_1c = fmaf(-R->m11, v->y, vo_1c_lead), vo_1 = fmaf(-R->m12, v->z, vo_1c);
  const float vo_2a = KSL_MULF(R->m20, v->x), vo_2c_lead = -vo_2a,
      vo_2c = fmaf(-R->m21, v->y, vo_2c_lead), vo_2 = fmaf(-R->m22, v->z, vo_2c);
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
}

/* vo = R^T v.
   R: rotation or other 3×3 matrix; v, vo: vector.
   3 mul, 6 fma.
   Error <= u |result| + 2 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_product_drinvvf_fused(const ksl_mat3x3f_t *R, const ksl_vec3f_t *v,
    ksl_vec3f_t *vo) {
  const float vo_0a = KSL_MULF(R->m00, v->x), vo_0c = fmaf(R->m10, v->y, vo_0a),
      vo_0 = fmaf(R->m20, v->z, vo_0c);
  const float vo_1a = KSL_MULF(R->m01, v->x), vo_1c = fmaf(R->m11, v->y, vo_1a),
      vo_1 = fmaf(R->m21, v->z, vo_1c);
  const float vo_2a = KSL_MULF(R->m02, v->x), vo_2c = fmaf(R->m12, v->y, vo_2a),
      vo_2 = fmaf(R->m22, v->z, vo_2c);
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
}

/* vo = R^T (-v).
   R: rotation or other 3×3 matrix; v, vo: vector.
   3 mul, 6 fma, 3 neg.
   Error <= u |result| + 2 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_product_drinvvinvf_fused(const ksl_mat3x3f_t *R, const ksl_vec3f_t *v,
    ksl_vec3f_t *vo) {
  const float vo_0a = KSL_MULF(R->m00, v->x), vo_0c_lead = -vo_0a,
      vo_0c = fmaf(-R->m10, v->y, vo_0c_lead), vo_0 = fmaf(-R->m20, v->z, vo_0c);
  const float vo_1a = KSL_MULF(R->m01, v->x), vo_1c_lead = -vo_1a,
      vo_1c = fmaf(-R->m11, v->y, vo_1c_lead), vo_1 = fmaf(-R->m21, v->z, vo_1c);
  const float vo_2a = KSL_MULF(R->m02, v->x), vo_2c_lead = -vo_2a,
      vo_2c = fmaf(-R->m12, v->y, vo_2c_lead), vo_2 = fmaf(-R->m22, v->z, vo_2c);
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
}

/* vo = R v + t.
   D: displacement [R | t], R rotation, t in m; v, vo: vector.
   3 mul, 3 add, 6 fma.
   Error <= u |result| + 3 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_product_dvf_fused(const ksl_SE3f_t *D, const ksl_vec3f_t *v,
    ksl_vec3f_t *vo) {
  const float vo_0a = KSL_MULF(D->m00, v->x), vo_0c = fmaf(D->m01, v->y, vo_0a),
      vo_0e = fmaf(D->m02, v->z, vo_0c), vo_0 = vo_0e + D->m03;
  const float vo_1a = KSL_MULF(D->m10, v->x), vo_1c = fmaf(D->m11, v->y, vo_1a),
      vo_1e = fmaf(D->m12, v->z, vo_1c), vo_1 = vo_1e + D->m13;
  const float vo_2a = KSL_MULF(D->m20, v->x), vo_2c = fmaf(D->m21, v->y, vo_2a),
      vo_2e = fmaf(D->m22, v->z, vo_2c), vo_2 = vo_2e + D->m23;
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
}

/* vo = R^T (v - t).
   D: displacement [R | t], R rotation, t in m; v, vo: vector.
   3 mul, 3 add, 6 fma.
   Error <= u |result| + 3 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_product_dinvvf_fused(const ksl_SE3f_t *D, const ksl_vec3f_t *v,
    ksl_vec3f_t *vo) {
  const float p_0 = v->x - D->m03;
  const float p_1 = v->y - D->m13;
  const float p_2 = v->z - D->m23;
  const float vo_0a = KSL_MULF(D->m00, p_0), vo_0c = fmaf(D->m10, p_1, vo_0a),
      vo_0 = fmaf(D->m20, p_2, vo_0c);
  const float vo_1a = KSL_MULF(D->m01, p_0), vo_1c = fmaf(D->m11, p_1, vo_1a),
      vo_1 = fmaf(D->m21, p_2, vo_1c);
  const float vo_2a = KSL_MULF(D->m02, p_0), vo_2c = fmaf(D->m12, p_1, vo_2a),
      vo_2 = fmaf(D->m22, p_2, vo_2c);
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
}

/* Ro = R1 R2.
   R1, R2, Ro: rotation or other 3×3 matrix.
   9 mul, 18 fma.
   Error <= u |result| + 2 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_product_drdrf_fused(const ksl_mat3x3f_t *R1, const ksl_mat3x3f_t *R2,
    ksl_mat3x3f_t *Ro) {
  const float Ro_00a = KSL_MULF(R1->m00, R2->m00), Ro_00c = fmaf(R1->m01, R2->m10, Ro_00a),
      Ro_00 = fmaf(R1->m02, R2->m20, Ro_00c);
  const float Ro_01a = KSL_MULF(R1->m00, R2->m01), Ro_01c = fmaf(R1->m01, R2->m11, Ro_01a),
      Ro_01 = fmaf(R1->m02, R2->m21, Ro_01c);
  const float Ro_02a = KSL_MULF(R1->m00, R2->m02), Ro_02c = fmaf(R1->m01, R2->m12, Ro_02a),
      Ro_02 = fmaf(R1->m02, R2->m22, Ro_02c);
  const float Ro_10a = KSL_MULF(R1->m10, R2->m00), Ro_10c = fmaf(R1->m11, R2->m10, Ro_10a),
      Ro_10 = fmaf(R1->m12, R2->m20, Ro_10c);
  const float Ro_11a = KSL_MULF(R1->m10, R2->m01), Ro_11c = fmaf(R1->m11, R2->m11, Ro_11a),
      Ro_11 = fmaf(R1->m12, R2->m21, Ro_11c);
  const float Ro_12a = KSL_MULF(R1->m10, R2->m02), Ro_12c = fmaf(R1->m11, R2->m12, Ro_12a),
      Ro_12 = fmaf(R1->m12, R2->m22, Ro_12c);
  const float Ro_20a = KSL_MULF(R1->m20, R2->m00), Ro_20c = fmaf(R1->m21, R2->m10, Ro_20a),
      Ro_20 = fmaf(R1->m22, R2->m20, Ro_20c);
  const float Ro_21a = KSL_MULF(R1->m20, R2->m01), Ro_21c = fmaf(R1->m21, R2->m11, Ro_21a),
      Ro_21 = fmaf(R1->m22, R2->m21, Ro_21c);
  const float Ro_22a = KSL_MULF(R1->m20, R2->m02), Ro_22c = fmaf(R1->m21, R2->m12, Ro_22a),
      Ro_22 = fmaf(R1->m22, R2->m22, Ro_22c);
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
   9 mul, 18 fma.
   Error <= u |result| + 2 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_product_drdrinvf_fused(const ksl_mat3x3f_t *R1, const ksl_mat3x3f_t *R2,
    ksl_mat3x3f_t *Ro) {
  const float Ro_00a = KSL_MULF(R1->m00, R2->m00), Ro_00c = fmaf(R1->m01, R2->m01, Ro_00a),
      Ro_00 = fmaf(R1->m02, R2->m02, Ro_00c);
  const float Ro_01a = KSL_MULF(R1->m00, R2->m10), Ro_01c = fmaf(R1->m01, R2->m11, Ro_01a),
      Ro_01 = fmaf(R1->m02, R2->m12, Ro_01c);
  const float Ro_02a = KSL_MULF(R1->m00, R2->m20), Ro_02c = fmaf(R1->m01, R2->m21, Ro_02a),
      Ro_02 = fmaf(R1->m02, R2->m22, Ro_02c);
  const float Ro_10a = KSL_MULF(R1->m10, R2->m00), Ro_10c = fmaf(R1->m11, R2->m01, Ro_10a),
      Ro_10 = fmaf(R1->m12, R2->m02, Ro_10c);
  const float Ro_11a = KSL_MULF(R1->m10, R2->m10), Ro_11c = fmaf(R1->m11, R2->m11, Ro_11a),
      Ro_11 = fmaf(R1->m12, R2->m12, Ro_11c);
  const float Ro_12a = KSL_MULF(R1->m10, R2->m20), Ro_12c = fmaf(R1->m11, R2->m21, Ro_12a),
      Ro_12 = fmaf(R1->m12, R2->m22, Ro_12c);
  const float Ro_20a = KSL_MULF(R1->m20, R2->m00), Ro_20c = fmaf(R1->m21, R2->m01, Ro_20a),
      Ro_20 = fmaf(R1->m22, R2->m02, Ro_20c);
  const float Ro_21a = KSL_MULF(R1->m20, R2->m10), Ro_21c = fmaf(R1->m21, R2->m11, Ro_21a),
      Ro_21 = fmaf(R1->m22, R2->m12, Ro_21c);
  const float Ro_22a = KSL_MULF(R1->m20, R2->m20), Ro_22c = fmaf(R1->m21, R2->m21, Ro_22a),
      Ro_22 = fmaf(R1->m22, R2->m22, Ro_22c);
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
   9 mul, 18 fma.
   Error <= u |result| + 2 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_product_drinvdrf_fused(const ksl_mat3x3f_t *R1, const ksl_mat3x3f_t *R2,
    ksl_mat3x3f_t *Ro) {
  const float Ro_00a = KSL_MULF(R1->m00, R2->m00), Ro_00c = fmaf(R1->m10, R2->m10, Ro_00a),
      Ro_00 = fmaf(R1->m20, R2->m20, Ro_00c);
  const float Ro_01a = KSL_MULF(R1->m00, R2->m01), Ro_01c = fmaf(R1->m10, R2->m11, Ro_01a),
      Ro_01 = fmaf(R1->m20, R2->m21, Ro_01c);
  const float Ro_02a = KSL_MULF(R1->m00, R2->m02), Ro_02c = fmaf(R1->m10, R2->m12, Ro_02a),
      Ro_02 = fmaf(R1->m20, R2->m22, Ro_02c);
  const float Ro_10a = KSL_MULF(R1->m01, R2->m00), Ro_10c = fmaf(R1->m11, R2->m10, Ro_10a),
      Ro_10 = fmaf(R1->m21, R2->m20, Ro_10c);
  const float Ro_11a = KSL_MULF(R1->m01, R2->m01), Ro_11c = fmaf(R1->m11, R2->m11, Ro_11a),
      Ro_11 = fmaf(R1->m21, R2->m21, Ro_11c);
  const float Ro_12a = KSL_MULF(R1->m01, R2->m02), Ro_12c = fmaf(R1->m11, R2->m12, Ro_12a),
      Ro_12 = fmaf(R1->m21, R2->m22, Ro_12c);
  const float Ro_20a = KSL_MULF(R1->m02, R2->m00), Ro_20c = fmaf(R1->m12, R2->m10, Ro_20a),
      Ro_20 = fmaf(R1->m22, R2->m20, Ro_20c);
  const float Ro_21a = KSL_MULF(R1->m02, R2->m01), Ro_21c = fmaf(R1->m12, R2->m11, Ro_21a),
      Ro_21 = fmaf(R1->m22, R2->m21, Ro_21c);
  const float Ro_22a = KSL_MULF(R1->m02, R2->m02), Ro_22c = fmaf(R1->m12, R2->m12, Ro_22a),
      Ro_22 = fmaf(R1->m22, R2->m22, Ro_22c);
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
   12 mul, 3 add, 24 fma.
   Error <= u |result| + (R: 2, t: 3) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_ddf_fused(const ksl_SE3f_t *D1, const ksl_SE3f_t *D2,
    ksl_SE3f_t *Do) {
  const float Do_00a = KSL_MULF(D1->m00, D2->m00), Do_00c = fmaf(D1->m01, D2->m10, Do_00a),
      Do_00 = fmaf(D1->m02, D2->m20, Do_00c);
  const float Do_01a = KSL_MULF(D1->m00, D2->m01), Do_01c = fmaf(D1->m01, D2->m11, Do_01a),
      Do_01 = fmaf(D1->m02, D2->m21, Do_01c);
  const float Do_02a = KSL_MULF(D1->m00, D2->m02), Do_02c = fmaf(D1->m01, D2->m12, Do_02a),
      Do_02 = fmaf(D1->m02, D2->m22, Do_02c);
  const float Do_03a = KSL_MULF(D1->m00, D2->m03), Do_03c = fmaf(D1->m01, D2->m13, Do_03a),
      Do_03e = fmaf(D1->m02, D2->m23, Do_03c), Do_03 = Do_03e + D1->m03;
  const float Do_10a = KSL_MULF(D1->m10, D2->m00), Do_10c = fmaf(D1->m11, D2->m10, Do_10a),
      Do_10 = fmaf(D1->m12, D2->m20, Do_10c);
  const float Do_11a = KSL_MULF(D1->m10, D2->m01), Do_11c = fmaf(D1->m11, D2->m11, Do_11a),
      Do_11 = fmaf(D1->m12, D2->m21, Do_11c);
  const float Do_12a = KSL_MULF(D1->m10, D2->m02), Do_12c = fmaf(D1->m11, D2->m12, Do_12a),
      Do_12 = fmaf(D1->m12, D2->m22, Do_12c);
  const float Do_13a = KSL_MULF(D1->m10, D2->m03), Do_13c = fmaf(D1->m11, D2->m13, Do_13a),
      Do_13e = fmaf(D1->m12, D2->m23, Do_13c), Do_13 = Do_13e + D1->m13;
  const float Do_20a = KSL_MULF(D1->m20, D2->m00), Do_20c = fmaf(D1->m21, D2->m10, Do_20a),
      Do_20 = fmaf(D1->m22, D2->m20, Do_20c);
  const float Do_21a = KSL_MULF(D1->m20, D2->m01), Do_21c = fmaf(D1->m21, D2->m11, Do_21a),
      Do_21 = fmaf(D1->m22, D2->m21, Do_21c);
  const float Do_22a = KSL_MULF(D1->m20, D2->m02), Do_22c = fmaf(D1->m21, D2->m12, Do_22a),
      Do_22 = fmaf(D1->m22, D2->m22, Do_22c);
  const float Do_23a = KSL_MULF(D1->m20, D2->m03), Do_23c = fmaf(D1->m21, D2->m13, Do_23a),
      Do_23e = fmaf(D1->m22, D2->m23, Do_23c), Do_23 = Do_23e + D1->m23;
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
   12 mul, 3 add, 24 fma.
   Error <= u |result| + (R: 2, t: 6) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_ddinvf_fused(const ksl_SE3f_t *D1, const ksl_SE3f_t *D2,
    ksl_SE3f_t *Do) {
  const float R_0a = KSL_MULF(D1->m00, D2->m00), R_0c = fmaf(D1->m01, D2->m01, R_0a),
      R_0 = fmaf(D1->m02, D2->m02, R_0c);
  const float R_1a = KSL_MULF(D1->m00, D2->m10), R_1c = fmaf(D1->m01, D2->m11, R_1a),
      R_1 = fmaf(D1->m02, D2->m12, R_1c);
  const float R_2a = KSL_MULF(D1->m00, D2->m20), R_2c = fmaf(D1->m01, D2->m21, R_2a),
      R_2 = fmaf(D1->m02, D2->m22, R_2c);
  const float R_3a = KSL_MULF(D1->m10, D2->m00), R_3c = fmaf(D1->m11, D2->m01, R_3a),
      R_3 = fmaf(D1->m12, D2->m02, R_3c);
  const float R_4a = KSL_MULF(D1->m10, D2->m10), R_4c = fmaf(D1->m11, D2->m11, R_4a),
      R_4 = fmaf(D1->m12, D2->m12, R_4c);
  const float R_5a = KSL_MULF(D1->m10, D2->m20), R_5c = fmaf(D1->m11, D2->m21, R_5a),
      R_5 = fmaf(D1->m12, D2->m22, R_5c);
  const float R_6a = KSL_MULF(D1->m20, D2->m00), R_6c = fmaf(D1->m21, D2->m01, R_6a),
      R_6 = fmaf(D1->m22, D2->m02, R_6c);
  const float R_7a = KSL_MULF(D1->m20, D2->m10), R_7c = fmaf(D1->m21, D2->m11, R_7a),
      R_7 = fmaf(D1->m22, D2->m12, R_7c);
  const float R_8a = KSL_MULF(D1->m20, D2->m20), R_8c = fmaf(D1->m21, D2->m21, R_8a),
      R_8 = fmaf(D1->m22, D2->m22, R_8c);
  const float Do_03a = KSL_MULF(D2->m03, R_0), Do_03c = fmaf(D2->m13, R_1, Do_03a),
      Do_03e = fmaf(D2->m23, R_2, Do_03c), Do_03 = D1->m03 - Do_03e;
  const float Do_13a = KSL_MULF(D2->m03, R_3), Do_13c = fmaf(D2->m13, R_4, Do_13a),
      Do_13e = fmaf(D2->m23, R_5, Do_13c), Do_13 = D1->m13 - Do_13e;
  const float Do_23a = KSL_MULF(D2->m03, R_6), Do_23c = fmaf(D2->m13, R_7, Do_23a),
      Do_23e = fmaf(D2->m23, R_8, Do_23c), Do_23 = D1->m23 - Do_23e;
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
   12 mul, 3 add, 24 fma.
   Error <= u |result| + (R: 2, t: 3) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_dinvdf_fused(const ksl_SE3f_t *D1, const ksl_SE3f_t *D2,
    ksl_SE3f_t *Do) {
  const float p_0 = D2->m03 - D1->m03;
  const float p_1 = D2->m13 - D1->m13;
  const float p_2 = D2->m23 - D1->m23;
  const float Do_00a = KSL_MULF(D1->m00, D2->m00), Do_00c = fmaf(D1->m10, D2->m10, Do_00a),
      Do_00 = fmaf(D1->m20, D2->m20, Do_00c);
  const float Do_01a = KSL_MULF(D1->m00, D2->m01), Do_01c = fmaf(D1->m10, D2->m11, Do_01a),
      Do_01 = fmaf(D1->m20, D2->m21, Do_01c);
  const float Do_02a = KSL_MULF(D1->m00, D2->m02), Do_02c = fmaf(D1->m10, D2->m12, Do_02a),
      Do_02 = fmaf(D1->m20, D2->m22, Do_02c);
  const float Do_03a = KSL_MULF(D1->m00, p_0), Do_03c = fmaf(D1->m10, p_1, Do_03a),
      Do_03 = fmaf(D1->m20, p_2, Do_03c);
  const float Do_10a = KSL_MULF(D1->m01, D2->m00), Do_10c = fmaf(D1->m11, D2->m10, Do_10a),
      Do_10 = fmaf(D1->m21, D2->m20, Do_10c);
  const float Do_11a = KSL_MULF(D1->m01, D2->m01), Do_11c = fmaf(D1->m11, D2->m11, Do_11a),
      Do_11 = fmaf(D1->m21, D2->m21, Do_11c);
  const float Do_12a = KSL_MULF(D1->m01, D2->m02), Do_12c = fmaf(D1->m11, D2->m12, Do_12a),
      Do_12 = fmaf(D1->m21, D2->m22, Do_12c);
  const float Do_13a = KSL_MULF(D1->m01, p_0), Do_13c = fmaf(D1->m11, p_1, Do_13a),
      Do_13 = fmaf(D1->m21, p_2, Do_13c);
  const float Do_20a = KSL_MULF(D1->m02, D2->m00), Do_20c = fmaf(D1->m12, D2->m10, Do_20a),
      Do_20 = fmaf(D1->m22, D2->m20, Do_20c);
  const float Do_21a = KSL_MULF(D1->m02, D2->m01), Do_21c = fmaf(D1->m12, D2->m11, Do_21a),
      Do_21 = fmaf(D1->m22, D2->m21, Do_21c);
  const float Do_22a = KSL_MULF(D1->m02, D2->m02), Do_22c = fmaf(D1->m12, D2->m12, Do_22a),
      Do_22 = fmaf(D1->m22, D2->m22, Do_22c);
  const float Do_23a = KSL_MULF(D1->m02, p_0), Do_23c = fmaf(D1->m12, p_1, Do_23a),
      Do_23 = fmaf(D1->m22, p_2, Do_23c);
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
   9 mul, 18 fma.
   Error <= u |result| + (R: 2, t: 0) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_ddrf_fused(const ksl_SE3f_t *D, const ksl_mat3x3f_t *R,
    ksl_SE3f_t *Do) {
  const float Do_00a = KSL_MULF(D->m00, R->m00), Do_00c = fmaf(D->m01, R->m10, Do_00a),
      Do_00 = fmaf(D->m02, R->m20, Do_00c);
  const float Do_01a = KSL_MULF(D->m00, R->m01), Do_01c = fmaf(D->m01, R->m11, Do_01a),
      Do_01 = fmaf(D->m02, R->m21, Do_01c);
  const float Do_02a = KSL_MULF(D->m00, R->m02), Do_02c = fmaf(D->m01, R->m12, Do_02a),
      Do_02 = fmaf(D->m02, R->m22, Do_02c);
  const float Do_10a = KSL_MULF(D->m10, R->m00), Do_10c = fmaf(D->m11, R->m10, Do_10a),
      Do_10 = fmaf(D->m12, R->m20, Do_10c);
  const float Do_11a = KSL_MULF(D->m10, R->m01), Do_11c = fmaf(D->m11, R->m11, Do_11a),
      Do_11 = fmaf(D->m12, R->m21, Do_11c);
  const float Do_12a = KSL_MULF(D->m10, R->m02), Do_12c = fmaf(D->m11, R->m12, Do_12a),
      Do_12 = fmaf(D->m12, R->m22, Do_12c);
  const float Do_20a = KSL_MULF(D->m20, R->m00), Do_20c = fmaf(D->m21, R->m10, Do_20a),
      Do_20 = fmaf(D->m22, R->m20, Do_20c);
  const float Do_21a = KSL_MULF(D->m20, R->m01), Do_21c = fmaf(D->m21, R->m11, Do_21a),
      Do_21 = fmaf(D->m22, R->m21, Do_21c);
  const float Do_22a = KSL_MULF(D->m20, R->m02), Do_22c = fmaf(D->m21, R->m12, Do_22a),
      Do_22 = fmaf(D->m22, R->m22, Do_22c);
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
   9 mul, 18 fma.
   Error <= u |result| + (R: 2, t: 0) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_ddrinvf_fused(const ksl_SE3f_t *D, const ksl_mat3x3f_t *R,
    ksl_SE3f_t *Do) {
  const float Do_00a = KSL_MULF(D->m00, R->m00), Do_00c = fmaf(D->m01, R->m01, Do_00a),
      Do_00 = fmaf(D->m02, R->m02, Do_00c);
  const float Do_01a = KSL_MULF(D->m00, R->m10), Do_01c = fmaf(D->m01, R->m11, Do_01a),
      Do_01 = fmaf(D->m02, R->m12, Do_01c);
  const float Do_02a = KSL_MULF(D->m00, R->m20), Do_02c = fmaf(D->m01, R->m21, Do_02a),
      Do_02 = fmaf(D->m02, R->m22, Do_02c);
  const float Do_10a = KSL_MULF(D->m10, R->m00), Do_10c = fmaf(D->m11, R->m01, Do_10a),
      Do_10 = fmaf(D->m12, R->m02, Do_10c);
  const float Do_11a = KSL_MULF(D->m10, R->m10), Do_11c = fmaf(D->m11, R->m11, Do_11a),
      Do_11 = fmaf(D->m12, R->m12, Do_11c);
  const float Do_12a = KSL_MULF(D->m10, R->m20), Do_12c = fmaf(D->m11, R->m21, Do_12a),
      Do_12 = fmaf(D->m12, R->m22, Do_12c);
  const float Do_20a = KSL_MULF(D->m20, R->m00), Do_20c = fmaf(D->m21, R->m01, Do_20a),
      Do_20 = fmaf(D->m22, R->m02, Do_20c);
  const float Do_21a = KSL_MULF(D->m20, R->m10), Do_21c = fmaf(D->m21, R->m11, Do_21a),
      Do_21 = fmaf(D->m22, R->m12, Do_21c);
  const float Do_22a = KSL_MULF(D->m20, R->m20), Do_22c = fmaf(D->m21, R->m21, Do_22a),
      Do_22 = fmaf(D->m22, R->m22, Do_22c);
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
   3 mul, 3 add, 6 fma.
   Error <= u |result| + (R: 0, t: 3) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_ddtf_fused(const ksl_SE3f_t *D, const ksl_vec3f_t *t,
    ksl_SE3f_t *Do) {
  const float Do_03a = KSL_MULF(D->m00, t->x), Do_03c = fmaf(D->m01, t->y, Do_03a),
      Do_03e = fmaf(D->m02, t->z, Do_03c), Do_03 = Do_03e + D->m03;
  const float Do_13a = KSL_MULF(D->m10, t->x), Do_13c = fmaf(D->m11, t->y, Do_13a),
      Do_13e = fmaf(D->m12, t->z, Do_13c), Do_13 = Do_13e + D->m13;
  const float Do_23a = KSL_MULF(D->m20, t->x), Do_23c = fmaf(D->m21, t->y, Do_23a),
      Do_23e = fmaf(D->m22, t->z, Do_23c), Do_23 = Do_23e + D->m23;
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
   3 mul, 3 add, 6 fma.
   Error <= u |result| + (R: 0, t: 3) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_ddtinvf_fused(const ksl_SE3f_t *D, const ksl_vec3f_t *t,
    ksl_SE3f_t *Do) {
  const float Do_03a = KSL_MULF(D->m00, t->x), Do_03c = fmaf(D->m01, t->y, Do_03a),
      Do_03e = fmaf(D->m02, t->z, Do_03c), Do_03 = D->m03 - Do_03e;
  const float Do_13a = KSL_MULF(D->m10, t->x), Do_13c = fmaf(D->m11, t->y, Do_13a),
      Do_13e = fmaf(D->m12, t->z, Do_13c), Do_13 = D->m13 - Do_13e;
  const float Do_23a = KSL_MULF(D->m20, t->x), Do_23c = fmaf(D->m21, t->y, Do_23a),
      Do_23e = fmaf(D->m22, t->z, Do_23c), Do_23 = D->m23 - Do_23e;
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
   3 mul, 3 add, 6 fma.
   Error <= u |result| + (R: 0, t: 3) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_dinvdtf_fused(const ksl_SE3f_t *D, const ksl_vec3f_t *t,
    ksl_SE3f_t *Do) {
  const float p_0 = t->x - D->m03;
  const float p_1 = t->y - D->m13;
  const float p_2 = t->z - D->m23;
  const float Do_03a = KSL_MULF(D->m00, p_0), Do_03c = fmaf(D->m10, p_1, Do_03a),
      Do_03 = fmaf(D->m20, p_2, Do_03c);
  const float Do_13a = KSL_MULF(D->m01, p_0), Do_13c = fmaf(D->m11, p_1, Do_13a),
      Do_13 = fmaf(D->m21, p_2, Do_13c);
  const float Do_23a = KSL_MULF(D->m02, p_0), Do_23c = fmaf(D->m12, p_1, Do_23a),
      Do_23 = fmaf(D->m22, p_2, Do_23c);
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
static inline void ksl_product_drvtxf_fused(const ksl_mat3x3f_t *R, const float k,
    ksl_vec3f_t *vo) {
  const float vo_0 = KSL_MULF(R->m00, k);
  const float vo_1 = KSL_MULF(R->m10, k);
  const float vo_2 = KSL_MULF(R->m20, k);
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
}

/* Ro = R R_x(θ), dc = (sin θ, cos θ).
   R, Ro: rotation or other 3×3 matrix; dc: (sin θ, cos θ).
   6 mul, 6 fma.
   Error <= u |result| + 1 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_product_drdrxf_fused(const ksl_mat3x3f_t *R, const float dc[2],
    ksl_mat3x3f_t *Ro) {
  const float Ro_01a = KSL_MULF(R->m01, dc[1]), Ro_01 = fmaf(R->m02, dc[0], Ro_01a);
  const float Ro_02a = KSL_MULF(R->m02, dc[1]), Ro_02 = fmaf(-R->m01, dc[0], Ro_02a);
  const float Ro_11a = KSL_MULF(R->m11, dc[1]), Ro_11 = fmaf(R->m12, dc[0], Ro_11a);
  const float Ro_12a = KSL_MULF(R->m12, dc[1]), Ro_12 = fmaf(-R->m11, dc[0], Ro_12a);
  const float Ro_21a = KSL_MULF(R->m21, dc[1]), Ro_21 = fmaf(R->m22, dc[0], Ro_21a);
  const float Ro_22a = KSL_MULF(R->m22, dc[1]), Ro_22 = fmaf(-R->m21, dc[0], Ro_22a);
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
   6 mul, 6 fma.
   Error <= u |result| + (R: 1, t: 0) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_ddrxf_fused(const ksl_SE3f_t *D, const float dc[2], ksl_SE3f_t *Do) {
  const float Do_01a = KSL_MULF(D->m01, dc[1]), Do_01 = fmaf(D->m02, dc[0], Do_01a);
  const float Do_02a = KSL_MULF(D->m02, dc[1]), Do_02 = fmaf(-D->m01, dc[0], Do_02a);
  const float Do_11a = KSL_MULF(D->m11, dc[1]), Do_11 = fmaf(D->m12, dc[0], Do_11a);
  const float Do_12a = KSL_MULF(D->m12, dc[1]), Do_12 = fmaf(-D->m11, dc[0], Do_12a);
  const float Do_21a = KSL_MULF(D->m21, dc[1]), Do_21 = fmaf(D->m22, dc[0], Do_21a);
  const float Do_22a = KSL_MULF(D->m22, dc[1]), Do_22 = fmaf(-D->m21, dc[0], Do_22a);
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
   3 fma.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_product_ddtxf_fused(const ksl_SE3f_t *D, const float k, ksl_SE3f_t *Do) {
  const float Do_03 = fmaf(D->m00, k, D->m03);
  const float Do_13 = fmaf(D->m10, k, D->m13);
  const float Do_23 = fmaf(D->m20, k, D->m23);
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
static inline void ksl_product_drvtxinvf_fused(const ksl_mat3x3f_t *R, const float k,
    ksl_vec3f_t *vo) {
  const float vo_0a = KSL_MULF(R->m00, k), vo_0 = -vo_0a;
  const float vo_1a = KSL_MULF(R->m10, k), vo_1 = -vo_1a;
  const float vo_2a = KSL_MULF(R->m20, k), vo_2 = -vo_2a;
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
}

/* Ro = R R_x(-θ), dc = (sin θ, cos θ).
   R, Ro: rotation or other 3×3 matrix; dc: (sin θ, cos θ).
   6 mul, 6 fma.
   Error <= u |result| + 1 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_product_drdrxinvf_fused(const ksl_mat3x3f_t *R, const float dc[2],
    ksl_mat3x3f_t *Ro) {
  const float Ro_01a = KSL_MULF(R->m01, dc[1]), Ro_01 = fmaf(-R->m02, dc[0], Ro_01a);
  const float Ro_02a = KSL_MULF(R->m01, dc[0]), Ro_02 = fmaf(R->m02, dc[1], Ro_02a);
  const float Ro_11a = KSL_MULF(R->m11, dc[1]), Ro_11 = fmaf(-R->m12, dc[0], Ro_11a);
  const float Ro_12a = KSL_MULF(R->m11, dc[0]), Ro_12 = fmaf(R->m12, dc[1], Ro_12a);
  const float Ro_21a = KSL_MULF(R->m21, dc[1]), Ro_21 = fmaf(-R->m22, dc[0], Ro_21a);
  const float Ro_22a = KSL_MULF(R->m21, dc[0]), Ro_22 = fmaf(R->m22, dc[1], Ro_22a);
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
   6 mul, 6 fma.
   Error <= u |result| + (R: 1, t: 0) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_ddrxinvf_fused(const ksl_SE3f_t *D, const float dc[2],
    ksl_SE3f_t *Do) {
  const float Do_01a = KSL_MULF(D->m01, dc[1]), Do_01 = fmaf(-D->m02, dc[0], Do_01a);
  const float Do_02a = KSL_MULF(D->m01, dc[0]), Do_02 = fmaf(D->m02, dc[1], Do_02a);
  const float Do_11a = KSL_MULF(D->m11, dc[1]), Do_11 = fmaf(-D->m12, dc[0], Do_11a);
  const float Do_12a = KSL_MULF(D->m11, dc[0]), Do_12 = fmaf(D->m12, dc[1], Do_12a);
  const float Do_21a = KSL_MULF(D->m21, dc[1]), Do_21 = fmaf(-D->m22, dc[0], Do_21a);
  const float Do_22a = KSL_MULF(D->m21, dc[0]), Do_22 = fmaf(D->m22, dc[1], Do_22a);
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
   3 fma.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_product_ddtxinvf_fused(const ksl_SE3f_t *D, const float k, ksl_SE3f_t *Do) {
  const float Do_03 = fmaf(-D->m00, k, D->m03);
  const float Do_13 = fmaf(-D->m10, k, D->m13);
  const float Do_23 = fmaf(-D->m20, k, D->m23);
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
static inline void ksl_product_drvtyf_fused(const ksl_mat3x3f_t *R, const float k,
    ksl_vec3f_t *vo) {
  const float vo_0 = KSL_MULF(R->m01, k);
  const float vo_1 = KSL_MULF(R->m11, k);
  const float vo_2 = KSL_MULF(R->m21, k);
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
}

/* Ro = R R_y(θ), dc = (sin θ, cos θ).
   R, Ro: rotation or other 3×3 matrix; dc: (sin θ, cos θ).
   6 mul, 6 fma.
   Error <= u |result| + 1 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_product_drdryf_fused(const ksl_mat3x3f_t *R, const float dc[2],
    ksl_mat3x3f_t *Ro) {
  const float Ro_00a = KSL_MULF(R->m00, dc[1]), Ro_00 = fmaf(-R->m02, dc[0], Ro_00a);
  const float Ro_02a = KSL_MULF(R->m00, dc[0]), Ro_02 = fmaf(R->m02, dc[1], Ro_02a);
  const float Ro_10a = KSL_MULF(R->m10, dc[1]), Ro_10 = fmaf(-R->m12, dc[0], Ro_10a);
  const float Ro_12a = KSL_MULF(R->m10, dc[0]), Ro_12 = fmaf(R->m12, dc[1], Ro_12a);
  const float Ro_20a = KSL_MULF(R->m20, dc[1]), Ro_20 = fmaf(-R->m22, dc[0], Ro_20a);
  const float Ro_22a = KSL_MULF(R->m20, dc[0]), Ro_22 = fmaf(R->m22, dc[1], Ro_22a);
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
   6 mul, 6 fma.
   Error <= u |result| + (R: 1, t: 0) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_ddryf_fused(const ksl_SE3f_t *D, const float dc[2], ksl_SE3f_t *Do) {
  const float Do_00a = KSL_MULF(D->m00, dc[1]), Do_00 = fmaf(-D->m02, dc[0], Do_00a);
  const float Do_02a = KSL_MULF(D->m00, dc[0]), Do_02 = fmaf(D->m02, dc[1], Do_02a);
  const float Do_10a = KSL_MULF(D->m10, dc[1]), Do_10 = fmaf(-D->m12, dc[0], Do_10a);
  const float Do_12a = KSL_MULF(D->m10, dc[0]), Do_12 = fmaf(D->m12, dc[1], Do_12a);
  const float Do_20a = KSL_MULF(D->m20, dc[1]), Do_20 = fmaf(-D->m22, dc[0], Do_20a);
  const float Do_22a = KSL_MULF(D->m20, dc[0]), Do_22 = fmaf(D->m22, dc[1], Do_22a);
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
   3 fma.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_product_ddtyf_fused(const ksl_SE3f_t *D, const float k, ksl_SE3f_t *Do) {
  const float Do_03 = fmaf(D->m01, k, D->m03);
  const float Do_13 = fmaf(D->m11, k, D->m13);
  const float Do_23 = fmaf(D->m21, k, D->m23);
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
static inline void ksl_product_drvtyinvf_fused(const ksl_mat3x3f_t *R, const float k,
    ksl_vec3f_t *vo) {
  const float vo_0a = KSL_MULF(R->m01, k), vo_0 = -vo_0a;
  const float vo_1a = KSL_MULF(R->m11, k), vo_1 = -vo_1a;
  const float vo_2a = KSL_MULF(R->m21, k), vo_2 = -vo_2a;
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
}

/* Ro = R R_y(-θ), dc = (sin θ, cos θ).
   R, Ro: rotation or other 3×3 matrix; dc: (sin θ, cos θ).
   6 mul, 6 fma.
   Error <= u |result| + 1 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_product_drdryinvf_fused(const ksl_mat3x3f_t *R, const float dc[2],
    ksl_mat3x3f_t *Ro) {
  const float Ro_00a = KSL_MULF(R->m00, dc[1]), Ro_00 = fmaf(R->m02, dc[0], Ro_00a);
  const float Ro_02a = KSL_MULF(R->m02, dc[1]), Ro_02 = fmaf(-R->m00, dc[0], Ro_02a);
  const float Ro_10a = KSL_MULF(R->m10, dc[1]), Ro_10 = fmaf(R->m12, dc[0], Ro_10a);
  const float Ro_12a = KSL_MULF(R->m12, dc[1]), Ro_12 = fmaf(-R->m10, dc[0], Ro_12a);
  const float Ro_20a = KSL_MULF(R->m20, dc[1]), Ro_20 = fmaf(R->m22, dc[0], Ro_20a);
  const float Ro_22a = KSL_MULF(R->m22, dc[1]), Ro_22 = fmaf(-R->m20, dc[0], Ro_22a);
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
   6 mul, 6 fma.
   Error <= u |result| + (R: 1, t: 0) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_ddryinvf_fused(const ksl_SE3f_t *D, const float dc[2],
    ksl_SE3f_t *Do) {
  const float Do_00a = KSL_MULF(D->m00, dc[1]), Do_00 = fmaf(D->m02, dc[0], Do_00a);
  const float Do_02a = KSL_MULF(D->m02, dc[1]), Do_02 = fmaf(-D->m00, dc[0], Do_02a);
  const float Do_10a = KSL_MULF(D->m10, dc[1]), Do_10 = fmaf(D->m12, dc[0], Do_10a);
  const float Do_12a = KSL_MULF(D->m12, dc[1]), Do_12 = fmaf(-D->m10, dc[0], Do_12a);
  const float Do_20a = KSL_MULF(D->m20, dc[1]), Do_20 = fmaf(D->m22, dc[0], Do_20a);
  const float Do_22a = KSL_MULF(D->m22, dc[1]), Do_22 = fmaf(-D->m20, dc[0], Do_22a);
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
   3 fma.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_product_ddtyinvf_fused(const ksl_SE3f_t *D, const float k, ksl_SE3f_t *Do) {
  const float Do_03 = fmaf(-D->m01, k, D->m03);
  const float Do_13 = fmaf(-D->m11, k, D->m13);
  const float Do_23 = fmaf(-D->m21, k, D->m23);
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
static inline void ksl_product_drvtzf_fused(const ksl_mat3x3f_t *R, const float k,
    ksl_vec3f_t *vo) {
  const float vo_0 = KSL_MULF(R->m02, k);
  const float vo_1 = KSL_MULF(R->m12, k);
  const float vo_2 = KSL_MULF(R->m22, k);
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
}

/* Ro = R R_z(θ), dc = (sin θ, cos θ).
   R, Ro: rotation or other 3×3 matrix; dc: (sin θ, cos θ).
   6 mul, 6 fma.
   Error <= u |result| + 1 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_product_drdrzf_fused(const ksl_mat3x3f_t *R, const float dc[2],
    ksl_mat3x3f_t *Ro) {
  const float Ro_00a = KSL_MULF(R->m00, dc[1]), Ro_00 = fmaf(R->m01, dc[0], Ro_00a);
  const float Ro_01a = KSL_MULF(R->m01, dc[1]), Ro_01 = fmaf(-R->m00, dc[0], Ro_01a);
  const float Ro_10a = KSL_MULF(R->m10, dc[1]), Ro_10 = fmaf(R->m11, dc[0], Ro_10a);
  const float Ro_11a = KSL_MULF(R->m11, dc[1]), Ro_11 = fmaf(-R->m10, dc[0], Ro_11a);
  const float Ro_20a = KSL_MULF(R->m20, dc[1]), Ro_20 = fmaf(R->m21, dc[0], Ro_20a);
  const float Ro_21a = KSL_MULF(R->m21, dc[1]), Ro_21 = fmaf(-R->m20, dc[0], Ro_21a);
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
   6 mul, 6 fma.
   Error <= u |result| + (R: 1, t: 0) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_ddrzf_fused(const ksl_SE3f_t *D, const float dc[2], ksl_SE3f_t *Do) {
  const float Do_00a = KSL_MULF(D->m00, dc[1]), Do_00 = fmaf(D->m01, dc[0], Do_00a);
  const float Do_01a = KSL_MULF(D->m01, dc[1]), Do_01 = fmaf(-D->m00, dc[0], Do_01a);
  const float Do_10a = KSL_MULF(D->m10, dc[1]), Do_10 = fmaf(D->m11, dc[0], Do_10a);
  const float Do_11a = KSL_MULF(D->m11, dc[1]), Do_11 = fmaf(-D->m10, dc[0], Do_11a);
  const float Do_20a = KSL_MULF(D->m20, dc[1]), Do_20 = fmaf(D->m21, dc[0], Do_20a);
  const float Do_21a = KSL_MULF(D->m21, dc[1]), Do_21 = fmaf(-D->m20, dc[0], Do_21a);
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
   3 fma.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_product_ddtzf_fused(const ksl_SE3f_t *D, const float k, ksl_SE3f_t *Do) {
  const float Do_03 = fmaf(D->m02, k, D->m03);
  const float Do_13 = fmaf(D->m12, k, D->m13);
  const float Do_23 = fmaf(D->m22, k, D->m23);
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
static inline void ksl_product_drvtzinvf_fused(const ksl_mat3x3f_t *R, const float k,
    ksl_vec3f_t *vo) {
  const float vo_0a = KSL_MULF(R->m02, k), vo_0 = -vo_0a;
  const float vo_1a = KSL_MULF(R->m12, k), vo_1 = -vo_1a;
  const float vo_2a = KSL_MULF(R->m22, k), vo_2 = -vo_2a;
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
}

/* Ro = R R_z(-θ), dc = (sin θ, cos θ).
   R, Ro: rotation or other 3×3 matrix; dc: (sin θ, cos θ).
   6 mul, 6 fma.
   Error <= u |result| + 1 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_product_drdrzinvf_fused(const ksl_mat3x3f_t *R, const float dc[2],
    ksl_mat3x3f_t *Ro) {
  const float Ro_00a = KSL_MULF(R->m00, dc[1]), Ro_00 = fmaf(-R->m01, dc[0], Ro_00a);
  const float Ro_01a = KSL_MULF(R->m00, dc[0]), Ro_01 = fmaf(R->m01, dc[1], Ro_01a);
  const float Ro_10a = KSL_MULF(R->m10, dc[1]), Ro_10 = fmaf(-R->m11, dc[0], Ro_10a);
  const float Ro_11a = KSL_MULF(R->m10, dc[0]), Ro_11 = fmaf(R->m11, dc[1], Ro_11a);
  const float Ro_20a = KSL_MULF(R->m20, dc[1]), Ro_20 = fmaf(-R->m21, dc[0], Ro_20a);
  const float Ro_21a = KSL_MULF(R->m20, dc[0]), Ro_21 = fmaf(R->m21, dc[1], Ro_21a);
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
   6 mul, 6 fma.
   Error <= u |result| + (R: 1, t: 0) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_ddrzinvf_fused(const ksl_SE3f_t *D, const float dc[2],
    ksl_SE3f_t *Do) {
  const float Do_00a = KSL_MULF(D->m00, dc[1]), Do_00 = fmaf(-D->m01, dc[0], Do_00a);
  const float Do_01a = KSL_MULF(D->m00, dc[0]), Do_01 = fmaf(D->m01, dc[1], Do_01a);
  const float Do_10a = KSL_MULF(D->m10, dc[1]), Do_10 = fmaf(-D->m11, dc[0], Do_10a);
  const float Do_11a = KSL_MULF(D->m10, dc[0]), Do_11 = fmaf(D->m11, dc[1], Do_11a);
  const float Do_20a = KSL_MULF(D->m20, dc[1]), Do_20 = fmaf(-D->m21, dc[0], Do_20a);
  const float Do_21a = KSL_MULF(D->m20, dc[0]), Do_21 = fmaf(D->m21, dc[1], Do_21a);
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
   3 fma.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_product_ddtzinvf_fused(const ksl_SE3f_t *D, const float k, ksl_SE3f_t *Do) {
  const float Do_03 = fmaf(-D->m02, k, D->m03);
  const float Do_13 = fmaf(-D->m12, k, D->m13);
  const float Do_23 = fmaf(-D->m22, k, D->m23);
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
