/* Made by `coscrew generate`; changes are overwritten. */
/* SPDX-License-Identifier: MIT */
/* coscrew 0.2.0.  Copyright (c) 2026 The coscrew authors. */
/* Coscrews: wrenches and momenta, c = (f; τ).
   Certified tier: plain results, and bounds on their errors that always hold. */
#ifndef KSL_COSCREW_CERTIFIED_H
#define KSL_COSCREW_CERTIFIED_H

#include "ksl_types.h"

/* self = a self; |error of self| <= self_bound unless inf or NaN.
   self, self_bound: coscrew (f in N; τ in N m); a: number.
   12 mul, 6 add, 6 abs. */
static inline void ksl_coscrew_scale_certified(ksl_coscrew_t *self, const double a,
    ksl_coscrew_t *self_bound) {
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
   a: number; x, y, y_bound: coscrew (f in N; τ in N m).
   12 mul, 18 add, 12 abs. */
static inline void ksl_axpy_cc_certified(const double a, const ksl_coscrew_t *x, ksl_coscrew_t *y,
    ksl_coscrew_t *y_bound) {
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
   x, y, y_bound: coscrew (f in N; τ in N m).
   6 mul, 6 add, 6 abs. */
static inline void ksl_xpy_cc_certified(const ksl_coscrew_t *x, ksl_coscrew_t *y,
    ksl_coscrew_t *y_bound) {
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
   x, y, y_bound: coscrew (f in N; τ in N m).
   6 mul, 6 add, 6 abs. */
static inline void ksl_nxpy_cc_certified(const ksl_coscrew_t *x, ksl_coscrew_t *y,
    ksl_coscrew_t *y_bound) {
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

/* co = a ci; |error of co| <= co_bound unless inf or NaN.
   a: number; ci, co, co_bound: coscrew (f in N; τ in N m).
   12 mul, 6 add, 6 abs. */
static inline void ksl_product_ac_certified(const double a, const ksl_coscrew_t *ci,
    ksl_coscrew_t *co, ksl_coscrew_t *co_bound) {
  const double co_0 = KSL_MUL(a, ci->m0), co_1 = KSL_MUL(a, ci->m1), co_2 = KSL_MUL(a, ci->m2),
      co_3 = KSL_MUL(a, ci->m3), co_4 = KSL_MUL(a, ci->m4), co_5 = KSL_MUL(a, ci->m5);
  const double co_0_bound = KSL_MUL(1.1102230246251568e-16, fabs(co_0) + 2.004168360008973e-292),
      co_1_bound = KSL_MUL(1.1102230246251568e-16, fabs(co_1) + 2.004168360008973e-292),
      co_2_bound = KSL_MUL(1.1102230246251568e-16, fabs(co_2) + 2.004168360008973e-292),
      co_3_bound = KSL_MUL(1.1102230246251568e-16, fabs(co_3) + 2.004168360008973e-292),
      co_4_bound = KSL_MUL(1.1102230246251568e-16, fabs(co_4) + 2.004168360008973e-292),
      co_5_bound = KSL_MUL(1.1102230246251568e-16, fabs(co_5) + 2.004168360008973e-292);
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

/* co = c1 + c2; |error of co| <= co_bound unless inf or NaN.
   c1, c2, co, co_bound: coscrew (f in N; τ in N m).
   6 mul, 6 add, 6 abs. */
static inline void ksl_add_cc_certified(const ksl_coscrew_t *c1, const ksl_coscrew_t *c2,
    ksl_coscrew_t *co, ksl_coscrew_t *co_bound) {
  const double co_0 = c1->m0 + c2->m0, co_1 = c1->m1 + c2->m1, co_2 = c1->m2 + c2->m2,
      co_3 = c1->m3 + c2->m3, co_4 = c1->m4 + c2->m4, co_5 = c1->m5 + c2->m5;
  const double co_0_bound = KSL_MUL(1.1102230246251568e-16, fabs(co_0)),
      co_1_bound = KSL_MUL(1.1102230246251568e-16, fabs(co_1)),
      co_2_bound = KSL_MUL(1.1102230246251568e-16, fabs(co_2)),
      co_3_bound = KSL_MUL(1.1102230246251568e-16, fabs(co_3)),
      co_4_bound = KSL_MUL(1.1102230246251568e-16, fabs(co_4)),
      co_5_bound = KSL_MUL(1.1102230246251568e-16, fabs(co_5));
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

/* co = c1 - c2; |error of co| <= co_bound unless inf or NaN.
   c1, c2, co, co_bound: coscrew (f in N; τ in N m).
   6 mul, 6 add, 6 abs. */
static inline void ksl_subtract_cc_certified(const ksl_coscrew_t *c1, const ksl_coscrew_t *c2,
    ksl_coscrew_t *co, ksl_coscrew_t *co_bound) {
  const double co_0 = c1->m0 - c2->m0, co_1 = c1->m1 - c2->m1, co_2 = c1->m2 - c2->m2,
      co_3 = c1->m3 - c2->m3, co_4 = c1->m4 - c2->m4, co_5 = c1->m5 - c2->m5;
  const double co_0_bound = KSL_MUL(1.1102230246251568e-16, fabs(co_0)),
      co_1_bound = KSL_MUL(1.1102230246251568e-16, fabs(co_1)),
      co_2_bound = KSL_MUL(1.1102230246251568e-16, fabs(co_2)),
      co_3_bound = KSL_MUL(1.1102230246251568e-16, fabs(co_3)),
      co_4_bound = KSL_MUL(1.1102230246251568e-16, fabs(co_4)),
      co_5_bound = KSL_MUL(1.1102230246251568e-16, fabs(co_5));
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

/* co = (c1.lin + c2.lin ; c1.ang); |error of co| <= co_bound unless inf or NaN.
   c1, c2, co, co_bound: coscrew (f in N; τ in N m).
   3 mul, 3 add, 3 abs. */
static inline void ksl_add_cct_certified(const ksl_coscrew_t *c1, const ksl_coscrew_t *c2,
    ksl_coscrew_t *co, ksl_coscrew_t *co_bound) {
  const double co_0 = c1->m0 + c2->m0, co_1 = c1->m1 + c2->m1, co_2 = c1->m2 + c2->m2;
  const double co_0_bound = KSL_MUL(1.1102230246251568e-16, fabs(co_0)),
      co_1_bound = KSL_MUL(1.1102230246251568e-16, fabs(co_1)),
      co_2_bound = KSL_MUL(1.1102230246251568e-16, fabs(co_2));
  const double c1_m3 = c1->m3;
  const double c1_m4 = c1->m4;
  const double c1_m5 = c1->m5;
  co->m0 = co_0;
  co->m1 = co_1;
  co->m2 = co_2;
  co->m3 = c1_m3;
  co->m4 = c1_m4;
  co->m5 = c1_m5;
  co_bound->m0 = co_0_bound;
  co_bound->m1 = co_1_bound;
  co_bound->m2 = co_2_bound;
  co_bound->m3 = 0.0;
  co_bound->m4 = 0.0;
  co_bound->m5 = 0.0;
}

/* co = [Ad]*(t) ci; |error of co| <= co_bound unless inf or NaN.
   t: vector; ci, co, co_bound: coscrew (f in N; τ in N m).
   9 mul, 15 add, 9 abs. */
static inline void ksl_product_CoAdtc_certified(const ksl_vec3_t *t, const ksl_coscrew_t *ci,
    ksl_coscrew_t *co, ksl_coscrew_t *co_bound) {
  const double co_3a = KSL_MUL(t->y, ci->m2), co_3b = KSL_MUL(t->z, ci->m1),
      co_3 = co_3a - co_3b + ci->m3;
  const double co_4a = KSL_MUL(t->z, ci->m0), co_4b = KSL_MUL(t->x, ci->m2),
      co_4 = co_4a - co_4b + ci->m4;
  const double co_5a = KSL_MUL(t->x, ci->m1), co_5b = KSL_MUL(t->y, ci->m0),
      co_5 = co_5a - co_5b + ci->m5;
  const double co_3_size = fabs(co_3a) + fabs(co_3b) + fabs(ci->m3),
      co_4_size = fabs(co_4a) + fabs(co_4b) + fabs(ci->m4),
      co_5_size = fabs(co_5a) + fabs(co_5b) + fabs(ci->m5);
  const double co_3_bound = KSL_MUL(3.3306690738754706e-16, co_3_size + 2.004168360008973e-292),
      co_4_bound = KSL_MUL(3.3306690738754706e-16, co_4_size + 2.004168360008973e-292),
      co_5_bound = KSL_MUL(3.3306690738754706e-16, co_5_size + 2.004168360008973e-292);
  const double ci_m0 = ci->m0;
  const double ci_m1 = ci->m1;
  const double ci_m2 = ci->m2;
  co->m0 = ci_m0;
  co->m1 = ci_m1;
  co->m2 = ci_m2;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
  co_bound->m0 = 0.0;
  co_bound->m1 = 0.0;
  co_bound->m2 = 0.0;
  co_bound->m3 = co_3_bound;
  co_bound->m4 = co_4_bound;
  co_bound->m5 = co_5_bound;
}

/* co = [Ad]*(t)^-1 ci; |error of co| <= co_bound unless inf or NaN.
   t: vector; ci, co, co_bound: coscrew (f in N; τ in N m).
   9 mul, 15 add, 9 abs. */
static inline void ksl_product_CoAdtinvc_certified(const ksl_vec3_t *t, const ksl_coscrew_t *ci,
    ksl_coscrew_t *co, ksl_coscrew_t *co_bound) {
  const double co_3a = KSL_MUL(t->z, ci->m1), co_3b = KSL_MUL(t->y, ci->m2),
      co_3 = co_3a - co_3b + ci->m3;
  const double co_4a = KSL_MUL(t->x, ci->m2), co_4b = KSL_MUL(t->z, ci->m0),
      co_4 = co_4a - co_4b + ci->m4;
  const double co_5a = KSL_MUL(t->y, ci->m0), co_5b = KSL_MUL(t->x, ci->m1),
      co_5 = co_5a - co_5b + ci->m5;
  const double co_3_size = fabs(co_3a) + fabs(co_3b) + fabs(ci->m3),
      co_4_size = fabs(co_4a) + fabs(co_4b) + fabs(ci->m4),
      co_5_size = fabs(co_5a) + fabs(co_5b) + fabs(ci->m5);
  const double co_3_bound = KSL_MUL(3.3306690738754706e-16, co_3_size + 2.004168360008973e-292),
      co_4_bound = KSL_MUL(3.3306690738754706e-16, co_4_size + 2.004168360008973e-292),
      co_5_bound = KSL_MUL(3.3306690738754706e-16, co_5_size + 2.004168360008973e-292);
  const double ci_m0 = ci->m0;
  const double ci_m1 = ci->m1;
  const double ci_m2 = ci->m2;
  co->m0 = ci_m0;
  co->m1 = ci_m1;
  co->m2 = ci_m2;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
  co_bound->m0 = 0.0;
  co_bound->m1 = 0.0;
  co_bound->m2 = 0.0;
  co_bound->m3 = co_3_bound;
  co_bound->m4 = co_4_bound;
  co_bound->m5 = co_5_bound;
}

/* co = [Ad]*(t) (-ci); |error of co| <= co_bound unless inf or NaN.
   t: vector; ci, co, co_bound: coscrew (f in N; τ in N m).
   9 mul, 15 add, 3 neg, 9 abs. */
static inline void ksl_product_CoAdtcinv_certified(const ksl_vec3_t *t, const ksl_coscrew_t *ci,
    ksl_coscrew_t *co, ksl_coscrew_t *co_bound) {
  const double co_0 = -ci->m0, co_1 = -ci->m1, co_2 = -ci->m2;
  const double co_3a = KSL_MUL(t->z, ci->m1), co_3b = KSL_MUL(t->y, ci->m2),
      co_3 = co_3a - co_3b - ci->m3;
  const double co_4a = KSL_MUL(t->x, ci->m2), co_4b = KSL_MUL(t->z, ci->m0),
      co_4 = co_4a - co_4b - ci->m4;
  const double co_5a = KSL_MUL(t->y, ci->m0), co_5b = KSL_MUL(t->x, ci->m1),
      co_5 = co_5a - co_5b - ci->m5;
  const double co_3_size = fabs(co_3a) + fabs(co_3b) + fabs(ci->m3),
      co_4_size = fabs(co_4a) + fabs(co_4b) + fabs(ci->m4),
      co_5_size = fabs(co_5a) + fabs(co_5b) + fabs(ci->m5);
  const double co_3_bound = KSL_MUL(3.3306690738754706e-16, co_3_size + 2.004168360008973e-292),
      co_4_bound = KSL_MUL(3.3306690738754706e-16, co_4_size + 2.004168360008973e-292),
      co_5_bound = KSL_MUL(3.3306690738754706e-16, co_5_size + 2.004168360008973e-292);
  co->m0 = co_0;
  co->m1 = co_1;
  co->m2 = co_2;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
  co_bound->m0 = 0.0;
  co_bound->m1 = 0.0;
  co_bound->m2 = 0.0;
  co_bound->m3 = co_3_bound;
  co_bound->m4 = co_4_bound;
  co_bound->m5 = co_5_bound;
}

/* co = [Ad]*(R) ci; |error of co| <= co_bound unless inf or NaN.
   R: rotation or other 3×3 matrix; ci, co, co_bound: coscrew (f in N; τ in N m).
   24 mul, 30 add, 18 abs. */
static inline void ksl_product_CoAdrc_certified(const ksl_mat3x3_t *R, const ksl_coscrew_t *ci,
    ksl_coscrew_t *co, ksl_coscrew_t *co_bound) {
  const double co_0a = KSL_MUL(R->m00, ci->m0), co_0b = KSL_MUL(R->m01, ci->m1),
      co_0d = KSL_MUL(R->m02, ci->m2), co_0 = co_0a + co_0b + co_0d;
  const double co_1a = KSL_MUL(R->m10, ci->m0), co_1b = KSL_MUL(R->m11, ci->m1),
      co_1d = KSL_MUL(R->m12, ci->m2), co_1 = co_1a + co_1b + co_1d;
  const double co_2a = KSL_MUL(R->m20, ci->m0), co_2b = KSL_MUL(R->m21, ci->m1),
      co_2d = KSL_MUL(R->m22, ci->m2), co_2 = co_2a + co_2b + co_2d;
  const double co_3a = KSL_MUL(R->m00, ci->m3), co_3b = KSL_MUL(R->m01, ci->m4),
      co_3d = KSL_MUL(R->m02, ci->m5), co_3 = co_3a + co_3b + co_3d;
  const double co_4a = KSL_MUL(R->m10, ci->m3), co_4b = KSL_MUL(R->m11, ci->m4),
      co_4d = KSL_MUL(R->m12, ci->m5), co_4 = co_4a + co_4b + co_4d;
  const double co_5a = KSL_MUL(R->m20, ci->m3), co_5b = KSL_MUL(R->m21, ci->m4),
      co_5d = KSL_MUL(R->m22, ci->m5), co_5 = co_5a + co_5b + co_5d;
  const double co_0_size = fabs(co_0a) + fabs(co_0b) + fabs(co_0d),
      co_1_size = fabs(co_1a) + fabs(co_1b) + fabs(co_1d),
      co_2_size = fabs(co_2a) + fabs(co_2b) + fabs(co_2d),
      co_3_size = fabs(co_3a) + fabs(co_3b) + fabs(co_3d),
      co_4_size = fabs(co_4a) + fabs(co_4b) + fabs(co_4d),
      co_5_size = fabs(co_5a) + fabs(co_5b) + fabs(co_5d);
  const double co_0_bound = KSL_MUL(3.3306690738754706e-16, co_0_size + 2.004168360008973e-292),
      co_1_bound = KSL_MUL(3.3306690738754706e-16, co_1_size + 2.004168360008973e-292),
      co_2_bound = KSL_MUL(3.3306690738754706e-16, co_2_size + 2.004168360008973e-292),
      co_3_bound = KSL_MUL(3.3306690738754706e-16, co_3_size + 2.004168360008973e-292),
      co_4_bound = KSL_MUL(3.3306690738754706e-16, co_4_size + 2.004168360008973e-292),
      co_5_bound = KSL_MUL(3.3306690738754706e-16, co_5_size + 2.004168360008973e-292);
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

/* co = [Ad]*(R)^-1 ci; |error of co| <= co_bound unless inf or NaN.
   R: rotation or other 3×3 matrix; ci, co, co_bound: coscrew (f in N; τ in N m).
   24 mul, 30 add, 18 abs. */
static inline void ksl_product_CoAdrinvc_certified(const ksl_mat3x3_t *R, const ksl_coscrew_t *ci,
    ksl_coscrew_t *co, ksl_coscrew_t *co_bound) {
  const double co_0a = KSL_MUL(R->m00, ci->m0), co_0b = KSL_MUL(R->m10, ci->m1),
      co_0d = KSL_MUL(R->m20, ci->m2), co_0 = co_0a + co_0b + co_0d;
  const double co_1a = KSL_MUL(R->m01, ci->m0), co_1b = KSL_MUL(R->m11, ci->m1),
      co_1d = KSL_MUL(R->m21, ci->m2), co_1 = co_1a + co_1b + co_1d;
  const double co_2a = KSL_MUL(R->m02, ci->m0), co_2b = KSL_MUL(R->m12, ci->m1),
      co_2d = KSL_MUL(R->m22, ci->m2), co_2 = co_2a + co_2b + co_2d;
  const double co_3a = KSL_MUL(R->m00, ci->m3), co_3b = KSL_MUL(R->m10, ci->m4),
      co_3d = KSL_MUL(R->m20, ci->m5), co_3 = co_3a + co_3b + co_3d;
  const double co_4a = KSL_MUL(R->m01, ci->m3), co_4b = KSL_MUL(R->m11, ci->m4),
      co_4d = KSL_MUL(R->m21, ci->m5), co_4 = co_4a + co_4b + co_4d;
  const double co_5a = KSL_MUL(R->m02, ci->m3), co_5b = KSL_MUL(R->m12, ci->m4),
      co_5d = KSL_MUL(R->m22, ci->m5), co_5 = co_5a + co_5b + co_5d;
  const double co_0_size = fabs(co_0a) + fabs(co_0b) + fabs(co_0d),
      co_1_size = fabs(co_1a) + fabs(co_1b) + fabs(co_1d),
      co_2_size = fabs(co_2a) + fabs(co_2b) + fabs(co_2d),
      co_3_size = fabs(co_3a) + fabs(co_3b) + fabs(co_3d),
      co_4_size = fabs(co_4a) + fabs(co_4b) + fabs(co_4d),
      co_5_size = fabs(co_5a) + fabs(co_5b) + fabs(co_5d);
  const double co_0_bound = KSL_MUL(3.3306690738754706e-16, co_0_size + 2.004168360008973e-292),
      co_1_bound = KSL_MUL(3.3306690738754706e-16, co_1_size + 2.004168360008973e-292),
      co_2_bound = KSL_MUL(3.3306690738754706e-16, co_2_size + 2.004168360008973e-292),
      co_3_bound = KSL_MUL(3.3306690738754706e-16, co_3_size + 2.004168360008973e-292),
      co_4_bound = KSL_MUL(3.3306690738754706e-16, co_4_size + 2.004168360008973e-292),
      co_5_bound = KSL_MUL(3.3306690738754706e-16, co_5_size + 2.004168360008973e-292);
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

/* co = [Ad]*(R) (-ci); |error of co| <= co_bound unless inf or NaN.
   R: rotation or other 3×3 matrix; ci, co, co_bound: coscrew (f in N; τ in N m).
   24 mul, 30 add, 6 neg, 18 abs. */
static inline void ksl_product_CoAdrcinv_certified(const ksl_mat3x3_t *R, const ksl_coscrew_t *ci,
    ksl_coscrew_t *co, ksl_coscrew_t *co_bound) {
  const double co_0a = KSL_MUL(R->m00, ci->m0), co_0b = KSL_MUL(R->m01, ci->m1),
      co_0d = KSL_MUL(R->m02, ci->m2), co_0 = -(co_0a + co_0b + co_0d);
  const double co_1a = KSL_MUL(R->m10, ci->m0), co_1b = KSL_MUL(R->m11, ci->m1),
      co_1d = KSL_MUL(R->m12, ci->m2), co_1 = -(co_1a + co_1b + co_1d);
  const double co_2a = KSL_MUL(R->m20, ci->m0), co_2b = KSL_MUL(R->m21, ci->m1),
      co_2d = KSL_MUL(R->m22, ci->m2), co_2 = -(co_2a + co_2b + co_2d);
  const double co_3a = KSL_MUL(R->m00, ci->m3), co_3b = KSL_MUL(R->m01, ci->m4),
      co_3d = KSL_MUL(R->m02, ci->m5), co_3 = -(co_3a + co_3b + co_3d);
  const double co_4a = KSL_MUL(R->m10, ci->m3), co_4b = KSL_MUL(R->m11, ci->m4),
      co_4d = KSL_MUL(R->m12, ci->m5), co_4 = -(co_4a + co_4b + co_4d);
  const double co_5a = KSL_MUL(R->m20, ci->m3), co_5b = KSL_MUL(R->m21, ci->m4),
      co_5d = KSL_MUL(R->m22, ci->m5), co_5 = -(co_5a + co_5b + co_5d);
  const double co_0e_bound = KSL_MUL(3.3306690738754706e-16, fabs(co_0a) + fabs(co_0b)
          + fabs(co_0d) + 2.004168360008973e-292);
  const double co_1e_bound = KSL_MUL(3.3306690738754706e-16, fabs(co_1a) + fabs(co_1b)
          + fabs(co_1d) + 2.004168360008973e-292);
  const double co_2e_bound = KSL_MUL(3.3306690738754706e-16, fabs(co_2a) + fabs(co_2b)
          + fabs(co_2d) + 2.004168360008973e-292);
  const double co_3e_bound = KSL_MUL(3.3306690738754706e-16, fabs(co_3a) + fabs(co_3b)
          + fabs(co_3d) + 2.004168360008973e-292);
  const double co_4e_bound = KSL_MUL(3.3306690738754706e-16, fabs(co_4a) + fabs(co_4b)
          + fabs(co_4d) + 2.004168360008973e-292);
  const double co_5e_bound = KSL_MUL(3.3306690738754706e-16, fabs(co_5a) + fabs(co_5b)
          + fabs(co_5d) + 2.004168360008973e-292);
  co->m0 = co_0;
  co->m1 = co_1;
  co->m2 = co_2;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
  co_bound->m0 = co_0e_bound;
  co_bound->m1 = co_1e_bound;
  co_bound->m2 = co_2e_bound;
  co_bound->m3 = co_3e_bound;
  co_bound->m4 = co_4e_bound;
  co_bound->m5 = co_5e_bound;
}

/* co = [Ad]*(D) ci = [Ad]*(t) [Ad]*(R) ci; |error of co| <= co_bound unless inf or NaN.
   D: displacement [R | t], R rotation, t in m; ci, co, co_bound: coscrew (f in N; τ in N m).
   36 mul, 42 add, 21 abs. */
static inline void ksl_product_CoAdc_certified(const ksl_SE3_t *D, const ksl_coscrew_t *ci,
    ksl_coscrew_t *co, ksl_coscrew_t *co_bound) {
  const double w_0a = KSL_MUL(D->m00, ci->m0), w_0b = KSL_MUL(D->m01, ci->m1),
      w_0d = KSL_MUL(D->m02, ci->m2), w_0 = w_0a + w_0b + w_0d;
  const double w_1a = KSL_MUL(D->m10, ci->m0), w_1b = KSL_MUL(D->m11, ci->m1),
      w_1d = KSL_MUL(D->m12, ci->m2), w_1 = w_1a + w_1b + w_1d;
  const double w_2a = KSL_MUL(D->m20, ci->m0), w_2b = KSL_MUL(D->m21, ci->m1),
      w_2d = KSL_MUL(D->m22, ci->m2), w_2 = w_2a + w_2b + w_2d;
  const double w_3a = KSL_MUL(D->m00, ci->m3), w_3b = KSL_MUL(D->m01, ci->m4),
      w_3d = KSL_MUL(D->m02, ci->m5), w_3 = w_3a + w_3b + w_3d;
  const double w_4a = KSL_MUL(D->m10, ci->m3), w_4b = KSL_MUL(D->m11, ci->m4),
      w_4d = KSL_MUL(D->m12, ci->m5), w_4 = w_4a + w_4b + w_4d;
  const double w_5a = KSL_MUL(D->m20, ci->m3), w_5b = KSL_MUL(D->m21, ci->m4),
      w_5d = KSL_MUL(D->m22, ci->m5), w_5 = w_5a + w_5b + w_5d;
  const double co_3 = KSL_MUL(D->m13, w_2) - KSL_MUL(D->m23, w_1) + w_3;
  const double co_4 = KSL_MUL(D->m23, w_0) - KSL_MUL(D->m03, w_2) + w_4;
  const double co_5 = KSL_MUL(D->m03, w_1) - KSL_MUL(D->m13, w_0) + w_5;
  const double w_0_size = fabs(w_0a) + fabs(w_0b) + fabs(w_0d),
      w_1_size = fabs(w_1a) + fabs(w_1b) + fabs(w_1d),
      w_2_size = fabs(w_2a) + fabs(w_2b) + fabs(w_2d),
      w_3_size = fabs(w_3a) + fabs(w_3b) + fabs(w_3d),
      w_4_size = fabs(w_4a) + fabs(w_4b) + fabs(w_4d),
      w_5_size = fabs(w_5a) + fabs(w_5b) + fabs(w_5d);
  const double w_2_padded = w_2_size + 2.004168360008973e-292;
  const double D_13_abs = fabs(D->m13);
  const double w_1_padded = w_1_size + 2.004168360008973e-292;
  const double D_23_abs = fabs(D->m23),
      co_3_size = KSL_MUL(D_13_abs, w_2_padded) + KSL_MUL(D_23_abs, w_1_padded) + w_3_size;
  const double w_0_padded = w_0_size + 2.004168360008973e-292;
  const double D_03_abs = fabs(D->m03),
      co_4_size = KSL_MUL(D_23_abs, w_0_padded) + KSL_MUL(D_03_abs, w_2_padded) + w_4_size;
  const double co_5_size = KSL_MUL(D_03_abs, w_1_padded) + KSL_MUL(D_13_abs, w_0_padded) + w_5_size;
  const double w_0_bound = KSL_MUL(3.3306690738754706e-16, w_0_padded),
      w_1_bound = KSL_MUL(3.3306690738754706e-16, w_1_padded),
      w_2_bound = KSL_MUL(3.3306690738754706e-16, w_2_padded);
  const double co_3_bound = KSL_MUL(6.661338147750942e-16, co_3_size + 2.004168360008973e-292),
      co_4_bound = KSL_MUL(6.661338147750942e-16, co_4_size + 2.004168360008973e-292),
      co_5_bound = KSL_MUL(6.661338147750942e-16, co_5_size + 2.004168360008973e-292);
  co->m0 = w_0;
  co->m1 = w_1;
  co->m2 = w_2;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
  co_bound->m0 = w_0_bound;
  co_bound->m1 = w_1_bound;
  co_bound->m2 = w_2_bound;
  co_bound->m3 = co_3_bound;
  co_bound->m4 = co_4_bound;
  co_bound->m5 = co_5_bound;
}

/* co = [Ad]*(D)^-1 ci = [Ad]*(R^T) [Ad]*(-t) ci; |error of co| <= co_bound unless inf or NaN.
   D: displacement [R | t], R rotation, t in m; ci, co, co_bound: coscrew (f in N; τ in N m).
   39 mul, 45 add, 27 abs. */
static inline void ksl_product_CoAdinvc_certified(const ksl_SE3_t *D, const ksl_coscrew_t *ci,
    ksl_coscrew_t *co, ksl_coscrew_t *co_bound) {
  const double w_3a = KSL_MUL(D->m23, ci->m1), w_3b = KSL_MUL(D->m13, ci->m2),
      w_3 = w_3a - w_3b + ci->m3;
  const double w_4a = KSL_MUL(D->m03, ci->m2), w_4b = KSL_MUL(D->m23, ci->m0),
      w_4 = w_4a - w_4b + ci->m4;
  const double w_5a = KSL_MUL(D->m13, ci->m0), w_5b = KSL_MUL(D->m03, ci->m1),
      w_5 = w_5a - w_5b + ci->m5;
  const double co_0a = KSL_MUL(D->m00, ci->m0), co_0b = KSL_MUL(D->m10, ci->m1),
      co_0d = KSL_MUL(D->m20, ci->m2), co_0 = co_0a + co_0b + co_0d;
  const double co_1a = KSL_MUL(D->m01, ci->m0), co_1b = KSL_MUL(D->m11, ci->m1),
      co_1d = KSL_MUL(D->m21, ci->m2), co_1 = co_1a + co_1b + co_1d;
  const double co_2a = KSL_MUL(D->m02, ci->m0), co_2b = KSL_MUL(D->m12, ci->m1),
      co_2d = KSL_MUL(D->m22, ci->m2), co_2 = co_2a + co_2b + co_2d;
  const double co_3 = KSL_MUL(D->m00, w_3) + KSL_MUL(D->m10, w_4) + KSL_MUL(D->m20, w_5);
  const double co_4 = KSL_MUL(D->m01, w_3) + KSL_MUL(D->m11, w_4) + KSL_MUL(D->m21, w_5),
      co_5 = KSL_MUL(D->m02, w_3) + KSL_MUL(D->m12, w_4) + KSL_MUL(D->m22, w_5);
  const double w_3_size = fabs(w_3a) + fabs(w_3b) + fabs(ci->m3),
      w_4_size = fabs(w_4a) + fabs(w_4b) + fabs(ci->m4),
      w_5_size = fabs(w_5a) + fabs(w_5b) + fabs(ci->m5);
  const double co_0_size = fabs(co_0a) + fabs(co_0b) + fabs(co_0d),
      co_1_size = fabs(co_1a) + fabs(co_1b) + fabs(co_1d),
      co_2_size = fabs(co_2a) + fabs(co_2b) + fabs(co_2d);
  const double w_3_padded = w_3_size + 2.004168360008973e-292,
      w_4_padded = w_4_size + 2.004168360008973e-292,
      w_5_padded = w_5_size + 2.004168360008973e-292;
  const double co_3_size = KSL_MUL(fabs(D->m00), w_3_padded) + KSL_MUL(fabs(D->m10), w_4_padded)
          + KSL_MUL(fabs(D->m20), w_5_padded),
      co_4_size = KSL_MUL(fabs(D->m01), w_3_padded) + KSL_MUL(fabs(D->m11), w_4_padded)
          + KSL_MUL(fabs(D->m21), w_5_padded),
      co_5_size = KSL_MUL(fabs(D->m02), w_3_padded) + KSL_MUL(fabs(D->m12), w_4_padded)
          + KSL_MUL(fabs(D->m22), w_5_padded);
  const double co_0_bound = KSL_MUL(3.3306690738754706e-16, co_0_size + 2.004168360008973e-292),
      co_1_bound = KSL_MUL(3.3306690738754706e-16, co_1_size + 2.004168360008973e-292),
      co_2_bound = KSL_MUL(3.3306690738754706e-16, co_2_size + 2.004168360008973e-292),
      co_3_bound = KSL_MUL(6.661338147750942e-16, co_3_size + 2.004168360008973e-292),
      co_4_bound = KSL_MUL(6.661338147750942e-16, co_4_size + 2.004168360008973e-292),
      co_5_bound = KSL_MUL(6.661338147750942e-16, co_5_size + 2.004168360008973e-292);
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

/* co = [Ad]*(D) (-ci); |error of co| <= co_bound unless inf or NaN.
   D: displacement [R | t], R rotation, t in m; ci, co, co_bound: coscrew (f in N; τ in N m).
   36 mul, 42 add, 6 neg, 21 abs. */
static inline void ksl_product_CoAdcinv_certified(const ksl_SE3_t *D, const ksl_coscrew_t *ci,
    ksl_coscrew_t *co, ksl_coscrew_t *co_bound) {
  const double w_0a = KSL_MUL(D->m00, ci->m0), w_0b = KSL_MUL(D->m01, ci->m1),
      w_0d = KSL_MUL(D->m02, ci->m2), w_0 = -(w_0a + w_0b + w_0d);
  const double w_1a = KSL_MUL(D->m10, ci->m0), w_1b = KSL_MUL(D->m11, ci->m1),
      w_1d = KSL_MUL(D->m12, ci->m2), w_1 = -(w_1a + w_1b + w_1d);
  const double w_2a = KSL_MUL(D->m20, ci->m0), w_2b = KSL_MUL(D->m21, ci->m1),
      w_2d = KSL_MUL(D->m22, ci->m2), w_2 = -(w_2a + w_2b + w_2d);
  const double w_3a = KSL_MUL(D->m00, ci->m3), w_3b = KSL_MUL(D->m01, ci->m4),
      w_3d = KSL_MUL(D->m02, ci->m5), w_3 = -(w_3a + w_3b + w_3d);
  const double w_4a = KSL_MUL(D->m10, ci->m3), w_4b = KSL_MUL(D->m11, ci->m4),
      w_4d = KSL_MUL(D->m12, ci->m5), w_4 = -(w_4a + w_4b + w_4d);
  const double w_5a = KSL_MUL(D->m20, ci->m3), w_5b = KSL_MUL(D->m21, ci->m4),
      w_5d = KSL_MUL(D->m22, ci->m5), w_5 = -(w_5a + w_5b + w_5d);
  const double co_3 = KSL_MUL(D->m13, w_2) - KSL_MUL(D->m23, w_1) + w_3;
  const double co_4 = KSL_MUL(D->m23, w_0) - KSL_MUL(D->m03, w_2) + w_4;
  const double co_5 = KSL_MUL(D->m03, w_1) - KSL_MUL(D->m13, w_0) + w_5;
  const double w_2e_padded = fabs(w_2a) + fabs(w_2b) + fabs(w_2d) + 2.004168360008973e-292;
  const double D_13_abs = fabs(D->m13);
  const double w_1e_padded = fabs(w_1a) + fabs(w_1b) + fabs(w_1d) + 2.004168360008973e-292;
  const double D_23_abs = fabs(D->m23),
      co_3_size = KSL_MUL(D_13_abs, w_2e_padded) + KSL_MUL(D_23_abs, w_1e_padded)
          + (fabs(w_3a) + fabs(w_3b) + fabs(w_3d));
  const double w_0e_padded = fabs(w_0a) + fabs(w_0b) + fabs(w_0d) + 2.004168360008973e-292;
  const double D_03_abs = fabs(D->m03),
      co_4_size = KSL_MUL(D_23_abs, w_0e_padded) + KSL_MUL(D_03_abs, w_2e_padded)
          + (fabs(w_4a) + fabs(w_4b) + fabs(w_4d));
  const double co_5_size = KSL_MUL(D_03_abs, w_1e_padded) + KSL_MUL(D_13_abs, w_0e_padded)
          + (fabs(w_5a) + fabs(w_5b) + fabs(w_5d));
  const double w_0e_bound = KSL_MUL(3.3306690738754706e-16, w_0e_padded);
  const double w_1e_bound = KSL_MUL(3.3306690738754706e-16, w_1e_padded);
  const double w_2e_bound = KSL_MUL(3.3306690738754706e-16, w_2e_padded);
  const double co_3_bound = KSL_MUL(6.661338147750942e-16, co_3_size + 2.004168360008973e-292),
      co_4_bound = KSL_MUL(6.661338147750942e-16, co_4_size + 2.004168360008973e-292),
      co_5_bound = KSL_MUL(6.661338147750942e-16, co_5_size + 2.004168360008973e-292);
  co->m0 = w_0;
  co->m1 = w_1;
  co->m2 = w_2;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
  co_bound->m0 = w_0e_bound;
  co_bound->m1 = w_1e_bound;
  co_bound->m2 = w_2e_bound;
  co_bound->m3 = co_3_bound;
  co_bound->m4 = co_4_bound;
  co_bound->m5 = co_5_bound;
}

/* co = h_tx: column 0 of [Ad]*(D); |error of co| <= co_bound unless inf or NaN.
   D: displacement [R | t], R rotation, t in m; co, co_bound: coscrew (f in N; τ in N m).
   9 mul, 9 add, 6 abs. */
static inline void ksl_hctx_certified(const ksl_SE3_t *D, ksl_coscrew_t *co,
    ksl_coscrew_t *co_bound) {
  const double co_3a = KSL_MUL(D->m20, D->m13), co_3b = KSL_MUL(D->m10, D->m23),
      co_3 = co_3a - co_3b;
  const double co_4a = KSL_MUL(D->m00, D->m23), co_4b = KSL_MUL(D->m20, D->m03),
      co_4 = co_4a - co_4b;
  const double co_5a = KSL_MUL(D->m10, D->m03), co_5b = KSL_MUL(D->m00, D->m13),
      co_5 = co_5a - co_5b;
  const double co_3_size = fabs(co_3a) + fabs(co_3b), co_4_size = fabs(co_4a) + fabs(co_4b),
      co_5_size = fabs(co_5a) + fabs(co_5b);
  const double co_3_bound = KSL_MUL(2.2204460492503136e-16, co_3_size + 2.004168360008973e-292),
      co_4_bound = KSL_MUL(2.2204460492503136e-16, co_4_size + 2.004168360008973e-292),
      co_5_bound = KSL_MUL(2.2204460492503136e-16, co_5_size + 2.004168360008973e-292);
  const double D_m00 = D->m00;
  const double D_m10 = D->m10;
  const double D_m20 = D->m20;
  co->m0 = D_m00;
  co->m1 = D_m10;
  co->m2 = D_m20;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
  co_bound->m0 = 0.0;
  co_bound->m1 = 0.0;
  co_bound->m2 = 0.0;
  co_bound->m3 = co_3_bound;
  co_bound->m4 = co_4_bound;
  co_bound->m5 = co_5_bound;
}

/* co = h_ty: column 1 of [Ad]*(D); |error of co| <= co_bound unless inf or NaN.
   D: displacement [R | t], R rotation, t in m; co, co_bound: coscrew (f in N; τ in N m).
   9 mul, 9 add, 6 abs. */
static inline void ksl_hcty_certified(const ksl_SE3_t *D, ksl_coscrew_t *co,
    ksl_coscrew_t *co_bound) {
  const double co_3a = KSL_MUL(D->m21, D->m13), co_3b = KSL_MUL(D->m11, D->m23),
      co_3 = co_3a - co_3b;
  const double co_4a = KSL_MUL(D->m01, D->m23), co_4b = KSL_MUL(D->m21, D->m03),
      co_4 = co_4a - co_4b;
  const double co_5a = KSL_MUL(D->m11, D->m03), co_5b = KSL_MUL(D->m01, D->m13),
      co_5 = co_5a - co_5b;
  const double co_3_size = fabs(co_3a) + fabs(co_3b), co_4_size = fabs(co_4a) + fabs(co_4b),
      co_5_size = fabs(co_5a) + fabs(co_5b);
  const double co_3_bound = KSL_MUL(2.2204460492503136e-16, co_3_size + 2.004168360008973e-292),
      co_4_bound = KSL_MUL(2.2204460492503136e-16, co_4_size + 2.004168360008973e-292),
      co_5_bound = KSL_MUL(2.2204460492503136e-16, co_5_size + 2.004168360008973e-292);
  const double D_m01 = D->m01;
  const double D_m11 = D->m11;
  const double D_m21 = D->m21;
  co->m0 = D_m01;
  co->m1 = D_m11;
  co->m2 = D_m21;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
  co_bound->m0 = 0.0;
  co_bound->m1 = 0.0;
  co_bound->m2 = 0.0;
  co_bound->m3 = co_3_bound;
  co_bound->m4 = co_4_bound;
  co_bound->m5 = co_5_bound;
}

/* co = h_tz: column 2 of [Ad]*(D); |error of co| <= co_bound unless inf or NaN.
   D: displacement [R | t], R rotation, t in m; co, co_bound: coscrew (f in N; τ in N m).
   9 mul, 9 add, 6 abs. */
static inline void ksl_hctz_certified(const ksl_SE3_t *D, ksl_coscrew_t *co,
    ksl_coscrew_t *co_bound) {
  const double co_3a = KSL_MUL(D->m22, D->m13), co_3b = KSL_MUL(D->m12, D->m23),
      co_3 = co_3a - co_3b;
  const double co_4a = KSL_MUL(D->m02, D->m23), co_4b = KSL_MUL(D->m22, D->m03),
      co_4 = co_4a - co_4b;
  const double co_5a = KSL_MUL(D->m12, D->m03), co_5b = KSL_MUL(D->m02, D->m13),
      co_5 = co_5a - co_5b;
  const double co_3_size = fabs(co_3a) + fabs(co_3b), co_4_size = fabs(co_4a) + fabs(co_4b),
      co_5_size = fabs(co_5a) + fabs(co_5b);
  const double co_3_bound = KSL_MUL(2.2204460492503136e-16, co_3_size + 2.004168360008973e-292),
      co_4_bound = KSL_MUL(2.2204460492503136e-16, co_4_size + 2.004168360008973e-292),
      co_5_bound = KSL_MUL(2.2204460492503136e-16, co_5_size + 2.004168360008973e-292);
  const double D_m02 = D->m02;
  const double D_m12 = D->m12;
  const double D_m22 = D->m22;
  co->m0 = D_m02;
  co->m1 = D_m12;
  co->m2 = D_m22;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
  co_bound->m0 = 0.0;
  co_bound->m1 = 0.0;
  co_bound->m2 = 0.0;
  co_bound->m3 = co_3_bound;
  co_bound->m4 = co_4_bound;
  co_bound->m5 = co_5_bound;
}

/* co = -h_tx: -column 0 of [Ad]*(D); |error of co| <= co_bound unless inf or NaN.
   D: displacement [R | t], R rotation, t in m; co, co_bound: coscrew (f in N; τ in N m).
   9 mul, 9 add, 3 neg, 6 abs. */
static inline void ksl_hctxinv_certified(const ksl_SE3_t *D, ksl_coscrew_t *co,
    ksl_coscrew_t *co_bound) {
  const double co_0 = -D->m00, co_1 = -D->m10, co_2 = -D->m20;
  const double co_3a = KSL_MUL(D->m10, D->m23), co_3b = KSL_MUL(D->m20, D->m13),
      co_3 = co_3a - co_3b;
  const double co_4a = KSL_MUL(D->m20, D->m03), co_4b = KSL_MUL(D->m00, D->m23),
      co_4 = co_4a - co_4b;
  const double co_5a = KSL_MUL(D->m00, D->m13), co_5b = KSL_MUL(D->m10, D->m03),
      co_5 = co_5a - co_5b;
  const double co_3_size = fabs(co_3a) + fabs(co_3b), co_4_size = fabs(co_4a) + fabs(co_4b),
      co_5_size = fabs(co_5a) + fabs(co_5b);
  const double co_3_bound = KSL_MUL(2.2204460492503136e-16, co_3_size + 2.004168360008973e-292),
      co_4_bound = KSL_MUL(2.2204460492503136e-16, co_4_size + 2.004168360008973e-292),
      co_5_bound = KSL_MUL(2.2204460492503136e-16, co_5_size + 2.004168360008973e-292);
  co->m0 = co_0;
  co->m1 = co_1;
  co->m2 = co_2;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
  co_bound->m0 = 0.0;
  co_bound->m1 = 0.0;
  co_bound->m2 = 0.0;
  co_bound->m3 = co_3_bound;
  co_bound->m4 = co_4_bound;
  co_bound->m5 = co_5_bound;
}

/* co = -h_ty: -column 1 of [Ad]*(D); |error of co| <= co_bound unless inf or NaN.
   D: displacement [R | t], R rotation, t in m; co, co_bound: coscrew (f in N; τ in N m).
   9 mul, 9 add, 3 neg, 6 abs. */
static inline void ksl_hctyinv_certified(const ksl_SE3_t *D, ksl_coscrew_t *co,
    ksl_coscrew_t *co_bound) {
  const double co_0 = -D->m01, co_1 = -D->m11, co_2 = -D->m21;
  const double co_3a = KSL_MUL(D->m11, D->m23), co_3b = KSL_MUL(D->m21, D->m13),
      co_3 = co_3a - co_3b;
  const double co_4a = KSL_MUL(D->m21, D->m03), co_4b = KSL_MUL(D->m01, D->m23),
      co_4 = co_4a - co_4b;
  const double co_5a = KSL_MUL(D->m01, D->m13), co_5b = KSL_MUL(D->m11, D->m03),
      co_5 = co_5a - co_5b;
  const double co_3_size = fabs(co_3a) + fabs(co_3b), co_4_size = fabs(co_4a) + fabs(co_4b),
      co_5_size = fabs(co_5a) + fabs(co_5b);
  const double co_3_bound = KSL_MUL(2.2204460492503136e-16, co_3_size + 2.004168360008973e-292),
      co_4_bound = KSL_MUL(2.2204460492503136e-16, co_4_size + 2.004168360008973e-292),
      co_5_bound = KSL_MUL(2.2204460492503136e-16, co_5_size + 2.004168360008973e-292);
  co->m0 = co_0;
  co->m1 = co_1;
  co->m2 = co_2;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
  co_bound->m0 = 0.0;
  co_bound->m1 = 0.0;
  co_bound->m2 = 0.0;
  co_bound->m3 = co_3_bound;
  co_bound->m4 = co_4_bound;
  co_bound->m5 = co_5_bound;
}

/* co = -h_tz: -column 2 of [Ad]*(D); |error of co| <= co_bound unless inf or NaN.
   D: displacement [R | t], R rotation, t in m; co, co_bound: coscrew (f in N; τ in N m).
   9 mul, 9 add, 3 neg, 6 abs. */
static inline void ksl_hctzinv_certified(const ksl_SE3_t *D, ksl_coscrew_t *co,
    ksl_coscrew_t *co_bound) {
  const double co_0 = -D->m02, co_1 = -D->m12, co_2 = -D->m22;
  const double co_3a = KSL_MUL(D->m12, D->m23), co_3b = KSL_MUL(D->m22, D->m13),
      co_3 = co_3a - co_3b;
  const double co_4a = KSL_MUL(D->m22, D->m03), co_4b = KSL_MUL(D->m02, D->m23),
      co_4 = co_4a - co_4b;
  const double co_5a = KSL_MUL(D->m02, D->m13), co_5b = KSL_MUL(D->m12, D->m03),
      co_5 = co_5a - co_5b;
  const double co_3_size = fabs(co_3a) + fabs(co_3b), co_4_size = fabs(co_4a) + fabs(co_4b),
      co_5_size = fabs(co_5a) + fabs(co_5b);
  const double co_3_bound = KSL_MUL(2.2204460492503136e-16, co_3_size + 2.004168360008973e-292),
      co_4_bound = KSL_MUL(2.2204460492503136e-16, co_4_size + 2.004168360008973e-292),
      co_5_bound = KSL_MUL(2.2204460492503136e-16, co_5_size + 2.004168360008973e-292);
  co->m0 = co_0;
  co->m1 = co_1;
  co->m2 = co_2;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
  co_bound->m0 = 0.0;
  co_bound->m1 = 0.0;
  co_bound->m2 = 0.0;
  co_bound->m3 = co_3_bound;
  co_bound->m4 = co_4_bound;
  co_bound->m5 = co_5_bound;
}

/* M = [Ad]*(D); |error of M| <= M_bound unless inf or NaN.
   D: displacement [R | t], R rotation, t in m; M, M_bound: 6×6 operator.
   27 mul, 27 add, 18 abs. */
static inline void ksl_CoAd_certified(const ksl_SE3_t *D, ksl_mat6x6_t *M, ksl_mat6x6_t *M_bound) {
  const double M_30a = KSL_MUL(D->m20, D->m13), M_30b = KSL_MUL(D->m10, D->m23),
      M_30 = M_30a - M_30b;
  const double M_31a = KSL_MUL(D->m21, D->m13), M_31b = KSL_MUL(D->m11, D->m23),
      M_31 = M_31a - M_31b;
  const double M_32a = KSL_MUL(D->m22, D->m13), M_32b = KSL_MUL(D->m12, D->m23),
      M_32 = M_32a - M_32b;
  const double M_40a = KSL_MUL(D->m00, D->m23), M_40b = KSL_MUL(D->m20, D->m03),
      M_40 = M_40a - M_40b;
  const double M_41a = KSL_MUL(D->m01, D->m23), M_41b = KSL_MUL(D->m21, D->m03),
      M_41 = M_41a - M_41b;
  const double M_42a = KSL_MUL(D->m02, D->m23), M_42b = KSL_MUL(D->m22, D->m03),
      M_42 = M_42a - M_42b;
  const double M_50a = KSL_MUL(D->m10, D->m03), M_50b = KSL_MUL(D->m00, D->m13),
      M_50 = M_50a - M_50b;
  const double M_51a = KSL_MUL(D->m11, D->m03), M_51b = KSL_MUL(D->m01, D->m13),
      M_51 = M_51a - M_51b;
  const double M_52a = KSL_MUL(D->m12, D->m03), M_52b = KSL_MUL(D->m02, D->m13),
      M_52 = M_52a - M_52b;
  const double M_30_size = fabs(M_30a) + fabs(M_30b), M_31_size = fabs(M_31a) + fabs(M_31b),
      M_32_size = fabs(M_32a) + fabs(M_32b), M_40_size = fabs(M_40a) + fabs(M_40b),
      M_41_size = fabs(M_41a) + fabs(M_41b), M_42_size = fabs(M_42a) + fabs(M_42b),
      M_50_size = fabs(M_50a) + fabs(M_50b), M_51_size = fabs(M_51a) + fabs(M_51b),
      M_52_size = fabs(M_52a) + fabs(M_52b);
  const double M_30_bound = KSL_MUL(2.2204460492503136e-16, M_30_size + 2.004168360008973e-292),
      M_31_bound = KSL_MUL(2.2204460492503136e-16, M_31_size + 2.004168360008973e-292),
      M_32_bound = KSL_MUL(2.2204460492503136e-16, M_32_size + 2.004168360008973e-292),
      M_40_bound = KSL_MUL(2.2204460492503136e-16, M_40_size + 2.004168360008973e-292),
      M_41_bound = KSL_MUL(2.2204460492503136e-16, M_41_size + 2.004168360008973e-292),
      M_42_bound = KSL_MUL(2.2204460492503136e-16, M_42_size + 2.004168360008973e-292),
      M_50_bound = KSL_MUL(2.2204460492503136e-16, M_50_size + 2.004168360008973e-292),
      M_51_bound = KSL_MUL(2.2204460492503136e-16, M_51_size + 2.004168360008973e-292),
      M_52_bound = KSL_MUL(2.2204460492503136e-16, M_52_size + 2.004168360008973e-292);
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
  M->at[3][0] = 0.0;
  M->at[4][0] = 0.0;
  M->at[5][0] = 0.0;
  M->at[0][1] = D_m10;
  M->at[1][1] = D_m11;
  M->at[2][1] = D_m12;
  M->at[3][1] = 0.0;
  M->at[4][1] = 0.0;
  M->at[5][1] = 0.0;
  M->at[0][2] = D_m20;
  M->at[1][2] = D_m21;
  M->at[2][2] = D_m22;
  M->at[3][2] = 0.0;
  M->at[4][2] = 0.0;
  M->at[5][2] = 0.0;
  M->at[0][3] = M_30;
  M->at[1][3] = M_31;
  M->at[2][3] = M_32;
  M->at[3][3] = D_m00;
  M->at[4][3] = D_m01;
  M->at[5][3] = D_m02;
  M->at[0][4] = M_40;
  M->at[1][4] = M_41;
  M->at[2][4] = M_42;
  M->at[3][4] = D_m10;
  M->at[4][4] = D_m11;
  M->at[5][4] = D_m12;
  M->at[0][5] = M_50;
  M->at[1][5] = M_51;
  M->at[2][5] = M_52;
  M->at[3][5] = D_m20;
  M->at[4][5] = D_m21;
  M->at[5][5] = D_m22;
  M_bound->at[0][0] = 0.0;
  M_bound->at[1][0] = 0.0;
  M_bound->at[2][0] = 0.0;
  M_bound->at[3][0] = 0.0;
  M_bound->at[4][0] = 0.0;
  M_bound->at[5][0] = 0.0;
  M_bound->at[0][1] = 0.0;
  M_bound->at[1][1] = 0.0;
  M_bound->at[2][1] = 0.0;
  M_bound->at[3][1] = 0.0;
  M_bound->at[4][1] = 0.0;
  M_bound->at[5][1] = 0.0;
  M_bound->at[0][2] = 0.0;
  M_bound->at[1][2] = 0.0;
  M_bound->at[2][2] = 0.0;
  M_bound->at[3][2] = 0.0;
  M_bound->at[4][2] = 0.0;
  M_bound->at[5][2] = 0.0;
  M_bound->at[0][3] = M_30_bound;
  M_bound->at[1][3] = M_31_bound;
  M_bound->at[2][3] = M_32_bound;
  M_bound->at[3][3] = 0.0;
  M_bound->at[4][3] = 0.0;
  M_bound->at[5][3] = 0.0;
  M_bound->at[0][4] = M_40_bound;
  M_bound->at[1][4] = M_41_bound;
  M_bound->at[2][4] = M_42_bound;
  M_bound->at[3][4] = 0.0;
  M_bound->at[4][4] = 0.0;
  M_bound->at[5][4] = 0.0;
  M_bound->at[0][5] = M_50_bound;
  M_bound->at[1][5] = M_51_bound;
  M_bound->at[2][5] = M_52_bound;
  M_bound->at[3][5] = 0.0;
  M_bound->at[4][5] = 0.0;
  M_bound->at[5][5] = 0.0;
}

/* power = W ⊙ $ = f·v + τ·ω, W = c = (f; τ), $ = x = (ω; v); |error of power| <= power_bound
     unless inf or NaN.
   c: coscrew (f in N; τ in N m); x: six components with the angular part on top; power_bound:
     number.
   7 mul, 11 add, 6 abs. */
static inline double ksl_reciprocal_product_certified(const ksl_coscrew_t *c, const double x[6],
    double *power_bound) {
  const double power_a = KSL_MUL(c->m0, x[3]), power_b = KSL_MUL(c->m1, x[4]),
      power_d = KSL_MUL(c->m2, x[5]), power_f = KSL_MUL(c->m3, x[0]),
      power_g = KSL_MUL(c->m4, x[1]), power_i = KSL_MUL(c->m5, x[2]),
      power = power_a + power_b + power_d + (power_f + power_g + power_i);
  const double power_size = fabs(power_a) + fabs(power_b) + fabs(power_d)
          + (fabs(power_f) + fabs(power_g) + fabs(power_i));
  const double power_bound_ = KSL_MUL(4.440892098500628e-16, power_size + 2.004168360008973e-292);
  *power_bound = power_bound_;
  return power;
}

/* co = [ad]*(s) c = (ω×f ; v×f + ω×τ); |error of co| <= co_bound unless inf or NaN.
   s: screw (v in m/s; ω in rad/s); c, co, co_bound: coscrew (f in N; τ in N m).
   24 mul, 30 add, 18 abs. */
static inline void ksl_cross_sc_certified(const ksl_screw_t *s, const ksl_coscrew_t *c,
    ksl_coscrew_t *co, ksl_coscrew_t *co_bound) {
  const double co_0a = KSL_MUL(s->m4, c->m2), co_0b = KSL_MUL(s->m5, c->m1), co_0 = co_0a - co_0b;
  const double co_1a = KSL_MUL(s->m5, c->m0), co_1b = KSL_MUL(s->m3, c->m2), co_1 = co_1a - co_1b;
  const double co_2a = KSL_MUL(s->m3, c->m1), co_2b = KSL_MUL(s->m4, c->m0), co_2 = co_2a - co_2b;
  const double co_3a = KSL_MUL(s->m1, c->m2), co_3b = KSL_MUL(s->m2, c->m1),
      co_3d = KSL_MUL(s->m4, c->m5), co_3e = KSL_MUL(s->m5, c->m4),
      co_3 = co_3a - co_3b + (co_3d - co_3e);
  const double co_4a = KSL_MUL(s->m2, c->m0), co_4b = KSL_MUL(s->m0, c->m2),
      co_4d = KSL_MUL(s->m5, c->m3), co_4e = KSL_MUL(s->m3, c->m5),
      co_4 = co_4a - co_4b + (co_4d - co_4e);
  const double co_5a = KSL_MUL(s->m0, c->m1), co_5b = KSL_MUL(s->m1, c->m0),
      co_5d = KSL_MUL(s->m3, c->m4), co_5e = KSL_MUL(s->m4, c->m3),
      co_5 = co_5a - co_5b + (co_5d - co_5e);
  const double co_0_size = fabs(co_0a) + fabs(co_0b), co_1_size = fabs(co_1a) + fabs(co_1b),
      co_2_size = fabs(co_2a) + fabs(co_2b),
      co_3_size = fabs(co_3a) + fabs(co_3b) + (fabs(co_3d) + fabs(co_3e)),
      co_4_size = fabs(co_4a) + fabs(co_4b) + (fabs(co_4d) + fabs(co_4e)),
      co_5_size = fabs(co_5a) + fabs(co_5b) + (fabs(co_5d) + fabs(co_5e));
  const double co_0_bound = KSL_MUL(2.2204460492503136e-16, co_0_size + 2.004168360008973e-292),
      co_1_bound = KSL_MUL(2.2204460492503136e-16, co_1_size + 2.004168360008973e-292),
      co_2_bound = KSL_MUL(2.2204460492503136e-16, co_2_size + 2.004168360008973e-292),
      co_3_bound = KSL_MUL(3.3306690738754706e-16, co_3_size + 2.004168360008973e-292),
      co_4_bound = KSL_MUL(3.3306690738754706e-16, co_4_size + 2.004168360008973e-292),
      co_5_bound = KSL_MUL(3.3306690738754706e-16, co_5_size + 2.004168360008973e-292);
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

/* co = (0 ; ω×τ); |error of co| <= co_bound unless inf or NaN.
   s: screw (v in m/s; ω in rad/s); c, co, co_bound: coscrew (f in N; τ in N m).
   9 mul, 9 add, 6 abs. */
static inline void ksl_cross_sca_certified(const ksl_screw_t *s, const ksl_coscrew_t *c,
    ksl_coscrew_t *co, ksl_coscrew_t *co_bound) {
  const double co_3a = KSL_MUL(s->m4, c->m5), co_3b = KSL_MUL(s->m5, c->m4), co_3 = co_3a - co_3b;
  const double co_4a = KSL_MUL(s->m5, c->m3), co_4b = KSL_MUL(s->m3, c->m5), co_4 = co_4a - co_4b;
  const double co_5a = KSL_MUL(s->m3, c->m4), co_5b = KSL_MUL(s->m4, c->m3), co_5 = co_5a - co_5b;
  const double co_3_size = fabs(co_3a) + fabs(co_3b), co_4_size = fabs(co_4a) + fabs(co_4b),
      co_5_size = fabs(co_5a) + fabs(co_5b);
  const double co_3_bound = KSL_MUL(2.2204460492503136e-16, co_3_size + 2.004168360008973e-292),
      co_4_bound = KSL_MUL(2.2204460492503136e-16, co_4_size + 2.004168360008973e-292),
      co_5_bound = KSL_MUL(2.2204460492503136e-16, co_5_size + 2.004168360008973e-292);
  co->m0 = 0.0;
  co->m1 = 0.0;
  co->m2 = 0.0;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
  co_bound->m0 = 0.0;
  co_bound->m1 = 0.0;
  co_bound->m2 = 0.0;
  co_bound->m3 = co_3_bound;
  co_bound->m4 = co_4_bound;
  co_bound->m5 = co_5_bound;
}

/* co = H̄* c = [Ad]*(D) P c; P clears component 0 of c, given in the frame of a tx joint at D;
     |error of co| <= co_bound unless inf or NaN.
   D: displacement [R | t], R rotation, t in m; c, co, co_bound: coscrew (f in N; τ in N m).
   33 mul, 36 add, 18 abs. */
static inline void ksl_constraint_ctx_certified(const ksl_SE3_t *D, const ksl_coscrew_t *c,
    ksl_coscrew_t *co, ksl_coscrew_t *co_bound) {
  const double w_0a = KSL_MUL(D->m01, c->m1), w_0b = KSL_MUL(D->m02, c->m2), w_0 = w_0a + w_0b;
  const double w_1a = KSL_MUL(D->m11, c->m1), w_1b = KSL_MUL(D->m12, c->m2), w_1 = w_1a + w_1b;
  const double w_2a = KSL_MUL(D->m21, c->m1), w_2b = KSL_MUL(D->m22, c->m2), w_2 = w_2a + w_2b;
  const double w_3a = KSL_MUL(D->m00, c->m3), w_3b = KSL_MUL(D->m01, c->m4),
      w_3d = KSL_MUL(D->m02, c->m5), w_3 = w_3a + w_3b + w_3d;
  const double w_4a = KSL_MUL(D->m10, c->m3), w_4b = KSL_MUL(D->m11, c->m4),
      w_4d = KSL_MUL(D->m12, c->m5), w_4 = w_4a + w_4b + w_4d;
  const double w_5a = KSL_MUL(D->m20, c->m3), w_5b = KSL_MUL(D->m21, c->m4),
      w_5d = KSL_MUL(D->m22, c->m5), w_5 = w_5a + w_5b + w_5d;
  const double co_3 = KSL_MUL(D->m13, w_2) - KSL_MUL(D->m23, w_1) + w_3;
  const double co_4 = KSL_MUL(D->m23, w_0) - KSL_MUL(D->m03, w_2) + w_4;
  const double co_5 = KSL_MUL(D->m03, w_1) - KSL_MUL(D->m13, w_0) + w_5;
  const double w_0_size = fabs(w_0a) + fabs(w_0b), w_1_size = fabs(w_1a) + fabs(w_1b),
      w_2_size = fabs(w_2a) + fabs(w_2b), w_3_size = fabs(w_3a) + fabs(w_3b) + fabs(w_3d),
      w_4_size = fabs(w_4a) + fabs(w_4b) + fabs(w_4d),
      w_5_size = fabs(w_5a) + fabs(w_5b) + fabs(w_5d);
  const double w_2_padded = w_2_size + 2.004168360008973e-292;
  const double D_13_abs = fabs(D->m13);
  const double w_1_padded = w_1_size + 2.004168360008973e-292;
  const double D_23_abs = fabs(D->m23),
      co_3_size = KSL_MUL(D_13_abs, w_2_padded) + KSL_MUL(D_23_abs, w_1_padded) + w_3_size;
  const double w_0_padded = w_0_size + 2.004168360008973e-292;
  const double D_03_abs = fabs(D->m03),
      co_4_size = KSL_MUL(D_23_abs, w_0_padded) + KSL_MUL(D_03_abs, w_2_padded) + w_4_size;
  const double co_5_size = KSL_MUL(D_03_abs, w_1_padded) + KSL_MUL(D_13_abs, w_0_padded) + w_5_size;
  const double w_0_bound = KSL_MUL(2.2204460492503136e-16, w_0_padded),
      w_1_bound = KSL_MUL(2.2204460492503136e-16, w_1_padded),
      w_2_bound = KSL_MUL(2.2204460492503136e-16, w_2_padded);
  const double co_3_bound = KSL_MUL(5.551115123125785e-16, co_3_size + 2.004168360008973e-292),
      co_4_bound = KSL_MUL(5.551115123125785e-16, co_4_size + 2.004168360008973e-292),
      co_5_bound = KSL_MUL(5.551115123125785e-16, co_5_size + 2.004168360008973e-292);
  co->m0 = w_0;
  co->m1 = w_1;
  co->m2 = w_2;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
  co_bound->m0 = w_0_bound;
  co_bound->m1 = w_1_bound;
  co_bound->m2 = w_2_bound;
  co_bound->m3 = co_3_bound;
  co_bound->m4 = co_4_bound;
  co_bound->m5 = co_5_bound;
}

/* co = H̄* c = [Ad]*(D) P c; P clears component 1 of c, given in the frame of a ty joint at D;
     |error of co| <= co_bound unless inf or NaN.
   D: displacement [R | t], R rotation, t in m; c, co, co_bound: coscrew (f in N; τ in N m).
   33 mul, 36 add, 18 abs. */
static inline void ksl_constraint_cty_certified(const ksl_SE3_t *D, const ksl_coscrew_t *c,
    ksl_coscrew_t *co, ksl_coscrew_t *co_bound) {
  const double w_0a = KSL_MUL(D->m00, c->m0), w_0b = KSL_MUL(D->m02, c->m2), w_0 = w_0a + w_0b;
  const double w_1a = KSL_MUL(D->m10, c->m0), w_1b = KSL_MUL(D->m12, c->m2), w_1 = w_1a + w_1b;
  const double w_2a = KSL_MUL(D->m20, c->m0), w_2b = KSL_MUL(D->m22, c->m2), w_2 = w_2a + w_2b;
  const double w_3a = KSL_MUL(D->m00, c->m3), w_3b = KSL_MUL(D->m01, c->m4),
      w_3d = KSL_MUL(D->m02, c->m5), w_3 = w_3a + w_3b + w_3d;
  const double w_4a = KSL_MUL(D->m10, c->m3), w_4b = KSL_MUL(D->m11, c->m4),
      w_4d = KSL_MUL(D->m12, c->m5), w_4 = w_4a + w_4b + w_4d;
  const double w_5a = KSL_MUL(D->m20, c->m3), w_5b = KSL_MUL(D->m21, c->m4),
      w_5d = KSL_MUL(D->m22, c->m5), w_5 = w_5a + w_5b + w_5d;
  const double co_3 = KSL_MUL(D->m13, w_2) - KSL_MUL(D->m23, w_1) + w_3;
  const double co_4 = KSL_MUL(D->m23, w_0) - KSL_MUL(D->m03, w_2) + w_4;
  const double co_5 = KSL_MUL(D->m03, w_1) - KSL_MUL(D->m13, w_0) + w_5;
  const double w_0_size = fabs(w_0a) + fabs(w_0b), w_1_size = fabs(w_1a) + fabs(w_1b),
      w_2_size = fabs(w_2a) + fabs(w_2b), w_3_size = fabs(w_3a) + fabs(w_3b) + fabs(w_3d),
      w_4_size = fabs(w_4a) + fabs(w_4b) + fabs(w_4d),
      w_5_size = fabs(w_5a) + fabs(w_5b) + fabs(w_5d);
  const double w_2_padded = w_2_size + 2.004168360008973e-292;
  const double D_13_abs = fabs(D->m13);
  const double w_1_padded = w_1_size + 2.004168360008973e-292;
  const double D_23_abs = fabs(D->m23),
      co_3_size = KSL_MUL(D_13_abs, w_2_padded) + KSL_MUL(D_23_abs, w_1_padded) + w_3_size;
  const double w_0_padded = w_0_size + 2.004168360008973e-292;
  const double D_03_abs = fabs(D->m03),
      co_4_size = KSL_MUL(D_23_abs, w_0_padded) + KSL_MUL(D_03_abs, w_2_padded) + w_4_size;
  const double co_5_size = KSL_MUL(D_03_abs, w_1_padded) + KSL_MUL(D_13_abs, w_0_padded) + w_5_size;
  const double w_0_bound = KSL_MUL(2.2204460492503136e-16, w_0_padded),
      w_1_bound = KSL_MUL(2.2204460492503136e-16, w_1_padded),
      w_2_bound = KSL_MUL(2.2204460492503136e-16, w_2_padded);
  const double co_3_bound = KSL_MUL(5.551115123125785e-16, co_3_size + 2.004168360008973e-292),
      co_4_bound = KSL_MUL(5.551115123125785e-16, co_4_size + 2.004168360008973e-292),
      co_5_bound = KSL_MUL(5.551115123125785e-16, co_5_size + 2.004168360008973e-292);
  co->m0 = w_0;
  co->m1 = w_1;
  co->m2 = w_2;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
  co_bound->m0 = w_0_bound;
  co_bound->m1 = w_1_bound;
  co_bound->m2 = w_2_bound;
  co_bound->m3 = co_3_bound;
  co_bound->m4 = co_4_bound;
  co_bound->m5 = co_5_bound;
}

/* co = H̄* c = [Ad]*(D) P c; P clears component 2 of c, given in the frame of a tz joint at D;
     |error of co| <= co_bound unless inf or NaN.
   D: displacement [R | t], R rotation, t in m; c, co, co_bound: coscrew (f in N; τ in N m).
   33 mul, 36 add, 18 abs. */
static inline void ksl_constraint_ctz_certified(const ksl_SE3_t *D, const ksl_coscrew_t *c,
    ksl_coscrew_t *co, ksl_coscrew_t *co_bound) {
  const double w_0a = KSL_MUL(D->m00, c->m0), w_0b = KSL_MUL(D->m01, c->m1), w_0 = w_0a + w_0b;
  const double w_1a = KSL_MUL(D->m10, c->m0), w_1b = KSL_MUL(D->m11, c->m1), w_1 = w_1a + w_1b;
  const double w_2a = KSL_MUL(D->m20, c->m0), w_2b = KSL_MUL(D->m21, c->m1), w_2 = w_2a + w_2b;
  const double w_3a = KSL_MUL(D->m00, c->m3), w_3b = KSL_MUL(D->m01, c->m4),
      w_3d = KSL_MUL(D->m02, c->m5), w_3 = w_3a + w_3b + w_3d;
  const double w_4a = KSL_MUL(D->m10, c->m3), w_4b = KSL_MUL(D->m11, c->m4),
      w_4d = KSL_MUL(D->m12, c->m5), w_4 = w_4a + w_4b + w_4d;
  const double w_5a = KSL_MUL(D->m20, c->m3), w_5b = KSL_MUL(D->m21, c->m4),
      w_5d = KSL_MUL(D->m22, c->m5), w_5 = w_5a + w_5b + w_5d;
  const double co_3 = KSL_MUL(D->m13, w_2) - KSL_MUL(D->m23, w_1) + w_3;
  const double co_4 = KSL_MUL(D->m23, w_0) - KSL_MUL(D->m03, w_2) + w_4;
  const double co_5 = KSL_MUL(D->m03, w_1) - KSL_MUL(D->m13, w_0) + w_5;
  const double w_0_size = fabs(w_0a) + fabs(w_0b), w_1_size = fabs(w_1a) + fabs(w_1b),
      w_2_size = fabs(w_2a) + fabs(w_2b), w_3_size = fabs(w_3a) + fabs(w_3b) + fabs(w_3d),
      w_4_size = fabs(w_4a) + fabs(w_4b) + fabs(w_4d),
      w_5_size = fabs(w_5a) + fabs(w_5b) + fabs(w_5d);
  const double w_2_padded = w_2_size + 2.004168360008973e-292;
  const double D_13_abs = fabs(D->m13);
  const double w_1_padded = w_1_size + 2.004168360008973e-292;
  const double D_23_abs = fabs(D->m23),
      co_3_size = KSL_MUL(D_13_abs, w_2_padded) + KSL_MUL(D_23_abs, w_1_padded) + w_3_size;
  const double w_0_padded = w_0_size + 2.004168360008973e-292;
  const double D_03_abs = fabs(D->m03),
      co_4_size = KSL_MUL(D_23_abs, w_0_padded) + KSL_MUL(D_03_abs, w_2_padded) + w_4_size;
  const double co_5_size = KSL_MUL(D_03_abs, w_1_padded) + KSL_MUL(D_13_abs, w_0_padded) + w_5_size;
  const double w_0_bound = KSL_MUL(2.2204460492503136e-16, w_0_padded),
      w_1_bound = KSL_MUL(2.2204460492503136e-16, w_1_padded),
      w_2_bound = KSL_MUL(2.2204460492503136e-16, w_2_padded);
  const double co_3_bound = KSL_MUL(5.551115123125785e-16, co_3_size + 2.004168360008973e-292),
      co_4_bound = KSL_MUL(5.551115123125785e-16, co_4_size + 2.004168360008973e-292),
      co_5_bound = KSL_MUL(5.551115123125785e-16, co_5_size + 2.004168360008973e-292);
  co->m0 = w_0;
  co->m1 = w_1;
  co->m2 = w_2;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
  co_bound->m0 = w_0_bound;
  co_bound->m1 = w_1_bound;
  co_bound->m2 = w_2_bound;
  co_bound->m3 = co_3_bound;
  co_bound->m4 = co_4_bound;
  co_bound->m5 = co_5_bound;
}

/* co = H̄* c = [Ad]*(D) P c; P clears component 3 of c, given in the frame of a rx joint at D;
     |error of co| <= co_bound unless inf or NaN.
   D: displacement [R | t], R rotation, t in m; c, co, co_bound: coscrew (f in N; τ in N m).
   33 mul, 36 add, 18 abs. */
static inline void ksl_constraint_crx_certified(const ksl_SE3_t *D, const ksl_coscrew_t *c,
    ksl_coscrew_t *co, ksl_coscrew_t *co_bound) {
  const double w_0a = KSL_MUL(D->m00, c->m0), w_0b = KSL_MUL(D->m01, c->m1),
      w_0d = KSL_MUL(D->m02, c->m2), w_0 = w_0a + w_0b + w_0d;
  const double w_1a = KSL_MUL(D->m10, c->m0), w_1b = KSL_MUL(D->m11, c->m1),
      w_1d = KSL_MUL(D->m12, c->m2), w_1 = w_1a + w_1b + w_1d;
  const double w_2a = KSL_MUL(D->m20, c->m0), w_2b = KSL_MUL(D->m21, c->m1),
      w_2d = KSL_MUL(D->m22, c->m2), w_2 = w_2a + w_2b + w_2d;
  const double w_3a = KSL_MUL(D->m01, c->m4), w_3b = KSL_MUL(D->m02, c->m5), w_3 = w_3a + w_3b;
  const double w_4a = KSL_MUL(D->m11, c->m4), w_4b = KSL_MUL(D->m12, c->m5), w_4 = w_4a + w_4b;
  const double w_5a = KSL_MUL(D->m21, c->m4), w_5b = KSL_MUL(D->m22, c->m5), w_5 = w_5a + w_5b;
  const double co_3 = KSL_MUL(D->m13, w_2) - KSL_MUL(D->m23, w_1) + w_3;
  const double co_4 = KSL_MUL(D->m23, w_0) - KSL_MUL(D->m03, w_2) + w_4;
  const double co_5 = KSL_MUL(D->m03, w_1) - KSL_MUL(D->m13, w_0) + w_5;
  const double w_0_size = fabs(w_0a) + fabs(w_0b) + fabs(w_0d),
      w_1_size = fabs(w_1a) + fabs(w_1b) + fabs(w_1d),
      w_2_size = fabs(w_2a) + fabs(w_2b) + fabs(w_2d), w_3_size = fabs(w_3a) + fabs(w_3b),
      w_4_size = fabs(w_4a) + fabs(w_4b), w_5_size = fabs(w_5a) + fabs(w_5b);
  const double w_2_padded = w_2_size + 2.004168360008973e-292;
  const double D_13_abs = fabs(D->m13);
  const double w_1_padded = w_1_size + 2.004168360008973e-292;
  const double D_23_abs = fabs(D->m23),
      co_3_size = KSL_MUL(D_13_abs, w_2_padded) + KSL_MUL(D_23_abs, w_1_padded) + w_3_size;
  const double w_0_padded = w_0_size + 2.004168360008973e-292;
  const double D_03_abs = fabs(D->m03),
      co_4_size = KSL_MUL(D_23_abs, w_0_padded) + KSL_MUL(D_03_abs, w_2_padded) + w_4_size;
  const double co_5_size = KSL_MUL(D_03_abs, w_1_padded) + KSL_MUL(D_13_abs, w_0_padded) + w_5_size;
  const double w_0_bound = KSL_MUL(3.3306690738754706e-16, w_0_padded),
      w_1_bound = KSL_MUL(3.3306690738754706e-16, w_1_padded),
      w_2_bound = KSL_MUL(3.3306690738754706e-16, w_2_padded);
  const double co_3_bound = KSL_MUL(6.661338147750942e-16, co_3_size + 2.004168360008973e-292),
      co_4_bound = KSL_MUL(6.661338147750942e-16, co_4_size + 2.004168360008973e-292),
      co_5_bound = KSL_MUL(6.661338147750942e-16, co_5_size + 2.004168360008973e-292);
  co->m0 = w_0;
  co->m1 = w_1;
  co->m2 = w_2;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
  co_bound->m0 = w_0_bound;
  co_bound->m1 = w_1_bound;
  co_bound->m2 = w_2_bound;
  co_bound->m3 = co_3_bound;
  co_bound->m4 = co_4_bound;
  co_bound->m5 = co_5_bound;
}

/* co = H̄* c = [Ad]*(D) P c; P clears component 4 of c, given in the frame of a ry joint at D;
     |error of co| <= co_bound unless inf or NaN.
   D: displacement [R | t], R rotation, t in m; c, co, co_bound: coscrew (f in N; τ in N m).
   33 mul, 36 add, 18 abs. */
static inline void ksl_constraint_cry_certified(const ksl_SE3_t *D, const ksl_coscrew_t *c,
    ksl_coscrew_t *co, ksl_coscrew_t *co_bound) {
  const double w_0a = KSL_MUL(D->m00, c->m0), w_0b = KSL_MUL(D->m01, c->m1),
      w_0d = KSL_MUL(D->m02, c->m2), w_0 = w_0a + w_0b + w_0d;
  const double w_1a = KSL_MUL(D->m10, c->m0), w_1b = KSL_MUL(D->m11, c->m1),
      w_1d = KSL_MUL(D->m12, c->m2), w_1 = w_1a + w_1b + w_1d;
  const double w_2a = KSL_MUL(D->m20, c->m0), w_2b = KSL_MUL(D->m21, c->m1),
      w_2d = KSL_MUL(D->m22, c->m2), w_2 = w_2a + w_2b + w_2d;
  const double w_3a = KSL_MUL(D->m00, c->m3), w_3b = KSL_MUL(D->m02, c->m5), w_3 = w_3a + w_3b;
  const double w_4a = KSL_MUL(D->m10, c->m3), w_4b = KSL_MUL(D->m12, c->m5), w_4 = w_4a + w_4b;
  const double w_5a = KSL_MUL(D->m20, c->m3), w_5b = KSL_MUL(D->m22, c->m5), w_5 = w_5a + w_5b;
  const double co_3 = KSL_MUL(D->m13, w_2) - KSL_MUL(D->m23, w_1) + w_3;
  const double co_4 = KSL_MUL(D->m23, w_0) - KSL_MUL(D->m03, w_2) + w_4;
  const double co_5 = KSL_MUL(D->m03, w_1) - KSL_MUL(D->m13, w_0) + w_5;
  const double w_0_size = fabs(w_0a) + fabs(w_0b) + fabs(w_0d),
      w_1_size = fabs(w_1a) + fabs(w_1b) + fabs(w_1d),
      w_2_size = fabs(w_2a) + fabs(w_2b) + fabs(w_2d), w_3_size = fabs(w_3a) + fabs(w_3b),
      w_4_size = fabs(w_4a) + fabs(w_4b), w_5_size = fabs(w_5a) + fabs(w_5b);
  const double w_2_padded = w_2_size + 2.004168360008973e-292;
  const double D_13_abs = fabs(D->m13);
  const double w_1_padded = w_1_size + 2.004168360008973e-292;
  const double D_23_abs = fabs(D->m23),
      co_3_size = KSL_MUL(D_13_abs, w_2_padded) + KSL_MUL(D_23_abs, w_1_padded) + w_3_size;
  const double w_0_padded = w_0_size + 2.004168360008973e-292;
  const double D_03_abs = fabs(D->m03),
      co_4_size = KSL_MUL(D_23_abs, w_0_padded) + KSL_MUL(D_03_abs, w_2_padded) + w_4_size;
  const double co_5_size = KSL_MUL(D_03_abs, w_1_padded) + KSL_MUL(D_13_abs, w_0_padded) + w_5_size;
  const double w_0_bound = KSL_MUL(3.3306690738754706e-16, w_0_padded),
      w_1_bound = KSL_MUL(3.3306690738754706e-16, w_1_padded),
      w_2_bound = KSL_MUL(3.3306690738754706e-16, w_2_padded);
  const double co_3_bound = KSL_MUL(6.661338147750942e-16, co_3_size + 2.004168360008973e-292),
      co_4_bound = KSL_MUL(6.661338147750942e-16, co_4_size + 2.004168360008973e-292),
      co_5_bound = KSL_MUL(6.661338147750942e-16, co_5_size + 2.004168360008973e-292);
  co->m0 = w_0;
  co->m1 = w_1;
  co->m2 = w_2;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
  co_bound->m0 = w_0_bound;
  co_bound->m1 = w_1_bound;
  co_bound->m2 = w_2_bound;
  co_bound->m3 = co_3_bound;
  co_bound->m4 = co_4_bound;
  co_bound->m5 = co_5_bound;
}

/* co = H̄* c = [Ad]*(D) P c; P clears component 5 of c, given in the frame of a rz joint at D;
     |error of co| <= co_bound unless inf or NaN.
   D: displacement [R | t], R rotation, t in m; c, co, co_bound: coscrew (f in N; τ in N m).
   33 mul, 36 add, 18 abs. */
static inline void ksl_constraint_crz_certified(const ksl_SE3_t *D, const ksl_coscrew_t *c,
    ksl_coscrew_t *co, ksl_coscrew_t *co_bound) {
  const double w_0a = KSL_MUL(D->m00, c->m0), w_0b = KSL_MUL(D->m01, c->m1),
      w_0d = KSL_MUL(D->m02, c->m2), w_0 = w_0a + w_0b + w_0d;
  const double w_1a = KSL_MUL(D->m10, c->m0), w_1b = KSL_MUL(D->m11, c->m1),
      w_1d = KSL_MUL(D->m12, c->m2), w_1 = w_1a + w_1b + w_1d;
  const double w_2a = KSL_MUL(D->m20, c->m0), w_2b = KSL_MUL(D->m21, c->m1),
      w_2d = KSL_MUL(D->m22, c->m2), w_2 = w_2a + w_2b + w_2d;
  const double w_3a = KSL_MUL(D->m00, c->m3), w_3b = KSL_MUL(D->m01, c->m4), w_3 = w_3a + w_3b;
  const double w_4a = KSL_MUL(D->m10, c->m3), w_4b = KSL_MUL(D->m11, c->m4), w_4 = w_4a + w_4b;
  const double w_5a = KSL_MUL(D->m20, c->m3), w_5b = KSL_MUL(D->m21, c->m4), w_5 = w_5a + w_5b;
  const double co_3 = KSL_MUL(D->m13, w_2) - KSL_MUL(D->m23, w_1) + w_3;
  const double co_4 = KSL_MUL(D->m23, w_0) - KSL_MUL(D->m03, w_2) + w_4;
  const double co_5 = KSL_MUL(D->m03, w_1) - KSL_MUL(D->m13, w_0) + w_5;
  const double w_0_size = fabs(w_0a) + fabs(w_0b) + fabs(w_0d),
      w_1_size = fabs(w_1a) + fabs(w_1b) + fabs(w_1d),
      w_2_size = fabs(w_2a) + fabs(w_2b) + fabs(w_2d), w_3_size = fabs(w_3a) + fabs(w_3b),
      w_4_size = fabs(w_4a) + fabs(w_4b), w_5_size = fabs(w_5a) + fabs(w_5b);
  const double w_2_padded = w_2_size + 2.004168360008973e-292;
  const double D_13_abs = fabs(D->m13);
  const double w_1_padded = w_1_size + 2.004168360008973e-292;
  const double D_23_abs = fabs(D->m23),
      co_3_size = KSL_MUL(D_13_abs, w_2_padded) + KSL_MUL(D_23_abs, w_1_padded) + w_3_size;
  const double w_0_padded = w_0_size + 2.004168360008973e-292;
  const double D_03_abs = fabs(D->m03),
      co_4_size = KSL_MUL(D_23_abs, w_0_padded) + KSL_MUL(D_03_abs, w_2_padded) + w_4_size;
  const double co_5_size = KSL_MUL(D_03_abs, w_1_padded) + KSL_MUL(D_13_abs, w_0_padded) + w_5_size;
  const double w_0_bound = KSL_MUL(3.3306690738754706e-16, w_0_padded),
      w_1_bound = KSL_MUL(3.3306690738754706e-16, w_1_padded),
      w_2_bound = KSL_MUL(3.3306690738754706e-16, w_2_padded);
  const double co_3_bound = KSL_MUL(6.661338147750942e-16, co_3_size + 2.004168360008973e-292),
      co_4_bound = KSL_MUL(6.661338147750942e-16, co_4_size + 2.004168360008973e-292),
      co_5_bound = KSL_MUL(6.661338147750942e-16, co_5_size + 2.004168360008973e-292);
  co->m0 = w_0;
  co->m1 = w_1;
  co->m2 = w_2;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
  co_bound->m0 = w_0_bound;
  co_bound->m1 = w_1_bound;
  co_bound->m2 = w_2_bound;
  co_bound->m3 = co_3_bound;
  co_bound->m4 = co_4_bound;
  co_bound->m5 = co_5_bound;
}

/* co = h̄* c = [Ad]*(D) P c; P keeps component 0 of c, given in the frame of a tx joint at D;
     |error of co| <= co_bound unless inf or NaN.
   D: displacement [R | t], R rotation, t in m; c, co, co_bound: coscrew (f in N; τ in N m).
   21 mul, 12 add, 6 abs. */
static inline void ksl_working_ctx_certified(const ksl_SE3_t *D, const ksl_coscrew_t *c,
    ksl_coscrew_t *co, ksl_coscrew_t *co_bound) {
  const double w_0 = KSL_MUL(D->m00, c->m0), w_1 = KSL_MUL(D->m10, c->m0),
      w_2 = KSL_MUL(D->m20, c->m0);
  const double co_3 = KSL_MUL(D->m13, w_2) - KSL_MUL(D->m23, w_1);
  const double co_4 = KSL_MUL(D->m23, w_0) - KSL_MUL(D->m03, w_2);
  const double co_5 = KSL_MUL(D->m03, w_1) - KSL_MUL(D->m13, w_0);
  const double w_2_padded = fabs(w_2) + 2.004168360008973e-292;
  const double D_13_abs = fabs(D->m13);
  const double w_1_padded = fabs(w_1) + 2.004168360008973e-292;
  const double D_23_abs = fabs(D->m23),
      co_3_size = KSL_MUL(D_13_abs, w_2_padded) + KSL_MUL(D_23_abs, w_1_padded);
  const double w_0_padded = fabs(w_0) + 2.004168360008973e-292;
  const double D_03_abs = fabs(D->m03),
      co_4_size = KSL_MUL(D_23_abs, w_0_padded) + KSL_MUL(D_03_abs, w_2_padded);
  const double co_5_size = KSL_MUL(D_03_abs, w_1_padded) + KSL_MUL(D_13_abs, w_0_padded);
  const double w_0_bound = KSL_MUL(1.1102230246251568e-16, w_0_padded),
      w_1_bound = KSL_MUL(1.1102230246251568e-16, w_1_padded),
      w_2_bound = KSL_MUL(1.1102230246251568e-16, w_2_padded);
  const double co_3_bound = KSL_MUL(3.3306690738754706e-16, co_3_size + 2.004168360008973e-292),
      co_4_bound = KSL_MUL(3.3306690738754706e-16, co_4_size + 2.004168360008973e-292),
      co_5_bound = KSL_MUL(3.3306690738754706e-16, co_5_size + 2.004168360008973e-292);
  co->m0 = w_0;
  co->m1 = w_1;
  co->m2 = w_2;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
  co_bound->m0 = w_0_bound;
  co_bound->m1 = w_1_bound;
  co_bound->m2 = w_2_bound;
  co_bound->m3 = co_3_bound;
  co_bound->m4 = co_4_bound;
  co_bound->m5 = co_5_bound;
}

/* co = h̄* c = [Ad]*(D) P c; P keeps component 1 of c, given in the frame of a ty joint at D;
     |error of co| <= co_bound unless inf or NaN.
   D: displacement [R | t], R rotation, t in m; c, co, co_bound: coscrew (f in N; τ in N m).
   21 mul, 12 add, 6 abs. */
static inline void ksl_working_cty_certified(const ksl_SE3_t *D, const ksl_coscrew_t *c,
    ksl_coscrew_t *co, ksl_coscrew_t *co_bound) {
  const double w_0 = KSL_MUL(D->m01, c->m1), w_1 = KSL_MUL(D->m11, c->m1),
      w_2 = KSL_MUL(D->m21, c->m1);
  const double co_3 = KSL_MUL(D->m13, w_2) - KSL_MUL(D->m23, w_1);
  const double co_4 = KSL_MUL(D->m23, w_0) - KSL_MUL(D->m03, w_2);
  const double co_5 = KSL_MUL(D->m03, w_1) - KSL_MUL(D->m13, w_0);
  const double w_2_padded = fabs(w_2) + 2.004168360008973e-292;
  const double D_13_abs = fabs(D->m13);
  const double w_1_padded = fabs(w_1) + 2.004168360008973e-292;
  const double D_23_abs = fabs(D->m23),
      co_3_size = KSL_MUL(D_13_abs, w_2_padded) + KSL_MUL(D_23_abs, w_1_padded);
  const double w_0_padded = fabs(w_0) + 2.004168360008973e-292;
  const double D_03_abs = fabs(D->m03),
      co_4_size = KSL_MUL(D_23_abs, w_0_padded) + KSL_MUL(D_03_abs, w_2_padded);
  const double co_5_size = KSL_MUL(D_03_abs, w_1_padded) + KSL_MUL(D_13_abs, w_0_padded);
  const double w_0_bound = KSL_MUL(1.1102230246251568e-16, w_0_padded),
      w_1_bound = KSL_MUL(1.1102230246251568e-16, w_1_padded),
      w_2_bound = KSL_MUL(1.1102230246251568e-16, w_2_padded);
  const double co_3_bound = KSL_MUL(3.3306690738754706e-16, co_3_size + 2.004168360008973e-292),
      co_4_bound = KSL_MUL(3.3306690738754706e-16, co_4_size + 2.004168360008973e-292),
      co_5_bound = KSL_MUL(3.3306690738754706e-16, co_5_size + 2.004168360008973e-292);
  co->m0 = w_0;
  co->m1 = w_1;
  co->m2 = w_2;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
  co_bound->m0 = w_0_bound;
  co_bound->m1 = w_1_bound;
  co_bound->m2 = w_2_bound;
  co_bound->m3 = co_3_bound;
  co_bound->m4 = co_4_bound;
  co_bound->m5 = co_5_bound;
}

/* co = h̄* c = [Ad]*(D) P c; P keeps component 2 of c, given in the frame of a tz joint at D;
     |error of co| <= co_bound unless inf or NaN.
   D: displacement [R | t], R rotation, t in m; c, co, co_bound: coscrew (f in N; τ in N m).
   21 mul, 12 add, 6 abs. */
static inline void ksl_working_ctz_certified(const ksl_SE3_t *D, const ksl_coscrew_t *c,
    ksl_coscrew_t *co, ksl_coscrew_t *co_bound) {
  const double w_0 = KSL_MUL(D->m02, c->m2), w_1 = KSL_MUL(D->m12, c->m2),
      w_2 = KSL_MUL(D->m22, c->m2);
  const double co_3 = KSL_MUL(D->m13, w_2) - KSL_MUL(D->m23, w_1);
  const double co_4 = KSL_MUL(D->m23, w_0) - KSL_MUL(D->m03, w_2);
  const double co_5 = KSL_MUL(D->m03, w_1) - KSL_MUL(D->m13, w_0);
  const double w_2_padded = fabs(w_2) + 2.004168360008973e-292;
  const double D_13_abs = fabs(D->m13);
  const double w_1_padded = fabs(w_1) + 2.004168360008973e-292;
  const double D_23_abs = fabs(D->m23),
      co_3_size = KSL_MUL(D_13_abs, w_2_padded) + KSL_MUL(D_23_abs, w_1_padded);
  const double w_0_padded = fabs(w_0) + 2.004168360008973e-292;
  const double D_03_abs = fabs(D->m03),
      co_4_size = KSL_MUL(D_23_abs, w_0_padded) + KSL_MUL(D_03_abs, w_2_padded);
  const double co_5_size = KSL_MUL(D_03_abs, w_1_padded) + KSL_MUL(D_13_abs, w_0_padded);
  const double w_0_bound = KSL_MUL(1.1102230246251568e-16, w_0_padded),
      w_1_bound = KSL_MUL(1.1102230246251568e-16, w_1_padded),
      w_2_bound = KSL_MUL(1.1102230246251568e-16, w_2_padded);
  const double co_3_bound = KSL_MUL(3.3306690738754706e-16, co_3_size + 2.004168360008973e-292),
      co_4_bound = KSL_MUL(3.3306690738754706e-16, co_4_size + 2.004168360008973e-292),
      co_5_bound = KSL_MUL(3.3306690738754706e-16, co_5_size + 2.004168360008973e-292);
  co->m0 = w_0;
  co->m1 = w_1;
  co->m2 = w_2;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
  co_bound->m0 = w_0_bound;
  co_bound->m1 = w_1_bound;
  co_bound->m2 = w_2_bound;
  co_bound->m3 = co_3_bound;
  co_bound->m4 = co_4_bound;
  co_bound->m5 = co_5_bound;
}

/* co = h̄* c = [Ad]*(D) P c; P keeps component 3 of c, given in the frame of a rx joint at D;
     |error of co| <= co_bound unless inf or NaN.
   D: displacement [R | t], R rotation, t in m; c, co, co_bound: coscrew (f in N; τ in N m).
   6 mul, 3 add, 3 abs. */
static inline void ksl_working_crx_certified(const ksl_SE3_t *D, const ksl_coscrew_t *c,
    ksl_coscrew_t *co, ksl_coscrew_t *co_bound) {
  const double w_3 = KSL_MUL(D->m00, c->m3), w_4 = KSL_MUL(D->m10, c->m3),
      w_5 = KSL_MUL(D->m20, c->m3);
  const double w_3_bound = KSL_MUL(1.1102230246251568e-16, fabs(w_3) + 2.004168360008973e-292),
      w_4_bound = KSL_MUL(1.1102230246251568e-16, fabs(w_4) + 2.004168360008973e-292),
      w_5_bound = KSL_MUL(1.1102230246251568e-16, fabs(w_5) + 2.004168360008973e-292);
  co->m0 = 0.0;
  co->m1 = 0.0;
  co->m2 = 0.0;
  co->m3 = w_3;
  co->m4 = w_4;
  co->m5 = w_5;
  co_bound->m0 = 0.0;
  co_bound->m1 = 0.0;
  co_bound->m2 = 0.0;
  co_bound->m3 = w_3_bound;
  co_bound->m4 = w_4_bound;
  co_bound->m5 = w_5_bound;
}

/* co = h̄* c = [Ad]*(D) P c; P keeps component 4 of c, given in the frame of a ry joint at D;
     |error of co| <= co_bound unless inf or NaN.
   D: displacement [R | t], R rotation, t in m; c, co, co_bound: coscrew (f in N; τ in N m).
   6 mul, 3 add, 3 abs. */
static inline void ksl_working_cry_certified(const ksl_SE3_t *D, const ksl_coscrew_t *c,
    ksl_coscrew_t *co, ksl_coscrew_t *co_bound) {
  const double w_3 = KSL_MUL(D->m01, c->m4), w_4 = KSL_MUL(D->m11, c->m4),
      w_5 = KSL_MUL(D->m21, c->m4);
  const double w_3_bound = KSL_MUL(1.1102230246251568e-16, fabs(w_3) + 2.004168360008973e-292),
      w_4_bound = KSL_MUL(1.1102230246251568e-16, fabs(w_4) + 2.004168360008973e-292),
      w_5_bound = KSL_MUL(1.1102230246251568e-16, fabs(w_5) + 2.004168360008973e-292);
  co->m0 = 0.0;
  co->m1 = 0.0;
  co->m2 = 0.0;
  co->m3 = w_3;
  co->m4 = w_4;
  co->m5 = w_5;
  co_bound->m0 = 0.0;
  co_bound->m1 = 0.0;
  co_bound->m2 = 0.0;
  co_bound->m3 = w_3_bound;
  co_bound->m4 = w_4_bound;
  co_bound->m5 = w_5_bound;
}

/* co = h̄* c = [Ad]*(D) P c; P keeps component 5 of c, given in the frame of a rz joint at D;
     |error of co| <= co_bound unless inf or NaN.
   D: displacement [R | t], R rotation, t in m; c, co, co_bound: coscrew (f in N; τ in N m).
   6 mul, 3 add, 3 abs. */
static inline void ksl_working_crz_certified(const ksl_SE3_t *D, const ksl_coscrew_t *c,
    ksl_coscrew_t *co, ksl_coscrew_t *co_bound) {
  const double w_3 = KSL_MUL(D->m02, c->m5), w_4 = KSL_MUL(D->m12, c->m5),
      w_5 = KSL_MUL(D->m22, c->m5);
  const double w_3_bound = KSL_MUL(1.1102230246251568e-16, fabs(w_3) + 2.004168360008973e-292),
      w_4_bound = KSL_MUL(1.1102230246251568e-16, fabs(w_4) + 2.004168360008973e-292),
      w_5_bound = KSL_MUL(1.1102230246251568e-16, fabs(w_5) + 2.004168360008973e-292);
  co->m0 = 0.0;
  co->m1 = 0.0;
  co->m2 = 0.0;
  co->m3 = w_3;
  co->m4 = w_4;
  co->m5 = w_5;
  co_bound->m0 = 0.0;
  co_bound->m1 = 0.0;
  co_bound->m2 = 0.0;
  co_bound->m3 = w_3_bound;
  co_bound->m4 = w_4_bound;
  co_bound->m5 = w_5_bound;
}

/* self = a self; |error of self| <= self_bound unless inf or NaN.
   self, self_bound: coscrew (f in N; τ in N m); a: number.
   12 mul, 6 add, 6 abs. */
static inline void ksl_coscrewf_scale_certified(ksl_coscrewf_t *self, const float a,
    ksl_coscrewf_t *self_bound) {
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
   a: number; x, y, y_bound: coscrew (f in N; τ in N m).
   12 mul, 18 add, 12 abs. */
static inline void ksl_axpy_ccf_certified(const float a, const ksl_coscrewf_t *x,
    ksl_coscrewf_t *y, ksl_coscrewf_t *y_bound) {
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
   x, y, y_bound: coscrew (f in N; τ in N m).
   6 mul, 6 add, 6 abs. */
static inline void ksl_xpy_ccf_certified(const ksl_coscrewf_t *x, ksl_coscrewf_t *y,
    ksl_coscrewf_t *y_bound) {
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
   x, y, y_bound: coscrew (f in N; τ in N m).
   6 mul, 6 add, 6 abs. */
static inline void ksl_nxpy_ccf_certified(const ksl_coscrewf_t *x, ksl_coscrewf_t *y,
    ksl_coscrewf_t *y_bound) {
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

/* co = a ci; |error of co| <= co_bound unless inf or NaN.
   a: number; ci, co, co_bound: coscrew (f in N; τ in N m).
   12 mul, 6 add, 6 abs. */
static inline void ksl_product_acf_certified(const float a, const ksl_coscrewf_t *ci,
    ksl_coscrewf_t *co, ksl_coscrewf_t *co_bound) {
  const float co_0 = KSL_MULF(a, ci->m0), co_1 = KSL_MULF(a, ci->m1), co_2 = KSL_MULF(a, ci->m2),
      co_3 = KSL_MULF(a, ci->m3), co_4 = KSL_MULF(a, ci->m4), co_5 = KSL_MULF(a, ci->m5);
  const float co_0_bound = KSL_MULF(5.960465e-08f, fabsf(co_0) + 1.9721523e-31f),
      co_1_bound = KSL_MULF(5.960465e-08f, fabsf(co_1) + 1.9721523e-31f),
      co_2_bound = KSL_MULF(5.960465e-08f, fabsf(co_2) + 1.9721523e-31f),
      co_3_bound = KSL_MULF(5.960465e-08f, fabsf(co_3) + 1.9721523e-31f),
      co_4_bound = KSL_MULF(5.960465e-08f, fabsf(co_4) + 1.9721523e-31f),
      co_5_bound = KSL_MULF(5.960465e-08f, fabsf(co_5) + 1.9721523e-31f);
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

/* co = c1 + c2; |error of co| <= co_bound unless inf or NaN.
   c1, c2, co, co_bound: coscrew (f in N; τ in N m).
   6 mul, 6 add, 6 abs. */
static inline void ksl_add_ccf_certified(const ksl_coscrewf_t *c1, const ksl_coscrewf_t *c2,
    ksl_coscrewf_t *co, ksl_coscrewf_t *co_bound) {
  const float co_0 = c1->m0 + c2->m0, co_1 = c1->m1 + c2->m1, co_2 = c1->m2 + c2->m2,
      co_3 = c1->m3 + c2->m3, co_4 = c1->m4 + c2->m4, co_5 = c1->m5 + c2->m5;
  const float co_0_bound = KSL_MULF(5.960465e-08f, fabsf(co_0)),
      co_1_bound = KSL_MULF(5.960465e-08f, fabsf(co_1)),
      co_2_bound = KSL_MULF(5.960465e-08f, fabsf(co_2)),
      co_3_bound = KSL_MULF(5.960465e-08f, fabsf(co_3)),
      co_4_bound = KSL_MULF(5.960465e-08f, fabsf(co_4)),
      co_5_bound = KSL_MULF(5.960465e-08f, fabsf(co_5));
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

/* co = c1 - c2; |error of co| <= co_bound unless inf or NaN.
   c1, c2, co, co_bound: coscrew (f in N; τ in N m).
   6 mul, 6 add, 6 abs. */
static inline void ksl_subtract_ccf_certified(const ksl_coscrewf_t *c1, const ksl_coscrewf_t *c2,
    ksl_coscrewf_t *co, ksl_coscrewf_t *co_bound) {
  const float co_0 = c1->m0 - c2->m0, co_1 = c1->m1 - c2->m1, co_2 = c1->m2 - c2->m2,
      co_3 = c1->m3 - c2->m3, co_4 = c1->m4 - c2->m4, co_5 = c1->m5 - c2->m5;
  const float co_0_bound = KSL_MULF(5.960465e-08f, fabsf(co_0)),
      co_1_bound = KSL_MULF(5.960465e-08f, fabsf(co_1)),
      co_2_bound = KSL_MULF(5.960465e-08f, fabsf(co_2)),
      co_3_bound = KSL_MULF(5.960465e-08f, fabsf(co_3)),
      co_4_bound = KSL_MULF(5.960465e-08f, fabsf(co_4)),
      co_5_bound = KSL_MULF(5.960465e-08f, fabsf(co_5));
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

/* co = (c1.lin + c2.lin ; c1.ang); |error of co| <= co_bound unless inf or NaN.
   c1, c2, co, co_bound: coscrew (f in N; τ in N m).
   3 mul, 3 add, 3 abs. */
static inline void ksl_add_cctf_certified(const ksl_coscrewf_t *c1, const ksl_coscrewf_t *c2,
    ksl_coscrewf_t *co, ksl_coscrewf_t *co_bound) {
  const float co_0 = c1->m0 + c2->m0, co_1 = c1->m1 + c2->m1, co_2 = c1->m2 + c2->m2;
  const float co_0_bound = KSL_MULF(5.960465e-08f, fabsf(co_0)),
      co_1_bound = KSL_MULF(5.960465e-08f, fabsf(co_1)),
      co_2_bound = KSL_MULF(5.960465e-08f, fabsf(co_2));
  const float c1_m3 = c1->m3;
  const float c1_m4 = c1->m4;
  const float c1_m5 = c1->m5;
  co->m0 = co_0;
  co->m1 = co_1;
  co->m2 = co_2;
  co->m3 = c1_m3;
  co->m4 = c1_m4;
  co->m5 = c1_m5;
  co_bound->m0 = co_0_bound;
  co_bound->m1 = co_1_bound;
  co_bound->m2 = co_2_bound;
  co_bound->m3 = 0.0f;
  co_bound->m4 = 0.0f;
  co_bound->m5 = 0.0f;
}

/* co = [Ad]*(t) ci; |error of co| <= co_bound unless inf or NaN.
   t: vector; ci, co, co_bound: coscrew (f in N; τ in N m).
   9 mul, 15 add, 9 abs. */
static inline void ksl_product_CoAdtcf_certified(const ksl_vec3f_t *t, const ksl_coscrewf_t *ci,
    ksl_coscrewf_t *co, ksl_coscrewf_t *co_bound) {
  const float co_3a = KSL_MULF(t->y, ci->m2), co_3b = KSL_MULF(t->z, ci->m1),
      co_3 = co_3a - co_3b + ci->m3;
  const float co_4a = KSL_MULF(t->z, ci->m0), co_4b = KSL_MULF(t->x, ci->m2),
      co_4 = co_4a - co_4b + ci->m4;
  const float co_5a = KSL_MULF(t->x, ci->m1), co_5b = KSL_MULF(t->y, ci->m0),
      co_5 = co_5a - co_5b + ci->m5;
  const float co_3_size = fabsf(co_3a) + fabsf(co_3b) + fabsf(ci->m3),
      co_4_size = fabsf(co_4a) + fabsf(co_4b) + fabsf(ci->m4),
      co_5_size = fabsf(co_5a) + fabsf(co_5b) + fabsf(ci->m5);
  const float co_3_bound = KSL_MULF(1.7881396e-07f, co_3_size + 1.9721523e-31f),
      co_4_bound = KSL_MULF(1.7881396e-07f, co_4_size + 1.9721523e-31f),
      co_5_bound = KSL_MULF(1.7881396e-07f, co_5_size + 1.9721523e-31f);
  const float ci_m0 = ci->m0;
  const float ci_m1 = ci->m1;
  const float ci_m2 = ci->m2;
  co->m0 = ci_m0;
  co->m1 = ci_m1;
  co->m2 = ci_m2;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
  co_bound->m0 = 0.0f;
  co_bound->m1 = 0.0f;
  co_bound->m2 = 0.0f;
  co_bound->m3 = co_3_bound;
  co_bound->m4 = co_4_bound;
  co_bound->m5 = co_5_bound;
}

/* co = [Ad]*(t)^-1 ci; |error of co| <= co_bound unless inf or NaN.
   t: vector; ci, co, co_bound: coscrew (f in N; τ in N m).
   9 mul, 15 add, 9 abs. */
static inline void ksl_product_CoAdtinvcf_certified(const ksl_vec3f_t *t,
    const ksl_coscrewf_t *ci, ksl_coscrewf_t *co, ksl_coscrewf_t *co_bound) {
  const float co_3a = KSL_MULF(t->z, ci->m1), co_3b = KSL_MULF(t->y, ci->m2),
      co_3 = co_3a - co_3b + ci->m3;
  const float co_4a = KSL_MULF(t->x, ci->m2), co_4b = KSL_MULF(t->z, ci->m0),
      co_4 = co_4a - co_4b + ci->m4;
  const float co_5a = KSL_MULF(t->y, ci->m0), co_5b = KSL_MULF(t->x, ci->m1),
      co_5 = co_5a - co_5b + ci->m5;
  const float co_3_size = fabsf(co_3a) + fabsf(co_3b) + fabsf(ci->m3),
      co_4_size = fabsf(co_4a) + fabsf(co_4b) + fabsf(ci->m4),
      co_5_size = fabsf(co_5a) + fabsf(co_5b) + fabsf(ci->m5);
  const float co_3_bound = KSL_MULF(1.7881396e-07f, co_3_size + 1.9721523e-31f),
      co_4_bound = KSL_MULF(1.7881396e-07f, co_4_size + 1.9721523e-31f),
      co_5_bound = KSL_MULF(1.7881396e-07f, co_5_size + 1.9721523e-31f);
  const float ci_m0 = ci->m0;
  const float ci_m1 = ci->m1;
  const float ci_m2 = ci->m2;
  co->m0 = ci_m0;
  co->m1 = ci_m1;
  co->m2 = ci_m2;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
  co_bound->m0 = 0.0f;
  co_bound->m1 = 0.0f;
  co_bound->m2 = 0.0f;
  co_bound->m3 = co_3_bound;
  co_bound->m4 = co_4_bound;
  co_bound->m5 = co_5_bound;
}

/* co = [Ad]*(t) (-ci); |error of co| <= co_bound unless inf or NaN.
   t: vector; ci, co, co_bound: coscrew (f in N; τ in N m).
   9 mul, 15 add, 3 neg, 9 abs. */
static inline void ksl_product_CoAdtcinvf_certified(const ksl_vec3f_t *t,
    const ksl_coscrewf_t *ci, ksl_coscrewf_t *co, ksl_coscrewf_t *co_bound) {
  const float co_0 = -ci->m0, co_1 = -ci->m1, co_2 = -ci->m2;
  const float co_3a = KSL_MULF(t->z, ci->m1), co_3b = KSL_MULF(t->y, ci->m2),
      co_3 = co_3a - co_3b - ci->m3;
  const float co_4a = KSL_MULF(t->x, ci->m2), co_4b = KSL_MULF(t->z, ci->m0),
      co_4 = co_4a - co_4b - ci->m4;
  const float co_5a = KSL_MULF(t->y, ci->m0), co_5b = KSL_MULF(t->x, ci->m1),
      co_5 = co_5a - co_5b - ci->m5;
  const float co_3_size = fabsf(co_3a) + fabsf(co_3b) + fabsf(ci->m3),
      co_4_size = fabsf(co_4a) + fabsf(co_4b) + fabsf(ci->m4),
      co_5_size = fabsf(co_5a) + fabsf(co_5b) + fabsf(ci->m5);
  const float co_3_bound = KSL_MULF(1.7881396e-07f, co_3_size + 1.9721523e-31f),
      co_4_bound = KSL_MULF(1.7881396e-07f, co_4_size + 1.9721523e-31f),
      co_5_bound = KSL_MULF(1.7881396e-07f, co_5_size + 1.9721523e-31f);
  co->m0 = co_0;
  co->m1 = co_1;
  co->m2 = co_2;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
  co_bound->m0 = 0.0f;
  co_bound->m1 = 0.0f;
  co_bound->m2 = 0.0f;
  co_bound->m3 = co_3_bound;
  co_bound->m4 = co_4_bound;
  co_bound->m5 = co_5_bound;
}

/* co = [Ad]*(R) ci; |error of co| <= co_bound unless inf or NaN.
   R: rotation or other 3×3 matrix; ci, co, co_bound: coscrew (f in N; τ in N m).
   24 mul, 30 add, 18 abs. */
static inline void ksl_product_CoAdrcf_certified(const ksl_mat3x3f_t *R, const ksl_coscrewf_t *ci,
    ksl_coscrewf_t *co, ksl_coscrewf_t *co_bound) {
  const float co_0a = KSL_MULF(R->m00, ci->m0), co_0b = KSL_MULF(R->m01, ci->m1),
      co_0d = KSL_MULF(R->m02, ci->m2), co_0 = co_0a + co_0b + co_0d;
  const float co_1a = KSL_MULF(R->m10, ci->m0), co_1b = KSL_MULF(R->m11, ci->m1),
      co_1d = KSL_MULF(R->m12, ci->m2), co_1 = co_1a + co_1b + co_1d;
  const float co_2a = KSL_MULF(R->m20, ci->m0), co_2b = KSL_MULF(R->m21, ci->m1),
      co_2d = KSL_MULF(R->m22, ci->m2), co_2 = co_2a + co_2b + co_2d;
  const float co_3a = KSL_MULF(R->m00, ci->m3), co_3b = KSL_MULF(R->m01, ci->m4),
      co_3d = KSL_MULF(R->m02, ci->m5), co_3 = co_3a + co_3b + co_3d;
  const float co_4a = KSL_MULF(R->m10, ci->m3), co_4b = KSL_MULF(R->m11, ci->m4),
      co_4d = KSL_MULF(R->m12, ci->m5), co_4 = co_4a + co_4b + co_4d;
  const float co_5a = KSL_MULF(R->m20, ci->m3), co_5b = KSL_MULF(R->m21, ci->m4),
      co_5d = KSL_MULF(R->m22, ci->m5), co_5 = co_5a + co_5b + co_5d;
  const float co_0_size = fabsf(co_0a) + fabsf(co_0b) + fabsf(co_0d),
      co_1_size = fabsf(co_1a) + fabsf(co_1b) + fabsf(co_1d),
      co_2_size = fabsf(co_2a) + fabsf(co_2b) + fabsf(co_2d),
      co_3_size = fabsf(co_3a) + fabsf(co_3b) + fabsf(co_3d),
      co_4_size = fabsf(co_4a) + fabsf(co_4b) + fabsf(co_4d),
      co_5_size = fabsf(co_5a) + fabsf(co_5b) + fabsf(co_5d);
  const float co_0_bound = KSL_MULF(1.7881396e-07f, co_0_size + 1.9721523e-31f),
      co_1_bound = KSL_MULF(1.7881396e-07f, co_1_size + 1.9721523e-31f),
      co_2_bound = KSL_MULF(1.7881396e-07f, co_2_size + 1.9721523e-31f),
      co_3_bound = KSL_MULF(1.7881396e-07f, co_3_size + 1.9721523e-31f),
      co_4_bound = KSL_MULF(1.7881396e-07f, co_4_size + 1.9721523e-31f),
      co_5_bound = KSL_MULF(1.7881396e-07f, co_5_size + 1.9721523e-31f);
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

/* co = [Ad]*(R)^-1 ci; |error of co| <= co_bound unless inf or NaN.
   R: rotation or other 3×3 matrix; ci, co, co_bound: coscrew (f in N; τ in N m).
   24 mul, 30 add, 18 abs. */
static inline void ksl_product_CoAdrinvcf_certified(const ksl_mat3x3f_t *R,
    const ksl_coscrewf_t *ci, ksl_coscrewf_t *co, ksl_coscrewf_t *co_bound) {
  const float co_0a = KSL_MULF(R->m00, ci->m0), co_0b = KSL_MULF(R->m10, ci->m1),
      co_0d = KSL_MULF(R->m20, ci->m2), co_0 = co_0a + co_0b + co_0d;
  const float co_1a = KSL_MULF(R->m01, ci->m0), co_1b = KSL_MULF(R->m11, ci->m1),
      co_1d = KSL_MULF(R->m21, ci->m2), co_1 = co_1a + co_1b + co_1d;
  const float co_2a = KSL_MULF(R->m02, ci->m0), co_2b = KSL_MULF(R->m12, ci->m1),
      co_2d = KSL_MULF(R->m22, ci->m2), co_2 = co_2a + co_2b + co_2d;
  const float co_3a = KSL_MULF(R->m00, ci->m3), co_3b = KSL_MULF(R->m10, ci->m4),
      co_3d = KSL_MULF(R->m20, ci->m5), co_3 = co_3a + co_3b + co_3d;
  const float co_4a = KSL_MULF(R->m01, ci->m3), co_4b = KSL_MULF(R->m11, ci->m4),
      co_4d = KSL_MULF(R->m21, ci->m5), co_4 = co_4a + co_4b + co_4d;
  const float co_5a = KSL_MULF(R->m02, ci->m3), co_5b = KSL_MULF(R->m12, ci->m4),
      co_5d = KSL_MULF(R->m22, ci->m5), co_5 = co_5a + co_5b + co_5d;
  const float co_0_size = fabsf(co_0a) + fabsf(co_0b) + fabsf(co_0d),
      co_1_size = fabsf(co_1a) + fabsf(co_1b) + fabsf(co_1d),
      co_2_size = fabsf(co_2a) + fabsf(co_2b) + fabsf(co_2d),
      co_3_size = fabsf(co_3a) + fabsf(co_3b) + fabsf(co_3d),
      co_4_size = fabsf(co_4a) + fabsf(co_4b) + fabsf(co_4d),
      co_5_size = fabsf(co_5a) + fabsf(co_5b) + fabsf(co_5d);
  const float co_0_bound = KSL_MULF(1.7881396e-07f, co_0_size + 1.9721523e-31f),
      co_1_bound = KSL_MULF(1.7881396e-07f, co_1_size + 1.9721523e-31f),
      co_2_bound = KSL_MULF(1.7881396e-07f, co_2_size + 1.9721523e-31f),
      co_3_bound = KSL_MULF(1.7881396e-07f, co_3_size + 1.9721523e-31f),
      co_4_bound = KSL_MULF(1.7881396e-07f, co_4_size + 1.9721523e-31f),
      co_5_bound = KSL_MULF(1.7881396e-07f, co_5_size + 1.9721523e-31f);
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

/* co = [Ad]*(R) (-ci); |error of co| <= co_bound unless inf or NaN.
   R: rotation or other 3×3 matrix; ci, co, co_bound: coscrew (f in N; τ in N m).
   24 mul, 30 add, 6 neg, 18 abs. */
static inline void ksl_product_CoAdrcinvf_certified(const ksl_mat3x3f_t *R,
    const ksl_coscrewf_t *ci, ksl_coscrewf_t *co, ksl_coscrewf_t *co_bound) {
  const float co_0a = KSL_MULF(R->m00, ci->m0), co_0b = KSL_MULF(R->m01, ci->m1),
      co_0d = KSL_MULF(R->m02, ci->m2), co_0 = -(co_0a + co_0b + co_0d);
  const float co_1a = KSL_MULF(R->m10, ci->m0), co_1b = KSL_MULF(R->m11, ci->m1),
      co_1d = KSL_MULF(R->m12, ci->m2), co_1 = -(co_1a + co_1b + co_1d);
  const float co_2a = KSL_MULF(R->m20, ci->m0), co_2b = KSL_MULF(R->m21, ci->m1),
      co_2d = KSL_MULF(R->m22, ci->m2), co_2 = -(co_2a + co_2b + co_2d);
  const float co_3a = KSL_MULF(R->m00, ci->m3), co_3b = KSL_MULF(R->m01, ci->m4),
      co_3d = KSL_MULF(R->m02, ci->m5), co_3 = -(co_3a + co_3b + co_3d);
  const float co_4a = KSL_MULF(R->m10, ci->m3), co_4b = KSL_MULF(R->m11, ci->m4),
      co_4d = KSL_MULF(R->m12, ci->m5), co_4 = -(co_4a + co_4b + co_4d);
  const float co_5a = KSL_MULF(R->m20, ci->m3), co_5b = KSL_MULF(R->m21, ci->m4),
      co_5d = KSL_MULF(R->m22, ci->m5), co_5 = -(co_5a + co_5b + co_5d);
  const float co_0e_bound = KSL_MULF(1.7881396e-07f, fabsf(co_0a) + fabsf(co_0b) + fabsf(co_0d)
          + 1.9721523e-31f);
  const float co_1e_bound = KSL_MULF(1.7881396e-07f, fabsf(co_1a) + fabsf(co_1b) + fabsf(co_1d)
          + 1.9721523e-31f);
  const float co_2e_bound = KSL_MULF(1.7881396e-07f, fabsf(co_2a) + fabsf(co_2b) + fabsf(co_2d)
          + 1.9721523e-31f);
  const float co_3e_bound = KSL_MULF(1.7881396e-07f, fabsf(co_3a) + fabsf(co_3b) + fabsf(co_3d)
          + 1.9721523e-31f);
  const float co_4e_bound = KSL_MULF(1.7881396e-07f, fabsf(co_4a) + fabsf(co_4b) + fabsf(co_4d)
          + 1.9721523e-31f);
  const float co_5e_bound = KSL_MULF(1.7881396e-07f, fabsf(co_5a) + fabsf(co_5b) + fabsf(co_5d)
          + 1.9721523e-31f);
  co->m0 = co_0;
  co->m1 = co_1;
  co->m2 = co_2;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
  co_bound->m0 = co_0e_bound;
  co_bound->m1 = co_1e_bound;
  co_bound->m2 = co_2e_bound;
  co_bound->m3 = co_3e_bound;
  co_bound->m4 = co_4e_bound;
  co_bound->m5 = co_5e_bound;
}

/* co = [Ad]*(D) ci = [Ad]*(t) [Ad]*(R) ci; |error of co| <= co_bound unless inf or NaN.
   D: displacement [R | t], R rotation, t in m; ci, co, co_bound: coscrew (f in N; τ in N m).
   36 mul, 42 add, 21 abs. */
static inline void ksl_product_CoAdcf_certified(const ksl_SE3f_t *D, const ksl_coscrewf_t *ci,
    ksl_coscrewf_t *co, ksl_coscrewf_t *co_bound) {
  const float w_0a = KSL_MULF(D->m00, ci->m0), w_0b = KSL_MULF(D->m01, ci->m1),
      w_0d = KSL_MULF(D->m02, ci->m2), w_0 = w_0a + w_0b + w_0d;
  const float w_1a = KSL_MULF(D->m10, ci->m0), w_1b = KSL_MULF(D->m11, ci->m1),
      w_1d = KSL_MULF(D->m12, ci->m2), w_1 = w_1a + w_1b + w_1d;
  const float w_2a = KSL_MULF(D->m20, ci->m0), w_2b = KSL_MULF(D->m21, ci->m1),
      w_2d = KSL_MULF(D->m22, ci->m2), w_2 = w_2a + w_2b + w_2d;
  const float w_3a = KSL_MULF(D->m00, ci->m3), w_3b = KSL_MULF(D->m01, ci->m4),
      w_3d = KSL_MULF(D->m02, ci->m5), w_3 = w_3a + w_3b + w_3d;
  const float w_4a = KSL_MULF(D->m10, ci->m3), w_4b = KSL_MULF(D->m11, ci->m4),
      w_4d = KSL_MULF(D->m12, ci->m5), w_4 = w_4a + w_4b + w_4d;
  const float w_5a = KSL_MULF(D->m20, ci->m3), w_5b = KSL_MULF(D->m21, ci->m4),
      w_5d = KSL_MULF(D->m22, ci->m5), w_5 = w_5a + w_5b + w_5d;
  const float co_3 = KSL_MULF(D->m13, w_2) - KSL_MULF(D->m23, w_1) + w_3;
  const float co_4 = KSL_MULF(D->m23, w_0) - KSL_MULF(D->m03, w_2) + w_4;
  const float co_5 = KSL_MULF(D->m03, w_1) - KSL_MULF(D->m13, w_0) + w_5;
  const float w_0_size = fabsf(w_0a) + fabsf(w_0b) + fabsf(w_0d),
      w_1_size = fabsf(w_1a) + fabsf(w_1b) + fabsf(w_1d),
      w_2_size = fabsf(w_2a) + fabsf(w_2b) + fabsf(w_2d),
      w_3_size = fabsf(w_3a) + fabsf(w_3b) + fabsf(w_3d),
      w_4_size = fabsf(w_4a) + fabsf(w_4b) + fabsf(w_4d),
      w_5_size = fabsf(w_5a) + fabsf(w_5b) + fabsf(w_5d);
  const float w_2_padded = w_2_size + 1.9721523e-31f;
  const float D_13_abs = fabsf(D->m13);
  const float w_1_padded = w_1_size + 1.9721523e-31f;
  const float D_23_abs = fabsf(D->m23),
      co_3_size = KSL_MULF(D_13_abs, w_2_padded) + KSL_MULF(D_23_abs, w_1_padded) + w_3_size;
  const float w_0_padded = w_0_size + 1.9721523e-31f;
  const float D_03_abs = fabsf(D->m03),
      co_4_size = KSL_MULF(D_23_abs, w_0_padded) + KSL_MULF(D_03_abs, w_2_padded) + w_4_size;
  const float co_5_size = KSL_MULF(D_03_abs, w_1_padded) + KSL_MULF(D_13_abs, w_0_padded)
          + w_5_size;
  const float w_0_bound = KSL_MULF(1.7881396e-07f, w_0_padded),
      w_1_bound = KSL_MULF(1.7881396e-07f, w_1_padded),
      w_2_bound = KSL_MULF(1.7881396e-07f, w_2_padded);
  const float co_3_bound = KSL_MULF(3.5762795e-07f, co_3_size + 1.9721523e-31f),
      co_4_bound = KSL_MULF(3.5762795e-07f, co_4_size + 1.9721523e-31f),
      co_5_bound = KSL_MULF(3.5762795e-07f, co_5_size + 1.9721523e-31f);
  co->m0 = w_0;
  co->m1 = w_1;
  co->m2 = w_2;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
  co_bound->m0 = w_0_bound;
  co_bound->m1 = w_1_bound;
  co_bound->m2 = w_2_bound;
  co_bound->m3 = co_3_bound;
  co_bound->m4 = co_4_bound;
  co_bound->m5 = co_5_bound;
}

/* co = [Ad]*(D)^-1 ci = [Ad]*(R^T) [Ad]*(-t) ci; |error of co| <= co_bound unless inf or NaN.
   D: displacement [R | t], R rotation, t in m; ci, co, co_bound: coscrew (f in N; τ in N m).
   39 mul, 45 add, 27 abs. */
static inline void ksl_product_CoAdinvcf_certified(const ksl_SE3f_t *D, const ksl_coscrewf_t *ci,
    ksl_coscrewf_t *co, ksl_coscrewf_t *co_bound) {
  const float w_3a = KSL_MULF(D->m23, ci->m1), w_3b = KSL_MULF(D->m13, ci->m2),
      w_3 = w_3a - w_3b + ci->m3;
  const float w_4a = KSL_MULF(D->m03, ci->m2), w_4b = KSL_MULF(D->m23, ci->m0),
      w_4 = w_4a - w_4b + ci->m4;
  const float w_5a = KSL_MULF(D->m13, ci->m0), w_5b = KSL_MULF(D->m03, ci->m1),
      w_5 = w_5a - w_5b + ci->m5;
  const float co_0a = KSL_MULF(D->m00, ci->m0), co_0b = KSL_MULF(D->m10, ci->m1),
      co_0d = KSL_MULF(D->m20, ci->m2), co_0 = co_0a + co_0b + co_0d;
  const float co_1a = KSL_MULF(D->m01, ci->m0), co_1b = KSL_MULF(D->m11, ci->m1),
      co_1d = KSL_MULF(D->m21, ci->m2), co_1 = co_1a + co_1b + co_1d;
  const float co_2a = KSL_MULF(D->m02, ci->m0), co_2b = KSL_MULF(D->m12, ci->m1),
      co_2d = KSL_MULF(D->m22, ci->m2), co_2 = co_2a + co_2b + co_2d;
  const float co_3 = KSL_MULF(D->m00, w_3) + KSL_MULF(D->m10, w_4) + KSL_MULF(D->m20, w_5);
  const float co_4 = KSL_MULF(D->m01, w_3) + KSL_MULF(D->m11, w_4) + KSL_MULF(D->m21, w_5),
      co_5 = KSL_MULF(D->m02, w_3) + KSL_MULF(D->m12, w_4) + KSL_MULF(D->m22, w_5);
  const float w_3_size = fabsf(w_3a) + fabsf(w_3b) + fabsf(ci->m3),
      w_4_size = fabsf(w_4a) + fabsf(w_4b) + fabsf(ci->m4),
      w_5_size = fabsf(w_5a) + fabsf(w_5b) + fabsf(ci->m5);
  const float co_0_size = fabsf(co_0a) + fabsf(co_0b) + fabsf(co_0d),
      co_1_size = fabsf(co_1a) + fabsf(co_1b) + fabsf(co_1d),
      co_2_size = fabsf(co_2a) + fabsf(co_2b) + fabsf(co_2d);
  const float w_3_padded = w_3_size + 1.9721523e-31f, w_4_padded = w_4_size + 1.9721523e-31f,
      w_5_padded = w_5_size + 1.9721523e-31f;
  const float co_3_size = KSL_MULF(fabsf(D->m00), w_3_padded) + KSL_MULF(fabsf(D->m10), w_4_padded)
          + KSL_MULF(fabsf(D->m20), w_5_padded),
      co_4_size = KSL_MULF(fabsf(D->m01), w_3_padded) + KSL_MULF(fabsf(D->m11), w_4_padded)
          + KSL_MULF(fabsf(D->m21), w_5_padded),
      co_5_size = KSL_MULF(fabsf(D->m02), w_3_padded) + KSL_MULF(fabsf(D->m12), w_4_padded)
          + KSL_MULF(fabsf(D->m22), w_5_padded);
  const float co_0_bound = KSL_MULF(1.7881396e-07f, co_0_size + 1.9721523e-31f),
      co_1_bound = KSL_MULF(1.7881396e-07f, co_1_size + 1.9721523e-31f),
      co_2_bound = KSL_MULF(1.7881396e-07f, co_2_size + 1.9721523e-31f),
      co_3_bound = KSL_MULF(3.5762795e-07f, co_3_size + 1.9721523e-31f),
      co_4_bound = KSL_MULF(3.5762795e-07f, co_4_size + 1.9721523e-31f),
      co_5_bound = KSL_MULF(3.5762795e-07f, co_5_size + 1.9721523e-31f);
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

/* co = [Ad]*(D) (-ci); |error of co| <= co_bound unless inf or NaN.
   D: displacement [R | t], R rotation, t in m; ci, co, co_bound: coscrew (f in N; τ in N m).
   36 mul, 42 add, 6 neg, 21 abs. */
static inline void ksl_product_CoAdcinvf_certified(const ksl_SE3f_t *D, const ksl_coscrewf_t *ci,
    ksl_coscrewf_t *co, ksl_coscrewf_t *co_bound) {
  const float w_0a = KSL_MULF(D->m00, ci->m0), w_0b = KSL_MULF(D->m01, ci->m1),
      w_0d = KSL_MULF(D->m02, ci->m2), w_0 = -(w_0a + w_0b + w_0d);
  const float w_1a = KSL_MULF(D->m10, ci->m0), w_1b = KSL_MULF(D->m11, ci->m1),
      w_1d = KSL_MULF(D->m12, ci->m2), w_1 = -(w_1a + w_1b + w_1d);
  const float w_2a = KSL_MULF(D->m20, ci->m0), w_2b = KSL_MULF(D->m21, ci->m1),
      w_2d = KSL_MULF(D->m22, ci->m2), w_2 = -(w_2a + w_2b + w_2d);
  const float w_3a = KSL_MULF(D->m00, ci->m3), w_3b = KSL_MULF(D->m01, ci->m4),
      w_3d = KSL_MULF(D->m02, ci->m5), w_3 = -(w_3a + w_3b + w_3d);
  const float w_4a = KSL_MULF(D->m10, ci->m3), w_4b = KSL_MULF(D->m11, ci->m4),
      w_4d = KSL_MULF(D->m12, ci->m5), w_4 = -(w_4a + w_4b + w_4d);
  const float w_5a = KSL_MULF(D->m20, ci->m3), w_5b = KSL_MULF(D->m21, ci->m4),
      w_5d = KSL_MULF(D->m22, ci->m5), w_5 = -(w_5a + w_5b + w_5d);
  const float co_3 = KSL_MULF(D->m13, w_2) - KSL_MULF(D->m23, w_1) + w_3;
  const float co_4 = KSL_MULF(D->m23, w_0) - KSL_MULF(D->m03, w_2) + w_4;
  const float co_5 = KSL_MULF(D->m03, w_1) - KSL_MULF(D->m13, w_0) + w_5;
  const float w_2e_padded = fabsf(w_2a) + fabsf(w_2b) + fabsf(w_2d) + 1.9721523e-31f;
  const float D_13_abs = fabsf(D->m13);
  const float w_1e_padded = fabsf(w_1a) + fabsf(w_1b) + fabsf(w_1d) + 1.9721523e-31f;
  const float D_23_abs = fabsf(D->m23),
      co_3_size = KSL_MULF(D_13_abs, w_2e_padded) + KSL_MULF(D_23_abs, w_1e_padded)
          + (fabsf(w_3a) + fabsf(w_3b) + fabsf(w_3d));
  const float w_0e_padded = fabsf(w_0a) + fabsf(w_0b) + fabsf(w_0d) + 1.9721523e-31f;
  const float D_03_abs = fabsf(D->m03),
      co_4_size = KSL_MULF(D_23_abs, w_0e_padded) + KSL_MULF(D_03_abs, w_2e_padded)
          + (fabsf(w_4a) + fabsf(w_4b) + fabsf(w_4d));
  const float co_5_size = KSL_MULF(D_03_abs, w_1e_padded) + KSL_MULF(D_13_abs, w_0e_padded)
          + (fabsf(w_5a) + fabsf(w_5b) + fabsf(w_5d));
  const float w_0e_bound = KSL_MULF(1.7881396e-07f, w_0e_padded);
  const float w_1e_bound = KSL_MULF(1.7881396e-07f, w_1e_padded);
  const float w_2e_bound = KSL_MULF(1.7881396e-07f, w_2e_padded);
  const float co_3_bound = KSL_MULF(3.5762795e-07f, co_3_size + 1.9721523e-31f),
      co_4_bound = KSL_MULF(3.5762795e-07f, co_4_size + 1.9721523e-31f),
      co_5_bound = KSL_MULF(3.5762795e-07f, co_5_size + 1.9721523e-31f);
  co->m0 = w_0;
  co->m1 = w_1;
  co->m2 = w_2;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
  co_bound->m0 = w_0e_bound;
  co_bound->m1 = w_1e_bound;
  co_bound->m2 = w_2e_bound;
  co_bound->m3 = co_3_bound;
  co_bound->m4 = co_4_bound;
  co_bound->m5 = co_5_bound;
}

/* co = h_tx: column 0 of [Ad]*(D); |error of co| <= co_bound unless inf or NaN.
   D: displacement [R | t], R rotation, t in m; co, co_bound: coscrew (f in N; τ in N m).
   9 mul, 9 add, 6 abs. */
static inline void ksl_hctxf_certified(const ksl_SE3f_t *D, ksl_coscrewf_t *co,
    ksl_coscrewf_t *co_bound) {
  const float co_3a = KSL_MULF(D->m20, D->m13), co_3b = KSL_MULF(D->m10, D->m23),
      co_3 = co_3a - co_3b;
  const float co_4a = KSL_MULF(D->m00, D->m23), co_4b = KSL_MULF(D->m20, D->m03),
      co_4 = co_4a - co_4b;
  const float co_5a = KSL_MULF(D->m10, D->m03), co_5b = KSL_MULF(D->m00, D->m13),
      co_5 = co_5a - co_5b;
  const float co_3_size = fabsf(co_3a) + fabsf(co_3b), co_4_size = fabsf(co_4a) + fabsf(co_4b),
      co_5_size = fabsf(co_5a) + fabsf(co_5b);
  const float co_3_bound = KSL_MULF(1.192093e-07f, co_3_size + 1.9721523e-31f),
      co_4_bound = KSL_MULF(1.192093e-07f, co_4_size + 1.9721523e-31f),
      co_5_bound = KSL_MULF(1.192093e-07f, co_5_size + 1.9721523e-31f);
  const float D_m00 = D->m00;
  const float D_m10 = D->m10;
  const float D_m20 = D->m20;
  co->m0 = D_m00;
  co->m1 = D_m10;
  co->m2 = D_m20;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
  co_bound->m0 = 0.0f;
  co_bound->m1 = 0.0f;
  co_bound->m2 = 0.0f;
  co_bound->m3 = co_3_bound;
  co_bound->m4 = co_4_bound;
  co_bound->m5 = co_5_bound;
}

/* co = h_ty: column 1 of [Ad]*(D); |error of co| <= co_bound unless inf or NaN.
   D: displacement [R | t], R rotation, t in m; co, co_bound: coscrew (f in N; τ in N m).
   9 mul, 9 add, 6 abs. */
static inline void ksl_hctyf_certified(const ksl_SE3f_t *D, ksl_coscrewf_t *co,
    ksl_coscrewf_t *co_bound) {
  const float co_3a = KSL_MULF(D->m21, D->m13), co_3b = KSL_MULF(D->m11, D->m23),
      co_3 = co_3a - co_3b;
  const float co_4a = KSL_MULF(D->m01, D->m23), co_4b = KSL_MULF(D->m21, D->m03),
      co_4 = co_4a - co_4b;
  const float co_5a = KSL_MULF(D->m11, D->m03), co_5b = KSL_MULF(D->m01, D->m13),
      co_5 = co_5a - co_5b;
  const float co_3_size = fabsf(co_3a) + fabsf(co_3b), co_4_size = fabsf(co_4a) + fabsf(co_4b),
      co_5_size = fabsf(co_5a) + fabsf(co_5b);
  const float co_3_bound = KSL_MULF(1.192093e-07f, co_3_size + 1.9721523e-31f),
      co_4_bound = KSL_MULF(1.192093e-07f, co_4_size + 1.9721523e-31f),
      co_5_bound = KSL_MULF(1.192093e-07f, co_5_size + 1.9721523e-31f);
  const float D_m01 = D->m01;
  const float D_m11 = D->m11;
  const float D_m21 = D->m21;
  co->m0 = D_m01;
  co->m1 = D_m11;
  co->m2 = D_m21;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
  co_bound->m0 = 0.0f;
  co_bound->m1 = 0.0f;
  co_bound->m2 = 0.0f;
  co_bound->m3 = co_3_bound;
  co_bound->m4 = co_4_bound;
  co_bound->m5 = co_5_bound;
}

/* co = h_tz: column 2 of [Ad]*(D); |error of co| <= co_bound unless inf or NaN.
   D: displacement [R | t], R rotation, t in m; co, co_bound: coscrew (f in N; τ in N m).
   9 mul, 9 add, 6 abs. */
static inline void ksl_hctzf_certified(const ksl_SE3f_t *D, ksl_coscrewf_t *co,
    ksl_coscrewf_t *co_bound) {
  const float co_3a = KSL_MULF(D->m22, D->m13), co_3b = KSL_MULF(D->m12, D->m23),
      co_3 = co_3a - co_3b;
  const float co_4a = KSL_MULF(D->m02, D->m23), co_4b = KSL_MULF(D->m22, D->m03),
      co_4 = co_4a - co_4b;
  const float co_5a = KSL_MULF(D->m12, D->m03), co_5b = KSL_MULF(D->m02, D->m13),
      co_5 = co_5a - co_5b;
  const float co_3_size = fabsf(co_3a) + fabsf(co_3b), co_4_size = fabsf(co_4a) + fabsf(co_4b),
      co_5_size = fabsf(co_5a) + fabsf(co_5b);
  const float co_3_bound = KSL_MULF(1.192093e-07f, co_3_size + 1.9721523e-31f),
      co_4_bound = KSL_MULF(1.192093e-07f, co_4_size + 1.9721523e-31f),
      co_5_bound = KSL_MULF(1.192093e-07f, co_5_size + 1.9721523e-31f);
  const float D_m02 = D->m02;
  const float D_m12 = D->m12;
  const float D_m22 = D->m22;
  co->m0 = D_m02;
  co->m1 = D_m12;
  co->m2 = D_m22;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
  co_bound->m0 = 0.0f;
  co_bound->m1 = 0.0f;
  co_bound->m2 = 0.0f;
  co_bound->m3 = co_3_bound;
  co_bound->m4 = co_4_bound;
  co_bound->m5 = co_5_bound;
}

/* co = -h_tx: -column 0 of [Ad]*(D); |error of co| <= co_bound unless inf or NaN.
   D: displacement [R | t], R rotation, t in m; co, co_bound: coscrew (f in N; τ in N m).
   9 mul, 9 add, 3 neg, 6 abs. */
static inline void ksl_hctxinvf_certified(const ksl_SE3f_t *D, ksl_coscrewf_t *co,
    ksl_coscrewf_t *co_bound) {
  const float co_0 = -D->m00, co_1 = -D->m10, co_2 = -D->m20;
  const float co_3a = KSL_MULF(D->m10, D->m23), co_3b = KSL_MULF(D->m20, D->m13),
      co_3 = co_3a - co_3b;
  const float co_4a = KSL_MULF(D->m20, D->m03), co_4b = KSL_MULF(D->m00, D->m23),
      co_4 = co_4a - co_4b;
  const float co_5a = KSL_MULF(D->m00, D->m13), co_5b = KSL_MULF(D->m10, D->m03),
      co_5 = co_5a - co_5b;
  const float co_3_size = fabsf(co_3a) + fabsf(co_3b), co_4_size = fabsf(co_4a) + fabsf(co_4b),
      co_5_size = fabsf(co_5a) + fabsf(co_5b);
  const float co_3_bound = KSL_MULF(1.192093e-07f, co_3_size + 1.9721523e-31f),
      co_4_bound = KSL_MULF(1.192093e-07f, co_4_size + 1.9721523e-31f),
      co_5_bound = KSL_MULF(1.192093e-07f, co_5_size + 1.9721523e-31f);
  co->m0 = co_0;
  co->m1 = co_1;
  co->m2 = co_2;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
  co_bound->m0 = 0.0f;
  co_bound->m1 = 0.0f;
  co_bound->m2 = 0.0f;
  co_bound->m3 = co_3_bound;
  co_bound->m4 = co_4_bound;
  co_bound->m5 = co_5_bound;
}

/* co = -h_ty: -column 1 of [Ad]*(D); |error of co| <= co_bound unless inf or NaN.
   D: displacement [R | t], R rotation, t in m; co, co_bound: coscrew (f in N; τ in N m).
   9 mul, 9 add, 3 neg, 6 abs. */
static inline void ksl_hctyinvf_certified(const ksl_SE3f_t *D, ksl_coscrewf_t *co,
    ksl_coscrewf_t *co_bound) {
  const float co_0 = -D->m01, co_1 = -D->m11, co_2 = -D->m21;
  const float co_3a = KSL_MULF(D->m11, D->m23), co_3b = KSL_MULF(D->m21, D->m13),
      co_3 = co_3a - co_3b;
  const float co_4a = KSL_MULF(D->m21, D->m03), co_4b = KSL_MULF(D->m01, D->m23),
      co_4 = co_4a - co_4b;
  const float co_5a = KSL_MULF(D->m01, D->m13), co_5b = KSL_MULF(D->m11, D->m03),
      co_5 = co_5a - co_5b;
  const float co_3_size = fabsf(co_3a) + fabsf(co_3b), co_4_size = fabsf(co_4a) + fabsf(co_4b),
      co_5_size = fabsf(co_5a) + fabsf(co_5b);
  const float co_3_bound = KSL_MULF(1.192093e-07f, co_3_size + 1.9721523e-31f),
      co_4_bound = KSL_MULF(1.192093e-07f, co_4_size + 1.9721523e-31f),
      co_5_bound = KSL_MULF(1.192093e-07f, co_5_size + 1.9721523e-31f);
  co->m0 = co_0;
  co->m1 = co_1;
  co->m2 = co_2;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
  co_bound->m0 = 0.0f;
  co_bound->m1 = 0.0f;
  co_bound->m2 = 0.0f;
  co_bound->m3 = co_3_bound;
  co_bound->m4 = co_4_bound;
  co_bound->m5 = co_5_bound;
}

/* co = -h_tz: -column 2 of [Ad]*(D); |error of co| <= co_bound unless inf or NaN.
   D: displacement [R | t], R rotation, t in m; co, co_bound: coscrew (f in N; τ in N m).
   9 mul, 9 add, 3 neg, 6 abs. */
static inline void ksl_hctzinvf_certified(const ksl_SE3f_t *D, ksl_coscrewf_t *co,
    ksl_coscrewf_t *co_bound) {
  const float co_0 = -D->m02, co_1 = -D->m12, co_2 = -D->m22;
  const float co_3a = KSL_MULF(D->m12, D->m23), co_3b = KSL_MULF(D->m22, D->m13),
      co_3 = co_3a - co_3b;
  const float co_4a = KSL_MULF(D->m22, D->m03), co_4b = KSL_MULF(D->m02, D->m23),
      co_4 = co_4a - co_4b;
  const float co_5a = KSL_MULF(D->m02, D->m13), co_5b = KSL_MULF(D->m12, D->m03),
      co_5 = co_5a - co_5b;
  const float co_3_size = fabsf(co_3a) + fabsf(co_3b), co_4_size = fabsf(co_4a) + fabsf(co_4b),
      co_5_size = fabsf(co_5a) + fabsf(co_5b);
  const float co_3_bound = KSL_MULF(1.192093e-07f, co_3_size + 1.9721523e-31f),
      co_4_bound = KSL_MULF(1.192093e-07f, co_4_size + 1.9721523e-31f),
      co_5_bound = KSL_MULF(1.192093e-07f, co_5_size + 1.9721523e-31f);
  co->m0 = co_0;
  co->m1 = co_1;
  co->m2 = co_2;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
  co_bound->m0 = 0.0f;
  co_bound->m1 = 0.0f;
  co_bound->m2 = 0.0f;
  co_bound->m3 = co_3_bound;
  co_bound->m4 = co_4_bound;
  co_bound->m5 = co_5_bound;
}

/* M = [Ad]*(D); |error of M| <= M_bound unless inf or NaN.
   D: displacement [R | t], R rotation, t in m; M, M_bound: 6×6 operator.
   27 mul, 27 add, 18 abs. */
static inline void ksl_CoAdf_certified(const ksl_SE3f_t *D, ksl_mat6x6f_t *M,
    ksl_mat6x6f_t *M_bound) {
  const float M_30a = KSL_MULF(D->m20, D->m13), M_30b = KSL_MULF(D->m10, D->m23),
      M_30 = M_30a - M_30b;
  const float M_31a = KSL_MULF(D->m21, D->m13), M_31b = KSL_MULF(D->m11, D->m23),
      M_31 = M_31a - M_31b;
  const float M_32a = KSL_MULF(D->m22, D->m13), M_32b = KSL_MULF(D->m12, D->m23),
      M_32 = M_32a - M_32b;
  const float M_40a = KSL_MULF(D->m00, D->m23), M_40b = KSL_MULF(D->m20, D->m03),
      M_40 = M_40a - M_40b;
  const float M_41a = KSL_MULF(D->m01, D->m23), M_41b = KSL_MULF(D->m21, D->m03),
      M_41 = M_41a - M_41b;
  const float M_42a = KSL_MULF(D->m02, D->m23), M_42b = KSL_MULF(D->m22, D->m03),
      M_42 = M_42a - M_42b;
  const float M_50a = KSL_MULF(D->m10, D->m03), M_50b = KSL_MULF(D->m00, D->m13),
      M_50 = M_50a - M_50b;
  const float M_51a = KSL_MULF(D->m11, D->m03), M_51b = KSL_MULF(D->m01, D->m13),
      M_51 = M_51a - M_51b;
  const float M_52a = KSL_MULF(D->m12, D->m03), M_52b = KSL_MULF(D->m02, D->m13),
      M_52 = M_52a - M_52b;
  const float M_30_size = fabsf(M_30a) + fabsf(M_30b), M_31_size = fabsf(M_31a) + fabsf(M_31b),
      M_32_size = fabsf(M_32a) + fabsf(M_32b), M_40_size = fabsf(M_40a) + fabsf(M_40b),
      M_41_size = fabsf(M_41a) + fabsf(M_41b), M_42_size = fabsf(M_42a) + fabsf(M_42b),
      M_50_size = fabsf(M_50a) + fabsf(M_50b), M_51_size = fabsf(M_51a) + fabsf(M_51b),
      M_52_size = fabsf(M_52a) + fabsf(M_52b);
  const float M_30_bound = KSL_MULF(1.192093e-07f, M_30_size + 1.9721523e-31f),
      M_31_bound = KSL_MULF(1.192093e-07f, M_31_size + 1.9721523e-31f),
      M_32_bound = KSL_MULF(1.192093e-07f, M_32_size + 1.9721523e-31f),
      M_40_bound = KSL_MULF(1.192093e-07f, M_40_size + 1.9721523e-31f),
      M_41_bound = KSL_MULF(1.192093e-07f, M_41_size + 1.9721523e-31f),
      M_42_bound = KSL_MULF(1.192093e-07f, M_42_size + 1.9721523e-31f),
      M_50_bound = KSL_MULF(1.192093e-07f, M_50_size + 1.9721523e-31f),
      M_51_bound = KSL_MULF(1.192093e-07f, M_51_size + 1.9721523e-31f),
      M_52_bound = KSL_MULF(1.192093e-07f, M_52_size + 1.9721523e-31f);
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
  M->at[3][0] = 0.0f;
  M->at[4][0] = 0.0f;
  M->at[5][0] = 0.0f;
  M->at[0][1] = D_m10;
  M->at[1][1] = D_m11;
  M->at[2][1] = D_m12;
  M->at[3][1] = 0.0f;
  M->at[4][1] = 0.0f;
  M->at[5][1] = 0.0f;
  M->at[0][2] = D_m20;
  M->at[1][2] = D_m21;
  M->at[2][2] = D_m22;
  M->at[3][2] = 0.0f;
  M->at[4][2] = 0.0f;
  M->at[5][2] = 0.0f;
  M->at[0][3] = M_30;
  M->at[1][3] = M_31;
  M->at[2][3] = M_32;
  M->at[3][3] = D_m00;
  M->at[4][3] = D_m01;
  M->at[5][3] = D_m02;
  M->at[0][4] = M_40;
  M->at[1][4] = M_41;
  M->at[2][4] = M_42;
  M->at[3][4] = D_m10;
  M->at[4][4] = D_m11;
  M->at[5][4] = D_m12;
  M->at[0][5] = M_50;
  M->at[1][5] = M_51;
  M->at[2][5] = M_52;
  M->at[3][5] = D_m20;
  M->at[4][5] = D_m21;
  M->at[5][5] = D_m22;
  M_bound->at[0][0] = 0.0f;
  M_bound->at[1][0] = 0.0f;
  M_bound->at[2][0] = 0.0f;
  M_bound->at[3][0] = 0.0f;
  M_bound->at[4][0] = 0.0f;
  M_bound->at[5][0] = 0.0f;
  M_bound->at[0][1] = 0.0f;
  M_bound->at[1][1] = 0.0f;
  M_bound->at[2][1] = 0.0f;
  M_bound->at[3][1] = 0.0f;
  M_bound->at[4][1] = 0.0f;
  M_bound->at[5][1] = 0.0f;
  M_bound->at[0][2] = 0.0f;
  M_bound->at[1][2] = 0.0f;
  M_bound->at[2][2] = 0.0f;
  M_bound->at[3][2] = 0.0f;
  M_bound->at[4][2] = 0.0f;
  M_bound->at[5][2] = 0.0f;
  M_bound->at[0][3] = M_30_bound;
  M_bound->at[1][3] = M_31_bound;
  M_bound->at[2][3] = M_32_bound;
  M_bound->at[3][3] = 0.0f;
  M_bound->at[4][3] = 0.0f;
  M_bound->at[5][3] = 0.0f;
  M_bound->at[0][4] = M_40_bound;
  M_bound->at[1][4] = M_41_bound;
  M_bound->at[2][4] = M_42_bound;
  M_bound->at[3][4] = 0.0f;
  M_bound->at[4][4] = 0.0f;
  M_bound->at[5][4] = 0.0f;
  M_bound->at[0][5] = M_50_bound;
  M_bound->at[1][5] = M_51_bound;
  M_bound->at[2][5] = M_52_bound;
  M_bound->at[3][5] = 0.0f;
  M_bound->at[4][5] = 0.0f;
  M_bound->at[5][5] = 0.0f;
}

/* power = W ⊙ $ = f·v + τ·ω, W = c = (f; τ), $ = x = (ω; v); |error of power| <= power_bound
     unless inf or NaN.
   c: coscrew (f in N; τ in N m); x: six components with the angular part on top; power_bound:
     number.
   7 mul, 11 add, 6 abs. */
static inline float ksl_reciprocal_productf_certified(const ksl_coscrewf_t *c, const float x[6],
    float *power_bound) {
  const float power_a = KSL_MULF(c->m0, x[3]), power_b = KSL_MULF(c->m1, x[4]),
      power_d = KSL_MULF(c->m2, x[5]), power_f = KSL_MULF(c->m3, x[0]),
      power_g = KSL_MULF(c->m4, x[1]), power_i = KSL_MULF(c->m5, x[2]),
      power = power_a + power_b + power_d + (power_f + power_g + power_i);
  const float power_size = fabsf(power_a) + fabsf(power_b) + fabsf(power_d)
          + (fabsf(power_f) + fabsf(power_g) + fabsf(power_i));
  const float power_bound_ = KSL_MULF(2.3841864e-07f, power_size + 1.9721523e-31f);
  *power_bound = power_bound_;
  return power;
}

/* co = [ad]*(s) c = (ω×f ; v×f + ω×τ); |error of co| <= co_bound unless inf or NaN.
   s: screw (v in m/s; ω in rad/s); c, co, co_bound: coscrew (f in N; τ in N m).
   24 mul, 30 add, 18 abs. */
static inline void ksl_cross_scf_certified(const ksl_screwf_t *s, const ksl_coscrewf_t *c,
    ksl_coscrewf_t *co, ksl_coscrewf_t *co_bound) {
  const float co_0a = KSL_MULF(s->m4, c->m2), co_0b = KSL_MULF(s->m5, c->m1), co_0 = co_0a - co_0b;
  const float co_1a = KSL_MULF(s->m5, c->m0), co_1b = KSL_MULF(s->m3, c->m2), co_1 = co_1a - co_1b;
  const float co_2a = KSL_MULF(s->m3, c->m1), co_2b = KSL_MULF(s->m4, c->m0), co_2 = co_2a - co_2b;
  const float co_3a = KSL_MULF(s->m1, c->m2), co_3b = KSL_MULF(s->m2, c->m1),
      co_3d = KSL_MULF(s->m4, c->m5), co_3e = KSL_MULF(s->m5, c->m4),
      co_3 = co_3a - co_3b + (co_3d - co_3e);
  const float co_4a = KSL_MULF(s->m2, c->m0), co_4b = KSL_MULF(s->m0, c->m2),
      co_4d = KSL_MULF(s->m5, c->m3), co_4e = KSL_MULF(s->m3, c->m5),
      co_4 = co_4a - co_4b + (co_4d - co_4e);
  const float co_5a = KSL_MULF(s->m0, c->m1), co_5b = KSL_MULF(s->m1, c->m0),
      co_5d = KSL_MULF(s->m3, c->m4), co_5e = KSL_MULF(s->m4, c->m3),
      co_5 = co_5a - co_5b + (co_5d - co_5e);
  const float co_0_size = fabsf(co_0a) + fabsf(co_0b), co_1_size = fabsf(co_1a) + fabsf(co_1b),
      co_2_size = fabsf(co_2a) + fabsf(co_2b),
      co_3_size = fabsf(co_3a) + fabsf(co_3b) + (fabsf(co_3d) + fabsf(co_3e)),
      co_4_size = fabsf(co_4a) + fabsf(co_4b) + (fabsf(co_4d) + fabsf(co_4e)),
      co_5_size = fabsf(co_5a) + fabsf(co_5b) + (fabsf(co_5d) + fabsf(co_5e));
  const float co_0_bound = KSL_MULF(1.192093e-07f, co_0_size + 1.9721523e-31f),
      co_1_bound = KSL_MULF(1.192093e-07f, co_1_size + 1.9721523e-31f),
      co_2_bound = KSL_MULF(1.192093e-07f, co_2_size + 1.9721523e-31f),
      co_3_bound = KSL_MULF(1.7881396e-07f, co_3_size + 1.9721523e-31f),
      co_4_bound = KSL_MULF(1.7881396e-07f, co_4_size + 1.9721523e-31f),
      co_5_bound = KSL_MULF(1.7881396e-07f, co_5_size + 1.9721523e-31f);
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

/* co = (0 ; ω×τ); |error of co| <= co_bound unless inf or NaN.
   s: screw (v in m/s; ω in rad/s); c, co, co_bound: coscrew (f in N; τ in N m).
   9 mul, 9 add, 6 abs. */
static inline void ksl_cross_scaf_certified(const ksl_screwf_t *s, const ksl_coscrewf_t *c,
    ksl_coscrewf_t *co, ksl_coscrewf_t *co_bound) {
  const float co_3a = KSL_MULF(s->m4, c->m5), co_3b = KSL_MULF(s->m5, c->m4), co_3 = co_3a - co_3b;
  const float co_4a = KSL_MULF(s->m5, c->m3), co_4b = KSL_MULF(s->m3, c->m5), co_4 = co_4a - co_4b;
  const float co_5a = KSL_MULF(s->m3, c->m4), co_5b = KSL_MULF(s->m4, c->m3), co_5 = co_5a - co_5b;
  const float co_3_size = fabsf(co_3a) + fabsf(co_3b), co_4_size = fabsf(co_4a) + fabsf(co_4b),
      co_5_size = fabsf(co_5a) + fabsf(co_5b);
  const float co_3_bound = KSL_MULF(1.192093e-07f, co_3_size + 1.9721523e-31f),
      co_4_bound = KSL_MULF(1.192093e-07f, co_4_size + 1.9721523e-31f),
      co_5_bound = KSL_MULF(1.192093e-07f, co_5_size + 1.9721523e-31f);
  co->m0 = 0.0f;
  co->m1 = 0.0f;
  co->m2 = 0.0f;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
  co_bound->m0 = 0.0f;
  co_bound->m1 = 0.0f;
  co_bound->m2 = 0.0f;
  co_bound->m3 = co_3_bound;
  co_bound->m4 = co_4_bound;
  co_bound->m5 = co_5_bound;
}

/* co = H̄* c = [Ad]*(D) P c; P clears component 0 of c, given in the frame of a tx joint at D;
     |error of co| <= co_bound unless inf or NaN.
   D: displacement [R | t], R rotation, t in m; c, co, co_bound: coscrew (f in N; τ in N m).
   33 mul, 36 add, 18 abs. */
static inline void ksl_constraint_ctxf_certified(const ksl_SE3f_t *D, const ksl_coscrewf_t *c,
    ksl_coscrewf_t *co, ksl_coscrewf_t *co_bound) {
  const float w_0a = KSL_MULF(D->m01, c->m1), w_0b = KSL_MULF(D->m02, c->m2), w_0 = w_0a + w_0b;
  const float w_1a = KSL_MULF(D->m11, c->m1), w_1b = KSL_MULF(D->m12, c->m2), w_1 = w_1a + w_1b;
  const float w_2a = KSL_MULF(D->m21, c->m1), w_2b = KSL_MULF(D->m22, c->m2), w_2 = w_2a + w_2b;
  const float w_3a = KSL_MULF(D->m00, c->m3), w_3b = KSL_MULF(D->m01, c->m4),
      w_3d = KSL_MULF(D->m02, c->m5), w_3 = w_3a + w_3b + w_3d;
  const float w_4a = KSL_MULF(D->m10, c->m3), w_4b = KSL_MULF(D->m11, c->m4),
      w_4d = KSL_MULF(D->m12, c->m5), w_4 = w_4a + w_4b + w_4d;
  const float w_5a = KSL_MULF(D->m20, c->m3), w_5b = KSL_MULF(D->m21, c->m4),
      w_5d = KSL_MULF(D->m22, c->m5), w_5 = w_5a + w_5b + w_5d;
  const float co_3 = KSL_MULF(D->m13, w_2) - KSL_MULF(D->m23, w_1) + w_3;
  const float co_4 = KSL_MULF(D->m23, w_0) - KSL_MULF(D->m03, w_2) + w_4;
  const float co_5 = KSL_MULF(D->m03, w_1) - KSL_MULF(D->m13, w_0) + w_5;
  const float w_0_size = fabsf(w_0a) + fabsf(w_0b), w_1_size = fabsf(w_1a) + fabsf(w_1b),
      w_2_size = fabsf(w_2a) + fabsf(w_2b), w_3_size = fabsf(w_3a) + fabsf(w_3b) + fabsf(w_3d),
      w_4_size = fabsf(w_4a) + fabsf(w_4b) + fabsf(w_4d),
      w_5_size = fabsf(w_5a) + fabsf(w_5b) + fabsf(w_5d);
  const float w_2_padded = w_2_size + 1.9721523e-31f;
  const float D_13_abs = fabsf(D->m13);
  const float w_1_padded = w_1_size + 1.9721523e-31f;
  const float D_23_abs = fabsf(D->m23),
      co_3_size = KSL_MULF(D_13_abs, w_2_padded) + KSL_MULF(D_23_abs, w_1_padded) + w_3_size;
  const float w_0_padded = w_0_size + 1.9721523e-31f;
  const float D_03_abs = fabsf(D->m03),
      co_4_size = KSL_MULF(D_23_abs, w_0_padded) + KSL_MULF(D_03_abs, w_2_padded) + w_4_size;
  const float co_5_size = KSL_MULF(D_03_abs, w_1_padded) + KSL_MULF(D_13_abs, w_0_padded)
          + w_5_size;
  const float w_0_bound = KSL_MULF(1.192093e-07f, w_0_padded),
      w_1_bound = KSL_MULF(1.192093e-07f, w_1_padded),
      w_2_bound = KSL_MULF(1.192093e-07f, w_2_padded);
  const float co_3_bound = KSL_MULF(2.9802328e-07f, co_3_size + 1.9721523e-31f),
      co_4_bound = KSL_MULF(2.9802328e-07f, co_4_size + 1.9721523e-31f),
      co_5_bound = KSL_MULF(2.9802328e-07f, co_5_size + 1.9721523e-31f);
  co->m0 = w_0;
  co->m1 = w_1;
  co->m2 = w_2;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
  co_bound->m0 = w_0_bound;
  co_bound->m1 = w_1_bound;
  co_bound->m2 = w_2_bound;
  co_bound->m3 = co_3_bound;
  co_bound->m4 = co_4_bound;
  co_bound->m5 = co_5_bound;
}

/* co = H̄* c = [Ad]*(D) P c; P clears component 1 of c, given in the frame of a ty joint at D;
     |error of co| <= co_bound unless inf or NaN.
   D: displacement [R | t], R rotation, t in m; c, co, co_bound: coscrew (f in N; τ in N m).
   33 mul, 36 add, 18 abs. */
static inline void ksl_constraint_ctyf_certified(const ksl_SE3f_t *D, const ksl_coscrewf_t *c,
    ksl_coscrewf_t *co, ksl_coscrewf_t *co_bound) {
  const float w_0a = KSL_MULF(D->m00, c->m0), w_0b = KSL_MULF(D->m02, c->m2), w_0 = w_0a + w_0b;
  const float w_1a = KSL_MULF(D->m10, c->m0), w_1b = KSL_MULF(D->m12, c->m2), w_1 = w_1a + w_1b;
  const float w_2a = KSL_MULF(D->m20, c->m0), w_2b = KSL_MULF(D->m22, c->m2), w_2 = w_2a + w_2b;
  const float w_3a = KSL_MULF(D->m00, c->m3), w_3b = KSL_MULF(D->m01, c->m4),
      w_3d = KSL_MULF(D->m02, c->m5), w_3 = w_3a + w_3b + w_3d;
  const float w_4a = KSL_MULF(D->m10, c->m3), w_4b = KSL_MULF(D->m11, c->m4),
      w_4d = KSL_MULF(D->m12, c->m5), w_4 = w_4a + w_4b + w_4d;
  const float w_5a = KSL_MULF(D->m20, c->m3), w_5b = KSL_MULF(D->m21, c->m4),
      w_5d = KSL_MULF(D->m22, c->m5), w_5 = w_5a + w_5b + w_5d;
  const float co_3 = KSL_MULF(D->m13, w_2) - KSL_MULF(D->m23, w_1) + w_3;
  const float co_4 = KSL_MULF(D->m23, w_0) - KSL_MULF(D->m03, w_2) + w_4;
  const float co_5 = KSL_MULF(D->m03, w_1) - KSL_MULF(D->m13, w_0) + w_5;
  const float w_0_size = fabsf(w_0a) + fabsf(w_0b), w_1_size = fabsf(w_1a) + fabsf(w_1b),
      w_2_size = fabsf(w_2a) + fabsf(w_2b), w_3_size = fabsf(w_3a) + fabsf(w_3b) + fabsf(w_3d),
      w_4_size = fabsf(w_4a) + fabsf(w_4b) + fabsf(w_4d),
      w_5_size = fabsf(w_5a) + fabsf(w_5b) + fabsf(w_5d);
  const float w_2_padded = w_2_size + 1.9721523e-31f;
  const float D_13_abs = fabsf(D->m13);
  const float w_1_padded = w_1_size + 1.9721523e-31f;
  const float D_23_abs = fabsf(D->m23),
      co_3_size = KSL_MULF(D_13_abs, w_2_padded) + KSL_MULF(D_23_abs, w_1_padded) + w_3_size;
  const float w_0_padded = w_0_size + 1.9721523e-31f;
  const float D_03_abs = fabsf(D->m03),
      co_4_size = KSL_MULF(D_23_abs, w_0_padded) + KSL_MULF(D_03_abs, w_2_padded) + w_4_size;
  const float co_5_size = KSL_MULF(D_03_abs, w_1_padded) + KSL_MULF(D_13_abs, w_0_padded)
          + w_5_size;
  const float w_0_bound = KSL_MULF(1.192093e-07f, w_0_padded),
      w_1_bound = KSL_MULF(1.192093e-07f, w_1_padded),
      w_2_bound = KSL_MULF(1.192093e-07f, w_2_padded);
  const float co_3_bound = KSL_MULF(2.9802328e-07f, co_3_size + 1.9721523e-31f),
      co_4_bound = KSL_MULF(2.9802328e-07f, co_4_size + 1.9721523e-31f),
      co_5_bound = KSL_MULF(2.9802328e-07f, co_5_size + 1.9721523e-31f);
  co->m0 = w_0;
  co->m1 = w_1;
  co->m2 = w_2;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
  co_bound->m0 = w_0_bound;
  co_bound->m1 = w_1_bound;
  co_bound->m2 = w_2_bound;
  co_bound->m3 = co_3_bound;
  co_bound->m4 = co_4_bound;
  co_bound->m5 = co_5_bound;
}

/* co = H̄* c = [Ad]*(D) P c; P clears component 2 of c, given in the frame of a tz joint at D;
     |error of co| <= co_bound unless inf or NaN.
   D: displacement [R | t], R rotation, t in m; c, co, co_bound: coscrew (f in N; τ in N m).
   33 mul, 36 add, 18 abs. */
static inline void ksl_constraint_ctzf_certified(const ksl_SE3f_t *D, const ksl_coscrewf_t *c,
    ksl_coscrewf_t *co, ksl_coscrewf_t *co_bound) {
  const float w_0a = KSL_MULF(D->m00, c->m0), w_0b = KSL_MULF(D->m01, c->m1), w_0 = w_0a + w_0b;
  const float w_1a = KSL_MULF(D->m10, c->m0), w_1b = KSL_MULF(D->m11, c->m1), w_1 = w_1a + w_1b;
  const float w_2a = KSL_MULF(D->m20, c->m0), w_2b = KSL_MULF(D->m21, c->m1), w_2 = w_2a + w_2b;
  const float w_3a = KSL_MULF(D->m00, c->m3), w_3b = KSL_MULF(D->m01, c->m4),
      w_3d = KSL_MULF(D->m02, c->m5), w_3 = w_3a + w_3b + w_3d;
  const float w_4a = KSL_MULF(D->m10, c->m3), w_4b = KSL_MULF(D->m11, c->m4),
      w_4d = KSL_MULF(D->m12, c->m5), w_4 = w_4a + w_4b + w_4d;
  const float w_5a = KSL_MULF(D->m20, c->m3), w_5b = KSL_MULF(D->m21, c->m4),
      w_5d = KSL_MULF(D->m22, c->m5), w_5 = w_5a + w_5b + w_5d;
  const float co_3 = KSL_MULF(D->m13, w_2) - KSL_MULF(D->m23, w_1) + w_3;
  const float co_4 = KSL_MULF(D->m23, w_0) - KSL_MULF(D->m03, w_2) + w_4;
  const float co_5 = KSL_MULF(D->m03, w_1) - KSL_MULF(D->m13, w_0) + w_5;
  const float w_0_size = fabsf(w_0a) + fabsf(w_0b), w_1_size = fabsf(w_1a) + fabsf(w_1b),
      w_2_size = fabsf(w_2a) + fabsf(w_2b), w_3_size = fabsf(w_3a) + fabsf(w_3b) + fabsf(w_3d),
      w_4_size = fabsf(w_4a) + fabsf(w_4b) + fabsf(w_4d),
      w_5_size = fabsf(w_5a) + fabsf(w_5b) + fabsf(w_5d);
  const float w_2_padded = w_2_size + 1.9721523e-31f;
  const float D_13_abs = fabsf(D->m13);
  const float w_1_padded = w_1_size + 1.9721523e-31f;
  const float D_23_abs = fabsf(D->m23),
      co_3_size = KSL_MULF(D_13_abs, w_2_padded) + KSL_MULF(D_23_abs, w_1_padded) + w_3_size;
  const float w_0_padded = w_0_size + 1.9721523e-31f;
  const float D_03_abs = fabsf(D->m03),
      co_4_size = KSL_MULF(D_23_abs, w_0_padded) + KSL_MULF(D_03_abs, w_2_padded) + w_4_size;
  const float co_5_size = KSL_MULF(D_03_abs, w_1_padded) + KSL_MULF(D_13_abs, w_0_padded)
          + w_5_size;
  const float w_0_bound = KSL_MULF(1.192093e-07f, w_0_padded),
      w_1_bound = KSL_MULF(1.192093e-07f, w_1_padded),
      w_2_bound = KSL_MULF(1.192093e-07f, w_2_padded);
  const float co_3_bound = KSL_MULF(2.9802328e-07f, co_3_size + 1.9721523e-31f),
      co_4_bound = KSL_MULF(2.9802328e-07f, co_4_size + 1.9721523e-31f),
      co_5_bound = KSL_MULF(2.9802328e-07f, co_5_size + 1.9721523e-31f);
  co->m0 = w_0;
  co->m1 = w_1;
  co->m2 = w_2;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
  co_bound->m0 = w_0_bound;
  co_bound->m1 = w_1_bound;
  co_bound->m2 = w_2_bound;
  co_bound->m3 = co_3_bound;
  co_bound->m4 = co_4_bound;
  co_bound->m5 = co_5_bound;
}

/* co = H̄* c = [Ad]*(D) P c; P clears component 3 of c, given in the frame of a rx joint at D;
     |error of co| <= co_bound unless inf or NaN.
   D: displacement [R | t], R rotation, t in m; c, co, co_bound: coscrew (f in N; τ in N m).
   33 mul, 36 add, 18 abs. */
static inline void ksl_constraint_crxf_certified(const ksl_SE3f_t *D, const ksl_coscrewf_t *c,
    ksl_coscrewf_t *co, ksl_coscrewf_t *co_bound) {
  const float w_0a = KSL_MULF(D->m00, c->m0), w_0b = KSL_MULF(D->m01, c->m1),
      w_0d = KSL_MULF(D->m02, c->m2), w_0 = w_0a + w_0b + w_0d;
  const float w_1a = KSL_MULF(D->m10, c->m0), w_1b = KSL_MULF(D->m11, c->m1),
      w_1d = KSL_MULF(D->m12, c->m2), w_1 = w_1a + w_1b + w_1d;
  const float w_2a = KSL_MULF(D->m20, c->m0), w_2b = KSL_MULF(D->m21, c->m1),
      w_2d = KSL_MULF(D->m22, c->m2), w_2 = w_2a + w_2b + w_2d;
  const float w_3a = KSL_MULF(D->m01, c->m4), w_3b = KSL_MULF(D->m02, c->m5), w_3 = w_3a + w_3b;
  const float w_4a = KSL_MULF(D->m11, c->m4), w_4b = KSL_MULF(D->m12, c->m5), w_4 = w_4a + w_4b;
  const float w_5a = KSL_MULF(D->m21, c->m4), w_5b = KSL_MULF(D->m22, c->m5), w_5 = w_5a + w_5b;
  const float co_3 = KSL_MULF(D->m13, w_2) - KSL_MULF(D->m23, w_1) + w_3;
  const float co_4 = KSL_MULF(D->m23, w_0) - KSL_MULF(D->m03, w_2) + w_4;
  const float co_5 = KSL_MULF(D->m03, w_1) - KSL_MULF(D->m13, w_0) + w_5;
  const float w_0_size = fabsf(w_0a) + fabsf(w_0b) + fabsf(w_0d),
      w_1_size = fabsf(w_1a) + fabsf(w_1b) + fabsf(w_1d),
      w_2_size = fabsf(w_2a) + fabsf(w_2b) + fabsf(w_2d), w_3_size = fabsf(w_3a) + fabsf(w_3b),
      w_4_size = fabsf(w_4a) + fabsf(w_4b), w_5_size = fabsf(w_5a) + fabsf(w_5b);
  const float w_2_padded = w_2_size + 1.9721523e-31f;
  const float D_13_abs = fabsf(D->m13);
  const float w_1_padded = w_1_size + 1.9721523e-31f;
  const float D_23_abs = fabsf(D->m23),
      co_3_size = KSL_MULF(D_13_abs, w_2_padded) + KSL_MULF(D_23_abs, w_1_padded) + w_3_size;
  const float w_0_padded = w_0_size + 1.9721523e-31f;
  const float D_03_abs = fabsf(D->m03),
      co_4_size = KSL_MULF(D_23_abs, w_0_padded) + KSL_MULF(D_03_abs, w_2_padded) + w_4_size;
  const float co_5_size = KSL_MULF(D_03_abs, w_1_padded) + KSL_MULF(D_13_abs, w_0_padded)
          + w_5_size;
  const float w_0_bound = KSL_MULF(1.7881396e-07f, w_0_padded),
      w_1_bound = KSL_MULF(1.7881396e-07f, w_1_padded),
      w_2_bound = KSL_MULF(1.7881396e-07f, w_2_padded);
  const float co_3_bound = KSL_MULF(3.5762795e-07f, co_3_size + 1.9721523e-31f),
      co_4_bound = KSL_MULF(3.5762795e-07f, co_4_size + 1.9721523e-31f),
      co_5_bound = KSL_MULF(3.5762795e-07f, co_5_size + 1.9721523e-31f);
  co->m0 = w_0;
  co->m1 = w_1;
  co->m2 = w_2;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
  co_bound->m0 = w_0_bound;
  co_bound->m1 = w_1_bound;
  co_bound->m2 = w_2_bound;
  co_bound->m3 = co_3_bound;
  co_bound->m4 = co_4_bound;
  co_bound->m5 = co_5_bound;
}

/* co = H̄* c = [Ad]*(D) P c; P clears component 4 of c, given in the frame of a ry joint at D;
     |error of co| <= co_bound unless inf or NaN.
   D: displacement [R | t], R rotation, t in m; c, co, co_bound: coscrew (f in N; τ in N m).
   33 mul, 36 add, 18 abs. */
static inline void ksl_constraint_cryf_certified(const ksl_SE3f_t *D, const ksl_coscrewf_t *c,
    ksl_coscrewf_t *co, ksl_coscrewf_t *co_bound) {
  const float w_0a = KSL_MULF(D->m00, c->m0), w_0b = KSL_MULF(D->m01, c->m1),
      w_0d = KSL_MULF(D->m02, c->m2), w_0 = w_0a + w_0b + w_0d;
  const float w_1a = KSL_MULF(D->m10, c->m0), w_1b = KSL_MULF(D->m11, c->m1),
      w_1d = KSL_MULF(D->m12, c->m2), w_1 = w_1a + w_1b + w_1d;
  const float w_2a = KSL_MULF(D->m20, c->m0), w_2b = KSL_MULF(D->m21, c->m1),
      w_2d = KSL_MULF(D->m22, c->m2), w_2 = w_2a + w_2b + w_2d;
  const float w_3a = KSL_MULF(D->m00, c->m3), w_3b = KSL_MULF(D->m02, c->m5), w_3 = w_3a + w_3b;
  const float w_4a = KSL_MULF(D->m10, c->m3), w_4b = KSL_MULF(D->m12, c->m5), w_4 = w_4a + w_4b;
  const float w_5a = KSL_MULF(D->m20, c->m3), w_5b = KSL_MULF(D->m22, c->m5), w_5 = w_5a + w_5b;
  const float co_3 = KSL_MULF(D->m13, w_2) - KSL_MULF(D->m23, w_1) + w_3;
  const float co_4 = KSL_MULF(D->m23, w_0) - KSL_MULF(D->m03, w_2) + w_4;
  const float co_5 = KSL_MULF(D->m03, w_1) - KSL_MULF(D->m13, w_0) + w_5;
  const float w_0_size = fabsf(w_0a) + fabsf(w_0b) + fabsf(w_0d),
      w_1_size = fabsf(w_1a) + fabsf(w_1b) + fabsf(w_1d),
      w_2_size = fabsf(w_2a) + fabsf(w_2b) + fabsf(w_2d), w_3_size = fabsf(w_3a) + fabsf(w_3b),
      w_4_size = fabsf(w_4a) + fabsf(w_4b), w_5_size = fabsf(w_5a) + fabsf(w_5b);
  const float w_2_padded = w_2_size + 1.9721523e-31f;
  const float D_13_abs = fabsf(D->m13);
  const float w_1_padded = w_1_size + 1.9721523e-31f;
  const float D_23_abs = fabsf(D->m23),
      co_3_size = KSL_MULF(D_13_abs, w_2_padded) + KSL_MULF(D_23_abs, w_1_padded) + w_3_size;
  const float w_0_padded = w_0_size + 1.9721523e-31f;
  const float D_03_abs = fabsf(D->m03),
      co_4_size = KSL_MULF(D_23_abs, w_0_padded) + KSL_MULF(D_03_abs, w_2_padded) + w_4_size;
  const float co_5_size = KSL_MULF(D_03_abs, w_1_padded) + KSL_MULF(D_13_abs, w_0_padded)
          + w_5_size;
  const float w_0_bound = KSL_MULF(1.7881396e-07f, w_0_padded),
      w_1_bound = KSL_MULF(1.7881396e-07f, w_1_padded),
      w_2_bound = KSL_MULF(1.7881396e-07f, w_2_padded);
  const float co_3_bound = KSL_MULF(3.5762795e-07f, co_3_size + 1.9721523e-31f),
      co_4_bound = KSL_MULF(3.5762795e-07f, co_4_size + 1.9721523e-31f),
      co_5_bound = KSL_MULF(3.5762795e-07f, co_5_size + 1.9721523e-31f);
  co->m0 = w_0;
  co->m1 = w_1;
  co->m2 = w_2;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
  co_bound->m0 = w_0_bound;
  co_bound->m1 = w_1_bound;
  co_bound->m2 = w_2_bound;
  co_bound->m3 = co_3_bound;
  co_bound->m4 = co_4_bound;
  co_bound->m5 = co_5_bound;
}

/* co = H̄* c = [Ad]*(D) P c; P clears component 5 of c, given in the frame of a rz joint at D;
     |error of co| <= co_bound unless inf or NaN.
   D: displacement [R | t], R rotation, t in m; c, co, co_bound: coscrew (f in N; τ in N m).
   33 mul, 36 add, 18 abs. */
static inline void ksl_constraint_crzf_certified(const ksl_SE3f_t *D, const ksl_coscrewf_t *c,
    ksl_coscrewf_t *co, ksl_coscrewf_t *co_bound) {
  const float w_0a = KSL_MULF(D->m00, c->m0), w_0b = KSL_MULF(D->m01, c->m1),
      w_0d = KSL_MULF(D->m02, c->m2), w_0 = w_0a + w_0b + w_0d;
  const float w_1a = KSL_MULF(D->m10, c->m0), w_1b = KSL_MULF(D->m11, c->m1),
      w_1d = KSL_MULF(D->m12, c->m2), w_1 = w_1a + w_1b + w_1d;
  const float w_2a = KSL_MULF(D->m20, c->m0), w_2b = KSL_MULF(D->m21, c->m1),
      w_2d = KSL_MULF(D->m22, c->m2), w_2 = w_2a + w_2b + w_2d;
  const float w_3a = KSL_MULF(D->m00, c->m3), w_3b = KSL_MULF(D->m01, c->m4), w_3 = w_3a + w_3b;
  const float w_4a = KSL_MULF(D->m10, c->m3), w_4b = KSL_MULF(D->m11, c->m4), w_4 = w_4a + w_4b;
  const float w_5a = KSL_MULF(D->m20, c->m3), w_5b = KSL_MULF(D->m21, c->m4), w_5 = w_5a + w_5b;
  const float co_3 = KSL_MULF(D->m13, w_2) - KSL_MULF(D->m23, w_1) + w_3;
  const float co_4 = KSL_MULF(D->m23, w_0) - KSL_MULF(D->m03, w_2) + w_4;
  const float co_5 = KSL_MULF(D->m03, w_1) - KSL_MULF(D->m13, w_0) + w_5;
  const float w_0_size = fabsf(w_0a) + fabsf(w_0b) + fabsf(w_0d),
      w_1_size = fabsf(w_1a) + fabsf(w_1b) + fabsf(w_1d),
      w_2_size = fabsf(w_2a) + fabsf(w_2b) + fabsf(w_2d), w_3_size = fabsf(w_3a) + fabsf(w_3b),
      w_4_size = fabsf(w_4a) + fabsf(w_4b), w_5_size = fabsf(w_5a) + fabsf(w_5b);
  const float w_2_padded = w_2_size + 1.9721523e-31f;
  const float D_13_abs = fabsf(D->m13);
  const float w_1_padded = w_1_size + 1.9721523e-31f;
  const float D_23_abs = fabsf(D->m23),
      co_3_size = KSL_MULF(D_13_abs, w_2_padded) + KSL_MULF(D_23_abs, w_1_padded) + w_3_size;
  const float w_0_padded = w_0_size + 1.9721523e-31f;
  const float D_03_abs = fabsf(D->m03),
      co_4_size = KSL_MULF(D_23_abs, w_0_padded) + KSL_MULF(D_03_abs, w_2_padded) + w_4_size;
  const float co_5_size = KSL_MULF(D_03_abs, w_1_padded) + KSL_MULF(D_13_abs, w_0_padded)
          + w_5_size;
  const float w_0_bound = KSL_MULF(1.7881396e-07f, w_0_padded),
      w_1_bound = KSL_MULF(1.7881396e-07f, w_1_padded),
      w_2_bound = KSL_MULF(1.7881396e-07f, w_2_padded);
  const float co_3_bound = KSL_MULF(3.5762795e-07f, co_3_size + 1.9721523e-31f),
      co_4_bound = KSL_MULF(3.5762795e-07f, co_4_size + 1.9721523e-31f),
      co_5_bound = KSL_MULF(3.5762795e-07f, co_5_size + 1.9721523e-31f);
  co->m0 = w_0;
  co->m1 = w_1;
  co->m2 = w_2;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
  co_bound->m0 = w_0_bound;
  co_bound->m1 = w_1_bound;
  co_bound->m2 = w_2_bound;
  co_bound->m3 = co_3_bound;
  co_bound->m4 = co_4_bound;
  co_bound->m5 = co_5_bound;
}

/* co = h̄* c = [Ad]*(D) P c; P keeps component 0 of c, given in the frame of a tx joint at D;
     |error of co| <= co_bound unless inf or NaN.
   D: displacement [R | t], R rotation, t in m; c, co, co_bound: coscrew (f in N; τ in N m).
   21 mul, 12 add, 6 abs. */
static inline void ksl_working_ctxf_certified(const ksl_SE3f_t *D, const ksl_coscrewf_t *c,
    ksl_coscrewf_t *co, ksl_coscrewf_t *co_bound) {
  const float w_0 = KSL_MULF(D->m00, c->m0), w_1 = KSL_MULF(D->m10, c->m0),
      w_2 = KSL_MULF(D->m20, c->m0);
  const float co_3 = KSL_MULF(D->m13, w_2) - KSL_MULF(D->m23, w_1);
  const float co_4 = KSL_MULF(D->m23, w_0) - KSL_MULF(D->m03, w_2);
  const float co_5 = KSL_MULF(D->m03, w_1) - KSL_MULF(D->m13, w_0);
  const float w_2_padded = fabsf(w_2) + 1.9721523e-31f;
  const float D_13_abs = fabsf(D->m13);
  const float w_1_padded = fabsf(w_1) + 1.9721523e-31f;
  const float D_23_abs = fabsf(D->m23),
      co_3_size = KSL_MULF(D_13_abs, w_2_padded) + KSL_MULF(D_23_abs, w_1_padded);
  const float w_0_padded = fabsf(w_0) + 1.9721523e-31f;
  const float D_03_abs = fabsf(D->m03),
      co_4_size = KSL_MULF(D_23_abs, w_0_padded) + KSL_MULF(D_03_abs, w_2_padded);
  const float co_5_size = KSL_MULF(D_03_abs, w_1_padded) + KSL_MULF(D_13_abs, w_0_padded);
  const float w_0_bound = KSL_MULF(5.960465e-08f, w_0_padded),
      w_1_bound = KSL_MULF(5.960465e-08f, w_1_padded),
      w_2_bound = KSL_MULF(5.960465e-08f, w_2_padded);
  const float co_3_bound = KSL_MULF(1.7881396e-07f, co_3_size + 1.9721523e-31f),
      co_4_bound = KSL_MULF(1.7881396e-07f, co_4_size + 1.9721523e-31f),
      co_5_bound = KSL_MULF(1.7881396e-07f, co_5_size + 1.9721523e-31f);
  co->m0 = w_0;
  co->m1 = w_1;
  co->m2 = w_2;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
  co_bound->m0 = w_0_bound;
  co_bound->m1 = w_1_bound;
  co_bound->m2 = w_2_bound;
  co_bound->m3 = co_3_bound;
  co_bound->m4 = co_4_bound;
  co_bound->m5 = co_5_bound;
}

/* co = h̄* c = [Ad]*(D) P c; P keeps component 1 of c, given in the frame of a ty joint at D;
     |error of co| <= co_bound unless inf or NaN.
   D: displacement [R | t], R rotation, t in m; c, co, co_bound: coscrew (f in N; τ in N m).
   21 mul, 12 add, 6 abs. */
static inline void ksl_working_ctyf_certified(const ksl_SE3f_t *D, const ksl_coscrewf_t *c,
    ksl_coscrewf_t *co, ksl_coscrewf_t *co_bound) {
  const float w_0 = KSL_MULF(D->m01, c->m1), w_1 = KSL_MULF(D->m11, c->m1),
      w_2 = KSL_MULF(D->m21, c->m1);
  const float co_3 = KSL_MULF(D->m13, w_2) - KSL_MULF(D->m23, w_1);
  const float co_4 = KSL_MULF(D->m23, w_0) - KSL_MULF(D->m03, w_2);
  const float co_5 = KSL_MULF(D->m03, w_1) - KSL_MULF(D->m13, w_0);
  const float w_2_padded = fabsf(w_2) + 1.9721523e-31f;
  const float D_13_abs = fabsf(D->m13);
  const float w_1_padded = fabsf(w_1) + 1.9721523e-31f;
  const float D_23_abs = fabsf(D->m23),
      co_3_size = KSL_MULF(D_13_abs, w_2_padded) + KSL_MULF(D_23_abs, w_1_padded);
  const float w_0_padded = fabsf(w_0) + 1.9721523e-31f;
  const float D_03_abs = fabsf(D->m03),
      co_4_size = KSL_MULF(D_23_abs, w_0_padded) + KSL_MULF(D_03_abs, w_2_padded);
  const float co_5_size = KSL_MULF(D_03_abs, w_1_padded) + KSL_MULF(D_13_abs, w_0_padded);
  const float w_0_bound = KSL_MULF(5.960465e-08f, w_0_padded),
      w_1_bound = KSL_MULF(5.960465e-08f, w_1_padded),
      w_2_bound = KSL_MULF(5.960465e-08f, w_2_padded);
  const float co_3_bound = KSL_MULF(1.7881396e-07f, co_3_size + 1.9721523e-31f),
      co_4_bound = KSL_MULF(1.7881396e-07f, co_4_size + 1.9721523e-31f),
      co_5_bound = KSL_MULF(1.7881396e-07f, co_5_size + 1.9721523e-31f);
  co->m0 = w_0;
  co->m1 = w_1;
  co->m2 = w_2;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
  co_bound->m0 = w_0_bound;
  co_bound->m1 = w_1_bound;
  co_bound->m2 = w_2_bound;
  co_bound->m3 = co_3_bound;
  co_bound->m4 = co_4_bound;
  co_bound->m5 = co_5_bound;
}

/* co = h̄* c = [Ad]*(D) P c; P keeps component 2 of c, given in the frame of a tz joint at D;
     |error of co| <= co_bound unless inf or NaN.
   D: displacement [R | t], R rotation, t in m; c, co, co_bound: coscrew (f in N; τ in N m).
   21 mul, 12 add, 6 abs. */
static inline void ksl_working_ctzf_certified(const ksl_SE3f_t *D, const ksl_coscrewf_t *c,
    ksl_coscrewf_t *co, ksl_coscrewf_t *co_bound) {
  const float w_0 = KSL_MULF(D->m02, c->m2), w_1 = KSL_MULF(D->m12, c->m2),
      w_2 = KSL_MULF(D->m22, c->m2);
  const float co_3 = KSL_MULF(D->m13, w_2) - KSL_MULF(D->m23, w_1);
  const float co_4 = KSL_MULF(D->m23, w_0) - KSL_MULF(D->m03, w_2);
  const float co_5 = KSL_MULF(D->m03, w_1) - KSL_MULF(D->m13, w_0);
  const float w_2_padded = fabsf(w_2) + 1.9721523e-31f;
  const float D_13_abs = fabsf(D->m13);
  const float w_1_padded = fabsf(w_1) + 1.9721523e-31f;
  const float D_23_abs = fabsf(D->m23),
      co_3_size = KSL_MULF(D_13_abs, w_2_padded) + KSL_MULF(D_23_abs, w_1_padded);
  const float w_0_padded = fabsf(w_0) + 1.9721523e-31f;
  const float D_03_abs = fabsf(D->m03),
      co_4_size = KSL_MULF(D_23_abs, w_0_padded) + KSL_MULF(D_03_abs, w_2_padded);
  const float co_5_size = KSL_MULF(D_03_abs, w_1_padded) + KSL_MULF(D_13_abs, w_0_padded);
  const float w_0_bound = KSL_MULF(5.960465e-08f, w_0_padded),
      w_1_bound = KSL_MULF(5.960465e-08f, w_1_padded),
      w_2_bound = KSL_MULF(5.960465e-08f, w_2_padded);
  const float co_3_bound = KSL_MULF(1.7881396e-07f, co_3_size + 1.9721523e-31f),
      co_4_bound = KSL_MULF(1.7881396e-07f, co_4_size + 1.9721523e-31f),
      co_5_bound = KSL_MULF(1.7881396e-07f, co_5_size + 1.9721523e-31f);
  co->m0 = w_0;
  co->m1 = w_1;
  co->m2 = w_2;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
  co_bound->m0 = w_0_bound;
  co_bound->m1 = w_1_bound;
  co_bound->m2 = w_2_bound;
  co_bound->m3 = co_3_bound;
  co_bound->m4 = co_4_bound;
  co_bound->m5 = co_5_bound;
}

/* co = h̄* c = [Ad]*(D) P c; P keeps component 3 of c, given in the frame of a rx joint at D;
     |error of co| <= co_bound unless inf or NaN.
   D: displacement [R | t], R rotation, t in m; c, co, co_bound: coscrew (f in N; τ in N m).
   6 mul, 3 add, 3 abs. */
static inline void ksl_working_crxf_certified(const ksl_SE3f_t *D, const ksl_coscrewf_t *c,
    ksl_coscrewf_t *co, ksl_coscrewf_t *co_bound) {
  const float w_3 = KSL_MULF(D->m00, c->m3), w_4 = KSL_MULF(D->m10, c->m3),
      w_5 = KSL_MULF(D->m20, c->m3);
  const float w_3_bound = KSL_MULF(5.960465e-08f, fabsf(w_3) + 1.9721523e-31f),
      w_4_bound = KSL_MULF(5.960465e-08f, fabsf(w_4) + 1.9721523e-31f),
      w_5_bound = KSL_MULF(5.960465e-08f, fabsf(w_5) + 1.9721523e-31f);
  co->m0 = 0.0f;
  co->m1 = 0.0f;
  co->m2 = 0.0f;
  co->m3 = w_3;
  co->m4 = w_4;
  co->m5 = w_5;
  co_bound->m0 = 0.0f;
  co_bound->m1 = 0.0f;
  co_bound->m2 = 0.0f;
  co_bound->m3 = w_3_bound;
  co_bound->m4 = w_4_bound;
  co_bound->m5 = w_5_bound;
}

/* co = h̄* c = [Ad]*(D) P c; P keeps component 4 of c, given in the frame of a ry joint at D;
     |error of co| <= co_bound unless inf or NaN.
   D: displacement [R | t], R rotation, t in m; c, co, co_bound: coscrew (f in N; τ in N m).
   6 mul, 3 add, 3 abs. */
static inline void ksl_working_cryf_certified(const ksl_SE3f_t *D, const ksl_coscrewf_t *c,
    ksl_coscrewf_t *co, ksl_coscrewf_t *co_bound) {
  const float w_3 = KSL_MULF(D->m01, c->m4), w_4 = KSL_MULF(D->m11, c->m4),
      w_5 = KSL_MULF(D->m21, c->m4);
  const float w_3_bound = KSL_MULF(5.960465e-08f, fabsf(w_3) + 1.9721523e-31f),
      w_4_bound = KSL_MULF(5.960465e-08f, fabsf(w_4) + 1.9721523e-31f),
      w_5_bound = KSL_MULF(5.960465e-08f, fabsf(w_5) + 1.9721523e-31f);
  co->m0 = 0.0f;
  co->m1 = 0.0f;
  co->m2 = 0.0f;
  co->m3 = w_3;
  co->m4 = w_4;
  co->m5 = w_5;
  co_bound->m0 = 0.0f;
  co_bound->m1 = 0.0f;
  co_bound->m2 = 0.0f;
  co_bound->m3 = w_3_bound;
  co_bound->m4 = w_4_bound;
  co_bound->m5 = w_5_bound;
}

/* co = h̄* c = [Ad]*(D) P c; P keeps component 5 of c, given in the frame of a rz joint at D;
     |error of co| <= co_bound unless inf or NaN.
   D: displacement [R | t], R rotation, t in m; c, co, co_bound: coscrew (f in N; τ in N m).
   6 mul, 3 add, 3 abs. */
static inline void ksl_working_crzf_certified(const ksl_SE3f_t *D, const ksl_coscrewf_t *c,
    ksl_coscrewf_t *co, ksl_coscrewf_t *co_bound) {
  const float w_3 = KSL_MULF(D->m02, c->m5), w_4 = KSL_MULF(D->m12, c->m5),
      w_5 = KSL_MULF(D->m22, c->m5);
  const float w_3_bound = KSL_MULF(5.960465e-08f, fabsf(w_3) + 1.9721523e-31f),
      w_4_bound = KSL_MULF(5.960465e-08f, fabsf(w_4) + 1.9721523e-31f),
      w_5_bound = KSL_MULF(5.960465e-08f, fabsf(w_5) + 1.9721523e-31f);
  co->m0 = 0.0f;
  co->m1 = 0.0f;
  co->m2 = 0.0f;
  co->m3 = w_3;
  co->m4 = w_4;
  co->m5 = w_5;
  co_bound->m0 = 0.0f;
  co_bound->m1 = 0.0f;
  co_bound->m2 = 0.0f;
  co_bound->m3 = w_3_bound;
  co_bound->m4 = w_4_bound;
  co_bound->m5 = w_5_bound;
}

#endif
