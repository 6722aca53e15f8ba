/* Made by `coscrew generate`; changes are overwritten. */
/* SPDX-License-Identifier: MIT */
/* coscrew 0.2.0.  Copyright (c) 2026 The coscrew authors. */
/* Inertias of rigid bodies: mass, mass times centre of mass, moments about the centre of mass.
   Accurate tier: double compensated, single computed in double. */
#ifndef KSL_INERTIA_ACCURATE_H
#define KSL_INERTIA_ACCURATE_H

#include "ksl_exact.h"

/* J = (m; m t; Ixx, Iyy, Izz, Ixy, Iyz, Izx): mass, centre of mass t in m, entries of the
     moments' matrix about it in kg m^2, Ixy = -∫ x y dm.
   m, Ixx, Iyy, Izz, Ixy, Iyz, Izx: number; t: vector.
   3 mul, 3 add, 3 product error.
   Error <= u |result|, barring over- and underflow. */
static inline ksl_inertia_t ksl_inertia_accurate(const double m, const ksl_vec3_t t,
    const double Ixx, const double Iyy, const double Izz, const double Ixy,
    const double Iyz, const double Izx) {
  const double J_1 = KSL_MUL(m, t.x), J_2 = KSL_MUL(m, t.y), J_3 = KSL_MUL(m, t.z);
  const double J_1_rounded = J_1 + ksl_product_error(m, t.x, J_1),
      J_2_rounded = J_2 + ksl_product_error(m, t.y, J_2),
      J_3_rounded = J_3 + ksl_product_error(m, t.z, J_3);
  ksl_inertia_t J;
  J.m = m;
  J.mt.x = J_1_rounded;
  J.mt.y = J_2_rounded;
  J.mt.z = J_3_rounded;
  J.Ixx = Ixx;
  J.Iyy = Iyy;
  J.Izz = Izz;
  J.Ixy = Ixy;
  J.Iyz = Iyz;
  J.Izx = Izx;
  return J;
}

/* Jo = Ji rotated by R: m, R mt, R I R^T.
   Ji, Jo: inertia (m in kg; mt = m c in kg m; I about the centre of mass c, xx, yy, zz, xy, yz,
     zx in kg m^2); R: rotation or other 3×3 matrix.
   72 mul, 207 add, 54 product rest.
   Error <= u |result| + (m: 0, mt: 11, I: 37) u^2 S, S the sum of the |terms| of the expanded
     formula; barring over- and underflow. */
static inline void ksl_inertia_rotated_accurate(const ksl_inertia_t *Ji, const ksl_mat3x3_t *R,
    ksl_inertia_t *Jo) {
  const double RI_0a = KSL_MUL(Ji->Ixx, R->m00), RI_0b = KSL_MUL(Ji->Ixy, R->m01),
      RI_0c = RI_0a + RI_0b, RI_0c_right = RI_0c - RI_0a, RI_0d = KSL_MUL(Ji->Izx, R->m02),
      RI_0 = RI_0c + RI_0d, RI_0_right = RI_0 - RI_0c,
      RI_0c_lo = ksl_product_rest(Ji->Ixx, R->m00, RI_0a, RI_0c - RI_0c_right)
          + ksl_product_rest(Ji->Ixy, R->m01, RI_0b, RI_0c_right),
      RI_0_lo = RI_0c - (RI_0 - RI_0_right) + ksl_product_rest(Ji->Izx, R->m02, RI_0d, RI_0_right)
          + RI_0c_lo;
  const double RI_1a = KSL_MUL(Ji->Iyy, R->m01), RI_1b = KSL_MUL(Ji->Ixy, R->m00),
      RI_1c = RI_1a + RI_1b, RI_1c_right = RI_1c - RI_1a, RI_1d = KSL_MUL(Ji->Iyz, R->m02),
      RI_1 = RI_1c + RI_1d, RI_1_right = RI_1 - RI_1c,
      RI_1c_lo = ksl_product_rest(Ji->Iyy, R->m01, RI_1a, RI_1c - RI_1c_right)
          + ksl_product_rest(Ji->Ixy, R->m00, RI_1b, RI_1c_right),
      RI_1_lo = RI_1c - (RI_1 - RI_1_right) + ksl_product_rest(Ji->Iyz, R->m02, RI_1d, RI_1_right)
          + RI_1c_lo;
  const double RI_2a = KSL_MUL(Ji->Izz, R->m02), RI_2b = KSL_MUL(Ji->Iyz, R->m01),
      RI_2c = RI_2a + RI_2b, RI_2c_right = RI_2c - RI_2a, RI_2d = KSL_MUL(Ji->Izx, R->m00),
      RI_2 = RI_2c + RI_2d, RI_2_right = RI_2 - RI_2c,
      RI_2c_lo = ksl_product_rest(Ji->Izz, R->m02, RI_2a, RI_2c - RI_2c_right)
          + ksl_product_rest(Ji->Iyz, R->m01, RI_2b, RI_2c_right),
      RI_2_lo = RI_2c - (RI_2 - RI_2_right) + ksl_product_rest(Ji->Izx, R->m00, RI_2d, RI_2_right)
          + RI_2c_lo;
  const double RI_3a = KSL_MUL(Ji->Ixx, R->m10), RI_3b = KSL_MUL(Ji->Ixy, R->m11),
      RI_3c = RI_3a + RI_3b, RI_3c_right = RI_3c - RI_3a, RI_3d = KSL_MUL(Ji->Izx, R->m12),
      RI_3 = RI_3c + RI_3d, RI_3_right = RI_3 - RI_3c,
      RI_3c_lo = ksl_product_rest(Ji->Ixx, R->m10, RI_3a, RI_3c - RI_3c_right)
          + ksl_product_rest(Ji->Ixy, R->m11, RI_3b, RI_3c_right),
      RI_3_lo = RI_3c - (RI_3 - RI_3_right) + ksl_product_rest(Ji->Izx, R->m12, RI_3d, RI_3_right)
          + RI_3c_lo;
  const double RI_4a = KSL_MUL(Ji->Iyy, R->m11), RI_4b = KSL_MUL(Ji->Ixy, R->m10),
      RI_4c = RI_4a + RI_4b, RI_4c_right = RI_4c - RI_4a, RI_4d = KSL_MUL(Ji->Iyz, R->m12),
      RI_4 = RI_4c + RI_4d, RI_4_right = RI_4 - RI_4c,
      RI_4c_lo = ksl_product_rest(Ji->Iyy, R->m11, RI_4a, RI_4c - RI_4c_right)
          + ksl_product_rest(Ji->Ixy, R->m10, RI_4b, RI_4c_right),
      RI_4_lo = RI_4c - (RI_4 - RI_4_right) + ksl_product_rest(Ji->Iyz, R->m12, RI_4d, RI_4_right)
          + RI_4c_lo;
  const double RI_5a = KSL_MUL(Ji->Izz, R->m12), RI_5b = KSL_MUL(Ji->Iyz, R->m11),
      RI_5c = RI_5a + RI_5b, RI_5c_right = RI_5c - RI_5a, RI_5d = KSL_MUL(Ji->Izx, R->m10),
      RI_5 = RI_5c + RI_5d, RI_5_right = RI_5 - RI_5c,
      RI_5c_lo = ksl_product_rest(Ji->Izz, R->m12, RI_5a, RI_5c - RI_5c_right)
          + ksl_product_rest(Ji->Iyz, R->m11, RI_5b, RI_5c_right),
      RI_5_lo = RI_5c - (RI_5 - RI_5_right) + ksl_product_rest(Ji->Izx, R->m10, RI_5d, RI_5_right)
          + RI_5c_lo;
  const double RI_6a = KSL_MUL(Ji->Ixx, R->m20), RI_6b = KSL_MUL(Ji->Ixy, R->m21),
      RI_6c = RI_6a + RI_6b, RI_6c_right = RI_6c - RI_6a, RI_6d = KSL_MUL(Ji->Izx, R->m22),
      RI_6 = RI_6c + RI_6d, RI_6_right = RI_6 - RI_6c,
      RI_6c_lo = ksl_product_rest(Ji->Ixx, R->m20, RI_6a, RI_6c - RI_6c_right)
          + ksl_product_rest(Ji->Ixy, R->m21, RI_6b, RI_6c_right);
  const double RI_7a = KSL_MUL(Ji->Iyy, R->m21), RI_7b = KSL_MUL(Ji->Ixy, R->m20),
      RI_7c = RI_7a + RI_7b, RI_7c_right = RI_7c - RI_7a, RI_7d = KSL_MUL(Ji->Iyz, R->m22),
      RI_7 = RI_7c + RI_7d, RI_7_right = RI_7 - RI_7c,
      RI_7c_lo = ksl_product_rest(Ji->Iyy, R->m21, RI_7a, RI_7c - RI_7c_right)
          + ksl_product_rest(Ji->Ixy, R->m20, RI_7b, RI_7c_right);
  const double RI_8a = KSL_MUL(Ji->Izz, R->m22), RI_8b = KSL_MUL(Ji->Iyz, R->m21),
      RI_8c = RI_8a + RI_8b, RI_8c_right = RI_8c - RI_8a, RI_8d = KSL_MUL(Ji->Izx, R->m20),
      RI_8 = RI_8c + RI_8d, RI_8_right = RI_8 - RI_8c,
      RI_8c_lo = ksl_product_rest(Ji->Izz, R->m22, RI_8a, RI_8c - RI_8c_right)
          + ksl_product_rest(Ji->Iyz, R->m21, RI_8b, RI_8c_right);
  const double Jo_1a = KSL_MUL(Ji->mt.x, R->m00), Jo_1b = KSL_MUL(Ji->mt.y, R->m01),
      Jo_1c = Jo_1a + Jo_1b, Jo_1c_right = Jo_1c - Jo_1a, Jo_1d = KSL_MUL(Ji->mt.z, R->m02),
      Jo_1 = Jo_1c + Jo_1d, Jo_1_right = Jo_1 - Jo_1c,
      Jo_1c_lo = ksl_product_rest(Ji->mt.x, R->m00, Jo_1a, Jo_1c - Jo_1c_right)
          + ksl_product_rest(Ji->mt.y, R->m01, Jo_1b, Jo_1c_right);
  const double Jo_2a = KSL_MUL(Ji->mt.x, R->m10), Jo_2b = KSL_MUL(Ji->mt.y, R->m11),
      Jo_2c = Jo_2a + Jo_2b, Jo_2c_right = Jo_2c - Jo_2a, Jo_2d = KSL_MUL(Ji->mt.z, R->m12),
      Jo_2 = Jo_2c + Jo_2d, Jo_2_right = Jo_2 - Jo_2c,
      Jo_2c_lo = ksl_product_rest(Ji->mt.x, R->m10, Jo_2a, Jo_2c - Jo_2c_right)
          + ksl_product_rest(Ji->mt.y, R->m11, Jo_2b, Jo_2c_right);
  const double Jo_3a = KSL_MUL(Ji->mt.x, R->m20), Jo_3b = KSL_MUL(Ji->mt.y, R->m21),
      Jo_3c = Jo_3a + Jo_3b, Jo_3c_right = Jo_3c - Jo_3a, Jo_3d = KSL_MUL(Ji->mt.z, R->m22),
      Jo_3 = Jo_3c + Jo_3d, Jo_3_right = Jo_3 - Jo_3c,
      Jo_3c_lo = ksl_product_rest(Ji->mt.x, R->m20, Jo_3a, Jo_3c - Jo_3c_right)
          + ksl_product_rest(Ji->mt.y, R->m21, Jo_3b, Jo_3c_right);
  const double Jo_4a = KSL_MUL(R->m00, RI_0), Jo_4b = KSL_MUL(R->m01, RI_1), Jo_4c = Jo_4a + Jo_4b,
      Jo_4c_right = Jo_4c - Jo_4a,
      Jo_4c_lo1 = ksl_product_rest(R->m00, RI_0, Jo_4a, Jo_4c - Jo_4c_right)
          + ksl_product_rest(R->m01, RI_1, Jo_4b, Jo_4c_right), Jo_4d = KSL_MUL(R->m02, RI_2),
      Jo_4 = Jo_4c + Jo_4d, Jo_4_right = Jo_4 - Jo_4c,
      Jo_4_lo2 = Jo_4c - (Jo_4 - Jo_4_right) + ksl_product_rest(R->m02, RI_2, Jo_4d, Jo_4_right)
          + KSL_MUL(R->m02, RI_2_lo);
  const double Jo_5a = KSL_MUL(R->m10, RI_3), Jo_5b = KSL_MUL(R->m11, RI_4), Jo_5c = Jo_5a + Jo_5b,
      Jo_5c_right = Jo_5c - Jo_5a,
      Jo_5c_lo1 = ksl_product_rest(R->m10, RI_3, Jo_5a, Jo_5c - Jo_5c_right)
          + ksl_product_rest(R->m11, RI_4, Jo_5b, Jo_5c_right), Jo_5d = KSL_MUL(R->m12, RI_5),
      Jo_5 = Jo_5c + Jo_5d, Jo_5_right = Jo_5 - Jo_5c,
      Jo_5_lo2 = Jo_5c - (Jo_5 - Jo_5_right) + ksl_product_rest(R->m12, RI_5, Jo_5d, Jo_5_right)
          + KSL_MUL(R->m12, RI_5_lo);
  const double Jo_6a = KSL_MUL(R->m20, RI_6), Jo_6b = KSL_MUL(R->m21, RI_7), Jo_6c = Jo_6a + Jo_6b,
      Jo_6c_right = Jo_6c - Jo_6a,
      Jo_6a_cross2 = KSL_MUL(R->m20, RI_6c - (RI_6 - RI_6_right)
          + ksl_product_rest(Ji->Izx, R->m22, RI_6d, RI_6_right) + RI_6c_lo),
      Jo_6c_cross = Jo_6a_cross2
          + KSL_MUL(R->m21, RI_7c - (RI_7 - RI_7_right)
          + ksl_product_rest(Ji->Iyz, R->m22, RI_7d, RI_7_right) + RI_7c_lo),
      Jo_6d = KSL_MUL(R->m22, RI_8), Jo_6 = Jo_6c + Jo_6d, Jo_6_right = Jo_6 - Jo_6c,
      Jo_6d_cross2 = KSL_MUL(R->m22, RI_8c - (RI_8 - RI_8_right)
          + ksl_product_rest(Ji->Izx, R->m20, RI_8d, RI_8_right) + RI_8c_lo),
      Jo_6c_lo = ksl_product_rest(R->m20, RI_6, Jo_6a, Jo_6c - Jo_6c_right)
          + ksl_product_rest(R->m21, RI_7, Jo_6b, Jo_6c_right) + Jo_6c_cross;
  const double Jo_7a = KSL_MUL(R->m10, RI_0), Jo_7b = KSL_MUL(R->m11, RI_1), Jo_7c = Jo_7a + Jo_7b,
      Jo_7c_right = Jo_7c - Jo_7a,
      Jo_7c_lo1 = ksl_product_rest(R->m10, RI_0, Jo_7a, Jo_7c - Jo_7c_right)
          + ksl_product_rest(R->m11, RI_1, Jo_7b, Jo_7c_right), Jo_7d = KSL_MUL(R->m12, RI_2),
      Jo_7 = Jo_7c + Jo_7d, Jo_7_right = Jo_7 - Jo_7c,
      Jo_7_lo2 = Jo_7c - (Jo_7 - Jo_7_right) + ksl_product_rest(R->m12, RI_2, Jo_7d, Jo_7_right)
          + KSL_MUL(R->m12, RI_2_lo);
  const double Jo_8a = KSL_MUL(R->m20, RI_3), Jo_8b = KSL_MUL(R->m21, RI_4), Jo_8c = Jo_8a + Jo_8b,
      Jo_8c_right = Jo_8c - Jo_8a,
      Jo_8c_lo1 = ksl_product_rest(R->m20, RI_3, Jo_8a, Jo_8c - Jo_8c_right)
          + ksl_product_rest(R->m21, RI_4, Jo_8b, Jo_8c_right), Jo_8d = KSL_MUL(R->m22, RI_5),
      Jo_8 = Jo_8c + Jo_8d, Jo_8_right = Jo_8 - Jo_8c,
      Jo_8_lo2 = Jo_8c - (Jo_8 - Jo_8_right) + ksl_product_rest(R->m22, RI_5, Jo_8d, Jo_8_right)
          + KSL_MUL(R->m22, RI_5_lo);
  const double Jo_9a = KSL_MUL(R->m20, RI_0), Jo_9b = KSL_MUL(R->m21, RI_1), Jo_9c = Jo_9a + Jo_9b,
      Jo_9c_right = Jo_9c - Jo_9a,
      Jo_9c_lo1 = ksl_product_rest(R->m20, RI_0, Jo_9a, Jo_9c - Jo_9c_right)
          + ksl_product_rest(R->m21, RI_1, Jo_9b, Jo_9c_right), Jo_9d = KSL_MUL(R->m22, RI_2),
      Jo_9 = Jo_9c + Jo_9d, Jo_9_right = Jo_9 - Jo_9c,
      Jo_9_lo2 = Jo_9c - (Jo_9 - Jo_9_right) + ksl_product_rest(R->m22, RI_2, Jo_9d, Jo_9_right)
          + KSL_MUL(R->m22, RI_2_lo);
  const double Jo_1_rounded = Jo_1
          + (Jo_1c - (Jo_1 - Jo_1_right) + ksl_product_rest(Ji->mt.z, R->m02, Jo_1d, Jo_1_right)
          + Jo_1c_lo),
      Jo_2_rounded = Jo_2
          + (Jo_2c - (Jo_2 - Jo_2_right) + ksl_product_rest(Ji->mt.z, R->m12, Jo_2d, Jo_2_right)
          + Jo_2c_lo),
      Jo_3_rounded = Jo_3
          + (Jo_3c - (Jo_3 - Jo_3_right) + ksl_product_rest(Ji->mt.z, R->m22, Jo_3d, Jo_3_right)
          + Jo_3c_lo),
      Jo_4_rounded = Jo_4
          + (Jo_4_lo2 + (Jo_4c_lo1 + (KSL_MUL(R->m00, RI_0_lo) + KSL_MUL(R->m01, RI_1_lo)))),
      Jo_5_rounded = Jo_5
          + (Jo_5_lo2 + (Jo_5c_lo1 + (KSL_MUL(R->m10, RI_3_lo) + KSL_MUL(R->m11, RI_4_lo)))),
      Jo_6_rounded = Jo_6
          + (Jo_6c - (Jo_6 - Jo_6_right) + ksl_product_rest(R->m22, RI_8, Jo_6d, Jo_6_right)
          + Jo_6d_cross2 + Jo_6c_lo),
      Jo_7_rounded = Jo_7
          + (Jo_7_lo2 + (Jo_7c_lo1 + (KSL_MUL(R->m10, RI_0_lo) + KSL_MUL(R->m11, RI_1_lo)))),
      Jo_8_rounded = Jo_8
          + (Jo_8_lo2 + (Jo_8c_lo1 + (KSL_MUL(R->m20, RI_3_lo) + KSL_MUL(R->m21, RI_4_lo)))),
      Jo_9_rounded = Jo_9
          + (Jo_9_lo2 + (Jo_9c_lo1 + (KSL_MUL(R->m20, RI_0_lo) + KSL_MUL(R->m21, RI_1_lo))));
  const double Ji_m = Ji->m;
  Jo->m = Ji_m;
  Jo->mt.x = Jo_1_rounded;
  Jo->mt.y = Jo_2_rounded;
  Jo->mt.z = Jo_3_rounded;
  Jo->Ixx = Jo_4_rounded;
  Jo->Iyy = Jo_5_rounded;
  Jo->Izz = Jo_6_rounded;
  Jo->Ixy = Jo_7_rounded;
  Jo->Iyz = Jo_8_rounded;
  Jo->Izx = Jo_9_rounded;
}

