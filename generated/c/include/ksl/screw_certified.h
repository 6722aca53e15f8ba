/* Made by `coscrew generate`; changes are overwritten. */
/* SPDX-License-Identifier: MIT */
/* coscrew 0.2.0.  Copyright (c) 2026 The coscrew authors. */
/* Screws: twists, spatial velocities and accelerations, s = (v; ω).
   Certified tier: plain results, and bounds on their errors that always hold. */
#ifndef KSL_SCREW_CERTIFIED_H
#define KSL_SCREW_CERTIFIED_H

#include "ksl_types.h"

/* self = a self; |error of self| <= self_bound unless inf or NaN.
   self, self_bound: screw (v in m/s; ω in rad/s); a: number.
   12 mul, 6 add, 6 abs. */
static inline void ksl_screw_scale_certified(ksl_screw_t *self, const double a,
    ksl_screw_t *self_bound) {
  const double self_0_new = KSL_MUL(self->m0, a), self_1_new = KSL_MUL(self->m1, a),
      self_2_new = KSL_MUL(self->m2, a), self_3_new = KSL_MUL(self->m3, a),
      self_4_new = KSL_MUL(self->m4, a), self_5_new = KSL_MUL(self->m5, a);
  const double self_0_new_bound = KSL_MUL(1.1102230246251568e-16, fabs(self_0_new)
          + 2.004168360008973e-292),
      self_1_new_bound = KSL_MUL(1.1102230246251568e-16, fabs(self_1_new) + 2.004168360008973e-292),
      self_2_new_bound = KSL_MUL(1.1102230246251568e-16, fabs(self_2_new) + 2.004168360008973e-292),
      self_3_new_bound = KSL_MUL(1.1102230246251568e-16, fabs(self_3_new) + 2.004168360008973e-292),
      self_4_new_bound = KSL_MUL(1.1102230246251568e-16, fabs(self_4_new) + 2.004168360008973e-292),
      self_5_new_bound = KSL_MUL(1.1102230246251568e-16, fabs(self_5_new) + 2.004168360008973e-292);
  self->m0 = self_0_new;
  self->m1 = self_1_new;
  self->m2 = self_2_new;
  self->m3 = self_3_new;
  self->m4 = self_4_new;
  self->m5 = self_5_new;
  self_bound->m0 = self_0_new_bound;
  self_bound->m1 = self_1_new_bound;
  self_bound->m2 = self_2_new_bound;
  self_bound->m3 = self_3_new_bound;
  self_bound->m4 = self_4_new_bound;
  self_bound->m5 = self_5_new_bound;
}

/* y = a x + y; |error of y| <= y_bound unless inf or NaN.
   a: number; x, y, y_bound: screw (v in m/s; ω in rad/s).
   12 mul, 18 add, 12 abs. */
static inline void ksl_axpy_ss_certified(const double a, const ksl_screw_t *x, ksl_screw_t *y,
    ksl_screw_t *y_bound) {
  const double y_0_new_a = KSL_MUL(a, x->m0), y_0_new = y_0_new_a + y->m0;
  const double y_1_new_a = KSL_MUL(a, x->m1), y_1_new = y_1_new_a + y->m1;
  const double y_2_new_a = KSL_MUL(a, x->m2), y_2_new = y_2_new_a + y->m2;
  const double y_3_new_a = KSL_MUL(a, x->m3), y_3_new = y_3_new_a + y->m3;
  const double y_4_new_a = KSL_MUL(a, x->m4), y_4_new = y_4_new_a + y->m4;
  const double y_5_new_a = KSL_MUL(a, x->m5), y_5_new = y_5_new_a + y->m5;
  const double y_0_new_size = fabs(y_0_new_a) + fabs(y->m0),
      y_1_new_size = fabs(y_1_new_a) + fabs(y->m1), y_2_new_size = fabs(y_2_new_a) + fabs(y->m2),
      y_3_new_size = fabs(y_3_new_a) + fabs(y->m3), y_4_new_size = fabs(y_4_new_a) + fabs(y->m4),
      y_5_new_size = fabs(y_5_new_a) + fabs(y->m5);
  const double y_0_new_bound = KSL_MUL(2.2204460492503136e-16, y_0_new_size
          + 2.004168360008973e-292),
      y_1_new_bound = KSL_MUL(2.2204460492503136e-16, y_1_new_size + 2.004168360008973e-292),
      y_2_new_bound = KSL_MUL(2.2204460492503136e-16, y_2_new_size + 2.004168360008973e-292),
      y_3_new_bound = KSL_MUL(2.2204460492503136e-16, y_3_new_size + 2.004168360008973e-292),
      y_4_new_bound = KSL_MUL(2.2204460492503136e-16, y_4_new_size + 2.004168360008973e-292),
      y_5_new_bound = KSL_MUL(2.2204460492503136e-16, y_5_new_size + 2.004168360008973e-292);
  y->m0 = y_0_new;
  y->m1 = y_1_new;
  y->m2 = y_2_new;
  y->m3 = y_3_new;
  y->m4 = y_4_new;
  y->m5 = y_5_new;
  y_bound->m0 = y_0_new_bound;
  y_bound->m1 = y_1_new_bound;
  y_bound->m2 = y_2_new_bound;
  y_bound->m3 = y_3_new_bound;
  y_bound->m4 = y_4_new_bound;
  y_bound->m5 = y_5_new_bound;
}

/* y = x + y; |error of y| <= y_bound unless inf or NaN.
   x, y, y_bound: screw (v in m/s; ω in rad/s).
   6 mul, 6 add, 6 abs. */
static inline void ksl_xpy_ss_certified(const ksl_screw_t *x, ksl_screw_t *y,
    ksl_screw_t *y_bound) {
  const double y_0_new = x->m0 + y->m0, y_1_new = x->m1 + y->m1, y_2_new = x->m2 + y->m2,
      y_3_new = x->m3 + y->m3, y_4_new = x->m4 + y->m4, y_5_new = x->m5 + y->m5;
  const double y_0_new_bound = KSL_MUL(1.1102230246251568e-16, fabs(y_0_new)),
      y_1_new_bound = KSL_MUL(1.1102230246251568e-16, fabs(y_1_new)),
      y_2_new_bound = KSL_MUL(1.1102230246251568e-16, fabs(y_2_new)),
      y_3_new_bound = KSL_MUL(1.1102230246251568e-16, fabs(y_3_new)),
      y_4_new_bound = KSL_MUL(1.1102230246251568e-16, fabs(y_4_new)),
      y_5_new_bound = KSL_MUL(1.1102230246251568e-16, fabs(y_5_new));
  y->m0 = y_0_new;
  y->m1 = y_1_new;
  y->m2 = y_2_new;
  y->m3 = y_3_new;
  y->m4 = y_4_new;
  y->m5 = y_5_new;
  y_bound->m0 = y_0_new_bound;
  y_bound->m1 = y_1_new_bound;
  y_bound->m2 = y_2_new_bound;
  y_bound->m3 = y_3_new_bound;
  y_bound->m4 = y_4_new_bound;
  y_bound->m5 = y_5_new_bound;
}

/* y = -x + y; |error of y| <= y_bound unless inf or NaN.
   x, y, y_bound: screw (v in m/s; ω in rad/s).
   6 mul, 6 add, 6 abs. */
static inline void ksl_nxpy_ss_certified(const ksl_screw_t *x, ksl_screw_t *y,
    ksl_screw_t *y_bound) {
  const double y_0_new = y->m0 - x->m0, y_1_new = y->m1 - x->m1, y_2_new = y->m2 - x->m2,
      y_3_new = y->m3 - x->m3, y_4_new = y->m4 - x->m4, y_5_new = y->m5 - x->m5;
  const double y_0_new_bound = KSL_MUL(1.1102230246251568e-16, fabs(y_0_new)),
      y_1_new_bound = KSL_MUL(1.1102230246251568e-16, fabs(y_1_new)),
      y_2_new_bound = KSL_MUL(1.1102230246251568e-16, fabs(y_2_new)),
      y_3_new_bound = KSL_MUL(1.1102230246251568e-16, fabs(y_3_new)),
      y_4_new_bound = KSL_MUL(1.1102230246251568e-16, fabs(y_4_new)),
      y_5_new_bound = KSL_MUL(1.1102230246251568e-16, fabs(y_5_new));
  y->m0 = y_0_new;
  y->m1 = y_1_new;
  y->m2 = y_2_new;
  y->m3 = y_3_new;
  y->m4 = y_4_new;
  y->m5 = y_5_new;
  y_bound->m0 = y_0_new_bound;
  y_bound->m1 = y_1_new_bound;
  y_bound->m2 = y_2_new_bound;
  y_bound->m3 = y_3_new_bound;
  y_bound->m4 = y_4_new_bound;
  y_bound->m5 = y_5_new_bound;
}

/* so = a si; |error of so| <= so_bound unless inf or NaN.
   a: number; si, so, so_bound: screw (v in m/s; ω in rad/s).
   12 mul, 6 add, 6 abs. */
static inline void ksl_product_as_certified(const double a, const ksl_screw_t *si,
    ksl_screw_t *so, ksl_screw_t *so_bound) {
  const double so_0 = KSL_MUL(a, si->m0), so_1 = KSL_MUL(a, si->m1), so_2 = KSL_MUL(a, si->m2),
      so_3 = KSL_MUL(a, si->m3), so_4 = KSL_MUL(a, si->m4), so_5 = KSL_MUL(a, si->m5);
  const double so_0_bound = KSL_MUL(1.1102230246251568e-16, fabs(so_0) + 2.004168360008973e-292),
      so_1_bound = KSL_MUL(1.1102230246251568e-16, fabs(so_1) + 2.004168360008973e-292),
      so_2_bound = KSL_MUL(1.1102230246251568e-16, fabs(so_2) + 2.004168360008973e-292),
      so_3_bound = KSL_MUL(1.1102230246251568e-16, fabs(so_3) + 2.004168360008973e-292),
      so_4_bound = KSL_MUL(1.1102230246251568e-16, fabs(so_4) + 2.004168360008973e-292),
      so_5_bound = KSL_MUL(1.1102230246251568e-16, fabs(so_5) + 2.004168360008973e-292);
  so->m0 = so_0;
  so->m1 = so_1;
  so->m2 = so_2;
  so->m3 = so_3;
  so->m4 = so_4;
  so->m5 = so_5;
  so_bound->m0 = so_0_bound;
  so_bound->m1 = so_1_bound;
  so_bound->m2 = so_2_bound;
  so_bound->m3 = so_3_bound;
  so_bound->m4 = so_4_bound;
  so_bound->m5 = so_5_bound;
}

/* so = s1 + s2; |error of so| <= so_bound unless inf or NaN.
   s1, s2, so, so_bound: screw (v in m/s; ω in rad/s).
   6 mul, 6 add, 6 abs. */
static inline void ksl_add_ss_certified(const ksl_screw_t *s1, const ksl_screw_t *s2,
    ksl_screw_t *so, ksl_screw_t *so_bound) {
  const double so_0 = s1->m0 + s2->m0, so_1 = s1->m1 + s2->m1, so_2 = s1->m2 + s2->m2,
      so_3 = s1->m3 + s2->m3, so_4 = s1->m4 + s2->m4, so_5 = s1->m5 + s2->m5;
  const double so_0_bound = KSL_MUL(1.1102230246251568e-16, fabs(so_0)),
      so_1_bound = KSL_MUL(1.1102230246251568e-16, fabs(so_1)),
      so_2_bound = KSL_MUL(1.1102230246251568e-16, fabs(so_2)),
      so_3_bound = KSL_MUL(1.1102230246251568e-16, fabs(so_3)),
      so_4_bound = KSL_MUL(1.1102230246251568e-16, fabs(so_4)),
      so_5_bound = KSL_MUL(1.1102230246251568e-16, fabs(so_5));
  so->m0 = so_0;
  so->m1 = so_1;
  so->m2 = so_2;
  so->m3 = so_3;
  so->m4 = so_4;
  so->m5 = so_5;
  so_bound->m0 = so_0_bound;
  so_bound->m1 = so_1_bound;
  so_bound->m2 = so_2_bound;
  so_bound->m3 = so_3_bound;
  so_bound->m4 = so_4_bound;
  so_bound->m5 = so_5_bound;
}

/* so = s1 - s2; |error of so| <= so_bound unless inf or NaN.
   s1, s2, so, so_bound: screw (v in m/s; ω in rad/s).
   6 mul, 6 add, 6 abs. */
static inline void ksl_subtract_ss_certified(const ksl_screw_t *s1, const ksl_screw_t *s2,
    ksl_screw_t *so, ksl_screw_t *so_bound) {
  const double so_0 = s1->m0 - s2->m0, so_1 = s1->m1 - s2->m1, so_2 = s1->m2 - s2->m2,
      so_3 = s1->m3 - s2->m3, so_4 = s1->m4 - s2->m4, so_5 = s1->m5 - s2->m5;
  const double so_0_bound = KSL_MUL(1.1102230246251568e-16, fabs(so_0)),
      so_1_bound = KSL_MUL(1.1102230246251568e-16, fabs(so_1)),
      so_2_bound = KSL_MUL(1.1102230246251568e-16, fabs(so_2)),
      so_3_bound = KSL_MUL(1.1102230246251568e-16, fabs(so_3)),
      so_4_bound = KSL_MUL(1.1102230246251568e-16, fabs(so_4)),
      so_5_bound = KSL_MUL(1.1102230246251568e-16, fabs(so_5));
  so->m0 = so_0;
  so->m1 = so_1;
  so->m2 = so_2;
  so->m3 = so_3;
  so->m4 = so_4;
  so->m5 = so_5;
  so_bound->m0 = so_0_bound;
  so_bound->m1 = so_1_bound;
  so_bound->m2 = so_2_bound;
  so_bound->m3 = so_3_bound;
  so_bound->m4 = so_4_bound;
  so_bound->m5 = so_5_bound;
}

/* so = (s1.lin + s2.lin ; s1.ang); |error of so| <= so_bound unless inf or NaN.
   s1, s2, so, so_bound: screw (v in m/s; ω in rad/s).
   3 mul, 3 add, 3 abs. */
static inline void ksl_add_sst_certified(const ksl_screw_t *s1, const ksl_screw_t *s2,
    ksl_screw_t *so, ksl_screw_t *so_bound) {
  const double so_0 = s1->m0 + s2->m0, so_1 = s1->m1 + s2->m1, so_2 = s1->m2 + s2->m2;
  const double so_0_bound = KSL_MUL(1.1102230246251568e-16, fabs(so_0)),
      so_1_bound = KSL_MUL(1.1102230246251568e-16, fabs(so_1)),
      so_2_bound = KSL_MUL(1.1102230246251568e-16, fabs(so_2));
  const double s1_m3 = s1->m3;
  const double s1_m4 = s1->m4;
  const double s1_m5 = s1->m5;
  so->m0 = so_0;
  so->m1 = so_1;
  so->m2 = so_2;
  so->m3 = s1_m3;
  so->m4 = s1_m4;
  so->m5 = s1_m5;
  so_bound->m0 = so_0_bound;
  so_bound->m1 = so_1_bound;
  so_bound->m2 = so_2_bound;
  so_bound->m3 = 0.0;
  so_bound->m4 = 0.0;
  so_bound->m5 = 0.0;
}

/* so = [Ad](t) si; |error of so| <= so_bound unless inf or NaN.
   t: vector; si, so, so_bound: screw (v in m/s; ω in rad/s).
   9 mul, 15 add, 9 abs. */
static inline void ksl_product_Adts_certified(const ksl_vec3_t *t, const ksl_screw_t *si,
    ksl_screw_t *so, ksl_screw_t *so_bound) {
  const double so_0a = KSL_MUL(t->y, si->m5), so_0b = KSL_MUL(t->z, si->m4),
      so_0 = so_0a - so_0b + si->m0;
  const double so_1a = KSL_MUL(t->z, si->m3), so_1b = KSL_MUL(t->x, si->m5),
      so_1 = so_1a - so_1b + si->m1;
  const double so_2a = KSL_MUL(t->x, si->m4), so_2b = KSL_MUL(t->y, si->m3),
      so_2 = so_2a - so_2b + si->m2;
  const double so_0_size = fabs(so_0a) + fabs(so_0b) + fabs(si->m0),
      so_1_size = fabs(so_1a) + fabs(so_1b) + fabs(si->m1),
      so_2_size = fabs(so_2a) + fabs(so_2b) + fabs(si->m2);
  const double so_0_bound = KSL_MUL(3.3306690738754706e-16, so_0_size + 2.004168360008973e-292),
      so_1_bound = KSL_MUL(3.3306690738754706e-16, so_1_size + 2.004168360008973e-292),
      so_2_bound = KSL_MUL(3.3306690738754706e-16, so_2_size + 2.004168360008973e-292);
  const double si_m3 = si->m3;
  const double si_m4 = si->m4;
  const double si_m5 = si->m5;
  so->m0 = so_0;
  so->m1 = so_1;
  so->m2 = so_2;
  so->m3 = si_m3;
  so->m4 = si_m4;
  so->m5 = si_m5;
  so_bound->m0 = so_0_bound;
  so_bound->m1 = so_1_bound;
  so_bound->m2 = so_2_bound;
  so_bound->m3 = 0.0;
  so_bound->m4 = 0.0;
  so_bound->m5 = 0.0;
}

/* so = [Ad](t)^-1 si; |error of so| <= so_bound unless inf or NaN.
   t: vector; si, so, so_bound: screw (v in m/s; ω in rad/s).
   9 mul, 15 add, 9 abs. */
static inline void ksl_product_Adtinvs_certified(const ksl_vec3_t *t, const ksl_screw_t *si,
    ksl_screw_t *so, ksl_screw_t *so_bound) {
  const double so_0a = KSL_MUL(t->z, si->m4), so_0b = KSL_MUL(t->y, si->m5),
      so_0 = so_0a - so_0b + si->m0;
  const double so_1a = KSL_MUL(t->x, si->m5), so_1b = KSL_MUL(t->z, si->m3),
      so_1 = so_1a - so_1b + si->m1;
  const double so_2a = KSL_MUL(t->y, si->m3), so_2b = KSL_MUL(t->x, si->m4),
      so_2 = so_2a - so_2b + si->m2;
  const double so_0_size = fabs(so_0a) + fabs(so_0b) + fabs(si->m0),
      so_1_size = fabs(so_1a) + fabs(so_1b) + fabs(si->m1),
      so_2_size = fabs(so_2a) + fabs(so_2b) + fabs(si->m2);
  const double so_0_bound = KSL_MUL(3.3306690738754706e-16, so_0_size + 2.004168360008973e-292),
      so_1_bound = KSL_MUL(3.3306690738754706e-16, so_1_size + 2.004168360008973e-292),
      so_2_bound = KSL_MUL(3.3306690738754706e-16, so_2_size + 2.004168360008973e-292);
  const double si_m3 = si->m3;
  const double si_m4 = si->m4;
  const double si_m5 = si->m5;
  so->m0 = so_0;
  so->m1 = so_1;
  so->m2 = so_2;
  so->m3 = si_m3;
  so->m4 = si_m4;
  so->m5 = si_m5;
  so_bound->m0 = so_0_bound;
  so_bound->m1 = so_1_bound;
  so_bound->m2 = so_2_bound;
  so_bound->m3 = 0.0;
  so_bound->m4 = 0.0;
  so_bound->m5 = 0.0;
}

/* so = [Ad](t) (-si); |error of so| <= so_bound unless inf or NaN.
   t: vector; si, so, so_bound: screw (v in m/s; ω in rad/s).
   9 mul, 15 add, 3 neg, 9 abs. */
static inline void ksl_product_Adtsinv_certified(const ksl_vec3_t *t, const ksl_screw_t *si,
    ksl_screw_t *so, ksl_screw_t *so_bound) {
  const double so_0a = KSL_MUL(t->z, si->m4), so_0b = KSL_MUL(t->y, si->m5),
      so_0 = so_0a - so_0b - si->m0;
  const double so_1a = KSL_MUL(t->x, si->m5), so_1b = KSL_MUL(t->z, si->m3),
      so_1 = so_1a - so_1b - si->m1;
  const double so_2a = KSL_MUL(t->y, si->m3), so_2b = KSL_MUL(t->x, si->m4),
      so_2 = so_2a - so_2b - si->m2;
  const double so_3 = -si->m3, so_4 = -si->m4, so_5 = -si->m5;
  const double so_0_size = fabs(so_0a) + fabs(so_0b) + fabs(si->m0),
      so_1_size = fabs(so_1a) + fabs(so_1b) + fabs(si->m1),
      so_2_size = fabs(so_2a) + fabs(so_2b) + fabs(si->m2);
  const double so_0_bound = KSL_MUL(3.3306690738754706e-16, so_0_size + 2.004168360008973e-292),
      so_1_bound = KSL_MUL(3.3306690738754706e-16, so_1_size + 2.004168360008973e-292),
      so_2_bound = KSL_MUL(3.3306690738754706e-16, so_2_size + 2.004168360008973e-292);
  so->m0 = so_0;
  so->m1 = so_1;
  so->m2 = so_2;
  so->m3 = so_3;
  so->m4 = so_4;
  so->m5 = so_5;
  so_bound->m0 = so_0_bound;
  so_bound->m1 = so_1_bound;
  so_bound->m2 = so_2_bound;
  so_bound->m3 = 0.0;
  so_bound->m4 = 0.0;
  so_bound->m5 = 0.0;
}

