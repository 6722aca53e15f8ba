/* Made by `coscrew generate`; changes are overwritten. */
/* SPDX-License-Identifier: MIT */
/* coscrew 0.2.0.  Copyright (c) 2026 The coscrew authors. */
/* Screws: twists, spatial velocities and accelerations, s = (v; ω).
   Accurate tier: double compensated, single computed in double. */
#ifndef KSL_SCREW_ACCURATE_H
#define KSL_SCREW_ACCURATE_H

#include "ksl_exact.h"

/* self = a self.
   self: screw (v in m/s; ω in rad/s); a: number.
   6 mul, 6 add, 6 product error.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_screw_scale_accurate(ksl_screw_t *self, const double a) {
  const double self_0_new = KSL_MUL(self->m0, a), self_1_new = KSL_MUL(self->m1, a),
      self_2_new = KSL_MUL(self->m2, a), self_3_new = KSL_MUL(self->m3, a),
      self_4_new = KSL_MUL(self->m4, a), self_5_new = KSL_MUL(self->m5, a);
  const double self_0_new_rounded = self_0_new + ksl_product_error(self->m0, a, self_0_new),
      self_1_new_rounded = self_1_new + ksl_product_error(self->m1, a, self_1_new),
      self_2_new_rounded = self_2_new + ksl_product_error(self->m2, a, self_2_new),
      self_3_new_rounded = self_3_new + ksl_product_error(self->m3, a, self_3_new),
      self_4_new_rounded = self_4_new + ksl_product_error(self->m4, a, self_4_new),
      self_5_new_rounded = self_5_new + ksl_product_error(self->m5, a, self_5_new);
  self->m0 = self_0_new_rounded;
  self->m1 = self_1_new_rounded;
  self->m2 = self_2_new_rounded;
  self->m3 = self_3_new_rounded;
  self->m4 = self_4_new_rounded;
  self->m5 = self_5_new_rounded;
}

/* y = a x + y.
   a: number; x, y: screw (v in m/s; ω in rad/s).
   6 mul, 36 add, 6 product rest.
   Error <= u |result| + 3 u^2 S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_axpy_ss_accurate(const double a, const ksl_screw_t *x, ksl_screw_t *y) {
  const double y_0_new_a = KSL_MUL(a, x->m0), y_0_new = y_0_new_a + y->m0,
      y_0_new_right = y_0_new - y_0_new_a;
  const double y_1_new_a = KSL_MUL(a, x->m1), y_1_new = y_1_new_a + y->m1,
      y_1_new_right = y_1_new - y_1_new_a;
  const double y_2_new_a = KSL_MUL(a, x->m2), y_2_new = y_2_new_a + y->m2,
      y_2_new_right = y_2_new - y_2_new_a;
  const double y_3_new_a = KSL_MUL(a, x->m3), y_3_new = y_3_new_a + y->m3,
      y_3_new_right = y_3_new - y_3_new_a;
  const double y_4_new_a = KSL_MUL(a, x->m4), y_4_new = y_4_new_a + y->m4,
      y_4_new_right = y_4_new - y_4_new_a;
  const double y_5_new_a = KSL_MUL(a, x->m5), y_5_new = y_5_new_a + y->m5,
      y_5_new_right = y_5_new - y_5_new_a;
  const double y_0_new_rounded = y_0_new
          + (ksl_product_rest(a, x->m0, y_0_new_a, y_0_new - y_0_new_right)
          + (y->m0 - y_0_new_right)),
      y_1_new_rounded = y_1_new
          + (ksl_product_rest(a, x->m1, y_1_new_a, y_1_new - y_1_new_right)
          + (y->m1 - y_1_new_right)),
      y_2_new_rounded = y_2_new
          + (ksl_product_rest(a, x->m2, y_2_new_a, y_2_new - y_2_new_right)
          + (y->m2 - y_2_new_right)),
      y_3_new_rounded = y_3_new
          + (ksl_product_rest(a, x->m3, y_3_new_a, y_3_new - y_3_new_right)
          + (y->m3 - y_3_new_right)),
      y_4_new_rounded = y_4_new
          + (ksl_product_rest(a, x->m4, y_4_new_a, y_4_new - y_4_new_right)
          + (y->m4 - y_4_new_right)),
      y_5_new_rounded = y_5_new
          + (ksl_product_rest(a, x->m5, y_5_new_a, y_5_new - y_5_new_right)
          + (y->m5 - y_5_new_right));
  y->m0 = y_0_new_rounded;
  y->m1 = y_1_new_rounded;
  y->m2 = y_2_new_rounded;
  y->m3 = y_3_new_rounded;
  y->m4 = y_4_new_rounded;
  y->m5 = y_5_new_rounded;
}

/* y = x + y.
   x, y: screw (v in m/s; ω in rad/s).
   42 add.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_xpy_ss_accurate(const ksl_screw_t *x, ksl_screw_t *y) {
  const double y_0_new = x->m0 + y->m0, y_0_new_right = y_0_new - x->m0;
  const double y_1_new = x->m1 + y->m1, y_1_new_right = y_1_new - x->m1;
  const double y_2_new = x->m2 + y->m2, y_2_new_right = y_2_new - x->m2;
  const double y_3_new = x->m3 + y->m3, y_3_new_right = y_3_new - x->m3;
  const double y_4_new = x->m4 + y->m4, y_4_new_right = y_4_new - x->m4;
  const double y_5_new = x->m5 + y->m5, y_5_new_right = y_5_new - x->m5;
  const double y_0_new_rounded = y_0_new
          + (x->m0 - (y_0_new - y_0_new_right) + (y->m0 - y_0_new_right)),
      y_1_new_rounded = y_1_new + (x->m1 - (y_1_new - y_1_new_right) + (y->m1 - y_1_new_right)),
      y_2_new_rounded = y_2_new + (x->m2 - (y_2_new - y_2_new_right) + (y->m2 - y_2_new_right)),
      y_3_new_rounded = y_3_new + (x->m3 - (y_3_new - y_3_new_right) + (y->m3 - y_3_new_right)),
      y_4_new_rounded = y_4_new + (x->m4 - (y_4_new - y_4_new_right) + (y->m4 - y_4_new_right)),
      y_5_new_rounded = y_5_new + (x->m5 - (y_5_new - y_5_new_right) + (y->m5 - y_5_new_right));
  y->m0 = y_0_new_rounded;
  y->m1 = y_1_new_rounded;
  y->m2 = y_2_new_rounded;
  y->m3 = y_3_new_rounded;
  y->m4 = y_4_new_rounded;
  y->m5 = y_5_new_rounded;
}

/* y = -x + y.
   x, y: screw (v in m/s; ω in rad/s).
   42 add.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_nxpy_ss_accurate(const ksl_screw_t *x, ksl_screw_t *y) {
  const double y_0_new = y->m0 - x->m0, y_0_new_right = y->m0 - y_0_new;
  const double y_1_new = y->m1 - x->m1, y_1_new_right = y->m1 - y_1_new;
  const double y_2_new = y->m2 - x->m2, y_2_new_right = y->m2 - y_2_new;
  const double y_3_new = y->m3 - x->m3, y_3_new_right = y->m3 - y_3_new;
  const double y_4_new = y->m4 - x->m4, y_4_new_right = y->m4 - y_4_new;
  const double y_5_new = y->m5 - x->m5, y_5_new_right = y->m5 - y_5_new;
  const double y_0_new_rounded = y_0_new
          + (y->m0 - (y_0_new + y_0_new_right) - (x->m0 - y_0_new_right)),
      y_1_new_rounded = y_1_new + (y->m1 - (y_1_new + y_1_new_right) - (x->m1 - y_1_new_right)),
      y_2_new_rounded = y_2_new + (y->m2 - (y_2_new + y_2_new_right) - (x->m2 - y_2_new_right)),
      y_3_new_rounded = y_3_new + (y->m3 - (y_3_new + y_3_new_right) - (x->m3 - y_3_new_right)),
      y_4_new_rounded = y_4_new + (y->m4 - (y_4_new + y_4_new_right) - (x->m4 - y_4_new_right)),
      y_5_new_rounded = y_5_new + (y->m5 - (y_5_new + y_5_new_right) - (x->m5 - y_5_new_right));
  y->m0 = y_0_new_rounded;
  y->m1 = y_1_new_rounded;
  y->m2 = y_2_new_rounded;
  y->m3 = y_3_new_rounded;
  y->m4 = y_4_new_rounded;
  y->m5 = y_5_new_rounded;
}

/* so = a si.
   a: number; si, so: screw (v in m/s; ω in rad/s).
   6 mul, 6 add, 6 product error.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_product_as_accurate(const double a, const ksl_screw_t *si, ksl_screw_t *so) {
  const double so_0 = KSL_MUL(a, si->m0), so_1 = KSL_MUL(a, si->m1), so_2 = KSL_MUL(a, si->m2),
      so_3 = KSL_MUL(a, si->m3), so_4 = KSL_MUL(a, si->m4), so_5 = KSL_MUL(a, si->m5);
  const double so_0_rounded = so_0 + ksl_product_error(a, si->m0, so_0),
      so_1_rounded = so_1 + ksl_product_error(a, si->m1, so_1),
      so_2_rounded = so_2 + ksl_product_error(a, si->m2, so_2),
      so_3_rounded = so_3 + ksl_product_error(a, si->m3, so_3),
      so_4_rounded = so_4 + ksl_product_error(a, si->m4, so_4),
      so_5_rounded = so_5 + ksl_product_error(a, si->m5, so_5);
  so->m0 = so_0_rounded;
  so->m1 = so_1_rounded;
  so->m2 = so_2_rounded;
  so->m3 = so_3_rounded;
  so->m4 = so_4_rounded;
  so->m5 = so_5_rounded;
}

/* so = s1 + s2.
   s1, s2, so: screw (v in m/s; ω in rad/s).
   42 add.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_add_ss_accurate(const ksl_screw_t *s1, const ksl_screw_t *s2,
    ksl_screw_t *so) {
  const double so_0 = s1->m0 + s2->m0, so_0_right = so_0 - s1->m0;
  const double so_1 = s1->m1 + s2->m1, so_1_right = so_1 - s1->m1;
  const double so_2 = s1->m2 + s2->m2, so_2_right = so_2 - s1->m2;
  const double so_3 = s1->m3 + s2->m3, so_3_right = so_3 - s1->m3;
  const double so_4 = s1->m4 + s2->m4, so_4_right = so_4 - s1->m4;
  const double so_5 = s1->m5 + s2->m5, so_5_right = so_5 - s1->m5;
  const double so_0_rounded = so_0 + (s1->m0 - (so_0 - so_0_right) + (s2->m0 - so_0_right)),
      so_1_rounded = so_1 + (s1->m1 - (so_1 - so_1_right) + (s2->m1 - so_1_right)),
      so_2_rounded = so_2 + (s1->m2 - (so_2 - so_2_right) + (s2->m2 - so_2_right)),
      so_3_rounded = so_3 + (s1->m3 - (so_3 - so_3_right) + (s2->m3 - so_3_right)),
      so_4_rounded = so_4 + (s1->m4 - (so_4 - so_4_right) + (s2->m4 - so_4_right)),
      so_5_rounded = so_5 + (s1->m5 - (so_5 - so_5_right) + (s2->m5 - so_5_right));
  so->m0 = so_0_rounded;
  so->m1 = so_1_rounded;
  so->m2 = so_2_rounded;
  so->m3 = so_3_rounded;
  so->m4 = so_4_rounded;
  so->m5 = so_5_rounded;
}

/* so = s1 - s2.
   s1, s2, so: screw (v in m/s; ω in rad/s).
   42 add.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_subtract_ss_accurate(const ksl_screw_t *s1, const ksl_screw_t *s2,
    ksl_screw_t *so) {
  const double so_0 = s1->m0 - s2->m0, so_0_right = s1->m0 - so_0;
  const double so_1 = s1->m1 - s2->m1, so_1_right = s1->m1 - so_1;
  const double so_2 = s1->m2 - s2->m2, so_2_right = s1->m2 - so_2;
  const double so_3 = s1->m3 - s2->m3, so_3_right = s1->m3 - so_3;
  const double so_4 = s1->m4 - s2->m4, so_4_right = s1->m4 - so_4;
  const double so_5 = s1->m5 - s2->m5, so_5_right = s1->m5 - so_5;
  const double so_0_rounded = so_0 + (s1->m0 - (so_0 + so_0_right) - (s2->m0 - so_0_right)),
      so_1_rounded = so_1 + (s1->m1 - (so_1 + so_1_right) - (s2->m1 - so_1_right)),
      so_2_rounded = so_2 + (s1->m2 - (so_2 + so_2_right) - (s2->m2 - so_2_right)),
      so_3_rounded = so_3 + (s1->m3 - (so_3 + so_3_right) - (s2->m3 - so_3_right)),
      so_4_rounded = so_4 + (s1->m4 - (so_4 + so_4_right) - (s2->m4 - so_4_right)),
      so_5_rounded = so_5 + (s1->m5 - (so_5 + so_5_right) - (s2->m5 - so_5_right));
  so->m0 = so_0_rounded;
  so->m1 = so_1_rounded;
  so->m2 = so_2_rounded;
  so->m3 = so_3_rounded;
  so->m4 = so_4_rounded;
  so->m5 = so_5_rounded;
}

/* |si|: |ω|, or |v| where every |ω_i| is below 1e-9 (single: 1e-6).
   si: screw (v in m/s; ω in rad/s).
   10 mul, 29 add, 1 product error, 3 product rest, 2 div, 1 sqrt, 6 abs, 11 less, 3 equal, 16
     select. */
static inline double ksl_screw_norm_accurate(const ksl_screw_t *si) {
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
  const double n_a = KSL_MUL(y_0, y_0), n_b = KSL_MUL(y_1, y_1), n_c = n_a + n_b,
      n_c_right = n_c - n_a, n_d = KSL_MUL(y_2, y_2), n_e = n_c + n_d, n_e_right = n_e - n_c,
      n_c_lo = ksl_product_rest(y_0, y_0, n_a, n_c - n_c_right)
          + ksl_product_rest(y_1, y_1, n_b, n_c_right),
      n_e_lo = n_c - (n_e - n_e_right) + ksl_product_rest(y_2, y_2, n_d, n_e_right) + n_c_lo,
      n_e_sum = n_e + n_e_lo, n_e_sum_right = n_e_sum - n_e, n = sqrt(n_e_sum),
      n_product = KSL_MUL(n, n), n_twice = n + n,
      n_residual = n_e_sum - n_product - ksl_product_error(n, n, n_product)
          + (n_e - (n_e_sum - n_e_sum_right) + (n_e_lo - n_e_sum_right)),
      n_lo = n_residual / (n == 0.0 ? 1.0 : n_twice);
  const double r_b = s < 1.0 ? 2.6815615859885194e+154 : 1.0,
      r_d = 1.0 < s ? 7.637340908749012e-152 : r_b,
      r = 1.3093562431584567e+151 < s ? 9.332636185032189e-302 : r_d;
  const double n_sum = n + n_lo, n_sum_right = n_sum - n, norm = KSL_MUL(n_sum, r);
  const double norm_rounded = norm
          + KSL_MUL(n_sum - KSL_MUL(norm, 1.0 / r)
          + (n - (n_sum - n_sum_right) + (n_lo - n_sum_right)), r),
      norm_final = norm_rounded == norm_rounded ? norm_rounded : norm;
  return norm_final;
}

/* self = self / |self|, with screw_norm; the zero screw stays zero.
   self: screw (v in m/s; ω in rad/s).
   43 mul, 104 add, 7 product error, 3 product rest, 19 div, 1 sqrt, 9 abs, 16 less, 9 equal, 34
     select. */
static inline void ksl_screw_normalize_accurate(ksl_screw_t *self) {
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
  const double n_a = KSL_MUL(y_0, y_0), n_b = KSL_MUL(y_1, y_1), n_c = n_a + n_b,
      n_c_right = n_c - n_a, n_d = KSL_MUL(y_2, y_2), n_e = n_c + n_d, n_e_right = n_e - n_c,
      n_c_lo = ksl_product_rest(y_0, y_0, n_a, n_c - n_c_right)
          + ksl_product_rest(y_1, y_1, n_b, n_c_right),
      n_e_lo = n_c - (n_e - n_e_right) + ksl_product_rest(y_2, y_2, n_d, n_e_right) + n_c_lo,
      n_e_sum = n_e + n_e_lo, n_e_sum_right = n_e_sum - n_e, n = sqrt(n_e_sum),
      n_product = KSL_MUL(n, n), n_twice = n + n,
      n_residual = n_e_sum - n_product - ksl_product_error(n, n, n_product)
          + (n_e - (n_e_sum - n_e_sum_right) + (n_e_lo - n_e_sum_right)),
      n_lo = n_residual / (n == 0.0 ? 1.0 : n_twice);
  const double n_sum = n + n_lo, n_sum_right = n_sum - n,
      n_sum_lo = n - (n_sum - n_sum_right) + (n_lo - n_sum_right),
      divisor = n_sum == 0.0 ? up : n_sum, divisor_lo = n_sum == 0.0 ? 0.0 : n_sum_lo;
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
  const double divisor_sum = divisor + divisor_lo, divisor_sum_right = divisor_sum - divisor,
      divisor_sum_lo = divisor - (divisor_sum - divisor_sum_right)
          + (divisor_lo - divisor_sum_right), quotient_0 = sized_0 / divisor_sum,
      quotient_0_product = KSL_MUL(quotient_0, divisor_sum),
      quotient_0_exact = sized_0 - quotient_0_product
          - ksl_product_error(quotient_0, divisor_sum, quotient_0_product),
      quotient_0_lo = (quotient_0_exact - KSL_MUL(quotient_0, divisor_sum_lo)) / divisor_sum;
  const double quotient_1 = sized_1 / divisor_sum,
      quotient_1_product = KSL_MUL(quotient_1, divisor_sum),
      quotient_1_exact = sized_1 - quotient_1_product
          - ksl_product_error(quotient_1, divisor_sum, quotient_1_product),
      quotient_1_lo = (quotient_1_exact - KSL_MUL(quotient_1, divisor_sum_lo)) / divisor_sum;
  const double quotient_2 = sized_2 / divisor_sum,
      quotient_2_product = KSL_MUL(quotient_2, divisor_sum),
      quotient_2_exact = sized_2 - quotient_2_product
          - ksl_product_error(quotient_2, divisor_sum, quotient_2_product),
      quotient_2_lo = (quotient_2_exact - KSL_MUL(quotient_2, divisor_sum_lo)) / divisor_sum;
  const double quotient_3 = sized_3 / divisor_sum,
      quotient_3_product = KSL_MUL(quotient_3, divisor_sum),
      quotient_3_exact = sized_3 - quotient_3_product
          - ksl_product_error(quotient_3, divisor_sum, quotient_3_product),
      quotient_3_lo = (quotient_3_exact - KSL_MUL(quotient_3, divisor_sum_lo)) / divisor_sum;
  const double quotient_4 = sized_4 / divisor_sum,
      quotient_4_product = KSL_MUL(quotient_4, divisor_sum),
      quotient_4_exact = sized_4 - quotient_4_product
          - ksl_product_error(quotient_4, divisor_sum, quotient_4_product),
      quotient_4_lo = (quotient_4_exact - KSL_MUL(quotient_4, divisor_sum_lo)) / divisor_sum;
  const double quotient_5 = sized_5 / divisor_sum,
      quotient_5_product = KSL_MUL(quotient_5, divisor_sum),
      quotient_5_exact = sized_5 - quotient_5_product
          - ksl_product_error(quotient_5, divisor_sum, quotient_5_product),
      quotient_5_lo = (quotient_5_exact - KSL_MUL(quotient_5, divisor_sum_lo)) / divisor_sum;
  const double quotient_0_sum = quotient_0 + quotient_0_lo,
      quotient_0_sum_right = quotient_0_sum - quotient_0,
      self_0_new = KSL_MUL(quotient_0_sum, after_0),
      quotient_0_sum_lo = quotient_0 - (quotient_0_sum - quotient_0_sum_right)
          + (quotient_0_lo - quotient_0_sum_right);
  const double quotient_1_sum = quotient_1 + quotient_1_lo,
      quotient_1_sum_right = quotient_1_sum - quotient_1,
      self_1_new = KSL_MUL(quotient_1_sum, after_1),
      quotient_1_sum_lo = quotient_1 - (quotient_1_sum - quotient_1_sum_right)
          + (quotient_1_lo - quotient_1_sum_right);
  const double quotient_2_sum = quotient_2 + quotient_2_lo,
      quotient_2_sum_right = quotient_2_sum - quotient_2,
      self_2_new = KSL_MUL(quotient_2_sum, after_2),
      quotient_2_sum_lo = quotient_2 - (quotient_2_sum - quotient_2_sum_right)
          + (quotient_2_lo - quotient_2_sum_right);
  const double quotient_3_sum = quotient_3 + quotient_3_lo,
      quotient_3_sum_right = quotient_3_sum - quotient_3,
      self_3_new = KSL_MUL(quotient_3_sum, after_3),
      quotient_3_sum_lo = quotient_3 - (quotient_3_sum - quotient_3_sum_right)
          + (quotient_3_lo - quotient_3_sum_right);
  const double quotient_4_sum = quotient_4 + quotient_4_lo,
      quotient_4_sum_right = quotient_4_sum - quotient_4,
      self_4_new = KSL_MUL(quotient_4_sum, after_4),
      quotient_4_sum_lo = quotient_4 - (quotient_4_sum - quotient_4_sum_right)
          + (quotient_4_lo - quotient_4_sum_right);
  const double quotient_5_sum = quotient_5 + quotient_5_lo,
      quotient_5_sum_right = quotient_5_sum - quotient_5,
      self_5_new = KSL_MUL(quotient_5_sum, after_5),
      quotient_5_sum_lo = quotient_5 - (quotient_5_sum - quotient_5_sum_right)
          + (quotient_5_lo - quotient_5_sum_right);
  const double self_0_new_rounded = self_0_new
          + KSL_MUL(quotient_0_sum - KSL_MUL(self_0_new, 1.0 / after_0)
          + quotient_0_sum_lo, after_0);
  const double self_1_new_rounded = self_1_new
          + KSL_MUL(quotient_1_sum - KSL_MUL(self_1_new, 1.0 / after_1)
          + quotient_1_sum_lo, after_1);
  const double self_2_new_rounded = self_2_new
          + KSL_MUL(quotient_2_sum - KSL_MUL(self_2_new, 1.0 / after_2)
          + quotient_2_sum_lo, after_2);
  const double self_3_new_rounded = self_3_new
          + KSL_MUL(quotient_3_sum - KSL_MUL(self_3_new, 1.0 / after_3)
          + quotient_3_sum_lo, after_3);
  const double self_4_new_rounded = self_4_new
          + KSL_MUL(quotient_4_sum - KSL_MUL(self_4_new, 1.0 / after_4)
          + quotient_4_sum_lo, after_4);
  const double self_5_new_rounded = self_5_new
          + KSL_MUL(quotient_5_sum - KSL_MUL(self_5_new, 1.0 / after_5)
          + quotient_5_sum_lo, after_5);
  const double self_0_new_final = self_0_new_rounded == self_0_new_rounded ? self_0_new_rounded
          : self_0_new;
  const double self_1_new_final = self_1_new_rounded == self_1_new_rounded ? self_1_new_rounded
          : self_1_new;
  const double self_2_new_final = self_2_new_rounded == self_2_new_rounded ? self_2_new_rounded
          : self_2_new;
  const double self_3_new_final = self_3_new_rounded == self_3_new_rounded ? self_3_new_rounded
          : self_3_new;
  const double self_4_new_final = self_4_new_rounded == self_4_new_rounded ? self_4_new_rounded
          : self_4_new;
  const double self_5_new_final = self_5_new_rounded == self_5_new_rounded ? self_5_new_rounded
          : self_5_new;
  self->m0 = self_0_new_final;
  self->m1 = self_1_new_final;
  self->m2 = self_2_new_final;
  self->m3 = self_3_new_final;
  self->m4 = self_4_new_final;
  self->m5 = self_5_new_final;
}

