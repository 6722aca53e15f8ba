/* Made by `coscrew generate`; changes are overwritten. */
/* SPDX-License-Identifier: MIT */
/* coscrew 0.2.0.  Copyright (c) 2026 The coscrew authors. */
/* Inertias of rigid bodies: mass, mass times centre of mass, moments about the centre of mass.
   Fused tier: products fused into sums. */
#ifndef KSL_INERTIA_FUSED_H
#define KSL_INERTIA_FUSED_H

#include "ksl_types.h"

/* J = (m; m t; Ixx, Iyy, Izz, Ixy, Iyz, Izx): mass, centre of mass t in m, entries of the
     moments' matrix about it in kg m^2, Ixy = -∫ x y dm.
   m, Ixx, Iyy, Izz, Ixy, Iyz, Izx: number; t: vector.
   3 mul.
   Error <= u |result|, barring over- and underflow. */
static inline ksl_inertia_t ksl_inertia_fused(const double m, const ksl_vec3_t t,
    const double Ixx, const double Iyy, const double Izz, const double Ixy,
    const double Iyz, const double Izx) {
  const double J_1 = KSL_MUL(m, t.x);
  const double J_2 = KSL_MUL(m, t.y);
  const double J_3 = KSL_MUL(m, t.z);
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
  return J;
}

/* Jo = Ji rotated by R: m, R mt, R I R^T.
   Ji, Jo: inertia (m in kg; mt = m c in kg m; I about the centre of mass c, xx, yy, zz, xy, yz,
     zx in kg m^2); R: rotation or other 3×3 matrix.
   18 mul, 36 fma.
   Error <= u |result| + (m: 0, mt: 2, I: 5) u S, S the sum of the |terms| of the expanded
     formula; barring over- and underflow. */
static inline void ksl_inertia_rotated_fused(const ksl_inertia_t *Ji, const ksl_mat3x3_t *R,
    ksl_inertia_t *Jo) {
  const double RI_0a = KSL_MUL(Ji->Ixx, R->m00), RI_0c = fma(Ji->Ixy, R->m01, RI_0a),
      RI_0 = fma(Ji->Izx, R->m02, RI_0c);
  const double RI_1a = KSL_MUL(Ji->Iyy, R->m01), RI_1c = fma(Ji->Ixy, R->m00, RI_1a),
      RI_1 = fma(Ji->Iyz, R->m02, RI_1c);
  const double RI_2a = KSL_MUL(Ji->Izz, R->m02), RI_2c = fma(Ji->Iyz, R->m01, RI_2a),
      RI_2 = fma(Ji->Izx, R->m00, RI_2c);
  const double RI_3a = KSL_MUL(Ji->Ixx, R->m10), RI_3c = fma(Ji->Ixy, R->m11, RI_3a),
      RI_3 = fma(Ji->Izx, R->m12, RI_3c);
  const double RI_4a = KSL_MUL(Ji->Iyy, R->m11), RI_4c = fma(Ji->Ixy, R->m10, RI_4a),
      RI_4 = fma(Ji->Iyz, R->m12, RI_4c);
  const double RI_5a = KSL_MUL(Ji->Izz, R->m12), RI_5c = fma(Ji->Iyz, R->m11, RI_5a),
      RI_5 = fma(Ji->Izx, R->m10, RI_5c);
  const double RI_6a = KSL_MUL(Ji->Ixx, R->m20), RI_6c = fma(Ji->Ixy, R->m21, RI_6a),
      RI_6 = fma(Ji->Izx, R->m22, RI_6c);
  const double RI_7a = KSL_MUL(Ji->Iyy, R->m21), RI_7c = fma(Ji->Ixy, R->m20, RI_7a),
      RI_7 = fma(Ji->Iyz, R->m22, RI_7c);
  const double RI_8a = KSL_MUL(Ji->Izz, R->m22), RI_8c = fma(Ji->Iyz, R->m21, RI_8a),
      RI_8 = fma(Ji->Izx, R->m20, RI_8c);
  const double Jo_1a = KSL_MUL(Ji->mt.x, R->m00), Jo_1c = fma(Ji->mt.y, R->m01, Jo_1a),
      Jo_1 = fma(Ji->mt.z, R->m02, Jo_1c);
  const double Jo_2a = KSL_MUL(Ji->mt.x, R->m10), Jo_2c = fma(Ji->mt.y, R->m11, Jo_2a),
      Jo_2 = fma(Ji->mt.z, R->m12, Jo_2c);
  const double Jo_3a = KSL_MUL(Ji->mt.x, R->m20), Jo_3c = fma(Ji->mt.y, R->m21, Jo_3a),
      Jo_3 = fma(Ji->mt.z, R->m22, Jo_3c);
  const double Jo_4a = KSL_MUL(R->m00, RI_0), Jo_4c = fma(R->m01, RI_1, Jo_4a),
      Jo_4 = fma(R->m02, RI_2, Jo_4c);
  const double Jo_5a = KSL_MUL(R->m10, RI_3), Jo_5c = fma(R->m11, RI_4, Jo_5a),
      Jo_5 = fma(R->m12, RI_5, Jo_5c);
  const double Jo_6a = KSL_MUL(R->m20, RI_6), Jo_6c = fma(R->m21, RI_7, Jo_6a),
      Jo_6 = fma(R->m22, RI_8, Jo_6c);
  const double Jo_7a = KSL_MUL(R->m10, RI_0), Jo_7c = fma(R->m11, RI_1, Jo_7a),
      Jo_7 = fma(R->m12, RI_2, Jo_7c);
  const double Jo_8a = KSL_MUL(R->m20, RI_3), Jo_8c = fma(R->m21, RI_4, Jo_8a),
      Jo_8 = fma(R->m22, RI_5, Jo_8c);
  const double Jo_9a = KSL_MUL(R->m20, RI_0), Jo_9c = fma(R->m21, RI_1, Jo_9a),
      Jo_9 = fma(R->m22, RI_2, Jo_9c);
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
}

