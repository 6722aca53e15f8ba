/* Made by `coscrew generate`; changes are overwritten. */
/* SPDX-License-Identifier: MIT */
/* coscrew 0.2.0.  Copyright (c) 2026 The coscrew authors. */
/* Coscrews: wrenches and momenta, c = (f; τ). */
#ifndef KSL_COSCREW_H
#define KSL_COSCREW_H

#include "ksl_types.h"
#include "screw.h"

/* The coscrew of these entries, in order. */
static inline ksl_coscrew_t ksl_coscrew(const double m0, const double m1, const double m2,
    const double m3, const double m4, const double m5) {
  ksl_coscrew_t value;
  value.m0 = m0;
  value.m1 = m1;
  value.m2 = m2;
  value.m3 = m3;
  value.m4 = m4;
  value.m5 = m5;
  return value;
}

/* co = ci.
   ci, co: coscrew (f in N; τ in N m).
   No arithmetic.
   Exact. */
static inline void ksl_coscrew_copy(const ksl_coscrew_t *ci, ksl_coscrew_t *co) {
  const double ci_m0 = ci->m0;
  const double ci_m1 = ci->m1;
  const double ci_m2 = ci->m2;
  const double ci_m3 = ci->m3;
  const double ci_m4 = ci->m4;
  const double ci_m5 = ci->m5;
  co->m0 = ci_m0;
  co->m1 = ci_m1;
  co->m2 = ci_m2;
  co->m3 = ci_m3;
  co->m4 = ci_m4;
  co->m5 = ci_m5;
}

/* self = a self.
   self: coscrew (f in N; τ in N m); a: number.
   6 mul.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_coscrew_scale(ksl_coscrew_t *self, const double a) {
  const double self_0_new = KSL_MUL(self->m0, a), self_1_new = KSL_MUL(self->m1, a),
      self_2_new = KSL_MUL(self->m2, a), self_3_new = KSL_MUL(self->m3, a),
      self_4_new = KSL_MUL(self->m4, a), self_5_new = KSL_MUL(self->m5, a);
  self->m0 = self_0_new;
  self->m1 = self_1_new;
  self->m2 = self_2_new;
  self->m3 = self_3_new;
  self->m4 = self_4_new;
  self->m5 = self_5_new;
}

/* co = -ci.
   ci, co: coscrew (f in N; τ in N m).
   6 neg.
   Exact. */
static inline void ksl_coscrew_inverted(const ksl_coscrew_t *ci, ksl_coscrew_t *co) {
  const double co_0 = -ci->m0, co_1 = -ci->m1, co_2 = -ci->m2, co_3 = -ci->m3, co_4 = -ci->m4,
      co_5 = -ci->m5;
  co->m0 = co_0;
  co->m1 = co_1;
  co->m2 = co_2;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
}

/* self = -self.
   self: coscrew (f in N; τ in N m).
   6 neg.
   Exact. */
static inline void ksl_coscrew_invert(ksl_coscrew_t *self) {
  const double self_0_new = -self->m0, self_1_new = -self->m1, self_2_new = -self->m2,
      self_3_new = -self->m3, self_4_new = -self->m4, self_5_new = -self->m5;
  self->m0 = self_0_new;
  self->m1 = self_1_new;
  self->m2 = self_2_new;
  self->m3 = self_3_new;
  self->m4 = self_4_new;
  self->m5 = self_5_new;
}

/* y = a x + y.
   a: number; x, y: coscrew (f in N; τ in N m).
   6 mul, 6 add.
   Error <= u |result| + 1 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_axpy_cc(const double a, const ksl_coscrew_t *x, ksl_coscrew_t *y) {
  const double y_0_new = KSL_MUL(a, x->m0) + y->m0, y_1_new = KSL_MUL(a, x->m1) + y->m1,
      y_2_new = KSL_MUL(a, x->m2) + y->m2, y_3_new = KSL_MUL(a, x->m3) + y->m3,
      y_4_new = KSL_MUL(a, x->m4) + y->m4, y_5_new = KSL_MUL(a, x->m5) + y->m5;
  y->m0 = y_0_new;
  y->m1 = y_1_new;
  y->m2 = y_2_new;
  y->m3 = y_3_new;
  y->m4 = y_4_new;
  y->m5 = y_5_new;
}

/* y = x + y.
   x, y: coscrew (f in N; τ in N m).
   6 add.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_xpy_cc(const ksl_coscrew_t *x, ksl_coscrew_t *y) {
  const double y_0_new = x->m0 + y->m0, y_1_new = x->m1 + y->m1, y_2_new = x->m2 + y->m2,
      y_3_new = x->m3 + y->m3, y_4_new = x->m4 + y->m4, y_5_new = x->m5 + y->m5;
  y->m0 = y_0_new;
  y->m1 = y_1_new;
  y->m2 = y_2_new;
  y->m3 = y_3_new;
  y->m4 = y_4_new;
  y->m5 = y_5_new;
}

/* y = -x + y.
   x, y: coscrew (f in N; τ in N m).
   6 add.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_nxpy_cc(const ksl_coscrew_t *x, ksl_coscrew_t *y) {
  const double y_0_new = y->m0 - x->m0, y_1_new = y->m1 - x->m1, y_2_new = y->m2 - x->m2,
      y_3_new = y->m3 - x->m3, y_4_new = y->m4 - x->m4, y_5_new = y->m5 - x->m5;
  y->m0 = y_0_new;
  y->m1 = y_1_new;
  y->m2 = y_2_new;
  y->m3 = y_3_new;
  y->m4 = y_4_new;
  y->m5 = y_5_new;
}

/* co = a ci.
   a: number; ci, co: coscrew (f in N; τ in N m).
   6 mul.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_product_ac(const double a, const ksl_coscrew_t *ci, ksl_coscrew_t *co) {
  const double co_0 = KSL_MUL(a, ci->m0), co_1 = KSL_MUL(a, ci->m1), co_2 = KSL_MUL(a, ci->m2),
      co_3 = KSL_MUL(a, ci->m3), co_4 = KSL_MUL(a, ci->m4), co_5 = KSL_MUL(a, ci->m5);
  co->m0 = co_0;
  co->m1 = co_1;
  co->m2 = co_2;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
}

/* co = c1 + c2.
   c1, c2, co: coscrew (f in N; τ in N m).
   6 add.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_add_cc(const ksl_coscrew_t *c1, const ksl_coscrew_t *c2, ksl_coscrew_t *co) {
  const double co_0 = c1->m0 + c2->m0, co_1 = c1->m1 + c2->m1, co_2 = c1->m2 + c2->m2,
      co_3 = c1->m3 + c2->m3, co_4 = c1->m4 + c2->m4, co_5 = c1->m5 + c2->m5;
  co->m0 = co_0;
  co->m1 = co_1;
  co->m2 = co_2;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
}

/* co = c1 - c2.
   c1, c2, co: coscrew (f in N; τ in N m).
   6 add.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_subtract_cc(const ksl_coscrew_t *c1, const ksl_coscrew_t *c2,
    ksl_coscrew_t *co) {
  const double co_0 = c1->m0 - c2->m0, co_1 = c1->m1 - c2->m1, co_2 = c1->m2 - c2->m2,
      co_3 = c1->m3 - c2->m3, co_4 = c1->m4 - c2->m4, co_5 = c1->m5 - c2->m5;
  co->m0 = co_0;
  co->m1 = co_1;
  co->m2 = co_2;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
}

/* |ci|: |f|, or |τ| where every |f_i| is below 1e-9 (single: 1e-6).
   ci: coscrew (f in N; τ in N m).
   7 mul, 2 add, 1 sqrt, 6 abs, 11 less, 1 equal, 14 select. */
static inline double ksl_coscrew_norm(const ksl_coscrew_t *ci) {
  const double small_c = fabs(ci->m2) < 1e-09 ? 1.0 : 0.0,
      small_f = fabs(ci->m1) < 1e-09 ? small_c : 0.0, small = fabs(ci->m0) < 1e-09 ? small_f : 0.0;
  const double p_0 = small == 1.0 ? ci->m3 : ci->m0, p_1 = small == 1.0 ? ci->m4 : ci->m1,
      p_2 = small == 1.0 ? ci->m5 : ci->m2;
  const double s_size_0 = fabs(p_0), s_size_1 = fabs(p_1), s_size_2 = fabs(p_2);
  const double s_largest1 = s_size_0 < s_size_1 ? s_size_1 : s_size_0;
  const double s_largest2 = s_largest1 < s_size_2 ? s_size_2 : s_largest1;
  const double s_b = 6.703903964971299e+153 < s_largest2 ? 3.7291703656001034e-155 : 1.0,
      s_d = s_largest2 < 256.0 ? 1.3093562431584567e+151 : s_b,
      s = s_largest2 < 1.955159272639747e-149 ? 1.0715086071862673e+301 : s_d;
  const double y_0 = KSL_MUL(p_0, s), y_1 = KSL_MUL(p_1, s), y_2 = KSL_MUL(p_2, s);
  const double n = sqrt(KSL_MUL(y_0, y_0) + KSL_MUL(y_1, y_1) + KSL_MUL(y_2, y_2));
  const double r_b = s < 1.0 ? 2.6815615859885194e+154 : 1.0,
      r_d = 1.0 < s ? 7.637340908749012e-152 : r_b,
      r = 1.3093562431584567e+151 < s ? 9.332636185032189e-302 : r_d;
  const double norm = KSL_MUL(n, r);
  return norm;
}

/* self = self / |self|, with coscrew_norm; the zero coscrew stays zero.
   self: coscrew (f in N; τ in N m).
   18 mul, 2 add, 6 div, 1 sqrt, 9 abs, 16 less, 2 equal, 26 select. */
static inline void ksl_coscrew_normalize(ksl_coscrew_t *self) {
  const double small_a = fabs(self->m2), small_c = small_a < 1e-09 ? 1.0 : 0.0,
      small_d = fabs(self->m1), small_f = small_d < 1e-09 ? small_c : 0.0, small_g = fabs(self->m0),
      small = small_g < 1e-09 ? small_f : 0.0;
  const double p_0 = small == 1.0 ? self->m3 : self->m0, p_1 = small == 1.0 ? self->m4 : self->m1,
      p_2 = small == 1.0 ? self->m5 : self->m2;
  const double s_size_0 = fabs(p_0), s_size_1 = fabs(p_1), s_size_2 = fabs(p_2);
  const double s_largest1 = s_size_0 < s_size_1 ? s_size_1 : s_size_0;
  const double s_largest2 = s_largest1 < s_size_2 ? s_size_2 : s_largest1;
  const double s_b = 6.703903964971299e+153 < s_largest2 ? 3.7291703656001034e-155 : 1.0,
      s_d = s_largest2 < 256.0 ? 1.3093562431584567e+151 : s_b,
      s = s_largest2 < 1.955159272639747e-149 ? 1.0715086071862673e+301 : s_d;
  const double y_0 = KSL_MUL(p_0, s), y_1 = KSL_MUL(p_1, s), y_2 = KSL_MUL(p_2, s);
  const double up = 1.0 < s ? s : 1.0;
  const double down = s < 1.0 ? s : 1.0;
  const double n = sqrt(KSL_MUL(y_0, y_0) + KSL_MUL(y_1, y_1) + KSL_MUL(y_2, y_2));
  const double divisor = n == 0.0 ? up : n;
  const double size_3 = fabs(self->m3), size_4 = fabs(self->m4), size_5 = fabs(self->m5);
  const double before_0 = small_g < 256.0 ? up : down, before_1 = small_d < 256.0 ? up : down,
      before_2 = small_a < 256.0 ? up : down, before_3 = size_3 < 256.0 ? up : down,
      before_4 = size_4 < 256.0 ? up : down, before_5 = size_5 < 256.0 ? up : down;
  const double after_0 = small_g < 256.0 ? down : up, after_1 = small_d < 256.0 ? down : up,
      after_2 = small_a < 256.0 ? down : up, after_3 = size_3 < 256.0 ? down : up,
      after_4 = size_4 < 256.0 ? down : up, after_5 = size_5 < 256.0 ? down : up;
  const double sized_0 = KSL_MUL(self->m0, before_0), sized_1 = KSL_MUL(self->m1, before_1),
      sized_2 = KSL_MUL(self->m2, before_2), sized_3 = KSL_MUL(self->m3, before_3),
      sized_4 = KSL_MUL(self->m4, before_4), sized_5 = KSL_MUL(self->m5, before_5);
  const double quotient_0 = sized_0 / divisor, quotient_1 = sized_1 / divisor,
      quotient_2 = sized_2 / divisor, quotient_3 = sized_3 / divisor,
      quotient_4 = sized_4 / divisor, quotient_5 = sized_5 / divisor;
  const double self_0_new = KSL_MUL(quotient_0, after_0), self_1_new = KSL_MUL(quotient_1, after_1),
      self_2_new = KSL_MUL(quotient_2, after_2), self_3_new = KSL_MUL(quotient_3, after_3),
      self_4_new = KSL_MUL(quotient_4, after_4), self_5_new = KSL_MUL(quotient_5, after_5);
  self->m0 = self_0_new;
  self->m1 = self_1_new;
  self->m2 = self_2_new;
  self->m3 = self_3_new;
  self->m4 = self_4_new;
  self->m5 = self_5_new;
}

/* co = ci / |ci|, with coscrew_norm; the zero coscrew stays zero.
   ci, co: coscrew (f in N; τ in N m).
   18 mul, 2 add, 6 div, 1 sqrt, 9 abs, 16 less, 2 equal, 26 select. */
static inline void ksl_coscrew_normalized(const ksl_coscrew_t *ci, ksl_coscrew_t *co) {
  const double small_a = fabs(ci->m2), small_c = small_a < 1e-09 ? 1.0 : 0.0,
      small_d = fabs(ci->m1), small_f = small_d < 1e-09 ? small_c : 0.0, small_g = fabs(ci->m0),
      small = small_g < 1e-09 ? small_f : 0.0;
  const double p_0 = small == 1.0 ? ci->m3 : ci->m0, p_1 = small == 1.0 ? ci->m4 : ci->m1,
      p_2 = small == 1.0 ? ci->m5 : ci->m2;
  const double s_size_0 = fabs(p_0), s_size_1 = fabs(p_1), s_size_2 = fabs(p_2);
  const double s_largest1 = s_size_0 < s_size_1 ? s_size_1 : s_size_0;
  const double s_largest2 = s_largest1 < s_size_2 ? s_size_2 : s_largest1;
  const double s_b = 6.703903964971299e+153 < s_largest2 ? 3.7291703656001034e-155 : 1.0,
      s_d = s_largest2 < 256.0 ? 1.3093562431584567e+151 : s_b,
      s = s_largest2 < 1.955159272639747e-149 ? 1.0715086071862673e+301 : s_d;
  const double y_0 = KSL_MUL(p_0, s), y_1 = KSL_MUL(p_1, s), y_2 = KSL_MUL(p_2, s);
  const double up = 1.0 < s ? s : 1.0;
  const double down = s < 1.0 ? s : 1.0;
  const double n = sqrt(KSL_MUL(y_0, y_0) + KSL_MUL(y_1, y_1) + KSL_MUL(y_2, y_2));
  const double divisor = n == 0.0 ? up : n;
  const double size_3 = fabs(ci->m3), size_4 = fabs(ci->m4), size_5 = fabs(ci->m5);
  const double before_0 = small_g < 256.0 ? up : down, before_1 = small_d < 256.0 ? up : down,
      before_2 = small_a < 256.0 ? up : down, before_3 = size_3 < 256.0 ? up : down,
      before_4 = size_4 < 256.0 ? up : down, before_5 = size_5 < 256.0 ? up : down;
  const double after_0 = small_g < 256.0 ? down : up, after_1 = small_d < 256.0 ? down : up,
      after_2 = small_a < 256.0 ? down : up, after_3 = size_3 < 256.0 ? down : up,
      after_4 = size_4 < 256.0 ? down : up, after_5 = size_5 < 256.0 ? down : up;
  const double sized_0 = KSL_MUL(ci->m0, before_0), sized_1 = KSL_MUL(ci->m1, before_1),
      sized_2 = KSL_MUL(ci->m2, before_2), sized_3 = KSL_MUL(ci->m3, before_3),
      sized_4 = KSL_MUL(ci->m4, before_4), sized_5 = KSL_MUL(ci->m5, before_5);
  const double quotient_0 = sized_0 / divisor, quotient_1 = sized_1 / divisor,
      quotient_2 = sized_2 / divisor, quotient_3 = sized_3 / divisor,
      quotient_4 = sized_4 / divisor, quotient_5 = sized_5 / divisor;
  const double co_0 = KSL_MUL(quotient_0, after_0), co_1 = KSL_MUL(quotient_1, after_1),
      co_2 = KSL_MUL(quotient_2, after_2), co_3 = KSL_MUL(quotient_3, after_3),
      co_4 = KSL_MUL(quotient_4, after_4), co_5 = KSL_MUL(quotient_5, after_5);
  co->m0 = co_0;
  co->m1 = co_1;
  co->m2 = co_2;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
}