/* so = si / |si|, with screw_norm; the zero screw stays zero.
   si, so: screw (v in m/s; ω in rad/s).
   43 mul, 104 add, 7 product error, 3 product rest, 19 div, 1 sqrt, 9 abs, 16 less, 9 equal, 34
     select. */
static inline void ksl_screw_normalized_accurate(const ksl_screw_t *si, ksl_screw_t *so) {
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
  const double n_a = KSL_MUL(y_0, y_0), n_b = KSL_MUL(y_1, y_1), n_c = n_a + n_b,
      n_c_right = n_c - n_a, n_d = KSL_MUL(y_2, y_2), n_e = n_c + n_d, n_e_right = n_e - n_c,
      n_c_lo = ksl_product_rest(y_0, y_0, n_a, n_c - n_c_right)
          + ksl_product_rest(y_1, y_1, n_b, n_c_right),
      n_e_lo = n_c - (n_e - n_e_right) + ksl_product_rest(y_2, y_2, n_d, n_e_right) + n_c_lo,
      n_e_sum = n_e + n_e_lo, n_e_sum_right = n_e_sum - n_e, n = sqrt(n_e_sum),
      n_product = KSL_MUL(n, n), n_twice = n + n,
      n_residual = n_e_sum - n_product - ksl_product_error(n, n, n_product)
          + (n_e - (n_e_sum - n_e_sum_right) + (n_e_lo - n_e_sum_right)),
      n_lo = n_residual / (n == 0.0 ? 1.0 : n_twice);
  const double n_sum = n + n_lo, n_sum_right = n_sum - n,
      n_sum_lo = n - (n_sum - n_sum_right) + (n_lo - n_sum_right),
      divisor = n_sum == 0.0 ? up : n_sum, divisor_lo = n_sum == 0.0 ? 0.0 : n_sum_lo;
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
  const double divisor_sum = divisor + divisor_lo, divisor_sum_right = divisor_sum - divisor,
      divisor_sum_lo = divisor - (divisor_sum - divisor_sum_right)
          + (divisor_lo - divisor_sum_right), quotient_0 = sized_0 / divisor_sum,
      quotient_0_product = KSL_MUL(quotient_0, divisor_sum),
      quotient_0_exact = sized_0 - quotient_0_product
          - ksl_product_error(quotient_0, divisor_sum, quotient_0_product),
      quotient_0_lo = (quotient_0_exact - KSL_MUL(quotient_0, divisor_sum_lo)) / divisor_sum;
  const double quotient_1 = sized_1 / divisor_sum,
      quotient_1_product = KSL_MUL(quotient_1, divisor_sum),
      quotient_1_exact = sized_1 - quotient_1_product
          - ksl_product_error(quotient_1, divisor_sum, quotient_1_product),
      quotient_1_lo = (quotient_1_exact - KSL_MUL(quotient_1, divisor_sum_lo)) / divisor_sum;
  const double quotient_2 = sized_2 / divisor_sum,
      quotient_2_product = KSL_MUL(quotient_2, divisor_sum),
      quotient_2_exact = sized_2 - quotient_2_product
          - ksl_product_error(quotient_2, divisor_sum, quotient_2_product),
      quotient_2_lo = (quotient_2_exact - KSL_MUL(quotient_2, divisor_sum_lo)) / divisor_sum;
  const double quotient_3 = sized_3 / divisor_sum,
      quotient_3_product = KSL_MUL(quotient_3, divisor_sum),
      quotient_3_exact = sized_3 - quotient_3_product
          - ksl_product_error(quotient_3, divisor_sum, quotient_3_product),
      quotient_3_lo = (quotient_3_exact - KSL_MUL(quotient_3, divisor_sum_lo)) / divisor_sum;
  const double quotient_4 = sized_4 / divisor_sum,
      quotient_4_product = KSL_MUL(quotient_4, divisor_sum),
      quotient_4_exact = sized_4 - quotient_4_product
          - ksl_product_error(quotient_4, divisor_sum, quotient_4_product),
      quotient_4_lo = (quotient_4_exact - KSL_MUL(quotient_4, divisor_sum_lo)) / divisor_sum;
  const double quotient_5 = sized_5 / divisor_sum,
      quotient_5_product = KSL_MUL(quotient_5, divisor_sum),
      quotient_5_exact = sized_5 - quotient_5_product
          - ksl_product_error(quotient_5, divisor_sum, quotient_5_product),
      quotient_5_lo = (quotient_5_exact - KSL_MUL(quotient_5, divisor_sum_lo)) / divisor_sum;
  const double quotient_0_sum = quotient_0 + quotient_0_lo,
      quotient_0_sum_right = quotient_0_sum - quotient_0, so_0 = KSL_MUL(quotient_0_sum, after_0),
      quotient_0_sum_lo = quotient_0 - (quotient_0_sum - quotient_0_sum_right)
          + (quotient_0_lo - quotient_0_sum_right);
  const double quotient_1_sum = quotient_1 + quotient_1_lo,
      quotient_1_sum_right = quotient_1_sum - quotient_1, so_1 = KSL_MUL(quotient_1_sum, after_1),
      quotient_1_sum_lo = quotient_1 - (quotient_1_sum - quotient_1_sum_right)
          + (quotient_1_lo - quotient_1_sum_right);
  const double quotient_2_sum = quotient_2 + quotient_2_lo,
      quotient_2_sum_right = quotient_2_sum - quotient_2, so_2 = KSL_MUL(quotient_2_sum, after_2),
      quotient_2_sum_lo = quotient_2 - (quotient_2_sum - quotient_2_sum_right)
          + (quotient_2_lo - quotient_2_sum_right);
  const double quotient_3_sum = quotient_3 + quotient_3_lo,
      quotient_3_sum_right = quotient_3_sum - quotient_3, so_3 = KSL_MUL(quotient_3_sum, after_3),
      quotient_3_sum_lo = quotient_3 - (quotient_3_sum - quotient_3_sum_right)
          + (quotient_3_lo - quotient_3_sum_right);
  const double quotient_4_sum = quotient_4 + quotient_4_lo,
      quotient_4_sum_right = quotient_4_sum - quotient_4, so_4 = KSL_MUL(quotient_4_sum, after_4),
      quotient_4_sum_lo = quotient_4 - (quotient_4_sum - quotient_4_sum_right)
          + (quotient_4_lo - quotient_4_sum_right);
  const double quotient_5_sum = quotient_5 + quotient_5_lo,
      quotient_5_sum_right = quotient_5_sum - quotient_5, so_5 = KSL_MUL(quotient_5_sum, after_5),
      quotient_5_sum_lo = quotient_5 - (quotient_5_sum - quotient_5_sum_right)
          + (quotient_5_lo - quotient_5_sum_right);
  const double so_0_rounded = so_0
          + KSL_MUL(quotient_0_sum - KSL_MUL(so_0, 1.0 / after_0) + quotient_0_sum_lo, after_0);
  const double so_1_rounded = so_1
          + KSL_MUL(quotient_1_sum - KSL_MUL(so_1, 1.0 / after_1) + quotient_1_sum_lo, after_1);
  const double so_2_rounded = so_2
          + KSL_MUL(quotient_2_sum - KSL_MUL(so_2, 1.0 / after_2) + quotient_2_sum_lo, after_2);
  const double so_3_rounded = so_3
          + KSL_MUL(quotient_3_sum - KSL_MUL(so_3, 1.0 / after_3) + quotient_3_sum_lo, after_3);
  const double so_4_rounded = so_4
          + KSL_MUL(quotient_4_sum - KSL_MUL(so_4, 1.0 / after_4) + quotient_4_sum_lo, after_4);
  const double so_5_rounded = so_5
          + KSL_MUL(quotient_5_sum - KSL_MUL(so_5, 1.0 / after_5) + quotient_5_sum_lo, after_5);
  const double so_0_final = so_0_rounded == so_0_rounded ? so_0_rounded : so_0;
  const double so_1_final = so_1_rounded == so_1_rounded ? so_1_rounded : so_1;
  const double so_2_final = so_2_rounded == so_2_rounded ? so_2_rounded : so_2;
  const double so_3_final = so_3_rounded == so_3_rounded ? so_3_rounded : so_3;
  const double so_4_final = so_4_rounded == so_4_rounded ? so_4_rounded : so_4;
  const double so_5_final = so_5_rounded == so_5_rounded ? so_5_rounded : so_5;
  so->m0 = so_0_final;
  so->m1 = so_1_final;
  so->m2 = so_2_final;
  so->m3 = so_3_final;
  so->m4 = so_4_final;
  so->m5 = so_5_final;
}

/* so = (s1.lin + s2.lin ; s1.ang).
   s1, s2, so: screw (v in m/s; ω in rad/s).
   21 add.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_add_sst_accurate(const ksl_screw_t *s1, const ksl_screw_t *s2,
    ksl_screw_t *so) {
  const double so_0 = s1->m0 + s2->m0, so_0_right = so_0 - s1->m0;
  const double so_1 = s1->m1 + s2->m1, so_1_right = so_1 - s1->m1;
  const double so_2 = s1->m2 + s2->m2, so_2_right = so_2 - s1->m2;
  const double so_0_rounded = so_0 + (s1->m0 - (so_0 - so_0_right) + (s2->m0 - so_0_right)),
      so_1_rounded = so_1 + (s1->m1 - (so_1 - so_1_right) + (s2->m1 - so_1_right)),
      so_2_rounded = so_2 + (s1->m2 - (so_2 - so_2_right) + (s2->m2 - so_2_right));
  const double s1_m3 = s1->m3;
  const double s1_m4 = s1->m4;
  const double s1_m5 = s1->m5;
  so->m0 = so_0_rounded;
  so->m1 = so_1_rounded;
  so->m2 = so_2_rounded;
  so->m3 = s1_m3;
  so->m4 = s1_m4;
  so->m5 = s1_m5;
}

/* so = [Ad](t) si.
   t: vector; si, so: screw (v in m/s; ω in rad/s).
   6 mul, 36 add, 6 product rest.
   Error <= u |result| + (lin: 9, ang: 0) u^2 S, S the sum of the |terms| of the expanded
     formula; barring over- and underflow. */
static inline void ksl_product_Adts_accurate(const ksl_vec3_t *t, const ksl_screw_t *si,
    ksl_screw_t *so) {
  const double so_0a = KSL_MUL(t->y, si->m5), so_0b = KSL_MUL(t->z, si->m4), so_0c = so_0a - so_0b,
      so_0c_right = so_0a - so_0c, so_0 = so_0c + si->m0, so_0_right = so_0 - so_0c,
      so_0c_lo = ksl_product_rest(t->y, si->m5, so_0a, so_0c + so_0c_right)
          - ksl_product_rest(t->z, si->m4, so_0b, so_0c_right);
  const double so_1a = KSL_MUL(t->z, si->m3), so_1b = KSL_MUL(t->x, si->m5), so_1c = so_1a - so_1b,
      so_1c_right = so_1a - so_1c, so_1 = so_1c + si->m1, so_1_right = so_1 - so_1c,
      so_1c_lo = ksl_product_rest(t->z, si->m3, so_1a, so_1c + so_1c_right)
          - ksl_product_rest(t->x, si->m5, so_1b, so_1c_right);
  const double so_2a = KSL_MUL(t->x, si->m4), so_2b = KSL_MUL(t->y, si->m3), so_2c = so_2a - so_2b,
      so_2c_right = so_2a - so_2c, so_2 = so_2c + si->m2, so_2_right = so_2 - so_2c,
      so_2c_lo = ksl_product_rest(t->x, si->m4, so_2a, so_2c + so_2c_right)
          - ksl_product_rest(t->y, si->m3, so_2b, so_2c_right);
  const double so_0_rounded = so_0
          + (so_0c - (so_0 - so_0_right) + (si->m0 - so_0_right) + so_0c_lo),
      so_1_rounded = so_1 + (so_1c - (so_1 - so_1_right) + (si->m1 - so_1_right) + so_1c_lo),
      so_2_rounded = so_2 + (so_2c - (so_2 - so_2_right) + (si->m2 - so_2_right) + so_2c_lo);
  const double si_m3 = si->m3;
  const double si_m4 = si->m4;
  const double si_m5 = si->m5;
  so->m0 = so_0_rounded;
  so->m1 = so_1_rounded;
  so->m2 = so_2_rounded;
  so->m3 = si_m3;
  so->m4 = si_m4;
  so->m5 = si_m5;
}

/* so = [Ad](t)^-1 si.
   t: vector; si, so: screw (v in m/s; ω in rad/s).
   6 mul, 36 add, 6 product rest.
   Error <= u |result| + (lin: 9, ang: 0) u^2 S, S the sum of the |terms| of the expanded
     formula; barring over- and underflow. */
static inline void ksl_product_Adtinvs_accurate(const ksl_vec3_t *t, const ksl_screw_t *si,
    ksl_screw_t *so) {
  const double so_0a = KSL_MUL(t->z, si->m4), so_0b = KSL_MUL(t->y, si->m5), so_0c = so_0a - so_0b,
      so_0c_right = so_0a - so_0c, so_0 = so_0c + si->m0, so_0_right = so_0 - so_0c,
      so_0c_lo = ksl_product_rest(t->z, si->m4, so_0a, so_0c + so_0c_right)
          - ksl_product_rest(t->y, si->m5, so_0b, so_0c_right);
  const double so_1a = KSL_MUL(t->x, si->m5), so_1b = KSL_MUL(t->z, si->m3), so_1c = so_1a - so_1b,
      so_1c_right = so_1a - so_1c, so_1 = so_1c + si->m1, so_1_right = so_1 - so_1c,
      so_1c_lo = ksl_product_rest(t->x, si->m5, so_1a, so_1c + so_1c_right)
          - ksl_product_rest(t->z, si->m3, so_1b, so_1c_right);
  const double so_2a = KSL_MUL(t->y, si->m3), so_2b = KSL_MUL(t->x, si->m4), so_2c = so_2a - so_2b,
      so_2c_right = so_2a - so_2c, so_2 = so_2c + si->m2, so_2_right = so_2 - so_2c,
      so_2c_lo = ksl_product_rest(t->y, si->m3, so_2a, so_2c + so_2c_right)
          - ksl_product_rest(t->x, si->m4, so_2b, so_2c_right);
  const double so_0_rounded = so_0
          + (so_0c - (so_0 - so_0_right) + (si->m0 - so_0_right) + so_0c_lo),
      so_1_rounded = so_1 + (so_1c - (so_1 - so_1_right) + (si->m1 - so_1_right) + so_1c_lo),
      so_2_rounded = so_2 + (so_2c - (so_2 - so_2_right) + (si->m2 - so_2_right) + so_2c_lo);
  const double si_m3 = si->m3;
  const double si_m4 = si->m4;
  const double si_m5 = si->m5;
  so->m0 = so_0_rounded;
  so->m1 = so_1_rounded;
  so->m2 = so_2_rounded;
  so->m3 = si_m3;
  so->m4 = si_m4;
  so->m5 = si_m5;
}

/* so = [Ad](t) (-si).
   t: vector; si, so: screw (v in m/s; ω in rad/s).
   6 mul, 36 add, 6 product rest, 3 neg.
   Error <= u |result| + (lin: 9, ang: 0) u^2 S, S the sum of the |terms| of the expanded
     formula; barring over- and underflow. */
static inline void ksl_product_Adtsinv_accurate(const ksl_vec3_t *t, const ksl_screw_t *si,
    ksl_screw_t *so) {
  const double so_0a = KSL_MUL(t->z, si->m4), so_0b = KSL_MUL(t->y, si->m5), so_0c = so_0a - so_0b,
      so_0c_right = so_0a - so_0c, so_0 = so_0c - si->m0, so_0_right = so_0c - so_0,
      so_0c_lo = ksl_product_rest(t->z, si->m4, so_0a, so_0c + so_0c_right)
          - ksl_product_rest(t->y, si->m5, so_0b, so_0c_right);
  const double so_1a = KSL_MUL(t->x, si->m5), so_1b = KSL_MUL(t->z, si->m3), so_1c = so_1a - so_1b,
      so_1c_right = so_1a - so_1c, so_1 = so_1c - si->m1, so_1_right = so_1c - so_1,
      so_1c_lo = ksl_product_rest(t->x, si->m5, so_1a, so_1c + so_1c_right)
          - ksl_product_rest(t->z, si->m3, so_1b, so_1c_right);
  const double so_2a = KSL_MUL(t->y, si->m3), so_2b = KSL_MUL(t->x, si->m4), so_2c = so_2a - so_2b,
      so_2c_right = so_2a - so_2c, so_2 = so_2c - si->m2, so_2_right = so_2c - so_2,
      so_2c_lo = ksl_product_rest(t->y, si->m3, so_2a, so_2c + so_2c_right)
          - ksl_product_rest(t->x, si->m4, so_2b, so_2c_right);
  const double so_3 = -si->m3, so_4 = -si->m4, so_5 = -si->m5;
  const double so_0_rounded = so_0
          + (so_0c - (so_0 + so_0_right) - (si->m0 - so_0_right) + so_0c_lo),
      so_1_rounded = so_1 + (so_1c - (so_1 + so_1_right) - (si->m1 - so_1_right) + so_1c_lo),
      so_2_rounded = so_2 + (so_2c - (so_2 + so_2_right) - (si->m2 - so_2_right) + so_2c_lo);
  so->m0 = so_0_rounded;
  so->m1 = so_1_rounded;
  so->m2 = so_2_rounded;
  so->m3 = so_3;
  so->m4 = so_4;
  so->m5 = so_5;
}

/* so = [Ad](R) si.
   R: rotation or other 3×3 matrix; si, so: screw (v in m/s; ω in rad/s).
   18 mul, 66 add, 18 product rest.
   Error <= u |result| + 11 u^2 S, S the sum of the |terms| of the expanded formula; barring
     over- and underflow. */
