/* Made by `coscrew generate`; changes are overwritten. */
/* SPDX-License-Identifier: MIT */
/* coscrew 0.2.0.  Copyright (c) 2026 The coscrew authors. */
/* 6×6 operators on screws and coscrews: [Ad], [Ad]*, [ad], [ad]*, and articulated inertias.
   Certified tier: plain results, and bounds on their errors that always hold. */
#ifndef KSL_MAT6X6_CERTIFIED_H
#define KSL_MAT6X6_CERTIFIED_H

#include "ksl_types.h"

/* Mo = [Ad]*(R) M [Ad]^-1(R), the articulated inertia M rotated by R; M is symmetric, only its
     lower triangle is read; |error of Mo| <= Mo_bound unless inf or NaN.
   R: rotation or other 3×3 matrix; M, Mo, Mo_bound: 6×6 operator.
   228 mul, 240 add, 90 abs. */
static inline void ksl_mat6x6_rotated_certified(const ksl_mat3x3_t *R, const ksl_mat6x6_t *M,
    ksl_mat6x6_t *Mo, ksl_mat6x6_t *Mo_bound) {
  const double RM_0a = KSL_MUL(R->m00, M->at[0][0]), RM_0b = KSL_MUL(R->m01, M->at[0][1]),
      RM_0d = KSL_MUL(R->m02, M->at[0][2]), RM_0 = RM_0a + RM_0b + RM_0d;
  const double RM_1a = KSL_MUL(R->m00, M->at[0][1]), RM_1b = KSL_MUL(R->m01, M->at[1][1]),
      RM_1d = KSL_MUL(R->m02, M->at[1][2]), RM_1 = RM_1a + RM_1b + RM_1d;
  const double RM_2a = KSL_MUL(R->m00, M->at[0][2]), RM_2b = KSL_MUL(R->m01, M->at[1][2]),
      RM_2d = KSL_MUL(R->m02, M->at[2][2]), RM_2 = RM_2a + RM_2b + RM_2d;
  const double RM_3a = KSL_MUL(R->m10, M->at[0][0]), RM_3b = KSL_MUL(R->m11, M->at[0][1]),
      RM_3d = KSL_MUL(R->m12, M->at[0][2]), RM_3 = RM_3a + RM_3b + RM_3d;
  const double RM_4a = KSL_MUL(R->m10, M->at[0][1]), RM_4b = KSL_MUL(R->m11, M->at[1][1]),
      RM_4d = KSL_MUL(R->m12, M->at[1][2]), RM_4 = RM_4a + RM_4b + RM_4d;
  const double RM_5a = KSL_MUL(R->m10, M->at[0][2]), RM_5b = KSL_MUL(R->m11, M->at[1][2]),
      RM_5d = KSL_MUL(R->m12, M->at[2][2]), RM_5 = RM_5a + RM_5b + RM_5d;
  const double RM_6a = KSL_MUL(R->m20, M->at[0][0]), RM_6b = KSL_MUL(R->m21, M->at[0][1]),
      RM_6d = KSL_MUL(R->m22, M->at[0][2]), RM_6 = RM_6a + RM_6b + RM_6d;
  const double RM_7a = KSL_MUL(R->m20, M->at[0][1]), RM_7b = KSL_MUL(R->m21, M->at[1][1]),
      RM_7d = KSL_MUL(R->m22, M->at[1][2]), RM_7 = RM_7a + RM_7b + RM_7d;
  const double RM_8a = KSL_MUL(R->m20, M->at[0][2]), RM_8b = KSL_MUL(R->m21, M->at[1][2]),
      RM_8d = KSL_MUL(R->m22, M->at[2][2]), RM_8 = RM_8a + RM_8b + RM_8d;
  const double linear_0 = KSL_MUL(R->m00, RM_0) + KSL_MUL(R->m01, RM_1) + KSL_MUL(R->m02, RM_2);
  const double linear_1 = KSL_MUL(R->m00, RM_3) + KSL_MUL(R->m01, RM_4) + KSL_MUL(R->m02, RM_5);
  const double linear_2 = KSL_MUL(R->m10, RM_3) + KSL_MUL(R->m11, RM_4) + KSL_MUL(R->m12, RM_5);
  const double linear_3 = KSL_MUL(R->m00, RM_6) + KSL_MUL(R->m01, RM_7) + KSL_MUL(R->m02, RM_8);
  const double linear_4 = KSL_MUL(R->m10, RM_6) + KSL_MUL(R->m11, RM_7) + KSL_MUL(R->m12, RM_8),
      linear_5 = KSL_MUL(R->m20, RM_6) + KSL_MUL(R->m21, RM_7) + KSL_MUL(R->m22, RM_8);
  const double RH_0a = KSL_MUL(R->m00, M->at[0][3]), RH_0b = KSL_MUL(R->m01, M->at[0][4]),
      RH_0d = KSL_MUL(R->m02, M->at[0][5]), RH_0 = RH_0a + RH_0b + RH_0d;
  const double RH_1a = KSL_MUL(R->m00, M->at[1][3]), RH_1b = KSL_MUL(R->m01, M->at[1][4]),
      RH_1d = KSL_MUL(R->m02, M->at[1][5]), RH_1 = RH_1a + RH_1b + RH_1d;
  const double RH_2a = KSL_MUL(R->m00, M->at[2][3]), RH_2b = KSL_MUL(R->m01, M->at[2][4]),
      RH_2d = KSL_MUL(R->m02, M->at[2][5]), RH_2 = RH_2a + RH_2b + RH_2d;
  const double RH_3a = KSL_MUL(R->m10, M->at[0][3]), RH_3b = KSL_MUL(R->m11, M->at[0][4]),
      RH_3d = KSL_MUL(R->m12, M->at[0][5]), RH_3 = RH_3a + RH_3b + RH_3d;
  const double RH_4a = KSL_MUL(R->m10, M->at[1][3]), RH_4b = KSL_MUL(R->m11, M->at[1][4]),
      RH_4d = KSL_MUL(R->m12, M->at[1][5]), RH_4 = RH_4a + RH_4b + RH_4d;
  const double RH_5a = KSL_MUL(R->m10, M->at[2][3]), RH_5b = KSL_MUL(R->m11, M->at[2][4]),
      RH_5d = KSL_MUL(R->m12, M->at[2][5]), RH_5 = RH_5a + RH_5b + RH_5d;
  const double RH_6a = KSL_MUL(R->m20, M->at[0][3]), RH_6b = KSL_MUL(R->m21, M->at[0][4]),
      RH_6d = KSL_MUL(R->m22, M->at[0][5]), RH_6 = RH_6a + RH_6b + RH_6d;
  const double RH_7a = KSL_MUL(R->m20, M->at[1][3]), RH_7b = KSL_MUL(R->m21, M->at[1][4]),
      RH_7d = KSL_MUL(R->m22, M->at[1][5]), RH_7 = RH_7a + RH_7b + RH_7d;
  const double RH_8a = KSL_MUL(R->m20, M->at[2][3]), RH_8b = KSL_MUL(R->m21, M->at[2][4]),
      RH_8d = KSL_MUL(R->m22, M->at[2][5]), RH_8 = RH_8a + RH_8b + RH_8d;
  const double coupling_0 = KSL_MUL(R->m00, RH_0) + KSL_MUL(R->m01, RH_1) + KSL_MUL(R->m02, RH_2);
  const double coupling_1 = KSL_MUL(R->m10, RH_0) + KSL_MUL(R->m11, RH_1) + KSL_MUL(R->m12, RH_2),
      coupling_2 = KSL_MUL(R->m20, RH_0) + KSL_MUL(R->m21, RH_1) + KSL_MUL(R->m22, RH_2);
  const double coupling_3 = KSL_MUL(R->m00, RH_3) + KSL_MUL(R->m01, RH_4) + KSL_MUL(R->m02, RH_5);
  const double coupling_4 = KSL_MUL(R->m10, RH_3) + KSL_MUL(R->m11, RH_4) + KSL_MUL(R->m12, RH_5),
      coupling_5 = KSL_MUL(R->m20, RH_3) + KSL_MUL(R->m21, RH_4) + KSL_MUL(R->m22, RH_5);
  const double coupling_6 = KSL_MUL(R->m00, RH_6) + KSL_MUL(R->m01, RH_7) + KSL_MUL(R->m02, RH_8);
  const double coupling_7 = KSL_MUL(R->m10, RH_6) + KSL_MUL(R->m11, RH_7) + KSL_MUL(R->m12, RH_8),
      coupling_8 = KSL_MUL(R->m20, RH_6) + KSL_MUL(R->m21, RH_7) + KSL_MUL(R->m22, RH_8);
  const double RI_0a = KSL_MUL(R->m00, M->at[3][3]), RI_0b = KSL_MUL(R->m01, M->at[3][4]),
      RI_0d = KSL_MUL(R->m02, M->at[3][5]), RI_0 = RI_0a + RI_0b + RI_0d;
  const double RI_1a = KSL_MUL(R->m00, M->at[3][4]), RI_1b = KSL_MUL(R->m01, M->at[4][4]),
      RI_1d = KSL_MUL(R->m02, M->at[4][5]), RI_1 = RI_1a + RI_1b + RI_1d;
  const double RI_2a = KSL_MUL(R->m00, M->at[3][5]), RI_2b = KSL_MUL(R->m01, M->at[4][5]),
      RI_2d = KSL_MUL(R->m02, M->at[5][5]), RI_2 = RI_2a + RI_2b + RI_2d;
  const double RI_3a = KSL_MUL(R->m10, M->at[3][3]), RI_3b = KSL_MUL(R->m11, M->at[3][4]),
      RI_3d = KSL_MUL(R->m12, M->at[3][5]), RI_3 = RI_3a + RI_3b + RI_3d;
  const double RI_4a = KSL_MUL(R->m10, M->at[3][4]), RI_4b = KSL_MUL(R->m11, M->at[4][4]),
      RI_4d = KSL_MUL(R->m12, M->at[4][5]), RI_4 = RI_4a + RI_4b + RI_4d;
  const double RI_5a = KSL_MUL(R->m10, M->at[3][5]), RI_5b = KSL_MUL(R->m11, M->at[4][5]),
      RI_5d = KSL_MUL(R->m12, M->at[5][5]), RI_5 = RI_5a + RI_5b + RI_5d;
  const double RI_6a = KSL_MUL(R->m20, M->at[3][3]), RI_6b = KSL_MUL(R->m21, M->at[3][4]),
      RI_6d = KSL_MUL(R->m22, M->at[3][5]), RI_6 = RI_6a + RI_6b + RI_6d;
  const double RI_7a = KSL_MUL(R->m20, M->at[3][4]), RI_7b = KSL_MUL(R->m21, M->at[4][4]),
      RI_7d = KSL_MUL(R->m22, M->at[4][5]), RI_7 = RI_7a + RI_7b + RI_7d;
  const double RI_8a = KSL_MUL(R->m20, M->at[3][5]), RI_8b = KSL_MUL(R->m21, M->at[4][5]),
      RI_8d = KSL_MUL(R->m22, M->at[5][5]), RI_8 = RI_8a + RI_8b + RI_8d;
  const double angular_0 = KSL_MUL(R->m00, RI_0) + KSL_MUL(R->m01, RI_1) + KSL_MUL(R->m02, RI_2);
  const double angular_1 = KSL_MUL(R->m00, RI_3) + KSL_MUL(R->m01, RI_4) + KSL_MUL(R->m02, RI_5);
  const double angular_2 = KSL_MUL(R->m10, RI_3) + KSL_MUL(R->m11, RI_4) + KSL_MUL(R->m12, RI_5);
  const double angular_3 = KSL_MUL(R->m00, RI_6) + KSL_MUL(R->m01, RI_7) + KSL_MUL(R->m02, RI_8);
  const double angular_4 = KSL_MUL(R->m10, RI_6) + KSL_MUL(R->m11, RI_7) + KSL_MUL(R->m12, RI_8),
      angular_5 = KSL_MUL(R->m20, RI_6) + KSL_MUL(R->m21, RI_7) + KSL_MUL(R->m22, RI_8);
  const double RM_0_size = fabs(RM_0a) + fabs(RM_0b) + fabs(RM_0d),
      RM_1_size = fabs(RM_1a) + fabs(RM_1b) + fabs(RM_1d),
      RM_2_size = fabs(RM_2a) + fabs(RM_2b) + fabs(RM_2d),
      RM_3_size = fabs(RM_3a) + fabs(RM_3b) + fabs(RM_3d),
      RM_4_size = fabs(RM_4a) + fabs(RM_4b) + fabs(RM_4d),
      RM_5_size = fabs(RM_5a) + fabs(RM_5b) + fabs(RM_5d),
      RM_6_size = fabs(RM_6a) + fabs(RM_6b) + fabs(RM_6d),
      RM_7_size = fabs(RM_7a) + fabs(RM_7b) + fabs(RM_7d),
      RM_8_size = fabs(RM_8a) + fabs(RM_8b) + fabs(RM_8d);
  const double R_00_abs = fabs(R->m00), R_01_abs = fabs(R->m01), R_02_abs = fabs(R->m02),
      linear_0c_size = KSL_MUL(R_00_abs, RM_0_size + 2.004168360008973e-292)
          + KSL_MUL(R_01_abs, RM_1_size + 2.004168360008973e-292),
      linear_0_size = linear_0c_size + KSL_MUL(R_02_abs, RM_2_size + 2.004168360008973e-292);
  const double RM_3_padded = RM_3_size + 2.004168360008973e-292,
      RM_4_padded = RM_4_size + 2.004168360008973e-292,
      RM_5_padded = RM_5_size + 2.004168360008973e-292;
  const double linear_1_size = KSL_MUL(R_00_abs, RM_3_padded) + KSL_MUL(R_01_abs, RM_4_padded)
          + KSL_MUL(R_02_abs, RM_5_padded);
  const double R_10_abs = fabs(R->m10), R_11_abs = fabs(R->m11), R_12_abs = fabs(R->m12),
      linear_2_size = KSL_MUL(R_10_abs, RM_3_padded) + KSL_MUL(R_11_abs, RM_4_padded)
          + KSL_MUL(R_12_abs, RM_5_padded);
  const double RM_6_padded = RM_6_size + 2.004168360008973e-292,
      RM_7_padded = RM_7_size + 2.004168360008973e-292,
      RM_8_padded = RM_8_size + 2.004168360008973e-292;
  const double linear_3_size = KSL_MUL(R_00_abs, RM_6_padded) + KSL_MUL(R_01_abs, RM_7_padded)
          + KSL_MUL(R_02_abs, RM_8_padded),
      linear_4_size = KSL_MUL(R_10_abs, RM_6_padded) + KSL_MUL(R_11_abs, RM_7_padded)
          + KSL_MUL(R_12_abs, RM_8_padded);
  const double R_20_abs = fabs(R->m20), R_21_abs = fabs(R->m21), R_22_abs = fabs(R->m22),
      linear_5_size = KSL_MUL(R_20_abs, RM_6_padded) + KSL_MUL(R_21_abs, RM_7_padded)
          + KSL_MUL(R_22_abs, RM_8_padded);
  const double RH_0_size = fabs(RH_0a) + fabs(RH_0b) + fabs(RH_0d),
      RH_1_size = fabs(RH_1a) + fabs(RH_1b) + fabs(RH_1d),
      RH_2_size = fabs(RH_2a) + fabs(RH_2b) + fabs(RH_2d),
      RH_3_size = fabs(RH_3a) + fabs(RH_3b) + fabs(RH_3d),
      RH_4_size = fabs(RH_4a) + fabs(RH_4b) + fabs(RH_4d),
      RH_5_size = fabs(RH_5a) + fabs(RH_5b) + fabs(RH_5d),
      RH_6_size = fabs(RH_6a) + fabs(RH_6b) + fabs(RH_6d),
      RH_7_size = fabs(RH_7a) + fabs(RH_7b) + fabs(RH_7d),
      RH_8_size = fabs(RH_8a) + fabs(RH_8b) + fabs(RH_8d);
  const double RH_0_padded = RH_0_size + 2.004168360008973e-292,
      RH_1_padded = RH_1_size + 2.004168360008973e-292,
      RH_2_padded = RH_2_size + 2.004168360008973e-292;
  const double coupling_0_size = KSL_MUL(R_00_abs, RH_0_padded) + KSL_MUL(R_01_abs, RH_1_padded)
          + KSL_MUL(R_02_abs, RH_2_padded),
      coupling_1_size = KSL_MUL(R_10_abs, RH_0_padded) + KSL_MUL(R_11_abs, RH_1_padded)
          + KSL_MUL(R_12_abs, RH_2_padded),
      coupling_2_size = KSL_MUL(R_20_abs, RH_0_padded) + KSL_MUL(R_21_abs, RH_1_padded)
          + KSL_MUL(R_22_abs, RH_2_padded);
  const double RH_3_padded = RH_3_size + 2.004168360008973e-292,
      RH_4_padded = RH_4_size + 2.004168360008973e-292,
      RH_5_padded = RH_5_size + 2.004168360008973e-292;
  const double coupling_3_size = KSL_MUL(R_00_abs, RH_3_padded) + KSL_MUL(R_01_abs, RH_4_padded)
          + KSL_MUL(R_02_abs, RH_5_padded),
      coupling_4_size = KSL_MUL(R_10_abs, RH_3_padded) + KSL_MUL(R_11_abs, RH_4_padded)
          + KSL_MUL(R_12_abs, RH_5_padded),
      coupling_5_size = KSL_MUL(R_20_abs, RH_3_padded) + KSL_MUL(R_21_abs, RH_4_padded)
          + KSL_MUL(R_22_abs, RH_5_padded);
  const double RH_6_padded = RH_6_size + 2.004168360008973e-292,
      RH_7_padded = RH_7_size + 2.004168360008973e-292,
      RH_8_padded = RH_8_size + 2.004168360008973e-292;
  const double coupling_6_size = KSL_MUL(R_00_abs, RH_6_padded) + KSL_MUL(R_01_abs, RH_7_padded)
          + KSL_MUL(R_02_abs, RH_8_padded),
      coupling_7_size = KSL_MUL(R_10_abs, RH_6_padded) + KSL_MUL(R_11_abs, RH_7_padded)
          + KSL_MUL(R_12_abs, RH_8_padded),
      coupling_8_size = KSL_MUL(R_20_abs, RH_6_padded) + KSL_MUL(R_21_abs, RH_7_padded)
          + KSL_MUL(R_22_abs, RH_8_padded);
  const double RI_0_size = fabs(RI_0a) + fabs(RI_0b) + fabs(RI_0d),
      RI_1_size = fabs(RI_1a) + fabs(RI_1b) + fabs(RI_1d),
      RI_2_size = fabs(RI_2a) + fabs(RI_2b) + fabs(RI_2d),
      RI_3_size = fabs(RI_3a) + fabs(RI_3b) + fabs(RI_3d),
      RI_4_size = fabs(RI_4a) + fabs(RI_4b) + fabs(RI_4d),
      RI_5_size = fabs(RI_5a) + fabs(RI_5b) + fabs(RI_5d),
      RI_6_size = fabs(RI_6a) + fabs(RI_6b) + fabs(RI_6d),
      RI_7_size = fabs(RI_7a) + fabs(RI_7b) + fabs(RI_7d),
      RI_8_size = fabs(RI_8a) + fabs(RI_8b) + fabs(RI_8d);
  const double angular_0c_size = KSL_MUL(R_00_abs, RI_0_size + 2.004168360008973e-292)
          + KSL_MUL(R_01_abs, RI_1_size + 2.004168360008973e-292),
      angular_0_size = angular_0c_size + KSL_MUL(R_02_abs, RI_2_size + 2.004168360008973e-292);
  const double RI_3_padded = RI_3_size + 2.004168360008973e-292,
      RI_4_padded = RI_4_size + 2.004168360008973e-292,
      RI_5_padded = RI_5_size + 2.004168360008973e-292;
  const double angular_1_size = KSL_MUL(R_00_abs, RI_3_padded) + KSL_MUL(R_01_abs, RI_4_padded)
          + KSL_MUL(R_02_abs, RI_5_padded),
      angular_2_size = KSL_MUL(R_10_abs, RI_3_padded) + KSL_MUL(R_11_abs, RI_4_padded)
          + KSL_MUL(R_12_abs, RI_5_padded);
  const double RI_6_padded = RI_6_size + 2.004168360008973e-292,
      RI_7_padded = RI_7_size + 2.004168360008973e-292,
      RI_8_padded = RI_8_size + 2.004168360008973e-292;
  const double angular_3_size = KSL_MUL(R_00_abs, RI_6_padded) + KSL_MUL(R_01_abs, RI_7_padded)
          + KSL_MUL(R_02_abs, RI_8_padded),
      angular_4_size = KSL_MUL(R_10_abs, RI_6_padded) + KSL_MUL(R_11_abs, RI_7_padded)
          + KSL_MUL(R_12_abs, RI_8_padded),
      angular_5_size = KSL_MUL(R_20_abs, RI_6_padded) + KSL_MUL(R_21_abs, RI_7_padded)
          + KSL_MUL(R_22_abs, RI_8_padded);
  const double linear_0_bound = KSL_MUL(6.661338147750942e-16, linear_0_size
          + 2.004168360008973e-292),
      linear_1_bound = KSL_MUL(6.661338147750942e-16, linear_1_size + 2.004168360008973e-292),
      linear_3_bound = KSL_MUL(6.661338147750942e-16, linear_3_size + 2.004168360008973e-292);
  const double coupling_0_bound = KSL_MUL(6.661338147750942e-16, coupling_0_size
          + 2.004168360008973e-292),
      coupling_3_bound = KSL_MUL(6.661338147750942e-16, coupling_3_size + 2.004168360008973e-292),
      coupling_6_bound = KSL_MUL(6.661338147750942e-16, coupling_6_size + 2.004168360008973e-292);
  const double linear_2_bound = KSL_MUL(6.661338147750942e-16, linear_2_size
          + 2.004168360008973e-292),
      linear_4_bound = KSL_MUL(6.661338147750942e-16, linear_4_size + 2.004168360008973e-292);
  const double coupling_1_bound = KSL_MUL(6.661338147750942e-16, coupling_1_size
          + 2.004168360008973e-292),
      coupling_4_bound = KSL_MUL(6.661338147750942e-16, coupling_4_size + 2.004168360008973e-292),
      coupling_7_bound = KSL_MUL(6.661338147750942e-16, coupling_7_size + 2.004168360008973e-292);
  const double linear_5_bound = KSL_MUL(6.661338147750942e-16, linear_5_size
          + 2.004168360008973e-292);
  const double coupling_2_bound = KSL_MUL(6.661338147750942e-16, coupling_2_size
          + 2.004168360008973e-292),
      coupling_5_bound = KSL_MUL(6.661338147750942e-16, coupling_5_size + 2.004168360008973e-292),
      coupling_8_bound = KSL_MUL(6.661338147750942e-16, coupling_8_size + 2.004168360008973e-292);
  const double angular_0_bound = KSL_MUL(6.661338147750942e-16, angular_0_size
          + 2.004168360008973e-292),
      angular_1_bound = KSL_MUL(6.661338147750942e-16, angular_1_size + 2.004168360008973e-292),
      angular_3_bound = KSL_MUL(6.661338147750942e-16, angular_3_size + 2.004168360008973e-292),
      angular_2_bound = KSL_MUL(6.661338147750942e-16, angular_2_size + 2.004168360008973e-292),
      angular_4_bound = KSL_MUL(6.661338147750942e-16, angular_4_size + 2.004168360008973e-292),
      angular_5_bound = KSL_MUL(6.661338147750942e-16, angular_5_size + 2.004168360008973e-292);
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
  Mo_bound->at[0][0] = linear_0_bound;
  Mo_bound->at[1][0] = linear_1_bound;
  Mo_bound->at[2][0] = linear_3_bound;
  Mo_bound->at[3][0] = coupling_0_bound;
  Mo_bound->at[4][0] = coupling_3_bound;
  Mo_bound->at[5][0] = coupling_6_bound;
  Mo_bound->at[0][1] = linear_1_bound;
  Mo_bound->at[1][1] = linear_2_bound;
  Mo_bound->at[2][1] = linear_4_bound;
  Mo_bound->at[3][1] = coupling_1_bound;
  Mo_bound->at[4][1] = coupling_4_bound;
  Mo_bound->at[5][1] = coupling_7_bound;
  Mo_bound->at[0][2] = linear_3_bound;
  Mo_bound->at[1][2] = linear_4_bound;
  Mo_bound->at[2][2] = linear_5_bound;
  Mo_bound->at[3][2] = coupling_2_bound;
  Mo_bound->at[4][2] = coupling_5_bound;
  Mo_bound->at[5][2] = coupling_8_bound;
  Mo_bound->at[0][3] = coupling_0_bound;
  Mo_bound->at[1][3] = coupling_1_bound;
  Mo_bound->at[2][3] = coupling_2_bound;
  Mo_bound->at[3][3] = angular_0_bound;
  Mo_bound->at[4][3] = angular_1_bound;
  Mo_bound->at[5][3] = angular_3_bound;
  Mo_bound->at[0][4] = coupling_3_bound;
  Mo_bound->at[1][4] = coupling_4_bound;
  Mo_bound->at[2][4] = coupling_5_bound;
  Mo_bound->at[3][4] = angular_1_bound;
  Mo_bound->at[4][4] = angular_2_bound;
  Mo_bound->at[5][4] = angular_4_bound;
  Mo_bound->at[0][5] = coupling_6_bound;
  Mo_bound->at[1][5] = coupling_7_bound;
  Mo_bound->at[2][5] = coupling_8_bound;
  Mo_bound->at[3][5] = angular_3_bound;
  Mo_bound->at[4][5] = angular_4_bound;
  Mo_bound->at[5][5] = angular_5_bound;
}