/* self = self rotated by R: m, R mt, R I R^T.
   self: inertia (m in kg; mt = m c in kg m; I about the centre of mass c, xx, yy, zz, xy, yz, zx
     in kg m^2); R: rotation or other 3×3 matrix.
   18 mul, 36 fma.
   Error <= u |result| + (m: 0, mt: 2, I: 5) u S, S the sum of the |terms| of the expanded
     formula; barring over- and underflow. */
static inline void ksl_inertia_rotate_fused(ksl_inertia_t *self, const ksl_mat3x3_t *R) {
  const double RI_0a = KSL_MUL(self->Ixx, R->m00), RI_0c = fma(self->Ixy, R->m01, RI_0a),
      RI_0 = fma(self->Izx, R->m02, RI_0c);
  const double RI_1a = KSL_MUL(self->Iyy, R->m01), RI_1c = fma(self->Ixy, R->m00, RI_1a),
      RI_1 = fma(self->Iyz, R->m02, RI_1c);
  const double RI_2a = KSL_MUL(self->Izz, R->m02), RI_2c = fma(self->Iyz, R->m01, RI_2a),
      RI_2 = fma(self->Izx, R->m00, RI_2c);
  const double RI_3a = KSL_MUL(self->Ixx, R->m10), RI_3c = fma(self->Ixy, R->m11, RI_3a),
      RI_3 = fma(self->Izx, R->m12, RI_3c);
  const double RI_4a = KSL_MUL(self->Iyy, R->m11), RI_4c = fma(self->Ixy, R->m10, RI_4a),
      RI_4 = fma(self->Iyz, R->m12, RI_4c);
  const double RI_5a = KSL_MUL(self->Izz, R->m12), RI_5c = fma(self->Iyz, R->m11, RI_5a),
      RI_5 = fma(self->Izx, R->m10, RI_5c);
  const double RI_6a = KSL_MUL(self->Ixx, R->m20), RI_6c = fma(self->Ixy, R->m21, RI_6a),
      RI_6 = fma(self->Izx, R->m22, RI_6c);
  const double RI_7a = KSL_MUL(self->Iyy, R->m21), RI_7c = fma(self->Ixy, R->m20, RI_7a),
      RI_7 = fma(self->Iyz, R->m22, RI_7c);
  const double RI_8a = KSL_MUL(self->Izz, R->m22), RI_8c = fma(self->Iyz, R->m21, RI_8a),
      RI_8 = fma(self->Izx, R->m20, RI_8c);
  const double self_1_new_a = KSL_MUL(self->mt.x, R->m00),
      self_1_new_c = fma(self->mt.y, R->m01, self_1_new_a),
      self_1_new = fma(self->mt.z, R->m02, self_1_new_c);
  const double self_2_new_a = KSL_MUL(self->mt.x, R->m10),
      self_2_new_c = fma(self->mt.y, R->m11, self_2_new_a),
      self_2_new = fma(self->mt.z, R->m12, self_2_new_c);
  const double self_3_new_a = KSL_MUL(self->mt.x, R->m20),
      self_3_new_c = fma(self->mt.y, R->m21, self_3_new_a),
      self_3_new = fma(self->mt.z, R->m22, self_3_new_c);
  const double self_4_new_a = KSL_MUL(R->m00, RI_0), self_4_new_c = fma(R->m01, RI_1, self_4_new_a),
      self_4_new = fma(R->m02, RI_2, self_4_new_c);
  const double self_5_new_a = KSL_MUL(R->m10, RI_3), self_5_new_c = fma(R->m11, RI_4, self_5_new_a),
      self_5_new = fma(R->m12, RI_5, self_5_new_c);
  const double self_6_new_a = KSL_MUL(R->m20, RI_6), self_6_new_c = fma(R->m21, RI_7, self_6_new_a),
      self_6_new = fma(R->m22, RI_8, self_6_new_c);
  const double self_7_new_a = KSL_MUL(R->m10, RI_0), self_7_new_c = fma(R->m11, RI_1, self_7_new_a),
      self_7_new = fma(R->m12, RI_2, self_7_new_c);
  const double self_8_new_a = KSL_MUL(R->m20, RI_3), self_8_new_c = fma(R->m21, RI_4, self_8_new_a),
      self_8_new = fma(R->m22, RI_5, self_8_new_c);
  const double self_9_new_a = KSL_MUL(R->m20, RI_0), self_9_new_c = fma(R->m21, RI_1, self_9_new_a),
      self_9_new = fma(R->m22, RI_2, self_9_new_c);
  self->mt.x = self_1_new;
  self->mt.y = self_2_new;
  self->mt.z = self_3_new;
  self->Ixx = self_4_new;
  self->Iyy = self_5_new;
  self->Izz = self_6_new;
  self->Ixy = self_7_new;
  self->Iyz = self_8_new;
  self->Izx = self_9_new;
}