/* self = self rotated by R: m, R mt, R I R^T.
   self: inertia (m in kg; mt = m c in kg m; I about the centre of mass c, xx, yy, zz, xy, yz, zx
     in kg m^2); R: rotation or other 3×3 matrix.
   72 mul, 207 add, 54 product rest.
   Error <= u |result| + (m: 0, mt: 11, I: 37) u^2 S, S the sum of the |terms| of the expanded
     formula; barring over- and underflow. */
static inline void ksl_inertia_rotate_accurate(ksl_inertia_t *self, const ksl_mat3x3_t *R) {
  const double RI_0a = KSL_MUL(self->Ixx, R->m00), RI_0b = KSL_MUL(self->Ixy, R->m01),
      RI_0c = RI_0a + RI_0b, RI_0c_right = RI_0c - RI_0a, RI_0d = KSL_MUL(self->Izx, R->m02),
      RI_0 = RI_0c + RI_0d, RI_0_right = RI_0 - RI_0c,
      RI_0c_lo = ksl_product_rest(self->Ixx, R->m00, RI_0a, RI_0c - RI_0c_right)
          + ksl_product_rest(self->Ixy, R->m01, RI_0b, RI_0c_right),
      RI_0_lo = RI_0c - (RI_0 - RI_0_right)
          + ksl_product_rest(self->Izx, R->m02, RI_0d, RI_0_right) + RI_0c_lo;
  const double RI_1a = KSL_MUL(self->Iyy, R->m01), RI_1b = KSL_MUL(self->Ixy, R->m00),
      RI_1c = RI_1a + RI_1b, RI_1c_right = RI_1c - RI_1a, RI_1d = KSL_MUL(self->Iyz, R->m02),
      RI_1 = RI_1c + RI_1d, RI_1_right = RI_1 - RI_1c,
      RI_1c_lo = ksl_product_rest(self->Iyy, R->m01, RI_1a, RI_1c - RI_1c_right)
          + ksl_product_rest(self->Ixy, R->m00, RI_1b, RI_1c_right),
      RI_1_lo = RI_1c - (RI_1 - RI_1_right)
          + ksl_product_rest(self->Iyz, R->m02, RI_1d, RI_1_right) + RI_1c_lo;
  const double RI_2a = KSL_MUL(self->Izz, R->m02), RI_2b = KSL_MUL(self->Iyz, R->m01),
      RI_2c = RI_2a + RI_2b, RI_2c_right = RI_2c - RI_2a, RI_2d = KSL_MUL(self->Izx, R->m00),
      RI_2 = RI_2c + RI_2d, RI_2_right = RI_2 - RI_2c,
      RI_2c_lo = ksl_product_rest(self->Izz, R->m02, RI_2a, RI_2c - RI_2c_right)
          + ksl_product_rest(self->Iyz, R->m01, RI_2b, RI_2c_right),
      RI_2_lo = RI_2c - (RI_2 - RI_2_right)
          + ksl_product_rest(self->Izx, R->m00, RI_2d, RI_2_right) + RI_2c_lo;
  const double RI_3a = KSL_MUL(self->Ixx, R->m10), RI_3b = KSL_MUL(self->Ixy, R->m11),
      RI_3c = RI_3a + RI_3b, RI_3c_right = RI_3c - RI_3a, RI_3d = KSL_MUL(self->Izx, R->m12),
      RI_3 = RI_3c + RI_3d, RI_3_right = RI_3 - RI_3c,
      RI_3c_lo = ksl_product_rest(self->Ixx, R->m10, RI_3a, RI_3c - RI_3c_right)
          + ksl_product_rest(self->Ixy, R->m11, RI_3b, RI_3c_right),
      RI_3_lo = RI_3c - (RI_3 - RI_3_right)
          + ksl_product_rest(self->Izx, R->m12, RI_3d, RI_3_right) + RI_3c_lo;
  const double RI_4a = KSL_MUL(self->Iyy, R->m11), RI_4b = KSL_MUL(self->Ixy, R->m10),
      RI_4c = RI_4a + RI_4b, RI_4c_right = RI_4c - RI_4a, RI_4d = KSL_MUL(self->Iyz, R->m12),
      RI_4 = RI_4c + RI_4d, RI_4_right = RI_4 - RI_4c,
      RI_4c_lo = ksl_product_rest(self->Iyy, R->m11, RI_4a, RI_4c - RI_4c_right)
          + ksl_product_rest(self->Ixy, R->m10, RI_4b, RI_4c_right),
      RI_4_lo = RI_4c - (RI_4 - RI_4_right)
          + ksl_product_rest(self->Iyz, R->m12, RI_4d, RI_4_right) + RI_4c_lo;
  const double RI_5a = KSL_MUL(self->Izz, R->m12), RI_5b = KSL_MUL(self->Iyz, R->m11),
      RI_5c = RI_5a + RI_5b, RI_5c_right = RI_5c - RI_5a, RI_5d = KSL_MUL(self->Izx, R->m10),
      RI_5 = RI_5c + RI_5d, RI_5_right = RI_5 - RI_5c,
      RI_5c_lo = ksl_product_rest(self->Izz, R->m12, RI_5a, RI_5c - RI_5c_right)
          + ksl_product_rest(self->Iyz, R->m11, RI_5b, RI_5c_right),
      RI_5_lo = RI_5c - (RI_5 - RI_5_right)
          + ksl_product_rest(self->Izx, R->m10, RI_5d, RI_5_right) + RI_5c_lo;
  const double RI_6a = KSL_MUL(self->Ixx, R->m20), RI_6b = KSL_MUL(self->Ixy, R->m21),
      RI_6c = RI_6a + RI_6b, RI_6c_right = RI_6c - RI_6a, RI_6d = KSL_MUL(self->Izx, R->m22),
      RI_6 = RI_6c + RI_6d, RI_6_right = RI_6 - RI_6c,
      RI_6c_lo = ksl_product_rest(self->Ixx, R->m20, RI_6a, RI_6c - RI_6c_right)
          + ksl_product_rest(self->Ixy, R->m21, RI_6b, RI_6c_right);
  const double RI_7a = KSL_MUL(self->Iyy, R->m21), RI_7b = KSL_MUL(self->Ixy, R->m20),
      RI_7c = RI_7a + RI_7b, RI_7c_right = RI_7c - RI_7a, RI_7d = KSL_MUL(self->Iyz, R->m22),
      RI_7 = RI_7c + RI_7d, RI_7_right = RI_7 - RI_7c,
      RI_7c_lo = ksl_product_rest(self->Iyy, R->m21, RI_7a, RI_7c - RI_7c_right)
          + ksl_product_rest(self->Ixy, R->m20, RI_7b, RI_7c_right);
  const double RI_8a = KSL_MUL(self->Izz, R->m22), RI_8b = KSL_MUL(self->Iyz, R->m21),
      RI_8c = RI_8a + RI_8b, RI_8c_right = RI_8c - RI_8a, RI_8d = KSL_MUL(self->Izx, R->m20),
      RI_8 = RI_8c + RI_8d, RI_8_right = RI_8 - RI_8c,
      RI_8c_lo = ksl_product_rest(self->Izz, R->m22, RI_8a, RI_8c - RI_8c_right)
          + ksl_product_rest(self->Iyz, R->m21, RI_8b, RI_8c_right);
  const double self_1_new_a = KSL_MUL(self->mt.x, R->m00),
      self_1_new_b = KSL_MUL(self->mt.y, R->m01), self_1_new_c = self_1_new_a + self_1_new_b,
      self_1_new_c_right = self_1_new_c - self_1_new_a,
      self_1_new_c_left_rest = ksl_product_rest(self->mt.x, R->m00, self_1_new_a, self_1_new_c
          - self_1_new_c_right), self_1_new_d = KSL_MUL(self->mt.z, R->m02),
      self_1_new = self_1_new_c + self_1_new_d, self_1_new_right = self_1_new - self_1_new_c,
      self_1_new_lo1 = self_1_new_c - (self_1_new - self_1_new_right)
          + ksl_product_rest(self->mt.z, R->m02, self_1_new_d, self_1_new_right);
  const double self_2_new_a = KSL_MUL(self->mt.x, R->m10),
      self_2_new_b = KSL_MUL(self->mt.y, R->m11), self_2_new_c = self_2_new_a + self_2_new_b,
      self_2_new_c_right = self_2_new_c - self_2_new_a,
      self_2_new_c_left_rest = ksl_product_rest(self->mt.x, R->m10, self_2_new_a, self_2_new_c
          - self_2_new_c_right), self_2_new_d = KSL_MUL(self->mt.z, R->m12),
      self_2_new = self_2_new_c + self_2_new_d, self_2_new_right = self_2_new - self_2_new_c,
      self_2_new_lo1 = self_2_new_c - (self_2_new - self_2_new_right)
          + ksl_product_rest(self->mt.z, R->m12, self_2_new_d, self_2_new_right);
  const double self_3_new_a = KSL_MUL(self->mt.x, R->m20),
      self_3_new_b = KSL_MUL(self->mt.y, R->m21), self_3_new_c = self_3_new_a + self_3_new_b,
      self_3_new_c_right = self_3_new_c - self_3_new_a,
      self_3_new_c_left_rest = ksl_product_rest(self->mt.x, R->m20, self_3_new_a, self_3_new_c
          - self_3_new_c_right), self_3_new_d = KSL_MUL(self->mt.z, R->m22),
      self_3_new = self_3_new_c + self_3_new_d, self_3_new_right = self_3_new - self_3_new_c,
      self_3_new_lo1 = self_3_new_c - (self_3_new - self_3_new_right)
          + ksl_product_rest(self->mt.z, R->m22, self_3_new_d, self_3_new_right);
  const double self_4_new_a = KSL_MUL(R->m00, RI_0), self_4_new_b = KSL_MUL(R->m01, RI_1),
      self_4_new_c = self_4_new_a + self_4_new_b, self_4_new_c_right = self_4_new_c - self_4_new_a,
      self_4_new_c_left_rest = ksl_product_rest(R->m00, RI_0, self_4_new_a, self_4_new_c
          - self_4_new_c_right),
      self_4_new_c_lo1 = self_4_new_c_left_rest
          + ksl_product_rest(R->m01, RI_1, self_4_new_b, self_4_new_c_right),
      self_4_new_d = KSL_MUL(R->m02, RI_2), self_4_new = self_4_new_c + self_4_new_d,
      self_4_new_right = self_4_new - self_4_new_c,
      self_4_new_lo1 = self_4_new_c - (self_4_new - self_4_new_right)
          + ksl_product_rest(R->m02, RI_2, self_4_new_d, self_4_new_right);
  const double self_5_new_a = KSL_MUL(R->m10, RI_3), self_5_new_b = KSL_MUL(R->m11, RI_4),
      self_5_new_c = self_5_new_a + self_5_new_b, self_5_new_c_right = self_5_new_c - self_5_new_a,
      self_5_new_c_left_rest = ksl_product_rest(R->m10, RI_3, self_5_new_a, self_5_new_c
          - self_5_new_c_right),
      self_5_new_c_lo1 = self_5_new_c_left_rest
          + ksl_product_rest(R->m11, RI_4, self_5_new_b, self_5_new_c_right),
      self_5_new_d = KSL_MUL(R->m12, RI_5), self_5_new = self_5_new_c + self_5_new_d,
      self_5_new_right = self_5_new - self_5_new_c,
      self_5_new_lo1 = self_5_new_c - (self_5_new - self_5_new_right)
          + ksl_product_rest(R->m12, RI_5, self_5_new_d, self_5_new_right);
  const double self_6_new_a = KSL_MUL(R->m20, RI_6), self_6_new_b = KSL_MUL(R->m21, RI_7),
      self_6_new_c = self_6_new_a + self_6_new_b, self_6_new_c_right = self_6_new_c - self_6_new_a,
      self_6_new_a_cross2 = KSL_MUL(R->m20, RI_6c - (RI_6 - RI_6_right)
          + ksl_product_rest(self->Izx, R->m22, RI_6d, RI_6_right) + RI_6c_lo),
      self_6_new_b_cross2 = KSL_MUL(R->m21, RI_7c - (RI_7 - RI_7_right)
          + ksl_product_rest(self->Iyz, R->m22, RI_7d, RI_7_right) + RI_7c_lo),
      self_6_new_c_left_rest = ksl_product_rest(R->m20, RI_6, self_6_new_a, self_6_new_c
          - self_6_new_c_right),
      self_6_new_c_lo1 = self_6_new_c_left_rest
          + ksl_product_rest(R->m21, RI_7, self_6_new_b, self_6_new_c_right),
      self_6_new_d = KSL_MUL(R->m22, RI_8), self_6_new = self_6_new_c + self_6_new_d,
      self_6_new_right = self_6_new - self_6_new_c,
      self_6_new_d_cross2 = KSL_MUL(R->m22, RI_8c - (RI_8 - RI_8_right)
          + ksl_product_rest(self->Izx, R->m20, RI_8d, RI_8_right) + RI_8c_lo),
      self_6_new_lo2 = self_6_new_c - (self_6_new - self_6_new_right)
          + ksl_product_rest(R->m22, RI_8, self_6_new_d, self_6_new_right) + self_6_new_d_cross2;
  const double self_7_new_a = KSL_MUL(R->m10, RI_0), self_7_new_b = KSL_MUL(R->m11, RI_1),
      self_7_new_c = self_7_new_a + self_7_new_b, self_7_new_c_right = self_7_new_c - self_7_new_a,
      self_7_new_c_left_rest = ksl_product_rest(R->m10, RI_0, self_7_new_a, self_7_new_c
          - self_7_new_c_right),
      self_7_new_c_lo1 = self_7_new_c_left_rest
          + ksl_product_rest(R->m11, RI_1, self_7_new_b, self_7_new_c_right),
      self_7_new_d = KSL_MUL(R->m12, RI_2), self_7_new = self_7_new_c + self_7_new_d,
      self_7_new_right = self_7_new - self_7_new_c,
      self_7_new_lo1 = self_7_new_c - (self_7_new - self_7_new_right)
          + ksl_product_rest(R->m12, RI_2, self_7_new_d, self_7_new_right);
  const double self_8_new_a = KSL_MUL(R->m20, RI_3), self_8_new_b = KSL_MUL(R->m21, RI_4),
      self_8_new_c = self_8_new_a + self_8_new_b, self_8_new_c_right = self_8_new_c - self_8_new_a,
      self_8_new_c_left_rest = ksl_product_rest(R->m20, RI_3, self_8_new_a, self_8_new_c
          - self_8_new_c_right),
      self_8_new_c_lo1 = self_8_new_c_left_rest
          + ksl_product_rest(R->m21, RI_4, self_8_new_b, self_8_new_c_right),
      self_8_new_d = KSL_MUL(R->m22, RI_5), self_8_new = self_8_new_c + self_8_new_d,
      self_8_new_right = self_8_new - self_8_new_c,
      self_8_new_lo1 = self_8_new_c - (self_8_new - self_8_new_right)
          + ksl_product_rest(R->m22, RI_5, self_8_new_d, self_8_new_right);
  const double self_9_new_a = KSL_MUL(R->m20, RI_0), self_9_new_b = KSL_MUL(R->m21, RI_1),
      self_9_new_c = self_9_new_a + self_9_new_b, self_9_new_c_right = self_9_new_c - self_9_new_a,
      self_9_new_c_left_rest = ksl_product_rest(R->m20, RI_0, self_9_new_a, self_9_new_c
          - self_9_new_c_right),
      self_9_new_c_lo1 = self_9_new_c_left_rest
          + ksl_product_rest(R->m21, RI_1, self_9_new_b, self_9_new_c_right),
      self_9_new_d = KSL_MUL(R->m22, RI_2), self_9_new = self_9_new_c + self_9_new_d,
      self_9_new_right = self_9_new - self_9_new_c,
      self_9_new_lo1 = self_9_new_c - (self_9_new - self_9_new_right)
          + ksl_product_rest(R->m22, RI_2, self_9_new_d, self_9_new_right);
  const double self_1_new_rounded = self_1_new
          + (self_1_new_lo1
          + (self_1_new_c_left_rest
          + ksl_product_rest(self->mt.y, R->m01, self_1_new_b, self_1_new_c_right))),
      self_2_new_rounded = self_2_new
          + (self_2_new_lo1
          + (self_2_new_c_left_rest
          + ksl_product_rest(self->mt.y, R->m11, self_2_new_b, self_2_new_c_right))),
      self_3_new_rounded = self_3_new
          + (self_3_new_lo1
          + (self_3_new_c_left_rest
          + ksl_product_rest(self->mt.y, R->m21, self_3_new_b, self_3_new_c_right)));
  const double self_4_new_lo = self_4_new_lo1 + KSL_MUL(R->m02, RI_2_lo)
          + (self_4_new_c_lo1 + (KSL_MUL(R->m00, RI_0_lo) + KSL_MUL(R->m01, RI_1_lo)));
  const double self_4_new_rounded = self_4_new + self_4_new_lo;
  const double self_5_new_lo = self_5_new_lo1 + KSL_MUL(R->m12, RI_5_lo)
          + (self_5_new_c_lo1 + (KSL_MUL(R->m10, RI_3_lo) + KSL_MUL(R->m11, RI_4_lo)));
  const double self_5_new_rounded = self_5_new + self_5_new_lo,
      self_6_new_rounded = self_6_new
          + (self_6_new_lo2 + (self_6_new_c_lo1 + (self_6_new_a_cross2 + self_6_new_b_cross2)));
  const double self_7_new_lo = self_7_new_lo1 + KSL_MUL(R->m12, RI_2_lo)
          + (self_7_new_c_lo1 + (KSL_MUL(R->m10, RI_0_lo) + KSL_MUL(R->m11, RI_1_lo)));
  const double self_7_new_rounded = self_7_new + self_7_new_lo;
  const double self_8_new_lo = self_8_new_lo1 + KSL_MUL(R->m22, RI_5_lo)
          + (self_8_new_c_lo1 + (KSL_MUL(R->m20, RI_3_lo) + KSL_MUL(R->m21, RI_4_lo)));
  const double self_8_new_rounded = self_8_new + self_8_new_lo;
  const double self_9_new_lo = self_9_new_lo1 + KSL_MUL(R->m22, RI_2_lo)
          + (self_9_new_c_lo1 + (KSL_MUL(R->m20, RI_0_lo) + KSL_MUL(R->m21, RI_1_lo)));
  const double self_9_new_rounded = self_9_new + self_9_new_lo;
  self->mt.x = self_1_new_rounded;
  self->mt.y = self_2_new_rounded;
  self->mt.z = self_3_new_rounded;
  self->Ixx = self_4_new_rounded;
  self->Iyy = self_5_new_rounded;
  self->Izz = self_6_new_rounded;
  self->Ixy = self_7_new_rounded;
  self->Iyz = self_8_new_rounded;
  self->Izx = self_9_new_rounded;
}