/* Mo = [Ad]*(t) M [Ad]^-1(t), the articulated inertia M shifted by t; M is symmetric, only its
     lower triangle is read; |error of Mo| <= Mo_bound unless inf or NaN.
   t: vector; M, Mo, Mo_bound: 6×6 operator.
   66 mul, 99 add, 45 abs. */
static inline void ksl_mat6x6_shifted_certified(const ksl_vec3_t *t, const ksl_mat6x6_t *M,
    ksl_mat6x6_t *Mo, ksl_mat6x6_t *Mo_bound) {
  const double G_0a = KSL_MUL(t->y, M->at[0][2]), G_0b = KSL_MUL(t->z, M->at[0][1]),
      G_0 = G_0a - G_0b + M->at[0][3];
  const double G_1a = KSL_MUL(t->y, M->at[1][2]), G_1b = KSL_MUL(t->z, M->at[1][1]),
      G_1 = G_1a - G_1b + M->at[1][3];
  const double G_2a = KSL_MUL(t->y, M->at[2][2]), G_2b = KSL_MUL(t->z, M->at[1][2]),
      G_2 = G_2a - G_2b + M->at[2][3];
  const double G_3a = KSL_MUL(t->z, M->at[0][0]), G_3b = KSL_MUL(t->x, M->at[0][2]),
      G_3 = G_3a - G_3b + M->at[0][4];
  const double G_4a = KSL_MUL(t->x, M->at[1][2]), G_4 = G_0b - G_4a + M->at[1][4];
  const double G_5a = KSL_MUL(t->z, M->at[0][2]), G_5b = KSL_MUL(t->x, M->at[2][2]),
      G_5 = G_5a - G_5b + M->at[2][4];
  const double G_6a = KSL_MUL(t->x, M->at[0][1]), G_6b = KSL_MUL(t->y, M->at[0][0]),
      G_6 = G_6a - G_6b + M->at[0][5];
  const double G_7a = KSL_MUL(t->x, M->at[1][1]), G_7b = KSL_MUL(t->y, M->at[0][1]),
      G_7 = G_7a - G_7b + M->at[1][5];
  const double G_8 = G_4a - G_0a + M->at[2][5];
  const double moved_0a = KSL_MUL(t->y, M->at[2][3]), moved_0b = KSL_MUL(t->z, M->at[1][3]),
      moved_0 = moved_0a - moved_0b + (KSL_MUL(t->y, G_2) - KSL_MUL(t->z, G_1)) + M->at[3][3];
  const double moved_1a = KSL_MUL(t->z, M->at[0][3]), moved_1b = KSL_MUL(t->x, M->at[2][3]),
      moved_1 = moved_1a - moved_1b + (KSL_MUL(t->y, G_5) - KSL_MUL(t->z, G_4)) + M->at[3][4];
  const double moved_2a = KSL_MUL(t->z, M->at[0][4]), moved_2b = KSL_MUL(t->x, M->at[2][4]),
      moved_2 = moved_2a - moved_2b + (KSL_MUL(t->z, G_3) - KSL_MUL(t->x, G_5)) + M->at[4][4];
  const double moved_3a = KSL_MUL(t->x, M->at[1][3]), moved_3b = KSL_MUL(t->y, M->at[0][3]),
      moved_3 = moved_3a - moved_3b + (KSL_MUL(t->y, G_8) - KSL_MUL(t->z, G_7)) + M->at[3][5];
  const double moved_4a = KSL_MUL(t->x, M->at[1][4]), moved_4b = KSL_MUL(t->y, M->at[0][4]),
      moved_4 = moved_4a - moved_4b + (KSL_MUL(t->z, G_6) - KSL_MUL(t->x, G_8)) + M->at[4][5];
  const double moved_5a = KSL_MUL(t->x, M->at[1][5]), moved_5b = KSL_MUL(t->y, M->at[0][5]),
      moved_5 = moved_5a - moved_5b + (KSL_MUL(t->x, G_7) - KSL_MUL(t->y, G_6)) + M->at[5][5];
  const double G_0a_abs = fabs(G_0a), G_0b_abs = fabs(G_0b),
      G_0_size = G_0a_abs + G_0b_abs + fabs(M->at[0][3]);
  const double G_1_size = fabs(G_1a) + fabs(G_1b) + fabs(M->at[1][3]),
      G_2_size = fabs(G_2a) + fabs(G_2b) + fabs(M->at[2][3]),
      G_3_size = fabs(G_3a) + fabs(G_3b) + fabs(M->at[0][4]);
  const double G_4a_abs = fabs(G_4a), G_4_size = G_0b_abs + G_4a_abs + fabs(M->at[1][4]);
  const double G_5_size = fabs(G_5a) + fabs(G_5b) + fabs(M->at[2][4]),
      G_6_size = fabs(G_6a) + fabs(G_6b) + fabs(M->at[0][5]),
      G_7_size = fabs(G_7a) + fabs(G_7b) + fabs(M->at[1][5]),
      G_8_size = G_4a_abs + G_0a_abs + fabs(M->at[2][5]);
  const double G_2_padded = G_2_size + 2.004168360008973e-292;
  const double t_1_abs = fabs(t->y);
  const double G_1_padded = G_1_size + 2.004168360008973e-292;
  const double t_2_abs = fabs(t->z),
      moved_0_size = fabs(moved_0a) + fabs(moved_0b)
          + (KSL_MUL(t_1_abs, G_2_padded) + KSL_MUL(t_2_abs, G_1_padded)) + fabs(M->at[3][3]);
  const double G_5_padded = G_5_size + 2.004168360008973e-292,
      G_4_padded = G_4_size + 2.004168360008973e-292;
  const double moved_1_size = fabs(moved_1a) + fabs(moved_1b)
          + (KSL_MUL(t_1_abs, G_5_padded) + KSL_MUL(t_2_abs, G_4_padded)) + fabs(M->at[3][4]);
  const double G_3_padded = G_3_size + 2.004168360008973e-292;
  const double t_0_abs = fabs(t->x),
      moved_2_size = fabs(moved_2a) + fabs(moved_2b)
          + (KSL_MUL(t_2_abs, G_3_padded) + KSL_MUL(t_0_abs, G_5_padded)) + fabs(M->at[4][4]);
  const double G_8_padded = G_8_size + 2.004168360008973e-292,
      G_7_padded = G_7_size + 2.004168360008973e-292;
  const double moved_3_size = fabs(moved_3a) + fabs(moved_3b)
          + (KSL_MUL(t_1_abs, G_8_padded) + KSL_MUL(t_2_abs, G_7_padded)) + fabs(M->at[3][5]);
  const double G_6_padded = G_6_size + 2.004168360008973e-292;
  const double moved_4_size = fabs(moved_4a) + fabs(moved_4b)
          + (KSL_MUL(t_2_abs, G_6_padded) + KSL_MUL(t_0_abs, G_8_padded)) + fabs(M->at[4][5]),
      moved_5_size = fabs(moved_5a) + fabs(moved_5b)
          + (KSL_MUL(t_0_abs, G_7_padded) + KSL_MUL(t_1_abs, G_6_padded)) + fabs(M->at[5][5]);
  const double G_0_bound = KSL_MUL(3.3306690738754706e-16, G_0_size + 2.004168360008973e-292),
      G_3_bound = KSL_MUL(3.3306690738754706e-16, G_3_padded),
      G_6_bound = KSL_MUL(3.3306690738754706e-16, G_6_padded),
      G_1_bound = KSL_MUL(3.3306690738754706e-16, G_1_padded),
      G_4_bound = KSL_MUL(3.3306690738754706e-16, G_4_padded),
      G_7_bound = KSL_MUL(3.3306690738754706e-16, G_7_padded),
      G_2_bound = KSL_MUL(3.3306690738754706e-16, G_2_padded),
      G_5_bound = KSL_MUL(3.3306690738754706e-16, G_5_padded),
      G_8_bound = KSL_MUL(3.3306690738754706e-16, G_8_padded);
  const double moved_0_bound = KSL_MUL(7.7715611723761e-16, moved_0_size + 2.004168360008973e-292),
      moved_1_bound = KSL_MUL(7.7715611723761e-16, moved_1_size + 2.004168360008973e-292),
      moved_3_bound = KSL_MUL(7.7715611723761e-16, moved_3_size + 2.004168360008973e-292),
      moved_2_bound = KSL_MUL(7.7715611723761e-16, moved_2_size + 2.004168360008973e-292),
      moved_4_bound = KSL_MUL(7.7715611723761e-16, moved_4_size + 2.004168360008973e-292),
      moved_5_bound = KSL_MUL(7.7715611723761e-16, moved_5_size + 2.004168360008973e-292);
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
  Mo_bound->at[0][0] = 0.0;
  Mo_bound->at[1][0] = 0.0;
  Mo_bound->at[2][0] = 0.0;
  Mo_bound->at[3][0] = G_0_bound;
  Mo_bound->at[4][0] = G_3_bound;
  Mo_bound->at[5][0] = G_6_bound;
  Mo_bound->at[0][1] = 0.0;
  Mo_bound->at[1][1] = 0.0;
  Mo_bound->at[2][1] = 0.0;
  Mo_bound->at[3][1] = G_1_bound;
  Mo_bound->at[4][1] = G_4_bound;
  Mo_bound->at[5][1] = G_7_bound;
  Mo_bound->at[0][2] = 0.0;
  Mo_bound->at[1][2] = 0.0;
  Mo_bound->at[2][2] = 0.0;
  Mo_bound->at[3][2] = G_2_bound;
  Mo_bound->at[4][2] = G_5_bound;
  Mo_bound->at[5][2] = G_8_bound;
  Mo_bound->at[0][3] = G_0_bound;
  Mo_bound->at[1][3] = G_1_bound;
  Mo_bound->at[2][3] = G_2_bound;
  Mo_bound->at[3][3] = moved_0_bound;
  Mo_bound->at[4][3] = moved_1_bound;
  Mo_bound->at[5][3] = moved_3_bound;
  Mo_bound->at[0][4] = G_3_bound;
  Mo_bound->at[1][4] = G_4_bound;
  Mo_bound->at[2][4] = G_5_bound;
  Mo_bound->at[3][4] = moved_1_bound;
  Mo_bound->at[4][4] = moved_2_bound;
  Mo_bound->at[5][4] = moved_4_bound;
  Mo_bound->at[0][5] = G_6_bound;
  Mo_bound->at[1][5] = G_7_bound;
  Mo_bound->at[2][5] = G_8_bound;
  Mo_bound->at[3][5] = moved_3_bound;
  Mo_bound->at[4][5] = moved_4_bound;
  Mo_bound->at[5][5] = moved_5_bound;
}

