/* Made by `coscrew generate`; changes are overwritten. */
/* SPDX-License-Identifier: MIT */
/* coscrew 0.2.0.  Copyright (c) 2026 The coscrew authors. */
/* Inertias of rigid bodies: mass, mass times centre of mass, moments about the centre of mass.
   Certified tier: plain results, and bounds on their errors that always hold. */
#ifndef KSL_INERTIA_CERTIFIED_H
#define KSL_INERTIA_CERTIFIED_H

#include "ksl_types.h"

/* J = (m; m t; Ixx, Iyy, Izz, Ixy, Iyz, Izx): mass, centre of mass t in m, entries of the
     moments' matrix about it in kg m^2, Ixy = -∫ x y dm; |error of J| <= J_bound unless inf or
     NaN.
   m, Ixx, Iyy, Izz, Ixy, Iyz, Izx: number; t: vector; J_bound: inertia (m in kg; mt = m c in kg
     m; I about the centre of mass c, xx, yy, zz, xy, yz, zx in kg m^2).
   6 mul, 3 add, 3 abs. */
static inline ksl_inertia_t ksl_inertia_certified(const double m, const ksl_vec3_t t,
    const double Ixx, const double Iyy, const double Izz, const double Ixy,
    const double Iyz, const double Izx, ksl_inertia_t *J_bound) {
  const double J_1 = KSL_MUL(m, t.x), J_2 = KSL_MUL(m, t.y), J_3 = KSL_MUL(m, t.z);
  const double J_1_bound = KSL_MUL(1.1102230246251568e-16, fabs(J_1) + 2.004168360008973e-292),
      J_2_bound = KSL_MUL(1.1102230246251568e-16, fabs(J_2) + 2.004168360008973e-292),
      J_3_bound = KSL_MUL(1.1102230246251568e-16, fabs(J_3) + 2.004168360008973e-292);
  ksl_inertia_t J;
  J.m = m;
  J.mt.x = J_1;
  J.mt.y = J_2;
  J.mt.z = J_3;
  J.Ixx = Ixx;
  J.Iyy = Iyy;
  J.Izz = Izz;
  J.Ixy = Ixy;
  J.Iyz = Iyz;
  J.Izx = Izx;
  J_bound->m = 0.0;
  J_bound->mt.x = J_1_bound;
  J_bound->mt.y = J_2_bound;
  J_bound->mt.z = J_3_bound;
  J_bound->Ixx = 0.0;
  J_bound->Iyy = 0.0;
  J_bound->Izz = 0.0;
  J_bound->Ixy = 0.0;
  J_bound->Iyz = 0.0;
  J_bound->Izx = 0.0;
  return J;
}

/* Jo = Ji rotated by R: m, R mt, R I R^T; |error of Jo| <= Jo_bound unless inf or NaN.
   Ji, Jo, Jo_bound: inertia (m in kg; mt = m c in kg m; I about the centre of mass c, xx, yy,
     zz, xy, yz, zx in kg m^2); R: rotation or other 3×3 matrix.
   81 mul, 90 add, 45 abs. */
static inline void ksl_inertia_rotated_certified(const ksl_inertia_t *Ji, const ksl_mat3x3_t *R,
    ksl_inertia_t *Jo, ksl_inertia_t *Jo_bound) {
  const double RI_0a = KSL_MUL(Ji->Ixx, R->m00), RI_0b = KSL_MUL(Ji->Ixy, R->m01),
      RI_0d = KSL_MUL(Ji->Izx, R->m02), RI_0 = RI_0a + RI_0b + RI_0d;
  const double RI_1a = KSL_MUL(Ji->Iyy, R->m01), RI_1b = KSL_MUL(Ji->Ixy, R->m00),
      RI_1d = KSL_MUL(Ji->Iyz, R->m02), RI_1 = RI_1a + RI_1b + RI_1d;
  const double RI_2a = KSL_MUL(Ji->Izz, R->m02), RI_2b = KSL_MUL(Ji->Iyz, R->m01),
      RI_2d = KSL_MUL(Ji->Izx, R->m00), RI_2 = RI_2a + RI_2b + RI_2d;
  const double RI_3a = KSL_MUL(Ji->Ixx, R->m10), RI_3b = KSL_MUL(Ji->Ixy, R->m11),
      RI_3d = KSL_MUL(Ji->Izx, R->m12), RI_3 = RI_3a + RI_3b + RI_3d;
  const double RI_4a = KSL_MUL(Ji->Iyy, R->m11), RI_4b = KSL_MUL(Ji->Ixy, R->m10),
      RI_4d = KSL_MUL(Ji->Iyz, R->m12), RI_4 = RI_4a + RI_4b + RI_4d;
  const double RI_5a = KSL_MUL(Ji->Izz, R->m12), RI_5b = KSL_MUL(Ji->Iyz, R->m11),
      RI_5d = KSL_MUL(Ji->Izx, R->m10), RI_5 = RI_5a + RI_5b + RI_5d;
  const double RI_6a = KSL_MUL(Ji->Ixx, R->m20), RI_6b = KSL_MUL(Ji->Ixy, R->m21),
      RI_6d = KSL_MUL(Ji->Izx, R->m22), RI_6 = RI_6a + RI_6b + RI_6d;
  const double RI_7a = KSL_MUL(Ji->Iyy, R->m21), RI_7b = KSL_MUL(Ji->Ixy, R->m20),
      RI_7d = KSL_MUL(Ji->Iyz, R->m22), RI_7 = RI_7a + RI_7b + RI_7d;
  const double RI_8a = KSL_MUL(Ji->Izz, R->m22), RI_8b = KSL_MUL(Ji->Iyz, R->m21),
      RI_8d = KSL_MUL(Ji->Izx, R->m20), RI_8 = RI_8a + RI_8b + RI_8d;
  const double Jo_1a = KSL_MUL(Ji->mt.x, R->m00), Jo_1b = KSL_MUL(Ji->mt.y, R->m01),
      Jo_1d = KSL_MUL(Ji->mt.z, R->m02), Jo_1 = Jo_1a + Jo_1b + Jo_1d;
  const double Jo_2a = KSL_MUL(Ji->mt.x, R->m10), Jo_2b = KSL_MUL(Ji->mt.y, R->m11),
      Jo_2d = KSL_MUL(Ji->mt.z, R->m12), Jo_2 = Jo_2a + Jo_2b + Jo_2d;
  const double Jo_3a = KSL_MUL(Ji->mt.x, R->m20), Jo_3b = KSL_MUL(Ji->mt.y, R->m21),
      Jo_3d = KSL_MUL(Ji->mt.z, R->m22), Jo_3 = Jo_3a + Jo_3b + Jo_3d;
  const double Jo_4 = KSL_MUL(R->m00, RI_0) + KSL_MUL(R->m01, RI_1) + KSL_MUL(R->m02, RI_2);
  const double Jo_5 = KSL_MUL(R->m10, RI_3) + KSL_MUL(R->m11, RI_4) + KSL_MUL(R->m12, RI_5);
  const double Jo_6 = KSL_MUL(R->m20, RI_6) + KSL_MUL(R->m21, RI_7) + KSL_MUL(R->m22, RI_8),
      Jo_7 = KSL_MUL(R->m10, RI_0) + KSL_MUL(R->m11, RI_1) + KSL_MUL(R->m12, RI_2),
      Jo_8 = KSL_MUL(R->m20, RI_3) + KSL_MUL(R->m21, RI_4) + KSL_MUL(R->m22, RI_5),
      Jo_9 = KSL_MUL(R->m20, RI_0) + KSL_MUL(R->m21, RI_1) + KSL_MUL(R->m22, RI_2);
  const double RI_0_size = fabs(RI_0a) + fabs(RI_0b) + fabs(RI_0d),
      RI_1_size = fabs(RI_1a) + fabs(RI_1b) + fabs(RI_1d),
      RI_2_size = fabs(RI_2a) + fabs(RI_2b) + fabs(RI_2d),
      RI_3_size = fabs(RI_3a) + fabs(RI_3b) + fabs(RI_3d),
      RI_4_size = fabs(RI_4a) + fabs(RI_4b) + fabs(RI_4d),
      RI_5_size = fabs(RI_5a) + fabs(RI_5b) + fabs(RI_5d),
      RI_6_size = fabs(RI_6a) + fabs(RI_6b) + fabs(RI_6d),
      RI_7_size = fabs(RI_7a) + fabs(RI_7b) + fabs(RI_7d),
      RI_8_size = fabs(RI_8a) + fabs(RI_8b) + fabs(RI_8d);
  const double Jo_1_size = fabs(Jo_1a) + fabs(Jo_1b) + fabs(Jo_1d),
      Jo_2_size = fabs(Jo_2a) + fabs(Jo_2b) + fabs(Jo_2d),
      Jo_3_size = fabs(Jo_3a) + fabs(Jo_3b) + fabs(Jo_3d);
  const double RI_0_padded = RI_0_size + 2.004168360008973e-292,
      RI_1_padded = RI_1_size + 2.004168360008973e-292,
      RI_2_padded = RI_2_size + 2.004168360008973e-292;
  const double Jo_4_size = KSL_MUL(fabs(R->m00), RI_0_padded) + KSL_MUL(fabs(R->m01), RI_1_padded)
          + KSL_MUL(fabs(R->m02), RI_2_padded);
  const double RI_3_padded = RI_3_size + 2.004168360008973e-292;
  const double R_10_abs = fabs(R->m10);
  const double RI_4_padded = RI_4_size + 2.004168360008973e-292;
  const double R_11_abs = fabs(R->m11);
  const double RI_5_padded = RI_5_size + 2.004168360008973e-292;
  const double R_12_abs = fabs(R->m12),
      Jo_5_size = KSL_MUL(R_10_abs, RI_3_padded) + KSL_MUL(R_11_abs, RI_4_padded)
          + KSL_MUL(R_12_abs, RI_5_padded);
  const double R_20_abs = fabs(R->m20), R_21_abs = fabs(R->m21), R_22_abs = fabs(R->m22),
      Jo_6c_size = KSL_MUL(R_20_abs, RI_6_size + 2.004168360008973e-292)
          + KSL_MUL(R_21_abs, RI_7_size + 2.004168360008973e-292),
      Jo_6_size = Jo_6c_size + KSL_MUL(R_22_abs, RI_8_size + 2.004168360008973e-292);
  const double Jo_7_size = KSL_MUL(R_10_abs, RI_0_padded) + KSL_MUL(R_11_abs, RI_1_padded)
          + KSL_MUL(R_12_abs, RI_2_padded),
      Jo_8_size = KSL_MUL(R_20_abs, RI_3_padded) + KSL_MUL(R_21_abs, RI_4_padded)
          + KSL_MUL(R_22_abs, RI_5_padded),
      Jo_9_size = KSL_MUL(R_20_abs, RI_0_padded) + KSL_MUL(R_21_abs, RI_1_padded)
          + KSL_MUL(R_22_abs, RI_2_padded);
  const double Jo_1_bound = KSL_MUL(3.3306690738754706e-16, Jo_1_size + 2.004168360008973e-292),
      Jo_2_bound = KSL_MUL(3.3306690738754706e-16, Jo_2_size + 2.004168360008973e-292),
      Jo_3_bound = KSL_MUL(3.3306690738754706e-16, Jo_3_size + 2.004168360008973e-292),
      Jo_4_bound = KSL_MUL(6.661338147750942e-16, Jo_4_size + 2.004168360008973e-292),
      Jo_5_bound = KSL_MUL(6.661338147750942e-16, Jo_5_size + 2.004168360008973e-292),
      Jo_6_bound = KSL_MUL(6.661338147750942e-16, Jo_6_size + 2.004168360008973e-292),
      Jo_7_bound = KSL_MUL(6.661338147750942e-16, Jo_7_size + 2.004168360008973e-292),
      Jo_8_bound = KSL_MUL(6.661338147750942e-16, Jo_8_size + 2.004168360008973e-292),
      Jo_9_bound = KSL_MUL(6.661338147750942e-16, Jo_9_size + 2.004168360008973e-292);
  const double Ji_m = Ji->m;
  Jo->m = Ji_m;
  Jo->mt.x = Jo_1;
  Jo->mt.y = Jo_2;
  Jo->mt.z = Jo_3;
  Jo->Ixx = Jo_4;
  Jo->Iyy = Jo_5;
  Jo->Izz = Jo_6;
  Jo->Ixy = Jo_7;
  Jo->Iyz = Jo_8;
  Jo->Izx = Jo_9;
  Jo_bound->m = 0.0;
  Jo_bound->mt.x = Jo_1_bound;
  Jo_bound->mt.y = Jo_2_bound;
  Jo_bound->mt.z = Jo_3_bound;
  Jo_bound->Ixx = Jo_4_bound;
  Jo_bound->Iyy = Jo_5_bound;
  Jo_bound->Izz = Jo_6_bound;
  Jo_bound->Ixy = Jo_7_bound;
  Jo_bound->Iyz = Jo_8_bound;
  Jo_bound->Izx = Jo_9_bound;
}

