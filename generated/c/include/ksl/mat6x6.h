/* Made by `coscrew generate`; changes are overwritten. */
/* SPDX-License-Identifier: MIT */
/* coscrew 0.2.0.  Copyright (c) 2026 The coscrew authors. */
/* 6×6 operators on screws and coscrews: [Ad], [Ad]*, [ad], [ad]*, and articulated inertias. */
#ifndef KSL_MAT6X6_H
#define KSL_MAT6X6_H

#include "ksl_types.h"

/* The entry of M at (row, column), for 0 <= row < 6 and 0 <= column < 6; NaN outside. */
static inline double ksl_mat6x6_get(const ksl_mat6x6_t *M, const int row, const int column) {
  return row >= 0 && row < 6 && column >= 0 && column < 6 ? M->at[column][row] : (double)NAN;
}

/* Sets the entry of M at (row, column), for 0 <= row < 6 and 0 <= column < 6; does nothing
     outside. */
static inline void ksl_mat6x6_set(ksl_mat6x6_t *M, const int row, const int column,
    const double value) {
  if (row >= 0 && row < 6 && column >= 0 && column < 6) {
    M->at[column][row] = value;
  }
}

/* Mo = M.
   M, Mo: 6×6 operator.
   No arithmetic.
   Exact. */
static inline void ksl_mat6x6_copy(const ksl_mat6x6_t *M, ksl_mat6x6_t *Mo) {
  const double M_at_00 = M->at[0][0];
  const double M_at_10 = M->at[1][0];
  const double M_at_20 = M->at[2][0];
  const double M_at_30 = M->at[3][0];
  const double M_at_40 = M->at[4][0];
  const double M_at_50 = M->at[5][0];
  const double M_at_01 = M->at[0][1];
  const double M_at_11 = M->at[1][1];
  const double M_at_21 = M->at[2][1];
  const double M_at_31 = M->at[3][1];
  const double M_at_41 = M->at[4][1];
  const double M_at_51 = M->at[5][1];
  const double M_at_02 = M->at[0][2];
  const double M_at_12 = M->at[1][2];
  const double M_at_22 = M->at[2][2];
  const double M_at_32 = M->at[3][2];
  const double M_at_42 = M->at[4][2];
  const double M_at_52 = M->at[5][2];
  const double M_at_03 = M->at[0][3];
  const double M_at_13 = M->at[1][3];
  const double M_at_23 = M->at[2][3];
  const double M_at_33 = M->at[3][3];
  const double M_at_43 = M->at[4][3];
  const double M_at_53 = M->at[5][3];
  const double M_at_04 = M->at[0][4];
  const double M_at_14 = M->at[1][4];
  const double M_at_24 = M->at[2][4];
  const double M_at_34 = M->at[3][4];
  const double M_at_44 = M->at[4][4];
  const double M_at_54 = M->at[5][4];
  const double M_at_05 = M->at[0][5];
  const double M_at_15 = M->at[1][5];
  const double M_at_25 = M->at[2][5];
  const double M_at_35 = M->at[3][5];
  const double M_at_45 = M->at[4][5];
  const double M_at_55 = M->at[5][5];
  Mo->at[0][0] = M_at_00;
  Mo->at[1][0] = M_at_10;
  Mo->at[2][0] = M_at_20;
  Mo->at[3][0] = M_at_30;
  Mo->at[4][0] = M_at_40;
  Mo->at[5][0] = M_at_50;
  Mo->at[0][1] = M_at_01;
  Mo->at[1][1] = M_at_11;
  Mo->at[2][1] = M_at_21;
  Mo->at[3][1] = M_at_31;
  Mo->at[4][1] = M_at_41;
  Mo->at[5][1] = M_at_51;
  Mo->at[0][2] = M_at_02;
  Mo->at[1][2] = M_at_12;
  Mo->at[2][2] = M_at_22;
  Mo->at[3][2] = M_at_32;
  Mo->at[4][2] = M_at_42;
  Mo->at[5][2] = M_at_52;
  Mo->at[0][3] = M_at_03;
  Mo->at[1][3] = M_at_13;
  Mo->at[2][3] = M_at_23;
  Mo->at[3][3] = M_at_33;
  Mo->at[4][3] = M_at_43;
  Mo->at[5][3] = M_at_53;
  Mo->at[0][4] = M_at_04;
  Mo->at[1][4] = M_at_14;
  Mo->at[2][4] = M_at_24;
  Mo->at[3][4] = M_at_34;
  Mo->at[4][4] = M_at_44;
  Mo->at[5][4] = M_at_54;
  Mo->at[0][5] = M_at_05;
  Mo->at[1][5] = M_at_15;
  Mo->at[2][5] = M_at_25;
  Mo->at[3][5] = M_at_35;
  Mo->at[4][5] = M_at_45;
  Mo->at[5][5] = M_at_55;
}

/* self = I.
   self: 6×6 operator.
   No arithmetic.
   Exact. */
