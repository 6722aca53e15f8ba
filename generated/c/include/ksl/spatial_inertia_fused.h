/* Made by `coscrew generate`; changes are overwritten. */
/* SPDX-License-Identifier: MIT */
/* coscrew 0.2.0.  Copyright (c) 2026 The coscrew authors. */
/* Spatial inertias of rigid bodies: mass, first moment, second moments about the origin.
   Fused tier: products fused into sums. */
#ifndef KSL_SPATIAL_INERTIA_FUSED_H
#define KSL_SPATIAL_INERTIA_FUSED_H

#include "ksl_types.h"

/* self = a self.
   self: spatial inertia (m in kg; h = m c in kg m; I about the origin, xx, yy, zz, xy, xz, yz in
     kg m^2); a: number.
   10 mul.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_spatial_inertia_scale_fused(ksl_spatial_inertia_t *self, const double a) {
  const double self_0_new = KSL_MUL(self->m, a);
  const double self_1_new = KSL_MUL(self->h.x, a);
  const double self_2_new = KSL_MUL(self->h.y, a);
  const double self_3_new = KSL_MUL(self->h.z, a);
  const double self_4_new = KSL_MUL(self->xx, a);
  const double self_5_new = KSL_MUL(self->yy, a);
  const double self_6_new = KSL_MUL(self->zz, a);
  const double self_7_new = KSL_MUL(self->xy, a);
  const double self_8_new = KSL_MUL(self->xz, a);
  const double self_9_new = KSL_MUL(self->yz, a);
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
static inline void ksl_add_BB_fused(const ksl_spatial_inertia_t *B1,
    const ksl_spatial_inertia_t *B2, ksl_spatial_inertia_t *Bo) {
  const double Bo_0 = B1->m + B2->m;
  const double Bo_1 = B1->h.x + B2->h.x;
  const double Bo_2 = B1->h.y + B2->h.y;
  const double Bo_3 = B1->h.z + B2->h.z;
  const double Bo_4 = B1->xx + B2->xx;
  const double Bo_5 = B1->yy + B2->yy;
  const double Bo_6 = B1->zz + B2->zz;
  const double Bo_7 = B1->xy + B2->xy;
  const double Bo_8 = B1->xz + B2->xz;
  const double Bo_9 = B1->yz + B2->yz;
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
static inline void ksl_subtract_BB_fused(const ksl_spatial_inertia_t *B1,
    const ksl_spatial_inertia_t *B2, ksl_spatial_inertia_t *Bo) {
  const double Bo_0 = B1->m - B2->m;
  const double Bo_1 = B1->h.x - B2->h.x;
  const double Bo_2 = B1->h.y - B2->h.y;
  const double Bo_3 = B1->h.z - B2->h.z;
  const double Bo_4 = B1->xx - B2->xx;
  const double Bo_5 = B1->yy - B2->yy;
  const double Bo_6 = B1->zz - B2->zz;
  const double Bo_7 = B1->xy - B2->xy;
  const double Bo_8 = B1->xz - B2->xz;
  const double Bo_9 = B1->yz - B2->yz;
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
   6 mul, 6 add, 3 fma.
   Error <= u |result| + (m: 0, h: 0, I: 3) u S, S the sum of the |terms| of the expanded
     formula; barring over- and underflow. */