static inline void ksl_product_Adrs_accurate(const ksl_mat3x3_t *R, const ksl_screw_t *si,
    ksl_screw_t *so) {
  const double so_0a = KSL_MUL(R->m00, si->m0), so_0b = KSL_MUL(R->m01, si->m1),
      so_0c = so_0a + so_0b, so_0c_right = so_0c - so_0a, so_0d = KSL_MUL(R->m02, si->m2),
      so_0 = so_0c + so_0d, so_0_right = so_0 - so_0c,
      so_0c_lo = ksl_product_rest(R->m00, si->m0, so_0a, so_0c - so_0c_right)
          + ksl_product_rest(R->m01, si->m1, so_0b, so_0c_right);
  const double so_1a = KSL_MUL(R->m10, si->m0), so_1b = KSL_MUL(R->m11, si->m1),
      so_1c = so_1a + so_1b, so_1c_right = so_1c - so_1a, so_1d = KSL_MUL(R->m12, si->m2),
      so_1 = so_1c + so_1d, so_1_right = so_1 - so_1c,
      so_1c_lo = ksl_product_rest(R->m10, si->m0, so_1a, so_1c - so_1c_right)
          + ksl_product_rest(R->m11, si->m1, so_1b, so_1c_right);
  const double so_2a = KSL_MUL(R->m20, si->m0), so_2b = KSL_MUL(R->m21, si->m1),
      so_2c = so_2a + so_2b, so_2c_right = so_2c - so_2a, so_2d = KSL_MUL(R->m22, si->m2),
      so_2 = so_2c + so_2d, so_2_right = so_2 - so_2c,
      so_2c_lo = ksl_product_rest(R->m20, si->m0, so_2a, so_2c - so_2c_right)
          + ksl_product_rest(R->m21, si->m1, so_2b, so_2c_right);
  const double so_3a = KSL_MUL(R->m00, si->m3), so_3b = KSL_MUL(R->m01, si->m4),
      so_3c = so_3a + so_3b, so_3c_right = so_3c - so_3a, so_3d = KSL_MUL(R->m02, si->m5),
      so_3 = so_3c + so_3d, so_3_right = so_3 - so_3c,
      so_3c_lo = ksl_product_rest(R->m00, si->m3, so_3a, so_3c - so_3c_right)
          + ksl_product_rest(R->m01, si->m4, so_3b, so_3c_right);
  const double so_4a = KSL_MUL(R->m10, si->m3), so_4b = KSL_MUL(R->m11, si->m4),
      so_4c = so_4a + so_4b, so_4c_right = so_4c - so_4a, so_4d = KSL_MUL(R->m12, si->m5),
      so_4 = so_4c + so_4d, so_4_right = so_4 - so_4c,
      so_4c_lo = ksl_product_rest(R->m10, si->m3, so_4a, so_4c - so_4c_right)
          + ksl_product_rest(R->m11, si->m4, so_4b, so_4c_right);
  const double so_5a = KSL_MUL(R->m20, si->m3), so_5b = KSL_MUL(R->m21, si->m4),
      so_5c = so_5a + so_5b, so_5c_right = so_5c - so_5a, so_5d = KSL_MUL(R->m22, si->m5),
      so_5 = so_5c + so_5d, so_5_right = so_5 - so_5c,
      so_5c_lo = ksl_product_rest(R->m20, si->m3, so_5a, so_5c - so_5c_right)
          + ksl_product_rest(R->m21, si->m4, so_5b, so_5c_right);
  const double so_0_rounded = so_0
          + (so_0c - (so_0 - so_0_right) + ksl_product_rest(R->m02, si->m2, so_0d, so_0_right)
          + so_0c_lo),
      so_1_rounded = so_1
          + (so_1c - (so_1 - so_1_right) + ksl_product_rest(R->m12, si->m2, so_1d, so_1_right)
          + so_1c_lo),
      so_2_rounded = so_2
          + (so_2c - (so_2 - so_2_right) + ksl_product_rest(R->m22, si->m2, so_2d, so_2_right)
          + so_2c_lo),
      so_3_rounded = so_3
          + (so_3c - (so_3 - so_3_right) + ksl_product_rest(R->m02, si->m5, so_3d, so_3_right)
          + so_3c_lo),
      so_4_rounded = so_4
          + (so_4c - (so_4 - so_4_right) + ksl_product_rest(R->m12, si->m5, so_4d, so_4_right)
          + so_4c_lo),
      so_5_rounded = so_5
          + (so_5c - (so_5 - so_5_right) + ksl_product_rest(R->m22, si->m5, so_5d, so_5_right)
          + so_5c_lo);
  so->m0 = so_0_rounded;
  so->m1 = so_1_rounded;
  so->m2 = so_2_rounded;
  so->m3 = so_3_rounded;
  so->m4 = so_4_rounded;
  so->m5 = so_5_rounded;
}

/* so = [Ad](R)^-1 si.
   R: rotation or other 3×3 matrix; si, so: screw (v in m/s; ω in rad/s).
   18 mul, 66 add, 18 product rest.
   Error <= u |result| + 11 u^2 S, S the sum of the |terms| of the expanded formula; barring
     over- and underflow. */
static inline void ksl_product_Adrinvs_accurate(const ksl_mat3x3_t *R, const ksl_screw_t *si,
    ksl_screw_t *so) {
  const double so_0a = KSL_MUL(R->m00, si->m0), so_0b = KSL_MUL(R->m10, si->m1),
      so_0c = so_0a + so_0b, so_0c_right = so_0c - so_0a, so_0d = KSL_MUL(R->m20, si->m2),
      so_0 = so_0c + so_0d, so_0_right = so_0 - so_0c,
      so_0c_lo = ksl_product_rest(R->m00, si->m0, so_0a, so_0c - so_0c_right)
          + ksl_product_rest(R->m10, si->m1, so_0b, so_0c_right);
  const double so_1a = KSL_MUL(R->m01, si->m0), so_1b = KSL_MUL(R->m11, si->m1),
      so_1c = so_1a + so_1b, so_1c_right = so_1c - so_1a, so_1d = KSL_MUL(R->m21, si->m2),
      so_1 = so_1c + so_1d, so_1_right = so_1 - so_1c,
      so_1c_lo = ksl_product_rest(R->m01, si->m0, so_1a, so_1c - so_1c_right)
          + ksl_product_rest(R->m11, si->m1, so_1b, so_1c_right);
  const double so_2a = KSL_MUL(R->m02, si->m0), so_2b = KSL_MUL(R->m12, si->m1),
      so_2c = so_2a + so_2b, so_2c_right = so_2c - so_2a, so_2d = KSL_MUL(R->m22, si->m2),
      so_2 = so_2c + so_2d, so_2_right = so_2 - so_2c,
      so_2c_lo = ksl_product_rest(R->m02, si->m0, so_2a, so_2c - so_2c_right)
          + ksl_product_rest(R->m12, si->m1, so_2b, so_2c_right);
  const double so_3a = KSL_MUL(R->m00, si->m3), so_3b = KSL_MUL(R->m10, si->m4),
      so_3c = so_3a + so_3b, so_3c_right = so_3c - so_3a, so_3d = KSL_MUL(R->m20, si->m5),
      so_3 = so_3c + so_3d, so_3_right = so_3 - so_3c,
      so_3c_lo = ksl_product_rest(R->m00, si->m3, so_3a, so_3c - so_3c_right)
          + ksl_product_rest(R->m10, si->m4, so_3b, so_3c_right);
  const double so_4a = KSL_MUL(R->m01, si->m3), so_4b = KSL_MUL(R->m11, si->m4),
      so_4c = so_4a + so_4b, so_4c_right = so_4c - so_4a, so_4d = KSL_MUL(R->m21, si->m5),
      so_4 = so_4c + so_4d, so_4_right = so_4 - so_4c,
      so_4c_lo = ksl_product_rest(R->m01, si->m3, so_4a, so_4c - so_4c_right)
          + ksl_product_rest(R->m11, si->m4, so_4b, so_4c_right);
  const double so_5a = KSL_MUL(R->m02, si->m3), so_5b = KSL_MUL(R->m12, si->m4),
      so_5c = so_5a + so_5b, so_5c_right = so_5c - so_5a, so_5d = KSL_MUL(R->m22, si->m5),
      so_5 = so_5c + so_5d, so_5_right = so_5 - so_5c,
      so_5c_lo = ksl_product_rest(R->m02, si->m3, so_5a, so_5c - so_5c_right)
          + ksl_product_rest(R->m12, si->m4, so_5b, so_5c_right);
  const double so_0_rounded = so_0
          + (so_0c - (so_0 - so_0_right) + ksl_product_rest(R->m20, si->m2, so_0d, so_0_right)
          + so_0c_lo),
      so_1_rounded = so_1
          + (so_1c - (so_1 - so_1_right) + ksl_product_rest(R->m21, si->m2, so_1d, so_1_right)
          + so_1c_lo),
      so_2_rounded = so_2
          + (so_2c - (so_2 - so_2_right) + ksl_product_rest(R->m22, si->m2, so_2d, so_2_right)
          + so_2c_lo),
      so_3_rounded = so_3
          + (so_3c - (so_3 - so_3_right) + ksl_product_rest(R->m20, si->m5, so_3d, so_3_right)
          + so_3c_lo),
      so_4_rounded = so_4
          + (so_4c - (so_4 - so_4_right) + ksl_product_rest(R->m21, si->m5, so_4d, so_4_right)
          + so_4c_lo),
      so_5_rounded = so_5
          + (so_5c - (so_5 - so_5_right) + ksl_product_rest(R->m22, si->m5, so_5d, so_5_right)
          + so_5c_lo);
  so->m0 = so_0_rounded;
  so->m1 = so_1_rounded;
  so->m2 = so_2_rounded;
  so->m3 = so_3_rounded;
  so->m4 = so_4_rounded;
  so->m5 = so_5_rounded;
}

/* so = [Ad](R) (-si).
   R: rotation or other 3×3 matrix; si, so: screw (v in m/s; ω in rad/s).
   18 mul, 66 add, 18 product rest, 12 neg.
   Error <= u |result| + 11 u^2 S, S the sum of the |terms| of the expanded formula; barring
     over- and underflow. */
static inline void ksl_product_Adrsinv_accurate(const ksl_mat3x3_t *R, const ksl_screw_t *si,
    ksl_screw_t *so) {
  const double so_0a = KSL_MUL(R->m00, si->m0), so_0b = KSL_MUL(R->m01, si->m1),
      so_0c = so_0a + so_0b, so_0c_right = so_0c - so_0a, so_0d = KSL_MUL(R->m02, si->m2),
      so_0e = so_0c + so_0d, so_0e_right = so_0e - so_0c,
      so_0c_lo = ksl_product_rest(R->m00, si->m0, so_0a, so_0c - so_0c_right)
          + ksl_product_rest(R->m01, si->m1, so_0b, so_0c_right), so_0 = -so_0e;
  const double so_1a = KSL_MUL(R->m10, si->m0), so_1b = KSL_MUL(R->m11, si->m1),
      so_1c = so_1a + so_1b, so_1c_right = so_1c - so_1a, so_1d = KSL_MUL(R->m12, si->m2),
      so_1e = so_1c + so_1d, so_1e_right = so_1e - so_1c,
      so_1c_lo = ksl_product_rest(R->m10, si->m0, so_1a, so_1c - so_1c_right)
          + ksl_product_rest(R->m11, si->m1, so_1b, so_1c_right), so_1 = -so_1e;
  const double so_2a = KSL_MUL(R->m20, si->m0), so_2b = KSL_MUL(R->m21, si->m1),
      so_2c = so_2a + so_2b, so_2c_right = so_2c - so_2a, so_2d = KSL_MUL(R->m22, si->m2),
      so_2e = so_2c + so_2d, so_2e_right = so_2e - so_2c,
      so_2c_lo = ksl_product_rest(R->m20, si->m0, so_2a, so_2c - so_2c_right)
          + ksl_product_rest(R->m21, si->m1, so_2b, so_2c_right), so_2 = -so_2e;
  const double so_3a = KSL_MUL(R->m00, si->m3), so_3b = KSL_MUL(R->m01, si->m4),
      so_3c = so_3a + so_3b, so_3c_right = so_3c - so_3a, so_3d = KSL_MUL(R->m02, si->m5),
      so_3e = so_3c + so_3d, so_3e_right = so_3e - so_3c,
      so_3c_lo = ksl_product_rest(R->m00, si->m3, so_3a, so_3c - so_3c_right)
          + ksl_product_rest(R->m01, si->m4, so_3b, so_3c_right), so_3 = -so_3e;
  const double so_4a = KSL_MUL(R->m10, si->m3), so_4b = KSL_MUL(R->m11, si->m4),
      so_4c = so_4a + so_4b, so_4c_right = so_4c - so_4a, so_4d = KSL_MUL(R->m12, si->m5),
      so_4e = so_4c + so_4d, so_4e_right = so_4e - so_4c,
      so_4c_lo = ksl_product_rest(R->m10, si->m3, so_4a, so_4c - so_4c_right)
          + ksl_product_rest(R->m11, si->m4, so_4b, so_4c_right), so_4 = -so_4e;
  const double so_5a = KSL_MUL(R->m20, si->m3), so_5b = KSL_MUL(R->m21, si->m4),
      so_5c = so_5a + so_5b, so_5c_right = so_5c - so_5a, so_5d = KSL_MUL(R->m22, si->m5),
      so_5e = so_5c + so_5d, so_5e_right = so_5e - so_5c,
      so_5c_lo = ksl_product_rest(R->m20, si->m3, so_5a, so_5c - so_5c_right)
          + ksl_product_rest(R->m21, si->m4, so_5b, so_5c_right), so_5 = -so_5e;
  const double so_0_rounded = so_0 +
          -(so_0c - (so_0e - so_0e_right) + ksl_product_rest(R->m02, si->m2, so_0d, so_0e_right)
          + so_0c_lo),
      so_1_rounded = so_1 +
          -(so_1c - (so_1e - so_1e_right) + ksl_product_rest(R->m12, si->m2, so_1d, so_1e_right)
          + so_1c_lo),
      so_2_rounded = so_2 +
          -(so_2c - (so_2e - so_2e_right) + ksl_product_rest(R->m22, si->m2, so_2d, so_2e_right)
          + so_2c_lo),
      so_3_rounded = so_3 +
          -(so_3c - (so_3e - so_3e_right) + ksl_product_rest(R->m02, si->m5, so_3d, so_3e_right)
          + so_3c_lo),
      so_4_rounded = so_4 +
          -(so_4c - (so_4e - so_4e_right) + ksl_product_rest(R->m12, si->m5, so_4d, so_4e_right)
          + so_4c_lo),
      so_5_rounded = so_5 +
          -(so_5c - (so_5e - so_5e_right) + ksl_product_rest(R->m22, si->m5, so_5d, so_5e_right)
          + so_5c_lo);
  so->m0 = so_0_rounded;
  so->m1 = so_1_rounded;
  so->m2 = so_2_rounded;
  so->m3 = so_3_rounded;
  so->m4 = so_4_rounded;
  so->m5 = so_5_rounded;
}

/* so = [Ad](D) si = [Ad](t) [Ad](R) si.
   D: displacement [R | t], R rotation, t in m; si, so: screw (v in m/s; ω in rad/s).
   30 mul, 108 add, 24 product rest.
   Error <= u |result| + (lin: 35, ang: 11) u^2 S, S the sum of the |terms| of the expanded
     formula; barring over- and underflow. */
static inline void ksl_product_Ads_accurate(const ksl_SE3_t *D, const ksl_screw_t *si,
    ksl_screw_t *so) {
  const double w_0a = KSL_MUL(D->m00, si->m0), w_0b = KSL_MUL(D->m01, si->m1), w_0c = w_0a + w_0b,
      w_0c_right = w_0c - w_0a, w_0d = KSL_MUL(D->m02, si->m2), w_0 = w_0c + w_0d,
      w_0_right = w_0 - w_0c,
      w_0c_lo = ksl_product_rest(D->m00, si->m0, w_0a, w_0c - w_0c_right)
          + ksl_product_rest(D->m01, si->m1, w_0b, w_0c_right);
  const double w_1a = KSL_MUL(D->m10, si->m0), w_1b = KSL_MUL(D->m11, si->m1), w_1c = w_1a + w_1b,
      w_1c_right = w_1c - w_1a, w_1d = KSL_MUL(D->m12, si->m2), w_1 = w_1c + w_1d,
      w_1_right = w_1 - w_1c,
      w_1c_lo = ksl_product_rest(D->m10, si->m0, w_1a, w_1c - w_1c_right)
          + ksl_product_rest(D->m11, si->m1, w_1b, w_1c_right);
  const double w_2a = KSL_MUL(D->m20, si->m0), w_2b = KSL_MUL(D->m21, si->m1), w_2c = w_2a + w_2b,
      w_2c_right = w_2c - w_2a, w_2d = KSL_MUL(D->m22, si->m2), w_2 = w_2c + w_2d,
      w_2_right = w_2 - w_2c,
      w_2c_lo = ksl_product_rest(D->m20, si->m0, w_2a, w_2c - w_2c_right)
          + ksl_product_rest(D->m21, si->m1, w_2b, w_2c_right);
  const double w_3a = KSL_MUL(D->m00, si->m3), w_3b = KSL_MUL(D->m01, si->m4), w_3c = w_3a + w_3b,
      w_3c_right = w_3c - w_3a, w_3d = KSL_MUL(D->m02, si->m5), w_3 = w_3c + w_3d,
      w_3_right = w_3 - w_3c,
      w_3c_lo = ksl_product_rest(D->m00, si->m3, w_3a, w_3c - w_3c_right)
          + ksl_product_rest(D->m01, si->m4, w_3b, w_3c_right),
      w_3_lo = w_3c - (w_3 - w_3_right) + ksl_product_rest(D->m02, si->m5, w_3d, w_3_right)
          + w_3c_lo;
  const double w_4a = KSL_MUL(D->m10, si->m3), w_4b = KSL_MUL(D->m11, si->m4), w_4c = w_4a + w_4b,
      w_4c_right = w_4c - w_4a, w_4d = KSL_MUL(D->m12, si->m5), w_4 = w_4c + w_4d,
      w_4_right = w_4 - w_4c,
      w_4c_lo = ksl_product_rest(D->m10, si->m3, w_4a, w_4c - w_4c_right)
          + ksl_product_rest(D->m11, si->m4, w_4b, w_4c_right),
      w_4_lo = w_4c - (w_4 - w_4_right) + ksl_product_rest(D->m12, si->m5, w_4d, w_4_right)
          + w_4c_lo;
  const double w_5a = KSL_MUL(D->m20, si->m3), w_5b = KSL_MUL(D->m21, si->m4), w_5c = w_5a + w_5b,
      w_5c_right = w_5c - w_5a, w_5d = KSL_MUL(D->m22, si->m5), w_5 = w_5c + w_5d,
      w_5_right = w_5 - w_5c,
      w_5c_lo = ksl_product_rest(D->m20, si->m3, w_5a, w_5c - w_5c_right)
          + ksl_product_rest(D->m21, si->m4, w_5b, w_5c_right),
      w_5_lo = w_5c - (w_5 - w_5_right) + ksl_product_rest(D->m22, si->m5, w_5d, w_5_right)
          + w_5c_lo;
  const double so_0a = KSL_MUL(D->m13, w_5), so_0b = KSL_MUL(D->m23, w_4), so_0c = so_0a - so_0b,
      so_0c_right = so_0a - so_0c,
      so_0c_lo1 = ksl_product_rest(D->m13, w_5, so_0a, so_0c + so_0c_right)
          - ksl_product_rest(D->m23, w_4, so_0b, so_0c_right), so_0 = so_0c + w_0,
      so_0_right = so_0 - so_0c,
      so_0_lo2 = so_0c - (so_0 - so_0_right) + (w_0 - so_0_right)
          + (w_0c - (w_0 - w_0_right) + ksl_product_rest(D->m02, si->m2, w_0d, w_0_right)
          + w_0c_lo);
  const double so_1a = KSL_MUL(D->m23, w_3), so_1b = KSL_MUL(D->m03, w_5), so_1c = so_1a - so_1b,
      so_1c_right = so_1a - so_1c,
      so_1c_lo1 = ksl_product_rest(D->m23, w_3, so_1a, so_1c + so_1c_right)
          - ksl_product_rest(D->m03, w_5, so_1b, so_1c_right), so_1 = so_1c + w_1,
      so_1_right = so_1 - so_1c,
      so_1_lo2 = so_1c - (so_1 - so_1_right) + (w_1 - so_1_right)
          + (w_1c - (w_1 - w_1_right) + ksl_product_rest(D->m12, si->m2, w_1d, w_1_right)
          + w_1c_lo);
  const double so_2a = KSL_MUL(D->m03, w_4), so_2b = KSL_MUL(D->m13, w_3), so_2c = so_2a - so_2b,
      so_2c_right = so_2a - so_2c,
      so_2c_lo1 = ksl_product_rest(D->m03, w_4, so_2a, so_2c + so_2c_right)
          - ksl_product_rest(D->m13, w_3, so_2b, so_2c_right), so_2 = so_2c + w_2,
      so_2_right = so_2 - so_2c,
      so_2_lo2 = so_2c - (so_2 - so_2_right) + (w_2 - so_2_right)
          + (w_2c - (w_2 - w_2_right) + ksl_product_rest(D->m22, si->m2, w_2d, w_2_right)
          + w_2c_lo);
  const double so_0_rounded = so_0
          + (so_0_lo2 + (so_0c_lo1 + (KSL_MUL(D->m13, w_5_lo) - KSL_MUL(D->m23, w_4_lo)))),
      so_1_rounded = so_1
          + (so_1_lo2 + (so_1c_lo1 + (KSL_MUL(D->m23, w_3_lo) - KSL_MUL(D->m03, w_5_lo)))),
      so_2_rounded = so_2
          + (so_2_lo2 + (so_2c_lo1 + (KSL_MUL(D->m03, w_4_lo) - KSL_MUL(D->m13, w_3_lo))));
  const double w_3_rounded = w_3 + w_3_lo, w_4_rounded = w_4 + w_4_lo, w_5_rounded = w_5 + w_5_lo;
  so->m0 = so_0_rounded;
  so->m1 = so_1_rounded;
  so->m2 = so_2_rounded;
  so->m3 = w_3_rounded;
  so->m4 = w_4_rounded;
  so->m5 = w_5_rounded;
}

/* so = [Ad](D)^-1 si = [Ad](R^T) [Ad](-t) si.
   D: displacement [R | t], R rotation, t in m; si, so: screw (v in m/s; ω in rad/s).
   33 mul, 108 add, 24 product rest.
   Error <= u |result| + (lin: 35, ang: 11) u^2 S, S the sum of the |terms| of the expanded
     formula; barring over- and underflow. */