static inline void ksl_mat6x6_setIdentity(ksl_mat6x6_t *self) {
  self->at[0][0] = 1.0;
  self->at[1][0] = 0.0;
  self->at[2][0] = 0.0;
  self->at[3][0] = 0.0;
  self->at[4][0] = 0.0;
  self->at[5][0] = 0.0;
  self->at[0][1] = 0.0;
  self->at[1][1] = 1.0;
  self->at[2][1] = 0.0;
  self->at[3][1] = 0.0;
  self->at[4][1] = 0.0;
  self->at[5][1] = 0.0;
  self->at[0][2] = 0.0;
  self->at[1][2] = 0.0;
  self->at[2][2] = 1.0;
  self->at[3][2] = 0.0;
  self->at[4][2] = 0.0;
  self->at[5][2] = 0.0;
  self->at[0][3] = 0.0;
  self->at[1][3] = 0.0;
  self->at[2][3] = 0.0;
  self->at[3][3] = 1.0;
  self->at[4][3] = 0.0;
  self->at[5][3] = 0.0;
  self->at[0][4] = 0.0;
  self->at[1][4] = 0.0;
  self->at[2][4] = 0.0;
  self->at[3][4] = 0.0;
  self->at[4][4] = 1.0;
  self->at[5][4] = 0.0;
  self->at[0][5] = 0.0;
  self->at[1][5] = 0.0;
  self->at[2][5] = 0.0;
  self->at[3][5] = 0.0;
  self->at[4][5] = 0.0;
  self->at[5][5] = 1.0;
}

/* Mo = M^T.
   M, Mo: 6×6 operator.
   No arithmetic.
   Exact. */
static inline void ksl_mat6x6_transposed(const ksl_mat6x6_t *M, ksl_mat6x6_t *Mo) {
  const double M_at_00 = M->at[0][0];
  const double M_at_01 = M->at[0][1];
  const double M_at_02 = M->at[0][2];
  const double M_at_03 = M->at[0][3];
  const double M_at_04 = M->at[0][4];
  const double M_at_05 = M->at[0][5];
  const double M_at_10 = M->at[1][0];
  const double M_at_11 = M->at[1][1];
  const double M_at_12 = M->at[1][2];
  const double M_at_13 = M->at[1][3];
  const double M_at_14 = M->at[1][4];
  const double M_at_15 = M->at[1][5];
  const double M_at_20 = M->at[2][0];
  const double M_at_21 = M->at[2][1];
  const double M_at_22 = M->at[2][2];
  const double M_at_23 = M->at[2][3];
  const double M_at_24 = M->at[2][4];
  const double M_at_25 = M->at[2][5];
  const double M_at_30 = M->at[3][0];
  const double M_at_31 = M->at[3][1];
  const double M_at_32 = M->at[3][2];
  const double M_at_33 = M->at[3][3];
  const double M_at_34 = M->at[3][4];
  const double M_at_35 = M->at[3][5];
  const double M_at_40 = M->at[4][0];
  const double M_at_41 = M->at[4][1];
  const double M_at_42 = M->at[4][2];
  const double M_at_43 = M->at[4][3];
  const double M_at_44 = M->at[4][4];
  const double M_at_45 = M->at[4][5];
  const double M_at_50 = M->at[5][0];
  const double M_at_51 = M->at[5][1];
  const double M_at_52 = M->at[5][2];
  const double M_at_53 = M->at[5][3];
  const double M_at_54 = M->at[5][4];
  const double M_at_55 = M->at[5][5];
  Mo->at[0][0] = M_at_00;
  Mo->at[1][0] = M_at_01;
  Mo->at[2][0] = M_at_02;
  Mo->at[3][0] = M_at_03;
  Mo->at[4][0] = M_at_04;
  Mo->at[5][0] = M_at_05;
  Mo->at[0][1] = M_at_10;
  Mo->at[1][1] = M_at_11;
  Mo->at[2][1] = M_at_12;
  Mo->at[3][1] = M_at_13;
  Mo->at[4][1] = M_at_14;
  Mo->at[5][1] = M_at_15;
  Mo->at[0][2] = M_at_20;
  Mo->at[1][2] = M_at_21;
  Mo->at[2][2] = M_at_22;
  Mo->at[3][2] = M_at_23;
  Mo->at[4][2] = M_at_24;
  Mo->at[5][2] = M_at_25;
  Mo->at[0][3] = M_at_30;
  Mo->at[1][3] = M_at_31;
  Mo->at[2][3] = M_at_32;
  Mo->at[3][3] = M_at_33;
  Mo->at[4][3] = M_at_34;
  Mo->at[5][3] = M_at_35;
  Mo->at[0][4] = M_at_40;
  Mo->at[1][4] = M_at_41;
  Mo->at[2][4] = M_at_42;
  Mo->at[3][4] = M_at_43;
  Mo->at[4][4] = M_at_44;
  Mo->at[5][4] = M_at_45;
  Mo->at[0][5] = M_at_50;
  Mo->at[1][5] = M_at_51;
  Mo->at[2][5] = M_at_52;
  Mo->at[3][5] = M_at_53;
  Mo->at[4][5] = M_at_54;
  Mo->at[5][5] = M_at_55;
}

