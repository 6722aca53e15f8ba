/* Made by `coscrew generate`; changes are overwritten. */
/* SPDX-License-Identifier: MIT */
/* coscrew 0.2.0.  Copyright (c) 2026 The coscrew authors. */
/* Spatial inertias of rigid bodies: mass, first moment, second moments about the origin. */
#ifndef KSL_SPATIAL_INERTIA_H
#define KSL_SPATIAL_INERTIA_H

#include "ksl_types.h"
#include "inertia.h"
#include "coscrew.h"

/* The spatial_inertia of these entries, in order. */
static inline ksl_spatial_inertia_t ksl_spatial_inertia(const double m, const double hx,
    const double hy, const double hz, const double xx, const double yy,
    const double zz, const double xy, const double xz, const double yz) {
  ksl_spatial_inertia_t value;
  value.m = m;
  value.h.x = hx;
  value.h.y = hy;
  value.h.z = hz;
  value.xx = xx;
  value.yy = yy;
  value.zz = zz;
  value.xy = xy;
  value.xz = xz;
  value.yz = yz;
  return value;
}

/* Bo = Bi.
   Bi, Bo: spatial inertia (m in kg; h = m c in kg m; I about the origin, xx, yy, zz, xy, xz, yz
     in kg m^2).
   No arithmetic.
   Exact. */
static inline void ksl_spatial_inertia_copy(const ksl_spatial_inertia_t *Bi,
    ksl_spatial_inertia_t *Bo) {
  const double Bi_m = Bi->m;
  const double Bi_h_x = Bi->h.x;
  const double Bi_h_y = Bi->h.y;
  const double Bi_h_z = Bi->h.z;
  const double Bi_xx = Bi->xx;
  const double Bi_yy = Bi->yy;
  const double Bi_zz = Bi->zz;
  const double Bi_xy = Bi->xy;
  const double Bi_xz = Bi->xz;
  const double Bi_yz = Bi->yz;
  Bo->m = Bi_m;
  Bo->h.x = Bi_h_x;
  Bo->h.y = Bi_h_y;
  Bo->h.z = Bi_h_z;
  Bo->xx = Bi_xx;
  Bo->yy = Bi_yy;
  Bo->zz = Bi_zz;
  Bo->xy = Bi_xy;
  Bo->xz = Bi_xz;
  Bo->yz = Bi_yz;
}

/* self = a self.
   self: spatial inertia (m in kg; h = m c in kg m; I about the origin, xx, yy, zz, xy, xz, yz in
     kg m^2); a: number.
   10 mul.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_spatial_inertia_scale(ksl_spatial_inertia_t *self, const double a) {
  const double self_0_new = KSL_MUL(self->m, a), self_1_new = KSL_MUL(self->h.x, a),
      self_2_new = KSL_MUL(self->h.y, a), self_3_new = KSL_MUL(self->h.z, a),
      self_4_new = KSL_MUL(self->xx, a), self_5_new = KSL_MUL(self->yy, a),
      self_6_new = KSL_MUL(self->zz, a), self_7_new = KSL_MUL(self->xy, a),
      self_8_new = KSL_MUL(self->xz, a), self_9_new = KSL_MUL(self->yz, a);
  self->m = self_0_new;
  self->h.x = self_1_new;
  self->h.y = self_2_new;
  self->h.z = self_3_new;
  self->xx = self_4_new;
  self->yy = self_5_new;
  self->zz = self_6_new;
  self->xy = self_7_new;
  self->xz = self_8_new;
  self->yz = self_9_new;
}

/* Bo = B1 + B2.
   B1, B2, Bo: spatial inertia (m in kg; h = m c in kg m; I about the origin, xx, yy, zz, xy, xz,
     yz in kg m^2).
   10 add.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_add_BB(const ksl_spatial_inertia_t *B1, const ksl_spatial_inertia_t *B2,
    ksl_spatial_inertia_t *Bo) {
  const double Bo_0 = B1->m + B2->m, Bo_1 = B1->h.x + B2->h.x, Bo_2 = B1->h.y + B2->h.y,
      Bo_3 = B1->h.z + B2->h.z, Bo_4 = B1->xx + B2->xx, Bo_5 = B1->yy + B2->yy,
      Bo_6 = B1->zz + B2->zz, Bo_7 = B1->xy + B2->xy, Bo_8 = B1->xz + B2->xz,
      Bo_9 = B1->yz + B2->yz;
  Bo->m = Bo_0;
  Bo->h.x = Bo_1;
  Bo->h.y = Bo_2;
  Bo->h.z = Bo_3;
  Bo->xx = Bo_4;
  Bo->yy = Bo_5;
  Bo->zz = Bo_6;
  Bo->xy = Bo_7;
  Bo->xz = Bo_8;
  Bo->yz = Bo_9;
}

/* Bo = B1 - B2.
   B1, B2, Bo: spatial inertia (m in kg; h = m c in kg m; I about the origin, xx, yy, zz, xy, xz,
     yz in kg m^2).
   10 add.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_subtract_BB(const ksl_spatial_inertia_t *B1,
    const ksl_spatial_inertia_t *B2, ksl_spatial_inertia_t *Bo) {
  const double Bo_0 = B1->m - B2->m, Bo_1 = B1->h.x - B2->h.x, Bo_2 = B1->h.y - B2->h.y,
      Bo_3 = B1->h.z - B2->h.z, Bo_4 = B1->xx - B2->xx, Bo_5 = B1->yy - B2->yy,
      Bo_6 = B1->zz - B2->zz, Bo_7 = B1->xy - B2->xy, Bo_8 = B1->xz - B2->xz,
      Bo_9 = B1->yz - B2->yz;
  Bo->m = Bo_0;
  Bo->h.x = Bo_1;
  Bo->h.y = Bo_2;
  Bo->h.z = Bo_3;
  Bo->xx = Bo_4;
  Bo->yy = Bo_5;
  Bo->zz = Bo_6;
  Bo->xy = Bo_7;
  Bo->xz = Bo_8;
  Bo->yz = Bo_9;
}

/* Bo: mass m, centre of mass com, second moments Ic about it (kg m^2; only the upper triangle is
     read): h = m com, I = Ic - m com~ com~.
   m: number; com: vector; Ic: rotation or other 3×3 matrix; Bo: spatial inertia (m in kg; h = m
     c in kg m; I about the origin, xx, yy, zz, xy, xz, yz in kg m^2).
   9 mul, 9 add.
   Error <= u |result| + (m: 0, h: 0, I: 3) u S, S the sum of the |terms| of the expanded
     formula; barring over- and underflow. */
static inline void ksl_spatial_inertia_from_com(const double m, const ksl_vec3_t *com,
    const ksl_mat3x3_t *Ic, ksl_spatial_inertia_t *Bo) {
  const double h_0 = KSL_MUL(m, com->x), h_1 = KSL_MUL(m, com->y), h_2 = KSL_MUL(m, com->z);
  const double squares_0 = KSL_MUL(com->x, h_0), squares_1 = KSL_MUL(com->y, h_1),
      squares_2 = KSL_MUL(com->z, h_2);
  const double Bo_4 = Ic->m00 + (squares_1 + squares_2), Bo_5 = Ic->m11 + (squares_0 + squares_2),
      Bo_6 = Ic->m22 + (squares_0 + squares_1), Bo_7 = Ic->m01 - KSL_MUL(com->y, h_0),
      Bo_8 = Ic->m02 - KSL_MUL(com->z, h_0), Bo_9 = Ic->m12 - KSL_MUL(com->z, h_1);
  Bo->m = m;
  Bo->h.x = h_0;
  Bo->h.y = h_1;
  Bo->h.z = h_2;
  Bo->xx = Bo_4;
  Bo->yy = Bo_5;
  Bo->zz = Bo_6;
  Bo->xy = Bo_7;
  Bo->xz = Bo_8;
  Bo->yz = Bo_9;
}

/* Bo = (m, mt, I - mt~ mt~ / m) from the inertia J, whose moments are about the centre of mass;
     NaN where m = 0.
   J: inertia (m in kg; mt = m c in kg m; I about the centre of mass c, xx, yy, zz, xy, yz, zx in
     kg m^2); Bo: spatial inertia (m in kg; h = m c in kg m; I about the origin, xx, yy, zz, xy,
     xz, yz in kg m^2).
   6 mul, 9 add, 3 div.
   Error of a moment <= 4 u times the sum of its |terms|, barring over- and underflow. */
