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
  const double RM_0a = KSL_MUL(R->m00, M->at[0][0]), RM_0b = KSL_MUL(R->m01, M->at[0][1]),
      RM_0c = RM_0a + RM_0b, RM_0d = KSL_MUL(R->m02, M->at[0][2]), RM_0 = RM_0c + RM_0d;
  const double RM_1a = KSL_MUL(R->m00, M->at[0][1]), RM_1b = KSL_MUL(R->m01, M->at[1][1]),
      RM_1c = RM_1a + RM_1b, RM_1d = KSL_MUL(R->m02, M->at[1][2]), RM_1 = RM_1c + RM_1d;
  const double RM_2a = KSL_MUL(R->m00, M->at[0][2]), RM_2b = KSL_MUL(R->m01, M->at[1][2]),
      RM_2c = RM_2a + RM_2b, RM_2d = KSL_MUL(R->m02, M->at[2][2]), RM_2 = RM_2c + RM_2d;
  const double RM_3a = KSL_MUL(R->m10, M->at[0][0]), RM_3b = KSL_MUL(R->m11, M->at[0][1]),
      RM_3c = RM_3a + RM_3b, RM_3d = KSL_MUL(R->m12, M->at[0][2]), RM_3 = RM_3c + RM_3d;
  const double RM_4a = KSL_MUL(R->m10, M->at[0][1]), RM_4b = KSL_MUL(R->m11, M->at[1][1]),
      RM_4c = RM_4a + RM_4b, RM_4d = KSL_MUL(R->m12, M->at[1][2]), RM_4 = RM_4c + RM_4d;
  const double RM_5a = KSL_MUL(R->m10, M->at[0][2]), RM_5b = KSL_MUL(R->m11, M->at[1][2]),
      RM_5c = RM_5a + RM_5b, RM_5d = KSL_MUL(R->m12, M->at[2][2]), RM_5 = RM_5c + RM_5d;
  const double RM_6a = KSL_MUL(R->m20, M->at[0][0]), RM_6b = KSL_MUL(R->m21, M->at[0][1]),
      RM_6c = RM_6a + RM_6b, RM_6d = KSL_MUL(R->m22, M->at[0][2]), RM_6 = RM_6c + RM_6d;
  const double RM_7a = KSL_MUL(R->m20, M->at[0][1]), RM_7b = KSL_MUL(R->m21, M->at[1][1]),
      RM_7c = RM_7a + RM_7b, RM_7d = KSL_MUL(R->m22, M->at[1][2]), RM_7 = RM_7c + RM_7d;
  const double RM_8a = KSL_MUL(R->m20, M->at[0][2]), RM_8b = KSL_MUL(R->m21, M->at[1][2]),
      RM_8c = RM_8a + RM_8b, RM_8d = KSL_MUL(R->m22, M->at[2][2]), RM_8 = RM_8c + RM_8d;
  const double linear_0a = KSL_MUL(R->m00, RM_0), linear_0b = KSL_MUL(R->m01, RM_1),
      linear_0c = linear_0a + linear_0b, linear_0d = KSL_MUL(R->m02, RM_2),
      linear_0 = linear_0c + linear_0d;
  const double linear_1a = KSL_MUL(R->m00, RM_3), linear_1b = KSL_MUL(R->m01, RM_4),
      linear_1c = linear_1a + linear_1b, linear_1d = KSL_MUL(R->m02, RM_5),
      linear_1 = linear_1c + linear_1d;
  const double linear_2a = KSL_MUL(R->m10, RM_3), linear_2b = KSL_MUL(R->m11, RM_4),
      linear_2c = linear_2a + linear_2b, linear_2d = KSL_MUL(R->m12, RM_5),
      linear_2 = linear_2c + linear_2d;
  const double linear_3a = KSL_MUL(R->m00, RM_6), linear_3b = KSL_MUL(R->m01, RM_7),
      linear_3c = linear_3a + linear_3b, linear_3d = KSL_MUL(R->m02, RM_8),
      linear_3 = linear_3c + linear_3d;
  const double linear_4a = KSL_MUL(R->m10, RM_6), linear_4b = KSL_MUL(R->m11, RM_7),
      linear_4c = linear_4a + linear_4b, linear_4d = KSL_MUL(R->m12, RM_8),
      linear_4 = linear_4c + linear_4d;
  const double linear_5a = KSL_MUL(R->m20, RM_6), linear_5b = KSL_MUL(R->m21, RM_7),
      linear_5c = linear_5a + linear_5b, linear_5d = KSL_MUL(R->m22, RM_8),
      linear_5 = linear_5c + linear_5d;
  const double RH_0a = KSL_MUL(R->m00, M->at[0][3]), RH_0b = KSL_MUL(R->m01, M->at[0][4]),
      RH_0c = RH_0a + RH_0b, RH_0d = KSL_MUL(R->m02, M->at[0][5]), RH_0 = RH_0c + RH_0d;
  const double RH_1a = KSL_MUL(R->m00, M->at[1][3]), RH_1b = KSL_MUL(R->m01, M->at[1][4]),
      RH_1c = RH_1a + RH_1b, RH_1d = KSL_MUL(R->m02, M->at[1][5]), RH_1 = RH_1c + RH_1d;
  const double RH_2a = KSL_MUL(R->m00, M->at[2][3]), RH_2b = KSL_MUL(R->m01, M->at[2][4]),
      RH_2c = RH_2a + RH_2b, RH_2d = KSL_MUL(R->m02, M->at[2][5]), RH_2 = RH_2c + RH_2d;
  const double RH_3a = KSL_MUL(R->m10, M->at[0][3]), RH_3b = KSL_MUL(R->m11, M->at[0][4]),
      RH_3c = RH_3a + RH_3b, RH_3d = KSL_MUL(R->m12, M->at[0][5]), RH_3 = RH_3c + RH_3d;
  const double RH_4a = KSL_MUL(R->m10, M->at[1][3]), RH_4b = KSL_MUL(R->m11, M->at[1][4]),
      RH_4c = RH_4a + RH_4b, RH_4d = KSL_MUL(R->m12, M->at[1][5]), RH_4 = RH_4c + RH_4d;
  const double RH_5a = KSL_MUL(R->m10, M->at[2][3]), RH_5b = KSL_MUL(R->m11, M->at[2][4]),
      RH_5c = RH_5a + RH_5b, RH_5d = KSL_MUL(R->m12, M->at[2][5]), RH_5 = RH_5c + RH_5d;
  const double RH_6a = KSL_MUL(R->m20, M->at[0][3]), RH_6b = KSL_MUL(R->m21, M->at[0][4]),
      RH_6c = RH_6a + RH_6b, RH_6d = KSL_MUL(R->m22, M->at[0][5]), RH_6 = RH_6c + RH_6d;
  const double RH_7a = KSL_MUL(R->m20, M->at[1][3]), RH_7b = KSL_MUL(R->m21, M->at[1][4]),
      RH_7c = RH_7a + RH_7b, RH_7d = KSL_MUL(R->m22, M->at[1][5]), RH_7 = RH_7c + RH_7d;
  const double RH_8a = KSL_MUL(R->m20, M->at[2][3]), RH_8b = KSL_MUL(R->m21, M->at[2][4]),
      RH_8c = RH_8a + RH_8b, RH_8d = KSL_MUL(R->m22, M->at[2][5]), RH_8 = RH_8c + RH_8d;
  const double coupling_0a = KSL_MUL(R->m00, RH_0), coupling_0b = KSL_MUL(R->m01, RH_1),
      coupling_0c = coupling_0a + coupling_0b, coupling_0d = KSL_MUL(R->m02, RH_2),
      coupling_0 = coupling_0c + coupling_0d;
  const double coupling_1a = KSL_MUL(R->m10, RH_0), coupling_1b = KSL_MUL(R->m11, RH_1),
      coupling_1c = coupling_1a + coupling_1b, coupling_1d = KSL_MUL(R->m12, RH_2),
      coupling_1 = coupling_1c + coupling_1d;
  const double coupling_2a = KSL_MUL(R->m20, RH_0), coupling_2b = KSL_MUL(R->m21, RH_1),
      coupling_2c = coupling_2a + coupling_2b, coupling_2d = KSL_MUL(R->m22, RH_2),
      coupling_2 = coupling_2c + coupling_2d;
  const double coupling_3a = KSL_MUL(R->m00, RH_3), coupling_3b = KSL_MUL(R->m01, RH_4),
      coupling_3c = coupling_3a + coupling_3b, coupling_3d = KSL_MUL(R->m02, RH_5),
      coupling_3 = coupling_3c + coupling_3d;
  const double coupling_4a = KSL_MUL(R->m10, RH_3), coupling_4b = KSL_MUL(R->m11, RH_4),
      coupling_4c = coupling_4a + coupling_4b, coupling_4d = KSL_MUL(R->m12, RH_5),
      coupling_4 = coupling_4c + coupling_4d;
  const double coupling_5a = KSL_MUL(R->m20, RH_3), coupling_5b = KSL_MUL(R->m21, RH_4),
      coupling_5c = coupling_5a + coupling_5b, coupling_5d = KSL_MUL(R->m22, RH_5),
      coupling_5 = coupling_5c + coupling_5d;
  const double coupling_6a = KSL_MUL(R->m00, RH_6), coupling_6b = KSL_MUL(R->m01, RH_7),
      coupling_6c = coupling_6a + coupling_6b, coupling_6d = KSL_MUL(R->m02, RH_8),
      coupling_6 = coupling_6c + coupling_6d;
  const double coupling_7a = KSL_MUL(R->m10, RH_6), coupling_7b = KSL_MUL(R->m11, RH_7),
      coupling_7c = coupling_7a + coupling_7b, coupling_7d = KSL_MUL(R->m12, RH_8),
      coupling_7 = coupling_7c + coupling_7d;
  const double coupling_8a = KSL_MUL(R->m20, RH_6), coupling_8b = KSL_MUL(R->m21, RH_7),
      coupling_8c = coupling_8a + coupling_8b, coupling_8d = KSL_MUL(R->m22, RH_8),
      coupling_8 = coupling_8c + coupling_8d;
  const double RI_0a = KSL_MUL(R->m00, M->at[3][3]), RI_0b = KSL_MUL(R->m01, M->at[3][4]),
      RI_0c = RI_0a + RI_0b, RI_0d = KSL_MUL(R->m02, M->at[3][5]), RI_0 = RI_0c + RI_0d;
  const double RI_1a = KSL_MUL(R->m00, M->at[3][4]), RI_1b = KSL_MUL(R->m01, M->at[4][4]),
      RI_1c = RI_1a + RI_1b, RI_1d = KSL_MUL(R->m02, M->at[4][5]), RI_1 = RI_1c + RI_1d;
  const double RI_2a = KSL_MUL(R->m00, M->at[3][5]), RI_2b = KSL_MUL(R->m01, M->at[4][5]),
      RI_2c = RI_2a + RI_2b, RI_2d = KSL_MUL(R->m02, M->at[5][5]), RI_2 = RI_2c + RI_2d;
  const double RI_3a = KSL_MUL(R->m10, M->at[3][3]), RI_3b = KSL_MUL(R->m11, M->at[3][4]),
      RI_3c = RI_3a + RI_3b, RI_3d = KSL_MUL(R->m12, M->at[3][5]), RI_3 = RI_3c + RI_3d;
  const double RI_4a = KSL_MUL(R->m10, M->at[3][4]), RI_4b = KSL_MUL(R->m11, M->at[4][4]),
      RI_4c = RI_4a + RI_4b, RI_4d = KSL_MUL(R->m12, M->at[4][5]), RI_4 = RI_4c + RI_4d;
  const double RI_5a = KSL_MUL(R->m10, M->at[3][5]), RI_5b = KSL_MUL(R->m11, M->at[4][5]),
      RI_5c = RI_5a + RI_5b, RI_5d = KSL_MUL(R->m12, M->at[5][5]), RI_5 = RI_5c + RI_5d;
  const double RI_6a = KSL_MUL(R->m20, M->at[3][3]), RI_6b = KSL_MUL(R->m21, M->at[3][4]),
      RI_6c = RI_6a + RI_6b, RI_6d = KSL_MUL(R->m22, M->at[3][5]), RI_6 = RI_6c + RI_6d;
  const double RI_7a = KSL_MUL(R->m20, M->at[3][4]), RI_7b = KSL_MUL(R->m21, M->at[4][4]),
      RI_7c = RI_7a + RI_7b, RI_7d = KSL_MUL(R->m22, M->at[4][5]), RI_7 = RI_7c + RI_7d;
  const double RI_8a = KSL_MUL(R->m20, M->at[3][5]), RI_8b = KSL_MUL(R->m21, M->at[4][5]),
      RI_8c = RI_8a + RI_8b, RI_8d = KSL_MUL(R->m22, M->at[5][5]), RI_8 = RI_8c + RI_8d;
  const double angular_0a = KSL_MUL(R->m00, RI_0), angular_0b = KSL_MUL(R->m01, RI_1),
      angular_0c = angular_0a + angular_0b, angular_0d = KSL_MUL(R->m02, RI_2),
      angular_0 = angular_0c + angular_0d;
  const double angular_1a = KSL_MUL(R->m00, RI_3), angular_1b = KSL_MUL(R->m01, RI_4),
      angular_1c = angular_1a + angular_1b, angular_1d = KSL_MUL(R->m02, RI_5),
      angular_1 = angular_1c + angular_1d;
  const double angular_2a = KSL_MUL(R->m10, RI_3), angular_2b = KSL_MUL(R->m11, RI_4),
      angular_2c = angular_2a + angular_2b, angular_2d = KSL_MUL(R->m12, RI_5),
      angular_2 = angular_2c + angular_2d;
  const double angular_3a = KSL_MUL(R->m00, RI_6), angular_3b = KSL_MUL(R->m01, RI_7),
      angular_3c = angular_3a + angular_3b, angular_3d = KSL_MUL(R->m02, RI_8),
      angular_3 = angular_3c + angular_3d;
  const double angular_4a = KSL_MUL(R->m10, RI_6), angular_4b = KSL_MUL(R->m11, RI_7),
      angular_4c = angular_4a + angular_4b, angular_4d = KSL_MUL(R->m12, RI_8),
      angular_4 = angular_4c + angular_4d;
  const double angular_5a = KSL_MUL(R->m20, RI_6), angular_5b = KSL_MUL(R->m21, RI_7),
      angular_5c = angular_5a + angular_5b, angular_5d = KSL_MUL(R->m22, RI_8),
      angular_5 = angular_5c + angular_5d;
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
      G_0c = G_0a - G_0b, G_0 = G_0c + M->at[0][3];
  const double G_1a = KSL_MUL(t->y, M->at[1][2]), G_1b = KSL_MUL(t->z, M->at[1][1]),
      G_1c = G_1a - G_1b, G_1 = G_1c + M->at[1][3];
  const double G_2a = KSL_MUL(t->y, M->at[2][2]), G_2b = KSL_MUL(t->z, M->at[1][2]),
      G_2c = G_2a - G_2b, G_2 = G_2c + M->at[2][3];
  const double G_3a = KSL_MUL(t->z, M->at[0][0]), G_3b = KSL_MUL(t->x, M->at[0][2]),
      G_3c = G_3a - G_3b, G_3 = G_3c + M->at[0][4];
  const double G_4a = KSL_MUL(t->x, M->at[1][2]), G_4b = G_0b - G_4a, G_4 = G_4b + M->at[1][4];
  const double G_5a = KSL_MUL(t->z, M->at[0][2]), G_5b = KSL_MUL(t->x, M->at[2][2]),
      G_5c = G_5a - G_5b, G_5 = G_5c + M->at[2][4];
  const double G_6a = KSL_MUL(t->x, M->at[0][1]), G_6b = KSL_MUL(t->y, M->at[0][0]),
      G_6c = G_6a - G_6b, G_6 = G_6c + M->at[0][5];
  const double G_7a = KSL_MUL(t->x, M->at[1][1]), G_7b = KSL_MUL(t->y, M->at[0][1]),
      G_7c = G_7a - G_7b, G_7 = G_7c + M->at[1][5];
  const double G_8a = G_4a - G_0a, G_8 = G_8a + M->at[2][5];
  const double moved_0a = KSL_MUL(t->y, M->at[2][3]), moved_0b = KSL_MUL(t->z, M->at[1][3]),
      moved_0c = moved_0a - moved_0b, moved_0d = KSL_MUL(t->y, G_2), moved_0e = KSL_MUL(t->z, G_1),
      moved_0f = moved_0d - moved_0e, moved_0g = moved_0c + moved_0f,
      moved_0 = moved_0g + M->at[3][3];
  const double moved_1a = KSL_MUL(t->z, M->at[0][3]), moved_1b = KSL_MUL(t->x, M->at[2][3]),
      moved_1c = moved_1a - moved_1b, moved_1d = KSL_MUL(t->y, G_5), moved_1e = KSL_MUL(t->z, G_4),
      moved_1f = moved_1d - moved_1e, moved_1g = moved_1c + moved_1f,
      moved_1 = moved_1g + M->at[3][4];
  const double moved_2a = KSL_MUL(t->z, M->at[0][4]), moved_2b = KSL_MUL(t->x, M->at[2][4]),
      moved_2c = moved_2a - moved_2b, moved_2d = KSL_MUL(t->z, G_3), moved_2e = KSL_MUL(t->x, G_5),
      moved_2f = moved_2d - moved_2e, moved_2g = moved_2c + moved_2f,
      moved_2 = moved_2g + M->at[4][4];
  const double moved_3a = KSL_MUL(t->x, M->at[1][3]), moved_3b = KSL_MUL(t->y, M->at[0][3]),
      moved_3c = moved_3a - moved_3b, moved_3d = KSL_MUL(t->y, G_8), moved_3e = KSL_MUL(t->z, G_7),
      moved_3f = moved_3d - moved_3e, moved_3g = moved_3c + moved_3f,
      moved_3 = moved_3g + M->at[3][5];
  const double moved_4a = KSL_MUL(t->x, M->at[1][4]), moved_4b = KSL_MUL(t->y, M->at[0][4]),
      moved_4c = moved_4a - moved_4b, moved_4d = KSL_MUL(t->z, G_6), moved_4e = KSL_MUL(t->x, G_8),
      moved_4f = moved_4d - moved_4e, moved_4g = moved_4c + moved_4f,
      moved_4 = moved_4g + M->at[4][5];
  const double moved_5a = KSL_MUL(t->x, M->at[1][5]), moved_5b = KSL_MUL(t->y, M->at[0][5]),
      moved_5c = moved_5a - moved_5b, moved_5d = KSL_MUL(t->x, G_7), moved_5e = KSL_MUL(t->y, G_6),
      moved_5f = moved_5d - moved_5e, moved_5g = moved_5c + moved_5f,
      moved_5 = moved_5g + M->at[5][5];
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
  const float RM_0a = KSL_MULF(R->m00, M->at[0][0]), RM_0b = KSL_MULF(R->m01, M->at[0][1]),
      RM_0c = RM_0a + RM_0b, RM_0d = KSL_MULF(R->m02, M->at[0][2]), RM_0 = RM_0c + RM_0d;
  const float RM_1a = KSL_MULF(R->m00, M->at[0][1]), RM_1b = KSL_MULF(R->m01, M->at[1][1]),
      RM_1c = RM_1a + RM_1b, RM_1d = KSL_MULF(R->m02, M->at[1][2]), RM_1 = RM_1c + RM_1d;
  const float RM_2a = KSL_MULF(R->m00, M->at[0][2]), RM_2b = KSL_MULF(R->m01, M->at[1][2]),
      RM_2c = RM_2a + RM_2b, RM_2d = KSL_MULF(R->m02, M->at[2][2]), RM_2 = RM_2c + RM_2d;
  const float RM_3a = KSL_MULF(R->m10, M->at[0][0]), RM_3b = KSL_MULF(R->m11, M->at[0][1]),
      RM_3c = RM_3a + RM_3b, RM_3d = KSL_MULF(R->m12, M->at[0][2]), RM_3 = RM_3c + RM_3d;
  const float RM_4a = KSL_MULF(R->m10, M->at[0][1]), RM_4b = KSL_MULF(R->m11, M->at[1][1]),
      RM_4c = RM_4a + RM_4b, RM_4d = KSL_MULF(R->m12, M->at[1][2]), RM_4 = RM_4c + RM_4d;
  const float RM_5a = KSL_MULF(R->m10, M->at[0][2]), RM_5b = KSL_MULF(R->m11, M->at[1][2]),
      RM_5c = RM_5a + RM_5b, RM_5d = KSL_MULF(R->m12, M->at[2][2]), RM_5 = RM_5c + RM_5d;
  const float RM_6a = KSL_MULF(R->m20, M->at[0][0]), RM_6b = KSL_MULF(R->m21, M->at[0][1]),
      RM_6c = RM_6a + RM_6b, RM_6d = KSL_MULF(R->m22, M->at[0][2]), RM_6 = RM_6c + RM_6d;
  const float RM_7a = KSL_MULF(R->m20, M->at[0][1]), RM_7b = KSL_MULF(R->m21, M->at[1][1]),
      RM_7c = RM_7a + RM_7b, RM_7d = KSL_MULF(R->m22, M->at[1][2]), RM_7 = RM_7c + RM_7d;
  const float RM_8a = KSL_MULF(R->m20, M->at[0][2]), RM_8b = KSL_MULF(R->m21, M->at[1][2]),
      RM_8c = RM_8a + RM_8b, RM_8d = KSL_MULF(R->m22, M->at[2][2]), RM_8 = RM_8c + RM_8d;
  const float linear_0a = KSL_MULF(R->m00, RM_0), linear_0b = KSL_MULF(R->m01, RM_1),
      linear_0c = linear_0a + linear_0b, linear_0d = KSL_MULF(R->m02, RM_2),
      linear_0 = linear_0c + linear_0d;
  const float linear_1a = KSL_MULF(R->m00, RM_3), linear_1b = KSL_MULF(R->m01, RM_4),
      linear_1c = linear_1a + linear_1b, linear_1d = KSL_MULF(R->m02, RM_5),
      linear_1 = linear_1c + linear_1d;
  const float linear_2a = KSL_MULF(R->m10, RM_3), linear_2b = KSL_MULF(R->m11, RM_4),
      linear_2c = linear_2a + linear_2b, linear_2d = KSL_MULF(R->m12, RM_5),
      linear_2 = linear_2c + linear_2d;
  const float linear_3a = KSL_MULF(R->m00, RM_6), linear_3b = KSL_MULF(R->m01, RM_7),
      linear_3c = linear_3a + linear_3b, linear_3d = KSL_MULF(R->m02, RM_8),
      linear_3 = linear_3c + linear_3d;
  const float linear_4a = KSL_MULF(R->m10, RM_6), linear_4b = KSL_MULF(R->m11, RM_7),
      linear_4c = linear_4a + linear_4b, linear_4d = KSL_MULF(R->m12, RM_8),
      linear_4 = linear_4c + linear_4d;
  const float linear_5a = KSL_MULF(R->m20, RM_6), linear_5b = KSL_MULF(R->m21, RM_7),
      linear_5c = linear_5a + linear_5b, linear_5d = KSL_MULF(R->m22, RM_8),
      linear_5 = linear_5c + linear_5d;
  const float RH_0a = KSL_MULF(R->m00, M->at[0][3]), RH_0b = KSL_MULF(R->m01, M->at[0][4]),
      RH_0c = RH_0a + RH_0b, RH_0d = KSL_MULF(R->m02, M->at[0][5]), RH_0 = RH_0c + RH_0d;
  const float RH_1a = KSL_MULF(R->m00, M->at[1][3]), RH_1b = KSL_MULF(R->m01, M->at[1][4]),
      RH_1c = RH_1a + RH_1b, RH_1d = KSL_MULF(R->m02, M->at[1][5]), RH_1 = RH_1c + RH_1d;
  const float RH_2a = KSL_MULF(R->m00, M->at[2][3]), RH_2b = KSL_MULF(R->m01, M->at[2][4]),
      RH_2c = RH_2a + RH_2b, RH_2d = KSL_MULF(R->m02, M->at[2][5]), RH_2 = RH_2c + RH_2d;
  const float RH_3a = KSL_MULF(R->m10, M->at[0][3]), RH_3b = KSL_MULF(R->m11, M->at[0][4]),
      RH_3c = RH_3a + RH_3b, RH_3d = KSL_MULF(R->m12, M->at[0][5]), RH_3 = RH_3c + RH_3d;
  const float RH_4a = KSL_MULF(R->m10, M->at[1][3]), RH_4b = KSL_MULF(R->m11, M->at[1][4]),
      RH_4c = RH_4a + RH_4b, RH_4d = KSL_MULF(R->m12, M->at[1][5]), RH_4 = RH_4c + RH_4d;
  const float RH_5a = KSL_MULF(R->m10, M->at[2][3]), RH_5b = KSL_MULF(R->m11, M->at[2][4]),
      RH_5c = RH_5a + RH_5b, RH_5d = KSL_MULF(R->m12, M->at[2][5]), RH_5 = RH_5c + RH_5d;
  const float RH_6a = KSL_MULF(R->m20, M->at[0][3]), RH_6b = KSL_MULF(R->m21, M->at[0][4]),
      RH_6c = RH_6a + RH_6b, RH_6d = KSL_MULF(R->m22, M->at[0][5]), RH_6 = RH_6c + RH_6d;
  const float RH_7a = KSL_MULF(R->m20, M->at[1][3]), RH_7b = KSL_MULF(R->m21, M->at[1][4]),
      RH_7c = RH_7a + RH_7b, RH_7d = KSL_MULF(R->m22, M->at[1][5]), RH_7 = RH_7c + RH_7d;
  const float RH_8a = KSL_MULF(R->m20, M->at[2][3]), RH_8b = KSL_MULF(R->m21, M->at[2][4]),
      RH_8c = RH_8a + RH_8b, RH_8d = KSL_MULF(R->m22, M->at[2][5]), RH_8 = RH_8c + RH_8d;
  const float coupling_0a = KSL_MULF(R->m00, RH_0), coupling_0b = KSL_MULF(R->m01, RH_1),
      coupling_0c = coupling_0a + coupling_0b, coupling_0d = KSL_MULF(R->m02, RH_2),
      coupling_0 = coupling_0c + coupling_0d;
  const float coupling_1a = KSL_MULF(R->m10, RH_0), coupling_1b = KSL_MULF(R->m11, RH_1),
      coupling_1c = coupling_1a + coupling_1b, coupling_1d = KSL_MULF(R->m12, RH_2),
      coupling_1 = coupling_1c + coupling_1d;
  const float coupling_2a = KSL_MULF(R->m20, RH_0), coupling_2b = KSL_MULF(R->m21, RH_1),
      coupling_2c = coupling_2a + coupling_2b, coupling_2d = KSL_MULF(R->m22, RH_2),
      coupling_2 = coupling_2c + coupling_2d;
  const float coupling_3a = KSL_MULF(R->m00, RH_3), coupling_3b = KSL_MULF(R->m01, RH_4),
      coupling_3c = coupling_3a + coupling_3b, coupling_3d = KSL_MULF(R->m02, RH_5),
      coupling_3 = coupling_3c + coupling_3d;
  const float coupling_4a = KSL_MULF(R->m10, RH_3), coupling_4b = KSL_MULF(R->m11, RH_4),
      coupling_4c = coupling_4a + coupling_4b, coupling_4d = KSL_MULF(R->m12, RH_5),
      coupling_4 = coupling_4c + coupling_4d;
  const float coupling_5a = KSL_MULF(R->m20, RH_3), coupling_5b = KSL_MULF(R->m21, RH_4),
      coupling_5c = coupling_5a + coupling_5b, coupling_5d = KSL_MULF(R->m22, RH_5),
      coupling_5 = coupling_5c + coupling_5d;
  const float coupling_6a = KSL_MULF(R->m00, RH_6), coupling_6b = KSL_MULF(R->m01, RH_7),
      coupling_6c = coupling_6a + coupling_6b, coupling_6d = KSL_MULF(R->m02, RH_8),
      coupling_6 = coupling_6c + coupling_6d;
  const float coupling_7a = KSL_MULF(R->m10, RH_6), coupling_7b = KSL_MULF(R->m11, RH_7),
      coupling_7c = coupling_7a + coupling_7b, coupling_7d = KSL_MULF(R->m12, RH_8),
      coupling_7 = coupling_7c + coupling_7d;
  const float coupling_8a = KSL_MULF(R->m20, RH_6), coupling_8b = KSL_MULF(R->m21, RH_7),
      coupling_8c = coupling_8a + coupling_8b, coupling_8d = KSL_MULF(R->m22, RH_8),
      coupling_8 = coupling_8c + coupling_8d;
  const float RI_0a = KSL_MULF(R->m00, M->at[3][3]), RI_0b = KSL_MULF(R->m01, M->at[3][4]),
      RI_0c = RI_0a + RI_0b, RI_0d = KSL_MULF(R->m02, M->at[3][5]), RI_0 = RI_0c + RI_0d;
  const float RI_1a = KSL_MULF(R->m00, M->at[3][4]), RI_1b = KSL_MULF(R->m01, M->at[4][4]),
      RI_1c = RI_1a + RI_1b, RI_1d = KSL_MULF(R->m02, M->at[4][5]), RI_1 = RI_1c + RI_1d;
  const float RI_2a = KSL_MULF(R->m00, M->at[3][5]), RI_2b = KSL_MULF(R->m01, M->at[4][5]),
      RI_2c = RI_2a + RI_2b, RI_2d = KSL_MULF(R->m02, M->at[5][5]), RI_2 = RI_2c + RI_2d;
  const float RI_3a = KSL_MULF(R->m10, M->at[3][3]), RI_3b = KSL_MULF(R->m11, M->at[3][4]),
      RI_3c = RI_3a + RI_3b, RI_3d = KSL_MULF(R->m12, M->at[3][5]), RI_3 = RI_3c + RI_3d;
  const float RI_4a = KSL_MULF(R->m10, M->at[3][4]), RI_4b = KSL_MULF(R->m11, M->at[4][4]),
      RI_4c = RI_4a + RI_4b, RI_4d = KSL_MULF(R->m12, M->at[4][5]), RI_4 = RI_4c + RI_4d;
  const float RI_5a = KSL_MULF(R->m10, M->at[3][5]), RI_5b = KSL_MULF(R->m11, M->at[4][5]),
      RI_5c = RI_5a + RI_5b, RI_5d = KSL_MULF(R->m12, M->at[5][5]), RI_5 = RI_5c + RI_5d;
  const float RI_6a = KSL_MULF(R->m20, M->at[3][3]), RI_6b = KSL_MULF(R->m21, M->at[3][4]),
      RI_6c = RI_6a + RI_6b, RI_6d = KSL_MULF(R->m22, M->at[3][5]), RI_6 = RI_6c + RI_6d;
  const float RI_7a = KSL_MULF(R->m20, M->at[3][4]), RI_7b = KSL_MULF(R->m21, M->at[4][4]),
      RI_7c = RI_7a + RI_7b, RI_7d = KSL_MULF(R->m22, M->at[4][5]), RI_7 = RI_7c + RI_7d;
  const float RI_8a = KSL_MULF(R->m20, M->at[3][5]), RI_8b = KSL_MULF(R->m21, M->at[4][5]),
      RI_8c = RI_8a + RI_8b, RI_8d = KSL_MULF(R->m22, M->at[5][5]), RI_8 = RI_8c + RI_8d;
  const float angular_0a = KSL_MULF(R->m00, RI_0), angular_0b = KSL_MULF(R->m01, RI_1),
      angular_0c = angular_0a + angular_0b, angular_0d = KSL_MULF(R->m02, RI_2),
      angular_0 = angular_0c + angular_0d;
  const float angular_1a = KSL_MULF(R->m00, RI_3), angular_1b = KSL_MULF(R->m01, RI_4),
      angular_1c = angular_1a + angular_1b, angular_1d = KSL_MULF(R->m02, RI_5),
      angular_1 = angular_1c + angular_1d;
  const float angular_2a = KSL_MULF(R->m10, RI_3), angular_2b = KSL_MULF(R->m11, RI_4),
      angular_2c = angular_2a + angular_2b, angular_2d = KSL_MULF(R->m12, RI_5),
      angular_2 = angular_2c + angular_2d;
  const float angular_3a = KSL_MULF(R->m00, RI_6), angular_3b = KSL_MULF(R->m01, RI_7),
      angular_3c = angular_3a + angular_3b, angular_3d = KSL_MULF(R->m02, RI_8),
      angular_3 = angular_3c + angular_3d;
  const float angular_4a = KSL_MULF(R->m10, RI_6), angular_4b = KSL_MULF(R->m11, RI_7),
      angular_4c = angular_4a + angular_4b, angular_4d = KSL_MULF(R->m12, RI_8),
      angular_4 = angular_4c + angular_4d;
  const float angular_5a = KSL_MULF(R->m20, RI_6), angular_5b = KSL_MULF(R->m21, RI_7),
      angular_5c = angular_5a + angular_5b, angular_5d = KSL_MULF(R->m22, RI_8),
      angular_5 = angular_5c + angular_5d;
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
      G_0c = G_0a - G_0b, G_0 = G_0c + M->at[0][3];
  const float G_1a = KSL_MULF(t->y, M->at[1][2]), G_1b = KSL_MULF(t->z, M->at[1][1]),
      G_1c = G_1a - G_1b, G_1 = G_1c + M->at[1][3];
  const float G_2a = KSL_MULF(t->y, M->at[2][2]), G_2b = KSL_MULF(t->z, M->at[1][2]),
      G_2c = G_2a - G_2b, G_2 = G_2c + M->at[2][3];
  const float G_3a = KSL_MULF(t->z, M->at[0][0]), G_3b = KSL_MULF(t->x, M->at[0][2]),
      G_3c = G_3a - G_3b, G_3 = G_3c + M->at[0][4];
  const float G_4a = KSL_MULF(t->x, M->at[1][2]), G_4b = G_0b - G_4a, G_4 = G_4b + M->at[1][4];
  const float G_5a = KSL_MULF(t->z, M->at[0][2]), G_5b = KSL_MULF(t->x, M->at[2][2]),
      G_5c = G_5a - G_5b, G_5 = G_5c + M->at[2][4];
  const float G_6a = KSL_MULF(t->x, M->at[0][1]), G_6b = KSL_MULF(t->y, M->at[0][0]),
      G_6c = G_6a - G_6b, G_6 = G_6c + M->at[0][5];
  const float G_7a = KSL_MULF(t->x, M->at[1][1]), G_7b = KSL_MULF(t->y, M->at[0][1]),
      G_7c = G_7a - G_7b, G_7 = G_7c + M->at[1][5];
  const float G_8a = G_4a - G_0a, G_8 = G_8a + M->at[2][5];
  const float moved_0a = KSL_MULF(t->y, M->at[2][3]), moved_0b = KSL_MULF(t->z, M->at[1][3]),
      moved_0c = moved_0a - moved_0b, moved_0d = KSL_MULF(t->y, G_2),
      moved_0e = KSL_MULF(t->z, G_1), moved_0f = moved_0d - moved_0e,
      moved_0g = moved_0c + moved_0f, moved_0 = moved_0g + M->at[3][3];
  const float moved_1a = KSL_MULF(t->z, M->at[0][3]), moved_1b = KSL_MULF(t->x, M->at[2][3]),
      moved_1c = moved_1a - moved_1b, moved_1d = KSL_MULF(t->y, G_5),
      moved_1e = KSL_MULF(t->z, G_4), moved_1f = moved_1d - moved_1e,
      moved_1g = moved_1c + moved_1f, moved_1 = moved_1g + M->at[3][4];
  const float moved_2a = KSL_MULF(t->z, M->at[0][4]), moved_2b = KSL_MULF(t->x, M->at[2][4]),
      moved_2c = moved_2a - moved_2b, moved_2d = KSL_MULF(t->z, G_3),
      moved_2e = KSL_MULF(t->x, G_5), moved_2f = moved_2d - moved_2e,
      moved_2g = moved_2c + moved_2f, moved_2 = moved_2g + M->at[4][4];
  const float moved_3a = KSL_MULF(t->x, M->at[1][3]), moved_3b = KSL_MULF(t->y, M->at[0][3]),
      moved_3c = moved_3a - moved_3b, moved_3d = KSL_MULF(t->y, G_8),
      moved_3e = KSL_MULF(t->z, G_7), moved_3f = moved_3d - moved_3e,
      moved_3g = moved_3c + moved_3f, moved_3 = moved_3g + M->at[3][5];
  const float moved_4a = KSL_MULF(t->x, M->at[1][4]), moved_4b = KSL_MULF(t->y, M->at[0][4]),
      moved_4c = moved_4a - moved_4b, moved_4d = KSL_MULF(t->z, G_6),
      moved_4e = KSL_MULF(t->x, G_8), moved_4f = moved_4d - moved_4e,
      moved_4g = moved_4c + moved_4f, moved_4 = moved_4g + M->at[4][5];
  const float moved_5a = KSL_MULF(t->x, M->at[1][5]), moved_5b = KSL_MULF(t->y, M->at[0][5]),
      moved_5c = moved_5a - moved_5b, moved_5d = KSL_MULF(t->x, G_7),
      moved_5e = KSL_MULF(t->y, G_6), moved_5f = moved_5d - moved_5e,
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