/* Jo = Ji translated by t: m, mt + m t, I.
   Ji, Jo: inertia (m in kg; mt = m c in kg m; I about the centre of mass c, xx, yy, zz, xy, yz,
     zx in kg m^2); t: vector.
   3 fma.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_inertia_translated_fused(const ksl_inertia_t *Ji, const ksl_vec3_t *t,
    ksl_inertia_t *Jo) {
  const double Jo_1 = fma(Ji->m, t->x, Ji->mt.x);
  const double Jo_2 = fma(Ji->m, t->y, Ji->mt.y);
  const double Jo_3 = fma(Ji->m, t->z, Ji->mt.z);
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
}

/* self = self translated by t: m, mt + m t, I.
   self: inertia (m in kg; mt = m c in kg m; I about the centre of mass c, xx, yy, zz, xy, yz, zx
     in kg m^2); t: vector.
   3 fma.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_inertia_translate_fused(ksl_inertia_t *self, const ksl_vec3_t *t) {
  const double self_1_new = fma(self->m, t->x, self->mt.x);
  const double self_2_new = fma(self->m, t->y, self->mt.y);
  const double self_3_new = fma(self->m, t->z, self->mt.z);
  self->mt.x = self_1_new;
  self->mt.y = self_2_new;
  self->mt.z = self_3_new;
}

/* Jo = Ji displaced by D = [R | t]: m, R mt + m t, R I R^T.
   Ji, Jo: inertia (m in kg; mt = m c in kg m; I about the centre of mass c, xx, yy, zz, xy, yz,
     zx in kg m^2); D: displacement [R | t], R rotation, t in m.
   18 mul, 39 fma.
   Error <= u |result| + (m: 0, mt: 3, I: 5) u S, S the sum of the |terms| of the expanded
     formula; barring over- and underflow. */
static inline void ksl_inertia_transformed_fused(const ksl_inertia_t *Ji, const ksl_SE3_t *D,
    ksl_inertia_t *Jo) {
  const double RI_0a = KSL_MUL(Ji->Ixx, D->m00), RI_0c = fma(Ji->Ixy, D->m01, RI_0a),
      RI_0 = fma(Ji->Izx, D->m02, RI_0c);
  const double RI_1a = KSL_MUL(Ji->Iyy, D->m01), RI_1c = fma(Ji->Ixy, D->m00, RI_1a),
      RI_1 = fma(Ji->Iyz, D->m02, RI_1c);
  const double RI_2a = KSL_MUL(Ji->Izz, D->m02), RI_2c = fma(Ji->Iyz, D->m01, RI_2a),
      RI_2 = fma(Ji->Izx, D->m00, RI_2c);
  const double RI_3a = KSL_MUL(Ji->Ixx, D->m10), RI_3c = fma(Ji->Ixy, D->m11, RI_3a),
      RI_3 = fma(Ji->Izx, D->m12, RI_3c);
  const double RI_4a = KSL_MUL(Ji->Iyy, D->m11), RI_4c = fma(Ji->Ixy, D->m10, RI_4a),
      RI_4 = fma(Ji->Iyz, D->m12, RI_4c);
  const double RI_5a = KSL_MUL(Ji->Izz, D->m12), RI_5c = fma(Ji->Iyz, D->m11, RI_5a),
      RI_5 = fma(Ji->Izx, D->m10, RI_5c);
  const double RI_6a = KSL_MUL(Ji->Ixx, D->m20), RI_6c = fma(Ji->Ixy, D->m21, RI_6a),
      RI_6 = fma(Ji->Izx, D->m22, RI_6c);
  const double RI_7a = KSL_MUL(Ji->Iyy, D->m21), RI_7c = fma(Ji->Ixy, D->m20, RI_7a),
      RI_7 = fma(Ji->Iyz, D->m22, RI_7c);
  const double RI_8a = KSL_MUL(Ji->Izz, D->m22), RI_8c = fma(Ji->Iyz, D->m21, RI_8a),
      RI_8 = fma(Ji->Izx, D->m20, RI_8c);
  const double Jo_1b = KSL_MUL(Ji->mt.x, D->m00), Jo_1d = fma(Ji->mt.y, D->m01, Jo_1b),
      Jo_1f = fma(Ji->mt.z, D->m02, Jo_1d), Jo_1 = fma(Ji->m, D->m03, Jo_1f);
  const double Jo_2b = KSL_MUL(Ji->mt.x, D->m10), Jo_2d = fma(Ji->mt.y, D->m11, Jo_2b),
      Jo_2f = fma(Ji->mt.z, D->m12, Jo_2d), Jo_2 = fma(Ji->m, D->m13, Jo_2f);
  const double Jo_3b = KSL_MUL(Ji->mt.x, D->m20), Jo_3d = fma(Ji->mt.y, D->m21, Jo_3b),
      Jo_3f = fma(Ji->mt.z, D->m22, Jo_3d), Jo_3 = fma(Ji->m, D->m23, Jo_3f);
  const double Jo_4a = KSL_MUL(D->m00, RI_0), Jo_4c = fma(D->m01, RI_1, Jo_4a),
      Jo_4 = fma(D->m02, RI_2, Jo_4c);
  const double Jo_5a = KSL_MUL(D->m10, RI_3), Jo_5c = fma(D->m11, RI_4, Jo_5a),
      Jo_5 = fma(D->m12, RI_5, Jo_5c);
  const double Jo_6a = KSL_MUL(D->m20, RI_6), Jo_6c = fma(D->m21, RI_7, Jo_6a),
      Jo_6 = fma(D->m22, RI_8, Jo_6c);
  const double Jo_7a = KSL_MUL(D->m10, RI_0), Jo_7c = fma(D->m11, RI_1, Jo_7a),
      Jo_7 = fma(D->m12, RI_2, Jo_7c);
  const double Jo_8a = KSL_MUL(D->m20, RI_3), Jo_8c = fma(D->m21, RI_4, Jo_8a),
      Jo_8 = fma(D->m22, RI_5, Jo_8c);
  const double Jo_9a = KSL_MUL(D->m20, RI_0), Jo_9c = fma(D->m21, RI_1, Jo_9a),
      Jo_9 = fma(D->m22, RI_2, Jo_9c);
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
}