static inline void ksl_spatial_inertia_from_inertia(const ksl_inertia_t *J,
    ksl_spatial_inertia_t *Bo) {
  const double c_0 = J->mt.x / J->m, c_1 = J->mt.y / J->m, c_2 = J->mt.z / J->m;
  const double squares_0 = KSL_MUL(J->mt.x, c_0), squares_1 = KSL_MUL(J->mt.y, c_1),
      squares_2 = KSL_MUL(J->mt.z, c_2);
  const double Bo_4 = J->Ixx + (squares_1 + squares_2), Bo_5 = J->Iyy + (squares_0 + squares_2),
      Bo_6 = J->Izz + (squares_0 + squares_1), Bo_7 = J->Ixy - KSL_MUL(J->mt.x, c_1),
      Bo_8 = J->Izx - KSL_MUL(J->mt.x, c_2), Bo_9 = J->Iyz - KSL_MUL(J->mt.y, c_2);
  const double J_m = J->m;
  const double J_mt_x = J->mt.x;
  const double J_mt_y = J->mt.y;
  const double J_mt_z = J->mt.z;
  Bo->m = J_m;
  Bo->h.x = J_mt_x;
  Bo->h.y = J_mt_y;
  Bo->h.z = J_mt_z;
  Bo->xx = Bo_4;
  Bo->yy = Bo_5;
  Bo->zz = Bo_6;
  Bo->xy = Bo_7;
  Bo->xz = Bo_8;
  Bo->yz = Bo_9;
}

/* Jo = (m, h, I + h~ h~ / m) from the spatial inertia B, with moments about the centre of mass;
     NaN where m = 0.
   B: spatial inertia (m in kg; h = m c in kg m; I about the origin, xx, yy, zz, xy, xz, yz in kg
     m^2); Jo: inertia (m in kg; mt = m c in kg m; I about the centre of mass c, xx, yy, zz, xy,
     yz, zx in kg m^2).
   6 mul, 9 add, 3 div.
   Error of a moment <= 4 u times the sum of its |terms|, barring over- and underflow. */
static inline void ksl_inertia_from_spatial_inertia(const ksl_spatial_inertia_t *B,
    ksl_inertia_t *Jo) {
  const double c_0 = B->h.x / B->m, c_1 = B->h.y / B->m, c_2 = B->h.z / B->m;
  const double squares_0 = KSL_MUL(B->h.x, c_0), squares_1 = KSL_MUL(B->h.y, c_1),
      squares_2 = KSL_MUL(B->h.z, c_2);
  const double Jo_4 = B->xx - (squares_1 + squares_2), Jo_5 = B->yy - (squares_0 + squares_2),
      Jo_6 = B->zz - (squares_0 + squares_1), Jo_7 = KSL_MUL(B->h.x, c_1) + B->xy,
      Jo_8 = KSL_MUL(B->h.y, c_2) + B->yz, Jo_9 = KSL_MUL(B->h.x, c_2) + B->xz;
  const double B_m = B->m;
  const double B_h_x = B->h.x;
  const double B_h_y = B->h.y;
  const double B_h_z = B->h.z;
  Jo->m = B_m;
  Jo->mt.x = B_h_x;
  Jo->mt.y = B_h_y;
  Jo->mt.z = B_h_z;
  Jo->Ixx = Jo_4;
  Jo->Iyy = Jo_5;
  Jo->Izz = Jo_6;
  Jo->Ixy = Jo_7;
  Jo->Iyz = Jo_8;
  Jo->Izx = Jo_9;
}

/* vo = h / m, the centre of mass in m.
   B: spatial inertia (m in kg; h = m c in kg m; I about the origin, xx, yy, zz, xy, xz, yz in kg
     m^2); vo: vector.
   3 div.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_spatial_inertia_com(const ksl_spatial_inertia_t *B, ksl_vec3_t *vo) {
  const double vo_0 = B->h.x / B->m, vo_1 = B->h.y / B->m, vo_2 = B->h.z / B->m;
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
}

/* Ro = I + h~ h~ / m, the second moments about the centre of mass.
   B: spatial inertia (m in kg; h = m c in kg m; I about the origin, xx, yy, zz, xy, xz, yz in kg
     m^2); Ro: rotation or other 3×3 matrix.
   6 mul, 9 add, 3 div. */
static inline void ksl_spatial_inertia_about_com(const ksl_spatial_inertia_t *B, ksl_mat3x3_t *Ro) {
  const double c_0 = B->h.x / B->m, c_1 = B->h.y / B->m, c_2 = B->h.z / B->m;
  const double squares_0 = KSL_MUL(B->h.x, c_0), squares_1 = KSL_MUL(B->h.y, c_1),
      squares_2 = KSL_MUL(B->h.z, c_2);
  const double about_0 = B->xx - (squares_1 + squares_2), about_1 = B->yy - (squares_0 + squares_2),
      about_2 = B->zz - (squares_0 + squares_1), about_3 = KSL_MUL(B->h.x, c_1) + B->xy,
      about_4 = KSL_MUL(B->h.x, c_2) + B->xz, about_5 = KSL_MUL(B->h.y, c_2) + B->yz;
  Ro->m00 = about_0;
  Ro->m01 = about_3;
  Ro->m02 = about_4;
  Ro->m10 = about_3;
  Ro->m11 = about_1;
  Ro->m12 = about_5;
  Ro->m20 = about_4;
  Ro->m21 = about_5;
  Ro->m22 = about_2;
}

/* Mo = [[m 1, -h~], [h~, I]].
   B: spatial inertia (m in kg; h = m c in kg m; I about the origin, xx, yy, zz, xy, xz, yz in kg
     m^2); Mo: 6×6 operator.
   3 neg.
   Exact. */
static inline void ksl_spatial_inertia_matrix(const ksl_spatial_inertia_t *B, ksl_mat6x6_t *Mo) {
  const double Mo_05 = -B->h.y, Mo_13 = -B->h.z, Mo_24 = -B->h.x;
  const double B_m = B->m;
  const double B_h_z = B->h.z;
  const double B_h_x = B->h.x;
  const double B_h_y = B->h.y;
  const double B_xx = B->xx;
  const double B_xy = B->xy;
  const double B_xz = B->xz;
  const double B_yy = B->yy;
  const double B_yz = B->yz;
  const double B_zz = B->zz;
  Mo->at[0][0] = B_m;
  Mo->at[1][0] = 0.0;
  Mo->at[2][0] = 0.0;
  Mo->at[3][0] = 0.0;
  Mo->at[4][0] = B_h_z;
  Mo->at[5][0] = Mo_05;
  Mo->at[0][1] = 0.0;
  Mo->at[1][1] = B_m;
  Mo->at[2][1] = 0.0;
  Mo->at[3][1] = Mo_13;
  Mo->at[4][1] = 0.0;
  Mo->at[5][1] = B_h_x;
  Mo->at[0][2] = 0.0;
  Mo->at[1][2] = 0.0;
  Mo->at[2][2] = B_m;
  Mo->at[3][2] = B_h_y;
  Mo->at[4][2] = Mo_24;
  Mo->at[5][2] = 0.0;
  Mo->at[0][3] = 0.0;
  Mo->at[1][3] = Mo_13;
  Mo->at[2][3] = B_h_y;
  Mo->at[3][3] = B_xx;
  Mo->at[4][3] = B_xy;
  Mo->at[5][3] = B_xz;
  Mo->at[0][4] = B_h_z;
  Mo->at[1][4] = 0.0;
  Mo->at[2][4] = Mo_24;
  Mo->at[3][4] = B_xy;
  Mo->at[4][4] = B_yy;
  Mo->at[5][4] = B_yz;
  Mo->at[0][5] = Mo_05;
  Mo->at[1][5] = B_h_x;
  Mo->at[2][5] = 0.0;
  Mo->at[3][5] = B_xz;
  Mo->at[4][5] = B_yz;
  Mo->at[5][5] = B_zz;
}