/* Mo = [Ad]*(R) M [Ad]^-1(R), the articulated inertia M rotated by R; M is symmetric, only its
     lower triangle is read.
   R: rotation or other 3×3 matrix; M, Mo: 6×6 operator.
   144 mul, 96 add.
   Error <= u |result| + 5 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_mat6x6_rotated(const ksl_mat3x3_t *R, const ksl_mat6x6_t *M,
    ksl_mat6x6_t *Mo) {
  const double RM_0 = KSL_MUL(R->m00, M->at[0][0]) + KSL_MUL(R->m01, M->at[0][1])
          + KSL_MUL(R->m02, M->at[0][2]),
      RM_1 = KSL_MUL(R->m00, M->at[0][1]) + KSL_MUL(R->m01, M->at[1][1])
          + KSL_MUL(R->m02, M->at[1][2]),
      RM_2 = KSL_MUL(R->m00, M->at[0][2]) + KSL_MUL(R->m01, M->at[1][2])
          + KSL_MUL(R->m02, M->at[2][2]),
      RM_3 = KSL_MUL(R->m10, M->at[0][0]) + KSL_MUL(R->m11, M->at[0][1])
          + KSL_MUL(R->m12, M->at[0][2]),
      RM_4 = KSL_MUL(R->m10, M->at[0][1]) + KSL_MUL(R->m11, M->at[1][1])
          + KSL_MUL(R->m12, M->at[1][2]),
      RM_5 = KSL_MUL(R->m10, M->at[0][2]) + KSL_MUL(R->m11, M->at[1][2])
          + KSL_MUL(R->m12, M->at[2][2]),
      RM_6 = KSL_MUL(R->m20, M->at[0][0]) + KSL_MUL(R->m21, M->at[0][1])
          + KSL_MUL(R->m22, M->at[0][2]),
      RM_7 = KSL_MUL(R->m20, M->at[0][1]) + KSL_MUL(R->m21, M->at[1][1])
          + KSL_MUL(R->m22, M->at[1][2]),
      RM_8 = KSL_MUL(R->m20, M->at[0][2]) + KSL_MUL(R->m21, M->at[1][2])
          + KSL_MUL(R->m22, M->at[2][2]);
  const double linear_0 = KSL_MUL(R->m00, RM_0) + KSL_MUL(R->m01, RM_1) + KSL_MUL(R->m02, RM_2),
      linear_1 = KSL_MUL(R->m00, RM_3) + KSL_MUL(R->m01, RM_4) + KSL_MUL(R->m02, RM_5),
      linear_2 = KSL_MUL(R->m10, RM_3) + KSL_MUL(R->m11, RM_4) + KSL_MUL(R->m12, RM_5),
      linear_3 = KSL_MUL(R->m00, RM_6) + KSL_MUL(R->m01, RM_7) + KSL_MUL(R->m02, RM_8),
      linear_4 = KSL_MUL(R->m10, RM_6) + KSL_MUL(R->m11, RM_7) + KSL_MUL(R->m12, RM_8),
      linear_5 = KSL_MUL(R->m20, RM_6) + KSL_MUL(R->m21, RM_7) + KSL_MUL(R->m22, RM_8);
  const double RH_0 = KSL_MUL(R->m00, M->at[0][3]) + KSL_MUL(R->m01, M->at[0][4])
          + KSL_MUL(R->m02, M->at[0][5]),
      RH_1 = KSL_MUL(R->m00, M->at[1][3]) + KSL_MUL(R->m01, M->at[1][4])
          + KSL_MUL(R->m02, M->at[1][5]),
      RH_2 = KSL_MUL(R->m00, M->at[2][3]) + KSL_MUL(R->m01, M->at[2][4])
          + KSL_MUL(R->m02, M->at[2][5]),
      RH_3 = KSL_MUL(R->m10, M->at[0][3]) + KSL_MUL(R->m11, M->at[0][4])
          + KSL_MUL(R->m12, M->at[0][5]),
      RH_4 = KSL_MUL(R->m10, M->at[1][3]) + KSL_MUL(R->m11, M->at[1][4])
          + KSL_MUL(R->m12, M->at[1][5]),
      RH_5 = KSL_MUL(R->m10, M->at[2][3]) + KSL_MUL(R->m11, M->at[2][4])
          + KSL_MUL(R->m12, M->at[2][5]),
      RH_6 = KSL_MUL(R->m20, M->at[0][3]) + KSL_MUL(R->m21, M->at[0][4])
          + KSL_MUL(R->m22, M->at[0][5]),
      RH_7 = KSL_MUL(R->m20, M->at[1][3]) + KSL_MUL(R->m21, M->at[1][4])
          + KSL_MUL(R->m22, M->at[1][5]),
      RH_8 = KSL_MUL(R->m20, M->at[2][3]) + KSL_MUL(R->m21, M->at[2][4])
          + KSL_MUL(R->m22, M->at[2][5]);
  const double coupling_0 = KSL_MUL(R->m00, RH_0) + KSL_MUL(R->m01, RH_1) + KSL_MUL(R->m02, RH_2),
      coupling_1 = KSL_MUL(R->m10, RH_0) + KSL_MUL(R->m11, RH_1) + KSL_MUL(R->m12, RH_2),
      coupling_2 = KSL_MUL(R->m20, RH_0) + KSL_MUL(R->m21, RH_1) + KSL_MUL(R->m22, RH_2),
      coupling_3 = KSL_MUL(R->m00, RH_3) + KSL_MUL(R->m01, RH_4) + KSL_MUL(R->m02, RH_5),
      coupling_4 = KSL_MUL(R->m10, RH_3) + KSL_MUL(R->m11, RH_4) + KSL_MUL(R->m12, RH_5),
      coupling_5 = KSL_MUL(R->m20, RH_3) + KSL_MUL(R->m21, RH_4) + KSL_MUL(R->m22, RH_5),
      coupling_6 = KSL_MUL(R->m00, RH_6) + KSL_MUL(R->m01, RH_7) + KSL_MUL(R->m02, RH_8),
      coupling_7 = KSL_MUL(R->m10, RH_6) + KSL_MUL(R->m11, RH_7) + KSL_MUL(R->m12, RH_8),
      coupling_8 = KSL_MUL(R->m20, RH_6) + KSL_MUL(R->m21, RH_7) + KSL_MUL(R->m22, RH_8);
  const double RI_0 = KSL_MUL(R->m00, M->at[3][3]) + KSL_MUL(R->m01, M->at[3][4])
          + KSL_MUL(R->m02, M->at[3][5]),
      RI_1 = KSL_MUL(R->m00, M->at[3][4]) + KSL_MUL(R->m01, M->at[4][4])
          + KSL_MUL(R->m02, M->at[4][5]),
      RI_2 = KSL_MUL(R->m00, M->at[3][5]) + KSL_MUL(R->m01, M->at[4][5])
          + KSL_MUL(R->m02, M->at[5][5]),
      RI_3 = KSL_MUL(R->m10, M->at[3][3]) + KSL_MUL(R->m11, M->at[3][4])
          + KSL_MUL(R->m12, M->at[3][5]),
      RI_4 = KSL_MUL(R->m10, M->at[3][4]) + KSL_MUL(R->m11, M->at[4][4])
          + KSL_MUL(R->m12, M->at[4][5]),
      RI_5 = KSL_MUL(R->m10, M->at[3][5]) + KSL_MUL(R->m11, M->at[4][5])
          + KSL_MUL(R->m12, M->at[5][5]),
      RI_6 = KSL_MUL(R->m20, M->at[3][3]) + KSL_MUL(R->m21, M->at[3][4])
          + KSL_MUL(R->m22, M->at[3][5]),
      RI_7 = KSL_MUL(R->m20, M->at[3][4]) + KSL_MUL(R->m21, M->at[4][4])
          + KSL_MUL(R->m22, M->at[4][5]),
      RI_8 = KSL_MUL(R->m20, M->at[3][5]) + KSL_MUL(R->m21, M->at[4][5])
          + KSL_MUL(R->m22, M->at[5][5]);
  const double angular_0 = KSL_MUL(R->m00, RI_0) + KSL_MUL(R->m01, RI_1) + KSL_MUL(R->m02, RI_2),
      angular_1 = KSL_MUL(R->m00, RI_3) + KSL_MUL(R->m01, RI_4) + KSL_MUL(R->m02, RI_5),
      angular_2 = KSL_MUL(R->m10, RI_3) + KSL_MUL(R->m11, RI_4) + KSL_MUL(R->m12, RI_5),
      angular_3 = KSL_MUL(R->m00, RI_6) + KSL_MUL(R->m01, RI_7) + KSL_MUL(R->m02, RI_8),
      angular_4 = KSL_MUL(R->m10, RI_6) + KSL_MUL(R->m11, RI_7) + KSL_MUL(R->m12, RI_8),
      angular_5 = KSL_MUL(R->m20, RI_6) + KSL_MUL(R->m21, RI_7) + KSL_MUL(R->m22, RI_8);
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
   39 mul, 42 add.
   Error <= u |result| + 6 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_mat6x6_shifted(const ksl_vec3_t *t, const ksl_mat6x6_t *M,
    ksl_mat6x6_t *Mo) {
  const double G_0a = KSL_MUL(t->y, M->at[0][2]), G_0b = KSL_MUL(t->z, M->at[0][1]),
      G_0 = G_0a - G_0b + M->at[0][3];
  const double G_1 = KSL_MUL(t->y, M->at[1][2]) - KSL_MUL(t->z, M->at[1][1]) + M->at[1][3],
      G_2 = KSL_MUL(t->y, M->at[2][2]) - KSL_MUL(t->z, M->at[1][2]) + M->at[2][3],
      G_3 = KSL_MUL(t->z, M->at[0][0]) - KSL_MUL(t->x, M->at[0][2]) + M->at[0][4];
  const double G_4a = KSL_MUL(t->x, M->at[1][2]), G_4 = G_0b - G_4a + M->at[1][4];
  const double G_5 = KSL_MUL(t->z, M->at[0][2]) - KSL_MUL(t->x, M->at[2][2]) + M->at[2][4],
      G_6 = KSL_MUL(t->x, M->at[0][1]) - KSL_MUL(t->y, M->at[0][0]) + M->at[0][5],
      G_7 = KSL_MUL(t->x, M->at[1][1]) - KSL_MUL(t->y, M->at[0][1]) + M->at[1][5],
      G_8 = G_4a - G_0a + M->at[2][5];
  const double moved_0 = KSL_MUL(t->y, M->at[2][3]) - KSL_MUL(t->z, M->at[1][3])
          + (KSL_MUL(t->y, G_2) - KSL_MUL(t->z, G_1)) + M->at[3][3],
      moved_1 = KSL_MUL(t->z, M->at[0][3]) - KSL_MUL(t->x, M->at[2][3])
          + (KSL_MUL(t->y, G_5) - KSL_MUL(t->z, G_4)) + M->at[3][4],
      moved_2 = KSL_MUL(t->z, M->at[0][4]) - KSL_MUL(t->x, M->at[2][4])
          + (KSL_MUL(t->z, G_3) - KSL_MUL(t->x, G_5)) + M->at[4][4],
      moved_3 = KSL_MUL(t->x, M->at[1][3]) - KSL_MUL(t->y, M->at[0][3])
          + (KSL_MUL(t->y, G_8) - KSL_MUL(t->z, G_7)) + M->at[3][5],
      moved_4 = KSL_MUL(t->x, M->at[1][4]) - KSL_MUL(t->y, M->at[0][4])
          + (KSL_MUL(t->z, G_6) - KSL_MUL(t->x, G_8)) + M->at[4][5],
      moved_5 = KSL_MUL(t->x, M->at[1][5]) - KSL_MUL(t->y, M->at[0][5])
          + (KSL_MUL(t->x, G_7) - KSL_MUL(t->y, G_6)) + M->at[5][5];
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

/* The entry of M at (row, column), for 0 <= row < 6 and 0 <= column < 6; NaN outside. */
static inline float ksl_mat6x6f_get(const ksl_mat6x6f_t *M, const int row, const int column) {
  return row >= 0 && row < 6 && column >= 0 && column < 6 ? M->at[column][row] : (float)NAN;
}

