/* Made by `coscrew generate`; changes are overwritten. */
/* SPDX-License-Identifier: MIT */
/* coscrew 0.2.0.  Copyright (c) 2026 The coscrew authors. */
/* Spatial inertias of rigid bodies: mass, first moment, second moments about the origin.
   Certified tier: plain results, and bounds on their errors that always hold. */
#ifndef KSL_SPATIAL_INERTIA_CERTIFIED_H
#define KSL_SPATIAL_INERTIA_CERTIFIED_H

#include "ksl_types.h"

/* self = a self; |error of self| <= self_bound unless inf or NaN.
   self, self_bound: spatial inertia (m in kg; h = m c in kg m; I about the origin, xx, yy, zz,
     xy, xz, yz in kg m^2); a: number.
   20 mul, 10 add, 10 abs. */
static inline void ksl_spatial_inertia_scale_certified(ksl_spatial_inertia_t *self,
    const double a, ksl_spatial_inertia_t *self_bound) {
  const double self_0_new = KSL_MUL(self->m, a), self_1_new = KSL_MUL(self->h.x, a),
      self_2_new = KSL_MUL(self->h.y, a), self_3_new = KSL_MUL(self->h.z, a),
      self_4_new = KSL_MUL(self->xx, a), self_5_new = KSL_MUL(self->yy, a),
      self_6_new = KSL_MUL(self->zz, a), self_7_new = KSL_MUL(self->xy, a),
      self_8_new = KSL_MUL(self->xz, a), self_9_new = KSL_MUL(self->yz, a);
  const double self_0_new_bound = KSL_MUL(1.1102230246251568e-16, fabs(self_0_new)
          + 2.004168360008973e-292),
      self_1_new_bound = KSL_MUL(1.1102230246251568e-16, fabs(self_1_new) + 2.004168360008973e-292),
      self_2_new_bound = KSL_MUL(1.1102230246251568e-16, fabs(self_2_new) + 2.004168360008973e-292),
      self_3_new_bound = KSL_MUL(1.1102230246251568e-16, fabs(self_3_new) + 2.004168360008973e-292),
      self_4_new_bound = KSL_MUL(1.1102230246251568e-16, fabs(self_4_new) + 2.004168360008973e-292),
      self_5_new_bound = KSL_MUL(1.1102230246251568e-16, fabs(self_5_new) + 2.004168360008973e-292),
      self_6_new_bound = KSL_MUL(1.1102230246251568e-16, fabs(self_6_new) + 2.004168360008973e-292),
      self_7_new_bound = KSL_MUL(1.1102230246251568e-16, fabs(self_7_new) + 2.004168360008973e-292),
      self_8_new_bound = KSL_MUL(1.1102230246251568e-16, fabs(self_8_new) + 2.004168360008973e-292),
      self_9_new_bound = KSL_MUL(1.1102230246251568e-16, fabs(self_9_new) + 2.004168360008973e-292);
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
  self_bound->m = self_0_new_bound;
  self_bound->h.x = self_1_new_bound;
  self_bound->h.y = self_2_new_bound;
  self_bound->h.z = self_3_new_bound;
  self_bound->xx = self_4_new_bound;
  self_bound->yy = self_5_new_bound;
  self_bound->zz = self_6_new_bound;
  self_bound->xy = self_7_new_bound;
  self_bound->xz = self_8_new_bound;
  self_bound->yz = self_9_new_bound;
}

/* Bo = B1 + B2; |error of Bo| <= Bo_bound unless inf or NaN.
   B1, B2, Bo, Bo_bound: spatial inertia (m in kg; h = m c in kg m; I about the origin, xx, yy,
     zz, xy, xz, yz in kg m^2).
   10 mul, 10 add, 10 abs. */
static inline void ksl_add_BB_certified(const ksl_spatial_inertia_t *B1,
    const ksl_spatial_inertia_t *B2, ksl_spatial_inertia_t *Bo,
    ksl_spatial_inertia_t *Bo_bound) {
  const double Bo_0 = B1->m + B2->m, Bo_1 = B1->h.x + B2->h.x, Bo_2 = B1->h.y + B2->h.y,
      Bo_3 = B1->h.z + B2->h.z, Bo_4 = B1->xx + B2->xx, Bo_5 = B1->yy + B2->yy,
      Bo_6 = B1->zz + B2->zz, Bo_7 = B1->xy + B2->xy, Bo_8 = B1->xz + B2->xz,
      Bo_9 = B1->yz + B2->yz;
  const double Bo_0_bound = KSL_MUL(1.1102230246251568e-16, fabs(Bo_0)),
      Bo_1_bound = KSL_MUL(1.1102230246251568e-16, fabs(Bo_1)),
      Bo_2_bound = KSL_MUL(1.1102230246251568e-16, fabs(Bo_2)),
      Bo_3_bound = KSL_MUL(1.1102230246251568e-16, fabs(Bo_3)),
      Bo_4_bound = KSL_MUL(1.1102230246251568e-16, fabs(Bo_4)),
      Bo_5_bound = KSL_MUL(1.1102230246251568e-16, fabs(Bo_5)),
      Bo_6_bound = KSL_MUL(1.1102230246251568e-16, fabs(Bo_6)),
      Bo_7_bound = KSL_MUL(1.1102230246251568e-16, fabs(Bo_7)),
      Bo_8_bound = KSL_MUL(1.1102230246251568e-16, fabs(Bo_8)),
      Bo_9_bound = KSL_MUL(1.1102230246251568e-16, fabs(Bo_9));
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
  Bo_bound->m = Bo_0_bound;
  Bo_bound->h.x = Bo_1_bound;
  Bo_bound->h.y = Bo_2_bound;
  Bo_bound->h.z = Bo_3_bound;
  Bo_bound->xx = Bo_4_bound;
  Bo_bound->yy = Bo_5_bound;
  Bo_bound->zz = Bo_6_bound;
  Bo_bound->xy = Bo_7_bound;
  Bo_bound->xz = Bo_8_bound;
  Bo_bound->yz = Bo_9_bound;
}

/* Bo = B1 - B2; |error of Bo| <= Bo_bound unless inf or NaN.
   B1, B2, Bo, Bo_bound: spatial inertia (m in kg; h = m c in kg m; I about the origin, xx, yy,
     zz, xy, xz, yz in kg m^2).
   10 mul, 10 add, 10 abs. */
static inline void ksl_subtract_BB_certified(const ksl_spatial_inertia_t *B1,
    const ksl_spatial_inertia_t *B2, ksl_spatial_inertia_t *Bo,
    ksl_spatial_inertia_t *Bo_bound) {
  const double Bo_0 = B1->m - B2->m, Bo_1 = B1->h.x - B2->h.x, Bo_2 = B1->h.y - B2->h.y,
      Bo_3 = B1->h.z - B2->h.z, Bo_4 = B1->xx - B2->xx, Bo_5 = B1->yy - B2->yy,
      Bo_6 = B1->zz - B2->zz, Bo_7 = B1->xy - B2->xy, Bo_8 = B1->xz - B2->xz,
      Bo_9 = B1->yz - B2->yz;
  const double Bo_0_bound = KSL_MUL(1.1102230246251568e-16, fabs(Bo_0)),
      Bo_1_bound = KSL_MUL(1.1102230246251568e-16, fabs(Bo_1)),
      Bo_2_bound = KSL_MUL(1.1102230246251568e-16, fabs(Bo_2)),
      Bo_3_bound = KSL_MUL(1.1102230246251568e-16, fabs(Bo_3)),
      Bo_4_bound = KSL_MUL(1.1102230246251568e-16, fabs(Bo_4)),
      Bo_5_bound = KSL_MUL(1.1102230246251568e-16, fabs(Bo_5)),
      Bo_6_bound = KSL_MUL(1.1102230246251568e-16, fabs(Bo_6)),
      Bo_7_bound = KSL_MUL(1.1102230246251568e-16, fabs(Bo_7)),
      Bo_8_bound = KSL_MUL(1.1102230246251568e-16, fabs(Bo_8)),
      Bo_9_bound = KSL_MUL(1.1102230246251568e-16, fabs(Bo_9));
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
  Bo_bound->m = Bo_0_bound;
  Bo_bound->h.x = Bo_1_bound;
  Bo_bound->h.y = Bo_2_bound;
  Bo_bound->h.z = Bo_3_bound;
  Bo_bound->xx = Bo_4_bound;
  Bo_bound->yy = Bo_5_bound;
  Bo_bound->zz = Bo_6_bound;
  Bo_bound->xy = Bo_7_bound;
  Bo_bound->xz = Bo_8_bound;
  Bo_bound->yz = Bo_9_bound;
}

/* Bo: mass m, centre of mass com, second moments Ic about it (kg m^2; only the upper triangle is
     read): h = m com, I = Ic - m com~ com~; |error of Bo| <= Bo_bound unless inf or NaN.
   m: number; com: vector; Ic: rotation or other 3×3 matrix; Bo, Bo_bound: spatial inertia (m in
     kg; h = m c in kg m; I about the origin, xx, yy, zz, xy, xz, yz in kg m^2).
   24 mul, 27 add, 12 abs. */
static inline void ksl_spatial_inertia_from_com_certified(const double m, const ksl_vec3_t *com,
    const ksl_mat3x3_t *Ic, ksl_spatial_inertia_t *Bo,
    ksl_spatial_inertia_t *Bo_bound) {
  const double h_0 = KSL_MUL(m, com->x), h_1 = KSL_MUL(m, com->y), h_2 = KSL_MUL(m, com->z);
  const double squares_0 = KSL_MUL(com->x, h_0);
  const double squares_1 = KSL_MUL(com->y, h_1);
  const double squares_2 = KSL_MUL(com->z, h_2);
  const double Bo_4 = Ic->m00 + (squares_1 + squares_2), Bo_5 = Ic->m11 + (squares_0 + squares_2),
      Bo_6 = Ic->m22 + (squares_0 + squares_1), Bo_7 = Ic->m01 - KSL_MUL(com->y, h_0),
      Bo_8 = Ic->m02 - KSL_MUL(com->z, h_0), Bo_9 = Ic->m12 - KSL_MUL(com->z, h_1);
  const double h_0_padded = fabs(h_0) + 2.004168360008973e-292;
  const double squares_0_size = KSL_MUL(fabs(com->x), h_0_padded);
  const double h_1_padded = fabs(h_1) + 2.004168360008973e-292;
  const double com_1_abs = fabs(com->y), squares_1_size = KSL_MUL(com_1_abs, h_1_padded);
  const double h_2_padded = fabs(h_2) + 2.004168360008973e-292;
  const double com_2_abs = fabs(com->z), squares_2_size = KSL_MUL(com_2_abs, h_2_padded);
  const double Bo_4_size = fabs(Ic->m00) + (squares_1_size + squares_2_size),
      Bo_5_size = fabs(Ic->m11) + (squares_0_size + squares_2_size),
      Bo_6_size = fabs(Ic->m22) + (squares_0_size + squares_1_size),
      Bo_7_size = fabs(Ic->m01) + KSL_MUL(com_1_abs, h_0_padded),
      Bo_8_size = fabs(Ic->m02) + KSL_MUL(com_2_abs, h_0_padded),
      Bo_9_size = fabs(Ic->m12) + KSL_MUL(com_2_abs, h_1_padded);
  const double h_0_bound = KSL_MUL(1.1102230246251568e-16, h_0_padded),
      h_1_bound = KSL_MUL(1.1102230246251568e-16, h_1_padded),
      h_2_bound = KSL_MUL(1.1102230246251568e-16, h_2_padded);
  const double Bo_4_bound = KSL_MUL(4.440892098500628e-16, Bo_4_size + 2.004168360008973e-292),
      Bo_5_bound = KSL_MUL(4.440892098500628e-16, Bo_5_size + 2.004168360008973e-292),
      Bo_6_bound = KSL_MUL(4.440892098500628e-16, Bo_6_size + 2.004168360008973e-292),
      Bo_7_bound = KSL_MUL(3.3306690738754706e-16, Bo_7_size + 2.004168360008973e-292),
      Bo_8_bound = KSL_MUL(3.3306690738754706e-16, Bo_8_size + 2.004168360008973e-292),
      Bo_9_bound = KSL_MUL(3.3306690738754706e-16, Bo_9_size + 2.004168360008973e-292);
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
  Bo_bound->m = 0.0;
  Bo_bound->h.x = h_0_bound;
  Bo_bound->h.y = h_1_bound;
  Bo_bound->h.z = h_2_bound;
  Bo_bound->xx = Bo_4_bound;
  Bo_bound->yy = Bo_5_bound;
  Bo_bound->zz = Bo_6_bound;
  Bo_bound->xy = Bo_7_bound;
  Bo_bound->xz = Bo_8_bound;
  Bo_bound->yz = Bo_9_bound;
}