/* so = [Ad](R) si; |error of so| <= so_bound unless inf or NaN.
   R: rotation or other 3×3 matrix; si, so, so_bound: screw (v in m/s; ω in rad/s).
   24 mul, 30 add, 18 abs. */
static inline void ksl_product_Adrs_certified(const ksl_mat3x3_t *R, const ksl_screw_t *si,
    ksl_screw_t *so, ksl_screw_t *so_bound) {
  const double so_0a = KSL_MUL(R->m00, si->m0), so_0b = KSL_MUL(R->m01, si->m1),
      so_0d = KSL_MUL(R->m02, si->m2), so_0 = so_0a + so_0b + so_0d;
  const double so_1a = KSL_MUL(R->m10, si->m0), so_1b = KSL_MUL(R->m11, si->m1),
      so_1d = KSL_MUL(R->m12, si->m2), so_1 = so_1a + so_1b + so_1d;
  const double so_2a = KSL_MUL(R->m20, si->m0), so_2b = KSL_MUL(R->m21, si->m1),
      so_2d = KSL_MUL(R->m22, si->m2), so_2 = so_2a + so_2b + so_2d;
  const double so_3a = KSL_MUL(R->m00, si->m3), so_3b = KSL_MUL(R->m01, si->m4),
      so_3d = KSL_MUL(R->m02, si->m5), so_3 = so_3a + so_3b + so_3d;
  const double so_4a = KSL_MUL(R->m10, si->m3), so_4b = KSL_MUL(R->m11, si->m4),
      so_4d = KSL_MUL(R->m12, si->m5), so_4 = so_4a + so_4b + so_4d;
  const double so_5a = KSL_MUL(R->m20, si->m3), so_5b = KSL_MUL(R->m21, si->m4),
      so_5d = KSL_MUL(R->m22, si->m5), so_5 = so_5a + so_5b + so_5d;
  const double so_0_size = fabs(so_0a) + fabs(so_0b) + fabs(so_0d),
      so_1_size = fabs(so_1a) + fabs(so_1b) + fabs(so_1d),
      so_2_size = fabs(so_2a) + fabs(so_2b) + fabs(so_2d),
      so_3_size = fabs(so_3a) + fabs(so_3b) + fabs(so_3d),
      so_4_size = fabs(so_4a) + fabs(so_4b) + fabs(so_4d),
      so_5_size = fabs(so_5a) + fabs(so_5b) + fabs(so_5d);
  const double so_0_bound = KSL_MUL(3.3306690738754706e-16, so_0_size + 2.004168360008973e-292),
      so_1_bound = KSL_MUL(3.3306690738754706e-16, so_1_size + 2.004168360008973e-292),
      so_2_bound = KSL_MUL(3.3306690738754706e-16, so_2_size + 2.004168360008973e-292),
      so_3_bound = KSL_MUL(3.3306690738754706e-16, so_3_size + 2.004168360008973e-292),
      so_4_bound = KSL_MUL(3.3306690738754706e-16, so_4_size + 2.004168360008973e-292),
      so_5_bound = KSL_MUL(3.3306690738754706e-16, so_5_size + 2.004168360008973e-292);
  so->m0 = so_0;
  so->m1 = so_1;
  so->m2 = so_2;
  so->m3 = so_3;
  so->m4 = so_4;
  so->m5 = so_5;
  so_bound->m0 = so_0_bound;
  so_bound->m1 = so_1_bound;
  so_bound->m2 = so_2_bound;
  so_bound->m3 = so_3_bound;
  so_bound->m4 = so_4_bound;
  so_bound->m5 = so_5_bound;
}

/* so = [Ad](R)^-1 si; |error of so| <= so_bound unless inf or NaN.
   R: rotation or other 3×3 matrix; si, so, so_bound: screw (v in m/s; ω in rad/s).
   24 mul, 30 add, 18 abs. */
static inline void ksl_product_Adrinvs_certified(const ksl_mat3x3_t *R, const ksl_screw_t *si,
    ksl_screw_t *so, ksl_screw_t *so_bound) {
  const double so_0a = KSL_MUL(R->m00, si->m0), so_0b = KSL_MUL(R->m10, si->m1),
      so_0d = KSL_MUL(R->m20, si->m2), so_0 = so_0a + so_0b + so_0d;
  const double so_1a = KSL_MUL(R->m01, si->m0), so_1b = KSL_MUL(R->m11, si->m1),
      so_1d = KSL_MUL(R->m21, si->m2), so_1 = so_1a + so_1b + so_1d;
  const double so_2a = KSL_MUL(R->m02, si->m0), so_2b = KSL_MUL(R->m12, si->m1),
      so_2d = KSL_MUL(R->m22, si->m2), so_2 = so_2a + so_2b + so_2d;
  const double so_3a = KSL_MUL(R->m00, si->m3), so_3b = KSL_MUL(R->m10, si->m4),
      so_3d = KSL_MUL(R->m20, si->m5), so_3 = so_3a + so_3b + so_3d;
  const double so_4a = KSL_MUL(R->m01, si->m3), so_4b = KSL_MUL(R->m11, si->m4),
      so_4d = KSL_MUL(R->m21, si->m5), so_4 = so_4a + so_4b + so_4d;
  const double so_5a = KSL_MUL(R->m02, si->m3), so_5b = KSL_MUL(R->m12, si->m4),
      so_5d = KSL_MUL(R->m22, si->m5), so_5 = so_5a + so_5b + so_5d;
  const double so_0_size = fabs(so_0a) + fabs(so_0b) + fabs(so_0d),
      so_1_size = fabs(so_1a) + fabs(so_1b) + fabs(so_1d),
      so_2_size = fabs(so_2a) + fabs(so_2b) + fabs(so_2d),
      so_3_size = fabs(so_3a) + fabs(so_3b) + fabs(so_3d),
      so_4_size = fabs(so_4a) + fabs(so_4b) + fabs(so_4d),
      so_5_size = fabs(so_5a) + fabs(so_5b) + fabs(so_5d);
  const double so_0_bound = KSL_MUL(3.3306690738754706e-16, so_0_size + 2.004168360008973e-292),
      so_1_bound = KSL_MUL(3.3306690738754706e-16, so_1_size + 2.004168360008973e-292),
      so_2_bound = KSL_MUL(3.3306690738754706e-16, so_2_size + 2.004168360008973e-292),
      so_3_bound = KSL_MUL(3.3306690738754706e-16, so_3_size + 2.004168360008973e-292),
      so_4_bound = KSL_MUL(3.3306690738754706e-16, so_4_size + 2.004168360008973e-292),
      so_5_bound = KSL_MUL(3.3306690738754706e-16, so_5_size + 2.004168360008973e-292);
  so->m0 = so_0;
  so->m1 = so_1;
  so->m2 = so_2;
  so->m3 = so_3;
  so->m4 = so_4;
  so->m5 = so_5;
  so_bound->m0 = so_0_bound;
  so_bound->m1 = so_1_bound;
  so_bound->m2 = so_2_bound;
  so_bound->m3 = so_3_bound;
  so_bound->m4 = so_4_bound;
  so_bound->m5 = so_5_bound;
}

/* so = [Ad](R) (-si); |error of so| <= so_bound unless inf or NaN.
   R: rotation or other 3×3 matrix; si, so, so_bound: screw (v in m/s; ω in rad/s).
   24 mul, 30 add, 6 neg, 18 abs. */
static inline void ksl_product_Adrsinv_certified(const ksl_mat3x3_t *R, const ksl_screw_t *si,
    ksl_screw_t *so, ksl_screw_t *so_bound) {
  const double so_0a = KSL_MUL(R->m00, si->m0), so_0b = KSL_MUL(R->m01, si->m1),
      so_0d = KSL_MUL(R->m02, si->m2), so_0 = -(so_0a + so_0b + so_0d);
  const double so_1a = KSL_MUL(R->m10, si->m0), so_1b = KSL_MUL(R->m11, si->m1),
      so_1d = KSL_MUL(R->m12, si->m2), so_1 = -(so_1a + so_1b + so_1d);
  const double so_2a = KSL_MUL(R->m20, si->m0), so_2b = KSL_MUL(R->m21, si->m1),
      so_2d = KSL_MUL(R->m22, si->m2), so_2 = -(so_2a + so_2b + so_2d);
  const double so_3a = KSL_MUL(R->m00, si->m3), so_3b = KSL_MUL(R->m01, si->m4),
      so_3d = KSL_MUL(R->m02, si->m5), so_3 = -(so_3a + so_3b + so_3d);
  const double so_4a = KSL_MUL(R->m10, si->m3), so_4b = KSL_MUL(R->m11, si->m4),
      so_4d = KSL_MUL(R->m12, si->m5), so_4 = -(so_4a + so_4b + so_4d);
  const double so_5a = KSL_MUL(R->m20, si->m3), so_5b = KSL_MUL(R->m21, si->m4),
      so_5d = KSL_MUL(R->m22, si->m5), so_5 = -(so_5a + so_5b + so_5d);
  const double so_0e_bound = KSL_MUL(3.3306690738754706e-16, fabs(so_0a) + fabs(so_0b)
          + fabs(so_0d) + 2.004168360008973e-292);
  const double so_1e_bound = KSL_MUL(3.3306690738754706e-16, fabs(so_1a) + fabs(so_1b)
          + fabs(so_1d) + 2.004168360008973e-292);
  const double so_2e_bound = KSL_MUL(3.3306690738754706e-16, fabs(so_2a) + fabs(so_2b)
          + fabs(so_2d) + 2.004168360008973e-292);
  const double so_3e_bound = KSL_MUL(3.3306690738754706e-16, fabs(so_3a) + fabs(so_3b)
          + fabs(so_3d) + 2.004168360008973e-292);
  const double so_4e_bound = KSL_MUL(3.3306690738754706e-16, fabs(so_4a) + fabs(so_4b)
          + fabs(so_4d) + 2.004168360008973e-292);
  const double so_5e_bound = KSL_MUL(3.3306690738754706e-16, fabs(so_5a) + fabs(so_5b)
          + fabs(so_5d) + 2.004168360008973e-292);
  so->m0 = so_0;
  so->m1 = so_1;
  so->m2 = so_2;
  so->m3 = so_3;
  so->m4 = so_4;
  so->m5 = so_5;
  so_bound->m0 = so_0e_bound;
  so_bound->m1 = so_1e_bound;
  so_bound->m2 = so_2e_bound;
  so_bound->m3 = so_3e_bound;
  so_bound->m4 = so_4e_bound;
  so_bound->m5 = so_5e_bound;
}

/* so = [Ad](D) si = [Ad](t) [Ad](R) si; |error of so| <= so_bound unless inf or NaN.
   D: displacement [R | t], R rotation, t in m; si, so, so_bound: screw (v in m/s; ω in rad/s).
   36 mul, 42 add, 21 abs. */
static inline void ksl_product_Ads_certified(const ksl_SE3_t *D, const ksl_screw_t *si,
    ksl_screw_t *so, ksl_screw_t *so_bound) {
  const double w_0a = KSL_MUL(D->m00, si->m0), w_0b = KSL_MUL(D->m01, si->m1),
      w_0d = KSL_MUL(D->m02, si->m2), w_0 = w_0a + w_0b + w_0d;
  const double w_1a = KSL_MUL(D->m10, si->m0), w_1b = KSL_MUL(D->m11, si->m1),
      w_1d = KSL_MUL(D->m12, si->m2), w_1 = w_1a + w_1b + w_1d;
  const double w_2a = KSL_MUL(D->m20, si->m0), w_2b = KSL_MUL(D->m21, si->m1),
      w_2d = KSL_MUL(D->m22, si->m2), w_2 = w_2a + w_2b + w_2d;
  const double w_3a = KSL_MUL(D->m00, si->m3), w_3b = KSL_MUL(D->m01, si->m4),
      w_3d = KSL_MUL(D->m02, si->m5), w_3 = w_3a + w_3b + w_3d;
  const double w_4a = KSL_MUL(D->m10, si->m3), w_4b = KSL_MUL(D->m11, si->m4),
      w_4d = KSL_MUL(D->m12, si->m5), w_4 = w_4a + w_4b + w_4d;
  const double w_5a = KSL_MUL(D->m20, si->m3), w_5b = KSL_MUL(D->m21, si->m4),
      w_5d = KSL_MUL(D->m22, si->m5), w_5 = w_5a + w_5b + w_5d;
  const double so_0 = KSL_MUL(D->m13, w_5) - KSL_MUL(D->m23, w_4) + w_0;
  const double so_1 = KSL_MUL(D->m23, w_3) - KSL_MUL(D->m03, w_5) + w_1;
  const double so_2 = KSL_MUL(D->m03, w_4) - KSL_MUL(D->m13, w_3) + w_2;
  const double w_0_size = fabs(w_0a) + fabs(w_0b) + fabs(w_0d),
      w_1_size = fabs(w_1a) + fabs(w_1b) + fabs(w_1d),
      w_2_size = fabs(w_2a) + fabs(w_2b) + fabs(w_2d),
      w_3_size = fabs(w_3a) + fabs(w_3b) + fabs(w_3d),
      w_4_size = fabs(w_4a) + fabs(w_4b) + fabs(w_4d),
      w_5_size = fabs(w_5a) + fabs(w_5b) + fabs(w_5d);
  const double w_5_padded = w_5_size + 2.004168360008973e-292;
  const double D_13_abs = fabs(D->m13);
  const double w_4_padded = w_4_size + 2.004168360008973e-292;
  const double D_23_abs = fabs(D->m23),
      so_0_size = KSL_MUL(D_13_abs, w_5_padded) + KSL_MUL(D_23_abs, w_4_padded) + w_0_size;
  const double w_3_padded = w_3_size + 2.004168360008973e-292;
  const double D_03_abs = fabs(D->m03),
      so_1_size = KSL_MUL(D_23_abs, w_3_padded) + KSL_MUL(D_03_abs, w_5_padded) + w_1_size;
  const double so_2_size = KSL_MUL(D_03_abs, w_4_padded) + KSL_MUL(D_13_abs, w_3_padded) + w_2_size;
  const double so_0_bound = KSL_MUL(6.661338147750942e-16, so_0_size + 2.004168360008973e-292),
      so_1_bound = KSL_MUL(6.661338147750942e-16, so_1_size + 2.004168360008973e-292),
      so_2_bound = KSL_MUL(6.661338147750942e-16, so_2_size + 2.004168360008973e-292);
  const double w_3_bound = KSL_MUL(3.3306690738754706e-16, w_3_padded),
      w_4_bound = KSL_MUL(3.3306690738754706e-16, w_4_padded),
      w_5_bound = KSL_MUL(3.3306690738754706e-16, w_5_padded);
  so->m0 = so_0;
  so->m1 = so_1;
  so->m2 = so_2;
  so->m3 = w_3;
  so->m4 = w_4;
  so->m5 = w_5;
  so_bound->m0 = so_0_bound;
  so_bound->m1 = so_1_bound;
  so_bound->m2 = so_2_bound;
  so_bound->m3 = w_3_bound;
  so_bound->m4 = w_4_bound;
  so_bound->m5 = w_5_bound;
}

/* so = [Ad](D)^-1 si = [Ad](R^T) [Ad](-t) si; |error of so| <= so_bound unless inf or NaN.
   D: displacement [R | t], R rotation, t in m; si, so, so_bound: screw (v in m/s; ω in rad/s).
   39 mul, 45 add, 27 abs. */
static inline void ksl_product_Adinvs_certified(const ksl_SE3_t *D, const ksl_screw_t *si,
    ksl_screw_t *so, ksl_screw_t *so_bound) {
  const double w_0a = KSL_MUL(D->m23, si->m4), w_0b = KSL_MUL(D->m13, si->m5),
      w_0 = w_0a - w_0b + si->m0;
  const double w_1a = KSL_MUL(D->m03, si->m5), w_1b = KSL_MUL(D->m23, si->m3),
      w_1 = w_1a - w_1b + si->m1;
  const double w_2a = KSL_MUL(D->m13, si->m3), w_2b = KSL_MUL(D->m03, si->m4),
      w_2 = w_2a - w_2b + si->m2;
  const double so_0 = KSL_MUL(D->m00, w_0) + KSL_MUL(D->m10, w_1) + KSL_MUL(D->m20, w_2);
  const double so_1 = KSL_MUL(D->m01, w_0) + KSL_MUL(D->m11, w_1) + KSL_MUL(D->m21, w_2),
      so_2 = KSL_MUL(D->m02, w_0) + KSL_MUL(D->m12, w_1) + KSL_MUL(D->m22, w_2);
  const double so_3a = KSL_MUL(D->m00, si->m3), so_3b = KSL_MUL(D->m10, si->m4),
      so_3d = KSL_MUL(D->m20, si->m5), so_3 = so_3a + so_3b + so_3d;
  const double so_4a = KSL_MUL(D->m01, si->m3), so_4b = KSL_MUL(D->m11, si->m4),
      so_4d = KSL_MUL(D->m21, si->m5), so_4 = so_4a + so_4b + so_4d;
  const double so_5a = KSL_MUL(D->m02, si->m3), so_5b = KSL_MUL(D->m12, si->m4),
      so_5d = KSL_MUL(D->m22, si->m5), so_5 = so_5a + so_5b + so_5d;
  const double w_0_size = fabs(w_0a) + fabs(w_0b) + fabs(si->m0),
      w_1_size = fabs(w_1a) + fabs(w_1b) + fabs(si->m1),
      w_2_size = fabs(w_2a) + fabs(w_2b) + fabs(si->m2);
  const double w_0_padded = w_0_size + 2.004168360008973e-292,
      w_1_padded = w_1_size + 2.004168360008973e-292,
      w_2_padded = w_2_size + 2.004168360008973e-292;
  const double so_0_size = KSL_MUL(fabs(D->m00), w_0_padded) + KSL_MUL(fabs(D->m10), w_1_padded)
          + KSL_MUL(fabs(D->m20), w_2_padded),
      so_1_size = KSL_MUL(fabs(D->m01), w_0_padded) + KSL_MUL(fabs(D->m11), w_1_padded)
          + KSL_MUL(fabs(D->m21), w_2_padded),
      so_2_size = KSL_MUL(fabs(D->m02), w_0_padded) + KSL_MUL(fabs(D->m12), w_1_padded)
          + KSL_MUL(fabs(D->m22), w_2_padded), so_3_size = fabs(so_3a) + fabs(so_3b) + fabs(so_3d),
      so_4_size = fabs(so_4a) + fabs(so_4b) + fabs(so_4d),
      so_5_size = fabs(so_5a) + fabs(so_5b) + fabs(so_5d);
  const double so_0_bound = KSL_MUL(6.661338147750942e-16, so_0_size + 2.004168360008973e-292),
      so_1_bound = KSL_MUL(6.661338147750942e-16, so_1_size + 2.004168360008973e-292),
      so_2_bound = KSL_MUL(6.661338147750942e-16, so_2_size + 2.004168360008973e-292),
      so_3_bound = KSL_MUL(3.3306690738754706e-16, so_3_size + 2.004168360008973e-292),
      so_4_bound = KSL_MUL(3.3306690738754706e-16, so_4_size + 2.004168360008973e-292),
      so_5_bound = KSL_MUL(3.3306690738754706e-16, so_5_size + 2.004168360008973e-292);
  so->m0 = so_0;
  so->m1 = so_1;
  so->m2 = so_2;
  so->m3 = so_3;
  so->m4 = so_4;
  so->m5 = so_5;
  so_bound->m0 = so_0_bound;
  so_bound->m1 = so_1_bound;
  so_bound->m2 = so_2_bound;
  so_bound->m3 = so_3_bound;
  so_bound->m4 = so_4_bound;
  so_bound->m5 = so_5_bound;
}