static inline void ksl_product_Adinvs_accurate(const ksl_SE3_t *D, const ksl_screw_t *si,
    ksl_screw_t *so) {
  const double w_0a = KSL_MUL(D->m23, si->m4), w_0b = KSL_MUL(D->m13, si->m5), w_0c = w_0a - w_0b,
      w_0c_right = w_0a - w_0c, w_0 = w_0c + si->m0, w_0_right = w_0 - w_0c,
      w_0c_lo = ksl_product_rest(D->m23, si->m4, w_0a, w_0c + w_0c_right)
          - ksl_product_rest(D->m13, si->m5, w_0b, w_0c_right),
      w_0_lo = w_0c - (w_0 - w_0_right) + (si->m0 - w_0_right) + w_0c_lo;
  const double w_1a = KSL_MUL(D->m03, si->m5), w_1b = KSL_MUL(D->m23, si->m3), w_1c = w_1a - w_1b,
      w_1c_right = w_1a - w_1c, w_1 = w_1c + si->m1, w_1_right = w_1 - w_1c,
      w_1c_lo = ksl_product_rest(D->m03, si->m5, w_1a, w_1c + w_1c_right)
          - ksl_product_rest(D->m23, si->m3, w_1b, w_1c_right),
      w_1_lo = w_1c - (w_1 - w_1_right) + (si->m1 - w_1_right) + w_1c_lo;
  const double w_2a = KSL_MUL(D->m13, si->m3), w_2b = KSL_MUL(D->m03, si->m4), w_2c = w_2a - w_2b,
      w_2c_right = w_2a - w_2c, w_2 = w_2c + si->m2, w_2_right = w_2 - w_2c,
      w_2c_lo = ksl_product_rest(D->m13, si->m3, w_2a, w_2c + w_2c_right)
          - ksl_product_rest(D->m03, si->m4, w_2b, w_2c_right),
      w_2_lo = w_2c - (w_2 - w_2_right) + (si->m2 - w_2_right) + w_2c_lo;
  const double so_0a = KSL_MUL(D->m00, w_0), so_0b = KSL_MUL(D->m10, w_1), so_0c = so_0a + so_0b,
      so_0c_right = so_0c - so_0a,
      so_0c_lo1 = ksl_product_rest(D->m00, w_0, so_0a, so_0c - so_0c_right)
          + ksl_product_rest(D->m10, w_1, so_0b, so_0c_right), so_0d = KSL_MUL(D->m20, w_2),
      so_0 = so_0c + so_0d, so_0_right = so_0 - so_0c,
      so_0_lo2 = so_0c - (so_0 - so_0_right) + ksl_product_rest(D->m20, w_2, so_0d, so_0_right)
          + KSL_MUL(D->m20, w_2_lo);
  const double so_1a = KSL_MUL(D->m01, w_0), so_1b = KSL_MUL(D->m11, w_1), so_1c = so_1a + so_1b,
      so_1c_right = so_1c - so_1a,
      so_1c_lo1 = ksl_product_rest(D->m01, w_0, so_1a, so_1c - so_1c_right)
          + ksl_product_rest(D->m11, w_1, so_1b, so_1c_right), so_1d = KSL_MUL(D->m21, w_2),
      so_1 = so_1c + so_1d, so_1_right = so_1 - so_1c,
      so_1_lo2 = so_1c - (so_1 - so_1_right) + ksl_product_rest(D->m21, w_2, so_1d, so_1_right)
          + KSL_MUL(D->m21, w_2_lo);
  const double so_2a = KSL_MUL(D->m02, w_0), so_2b = KSL_MUL(D->m12, w_1), so_2c = so_2a + so_2b,
      so_2c_right = so_2c - so_2a,
      so_2c_lo1 = ksl_product_rest(D->m02, w_0, so_2a, so_2c - so_2c_right)
          + ksl_product_rest(D->m12, w_1, so_2b, so_2c_right), so_2d = KSL_MUL(D->m22, w_2),
      so_2 = so_2c + so_2d, so_2_right = so_2 - so_2c,
      so_2_lo2 = so_2c - (so_2 - so_2_right) + ksl_product_rest(D->m22, w_2, so_2d, so_2_right)
          + KSL_MUL(D->m22, w_2_lo);
  const double so_3a = KSL_MUL(D->m00, si->m3), so_3b = KSL_MUL(D->m10, si->m4),
      so_3c = so_3a + so_3b, so_3c_right = so_3c - so_3a, so_3d = KSL_MUL(D->m20, si->m5),
      so_3 = so_3c + so_3d, so_3_right = so_3 - so_3c,
      so_3c_lo = ksl_product_rest(D->m00, si->m3, so_3a, so_3c - so_3c_right)
          + ksl_product_rest(D->m10, si->m4, so_3b, so_3c_right);
  const double so_4a = KSL_MUL(D->m01, si->m3), so_4b = KSL_MUL(D->m11, si->m4),
      so_4c = so_4a + so_4b, so_4c_right = so_4c - so_4a, so_4d = KSL_MUL(D->m21, si->m5),
      so_4 = so_4c + so_4d, so_4_right = so_4 - so_4c,
      so_4c_lo = ksl_product_rest(D->m01, si->m3, so_4a, so_4c - so_4c_right)
          + ksl_product_rest(D->m11, si->m4, so_4b, so_4c_right);
  const double so_5a = KSL_MUL(D->m02, si->m3), so_5b = KSL_MUL(D->m12, si->m4),
      so_5c = so_5a + so_5b, so_5c_right = so_5c - so_5a, so_5d = KSL_MUL(D->m22, si->m5),
      so_5 = so_5c + so_5d, so_5_right = so_5 - so_5c,
      so_5c_lo = ksl_product_rest(D->m02, si->m3, so_5a, so_5c - so_5c_right)
          + ksl_product_rest(D->m12, si->m4, so_5b, so_5c_right);
  const double so_0_rounded = so_0
          + (so_0_lo2 + (so_0c_lo1 + (KSL_MUL(D->m00, w_0_lo) + KSL_MUL(D->m10, w_1_lo)))),
      so_1_rounded = so_1
          + (so_1_lo2 + (so_1c_lo1 + (KSL_MUL(D->m01, w_0_lo) + KSL_MUL(D->m11, w_1_lo)))),
      so_2_rounded = so_2
          + (so_2_lo2 + (so_2c_lo1 + (KSL_MUL(D->m02, w_0_lo) + KSL_MUL(D->m12, w_1_lo)))),
      so_3_rounded = so_3
          + (so_3c - (so_3 - so_3_right) + ksl_product_rest(D->m20, si->m5, so_3d, so_3_right)
          + so_3c_lo),
      so_4_rounded = so_4
          + (so_4c - (so_4 - so_4_right) + ksl_product_rest(D->m21, si->m5, so_4d, so_4_right)
          + so_4c_lo),
      so_5_rounded = so_5
          + (so_5c - (so_5 - so_5_right) + ksl_product_rest(D->m22, si->m5, so_5d, so_5_right)
          + so_5c_lo);
  so->m0 = so_0_rounded;
  so->m1 = so_1_rounded;
  so->m2 = so_2_rounded;
  so->m3 = so_3_rounded;
  so->m4 = so_4_rounded;
  so->m5 = so_5_rounded;
}

/* so = [Ad](D) (-si).
   D: displacement [R | t], R rotation, t in m; si, so: screw (v in m/s; ω in rad/s).
   30 mul, 108 add, 24 product rest, 12 neg.
   Error <= u |result| + (lin: 35, ang: 11) u^2 S, S the sum of the |terms| of the expanded
     formula; barring over- and underflow. */
static inline void ksl_product_Adsinv_accurate(const ksl_SE3_t *D, const ksl_screw_t *si,
    ksl_screw_t *so) {
  const double w_0a = KSL_MUL(D->m00, si->m0), w_0b = KSL_MUL(D->m01, si->m1), w_0c = w_0a + w_0b,
      w_0c_right = w_0c - w_0a, w_0d = KSL_MUL(D->m02, si->m2), w_0e = w_0c + w_0d,
      w_0e_right = w_0e - w_0c,
      w_0c_lo = ksl_product_rest(D->m00, si->m0, w_0a, w_0c - w_0c_right)
          + ksl_product_rest(D->m01, si->m1, w_0b, w_0c_right), w_0 = -w_0e;
  const double w_1a = KSL_MUL(D->m10, si->m0), w_1b = KSL_MUL(D->m11, si->m1), w_1c = w_1a + w_1b,
      w_1c_right = w_1c - w_1a, w_1d = KSL_MUL(D->m12, si->m2), w_1e = w_1c + w_1d,
      w_1e_right = w_1e - w_1c,
      w_1c_lo = ksl_product_rest(D->m10, si->m0, w_1a, w_1c - w_1c_right)
          + ksl_product_rest(D->m11, si->m1, w_1b, w_1c_right), w_1 = -w_1e;
  const double w_2a = KSL_MUL(D->m20, si->m0), w_2b = KSL_MUL(D->m21, si->m1), w_2c = w_2a + w_2b,
      w_2c_right = w_2c - w_2a, w_2d = KSL_MUL(D->m22, si->m2), w_2e = w_2c + w_2d,
      w_2e_right = w_2e - w_2c,
      w_2c_lo = ksl_product_rest(D->m20, si->m0, w_2a, w_2c - w_2c_right)
          + ksl_product_rest(D->m21, si->m1, w_2b, w_2c_right), w_2 = -w_2e;
  const double w_3a = KSL_MUL(D->m00, si->m3), w_3b = KSL_MUL(D->m01, si->m4), w_3c = w_3a + w_3b,
      w_3c_right = w_3c - w_3a, w_3d = KSL_MUL(D->m02, si->m5), w_3e = w_3c + w_3d,
      w_3e_right = w_3e - w_3c,
      w_3c_lo = ksl_product_rest(D->m00, si->m3, w_3a, w_3c - w_3c_right)
          + ksl_product_rest(D->m01, si->m4, w_3b, w_3c_right), w_3 = -w_3e,
      w_3_lo =
          -(w_3c - (w_3e - w_3e_right) + ksl_product_rest(D->m02, si->m5, w_3d, w_3e_right)
          + w_3c_lo);
  const double w_4a = KSL_MUL(D->m10, si->m3), w_4b = KSL_MUL(D->m11, si->m4), w_4c = w_4a + w_4b,
      w_4c_right = w_4c - w_4a, w_4d = KSL_MUL(D->m12, si->m5), w_4e = w_4c + w_4d,
      w_4e_right = w_4e - w_4c,
      w_4c_lo = ksl_product_rest(D->m10, si->m3, w_4a, w_4c - w_4c_right)
          + ksl_product_rest(D->m11, si->m4, w_4b, w_4c_right), w_4 = -w_4e,
      w_4_lo =
          -(w_4c - (w_4e - w_4e_right) + ksl_product_rest(D->m12, si->m5, w_4d, w_4e_right)
          + w_4c_lo);
  const double w_5a = KSL_MUL(D->m20, si->m3), w_5b = KSL_MUL(D->m21, si->m4), w_5c = w_5a + w_5b,
      w_5c_right = w_5c - w_5a, w_5d = KSL_MUL(D->m22, si->m5), w_5e = w_5c + w_5d,
      w_5e_right = w_5e - w_5c,
      w_5c_lo = ksl_product_rest(D->m20, si->m3, w_5a, w_5c - w_5c_right)
          + ksl_product_rest(D->m21, si->m4, w_5b, w_5c_right), w_5 = -w_5e,
      w_5_lo =
          -(w_5c - (w_5e - w_5e_right) + ksl_product_rest(D->m22, si->m5, w_5d, w_5e_right)
          + w_5c_lo);
  const double so_0a = KSL_MUL(D->m13, w_5), so_0b = KSL_MUL(D->m23, w_4), so_0c = so_0a - so_0b,
      so_0c_right = so_0a - so_0c,
      so_0c_lo1 = ksl_product_rest(D->m13, w_5, so_0a, so_0c + so_0c_right)
          - ksl_product_rest(D->m23, w_4, so_0b, so_0c_right), so_0 = so_0c + w_0,
      so_0_right = so_0 - so_0c;
  const double w_0_lo =
          -(w_0c - (w_0e - w_0e_right) + ksl_product_rest(D->m02, si->m2, w_0d, w_0e_right)
          + w_0c_lo);
  const double so_1a = KSL_MUL(D->m23, w_3), so_1b = KSL_MUL(D->m03, w_5), so_1c = so_1a - so_1b,
      so_1c_right = so_1a - so_1c,
      so_1c_lo1 = ksl_product_rest(D->m23, w_3, so_1a, so_1c + so_1c_right)
          - ksl_product_rest(D->m03, w_5, so_1b, so_1c_right), so_1 = so_1c + w_1,
      so_1_right = so_1 - so_1c;
  const double w_1_lo =
          -(w_1c - (w_1e - w_1e_right) + ksl_product_rest(D->m12, si->m2, w_1d, w_1e_right)
          + w_1c_lo);
  const double so_2a = KSL_MUL(D->m03, w_4), so_2b = KSL_MUL(D->m13, w_3), so_2c = so_2a - so_2b,
      so_2c_right = so_2a - so_2c,
      so_2c_lo1 = ksl_product_rest(D->m03, w_4, so_2a, so_2c + so_2c_right)
          - ksl_product_rest(D->m13, w_3, so_2b, so_2c_right), so_2 = so_2c + w_2,
      so_2_right = so_2 - so_2c;
  const double w_2_lo =
          -(w_2c - (w_2e - w_2e_right) + ksl_product_rest(D->m22, si->m2, w_2d, w_2e_right)
          + w_2c_lo);
  const double so_0_rounded = so_0
          + (so_0c - (so_0 - so_0_right) + (w_0 - so_0_right) + w_0_lo
          + (so_0c_lo1 + (KSL_MUL(D->m13, w_5_lo) - KSL_MUL(D->m23, w_4_lo)))),
      so_1_rounded = so_1
          + (so_1c - (so_1 - so_1_right) + (w_1 - so_1_right) + w_1_lo
          + (so_1c_lo1 + (KSL_MUL(D->m23, w_3_lo) - KSL_MUL(D->m03, w_5_lo)))),
      so_2_rounded = so_2
          + (so_2c - (so_2 - so_2_right) + (w_2 - so_2_right) + w_2_lo
          + (so_2c_lo1 + (KSL_MUL(D->m03, w_4_lo) - KSL_MUL(D->m13, w_3_lo))));
  const double w_3_rounded = w_3 + w_3_lo, w_4_rounded = w_4 + w_4_lo, w_5_rounded = w_5 + w_5_lo;
  so->m0 = so_0_rounded;
  so->m1 = so_1_rounded;
  so->m2 = so_2_rounded;
  so->m3 = w_3_rounded;
  so->m4 = w_4_rounded;
  so->m5 = w_5_rounded;
}

/* so = h_rx: column 3 of [Ad](D).
   D: displacement [R | t], R rotation, t in m; so: screw (v in m/s; ω in rad/s).
   6 mul, 15 add, 6 product rest.
   Error <= u |result| + (lin: 6, ang: 0) u^2 S, S the sum of the |terms| of the expanded
     formula; barring over- and underflow. */
static inline void ksl_hsrx_accurate(const ksl_SE3_t *D, ksl_screw_t *so) {
  const double so_0a = KSL_MUL(D->m20, D->m13), so_0b = KSL_MUL(D->m10, D->m23),
      so_0 = so_0a - so_0b, so_0_right = so_0a - so_0;
  const double so_1a = KSL_MUL(D->m00, D->m23), so_1b = KSL_MUL(D->m20, D->m03),
      so_1 = so_1a - so_1b, so_1_right = so_1a - so_1;
  const double so_2a = KSL_MUL(D->m10, D->m03), so_2b = KSL_MUL(D->m00, D->m13),
      so_2 = so_2a - so_2b, so_2_right = so_2a - so_2;
  const double so_0_rounded = so_0
          + (ksl_product_rest(D->m20, D->m13, so_0a, so_0 + so_0_right)
          - ksl_product_rest(D->m10, D->m23, so_0b, so_0_right)),
      so_1_rounded = so_1
          + (ksl_product_rest(D->m00, D->m23, so_1a, so_1 + so_1_right)
          - ksl_product_rest(D->m20, D->m03, so_1b, so_1_right)),
      so_2_rounded = so_2
          + (ksl_product_rest(D->m10, D->m03, so_2a, so_2 + so_2_right)
          - ksl_product_rest(D->m00, D->m13, so_2b, so_2_right));
  const double D_m00 = D->m00;
  const double D_m10 = D->m10;
  const double D_m20 = D->m20;
  so->m0 = so_0_rounded;
  so->m1 = so_1_rounded;
  so->m2 = so_2_rounded;
  so->m3 = D_m00;
  so->m4 = D_m10;
  so->m5 = D_m20;
}

/* so = h_ry: column 4 of [Ad](D).
   D: displacement [R | t], R rotation, t in m; so: screw (v in m/s; ω in rad/s).
   6 mul, 15 add, 6 product rest.
   Error <= u |result| + (lin: 6, ang: 0) u^2 S, S the sum of the |terms| of the expanded
     formula; barring over- and underflow. */
static inline void ksl_hsry_accurate(const ksl_SE3_t *D, ksl_screw_t *so) {
  const double so_0a = KSL_MUL(D->m21, D->m13), so_0b = KSL_MUL(D->m11, D->m23),
      so_0 = so_0a - so_0b, so_0_right = so_0a - so_0;
  const double so_1a = KSL_MUL(D->m01, D->m23), so_1b = KSL_MUL(D->m21, D->m03),
      so_1 = so_1a - so_1b, so_1_right = so_1a - so_1;
  const double so_2a = KSL_MUL(D->m11, D->m03), so_2b = KSL_MUL(D->m01, D->m13),
      so_2 = so_2a - so_2b, so_2_right = so_2a - so_2;
  const double so_0_rounded = so_0
          + (ksl_product_rest(D->m21, D->m13, so_0a, so_0 + so_0_right)
          - ksl_product_rest(D->m11, D->m23, so_0b, so_0_right)),
      so_1_rounded = so_1
          + (ksl_product_rest(D->m01, D->m23, so_1a, so_1 + so_1_right)
          - ksl_product_rest(D->m21, D->m03, so_1b, so_1_right)),
      so_2_rounded = so_2
          + (ksl_product_rest(D->m11, D->m03, so_2a, so_2 + so_2_right)
          - ksl_product_rest(D->m01, D->m13, so_2b, so_2_right));
  const double D_m01 = D->m01;
  const double D_m11 = D->m11;
  const double D_m21 = D->m21;
  so->m0 = so_0_rounded;
  so->m1 = so_1_rounded;
  so->m2 = so_2_rounded;
  so->m3 = D_m01;
  so->m4 = D_m11;
  so->m5 = D_m21;
}

/* so = h_rz: column 5 of [Ad](D).
   D: displacement [R | t], R rotation, t in m; so: screw (v in m/s; ω in rad/s).
   6 mul, 15 add, 6 product rest.
   Error <= u |result| + (lin: 6, ang: 0) u^2 S, S the sum of the |terms| of the expanded
     formula; barring over- and underflow. */
static inline void ksl_hsrz_accurate(const ksl_SE3_t *D, ksl_screw_t *so) {
  const double so_0a = KSL_MUL(D->m22, D->m13), so_0b = KSL_MUL(D->m12, D->m23),
      so_0 = so_0a - so_0b, so_0_right = so_0a - so_0;
  const double so_1a = KSL_MUL(D->m02, D->m23), so_1b = KSL_MUL(D->m22, D->m03),
      so_1 = so_1a - so_1b, so_1_right = so_1a - so_1;
  const double so_2a = KSL_MUL(D->m12, D->m03), so_2b = KSL_MUL(D->m02, D->m13),
      so_2 = so_2a - so_2b, so_2_right = so_2a - so_2;
  const double so_0_rounded = so_0
          + (ksl_product_rest(D->m22, D->m13, so_0a, so_0 + so_0_right)
          - ksl_product_rest(D->m12, D->m23, so_0b, so_0_right)),
      so_1_rounded = so_1
          + (ksl_product_rest(D->m02, D->m23, so_1a, so_1 + so_1_right)
          - ksl_product_rest(D->m22, D->m03, so_1b, so_1_right)),
      so_2_rounded = so_2
          + (ksl_product_rest(D->m12, D->m03, so_2a, so_2 + so_2_right)
          - ksl_product_rest(D->m02, D->m13, so_2b, so_2_right));
  const double D_m02 = D->m02;
  const double D_m12 = D->m12;
  const double D_m22 = D->m22;
  so->m0 = so_0_rounded;
  so->m1 = so_1_rounded;
  so->m2 = so_2_rounded;
  so->m3 = D_m02;
  so->m4 = D_m12;
  so->m5 = D_m22;
}

/* so = -h_rx: -column 3 of [Ad](D).
   D: displacement [R | t], R rotation, t in m; so: screw (v in m/s; ω in rad/s).
   6 mul, 15 add, 6 product rest, 3 neg.
   Error <= u |result| + (lin: 6, ang: 0) u^2 S, S the sum of the |terms| of the expanded
     formula; barring over- and underflow. */
static inline void ksl_hsrxinv_accurate(const ksl_SE3_t *D, ksl_screw_t *so) {
  const double so_0a = KSL_MUL(D->m10, D->m23), so_0b = KSL_MUL(D->m20, D->m13),
      so_0 = so_0a - so_0b, so_0_right = so_0a - so_0;
  const double so_1a = KSL_MUL(D->m20, D->m03), so_1b = KSL_MUL(D->m00, D->m23),
      so_1 = so_1a - so_1b, so_1_right = so_1a - so_1;
  const double so_2a = KSL_MUL(D->m00, D->m13), so_2b = KSL_MUL(D->m10, D->m03),
      so_2 = so_2a - so_2b, so_2_right = so_2a - so_2;
  const double so_3 = -D->m00, so_4 = -D->m10, so_5 = -D->m20;
  const double so_0_rounded = so_0
          + (ksl_product_rest(D->m10, D->m23, so_0a, so_0 + so_0_right)
          - ksl_product_rest(D->m20, D->m13, so_0b, so_0_right)),
      so_1_rounded = so_1
          + (ksl_product_rest(D->m20, D->m03, so_1a, so_1 + so_1_right)
          - ksl_product_rest(D->m00, D->m23, so_1b, so_1_right)),
      so_2_rounded = so_2
          + (ksl_product_rest(D->m00, D->m13, so_2a, so_2 + so_2_right)
          - ksl_product_rest(D->m10, D->m03, so_2b, so_2_right));
  so->m0 = so_0_rounded;
  so->m1 = so_1_rounded;
  so->m2 = so_2_rounded;
  so->m3 = so_3;
  so->m4 = so_4;
  so->m5 = so_5;
}