/* co = B s = (m v - h × ω; h × v + I ω), the momentum of a body that moves with s; |error of co|
     <= co_bound unless inf or NaN.
   B: spatial inertia (m in kg; h = m c in kg m; I about the origin, xx, yy, zz, xy, xz, yz in kg
     m^2); s: screw (v in m/s; ω in rad/s); co, co_bound: coscrew (f in N; τ in N m).
   30 mul, 42 add, 24 abs. */
static inline void ksl_product_Bs_certified(const ksl_spatial_inertia_t *B, const ksl_screw_t *s,
    ksl_coscrew_t *co, ksl_coscrew_t *co_bound) {
  const double co_0a = KSL_MUL(B->m, s->m0), co_0b = KSL_MUL(B->h.z, s->m4),
      co_0c = KSL_MUL(B->h.y, s->m5), co_0 = co_0a + (co_0b - co_0c);
  const double co_1a = KSL_MUL(B->m, s->m1), co_1b = KSL_MUL(B->h.x, s->m5),
      co_1c = KSL_MUL(B->h.z, s->m3), co_1 = co_1a + (co_1b - co_1c);
  const double co_2a = KSL_MUL(B->m, s->m2), co_2b = KSL_MUL(B->h.y, s->m3),
      co_2c = KSL_MUL(B->h.x, s->m4), co_2 = co_2a + (co_2b - co_2c);
  const double co_3a = KSL_MUL(B->h.y, s->m2), co_3b = KSL_MUL(B->h.z, s->m1),
      co_3d = KSL_MUL(B->xx, s->m3), co_3e = KSL_MUL(B->xy, s->m4), co_3g = KSL_MUL(B->xz, s->m5),
      co_3 = co_3a - co_3b + (co_3d + co_3e + co_3g);
  const double co_4a = KSL_MUL(B->h.z, s->m0), co_4b = KSL_MUL(B->h.x, s->m2),
      co_4d = KSL_MUL(B->yy, s->m4), co_4e = KSL_MUL(B->xy, s->m3), co_4g = KSL_MUL(B->yz, s->m5),
      co_4 = co_4a - co_4b + (co_4d + co_4e + co_4g);
  const double co_5a = KSL_MUL(B->h.x, s->m1), co_5b = KSL_MUL(B->h.y, s->m0),
      co_5d = KSL_MUL(B->zz, s->m5), co_5e = KSL_MUL(B->xz, s->m3), co_5g = KSL_MUL(B->yz, s->m4),
      co_5 = co_5a - co_5b + (co_5d + co_5e + co_5g);
  const double co_0_size = fabs(co_0a) + (fabs(co_0b) + fabs(co_0c)),
      co_1_size = fabs(co_1a) + (fabs(co_1b) + fabs(co_1c)),
      co_2_size = fabs(co_2a) + (fabs(co_2b) + fabs(co_2c)),
      co_3_size = fabs(co_3a) + fabs(co_3b) + (fabs(co_3d) + fabs(co_3e) + fabs(co_3g)),
      co_4_size = fabs(co_4a) + fabs(co_4b) + (fabs(co_4d) + fabs(co_4e) + fabs(co_4g)),
      co_5_size = fabs(co_5a) + fabs(co_5b) + (fabs(co_5d) + fabs(co_5e) + fabs(co_5g));
  const double co_0_bound = KSL_MUL(3.3306690738754706e-16, co_0_size + 2.004168360008973e-292),
      co_1_bound = KSL_MUL(3.3306690738754706e-16, co_1_size + 2.004168360008973e-292),
      co_2_bound = KSL_MUL(3.3306690738754706e-16, co_2_size + 2.004168360008973e-292),
      co_3_bound = KSL_MUL(4.440892098500628e-16, co_3_size + 2.004168360008973e-292),
      co_4_bound = KSL_MUL(4.440892098500628e-16, co_4_size + 2.004168360008973e-292),
      co_5_bound = KSL_MUL(4.440892098500628e-16, co_5_size + 2.004168360008973e-292);
  co->m0 = co_0;
  co->m1 = co_1;
  co->m2 = co_2;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
  co_bound->m0 = co_0_bound;
  co_bound->m1 = co_1_bound;
  co_bound->m2 = co_2_bound;
  co_bound->m3 = co_3_bound;
  co_bound->m4 = co_4_bound;
  co_bound->m5 = co_5_bound;
}

/* s·B s / 2, the kinetic energy in J of a body that moves with s; |error of energy| <=
     energy_bound unless inf or NaN.
   B: spatial inertia (m in kg; h = m c in kg m; I about the origin, xx, yy, zz, xy, xz, yz in kg
     m^2); s: screw (v in m/s; ω in rad/s); energy_bound: number.
   35 mul, 43 add, 25 abs. */
static inline double ksl_spatial_inertia_energy_certified(const ksl_spatial_inertia_t *B,
    const ksl_screw_t *s, double *energy_bound) {
  const double square_a = KSL_MUL(s->m0, s->m0), square_b = KSL_MUL(s->m1, s->m1),
      square_d = KSL_MUL(s->m2, s->m2), square = square_a + square_b + square_d;
  const double L_0a = KSL_MUL(B->xx, s->m3), L_0b = KSL_MUL(B->xy, s->m4),
      L_0d = KSL_MUL(B->xz, s->m5), L_0 = L_0a + L_0b + L_0d;
  const double L_1a = KSL_MUL(B->yy, s->m4), L_1b = KSL_MUL(B->xy, s->m3),
      L_1d = KSL_MUL(B->yz, s->m5), L_1 = L_1a + L_1b + L_1d;
  const double L_2a = KSL_MUL(B->zz, s->m5), L_2b = KSL_MUL(B->xz, s->m3),
      L_2d = KSL_MUL(B->yz, s->m4), L_2 = L_2a + L_2b + L_2d;
  const double twice = KSL_MUL(B->m, square)
          + (KSL_MUL(s->m3, L_0) + KSL_MUL(s->m4, L_1) + KSL_MUL(s->m5, L_2));
  const double across_0a = KSL_MUL(B->h.z, s->m4), across_0b = KSL_MUL(B->h.y, s->m5),
      across_0 = across_0a - across_0b;
  const double across_1a = KSL_MUL(B->h.x, s->m5), across_1b = KSL_MUL(B->h.z, s->m3),
      across_1 = across_1a - across_1b;
  const double across_2a = KSL_MUL(B->h.y, s->m3), across_2b = KSL_MUL(B->h.x, s->m4),
      across_2 = across_2a - across_2b;
  const double energy = KSL_MUL(s->m0, across_0) + KSL_MUL(s->m1, across_1)
          + KSL_MUL(s->m2, across_2) + KSL_MUL(0.5, twice);
  const double square_size = fabs(square_a) + fabs(square_b) + fabs(square_d);
  const double L_0_size = fabs(L_0a) + fabs(L_0b) + fabs(L_0d),
      L_1_size = fabs(L_1a) + fabs(L_1b) + fabs(L_1d),
      L_2_size = fabs(L_2a) + fabs(L_2b) + fabs(L_2d);
  const double twice_d_size = KSL_MUL(fabs(s->m3), L_0_size + 2.004168360008973e-292)
          + KSL_MUL(fabs(s->m4), L_1_size + 2.004168360008973e-292),
      twice_size = KSL_MUL(fabs(B->m), square_size + 2.004168360008973e-292)
          + (twice_d_size + KSL_MUL(fabs(s->m5), L_2_size + 2.004168360008973e-292));
  const double across_0_size = fabs(across_0a) + fabs(across_0b),
      across_1_size = fabs(across_1a) + fabs(across_1b),
      across_2_size = fabs(across_2a) + fabs(across_2b);
  const double energy_c_size = KSL_MUL(fabs(s->m0), across_0_size + 2.004168360008973e-292)
          + KSL_MUL(fabs(s->m1), across_1_size + 2.004168360008973e-292),
      energy_size = energy_c_size + KSL_MUL(fabs(s->m2), across_2_size + 2.004168360008973e-292)
          + KSL_MUL(0.5, twice_size + 2.004168360008973e-292);
  const double energy_bound_ = KSL_MUL(9.992007221626415e-16, energy_size + 2.004168360008973e-292);
  *energy_bound = energy_bound_;
  return energy;
}

/* co = B ds + (w × (w × h); w × I w): the net wrench, about the origin, of a body with angular
     velocity w and acceleration ds = (a; w'), where a is that of the point now at the origin; if
     a is less gravity's, so is the wrench; |error of co| <= co_bound unless inf or NaN.
   B: spatial inertia (m in kg; h = m c in kg m; I about the origin, xx, yy, zz, xy, xz, yz in kg
     m^2); w: vector; ds: screw (v in m/s; ω in rad/s); co, co_bound: coscrew (f in N; τ in N m).
   66 mul, 102 add, 3 neg, 30 abs. */