/* self = self displaced by D = [R | t]: m, R mt + m t, R I R^T.
   self: inertia (m in kg; mt = m c in kg m; I about the centre of mass c, xx, yy, zz, xy, yz, zx
     in kg m^2); D: displacement [R | t], R rotation, t in m.
   18 mul, 39 fma.
   Error <= u |result| + (m: 0, mt: 3, I: 5) u S, S the sum of the |terms| of the expanded
     formula; barring over- and underflow. */
static inline void ksl_inertia_transform_fused(ksl_inertia_t *self, const ksl_SE3_t *D) {
  const double RI_0a = KSL_MUL(self->Ixx, D->m00), RI_0c = fma(self->Ixy, D->m01, RI_0a),
      RI_0 = fma(self->Izx, D->m02, RI_0c);
  const double RI_1a = KSL_MUL(self->Iyy, D->m01), RI_1c = fma(self->Ixy, D->m00, RI_1a),
      RI_1 = fma(self->Iyz, D->m02, RI_1c);
  const double RI_2a = KSL_MUL(self->Izz, D->m02), RI_2c = fma(self->Iyz, D->m01, RI_2a),
      RI_2 = fma(self->Izx, D->m00, RI_2c);
  const double RI_3a = KSL_MUL(self->Ixx, D->m10), RI_3c = fma(self->Ixy, D->m11, RI_3a),
      RI_3 = fma(self->Izx, D->m12, RI_3c);
  const double RI_4a = KSL_MUL(self->Iyy, D->m11), RI_4c = fma(self->Ixy, D->m10, RI_4a),
      RI_4 = fma(self->Iyz, D->m12, RI_4c);
  const double RI_5a = KSL_MUL(self->Izz, D->m12), RI_5c = fma(self->Iyz, D->m11, RI_5a),
      RI_5 = fma(self->Izx, D->m10, RI_5c);
  const double RI_6a = KSL_MUL(self->Ixx, D->m20), RI_6c = fma(self->Ixy, D->m21, RI_6a),
      RI_6 = fma(self->Izx, D->m22, RI_6c);
  const double RI_7a = KSL_MUL(self->Iyy, D->m21), RI_7c = fma(self->Ixy, D->m20, RI_7a),
      RI_7 = fma(self->Iyz, D->m22, RI_7c);
  const double RI_8a = KSL_MUL(self->Izz, D->m22), RI_8c = fma(self->Iyz, D->m21, RI_8a),
      RI_8 = fma(self->Izx, D->m20, RI_8c);
  const double self_1_new_b = KSL_MUL(self->mt.x, D->m00),
      self_1_new_d = fma(self->mt.y, D->m01, self_1_new_b),
      self_1_new_f = fma(self->mt.z, D->m02, self_1_new_d),
      self_1_new = fma(self->m, D->m03, self_1_new_f);
  const double self_2_new_b = KSL_MUL(self->mt.x, D->m10),
      self_2_new_d = fma(self->mt.y, D->m11, self_2_new_b),
      self_2_new_f = fma(self->mt.z, D->m12, self_2_new_d),
      self_2_new = fma(self->m, D->m13, self_2_new_f);
  const double self_3_new_b = KSL_MUL(self->mt.x, D->m20),
      self_3_new_d = fma(self->mt.y, D->m21, self_3_new_b),
      self_3_new_f = fma(self->mt.z, D->m22, self_3_new_d),
      self_3_new = fma(self->m, D->m23, self_3_new_f);
  const double self_4_new_a = KSL_MUL(D->m00, RI_0), self_4_new_c = fma(D->m01, RI_1, self_4_new_a),
      self_4_new = fma(D->m02, RI_2, self_4_new_c);
  const double self_5_new_a = KSL_MUL(D->m10, RI_3), self_5_new_c = fma(D->m11, RI_4, self_5_new_a),
      self_5_new = fma(D->m12, RI_5, self_5_new_c);
  const double self_6_new_a = KSL_MUL(D->m20, RI_6), self_6_new_c = fma(D->m21, RI_7, self_6_new_a),
      self_6_new = fma(D->m22, RI_8, self_6_new_c);
  const double self_7_new_a = KSL_MUL(D->m10, RI_0), self_7_new_c = fma(D->m11, RI_1, self_7_new_a),
      self_7_new = fma(D->m12, RI_2, self_7_new_c);
  const double self_8_new_a = KSL_MUL(D->m20, RI_3), self_8_new_c = fma(D->m21, RI_4, self_8_new_a),
      self_8_new = fma(D->m22, RI_5, self_8_new_c);
  const double self_9_new_a = KSL_MUL(D->m20, RI_0), self_9_new_c = fma(D->m21, RI_1, self_9_new_a),
      self_9_new = fma(D->m22, RI_2, self_9_new_c);
  self->mt.x = self_1_new;
  self->mt.y = self_2_new;
  self->mt.z = self_3_new;
  self->Ixx = self_4_new;
  self->Iyy = self_5_new;
  self->Izz = self_6_new;
  self->Ixy = self_7_new;
  self->Iyz = self_8_new;
  self->Izx = self_9_new;
}

/* J = (m; m t; Ixx, Iyy, Izz, Ixy, Iyz, Izx): mass, centre of mass t in m, entries of the
     moments' matrix about it in kg m^2, Ixy = -∫ x y dm.
   m, Ixx, Iyy, Izz, Ixy, Iyz, Izx: number; t: vector.
   3 mul.
   Error <= u |result|, barring over- and underflow. */