/* Jo = Ji translated by t: m, mt + m t, I.
   Ji, Jo: inertia (m in kg; mt = m c in kg m; I about the centre of mass c, xx, yy, zz, xy, yz,
     zx in kg m^2); t: vector.
   3 mul, 18 add, 3 product rest.
   Error <= u |result| + (m: 0, mt: 3, I: 0) u^2 S, S the sum of the |terms| of the expanded
     formula; barring over- and underflow. */
static inline void ksl_inertia_translated_accurate(const ksl_inertia_t *Ji, const ksl_vec3_t *t,
    ksl_inertia_t *Jo) {
  const double Jo_1a = KSL_MUL(Ji->m, t->x), Jo_1 = Jo_1a + Ji->mt.x, Jo_1_right = Jo_1 - Jo_1a;
  const double Jo_2a = KSL_MUL(Ji->m, t->y), Jo_2 = Jo_2a + Ji->mt.y, Jo_2_right = Jo_2 - Jo_2a;
  const double Jo_3a = KSL_MUL(Ji->m, t->z), Jo_3 = Jo_3a + Ji->mt.z, Jo_3_right = Jo_3 - Jo_3a;
  const double Jo_1_rounded = Jo_1
          + (ksl_product_rest(Ji->m, t->x, Jo_1a, Jo_1 - Jo_1_right) + (Ji->mt.x - Jo_1_right)),
      Jo_2_rounded = Jo_2
          + (ksl_product_rest(Ji->m, t->y, Jo_2a, Jo_2 - Jo_2_right) + (Ji->mt.y - Jo_2_right)),
      Jo_3_rounded = Jo_3
          + (ksl_product_rest(Ji->m, t->z, Jo_3a, Jo_3 - Jo_3_right) + (Ji->mt.z - Jo_3_right));
  const double Ji_m = Ji->m;
  const double Ji_Ixx = Ji->Ixx;
  const double Ji_Iyy = Ji->Iyy;
  const double Ji_Izz = Ji->Izz;
  const double Ji_Ixy = Ji->Ixy;
  const double Ji_Iyz = Ji->Iyz;
  const double Ji_Izx = Ji->Izx;
  Jo->m = Ji_m;
  Jo->mt.x = Jo_1_rounded;
  Jo->mt.y = Jo_2_rounded;
  Jo->mt.z = Jo_3_rounded;
  Jo->Ixx = Ji_Ixx;
  Jo->Iyy = Ji_Iyy;
  Jo->Izz = Ji_Izz;
  Jo->Ixy = Ji_Ixy;
  Jo->Iyz = Ji_Iyz;
  Jo->Izx = Ji_Izx;
}

/* self = self translated by t: m, mt + m t, I.
   self: inertia (m in kg; mt = m c in kg m; I about the centre of mass c, xx, yy, zz, xy, yz, zx
     in kg m^2); t: vector.
   3 mul, 18 add, 3 product rest.
   Error <= u |result| + (m: 0, mt: 3, I: 0) u^2 S, S the sum of the |terms| of the expanded
     formula; barring over- and underflow. */
static inline void ksl_inertia_translate_accurate(ksl_inertia_t *self, const ksl_vec3_t *t) {
  const double self_1_new_a = KSL_MUL(self->m, t->x), self_1_new = self_1_new_a + self->mt.x,
      self_1_new_right = self_1_new - self_1_new_a;
  const double self_2_new_a = KSL_MUL(self->m, t->y), self_2_new = self_2_new_a + self->mt.y,
      self_2_new_right = self_2_new - self_2_new_a;
  const double self_3_new_a = KSL_MUL(self->m, t->z), self_3_new = self_3_new_a + self->mt.z,
      self_3_new_right = self_3_new - self_3_new_a;
  const double self_1_new_rounded = self_1_new
          + (ksl_product_rest(self->m, t->x, self_1_new_a, self_1_new - self_1_new_right)
          + (self->mt.x - self_1_new_right)),
      self_2_new_rounded = self_2_new
          + (ksl_product_rest(self->m, t->y, self_2_new_a, self_2_new - self_2_new_right)
          + (self->mt.y - self_2_new_right)),
      self_3_new_rounded = self_3_new
          + (ksl_product_rest(self->m, t->z, self_3_new_a, self_3_new - self_3_new_right)
          + (self->mt.z - self_3_new_right));
  self->mt.x = self_1_new_rounded;
  self->mt.y = self_2_new_rounded;
  self->mt.z = self_3_new_rounded;
}

/* Jo = Ji displaced by D = [R | t]: m, R mt + m t, R I R^T.
   Ji, Jo: inertia (m in kg; mt = m c in kg m; I about the centre of mass c, xx, yy, zz, xy, yz,
     zx in kg m^2); D: displacement [R | t], R rotation, t in m.
   75 mul, 225 add, 57 product rest.
   Error <= u |result| + (m: 0, mt: 17, I: 37) u^2 S, S the sum of the |terms| of the expanded
     formula; barring over- and underflow. */
static inline void ksl_inertia_transformed_accurate(const ksl_inertia_t *Ji, const ksl_SE3_t *D,
    ksl_inertia_t *Jo) {
  const double RI_0a = KSL_MUL(Ji->Ixx, D->m00), RI_0b = KSL_MUL(Ji->Ixy, D->m01),
      RI_0c = RI_0a + RI_0b, RI_0c_right = RI_0c - RI_0a, RI_0d = KSL_MUL(Ji->Izx, D->m02),
      RI_0 = RI_0c + RI_0d, RI_0_right = RI_0 - RI_0c,
      RI_0c_lo = ksl_product_rest(Ji->Ixx, D->m00, RI_0a, RI_0c - RI_0c_right)
          + ksl_product_rest(Ji->Ixy, D->m01, RI_0b, RI_0c_right),
      RI_0_lo = RI_0c - (RI_0 - RI_0_right) + ksl_product_rest(Ji->Izx, D->m02, RI_0d, RI_0_right)
          + RI_0c_lo;
  const double RI_1a = KSL_MUL(Ji->Iyy, D->m01), RI_1b = KSL_MUL(Ji->Ixy, D->m00),
      RI_1c = RI_1a + RI_1b, RI_1c_right = RI_1c - RI_1a, RI_1d = KSL_MUL(Ji->Iyz, D->m02),
      RI_1 = RI_1c + RI_1d, RI_1_right = RI_1 - RI_1c,
      RI_1c_lo = ksl_product_rest(Ji->Iyy, D->m01, RI_1a, RI_1c - RI_1c_right)
          + ksl_product_rest(Ji->Ixy, D->m00, RI_1b, RI_1c_right),
      RI_1_lo = RI_1c - (RI_1 - RI_1_right) + ksl_product_rest(Ji->Iyz, D->m02, RI_1d, RI_1_right)
          + RI_1c_lo;
  const double RI_2a = KSL_MUL(Ji->Izz, D->m02), RI_2b = KSL_MUL(Ji->Iyz, D->m01),
      RI_2c = RI_2a + RI_2b, RI_2c_right = RI_2c - RI_2a, RI_2d = KSL_MUL(Ji->Izx, D->m00),
      RI_2 = RI_2c + RI_2d, RI_2_right = RI_2 - RI_2c,
      RI_2c_lo = ksl_product_rest(Ji->Izz, D->m02, RI_2a, RI_2c - RI_2c_right)
          + ksl_product_rest(Ji->Iyz, D->m01, RI_2b, RI_2c_right),
      RI_2_lo = RI_2c - (RI_2 - RI_2_right) + ksl_product_rest(Ji->Izx, D->m00, RI_2d, RI_2_right)
          + RI_2c_lo;
  const double RI_3a = KSL_MUL(Ji->Ixx, D->m10), RI_3b = KSL_MUL(Ji->Ixy, D->m11),
      RI_3c = RI_3a + RI_3b, RI_3c_right = RI_3c - RI_3a, RI_3d = KSL_MUL(Ji->Izx, D->m12),
      RI_3 = RI_3c + RI_3d, RI_3_right = RI_3 - RI_3c,
      RI_3c_lo = ksl_product_rest(Ji->Ixx, D->m10, RI_3a, RI_3c - RI_3c_right)
          + ksl_product_rest(Ji->Ixy, D->m11, RI_3b, RI_3c_right),
      RI_3_lo = RI_3c - (RI_3 - RI_3_right) + ksl_product_rest(Ji->Izx, D->m12, RI_3d, RI_3_right)
          + RI_3c_lo;
  const double RI_4a = KSL_MUL(Ji->Iyy, D->m11), RI_4b = KSL_MUL(Ji->Ixy, D->m10),
      RI_4c = RI_4a + RI_4b, RI_4c_right = RI_4c - RI_4a, RI_4d = KSL_MUL(Ji->Iyz, D->m12),
      RI_4 = RI_4c + RI_4d, RI_4_right = RI_4 - RI_4c,
      RI_4c_lo = ksl_product_rest(Ji->Iyy, D->m11, RI_4a, RI_4c - RI_4c_right)
          + ksl_product_rest(Ji->Ixy, D->m10, RI_4b, RI_4c_right),
      RI_4_lo = RI_4c - (RI_4 - RI_4_right) + ksl_product_rest(Ji->Iyz, D->m12, RI_4d, RI_4_right)
          + RI_4c_lo;
  const double RI_5a = KSL_MUL(Ji->Izz, D->m12), RI_5b = KSL_MUL(Ji->Iyz, D->m11),
      RI_5c = RI_5a + RI_5b, RI_5c_right = RI_5c - RI_5a, RI_5d = KSL_MUL(Ji->Izx, D->m10),
      RI_5 = RI_5c + RI_5d, RI_5_right = RI_5 - RI_5c,
      RI_5c_lo = ksl_product_rest(Ji->Izz, D->m12, RI_5a, RI_5c - RI_5c_right)
          + ksl_product_rest(Ji->Iyz, D->m11, RI_5b, RI_5c_right),
      RI_5_lo = RI_5c - (RI_5 - RI_5_right) + ksl_product_rest(Ji->Izx, D->m10, RI_5d, RI_5_right)
          + RI_5c_lo;
  const double RI_6a = KSL_MUL(Ji->Ixx, D->m20), RI_6b = KSL_MUL(Ji->Ixy, D->m21),
      RI_6c = RI_6a + RI_6b, RI_6c_right = RI_6c - RI_6a, RI_6d = KSL_MUL(Ji->Izx, D->m22),
      RI_6 = RI_6c + RI_6d, RI_6_right = RI_6 - RI_6c,
      RI_6c_lo = ksl_product_rest(Ji->Ixx, D->m20, RI_6a, RI_6c - RI_6c_right)
          + ksl_product_rest(Ji->Ixy, D->m21, RI_6b, RI_6c_right);
  const double RI_7a = KSL_MUL(Ji->Iyy, D->m21), RI_7b = KSL_MUL(Ji->Ixy, D->m20),
      RI_7c = RI_7a + RI_7b, RI_7c_right = RI_7c - RI_7a, RI_7d = KSL_MUL(Ji->Iyz, D->m22),
      RI_7 = RI_7c + RI_7d, RI_7_right = RI_7 - RI_7c,
      RI_7c_lo = ksl_product_rest(Ji->Iyy, D->m21, RI_7a, RI_7c - RI_7c_right)
          + ksl_product_rest(Ji->Ixy, D->m20, RI_7b, RI_7c_right);
  const double RI_8a = KSL_MUL(Ji->Izz, D->m22), RI_8b = KSL_MUL(Ji->Iyz, D->m21),
      RI_8c = RI_8a + RI_8b, RI_8c_right = RI_8c - RI_8a, RI_8d = KSL_MUL(Ji->Izx, D->m20),
      RI_8 = RI_8c + RI_8d, RI_8_right = RI_8 - RI_8c,
      RI_8c_lo = ksl_product_rest(Ji->Izz, D->m22, RI_8a, RI_8c - RI_8c_right)
          + ksl_product_rest(Ji->Iyz, D->m21, RI_8b, RI_8c_right);
  const double Jo_1a = KSL_MUL(Ji->m, D->m03), Jo_1b = KSL_MUL(Ji->mt.x, D->m00),
      Jo_1c = KSL_MUL(Ji->mt.y, D->m01), Jo_1d = Jo_1b + Jo_1c, Jo_1d_right = Jo_1d - Jo_1b,
      Jo_1e = KSL_MUL(Ji->mt.z, D->m02), Jo_1f = Jo_1d + Jo_1e, Jo_1f_right = Jo_1f - Jo_1d,
      Jo_1d_lo = ksl_product_rest(Ji->mt.x, D->m00, Jo_1b, Jo_1d - Jo_1d_right)
          + ksl_product_rest(Ji->mt.y, D->m01, Jo_1c, Jo_1d_right), Jo_1 = Jo_1a + Jo_1f,
      Jo_1_right = Jo_1 - Jo_1a,
      Jo_1f_lo = Jo_1d - (Jo_1f - Jo_1f_right)
          + ksl_product_rest(Ji->mt.z, D->m02, Jo_1e, Jo_1f_right) + Jo_1d_lo;
  const double Jo_2a = KSL_MUL(Ji->m, D->m13), Jo_2b = KSL_MUL(Ji->mt.x, D->m10),
      Jo_2c = KSL_MUL(Ji->mt.y, D->m11), Jo_2d = Jo_2b + Jo_2c, Jo_2d_right = Jo_2d - Jo_2b,
      Jo_2e = KSL_MUL(Ji->mt.z, D->m12), Jo_2f = Jo_2d + Jo_2e, Jo_2f_right = Jo_2f - Jo_2d,
      Jo_2d_lo = ksl_product_rest(Ji->mt.x, D->m10, Jo_2b, Jo_2d - Jo_2d_right)
          + ksl_product_rest(Ji->mt.y, D->m11, Jo_2c, Jo_2d_right), Jo_2 = Jo_2a + Jo_2f,
      Jo_2_right = Jo_2 - Jo_2a,
      Jo_2f_lo = Jo_2d - (Jo_2f - Jo_2f_right)
          + ksl_product_rest(Ji->mt.z, D->m12, Jo_2e, Jo_2f_right) + Jo_2d_lo;
  const double Jo_3a = KSL_MUL(Ji->m, D->m23), Jo_3b = KSL_MUL(Ji->mt.x, D->m20),
      Jo_3c = KSL_MUL(Ji->mt.y, D->m21), Jo_3d = Jo_3b + Jo_3c, Jo_3d_right = Jo_3d - Jo_3b,
      Jo_3e = KSL_MUL(Ji->mt.z, D->m22), Jo_3f = Jo_3d + Jo_3e, Jo_3f_right = Jo_3f - Jo_3d,
      Jo_3d_lo = ksl_product_rest(Ji->mt.x, D->m20, Jo_3b, Jo_3d - Jo_3d_right)
          + ksl_product_rest(Ji->mt.y, D->m21, Jo_3c, Jo_3d_right), Jo_3 = Jo_3a + Jo_3f,
      Jo_3_right = Jo_3 - Jo_3a,
      Jo_3f_lo = Jo_3d - (Jo_3f - Jo_3f_right)
          + ksl_product_rest(Ji->mt.z, D->m22, Jo_3e, Jo_3f_right) + Jo_3d_lo;
  const double Jo_4a = KSL_MUL(D->m00, RI_0), Jo_4b = KSL_MUL(D->m01, RI_1), Jo_4c = Jo_4a + Jo_4b,
      Jo_4c_right = Jo_4c - Jo_4a,
      Jo_4c_lo1 = ksl_product_rest(D->m00, RI_0, Jo_4a, Jo_4c - Jo_4c_right)
          + ksl_product_rest(D->m01, RI_1, Jo_4b, Jo_4c_right), Jo_4d = KSL_MUL(D->m02, RI_2),
      Jo_4 = Jo_4c + Jo_4d, Jo_4_right = Jo_4 - Jo_4c,
      Jo_4_lo2 = Jo_4c - (Jo_4 - Jo_4_right) + ksl_product_rest(D->m02, RI_2, Jo_4d, Jo_4_right)
          + KSL_MUL(D->m02, RI_2_lo);
  const double Jo_5a = KSL_MUL(D->m10, RI_3), Jo_5b = KSL_MUL(D->m11, RI_4), Jo_5c = Jo_5a + Jo_5b,
      Jo_5c_right = Jo_5c - Jo_5a,
      Jo_5c_lo1 = ksl_product_rest(D->m10, RI_3, Jo_5a, Jo_5c - Jo_5c_right)
          + ksl_product_rest(D->m11, RI_4, Jo_5b, Jo_5c_right), Jo_5d = KSL_MUL(D->m12, RI_5),
      Jo_5 = Jo_5c + Jo_5d, Jo_5_right = Jo_5 - Jo_5c,
      Jo_5_lo2 = Jo_5c - (Jo_5 - Jo_5_right) + ksl_product_rest(D->m12, RI_5, Jo_5d, Jo_5_right)
          + KSL_MUL(D->m12, RI_5_lo);
  const double Jo_6a = KSL_MUL(D->m20, RI_6), Jo_6b = KSL_MUL(D->m21, RI_7), Jo_6c = Jo_6a + Jo_6b,
      Jo_6c_right = Jo_6c - Jo_6a,
      Jo_6a_cross2 = KSL_MUL(D->m20, RI_6c - (RI_6 - RI_6_right)
          + ksl_product_rest(Ji->Izx, D->m22, RI_6d, RI_6_right) + RI_6c_lo),
      Jo_6c_cross = Jo_6a_cross2
          + KSL_MUL(D->m21, RI_7c - (RI_7 - RI_7_right)
          + ksl_product_rest(Ji->Iyz, D->m22, RI_7d, RI_7_right) + RI_7c_lo),
      Jo_6d = KSL_MUL(D->m22, RI_8), Jo_6 = Jo_6c + Jo_6d, Jo_6_right = Jo_6 - Jo_6c,
      Jo_6d_cross2 = KSL_MUL(D->m22, RI_8c - (RI_8 - RI_8_right)
          + ksl_product_rest(Ji->Izx, D->m20, RI_8d, RI_8_right) + RI_8c_lo),
      Jo_6c_lo = ksl_product_rest(D->m20, RI_6, Jo_6a, Jo_6c - Jo_6c_right)
          + ksl_product_rest(D->m21, RI_7, Jo_6b, Jo_6c_right) + Jo_6c_cross;
  const double Jo_7a = KSL_MUL(D->m10, RI_0), Jo_7b = KSL_MUL(D->m11, RI_1), Jo_7c = Jo_7a + Jo_7b,
      Jo_7c_right = Jo_7c - Jo_7a,
      Jo_7c_lo1 = ksl_product_rest(D->m10, RI_0, Jo_7a, Jo_7c - Jo_7c_right)
          + ksl_product_rest(D->m11, RI_1, Jo_7b, Jo_7c_right), Jo_7d = KSL_MUL(D->m12, RI_2),
      Jo_7 = Jo_7c + Jo_7d, Jo_7_right = Jo_7 - Jo_7c,
      Jo_7_lo2 = Jo_7c - (Jo_7 - Jo_7_right) + ksl_product_rest(D->m12, RI_2, Jo_7d, Jo_7_right)
          + KSL_MUL(D->m12, RI_2_lo);
  const double Jo_8a = KSL_MUL(D->m20, RI_3), Jo_8b = KSL_MUL(D->m21, RI_4), Jo_8c = Jo_8a + Jo_8b,
      Jo_8c_right = Jo_8c - Jo_8a,
      Jo_8c_lo1 = ksl_product_rest(D->m20, RI_3, Jo_8a, Jo_8c - Jo_8c_right)
          + ksl_product_rest(D->m21, RI_4, Jo_8b, Jo_8c_right), Jo_8d = KSL_MUL(D->m22, RI_5),
      Jo_8 = Jo_8c + Jo_8d, Jo_8_right = Jo_8 - Jo_8c,
      Jo_8_lo2 = Jo_8c - (Jo_8 - Jo_8_right) + ksl_product_rest(D->m22, RI_5, Jo_8d, Jo_8_right)
          + KSL_MUL(D->m22, RI_5_lo);
  const double Jo_9a = KSL_MUL(D->m20, RI_0), Jo_9b = KSL_MUL(D->m21, RI_1), Jo_9c = Jo_9a + Jo_9b,
      Jo_9c_right = Jo_9c - Jo_9a,
      Jo_9c_lo1 = ksl_product_rest(D->m20, RI_0, Jo_9a, Jo_9c - Jo_9c_right)
          + ksl_product_rest(D->m21, RI_1, Jo_9b, Jo_9c_right), Jo_9d = KSL_MUL(D->m22, RI_2),
      Jo_9 = Jo_9c + Jo_9d, Jo_9_right = Jo_9 - Jo_9c,
      Jo_9_lo2 = Jo_9c - (Jo_9 - Jo_9_right) + ksl_product_rest(D->m22, RI_2, Jo_9d, Jo_9_right)
          + KSL_MUL(D->m22, RI_2_lo);
  const double Jo_1_rounded = Jo_1
          + (ksl_product_rest(Ji->m, D->m03, Jo_1a, Jo_1 - Jo_1_right) + (Jo_1f - Jo_1_right)
          + Jo_1f_lo),
      Jo_2_rounded = Jo_2
          + (ksl_product_rest(Ji->m, D->m13, Jo_2a, Jo_2 - Jo_2_right) + (Jo_2f - Jo_2_right)
          + Jo_2f_lo),
      Jo_3_rounded = Jo_3
          + (ksl_product_rest(Ji->m, D->m23, Jo_3a, Jo_3 - Jo_3_right) + (Jo_3f - Jo_3_right)
          + Jo_3f_lo),
      Jo_4_rounded = Jo_4
          + (Jo_4_lo2 + (Jo_4c_lo1 + (KSL_MUL(D->m00, RI_0_lo) + KSL_MUL(D->m01, RI_1_lo)))),
      Jo_5_rounded = Jo_5
          + (Jo_5_lo2 + (Jo_5c_lo1 + (KSL_MUL(D->m10, RI_3_lo) + KSL_MUL(D->m11, RI_4_lo)))),
      Jo_6_rounded = Jo_6
          + (Jo_6c - (Jo_6 - Jo_6_right) + ksl_product_rest(D->m22, RI_8, Jo_6d, Jo_6_right)
          + Jo_6d_cross2 + Jo_6c_lo),
      Jo_7_rounded = Jo_7
          + (Jo_7_lo2 + (Jo_7c_lo1 + (KSL_MUL(D->m10, RI_0_lo) + KSL_MUL(D->m11, RI_1_lo)))),
      Jo_8_rounded = Jo_8
          + (Jo_8_lo2 + (Jo_8c_lo1 + (KSL_MUL(D->m20, RI_3_lo) + KSL_MUL(D->m21, RI_4_lo)))),
      Jo_9_rounded = Jo_9
          + (Jo_9_lo2 + (Jo_9c_lo1 + (KSL_MUL(D->m20, RI_0_lo) + KSL_MUL(D->m21, RI_1_lo))));
  const double Ji_m = Ji->m;
  Jo->m = Ji_m;
  Jo->mt.x = Jo_1_rounded;
  Jo->mt.y = Jo_2_rounded;
  Jo->mt.z = Jo_3_rounded;
  Jo->Ixx = Jo_4_rounded;
  Jo->Iyy = Jo_5_rounded;
  Jo->Izz = Jo_6_rounded;
  Jo->Ixy = Jo_7_rounded;
  Jo->Iyz = Jo_8_rounded;
  Jo->Izx = Jo_9_rounded;
}