static inline void ksl_spatial_inertia_net_wrench_certified(const ksl_spatial_inertia_t *B,
    const ksl_vec3_t *w, const ksl_screw_t *ds, ksl_coscrew_t *co,
    ksl_coscrew_t *co_bound) {
  const double ww_0 = KSL_MUL(w->x, w->x), ww_1 = KSL_MUL(w->y, w->y), ww_2 = KSL_MUL(w->z, w->z),
      ww_3 = KSL_MUL(w->x, w->y), ww_4 = KSL_MUL(w->x, w->z), ww_5 = KSL_MUL(w->y, w->z);
  const double U_0 = -(ww_1 + ww_2), U_1 = ww_3 - ds->m5, U_2 = ds->m4 + ww_4, U_3 = ds->m5 + ww_3,
      U_4 = -(ww_0 + ww_2), U_5 = ww_5 - ds->m3, U_6 = ww_4 - ds->m4, U_7 = ds->m3 + ww_5,
      U_8 = -(ww_0 + ww_1);
  const double others_0 = B->zz - B->yy, others_1 = B->xx - B->zz, others_2 = B->yy - B->xx;
  const double squares_0 = ww_1 - ww_2, squares_1 = ww_2 - ww_0, squares_2 = ww_0 - ww_1;
  const double own_0a = KSL_MUL(B->xx, ds->m3), own_0 = own_0a + KSL_MUL(ww_5, others_0);
  const double own_1a = KSL_MUL(B->yy, ds->m4), own_1 = own_1a + KSL_MUL(ww_4, others_1);
  const double own_2a = KSL_MUL(B->zz, ds->m5), own_2 = own_2a + KSL_MUL(ww_3, others_2);
  const double N_0 = KSL_MUL(B->xz, U_3) - KSL_MUL(B->xy, U_6) + KSL_MUL(B->yz, squares_0) + own_0;
  const double N_1 = KSL_MUL(B->xy, U_7) - KSL_MUL(B->yz, U_1) + KSL_MUL(B->xz, squares_1) + own_1;
  const double N_2 = KSL_MUL(B->xy, squares_2) + (KSL_MUL(B->yz, U_2) - KSL_MUL(B->xz, U_5))
          + own_2;
  const double co_0a = KSL_MUL(B->m, ds->m0),
      co_0 = co_0a + (KSL_MUL(B->h.x, U_0) + KSL_MUL(B->h.y, U_1) + KSL_MUL(B->h.z, U_2));
  const double co_1a = KSL_MUL(B->m, ds->m1),
      co_1 = co_1a + (KSL_MUL(B->h.x, U_3) + KSL_MUL(B->h.y, U_4) + KSL_MUL(B->h.z, U_5));
  const double co_2a = KSL_MUL(B->m, ds->m2),
      co_2 = co_2a + (KSL_MUL(B->h.x, U_6) + KSL_MUL(B->h.y, U_7) + KSL_MUL(B->h.z, U_8));
  const double co_3a = KSL_MUL(B->h.y, ds->m2), co_3b = KSL_MUL(B->h.z, ds->m1),
      co_3 = co_3a - co_3b + N_0;
  const double co_4a = KSL_MUL(B->h.z, ds->m0), co_4b = KSL_MUL(B->h.x, ds->m2),
      co_4 = co_4a - co_4b + N_1;
  const double co_5a = KSL_MUL(B->h.x, ds->m1), co_5b = KSL_MUL(B->h.y, ds->m0),
      co_5 = co_5a - co_5b + N_2;
  const double ww_1_abs = fabs(ww_1), ww_2_abs = fabs(ww_2);
  const double ww_3_abs = fabs(ww_3), ds_5_abs = fabs(ds->m5), U_1_size = ww_3_abs + ds_5_abs;
  const double ds_4_abs = fabs(ds->m4), ww_4_abs = fabs(ww_4), U_2_size = ds_4_abs + ww_4_abs;
  const double U_3_size = ds_5_abs + ww_3_abs, ww_0_abs = fabs(ww_0);
  const double ww_5_abs = fabs(ww_5), ds_3_abs = fabs(ds->m3), U_5_size = ww_5_abs + ds_3_abs;
  const double U_6_size = ww_4_abs + ds_4_abs, U_7_size = ds_3_abs + ww_5_abs;
  const double squares_0_size = ww_1_abs + ww_2_abs, squares_1_size = ww_2_abs + ww_0_abs,
      squares_2_size = ww_0_abs + ww_1_abs;
  const double own_0_size = fabs(own_0a)
          + KSL_MUL(ww_5_abs + 2.004168360008973e-292, fabs(others_0)),
      own_1_size = fabs(own_1a) + KSL_MUL(ww_4_abs + 2.004168360008973e-292, fabs(others_1)),
      own_2_size = fabs(own_2a) + KSL_MUL(ww_3_abs + 2.004168360008973e-292, fabs(others_2));
  const double U_3_padded = U_3_size + 2.004168360008973e-292;
  const double B_8_abs = fabs(B->xz);
  const double U_6_padded = U_6_size + 2.004168360008973e-292;
  const double B_7_abs = fabs(B->xy), B_9_abs = fabs(B->yz),
      N_0_size = KSL_MUL(B_8_abs, U_3_padded) + KSL_MUL(B_7_abs, U_6_padded)
          + KSL_MUL(B_9_abs, squares_0_size + 2.004168360008973e-292) + own_0_size;
  const double U_7_padded = U_7_size + 2.004168360008973e-292,
      U_1_padded = U_1_size + 2.004168360008973e-292;
  const double N_1_size = KSL_MUL(B_7_abs, U_7_padded) + KSL_MUL(B_9_abs, U_1_padded)
          + KSL_MUL(B_8_abs, squares_1_size + 2.004168360008973e-292) + own_1_size;
  const double U_2_padded = U_2_size + 2.004168360008973e-292,
      U_5_padded = U_5_size + 2.004168360008973e-292;
  const double N_2_size = KSL_MUL(B_7_abs, squares_2_size + 2.004168360008973e-292)
          + (KSL_MUL(B_9_abs, U_2_padded) + KSL_MUL(B_8_abs, U_5_padded)) + own_2_size;
  const double B_1_abs = fabs(B->h.x), B_2_abs = fabs(B->h.y), B_3_abs = fabs(B->h.z),
      co_0f_size = KSL_MUL(B_1_abs, ww_1_abs + ww_2_abs + 2.004168360008973e-292)
          + KSL_MUL(B_2_abs, U_1_padded) + KSL_MUL(B_3_abs, U_2_padded),
      co_0_size = fabs(co_0a) + co_0f_size;
  const double co_1f_size = KSL_MUL(B_1_abs, U_3_padded)
          + KSL_MUL(B_2_abs, ww_0_abs + ww_2_abs + 2.004168360008973e-292)
          + KSL_MUL(B_3_abs, U_5_padded), co_1_size = fabs(co_1a) + co_1f_size;
  const double co_2f_size = KSL_MUL(B_1_abs, U_6_padded) + KSL_MUL(B_2_abs, U_7_padded)
          + KSL_MUL(B_3_abs, ww_0_abs + ww_1_abs + 2.004168360008973e-292),
      co_2_size = fabs(co_2a) + co_2f_size;
  const double co_3_size = fabs(co_3a) + fabs(co_3b) + N_0_size,
      co_4_size = fabs(co_4a) + fabs(co_4b) + N_1_size,
      co_5_size = fabs(co_5a) + fabs(co_5b) + N_2_size;
  const double co_0_bound = KSL_MUL(6.661338147750942e-16, co_0_size + 2.004168360008973e-292),
      co_1_bound = KSL_MUL(6.661338147750942e-16, co_1_size + 2.004168360008973e-292),
      co_2_bound = KSL_MUL(6.661338147750942e-16, co_2_size + 2.004168360008973e-292),
      co_3_bound = KSL_MUL(7.7715611723761e-16, co_3_size + 2.004168360008973e-292),
      co_4_bound = KSL_MUL(7.7715611723761e-16, co_4_size + 2.004168360008973e-292),
      co_5_bound = KSL_MUL(7.7715611723761e-16, co_5_size + 2.004168360008973e-292);
  co->m0 = co_0;
  co->m1 = co_1;
  co->m2 = co_2;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
  co_bound->m0 = co_0_bound;
  co_bound->m1 = co_1_bound;
  co_bound->m2 = co_2_bound;
  co_bound->m3 = co_3_bound;
  co_bound->m4 = co_4_bound;
  co_bound->m5 = co_5_bound;
}

/* Bo = B moved by t: m, h + m t, I - t~ (h + m t)~ - h~ t~; |error of Bo| <= Bo_bound unless inf
     or NaN.
   t: vector; B, Bo, Bo_bound: spatial inertia (m in kg; h = m c in kg m; I about the origin, xx,
     yy, zz, xy, xz, yz in kg m^2).
   42 mul, 54 add, 15 abs. */
static inline void ksl_spatial_inertia_shifted_certified(const ksl_vec3_t *t,
    const ksl_spatial_inertia_t *B, ksl_spatial_inertia_t *Bo,
    ksl_spatial_inertia_t *Bo_bound) {
  const double mt_0 = KSL_MUL(t->x, B->m), mt_1 = KSL_MUL(t->y, B->m), mt_2 = KSL_MUL(t->z, B->m);
  const double half_0 = KSL_MUL(0.5, mt_0);
  const double half_1 = KSL_MUL(0.5, mt_1);
  const double half_2 = KSL_MUL(0.5, mt_2);
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
  const double mt_0_abs = fabs(mt_0);
  const double half_0_size = KSL_MUL(0.5, mt_0_abs + 2.004168360008973e-292);
  const double mt_1_abs = fabs(mt_1);
  const double half_1_size = KSL_MUL(0.5, mt_1_abs + 2.004168360008973e-292);
  const double mt_2_abs = fabs(mt_2);
  const double half_2_size = KSL_MUL(0.5, mt_2_abs + 2.004168360008973e-292);
  const double B_1_abs = fabs(B->h.x), n_0_size = B_1_abs + half_0_size;
  const double B_2_abs = fabs(B->h.y), n_1_size = B_2_abs + half_1_size;
  const double B_3_abs = fabs(B->h.z), n_2_size = B_3_abs + half_2_size;
  const double n_0_padded = n_0_size + 2.004168360008973e-292;
  const double t_0_abs = fabs(t->x), tn0_size = KSL_MUL(t_0_abs, n_0_padded);
  const double n_1_padded = n_1_size + 2.004168360008973e-292;
  const double t_1_abs = fabs(t->y), tn1_size = KSL_MUL(t_1_abs, n_1_padded);
  const double n_2_padded = n_2_size + 2.004168360008973e-292;
  const double t_2_abs = fabs(t->z), tn2_size = KSL_MUL(t_2_abs, n_2_padded);
  const double own_0_size = KSL_MUL(2.0, tn0_size + 2.004168360008973e-292),
      own_1_size = KSL_MUL(2.0, tn1_size + 2.004168360008973e-292),
      own_2_size = KSL_MUL(2.0, tn2_size + 2.004168360008973e-292);
  const double pairs_0_size = own_1_size + own_2_size, pairs_1_size = own_0_size + own_2_size,
      pairs_2_size = own_0_size + own_1_size,
      pairs_3_size = KSL_MUL(t_0_abs, n_1_padded) + KSL_MUL(t_1_abs, n_0_padded),
      pairs_4_size = KSL_MUL(t_0_abs, n_2_padded) + KSL_MUL(t_2_abs, n_0_padded),
      pairs_5_size = KSL_MUL(t_1_abs, n_2_padded) + KSL_MUL(t_2_abs, n_1_padded);
  const double moved_0_size = B_1_abs + mt_0_abs, moved_1_size = B_2_abs + mt_1_abs,
      moved_2_size = B_3_abs + mt_2_abs;
  const double Bo_4_size = fabs(B->xx) + pairs_0_size, Bo_5_size = fabs(B->yy) + pairs_1_size,
      Bo_6_size = fabs(B->zz) + pairs_2_size, Bo_7_size = fabs(B->xy) + pairs_3_size,
      Bo_8_size = fabs(B->xz) + pairs_4_size, Bo_9_size = fabs(B->yz) + pairs_5_size;
  const double moved_0_bound = KSL_MUL(2.2204460492503136e-16, moved_0_size
          + 2.004168360008973e-292),
      moved_1_bound = KSL_MUL(2.2204460492503136e-16, moved_1_size + 2.004168360008973e-292),
      moved_2_bound = KSL_MUL(2.2204460492503136e-16, moved_2_size + 2.004168360008973e-292);
  const double Bo_4_bound = KSL_MUL(7.7715611723761e-16, Bo_4_size + 2.004168360008973e-292),
      Bo_5_bound = KSL_MUL(7.7715611723761e-16, Bo_5_size + 2.004168360008973e-292),
      Bo_6_bound = KSL_MUL(7.7715611723761e-16, Bo_6_size + 2.004168360008973e-292),
      Bo_7_bound = KSL_MUL(6.661338147750942e-16, Bo_7_size + 2.004168360008973e-292),
      Bo_8_bound = KSL_MUL(6.661338147750942e-16, Bo_8_size + 2.004168360008973e-292),
      Bo_9_bound = KSL_MUL(6.661338147750942e-16, Bo_9_size + 2.004168360008973e-292);
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
  Bo_bound->m = 0.0;
  Bo_bound->h.x = moved_0_bound;
  Bo_bound->h.y = moved_1_bound;
  Bo_bound->h.z = moved_2_bound;
  Bo_bound->xx = Bo_4_bound;
  Bo_bound->yy = Bo_5_bound;
  Bo_bound->zz = Bo_6_bound;
  Bo_bound->xy = Bo_7_bound;
  Bo_bound->xz = Bo_8_bound;
  Bo_bound->yz = Bo_9_bound;
}

/* Bo = [Ad]*(D) B [Ad]^-1(D): B, given in the frame at D, in the reference frame; |error of Bo|
     <= Bo_bound unless inf or NaN.
   D: displacement [R | t], R rotation, t in m; B, Bo, Bo_bound: spatial inertia (m in kg; h = m
     c in kg m; I about the origin, xx, yy, zz, xy, xz, yz in kg m^2).
   114 mul, 135 add, 51 abs. */
