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
  const double RM_0a_abs = fabs(RM_0a), RM_0b_abs = fabs(RM_0b), RM_0c_size = RM_0a_abs + RM_0b_abs,
      RM_0d_abs = fabs(RM_0d), RM_0_size = RM_0c_size + RM_0d_abs;
  const double RM_1a_abs = fabs(RM_1a), RM_1b_abs = fabs(RM_1b), RM_1c_size = RM_1a_abs + RM_1b_abs,
      RM_1d_abs = fabs(RM_1d), RM_1_size = RM_1c_size + RM_1d_abs;
  const double RM_2a_abs = fabs(RM_2a), RM_2b_abs = fabs(RM_2b), RM_2c_size = RM_2a_abs + RM_2b_abs,
      RM_2d_abs = fabs(RM_2d), RM_2_size = RM_2c_size + RM_2d_abs;
  const double RM_3a_abs = fabs(RM_3a), RM_3b_abs = fabs(RM_3b), RM_3c_size = RM_3a_abs + RM_3b_abs,
      RM_3d_abs = fabs(RM_3d), RM_3_size = RM_3c_size + RM_3d_abs;
  const double RM_4a_abs = fabs(RM_4a), RM_4b_abs = fabs(RM_4b), RM_4c_size = RM_4a_abs + RM_4b_abs,
      RM_4d_abs = fabs(RM_4d), RM_4_size = RM_4c_size + RM_4d_abs;
  const double RM_5a_abs = fabs(RM_5a), RM_5b_abs = fabs(RM_5b), RM_5c_size = RM_5a_abs + RM_5b_abs,
      RM_5d_abs = fabs(RM_5d), RM_5_size = RM_5c_size + RM_5d_abs;
  const double RM_6a_abs = fabs(RM_6a), RM_6b_abs = fabs(RM_6b), RM_6c_size = RM_6a_abs + RM_6b_abs,
      RM_6d_abs = fabs(RM_6d), RM_6_size = RM_6c_size + RM_6d_abs;
  const double RM_7a_abs = fabs(RM_7a), RM_7b_abs = fabs(RM_7b), RM_7c_size = RM_7a_abs + RM_7b_abs,
      RM_7d_abs = fabs(RM_7d), RM_7_size = RM_7c_size + RM_7d_abs;
  const double RM_8a_abs = fabs(RM_8a), RM_8b_abs = fabs(RM_8b), RM_8c_size = RM_8a_abs + RM_8b_abs,
      RM_8d_abs = fabs(RM_8d), RM_8_size = RM_8c_size + RM_8d_abs;
  const double RM_0_padded = RM_0_size + 2.004168360008973e-292;
  const double R_00_abs = fabs(R->m00), linear_0a_size = KSL_MUL(R_00_abs, RM_0_padded);
  const double RM_1_padded = RM_1_size + 2.004168360008973e-292;
  const double R_01_abs = fabs(R->m01), linear_0b_size = KSL_MUL(R_01_abs, RM_1_padded),
      linear_0c_size = linear_0a_size + linear_0b_size;
  const double RM_2_padded = RM_2_size + 2.004168360008973e-292;
  const double R_02_abs = fabs(R->m02), linear_0d_size = KSL_MUL(R_02_abs, RM_2_padded),
      linear_0_size = linear_0c_size + linear_0d_size;
  const double RM_3_padded = RM_3_size + 2.004168360008973e-292;
  const double linear_1a_size = KSL_MUL(R_00_abs, RM_3_padded);
  const double RM_4_padded = RM_4_size + 2.004168360008973e-292;
  const double linear_1b_size = KSL_MUL(R_01_abs, RM_4_padded),
      linear_1c_size = linear_1a_size + linear_1b_size;
  const double RM_5_padded = RM_5_size + 2.004168360008973e-292;
  const double linear_1d_size = KSL_MUL(R_02_abs, RM_5_padded),
      linear_1_size = linear_1c_size + linear_1d_size;
  const double R_10_abs = fabs(R->m10), linear_2a_size = KSL_MUL(R_10_abs, RM_3_padded),
      R_11_abs = fabs(R->m11), linear_2b_size = KSL_MUL(R_11_abs, RM_4_padded),
      linear_2c_size = linear_2a_size + linear_2b_size, R_12_abs = fabs(R->m12),
      linear_2d_size = KSL_MUL(R_12_abs, RM_5_padded),
      linear_2_size = linear_2c_size + linear_2d_size;
  const double RM_6_padded = RM_6_size + 2.004168360008973e-292;
  const double linear_3a_size = KSL_MUL(R_00_abs, RM_6_padded);
  const double RM_7_padded = RM_7_size + 2.004168360008973e-292;
  const double linear_3b_size = KSL_MUL(R_01_abs, RM_7_padded),
      linear_3c_size = linear_3a_size + linear_3b_size;
  const double RM_8_padded = RM_8_size + 2.004168360008973e-292;
  const double linear_3d_size = KSL_MUL(R_02_abs, RM_8_padded),
      linear_3_size = linear_3c_size + linear_3d_size;
  const double linear_4a_size = KSL_MUL(R_10_abs, RM_6_padded),
      linear_4b_size = KSL_MUL(R_11_abs, RM_7_padded),
      linear_4c_size = linear_4a_size + linear_4b_size,
      linear_4d_size = KSL_MUL(R_12_abs, RM_8_padded),
      linear_4_size = linear_4c_size + linear_4d_size;
  const double R_20_abs = fabs(R->m20), linear_5a_size = KSL_MUL(R_20_abs, RM_6_padded),
      R_21_abs = fabs(R->m21), linear_5b_size = KSL_MUL(R_21_abs, RM_7_padded),
      linear_5c_size = linear_5a_size + linear_5b_size, R_22_abs = fabs(R->m22),
      linear_5d_size = KSL_MUL(R_22_abs, RM_8_padded),
      linear_5_size = linear_5c_size + linear_5d_size;
  const double RH_0a_abs = fabs(RH_0a), RH_0b_abs = fabs(RH_0b), RH_0c_size = RH_0a_abs + RH_0b_abs,
      RH_0d_abs = fabs(RH_0d), RH_0_size = RH_0c_size + RH_0d_abs;
  const double RH_1a_abs = fabs(RH_1a), RH_1b_abs = fabs(RH_1b), RH_1c_size = RH_1a_abs + RH_1b_abs,
      RH_1d_abs = fabs(RH_1d), RH_1_size = RH_1c_size + RH_1d_abs;
  const double RH_2a_abs = fabs(RH_2a), RH_2b_abs = fabs(RH_2b), RH_2c_size = RH_2a_abs + RH_2b_abs,
      RH_2d_abs = fabs(RH_2d), RH_2_size = RH_2c_size + RH_2d_abs;
  const double RH_3a_abs = fabs(RH_3a), RH_3b_abs = fabs(RH_3b), RH_3c_size = RH_3a_abs + RH_3b_abs,
      RH_3d_abs = fabs(RH_3d), RH_3_size = RH_3c_size + RH_3d_abs;
  const double RH_4a_abs = fabs(RH_4a), RH_4b_abs = fabs(RH_4b), RH_4c_size = RH_4a_abs + RH_4b_abs,
      RH_4d_abs = fabs(RH_4d), RH_4_size = RH_4c_size + RH_4d_abs;
  const double RH_5a_abs = fabs(RH_5a), RH_5b_abs = fabs(RH_5b), RH_5c_size = RH_5a_abs + RH_5b_abs,
      RH_5d_abs = fabs(RH_5d), RH_5_size = RH_5c_size + RH_5d_abs;
  const double RH_6a_abs = fabs(RH_6a), RH_6b_abs = fabs(RH_6b), RH_6c_size = RH_6a_abs + RH_6b_abs,
      RH_6d_abs = fabs(RH_6d), RH_6_size = RH_6c_size + RH_6d_abs;
  const double RH_7a_abs = fabs(RH_7a), RH_7b_abs = fabs(RH_7b), RH_7c_size = RH_7a_abs + RH_7b_abs,
      RH_7d_abs = fabs(RH_7d), RH_7_size = RH_7c_size + RH_7d_abs;
  const double RH_8a_abs = fabs(RH_8a), RH_8b_abs = fabs(RH_8b), RH_8c_size = RH_8a_abs + RH_8b_abs,
      RH_8d_abs = fabs(RH_8d), RH_8_size = RH_8c_size + RH_8d_abs;
  const double RH_0_padded = RH_0_size + 2.004168360008973e-292;
  const double coupling_0a_size = KSL_MUL(R_00_abs, RH_0_padded);
  const double RH_1_padded = RH_1_size + 2.004168360008973e-292;
  const double coupling_0b_size = KSL_MUL(R_01_abs, RH_1_padded),
      coupling_0c_size = coupling_0a_size + coupling_0b_size;
  const double RH_2_padded = RH_2_size + 2.004168360008973e-292;
  const double coupling_0d_size = KSL_MUL(R_02_abs, RH_2_padded),
      coupling_0_size = coupling_0c_size + coupling_0d_size;
  const double coupling_1a_size = KSL_MUL(R_10_abs, RH_0_padded),
      coupling_1b_size = KSL_MUL(R_11_abs, RH_1_padded),
      coupling_1c_size = coupling_1a_size + coupling_1b_size,
      coupling_1d_size = KSL_MUL(R_12_abs, RH_2_padded),
      coupling_1_size = coupling_1c_size + coupling_1d_size;
  const double coupling_2a_size = KSL_MUL(R_20_abs, RH_0_padded),
      coupling_2b_size = KSL_MUL(R_21_abs, RH_1_padded),
      coupling_2c_size = coupling_2a_size + coupling_2b_size,
      coupling_2d_size = KSL_MUL(R_22_abs, RH_2_padded),
      coupling_2_size = coupling_2c_size + coupling_2d_size;
  const double RH_3_padded = RH_3_size + 2.004168360008973e-292;
  const double coupling_3a_size = KSL_MUL(R_00_abs, RH_3_padded);
  const double RH_4_padded = RH_4_size + 2.004168360008973e-292;
  const double coupling_3b_size = KSL_MUL(R_01_abs, RH_4_padded),
      coupling_3c_size = coupling_3a_size + coupling_3b_size;
  const double RH_5_padded = RH_5_size + 2.004168360008973e-292;
  const double coupling_3d_size = KSL_MUL(R_02_abs, RH_5_padded),
      coupling_3_size = coupling_3c_size + coupling_3d_size;
  const double coupling_4a_size = KSL_MUL(R_10_abs, RH_3_padded),
      coupling_4b_size = KSL_MUL(R_11_abs, RH_4_padded),
      coupling_4c_size = coupling_4a_size + coupling_4b_size,
      coupling_4d_size = KSL_MUL(R_12_abs, RH_5_padded),
      coupling_4_size = coupling_4c_size + coupling_4d_size;
  const double coupling_5a_size = KSL_MUL(R_20_abs, RH_3_padded),
      coupling_5b_size = KSL_MUL(R_21_abs, RH_4_padded),
      coupling_5c_size = coupling_5a_size + coupling_5b_size,
      coupling_5d_size = KSL_MUL(R_22_abs, RH_5_padded),
      coupling_5_size = coupling_5c_size + coupling_5d_size;
  const double RH_6_padded = RH_6_size + 2.004168360008973e-292;
  const double coupling_6a_size = KSL_MUL(R_00_abs, RH_6_padded);
  const double RH_7_padded = RH_7_size + 2.004168360008973e-292;
  const double coupling_6b_size = KSL_MUL(R_01_abs, RH_7_padded),
      coupling_6c_size = coupling_6a_size + coupling_6b_size;
  const double RH_8_padded = RH_8_size + 2.004168360008973e-292;
  const double coupling_6d_size = KSL_MUL(R_02_abs, RH_8_padded),
      coupling_6_size = coupling_6c_size + coupling_6d_size;
  const double coupling_7a_size = KSL_MUL(R_10_abs, RH_6_padded),
      coupling_7b_size = KSL_MUL(R_11_abs, RH_7_padded),
      coupling_7c_size = coupling_7a_size + coupling_7b_size,
      coupling_7d_size = KSL_MUL(R_12_abs, RH_8_padded),
      coupling_7_size = coupling_7c_size + coupling_7d_size;
  const double coupling_8a_size = KSL_MUL(R_20_abs, RH_6_padded),
      coupling_8b_size = KSL_MUL(R_21_abs, RH_7_padded),
      coupling_8c_size = coupling_8a_size + coupling_8b_size,
      coupling_8d_size = KSL_MUL(R_22_abs, RH_8_padded),
      coupling_8_size = coupling_8c_size + coupling_8d_size;
  const double RI_0a_abs = fabs(RI_0a), RI_0b_abs = fabs(RI_0b), RI_0c_size = RI_0a_abs + RI_0b_abs,
      RI_0d_abs = fabs(RI_0d), RI_0_size = RI_0c_size + RI_0d_abs;
  const double RI_1a_abs = fabs(RI_1a), RI_1b_abs = fabs(RI_1b), RI_1c_size = RI_1a_abs + RI_1b_abs,
      RI_1d_abs = fabs(RI_1d), RI_1_size = RI_1c_size + RI_1d_abs;
  const double RI_2a_abs = fabs(RI_2a), RI_2b_abs = fabs(RI_2b), RI_2c_size = RI_2a_abs + RI_2b_abs,
      RI_2d_abs = fabs(RI_2d), RI_2_size = RI_2c_size + RI_2d_abs;
  const double RI_3a_abs = fabs(RI_3a), RI_3b_abs = fabs(RI_3b), RI_3c_size = RI_3a_abs + RI_3b_abs,
      RI_3d_abs = fabs(RI_3d), RI_3_size = RI_3c_size + RI_3d_abs;
  const double RI_4a_abs = fabs(RI_4a), RI_4b_abs = fabs(RI_4b), RI_4c_size = RI_4a_abs + RI_4b_abs,
      RI_4d_abs = fabs(RI_4d), RI_4_size = RI_4c_size + RI_4d_abs;
  const double RI_5a_abs = fabs(RI_5a), RI_5b_abs = fabs(RI_5b), RI_5c_size = RI_5a_abs + RI_5b_abs,
      RI_5d_abs = fabs(RI_5d), RI_5_size = RI_5c_size + RI_5d_abs;
  const double RI_6a_abs = fabs(RI_6a), RI_6b_abs = fabs(RI_6b), RI_6c_size = RI_6a_abs + RI_6b_abs,
      RI_6d_abs = fabs(RI_6d), RI_6_size = RI_6c_size + RI_6d_abs;
  const double RI_7a_abs = fabs(RI_7a), RI_7b_abs = fabs(RI_7b), RI_7c_size = RI_7a_abs + RI_7b_abs,
      RI_7d_abs = fabs(RI_7d), RI_7_size = RI_7c_size + RI_7d_abs;
  const double RI_8a_abs = fabs(RI_8a), RI_8b_abs = fabs(RI_8b), RI_8c_size = RI_8a_abs + RI_8b_abs,
      RI_8d_abs = fabs(RI_8d), RI_8_size = RI_8c_size + RI_8d_abs;
  const double RI_0_padded = RI_0_size + 2.004168360008973e-292;
  const double angular_0a_size = KSL_MUL(R_00_abs, RI_0_padded);
  const double RI_1_padded = RI_1_size + 2.004168360008973e-292;
  const double angular_0b_size = KSL_MUL(R_01_abs, RI_1_padded),
      angular_0c_size = angular_0a_size + angular_0b_size;
  const double RI_2_padded = RI_2_size + 2.004168360008973e-292;
  const double angular_0d_size = KSL_MUL(R_02_abs, RI_2_padded),
      angular_0_size = angular_0c_size + angular_0d_size;
  const double RI_3_padded = RI_3_size + 2.004168360008973e-292;
  const double angular_1a_size = KSL_MUL(R_00_abs, RI_3_padded);
  const double RI_4_padded = RI_4_size + 2.004168360008973e-292;
  const double angular_1b_size = KSL_MUL(R_01_abs, RI_4_padded),
      angular_1c_size = angular_1a_size + angular_1b_size;
  const double RI_5_padded = RI_5_size + 2.004168360008973e-292;
  const double angular_1d_size = KSL_MUL(R_02_abs, RI_5_padded),
      angular_1_size = angular_1c_size + angular_1d_size;
  const double angular_2a_size = KSL_MUL(R_10_abs, RI_3_padded),
      angular_2b_size = KSL_MUL(R_11_abs, RI_4_padded),
      angular_2c_size = angular_2a_size + angular_2b_size,
      angular_2d_size = KSL_MUL(R_12_abs, RI_5_padded),
      angular_2_size = angular_2c_size + angular_2d_size;
  const double RI_6_padded = RI_6_size + 2.004168360008973e-292;
  const double angular_3a_size = KSL_MUL(R_00_abs, RI_6_padded);
  const double RI_7_padded = RI_7_size + 2.004168360008973e-292;
  const double angular_3b_size = KSL_MUL(R_01_abs, RI_7_padded),
      angular_3c_size = angular_3a_size + angular_3b_size;
  const double RI_8_padded = RI_8_size + 2.004168360008973e-292;
  const double angular_3d_size = KSL_MUL(R_02_abs, RI_8_padded),
      angular_3_size = angular_3c_size + angular_3d_size;
  const double angular_4a_size = KSL_MUL(R_10_abs, RI_6_padded),
      angular_4b_size = KSL_MUL(R_11_abs, RI_7_padded),
      angular_4c_size = angular_4a_size + angular_4b_size,
      angular_4d_size = KSL_MUL(R_12_abs, RI_8_padded),
      angular_4_size = angular_4c_size + angular_4d_size;
  const double angular_5a_size = KSL_MUL(R_20_abs, RI_6_padded),
      angular_5b_size = KSL_MUL(R_21_abs, RI_7_padded),
      angular_5c_size = angular_5a_size + angular_5b_size,
      angular_5d_size = KSL_MUL(R_22_abs, RI_8_padded),
      angular_5_size = angular_5c_size + angular_5d_size;
  const double linear_0_padded = linear_0_size + 2.004168360008973e-292,
      linear_0_error_bound = KSL_MUL(6.661338147750942e-16, linear_0_padded);
  const double linear_1_padded = linear_1_size + 2.004168360008973e-292,
      linear_1_error_bound = KSL_MUL(6.661338147750942e-16, linear_1_padded);
  const double linear_3_padded = linear_3_size + 2.004168360008973e-292,
      linear_3_error_bound = KSL_MUL(6.661338147750942e-16, linear_3_padded);
  const double coupling_0_padded = coupling_0_size + 2.004168360008973e-292,
      coupling_0_error_bound = KSL_MUL(6.661338147750942e-16, coupling_0_padded);
  const double coupling_3_padded = coupling_3_size + 2.004168360008973e-292,
      coupling_3_error_bound = KSL_MUL(6.661338147750942e-16, coupling_3_padded);
  const double coupling_6_padded = coupling_6_size + 2.004168360008973e-292,
      coupling_6_error_bound = KSL_MUL(6.661338147750942e-16, coupling_6_padded);
  const double linear_2_padded = linear_2_size + 2.004168360008973e-292,
      linear_2_error_bound = KSL_MUL(6.661338147750942e-16, linear_2_padded);
  const double linear_4_padded = linear_4_size + 2.004168360008973e-292,
      linear_4_error_bound = KSL_MUL(6.661338147750942e-16, linear_4_padded);
  const double coupling_1_padded = coupling_1_size + 2.004168360008973e-292,
      coupling_1_error_bound = KSL_MUL(6.661338147750942e-16, coupling_1_padded);
  const double coupling_4_padded = coupling_4_size + 2.004168360008973e-292,
      coupling_4_error_bound = KSL_MUL(6.661338147750942e-16, coupling_4_padded);
  const double coupling_7_padded = coupling_7_size + 2.004168360008973e-292,
      coupling_7_error_bound = KSL_MUL(6.661338147750942e-16, coupling_7_padded);
  const double linear_5_padded = linear_5_size + 2.004168360008973e-292,
      linear_5_error_bound = KSL_MUL(6.661338147750942e-16, linear_5_padded);
  const double coupling_2_padded = coupling_2_size + 2.004168360008973e-292,
      coupling_2_error_bound = KSL_MUL(6.661338147750942e-16, coupling_2_padded);
  const double coupling_5_padded = coupling_5_size + 2.004168360008973e-292,
      coupling_5_error_bound = KSL_MUL(6.661338147750942e-16, coupling_5_padded);
  const double coupling_8_padded = coupling_8_size + 2.004168360008973e-292,
      coupling_8_error_bound = KSL_MUL(6.661338147750942e-16, coupling_8_padded);
  const double angular_0_padded = angular_0_size + 2.004168360008973e-292,
      angular_0_error_bound = KSL_MUL(6.661338147750942e-16, angular_0_padded);
  const double angular_1_padded = angular_1_size + 2.004168360008973e-292,
      angular_1_error_bound = KSL_MUL(6.661338147750942e-16, angular_1_padded);
  const double angular_3_padded = angular_3_size + 2.004168360008973e-292,
      angular_3_error_bound = KSL_MUL(6.661338147750942e-16, angular_3_padded);
  const double angular_2_padded = angular_2_size + 2.004168360008973e-292,
      angular_2_error_bound = KSL_MUL(6.661338147750942e-16, angular_2_padded);
  const double angular_4_padded = angular_4_size + 2.004168360008973e-292,
      angular_4_error_bound = KSL_MUL(6.661338147750942e-16, angular_4_padded);
  const double angular_5_padded = angular_5_size + 2.004168360008973e-292,
      angular_5_error_bound = KSL_MUL(6.661338147750942e-16, angular_5_padded);
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
  Mo_bound->at[0][0] = linear_0_error_bound;
  Mo_bound->at[1][0] = linear_1_error_bound;
  Mo_bound->at[2][0] = linear_3_error_bound;
  Mo_bound->at[3][0] = coupling_0_error_bound;
  Mo_bound->at[4][0] = coupling_3_error_bound;
  Mo_bound->at[5][0] = coupling_6_error_bound;
  Mo_bound->at[0][1] = linear_1_error_bound;
  Mo_bound->at[1][1] = linear_2_error_bound;
  Mo_bound->at[2][1] = linear_4_error_bound;
  Mo_bound->at[3][1] = coupling_1_error_bound;
  Mo_bound->at[4][1] = coupling_4_error_bound;
  Mo_bound->at[5][1] = coupling_7_error_bound;
  Mo_bound->at[0][2] = linear_3_error_bound;
  Mo_bound->at[1][2] = linear_4_error_bound;
  Mo_bound->at[2][2] = linear_5_error_bound;
  Mo_bound->at[3][2] = coupling_2_error_bound;
  Mo_bound->at[4][2] = coupling_5_error_bound;
  Mo_bound->at[5][2] = coupling_8_error_bound;
  Mo_bound->at[0][3] = coupling_0_error_bound;
  Mo_bound->at[1][3] = coupling_1_error_bound;
  Mo_bound->at[2][3] = coupling_2_error_bound;
  Mo_bound->at[3][3] = angular_0_error_bound;
  Mo_bound->at[4][3] = angular_1_error_bound;
  Mo_bound->at[5][3] = angular_3_error_bound;
  Mo_bound->at[0][4] = coupling_3_error_bound;
  Mo_bound->at[1][4] = coupling_4_error_bound;
  Mo_bound->at[2][4] = coupling_5_error_bound;
  Mo_bound->at[3][4] = angular_1_error_bound;
  Mo_bound->at[4][4] = angular_2_error_bound;
  Mo_bound->at[5][4] = angular_4_error_bound;
  Mo_bound->at[0][5] = coupling_6_error_bound;
  Mo_bound->at[1][5] = coupling_7_error_bound;
  Mo_bound->at[2][5] = coupling_8_error_bound;
  Mo_bound->at[3][5] = angular_3_error_bound;
  Mo_bound->at[4][5] = angular_4_error_bound;
  Mo_bound->at[5][5] = angular_5_error_bound;
}