/* co = (lin; ang).
   lin, ang: vector; co: coscrew (f in N; τ in N m).
   No arithmetic.
   Exact. */
static inline void ksl_coscrew_from_lin_ang(const ksl_vec3_t *lin, const ksl_vec3_t *ang,
    ksl_coscrew_t *co) {
  const double lin_x = lin->x;
  const double lin_y = lin->y;
  const double lin_z = lin->z;
  const double ang_x = ang->x;
  const double ang_y = ang->y;
  const double ang_z = ang->z;
  co->m0 = lin_x;
  co->m1 = lin_y;
  co->m2 = lin_z;
  co->m3 = ang_x;
  co->m4 = ang_y;
  co->m5 = ang_z;
}

/* x = (ang; lin) of ci.
   ci: coscrew (f in N; τ in N m); x: six components with the angular part on top.
   No arithmetic.
   Exact. */
static inline void ksl_coscrew_to_angular_first(const ksl_coscrew_t *ci, double x[6]) {
  const double ci_m3 = ci->m3;
  const double ci_m4 = ci->m4;
  const double ci_m5 = ci->m5;
  const double ci_m0 = ci->m0;
  const double ci_m1 = ci->m1;
  const double ci_m2 = ci->m2;
  x[0] = ci_m3;
  x[1] = ci_m4;
  x[2] = ci_m5;
  x[3] = ci_m0;
  x[4] = ci_m1;
  x[5] = ci_m2;
}

/* co = (lin; ang) of x = (ang; lin).
   x: six components with the angular part on top; co: coscrew (f in N; τ in N m).
   No arithmetic.
   Exact. */
static inline void ksl_coscrew_from_angular_first(const double x[6], ksl_coscrew_t *co) {
  const double x_3 = x[3];
  const double x_4 = x[4];
  const double x_5 = x[5];
  const double x_0 = x[0];
  const double x_1 = x[1];
  const double x_2 = x[2];
  co->m0 = x_3;
  co->m1 = x_4;
  co->m2 = x_5;
  co->m3 = x_0;
  co->m4 = x_1;
  co->m5 = x_2;
}

/* co = (c1.lin + c2.lin ; c1.ang).
   c1, c2, co: coscrew (f in N; τ in N m).
   3 add.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_add_cct(const ksl_coscrew_t *c1, const ksl_coscrew_t *c2,
    ksl_coscrew_t *co) {
  const double co_0 = c1->m0 + c2->m0, co_1 = c1->m1 + c2->m1, co_2 = c1->m2 + c2->m2;
  const double c1_m3 = c1->m3;
  const double c1_m4 = c1->m4;
  const double c1_m5 = c1->m5;
  co->m0 = co_0;
  co->m1 = co_1;
  co->m2 = co_2;
  co->m3 = c1_m3;
  co->m4 = c1_m4;
  co->m5 = c1_m5;
}

/* co = [Ad]*(t) ci.
   t: vector; ci, co: coscrew (f in N; τ in N m).
   6 mul, 6 add.
   Error <= u |result| + (lin: 0, ang: 2) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_CoAdtc(const ksl_vec3_t *t, const ksl_coscrew_t *ci,
    ksl_coscrew_t *co) {
  const double co_3 = KSL_MUL(t->y, ci->m2) - KSL_MUL(t->z, ci->m1) + ci->m3,
      co_4 = KSL_MUL(t->z, ci->m0) - KSL_MUL(t->x, ci->m2) + ci->m4,
      co_5 = KSL_MUL(t->x, ci->m1) - KSL_MUL(t->y, ci->m0) + ci->m5;
  const double ci_m0 = ci->m0;
  const double ci_m1 = ci->m1;
  const double ci_m2 = ci->m2;
  co->m0 = ci_m0;
  co->m1 = ci_m1;
  co->m2 = ci_m2;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
}

/* co = [Ad]*(t)^-1 ci.
   t: vector; ci, co: coscrew (f in N; τ in N m).
   6 mul, 6 add.
   Error <= u |result| + (lin: 0, ang: 2) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_CoAdtinvc(const ksl_vec3_t *t, const ksl_coscrew_t *ci,
    ksl_coscrew_t *co) {
  const double co_3 = KSL_MUL(t->z, ci->m1) - KSL_MUL(t->y, ci->m2) + ci->m3,
      co_4 = KSL_MUL(t->x, ci->m2) - KSL_MUL(t->z, ci->m0) + ci->m4,
      co_5 = KSL_MUL(t->y, ci->m0) - KSL_MUL(t->x, ci->m1) + ci->m5;
  const double ci_m0 = ci->m0;
  const double ci_m1 = ci->m1;
  const double ci_m2 = ci->m2;
  co->m0 = ci_m0;
  co->m1 = ci_m1;
  co->m2 = ci_m2;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
}

/* co = [Ad]*(t) (-ci).
   t: vector; ci, co: coscrew (f in N; τ in N m).
   6 mul, 6 add, 3 neg.
   Error <= u |result| + (lin: 0, ang: 2) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_CoAdtcinv(const ksl_vec3_t *t, const ksl_coscrew_t *ci,
    ksl_coscrew_t *co) {
  const double co_0 = -ci->m0, co_1 = -ci->m1, co_2 = -ci->m2,
      co_3 = KSL_MUL(t->z, ci->m1) - KSL_MUL(t->y, ci->m2) - ci->m3,
      co_4 = KSL_MUL(t->x, ci->m2) - KSL_MUL(t->z, ci->m0) - ci->m4,
      co_5 = KSL_MUL(t->y, ci->m0) - KSL_MUL(t->x, ci->m1) - ci->m5;
  co->m0 = co_0;
  co->m1 = co_1;
  co->m2 = co_2;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
}

/* co = [Ad]*(R) ci.
   R: rotation or other 3×3 matrix; ci, co: coscrew (f in N; τ in N m).
   18 mul, 12 add.
   Error <= u |result| + 2 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_product_CoAdrc(const ksl_mat3x3_t *R, const ksl_coscrew_t *ci,
    ksl_coscrew_t *co) {
  const double co_0 = KSL_MUL(R->m00, ci->m0) + KSL_MUL(R->m01, ci->m1) + KSL_MUL(R->m02, ci->m2),
      co_1 = KSL_MUL(R->m10, ci->m0) + KSL_MUL(R->m11, ci->m1) + KSL_MUL(R->m12, ci->m2),
      co_2 = KSL_MUL(R->m20, ci->m0) + KSL_MUL(R->m21, ci->m1) + KSL_MUL(R->m22, ci->m2),
      co_3 = KSL_MUL(R->m00, ci->m3) + KSL_MUL(R->m01, ci->m4) + KSL_MUL(R->m02, ci->m5),
      co_4 = KSL_MUL(R->m10, ci->m3) + KSL_MUL(R->m11, ci->m4) + KSL_MUL(R->m12, ci->m5),
      co_5 = KSL_MUL(R->m20, ci->m3) + KSL_MUL(R->m21, ci->m4) + KSL_MUL(R->m22, ci->m5);
  co->m0 = co_0;
  co->m1 = co_1;
  co->m2 = co_2;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
}

/* co = [Ad]*(R)^-1 ci.
   R: rotation or other 3×3 matrix; ci, co: coscrew (f in N; τ in N m).
   18 mul, 12 add.
   Error <= u |result| + 2 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_product_CoAdrinvc(const ksl_mat3x3_t *R, const ksl_coscrew_t *ci,
    ksl_coscrew_t *co) {
  const double co_0 = KSL_MUL(R->m00, ci->m0) + KSL_MUL(R->m10, ci->m1) + KSL_MUL(R->m20, ci->m2),
      co_1 = KSL_MUL(R->m01, ci->m0) + KSL_MUL(R->m11, ci->m1) + KSL_MUL(R->m21, ci->m2),
      co_2 = KSL_MUL(R->m02, ci->m0) + KSL_MUL(R->m12, ci->m1) + KSL_MUL(R->m22, ci->m2),
      co_3 = KSL_MUL(R->m00, ci->m3) + KSL_MUL(R->m10, ci->m4) + KSL_MUL(R->m20, ci->m5),
      co_4 = KSL_MUL(R->m01, ci->m3) + KSL_MUL(R->m11, ci->m4) + KSL_MUL(R->m21, ci->m5),
      co_5 = KSL_MUL(R->m02, ci->m3) + KSL_MUL(R->m12, ci->m4) + KSL_MUL(R->m22, ci->m5);
  co->m0 = co_0;
  co->m1 = co_1;
  co->m2 = co_2;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
}

/* co = [Ad]*(R) (-ci).
   R: rotation or other 3×3 matrix; ci, co: coscrew (f in N; τ in N m).
   18 mul, 12 add, 6 neg.
   Error <= u |result| + 2 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_product_CoAdrcinv(const ksl_mat3x3_t *R, const ksl_coscrew_t *ci,
    ksl_coscrew_t *co) {
  const double co_0 =
          -(KSL_MUL(R->m00, ci->m0) + KSL_MUL(R->m01, ci->m1) + KSL_MUL(R->m02, ci->m2)),
      co_1 = -(KSL_MUL(R->m10, ci->m0) + KSL_MUL(R->m11, ci->m1) + KSL_MUL(R->m12, ci->m2)),
      co_2 = -(KSL_MUL(R->m20, ci->m0) + KSL_MUL(R->m21, ci->m1) + KSL_MUL(R->m22, ci->m2)),
      co_3 = -(KSL_MUL(R->m00, ci->m3) + KSL_MUL(R->m01, ci->m4) + KSL_MUL(R->m02, ci->m5)),
      co_4 = -(KSL_MUL(R->m10, ci->m3) + KSL_MUL(R->m11, ci->m4) + KSL_MUL(R->m12, ci->m5)),
      co_5 = -(KSL_MUL(R->m20, ci->m3) + KSL_MUL(R->m21, ci->m4) + KSL_MUL(R->m22, ci->m5));
  co->m0 = co_0;
  co->m1 = co_1;
  co->m2 = co_2;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
}

/* co = [Ad]*(D) ci = [Ad]*(t) [Ad]*(R) ci.
   D: displacement [R | t], R rotation, t in m; ci, co: coscrew (f in N; τ in N m).
   24 mul, 18 add.
   Error <= u |result| + (lin: 2, ang: 5) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_CoAdc(const ksl_SE3_t *D, const ksl_coscrew_t *ci,
    ksl_coscrew_t *co) {
  const double w_0 = KSL_MUL(D->m00, ci->m0) + KSL_MUL(D->m01, ci->m1) + KSL_MUL(D->m02, ci->m2),
      w_1 = KSL_MUL(D->m10, ci->m0) + KSL_MUL(D->m11, ci->m1) + KSL_MUL(D->m12, ci->m2),
      w_2 = KSL_MUL(D->m20, ci->m0) + KSL_MUL(D->m21, ci->m1) + KSL_MUL(D->m22, ci->m2),
      w_3 = KSL_MUL(D->m00, ci->m3) + KSL_MUL(D->m01, ci->m4) + KSL_MUL(D->m02, ci->m5),
      w_4 = KSL_MUL(D->m10, ci->m3) + KSL_MUL(D->m11, ci->m4) + KSL_MUL(D->m12, ci->m5),
      w_5 = KSL_MUL(D->m20, ci->m3) + KSL_MUL(D->m21, ci->m4) + KSL_MUL(D->m22, ci->m5);
  const double co_3 = KSL_MUL(D->m13, w_2) - KSL_MUL(D->m23, w_1) + w_3,
      co_4 = KSL_MUL(D->m23, w_0) - KSL_MUL(D->m03, w_2) + w_4,
      co_5 = KSL_MUL(D->m03, w_1) - KSL_MUL(D->m13, w_0) + w_5;
  co->m0 = w_0;
  co->m1 = w_1;
  co->m2 = w_2;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
}

/* co = [Ad]*(D)^-1 ci = [Ad]*(R^T) [Ad]*(-t) ci.
   D: displacement [R | t], R rotation, t in m; ci, co: coscrew (f in N; τ in N m).
   24 mul, 18 add.
   Error <= u |result| + (lin: 2, ang: 5) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_CoAdinvc(const ksl_SE3_t *D, const ksl_coscrew_t *ci,
    ksl_coscrew_t *co) {
  const double w_3 = KSL_MUL(D->m23, ci->m1) - KSL_MUL(D->m13, ci->m2) + ci->m3,
      w_4 = KSL_MUL(D->m03, ci->m2) - KSL_MUL(D->m23, ci->m0) + ci->m4,
      w_5 = KSL_MUL(D->m13, ci->m0) - KSL_MUL(D->m03, ci->m1) + ci->m5;
  const double co_0 = KSL_MUL(D->m00, ci->m0) + KSL_MUL(D->m10, ci->m1) + KSL_MUL(D->m20, ci->m2),
      co_1 = KSL_MUL(D->m01, ci->m0) + KSL_MUL(D->m11, ci->m1) + KSL_MUL(D->m21, ci->m2),
      co_2 = KSL_MUL(D->m02, ci->m0) + KSL_MUL(D->m12, ci->m1) + KSL_MUL(D->m22, ci->m2),
      co_3 = KSL_MUL(D->m00, w_3) + KSL_MUL(D->m10, w_4) + KSL_MUL(D->m20, w_5),
      co_4 = KSL_MUL(D->m01, w_3) + KSL_MUL(D->m11, w_4) + KSL_MUL(D->m21, w_5),
      co_5 = KSL_MUL(D->m02, w_3) + KSL_MUL(D->m12, w_4) + KSL_MUL(D->m22, w_5);
  co->m0 = co_0;
  co->m1 = co_1;
  co->m2 = co_2;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
}

/* co = [Ad]*(D) (-ci).
   D: displacement [R | t], R rotation, t in m; ci, co: coscrew (f in N; τ in N m).
   24 mul, 18 add, 6 neg.
   Error <= u |result| + (lin: 2, ang: 5) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_CoAdcinv(const ksl_SE3_t *D, const ksl_coscrew_t *ci,
    ksl_coscrew_t *co) {
  const double w_0 = -(KSL_MUL(D->m00, ci->m0) + KSL_MUL(D->m01, ci->m1) + KSL_MUL(D->m02, ci->m2)),
      w_1 = -(KSL_MUL(D->m10, ci->m0) + KSL_MUL(D->m11, ci->m1) + KSL_MUL(D->m12, ci->m2)),
      w_2 = -(KSL_MUL(D->m20, ci->m0) + KSL_MUL(D->m21, ci->m1) + KSL_MUL(D->m22, ci->m2)),
      w_3 = -(KSL_MUL(D->m00, ci->m3) + KSL_MUL(D->m01, ci->m4) + KSL_MUL(D->m02, ci->m5)),
      w_4 = -(KSL_MUL(D->m10, ci->m3) + KSL_MUL(D->m11, ci->m4) + KSL_MUL(D->m12, ci->m5)),
      w_5 = -(KSL_MUL(D->m20, ci->m3) + KSL_MUL(D->m21, ci->m4) + KSL_MUL(D->m22, ci->m5));
  const double co_3 = KSL_MUL(D->m13, w_2) - KSL_MUL(D->m23, w_1) + w_3,
      co_4 = KSL_MUL(D->m23, w_0) - KSL_MUL(D->m03, w_2) + w_4,
      co_5 = KSL_MUL(D->m03, w_1) - KSL_MUL(D->m13, w_0) + w_5;
  co->m0 = w_0;
  co->m1 = w_1;
  co->m2 = w_2;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
}

/* co = h_tx: column 0 of [Ad]*(D).
   D: displacement [R | t], R rotation, t in m; co: coscrew (f in N; τ in N m).
   6 mul, 3 add.
   Error <= u |result| + (lin: 0, ang: 1) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_hctx(const ksl_SE3_t *D, ksl_coscrew_t *co) {
  const double co_3 = KSL_MUL(D->m20, D->m13) - KSL_MUL(D->m10, D->m23),
      co_4 = KSL_MUL(D->m00, D->m23) - KSL_MUL(D->m20, D->m03),
      co_5 = KSL_MUL(D->m10, D->m03) - KSL_MUL(D->m00, D->m13);
  const double D_m00 = D->m00;
  const double D_m10 = D->m10;
  const double D_m20 = D->m20;
  co->m0 = D_m00;
  co->m1 = D_m10;
  co->m2 = D_m20;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
}

/* co = h_ty: column 1 of [Ad]*(D).
   D: displacement [R | t], R rotation, t in m; co: coscrew (f in N; τ in N m).
   6 mul, 3 add.
   Error <= u |result| + (lin: 0, ang: 1) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_hcty(const ksl_SE3_t *D, ksl_coscrew_t *co) {
  const double co_3 = KSL_MUL(D->m21, D->m13) - KSL_MUL(D->m11, D->m23),
      co_4 = KSL_MUL(D->m01, D->m23) - KSL_MUL(D->m21, D->m03),
      co_5 = KSL_MUL(D->m11, D->m03) - KSL_MUL(D->m01, D->m13);
  const double D_m01 = D->m01;
  const double D_m11 = D->m11;
  const double D_m21 = D->m21;
  co->m0 = D_m01;
  co->m1 = D_m11;
  co->m2 = D_m21;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
}

/* co = h_tz: column 2 of [Ad]*(D).
   D: displacement [R | t], R rotation, t in m; co: coscrew (f in N; τ in N m).
   6 mul, 3 add.
   Error <= u |result| + (lin: 0, ang: 1) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_hctz(const ksl_SE3_t *D, ksl_coscrew_t *co) {
  const double co_3 = KSL_MUL(D->m22, D->m13) - KSL_MUL(D->m12, D->m23),
      co_4 = KSL_MUL(D->m02, D->m23) - KSL_MUL(D->m22, D->m03),
      co_5 = KSL_MUL(D->m12, D->m03) - KSL_MUL(D->m02, D->m13);
  const double D_m02 = D->m02;
  const double D_m12 = D->m12;
  const double D_m22 = D->m22;
  co->m0 = D_m02;
  co->m1 = D_m12;
  co->m2 = D_m22;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
}

/* co = h_rx: column 3 of [Ad]*(D).
   D: displacement [R | t], R rotation, t in m; co: coscrew (f in N; τ in N m).
   No arithmetic.
   Exact. */