/* co = B s = (m v - h × ω; h × v + I ω), the momentum of a body that moves with s.
   B: spatial inertia (m in kg; h = m c in kg m; I about the origin, xx, yy, zz, xy, xz, yz in kg
     m^2); s: screw (v in m/s; ω in rad/s); co: coscrew (f in N; τ in N m).
   24 mul, 18 add.
   Error <= u |result| + (lin: 2, ang: 3) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_Bs(const ksl_spatial_inertia_t *B, const ksl_screw_t *s,
    ksl_coscrew_t *co) {
  const double co_0 = KSL_MUL(B->m, s->m0) + (KSL_MUL(B->h.z, s->m4) - KSL_MUL(B->h.y, s->m5)),
      co_1 = KSL_MUL(B->m, s->m1) + (KSL_MUL(B->h.x, s->m5) - KSL_MUL(B->h.z, s->m3)),
      co_2 = KSL_MUL(B->m, s->m2) + (KSL_MUL(B->h.y, s->m3) - KSL_MUL(B->h.x, s->m4)),
      co_3 = KSL_MUL(B->h.y, s->m2) - KSL_MUL(B->h.z, s->m1)
          + (KSL_MUL(B->xx, s->m3) + KSL_MUL(B->xy, s->m4) + KSL_MUL(B->xz, s->m5)),
      co_4 = KSL_MUL(B->h.z, s->m0) - KSL_MUL(B->h.x, s->m2)
          + (KSL_MUL(B->yy, s->m4) + KSL_MUL(B->xy, s->m3) + KSL_MUL(B->yz, s->m5)),
      co_5 = KSL_MUL(B->h.x, s->m1) - KSL_MUL(B->h.y, s->m0)
          + (KSL_MUL(B->zz, s->m5) + KSL_MUL(B->xz, s->m3) + KSL_MUL(B->yz, s->m4));
  co->m0 = co_0;
  co->m1 = co_1;
  co->m2 = co_2;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
}

/* s·B s / 2, the kinetic energy in J of a body that moves with s.
   B: spatial inertia (m in kg; h = m c in kg m; I about the origin, xx, yy, zz, xy, xz, yz in kg
     m^2); s: screw (v in m/s; ω in rad/s).
   26 mul, 17 add.
   Error <= u |result| + 7 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline double ksl_spatial_inertia_energy(const ksl_spatial_inertia_t *B,
    const ksl_screw_t *s) {
  const double square = KSL_MUL(s->m0, s->m0) + KSL_MUL(s->m1, s->m1) + KSL_MUL(s->m2, s->m2);
  const double L_0 = KSL_MUL(B->xx, s->m3) + KSL_MUL(B->xy, s->m4) + KSL_MUL(B->xz, s->m5),
      L_1 = KSL_MUL(B->yy, s->m4) + KSL_MUL(B->xy, s->m3) + KSL_MUL(B->yz, s->m5),
      L_2 = KSL_MUL(B->zz, s->m5) + KSL_MUL(B->xz, s->m3) + KSL_MUL(B->yz, s->m4);
  const double twice = KSL_MUL(B->m, square)
          + (KSL_MUL(s->m3, L_0) + KSL_MUL(s->m4, L_1) + KSL_MUL(s->m5, L_2));
  const double across_0 = KSL_MUL(B->h.z, s->m4) - KSL_MUL(B->h.y, s->m5),
      across_1 = KSL_MUL(B->h.x, s->m5) - KSL_MUL(B->h.z, s->m3),
      across_2 = KSL_MUL(B->h.y, s->m3) - KSL_MUL(B->h.x, s->m4);
  const double energy = KSL_MUL(s->m0, across_0) + KSL_MUL(s->m1, across_1)
          + KSL_MUL(s->m2, across_2) + KSL_MUL(0.5, twice);
  return energy;
}

/* co = B ds + (w × (w × h); w × I w): the net wrench, about the origin, of a body with angular
     velocity w and acceleration ds = (a; w'), where a is that of the point now at the origin; if
     a is less gravity's, so is the wrench.
   B: spatial inertia (m in kg; h = m c in kg m; I about the origin, xx, yy, zz, xy, xz, yz in kg
     m^2); w: vector; ds: screw (v in m/s; ω in rad/s); co: coscrew (f in N; τ in N m).
   39 mul, 42 add, 3 neg.
   Error <= u |result| + (lin: 5, ang: 6) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_spatial_inertia_net_wrench(const ksl_spatial_inertia_t *B,
    const ksl_vec3_t *w, const ksl_screw_t *ds, ksl_coscrew_t *co) {
  const double ww_0 = KSL_MUL(w->x, w->x), ww_1 = KSL_MUL(w->y, w->y), ww_2 = KSL_MUL(w->z, w->z),
      ww_3 = KSL_MUL(w->x, w->y), ww_4 = KSL_MUL(w->x, w->z), ww_5 = KSL_MUL(w->y, w->z);
  const double U_0 = -(ww_1 + ww_2), U_1 = ww_3 - ds->m5, U_2 = ds->m4 + ww_4, U_3 = ds->m5 + ww_3,
      U_4 = -(ww_0 + ww_2), U_5 = ww_5 - ds->m3, U_6 = ww_4 - ds->m4, U_7 = ds->m3 + ww_5,
      U_8 = -(ww_0 + ww_1);
  const double others_0 = B->zz - B->yy, others_1 = B->xx - B->zz, others_2 = B->yy - B->xx;
  const double squares_0 = ww_1 - ww_2, squares_1 = ww_2 - ww_0, squares_2 = ww_0 - ww_1;
  const double own_0 = KSL_MUL(B->xx, ds->m3) + KSL_MUL(ww_5, others_0),
      own_1 = KSL_MUL(B->yy, ds->m4) + KSL_MUL(ww_4, others_1),
      own_2 = KSL_MUL(B->zz, ds->m5) + KSL_MUL(ww_3, others_2);
  const double N_0 = KSL_MUL(B->xz, U_3) - KSL_MUL(B->xy, U_6) + KSL_MUL(B->yz, squares_0) + own_0,
      N_1 = KSL_MUL(B->xy, U_7) - KSL_MUL(B->yz, U_1) + KSL_MUL(B->xz, squares_1) + own_1,
      N_2 = KSL_MUL(B->xy, squares_2) + (KSL_MUL(B->yz, U_2) - KSL_MUL(B->xz, U_5)) + own_2;
  const double co_0 = KSL_MUL(B->m, ds->m0)
          + (KSL_MUL(B->h.x, U_0) + KSL_MUL(B->h.y, U_1) + KSL_MUL(B->h.z, U_2)),
      co_1 = KSL_MUL(B->m, ds->m1)
          + (KSL_MUL(B->h.x, U_3) + KSL_MUL(B->h.y, U_4) + KSL_MUL(B->h.z, U_5)),
      co_2 = KSL_MUL(B->m, ds->m2)
          + (KSL_MUL(B->h.x, U_6) + KSL_MUL(B->h.y, U_7) + KSL_MUL(B->h.z, U_8)),
      co_3 = KSL_MUL(B->h.y, ds->m2) - KSL_MUL(B->h.z, ds->m1) + N_0,
      co_4 = KSL_MUL(B->h.z, ds->m0) - KSL_MUL(B->h.x, ds->m2) + N_1,
      co_5 = KSL_MUL(B->h.x, ds->m1) - KSL_MUL(B->h.y, ds->m0) + N_2;
  co->m0 = co_0;
  co->m1 = co_1;
  co->m2 = co_2;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
}

/* Bo = B moved by t: m, h + m t, I - t~ (h + m t)~ - h~ t~.
   t: vector; B, Bo: spatial inertia (m in kg; h = m c in kg m; I about the origin, xx, yy, zz,
     xy, xz, yz in kg m^2).
   18 mul, 18 add.
   Error <= u |result| + (m: 0, h: 1, I: 4) u S, S the sum of the |terms| of the expanded
     formula; barring over- and underflow. */
static inline void ksl_spatial_inertia_shifted(const ksl_vec3_t *t,
    const ksl_spatial_inertia_t *B, ksl_spatial_inertia_t *Bo) {
  const double mt_0 = KSL_MUL(t->x, B->m), mt_1 = KSL_MUL(t->y, B->m), mt_2 = KSL_MUL(t->z, B->m);
  const double half_0 = KSL_MUL(0.5, mt_0), half_1 = KSL_MUL(0.5, mt_1),
      half_2 = KSL_MUL(0.5, mt_2);
  const double n_0 = B->h.x + half_0, n_1 = B->h.y + half_1, n_2 = B->h.z + half_2;
  const double tn0 = KSL_MUL(t->x, n_0);
  const double tn1 = KSL_MUL(t->y, n_1);
  const double tn2 = KSL_MUL(t->z, n_2);
  const double own_0 = KSL_MUL(2.0, tn0), own_1 = KSL_MUL(2.0, tn1), own_2 = KSL_MUL(2.0, tn2);
  const double pairs_0 = own_1 + own_2, pairs_1 = own_0 + own_2, pairs_2 = own_0 + own_1,
      pairs_3 = KSL_MUL(t->x, n_1) + KSL_MUL(t->y, n_0),
      pairs_4 = KSL_MUL(t->x, n_2) + KSL_MUL(t->z, n_0),
      pairs_5 = KSL_MUL(t->y, n_2) + KSL_MUL(t->z, n_1);
  const double moved_0 = B->h.x + mt_0, moved_1 = B->h.y + mt_1, moved_2 = B->h.z + mt_2;
  const double Bo_4 = B->xx + pairs_0, Bo_5 = B->yy + pairs_1, Bo_6 = B->zz + pairs_2,
      Bo_7 = B->xy - pairs_3, Bo_8 = B->xz - pairs_4, Bo_9 = B->yz - pairs_5;
  const double B_m = B->m;
  Bo->m = B_m;
  Bo->h.x = moved_0;
  Bo->h.y = moved_1;
  Bo->h.z = moved_2;
  Bo->xx = Bo_4;
  Bo->yy = Bo_5;
  Bo->zz = Bo_6;
  Bo->xy = Bo_7;
  Bo->xz = Bo_8;
  Bo->yz = Bo_9;
}