static inline ksl_inertiaf_t ksl_inertiaf_fused(const float m, const ksl_vec3f_t t,
    const float Ixx, const float Iyy, const float Izz, const float Ixy,
    const float Iyz, const float Izx) {
  const float J_1 = KSL_MULF(m, t.x);
  const float J_2 = KSL_MULF(m, t.y);
  const float J_3 = KSL_MULF(m, t.z);
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
  return J;
}

/* Jo = Ji rotated by R: m, R mt, R I R^T.
   Ji, Jo: inertia (m in kg; mt = m c in kg m; I about the centre of mass c, xx, yy, zz, xy, yz,
     zx in kg m^2); R: rotation or other 3×3 matrix.
   18 mul, 36 fma.
   Error <= u |result| + (m: 0, mt: 2, I: 5) u S, S the sum of the |terms| of the expanded
     formula; barring over- and underflow. */
static inline void ksl_inertiaf_rotated_fused(const ksl_inertiaf_t *Ji, const ksl_mat3x3f_t *R,
    ksl_inertiaf_t *Jo) {
  const float RI_0a = KSL_MULF(Ji->Ixx, R->m00), RI_0c = fmaf(Ji->Ixy, R->m01, RI_0a),
      RI_0 = fmaf(Ji->Izx, R->m02, RI_0c);
  const float RI_1a = KSL_MULF(Ji->Iyy, R->m01), RI_1c = fmaf(Ji->Ixy, R->m00, RI_1a),
      RI_1 = fmaf(Ji->Iyz, R->m02, RI_1c);
  const float RI_2a = KSL_MULF(Ji->Izz, R->m02), RI_2c = fmaf(Ji->Iyz, R->m01, RI_2a),
      RI_2 = fmaf(Ji->Izx, R->m00, RI_2c);
  const float RI_3a = KSL_MULF(Ji->Ixx, R->m10), RI_3c = fmaf(Ji->Ixy, R->m11, RI_3a),
      RI_3 = fmaf(Ji->Izx, R->m12, RI_3c);
  const float RI_4a = KSL_MULF(Ji->Iyy, R->m11), RI_4c = fmaf(Ji->Ixy, R->m10, RI_4a),
      RI_4 = fmaf(Ji->Iyz, R->m12, RI_4c);
  const float RI_5a = KSL_MULF(Ji->Izz, R->m12), RI_5c = fmaf(Ji->Iyz, R->m11, RI_5a),
      RI_5 = fmaf(Ji->Izx, R->m10, RI_5c);
  const float RI_6a = KSL_MULF(Ji->Ixx, R->m20), RI_6c = fmaf(Ji->Ixy, R->m21, RI_6a),
      RI_6 = fmaf(Ji->Izx, R->m22, RI_6c);
  const float RI_7a = KSL_MULF(Ji->Iyy, R->m21), RI_7c = fmaf(Ji->Ixy, R->m20, RI_7a),
      RI_7 = fmaf(Ji->Iyz, R->m22, RI_7c);
  const float RI_8a = KSL_MULF(Ji->Izz, R->m22), RI_8c = fmaf(Ji->Iyz, R->m21, RI_8a),
      RI_8 = fmaf(Ji->Izx, R->m20, RI_8c);
  const float Jo_1a = KSL_MULF(Ji->mt.x, R->m00), Jo_1c = fmaf(Ji->mt.y, R->m01, Jo_1a),
      Jo_1 = fmaf(Ji->mt.z, R->m02, Jo_1c);
  const float Jo_2a = KSL_MULF(Ji->mt.x, R->m10), Jo_2c = fmaf(Ji->mt.y, R->m11, Jo_2a),
      Jo_2 = fmaf(Ji->mt.z, R->m12, Jo_2c);
  const float Jo_3a = KSL_MULF(Ji->mt.x, R->m20), Jo_3c = fmaf(Ji->mt.y, R->m21, Jo_3a),
      Jo_3 = fmaf(Ji->mt.z, R->m22, Jo_3c);
  const float Jo_4a = KSL_MULF(R->m00, RI_0), Jo_4c = fmaf(R->m01, RI_1, Jo_4a),
      Jo_4 = fmaf(R->m02, RI_2, Jo_4c);
  const float Jo_5a = KSL_MULF(R->m10, RI_3), Jo_5c = fmaf(R->m11, RI_4, Jo_5a),
      Jo_5 = fmaf(R->m12, RI_5, Jo_5c);
  const float Jo_6a = KSL_MULF(R->m20, RI_6), Jo_6c = fmaf(R->m21, RI_7, Jo_6a),
      Jo_6 = fmaf(R->m22, RI_8, Jo_6c);
  const float Jo_7a = KSL_MULF(R->m10, RI_0), Jo_7c = fmaf(R->m11, RI_1, Jo_7a),
      Jo_7 = fmaf(R->m12, RI_2, Jo_7c);
  const float Jo_8a = KSL_MULF(R->m20, RI_3), Jo_8c = fmaf(R->m21, RI_4, Jo_8a),
      Jo_8 = fmaf(R->m22, RI_5, Jo_8c);
  const float Jo_9a = KSL_MULF(R->m20, RI_0), Jo_9c = fmaf(R->m21, RI_1, Jo_9a),
      Jo_9 = fmaf(R->m22, RI_2, Jo_9c);
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
}

