/* Made by `coscrew generate`; changes are overwritten. */
/* SPDX-License-Identifier: MIT */
/* coscrew 0.2.0.  Copyright (c) 2026 The coscrew authors. */
/* 6×6 operators on screws and coscrews, as [Ad], [Ad]*, [ad] and [ad]* return them. */
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