static inline void ksl_hcrx(const ksl_SE3_t *D, ksl_coscrew_t *co) {
  const double D_m00 = D->m00;
  const double D_m10 = D->m10;
  const double D_m20 = D->m20;
  co->m0 = 0.0;
  co->m1 = 0.0;
  co->m2 = 0.0;
  co->m3 = D_m00;
  co->m4 = D_m10;
  co->m5 = D_m20;
}

/* co = h_ry: column 4 of [Ad]*(D).
   D: displacement [R | t], R rotation, t in m; co: coscrew (f in N; τ in N m).
   No arithmetic.
   Exact. */
static inline void ksl_hcry(const ksl_SE3_t *D, ksl_coscrew_t *co) {
  const double D_m01 = D->m01;
  const double D_m11 = D->m11;
  const double D_m21 = D->m21;
  co->m0 = 0.0;
  co->m1 = 0.0;
  co->m2 = 0.0;
  co->m3 = D_m01;
  co->m4 = D_m11;
  co->m5 = D_m21;
}

/* co = h_rz: column 5 of [Ad]*(D).
   D: displacement [R | t], R rotation, t in m; co: coscrew (f in N; τ in N m).
   No arithmetic.
   Exact. */
static inline void ksl_hcrz(const ksl_SE3_t *D, ksl_coscrew_t *co) {
  const double D_m02 = D->m02;
  const double D_m12 = D->m12;
  const double D_m22 = D->m22;
  co->m0 = 0.0;
  co->m1 = 0.0;
  co->m2 = 0.0;
  co->m3 = D_m02;
  co->m4 = D_m12;
  co->m5 = D_m22;
}

/* co = -h_tx: -column 0 of [Ad]*(D).
   D: displacement [R | t], R rotation, t in m; co: coscrew (f in N; τ in N m).
   6 mul, 3 add, 3 neg.
   Error <= u |result| + (lin: 0, ang: 1) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_hctxinv(const ksl_SE3_t *D, ksl_coscrew_t *co) {
  const double co_0 = -D->m00, co_1 = -D->m10, co_2 = -D->m20,
      co_3 = KSL_MUL(D->m10, D->m23) - KSL_MUL(D->m20, D->m13),
      co_4 = KSL_MUL(D->m20, D->m03) - KSL_MUL(D->m00, D->m23),
      co_5 = KSL_MUL(D->m00, D->m13) - KSL_MUL(D->m10, D->m03);
  co->m0 = co_0;
  co->m1 = co_1;
  co->m2 = co_2;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
}

/* co = -h_ty: -column 1 of [Ad]*(D).
   D: displacement [R | t], R rotation, t in m; co: coscrew (f in N; τ in N m).
   6 mul, 3 add, 3 neg.
   Error <= u |result| + (lin: 0, ang: 1) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_hctyinv(const ksl_SE3_t *D, ksl_coscrew_t *co) {
  const double co_0 = -D->m01, co_1 = -D->m11, co_2 = -D->m21,
      co_3 = KSL_MUL(D->m11, D->m23) - KSL_MUL(D->m21, D->m13),
      co_4 = KSL_MUL(D->m21, D->m03) - KSL_MUL(D->m01, D->m23),
      co_5 = KSL_MUL(D->m01, D->m13) - KSL_MUL(D->m11, D->m03);
  co->m0 = co_0;
  co->m1 = co_1;
  co->m2 = co_2;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
}

/* co = -h_tz: -column 2 of [Ad]*(D).
   D: displacement [R | t], R rotation, t in m; co: coscrew (f in N; τ in N m).
   6 mul, 3 add, 3 neg.
   Error <= u |result| + (lin: 0, ang: 1) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_hctzinv(const ksl_SE3_t *D, ksl_coscrew_t *co) {
  const double co_0 = -D->m02, co_1 = -D->m12, co_2 = -D->m22,
      co_3 = KSL_MUL(D->m12, D->m23) - KSL_MUL(D->m22, D->m13),
      co_4 = KSL_MUL(D->m22, D->m03) - KSL_MUL(D->m02, D->m23),
      co_5 = KSL_MUL(D->m02, D->m13) - KSL_MUL(D->m12, D->m03);
  co->m0 = co_0;
  co->m1 = co_1;
  co->m2 = co_2;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
}

/* co = -h_rx: -column 3 of [Ad]*(D).
   D: displacement [R | t], R rotation, t in m; co: coscrew (f in N; τ in N m).
   3 neg.
   Exact. */
static inline void ksl_hcrxinv(const ksl_SE3_t *D, ksl_coscrew_t *co) {
  const double co_3 = -D->m00, co_4 = -D->m10, co_5 = -D->m20;
  co->m0 = 0.0;
  co->m1 = 0.0;
  co->m2 = 0.0;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
}

/* co = -h_ry: -column 4 of [Ad]*(D).
   D: displacement [R | t], R rotation, t in m; co: coscrew (f in N; τ in N m).
   3 neg.
   Exact. */
static inline void ksl_hcryinv(const ksl_SE3_t *D, ksl_coscrew_t *co) {
  const double co_3 = -D->m01, co_4 = -D->m11, co_5 = -D->m21;
  co->m0 = 0.0;
  co->m1 = 0.0;
  co->m2 = 0.0;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
}

/* co = -h_rz: -column 5 of [Ad]*(D).
   D: displacement [R | t], R rotation, t in m; co: coscrew (f in N; τ in N m).
   3 neg.
   Exact. */
static inline void ksl_hcrzinv(const ksl_SE3_t *D, ksl_coscrew_t *co) {
  const double co_3 = -D->m02, co_4 = -D->m12, co_5 = -D->m22;
  co->m0 = 0.0;
  co->m1 = 0.0;
  co->m2 = 0.0;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
}