/* Bo = [Ad]*(D) B [Ad]^-1(D): B, given in the frame at D, in the reference frame.
   D: displacement [R | t], R rotation, t in m; B, Bo: spatial inertia (m in kg; h = m c in kg m;
     I about the origin, xx, yy, zz, xy, xz, yz in kg m^2).
   72 mul, 54 add.
   Error <= u |result| + (m: 0, h: 3, I: 6) u S, S the sum of the |terms| of the expanded
     formula; barring over- and underflow. */
static inline void ksl_spatial_inertia_transformed(const ksl_SE3_t *D,
    const ksl_spatial_inertia_t *B, ksl_spatial_inertia_t *Bo) {
  const double RI_0 = KSL_MUL(D->m00, B->xx) + KSL_MUL(D->m01, B->xy) + KSL_MUL(D->m02, B->xz),
      RI_1 = KSL_MUL(D->m00, B->xy) + KSL_MUL(D->m01, B->yy) + KSL_MUL(D->m02, B->yz),
      RI_2 = KSL_MUL(D->m00, B->xz) + KSL_MUL(D->m01, B->yz) + KSL_MUL(D->m02, B->zz),
      RI_3 = KSL_MUL(D->m10, B->xx) + KSL_MUL(D->m11, B->xy) + KSL_MUL(D->m12, B->xz),
      RI_4 = KSL_MUL(D->m10, B->xy) + KSL_MUL(D->m11, B->yy) + KSL_MUL(D->m12, B->yz),
      RI_5 = KSL_MUL(D->m10, B->xz) + KSL_MUL(D->m11, B->yz) + KSL_MUL(D->m12, B->zz),
      RI_6 = KSL_MUL(D->m20, B->xx) + KSL_MUL(D->m21, B->xy) + KSL_MUL(D->m22, B->xz),
      RI_7 = KSL_MUL(D->m20, B->xy) + KSL_MUL(D->m21, B->yy) + KSL_MUL(D->m22, B->yz),
      RI_8 = KSL_MUL(D->m20, B->xz) + KSL_MUL(D->m21, B->yz) + KSL_MUL(D->m22, B->zz);
  const double turned_1 = KSL_MUL(D->m00, B->h.x) + KSL_MUL(D->m01, B->h.y)
          + KSL_MUL(D->m02, B->h.z),
      turned_2 = KSL_MUL(D->m10, B->h.x) + KSL_MUL(D->m11, B->h.y) + KSL_MUL(D->m12, B->h.z),
      turned_3 = KSL_MUL(D->m20, B->h.x) + KSL_MUL(D->m21, B->h.y) + KSL_MUL(D->m22, B->h.z),
      turned_4 = KSL_MUL(D->m00, RI_0) + KSL_MUL(D->m01, RI_1) + KSL_MUL(D->m02, RI_2),
      turned_5 = KSL_MUL(D->m10, RI_3) + KSL_MUL(D->m11, RI_4) + KSL_MUL(D->m12, RI_5),
      turned_6 = KSL_MUL(D->m20, RI_6) + KSL_MUL(D->m21, RI_7) + KSL_MUL(D->m22, RI_8),
      turned_7 = KSL_MUL(D->m10, RI_0) + KSL_MUL(D->m11, RI_1) + KSL_MUL(D->m12, RI_2),
      turned_8 = KSL_MUL(D->m20, RI_0) + KSL_MUL(D->m21, RI_1) + KSL_MUL(D->m22, RI_2),
      turned_9 = KSL_MUL(D->m20, RI_3) + KSL_MUL(D->m21, RI_4) + KSL_MUL(D->m22, RI_5);
  const double mt_0 = KSL_MUL(D->m03, B->m), mt_1 = KSL_MUL(D->m13, B->m),
      mt_2 = KSL_MUL(D->m23, B->m);
  const double half_0 = KSL_MUL(0.5, mt_0), half_1 = KSL_MUL(0.5, mt_1),
      half_2 = KSL_MUL(0.5, mt_2);
  const double n_0 = turned_1 + half_0, n_1 = turned_2 + half_1, n_2 = turned_3 + half_2;
  const double tn0 = KSL_MUL(D->m03, n_0);
  const double tn1 = KSL_MUL(D->m13, n_1);
  const double tn2 = KSL_MUL(D->m23, n_2);
  const double own_0 = KSL_MUL(2.0, tn0), own_1 = KSL_MUL(2.0, tn1), own_2 = KSL_MUL(2.0, tn2);
  const double pairs_0 = own_1 + own_2, pairs_1 = own_0 + own_2, pairs_2 = own_0 + own_1,
      pairs_3 = KSL_MUL(D->m03, n_1) + KSL_MUL(D->m13, n_0),
      pairs_4 = KSL_MUL(D->m03, n_2) + KSL_MUL(D->m23, n_0),
      pairs_5 = KSL_MUL(D->m13, n_2) + KSL_MUL(D->m23, n_1);
  const double moved_0 = turned_1 + mt_0, moved_1 = turned_2 + mt_1, moved_2 = turned_3 + mt_2;
  const double Bo_4 = turned_4 + pairs_0, Bo_5 = turned_5 + pairs_1, Bo_6 = turned_6 + pairs_2,
      Bo_7 = turned_7 - pairs_3, Bo_8 = turned_8 - pairs_4, Bo_9 = turned_9 - pairs_5;
  const double B_m = B->m;
  Bo->m = B_m;
  Bo->h.x = moved_0;
  Bo->h.y = moved_1;
  Bo->h.z = moved_2;
  Bo->xx = Bo_4;
  Bo->yy = Bo_5;
  Bo->zz = Bo_6;
  Bo->xy = Bo_7;
  Bo->xz = Bo_8;
  Bo->yz = Bo_9;
}

/* the smallest pivot of [[m, h^T], [h, tr(I)/2 1 - I]], each divided by its diagonal entry:
     positive exactly if a body of positive density has this inertia.
   B: spatial inertia (m in kg; h = m c in kg m; I about the origin, xx, yy, zz, xy, xz, yz in kg
     m^2).
   11 mul, 15 add, 10 div, 3 neg, 9 less, 13 select. */
static inline double ksl_spatial_inertia_consistency(const ksl_spatial_inertia_t *B) {
  const double twice_trace = B->xx + B->yy + B->zz;
  const double trace = KSL_MUL(0.5, twice_trace);
  const double sigma_0 = trace - B->xx, sigma_1 = trace - B->yy, sigma_2 = trace - B->zz;
  const double divisor0 = 0.0 < B->m ? B->m : 1.0;
  const double l0_0 = B->h.x / divisor0, l0_1 = B->h.y / divisor0, l0_2 = B->h.z / divisor0;
  const double u1_0 = sigma_0 - KSL_MUL(B->h.x, l0_0), u1_1 = -(KSL_MUL(B->h.y, l0_0) + B->xy),
      u1_2 = -(KSL_MUL(B->h.z, l0_0) + B->xz);
  const double divisor1 = 0.0 < u1_0 ? u1_0 : 1.0;
  const double l1_0 = u1_1 / divisor1, l1_1 = u1_2 / divisor1;
  const double u2_0 = sigma_1 - KSL_MUL(B->h.y, l0_1) - KSL_MUL(u1_1, l1_0),
      u2_1 = -(KSL_MUL(B->h.z, l0_1) + B->yz + KSL_MUL(u1_2, l1_0));
  const double divisor2 = 0.0 < u2_0 ? u2_0 : 1.0;
  const double l2 = u2_1 / divisor2;
  const double u3 = sigma_2 - KSL_MUL(B->h.z, l0_2) - KSL_MUL(u1_2, l1_1) - KSL_MUL(u2_1, l2);
  const double part0a = B->m / divisor0, part0 = 0.0 < B->m ? part0a : B->m;
  const double own1 = 0.0 < sigma_0 ? sigma_0 : 1.0;
  const double part1a = u1_0 / own1, part1 = 0.0 < sigma_0 ? part1a : sigma_0;
  const double smallest1 = part0 < part1 ? part0 : part1;
  const double own2 = 0.0 < sigma_1 ? sigma_1 : 1.0;
  const double part2a = u2_0 / own2, part2 = 0.0 < sigma_1 ? part2a : sigma_1;
  const double smallest2 = smallest1 < part2 ? smallest1 : part2;
  const double own3 = 0.0 < sigma_2 ? sigma_2 : 1.0;
  const double part3a = u3 / own3, part3 = 0.0 < sigma_2 ? part3a : sigma_2;
  const double smallest3 = smallest2 < part3 ? smallest2 : part3;
  return smallest3;
}

/* The spatial_inertia of these entries, in order. */
static inline ksl_spatial_inertiaf_t ksl_spatial_inertiaf(const float m, const float hx,
    const float hy, const float hz, const float xx, const float yy, const float zz,
    const float xy, const float xz, const float yz) {
  ksl_spatial_inertiaf_t value;
  value.m = m;
  value.h.x = hx;
  value.h.y = hy;
  value.h.z = hz;
  value.xx = xx;
  value.yy = yy;
  value.zz = zz;
  value.xy = xy;
  value.xz = xz;
  value.yz = yz;
  return value;
}