/* Sets the entry of M at (row, column), for 0 <= row < 6 and 0 <= column < 6; does nothing
     outside. */
static inline void ksl_mat6x6f_set(ksl_mat6x6f_t *M, const int row, const int column,
    const float value) {
  if (row >= 0 && row < 6 && column >= 0 && column < 6) {
    M->at[column][row] = value;
  }
}

/* Mo = M.
   M, Mo: 6×6 operator.
   No arithmetic.
   Exact. */
static inline void ksl_mat6x6f_copy(const ksl_mat6x6f_t *M, ksl_mat6x6f_t *Mo) {
  const float M_at_00 = M->at[0][0];
  const float M_at_10 = M->at[1][0];
  const float M_at_20 = M->at[2][0];
  const float M_at_30 = M->at[3][0];
  const float M_at_40 = M->at[4][0];
  const float M_at_50 = M->at[5][0];
  const float M_at_01 = M->at[0][1];
  const float M_at_11 = M->at[1][1];
  const float M_at_21 = M->at[2][1];
  const float M_at_31 = M->at[3][1];
  const float M_at_41 = M->at[4][1];
  const float M_at_51 = M->at[5][1];
  const float M_at_02 = M->at[0][2];
  const float M_at_12 = M->at[1][2];
  const float M_at_22 = M->at[2][2];
  const float M_at_32 = M->at[3][2];
  const float M_at_42 = M->at[4][2];
  const float M_at_52 = M->at[5][2];
  const float M_at_03 = M->at[0][3];
  const float M_at_13 = M->at[1][3];
  const float M_at_23 = M->at[2][3];
  const float M_at_33 = M->at[3][3];
  const float M_at_43 = M->at[4][3];
  const float M_at_53 = M->at[5][3];
  const float M_at_04 = M->at[0][4];
  const float M_at_14 = M->at[1][4];
  const float M_at_24 = M->at[2][4];
  const float M_at_34 = M->at[3][4];
  const float M_at_44 = M->at[4][4];
  const float M_at_54 = M->at[5][4];
  const float M_at_05 = M->at[0][5];
  const float M_at_15 = M->at[1][5];
  const float M_at_25 = M->at[2][5];
  const float M_at_35 = M->at[3][5];
  const float M_at_45 = M->at[4][5];
  const float M_at_55 = M->at[5][5];
  Mo->at[0][0] = M_at_00;
  Mo->at[1][0] = M_at_10;
  Mo->at[2][0] = M_at_20;
  Mo->at[3][0] = M_at_30;
  Mo->at[4][0] = M_at_40;
  Mo->at[5][0] = M_at_50;
  Mo->at[0][1] = M_at_01;
  Mo->at[1][1] = M_at_11;
  Mo->at[2][1] = M_at_21;
  Mo->at[3][1] = M_at_31;
  Mo->at[4][1] = M_at_41;
  Mo->at[5][1] = M_at_51;
  Mo->at[0][2] = M_at_02;
  Mo->at[1][2] = M_at_12;
  Mo->at[2][2] = M_at_22;
  Mo->at[3][2] = M_at_32;
  Mo->at[4][2] = M_at_42;
  Mo->at[5][2] = M_at_52;
  Mo->at[0][3] = M_at_03;
  Mo->at[1][3] = M_at_13;
  Mo->at[2][3] = M_at_23;
  Mo->at[3][3] = M_at_33;
  Mo->at[4][3] = M_at_43;
  Mo->at[5][3] = M_at_53;
  Mo->at[0][4] = M_at_04;
  Mo->at[1][4] = M_at_14;
  Mo->at[2][4] = M_at_24;
  Mo->at[3][4] = M_at_34;
  Mo->at[4][4] = M_at_44;
  Mo->at[5][4] = M_at_54;
  Mo->at[0][5] = M_at_05;
  Mo->at[1][5] = M_at_15;
  Mo->at[2][5] = M_at_25;
  Mo->at[3][5] = M_at_35;
  Mo->at[4][5] = M_at_45;
  Mo->at[5][5] = M_at_55;
}