/* self = self rotated by R: m, R mt, R I R^T; |error of self| <= self_bound unless inf or NaN.
   self, self_bound: inertia (m in kg; mt = m c in kg m; I about the centre of mass c, xx, yy,
     zz, xy, yz, zx in kg m^2); R: rotation or other 3×3 matrix.
   81 mul, 90 add, 45 abs. */
static inline void ksl_inertia_rotate_certified(ksl_inertia_t *self, const ksl_mat3x3_t *R,
    ksl_inertia_t *self_bound) {
  const double RI_0a = KSL_MUL(self->Ixx, R->m00), RI_0b = KSL_MUL(self->Ixy, R->m01),
      RI_0d = KSL_MUL(self->Izx, R->m02), RI_0 = RI_0a + RI_0b + RI_0d;
  const double RI_1a = KSL_MUL(self->Iyy, R->m01), RI_1b = KSL_MUL(self->Ixy, R->m00),
      RI_1d = KSL_MUL(self->Iyz, R->m02), RI_1 = RI_1a + RI_1b + RI_1d;
  const double RI_2a = KSL_MUL(self->Izz, R->m02), RI_2b = KSL_MUL(self->Iyz, R->m01),
      RI_2d = KSL_MUL(self->Izx, R->m00), RI_2 = RI_2a + RI_2b + RI_2d;
  const double RI_3a = KSL_MUL(self->Ixx, R->m10), RI_3b = KSL_MUL(self->Ixy, R->m11),
      RI_3d = KSL_MUL(self->Izx, R->m12), RI_3 = RI_3a + RI_3b + RI_3d;
  const double RI_4a = KSL_MUL(self->Iyy, R->m11), RI_4b = KSL_MUL(self->Ixy, R->m10),
      RI_4d = KSL_MUL(self->Iyz, R->m12), RI_4 = RI_4a + RI_4b + RI_4d;
  const double RI_5a = KSL_MUL(self->Izz, R->m12), RI_5b = KSL_MUL(self->Iyz, R->m11),
      RI_5d = KSL_MUL(self->Izx, R->m10), RI_5 = RI_5a + RI_5b + RI_5d;
  const double RI_6a = KSL_MUL(self->Ixx, R->m20), RI_6b = KSL_MUL(self->Ixy, R->m21),
      RI_6d = KSL_MUL(self->Izx, R->m22), RI_6 = RI_6a + RI_6b + RI_6d;
  const double RI_7a = KSL_MUL(self->Iyy, R->m21), RI_7b = KSL_MUL(self->Ixy, R->m20),
      RI_7d = KSL_MUL(self->Iyz, R->m22), RI_7 = RI_7a + RI_7b + RI_7d;
  const double RI_8a = KSL_MUL(self->Izz, R->m22), RI_8b = KSL_MUL(self->Iyz, R->m21),
      RI_8d = KSL_MUL(self->Izx, R->m20), RI_8 = RI_8a + RI_8b + RI_8d;
  const double self_1_new_a = KSL_MUL(self->mt.x, R->m00),
      self_1_new_b = KSL_MUL(self->mt.y, R->m01), self_1_new_d = KSL_MUL(self->mt.z, R->m02),
      self_1_new = self_1_new_a + self_1_new_b + self_1_new_d;
  const double self_2_new_a = KSL_MUL(self->mt.x, R->m10),
      self_2_new_b = KSL_MUL(self->mt.y, R->m11), self_2_new_d = KSL_MUL(self->mt.z, R->m12),
      self_2_new = self_2_new_a + self_2_new_b + self_2_new_d;
  const double self_3_new_a = KSL_MUL(self->mt.x, R->m20),
      self_3_new_b = KSL_MUL(self->mt.y, R->m21), self_3_new_d = KSL_MUL(self->mt.z, R->m22),
      self_3_new = self_3_new_a + self_3_new_b + self_3_new_d;
  const double self_4_new = KSL_MUL(R->m00, RI_0) + KSL_MUL(R->m01, RI_1) + KSL_MUL(R->m02, RI_2);
  const double self_5_new = KSL_MUL(R->m10, RI_3) + KSL_MUL(R->m11, RI_4) + KSL_MUL(R->m12, RI_5);
  const double self_6_new = KSL_MUL(R->m20, RI_6) + KSL_MUL(R->m21, RI_7) + KSL_MUL(R->m22, RI_8),
      self_7_new = KSL_MUL(R->m10, RI_0) + KSL_MUL(R->m11, RI_1) + KSL_MUL(R->m12, RI_2),
      self_8_new = KSL_MUL(R->m20, RI_3) + KSL_MUL(R->m21, RI_4) + KSL_MUL(R->m22, RI_5),
      self_9_new = KSL_MUL(R->m20, RI_0) + KSL_MUL(R->m21, RI_1) + KSL_MUL(R->m22, RI_2);
  const double RI_0_size = fabs(RI_0a) + fabs(RI_0b) + fabs(RI_0d),
      RI_1_size = fabs(RI_1a) + fabs(RI_1b) + fabs(RI_1d),
      RI_2_size = fabs(RI_2a) + fabs(RI_2b) + fabs(RI_2d),
      RI_3_size = fabs(RI_3a) + fabs(RI_3b) + fabs(RI_3d),
      RI_4_size = fabs(RI_4a) + fabs(RI_4b) + fabs(RI_4d),
      RI_5_size = fabs(RI_5a) + fabs(RI_5b) + fabs(RI_5d),
      RI_6_size = fabs(RI_6a) + fabs(RI_6b) + fabs(RI_6d),
      RI_7_size = fabs(RI_7a) + fabs(RI_7b) + fabs(RI_7d),
      RI_8_size = fabs(RI_8a) + fabs(RI_8b) + fabs(RI_8d);
  const double self_1_new_size = fabs(self_1_new_a) + fabs(self_1_new_b) + fabs(self_1_new_d),
      self_2_new_size = fabs(self_2_new_a) + fabs(self_2_new_b) + fabs(self_2_new_d),
      self_3_new_size = fabs(self_3_new_a) + fabs(self_3_new_b) + fabs(self_3_new_d);
  const double RI_0_padded = RI_0_size + 2.004168360008973e-292,
      RI_1_padded = RI_1_size + 2.004168360008973e-292,
      RI_2_padded = RI_2_size + 2.004168360008973e-292;
  const double self_4_new_size = KSL_MUL(fabs(R->m00), RI_0_padded)
          + KSL_MUL(fabs(R->m01), RI_1_padded) + KSL_MUL(fabs(R->m02), RI_2_padded);
  const double RI_3_padded = RI_3_size + 2.004168360008973e-292;
  const double R_10_abs = fabs(R->m10);
  const double RI_4_padded = RI_4_size + 2.004168360008973e-292;
  const double R_11_abs = fabs(R->m11);
  const double RI_5_padded = RI_5_size + 2.004168360008973e-292;
  const double R_12_abs = fabs(R->m12),
      self_5_new_size = KSL_MUL(R_10_abs, RI_3_padded) + KSL_MUL(R_11_abs, RI_4_padded)
          + KSL_MUL(R_12_abs, RI_5_padded);
  const double R_20_abs = fabs(R->m20), R_21_abs = fabs(R->m21), R_22_abs = fabs(R->m22),
      self_6_new_c_size = KSL_MUL(R_20_abs, RI_6_size + 2.004168360008973e-292)
          + KSL_MUL(R_21_abs, RI_7_size + 2.004168360008973e-292),
      self_6_new_size = self_6_new_c_size + KSL_MUL(R_22_abs, RI_8_size + 2.004168360008973e-292);
  const double self_7_new_size = KSL_MUL(R_10_abs, RI_0_padded) + KSL_MUL(R_11_abs, RI_1_padded)
          + KSL_MUL(R_12_abs, RI_2_padded),
      self_8_new_size = KSL_MUL(R_20_abs, RI_3_padded) + KSL_MUL(R_21_abs, RI_4_padded)
          + KSL_MUL(R_22_abs, RI_5_padded),
      self_9_new_size = KSL_MUL(R_20_abs, RI_0_padded) + KSL_MUL(R_21_abs, RI_1_padded)
          + KSL_MUL(R_22_abs, RI_2_padded);
  const double self_1_new_bound = KSL_MUL(3.3306690738754706e-16, self_1_new_size
          + 2.004168360008973e-292),
      self_2_new_bound = KSL_MUL(3.3306690738754706e-16, self_2_new_size + 2.004168360008973e-292),
      self_3_new_bound = KSL_MUL(3.3306690738754706e-16, self_3_new_size + 2.004168360008973e-292),
      self_4_new_bound = KSL_MUL(6.661338147750942e-16, self_4_new_size + 2.004168360008973e-292),
      self_5_new_bound = KSL_MUL(6.661338147750942e-16, self_5_new_size + 2.004168360008973e-292),
      self_6_new_bound = KSL_MUL(6.661338147750942e-16, self_6_new_size + 2.004168360008973e-292),
      self_7_new_bound = KSL_MUL(6.661338147750942e-16, self_7_new_size + 2.004168360008973e-292),
      self_8_new_bound = KSL_MUL(6.661338147750942e-16, self_8_new_size + 2.004168360008973e-292),
      self_9_new_bound = KSL_MUL(6.661338147750942e-16, self_9_new_size + 2.004168360008973e-292);
  self->mt.x = self_1_new;
  self->mt.y = self_2_new;
  self->mt.z = self_3_new;
  self->Ixx = self_4_new;
  self->Iyy = self_5_new;
  self->Izz = self_6_new;
  self->Ixy = self_7_new;
  self->Iyz = self_8_new;
  self->Izx = self_9_new;
  self_bound->m = 0.0;
  self_bound->mt.x = self_1_new_bound;
  self_bound->mt.y = self_2_new_bound;
  self_bound->mt.z = self_3_new_bound;
  self_bound->Ixx = self_4_new_bound;
  self_bound->Iyy = self_5_new_bound;
  self_bound->Izz = self_6_new_bound;
  self_bound->Ixy = self_7_new_bound;
  self_bound->Iyz = self_8_new_bound;
  self_bound->Izx = self_9_new_bound;
}

/* Jo = Ji translated by t: m, mt + m t, I; |error of Jo| <= Jo_bound unless inf or NaN.
   Ji, Jo, Jo_bound: inertia (m in kg; mt = m c in kg m; I about the centre of mass c, xx, yy,
     zz, xy, yz, zx in kg m^2); t: vector.
   6 mul, 9 add, 6 abs. */