/* self = self displaced by D = [R | t]: m, R mt + m t, R I R^T.
   self: inertia (m in kg; mt = m c in kg m; I about the centre of mass c, xx, yy, zz, xy, yz, zx
     in kg m^2); D: displacement [R | t], R rotation, t in m.
   75 mul, 225 add, 57 product rest.
   Error <= u |result| + (m: 0, mt: 17, I: 37) u^2 S, S the sum of the |terms| of the expanded
     formula; barring over- and underflow. */
static inline void ksl_inertia_transform_accurate(ksl_inertia_t *self, const ksl_SE3_t *D) {
  const double RI_0a = KSL_MUL(self->Ixx, D->m00), RI_0b = KSL_MUL(self->Ixy, D->m01),
      RI_0c = RI_0a + RI_0b, RI_0c_right = RI_0c - RI_0a, RI_0d = KSL_MUL(self->Izx, D->m02),
      RI_0 = RI_0c + RI_0d, RI_0_right = RI_0 - RI_0c,
      RI_0c_lo = ksl_product_rest(self->Ixx, D->m00, RI_0a, RI_0c - RI_0c_right)
          + ksl_product_rest(self->Ixy, D->m01, RI_0b, RI_0c_right),
      RI_0_lo = RI_0c - (RI_0 - RI_0_right)
          + ksl_product_rest(self->Izx, D->m02, RI_0d, RI_0_right) + RI_0c_lo;
  const double RI_1a = KSL_MUL(self->Iyy, D->m01), RI_1b = KSL_MUL(self->Ixy, D->m00),
      RI_1c = RI_1a + RI_1b, RI_1c_right = RI_1c - RI_1a, RI_1d = KSL_MUL(self->Iyz, D->m02),
      RI_1 = RI_1c + RI_1d, RI_1_right = RI_1 - RI_1c,
      RI_1c_lo = ksl_product_rest(self->Iyy, D->m01, RI_1a, RI_1c - RI_1c_right)
          + ksl_product_rest(self->Ixy, D->m00, RI_1b, RI_1c_right),
      RI_1_lo = RI_1c - (RI_1 - RI_1_right)
          + ksl_product_rest(self->Iyz, D->m02, RI_1d, RI_1_right) + RI_1c_lo;
  const double RI_2a = KSL_MUL(self->Izz, D->m02), RI_2b = KSL_MUL(self->Iyz, D->m01),
      RI_2c = RI_2a + RI_2b, RI_2c_right = RI_2c - RI_2a, RI_2d = KSL_MUL(self->Izx, D->m00),
      RI_2 = RI_2c + RI_2d, RI_2_right = RI_2 - RI_2c,
      RI_2c_lo = ksl_product_rest(self->Izz, D->m02, RI_2a, RI_2c - RI_2c_right)
          + ksl_product_rest(self->Iyz, D->m01, RI_2b, RI_2c_right),
      RI_2_lo = RI_2c - (RI_2 - RI_2_right)
          + ksl_product_rest(self->Izx, D->m00, RI_2d, RI_2_right) + RI_2c_lo;
  const double RI_3a = KSL_MUL(self->Ixx, D->m10), RI_3b = KSL_MUL(self->Ixy, D->m11),
      RI_3c = RI_3a + RI_3b, RI_3c_right = RI_3c - RI_3a, RI_3d = KSL_MUL(self->Izx, D->m12),
      RI_3 = RI_3c + RI_3d, RI_3_right = RI_3 - RI_3c,
      RI_3c_lo = ksl_product_rest(self->Ixx, D->m10, RI_3a, RI_3c - RI_3c_right)
          + ksl_product_rest(self->Ixy, D->m11, RI_3b, RI_3c_right),
      RI_3_lo = RI_3c - (RI_3 - RI_3_right)
          + ksl_product_rest(self->Izx, D->m12, RI_3d, RI_3_right) + RI_3c_lo;
  const double RI_4a = KSL_MUL(self->Iyy, D->m11), RI_4b = KSL_MUL(self->Ixy, D->m10),
      RI_4c = RI_4a + RI_4b, RI_4c_right = RI_4c - RI_4a, RI_4d = KSL_MUL(self->Iyz, D->m12),
      RI_4 = RI_4c + RI_4d, RI_4_right = RI_4 - RI_4c,
      RI_4c_lo = ksl_product_rest(self->Iyy, D->m11, RI_4a, RI_4c - RI_4c_right)
          + ksl_product_rest(self->Ixy, D->m10, RI_4b, RI_4c_right),
      RI_4_lo = RI_4c - (RI_4 - RI_4_right)
          + ksl_product_rest(self->Iyz, D->m12, RI_4d, RI_4_right) + RI_4c_lo;
  const double RI_5a = KSL_MUL(self->Izz, D->m12), RI_5b = KSL_MUL(self->Iyz, D->m11),
      RI_5c = RI_5a + RI_5b, RI_5c_right = RI_5c - RI_5a, RI_5d = KSL_MUL(self->Izx, D->m10),
      RI_5 = RI_5c + RI_5d, RI_5_right = RI_5 - RI_5c,
      RI_5c_lo = ksl_product_rest(self->Izz, D->m12, RI_5a, RI_5c - RI_5c_right)
          + ksl_product_rest(self->Iyz, D->m11, RI_5b, RI_5c_right),
      RI_5_lo = RI_5c - (RI_5 - RI_5_right)
          + ksl_product_rest(self->Izx, D->m10, RI_5d, RI_5_right) + RI_5c_lo;
  const double RI_6a = KSL_MUL(self->Ixx, D->m20), RI_6b = KSL_MUL(self->Ixy, D->m21),
      RI_6c = RI_6a + RI_6b, RI_6c_right = RI_6c - RI_6a, RI_6d = KSL_MUL(self->Izx, D->m22),
      RI_6 = RI_6c + RI_6d, RI_6_right = RI_6 - RI_6c,
      RI_6c_lo = ksl_product_rest(self->Ixx, D->m20, RI_6a, RI_6c - RI_6c_right)
          + ksl_product_rest(self->Ixy, D->m21, RI_6b, RI_6c_right);
  const double RI_7a = KSL_MUL(self->Iyy, D->m21), RI_7b = KSL_MUL(self->Ixy, D->m20),
      RI_7c = RI_7a + RI_7b, RI_7c_right = RI_7c - RI_7a, RI_7d = KSL_MUL(self->Iyz, D->m22),
      RI_7 = RI_7c + RI_7d, RI_7_right = RI_7 - RI_7c,
      RI_7c_lo = ksl_product_rest(self->Iyy, D->m21, RI_7a, RI_7c - RI_7c_right)
          + ksl_product_rest(self->Ixy, D->m20, RI_7b, RI_7c_right);
  const double RI_8a = KSL_MUL(self->Izz, D->m22), RI_8b = KSL_MUL(self->Iyz, D->m21),
      RI_8c = RI_8a + RI_8b, RI_8c_right = RI_8c - RI_8a, RI_8d = KSL_MUL(self->Izx, D->m20),
      RI_8 = RI_8c + RI_8d, RI_8_right = RI_8 - RI_8c,
      RI_8c_lo = ksl_product_rest(self->Izz, D->m22, RI_8a, RI_8c - RI_8c_right)
          + ksl_product_rest(self->Iyz, D->m21, RI_8b, RI_8c_right);
  const double self_1_new_a = KSL_MUL(self->m, D->m03), self_1_new_b = KSL_MUL(self->mt.x, D->m00),
      self_1_new_c = KSL_MUL(self->mt.y, D->m01), self_1_new_d = self_1_new_b + self_1_new_c,
      self_1_new_d_right = self_1_new_d - self_1_new_b,
      self_1_new_d_left_rest = ksl_product_rest(self->mt.x, D->m00, self_1_new_b, self_1_new_d
          - self_1_new_d_right), self_1_new_e = KSL_MUL(self->mt.z, D->m02),
      self_1_new_f = self_1_new_d + self_1_new_e, self_1_new_f_right = self_1_new_f - self_1_new_d,
      self_1_new_f_lo1 = self_1_new_d - (self_1_new_f - self_1_new_f_right)
          + ksl_product_rest(self->mt.z, D->m02, self_1_new_e, self_1_new_f_right),
      self_1_new = self_1_new_a + self_1_new_f, self_1_new_right = self_1_new - self_1_new_a,
      self_1_new_f_lo = self_1_new_f_lo1
          + (self_1_new_d_left_rest
          + ksl_product_rest(self->mt.y, D->m01, self_1_new_c, self_1_new_d_right));
  const double self_2_new_a = KSL_MUL(self->m, D->m13), self_2_new_b = KSL_MUL(self->mt.x, D->m10),
      self_2_new_c = KSL_MUL(self->mt.y, D->m11), self_2_new_d = self_2_new_b + self_2_new_c,
      self_2_new_d_right = self_2_new_d - self_2_new_b,
      self_2_new_d_left_rest = ksl_product_rest(self->mt.x, D->m10, self_2_new_b, self_2_new_d
          - self_2_new_d_right), self_2_new_e = KSL_MUL(self->mt.z, D->m12),
      self_2_new_f = self_2_new_d + self_2_new_e, self_2_new_f_right = self_2_new_f - self_2_new_d,
      self_2_new_f_lo1 = self_2_new_d - (self_2_new_f - self_2_new_f_right)
          + ksl_product_rest(self->mt.z, D->m12, self_2_new_e, self_2_new_f_right),
      self_2_new = self_2_new_a + self_2_new_f, self_2_new_right = self_2_new - self_2_new_a,
      self_2_new_f_lo = self_2_new_f_lo1
          + (self_2_new_d_left_rest
          + ksl_product_rest(self->mt.y, D->m11, self_2_new_c, self_2_new_d_right));
  const double self_3_new_a = KSL_MUL(self->m, D->m23), self_3_new_b = KSL_MUL(self->mt.x, D->m20),
      self_3_new_c = KSL_MUL(self->mt.y, D->m21), self_3_new_d = self_3_new_b + self_3_new_c,
      self_3_new_d_right = self_3_new_d - self_3_new_b,
      self_3_new_d_left_rest = ksl_product_rest(self->mt.x, D->m20, self_3_new_b, self_3_new_d
          - self_3_new_d_right), self_3_new_e = KSL_MUL(self->mt.z, D->m22),
      self_3_new_f = self_3_new_d + self_3_new_e, self_3_new_f_right = self_3_new_f - self_3_new_d,
      self_3_new_f_lo1 = self_3_new_d - (self_3_new_f - self_3_new_f_right)
          + ksl_product_rest(self->mt.z, D->m22, self_3_new_e, self_3_new_f_right),
      self_3_new = self_3_new_a + self_3_new_f, self_3_new_right = self_3_new - self_3_new_a,
      self_3_new_f_lo = self_3_new_f_lo1
          + (self_3_new_d_left_rest
          + ksl_product_rest(self->mt.y, D->m21, self_3_new_c, self_3_new_d_right));
  const double self_4_new_a = KSL_MUL(D->m00, RI_0), self_4_new_b = KSL_MUL(D->m01, RI_1),
      self_4_new_c = self_4_new_a + self_4_new_b, self_4_new_c_right = self_4_new_c - self_4_new_a,
      self_4_new_c_left_rest = ksl_product_rest(D->m00, RI_0, self_4_new_a, self_4_new_c
          - self_4_new_c_right),
      self_4_new_c_lo1 = self_4_new_c_left_rest
          + ksl_product_rest(D->m01, RI_1, self_4_new_b, self_4_new_c_right),
      self_4_new_d = KSL_MUL(D->m02, RI_2), self_4_new = self_4_new_c + self_4_new_d,
      self_4_new_right = self_4_new - self_4_new_c,
      self_4_new_lo1 = self_4_new_c - (self_4_new - self_4_new_right)
          + ksl_product_rest(D->m02, RI_2, self_4_new_d, self_4_new_right);
  const double self_5_new_a = KSL_MUL(D->m10, RI_3), self_5_new_b = KSL_MUL(D->m11, RI_4),
      self_5_new_c = self_5_new_a + self_5_new_b, self_5_new_c_right = self_5_new_c - self_5_new_a,
      self_5_new_c_left_rest = ksl_product_rest(D->m10, RI_3, self_5_new_a, self_5_new_c
          - self_5_new_c_right),
      self_5_new_c_lo1 = self_5_new_c_left_rest
          + ksl_product_rest(D->m11, RI_4, self_5_new_b, self_5_new_c_right),
      self_5_new_d = KSL_MUL(D->m12, RI_5), self_5_new = self_5_new_c + self_5_new_d,
      self_5_new_right = self_5_new - self_5_new_c,
      self_5_new_lo1 = self_5_new_c - (self_5_new - self_5_new_right)
          + ksl_product_rest(D->m12, RI_5, self_5_new_d, self_5_new_right);
  const double self_6_new_a = KSL_MUL(D->m20, RI_6), self_6_new_b = KSL_MUL(D->m21, RI_7),
      self_6_new_c = self_6_new_a + self_6_new_b, self_6_new_c_right = self_6_new_c - self_6_new_a,
      self_6_new_a_cross2 = KSL_MUL(D->m20, RI_6c - (RI_6 - RI_6_right)
          + ksl_product_rest(self->Izx, D->m22, RI_6d, RI_6_right) + RI_6c_lo),
      self_6_new_b_cross2 = KSL_MUL(D->m21, RI_7c - (RI_7 - RI_7_right)
          + ksl_product_rest(self->Iyz, D->m22, RI_7d, RI_7_right) + RI_7c_lo),
      self_6_new_c_left_rest = ksl_product_rest(D->m20, RI_6, self_6_new_a, self_6_new_c
          - self_6_new_c_right),
      self_6_new_c_lo1 = self_6_new_c_left_rest
          + ksl_product_rest(D->m21, RI_7, self_6_new_b, self_6_new_c_right),
      self_6_new_d = KSL_MUL(D->m22, RI_8), self_6_new = self_6_new_c + self_6_new_d,
      self_6_new_right = self_6_new - self_6_new_c,
      self_6_new_d_cross2 = KSL_MUL(D->m22, RI_8c - (RI_8 - RI_8_right)
          + ksl_product_rest(self->Izx, D->m20, RI_8d, RI_8_right) + RI_8c_lo),
      self_6_new_lo2 = self_6_new_c - (self_6_new - self_6_new_right)
          + ksl_product_rest(D->m22, RI_8, self_6_new_d, self_6_new_right) + self_6_new_d_cross2;
  const double self_7_new_a = KSL_MUL(D->m10, RI_0), self_7_new_b = KSL_MUL(D->m11, RI_1),
      self_7_new_c = self_7_new_a + self_7_new_b, self_7_new_c_right = self_7_new_c - self_7_new_a,
      self_7_new_c_left_rest = ksl_product_rest(D->m10, RI_0, self_7_new_a, self_7_new_c
          - self_7_new_c_right),
      self_7_new_c_lo1 = self_7_new_c_left_rest
          + ksl_product_rest(D->m11, RI_1, self_7_new_b, self_7_new_c_right),
      self_7_new_d = KSL_MUL(D->m12, RI_2), self_7_new = self_7_new_c + self_7_new_d,
      self_7_new_right = self_7_new - self_7_new_c,
      self_7_new_lo1 = self_7_new_c - (self_7_new - self_7_new_right)
          + ksl_product_rest(D->m12, RI_2, self_7_new_d, self_7_new_right);
  const double self_8_new_a = KSL_MUL(D->m20, RI_3), self_8_new_b = KSL_MUL(D->m21, RI_4),
      self_8_new_c = self_8_new_a + self_8_new_b, self_8_new_c_right = self_8_new_c - self_8_new_a,
      self_8_new_c_left_rest = ksl_product_rest(D->m20, RI_3, self_8_new_a, self_8_new_c
          - self_8_new_c_right),
      self_8_new_c_lo1 = self_8_new_c_left_rest
          + ksl_product_rest(D->m21, RI_4, self_8_new_b, self_8_new_c_right),
      self_8_new_d = KSL_MUL(D->m22, RI_5), self_8_new = self_8_new_c + self_8_new_d,
      self_8_new_right = self_8_new - self_8_new_c,
      self_8_new_lo1 = self_8_new_c - (self_8_new - self_8_new_right)
          + ksl_product_rest(D->m22, RI_5, self_8_new_d, self_8_new_right);
  const double self_9_new_a = KSL_MUL(D->m20, RI_0), self_9_new_b = KSL_MUL(D->m21, RI_1),
      self_9_new_c = self_9_new_a + self_9_new_b, self_9_new_c_right = self_9_new_c - self_9_new_a,
      self_9_new_c_left_rest = ksl_product_rest(D->m20, RI_0, self_9_new_a, self_9_new_c
          - self_9_new_c_right),
      self_9_new_c_lo1 = self_9_new_c_left_rest
          + ksl_product_rest(D->m21, RI_1, self_9_new_b, self_9_new_c_right),
      self_9_new_d = KSL_MUL(D->m22, RI_2), self_9_new = self_9_new_c + self_9_new_d,
      self_9_new_right = self_9_new - self_9_new_c,
      self_9_new_lo1 = self_9_new_c - (self_9_new - self_9_new_right)
          + ksl_product_rest(D->m22, RI_2, self_9_new_d, self_9_new_right);
  const double self_1_new_lo = ksl_product_rest(self->m, D->m03, self_1_new_a, self_1_new
          - self_1_new_right) + (self_1_new_f - self_1_new_right) + self_1_new_f_lo;
  const double self_1_new_rounded = self_1_new + self_1_new_lo;
  const double self_2_new_lo = ksl_product_rest(self->m, D->m13, self_2_new_a, self_2_new
          - self_2_new_right) + (self_2_new_f - self_2_new_right) + self_2_new_f_lo;
  const double self_2_new_rounded = self_2_new + self_2_new_lo;
  const double self_3_new_lo = ksl_product_rest(self->m, D->m23, self_3_new_a, self_3_new
          - self_3_new_right) + (self_3_new_f - self_3_new_right) + self_3_new_f_lo;
  const double self_3_new_rounded = self_3_new + self_3_new_lo;
  const double self_4_new_lo = self_4_new_lo1 + KSL_MUL(D->m02, RI_2_lo)
          + (self_4_new_c_lo1 + (KSL_MUL(D->m00, RI_0_lo) + KSL_MUL(D->m01, RI_1_lo)));
  const double self_4_new_rounded = self_4_new + self_4_new_lo;
  const double self_5_new_lo = self_5_new_lo1 + KSL_MUL(D->m12, RI_5_lo)
          + (self_5_new_c_lo1 + (KSL_MUL(D->m10, RI_3_lo) + KSL_MUL(D->m11, RI_4_lo)));
  const double self_5_new_rounded = self_5_new + self_5_new_lo,
      self_6_new_rounded = self_6_new
          + (self_6_new_lo2 + (self_6_new_c_lo1 + (self_6_new_a_cross2 + self_6_new_b_cross2)));
  const double self_7_new_lo = self_7_new_lo1 + KSL_MUL(D->m12, RI_2_lo)
          + (self_7_new_c_lo1 + (KSL_MUL(D->m10, RI_0_lo) + KSL_MUL(D->m11, RI_1_lo)));
  const double self_7_new_rounded = self_7_new + self_7_new_lo;
  const double self_8_new_lo = self_8_new_lo1 + KSL_MUL(D->m22, RI_5_lo)
          + (self_8_new_c_lo1 + (KSL_MUL(D->m20, RI_3_lo) + KSL_MUL(D->m21, RI_4_lo)));
  const double self_8_new_rounded = self_8_new + self_8_new_lo;
  const double self_9_new_lo = self_9_new_lo1 + KSL_MUL(D->m22, RI_2_lo)
          + (self_9_new_c_lo1 + (KSL_MUL(D->m20, RI_0_lo) + KSL_MUL(D->m21, RI_1_lo)));
  const double self_9_new_rounded = self_9_new + self_9_new_lo;
  self->mt.x = self_1_new_rounded;
  self->mt.y = self_2_new_rounded;
  self->mt.z = self_3_new_rounded;
  self->Ixx = self_4_new_rounded;
  self->Iyy = self_5_new_rounded;
  self->Izz = self_6_new_rounded;
  self->Ixy = self_7_new_rounded;
  self->Iyz = self_8_new_rounded;
  self->Izx = self_9_new_rounded;
}