/* so = [Ad](D) (-si); |error of so| <= so_bound unless inf or NaN.
   D: displacement [R | t], R rotation, t in m; si, so, so_bound: screw (v in m/s; ω in rad/s).
   36 mul, 42 add, 6 neg, 21 abs. */
static inline void ksl_product_Adsinv_certified(const ksl_SE3_t *D, const ksl_screw_t *si,
    ksl_screw_t *so, ksl_screw_t *so_bound) {
  const double w_0a = KSL_MUL(D->m00, si->m0), w_0b = KSL_MUL(D->m01, si->m1),
      w_0d = KSL_MUL(D->m02, si->m2), w_0 = -(w_0a + w_0b + w_0d);
  const double w_1a = KSL_MUL(D->m10, si->m0), w_1b = KSL_MUL(D->m11, si->m1),
      w_1d = KSL_MUL(D->m12, si->m2), w_1 = -(w_1a + w_1b + w_1d);
  const double w_2a = KSL_MUL(D->m20, si->m0), w_2b = KSL_MUL(D->m21, si->m1),
      w_2d = KSL_MUL(D->m22, si->m2), w_2 = -(w_2a + w_2b + w_2d);
  const double w_3a = KSL_MUL(D->m00, si->m3), w_3b = KSL_MUL(D->m01, si->m4),
      w_3d = KSL_MUL(D->m02, si->m5), w_3 = -(w_3a + w_3b + w_3d);
  const double w_4a = KSL_MUL(D->m10, si->m3), w_4b = KSL_MUL(D->m11, si->m4),
      w_4d = KSL_MUL(D->m12, si->m5), w_4 = -(w_4a + w_4b + w_4d);
  const double w_5a = KSL_MUL(D->m20, si->m3), w_5b = KSL_MUL(D->m21, si->m4),
      w_5d = KSL_MUL(D->m22, si->m5), w_5 = -(w_5a + w_5b + w_5d);
  const double so_0 = KSL_MUL(D->m13, w_5) - KSL_MUL(D->m23, w_4) + w_0;
  const double so_1 = KSL_MUL(D->m23, w_3) - KSL_MUL(D->m03, w_5) + w_1;
  const double so_2 = KSL_MUL(D->m03, w_4) - KSL_MUL(D->m13, w_3) + w_2;
  const double w_5e_padded = fabs(w_5a) + fabs(w_5b) + fabs(w_5d) + 2.004168360008973e-292;
  const double D_13_abs = fabs(D->m13);
  const double w_4e_padded = fabs(w_4a) + fabs(w_4b) + fabs(w_4d) + 2.004168360008973e-292;
  const double D_23_abs = fabs(D->m23),
      so_0_size = KSL_MUL(D_13_abs, w_5e_padded) + KSL_MUL(D_23_abs, w_4e_padded)
          + (fabs(w_0a) + fabs(w_0b) + fabs(w_0d));
  const double w_3e_padded = fabs(w_3a) + fabs(w_3b) + fabs(w_3d) + 2.004168360008973e-292;
  const double D_03_abs = fabs(D->m03),
      so_1_size = KSL_MUL(D_23_abs, w_3e_padded) + KSL_MUL(D_03_abs, w_5e_padded)
          + (fabs(w_1a) + fabs(w_1b) + fabs(w_1d));
  const double so_2_size = KSL_MUL(D_03_abs, w_4e_padded) + KSL_MUL(D_13_abs, w_3e_padded)
          + (fabs(w_2a) + fabs(w_2b) + fabs(w_2d));
  const double so_0_bound = KSL_MUL(6.661338147750942e-16, so_0_size + 2.004168360008973e-292),
      so_1_bound = KSL_MUL(6.661338147750942e-16, so_1_size + 2.004168360008973e-292),
      so_2_bound = KSL_MUL(6.661338147750942e-16, so_2_size + 2.004168360008973e-292);
  const double w_3e_bound = KSL_MUL(3.3306690738754706e-16, w_3e_padded);
  const double w_4e_bound = KSL_MUL(3.3306690738754706e-16, w_4e_padded);
  const double w_5e_bound = KSL_MUL(3.3306690738754706e-16, w_5e_padded);
  so->m0 = so_0;
  so->m1 = so_1;
  so->m2 = so_2;
  so->m3 = w_3;
  so->m4 = w_4;
  so->m5 = w_5;
  so_bound->m0 = so_0_bound;
  so_bound->m1 = so_1_bound;
  so_bound->m2 = so_2_bound;
  so_bound->m3 = w_3e_bound;
  so_bound->m4 = w_4e_bound;
  so_bound->m5 = w_5e_bound;
}

/* so = h_rx: column 3 of [Ad](D); |error of so| <= so_bound unless inf or NaN.
   D: displacement [R | t], R rotation, t in m; so, so_bound: screw (v in m/s; ω in rad/s).
   9 mul, 9 add, 6 abs. */
static inline void ksl_hsrx_certified(const ksl_SE3_t *D, ksl_screw_t *so, ksl_screw_t *so_bound) {
  const double so_0a = KSL_MUL(D->m20, D->m13), so_0b = KSL_MUL(D->m10, D->m23),
      so_0 = so_0a - so_0b;
  const double so_1a = KSL_MUL(D->m00, D->m23), so_1b = KSL_MUL(D->m20, D->m03),
      so_1 = so_1a - so_1b;
  const double so_2a = KSL_MUL(D->m10, D->m03), so_2b = KSL_MUL(D->m00, D->m13),
      so_2 = so_2a - so_2b;
  const double so_0_size = fabs(so_0a) + fabs(so_0b), so_1_size = fabs(so_1a) + fabs(so_1b),
      so_2_size = fabs(so_2a) + fabs(so_2b);
  const double so_0_bound = KSL_MUL(2.2204460492503136e-16, so_0_size + 2.004168360008973e-292),
      so_1_bound = KSL_MUL(2.2204460492503136e-16, so_1_size + 2.004168360008973e-292),
      so_2_bound = KSL_MUL(2.2204460492503136e-16, so_2_size + 2.004168360008973e-292);
  const double D_m00 = D->m00;
  const double D_m10 = D->m10;
  const double D_m20 = D->m20;
  so->m0 = so_0;
  so->m1 = so_1;
  so->m2 = so_2;
  so->m3 = D_m00;
  so->m4 = D_m10;
  so->m5 = D_m20;
  so_bound->m0 = so_0_bound;
  so_bound->m1 = so_1_bound;
  so_bound->m2 = so_2_bound;
  so_bound->m3 = 0.0;
  so_bound->m4 = 0.0;
  so_bound->m5 = 0.0;
}

/* so = h_ry: column 4 of [Ad](D); |error of so| <= so_bound unless inf or NaN.
   D: displacement [R | t], R rotation, t in m; so, so_bound: screw (v in m/s; ω in rad/s).
   9 mul, 9 add, 6 abs. */
static inline void ksl_hsry_certified(const ksl_SE3_t *D, ksl_screw_t *so, ksl_screw_t *so_bound) {
  const double so_0a = KSL_MUL(D->m21, D->m13), so_0b = KSL_MUL(D->m11, D->m23),
      so_0 = so_0a - so_0b;
  const double so_1a = KSL_MUL(D->m01, D->m23), so_1b = KSL_MUL(D->m21, D->m03),
      so_1 = so_1a - so_1b;
  const double so_2a = KSL_MUL(D->m11, D->m03), so_2b = KSL_MUL(D->m01, D->m13),
      so_2 = so_2a - so_2b;
  const double so_0_size = fabs(so_0a) + fabs(so_0b), so_1_size = fabs(so_1a) + fabs(so_1b),
      so_2_size = fabs(so_2a) + fabs(so_2b);
  const double so_0_bound = KSL_MUL(2.2204460492503136e-16, so_0_size + 2.004168360008973e-292),
      so_1_bound = KSL_MUL(2.2204460492503136e-16, so_1_size + 2.004168360008973e-292),
      so_2_bound = KSL_MUL(2.2204460492503136e-16, so_2_size + 2.004168360008973e-292);
  const double D_m01 = D->m01;
  const double D_m11 = D->m11;
  const double D_m21 = D->m21;
  so->m0 = so_0;
  so->m1 = so_1;
  so->m2 = so_2;
  so->m3 = D_m01;
  so->m4 = D_m11;
  so->m5 = D_m21;
  so_bound->m0 = so_0_bound;
  so_bound->m1 = so_1_bound;
  so_bound->m2 = so_2_bound;
  so_bound->m3 = 0.0;
  so_bound->m4 = 0.0;
  so_bound->m5 = 0.0;
}

/* so = h_rz: column 5 of [Ad](D); |error of so| <= so_bound unless inf or NaN.
   D: displacement [R | t], R rotation, t in m; so, so_bound: screw (v in m/s; ω in rad/s).
   9 mul, 9 add, 6 abs. */
static inline void ksl_hsrz_certified(const ksl_SE3_t *D, ksl_screw_t *so, ksl_screw_t *so_bound) {
  const double so_0a = KSL_MUL(D->m22, D->m13), so_0b = KSL_MUL(D->m12, D->m23),
      so_0 = so_0a - so_0b;
  const double so_1a = KSL_MUL(D->m02, D->m23), so_1b = KSL_MUL(D->m22, D->m03),
      so_1 = so_1a - so_1b;
  const double so_2a = KSL_MUL(D->m12, D->m03), so_2b = KSL_MUL(D->m02, D->m13),
      so_2 = so_2a - so_2b;
  const double so_0_size = fabs(so_0a) + fabs(so_0b), so_1_size = fabs(so_1a) + fabs(so_1b),
      so_2_size = fabs(so_2a) + fabs(so_2b);
  const double so_0_bound = KSL_MUL(2.2204460492503136e-16, so_0_size + 2.004168360008973e-292),
      so_1_bound = KSL_MUL(2.2204460492503136e-16, so_1_size + 2.004168360008973e-292),
      so_2_bound = KSL_MUL(2.2204460492503136e-16, so_2_size + 2.004168360008973e-292);
  const double D_m02 = D->m02;
  const double D_m12 = D->m12;
  const double D_m22 = D->m22;
  so->m0 = so_0;
  so->m1 = so_1;
  so->m2 = so_2;
  so->m3 = D_m02;
  so->m4 = D_m12;
  so->m5 = D_m22;
  so_bound->m0 = so_0_bound;
  so_bound->m1 = so_1_bound;
  so_bound->m2 = so_2_bound;
  so_bound->m3 = 0.0;
  so_bound->m4 = 0.0;
  so_bound->m5 = 0.0;
}

/* so = -h_rx: -column 3 of [Ad](D); |error of so| <= so_bound unless inf or NaN.
   D: displacement [R | t], R rotation, t in m; so, so_bound: screw (v in m/s; ω in rad/s).
   9 mul, 9 add, 3 neg, 6 abs. */
static inline void ksl_hsrxinv_certified(const ksl_SE3_t *D, ksl_screw_t *so,
    ksl_screw_t *so_bound) {
  const double so_0a = KSL_MUL(D->m10, D->m23), so_0b = KSL_MUL(D->m20, D->m13),
      so_0 = so_0a - so_0b;
  const double so_1a = KSL_MUL(D->m20, D->m03), so_1b = KSL_MUL(D->m00, D->m23),
      so_1 = so_1a - so_1b;
  const double so_2a = KSL_MUL(D->m00, D->m13), so_2b = KSL_MUL(D->m10, D->m03),
      so_2 = so_2a - so_2b;
  const double so_3 = -D->m00, so_4 = -D->m10, so_5 = -D->m20;
  const double so_0_size = fabs(so_0a) + fabs(so_0b), so_1_size = fabs(so_1a) + fabs(so_1b),
      so_2_size = fabs(so_2a) + fabs(so_2b);
  const double so_0_bound = KSL_MUL(2.2204460492503136e-16, so_0_size + 2.004168360008973e-292),
      so_1_bound = KSL_MUL(2.2204460492503136e-16, so_1_size + 2.004168360008973e-292),
      so_2_bound = KSL_MUL(2.2204460492503136e-16, so_2_size + 2.004168360008973e-292);
  so->m0 = so_0;
  so->m1 = so_1;
  so->m2 = so_2;
  so->m3 = so_3;
  so->m4 = so_4;
  so->m5 = so_5;
  so_bound->m0 = so_0_bound;
  so_bound->m1 = so_1_bound;
  so_bound->m2 = so_2_bound;
  so_bound->m3 = 0.0;
  so_bound->m4 = 0.0;
  so_bound->m5 = 0.0;
}

/* so = -h_ry: -column 4 of [Ad](D); |error of so| <= so_bound unless inf or NaN.
   D: displacement [R | t], R rotation, t in m; so, so_bound: screw (v in m/s; ω in rad/s).
   9 mul, 9 add, 3 neg, 6 abs. */
static inline void ksl_hsryinv_certified(const ksl_SE3_t *D, ksl_screw_t *so,
    ksl_screw_t *so_bound) {
  const double so_0a = KSL_MUL(D->m11, D->m23), so_0b = KSL_MUL(D->m21, D->m13),
      so_0 = so_0a - so_0b;
  const double so_1a = KSL_MUL(D->m21, D->m03), so_1b = KSL_MUL(D->m01, D->m23),
      so_1 = so_1a - so_1b;
  const double so_2a = KSL_MUL(D->m01, D->m13), so_2b = KSL_MUL(D->m11, D->m03),
      so_2 = so_2a - so_2b;
  const double so_3 = -D->m01, so_4 = -D->m11, so_5 = -D->m21;
  const double so_0_size = fabs(so_0a) + fabs(so_0b), so_1_size = fabs(so_1a) + fabs(so_1b),
      so_2_size = fabs(so_2a) + fabs(so_2b);
  const double so_0_bound = KSL_MUL(2.2204460492503136e-16, so_0_size + 2.004168360008973e-292),
      so_1_bound = KSL_MUL(2.2204460492503136e-16, so_1_size + 2.004168360008973e-292),
      so_2_bound = KSL_MUL(2.2204460492503136e-16, so_2_size + 2.004168360008973e-292);
  so->m0 = so_0;
  so->m1 = so_1;
  so->m2 = so_2;
  so->m3 = so_3;
  so->m4 = so_4;
  so->m5 = so_5;
  so_bound->m0 = so_0_bound;
  so_bound->m1 = so_1_bound;
  so_bound->m2 = so_2_bound;
  so_bound->m3 = 0.0;
  so_bound->m4 = 0.0;
  so_bound->m5 = 0.0;
}

/* so = -h_rz: -column 5 of [Ad](D); |error of so| <= so_bound unless inf or NaN.
   D: displacement [R | t], R rotation, t in m; so, so_bound: screw (v in m/s; ω in rad/s).
   9 mul, 9 add, 3 neg, 6 abs. */
static inline void ksl_hsrzinv_certified(const ksl_SE3_t *D, ksl_screw_t *so,
    ksl_screw_t *so_bound) {
  const double so_0a = KSL_MUL(D->m12, D->m23), so_0b = KSL_MUL(D->m22, D->m13),
      so_0 = so_0a - so_0b;
  const double so_1a = KSL_MUL(D->m22, D->m03), so_1b = KSL_MUL(D->m02, D->m23),
      so_1 = so_1a - so_1b;
  const double so_2a = KSL_MUL(D->m02, D->m13), so_2b = KSL_MUL(D->m12, D->m03),
      so_2 = so_2a - so_2b;
  const double so_3 = -D->m02, so_4 = -D->m12, so_5 = -D->m22;
  const double so_0_size = fabs(so_0a) + fabs(so_0b), so_1_size = fabs(so_1a) + fabs(so_1b),
      so_2_size = fabs(so_2a) + fabs(so_2b);
  const double so_0_bound = KSL_MUL(2.2204460492503136e-16, so_0_size + 2.004168360008973e-292),
      so_1_bound = KSL_MUL(2.2204460492503136e-16, so_1_size + 2.004168360008973e-292),
      so_2_bound = KSL_MUL(2.2204460492503136e-16, so_2_size + 2.004168360008973e-292);
  so->m0 = so_0;
  so->m1 = so_1;
  so->m2 = so_2;
  so->m3 = so_3;
  so->m4 = so_4;
  so->m5 = so_5;
  so_bound->m0 = so_0_bound;
  so_bound->m1 = so_1_bound;
  so_bound->m2 = so_2_bound;
  so_bound->m3 = 0.0;
  so_bound->m4 = 0.0;
  so_bound->m5 = 0.0;
}

/* M = [Ad](D); |error of M| <= M_bound unless inf or NaN.
   D: displacement [R | t], R rotation, t in m; M, M_bound: 6×6 operator.
   27 mul, 27 add, 18 abs. */
static inline void ksl_Ad_certified(const ksl_SE3_t *D, ksl_mat6x6_t *M, ksl_mat6x6_t *M_bound) {
  const double M_03a = KSL_MUL(D->m20, D->m13), M_03b = KSL_MUL(D->m10, D->m23),
      M_03 = M_03a - M_03b;
  const double M_04a = KSL_MUL(D->m21, D->m13), M_04b = KSL_MUL(D->m11, D->m23),
      M_04 = M_04a - M_04b;
  const double M_05a = KSL_MUL(D->m22, D->m13), M_05b = KSL_MUL(D->m12, D->m23),
      M_05 = M_05a - M_05b;
  const double M_13a = KSL_MUL(D->m00, D->m23), M_13b = KSL_MUL(D->m20, D->m03),
      M_13 = M_13a - M_13b;
  const double M_14a = KSL_MUL(D->m01, D->m23), M_14b = KSL_MUL(D->m21, D->m03),
      M_14 = M_14a - M_14b;
  const double M_15a = KSL_MUL(D->m02, D->m23), M_15b = KSL_MUL(D->m22, D->m03),
      M_15 = M_15a - M_15b;
  const double M_23a = KSL_MUL(D->m10, D->m03), M_23b = KSL_MUL(D->m00, D->m13),
      M_23 = M_23a - M_23b;
  const double M_24a = KSL_MUL(D->m11, D->m03), M_24b = KSL_MUL(D->m01, D->m13),
      M_24 = M_24a - M_24b;
  const double M_25a = KSL_MUL(D->m12, D->m03), M_25b = KSL_MUL(D->m02, D->m13),
      M_25 = M_25a - M_25b;
  const double M_03_size = fabs(M_03a) + fabs(M_03b), M_04_size = fabs(M_04a) + fabs(M_04b),
      M_05_size = fabs(M_05a) + fabs(M_05b), M_13_size = fabs(M_13a) + fabs(M_13b),
      M_14_size = fabs(M_14a) + fabs(M_14b), M_15_size = fabs(M_15a) + fabs(M_15b),
      M_23_size = fabs(M_23a) + fabs(M_23b), M_24_size = fabs(M_24a) + fabs(M_24b),
      M_25_size = fabs(M_25a) + fabs(M_25b);
  const double M_03_bound = KSL_MUL(2.2204460492503136e-16, M_03_size + 2.004168360008973e-292),
      M_04_bound = KSL_MUL(2.2204460492503136e-16, M_04_size + 2.004168360008973e-292),
      M_05_bound = KSL_MUL(2.2204460492503136e-16, M_05_size + 2.004168360008973e-292),
      M_13_bound = KSL_MUL(2.2204460492503136e-16, M_13_size + 2.004168360008973e-292),
      M_14_bound = KSL_MUL(2.2204460492503136e-16, M_14_size + 2.004168360008973e-292),
      M_15_bound = KSL_MUL(2.2204460492503136e-16, M_15_size + 2.004168360008973e-292),
      M_23_bound = KSL_MUL(2.2204460492503136e-16, M_23_size + 2.004168360008973e-292),
      M_24_bound = KSL_MUL(2.2204460492503136e-16, M_24_size + 2.004168360008973e-292),
      M_25_bound = KSL_MUL(2.2204460492503136e-16, M_25_size + 2.004168360008973e-292);
  const double D_m00 = D->m00;
  const double D_m01 = D->m01;
  const double D_m02 = D->m02;
  const double D_m10 = D->m10;
  const double D_m11 = D->m11;
  const double D_m12 = D->m12;
  const double D_m20 = D->m20;
  const double D_m21 = D->m21;
  const double D_m22 = D->m22;
  M->at[0][0] = D_m00;
  M->at[1][0] = D_m01;
  M->at[2][0] = D_m02;
  M->at[3][0] = M_03;
  M->at[4][0] = M_04;
  M->at[5][0] = M_05;
  M->at[0][1] = D_m10;
  M->at[1][1] = D_m11;
  M->at[2][1] = D_m12;
  M->at[3][1] = M_13;
  M->at[4][1] = M_14;
  M->at[5][1] = M_15;
  M->at[0][2] = D_m20;
  M->at[1][2] = D_m21;
  M->at[2][2] = D_m22;
  M->at[3][2] = M_23;
  M->at[4][2] = M_24;
  M->at[5][2] = M_25;
  M->at[0][3] = 0.0;
  M->at[1][3] = 0.0;
  M->at[2][3] = 0.0;
  M->at[3][3] = D_m00;
  M->at[4][3] = D_m01;
  M->at[5][3] = D_m02;
  M->at[0][4] = 0.0;
  M->at[1][4] = 0.0;
  M->at[2][4] = 0.0;
  M->at[3][4] = D_m10;
  M->at[4][4] = D_m11;
  M->at[5][4] = D_m12;
  M->at[0][5] = 0.0;
  M->at[1][5] = 0.0;
  M->at[2][5] = 0.0;
  M->at[3][5] = D_m20;
  M->at[4][5] = D_m21;
  M->at[5][5] = D_m22;
  M_bound->at[0][0] = 0.0;
  M_bound->at[1][0] = 0.0;
  M_bound->at[2][0] = 0.0;
  M_bound->at[3][0] = M_03_bound;
  M_bound->at[4][0] = M_04_bound;
  M_bound->at[5][0] = M_05_bound;
  M_bound->at[0][1] = 0.0;
  M_bound->at[1][1] = 0.0;
  M_bound->at[2][1] = 0.0;
  M_bound->at[3][1] = M_13_bound;
  M_bound->at[4][1] = M_14_bound;
  M_bound->at[5][1] = M_15_bound;
  M_bound->at[0][2] = 0.0;
  M_bound->at[1][2] = 0.0;
  M_bound->at[2][2] = 0.0;
  M_bound->at[3][2] = M_23_bound;
  M_bound->at[4][2] = M_24_bound;
  M_bound->at[5][2] = M_25_bound;
  M_bound->at[0][3] = 0.0;
  M_bound->at[1][3] = 0.0;
  M_bound->at[2][3] = 0.0;
  M_bound->at[3][3] = 0.0;
  M_bound->at[4][3] = 0.0;
  M_bound->at[5][3] = 0.0;
  M_bound->at[0][4] = 0.0;
  M_bound->at[1][4] = 0.0;
  M_bound->at[2][4] = 0.0;
  M_bound->at[3][4] = 0.0;
  M_bound->at[4][4] = 0.0;
  M_bound->at[5][4] = 0.0;
  M_bound->at[0][5] = 0.0;
  M_bound->at[1][5] = 0.0;
  M_bound->at[2][5] = 0.0;
  M_bound->at[3][5] = 0.0;
  M_bound->at[4][5] = 0.0;
  M_bound->at[5][5] = 0.0;
}