/* Mo = [Ad]*(R) M [Ad]^-1(R), the articulated inertia M rotated by R; M is symmetric, only its
     lower triangle is read; |error of Mo| <= Mo_bound unless inf or NaN.
   R: rotation or other 3×3 matrix; M, Mo, Mo_bound: 6×6 operator.
   228 mul, 240 add, 90 abs. */
static inline void ksl_mat6x6f_rotated_certified(const ksl_mat3x3f_t *R, const ksl_mat6x6f_t *M,
    ksl_mat6x6f_t *Mo, ksl_mat6x6f_t *Mo_bound) {
  const float RM_0a = KSL_MULF(R->m00, M->at[0][0]), RM_0b = KSL_MULF(R->m01, M->at[0][1]),
      RM_0d = KSL_MULF(R->m02, M->at[0][2]), RM_0 = RM_0a + RM_0b + RM_0d;
  const float RM_1a = KSL_MULF(R->m00, M->at[0][1]), RM_1b = KSL_MULF(R->m01, M->at[1][1]),
      RM_1d = KSL_MULF(R->m02, M->at[1][2]), RM_1 = RM_1a + RM_1b + RM_1d;
  const float RM_2a = KSL_MULF(R->m00, M->at[0][2]), RM_2b = KSL_MULF(R->m01, M->at[1][2]),
      RM_2d = KSL_MULF(R->m02, M->at[2][2]), RM_2 = RM_2a + RM_2b + RM_2d;
  const float RM_3a = KSL_MULF(R->m10, M->at[0][0]), RM_3b = KSL_MULF(R->m11, M->at[0][1]),
      RM_3d = KSL_MULF(R->m12, M->at[0][2]), RM_3 = RM_3a + RM_3b + RM_3d;
  const float RM_4a = KSL_MULF(R->m10, M->at[0][1]), RM_4b = KSL_MULF(R->m11, M->at[1][1]),
      RM_4d = KSL_MULF(R->m12, M->at[1][2]), RM_4 = RM_4a + RM_4b + RM_4d;
  const float RM_5a = KSL_MULF(R->m10, M->at[0][2]), RM_5b = KSL_MULF(R->m11, M->at[1][2]),
      RM_5d = KSL_MULF(R->m12, M->at[2][2]), RM_5 = RM_5a + RM_5b + RM_5d;
  const float RM_6a = KSL_MULF(R->m20, M->at[0][0]), RM_6b = KSL_MULF(R->m21, M->at[0][1]),
      RM_6d = KSL_MULF(R->m22, M->at[0][2]), RM_6 = RM_6a + RM_6b + RM_6d;
  const float RM_7a = KSL_MULF(R->m20, M->at[0][1]), RM_7b = KSL_MULF(R->m21, M->at[1][1]),
      RM_7d = KSL_MULF(R->m22, M->at[1][2]), RM_7 = RM_7a + RM_7b + RM_7d;
  const float RM_8a = KSL_MULF(R->m20, M->at[0][2]), RM_8b = KSL_MULF(R->m21, M->at[1][2]),
      RM_8d = KSL_MULF(R->m22, M->at[2][2]), RM_8 = RM_8a + RM_8b + RM_8d;
  const float linear_0 = KSL_MULF(R->m00, RM_0) + KSL_MULF(R->m01, RM_1) + KSL_MULF(R->m02, RM_2);
  const float linear_1 = KSL_MULF(R->m00, RM_3) + KSL_MULF(R->m01, RM_4) + KSL_MULF(R->m02, RM_5);
  const float linear_2 = KSL_MULF(R->m10, RM_3) + KSL_MULF(R->m11, RM_4) + KSL_MULF(R->m12, RM_5);
  const float linear_3 = KSL_MULF(R->m00, RM_6) + KSL_MULF(R->m01, RM_7) + KSL_MULF(R->m02, RM_8);
  const float linear_4 = KSL_MULF(R->m10, RM_6) + KSL_MULF(R->m11, RM_7) + KSL_MULF(R->m12, RM_8),
      linear_5 = KSL_MULF(R->m20, RM_6) + KSL_MULF(R->m21, RM_7) + KSL_MULF(R->m22, RM_8);
  const float RH_0a = KSL_MULF(R->m00, M->at[0][3]), RH_0b = KSL_MULF(R->m01, M->at[0][4]),
      RH_0d = KSL_MULF(R->m02, M->at[0][5]), RH_0 = RH_0a + RH_0b + RH_0d;
  const float RH_1a = KSL_MULF(R->m00, M->at[1][3]), RH_1b = KSL_MULF(R->m01, M->at[1][4]),
      RH_1d = KSL_MULF(R->m02, M->at[1][5]), RH_1 = RH_1a + RH_1b + RH_1d;
  const float RH_2a = KSL_MULF(R->m00, M->at[2][3]), RH_2b = KSL_MULF(R->m01, M->at[2][4]),
      RH_2d = KSL_MULF(R->m02, M->at[2][5]), RH_2 = RH_2a + RH_2b + RH_2d;
  const float RH_3a = KSL_MULF(R->m10, M->at[0][3]), RH_3b = KSL_MULF(R->m11, M->at[0][4]),
      RH_3d = KSL_MULF(R->m12, M->at[0][5]), RH_3 = RH_3a + RH_3b + RH_3d;
  const float RH_4a = KSL_MULF(R->m10, M->at[1][3]), RH_4b = KSL_MULF(R->m11, M->at[1][4]),
      RH_4d = KSL_MULF(R->m12, M->at[1][5]), RH_4 = RH_4a + RH_4b + RH_4d;
  const float RH_5a = KSL_MULF(R->m10, M->at[2][3]), RH_5b = KSL_MULF(R->m11, M->at[2][4]),
      RH_5d = KSL_MULF(R->m12, M->at[2][5]), RH_5 = RH_5a + RH_5b + RH_5d;
  const float RH_6a = KSL_MULF(R->m20, M->at[0][3]), RH_6b = KSL_MULF(R->m21, M->at[0][4]),
      RH_6d = KSL_MULF(R->m22, M->at[0][5]), RH_6 = RH_6a + RH_6b + RH_6d;
  const float RH_7a = KSL_MULF(R->m20, M->at[1][3]), RH_7b = KSL_MULF(R->m21, M->at[1][4]),
      RH_7d = KSL_MULF(R->m22, M->at[1][5]), RH_7 = RH_7a + RH_7b + RH_7d;
  const float RH_8a = KSL_MULF(R->m20, M->at[2][3]), RH_8b = KSL_MULF(R->m21, M->at[2][4]),
      RH_8d = KSL_MULF(R->m22, M->at[2][5]), RH_8 = RH_8a + RH_8b + RH_8d;
  const float coupling_0 = KSL_MULF(R->m00, RH_0) + KSL_MULF(R->m01, RH_1) + KSL_MULF(R->m02, RH_2);
  const float coupling_1 = KSL_MULF(R->m10, RH_0) + KSL_MULF(R->m11, RH_1) + KSL_MULF(R->m12, RH_2),
      coupling_2 = KSL_MULF(R->m20, RH_0) + KSL_MULF(R->m21, RH_1) + KSL_MULF(R->m22, RH_2);
  const float coupling_3 = KSL_MULF(R->m00, RH_3) + KSL_MULF(R->m01, RH_4) + KSL_MULF(R->m02, RH_5);
  const float coupling_4 = KSL_MULF(R->m10, RH_3) + KSL_MULF(R->m11, RH_4) + KSL_MULF(R->m12, RH_5),
      coupling_5 = KSL_MULF(R->m20, RH_3) + KSL_MULF(R->m21, RH_4) + KSL_MULF(R->m22, RH_5);
  const float coupling_6 = KSL_MULF(R->m00, RH_6) + KSL_MULF(R->m01, RH_7) + KSL_MULF(R->m02, RH_8);
  const float coupling_7 = KSL_MULF(R->m10, RH_6) + KSL_MULF(R->m11, RH_7) + KSL_MULF(R->m12, RH_8),
      coupling_8 = KSL_MULF(R->m20, RH_6) + KSL_MULF(R->m21, RH_7) + KSL_MULF(R->m22, RH_8);
  const float RI_0a = KSL_MULF(R->m00, M->at[3][3]), RI_0b = KSL_MULF(R->m01, M->at[3][4]),
      RI_0d = KSL_MULF(R->m02, M->at[3][5]), RI_0 = RI_0a + RI_0b + RI_0d;
  const float RI_1a = KSL_MULF(R->m00, M->at[3][4]), RI_1b = KSL_MULF(R->m01, M->at[4][4]),
      RI_1d = KSL_MULF(R->m02, M->at[4][5]), RI_1 = RI_1a + RI_1b + RI_1d;
  const float RI_2a = KSL_MULF(R->m00, M->at[3][5]), RI_2b = KSL_MULF(R->m01, M->at[4][5]),
      RI_2d = KSL_MULF(R->m02, M->at[5][5]), RI_2 = RI_2a + RI_2b + RI_2d;
  const float RI_3a = KSL_MULF(R->m10, M->at[3][3]), RI_3b = KSL_MULF(R->m11, M->at[3][4]),
      RI_3d = KSL_MULF(R->m12, M->at[3][5]), RI_3 = RI_3a + RI_3b + RI_3d;
  const float RI_4a = KSL_MULF(R->m10, M->at[3][4]), RI_4b = KSL_MULF(R->m11, M->at[4][4]),
      RI_4d = KSL_MULF(R->m12, M->at[4][5]), RI_4 = RI_4a + RI_4b + RI_4d;
  const float RI_5a = KSL_MULF(R->m10, M->at[3][5]), RI_5b = KSL_MULF(R->m11, M->at[4][5]),
      RI_5d = KSL_MULF(R->m12, M->at[5][5]), RI_5 = RI_5a + RI_5b + RI_5d;
  const float RI_6a = KSL_MULF(R->m20, M->at[3][3]), RI_6b = KSL_MULF(R->m21, M->at[3][4]),
      RI_6d = KSL_MULF(R->m22, M->at[3][5]), RI_6 = RI_6a + RI_6b + RI_6d;
  const float RI_7a = KSL_MULF(R->m20, M->at[3][4]), RI_7b = KSL_MULF(R->m21, M->at[4][4]),
      RI_7d = KSL_MULF(R->m22, M->at[4][5]), RI_7 = RI_7a + RI_7b + RI_7d;
  const float RI_8a = KSL_MULF(R->m20, M->at[3][5]), RI_8b = KSL_MULF(R->m21, M->at[4][5]),
      RI_8d = KSL_MULF(R->m22, M->at[5][5]), RI_8 = RI_8a + RI_8b + RI_8d;
  const float angular_0 = KSL_MULF(R->m00, RI_0) + KSL_MULF(R->m01, RI_1) + KSL_MULF(R->m02, RI_2);
  const float angular_1 = KSL_MULF(R->m00, RI_3) + KSL_MULF(R->m01, RI_4) + KSL_MULF(R->m02, RI_5);
  const float angular_2 = KSL_MULF(R->m10, RI_3) + KSL_MULF(R->m11, RI_4) + KSL_MULF(R->m12, RI_5);
  const float angular_3 = KSL_MULF(R->m00, RI_6) + KSL_MULF(R->m01, RI_7) + KSL_MULF(R->m02, RI_8);
  const float angular_4 = KSL_MULF(R->m10, RI_6) + KSL_MULF(R->m11, RI_7) + KSL_MULF(R->m12, RI_8),
      angular_5 = KSL_MULF(R->m20, RI_6) + KSL_MULF(R->m21, RI_7) + KSL_MULF(R->m22, RI_8);
  const float RM_0_size = fabsf(RM_0a) + fabsf(RM_0b) + fabsf(RM_0d),
      RM_1_size = fabsf(RM_1a) + fabsf(RM_1b) + fabsf(RM_1d),
      RM_2_size = fabsf(RM_2a) + fabsf(RM_2b) + fabsf(RM_2d),
      RM_3_size = fabsf(RM_3a) + fabsf(RM_3b) + fabsf(RM_3d),
      RM_4_size = fabsf(RM_4a) + fabsf(RM_4b) + fabsf(RM_4d),
      RM_5_size = fabsf(RM_5a) + fabsf(RM_5b) + fabsf(RM_5d),
      RM_6_size = fabsf(RM_6a) + fabsf(RM_6b) + fabsf(RM_6d),
      RM_7_size = fabsf(RM_7a) + fabsf(RM_7b) + fabsf(RM_7d),
      RM_8_size = fabsf(RM_8a) + fabsf(RM_8b) + fabsf(RM_8d);
  const float R_00_abs = fabsf(R->m00), R_01_abs = fabsf(R->m01), R_02_abs = fabsf(R->m02),
      linear_0c_size = KSL_MULF(R_00_abs, RM_0_size + 1.9721523e-31f)
          + KSL_MULF(R_01_abs, RM_1_size + 1.9721523e-31f),
      linear_0_size = linear_0c_size + KSL_MULF(R_02_abs, RM_2_size + 1.9721523e-31f);
  const float RM_3_padded = RM_3_size + 1.9721523e-31f, RM_4_padded = RM_4_size + 1.9721523e-31f,
      RM_5_padded = RM_5_size + 1.9721523e-31f;
  const float linear_1_size = KSL_MULF(R_00_abs, RM_3_padded) + KSL_MULF(R_01_abs, RM_4_padded)
          + KSL_MULF(R_02_abs, RM_5_padded);
  const float R_10_abs = fabsf(R->m10), R_11_abs = fabsf(R->m11), R_12_abs = fabsf(R->m12),
      linear_2_size = KSL_MULF(R_10_abs, RM_3_padded) + KSL_MULF(R_11_abs, RM_4_padded)
          + KSL_MULF(R_12_abs, RM_5_padded);
  const float RM_6_padded = RM_6_size + 1.9721523e-31f, RM_7_padded = RM_7_size + 1.9721523e-31f,
      RM_8_padded = RM_8_size + 1.9721523e-31f;
  const float linear_3_size = KSL_MULF(R_00_abs, RM_6_padded) + KSL_MULF(R_01_abs, RM_7_padded)
          + KSL_MULF(R_02_abs, RM_8_padded),
      linear_4_size = KSL_MULF(R_10_abs, RM_6_padded) + KSL_MULF(R_11_abs, RM_7_padded)
          + KSL_MULF(R_12_abs, RM_8_padded);
  const float R_20_abs = fabsf(R->m20), R_21_abs = fabsf(R->m21), R_22_abs = fabsf(R->m22),
      linear_5_size = KSL_MULF(R_20_abs, RM_6_padded) + KSL_MULF(R_21_abs, RM_7_padded)
          + KSL_MULF(R_22_abs, RM_8_padded);
  const float RH_0_size = fabsf(RH_0a) + fabsf(RH_0b) + fabsf(RH_0d),
      RH_1_size = fabsf(RH_1a) + fabsf(RH_1b) + fabsf(RH_1d),
      RH_2_size = fabsf(RH_2a) + fabsf(RH_2b) + fabsf(RH_2d),
      RH_3_size = fabsf(RH_3a) + fabsf(RH_3b) + fabsf(RH_3d),
      RH_4_size = fabsf(RH_4a) + fabsf(RH_4b) + fabsf(RH_4d),
      RH_5_size = fabsf(RH_5a) + fabsf(RH_5b) + fabsf(RH_5d),
      RH_6_size = fabsf(RH_6a) + fabsf(RH_6b) + fabsf(RH_6d),
      RH_7_size = fabsf(RH_7a) + fabsf(RH_7b) + fabsf(RH_7d),
      RH_8_size = fabsf(RH_8a) + fabsf(RH_8b) + fabsf(RH_8d);
  const float RH_0_padded = RH_0_size + 1.9721523e-31f, RH_1_padded = RH_1_size + 1.9721523e-31f,
      RH_2_padded = RH_2_size + 1.9721523e-31f;
  const float coupling_0_size = KSL_MULF(R_00_abs, RH_0_padded) + KSL_MULF(R_01_abs, RH_1_padded)
          + KSL_MULF(R_02_abs, RH_2_padded),
      coupling_1_size = KSL_MULF(R_10_abs, RH_0_padded) + KSL_MULF(R_11_abs, RH_1_padded)
          + KSL_MULF(R_12_abs, RH_2_padded),
      coupling_2_size = KSL_MULF(R_20_abs, RH_0_padded) + KSL_MULF(R_21_abs, RH_1_padded)
          + KSL_MULF(R_22_abs, RH_2_padded);
  const float RH_3_padded = RH_3_size + 1.9721523e-31f, RH_4_padded = RH_4_size + 1.9721523e-31f,
      RH_5_padded = RH_5_size + 1.9721523e-31f;
  const float coupling_3_size = KSL_MULF(R_00_abs, RH_3_padded) + KSL_MULF(R_01_abs, RH_4_padded)
          + KSL_MULF(R_02_abs, RH_5_padded),
      coupling_4_size = KSL_MULF(R_10_abs, RH_3_padded) + KSL_MULF(R_11_abs, RH_4_padded)
          + KSL_MULF(R_12_abs, RH_5_padded),
      coupling_5_size = KSL_MULF(R_20_abs, RH_3_padded) + KSL_MULF(R_21_abs, RH_4_padded)
          + KSL_MULF(R_22_abs, RH_5_padded);
  const float RH_6_padded = RH_6_size + 1.9721523e-31f, RH_7_padded = RH_7_size + 1.9721523e-31f,
      RH_8_padded = RH_8_size + 1.9721523e-31f;
  const float coupling_6_size = KSL_MULF(R_00_abs, RH_6_padded) + KSL_MULF(R_01_abs, RH_7_padded)
          + KSL_MULF(R_02_abs, RH_8_padded),
      coupling_7_size = KSL_MULF(R_10_abs, RH_6_padded) + KSL_MULF(R_11_abs, RH_7_padded)
          + KSL_MULF(R_12_abs, RH_8_padded),
      coupling_8_size = KSL_MULF(R_20_abs, RH_6_padded) + KSL_MULF(R_21_abs, RH_7_padded)
          + KSL_MULF(R_22_abs, RH_8_padded);
  const float RI_0_size = fabsf(RI_0a) + fabsf(RI_0b) + fabsf(RI_0d),
      RI_1_size = fabsf(RI_1a) + fabsf(RI_1b) + fabsf(RI_1d),
      RI_2_size = fabsf(RI_2a) + fabsf(RI_2b) + fabsf(RI_2d),
      RI_3_size = fabsf(RI_3a) + fabsf(RI_3b) + fabsf(RI_3d),
      RI_4_size = fabsf(RI_4a) + fabsf(RI_4b) + fabsf(RI_4d),
      RI_5_size = fabsf(RI_5a) + fabsf(RI_5b) + fabsf(RI_5d),
      RI_6_size = fabsf(RI_6a) + fabsf(RI_6b) + fabsf(RI_6d),
      RI_7_size = fabsf(RI_7a) + fabsf(RI_7b) + fabsf(RI_7d),
      RI_8_size = fabsf(RI_8a) + fabsf(RI_8b) + fabsf(RI_8d);
  const float angular_0c_size = KSL_MULF(R_00_abs, RI_0_size + 1.9721523e-31f)
          + KSL_MULF(R_01_abs, RI_1_size + 1.9721523e-31f),
      angular_0_size = angular_0c_size + KSL_MULF(R_02_abs, RI_2_size + 1.9721523e-31f);
  const float RI_3_padded = RI_3_size + 1.9721523e-31f, RI_4_padded = RI_4_size + 1.9721523e-31f,
      RI_5_padded = RI_5_size + 1.9721523e-31f;
  const float angular_1_size = KSL_MULF(R_00_abs, RI_3_padded) + KSL_MULF(R_01_abs, RI_4_padded)
          + KSL_MULF(R_02_abs, RI_5_padded),
      angular_2_size = KSL_MULF(R_10_abs, RI_3_padded) + KSL_MULF(R_11_abs, RI_4_padded)
          + KSL_MULF(R_12_abs, RI_5_padded);
  const float RI_6_padded = RI_6_size + 1.9721523e-31f, RI_7_padded = RI_7_size + 1.9721523e-31f,
      RI_8_padded = RI_8_size + 1.9721523e-31f;
  const float angular_3_size = KSL_MULF(R_00_abs, RI_6_padded) + KSL_MULF(R_01_abs, RI_7_padded)
          + KSL_MULF(R_02_abs, RI_8_padded),
      angular_4_size = KSL_MULF(R_10_abs, RI_6_padded) + KSL_MULF(R_11_abs, RI_7_padded)
          + KSL_MULF(R_12_abs, RI_8_padded),
      angular_5_size = KSL_MULF(R_20_abs, RI_6_padded) + KSL_MULF(R_21_abs, RI_7_padded)
          + KSL_MULF(R_22_abs, RI_8_padded);
  const float linear_0_bound = KSL_MULF(3.5762795e-07f, linear_0_size + 1.9721523e-31f),
      linear_1_bound = KSL_MULF(3.5762795e-07f, linear_1_size + 1.9721523e-31f),
      linear_3_bound = KSL_MULF(3.5762795e-07f, linear_3_size + 1.9721523e-31f);
  const float coupling_0_bound = KSL_MULF(3.5762795e-07f, coupling_0_size + 1.9721523e-31f),
      coupling_3_bound = KSL_MULF(3.5762795e-07f, coupling_3_size + 1.9721523e-31f),
      coupling_6_bound = KSL_MULF(3.5762795e-07f, coupling_6_size + 1.9721523e-31f);
  const float linear_2_bound = KSL_MULF(3.5762795e-07f, linear_2_size + 1.9721523e-31f),
      linear_4_bound = KSL_MULF(3.5762795e-07f, linear_4_size + 1.9721523e-31f);
  const float coupling_1_bound = KSL_MULF(3.5762795e-07f, coupling_1_size + 1.9721523e-31f),
      coupling_4_bound = KSL_MULF(3.5762795e-07f, coupling_4_size + 1.9721523e-31f),
      coupling_7_bound = KSL_MULF(3.5762795e-07f, coupling_7_size + 1.9721523e-31f);
  const float linear_5_bound = KSL_MULF(3.5762795e-07f, linear_5_size + 1.9721523e-31f);
  const float coupling_2_bound = KSL_MULF(3.5762795e-07f, coupling_2_size + 1.9721523e-31f),
      coupling_5_bound = KSL_MULF(3.5762795e-07f, coupling_5_size + 1.9721523e-31f),
      coupling_8_bound = KSL_MULF(3.5762795e-07f, coupling_8_size + 1.9721523e-31f);
  const float angular_0_bound = KSL_MULF(3.5762795e-07f, angular_0_size + 1.9721523e-31f),
      angular_1_bound = KSL_MULF(3.5762795e-07f, angular_1_size + 1.9721523e-31f),
      angular_3_bound = KSL_MULF(3.5762795e-07f, angular_3_size + 1.9721523e-31f),
      angular_2_bound = KSL_MULF(3.5762795e-07f, angular_2_size + 1.9721523e-31f),
      angular_4_bound = KSL_MULF(3.5762795e-07f, angular_4_size + 1.9721523e-31f),
      angular_5_bound = KSL_MULF(3.5762795e-07f, angular_5_size + 1.9721523e-31f);
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
  Mo_bound->at[0][0] = linear_0_bound;
  Mo_bound->at[1][0] = linear_1_bound;
  Mo_bound->at[2][0] = linear_3_bound;
  Mo_bound->at[3][0] = coupling_0_bound;
  Mo_bound->at[4][0] = coupling_3_bound;
  Mo_bound->at[5][0] = coupling_6_bound;
  Mo_bound->at[0][1] = linear_1_bound;
  Mo_bound->at[1][1] = linear_2_bound;
  Mo_bound->at[2][1] = linear_4_bound;
  Mo_bound->at[3][1] = coupling_1_bound;
  Mo_bound->at[4][1] = coupling_4_bound;
  Mo_bound->at[5][1] = coupling_7_bound;
  Mo_bound->at[0][2] = linear_3_bound;
  Mo_bound->at[1][2] = linear_4_bound;
  Mo_bound->at[2][2] = linear_5_bound;
  Mo_bound->at[3][2] = coupling_2_bound;
  Mo_bound->at[4][2] = coupling_5_bound;
  Mo_bound->at[5][2] = coupling_8_bound;
  Mo_bound->at[0][3] = coupling_0_bound;
  Mo_bound->at[1][3] = coupling_1_bound;
  Mo_bound->at[2][3] = coupling_2_bound;
  Mo_bound->at[3][3] = angular_0_bound;
  Mo_bound->at[4][3] = angular_1_bound;
  Mo_bound->at[5][3] = angular_3_bound;
  Mo_bound->at[0][4] = coupling_3_bound;
  Mo_bound->at[1][4] = coupling_4_bound;
  Mo_bound->at[2][4] = coupling_5_bound;
  Mo_bound->at[3][4] = angular_1_bound;
  Mo_bound->at[4][4] = angular_2_bound;
  Mo_bound->at[5][4] = angular_4_bound;
  Mo_bound->at[0][5] = coupling_6_bound;
  Mo_bound->at[1][5] = coupling_7_bound;
  Mo_bound->at[2][5] = coupling_8_bound;
  Mo_bound->at[3][5] = angular_3_bound;
  Mo_bound->at[4][5] = angular_4_bound;
  Mo_bound->at[5][5] = angular_5_bound;
}