/* self = I.
   self: 6×6 operator.
   No arithmetic.
   Exact. */
static inline void ksl_mat6x6f_setIdentity(ksl_mat6x6f_t *self) {
  self->at[0][0] = 1.0f;
  self->at[1][0] = 0.0f;
  self->at[2][0] = 0.0f;
  self->at[3][0] = 0.0f;
  self->at[4][0] = 0.0f;
  self->at[5][0] = 0.0f;
  self->at[0][1] = 0.0f;
  self->at[1][1] = 1.0f;
  self->at[2][1] = 0.0f;
  self->at[3][1] = 0.0f;
  self->at[4][1] = 0.0f;
  self->at[5][1] = 0.0f;
  self->at[0][2] = 0.0f;
  self->at[1][2] = 0.0f;
  self->at[2][2] = 1.0f;
  self->at[3][2] = 0.0f;
  self->at[4][2] = 0.0f;
  self->at[5][2] = 0.0f;
  self->at[0][3] = 0.0f;
  self->at[1][3] = 0.0f;
  self->at[2][3] = 0.0f;
  self->at[3][3] = 1.0f;
  self->at[4][3] = 0.0f;
  self->at[5][3] = 0.0f;
  self->at[0][4] = 0.0f;
  self->at[1][4] = 0.0f;
  self->at[2][4] = 0.0f;
  self->at[3][4] = 0.0f;
  self->at[4][4] = 1.0f;
  self->at[5][4] = 0.0f;
  self->at[0][5] = 0.0f;
  self->at[1][5] = 0.0f;
  self->at[2][5] = 0.0f;
  self->at[3][5] = 0.0f;
  self->at[4][5] = 0.0f;
  self->at[5][5] = 1.0f;
}

