/* Made by `coscrew generate`; changes are overwritten. */
/* SPDX-License-Identifier: MIT */
/* coscrew 0.2.0.  Copyright (c) 2026 The coscrew authors. */
/* Screws: twists, spatial velocities and accelerations, s = (v; ω). */
#ifndef KSL_SCREW_H
#define KSL_SCREW_H

#include "ksl_types.h"
#include "matrix.h"
#include "mat6x6.h"

/* The screw of these entries, in order. */
static inline ksl_screw_t ksl_screw(const double m0, const double m1, const double m2,
    const double m3, const double m4, const double m5) {
  ksl_screw_t value;
  value.m0 = m0;
  value.m1 = m1;
  value.m2 = m2;
  value.m3 = m3;
  value.m4 = m4;
  value.m5 = m5;
  return value;
}

/* so = si.
   si, so: screw (v in m/s; ω in rad/s).
   No arithmetic.
   Exact. */
static inline void ksl_screw_copy(const ksl_screw_t *si, ksl_screw_t *so) {
  const double si_m0 = si->m0;
  const double si_m1 = si->m1;
  const double si_m2 = si->m2;
  const double si_m3 = si->m3;
  const double si_m4 = si->m4;
  const double si_m5 = si->m5;
  so->m0 = si_m0;
  so->m1 = si_m1;
  so->m2 = si_m2;
  so->m3 = si_m3;
  so->m4 = si_m4;
  so->m5 = si_m5;
}

/* self = a self.
   self: screw (v in m/s; ω in rad/s); a: number.
   6 mul.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_screw_scale(ksl_screw_t *self, const double a) {
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

/* so = -si.
   si, so: screw (v in m/s; ω in rad/s).
   6 neg.
   Exact. */
static inline void ksl_screw_inverted(const ksl_screw_t *si, ksl_screw_t *so) {
  const double so_0 = -si->m0, so_1 = -si->m1, so_2 = -si->m2, so_3 = -si->m3, so_4 = -si->m4,
      so_5 = -si->m5;
  so->m0 = so_0;
  so->m1 = so_1;
  so->m2 = so_2;
  so->m3 = so_3;
  so->m4 = so_4;
  so->m5 = so_5;
}

/* self = -self.
   self: screw (v in m/s; ω in rad/s).
   6 neg.
   Exact. */
