/* Made by `coscrew generate`; changes are overwritten. */
/* SPDX-License-Identifier: MIT */
/* coscrew 0.2.0.  Copyright (c) 2026 The coscrew authors. */
/* 6×6 operators on screws and coscrews: [Ad], [Ad]*, [ad], [ad]*, and articulated inertias.
   Fused tier: products fused into sums. */
#ifndef KSL_MAT6X6_FUSED_H
#define KSL_MAT6X6_FUSED_H

#include "ksl_types.h"

/* Mo = [Ad]*(R) M [Ad]^-1(R), the articulated inertia M rotated by R; M is symmetric, only its
     lower triangle is read.
   R: rotation or other 3×3 matrix; M, Mo: 6×6 operator.
   48 mul, 96 fma.
   Error <= u |result| + 5 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_mat6x6_rotated_fused(const ksl_mat3x3_t *R, const ksl_mat6x6_t *M,
    ksl_mat6x6_t *Mo) {
  const double RM_0a = KSL_MUL(R->m00, M->at[0][0]), RM_0c = fma(R->m01, M->at[0][1], RM_0a),
      RM_0 = fma(R->m02, M->at[0][2], RM_0c);
  const double RM_1a = KSL_MUL(R->m00, M->at[0][1]), RM_1c = fma(R->m01, M->at[1][1], RM_1a),
      RM_1 = fma(R->m02, M->at[1][2], RM_1c);
  const double RM_2a = KSL_MUL(R->m00, M->at[0][2]), RM_2c = fma(R->m01, M->at[1][2], RM_2a),
      RM_2 = fma(R->m02, M->at[2][2], RM_2c);
  const double RM_3a = KSL_MUL(R->m10, M->at[0][0]), RM_3c = fma(R->m11, M->at[0][1], RM_3a),
      RM_3 = fma(R->m12, M->at[0][2], RM_3c);
  const double RM_4a = KSL_MUL(R->m10, M->at[0][1]), RM_4c = fma(R->m11, M->at[1][1], RM_4a),
      RM_4 = fma(R->m12, M->at[1][2], RM_4c);
  const double RM_5a = KSL_MUL(R->m10, M->at[0][2]), RM_5c = fma(R->m11, M->at[1][2], RM_5a),
      RM_5 = fma(R->m12, M->at[2][2], RM_5c);
  const double RM_6a = KSL_MUL(R->m20, M->at[0][0]), RM_6c = fma(R->m21, M->at[0][1], RM_6a),
      RM_6 = fma(R->m22, M->at[0][2], RM_6c);
  const double RM_7a = KSL_MUL(R->m20, M->at[0][1]), RM_7c = fma(R->m21, M->at[1][1], RM_7a),
      RM_7 = fma(R->m22, M->at[1][2], RM_7c);
  const double RM_8a = KSL_MUL(R->m20, M->at[0][2]), RM_8c = fma(R->m21, M->at[1][2], RM_8a),
      RM_8 = fma(R->m22, M->at[2][2], RM_8c);
  const double linear_0a = KSL_MUL(R->m00, RM_0), linear_0c = fma(R->m01, RM_1, linear_0a),
      linear_0 = fma(R->m02, RM_2, linear_0c);
  const double linear_1a = KSL_MUL(R->m00, RM_3), linear_1c = fma(R->m01, RM_4, linear_1a),
      linear_1 = fma(R->m02, RM_5, linear_1c);
  const double linear_2a = KSL_MUL(R->m10, RM_3), linear_2c = fma(R->m11, RM_4, linear_2a),
      linear_2 = fma(R->m12, RM_5, linear_2c);
  const double linear_3a = KSL_MUL(R->m00, RM_6), linear_3c = fma(R->m01, RM_7, linear_3a),
      linear_3 = fma(R->m02, RM_8, linear_3c);
  const double linear_4a = KSL_MUL(R->m10, RM_6), linear_4c = fma(R->m11, RM_7, linear_4a),
      linear_4 = fma(R->m12, RM_8, linear_4c);
  const double linear_5a = KSL_MUL(R->m20, RM_6), linear_5c = fma(R->m21, RM_7, linear_5a),
      linear_5 = fma(R->m22, RM_8, linear_5c);
  const double RH_0a = KSL_MUL(R->m00, M->at[0][3]), RH_0c = fma(R->m01, M->at[0][4], RH_0a),
      RH_0 = fma(R->m02, M->at[0][5], RH_0c);
  const double RH_1a = KSL_MUL(R->m00, M->at[1][3]), RH_1c = fma(R->m01, M->at[1][4], RH_1a),
      RH_1 = fma(R->m02, M->at[1][5], RH_1c);
  const double RH_2a = KSL_MUL(R->m00, M->at[2][3]), RH_2c = fma(R->m01, M->at[2][4], RH_2a),
      RH_2 = fma(R->m02, M->at[2][5], RH_2c);
  const double RH_3a = KSL_MUL(R->m10, M->at[0][3]), RH_3c = fma(R->m11, M->at[0][4], RH_3a),
      RH_3 = fma(R->m12, M->at[0][5], RH_3c);
  const double RH_4a = KSL_MUL(R->m10, M->at[1][3]), RH_4c = fma(R->m11, M->at[1][4], RH_4a),
      RH_4 = fma(R->m12, M->at[1][5], RH_4c);
  const double RH_5a = KSL_MUL(R->m10, M->at[2][3]), RH_5c = fma(R->m11, M->at[2][4], RH_5a),
      RH_5 = fma(R->m12, M->at[2][5], RH_5c);
  const double RH_6a = KSL_MUL(R->m20, M->at[0][3]), RH_6c = fma(R->m21, M->at[0][4], RH_6a),
      RH_6 = fma(R->m22, M->at[0][5], RH_6c);
  const double RH_7a = KSL_MUL(R->m20, M->at[1][3]), RH_7c = fma(R->m21, M->at[1][4], RH_7a),
      RH_7 = fma(R->m22, M->at[1][5], RH_7c);
  const double RH_8a = KSL_MUL(R->m20, M->at[2][3]), RH_8c = fma(R->m21, M->at[2][4], RH_8a),
      RH_8 = fma(R->m22, M->at[2][5], RH_8c);
  const double coupling_0a = KSL_MUL(R->m00, RH_0), coupling_0c = fma(R->m01, RH_1, coupling_0a),
      coupling_0 = fma(R->m02, RH_2, coupling_0c);
  const double coupling_1a = KSL_MUL(R->m10, RH_0), coupling_1c = fma(R->m11, RH_1, coupling_1a),
      coupling_1 = fma(R->m12, RH_2, coupling_1c);
  const double coupling_2a = KSL_MUL(R->m20, RH_0), coupling_2c = fma(R->m21, RH_1, coupling_2a),
      coupling_2 = fma(R->m22, RH_2, coupling_2c);
  const double coupling_3a = KSL_MUL(R->m00, RH_3), coupling_3c = fma(R->m01, RH_4, coupling_3a),
      coupling_3 = fma(R->m02, RH_5, coupling_3c);
  const double coupling_4a = KSL_MUL(R->m10, RH_3), coupling_4c = fma(R->m11, RH_4, coupling_4a),
      coupling_4 = fma(R->m12, RH_5, coupling_4c);
  const double coupling_5a = KSL_MUL(R->m20, RH_3), coupling_5c = fma(R->m21, RH_4, coupling_5a),
      coupling_5 = fma(R->m22, RH_5, coupling_5c);
  const double coupling_6a = KSL_MUL(R->m00, RH_6), coupling_6c = fma(R->m01, RH_7, coupling_6a),
      coupling_6 = fma(R->m02, RH_8, coupling_6c);
  const double coupling_7a = KSL_MUL(R->m10, RH_6), coupling_7c = fma(R->m11, RH_7, coupling_7a),
      coupling_7 = fma(R->m12, RH_8, coupling_7c);
  const double coupling_8a = KSL_MUL(R->m20, RH_6), coupling_8c = fma(R->m21, RH_7, coupling_8a),
      coupling_8 = fma(R->m22, RH_8, coupling_8c);
  const double RI_0a = KSL_MUL(R->m00, M->at[3][3]), RI_0c = fma(R->m01, M->at[3][4], RI_0a),
      RI_0 = fma(R->m02, M->at[3][5], RI_0c);
  const double RI_1a = KSL_MUL(R->m00, M->at[3][4]), RI_1c = fma(R->m01, M->at[4][4], RI_1a),
      RI_1 = fma(R->m02, M->at[4][5], RI_1c);
  const double RI_2a = KSL_MUL(R->m00, M->at[3][5]), RI_2c = fma(R->m01, M->at[4][5], RI_2a),
      RI_2 = fma(R->m02, M->at[5][5], RI_2c);
  const double RI_3a = KSL_MUL(R->m10, M->at[3][3]), RI_3c = fma(R->m11, M->at[3][4], RI_3a),
      RI_3 = fma(R->m12, M->at[3][5], RI_3c);
  const double RI_4a = KSL_MUL(R->m10, M->at[3][4]), RI_4c = fma(R->m11, M->at[4][4], RI_4a),
      RI_4 = fma(R->m12, M->at[4][5], RI_4c);
  const double RI_5a = KSL_MUL(R->m10, M->at[3][5]), RI_5c = fma(R->m11, M->at[4][5], RI_5a),
      RI_5 = fma(R->m12, M->at[5][5], RI_5c);
  const double RI_6a = KSL_MUL(R->m20, M->at[3][3]), RI_6c = fma(R->m21, M->at[3][4], RI_6a),
      RI_6 = fma(R->m22, M->at[3][5], RI_6c);
  const double RI_7a = KSL_MUL(R->m20, M->at[3][4]), RI_7c = fma(R->m21, M->at[4][4], RI_7a),
      RI_7 = fma(R->m22, M->at[4][5], RI_7c);
  const double RI_8a = KSL_MUL(R->m20, M->at[3][5]), RI_8c = fma(R->m21, M->at[4][5], RI_8a),
      RI_8 = fma(R->m22, M->at[5][5], RI_8c);
  const double angular_0a = KSL_MUL(R->m00, RI_0), angular_0c = fma(R->m01, RI_1, angular_0a),
      angular_0 = fma(R->m02, RI_2, angular_0c);
  const double angular_1a = KSL_MUL(R->m00, RI_3), angular_1c = fma(R->m01, RI_4, angular_1a),
      angular_1 = fma(R->m02, RI_5, angular_1c);
  const double angular_2a = KSL_MUL(R->m10, RI_3), angular_2c = fma(R->m11, RI_4, angular_2a),
      angular_2 = fma(R->m12, RI_5, angular_2c);
  const double angular_3a = KSL_MUL(R->m00, RI_6), angular_3c = fma(R->m01, RI_7, angular_3a),
      angular_3 = fma(R->m02, RI_8, angular_3c);
  const double angular_4a = KSL_MUL(R->m10, RI_6), angular_4c = fma(R->m11, RI_7, angular_4a),
      angular_4 = fma(R->m12, RI_8, angular_4c);
  const double angular_5a = KSL_MUL(R->m20, RI_6), angular_5c = fma(R->m21, RI_7, angular_5a),
      angular_5 = fma(R->m22, RI_8, angular_5c);
  Mo->at[0][0] = linear_0;
  Mo->at[1][0] = linear_1;
  Mo->at[2][0] = linear_3;
  Mo->at[3][0] = coupling_0;
  Mo->at[4][0] = coupling_3;
  Mo->at[5][0] = coupling_6;
  Mo->at[0][1] = linear_1;
  Mo->at[1][1] = linear_2;
  Mo->at[2][1] = linear_4;
  Mo->at[3][1] = coupling_1;
  Mo->at[4][1] = coupling_4;
  Mo->at[5][1] = coupling_7;
  Mo->at[0][2] = linear_3;
  Mo->at[1][2] = linear_4;
  Mo->at[2][2] = linear_5;
  Mo->at[3][2] = coupling_2;
  Mo->at[4][2] = coupling_5;
  Mo->at[5][2] = coupling_8;
  Mo->at[0][3] = coupling_0;
  Mo->at[1][3] = coupling_1;
  Mo->at[2][3] = coupling_2;
  Mo->at[3][3] = angular_0;
  Mo->at[4][3] = angular_1;
  Mo->at[5][3] = angular_3;
  Mo->at[0][4] = coupling_3;
  Mo->at[1][4] = coupling_4;
  Mo->at[2][4] = coupling_5;
  Mo->at[3][4] = angular_1;
  Mo->at[4][4] = angular_2;
  Mo->at[5][4] = angular_4;
  Mo->at[0][5] = coupling_6;
  Mo->at[1][5] = coupling_7;
  Mo->at[2][5] = coupling_8;
  Mo->at[3][5] = angular_3;
  Mo->at[4][5] = angular_4;
  Mo->at[5][5] = angular_5;
}

/* Mo = [Ad]*(t) M [Ad]^-1(t), the articulated inertia M shifted by t; M is symmetric, only its
     lower triangle is read.
   t: vector; M, Mo: 6×6 operator.
   21 mul, 24 add, 18 fma.
   Error <= u |result| + 6 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_mat6x6_shifted_fused(const ksl_vec3_t *t, const ksl_mat6x6_t *M,
    ksl_mat6x6_t *Mo) {
  const double G_0a = KSL_MUL(t->y, M->at[0][2]), G_0b = KSL_MUL(t->z, M->at[0][1]),
      G_0c = G_0a - G_0b, G_0 = G_0c + M->at[0][3];
  const double G_1a = KSL_MUL(t->y, M->at[1][2]), G_1c = fma(-t->z, M->at[1][1], G_1a),
      G_1 = G_1c + M->at[1][3];
  const double G_2a = KSL_MUL(t->y, M->at[2][2]), G_2c = fma(-t->z, M->at[1][2], G_2a),
      G_2 = G_2c + M->at[2][3];
  const double G_3a = KSL_MUL(t->z, M->at[0][0]), G_3c = fma(-t->x, M->at[0][2], G_3a),
      G_3 = G_3c + M->at[0][4];
  const double G_4a = KSL_MUL(t->x, M->at[1][2]), G_4b = G_0b - G_4a, G_4 = G_4b + M->at[1][4];
  const double G_5a = KSL_MUL(t->z, M->at[0][2]), G_5c = fma(-t->x, M->at[2][2], G_5a),
      G_5 = G_5c + M->at[2][4];
  const double G_6a = KSL_MUL(t->x, M->at[0][1]), G_6c = fma(-t->y, M->at[0][0], G_6a),
      G_6 = G_6c + M->at[0][5];
  const double G_7a = KSL_MUL(t->x, M->at[1][1]), G_7c = fma(-t->y, M->at[0][1], G_7a),
      G_7 = G_7c + M->at[1][5];
  const double G_8a = G_4a - G_0a, G_8 = G_8a + M->at[2][5];
  const double moved_0a = KSL_MUL(t->y, M->at[2][3]), moved_0c = fma(-t->z, M->at[1][3], moved_0a),
      moved_0d = KSL_MUL(t->y, G_2), moved_0f = fma(-t->z, G_1, moved_0d),
      moved_0g = moved_0c + moved_0f, moved_0 = moved_0g + M->at[3][3];
  const double moved_1a = KSL_MUL(t->z, M->at[0][3]), moved_1c = fma(-t->x, M->at[2][3], moved_1a),
      moved_1d = KSL_MUL(t->y, G_5), moved_1f = fma(-t->z, G_4, moved_1d),
      moved_1g = moved_1c + moved_1f, moved_1 = moved_1g + M->at[3][4];
  const double moved_2a = KSL_MUL(t->z, M->at[0][4]), moved_2c = fma(-t->x, M->at[2][4], moved_2a),
      moved_2d = KSL_MUL(t->z, G_3), moved_2f = fma(-t->x, G_5, moved_2d),
      moved_2g = moved_2c + moved_2f, moved_2 = moved_2g + M->at[4][4];
  const double moved_3a = KSL_MUL(t->x, M->at[1][3]), moved_3c = fma(-t->y, M->at[0][3], moved_3a),
      moved_3d = KSL_MUL(t->y, G_8), moved_3f = fma(-t->z, G_7, moved_3d),
      moved_3g = moved_3c + moved_3f, moved_3 = moved_3g + M->at[3][5];
  const double moved_4a = KSL_MUL(t->x, M->at[1][4]), moved_4c = fma(-t->y, M->at[0][4], moved_4a),
      moved_4d = KSL_MUL(t->z, G_6), moved_4f = fma(-t->x, G_8, moved_4d),
      moved_4g = moved_4c + moved_4f, moved_4 = moved_4g + M->at[4][5];
  const double moved_5a = KSL_MUL(t->x, M->at[1][5]), moved_5c = fma(-t->y, M->at[0][5], moved_5a),
      moved_5d = KSL_MUL(t->x, G_7), moved_5f = fma(-t->y, G_6, moved_5d),
      moved_5g = moved_5c + moved_5f, moved_5 = moved_5g + M->at[5][5];
  const double M_at_00 = M->at[0][0];
  const double M_at_01 = M->at[0][1];
  const double M_at_02 = M->at[0][2];
  const double M_at_11 = M->at[1][1];
  const double M_at_12 = M->at[1][2];
  const double M_at_22 = M->at[2][2];
  Mo->at[0][0] = M_at_00;
  Mo->at[1][0] = M_at_01;
  Mo->at[2][0] = M_at_02;
  Mo->at[3][0] = G_0;
  Mo->at[4][0] = G_3;
  Mo->at[5][0] = G_6;
  Mo->at[0][1] = M_at_01;
  Mo->at[1][1] = M_at_11;
  Mo->at[2][1] = M_at_12;
  Mo->at[3][1] = G_1;
  Mo->at[4][1] = G_4;
  Mo->at[5][1] = G_7;
  Mo->at[0][2] = M_at_02;
  Mo->at[1][2] = M_at_12;
  Mo->at[2][2] = M_at_22;
  Mo->at[3][2] = G_2;
  Mo->at[4][2] = G_5;
  Mo->at[5][2] = G_8;
  Mo->at[0][3] = G_0;
  Mo->at[1][3] = G_1;
  Mo->at[2][3] = G_2;
  Mo->at[3][3] = moved_0;
  Mo->at[4][3] = moved_1;
  Mo->at[5][3] = moved_3;
  Mo->at[0][4] = G_3;
  Mo->at[1][4] = G_4;
  Mo->at[2][4] = G_5;
  Mo->at[3][4] = moved_1;
  Mo->at[4][4] = moved_2;
  Mo->at[5][4] = moved_4;
  Mo->at[0][5] = G_6;
  Mo->at[1][5] = G_7;
  Mo->at[2][5] = G_8;
  Mo->at[3][5] = moved_3;
  Mo->at[4][5] = moved_4;
  Mo->at[5][5] = moved_5;
}

/* Mo = [Ad]*(R) M [Ad]^-1(R), the articulated inertia M rotated by R; M is symmetric, only its
     lower triangle is read.
   R: rotation or other 3×3 matrix; M, Mo: 6×6 operator.
   48 mul, 96 fma.
   Error <= u |result| + 5 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_mat6x6f_rotated_fused(const ksl_mat3x3f_t *R, const ksl_mat6x6f_t *M,
    ksl_mat6x6f_t *Mo) {
  const float RM_0a = KSL_MULF(R->m00, M->at[0][0]), RM_0c = fmaf(R->m01, M->at[0][1], RM_0a),
      RM_0 = fmaf(R->m02, M->at[0][2], RM_0c);
  const float RM_1a = KSL_MULF(R->m00, M->at[0][1]), RM_1c = fmaf(R->m01, M->at[1][1], RM_1a),
      RM_1 = fmaf(R->m02, M->at[1][2], RM_1c);
  const float RM_2a = KSL_MULF(R->m00, M->at[0][2]), RM_2c = fmaf(R->m01, M->at[1][2], RM_2a),
      RM_2 = fmaf(R->m02, M->at[2][2], RM_2c);
  const float RM_3a = KSL_MULF(R->m10, M->at[0][0]), RM_3c = fmaf(R->m11, M->at[0][1], RM_3a),
      RM_3 = fmaf(R->m12, M->at[0][2], RM_3c);
  const float RM_4a = KSL_MULF(R->m10, M->at[0][1]), RM_4c = fmaf(R->m11, M->at[1][1], RM_4a),
      RM_4 = fmaf(R->m12, M->at[1][2], RM_4c);
  const float RM_5a = KSL_MULF(R->m10, M->at[0][2]), RM_5c = fmaf(R->m11, M->at[1][2], RM_5a),
      RM_5 = fmaf(R->m12, M->at[2][2], RM_5c);
  const float RM_6a = KSL_MULF(R->m20, M->at[0][0]), RM_6c = fmaf(R->m21, M->at[0][1], RM_6a),
      RM_6 = fmaf(R->m22, M->at[0][2], RM_6c);
  const float RM_7a = KSL_MULF(R->m20, M->at[0][1]), RM_7c = fmaf(R->m21, M->at[1][1], RM_7a),
      RM_7 = fmaf(R->m22, M->at[1][2], RM_7c);
  const float RM_8a = KSL_MULF(R->m20, M->at[0][2]), RM_8c = fmaf(R->m21, M->at[1][2], RM_8a),
      RM_8 = fmaf(R->m22, M->at[2][2], RM_8c);
  const float linear_0a = KSL_MULF(R->m00, RM_0), linear_0c = fmaf(R->m01, RM_1, linear_0a),
      linear_0 = fmaf(R->m02, RM_2, linear_0c);
  const float linear_1a = KSL_MULF(R->m00, RM_3), linear_1c = fmaf(R->m01, RM_4, linear_1a),
      linear_1 = fmaf(R->m02, RM_5, linear_1c);
  const float linear_2a = KSL_MULF(R->m10, RM_3), linear_2c = fmaf(R->m11, RM_4, linear_2a),
      linear_2 = fmaf(R->m12, RM_5, linear_2c);
  const float linear_3a = KSL_MULF(R->m00, RM_6), linear_3c = fmaf(R->m01, RM_7, linear_3a),
      linear_3 = fmaf(R->m02, RM_8, linear_3c);
  const float linear_4a = KSL_MULF(R->m10, RM_6), linear_4c = fmaf(R->m11, RM_7, linear_4a),
      linear_4 = fmaf(R->m12, RM_8, linear_4c);
  const float linear_5a = KSL_MULF(R->m20, RM_6), linear_5c = fmaf(R->m21, RM_7, linear_5a),
      linear_5 = fmaf(R->m22, RM_8, linear_5c);
  const float RH_0a = KSL_MULF(R->m00, M->at[0][3]), RH_0c = fmaf(R->m01, M->at[0][4], RH_0a),
      RH_0 = fmaf(R->m02, M->at[0][5], RH_0c);
  const float RH_1a = KSL_MULF(R->m00, M->at[1][3]), RH_1c = fmaf(R->m01, M->at[1][4], RH_1a),
      RH_1 = fmaf(R->m02, M->at[1][5], RH_1c);
  const float RH_2a = KSL_MULF(R->m00, M->at[2][3]), RH_2c = fmaf(R->m01, M->at[2][4], RH_2a),
      RH_2 = fmaf(R->m02, M->at[2][5], RH_2c);
  const float RH_3a = KSL_MULF(R->m10, M->at[0][3]), RH_3c = fmaf(R->m11, M->at[0][4], RH_3a),
      RH_3 = fmaf(R->m12, M->at[0][5], RH_3c);
  const float RH_4a = KSL_MULF(R->m10, M->at[1][3]), RH_4c = fmaf(R->m11, M->at[1][4], RH_4a),
      RH_4 = fmaf(R->m12, M->at[1][5], RH_4c);
  const float RH_5a = KSL_MULF(R->m10, M->at[2][3]), RH_5c = fmaf(R->m11, M->at[2][4], RH_5a),
      RH_5 = fmaf(R->m12, M->at[2][5], RH_5c);
  const float RH_6a = KSL_MULF(R->m20, M->at[0][3]), RH_6c = fmaf(R->m21, M->at[0][4], RH_6a),
      RH_6 = fmaf(R->m22, M->at[0][5], RH_6c);
  const float RH_7a = KSL_MULF(R->m20, M->at[1][3]), RH_7c = fmaf(R->m21, M->at[1][4], RH_7a),
      RH_7 = fmaf(R->m22, M->at[1][5], RH_7c);
  const float RH_8a = KSL_MULF(R->m20, M->at[2][3]), RH_8c = fmaf(R->m21, M->at[2][4], RH_8a),
      RH_8 = fmaf(R->m22, M->at[2][5], RH_8c);
  const float coupling_0a = KSL_MULF(R->m00, RH_0), coupling_0c = fmaf(R->m01, RH_1, coupling_0a),
      coupling_0 = fmaf(R->m02, RH_2, coupling_0c);
  const float coupling_1a = KSL_MULF(R->m10, RH_0), coupling_1c = fmaf(R->m11, RH_1, coupling_1a),
      coupling_1 = fmaf(R->m12, RH_2, coupling_1c);
  const float coupling_2a = KSL_MULF(R->m20, RH_0), coupling_2c = fmaf(R->m21, RH_1, coupling_2a),
      coupling_2 = fmaf(R->m22, RH_2, coupling_2c);
  const float coupling_3a = KSL_MULF(R->m00, RH_3), coupling_3c = fmaf(R->m01, RH_4, coupling_3a),
      coupling_3 = fmaf(R->m02, RH_5, coupling_3c);
  const float coupling_4a = KSL_MULF(R->m10, RH_3), coupling_4c = fmaf(R->m11, RH_4, coupling_4a),
      coupling_4 = fmaf(R->m12, RH_5, coupling_4c);
  const float coupling_5a = KSL_MULF(R->m20, RH_3), coupling_5c = fmaf(R->m21, RH_4, coupling_5a),
      coupling_5 = fmaf(R->m22, RH_5, coupling_5c);
  const float coupling_6a = KSL_MULF(R->m00, RH_6), coupling_6c = fmaf(R->m01, RH_7, coupling_6a),
      coupling_6 = fmaf(R->m02, RH_8, coupling_6c);
  const float coupling_7a = KSL_MULF(R->m10, RH_6), coupling_7c = fmaf(R->m11, RH_7, coupling_7a),
      coupling_7 = fmaf(R->m12, RH_8, coupling_7c);
  const float coupling_8a = KSL_MULF(R->m20, RH_6), coupling_8c = fmaf(R->m21, RH_7, coupling_8a),
      coupling_8 = fmaf(R->m22, RH_8, coupling_8c);
  const float RI_0a = KSL_MULF(R->m00, M->at[3][3]), RI_0c = fmaf(R->m01, M->at[3][4], RI_0a),
      RI_0 = fmaf(R->m02, M->at[3][5], RI_0c);
  const float RI_1a = KSL_MULF(R->m00, M->at[3][4]), RI_1c = fmaf(R->m01, M->at[4][4], RI_1a),
      RI_1 = fmaf(R->m02, M->at[4][5], RI_1c);
  const float RI_2a = KSL_MULF(R->m00, M->at[3][5]), RI_2c = fmaf(R->m01, M->at[4][5], RI_2a),
      RI_2 = fmaf(R->m02, M->at[5][5], RI_2c);
  const float RI_3a = KSL_MULF(R->m10, M->at[3][3]), RI_3c = fmaf(R->m11, M->at[3][4], RI_3a),
      RI_3 = fmaf(R->m12, M->at[3][5], RI_3c);
  const float RI_4a = KSL_MULF(R->m10, M->at[3][4]), RI_4c = fmaf(R->m11, M->at[4][4], RI_4a),
      RI_4 = fmaf(R->m12, M->at[4][5], RI_4c);
  const float RI_5a = KSL_MULF(R->m10, M->at[3][5]), RI_5c = fmaf(R->m11, M->at[4][5], RI_5a),
      RI_5 = fmaf(R->m12, M->at[5][5], RI_5c);
  const float RI_6a = KSL_MULF(R->m20, M->at[3][3]), RI_6c = fmaf(R->m21, M->at[3][4], RI_6a),
      RI_6 = fmaf(R->m22, M->at[3][5], RI_6c);
  const float RI_7a = KSL_MULF(R->m20, M->at[3][4]), RI_7c = fmaf(R->m21, M->at[4][4], RI_7a),
      RI_7 = fmaf(R->m22, M->at[4][5], RI_7c);
  const float RI_8a = KSL_MULF(R->m20, M->at[3][5]), RI_8c = fmaf(R->m21, M->at[4][5], RI_8a),
      RI_8 = fmaf(R->m22, M->at[5][5], RI_8c);
  const float angular_0a = KSL_MULF(R->m00, RI_0), angular_0c = fmaf(R->m01, RI_1, angular_0a),
      angular_0 = fmaf(R->m02, RI_2, angular_0c);
  const float angular_1a = KSL_MULF(R->m00, RI_3), angular_1c = fmaf(R->m01, RI_4, angular_1a),
      angular_1 = fmaf(R->m02, RI_5, angular_1c);
  const float angular_2a = KSL_MULF(R->m10, RI_3), angular_2c = fmaf(R->m11, RI_4, angular_2a),
      angular_2 = fmaf(R->m12, RI_5, angular_2c);
  const float angular_3a = KSL_MULF(R->m00, RI_6), angular_3c = fmaf(R->m01, RI_7, angular_3a),
      angular_3 = fmaf(R->m02, RI_8, angular_3c);
  const float angular_4a = KSL_MULF(R->m10, RI_6), angular_4c = fmaf(R->m11, RI_7, angular_4a),
      angular_4 = fmaf(R->m12, RI_8, angular_4c);
  const float angular_5a = KSL_MULF(R->m20, RI_6), angular_5c = fmaf(R->m21, RI_7, angular_5a),
      angular_5 = fmaf(R->m22, RI_8, angular_5c);
  Mo->at[0][0] = linear_0;
  Mo->at[1][0] = linear_1;
  Mo->at[2][0] = linear_3;
  Mo->at[3][0] = coupling_0;
  Mo->at[4][0] = coupling_3;
  Mo->at[5][0] = coupling_6;
  Mo->at[0][1] = linear_1;
  Mo->at[1][1] = linear_2;
  Mo->at[2][1] = linear_4;
  Mo->at[3][1] = coupling_1;
  Mo->at[4][1] = coupling_4;
  Mo->at[5][1] = coupling_7;
  Mo->at[0][2] = linear_3;
  Mo->at[1][2] = linear_4;
  Mo->at[2][2] = linear_5;
  Mo->at[3][2] = coupling_2;
  Mo->at[4][2] = coupling_5;
  Mo->at[5][2] = coupling_8;
  Mo->at[0][3] = coupling_0;
  Mo->at[1][3] = coupling_1;
  Mo->at[2][3] = coupling_2;
  Mo->at[3][3] = angular_0;
  Mo->at[4][3] = angular_1;
  Mo->at[5][3] = angular_3;
  Mo->at[0][4] = coupling_3;
  Mo->at[1][4] = coupling_4;
  Mo->at[2][4] = coupling_5;
  Mo->at[3][4] = angular_1;
  Mo->at[4][4] = angular_2;
  Mo->at[5][4] = angular_4;
  Mo->at[0][5] = coupling_6;
  Mo->at[1][5] = coupling_7;
  Mo->at[2][5] = coupling_8;
  Mo->at[3][5] = angular_3;
  Mo->at[4][5] = angular_4;
  Mo->at[5][5] = angular_5;
}

/* Mo = [Ad]*(t) M [Ad]^-1(t), the articulated inertia M shifted by t; M is symmetric, only its
     lower triangle is read.
   t: vector; M, Mo: 6×6 operator.
   21 mul, 24 add, 18 fma.
   Error <= u |result| + 6 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_mat6x6f_shifted_fused(const ksl_vec3f_t *t, const ksl_mat6x6f_t *M,
    ksl_mat6x6f_t *Mo) {
  const float G_0a = KSL_MULF(t->y, M->at[0][2]), G_0b = KSL_MULF(t->z, M->at[0][1]),
      G_0c = G_0a - G_0b, G_0 = G_0c + M->at[0][3];
  const float G_1a = KSL_MULF(t->y, M->at[1][2]), G_1c = fmaf(-t->z, M->at[1][1], G_1a),
      G_1 = G_1c + M->at[1][3];
  const float G_2a = KSL_MULF(t->y, M->at[2][2]), G_2c = fmaf(-t->z, M->at[1][2], G_2a),
      G_2 = G_2c + M->at[2][3];
  const float G_3a = KSL_MULF(t->z, M->at[0][0]), G_3c = fmaf(-t->x, M->at[0][2], G_3a),
      G_3 = G_3c + M->at[0][4];
  const float G_4a = KSL_MULF(t->x, M->at[1][2]), G_4b = G_0b - G_4a, G_4 = G_4b + M->at[1][4];
  const float G_5a = KSL_MULF(t->z, M->at[0][2]), G_5c = fmaf(-t->x, M->at[2][2], G_5a),
      G_5 = G_5c + M->at[2][4];
  const float G_6a = KSL_MULF(t->x, M->at[0][1]), G_6c = fmaf(-t->y, M->at[0][0], G_6a),
      G_6 = G_6c + M->at[0][5];
  const float G_7a = KSL_MULF(t->x, M->at[1][1]), G_7c = fmaf(-t->y, M->at[0][1], G_7a),
      G_7 = G_7c + M->at[1][5];
  const float G_8a = G_4a - G_0a, G_8 = G_8a + M->at[2][5];
  const float moved_0a = KSL_MULF(t->y, M->at[2][3]), moved_0c = fmaf(-t->z, M->at[1][3], moved_0a),
      moved_0d = KSL_MULF(t->y, G_2), moved_0f = fmaf(-t->z, G_1, moved_0d),
      moved_0g = moved_0c + moved_0f, moved_0 = moved_0g + M->at[3][3];
  const float moved_1a = KSL_MULF(t->z, M->at[0][3]), moved_1c = fmaf(-t->x, M->at[2][3], moved_1a),
      moved_1d = KSL_MULF(t->y, G_5), moved_1f = fmaf(-t->z, G_4, moved_1d),
      moved_1g = moved_1c + moved_1f, moved_1 = moved_1g + M->at[3][4];
  const float moved_2a = KSL_MULF(t->z, M->at[0][4]), moved_2c = fmaf(-t->x, M->at[2][4], moved_2a),
      moved_2d = KSL_MULF(t->z, G_3), moved_2f = fmaf(-t->x, G_5, moved_2d),
      moved_2g = moved_2c + moved_2f, moved_2 = moved_2g + M->at[4][4];
  const float moved_3a = KSL_MULF(t->x, M->at[1][3]), moved_3c = fmaf(-t->y, M->at[0][3], moved_3a),
      moved_3d = KSL_MULF(t->y, G_8), moved_3f = fmaf(-t->z, G_7, moved_3d),
      moved_3g = moved_3c + moved_3f, moved_3 = moved_3g + M->at[3][5];
  const float moved_4a = KSL_MULF(t->x, M->at[1][4]), moved_4c = fmaf(-t->y, M->at[0][4], moved_4a),
      moved_4d = KSL_MULF(t->z, G_6), moved_4f = fmaf(-t->x, G_8, moved_4d),
      moved_4g = moved_4c + moved_4f, moved_4 = moved_4g + M->at[4][5];
  const float moved_5a = KSL_MULF(t->x, M->at[1][5]), moved_5c = fmaf(-t->y, M->at[0][5], moved_5a),
      moved_5d = KSL_MULF(t->x, G_7), moved_5f = fmaf(-t->y, G_6, moved_5d),
      moved_5g = moved_5c + moved_5f, moved_5 = moved_5g + M->at[5][5];
  const float M_at_00 = M->at[0][0];
  const float M_at_01 = M->at[0][1];
  const float M_at_02 = M->at[0][2];
  const float M_at_11 = M->at[1][1];
  const float M_at_12 = M->at[1][2];
  const float M_at_22 = M->at[2][2];
  Mo->at[0][0] = M_at_00;
  Mo->at[1][0] = M_at_01;
  Mo->at[2][0] = M_at_02;
  Mo->at[3][0] = G_0;
  Mo->at[4][0] = G_3;
  Mo->at[5][0] = G_6;
  Mo->at[0][1] = M_at_01;
  Mo->at[1][1] = M_at_11;
  Mo->at[2][1] = M_at_12;
  Mo->at[3][1] = G_1;
  Mo->at[4][1] = G_4;
  Mo->at[5][1] = G_7;
  Mo->at[0][2] = M_at_02;
  Mo->at[1][2] = M_at_12;
  Mo->at[2][2] = M_at_22;
  Mo->at[3][2] = G_2;
  Mo->at[4][2] = G_5;
  Mo->at[5][2] = G_8;
  Mo->at[0][3] = G_0;
  Mo->at[1][3] = G_1;
  Mo->at[2][3] = G_2;
  Mo->at[3][3] = moved_0;
  Mo->at[4][3] = moved_1;
  Mo->at[5][3] = moved_3;
  Mo->at[0][4] = G_3;
  Mo->at[1][4] = G_4;
  Mo->at[2][4] = G_5;
  Mo->at[3][4] = moved_1;
  Mo->at[4][4] = moved_2;
  Mo->at[5][4] = moved_4;
  Mo->at[0][5] = G_6;
  Mo->at[1][5] = G_7;
  Mo->at[2][5] = G_8;
  Mo->at[3][5] = moved_3;
  Mo->at[4][5] = moved_4;
  Mo->at[5][5] = moved_5;
}

#endif