static inline void ksl_inertia_translated_certified(const ksl_inertia_t *Ji, const ksl_vec3_t *t,
    ksl_inertia_t *Jo, ksl_inertia_t *Jo_bound) {
  const double Jo_1a = KSL_MUL(Ji->m, t->x), Jo_1 = Jo_1a + Ji->mt.x;
  const double Jo_2a = KSL_MUL(Ji->m, t->y), Jo_2 = Jo_2a + Ji->mt.y;
  const double Jo_3a = KSL_MUL(Ji->m, t->z), Jo_3 = Jo_3a + Ji->mt.z;
  const double Jo_1_size = fabs(Jo_1a) + fabs(Ji->mt.x), Jo_2_size = fabs(Jo_2a) + fabs(Ji->mt.y),
      Jo_3_size = fabs(Jo_3a) + fabs(Ji->mt.z);
  const double Jo_1_bound = KSL_MUL(2.2204460492503136e-16, Jo_1_size + 2.004168360008973e-292),
      Jo_2_bound = KSL_MUL(2.2204460492503136e-16, Jo_2_size + 2.004168360008973e-292),
      Jo_3_bound = KSL_MUL(2.2204460492503136e-16, Jo_3_size + 2.004168360008973e-292);
  const double Ji_m = Ji->m;
  const double Ji_Ixx = Ji->Ixx;
  const double Ji_Iyy = Ji->Iyy;
  const double Ji_Izz = Ji->Izz;
  const double Ji_Ixy = Ji->Ixy;
  const double Ji_Iyz = Ji->Iyz;
  const double Ji_Izx = Ji->Izx;
  Jo->m = Ji_m;
  Jo->mt.x = Jo_1;
  Jo->mt.y = Jo_2;
  Jo->mt.z = Jo_3;
  Jo->Ixx = Ji_Ixx;
  Jo->Iyy = Ji_Iyy;
  Jo->Izz = Ji_Izz;
  Jo->Ixy = Ji_Ixy;
  Jo->Iyz = Ji_Iyz;
  Jo->Izx = Ji_Izx;
  Jo_bound->m = 0.0;
  Jo_bound->mt.x = Jo_1_bound;
  Jo_bound->mt.y = Jo_2_bound;
  Jo_bound->mt.z = Jo_3_bound;
  Jo_bound->Ixx = 0.0;
  Jo_bound->Iyy = 0.0;
  Jo_bound->Izz = 0.0;
  Jo_bound->Ixy = 0.0;
  Jo_bound->Iyz = 0.0;
  Jo_bound->Izx = 0.0;
}

/* self = self translated by t: m, mt + m t, I; |error of self| <= self_bound unless inf or NaN.
   self, self_bound: inertia (m in kg; mt = m c in kg m; I about the centre of mass c, xx, yy,
     zz, xy, yz, zx in kg m^2); t: vector.
   6 mul, 9 add, 6 abs. */
static inline void ksl_inertia_translate_certified(ksl_inertia_t *self, const ksl_vec3_t *t,
    ksl_inertia_t *self_bound) {
  const double self_1_new_a = KSL_MUL(self->m, t->x), self_1_new = self_1_new_a + self->mt.x;
  const double self_2_new_a = KSL_MUL(self->m, t->y), self_2_new = self_2_new_a + self->mt.y;
  const double self_3_new_a = KSL_MUL(self->m, t->z), self_3_new = self_3_new_a + self->mt.z;
  const double self_1_new_size = fabs(self_1_new_a) + fabs(self->mt.x),
      self_2_new_size = fabs(self_2_new_a) + fabs(self->mt.y),
      self_3_new_size = fabs(self_3_new_a) + fabs(self->mt.z);
  const double self_1_new_bound = KSL_MUL(2.2204460492503136e-16, self_1_new_size
          + 2.004168360008973e-292),
      self_2_new_bound = KSL_MUL(2.2204460492503136e-16, self_2_new_size + 2.004168360008973e-292),
      self_3_new_bound = KSL_MUL(2.2204460492503136e-16, self_3_new_size + 2.004168360008973e-292);
  self->mt.x = self_1_new;
  self->mt.y = self_2_new;
  self->mt.z = self_3_new;
  self_bound->m = 0.0;
  self_bound->mt.x = self_1_new_bound;
  self_bound->mt.y = self_2_new_bound;
  self_bound->mt.z = self_3_new_bound;
  self_bound->Ixx = 0.0;
  self_bound->Iyy = 0.0;
  self_bound->Izz = 0.0;
  self_bound->Ixy = 0.0;
  self_bound->Iyz = 0.0;
  self_bound->Izx = 0.0;
}

/* Jo = Ji displaced by D = [R | t]: m, R mt + m t, R I R^T; |error of Jo| <= Jo_bound unless inf
     or NaN.
   Ji, Jo, Jo_bound: inertia (m in kg; mt = m c in kg m; I about the centre of mass c, xx, yy,
     zz, xy, yz, zx in kg m^2); D: displacement [R | t], R rotation, t in m.
   84 mul, 96 add, 48 abs. */
static inline void ksl_inertia_transformed_certified(const ksl_inertia_t *Ji, const ksl_SE3_t *D,
    ksl_inertia_t *Jo, ksl_inertia_t *Jo_bound) {
  const double RI_0a = KSL_MUL(Ji->Ixx, D->m00), RI_0b = KSL_MUL(Ji->Ixy, D->m01),
      RI_0d = KSL_MUL(Ji->Izx, D->m02), RI_0 = RI_0a + RI_0b + RI_0d;
  const double RI_1a = KSL_MUL(Ji->Iyy, D->m01), RI_1b = KSL_MUL(Ji->Ixy, D->m00),
      RI_1d = KSL_MUL(Ji->Iyz, D->m02), RI_1 = RI_1a + RI_1b + RI_1d;
  const double RI_2a = KSL_MUL(Ji->Izz, D->m02), RI_2b = KSL_MUL(Ji->Iyz, D->m01),
      RI_2d = KSL_MUL(Ji->Izx, D->m00), RI_2 = RI_2a + RI_2b + RI_2d;
  const double RI_3a = KSL_MUL(Ji->Ixx, D->m10), RI_3b = KSL_MUL(Ji->Ixy, D->m11),
      RI_3d = KSL_MUL(Ji->Izx, D->m12), RI_3 = RI_3a + RI_3b + RI_3d;
  const double RI_4a = KSL_MUL(Ji->Iyy, D->m11), RI_4b = KSL_MUL(Ji->Ixy, D->m10),
      RI_4d = KSL_MUL(Ji->Iyz, D->m12), RI_4 = RI_4a + RI_4b + RI_4d;
  const double RI_5a = KSL_MUL(Ji->Izz, D->m12), RI_5b = KSL_MUL(Ji->Iyz, D->m11),
      RI_5d = KSL_MUL(Ji->Izx, D->m10), RI_5 = RI_5a + RI_5b + RI_5d;
  const double RI_6a = KSL_MUL(Ji->Ixx, D->m20), RI_6b = KSL_MUL(Ji->Ixy, D->m21),
      RI_6d = KSL_MUL(Ji->Izx, D->m22), RI_6 = RI_6a + RI_6b + RI_6d;
  const double RI_7a = KSL_MUL(Ji->Iyy, D->m21), RI_7b = KSL_MUL(Ji->Ixy, D->m20),
      RI_7d = KSL_MUL(Ji->Iyz, D->m22), RI_7 = RI_7a + RI_7b + RI_7d;
  const double RI_8a = KSL_MUL(Ji->Izz, D->m22), RI_8b = KSL_MUL(Ji->Iyz, D->m21),
      RI_8d = KSL_MUL(Ji->Izx, D->m20), RI_8 = RI_8a + RI_8b + RI_8d;
  const double Jo_1a = KSL_MUL(Ji->m, D->m03), Jo_1b = KSL_MUL(Ji->mt.x, D->m00),
      Jo_1c = KSL_MUL(Ji->mt.y, D->m01), Jo_1e = KSL_MUL(Ji->mt.z, D->m02),
      Jo_1 = Jo_1a + (Jo_1b + Jo_1c + Jo_1e);
  const double Jo_2a = KSL_MUL(Ji->m, D->m13), Jo_2b = KSL_MUL(Ji->mt.x, D->m10),
      Jo_2c = KSL_MUL(Ji->mt.y, D->m11), Jo_2e = KSL_MUL(Ji->mt.z, D->m12),
      Jo_2 = Jo_2a + (Jo_2b + Jo_2c + Jo_2e);
  const double Jo_3a = KSL_MUL(Ji->m, D->m23), Jo_3b = KSL_MUL(Ji->mt.x, D->m20),
      Jo_3c = KSL_MUL(Ji->mt.y, D->m21), Jo_3e = KSL_MUL(Ji->mt.z, D->m22),
      Jo_3 = Jo_3a + (Jo_3b + Jo_3c + Jo_3e);
  const double Jo_4 = KSL_MUL(D->m00, RI_0) + KSL_MUL(D->m01, RI_1) + KSL_MUL(D->m02, RI_2);
  const double Jo_5 = KSL_MUL(D->m10, RI_3) + KSL_MUL(D->m11, RI_4) + KSL_MUL(D->m12, RI_5);
  const double Jo_6 = KSL_MUL(D->m20, RI_6) + KSL_MUL(D->m21, RI_7) + KSL_MUL(D->m22, RI_8),
      Jo_7 = KSL_MUL(D->m10, RI_0) + KSL_MUL(D->m11, RI_1) + KSL_MUL(D->m12, RI_2),
      Jo_8 = KSL_MUL(D->m20, RI_3) + KSL_MUL(D->m21, RI_4) + KSL_MUL(D->m22, RI_5),
      Jo_9 = KSL_MUL(D->m20, RI_0) + KSL_MUL(D->m21, RI_1) + KSL_MUL(D->m22, RI_2);
  const double RI_0_size = fabs(RI_0a) + fabs(RI_0b) + fabs(RI_0d),
      RI_1_size = fabs(RI_1a) + fabs(RI_1b) + fabs(RI_1d),
      RI_2_size = fabs(RI_2a) + fabs(RI_2b) + fabs(RI_2d),
      RI_3_size = fabs(RI_3a) + fabs(RI_3b) + fabs(RI_3d),
      RI_4_size = fabs(RI_4a) + fabs(RI_4b) + fabs(RI_4d),
      RI_5_size = fabs(RI_5a) + fabs(RI_5b) + fabs(RI_5d),
      RI_6_size = fabs(RI_6a) + fabs(RI_6b) + fabs(RI_6d),
      RI_7_size = fabs(RI_7a) + fabs(RI_7b) + fabs(RI_7d),
      RI_8_size = fabs(RI_8a) + fabs(RI_8b) + fabs(RI_8d);
  const double Jo_1_size = fabs(Jo_1a) + (fabs(Jo_1b) + fabs(Jo_1c) + fabs(Jo_1e)),
      Jo_2_size = fabs(Jo_2a) + (fabs(Jo_2b) + fabs(Jo_2c) + fabs(Jo_2e)),
      Jo_3_size = fabs(Jo_3a) + (fabs(Jo_3b) + fabs(Jo_3c) + fabs(Jo_3e));
  const double RI_0_padded = RI_0_size + 2.004168360008973e-292,
      RI_1_padded = RI_1_size + 2.004168360008973e-292,
      RI_2_padded = RI_2_size + 2.004168360008973e-292;
  const double Jo_4_size = KSL_MUL(fabs(D->m00), RI_0_padded) + KSL_MUL(fabs(D->m01), RI_1_padded)
          + KSL_MUL(fabs(D->m02), RI_2_padded);
  const double RI_3_padded = RI_3_size + 2.004168360008973e-292;
  const double D_10_abs = fabs(D->m10);
  const double RI_4_padded = RI_4_size + 2.004168360008973e-292;
  const double D_11_abs = fabs(D->m11);
  const double RI_5_padded = RI_5_size + 2.004168360008973e-292;
  const double D_12_abs = fabs(D->m12),
      Jo_5_size = KSL_MUL(D_10_abs, RI_3_padded) + KSL_MUL(D_11_abs, RI_4_padded)
          + KSL_MUL(D_12_abs, RI_5_padded);
  const double D_20_abs = fabs(D->m20), D_21_abs = fabs(D->m21), D_22_abs = fabs(D->m22),
      Jo_6c_size = KSL_MUL(D_20_abs, RI_6_size + 2.004168360008973e-292)
          + KSL_MUL(D_21_abs, RI_7_size + 2.004168360008973e-292),
      Jo_6_size = Jo_6c_size + KSL_MUL(D_22_abs, RI_8_size + 2.004168360008973e-292);
  const double Jo_7_size = KSL_MUL(D_10_abs, RI_0_padded) + KSL_MUL(D_11_abs, RI_1_padded)
          + KSL_MUL(D_12_abs, RI_2_padded),
      Jo_8_size = KSL_MUL(D_20_abs, RI_3_padded) + KSL_MUL(D_21_abs, RI_4_padded)
          + KSL_MUL(D_22_abs, RI_5_padded),
      Jo_9_size = KSL_MUL(D_20_abs, RI_0_padded) + KSL_MUL(D_21_abs, RI_1_padded)
          + KSL_MUL(D_22_abs, RI_2_padded);
  const double Jo_1_bound = KSL_MUL(4.440892098500628e-16, Jo_1_size + 2.004168360008973e-292),
      Jo_2_bound = KSL_MUL(4.440892098500628e-16, Jo_2_size + 2.004168360008973e-292),
      Jo_3_bound = KSL_MUL(4.440892098500628e-16, Jo_3_size + 2.004168360008973e-292),
      Jo_4_bound = KSL_MUL(6.661338147750942e-16, Jo_4_size + 2.004168360008973e-292),
      Jo_5_bound = KSL_MUL(6.661338147750942e-16, Jo_5_size + 2.004168360008973e-292),
      Jo_6_bound = KSL_MUL(6.661338147750942e-16, Jo_6_size + 2.004168360008973e-292),
      Jo_7_bound = KSL_MUL(6.661338147750942e-16, Jo_7_size + 2.004168360008973e-292),
      Jo_8_bound = KSL_MUL(6.661338147750942e-16, Jo_8_size + 2.004168360008973e-292),
      Jo_9_bound = KSL_MUL(6.661338147750942e-16, Jo_9_size + 2.004168360008973e-292);
  const double Ji_m = Ji->m;
  Jo->m = Ji_m;
  Jo->mt.x = Jo_1;
  Jo->mt.y = Jo_2;
  Jo->mt.z = Jo_3;
  Jo->Ixx = Jo_4;
  Jo->Iyy = Jo_5;
  Jo->Izz = Jo_6;
  Jo->Ixy = Jo_7;
  Jo->Iyz = Jo_8;
  Jo->Izx = Jo_9;
  Jo_bound->m = 0.0;
  Jo_bound->mt.x = Jo_1_bound;
  Jo_bound->mt.y = Jo_2_bound;
  Jo_bound->mt.z = Jo_3_bound;
  Jo_bound->Ixx = Jo_4_bound;
  Jo_bound->Iyy = Jo_5_bound;
  Jo_bound->Izz = Jo_6_bound;
  Jo_bound->Ixy = Jo_7_bound;
  Jo_bound->Iyz = Jo_8_bound;
  Jo_bound->Izx = Jo_9_bound;
}