static inline void ksl_spatial_inertia_from_com_fused(const double m, const ksl_vec3_t *com,
    const ksl_mat3x3_t *Ic, ksl_spatial_inertia_t *Bo) {
  const double h_0 = KSL_MUL(m, com->x);
  const double h_1 = KSL_MUL(m, com->y);
  const double h_2 = KSL_MUL(m, com->z);
  const double squares_0 = KSL_MUL(com->x, h_0);
  const double squares_1 = KSL_MUL(com->y, h_1);
  const double squares_2 = KSL_MUL(com->z, h_2);
  const double Bo_4a = squares_1 + squares_2, Bo_4 = Ic->m00 + Bo_4a;
  const double Bo_5a = squares_0 + squares_2, Bo_5 = Ic->m11 + Bo_5a;
  const double Bo_6a = squares_0 + squares_1, Bo_6 = Ic->m22 + Bo_6a;
  const double Bo_7 = fma(-com->y, h_0, Ic->m01);
  const double Bo_8 = fma(-com->z, h_0, Ic->m02);
  const double Bo_9 = fma(-com->z, h_1, Ic->m12);
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

/* co = B s = (m v - h × ω; h × v + I ω), the momentum of a body that moves with s.
   B: spatial inertia (m in kg; h = m c in kg m; I about the origin, xx, yy, zz, xy, xz, yz in kg
     m^2); s: screw (v in m/s; ω in rad/s); co: coscrew (f in N; τ in N m).
   9 mul, 3 add, 15 fma.
   Error <= u |result| + (lin: 2, ang: 3) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_Bs_fused(const ksl_spatial_inertia_t *B, const ksl_screw_t *s,
    ksl_coscrew_t *co) {
  const double co_0b = KSL_MUL(B->h.z, s->m4), co_0d = fma(-B->h.y, s->m5, co_0b),
      co_0 = fma(B->m, s->m0, co_0d);
  const double co_1b = KSL_MUL(B->h.x, s->m5), co_1d = fma(-B->h.z, s->m3, co_1b),
      co_1 = fma(B->m, s->m1, co_1d);
  const double co_2b = KSL_MUL(B->h.y, s->m3), co_2d = fma(-B->h.x, s->m4, co_2b),
      co_2 = fma(B->m, s->m2, co_2d);
  const double co_3a = KSL_MUL(B->h.y, s->m2), co_3c = fma(-B->h.z, s->m1, co_3a),
      co_3d = KSL_MUL(B->xx, s->m3), co_3f = fma(B->xy, s->m4, co_3d),
      co_3h = fma(B->xz, s->m5, co_3f), co_3 = co_3c + co_3h;
  const double co_4a = KSL_MUL(B->h.z, s->m0), co_4c = fma(-B->h.x, s->m2, co_4a),
      co_4d = KSL_MUL(B->yy, s->m4), co_4f = fma(B->xy, s->m3, co_4d),
      co_4h = fma(B->yz, s->m5, co_4f), co_4 = co_4c + co_4h;
  const double co_5a = KSL_MUL(B->h.x, s->m1), co_5c = fma(-B->h.y, s->m0, co_5a),
      co_5d = KSL_MUL(B->zz, s->m5), co_5f = fma(B->xz, s->m3, co_5d),
      co_5h = fma(B->yz, s->m4, co_5f), co_5 = co_5c + co_5h;
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
   9 mul, 17 fma.
   Error <= u |result| + 7 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline double ksl_spatial_inertia_energy_fused(const ksl_spatial_inertia_t *B,
    const ksl_screw_t *s) {
  const double square_a = KSL_MUL(s->m0, s->m0), square_c = fma(s->m1, s->m1, square_a),
      square = fma(s->m2, s->m2, square_c);
  const double L_0a = KSL_MUL(B->xx, s->m3), L_0c = fma(B->xy, s->m4, L_0a),
      L_0 = fma(B->xz, s->m5, L_0c);
  const double L_1a = KSL_MUL(B->yy, s->m4), L_1c = fma(B->xy, s->m3, L_1a),
      L_1 = fma(B->yz, s->m5, L_1c);
  const double L_2a = KSL_MUL(B->zz, s->m5), L_2c = fma(B->xz, s->m3, L_2a),
      L_2 = fma(B->yz, s->m4, L_2c);
  const double twice_b = KSL_MUL(s->m3, L_0), twice_d = fma(s->m4, L_1, twice_b),
      twice_f = fma(s->m5, L_2, twice_d), twice = fma(B->m, square, twice_f);
  const double across_0a = KSL_MUL(B->h.z, s->m4), across_0 = fma(-B->h.y, s->m5, across_0a);
  const double across_1a = KSL_MUL(B->h.x, s->m5), across_1 = fma(-B->h.z, s->m3, across_1a);
  const double across_2a = KSL_MUL(B->h.y, s->m3), across_2 = fma(-B->h.x, s->m4, across_2a);
  const double energy_a = KSL_MUL(s->m0, across_0), energy_c = fma(s->m1, across_1, energy_a),
      energy_e = fma(s->m2, across_2, energy_c), energy = fma(0.5, twice, energy_e);
  return energy;
}

/* co = B ds + (w × (w × h); w × I w): the net wrench, about the origin, of a body with angular
     velocity w and acceleration ds = (a; w'), where a is that of the point now at the origin; if
     a is less gravity's, so is the wrench.
   B: spatial inertia (m in kg; h = m c in kg m; I about the origin, xx, yy, zz, xy, xz, yz in kg
     m^2); w: vector; ds: screw (v in m/s; ω in rad/s); co: coscrew (f in N; τ in N m).
   18 mul, 21 add, 21 fma, 3 neg.
   Error <= u |result| + (lin: 5, ang: 6) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_spatial_inertia_net_wrench_fused(const ksl_spatial_inertia_t *B,
    const ksl_vec3_t *w, const ksl_screw_t *ds, ksl_coscrew_t *co) {
  const double ww_0 = KSL_MUL(w->x, w->x);
  const double ww_1 = KSL_MUL(w->y, w->y);
  const double ww_2 = KSL_MUL(w->z, w->z);
  const double ww_3 = KSL_MUL(w->x, w->y);
  const double ww_4 = KSL_MUL(w->x, w->z);
  const double ww_5 = KSL_MUL(w->y, w->z);
  const double U_0a_lead = -ww_1, U_0 = U_0a_lead - ww_2;
  const double U_1 = ww_3 - ds->m5;
  const double U_2 = ds->m4 + ww_4;
  const double U_3 = ds->m5 + ww_3;
  const double U_4a_lead = -ww_0, U_4 = U_4a_lead - ww_2;
  const double U_5 = ww_5 - ds->m3;
  const double U_6 = ww_4 - ds->m4;
  const double U_7 = ds->m3 + ww_5;
  const double U_8a_lead = -ww_0, U_8 = U_8a_lead - ww_1;
  const double others_0 = B->zz - B->yy;
  const double others_1 = B->xx - B->zz;
  const double others_2 = B->yy - B->xx;
  const double squares_0 = ww_1 - ww_2;
  const double squares_1 = ww_2 - ww_0;
  const double squares_2 = ww_0 - ww_1;
  const double own_0a = KSL_MUL(B->xx, ds->m3), own_0 = fma(ww_5, others_0, own_0a);
  const double own_1a = KSL_MUL(B->yy, ds->m4), own_1 = fma(ww_4, others_1, own_1a);
  const double own_2a = KSL_MUL(B->zz, ds->m5), own_2 = fma(ww_3, others_2, own_2a);
  const double N_0a = KSL_MUL(B->xz, U_3), N_0c = fma(-B->xy, U_6, N_0a),
      N_0e = fma(B->yz, squares_0, N_0c), N_0 = N_0e + own_0;
  const double N_1a = KSL_MUL(B->xy, U_7), N_1c = fma(-B->yz, U_1, N_1a),
      N_1e = fma(B->xz, squares_1, N_1c), N_1 = N_1e + own_1;
  const double N_2b = KSL_MUL(B->yz, U_2), N_2d = fma(-B->xz, U_5, N_2b),
      N_2e = fma(B->xy, squares_2, N_2d), N_2 = N_2e + own_2;
  const double co_0b = KSL_MUL(B->h.x, U_0), co_0d = fma(B->h.y, U_1, co_0b),
      co_0f = fma(B->h.z, U_2, co_0d), co_0 = fma(B->m, ds->m0, co_0f);
  const double co_1b = KSL_MUL(B->h.x, U_3), co_1d = fma(B->h.y, U_4, co_1b),
      co_1f = fma(B->h.z, U_5, co_1d), co_1 = fma(B->m, ds->m1, co_1f);
  const double co_2b = KSL_MUL(B->h.x, U_6), co_2d = fma(B->h.y, U_7, co_2b),
      co_2f = fma(B->h.z, U_8, co_2d), co_2 = fma(B->m, ds->m2, co_2f);
  const double co_3a = KSL_MUL(B->h.y, ds->m2), co_3c = fma(-B->h.z, ds->m1, co_3a),
      co_3 = co_3c + N_0;
  const double co_4a = KSL_MUL(B->h.z, ds->m0), co_4c = fma(-B->h.x, ds->m2, co_4a),
      co_4 = co_4c + N_1;
  const double co_5a = KSL_MUL(B->h.x, ds->m1), co_5c = fma(-B->h.y, ds->m0, co_5a),
      co_5 = co_5c + N_2;
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
   12 mul, 12 add, 6 fma.
   Error <= u |result| + (m: 0, h: 1, I: 4) u S, S the sum of the |terms| of the expanded
     formula; barring over- and underflow. */
static inline void ksl_spatial_inertia_shifted_fused(const ksl_vec3_t *t,
    const ksl_spatial_inertia_t *B, ksl_spatial_inertia_t *Bo) {
  const double mt_0 = KSL_MUL(t->x, B->m);
  const double mt_1 = KSL_MUL(t->y, B->m);
  const double mt_2 = KSL_MUL(t->z, B->m);
  const double n_0 = fma(0.5, mt_0, B->h.x);
  const double n_1 = fma(0.5, mt_1, B->h.y);
  const double n_2 = fma(0.5, mt_2, B->h.z);
  const double tn0 = KSL_MUL(t->x, n_0);
  const double tn1 = KSL_MUL(t->y, n_1);
  const double tn2 = KSL_MUL(t->z, n_2);
  const double own_0 = KSL_MUL(2.0, tn0);
  const double own_1 = KSL_MUL(2.0, tn1);
  const double own_2 = KSL_MUL(2.0, tn2);
  const double pairs_0 = own_1 + own_2;
  const double pairs_1 = own_0 + own_2;
  const double pairs_2 = own_0 + own_1;
  const double pairs_3a = KSL_MUL(t->x, n_1), pairs_3 = fma(t->y, n_0, pairs_3a);
  const double pairs_4a = KSL_MUL(t->x, n_2), pairs_4 = fma(t->z, n_0, pairs_4a);
  const double pairs_5a = KSL_MUL(t->y, n_2), pairs_5 = fma(t->z, n_1, pairs_5a);
  const double moved_0 = B->h.x + mt_0;
  const double moved_1 = B->h.y + mt_1;
  const double moved_2 = B->h.z + mt_2;
  const double Bo_4 = B->xx + pairs_0;
  const double Bo_5 = B->yy + pairs_1;
  const double Bo_6 = B->zz + pairs_2;
  const double Bo_7 = B->xy - pairs_3;
  const double Bo_8 = B->xz - pairs_4;
  const double Bo_9 = B->yz - pairs_5;
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
   30 mul, 12 add, 42 fma.
   Error <= u |result| + (m: 0, h: 3, I: 6) u S, S the sum of the |terms| of the expanded
     formula; barring over- and underflow. */
static inline void ksl_spatial_inertia_transformed_fused(const ksl_SE3_t *D,
    const ksl_spatial_inertia_t *B, ksl_spatial_inertia_t *Bo) {
  const double RI_0a = KSL_MUL(D->m00, B->xx), RI_0c = fma(D->m01, B->xy, RI_0a),
      RI_0 = fma(D->m02, B->xz, RI_0c);
  const double RI_1a = KSL_MUL(D->m00, B->xy), RI_1c = fma(D->m01, B->yy, RI_1a),
      RI_1 = fma(D->m02, B->yz, RI_1c);
  const double RI_2a = KSL_MUL(D->m00, B->xz), RI_2c = fma(D->m01, B->yz, RI_2a),
      RI_2 = fma(D->m02, B->zz, RI_2c);
  const double RI_3a = KSL_MUL(D->m10, B->xx), RI_3c = fma(D->m11, B->xy, RI_3a),
      RI_3 = fma(D->m12, B->xz, RI_3c);
  const double RI_4a = KSL_MUL(D->m10, B->xy), RI_4c = fma(D->m11, B->yy, RI_4a),
      RI_4 = fma(D->m12, B->yz, RI_4c);
  const double RI_5a = KSL_MUL(D->m10, B->xz), RI_5c = fma(D->m11, B->yz, RI_5a),
      RI_5 = fma(D->m12, B->zz, RI_5c);
  const double RI_6a = KSL_MUL(D->m20, B->xx), RI_6c = fma(D->m21, B->xy, RI_6a),
      RI_6 = fma(D->m22, B->xz, RI_6c);
  const double RI_7a = KSL_MUL(D->m20, B->xy), RI_7c = fma(D->m21, B->yy, RI_7a),
      RI_7 = fma(D->m22, B->yz, RI_7c);
  const double RI_8a = KSL_MUL(D->m20, B->xz), RI_8c = fma(D->m21, B->yz, RI_8a),
      RI_8 = fma(D->m22, B->zz, RI_8c);
  const double turned_1a = KSL_MUL(D->m00, B->h.x), turned_1c = fma(D->m01, B->h.y, turned_1a),
      turned_1 = fma(D->m02, B->h.z, turned_1c);
  const double turned_2a = KSL_MUL(D->m10, B->h.x), turned_2c = fma(D->m11, B->h.y, turned_2a),
      turned_2 = fma(D->m12, B->h.z, turned_2c);
  const double turned_3a = KSL_MUL(D->m20, B->h.x), turned_3c = fma(D->m21, B->h.y, turned_3a),
      turned_3 = fma(D->m22, B->h.z, turned_3c);
  const double turned_4a = KSL_MUL(D->m00, RI_0), turned_4c = fma(D->m01, RI_1, turned_4a),
      turned_4 = fma(D->m02, RI_2, turned_4c);
  const double turned_5a = KSL_MUL(D->m10, RI_3), turned_5c = fma(D->m11, RI_4, turned_5a),
      turned_5 = fma(D->m12, RI_5, turned_5c);
  const double turned_6a = KSL_MUL(D->m20, RI_6), turned_6c = fma(D->m21, RI_7, turned_6a),
      turned_6 = fma(D->m22, RI_8, turned_6c);
  const double turned_7a = KSL_MUL(D->m10, RI_0), turned_7c = fma(D->m11, RI_1, turned_7a),
      turned_7 = fma(D->m12, RI_2, turned_7c);
  const double turned_8a = KSL_MUL(D->m20, RI_0), turned_8c = fma(D->m21, RI_1, turned_8a),
      turned_8 = fma(D->m22, RI_2, turned_8c);
  const double turned_9a = KSL_MUL(D->m20, RI_3), turned_9c = fma(D->m21, RI_4, turned_9a),
      turned_9 = fma(D->m22, RI_5, turned_9c);
  const double mt_0 = KSL_MUL(D->m03, B->m);
  const double mt_1 = KSL_MUL(D->m13, B->m);
  const double mt_2 = KSL_MUL(D->m23, B->m);
  const double n_0 = fma(0.5, mt_0, turned_1);
  const double n_1 = fma(0.5, mt_1, turned_2);
  const double n_2 = fma(0.5, mt_2, turned_3);
  const double tn0 = KSL_MUL(D->m03, n_0);
  const double tn1 = KSL_MUL(D->m13, n_1);
  const double tn2 = KSL_MUL(D->m23, n_2);
  const double own_0 = KSL_MUL(2.0, tn0);
  const double own_1 = KSL_MUL(2.0, tn1);
  const double own_2 = KSL_MUL(2.0, tn2);
  const double pairs_0 = own_1 + own_2;
  const double pairs_1 = own_0 + own_2;
  const double pairs_2 = own_0 + own_1;
  const double pairs_3a = KSL_MUL(D->m03, n_1), pairs_3 = fma(D->m13, n_0, pairs_3a);
  const double pairs_4a = KSL_MUL(D->m03, n_2), pairs_4 = fma(D->m23, n_0, pairs_4a);
  const double pairs_5a = KSL_MUL(D->m13, n_2), pairs_5 = fma(D->m23, n_1, pairs_5a);
  const double moved_0 = turned_1 + mt_0;
  const double moved_1 = turned_2 + mt_1;
  const double moved_2 = turned_3 + mt_2;
  const double Bo_4 = turned_4 + pairs_0;
  const double Bo_5 = turned_5 + pairs_1;
  const double Bo_6 = turned_6 + pairs_2;
  const double Bo_7 = turned_7 - pairs_3;
  const double Bo_8 = turned_8 - pairs_4;
  const double Bo_9 = turned_9 - pairs_5;
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

/* self = a self.
   self: spatial inertia (m in kg; h = m c in kg m; I about the origin, xx, yy, zz, xy, xz, yz in
     kg m^2); a: number.
   10 mul.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_spatial_inertiaf_scale_fused(ksl_spatial_inertiaf_t *self, const float a) {
  const float self_0_new = KSL_MULF(self->m, a);
  const float self_1_new = KSL_MULF(self->h.x, a);
  const float self_2_new = KSL_MULF(self->h.y, a);
  const float self_3_new = KSL_MULF(self->h.z, a);
  const float self_4_new = KSL_MULF(self->xx, a);
  const float self_5_new = KSL_MULF(self->yy, a);
  const float self_6_new = KSL_MULF(self->zz, a);
  const float self_7_new = KSL_MULF(self->xy, a);
  const float self_8_new = KSL_MULF(self->xz, a);
  const float self_9_new = KSL_MULF(self->yz, a);
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
static inline void ksl_add_BBf_fused(const ksl_spatial_inertiaf_t *B1,
    const ksl_spatial_inertiaf_t *B2, ksl_spatial_inertiaf_t *Bo) {
  const float Bo_0 = B1->m + B2->m;
  const float Bo_1 = B1->h.x + B2->h.x;
  const float Bo_2 = B1->h.y + B2->h.y;
  const float Bo_3 = B1->h.z + B2->h.z;
  const float Bo_4 = B1->xx + B2->xx;
  const float Bo_5 = B1->yy + B2->yy;
  const float Bo_6 = B1->zz + B2->zz;
  const float Bo_7 = B1->xy + B2->xy;
  const float Bo_8 = B1->xz + B2->xz;
  const float Bo_9 = B1->yz + B2->yz;
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
static inline void ksl_subtract_BBf_fused(const ksl_spatial_inertiaf_t *B1,
    const ksl_spatial_inertiaf_t *B2, ksl_spatial_inertiaf_t *Bo) {
  const float Bo_0 = B1->m - B2->m;
  const float Bo_1 = B1->h.x - B2->h.x;
  const float Bo_2 = B1->h.y - B2->h.y;
  const float Bo_3 = B1->h.z - B2->h.z;
  const float Bo_4 = B1->xx - B2->xx;
  const float Bo_5 = B1->yy - B2->yy;
  const float Bo_6 = B1->zz - B2->zz;
  const float Bo_7 = B1->xy - B2->xy;
  const float Bo_8 = B1->xz - B2->xz;
  const float Bo_9 = B1->yz - B2->yz;
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
   6 mul, 6 add, 3 fma.
   Error <= u |result| + (m: 0, h: 0, I: 3) u S, S the sum of the |terms| of the expanded
     formula; barring over- and underflow. */
static inline void ksl_spatial_inertiaf_from_com_fused(const float m, const ksl_vec3f_t *com,
    const ksl_mat3x3f_t *Ic, ksl_spatial_inertiaf_t *Bo) {
  const float h_0 = KSL_MULF(m, com->x);
  const float h_1 = KSL_MULF(m, com->y);
  const float h_2 = KSL_MULF(m, com->z);
  const float squares_0 = KSL_MULF(com->x, h_0);
  const float squares_1 = KSL_MULF(com->y, h_1);
  const float squares_2 = KSL_MULF(com->z, h_2);
  const float Bo_4a = squares_1 + squares_2, Bo_4 = Ic->m00 + Bo_4a;
  const float Bo_5a = squares_0 + squares_2, Bo_5 = Ic->m11 + Bo_5a;
  const float Bo_6a = squares_0 + squares_1, Bo_6 = Ic->m22 + Bo_6a;
  const float Bo_7 = fmaf(-com->y, h_0, Ic->m01);
  const float Bo_8 = fmaf(-com->z, h_0, Ic->m02);
  const float Bo_9 = fmaf(-com->z, h_1, Ic->m12);
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

/* co = B s = (m v - h × ω; h × v + I ω), the momentum of a body that moves with s.
   B: spatial inertia (m in kg; h = m c in kg m; I about the origin, xx, yy, zz, xy, xz, yz in kg
     m^2); s: screw (v in m/s; ω in rad/s); co: coscrew (f in N; τ in N m).
   9 mul, 3 add, 15 fma.
   Error <= u |result| + (lin: 2, ang: 3) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_Bsf_fused(const ksl_spatial_inertiaf_t *B, const ksl_screwf_t *s,
    ksl_coscrewf_t *co) {
  const float co_0b = KSL_MULF(B->h.z, s->m4), co_0d = fmaf(-B->h.y, s->m5, co_0b),
      co_0 = fmaf(B->m, s->m0, co_0d);
  const float co_1b = KSL_MULF(B->h.x, s->m5), co_1d = fmaf(-B->h.z, s->m3, co_1b),
      co_1 = fmaf(B->m, s->m1, co_1d);
  const float co_2b = KSL_MULF(B->h.y, s->m3), co_2d = fmaf(-B->h.x, s->m4, co_2b),
      co_2 = fmaf(B->m, s->m2, co_2d);
  const float co_3a = KSL_MULF(B->h.y, s->m2), co_3c = fmaf(-B->h.z, s->m1, co_3a),
      co_3d = KSL_MULF(B->xx, s->m3), co_3f = fmaf(B->xy, s->m4, co_3d),
      co_3h = fmaf(B->xz, s->m5, co_3f), co_3 = co_3c + co_3h;
  const float co_4a = KSL_MULF(B->h.z, s->m0), co_4c = fmaf(-B->h.x, s->m2, co_4a),
      co_4d = KSL_MULF(B->yy, s->m4), co_4f = fmaf(B->xy, s->m3, co_4d),
      co_4h = fmaf(B->yz, s->m5, co_4f), co_4 = co_4c + co_4h;
  const float co_5a = KSL_MULF(B->h.x, s->m1), co_5c = fmaf(-B->h.y, s->m0, co_5a),
      co_5d = KSL_MULF(B->zz, s->m5), co_5f = fmaf(B->xz, s->m3, co_5d),
      co_5h = fmaf(B->yz, s->m4, co_5f), co_5 = co_5c + co_5h;
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
   9 mul, 17 fma.
   Error <= u |result| + 7 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline float ksl_spatial_inertiaf_energy_fused(const ksl_spatial_inertiaf_t *B,
    const ksl_screwf_t *s) {
  const float square_a = KSL_MULF(s->m0, s->m0), square_c = fmaf(s->m1, s->m1, square_a),
      square = fmaf(s->m2, s->m2, square_c);
  const float L_0a = KSL_MULF(B->xx, s->m3), L_0c = fmaf(B->xy, s->m4, L_0a),
      L_0 = fmaf(B->xz, s->m5, L_0c);
  const float L_1a = KSL_MULF(B->yy, s->m4), L_1c = fmaf(B->xy, s->m3, L_1a),
      L_1 = fmaf(B->yz, s->m5, L_1c);
  const float L_2a = KSL_MULF(B->zz, s->m5), L_2c = fmaf(B->xz, s->m3, L_2a),
      L_2 = fmaf(B->yz, s->m4, L_2c);
  const float twice_b = KSL_MULF(s->m3, L_0), twice_d = fmaf(s->m4, L_1, twice_b),
      twice_f = fmaf(s->m5, L_2, twice_d), twice = fmaf(B->m, square, twice_f);
  const float across_0a = KSL_MULF(B->h.z, s->m4), across_0 = fmaf(-B->h.y, s->m5, across_0a);
  const float across_1a = KSL_MULF(B->h.x, s->m5), across_1 = fmaf(-B->h.z, s->m3, across_1a);
  const float across_2a = KSL_MULF(B->h.y, s->m3), across_2 = fmaf(-B->h.x, s->m4, across_2a);
  const float energy_a = KSL_MULF(s->m0, across_0), energy_c = fmaf(s->m1, across_1, energy_a),
      energy_e = fmaf(s->m2, across_2, energy_c), energy = fmaf(0.5f, twice, energy_e);
  return energy;
}

/* co = B ds + (w × (w × h); w × I w): the net wrench, about the origin, of a body with angular
     velocity w and acceleration ds = (a; w'), where a is that of the point now at the origin; if
     a is less gravity's, so is the wrench.
   B: spatial inertia (m in kg; h = m c in kg m; I about the origin, xx, yy, zz, xy, xz, yz in kg
     m^2); w: vector; ds: screw (v in m/s; ω in rad/s); co: coscrew (f in N; τ in N m).
   18 mul, 21 add, 21 fma, 3 neg.
   Error <= u |result| + (lin: 5, ang: 6) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_spatial_inertiaf_net_wrench_fused(const ksl_spatial_inertiaf_t *B,
    const ksl_vec3f_t *w, const ksl_screwf_t *ds, ksl_coscrewf_t *co) {
  const float ww_0 = KSL_MULF(w->x, w->x);
  const float ww_1 = KSL_MULF(w->y, w->y);
  const float ww_2 = KSL_MULF(w->z, w->z);
  const float ww_3 = KSL_MULF(w->x, w->y);
  const float ww_4 = KSL_MULF(w->x, w->z);
  const float ww_5 = KSL_MULF(w->y, w->z);
  const float U_0a_lead = -ww_1, U_0 = U_0a_lead - ww_2;
  const float U_1 = ww_3 - ds->m5;
  const float U_2 = ds->m4 + ww_4;
  const float U_3 = ds->m5 + ww_3;
  const float U_4a_lead = -ww_0, U_4 = U_4a_lead - ww_2;
  const float U_5 = ww_5 - ds->m3;
  const float U_6 = ww_4 - ds->m4;
  const float U_7 = ds->m3 + ww_5;
  const float U_8a_lead = -ww_0, U_8 = U_8a_lead - ww_1;
  const float others_0 = B->zz - B->yy;
  const float others_1 = B->xx - B->zz;
  const float others_2 = B->yy - B->xx;
  const float squares_0 = ww_1 - ww_2;
  const float squares_1 = ww_2 - ww_0;
  const float squares_2 = ww_0 - ww_1;
  const float own_0a = KSL_MULF(B->xx, ds->m3), own_0 = fmaf(ww_5, others_0, own_0a);
  const float own_1a = KSL_MULF(B->yy, ds->m4), own_1 = fmaf(ww_4, others_1, own_1a);
  const float own_2a = KSL_MULF(B->zz, ds->m5), own_2 = fmaf(ww_3, others_2, own_2a);
  const float N_0a = KSL_MULF(B->xz, U_3), N_0c = fmaf(-B->xy, U_6, N_0a),
      N_0e = fmaf(B->yz, squares_0, N_0c), N_0 = N_0e + own_0;
  const float N_1a = KSL_MULF(B->xy, U_7), N_1c = fmaf(-B->yz, U_1, N_1a),
      N_1e = fmaf(B->xz, squares_1, N_1c), N_1 = N_1e + own_1;
  const float N_2b = KSL_MULF(B->yz, U_2), N_2d = fmaf(-B->xz, U_5, N_2b),
      N_2e = fmaf(B->xy, squares_2, N_2d), N_2 = N_2e + own_2;
  const float co_0b = KSL_MULF(B->h.x, U_0), co_0d = fmaf(B->h.y, U_1, co_0b),
      co_0f = fmaf(B->h.z, U_2, co_0d), co_0 = fmaf(B->m, ds->m0, co_0f);
  const float co_1b = KSL_MULF(B->h.x, U_3), co_1d = fmaf(B->h.y, U_4, co_1b),
      co_1f = fmaf(B->h.z, U_5, co_1d), co_1 = fmaf(B->m, ds->m1, co_1f);
  const float co_2b = KSL_MULF(B->h.x, U_6), co_2d = fmaf(B->h.y, U_7, co_2b),
      co_2f = fmaf(B->h.z, U_8, co_2d), co_2 = fmaf(B->m, ds->m2, co_2f);
  const float co_3a = KSL_MULF(B->h.y, ds->m2), co_3c = fmaf(-B->h.z, ds->m1, co_3a),
      co_3 = co_3c + N_0;
  const float co_4a = KSL_MULF(B->h.z, ds->m0), co_4c = fmaf(-B->h.x, ds->m2, co_4a),
      co_4 = co_4c + N_1;
  const float co_5a = KSL_MULF(B->h.x, ds->m1), co_5c = fmaf(-B->h.y, ds->m0, co_5a),
      co_5 = co_5c + N_2;
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
   12 mul, 12 add, 6 fma.
   Error <= u |result| + (m: 0, h: 1, I: 4) u S, S the sum of the |terms| of the expanded
     formula; barring over- and underflow. */
static inline void ksl_spatial_inertiaf_shifted_fused(const ksl_vec3f_t *t,
    const ksl_spatial_inertiaf_t *B, ksl_spatial_inertiaf_t *Bo) {
  const float mt_0 = KSL_MULF(t->x, B->m);
  const float mt_1 = KSL_MULF(t->y, B->m);
  const float mt_2 = KSL_MULF(t->z, B->m);
  const float n_0 = fmaf(0.5f, mt_0, B->h.x);
  const float n_1 = fmaf(0.5f, mt_1, B->h.y);
  const float n_2 = fmaf(0.5f, mt_2, B->h.z);
  const float tn0 = KSL_MULF(t->x, n_0);
  const float tn1 = KSL_MULF(t->y, n_1);
  const float tn2 = KSL_MULF(t->z, n_2);
  const float own_0 = KSL_MULF(2.0f, tn0);
  const float own_1 = KSL_MULF(2.0f, tn1);
  const float own_2 = KSL_MULF(2.0f, tn2);
  const float pairs_0 = own_1 + own_2;
  const float pairs_1 = own_0 + own_2;
  const float pairs_2 = own_0 + own_1;
  const float pairs_3a = KSL_MULF(t->x, n_1), pairs_3 = fmaf(t->y, n_0, pairs_3a);
  const float pairs_4a = KSL_MULF(t->x, n_2), pairs_4 = fmaf(t->z, n_0, pairs_4a);
  const float pairs_5a = KSL_MULF(t->y, n_2), pairs_5 = fmaf(t->z, n_1, pairs_5a);
  const float moved_0 = B->h.x + mt_0;
  const float moved_1 = B->h.y + mt_1;
  const float moved_2 = B->h.z + mt_2;
  const float Bo_4 = B->xx + pairs_0;
  const float Bo_5 = B->yy + pairs_1;
  const float Bo_6 = B->zz + pairs_2;
  const float Bo_7 = B->xy - pairs_3;
  const float Bo_8 = B->xz - pairs_4;
  const float Bo_9 = B->yz - pairs_5;
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
   30 mul, 12 add, 42 fma.
   Error <= u |result| + (m: 0, h: 3, I: 6) u S, S the sum of the |terms| of the expanded
     formula; barring over- and underflow. */
static inline void ksl_spatial_inertiaf_transformed_fused(const ksl_SE3f_t *D,
    const ksl_spatial_inertiaf_t *B, ksl_spatial_inertiaf_t *Bo) {
  const float RI_0a = KSL_MULF(D->m00, B->xx), RI_0c = fmaf(D->m01, B->xy, RI_0a),
      RI_0 = fmaf(D->m02, B->xz, RI_0c);
  const float RI_1a = KSL_MULF(D->m00, B->xy), RI_1c = fmaf(D->m01, B->yy, RI_1a),
      RI_1 = fmaf(D->m02, B->yz, RI_1c);
  const float RI_2a = KSL_MULF(D->m00, B->xz), RI_2c = fmaf(D->m01, B->yz, RI_2a),
      RI_2 = fmaf(D->m02, B->zz, RI_2c);
  const float RI_3a = KSL_MULF(D->m10, B->xx), RI_3c = fmaf(D->m11, B->xy, RI_3a),
      RI_3 = fmaf(D->m12, B->xz, RI_3c);
  const float RI_4a = KSL_MULF(D->m10, B->xy), RI_4c = fmaf(D->m11, B->yy, RI_4a),
      RI_4 = fmaf(D->m12, B->yz, RI_4c);
  const float RI_5a = KSL_MULF(D->m10, B->xz), RI_5c = fmaf(D->m11, B->yz, RI_5a),
      RI_5 = fmaf(D->m12, B->zz, RI_5c);
  const float RI_6a = KSL_MULF(D->m20, B->xx), RI_6c = fmaf(D->m21, B->xy, RI_6a),
      RI_6 = fmaf(D->m22, B->xz, RI_6c);
  const float RI_7a = KSL_MULF(D->m20, B->xy), RI_7c = fmaf(D->m21, B->yy, RI_7a),
      RI_7 = fmaf(D->m22, B->yz, RI_7c);
  const float RI_8a = KSL_MULF(D->m20, B->xz), RI_8c = fmaf(D->m21, B->yz, RI_8a),
      RI_8 = fmaf(D->m22, B->zz, RI_8c);
  const float turned_1a = KSL_MULF(D->m00, B->h.x), turned_1c = fmaf(D->m01, B->h.y, turned_1a),
      turned_1 = fmaf(D->m02, B->h.z, turned_1c);
  const float turned_2a = KSL_MULF(D->m10, B->h.x), turned_2c = fmaf(D->m11, B->h.y, turned_2a),
      turned_2 = fmaf(D->m12, B->h.z, turned_2c);
  const float turned_3a = KSL_MULF(D->m20, B->h.x), turned_3c = fmaf(D->m21, B->h.y, turned_3a),
      turned_3 = fmaf(D->m22, B->h.z, turned_3c);
  const float turned_4a = KSL_MULF(D->m00, RI_0), turned_4c = fmaf(D->m01, RI_1, turned_4a),
      turned_4 = fmaf(D->m02, RI_2, turned_4c);
  const float turned_5a = KSL_MULF(D->m10, RI_3), turned_5c = fmaf(D->m11, RI_4, turned_5a),
      turned_5 = fmaf(D->m12, RI_5, turned_5c);
  const float turned_6a = KSL_MULF(D->m20, RI_6), turned_6c = fmaf(D->m21, RI_7, turned_6a),
      turned_6 = fmaf(D->m22, RI_8, turned_6c);
  const float turned_7a = KSL_MULF(D->m10, RI_0), turned_7c = fmaf(D->m11, RI_1, turned_7a),
      turned_7 = fmaf(D->m12, RI_2, turned_7c);
  const float turned_8a = KSL_MULF(D->m20, RI_0), turned_8c = fmaf(D->m21, RI_1, turned_8a),
      turned_8 = fmaf(D->m22, RI_2, turned_8c);
  const float turned_9a = KSL_MULF(D->m20, RI_3), turned_9c = fmaf(D->m21, RI_4, turned_9a),
      turned_9 = fmaf(D->m22, RI_5, turned_9c);
  const float mt_0 = KSL_MULF(D->m03, B->m);
  const float mt_1 = KSL_MULF(D->m13, B->m);
  const float mt_2 = KSL_MULF(D->m23, B->m);
  const float n_0 = fmaf(0.5f, mt_0, turned_1);
  const float n_1 = fmaf(0.5f, mt_1, turned_2);
  const float n_2 = fmaf(0.5f, mt_2, turned_3);
  const float tn0 = KSL_MULF(D->m03, n_0);
  const float tn1 = KSL_MULF(D->m13, n_1);
  const float tn2 = KSL_MULF(D->m23, n_2);
  const float own_0 = KSL_MULF(2.0f, tn0);
  const float own_1 = KSL_MULF(2.0f, tn1);
  const float own_2 = KSL_MULF(2.0f, tn2);
  const float pairs_0 = own_1 + own_2;
  const float pairs_1 = own_0 + own_2;
  const float pairs_2 = own_0 + own_1;
  const float pairs_3a = KSL_MULF(D->m03, n_1), pairs_3 = fmaf(D->m13, n_0, pairs_3a);
  const float pairs_4a = KSL_MULF(D->m03, n_2), pairs_4 = fmaf(D->m23, n_0, pairs_4a);
  const float pairs_5a = KSL_MULF(D->m13, n_2), pairs_5 = fmaf(D->m23, n_1, pairs_5a);
  const float moved_0 = turned_1 + mt_0;
  const float moved_1 = turned_2 + mt_1;
  const float moved_2 = turned_3 + mt_2;
  const float Bo_4 = turned_4 + pairs_0;
  const float Bo_5 = turned_5 + pairs_1;
  const float Bo_6 = turned_6 + pairs_2;
  const float Bo_7 = turned_7 - pairs_3;
  const float Bo_8 = turned_8 - pairs_4;
  const float Bo_9 = turned_9 - pairs_5;
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

#endif