/* M = [Ad]*(D).
   D: displacement [R | t], R rotation, t in m; M: 6×6 operator.
   18 mul, 9 add.
   Error <= u |result| + 1 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_CoAd(const ksl_SE3_t *D, ksl_mat6x6_t *M) {
  const double M_30 = KSL_MUL(D->m20, D->m13) - KSL_MUL(D->m10, D->m23),
      M_31 = KSL_MUL(D->m21, D->m13) - KSL_MUL(D->m11, D->m23),
      M_32 = KSL_MUL(D->m22, D->m13) - KSL_MUL(D->m12, D->m23),
      M_40 = KSL_MUL(D->m00, D->m23) - KSL_MUL(D->m20, D->m03),
      M_41 = KSL_MUL(D->m01, D->m23) - KSL_MUL(D->m21, D->m03),
      M_42 = KSL_MUL(D->m02, D->m23) - KSL_MUL(D->m22, D->m03),
      M_50 = KSL_MUL(D->m10, D->m03) - KSL_MUL(D->m00, D->m13),
      M_51 = KSL_MUL(D->m11, D->m03) - KSL_MUL(D->m01, D->m13),
      M_52 = KSL_MUL(D->m12, D->m03) - KSL_MUL(D->m02, D->m13);
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
}

/* power = W ⊙ $ = f·v + τ·ω, W = c = (f; τ), $ = x = (ω; v).
   c: coscrew (f in N; τ in N m); x: six components with the angular part on top.
   6 mul, 5 add.
   Error <= u |result| + 3 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline double ksl_reciprocal_product(const ksl_coscrew_t *c, const double x[6]) {
  const double power = KSL_MUL(c->m0, x[3]) + KSL_MUL(c->m1, x[4]) + KSL_MUL(c->m2, x[5])
          + (KSL_MUL(c->m3, x[0]) + KSL_MUL(c->m4, x[1]) + KSL_MUL(c->m5, x[2]));
  return power;
}

/* co = [ad]*(s) c = (ω×f ; v×f + ω×τ).
   s: screw (v in m/s; ω in rad/s); c, co: coscrew (f in N; τ in N m).
   18 mul, 12 add.
   Error <= u |result| + (lin: 1, ang: 2) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_cross_sc(const ksl_screw_t *s, const ksl_coscrew_t *c, ksl_coscrew_t *co) {
  const double co_0 = KSL_MUL(s->m4, c->m2) - KSL_MUL(s->m5, c->m1),
      co_1 = KSL_MUL(s->m5, c->m0) - KSL_MUL(s->m3, c->m2),
      co_2 = KSL_MUL(s->m3, c->m1) - KSL_MUL(s->m4, c->m0),
      co_3 = KSL_MUL(s->m1, c->m2) - KSL_MUL(s->m2, c->m1)
          + (KSL_MUL(s->m4, c->m5) - KSL_MUL(s->m5, c->m4)),
      co_4 = KSL_MUL(s->m2, c->m0) - KSL_MUL(s->m0, c->m2)
          + (KSL_MUL(s->m5, c->m3) - KSL_MUL(s->m3, c->m5)),
      co_5 = KSL_MUL(s->m0, c->m1) - KSL_MUL(s->m1, c->m0)
          + (KSL_MUL(s->m3, c->m4) - KSL_MUL(s->m4, c->m3));
  co->m0 = co_0;
  co->m1 = co_1;
  co->m2 = co_2;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
}

/* co = (0 ; ω×τ).
   s: screw (v in m/s; ω in rad/s); c, co: coscrew (f in N; τ in N m).
   6 mul, 3 add.
   Error <= u |result| + (lin: 0, ang: 1) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_cross_sca(const ksl_screw_t *s, const ksl_coscrew_t *c, ksl_coscrew_t *co) {
  const double co_3 = KSL_MUL(s->m4, c->m5) - KSL_MUL(s->m5, c->m4),
      co_4 = KSL_MUL(s->m5, c->m3) - KSL_MUL(s->m3, c->m5),
      co_5 = KSL_MUL(s->m3, c->m4) - KSL_MUL(s->m4, c->m3);
  co->m0 = 0.0;
  co->m1 = 0.0;
  co->m2 = 0.0;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
}

/* co = H̄* c = [Ad]*(D) P c; P clears component 0 of c, given in the frame of a tx joint at D.
   D: displacement [R | t], R rotation, t in m; c, co: coscrew (f in N; τ in N m).
   21 mul, 15 add.
   Error <= u |result| + (lin: 1, ang: 4) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_constraint_ctx(const ksl_SE3_t *D, const ksl_coscrew_t *c,
    ksl_coscrew_t *co) {
  const double w_0 = KSL_MUL(D->m01, c->m1) + KSL_MUL(D->m02, c->m2),
      w_1 = KSL_MUL(D->m11, c->m1) + KSL_MUL(D->m12, c->m2),
      w_2 = KSL_MUL(D->m21, c->m1) + KSL_MUL(D->m22, c->m2),
      w_3 = KSL_MUL(D->m00, c->m3) + KSL_MUL(D->m01, c->m4) + KSL_MUL(D->m02, c->m5),
      w_4 = KSL_MUL(D->m10, c->m3) + KSL_MUL(D->m11, c->m4) + KSL_MUL(D->m12, c->m5),
      w_5 = KSL_MUL(D->m20, c->m3) + KSL_MUL(D->m21, c->m4) + KSL_MUL(D->m22, c->m5);
  const double co_3 = KSL_MUL(D->m13, w_2) - KSL_MUL(D->m23, w_1) + w_3,
      co_4 = KSL_MUL(D->m23, w_0) - KSL_MUL(D->m03, w_2) + w_4,
      co_5 = KSL_MUL(D->m03, w_1) - KSL_MUL(D->m13, w_0) + w_5;
  co->m0 = w_0;
  co->m1 = w_1;
  co->m2 = w_2;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
}

/* co = H̄* c = [Ad]*(D) P c; P clears component 1 of c, given in the frame of a ty joint at D.
   D: displacement [R | t], R rotation, t in m; c, co: coscrew (f in N; τ in N m).
   21 mul, 15 add.
   Error <= u |result| + (lin: 1, ang: 4) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_constraint_cty(const ksl_SE3_t *D, const ksl_coscrew_t *c,
    ksl_coscrew_t *co) {
  const double w_0 = KSL_MUL(D->m00, c->m0) + KSL_MUL(D->m02, c->m2),
      w_1 = KSL_MUL(D->m10, c->m0) + KSL_MUL(D->m12, c->m2),
      w_2 = KSL_MUL(D->m20, c->m0) + KSL_MUL(D->m22, c->m2),
      w_3 = KSL_MUL(D->m00, c->m3) + KSL_MUL(D->m01, c->m4) + KSL_MUL(D->m02, c->m5),
      w_4 = KSL_MUL(D->m10, c->m3) + KSL_MUL(D->m11, c->m4) + KSL_MUL(D->m12, c->m5),
      w_5 = KSL_MUL(D->m20, c->m3) + KSL_MUL(D->m21, c->m4) + KSL_MUL(D->m22, c->m5);
  const double co_3 = KSL_MUL(D->m13, w_2) - KSL_MUL(D->m23, w_1) + w_3,
      co_4 = KSL_MUL(D->m23, w_0) - KSL_MUL(D->m03, w_2) + w_4,
      co_5 = KSL_MUL(D->m03, w_1) - KSL_MUL(D->m13, w_0) + w_5;
  co->m0 = w_0;
  co->m1 = w_1;
  co->m2 = w_2;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
}

/* co = H̄* c = [Ad]*(D) P c; P clears component 2 of c, given in the frame of a tz joint at D.
   D: displacement [R | t], R rotation, t in m; c, co: coscrew (f in N; τ in N m).
   21 mul, 15 add.
   Error <= u |result| + (lin: 1, ang: 4) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_constraint_ctz(const ksl_SE3_t *D, const ksl_coscrew_t *c,
    ksl_coscrew_t *co) {
  const double w_0 = KSL_MUL(D->m00, c->m0) + KSL_MUL(D->m01, c->m1),
      w_1 = KSL_MUL(D->m10, c->m0) + KSL_MUL(D->m11, c->m1),
      w_2 = KSL_MUL(D->m20, c->m0) + KSL_MUL(D->m21, c->m1),
      w_3 = KSL_MUL(D->m00, c->m3) + KSL_MUL(D->m01, c->m4) + KSL_MUL(D->m02, c->m5),
      w_4 = KSL_MUL(D->m10, c->m3) + KSL_MUL(D->m11, c->m4) + KSL_MUL(D->m12, c->m5),
      w_5 = KSL_MUL(D->m20, c->m3) + KSL_MUL(D->m21, c->m4) + KSL_MUL(D->m22, c->m5);
  const double co_3 = KSL_MUL(D->m13, w_2) - KSL_MUL(D->m23, w_1) + w_3,
      co_4 = KSL_MUL(D->m23, w_0) - KSL_MUL(D->m03, w_2) + w_4,
      co_5 = KSL_MUL(D->m03, w_1) - KSL_MUL(D->m13, w_0) + w_5;
  co->m0 = w_0;
  co->m1 = w_1;
  co->m2 = w_2;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
}

/* co = H̄* c = [Ad]*(D) P c; P clears component 3 of c, given in the frame of a rx joint at D.
   D: displacement [R | t], R rotation, t in m; c, co: coscrew (f in N; τ in N m).
   21 mul, 15 add.
   Error <= u |result| + (lin: 2, ang: 5) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_constraint_crx(const ksl_SE3_t *D, const ksl_coscrew_t *c,
    ksl_coscrew_t *co) {
  const double w_0 = KSL_MUL(D->m00, c->m0) + KSL_MUL(D->m01, c->m1) + KSL_MUL(D->m02, c->m2),
      w_1 = KSL_MUL(D->m10, c->m0) + KSL_MUL(D->m11, c->m1) + KSL_MUL(D->m12, c->m2),
      w_2 = KSL_MUL(D->m20, c->m0) + KSL_MUL(D->m21, c->m1) + KSL_MUL(D->m22, c->m2),
      w_3 = KSL_MUL(D->m01, c->m4) + KSL_MUL(D->m02, c->m5),
      w_4 = KSL_MUL(D->m11, c->m4) + KSL_MUL(D->m12, c->m5),
      w_5 = KSL_MUL(D->m21, c->m4) + KSL_MUL(D->m22, c->m5);
  const double co_3 = KSL_MUL(D->m13, w_2) - KSL_MUL(D->m23, w_1) + w_3,
      co_4 = KSL_MUL(D->m23, w_0) - KSL_MUL(D->m03, w_2) + w_4,
      co_5 = KSL_MUL(D->m03, w_1) - KSL_MUL(D->m13, w_0) + w_5;
  co->m0 = w_0;
  co->m1 = w_1;
  co->m2 = w_2;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
}

/* co = H̄* c = [Ad]*(D) P c; P clears component 4 of c, given in the frame of a ry joint at D.
   D: displacement [R | t], R rotation, t in m; c, co: coscrew (f in N; τ in N m).
   21 mul, 15 add.
   Error <= u |result| + (lin: 2, ang: 5) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_constraint_cry(const ksl_SE3_t *D, const ksl_coscrew_t *c,
    ksl_coscrew_t *co) {
  const double w_0 = KSL_MUL(D->m00, c->m0) + KSL_MUL(D->m01, c->m1) + KSL_MUL(D->m02, c->m2),
      w_1 = KSL_MUL(D->m10, c->m0) + KSL_MUL(D->m11, c->m1) + KSL_MUL(D->m12, c->m2),
      w_2 = KSL_MUL(D->m20, c->m0) + KSL_MUL(D->m21, c->m1) + KSL_MUL(D->m22, c->m2),
      w_3 = KSL_MUL(D->m00, c->m3) + KSL_MUL(D->m02, c->m5),
      w_4 = KSL_MUL(D->m10, c->m3) + KSL_MUL(D->m12, c->m5),
      w_5 = KSL_MUL(D->m20, c->m3) + KSL_MUL(D->m22, c->m5);
  const double co_3 = KSL_MUL(D->m13, w_2) - KSL_MUL(D->m23, w_1) + w_3,
      co_4 = KSL_MUL(D->m23, w_0) - KSL_MUL(D->m03, w_2) + w_4,
      co_5 = KSL_MUL(D->m03, w_1) - KSL_MUL(D->m13, w_0) + w_5;
  co->m0 = w_0;
  co->m1 = w_1;
  co->m2 = w_2;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
}

/* co = H̄* c = [Ad]*(D) P c; P clears component 5 of c, given in the frame of a rz joint at D.
   D: displacement [R | t], R rotation, t in m; c, co: coscrew (f in N; τ in N m).
   21 mul, 15 add.
   Error <= u |result| + (lin: 2, ang: 5) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_constraint_crz(const ksl_SE3_t *D, const ksl_coscrew_t *c,
    ksl_coscrew_t *co) {
  const double w_0 = KSL_MUL(D->m00, c->m0) + KSL_MUL(D->m01, c->m1) + KSL_MUL(D->m02, c->m2),
      w_1 = KSL_MUL(D->m10, c->m0) + KSL_MUL(D->m11, c->m1) + KSL_MUL(D->m12, c->m2),
      w_2 = KSL_MUL(D->m20, c->m0) + KSL_MUL(D->m21, c->m1) + KSL_MUL(D->m22, c->m2),
      w_3 = KSL_MUL(D->m00, c->m3) + KSL_MUL(D->m01, c->m4),
      w_4 = KSL_MUL(D->m10, c->m3) + KSL_MUL(D->m11, c->m4),
      w_5 = KSL_MUL(D->m20, c->m3) + KSL_MUL(D->m21, c->m4);
  const double co_3 = KSL_MUL(D->m13, w_2) - KSL_MUL(D->m23, w_1) + w_3,
      co_4 = KSL_MUL(D->m23, w_0) - KSL_MUL(D->m03, w_2) + w_4,
      co_5 = KSL_MUL(D->m03, w_1) - KSL_MUL(D->m13, w_0) + w_5;
  co->m0 = w_0;
  co->m1 = w_1;
  co->m2 = w_2;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
}

/* co = h̄* c = [Ad]*(D) P c; P keeps component 0 of c, given in the frame of a tx joint at D.
   D: displacement [R | t], R rotation, t in m; c, co: coscrew (f in N; τ in N m).
   9 mul, 3 add.
   Error <= u |result| + (lin: 0, ang: 2) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_working_ctx(const ksl_SE3_t *D, const ksl_coscrew_t *c, ksl_coscrew_t *co) {
  const double w_0 = KSL_MUL(D->m00, c->m0), w_1 = KSL_MUL(D->m10, c->m0),
      w_2 = KSL_MUL(D->m20, c->m0);
  const double co_3 = KSL_MUL(D->m13, w_2) - KSL_MUL(D->m23, w_1),
      co_4 = KSL_MUL(D->m23, w_0) - KSL_MUL(D->m03, w_2),
      co_5 = KSL_MUL(D->m03, w_1) - KSL_MUL(D->m13, w_0);
  co->m0 = w_0;
  co->m1 = w_1;
  co->m2 = w_2;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
}

/* co = h̄* c = [Ad]*(D) P c; P keeps component 1 of c, given in the frame of a ty joint at D.
   D: displacement [R | t], R rotation, t in m; c, co: coscrew (f in N; τ in N m).
   9 mul, 3 add.
   Error <= u |result| + (lin: 0, ang: 2) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_working_cty(const ksl_SE3_t *D, const ksl_coscrew_t *c, ksl_coscrew_t *co) {
  const double w_0 = KSL_MUL(D->m01, c->m1), w_1 = KSL_MUL(D->m11, c->m1),
      w_2 = KSL_MUL(D->m21, c->m1);
  const double co_3 = KSL_MUL(D->m13, w_2) - KSL_MUL(D->m23, w_1),
      co_4 = KSL_MUL(D->m23, w_0) - KSL_MUL(D->m03, w_2),
      co_5 = KSL_MUL(D->m03, w_1) - KSL_MUL(D->m13, w_0);
  co->m0 = w_0;
  co->m1 = w_1;
  co->m2 = w_2;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
}

/* co = h̄* c = [Ad]*(D) P c; P keeps component 2 of c, given in the frame of a tz joint at D.
   D: displacement [R | t], R rotation, t in m; c, co: coscrew (f in N; τ in N m).
   9 mul, 3 add.
   Error <= u |result| + (lin: 0, ang: 2) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_working_ctz(const ksl_SE3_t *D, const ksl_coscrew_t *c, ksl_coscrew_t *co) {
  const double w_0 = KSL_MUL(D->m02, c->m2), w_1 = KSL_MUL(D->m12, c->m2),
      w_2 = KSL_MUL(D->m22, c->m2);
  const double co_3 = KSL_MUL(D->m13, w_2) - KSL_MUL(D->m23, w_1),
      co_4 = KSL_MUL(D->m23, w_0) - KSL_MUL(D->m03, w_2),
      co_5 = KSL_MUL(D->m03, w_1) - KSL_MUL(D->m13, w_0);
  co->m0 = w_0;
  co->m1 = w_1;
  co->m2 = w_2;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
}

/* co = h̄* c = [Ad]*(D) P c; P keeps component 3 of c, given in the frame of a rx joint at D.
   D: displacement [R | t], R rotation, t in m; c, co: coscrew (f in N; τ in N m).
   3 mul.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_working_crx(const ksl_SE3_t *D, const ksl_coscrew_t *c, ksl_coscrew_t *co) {
  const double w_3 = KSL_MUL(D->m00, c->m3), w_4 = KSL_MUL(D->m10, c->m3),
      w_5 = KSL_MUL(D->m20, c->m3);
  co->m0 = 0.0;
  co->m1 = 0.0;
  co->m2 = 0.0;
  co->m3 = w_3;
  co->m4 = w_4;
  co->m5 = w_5;
}

/* co = h̄* c = [Ad]*(D) P c; P keeps component 4 of c, given in the frame of a ry joint at D.
   D: displacement [R | t], R rotation, t in m; c, co: coscrew (f in N; τ in N m).
   3 mul.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_working_cry(const ksl_SE3_t *D, const ksl_coscrew_t *c, ksl_coscrew_t *co) {
  const double w_3 = KSL_MUL(D->m01, c->m4), w_4 = KSL_MUL(D->m11, c->m4),
      w_5 = KSL_MUL(D->m21, c->m4);
  co->m0 = 0.0;
  co->m1 = 0.0;
  co->m2 = 0.0;
  co->m3 = w_3;
  co->m4 = w_4;
  co->m5 = w_5;
}

/* co = h̄* c = [Ad]*(D) P c; P keeps component 5 of c, given in the frame of a rz joint at D.
   D: displacement [R | t], R rotation, t in m; c, co: coscrew (f in N; τ in N m).
   3 mul.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_working_crz(const ksl_SE3_t *D, const ksl_coscrew_t *c, ksl_coscrew_t *co) {
  const double w_3 = KSL_MUL(D->m02, c->m5), w_4 = KSL_MUL(D->m12, c->m5),
      w_5 = KSL_MUL(D->m22, c->m5);
  co->m0 = 0.0;
  co->m1 = 0.0;
  co->m2 = 0.0;
  co->m3 = w_3;
  co->m4 = w_4;
  co->m5 = w_5;
}

/* M = [ad]*(s) = [Ad]*' [Ad]*^-1 = [[ω~, 0], [v~, ω~]].
   s: screw (v in m/s; ω in rad/s); M: 6×6 operator.
   6 neg.
   Exact. */
static inline void ksl_coad(const ksl_screw_t *s, ksl_mat6x6_t *M) {
  const double M_01 = -s->m5, M_12 = -s->m3, M_20 = -s->m4, M_31 = -s->m2, M_42 = -s->m0,
      M_50 = -s->m1;
  const double s_m4 = s->m4;
  const double s_m5 = s->m5;
  const double s_m3 = s->m3;
  const double s_m1 = s->m1;
  const double s_m2 = s->m2;
  const double s_m0 = s->m0;
  M->at[0][0] = 0.0;
  M->at[1][0] = M_01;
  M->at[2][0] = s_m4;
  M->at[3][0] = 0.0;
  M->at[4][0] = 0.0;
  M->at[5][0] = 0.0;
  M->at[0][1] = s_m5;
  M->at[1][1] = 0.0;
  M->at[2][1] = M_12;
  M->at[3][1] = 0.0;
  M->at[4][1] = 0.0;
  M->at[5][1] = 0.0;
  M->at[0][2] = M_20;
  M->at[1][2] = s_m3;
  M->at[2][2] = 0.0;
  M->at[3][2] = 0.0;
  M->at[4][2] = 0.0;
  M->at[5][2] = 0.0;
  M->at[0][3] = 0.0;
  M->at[1][3] = M_31;
  M->at[2][3] = s_m1;
  M->at[3][3] = 0.0;
  M->at[4][3] = M_01;
  M->at[5][3] = s_m4;
  M->at[0][4] = s_m2;
  M->at[1][4] = 0.0;
  M->at[2][4] = M_42;
  M->at[3][4] = s_m5;
  M->at[4][4] = 0.0;
  M->at[5][4] = M_12;
  M->at[0][5] = M_50;
  M->at[1][5] = s_m0;
  M->at[2][5] = 0.0;
  M->at[3][5] = M_20;
  M->at[4][5] = s_m3;
  M->at[5][5] = 0.0;
}

/* The coscrew of these entries, in order. */
static inline ksl_coscrewf_t ksl_coscrewf(const float m0, const float m1, const float m2,
    const float m3, const float m4, const float m5) {
  ksl_coscrewf_t value;
  value.m0 = m0;
  value.m1 = m1;
  value.m2 = m2;
  value.m3 = m3;
  value.m4 = m4;
  value.m5 = m5;
  return value;
}

/* co = ci.
   ci, co: coscrew (f in N; τ in N m).
   No arithmetic.
   Exact. */