static inline void ksl_spatial_inertia_transformed_certified(const ksl_SE3_t *D,
    const ksl_spatial_inertia_t *B, ksl_spatial_inertia_t *Bo,
    ksl_spatial_inertia_t *Bo_bound) {
  const double RI_0a = KSL_MUL(D->m00, B->xx), RI_0b = KSL_MUL(D->m01, B->xy),
      RI_0d = KSL_MUL(D->m02, B->xz), RI_0 = RI_0a + RI_0b + RI_0d;
  const double RI_1a = KSL_MUL(D->m00, B->xy), RI_1b = KSL_MUL(D->m01, B->yy),
      RI_1d = KSL_MUL(D->m02, B->yz), RI_1 = RI_1a + RI_1b + RI_1d;
  const double RI_2a = KSL_MUL(D->m00, B->xz), RI_2b = KSL_MUL(D->m01, B->yz),
      RI_2d = KSL_MUL(D->m02, B->zz), RI_2 = RI_2a + RI_2b + RI_2d;
  const double RI_3a = KSL_MUL(D->m10, B->xx), RI_3b = KSL_MUL(D->m11, B->xy),
      RI_3d = KSL_MUL(D->m12, B->xz), RI_3 = RI_3a + RI_3b + RI_3d;
  const double RI_4a = KSL_MUL(D->m10, B->xy), RI_4b = KSL_MUL(D->m11, B->yy),
      RI_4d = KSL_MUL(D->m12, B->yz), RI_4 = RI_4a + RI_4b + RI_4d;
  const double RI_5a = KSL_MUL(D->m10, B->xz), RI_5b = KSL_MUL(D->m11, B->yz),
      RI_5d = KSL_MUL(D->m12, B->zz), RI_5 = RI_5a + RI_5b + RI_5d;
  const double RI_6a = KSL_MUL(D->m20, B->xx), RI_6b = KSL_MUL(D->m21, B->xy),
      RI_6d = KSL_MUL(D->m22, B->xz), RI_6 = RI_6a + RI_6b + RI_6d;
  const double RI_7a = KSL_MUL(D->m20, B->xy), RI_7b = KSL_MUL(D->m21, B->yy),
      RI_7d = KSL_MUL(D->m22, B->yz), RI_7 = RI_7a + RI_7b + RI_7d;
  const double RI_8a = KSL_MUL(D->m20, B->xz), RI_8b = KSL_MUL(D->m21, B->yz),
      RI_8d = KSL_MUL(D->m22, B->zz), RI_8 = RI_8a + RI_8b + RI_8d;
  const double turned_1a = KSL_MUL(D->m00, B->h.x), turned_1b = KSL_MUL(D->m01, B->h.y),
      turned_1d = KSL_MUL(D->m02, B->h.z), turned_1 = turned_1a + turned_1b + turned_1d;
  const double turned_2a = KSL_MUL(D->m10, B->h.x), turned_2b = KSL_MUL(D->m11, B->h.y),
      turned_2d = KSL_MUL(D->m12, B->h.z), turned_2 = turned_2a + turned_2b + turned_2d;
  const double turned_3a = KSL_MUL(D->m20, B->h.x), turned_3b = KSL_MUL(D->m21, B->h.y),
      turned_3d = KSL_MUL(D->m22, B->h.z), turned_3 = turned_3a + turned_3b + turned_3d;
  const double turned_4 = KSL_MUL(D->m00, RI_0) + KSL_MUL(D->m01, RI_1) + KSL_MUL(D->m02, RI_2);
  const double turned_5 = KSL_MUL(D->m10, RI_3) + KSL_MUL(D->m11, RI_4) + KSL_MUL(D->m12, RI_5);
  const double turned_6 = KSL_MUL(D->m20, RI_6) + KSL_MUL(D->m21, RI_7) + KSL_MUL(D->m22, RI_8),
      turned_7 = KSL_MUL(D->m10, RI_0) + KSL_MUL(D->m11, RI_1) + KSL_MUL(D->m12, RI_2),
      turned_8 = KSL_MUL(D->m20, RI_0) + KSL_MUL(D->m21, RI_1) + KSL_MUL(D->m22, RI_2),
      turned_9 = KSL_MUL(D->m20, RI_3) + KSL_MUL(D->m21, RI_4) + KSL_MUL(D->m22, RI_5);
  const double mt_0 = KSL_MUL(D->m03, B->m), mt_1 = KSL_MUL(D->m13, B->m),
      mt_2 = KSL_MUL(D->m23, B->m);
  const double half_0 = KSL_MUL(0.5, mt_0);
  const double half_1 = KSL_MUL(0.5, mt_1);
  const double half_2 = KSL_MUL(0.5, mt_2);
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
  const double RI_0_size = fabs(RI_0a) + fabs(RI_0b) + fabs(RI_0d),
      RI_1_size = fabs(RI_1a) + fabs(RI_1b) + fabs(RI_1d),
      RI_2_size = fabs(RI_2a) + fabs(RI_2b) + fabs(RI_2d),
      RI_3_size = fabs(RI_3a) + fabs(RI_3b) + fabs(RI_3d),
      RI_4_size = fabs(RI_4a) + fabs(RI_4b) + fabs(RI_4d),
      RI_5_size = fabs(RI_5a) + fabs(RI_5b) + fabs(RI_5d),
      RI_6_size = fabs(RI_6a) + fabs(RI_6b) + fabs(RI_6d),
      RI_7_size = fabs(RI_7a) + fabs(RI_7b) + fabs(RI_7d),
      RI_8_size = fabs(RI_8a) + fabs(RI_8b) + fabs(RI_8d);
  const double turned_1_size = fabs(turned_1a) + fabs(turned_1b) + fabs(turned_1d),
      turned_2_size = fabs(turned_2a) + fabs(turned_2b) + fabs(turned_2d),
      turned_3_size = fabs(turned_3a) + fabs(turned_3b) + fabs(turned_3d);
  const double RI_0_padded = RI_0_size + 2.004168360008973e-292,
      RI_1_padded = RI_1_size + 2.004168360008973e-292,
      RI_2_padded = RI_2_size + 2.004168360008973e-292;
  const double turned_4_size = KSL_MUL(fabs(D->m00), RI_0_padded)
          + KSL_MUL(fabs(D->m01), RI_1_padded) + KSL_MUL(fabs(D->m02), RI_2_padded);
  const double RI_3_padded = RI_3_size + 2.004168360008973e-292;
  const double D_10_abs = fabs(D->m10);
  const double RI_4_padded = RI_4_size + 2.004168360008973e-292;
  const double D_11_abs = fabs(D->m11);
  const double RI_5_padded = RI_5_size + 2.004168360008973e-292;
  const double D_12_abs = fabs(D->m12),
      turned_5_size = KSL_MUL(D_10_abs, RI_3_padded) + KSL_MUL(D_11_abs, RI_4_padded)
          + KSL_MUL(D_12_abs, RI_5_padded);
  const double D_20_abs = fabs(D->m20), D_21_abs = fabs(D->m21), D_22_abs = fabs(D->m22),
      turned_6c_size = KSL_MUL(D_20_abs, RI_6_size + 2.004168360008973e-292)
          + KSL_MUL(D_21_abs, RI_7_size + 2.004168360008973e-292),
      turned_6_size = turned_6c_size + KSL_MUL(D_22_abs, RI_8_size + 2.004168360008973e-292);
  const double turned_7_size = KSL_MUL(D_10_abs, RI_0_padded) + KSL_MUL(D_11_abs, RI_1_padded)
          + KSL_MUL(D_12_abs, RI_2_padded),
      turned_8_size = KSL_MUL(D_20_abs, RI_0_padded) + KSL_MUL(D_21_abs, RI_1_padded)
          + KSL_MUL(D_22_abs, RI_2_padded),
      turned_9_size = KSL_MUL(D_20_abs, RI_3_padded) + KSL_MUL(D_21_abs, RI_4_padded)
          + KSL_MUL(D_22_abs, RI_5_padded);
  const double mt_0_abs = fabs(mt_0);
  const double half_0_size = KSL_MUL(0.5, mt_0_abs + 2.004168360008973e-292);
  const double mt_1_abs = fabs(mt_1);
  const double half_1_size = KSL_MUL(0.5, mt_1_abs + 2.004168360008973e-292);
  const double mt_2_abs = fabs(mt_2);
  const double half_2_size = KSL_MUL(0.5, mt_2_abs + 2.004168360008973e-292);
  const double n_0_size = turned_1_size + half_0_size, n_1_size = turned_2_size + half_1_size,
      n_2_size = turned_3_size + half_2_size;
  const double n_0_padded = n_0_size + 2.004168360008973e-292;
  const double D_03_abs = fabs(D->m03), tn0_size = KSL_MUL(D_03_abs, n_0_padded);
  const double n_1_padded = n_1_size + 2.004168360008973e-292;
  const double D_13_abs = fabs(D->m13), tn1_size = KSL_MUL(D_13_abs, n_1_padded);
  const double n_2_padded = n_2_size + 2.004168360008973e-292;
  const double D_23_abs = fabs(D->m23), tn2_size = KSL_MUL(D_23_abs, n_2_padded);
  const double own_0_size = KSL_MUL(2.0, tn0_size + 2.004168360008973e-292),
      own_1_size = KSL_MUL(2.0, tn1_size + 2.004168360008973e-292),
      own_2_size = KSL_MUL(2.0, tn2_size + 2.004168360008973e-292);
  const double pairs_0_size = own_1_size + own_2_size, pairs_1_size = own_0_size + own_2_size,
      pairs_2_size = own_0_size + own_1_size,
      pairs_3_size = KSL_MUL(D_03_abs, n_1_padded) + KSL_MUL(D_13_abs, n_0_padded),
      pairs_4_size = KSL_MUL(D_03_abs, n_2_padded) + KSL_MUL(D_23_abs, n_0_padded),
      pairs_5_size = KSL_MUL(D_13_abs, n_2_padded) + KSL_MUL(D_23_abs, n_1_padded);
  const double moved_0_size = turned_1_size + mt_0_abs, moved_1_size = turned_2_size + mt_1_abs,
      moved_2_size = turned_3_size + mt_2_abs;
  const double Bo_4_size = turned_4_size + pairs_0_size, Bo_5_size = turned_5_size + pairs_1_size,
      Bo_6_size = turned_6_size + pairs_2_size, Bo_7_size = turned_7_size + pairs_3_size,
      Bo_8_size = turned_8_size + pairs_4_size, Bo_9_size = turned_9_size + pairs_5_size;
  const double moved_0_bound = KSL_MUL(4.440892098500628e-16, moved_0_size
          + 2.004168360008973e-292),
      moved_1_bound = KSL_MUL(4.440892098500628e-16, moved_1_size + 2.004168360008973e-292),
      moved_2_bound = KSL_MUL(4.440892098500628e-16, moved_2_size + 2.004168360008973e-292);
  const double Bo_4_bound = KSL_MUL(8.881784197001258e-16, Bo_4_size + 2.004168360008973e-292),
      Bo_5_bound = KSL_MUL(8.881784197001258e-16, Bo_5_size + 2.004168360008973e-292),
      Bo_6_bound = KSL_MUL(8.881784197001258e-16, Bo_6_size + 2.004168360008973e-292),
      Bo_7_bound = KSL_MUL(7.7715611723761e-16, Bo_7_size + 2.004168360008973e-292),
      Bo_8_bound = KSL_MUL(7.7715611723761e-16, Bo_8_size + 2.004168360008973e-292),
      Bo_9_bound = KSL_MUL(7.7715611723761e-16, Bo_9_size + 2.004168360008973e-292);
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
  Bo_bound->m = 0.0;
  Bo_bound->h.x = moved_0_bound;
  Bo_bound->h.y = moved_1_bound;
  Bo_bound->h.z = moved_2_bound;
  Bo_bound->xx = Bo_4_bound;
  Bo_bound->yy = Bo_5_bound;
  Bo_bound->zz = Bo_6_bound;
  Bo_bound->xy = Bo_7_bound;
  Bo_bound->xz = Bo_8_bound;
  Bo_bound->yz = Bo_9_bound;
}