/* self = self rotated by R: m, R mt, R I R^T.
   self: inertia (m in kg; mt = m c in kg m; I about the centre of mass c, xx, yy, zz, xy, yz, zx
     in kg m^2); R: rotation or other 3×3 matrix.
   18 mul, 36 fma.
   Error <= u |result| + (m: 0, mt: 2, I: 5) u S, S the sum of the |terms| of the expanded
     formula; barring over- and underflow. */
static inline void ksl_inertiaf_rotate_fused(ksl_inertiaf_t *self, const ksl_mat3x3f_t *R) {
  const float RI_0a = KSL_MULF(self->Ixx, R->m00), RI_0c = fmaf(self->Ixy, R->m01, RI_0a),
      RI_0 = fmaf(self->Izx, R->m02, RI_0c);
  const float RI_1a = KSL_MULF(self->Iyy, R->m01), RI_1c = fmaf(self->Ixy, R->m00, RI_1a),
      RI_1 = fmaf(self->Iyz, R->m02, RI_1c);
  const float RI_2a = KSL_MULF(self->Izz, R->m02), RI_2c = fmaf(self->Iyz, R->m01, RI_2a),
      RI_2 = fmaf(self->Izx, R->m00, RI_2c);
  const float RI_3a = KSL_MULF(self->Ixx, R->m10), RI_3c = fmaf(self->Ixy, R->m11, RI_3a),
      RI_3 = fmaf(self->Izx, R->m12, RI_3c);
  const float RI_4a = KSL_MULF(self->Iyy, R->m11), RI_4c = fmaf(self->Ixy, R->m10, RI_4a),
      RI_4 = fmaf(self->Iyz, R->m12, RI_4c);
  const float RI_5a = KSL_MULF(self->Izz, R->m12), RI_5c = fmaf(self->Iyz, R->m11, RI_5a),
      RI_5 = fmaf(self->Izx, R->m10, RI_5c);
  const float RI_6a = KSL_MULF(self->Ixx, R->m20), RI_6c = fmaf(self->Ixy, R->m21, RI_6a),
      RI_6 = fmaf(self->Izx, R->m22, RI_6c);
  const float RI_7a = KSL_MULF(self->Iyy, R->m21), RI_7c = fmaf(self->Ixy, R->m20, RI_7a),
      RI_7 = fmaf(self->Iyz, R->m22, RI_7c);
  const float RI_8a = KSL_MULF(self->Izz, R->m22), RI_8c = fmaf(self->Iyz, R->m21, RI_8a),
      RI_8 = fmaf(self->Izx, R->m20, RI_8c);
  const float self_1_new_a = KSL_MULF(self->mt.x, R->m00),
      self_1_new_c = fmaf(self->mt.y, R->m01, self_1_new_a),
      self_1_new = fmaf(self->mt.z, R->m02, self_1_new_c);
  const float self_2_new_a = KSL_MULF(self->mt.x, R->m10),
      self_2_new_c = fmaf(self->mt.y, R->m11, self_2_new_a),
      self_2_new = fmaf(self->mt.z, R->m12, self_2_new_c);
  const float self_3_new_a = KSL_MULF(self->mt.x, R->m20),
      self_3_new_c = fmaf(self->mt.y, R->m21, self_3_new_a),
      self_3_new = fmaf(self->mt.z, R->m22, self_3_new_c);
  const float self_4_new_a = KSL_MULF(R->m00, RI_0),
      self_4_new_c = fmaf(R->m01, RI_1, self_4_new_a),
      self_4_new = fmaf(R->m02, RI_2, self_4_new_c);
  const float self_5_new_a = KSL_MULF(R->m10, RI_3),
      self_5_new_c = fmaf(R->m11, RI_4, self_5_new_a),
      self_5_new = fmaf(R->m12, RI_5, self_5_new_c);
  const float self_6_new_a = KSL_MULF(R->m20, RI_6),
      self_6_new_c = fmaf(R->m21, RI_7, self_6_new_a),
      self_6_new = fmaf(R->m22, RI_8, self_6_new_c);
  const float self_7_new_a = KSL_MULF(R->m10, RI_0),
      self_7_new_c = fmaf(R->m11, RI_1, self_7_new_a),
      self_7_new = fmaf(R->m12, RI_2, self_7_new_c);
  const float self_8_new_a = KSL_MULF(R->m20, RI_3),
      self_8_new_c = fmaf(R->m21, RI_4, self_8_new_a),
      self_8_new = fmaf(R->m22, RI_5, self_8_new_c);
  const float self_9_new_a = KSL_MULF(R->m20, RI_0),
      self_9_new_c = fmaf(R->m21, RI_1, self_9_new_a),
      self_9_new = fmaf(R->m22, RI_2, self_9_new_c);
  self->mt.x = self_1_new;
  self->mt.y = self_2_new;
  self->mt.z = self_3_new;
  self->Ixx = self_4_new;
  self->Iyy = self_5_new;
  self->Izz = self_6_new;
  self->Ixy = self_7_new;
  self->Iyz = self_8_new;
  self->Izx = self_9_new;
}