static inline void ksl_screw_invert(ksl_screw_t *self) {
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
   a: number; x, y: screw (v in m/s; ω in rad/s).
   6 mul, 6 add.
   Error <= u |result| + 1 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_axpy_ss(const double a, const ksl_screw_t *x, ksl_screw_t *y) {
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
   x, y: screw (v in m/s; ω in rad/s).
   6 add.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_xpy_ss(const ksl_screw_t *x, ksl_screw_t *y) {
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
   x, y: screw (v in m/s; ω in rad/s).
   6 add.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_nxpy_ss(const ksl_screw_t *x, ksl_screw_t *y) {
  const double y_0_new = y->m0 - x->m0, y_1_new = y->m1 - x->m1, y_2_new = y->m2 - x->m2,
      y_3_new = y->m3 - x->m3, y_4_new = y->m4 - x->m4, y_5_new = y->m5 - x->m5;
  y->m0 = y_0_new;
  y->m1 = y_1_new;
  y->m2 = y_2_new;
  y->m3 = y_3_new;
  y->m4 = y_4_new;
  y->m5 = y_5_new;
}

/* so = a si.
   a: number; si, so: screw (v in m/s; ω in rad/s).
   6 mul.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_product_as(const double a, const ksl_screw_t *si, ksl_screw_t *so) {
  const double so_0 = KSL_MUL(a, si->m0), so_1 = KSL_MUL(a, si->m1), so_2 = KSL_MUL(a, si->m2),
      so_3 = KSL_MUL(a, si->m3), so_4 = KSL_MUL(a, si->m4), so_5 = KSL_MUL(a, si->m5);
  so->m0 = so_0;
  so->m1 = so_1;
  so->m2 = so_2;
  so->m3 = so_3;
  so->m4 = so_4;
  so->m5 = so_5;
}

/* so = s1 + s2.
   s1, s2, so: screw (v in m/s; ω in rad/s).
   6 add.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_add_ss(const ksl_screw_t *s1, const ksl_screw_t *s2, ksl_screw_t *so) {
  const double so_0 = s1->m0 + s2->m0, so_1 = s1->m1 + s2->m1, so_2 = s1->m2 + s2->m2,
      so_3 = s1->m3 + s2->m3, so_4 = s1->m4 + s2->m4, so_5 = s1->m5 + s2->m5;
  so->m0 = so_0;
  so->m1 = so_1;
  so->m2 = so_2;
  so->m3 = so_3;
  so->m4 = so_4;
  so->m5 = so_5;
}

/* so = s1 - s2.
   s1, s2, so: screw (v in m/s; ω in rad/s).
   6 add.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_subtract_ss(const ksl_screw_t *s1, const ksl_screw_t *s2, ksl_screw_t *so) {
  const double so_0 = s1->m0 - s2->m0, so_1 = s1->m1 - s2->m1, so_2 = s1->m2 - s2->m2,
      so_3 = s1->m3 - s2->m3, so_4 = s1->m4 - s2->m4, so_5 = s1->m5 - s2->m5;
  so->m0 = so_0;
  so->m1 = so_1;
  so->m2 = so_2;
  so->m3 = so_3;
  so->m4 = so_4;
  so->m5 = so_5;
}

/* |si|: |ω|, or |v| where every |ω_i| is below 1e-9 (single: 1e-6).
   si: screw (v in m/s; ω in rad/s).
   7 mul, 2 add, 1 sqrt, 6 abs, 11 less, 1 equal, 14 select. */
static inline double ksl_screw_norm(const ksl_screw_t *si) {
  const double small_c = fabs(si->m5) < 1e-09 ? 1.0 : 0.0,
      small_f = fabs(si->m4) < 1e-09 ? small_c : 0.0, small = fabs(si->m3) < 1e-09 ? small_f : 0.0;
  const double p_0 = small == 1.0 ? si->m0 : si->m3, p_1 = small == 1.0 ? si->m1 : si->m4,
      p_2 = small == 1.0 ? si->m2 : si->m5;
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

/* self = self / |self|, with screw_norm; the zero screw stays zero.
   self: screw (v in m/s; ω in rad/s).
   18 mul, 2 add, 6 div, 1 sqrt, 9 abs, 16 less, 2 equal, 26 select. */
static inline void ksl_screw_normalize(ksl_screw_t *self) {
  const double small_a = fabs(self->m5), small_c = small_a < 1e-09 ? 1.0 : 0.0,
      small_d = fabs(self->m4), small_f = small_d < 1e-09 ? small_c : 0.0, small_g = fabs(self->m3),
      small = small_g < 1e-09 ? small_f : 0.0;
  const double p_0 = small == 1.0 ? self->m0 : self->m3, p_1 = small == 1.0 ? self->m1 : self->m4,
      p_2 = small == 1.0 ? self->m2 : self->m5;
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
  const double size_0 = fabs(self->m0), size_1 = fabs(self->m1), size_2 = fabs(self->m2);
  const double before_0 = size_0 < 256.0 ? up : down, before_1 = size_1 < 256.0 ? up : down,
      before_2 = size_2 < 256.0 ? up : down, before_3 = small_g < 256.0 ? up : down,
      before_4 = small_d < 256.0 ? up : down, before_5 = small_a < 256.0 ? up : down;
  const double after_0 = size_0 < 256.0 ? down : up, after_1 = size_1 < 256.0 ? down : up,
      after_2 = size_2 < 256.0 ? down : up, after_3 = small_g < 256.0 ? down : up,
      after_4 = small_d < 256.0 ? down : up, after_5 = small_a < 256.0 ? down : up;
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

/* so = si / |si|, with screw_norm; the zero screw stays zero.
   si, so: screw (v in m/s; ω in rad/s).
   18 mul, 2 add, 6 div, 1 sqrt, 9 abs, 16 less, 2 equal, 26 select. */
static inline void ksl_screw_normalized(const ksl_screw_t *si, ksl_screw_t *so) {
  const double small_a = fabs(si->m5), small_c = small_a < 1e-09 ? 1.0 : 0.0,
      small_d = fabs(si->m4), small_f = small_d < 1e-09 ? small_c : 0.0, small_g = fabs(si->m3),
      small = small_g < 1e-09 ? small_f : 0.0;
  const double p_0 = small == 1.0 ? si->m0 : si->m3, p_1 = small == 1.0 ? si->m1 : si->m4,
      p_2 = small == 1.0 ? si->m2 : si->m5;
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
  const double size_0 = fabs(si->m0), size_1 = fabs(si->m1), size_2 = fabs(si->m2);
  const double before_0 = size_0 < 256.0 ? up : down, before_1 = size_1 < 256.0 ? up : down,
      before_2 = size_2 < 256.0 ? up : down, before_3 = small_g < 256.0 ? up : down,
      before_4 = small_d < 256.0 ? up : down, before_5 = small_a < 256.0 ? up : down;
  const double after_0 = size_0 < 256.0 ? down : up, after_1 = size_1 < 256.0 ? down : up,
      after_2 = size_2 < 256.0 ? down : up, after_3 = small_g < 256.0 ? down : up,
      after_4 = small_d < 256.0 ? down : up, after_5 = small_a < 256.0 ? down : up;
  const double sized_0 = KSL_MUL(si->m0, before_0), sized_1 = KSL_MUL(si->m1, before_1),
      sized_2 = KSL_MUL(si->m2, before_2), sized_3 = KSL_MUL(si->m3, before_3),
      sized_4 = KSL_MUL(si->m4, before_4), sized_5 = KSL_MUL(si->m5, before_5);
  const double quotient_0 = sized_0 / divisor, quotient_1 = sized_1 / divisor,
      quotient_2 = sized_2 / divisor, quotient_3 = sized_3 / divisor,
      quotient_4 = sized_4 / divisor, quotient_5 = sized_5 / divisor;
  const double so_0 = KSL_MUL(quotient_0, after_0), so_1 = KSL_MUL(quotient_1, after_1),
      so_2 = KSL_MUL(quotient_2, after_2), so_3 = KSL_MUL(quotient_3, after_3),
      so_4 = KSL_MUL(quotient_4, after_4), so_5 = KSL_MUL(quotient_5, after_5);
  so->m0 = so_0;
  so->m1 = so_1;
  so->m2 = so_2;
  so->m3 = so_3;
  so->m4 = so_4;
  so->m5 = so_5;
}

/* so = (lin; ang).
   lin, ang: vector; so: screw (v in m/s; ω in rad/s).
   No arithmetic.
   Exact. */
static inline void ksl_screw_from_lin_ang(const ksl_vec3_t *lin, const ksl_vec3_t *ang,
    ksl_screw_t *so) {
  const double lin_x = lin->x;
  const double lin_y = lin->y;
  const double lin_z = lin->z;
  const double ang_x = ang->x;
  const double ang_y = ang->y;
  const double ang_z = ang->z;
  so->m0 = lin_x;
  so->m1 = lin_y;
  so->m2 = lin_z;
  so->m3 = ang_x;
  so->m4 = ang_y;
  so->m5 = ang_z;
}

/* x = (ang; lin) of si.
   si: screw (v in m/s; ω in rad/s); x: six components with the angular part on top.
   No arithmetic.
   Exact. */
static inline void ksl_screw_to_angular_first(const ksl_screw_t *si, double x[6]) {
  const double si_m3 = si->m3;
  const double si_m4 = si->m4;
  const double si_m5 = si->m5;
  const double si_m0 = si->m0;
  const double si_m1 = si->m1;
  const double si_m2 = si->m2;
  x[0] = si_m3;
  x[1] = si_m4;
  x[2] = si_m5;
  x[3] = si_m0;
  x[4] = si_m1;
  x[5] = si_m2;
}

/* so = (lin; ang) of x = (ang; lin).
   x: six components with the angular part on top; so: screw (v in m/s; ω in rad/s).
   No arithmetic.
   Exact. */
static inline void ksl_screw_from_angular_first(const double x[6], ksl_screw_t *so) {
  const double x_3 = x[3];
  const double x_4 = x[4];
  const double x_5 = x[5];
  const double x_0 = x[0];
  const double x_1 = x[1];
  const double x_2 = x[2];
  so->m0 = x_3;
  so->m1 = x_4;
  so->m2 = x_5;
  so->m3 = x_0;
  so->m4 = x_1;
  so->m5 = x_2;
}

/* so = (s1.lin + s2.lin ; s1.ang).
   s1, s2, so: screw (v in m/s; ω in rad/s).
   3 add.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_add_sst(const ksl_screw_t *s1, const ksl_screw_t *s2, ksl_screw_t *so) {
  const double so_0 = s1->m0 + s2->m0, so_1 = s1->m1 + s2->m1, so_2 = s1->m2 + s2->m2;
  const double s1_m3 = s1->m3;
  const double s1_m4 = s1->m4;
  const double s1_m5 = s1->m5;
  so->m0 = so_0;
  so->m1 = so_1;
  so->m2 = so_2;
  so->m3 = s1_m3;
  so->m4 = s1_m4;
  so->m5 = s1_m5;
}

/* so = [Ad](t) si.
   t: vector; si, so: screw (v in m/s; ω in rad/s).
   6 mul, 6 add.
   Error <= u |result| + (lin: 2, ang: 0) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_Adts(const ksl_vec3_t *t, const ksl_screw_t *si, ksl_screw_t *so) {
  const double so_0 = KSL_MUL(t->y, si->m5) - KSL_MUL(t->z, si->m4) + si->m0,
      so_1 = KSL_MUL(t->z, si->m3) - KSL_MUL(t->x, si->m5) + si->m1,
      so_2 = KSL_MUL(t->x, si->m4) - KSL_MUL(t->y, si->m3) + si->m2;
  const double si_m3 = si->m3;
  const double si_m4 = si->m4;
  const double si_m5 = si->m5;
  so->m0 = so_0;
  so->m1 = so_1;
  so->m2 = so_2;
  so->m3 = si_m3;
  so->m4 = si_m4;
  so->m5 = si_m5;
}

/* so = [Ad](t)^-1 si.
   t: vector; si, so: screw (v in m/s; ω in rad/s).
   6 mul, 6 add.
   Error <= u |result| + (lin: 2, ang: 0) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_Adtinvs(const ksl_vec3_t *t, const ksl_screw_t *si,
    ksl_screw_t *so) {
  const double so_0 = KSL_MUL(t->z, si->m4) - KSL_MUL(t->y, si->m5) + si->m0,
      so_1 = KSL_MUL(t->x, si->m5) - KSL_MUL(t->z, si->m3) + si->m1,
      so_2 = KSL_MUL(t->y, si->m3) - KSL_MUL(t->x, si->m4) + si->m2;
  const double si_m3 = si->m3;
  const double si_m4 = si->m4;
  const double si_m5 = si->m5;
  so->m0 = so_0;
  so->m1 = so_1;
  so->m2 = so_2;
  so->m3 = si_m3;
  so->m4 = si_m4;
  so->m5 = si_m5;
}

/* so = [Ad](t) (-si).
   t: vector; si, so: screw (v in m/s; ω in rad/s).
   6 mul, 6 add, 3 neg.
   Error <= u |result| + (lin: 2, ang: 0) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_Adtsinv(const ksl_vec3_t *t, const ksl_screw_t *si,
    ksl_screw_t *so) {
  const double so_0 = KSL_MUL(t->z, si->m4) - KSL_MUL(t->y, si->m5) - si->m0,
      so_1 = KSL_MUL(t->x, si->m5) - KSL_MUL(t->z, si->m3) - si->m1,
      so_2 = KSL_MUL(t->y, si->m3) - KSL_MUL(t->x, si->m4) - si->m2, so_3 = -si->m3, so_4 = -si->m4,
      so_5 = -si->m5;
  so->m0 = so_0;
  so->m1 = so_1;
  so->m2 = so_2;
  so->m3 = so_3;
  so->m4 = so_4;
  so->m5 = so_5;
}

/* so = [Ad](R) si.
   R: rotation or other 3×3 matrix; si, so: screw (v in m/s; ω in rad/s).
   18 mul, 12 add.
   Error <= u |result| + 2 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_product_Adrs(const ksl_mat3x3_t *R, const ksl_screw_t *si, ksl_screw_t *so) {
  const double so_0 = KSL_MUL(R->m00, si->m0) + KSL_MUL(R->m01, si->m1) + KSL_MUL(R->m02, si->m2),
      so_1 = KSL_MUL(R->m10, si->m0) + KSL_MUL(R->m11, si->m1) + KSL_MUL(R->m12, si->m2),
      so_2 = KSL_MUL(R->m20, si->m0) + KSL_MUL(R->m21, si->m1) + KSL_MUL(R->m22, si->m2),
      so_3 = KSL_MUL(R->m00, si->m3) + KSL_MUL(R->m01, si->m4) + KSL_MUL(R->m02, si->m5),
      so_4 = KSL_MUL(R->m10, si->m3) + KSL_MUL(R->m11, si->m4) + KSL_MUL(R->m12, si->m5),
      so_5 = KSL_MUL(R->m20, si->m3) + KSL_MUL(R->m21, si->m4) + KSL_MUL(R->m22, si->m5);
  so->m0 = so_0;
  so->m1 = so_1;
  so->m2 = so_2;
  so->m3 = so_3;
  so->m4 = so_4;
  so->m5 = so_5;
}

/* so = [Ad](R)^-1 si.
   R: rotation or other 3×3 matrix; si, so: screw (v in m/s; ω in rad/s).
   18 mul, 12 add.
   Error <= u |result| + 2 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_product_Adrinvs(const ksl_mat3x3_t *R, const ksl_screw_t *si,
    ksl_screw_t *so) {
  const double so_0 = KSL_MUL(R->m00, si->m0) + KSL_MUL(R->m10, si->m1) + KSL_MUL(R->m20, si->m2),
      so_1 = KSL_MUL(R->m01, si->m0) + KSL_MUL(R->m11, si->m1) + KSL_MUL(R->m21, si->m2),
      so_2 = KSL_MUL(R->m02, si->m0) + KSL_MUL(R->m12, si->m1) + KSL_MUL(R->m22, si->m2),
      so_3 = KSL_MUL(R->m00, si->m3) + KSL_MUL(R->m10, si->m4) + KSL_MUL(R->m20, si->m5),
      so_4 = KSL_MUL(R->m01, si->m3) + KSL_MUL(R->m11, si->m4) + KSL_MUL(R->m21, si->m5),
      so_5 = KSL_MUL(R->m02, si->m3) + KSL_MUL(R->m12, si->m4) + KSL_MUL(R->m22, si->m5);
  so->m0 = so_0;
  so->m1 = so_1;
  so->m2 = so_2;
  so->m3 = so_3;
  so->m4 = so_4;
  so->m5 = so_5;
}

/* so = [Ad](R) (-si).
   R: rotation or other 3×3 matrix; si, so: screw (v in m/s; ω in rad/s).
   18 mul, 12 add, 6 neg.
   Error <= u |result| + 2 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_product_Adrsinv(const ksl_mat3x3_t *R, const ksl_screw_t *si,
    ksl_screw_t *so) {
  const double so_0 =
          -(KSL_MUL(R->m00, si->m0) + KSL_MUL(R->m01, si->m1) + KSL_MUL(R->m02, si->m2)),
      so_1 = -(KSL_MUL(R->m10, si->m0) + KSL_MUL(R->m11, si->m1) + KSL_MUL(R->m12, si->m2)),
      so_2 = -(KSL_MUL(R->m20, si->m0) + KSL_MUL(R->m21, si->m1) + KSL_MUL(R->m22, si->m2)),
      so_3 = -(KSL_MUL(R->m00, si->m3) + KSL_MUL(R->m01, si->m4) + KSL_MUL(R->m02, si->m5)),
      so_4 = -(KSL_MUL(R->m10, si->m3) + KSL_MUL(R->m11, si->m4) + KSL_MUL(R->m12, si->m5)),
      so_5 = -(KSL_MUL(R->m20, si->m3) + KSL_MUL(R->m21, si->m4) + KSL_MUL(R->m22, si->m5));
  so->m0 = so_0;
  so->m1 = so_1;
  so->m2 = so_2;
  so->m3 = so_3;
  so->m4 = so_4;
  so->m5 = so_5;
}

/* so = [Ad](D) si = [Ad](t) [Ad](R) si.
   D: displacement [R | t], R rotation, t in m; si, so: screw (v in m/s; ω in rad/s).
   24 mul, 18 add.
   Error <= u |result| + (lin: 5, ang: 2) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_Ads(const ksl_SE3_t *D, const ksl_screw_t *si, ksl_screw_t *so) {
  const double w_0 = KSL_MUL(D->m00, si->m0) + KSL_MUL(D->m01, si->m1) + KSL_MUL(D->m02, si->m2),
      w_1 = KSL_MUL(D->m10, si->m0) + KSL_MUL(D->m11, si->m1) + KSL_MUL(D->m12, si->m2),
      w_2 = KSL_MUL(D->m20, si->m0) + KSL_MUL(D->m21, si->m1) + KSL_MUL(D->m22, si->m2),
      w_3 = KSL_MUL(D->m00, si->m3) + KSL_MUL(D->m01, si->m4) + KSL_MUL(D->m02, si->m5),
      w_4 = KSL_MUL(D->m10, si->m3) + KSL_MUL(D->m11, si->m4) + KSL_MUL(D->m12, si->m5),
      w_5 = KSL_MUL(D->m20, si->m3) + KSL_MUL(D->m21, si->m4) + KSL_MUL(D->m22, si->m5);
  const double so_0 = KSL_MUL(D->m13, w_5) - KSL_MUL(D->m23, w_4) + w_0,
      so_1 = KSL_MUL(D->m23, w_3) - KSL_MUL(D->m03, w_5) + w_1,
      so_2 = KSL_MUL(D->m03, w_4) - KSL_MUL(D->m13, w_3) + w_2;
  so->m0 = so_0;
  so->m1 = so_1;
  so->m2 = so_2;
  so->m3 = w_3;
  so->m4 = w_4;
  so->m5 = w_5;
}

/* so = [Ad](D)^-1 si = [Ad](R^T) [Ad](-t) si.
   D: displacement [R | t], R rotation, t in m; si, so: screw (v in m/s; ω in rad/s).
   24 mul, 18 add.
   Error <= u |result| + (lin: 5, ang: 2) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_Adinvs(const ksl_SE3_t *D, const ksl_screw_t *si, ksl_screw_t *so) {
  const double w_0 = KSL_MUL(D->m23, si->m4) - KSL_MUL(D->m13, si->m5) + si->m0,
      w_1 = KSL_MUL(D->m03, si->m5) - KSL_MUL(D->m23, si->m3) + si->m1,
      w_2 = KSL_MUL(D->m13, si->m3) - KSL_MUL(D->m03, si->m4) + si->m2;
  const double so_0 = KSL_MUL(D->m00, w_0) + KSL_MUL(D->m10, w_1) + KSL_MUL(D->m20, w_2),
      so_1 = KSL_MUL(D->m01, w_0) + KSL_MUL(D->m11, w_1) + KSL_MUL(D->m21, w_2),
      so_2 = KSL_MUL(D->m02, w_0) + KSL_MUL(D->m12, w_1) + KSL_MUL(D->m22, w_2),
      so_3 = KSL_MUL(D->m00, si->m3) + KSL_MUL(D->m10, si->m4) + KSL_MUL(D->m20, si->m5),
      so_4 = KSL_MUL(D->m01, si->m3) + KSL_MUL(D->m11, si->m4) + KSL_MUL(D->m21, si->m5),
      so_5 = KSL_MUL(D->m02, si->m3) + KSL_MUL(D->m12, si->m4) + KSL_MUL(D->m22, si->m5);
  so->m0 = so_0;
  so->m1 = so_1;
  so->m2 = so_2;
  so->m3 = so_3;
  so->m4 = so_4;
  so->m5 = so_5;
}

/* so = [Ad](D) (-si).
   D: displacement [R | t], R rotation, t in m; si, so: screw (v in m/s; ω in rad/s).
   24 mul, 18 add, 6 neg.
   Error <= u |result| + (lin: 5, ang: 2) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_Adsinv(const ksl_SE3_t *D, const ksl_screw_t *si, ksl_screw_t *so) {
  const double w_0 = -(KSL_MUL(D->m00, si->m0) + KSL_MUL(D->m01, si->m1) + KSL_MUL(D->m02, si->m2)),
      w_1 = -(KSL_MUL(D->m10, si->m0) + KSL_MUL(D->m11, si->m1) + KSL_MUL(D->m12, si->m2)),
      w_2 = -(KSL_MUL(D->m20, si->m0) + KSL_MUL(D->m21, si->m1) + KSL_MUL(D->m22, si->m2)),
      w_3 = -(KSL_MUL(D->m00, si->m3) + KSL_MUL(D->m01, si->m4) + KSL_MUL(D->m02, si->m5)),
      w_4 = -(KSL_MUL(D->m10, si->m3) + KSL_MUL(D->m11, si->m4) + KSL_MUL(D->m12, si->m5)),
      w_5 = -(KSL_MUL(D->m20, si->m3) + KSL_MUL(D->m21, si->m4) + KSL_MUL(D->m22, si->m5));
  const double so_0 = KSL_MUL(D->m13, w_5) - KSL_MUL(D->m23, w_4) + w_0,
      so_1 = KSL_MUL(D->m23, w_3) - KSL_MUL(D->m03, w_5) + w_1,
      so_2 = KSL_MUL(D->m03, w_4) - KSL_MUL(D->m13, w_3) + w_2;
  so->m0 = so_0;
  so->m1 = so_1;
  so->m2 = so_2;
  so->m3 = w_3;
  so->m4 = w_4;
  so->m5 = w_5;
}

/* so = h_tx: column 0 of [Ad](D).
   D: displacement [R | t], R rotation, t in m; so: screw (v in m/s; ω in rad/s).
   No arithmetic.
   Exact. */
static inline void ksl_hstx(const ksl_SE3_t *D, ksl_screw_t *so) {
  const double D_m00 = D->m00;
  const double D_m10 = D->m10;
  const double D_m20 = D->m20;
  so->m0 = D_m00;
  so->m1 = D_m10;
  so->m2 = D_m20;
  so->m3 = 0.0;
  so->m4 = 0.0;
  so->m5 = 0.0;
}

/* so = h_ty: column 1 of [Ad](D).
   D: displacement [R | t], R rotation, t in m; so: screw (v in m/s; ω in rad/s).
   No arithmetic.
   Exact. */
static inline void ksl_hsty(const ksl_SE3_t *D, ksl_screw_t *so) {
  const double D_m01 = D->m01;
  const double D_m11 = D->m11;
  const double D_m21 = D->m21;
  so->m0 = D_m01;
  so->m1 = D_m11;
  so->m2 = D_m21;
  so->m3 = 0.0;
  so->m4 = 0.0;
  so->m5 = 0.0;
}

/* so = h_tz: column 2 of [Ad](D).
   D: displacement [R | t], R rotation, t in m; so: screw (v in m/s; ω in rad/s).
   No arithmetic.
   Exact. */
static inline void ksl_hstz(const ksl_SE3_t *D, ksl_screw_t *so) {
  const double D_m02 = D->m02;
  const double D_m12 = D->m12;
  const double D_m22 = D->m22;
  so->m0 = D_m02;
  so->m1 = D_m12;
  so->m2 = D_m22;
  so->m3 = 0.0;
  so->m4 = 0.0;
  so->m5 = 0.0;
}

/* so = h_rx: column 3 of [Ad](D).
   D: displacement [R | t], R rotation, t in m; so: screw (v in m/s; ω in rad/s).
   6 mul, 3 add.
   Error <= u |result| + (lin: 1, ang: 0) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_hsrx(const ksl_SE3_t *D, ksl_screw_t *so) {
  const double so_0 = KSL_MUL(D->m20, D->m13) - KSL_MUL(D->m10, D->m23),
      so_1 = KSL_MUL(D->m00, D->m23) - KSL_MUL(D->m20, D->m03),
      so_2 = KSL_MUL(D->m10, D->m03) - KSL_MUL(D->m00, D->m13);
  const double D_m00 = D->m00;
  const double D_m10 = D->m10;
  const double D_m20 = D->m20;
  so->m0 = so_0;
  so->m1 = so_1;
  so->m2 = so_2;
  so->m3 = D_m00;
  so->m4 = D_m10;
  so->m5 = D_m20;
}

/* so = h_ry: column 4 of [Ad](D).
   D: displacement [R | t], R rotation, t in m; so: screw (v in m/s; ω in rad/s).
   6 mul, 3 add.
   Error <= u |result| + (lin: 1, ang: 0) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_hsry(const ksl_SE3_t *D, ksl_screw_t *so) {
  const double so_0 = KSL_MUL(D->m21, D->m13) - KSL_MUL(D->m11, D->m23),
      so_1 = KSL_MUL(D->m01, D->m23) - KSL_MUL(D->m21, D->m03),
      so_2 = KSL_MUL(D->m11, D->m03) - KSL_MUL(D->m01, D->m13);
  const double D_m01 = D->m01;
  const double D_m11 = D->m11;
  const double D_m21 = D->m21;
  so->m0 = so_0;
  so->m1 = so_1;
  so->m2 = so_2;
  so->m3 = D_m01;
  so->m4 = D_m11;
  so->m5 = D_m21;
}

/* so = h_rz: column 5 of [Ad](D).
   D: displacement [R | t], R rotation, t in m; so: screw (v in m/s; ω in rad/s).
   6 mul, 3 add.
   Error <= u |result| + (lin: 1, ang: 0) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_hsrz(const ksl_SE3_t *D, ksl_screw_t *so) {
  const double so_0 = KSL_MUL(D->m22, D->m13) - KSL_MUL(D->m12, D->m23),
      so_1 = KSL_MUL(D->m02, D->m23) - KSL_MUL(D->m22, D->m03),
      so_2 = KSL_MUL(D->m12, D->m03) - KSL_MUL(D->m02, D->m13);
  const double D_m02 = D->m02;
  const double D_m12 = D->m12;
  const double D_m22 = D->m22;
  so->m0 = so_0;
  so->m1 = so_1;
  so->m2 = so_2;
  so->m3 = D_m02;
  so->m4 = D_m12;
  so->m5 = D_m22;
}

/* so = -h_tx: -column 0 of [Ad](D).
   D: displacement [R | t], R rotation, t in m; so: screw (v in m/s; ω in rad/s).
   3 neg.
   Exact. */
static inline void ksl_hstxinv(const ksl_SE3_t *D, ksl_screw_t *so) {
  const double so_0 = -D->m00, so_1 = -D->m10, so_2 = -D->m20;
  so->m0 = so_0;
  so->m1 = so_1;
  so->m2 = so_2;
  so->m3 = 0.0;
  so->m4 = 0.0;
  so->m5 = 0.0;
}

/* so = -h_ty: -column 1 of [Ad](D).
   D: displacement [R | t], R rotation, t in m; so: screw (v in m/s; ω in rad/s).
   3 neg.
   Exact. */
static inline void ksl_hstyinv(const ksl_SE3_t *D, ksl_screw_t *so) {
  const double so_0 = -D->m01, so_1 = -D->m11, so_2 = -D->m21;
  so->m0 = so_0;
  so->m1 = so_1;
  so->m2 = so_2;
  so->m3 = 0.0;
  so->m4 = 0.0;
  so->m5 = 0.0;
}

/* so = -h_tz: -column 2 of [Ad](D).
   D: displacement [R | t], R rotation, t in m; so: screw (v in m/s; ω in rad/s).
   3 neg.
   Exact. */
static inline void ksl_hstzinv(const ksl_SE3_t *D, ksl_screw_t *so) {
  const double so_0 = -D->m02, so_1 = -D->m12, so_2 = -D->m22;
  so->m0 = so_0;
  so->m1 = so_1;
  so->m2 = so_2;
  so->m3 = 0.0;
  so->m4 = 0.0;
  so->m5 = 0.0;
}

/* so = -h_rx: -column 3 of [Ad](D).
   D: displacement [R | t], R rotation, t in m; so: screw (v in m/s; ω in rad/s).
   6 mul, 3 add, 3 neg.
   Error <= u |result| + (lin: 1, ang: 0) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_hsrxinv(const ksl_SE3_t *D, ksl_screw_t *so) {
  const double so_0 = KSL_MUL(D->m10, D->m23) - KSL_MUL(D->m20, D->m13),
      so_1 = KSL_MUL(D->m20, D->m03) - KSL_MUL(D->m00, D->m23),
      so_2 = KSL_MUL(D->m00, D->m13) - KSL_MUL(D->m10, D->m03), so_3 = -D->m00, so_4 = -D->m10,
      so_5 = -D->m20;
  so->m0 = so_0;
  so->m1 = so_1;
  so->m2 = so_2;
  so->m3 = so_3;
  so->m4 = so_4;
  so->m5 = so_5;
}

/* so = -h_ry: -column 4 of [Ad](D).
   D: displacement [R | t], R rotation, t in m; so: screw (v in m/s; ω in rad/s).
   6 mul, 3 add, 3 neg.
   Error <= u |result| + (lin: 1, ang: 0) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_hsryinv(const ksl_SE3_t *D, ksl_screw_t *so) {
  const double so_0 = KSL_MUL(D->m11, D->m23) - KSL_MUL(D->m21, D->m13),
      so_1 = KSL_MUL(D->m21, D->m03) - KSL_MUL(D->m01, D->m23),
      so_2 = KSL_MUL(D->m01, D->m13) - KSL_MUL(D->m11, D->m03), so_3 = -D->m01, so_4 = -D->m11,
      so_5 = -D->m21;
  so->m0 = so_0;
  so->m1 = so_1;
  so->m2 = so_2;
  so->m3 = so_3;
  so->m4 = so_4;
  so->m5 = so_5;
}

/* so = -h_rz: -column 5 of [Ad](D).
   D: displacement [R | t], R rotation, t in m; so: screw (v in m/s; ω in rad/s).
   6 mul, 3 add, 3 neg.
   Error <= u |result| + (lin: 1, ang: 0) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_hsrzinv(const ksl_SE3_t *D, ksl_screw_t *so) {
  const double so_0 = KSL_MUL(D->m12, D->m23) - KSL_MUL(D->m22, D->m13),
      so_1 = KSL_MUL(D->m22, D->m03) - KSL_MUL(D->m02, D->m23),
      so_2 = KSL_MUL(D->m02, D->m13) - KSL_MUL(D->m12, D->m03), so_3 = -D->m02, so_4 = -D->m12,
      so_5 = -D->m22;
  so->m0 = so_0;
  so->m1 = so_1;
  so->m2 = so_2;
  so->m3 = so_3;
  so->m4 = so_4;
  so->m5 = so_5;
}

/* M = [Ad](D).
   D: displacement [R | t], R rotation, t in m; M: 6×6 operator.
   18 mul, 9 add.
   Error <= u |result| + 1 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_Ad(const ksl_SE3_t *D, ksl_mat6x6_t *M) {
  const double M_03 = KSL_MUL(D->m20, D->m13) - KSL_MUL(D->m10, D->m23),
      M_04 = KSL_MUL(D->m21, D->m13) - KSL_MUL(D->m11, D->m23),
      M_05 = KSL_MUL(D->m22, D->m13) - KSL_MUL(D->m12, D->m23),
      M_13 = KSL_MUL(D->m00, D->m23) - KSL_MUL(D->m20, D->m03),
      M_14 = KSL_MUL(D->m01, D->m23) - KSL_MUL(D->m21, D->m03),
      M_15 = KSL_MUL(D->m02, D->m23) - KSL_MUL(D->m22, D->m03),
      M_23 = KSL_MUL(D->m10, D->m03) - KSL_MUL(D->m00, D->m13),
      M_24 = KSL_MUL(D->m11, D->m03) - KSL_MUL(D->m01, D->m13),
      M_25 = KSL_MUL(D->m12, D->m03) - KSL_MUL(D->m02, D->m13);
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
}

/* power = f·v + τ·ω, in W.
   c: coscrew (f in N; τ in N m); s: screw (v in m/s; ω in rad/s).
   6 mul, 5 add.
   Error <= u |result| + 3 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline double ksl_dot_cs(const ksl_coscrew_t *c, const ksl_screw_t *s) {
  const double power_e = KSL_MUL(c->m0, s->m0) + KSL_MUL(c->m1, s->m1) + KSL_MUL(c->m2, s->m2),
      power = power_e + (KSL_MUL(c->m3, s->m3) + KSL_MUL(c->m4, s->m4) + KSL_MUL(c->m5, s->m5));
  return power;
}

/* so = [ad](s1) s2 = (ω1×v2 + v1×ω2 ; ω1×ω2).  Exactly zero for s1 = s2, unless products
     overflow.
   s1, s2, so: screw (v in m/s; ω in rad/s).
   18 mul, 12 add.
   Error <= u |result| + (lin: 2, ang: 1) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_cross_ss(const ksl_screw_t *s1, const ksl_screw_t *s2, ksl_screw_t *so) {
  const double so_0 = KSL_MUL(s1->m1, s2->m5) - KSL_MUL(s1->m5, s2->m1)
          + (KSL_MUL(s1->m4, s2->m2) - KSL_MUL(s1->m2, s2->m4)),
      so_1 = KSL_MUL(s1->m5, s2->m0) - KSL_MUL(s1->m0, s2->m5)
          + (KSL_MUL(s1->m2, s2->m3) - KSL_MUL(s1->m3, s2->m2)),
      so_2 = KSL_MUL(s1->m0, s2->m4) - KSL_MUL(s1->m4, s2->m0)
          + (KSL_MUL(s1->m3, s2->m1) - KSL_MUL(s1->m1, s2->m3)),
      so_3 = KSL_MUL(s1->m4, s2->m5) - KSL_MUL(s1->m5, s2->m4),
      so_4 = KSL_MUL(s1->m5, s2->m3) - KSL_MUL(s1->m3, s2->m5),
      so_5 = KSL_MUL(s1->m3, s2->m4) - KSL_MUL(s1->m4, s2->m3);
  so->m0 = so_0;
  so->m1 = so_1;
  so->m2 = so_2;
  so->m3 = so_3;
  so->m4 = so_4;
  so->m5 = so_5;
}

/* so = (ω1×v2 ; 0).
   s1, s2, so: screw (v in m/s; ω in rad/s).
   6 mul, 3 add.
   Error <= u |result| + (lin: 1, ang: 0) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_cross_sst(const ksl_screw_t *s1, const ksl_screw_t *s2, ksl_screw_t *so) {
  const double so_0 = KSL_MUL(s1->m4, s2->m2) - KSL_MUL(s1->m5, s2->m1),
      so_1 = KSL_MUL(s1->m5, s2->m0) - KSL_MUL(s1->m3, s2->m2),
      so_2 = KSL_MUL(s1->m3, s2->m1) - KSL_MUL(s1->m4, s2->m0);
  so->m0 = so_0;
  so->m1 = so_1;
  so->m2 = so_2;
  so->m3 = 0.0;
  so->m4 = 0.0;
  so->m5 = 0.0;
}

/* so = (t×R a ; R a), a = axis in the body's frame.
   D: displacement [R | t], R rotation, t in m; axis: vector; so: screw (v in m/s; ω in rad/s).
   15 mul, 9 add.
   Error <= u |result| + (lin: 4, ang: 2) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_hsra(const ksl_SE3_t *D, const ksl_vec3_t *axis, ksl_screw_t *so) {
  const double a_0 = KSL_MUL(D->m00, axis->x) + KSL_MUL(D->m01, axis->y) + KSL_MUL(D->m02, axis->z),
      a_1 = KSL_MUL(D->m10, axis->x) + KSL_MUL(D->m11, axis->y) + KSL_MUL(D->m12, axis->z),
      a_2 = KSL_MUL(D->m20, axis->x) + KSL_MUL(D->m21, axis->y) + KSL_MUL(D->m22, axis->z);
  const double so_0 = KSL_MUL(D->m13, a_2) - KSL_MUL(D->m23, a_1),
      so_1 = KSL_MUL(D->m23, a_0) - KSL_MUL(D->m03, a_2),
      so_2 = KSL_MUL(D->m03, a_1) - KSL_MUL(D->m13, a_0);
  so->m0 = so_0;
  so->m1 = so_1;
  so->m2 = so_2;
  so->m3 = a_0;
  so->m4 = a_1;
  so->m5 = a_2;
}

/* so = (R a ; 0), a = axis in the body's frame.
   D: displacement [R | t], R rotation, t in m; axis: vector; so: screw (v in m/s; ω in rad/s).
   9 mul, 6 add.
   Error <= u |result| + (lin: 2, ang: 0) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_hsta(const ksl_SE3_t *D, const ksl_vec3_t *axis, ksl_screw_t *so) {
  const double so_0 = KSL_MUL(D->m00, axis->x) + KSL_MUL(D->m01, axis->y)
          + KSL_MUL(D->m02, axis->z),
      so_1 = KSL_MUL(D->m10, axis->x) + KSL_MUL(D->m11, axis->y) + KSL_MUL(D->m12, axis->z),
      so_2 = KSL_MUL(D->m20, axis->x) + KSL_MUL(D->m21, axis->y) + KSL_MUL(D->m22, axis->z);
  so->m0 = so_0;
  so->m1 = so_1;
  so->m2 = so_2;
  so->m3 = 0.0;
  so->m4 = 0.0;
  so->m5 = 0.0;
}

/* so = -(t×R a ; R a), a = axis in the body's frame.
   D: displacement [R | t], R rotation, t in m; axis: vector; so: screw (v in m/s; ω in rad/s).
   15 mul, 9 add, 3 neg.
   Error <= u |result| + (lin: 4, ang: 2) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_hsrainv(const ksl_SE3_t *D, const ksl_vec3_t *axis, ksl_screw_t *so) {
  const double a_0 =
          -(KSL_MUL(D->m00, axis->x) + KSL_MUL(D->m01, axis->y) + KSL_MUL(D->m02, axis->z)),
      a_1 = -(KSL_MUL(D->m10, axis->x) + KSL_MUL(D->m11, axis->y) + KSL_MUL(D->m12, axis->z)),
      a_2 = -(KSL_MUL(D->m20, axis->x) + KSL_MUL(D->m21, axis->y) + KSL_MUL(D->m22, axis->z));
  const double so_0 = KSL_MUL(D->m13, a_2) - KSL_MUL(D->m23, a_1),
      so_1 = KSL_MUL(D->m23, a_0) - KSL_MUL(D->m03, a_2),
      so_2 = KSL_MUL(D->m03, a_1) - KSL_MUL(D->m13, a_0);
  so->m0 = so_0;
  so->m1 = so_1;
  so->m2 = so_2;
  so->m3 = a_0;
  so->m4 = a_1;
  so->m5 = a_2;
}

/* so = -(R a ; 0), a = axis in the body's frame.
   D: displacement [R | t], R rotation, t in m; axis: vector; so: screw (v in m/s; ω in rad/s).
   9 mul, 6 add, 3 neg.
   Error <= u |result| + (lin: 2, ang: 0) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_hstainv(const ksl_SE3_t *D, const ksl_vec3_t *axis, ksl_screw_t *so) {
  const double so_0 =
          -(KSL_MUL(D->m00, axis->x) + KSL_MUL(D->m01, axis->y) + KSL_MUL(D->m02, axis->z)),
      so_1 = -(KSL_MUL(D->m10, axis->x) + KSL_MUL(D->m11, axis->y) + KSL_MUL(D->m12, axis->z)),
      so_2 = -(KSL_MUL(D->m20, axis->x) + KSL_MUL(D->m21, axis->y) + KSL_MUL(D->m22, axis->z));
  so->m0 = so_0;
  so->m1 = so_1;
  so->m2 = so_2;
  so->m3 = 0.0;
  so->m4 = 0.0;
  so->m5 = 0.0;
}

/* M = [ad](s) = [Ad]' [Ad]^-1 = [[ω~, v~], [0, ω~]].
   s: screw (v in m/s; ω in rad/s); M: 6×6 operator.
   6 neg.
   Exact. */
static inline void ksl_ad(const ksl_screw_t *s, ksl_mat6x6_t *M) {
  const double M_01 = -s->m5, M_04 = -s->m2, M_12 = -s->m3, M_15 = -s->m0, M_20 = -s->m4,
      M_23 = -s->m1;
  const double s_m4 = s->m4;
  const double s_m1 = s->m1;
  const double s_m5 = s->m5;
  const double s_m2 = s->m2;
  const double s_m3 = s->m3;
  const double s_m0 = s->m0;
  M->at[0][0] = 0.0;
  M->at[1][0] = M_01;
  M->at[2][0] = s_m4;
  M->at[3][0] = 0.0;
  M->at[4][0] = M_04;
  M->at[5][0] = s_m1;
  M->at[0][1] = s_m5;
  M->at[1][1] = 0.0;
  M->at[2][1] = M_12;
  M->at[3][1] = s_m2;
  M->at[4][1] = 0.0;
  M->at[5][1] = M_15;
  M->at[0][2] = M_20;
  M->at[1][2] = s_m3;
  M->at[2][2] = 0.0;
  M->at[3][2] = M_23;
  M->at[4][2] = s_m0;
  M->at[5][2] = 0.0;
  M->at[0][3] = 0.0;
  M->at[1][3] = 0.0;
  M->at[2][3] = 0.0;
  M->at[3][3] = 0.0;
  M->at[4][3] = M_01;
  M->at[5][3] = s_m4;
  M->at[0][4] = 0.0;
  M->at[1][4] = 0.0;
  M->at[2][4] = 0.0;
  M->at[3][4] = s_m5;
  M->at[4][4] = 0.0;
  M->at[5][4] = M_12;
  M->at[0][5] = 0.0;
  M->at[1][5] = 0.0;
  M->at[2][5] = 0.0;
  M->at[3][5] = M_20;
  M->at[4][5] = s_m3;
  M->at[5][5] = 0.0;
}

/* The screw of these entries, in order. */
static inline ksl_screwf_t ksl_screwf(const float m0, const float m1, const float m2,
    const float m3, const float m4, const float m5) {
  ksl_screwf_t value;
  value.m0 = m0;
  value.m1 = m1;
  value.m2 = m2;
  value.m3 = m3;
  value.m4 = m4;
  value.m5 = m5;
  return value;
}

/* so = si.
   si, so: screw (v in m/s; ω in rad/s).
   No arithmetic.
   Exact. */
static inline void ksl_screwf_copy(const ksl_screwf_t *si, ksl_screwf_t *so) {
  const float si_m0 = si->m0;
  const float si_m1 = si->m1;
  const float si_m2 = si->m2;
  const float si_m3 = si->m3;
  const float si_m4 = si->m4;
  const float si_m5 = si->m5;
  so->m0 = si_m0;
  so->m1 = si_m1;
  so->m2 = si_m2;
  so->m3 = si_m3;
  so->m4 = si_m4;
  so->m5 = si_m5;
}

/* self = a self.
   self: screw (v in m/s; ω in rad/s); a: number.
   6 mul.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_screwf_scale(ksl_screwf_t *self, const float a) {
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

/* so = -si.
   si, so: screw (v in m/s; ω in rad/s).
   6 neg.
   Exact. */
static inline void ksl_screwf_inverted(const ksl_screwf_t *si, ksl_screwf_t *so) {
  const float so_0 = -si->m0, so_1 = -si->m1, so_2 = -si->m2, so_3 = -si->m3, so_4 = -si->m4,
      so_5 = -si->m5;
  so->m0 = so_0;
  so->m1 = so_1;
  so->m2 = so_2;
  so->m3 = so_3;
  so->m4 = so_4;
  so->m5 = so_5;
}

/* self = -self.
   self: screw (v in m/s; ω in rad/s).
   6 neg.
   Exact. */
static inline void ksl_screwf_invert(ksl_screwf_t *self) {
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
   a: number; x, y: screw (v in m/s; ω in rad/s).
   6 mul, 6 add.
   Error <= u |result| + 1 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_axpy_ssf(const float a, const ksl_screwf_t *x, ksl_screwf_t *y) {
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
   x, y: screw (v in m/s; ω in rad/s).
   6 add.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_xpy_ssf(const ksl_screwf_t *x, ksl_screwf_t *y) {
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
   x, y: screw (v in m/s; ω in rad/s).
   6 add.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_nxpy_ssf(const ksl_screwf_t *x, ksl_screwf_t *y) {
  const float y_0_new = y->m0 - x->m0, y_1_new = y->m1 - x->m1, y_2_new = y->m2 - x->m2,
      y_3_new = y->m3 - x->m3, y_4_new = y->m4 - x->m4, y_5_new = y->m5 - x->m5;
  y->m0 = y_0_new;
  y->m1 = y_1_new;
  y->m2 = y_2_new;
  y->m3 = y_3_new;
  y->m4 = y_4_new;
  y->m5 = y_5_new;
}

/* so = a si.
   a: number; si, so: screw (v in m/s; ω in rad/s).
   6 mul.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_product_asf(const float a, const ksl_screwf_t *si, ksl_screwf_t *so) {
  const float so_0 = KSL_MULF(a, si->m0), so_1 = KSL_MULF(a, si->m1), so_2 = KSL_MULF(a, si->m2),
      so_3 = KSL_MULF(a, si->m3), so_4 = KSL_MULF(a, si->m4), so_5 = KSL_MULF(a, si->m5);
  so->m0 = so_0;
  so->m1 = so_1;
  so->m2 = so_2;
  so->m3 = so_3;
  so->m4 = so_4;
  so->m5 = so_5;
}

/* so = s1 + s2.
   s1, s2, so: screw (v in m/s; ω in rad/s).
   6 add.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_add_ssf(const ksl_screwf_t *s1, const ksl_screwf_t *s2, ksl_screwf_t *so) {
  const float so_0 = s1->m0 + s2->m0, so_1 = s1->m1 + s2->m1, so_2 = s1->m2 + s2->m2,
      so_3 = s1->m3 + s2->m3, so_4 = s1->m4 + s2->m4, so_5 = s1->m5 + s2->m5;
  so->m0 = so_0;
  so->m1 = so_1;
  so->m2 = so_2;
  so->m3 = so_3;
  so->m4 = so_4;
  so->m5 = so_5;
}

/* so = s1 - s2.
   s1, s2, so: screw (v in m/s; ω in rad/s).
   6 add.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_subtract_ssf(const ksl_screwf_t *s1, const ksl_screwf_t *s2,
    ksl_screwf_t *so) {
  const float so_0 = s1->m0 - s2->m0, so_1 = s1->m1 - s2->m1, so_2 = s1->m2 - s2->m2,
      so_3 = s1->m3 - s2->m3, so_4 = s1->m4 - s2->m4, so_5 = s1->m5 - s2->m5;
  so->m0 = so_0;
  so->m1 = so_1;
  so->m2 = so_2;
  so->m3 = so_3;
  so->m4 = so_4;
  so->m5 = so_5;
}

/* |si|: |ω|, or |v| where every |ω_i| is below 1e-9 (single: 1e-6).
   si: screw (v in m/s; ω in rad/s).
   7 mul, 2 add, 1 sqrt, 6 abs, 11 less, 1 equal, 14 select. */
static inline float ksl_screwf_norm(const ksl_screwf_t *si) {
  const float small_c = fabsf(si->m5) < 1e-06f ? 1.0f : 0.0f,
      small_f = fabsf(si->m4) < 1e-06f ? small_c : 0.0f,
      small = fabsf(si->m3) < 1e-06f ? small_f : 0.0f;
  const float p_0 = small == 1.0f ? si->m0 : si->m3, p_1 = small == 1.0f ? si->m1 : si->m4,
      p_2 = small == 1.0f ? si->m2 : si->m5;
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

/* self = self / |self|, with screw_norm; the zero screw stays zero.
   self: screw (v in m/s; ω in rad/s).
   18 mul, 2 add, 6 div, 1 sqrt, 9 abs, 16 less, 2 equal, 26 select. */
static inline void ksl_screwf_normalize(ksl_screwf_t *self) {
  const float small_a = fabsf(self->m5), small_c = small_a < 1e-06f ? 1.0f : 0.0f,
      small_d = fabsf(self->m4), small_f = small_d < 1e-06f ? small_c : 0.0f,
      small_g = fabsf(self->m3), small = small_g < 1e-06f ? small_f : 0.0f;
  const float p_0 = small == 1.0f ? self->m0 : self->m3, p_1 = small == 1.0f ? self->m1 : self->m4,
      p_2 = small == 1.0f ? self->m2 : self->m5;
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
  const float size_0 = fabsf(self->m0), size_1 = fabsf(self->m1), size_2 = fabsf(self->m2);
  const float before_0 = size_0 < 256.0f ? up : down, before_1 = size_1 < 256.0f ? up : down,
      before_2 = size_2 < 256.0f ? up : down, before_3 = small_g < 256.0f ? up : down,
      before_4 = small_d < 256.0f ? up : down, before_5 = small_a < 256.0f ? up : down;
  const float after_0 = size_0 < 256.0f ? down : up, after_1 = size_1 < 256.0f ? down : up,
      after_2 = size_2 < 256.0f ? down : up, after_3 = small_g < 256.0f ? down : up,
      after_4 = small_d < 256.0f ? down : up, after_5 = small_a < 256.0f ? down : up;
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

/* so = si / |si|, with screw_norm; the zero screw stays zero.
   si, so: screw (v in m/s; ω in rad/s).
   18 mul, 2 add, 6 div, 1 sqrt, 9 abs, 16 less, 2 equal, 26 select. */
static inline void ksl_screwf_normalized(const ksl_screwf_t *si, ksl_screwf_t *so) {
  const float small_a = fabsf(si->m5), small_c = small_a < 1e-06f ? 1.0f : 0.0f,
      small_d = fabsf(si->m4), small_f = small_d < 1e-06f ? small_c : 0.0f, small_g = fabsf(si->m3),
      small = small_g < 1e-06f ? small_f : 0.0f;
  const float p_0 = small == 1.0f ? si->m0 : si->m3, p_1 = small == 1.0f ? si->m1 : si->m4,
      p_2 = small == 1.0f ? si->m2 : si->m5;
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
  const float size_0 = fabsf(si->m0), size_1 = fabsf(si->m1), size_2 = fabsf(si->m2);
  const float before_0 = size_0 < 256.0f ? up : down, before_1 = size_1 < 256.0f ? up : down,
      before_2 = size_2 < 256.0f ? up : down, before_3 = small_g < 256.0f ? up : down,
      before_4 = small_d < 256.0f ? up : down, before_5 = small_a < 256.0f ? up : down;
  const float after_0 = size_0 < 256.0f ? down : up, after_1 = size_1 < 256.0f ? down : up,
      after_2 = size_2 < 256.0f ? down : up, after_3 = small_g < 256.0f ? down : up,
      after_4 = small_d < 256.0f ? down : up, after_5 = small_a < 256.0f ? down : up;
  const float sized_0 = KSL_MULF(si->m0, before_0), sized_1 = KSL_MULF(si->m1, before_1),
      sized_2 = KSL_MULF(si->m2, before_2), sized_3 = KSL_MULF(si->m3, before_3),
      sized_4 = KSL_MULF(si->m4, before_4), sized_5 = KSL_MULF(si->m5, before_5);
  const float quotient_0 = sized_0 / divisor, quotient_1 = sized_1 / divisor,
      quotient_2 = sized_2 / divisor, quotient_3 = sized_3 / divisor,
      quotient_4 = sized_4 / divisor, quotient_5 = sized_5 / divisor;
  const float so_0 = KSL_MULF(quotient_0, after_0), so_1 = KSL_MULF(quotient_1, after_1),
      so_2 = KSL_MULF(quotient_2, after_2), so_3 = KSL_MULF(quotient_3, after_3),
      so_4 = KSL_MULF(quotient_4, after_4), so_5 = KSL_MULF(quotient_5, after_5);
  so->m0 = so_0;
  so->m1 = so_1;
  so->m2 = so_2;
  so->m3 = so_3;
  so->m4 = so_4;
  so->m5 = so_5;
}

/* so = (lin; ang).
   lin, ang: vector; so: screw (v in m/s; ω in rad/s).
   No arithmetic.
   Exact. */
static inline void ksl_screwf_from_lin_ang(const ksl_vec3f_t *lin, const ksl_vec3f_t *ang,
    ksl_screwf_t *so) {
  const float lin_x = lin->x;
  const float lin_y = lin->y;
  const float lin_z = lin->z;
  const float ang_x = ang->x;
  const float ang_y = ang->y;
  const float ang_z = ang->z;
  so->m0 = lin_x;
  so->m1 = lin_y;
  so->m2 = lin_z;
  so->m3 = ang_x;
  so->m4 = ang_y;
  so->m5 = ang_z;
}

/* x = (ang; lin) of si.
   si: screw (v in m/s; ω in rad/s); x: six components with the angular part on top.
   No arithmetic.
   Exact. */
static inline void ksl_screwf_to_angular_first(const ksl_screwf_t *si, float x[6]) {
  const float si_m3 = si->m3;
  const float si_m4 = si->m4;
  const float si_m5 = si->m5;
  const float si_m0 = si->m0;
  const float si_m1 = si->m1;
  const float si_m2 = si->m2;
  x[0] = si_m3;
  x[1] = si_m4;
  x[2] = si_m5;
  x[3] = si_m0;
  x[4] = si_m1;
  x[5] = si_m2;
}

/* so = (lin; ang) of x = (ang; lin).
   x: six components with the angular part on top; so: screw (v in m/s; ω in rad/s).
   No arithmetic.
   Exact. */
static inline void ksl_screwf_from_angular_first(const float x[6], ksl_screwf_t *so) {
  const float x_3 = x[3];
  const float x_4 = x[4];
  const float x_5 = x[5];
  const float x_0 = x[0];
  const float x_1 = x[1];
  const float x_2 = x[2];
  so->m0 = x_3;
  so->m1 = x_4;
  so->m2 = x_5;
  so->m3 = x_0;
  so->m4 = x_1;
  so->m5 = x_2;
}

/* so = (s1.lin + s2.lin ; s1.ang).
   s1, s2, so: screw (v in m/s; ω in rad/s).
   3 add.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_add_sstf(const ksl_screwf_t *s1, const ksl_screwf_t *s2, ksl_screwf_t *so) {
  const float so_0 = s1->m0 + s2->m0, so_1 = s1->m1 + s2->m1, so_2 = s1->m2 + s2->m2;
  const float s1_m3 = s1->m3;
  const float s1_m4 = s1->m4;
  const float s1_m5 = s1->m5;
  so->m0 = so_0;
  so->m1 = so_1;
  so->m2 = so_2;
  so->m3 = s1_m3;
  so->m4 = s1_m4;
  so->m5 = s1_m5;
}

/* so = [Ad](t) si.
   t: vector; si, so: screw (v in m/s; ω in rad/s).
   6 mul, 6 add.
   Error <= u |result| + (lin: 2, ang: 0) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_Adtsf(const ksl_vec3f_t *t, const ksl_screwf_t *si,
    ksl_screwf_t *so) {
  const float so_0 = KSL_MULF(t->y, si->m5) - KSL_MULF(t->z, si->m4) + si->m0,
      so_1 = KSL_MULF(t->z, si->m3) - KSL_MULF(t->x, si->m5) + si->m1,
      so_2 = KSL_MULF(t->x, si->m4) - KSL_MULF(t->y, si->m3) + si->m2;
  const float si_m3 = si->m3;
  const float si_m4 = si->m4;
  const float si_m5 = si->m5;
  so->m0 = so_0;
  so->m1 = so_1;
  so->m2 = so_2;
  so->m3 = si_m3;
  so->m4 = si_m4;
  so->m5 = si_m5;
}

/* so = [Ad](t)^-1 si.
   t: vector; si, so: screw (v in m/s; ω in rad/s).
   6 mul, 6 add.
   Error <= u |result| + (lin: 2, ang: 0) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_Adtinvsf(const ksl_vec3f_t *t, const ksl_screwf_t *si,
    ksl_screwf_t *so) {
  const float so_0 = KSL_MULF(t->z, si->m4) - KSL_MULF(t->y, si->m5) + si->m0,
      so_1 = KSL_MULF(t->x, si->m5) - KSL_MULF(t->z, si->m3) + si->m1,
      so_2 = KSL_MULF(t->y, si->m3) - KSL_MULF(t->x, si->m4) + si->m2;
  const float si_m3 = si->m3;
  const float si_m4 = si->m4;
  const float si_m5 = si->m5;
  so->m0 = so_0;
  so->m1 = so_1;
  so->m2 = so_2;
  so->m3 = si_m3;
  so->m4 = si_m4;
  so->m5 = si_m5;
}

/* so = [Ad](t) (-si).
   t: vector; si, so: screw (v in m/s; ω in rad/s).
   6 mul, 6 add, 3 neg.
   Error <= u |result| + (lin: 2, ang: 0) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_Adtsinvf(const ksl_vec3f_t *t, const ksl_screwf_t *si,
    ksl_screwf_t *so) {
  const float so_0 = KSL_MULF(t->z, si->m4) - KSL_MULF(t->y, si->m5) - si->m0,
      so_1 = KSL_MULF(t->x, si->m5) - KSL_MULF(t->z, si->m3) - si->m1,
      so_2 = KSL_MULF(t->y, si->m3) - KSL_MULF(t->x, si->m4) - si->m2, so_3 = -si->m3,
      so_4 = -si->m4, so_5 = -si->m5;
  so->m0 = so_0;
  so->m1 = so_1;
  so->m2 = so_2;
  so->m3 = so_3;
  so->m4 = so_4;
  so->m5 = so_5;
}

/* so = [Ad](R) si.
   R: rotation or other 3×3 matrix; si, so: screw (v in m/s; ω in rad/s).
   18 mul, 12 add.
   Error <= u |result| + 2 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_product_Adrsf(const ksl_mat3x3f_t *R, const ksl_screwf_t *si,
    ksl_screwf_t *so) {
  const float so_0 = KSL_MULF(R->m00, si->m0) + KSL_MULF(R->m01, si->m1) + KSL_MULF(R->m02, si->m2),
      so_1 = KSL_MULF(R->m10, si->m0) + KSL_MULF(R->m11, si->m1) + KSL_MULF(R->m12, si->m2),
      so_2 = KSL_MULF(R->m20, si->m0) + KSL_MULF(R->m21, si->m1) + KSL_MULF(R->m22, si->m2),
      so_3 = KSL_MULF(R->m00, si->m3) + KSL_MULF(R->m01, si->m4) + KSL_MULF(R->m02, si->m5),
      so_4 = KSL_MULF(R->m10, si->m3) + KSL_MULF(R->m11, si->m4) + KSL_MULF(R->m12, si->m5),
      so_5 = KSL_MULF(R->m20, si->m3) + KSL_MULF(R->m21, si->m4) + KSL_MULF(R->m22, si->m5);
  so->m0 = so_0;
  so->m1 = so_1;
  so->m2 = so_2;
  so->m3 = so_3;
  so->m4 = so_4;
  so->m5 = so_5;
}

/* so = [Ad](R)^-1 si.
   R: rotation or other 3×3 matrix; si, so: screw (v in m/s; ω in rad/s).
   18 mul, 12 add.
   Error <= u |result| + 2 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_product_Adrinvsf(const ksl_mat3x3f_t *R, const ksl_screwf_t *si,
    ksl_screwf_t *so) {
  const float so_0 = KSL_MULF(R->m00, si->m0) + KSL_MULF(R->m10, si->m1) + KSL_MULF(R->m20, si->m2),
      so_1 = KSL_MULF(R->m01, si->m0) + KSL_MULF(R->m11, si->m1) + KSL_MULF(R->m21, si->m2),
      so_2 = KSL_MULF(R->m02, si->m0) + KSL_MULF(R->m12, si->m1) + KSL_MULF(R->m22, si->m2),
      so_3 = KSL_MULF(R->m00, si->m3) + KSL_MULF(R->m10, si->m4) + KSL_MULF(R->m20, si->m5),
      so_4 = KSL_MULF(R->m01, si->m3) + KSL_MULF(R->m11, si->m4) + KSL_MULF(R->m21, si->m5),
      so_5 = KSL_MULF(R->m02, si->m3) + KSL_MULF(R->m12, si->m4) + KSL_MULF(R->m22, si->m5);
  so->m0 = so_0;
  so->m1 = so_1;
  so->m2 = so_2;
  so->m3 = so_3;
  so->m4 = so_4;
  so->m5 = so_5;
}

/* so = [Ad](R) (-si).
   R: rotation or other 3×3 matrix; si, so: screw (v in m/s; ω in rad/s).
   18 mul, 12 add, 6 neg.
   Error <= u |result| + 2 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_product_Adrsinvf(const ksl_mat3x3f_t *R, const ksl_screwf_t *si,
    ksl_screwf_t *so) {
  const float so_0 =
          -(KSL_MULF(R->m00, si->m0) + KSL_MULF(R->m01, si->m1) + KSL_MULF(R->m02, si->m2)),
      so_1 = -(KSL_MULF(R->m10, si->m0) + KSL_MULF(R->m11, si->m1) + KSL_MULF(R->m12, si->m2)),
      so_2 = -(KSL_MULF(R->m20, si->m0) + KSL_MULF(R->m21, si->m1) + KSL_MULF(R->m22, si->m2)),
      so_3 = -(KSL_MULF(R->m00, si->m3) + KSL_MULF(R->m01, si->m4) + KSL_MULF(R->m02, si->m5)),
      so_4 = -(KSL_MULF(R->m10, si->m3) + KSL_MULF(R->m11, si->m4) + KSL_MULF(R->m12, si->m5)),
      so_5 = -(KSL_MULF(R->m20, si->m3) + KSL_MULF(R->m21, si->m4) + KSL_MULF(R->m22, si->m5));
  so->m0 = so_0;
  so->m1 = so_1;
  so->m2 = so_2;
  so->m3 = so_3;
  so->m4 = so_4;
  so->m5 = so_5;
}

/* so = [Ad](D) si = [Ad](t) [Ad](R) si.
   D: displacement [R | t], R rotation, t in m; si, so: screw (v in m/s; ω in rad/s).
   24 mul, 18 add.
   Error <= u |result| + (lin: 5, ang: 2) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_Adsf(const ksl_SE3f_t *D, const ksl_screwf_t *si, ksl_screwf_t *so) {
  const float w_0 = KSL_MULF(D->m00, si->m0) + KSL_MULF(D->m01, si->m1) + KSL_MULF(D->m02, si->m2),
      w_1 = KSL_MULF(D->m10, si->m0) + KSL_MULF(D->m11, si->m1) + KSL_MULF(D->m12, si->m2),
      w_2 = KSL_MULF(D->m20, si->m0) + KSL_MULF(D->m21, si->m1) + KSL_MULF(D->m22, si->m2),
      w_3 = KSL_MULF(D->m00, si->m3) + KSL_MULF(D->m01, si->m4) + KSL_MULF(D->m02, si->m5),
      w_4 = KSL_MULF(D->m10, si->m3) + KSL_MULF(D->m11, si->m4) + KSL_MULF(D->m12, si->m5),
      w_5 = KSL_MULF(D->m20, si->m3) + KSL_MULF(D->m21, si->m4) + KSL_MULF(D->m22, si->m5);
  const float so_0 = KSL_MULF(D->m13, w_5) - KSL_MULF(D->m23, w_4) + w_0,
      so_1 = KSL_MULF(D->m23, w_3) - KSL_MULF(D->m03, w_5) + w_1,
      so_2 = KSL_MULF(D->m03, w_4) - KSL_MULF(D->m13, w_3) + w_2;
  so->m0 = so_0;
  so->m1 = so_1;
  so->m2 = so_2;
  so->m3 = w_3;
  so->m4 = w_4;
  so->m5 = w_5;
}

/* so = [Ad](D)^-1 si = [Ad](R^T) [Ad](-t) si.
   D: displacement [R | t], R rotation, t in m; si, so: screw (v in m/s; ω in rad/s).
   24 mul, 18 add.
   Error <= u |result| + (lin: 5, ang: 2) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_Adinvsf(const ksl_SE3f_t *D, const ksl_screwf_t *si,
    ksl_screwf_t *so) {
  const float w_0 = KSL_MULF(D->m23, si->m4) - KSL_MULF(D->m13, si->m5) + si->m0,
      w_1 = KSL_MULF(D->m03, si->m5) - KSL_MULF(D->m23, si->m3) + si->m1,
      w_2 = KSL_MULF(D->m13, si->m3) - KSL_MULF(D->m03, si->m4) + si->m2;
  const float so_0 = KSL_MULF(D->m00, w_0) + KSL_MULF(D->m10, w_1) + KSL_MULF(D->m20, w_2),
      so_1 = KSL_MULF(D->m01, w_0) + KSL_MULF(D->m11, w_1) + KSL_MULF(D->m21, w_2),
      so_2 = KSL_MULF(D->m02, w_0) + KSL_MULF(D->m12, w_1) + KSL_MULF(D->m22, w_2),
      so_3 = KSL_MULF(D->m00, si->m3) + KSL_MULF(D->m10, si->m4) + KSL_MULF(D->m20, si->m5),
      so_4 = KSL_MULF(D->m01, si->m3) + KSL_MULF(D->m11, si->m4) + KSL_MULF(D->m21, si->m5),
      so_5 = KSL_MULF(D->m02, si->m3) + KSL_MULF(D->m12, si->m4) + KSL_MULF(D->m22, si->m5);
  so->m0 = so_0;
  so->m1 = so_1;
  so->m2 = so_2;
  so->m3 = so_3;
  so->m4 = so_4;
  so->m5 = so_5;
}

/* so = [Ad](D) (-si).
   D: displacement [R | t], R rotation, t in m; si, so: screw (v in m/s; ω in rad/s).
   24 mul, 18 add, 6 neg.
   Error <= u |result| + (lin: 5, ang: 2) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_Adsinvf(const ksl_SE3f_t *D, const ksl_screwf_t *si,
    ksl_screwf_t *so) {
  const float w_0 =
          -(KSL_MULF(D->m00, si->m0) + KSL_MULF(D->m01, si->m1) + KSL_MULF(D->m02, si->m2)),
      w_1 = -(KSL_MULF(D->m10, si->m0) + KSL_MULF(D->m11, si->m1) + KSL_MULF(D->m12, si->m2)),
      w_2 = -(KSL_MULF(D->m20, si->m0) + KSL_MULF(D->m21, si->m1) + KSL_MULF(D->m22, si->m2)),
      w_3 = -(KSL_MULF(D->m00, si->m3) + KSL_MULF(D->m01, si->m4) + KSL_MULF(D->m02, si->m5)),
      w_4 = -(KSL_MULF(D->m10, si->m3) + KSL_MULF(D->m11, si->m4) + KSL_MULF(D->m12, si->m5)),
      w_5 = -(KSL_MULF(D->m20, si->m3) + KSL_MULF(D->m21, si->m4) + KSL_MULF(D->m22, si->m5));
  const float so_0 = KSL_MULF(D->m13, w_5) - KSL_MULF(D->m23, w_4) + w_0,
      so_1 = KSL_MULF(D->m23, w_3) - KSL_MULF(D->m03, w_5) + w_1,
      so_2 = KSL_MULF(D->m03, w_4) - KSL_MULF(D->m13, w_3) + w_2;
  so->m0 = so_0;
  so->m1 = so_1;
  so->m2 = so_2;
  so->m3 = w_3;
  so->m4 = w_4;
  so->m5 = w_5;
}

/* so = h_tx: column 0 of [Ad](D).
   D: displacement [R | t], R rotation, t in m; so: screw (v in m/s; ω in rad/s).
   No arithmetic.
   Exact. */
static inline void ksl_hstxf(const ksl_SE3f_t *D, ksl_screwf_t *so) {
  const float D_m00 = D->m00;
  const float D_m10 = D->m10;
  const float D_m20 = D->m20;
  so->m0 = D_m00;
  so->m1 = D_m10;
  so->m2 = D_m20;
  so->m3 = 0.0f;
  so->m4 = 0.0f;
  so->m5 = 0.0f;
}

/* so = h_ty: column 1 of [Ad](D).
   D: displacement [R | t], R rotation, t in m; so: screw (v in m/s; ω in rad/s).
   No arithmetic.
   Exact. */
static inline void ksl_hstyf(const ksl_SE3f_t *D, ksl_screwf_t *so) {
  const float D_m01 = D->m01;
  const float D_m11 = D->m11;
  const float D_m21 = D->m21;
  so->m0 = D_m01;
  so->m1 = D_m11;
  so->m2 = D_m21;
  so->m3 = 0.0f;
  so->m4 = 0.0f;
  so->m5 = 0.0f;
}

/* so = h_tz: column 2 of [Ad](D).
   D: displacement [R | t], R rotation, t in m; so: screw (v in m/s; ω in rad/s).
   No arithmetic.
   Exact. */
static inline void ksl_hstzf(const ksl_SE3f_t *D, ksl_screwf_t *so) {
  const float D_m02 = D->m02;
  const float D_m12 = D->m12;
  const float D_m22 = D->m22;
  so->m0 = D_m02;
  so->m1 = D_m12;
  so->m2 = D_m22;
  so->m3 = 0.0f;
  so->m4 = 0.0f;
  so->m5 = 0.0f;
}

/* so = h_rx: column 3 of [Ad](D).
   D: displacement [R | t], R rotation, t in m; so: screw (v in m/s; ω in rad/s).
   6 mul, 3 add.
   Error <= u |result| + (lin: 1, ang: 0) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_hsrxf(const ksl_SE3f_t *D, ksl_screwf_t *so) {
  const float so_0 = KSL_MULF(D->m20, D->m13) - KSL_MULF(D->m10, D->m23),
      so_1 = KSL_MULF(D->m00, D->m23) - KSL_MULF(D->m20, D->m03),
      so_2 = KSL_MULF(D->m10, D->m03) - KSL_MULF(D->m00, D->m13);
  const float D_m00 = D->m00;
  const float D_m10 = D->m10;
  const float D_m20 = D->m20;
  so->m0 = so_0;
  so->m1 = so_1;
  so->m2 = so_2;
  so->m3 = D_m00;
  so->m4 = D_m10;
  so->m5 = D_m20;
}

/* so = h_ry: column 4 of [Ad](D).
   D: displacement [R | t], R rotation, t in m; so: screw (v in m/s; ω in rad/s).
   6 mul, 3 add.
   Error <= u |result| + (lin: 1, ang: 0) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_hsryf(const ksl_SE3f_t *D, ksl_screwf_t *so) {
  const float so_0 = KSL_MULF(D->m21, D->m13) - KSL_MULF(D->m11, D->m23),
      so_1 = KSL_MULF(D->m01, D->m23) - KSL_MULF(D->m21, D->m03),
      so_2 = KSL_MULF(D->m11, D->m03) - KSL_MULF(D->m01, D->m13);
  const float D_m01 = D->m01;
  const float D_m11 = D->m11;
  const float D_m21 = D->m21;
  so->m0 = so_0;
  so->m1 = so_1;
  so->m2 = so_2;
  so->m3 = D_m01;
  so->m4 = D_m11;
  so->m5 = D_m21;
}

/* so = h_rz: column 5 of [Ad](D).
   D: displacement [R | t], R rotation, t in m; so: screw (v in m/s; ω in rad/s).
   6 mul, 3 add.
   Error <= u |result| + (lin: 1, ang: 0) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_hsrzf(const ksl_SE3f_t *D, ksl_screwf_t *so) {
  const float so_0 = KSL_MULF(D->m22, D->m13) - KSL_MULF(D->m12, D->m23),
      so_1 = KSL_MULF(D->m02, D->m23) - KSL_MULF(D->m22, D->m03),
      so_2 = KSL_MULF(D->m12, D->m03) - KSL_MULF(D->m02, D->m13);
  const float D_m02 = D->m02;
  const float D_m12 = D->m12;
  const float D_m22 = D->m22;
  so->m0 = so_0;
  so->m1 = so_1;
  so->m2 = so_2;
  so->m3 = D_m02;
  so->m4 = D_m12;
  so->m5 = D_m22;
}

/* so = -h_tx: -column 0 of [Ad](D).
   D: displacement [R | t], R rotation, t in m; so: screw (v in m/s; ω in rad/s).
   3 neg.
   Exact. */
static inline void ksl_hstxinvf(const ksl_SE3f_t *D, ksl_screwf_t *so) {
  const float so_0 = -D->m00, so_1 = -D->m10, so_2 = -D->m20;
  so->m0 = so_0;
  so->m1 = so_1;
  so->m2 = so_2;
  so->m3 = 0.0f;
  so->m4 = 0.0f;
  so->m5 = 0.0f;
}

/* so = -h_ty: -column 1 of [Ad](D).
   D: displacement [R | t], R rotation, t in m; so: screw (v in m/s; ω in rad/s).
   3 neg.
   Exact. */
static inline void ksl_hstyinvf(const ksl_SE3f_t *D, ksl_screwf_t *so) {
  const float so_0 = -D->m01, so_1 = -D->m11, so_2 = -D->m21;
  so->m0 = so_0;
  so->m1 = so_1;
  so->m2 = so_2;
  so->m3 = 0.0f;
  so->m4 = 0.0f;
  so->m5 = 0.0f;
}

/* so = -h_tz: -column 2 of [Ad](D).
   D: displacement [R | t], R rotation, t in m; so: screw (v in m/s; ω in rad/s).
   3 neg.
   Exact. */
static inline void ksl_hstzinvf(const ksl_SE3f_t *D, ksl_screwf_t *so) {
  const float so_0 = -D->m02, so_1 = -D->m12, so_2 = -D->m22;
  so->m0 = so_0;
  so->m1 = so_1;
  so->m2 = so_2;
  so->m3 = 0.0f;
  so->m4 = 0.0f;
  so->m5 = 0.0f;
}

/* so = -h_rx: -column 3 of [Ad](D).
   D: displacement [R | t], R rotation, t in m; so: screw (v in m/s; ω in rad/s).
   6 mul, 3 add, 3 neg.
   Error <= u |result| + (lin: 1, ang: 0) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_hsrxinvf(const ksl_SE3f_t *D, ksl_screwf_t *so) {
  const float so_0 = KSL_MULF(D->m10, D->m23) - KSL_MULF(D->m20, D->m13),
      so_1 = KSL_MULF(D->m20, D->m03) - KSL_MULF(D->m00, D->m23),
      so_2 = KSL_MULF(D->m00, D->m13) - KSL_MULF(D->m10, D->m03), so_3 = -D->m00, so_4 = -D->m10,
      so_5 = -D->m20;
  so->m0 = so_0;
  so->m1 = so_1;
  so->m2 = so_2;
  so->m3 = so_3;
  so->m4 = so_4;
  so->m5 = so_5;
}

/* so = -h_ry: -column 4 of [Ad](D).
   D: displacement [R | t], R rotation, t in m; so: screw (v in m/s; ω in rad/s).
   6 mul, 3 add, 3 neg.
   Error <= u |result| + (lin: 1, ang: 0) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_hsryinvf(const ksl_SE3f_t *D, ksl_screwf_t *so) {
  const float so_0 = KSL_MULF(D->m11, D->m23) - KSL_MULF(D->m21, D->m13),
      so_1 = KSL_MULF(D->m21, D->m03) - KSL_MULF(D->m01, D->m23),
      so_2 = KSL_MULF(D->m01, D->m13) - KSL_MULF(D->m11, D->m03), so_3 = -D->m01, so_4 = -D->m11,
      so_5 = -D->m21;
  so->m0 = so_0;
  so->m1 = so_1;
  so->m2 = so_2;
  so->m3 = so_3;
  so->m4 = so_4;
  so->m5 = so_5;
}

/* so = -h_rz: -column 5 of [Ad](D).
   D: displacement [R | t], R rotation, t in m; so: screw (v in m/s; ω in rad/s).
   6 mul, 3 add, 3 neg.
   Error <= u |result| + (lin: 1, ang: 0) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_hsrzinvf(const ksl_SE3f_t *D, ksl_screwf_t *so) {
  const float so_0 = KSL_MULF(D->m12, D->m23) - KSL_MULF(D->m22, D->m13),
      so_1 = KSL_MULF(D->m22, D->m03) - KSL_MULF(D->m02, D->m23),
      so_2 = KSL_MULF(D->m02, D->m13) - KSL_MULF(D->m12, D->m03), so_3 = -D->m02, so_4 = -D->m12,
      so_5 = -D->m22;
  so->m0 = so_0;
  so->m1 = so_1;
  so->m2 = so_2;
  so->m3 = so_3;
  so->m4 = so_4;
  so->m5 = so_5;
}

/* M = [Ad](D).
   D: displacement [R | t], R rotation, t in m; M: 6×6 operator.
   18 mul, 9 add.
   Error <= u |result| + 1 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_Adf(const ksl_SE3f_t *D, ksl_mat6x6f_t *M) {
  const float M_03 = KSL_MULF(D->m20, D->m13) - KSL_MULF(D->m10, D->m23),
      M_04 = KSL_MULF(D->m21, D->m13) - KSL_MULF(D->m11, D->m23),
      M_05 = KSL_MULF(D->m22, D->m13) - KSL_MULF(D->m12, D->m23),
      M_13 = KSL_MULF(D->m00, D->m23) - KSL_MULF(D->m20, D->m03),
      M_14 = KSL_MULF(D->m01, D->m23) - KSL_MULF(D->m21, D->m03),
      M_15 = KSL_MULF(D->m02, D->m23) - KSL_MULF(D->m22, D->m03),
      M_23 = KSL_MULF(D->m10, D->m03) - KSL_MULF(D->m00, D->m13),
      M_24 = KSL_MULF(D->m11, D->m03) - KSL_MULF(D->m01, D->m13),
      M_25 = KSL_MULF(D->m12, D->m03) - KSL_MULF(D->m02, D->m13);
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
}

/* power = f·v + τ·ω, in W.
   c: coscrew (f in N; τ in N m); s: screw (v in m/s; ω in rad/s).
   6 mul, 5 add.
   Error <= u |result| + 3 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline float ksl_dot_csf(const ksl_coscrewf_t *c, const ksl_screwf_t *s) {
  const float power_e = KSL_MULF(c->m0, s->m0) + KSL_MULF(c->m1, s->m1) + KSL_MULF(c->m2, s->m2),
      power = power_e + (KSL_MULF(c->m3, s->m3) + KSL_MULF(c->m4, s->m4) + KSL_MULF(c->m5, s->m5));
  return power;
}

/* so = [ad](s1) s2 = (ω1×v2 + v1×ω2 ; ω1×ω2).  Exactly zero for s1 = s2, unless products
     overflow.
   s1, s2, so: screw (v in m/s; ω in rad/s).
   18 mul, 12 add.
   Error <= u |result| + (lin: 2, ang: 1) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_cross_ssf(const ksl_screwf_t *s1, const ksl_screwf_t *s2, ksl_screwf_t *so) {
  const float so_0 = KSL_MULF(s1->m1, s2->m5) - KSL_MULF(s1->m5, s2->m1)
          + (KSL_MULF(s1->m4, s2->m2) - KSL_MULF(s1->m2, s2->m4)),
      so_1 = KSL_MULF(s1->m5, s2->m0) - KSL_MULF(s1->m0, s2->m5)
          + (KSL_MULF(s1->m2, s2->m3) - KSL_MULF(s1->m3, s2->m2)),
      so_2 = KSL_MULF(s1->m0, s2->m4) - KSL_MULF(s1->m4, s2->m0)
          + (KSL_MULF(s1->m3, s2->m1) - KSL_MULF(s1->m1, s2->m3)),
      so_3 = KSL_MULF(s1->m4, s2->m5) - KSL_MULF(s1->m5, s2->m4),
      so_4 = KSL_MULF(s1->m5, s2->m3) - KSL_MULF(s1->m3, s2->m5),
      so_5 = KSL_MULF(s1->m3, s2->m4) - KSL_MULF(s1->m4, s2->m3);
  so->m0 = so_0;
  so->m1 = so_1;
  so->m2 = so_2;
  so->m3 = so_3;
  so->m4 = so_4;
  so->m5 = so_5;
}

/* so = (ω1×v2 ; 0).
   s1, s2, so: screw (v in m/s; ω in rad/s).
   6 mul, 3 add.
   Error <= u |result| + (lin: 1, ang: 0) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_cross_sstf(const ksl_screwf_t *s1, const ksl_screwf_t *s2,
    ksl_screwf_t *so) {
  const float so_0 = KSL_MULF(s1->m4, s2->m2) - KSL_MULF(s1->m5, s2->m1),
      so_1 = KSL_MULF(s1->m5, s2->m0) - KSL_MULF(s1->m3, s2->m2),
      so_2 = KSL_MULF(s1->m3, s2->m1) - KSL_MULF(s1->m4, s2->m0);
  so->m0 = so_0;
  so->m1 = so_1;
  so->m2 = so_2;
  so->m3 = 0.0f;
  so->m4 = 0.0f;
  so->m5 = 0.0f;
}

/* so = (t×R a ; R a), a = axis in the body's frame.
   D: displacement [R | t], R rotation, t in m; axis: vector; so: screw (v in m/s; ω in rad/s).
   15 mul, 9 add.
   Error <= u |result| + (lin: 4, ang: 2) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_hsraf(const ksl_SE3f_t *D, const ksl_vec3f_t *axis, ksl_screwf_t *so) {
  const float a_0 = KSL_MULF(D->m00, axis->x) + KSL_MULF(D->m01, axis->y)
          + KSL_MULF(D->m02, axis->z),
      a_1 = KSL_MULF(D->m10, axis->x) + KSL_MULF(D->m11, axis->y) + KSL_MULF(D->m12, axis->z),
      a_2 = KSL_MULF(D->m20, axis->x) + KSL_MULF(D->m21, axis->y) + KSL_MULF(D->m22, axis->z);
  const float so_0 = KSL_MULF(D->m13, a_2) - KSL_MULF(D->m23, a_1),
      so_1 = KSL_MULF(D->m23, a_0) - KSL_MULF(D->m03, a_2),
      so_2 = KSL_MULF(D->m03, a_1) - KSL_MULF(D->m13, a_0);
  so->m0 = so_0;
  so->m1 = so_1;
  so->m2 = so_2;
  so->m3 = a_0;
  so->m4 = a_1;
  so->m5 = a_2;
}

/* so = (R a ; 0), a = axis in the body's frame.
   D: displacement [R | t], R rotation, t in m; axis: vector; so: screw (v in m/s; ω in rad/s).
   9 mul, 6 add.
   Error <= u |result| + (lin: 2, ang: 0) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_hstaf(const ksl_SE3f_t *D, const ksl_vec3f_t *axis, ksl_screwf_t *so) {
  const float so_0 = KSL_MULF(D->m00, axis->x) + KSL_MULF(D->m01, axis->y)
          + KSL_MULF(D->m02, axis->z),
      so_1 = KSL_MULF(D->m10, axis->x) + KSL_MULF(D->m11, axis->y) + KSL_MULF(D->m12, axis->z),
      so_2 = KSL_MULF(D->m20, axis->x) + KSL_MULF(D->m21, axis->y) + KSL_MULF(D->m22, axis->z);
  so->m0 = so_0;
  so->m1 = so_1;
  so->m2 = so_2;
  so->m3 = 0.0f;
  so->m4 = 0.0f;
  so->m5 = 0.0f;
}

/* so = -(t×R a ; R a), a = axis in the body's frame.
   D: displacement [R | t], R rotation, t in m; axis: vector; so: screw (v in m/s; ω in rad/s).
   15 mul, 9 add, 3 neg.
   Error <= u |result| + (lin: 4, ang: 2) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_hsrainvf(const ksl_SE3f_t *D, const ksl_vec3f_t *axis, ksl_screwf_t *so) {
  const float a_0 =
          -(KSL_MULF(D->m00, axis->x) + KSL_MULF(D->m01, axis->y) + KSL_MULF(D->m02, axis->z)),
      a_1 = -(KSL_MULF(D->m10, axis->x) + KSL_MULF(D->m11, axis->y) + KSL_MULF(D->m12, axis->z)),
      a_2 = -(KSL_MULF(D->m20, axis->x) + KSL_MULF(D->m21, axis->y) + KSL_MULF(D->m22, axis->z));
  const float so_0 = KSL_MULF(D->m13, a_2) - KSL_MULF(D->m23, a_1),
      so_1 = KSL_MULF(D->m23, a_0) - KSL_MULF(D->m03, a_2),
      so_2 = KSL_MULF(D->m03, a_1) - KSL_MULF(D->m13, a_0);
  so->m0 = so_0;
  so->m1 = so_1;
  so->m2 = so_2;
  so->m3 = a_0;
  so->m4 = a_1;
  so->m5 = a_2;
}

/* so = -(R a ; 0), a = axis in the body's frame.
   D: displacement [R | t], R rotation, t in m; axis: vector; so: screw (v in m/s; ω in rad/s).
   9 mul, 6 add, 3 neg.
   Error <= u |result| + (lin: 2, ang: 0) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_hstainvf(const ksl_SE3f_t *D, const ksl_vec3f_t *axis, ksl_screwf_t *so) {
  const float so_0 =
          -(KSL_MULF(D->m00, axis->x) + KSL_MULF(D->m01, axis->y) + KSL_MULF(D->m02, axis->z)),
      so_1 = -(KSL_MULF(D->m10, axis->x) + KSL_MULF(D->m11, axis->y) + KSL_MULF(D->m12, axis->z)),
      so_2 = -(KSL_MULF(D->m20, axis->x) + KSL_MULF(D->m21, axis->y) + KSL_MULF(D->m22, axis->z));
  so->m0 = so_0;
  so->m1 = so_1;
  so->m2 = so_2;
  so->m3 = 0.0f;
  so->m4 = 0.0f;
  so->m5 = 0.0f;
}

/* M = [ad](s) = [Ad]' [Ad]^-1 = [[ω~, v~], [0, ω~]].
   s: screw (v in m/s; ω in rad/s); M: 6×6 operator.
   6 neg.
   Exact. */
static inline void ksl_adf(const ksl_screwf_t *s, ksl_mat6x6f_t *M) {
  const float M_01 = -s->m5, M_04 = -s->m2, M_12 = -s->m3, M_15 = -s->m0, M_20 = -s->m4,
      M_23 = -s->m1;
  const float s_m4 = s->m4;
  const float s_m1 = s->m1;
  const float s_m5 = s->m5;
  const float s_m2 = s->m2;
  const float s_m3 = s->m3;
  const float s_m0 = s->m0;
  M->at[0][0] = 0.0f;
  M->at[1][0] = M_01;
  M->at[2][0] = s_m4;
  M->at[3][0] = 0.0f;
  M->at[4][0] = M_04;
  M->at[5][0] = s_m1;
  M->at[0][1] = s_m5;
  M->at[1][1] = 0.0f;
  M->at[2][1] = M_12;
  M->at[3][1] = s_m2;
  M->at[4][1] = 0.0f;
  M->at[5][1] = M_15;
  M->at[0][2] = M_20;
  M->at[1][2] = s_m3;
  M->at[2][2] = 0.0f;
  M->at[3][2] = M_23;
  M->at[4][2] = s_m0;
  M->at[5][2] = 0.0f;
  M->at[0][3] = 0.0f;
  M->at[1][3] = 0.0f;
  M->at[2][3] = 0.0f;
  M->at[3][3] = 0.0f;
  M->at[4][3] = M_01;
  M->at[5][3] = s_m4;
  M->at[0][4] = 0.0f;
  M->at[1][4] = 0.0f;
  M->at[2][4] = 0.0f;
  M->at[3][4] = s_m5;
  M->at[4][4] = 0.0f;
  M->at[5][4] = M_12;
  M->at[0][5] = 0.0f;
  M->at[1][5] = 0.0f;
  M->at[2][5] = 0.0f;
  M->at[3][5] = M_20;
  M->at[4][5] = s_m3;
  M->at[5][5] = 0.0f;
}

#ifndef KSL_NO_ALLOC
#include <stdlib.h>

/* n ksl_screw_t on the heap, zeros, to be freed by the caller; NULL for n <= 0 or when there is
     no memory. */
static inline ksl_screw_t *ksl_screw_alloc(int n) {
  return n > 0 ? (ksl_screw_t *)calloc((size_t)n, sizeof(ksl_screw_t)) : NULL;
}

/* n ksl_screwf_t on the heap, zeros, to be freed by the caller; NULL for n <= 0 or when there is
     no memory. */
static inline ksl_screwf_t *ksl_screwf_alloc(int n) {
  return n > 0 ? (ksl_screwf_t *)calloc((size_t)n, sizeof(ksl_screwf_t)) : NULL;
}

#endif

/* What KSL declares beside formulas. */


/* Six entries of A, down from (rowIndex, columnIndex), become si; A lies row by row, stride
   apart. */
static inline void ksl_screw_copy_rmo(
    const ksl_screw_t *si, double *A, const int rowIndex, const int columnIndex,
    const int stride) {
  for (int i = 0; i < 6; i++) {
    A[(rowIndex + i) * stride + columnIndex] = si->at[i];
  }
}

/* Six entries of A, down from (rowIndex, columnIndex), become -si; A lies row by row, stride
   apart. */
static inline void ksl_screw_ncopy_rmo(
    const ksl_screw_t *si, double *A, const int rowIndex, const int columnIndex,
    const int stride) {
  for (int i = 0; i < 6; i++) {
    A[(rowIndex + i) * stride + columnIndex] = -si->at[i];
  }
}

/* Six entries of A, down from (rowIndex, columnIndex), become si; A lies column by column, stride
   apart. */
static inline void ksl_screw_copy_cmo(
    const ksl_screw_t *si, double *A, const int rowIndex, const int columnIndex,
    const int stride) {
  for (int i = 0; i < 6; i++) {
    A[columnIndex * stride + rowIndex + i] = si->at[i];
  }
}

/* Six entries of A, down from (rowIndex, columnIndex), become -si; A lies column by column, stride
   apart. */
static inline void ksl_screw_ncopy_cmo(
    const ksl_screw_t *si, double *A, const int rowIndex, const int columnIndex,
    const int stride) {
  for (int i = 0; i < 6; i++) {
    A[columnIndex * stride + rowIndex + i] = -si->at[i];
  }
}

/* Six entries of A, down from (rowIndex, columnIndex), become si; A lies row by row, stride
   apart. */
static inline void ksl_screwf_copy_rmo(
    const ksl_screwf_t *si, float *A, const int rowIndex, const int columnIndex,
    const int stride) {
  for (int i = 0; i < 6; i++) {
    A[(rowIndex + i) * stride + columnIndex] = si->at[i];
  }
}

/* Six entries of A, down from (rowIndex, columnIndex), become -si; A lies row by row, stride
   apart. */
static inline void ksl_screwf_ncopy_rmo(
    const ksl_screwf_t *si, float *A, const int rowIndex, const int columnIndex,
    const int stride) {
  for (int i = 0; i < 6; i++) {
    A[(rowIndex + i) * stride + columnIndex] = -si->at[i];
  }
}

/* Six entries of A, down from (rowIndex, columnIndex), become si; A lies column by column, stride
   apart. */
static inline void ksl_screwf_copy_cmo(
    const ksl_screwf_t *si, float *A, const int rowIndex, const int columnIndex,
    const int stride) {
  for (int i = 0; i < 6; i++) {
    A[columnIndex * stride + rowIndex + i] = si->at[i];
  }
}

/* Six entries of A, down from (rowIndex, columnIndex), become -si; A lies column by column, stride
   apart. */
static inline void ksl_screwf_ncopy_cmo(
    const ksl_screwf_t *si, float *A, const int rowIndex, const int columnIndex,
    const int stride) {
  for (int i = 0; i < 6; i++) {
    A[columnIndex * stride + rowIndex + i] = -si->at[i];
  }
}

/* KSL's other spelling of ksl_hsrxinvf. */
static inline void ksl_hrxinvf(const ksl_SE3f_t *Di, ksl_screwf_t *ho) {
  ksl_hsrxinvf(Di, ho);
}

#endif