/* power = f·v + τ·ω, in W; |error of power| <= power_bound unless inf or NaN.
   c: coscrew (f in N; τ in N m); s: screw (v in m/s; ω in rad/s); power_bound: number.
   7 mul, 11 add, 6 abs. */
static inline double ksl_dot_cs_certified(const ksl_coscrew_t *c, const ksl_screw_t *s,
    double *power_bound) {
  const double power_a = KSL_MUL(c->m0, s->m0), power_b = KSL_MUL(c->m1, s->m1),
      power_d = KSL_MUL(c->m2, s->m2), power_f = KSL_MUL(c->m3, s->m3),
      power_g = KSL_MUL(c->m4, s->m4), power_i = KSL_MUL(c->m5, s->m5),
      power = power_a + power_b + power_d + (power_f + power_g + power_i);
  const double power_size = fabs(power_a) + fabs(power_b) + fabs(power_d)
          + (fabs(power_f) + fabs(power_g) + fabs(power_i));
  const double power_bound_ = KSL_MUL(4.440892098500628e-16, power_size + 2.004168360008973e-292);
  *power_bound = power_bound_;
  return power;
}

/* so = [ad](s1) s2 = (ω1×v2 + v1×ω2 ; ω1×ω2); |error of so| <= so_bound unless inf or NaN.
     Exactly zero for s1 = s2, unless products overflow.
   s1, s2, so, so_bound: screw (v in m/s; ω in rad/s).
   24 mul, 30 add, 18 abs. */
static inline void ksl_cross_ss_certified(const ksl_screw_t *s1, const ksl_screw_t *s2,
    ksl_screw_t *so, ksl_screw_t *so_bound) {
  const double so_0a = KSL_MUL(s1->m1, s2->m5), so_0b = KSL_MUL(s1->m5, s2->m1),
      so_0d = KSL_MUL(s1->m4, s2->m2), so_0e = KSL_MUL(s1->m2, s2->m4),
      so_0 = so_0a - so_0b + (so_0d - so_0e);
  const double so_1a = KSL_MUL(s1->m5, s2->m0), so_1b = KSL_MUL(s1->m0, s2->m5),
      so_1d = KSL_MUL(s1->m2, s2->m3), so_1e = KSL_MUL(s1->m3, s2->m2),
      so_1 = so_1a - so_1b + (so_1d - so_1e);
  const double so_2a = KSL_MUL(s1->m0, s2->m4), so_2b = KSL_MUL(s1->m4, s2->m0),
      so_2d = KSL_MUL(s1->m3, s2->m1), so_2e = KSL_MUL(s1->m1, s2->m3),
      so_2 = so_2a - so_2b + (so_2d - so_2e);
  const double so_3a = KSL_MUL(s1->m4, s2->m5), so_3b = KSL_MUL(s1->m5, s2->m4),
      so_3 = so_3a - so_3b;
  const double so_4a = KSL_MUL(s1->m5, s2->m3), so_4b = KSL_MUL(s1->m3, s2->m5),
      so_4 = so_4a - so_4b;
  const double so_5a = KSL_MUL(s1->m3, s2->m4), so_5b = KSL_MUL(s1->m4, s2->m3),
      so_5 = so_5a - so_5b;
  const double so_0_size = fabs(so_0a) + fabs(so_0b) + (fabs(so_0d) + fabs(so_0e)),
      so_1_size = fabs(so_1a) + fabs(so_1b) + (fabs(so_1d) + fabs(so_1e)),
      so_2_size = fabs(so_2a) + fabs(so_2b) + (fabs(so_2d) + fabs(so_2e)),
      so_3_size = fabs(so_3a) + fabs(so_3b), so_4_size = fabs(so_4a) + fabs(so_4b),
      so_5_size = fabs(so_5a) + fabs(so_5b);
  const double so_0_bound = KSL_MUL(3.3306690738754706e-16, so_0_size + 2.004168360008973e-292),
      so_1_bound = KSL_MUL(3.3306690738754706e-16, so_1_size + 2.004168360008973e-292),
      so_2_bound = KSL_MUL(3.3306690738754706e-16, so_2_size + 2.004168360008973e-292),
      so_3_bound = KSL_MUL(2.2204460492503136e-16, so_3_size + 2.004168360008973e-292),
      so_4_bound = KSL_MUL(2.2204460492503136e-16, so_4_size + 2.004168360008973e-292),
      so_5_bound = KSL_MUL(2.2204460492503136e-16, so_5_size + 2.004168360008973e-292);
  so->m0 = so_0;
  so->m1 = so_1;
  so->m2 = so_2;
  so->m3 = so_3;
  so->m4 = so_4;
  so->m5 = so_5;
  so_bound->m0 = so_0_bound;
  so_bound->m1 = so_1_bound;
  so_bound->m2 = so_2_bound;
  so_bound->m3 = so_3_bound;
  so_bound->m4 = so_4_bound;
  so_bound->m5 = so_5_bound;
}

/* so = (ω1×v2 ; 0); |error of so| <= so_bound unless inf or NaN.
   s1, s2, so, so_bound: screw (v in m/s; ω in rad/s).
   9 mul, 9 add, 6 abs. */
static inline void ksl_cross_sst_certified(const ksl_screw_t *s1, const ksl_screw_t *s2,
    ksl_screw_t *so, ksl_screw_t *so_bound) {
  const double so_0a = KSL_MUL(s1->m4, s2->m2), so_0b = KSL_MUL(s1->m5, s2->m1),
      so_0 = so_0a - so_0b;
  const double so_1a = KSL_MUL(s1->m5, s2->m0), so_1b = KSL_MUL(s1->m3, s2->m2),
      so_1 = so_1a - so_1b;
  const double so_2a = KSL_MUL(s1->m3, s2->m1), so_2b = KSL_MUL(s1->m4, s2->m0),
      so_2 = so_2a - so_2b;
  const double so_0_size = fabs(so_0a) + fabs(so_0b), so_1_size = fabs(so_1a) + fabs(so_1b),
      so_2_size = fabs(so_2a) + fabs(so_2b);
  const double so_0_bound = KSL_MUL(2.2204460492503136e-16, so_0_size + 2.004168360008973e-292),
      so_1_bound = KSL_MUL(2.2204460492503136e-16, so_1_size + 2.004168360008973e-292),
      so_2_bound = KSL_MUL(2.2204460492503136e-16, so_2_size + 2.004168360008973e-292);
  so->m0 = so_0;
  so->m1 = so_1;
  so->m2 = so_2;
  so->m3 = 0.0;
  so->m4 = 0.0;
  so->m5 = 0.0;
  so_bound->m0 = so_0_bound;
  so_bound->m1 = so_1_bound;
  so_bound->m2 = so_2_bound;
  so_bound->m3 = 0.0;
  so_bound->m4 = 0.0;
  so_bound->m5 = 0.0;
}

/* so = (t×R a ; R a), a = axis in the body's frame; |error of so| <= so_bound unless inf or NaN.
   D: displacement [R | t], R rotation, t in m; axis: vector; so, so_bound: screw (v in m/s; ω in
     rad/s).
   27 mul, 24 add, 12 abs. */
static inline void ksl_hsra_certified(const ksl_SE3_t *D, const ksl_vec3_t *axis, ksl_screw_t *so,
    ksl_screw_t *so_bound) {
  const double a_0a = KSL_MUL(D->m00, axis->x), a_0b = KSL_MUL(D->m01, axis->y),
      a_0d = KSL_MUL(D->m02, axis->z), a_0 = a_0a + a_0b + a_0d;
  const double a_1a = KSL_MUL(D->m10, axis->x), a_1b = KSL_MUL(D->m11, axis->y),
      a_1d = KSL_MUL(D->m12, axis->z), a_1 = a_1a + a_1b + a_1d;
  const double a_2a = KSL_MUL(D->m20, axis->x), a_2b = KSL_MUL(D->m21, axis->y),
      a_2d = KSL_MUL(D->m22, axis->z), a_2 = a_2a + a_2b + a_2d;
  const double so_0 = KSL_MUL(D->m13, a_2) - KSL_MUL(D->m23, a_1);
  const double so_1 = KSL_MUL(D->m23, a_0) - KSL_MUL(D->m03, a_2);
  const double so_2 = KSL_MUL(D->m03, a_1) - KSL_MUL(D->m13, a_0);
  const double a_0_size = fabs(a_0a) + fabs(a_0b) + fabs(a_0d),
      a_1_size = fabs(a_1a) + fabs(a_1b) + fabs(a_1d),
      a_2_size = fabs(a_2a) + fabs(a_2b) + fabs(a_2d);
  const double a_2_padded = a_2_size + 2.004168360008973e-292;
  const double D_13_abs = fabs(D->m13);
  const double a_1_padded = a_1_size + 2.004168360008973e-292;
  const double D_23_abs = fabs(D->m23),
      so_0_size = KSL_MUL(D_13_abs, a_2_padded) + KSL_MUL(D_23_abs, a_1_padded);
  const double a_0_padded = a_0_size + 2.004168360008973e-292;
  const double D_03_abs = fabs(D->m03),
      so_1_size = KSL_MUL(D_23_abs, a_0_padded) + KSL_MUL(D_03_abs, a_2_padded);
  const double so_2_size = KSL_MUL(D_03_abs, a_1_padded) + KSL_MUL(D_13_abs, a_0_padded);
  const double so_0_bound = KSL_MUL(5.551115123125785e-16, so_0_size + 2.004168360008973e-292),
      so_1_bound = KSL_MUL(5.551115123125785e-16, so_1_size + 2.004168360008973e-292),
      so_2_bound = KSL_MUL(5.551115123125785e-16, so_2_size + 2.004168360008973e-292);
  const double a_0_bound = KSL_MUL(3.3306690738754706e-16, a_0_padded),
      a_1_bound = KSL_MUL(3.3306690738754706e-16, a_1_padded),
      a_2_bound = KSL_MUL(3.3306690738754706e-16, a_2_padded);
  so->m0 = so_0;
  so->m1 = so_1;
  so->m2 = so_2;
  so->m3 = a_0;
  so->m4 = a_1;
  so->m5 = a_2;
  so_bound->m0 = so_0_bound;
  so_bound->m1 = so_1_bound;
  so_bound->m2 = so_2_bound;
  so_bound->m3 = a_0_bound;
  so_bound->m4 = a_1_bound;
  so_bound->m5 = a_2_bound;
}

/* so = (R a ; 0), a = axis in the body's frame; |error of so| <= so_bound unless inf or NaN.
   D: displacement [R | t], R rotation, t in m; axis: vector; so, so_bound: screw (v in m/s; ω in
     rad/s).
   12 mul, 15 add, 9 abs. */
static inline void ksl_hsta_certified(const ksl_SE3_t *D, const ksl_vec3_t *axis, ksl_screw_t *so,
    ksl_screw_t *so_bound) {
  const double so_0a = KSL_MUL(D->m00, axis->x), so_0b = KSL_MUL(D->m01, axis->y),
      so_0d = KSL_MUL(D->m02, axis->z), so_0 = so_0a + so_0b + so_0d;
  const double so_1a = KSL_MUL(D->m10, axis->x), so_1b = KSL_MUL(D->m11, axis->y),
      so_1d = KSL_MUL(D->m12, axis->z), so_1 = so_1a + so_1b + so_1d;
  const double so_2a = KSL_MUL(D->m20, axis->x), so_2b = KSL_MUL(D->m21, axis->y),
      so_2d = KSL_MUL(D->m22, axis->z), so_2 = so_2a + so_2b + so_2d;
  const double so_0_size = fabs(so_0a) + fabs(so_0b) + fabs(so_0d),
      so_1_size = fabs(so_1a) + fabs(so_1b) + fabs(so_1d),
      so_2_size = fabs(so_2a) + fabs(so_2b) + fabs(so_2d);
  const double so_0_bound = KSL_MUL(3.3306690738754706e-16, so_0_size + 2.004168360008973e-292),
      so_1_bound = KSL_MUL(3.3306690738754706e-16, so_1_size + 2.004168360008973e-292),
      so_2_bound = KSL_MUL(3.3306690738754706e-16, so_2_size + 2.004168360008973e-292);
  so->m0 = so_0;
  so->m1 = so_1;
  so->m2 = so_2;
  so->m3 = 0.0;
  so->m4 = 0.0;
  so->m5 = 0.0;
  so_bound->m0 = so_0_bound;
  so_bound->m1 = so_1_bound;
  so_bound->m2 = so_2_bound;
  so_bound->m3 = 0.0;
  so_bound->m4 = 0.0;
  so_bound->m5 = 0.0;
}

/* so = -(t×R a ; R a), a = axis in the body's frame; |error of so| <= so_bound unless inf or
     NaN.
   D: displacement [R | t], R rotation, t in m; axis: vector; so, so_bound: screw (v in m/s; ω in
     rad/s).
   27 mul, 24 add, 3 neg, 12 abs. */
static inline void ksl_hsrainv_certified(const ksl_SE3_t *D, const ksl_vec3_t *axis,
    ksl_screw_t *so, ksl_screw_t *so_bound) {
  const double a_0a = KSL_MUL(D->m00, axis->x), a_0b = KSL_MUL(D->m01, axis->y),
      a_0d = KSL_MUL(D->m02, axis->z), a_0 = -(a_0a + a_0b + a_0d);
  const double a_1a = KSL_MUL(D->m10, axis->x), a_1b = KSL_MUL(D->m11, axis->y),
      a_1d = KSL_MUL(D->m12, axis->z), a_1 = -(a_1a + a_1b + a_1d);
  const double a_2a = KSL_MUL(D->m20, axis->x), a_2b = KSL_MUL(D->m21, axis->y),
      a_2d = KSL_MUL(D->m22, axis->z), a_2 = -(a_2a + a_2b + a_2d);
  const double so_0 = KSL_MUL(D->m13, a_2) - KSL_MUL(D->m23, a_1);
  const double so_1 = KSL_MUL(D->m23, a_0) - KSL_MUL(D->m03, a_2);
  const double so_2 = KSL_MUL(D->m03, a_1) - KSL_MUL(D->m13, a_0);
  const double a_2e_padded = fabs(a_2a) + fabs(a_2b) + fabs(a_2d) + 2.004168360008973e-292;
  const double D_13_abs = fabs(D->m13);
  const double a_1e_padded = fabs(a_1a) + fabs(a_1b) + fabs(a_1d) + 2.004168360008973e-292;
  const double D_23_abs = fabs(D->m23),
      so_0_size = KSL_MUL(D_13_abs, a_2e_padded) + KSL_MUL(D_23_abs, a_1e_padded);
  const double a_0e_padded = fabs(a_0a) + fabs(a_0b) + fabs(a_0d) + 2.004168360008973e-292;
  const double D_03_abs = fabs(D->m03),
      so_1_size = KSL_MUL(D_23_abs, a_0e_padded) + KSL_MUL(D_03_abs, a_2e_padded);
  const double so_2_size = KSL_MUL(D_03_abs, a_1e_padded) + KSL_MUL(D_13_abs, a_0e_padded);
  const double so_0_bound = KSL_MUL(5.551115123125785e-16, so_0_size + 2.004168360008973e-292),
      so_1_bound = KSL_MUL(5.551115123125785e-16, so_1_size + 2.004168360008973e-292),
      so_2_bound = KSL_MUL(5.551115123125785e-16, so_2_size + 2.004168360008973e-292);
  const double a_0e_bound = KSL_MUL(3.3306690738754706e-16, a_0e_padded);
  const double a_1e_bound = KSL_MUL(3.3306690738754706e-16, a_1e_padded);
  const double a_2e_bound = KSL_MUL(3.3306690738754706e-16, a_2e_padded);
  so->m0 = so_0;
  so->m1 = so_1;
  so->m2 = so_2;
  so->m3 = a_0;
  so->m4 = a_1;
  so->m5 = a_2;
  so_bound->m0 = so_0_bound;
  so_bound->m1 = so_1_bound;
  so_bound->m2 = so_2_bound;
  so_bound->m3 = a_0e_bound;
  so_bound->m4 = a_1e_bound;
  so_bound->m5 = a_2e_bound;
}

/* so = -(R a ; 0), a = axis in the body's frame; |error of so| <= so_bound unless inf or NaN.
   D: displacement [R | t], R rotation, t in m; axis: vector; so, so_bound: screw (v in m/s; ω in
     rad/s).
   12 mul, 15 add, 3 neg, 9 abs. */
static inline void ksl_hstainv_certified(const ksl_SE3_t *D, const ksl_vec3_t *axis,
    ksl_screw_t *so, ksl_screw_t *so_bound) {
  const double so_0a = KSL_MUL(D->m00, axis->x), so_0b = KSL_MUL(D->m01, axis->y),
      so_0d = KSL_MUL(D->m02, axis->z), so_0 = -(so_0a + so_0b + so_0d);
  const double so_1a = KSL_MUL(D->m10, axis->x), so_1b = KSL_MUL(D->m11, axis->y),
      so_1d = KSL_MUL(D->m12, axis->z), so_1 = -(so_1a + so_1b + so_1d);
  const double so_2a = KSL_MUL(D->m20, axis->x), so_2b = KSL_MUL(D->m21, axis->y),
      so_2d = KSL_MUL(D->m22, axis->z), so_2 = -(so_2a + so_2b + so_2d);
  const double so_0e_bound = KSL_MUL(3.3306690738754706e-16, fabs(so_0a) + fabs(so_0b)
          + fabs(so_0d) + 2.004168360008973e-292);
  const double so_1e_bound = KSL_MUL(3.3306690738754706e-16, fabs(so_1a) + fabs(so_1b)
          + fabs(so_1d) + 2.004168360008973e-292);
  const double so_2e_bound = KSL_MUL(3.3306690738754706e-16, fabs(so_2a) + fabs(so_2b)
          + fabs(so_2d) + 2.004168360008973e-292);
  so->m0 = so_0;
  so->m1 = so_1;
  so->m2 = so_2;
  so->m3 = 0.0;
  so->m4 = 0.0;
  so->m5 = 0.0;
  so_bound->m0 = so_0e_bound;
  so_bound->m1 = so_1e_bound;
  so_bound->m2 = so_2e_bound;
  so_bound->m3 = 0.0;
  so_bound->m4 = 0.0;
  so_bound->m5 = 0.0;
}