/* so = -h_ry: -column 4 of [Ad](D).
   D: displacement [R | t], R rotation, t in m; so: screw (v in m/s; ω in rad/s).
   6 mul, 15 add, 6 product rest, 3 neg.
   Error <= u |result| + (lin: 6, ang: 0) u^2 S, S the sum of the |terms| of the expanded
     formula; barring over- and underflow. */
static inline void ksl_hsryinv_accurate(const ksl_SE3_t *D, ksl_screw_t *so) {
  const double so_0a = KSL_MUL(D->m11, D->m23), so_0b = KSL_MUL(D->m21, D->m13),
      so_0 = so_0a - so_0b, so_0_right = so_0a - so_0;
  const double so_1a = KSL_MUL(D->m21, D->m03), so_1b = KSL_MUL(D->m01, D->m23),
      so_1 = so_1a - so_1b, so_1_right = so_1a - so_1;
  const double so_2a = KSL_MUL(D->m01, D->m13), so_2b = KSL_MUL(D->m11, D->m03),
      so_2 = so_2a - so_2b, so_2_right = so_2a - so_2;
  const double so_3 = -D->m01, so_4 = -D->m11, so_5 = -D->m21;
  const double so_0_rounded = so_0
          + (ksl_product_rest(D->m11, D->m23, so_0a, so_0 + so_0_right)
          - ksl_product_rest(D->m21, D->m13, so_0b, so_0_right)),
      so_1_rounded = so_1
          + (ksl_product_rest(D->m21, D->m03, so_1a, so_1 + so_1_right)
          - ksl_product_rest(D->m01, D->m23, so_1b, so_1_right)),
      so_2_rounded = so_2
          + (ksl_product_rest(D->m01, D->m13, so_2a, so_2 + so_2_right)
          - ksl_product_rest(D->m11, D->m03, so_2b, so_2_right));
  so->m0 = so_0_rounded;
  so->m1 = so_1_rounded;
  so->m2 = so_2_rounded;
  so->m3 = so_3;
  so->m4 = so_4;
  so->m5 = so_5;
}

/* so = -h_rz: -column 5 of [Ad](D).
   D: displacement [R | t], R rotation, t in m; so: screw (v in m/s; ω in rad/s).
   6 mul, 15 add, 6 product rest, 3 neg.
   Error <= u |result| + (lin: 6, ang: 0) u^2 S, S the sum of the |terms| of the expanded
     formula; barring over- and underflow. */
static inline void ksl_hsrzinv_accurate(const ksl_SE3_t *D, ksl_screw_t *so) {
  const double so_0a = KSL_MUL(D->m12, D->m23), so_0b = KSL_MUL(D->m22, D->m13),
      so_0 = so_0a - so_0b, so_0_right = so_0a - so_0;
  const double so_1a = KSL_MUL(D->m22, D->m03), so_1b = KSL_MUL(D->m02, D->m23),
      so_1 = so_1a - so_1b, so_1_right = so_1a - so_1;
  const double so_2a = KSL_MUL(D->m02, D->m13), so_2b = KSL_MUL(D->m12, D->m03),
      so_2 = so_2a - so_2b, so_2_right = so_2a - so_2;
  const double so_3 = -D->m02, so_4 = -D->m12, so_5 = -D->m22;
  const double so_0_rounded = so_0
          + (ksl_product_rest(D->m12, D->m23, so_0a, so_0 + so_0_right)
          - ksl_product_rest(D->m22, D->m13, so_0b, so_0_right)),
      so_1_rounded = so_1
          + (ksl_product_rest(D->m22, D->m03, so_1a, so_1 + so_1_right)
          - ksl_product_rest(D->m02, D->m23, so_1b, so_1_right)),
      so_2_rounded = so_2
          + (ksl_product_rest(D->m02, D->m13, so_2a, so_2 + so_2_right)
          - ksl_product_rest(D->m12, D->m03, so_2b, so_2_right));
  so->m0 = so_0_rounded;
  so->m1 = so_1_rounded;
  so->m2 = so_2_rounded;
  so->m3 = so_3;
  so->m4 = so_4;
  so->m5 = so_5;
}

/* M = [Ad](D).
   D: displacement [R | t], R rotation, t in m; M: 6×6 operator.
   18 mul, 45 add, 18 product rest.
   Error <= u |result| + 6 u^2 S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_Ad_accurate(const ksl_SE3_t *D, ksl_mat6x6_t *M) {
  const double M_03a = KSL_MUL(D->m20, D->m13), M_03b = KSL_MUL(D->m10, D->m23),
      M_03 = M_03a - M_03b, M_03_right = M_03a - M_03;
  const double M_04a = KSL_MUL(D->m21, D->m13), M_04b = KSL_MUL(D->m11, D->m23),
      M_04 = M_04a - M_04b, M_04_right = M_04a - M_04;
  const double M_05a = KSL_MUL(D->m22, D->m13), M_05b = KSL_MUL(D->m12, D->m23),
      M_05 = M_05a - M_05b, M_05_right = M_05a - M_05;
  const double M_13a = KSL_MUL(D->m00, D->m23), M_13b = KSL_MUL(D->m20, D->m03),
      M_13 = M_13a - M_13b, M_13_right = M_13a - M_13;
  const double M_14a = KSL_MUL(D->m01, D->m23), M_14b = KSL_MUL(D->m21, D->m03),
      M_14 = M_14a - M_14b, M_14_right = M_14a - M_14;
  const double M_15a = KSL_MUL(D->m02, D->m23), M_15b = KSL_MUL(D->m22, D->m03),
      M_15 = M_15a - M_15b, M_15_right = M_15a - M_15;
  const double M_23a = KSL_MUL(D->m10, D->m03), M_23b = KSL_MUL(D->m00, D->m13),
      M_23 = M_23a - M_23b, M_23_right = M_23a - M_23;
  const double M_24a = KSL_MUL(D->m11, D->m03), M_24b = KSL_MUL(D->m01, D->m13),
      M_24 = M_24a - M_24b, M_24_right = M_24a - M_24;
  const double M_25a = KSL_MUL(D->m12, D->m03), M_25b = KSL_MUL(D->m02, D->m13),
      M_25 = M_25a - M_25b, M_25_right = M_25a - M_25;
  const double M_03_rounded = M_03
          + (ksl_product_rest(D->m20, D->m13, M_03a, M_03 + M_03_right)
          - ksl_product_rest(D->m10, D->m23, M_03b, M_03_right)),
      M_04_rounded = M_04
          + (ksl_product_rest(D->m21, D->m13, M_04a, M_04 + M_04_right)
          - ksl_product_rest(D->m11, D->m23, M_04b, M_04_right)),
      M_05_rounded = M_05
          + (ksl_product_rest(D->m22, D->m13, M_05a, M_05 + M_05_right)
          - ksl_product_rest(D->m12, D->m23, M_05b, M_05_right)),
      M_13_rounded = M_13
          + (ksl_product_rest(D->m00, D->m23, M_13a, M_13 + M_13_right)
          - ksl_product_rest(D->m20, D->m03, M_13b, M_13_right)),
      M_14_rounded = M_14
          + (ksl_product_rest(D->m01, D->m23, M_14a, M_14 + M_14_right)
          - ksl_product_rest(D->m21, D->m03, M_14b, M_14_right)),
      M_15_rounded = M_15
          + (ksl_product_rest(D->m02, D->m23, M_15a, M_15 + M_15_right)
          - ksl_product_rest(D->m22, D->m03, M_15b, M_15_right)),
      M_23_rounded = M_23
          + (ksl_product_rest(D->m10, D->m03, M_23a, M_23 + M_23_right)
          - ksl_product_rest(D->m00, D->m13, M_23b, M_23_right)),
      M_24_rounded = M_24
          + (ksl_product_rest(D->m11, D->m03, M_24a, M_24 + M_24_right)
          - ksl_product_rest(D->m01, D->m13, M_24b, M_24_right)),
      M_25_rounded = M_25
          + (ksl_product_rest(D->m12, D->m03, M_25a, M_25 + M_25_right)
          - ksl_product_rest(D->m02, D->m13, M_25b, M_25_right));
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
  M->at[3][0] = M_03_rounded;
  M->at[4][0] = M_04_rounded;
  M->at[5][0] = M_05_rounded;
  M->at[0][1] = D_m10;
  M->at[1][1] = D_m11;
  M->at[2][1] = D_m12;
  M->at[3][1] = M_13_rounded;
  M->at[4][1] = M_14_rounded;
  M->at[5][1] = M_15_rounded;
  M->at[0][2] = D_m20;
  M->at[1][2] = D_m21;
  M->at[2][2] = D_m22;
  M->at[3][2] = M_23_rounded;
  M->at[4][2] = M_24_rounded;
  M->at[5][2] = M_25_rounded;
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
   6 mul, 29 add, 6 product rest.
   Error <= u |result| + 19 u^2 S, S the sum of the |terms| of the expanded formula; barring
     over- and underflow. */
static inline double ksl_dot_cs_accurate(const ksl_coscrew_t *c, const ksl_screw_t *s) {
  const double power_a = KSL_MUL(c->m0, s->m0), power_b = KSL_MUL(c->m1, s->m1),
      power_c = power_a + power_b, power_c_right = power_c - power_a,
      power_d = KSL_MUL(c->m2, s->m2), power_e = power_c + power_d,
      power_e_right = power_e - power_c,
      power_c_lo = ksl_product_rest(c->m0, s->m0, power_a, power_c - power_c_right)
          + ksl_product_rest(c->m1, s->m1, power_b, power_c_right), power_f = KSL_MUL(c->m3, s->m3),
      power_g = KSL_MUL(c->m4, s->m4), power_h = power_f + power_g,
      power_h_right = power_h - power_f, power_i = KSL_MUL(c->m5, s->m5),
      power_j = power_h + power_i, power_j_right = power_j - power_h,
      power_h_lo = ksl_product_rest(c->m3, s->m3, power_f, power_h - power_h_right)
          + ksl_product_rest(c->m4, s->m4, power_g, power_h_right), power = power_e + power_j,
      power_right = power - power_e,
      power_j_lo = power_h - (power_j - power_j_right)
          + ksl_product_rest(c->m5, s->m5, power_i, power_j_right) + power_h_lo,
      power_e_lo = power_c - (power_e - power_e_right)
          + ksl_product_rest(c->m2, s->m2, power_d, power_e_right) + power_c_lo;
  const double power_rounded = power
          + (power_e - (power - power_right) + (power_j - power_right) + power_j_lo + power_e_lo);
  return power_rounded;
}

/* so = [ad](s1) s2 = (ω1×v2 + v1×ω2 ; ω1×ω2).  Exactly zero for s1 = s2, unless products
     overflow.
   s1, s2, so: screw (v in m/s; ω in rad/s).
   18 mul, 66 add, 18 product rest.
   Error <= u |result| + (lin: 12, ang: 6) u^2 S, S the sum of the |terms| of the expanded
     formula; barring over- and underflow. */
static inline void ksl_cross_ss_accurate(const ksl_screw_t *s1, const ksl_screw_t *s2,
    ksl_screw_t *so) {
  const double so_0a = KSL_MUL(s1->m1, s2->m5), so_0b = KSL_MUL(s1->m5, s2->m1),
      so_0c = so_0a - so_0b, so_0c_right = so_0a - so_0c, so_0d = KSL_MUL(s1->m4, s2->m2),
      so_0e = KSL_MUL(s1->m2, s2->m4), so_0f = so_0d - so_0e, so_0f_right = so_0d - so_0f,
      so_0 = so_0c + so_0f, so_0_right = so_0 - so_0c,
      so_0f_lo = ksl_product_rest(s1->m4, s2->m2, so_0d, so_0f + so_0f_right)
          - ksl_product_rest(s1->m2, s2->m4, so_0e, so_0f_right),
      so_0c_lo = ksl_product_rest(s1->m1, s2->m5, so_0a, so_0c + so_0c_right)
          - ksl_product_rest(s1->m5, s2->m1, so_0b, so_0c_right);
  const double so_1a = KSL_MUL(s1->m5, s2->m0), so_1b = KSL_MUL(s1->m0, s2->m5),
      so_1c = so_1a - so_1b, so_1c_right = so_1a - so_1c, so_1d = KSL_MUL(s1->m2, s2->m3),
      so_1e = KSL_MUL(s1->m3, s2->m2), so_1f = so_1d - so_1e, so_1f_right = so_1d - so_1f,
      so_1 = so_1c + so_1f, so_1_right = so_1 - so_1c,
      so_1f_lo = ksl_product_rest(s1->m2, s2->m3, so_1d, so_1f + so_1f_right)
          - ksl_product_rest(s1->m3, s2->m2, so_1e, so_1f_right),
      so_1c_lo = ksl_product_rest(s1->m5, s2->m0, so_1a, so_1c + so_1c_right)
          - ksl_product_rest(s1->m0, s2->m5, so_1b, so_1c_right);
  const double so_2a = KSL_MUL(s1->m0, s2->m4), so_2b = KSL_MUL(s1->m4, s2->m0),
      so_2c = so_2a - so_2b, so_2c_right = so_2a - so_2c, so_2d = KSL_MUL(s1->m3, s2->m1),
      so_2e = KSL_MUL(s1->m1, s2->m3), so_2f = so_2d - so_2e, so_2f_right = so_2d - so_2f,
      so_2 = so_2c + so_2f, so_2_right = so_2 - so_2c,
      so_2f_lo = ksl_product_rest(s1->m3, s2->m1, so_2d, so_2f + so_2f_right)
          - ksl_product_rest(s1->m1, s2->m3, so_2e, so_2f_right),
      so_2c_lo = ksl_product_rest(s1->m0, s2->m4, so_2a, so_2c + so_2c_right)
          - ksl_product_rest(s1->m4, s2->m0, so_2b, so_2c_right);
  const double so_3a = KSL_MUL(s1->m4, s2->m5), so_3b = KSL_MUL(s1->m5, s2->m4),
      so_3 = so_3a - so_3b, so_3_right = so_3a - so_3;
  const double so_4a = KSL_MUL(s1->m5, s2->m3), so_4b = KSL_MUL(s1->m3, s2->m5),
      so_4 = so_4a - so_4b, so_4_right = so_4a - so_4;
  const double so_5a = KSL_MUL(s1->m3, s2->m4), so_5b = KSL_MUL(s1->m4, s2->m3),
      so_5 = so_5a - so_5b, so_5_right = so_5a - so_5;
  const double so_0_rounded = so_0
          + (so_0c - (so_0 - so_0_right) + (so_0f - so_0_right) + so_0f_lo + so_0c_lo),
      so_1_rounded = so_1
          + (so_1c - (so_1 - so_1_right) + (so_1f - so_1_right) + so_1f_lo + so_1c_lo),
      so_2_rounded = so_2
          + (so_2c - (so_2 - so_2_right) + (so_2f - so_2_right) + so_2f_lo + so_2c_lo),
      so_3_rounded = so_3
          + (ksl_product_rest(s1->m4, s2->m5, so_3a, so_3 + so_3_right)
          - ksl_product_rest(s1->m5, s2->m4, so_3b, so_3_right)),
      so_4_rounded = so_4
          + (ksl_product_rest(s1->m5, s2->m3, so_4a, so_4 + so_4_right)
          - ksl_product_rest(s1->m3, s2->m5, so_4b, so_4_right)),
      so_5_rounded = so_5
          + (ksl_product_rest(s1->m3, s2->m4, so_5a, so_5 + so_5_right)
          - ksl_product_rest(s1->m4, s2->m3, so_5b, so_5_right));
  so->m0 = so_0_rounded;
  so->m1 = so_1_rounded;
  so->m2 = so_2_rounded;
  so->m3 = so_3_rounded;
  so->m4 = so_4_rounded;
  so->m5 = so_5_rounded;
}

/* so = (ω1×v2 ; 0).
   s1, s2, so: screw (v in m/s; ω in rad/s).
   6 mul, 15 add, 6 product rest.
   Error <= u |result| + (lin: 6, ang: 0) u^2 S, S the sum of the |terms| of the expanded
     formula; barring over- and underflow. */
static inline void ksl_cross_sst_accurate(const ksl_screw_t *s1, const ksl_screw_t *s2,
    ksl_screw_t *so) {
  const double so_0a = KSL_MUL(s1->m4, s2->m2), so_0b = KSL_MUL(s1->m5, s2->m1),
      so_0 = so_0a - so_0b, so_0_right = so_0a - so_0;
  const double so_1a = KSL_MUL(s1->m5, s2->m0), so_1b = KSL_MUL(s1->m3, s2->m2),
      so_1 = so_1a - so_1b, so_1_right = so_1a - so_1;
  const double so_2a = KSL_MUL(s1->m3, s2->m1), so_2b = KSL_MUL(s1->m4, s2->m0),
      so_2 = so_2a - so_2b, so_2_right = so_2a - so_2;
  const double so_0_rounded = so_0
          + (ksl_product_rest(s1->m4, s2->m2, so_0a, so_0 + so_0_right)
          - ksl_product_rest(s1->m5, s2->m1, so_0b, so_0_right)),
      so_1_rounded = so_1
          + (ksl_product_rest(s1->m5, s2->m0, so_1a, so_1 + so_1_right)
          - ksl_product_rest(s1->m3, s2->m2, so_1b, so_1_right)),
      so_2_rounded = so_2
          + (ksl_product_rest(s1->m3, s2->m1, so_2a, so_2 + so_2_right)
          - ksl_product_rest(s1->m4, s2->m0, so_2b, so_2_right));
  so->m0 = so_0_rounded;
  so->m1 = so_1_rounded;
  so->m2 = so_2_rounded;
  so->m3 = 0.0;
  so->m4 = 0.0;
  so->m5 = 0.0;
}

/* so = (t×R a ; R a), a = axis in the body's frame.
   D: displacement [R | t], R rotation, t in m; axis: vector; so: screw (v in m/s; ω in rad/s).
   21 mul, 54 add, 15 product rest.
   Error <= u |result| + (lin: 28, ang: 11) u^2 S, S the sum of the |terms| of the expanded
     formula; barring over- and underflow. */
static inline void ksl_hsra_accurate(const ksl_SE3_t *D, const ksl_vec3_t *axis, ksl_screw_t *so) {
  const double a_0a = KSL_MUL(D->m00, axis->x), a_0b = KSL_MUL(D->m01, axis->y), a_0c = a_0a + a_0b,
      a_0c_right = a_0c - a_0a, a_0d = KSL_MUL(D->m02, axis->z), a_0 = a_0c + a_0d,
      a_0_right = a_0 - a_0c,
      a_0c_lo = ksl_product_rest(D->m00, axis->x, a_0a, a_0c - a_0c_right)
          + ksl_product_rest(D->m01, axis->y, a_0b, a_0c_right),
      a_0_lo = a_0c - (a_0 - a_0_right) + ksl_product_rest(D->m02, axis->z, a_0d, a_0_right)
          + a_0c_lo;
  const double a_1a = KSL_MUL(D->m10, axis->x), a_1b = KSL_MUL(D->m11, axis->y), a_1c = a_1a + a_1b,
      a_1c_right = a_1c - a_1a, a_1d = KSL_MUL(D->m12, axis->z), a_1 = a_1c + a_1d,
      a_1_right = a_1 - a_1c,
      a_1c_lo = ksl_product_rest(D->m10, axis->x, a_1a, a_1c - a_1c_right)
          + ksl_product_rest(D->m11, axis->y, a_1b, a_1c_right),
      a_1_lo = a_1c - (a_1 - a_1_right) + ksl_product_rest(D->m12, axis->z, a_1d, a_1_right)
          + a_1c_lo;
  const double a_2a = KSL_MUL(D->m20, axis->x), a_2b = KSL_MUL(D->m21, axis->y), a_2c = a_2a + a_2b,
      a_2c_right = a_2c - a_2a, a_2d = KSL_MUL(D->m22, axis->z), a_2 = a_2c + a_2d,
      a_2_right = a_2 - a_2c,
      a_2c_lo = ksl_product_rest(D->m20, axis->x, a_2a, a_2c - a_2c_right)
          + ksl_product_rest(D->m21, axis->y, a_2b, a_2c_right),
      a_2_lo = a_2c - (a_2 - a_2_right) + ksl_product_rest(D->m22, axis->z, a_2d, a_2_right)
          + a_2c_lo;
  const double so_0a = KSL_MUL(D->m13, a_2), so_0b = KSL_MUL(D->m23, a_1), so_0 = so_0a - so_0b,
      so_0_right = so_0a - so_0,
      so_0_lo1 = ksl_product_rest(D->m13, a_2, so_0a, so_0 + so_0_right)
          - ksl_product_rest(D->m23, a_1, so_0b, so_0_right);
  const double so_1a = KSL_MUL(D->m23, a_0), so_1b = KSL_MUL(D->m03, a_2), so_1 = so_1a - so_1b,
      so_1_right = so_1a - so_1,
      so_1_lo1 = ksl_product_rest(D->m23, a_0, so_1a, so_1 + so_1_right)
          - ksl_product_rest(D->m03, a_2, so_1b, so_1_right);
  const double so_2a = KSL_MUL(D->m03, a_1), so_2b = KSL_MUL(D->m13, a_0), so_2 = so_2a - so_2b,
      so_2_right = so_2a - so_2,
      so_2_lo1 = ksl_product_rest(D->m03, a_1, so_2a, so_2 + so_2_right)
          - ksl_product_rest(D->m13, a_0, so_2b, so_2_right);
  const double so_0_rounded = so_0
          + (so_0_lo1 + (KSL_MUL(D->m13, a_2_lo) - KSL_MUL(D->m23, a_1_lo))),
      so_1_rounded = so_1 + (so_1_lo1 + (KSL_MUL(D->m23, a_0_lo) - KSL_MUL(D->m03, a_2_lo))),
      so_2_rounded = so_2 + (so_2_lo1 + (KSL_MUL(D->m03, a_1_lo) - KSL_MUL(D->m13, a_0_lo)));
  const double a_0_rounded = a_0 + a_0_lo, a_1_rounded = a_1 + a_1_lo, a_2_rounded = a_2 + a_2_lo;
  so->m0 = so_0_rounded;
  so->m1 = so_1_rounded;
  so->m2 = so_2_rounded;
  so->m3 = a_0_rounded;
  so->m4 = a_1_rounded;
  so->m5 = a_2_rounded;
}