/* Ji = the inertia of two joined bodies: Ji, and Jj displaced by D_ij = [R | t]: m_i + m_j, mt_i
     + m_j c, I_i + R I_j R^T + m_i m_j/(m_i + m_j) (d·d 1 - d d^T) with c = R t_jc + t, d = c -
     t_ic; t_ic = mt_i / m_i and t_jc = mt_j / m_j are the centres of mass, each in its own
     frame; NaN where m_i + m_j = 0.
   Ji, Jj: inertia (m in kg; mt = m c in kg m; I about the centre of mass c, xx, yy, zz, xy, yz,
     zx in kg m^2); t_ic, t_jc: vector; D_ij: displacement [R | t], R rotation, t in m.
   109 mul, 401 add, 5 product error, 66 product rest, 2 div, 10 equal, 10 select.
   Error <= 18 u times the sum of the absolute values of all terms, for masses that are not
     negative, barring over- and underflow. */
static inline void ksl_inertia_merge_accurate(ksl_inertia_t *Ji, const ksl_vec3_t *t_ic,
    const ksl_inertia_t *Jj, const ksl_vec3_t *t_jc, const ksl_SE3_t *D_ij) {
  const double m = Ji->m + Jj->m, m_right = m - Ji->m,
      m_lo = Ji->m - (m - m_right) + (Jj->m - m_right);
  const double c_0a = KSL_MUL(t_jc->x, D_ij->m00), c_0b = KSL_MUL(t_jc->y, D_ij->m01),
      c_0c = c_0a + c_0b, c_0c_right = c_0c - c_0a, c_0d = KSL_MUL(t_jc->z, D_ij->m02),
      c_0e = c_0c + c_0d, c_0e_right = c_0e - c_0c,
      c_0c_lo = ksl_product_rest(t_jc->x, D_ij->m00, c_0a, c_0c - c_0c_right)
          + ksl_product_rest(t_jc->y, D_ij->m01, c_0b, c_0c_right), c_0 = c_0e + D_ij->m03,
      c_0_right = c_0 - c_0e,
      c_0e_lo = c_0c - (c_0e - c_0e_right) + ksl_product_rest(t_jc->z, D_ij->m02, c_0d, c_0e_right)
          + c_0c_lo, c_0_lo = c_0e - (c_0 - c_0_right) + (D_ij->m03 - c_0_right) + c_0e_lo;
  const double c_1a = KSL_MUL(t_jc->x, D_ij->m10), c_1b = KSL_MUL(t_jc->y, D_ij->m11),
      c_1c = c_1a + c_1b, c_1c_right = c_1c - c_1a, c_1d = KSL_MUL(t_jc->z, D_ij->m12),
      c_1e = c_1c + c_1d, c_1e_right = c_1e - c_1c,
      c_1c_lo = ksl_product_rest(t_jc->x, D_ij->m10, c_1a, c_1c - c_1c_right)
          + ksl_product_rest(t_jc->y, D_ij->m11, c_1b, c_1c_right), c_1 = c_1e + D_ij->m13,
      c_1_right = c_1 - c_1e,
      c_1e_lo = c_1c - (c_1e - c_1e_right) + ksl_product_rest(t_jc->z, D_ij->m12, c_1d, c_1e_right)
          + c_1c_lo, c_1_lo = c_1e - (c_1 - c_1_right) + (D_ij->m13 - c_1_right) + c_1e_lo;
  const double c_2a = KSL_MUL(t_jc->x, D_ij->m20), c_2b = KSL_MUL(t_jc->y, D_ij->m21),
      c_2c = c_2a + c_2b, c_2c_right = c_2c - c_2a, c_2d = KSL_MUL(t_jc->z, D_ij->m22),
      c_2e = c_2c + c_2d, c_2e_right = c_2e - c_2c,
      c_2c_lo = ksl_product_rest(t_jc->x, D_ij->m20, c_2a, c_2c - c_2c_right)
          + ksl_product_rest(t_jc->y, D_ij->m21, c_2b, c_2c_right), c_2 = c_2e + D_ij->m23,
      c_2_right = c_2 - c_2e,
      c_2e_lo = c_2c - (c_2e - c_2e_right) + ksl_product_rest(t_jc->z, D_ij->m22, c_2d, c_2e_right)
          + c_2c_lo, c_2_lo = c_2e - (c_2 - c_2_right) + (D_ij->m23 - c_2_right) + c_2e_lo;
  const double d_0 = c_0 - t_ic->x, d_0_right = c_0 - d_0,
      d_0_lo = c_0 - (d_0 + d_0_right) - (t_ic->x - d_0_right) + c_0_lo;
  const double d_1 = c_1 - t_ic->y, d_1_right = c_1 - d_1,
      d_1_lo = c_1 - (d_1 + d_1_right) - (t_ic->y - d_1_right) + c_1_lo;
  const double d_2 = c_2 - t_ic->z, d_2_right = c_2 - d_2,
      d_2_lo = c_2 - (d_2 + d_2_right) - (t_ic->z - d_2_right) + c_2_lo;
  const double m_sum = m + m_lo, m_sum_right = m_sum - m, part = Jj->m / m_sum,
      part_product = KSL_MUL(part, m_sum),
      part_residual = Jj->m - part_product - ksl_product_error(part, m_sum, part_product)
          - KSL_MUL(part, m - (m_sum - m_sum_right) + (m_lo - m_sum_right));
  const double reduced = KSL_MUL(Ji->m, part);
  const double reduced_lo = ksl_product_error(Ji->m, part, reduced)
          + KSL_MUL(Ji->m, part_residual / m_sum), p_0 = KSL_MUL(d_0, reduced);
  const double p_1 = KSL_MUL(d_1, reduced), p_2 = KSL_MUL(d_2, reduced);
  const double p_0_lo = ksl_product_error(d_0, reduced, p_0)
          + (KSL_MUL(d_0_lo, reduced) + KSL_MUL(d_0, reduced_lo)), squares_0 = KSL_MUL(d_0, p_0),
      squares_0_cross = KSL_MUL(d_0_lo, p_0) + KSL_MUL(d_0, p_0_lo);
  const double p_1_lo = ksl_product_error(d_1, reduced, p_1)
          + (KSL_MUL(d_1_lo, reduced) + KSL_MUL(d_1, reduced_lo)), squares_1 = KSL_MUL(d_1, p_1),
      squares_1_cross = KSL_MUL(d_1_lo, p_1) + KSL_MUL(d_1, p_1_lo);
  const double squares_2 = KSL_MUL(d_2, p_2),
      squares_2_cross = KSL_MUL(d_2_lo, p_2)
          + KSL_MUL(d_2, ksl_product_error(d_2, reduced, p_2)
          + (KSL_MUL(d_2_lo, reduced) + KSL_MUL(d_2, reduced_lo)));
  const double RI_0a = KSL_MUL(Jj->Ixx, D_ij->m00), RI_0b = KSL_MUL(Jj->Ixy, D_ij->m01),
      RI_0c = RI_0a + RI_0b, RI_0c_right = RI_0c - RI_0a, RI_0d = KSL_MUL(Jj->Izx, D_ij->m02),
      RI_0 = RI_0c + RI_0d, RI_0_right = RI_0 - RI_0c,
      RI_0c_lo = ksl_product_rest(Jj->Ixx, D_ij->m00, RI_0a, RI_0c - RI_0c_right)
          + ksl_product_rest(Jj->Ixy, D_ij->m01, RI_0b, RI_0c_right),
      RI_0_lo = RI_0c - (RI_0 - RI_0_right)
          + ksl_product_rest(Jj->Izx, D_ij->m02, RI_0d, RI_0_right) + RI_0c_lo;
  const double RI_1a = KSL_MUL(Jj->Iyy, D_ij->m01), RI_1b = KSL_MUL(Jj->Ixy, D_ij->m00),
      RI_1c = RI_1a + RI_1b, RI_1c_right = RI_1c - RI_1a, RI_1d = KSL_MUL(Jj->Iyz, D_ij->m02),
      RI_1 = RI_1c + RI_1d, RI_1_right = RI_1 - RI_1c,
      RI_1c_lo = ksl_product_rest(Jj->Iyy, D_ij->m01, RI_1a, RI_1c - RI_1c_right)
          + ksl_product_rest(Jj->Ixy, D_ij->m00, RI_1b, RI_1c_right),
      RI_1_lo = RI_1c - (RI_1 - RI_1_right)
          + ksl_product_rest(Jj->Iyz, D_ij->m02, RI_1d, RI_1_right) + RI_1c_lo;
  const double RI_2a = KSL_MUL(Jj->Izz, D_ij->m02), RI_2b = KSL_MUL(Jj->Iyz, D_ij->m01),
      RI_2c = RI_2a + RI_2b, RI_2c_right = RI_2c - RI_2a, RI_2d = KSL_MUL(Jj->Izx, D_ij->m00),
      RI_2 = RI_2c + RI_2d, RI_2_right = RI_2 - RI_2c,
      RI_2c_lo = ksl_product_rest(Jj->Izz, D_ij->m02, RI_2a, RI_2c - RI_2c_right)
          + ksl_product_rest(Jj->Iyz, D_ij->m01, RI_2b, RI_2c_right),
      RI_2_lo = RI_2c - (RI_2 - RI_2_right)
          + ksl_product_rest(Jj->Izx, D_ij->m00, RI_2d, RI_2_right) + RI_2c_lo;
  const double RI_3a = KSL_MUL(Jj->Ixx, D_ij->m10), RI_3b = KSL_MUL(Jj->Ixy, D_ij->m11),
      RI_3c = RI_3a + RI_3b, RI_3c_right = RI_3c - RI_3a, RI_3d = KSL_MUL(Jj->Izx, D_ij->m12),
      RI_3 = RI_3c + RI_3d, RI_3_right = RI_3 - RI_3c,
      RI_3c_lo = ksl_product_rest(Jj->Ixx, D_ij->m10, RI_3a, RI_3c - RI_3c_right)
          + ksl_product_rest(Jj->Ixy, D_ij->m11, RI_3b, RI_3c_right),
      RI_3_lo = RI_3c - (RI_3 - RI_3_right)
          + ksl_product_rest(Jj->Izx, D_ij->m12, RI_3d, RI_3_right) + RI_3c_lo;
  const double RI_4a = KSL_MUL(Jj->Iyy, D_ij->m11), RI_4b = KSL_MUL(Jj->Ixy, D_ij->m10),
      RI_4c = RI_4a + RI_4b, RI_4c_right = RI_4c - RI_4a, RI_4d = KSL_MUL(Jj->Iyz, D_ij->m12),
      RI_4 = RI_4c + RI_4d, RI_4_right = RI_4 - RI_4c,
      RI_4c_lo = ksl_product_rest(Jj->Iyy, D_ij->m11, RI_4a, RI_4c - RI_4c_right)
          + ksl_product_rest(Jj->Ixy, D_ij->m10, RI_4b, RI_4c_right),
      RI_4_lo = RI_4c - (RI_4 - RI_4_right)
          + ksl_product_rest(Jj->Iyz, D_ij->m12, RI_4d, RI_4_right) + RI_4c_lo;
  const double RI_5a = KSL_MUL(Jj->Izz, D_ij->m12), RI_5b = KSL_MUL(Jj->Iyz, D_ij->m11),
      RI_5c = RI_5a + RI_5b, RI_5c_right = RI_5c - RI_5a, RI_5d = KSL_MUL(Jj->Izx, D_ij->m10),
      RI_5 = RI_5c + RI_5d, RI_5_right = RI_5 - RI_5c,
      RI_5c_lo = ksl_product_rest(Jj->Izz, D_ij->m12, RI_5a, RI_5c - RI_5c_right)
          + ksl_product_rest(Jj->Iyz, D_ij->m11, RI_5b, RI_5c_right),
      RI_5_lo = RI_5c - (RI_5 - RI_5_right)
          + ksl_product_rest(Jj->Izx, D_ij->m10, RI_5d, RI_5_right) + RI_5c_lo;
  const double RI_6a = KSL_MUL(Jj->Ixx, D_ij->m20), RI_6b = KSL_MUL(Jj->Ixy, D_ij->m21),
      RI_6c = RI_6a + RI_6b, RI_6c_right = RI_6c - RI_6a, RI_6d = KSL_MUL(Jj->Izx, D_ij->m22),
      RI_6 = RI_6c + RI_6d, RI_6_right = RI_6 - RI_6c,
      RI_6c_lo = ksl_product_rest(Jj->Ixx, D_ij->m20, RI_6a, RI_6c - RI_6c_right)
          + ksl_product_rest(Jj->Ixy, D_ij->m21, RI_6b, RI_6c_right);
  const double RI_7a = KSL_MUL(Jj->Iyy, D_ij->m21), RI_7b = KSL_MUL(Jj->Ixy, D_ij->m20),
      RI_7c = RI_7a + RI_7b, RI_7c_right = RI_7c - RI_7a, RI_7d = KSL_MUL(Jj->Iyz, D_ij->m22),
      RI_7 = RI_7c + RI_7d, RI_7_right = RI_7 - RI_7c,
      RI_7c_lo = ksl_product_rest(Jj->Iyy, D_ij->m21, RI_7a, RI_7c - RI_7c_right)
          + ksl_product_rest(Jj->Ixy, D_ij->m20, RI_7b, RI_7c_right);
  const double RI_8a = KSL_MUL(Jj->Izz, D_ij->m22), RI_8b = KSL_MUL(Jj->Iyz, D_ij->m21),
      RI_8c = RI_8a + RI_8b, RI_8c_right = RI_8c - RI_8a, RI_8d = KSL_MUL(Jj->Izx, D_ij->m20),
      RI_8 = RI_8c + RI_8d, RI_8_right = RI_8 - RI_8c,
      RI_8c_lo = ksl_product_rest(Jj->Izz, D_ij->m22, RI_8a, RI_8c - RI_8c_right)
          + ksl_product_rest(Jj->Iyz, D_ij->m21, RI_8b, RI_8c_right);
  const double Ji_1_new_a = KSL_MUL(Jj->m, c_0), Ji_1_new = Ji->mt.x + Ji_1_new_a,
      Ji_1_new_right = Ji_1_new - Ji->mt.x;
  const double Ji_2_new_a = KSL_MUL(Jj->m, c_1), Ji_2_new = Ji->mt.y + Ji_2_new_a,
      Ji_2_new_right = Ji_2_new - Ji->mt.y;
  const double Ji_3_new_a = KSL_MUL(Jj->m, c_2), Ji_3_new = Ji->mt.z + Ji_3_new_a,
      Ji_3_new_right = Ji_3_new - Ji->mt.z;
  const double Ji_4_new_a = KSL_MUL(D_ij->m00, RI_0), Ji_4_new_b = KSL_MUL(D_ij->m01, RI_1),
      Ji_4_new_c = Ji_4_new_a + Ji_4_new_b, Ji_4_new_c_right = Ji_4_new_c - Ji_4_new_a,
      Ji_4_new_c_left_rest = ksl_product_rest(D_ij->m00, RI_0, Ji_4_new_a, Ji_4_new_c
          - Ji_4_new_c_right),
      Ji_4_new_c_lo1 = Ji_4_new_c_left_rest
          + ksl_product_rest(D_ij->m01, RI_1, Ji_4_new_b, Ji_4_new_c_right),
      Ji_4_new_d = KSL_MUL(D_ij->m02, RI_2), Ji_4_new_e = Ji_4_new_c + Ji_4_new_d,
      Ji_4_new_e_right = Ji_4_new_e - Ji_4_new_c,
      Ji_4_new_e_lo1 = Ji_4_new_c - (Ji_4_new_e - Ji_4_new_e_right)
          + ksl_product_rest(D_ij->m02, RI_2, Ji_4_new_d, Ji_4_new_e_right),
      Ji_4_new_f = Ji->Ixx + Ji_4_new_e, Ji_4_new_f_right = Ji_4_new_f - Ji->Ixx,
      Ji_4_new_e_lo = Ji_4_new_e_lo1 + KSL_MUL(D_ij->m02, RI_2_lo)
          + (Ji_4_new_c_lo1 + (KSL_MUL(D_ij->m00, RI_0_lo) + KSL_MUL(D_ij->m01, RI_1_lo))),
      Ji_4_new_g = squares_1 + squares_2, Ji_4_new_g_right = Ji_4_new_g - squares_1,
      Ji_4_new_g_lo1 = ksl_product_rest(d_1, p_1, squares_1, Ji_4_new_g - Ji_4_new_g_right)
          + ksl_product_rest(d_2, p_2, squares_2, Ji_4_new_g_right),
      Ji_4_new = Ji_4_new_f + Ji_4_new_g, Ji_4_new_right = Ji_4_new - Ji_4_new_f,
      Ji_4_new_lo2 = Ji_4_new_f - (Ji_4_new - Ji_4_new_right) + (Ji_4_new_g - Ji_4_new_right)
          + (Ji_4_new_g_lo1 + (squares_1_cross + squares_2_cross));
  const double Ji_5_new_a = KSL_MUL(D_ij->m10, RI_3), Ji_5_new_b = KSL_MUL(D_ij->m11, RI_4),
      Ji_5_new_c = Ji_5_new_a + Ji_5_new_b, Ji_5_new_c_right = Ji_5_new_c - Ji_5_new_a,
      Ji_5_new_c_left_rest = ksl_product_rest(D_ij->m10, RI_3, Ji_5_new_a, Ji_5_new_c
          - Ji_5_new_c_right),
      Ji_5_new_c_lo1 = Ji_5_new_c_left_rest
          + ksl_product_rest(D_ij->m11, RI_4, Ji_5_new_b, Ji_5_new_c_right),
      Ji_5_new_d = KSL_MUL(D_ij->m12, RI_5), Ji_5_new_e = Ji_5_new_c + Ji_5_new_d,
      Ji_5_new_e_right = Ji_5_new_e - Ji_5_new_c,
      Ji_5_new_e_lo1 = Ji_5_new_c - (Ji_5_new_e - Ji_5_new_e_right)
          + ksl_product_rest(D_ij->m12, RI_5, Ji_5_new_d, Ji_5_new_e_right),
      Ji_5_new_f = Ji->Iyy + Ji_5_new_e, Ji_5_new_f_right = Ji_5_new_f - Ji->Iyy,
      Ji_5_new_e_lo = Ji_5_new_e_lo1 + KSL_MUL(D_ij->m12, RI_5_lo)
          + (Ji_5_new_c_lo1 + (KSL_MUL(D_ij->m10, RI_3_lo) + KSL_MUL(D_ij->m11, RI_4_lo))),
      Ji_5_new_g = squares_0 + squares_2, Ji_5_new_g_right = Ji_5_new_g - squares_0,
      Ji_5_new_g_lo1 = ksl_product_rest(d_0, p_0, squares_0, Ji_5_new_g - Ji_5_new_g_right)
          + ksl_product_rest(d_2, p_2, squares_2, Ji_5_new_g_right),
      Ji_5_new = Ji_5_new_f + Ji_5_new_g, Ji_5_new_right = Ji_5_new - Ji_5_new_f,
      Ji_5_new_lo2 = Ji_5_new_f - (Ji_5_new - Ji_5_new_right) + (Ji_5_new_g - Ji_5_new_right)
          + (Ji_5_new_g_lo1 + (squares_0_cross + squares_2_cross));
  const double Ji_6_new_a = KSL_MUL(D_ij->m20, RI_6), Ji_6_new_b = KSL_MUL(D_ij->m21, RI_7),
      Ji_6_new_c = Ji_6_new_a + Ji_6_new_b, Ji_6_new_c_right = Ji_6_new_c - Ji_6_new_a,
      Ji_6_new_a_cross2 = KSL_MUL(D_ij->m20, RI_6c - (RI_6 - RI_6_right)
          + ksl_product_rest(Jj->Izx, D_ij->m22, RI_6d, RI_6_right) + RI_6c_lo),
      Ji_6_new_b_cross2 = KSL_MUL(D_ij->m21, RI_7c - (RI_7 - RI_7_right)
          + ksl_product_rest(Jj->Iyz, D_ij->m22, RI_7d, RI_7_right) + RI_7c_lo),
      Ji_6_new_c_left_rest = ksl_product_rest(D_ij->m20, RI_6, Ji_6_new_a, Ji_6_new_c
          - Ji_6_new_c_right), Ji_6_new_d = KSL_MUL(D_ij->m22, RI_8),
      Ji_6_new_e = Ji_6_new_c + Ji_6_new_d, Ji_6_new_e_right = Ji_6_new_e - Ji_6_new_c,
      Ji_6_new_d_cross2 = KSL_MUL(D_ij->m22, RI_8c - (RI_8 - RI_8_right)
          + ksl_product_rest(Jj->Izx, D_ij->m20, RI_8d, RI_8_right) + RI_8c_lo),
      Ji_6_new_e_lo2 = Ji_6_new_c - (Ji_6_new_e - Ji_6_new_e_right)
          + ksl_product_rest(D_ij->m22, RI_8, Ji_6_new_d, Ji_6_new_e_right) + Ji_6_new_d_cross2,
      Ji_6_new_c_lo = Ji_6_new_c_left_rest
          + ksl_product_rest(D_ij->m21, RI_7, Ji_6_new_b, Ji_6_new_c_right)
          + (Ji_6_new_a_cross2 + Ji_6_new_b_cross2), Ji_6_new_f = Ji->Izz + Ji_6_new_e,
      Ji_6_new_f_right = Ji_6_new_f - Ji->Izz, Ji_6_new_g = squares_0 + squares_1,
      Ji_6_new_g_right = Ji_6_new_g - squares_0,
      Ji_6_new_g_lo1 = ksl_product_rest(d_0, p_0, squares_0, Ji_6_new_g - Ji_6_new_g_right)
          + ksl_product_rest(d_1, p_1, squares_1, Ji_6_new_g_right),
      Ji_6_new = Ji_6_new_f + Ji_6_new_g, Ji_6_new_right = Ji_6_new - Ji_6_new_f,
      Ji_6_new_lo2 = Ji_6_new_f - (Ji_6_new - Ji_6_new_right) + (Ji_6_new_g - Ji_6_new_right)
          + (Ji_6_new_g_lo1 + (squares_0_cross + squares_1_cross));
  const double Ji_7_new_a = KSL_MUL(D_ij->m10, RI_0), Ji_7_new_b = KSL_MUL(D_ij->m11, RI_1),
      Ji_7_new_c = Ji_7_new_a + Ji_7_new_b, Ji_7_new_c_right = Ji_7_new_c - Ji_7_new_a,
      Ji_7_new_c_left_rest = ksl_product_rest(D_ij->m10, RI_0, Ji_7_new_a, Ji_7_new_c
          - Ji_7_new_c_right),
      Ji_7_new_c_lo1 = Ji_7_new_c_left_rest
          + ksl_product_rest(D_ij->m11, RI_1, Ji_7_new_b, Ji_7_new_c_right),
      Ji_7_new_d = KSL_MUL(D_ij->m12, RI_2), Ji_7_new_e = Ji_7_new_c + Ji_7_new_d,
      Ji_7_new_e_right = Ji_7_new_e - Ji_7_new_c,
      Ji_7_new_e_lo1 = Ji_7_new_c - (Ji_7_new_e - Ji_7_new_e_right)
          + ksl_product_rest(D_ij->m12, RI_2, Ji_7_new_d, Ji_7_new_e_right),
      Ji_7_new_f = Ji->Ixy + Ji_7_new_e, Ji_7_new_f_right = Ji_7_new_f - Ji->Ixy,
      Ji_7_new_e_lo = Ji_7_new_e_lo1 + KSL_MUL(D_ij->m12, RI_2_lo)
          + (Ji_7_new_c_lo1 + (KSL_MUL(D_ij->m10, RI_0_lo) + KSL_MUL(D_ij->m11, RI_1_lo))),
      Ji_7_new_g = KSL_MUL(d_1, p_0), Ji_7_new = Ji_7_new_f - Ji_7_new_g,
      Ji_7_new_right = Ji_7_new_f - Ji_7_new,
      Ji_7_new_lo1 = Ji_7_new_f - (Ji_7_new + Ji_7_new_right)
          - ksl_product_rest(d_1, p_0, Ji_7_new_g, Ji_7_new_right),
      Ji_7_new_f_lo = Ji->Ixy - (Ji_7_new_f - Ji_7_new_f_right) + (Ji_7_new_e - Ji_7_new_f_right)
          + Ji_7_new_e_lo;
  const double Ji_8_new_a = KSL_MUL(D_ij->m20, RI_3), Ji_8_new_b = KSL_MUL(D_ij->m21, RI_4),
      Ji_8_new_c = Ji_8_new_a + Ji_8_new_b, Ji_8_new_c_right = Ji_8_new_c - Ji_8_new_a,
      Ji_8_new_c_left_rest = ksl_product_rest(D_ij->m20, RI_3, Ji_8_new_a, Ji_8_new_c
          - Ji_8_new_c_right),
      Ji_8_new_c_lo1 = Ji_8_new_c_left_rest
          + ksl_product_rest(D_ij->m21, RI_4, Ji_8_new_b, Ji_8_new_c_right),
      Ji_8_new_d = KSL_MUL(D_ij->m22, RI_5), Ji_8_new_e = Ji_8_new_c + Ji_8_new_d,
      Ji_8_new_e_right = Ji_8_new_e - Ji_8_new_c,
      Ji_8_new_e_lo1 = Ji_8_new_c - (Ji_8_new_e - Ji_8_new_e_right)
          + ksl_product_rest(D_ij->m22, RI_5, Ji_8_new_d, Ji_8_new_e_right),
      Ji_8_new_f = Ji->Iyz + Ji_8_new_e, Ji_8_new_f_right = Ji_8_new_f - Ji->Iyz,
      Ji_8_new_e_lo = Ji_8_new_e_lo1 + KSL_MUL(D_ij->m22, RI_5_lo)
          + (Ji_8_new_c_lo1 + (KSL_MUL(D_ij->m20, RI_3_lo) + KSL_MUL(D_ij->m21, RI_4_lo))),
      Ji_8_new_g = KSL_MUL(d_2, p_1), Ji_8_new = Ji_8_new_f - Ji_8_new_g,
      Ji_8_new_right = Ji_8_new_f - Ji_8_new,
      Ji_8_new_lo1 = Ji_8_new_f - (Ji_8_new + Ji_8_new_right)
          - ksl_product_rest(d_2, p_1, Ji_8_new_g, Ji_8_new_right),
      Ji_8_new_f_lo = Ji->Iyz - (Ji_8_new_f - Ji_8_new_f_right) + (Ji_8_new_e - Ji_8_new_f_right)
          + Ji_8_new_e_lo;
  const double Ji_9_new_a = KSL_MUL(D_ij->m20, RI_0), Ji_9_new_b = KSL_MUL(D_ij->m21, RI_1),
      Ji_9_new_c = Ji_9_new_a + Ji_9_new_b, Ji_9_new_c_right = Ji_9_new_c - Ji_9_new_a,
      Ji_9_new_c_left_rest = ksl_product_rest(D_ij->m20, RI_0, Ji_9_new_a, Ji_9_new_c
          - Ji_9_new_c_right),
      Ji_9_new_c_lo1 = Ji_9_new_c_left_rest
          + ksl_product_rest(D_ij->m21, RI_1, Ji_9_new_b, Ji_9_new_c_right),
      Ji_9_new_d = KSL_MUL(D_ij->m22, RI_2), Ji_9_new_e = Ji_9_new_c + Ji_9_new_d,
      Ji_9_new_e_right = Ji_9_new_e - Ji_9_new_c,
      Ji_9_new_e_lo1 = Ji_9_new_c - (Ji_9_new_e - Ji_9_new_e_right)
          + ksl_product_rest(D_ij->m22, RI_2, Ji_9_new_d, Ji_9_new_e_right),
      Ji_9_new_f = Ji->Izx + Ji_9_new_e, Ji_9_new_f_right = Ji_9_new_f - Ji->Izx,
      Ji_9_new_e_lo = Ji_9_new_e_lo1 + KSL_MUL(D_ij->m22, RI_2_lo)
          + (Ji_9_new_c_lo1 + (KSL_MUL(D_ij->m20, RI_0_lo) + KSL_MUL(D_ij->m21, RI_1_lo))),
      Ji_9_new_g = KSL_MUL(d_2, p_0), Ji_9_new = Ji_9_new_f - Ji_9_new_g,
      Ji_9_new_right = Ji_9_new_f - Ji_9_new,
      Ji_9_new_lo1 = Ji_9_new_f - (Ji_9_new + Ji_9_new_right)
          - ksl_product_rest(d_2, p_0, Ji_9_new_g, Ji_9_new_right),
      Ji_9_new_f_lo = Ji->Izx - (Ji_9_new_f - Ji_9_new_f_right) + (Ji_9_new_e - Ji_9_new_f_right)
          + Ji_9_new_e_lo;
  const double m_rounded = m + m_lo;
  const double Ji_1_new_lo = Ji->mt.x - (Ji_1_new - Ji_1_new_right)
          + ksl_product_rest(Jj->m, c_0, Ji_1_new_a, Ji_1_new_right) + KSL_MUL(Jj->m, c_0_lo);
  const double Ji_1_new_rounded = Ji_1_new + Ji_1_new_lo;
  const double Ji_2_new_lo = Ji->mt.y - (Ji_2_new - Ji_2_new_right)
          + ksl_product_rest(Jj->m, c_1, Ji_2_new_a, Ji_2_new_right) + KSL_MUL(Jj->m, c_1_lo);
  const double Ji_2_new_rounded = Ji_2_new + Ji_2_new_lo;
  const double Ji_3_new_lo = Ji->mt.z - (Ji_3_new - Ji_3_new_right)
          + ksl_product_rest(Jj->m, c_2, Ji_3_new_a, Ji_3_new_right) + KSL_MUL(Jj->m, c_2_lo);
  const double Ji_3_new_rounded = Ji_3_new + Ji_3_new_lo;
  const double Ji_4_new_rounded = Ji_4_new
          + (Ji_4_new_lo2
          + (Ji->Ixx - (Ji_4_new_f - Ji_4_new_f_right) + (Ji_4_new_e - Ji_4_new_f_right)
          + Ji_4_new_e_lo));
  const double Ji_5_new_rounded = Ji_5_new
          + (Ji_5_new_lo2
          + (Ji->Iyy - (Ji_5_new_f - Ji_5_new_f_right) + (Ji_5_new_e - Ji_5_new_f_right)
          + Ji_5_new_e_lo));
  const double Ji_6_new_lo = Ji_6_new_lo2
          + (Ji->Izz - (Ji_6_new_f - Ji_6_new_f_right) + (Ji_6_new_e - Ji_6_new_f_right)
          + (Ji_6_new_e_lo2 + Ji_6_new_c_lo));
  const double Ji_6_new_rounded = Ji_6_new + Ji_6_new_lo;
  const double Ji_7_new_rounded = Ji_7_new
          + (Ji_7_new_lo1 - (KSL_MUL(d_1_lo, p_0) + KSL_MUL(d_1, p_0_lo)) + Ji_7_new_f_lo);
  const double Ji_8_new_rounded = Ji_8_new
          + (Ji_8_new_lo1 - (KSL_MUL(d_2_lo, p_1) + KSL_MUL(d_2, p_1_lo)) + Ji_8_new_f_lo);
  const double Ji_9_new_rounded = Ji_9_new
          + (Ji_9_new_lo1 - (KSL_MUL(d_2_lo, p_0) + KSL_MUL(d_2, p_0_lo)) + Ji_9_new_f_lo);
  const double m_final = m_rounded == m_rounded ? m_rounded : m;
  const double Ji_1_new_final = Ji_1_new_rounded == Ji_1_new_rounded ? Ji_1_new_rounded : Ji_1_new;
  const double Ji_2_new_final = Ji_2_new_rounded == Ji_2_new_rounded ? Ji_2_new_rounded : Ji_2_new;
  const double Ji_3_new_final = Ji_3_new_rounded == Ji_3_new_rounded ? Ji_3_new_rounded : Ji_3_new;
  const double Ji_4_new_final = Ji_4_new_rounded == Ji_4_new_rounded ? Ji_4_new_rounded : Ji_4_new;
  const double Ji_5_new_final = Ji_5_new_rounded == Ji_5_new_rounded ? Ji_5_new_rounded : Ji_5_new;
  const double Ji_6_new_final = Ji_6_new_rounded == Ji_6_new_rounded ? Ji_6_new_rounded : Ji_6_new;
  const double Ji_7_new_final = Ji_7_new_rounded == Ji_7_new_rounded ? Ji_7_new_rounded : Ji_7_new;
  const double Ji_8_new_final = Ji_8_new_rounded == Ji_8_new_rounded ? Ji_8_new_rounded : Ji_8_new;
  const double Ji_9_new_final = Ji_9_new_rounded == Ji_9_new_rounded ? Ji_9_new_rounded : Ji_9_new;
  Ji->m = m_final;
  Ji->mt.x = Ji_1_new_final;
  Ji->mt.y = Ji_2_new_final;
  Ji->mt.z = Ji_3_new_final;
  Ji->Ixx = Ji_4_new_final;
  Ji->Iyy = Ji_5_new_final;
  Ji->Izz = Ji_6_new_final;
  Ji->Ixy = Ji_7_new_final;
  Ji->Iyz = Ji_8_new_final;
  Ji->Izx = Ji_9_new_final;
}