/* self = a self; |error of self| <= self_bound unless inf or NaN.
   self, self_bound: screw (v in m/s; ω in rad/s); a: number.
   12 mul, 6 add, 6 abs. */
static inline void ksl_screwf_scale_certified(ksl_screwf_t *self, const float a,
    ksl_screwf_t *self_bound) {
  const float self_0_new = KSL_MULF(self->m0, a), self_1_new = KSL_MULF(self->m1, a),
      self_2_new = KSL_MULF(self->m2, a), self_3_new = KSL_MULF(self->m3, a),
      self_4_new = KSL_MULF(self->m4, a), self_5_new = KSL_MULF(self->m5, a);
  const float self_0_new_bound = KSL_MULF(5.960465e-08f, fabsf(self_0_new) + 1.9721523e-31f),
      self_1_new_bound = KSL_MULF(5.960465e-08f, fabsf(self_1_new) + 1.9721523e-31f),
      self_2_new_bound = KSL_MULF(5.960465e-08f, fabsf(self_2_new) + 1.9721523e-31f),
      self_3_new_bound = KSL_MULF(5.960465e-08f, fabsf(self_3_new) + 1.9721523e-31f),
      self_4_new_bound = KSL_MULF(5.960465e-08f, fabsf(self_4_new) + 1.9721523e-31f),
      self_5_new_bound = KSL_MULF(5.960465e-08f, fabsf(self_5_new) + 1.9721523e-31f);
  self->m0 = self_0_new;
  self->m1 = self_1_new;
  self->m2 = self_2_new;
  self->m3 = self_3_new;
  self->m4 = self_4_new;
  self->m5 = self_5_new;
  self_bound->m0 = self_0_new_bound;
  self_bound->m1 = self_1_new_bound;
  self_bound->m2 = self_2_new_bound;
  self_bound->m3 = self_3_new_bound;
  self_bound->m4 = self_4_new_bound;
  self_bound->m5 = self_5_new_bound;
}

/* y = a x + y; |error of y| <= y_bound unless inf or NaN.
   a: number; x, y, y_bound: screw (v in m/s; ω in rad/s).
   12 mul, 18 add, 12 abs. */
static inline void ksl_axpy_ssf_certified(const float a, const ksl_screwf_t *x, ksl_screwf_t *y,
    ksl_screwf_t *y_bound) {
  const float y_0_new_a = KSL_MULF(a, x->m0), y_0_new = y_0_new_a + y->m0;
  const float y_1_new_a = KSL_MULF(a, x->m1), y_1_new = y_1_new_a + y->m1;
  const float y_2_new_a = KSL_MULF(a, x->m2), y_2_new = y_2_new_a + y->m2;
  const float y_3_new_a = KSL_MULF(a, x->m3), y_3_new = y_3_new_a + y->m3;
  const float y_4_new_a = KSL_MULF(a, x->m4), y_4_new = y_4_new_a + y->m4;
  const float y_5_new_a = KSL_MULF(a, x->m5), y_5_new = y_5_new_a + y->m5;
  const float y_0_new_size = fabsf(y_0_new_a) + fabsf(y->m0),
      y_1_new_size = fabsf(y_1_new_a) + fabsf(y->m1),
      y_2_new_size = fabsf(y_2_new_a) + fabsf(y->m2),
      y_3_new_size = fabsf(y_3_new_a) + fabsf(y->m3),
      y_4_new_size = fabsf(y_4_new_a) + fabsf(y->m4),
      y_5_new_size = fabsf(y_5_new_a) + fabsf(y->m5);
  const float y_0_new_bound = KSL_MULF(1.192093e-07f, y_0_new_size + 1.9721523e-31f),
      y_1_new_bound = KSL_MULF(1.192093e-07f, y_1_new_size + 1.9721523e-31f),
      y_2_new_bound = KSL_MULF(1.192093e-07f, y_2_new_size + 1.9721523e-31f),
      y_3_new_bound = KSL_MULF(1.192093e-07f, y_3_new_size + 1.9721523e-31f),
      y_4_new_bound = KSL_MULF(1.192093e-07f, y_4_new_size + 1.9721523e-31f),
      y_5_new_bound = KSL_MULF(1.192093e-07f, y_5_new_size + 1.9721523e-31f);
  y->m0 = y_0_new;
  y->m1 = y_1_new;
  y->m2 = y_2_new;
  y->m3 = y_3_new;
  y->m4 = y_4_new;
  y->m5 = y_5_new;
  y_bound->m0 = y_0_new_bound;
  y_bound->m1 = y_1_new_bound;
  y_bound->m2 = y_2_new_bound;
  y_bound->m3 = y_3_new_bound;
  y_bound->m4 = y_4_new_bound;
  y_bound->m5 = y_5_new_bound;
}

/* y = x + y; |error of y| <= y_bound unless inf or NaN.
   x, y, y_bound: screw (v in m/s; ω in rad/s).
   6 mul, 6 add, 6 abs. */
static inline void ksl_xpy_ssf_certified(const ksl_screwf_t *x, ksl_screwf_t *y,
    ksl_screwf_t *y_bound) {
  const float y_0_new = x->m0 + y->m0, y_1_new = x->m1 + y->m1, y_2_new = x->m2 + y->m2,
      y_3_new = x->m3 + y->m3, y_4_new = x->m4 + y->m4, y_5_new = x->m5 + y->m5;
  const float y_0_new_bound = KSL_MULF(5.960465e-08f, fabsf(y_0_new)),
      y_1_new_bound = KSL_MULF(5.960465e-08f, fabsf(y_1_new)),
      y_2_new_bound = KSL_MULF(5.960465e-08f, fabsf(y_2_new)),
      y_3_new_bound = KSL_MULF(5.960465e-08f, fabsf(y_3_new)),
      y_4_new_bound = KSL_MULF(5.960465e-08f, fabsf(y_4_new)),
      y_5_new_bound = KSL_MULF(5.960465e-08f, fabsf(y_5_new));
  y->m0 = y_0_new;
  y->m1 = y_1_new;
  y->m2 = y_2_new;
  y->m3 = y_3_new;
  y->m4 = y_4_new;
  y->m5 = y_5_new;
  y_bound->m0 = y_0_new_bound;
  y_bound->m1 = y_1_new_bound;
  y_bound->m2 = y_2_new_bound;
  y_bound->m3 = y_3_new_bound;
  y_bound->m4 = y_4_new_bound;
  y_bound->m5 = y_5_new_bound;
}

/* y = -x + y; |error of y| <= y_bound unless inf or NaN.
   x, y, y_bound: screw (v in m/s; ω in rad/s).
   6 mul, 6 add, 6 abs. */
static inline void ksl_nxpy_ssf_certified(const ksl_screwf_t *x, ksl_screwf_t *y,
    ksl_screwf_t *y_bound) {
  const float y_0_new = y->m0 - x->m0, y_1_new = y->m1 - x->m1, y_2_new = y->m2 - x->m2,
      y_3_new = y->m3 - x->m3, y_4_new = y->m4 - x->m4, y_5_new = y->m5 - x->m5;
  const float y_0_new_bound = KSL_MULF(5.960465e-08f, fabsf(y_0_new)),
      y_1_new_bound = KSL_MULF(5.960465e-08f, fabsf(y_1_new)),
      y_2_new_bound = KSL_MULF(5.960465e-08f, fabsf(y_2_new)),
      y_3_new_bound = KSL_MULF(5.960465e-08f, fabsf(y_3_new)),
      y_4_new_bound = KSL_MULF(5.960465e-08f, fabsf(y_4_new)),
      y_5_new_bound = KSL_MULF(5.960465e-08f, fabsf(y_5_new));
  y->m0 = y_0_new;
  y->m1 = y_1_new;
  y->m2 = y_2_new;
  y->m3 = y_3_new;
  y->m4 = y_4_new;
  y->m5 = y_5_new;
  y_bound->m0 = y_0_new_bound;
  y_bound->m1 = y_1_new_bound;
  y_bound->m2 = y_2_new_bound;
  y_bound->m3 = y_3_new_bound;
  y_bound->m4 = y_4_new_bound;
  y_bound->m5 = y_5_new_bound;
}

/* so = a si; |error of so| <= so_bound unless inf or NaN.
   a: number; si, so, so_bound: screw (v in m/s; ω in rad/s).
   12 mul, 6 add, 6 abs. */
static inline void ksl_product_asf_certified(const float a, const ksl_screwf_t *si,
    ksl_screwf_t *so, ksl_screwf_t *so_bound) {
  const float so_0 = KSL_MULF(a, si->m0), so_1 = KSL_MULF(a, si->m1), so_2 = KSL_MULF(a, si->m2),
      so_3 = KSL_MULF(a, si->m3), so_4 = KSL_MULF(a, si->m4), so_5 = KSL_MULF(a, si->m5);
  const float so_0_bound = KSL_MULF(5.960465e-08f, fabsf(so_0) + 1.9721523e-31f),
      so_1_bound = KSL_MULF(5.960465e-08f, fabsf(so_1) + 1.9721523e-31f),
      so_2_bound = KSL_MULF(5.960465e-08f, fabsf(so_2) + 1.9721523e-31f),
      so_3_bound = KSL_MULF(5.960465e-08f, fabsf(so_3) + 1.9721523e-31f),
      so_4_bound = KSL_MULF(5.960465e-08f, fabsf(so_4) + 1.9721523e-31f),
      so_5_bound = KSL_MULF(5.960465e-08f, fabsf(so_5) + 1.9721523e-31f);
  so->m0 = so_0;
  so->m1 = so_1;
  so->m2 = so_2;
  so->m3 = so_3;
  so->m4 = so_4;
  so->m5 = so_5;
  so_bound->m0 = so_0_bound;
  so_bound->m1 = so_1_bound;
  so_bound->m2 = so_2_bound;
  so_bound->m3 = so_3_bound;
  so_bound->m4 = so_4_bound;
  so_bound->m5 = so_5_bound;
}

/* so = s1 + s2; |error of so| <= so_bound unless inf or NaN.
   s1, s2, so, so_bound: screw (v in m/s; ω in rad/s).
   6 mul, 6 add, 6 abs. */
static inline void ksl_add_ssf_certified(const ksl_screwf_t *s1, const ksl_screwf_t *s2,
    ksl_screwf_t *so, ksl_screwf_t *so_bound) {
  const float so_0 = s1->m0 + s2->m0, so_1 = s1->m1 + s2->m1, so_2 = s1->m2 + s2->m2,
      so_3 = s1->m3 + s2->m3, so_4 = s1->m4 + s2->m4, so_5 = s1->m5 + s2->m5;
  const float so_0_bound = KSL_MULF(5.960465e-08f, fabsf(so_0)),
      so_1_bound = KSL_MULF(5.960465e-08f, fabsf(so_1)),
      so_2_bound = KSL_MULF(5.960465e-08f, fabsf(so_2)),
      so_3_bound = KSL_MULF(5.960465e-08f, fabsf(so_3)),
      so_4_bound = KSL_MULF(5.960465e-08f, fabsf(so_4)),
      so_5_bound = KSL_MULF(5.960465e-08f, fabsf(so_5));
  so->m0 = so_0;
  so->m1 = so_1;
  so->m2 = so_2;
  so->m3 = so_3;
  so->m4 = so_4;
  so->m5 = so_5;
  so_bound->m0 = so_0_bound;
  so_bound->m1 = so_1_bound;
  so_bound->m2 = so_2_bound;
  so_bound->m3 = so_3_bound;
  so_bound->m4 = so_4_bound;
  so_bound->m5 = so_5_bound;
}

/* so = s1 - s2; |error of so| <= so_bound unless inf or NaN.
   s1, s2, so, so_bound: screw (v in m/s; ω in rad/s).
   6 mul, 6 add, 6 abs. */
static inline void ksl_subtract_ssf_certified(const ksl_screwf_t *s1, const ksl_screwf_t *s2,
    ksl_screwf_t *so, ksl_screwf_t *so_bound) {
  const float so_0 = s1->m0 - s2->m0, so_1 = s1->m1 - s2->m1, so_2 = s1->m2 - s2->m2,
      so_3 = s1->m3 - s2->m3, so_4 = s1->m4 - s2->m4, so_5 = s1->m5 - s2->m5;
  const float so_0_bound = KSL_MULF(5.960465e-08f, fabsf(so_0)),
      so_1_bound = KSL_MULF(5.960465e-08f, fabsf(so_1)),
      so_2_bound = KSL_MULF(5.960465e-08f, fabsf(so_2)),
      so_3_bound = KSL_MULF(5.960465e-08f, fabsf(so_3)),
      so_4_bound = KSL_MULF(5.960465e-08f, fabsf(so_4)),
      so_5_bound = KSL_MULF(5.960465e-08f, fabsf(so_5));
  so->m0 = so_0;
  so->m1 = so_1;
  so->m2 = so_2;
  so->m3 = so_3;
  so->m4 = so_4;
  so->m5 = so_5;
  so_bound->m0 = so_0_bound;
  so_bound->m1 = so_1_bound;
  so_bound->m2 = so_2_bound;
  so_bound->m3 = so_3_bound;
  so_bound->m4 = so_4_bound;
  so_bound->m5 = so_5_bound;
}

/* so = (s1.lin + s2.lin ; s1.ang); |error of so| <= so_bound unless inf or NaN.
   s1, s2, so, so_bound: screw (v in m/s; ω in rad/s).
   3 mul, 3 add, 3 abs. */
static inline void ksl_add_sstf_certified(const ksl_screwf_t *s1, const ksl_screwf_t *s2,
    ksl_screwf_t *so, ksl_screwf_t *so_bound) {
  const float so_0 = s1->m0 + s2->m0, so_1 = s1->m1 + s2->m1, so_2 = s1->m2 + s2->m2;
  const float so_0_bound = KSL_MULF(5.960465e-08f, fabsf(so_0)),
      so_1_bound = KSL_MULF(5.960465e-08f, fabsf(so_1)),
      so_2_bound = KSL_MULF(5.960465e-08f, fabsf(so_2));
  const float s1_m3 = s1->m3;
  const float s1_m4 = s1->m4;
  const float s1_m5 = s1->m5;
  so->m0 = so_0;
  so->m1 = so_1;
  so->m2 = so_2;
  so->m3 = s1_m3;
  so->m4 = s1_m4;
  so->m5 = s1_m5;
  so_bound->m0 = so_0_bound;
  so_bound->m1 = so_1_bound;
  so_bound->m2 = so_2_bound;
  so_bound->m3 = 0.0f;
  so_bound->m4 = 0.0f;
  so_bound->m5 = 0.0f;
}

/* so = [Ad](t) si; |error of so| <= so_bound unless inf or NaN.
   t: vector; si, so, so_bound: screw (v in m/s; ω in rad/s).
   9 mul, 15 add, 9 abs. */
static inline void ksl_product_Adtsf_certified(const ksl_vec3f_t *t, const ksl_screwf_t *si,
    ksl_screwf_t *so, ksl_screwf_t *so_bound) {
  const float so_0a = KSL_MULF(t->y, si->m5), so_0b = KSL_MULF(t->z, si->m4),
      so_0 = so_0a - so_0b + si->m0;
  const float so_1a = KSL_MULF(t->z, si->m3), so_1b = KSL_MULF(t->x, si->m5),
      so_1 = so_1a - so_1b + si->m1;
  const float so_2a = KSL_MULF(t->x, si->m4), so_2b = KSL_MULF(t->y, si->m3),
      so_2 = so_2a - so_2b + si->m2;
  const float so_0_size = fabsf(so_0a) + fabsf(so_0b) + fabsf(si->m0),
      so_1_size = fabsf(so_1a) + fabsf(so_1b) + fabsf(si->m1),
      so_2_size = fabsf(so_2a) + fabsf(so_2b) + fabsf(si->m2);
  const float so_0_bound = KSL_MULF(1.7881396e-07f, so_0_size + 1.9721523e-31f),
      so_1_bound = KSL_MULF(1.7881396e-07f, so_1_size + 1.9721523e-31f),
      so_2_bound = KSL_MULF(1.7881396e-07f, so_2_size + 1.9721523e-31f);
  const float si_m3 = si->m3;
  const float si_m4 = si->m4;
  const float si_m5 = si->m5;
  so->m0 = so_0;
  so->m1 = so_1;
  so->m2 = so_2;
  so->m3 = si_m3;
  so->m4 = si_m4;
  so->m5 = si_m5;
  so_bound->m0 = so_0_bound;
  so_bound->m1 = so_1_bound;
  so_bound->m2 = so_2_bound;
  so_bound->m3 = 0.0f;
  so_bound->m4 = 0.0f;
  so_bound->m5 = 0.0f;
}

/* so = [Ad](t)^-1 si; |error of so| <= so_bound unless inf or NaN.
   t: vector; si, so, so_bound: screw (v in m/s; ω in rad/s).
   9 mul, 15 add, 9 abs. */
static inline void ksl_product_Adtinvsf_certified(const ksl_vec3f_t *t, const ksl_screwf_t *si,
    ksl_screwf_t *so, ksl_screwf_t *so_bound) {
  const float so_0a = KSL_MULF(t->z, si->m4), so_0b = KSL_MULF(t->y, si->m5),
      so_0 = so_0a - so_0b + si->m0;
  const float so_1a = KSL_MULF(t->x, si->m5), so_1b = KSL_MULF(t->z, si->m3),
      so_1 = so_1a - so_1b + si->m1;
  const float so_2a = KSL_MULF(t->y, si->m3), so_2b = KSL_MULF(t->x, si->m4),
      so_2 = so_2a - so_2b + si->m2;
  const float so_0_size = fabsf(so_0a) + fabsf(so_0b) + fabsf(si->m0),
      so_1_size = fabsf(so_1a) + fabsf(so_1b) + fabsf(si->m1),
      so_2_size = fabsf(so_2a) + fabsf(so_2b) + fabsf(si->m2);
  const float so_0_bound = KSL_MULF(1.7881396e-07f, so_0_size + 1.9721523e-31f),
      so_1_bound = KSL_MULF(1.7881396e-07f, so_1_size + 1.9721523e-31f),
      so_2_bound = KSL_MULF(1.7881396e-07f, so_2_size + 1.9721523e-31f);
  const float si_m3 = si->m3;
  const float si_m4 = si->m4;
  const float si_m5 = si->m5;
  so->m0 = so_0;
  so->m1 = so_1;
  so->m2 = so_2;
  so->m3 = si_m3;
  so->m4 = si_m4;
  so->m5 = si_m5;
  so_bound->m0 = so_0_bound;
  so_bound->m1 = so_1_bound;
  so_bound->m2 = so_2_bound;
  so_bound->m3 = 0.0f;
  so_bound->m4 = 0.0f;
  so_bound->m5 = 0.0f;
}

/* so = [Ad](t) (-si); |error of so| <= so_bound unless inf or NaN.
   t: vector; si, so, so_bound: screw (v in m/s; ω in rad/s).
   9 mul, 15 add, 3 neg, 9 abs. */
static inline void ksl_product_Adtsinvf_certified(const ksl_vec3f_t *t, const ksl_screwf_t *si,
    ksl_screwf_t *so, ksl_screwf_t *so_bound) {
  const float so_0a = KSL_MULF(t->z, si->m4), so_0b = KSL_MULF(t->y, si->m5),
      so_0 = so_0a - so_0b - si->m0;
  const float so_1a = KSL_MULF(t->x, si->m5), so_1b = KSL_MULF(t->z, si->m3),
      so_1 = so_1a - so_1b - si->m1;
  const float so_2a = KSL_MULF(t->y, si->m3), so_2b = KSL_MULF(t->x, si->m4),
      so_2 = so_2a - so_2b - si->m2;
  const float so_3 = -si->m3, so_4 = -si->m4, so_5 = -si->m5;
  const float so_0_size = fabsf(so_0a) + fabsf(so_0b) + fabsf(si->m0),
      so_1_size = fabsf(so_1a) + fabsf(so_1b) + fabsf(si->m1),
      so_2_size = fabsf(so_2a) + fabsf(so_2b) + fabsf(si->m2);
  const float so_0_bound = KSL_MULF(1.7881396e-07f, so_0_size + 1.9721523e-31f),
      so_1_bound = KSL_MULF(1.7881396e-07f, so_1_size + 1.9721523e-31f),
      so_2_bound = KSL_MULF(1.7881396e-07f, so_2_size + 1.9721523e-31f);
  so->m0 = so_0;
  so->m1 = so_1;
  so->m2 = so_2;
  so->m3 = so_3;
  so->m4 = so_4;
  so->m5 = so_5;
  so_bound->m0 = so_0_bound;
  so_bound->m1 = so_1_bound;
  so_bound->m2 = so_2_bound;
  so_bound->m3 = 0.0f;
  so_bound->m4 = 0.0f;
  so_bound->m5 = 0.0f;
}