/* Bo = Bi.
   Bi, Bo: spatial inertia (m in kg; h = m c in kg m; I about the origin, xx, yy, zz, xy, xz, yz
     in kg m^2).
   No arithmetic.
   Exact. */
static inline void ksl_spatial_inertiaf_copy(const ksl_spatial_inertiaf_t *Bi,
    ksl_spatial_inertiaf_t *Bo) {
  const float Bi_m = Bi->m;
  const float Bi_h_x = Bi->h.x;
  const float Bi_h_y = Bi->h.y;
  const float Bi_h_z = Bi->h.z;
  const float Bi_xx = Bi->xx;
  const float Bi_yy = Bi->yy;
  const float Bi_zz = Bi->zz;
  const float Bi_xy = Bi->xy;
  const float Bi_xz = Bi->xz;
  const float Bi_yz = Bi->yz;
  Bo->m = Bi_m;
  Bo->h.x = Bi_h_x;
  Bo->h.y = Bi_h_y;
  Bo->h.z = Bi_h_z;
  Bo->xx = Bi_xx;
  Bo->yy = Bi_yy;
  Bo->zz = Bi_zz;
  Bo->xy = Bi_xy;
  Bo->xz = Bi_xz;
  Bo->yz = Bi_yz;
}

/* self = a self.
   self: spatial inertia (m in kg; h = m c in kg m; I about the origin, xx, yy, zz, xy, xz, yz in
     kg m^2); a: number.
   10 mul.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_spatial_inertiaf_scale(ksl_spatial_inertiaf_t *self, const float a) {
  const float self_0_new = KSL_MULF(self->m, a), self_1_new = KSL_MULF(self->h.x, a),
      self_2_new = KSL_MULF(self->h.y, a), self_3_new = KSL_MULF(self->h.z, a),
      self_4_new = KSL_MULF(self->xx, a), self_5_new = KSL_MULF(self->yy, a),
      self_6_new = KSL_MULF(self->zz, a), self_7_new = KSL_MULF(self->xy, a),
      self_8_new = KSL_MULF(self->xz, a), self_9_new = KSL_MULF(self->yz, a);
  self->m = self_0_new;
  self->h.x = self_1_new;
  self->h.y = self_2_new;
  self->h.z = self_3_new;
  self->xx = self_4_new;
  self->yy = self_5_new;
  self->zz = self_6_new;
  self->xy = self_7_new;
  self->xz = self_8_new;
  self->yz = self_9_new;
}

/* Bo = B1 + B2.
   B1, B2, Bo: spatial inertia (m in kg; h = m c in kg m; I about the origin, xx, yy, zz, xy, xz,
     yz in kg m^2).
   10 add.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_add_BBf(const ksl_spatial_inertiaf_t *B1, const ksl_spatial_inertiaf_t *B2,
    ksl_spatial_inertiaf_t *Bo) {
  const float Bo_0 = B1->m + B2->m, Bo_1 = B1->h.x + B2->h.x, Bo_2 = B1->h.y + B2->h.y,
      Bo_3 = B1->h.z + B2->h.z, Bo_4 = B1->xx + B2->xx, Bo_5 = B1->yy + B2->yy,
      Bo_6 = B1->zz + B2->zz, Bo_7 = B1->xy + B2->xy, Bo_8 = B1->xz + B2->xz,
      Bo_9 = B1->yz + B2->yz;
  Bo->m = Bo_0;
  Bo->h.x = Bo_1;
  Bo->h.y = Bo_2;
  Bo->h.z = Bo_3;
  Bo->xx = Bo_4;
  Bo->yy = Bo_5;
  Bo->zz = Bo_6;
  Bo->xy = Bo_7;
  Bo->xz = Bo_8;
  Bo->yz = Bo_9;
}

/* Bo = B1 - B2.
   B1, B2, Bo: spatial inertia (m in kg; h = m c in kg m; I about the origin, xx, yy, zz, xy, xz,
     yz in kg m^2).
   10 add.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_subtract_BBf(const ksl_spatial_inertiaf_t *B1,
    const ksl_spatial_inertiaf_t *B2, ksl_spatial_inertiaf_t *Bo) {
  const float Bo_0 = B1->m - B2->m, Bo_1 = B1->h.x - B2->h.x, Bo_2 = B1->h.y - B2->h.y,
      Bo_3 = B1->h.z - B2->h.z, Bo_4 = B1->xx - B2->xx, Bo_5 = B1->yy - B2->yy,
      Bo_6 = B1->zz - B2->zz, Bo_7 = B1->xy - B2->xy, Bo_8 = B1->xz - B2->xz,
      Bo_9 = B1->yz - B2->yz;
  Bo->m = Bo_0;
  Bo->h.x = Bo_1;
  Bo->h.y = Bo_2;
  Bo->h.z = Bo_3;
  Bo->xx = Bo_4;
  Bo->yy = Bo_5;
  Bo->zz = Bo_6;
  Bo->xy = Bo_7;
  Bo->xz = Bo_8;
  Bo->yz = Bo_9;
}

/* Bo: mass m, centre of mass com, second moments Ic about it (kg m^2; only the upper triangle is
     read): h = m com, I = Ic - m com~ com~.
   m: number; com: vector; Ic: rotation or other 3×3 matrix; Bo: spatial inertia (m in kg; h = m
     c in kg m; I about the origin, xx, yy, zz, xy, xz, yz in kg m^2).
   9 mul, 9 add.
   Error <= u |result| + (m: 0, h: 0, I: 3) u S, S the sum of the |terms| of the expanded
     formula; barring over- and underflow. */
static inline void ksl_spatial_inertiaf_from_com(const float m, const ksl_vec3f_t *com,
    const ksl_mat3x3f_t *Ic, ksl_spatial_inertiaf_t *Bo) {
  const float h_0 = KSL_MULF(m, com->x), h_1 = KSL_MULF(m, com->y), h_2 = KSL_MULF(m, com->z);
  const float squares_0 = KSL_MULF(com->x, h_0), squares_1 = KSL_MULF(com->y, h_1),
      squares_2 = KSL_MULF(com->z, h_2);
  const float Bo_4 = Ic->m00 + (squares_1 + squares_2), Bo_5 = Ic->m11 + (squares_0 + squares_2),
      Bo_6 = Ic->m22 + (squares_0 + squares_1), Bo_7 = Ic->m01 - KSL_MULF(com->y, h_0),
      Bo_8 = Ic->m02 - KSL_MULF(com->z, h_0), Bo_9 = Ic->m12 - KSL_MULF(com->z, h_1);
  Bo->m = m;
  Bo->h.x = h_0;
  Bo->h.y = h_1;
  Bo->h.z = h_2;
  Bo->xx = Bo_4;
  Bo->yy = Bo_5;
  Bo->zz = Bo_6;
  Bo->xy = Bo_7;
  Bo->xz = Bo_8;
  Bo->yz = Bo_9;
}

/* Bo = (m, mt, I - mt~ mt~ / m) from the inertia J, whose moments are about the centre of mass;
     NaN where m = 0.
   J: inertia (m in kg; mt = m c in kg m; I about the centre of mass c, xx, yy, zz, xy, yz, zx in
     kg m^2); Bo: spatial inertia (m in kg; h = m c in kg m; I about the origin, xx, yy, zz, xy,
     xz, yz in kg m^2).
   6 mul, 9 add, 3 div.
   Error of a moment <= 4 u times the sum of its |terms|, barring over- and underflow. */
static inline void ksl_spatial_inertiaf_from_inertia(const ksl_inertiaf_t *J,
    ksl_spatial_inertiaf_t *Bo) {
  const float c_0 = J->mt.x / J->m, c_1 = J->mt.y / J->m, c_2 = J->mt.z / J->m;
  const float squares_0 = KSL_MULF(J->mt.x, c_0), squares_1 = KSL_MULF(J->mt.y, c_1),
      squares_2 = KSL_MULF(J->mt.z, c_2);
  const float Bo_4 = J->Ixx + (squares_1 + squares_2), Bo_5 = J->Iyy + (squares_0 + squares_2),
      Bo_6 = J->Izz + (squares_0 + squares_1), Bo_7 = J->Ixy - KSL_MULF(J->mt.x, c_1),
      Bo_8 = J->Izx - KSL_MULF(J->mt.x, c_2), Bo_9 = J->Iyz - KSL_MULF(J->mt.y, c_2);
  const float J_m = J->m;
  const float J_mt_x = J->mt.x;
  const float J_mt_y = J->mt.y;
  const float J_mt_z = J->mt.z;
  Bo->m = J_m;
  Bo->h.x = J_mt_x;
  Bo->h.y = J_mt_y;
  Bo->h.z = J_mt_z;
  Bo->xx = Bo_4;
  Bo->yy = Bo_5;
  Bo->zz = Bo_6;
  Bo->xy = Bo_7;
  Bo->xz = Bo_8;
  Bo->yz = Bo_9;
}