/* J = (m; m t; Ixx, Iyy, Izz, Ixy, Iyz, Izx): mass, centre of mass t in m, entries of the
     moments' matrix about it in kg m^2, Ixy = -∫ x y dm.
   m, Ixx, Iyy, Izz, Ixy, Iyz, Izx: number; t: vector.
   3 mul.
   Error <= u |result| + (m: 0, mt: 1/32, I: 0) u^2 S, S the sum of the |terms| of the expanded
     formula; barring over- and underflow. */
static inline ksl_inertiaf_t ksl_inertiaf_accurate(const float m, const ksl_vec3f_t t,
    const float Ixx, const float Iyy, const float Izz, const float Ixy,
    const float Iyz, const float Izx) {
  const double J_1 = (double)m * (double)t.x, J_2 = (double)m * (double)t.y,
      J_3 = (double)m * (double)t.z;
  ksl_inertiaf_t J;
  J.m = m;
  J.mt.x = (float)J_1;
  J.mt.y = (float)J_2;
  J.mt.z = (float)J_3;
  J.Ixx = Ixx;
  J.Iyy = Iyy;
  J.Izz = Izz;
  J.Ixy = Ixy;
  J.Iyz = Iyz;
  J.Izx = Izx;
  return J;
}

/* Jo = Ji rotated by R: m, R mt, R I R^T.
   Ji, Jo: inertia (m in kg; mt = m c in kg m; I about the centre of mass c, xx, yy, zz, xy, yz,
     zx in kg m^2); R: rotation or other 3×3 matrix.
   54 mul, 36 add.
   Error <= u |result| + (m: 0, mt: 3/32, I: 3/16) u^2 S, S the sum of the |terms| of the
     expanded formula; barring over- and underflow. */