/* so = [Ad](R) si; |error of so| <= so_bound unless inf or NaN.
   R: rotation or other 3×3 matrix; si, so, so_bound: screw (v in m/s; ω in rad/s).
   24 mul, 30 add, 18 abs. */
static inline void ksl_product_Adrsf_certified(const ksl_mat3x3f_t *R, const ksl_screwf_t *si,
    ksl_screwf_t *so, ksl_screwf_t *so_bound) {
  const float so_0a = KSL_MULF(R->m00, si->m0), so_0b = KSL_MULF(R->m01, si->m1),
      so_0d = KSL_MULF(R->m02, si->m2), so_0 = so_0a + so_0b + so_0d;
  const float so_1a = KSL_MULF(R->m10, si->m0), so_1b = KSL_MULF(R->m11, si->m1),
      so_1d = KSL_MULF(R->m12, si->m2), so_1 = so_1a + so_1b + so_1d;
  const float so_2a = KSL_MULF(R->m20, si->m0), so_2b = KSL_MULF(R->m21, si->m1),
      so_2d = KSL_MULF(R->m22, si->m2), so_2 = so_2a + so_2b + so_2d;
  const float so_3a = KSL_MULF(R->m00, si->m3), so_3b = KSL_MULF(R->m01, si->m4),
      so_3d = KSL_MULF(R->m02, si->m5), so_3 = so_3a + so_3b + so_3d;
  const float so_4a = KSL_MULF(R->m10, si->m3), so_4b = KSL_MULF(R->m11, si->m4),
      so_4d = KSL_MULF(R->m12, si->m5), so_4 = so_4a + so_4b + so_4d;
  const float so_5a = KSL_MULF(R->m20, si->m3), so_5b = KSL_MULF(R->m21, si->m4),
      so_5d = KSL_MULF(R->m22, si->m5), so_5 = so_5a + so_5b + so_5d;
  const float so_0_size = fabsf(so_0a) + fabsf(so_0b) + fabsf(so_0d),
      so_1_size = fabsf(so_1a) + fabsf(so_1b) + fabsf(so_1d),
      so_2_size = fabsf(so_2a) + fabsf(so_2b) + fabsf(so_2d),
      so_3_size = fabsf(so_3a) + fabsf(so_3b) + fabsf(so_3d),
      so_4_size = fabsf(so_4a) + fabsf(so_4b) + fabsf(so_4d),
      so_5_size = fabsf(so_5a) + fabsf(so_5b) + fabsf(so_5d);
  const float so_0_bound = KSL_MULF(1.7881396e-07f, so_0_size + 1.9721523e-31f),
      so_1_bound = KSL_MULF(1.7881396e-07f, so_1_size + 1.9721523e-31f),
      so_2_bound = KSL_MULF(1.7881396e-07f, so_2_size + 1.9721523e-31f),
      so_3_bound = KSL_MULF(1.7881396e-07f, so_3_size + 1.9721523e-31f),
      so_4_bound = KSL_MULF(1.7881396e-07f, so_4_size + 1.9721523e-31f),
      so_5_bound = KSL_MULF(1.7881396e-07f, so_5_size + 1.9721523e-31f);
  so->m0 = so_0;
  so->m1 = so_1;
  so->m2 = so_2;
  so->m3 = so_3;
  so->m4 = so_4;
  so->m5 = so_5;
  so_bound->m0 = so_0_bound;
  so_bound->m1 = so_1_bound;
  so_bound->m2 = so_2_bound;
  so_bound->m3 = so_3_bound;
  so_bound->m4 = so_4_bound;
  so_bound->m5 = so_5_bound;
}

/* so = [Ad](R)^-1 si; |error of so| <= so_bound unless inf or NaN.
   R: rotation or other 3×3 matrix; si, so, so_bound: screw (v in m/s; ω in rad/s).
   24 mul, 30 add, 18 abs. */
static inline void ksl_product_Adrinvsf_certified(const ksl_mat3x3f_t *R, const ksl_screwf_t *si,
    ksl_screwf_t *so, ksl_screwf_t *so_bound) {
  const float so_0a = KSL_MULF(R->m00, si->m0), so_0b = KSL_MULF(R->m10, si->m1),
      so_0d = KSL_MULF(R->m20, si->m2), so_0 = so_0a + so_0b + so_0d;
  const float so_1a = KSL_MULF(R->m01, si->m0), so_1b = KSL_MULF(R->m11, si->m1),
      so_1d = KSL_MULF(R->m21, si->m2), so_1 = so_1a + so_1b + so_1d;
  const float so_2a = KSL_MULF(R->m02, si->m0), so_2b = KSL_MULF(R->m12, si->m1),
      so_2d = KSL_MULF(R->m22, si->m2), so_2 = so_2a + so_2b + so_2d;
  const float so_3a = KSL_MULF(R->m00, si->m3), so_3b = KSL_MULF(R->m10, si->m4),
      so_3d = KSL_MULF(R->m20, si->m5), so_3 = so_3a + so_3b + so_3d;
  const float so_4a = KSL_MULF(R->m01, si->m3), so_4b = KSL_MULF(R->m11, si->m4),
      so_4d = KSL_MULF(R->m21, si->m5), so_4 = so_4a + so_4b + so_4d;
  const float so_5a = KSL_MULF(R->m02, si->m3), so_5b = KSL_MULF(R->m12, si->m4),
      so_5d = KSL_MULF(R->m22, si->m5), so_5 = so_5a + so_5b + so_5d;
  const float so_0_size = fabsf(so_0a) + fabsf(so_0b) + fabsf(so_0d),
      so_1_size = fabsf(so_1a) + fabsf(so_1b) + fabsf(so_1d),
      so_2_size = fabsf(so_2a) + fabsf(so_2b) + fabsf(so_2d),
      so_3_size = fabsf(so_3a) + fabsf(so_3b) + fabsf(so_3d),
      so_4_size = fabsf(so_4a) + fabsf(so_4b) + fabsf(so_4d),
      so_5_size = fabsf(so_5a) + fabsf(so_5b) + fabsf(so_5d);
  const float so_0_bound = KSL_MULF(1.7881396e-07f, so_0_size + 1.9721523e-31f),
      so_1_bound = KSL_MULF(1.7881396e-07f, so_1_size + 1.9721523e-31f),
      so_2_bound = KSL_MULF(1.7881396e-07f, so_2_size + 1.9721523e-31f),
      so_3_bound = KSL_MULF(1.7881396e-07f, so_3_size + 1.9721523e-31f),
      so_4_bound = KSL_MULF(1.7881396e-07f, so_4_size + 1.9721523e-31f),
      so_5_bound = KSL_MULF(1.7881396e-07f, so_5_size + 1.9721523e-31f);
  so->m0 = so_0;
  so->m1 = so_1;
  so->m2 = so_2;
  so->m3 = so_3;
  so->m4 = so_4;
  so->m5 = so_5;
  so_bound->m0 = so_0_bound;
  so_bound->m1 = so_1_bound;
  so_bound->m2 = so_2_bound;
  so_bound->m3 = so_3_bound;
  so_bound->m4 = so_4_bound;
  so_bound->m5 = so_5_bound;
}

/* so = [Ad](R) (-si); |error of so| <= so_bound unless inf or NaN.
   R: rotation or other 3×3 matrix; si, so, so_bound: screw (v in m/s; ω in rad/s).
   24 mul, 30 add, 6 neg, 18 abs. */
static inline void ksl_product_Adrsinvf_certified(const ksl_mat3x3f_t *R, const ksl_screwf_t *si,
    ksl_screwf_t *so, ksl_screwf_t *so_bound) {
  const float so_0a = KSL_MULF(R->m00, si->m0), so_0b = KSL_MULF(R->m01, si->m1),
      so_0d = KSL_MULF(R->m02, si->m2), so_0 = -(so_0a + so_0b + so_0d);
  const float so_1a = KSL_MULF(R->m10, si->m0), so_1b = KSL_MULF(R->m11, si->m1),
      so_1d = KSL_MULF(R->m12, si->m2), so_1 = -(so_1a + so_1b + so_1d);
  const float so_2a = KSL_MULF(R->m20, si->m0), so_2b = KSL_MULF(R->m21, si->m1),
      so_2d = KSL_MULF(R->m22, si->m2), so_2 = -(so_2a + so_2b + so_2d);
  const float so_3a = KSL_MULF(R->m00, si->m3), so_3b = KSL_MULF(R->m01, si->m4),
      so_3d = KSL_MULF(R->m02, si->m5), so_3 = -(so_3a + so_3b + so_3d);
  const float so_4a = KSL_MULF(R->m10, si->m3), so_4b = KSL_MULF(R->m11, si->m4),
      so_4d = KSL_MULF(R->m12, si->m5), so_4 = -(so_4a + so_4b + so_4d);
  const float so_5a = KSL_MULF(R->m20, si->m3), so_5b = KSL_MULF(R->m21, si->m4),
      so_5d = KSL_MULF(R->m22, si->m5), so_5 = -(so_5a + so_5b + so_5d);
  const float so_0e_bound = KSL_MULF(1.7881396e-07f, fabsf(so_0a) + fabsf(so_0b) + fabsf(so_0d)
          + 1.9721523e-31f);
  const float so_1e_bound = KSL_MULF(1.7881396e-07f, fabsf(so_1a) + fabsf(so_1b) + fabsf(so_1d)
          + 1.9721523e-31f);
  const float so_2e_bound = KSL_MULF(1.7881396e-07f, fabsf(so_2a) + fabsf(so_2b) + fabsf(so_2d)
          + 1.9721523e-31f);
  const float so_3e_bound = KSL_MULF(1.7881396e-07f, fabsf(so_3a) + fabsf(so_3b) + fabsf(so_3d)
          + 1.9721523e-31f);
  const float so_4e_bound = KSL_MULF(1.7881396e-07f, fabsf(so_4a) + fabsf(so_4b) + fabsf(so_4d)
          + 1.9721523e-31f);
  const float so_5e_bound = KSL_MULF(1.7881396e-07f, fabsf(so_5a) + fabsf(so_5b) + fabsf(so_5d)
          + 1.9721523e-31f);
  so->m0 = so_0;
  so->m1 = so_1;
  so->m2 = so_2;
  so->m3 = so_3;
  so->m4 = so_4;
  so->m5 = so_5;
  so_bound->m0 = so_0e_bound;
  so_bound->m1 = so_1e_bound;
  so_bound->m2 = so_2e_bound;
  so_bound->m3 = so_3e_bound;
  so_bound->m4 = so_4e_bound;
  so_bound->m5 = so_5e_bound;
}

/* so = [Ad](D) si = [Ad](t) [Ad](R) si; |error of so| <= so_bound unless inf or NaN.
   D: displacement [R | t], R rotation, t in m; si, so, so_bound: screw (v in m/s; ω in rad/s).
   36 mul, 42 add, 21 abs. */
static inline void ksl_product_Adsf_certified(const ksl_SE3f_t *D, const ksl_screwf_t *si,
    ksl_screwf_t *so, ksl_screwf_t *so_bound) {
  const float w_0a = KSL_MULF(D->m00, si->m0), w_0b = KSL_MULF(D->m01, si->m1),
      w_0d = KSL_MULF(D->m02, si->m2), w_0 = w_0a + w_0b + w_0d;
  const float w_1a = KSL_MULF(D->m10, si->m0), w_1b = KSL_MULF(D->m11, si->m1),
      w_1d = KSL_MULF(D->m12, si->m2), w_1 = w_1a + w_1b + w_1d;
  const float w_2a = KSL_MULF(D->m20, si->m0), w_2b = KSL_MULF(D->m21, si->m1),
      w_2d = KSL_MULF(D->m22, si->m2), w_2 = w_2a + w_2b + w_2d;
  const float w_3a = KSL_MULF(D->m00, si->m3), w_3b = KSL_MULF(D->m01, si->m4),
      w_3d = KSL_MULF(D->m02, si->m5), w_3 = w_3a + w_3b + w_3d;
  const float w_4a = KSL_MULF(D->m10, si->m3), w_4b = KSL_MULF(D->m11, si->m4),
      w_4d = KSL_MULF(D->m12, si->m5), w_4 = w_4a + w_4b + w_4d;
  const float w_5a = KSL_MULF(D->m20, si->m3), w_5b = KSL_MULF(D->m21, si->m4),
      w_5d = KSL_MULF(D->m22, si->m5), w_5 = w_5a + w_5b + w_5d;
  const float so_0 = KSL_MULF(D->m13, w_5) - KSL_MULF(D->m23, w_4) + w_0;
  const float so_1 = KSL_MULF(D->m23, w_3) - KSL_MULF(D->m03, w_5) + w_1;
  const float so_2 = KSL_MULF(D->m03, w_4) - KSL_MULF(D->m13, w_3) + w_2;
  const float w_0_size = fabsf(w_0a) + fabsf(w_0b) + fabsf(w_0d),
      w_1_size = fabsf(w_1a) + fabsf(w_1b) + fabsf(w_1d),
      w_2_size = fabsf(w_2a) + fabsf(w_2b) + fabsf(w_2d),
      w_3_size = fabsf(w_3a) + fabsf(w_3b) + fabsf(w_3d),
      w_4_size = fabsf(w_4a) + fabsf(w_4b) + fabsf(w_4d),
      w_5_size = fabsf(w_5a) + fabsf(w_5b) + fabsf(w_5d);
  const float w_5_padded = w_5_size + 1.9721523e-31f;
  const float D_13_abs = fabsf(D->m13);
  const float w_4_padded = w_4_size + 1.9721523e-31f;
  const float D_23_abs = fabsf(D->m23),
      so_0_size = KSL_MULF(D_13_abs, w_5_padded) + KSL_MULF(D_23_abs, w_4_padded) + w_0_size;
  const float w_3_padded = w_3_size + 1.9721523e-31f;
  const float D_03_abs = fabsf(D->m03),
      so_1_size = KSL_MULF(D_23_abs, w_3_padded) + KSL_MULF(D_03_abs, w_5_padded) + w_1_size;
  const float so_2_size = KSL_MULF(D_03_abs, w_4_padded) + KSL_MULF(D_13_abs, w_3_padded)
          + w_2_size;
  const float so_0_bound = KSL_MULF(3.5762795e-07f, so_0_size + 1.9721523e-31f),
      so_1_bound = KSL_MULF(3.5762795e-07f, so_1_size + 1.9721523e-31f),
      so_2_bound = KSL_MULF(3.5762795e-07f, so_2_size + 1.9721523e-31f);
  const float w_3_bound = KSL_MULF(1.7881396e-07f, w_3_padded),
      w_4_bound = KSL_MULF(1.7881396e-07f, w_4_padded),
      w_5_bound = KSL_MULF(1.7881396e-07f, w_5_padded);
  so->m0 = so_0;
  so->m1 = so_1;
  so->m2 = so_2;
  so->m3 = w_3;
  so->m4 = w_4;
  so->m5 = w_5;
  so_bound->m0 = so_0_bound;
  so_bound->m1 = so_1_bound;
  so_bound->m2 = so_2_bound;
  so_bound->m3 = w_3_bound;
  so_bound->m4 = w_4_bound;
  so_bound->m5 = w_5_bound;
}

/* so = [Ad](D)^-1 si = [Ad](R^T) [Ad](-t) si; |error of so| <= so_bound unless inf or NaN.
   D: displacement [R | t], R rotation, t in m; si, so, so_bound: screw (v in m/s; ω in rad/s).
   39 mul, 45 add, 27 abs. */
static inline void ksl_product_Adinvsf_certified(const ksl_SE3f_t *D, const ksl_screwf_t *si,
    ksl_screwf_t *so, ksl_screwf_t *so_bound) {
  const float w_0a = KSL_MULF(D->m23, si->m4), w_0b = KSL_MULF(D->m13, si->m5),
      w_0 = w_0a - w_0b + si->m0;
  const float w_1a = KSL_MULF(D->m03, si->m5), w_1b = KSL_MULF(D->m23, si->m3),
      w_1 = w_1a - w_1b + si->m1;
  const float w_2a = KSL_MULF(D->m13, si->m3), w_2b = KSL_MULF(D->m03, si->m4),
      w_2 = w_2a - w_2b + si->m2;
  const float so_0 = KSL_MULF(D->m00, w_0) + KSL_MULF(D->m10, w_1) + KSL_MULF(D->m20, w_2);
  const float so_1 = KSL_MULF(D->m01, w_0) + KSL_MULF(D->m11, w_1) + KSL_MULF(D->m21, w_2),
      so_2 = KSL_MULF(D->m02, w_0) + KSL_MULF(D->m12, w_1) + KSL_MULF(D->m22, w_2);
  const float so_3a = KSL_MULF(D->m00, si->m3), so_3b = KSL_MULF(D->m10, si->m4),
      so_3d = KSL_MULF(D->m20, si->m5), so_3 = so_3a + so_3b + so_3d;
  const float so_4a = KSL_MULF(D->m01, si->m3), so_4b = KSL_MULF(D->m11, si->m4),
      so_4d = KSL_MULF(D->m21, si->m5), so_4 = so_4a + so_4b + so_4d;
  const float so_5a = KSL_MULF(D->m02, si->m3), so_5b = KSL_MULF(D->m12, si->m4),
      so_5d = KSL_MULF(D->m22, si->m5), so_5 = so_5a + so_5b + so_5d;
  const float w_0_size = fabsf(w_0a) + fabsf(w_0b) + fabsf(si->m0),
      w_1_size = fabsf(w_1a) + fabsf(w_1b) + fabsf(si->m1),
      w_2_size = fabsf(w_2a) + fabsf(w_2b) + fabsf(si->m2);
  const float w_0_padded = w_0_size + 1.9721523e-31f, w_1_padded = w_1_size + 1.9721523e-31f,
      w_2_padded = w_2_size + 1.9721523e-31f;
  const float so_0_size = KSL_MULF(fabsf(D->m00), w_0_padded) + KSL_MULF(fabsf(D->m10), w_1_padded)
          + KSL_MULF(fabsf(D->m20), w_2_padded),
      so_1_size = KSL_MULF(fabsf(D->m01), w_0_padded) + KSL_MULF(fabsf(D->m11), w_1_padded)
          + KSL_MULF(fabsf(D->m21), w_2_padded),
      so_2_size = KSL_MULF(fabsf(D->m02), w_0_padded) + KSL_MULF(fabsf(D->m12), w_1_padded)
          + KSL_MULF(fabsf(D->m22), w_2_padded),
      so_3_size = fabsf(so_3a) + fabsf(so_3b) + fabsf(so_3d),
      so_4_size = fabsf(so_4a) + fabsf(so_4b) + fabsf(so_4d),
      so_5_size = fabsf(so_5a) + fabsf(so_5b) + fabsf(so_5d);
  const float so_0_bound = KSL_MULF(3.5762795e-07f, so_0_size + 1.9721523e-31f),
      so_1_bound = KSL_MULF(3.5762795e-07f, so_1_size + 1.9721523e-31f),
      so_2_bound = KSL_MULF(3.5762795e-07f, so_2_size + 1.9721523e-31f),
      so_3_bound = KSL_MULF(1.7881396e-07f, so_3_size + 1.9721523e-31f),
      so_4_bound = KSL_MULF(1.7881396e-07f, so_4_size + 1.9721523e-31f),
      so_5_bound = KSL_MULF(1.7881396e-07f, so_5_size + 1.9721523e-31f);
  so->m0 = so_0;
  so->m1 = so_1;
  so->m2 = so_2;
  so->m3 = so_3;
  so->m4 = so_4;
  so->m5 = so_5;
  so_bound->m0 = so_0_bound;
  so_bound->m1 = so_1_bound;
  so_bound->m2 = so_2_bound;
  so_bound->m3 = so_3_bound;
  so_bound->m4 = so_4_bound;
  so_bound->m5 = so_5_bound;
}

/* so = [Ad](D) (-si); |error of so| <= so_bound unless inf or NaN.
   D: displacement [R | t], R rotation, t in m; si, so, so_bound: screw (v in m/s; ω in rad/s).
   36 mul, 42 add, 6 neg, 21 abs. */