/* so = (R a ; 0), a = axis in the body's frame.
   D: displacement [R | t], R rotation, t in m; axis: vector; so: screw (v in m/s; ω in rad/s).
   9 mul, 33 add, 9 product rest.
   Error <= u |result| + (lin: 11, ang: 0) u^2 S, S the sum of the |terms| of the expanded
     formula; barring over- and underflow. */
static inline void ksl_hsta_accurate(const ksl_SE3_t *D, const ksl_vec3_t *axis, ksl_screw_t *so) {
  const double so_0a = KSL_MUL(D->m00, axis->x), so_0b = KSL_MUL(D->m01, axis->y),
      so_0c = so_0a + so_0b, so_0c_right = so_0c - so_0a, so_0d = KSL_MUL(D->m02, axis->z),
      so_0 = so_0c + so_0d, so_0_right = so_0 - so_0c,
      so_0c_lo = ksl_product_rest(D->m00, axis->x, so_0a, so_0c - so_0c_right)
          + ksl_product_rest(D->m01, axis->y, so_0b, so_0c_right);
  const double so_1a = KSL_MUL(D->m10, axis->x), so_1b = KSL_MUL(D->m11, axis->y),
      so_1c = so_1a + so_1b, so_1c_right = so_1c - so_1a, so_1d = KSL_MUL(D->m12, axis->z),
      so_1 = so_1c + so_1d, so_1_right = so_1 - so_1c,
      so_1c_lo = ksl_product_rest(D->m10, axis->x, so_1a, so_1c - so_1c_right)
          + ksl_product_rest(D->m11, axis->y, so_1b, so_1c_right);
  const double so_2a = KSL_MUL(D->m20, axis->x), so_2b = KSL_MUL(D->m21, axis->y),
      so_2c = so_2a + so_2b, so_2c_right = so_2c - so_2a, so_2d = KSL_MUL(D->m22, axis->z),
      so_2 = so_2c + so_2d, so_2_right = so_2 - so_2c,
      so_2c_lo = ksl_product_rest(D->m20, axis->x, so_2a, so_2c - so_2c_right)
          + ksl_product_rest(D->m21, axis->y, so_2b, so_2c_right);
  const double so_0_rounded = so_0
          + (so_0c - (so_0 - so_0_right) + ksl_product_rest(D->m02, axis->z, so_0d, so_0_right)
          + so_0c_lo),
      so_1_rounded = so_1
          + (so_1c - (so_1 - so_1_right) + ksl_product_rest(D->m12, axis->z, so_1d, so_1_right)
          + so_1c_lo),
      so_2_rounded = so_2
          + (so_2c - (so_2 - so_2_right) + ksl_product_rest(D->m22, axis->z, so_2d, so_2_right)
          + so_2c_lo);
  so->m0 = so_0_rounded;
  so->m1 = so_1_rounded;
  so->m2 = so_2_rounded;
  so->m3 = 0.0;
  so->m4 = 0.0;
  so->m5 = 0.0;
}

/* so = -(t×R a ; R a), a = axis in the body's frame.
   D: displacement [R | t], R rotation, t in m; axis: vector; so: screw (v in m/s; ω in rad/s).
   21 mul, 54 add, 15 product rest, 6 neg.
   Error <= u |result| + (lin: 28, ang: 11) u^2 S, S the sum of the |terms| of the expanded
     formula; barring over- and underflow. */
static inline void ksl_hsrainv_accurate(const ksl_SE3_t *D, const ksl_vec3_t *axis,
    ksl_screw_t *so) {
  const double a_0a = KSL_MUL(D->m00, axis->x), a_0b = KSL_MUL(D->m01, axis->y), a_0c = a_0a + a_0b,
      a_0c_right = a_0c - a_0a, a_0d = KSL_MUL(D->m02, axis->z), a_0e = a_0c + a_0d,
      a_0e_right = a_0e - a_0c,
      a_0c_lo = ksl_product_rest(D->m00, axis->x, a_0a, a_0c - a_0c_right)
          + ksl_product_rest(D->m01, axis->y, a_0b, a_0c_right), a_0 = -a_0e,
      a_0_lo =
          -(a_0c - (a_0e - a_0e_right) + ksl_product_rest(D->m02, axis->z, a_0d, a_0e_right)
          + a_0c_lo);
  const double a_1a = KSL_MUL(D->m10, axis->x), a_1b = KSL_MUL(D->m11, axis->y), a_1c = a_1a + a_1b,
      a_1c_right = a_1c - a_1a, a_1d = KSL_MUL(D->m12, axis->z), a_1e = a_1c + a_1d,
      a_1e_right = a_1e - a_1c,
      a_1c_lo = ksl_product_rest(D->m10, axis->x, a_1a, a_1c - a_1c_right)
          + ksl_product_rest(D->m11, axis->y, a_1b, a_1c_right), a_1 = -a_1e,
      a_1_lo =
          -(a_1c - (a_1e - a_1e_right) + ksl_product_rest(D->m12, axis->z, a_1d, a_1e_right)
          + a_1c_lo);
  const double a_2a = KSL_MUL(D->m20, axis->x), a_2b = KSL_MUL(D->m21, axis->y), a_2c = a_2a + a_2b,
      a_2c_right = a_2c - a_2a, a_2d = KSL_MUL(D->m22, axis->z), a_2e = a_2c + a_2d,
      a_2e_right = a_2e - a_2c,
      a_2c_lo = ksl_product_rest(D->m20, axis->x, a_2a, a_2c - a_2c_right)
          + ksl_product_rest(D->m21, axis->y, a_2b, a_2c_right), a_2 = -a_2e,
      a_2_lo =
          -(a_2c - (a_2e - a_2e_right) + ksl_product_rest(D->m22, axis->z, a_2d, a_2e_right)
          + a_2c_lo);
  const double so_0a = KSL_MUL(D->m13, a_2), so_0b = KSL_MUL(D->m23, a_1), so_0 = so_0a - so_0b,
      so_0_right = so_0a - so_0,
      so_0_lo1 = ksl_product_rest(D->m13, a_2, so_0a, so_0 + so_0_right)
          - ksl_product_rest(D->m23, a_1, so_0b, so_0_right);
  const double so_1a = KSL_MUL(D->m23, a_0), so_1b = KSL_MUL(D->m03, a_2), so_1 = so_1a - so_1b,
      so_1_right = so_1a - so_1,
      so_1_lo1 = ksl_product_rest(D->m23, a_0, so_1a, so_1 + so_1_right)
          - ksl_product_rest(D->m03, a_2, so_1b, so_1_right);
  const double so_2a = KSL_MUL(D->m03, a_1), so_2b = KSL_MUL(D->m13, a_0), so_2 = so_2a - so_2b,
      so_2_right = so_2a - so_2,
      so_2_lo1 = ksl_product_rest(D->m03, a_1, so_2a, so_2 + so_2_right)
          - ksl_product_rest(D->m13, a_0, so_2b, so_2_right);
  const double so_0_rounded = so_0
          + (so_0_lo1 + (KSL_MUL(D->m13, a_2_lo) - KSL_MUL(D->m23, a_1_lo))),
      so_1_rounded = so_1 + (so_1_lo1 + (KSL_MUL(D->m23, a_0_lo) - KSL_MUL(D->m03, a_2_lo))),
      so_2_rounded = so_2 + (so_2_lo1 + (KSL_MUL(D->m03, a_1_lo) - KSL_MUL(D->m13, a_0_lo)));
  const double a_0_rounded = a_0 + a_0_lo, a_1_rounded = a_1 + a_1_lo, a_2_rounded = a_2 + a_2_lo;
  so->m0 = so_0_rounded;
  so->m1 = so_1_rounded;
  so->m2 = so_2_rounded;
  so->m3 = a_0_rounded;
  so->m4 = a_1_rounded;
  so->m5 = a_2_rounded;
}

/* so = -(R a ; 0), a = axis in the body's frame.
   D: displacement [R | t], R rotation, t in m; axis: vector; so: screw (v in m/s; ω in rad/s).
   9 mul, 33 add, 9 product rest, 6 neg.
   Error <= u |result| + (lin: 11, ang: 0) u^2 S, S the sum of the |terms| of the expanded
     formula; barring over- and underflow. */
static inline void ksl_hstainv_accurate(const ksl_SE3_t *D, const ksl_vec3_t *axis,
    ksl_screw_t *so) {
  const double so_0a = KSL_MUL(D->m00, axis->x), so_0b = KSL_MUL(D->m01, axis->y),
      so_0c = so_0a + so_0b, so_0c_right = so_0c - so_0a, so_0d = KSL_MUL(D->m02, axis->z),
      so_0e = so_0c + so_0d, so_0e_right = so_0e - so_0c,
      so_0c_lo = ksl_product_rest(D->m00, axis->x, so_0a, so_0c - so_0c_right)
          + ksl_product_rest(D->m01, axis->y, so_0b, so_0c_right), so_0 = -so_0e;
  const double so_1a = KSL_MUL(D->m10, axis->x), so_1b = KSL_MUL(D->m11, axis->y),
      so_1c = so_1a + so_1b, so_1c_right = so_1c - so_1a, so_1d = KSL_MUL(D->m12, axis->z),
      so_1e = so_1c + so_1d, so_1e_right = so_1e - so_1c,
      so_1c_lo = ksl_product_rest(D->m10, axis->x, so_1a, so_1c - so_1c_right)
          + ksl_product_rest(D->m11, axis->y, so_1b, so_1c_right), so_1 = -so_1e;
  const double so_2a = KSL_MUL(D->m20, axis->x), so_2b = KSL_MUL(D->m21, axis->y),
      so_2c = so_2a + so_2b, so_2c_right = so_2c - so_2a, so_2d = KSL_MUL(D->m22, axis->z),
      so_2e = so_2c + so_2d, so_2e_right = so_2e - so_2c,
      so_2c_lo = ksl_product_rest(D->m20, axis->x, so_2a, so_2c - so_2c_right)
          + ksl_product_rest(D->m21, axis->y, so_2b, so_2c_right), so_2 = -so_2e;
  const double so_0_rounded = so_0 +
          -(so_0c - (so_0e - so_0e_right) + ksl_product_rest(D->m02, axis->z, so_0d, so_0e_right)
          + so_0c_lo),
      so_1_rounded = so_1 +
          -(so_1c - (so_1e - so_1e_right) + ksl_product_rest(D->m12, axis->z, so_1d, so_1e_right)
          + so_1c_lo),
      so_2_rounded = so_2 +
          -(so_2c - (so_2e - so_2e_right) + ksl_product_rest(D->m22, axis->z, so_2d, so_2e_right)
          + so_2c_lo);
  so->m0 = so_0_rounded;
  so->m1 = so_1_rounded;
  so->m2 = so_2_rounded;
  so->m3 = 0.0;
  so->m4 = 0.0;
  so->m5 = 0.0;
}

/* self = a self.
   self: screw (v in m/s; ω in rad/s); a: number.
   6 mul.
   Error <= u |result| + 1/32 u^2 S, S the sum of the |terms| of the expanded formula; barring
     over- and underflow. */
static inline void ksl_screwf_scale_accurate(ksl_screwf_t *self, const float a) {
  const double self_0_new = (double)self->m0 * (double)a, self_1_new = (double)self->m1 * (double)a,
      self_2_new = (double)self->m2 * (double)a, self_3_new = (double)self->m3 * (double)a,
      self_4_new = (double)self->m4 * (double)a, self_5_new = (double)self->m5 * (double)a;
  self->m0 = (float)self_0_new;
  self->m1 = (float)self_1_new;
  self->m2 = (float)self_2_new;
  self->m3 = (float)self_3_new;
  self->m4 = (float)self_4_new;
  self->m5 = (float)self_5_new;
}

/* y = a x + y.
   a: number; x, y: screw (v in m/s; ω in rad/s).
   6 mul, 6 add.
   Error <= u |result| + 1/16 u^2 S, S the sum of the |terms| of the expanded formula; barring
     over- and underflow. */
static inline void ksl_axpy_ssf_accurate(const float a, const ksl_screwf_t *x, ksl_screwf_t *y) {
  const double y_0_new = ksl_product_sum((double)a, (double)x->m0, (double)y->m0),
      y_1_new = ksl_product_sum((double)a, (double)x->m1, (double)y->m1),
      y_2_new = ksl_product_sum((double)a, (double)x->m2, (double)y->m2),
      y_3_new = ksl_product_sum((double)a, (double)x->m3, (double)y->m3),
      y_4_new = ksl_product_sum((double)a, (double)x->m4, (double)y->m4),
      y_5_new = ksl_product_sum((double)a, (double)x->m5, (double)y->m5);
  y->m0 = (float)y_0_new;
  y->m1 = (float)y_1_new;
  y->m2 = (float)y_2_new;
  y->m3 = (float)y_3_new;
  y->m4 = (float)y_4_new;
  y->m5 = (float)y_5_new;
}

/* y = x + y.
   x, y: screw (v in m/s; ω in rad/s).
   6 add.
   Error <= u |result| + 1/32 u^2 S, S the sum of the |terms| of the expanded formula; barring
     over- and underflow. */
static inline void ksl_xpy_ssf_accurate(const ksl_screwf_t *x, ksl_screwf_t *y) {
  const double y_0_new = (double)x->m0 + (double)y->m0, y_1_new = (double)x->m1 + (double)y->m1,
      y_2_new = (double)x->m2 + (double)y->m2, y_3_new = (double)x->m3 + (double)y->m3,
      y_4_new = (double)x->m4 + (double)y->m4, y_5_new = (double)x->m5 + (double)y->m5;
  y->m0 = (float)y_0_new;
  y->m1 = (float)y_1_new;
  y->m2 = (float)y_2_new;
  y->m3 = (float)y_3_new;
  y->m4 = (float)y_4_new;
  y->m5 = (float)y_5_new;
}

/* y = -x + y.
   x, y: screw (v in m/s; ω in rad/s).
   6 add.
   Error <= u |result| + 1/32 u^2 S, S the sum of the |terms| of the expanded formula; barring
     over- and underflow. */
static inline void ksl_nxpy_ssf_accurate(const ksl_screwf_t *x, ksl_screwf_t *y) {
  const double y_0_new = (double)y->m0 - (double)x->m0, y_1_new = (double)y->m1 - (double)x->m1,
      y_2_new = (double)y->m2 - (double)x->m2, y_3_new = (double)y->m3 - (double)x->m3,
      y_4_new = (double)y->m4 - (double)x->m4, y_5_new = (double)y->m5 - (double)x->m5;
  y->m0 = (float)y_0_new;
  y->m1 = (float)y_1_new;
  y->m2 = (float)y_2_new;
  y->m3 = (float)y_3_new;
  y->m4 = (float)y_4_new;
  y->m5 = (float)y_5_new;
}

/* so = a si.
   a: number; si, so: screw (v in m/s; ω in rad/s).
   6 mul.
   Error <= u |result| + 1/32 u^2 S, S the sum of the |terms| of the expanded formula; barring
     over- and underflow. */
static inline void ksl_product_asf_accurate(const float a, const ksl_screwf_t *si,
    ksl_screwf_t *so) {
  const double so_0 = (double)a * (double)si->m0, so_1 = (double)a * (double)si->m1,
      so_2 = (double)a * (double)si->m2, so_3 = (double)a * (double)si->m3,
      so_4 = (double)a * (double)si->m4, so_5 = (double)a * (double)si->m5;
  so->m0 = (float)so_0;
  so->m1 = (float)so_1;
  so->m2 = (float)so_2;
  so->m3 = (float)so_3;
  so->m4 = (float)so_4;
  so->m5 = (float)so_5;
}

/* so = s1 + s2.
   s1, s2, so: screw (v in m/s; ω in rad/s).
   6 add.
   Error <= u |result| + 1/32 u^2 S, S the sum of the |terms| of the expanded formula; barring
     over- and underflow. */
static inline void ksl_add_ssf_accurate(const ksl_screwf_t *s1, const ksl_screwf_t *s2,
    ksl_screwf_t *so) {
  const double so_0 = (double)s1->m0 + (double)s2->m0, so_1 = (double)s1->m1 + (double)s2->m1,
      so_2 = (double)s1->m2 + (double)s2->m2, so_3 = (double)s1->m3 + (double)s2->m3,
      so_4 = (double)s1->m4 + (double)s2->m4, so_5 = (double)s1->m5 + (double)s2->m5;
  so->m0 = (float)so_0;
  so->m1 = (float)so_1;
  so->m2 = (float)so_2;
  so->m3 = (float)so_3;
  so->m4 = (float)so_4;
  so->m5 = (float)so_5;
}

/* so = s1 - s2.
   s1, s2, so: screw (v in m/s; ω in rad/s).
   6 add.
   Error <= u |result| + 1/32 u^2 S, S the sum of the |terms| of the expanded formula; barring
     over- and underflow. */
static inline void ksl_subtract_ssf_accurate(const ksl_screwf_t *s1, const ksl_screwf_t *s2,
    ksl_screwf_t *so) {
  const double so_0 = (double)s1->m0 - (double)s2->m0, so_1 = (double)s1->m1 - (double)s2->m1,
      so_2 = (double)s1->m2 - (double)s2->m2, so_3 = (double)s1->m3 - (double)s2->m3,
      so_4 = (double)s1->m4 - (double)s2->m4, so_5 = (double)s1->m5 - (double)s2->m5;
  so->m0 = (float)so_0;
  so->m1 = (float)so_1;
  so->m2 = (float)so_2;
  so->m3 = (float)so_3;
  so->m4 = (float)so_4;
  so->m5 = (float)so_5;
}

/* |si|: |ω|, or |v| where every |ω_i| is below 1e-9 (single: 1e-6).
   si: screw (v in m/s; ω in rad/s).
   7 mul, 2 add, 1 sqrt, 6 abs, 11 less, 1 equal, 14 select. */
static inline float ksl_screwf_norm_accurate(const ksl_screwf_t *si) {
  const double small_c = fabs((double)si->m5) < 9.999999974752427e-07 ? 1.0 : 0.0,
      small_f = fabs((double)si->m4) < 9.999999974752427e-07 ? small_c : 0.0,
      small = fabs((double)si->m3) < 9.999999974752427e-07 ? small_f : 0.0;
  const double p_0 = small == 1.0 ? (double)si->m0 : (double)si->m3,
      p_1 = small == 1.0 ? (double)si->m1 : (double)si->m4,
      p_2 = small == 1.0 ? (double)si->m2 : (double)si->m5;
  const double s_size_0 = fabs(p_0), s_size_1 = fabs(p_1), s_size_2 = fabs(p_2);
  const double s_largest1 = s_size_0 < s_size_1 ? s_size_1 : s_size_0;
  const double s_largest2 = s_largest1 < s_size_2 ? s_size_2 : s_largest1;
  const double s_b = 4.611686018427388e+18 < s_largest2 ? 2.710505431213761e-20 : 1.0,
      s_d = s_largest2 < 256.0 ? 1.8014398509481984e+16 : s_b,
      s = s_largest2 < 1.4210854715202004e-14 ? 3.2451855365842673e+32 : s_d;
  const double y_0 = KSL_MUL(p_0, s), y_1 = KSL_MUL(p_1, s), y_2 = KSL_MUL(p_2, s);
  const double n = sqrt(KSL_MUL(y_0, y_0) + KSL_MUL(y_1, y_1) + KSL_MUL(y_2, y_2));
  const double r_b = s < 1.0 ? 3.6893488147419103e+19 : 1.0,
      r_d = 1.0 < s ? 5.551115123125783e-17 : r_b,
      r = 1.8014398509481984e+16 < s ? 3.0814879110195774e-33 : r_d;
  const double norm = KSL_MUL(n, r);
  return (float)norm;
}

/* self = self / |self|, with screw_norm; the zero screw stays zero.
   self: screw (v in m/s; ω in rad/s).
   18 mul, 2 add, 6 div, 1 sqrt, 9 abs, 16 less, 2 equal, 26 select. */