/* Mo = [Ad]*(t) M [Ad]^-1(t), the articulated inertia M shifted by t; M is symmetric, only its
     lower triangle is read; |error of Mo| <= Mo_bound unless inf or NaN.
   t: vector; M, Mo, Mo_bound: 6×6 operator.
   66 mul, 99 add, 45 abs. */
static inline void ksl_mat6x6_shifted_certified(const ksl_vec3_t *t, const ksl_mat6x6_t *M,
    ksl_mat6x6_t *Mo, ksl_mat6x6_t *Mo_bound) {
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
  const double G_0a_abs = fabs(G_0a), G_0b_abs = fabs(G_0b), G_0c_size = G_0a_abs + G_0b_abs,
      M_30_abs = fabs(M->at[0][3]), G_0_size = G_0c_size + M_30_abs;
  const double G_1a_abs = fabs(G_1a), G_1b_abs = fabs(G_1b), G_1c_size = G_1a_abs + G_1b_abs,
      M_31_abs = fabs(M->at[1][3]), G_1_size = G_1c_size + M_31_abs;
  const double G_2a_abs = fabs(G_2a), G_2b_abs = fabs(G_2b), G_2c_size = G_2a_abs + G_2b_abs,
      M_32_abs = fabs(M->at[2][3]), G_2_size = G_2c_size + M_32_abs;
  const double G_3a_abs = fabs(G_3a), G_3b_abs = fabs(G_3b), G_3c_size = G_3a_abs + G_3b_abs,
      M_40_abs = fabs(M->at[0][4]), G_3_size = G_3c_size + M_40_abs;
  const double G_4a_abs = fabs(G_4a), G_4b_size = G_0b_abs + G_4a_abs, M_41_abs = fabs(M->at[1][4]),
      G_4_size = G_4b_size + M_41_abs;
  const double G_5a_abs = fabs(G_5a), G_5b_abs = fabs(G_5b), G_5c_size = G_5a_abs + G_5b_abs,
      M_42_abs = fabs(M->at[2][4]), G_5_size = G_5c_size + M_42_abs;
  const double G_6a_abs = fabs(G_6a), G_6b_abs = fabs(G_6b), G_6c_size = G_6a_abs + G_6b_abs,
      M_50_abs = fabs(M->at[0][5]), G_6_size = G_6c_size + M_50_abs;
  const double G_7a_abs = fabs(G_7a), G_7b_abs = fabs(G_7b), G_7c_size = G_7a_abs + G_7b_abs,
      M_51_abs = fabs(M->at[1][5]), G_7_size = G_7c_size + M_51_abs;
  const double G_8a_size = G_4a_abs + G_0a_abs, M_52_abs = fabs(M->at[2][5]),
      G_8_size = G_8a_size + M_52_abs;
  const double moved_0a_abs = fabs(moved_0a), moved_0b_abs = fabs(moved_0b),
      moved_0c_size = moved_0a_abs + moved_0b_abs;
  const double G_2_padded = G_2_size + 2.004168360008973e-292;
  const double t_1_abs = fabs(t->y), moved_0d_size = KSL_MUL(t_1_abs, G_2_padded);
  const double G_1_padded = G_1_size + 2.004168360008973e-292;
  const double t_2_abs = fabs(t->z), moved_0e_size = KSL_MUL(t_2_abs, G_1_padded),
      moved_0f_size = moved_0d_size + moved_0e_size, moved_0g_size = moved_0c_size + moved_0f_size,
      M_33_abs = fabs(M->at[3][3]), moved_0_size = moved_0g_size + M_33_abs;
  const double moved_1a_abs = fabs(moved_1a), moved_1b_abs = fabs(moved_1b),
      moved_1c_size = moved_1a_abs + moved_1b_abs;
  const double G_5_padded = G_5_size + 2.004168360008973e-292;
  const double moved_1d_size = KSL_MUL(t_1_abs, G_5_padded);
  const double G_4_padded = G_4_size + 2.004168360008973e-292;
  const double moved_1e_size = KSL_MUL(t_2_abs, G_4_padded),
      moved_1f_size = moved_1d_size + moved_1e_size, moved_1g_size = moved_1c_size + moved_1f_size,
      M_43_abs = fabs(M->at[3][4]), moved_1_size = moved_1g_size + M_43_abs;
  const double moved_2a_abs = fabs(moved_2a), moved_2b_abs = fabs(moved_2b),
      moved_2c_size = moved_2a_abs + moved_2b_abs;
  const double G_3_padded = G_3_size + 2.004168360008973e-292;
  const double moved_2d_size = KSL_MUL(t_2_abs, G_3_padded), t_0_abs = fabs(t->x),
      moved_2e_size = KSL_MUL(t_0_abs, G_5_padded), moved_2f_size = moved_2d_size + moved_2e_size,
      moved_2g_size = moved_2c_size + moved_2f_size, M_44_abs = fabs(M->at[4][4]),
      moved_2_size = moved_2g_size + M_44_abs;
  const double moved_3a_abs = fabs(moved_3a), moved_3b_abs = fabs(moved_3b),
      moved_3c_size = moved_3a_abs + moved_3b_abs;
  const double G_8_padded = G_8_size + 2.004168360008973e-292;
  const double moved_3d_size = KSL_MUL(t_1_abs, G_8_padded);
  const double G_7_padded = G_7_size + 2.004168360008973e-292;
  const double moved_3e_size = KSL_MUL(t_2_abs, G_7_padded),
      moved_3f_size = moved_3d_size + moved_3e_size, moved_3g_size = moved_3c_size + moved_3f_size,
      M_53_abs = fabs(M->at[3][5]), moved_3_size = moved_3g_size + M_53_abs;
  const double moved_4a_abs = fabs(moved_4a), moved_4b_abs = fabs(moved_4b),
      moved_4c_size = moved_4a_abs + moved_4b_abs;
  const double G_6_padded = G_6_size + 2.004168360008973e-292;
  const double moved_4d_size = KSL_MUL(t_2_abs, G_6_padded),
      moved_4e_size = KSL_MUL(t_0_abs, G_8_padded), moved_4f_size = moved_4d_size + moved_4e_size,
      moved_4g_size = moved_4c_size + moved_4f_size, M_54_abs = fabs(M->at[4][5]),
      moved_4_size = moved_4g_size + M_54_abs;
  const double moved_5a_abs = fabs(moved_5a), moved_5b_abs = fabs(moved_5b),
      moved_5c_size = moved_5a_abs + moved_5b_abs, moved_5d_size = KSL_MUL(t_0_abs, G_7_padded),
      moved_5e_size = KSL_MUL(t_1_abs, G_6_padded), moved_5f_size = moved_5d_size + moved_5e_size,
      moved_5g_size = moved_5c_size + moved_5f_size, M_55_abs = fabs(M->at[5][5]),
      moved_5_size = moved_5g_size + M_55_abs;
  const double G_0_padded = G_0_size + 2.004168360008973e-292,
      G_0_error_bound = KSL_MUL(3.3306690738754706e-16, G_0_padded);
  const double G_3_error_bound = KSL_MUL(3.3306690738754706e-16, G_3_padded);
  const double G_6_error_bound = KSL_MUL(3.3306690738754706e-16, G_6_padded);
  const double G_1_error_bound = KSL_MUL(3.3306690738754706e-16, G_1_padded);
  const double G_4_error_bound = KSL_MUL(3.3306690738754706e-16, G_4_padded);
  const double G_7_error_bound = KSL_MUL(3.3306690738754706e-16, G_7_padded);
  const double G_2_error_bound = KSL_MUL(3.3306690738754706e-16, G_2_padded);
  const double G_5_error_bound = KSL_MUL(3.3306690738754706e-16, G_5_padded);
  const double G_8_error_bound = KSL_MUL(3.3306690738754706e-16, G_8_padded);
  const double moved_0_padded = moved_0_size + 2.004168360008973e-292,
      moved_0_error_bound = KSL_MUL(7.7715611723761e-16, moved_0_padded);
  const double moved_1_padded = moved_1_size + 2.004168360008973e-292,
      moved_1_error_bound = KSL_MUL(7.7715611723761e-16, moved_1_padded);
  const double moved_3_padded = moved_3_size + 2.004168360008973e-292,
      moved_3_error_bound = KSL_MUL(7.7715611723761e-16, moved_3_padded);
  const double moved_2_padded = moved_2_size + 2.004168360008973e-292,
      moved_2_error_bound = KSL_MUL(7.7715611723761e-16, moved_2_padded);
  const double moved_4_padded = moved_4_size + 2.004168360008973e-292,
      moved_4_error_bound = KSL_MUL(7.7715611723761e-16, moved_4_padded);
  const double moved_5_padded = moved_5_size + 2.004168360008973e-292,
      moved_5_error_bound = KSL_MUL(7.7715611723761e-16, moved_5_padded);
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
  Mo_bound->at[3][0] = G_0_error_bound;
  Mo_bound->at[4][0] = G_3_error_bound;
  Mo_bound->at[5][0] = G_6_error_bound;
  Mo_bound->at[0][1] = 0.0;
  Mo_bound->at[1][1] = 0.0;
  Mo_bound->at[2][1] = 0.0;
  Mo_bound->at[3][1] = G_1_error_bound;
  Mo_bound->at[4][1] = G_4_error_bound;
  Mo_bound->at[5][1] = G_7_error_bound;
  Mo_bound->at[0][2] = 0.0;
  Mo_bound->at[1][2] = 0.0;
  Mo_bound->at[2][2] = 0.0;
  Mo_bound->at[3][2] = G_2_error_bound;
  Mo_bound->at[4][2] = G_5_error_bound;
  Mo_bound->at[5][2] = G_8_error_bound;
  Mo_bound->at[0][3] = G_0_error_bound;
  Mo_bound->at[1][3] = G_1_error_bound;
  Mo_bound->at[2][3] = G_2_error_bound;
  Mo_bound->at[3][3] = moved_0_error_bound;
  Mo_bound->at[4][3] = moved_1_error_bound;
  Mo_bound->at[5][3] = moved_3_error_bound;
  Mo_bound->at[0][4] = G_3_error_bound;
  Mo_bound->at[1][4] = G_4_error_bound;
  Mo_bound->at[2][4] = G_5_error_bound;
  Mo_bound->at[3][4] = moved_1_error_bound;
  Mo_bound->at[4][4] = moved_2_error_bound;
  Mo_bound->at[5][4] = moved_4_error_bound;
  Mo_bound->at[0][5] = G_6_error_bound;
  Mo_bound->at[1][5] = G_7_error_bound;
  Mo_bound->at[2][5] = G_8_error_bound;
  Mo_bound->at[3][5] = moved_3_error_bound;
  Mo_bound->at[4][5] = moved_4_error_bound;
  Mo_bound->at[5][5] = moved_5_error_bound;
}