/* Jo = (m, h, I + h~ h~ / m) from the spatial inertia B, with moments about the centre of mass;
     NaN where m = 0.
   B: spatial inertia (m in kg; h = m c in kg m; I about the origin, xx, yy, zz, xy, xz, yz in kg
     m^2); Jo: inertia (m in kg; mt = m c in kg m; I about the centre of mass c, xx, yy, zz, xy,
     yz, zx in kg m^2).
   6 mul, 9 add, 3 div.
   Error of a moment <= 4 u times the sum of its |terms|, barring over- and underflow. */
static inline void ksl_inertiaf_from_spatial_inertia(const ksl_spatial_inertiaf_t *B,
    ksl_inertiaf_t *Jo) {
  const float c_0 = B->h.x / B->m, c_1 = B->h.y / B->m, c_2 = B->h.z / B->m;
  const float squares_0 = KSL_MULF(B->h.x, c_0), squares_1 = KSL_MULF(B->h.y, c_1),
      squares_2 = KSL_MULF(B->h.z, c_2);
  const float Jo_4 = B->xx - (squares_1 + squares_2), Jo_5 = B->yy - (squares_0 + squares_2),
      Jo_6 = B->zz - (squares_0 + squares_1), Jo_7 = KSL_MULF(B->h.x, c_1) + B->xy,
      Jo_8 = KSL_MULF(B->h.y, c_2) + B->yz, Jo_9 = KSL_MULF(B->h.x, c_2) + B->xz;
  const float B_m = B->m;
  const float B_h_x = B->h.x;
  const float B_h_y = B->h.y;
  const float B_h_z = B->h.z;
  Jo->m = B_m;
  Jo->mt.x = B_h_x;
  Jo->mt.y = B_h_y;
  Jo->mt.z = B_h_z;
  Jo->Ixx = Jo_4;
  Jo->Iyy = Jo_5;
  Jo->Izz = Jo_6;
  Jo->Ixy = Jo_7;
  Jo->Iyz = Jo_8;
  Jo->Izx = Jo_9;
}

/* vo = h / m, the centre of mass in m.
   B: spatial inertia (m in kg; h = m c in kg m; I about the origin, xx, yy, zz, xy, xz, yz in kg
     m^2); vo: vector.
   3 div.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_spatial_inertiaf_com(const ksl_spatial_inertiaf_t *B, ksl_vec3f_t *vo) {
  const float vo_0 = B->h.x / B->m, vo_1 = B->h.y / B->m, vo_2 = B->h.z / B->m;
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
}

/* Ro = I + h~ h~ / m, the second moments about the centre of mass.
   B: spatial inertia (m in kg; h = m c in kg m; I about the origin, xx, yy, zz, xy, xz, yz in kg
     m^2); Ro: rotation or other 3×3 matrix.
   6 mul, 9 add, 3 div. */
static inline void ksl_spatial_inertiaf_about_com(const ksl_spatial_inertiaf_t *B,
    ksl_mat3x3f_t *Ro) {
  const float c_0 = B->h.x / B->m, c_1 = B->h.y / B->m, c_2 = B->h.z / B->m;
  const float squares_0 = KSL_MULF(B->h.x, c_0), squares_1 = KSL_MULF(B->h.y, c_1),
      squares_2 = KSL_MULF(B->h.z, c_2);
  const float about_0 = B->xx - (squares_1 + squares_2), about_1 = B->yy - (squares_0 + squares_2),
      about_2 = B->zz - (squares_0 + squares_1), about_3 = KSL_MULF(B->h.x, c_1) + B->xy,
      about_4 = KSL_MULF(B->h.x, c_2) + B->xz, about_5 = KSL_MULF(B->h.y, c_2) + B->yz;
  Ro->m00 = about_0;
  Ro->m01 = about_3;
  Ro->m02 = about_4;
  Ro->m10 = about_3;
  Ro->m11 = about_1;
  Ro->m12 = about_5;
  Ro->m20 = about_4;
  Ro->m21 = about_5;
  Ro->m22 = about_2;
}

/* Mo = [[m 1, -h~], [h~, I]].
   B: spatial inertia (m in kg; h = m c in kg m; I about the origin, xx, yy, zz, xy, xz, yz in kg
     m^2); Mo: 6×6 operator.
   3 neg.
   Exact. */
static inline void ksl_spatial_inertiaf_matrix(const ksl_spatial_inertiaf_t *B, ksl_mat6x6f_t *Mo) {
  const float Mo_05 = -B->h.y, Mo_13 = -B->h.z, Mo_24 = -B->h.x;
  const float B_m = B->m;
  const float B_h_z = B->h.z;
  const float B_h_x = B->h.x;
  const float B_h_y = B->h.y;
  const float B_xx = B->xx;
  const float B_xy = B->xy;
  const float B_xz = B->xz;
  const float B_yy = B->yy;
  const float B_yz = B->yz;
  const float B_zz = B->zz;
  Mo->at[0][0] = B_m;
  Mo->at[1][0] = 0.0f;
  Mo->at[2][0] = 0.0f;
  Mo->at[3][0] = 0.0f;
  Mo->at[4][0] = B_h_z;
  Mo->at[5][0] = Mo_05;
  Mo->at[0][1] = 0.0f;
  Mo->at[1][1] = B_m;
  Mo->at[2][1] = 0.0f;
  Mo->at[3][1] = Mo_13;
  Mo->at[4][1] = 0.0f;
  Mo->at[5][1] = B_h_x;
  Mo->at[0][2] = 0.0f;
  Mo->at[1][2] = 0.0f;
  Mo->at[2][2] = B_m;
  Mo->at[3][2] = B_h_y;
  Mo->at[4][2] = Mo_24;
  Mo->at[5][2] = 0.0f;
  Mo->at[0][3] = 0.0f;
  Mo->at[1][3] = Mo_13;
  Mo->at[2][3] = B_h_y;
  Mo->at[3][3] = B_xx;
  Mo->at[4][3] = B_xy;
  Mo->at[5][3] = B_xz;
  Mo->at[0][4] = B_h_z;
  Mo->at[1][4] = 0.0f;
  Mo->at[2][4] = Mo_24;
  Mo->at[3][4] = B_xy;
  Mo->at[4][4] = B_yy;
  Mo->at[5][4] = B_yz;
  Mo->at[0][5] = Mo_05;
  Mo->at[1][5] = B_h_x;
  Mo->at[2][5] = 0.0f;
  Mo->at[3][5] = B_xz;
  Mo->at[4][5] = B_yz;
  Mo->at[5][5] = B_zz;
}