static inline void ksl_screwf_normalize_accurate(ksl_screwf_t *self) {
  const double small_a = fabs((double)self->m5),
      small_c = small_a < 9.999999974752427e-07 ? 1.0 : 0.0, small_d = fabs((double)self->m4),
      small_f = small_d < 9.999999974752427e-07 ? small_c : 0.0, small_g = fabs((double)self->m3),
      small = small_g < 9.999999974752427e-07 ? small_f : 0.0;
  const double p_0 = small == 1.0 ? (double)self->m0 : (double)self->m3,
      p_1 = small == 1.0 ? (double)self->m1 : (double)self->m4,
      p_2 = small == 1.0 ? (double)self->m2 : (double)self->m5;
  const double s_size_0 = fabs(p_0), s_size_1 = fabs(p_1), s_size_2 = fabs(p_2);
  const double s_largest1 = s_size_0 < s_size_1 ? s_size_1 : s_size_0;
  const double s_largest2 = s_largest1 < s_size_2 ? s_size_2 : s_largest1;
  const double s_b = 4.611686018427388e+18 < s_largest2 ? 2.710505431213761e-20 : 1.0,
      s_d = s_largest2 < 256.0 ? 1.8014398509481984e+16 : s_b,
      s = s_largest2 < 1.4210854715202004e-14 ? 3.2451855365842673e+32 : s_d;
  const double y_0 = KSL_MUL(p_0, s), y_1 = KSL_MUL(p_1, s), y_2 = KSL_MUL(p_2, s);
  const double up = 1.0 < s ? s : 1.0;
  const double down = s < 1.0 ? s : 1.0;
  const double n = sqrt(KSL_MUL(y_0, y_0) + KSL_MUL(y_1, y_1) + KSL_MUL(y_2, y_2));
  const double divisor = n == 0.0 ? up : n;
  const double size_0 = fabs((double)self->m0), size_1 = fabs((double)self->m1),
      size_2 = fabs((double)self->m2);
  const double before_0 = size_0 < 256.0 ? up : down, before_1 = size_1 < 256.0 ? up : down,
      before_2 = size_2 < 256.0 ? up : down, before_3 = small_g < 256.0 ? up : down,
      before_4 = small_d < 256.0 ? up : down, before_5 = small_a < 256.0 ? up : down;
  const double after_0 = size_0 < 256.0 ? down : up, after_1 = size_1 < 256.0 ? down : up,
      after_2 = size_2 < 256.0 ? down : up, after_3 = small_g < 256.0 ? down : up,
      after_4 = small_d < 256.0 ? down : up, after_5 = small_a < 256.0 ? down : up;
  const double sized_0 = KSL_MUL((double)self->m0, before_0),
      sized_1 = KSL_MUL((double)self->m1, before_1), sized_2 = KSL_MUL((double)self->m2, before_2),
      sized_3 = KSL_MUL((double)self->m3, before_3), sized_4 = KSL_MUL((double)self->m4, before_4),
      sized_5 = KSL_MUL((double)self->m5, before_5);
  const double quotient_0 = sized_0 / divisor, quotient_1 = sized_1 / divisor,
      quotient_2 = sized_2 / divisor, quotient_3 = sized_3 / divisor,
      quotient_4 = sized_4 / divisor, quotient_5 = sized_5 / divisor;
  const double self_0_new = KSL_MUL(quotient_0, after_0), self_1_new = KSL_MUL(quotient_1, after_1),
      self_2_new = KSL_MUL(quotient_2, after_2), self_3_new = KSL_MUL(quotient_3, after_3),
      self_4_new = KSL_MUL(quotient_4, after_4), self_5_new = KSL_MUL(quotient_5, after_5);
  self->m0 = (float)self_0_new;
  self->m1 = (float)self_1_new;
  self->m2 = (float)self_2_new;
  self->m3 = (float)self_3_new;
  self->m4 = (float)self_4_new;
  self->m5 = (float)self_5_new;
}

/* so = si / |si|, with screw_norm; the zero screw stays zero.
   si, so: screw (v in m/s; ω in rad/s).
   18 mul, 2 add, 6 div, 1 sqrt, 9 abs, 16 less, 2 equal, 26 select. */
static inline void ksl_screwf_normalized_accurate(const ksl_screwf_t *si, ksl_screwf_t *so) {
  const double small_a = fabs((double)si->m5),
      small_c = small_a < 9.999999974752427e-07 ? 1.0 : 0.0, small_d = fabs((double)si->m4),
      small_f = small_d < 9.999999974752427e-07 ? small_c : 0.0, small_g = fabs((double)si->m3),
      small = small_g < 9.999999974752427e-07 ? small_f : 0.0;
  const double p_0 = small == 1.0 ? (double)si->m0 : (double)si->m3,
      p_1 = small == 1.0 ? (double)si->m1 : (double)si->m4,
      p_2 = small == 1.0 ? (double)si->m2 : (double)si->m5;
  const double s_size_0 = fabs(p_0), s_size_1 = fabs(p_1), s_size_2 = fabs(p_2);
  const double s_largest1 = s_size_0 < s_size_1 ? s_size_1 : s_size_0;
  const double s_largest2 = s_largest1 < s_size_2 ? s_size_2 : s_largest1;
  const double s_b = 4.611686018427388e+18 < s_largest2 ? 2.710505431213761e-20 : 1.0,
      s_d = s_largest2 < 256.0 ? 1.8014398509481984e+16 : s_b,
      s = s_largest2 < 1.4210854715202004e-14 ? 3.2451855365842673e+32 : s_d;
  const double y_0 = KSL_MUL(p_0, s), y_1 = KSL_MUL(p_1, s), y_2 = KSL_MUL(p_2, s);
  const double up = 1.0 < s ? s : 1.0;
  const double down = s < 1.0 ? s : 1.0;
  const double n = sqrt(KSL_MUL(y_0, y_0) + KSL_MUL(y_1, y_1) + KSL_MUL(y_2, y_2));
  const double divisor = n == 0.0 ? up : n;
  const double size_0 = fabs((double)si->m0), size_1 = fabs((double)si->m1),
      size_2 = fabs((double)si->m2);
  const double before_0 = size_0 < 256.0 ? up : down, before_1 = size_1 < 256.0 ? up : down,
      before_2 = size_2 < 256.0 ? up : down, before_3 = small_g < 256.0 ? up : down,
      before_4 = small_d < 256.0 ? up : down, before_5 = small_a < 256.0 ? up : down;
  const double after_0 = size_0 < 256.0 ? down : up, after_1 = size_1 < 256.0 ? down : up,
      after_2 = size_2 < 256.0 ? down : up, after_3 = small_g < 256.0 ? down : up,
      after_4 = small_d < 256.0 ? down : up, after_5 = small_a < 256.0 ? down : up;
  const double sized_0 = KSL_MUL((double)si->m0, before_0),
      sized_1 = KSL_MUL((double)si->m1, before_1), sized_2 = KSL_MUL((double)si->m2, before_2),
      sized_3 = KSL_MUL((double)si->m3, before_3), sized_4 = KSL_MUL((double)si->m4, before_4),
      sized_5 = KSL_MUL((double)si->m5, before_5);
  const double quotient_0 = sized_0 / divisor, quotient_1 = sized_1 / divisor,
      quotient_2 = sized_2 / divisor, quotient_3 = sized_3 / divisor,
      quotient_4 = sized_4 / divisor, quotient_5 = sized_5 / divisor;
  const double so_0 = KSL_MUL(quotient_0, after_0), so_1 = KSL_MUL(quotient_1, after_1),
      so_2 = KSL_MUL(quotient_2, after_2), so_3 = KSL_MUL(quotient_3, after_3),
      so_4 = KSL_MUL(quotient_4, after_4), so_5 = KSL_MUL(quotient_5, after_5);
  so->m0 = (float)so_0;
  so->m1 = (float)so_1;
  so->m2 = (float)so_2;
  so->m3 = (float)so_3;
  so->m4 = (float)so_4;
  so->m5 = (float)so_5;
}

/* so = (s1.lin + s2.lin ; s1.ang).
   s1, s2, so: screw (v in m/s; ω in rad/s).
   3 add.
   Error <= u |result| + (lin: 1/32, ang: 0) u^2 S, S the sum of the |terms| of the expanded
     formula; barring over- and underflow. */
static inline void ksl_add_sstf_accurate(const ksl_screwf_t *s1, const ksl_screwf_t *s2,
    ksl_screwf_t *so) {
  const double so_0 = (double)s1->m0 + (double)s2->m0, so_1 = (double)s1->m1 + (double)s2->m1,
      so_2 = (double)s1->m2 + (double)s2->m2;
  const float s1_m3 = s1->m3;
  const float s1_m4 = s1->m4;
  const float s1_m5 = s1->m5;
  so->m0 = (float)so_0;
  so->m1 = (float)so_1;
  so->m2 = (float)so_2;
  so->m3 = s1_m3;
  so->m4 = s1_m4;
  so->m5 = s1_m5;
}

/* so = [Ad](t) si.
   t: vector; si, so: screw (v in m/s; ω in rad/s).
   6 mul, 6 add.
   Error <= u |result| + (lin: 3/32, ang: 0) u^2 S, S the sum of the |terms| of the expanded
     formula; barring over- and underflow. */
static inline void ksl_product_Adtsf_accurate(const ksl_vec3f_t *t, const ksl_screwf_t *si,
    ksl_screwf_t *so) {
  const double so_0 = ksl_product_sum(-(double)t->z, (double)si->m4, (double)t->y * (double)si->m5)
          + (double)si->m0,
      so_1 = ksl_product_sum(-(double)t->x, (double)si->m5, (double)t->z * (double)si->m3)
          + (double)si->m1,
      so_2 = ksl_product_sum(-(double)t->y, (double)si->m3, (double)t->x * (double)si->m4)
          + (double)si->m2;
  const float si_m3 = si->m3;
  const float si_m4 = si->m4;
  const float si_m5 = si->m5;
  so->m0 = (float)so_0;
  so->m1 = (float)so_1;
  so->m2 = (float)so_2;
  so->m3 = si_m3;
  so->m4 = si_m4;
  so->m5 = si_m5;
}

/* so = [Ad](t)^-1 si.
   t: vector; si, so: screw (v in m/s; ω in rad/s).
   6 mul, 6 add.
   Error <= u |result| + (lin: 3/32, ang: 0) u^2 S, S the sum of the |terms| of the expanded
     formula; barring over- and underflow. */
static inline void ksl_product_Adtinvsf_accurate(const ksl_vec3f_t *t, const ksl_screwf_t *si,
    ksl_screwf_t *so) {
  const double so_0 = ksl_product_sum(-(double)t->y, (double)si->m5, (double)t->z * (double)si->m4)
          + (double)si->m0,
      so_1 = ksl_product_sum(-(double)t->z, (double)si->m3, (double)t->x * (double)si->m5)
          + (double)si->m1,
      so_2 = ksl_product_sum(-(double)t->x, (double)si->m4, (double)t->y * (double)si->m3)
          + (double)si->m2;
  const float si_m3 = si->m3;
  const float si_m4 = si->m4;
  const float si_m5 = si->m5;
  so->m0 = (float)so_0;
  so->m1 = (float)so_1;
  so->m2 = (float)so_2;
  so->m3 = si_m3;
  so->m4 = si_m4;
  so->m5 = si_m5;
}

/* so = [Ad](t) (-si).
   t: vector; si, so: screw (v in m/s; ω in rad/s).
   6 mul, 6 add, 3 neg.
   Error <= u |result| + (lin: 3/32, ang: 0) u^2 S, S the sum of the |terms| of the expanded
     formula; barring over- and underflow. */
static inline void ksl_product_Adtsinvf_accurate(const ksl_vec3f_t *t, const ksl_screwf_t *si,
    ksl_screwf_t *so) {
  const double so_0 = ksl_product_sum(-(double)t->y, (double)si->m5, (double)t->z * (double)si->m4)
          - (double)si->m0,
      so_1 = ksl_product_sum(-(double)t->z, (double)si->m3, (double)t->x * (double)si->m5)
          - (double)si->m1,
      so_2 = ksl_product_sum(-(double)t->x, (double)si->m4, (double)t->y * (double)si->m3)
          - (double)si->m2, so_3 = -(double)si->m3, so_4 = -(double)si->m4, so_5 = -(double)si->m5;
  so->m0 = (float)so_0;
  so->m1 = (float)so_1;
  so->m2 = (float)so_2;
  so->m3 = (float)so_3;
  so->m4 = (float)so_4;
  so->m5 = (float)so_5;
}

/* so = [Ad](R) si.
   R: rotation or other 3×3 matrix; si, so: screw (v in m/s; ω in rad/s).
   18 mul, 12 add.
   Error <= u |result| + 3/32 u^2 S, S the sum of the |terms| of the expanded formula; barring
     over- and underflow. */
static inline void ksl_product_Adrsf_accurate(const ksl_mat3x3f_t *R, const ksl_screwf_t *si,
    ksl_screwf_t *so) {
  const double so_0 = ksl_product_sum((double)R->m02, (double)si->m2,
      ksl_product_sum((double)R->m01, (double)si->m1, (double)R->m00 * (double)si->m0)),
      so_1 = ksl_product_sum((double)R->m12, (double)si->m2, ksl_product_sum((double)R->m11,
          (double)si->m1, (double)R->m10 * (double)si->m0)),
      so_2 = ksl_product_sum((double)R->m22, (double)si->m2, ksl_product_sum((double)R->m21,
          (double)si->m1, (double)R->m20 * (double)si->m0)),
      so_3 = ksl_product_sum((double)R->m02, (double)si->m5, ksl_product_sum((double)R->m01,
          (double)si->m4, (double)R->m00 * (double)si->m3)),
      so_4 = ksl_product_sum((double)R->m12, (double)si->m5, ksl_product_sum((double)R->m11,
          (double)si->m4, (double)R->m10 * (double)si->m3)),
      so_5 = ksl_product_sum((double)R->m22, (double)si->m5, ksl_product_sum((double)R->m21,
          (double)si->m4, (double)R->m20 * (double)si->m3));
  so->m0 = (float)so_0;
  so->m1 = (float)so_1;
  so->m2 = (float)so_2;
  so->m3 = (float)so_3;
  so->m4 = (float)so_4;
  so->m5 = (float)so_5;
}

/* so = [Ad](R)^-1 si.
   R: rotation or other 3×3 matrix; si, so: screw (v in m/s; ω in rad/s).
   18 mul, 12 add.
   Error <= u |result| + 3/32 u^2 S, S the sum of the |terms| of the expanded formula; barring
     over- and underflow. */
static inline void ksl_product_Adrinvsf_accurate(const ksl_mat3x3f_t *R, const ksl_screwf_t *si,
    ksl_screwf_t *so) {
  const double so_0 = ksl_product_sum((double)R->m20, (double)si->m2,
      ksl_product_sum((double)R->m10, (double)si->m1, (double)R->m00 * (double)si->m0)),
      so_1 = ksl_product_sum((double)R->m21, (double)si->m2, ksl_product_sum((double)R->m11,
          (double)si->m1, (double)R->m01 * (double)si->m0)),
      so_2 = ksl_product_sum((double)R->m22, (double)si->m2, ksl_product_sum((double)R->m12,
          (double)si->m1, (double)R->m02 * (double)si->m0)),
      so_3 = ksl_product_sum((double)R->m20, (double)si->m5, ksl_product_sum((double)R->m10,
          (double)si->m4, (double)R->m00 * (double)si->m3)),
      so_4 = ksl_product_sum((double)R->m21, (double)si->m5, ksl_product_sum((double)R->m11,
          (double)si->m4, (double)R->m01 * (double)si->m3)),
      so_5 = ksl_product_sum((double)R->m22, (double)si->m5, ksl_product_sum((double)R->m12,
          (double)si->m4, (double)R->m02 * (double)si->m3));
  so->m0 = (float)so_0;
  so->m1 = (float)so_1;
  so->m2 = (float)so_2;
  so->m3 = (float)so_3;
  so->m4 = (float)so_4;
  so->m5 = (float)so_5;
}

/* so = [Ad](R) (-si).
   R: rotation or other 3×3 matrix; si, so: screw (v in m/s; ω in rad/s).
   18 mul, 12 add, 6 neg.
   Error <= u |result| + 3/32 u^2 S, S the sum of the |terms| of the expanded formula; barring
     over- and underflow. */
static inline void ksl_product_Adrsinvf_accurate(const ksl_mat3x3f_t *R, const ksl_screwf_t *si,
    ksl_screwf_t *so) {
  const double so_0 = ksl_product_sum(-(double)R->m02, (double)si->m2,
      ksl_product_sum(-(double)R->m01, (double)si->m1, -((double)R->m00 * (double)si->m0))),
      so_1 = ksl_product_sum(-(double)R->m12, (double)si->m2, ksl_product_sum(-(double)R->m11,
          (double)si->m1, -((double)R->m10 * (double)si->m0))),
      so_2 = ksl_product_sum(-(double)R->m22, (double)si->m2, ksl_product_sum(-(double)R->m21,
          (double)si->m1, -((double)R->m20 * (double)si->m0))),
      so_3 = ksl_product_sum(-(double)R->m02, (double)si->m5, ksl_product_sum(-(double)R->m01,
          (double)si->m4, -((double)R->m00 * (double)si->m3))),
      so_4 = ksl_product_sum(-(double)R->m12, (double)si->m5, ksl_product_sum(-(double)R->m11,
          (double)si->m4, -((double)R->m10 * (double)si->m3))),
      so_5 = ksl_product_sum(-(double)R->m22, (double)si->m5, ksl_product_sum(-(double)R->m21,
          (double)si->m4, -((double)R->m20 * (double)si->m3)));
  so->m0 = (float)so_0;
  so->m1 = (float)so_1;
  so->m2 = (float)so_2;
  so->m3 = (float)so_3;
  so->m4 = (float)so_4;
  so->m5 = (float)so_5;
}

/* so = [Ad](D) si = [Ad](t) [Ad](R) si.
   D: displacement [R | t], R rotation, t in m; si, so: screw (v in m/s; ω in rad/s).
   24 mul, 18 add.
   Error <= u |result| + (lin: 3/16, ang: 3/32) u^2 S, S the sum of the |terms| of the expanded
     formula; barring over- and underflow. */
static inline void ksl_product_Adsf_accurate(const ksl_SE3f_t *D, const ksl_screwf_t *si,
    ksl_screwf_t *so) {
  const double w_0 = ksl_product_sum((double)D->m02, (double)si->m2, ksl_product_sum((double)D->m01,
      (double)si->m1, (double)D->m00 * (double)si->m0)),
      w_1 = ksl_product_sum((double)D->m12, (double)si->m2, ksl_product_sum((double)D->m11,
          (double)si->m1, (double)D->m10 * (double)si->m0)),
      w_2 = ksl_product_sum((double)D->m22, (double)si->m2, ksl_product_sum((double)D->m21,
          (double)si->m1, (double)D->m20 * (double)si->m0)),
      w_3 = ksl_product_sum((double)D->m02, (double)si->m5, ksl_product_sum((double)D->m01,
          (double)si->m4, (double)D->m00 * (double)si->m3)),
      w_4 = ksl_product_sum((double)D->m12, (double)si->m5, ksl_product_sum((double)D->m11,
          (double)si->m4, (double)D->m10 * (double)si->m3)),
      w_5 = ksl_product_sum((double)D->m22, (double)si->m5, ksl_product_sum((double)D->m21,
          (double)si->m4, (double)D->m20 * (double)si->m3));
  const double so_0 = KSL_MUL((double)D->m13, w_5) - KSL_MUL((double)D->m23, w_4) + w_0,
      so_1 = KSL_MUL((double)D->m23, w_3) - KSL_MUL((double)D->m03, w_5) + w_1,
      so_2 = KSL_MUL((double)D->m03, w_4) - KSL_MUL((double)D->m13, w_3) + w_2;
  so->m0 = (float)so_0;
  so->m1 = (float)so_1;
  so->m2 = (float)so_2;
  so->m3 = (float)w_3;
  so->m4 = (float)w_4;
  so->m5 = (float)w_5;
}

/* so = [Ad](D)^-1 si = [Ad](R^T) [Ad](-t) si.
   D: displacement [R | t], R rotation, t in m; si, so: screw (v in m/s; ω in rad/s).
   24 mul, 18 add.
   Error <= u |result| + (lin: 3/16, ang: 3/32) u^2 S, S the sum of the |terms| of the expanded
     formula; barring over- and underflow. */
static inline void ksl_product_Adinvsf_accurate(const ksl_SE3f_t *D, const ksl_screwf_t *si,
    ksl_screwf_t *so) {
  const double w_0 = ksl_product_sum(-(double)D->m13, (double)si->m5, (double)D->m23
          * (double)si->m4) + (double)si->m0,
      w_1 = ksl_product_sum(-(double)D->m23, (double)si->m3, (double)D->m03 * (double)si->m5)
          + (double)si->m1,
      w_2 = ksl_product_sum(-(double)D->m03, (double)si->m4, (double)D->m13 * (double)si->m3)
          + (double)si->m2;
  const double so_0 = KSL_MUL((double)D->m00, w_0) + KSL_MUL((double)D->m10, w_1)
          + KSL_MUL((double)D->m20, w_2),
      so_1 = KSL_MUL((double)D->m01, w_0) + KSL_MUL((double)D->m11, w_1)
          + KSL_MUL((double)D->m21, w_2),
      so_2 = KSL_MUL((double)D->m02, w_0) + KSL_MUL((double)D->m12, w_1)
          + KSL_MUL((double)D->m22, w_2),
      so_3 = ksl_product_sum((double)D->m20, (double)si->m5, ksl_product_sum((double)D->m10,
          (double)si->m4, (double)D->m00 * (double)si->m3)),
      so_4 = ksl_product_sum((double)D->m21, (double)si->m5, ksl_product_sum((double)D->m11,
          (double)si->m4, (double)D->m01 * (double)si->m3)),
      so_5 = ksl_product_sum((double)D->m22, (double)si->m5, ksl_product_sum((double)D->m12,
          (double)si->m4, (double)D->m02 * (double)si->m3));
  so->m0 = (float)so_0;
  so->m1 = (float)so_1;
  so->m2 = (float)so_2;
  so->m3 = (float)so_3;
  so->m4 = (float)so_4;
  so->m5 = (float)so_5;
}

/* so = [Ad](D) (-si).
   D: displacement [R | t], R rotation, t in m; si, so: screw (v in m/s; ω in rad/s).
   24 mul, 18 add, 6 neg.
   Error <= u |result| + (lin: 3/16, ang: 3/32) u^2 S, S the sum of the |terms| of the expanded
     formula; barring over- and underflow. */