/* self = a self; |error of self| <= self_bound unless inf or NaN.
   self, self_bound: spatial inertia (m in kg; h = m c in kg m; I about the origin, xx, yy, zz,
     xy, xz, yz in kg m^2); a: number.
   20 mul, 10 add, 10 abs. */
static inline void ksl_spatial_inertiaf_scale_certified(ksl_spatial_inertiaf_t *self,
    const float a, ksl_spatial_inertiaf_t *self_bound) {
  const float self_0_new = KSL_MULF(self->m, a), self_1_new = KSL_MULF(self->h.x, a),
      self_2_new = KSL_MULF(self->h.y, a), self_3_new = KSL_MULF(self->h.z, a),
      self_4_new = KSL_MULF(self->xx, a), self_5_new = KSL_MULF(self->yy, a),
      self_6_new = KSL_MULF(self->zz, a), self_7_new = KSL_MULF(self->xy, a),
      self_8_new = KSL_MULF(self->xz, a), self_9_new = KSL_MULF(self->yz, a);
  const float self_0_new_bound = KSL_MULF(5.960465e-08f, fabsf(self_0_new) + 1.9721523e-31f),
      self_1_new_bound = KSL_MULF(5.960465e-08f, fabsf(self_1_new) + 1.9721523e-31f),
      self_2_new_bound = KSL_MULF(5.960465e-08f, fabsf(self_2_new) + 1.9721523e-31f),
      self_3_new_bound = KSL_MULF(5.960465e-08f, fabsf(self_3_new) + 1.9721523e-31f),
      self_4_new_bound = KSL_MULF(5.960465e-08f, fabsf(self_4_new) + 1.9721523e-31f),
      self_5_new_bound = KSL_MULF(5.960465e-08f, fabsf(self_5_new) + 1.9721523e-31f),
      self_6_new_bound = KSL_MULF(5.960465e-08f, fabsf(self_6_new) + 1.9721523e-31f),
      self_7_new_bound = KSL_MULF(5.960465e-08f, fabsf(self_7_new) + 1.9721523e-31f),
      self_8_new_bound = KSL_MULF(5.960465e-08f, fabsf(self_8_new) + 1.9721523e-31f),
      self_9_new_bound = KSL_MULF(5.960465e-08f, fabsf(self_9_new) + 1.9721523e-31f);
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
  self_bound->m = self_0_new_bound;
  self_bound->h.x = self_1_new_bound;
  self_bound->h.y = self_2_new_bound;
  self_bound->h.z = self_3_new_bound;
  self_bound->xx = self_4_new_bound;
  self_bound->yy = self_5_new_bound;
  self_bound->zz = self_6_new_bound;
  self_bound->xy = self_7_new_bound;
  self_bound->xz = self_8_new_bound;
  self_bound->yz = self_9_new_bound;
}

/* Bo = B1 + B2; |error of Bo| <= Bo_bound unless inf or NaN.
   B1, B2, Bo, Bo_bound: spatial inertia (m in kg; h = m c in kg m; I about the origin, xx, yy,
     zz, xy, xz, yz in kg m^2).
   10 mul, 10 add, 10 abs. */
static inline void ksl_add_BBf_certified(const ksl_spatial_inertiaf_t *B1,
    const ksl_spatial_inertiaf_t *B2, ksl_spatial_inertiaf_t *Bo,
    ksl_spatial_inertiaf_t *Bo_bound) {
  const float Bo_0 = B1->m + B2->m, Bo_1 = B1->h.x + B2->h.x, Bo_2 = B1->h.y + B2->h.y,
      Bo_3 = B1->h.z + B2->h.z, Bo_4 = B1->xx + B2->xx, Bo_5 = B1->yy + B2->yy,
      Bo_6 = B1->zz + B2->zz, Bo_7 = B1->xy + B2->xy, Bo_8 = B1->xz + B2->xz,
      Bo_9 = B1->yz + B2->yz;
  const float Bo_0_bound = KSL_MULF(5.960465e-08f, fabsf(Bo_0)),
      Bo_1_bound = KSL_MULF(5.960465e-08f, fabsf(Bo_1)),
      Bo_2_bound = KSL_MULF(5.960465e-08f, fabsf(Bo_2)),
      Bo_3_bound = KSL_MULF(5.960465e-08f, fabsf(Bo_3)),
      Bo_4_bound = KSL_MULF(5.960465e-08f, fabsf(Bo_4)),
      Bo_5_bound = KSL_MULF(5.960465e-08f, fabsf(Bo_5)),
      Bo_6_bound = KSL_MULF(5.960465e-08f, fabsf(Bo_6)),
      Bo_7_bound = KSL_MULF(5.960465e-08f, fabsf(Bo_7)),
      Bo_8_bound = KSL_MULF(5.960465e-08f, fabsf(Bo_8)),
      Bo_9_bound = KSL_MULF(5.960465e-08f, fabsf(Bo_9));
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
  Bo_bound->m = Bo_0_bound;
  Bo_bound->h.x = Bo_1_bound;
  Bo_bound->h.y = Bo_2_bound;
  Bo_bound->h.z = Bo_3_bound;
  Bo_bound->xx = Bo_4_bound;
  Bo_bound->yy = Bo_5_bound;
  Bo_bound->zz = Bo_6_bound;
  Bo_bound->xy = Bo_7_bound;
  Bo_bound->xz = Bo_8_bound;
  Bo_bound->yz = Bo_9_bound;
}

/* Bo = B1 - B2; |error of Bo| <= Bo_bound unless inf or NaN.
   B1, B2, Bo, Bo_bound: spatial inertia (m in kg; h = m c in kg m; I about the origin, xx, yy,
     zz, xy, xz, yz in kg m^2).
   10 mul, 10 add, 10 abs. */
static inline void ksl_subtract_BBf_certified(const ksl_spatial_inertiaf_t *B1,
    const ksl_spatial_inertiaf_t *B2, ksl_spatial_inertiaf_t *Bo,
    ksl_spatial_inertiaf_t *Bo_bound) {
  const float Bo_0 = B1->m - B2->m, Bo_1 = B1->h.x - B2->h.x, Bo_2 = B1->h.y - B2->h.y,
      Bo_3 = B1->h.z - B2->h.z, Bo_4 = B1->xx - B2->xx, Bo_5 = B1->yy - B2->yy,
      Bo_6 = B1->zz - B2->zz, Bo_7 = B1->xy - B2->xy, Bo_8 = B1->xz - B2->xz,
      Bo_9 = B1->yz - B2->yz;
  const float Bo_0_bound = KSL_MULF(5.960465e-08f, fabsf(Bo_0)),
      Bo_1_bound = KSL_MULF(5.960465e-08f, fabsf(Bo_1)),
      Bo_2_bound = KSL_MULF(5.960465e-08f, fabsf(Bo_2)),
      Bo_3_bound = KSL_MULF(5.960465e-08f, fabsf(Bo_3)),
      Bo_4_bound = KSL_MULF(5.960465e-08f, fabsf(Bo_4)),
      Bo_5_bound = KSL_MULF(5.960465e-08f, fabsf(Bo_5)),
      Bo_6_bound = KSL_MULF(5.960465e-08f, fabsf(Bo_6)),
      Bo_7_bound = KSL_MULF(5.960465e-08f, fabsf(Bo_7)),
      Bo_8_bound = KSL_MULF(5.960465e-08f, fabsf(Bo_8)),
      Bo_9_bound = KSL_MULF(5.960465e-08f, fabsf(Bo_9));
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
  Bo_bound->m = Bo_0_bound;
  Bo_bound->h.x = Bo_1_bound;
  Bo_bound->h.y = Bo_2_bound;
  Bo_bound->h.z = Bo_3_bound;
  Bo_bound->xx = Bo_4_bound;
  Bo_bound->yy = Bo_5_bound;
  Bo_bound->zz = Bo_6_bound;
  Bo_bound->xy = Bo_7_bound;
  Bo_bound->xz = Bo_8_bound;
  Bo_bound->yz = Bo_9_bound;
}

/* Bo: mass m, centre of mass com, second moments Ic about it (kg m^2; only the upper triangle is
     read): h = m com, I = Ic - m com~ com~; |error of Bo| <= Bo_bound unless inf or NaN.
   m: number; com: vector; Ic: rotation or other 3×3 matrix; Bo, Bo_bound: spatial inertia (m in
     kg; h = m c in kg m; I about the origin, xx, yy, zz, xy, xz, yz in kg m^2).
   24 mul, 27 add, 12 abs. */
static inline void ksl_spatial_inertiaf_from_com_certified(const float m, const ksl_vec3f_t *com,
    const ksl_mat3x3f_t *Ic, ksl_spatial_inertiaf_t *Bo,
    ksl_spatial_inertiaf_t *Bo_bound) {
  const float h_0 = KSL_MULF(m, com->x), h_1 = KSL_MULF(m, com->y), h_2 = KSL_MULF(m, com->z);
  const float squares_0 = KSL_MULF(com->x, h_0);
  const float squares_1 = KSL_MULF(com->y, h_1);
  const float squares_2 = KSL_MULF(com->z, h_2);
  const float Bo_4 = Ic->m00 + (squares_1 + squares_2), Bo_5 = Ic->m11 + (squares_0 + squares_2),
      Bo_6 = Ic->m22 + (squares_0 + squares_1), Bo_7 = Ic->m01 - KSL_MULF(com->y, h_0),
      Bo_8 = Ic->m02 - KSL_MULF(com->z, h_0), Bo_9 = Ic->m12 - KSL_MULF(com->z, h_1);
  const float h_0_padded = fabsf(h_0) + 1.9721523e-31f;
  const float squares_0_size = KSL_MULF(fabsf(com->x), h_0_padded);
  const float h_1_padded = fabsf(h_1) + 1.9721523e-31f;
  const float com_1_abs = fabsf(com->y), squares_1_size = KSL_MULF(com_1_abs, h_1_padded);
  const float h_2_padded = fabsf(h_2) + 1.9721523e-31f;
  const float com_2_abs = fabsf(com->z), squares_2_size = KSL_MULF(com_2_abs, h_2_padded);
  const float Bo_4_size = fabsf(Ic->m00) + (squares_1_size + squares_2_size),
      Bo_5_size = fabsf(Ic->m11) + (squares_0_size + squares_2_size),
      Bo_6_size = fabsf(Ic->m22) + (squares_0_size + squares_1_size),
      Bo_7_size = fabsf(Ic->m01) + KSL_MULF(com_1_abs, h_0_padded),
      Bo_8_size = fabsf(Ic->m02) + KSL_MULF(com_2_abs, h_0_padded),
      Bo_9_size = fabsf(Ic->m12) + KSL_MULF(com_2_abs, h_1_padded);
  const float h_0_bound = KSL_MULF(5.960465e-08f, h_0_padded),
      h_1_bound = KSL_MULF(5.960465e-08f, h_1_padded),
      h_2_bound = KSL_MULF(5.960465e-08f, h_2_padded);
  const float Bo_4_bound = KSL_MULF(2.3841864e-07f, Bo_4_size + 1.9721523e-31f),
      Bo_5_bound = KSL_MULF(2.3841864e-07f, Bo_5_size + 1.9721523e-31f),
      Bo_6_bound = KSL_MULF(2.3841864e-07f, Bo_6_size + 1.9721523e-31f),
      Bo_7_bound = KSL_MULF(1.7881396e-07f, Bo_7_size + 1.9721523e-31f),
      Bo_8_bound = KSL_MULF(1.7881396e-07f, Bo_8_size + 1.9721523e-31f),
      Bo_9_bound = KSL_MULF(1.7881396e-07f, Bo_9_size + 1.9721523e-31f);
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
  Bo_bound->m = 0.0f;
  Bo_bound->h.x = h_0_bound;
  Bo_bound->h.y = h_1_bound;
  Bo_bound->h.z = h_2_bound;
  Bo_bound->xx = Bo_4_bound;
  Bo_bound->yy = Bo_5_bound;
  Bo_bound->zz = Bo_6_bound;
  Bo_bound->xy = Bo_7_bound;
  Bo_bound->xz = Bo_8_bound;
  Bo_bound->yz = Bo_9_bound;
}