/* self = self displaced by D = [R | t]: m, R mt + m t, R I R^T; |error of self| <= self_bound
     unless inf or NaN.
   self, self_bound: inertia (m in kg; mt = m c in kg m; I about the centre of mass c, xx, yy,
     zz, xy, yz, zx in kg m^2); D: displacement [R | t], R rotation, t in m.
   84 mul, 96 add, 48 abs. */
static inline void ksl_inertia_transform_certified(ksl_inertia_t *self, const ksl_SE3_t *D,
    ksl_inertia_t *self_bound) {
  const double RI_0a = KSL_MUL(self->Ixx, D->m00), RI_0b = KSL_MUL(self->Ixy, D->m01),
      RI_0d = KSL_MUL(self->Izx, D->m02), RI_0 = RI_0a + RI_0b + RI_0d;
  const double RI_1a = KSL_MUL(self->Iyy, D->m01), RI_1b = KSL_MUL(self->Ixy, D->m00),
      RI_1d = KSL_MUL(self->Iyz, D->m02), RI_1 = RI_1a + RI_1b + RI_1d;
  const double RI_2a = KSL_MUL(self->Izz, D->m02), RI_2b = KSL_MUL(self->Iyz, D->m01),
      RI_2d = KSL_MUL(self->Izx, D->m00), RI_2 = RI_2a + RI_2b + RI_2d;
  const double RI_3a = KSL_MUL(self->Ixx, D->m10), RI_3b = KSL_MUL(self->Ixy, D->m11),
      RI_3d = KSL_MUL(self->Izx, D->m12), RI_3 = RI_3a + RI_3b + RI_3d;
  const double RI_4a = KSL_MUL(self->Iyy, D->m11), RI_4b = KSL_MUL(self->Ixy, D->m10),
      RI_4d = KSL_MUL(self->Iyz, D->m12), RI_4 = RI_4a + RI_4b + RI_4d;
  const double RI_5a = KSL_MUL(self->Izz, D->m12), RI_5b = KSL_MUL(self->Iyz, D->m11),
      RI_5d = KSL_MUL(self->Izx, D->m10), RI_5 = RI_5a + RI_5b + RI_5d;
  const double RI_6a = KSL_MUL(self->Ixx, D->m20), RI_6b = KSL_MUL(self->Ixy, D->m21),
      RI_6d = KSL_MUL(self->Izx, D->m22), RI_6 = RI_6a + RI_6b + RI_6d;
  const double RI_7a = KSL_MUL(self->Iyy, D->m21), RI_7b = KSL_MUL(self->Ixy, D->m20),
      RI_7d = KSL_MUL(self->Iyz, D->m22), RI_7 = RI_7a + RI_7b + RI_7d;
  const double RI_8a = KSL_MUL(self->Izz, D->m22), RI_8b = KSL_MUL(self->Iyz, D->m21),
      RI_8d = KSL_MUL(self->Izx, D->m20), RI_8 = RI_8a + RI_8b + RI_8d;
  const double self_1_new_a = KSL_MUL(self->m, D->m03), self_1_new_b = KSL_MUL(self->mt.x, D->m00),
      self_1_new_c = KSL_MUL(self->mt.y, D->m01), self_1_new_e = KSL_MUL(self->mt.z, D->m02),
      self_1_new = self_1_new_a + (self_1_new_b + self_1_new_c + self_1_new_e);
  const double self_2_new_a = KSL_MUL(self->m, D->m13), self_2_new_b = KSL_MUL(self->mt.x, D->m10),
      self_2_new_c = KSL_MUL(self->mt.y, D->m11), self_2_new_e = KSL_MUL(self->mt.z, D->m12),
      self_2_new = self_2_new_a + (self_2_new_b + self_2_new_c + self_2_new_e);
  const double self_3_new_a = KSL_MUL(self->m, D->m23), self_3_new_b = KSL_MUL(self->mt.x, D->m20),
      self_3_new_c = KSL_MUL(self->mt.y, D->m21), self_3_new_e = KSL_MUL(self->mt.z, D->m22),
      self_3_new = self_3_new_a + (self_3_new_b + self_3_new_c + self_3_new_e);
  const double self_4_new = KSL_MUL(D->m00, RI_0) + KSL_MUL(D->m01, RI_1) + KSL_MUL(D->m02, RI_2);
  const double self_5_new = KSL_MUL(D->m10, RI_3) + KSL_MUL(D->m11, RI_4) + KSL_MUL(D->m12, RI_5);
  const double self_6_new = KSL_MUL(D->m20, RI_6) + KSL_MUL(D->m21, RI_7) + KSL_MUL(D->m22, RI_8),
      self_7_new = KSL_MUL(D->m10, RI_0) + KSL_MUL(D->m11, RI_1) + KSL_MUL(D->m12, RI_2),
      self_8_new = KSL_MUL(D->m20, RI_3) + KSL_MUL(D->m21, RI_4) + KSL_MUL(D->m22, RI_5),
      self_9_new = KSL_MUL(D->m20, RI_0) + KSL_MUL(D->m21, RI_1) + KSL_MUL(D->m22, RI_2);
  const double RI_0_size = fabs(RI_0a) + fabs(RI_0b) + fabs(RI_0d),
      RI_1_size = fabs(RI_1a) + fabs(RI_1b) + fabs(RI_1d),
      RI_2_size = fabs(RI_2a) + fabs(RI_2b) + fabs(RI_2d),
      RI_3_size = fabs(RI_3a) + fabs(RI_3b) + fabs(RI_3d),
      RI_4_size = fabs(RI_4a) + fabs(RI_4b) + fabs(RI_4d),
      RI_5_size = fabs(RI_5a) + fabs(RI_5b) + fabs(RI_5d),
      RI_6_size = fabs(RI_6a) + fabs(RI_6b) + fabs(RI_6d),
      RI_7_size = fabs(RI_7a) + fabs(RI_7b) + fabs(RI_7d),
      RI_8_size = fabs(RI_8a) + fabs(RI_8b) + fabs(RI_8d);
  const double self_1_new_size = fabs(self_1_new_a)
          + (fabs(self_1_new_b) + fabs(self_1_new_c) + fabs(self_1_new_e)),
      self_2_new_size = fabs(self_2_new_a)
          + (fabs(self_2_new_b) + fabs(self_2_new_c) + fabs(self_2_new_e)),
      self_3_new_size = fabs(self_3_new_a)
          + (fabs(self_3_new_b) + fabs(self_3_new_c) + fabs(self_3_new_e));
  const double RI_0_padded = RI_0_size + 2.004168360008973e-292,
      RI_1_padded = RI_1_size + 2.004168360008973e-292,
      RI_2_padded = RI_2_size + 2.004168360008973e-292;
  const double self_4_new_size = KSL_MUL(fabs(D->m00), RI_0_padded)
          + KSL_MUL(fabs(D->m01), RI_1_padded) + KSL_MUL(fabs(D->m02), RI_2_padded);
  const double RI_3_padded = RI_3_size + 2.004168360008973e-292;
  const double D_10_abs = fabs(D->m10);
  const double RI_4_padded = RI_4_size + 2.004168360008973e-292;
  const double D_11_abs = fabs(D->m11);
  const double RI_5_padded = RI_5_size + 2.004168360008973e-292;
  const double D_12_abs = fabs(D->m12),
      self_5_new_size = KSL_MUL(D_10_abs, RI_3_padded) + KSL_MUL(D_11_abs, RI_4_padded)
          + KSL_MUL(D_12_abs, RI_5_padded);
  const double D_20_abs = fabs(D->m20), D_21_abs = fabs(D->m21), D_22_abs = fabs(D->m22),
      self_6_new_c_size = KSL_MUL(D_20_abs, RI_6_size + 2.004168360008973e-292)
          + KSL_MUL(D_21_abs, RI_7_size + 2.004168360008973e-292),
      self_6_new_size = self_6_new_c_size + KSL_MUL(D_22_abs, RI_8_size + 2.004168360008973e-292);
  const double self_7_new_size = KSL_MUL(D_10_abs, RI_0_padded) + KSL_MUL(D_11_abs, RI_1_padded)
          + KSL_MUL(D_12_abs, RI_2_padded),
      self_8_new_size = KSL_MUL(D_20_abs, RI_3_padded) + KSL_MUL(D_21_abs, RI_4_padded)
          + KSL_MUL(D_22_abs, RI_5_padded),
      self_9_new_size = KSL_MUL(D_20_abs, RI_0_padded) + KSL_MUL(D_21_abs, RI_1_padded)
          + KSL_MUL(D_22_abs, RI_2_padded);
  const double self_1_new_bound = KSL_MUL(4.440892098500628e-16, self_1_new_size
          + 2.004168360008973e-292),
      self_2_new_bound = KSL_MUL(4.440892098500628e-16, self_2_new_size + 2.004168360008973e-292),
      self_3_new_bound = KSL_MUL(4.440892098500628e-16, self_3_new_size + 2.004168360008973e-292),
      self_4_new_bound = KSL_MUL(6.661338147750942e-16, self_4_new_size + 2.004168360008973e-292),
      self_5_new_bound = KSL_MUL(6.661338147750942e-16, self_5_new_size + 2.004168360008973e-292),
      self_6_new_bound = KSL_MUL(6.661338147750942e-16, self_6_new_size + 2.004168360008973e-292),
      self_7_new_bound = KSL_MUL(6.661338147750942e-16, self_7_new_size + 2.004168360008973e-292),
      self_8_new_bound = KSL_MUL(6.661338147750942e-16, self_8_new_size + 2.004168360008973e-292),
      self_9_new_bound = KSL_MUL(6.661338147750942e-16, self_9_new_size + 2.004168360008973e-292);
  self->mt.x = self_1_new;
  self->mt.y = self_2_new;
  self->mt.z = self_3_new;
  self->Ixx = self_4_new;
  self->Iyy = self_5_new;
  self->Izz = self_6_new;
  self->Ixy = self_7_new;
  self->Iyz = self_8_new;
  self->Izx = self_9_new;
  self_bound->m = 0.0;
  self_bound->mt.x = self_1_new_bound;
  self_bound->mt.y = self_2_new_bound;
  self_bound->mt.z = self_3_new_bound;
  self_bound->Ixx = self_4_new_bound;
  self_bound->Iyy = self_5_new_bound;
  self_bound->Izz = self_6_new_bound;
  self_bound->Ixy = self_7_new_bound;
  self_bound->Iyz = self_8_new_bound;
  self_bound->Izx = self_9_new_bound;
}