static inline void ksl_coscrewf_copy(const ksl_coscrewf_t *ci, ksl_coscrewf_t *co) {
  const float ci_m0 = ci->m0;
  const float ci_m1 = ci->m1;
  const float ci_m2 = ci->m2;
  const float ci_m3 = ci->m3;
  const float ci_m4 = ci->m4;
  const float ci_m5 = ci->m5;
  co->m0 = ci_m0;
  co->m1 = ci_m1;
  co->m2 = ci_m2;
  co->m3 = ci_m3;
  co->m4 = ci_m4;
  co->m5 = ci_m5;
}

/* self = a self.
   self: coscrew (f in N; τ in N m); a: number.
   6 mul.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_coscrewf_scale(ksl_coscrewf_t *self, const float a) {
  const float self_0_new = KSL_MULF(self->m0, a), self_1_new = KSL_MULF(self->m1, a),
      self_2_new = KSL_MULF(self->m2, a), self_3_new = KSL_MULF(self->m3, a),
      self_4_new = KSL_MULF(self->m4, a), self_5_new = KSL_MULF(self->m5, a);
  self->m0 = self_0_new;
  self->m1 = self_1_new;
  self->m2 = self_2_new;
  self->m3 = self_3_new;
  self->m4 = self_4_new;
  self->m5 = self_5_new;
}

/* co = -ci.
   ci, co: coscrew (f in N; τ in N m).
   6 neg.
   Exact. */
static inline void ksl_coscrewf_inverted(const ksl_coscrewf_t *ci, ksl_coscrewf_t *co) {
  const float co_0 = -ci->m0, co_1 = -ci->m1, co_2 = -ci->m2, co_3 = -ci->m3, co_4 = -ci->m4,
      co_5 = -ci->m5;
  co->m0 = co_0;
  co->m1 = co_1;
  co->m2 = co_2;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
}

/* self = -self.
   self: coscrew (f in N; τ in N m).
   6 neg.
   Exact. */
static inline void ksl_coscrewf_invert(ksl_coscrewf_t *self) {
  const float self_0_new = -self->m0, self_1_new = -self->m1, self_2_new = -self->m2,
      self_3_new = -self->m3, self_4_new = -self->m4, self_5_new = -self->m5;
  self->m0 = self_0_new;
  self->m1 = self_1_new;
  self->m2 = self_2_new;
  self->m3 = self_3_new;
  self->m4 = self_4_new;
  self->m5 = self_5_new;
}

/* y = a x + y.
   a: number; x, y: coscrew (f in N; τ in N m).
   6 mul, 6 add.
   Error <= u |result| + 1 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_axpy_ccf(const float a, const ksl_coscrewf_t *x, ksl_coscrewf_t *y) {
  const float y_0_new = KSL_MULF(a, x->m0) + y->m0, y_1_new = KSL_MULF(a, x->m1) + y->m1,
      y_2_new = KSL_MULF(a, x->m2) + y->m2, y_3_new = KSL_MULF(a, x->m3) + y->m3,
      y_4_new = KSL_MULF(a, x->m4) + y->m4, y_5_new = KSL_MULF(a, x->m5) + y->m5;
  y->m0 = y_0_new;
  y->m1 = y_1_new;
  y->m2 = y_2_new;
  y->m3 = y_3_new;
  y->m4 = y_4_new;
  y->m5 = y_5_new;
}

/* y = x + y.
   x, y: coscrew (f in N; τ in N m).
   6 add.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_xpy_ccf(const ksl_coscrewf_t *x, ksl_coscrewf_t *y) {
  const float y_0_new = x->m0 + y->m0, y_1_new = x->m1 + y->m1, y_2_new = x->m2 + y->m2,
      y_3_new = x->m3 + y->m3, y_4_new = x->m4 + y->m4, y_5_new = x->m5 + y->m5;
  y->m0 = y_0_new;
  y->m1 = y_1_new;
  y->m2 = y_2_new;
  y->m3 = y_3_new;
  y->m4 = y_4_new;
  y->m5 = y_5_new;
}

/* y = -x + y.
   x, y: coscrew (f in N; τ in N m).
   6 add.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_nxpy_ccf(const ksl_coscrewf_t *x, ksl_coscrewf_t *y) {
  const float y_0_new = y->m0 - x->m0, y_1_new = y->m1 - x->m1, y_2_new = y->m2 - x->m2,
      y_3_new = y->m3 - x->m3, y_4_new = y->m4 - x->m4, y_5_new = y->m5 - x->m5;
  y->m0 = y_0_new;
  y->m1 = y_1_new;
  y->m2 = y_2_new;
  y->m3 = y_3_new;
  y->m4 = y_4_new;
  y->m5 = y_5_new;
}

/* co = a ci.
   a: number; ci, co: coscrew (f in N; τ in N m).
   6 mul.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_product_acf(const float a, const ksl_coscrewf_t *ci, ksl_coscrewf_t *co) {
  const float co_0 = KSL_MULF(a, ci->m0), co_1 = KSL_MULF(a, ci->m1), co_2 = KSL_MULF(a, ci->m2),
      co_3 = KSL_MULF(a, ci->m3), co_4 = KSL_MULF(a, ci->m4), co_5 = KSL_MULF(a, ci->m5);
  co->m0 = co_0;
  co->m1 = co_1;
  co->m2 = co_2;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
}

/* co = c1 + c2.
   c1, c2, co: coscrew (f in N; τ in N m).
   6 add.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_add_ccf(const ksl_coscrewf_t *c1, const ksl_coscrewf_t *c2,
    ksl_coscrewf_t *co) {
  const float co_0 = c1->m0 + c2->m0, co_1 = c1->m1 + c2->m1, co_2 = c1->m2 + c2->m2,
      co_3 = c1->m3 + c2->m3, co_4 = c1->m4 + c2->m4, co_5 = c1->m5 + c2->m5;
  co->m0 = co_0;
  co->m1 = co_1;
  co->m2 = co_2;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
}

/* co = c1 - c2.
   c1, c2, co: coscrew (f in N; τ in N m).
   6 add.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_subtract_ccf(const ksl_coscrewf_t *c1, const ksl_coscrewf_t *c2,
    ksl_coscrewf_t *co) {
  const float co_0 = c1->m0 - c2->m0, co_1 = c1->m1 - c2->m1, co_2 = c1->m2 - c2->m2,
      co_3 = c1->m3 - c2->m3, co_4 = c1->m4 - c2->m4, co_5 = c1->m5 - c2->m5;
  co->m0 = co_0;
  co->m1 = co_1;
  co->m2 = co_2;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
}

/* |ci|: |f|, or |τ| where every |f_i| is below 1e-9 (single: 1e-6).
   ci: coscrew (f in N; τ in N m).
   7 mul, 2 add, 1 sqrt, 6 abs, 11 less, 1 equal, 14 select. */
static inline float ksl_coscrewf_norm(const ksl_coscrewf_t *ci) {
  const float small_c = fabsf(ci->m2) < 1e-06f ? 1.0f : 0.0f,
      small_f = fabsf(ci->m1) < 1e-06f ? small_c : 0.0f,
      small = fabsf(ci->m0) < 1e-06f ? small_f : 0.0f;
  const float p_0 = small == 1.0f ? ci->m3 : ci->m0, p_1 = small == 1.0f ? ci->m4 : ci->m1,
      p_2 = small == 1.0f ? ci->m5 : ci->m2;
  const float s_size_0 = fabsf(p_0), s_size_1 = fabsf(p_1), s_size_2 = fabsf(p_2);
  const float s_largest1 = s_size_0 < s_size_1 ? s_size_1 : s_size_0;
  const float s_largest2 = s_largest1 < s_size_2 ? s_size_2 : s_largest1;
  const float s_b = 4.611686e+18f < s_largest2 ? 2.7105054e-20f : 1.0f,
      s_d = s_largest2 < 256.0f ? 1.8014399e+16f : s_b,
      s = s_largest2 < 1.4210855e-14f ? 3.2451855e+32f : s_d;
  const float y_0 = KSL_MULF(p_0, s), y_1 = KSL_MULF(p_1, s), y_2 = KSL_MULF(p_2, s);
  const float n = sqrtf(KSL_MULF(y_0, y_0) + KSL_MULF(y_1, y_1) + KSL_MULF(y_2, y_2));
  const float r_b = s < 1.0f ? 3.689349e+19f : 1.0f, r_d = 1.0f < s ? 5.551115e-17f : r_b,
      r = 1.8014399e+16f < s ? 3.081488e-33f : r_d;
  const float norm = KSL_MULF(n, r);
  return norm;
}

/* self = self / |self|, with coscrew_norm; the zero coscrew stays zero.
   self: coscrew (f in N; τ in N m).
   18 mul, 2 add, 6 div, 1 sqrt, 9 abs, 16 less, 2 equal, 26 select. */
static inline void ksl_coscrewf_normalize(ksl_coscrewf_t *self) {
  const float small_a = fabsf(self->m2), small_c = small_a < 1e-06f ? 1.0f : 0.0f,
      small_d = fabsf(self->m1), small_f = small_d < 1e-06f ? small_c : 0.0f,
      small_g = fabsf(self->m0), small = small_g < 1e-06f ? small_f : 0.0f;
  const float p_0 = small == 1.0f ? self->m3 : self->m0, p_1 = small == 1.0f ? self->m4 : self->m1,
      p_2 = small == 1.0f ? self->m5 : self->m2;
  const float s_size_0 = fabsf(p_0), s_size_1 = fabsf(p_1), s_size_2 = fabsf(p_2);
  const float s_largest1 = s_size_0 < s_size_1 ? s_size_1 : s_size_0;
  const float s_largest2 = s_largest1 < s_size_2 ? s_size_2 : s_largest1;
  const float s_b = 4.611686e+18f < s_largest2 ? 2.7105054e-20f : 1.0f,
      s_d = s_largest2 < 256.0f ? 1.8014399e+16f : s_b,
      s = s_largest2 < 1.4210855e-14f ? 3.2451855e+32f : s_d;
  const float y_0 = KSL_MULF(p_0, s), y_1 = KSL_MULF(p_1, s), y_2 = KSL_MULF(p_2, s);
  const float up = 1.0f < s ? s : 1.0f;
  const float down = s < 1.0f ? s : 1.0f;
  const float n = sqrtf(KSL_MULF(y_0, y_0) + KSL_MULF(y_1, y_1) + KSL_MULF(y_2, y_2));
  const float divisor = n == 0.0f ? up : n;
  const float size_3 = fabsf(self->m3), size_4 = fabsf(self->m4), size_5 = fabsf(self->m5);
  const float before_0 = small_g < 256.0f ? up : down, before_1 = small_d < 256.0f ? up : down,
      before_2 = small_a < 256.0f ? up : down, before_3 = size_3 < 256.0f ? up : down,
      before_4 = size_4 < 256.0f ? up : down, before_5 = size_5 < 256.0f ? up : down;
  const float after_0 = small_g < 256.0f ? down : up, after_1 = small_d < 256.0f ? down : up,
      after_2 = small_a < 256.0f ? down : up, after_3 = size_3 < 256.0f ? down : up,
      after_4 = size_4 < 256.0f ? down : up, after_5 = size_5 < 256.0f ? down : up;
  const float sized_0 = KSL_MULF(self->m0, before_0), sized_1 = KSL_MULF(self->m1, before_1),
      sized_2 = KSL_MULF(self->m2, before_2), sized_3 = KSL_MULF(self->m3, before_3),
      sized_4 = KSL_MULF(self->m4, before_4), sized_5 = KSL_MULF(self->m5, before_5);
  const float quotient_0 = sized_0 / divisor, quotient_1 = sized_1 / divisor,
      quotient_2 = sized_2 / divisor, quotient_3 = sized_3 / divisor,
      quotient_4 = sized_4 / divisor, quotient_5 = sized_5 / divisor;
  const float self_0_new = KSL_MULF(quotient_0, after_0),
      self_1_new = KSL_MULF(quotient_1, after_1), self_2_new = KSL_MULF(quotient_2, after_2),
      self_3_new = KSL_MULF(quotient_3, after_3), self_4_new = KSL_MULF(quotient_4, after_4),
      self_5_new = KSL_MULF(quotient_5, after_5);
  self->m0 = self_0_new;
  self->m1 = self_1_new;
  self->m2 = self_2_new;
  self->m3 = self_3_new;
  self->m4 = self_4_new;
  self->m5 = self_5_new;
}

/* co = ci / |ci|, with coscrew_norm; the zero coscrew stays zero.
   ci, co: coscrew (f in N; τ in N m).
   18 mul, 2 add, 6 div, 1 sqrt, 9 abs, 16 less, 2 equal, 26 select. */
static inline void ksl_coscrewf_normalized(const ksl_coscrewf_t *ci, ksl_coscrewf_t *co) {
  const float small_a = fabsf(ci->m2), small_c = small_a < 1e-06f ? 1.0f : 0.0f,
      small_d = fabsf(ci->m1), small_f = small_d < 1e-06f ? small_c : 0.0f, small_g = fabsf(ci->m0),
      small = small_g < 1e-06f ? small_f : 0.0f;
  const float p_0 = small == 1.0f ? ci->m3 : ci->m0, p_1 = small == 1.0f ? ci->m4 : ci->m1,
      p_2 = small == 1.0f ? ci->m5 : ci->m2;
  const float s_size_0 = fabsf(p_0), s_size_1 = fabsf(p_1), s_size_2 = fabsf(p_2);
  const float s_largest1 = s_size_0 < s_size_1 ? s_size_1 : s_size_0;
  const float s_largest2 = s_largest1 < s_size_2 ? s_size_2 : s_largest1;
  const float s_b = 4.611686e+18f < s_largest2 ? 2.7105054e-20f : 1.0f,
      s_d = s_largest2 < 256.0f ? 1.8014399e+16f : s_b,
      s = s_largest2 < 1.4210855e-14f ? 3.2451855e+32f : s_d;
  const float y_0 = KSL_MULF(p_0, s), y_1 = KSL_MULF(p_1, s), y_2 = KSL_MULF(p_2, s);
  const float up = 1.0f < s ? s : 1.0f;
  const float down = s < 1.0f ? s : 1.0f;
  const float n = sqrtf(KSL_MULF(y_0, y_0) + KSL_MULF(y_1, y_1) + KSL_MULF(y_2, y_2));
  const float divisor = n == 0.0f ? up : n;
  const float size_3 = fabsf(ci->m3), size_4 = fabsf(ci->m4), size_5 = fabsf(ci->m5);
  const float before_0 = small_g < 256.0f ? up : down, before_1 = small_d < 256.0f ? up : down,
      before_2 = small_a < 256.0f ? up : down, before_3 = size_3 < 256.0f ? up : down,
      before_4 = size_4 < 256.0f ? up : down, before_5 = size_5 < 256.0f ? up : down;
  const float after_0 = small_g < 256.0f ? down : up, after_1 = small_d < 256.0f ? down : up,
      after_2 = small_a < 256.0f ? down : up, after_3 = size_3 < 256.0f ? down : up,
      after_4 = size_4 < 256.0f ? down : up, after_5 = size_5 < 256.0f ? down : up;
  const float sized_0 = KSL_MULF(ci->m0, before_0), sized_1 = KSL_MULF(ci->m1, before_1),
      sized_2 = KSL_MULF(ci->m2, before_2), sized_3 = KSL_MULF(ci->m3, before_3),
      sized_4 = KSL_MULF(ci->m4, before_4), sized_5 = KSL_MULF(ci->m5, before_5);
  const float quotient_0 = sized_0 / divisor, quotient_1 = sized_1 / divisor,
      quotient_2 = sized_2 / divisor, quotient_3 = sized_3 / divisor,
      quotient_4 = sized_4 / divisor, quotient_5 = sized_5 / divisor;
  const float co_0 = KSL_MULF(quotient_0, after_0), co_1 = KSL_MULF(quotient_1, after_1),
      co_2 = KSL_MULF(quotient_2, after_2), co_3 = KSL_MULF(quotient_3, after_3),
      co_4 = KSL_MULF(quotient_4, after_4), co_5 = KSL_MULF(quotient_5, after_5);
  co->m0 = co_0;
  co->m1 = co_1;
  co->m2 = co_2;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
}