static inline void ksl_inertiaf_rotated_accurate(const ksl_inertiaf_t *Ji, const ksl_mat3x3f_t *R,
    ksl_inertiaf_t *Jo) {
  const double RI_0 = ksl_product_sum((double)Ji->Izx, (double)R->m02,
      ksl_product_sum((double)Ji->Ixy, (double)R->m01, (double)Ji->Ixx * (double)R->m00)),
      RI_1 = ksl_product_sum((double)Ji->Iyz, (double)R->m02, ksl_product_sum((double)Ji->Ixy,
          (double)R->m00, (double)Ji->Iyy * (double)R->m01)),
      RI_2 = ksl_product_sum((double)Ji->Izx, (double)R->m00, ksl_product_sum((double)Ji->Iyz,
          (double)R->m01, (double)Ji->Izz * (double)R->m02)),
      RI_3 = ksl_product_sum((double)Ji->Izx, (double)R->m12, ksl_product_sum((double)Ji->Ixy,
          (double)R->m11, (double)Ji->Ixx * (double)R->m10)),
      RI_4 = ksl_product_sum((double)Ji->Iyz, (double)R->m12, ksl_product_sum((double)Ji->Ixy,
          (double)R->m10, (double)Ji->Iyy * (double)R->m11)),
      RI_5 = ksl_product_sum((double)Ji->Izx, (double)R->m10, ksl_product_sum((double)Ji->Iyz,
          (double)R->m11, (double)Ji->Izz * (double)R->m12)),
      RI_6 = ksl_product_sum((double)Ji->Izx, (double)R->m22, ksl_product_sum((double)Ji->Ixy,
          (double)R->m21, (double)Ji->Ixx * (double)R->m20)),
      RI_7 = ksl_product_sum((double)Ji->Iyz, (double)R->m22, ksl_product_sum((double)Ji->Ixy,
          (double)R->m20, (double)Ji->Iyy * (double)R->m21)),
      RI_8 = ksl_product_sum((double)Ji->Izx, (double)R->m20, ksl_product_sum((double)Ji->Iyz,
          (double)R->m21, (double)Ji->Izz * (double)R->m22));
  const double Jo_1 = ksl_product_sum((double)Ji->mt.z, (double)R->m02,
      ksl_product_sum((double)Ji->mt.y, (double)R->m01, (double)Ji->mt.x * (double)R->m00)),
      Jo_2 = ksl_product_sum((double)Ji->mt.z, (double)R->m12, ksl_product_sum((double)Ji->mt.y,
          (double)R->m11, (double)Ji->mt.x * (double)R->m10)),
      Jo_3 = ksl_product_sum((double)Ji->mt.z, (double)R->m22, ksl_product_sum((double)Ji->mt.y,
          (double)R->m21, (double)Ji->mt.x * (double)R->m20)),
      Jo_4 = KSL_MUL((double)R->m00, RI_0) + KSL_MUL((double)R->m01, RI_1)
          + KSL_MUL((double)R->m02, RI_2),
      Jo_5 = KSL_MUL((double)R->m10, RI_3) + KSL_MUL((double)R->m11, RI_4)
          + KSL_MUL((double)R->m12, RI_5),
      Jo_6 = KSL_MUL((double)R->m20, RI_6) + KSL_MUL((double)R->m21, RI_7)
          + KSL_MUL((double)R->m22, RI_8),
      Jo_7 = KSL_MUL((double)R->m10, RI_0) + KSL_MUL((double)R->m11, RI_1)
          + KSL_MUL((double)R->m12, RI_2),
      Jo_8 = KSL_MUL((double)R->m20, RI_3) + KSL_MUL((double)R->m21, RI_4)
          + KSL_MUL((double)R->m22, RI_5),
      Jo_9 = KSL_MUL((double)R->m20, RI_0) + KSL_MUL((double)R->m21, RI_1)
          + KSL_MUL((double)R->m22, RI_2);
  const float Ji_m = Ji->m;
  Jo->m = Ji_m;
  Jo->mt.x = (float)Jo_1;
  Jo->mt.y = (float)Jo_2;
  Jo->mt.z = (float)Jo_3;
  Jo->Ixx = (float)Jo_4;
  Jo->Iyy = (float)Jo_5;
  Jo->Izz = (float)Jo_6;
  Jo->Ixy = (float)Jo_7;
  Jo->Iyz = (float)Jo_8;
  Jo->Izx = (float)Jo_9;
}

/* self = self rotated by R: m, R mt, R I R^T.
   self: inertia (m in kg; mt = m c in kg m; I about the centre of mass c, xx, yy, zz, xy, yz, zx
     in kg m^2); R: rotation or other 3×3 matrix.
   54 mul, 36 add.
   Error <= u |result| + (m: 0, mt: 3/32, I: 3/16) u^2 S, S the sum of the |terms| of the
     expanded formula; barring over- and underflow. */
static inline void ksl_inertiaf_rotate_accurate(ksl_inertiaf_t *self, const ksl_mat3x3f_t *R) {
  const double RI_0 = ksl_product_sum((double)self->Izx, (double)R->m02,
      ksl_product_sum((double)self->Ixy, (double)R->m01, (double)self->Ixx * (double)R->m00)),
      RI_1 = ksl_product_sum((double)self->Iyz, (double)R->m02, ksl_product_sum((double)self->Ixy,
          (double)R->m00, (double)self->Iyy * (double)R->m01)),
      RI_2 = ksl_product_sum((double)self->Izx, (double)R->m00, ksl_product_sum((double)self->Iyz,
          (double)R->m01, (double)self->Izz * (double)R->m02)),
      RI_3 = ksl_product_sum((double)self->Izx, (double)R->m12, ksl_product_sum((double)self->Ixy,
          (double)R->m11, (double)self->Ixx * (double)R->m10)),
      RI_4 = ksl_product_sum((double)self->Iyz, (double)R->m12, ksl_product_sum((double)self->Ixy,
          (double)R->m10, (double)self->Iyy * (double)R->m11)),
      RI_5 = ksl_product_sum((double)self->Izx, (double)R->m10, ksl_product_sum((double)self->Iyz,
          (double)R->m11, (double)self->Izz * (double)R->m12)),
      RI_6 = ksl_product_sum((double)self->Izx, (double)R->m22, ksl_product_sum((double)self->Ixy,
          (double)R->m21, (double)self->Ixx * (double)R->m20)),
      RI_7 = ksl_product_sum((double)self->Iyz, (double)R->m22, ksl_product_sum((double)self->Ixy,
          (double)R->m20, (double)self->Iyy * (double)R->m21)),
      RI_8 = ksl_product_sum((double)self->Izx, (double)R->m20, ksl_product_sum((double)self->Iyz,
          (double)R->m21, (double)self->Izz * (double)R->m22));
  const double self_1_new_c = ksl_product_sum((double)self->mt.y, (double)R->m01, (double)self->mt.x
      * (double)R->m00),
      self_1_new = ksl_product_sum((double)self->mt.z, (double)R->m02, self_1_new_c);
  const double self_2_new_c = ksl_product_sum((double)self->mt.y, (double)R->m11, (double)self->mt.x
      * (double)R->m10),
      self_2_new = ksl_product_sum((double)self->mt.z, (double)R->m12, self_2_new_c);
  const double self_3_new_c = ksl_product_sum((double)self->mt.y, (double)R->m21, (double)self->mt.x
      * (double)R->m20),
      self_3_new = ksl_product_sum((double)self->mt.z, (double)R->m22, self_3_new_c);
  const double self_4_new = KSL_MUL((double)R->m00, RI_0) + KSL_MUL((double)R->m01, RI_1)
          + KSL_MUL((double)R->m02, RI_2),
      self_5_new = KSL_MUL((double)R->m10, RI_3) + KSL_MUL((double)R->m11, RI_4)
          + KSL_MUL((double)R->m12, RI_5),
      self_6_new = KSL_MUL((double)R->m20, RI_6) + KSL_MUL((double)R->m21, RI_7)
          + KSL_MUL((double)R->m22, RI_8),
      self_7_new = KSL_MUL((double)R->m10, RI_0) + KSL_MUL((double)R->m11, RI_1)
          + KSL_MUL((double)R->m12, RI_2),
      self_8_new = KSL_MUL((double)R->m20, RI_3) + KSL_MUL((double)R->m21, RI_4)
          + KSL_MUL((double)R->m22, RI_5),
      self_9_new = KSL_MUL((double)R->m20, RI_0) + KSL_MUL((double)R->m21, RI_1)
          + KSL_MUL((double)R->m22, RI_2);
  self->mt.x = (float)self_1_new;
  self->mt.y = (float)self_2_new;
  self->mt.z = (float)self_3_new;
  self->Ixx = (float)self_4_new;
  self->Iyy = (float)self_5_new;
  self->Izz = (float)self_6_new;
  self->Ixy = (float)self_7_new;
  self->Iyz = (float)self_8_new;
  self->Izx = (float)self_9_new;
}

/* Jo = Ji translated by t: m, mt + m t, I.
   Ji, Jo: inertia (m in kg; mt = m c in kg m; I about the centre of mass c, xx, yy, zz, xy, yz,
     zx in kg m^2); t: vector.
   3 mul, 3 add.
   Error <= u |result| + (m: 0, mt: 1/16, I: 0) u^2 S, S the sum of the |terms| of the expanded
     formula; barring over- and underflow. */
static inline void ksl_inertiaf_translated_accurate(const ksl_inertiaf_t *Ji,
    const ksl_vec3f_t *t, ksl_inertiaf_t *Jo) {
  const double Jo_1 = ksl_product_sum((double)Ji->m, (double)t->x, (double)Ji->mt.x),
      Jo_2 = ksl_product_sum((double)Ji->m, (double)t->y, (double)Ji->mt.y),
      Jo_3 = ksl_product_sum((double)Ji->m, (double)t->z, (double)Ji->mt.z);
  const float Ji_m = Ji->m;
  const float Ji_Ixx = Ji->Ixx;
  const float Ji_Iyy = Ji->Iyy;
  const float Ji_Izz = Ji->Izz;
  const float Ji_Ixy = Ji->Ixy;
  const float Ji_Iyz = Ji->Iyz;
  const float Ji_Izx = Ji->Izx;
  Jo->m = Ji_m;
  Jo->mt.x = (float)Jo_1;
  Jo->mt.y = (float)Jo_2;
  Jo->mt.z = (float)Jo_3;
  Jo->Ixx = Ji_Ixx;
  Jo->Iyy = Ji_Iyy;
  Jo->Izz = Ji_Izz;
  Jo->Ixy = Ji_Ixy;
  Jo->Iyz = Ji_Iyz;
  Jo->Izx = Ji_Izx;
}