/* Jo = Ji translated by t: m, mt + m t, I.
   Ji, Jo: inertia (m in kg; mt = m c in kg m; I about the centre of mass c, xx, yy, zz, xy, yz,
     zx in kg m^2); t: vector.
   3 fma.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_inertiaf_translated_fused(const ksl_inertiaf_t *Ji, const ksl_vec3f_t *t,
    ksl_inertiaf_t *Jo) {
  const float Jo_1 = fmaf(Ji->m, t->x, Ji->mt.x);
  const float Jo_2 = fmaf(Ji->m, t->y, Ji->mt.y);
  const float Jo_3 = fmaf(Ji->m, t->z, Ji->mt.z);
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
}

/* self = self translated by t: m, mt + m t, I.
   self: inertia (m in kg; mt = m c in kg m; I about the centre of mass c, xx, yy, zz, xy, yz, zx
     in kg m^2); t: vector.
   3 fma.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_inertiaf_translate_fused(ksl_inertiaf_t *self, const ksl_vec3f_t *t) {
  const float self_1_new = fmaf(self->m, t->x, self->mt.x);
  const float self_2_new = fmaf(self->m, t->y, self->mt.y);
  const float self_3_new = fmaf(self->m, t->z, self->mt.z);
  self->mt.x = self_1_new;
  self->mt.y = self_2_new;
  self->mt.z = self_3_new;
}

/* Jo = Ji displaced by D = [R | t]: m, R mt + m t, R I R^T.
   Ji, Jo: inertia (m in kg; mt = m c in kg m; I about the centre of mass c, xx, yy, zz, xy, yz,
     zx in kg m^2); D: displacement [R | t], R rotation, t in m.
   18 mul, 39 fma.
   Error <= u |result| + (m: 0, mt: 3, I: 5) u S, S the sum of the |terms| of the expanded
     formula; barring over- and underflow. */
static inline void ksl_inertiaf_transformed_fused(const ksl_inertiaf_t *Ji, const ksl_SE3f_t *D,
    ksl_inertiaf_t *Jo) {
  const float RI_0a = KSL_MULF(Ji->Ixx, D->m00), RI_0c = fmaf(Ji->Ixy, D->m01, RI_0a),
      RI_0 = fmaf(Ji->Izx, D->m02, RI_0c);
  const float RI_1a = KSL_MULF(Ji->Iyy, D->m01), RI_1c = fmaf(Ji->Ixy, D->m00, RI_1a),
      RI_1 = fmaf(Ji->Iyz, D->m02, RI_1c);
  const float RI_2a = KSL_MULF(Ji->Izz, D->m02), RI_2c = fmaf(Ji->Iyz, D->m01, RI_2a),
      RI_2 = fmaf(Ji->Izx, D->m00, RI_2c);
  const float RI_3a = KSL_MULF(Ji->Ixx, D->m10), RI_3c = fmaf(Ji->Ixy, D->m11, RI_3a),
      RI_3 = fmaf(Ji->Izx, D->m12, RI_3c);
  const float RI_4a = KSL_MULF(Ji->Iyy, D->m11), RI_4c = fmaf(Ji->Ixy, D->m10, RI_4a),
      RI_4 = fmaf(Ji->Iyz, D->m12, RI_4c);
  const float RI_5a = KSL_MULF(Ji->Izz, D->m12), RI_5c = fmaf(Ji->Iyz, D->m11, RI_5a),
      RI_5 = fmaf(Ji->Izx, D->m10, RI_5c);
  const float RI_6a = KSL_MULF(Ji->Ixx, D->m20), RI_6c = fmaf(Ji->Ixy, D->m21, RI_6a),
      RI_6 = fmaf(Ji->Izx, D->m22, RI_6c);
  const float RI_7a = KSL_MULF(Ji->Iyy, D->m21), RI_7c = fmaf(Ji->Ixy, D->m20, RI_7a),
      RI_7 = fmaf(Ji->Iyz, D->m22, RI_7c);
  const float RI_8a = KSL_MULF(Ji->Izz, D->m22), RI_8c = fmaf(Ji->Iyz, D->m21, RI_8a),
      RI_8 = fmaf(Ji->Izx, D->m20, RI_8c);
  const float Jo_1b = KSL_MULF(Ji->mt.x, D->m00), Jo_1d = fmaf(Ji->mt.y, D->m01, Jo_1b),
      Jo_1f = fmaf(Ji->mt.z, D->m02, Jo_1d), Jo_1 = fmaf(Ji->m, D->m03, Jo_1f);
  const float Jo_2b = KSL_MULF(Ji->mt.x, D->m10), Jo_2d = fmaf(Ji->mt.y, D->m11, Jo_2b),
      Jo_2f = fmaf(Ji->mt.z, D->m12, Jo_2d), Jo_2 = fmaf(Ji->m, D->m13, Jo_2f);
  const float Jo_3b = KSL_MULF(Ji->mt.x, D->m20), Jo_3d = fmaf(Ji->mt.y, D->m21, Jo_3b),
      Jo_3f = fmaf(Ji->mt.z, D->m22, Jo_3d), Jo_3 = fmaf(Ji->m, D->m23, Jo_3f);
  const float Jo_4a = KSL_MULF(D->m00, RI_0), Jo_4c = fmaf(D->m01, RI_1, Jo_4a),
      Jo_4 = fmaf(D->m02, RI_2, Jo_4c);
  const float Jo_5a = KSL_MULF(D->m10, RI_3), Jo_5c = fmaf(D->m11, RI_4, Jo_5a),
      Jo_5 = fmaf(D->m12, RI_5, Jo_5c);
  const float Jo_6a = KSL_MULF(D->m20, RI_6), Jo_6c = fmaf(D->m21, RI_7, Jo_6a),
      Jo_6 = fmaf(D->m22, RI_8, Jo_6c);
  const float Jo_7a = KSL_MULF(D->m10, RI_0), Jo_7c = fmaf(D->m11, RI_1, Jo_7a),
      Jo_7 = fmaf(D->m12, RI_2, Jo_7c);
  const float Jo_8a = KSL_MULF(D->m20, RI_3), Jo_8c = fmaf(D->m21, RI_4, Jo_8a),
      Jo_8 = fmaf(D->m22, RI_5, Jo_8c);
  const float Jo_9a = KSL_MULF(D->m20, RI_0), Jo_9c = fmaf(D->m21, RI_1, Jo_9a),
      Jo_9 = fmaf(D->m22, RI_2, Jo_9c);
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
}