/* co = B s = (m v - h × ω; h × v + I ω), the momentum of a body that moves with s; |error of co|
     <= co_bound unless inf or NaN.
   B: spatial inertia (m in kg; h = m c in kg m; I about the origin, xx, yy, zz, xy, xz, yz in kg
     m^2); s: screw (v in m/s; ω in rad/s); co, co_bound: coscrew (f in N; τ in N m).
   30 mul, 42 add, 24 abs. */
static inline void ksl_product_Bsf_certified(const ksl_spatial_inertiaf_t *B,
    const ksl_screwf_t *s, ksl_coscrewf_t *co, ksl_coscrewf_t *co_bound) {
  const float co_0a = KSL_MULF(B->m, s->m0), co_0b = KSL_MULF(B->h.z, s->m4),
      co_0c = KSL_MULF(B->h.y, s->m5), co_0 = co_0a + (co_0b - co_0c);
  const float co_1a = KSL_MULF(B->m, s->m1), co_1b = KSL_MULF(B->h.x, s->m5),
      co_1c = KSL_MULF(B->h.z, s->m3), co_1 = co_1a + (co_1b - co_1c);
  const float co_2a = KSL_MULF(B->m, s->m2), co_2b = KSL_MULF(B->h.y, s->m3),
      co_2c = KSL_MULF(B->h.x, s->m4), co_2 = co_2a + (co_2b - co_2c);
  const float co_3a = KSL_MULF(B->h.y, s->m2), co_3b = KSL_MULF(B->h.z, s->m1),
      co_3d = KSL_MULF(B->xx, s->m3), co_3e = KSL_MULF(B->xy, s->m4),
      co_3g = KSL_MULF(B->xz, s->m5), co_3 = co_3a - co_3b + (co_3d + co_3e + co_3g);
  const float co_4a = KSL_MULF(B->h.z, s->m0), co_4b = KSL_MULF(B->h.x, s->m2),
      co_4d = KSL_MULF(B->yy, s->m4), co_4e = KSL_MULF(B->xy, s->m3),
      co_4g = KSL_MULF(B->yz, s->m5), co_4 = co_4a - co_4b + (co_4d + co_4e + co_4g);
  const float co_5a = KSL_MULF(B->h.x, s->m1), co_5b = KSL_MULF(B->h.y, s->m0),
      co_5d = KSL_MULF(B->zz, s->m5), co_5e = KSL_MULF(B->xz, s->m3),
      co_5g = KSL_MULF(B->yz, s->m4), co_5 = co_5a - co_5b + (co_5d + co_5e + co_5g);
  const float co_0_size = fabsf(co_0a) + (fabsf(co_0b) + fabsf(co_0c)),
      co_1_size = fabsf(co_1a) + (fabsf(co_1b) + fabsf(co_1c)),
      co_2_size = fabsf(co_2a) + (fabsf(co_2b) + fabsf(co_2c)),
      co_3_size = fabsf(co_3a) + fabsf(co_3b) + (fabsf(co_3d) + fabsf(co_3e) + fabsf(co_3g)),
      co_4_size = fabsf(co_4a) + fabsf(co_4b) + (fabsf(co_4d) + fabsf(co_4e) + fabsf(co_4g)),
      co_5_size = fabsf(co_5a) + fabsf(co_5b) + (fabsf(co_5d) + fabsf(co_5e) + fabsf(co_5g));
  const float co_0_bound = KSL_MULF(1.7881396e-07f, co_0_size + 1.9721523e-31f),
      co_1_bound = KSL_MULF(1.7881396e-07f, co_1_size + 1.9721523e-31f),
      co_2_bound = KSL_MULF(1.7881396e-07f, co_2_size + 1.9721523e-31f),
      co_3_bound = KSL_MULF(2.3841864e-07f, co_3_size + 1.9721523e-31f),
      co_4_bound = KSL_MULF(2.3841864e-07f, co_4_size + 1.9721523e-31f),
      co_5_bound = KSL_MULF(2.3841864e-07f, co_5_size + 1.9721523e-31f);
  co->m0 = co_0;
  co->m1 = co_1;
  co->m2 = co_2;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
  co_bound->m0 = co_0_bound;
  co_bound->m1 = co_1_bound;
  co_bound->m2 = co_2_bound;
  co_bound->m3 = co_3_bound;
  co_bound->m4 = co_4_bound;
  co_bound->m5 = co_5_bound;
}

/* s·B s / 2, the kinetic energy in J of a body that moves with s; |error of energy| <=
     energy_bound unless inf or NaN.
   B: spatial inertia (m in kg; h = m c in kg m; I about the origin, xx, yy, zz, xy, xz, yz in kg
     m^2); s: screw (v in m/s; ω in rad/s); energy_bound: number.
   35 mul, 43 add, 25 abs. */
static inline float ksl_spatial_inertiaf_energy_certified(const ksl_spatial_inertiaf_t *B,
    const ksl_screwf_t *s, float *energy_bound) {
  const float square_a = KSL_MULF(s->m0, s->m0), square_b = KSL_MULF(s->m1, s->m1),
      square_d = KSL_MULF(s->m2, s->m2), square = square_a + square_b + square_d;
  const float L_0a = KSL_MULF(B->xx, s->m3), L_0b = KSL_MULF(B->xy, s->m4),
      L_0d = KSL_MULF(B->xz, s->m5), L_0 = L_0a + L_0b + L_0d;
  const float L_1a = KSL_MULF(B->yy, s->m4), L_1b = KSL_MULF(B->xy, s->m3),
      L_1d = KSL_MULF(B->yz, s->m5), L_1 = L_1a + L_1b + L_1d;
  const float L_2a = KSL_MULF(B->zz, s->m5), L_2b = KSL_MULF(B->xz, s->m3),
      L_2d = KSL_MULF(B->yz, s->m4), L_2 = L_2a + L_2b + L_2d;
  const float twice = KSL_MULF(B->m, square)
          + (KSL_MULF(s->m3, L_0) + KSL_MULF(s->m4, L_1) + KSL_MULF(s->m5, L_2));
  const float across_0a = KSL_MULF(B->h.z, s->m4), across_0b = KSL_MULF(B->h.y, s->m5),
      across_0 = across_0a - across_0b;
  const float across_1a = KSL_MULF(B->h.x, s->m5), across_1b = KSL_MULF(B->h.z, s->m3),
      across_1 = across_1a - across_1b;
  const float across_2a = KSL_MULF(B->h.y, s->m3), across_2b = KSL_MULF(B->h.x, s->m4),
      across_2 = across_2a - across_2b;
  const float energy = KSL_MULF(s->m0, across_0) + KSL_MULF(s->m1, across_1)
          + KSL_MULF(s->m2, across_2) + KSL_MULF(0.5f, twice);
  const float square_size = fabsf(square_a) + fabsf(square_b) + fabsf(square_d);
  const float L_0_size = fabsf(L_0a) + fabsf(L_0b) + fabsf(L_0d),
      L_1_size = fabsf(L_1a) + fabsf(L_1b) + fabsf(L_1d),
      L_2_size = fabsf(L_2a) + fabsf(L_2b) + fabsf(L_2d);
  const float twice_d_size = KSL_MULF(fabsf(s->m3), L_0_size + 1.9721523e-31f)
          + KSL_MULF(fabsf(s->m4), L_1_size + 1.9721523e-31f),
      twice_size = KSL_MULF(fabsf(B->m), square_size + 1.9721523e-31f)
          + (twice_d_size + KSL_MULF(fabsf(s->m5), L_2_size + 1.9721523e-31f));
  const float across_0_size = fabsf(across_0a) + fabsf(across_0b),
      across_1_size = fabsf(across_1a) + fabsf(across_1b),
      across_2_size = fabsf(across_2a) + fabsf(across_2b);
  const float energy_c_size = KSL_MULF(fabsf(s->m0), across_0_size + 1.9721523e-31f)
          + KSL_MULF(fabsf(s->m1), across_1_size + 1.9721523e-31f),
      energy_size = energy_c_size + KSL_MULF(fabsf(s->m2), across_2_size + 1.9721523e-31f)
          + KSL_MULF(0.5f, twice_size + 1.9721523e-31f);
  const float energy_bound_ = KSL_MULF(5.36442e-07f, energy_size + 1.9721523e-31f);
  *energy_bound = energy_bound_;
  return energy;
}

/* co = B ds + (w × (w × h); w × I w): the net wrench, about the origin, of a body with angular
     velocity w and acceleration ds = (a; w'), where a is that of the point now at the origin; if
     a is less gravity's, so is the wrench; |error of co| <= co_bound unless inf or NaN.
   B: spatial inertia (m in kg; h = m c in kg m; I about the origin, xx, yy, zz, xy, xz, yz in kg
     m^2); w: vector; ds: screw (v in m/s; ω in rad/s); co, co_bound: coscrew (f in N; τ in N m).
   66 mul, 102 add, 3 neg, 30 abs. */