/* Mo = [Ad]*(t) M [Ad]^-1(t), the articulated inertia M shifted by t; M is symmetric, only its
     lower triangle is read; |error of Mo| <= Mo_bound unless inf or NaN.
   t: vector; M, Mo, Mo_bound: 6×6 operator.
   66 mul, 99 add, 45 abs. */
static inline void ksl_mat6x6f_shifted_certified(const ksl_vec3f_t *t, const ksl_mat6x6f_t *M,
    ksl_mat6x6f_t *Mo, ksl_mat6x6f_t *Mo_bound) {
  const float G_0a = KSL_MULF(t->y, M->at[0][2]), G_0b = KSL_MULF(t->z, M->at[0][1]),
      G_0 = G_0a - G_0b + M->at[0][3];
  const float G_1a = KSL_MULF(t->y, M->at[1][2]), G_1b = KSL_MULF(t->z, M->at[1][1]),
      G_1 = G_1a - G_1b + M->at[1][3];
  const float G_2a = KSL_MULF(t->y, M->at[2][2]), G_2b = KSL_MULF(t->z, M->at[1][2]),
      G_2 = G_2a - G_2b + M->at[2][3];
  const float G_3a = KSL_MULF(t->z, M->at[0][0]), G_3b = KSL_MULF(t->x, M->at[0][2]),
      G_3 = G_3a - G_3b + M->at[0][4];
  const float G_4a = KSL_MULF(t->x, M->at[1][2]), G_4 = G_0b - G_4a + M->at[1][4];
  const float G_5a = KSL_MULF(t->z, M->at[0][2]), G_5b = KSL_MULF(t->x, M->at[2][2]),
      G_5 = G_5a - G_5b + M->at[2][4];
  const float G_6a = KSL_MULF(t->x, M->at[0][1]), G_6b = KSL_MULF(t->y, M->at[0][0]),
      G_6 = G_6a - G_6b + M->at[0][5];
  const float G_7a = KSL_MULF(t->x, M->at[1][1]), G_7b = KSL_MULF(t->y, M->at[0][1]),
      G_7 = G_7a - G_7b + M->at[1][5];
  const float G_8 = G_4a - G_0a + M->at[2][5];
  const float moved_0a = KSL_MULF(t->y, M->at[2][3]), moved_0b = KSL_MULF(t->z, M->at[1][3]),
      moved_0 = moved_0a - moved_0b + (KSL_MULF(t->y, G_2) - KSL_MULF(t->z, G_1)) + M->at[3][3];
  const float moved_1a = KSL_MULF(t->z, M->at[0][3]), moved_1b = KSL_MULF(t->x, M->at[2][3]),
      moved_1 = moved_1a - moved_1b + (KSL_MULF(t->y, G_5) - KSL_MULF(t->z, G_4)) + M->at[3][4];
  const float moved_2a = KSL_MULF(t->z, M->at[0][4]), moved_2b = KSL_MULF(t->x, M->at[2][4]),
      moved_2 = moved_2a - moved_2b + (KSL_MULF(t->z, G_3) - KSL_MULF(t->x, G_5)) + M->at[4][4];
  const float moved_3a = KSL_MULF(t->x, M->at[1][3]), moved_3b = KSL_MULF(t->y, M->at[0][3]),
      moved_3 = moved_3a - moved_3b + (KSL_MULF(t->y, G_8) - KSL_MULF(t->z, G_7)) + M->at[3][5];
  const float moved_4a = KSL_MULF(t->x, M->at[1][4]), moved_4b = KSL_MULF(t->y, M->at[0][4]),
      moved_4 = moved_4a - moved_4b + (KSL_MULF(t->z, G_6) - KSL_MULF(t->x, G_8)) + M->at[4][5];
  const float moved_5a = KSL_MULF(t->x, M->at[1][5]), moved_5b = KSL_MULF(t->y, M->at[0][5]),
      moved_5 = moved_5a - moved_5b + (KSL_MULF(t->x, G_7) - KSL_MULF(t->y, G_6)) + M->at[5][5];
  const float G_0a_abs = fabsf(G_0a), G_0b_abs = fabsf(G_0b),
      G_0_size = G_0a_abs + G_0b_abs + fabsf(M->at[0][3]);
  const float G_1_size = fabsf(G_1a) + fabsf(G_1b) + fabsf(M->at[1][3]),
      G_2_size = fabsf(G_2a) + fabsf(G_2b) + fabsf(M->at[2][3]),
      G_3_size = fabsf(G_3a) + fabsf(G_3b) + fabsf(M->at[0][4]);
  const float G_4a_abs = fabsf(G_4a), G_4_size = G_0b_abs + G_4a_abs + fabsf(M->at[1][4]);
  const float G_5_size = fabsf(G_5a) + fabsf(G_5b) + fabsf(M->at[2][4]),
      G_6_size = fabsf(G_6a) + fabsf(G_6b) + fabsf(M->at[0][5]),
      G_7_size = fabsf(G_7a) + fabsf(G_7b) + fabsf(M->at[1][5]),
      G_8_size = G_4a_abs + G_0a_abs + fabsf(M->at[2][5]);
  const float G_2_padded = G_2_size + 1.9721523e-31f;
  const float t_1_abs = fabsf(t->y);
  const float G_1_padded = G_1_size + 1.9721523e-31f;
  const float t_2_abs = fabsf(t->z),
      moved_0_size = fabsf(moved_0a) + fabsf(moved_0b)
          + (KSL_MULF(t_1_abs, G_2_padded) + KSL_MULF(t_2_abs, G_1_padded)) + fabsf(M->at[3][3]);
  const float G_5_padded = G_5_size + 1.9721523e-31f, G_4_padded = G_4_size + 1.9721523e-31f;
  const float moved_1_size = fabsf(moved_1a) + fabsf(moved_1b)
          + (KSL_MULF(t_1_abs, G_5_padded) + KSL_MULF(t_2_abs, G_4_padded)) + fabsf(M->at[3][4]);
  const float G_3_padded = G_3_size + 1.9721523e-31f;
  const float t_0_abs = fabsf(t->x),
      moved_2_size = fabsf(moved_2a) + fabsf(moved_2b)
          + (KSL_MULF(t_2_abs, G_3_padded) + KSL_MULF(t_0_abs, G_5_padded)) + fabsf(M->at[4][4]);
  const float G_8_padded = G_8_size + 1.9721523e-31f, G_7_padded = G_7_size + 1.9721523e-31f;
  const float moved_3_size = fabsf(moved_3a) + fabsf(moved_3b)
          + (KSL_MULF(t_1_abs, G_8_padded) + KSL_MULF(t_2_abs, G_7_padded)) + fabsf(M->at[3][5]);
  const float G_6_padded = G_6_size + 1.9721523e-31f;
  const float moved_4_size = fabsf(moved_4a) + fabsf(moved_4b)
          + (KSL_MULF(t_2_abs, G_6_padded) + KSL_MULF(t_0_abs, G_8_padded)) + fabsf(M->at[4][5]),
      moved_5_size = fabsf(moved_5a) + fabsf(moved_5b)
          + (KSL_MULF(t_0_abs, G_7_padded) + KSL_MULF(t_1_abs, G_6_padded)) + fabsf(M->at[5][5]);
  const float G_0_bound = KSL_MULF(1.7881396e-07f, G_0_size + 1.9721523e-31f),
      G_3_bound = KSL_MULF(1.7881396e-07f, G_3_padded),
      G_6_bound = KSL_MULF(1.7881396e-07f, G_6_padded),
      G_1_bound = KSL_MULF(1.7881396e-07f, G_1_padded),
      G_4_bound = KSL_MULF(1.7881396e-07f, G_4_padded),
      G_7_bound = KSL_MULF(1.7881396e-07f, G_7_padded),
      G_2_bound = KSL_MULF(1.7881396e-07f, G_2_padded),
      G_5_bound = KSL_MULF(1.7881396e-07f, G_5_padded),
      G_8_bound = KSL_MULF(1.7881396e-07f, G_8_padded);
  const float moved_0_bound = KSL_MULF(4.1723263e-07f, moved_0_size + 1.9721523e-31f),
      moved_1_bound = KSL_MULF(4.1723263e-07f, moved_1_size + 1.9721523e-31f),
      moved_3_bound = KSL_MULF(4.1723263e-07f, moved_3_size + 1.9721523e-31f),
      moved_2_bound = KSL_MULF(4.1723263e-07f, moved_2_size + 1.9721523e-31f),
      moved_4_bound = KSL_MULF(4.1723263e-07f, moved_4_size + 1.9721523e-31f),
      moved_5_bound = KSL_MULF(4.1723263e-07f, moved_5_size + 1.9721523e-31f);
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
  Mo_bound->at[0][0] = 0.0f;
  Mo_bound->at[1][0] = 0.0f;
  Mo_bound->at[2][0] = 0.0f;
  Mo_bound->at[3][0] = G_0_bound;
  Mo_bound->at[4][0] = G_3_bound;
  Mo_bound->at[5][0] = G_6_bound;
  Mo_bound->at[0][1] = 0.0f;
  Mo_bound->at[1][1] = 0.0f;
  Mo_bound->at[2][1] = 0.0f;
  Mo_bound->at[3][1] = G_1_bound;
  Mo_bound->at[4][1] = G_4_bound;
  Mo_bound->at[5][1] = G_7_bound;
  Mo_bound->at[0][2] = 0.0f;
  Mo_bound->at[1][2] = 0.0f;
  Mo_bound->at[2][2] = 0.0f;
  Mo_bound->at[3][2] = G_2_bound;
  Mo_bound->at[4][2] = G_5_bound;
  Mo_bound->at[5][2] = G_8_bound;
  Mo_bound->at[0][3] = G_0_bound;
  Mo_bound->at[1][3] = G_1_bound;
  Mo_bound->at[2][3] = G_2_bound;
  Mo_bound->at[3][3] = moved_0_bound;
  Mo_bound->at[4][3] = moved_1_bound;
  Mo_bound->at[5][3] = moved_3_bound;
  Mo_bound->at[0][4] = G_3_bound;
  Mo_bound->at[1][4] = G_4_bound;
  Mo_bound->at[2][4] = G_5_bound;
  Mo_bound->at[3][4] = moved_1_bound;
  Mo_bound->at[4][4] = moved_2_bound;
  Mo_bound->at[5][4] = moved_4_bound;
  Mo_bound->at[0][5] = G_6_bound;
  Mo_bound->at[1][5] = G_7_bound;
  Mo_bound->at[2][5] = G_8_bound;
  Mo_bound->at[3][5] = moved_3_bound;
  Mo_bound->at[4][5] = moved_4_bound;
  Mo_bound->at[5][5] = moved_5_bound;
}

#endif