/* co = (lin; ang).
   lin, ang: vector; co: coscrew (f in N; τ in N m).
   No arithmetic.
   Exact. */
static inline void ksl_coscrewf_from_lin_ang(const ksl_vec3f_t *lin, const ksl_vec3f_t *ang,
    ksl_coscrewf_t *co) {
  const float lin_x = lin->x;
  const float lin_y = lin->y;
  const float lin_z = lin->z;
  const float ang_x = ang->x;
  const float ang_y = ang->y;
  const float ang_z = ang->z;
  co->m0 = lin_x;
  co->m1 = lin_y;
  co->m2 = lin_z;
  co->m3 = ang_x;
  co->m4 = ang_y;
  co->m5 = ang_z;
}

/* x = (ang; lin) of ci.
   ci: coscrew (f in N; τ in N m); x: six components with the angular part on top.
   No arithmetic.
   Exact. */
static inline void ksl_coscrewf_to_angular_first(const ksl_coscrewf_t *ci, float x[6]) {
  const float ci_m3 = ci->m3;
  const float ci_m4 = ci->m4;
  const float ci_m5 = ci->m5;
  const float ci_m0 = ci->m0;
  const float ci_m1 = ci->m1;
  const float ci_m2 = ci->m2;
  x[0] = ci_m3;
  x[1] = ci_m4;
  x[2] = ci_m5;
  x[3] = ci_m0;
  x[4] = ci_m1;
  x[5] = ci_m2;
}

/* co = (lin; ang) of x = (ang; lin).
   x: six components with the angular part on top; co: coscrew (f in N; τ in N m).
   No arithmetic.
   Exact. */
static inline void ksl_coscrewf_from_angular_first(const float x[6], ksl_coscrewf_t *co) {
  const float x_3 = x[3];
  const float x_4 = x[4];
  const float x_5 = x[5];
  const float x_0 = x[0];
  const float x_1 = x[1];
  const float x_2 = x[2];
  co->m0 = x_3;
  co->m1 = x_4;
  co->m2 = x_5;
  co->m3 = x_0;
  co->m4 = x_1;
  co->m5 = x_2;
}

/* co = (c1.lin + c2.lin ; c1.ang).
   c1, c2, co: coscrew (f in N; τ in N m).
   3 add.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_add_cctf(const ksl_coscrewf_t *c1, const ksl_coscrewf_t *c2,
    ksl_coscrewf_t *co) {
  const float co_0 = c1->m0 + c2->m0, co_1 = c1->m1 + c2->m1, co_2 = c1->m2 + c2->m2;
  const float c1_m3 = c1->m3;
  const float c1_m4 = c1->m4;
  const float c1_m5 = c1->m5;
  co->m0 = co_0;
  co->m1 = co_1;
  co->m2 = co_2;
  co->m3 = c1_m3;
  co->m4 = c1_m4;
  co->m5 = c1_m5;
}

/* co = [Ad]*(t) ci.
   t: vector; ci, co: coscrew (f in N; τ in N m).
   6 mul, 6 add.
   Error <= u |result| + (lin: 0, ang: 2) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_CoAdtcf(const ksl_vec3f_t *t, const ksl_coscrewf_t *ci,
    ksl_coscrewf_t *co) {
  const float co_3 = KSL_MULF(t->y, ci->m2) - KSL_MULF(t->z, ci->m1) + ci->m3,
      co_4 = KSL_MULF(t->z, ci->m0) - KSL_MULF(t->x, ci->m2) + ci->m4,
      co_5 = KSL_MULF(t->x, ci->m1) - KSL_MULF(t->y, ci->m0) + ci->m5;
  const float ci_m0 = ci->m0;
  const float ci_m1 = ci->m1;
  const float ci_m2 = ci->m2;
  co->m0 = ci_m0;
  co->m1 = ci_m1;
  co->m2 = ci_m2;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
}

/* co = [Ad]*(t)^-1 ci.
   t: vector; ci, co: coscrew (f in N; τ in N m).
   6 mul, 6 add.
   Error <= u |result| + (lin: 0, ang: 2) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_CoAdtinvcf(const ksl_vec3f_t *t, const ksl_coscrewf_t *ci,
    ksl_coscrewf_t *co) {
  const float co_3 = KSL_MULF(t->z, ci->m1) - KSL_MULF(t->y, ci->m2) + ci->m3,
      co_4 = KSL_MULF(t->x, ci->m2) - KSL_MULF(t->z, ci->m0) + ci->m4,
      co_5 = KSL_MULF(t->y, ci->m0) - KSL_MULF(t->x, ci->m1) + ci->m5;
  const float ci_m0 = ci->m0;
  const float ci_m1 = ci->m1;
  const float ci_m2 = ci->m2;
  co->m0 = ci_m0;
  co->m1 = ci_m1;
  co->m2 = ci_m2;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
}

/* co = [Ad]*(t) (-ci).
   t: vector; ci, co: coscrew (f in N; τ in N m).
   6 mul, 6 add, 3 neg.
   Error <= u |result| + (lin: 0, ang: 2) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_CoAdtcinvf(const ksl_vec3f_t *t, const ksl_coscrewf_t *ci,
    ksl_coscrewf_t *co) {
  const float co_0 = -ci->m0, co_1 = -ci->m1, co_2 = -ci->m2,
      co_3 = KSL_MULF(t->z, ci->m1) - KSL_MULF(t->y, ci->m2) - ci->m3,
      co_4 = KSL_MULF(t->x, ci->m2) - KSL_MULF(t->z, ci->m0) - ci->m4,
      co_5 = KSL_MULF(t->y, ci->m0) - KSL_MULF(t->x, ci->m1) - ci->m5;
  co->m0 = co_0;
  co->m1 = co_1;
  co->m2 = co_2;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
}

/* co = [Ad]*(R) ci.
   R: rotation or other 3×3 matrix; ci, co: coscrew (f in N; τ in N m).
   18 mul, 12 add.
   Error <= u |result| + 2 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_product_CoAdrcf(const ksl_mat3x3f_t *R, const ksl_coscrewf_t *ci,
    ksl_coscrewf_t *co) {
  const float co_0 = KSL_MULF(R->m00, ci->m0) + KSL_MULF(R->m01, ci->m1) + KSL_MULF(R->m02, ci->m2),
      co_1 = KSL_MULF(R->m10, ci->m0) + KSL_MULF(R->m11, ci->m1) + KSL_MULF(R->m12, ci->m2),
      co_2 = KSL_MULF(R->m20, ci->m0) + KSL_MULF(R->m21, ci->m1) + KSL_MULF(R->m22, ci->m2),
      co_3 = KSL_MULF(R->m00, ci->m3) + KSL_MULF(R->m01, ci->m4) + KSL_MULF(R->m02, ci->m5),
      co_4 = KSL_MULF(R->m10, ci->m3) + KSL_MULF(R->m11, ci->m4) + KSL_MULF(R->m12, ci->m5),
      co_5 = KSL_MULF(R->m20, ci->m3) + KSL_MULF(R->m21, ci->m4) + KSL_MULF(R->m22, ci->m5);
  co->m0 = co_0;
  co->m1 = co_1;
  co->m2 = co_2;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
}

/* co = [Ad]*(R)^-1 ci.
   R: rotation or other 3×3 matrix; ci, co: coscrew (f in N; τ in N m).
   18 mul, 12 add.
   Error <= u |result| + 2 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_product_CoAdrinvcf(const ksl_mat3x3f_t *R, const ksl_coscrewf_t *ci,
    ksl_coscrewf_t *co) {
  const float co_0 = KSL_MULF(R->m00, ci->m0) + KSL_MULF(R->m10, ci->m1) + KSL_MULF(R->m20, ci->m2),
      co_1 = KSL_MULF(R->m01, ci->m0) + KSL_MULF(R->m11, ci->m1) + KSL_MULF(R->m21, ci->m2),
      co_2 = KSL_MULF(R->m02, ci->m0) + KSL_MULF(R->m12, ci->m1) + KSL_MULF(R->m22, ci->m2),
      co_3 = KSL_MULF(R->m00, ci->m3) + KSL_MULF(R->m10, ci->m4) + KSL_MULF(R->m20, ci->m5),
      co_4 = KSL_MULF(R->m01, ci->m3) + KSL_MULF(R->m11, ci->m4) + KSL_MULF(R->m21, ci->m5),
      co_5 = KSL_MULF(R->m02, ci->m3) + KSL_MULF(R->m12, ci->m4) + KSL_MULF(R->m22, ci->m5);
  co->m0 = co_0;
  co->m1 = co_1;
  co->m2 = co_2;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
}

/* co = [Ad]*(R) (-ci).
   R: rotation or other 3×3 matrix; ci, co: coscrew (f in N; τ in N m).
   18 mul, 12 add, 6 neg.
   Error <= u |result| + 2 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_product_CoAdrcinvf(const ksl_mat3x3f_t *R, const ksl_coscrewf_t *ci,
    ksl_coscrewf_t *co) {
  const float co_0 =
          -(KSL_MULF(R->m00, ci->m0) + KSL_MULF(R->m01, ci->m1) + KSL_MULF(R->m02, ci->m2)),
      co_1 = -(KSL_MULF(R->m10, ci->m0) + KSL_MULF(R->m11, ci->m1) + KSL_MULF(R->m12, ci->m2)),
      co_2 = -(KSL_MULF(R->m20, ci->m0) + KSL_MULF(R->m21, ci->m1) + KSL_MULF(R->m22, ci->m2)),
      co_3 = -(KSL_MULF(R->m00, ci->m3) + KSL_MULF(R->m01, ci->m4) + KSL_MULF(R->m02, ci->m5)),
      co_4 = -(KSL_MULF(R->m10, ci->m3) + KSL_MULF(R->m11, ci->m4) + KSL_MULF(R->m12, ci->m5)),
      co_5 = -(KSL_MULF(R->m20, ci->m3) + KSL_MULF(R->m21, ci->m4) + KSL_MULF(R->m22, ci->m5));
  co->m0 = co_0;
  co->m1 = co_1;
  co->m2 = co_2;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
}

/* co = [Ad]*(D) ci = [Ad]*(t) [Ad]*(R) ci.
   D: displacement [R | t], R rotation, t in m; ci, co: coscrew (f in N; τ in N m).
   24 mul, 18 add.
   Error <= u |result| + (lin: 2, ang: 5) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_CoAdcf(const ksl_SE3f_t *D, const ksl_coscrewf_t *ci,
    ksl_coscrewf_t *co) {
  const float w_0 = KSL_MULF(D->m00, ci->m0) + KSL_MULF(D->m01, ci->m1) + KSL_MULF(D->m02, ci->m2),
      w_1 = KSL_MULF(D->m10, ci->m0) + KSL_MULF(D->m11, ci->m1) + KSL_MULF(D->m12, ci->m2),
      w_2 = KSL_MULF(D->m20, ci->m0) + KSL_MULF(D->m21, ci->m1) + KSL_MULF(D->m22, ci->m2),
      w_3 = KSL_MULF(D->m00, ci->m3) + KSL_MULF(D->m01, ci->m4) + KSL_MULF(D->m02, ci->m5),
      w_4 = KSL_MULF(D->m10, ci->m3) + KSL_MULF(D->m11, ci->m4) + KSL_MULF(D->m12, ci->m5),
      w_5 = KSL_MULF(D->m20, ci->m3) + KSL_MULF(D->m21, ci->m4) + KSL_MULF(D->m22, ci->m5);
  const float co_3 = KSL_MULF(D->m13, w_2) - KSL_MULF(D->m23, w_1) + w_3,
      co_4 = KSL_MULF(D->m23, w_0) - KSL_MULF(D->m03, w_2) + w_4,
      co_5 = KSL_MULF(D->m03, w_1) - KSL_MULF(D->m13, w_0) + w_5;
  co->m0 = w_0;
  co->m1 = w_1;
  co->m2 = w_2;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
}

/* co = [Ad]*(D)^-1 ci = [Ad]*(R^T) [Ad]*(-t) ci.
   D: displacement [R | t], R rotation, t in m; ci, co: coscrew (f in N; τ in N m).
   24 mul, 18 add.
   Error <= u |result| + (lin: 2, ang: 5) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_CoAdinvcf(const ksl_SE3f_t *D, const ksl_coscrewf_t *ci,
    ksl_coscrewf_t *co) {
  const float w_3 = KSL_MULF(D->m23, ci->m1) - KSL_MULF(D->m13, ci->m2) + ci->m3,
      w_4 = KSL_MULF(D->m03, ci->m2) - KSL_MULF(D->m23, ci->m0) + ci->m4,
      w_5 = KSL_MULF(D->m13, ci->m0) - KSL_MULF(D->m03, ci->m1) + ci->m5;
  const float co_0 = KSL_MULF(D->m00, ci->m0) + KSL_MULF(D->m10, ci->m1) + KSL_MULF(D->m20, ci->m2),
      co_1 = KSL_MULF(D->m01, ci->m0) + KSL_MULF(D->m11, ci->m1) + KSL_MULF(D->m21, ci->m2),
      co_2 = KSL_MULF(D->m02, ci->m0) + KSL_MULF(D->m12, ci->m1) + KSL_MULF(D->m22, ci->m2),
      co_3 = KSL_MULF(D->m00, w_3) + KSL_MULF(D->m10, w_4) + KSL_MULF(D->m20, w_5),
      co_4 = KSL_MULF(D->m01, w_3) + KSL_MULF(D->m11, w_4) + KSL_MULF(D->m21, w_5),
      co_5 = KSL_MULF(D->m02, w_3) + KSL_MULF(D->m12, w_4) + KSL_MULF(D->m22, w_5);
  co->m0 = co_0;
  co->m1 = co_1;
  co->m2 = co_2;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
}

/* co = [Ad]*(D) (-ci).
   D: displacement [R | t], R rotation, t in m; ci, co: coscrew (f in N; τ in N m).
   24 mul, 18 add, 6 neg.
   Error <= u |result| + (lin: 2, ang: 5) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_CoAdcinvf(const ksl_SE3f_t *D, const ksl_coscrewf_t *ci,
    ksl_coscrewf_t *co) {
  const float w_0 =
          -(KSL_MULF(D->m00, ci->m0) + KSL_MULF(D->m01, ci->m1) + KSL_MULF(D->m02, ci->m2)),
      w_1 = -(KSL_MULF(D->m10, ci->m0) + KSL_MULF(D->m11, ci->m1) + KSL_MULF(D->m12, ci->m2)),
      w_2 = -(KSL_MULF(D->m20, ci->m0) + KSL_MULF(D->m21, ci->m1) + KSL_MULF(D->m22, ci->m2)),
      w_3 = -(KSL_MULF(D->m00, ci->m3) + KSL_MULF(D->m01, ci->m4) + KSL_MULF(D->m02, ci->m5)),
      w_4 = -(KSL_MULF(D->m10, ci->m3) + KSL_MULF(D->m11, ci->m4) + KSL_MULF(D->m12, ci->m5)),
      w_5 = -(KSL_MULF(D->m20, ci->m3) + KSL_MULF(D->m21, ci->m4) + KSL_MULF(D->m22, ci->m5));
  const float co_3 = KSL_MULF(D->m13, w_2) - KSL_MULF(D->m23, w_1) + w_3,
      co_4 = KSL_MULF(D->m23, w_0) - KSL_MULF(D->m03, w_2) + w_4,
      co_5 = KSL_MULF(D->m03, w_1) - KSL_MULF(D->m13, w_0) + w_5;
  co->m0 = w_0;
  co->m1 = w_1;
  co->m2 = w_2;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
}

/* co = h_tx: column 0 of [Ad]*(D).
   D: displacement [R | t], R rotation, t in m; co: coscrew (f in N; τ in N m).
   6 mul, 3 add.
   Error <= u |result| + (lin: 0, ang: 1) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_hctxf(const ksl_SE3f_t *D, ksl_coscrewf_t *co) {
  const float co_3 = KSL_MULF(D->m20, D->m13) - KSL_MULF(D->m10, D->m23),
      co_4 = KSL_MULF(D->m00, D->m23) - KSL_MULF(D->m20, D->m03),
      co_5 = KSL_MULF(D->m10, D->m03) - KSL_MULF(D->m00, D->m13);
  const float D_m00 = D->m00;
  const float D_m10 = D->m10;
  const float D_m20 = D->m20;
  co->m0 = D_m00;
  co->m1 = D_m10;
  co->m2 = D_m20;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
}

/* co = h_ty: column 1 of [Ad]*(D).
   D: displacement [R | t], R rotation, t in m; co: coscrew (f in N; τ in N m).
   6 mul, 3 add.
   Error <= u |result| + (lin: 0, ang: 1) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_hctyf(const ksl_SE3f_t *D, ksl_coscrewf_t *co) {
  const float co_3 = KSL_MULF(D->m21, D->m13) - KSL_MULF(D->m11, D->m23),
      co_4 = KSL_MULF(D->m01, D->m23) - KSL_MULF(D->m21, D->m03),
      co_5 = KSL_MULF(D->m11, D->m03) - KSL_MULF(D->m01, D->m13);
  const float D_m01 = D->m01;
  const float D_m11 = D->m11;
  const float D_m21 = D->m21;
  co->m0 = D_m01;
  co->m1 = D_m11;
  co->m2 = D_m21;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
}

/* co = h_tz: column 2 of [Ad]*(D).
   D: displacement [R | t], R rotation, t in m; co: coscrew (f in N; τ in N m).
   6 mul, 3 add.
   Error <= u |result| + (lin: 0, ang: 1) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_hctzf(const ksl_SE3f_t *D, ksl_coscrewf_t *co) {
  const float co_3 = KSL_MULF(D->m22, D->m13) - KSL_MULF(D->m12, D->m23),
      co_4 = KSL_MULF(D->m02, D->m23) - KSL_MULF(D->m22, D->m03),
      co_5 = KSL_MULF(D->m12, D->m03) - KSL_MULF(D->m02, D->m13);
  const float D_m02 = D->m02;
  const float D_m12 = D->m12;
  const float D_m22 = D->m22;
  co->m0 = D_m02;
  co->m1 = D_m12;
  co->m2 = D_m22;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
}

/* co = h_rx: column 3 of [Ad]*(D).
   D: displacement [R | t], R rotation, t in m; co: coscrew (f in N; τ in N m).
   No arithmetic.
   Exact. */