/* self = self displaced by D = [R | t]: m, R mt + m t, R I R^T.
   self: inertia (m in kg; mt = m c in kg m; I about the centre of mass c, xx, yy, zz, xy, yz, zx
     in kg m^2); D: displacement [R | t], R rotation, t in m.
   18 mul, 39 fma.
   Error <= u |result| + (m: 0, mt: 3, I: 5) u S, S the sum of the |terms| of the expanded
     formula; barring over- and underflow. */
static inline void ksl_inertiaf_transform_fused(ksl_inertiaf_t *self, const ksl_SE3f_t *D) {
  const float RI_0a = KSL_MULF(self->Ixx, D->m00), RI_0c = fmaf(self->Ixy, D->m01, RI_0a),
      RI_0 = fmaf(self->Izx, D->m02, RI_0c);
  const float RI_1a = KSL_MULF(self->Iyy, D->m01), RI_1c = fmaf(self->Ixy, D->m00, RI_1a),
      RI_1 = fmaf(self->Iyz, D->m02, RI_1c);
  const float RI_2a = KSL_MULF(self->Izz, D->m02), RI_2c = fmaf(self->Iyz, D->m01, RI_2a),
      RI_2 = fmaf(self->Izx, D->m00, RI_2c);
  const float RI_3a = KSL_MULF(self->Ixx, D->m10), RI_3c = fmaf(self->Ixy, D->m11, RI_3a),
      RI_3 = fmaf(self->Izx, D->m12, RI_3c);
  const float RI_4a = KSL_MULF(self->Iyy, D->m11), RI_4c = fmaf(self->Ixy, D->m10, RI_4a),
      RI_4 = fmaf(self->Iyz, D->m12, RI_4c);
  const float RI_5a = KSL_MULF(self->Izz, D->m12), RI_5c = fmaf(self->Iyz, D->m11, RI_5a),
      RI_5 = fmaf(self->Izx, D->m10, RI_5c);
  const float RI_6a = KSL_MULF(self->Ixx, D->m20), RI_6c = fmaf(self->Ixy, D->m21, RI_6a),
      RI_6 = fmaf(self->Izx, D->m22, RI_6c);
  const float RI_7a = KSL_MULF(self->Iyy, D->m21), RI_7c = fmaf(self->Ixy, D->m20, RI_7a),
      RI_7 = fmaf(self->Iyz, D->m22, RI_7c);
  const float RI_8a = KSL_MULF(self->Izz, D->m22), RI_8c = fmaf(self->Iyz, D->m21, RI_8a),
      RI_8 = fmaf(self->Izx, D->m20, RI_8c);
  const float self_1_new_b = KSL_MULF(self->mt.x, D->m00),
      self_1_new_d = fmaf(self->mt.y, D->m01, self_1_new_b),
      self_1_new_f = fmaf(self->mt.z, D->m02, self_1_new_d),
      self_1_new = fmaf(self->m, D->m03, self_1_new_f);
  const float self_2_new_b = KSL_MULF(self->mt.x, D->m10),
      self_2_new_d = fmaf(self->mt.y, D->m11, self_2_new_b),
      self_2_new_f = fmaf(self->mt.z, D->m12, self_2_new_d),
      self_2_new = fmaf(self->m, D->m13, self_2_new_f);
  const float self_3_new_b = KSL_MULF(self->mt.x, D->m20),
      self_3_new_d = fmaf(self->mt.y, D->m21, self_3_new_b),
      self_3_new_f = fmaf(self->mt.z, D->m22, self_3_new_d),
      self_3_new = fmaf(self->m, D->m23, self_3_new_f);
  const float self_4_new_a = KSL_MULF(D->m00, RI_0),
      self_4_new_c = fmaf(D->m01, RI_1, self_4_new_a),
      self_4_new = fmaf(D->m02, RI_2, self_4_new_c);
  const float self_5_new_a = KSL_MULF(D->m10, RI_3),
      self_5_new_c = fmaf(D->m11, RI_4, self_5_new_a),
      self_5_new = fmaf(D->m12, RI_5, self_5_new_c);
  const float self_6_new_a = KSL_MULF(D->m20, RI_6),
      self_6_new_c = fmaf(D->m21, RI_7, self_6_new_a),
      self_6_new = fmaf(D->m22, RI_8, self_6_new_c);
  const float self_7_new_a = KSL_MULF(D->m10, RI_0),
      self_7_new_c = fmaf(D->m11, RI_1, self_7_new_a),
      self_7_new = fmaf(D->m12, RI_2, self_7_new_c);
  const float self_8_new_a = KSL_MULF(D->m20, RI_3),
      self_8_new_c = fmaf(D->m21, RI_4, self_8_new_a),
      self_8_new = fmaf(D->m22, RI_5, self_8_new_c);
  const float self_9_new_a = KSL_MULF(D->m20, RI_0),
      self_9_new_c = fmaf(D->m21, RI_1, self_9_new_a),
      self_9_new = fmaf(D->m22, RI_2, self_9_new_c);
  self->mt.x = self_1_new;
  self->mt.y = self_2_new;
  self->mt.z = self_3_new;
  self->Ixx = self_4_new;
  self->Iyy = self_5_new;
  self->Izz = self_6_new;
  self->Ixy = self_7_new;
  self->Iyz = self_8_new;
  self->Izx = self_9_new;
}

#endif