/* co = B s = (m v - h × ω; h × v + I ω), the momentum of a body that moves with s.
   B: spatial inertia (m in kg; h = m c in kg m; I about the origin, xx, yy, zz, xy, xz, yz in kg
     m^2); s: screw (v in m/s; ω in rad/s); co: coscrew (f in N; τ in N m).
   24 mul, 18 add.
   Error <= u |result| + (lin: 2, ang: 3) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_Bsf(const ksl_spatial_inertiaf_t *B, const ksl_screwf_t *s,
    ksl_coscrewf_t *co) {
  const float co_0 = KSL_MULF(B->m, s->m0) + (KSL_MULF(B->h.z, s->m4) - KSL_MULF(B->h.y, s->m5)),
      co_1 = KSL_MULF(B->m, s->m1) + (KSL_MULF(B->h.x, s->m5) - KSL_MULF(B->h.z, s->m3)),
      co_2 = KSL_MULF(B->m, s->m2) + (KSL_MULF(B->h.y, s->m3) - KSL_MULF(B->h.x, s->m4)),
      co_3 = KSL_MULF(B->h.y, s->m2) - KSL_MULF(B->h.z, s->m1)
          + (KSL_MULF(B->xx, s->m3) + KSL_MULF(B->xy, s->m4) + KSL_MULF(B->xz, s->m5)),
      co_4 = KSL_MULF(B->h.z, s->m0) - KSL_MULF(B->h.x, s->m2)
          + (KSL_MULF(B->yy, s->m4) + KSL_MULF(B->xy, s->m3) + KSL_MULF(B->yz, s->m5)),
      co_5 = KSL_MULF(B->h.x, s->m1) - KSL_MULF(B->h.y, s->m0)
          + (KSL_MULF(B->zz, s->m5) + KSL_MULF(B->xz, s->m3) + KSL_MULF(B->yz, s->m4));
  co->m0 = co_0;
  co->m1 = co_1;
  co->m2 = co_2;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
}

/* s·B s / 2, the kinetic energy in J of a body that moves with s.
   B: spatial inertia (m in kg; h = m c in kg m; I about the origin, xx, yy, zz, xy, xz, yz in kg
     m^2); s: screw (v in m/s; ω in rad/s).
   26 mul, 17 add.
   Error <= u |result| + 7 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline float ksl_spatial_inertiaf_energy(const ksl_spatial_inertiaf_t *B,
    const ksl_screwf_t *s) {
  const float square = KSL_MULF(s->m0, s->m0) + KSL_MULF(s->m1, s->m1) + KSL_MULF(s->m2, s->m2);
  const float L_0 = KSL_MULF(B->xx, s->m3) + KSL_MULF(B->xy, s->m4) + KSL_MULF(B->xz, s->m5),
      L_1 = KSL_MULF(B->yy, s->m4) + KSL_MULF(B->xy, s->m3) + KSL_MULF(B->yz, s->m5),
      L_2 = KSL_MULF(B->zz, s->m5) + KSL_MULF(B->xz, s->m3) + KSL_MULF(B->yz, s->m4);
  const float twice = KSL_MULF(B->m, square)
          + (KSL_MULF(s->m3, L_0) + KSL_MULF(s->m4, L_1) + KSL_MULF(s->m5, L_2));
  const float across_0 = KSL_MULF(B->h.z, s->m4) - KSL_MULF(B->h.y, s->m5),
      across_1 = KSL_MULF(B->h.x, s->m5) - KSL_MULF(B->h.z, s->m3),
      across_2 = KSL_MULF(B->h.y, s->m3) - KSL_MULF(B->h.x, s->m4);
  const float energy = KSL_MULF(s->m0, across_0) + KSL_MULF(s->m1, across_1)
          + KSL_MULF(s->m2, across_2) + KSL_MULF(0.5f, twice);
  return energy;
}

/* co = B ds + (w × (w × h); w × I w): the net wrench, about the origin, of a body with angular
     velocity w and acceleration ds = (a; w'), where a is that of the point now at the origin; if
     a is less gravity's, so is the wrench.
   B: spatial inertia (m in kg; h = m c in kg m; I about the origin, xx, yy, zz, xy, xz, yz in kg
     m^2); w: vector; ds: screw (v in m/s; ω in rad/s); co: coscrew (f in N; τ in N m).
   39 mul, 42 add, 3 neg.
   Error <= u |result| + (lin: 5, ang: 6) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_spatial_inertiaf_net_wrench(const ksl_spatial_inertiaf_t *B,
    const ksl_vec3f_t *w, const ksl_screwf_t *ds, ksl_coscrewf_t *co) {
  const float ww_0 = KSL_MULF(w->x, w->x), ww_1 = KSL_MULF(w->y, w->y), ww_2 = KSL_MULF(w->z, w->z),
      ww_3 = KSL_MULF(w->x, w->y), ww_4 = KSL_MULF(w->x, w->z), ww_5 = KSL_MULF(w->y, w->z);
  const float U_0 = -(ww_1 + ww_2), U_1 = ww_3 - ds->m5, U_2 = ds->m4 + ww_4, U_3 = ds->m5 + ww_3,
      U_4 = -(ww_0 + ww_2), U_5 = ww_5 - ds->m3, U_6 = ww_4 - ds->m4, U_7 = ds->m3 + ww_5,
      U_8 = -(ww_0 + ww_1);
  const float others_0 = B->zz - B->yy, others_1 = B->xx - B->zz, others_2 = B->yy - B->xx;
  const float squares_0 = ww_1 - ww_2, squares_1 = ww_2 - ww_0, squares_2 = ww_0 - ww_1;
  const float own_0 = KSL_MULF(B->xx, ds->m3) + KSL_MULF(ww_5, others_0),
      own_1 = KSL_MULF(B->yy, ds->m4) + KSL_MULF(ww_4, others_1),
      own_2 = KSL_MULF(B->zz, ds->m5) + KSL_MULF(ww_3, others_2);
  const float N_0 = KSL_MULF(B->xz, U_3) - KSL_MULF(B->xy, U_6) + KSL_MULF(B->yz, squares_0)
          + own_0,
      N_1 = KSL_MULF(B->xy, U_7) - KSL_MULF(B->yz, U_1) + KSL_MULF(B->xz, squares_1) + own_1,
      N_2 = KSL_MULF(B->xy, squares_2) + (KSL_MULF(B->yz, U_2) - KSL_MULF(B->xz, U_5)) + own_2;
  const float co_0 = KSL_MULF(B->m, ds->m0)
          + (KSL_MULF(B->h.x, U_0) + KSL_MULF(B->h.y, U_1) + KSL_MULF(B->h.z, U_2)),
      co_1 = KSL_MULF(B->m, ds->m1)
          + (KSL_MULF(B->h.x, U_3) + KSL_MULF(B->h.y, U_4) + KSL_MULF(B->h.z, U_5)),
      co_2 = KSL_MULF(B->m, ds->m2)
          + (KSL_MULF(B->h.x, U_6) + KSL_MULF(B->h.y, U_7) + KSL_MULF(B->h.z, U_8)),
      co_3 = KSL_MULF(B->h.y, ds->m2) - KSL_MULF(B->h.z, ds->m1) + N_0,
      co_4 = KSL_MULF(B->h.z, ds->m0) - KSL_MULF(B->h.x, ds->m2) + N_1,
      co_5 = KSL_MULF(B->h.x, ds->m1) - KSL_MULF(B->h.y, ds->m0) + N_2;
  co->m0 = co_0;
  co->m1 = co_1;
  co->m2 = co_2;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
}

/* Bo = B moved by t: m, h + m t, I - t~ (h + m t)~ - h~ t~.
   t: vector; B, Bo: spatial inertia (m in kg; h = m c in kg m; I about the origin, xx, yy, zz,
     xy, xz, yz in kg m^2).
   18 mul, 18 add.
   Error <= u |result| + (m: 0, h: 1, I: 4) u S, S the sum of the |terms| of the expanded
     formula; barring over- and underflow. */
static inline void ksl_spatial_inertiaf_shifted(const ksl_vec3f_t *t,
    const ksl_spatial_inertiaf_t *B, ksl_spatial_inertiaf_t *Bo) {
  const float mt_0 = KSL_MULF(t->x, B->m), mt_1 = KSL_MULF(t->y, B->m), mt_2 = KSL_MULF(t->z, B->m);
  const float half_0 = KSL_MULF(0.5f, mt_0), half_1 = KSL_MULF(0.5f, mt_1),
      half_2 = KSL_MULF(0.5f, mt_2);
  const float n_0 = B->h.x + half_0, n_1 = B->h.y + half_1, n_2 = B->h.z + half_2;
  const float tn0 = KSL_MULF(t->x, n_0);
  const float tn1 = KSL_MULF(t->y, n_1);
  const float tn2 = KSL_MULF(t->z, n_2);
  const float own_0 = KSL_MULF(2.0f, tn0), own_1 = KSL_MULF(2.0f, tn1), own_2 = KSL_MULF(2.0f, tn2);
  const float pairs_0 = own_1 + own_2, pairs_1 = own_0 + own_2, pairs_2 = own_0 + own_1,
      pairs_3 = KSL_MULF(t->x, n_1) + KSL_MULF(t->y, n_0),
      pairs_4 = KSL_MULF(t->x, n_2) + KSL_MULF(t->z, n_0),
      pairs_5 = KSL_MULF(t->y, n_2) + KSL_MULF(t->z, n_1);
  const float moved_0 = B->h.x + mt_0, moved_1 = B->h.y + mt_1, moved_2 = B->h.z + mt_2;
  const float Bo_4 = B->xx + pairs_0, Bo_5 = B->yy + pairs_1, Bo_6 = B->zz + pairs_2,
      Bo_7 = B->xy - pairs_3, Bo_8 = B->xz - pairs_4, Bo_9 = B->yz - pairs_5;
  const float B_m = B->m;
  Bo->m = B_m;
  Bo->h.x = moved_0;
  Bo->h.y = moved_1;
  Bo->h.z = moved_2;
  Bo->xx = Bo_4;
  Bo->yy = Bo_5;
  Bo->zz = Bo_6;
  Bo->xy = Bo_7;
  Bo->xz = Bo_8;
  Bo->yz = Bo_9;
}

/* Bo = [Ad]*(D) B [Ad]^-1(D): B, given in the frame at D, in the reference frame.
   D: displacement [R | t], R rotation, t in m; B, Bo: spatial inertia (m in kg; h = m c in kg m;
     I about the origin, xx, yy, zz, xy, xz, yz in kg m^2).
   72 mul, 54 add.
   Error <= u |result| + (m: 0, h: 3, I: 6) u S, S the sum of the |terms| of the expanded
     formula; barring over- and underflow. */