static inline void ksl_spatial_inertiaf_net_wrench_certified(const ksl_spatial_inertiaf_t *B,
    const ksl_vec3f_t *w, const ksl_screwf_t *ds, ksl_coscrewf_t *co,
    ksl_coscrewf_t *co_bound) {
  const float ww_0 = KSL_MULF(w->x, w->x), ww_1 = KSL_MULF(w->y, w->y), ww_2 = KSL_MULF(w->z, w->z),
      ww_3 = KSL_MULF(w->x, w->y), ww_4 = KSL_MULF(w->x, w->z), ww_5 = KSL_MULF(w->y, w->z);
  const float U_0 = -(ww_1 + ww_2), U_1 = ww_3 - ds->m5, U_2 = ds->m4 + ww_4, U_3 = ds->m5 + ww_3,
      U_4 = -(ww_0 + ww_2), U_5 = ww_5 - ds->m3, U_6 = ww_4 - ds->m4, U_7 = ds->m3 + ww_5,
      U_8 = -(ww_0 + ww_1);
  const float others_0 = B->zz - B->yy, others_1 = B->xx - B->zz, others_2 = B->yy - B->xx;
  const float squares_0 = ww_1 - ww_2, squares_1 = ww_2 - ww_0, squares_2 = ww_0 - ww_1;
  const float own_0a = KSL_MULF(B->xx, ds->m3), own_0 = own_0a + KSL_MULF(ww_5, others_0);
  const float own_1a = KSL_MULF(B->yy, ds->m4), own_1 = own_1a + KSL_MULF(ww_4, others_1);
  const float own_2a = KSL_MULF(B->zz, ds->m5), own_2 = own_2a + KSL_MULF(ww_3, others_2);
  const float N_0 = KSL_MULF(B->xz, U_3) - KSL_MULF(B->xy, U_6) + KSL_MULF(B->yz, squares_0)
          + own_0;
  const float N_1 = KSL_MULF(B->xy, U_7) - KSL_MULF(B->yz, U_1) + KSL_MULF(B->xz, squares_1)
          + own_1;
  const float N_2 = KSL_MULF(B->xy, squares_2) + (KSL_MULF(B->yz, U_2) - KSL_MULF(B->xz, U_5))
          + own_2;
  const float co_0a = KSL_MULF(B->m, ds->m0),
      co_0 = co_0a + (KSL_MULF(B->h.x, U_0) + KSL_MULF(B->h.y, U_1) + KSL_MULF(B->h.z, U_2));
  const float co_1a = KSL_MULF(B->m, ds->m1),
      co_1 = co_1a + (KSL_MULF(B->h.x, U_3) + KSL_MULF(B->h.y, U_4) + KSL_MULF(B->h.z, U_5));
  const float co_2a = KSL_MULF(B->m, ds->m2),
      co_2 = co_2a + (KSL_MULF(B->h.x, U_6) + KSL_MULF(B->h.y, U_7) + KSL_MULF(B->h.z, U_8));
  const float co_3a = KSL_MULF(B->h.y, ds->m2), co_3b = KSL_MULF(B->h.z, ds->m1),
      co_3 = co_3a - co_3b + N_0;
  const float co_4a = KSL_MULF(B->h.z, ds->m0), co_4b = KSL_MULF(B->h.x, ds->m2),
      co_4 = co_4a - co_4b + N_1;
  const float co_5a = KSL_MULF(B->h.x, ds->m1), co_5b = KSL_MULF(B->h.y, ds->m0),
      co_5 = co_5a - co_5b + N_2;
  const float ww_1_abs = fabsf(ww_1), ww_2_abs = fabsf(ww_2);
  const float ww_3_abs = fabsf(ww_3), ds_5_abs = fabsf(ds->m5), U_1_size = ww_3_abs + ds_5_abs;
  const float ds_4_abs = fabsf(ds->m4), ww_4_abs = fabsf(ww_4), U_2_size = ds_4_abs + ww_4_abs;
  const float U_3_size = ds_5_abs + ww_3_abs, ww_0_abs = fabsf(ww_0);
  const float ww_5_abs = fabsf(ww_5), ds_3_abs = fabsf(ds->m3), U_5_size = ww_5_abs + ds_3_abs;
  const float U_6_size = ww_4_abs + ds_4_abs, U_7_size = ds_3_abs + ww_5_abs;
  const float squares_0_size = ww_1_abs + ww_2_abs, squares_1_size = ww_2_abs + ww_0_abs,
      squares_2_size = ww_0_abs + ww_1_abs;
  const float own_0_size = fabsf(own_0a) + KSL_MULF(ww_5_abs + 1.9721523e-31f, fabsf(others_0)),
      own_1_size = fabsf(own_1a) + KSL_MULF(ww_4_abs + 1.9721523e-31f, fabsf(others_1)),
      own_2_size = fabsf(own_2a) + KSL_MULF(ww_3_abs + 1.9721523e-31f, fabsf(others_2));
  const float U_3_padded = U_3_size + 1.9721523e-31f;
  const float B_8_abs = fabsf(B->xz);
  const float U_6_padded = U_6_size + 1.9721523e-31f;
  const float B_7_abs = fabsf(B->xy), B_9_abs = fabsf(B->yz),
      N_0_size = KSL_MULF(B_8_abs, U_3_padded) + KSL_MULF(B_7_abs, U_6_padded)
          + KSL_MULF(B_9_abs, squares_0_size + 1.9721523e-31f) + own_0_size;
  const float U_7_padded = U_7_size + 1.9721523e-31f, U_1_padded = U_1_size + 1.9721523e-31f;
  const float N_1_size = KSL_MULF(B_7_abs, U_7_padded) + KSL_MULF(B_9_abs, U_1_padded)
          + KSL_MULF(B_8_abs, squares_1_size + 1.9721523e-31f) + own_1_size;
  const float U_2_padded = U_2_size + 1.9721523e-31f, U_5_padded = U_5_size + 1.9721523e-31f;
  const float N_2_size = KSL_MULF(B_7_abs, squares_2_size + 1.9721523e-31f)
          + (KSL_MULF(B_9_abs, U_2_padded) + KSL_MULF(B_8_abs, U_5_padded)) + own_2_size;
  const float B_1_abs = fabsf(B->h.x), B_2_abs = fabsf(B->h.y), B_3_abs = fabsf(B->h.z),
      co_0_size = fabsf(co_0a)
          + (KSL_MULF(B_1_abs, ww_1_abs + ww_2_abs + 1.9721523e-31f)
          + KSL_MULF(B_2_abs, U_1_padded) + KSL_MULF(B_3_abs, U_2_padded));
  const float co_1_size = fabsf(co_1a)
          + (KSL_MULF(B_1_abs, U_3_padded)
          + KSL_MULF(B_2_abs, ww_0_abs + ww_2_abs + 1.9721523e-31f)
          + KSL_MULF(B_3_abs, U_5_padded)),
      co_2_size = fabsf(co_2a)
          + (KSL_MULF(B_1_abs, U_6_padded) + KSL_MULF(B_2_abs, U_7_padded)
          + KSL_MULF(B_3_abs, ww_0_abs + ww_1_abs + 1.9721523e-31f)),
      co_3_size = fabsf(co_3a) + fabsf(co_3b) + N_0_size,
      co_4_size = fabsf(co_4a) + fabsf(co_4b) + N_1_size,
      co_5_size = fabsf(co_5a) + fabsf(co_5b) + N_2_size;
  const float co_0_bound = KSL_MULF(3.5762795e-07f, co_0_size + 1.9721523e-31f),
      co_1_bound = KSL_MULF(3.5762795e-07f, co_1_size + 1.9721523e-31f),
      co_2_bound = KSL_MULF(3.5762795e-07f, co_2_size + 1.9721523e-31f),
      co_3_bound = KSL_MULF(4.1723263e-07f, co_3_size + 1.9721523e-31f),
      co_4_bound = KSL_MULF(4.1723263e-07f, co_4_size + 1.9721523e-31f),
      co_5_bound = KSL_MULF(4.1723263e-07f, co_5_size + 1.9721523e-31f);
  co->m0 = co_0;
  co->m1 = co_1;
  co->m2 = co_2;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
  co_bound->m0 = co_0_bound;
  co_bound->m1 = co_1_bound;
  co_bound->m2 = co_2_bound;
  co_bound->m3 = co_3_bound;
  co_bound->m4 = co_4_bound;
  co_bound->m5 = co_5_bound;
}

/* Bo = B moved by t: m, h + m t, I - t~ (h + m t)~ - h~ t~; |error of Bo| <= Bo_bound unless inf
     or NaN.
   t: vector; B, Bo, Bo_bound: spatial inertia (m in kg; h = m c in kg m; I about the origin, xx,
     yy, zz, xy, xz, yz in kg m^2).
   42 mul, 54 add, 15 abs. */
static inline void ksl_spatial_inertiaf_shifted_certified(const ksl_vec3f_t *t,
    const ksl_spatial_inertiaf_t *B, ksl_spatial_inertiaf_t *Bo,
    ksl_spatial_inertiaf_t *Bo_bound) {
  const float mt_0 = KSL_MULF(t->x, B->m), mt_1 = KSL_MULF(t->y, B->m), mt_2 = KSL_MULF(t->z, B->m);
  const float half_0 = KSL_MULF(0.5f, mt_0);
  const float half_1 = KSL_MULF(0.5f, mt_1);
  const float half_2 = KSL_MULF(0.5f, mt_2);
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
  const float mt_0_abs = fabsf(mt_0);
  const float half_0_size = KSL_MULF(0.5f, mt_0_abs + 1.9721523e-31f);
  const float mt_1_abs = fabsf(mt_1);
  const float half_1_size = KSL_MULF(0.5f, mt_1_abs + 1.9721523e-31f);
  const float mt_2_abs = fabsf(mt_2);
  const float half_2_size = KSL_MULF(0.5f, mt_2_abs + 1.9721523e-31f);
  const float B_1_abs = fabsf(B->h.x), n_0_size = B_1_abs + half_0_size;
  const float B_2_abs = fabsf(B->h.y), n_1_size = B_2_abs + half_1_size;
  const float B_3_abs = fabsf(B->h.z), n_2_size = B_3_abs + half_2_size;
  const float n_0_padded = n_0_size + 1.9721523e-31f;
  const float t_0_abs = fabsf(t->x), tn0_size = KSL_MULF(t_0_abs, n_0_padded);
  const float n_1_padded = n_1_size + 1.9721523e-31f;
  const float t_1_abs = fabsf(t->y), tn1_size = KSL_MULF(t_1_abs, n_1_padded);
  const float n_2_padded = n_2_size + 1.9721523e-31f;
  const float t_2_abs = fabsf(t->z), tn2_size = KSL_MULF(t_2_abs, n_2_padded);
  const float own_0_size = KSL_MULF(2.0f, tn0_size + 1.9721523e-31f),
      own_1_size = KSL_MULF(2.0f, tn1_size + 1.9721523e-31f),
      own_2_size = KSL_MULF(2.0f, tn2_size + 1.9721523e-31f);
  const float pairs_0_size = own_1_size + own_2_size, pairs_1_size = own_0_size + own_2_size,
      pairs_2_size = own_0_size + own_1_size,
      pairs_3_size = KSL_MULF(t_0_abs, n_1_padded) + KSL_MULF(t_1_abs, n_0_padded),
      pairs_4_size = KSL_MULF(t_0_abs, n_2_padded) + KSL_MULF(t_2_abs, n_0_padded),
      pairs_5_size = KSL_MULF(t_1_abs, n_2_padded) + KSL_MULF(t_2_abs, n_1_padded);
  const float moved_0_size = B_1_abs + mt_0_abs, moved_1_size = B_2_abs + mt_1_abs,
      moved_2_size = B_3_abs + mt_2_abs;
  const float Bo_4_size = fabsf(B->xx) + pairs_0_size, Bo_5_size = fabsf(B->yy) + pairs_1_size,
      Bo_6_size = fabsf(B->zz) + pairs_2_size, Bo_7_size = fabsf(B->xy) + pairs_3_size,
      Bo_8_size = fabsf(B->xz) + pairs_4_size, Bo_9_size = fabsf(B->yz) + pairs_5_size;
  const float moved_0_bound = KSL_MULF(1.192093e-07f, moved_0_size + 1.9721523e-31f),
      moved_1_bound = KSL_MULF(1.192093e-07f, moved_1_size + 1.9721523e-31f),
      moved_2_bound = KSL_MULF(1.192093e-07f, moved_2_size + 1.9721523e-31f);
  const float Bo_4_bound = KSL_MULF(4.1723263e-07f, Bo_4_size + 1.9721523e-31f),
      Bo_5_bound = KSL_MULF(4.1723263e-07f, Bo_5_size + 1.9721523e-31f),
      Bo_6_bound = KSL_MULF(4.1723263e-07f, Bo_6_size + 1.9721523e-31f),
      Bo_7_bound = KSL_MULF(3.5762795e-07f, Bo_7_size + 1.9721523e-31f),
      Bo_8_bound = KSL_MULF(3.5762795e-07f, Bo_8_size + 1.9721523e-31f),
      Bo_9_bound = KSL_MULF(3.5762795e-07f, Bo_9_size + 1.9721523e-31f);
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
  Bo_bound->m = 0.0f;
  Bo_bound->h.x = moved_0_bound;
  Bo_bound->h.y = moved_1_bound;
  Bo_bound->h.z = moved_2_bound;
  Bo_bound->xx = Bo_4_bound;
  Bo_bound->yy = Bo_5_bound;
  Bo_bound->zz = Bo_6_bound;
  Bo_bound->xy = Bo_7_bound;
  Bo_bound->xz = Bo_8_bound;
  Bo_bound->yz = Bo_9_bound;
}

/* Bo = [Ad]*(D) B [Ad]^-1(D): B, given in the frame at D, in the reference frame; |error of Bo|
     <= Bo_bound unless inf or NaN.
   D: displacement [R | t], R rotation, t in m; B, Bo, Bo_bound: spatial inertia (m in kg; h = m
     c in kg m; I about the origin, xx, yy, zz, xy, xz, yz in kg m^2).
   114 mul, 135 add, 51 abs. */