static inline void ksl_product_Adsinvf_certified(const ksl_SE3f_t *D, const ksl_screwf_t *si,
    ksl_screwf_t *so, ksl_screwf_t *so_bound) {
  const float w_0a = KSL_MULF(D->m00, si->m0), w_0b = KSL_MULF(D->m01, si->m1),
      w_0d = KSL_MULF(D->m02, si->m2), w_0 = -(w_0a + w_0b + w_0d);
  const float w_1a = KSL_MULF(D->m10, si->m0), w_1b = KSL_MULF(D->m11, si->m1),
      w_1d = KSL_MULF(D->m12, si->m2), w_1 = -(w_1a + w_1b + w_1d);
  const float w_2a = KSL_MULF(D->m20, si->m0), w_2b = KSL_MULF(D->m21, si->m1),
      w_2d = KSL_MULF(D->m22, si->m2), w_2 = -(w_2a + w_2b + w_2d);
  const float w_3a = KSL_MULF(D->m00, si->m3), w_3b = KSL_MULF(D->m01, si->m4),
      w_3d = KSL_MULF(D->m02, si->m5), w_3 = -(w_3a + w_3b + w_3d);
  const float w_4a = KSL_MULF(D->m10, si->m3), w_4b = KSL_MULF(D->m11, si->m4),
      w_4d = KSL_MULF(D->m12, si->m5), w_4 = -(w_4a + w_4b + w_4d);
  const float w_5a = KSL_MULF(D->m20, si->m3), w_5b = KSL_MULF(D->m21, si->m4),
      w_5d = KSL_MULF(D->m22, si->m5), w_5 = -(w_5a + w_5b + w_5d);
  const float so_0 = KSL_MULF(D->m13, w_5) - KSL_MULF(D->m23, w_4) + w_0;
  const float so_1 = KSL_MULF(D->m23, w_3) - KSL_MULF(D->m03, w_5) + w_1;
  const float so_2 = KSL_MULF(D->m03, w_4) - KSL_MULF(D->m13, w_3) + w_2;
  const float w_5e_padded = fabsf(w_5a) + fabsf(w_5b) + fabsf(w_5d) + 1.9721523e-31f;
  const float D_13_abs = fabsf(D->m13);
  const float w_4e_padded = fabsf(w_4a) + fabsf(w_4b) + fabsf(w_4d) + 1.9721523e-31f;
  const float D_23_abs = fabsf(D->m23),
      so_0_size = KSL_MULF(D_13_abs, w_5e_padded) + KSL_MULF(D_23_abs, w_4e_padded)
          + (fabsf(w_0a) + fabsf(w_0b) + fabsf(w_0d));
  const float w_3e_padded = fabsf(w_3a) + fabsf(w_3b) + fabsf(w_3d) + 1.9721523e-31f;
  const float D_03_abs = fabsf(D->m03),
      so_1_size = KSL_MULF(D_23_abs, w_3e_padded) + KSL_MULF(D_03_abs, w_5e_padded)
          + (fabsf(w_1a) + fabsf(w_1b) + fabsf(w_1d));
  const float so_2_size = KSL_MULF(D_03_abs, w_4e_padded) + KSL_MULF(D_13_abs, w_3e_padded)
          + (fabsf(w_2a) + fabsf(w_2b) + fabsf(w_2d));
  const float so_0_bound = KSL_MULF(3.5762795e-07f, so_0_size + 1.9721523e-31f),
      so_1_bound = KSL_MULF(3.5762795e-07f, so_1_size + 1.9721523e-31f),
      so_2_bound = KSL_MULF(3.5762795e-07f, so_2_size + 1.9721523e-31f);
  const float w_3e_bound = KSL_MULF(1.7881396e-07f, w_3e_padded);
  const float w_4e_bound = KSL_MULF(1.7881396e-07f, w_4e_padded);
  const float w_5e_bound = KSL_MULF(1.7881396e-07f, w_5e_padded);
  so->m0 = so_0;
  so->m1 = so_1;
  so->m2 = so_2;
  so->m3 = w_3;
  so->m4 = w_4;
  so->m5 = w_5;
  so_bound->m0 = so_0_bound;
  so_bound->m1 = so_1_bound;
  so_bound->m2 = so_2_bound;
  so_bound->m3 = w_3e_bound;
  so_bound->m4 = w_4e_bound;
  so_bound->m5 = w_5e_bound;
}

/* so = h_rx: column 3 of [Ad](D); |error of so| <= so_bound unless inf or NaN.
   D: displacement [R | t], R rotation, t in m; so, so_bound: screw (v in m/s; ω in rad/s).
   9 mul, 9 add, 6 abs. */
static inline void ksl_hsrxf_certified(const ksl_SE3f_t *D, ksl_screwf_t *so,
    ksl_screwf_t *so_bound) {
  const float so_0a = KSL_MULF(D->m20, D->m13), so_0b = KSL_MULF(D->m10, D->m23),
      so_0 = so_0a - so_0b;
  const float so_1a = KSL_MULF(D->m00, D->m23), so_1b = KSL_MULF(D->m20, D->m03),
      so_1 = so_1a - so_1b;
  const float so_2a = KSL_MULF(D->m10, D->m03), so_2b = KSL_MULF(D->m00, D->m13),
      so_2 = so_2a - so_2b;
  const float so_0_size = fabsf(so_0a) + fabsf(so_0b), so_1_size = fabsf(so_1a) + fabsf(so_1b),
      so_2_size = fabsf(so_2a) + fabsf(so_2b);
  const float so_0_bound = KSL_MULF(1.192093e-07f, so_0_size + 1.9721523e-31f),
      so_1_bound = KSL_MULF(1.192093e-07f, so_1_size + 1.9721523e-31f),
      so_2_bound = KSL_MULF(1.192093e-07f, so_2_size + 1.9721523e-31f);
  const float D_m00 = D->m00;
  const float D_m10 = D->m10;
  const float D_m20 = D->m20;
  so->m0 = so_0;
  so->m1 = so_1;
  so->m2 = so_2;
  so->m3 = D_m00;
  so->m4 = D_m10;
  so->m5 = D_m20;
  so_bound->m0 = so_0_bound;
  so_bound->m1 = so_1_bound;
  so_bound->m2 = so_2_bound;
  so_bound->m3 = 0.0f;
  so_bound->m4 = 0.0f;
  so_bound->m5 = 0.0f;
}

/* so = h_ry: column 4 of [Ad](D); |error of so| <= so_bound unless inf or NaN.
   D: displacement [R | t], R rotation, t in m; so, so_bound: screw (v in m/s; ω in rad/s).
   9 mul, 9 add, 6 abs. */
static inline void ksl_hsryf_certified(const ksl_SE3f_t *D, ksl_screwf_t *so,
    ksl_screwf_t *so_bound) {
  const float so_0a = KSL_MULF(D->m21, D->m13), so_0b = KSL_MULF(D->m11, D->m23),
      so_0 = so_0a - so_0b;
  const float so_1a = KSL_MULF(D->m01, D->m23), so_1b = KSL_MULF(D->m21, D->m03),
      so_1 = so_1a - so_1b;
  const float so_2a = KSL_MULF(D->m11, D->m03), so_2b = KSL_MULF(D->m01, D->m13),
      so_2 = so_2a - so_2b;
  const float so_0_size = fabsf(so_0a) + fabsf(so_0b), so_1_size = fabsf(so_1a) + fabsf(so_1b),
      so_2_size = fabsf(so_2a) + fabsf(so_2b);
  const float so_0_bound = KSL_MULF(1.192093e-07f, so_0_size + 1.9721523e-31f),
      so_1_bound = KSL_MULF(1.192093e-07f, so_1_size + 1.9721523e-31f),
      so_2_bound = KSL_MULF(1.192093e-07f, so_2_size + 1.9721523e-31f);
  const float D_m01 = D->m01;
  const float D_m11 = D->m11;
  const float D_m21 = D->m21;
  so->m0 = so_0;
  so->m1 = so_1;
  so->m2 = so_2;
  so->m3 = D_m01;
  so->m4 = D_m11;
  so->m5 = D_m21;
  so_bound->m0 = so_0_bound;
  so_bound->m1 = so_1_bound;
  so_bound->m2 = so_2_bound;
  so_bound->m3 = 0.0f;
  so_bound->m4 = 0.0f;
  so_bound->m5 = 0.0f;
}

/* so = h_rz: column 5 of [Ad](D); |error of so| <= so_bound unless inf or NaN.
   D: displacement [R | t], R rotation, t in m; so, so_bound: screw (v in m/s; ω in rad/s).
   9 mul, 9 add, 6 abs. */
static inline void ksl_hsrzf_certified(const ksl_SE3f_t *D, ksl_screwf_t *so,
    ksl_screwf_t *so_bound) {
  const float so_0a = KSL_MULF(D->m22, D->m13), so_0b = KSL_MULF(D->m12, D->m23),
      so_0 = so_0a - so_0b;
  const float so_1a = KSL_MULF(D->m02, D->m23), so_1b = KSL_MULF(D->m22, D->m03),
      so_1 = so_1a - so_1b;
  const float so_2a = KSL_MULF(D->m12, D->m03), so_2b = KSL_MULF(D->m02, D->m13),
      so_2 = so_2a - so_2b;
  const float so_0_size = fabsf(so_0a) + fabsf(so_0b), so_1_size = fabsf(so_1a) + fabsf(so_1b),
      so_2_size = fabsf(so_2a) + fabsf(so_2b);
  const float so_0_bound = KSL_MULF(1.192093e-07f, so_0_size + 1.9721523e-31f),
      so_1_bound = KSL_MULF(1.192093e-07f, so_1_size + 1.9721523e-31f),
      so_2_bound = KSL_MULF(1.192093e-07f, so_2_size + 1.9721523e-31f);
  const float D_m02 = D->m02;
  const float D_m12 = D->m12;
  const float D_m22 = D->m22;
  so->m0 = so_0;
  so->m1 = so_1;
  so->m2 = so_2;
  so->m3 = D_m02;
  so->m4 = D_m12;
  so->m5 = D_m22;
  so_bound->m0 = so_0_bound;
  so_bound->m1 = so_1_bound;
  so_bound->m2 = so_2_bound;
  so_bound->m3 = 0.0f;
  so_bound->m4 = 0.0f;
  so_bound->m5 = 0.0f;
}

/* so = -h_rx: -column 3 of [Ad](D); |error of so| <= so_bound unless inf or NaN.
   D: displacement [R | t], R rotation, t in m; so, so_bound: screw (v in m/s; ω in rad/s).
   9 mul, 9 add, 3 neg, 6 abs. */
static inline void ksl_hsrxinvf_certified(const ksl_SE3f_t *D, ksl_screwf_t *so,
    ksl_screwf_t *so_bound) {
  const float so_0a = KSL_MULF(D->m10, D->m23), so_0b = KSL_MULF(D->m20, D->m13),
      so_0 = so_0a - so_0b;
  const float so_1a = KSL_MULF(D->m20, D->m03), so_1b = KSL_MULF(D->m00, D->m23),
      so_1 = so_1a - so_1b;
  const float so_2a = KSL_MULF(D->m00, D->m13), so_2b = KSL_MULF(D->m10, D->m03),
      so_2 = so_2a - so_2b;
  const float so_3 = -D->m00, so_4 = -D->m10, so_5 = -D->m20;
  const float so_0_size = fabsf(so_0a) + fabsf(so_0b), so_1_size = fabsf(so_1a) + fabsf(so_1b),
      so_2_size = fabsf(so_2a) + fabsf(so_2b);
  const float so_0_bound = KSL_MULF(1.192093e-07f, so_0_size + 1.9721523e-31f),
      so_1_bound = KSL_MULF(1.192093e-07f, so_1_size + 1.9721523e-31f),
      so_2_bound = KSL_MULF(1.192093e-07f, so_2_size + 1.9721523e-31f);
  so->m0 = so_0;
  so->m1 = so_1;
  so->m2 = so_2;
  so->m3 = so_3;
  so->m4 = so_4;
  so->m5 = so_5;
  so_bound->m0 = so_0_bound;
  so_bound->m1 = so_1_bound;
  so_bound->m2 = so_2_bound;
  so_bound->m3 = 0.0f;
  so_bound->m4 = 0.0f;
  so_bound->m5 = 0.0f;
}

/* so = -h_ry: -column 4 of [Ad](D); |error of so| <= so_bound unless inf or NaN.
   D: displacement [R | t], R rotation, t in m; so, so_bound: screw (v in m/s; ω in rad/s).
   9 mul, 9 add, 3 neg, 6 abs. */
static inline void ksl_hsryinvf_certified(const ksl_SE3f_t *D, ksl_screwf_t *so,
    ksl_screwf_t *so_bound) {
  const float so_0a = KSL_MULF(D->m11, D->m23), so_0b = KSL_MULF(D->m21, D->m13),
      so_0 = so_0a - so_0b;
  const float so_1a = KSL_MULF(D->m21, D->m03), so_1b = KSL_MULF(D->m01, D->m23),
      so_1 = so_1a - so_1b;
  const float so_2a = KSL_MULF(D->m01, D->m13), so_2b = KSL_MULF(D->m11, D->m03),
      so_2 = so_2a - so_2b;
  const float so_3 = -D->m01, so_4 = -D->m11, so_5 = -D->m21;
  const float so_0_size = fabsf(so_0a) + fabsf(so_0b), so_1_size = fabsf(so_1a) + fabsf(so_1b),
      so_2_size = fabsf(so_2a) + fabsf(so_2b);
  const float so_0_bound = KSL_MULF(1.192093e-07f, so_0_size + 1.9721523e-31f),
      so_1_bound = KSL_MULF(1.192093e-07f, so_1_size + 1.9721523e-31f),
      so_2_bound = KSL_MULF(1.192093e-07f, so_2_size + 1.9721523e-31f);
  so->m0 = so_0;
  so->m1 = so_1;
  so->m2 = so_2;
  so->m3 = so_3;
  so->m4 = so_4;
  so->m5 = so_5;
  so_bound->m0 = so_0_bound;
  so_bound->m1 = so_1_bound;
  so_bound->m2 = so_2_bound;
  so_bound->m3 = 0.0f;
  so_bound->m4 = 0.0f;
  so_bound->m5 = 0.0f;
}

/* so = -h_rz: -column 5 of [Ad](D); |error of so| <= so_bound unless inf or NaN.
   D: displacement [R | t], R rotation, t in m; so, so_bound: screw (v in m/s; ω in rad/s).
   9 mul, 9 add, 3 neg, 6 abs. */
static inline void ksl_hsrzinvf_certified(const ksl_SE3f_t *D, ksl_screwf_t *so,
    ksl_screwf_t *so_bound) {
  const float so_0a = KSL_MULF(D->m12, D->m23), so_0b = KSL_MULF(D->m22, D->m13),
      so_0 = so_0a - so_0b;
  const float so_1a = KSL_MULF(D->m22, D->m03), so_1b = KSL_MULF(D->m02, D->m23),
      so_1 = so_1a - so_1b;
  const float so_2a = KSL_MULF(D->m02, D->m13), so_2b = KSL_MULF(D->m12, D->m03),
      so_2 = so_2a - so_2b;
  const float so_3 = -D->m02, so_4 = -D->m12, so_5 = -D->m22;
  const float so_0_size = fabsf(so_0a) + fabsf(so_0b), so_1_size = fabsf(so_1a) + fabsf(so_1b),
      so_2_size = fabsf(so_2a) + fabsf(so_2b);
  const float so_0_bound = KSL_MULF(1.192093e-07f, so_0_size + 1.9721523e-31f),
      so_1_bound = KSL_MULF(1.192093e-07f, so_1_size + 1.9721523e-31f),
      so_2_bound = KSL_MULF(1.192093e-07f, so_2_size + 1.9721523e-31f);
  so->m0 = so_0;
  so->m1 = so_1;
  so->m2 = so_2;
  so->m3 = so_3;
  so->m4 = so_4;
  so->m5 = so_5;
  so_bound->m0 = so_0_bound;
  so_bound->m1 = so_1_bound;
  so_bound->m2 = so_2_bound;
  so_bound->m3 = 0.0f;
  so_bound->m4 = 0.0f;
  so_bound->m5 = 0.0f;
}

/* M = [Ad](D); |error of M| <= M_bound unless inf or NaN.
   D: displacement [R | t], R rotation, t in m; M, M_bound: 6×6 operator.
   27 mul, 27 add, 18 abs. */
static inline void ksl_Adf_certified(const ksl_SE3f_t *D, ksl_mat6x6f_t *M,
    ksl_mat6x6f_t *M_bound) {
  const float M_03a = KSL_MULF(D->m20, D->m13), M_03b = KSL_MULF(D->m10, D->m23),
      M_03 = M_03a - M_03b;
  const float M_04a = KSL_MULF(D->m21, D->m13), M_04b = KSL_MULF(D->m11, D->m23),
      M_04 = M_04a - M_04b;
  const float M_05a = KSL_MULF(D->m22, D->m13), M_05b = KSL_MULF(D->m12, D->m23),
      M_05 = M_05a - M_05b;
  const float M_13a = KSL_MULF(D->m00, D->m23), M_13b = KSL_MULF(D->m20, D->m03),
      M_13 = M_13a - M_13b;
  const float M_14a = KSL_MULF(D->m01, D->m23), M_14b = KSL_MULF(D->m21, D->m03),
      M_14 = M_14a - M_14b;
  const float M_15a = KSL_MULF(D->m02, D->m23), M_15b = KSL_MULF(D->m22, D->m03),
      M_15 = M_15a - M_15b;
  const float M_23a = KSL_MULF(D->m10, D->m03), M_23b = KSL_MULF(D->m00, D->m13),
      M_23 = M_23a - M_23b;
  const float M_24a = KSL_MULF(D->m11, D->m03), M_24b = KSL_MULF(D->m01, D->m13),
      M_24 = M_24a - M_24b;
  const float M_25a = KSL_MULF(D->m12, D->m03), M_25b = KSL_MULF(D->m02, D->m13),
      M_25 = M_25a - M_25b;
  const float M_03_size = fabsf(M_03a) + fabsf(M_03b), M_04_size = fabsf(M_04a) + fabsf(M_04b),
      M_05_size = fabsf(M_05a) + fabsf(M_05b), M_13_size = fabsf(M_13a) + fabsf(M_13b),
      M_14_size = fabsf(M_14a) + fabsf(M_14b), M_15_size = fabsf(M_15a) + fabsf(M_15b),
      M_23_size = fabsf(M_23a) + fabsf(M_23b), M_24_size = fabsf(M_24a) + fabsf(M_24b),
      M_25_size = fabsf(M_25a) + fabsf(M_25b);
  const float M_03_bound = KSL_MULF(1.192093e-07f, M_03_size + 1.9721523e-31f),
      M_04_bound = KSL_MULF(1.192093e-07f, M_04_size + 1.9721523e-31f),
      M_05_bound = KSL_MULF(1.192093e-07f, M_05_size + 1.9721523e-31f),
      M_13_bound = KSL_MULF(1.192093e-07f, M_13_size + 1.9721523e-31f),
      M_14_bound = KSL_MULF(1.192093e-07f, M_14_size + 1.9721523e-31f),
      M_15_bound = KSL_MULF(1.192093e-07f, M_15_size + 1.9721523e-31f),
      M_23_bound = KSL_MULF(1.192093e-07f, M_23_size + 1.9721523e-31f),
      M_24_bound = KSL_MULF(1.192093e-07f, M_24_size + 1.9721523e-31f),
      M_25_bound = KSL_MULF(1.192093e-07f, M_25_size + 1.9721523e-31f);
  const float D_m00 = D->m00;
  const float D_m01 = D->m01;
  const float D_m02 = D->m02;
  const float D_m10 = D->m10;
  const float D_m11 = D->m11;
  const float D_m12 = D->m12;
  const float D_m20 = D->m20;
  const float D_m21 = D->m21;
  const float D_m22 = D->m22;
  M->at[0][0] = D_m00;
  M->at[1][0] = D_m01;
  M->at[2][0] = D_m02;
  M->at[3][0] = M_03;
  M->at[4][0] = M_04;
  M->at[5][0] = M_05;
  M->at[0][1] = D_m10;
  M->at[1][1] = D_m11;
  M->at[2][1] = D_m12;
  M->at[3][1] = M_13;
  M->at[4][1] = M_14;
  M->at[5][1] = M_15;
  M->at[0][2] = D_m20;
  M->at[1][2] = D_m21;
  M->at[2][2] = D_m22;
  M->at[3][2] = M_23;
  M->at[4][2] = M_24;
  M->at[5][2] = M_25;
  M->at[0][3] = 0.0f;
  M->at[1][3] = 0.0f;
  M->at[2][3] = 0.0f;
  M->at[3][3] = D_m00;
  M->at[4][3] = D_m01;
  M->at[5][3] = D_m02;
  M->at[0][4] = 0.0f;
  M->at[1][4] = 0.0f;
  M->at[2][4] = 0.0f;
  M->at[3][4] = D_m10;
  M->at[4][4] = D_m11;
  M->at[5][4] = D_m12;
  M->at[0][5] = 0.0f;
  M->at[1][5] = 0.0f;
  M->at[2][5] = 0.0f;
  M->at[3][5] = D_m20;
  M->at[4][5] = D_m21;
  M->at[5][5] = D_m22;
  M_bound->at[0][0] = 0.0f;
  M_bound->at[1][0] = 0.0f;
  M_bound->at[2][0] = 0.0f;
  M_bound->at[3][0] = M_03_bound;
  M_bound->at[4][0] = M_04_bound;
  M_bound->at[5][0] = M_05_bound;
  M_bound->at[0][1] = 0.0f;
  M_bound->at[1][1] = 0.0f;
  M_bound->at[2][1] = 0.0f;
  M_bound->at[3][1] = M_13_bound;
  M_bound->at[4][1] = M_14_bound;
  M_bound->at[5][1] = M_15_bound;
  M_bound->at[0][2] = 0.0f;
  M_bound->at[1][2] = 0.0f;
  M_bound->at[2][2] = 0.0f;
  M_bound->at[3][2] = M_23_bound;
  M_bound->at[4][2] = M_24_bound;
  M_bound->at[5][2] = M_25_bound;
  M_bound->at[0][3] = 0.0f;
  M_bound->at[1][3] = 0.0f;
  M_bound->at[2][3] = 0.0f;
  M_bound->at[3][3] = 0.0f;
  M_bound->at[4][3] = 0.0f;
  M_bound->at[5][3] = 0.0f;
  M_bound->at[0][4] = 0.0f;
  M_bound->at[1][4] = 0.0f;
  M_bound->at[2][4] = 0.0f;
  M_bound->at[3][4] = 0.0f;
  M_bound->at[4][4] = 0.0f;
  M_bound->at[5][4] = 0.0f;
  M_bound->at[0][5] = 0.0f;
  M_bound->at[1][5] = 0.0f;
  M_bound->at[2][5] = 0.0f;
  M_bound->at[3][5] = 0.0f;
  M_bound->at[4][5] = 0.0f;
  M_bound->at[5][5] = 0.0f;
}