/* self = self translated by t: m, mt + m t, I.
   self: inertia (m in kg; mt = m c in kg m; I about the centre of mass c, xx, yy, zz, xy, yz, zx
     in kg m^2); t: vector.
   3 mul, 3 add.
   Error <= u |result| + (m: 0, mt: 1/16, I: 0) u^2 S, S the sum of the |terms| of the expanded
     formula; barring over- and underflow. */
static inline void ksl_inertiaf_translate_accurate(ksl_inertiaf_t *self, const ksl_vec3f_t *t) {
  const double self_1_new = ksl_product_sum((double)self->m, (double)t->x, (double)self->mt.x),
      self_2_new = ksl_product_sum((double)self->m, (double)t->y, (double)self->mt.y),
      self_3_new = ksl_product_sum((double)self->m, (double)t->z, (double)self->mt.z);
  self->mt.x = (float)self_1_new;
  self->mt.y = (float)self_2_new;
  self->mt.z = (float)self_3_new;
}

/* Jo = Ji displaced by D = [R | t]: m, R mt + m t, R I R^T.
   Ji, Jo: inertia (m in kg; mt = m c in kg m; I about the centre of mass c, xx, yy, zz, xy, yz,
     zx in kg m^2); D: displacement [R | t], R rotation, t in m.
   57 mul, 39 add.
   Error <= u |result| + (m: 0, mt: 1/8, I: 3/16) u^2 S, S the sum of the |terms| of the expanded
     formula; barring over- and underflow. */
static inline void ksl_inertiaf_transformed_accurate(const ksl_inertiaf_t *Ji,
    const ksl_SE3f_t *D, ksl_inertiaf_t *Jo) {
  const double RI_0 = ksl_product_sum((double)Ji->Izx, (double)D->m02,
      ksl_product_sum((double)Ji->Ixy, (double)D->m01, (double)Ji->Ixx * (double)D->m00)),
      RI_1 = ksl_product_sum((double)Ji->Iyz, (double)D->m02, ksl_product_sum((double)Ji->Ixy,
          (double)D->m00, (double)Ji->Iyy * (double)D->m01)),
      RI_2 = ksl_product_sum((double)Ji->Izx, (double)D->m00, ksl_product_sum((double)Ji->Iyz,
          (double)D->m01, (double)Ji->Izz * (double)D->m02)),
      RI_3 = ksl_product_sum((double)Ji->Izx, (double)D->m12, ksl_product_sum((double)Ji->Ixy,
          (double)D->m11, (double)Ji->Ixx * (double)D->m10)),
      RI_4 = ksl_product_sum((double)Ji->Iyz, (double)D->m12, ksl_product_sum((double)Ji->Ixy,
          (double)D->m10, (double)Ji->Iyy * (double)D->m11)),
      RI_5 = ksl_product_sum((double)Ji->Izx, (double)D->m10, ksl_product_sum((double)Ji->Iyz,
          (double)D->m11, (double)Ji->Izz * (double)D->m12)),
      RI_6 = ksl_product_sum((double)Ji->Izx, (double)D->m22, ksl_product_sum((double)Ji->Ixy,
          (double)D->m21, (double)Ji->Ixx * (double)D->m20)),
      RI_7 = ksl_product_sum((double)Ji->Iyz, (double)D->m22, ksl_product_sum((double)Ji->Ixy,
          (double)D->m20, (double)Ji->Iyy * (double)D->m21)),
      RI_8 = ksl_product_sum((double)Ji->Izx, (double)D->m20, ksl_product_sum((double)Ji->Iyz,
          (double)D->m21, (double)Ji->Izz * (double)D->m22));
  const double Jo_1f = ksl_product_sum((double)Ji->mt.z, (double)D->m02,
      ksl_product_sum((double)Ji->mt.y, (double)D->m01, (double)Ji->mt.x * (double)D->m00)),
      Jo_1 = ksl_product_sum((double)Ji->m, (double)D->m03, Jo_1f);
  const double Jo_2f = ksl_product_sum((double)Ji->mt.z, (double)D->m12,
      ksl_product_sum((double)Ji->mt.y, (double)D->m11, (double)Ji->mt.x * (double)D->m10)),
      Jo_2 = ksl_product_sum((double)Ji->m, (double)D->m13, Jo_2f);
  const double Jo_3f = ksl_product_sum((double)Ji->mt.z, (double)D->m22,
      ksl_product_sum((double)Ji->mt.y, (double)D->m21, (double)Ji->mt.x * (double)D->m20)),
      Jo_3 = ksl_product_sum((double)Ji->m, (double)D->m23, Jo_3f);
  const double Jo_4 = KSL_MUL((double)D->m00, RI_0) + KSL_MUL((double)D->m01, RI_1)
          + KSL_MUL((double)D->m02, RI_2),
      Jo_5 = KSL_MUL((double)D->m10, RI_3) + KSL_MUL((double)D->m11, RI_4)
          + KSL_MUL((double)D->m12, RI_5),
      Jo_6 = KSL_MUL((double)D->m20, RI_6) + KSL_MUL((double)D->m21, RI_7)
          + KSL_MUL((double)D->m22, RI_8),
      Jo_7 = KSL_MUL((double)D->m10, RI_0) + KSL_MUL((double)D->m11, RI_1)
          + KSL_MUL((double)D->m12, RI_2),
      Jo_8 = KSL_MUL((double)D->m20, RI_3) + KSL_MUL((double)D->m21, RI_4)
          + KSL_MUL((double)D->m22, RI_5),
      Jo_9 = KSL_MUL((double)D->m20, RI_0) + KSL_MUL((double)D->m21, RI_1)
          + KSL_MUL((double)D->m22, RI_2);
  const float Ji_m = Ji->m;
  Jo->m = Ji_m;
  Jo->mt.x = (float)Jo_1;
  Jo->mt.y = (float)Jo_2;
  Jo->mt.z = (float)Jo_3;
  Jo->Ixx = (float)Jo_4;
  Jo->Iyy = (float)Jo_5;
  Jo->Izz = (float)Jo_6;
  Jo->Ixy = (float)Jo_7;
  Jo->Iyz = (float)Jo_8;
  Jo->Izx = (float)Jo_9;
}

/* self = self displaced by D = [R | t]: m, R mt + m t, R I R^T.
   self: inertia (m in kg; mt = m c in kg m; I about the centre of mass c, xx, yy, zz, xy, yz, zx
     in kg m^2); D: displacement [R | t], R rotation, t in m.
   57 mul, 39 add.
   Error <= u |result| + (m: 0, mt: 1/8, I: 3/16) u^2 S, S the sum of the |terms| of the expanded
     formula; barring over- and underflow. */
static inline void ksl_inertiaf_transform_accurate(ksl_inertiaf_t *self, const ksl_SE3f_t *D) {
  const double RI_0 = ksl_product_sum((double)self->Izx, (double)D->m02,
      ksl_product_sum((double)self->Ixy, (double)D->m01, (double)self->Ixx * (double)D->m00)),
      RI_1 = ksl_product_sum((double)self->Iyz, (double)D->m02, ksl_product_sum((double)self->Ixy,
          (double)D->m00, (double)self->Iyy * (double)D->m01)),
      RI_2 = ksl_product_sum((double)self->Izx, (double)D->m00, ksl_product_sum((double)self->Iyz,
          (double)D->m01, (double)self->Izz * (double)D->m02)),
      RI_3 = ksl_product_sum((double)self->Izx, (double)D->m12, ksl_product_sum((double)self->Ixy,
          (double)D->m11, (double)self->Ixx * (double)D->m10)),
      RI_4 = ksl_product_sum((double)self->Iyz, (double)D->m12, ksl_product_sum((double)self->Ixy,
          (double)D->m10, (double)self->Iyy * (double)D->m11)),
      RI_5 = ksl_product_sum((double)self->Izx, (double)D->m10, ksl_product_sum((double)self->Iyz,
          (double)D->m11, (double)self->Izz * (double)D->m12)),
      RI_6 = ksl_product_sum((double)self->Izx, (double)D->m22, ksl_product_sum((double)self->Ixy,
          (double)D->m21, (double)self->Ixx * (double)D->m20)),
      RI_7 = ksl_product_sum((double)self->Iyz, (double)D->m22, ksl_product_sum((double)self->Ixy,
          (double)D->m20, (double)self->Iyy * (double)D->m21)),
      RI_8 = ksl_product_sum((double)self->Izx, (double)D->m20, ksl_product_sum((double)self->Iyz,
          (double)D->m21, (double)self->Izz * (double)D->m22));
  const double self_1_new_d = ksl_product_sum((double)self->mt.y, (double)D->m01, (double)self->mt.x
      * (double)D->m00),
      self_1_new = ksl_product_sum((double)self->m, (double)D->m03,
          ksl_product_sum((double)self->mt.z, (double)D->m02, self_1_new_d));
  const double self_2_new_d = ksl_product_sum((double)self->mt.y, (double)D->m11, (double)self->mt.x
      * (double)D->m10),
      self_2_new = ksl_product_sum((double)self->m, (double)D->m13,
          ksl_product_sum((double)self->mt.z, (double)D->m12, self_2_new_d));
  const double self_3_new_d = ksl_product_sum((double)self->mt.y, (double)D->m21, (double)self->mt.x
      * (double)D->m20),
      self_3_new = ksl_product_sum((double)self->m, (double)D->m23,
          ksl_product_sum((double)self->mt.z, (double)D->m22, self_3_new_d));
  const double self_4_new = KSL_MUL((double)D->m00, RI_0) + KSL_MUL((double)D->m01, RI_1)
          + KSL_MUL((double)D->m02, RI_2),
      self_5_new = KSL_MUL((double)D->m10, RI_3) + KSL_MUL((double)D->m11, RI_4)
          + KSL_MUL((double)D->m12, RI_5),
      self_6_new = KSL_MUL((double)D->m20, RI_6) + KSL_MUL((double)D->m21, RI_7)
          + KSL_MUL((double)D->m22, RI_8),
      self_7_new = KSL_MUL((double)D->m10, RI_0) + KSL_MUL((double)D->m11, RI_1)
          + KSL_MUL((double)D->m12, RI_2),
      self_8_new = KSL_MUL((double)D->m20, RI_3) + KSL_MUL((double)D->m21, RI_4)
          + KSL_MUL((double)D->m22, RI_5),
      self_9_new = KSL_MUL((double)D->m20, RI_0) + KSL_MUL((double)D->m21, RI_1)
          + KSL_MUL((double)D->m22, RI_2);
  self->mt.x = (float)self_1_new;
  self->mt.y = (float)self_2_new;
  self->mt.z = (float)self_3_new;
  self->Ixx = (float)self_4_new;
  self->Iyy = (float)self_5_new;
  self->Izz = (float)self_6_new;
  self->Ixy = (float)self_7_new;
  self->Iyz = (float)self_8_new;
  self->Izx = (float)self_9_new;
}

/* Ji = the inertia of two joined bodies: Ji, and Jj displaced by D_ij = [R | t]: m_i + m_j, mt_i
     + m_j c, I_i + R I_j R^T + m_i m_j/(m_i + m_j) (d·d 1 - d d^T) with c = R t_jc + t, d = c -
     t_ic; t_ic = mt_i / m_i and t_jc = mt_j / m_j are the centres of mass, each in its own
     frame; NaN where m_i + m_j = 0.
   Ji, Jj: inertia (m in kg; mt = m c in kg m; I about the centre of mass c, xx, yy, zz, xy, yz,
     zx in kg m^2); t_ic, t_jc: vector; D_ij: displacement [R | t], R rotation, t in m.
   67 mul, 61 add, 1 div.
   Error <= 18 u times the sum of the absolute values of all terms, for masses that are not
     negative, barring over- and underflow. */
static inline void ksl_inertiaf_merge_accurate(ksl_inertiaf_t *Ji, const ksl_vec3f_t *t_ic,
    const ksl_inertiaf_t *Jj, const ksl_vec3f_t *t_jc, const ksl_SE3f_t *D_ij) {
  const double m = (double)Ji->m + (double)Jj->m;
  const double c_0e = ksl_product_sum((double)t_jc->z, (double)D_ij->m02,
      ksl_product_sum((double)t_jc->y, (double)D_ij->m01, (double)t_jc->x * (double)D_ij->m00)),
      c_0 = c_0e + (double)D_ij->m03;
  const double c_1e = ksl_product_sum((double)t_jc->z, (double)D_ij->m12,
      ksl_product_sum((double)t_jc->y, (double)D_ij->m11, (double)t_jc->x * (double)D_ij->m10)),
      c_1 = c_1e + (double)D_ij->m13;
  const double c_2e = ksl_product_sum((double)t_jc->z, (double)D_ij->m22,
      ksl_product_sum((double)t_jc->y, (double)D_ij->m21, (double)t_jc->x * (double)D_ij->m20)),
      c_2 = c_2e + (double)D_ij->m23;
  const double d_0 = c_0 - (double)t_ic->x, d_1 = c_1 - (double)t_ic->y,
      d_2 = c_2 - (double)t_ic->z;
  const double part = (double)Jj->m / m;
  const double reduced = KSL_MUL((double)Ji->m, part);
  const double p_0 = KSL_MUL(d_0, reduced), p_1 = KSL_MUL(d_1, reduced),
      p_2 = KSL_MUL(d_2, reduced);
  const double squares_0 = KSL_MUL(d_0, p_0), squares_1 = KSL_MUL(d_1, p_1),
      squares_2 = KSL_MUL(d_2, p_2);
  const double RI_0 = ksl_product_sum((double)Jj->Izx, (double)D_ij->m02,
      ksl_product_sum((double)Jj->Ixy, (double)D_ij->m01, (double)Jj->Ixx * (double)D_ij->m00)),
      RI_1 = ksl_product_sum((double)Jj->Iyz, (double)D_ij->m02, ksl_product_sum((double)Jj->Ixy,
          (double)D_ij->m00, (double)Jj->Iyy * (double)D_ij->m01)),
      RI_2 = ksl_product_sum((double)Jj->Izx, (double)D_ij->m00, ksl_product_sum((double)Jj->Iyz,
          (double)D_ij->m01, (double)Jj->Izz * (double)D_ij->m02)),
      RI_3 = ksl_product_sum((double)Jj->Izx, (double)D_ij->m12, ksl_product_sum((double)Jj->Ixy,
          (double)D_ij->m11, (double)Jj->Ixx * (double)D_ij->m10)),
      RI_4 = ksl_product_sum((double)Jj->Iyz, (double)D_ij->m12, ksl_product_sum((double)Jj->Ixy,
          (double)D_ij->m10, (double)Jj->Iyy * (double)D_ij->m11)),
      RI_5 = ksl_product_sum((double)Jj->Izx, (double)D_ij->m10, ksl_product_sum((double)Jj->Iyz,
          (double)D_ij->m11, (double)Jj->Izz * (double)D_ij->m12)),
      RI_6 = ksl_product_sum((double)Jj->Izx, (double)D_ij->m22, ksl_product_sum((double)Jj->Ixy,
          (double)D_ij->m21, (double)Jj->Ixx * (double)D_ij->m20)),
      RI_7 = ksl_product_sum((double)Jj->Iyz, (double)D_ij->m22, ksl_product_sum((double)Jj->Ixy,
          (double)D_ij->m20, (double)Jj->Iyy * (double)D_ij->m21)),
      RI_8 = ksl_product_sum((double)Jj->Izx, (double)D_ij->m20, ksl_product_sum((double)Jj->Iyz,
          (double)D_ij->m21, (double)Jj->Izz * (double)D_ij->m22));
  const double Ji_1_new = (double)Ji->mt.x + KSL_MUL((double)Jj->m, c_0),
      Ji_2_new = (double)Ji->mt.y + KSL_MUL((double)Jj->m, c_1),
      Ji_3_new = (double)Ji->mt.z + KSL_MUL((double)Jj->m, c_2);
  const double Ji_4_new_f = (double)Ji->Ixx
          + (KSL_MUL((double)D_ij->m00, RI_0) + KSL_MUL((double)D_ij->m01, RI_1)
          + KSL_MUL((double)D_ij->m02, RI_2)), Ji_4_new = Ji_4_new_f + (squares_1 + squares_2);
  const double Ji_5_new_f = (double)Ji->Iyy
          + (KSL_MUL((double)D_ij->m10, RI_3) + KSL_MUL((double)D_ij->m11, RI_4)
          + KSL_MUL((double)D_ij->m12, RI_5)), Ji_5_new = Ji_5_new_f + (squares_0 + squares_2);
  const double Ji_6_new_f = (double)Ji->Izz
          + (KSL_MUL((double)D_ij->m20, RI_6) + KSL_MUL((double)D_ij->m21, RI_7)
          + KSL_MUL((double)D_ij->m22, RI_8)), Ji_6_new = Ji_6_new_f + (squares_0 + squares_1);
  const double Ji_7_new_f = (double)Ji->Ixy
          + (KSL_MUL((double)D_ij->m10, RI_0) + KSL_MUL((double)D_ij->m11, RI_1)
          + KSL_MUL((double)D_ij->m12, RI_2)), Ji_7_new = Ji_7_new_f - KSL_MUL(d_1, p_0);
  const double Ji_8_new_f = (double)Ji->Iyz
          + (KSL_MUL((double)D_ij->m20, RI_3) + KSL_MUL((double)D_ij->m21, RI_4)
          + KSL_MUL((double)D_ij->m22, RI_5)), Ji_8_new = Ji_8_new_f - KSL_MUL(d_2, p_1);
  const double Ji_9_new_f = (double)Ji->Izx
          + (KSL_MUL((double)D_ij->m20, RI_0) + KSL_MUL((double)D_ij->m21, RI_1)
          + KSL_MUL((double)D_ij->m22, RI_2)), Ji_9_new = Ji_9_new_f - KSL_MUL(d_2, p_0);
  Ji->m = (float)m;
  Ji->mt.x = (float)Ji_1_new;
  Ji->mt.y = (float)Ji_2_new;
  Ji->mt.z = (float)Ji_3_new;
  Ji->Ixx = (float)Ji_4_new;
  Ji->Iyy = (float)Ji_5_new;
  Ji->Izz = (float)Ji_6_new;
  Ji->Ixy = (float)Ji_7_new;
  Ji->Iyz = (float)Ji_8_new;
  Ji->Izx = (float)Ji_9_new;
}

#endif