static inline void ksl_hcrxf(const ksl_SE3f_t *D, ksl_coscrewf_t *co) {
  const float D_m00 = D->m00;
  const float D_m10 = D->m10;
  const float D_m20 = D->m20;
  co->m0 = 0.0f;
  co->m1 = 0.0f;
  co->m2 = 0.0f;
  co->m3 = D_m00;
  co->m4 = D_m10;
  co->m5 = D_m20;
}

/* co = h_ry: column 4 of [Ad]*(D).
   D: displacement [R | t], R rotation, t in m; co: coscrew (f in N; τ in N m).
   No arithmetic.
   Exact. */
static inline void ksl_hcryf(const ksl_SE3f_t *D, ksl_coscrewf_t *co) {
  const float D_m01 = D->m01;
  const float D_m11 = D->m11;
  const float D_m21 = D->m21;
  co->m0 = 0.0f;
  co->m1 = 0.0f;
  co->m2 = 0.0f;
  co->m3 = D_m01;
  co->m4 = D_m11;
  co->m5 = D_m21;
}

/* co = h_rz: column 5 of [Ad]*(D).
   D: displacement [R | t], R rotation, t in m; co: coscrew (f in N; τ in N m).
   No arithmetic.
   Exact. */
static inline void ksl_hcrzf(const ksl_SE3f_t *D, ksl_coscrewf_t *co) {
  const float D_m02 = D->m02;
  const float D_m12 = D->m12;
  const float D_m22 = D->m22;
  co->m0 = 0.0f;
  co->m1 = 0.0f;
  co->m2 = 0.0f;
  co->m3 = D_m02;
  co->m4 = D_m12;
  co->m5 = D_m22;
}

/* co = -h_tx: -column 0 of [Ad]*(D).
   D: displacement [R | t], R rotation, t in m; co: coscrew (f in N; τ in N m).
   6 mul, 3 add, 3 neg.
   Error <= u |result| + (lin: 0, ang: 1) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_hctxinvf(const ksl_SE3f_t *D, ksl_coscrewf_t *co) {
  const float co_0 = -D->m00, co_1 = -D->m10, co_2 = -D->m20,
      co_3 = KSL_MULF(D->m10, D->m23) - KSL_MULF(D->m20, D->m13),
      co_4 = KSL_MULF(D->m20, D->m03) - KSL_MULF(D->m00, D->m23),
      co_5 = KSL_MULF(D->m00, D->m13) - KSL_MULF(D->m10, D->m03);
  co->m0 = co_0;
  co->m1 = co_1;
  co->m2 = co_2;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
}

/* co = -h_ty: -column 1 of [Ad]*(D).
   D: displacement [R | t], R rotation, t in m; co: coscrew (f in N; τ in N m).
   6 mul, 3 add, 3 neg.
   Error <= u |result| + (lin: 0, ang: 1) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_hctyinvf(const ksl_SE3f_t *D, ksl_coscrewf_t *co) {
  const float co_0 = -D->m01, co_1 = -D->m11, co_2 = -D->m21,
      co_3 = KSL_MULF(D->m11, D->m23) - KSL_MULF(D->m21, D->m13),
      co_4 = KSL_MULF(D->m21, D->m03) - KSL_MULF(D->m01, D->m23),
      co_5 = KSL_MULF(D->m01, D->m13) - KSL_MULF(D->m11, D->m03);
  co->m0 = co_0;
  co->m1 = co_1;
  co->m2 = co_2;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
}

/* co = -h_tz: -column 2 of [Ad]*(D).
   D: displacement [R | t], R rotation, t in m; co: coscrew (f in N; τ in N m).
   6 mul, 3 add, 3 neg.
   Error <= u |result| + (lin: 0, ang: 1) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_hctzinvf(const ksl_SE3f_t *D, ksl_coscrewf_t *co) {
  const float co_0 = -D->m02, co_1 = -D->m12, co_2 = -D->m22,
      co_3 = KSL_MULF(D->m12, D->m23) - KSL_MULF(D->m22, D->m13),
      co_4 = KSL_MULF(D->m22, D->m03) - KSL_MULF(D->m02, D->m23),
      co_5 = KSL_MULF(D->m02, D->m13) - KSL_MULF(D->m12, D->m03);
  co->m0 = co_0;
  co->m1 = co_1;
  co->m2 = co_2;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
}

/* co = -h_rx: -column 3 of [Ad]*(D).
   D: displacement [R | t], R rotation, t in m; co: coscrew (f in N; τ in N m).
   3 neg.
   Exact. */
static inline void ksl_hcrxinvf(const ksl_SE3f_t *D, ksl_coscrewf_t *co) {
  const float co_3 = -D->m00, co_4 = -D->m10, co_5 = -D->m20;
  co->m0 = 0.0f;
  co->m1 = 0.0f;
  co->m2 = 0.0f;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
}

/* co = -h_ry: -column 4 of [Ad]*(D).
   D: displacement [R | t], R rotation, t in m; co: coscrew (f in N; τ in N m).
   3 neg.
   Exact. */
static inline void ksl_hcryinvf(const ksl_SE3f_t *D, ksl_coscrewf_t *co) {
  const float co_3 = -D->m01, co_4 = -D->m11, co_5 = -D->m21;
  co->m0 = 0.0f;
  co->m1 = 0.0f;
  co->m2 = 0.0f;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
}

/* co = -h_rz: -column 5 of [Ad]*(D).
   D: displacement [R | t], R rotation, t in m; co: coscrew (f in N; τ in N m).
   3 neg.
   Exact. */
static inline void ksl_hcrzinvf(const ksl_SE3f_t *D, ksl_coscrewf_t *co) {
  const float co_3 = -D->m02, co_4 = -D->m12, co_5 = -D->m22;
  co->m0 = 0.0f;
  co->m1 = 0.0f;
  co->m2 = 0.0f;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
}