/* J = (m; m t; Ixx, Iyy, Izz, Ixy, Iyz, Izx): mass, centre of mass t in m, entries of the
     moments' matrix about it in kg m^2, Ixy = -∫ x y dm; |error of J| <= J_bound unless inf or
     NaN.
   m, Ixx, Iyy, Izz, Ixy, Iyz, Izx: number; t: vector; J_bound: inertia (m in kg; mt = m c in kg
     m; I about the centre of mass c, xx, yy, zz, xy, yz, zx in kg m^2).
   6 mul, 3 add, 3 abs. */
static inline ksl_inertiaf_t ksl_inertiaf_certified(const float m, const ksl_vec3f_t t,
    const float Ixx, const float Iyy, const float Izz, const float Ixy,
    const float Iyz, const float Izx, ksl_inertiaf_t *J_bound) {
  const float J_1 = KSL_MULF(m, t.x), J_2 = KSL_MULF(m, t.y), J_3 = KSL_MULF(m, t.z);
  const float J_1_bound = KSL_MULF(5.960465e-08f, fabsf(J_1) + 1.9721523e-31f),
      J_2_bound = KSL_MULF(5.960465e-08f, fabsf(J_2) + 1.9721523e-31f),
      J_3_bound = KSL_MULF(5.960465e-08f, fabsf(J_3) + 1.9721523e-31f);
  ksl_inertiaf_t J;
  J.m = m;
  J.mt.x = J_1;
  J.mt.y = J_2;
  J.mt.z = J_3;
  J.Ixx = Ixx;
  J.Iyy = Iyy;
  J.Izz = Izz;
  J.Ixy = Ixy;
  J.Iyz = Iyz;
  J.Izx = Izx;
  J_bound->m = 0.0f;
  J_bound->mt.x = J_1_bound;
  J_bound->mt.y = J_2_bound;
  J_bound->mt.z = J_3_bound;
  J_bound->Ixx = 0.0f;
  J_bound->Iyy = 0.0f;
  J_bound->Izz = 0.0f;
  J_bound->Ixy = 0.0f;
  J_bound->Iyz = 0.0f;
  J_bound->Izx = 0.0f;
  return J;
}

/* Jo = Ji rotated by R: m, R mt, R I R^T; |error of Jo| <= Jo_bound unless inf or NaN.
   Ji, Jo, Jo_bound: inertia (m in kg; mt = m c in kg m; I about the centre of mass c, xx, yy,
     zz, xy, yz, zx in kg m^2); R: rotation or other 3×3 matrix.
   81 mul, 90 add, 45 abs. */
static inline void ksl_inertiaf_rotated_certified(const ksl_inertiaf_t *Ji,
    const ksl_mat3x3f_t *R, ksl_inertiaf_t *Jo, ksl_inertiaf_t *Jo_bound) {
  const float RI_0a = KSL_MULF(Ji->Ixx, R->m00), RI_0b = KSL_MULF(Ji->Ixy, R->m01),
      RI_0d = KSL_MULF(Ji->Izx, R->m02), RI_0 = RI_0a + RI_0b + RI_0d;
  const float RI_1a = KSL_MULF(Ji->Iyy, R->m01), RI_1b = KSL_MULF(Ji->Ixy, R->m00),
      RI_1d = KSL_MULF(Ji->Iyz, R->m02), RI_1 = RI_1a + RI_1b + RI_1d;
  const float RI_2a = KSL_MULF(Ji->Izz, R->m02), RI_2b = KSL_MULF(Ji->Iyz, R->m01),
      RI_2d = KSL_MULF(Ji->Izx, R->m00), RI_2 = RI_2a + RI_2b + RI_2d;
  const float RI_3a = KSL_MULF(Ji->Ixx, R->m10), RI_3b = KSL_MULF(Ji->Ixy, R->m11),
      RI_3d = KSL_MULF(Ji->Izx, R->m12), RI_3 = RI_3a + RI_3b + RI_3d;
  const float RI_4a = KSL_MULF(Ji->Iyy, R->m11), RI_4b = KSL_MULF(Ji->Ixy, R->m10),
      RI_4d = KSL_MULF(Ji->Iyz, R->m12), RI_4 = RI_4a + RI_4b + RI_4d;
  const float RI_5a = KSL_MULF(Ji->Izz, R->m12), RI_5b = KSL_MULF(Ji->Iyz, R->m11),
      RI_5d = KSL_MULF(Ji->Izx, R->m10), RI_5 = RI_5a + RI_5b + RI_5d;
  const float RI_6a = KSL_MULF(Ji->Ixx, R->m20), RI_6b = KSL_MULF(Ji->Ixy, R->m21),
      RI_6d = KSL_MULF(Ji->Izx, R->m22), RI_6 = RI_6a + RI_6b + RI_6d;
  const float RI_7a = KSL_MULF(Ji->Iyy, R->m21), RI_7b = KSL_MULF(Ji->Ixy, R->m20),
      RI_7d = KSL_MULF(Ji->Iyz, R->m22), RI_7 = RI_7a + RI_7b + RI_7d;
  const float RI_8a = KSL_MULF(Ji->Izz, R->m22), RI_8b = KSL_MULF(Ji->Iyz, R->m21),
      RI_8d = KSL_MULF(Ji->Izx, R->m20), RI_8 = RI_8a + RI_8b + RI_8d;
  const float Jo_1a = KSL_MULF(Ji->mt.x, R->m00), Jo_1b = KSL_MULF(Ji->mt.y, R->m01),
      Jo_1d = KSL_MULF(Ji->mt.z, R->m02), Jo_1 = Jo_1a + Jo_1b + Jo_1d;
  const float Jo_2a = KSL_MULF(Ji->mt.x, R->m10), Jo_2b = KSL_MULF(Ji->mt.y, R->m11),
      Jo_2d = KSL_MULF(Ji->mt.z, R->m12), Jo_2 = Jo_2a + Jo_2b + Jo_2d;
  const float Jo_3a = KSL_MULF(Ji->mt.x, R->m20), Jo_3b = KSL_MULF(Ji->mt.y, R->m21),
      Jo_3d = KSL_MULF(Ji->mt.z, R->m22), Jo_3 = Jo_3a + Jo_3b + Jo_3d;
  const float Jo_4 = KSL_MULF(R->m00, RI_0) + KSL_MULF(R->m01, RI_1) + KSL_MULF(R->m02, RI_2);
  const float Jo_5 = KSL_MULF(R->m10, RI_3) + KSL_MULF(R->m11, RI_4) + KSL_MULF(R->m12, RI_5);
  const float Jo_6 = KSL_MULF(R->m20, RI_6) + KSL_MULF(R->m21, RI_7) + KSL_MULF(R->m22, RI_8),
      Jo_7 = KSL_MULF(R->m10, RI_0) + KSL_MULF(R->m11, RI_1) + KSL_MULF(R->m12, RI_2),
      Jo_8 = KSL_MULF(R->m20, RI_3) + KSL_MULF(R->m21, RI_4) + KSL_MULF(R->m22, RI_5),
      Jo_9 = KSL_MULF(R->m20, RI_0) + KSL_MULF(R->m21, RI_1) + KSL_MULF(R->m22, RI_2);
  const float RI_0_size = fabsf(RI_0a) + fabsf(RI_0b) + fabsf(RI_0d),
      RI_1_size = fabsf(RI_1a) + fabsf(RI_1b) + fabsf(RI_1d),
      RI_2_size = fabsf(RI_2a) + fabsf(RI_2b) + fabsf(RI_2d),
      RI_3_size = fabsf(RI_3a) + fabsf(RI_3b) + fabsf(RI_3d),
      RI_4_size = fabsf(RI_4a) + fabsf(RI_4b) + fabsf(RI_4d),
      RI_5_size = fabsf(RI_5a) + fabsf(RI_5b) + fabsf(RI_5d),
      RI_6_size = fabsf(RI_6a) + fabsf(RI_6b) + fabsf(RI_6d),
      RI_7_size = fabsf(RI_7a) + fabsf(RI_7b) + fabsf(RI_7d),
      RI_8_size = fabsf(RI_8a) + fabsf(RI_8b) + fabsf(RI_8d);
  const float Jo_1_size = fabsf(Jo_1a) + fabsf(Jo_1b) + fabsf(Jo_1d),
      Jo_2_size = fabsf(Jo_2a) + fabsf(Jo_2b) + fabsf(Jo_2d),
      Jo_3_size = fabsf(Jo_3a) + fabsf(Jo_3b) + fabsf(Jo_3d);
  const float RI_0_padded = RI_0_size + 1.9721523e-31f, RI_1_padded = RI_1_size + 1.9721523e-31f,
      RI_2_padded = RI_2_size + 1.9721523e-31f;
  const float Jo_4_size = KSL_MULF(fabsf(R->m00), RI_0_padded)
          + KSL_MULF(fabsf(R->m01), RI_1_padded) + KSL_MULF(fabsf(R->m02), RI_2_padded);
  const float RI_3_padded = RI_3_size + 1.9721523e-31f;
  const float R_10_abs = fabsf(R->m10);
  const float RI_4_padded = RI_4_size + 1.9721523e-31f;
  const float R_11_abs = fabsf(R->m11);
  const float RI_5_padded = RI_5_size + 1.9721523e-31f;
  const float R_12_abs = fabsf(R->m12),
      Jo_5_size = KSL_MULF(R_10_abs, RI_3_padded) + KSL_MULF(R_11_abs, RI_4_padded)
          + KSL_MULF(R_12_abs, RI_5_padded);
  const float R_20_abs = fabsf(R->m20), R_21_abs = fabsf(R->m21), R_22_abs = fabsf(R->m22),
      Jo_6c_size = KSL_MULF(R_20_abs, RI_6_size + 1.9721523e-31f)
          + KSL_MULF(R_21_abs, RI_7_size + 1.9721523e-31f),
      Jo_6_size = Jo_6c_size + KSL_MULF(R_22_abs, RI_8_size + 1.9721523e-31f);
  const float Jo_7_size = KSL_MULF(R_10_abs, RI_0_padded) + KSL_MULF(R_11_abs, RI_1_padded)
          + KSL_MULF(R_12_abs, RI_2_padded),
      Jo_8_size = KSL_MULF(R_20_abs, RI_3_padded) + KSL_MULF(R_21_abs, RI_4_padded)
          + KSL_MULF(R_22_abs, RI_5_padded),
      Jo_9_size = KSL_MULF(R_20_abs, RI_0_padded) + KSL_MULF(R_21_abs, RI_1_padded)
          + KSL_MULF(R_22_abs, RI_2_padded);
  const float Jo_1_bound = KSL_MULF(1.7881396e-07f, Jo_1_size + 1.9721523e-31f),
      Jo_2_bound = KSL_MULF(1.7881396e-07f, Jo_2_size + 1.9721523e-31f),
      Jo_3_bound = KSL_MULF(1.7881396e-07f, Jo_3_size + 1.9721523e-31f),
      Jo_4_bound = KSL_MULF(3.5762795e-07f, Jo_4_size + 1.9721523e-31f),
      Jo_5_bound = KSL_MULF(3.5762795e-07f, Jo_5_size + 1.9721523e-31f),
      Jo_6_bound = KSL_MULF(3.5762795e-07f, Jo_6_size + 1.9721523e-31f),
      Jo_7_bound = KSL_MULF(3.5762795e-07f, Jo_7_size + 1.9721523e-31f),
      Jo_8_bound = KSL_MULF(3.5762795e-07f, Jo_8_size + 1.9721523e-31f),
      Jo_9_bound = KSL_MULF(3.5762795e-07f, Jo_9_size + 1.9721523e-31f);
  const float Ji_m = Ji->m;
  Jo->m = Ji_m;
  Jo->mt.x = Jo_1;
  Jo->mt.y = Jo_2;
  Jo->mt.z = Jo_3;
  Jo->Ixx = Jo_4;
  Jo->Iyy = Jo_5;
  Jo->Izz = Jo_6;
  Jo->Ixy = Jo_7;
  Jo->Iyz = Jo_8;
  Jo->Izx = Jo_9;
  Jo_bound->m = 0.0f;
  Jo_bound->mt.x = Jo_1_bound;
  Jo_bound->mt.y = Jo_2_bound;
  Jo_bound->mt.z = Jo_3_bound;
  Jo_bound->Ixx = Jo_4_bound;
  Jo_bound->Iyy = Jo_5_bound;
  Jo_bound->Izz = Jo_6_bound;
  Jo_bound->Ixy = Jo_7_bound;
  Jo_bound->Iyz = Jo_8_bound;
  Jo_bound->Izx = Jo_9_bound;
}