/* Mo = M^T.
   M, Mo: 6×6 operator.
   No arithmetic.
   Exact. */
static inline void ksl_mat6x6f_transposed(const ksl_mat6x6f_t *M, ksl_mat6x6f_t *Mo) {
  const float M_at_00 = M->at[0][0];
  const float M_at_01 = M->at[0][1];
  const float M_at_02 = M->at[0][2];
  const float M_at_03 = M->at[0][3];
  const float M_at_04 = M->at[0][4];
  const float M_at_05 = M->at[0][5];
  const float M_at_10 = M->at[1][0];
  const float M_at_11 = M->at[1][1];
  const float M_at_12 = M->at[1][2];
  const float M_at_13 = M->at[1][3];
  const float M_at_14 = M->at[1][4];
  const float M_at_15 = M->at[1][5];
  const float M_at_20 = M->at[2][0];
  const float M_at_21 = M->at[2][1];
  const float M_at_22 = M->at[2][2];
  const float M_at_23 = M->at[2][3];
  const float M_at_24 = M->at[2][4];
  const float M_at_25 = M->at[2][5];
  const float M_at_30 = M->at[3][0];
  const float M_at_31 = M->at[3][1];
  const float M_at_32 = M->at[3][2];
  const float M_at_33 = M->at[3][3];
  const float M_at_34 = M->at[3][4];
  const float M_at_35 = M->at[3][5];
  const float M_at_40 = M->at[4][0];
  const float M_at_41 = M->at[4][1];
  const float M_at_42 = M->at[4][2];
  const float M_at_43 = M->at[4][3];
  const float M_at_44 = M->at[4][4];
  const float M_at_45 = M->at[4][5];
  const float M_at_50 = M->at[5][0];
  const float M_at_51 = M->at[5][1];
  const float M_at_52 = M->at[5][2];
  const float M_at_53 = M->at[5][3];
  const float M_at_54 = M->at[5][4];
  const float M_at_55 = M->at[5][5];
  Mo->at[0][0] = M_at_00;
  Mo->at[1][0] = M_at_01;
  Mo->at[2][0] = M_at_02;
  Mo->at[3][0] = M_at_03;
  Mo->at[4][0] = M_at_04;
  Mo->at[5][0] = M_at_05;
  Mo->at[0][1] = M_at_10;
  Mo->at[1][1] = M_at_11;
  Mo->at[2][1] = M_at_12;
  Mo->at[3][1] = M_at_13;
  Mo->at[4][1] = M_at_14;
  Mo->at[5][1] = M_at_15;
  Mo->at[0][2] = M_at_20;
  Mo->at[1][2] = M_at_21;
  Mo->at[2][2] = M_at_22;
  Mo->at[3][2] = M_at_23;
  Mo->at[4][2] = M_at_24;
  Mo->at[5][2] = M_at_25;
  Mo->at[0][3] = M_at_30;
  Mo->at[1][3] = M_at_31;
  Mo->at[2][3] = M_at_32;
  Mo->at[3][3] = M_at_33;
  Mo->at[4][3] = M_at_34;
  Mo->at[5][3] = M_at_35;
  Mo->at[0][4] = M_at_40;
  Mo->at[1][4] = M_at_41;
  Mo->at[2][4] = M_at_42;
  Mo->at[3][4] = M_at_43;
  Mo->at[4][4] = M_at_44;
  Mo->at[5][4] = M_at_45;
  Mo->at[0][5] = M_at_50;
  Mo->at[1][5] = M_at_51;
  Mo->at[2][5] = M_at_52;
  Mo->at[3][5] = M_at_53;
  Mo->at[4][5] = M_at_54;
  Mo->at[5][5] = M_at_55;
}