static inline void ksl_spatial_inertiaf_transformed(const ksl_SE3f_t *D,
    const ksl_spatial_inertiaf_t *B, ksl_spatial_inertiaf_t *Bo) {
  const float RI_0 = KSL_MULF(D->m00, B->xx) + KSL_MULF(D->m01, B->xy) + KSL_MULF(D->m02, B->xz),
      RI_1 = KSL_MULF(D->m00, B->xy) + KSL_MULF(D->m01, B->yy) + KSL_MULF(D->m02, B->yz),
      RI_2 = KSL_MULF(D->m00, B->xz) + KSL_MULF(D->m01, B->yz) + KSL_MULF(D->m02, B->zz),
      RI_3 = KSL_MULF(D->m10, B->xx) + KSL_MULF(D->m11, B->xy) + KSL_MULF(D->m12, B->xz),
      RI_4 = KSL_MULF(D->m10, B->xy) + KSL_MULF(D->m11, B->yy) + KSL_MULF(D->m12, B->yz),
      RI_5 = KSL_MULF(D->m10, B->xz) + KSL_MULF(D->m11, B->yz) + KSL_MULF(D->m12, B->zz),
      RI_6 = KSL_MULF(D->m20, B->xx) + KSL_MULF(D->m21, B->xy) + KSL_MULF(D->m22, B->xz),
      RI_7 = KSL_MULF(D->m20, B->xy) + KSL_MULF(D->m21, B->yy) + KSL_MULF(D->m22, B->yz),
      RI_8 = KSL_MULF(D->m20, B->xz) + KSL_MULF(D->m21, B->yz) + KSL_MULF(D->m22, B->zz);
  const float turned_1 = KSL_MULF(D->m00, B->h.x) + KSL_MULF(D->m01, B->h.y)
          + KSL_MULF(D->m02, B->h.z),
      turned_2 = KSL_MULF(D->m10, B->h.x) + KSL_MULF(D->m11, B->h.y) + KSL_MULF(D->m12, B->h.z),
      turned_3 = KSL_MULF(D->m20, B->h.x) + KSL_MULF(D->m21, B->h.y) + KSL_MULF(D->m22, B->h.z),
      turned_4 = KSL_MULF(D->m00, RI_0) + KSL_MULF(D->m01, RI_1) + KSL_MULF(D->m02, RI_2),
      turned_5 = KSL_MULF(D->m10, RI_3) + KSL_MULF(D->m11, RI_4) + KSL_MULF(D->m12, RI_5),
      turned_6 = KSL_MULF(D->m20, RI_6) + KSL_MULF(D->m21, RI_7) + KSL_MULF(D->m22, RI_8),
      turned_7 = KSL_MULF(D->m10, RI_0) + KSL_MULF(D->m11, RI_1) + KSL_MULF(D->m12, RI_2),
      turned_8 = KSL_MULF(D->m20, RI_0) + KSL_MULF(D->m21, RI_1) + KSL_MULF(D->m22, RI_2),
      turned_9 = KSL_MULF(D->m20, RI_3) + KSL_MULF(D->m21, RI_4) + KSL_MULF(D->m22, RI_5);
  const float mt_0 = KSL_MULF(D->m03, B->m), mt_1 = KSL_MULF(D->m13, B->m),
      mt_2 = KSL_MULF(D->m23, B->m);
  const float half_0 = KSL_MULF(0.5f, mt_0), half_1 = KSL_MULF(0.5f, mt_1),
      half_2 = KSL_MULF(0.5f, mt_2);
  const float n_0 = turned_1 + half_0, n_1 = turned_2 + half_1, n_2 = turned_3 + half_2;
  const float tn0 = KSL_MULF(D->m03, n_0);
  const float tn1 = KSL_MULF(D->m13, n_1);
  const float tn2 = KSL_MULF(D->m23, n_2);
  const float own_0 = KSL_MULF(2.0f, tn0), own_1 = KSL_MULF(2.0f, tn1), own_2 = KSL_MULF(2.0f, tn2);
  const float pairs_0 = own_1 + own_2, pairs_1 = own_0 + own_2, pairs_2 = own_0 + own_1,
      pairs_3 = KSL_MULF(D->m03, n_1) + KSL_MULF(D->m13, n_0),
      pairs_4 = KSL_MULF(D->m03, n_2) + KSL_MULF(D->m23, n_0),
      pairs_5 = KSL_MULF(D->m13, n_2) + KSL_MULF(D->m23, n_1);
  const float moved_0 = turned_1 + mt_0, moved_1 = turned_2 + mt_1, moved_2 = turned_3 + mt_2;
  const float Bo_4 = turned_4 + pairs_0, Bo_5 = turned_5 + pairs_1, Bo_6 = turned_6 + pairs_2,
      Bo_7 = turned_7 - pairs_3, Bo_8 = turned_8 - pairs_4, Bo_9 = turned_9 - pairs_5;
  const float B_m = B->m;
  Bo->m = B_m;
  Bo->h.x = moved_0;
  Bo->h.y = moved_1;
  Bo->h.z = moved_2;
  Bo->xx = Bo_4;
  Bo->yy = Bo_5;
  Bo->zz = Bo_6;
  Bo->xy = Bo_7;
  Bo->xz = Bo_8;
  Bo->yz = Bo_9;
}

/* the smallest pivot of [[m, h^T], [h, tr(I)/2 1 - I]], each divided by its diagonal entry:
     positive exactly if a body of positive density has this inertia.
   B: spatial inertia (m in kg; h = m c in kg m; I about the origin, xx, yy, zz, xy, xz, yz in kg
     m^2).
   11 mul, 15 add, 10 div, 3 neg, 9 less, 13 select. */
static inline float ksl_spatial_inertiaf_consistency(const ksl_spatial_inertiaf_t *B) {
  const float twice_trace = B->xx + B->yy + B->zz;
  const float trace = KSL_MULF(0.5f, twice_trace);
  const float sigma_0 = trace - B->xx, sigma_1 = trace - B->yy, sigma_2 = trace - B->zz;
  const float divisor0 = 0.0f < B->m ? B->m : 1.0f;
  const float l0_0 = B->h.x / divisor0, l0_1 = B->h.y / divisor0, l0_2 = B->h.z / divisor0;
  const float u1_0 = sigma_0 - KSL_MULF(B->h.x, l0_0), u1_1 = -(KSL_MULF(B->h.y, l0_0) + B->xy),
      u1_2 = -(KSL_MULF(B->h.z, l0_0) + B->xz);
  const float divisor1 = 0.0f < u1_0 ? u1_0 : 1.0f;
  const float l1_0 = u1_1 / divisor1, l1_1 = u1_2 / divisor1;
  const float u2_0 = sigma_1 - KSL_MULF(B->h.y, l0_1) - KSL_MULF(u1_1, l1_0),
      u2_1 = -(KSL_MULF(B->h.z, l0_1) + B->yz + KSL_MULF(u1_2, l1_0));
  const float divisor2 = 0.0f < u2_0 ? u2_0 : 1.0f;
  const float l2 = u2_1 / divisor2;
  const float u3 = sigma_2 - KSL_MULF(B->h.z, l0_2) - KSL_MULF(u1_2, l1_1) - KSL_MULF(u2_1, l2);
  const float part0a = B->m / divisor0, part0 = 0.0f < B->m ? part0a : B->m;
  const float own1 = 0.0f < sigma_0 ? sigma_0 : 1.0f;
  const float part1a = u1_0 / own1, part1 = 0.0f < sigma_0 ? part1a : sigma_0;
  const float smallest1 = part0 < part1 ? part0 : part1;
  const float own2 = 0.0f < sigma_1 ? sigma_1 : 1.0f;
  const float part2a = u2_0 / own2, part2 = 0.0f < sigma_1 ? part2a : sigma_1;
  const float smallest2 = smallest1 < part2 ? smallest1 : part2;
  const float own3 = 0.0f < sigma_2 ? sigma_2 : 1.0f;
  const float part3a = u3 / own3, part3 = 0.0f < sigma_2 ? part3a : sigma_2;
  const float smallest3 = smallest2 < part3 ? smallest2 : part3;
  return smallest3;
}

#ifndef KSL_NO_ALLOC
#include <stdlib.h>

/* n ksl_spatial_inertia_t on the heap, zeros, to be freed by the caller; NULL for n <= 0 or when
     there is no memory. */
static inline ksl_spatial_inertia_t *ksl_spatial_inertia_alloc(int n) {
  return n > 0 ? (ksl_spatial_inertia_t *)calloc((size_t)n, sizeof(ksl_spatial_inertia_t)) : NULL;
}

/* n ksl_spatial_inertiaf_t on the heap, zeros, to be freed by the caller; NULL for n <= 0 or
     when there is no memory. */
static inline ksl_spatial_inertiaf_t *ksl_spatial_inertiaf_alloc(int n) {
  return n > 0 ? (ksl_spatial_inertiaf_t *)calloc((size_t)n, sizeof(ksl_spatial_inertiaf_t)) : NULL;
}

#endif

#endif