/* self = self rotated by R: m, R mt, R I R^T; |error of self| <= self_bound unless inf or NaN.
   self, self_bound: inertia (m in kg; mt = m c in kg m; I about the centre of mass c, xx, yy,
     zz, xy, yz, zx in kg m^2); R: rotation or other 3×3 matrix.
   81 mul, 90 add, 45 abs. */
static inline void ksl_inertiaf_rotate_certified(ksl_inertiaf_t *self, const ksl_mat3x3f_t *R,
    ksl_inertiaf_t *self_bound) {
  const float RI_0a = KSL_MULF(self->Ixx, R->m00), RI_0b = KSL_MULF(self->Ixy, R->m01),
      RI_0d = KSL_MULF(self->Izx, R->m02), RI_0 = RI_0a + RI_0b + RI_0d;
  const float RI_1a = KSL_MULF(self->Iyy, R->m01), RI_1b = KSL_MULF(self->Ixy, R->m00),
      RI_1d = KSL_MULF(self->Iyz, R->m02), RI_1 = RI_1a + RI_1b + RI_1d;
  const float RI_2a = KSL_MULF(self->Izz, R->m02), RI_2b = KSL_MULF(self->Iyz, R->m01),
      RI_2d = KSL_MULF(self->Izx, R->m00), RI_2 = RI_2a + RI_2b + RI_2d;
  const float RI_3a = KSL_MULF(self->Ixx, R->m10), RI_3b = KSL_MULF(self->Ixy, R->m11),
      RI_3d = KSL_MULF(self->Izx, R->m12), RI_3 = RI_3a + RI_3b + RI_3d;
  const float RI_4a = KSL_MULF(self->Iyy, R->m11), RI_4b = KSL_MULF(self->Ixy, R->m10),
      RI_4d = KSL_MULF(self->Iyz, R->m12), RI_4 = RI_4a + RI_4b + RI_4d;
  const float RI_5a = KSL_MULF(self->Izz, R->m12), RI_5b = KSL_MULF(self->Iyz, R->m11),
      RI_5d = KSL_MULF(self->Izx, R->m10), RI_5 = RI_5a + RI_5b + RI_5d;
  const float RI_6a = KSL_MULF(self->Ixx, R->m20), RI_6b = KSL_MULF(self->Ixy, R->m21),
      RI_6d = KSL_MULF(self->Izx, R->m22), RI_6 = RI_6a + RI_6b + RI_6d;
  const float RI_7a = KSL_MULF(self->Iyy, R->m21), RI_7b = KSL_MULF(self->Ixy, R->m20),
      RI_7d = KSL_MULF(self->Iyz, R->m22), RI_7 = RI_7a + RI_7b + RI_7d;
  const float RI_8a = KSL_MULF(self->Izz, R->m22), RI_8b = KSL_MULF(self->Iyz, R->m21),
      RI_8d = KSL_MULF(self->Izx, R->m20), RI_8 = RI_8a + RI_8b + RI_8d;
  const float self_1_new_a = KSL_MULF(self->mt.x, R->m00),
      self_1_new_b = KSL_MULF(self->mt.y, R->m01), self_1_new_d = KSL_MULF(self->mt.z, R->m02),
      self_1_new = self_1_new_a + self_1_new_b + self_1_new_d;
  const float self_2_new_a = KSL_MULF(self->mt.x, R->m10),
      self_2_new_b = KSL_MULF(self->mt.y, R->m11), self_2_new_d = KSL_MULF(self->mt.z, R->m12),
      self_2_new = self_2_new_a + self_2_new_b + self_2_new_d;
  const float self_3_new_a = KSL_MULF(self->mt.x, R->m20),
      self_3_new_b = KSL_MULF(self->mt.y, R->m21), self_3_new_d = KSL_MULF(self->mt.z, R->m22),
      self_3_new = self_3_new_a + self_3_new_b + self_3_new_d;
  const float self_4_new = KSL_MULF(R->m00, RI_0) + KSL_MULF(R->m01, RI_1) + KSL_MULF(R->m02, RI_2);
  const float self_5_new = KSL_MULF(R->m10, RI_3) + KSL_MULF(R->m11, RI_4) + KSL_MULF(R->m12, RI_5);
  const float self_6_new = KSL_MULF(R->m20, RI_6) + KSL_MULF(R->m21, RI_7) + KSL_MULF(R->m22, RI_8),
      self_7_new = KSL_MULF(R->m10, RI_0) + KSL_MULF(R->m11, RI_1) + KSL_MULF(R->m12, RI_2),
      self_8_new = KSL_MULF(R->m20, RI_3) + KSL_MULF(R->m21, RI_4) + KSL_MULF(R->m22, RI_5),
      self_9_new = KSL_MULF(R->m20, RI_0) + KSL_MULF(R->m21, RI_1) + KSL_MULF(R->m22, RI_2);
  const float RI_0_size = fabsf(RI_0a) + fabsf(RI_0b) + fabsf(RI_0d),
      RI_1_size = fabsf(RI_1a) + fabsf(RI_1b) + fabsf(RI_1d),
      RI_2_size = fabsf(RI_2a) + fabsf(RI_2b) + fabsf(RI_2d),
      RI_3_size = fabsf(RI_3a) + fabsf(RI_3b) + fabsf(RI_3d),
      RI_4_size = fabsf(RI_4a) + fabsf(RI_4b) + fabsf(RI_4d),
      RI_5_size = fabsf(RI_5a) + fabsf(RI_5b) + fabsf(RI_5d),
      RI_6_size = fabsf(RI_6a) + fabsf(RI_6b) + fabsf(RI_6d),
      RI_7_size = fabsf(RI_7a) + fabsf(RI_7b) + fabsf(RI_7d),
      RI_8_size = fabsf(RI_8a) + fabsf(RI_8b) + fabsf(RI_8d);
  const float self_1_new_size = fabsf(self_1_new_a) + fabsf(self_1_new_b) + fabsf(self_1_new_d),
      self_2_new_size = fabsf(self_2_new_a) + fabsf(self_2_new_b) + fabsf(self_2_new_d),
      self_3_new_size = fabsf(self_3_new_a) + fabsf(self_3_new_b) + fabsf(self_3_new_d);
  const float RI_0_padded = RI_0_size + 1.9721523e-31f, RI_1_padded = RI_1_size + 1.9721523e-31f,
      RI_2_padded = RI_2_size + 1.9721523e-31f;
  const float self_4_new_size = KSL_MULF(fabsf(R->m00), RI_0_padded)
          + KSL_MULF(fabsf(R->m01), RI_1_padded) + KSL_MULF(fabsf(R->m02), RI_2_padded);
  const float RI_3_padded = RI_3_size + 1.9721523e-31f;
  const float R_10_abs = fabsf(R->m10);
  const float RI_4_padded = RI_4_size + 1.9721523e-31f;
  const float R_11_abs = fabsf(R->m11);
  const float RI_5_padded = RI_5_size + 1.9721523e-31f;
  const float R_12_abs = fabsf(R->m12),
      self_5_new_size = KSL_MULF(R_10_abs, RI_3_padded) + KSL_MULF(R_11_abs, RI_4_padded)
          + KSL_MULF(R_12_abs, RI_5_padded);
  const float R_20_abs = fabsf(R->m20), R_21_abs = fabsf(R->m21), R_22_abs = fabsf(R->m22),
      self_6_new_c_size = KSL_MULF(R_20_abs, RI_6_size + 1.9721523e-31f)
          + KSL_MULF(R_21_abs, RI_7_size + 1.9721523e-31f),
      self_6_new_size = self_6_new_c_size + KSL_MULF(R_22_abs, RI_8_size + 1.9721523e-31f);
  const float self_7_new_size = KSL_MULF(R_10_abs, RI_0_padded) + KSL_MULF(R_11_abs, RI_1_padded)
          + KSL_MULF(R_12_abs, RI_2_padded),
      self_8_new_size = KSL_MULF(R_20_abs, RI_3_padded) + KSL_MULF(R_21_abs, RI_4_padded)
          + KSL_MULF(R_22_abs, RI_5_padded),
      self_9_new_size = KSL_MULF(R_20_abs, RI_0_padded) + KSL_MULF(R_21_abs, RI_1_padded)
          + KSL_MULF(R_22_abs, RI_2_padded);
  const float self_1_new_bound = KSL_MULF(1.7881396e-07f, self_1_new_size + 1.9721523e-31f),
      self_2_new_bound = KSL_MULF(1.7881396e-07f, self_2_new_size + 1.9721523e-31f),
      self_3_new_bound = KSL_MULF(1.7881396e-07f, self_3_new_size + 1.9721523e-31f),
      self_4_new_bound = KSL_MULF(3.5762795e-07f, self_4_new_size + 1.9721523e-31f),
      self_5_new_bound = KSL_MULF(3.5762795e-07f, self_5_new_size + 1.9721523e-31f),
      self_6_new_bound = KSL_MULF(3.5762795e-07f, self_6_new_size + 1.9721523e-31f),
      self_7_new_bound = KSL_MULF(3.5762795e-07f, self_7_new_size + 1.9721523e-31f),
      self_8_new_bound = KSL_MULF(3.5762795e-07f, self_8_new_size + 1.9721523e-31f),
      self_9_new_bound = KSL_MULF(3.5762795e-07f, self_9_new_size + 1.9721523e-31f);
  self->mt.x = self_1_new;
  self->mt.y = self_2_new;
  self->mt.z = self_3_new;
  self->Ixx = self_4_new;
  self->Iyy = self_5_new;
  self->Izz = self_6_new;
  self->Ixy = self_7_new;
  self->Iyz = self_8_new;
  self->Izx = self_9_new;
  self_bound->m = 0.0f;
  self_bound->mt.x = self_1_new_bound;
  self_bound->mt.y = self_2_new_bound;
  self_bound->mt.z = self_3_new_bound;
  self_bound->Ixx = self_4_new_bound;
  self_bound->Iyy = self_5_new_bound;
  self_bound->Izz = self_6_new_bound;
  self_bound->Ixy = self_7_new_bound;
  self_bound->Iyz = self_8_new_bound;
  self_bound->Izx = self_9_new_bound;
}

/* Jo = Ji translated by t: m, mt + m t, I; |error of Jo| <= Jo_bound unless inf or NaN.
   Ji, Jo, Jo_bound: inertia (m in kg; mt = m c in kg m; I about the centre of mass c, xx, yy,
     zz, xy, yz, zx in kg m^2); t: vector.
   6 mul, 9 add, 6 abs. */
static inline void ksl_inertiaf_translated_certified(const ksl_inertiaf_t *Ji,
    const ksl_vec3f_t *t, ksl_inertiaf_t *Jo, ksl_inertiaf_t *Jo_bound) {
  const float Jo_1a = KSL_MULF(Ji->m, t->x), Jo_1 = Jo_1a + Ji->mt.x;
  const float Jo_2a = KSL_MULF(Ji->m, t->y), Jo_2 = Jo_2a + Ji->mt.y;
  const float Jo_3a = KSL_MULF(Ji->m, t->z), Jo_3 = Jo_3a + Ji->mt.z;
  const float Jo_1_size = fabsf(Jo_1a) + fabsf(Ji->mt.x),
      Jo_2_size = fabsf(Jo_2a) + fabsf(Ji->mt.y), Jo_3_size = fabsf(Jo_3a) + fabsf(Ji->mt.z);
  const float Jo_1_bound = KSL_MULF(1.192093e-07f, Jo_1_size + 1.9721523e-31f),
      Jo_2_bound = KSL_MULF(1.192093e-07f, Jo_2_size + 1.9721523e-31f),
      Jo_3_bound = KSL_MULF(1.192093e-07f, Jo_3_size + 1.9721523e-31f);
  const float Ji_m = Ji->m;
  const float Ji_Ixx = Ji->Ixx;
  const float Ji_Iyy = Ji->Iyy;
  const float Ji_Izz = Ji->Izz;
  const float Ji_Ixy = Ji->Ixy;
  const float Ji_Iyz = Ji->Iyz;
  const float Ji_Izx = Ji->Izx;
  Jo->m = Ji_m;
  Jo->mt.x = Jo_1;
  Jo->mt.y = Jo_2;
  Jo->mt.z = Jo_3;
  Jo->Ixx = Ji_Ixx;
  Jo->Iyy = Ji_Iyy;
  Jo->Izz = Ji_Izz;
  Jo->Ixy = Ji_Ixy;
  Jo->Iyz = Ji_Iyz;
  Jo->Izx = Ji_Izx;
  Jo_bound->m = 0.0f;
  Jo_bound->mt.x = Jo_1_bound;
  Jo_bound->mt.y = Jo_2_bound;
  Jo_bound->mt.z = Jo_3_bound;
  Jo_bound->Ixx = 0.0f;
  Jo_bound->Iyy = 0.0f;
  Jo_bound->Izz = 0.0f;
  Jo_bound->Ixy = 0.0f;
  Jo_bound->Iyz = 0.0f;
  Jo_bound->Izx = 0.0f;
}