/* Mo = [Ad]*(R) M [Ad]^-1(R), the articulated inertia M rotated by R; M is symmetric, only its
     lower triangle is read; |error of Mo| <= Mo_bound unless inf or NaN.
   R: rotation or other 3×3 matrix; M, Mo, Mo_bound: 6×6 operator.
   228 mul, 240 add, 90 abs. */
static inline void ksl_mat6x6f_rotated_certified(const ksl_mat3x3f_t *R, const ksl_mat6x6f_t *M,
    ksl_mat6x6f_t *Mo, ksl_mat6x6f_t *Mo_bound) {
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
  const float RM_0a_abs = fabsf(RM_0a), RM_0b_abs = fabsf(RM_0b),
      RM_0c_size = RM_0a_abs + RM_0b_abs, RM_0d_abs = fabsf(RM_0d),
      RM_0_size = RM_0c_size + RM_0d_abs;
  const float RM_1a_abs = fabsf(RM_1a), RM_1b_abs = fabsf(RM_1b),
      RM_1c_size = RM_1a_abs + RM_1b_abs, RM_1d_abs = fabsf(RM_1d),
      RM_1_size = RM_1c_size + RM_1d_abs;
  const float RM_2a_abs = fabsf(RM_2a), RM_2b_abs = fabsf(RM_2b),
      RM_2c_size = RM_2a_abs + RM_2b_abs, RM_2d_abs = fabsf(RM_2d),
      RM_2_size = RM_2c_size + RM_2d_abs;
  const float RM_3a_abs = fabsf(RM_3a), RM_3b_abs = fabsf(RM_3b),
      RM_3c_size = RM_3a_abs + RM_3b_abs, RM_3d_abs = fabsf(RM_3d),
      RM_3_size = RM_3c_size + RM_3d_abs;
  const float RM_4a_abs = fabsf(RM_4a), RM_4b_abs = fabsf(RM_4b),
      RM_4c_size = RM_4a_abs + RM_4b_abs, RM_4d_abs = fabsf(RM_4d),
      RM_4_size = RM_4c_size + RM_4d_abs;
  const float RM_5a_abs = fabsf(RM_5a), RM_5b_abs = fabsf(RM_5b),
      RM_5c_size = RM_5a_abs + RM_5b_abs, RM_5d_abs = fabsf(RM_5d),
      RM_5_size = RM_5c_size + RM_5d_abs;
  const float RM_6a_abs = fabsf(RM_6a), RM_6b_abs = fabsf(RM_6b),
      RM_6c_size = RM_6a_abs + RM_6b_abs, RM_6d_abs = fabsf(RM_6d),
      RM_6_size = RM_6c_size + RM_6d_abs;
  const float RM_7a_abs = fabsf(RM_7a), RM_7b_abs = fabsf(RM_7b),
      RM_7c_size = RM_7a_abs + RM_7b_abs, RM_7d_abs = fabsf(RM_7d),
      RM_7_size = RM_7c_size + RM_7d_abs;
  const float RM_8a_abs = fabsf(RM_8a), RM_8b_abs = fabsf(RM_8b),
      RM_8c_size = RM_8a_abs + RM_8b_abs, RM_8d_abs = fabsf(RM_8d),
      RM_8_size = RM_8c_size + RM_8d_abs;
  const float RM_0_padded = RM_0_size + 1.9721523e-31f;
  const float R_00_abs = fabsf(R->m00), linear_0a_size = KSL_MULF(R_00_abs, RM_0_padded);
  const float RM_1_padded = RM_1_size + 1.9721523e-31f;
  const float R_01_abs = fabsf(R->m01), linear_0b_size = KSL_MULF(R_01_abs, RM_1_padded),
      linear_0c_size = linear_0a_size + linear_0b_size;
  const float RM_2_padded = RM_2_size + 1.9721523e-31f;
  const float R_02_abs = fabsf(R->m02), linear_0d_size = KSL_MULF(R_02_abs, RM_2_padded),
      linear_0_size = linear_0c_size + linear_0d_size;
  const float RM_3_padded = RM_3_size + 1.9721523e-31f;
  const float linear_1a_size = KSL_MULF(R_00_abs, RM_3_padded);
  const float RM_4_padded = RM_4_size + 1.9721523e-31f;
  const float linear_1b_size = KSL_MULF(R_01_abs, RM_4_padded),
      linear_1c_size = linear_1a_size + linear_1b_size;
  const float RM_5_padded = RM_5_size + 1.9721523e-31f;
  const float linear_1d_size = KSL_MULF(R_02_abs, RM_5_padded),
      linear_1_size = linear_1c_size + linear_1d_size;
  const float R_10_abs = fabsf(R->m10), linear_2a_size = KSL_MULF(R_10_abs, RM_3_padded),
      R_11_abs = fabsf(R->m11), linear_2b_size = KSL_MULF(R_11_abs, RM_4_padded),
      linear_2c_size = linear_2a_size + linear_2b_size, R_12_abs = fabsf(R->m12),
      linear_2d_size = KSL_MULF(R_12_abs, RM_5_padded),
      linear_2_size = linear_2c_size + linear_2d_size;
  const float RM_6_padded = RM_6_size + 1.9721523e-31f;
  const float linear_3a_size = KSL_MULF(R_00_abs, RM_6_padded);
  const float RM_7_padded = RM_7_size + 1.9721523e-31f;
  const float linear_3b_size = KSL_MULF(R_01_abs, RM_7_padded),
      linear_3c_size = linear_3a_size + linear_3b_size;
  const float RM_8_padded = RM_8_size + 1.9721523e-31f;
  const float linear_3d_size = KSL_MULF(R_02_abs, RM_8_padded),
      linear_3_size = linear_3c_size + linear_3d_size;
  const float linear_4a_size = KSL_MULF(R_10_abs, RM_6_padded),
      linear_4b_size = KSL_MULF(R_11_abs, RM_7_padded),
      linear_4c_size = linear_4a_size + linear_4b_size,
      linear_4d_size = KSL_MULF(R_12_abs, RM_8_padded),
      linear_4_size = linear_4c_size + linear_4d_size;
  const float R_20_abs = fabsf(R->m20), linear_5a_size = KSL_MULF(R_20_abs, RM_6_padded),
      R_21_abs = fabsf(R->m21), linear_5b_size = KSL_MULF(R_21_abs, RM_7_padded),
      linear_5c_size = linear_5a_size + linear_5b_size, R_22_abs = fabsf(R->m22),
      linear_5d_size = KSL_MULF(R_22_abs, RM_8_padded),
      linear_5_size = linear_5c_size + linear_5d_size;
  const float RH_0a_abs = fabsf(RH_0a), RH_0b_abs = fabsf(RH_0b),
      RH_0c_size = RH_0a_abs + RH_0b_abs, RH_0d_abs = fabsf(RH_0d),
      RH_0_size = RH_0c_size + RH_0d_abs;
  const float RH_1a_abs = fabsf(RH_1a), RH_1b_abs = fabsf(RH_1b),
      RH_1c_size = RH_1a_abs + RH_1b_abs, RH_1d_abs = fabsf(RH_1d),
      RH_1_size = RH_1c_size + RH_1d_abs;
  const float RH_2a_abs = fabsf(RH_2a), RH_2b_abs = fabsf(RH_2b),
      RH_2c_size = RH_2a_abs + RH_2b_abs, RH_2d_abs = fabsf(RH_2d),
      RH_2_size = RH_2c_size + RH_2d_abs;
  const float RH_3a_abs = fabsf(RH_3a), RH_3b_abs = fabsf(RH_3b),
      RH_3c_size = RH_3a_abs + RH_3b_abs, RH_3d_abs = fabsf(RH_3d),
      RH_3_size = RH_3c_size + RH_3d_abs;
  const float RH_4a_abs = fabsf(RH_4a), RH_4b_abs = fabsf(RH_4b),
      RH_4c_size = RH_4a_abs + RH_4b_abs, RH_4d_abs = fabsf(RH_4d),
      RH_4_size = RH_4c_size + RH_4d_abs;
  const float RH_5a_abs = fabsf(RH_5a), RH_5b_abs = fabsf(RH_5b),
      RH_5c_size = RH_5a_abs + RH_5b_abs, RH_5d_abs = fabsf(RH_5d),
      RH_5_size = RH_5c_size + RH_5d_abs;
  const float RH_6a_abs = fabsf(RH_6a), RH_6b_abs = fabsf(RH_6b),
      RH_6c_size = RH_6a_abs + RH_6b_abs, RH_6d_abs = fabsf(RH_6d),
      RH_6_size = RH_6c_size + RH_6d_abs;
  const float RH_7a_abs = fabsf(RH_7a), RH_7b_abs = fabsf(RH_7b),
      RH_7c_size = RH_7a_abs + RH_7b_abs, RH_7d_abs = fabsf(RH_7d),
      RH_7_size = RH_7c_size + RH_7d_abs;
  const float RH_8a_abs = fabsf(RH_8a), RH_8b_abs = fabsf(RH_8b),
      RH_8c_size = RH_8a_abs + RH_8b_abs, RH_8d_abs = fabsf(RH_8d),
      RH_8_size = RH_8c_size + RH_8d_abs;
  const float RH_0_padded = RH_0_size + 1.9721523e-31f;
  const float coupling_0a_size = KSL_MULF(R_00_abs, RH_0_padded);
  const float RH_1_padded = RH_1_size + 1.9721523e-31f;
  const float coupling_0b_size = KSL_MULF(R_01_abs, RH_1_padded),
      coupling_0c_size = coupling_0a_size + coupling_0b_size;
  const float RH_2_padded = RH_2_size + 1.9721523e-31f;
  const float coupling_0d_size = KSL_MULF(R_02_abs, RH_2_padded),
      coupling_0_size = coupling_0c_size + coupling_0d_size;
  const float coupling_1a_size = KSL_MULF(R_10_abs, RH_0_padded),
      coupling_1b_size = KSL_MULF(R_11_abs, RH_1_padded),
      coupling_1c_size = coupling_1a_size + coupling_1b_size,
      coupling_1d_size = KSL_MULF(R_12_abs, RH_2_padded),
      coupling_1_size = coupling_1c_size + coupling_1d_size;
  const float coupling_2a_size = KSL_MULF(R_20_abs, RH_0_padded),
      coupling_2b_size = KSL_MULF(R_21_abs, RH_1_padded),
      coupling_2c_size = coupling_2a_size + coupling_2b_size,
      coupling_2d_size = KSL_MULF(R_22_abs, RH_2_padded),
      coupling_2_size = coupling_2c_size + coupling_2d_size;
  const float RH_3_padded = RH_3_size + 1.9721523e-31f;
  const float coupling_3a_size = KSL_MULF(R_00_abs, RH_3_padded);
  const float RH_4_padded = RH_4_size + 1.9721523e-31f;
  const float coupling_3b_size = KSL_MULF(R_01_abs, RH_4_padded),
      coupling_3c_size = coupling_3a_size + coupling_3b_size;
  const float RH_5_padded = RH_5_size + 1.9721523e-31f;
  const float coupling_3d_size = KSL_MULF(R_02_abs, RH_5_padded),
      coupling_3_size = coupling_3c_size + coupling_3d_size;
  const float coupling_4a_size = KSL_MULF(R_10_abs, RH_3_padded),
      coupling_4b_size = KSL_MULF(R_11_abs, RH_4_padded),
      coupling_4c_size = coupling_4a_size + coupling_4b_size,
      coupling_4d_size = KSL_MULF(R_12_abs, RH_5_padded),
      coupling_4_size = coupling_4c_size + coupling_4d_size;
  const float coupling_5a_size = KSL_MULF(R_20_abs, RH_3_padded),
      coupling_5b_size = KSL_MULF(R_21_abs, RH_4_padded),
      coupling_5c_size = coupling_5a_size + coupling_5b_size,
      coupling_5d_size = KSL_MULF(R_22_abs, RH_5_padded),
      coupling_5_size = coupling_5c_size + coupling_5d_size;
  const float RH_6_padded = RH_6_size + 1.9721523e-31f;
  const float coupling_6a_size = KSL_MULF(R_00_abs, RH_6_padded);
  const float RH_7_padded = RH_7_size + 1.9721523e-31f;
  const float coupling_6b_size = KSL_MULF(R_01_abs, RH_7_padded),
      coupling_6c_size = coupling_6a_size + coupling_6b_size;
  const float RH_8_padded = RH_8_size + 1.9721523e-31f;
  const float coupling_6d_size = KSL_MULF(R_02_abs, RH_8_padded),
      coupling_6_size = coupling_6c_size + coupling_6d_size;
  const float coupling_7a_size = KSL_MULF(R_10_abs, RH_6_padded),
      coupling_7b_size = KSL_MULF(R_11_abs, RH_7_padded),
      coupling_7c_size = coupling_7a_size + coupling_7b_size,
      coupling_7d_size = KSL_MULF(R_12_abs, RH_8_padded),
      coupling_7_size = coupling_7c_size + coupling_7d_size;
  const float coupling_8a_size = KSL_MULF(R_20_abs, RH_6_padded),
      coupling_8b_size = KSL_MULF(R_21_abs, RH_7_padded),
      coupling_8c_size = coupling_8a_size + coupling_8b_size,
      coupling_8d_size = KSL_MULF(R_22_abs, RH_8_padded),
      coupling_8_size = coupling_8c_size + coupling_8d_size;
  const float RI_0a_abs = fabsf(RI_0a), RI_0b_abs = fabsf(RI_0b),
      RI_0c_size = RI_0a_abs + RI_0b_abs, RI_0d_abs = fabsf(RI_0d),
      RI_0_size = RI_0c_size + RI_0d_abs;
  const float RI_1a_abs = fabsf(RI_1a), RI_1b_abs = fabsf(RI_1b),
      RI_1c_size = RI_1a_abs + RI_1b_abs, RI_1d_abs = fabsf(RI_1d),
      RI_1_size = RI_1c_size + RI_1d_abs;
  const float RI_2a_abs = fabsf(RI_2a), RI_2b_abs = fabsf(RI_2b),
      RI_2c_size = RI_2a_abs + RI_2b_abs, RI_2d_abs = fabsf(RI_2d),
      RI_2_size = RI_2c_size + RI_2d_abs;
  const float RI_3a_abs = fabsf(RI_3a), RI_3b_abs = fabsf(RI_3b),
      RI_3c_size = RI_3a_abs + RI_3b_abs, RI_3d_abs = fabsf(RI_3d),
      RI_3_size = RI_3c_size + RI_3d_abs;
  const float RI_4a_abs = fabsf(RI_4a), RI_4b_abs = fabsf(RI_4b),
      RI_4c_size = RI_4a_abs + RI_4b_abs, RI_4d_abs = fabsf(RI_4d),
      RI_4_size = RI_4c_size + RI_4d_abs;
  const float RI_5a_abs = fabsf(RI_5a), RI_5b_abs = fabsf(RI_5b),
      RI_5c_size = RI_5a_abs + RI_5b_abs, RI_5d_abs = fabsf(RI_5d),
      RI_5_size = RI_5c_size + RI_5d_abs;
  const float RI_6a_abs = fabsf(RI_6a), RI_6b_abs = fabsf(RI_6b),
      RI_6c_size = RI_6a_abs + RI_6b_abs, RI_6d_abs = fabsf(RI_6d),
      RI_6_size = RI_6c_size + RI_6d_abs;
  const float RI_7a_abs = fabsf(RI_7a), RI_7b_abs = fabsf(RI_7b),
      RI_7c_size = RI_7a_abs + RI_7b_abs, RI_7d_abs = fabsf(RI_7d),
      RI_7_size = RI_7c_size + RI_7d_abs;
  const float RI_8a_abs = fabsf(RI_8a), RI_8b_abs = fabsf(RI_8b),
      RI_8c_size = RI_8a_abs + RI_8b_abs, RI_8d_abs = fabsf(RI_8d),
      RI_8_size = RI_8c_size + RI_8d_abs;
  const float RI_0_padded = RI_0_size + 1.9721523e-31f;
  const float angular_0a_size = KSL_MULF(R_00_abs, RI_0_padded);
  const float RI_1_padded = RI_1_size + 1.9721523e-31f;
  const float angular_0b_size = KSL_MULF(R_01_abs, RI_1_padded),
      angular_0c_size = angular_0a_size + angular_0b_size;
  const float RI_2_padded = RI_2_size + 1.9721523e-31f;
  const float angular_0d_size = KSL_MULF(R_02_abs, RI_2_padded),
      angular_0_size = angular_0c_size + angular_0d_size;
  const float RI_3_padded = RI_3_size + 1.9721523e-31f;
  const float angular_1a_size = KSL_MULF(R_00_abs, RI_3_padded);
  const float RI_4_padded = RI_4_size + 1.9721523e-31f;
  const float angular_1b_size = KSL_MULF(R_01_abs, RI_4_padded),
      angular_1c_size = angular_1a_size + angular_1b_size;
  const float RI_5_padded = RI_5_size + 1.9721523e-31f;
  const float angular_1d_size = KSL_MULF(R_02_abs, RI_5_padded),
      angular_1_size = angular_1c_size + angular_1d_size;
  const float angular_2a_size = KSL_MULF(R_10_abs, RI_3_padded),
      angular_2b_size = KSL_MULF(R_11_abs, RI_4_padded),
      angular_2c_size = angular_2a_size + angular_2b_size,
      angular_2d_size = KSL_MULF(R_12_abs, RI_5_padded),
      angular_2_size = angular_2c_size + angular_2d_size;
  const float RI_6_padded = RI_6_size + 1.9721523e-31f;
  const float angular_3a_size = KSL_MULF(R_00_abs, RI_6_padded);
  const float RI_7_padded = RI_7_size + 1.9721523e-31f;
  const float angular_3b_size = KSL_MULF(R_01_abs, RI_7_padded),
      angular_3c_size = angular_3a_size + angular_3b_size;
  const float RI_8_padded = RI_8_size + 1.9721523e-31f;
  const float angular_3d_size = KSL_MULF(R_02_abs, RI_8_padded),
      angular_3_size = angular_3c_size + angular_3d_size;
  const float angular_4a_size = KSL_MULF(R_10_abs, RI_6_padded),
      angular_4b_size = KSL_MULF(R_11_abs, RI_7_padded),
      angular_4c_size = angular_4a_size + angular_4b_size,
      angular_4d_size = KSL_MULF(R_12_abs, RI_8_padded),
      angular_4_size = angular_4c_size + angular_4d_size;
  const float angular_5a_size = KSL_MULF(R_20_abs, RI_6_padded),
      angular_5b_size = KSL_MULF(R_21_abs, RI_7_padded),
      angular_5c_size = angular_5a_size + angular_5b_size,
      angular_5d_size = KSL_MULF(R_22_abs, RI_8_padded),
      angular_5_size = angular_5c_size + angular_5d_size;
  const float linear_0_padded = linear_0_size + 1.9721523e-31f,
      linear_0_error_bound = KSL_MULF(3.5762795e-07f, linear_0_padded);
  const float linear_1_padded = linear_1_size + 1.9721523e-31f,
      linear_1_error_bound = KSL_MULF(3.5762795e-07f, linear_1_padded);
  const float linear_3_padded = linear_3_size + 1.9721523e-31f,
      linear_3_error_bound = KSL_MULF(3.5762795e-07f, linear_3_padded);
  const float coupling_0_padded = coupling_0_size + 1.9721523e-31f,
      coupling_0_error_bound = KSL_MULF(3.5762795e-07f, coupling_0_padded);
  const float coupling_3_padded = coupling_3_size + 1.9721523e-31f,
      coupling_3_error_bound = KSL_MULF(3.5762795e-07f, coupling_3_padded);
  const float coupling_6_padded = coupling_6_size + 1.9721523e-31f,
      coupling_6_error_bound = KSL_MULF(3.5762795e-07f, coupling_6_padded);
  const float linear_2_padded = linear_2_size + 1.9721523e-31f,
      linear_2_error_bound = KSL_MULF(3.5762795e-07f, linear_2_padded);
  const float linear_4_padded = linear_4_size + 1.9721523e-31f,
      linear_4_error_bound = KSL_MULF(3.5762795e-07f, linear_4_padded);
  const float coupling_1_padded = coupling_1_size + 1.9721523e-31f,
      coupling_1_error_bound = KSL_MULF(3.5762795e-07f, coupling_1_padded);
  const float coupling_4_padded = coupling_4_size + 1.9721523e-31f,
      coupling_4_error_bound = KSL_MULF(3.5762795e-07f, coupling_4_padded);
  const float coupling_7_padded = coupling_7_size + 1.9721523e-31f,
      coupling_7_error_bound = KSL_MULF(3.5762795e-07f, coupling_7_padded);
  const float linear_5_padded = linear_5_size + 1.9721523e-31f,
      linear_5_error_bound = KSL_MULF(3.5762795e-07f, linear_5_padded);
  const float coupling_2_padded = coupling_2_size + 1.9721523e-31f,
      coupling_2_error_bound = KSL_MULF(3.5762795e-07f, coupling_2_padded);
  const float coupling_5_padded = coupling_5_size + 1.9721523e-31f,
      coupling_5_error_bound = KSL_MULF(3.5762795e-07f, coupling_5_padded);
  const float coupling_8_padded = coupling_8_size + 1.9721523e-31f,
      coupling_8_error_bound = KSL_MULF(3.5762795e-07f, coupling_8_padded);
  const float angular_0_padded = angular_0_size + 1.9721523e-31f,
      angular_0_error_bound = KSL_MULF(3.5762795e-07f, angular_0_padded);
  const float angular_1_padded = angular_1_size + 1.9721523e-31f,
      angular_1_error_bound = KSL_MULF(3.5762795e-07f, angular_1_padded);
  const float angular_3_padded = angular_3_size + 1.9721523e-31f,
      angular_3_error_bound = KSL_MULF(3.5762795e-07f, angular_3_padded);
  const float angular_2_padded = angular_2_size + 1.9721523e-31f,
      angular_2_error_bound = KSL_MULF(3.5762795e-07f, angular_2_padded);
  const float angular_4_padded = angular_4_size + 1.9721523e-31f,
      angular_4_error_bound = KSL_MULF(3.5762795e-07f, angular_4_padded);
  const float angular_5_padded = angular_5_size + 1.9721523e-31f,
      angular_5_error_bound = KSL_MULF(3.5762795e-07f, angular_5_padded);
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
  Mo_bound->at[0][0] = linear_0_error_bound;
  Mo_bound->at[1][0] = linear_1_error_bound;
  Mo_bound->at[2][0] = linear_3_error_bound;
  Mo_bound->at[3][0] = coupling_0_error_bound;
  Mo_bound->at[4][0] = coupling_3_error_bound;
  Mo_bound->at[5][0] = coupling_6_error_bound;
  Mo_bound->at[0][1] = linear_1_error_bound;
  Mo_bound->at[1][1] = linear_2_error_bound;
  Mo_bound->at[2][1] = linear_4_error_bound;
  Mo_bound->at[3][1] = coupling_1_error_bound;
  Mo_bound->at[4][1] = coupling_4_error_bound;
  Mo_bound->at[5][1] = coupling_7_error_bound;
  Mo_bound->at[0][2] = linear_3_error_bound;
  Mo_bound->at[1][2] = linear_4_error_bound;
  Mo_bound->at[2][2] = linear_5_error_bound;
  Mo_bound->at[3][2] = coupling_2_error_bound;
  Mo_bound->at[4][2] = coupling_5_error_bound;
  Mo_bound->at[5][2] = coupling_8_error_bound;
  Mo_bound->at[0][3] = coupling_0_error_bound;
  Mo_bound->at[1][3] = coupling_1_error_bound;
  Mo_bound->at[2][3] = coupling_2_error_bound;
  Mo_bound->at[3][3] = angular_0_error_bound;
  Mo_bound->at[4][3] = angular_1_error_bound;
  Mo_bound->at[5][3] = angular_3_error_bound;
  Mo_bound->at[0][4] = coupling_3_error_bound;
  Mo_bound->at[1][4] = coupling_4_error_bound;
  Mo_bound->at[2][4] = coupling_5_error_bound;
  Mo_bound->at[3][4] = angular_1_error_bound;
  Mo_bound->at[4][4] = angular_2_error_bound;
  Mo_bound->at[5][4] = angular_4_error_bound;
  Mo_bound->at[0][5] = coupling_6_error_bound;
  Mo_bound->at[1][5] = coupling_7_error_bound;
  Mo_bound->at[2][5] = coupling_8_error_bound;
  Mo_bound->at[3][5] = angular_3_error_bound;
  Mo_bound->at[4][5] = angular_4_error_bound;
  Mo_bound->at[5][5] = angular_5_error_bound;
}