/* Mo = [Ad]*(R) M [Ad]^-1(R), the articulated inertia M rotated by R; M is symmetric, only its
     lower triangle is read.
   R: rotation or other 3×3 matrix; M, Mo: 6×6 operator.
   144 mul, 96 add.
   Error <= u |result| + 5 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_mat6x6f_rotated(const ksl_mat3x3f_t *R, const ksl_mat6x6f_t *M,
    ksl_mat6x6f_t *Mo) {
  const float RM_0 = KSL_MULF(R->m00, M->at[0][0]) + KSL_MULF(R->m01, M->at[0][1])
          + KSL_MULF(R->m02, M->at[0][2]),
      RM_1 = KSL_MULF(R->m00, M->at[0][1]) + KSL_MULF(R->m01, M->at[1][1])
          + KSL_MULF(R->m02, M->at[1][2]),
      RM_2 = KSL_MULF(R->m00, M->at[0][2]) + KSL_MULF(R->m01, M->at[1][2])
          + KSL_MULF(R->m02, M->at[2][2]),
      RM_3 = KSL_MULF(R->m10, M->at[0][0]) + KSL_MULF(R->m11, M->at[0][1])
          + KSL_MULF(R->m12, M->at[0][2]),
      RM_4 = KSL_MULF(R->m10, M->at[0][1]) + KSL_MULF(R->m11, M->at[1][1])
          + KSL_MULF(R->m12, M->at[1][2]),
      RM_5 = KSL_MULF(R->m10, M->at[0][2]) + KSL_MULF(R->m11, M->at[1][2])
          + KSL_MULF(R->m12, M->at[2][2]),
      RM_6 = KSL_MULF(R->m20, M->at[0][0]) + KSL_MULF(R->m21, M->at[0][1])
          + KSL_MULF(R->m22, M->at[0][2]),
      RM_7 = KSL_MULF(R->m20, M->at[0][1]) + KSL_MULF(R->m21, M->at[1][1])
          + KSL_MULF(R->m22, M->at[1][2]),
      RM_8 = KSL_MULF(R->m20, M->at[0][2]) + KSL_MULF(R->m21, M->at[1][2])
          + KSL_MULF(R->m22, M->at[2][2]);
  const float linear_0 = KSL_MULF(R->m00, RM_0) + KSL_MULF(R->m01, RM_1) + KSL_MULF(R->m02, RM_2),
      linear_1 = KSL_MULF(R->m00, RM_3) + KSL_MULF(R->m01, RM_4) + KSL_MULF(R->m02, RM_5),
      linear_2 = KSL_MULF(R->m10, RM_3) + KSL_MULF(R->m11, RM_4) + KSL_MULF(R->m12, RM_5),
      linear_3 = KSL_MULF(R->m00, RM_6) + KSL_MULF(R->m01, RM_7) + KSL_MULF(R->m02, RM_8),
      linear_4 = KSL_MULF(R->m10, RM_6) + KSL_MULF(R->m11, RM_7) + KSL_MULF(R->m12, RM_8),
      linear_5 = KSL_MULF(R->m20, RM_6) + KSL_MULF(R->m21, RM_7) + KSL_MULF(R->m22, RM_8);
  const float RH_0 = KSL_MULF(R->m00, M->at[0][3]) + KSL_MULF(R->m01, M->at[0][4])
          + KSL_MULF(R->m02, M->at[0][5]),
      RH_1 = KSL_MULF(R->m00, M->at[1][3]) + KSL_MULF(R->m01, M->at[1][4])
          + KSL_MULF(R->m02, M->at[1][5]),
      RH_2 = KSL_MULF(R->m00, M->at[2][3]) + KSL_MULF(R->m01, M->at[2][4])
          + KSL_MULF(R->m02, M->at[2][5]),
      RH_3 = KSL_MULF(R->m10, M->at[0][3]) + KSL_MULF(R->m11, M->at[0][4])
          + KSL_MULF(R->m12, M->at[0][5]),
      RH_4 = KSL_MULF(R->m10, M->at[1][3]) + KSL_MULF(R->m11, M->at[1][4])
          + KSL_MULF(R->m12, M->at[1][5]),
      RH_5 = KSL_MULF(R->m10, M->at[2][3]) + KSL_MULF(R->m11, M->at[2][4])
          + KSL_MULF(R->m12, M->at[2][5]),
      RH_6 = KSL_MULF(R->m20, M->at[0][3]) + KSL_MULF(R->m21, M->at[0][4])
          + KSL_MULF(R->m22, M->at[0][5]),
      RH_7 = KSL_MULF(R->m20, M->at[1][3]) + KSL_MULF(R->m21, M->at[1][4])
          + KSL_MULF(R->m22, M->at[1][5]),
      RH_8 = KSL_MULF(R->m20, M->at[2][3]) + KSL_MULF(R->m21, M->at[2][4])
          + KSL_MULF(R->m22, M->at[2][5]);
  const float coupling_0 = KSL_MULF(R->m00, RH_0) + KSL_MULF(R->m01, RH_1) + KSL_MULF(R->m02, RH_2),
      coupling_1 = KSL_MULF(R->m10, RH_0) + KSL_MULF(R->m11, RH_1) + KSL_MULF(R->m12, RH_2),
      coupling_2 = KSL_MULF(R->m20, RH_0) + KSL_MULF(R->m21, RH_1) + KSL_MULF(R->m22, RH_2),
      coupling_3 = KSL_MULF(R->m00, RH_3) + KSL_MULF(R->m01, RH_4) + KSL_MULF(R->m02, RH_5),
      coupling_4 = KSL_MULF(R->m10, RH_3) + KSL_MULF(R->m11, RH_4) + KSL_MULF(R->m12, RH_5),
      coupling_5 = KSL_MULF(R->m20, RH_3) + KSL_MULF(R->m21, RH_4) + KSL_MULF(R->m22, RH_5),
      coupling_6 = KSL_MULF(R->m00, RH_6) + KSL_MULF(R->m01, RH_7) + KSL_MULF(R->m02, RH_8),
      coupling_7 = KSL_MULF(R->m10, RH_6) + KSL_MULF(R->m11, RH_7) + KSL_MULF(R->m12, RH_8),
      coupling_8 = KSL_MULF(R->m20, RH_6) + KSL_MULF(R->m21, RH_7) + KSL_MULF(R->m22, RH_8);
  const float RI_0 = KSL_MULF(R->m00, M->at[3][3]) + KSL_MULF(R->m01, M->at[3][4])
          + KSL_MULF(R->m02, M->at[3][5]),
      RI_1 = KSL_MULF(R->m00, M->at[3][4]) + KSL_MULF(R->m01, M->at[4][4])
          + KSL_MULF(R->m02, M->at[4][5]),
      RI_2 = KSL_MULF(R->m00, M->at[3][5]) + KSL_MULF(R->m01, M->at[4][5])
          + KSL_MULF(R->m02, M->at[5][5]),
      RI_3 = KSL_MULF(R->m10, M->at[3][3]) + KSL_MULF(R->m11, M->at[3][4])
          + KSL_MULF(R->m12, M->at[3][5]),
      RI_4 = KSL_MULF(R->m10, M->at[3][4]) + KSL_MULF(R->m11, M->at[4][4])
          + KSL_MULF(R->m12, M->at[4][5]),
      RI_5 = KSL_MULF(R->m10, M->at[3][5]) + KSL_MULF(R->m11, M->at[4][5])
          + KSL_MULF(R->m12, M->at[5][5]),
      RI_6 = KSL_MULF(R->m20, M->at[3][3]) + KSL_MULF(R->m21, M->at[3][4])
          + KSL_MULF(R->m22, M->at[3][5]),
      RI_7 = KSL_MULF(R->m20, M->at[3][4]) + KSL_MULF(R->m21, M->at[4][4])
          + KSL_MULF(R->m22, M->at[4][5]),
      RI_8 = KSL_MULF(R->m20, M->at[3][5]) + KSL_MULF(R->m21, M->at[4][5])
          + KSL_MULF(R->m22, M->at[5][5]);
  const float angular_0 = KSL_MULF(R->m00, RI_0) + KSL_MULF(R->m01, RI_1) + KSL_MULF(R->m02, RI_2),
      angular_1 = KSL_MULF(R->m00, RI_3) + KSL_MULF(R->m01, RI_4) + KSL_MULF(R->m02, RI_5),
      angular_2 = KSL_MULF(R->m10, RI_3) + KSL_MULF(R->m11, RI_4) + KSL_MULF(R->m12, RI_5),
      angular_3 = KSL_MULF(R->m00, RI_6) + KSL_MULF(R->m01, RI_7) + KSL_MULF(R->m02, RI_8),
      angular_4 = KSL_MULF(R->m10, RI_6) + KSL_MULF(R->m11, RI_7) + KSL_MULF(R->m12, RI_8),
      angular_5 = KSL_MULF(R->m20, RI_6) + KSL_MULF(R->m21, RI_7) + KSL_MULF(R->m22, RI_8);
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
   39 mul, 42 add.
   Error <= u |result| + 6 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_mat6x6f_shifted(const ksl_vec3f_t *t, const ksl_mat6x6f_t *M,
    ksl_mat6x6f_t *Mo) {
  const float G_0a = KSL_MULF(t->y, M->at[0][2]), G_0b = KSL_MULF(t->z, M->at[0][1]),
      G_0 = G_0a - G_0b + M->at[0][3];
  const float G_1 = KSL_MULF(t->y, M->at[1][2]) - KSL_MULF(t->z, M->at[1][1]) + M->at[1][3],
      G_2 = KSL_MULF(t->y, M->at[2][2]) - KSL_MULF(t->z, M->at[1][2]) + M->at[2][3],
      G_3 = KSL_MULF(t->z, M->at[0][0]) - KSL_MULF(t->x, M->at[0][2]) + M->at[0][4];
  const float G_4a = KSL_MULF(t->x, M->at[1][2]), G_4 = G_0b - G_4a + M->at[1][4];
  const float G_5 = KSL_MULF(t->z, M->at[0][2]) - KSL_MULF(t->x, M->at[2][2]) + M->at[2][4],
      G_6 = KSL_MULF(t->x, M->at[0][1]) - KSL_MULF(t->y, M->at[0][0]) + M->at[0][5],
      G_7 = KSL_MULF(t->x, M->at[1][1]) - KSL_MULF(t->y, M->at[0][1]) + M->at[1][5],
      G_8 = G_4a - G_0a + M->at[2][5];
  const float moved_0 = KSL_MULF(t->y, M->at[2][3]) - KSL_MULF(t->z, M->at[1][3])
          + (KSL_MULF(t->y, G_2) - KSL_MULF(t->z, G_1)) + M->at[3][3],
      moved_1 = KSL_MULF(t->z, M->at[0][3]) - KSL_MULF(t->x, M->at[2][3])
          + (KSL_MULF(t->y, G_5) - KSL_MULF(t->z, G_4)) + M->at[3][4],
      moved_2 = KSL_MULF(t->z, M->at[0][4]) - KSL_MULF(t->x, M->at[2][4])
          + (KSL_MULF(t->z, G_3) - KSL_MULF(t->x, G_5)) + M->at[4][4],
      moved_3 = KSL_MULF(t->x, M->at[1][3]) - KSL_MULF(t->y, M->at[0][3])
          + (KSL_MULF(t->y, G_8) - KSL_MULF(t->z, G_7)) + M->at[3][5],
      moved_4 = KSL_MULF(t->x, M->at[1][4]) - KSL_MULF(t->y, M->at[0][4])
          + (KSL_MULF(t->z, G_6) - KSL_MULF(t->x, G_8)) + M->at[4][5],
      moved_5 = KSL_MULF(t->x, M->at[1][5]) - KSL_MULF(t->y, M->at[0][5])
          + (KSL_MULF(t->x, G_7) - KSL_MULF(t->y, G_6)) + M->at[5][5];
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

#ifndef KSL_NO_ALLOC
#include <stdlib.h>

/* n ksl_mat6x6_t on the heap, zeros, to be freed by the caller; NULL for n <= 0 or when there is
     no memory. */
static inline ksl_mat6x6_t *ksl_mat6x6_alloc(int n) {
  return n > 0 ? (ksl_mat6x6_t *)calloc((size_t)n, sizeof(ksl_mat6x6_t)) : NULL;
}

/* n ksl_mat6x6f_t on the heap, zeros, to be freed by the caller; NULL for n <= 0 or when there
     is no memory. */
static inline ksl_mat6x6f_t *ksl_mat6x6f_alloc(int n) {
  return n > 0 ? (ksl_mat6x6f_t *)calloc((size_t)n, sizeof(ksl_mat6x6f_t)) : NULL;
}

#endif

#endif