/* self = self translated by t: m, mt + m t, I; |error of self| <= self_bound unless inf or NaN.
   self, self_bound: inertia (m in kg; mt = m c in kg m; I about the centre of mass c, xx, yy,
     zz, xy, yz, zx in kg m^2); t: vector.
   6 mul, 9 add, 6 abs. */
static inline void ksl_inertiaf_translate_certified(ksl_inertiaf_t *self, const ksl_vec3f_t *t,
    ksl_inertiaf_t *self_bound) {
  const float self_1_new_a = KSL_MULF(self->m, t->x), self_1_new = self_1_new_a + self->mt.x;
  const float self_2_new_a = KSL_MULF(self->m, t->y), self_2_new = self_2_new_a + self->mt.y;
  const float self_3_new_a = KSL_MULF(self->m, t->z), self_3_new = self_3_new_a + self->mt.z;
  const float self_1_new_size = fabsf(self_1_new_a) + fabsf(self->mt.x),
      self_2_new_size = fabsf(self_2_new_a) + fabsf(self->mt.y),
      self_3_new_size = fabsf(self_3_new_a) + fabsf(self->mt.z);
  const float self_1_new_bound = KSL_MULF(1.192093e-07f, self_1_new_size + 1.9721523e-31f),
      self_2_new_bound = KSL_MULF(1.192093e-07f, self_2_new_size + 1.9721523e-31f),
      self_3_new_bound = KSL_MULF(1.192093e-07f, self_3_new_size + 1.9721523e-31f);
  self->mt.x = self_1_new;
  self->mt.y = self_2_new;
  self->mt.z = self_3_new;
  self_bound->m = 0.0f;
  self_bound->mt.x = self_1_new_bound;
  self_bound->mt.y = self_2_new_bound;
  self_bound->mt.z = self_3_new_bound;
  self_bound->Ixx = 0.0f;
  self_bound->Iyy = 0.0f;
  self_bound->Izz = 0.0f;
  self_bound->Ixy = 0.0f;
  self_bound->Iyz = 0.0f;
  self_bound->Izx = 0.0f;
}

/* Jo = Ji displaced by D = [R | t]: m, R mt + m t, R I R^T; |error of Jo| <= Jo_bound unless inf
     or NaN.
   Ji, Jo, Jo_bound: inertia (m in kg; mt = m c in kg m; I about the centre of mass c, xx, yy,
     zz, xy, yz, zx in kg m^2); D: displacement [R | t], R rotation, t in m.
   84 mul, 96 add, 48 abs. */
static inline void ksl_inertiaf_transformed_certified(const ksl_inertiaf_t *Ji,
    const ksl_SE3f_t *D, ksl_inertiaf_t *Jo, ksl_inertiaf_t *Jo_bound) {
  const float RI_0a = KSL_MULF(Ji->Ixx, D->m00), RI_0b = KSL_MULF(Ji->Ixy, D->m01),
      RI_0d = KSL_MULF(Ji->Izx, D->m02), RI_0 = RI_0a + RI_0b + RI_0d;
  const float RI_1a = KSL_MULF(Ji->Iyy, D->m01), RI_1b = KSL_MULF(Ji->Ixy, D->m00),
      RI_1d = KSL_MULF(Ji->Iyz, D->m02), RI_1 = RI_1a + RI_1b + RI_1d;
  const float RI_2a = KSL_MULF(Ji->Izz, D->m02), RI_2b = KSL_MULF(Ji->Iyz, D->m01),
      RI_2d = KSL_MULF(Ji->Izx, D->m00), RI_2 = RI_2a + RI_2b + RI_2d;
  const float RI_3a = KSL_MULF(Ji->Ixx, D->m10), RI_3b = KSL_MULF(Ji->Ixy, D->m11),
      RI_3d = KSL_MULF(Ji->Izx, D->m12), RI_3 = RI_3a + RI_3b + RI_3d;
  const float RI_4a = KSL_MULF(Ji->Iyy, D->m11), RI_4b = KSL_MULF(Ji->Ixy, D->m10),
      RI_4d = KSL_MULF(Ji->Iyz, D->m12), RI_4 = RI_4a + RI_4b + RI_4d;
  const float RI_5a = KSL_MULF(Ji->Izz, D->m12), RI_5b = KSL_MULF(Ji->Iyz, D->m11),
      RI_5d = KSL_MULF(Ji->Izx, D->m10), RI_5 = RI_5a + RI_5b + RI_5d;
  const float RI_6a = KSL_MULF(Ji->Ixx, D->m20), RI_6b = KSL_MULF(Ji->Ixy, D->m21),
      RI_6d = KSL_MULF(Ji->Izx, D->m22), RI_6 = RI_6a + RI_6b + RI_6d;
  const float RI_7a = KSL_MULF(Ji->Iyy, D->m21), RI_7b = KSL_MULF(Ji->Ixy, D->m20),
      RI_7d = KSL_MULF(Ji->Iyz, D->m22), RI_7 = RI_7a + RI_7b + RI_7d;
  const float RI_8a = KSL_MULF(Ji->Izz, D->m22), RI_8b = KSL_MULF(Ji->Iyz, D->m21),
      RI_8d = KSL_MULF(Ji->Izx, D->m20), RI_8 = RI_8a + RI_8b + RI_8d;
  const float Jo_1a = KSL_MULF(Ji->m, D->m03), Jo_1b = KSL_MULF(Ji->mt.x, D->m00),
      Jo_1c = KSL_MULF(Ji->mt.y, D->m01), Jo_1e = KSL_MULF(Ji->mt.z, D->m02),
      Jo_1 = Jo_1a + (Jo_1b + Jo_1c + Jo_1e);
  const float Jo_2a = KSL_MULF(Ji->m, D->m13), Jo_2b = KSL_MULF(Ji->mt.x, D->m10),
      Jo_2c = KSL_MULF(Ji->mt.y, D->m11), Jo_2e = KSL_MULF(Ji->mt.z, D->m12),
      Jo_2 = Jo_2a + (Jo_2b + Jo_2c + Jo_2e);
  const float Jo_3a = KSL_MULF(Ji->m, D->m23), Jo_3b = KSL_MULF(Ji->mt.x, D->m20),
      Jo_3c = KSL_MULF(Ji->mt.y, D->m21), Jo_3e = KSL_MULF(Ji->mt.z, D->m22),
      Jo_3 = Jo_3a + (Jo_3b + Jo_3c + Jo_3e);
  const float Jo_4 = KSL_MULF(D->m00, RI_0) + KSL_MULF(D->m01, RI_1) + KSL_MULF(D->m02, RI_2);
  const float Jo_5 = KSL_MULF(D->m10, RI_3) + KSL_MULF(D->m11, RI_4) + KSL_MULF(D->m12, RI_5);
  const float Jo_6 = KSL_MULF(D->m20, RI_6) + KSL_MULF(D->m21, RI_7) + KSL_MULF(D->m22, RI_8),
      Jo_7 = KSL_MULF(D->m10, RI_0) + KSL_MULF(D->m11, RI_1) + KSL_MULF(D->m12, RI_2),
      Jo_8 = KSL_MULF(D->m20, RI_3) + KSL_MULF(D->m21, RI_4) + KSL_MULF(D->m22, RI_5),
      Jo_9 = KSL_MULF(D->m20, RI_0) + KSL_MULF(D->m21, RI_1) + KSL_MULF(D->m22, RI_2);
  const float RI_0_size = fabsf(RI_0a) + fabsf(RI_0b) + fabsf(RI_0d),
      RI_1_size = fabsf(RI_1a) + fabsf(RI_1b) + fabsf(RI_1d),
      RI_2_size = fabsf(RI_2a) + fabsf(RI_2b) + fabsf(RI_2d),
      RI_3_size = fabsf(RI_3a) + fabsf(RI_3b) + fabsf(RI_3d),
      RI_4_size = fabsf(RI_4a) + fabsf(RI_4b) + fabsf(RI_4d),
      RI_5_size = fabsf(RI_5a) + fabsf(RI_5b) + fabsf(RI_5d),
      RI_6_size = fabsf(RI_6a) + fabsf(RI_6b) + fabsf(RI_6d),
      RI_7_size = fabsf(RI_7a) + fabsf(RI_7b) + fabsf(RI_7d),
      RI_8_size = fabsf(RI_8a) + fabsf(RI_8b) + fabsf(RI_8d);
  const float Jo_1_size = fabsf(Jo_1a) + (fabsf(Jo_1b) + fabsf(Jo_1c) + fabsf(Jo_1e)),
      Jo_2_size = fabsf(Jo_2a) + (fabsf(Jo_2b) + fabsf(Jo_2c) + fabsf(Jo_2e)),
      Jo_3_size = fabsf(Jo_3a) + (fabsf(Jo_3b) + fabsf(Jo_3c) + fabsf(Jo_3e));
  const float RI_0_padded = RI_0_size + 1.9721523e-31f, RI_1_padded = RI_1_size + 1.9721523e-31f,
      RI_2_padded = RI_2_size + 1.9721523e-31f;
  const float Jo_4_size = KSL_MULF(fabsf(D->m00), RI_0_padded)
          + KSL_MULF(fabsf(D->m01), RI_1_padded) + KSL_MULF(fabsf(D->m02), RI_2_padded);
  const float RI_3_padded = RI_3_size + 1.9721523e-31f;
  const float D_10_abs = fabsf(D->m10);
  const float RI_4_padded = RI_4_size + 1.9721523e-31f;
  const float D_11_abs = fabsf(D->m11);
  const float RI_5_padded = RI_5_size + 1.9721523e-31f;
  const float D_12_abs = fabsf(D->m12),
      Jo_5_size = KSL_MULF(D_10_abs, RI_3_padded) + KSL_MULF(D_11_abs, RI_4_padded)
          + KSL_MULF(D_12_abs, RI_5_padded);
  const float D_20_abs = fabsf(D->m20), D_21_abs = fabsf(D->m21), D_22_abs = fabsf(D->m22),
      Jo_6c_size = KSL_MULF(D_20_abs, RI_6_size + 1.9721523e-31f)
          + KSL_MULF(D_21_abs, RI_7_size + 1.9721523e-31f),
      Jo_6_size = Jo_6c_size + KSL_MULF(D_22_abs, RI_8_size + 1.9721523e-31f);
  const float Jo_7_size = KSL_MULF(D_10_abs, RI_0_padded) + KSL_MULF(D_11_abs, RI_1_padded)
          + KSL_MULF(D_12_abs, RI_2_padded),
      Jo_8_size = KSL_MULF(D_20_abs, RI_3_padded) + KSL_MULF(D_21_abs, RI_4_padded)
          + KSL_MULF(D_22_abs, RI_5_padded),
      Jo_9_size = KSL_MULF(D_20_abs, RI_0_padded) + KSL_MULF(D_21_abs, RI_1_padded)
          + KSL_MULF(D_22_abs, RI_2_padded);
  const float Jo_1_bound = KSL_MULF(2.3841864e-07f, Jo_1_size + 1.9721523e-31f),
      Jo_2_bound = KSL_MULF(2.3841864e-07f, Jo_2_size + 1.9721523e-31f),
      Jo_3_bound = KSL_MULF(2.3841864e-07f, Jo_3_size + 1.9721523e-31f),
      Jo_4_bound = KSL_MULF(3.5762795e-07f, Jo_4_size + 1.9721523e-31f),
      Jo_5_bound = KSL_MULF(3.5762795e-07f, Jo_5_size + 1.9721523e-31f),
      Jo_6_bound = KSL_MULF(3.5762795e-07f, Jo_6_size + 1.9721523e-31f),
      Jo_7_bound = KSL_MULF(3.5762795e-07f, Jo_7_size + 1.9721523e-31f),
      Jo_8_bound = KSL_MULF(3.5762795e-07f, Jo_8_size + 1.9721523e-31f),
      Jo_9_bound = KSL_MULF(3.5762795e-07f, Jo_9_size + 1.9721523e-31f);
  const float Ji_m = Ji->m;
  Jo->m = Ji_m;
  Jo->mt.x = Jo_1;
  Jo->mt.y = Jo_2;
  Jo->mt.z = Jo_3;
  Jo->Ixx = Jo_4;
  Jo->Iyy = Jo_5;
  Jo->Izz = Jo_6;
  Jo->Ixy = Jo_7;
  Jo->Iyz = Jo_8;
  Jo->Izx = Jo_9;
  Jo_bound->m = 0.0f;
  Jo_bound->mt.x = Jo_1_bound;
  Jo_bound->mt.y = Jo_2_bound;
  Jo_bound->mt.z = Jo_3_bound;
  Jo_bound->Ixx = Jo_4_bound;
  Jo_bound->Iyy = Jo_5_bound;
  Jo_bound->Izz = Jo_6_bound;
  Jo_bound->Ixy = Jo_7_bound;
  Jo_bound->Iyz = Jo_8_bound;
  Jo_bound->Izx = Jo_9_bound;
}