static inline void ksl_spatial_inertiaf_transformed_certified(const ksl_SE3f_t *D,
    const ksl_spatial_inertiaf_t *B, ksl_spatial_inertiaf_t *Bo,
    ksl_spatial_inertiaf_t *Bo_bound) {
  const float RI_0a = KSL_MULF(D->m00, B->xx), RI_0b = KSL_MULF(D->m01, B->xy),
      RI_0d = KSL_MULF(D->m02, B->xz), RI_0 = RI_0a + RI_0b + RI_0d;
  const float RI_1a = KSL_MULF(D->m00, B->xy), RI_1b = KSL_MULF(D->m01, B->yy),
      RI_1d = KSL_MULF(D->m02, B->yz), RI_1 = RI_1a + RI_1b + RI_1d;
  const float RI_2a = KSL_MULF(D->m00, B->xz), RI_2b = KSL_MULF(D->m01, B->yz),
      RI_2d = KSL_MULF(D->m02, B->zz), RI_2 = RI_2a + RI_2b + RI_2d;
  const float RI_3a = KSL_MULF(D->m10, B->xx), RI_3b = KSL_MULF(D->m11, B->xy),
      RI_3d = KSL_MULF(D->m12, B->xz), RI_3 = RI_3a + RI_3b + RI_3d;
  const float RI_4a = KSL_MULF(D->m10, B->xy), RI_4b = KSL_MULF(D->m11, B->yy),
      RI_4d = KSL_MULF(D->m12, B->yz), RI_4 = RI_4a + RI_4b + RI_4d;
  const float RI_5a = KSL_MULF(D->m10, B->xz), RI_5b = KSL_MULF(D->m11, B->yz),
      RI_5d = KSL_MULF(D->m12, B->zz), RI_5 = RI_5a + RI_5b + RI_5d;
  const float RI_6a = KSL_MULF(D->m20, B->xx), RI_6b = KSL_MULF(D->m21, B->xy),
      RI_6d = KSL_MULF(D->m22, B->xz), RI_6 = RI_6a + RI_6b + RI_6d;
  const float RI_7a = KSL_MULF(D->m20, B->xy), RI_7b = KSL_MULF(D->m21, B->yy),
      RI_7d = KSL_MULF(D->m22, B->yz), RI_7 = RI_7a + RI_7b + RI_7d;
  const float RI_8a = KSL_MULF(D->m20, B->xz), RI_8b = KSL_MULF(D->m21, B->yz),
      RI_8d = KSL_MULF(D->m22, B->zz), RI_8 = RI_8a + RI_8b + RI_8d;
  const float turned_1a = KSL_MULF(D->m00, B->h.x), turned_1b = KSL_MULF(D->m01, B->h.y),
      turned_1d = KSL_MULF(D->m02, B->h.z), turned_1 = turned_1a + turned_1b + turned_1d;
  const float turned_2a = KSL_MULF(D->m10, B->h.x), turned_2b = KSL_MULF(D->m11, B->h.y),
      turned_2d = KSL_MULF(D->m12, B->h.z), turned_2 = turned_2a + turned_2b + turned_2d;
  const float turned_3a = KSL_MULF(D->m20, B->h.x), turned_3b = KSL_MULF(D->m21, B->h.y),
      turned_3d = KSL_MULF(D->m22, B->h.z), turned_3 = turned_3a + turned_3b + turned_3d;
  const float turned_4 = KSL_MULF(D->m00, RI_0) + KSL_MULF(D->m01, RI_1) + KSL_MULF(D->m02, RI_2);
  const float turned_5 = KSL_MULF(D->m10, RI_3) + KSL_MULF(D->m11, RI_4) + KSL_MULF(D->m12, RI_5);
  const float turned_6 = KSL_MULF(D->m20, RI_6) + KSL_MULF(D->m21, RI_7) + KSL_MULF(D->m22, RI_8),
      turned_7 = KSL_MULF(D->m10, RI_0) + KSL_MULF(D->m11, RI_1) + KSL_MULF(D->m12, RI_2),
      turned_8 = KSL_MULF(D->m20, RI_0) + KSL_MULF(D->m21, RI_1) + KSL_MULF(D->m22, RI_2),
      turned_9 = KSL_MULF(D->m20, RI_3) + KSL_MULF(D->m21, RI_4) + KSL_MULF(D->m22, RI_5);
  const float mt_0 = KSL_MULF(D->m03, B->m), mt_1 = KSL_MULF(D->m13, B->m),
      mt_2 = KSL_MULF(D->m23, B->m);
  const float half_0 = KSL_MULF(0.5f, mt_0);
  const float half_1 = KSL_MULF(0.5f, mt_1);
  const float half_2 = KSL_MULF(0.5f, mt_2);
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
  const float RI_0_size = fabsf(RI_0a) + fabsf(RI_0b) + fabsf(RI_0d),
      RI_1_size = fabsf(RI_1a) + fabsf(RI_1b) + fabsf(RI_1d),
      RI_2_size = fabsf(RI_2a) + fabsf(RI_2b) + fabsf(RI_2d),
      RI_3_size = fabsf(RI_3a) + fabsf(RI_3b) + fabsf(RI_3d),
      RI_4_size = fabsf(RI_4a) + fabsf(RI_4b) + fabsf(RI_4d),
      RI_5_size = fabsf(RI_5a) + fabsf(RI_5b) + fabsf(RI_5d),
      RI_6_size = fabsf(RI_6a) + fabsf(RI_6b) + fabsf(RI_6d),
      RI_7_size = fabsf(RI_7a) + fabsf(RI_7b) + fabsf(RI_7d),
      RI_8_size = fabsf(RI_8a) + fabsf(RI_8b) + fabsf(RI_8d);
  const float turned_1_size = fabsf(turned_1a) + fabsf(turned_1b) + fabsf(turned_1d),
      turned_2_size = fabsf(turned_2a) + fabsf(turned_2b) + fabsf(turned_2d),
      turned_3_size = fabsf(turned_3a) + fabsf(turned_3b) + fabsf(turned_3d);
  const float RI_0_padded = RI_0_size + 1.9721523e-31f, RI_1_padded = RI_1_size + 1.9721523e-31f,
      RI_2_padded = RI_2_size + 1.9721523e-31f;
  const float turned_4_size = KSL_MULF(fabsf(D->m00), RI_0_padded)
          + KSL_MULF(fabsf(D->m01), RI_1_padded) + KSL_MULF(fabsf(D->m02), RI_2_padded);
  const float RI_3_padded = RI_3_size + 1.9721523e-31f;
  const float D_10_abs = fabsf(D->m10);
  const float RI_4_padded = RI_4_size + 1.9721523e-31f;
  const float D_11_abs = fabsf(D->m11);
  const float RI_5_padded = RI_5_size + 1.9721523e-31f;
  const float D_12_abs = fabsf(D->m12),
      turned_5_size = KSL_MULF(D_10_abs, RI_3_padded) + KSL_MULF(D_11_abs, RI_4_padded)
          + KSL_MULF(D_12_abs, RI_5_padded);
  const float D_20_abs = fabsf(D->m20), D_21_abs = fabsf(D->m21), D_22_abs = fabsf(D->m22),
      turned_6c_size = KSL_MULF(D_20_abs, RI_6_size + 1.9721523e-31f)
          + KSL_MULF(D_21_abs, RI_7_size + 1.9721523e-31f),
      turned_6_size = turned_6c_size + KSL_MULF(D_22_abs, RI_8_size + 1.9721523e-31f);
  const float turned_7_size = KSL_MULF(D_10_abs, RI_0_padded) + KSL_MULF(D_11_abs, RI_1_padded)
          + KSL_MULF(D_12_abs, RI_2_padded),
      turned_8_size = KSL_MULF(D_20_abs, RI_0_padded) + KSL_MULF(D_21_abs, RI_1_padded)
          + KSL_MULF(D_22_abs, RI_2_padded),
      turned_9_size = KSL_MULF(D_20_abs, RI_3_padded) + KSL_MULF(D_21_abs, RI_4_padded)
          + KSL_MULF(D_22_abs, RI_5_padded);
  const float mt_0_abs = fabsf(mt_0);
  const float half_0_size = KSL_MULF(0.5f, mt_0_abs + 1.9721523e-31f);
  const float mt_1_abs = fabsf(mt_1);
  const float half_1_size = KSL_MULF(0.5f, mt_1_abs + 1.9721523e-31f);
  const float mt_2_abs = fabsf(mt_2);
  const float half_2_size = KSL_MULF(0.5f, mt_2_abs + 1.9721523e-31f);
  const float n_0_size = turned_1_size + half_0_size, n_1_size = turned_2_size + half_1_size,
      n_2_size = turned_3_size + half_2_size;
  const float n_0_padded = n_0_size + 1.9721523e-31f;
  const float D_03_abs = fabsf(D->m03), tn0_size = KSL_MULF(D_03_abs, n_0_padded);
  const float n_1_padded = n_1_size + 1.9721523e-31f;
  const float D_13_abs = fabsf(D->m13), tn1_size = KSL_MULF(D_13_abs, n_1_padded);
  const float n_2_padded = n_2_size + 1.9721523e-31f;
  const float D_23_abs = fabsf(D->m23), tn2_size = KSL_MULF(D_23_abs, n_2_padded);
  const float own_0_size = KSL_MULF(2.0f, tn0_size + 1.9721523e-31f),
      own_1_size = KSL_MULF(2.0f, tn1_size + 1.9721523e-31f),
      own_2_size = KSL_MULF(2.0f, tn2_size + 1.9721523e-31f);
  const float pairs_0_size = own_1_size + own_2_size, pairs_1_size = own_0_size + own_2_size,
      pairs_2_size = own_0_size + own_1_size,
      pairs_3_size = KSL_MULF(D_03_abs, n_1_padded) + KSL_MULF(D_13_abs, n_0_padded),
      pairs_4_size = KSL_MULF(D_03_abs, n_2_padded) + KSL_MULF(D_23_abs, n_0_padded),
      pairs_5_size = KSL_MULF(D_13_abs, n_2_padded) + KSL_MULF(D_23_abs, n_1_padded);
  const float moved_0_size = turned_1_size + mt_0_abs, moved_1_size = turned_2_size + mt_1_abs,
      moved_2_size = turned_3_size + mt_2_abs;
  const float Bo_4_size = turned_4_size + pairs_0_size, Bo_5_size = turned_5_size + pairs_1_size,
      Bo_6_size = turned_6_size + pairs_2_size, Bo_7_size = turned_7_size + pairs_3_size,
      Bo_8_size = turned_8_size + pairs_4_size, Bo_9_size = turned_9_size + pairs_5_size;
  const float moved_0_bound = KSL_MULF(2.3841864e-07f, moved_0_size + 1.9721523e-31f),
      moved_1_bound = KSL_MULF(2.3841864e-07f, moved_1_size + 1.9721523e-31f),
      moved_2_bound = KSL_MULF(2.3841864e-07f, moved_2_size + 1.9721523e-31f);
  const float Bo_4_bound = KSL_MULF(4.7683733e-07f, Bo_4_size + 1.9721523e-31f),
      Bo_5_bound = KSL_MULF(4.7683733e-07f, Bo_5_size + 1.9721523e-31f),
      Bo_6_bound = KSL_MULF(4.7683733e-07f, Bo_6_size + 1.9721523e-31f),
      Bo_7_bound = KSL_MULF(4.1723263e-07f, Bo_7_size + 1.9721523e-31f),
      Bo_8_bound = KSL_MULF(4.1723263e-07f, Bo_8_size + 1.9721523e-31f),
      Bo_9_bound = KSL_MULF(4.1723263e-07f, Bo_9_size + 1.9721523e-31f);
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
  Bo_bound->m = 0.0f;
  Bo_bound->h.x = moved_0_bound;
  Bo_bound->h.y = moved_1_bound;
  Bo_bound->h.z = moved_2_bound;
  Bo_bound->xx = Bo_4_bound;
  Bo_bound->yy = Bo_5_bound;
  Bo_bound->zz = Bo_6_bound;
  Bo_bound->xy = Bo_7_bound;
  Bo_bound->xz = Bo_8_bound;
  Bo_bound->yz = Bo_9_bound;
}

#endif