/* M = [Ad]*(D).
   D: displacement [R | t], R rotation, t in m; M: 6×6 operator.
   18 mul, 9 add.
   Error <= u |result| + 1 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_CoAdf(const ksl_SE3f_t *D, ksl_mat6x6f_t *M) {
  const float M_30 = KSL_MULF(D->m20, D->m13) - KSL_MULF(D->m10, D->m23),
      M_31 = KSL_MULF(D->m21, D->m13) - KSL_MULF(D->m11, D->m23),
      M_32 = KSL_MULF(D->m22, D->m13) - KSL_MULF(D->m12, D->m23),
      M_40 = KSL_MULF(D->m00, D->m23) - KSL_MULF(D->m20, D->m03),
      M_41 = KSL_MULF(D->m01, D->m23) - KSL_MULF(D->m21, D->m03),
      M_42 = KSL_MULF(D->m02, D->m23) - KSL_MULF(D->m22, D->m03),
      M_50 = KSL_MULF(D->m10, D->m03) - KSL_MULF(D->m00, D->m13),
      M_51 = KSL_MULF(D->m11, D->m03) - KSL_MULF(D->m01, D->m13),
      M_52 = KSL_MULF(D->m12, D->m03) - KSL_MULF(D->m02, D->m13);
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
}

/* power = W ⊙ $ = f·v + τ·ω, W = c = (f; τ), $ = x = (ω; v).
   c: coscrew (f in N; τ in N m); x: six components with the angular part on top.
   6 mul, 5 add.
   Error <= u |result| + 3 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline float ksl_reciprocal_productf(const ksl_coscrewf_t *c, const float x[6]) {
  const float power_e = KSL_MULF(c->m0, x[3]) + KSL_MULF(c->m1, x[4]) + KSL_MULF(c->m2, x[5]),
      power = power_e + (KSL_MULF(c->m3, x[0]) + KSL_MULF(c->m4, x[1]) + KSL_MULF(c->m5, x[2]));
  return power;
}

/* co = [ad]*(s) c = (ω×f ; v×f + ω×τ).
   s: screw (v in m/s; ω in rad/s); c, co: coscrew (f in N; τ in N m).
   18 mul, 12 add.
   Error <= u |result| + (lin: 1, ang: 2) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_cross_scf(const ksl_screwf_t *s, const ksl_coscrewf_t *c,
    ksl_coscrewf_t *co) {
  const float co_0 = KSL_MULF(s->m4, c->m2) - KSL_MULF(s->m5, c->m1),
      co_1 = KSL_MULF(s->m5, c->m0) - KSL_MULF(s->m3, c->m2),
      co_2 = KSL_MULF(s->m3, c->m1) - KSL_MULF(s->m4, c->m0),
      co_3 = KSL_MULF(s->m1, c->m2) - KSL_MULF(s->m2, c->m1)
          + (KSL_MULF(s->m4, c->m5) - KSL_MULF(s->m5, c->m4)),
      co_4 = KSL_MULF(s->m2, c->m0) - KSL_MULF(s->m0, c->m2)
          + (KSL_MULF(s->m5, c->m3) - KSL_MULF(s->m3, c->m5)),
      co_5 = KSL_MULF(s->m0, c->m1) - KSL_MULF(s->m1, c->m0)
          + (KSL_MULF(s->m3, c->m4) - KSL_MULF(s->m4, c->m3));
  co->m0 = co_0;
  co->m1 = co_1;
  co->m2 = co_2;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
}

/* co = (0 ; ω×τ).
   s: screw (v in m/s; ω in rad/s); c, co: coscrew (f in N; τ in N m).
   6 mul, 3 add.
   Error <= u |result| + (lin: 0, ang: 1) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_cross_scaf(const ksl_screwf_t *s, const ksl_coscrewf_t *c,
    ksl_coscrewf_t *co) {
  const float co_3 = KSL_MULF(s->m4, c->m5) - KSL_MULF(s->m5, c->m4),
      co_4 = KSL_MULF(s->m5, c->m3) - KSL_MULF(s->m3, c->m5),
      co_5 = KSL_MULF(s->m3, c->m4) - KSL_MULF(s->m4, c->m3);
  co->m0 = 0.0f;
  co->m1 = 0.0f;
  co->m2 = 0.0f;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
}

/* co = H̄* c = [Ad]*(D) P c; P clears component 0 of c, given in the frame of a tx joint at D.
   D: displacement [R | t], R rotation, t in m; c, co: coscrew (f in N; τ in N m).
   21 mul, 15 add.
   Error <= u |result| + (lin: 1, ang: 4) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_constraint_ctxf(const ksl_SE3f_t *D, const ksl_coscrewf_t *c,
    ksl_coscrewf_t *co) {
  const float w_0 = KSL_MULF(D->m01, c->m1) + KSL_MULF(D->m02, c->m2),
      w_1 = KSL_MULF(D->m11, c->m1) + KSL_MULF(D->m12, c->m2),
      w_2 = KSL_MULF(D->m21, c->m1) + KSL_MULF(D->m22, c->m2),
      w_3 = KSL_MULF(D->m00, c->m3) + KSL_MULF(D->m01, c->m4) + KSL_MULF(D->m02, c->m5),
      w_4 = KSL_MULF(D->m10, c->m3) + KSL_MULF(D->m11, c->m4) + KSL_MULF(D->m12, c->m5),
      w_5 = KSL_MULF(D->m20, c->m3) + KSL_MULF(D->m21, c->m4) + KSL_MULF(D->m22, c->m5);
  const float co_3 = KSL_MULF(D->m13, w_2) - KSL_MULF(D->m23, w_1) + w_3,
      co_4 = KSL_MULF(D->m23, w_0) - KSL_MULF(D->m03, w_2) + w_4,
      co_5 = KSL_MULF(D->m03, w_1) - KSL_MULF(D->m13, w_0) + w_5;
  co->m0 = w_0;
  co->m1 = w_1;
  co->m2 = w_2;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
}

/* co = H̄* c = [Ad]*(D) P c; P clears component 1 of c, given in the frame of a ty joint at D.
   D: displacement [R | t], R rotation, t in m; c, co: coscrew (f in N; τ in N m).
   21 mul, 15 add.
   Error <= u |result| + (lin: 1, ang: 4) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_constraint_ctyf(const ksl_SE3f_t *D, const ksl_coscrewf_t *c,
    ksl_coscrewf_t *co) {
  const float w_0 = KSL_MULF(D->m00, c->m0) + KSL_MULF(D->m02, c->m2),
      w_1 = KSL_MULF(D->m10, c->m0) + KSL_MULF(D->m12, c->m2),
      w_2 = KSL_MULF(D->m20, c->m0) + KSL_MULF(D->m22, c->m2),
      w_3 = KSL_MULF(D->m00, c->m3) + KSL_MULF(D->m01, c->m4) + KSL_MULF(D->m02, c->m5),
      w_4 = KSL_MULF(D->m10, c->m3) + KSL_MULF(D->m11, c->m4) + KSL_MULF(D->m12, c->m5),
      w_5 = KSL_MULF(D->m20, c->m3) + KSL_MULF(D->m21, c->m4) + KSL_MULF(D->m22, c->m5);
  const float co_3 = KSL_MULF(D->m13, w_2) - KSL_MULF(D->m23, w_1) + w_3,
      co_4 = KSL_MULF(D->m23, w_0) - KSL_MULF(D->m03, w_2) + w_4,
      co_5 = KSL_MULF(D->m03, w_1) - KSL_MULF(D->m13, w_0) + w_5;
  co->m0 = w_0;
  co->m1 = w_1;
  co->m2 = w_2;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
}

/* co = H̄* c = [Ad]*(D) P c; P clears component 2 of c, given in the frame of a tz joint at D.
   D: displacement [R | t], R rotation, t in m; c, co: coscrew (f in N; τ in N m).
   21 mul, 15 add.
   Error <= u |result| + (lin: 1, ang: 4) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_constraint_ctzf(const ksl_SE3f_t *D, const ksl_coscrewf_t *c,
    ksl_coscrewf_t *co) {
  const float w_0 = KSL_MULF(D->m00, c->m0) + KSL_MULF(D->m01, c->m1),
      w_1 = KSL_MULF(D->m10, c->m0) + KSL_MULF(D->m11, c->m1),
      w_2 = KSL_MULF(D->m20, c->m0) + KSL_MULF(D->m21, c->m1),
      w_3 = KSL_MULF(D->m00, c->m3) + KSL_MULF(D->m01, c->m4) + KSL_MULF(D->m02, c->m5),
      w_4 = KSL_MULF(D->m10, c->m3) + KSL_MULF(D->m11, c->m4) + KSL_MULF(D->m12, c->m5),
      w_5 = KSL_MULF(D->m20, c->m3) + KSL_MULF(D->m21, c->m4) + KSL_MULF(D->m22, c->m5);
  const float co_3 = KSL_MULF(D->m13, w_2) - KSL_MULF(D->m23, w_1) + w_3,
      co_4 = KSL_MULF(D->m23, w_0) - KSL_MULF(D->m03, w_2) + w_4,
      co_5 = KSL_MULF(D->m03, w_1) - KSL_MULF(D->m13, w_0) + w_5;
  co->m0 = w_0;
  co->m1 = w_1;
  co->m2 = w_2;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
}

/* co = H̄* c = [Ad]*(D) P c; P clears component 3 of c, given in the frame of a rx joint at D.
   D: displacement [R | t], R rotation, t in m; c, co: coscrew (f in N; τ in N m).
   21 mul, 15 add.
   Error <= u |result| + (lin: 2, ang: 5) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_constraint_crxf(const ksl_SE3f_t *D, const ksl_coscrewf_t *c,
    ksl_coscrewf_t *co) {
  const float w_0 = KSL_MULF(D->m00, c->m0) + KSL_MULF(D->m01, c->m1) + KSL_MULF(D->m02, c->m2),
      w_1 = KSL_MULF(D->m10, c->m0) + KSL_MULF(D->m11, c->m1) + KSL_MULF(D->m12, c->m2),
      w_2 = KSL_MULF(D->m20, c->m0) + KSL_MULF(D->m21, c->m1) + KSL_MULF(D->m22, c->m2),
      w_3 = KSL_MULF(D->m01, c->m4) + KSL_MULF(D->m02, c->m5),
      w_4 = KSL_MULF(D->m11, c->m4) + KSL_MULF(D->m12, c->m5),
      w_5 = KSL_MULF(D->m21, c->m4) + KSL_MULF(D->m22, c->m5);
  const float co_3 = KSL_MULF(D->m13, w_2) - KSL_MULF(D->m23, w_1) + w_3,
      co_4 = KSL_MULF(D->m23, w_0) - KSL_MULF(D->m03, w_2) + w_4,
      co_5 = KSL_MULF(D->m03, w_1) - KSL_MULF(D->m13, w_0) + w_5;
  co->m0 = w_0;
  co->m1 = w_1;
  co->m2 = w_2;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
}

/* co = H̄* c = [Ad]*(D) P c; P clears component 4 of c, given in the frame of a ry joint at D.
   D: displacement [R | t], R rotation, t in m; c, co: coscrew (f in N; τ in N m).
   21 mul, 15 add.
   Error <= u |result| + (lin: 2, ang: 5) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_constraint_cryf(const ksl_SE3f_t *D, const ksl_coscrewf_t *c,
    ksl_coscrewf_t *co) {
  const float w_0 = KSL_MULF(D->m00, c->m0) + KSL_MULF(D->m01, c->m1) + KSL_MULF(D->m02, c->m2),
      w_1 = KSL_MULF(D->m10, c->m0) + KSL_MULF(D->m11, c->m1) + KSL_MULF(D->m12, c->m2),
      w_2 = KSL_MULF(D->m20, c->m0) + KSL_MULF(D->m21, c->m1) + KSL_MULF(D->m22, c->m2),
      w_3 = KSL_MULF(D->m00, c->m3) + KSL_MULF(D->m02, c->m5),
      w_4 = KSL_MULF(D->m10, c->m3) + KSL_MULF(D->m12, c->m5),
      w_5 = KSL_MULF(D->m20, c->m3) + KSL_MULF(D->m22, c->m5);
  const float co_3 = KSL_MULF(D->m13, w_2) - KSL_MULF(D->m23, w_1) + w_3,
      co_4 = KSL_MULF(D->m23, w_0) - KSL_MULF(D->m03, w_2) + w_4,
      co_5 = KSL_MULF(D->m03, w_1) - KSL_MULF(D->m13, w_0) + w_5;
  co->m0 = w_0;
  co->m1 = w_1;
  co->m2 = w_2;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
}

/* co = H̄* c = [Ad]*(D) P c; P clears component 5 of c, given in the frame of a rz joint at D.
   D: displacement [R | t], R rotation, t in m; c, co: coscrew (f in N; τ in N m).
   21 mul, 15 add.
   Error <= u |result| + (lin: 2, ang: 5) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_constraint_crzf(const ksl_SE3f_t *D, const ksl_coscrewf_t *c,
    ksl_coscrewf_t *co) {
  const float w_0 = KSL_MULF(D->m00, c->m0) + KSL_MULF(D->m01, c->m1) + KSL_MULF(D->m02, c->m2),
      w_1 = KSL_MULF(D->m10, c->m0) + KSL_MULF(D->m11, c->m1) + KSL_MULF(D->m12, c->m2),
      w_2 = KSL_MULF(D->m20, c->m0) + KSL_MULF(D->m21, c->m1) + KSL_MULF(D->m22, c->m2),
      w_3 = KSL_MULF(D->m00, c->m3) + KSL_MULF(D->m01, c->m4),
      w_4 = KSL_MULF(D->m10, c->m3) + KSL_MULF(D->m11, c->m4),
      w_5 = KSL_MULF(D->m20, c->m3) + KSL_MULF(D->m21, c->m4);
  const float co_3 = KSL_MULF(D->m13, w_2) - KSL_MULF(D->m23, w_1) + w_3,
      co_4 = KSL_MULF(D->m23, w_0) - KSL_MULF(D->m03, w_2) + w_4,
      co_5 = KSL_MULF(D->m03, w_1) - KSL_MULF(D->m13, w_0) + w_5;
  co->m0 = w_0;
  co->m1 = w_1;
  co->m2 = w_2;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
}

/* co = h̄* c = [Ad]*(D) P c; P keeps component 0 of c, given in the frame of a tx joint at D.
   D: displacement [R | t], R rotation, t in m; c, co: coscrew (f in N; τ in N m).
   9 mul, 3 add.
   Error <= u |result| + (lin: 0, ang: 2) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_working_ctxf(const ksl_SE3f_t *D, const ksl_coscrewf_t *c,
    ksl_coscrewf_t *co) {
  const float w_0 = KSL_MULF(D->m00, c->m0), w_1 = KSL_MULF(D->m10, c->m0),
      w_2 = KSL_MULF(D->m20, c->m0);
  const float co_3 = KSL_MULF(D->m13, w_2) - KSL_MULF(D->m23, w_1),
      co_4 = KSL_MULF(D->m23, w_0) - KSL_MULF(D->m03, w_2),
      co_5 = KSL_MULF(D->m03, w_1) - KSL_MULF(D->m13, w_0);
  co->m0 = w_0;
  co->m1 = w_1;
  co->m2 = w_2;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
}

/* co = h̄* c = [Ad]*(D) P c; P keeps component 1 of c, given in the frame of a ty joint at D.
   D: displacement [R | t], R rotation, t in m; c, co: coscrew (f in N; τ in N m).
   9 mul, 3 add.
   Error <= u |result| + (lin: 0, ang: 2) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_working_ctyf(const ksl_SE3f_t *D, const ksl_coscrewf_t *c,
    ksl_coscrewf_t *co) {
  const float w_0 = KSL_MULF(D->m01, c->m1), w_1 = KSL_MULF(D->m11, c->m1),
      w_2 = KSL_MULF(D->m21, c->m1);
  const float co_3 = KSL_MULF(D->m13, w_2) - KSL_MULF(D->m23, w_1),
      co_4 = KSL_MULF(D->m23, w_0) - KSL_MULF(D->m03, w_2),
      co_5 = KSL_MULF(D->m03, w_1) - KSL_MULF(D->m13, w_0);
  co->m0 = w_0;
  co->m1 = w_1;
  co->m2 = w_2;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
}

/* co = h̄* c = [Ad]*(D) P c; P keeps component 2 of c, given in the frame of a tz joint at D.
   D: displacement [R | t], R rotation, t in m; c, co: coscrew (f in N; τ in N m).
   9 mul, 3 add.
   Error <= u |result| + (lin: 0, ang: 2) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_working_ctzf(const ksl_SE3f_t *D, const ksl_coscrewf_t *c,
    ksl_coscrewf_t *co) {
  const float w_0 = KSL_MULF(D->m02, c->m2), w_1 = KSL_MULF(D->m12, c->m2),
      w_2 = KSL_MULF(D->m22, c->m2);
  const float co_3 = KSL_MULF(D->m13, w_2) - KSL_MULF(D->m23, w_1),
      co_4 = KSL_MULF(D->m23, w_0) - KSL_MULF(D->m03, w_2),
      co_5 = KSL_MULF(D->m03, w_1) - KSL_MULF(D->m13, w_0);
  co->m0 = w_0;
  co->m1 = w_1;
  co->m2 = w_2;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
}

/* co = h̄* c = [Ad]*(D) P c; P keeps component 3 of c, given in the frame of a rx joint at D.
   D: displacement [R | t], R rotation, t in m; c, co: coscrew (f in N; τ in N m).
   3 mul.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_working_crxf(const ksl_SE3f_t *D, const ksl_coscrewf_t *c,
    ksl_coscrewf_t *co) {
  const float w_3 = KSL_MULF(D->m00, c->m3), w_4 = KSL_MULF(D->m10, c->m3),
      w_5 = KSL_MULF(D->m20, c->m3);
  co->m0 = 0.0f;
  co->m1 = 0.0f;
  co->m2 = 0.0f;
  co->m3 = w_3;
  co->m4 = w_4;
  co->m5 = w_5;
}

/* co = h̄* c = [Ad]*(D) P c; P keeps component 4 of c, given in the frame of a ry joint at D.
   D: displacement [R | t], R rotation, t in m; c, co: coscrew (f in N; τ in N m).
   3 mul.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_working_cryf(const ksl_SE3f_t *D, const ksl_coscrewf_t *c,
    ksl_coscrewf_t *co) {
  const float w_3 = KSL_MULF(D->m01, c->m4), w_4 = KSL_MULF(D->m11, c->m4),
      w_5 = KSL_MULF(D->m21, c->m4);
  co->m0 = 0.0f;
  co->m1 = 0.0f;
  co->m2 = 0.0f;
  co->m3 = w_3;
  co->m4 = w_4;
  co->m5 = w_5;
}

/* co = h̄* c = [Ad]*(D) P c; P keeps component 5 of c, given in the frame of a rz joint at D.
   D: displacement [R | t], R rotation, t in m; c, co: coscrew (f in N; τ in N m).
   3 mul.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_working_crzf(const ksl_SE3f_t *D, const ksl_coscrewf_t *c,
    ksl_coscrewf_t *co) {
  const float w_3 = KSL_MULF(D->m02, c->m5), w_4 = KSL_MULF(D->m12, c->m5),
      w_5 = KSL_MULF(D->m22, c->m5);
  co->m0 = 0.0f;
  co->m1 = 0.0f;
  co->m2 = 0.0f;
  co->m3 = w_3;
  co->m4 = w_4;
  co->m5 = w_5;
}

/* M = [ad]*(s) = [Ad]*' [Ad]*^-1 = [[ω~, 0], [v~, ω~]].
   s: screw (v in m/s; ω in rad/s); M: 6×6 operator.
   6 neg.
   Exact. */
static inline void ksl_coadf(const ksl_screwf_t *s, ksl_mat6x6f_t *M) {
  const float M_01 = -s->m5, M_12 = -s->m3, M_20 = -s->m4, M_31 = -s->m2, M_42 = -s->m0,
      M_50 = -s->m1;
  const float s_m4 = s->m4;
  const float s_m5 = s->m5;
  const float s_m3 = s->m3;
  const float s_m1 = s->m1;
  const float s_m2 = s->m2;
  const float s_m0 = s->m0;
  M->at[0][0] = 0.0f;
  M->at[1][0] = M_01;
  M->at[2][0] = s_m4;
  M->at[3][0] = 0.0f;
  M->at[4][0] = 0.0f;
  M->at[5][0] = 0.0f;
  M->at[0][1] = s_m5;
  M->at[1][1] = 0.0f;
  M->at[2][1] = M_12;
  M->at[3][1] = 0.0f;
  M->at[4][1] = 0.0f;
  M->at[5][1] = 0.0f;
  M->at[0][2] = M_20;
  M->at[1][2] = s_m3;
  M->at[2][2] = 0.0f;
  M->at[3][2] = 0.0f;
  M->at[4][2] = 0.0f;
  M->at[5][2] = 0.0f;
  M->at[0][3] = 0.0f;
  M->at[1][3] = M_31;
  M->at[2][3] = s_m1;
  M->at[3][3] = 0.0f;
  M->at[4][3] = M_01;
  M->at[5][3] = s_m4;
  M->at[0][4] = s_m2;
  M->at[1][4] = 0.0f;
  M->at[2][4] = M_42;
  M->at[3][4] = s_m5;
  M->at[4][4] = 0.0f;
  M->at[5][4] = M_12;
  M->at[0][5] = M_50;
  M->at[1][5] = s_m0;
  M->at[2][5] = 0.0f;
  M->at[3][5] = M_20;
  M->at[4][5] = s_m3;
  M->at[5][5] = 0.0f;
}

#ifndef KSL_NO_ALLOC
#include <stdlib.h>

/* n ksl_coscrew_t on the heap, zeros, to be freed by the caller; NULL for n <= 0 or when there
     is no memory. */
static inline ksl_coscrew_t *ksl_coscrew_alloc(int n) {
  return n > 0 ? (ksl_coscrew_t *)calloc((size_t)n, sizeof(ksl_coscrew_t)) : NULL;
}

/* n ksl_coscrewf_t on the heap, zeros, to be freed by the caller; NULL for n <= 0 or when there
     is no memory. */
static inline ksl_coscrewf_t *ksl_coscrewf_alloc(int n) {
  return n > 0 ? (ksl_coscrewf_t *)calloc((size_t)n, sizeof(ksl_coscrewf_t)) : NULL;
}

#endif

#endif