/* self = self displaced by D = [R | t]: m, R mt + m t, R I R^T; |error of self| <= self_bound
     unless inf or NaN.
   self, self_bound: inertia (m in kg; mt = m c in kg m; I about the centre of mass c, xx, yy,
     zz, xy, yz, zx in kg m^2); D: displacement [R | t], R rotation, t in m.
   84 mul, 96 add, 48 abs. */
static inline void ksl_inertiaf_transform_certified(ksl_inertiaf_t *self, const ksl_SE3f_t *D,
    ksl_inertiaf_t *self_bound) {
  const float RI_0a = KSL_MULF(self->Ixx, D->m00), RI_0b = KSL_MULF(self->Ixy, D->m01),
      RI_0d = KSL_MULF(self->Izx, D->m02), RI_0 = RI_0a + RI_0b + RI_0d;
  const float RI_1a = KSL_MULF(self->Iyy, D->m01), RI_1b = KSL_MULF(self->Ixy, D->m00),
      RI_1d = KSL_MULF(self->Iyz, D->m02), RI_1 = RI_1a + RI_1b + RI_1d;
  const float RI_2a = KSL_MULF(self->Izz, D->m02), RI_2b = KSL_MULF(self->Iyz, D->m01),
      RI_2d = KSL_MULF(self->Izx, D->m00), RI_2 = RI_2a + RI_2b + RI_2d;
  const float RI_3a = KSL_MULF(self->Ixx, D->m10), RI_3b = KSL_MULF(self->Ixy, D->m11),
      RI_3d = KSL_MULF(self->Izx, D->m12), RI_3 = RI_3a + RI_3b + RI_3d;
  const float RI_4a = KSL_MULF(self->Iyy, D->m11), RI_4b = KSL_MULF(self->Ixy, D->m10),
      RI_4d = KSL_MULF(self->Iyz, D->m12), RI_4 = RI_4a + RI_4b + RI_4d;
  const float RI_5a = KSL_MULF(self->Izz, D->m12), RI_5b = KSL_MULF(self->Iyz, D->m11),
      RI_5d = KSL_MULF(self->Izx, D->m10), RI_5 = RI_5a + RI_5b + RI_5d;
  const float RI_6a = KSL_MULF(self->Ixx, D->m20), RI_6b = KSL_MULF(self->Ixy, D->m21),
      RI_6d = KSL_MULF(self->Izx, D->m22), RI_6 = RI_6a + RI_6b + RI_6d;
  const float RI_7a = KSL_MULF(self->Iyy, D->m21), RI_7b = KSL_MULF(self->Ixy, D->m20),
      RI_7d = KSL_MULF(self->Iyz, D->m22), RI_7 = RI_7a + RI_7b + RI_7d;
  const float RI_8a = KSL_MULF(self->Izz, D->m22), RI_8b = KSL_MULF(self->Iyz, D->m21),
      RI_8d = KSL_MULF(self->Izx, D->m20), RI_8 = RI_8a + RI_8b + RI_8d;
  const float self_1_new_a = KSL_MULF(self->m, D->m03), self_1_new_b = KSL_MULF(self->mt.x, D->m00),
      self_1_new_c = KSL_MULF(self->mt.y, D->m01), self_1_new_e = KSL_MULF(self->mt.z, D->m02),
      self_1_new = self_1_new_a + (self_1_new_b + self_1_new_c + self_1_new_e);
  const float self_2_new_a = KSL_MULF(self->m, D->m13), self_2_new_b = KSL_MULF(self->mt.x, D->m10),
      self_2_new_c = KSL_MULF(self->mt.y, D->m11), self_2_new_e = KSL_MULF(self->mt.z, D->m12),
      self_2_new = self_2_new_a + (self_2_new_b + self_2_new_c + self_2_new_e);
  const float self_3_new_a = KSL_MULF(self->m, D->m23), self_3_new_b = KSL_MULF(self->mt.x, D->m20),
      self_3_new_c = KSL_MULF(self->mt.y, D->m21), self_3_new_e = KSL_MULF(self->mt.z, D->m22),
      self_3_new = self_3_new_a + (self_3_new_b + self_3_new_c + self_3_new_e);
  const float self_4_new = KSL_MULF(D->m00, RI_0) + KSL_MULF(D->m01, RI_1) + KSL_MULF(D->m02, RI_2);
  const float self_5_new = KSL_MULF(D->m10, RI_3) + KSL_MULF(D->m11, RI_4) + KSL_MULF(D->m12, RI_5);
  const float self_6_new = KSL_MULF(D->m20, RI_6) + KSL_MULF(D->m21, RI_7) + KSL_MULF(D->m22, RI_8),
      self_7_new = KSL_MULF(D->m10, RI_0) + KSL_MULF(D->m11, RI_1) + KSL_MULF(D->m12, RI_2),
      self_8_new = KSL_MULF(D->m20, RI_3) + KSL_MULF(D->m21, RI_4) + KSL_MULF(D->m22, RI_5),
      self_9_new = KSL_MULF(D->m20, RI_0) + KSL_MULF(D->m21, RI_1) + KSL_MULF(D->m22, RI_2);
  const float RI_0_size = fabsf(RI_0a) + fabsf(RI_0b) + fabsf(RI_0d),
      RI_1_size = fabsf(RI_1a) + fabsf(RI_1b) + fabsf(RI_1d),
      RI_2_size = fabsf(RI_2a) + fabsf(RI_2b) + fabsf(RI_2d),
      RI_3_size = fabsf(RI_3a) + fabsf(RI_3b) + fabsf(RI_3d),
      RI_4_size = fabsf(RI_4a) + fabsf(RI_4b) + fabsf(RI_4d),
      RI_5_size = fabsf(RI_5a) + fabsf(RI_5b) + fabsf(RI_5d),
      RI_6_size = fabsf(RI_6a) + fabsf(RI_6b) + fabsf(RI_6d),
      RI_7_size = fabsf(RI_7a) + fabsf(RI_7b) + fabsf(RI_7d),
      RI_8_size = fabsf(RI_8a) + fabsf(RI_8b) + fabsf(RI_8d);
  const float self_1_new_size = fabsf(self_1_new_a)
          + (fabsf(self_1_new_b) + fabsf(self_1_new_c) + fabsf(self_1_new_e)),
      self_2_new_size = fabsf(self_2_new_a)
          + (fabsf(self_2_new_b) + fabsf(self_2_new_c) + fabsf(self_2_new_e)),
      self_3_new_size = fabsf(self_3_new_a)
          + (fabsf(self_3_new_b) + fabsf(self_3_new_c) + fabsf(self_3_new_e));
  const float RI_0_padded = RI_0_size + 1.9721523e-31f, RI_1_padded = RI_1_size + 1.9721523e-31f,
      RI_2_padded = RI_2_size + 1.9721523e-31f;
  const float self_4_new_size = KSL_MULF(fabsf(D->m00), RI_0_padded)
          + KSL_MULF(fabsf(D->m01), RI_1_padded) + KSL_MULF(fabsf(D->m02), RI_2_padded);
  const float RI_3_padded = RI_3_size + 1.9721523e-31f;
  const float D_10_abs = fabsf(D->m10);
  const float RI_4_padded = RI_4_size + 1.9721523e-31f;
  const float D_11_abs = fabsf(D->m11);
  const float RI_5_padded = RI_5_size + 1.9721523e-31f;
  const float D_12_abs = fabsf(D->m12),
      self_5_new_size = KSL_MULF(D_10_abs, RI_3_padded) + KSL_MULF(D_11_abs, RI_4_padded)
          + KSL_MULF(D_12_abs, RI_5_padded);
  const float D_20_abs = fabsf(D->m20), D_21_abs = fabsf(D->m21), D_22_abs = fabsf(D->m22),
      self_6_new_c_size = KSL_MULF(D_20_abs, RI_6_size + 1.9721523e-31f)
          + KSL_MULF(D_21_abs, RI_7_size + 1.9721523e-31f),
      self_6_new_size = self_6_new_c_size + KSL_MULF(D_22_abs, RI_8_size + 1.9721523e-31f);
  const float self_7_new_size = KSL_MULF(D_10_abs, RI_0_padded) + KSL_MULF(D_11_abs, RI_1_padded)
          + KSL_MULF(D_12_abs, RI_2_padded),
      self_8_new_size = KSL_MULF(D_20_abs, RI_3_padded) + KSL_MULF(D_21_abs, RI_4_padded)
          + KSL_MULF(D_22_abs, RI_5_padded),
      self_9_new_size = KSL_MULF(D_20_abs, RI_0_padded) + KSL_MULF(D_21_abs, RI_1_padded)
          + KSL_MULF(D_22_abs, RI_2_padded);
  const float self_1_new_bound = KSL_MULF(2.3841864e-07f, self_1_new_size + 1.9721523e-31f),
      self_2_new_bound = KSL_MULF(2.3841864e-07f, self_2_new_size + 1.9721523e-31f),
      self_3_new_bound = KSL_MULF(2.3841864e-07f, self_3_new_size + 1.9721523e-31f),
      self_4_new_bound = KSL_MULF(3.5762795e-07f, self_4_new_size + 1.9721523e-31f),
      self_5_new_bound = KSL_MULF(3.5762795e-07f, self_5_new_size + 1.9721523e-31f),
      self_6_new_bound = KSL_MULF(3.5762795e-07f, self_6_new_size + 1.9721523e-31f),
      self_7_new_bound = KSL_MULF(3.5762795e-07f, self_7_new_size + 1.9721523e-31f),
      self_8_new_bound = KSL_MULF(3.5762795e-07f, self_8_new_size + 1.9721523e-31f),
      self_9_new_bound = KSL_MULF(3.5762795e-07f, self_9_new_size + 1.9721523e-31f);
  self->mt.x = self_1_new;
  self->mt.y = self_2_new;
  self->mt.z = self_3_new;
  self->Ixx = self_4_new;
  self->Iyy = self_5_new;
  self->Izz = self_6_new;
  self->Ixy = self_7_new;
  self->Iyz = self_8_new;
  self->Izx = self_9_new;
  self_bound->m = 0.0f;
  self_bound->mt.x = self_1_new_bound;
  self_bound->mt.y = self_2_new_bound;
  self_bound->mt.z = self_3_new_bound;
  self_bound->Ixx = self_4_new_bound;
  self_bound->Iyy = self_5_new_bound;
  self_bound->Izz = self_6_new_bound;
  self_bound->Ixy = self_7_new_bound;
  self_bound->Iyz = self_8_new_bound;
  self_bound->Izx = self_9_new_bound;
}

#endif