static inline void ksl_product_Adsinvf_accurate(const ksl_SE3f_t *D, const ksl_screwf_t *si,
    ksl_screwf_t *so) {
  const double w_0 = ksl_product_sum(-(double)D->m02, (double)si->m2,
      ksl_product_sum(-(double)D->m01, (double)si->m1, -((double)D->m00 * (double)si->m0))),
      w_1 = ksl_product_sum(-(double)D->m12, (double)si->m2, ksl_product_sum(-(double)D->m11,
          (double)si->m1, -((double)D->m10 * (double)si->m0))),
      w_2 = ksl_product_sum(-(double)D->m22, (double)si->m2, ksl_product_sum(-(double)D->m21,
          (double)si->m1, -((double)D->m20 * (double)si->m0))),
      w_3 = ksl_product_sum(-(double)D->m02, (double)si->m5, ksl_product_sum(-(double)D->m01,
          (double)si->m4, -((double)D->m00 * (double)si->m3))),
      w_4 = ksl_product_sum(-(double)D->m12, (double)si->m5, ksl_product_sum(-(double)D->m11,
          (double)si->m4, -((double)D->m10 * (double)si->m3))),
      w_5 = ksl_product_sum(-(double)D->m22, (double)si->m5, ksl_product_sum(-(double)D->m21,
          (double)si->m4, -((double)D->m20 * (double)si->m3)));
  const double so_0 = KSL_MUL((double)D->m13, w_5) - KSL_MUL((double)D->m23, w_4) + w_0,
      so_1 = KSL_MUL((double)D->m23, w_3) - KSL_MUL((double)D->m03, w_5) + w_1,
      so_2 = KSL_MUL((double)D->m03, w_4) - KSL_MUL((double)D->m13, w_3) + w_2;
  so->m0 = (float)so_0;
  so->m1 = (float)so_1;
  so->m2 = (float)so_2;
  so->m3 = (float)w_3;
  so->m4 = (float)w_4;
  so->m5 = (float)w_5;
}

/* so = h_rx: column 3 of [Ad](D).
   D: displacement [R | t], R rotation, t in m; so: screw (v in m/s; ω in rad/s).
   6 mul, 3 add.
   Error <= u |result| + (lin: 1/16, ang: 0) u^2 S, S the sum of the |terms| of the expanded
     formula; barring over- and underflow. */
static inline void ksl_hsrxf_accurate(const ksl_SE3f_t *D, ksl_screwf_t *so) {
  const double so_0 = ksl_product_sum(-(double)D->m10, (double)D->m23, (double)D->m20
          * (double)D->m13),
      so_1 = ksl_product_sum(-(double)D->m20, (double)D->m03, (double)D->m00 * (double)D->m23),
      so_2 = ksl_product_sum(-(double)D->m00, (double)D->m13, (double)D->m10 * (double)D->m03);
  const float D_m00 = D->m00;
  const float D_m10 = D->m10;
  const float D_m20 = D->m20;
  so->m0 = (float)so_0;
  so->m1 = (float)so_1;
  so->m2 = (float)so_2;
  so->m3 = D_m00;
  so->m4 = D_m10;
  so->m5 = D_m20;
}

/* so = h_ry: column 4 of [Ad](D).
   D: displacement [R | t], R rotation, t in m; so: screw (v in m/s; ω in rad/s).
   6 mul, 3 add.
   Error <= u |result| + (lin: 1/16, ang: 0) u^2 S, S the sum of the |terms| of the expanded
     formula; barring over- and underflow. */
static inline void ksl_hsryf_accurate(const ksl_SE3f_t *D, ksl_screwf_t *so) {
  const double so_0 = ksl_product_sum(-(double)D->m11, (double)D->m23, (double)D->m21
          * (double)D->m13),
      so_1 = ksl_product_sum(-(double)D->m21, (double)D->m03, (double)D->m01 * (double)D->m23),
      so_2 = ksl_product_sum(-(double)D->m01, (double)D->m13, (double)D->m11 * (double)D->m03);
  const float D_m01 = D->m01;
  const float D_m11 = D->m11;
  const float D_m21 = D->m21;
  so->m0 = (float)so_0;
  so->m1 = (float)so_1;
  so->m2 = (float)so_2;
  so->m3 = D_m01;
  so->m4 = D_m11;
  so->m5 = D_m21;
}

/* so = h_rz: column 5 of [Ad](D).
   D: displacement [R | t], R rotation, t in m; so: screw (v in m/s; ω in rad/s).
   6 mul, 3 add.
   Error <= u |result| + (lin: 1/16, ang: 0) u^2 S, S the sum of the |terms| of the expanded
     formula; barring over- and underflow. */
static inline void ksl_hsrzf_accurate(const ksl_SE3f_t *D, ksl_screwf_t *so) {
  const double so_0 = ksl_product_sum(-(double)D->m12, (double)D->m23, (double)D->m22
          * (double)D->m13),
      so_1 = ksl_product_sum(-(double)D->m22, (double)D->m03, (double)D->m02 * (double)D->m23),
      so_2 = ksl_product_sum(-(double)D->m02, (double)D->m13, (double)D->m12 * (double)D->m03);
  const float D_m02 = D->m02;
  const float D_m12 = D->m12;
  const float D_m22 = D->m22;
  so->m0 = (float)so_0;
  so->m1 = (float)so_1;
  so->m2 = (float)so_2;
  so->m3 = D_m02;
  so->m4 = D_m12;
  so->m5 = D_m22;
}

/* so = -h_rx: -column 3 of [Ad](D).
   D: displacement [R | t], R rotation, t in m; so: screw (v in m/s; ω in rad/s).
   6 mul, 3 add, 3 neg.
   Error <= u |result| + (lin: 1/16, ang: 0) u^2 S, S the sum of the |terms| of the expanded
     formula; barring over- and underflow. */
static inline void ksl_hsrxinvf_accurate(const ksl_SE3f_t *D, ksl_screwf_t *so) {
  const double so_0 = ksl_product_sum(-(double)D->m20, (double)D->m13, (double)D->m10
          * (double)D->m23),
      so_1 = ksl_product_sum(-(double)D->m00, (double)D->m23, (double)D->m20 * (double)D->m03),
      so_2 = ksl_product_sum(-(double)D->m10, (double)D->m03, (double)D->m00 * (double)D->m13),
      so_3 = -(double)D->m00, so_4 = -(double)D->m10, so_5 = -(double)D->m20;
  so->m0 = (float)so_0;
  so->m1 = (float)so_1;
  so->m2 = (float)so_2;
  so->m3 = (float)so_3;
  so->m4 = (float)so_4;
  so->m5 = (float)so_5;
}

/* so = -h_ry: -column 4 of [Ad](D).
   D: displacement [R | t], R rotation, t in m; so: screw (v in m/s; ω in rad/s).
   6 mul, 3 add, 3 neg.
   Error <= u |result| + (lin: 1/16, ang: 0) u^2 S, S the sum of the |terms| of the expanded
     formula; barring over- and underflow. */
static inline void ksl_hsryinvf_accurate(const ksl_SE3f_t *D, ksl_screwf_t *so) {
  const double so_0 = ksl_product_sum(-(double)D->m21, (double)D->m13, (double)D->m11
          * (double)D->m23),
      so_1 = ksl_product_sum(-(double)D->m01, (double)D->m23, (double)D->m21 * (double)D->m03),
      so_2 = ksl_product_sum(-(double)D->m11, (double)D->m03, (double)D->m01 * (double)D->m13),
      so_3 = -(double)D->m01, so_4 = -(double)D->m11, so_5 = -(double)D->m21;
  so->m0 = (float)so_0;
  so->m1 = (float)so_1;
  so->m2 = (float)so_2;
  so->m3 = (float)so_3;
  so->m4 = (float)so_4;
  so->m5 = (float)so_5;
}

/* so = -h_rz: -column 5 of [Ad](D).
   D: displacement [R | t], R rotation, t in m; so: screw (v in m/s; ω in rad/s).
   6 mul, 3 add, 3 neg.
   Error <= u |result| + (lin: 1/16, ang: 0) u^2 S, S the sum of the |terms| of the expanded
     formula; barring over- and underflow. */
static inline void ksl_hsrzinvf_accurate(const ksl_SE3f_t *D, ksl_screwf_t *so) {
  const double so_0 = ksl_product_sum(-(double)D->m22, (double)D->m13, (double)D->m12
          * (double)D->m23),
      so_1 = ksl_product_sum(-(double)D->m02, (double)D->m23, (double)D->m22 * (double)D->m03),
      so_2 = ksl_product_sum(-(double)D->m12, (double)D->m03, (double)D->m02 * (double)D->m13),
      so_3 = -(double)D->m02, so_4 = -(double)D->m12, so_5 = -(double)D->m22;
  so->m0 = (float)so_0;
  so->m1 = (float)so_1;
  so->m2 = (float)so_2;
  so->m3 = (float)so_3;
  so->m4 = (float)so_4;
  so->m5 = (float)so_5;
}

/* M = [Ad](D).
   D: displacement [R | t], R rotation, t in m; M: 6×6 operator.
   18 mul, 9 add.
   Error <= u |result| + 1/16 u^2 S, S the sum of the |terms| of the expanded formula; barring
     over- and underflow. */
static inline void ksl_Adf_accurate(const ksl_SE3f_t *D, ksl_mat6x6f_t *M) {
  const double M_03 = ksl_product_sum(-(double)D->m10, (double)D->m23, (double)D->m20
          * (double)D->m13),
      M_04 = ksl_product_sum(-(double)D->m11, (double)D->m23, (double)D->m21 * (double)D->m13),
      M_05 = ksl_product_sum(-(double)D->m12, (double)D->m23, (double)D->m22 * (double)D->m13),
      M_13 = ksl_product_sum(-(double)D->m20, (double)D->m03, (double)D->m00 * (double)D->m23),
      M_14 = ksl_product_sum(-(double)D->m21, (double)D->m03, (double)D->m01 * (double)D->m23),
      M_15 = ksl_product_sum(-(double)D->m22, (double)D->m03, (double)D->m02 * (double)D->m23),
      M_23 = ksl_product_sum(-(double)D->m00, (double)D->m13, (double)D->m10 * (double)D->m03),
      M_24 = ksl_product_sum(-(double)D->m01, (double)D->m13, (double)D->m11 * (double)D->m03),
      M_25 = ksl_product_sum(-(double)D->m02, (double)D->m13, (double)D->m12 * (double)D->m03);
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
  M->at[3][0] = (float)M_03;
  M->at[4][0] = (float)M_04;
  M->at[5][0] = (float)M_05;
  M->at[0][1] = D_m10;
  M->at[1][1] = D_m11;
  M->at[2][1] = D_m12;
  M->at[3][1] = (float)M_13;
  M->at[4][1] = (float)M_14;
  M->at[5][1] = (float)M_15;
  M->at[0][2] = D_m20;
  M->at[1][2] = D_m21;
  M->at[2][2] = D_m22;
  M->at[3][2] = (float)M_23;
  M->at[4][2] = (float)M_24;
  M->at[5][2] = (float)M_25;
  M->at[0][3] = (float)0.0;
  M->at[1][3] = (float)0.0;
  M->at[2][3] = (float)0.0;
  M->at[3][3] = D_m00;
  M->at[4][3] = D_m01;
  M->at[5][3] = D_m02;
  M->at[0][4] = (float)0.0;
  M->at[1][4] = (float)0.0;
  M->at[2][4] = (float)0.0;
  M->at[3][4] = D_m10;
  M->at[4][4] = D_m11;
  M->at[5][4] = D_m12;
  M->at[0][5] = (float)0.0;
  M->at[1][5] = (float)0.0;
  M->at[2][5] = (float)0.0;
  M->at[3][5] = D_m20;
  M->at[4][5] = D_m21;
  M->at[5][5] = D_m22;
}

/* power = f·v + τ·ω, in W.
   c: coscrew (f in N; τ in N m); s: screw (v in m/s; ω in rad/s).
   6 mul, 5 add.
   Error <= u |result| + 1/8 u^2 S, S the sum of the |terms| of the expanded formula; barring
     over- and underflow. */
static inline float ksl_dot_csf_accurate(const ksl_coscrewf_t *c, const ksl_screwf_t *s) {
  const double power_e = ksl_product_sum((double)c->m2, (double)s->m2,
      ksl_product_sum((double)c->m1, (double)s->m1, (double)c->m0 * (double)s->m0)),
      power = power_e
          + ksl_product_sum((double)c->m5, (double)s->m5, ksl_product_sum((double)c->m4,
              (double)s->m4, (double)c->m3 * (double)s->m3));
  return (float)power;
}

/* so = [ad](s1) s2 = (ω1×v2 + v1×ω2 ; ω1×ω2).  Exactly zero for s1 = s2, unless products
     overflow.
   s1, s2, so: screw (v in m/s; ω in rad/s).
   18 mul, 12 add.
   Error <= u |result| + (lin: 3/32, ang: 1/16) u^2 S, S the sum of the |terms| of the expanded
     formula; barring over- and underflow. */
static inline void ksl_cross_ssf_accurate(const ksl_screwf_t *s1, const ksl_screwf_t *s2,
    ksl_screwf_t *so) {
  const double so_0c = ksl_product_sum(-(double)s1->m5, (double)s2->m1, (double)s1->m1
          * (double)s2->m5),
      so_0 = so_0c
          + ksl_product_sum(-(double)s1->m2, (double)s2->m4, (double)s1->m4 * (double)s2->m2);
  const double so_1c = ksl_product_sum(-(double)s1->m0, (double)s2->m5, (double)s1->m5
          * (double)s2->m0),
      so_1 = so_1c
          + ksl_product_sum(-(double)s1->m3, (double)s2->m2, (double)s1->m2 * (double)s2->m3);
  const double so_2c = ksl_product_sum(-(double)s1->m4, (double)s2->m0, (double)s1->m0
          * (double)s2->m4),
      so_2 = so_2c
          + ksl_product_sum(-(double)s1->m1, (double)s2->m3, (double)s1->m3 * (double)s2->m1);
  const double so_3 = ksl_product_sum(-(double)s1->m5, (double)s2->m4, (double)s1->m4
          * (double)s2->m5),
      so_4 = ksl_product_sum(-(double)s1->m3, (double)s2->m5, (double)s1->m5 * (double)s2->m3),
      so_5 = ksl_product_sum(-(double)s1->m4, (double)s2->m3, (double)s1->m3 * (double)s2->m4);
  so->m0 = (float)so_0;
  so->m1 = (float)so_1;
  so->m2 = (float)so_2;
  so->m3 = (float)so_3;
  so->m4 = (float)so_4;
  so->m5 = (float)so_5;
}

/* so = (ω1×v2 ; 0).
   s1, s2, so: screw (v in m/s; ω in rad/s).
   6 mul, 3 add.
   Error <= u |result| + (lin: 1/16, ang: 0) u^2 S, S the sum of the |terms| of the expanded
     formula; barring over- and underflow. */
static inline void ksl_cross_sstf_accurate(const ksl_screwf_t *s1, const ksl_screwf_t *s2,
    ksl_screwf_t *so) {
  const double so_0 = ksl_product_sum(-(double)s1->m5, (double)s2->m1, (double)s1->m4
          * (double)s2->m2),
      so_1 = ksl_product_sum(-(double)s1->m3, (double)s2->m2, (double)s1->m5 * (double)s2->m0),
      so_2 = ksl_product_sum(-(double)s1->m4, (double)s2->m0, (double)s1->m3 * (double)s2->m1);
  so->m0 = (float)so_0;
  so->m1 = (float)so_1;
  so->m2 = (float)so_2;
  so->m3 = (float)0.0;
  so->m4 = (float)0.0;
  so->m5 = (float)0.0;
}

/* so = (t×R a ; R a), a = axis in the body's frame.
   D: displacement [R | t], R rotation, t in m; axis: vector; so: screw (v in m/s; ω in rad/s).
   15 mul, 9 add.
   Error <= u |result| + (lin: 5/32, ang: 3/32) u^2 S, S the sum of the |terms| of the expanded
     formula; barring over- and underflow. */
static inline void ksl_hsraf_accurate(const ksl_SE3f_t *D, const ksl_vec3f_t *axis,
    ksl_screwf_t *so) {
  const double a_0 = ksl_product_sum((double)D->m02, (double)axis->z,
      ksl_product_sum((double)D->m01, (double)axis->y, (double)D->m00 * (double)axis->x)),
      a_1 = ksl_product_sum((double)D->m12, (double)axis->z, ksl_product_sum((double)D->m11,
          (double)axis->y, (double)D->m10 * (double)axis->x)),
      a_2 = ksl_product_sum((double)D->m22, (double)axis->z, ksl_product_sum((double)D->m21,
          (double)axis->y, (double)D->m20 * (double)axis->x));
  const double so_0 = KSL_MUL((double)D->m13, a_2) - KSL_MUL((double)D->m23, a_1),
      so_1 = KSL_MUL((double)D->m23, a_0) - KSL_MUL((double)D->m03, a_2),
      so_2 = KSL_MUL((double)D->m03, a_1) - KSL_MUL((double)D->m13, a_0);
  so->m0 = (float)so_0;
  so->m1 = (float)so_1;
  so->m2 = (float)so_2;
  so->m3 = (float)a_0;
  so->m4 = (float)a_1;
  so->m5 = (float)a_2;
}

/* so = (R a ; 0), a = axis in the body's frame.
   D: displacement [R | t], R rotation, t in m; axis: vector; so: screw (v in m/s; ω in rad/s).
   9 mul, 6 add.
   Error <= u |result| + (lin: 3/32, ang: 0) u^2 S, S the sum of the |terms| of the expanded
     formula; barring over- and underflow. */
static inline void ksl_hstaf_accurate(const ksl_SE3f_t *D, const ksl_vec3f_t *axis,
    ksl_screwf_t *so) {
  const double so_0 = ksl_product_sum((double)D->m02, (double)axis->z,
      ksl_product_sum((double)D->m01, (double)axis->y, (double)D->m00 * (double)axis->x)),
      so_1 = ksl_product_sum((double)D->m12, (double)axis->z, ksl_product_sum((double)D->m11,
          (double)axis->y, (double)D->m10 * (double)axis->x)),
      so_2 = ksl_product_sum((double)D->m22, (double)axis->z, ksl_product_sum((double)D->m21,
          (double)axis->y, (double)D->m20 * (double)axis->x));
  so->m0 = (float)so_0;
  so->m1 = (float)so_1;
  so->m2 = (float)so_2;
  so->m3 = (float)0.0;
  so->m4 = (float)0.0;
  so->m5 = (float)0.0;
}

/* so = -(t×R a ; R a), a = axis in the body's frame.
   D: displacement [R | t], R rotation, t in m; axis: vector; so: screw (v in m/s; ω in rad/s).
   15 mul, 9 add, 3 neg.
   Error <= u |result| + (lin: 5/32, ang: 3/32) u^2 S, S the sum of the |terms| of the expanded
     formula; barring over- and underflow. */
static inline void ksl_hsrainvf_accurate(const ksl_SE3f_t *D, const ksl_vec3f_t *axis,
    ksl_screwf_t *so) {
  const double a_0 = ksl_product_sum(-(double)D->m02, (double)axis->z,
      ksl_product_sum(-(double)D->m01, (double)axis->y, -((double)D->m00 * (double)axis->x))),
      a_1 = ksl_product_sum(-(double)D->m12, (double)axis->z, ksl_product_sum(-(double)D->m11,
          (double)axis->y, -((double)D->m10 * (double)axis->x))),
      a_2 = ksl_product_sum(-(double)D->m22, (double)axis->z, ksl_product_sum(-(double)D->m21,
          (double)axis->y, -((double)D->m20 * (double)axis->x)));
  const double so_0 = KSL_MUL((double)D->m13, a_2) - KSL_MUL((double)D->m23, a_1),
      so_1 = KSL_MUL((double)D->m23, a_0) - KSL_MUL((double)D->m03, a_2),
      so_2 = KSL_MUL((double)D->m03, a_1) - KSL_MUL((double)D->m13, a_0);
  so->m0 = (float)so_0;
  so->m1 = (float)so_1;
  so->m2 = (float)so_2;
  so->m3 = (float)a_0;
  so->m4 = (float)a_1;
  so->m5 = (float)a_2;
}

/* so = -(R a ; 0), a = axis in the body's frame.
   D: displacement [R | t], R rotation, t in m; axis: vector; so: screw (v in m/s; ω in rad/s).
   9 mul, 6 add, 3 neg.
   Error <= u |result| + (lin: 3/32, ang: 0) u^2 S, S the sum of the |terms| of the expanded
     formula; barring over- and underflow. */
static inline void ksl_hstainvf_accurate(const ksl_SE3f_t *D, const ksl_vec3f_t *axis,
    ksl_screwf_t *so) {
  const double so_0 = ksl_product_sum(-(double)D->m02, (double)axis->z,
      ksl_product_sum(-(double)D->m01, (double)axis->y, -((double)D->m00 * (double)axis->x))),
      so_1 = ksl_product_sum(-(double)D->m12, (double)axis->z, ksl_product_sum(-(double)D->m11,
          (double)axis->y, -((double)D->m10 * (double)axis->x))),
      so_2 = ksl_product_sum(-(double)D->m22, (double)axis->z, ksl_product_sum(-(double)D->m21,
          (double)axis->y, -((double)D->m20 * (double)axis->x)));
  so->m0 = (float)so_0;
  so->m1 = (float)so_1;
  so->m2 = (float)so_2;
  so->m3 = (float)0.0;
  so->m4 = (float)0.0;
  so->m5 = (float)0.0;
}

#endif
