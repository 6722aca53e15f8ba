/* Made by `coscrew generate`; changes are overwritten. */
/* SPDX-License-Identifier: MIT */
/* coscrew 0.2.0.  Copyright (c) 2026 The coscrew authors. */
/* Inertias of rigid bodies: mass, mass times centre of mass, moments about the centre of mass. */
#ifndef KSL_INERTIA_H
#define KSL_INERTIA_H

#include "ksl_types.h"
#include "SE3.h"

/* J = (m; m t; Ixx, Iyy, Izz, Ixy, Iyz, Izx): mass, centre of mass t in m, entries of the
     moments' matrix about it in kg m^2, Ixy = -∫ x y dm.
   m, Ixx, Iyy, Izz, Ixy, Iyz, Izx: number; t: vector.
   3 mul.
   Error <= u |result|, barring over- and underflow. */
static inline ksl_inertia_t ksl_inertia(const double m, const ksl_vec3_t t, const double Ixx,
    const double Iyy, const double Izz, const double Ixy, const double Iyz,
    const double Izx) {
  const double J_1 = KSL_MUL(m, t.x), J_2 = KSL_MUL(m, t.y), J_3 = KSL_MUL(m, t.z);
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

/* Jo = Ji.
   Ji, Jo: inertia (m in kg; mt = m c in kg m; I about the centre of mass c, xx, yy, zz, xy, yz,
     zx in kg m^2).
   No arithmetic.
   Exact. */
static inline void ksl_inertia_copy(const ksl_inertia_t *Ji, ksl_inertia_t *Jo) {
  const double Ji_m = Ji->m;
  const double Ji_mt_x = Ji->mt.x;
  const double Ji_mt_y = Ji->mt.y;
  const double Ji_mt_z = Ji->mt.z;
  const double Ji_Ixx = Ji->Ixx;
  const double Ji_Iyy = Ji->Iyy;
  const double Ji_Izz = Ji->Izz;
  const double Ji_Ixy = Ji->Ixy;
  const double Ji_Iyz = Ji->Iyz;
  const double Ji_Izx = Ji->Izx;
  Jo->m = Ji_m;
  Jo->mt.x = Ji_mt_x;
  Jo->mt.y = Ji_mt_y;
  Jo->mt.z = Ji_mt_z;
  Jo->Ixx = Ji_Ixx;
  Jo->Iyy = Ji_Iyy;
  Jo->Izz = Ji_Izz;
  Jo->Ixy = Ji_Ixy;
  Jo->Iyz = Ji_Iyz;
  Jo->Izx = Ji_Izx;
}

/* Jo = Ji rotated by R: m, R mt, R I R^T.
   Ji, Jo: inertia (m in kg; mt = m c in kg m; I about the centre of mass c, xx, yy, zz, xy, yz,
     zx in kg m^2); R: rotation or other 3×3 matrix.
   54 mul, 36 add.
   Error <= u |result| + (m: 0, mt: 2, I: 5) u S, S the sum of the |terms| of the expanded
     formula; barring over- and underflow. */
static inline void ksl_inertia_rotated(const ksl_inertia_t *Ji, const ksl_mat3x3_t *R,
    ksl_inertia_t *Jo) {
  const double RI_0 = KSL_MUL(Ji->Ixx, R->m00) + KSL_MUL(Ji->Ixy, R->m01)
          + KSL_MUL(Ji->Izx, R->m02),
      RI_1 = KSL_MUL(Ji->Iyy, R->m01) + KSL_MUL(Ji->Ixy, R->m00) + KSL_MUL(Ji->Iyz, R->m02),
      RI_2 = KSL_MUL(Ji->Izz, R->m02) + KSL_MUL(Ji->Iyz, R->m01) + KSL_MUL(Ji->Izx, R->m00),
      RI_3 = KSL_MUL(Ji->Ixx, R->m10) + KSL_MUL(Ji->Ixy, R->m11) + KSL_MUL(Ji->Izx, R->m12),
      RI_4 = KSL_MUL(Ji->Iyy, R->m11) + KSL_MUL(Ji->Ixy, R->m10) + KSL_MUL(Ji->Iyz, R->m12),
      RI_5 = KSL_MUL(Ji->Izz, R->m12) + KSL_MUL(Ji->Iyz, R->m11) + KSL_MUL(Ji->Izx, R->m10),
      RI_6 = KSL_MUL(Ji->Ixx, R->m20) + KSL_MUL(Ji->Ixy, R->m21) + KSL_MUL(Ji->Izx, R->m22),
      RI_7 = KSL_MUL(Ji->Iyy, R->m21) + KSL_MUL(Ji->Ixy, R->m20) + KSL_MUL(Ji->Iyz, R->m22),
      RI_8 = KSL_MUL(Ji->Izz, R->m22) + KSL_MUL(Ji->Iyz, R->m21) + KSL_MUL(Ji->Izx, R->m20);
  const double Jo_1 = KSL_MUL(Ji->mt.x, R->m00) + KSL_MUL(Ji->mt.y, R->m01)
          + KSL_MUL(Ji->mt.z, R->m02),
      Jo_2 = KSL_MUL(Ji->mt.x, R->m10) + KSL_MUL(Ji->mt.y, R->m11) + KSL_MUL(Ji->mt.z, R->m12),
      Jo_3 = KSL_MUL(Ji->mt.x, R->m20) + KSL_MUL(Ji->mt.y, R->m21) + KSL_MUL(Ji->mt.z, R->m22),
      Jo_4 = KSL_MUL(R->m00, RI_0) + KSL_MUL(R->m01, RI_1) + KSL_MUL(R->m02, RI_2),
      Jo_5 = KSL_MUL(R->m10, RI_3) + KSL_MUL(R->m11, RI_4) + KSL_MUL(R->m12, RI_5),
      Jo_6 = KSL_MUL(R->m20, RI_6) + KSL_MUL(R->m21, RI_7) + KSL_MUL(R->m22, RI_8),
      Jo_7 = KSL_MUL(R->m10, RI_0) + KSL_MUL(R->m11, RI_1) + KSL_MUL(R->m12, RI_2),
      Jo_8 = KSL_MUL(R->m20, RI_3) + KSL_MUL(R->m21, RI_4) + KSL_MUL(R->m22, RI_5),
      Jo_9 = KSL_MUL(R->m20, RI_0) + KSL_MUL(R->m21, RI_1) + KSL_MUL(R->m22, RI_2);
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
   54 mul, 36 add.
   Error <= u |result| + (m: 0, mt: 2, I: 5) u S, S the sum of the |terms| of the expanded
     formula; barring over- and underflow. */
static inline void ksl_inertia_rotate(ksl_inertia_t *self, const ksl_mat3x3_t *R) {
  const double RI_0 = KSL_MUL(self->Ixx, R->m00) + KSL_MUL(self->Ixy, R->m01)
          + KSL_MUL(self->Izx, R->m02),
      RI_1 = KSL_MUL(self->Iyy, R->m01) + KSL_MUL(self->Ixy, R->m00) + KSL_MUL(self->Iyz, R->m02),
      RI_2 = KSL_MUL(self->Izz, R->m02) + KSL_MUL(self->Iyz, R->m01) + KSL_MUL(self->Izx, R->m00),
      RI_3 = KSL_MUL(self->Ixx, R->m10) + KSL_MUL(self->Ixy, R->m11) + KSL_MUL(self->Izx, R->m12),
      RI_4 = KSL_MUL(self->Iyy, R->m11) + KSL_MUL(self->Ixy, R->m10) + KSL_MUL(self->Iyz, R->m12),
      RI_5 = KSL_MUL(self->Izz, R->m12) + KSL_MUL(self->Iyz, R->m11) + KSL_MUL(self->Izx, R->m10),
      RI_6 = KSL_MUL(self->Ixx, R->m20) + KSL_MUL(self->Ixy, R->m21) + KSL_MUL(self->Izx, R->m22),
      RI_7 = KSL_MUL(self->Iyy, R->m21) + KSL_MUL(self->Ixy, R->m20) + KSL_MUL(self->Iyz, R->m22),
      RI_8 = KSL_MUL(self->Izz, R->m22) + KSL_MUL(self->Iyz, R->m21) + KSL_MUL(self->Izx, R->m20);
  const double self_1_new = KSL_MUL(self->mt.x, R->m00) + KSL_MUL(self->mt.y, R->m01)
          + KSL_MUL(self->mt.z, R->m02),
      self_2_new = KSL_MUL(self->mt.x, R->m10) + KSL_MUL(self->mt.y, R->m11)
          + KSL_MUL(self->mt.z, R->m12),
      self_3_new = KSL_MUL(self->mt.x, R->m20) + KSL_MUL(self->mt.y, R->m21)
          + KSL_MUL(self->mt.z, R->m22),
      self_4_new = KSL_MUL(R->m00, RI_0) + KSL_MUL(R->m01, RI_1) + KSL_MUL(R->m02, RI_2),
      self_5_new = KSL_MUL(R->m10, RI_3) + KSL_MUL(R->m11, RI_4) + KSL_MUL(R->m12, RI_5),
      self_6_new = KSL_MUL(R->m20, RI_6) + KSL_MUL(R->m21, RI_7) + KSL_MUL(R->m22, RI_8),
      self_7_new = KSL_MUL(R->m10, RI_0) + KSL_MUL(R->m11, RI_1) + KSL_MUL(R->m12, RI_2),
      self_8_new = KSL_MUL(R->m20, RI_3) + KSL_MUL(R->m21, RI_4) + KSL_MUL(R->m22, RI_5),
      self_9_new = KSL_MUL(R->m20, RI_0) + KSL_MUL(R->m21, RI_1) + KSL_MUL(R->m22, RI_2);
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
   3 mul, 3 add.
   Error <= u |result| + (m: 0, mt: 1, I: 0) u S, S the sum of the |terms| of the expanded
     formula; barring over- and underflow. */
static inline void ksl_inertia_translated(const ksl_inertia_t *Ji, const ksl_vec3_t *t,
    ksl_inertia_t *Jo) {
  const double Jo_1 = KSL_MUL(Ji->m, t->x) + Ji->mt.x, Jo_2 = KSL_MUL(Ji->m, t->y) + Ji->mt.y,
      Jo_3 = KSL_MUL(Ji->m, t->z) + Ji->mt.z;
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
   3 mul, 3 add.
   Error <= u |result| + (m: 0, mt: 1, I: 0) u S, S the sum of the |terms| of the expanded
     formula; barring over- and underflow. */
static inline void ksl_inertia_translate(ksl_inertia_t *self, const ksl_vec3_t *t) {
  const double self_1_new = KSL_MUL(self->m, t->x) + self->mt.x,
      self_2_new = KSL_MUL(self->m, t->y) + self->mt.y,
      self_3_new = KSL_MUL(self->m, t->z) + self->mt.z;
  self->mt.x = self_1_new;
  self->mt.y = self_2_new;
  self->mt.z = self_3_new;
}

/* Jo = Ji displaced by D = [R | t]: m, R mt + m t, R I R^T.
   Ji, Jo: inertia (m in kg; mt = m c in kg m; I about the centre of mass c, xx, yy, zz, xy, yz,
     zx in kg m^2); D: displacement [R | t], R rotation, t in m.
   57 mul, 39 add.
   Error <= u |result| + (m: 0, mt: 3, I: 5) u S, S the sum of the |terms| of the expanded
     formula; barring over- and underflow. */
static inline void ksl_inertia_transformed(const ksl_inertia_t *Ji, const ksl_SE3_t *D,
    ksl_inertia_t *Jo) {
  const double RI_0 = KSL_MUL(Ji->Ixx, D->m00) + KSL_MUL(Ji->Ixy, D->m01)
          + KSL_MUL(Ji->Izx, D->m02),
      RI_1 = KSL_MUL(Ji->Iyy, D->m01) + KSL_MUL(Ji->Ixy, D->m00) + KSL_MUL(Ji->Iyz, D->m02),
      RI_2 = KSL_MUL(Ji->Izz, D->m02) + KSL_MUL(Ji->Iyz, D->m01) + KSL_MUL(Ji->Izx, D->m00),
      RI_3 = KSL_MUL(Ji->Ixx, D->m10) + KSL_MUL(Ji->Ixy, D->m11) + KSL_MUL(Ji->Izx, D->m12),
      RI_4 = KSL_MUL(Ji->Iyy, D->m11) + KSL_MUL(Ji->Ixy, D->m10) + KSL_MUL(Ji->Iyz, D->m12),
      RI_5 = KSL_MUL(Ji->Izz, D->m12) + KSL_MUL(Ji->Iyz, D->m11) + KSL_MUL(Ji->Izx, D->m10),
      RI_6 = KSL_MUL(Ji->Ixx, D->m20) + KSL_MUL(Ji->Ixy, D->m21) + KSL_MUL(Ji->Izx, D->m22),
      RI_7 = KSL_MUL(Ji->Iyy, D->m21) + KSL_MUL(Ji->Ixy, D->m20) + KSL_MUL(Ji->Iyz, D->m22),
      RI_8 = KSL_MUL(Ji->Izz, D->m22) + KSL_MUL(Ji->Iyz, D->m21) + KSL_MUL(Ji->Izx, D->m20);
  const double Jo_1 = KSL_MUL(Ji->m, D->m03)
          + (KSL_MUL(Ji->mt.x, D->m00) + KSL_MUL(Ji->mt.y, D->m01) + KSL_MUL(Ji->mt.z, D->m02)),
      Jo_2 = KSL_MUL(Ji->m, D->m13)
          + (KSL_MUL(Ji->mt.x, D->m10) + KSL_MUL(Ji->mt.y, D->m11) + KSL_MUL(Ji->mt.z, D->m12)),
      Jo_3 = KSL_MUL(Ji->m, D->m23)
          + (KSL_MUL(Ji->mt.x, D->m20) + KSL_MUL(Ji->mt.y, D->m21) + KSL_MUL(Ji->mt.z, D->m22)),
      Jo_4 = KSL_MUL(D->m00, RI_0) + KSL_MUL(D->m01, RI_1) + KSL_MUL(D->m02, RI_2),
      Jo_5 = KSL_MUL(D->m10, RI_3) + KSL_MUL(D->m11, RI_4) + KSL_MUL(D->m12, RI_5),
      Jo_6 = KSL_MUL(D->m20, RI_6) + KSL_MUL(D->m21, RI_7) + KSL_MUL(D->m22, RI_8),
      Jo_7 = KSL_MUL(D->m10, RI_0) + KSL_MUL(D->m11, RI_1) + KSL_MUL(D->m12, RI_2),
      Jo_8 = KSL_MUL(D->m20, RI_3) + KSL_MUL(D->m21, RI_4) + KSL_MUL(D->m22, RI_5),
      Jo_9 = KSL_MUL(D->m20, RI_0) + KSL_MUL(D->m21, RI_1) + KSL_MUL(D->m22, RI_2);
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
   57 mul, 39 add.
   Error <= u |result| + (m: 0, mt: 3, I: 5) u S, S the sum of the |terms| of the expanded
     formula; barring over- and underflow. */
static inline void ksl_inertia_transform(ksl_inertia_t *self, const ksl_SE3_t *D) {
  const double RI_0 = KSL_MUL(self->Ixx, D->m00) + KSL_MUL(self->Ixy, D->m01)
          + KSL_MUL(self->Izx, D->m02),
      RI_1 = KSL_MUL(self->Iyy, D->m01) + KSL_MUL(self->Ixy, D->m00) + KSL_MUL(self->Iyz, D->m02),
      RI_2 = KSL_MUL(self->Izz, D->m02) + KSL_MUL(self->Iyz, D->m01) + KSL_MUL(self->Izx, D->m00),
      RI_3 = KSL_MUL(self->Ixx, D->m10) + KSL_MUL(self->Ixy, D->m11) + KSL_MUL(self->Izx, D->m12),
      RI_4 = KSL_MUL(self->Iyy, D->m11) + KSL_MUL(self->Ixy, D->m10) + KSL_MUL(self->Iyz, D->m12),
      RI_5 = KSL_MUL(self->Izz, D->m12) + KSL_MUL(self->Iyz, D->m11) + KSL_MUL(self->Izx, D->m10),
      RI_6 = KSL_MUL(self->Ixx, D->m20) + KSL_MUL(self->Ixy, D->m21) + KSL_MUL(self->Izx, D->m22),
      RI_7 = KSL_MUL(self->Iyy, D->m21) + KSL_MUL(self->Ixy, D->m20) + KSL_MUL(self->Iyz, D->m22),
      RI_8 = KSL_MUL(self->Izz, D->m22) + KSL_MUL(self->Iyz, D->m21) + KSL_MUL(self->Izx, D->m20);
  const double self_1_new = KSL_MUL(self->m, D->m03)
          + (KSL_MUL(self->mt.x, D->m00) + KSL_MUL(self->mt.y, D->m01)
          + KSL_MUL(self->mt.z, D->m02)),
      self_2_new = KSL_MUL(self->m, D->m13)
          + (KSL_MUL(self->mt.x, D->m10) + KSL_MUL(self->mt.y, D->m11)
          + KSL_MUL(self->mt.z, D->m12)),
      self_3_new = KSL_MUL(self->m, D->m23)
          + (KSL_MUL(self->mt.x, D->m20) + KSL_MUL(self->mt.y, D->m21)
          + KSL_MUL(self->mt.z, D->m22)),
      self_4_new = KSL_MUL(D->m00, RI_0) + KSL_MUL(D->m01, RI_1) + KSL_MUL(D->m02, RI_2),
      self_5_new = KSL_MUL(D->m10, RI_3) + KSL_MUL(D->m11, RI_4) + KSL_MUL(D->m12, RI_5),
      self_6_new = KSL_MUL(D->m20, RI_6) + KSL_MUL(D->m21, RI_7) + KSL_MUL(D->m22, RI_8),
      self_7_new = KSL_MUL(D->m10, RI_0) + KSL_MUL(D->m11, RI_1) + KSL_MUL(D->m12, RI_2),
      self_8_new = KSL_MUL(D->m20, RI_3) + KSL_MUL(D->m21, RI_4) + KSL_MUL(D->m22, RI_5),
      self_9_new = KSL_MUL(D->m20, RI_0) + KSL_MUL(D->m21, RI_1) + KSL_MUL(D->m22, RI_2);
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

/* Ji = the inertia of two joined bodies: Ji, and Jj displaced by D_ij = [R | t]: m_i + m_j, mt_i
     + m_j c, I_i + R I_j R^T + m_i m_j/(m_i + m_j) (d·d 1 - d d^T) with c = R t_jc + t, d = c -
     t_ic; t_ic = mt_i / m_i and t_jc = mt_j / m_j are the centres of mass, each in its own
     frame; NaN where m_i + m_j = 0.
   Ji, Jj: inertia (m in kg; mt = m c in kg m; I about the centre of mass c, xx, yy, zz, xy, yz,
     zx in kg m^2); t_ic, t_jc: vector; D_ij: displacement [R | t], R rotation, t in m.
   67 mul, 61 add, 1 div.
   Error <= 18 u times the sum of the absolute values of all terms, for masses that are not
     negative, barring over- and underflow. */
static inline void ksl_inertia_merge(ksl_inertia_t *Ji, const ksl_vec3_t *t_ic,
    const ksl_inertia_t *Jj, const ksl_vec3_t *t_jc, const ksl_SE3_t *D_ij) {
  const double m = Ji->m + Jj->m;
  const double c_0 = KSL_MUL(t_jc->x, D_ij->m00) + KSL_MUL(t_jc->y, D_ij->m01)
          + KSL_MUL(t_jc->z, D_ij->m02) + D_ij->m03,
      c_1 = KSL_MUL(t_jc->x, D_ij->m10) + KSL_MUL(t_jc->y, D_ij->m11) + KSL_MUL(t_jc->z, D_ij->m12)
          + D_ij->m13,
      c_2 = KSL_MUL(t_jc->x, D_ij->m20) + KSL_MUL(t_jc->y, D_ij->m21) + KSL_MUL(t_jc->z, D_ij->m22)
          + D_ij->m23;
  const double d_0 = c_0 - t_ic->x, d_1 = c_1 - t_ic->y, d_2 = c_2 - t_ic->z;
  const double part = Jj->m / m;
  const double reduced = KSL_MUL(Ji->m, part);
  const double p_0 = KSL_MUL(d_0, reduced), p_1 = KSL_MUL(d_1, reduced),
      p_2 = KSL_MUL(d_2, reduced);
  const double squares_0 = KSL_MUL(d_0, p_0), squares_1 = KSL_MUL(d_1, p_1),
      squares_2 = KSL_MUL(d_2, p_2);
  const double RI_0 = KSL_MUL(Jj->Ixx, D_ij->m00) + KSL_MUL(Jj->Ixy, D_ij->m01)
          + KSL_MUL(Jj->Izx, D_ij->m02),
      RI_1 = KSL_MUL(Jj->Iyy, D_ij->m01) + KSL_MUL(Jj->Ixy, D_ij->m00)
          + KSL_MUL(Jj->Iyz, D_ij->m02),
      RI_2 = KSL_MUL(Jj->Izz, D_ij->m02) + KSL_MUL(Jj->Iyz, D_ij->m01)
          + KSL_MUL(Jj->Izx, D_ij->m00),
      RI_3 = KSL_MUL(Jj->Ixx, D_ij->m10) + KSL_MUL(Jj->Ixy, D_ij->m11)
          + KSL_MUL(Jj->Izx, D_ij->m12),
      RI_4 = KSL_MUL(Jj->Iyy, D_ij->m11) + KSL_MUL(Jj->Ixy, D_ij->m10)
          + KSL_MUL(Jj->Iyz, D_ij->m12),
      RI_5 = KSL_MUL(Jj->Izz, D_ij->m12) + KSL_MUL(Jj->Iyz, D_ij->m11)
          + KSL_MUL(Jj->Izx, D_ij->m10),
      RI_6 = KSL_MUL(Jj->Ixx, D_ij->m20) + KSL_MUL(Jj->Ixy, D_ij->m21)
          + KSL_MUL(Jj->Izx, D_ij->m22),
      RI_7 = KSL_MUL(Jj->Iyy, D_ij->m21) + KSL_MUL(Jj->Ixy, D_ij->m20)
          + KSL_MUL(Jj->Iyz, D_ij->m22),
      RI_8 = KSL_MUL(Jj->Izz, D_ij->m22) + KSL_MUL(Jj->Iyz, D_ij->m21)
          + KSL_MUL(Jj->Izx, D_ij->m20);
  const double Ji_1_new = Ji->mt.x + KSL_MUL(Jj->m, c_0), Ji_2_new = Ji->mt.y + KSL_MUL(Jj->m, c_1),
      Ji_3_new = Ji->mt.z + KSL_MUL(Jj->m, c_2),
      Ji_4_new = Ji->Ixx
          + (KSL_MUL(D_ij->m00, RI_0) + KSL_MUL(D_ij->m01, RI_1) + KSL_MUL(D_ij->m02, RI_2))
          + (squares_1 + squares_2),
      Ji_5_new = Ji->Iyy
          + (KSL_MUL(D_ij->m10, RI_3) + KSL_MUL(D_ij->m11, RI_4) + KSL_MUL(D_ij->m12, RI_5))
          + (squares_0 + squares_2),
      Ji_6_new = Ji->Izz
          + (KSL_MUL(D_ij->m20, RI_6) + KSL_MUL(D_ij->m21, RI_7) + KSL_MUL(D_ij->m22, RI_8))
          + (squares_0 + squares_1),
      Ji_7_new = Ji->Ixy
          + (KSL_MUL(D_ij->m10, RI_0) + KSL_MUL(D_ij->m11, RI_1) + KSL_MUL(D_ij->m12, RI_2))
          - KSL_MUL(d_1, p_0),
      Ji_8_new = Ji->Iyz
          + (KSL_MUL(D_ij->m20, RI_3) + KSL_MUL(D_ij->m21, RI_4) + KSL_MUL(D_ij->m22, RI_5))
          - KSL_MUL(d_2, p_1),
      Ji_9_new = Ji->Izx
          + (KSL_MUL(D_ij->m20, RI_0) + KSL_MUL(D_ij->m21, RI_1) + KSL_MUL(D_ij->m22, RI_2))
          - KSL_MUL(d_2, p_0);
  Ji->m = m;
  Ji->mt.x = Ji_1_new;
  Ji->mt.y = Ji_2_new;
  Ji->mt.z = Ji_3_new;
  Ji->Ixx = Ji_4_new;
  Ji->Iyy = Ji_5_new;
  Ji->Izz = Ji_6_new;
  Ji->Ixy = Ji_7_new;
  Ji->Iyz = Ji_8_new;
  Ji->Izx = Ji_9_new;
}

/* J = (m; m t; Ixx, Iyy, Izz, Ixy, Iyz, Izx): mass, centre of mass t in m, entries of the
     moments' matrix about it in kg m^2, Ixy = -∫ x y dm.
   m, Ixx, Iyy, Izz, Ixy, Iyz, Izx: number; t: vector.
   3 mul.
   Error <= u |result|, barring over- and underflow. */
static inline ksl_inertiaf_t ksl_inertiaf(const float m, const ksl_vec3f_t t, const float Ixx,
    const float Iyy, const float Izz, const float Ixy, const float Iyz,
    const float Izx) {
  const float J_1 = KSL_MULF(m, t.x), J_2 = KSL_MULF(m, t.y), J_3 = KSL_MULF(m, t.z);
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

/* Jo = Ji.
   Ji, Jo: inertia (m in kg; mt = m c in kg m; I about the centre of mass c, xx, yy, zz, xy, yz,
     zx in kg m^2).
   No arithmetic.
   Exact. */
static inline void ksl_inertiaf_copy(const ksl_inertiaf_t *Ji, ksl_inertiaf_t *Jo) {
  const float Ji_m = Ji->m;
  const float Ji_mt_x = Ji->mt.x;
  const float Ji_mt_y = Ji->mt.y;
  const float Ji_mt_z = Ji->mt.z;
  const float Ji_Ixx = Ji->Ixx;
  const float Ji_Iyy = Ji->Iyy;
  const float Ji_Izz = Ji->Izz;
  const float Ji_Ixy = Ji->Ixy;
  const float Ji_Iyz = Ji->Iyz;
  const float Ji_Izx = Ji->Izx;
  Jo->m = Ji_m;
  Jo->mt.x = Ji_mt_x;
  Jo->mt.y = Ji_mt_y;
  Jo->mt.z = Ji_mt_z;
  Jo->Ixx = Ji_Ixx;
  Jo->Iyy = Ji_Iyy;
  Jo->Izz = Ji_Izz;
  Jo->Ixy = Ji_Ixy;
  Jo->Iyz = Ji_Iyz;
  Jo->Izx = Ji_Izx;
}

/* Jo = Ji rotated by R: m, R mt, R I R^T.
   Ji, Jo: inertia (m in kg; mt = m c in kg m; I about the centre of mass c, xx, yy, zz, xy, yz,
     zx in kg m^2); R: rotation or other 3×3 matrix.
   54 mul, 36 add.
   Error <= u |result| + (m: 0, mt: 2, I: 5) u S, S the sum of the |terms| of the expanded
     formula; barring over- and underflow. */
static inline void ksl_inertiaf_rotated(const ksl_inertiaf_t *Ji, const ksl_mat3x3f_t *R,
    ksl_inertiaf_t *Jo) {
  const float RI_0 = KSL_MULF(Ji->Ixx, R->m00) + KSL_MULF(Ji->Ixy, R->m01)
          + KSL_MULF(Ji->Izx, R->m02),
      RI_1 = KSL_MULF(Ji->Iyy, R->m01) + KSL_MULF(Ji->Ixy, R->m00) + KSL_MULF(Ji->Iyz, R->m02),
      RI_2 = KSL_MULF(Ji->Izz, R->m02) + KSL_MULF(Ji->Iyz, R->m01) + KSL_MULF(Ji->Izx, R->m00),
      RI_3 = KSL_MULF(Ji->Ixx, R->m10) + KSL_MULF(Ji->Ixy, R->m11) + KSL_MULF(Ji->Izx, R->m12),
      RI_4 = KSL_MULF(Ji->Iyy, R->m11) + KSL_MULF(Ji->Ixy, R->m10) + KSL_MULF(Ji->Iyz, R->m12),
      RI_5 = KSL_MULF(Ji->Izz, R->m12) + KSL_MULF(Ji->Iyz, R->m11) + KSL_MULF(Ji->Izx, R->m10),
      RI_6 = KSL_MULF(Ji->Ixx, R->m20) + KSL_MULF(Ji->Ixy, R->m21) + KSL_MULF(Ji->Izx, R->m22),
      RI_7 = KSL_MULF(Ji->Iyy, R->m21) + KSL_MULF(Ji->Ixy, R->m20) + KSL_MULF(Ji->Iyz, R->m22),
      RI_8 = KSL_MULF(Ji->Izz, R->m22) + KSL_MULF(Ji->Iyz, R->m21) + KSL_MULF(Ji->Izx, R->m20);
  const float Jo_1 = KSL_MULF(Ji->mt.x, R->m00) + KSL_MULF(Ji->mt.y, R->m01)
          + KSL_MULF(Ji->mt.z, R->m02),
      Jo_2 = KSL_MULF(Ji->mt.x, R->m10) + KSL_MULF(Ji->mt.y, R->m11) + KSL_MULF(Ji->mt.z, R->m12),
      Jo_3 = KSL_MULF(Ji->mt.x, R->m20) + KSL_MULF(Ji->mt.y, R->m21) + KSL_MULF(Ji->mt.z, R->m22),
      Jo_4 = KSL_MULF(R->m00, RI_0) + KSL_MULF(R->m01, RI_1) + KSL_MULF(R->m02, RI_2),
      Jo_5 = KSL_MULF(R->m10, RI_3) + KSL_MULF(R->m11, RI_4) + KSL_MULF(R->m12, RI_5),
      Jo_6 = KSL_MULF(R->m20, RI_6) + KSL_MULF(R->m21, RI_7) + KSL_MULF(R->m22, RI_8),
      Jo_7 = KSL_MULF(R->m10, RI_0) + KSL_MULF(R->m11, RI_1) + KSL_MULF(R->m12, RI_2),
      Jo_8 = KSL_MULF(R->m20, RI_3) + KSL_MULF(R->m21, RI_4) + KSL_MULF(R->m22, RI_5),
      Jo_9 = KSL_MULF(R->m20, RI_0) + KSL_MULF(R->m21, RI_1) + KSL_MULF(R->m22, RI_2);
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
   54 mul, 36 add.
   Error <= u |result| + (m: 0, mt: 2, I: 5) u S, S the sum of the |terms| of the expanded
     formula; barring over- and underflow. */
static inline void ksl_inertiaf_rotate(ksl_inertiaf_t *self, const ksl_mat3x3f_t *R) {
  const float RI_0 = KSL_MULF(self->Ixx, R->m00) + KSL_MULF(self->Ixy, R->m01)
          + KSL_MULF(self->Izx, R->m02),
      RI_1 = KSL_MULF(self->Iyy, R->m01) + KSL_MULF(self->Ixy, R->m00)
          + KSL_MULF(self->Iyz, R->m02),
      RI_2 = KSL_MULF(self->Izz, R->m02) + KSL_MULF(self->Iyz, R->m01)
          + KSL_MULF(self->Izx, R->m00),
      RI_3 = KSL_MULF(self->Ixx, R->m10) + KSL_MULF(self->Ixy, R->m11)
          + KSL_MULF(self->Izx, R->m12),
      RI_4 = KSL_MULF(self->Iyy, R->m11) + KSL_MULF(self->Ixy, R->m10)
          + KSL_MULF(self->Iyz, R->m12),
      RI_5 = KSL_MULF(self->Izz, R->m12) + KSL_MULF(self->Iyz, R->m11)
          + KSL_MULF(self->Izx, R->m10),
      RI_6 = KSL_MULF(self->Ixx, R->m20) + KSL_MULF(self->Ixy, R->m21)
          + KSL_MULF(self->Izx, R->m22),
      RI_7 = KSL_MULF(self->Iyy, R->m21) + KSL_MULF(self->Ixy, R->m20)
          + KSL_MULF(self->Iyz, R->m22),
      RI_8 = KSL_MULF(self->Izz, R->m22) + KSL_MULF(self->Iyz, R->m21)
          + KSL_MULF(self->Izx, R->m20);
  const float self_1_new = KSL_MULF(self->mt.x, R->m00) + KSL_MULF(self->mt.y, R->m01)
          + KSL_MULF(self->mt.z, R->m02),
      self_2_new = KSL_MULF(self->mt.x, R->m10) + KSL_MULF(self->mt.y, R->m11)
          + KSL_MULF(self->mt.z, R->m12),
      self_3_new = KSL_MULF(self->mt.x, R->m20) + KSL_MULF(self->mt.y, R->m21)
          + KSL_MULF(self->mt.z, R->m22),
      self_4_new = KSL_MULF(R->m00, RI_0) + KSL_MULF(R->m01, RI_1) + KSL_MULF(R->m02, RI_2),
      self_5_new = KSL_MULF(R->m10, RI_3) + KSL_MULF(R->m11, RI_4) + KSL_MULF(R->m12, RI_5),
      self_6_new = KSL_MULF(R->m20, RI_6) + KSL_MULF(R->m21, RI_7) + KSL_MULF(R->m22, RI_8),
      self_7_new = KSL_MULF(R->m10, RI_0) + KSL_MULF(R->m11, RI_1) + KSL_MULF(R->m12, RI_2),
      self_8_new = KSL_MULF(R->m20, RI_3) + KSL_MULF(R->m21, RI_4) + KSL_MULF(R->m22, RI_5),
      self_9_new = KSL_MULF(R->m20, RI_0) + KSL_MULF(R->m21, RI_1) + KSL_MULF(R->m22, RI_2);
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
   3 mul, 3 add.
   Error <= u |result| + (m: 0, mt: 1, I: 0) u S, S the sum of the |terms| of the expanded
     formula; barring over- and underflow. */
static inline void ksl_inertiaf_translated(const ksl_inertiaf_t *Ji, const ksl_vec3f_t *t,
    ksl_inertiaf_t *Jo) {
  const float Jo_1 = KSL_MULF(Ji->m, t->x) + Ji->mt.x, Jo_2 = KSL_MULF(Ji->m, t->y) + Ji->mt.y,
      Jo_3 = KSL_MULF(Ji->m, t->z) + Ji->mt.z;
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
   3 mul, 3 add.
   Error <= u |result| + (m: 0, mt: 1, I: 0) u S, S the sum of the |terms| of the expanded
     formula; barring over- and underflow. */
static inline void ksl_inertiaf_translate(ksl_inertiaf_t *self, const ksl_vec3f_t *t) {
  const float self_1_new = KSL_MULF(self->m, t->x) + self->mt.x,
      self_2_new = KSL_MULF(self->m, t->y) + self->mt.y,
      self_3_new = KSL_MULF(self->m, t->z) + self->mt.z;
  self->mt.x = self_1_new;
  self->mt.y = self_2_new;
  self->mt.z = self_3_new;
}

/* Jo = Ji displaced by D = [R | t]: m, R mt + m t, R I R^T.
   Ji, Jo: inertia (m in kg; mt = m c in kg m; I about the centre of mass c, xx, yy, zz, xy, yz,
     zx in kg m^2); D: displacement [R | t], R rotation, t in m.
   57 mul, 39 add.
   Error <= u |result| + (m: 0, mt: 3, I: 5) u S, S the sum of the |terms| of the expanded
     formula; barring over- and underflow. */
static inline void ksl_inertiaf_transformed(const ksl_inertiaf_t *Ji, const ksl_SE3f_t *D,
    ksl_inertiaf_t *Jo) {
  const float RI_0 = KSL_MULF(Ji->Ixx, D->m00) + KSL_MULF(Ji->Ixy, D->m01)
          + KSL_MULF(Ji->Izx, D->m02),
      RI_1 = KSL_MULF(Ji->Iyy, D->m01) + KSL_MULF(Ji->Ixy, D->m00) + KSL_MULF(Ji->Iyz, D->m02),
      RI_2 = KSL_MULF(Ji->Izz, D->m02) + KSL_MULF(Ji->Iyz, D->m01) + KSL_MULF(Ji->Izx, D->m00),
      RI_3 = KSL_MULF(Ji->Ixx, D->m10) + KSL_MULF(Ji->Ixy, D->m11) + KSL_MULF(Ji->Izx, D->m12),
      RI_4 = KSL_MULF(Ji->Iyy, D->m11) + KSL_MULF(Ji->Ixy, D->m10) + KSL_MULF(Ji->Iyz, D->m12),
      RI_5 = KSL_MULF(Ji->Izz, D->m12) + KSL_MULF(Ji->Iyz, D->m11) + KSL_MULF(Ji->Izx, D->m10),
      RI_6 = KSL_MULF(Ji->Ixx, D->m20) + KSL_MULF(Ji->Ixy, D->m21) + KSL_MULF(Ji->Izx, D->m22),
      RI_7 = KSL_MULF(Ji->Iyy, D->m21) + KSL_MULF(Ji->Ixy, D->m20) + KSL_MULF(Ji->Iyz, D->m22),
      RI_8 = KSL_MULF(Ji->Izz, D->m22) + KSL_MULF(Ji->Iyz, D->m21) + KSL_MULF(Ji->Izx, D->m20);
  const float Jo_1 = KSL_MULF(Ji->m, D->m03)
          + (KSL_MULF(Ji->mt.x, D->m00) + KSL_MULF(Ji->mt.y, D->m01) + KSL_MULF(Ji->mt.z, D->m02)),
      Jo_2 = KSL_MULF(Ji->m, D->m13)
          + (KSL_MULF(Ji->mt.x, D->m10) + KSL_MULF(Ji->mt.y, D->m11) + KSL_MULF(Ji->mt.z, D->m12)),
      Jo_3 = KSL_MULF(Ji->m, D->m23)
          + (KSL_MULF(Ji->mt.x, D->m20) + KSL_MULF(Ji->mt.y, D->m21) + KSL_MULF(Ji->mt.z, D->m22)),
      Jo_4 = KSL_MULF(D->m00, RI_0) + KSL_MULF(D->m01, RI_1) + KSL_MULF(D->m02, RI_2),
      Jo_5 = KSL_MULF(D->m10, RI_3) + KSL_MULF(D->m11, RI_4) + KSL_MULF(D->m12, RI_5),
      Jo_6 = KSL_MULF(D->m20, RI_6) + KSL_MULF(D->m21, RI_7) + KSL_MULF(D->m22, RI_8),
      Jo_7 = KSL_MULF(D->m10, RI_0) + KSL_MULF(D->m11, RI_1) + KSL_MULF(D->m12, RI_2),
      Jo_8 = KSL_MULF(D->m20, RI_3) + KSL_MULF(D->m21, RI_4) + KSL_MULF(D->m22, RI_5),
      Jo_9 = KSL_MULF(D->m20, RI_0) + KSL_MULF(D->m21, RI_1) + KSL_MULF(D->m22, RI_2);
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
   57 mul, 39 add.
   Error <= u |result| + (m: 0, mt: 3, I: 5) u S, S the sum of the |terms| of the expanded
     formula; barring over- and underflow. */
static inline void ksl_inertiaf_transform(ksl_inertiaf_t *self, const ksl_SE3f_t *D) {
  const float RI_0 = KSL_MULF(self->Ixx, D->m00) + KSL_MULF(self->Ixy, D->m01)
          + KSL_MULF(self->Izx, D->m02),
      RI_1 = KSL_MULF(self->Iyy, D->m01) + KSL_MULF(self->Ixy, D->m00)
          + KSL_MULF(self->Iyz, D->m02),
      RI_2 = KSL_MULF(self->Izz, D->m02) + KSL_MULF(self->Iyz, D->m01)
          + KSL_MULF(self->Izx, D->m00),
      RI_3 = KSL_MULF(self->Ixx, D->m10) + KSL_MULF(self->Ixy, D->m11)
          + KSL_MULF(self->Izx, D->m12),
      RI_4 = KSL_MULF(self->Iyy, D->m11) + KSL_MULF(self->Ixy, D->m10)
          + KSL_MULF(self->Iyz, D->m12),
      RI_5 = KSL_MULF(self->Izz, D->m12) + KSL_MULF(self->Iyz, D->m11)
          + KSL_MULF(self->Izx, D->m10),
      RI_6 = KSL_MULF(self->Ixx, D->m20) + KSL_MULF(self->Ixy, D->m21)
          + KSL_MULF(self->Izx, D->m22),
      RI_7 = KSL_MULF(self->Iyy, D->m21) + KSL_MULF(self->Ixy, D->m20)
          + KSL_MULF(self->Iyz, D->m22),
      RI_8 = KSL_MULF(self->Izz, D->m22) + KSL_MULF(self->Iyz, D->m21)
          + KSL_MULF(self->Izx, D->m20);
  const float self_1_new = KSL_MULF(self->m, D->m03)
          + (KSL_MULF(self->mt.x, D->m00) + KSL_MULF(self->mt.y, D->m01)
          + KSL_MULF(self->mt.z, D->m02)),
      self_2_new = KSL_MULF(self->m, D->m13)
          + (KSL_MULF(self->mt.x, D->m10) + KSL_MULF(self->mt.y, D->m11)
          + KSL_MULF(self->mt.z, D->m12)),
      self_3_new = KSL_MULF(self->m, D->m23)
          + (KSL_MULF(self->mt.x, D->m20) + KSL_MULF(self->mt.y, D->m21)
          + KSL_MULF(self->mt.z, D->m22)),
      self_4_new = KSL_MULF(D->m00, RI_0) + KSL_MULF(D->m01, RI_1) + KSL_MULF(D->m02, RI_2),
      self_5_new = KSL_MULF(D->m10, RI_3) + KSL_MULF(D->m11, RI_4) + KSL_MULF(D->m12, RI_5),
      self_6_new = KSL_MULF(D->m20, RI_6) + KSL_MULF(D->m21, RI_7) + KSL_MULF(D->m22, RI_8),
      self_7_new = KSL_MULF(D->m10, RI_0) + KSL_MULF(D->m11, RI_1) + KSL_MULF(D->m12, RI_2),
      self_8_new = KSL_MULF(D->m20, RI_3) + KSL_MULF(D->m21, RI_4) + KSL_MULF(D->m22, RI_5),
      self_9_new = KSL_MULF(D->m20, RI_0) + KSL_MULF(D->m21, RI_1) + KSL_MULF(D->m22, RI_2);
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

/* Ji = the inertia of two joined bodies: Ji, and Jj displaced by D_ij = [R | t]: m_i + m_j, mt_i
     + m_j c, I_i + R I_j R^T + m_i m_j/(m_i + m_j) (d·d 1 - d d^T) with c = R t_jc + t, d = c -
     t_ic; t_ic = mt_i / m_i and t_jc = mt_j / m_j are the centres of mass, each in its own
     frame; NaN where m_i + m_j = 0.
   Ji, Jj: inertia (m in kg; mt = m c in kg m; I about the centre of mass c, xx, yy, zz, xy, yz,
     zx in kg m^2); t_ic, t_jc: vector; D_ij: displacement [R | t], R rotation, t in m.
   67 mul, 61 add, 1 div.
   Error <= 18 u times the sum of the absolute values of all terms, for masses that are not
     negative, barring over- and underflow. */
static inline void ksl_inertiaf_merge(ksl_inertiaf_t *Ji, const ksl_vec3f_t *t_ic,
    const ksl_inertiaf_t *Jj, const ksl_vec3f_t *t_jc, const ksl_SE3f_t *D_ij) {
  const float m = Ji->m + Jj->m;
  const float c_0 = KSL_MULF(t_jc->x, D_ij->m00) + KSL_MULF(t_jc->y, D_ij->m01)
          + KSL_MULF(t_jc->z, D_ij->m02) + D_ij->m03,
      c_1 = KSL_MULF(t_jc->x, D_ij->m10) + KSL_MULF(t_jc->y, D_ij->m11)
          + KSL_MULF(t_jc->z, D_ij->m12) + D_ij->m13,
      c_2 = KSL_MULF(t_jc->x, D_ij->m20) + KSL_MULF(t_jc->y, D_ij->m21)
          + KSL_MULF(t_jc->z, D_ij->m22) + D_ij->m23;
  const float d_0 = c_0 - t_ic->x, d_1 = c_1 - t_ic->y, d_2 = c_2 - t_ic->z;
  const float part = Jj->m / m;
  const float reduced = KSL_MULF(Ji->m, part);
  const float p_0 = KSL_MULF(d_0, reduced), p_1 = KSL_MULF(d_1, reduced),
      p_2 = KSL_MULF(d_2, reduced);
  const float squares_0 = KSL_MULF(d_0, p_0), squares_1 = KSL_MULF(d_1, p_1),
      squares_2 = KSL_MULF(d_2, p_2);
  const float RI_0 = KSL_MULF(Jj->Ixx, D_ij->m00) + KSL_MULF(Jj->Ixy, D_ij->m01)
          + KSL_MULF(Jj->Izx, D_ij->m02),
      RI_1 = KSL_MULF(Jj->Iyy, D_ij->m01) + KSL_MULF(Jj->Ixy, D_ij->m00)
          + KSL_MULF(Jj->Iyz, D_ij->m02),
      RI_2 = KSL_MULF(Jj->Izz, D_ij->m02) + KSL_MULF(Jj->Iyz, D_ij->m01)
          + KSL_MULF(Jj->Izx, D_ij->m00),
      RI_3 = KSL_MULF(Jj->Ixx, D_ij->m10) + KSL_MULF(Jj->Ixy, D_ij->m11)
          + KSL_MULF(Jj->Izx, D_ij->m12),
      RI_4 = KSL_MULF(Jj->Iyy, D_ij->m11) + KSL_MULF(Jj->Ixy, D_ij->m10)
          + KSL_MULF(Jj->Iyz, D_ij->m12),
      RI_5 = KSL_MULF(Jj->Izz, D_ij->m12) + KSL_MULF(Jj->Iyz, D_ij->m11)
          + KSL_MULF(Jj->Izx, D_ij->m10),
      RI_6 = KSL_MULF(Jj->Ixx, D_ij->m20) + KSL_MULF(Jj->Ixy, D_ij->m21)
          + KSL_MULF(Jj->Izx, D_ij->m22),
      RI_7 = KSL_MULF(Jj->Iyy, D_ij->m21) + KSL_MULF(Jj->Ixy, D_ij->m20)
          + KSL_MULF(Jj->Iyz, D_ij->m22),
      RI_8 = KSL_MULF(Jj->Izz, D_ij->m22) + KSL_MULF(Jj->Iyz, D_ij->m21)
          + KSL_MULF(Jj->Izx, D_ij->m20);
  const float Ji_1_new = Ji->mt.x + KSL_MULF(Jj->m, c_0),
      Ji_2_new = Ji->mt.y + KSL_MULF(Jj->m, c_1), Ji_3_new = Ji->mt.z + KSL_MULF(Jj->m, c_2),
      Ji_4_new = Ji->Ixx
          + (KSL_MULF(D_ij->m00, RI_0) + KSL_MULF(D_ij->m01, RI_1) + KSL_MULF(D_ij->m02, RI_2))
          + (squares_1 + squares_2),
      Ji_5_new = Ji->Iyy
          + (KSL_MULF(D_ij->m10, RI_3) + KSL_MULF(D_ij->m11, RI_4) + KSL_MULF(D_ij->m12, RI_5))
          + (squares_0 + squares_2),
      Ji_6_new = Ji->Izz
          + (KSL_MULF(D_ij->m20, RI_6) + KSL_MULF(D_ij->m21, RI_7) + KSL_MULF(D_ij->m22, RI_8))
          + (squares_0 + squares_1),
      Ji_7_new = Ji->Ixy
          + (KSL_MULF(D_ij->m10, RI_0) + KSL_MULF(D_ij->m11, RI_1) + KSL_MULF(D_ij->m12, RI_2))
          - KSL_MULF(d_1, p_0),
      Ji_8_new = Ji->Iyz
          + (KSL_MULF(D_ij->m20, RI_3) + KSL_MULF(D_ij->m21, RI_4) + KSL_MULF(D_ij->m22, RI_5))
          - KSL_MULF(d_2, p_1),
      Ji_9_new = Ji->Izx
          + (KSL_MULF(D_ij->m20, RI_0) + KSL_MULF(D_ij->m21, RI_1) + KSL_MULF(D_ij->m22, RI_2))
          - KSL_MULF(d_2, p_0);
  Ji->m = m;
  Ji->mt.x = Ji_1_new;
  Ji->mt.y = Ji_2_new;
  Ji->mt.z = Ji_3_new;
  Ji->Ixx = Ji_4_new;
  Ji->Iyy = Ji_5_new;
  Ji->Izz = Ji_6_new;
  Ji->Ixy = Ji_7_new;
  Ji->Iyz = Ji_8_new;
  Ji->Izx = Ji_9_new;
}

#ifndef KSL_NO_ALLOC
#include <stdlib.h>

/* n ksl_inertia_t on the heap, zeros, to be freed by the caller; NULL for n <= 0 or when there
     is no memory. */
static inline ksl_inertia_t *ksl_inertia_alloc(int n) {
  return n > 0 ? (ksl_inertia_t *)calloc((size_t)n, sizeof(ksl_inertia_t)) : NULL;
}

/* n ksl_inertiaf_t on the heap, zeros, to be freed by the caller; NULL for n <= 0 or when there
     is no memory. */
static inline ksl_inertiaf_t *ksl_inertiaf_alloc(int n) {
  return n > 0 ? (ksl_inertiaf_t *)calloc((size_t)n, sizeof(ksl_inertiaf_t)) : NULL;
}

#endif

/* What KSL declares beside formulas. */


/* Cholesky factorization L L^T = I of the matrix I of self's moments: the entries of L replace the
     moments, L_yx that of Ixy, L_zy that of Iyz, L_zx that of Izx; L_xx, L_yy, L_zz >= 0.
     Returns the rank of I to rounding: 3, 2 (a rod), 1, or 0 (a point mass); or -1, with L = NaN, if
     I has a negative eigenvalue.  Eigenvalues up to 128 u times the largest count as zero;
     |L L^T - I| <= 160 u times the largest moment; searched, not proved. */
static inline int ksl_inertia_factor(ksl_inertia_t *self) {
  static const int planes[3][2] = {{0, 1}, {0, 2}, {1, 2}};
  ksl_mat3x3_t D = ksl_mat3x3(
      self->Ixx, self->Ixy, self->Izx,
      self->Ixy, self->Iyy, self->Iyz,
      self->Izx, self->Iyz, self->Izz), L;
  double least;
  int rank = 0;
  ksl_mat3x3_pca(&D, &L);
  least = KSL_MUL(1.4210854715202004e-14, D.m00);
  if (!(D.m22 >= -least)) {
    self->Ixx = self->Iyy = self->Izz = self->Ixy = self->Iyz = self->Izx = (double)NAN;
    return -1;
  }
  for (int i = 0; i < 3; i++) { /* L = V sqrt(D) */
    const int counts = D.at[i][i] > least;
    ksl_vec3_scale(&L.v[i], counts ? sqrt(D.at[i][i]) : 0);
    rank += counts;
  }
  for (int n = 0; n < 3; n++) { /* rotate two columns so that the upper entry becomes zero */
    const int i = planes[n][0], j = planes[n][1];
    const ksl_vec3_t a = L.v[i], b = L.v[j];
    ksl_vec3_t turn = ksl_vec3(a.at[i], b.at[i], 0);
    ksl_vec3_normalize(&turn);
    if (turn.y != 0) {
      ksl_vec3_scale(&L.v[i], turn.x);
      ksl_axpy_vv(turn.y, &b, &L.v[i]);
      ksl_vec3_scale(&L.v[j], turn.x);
      ksl_axpy_vv(-turn.y, &a, &L.v[j]);
      L.at[j][i] = 0;
    }
  }
  for (int i = 0; i < 3; i++) {
    if (L.at[i][i] < 0) {
      ksl_vec3_invert(&L.v[i]);
    }
  }
  self->Ixx = L.m00; self->Iyy = L.m11; self->Izz = L.m22;
  self->Ixy = L.m10; self->Iyz = L.m21; self->Izx = L.m20;
  return rank;
}

/* Cholesky factorization L L^T = I of the matrix I of self's moments: the entries of L replace the
     moments, L_yx that of Ixy, L_zy that of Iyz, L_zx that of Izx; L_xx, L_yy, L_zz >= 0.
     Returns the rank of I to rounding: 3, 2 (a rod), 1, or 0 (a point mass); or -1, with L = NaN, if
     I has a negative eigenvalue.  Eigenvalues up to 128 u times the largest count as zero;
     |L L^T - I| <= 160 u times the largest moment; searched, not proved. */
static inline int ksl_inertiaf_factor(ksl_inertiaf_t *self) {
  static const int planes[3][2] = {{0, 1}, {0, 2}, {1, 2}};
  ksl_mat3x3f_t D = ksl_mat3x3f(
      self->Ixx, self->Ixy, self->Izx,
      self->Ixy, self->Iyy, self->Iyz,
      self->Izx, self->Iyz, self->Izz), L;
  float least;
  int rank = 0;
  ksl_mat3x3f_pca(&D, &L);
  least = KSL_MULF(7.6293945e-06f, D.m00);
  if (!(D.m22 >= -least)) {
    self->Ixx = self->Iyy = self->Izz = self->Ixy = self->Iyz = self->Izx = (float)NAN;
    return -1;
  }
  for (int i = 0; i < 3; i++) { /* L = V sqrt(D) */
    const int counts = D.at[i][i] > least;
    ksl_vec3f_scale(&L.v[i], counts ? sqrtf(D.at[i][i]) : 0);
    rank += counts;
  }
  for (int n = 0; n < 3; n++) { /* rotate two columns so that the upper entry becomes zero */
    const int i = planes[n][0], j = planes[n][1];
    const ksl_vec3f_t a = L.v[i], b = L.v[j];
    ksl_vec3f_t turn = ksl_vec3f(a.at[i], b.at[i], 0);
    ksl_vec3f_normalize(&turn);
    if (turn.y != 0) {
      ksl_vec3f_scale(&L.v[i], turn.x);
      ksl_axpy_vvf(turn.y, &b, &L.v[i]);
      ksl_vec3f_scale(&L.v[j], turn.x);
      ksl_axpy_vvf(-turn.y, &a, &L.v[j]);
      L.at[j][i] = 0;
    }
  }
  for (int i = 0; i < 3; i++) {
    if (L.at[i][i] < 0) {
      ksl_vec3f_invert(&L.v[i]);
    }
  }
  self->Ixx = L.m00; self->Iyy = L.m11; self->Izz = L.m22;
  self->Ixy = L.m10; self->Iyz = L.m21; self->Izx = L.m20;
  return rank;
}

#endif