/* power = f·v + τ·ω, in W; |error of power| <= power_bound unless inf or NaN.
   c: coscrew (f in N; τ in N m); s: screw (v in m/s; ω in rad/s); power_bound: number.
   7 mul, 11 add, 6 abs. */
static inline float ksl_dot_csf_certified(const ksl_coscrewf_t *c, const ksl_screwf_t *s,
    float *power_bound) {
  const float power_a = KSL_MULF(c->m0, s->m0), power_b = KSL_MULF(c->m1, s->m1),
      power_d = KSL_MULF(c->m2, s->m2), power_f = KSL_MULF(c->m3, s->m3),
      power_g = KSL_MULF(c->m4, s->m4), power_i = KSL_MULF(c->m5, s->m5),
      power = power_a + power_b + power_d + (power_f + power_g + power_i);
  const float power_size = fabsf(power_a) + fabsf(power_b) + fabsf(power_d)
          + (fabsf(power_f) + fabsf(power_g) + fabsf(power_i));
  const float power_bound_ = KSL_MULF(2.3841864e-07f, power_size + 1.9721523e-31f);
  *power_bound = power_bound_;
  return power;
}

/* so = [ad](s1) s2 = (ω1×v2 + v1×ω2 ; ω1×ω2); |error of so| <= so_bound unless inf or NaN.
     Exactly zero for s1 = s2, unless products overflow.
   s1, s2, so, so_bound: screw (v in m/s; ω in rad/s).
   24 mul, 30 add, 18 abs. */
static inline void ksl_cross_ssf_certified(const ksl_screwf_t *s1, const ksl_screwf_t *s2,
    ksl_screwf_t *so, ksl_screwf_t *so_bound) {
  const float so_0a = KSL_MULF(s1->m1, s2->m5), so_0b = KSL_MULF(s1->m5, s2->m1),
      so_0d = KSL_MULF(s1->m4, s2->m2), so_0e = KSL_MULF(s1->m2, s2->m4),
      so_0 = so_0a - so_0b + (so_0d - so_0e);
  const float so_1a = KSL_MULF(s1->m5, s2->m0), so_1b = KSL_MULF(s1->m0, s2->m5),
      so_1d = KSL_MULF(s1->m2, s2->m3), so_1e = KSL_MULF(s1->m3, s2->m2),
      so_1 = so_1a - so_1b + (so_1d - so_1e);
  const float so_2a = KSL_MULF(s1->m0, s2->m4), so_2b = KSL_MULF(s1->m4, s2->m0),
      so_2d = KSL_MULF(s1->m3, s2->m1), so_2e = KSL_MULF(s1->m1, s2->m3),
      so_2 = so_2a - so_2b + (so_2d - so_2e);
  const float so_3a = KSL_MULF(s1->m4, s2->m5), so_3b = KSL_MULF(s1->m5, s2->m4),
      so_3 = so_3a - so_3b;
  const float so_4a = KSL_MULF(s1->m5, s2->m3), so_4b = KSL_MULF(s1->m3, s2->m5),
      so_4 = so_4a - so_4b;
  const float so_5a = KSL_MULF(s1->m3, s2->m4), so_5b = KSL_MULF(s1->m4, s2->m3),
      so_5 = so_5a - so_5b;
  const float so_0_size = fabsf(so_0a) + fabsf(so_0b) + (fabsf(so_0d) + fabsf(so_0e)),
      so_1_size = fabsf(so_1a) + fabsf(so_1b) + (fabsf(so_1d) + fabsf(so_1e)),
      so_2_size = fabsf(so_2a) + fabsf(so_2b) + (fabsf(so_2d) + fabsf(so_2e)),
      so_3_size = fabsf(so_3a) + fabsf(so_3b), so_4_size = fabsf(so_4a) + fabsf(so_4b),
      so_5_size = fabsf(so_5a) + fabsf(so_5b);
  const float so_0_bound = KSL_MULF(1.7881396e-07f, so_0_size + 1.9721523e-31f),
      so_1_bound = KSL_MULF(1.7881396e-07f, so_1_size + 1.9721523e-31f),
      so_2_bound = KSL_MULF(1.7881396e-07f, so_2_size + 1.9721523e-31f),
      so_3_bound = KSL_MULF(1.192093e-07f, so_3_size + 1.9721523e-31f),
      so_4_bound = KSL_MULF(1.192093e-07f, so_4_size + 1.9721523e-31f),
      so_5_bound = KSL_MULF(1.192093e-07f, so_5_size + 1.9721523e-31f);
  so->m0 = so_0;
  so->m1 = so_1;
  so->m2 = so_2;
  so->m3 = so_3;
  so->m4 = so_4;
  so->m5 = so_5;
  so_bound->m0 = so_0_bound;
  so_bound->m1 = so_1_bound;
  so_bound->m2 = so_2_bound;
  so_bound->m3 = so_3_bound;
  so_bound->m4 = so_4_bound;
  so_bound->m5 = so_5_bound;
}

/* so = (ω1×v2 ; 0); |error of so| <= so_bound unless inf or NaN.
   s1, s2, so, so_bound: screw (v in m/s; ω in rad/s).
   9 mul, 9 add, 6 abs. */
static inline void ksl_cross_sstf_certified(const ksl_screwf_t *s1, const ksl_screwf_t *s2,
    ksl_screwf_t *so, ksl_screwf_t *so_bound) {
  const float so_0a = KSL_MULF(s1->m4, s2->m2), so_0b = KSL_MULF(s1->m5, s2->m1),
      so_0 = so_0a - so_0b;
  const float so_1a = KSL_MULF(s1->m5, s2->m0), so_1b = KSL_MULF(s1->m3, s2->m2),
      so_1 = so_1a - so_1b;
  const float so_2a = KSL_MULF(s1->m3, s2->m1), so_2b = KSL_MULF(s1->m4, s2->m0),
      so_2 = so_2a - so_2b;
  const float so_0_size = fabsf(so_0a) + fabsf(so_0b), so_1_size = fabsf(so_1a) + fabsf(so_1b),
      so_2_size = fabsf(so_2a) + fabsf(so_2b);
  const float so_0_bound = KSL_MULF(1.192093e-07f, so_0_size + 1.9721523e-31f),
      so_1_bound = KSL_MULF(1.192093e-07f, so_1_size + 1.9721523e-31f),
      so_2_bound = KSL_MULF(1.192093e-07f, so_2_size + 1.9721523e-31f);
  so->m0 = so_0;
  so->m1 = so_1;
  so->m2 = so_2;
  so->m3 = 0.0f;
  so->m4 = 0.0f;
  so->m5 = 0.0f;
  so_bound->m0 = so_0_bound;
  so_bound->m1 = so_1_bound;
  so_bound->m2 = so_2_bound;
  so_bound->m3 = 0.0f;
  so_bound->m4 = 0.0f;
  so_bound->m5 = 0.0f;
}

/* so = (t×R a ; R a), a = axis in the body's frame; |error of so| <= so_bound unless inf or NaN.
   D: displacement [R | t], R rotation, t in m; axis: vector; so, so_bound: screw (v in m/s; ω in
     rad/s).
   27 mul, 24 add, 12 abs. */
static inline void ksl_hsraf_certified(const ksl_SE3f_t *D, const ksl_vec3f_t *axis,
    ksl_screwf_t *so, ksl_screwf_t *so_bound) {
  const float a_0a = KSL_MULF(D->m00, axis->x), a_0b = KSL_MULF(D->m01, axis->y),
      a_0d = KSL_MULF(D->m02, axis->z), a_0 = a_0a + a_0b + a_0d;
  const float a_1a = KSL_MULF(D->m10, axis->x), a_1b = KSL_MULF(D->m11, axis->y),
      a_1d = KSL_MULF(D->m12, axis->z), a_1 = a_1a + a_1b + a_1d;
  const float a_2a = KSL_MULF(D->m20, axis->x), a_2b = KSL_MULF(D->m21, axis->y),
      a_2d = KSL_MULF(D->m22, axis->z), a_2 = a_2a + a_2b + a_2d;
  const float so_0 = KSL_MULF(D->m13, a_2) - KSL_MULF(D->m23, a_1);
  const float so_1 = KSL_MULF(D->m23, a_0) - KSL_MULF(D->m03, a_2);
  const float so_2 = KSL_MULF(D->m03, a_1) - KSL_MULF(D->m13, a_0);
  const float a_0_size = fabsf(a_0a) + fabsf(a_0b) + fabsf(a_0d),
      a_1_size = fabsf(a_1a) + fabsf(a_1b) + fabsf(a_1d),
      a_2_size = fabsf(a_2a) + fabsf(a_2b) + fabsf(a_2d);
  const float a_2_padded = a_2_size + 1.9721523e-31f;
  const float D_13_abs = fabsf(D->m13);
  const float a_1_padded = a_1_size + 1.9721523e-31f;
  const float D_23_abs = fabsf(D->m23),
      so_0_size = KSL_MULF(D_13_abs, a_2_padded) + KSL_MULF(D_23_abs, a_1_padded);
  const float a_0_padded = a_0_size + 1.9721523e-31f;
  const float D_03_abs = fabsf(D->m03),
      so_1_size = KSL_MULF(D_23_abs, a_0_padded) + KSL_MULF(D_03_abs, a_2_padded);
  const float so_2_size = KSL_MULF(D_03_abs, a_1_padded) + KSL_MULF(D_13_abs, a_0_padded);
  const float so_0_bound = KSL_MULF(2.9802328e-07f, so_0_size + 1.9721523e-31f),
      so_1_bound = KSL_MULF(2.9802328e-07f, so_1_size + 1.9721523e-31f),
      so_2_bound = KSL_MULF(2.9802328e-07f, so_2_size + 1.9721523e-31f);
  const float a_0_bound = KSL_MULF(1.7881396e-07f, a_0_padded),
      a_1_bound = KSL_MULF(1.7881396e-07f, a_1_padded),
      a_2_bound = KSL_MULF(1.7881396e-07f, a_2_padded);
  so->m0 = so_0;
  so->m1 = so_1;
  so->m2 = so_2;
  so->m3 = a_0;
  so->m4 = a_1;
  so->m5 = a_2;
  so_bound->m0 = so_0_bound;
  so_bound->m1 = so_1_bound;
  so_bound->m2 = so_2_bound;
  so_bound->m3 = a_0_bound;
  so_bound->m4 = a_1_bound;
  so_bound->m5 = a_2_bound;
}

/* so = (R a ; 0), a = axis in the body's frame; |error of so| <= so_bound unless inf or NaN.
   D: displacement [R | t], R rotation, t in m; axis: vector; so, so_bound: screw (v in m/s; ω in
     rad/s).
   12 mul, 15 add, 9 abs. */
static inline void ksl_hstaf_certified(const ksl_SE3f_t *D, const ksl_vec3f_t *axis,
    ksl_screwf_t *so, ksl_screwf_t *so_bound) {
  const float so_0a = KSL_MULF(D->m00, axis->x), so_0b = KSL_MULF(D->m01, axis->y),
      so_0d = KSL_MULF(D->m02, axis->z), so_0 = so_0a + so_0b + so_0d;
  const float so_1a = KSL_MULF(D->m10, axis->x), so_1b = KSL_MULF(D->m11, axis->y),
      so_1d = KSL_MULF(D->m12, axis->z), so_1 = so_1a + so_1b + so_1d;
  const float so_2a = KSL_MULF(D->m20, axis->x), so_2b = KSL_MULF(D->m21, axis->y),
      so_2d = KSL_MULF(D->m22, axis->z), so_2 = so_2a + so_2b + so_2d;
  const float so_0_size = fabsf(so_0a) + fabsf(so_0b) + fabsf(so_0d),
      so_1_size = fabsf(so_1a) + fabsf(so_1b) + fabsf(so_1d),
      so_2_size = fabsf(so_2a) + fabsf(so_2b) + fabsf(so_2d);
  const float so_0_bound = KSL_MULF(1.7881396e-07f, so_0_size + 1.9721523e-31f),
      so_1_bound = KSL_MULF(1.7881396e-07f, so_1_size + 1.9721523e-31f),
      so_2_bound = KSL_MULF(1.7881396e-07f, so_2_size + 1.9721523e-31f);
  so->m0 = so_0;
  so->m1 = so_1;
  so->m2 = so_2;
  so->m3 = 0.0f;
  so->m4 = 0.0f;
  so->m5 = 0.0f;
  so_bound->m0 = so_0_bound;
  so_bound->m1 = so_1_bound;
  so_bound->m2 = so_2_bound;
  so_bound->m3 = 0.0f;
  so_bound->m4 = 0.0f;
  so_bound->m5 = 0.0f;
}

/* so = -(t×R a ; R a), a = axis in the body's frame; |error of so| <= so_bound unless inf or
     NaN.
   D: displacement [R | t], R rotation, t in m; axis: vector; so, so_bound: screw (v in m/s; ω in
     rad/s).
   27 mul, 24 add, 3 neg, 12 abs. */
static inline void ksl_hsrainvf_certified(const ksl_SE3f_t *D, const ksl_vec3f_t *axis,
    ksl_screwf_t *so, ksl_screwf_t *so_bound) {
  const float a_0a = KSL_MULF(D->m00, axis->x), a_0b = KSL_MULF(D->m01, axis->y),
      a_0d = KSL_MULF(D->m02, axis->z), a_0 = -(a_0a + a_0b + a_0d);
  const float a_1a = KSL_MULF(D->m10, axis->x), a_1b = KSL_MULF(D->m11, axis->y),
      a_1d = KSL_MULF(D->m12, axis->z), a_1 = -(a_1a + a_1b + a_1d);
  const float a_2a = KSL_MULF(D->m20, axis->x), a_2b = KSL_MULF(D->m21, axis->y),
      a_2d = KSL_MULF(D->m22, axis->z), a_2 = -(a_2a + a_2b + a_2d);
  const float so_0 = KSL_MULF(D->m13, a_2) - KSL_MULF(D->m23, a_1);
  const float so_1 = KSL_MULF(D->m23, a_0) - KSL_MULF(D->m03, a_2);
  const float so_2 = KSL_MULF(D->m03, a_1) - KSL_MULF(D->m13, a_0);
  const float a_2e_padded = fabsf(a_2a) + fabsf(a_2b) + fabsf(a_2d) + 1.9721523e-31f;
  const float D_13_abs = fabsf(D->m13);
  const float a_1e_padded = fabsf(a_1a) + fabsf(a_1b) + fabsf(a_1d) + 1.9721523e-31f;
  const float D_23_abs = fabsf(D->m23),
      so_0_size = KSL_MULF(D_13_abs, a_2e_padded) + KSL_MULF(D_23_abs, a_1e_padded);
  const float a_0e_padded = fabsf(a_0a) + fabsf(a_0b) + fabsf(a_0d) + 1.9721523e-31f;
  const float D_03_abs = fabsf(D->m03),
      so_1_size = KSL_MULF(D_23_abs, a_0e_padded) + KSL_MULF(D_03_abs, a_2e_padded);
  const float so_2_size = KSL_MULF(D_03_abs, a_1e_padded) + KSL_MULF(D_13_abs, a_0e_padded);
  const float so_0_bound = KSL_MULF(2.9802328e-07f, so_0_size + 1.9721523e-31f),
      so_1_bound = KSL_MULF(2.9802328e-07f, so_1_size + 1.9721523e-31f),
      so_2_bound = KSL_MULF(2.9802328e-07f, so_2_size + 1.9721523e-31f);
  const float a_0e_bound = KSL_MULF(1.7881396e-07f, a_0e_padded);
  const float a_1e_bound = KSL_MULF(1.7881396e-07f, a_1e_padded);
  const float a_2e_bound = KSL_MULF(1.7881396e-07f, a_2e_padded);
  so->m0 = so_0;
  so->m1 = so_1;
  so->m2 = so_2;
  so->m3 = a_0;
  so->m4 = a_1;
  so->m5 = a_2;
  so_bound->m0 = so_0_bound;
  so_bound->m1 = so_1_bound;
  so_bound->m2 = so_2_bound;
  so_bound->m3 = a_0e_bound;
  so_bound->m4 = a_1e_bound;
  so_bound->m5 = a_2e_bound;
}

/* so = -(R a ; 0), a = axis in the body's frame; |error of so| <= so_bound unless inf or NaN.
   D: displacement [R | t], R rotation, t in m; axis: vector; so, so_bound: screw (v in m/s; ω in
     rad/s).
   12 mul, 15 add, 3 neg, 9 abs. */
static inline void ksl_hstainvf_certified(const ksl_SE3f_t *D, const ksl_vec3f_t *axis,
    ksl_screwf_t *so, ksl_screwf_t *so_bound) {
  const float so_0a = KSL_MULF(D->m00, axis->x), so_0b = KSL_MULF(D->m01, axis->y),
      so_0d = KSL_MULF(D->m02, axis->z), so_0 = -(so_0a + so_0b + so_0d);
  const float so_1a = KSL_MULF(D->m10, axis->x), so_1b = KSL_MULF(D->m11, axis->y),
      so_1d = KSL_MULF(D->m12, axis->z), so_1 = -(so_1a + so_1b + so_1d);
  const float so_2a = KSL_MULF(D->m20, axis->x), so_2b = KSL_MULF(D->m21, axis->y),
      so_2d = KSL_MULF(D->m22, axis->z), so_2 = -(so_2a + so_2b + so_2d);
  const float so_0e_bound = KSL_MULF(1.7881396e-07f, fabsf(so_0a) + fabsf(so_0b) + fabsf(so_0d)
          + 1.9721523e-31f);
  const float so_1e_bound = KSL_MULF(1.7881396e-07f, fabsf(so_1a) + fabsf(so_1b) + fabsf(so_1d)
          + 1.9721523e-31f);
  const float so_2e_bound = KSL_MULF(1.7881396e-07f, fabsf(so_2a) + fabsf(so_2b) + fabsf(so_2d)
          + 1.9721523e-31f);
  so->m0 = so_0;
  so->m1 = so_1;
  so->m2 = so_2;
  so->m3 = 0.0f;
  so->m4 = 0.0f;
  so->m5 = 0.0f;
  so_bound->m0 = so_0e_bound;
  so_bound->m1 = so_1e_bound;
  so_bound->m2 = so_2e_bound;
  so_bound->m3 = 0.0f;
  so_bound->m4 = 0.0f;
  so_bound->m5 = 0.0f;
}

#endif