/* Mo = [Ad]*(t) M [Ad]^-1(t), the articulated inertia M shifted by t; M is symmetric, only its
     lower triangle is read; |error of Mo| <= Mo_bound unless inf or NaN.
   t: vector; M, Mo, Mo_bound: 6×6 operator.
   66 mul, 99 add, 45 abs. */
static inline void ksl_mat6x6f_shifted_certified(const ksl_vec3f_t *t, const ksl_mat6x6f_t *M,
    ksl_mat6x6f_t *Mo, ksl_mat6x6f_t *Mo_bound) {
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
  const float G_0a_abs = fabsf(G_0a), G_0b_abs = fabsf(G_0b), G_0c_size = G_0a_abs + G_0b_abs,
      M_30_abs = fabsf(M->at[0][3]), G_0_size = G_0c_size + M_30_abs;
  const float G_1a_abs = fabsf(G_1a), G_1b_abs = fabsf(G_1b), G_1c_size = G_1a_abs + G_1b_abs,
      M_31_abs = fabsf(M->at[1][3]), G_1_size = G_1c_size + M_31_abs;
  const float G_2a_abs = fabsf(G_2a), G_2b_abs = fabsf(G_2b), G_2c_size = G_2a_abs + G_2b_abs,
      M_32_abs = fabsf(M->at[2][3]), G_2_size = G_2c_size + M_32_abs;
  const float G_3a_abs = fabsf(G_3a), G_3b_abs = fabsf(G_3b), G_3c_size = G_3a_abs + G_3b_abs,
      M_40_abs = fabsf(M->at[0][4]), G_3_size = G_3c_size + M_40_abs;
  const float G_4a_abs = fabsf(G_4a), G_4b_size = G_0b_abs + G_4a_abs,
      M_41_abs = fabsf(M->at[1][4]), G_4_size = G_4b_size + M_41_abs;
  const float G_5a_abs = fabsf(G_5a), G_5b_abs = fabsf(G_5b), G_5c_size = G_5a_abs + G_5b_abs,
      M_42_abs = fabsf(M->at[2][4]), G_5_size = G_5c_size + M_42_abs;
  const float G_6a_abs = fabsf(G_6a), G_6b_abs = fabsf(G_6b), G_6c_size = G_6a_abs + G_6b_abs,
      M_50_abs = fabsf(M->at[0][5]), G_6_size = G_6c_size + M_50_abs;
  const float G_7a_abs = fabsf(G_7a), G_7b_abs = fabsf(G_7b), G_7c_size = G_7a_abs + G_7b_abs,
      M_51_abs = fabsf(M->at[1][5]), G_7_size = G_7c_size + M_51_abs;
  const float G_8a_size = G_4a_abs + G_0a_abs, M_52_abs = fabsf(M->at[2][5]),
      G_8_size = G_8a_size + M_52_abs;
  const float moved_0a_abs = fabsf(moved_0a), moved_0b_abs = fabsf(moved_0b),
      moved_0c_size = moved_0a_abs + moved_0b_abs;
  const float G_2_padded = G_2_size + 1.9721523e-31f;
  const float t_1_abs = fabsf(t->y), moved_0d_size = KSL_MULF(t_1_abs, G_2_padded);
  const float G_1_padded = G_1_size + 1.9721523e-31f;
  const float t_2_abs = fabsf(t->z), moved_0e_size = KSL_MULF(t_2_abs, G_1_padded),
      moved_0f_size = moved_0d_size + moved_0e_size, moved_0g_size = moved_0c_size + moved_0f_size,
      M_33_abs = fabsf(M->at[3][3]), moved_0_size = moved_0g_size + M_33_abs;
  const float moved_1a_abs = fabsf(moved_1a), moved_1b_abs = fabsf(moved_1b),
      moved_1c_size = moved_1a_abs + moved_1b_abs;
  const float G_5_padded = G_5_size + 1.9721523e-31f;
  const float moved_1d_size = KSL_MULF(t_1_abs, G_5_padded);
  const float G_4_padded = G_4_size + 1.9721523e-31f;
  const float moved_1e_size = KSL_MULF(t_2_abs, G_4_padded),
      moved_1f_size = moved_1d_size + moved_1e_size, moved_1g_size = moved_1c_size + moved_1f_size,
      M_43_abs = fabsf(M->at[3][4]), moved_1_size = moved_1g_size + M_43_abs;
  const float moved_2a_abs = fabsf(moved_2a), moved_2b_abs = fabsf(moved_2b),
      moved_2c_size = moved_2a_abs + moved_2b_abs;
  const float G_3_padded = G_3_size + 1.9721523e-31f;
  const float moved_2d_size = KSL_MULF(t_2_abs, G_3_padded), t_0_abs = fabsf(t->x),
      moved_2e_size = KSL_MULF(t_0_abs, G_5_padded), moved_2f_size = moved_2d_size + moved_2e_size,
      moved_2g_size = moved_2c_size + moved_2f_size, M_44_abs = fabsf(M->at[4][4]),
      moved_2_size = moved_2g_size + M_44_abs;
  const float moved_3a_abs = fabsf(moved_3a), moved_3b_abs = fabsf(moved_3b),
      moved_3c_size = moved_3a_abs + moved_3b_abs;
  const float G_8_padded = G_8_size + 1.9721523e-31f;
  const float moved_3d_size = KSL_MULF(t_1_abs, G_8_padded);
  const float G_7_padded = G_7_size + 1.9721523e-31f;
  const float moved_3e_size = KSL_MULF(t_2_abs, G_7_padded),
      moved_3f_size = moved_3d_size + moved_3e_size, moved_3g_size = moved_3c_size + moved_3f_size,
      M_53_abs = fabsf(M->at[3][5]), moved_3_size = moved_3g_size + M_53_abs;
  const float moved_4a_abs = fabsf(moved_4a), moved_4b_abs = fabsf(moved_4b),
      moved_4c_size = moved_4a_abs + moved_4b_abs;
  const float G_6_padded = G_6_size + 1.9721523e-31f;
  const float moved_4d_size = KSL_MULF(t_2_abs, G_6_padded),
      moved_4e_size = KSL_MULF(t_0_abs, G_8_padded), moved_4f_size = moved_4d_size + moved_4e_size,
      moved_4g_size = moved_4c_size + moved_4f_size, M_54_abs = fabsf(M->at[4][5]),
      moved_4_size = moved_4g_size + M_54_abs;
  const float moved_5a_abs = fabsf(moved_5a), moved_5b_abs = fabsf(moved_5b),
      moved_5c_size = moved_5a_abs + moved_5b_abs, moved_5d_size = KSL_MULF(t_0_abs, G_7_padded),
      moved_5e_size = KSL_MULF(t_1_abs, G_6_padded), moved_5f_size = moved_5d_size + moved_5e_size,
      moved_5g_size = moved_5c_size + moved_5f_size, M_55_abs = fabsf(M->at[5][5]),
      moved_5_size = moved_5g_size + M_55_abs;
  const float G_0_padded = G_0_size + 1.9721523e-31f,
      G_0_error_bound = KSL_MULF(1.7881396e-07f, G_0_padded);
  const float G_3_error_bound = KSL_MULF(1.7881396e-07f, G_3_padded);
  const float G_6_error_bound = KSL_MULF(1.7881396e-07f, G_6_padded);
  const float G_1_error_bound = KSL_MULF(1.7881396e-07f, G_1_padded);
  const float G_4_error_bound = KSL_MULF(1.7881396e-07f, G_4_padded);
  const float G_7_error_bound = KSL_MULF(1.7881396e-07f, G_7_padded);
  const float G_2_error_bound = KSL_MULF(1.7881396e-07f, G_2_padded);
  const float G_5_error_bound = KSL_MULF(1.7881396e-07f, G_5_padded);
  const float G_8_error_bound = KSL_MULF(1.7881396e-07f, G_8_padded);
  const float moved_0_padded = moved_0_size + 1.9721523e-31f,
      moved_0_error_bound = KSL_MULF(4.1723263e-07f, moved_0_padded);
  const float moved_1_padded = moved_1_size + 1.9721523e-31f,
      moved_1_error_bound = KSL_MULF(4.1723263e-07f, moved_1_padded);
  const float moved_3_padded = moved_3_size + 1.9721523e-31f,
      moved_3_error_bound = KSL_MULF(4.1723263e-07f, moved_3_padded);
  const float moved_2_padded = moved_2_size + 1.9721523e-31f,
      moved_2_error_bound = KSL_MULF(4.1723263e-07f, moved_2_padded);
  const float moved_4_padded = moved_4_size + 1.9721523e-31f,
      moved_4_error_bound = KSL_MULF(4.1723263e-07f, moved_4_padded);
  const float moved_5_padded = moved_5_size + 1.9721523e-31f,
      moved_5_error_bound = KSL_MULF(4.1723263e-07f, moved_5_padded);
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
  Mo_bound->at[3][0] = G_0_error_bound;
  Mo_bound->at[4][0] = G_3_error_bound;
  Mo_bound->at[5][0] = G_6_error_bound;
  Mo_bound->at[0][1] = 0.0f;
  Mo_bound->at[1][1] = 0.0f;
  Mo_bound->at[2][1] = 0.0f;
  Mo_bound->at[3][1] = G_1_error_bound;
  Mo_bound->at[4][1] = G_4_error_bound;
  Mo_bound->at[5][1] = G_7_error_bound;
  Mo_bound->at[0][2] = 0.0f;
  Mo_bound->at[1][2] = 0.0f;
  Mo_bound->at[2][2] = 0.0f;
  Mo_bound->at[3][2] = G_2_error_bound;
  Mo_bound->at[4][2] = G_5_error_bound;
  Mo_bound->at[5][2] = G_8_error_bound;
  Mo_bound->at[0][3] = G_0_error_bound;
  Mo_bound->at[1][3] = G_1_error_bound;
  Mo_bound->at[2][3] = G_2_error_bound;
  Mo_bound->at[3][3] = moved_0_error_bound;
  Mo_bound->at[4][3] = moved_1_error_bound;
  Mo_bound->at[5][3] = moved_3_error_bound;
  Mo_bound->at[0][4] = G_3_error_bound;
  Mo_bound->at[1][4] = G_4_error_bound;
  Mo_bound->at[2][4] = G_5_error_bound;
  Mo_bound->at[3][4] = moved_1_error_bound;
  Mo_bound->at[4][4] = moved_2_error_bound;
  Mo_bound->at[5][4] = moved_4_error_bound;
  Mo_bound->at[0][5] = G_6_error_bound;
  Mo_bound->at[1][5] = G_7_error_bound;
  Mo_bound->at[2][5] = G_8_error_bound;
  Mo_bound->at[3][5] = moved_3_error_bound;
  Mo_bound->at[4][5] = moved_4_error_bound;
  Mo_bound->at[5][5] = moved_5_error_bound;
}

#endif
