/* Made by `coscrew generate`; changes are overwritten. */
/* SPDX-License-Identifier: MIT */
/* coscrew 0.2.0.  Copyright (c) 2026 The coscrew authors. */
/* Coscrews: wrenches and momenta, c = (f; τ).
   Accurate tier: double compensated, single computed in double. */
#ifndef KSL_COSCREW_ACCURATE_H
#define KSL_COSCREW_ACCURATE_H

#include "ksl_exact.h"

/* self = a self.
   self: coscrew (f in N; τ in N m); a: number.
   6 mul, 6 add, 6 product error.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_coscrew_scale_accurate(ksl_coscrew_t *self, const double a) {
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
   a: number; x, y: coscrew (f in N; τ in N m).
   6 mul, 36 add, 6 product rest.
   Error <= u |result| + 3 u^2 S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_axpy_cc_accurate(const double a, const ksl_coscrew_t *x, ksl_coscrew_t *y) {
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
   x, y: coscrew (f in N; τ in N m).
   42 add.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_xpy_cc_accurate(const ksl_coscrew_t *x, ksl_coscrew_t *y) {
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
   x, y: coscrew (f in N; τ in N m).
   42 add.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_nxpy_cc_accurate(const ksl_coscrew_t *x, ksl_coscrew_t *y) {
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

/* co = a ci.
   a: number; ci, co: coscrew (f in N; τ in N m).
   6 mul, 6 add, 6 product error.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_product_ac_accurate(const double a, const ksl_coscrew_t *ci,
    ksl_coscrew_t *co) {
  const double co_0 = KSL_MUL(a, ci->m0), co_1 = KSL_MUL(a, ci->m1), co_2 = KSL_MUL(a, ci->m2),
      co_3 = KSL_MUL(a, ci->m3), co_4 = KSL_MUL(a, ci->m4), co_5 = KSL_MUL(a, ci->m5);
  const double co_0_rounded = co_0 + ksl_product_error(a, ci->m0, co_0),
      co_1_rounded = co_1 + ksl_product_error(a, ci->m1, co_1),
      co_2_rounded = co_2 + ksl_product_error(a, ci->m2, co_2),
      co_3_rounded = co_3 + ksl_product_error(a, ci->m3, co_3),
      co_4_rounded = co_4 + ksl_product_error(a, ci->m4, co_4),
      co_5_rounded = co_5 + ksl_product_error(a, ci->m5, co_5);
  co->m0 = co_0_rounded;
  co->m1 = co_1_rounded;
  co->m2 = co_2_rounded;
  co->m3 = co_3_rounded;
  co->m4 = co_4_rounded;
  co->m5 = co_5_rounded;
}

/* co = c1 + c2.
   c1, c2, co: coscrew (f in N; τ in N m).
   42 add.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_add_cc_accurate(const ksl_coscrew_t *c1, const ksl_coscrew_t *c2,
    ksl_coscrew_t *co) {
  const double co_0 = c1->m0 + c2->m0, co_0_right = co_0 - c1->m0;
  const double co_1 = c1->m1 + c2->m1, co_1_right = co_1 - c1->m1;
  const double co_2 = c1->m2 + c2->m2, co_2_right = co_2 - c1->m2;
  const double co_3 = c1->m3 + c2->m3, co_3_right = co_3 - c1->m3;
  const double co_4 = c1->m4 + c2->m4, co_4_right = co_4 - c1->m4;
  const double co_5 = c1->m5 + c2->m5, co_5_right = co_5 - c1->m5;
  const double co_0_rounded = co_0 + (c1->m0 - (co_0 - co_0_right) + (c2->m0 - co_0_right)),
      co_1_rounded = co_1 + (c1->m1 - (co_1 - co_1_right) + (c2->m1 - co_1_right)),
      co_2_rounded = co_2 + (c1->m2 - (co_2 - co_2_right) + (c2->m2 - co_2_right)),
      co_3_rounded = co_3 + (c1->m3 - (co_3 - co_3_right) + (c2->m3 - co_3_right)),
      co_4_rounded = co_4 + (c1->m4 - (co_4 - co_4_right) + (c2->m4 - co_4_right)),
      co_5_rounded = co_5 + (c1->m5 - (co_5 - co_5_right) + (c2->m5 - co_5_right));
  co->m0 = co_0_rounded;
  co->m1 = co_1_rounded;
  co->m2 = co_2_rounded;
  co->m3 = co_3_rounded;
  co->m4 = co_4_rounded;
  co->m5 = co_5_rounded;
}

/* co = c1 - c2.
   c1, c2, co: coscrew (f in N; τ in N m).
   42 add.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_subtract_cc_accurate(const ksl_coscrew_t *c1, const ksl_coscrew_t *c2,
    ksl_coscrew_t *co) {
  const double co_0 = c1->m0 - c2->m0, co_0_right = c1->m0 - co_0;
  const double co_1 = c1->m1 - c2->m1, co_1_right = c1->m1 - co_1;
  const double co_2 = c1->m2 - c2->m2, co_2_right = c1->m2 - co_2;
  const double co_3 = c1->m3 - c2->m3, co_3_right = c1->m3 - co_3;
  const double co_4 = c1->m4 - c2->m4, co_4_right = c1->m4 - co_4;
  const double co_5 = c1->m5 - c2->m5, co_5_right = c1->m5 - co_5;
  const double co_0_rounded = co_0 + (c1->m0 - (co_0 + co_0_right) - (c2->m0 - co_0_right)),
      co_1_rounded = co_1 + (c1->m1 - (co_1 + co_1_right) - (c2->m1 - co_1_right)),
      co_2_rounded = co_2 + (c1->m2 - (co_2 + co_2_right) - (c2->m2 - co_2_right)),
      co_3_rounded = co_3 + (c1->m3 - (co_3 + co_3_right) - (c2->m3 - co_3_right)),
      co_4_rounded = co_4 + (c1->m4 - (co_4 + co_4_right) - (c2->m4 - co_4_right)),
      co_5_rounded = co_5 + (c1->m5 - (co_5 + co_5_right) - (c2->m5 - co_5_right));
  co->m0 = co_0_rounded;
  co->m1 = co_1_rounded;
  co->m2 = co_2_rounded;
  co->m3 = co_3_rounded;
  co->m4 = co_4_rounded;
  co->m5 = co_5_rounded;
}

/* |ci|: |f|, or |τ| where every |f_i| is below 1e-9 (single: 1e-6).
   ci: coscrew (f in N; τ in N m).
   10 mul, 29 add, 1 product error, 3 product rest, 2 div, 1 sqrt, 6 abs, 11 less, 3 equal, 16
     select. */
static inline double ksl_coscrew_norm_accurate(const ksl_coscrew_t *ci) {
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

/* self = self / |self|, with coscrew_norm; the zero coscrew stays zero.
   self: coscrew (f in N; τ in N m).
   43 mul, 104 add, 7 product error, 3 product rest, 19 div, 1 sqrt, 9 abs, 16 less, 9 equal, 34
     select. */
static inline void ksl_coscrew_normalize_accurate(ksl_coscrew_t *self) {
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

/* co = ci / |ci|, with coscrew_norm; the zero coscrew stays zero.
   ci, co: coscrew (f in N; τ in N m).
   43 mul, 104 add, 7 product error, 3 product rest, 19 div, 1 sqrt, 9 abs, 16 less, 9 equal, 34
     select. */
static inline void ksl_coscrew_normalized_accurate(const ksl_coscrew_t *ci, ksl_coscrew_t *co) {
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
      quotient_0_sum_right = quotient_0_sum - quotient_0, co_0 = KSL_MUL(quotient_0_sum, after_0),
      quotient_0_sum_lo = quotient_0 - (quotient_0_sum - quotient_0_sum_right)
          + (quotient_0_lo - quotient_0_sum_right);
  const double quotient_1_sum = quotient_1 + quotient_1_lo,
      quotient_1_sum_right = quotient_1_sum - quotient_1, co_1 = KSL_MUL(quotient_1_sum, after_1),
      quotient_1_sum_lo = quotient_1 - (quotient_1_sum - quotient_1_sum_right)
          + (quotient_1_lo - quotient_1_sum_right);
  const double quotient_2_sum = quotient_2 + quotient_2_lo,
      quotient_2_sum_right = quotient_2_sum - quotient_2, co_2 = KSL_MUL(quotient_2_sum, after_2),
      quotient_2_sum_lo = quotient_2 - (quotient_2_sum - quotient_2_sum_right)
          + (quotient_2_lo - quotient_2_sum_right);
  const double quotient_3_sum = quotient_3 + quotient_3_lo,
      quotient_3_sum_right = quotient_3_sum - quotient_3, co_3 = KSL_MUL(quotient_3_sum, after_3),
      quotient_3_sum_lo = quotient_3 - (quotient_3_sum - quotient_3_sum_right)
          + (quotient_3_lo - quotient_3_sum_right);
  const double quotient_4_sum = quotient_4 + quotient_4_lo,
      quotient_4_sum_right = quotient_4_sum - quotient_4, co_4 = KSL_MUL(quotient_4_sum, after_4),
      quotient_4_sum_lo = quotient_4 - (quotient_4_sum - quotient_4_sum_right)
          + (quotient_4_lo - quotient_4_sum_right);
  const double quotient_5_sum = quotient_5 + quotient_5_lo,
      quotient_5_sum_right = quotient_5_sum - quotient_5, co_5 = KSL_MUL(quotient_5_sum, after_5),
      quotient_5_sum_lo = quotient_5 - (quotient_5_sum - quotient_5_sum_right)
          + (quotient_5_lo - quotient_5_sum_right);
  const double co_0_rounded = co_0
          + KSL_MUL(quotient_0_sum - KSL_MUL(co_0, 1.0 / after_0) + quotient_0_sum_lo, after_0);
  const double co_1_rounded = co_1
          + KSL_MUL(quotient_1_sum - KSL_MUL(co_1, 1.0 / after_1) + quotient_1_sum_lo, after_1);
  const double co_2_rounded = co_2
          + KSL_MUL(quotient_2_sum - KSL_MUL(co_2, 1.0 / after_2) + quotient_2_sum_lo, after_2);
  const double co_3_rounded = co_3
          + KSL_MUL(quotient_3_sum - KSL_MUL(co_3, 1.0 / after_3) + quotient_3_sum_lo, after_3);
  const double co_4_rounded = co_4
          + KSL_MUL(quotient_4_sum - KSL_MUL(co_4, 1.0 / after_4) + quotient_4_sum_lo, after_4);
  const double co_5_rounded = co_5
          + KSL_MUL(quotient_5_sum - KSL_MUL(co_5, 1.0 / after_5) + quotient_5_sum_lo, after_5);
  const double co_0_final = co_0_rounded == co_0_rounded ? co_0_rounded : co_0;
  const double co_1_final = co_1_rounded == co_1_rounded ? co_1_rounded : co_1;
  const double co_2_final = co_2_rounded == co_2_rounded ? co_2_rounded : co_2;
  const double co_3_final = co_3_rounded == co_3_rounded ? co_3_rounded : co_3;
  const double co_4_final = co_4_rounded == co_4_rounded ? co_4_rounded : co_4;
  const double co_5_final = co_5_rounded == co_5_rounded ? co_5_rounded : co_5;
  co->m0 = co_0_final;
  co->m1 = co_1_final;
  co->m2 = co_2_final;
  co->m3 = co_3_final;
  co->m4 = co_4_final;
  co->m5 = co_5_final;
}

/* co = (c1.lin + c2.lin ; c1.ang).
   c1, c2, co: coscrew (f in N; τ in N m).
   21 add.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_add_cct_accurate(const ksl_coscrew_t *c1, const ksl_coscrew_t *c2,
    ksl_coscrew_t *co) {
  const double co_0 = c1->m0 + c2->m0, co_0_right = co_0 - c1->m0;
  const double co_1 = c1->m1 + c2->m1, co_1_right = co_1 - c1->m1;
  const double co_2 = c1->m2 + c2->m2, co_2_right = co_2 - c1->m2;
  const double co_0_rounded = co_0 + (c1->m0 - (co_0 - co_0_right) + (c2->m0 - co_0_right)),
      co_1_rounded = co_1 + (c1->m1 - (co_1 - co_1_right) + (c2->m1 - co_1_right)),
      co_2_rounded = co_2 + (c1->m2 - (co_2 - co_2_right) + (c2->m2 - co_2_right));
  const double c1_m3 = c1->m3;
  const double c1_m4 = c1->m4;
  const double c1_m5 = c1->m5;
  co->m0 = co_0_rounded;
  co->m1 = co_1_rounded;
  co->m2 = co_2_rounded;
  co->m3 = c1_m3;
  co->m4 = c1_m4;
  co->m5 = c1_m5;
}

/* co = [Ad]*(t) ci.
   t: vector; ci, co: coscrew (f in N; τ in N m).
   6 mul, 36 add, 6 product rest.
   Error <= u |result| + (lin: 0, ang: 9) u^2 S, S the sum of the |terms| of the expanded
     formula; barring over- and underflow. */
static inline void ksl_product_CoAdtc_accurate(const ksl_vec3_t *t, const ksl_coscrew_t *ci,
    ksl_coscrew_t *co) {
  const double co_3a = KSL_MUL(t->y, ci->m2), co_3b = KSL_MUL(t->z, ci->m1), co_3c = co_3a - co_3b,
      co_3c_right = co_3a - co_3c, co_3 = co_3c + ci->m3, co_3_right = co_3 - co_3c,
      co_3c_lo = ksl_product_rest(t->y, ci->m2, co_3a, co_3c + co_3c_right)
          - ksl_product_rest(t->z, ci->m1, co_3b, co_3c_right);
  const double co_4a = KSL_MUL(t->z, ci->m0), co_4b = KSL_MUL(t->x, ci->m2), co_4c = co_4a - co_4b,
      co_4c_right = co_4a - co_4c, co_4 = co_4c + ci->m4, co_4_right = co_4 - co_4c,
      co_4c_lo = ksl_product_rest(t->z, ci->m0, co_4a, co_4c + co_4c_right)
          - ksl_product_rest(t->x, ci->m2, co_4b, co_4c_right);
  const double co_5a = KSL_MUL(t->x, ci->m1), co_5b = KSL_MUL(t->y, ci->m0), co_5c = co_5a - co_5b,
      co_5c_right = co_5a - co_5c, co_5 = co_5c + ci->m5, co_5_right = co_5 - co_5c,
      co_5c_lo = ksl_product_rest(t->x, ci->m1, co_5a, co_5c + co_5c_right)
          - ksl_product_rest(t->y, ci->m0, co_5b, co_5c_right);
  const double co_3_rounded = co_3
          + (co_3c - (co_3 - co_3_right) + (ci->m3 - co_3_right) + co_3c_lo),
      co_4_rounded = co_4 + (co_4c - (co_4 - co_4_right) + (ci->m4 - co_4_right) + co_4c_lo),
      co_5_rounded = co_5 + (co_5c - (co_5 - co_5_right) + (ci->m5 - co_5_right) + co_5c_lo);
  const double ci_m0 = ci->m0;
  const double ci_m1 = ci->m1;
  const double ci_m2 = ci->m2;
  co->m0 = ci_m0;
  co->m1 = ci_m1;
  co->m2 = ci_m2;
  co->m3 = co_3_rounded;
  co->m4 = co_4_rounded;
  co->m5 = co_5_rounded;
}

/* co = [Ad]*(t)^-1 ci.
   t: vector; ci, co: coscrew (f in N; τ in N m).
   6 mul, 36 add, 6 product rest.
   Error <= u |result| + (lin: 0, ang: 9) u^2 S, S the sum of the |terms| of the expanded
     formula; barring over- and underflow. */
static inline void ksl_product_CoAdtinvc_accurate(const ksl_vec3_t *t, const ksl_coscrew_t *ci,
    ksl_coscrew_t *co) {
  const double co_3a = KSL_MUL(t->z, ci->m1), co_3b = KSL_MUL(t->y, ci->m2), co_3c = co_3a - co_3b,
      co_3c_right = co_3a - co_3c, co_3 = co_3c + ci->m3, co_3_right = co_3 - co_3c,
      co_3c_lo = ksl_product_rest(t->z, ci->m1, co_3a, co_3c + co_3c_right)
          - ksl_product_rest(t->y, ci->m2, co_3b, co_3c_right);
  const double co_4a = KSL_MUL(t->x, ci->m2), co_4b = KSL_MUL(t->z, ci->m0), co_4c = co_4a - co_4b,
      co_4c_right = co_4a - co_4c, co_4 = co_4c + ci->m4, co_4_right = co_4 - co_4c,
      co_4c_lo = ksl_product_rest(t->x, ci->m2, co_4a, co_4c + co_4c_right)
          - ksl_product_rest(t->z, ci->m0, co_4b, co_4c_right);
  const double co_5a = KSL_MUL(t->y, ci->m0), co_5b = KSL_MUL(t->x, ci->m1), co_5c = co_5a - co_5b,
      co_5c_right = co_5a - co_5c, co_5 = co_5c + ci->m5, co_5_right = co_5 - co_5c,
      co_5c_lo = ksl_product_rest(t->y, ci->m0, co_5a, co_5c + co_5c_right)
          - ksl_product_rest(t->x, ci->m1, co_5b, co_5c_right);
  const double co_3_rounded = co_3
          + (co_3c - (co_3 - co_3_right) + (ci->m3 - co_3_right) + co_3c_lo),
      co_4_rounded = co_4 + (co_4c - (co_4 - co_4_right) + (ci->m4 - co_4_right) + co_4c_lo),
      co_5_rounded = co_5 + (co_5c - (co_5 - co_5_right) + (ci->m5 - co_5_right) + co_5c_lo);
  const double ci_m0 = ci->m0;
  const double ci_m1 = ci->m1;
  const double ci_m2 = ci->m2;
  co->m0 = ci_m0;
  co->m1 = ci_m1;
  co->m2 = ci_m2;
  co->m3 = co_3_rounded;
  co->m4 = co_4_rounded;
  co->m5 = co_5_rounded;
}

/* co = [Ad]*(t) (-ci).
   t: vector; ci, co: coscrew (f in N; τ in N m).
   6 mul, 36 add, 6 product rest, 3 neg.
   Error <= u |result| + (lin: 0, ang: 9) u^2 S, S the sum of the |terms| of the expanded
     formula; barring over- and underflow. */
static inline void ksl_product_CoAdtcinv_accurate(const ksl_vec3_t *t, const ksl_coscrew_t *ci,
    ksl_coscrew_t *co) {
  const double co_0 = -ci->m0, co_1 = -ci->m1, co_2 = -ci->m2;
  const double co_3a = KSL_MUL(t->z, ci->m1), co_3b = KSL_MUL(t->y, ci->m2), co_3c = co_3a - co_3b,
      co_3c_right = co_3a - co_3c, co_3 = co_3c - ci->m3, co_3_right = co_3c - co_3,
      co_3c_lo = ksl_product_rest(t->z, ci->m1, co_3a, co_3c + co_3c_right)
          - ksl_product_rest(t->y, ci->m2, co_3b, co_3c_right);
  const double co_4a = KSL_MUL(t->x, ci->m2), co_4b = KSL_MUL(t->z, ci->m0), co_4c = co_4a - co_4b,
      co_4c_right = co_4a - co_4c, co_4 = co_4c - ci->m4, co_4_right = co_4c - co_4,
      co_4c_lo = ksl_product_rest(t->x, ci->m2, co_4a, co_4c + co_4c_right)
          - ksl_product_rest(t->z, ci->m0, co_4b, co_4c_right);
  const double co_5a = KSL_MUL(t->y, ci->m0), co_5b = KSL_MUL(t->x, ci->m1), co_5c = co_5a - co_5b,
      co_5c_right = co_5a - co_5c, co_5 = co_5c - ci->m5, co_5_right = co_5c - co_5,
      co_5c_lo = ksl_product_rest(t->y, ci->m0, co_5a, co_5c + co_5c_right)
          - ksl_product_rest(t->x, ci->m1, co_5b, co_5c_right);
  const double co_3_rounded = co_3
          + (co_3c - (co_3 + co_3_right) - (ci->m3 - co_3_right) + co_3c_lo),
      co_4_rounded = co_4 + (co_4c - (co_4 + co_4_right) - (ci->m4 - co_4_right) + co_4c_lo),
      co_5_rounded = co_5 + (co_5c - (co_5 + co_5_right) - (ci->m5 - co_5_right) + co_5c_lo);
  co->m0 = co_0;
  co->m1 = co_1;
  co->m2 = co_2;
  co->m3 = co_3_rounded;
  co->m4 = co_4_rounded;
  co->m5 = co_5_rounded;
}

/* co = [Ad]*(R) ci.
   R: rotation or other 3×3 matrix; ci, co: coscrew (f in N; τ in N m).
   18 mul, 66 add, 18 product rest.
   Error <= u |result| + 11 u^2 S, S the sum of the |terms| of the expanded formula; barring
     over- and underflow. */
static inline void ksl_product_CoAdrc_accurate(const ksl_mat3x3_t *R, const ksl_coscrew_t *ci,
    ksl_coscrew_t *co) {
  const double co_0a = KSL_MUL(R->m00, ci->m0), co_0b = KSL_MUL(R->m01, ci->m1),
      co_0c = co_0a + co_0b, co_0c_right = co_0c - co_0a, co_0d = KSL_MUL(R->m02, ci->m2),
      co_0 = co_0c + co_0d, co_0_right = co_0 - co_0c,
      co_0c_lo = ksl_product_rest(R->m00, ci->m0, co_0a, co_0c - co_0c_right)
          + ksl_product_rest(R->m01, ci->m1, co_0b, co_0c_right);
  const double co_1a = KSL_MUL(R->m10, ci->m0), co_1b = KSL_MUL(R->m11, ci->m1),
      co_1c = co_1a + co_1b, co_1c_right = co_1c - co_1a, co_1d = KSL_MUL(R->m12, ci->m2),
      co_1 = co_1c + co_1d, co_1_right = co_1 - co_1c,
      co_1c_lo = ksl_product_rest(R->m10, ci->m0, co_1a, co_1c - co_1c_right)
          + ksl_product_rest(R->m11, ci->m1, co_1b, co_1c_right);
  const double co_2a = KSL_MUL(R->m20, ci->m0), co_2b = KSL_MUL(R->m21, ci->m1),
      co_2c = co_2a + co_2b, co_2c_right = co_2c - co_2a, co_2d = KSL_MUL(R->m22, ci->m2),
      co_2 = co_2c + co_2d, co_2_right = co_2 - co_2c,
      co_2c_lo = ksl_product_rest(R->m20, ci->m0, co_2a, co_2c - co_2c_right)
          + ksl_product_rest(R->m21, ci->m1, co_2b, co_2c_right);
  const double co_3a = KSL_MUL(R->m00, ci->m3), co_3b = KSL_MUL(R->m01, ci->m4),
      co_3c = co_3a + co_3b, co_3c_right = co_3c - co_3a, co_3d = KSL_MUL(R->m02, ci->m5),
      co_3 = co_3c + co_3d, co_3_right = co_3 - co_3c,
      co_3c_lo = ksl_product_rest(R->m00, ci->m3, co_3a, co_3c - co_3c_right)
          + ksl_product_rest(R->m01, ci->m4, co_3b, co_3c_right);
  const double co_4a = KSL_MUL(R->m10, ci->m3), co_4b = KSL_MUL(R->m11, ci->m4),
      co_4c = co_4a + co_4b, co_4c_right = co_4c - co_4a, co_4d = KSL_MUL(R->m12, ci->m5),
      co_4 = co_4c + co_4d, co_4_right = co_4 - co_4c,
      co_4c_lo = ksl_product_rest(R->m10, ci->m3, co_4a, co_4c - co_4c_right)
          + ksl_product_rest(R->m11, ci->m4, co_4b, co_4c_right);
  const double co_5a = KSL_MUL(R->m20, ci->m3), co_5b = KSL_MUL(R->m21, ci->m4),
      co_5c = co_5a + co_5b, co_5c_right = co_5c - co_5a, co_5d = KSL_MUL(R->m22, ci->m5),
      co_5 = co_5c + co_5d, co_5_right = co_5 - co_5c,
      co_5c_lo = ksl_product_rest(R->m20, ci->m3, co_5a, co_5c - co_5c_right)
          + ksl_product_rest(R->m21, ci->m4, co_5b, co_5c_right);
  const double co_0_rounded = co_0
          + (co_0c - (co_0 - co_0_right) + ksl_product_rest(R->m02, ci->m2, co_0d, co_0_right)
          + co_0c_lo),
      co_1_rounded = co_1
          + (co_1c - (co_1 - co_1_right) + ksl_product_rest(R->m12, ci->m2, co_1d, co_1_right)
          + co_1c_lo),
      co_2_rounded = co_2
          + (co_2c - (co_2 - co_2_right) + ksl_product_rest(R->m22, ci->m2, co_2d, co_2_right)
          + co_2c_lo),
      co_3_rounded = co_3
          + (co_3c - (co_3 - co_3_right) + ksl_product_rest(R->m02, ci->m5, co_3d, co_3_right)
          + co_3c_lo),
      co_4_rounded = co_4
          + (co_4c - (co_4 - co_4_right) + ksl_product_rest(R->m12, ci->m5, co_4d, co_4_right)
          + co_4c_lo),
      co_5_rounded = co_5
          + (co_5c - (co_5 - co_5_right) + ksl_product_rest(R->m22, ci->m5, co_5d, co_5_right)
          + co_5c_lo);
  co->m0 = co_0_rounded;
  co->m1 = co_1_rounded;
  co->m2 = co_2_rounded;
  co->m3 = co_3_rounded;
  co->m4 = co_4_rounded;
  co->m5 = co_5_rounded;
}

/* co = [Ad]*(R)^-1 ci.
   R: rotation or other 3×3 matrix; ci, co: coscrew (f in N; τ in N m).
   18 mul, 66 add, 18 product rest.
   Error <= u |result| + 11 u^2 S, S the sum of the |terms| of the expanded formula; barring
     over- and underflow. */
static inline void ksl_product_CoAdrinvc_accurate(const ksl_mat3x3_t *R, const ksl_coscrew_t *ci,
    ksl_coscrew_t *co) {
  const double co_0a = KSL_MUL(R->m00, ci->m0), co_0b = KSL_MUL(R->m10, ci->m1),
      co_0c = co_0a + co_0b, co_0c_right = co_0c - co_0a, co_0d = KSL_MUL(R->m20, ci->m2),
      co_0 = co_0c + co_0d, co_0_right = co_0 - co_0c,
      co_0c_lo = ksl_product_rest(R->m00, ci->m0, co_0a, co_0c - co_0c_right)
          + ksl_product_rest(R->m10, ci->m1, co_0b, co_0c_right);
  const double co_1a = KSL_MUL(R->m01, ci->m0), co_1b = KSL_MUL(R->m11, ci->m1),
      co_1c = co_1a + co_1b, co_1c_right = co_1c - co_1a, co_1d = KSL_MUL(R->m21, ci->m2),
      co_1 = co_1c + co_1d, co_1_right = co_1 - co_1c,
      co_1c_lo = ksl_product_rest(R->m01, ci->m0, co_1a, co_1c - co_1c_right)
          + ksl_product_rest(R->m11, ci->m1, co_1b, co_1c_right);
  const double co_2a = KSL_MUL(R->m02, ci->m0), co_2b = KSL_MUL(R->m12, ci->m1),
      co_2c = co_2a + co_2b, co_2c_right = co_2c - co_2a, co_2d = KSL_MUL(R->m22, ci->m2),
      co_2 = co_2c + co_2d, co_2_right = co_2 - co_2c,
      co_2c_lo = ksl_product_rest(R->m02, ci->m0, co_2a, co_2c - co_2c_right)
          + ksl_product_rest(R->m12, ci->m1, co_2b, co_2c_right);
  const double co_3a = KSL_MUL(R->m00, ci->m3), co_3b = KSL_MUL(R->m10, ci->m4),
      co_3c = co_3a + co_3b, co_3c_right = co_3c - co_3a, co_3d = KSL_MUL(R->m20, ci->m5),
      co_3 = co_3c + co_3d, co_3_right = co_3 - co_3c,
      co_3c_lo = ksl_product_rest(R->m00, ci->m3, co_3a, co_3c - co_3c_right)
          + ksl_product_rest(R->m10, ci->m4, co_3b, co_3c_right);
  const double co_4a = KSL_MUL(R->m01, ci->m3), co_4b = KSL_MUL(R->m11, ci->m4),
      co_4c = co_4a + co_4b, co_4c_right = co_4c - co_4a, co_4d = KSL_MUL(R->m21, ci->m5),
      co_4 = co_4c + co_4d, co_4_right = co_4 - co_4c,
      co_4c_lo = ksl_product_rest(R->m01, ci->m3, co_4a, co_4c - co_4c_right)
          + ksl_product_rest(R->m11, ci->m4, co_4b, co_4c_right);
  const double co_5a = KSL_MUL(R->m02, ci->m3), co_5b = KSL_MUL(R->m12, ci->m4),
      co_5c = co_5a + co_5b, co_5c_right = co_5c - co_5a, co_5d = KSL_MUL(R->m22, ci->m5),
      co_5 = co_5c + co_5d, co_5_right = co_5 - co_5c,
      co_5c_lo = ksl_product_rest(R->m02, ci->m3, co_5a, co_5c - co_5c_right)
          + ksl_product_rest(R->m12, ci->m4, co_5b, co_5c_right);
  const double co_0_rounded = co_0
          + (co_0c - (co_0 - co_0_right) + ksl_product_rest(R->m20, ci->m2, co_0d, co_0_right)
          + co_0c_lo),
      co_1_rounded = co_1
          + (co_1c - (co_1 - co_1_right) + ksl_product_rest(R->m21, ci->m2, co_1d, co_1_right)
          + co_1c_lo),
      co_2_rounded = co_2
          + (co_2c - (co_2 - co_2_right) + ksl_product_rest(R->m22, ci->m2, co_2d, co_2_right)
          + co_2c_lo),
      co_3_rounded = co_3
          + (co_3c - (co_3 - co_3_right) + ksl_product_rest(R->m20, ci->m5, co_3d, co_3_right)
          + co_3c_lo),
      co_4_rounded = co_4
          + (co_4c - (co_4 - co_4_right) + ksl_product_rest(R->m21, ci->m5, co_4d, co_4_right)
          + co_4c_lo),
      co_5_rounded = co_5
          + (co_5c - (co_5 - co_5_right) + ksl_product_rest(R->m22, ci->m5, co_5d, co_5_right)
          + co_5c_lo);
  co->m0 = co_0_rounded;
  co->m1 = co_1_rounded;
  co->m2 = co_2_rounded;
  co->m3 = co_3_rounded;
  co->m4 = co_4_rounded;
  co->m5 = co_5_rounded;
}

/* co = [Ad]*(R) (-ci).
   R: rotation or other 3×3 matrix; ci, co: coscrew (f in N; τ in N m).
   18 mul, 66 add, 18 product rest, 12 neg.
   Error <= u |result| + 11 u^2 S, S the sum of the |terms| of the expanded formula; barring
     over- and underflow. */
static inline void ksl_product_CoAdrcinv_accurate(const ksl_mat3x3_t *R, const ksl_coscrew_t *ci,
    ksl_coscrew_t *co) {
  const double co_0a = KSL_MUL(R->m00, ci->m0), co_0b = KSL_MUL(R->m01, ci->m1),
      co_0c = co_0a + co_0b, co_0c_right = co_0c - co_0a, co_0d = KSL_MUL(R->m02, ci->m2),
      co_0e = co_0c + co_0d, co_0e_right = co_0e - co_0c,
      co_0c_lo = ksl_product_rest(R->m00, ci->m0, co_0a, co_0c - co_0c_right)
          + ksl_product_rest(R->m01, ci->m1, co_0b, co_0c_right), co_0 = -co_0e;
  const double co_1a = KSL_MUL(R->m10, ci->m0), co_1b = KSL_MUL(R->m11, ci->m1),
      co_1c = co_1a + co_1b, co_1c_right = co_1c - co_1a, co_1d = KSL_MUL(R->m12, ci->m2),
      co_1e = co_1c + co_1d, co_1e_right = co_1e - co_1c,
      co_1c_lo = ksl_product_rest(R->m10, ci->m0, co_1a, co_1c - co_1c_right)
          + ksl_product_rest(R->m11, ci->m1, co_1b, co_1c_right), co_1 = -co_1e;
  const double co_2a = KSL_MUL(R->m20, ci->m0), co_2b = KSL_MUL(R->m21, ci->m1),
      co_2c = co_2a + co_2b, co_2c_right = co_2c - co_2a, co_2d = KSL_MUL(R->m22, ci->m2),
      co_2e = co_2c + co_2d, co_2e_right = co_2e - co_2c,
      co_2c_lo = ksl_product_rest(R->m20, ci->m0, co_2a, co_2c - co_2c_right)
          + ksl_product_rest(R->m21, ci->m1, co_2b, co_2c_right), co_2 = -co_2e;
  const double co_3a = KSL_MUL(R->m00, ci->m3), co_3b = KSL_MUL(R->m01, ci->m4),
      co_3c = co_3a + co_3b, co_3c_right = co_3c - co_3a, co_3d = KSL_MUL(R->m02, ci->m5),
      co_3e = co_3c + co_3d, co_3e_right = co_3e - co_3c,
      co_3c_lo = ksl_product_rest(R->m00, ci->m3, co_3a, co_3c - co_3c_right)
          + ksl_product_rest(R->m01, ci->m4, co_3b, co_3c_right), co_3 = -co_3e;
  const double co_4a = KSL_MUL(R->m10, ci->m3), co_4b = KSL_MUL(R->m11, ci->m4),
      co_4c = co_4a + co_4b, co_4c_right = co_4c - co_4a, co_4d = KSL_MUL(R->m12, ci->m5),
      co_4e = co_4c + co_4d, co_4e_right = co_4e - co_4c,
      co_4c_lo = ksl_product_rest(R->m10, ci->m3, co_4a, co_4c - co_4c_right)
          + ksl_product_rest(R->m11, ci->m4, co_4b, co_4c_right), co_4 = -co_4e;
  const double co_5a = KSL_MUL(R->m20, ci->m3), co_5b = KSL_MUL(R->m21, ci->m4),
      co_5c = co_5a + co_5b, co_5c_right = co_5c - co_5a, co_5d = KSL_MUL(R->m22, ci->m5),
      co_5e = co_5c + co_5d, co_5e_right = co_5e - co_5c,
      co_5c_lo = ksl_product_rest(R->m20, ci->m3, co_5a, co_5c - co_5c_right)
          + ksl_product_rest(R->m21, ci->m4, co_5b, co_5c_right), co_5 = -co_5e;
  const double co_0_rounded = co_0 +
          -(co_0c - (co_0e - co_0e_right) + ksl_product_rest(R->m02, ci->m2, co_0d, co_0e_right)
          + co_0c_lo),
      co_1_rounded = co_1 +
          -(co_1c - (co_1e - co_1e_right) + ksl_product_rest(R->m12, ci->m2, co_1d, co_1e_right)
          + co_1c_lo),
      co_2_rounded = co_2 +
          -(co_2c - (co_2e - co_2e_right) + ksl_product_rest(R->m22, ci->m2, co_2d, co_2e_right)
          + co_2c_lo),
      co_3_rounded = co_3 +
          -(co_3c - (co_3e - co_3e_right) + ksl_product_rest(R->m02, ci->m5, co_3d, co_3e_right)
          + co_3c_lo),
      co_4_rounded = co_4 +
          -(co_4c - (co_4e - co_4e_right) + ksl_product_rest(R->m12, ci->m5, co_4d, co_4e_right)
          + co_4c_lo),
      co_5_rounded = co_5 +
          -(co_5c - (co_5e - co_5e_right) + ksl_product_rest(R->m22, ci->m5, co_5d, co_5e_right)
          + co_5c_lo);
  co->m0 = co_0_rounded;
  co->m1 = co_1_rounded;
  co->m2 = co_2_rounded;
  co->m3 = co_3_rounded;
  co->m4 = co_4_rounded;
  co->m5 = co_5_rounded;
}

/* co = [Ad]*(D) ci = [Ad]*(t) [Ad]*(R) ci.
   D: displacement [R | t], R rotation, t in m; ci, co: coscrew (f in N; τ in N m).
   30 mul, 108 add, 24 product rest.
   Error <= u |result| + (lin: 11, ang: 35) u^2 S, S the sum of the |terms| of the expanded
     formula; barring over- and underflow. */
static inline void ksl_product_CoAdc_accurate(const ksl_SE3_t *D, const ksl_coscrew_t *ci,
    ksl_coscrew_t *co) {
  const double w_0a = KSL_MUL(D->m00, ci->m0), w_0b = KSL_MUL(D->m01, ci->m1), w_0c = w_0a + w_0b,
      w_0c_right = w_0c - w_0a, w_0d = KSL_MUL(D->m02, ci->m2), w_0 = w_0c + w_0d,
      w_0_right = w_0 - w_0c,
      w_0c_lo = ksl_product_rest(D->m00, ci->m0, w_0a, w_0c - w_0c_right)
          + ksl_product_rest(D->m01, ci->m1, w_0b, w_0c_right),
      w_0_lo = w_0c - (w_0 - w_0_right) + ksl_product_rest(D->m02, ci->m2, w_0d, w_0_right)
          + w_0c_lo;
  const double w_1a = KSL_MUL(D->m10, ci->m0), w_1b = KSL_MUL(D->m11, ci->m1), w_1c = w_1a + w_1b,
      w_1c_right = w_1c - w_1a, w_1d = KSL_MUL(D->m12, ci->m2), w_1 = w_1c + w_1d,
      w_1_right = w_1 - w_1c,
      w_1c_lo = ksl_product_rest(D->m10, ci->m0, w_1a, w_1c - w_1c_right)
          + ksl_product_rest(D->m11, ci->m1, w_1b, w_1c_right),
      w_1_lo = w_1c - (w_1 - w_1_right) + ksl_product_rest(D->m12, ci->m2, w_1d, w_1_right)
          + w_1c_lo;
  const double w_2a = KSL_MUL(D->m20, ci->m0), w_2b = KSL_MUL(D->m21, ci->m1), w_2c = w_2a + w_2b,
      w_2c_right = w_2c - w_2a, w_2d = KSL_MUL(D->m22, ci->m2), w_2 = w_2c + w_2d,
      w_2_right = w_2 - w_2c,
      w_2c_lo = ksl_product_rest(D->m20, ci->m0, w_2a, w_2c - w_2c_right)
          + ksl_product_rest(D->m21, ci->m1, w_2b, w_2c_right),
      w_2_lo = w_2c - (w_2 - w_2_right) + ksl_product_rest(D->m22, ci->m2, w_2d, w_2_right)
          + w_2c_lo;
  const double w_3a = KSL_MUL(D->m00, ci->m3), w_3b = KSL_MUL(D->m01, ci->m4), w_3c = w_3a + w_3b,
      w_3c_right = w_3c - w_3a, w_3d = KSL_MUL(D->m02, ci->m5), w_3 = w_3c + w_3d,
      w_3_right = w_3 - w_3c,
      w_3c_lo = ksl_product_rest(D->m00, ci->m3, w_3a, w_3c - w_3c_right)
          + ksl_product_rest(D->m01, ci->m4, w_3b, w_3c_right);
  const double w_4a = KSL_MUL(D->m10, ci->m3), w_4b = KSL_MUL(D->m11, ci->m4), w_4c = w_4a + w_4b,
      w_4c_right = w_4c - w_4a, w_4d = KSL_MUL(D->m12, ci->m5), w_4 = w_4c + w_4d,
      w_4_right = w_4 - w_4c,
      w_4c_lo = ksl_product_rest(D->m10, ci->m3, w_4a, w_4c - w_4c_right)
          + ksl_product_rest(D->m11, ci->m4, w_4b, w_4c_right);
  const double w_5a = KSL_MUL(D->m20, ci->m3), w_5b = KSL_MUL(D->m21, ci->m4), w_5c = w_5a + w_5b,
      w_5c_right = w_5c - w_5a, w_5d = KSL_MUL(D->m22, ci->m5), w_5 = w_5c + w_5d,
      w_5_right = w_5 - w_5c,
      w_5c_lo = ksl_product_rest(D->m20, ci->m3, w_5a, w_5c - w_5c_right)
          + ksl_product_rest(D->m21, ci->m4, w_5b, w_5c_right);
  const double co_3a = KSL_MUL(D->m13, w_2), co_3b = KSL_MUL(D->m23, w_1), co_3c = co_3a - co_3b,
      co_3c_right = co_3a - co_3c,
      co_3c_lo1 = ksl_product_rest(D->m13, w_2, co_3a, co_3c + co_3c_right)
          - ksl_product_rest(D->m23, w_1, co_3b, co_3c_right), co_3 = co_3c + w_3,
      co_3_right = co_3 - co_3c,
      co_3_lo2 = co_3c - (co_3 - co_3_right) + (w_3 - co_3_right)
          + (w_3c - (w_3 - w_3_right) + ksl_product_rest(D->m02, ci->m5, w_3d, w_3_right)
          + w_3c_lo);
  const double co_4a = KSL_MUL(D->m23, w_0), co_4b = KSL_MUL(D->m03, w_2), co_4c = co_4a - co_4b,
      co_4c_right = co_4a - co_4c,
      co_4c_lo1 = ksl_product_rest(D->m23, w_0, co_4a, co_4c + co_4c_right)
          - ksl_product_rest(D->m03, w_2, co_4b, co_4c_right), co_4 = co_4c + w_4,
      co_4_right = co_4 - co_4c,
      co_4_lo2 = co_4c - (co_4 - co_4_right) + (w_4 - co_4_right)
          + (w_4c - (w_4 - w_4_right) + ksl_product_rest(D->m12, ci->m5, w_4d, w_4_right)
          + w_4c_lo);
  const double co_5a = KSL_MUL(D->m03, w_1), co_5b = KSL_MUL(D->m13, w_0), co_5c = co_5a - co_5b,
      co_5c_right = co_5a - co_5c,
      co_5c_lo1 = ksl_product_rest(D->m03, w_1, co_5a, co_5c + co_5c_right)
          - ksl_product_rest(D->m13, w_0, co_5b, co_5c_right), co_5 = co_5c + w_5,
      co_5_right = co_5 - co_5c,
      co_5_lo2 = co_5c - (co_5 - co_5_right) + (w_5 - co_5_right)
          + (w_5c - (w_5 - w_5_right) + ksl_product_rest(D->m22, ci->m5, w_5d, w_5_right)
          + w_5c_lo);
  const double w_0_rounded = w_0 + w_0_lo, w_1_rounded = w_1 + w_1_lo, w_2_rounded = w_2 + w_2_lo;
  const double co_3_rounded = co_3
          + (co_3_lo2 + (co_3c_lo1 + (KSL_MUL(D->m13, w_2_lo) - KSL_MUL(D->m23, w_1_lo)))),
      co_4_rounded = co_4
          + (co_4_lo2 + (co_4c_lo1 + (KSL_MUL(D->m23, w_0_lo) - KSL_MUL(D->m03, w_2_lo)))),
      co_5_rounded = co_5
          + (co_5_lo2 + (co_5c_lo1 + (KSL_MUL(D->m03, w_1_lo) - KSL_MUL(D->m13, w_0_lo))));
  co->m0 = w_0_rounded;
  co->m1 = w_1_rounded;
  co->m2 = w_2_rounded;
  co->m3 = co_3_rounded;
  co->m4 = co_4_rounded;
  co->m5 = co_5_rounded;
}

/* co = [Ad]*(D)^-1 ci = [Ad]*(R^T) [Ad]*(-t) ci.
   D: displacement [R | t], R rotation, t in m; ci, co: coscrew (f in N; τ in N m).
   33 mul, 108 add, 24 product rest.
   Error <= u |result| + (lin: 11, ang: 35) u^2 S, S the sum of the |terms| of the expanded
     formula; barring over- and underflow. */
static inline void ksl_product_CoAdinvc_accurate(const ksl_SE3_t *D, const ksl_coscrew_t *ci,
    ksl_coscrew_t *co) {
  const double w_3a = KSL_MUL(D->m23, ci->m1), w_3b = KSL_MUL(D->m13, ci->m2), w_3c = w_3a - w_3b,
      w_3c_right = w_3a - w_3c, w_3 = w_3c + ci->m3, w_3_right = w_3 - w_3c,
      w_3c_lo = ksl_product_rest(D->m23, ci->m1, w_3a, w_3c + w_3c_right)
          - ksl_product_rest(D->m13, ci->m2, w_3b, w_3c_right),
      w_3_lo = w_3c - (w_3 - w_3_right) + (ci->m3 - w_3_right) + w_3c_lo;
  const double w_4a = KSL_MUL(D->m03, ci->m2), w_4b = KSL_MUL(D->m23, ci->m0), w_4c = w_4a - w_4b,
      w_4c_right = w_4a - w_4c, w_4 = w_4c + ci->m4, w_4_right = w_4 - w_4c,
      w_4c_lo = ksl_product_rest(D->m03, ci->m2, w_4a, w_4c + w_4c_right)
          - ksl_product_rest(D->m23, ci->m0, w_4b, w_4c_right),
      w_4_lo = w_4c - (w_4 - w_4_right) + (ci->m4 - w_4_right) + w_4c_lo;
  const double w_5a = KSL_MUL(D->m13, ci->m0), w_5b = KSL_MUL(D->m03, ci->m1), w_5c = w_5a - w_5b,
      w_5c_right = w_5a - w_5c, w_5 = w_5c + ci->m5, w_5_right = w_5 - w_5c,
      w_5c_lo = ksl_product_rest(D->m13, ci->m0, w_5a, w_5c + w_5c_right)
          - ksl_product_rest(D->m03, ci->m1, w_5b, w_5c_right),
      w_5_lo = w_5c - (w_5 - w_5_right) + (ci->m5 - w_5_right) + w_5c_lo;
  const double co_0a = KSL_MUL(D->m00, ci->m0), co_0b = KSL_MUL(D->m10, ci->m1),
      co_0c = co_0a + co_0b, co_0c_right = co_0c - co_0a, co_0d = KSL_MUL(D->m20, ci->m2),
      co_0 = co_0c + co_0d, co_0_right = co_0 - co_0c,
      co_0c_lo = ksl_product_rest(D->m00, ci->m0, co_0a, co_0c - co_0c_right)
          + ksl_product_rest(D->m10, ci->m1, co_0b, co_0c_right);
  const double co_1a = KSL_MUL(D->m01, ci->m0), co_1b = KSL_MUL(D->m11, ci->m1),
      co_1c = co_1a + co_1b, co_1c_right = co_1c - co_1a, co_1d = KSL_MUL(D->m21, ci->m2),
      co_1 = co_1c + co_1d, co_1_right = co_1 - co_1c,
      co_1c_lo = ksl_product_rest(D->m01, ci->m0, co_1a, co_1c - co_1c_right)
          + ksl_product_rest(D->m11, ci->m1, co_1b, co_1c_right);
  const double co_2a = KSL_MUL(D->m02, ci->m0), co_2b = KSL_MUL(D->m12, ci->m1),
      co_2c = co_2a + co_2b, co_2c_right = co_2c - co_2a, co_2d = KSL_MUL(D->m22, ci->m2),
      co_2 = co_2c + co_2d, co_2_right = co_2 - co_2c,
      co_2c_lo = ksl_product_rest(D->m02, ci->m0, co_2a, co_2c - co_2c_right)
          + ksl_product_rest(D->m12, ci->m1, co_2b, co_2c_right);
  const double co_3a = KSL_MUL(D->m00, w_3), co_3b = KSL_MUL(D->m10, w_4), co_3c = co_3a + co_3b,
      co_3c_right = co_3c - co_3a,
      co_3c_lo1 = ksl_product_rest(D->m00, w_3, co_3a, co_3c - co_3c_right)
          + ksl_product_rest(D->m10, w_4, co_3b, co_3c_right), co_3d = KSL_MUL(D->m20, w_5),
      co_3 = co_3c + co_3d, co_3_right = co_3 - co_3c,
      co_3_lo2 = co_3c - (co_3 - co_3_right) + ksl_product_rest(D->m20, w_5, co_3d, co_3_right)
          + KSL_MUL(D->m20, w_5_lo);
  const double co_4a = KSL_MUL(D->m01, w_3), co_4b = KSL_MUL(D->m11, w_4), co_4c = co_4a + co_4b,
      co_4c_right = co_4c - co_4a,
      co_4c_lo1 = ksl_product_rest(D->m01, w_3, co_4a, co_4c - co_4c_right)
          + ksl_product_rest(D->m11, w_4, co_4b, co_4c_right), co_4d = KSL_MUL(D->m21, w_5),
      co_4 = co_4c + co_4d, co_4_right = co_4 - co_4c,
      co_4_lo2 = co_4c - (co_4 - co_4_right) + ksl_product_rest(D->m21, w_5, co_4d, co_4_right)
          + KSL_MUL(D->m21, w_5_lo);
  const double co_5a = KSL_MUL(D->m02, w_3), co_5b = KSL_MUL(D->m12, w_4), co_5c = co_5a + co_5b,
      co_5c_right = co_5c - co_5a,
      co_5c_lo1 = ksl_product_rest(D->m02, w_3, co_5a, co_5c - co_5c_right)
          + ksl_product_rest(D->m12, w_4, co_5b, co_5c_right), co_5d = KSL_MUL(D->m22, w_5),
      co_5 = co_5c + co_5d, co_5_right = co_5 - co_5c,
      co_5_lo2 = co_5c - (co_5 - co_5_right) + ksl_product_rest(D->m22, w_5, co_5d, co_5_right)
          + KSL_MUL(D->m22, w_5_lo);
  const double co_0_rounded = co_0
          + (co_0c - (co_0 - co_0_right) + ksl_product_rest(D->m20, ci->m2, co_0d, co_0_right)
          + co_0c_lo),
      co_1_rounded = co_1
          + (co_1c - (co_1 - co_1_right) + ksl_product_rest(D->m21, ci->m2, co_1d, co_1_right)
          + co_1c_lo),
      co_2_rounded = co_2
          + (co_2c - (co_2 - co_2_right) + ksl_product_rest(D->m22, ci->m2, co_2d, co_2_right)
          + co_2c_lo),
      co_3_rounded = co_3
          + (co_3_lo2 + (co_3c_lo1 + (KSL_MUL(D->m00, w_3_lo) + KSL_MUL(D->m10, w_4_lo)))),
      co_4_rounded = co_4
          + (co_4_lo2 + (co_4c_lo1 + (KSL_MUL(D->m01, w_3_lo) + KSL_MUL(D->m11, w_4_lo)))),
      co_5_rounded = co_5
          + (co_5_lo2 + (co_5c_lo1 + (KSL_MUL(D->m02, w_3_lo) + KSL_MUL(D->m12, w_4_lo))));
  co->m0 = co_0_rounded;
  co->m1 = co_1_rounded;
  co->m2 = co_2_rounded;
  co->m3 = co_3_rounded;
  co->m4 = co_4_rounded;
  co->m5 = co_5_rounded;
}

/* co = [Ad]*(D) (-ci).
   D: displacement [R | t], R rotation, t in m; ci, co: coscrew (f in N; τ in N m).
   30 mul, 108 add, 24 product rest, 12 neg.
   Error <= u |result| + (lin: 11, ang: 35) u^2 S, S the sum of the |terms| of the expanded
     formula; barring over- and underflow. */
static inline void ksl_product_CoAdcinv_accurate(const ksl_SE3_t *D, const ksl_coscrew_t *ci,
    ksl_coscrew_t *co) {
  const double w_0a = KSL_MUL(D->m00, ci->m0), w_0b = KSL_MUL(D->m01, ci->m1), w_0c = w_0a + w_0b,
      w_0c_right = w_0c - w_0a, w_0d = KSL_MUL(D->m02, ci->m2), w_0e = w_0c + w_0d,
      w_0e_right = w_0e - w_0c,
      w_0c_lo = ksl_product_rest(D->m00, ci->m0, w_0a, w_0c - w_0c_right)
          + ksl_product_rest(D->m01, ci->m1, w_0b, w_0c_right), w_0 = -w_0e,
      w_0_lo =
          -(w_0c - (w_0e - w_0e_right) + ksl_product_rest(D->m02, ci->m2, w_0d, w_0e_right)
          + w_0c_lo);
  const double w_1a = KSL_MUL(D->m10, ci->m0), w_1b = KSL_MUL(D->m11, ci->m1), w_1c = w_1a + w_1b,
      w_1c_right = w_1c - w_1a, w_1d = KSL_MUL(D->m12, ci->m2), w_1e = w_1c + w_1d,
      w_1e_right = w_1e - w_1c,
      w_1c_lo = ksl_product_rest(D->m10, ci->m0, w_1a, w_1c - w_1c_right)
          + ksl_product_rest(D->m11, ci->m1, w_1b, w_1c_right), w_1 = -w_1e,
      w_1_lo =
          -(w_1c - (w_1e - w_1e_right) + ksl_product_rest(D->m12, ci->m2, w_1d, w_1e_right)
          + w_1c_lo);
  const double w_2a = KSL_MUL(D->m20, ci->m0), w_2b = KSL_MUL(D->m21, ci->m1), w_2c = w_2a + w_2b,
      w_2c_right = w_2c - w_2a, w_2d = KSL_MUL(D->m22, ci->m2), w_2e = w_2c + w_2d,
      w_2e_right = w_2e - w_2c,
      w_2c_lo = ksl_product_rest(D->m20, ci->m0, w_2a, w_2c - w_2c_right)
          + ksl_product_rest(D->m21, ci->m1, w_2b, w_2c_right), w_2 = -w_2e,
      w_2_lo =
          -(w_2c - (w_2e - w_2e_right) + ksl_product_rest(D->m22, ci->m2, w_2d, w_2e_right)
          + w_2c_lo);
  const double w_3a = KSL_MUL(D->m00, ci->m3), w_3b = KSL_MUL(D->m01, ci->m4), w_3c = w_3a + w_3b,
      w_3c_right = w_3c - w_3a, w_3d = KSL_MUL(D->m02, ci->m5), w_3e = w_3c + w_3d,
      w_3e_right = w_3e - w_3c,
      w_3c_lo = ksl_product_rest(D->m00, ci->m3, w_3a, w_3c - w_3c_right)
          + ksl_product_rest(D->m01, ci->m4, w_3b, w_3c_right), w_3 = -w_3e;
  const double w_4a = KSL_MUL(D->m10, ci->m3), w_4b = KSL_MUL(D->m11, ci->m4), w_4c = w_4a + w_4b,
      w_4c_right = w_4c - w_4a, w_4d = KSL_MUL(D->m12, ci->m5), w_4e = w_4c + w_4d,
      w_4e_right = w_4e - w_4c,
      w_4c_lo = ksl_product_rest(D->m10, ci->m3, w_4a, w_4c - w_4c_right)
          + ksl_product_rest(D->m11, ci->m4, w_4b, w_4c_right), w_4 = -w_4e;
  const double w_5a = KSL_MUL(D->m20, ci->m3), w_5b = KSL_MUL(D->m21, ci->m4), w_5c = w_5a + w_5b,
      w_5c_right = w_5c - w_5a, w_5d = KSL_MUL(D->m22, ci->m5), w_5e = w_5c + w_5d,
      w_5e_right = w_5e - w_5c,
      w_5c_lo = ksl_product_rest(D->m20, ci->m3, w_5a, w_5c - w_5c_right)
          + ksl_product_rest(D->m21, ci->m4, w_5b, w_5c_right), w_5 = -w_5e;
  const double co_3a = KSL_MUL(D->m13, w_2), co_3b = KSL_MUL(D->m23, w_1), co_3c = co_3a - co_3b,
      co_3c_right = co_3a - co_3c,
      co_3c_lo1 = ksl_product_rest(D->m13, w_2, co_3a, co_3c + co_3c_right)
          - ksl_product_rest(D->m23, w_1, co_3b, co_3c_right), co_3 = co_3c + w_3,
      co_3_right = co_3 - co_3c;
  const double w_3_lo =
          -(w_3c - (w_3e - w_3e_right) + ksl_product_rest(D->m02, ci->m5, w_3d, w_3e_right)
          + w_3c_lo);
  const double co_4a = KSL_MUL(D->m23, w_0), co_4b = KSL_MUL(D->m03, w_2), co_4c = co_4a - co_4b,
      co_4c_right = co_4a - co_4c,
      co_4c_lo1 = ksl_product_rest(D->m23, w_0, co_4a, co_4c + co_4c_right)
          - ksl_product_rest(D->m03, w_2, co_4b, co_4c_right), co_4 = co_4c + w_4,
      co_4_right = co_4 - co_4c;
  const double w_4_lo =
          -(w_4c - (w_4e - w_4e_right) + ksl_product_rest(D->m12, ci->m5, w_4d, w_4e_right)
          + w_4c_lo);
  const double co_5a = KSL_MUL(D->m03, w_1), co_5b = KSL_MUL(D->m13, w_0), co_5c = co_5a - co_5b,
      co_5c_right = co_5a - co_5c,
      co_5c_lo1 = ksl_product_rest(D->m03, w_1, co_5a, co_5c + co_5c_right)
          - ksl_product_rest(D->m13, w_0, co_5b, co_5c_right), co_5 = co_5c + w_5,
      co_5_right = co_5 - co_5c;
  const double w_5_lo =
          -(w_5c - (w_5e - w_5e_right) + ksl_product_rest(D->m22, ci->m5, w_5d, w_5e_right)
          + w_5c_lo);
  const double w_0_rounded = w_0 + w_0_lo, w_1_rounded = w_1 + w_1_lo, w_2_rounded = w_2 + w_2_lo;
  const double co_3_rounded = co_3
          + (co_3c - (co_3 - co_3_right) + (w_3 - co_3_right) + w_3_lo
          + (co_3c_lo1 + (KSL_MUL(D->m13, w_2_lo) - KSL_MUL(D->m23, w_1_lo)))),
      co_4_rounded = co_4
          + (co_4c - (co_4 - co_4_right) + (w_4 - co_4_right) + w_4_lo
          + (co_4c_lo1 + (KSL_MUL(D->m23, w_0_lo) - KSL_MUL(D->m03, w_2_lo)))),
      co_5_rounded = co_5
          + (co_5c - (co_5 - co_5_right) + (w_5 - co_5_right) + w_5_lo
          + (co_5c_lo1 + (KSL_MUL(D->m03, w_1_lo) - KSL_MUL(D->m13, w_0_lo))));
  co->m0 = w_0_rounded;
  co->m1 = w_1_rounded;
  co->m2 = w_2_rounded;
  co->m3 = co_3_rounded;
  co->m4 = co_4_rounded;
  co->m5 = co_5_rounded;
}

/* co = h_tx: column 0 of [Ad]*(D).
   D: displacement [R | t], R rotation, t in m; co: coscrew (f in N; τ in N m).
   6 mul, 15 add, 6 product rest.
   Error <= u |result| + (lin: 0, ang: 6) u^2 S, S the sum of the |terms| of the expanded
     formula; barring over- and underflow. */
static inline void ksl_hctx_accurate(const ksl_SE3_t *D, ksl_coscrew_t *co) {
  const double co_3a = KSL_MUL(D->m20, D->m13), co_3b = KSL_MUL(D->m10, D->m23),
      co_3 = co_3a - co_3b, co_3_right = co_3a - co_3;
  const double co_4a = KSL_MUL(D->m00, D->m23), co_4b = KSL_MUL(D->m20, D->m03),
      co_4 = co_4a - co_4b, co_4_right = co_4a - co_4;
  const double co_5a = KSL_MUL(D->m10, D->m03), co_5b = KSL_MUL(D->m00, D->m13),
      co_5 = co_5a - co_5b, co_5_right = co_5a - co_5;
  const double co_3_rounded = co_3
          + (ksl_product_rest(D->m20, D->m13, co_3a, co_3 + co_3_right)
          - ksl_product_rest(D->m10, D->m23, co_3b, co_3_right)),
      co_4_rounded = co_4
          + (ksl_product_rest(D->m00, D->m23, co_4a, co_4 + co_4_right)
          - ksl_product_rest(D->m20, D->m03, co_4b, co_4_right)),
      co_5_rounded = co_5
          + (ksl_product_rest(D->m10, D->m03, co_5a, co_5 + co_5_right)
          - ksl_product_rest(D->m00, D->m13, co_5b, co_5_right));
  const double D_m00 = D->m00;
  const double D_m10 = D->m10;
  const double D_m20 = D->m20;
  co->m0 = D_m00;
  co->m1 = D_m10;
  co->m2 = D_m20;
  co->m3 = co_3_rounded;
  co->m4 = co_4_rounded;
  co->m5 = co_5_rounded;
}

/* co = h_ty: column 1 of [Ad]*(D).
   D: displacement [R | t], R rotation, t in m; co: coscrew (f in N; τ in N m).
   6 mul, 15 add, 6 product rest.
   Error <= u |result| + (lin: 0, ang: 6) u^2 S, S the sum of the |terms| of the expanded
     formula; barring over- and underflow. */
static inline void ksl_hcty_accurate(const ksl_SE3_t *D, ksl_coscrew_t *co) {
  const double co_3a = KSL_MUL(D->m21, D->m13), co_3b = KSL_MUL(D->m11, D->m23),
      co_3 = co_3a - co_3b, co_3_right = co_3a - co_3;
  const double co_4a = KSL_MUL(D->m01, D->m23), co_4b = KSL_MUL(D->m21, D->m03),
      co_4 = co_4a - co_4b, co_4_right = co_4a - co_4;
  const double co_5a = KSL_MUL(D->m11, D->m03), co_5b = KSL_MUL(D->m01, D->m13),
      co_5 = co_5a - co_5b, co_5_right = co_5a - co_5;
  const double co_3_rounded = co_3
          + (ksl_product_rest(D->m21, D->m13, co_3a, co_3 + co_3_right)
          - ksl_product_rest(D->m11, D->m23, co_3b, co_3_right)),
      co_4_rounded = co_4
          + (ksl_product_rest(D->m01, D->m23, co_4a, co_4 + co_4_right)
          - ksl_product_rest(D->m21, D->m03, co_4b, co_4_right)),
      co_5_rounded = co_5
          + (ksl_product_rest(D->m11, D->m03, co_5a, co_5 + co_5_right)
          - ksl_product_rest(D->m01, D->m13, co_5b, co_5_right));
  const double D_m01 = D->m01;
  const double D_m11 = D->m11;
  const double D_m21 = D->m21;
  co->m0 = D_m01;
  co->m1 = D_m11;
  co->m2 = D_m21;
  co->m3 = co_3_rounded;
  co->m4 = co_4_rounded;
  co->m5 = co_5_rounded;
}

/* co = h_tz: column 2 of [Ad]*(D).
   D: displacement [R | t], R rotation, t in m; co: coscrew (f in N; τ in N m).
   6 mul, 15 add, 6 product rest.
   Error <= u |result| + (lin: 0, ang: 6) u^2 S, S the sum of the |terms| of the expanded
     formula; barring over- and underflow. */
static inline void ksl_hctz_accurate(const ksl_SE3_t *D, ksl_coscrew_t *co) {
  const double co_3a = KSL_MUL(D->m22, D->m13), co_3b = KSL_MUL(D->m12, D->m23),
      co_3 = co_3a - co_3b, co_3_right = co_3a - co_3;
  const double co_4a = KSL_MUL(D->m02, D->m23), co_4b = KSL_MUL(D->m22, D->m03),
      co_4 = co_4a - co_4b, co_4_right = co_4a - co_4;
  const double co_5a = KSL_MUL(D->m12, D->m03), co_5b = KSL_MUL(D->m02, D->m13),
      co_5 = co_5a - co_5b, co_5_right = co_5a - co_5;
  const double co_3_rounded = co_3
          + (ksl_product_rest(D->m22, D->m13, co_3a, co_3 + co_3_right)
          - ksl_product_rest(D->m12, D->m23, co_3b, co_3_right)),
      co_4_rounded = co_4
          + (ksl_product_rest(D->m02, D->m23, co_4a, co_4 + co_4_right)
          - ksl_product_rest(D->m22, D->m03, co_4b, co_4_right)),
      co_5_rounded = co_5
          + (ksl_product_rest(D->m12, D->m03, co_5a, co_5 + co_5_right)
          - ksl_product_rest(D->m02, D->m13, co_5b, co_5_right));
  const double D_m02 = D->m02;
  const double D_m12 = D->m12;
  const double D_m22 = D->m22;
  co->m0 = D_m02;
  co->m1 = D_m12;
  co->m2 = D_m22;
  co->m3 = co_3_rounded;
  co->m4 = co_4_rounded;
  co->m5 = co_5_rounded;
}

/* co = -h_tx: -column 0 of [Ad]*(D).
   D: displacement [R | t], R rotation, t in m; co: coscrew (f in N; τ in N m).
   6 mul, 15 add, 6 product rest, 3 neg.
   Error <= u |result| + (lin: 0, ang: 6) u^2 S, S the sum of the |terms| of the expanded
     formula; barring over- and underflow. */
static inline void ksl_hctxinv_accurate(const ksl_SE3_t *D, ksl_coscrew_t *co) {
  const double co_0 = -D->m00, co_1 = -D->m10, co_2 = -D->m20;
  const double co_3a = KSL_MUL(D->m10, D->m23), co_3b = KSL_MUL(D->m20, D->m13),
      co_3 = co_3a - co_3b, co_3_right = co_3a - co_3;
  const double co_4a = KSL_MUL(D->m20, D->m03), co_4b = KSL_MUL(D->m00, D->m23),
      co_4 = co_4a - co_4b, co_4_right = co_4a - co_4;
  const double co_5a = KSL_MUL(D->m00, D->m13), co_5b = KSL_MUL(D->m10, D->m03),
      co_5 = co_5a - co_5b, co_5_right = co_5a - co_5;
  const double co_3_rounded = co_3
          + (ksl_product_rest(D->m10, D->m23, co_3a, co_3 + co_3_right)
          - ksl_product_rest(D->m20, D->m13, co_3b, co_3_right)),
      co_4_rounded = co_4
          + (ksl_product_rest(D->m20, D->m03, co_4a, co_4 + co_4_right)
          - ksl_product_rest(D->m00, D->m23, co_4b, co_4_right)),
      co_5_rounded = co_5
          + (ksl_product_rest(D->m00, D->m13, co_5a, co_5 + co_5_right)
          - ksl_product_rest(D->m10, D->m03, co_5b, co_5_right));
  co->m0 = co_0;
  co->m1 = co_1;
  co->m2 = co_2;
  co->m3 = co_3_rounded;
  co->m4 = co_4_rounded;
  co->m5 = co_5_rounded;
}

/* co = -h_ty: -column 1 of [Ad]*(D).
   D: displacement [R | t], R rotation, t in m; co: coscrew (f in N; τ in N m).
   6 mul, 15 add, 6 product rest, 3 neg.
   Error <= u |result| + (lin: 0, ang: 6) u^2 S, S the sum of the |terms| of the expanded
     formula; barring over- and underflow. */
static inline void ksl_hctyinv_accurate(const ksl_SE3_t *D, ksl_coscrew_t *co) {
  const double co_0 = -D->m01, co_1 = -D->m11, co_2 = -D->m21;
  const double co_3a = KSL_MUL(D->m11, D->m23), co_3b = KSL_MUL(D->m21, D->m13),
      co_3 = co_3a - co_3b, co_3_right = co_3a - co_3;
  const double co_4a = KSL_MUL(D->m21, D->m03), co_4b = KSL_MUL(D->m01, D->m23),
      co_4 = co_4a - co_4b, co_4_right = co_4a - co_4;
  const double co_5a = KSL_MUL(D->m01, D->m13), co_5b = KSL_MUL(D->m11, D->m03),
      co_5 = co_5a - co_5b, co_5_right = co_5a - co_5;
  const double co_3_rounded = co_3
          + (ksl_product_rest(D->m11, D->m23, co_3a, co_3 + co_3_right)
          - ksl_product_rest(D->m21, D->m13, co_3b, co_3_right)),
      co_4_rounded = co_4
          + (ksl_product_rest(D->m21, D->m03, co_4a, co_4 + co_4_right)
          - ksl_product_rest(D->m01, D->m23, co_4b, co_4_right)),
      co_5_rounded = co_5
          + (ksl_product_rest(D->m01, D->m13, co_5a, co_5 + co_5_right)
          - ksl_product_rest(D->m11, D->m03, co_5b, co_5_right));
  co->m0 = co_0;
  co->m1 = co_1;
  co->m2 = co_2;
  co->m3 = co_3_rounded;
  co->m4 = co_4_rounded;
  co->m5 = co_5_rounded;
}

/* co = -h_tz: -column 2 of [Ad]*(D).
   D: displacement [R | t], R rotation, t in m; co: coscrew (f in N; τ in N m).
   6 mul, 15 add, 6 product rest, 3 neg.
   Error <= u |result| + (lin: 0, ang: 6) u^2 S, S the sum of the |terms| of the expanded
     formula; barring over- and underflow. */
static inline void ksl_hctzinv_accurate(const ksl_SE3_t *D, ksl_coscrew_t *co) {
  const double co_0 = -D->m02, co_1 = -D->m12, co_2 = -D->m22;
  const double co_3a = KSL_MUL(D->m12, D->m23), co_3b = KSL_MUL(D->m22, D->m13),
      co_3 = co_3a - co_3b, co_3_right = co_3a - co_3;
  const double co_4a = KSL_MUL(D->m22, D->m03), co_4b = KSL_MUL(D->m02, D->m23),
      co_4 = co_4a - co_4b, co_4_right = co_4a - co_4;
  const double co_5a = KSL_MUL(D->m02, D->m13), co_5b = KSL_MUL(D->m12, D->m03),
      co_5 = co_5a - co_5b, co_5_right = co_5a - co_5;
  const double co_3_rounded = co_3
          + (ksl_product_rest(D->m12, D->m23, co_3a, co_3 + co_3_right)
          - ksl_product_rest(D->m22, D->m13, co_3b, co_3_right)),
      co_4_rounded = co_4
          + (ksl_product_rest(D->m22, D->m03, co_4a, co_4 + co_4_right)
          - ksl_product_rest(D->m02, D->m23, co_4b, co_4_right)),
      co_5_rounded = co_5
          + (ksl_product_rest(D->m02, D->m13, co_5a, co_5 + co_5_right)
          - ksl_product_rest(D->m12, D->m03, co_5b, co_5_right));
  co->m0 = co_0;
  co->m1 = co_1;
  co->m2 = co_2;
  co->m3 = co_3_rounded;
  co->m4 = co_4_rounded;
  co->m5 = co_5_rounded;
}

/* M = [Ad]*(D).
   D: displacement [R | t], R rotation, t in m; M: 6×6 operator.
   18 mul, 45 add, 18 product rest.
   Error <= u |result| + 6 u^2 S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_CoAd_accurate(const ksl_SE3_t *D, ksl_mat6x6_t *M) {
  const double M_30a = KSL_MUL(D->m20, D->m13), M_30b = KSL_MUL(D->m10, D->m23),
      M_30 = M_30a - M_30b, M_30_right = M_30a - M_30;
  const double M_31a = KSL_MUL(D->m21, D->m13), M_31b = KSL_MUL(D->m11, D->m23),
      M_31 = M_31a - M_31b, M_31_right = M_31a - M_31;
  const double M_32a = KSL_MUL(D->m22, D->m13), M_32b = KSL_MUL(D->m12, D->m23),
      M_32 = M_32a - M_32b, M_32_right = M_32a - M_32;
  const double M_40a = KSL_MUL(D->m00, D->m23), M_40b = KSL_MUL(D->m20, D->m03),
      M_40 = M_40a - M_40b, M_40_right = M_40a - M_40;
  const double M_41a = KSL_MUL(D->m01, D->m23), M_41b = KSL_MUL(D->m21, D->m03),
      M_41 = M_41a - M_41b, M_41_right = M_41a - M_41;
  const double M_42a = KSL_MUL(D->m02, D->m23), M_42b = KSL_MUL(D->m22, D->m03),
      M_42 = M_42a - M_42b, M_42_right = M_42a - M_42;
  const double M_50a = KSL_MUL(D->m10, D->m03), M_50b = KSL_MUL(D->m00, D->m13),
      M_50 = M_50a - M_50b, M_50_right = M_50a - M_50;
  const double M_51a = KSL_MUL(D->m11, D->m03), M_51b = KSL_MUL(D->m01, D->m13),
      M_51 = M_51a - M_51b, M_51_right = M_51a - M_51;
  const double M_52a = KSL_MUL(D->m12, D->m03), M_52b = KSL_MUL(D->m02, D->m13),
      M_52 = M_52a - M_52b, M_52_right = M_52a - M_52;
  const double M_30_rounded = M_30
          + (ksl_product_rest(D->m20, D->m13, M_30a, M_30 + M_30_right)
          - ksl_product_rest(D->m10, D->m23, M_30b, M_30_right)),
      M_31_rounded = M_31
          + (ksl_product_rest(D->m21, D->m13, M_31a, M_31 + M_31_right)
          - ksl_product_rest(D->m11, D->m23, M_31b, M_31_right)),
      M_32_rounded = M_32
          + (ksl_product_rest(D->m22, D->m13, M_32a, M_32 + M_32_right)
          - ksl_product_rest(D->m12, D->m23, M_32b, M_32_right)),
      M_40_rounded = M_40
          + (ksl_product_rest(D->m00, D->m23, M_40a, M_40 + M_40_right)
          - ksl_product_rest(D->m20, D->m03, M_40b, M_40_right)),
      M_41_rounded = M_41
          + (ksl_product_rest(D->m01, D->m23, M_41a, M_41 + M_41_right)
          - ksl_product_rest(D->m21, D->m03, M_41b, M_41_right)),
      M_42_rounded = M_42
          + (ksl_product_rest(D->m02, D->m23, M_42a, M_42 + M_42_right)
          - ksl_product_rest(D->m22, D->m03, M_42b, M_42_right)),
      M_50_rounded = M_50
          + (ksl_product_rest(D->m10, D->m03, M_50a, M_50 + M_50_right)
          - ksl_product_rest(D->m00, D->m13, M_50b, M_50_right)),
      M_51_rounded = M_51
          + (ksl_product_rest(D->m11, D->m03, M_51a, M_51 + M_51_right)
          - ksl_product_rest(D->m01, D->m13, M_51b, M_51_right)),
      M_52_rounded = M_52
          + (ksl_product_rest(D->m12, D->m03, M_52a, M_52 + M_52_right)
          - ksl_product_rest(D->m02, D->m13, M_52b, M_52_right));
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
  M->at[0][3] = M_30_rounded;
  M->at[1][3] = M_31_rounded;
  M->at[2][3] = M_32_rounded;
  M->at[3][3] = D_m00;
  M->at[4][3] = D_m01;
  M->at[5][3] = D_m02;
  M->at[0][4] = M_40_rounded;
  M->at[1][4] = M_41_rounded;
  M->at[2][4] = M_42_rounded;
  M->at[3][4] = D_m10;
  M->at[4][4] = D_m11;
  M->at[5][4] = D_m12;
  M->at[0][5] = M_50_rounded;
  M->at[1][5] = M_51_rounded;
  M->at[2][5] = M_52_rounded;
  M->at[3][5] = D_m20;
  M->at[4][5] = D_m21;
  M->at[5][5] = D_m22;
}

/* power = W ⊙ $ = f·v + τ·ω, W = c = (f; τ), $ = x = (ω; v).
   c: coscrew (f in N; τ in N m); x: six components with the angular part on top.
   6 mul, 29 add, 6 product rest.
   Error <= u |result| + 19 u^2 S, S the sum of the |terms| of the expanded formula; barring
     over- and underflow. */
static inline double ksl_reciprocal_product_accurate(const ksl_coscrew_t *c, const double x[6]) {
  const double power_a = KSL_MUL(c->m0, x[3]), power_b = KSL_MUL(c->m1, x[4]),
      power_c = power_a + power_b, power_c_right = power_c - power_a,
      power_d = KSL_MUL(c->m2, x[5]), power_e = power_c + power_d,
      power_e_right = power_e - power_c,
      power_c_lo = ksl_product_rest(c->m0, x[3], power_a, power_c - power_c_right)
          + ksl_product_rest(c->m1, x[4], power_b, power_c_right), power_f = KSL_MUL(c->m3, x[0]),
      power_g = KSL_MUL(c->m4, x[1]), power_h = power_f + power_g,
      power_h_right = power_h - power_f, power_i = KSL_MUL(c->m5, x[2]),
      power_j = power_h + power_i, power_j_right = power_j - power_h,
      power_h_lo = ksl_product_rest(c->m3, x[0], power_f, power_h - power_h_right)
          + ksl_product_rest(c->m4, x[1], power_g, power_h_right), power = power_e + power_j,
      power_right = power - power_e,
      power_j_lo = power_h - (power_j - power_j_right)
          + ksl_product_rest(c->m5, x[2], power_i, power_j_right) + power_h_lo,
      power_e_lo = power_c - (power_e - power_e_right)
          + ksl_product_rest(c->m2, x[5], power_d, power_e_right) + power_c_lo;
  const double power_rounded = power
          + (power_e - (power - power_right) + (power_j - power_right) + power_j_lo + power_e_lo);
  return power_rounded;
}

/* co = [ad]*(s) c = (ω×f ; v×f + ω×τ).
   s: screw (v in m/s; ω in rad/s); c, co: coscrew (f in N; τ in N m).
   18 mul, 66 add, 18 product rest.
   Error <= u |result| + (lin: 6, ang: 12) u^2 S, S the sum of the |terms| of the expanded
     formula; barring over- and underflow. */
static inline void ksl_cross_sc_accurate(const ksl_screw_t *s, const ksl_coscrew_t *c,
    ksl_coscrew_t *co) {
  const double co_0a = KSL_MUL(s->m4, c->m2), co_0b = KSL_MUL(s->m5, c->m1), co_0 = co_0a - co_0b,
      co_0_right = co_0a - co_0;
  const double co_1a = KSL_MUL(s->m5, c->m0), co_1b = KSL_MUL(s->m3, c->m2), co_1 = co_1a - co_1b,
      co_1_right = co_1a - co_1;
  const double co_2a = KSL_MUL(s->m3, c->m1), co_2b = KSL_MUL(s->m4, c->m0), co_2 = co_2a - co_2b,
      co_2_right = co_2a - co_2;
  const double co_3a = KSL_MUL(s->m1, c->m2), co_3b = KSL_MUL(s->m2, c->m1), co_3c = co_3a - co_3b,
      co_3c_right = co_3a - co_3c, co_3d = KSL_MUL(s->m4, c->m5), co_3e = KSL_MUL(s->m5, c->m4),
      co_3f = co_3d - co_3e, co_3f_right = co_3d - co_3f, co_3 = co_3c + co_3f,
      co_3_right = co_3 - co_3c,
      co_3f_lo = ksl_product_rest(s->m4, c->m5, co_3d, co_3f + co_3f_right)
          - ksl_product_rest(s->m5, c->m4, co_3e, co_3f_right),
      co_3c_lo = ksl_product_rest(s->m1, c->m2, co_3a, co_3c + co_3c_right)
          - ksl_product_rest(s->m2, c->m1, co_3b, co_3c_right);
  const double co_4a = KSL_MUL(s->m2, c->m0), co_4b = KSL_MUL(s->m0, c->m2), co_4c = co_4a - co_4b,
      co_4c_right = co_4a - co_4c, co_4d = KSL_MUL(s->m5, c->m3), co_4e = KSL_MUL(s->m3, c->m5),
      co_4f = co_4d - co_4e, co_4f_right = co_4d - co_4f, co_4 = co_4c + co_4f,
      co_4_right = co_4 - co_4c,
      co_4f_lo = ksl_product_rest(s->m5, c->m3, co_4d, co_4f + co_4f_right)
          - ksl_product_rest(s->m3, c->m5, co_4e, co_4f_right),
      co_4c_lo = ksl_product_rest(s->m2, c->m0, co_4a, co_4c + co_4c_right)
          - ksl_product_rest(s->m0, c->m2, co_4b, co_4c_right);
  const double co_5a = KSL_MUL(s->m0, c->m1), co_5b = KSL_MUL(s->m1, c->m0), co_5c = co_5a - co_5b,
      co_5c_right = co_5a - co_5c, co_5d = KSL_MUL(s->m3, c->m4), co_5e = KSL_MUL(s->m4, c->m3),
      co_5f = co_5d - co_5e, co_5f_right = co_5d - co_5f, co_5 = co_5c + co_5f,
      co_5_right = co_5 - co_5c,
      co_5f_lo = ksl_product_rest(s->m3, c->m4, co_5d, co_5f + co_5f_right)
          - ksl_product_rest(s->m4, c->m3, co_5e, co_5f_right),
      co_5c_lo = ksl_product_rest(s->m0, c->m1, co_5a, co_5c + co_5c_right)
          - ksl_product_rest(s->m1, c->m0, co_5b, co_5c_right);
  const double co_0_rounded = co_0
          + (ksl_product_rest(s->m4, c->m2, co_0a, co_0 + co_0_right)
          - ksl_product_rest(s->m5, c->m1, co_0b, co_0_right)),
      co_1_rounded = co_1
          + (ksl_product_rest(s->m5, c->m0, co_1a, co_1 + co_1_right)
          - ksl_product_rest(s->m3, c->m2, co_1b, co_1_right)),
      co_2_rounded = co_2
          + (ksl_product_rest(s->m3, c->m1, co_2a, co_2 + co_2_right)
          - ksl_product_rest(s->m4, c->m0, co_2b, co_2_right)),
      co_3_rounded = co_3
          + (co_3c - (co_3 - co_3_right) + (co_3f - co_3_right) + co_3f_lo + co_3c_lo),
      co_4_rounded = co_4
          + (co_4c - (co_4 - co_4_right) + (co_4f - co_4_right) + co_4f_lo + co_4c_lo),
      co_5_rounded = co_5
          + (co_5c - (co_5 - co_5_right) + (co_5f - co_5_right) + co_5f_lo + co_5c_lo);
  co->m0 = co_0_rounded;
  co->m1 = co_1_rounded;
  co->m2 = co_2_rounded;
  co->m3 = co_3_rounded;
  co->m4 = co_4_rounded;
  co->m5 = co_5_rounded;
}

/* co = (0 ; ω×τ).
   s: screw (v in m/s; ω in rad/s); c, co: coscrew (f in N; τ in N m).
   6 mul, 15 add, 6 product rest.
   Error <= u |result| + (lin: 0, ang: 6) u^2 S, S the sum of the |terms| of the expanded
     formula; barring over- and underflow. */
static inline void ksl_cross_sca_accurate(const ksl_screw_t *s, const ksl_coscrew_t *c,
    ksl_coscrew_t *co) {
  const double co_3a = KSL_MUL(s->m4, c->m5), co_3b = KSL_MUL(s->m5, c->m4), co_3 = co_3a - co_3b,
      co_3_right = co_3a - co_3;
  const double co_4a = KSL_MUL(s->m5, c->m3), co_4b = KSL_MUL(s->m3, c->m5), co_4 = co_4a - co_4b,
      co_4_right = co_4a - co_4;
  const double co_5a = KSL_MUL(s->m3, c->m4), co_5b = KSL_MUL(s->m4, c->m3), co_5 = co_5a - co_5b,
      co_5_right = co_5a - co_5;
  const double co_3_rounded = co_3
          + (ksl_product_rest(s->m4, c->m5, co_3a, co_3 + co_3_right)
          - ksl_product_rest(s->m5, c->m4, co_3b, co_3_right)),
      co_4_rounded = co_4
          + (ksl_product_rest(s->m5, c->m3, co_4a, co_4 + co_4_right)
          - ksl_product_rest(s->m3, c->m5, co_4b, co_4_right)),
      co_5_rounded = co_5
          + (ksl_product_rest(s->m3, c->m4, co_5a, co_5 + co_5_right)
          - ksl_product_rest(s->m4, c->m3, co_5b, co_5_right));
  co->m0 = 0.0;
  co->m1 = 0.0;
  co->m2 = 0.0;
  co->m3 = co_3_rounded;
  co->m4 = co_4_rounded;
  co->m5 = co_5_rounded;
}

/* co = H̄* c = [Ad]*(D) P c; P clears component 0 of c, given in the frame of a tx joint at D.
   D: displacement [R | t], R rotation, t in m; c, co: coscrew (f in N; τ in N m).
   27 mul, 90 add, 21 product rest.
   Error <= u |result| + (lin: 6, ang: 26) u^2 S, S the sum of the |terms| of the expanded
     formula; barring over- and underflow. */
static inline void ksl_constraint_ctx_accurate(const ksl_SE3_t *D, const ksl_coscrew_t *c,
    ksl_coscrew_t *co) {
  const double w_0a = KSL_MUL(D->m01, c->m1), w_0b = KSL_MUL(D->m02, c->m2), w_0 = w_0a + w_0b,
      w_0_right = w_0 - w_0a,
      w_0_lo = ksl_product_rest(D->m01, c->m1, w_0a, w_0 - w_0_right)
          + ksl_product_rest(D->m02, c->m2, w_0b, w_0_right);
  const double w_1a = KSL_MUL(D->m11, c->m1), w_1b = KSL_MUL(D->m12, c->m2), w_1 = w_1a + w_1b,
      w_1_right = w_1 - w_1a,
      w_1_lo = ksl_product_rest(D->m11, c->m1, w_1a, w_1 - w_1_right)
          + ksl_product_rest(D->m12, c->m2, w_1b, w_1_right);
  const double w_2a = KSL_MUL(D->m21, c->m1), w_2b = KSL_MUL(D->m22, c->m2), w_2 = w_2a + w_2b,
      w_2_right = w_2 - w_2a,
      w_2_lo = ksl_product_rest(D->m21, c->m1, w_2a, w_2 - w_2_right)
          + ksl_product_rest(D->m22, c->m2, w_2b, w_2_right);
  const double w_3a = KSL_MUL(D->m00, c->m3), w_3b = KSL_MUL(D->m01, c->m4), w_3c = w_3a + w_3b,
      w_3c_right = w_3c - w_3a, w_3d = KSL_MUL(D->m02, c->m5), w_3 = w_3c + w_3d,
      w_3_right = w_3 - w_3c,
      w_3c_lo = ksl_product_rest(D->m00, c->m3, w_3a, w_3c - w_3c_right)
          + ksl_product_rest(D->m01, c->m4, w_3b, w_3c_right);
  const double w_4a = KSL_MUL(D->m10, c->m3), w_4b = KSL_MUL(D->m11, c->m4), w_4c = w_4a + w_4b,
      w_4c_right = w_4c - w_4a, w_4d = KSL_MUL(D->m12, c->m5), w_4 = w_4c + w_4d,
      w_4_right = w_4 - w_4c,
      w_4c_lo = ksl_product_rest(D->m10, c->m3, w_4a, w_4c - w_4c_right)
          + ksl_product_rest(D->m11, c->m4, w_4b, w_4c_right);
  const double w_5a = KSL_MUL(D->m20, c->m3), w_5b = KSL_MUL(D->m21, c->m4), w_5c = w_5a + w_5b,
      w_5c_right = w_5c - w_5a, w_5d = KSL_MUL(D->m22, c->m5), w_5 = w_5c + w_5d,
      w_5_right = w_5 - w_5c,
      w_5c_lo = ksl_product_rest(D->m20, c->m3, w_5a, w_5c - w_5c_right)
          + ksl_product_rest(D->m21, c->m4, w_5b, w_5c_right);
  const double co_3a = KSL_MUL(D->m13, w_2), co_3b = KSL_MUL(D->m23, w_1), co_3c = co_3a - co_3b,
      co_3c_right = co_3a - co_3c,
      co_3c_lo1 = ksl_product_rest(D->m13, w_2, co_3a, co_3c + co_3c_right)
          - ksl_product_rest(D->m23, w_1, co_3b, co_3c_right), co_3 = co_3c + w_3,
      co_3_right = co_3 - co_3c,
      co_3_lo2 = co_3c - (co_3 - co_3_right) + (w_3 - co_3_right)
          + (w_3c - (w_3 - w_3_right) + ksl_product_rest(D->m02, c->m5, w_3d, w_3_right) + w_3c_lo);
  const double co_4a = KSL_MUL(D->m23, w_0), co_4b = KSL_MUL(D->m03, w_2), co_4c = co_4a - co_4b,
      co_4c_right = co_4a - co_4c,
      co_4c_lo1 = ksl_product_rest(D->m23, w_0, co_4a, co_4c + co_4c_right)
          - ksl_product_rest(D->m03, w_2, co_4b, co_4c_right), co_4 = co_4c + w_4,
      co_4_right = co_4 - co_4c,
      co_4_lo2 = co_4c - (co_4 - co_4_right) + (w_4 - co_4_right)
          + (w_4c - (w_4 - w_4_right) + ksl_product_rest(D->m12, c->m5, w_4d, w_4_right) + w_4c_lo);
  const double co_5a = KSL_MUL(D->m03, w_1), co_5b = KSL_MUL(D->m13, w_0), co_5c = co_5a - co_5b,
      co_5c_right = co_5a - co_5c,
      co_5c_lo1 = ksl_product_rest(D->m03, w_1, co_5a, co_5c + co_5c_right)
          - ksl_product_rest(D->m13, w_0, co_5b, co_5c_right), co_5 = co_5c + w_5,
      co_5_right = co_5 - co_5c,
      co_5_lo2 = co_5c - (co_5 - co_5_right) + (w_5 - co_5_right)
          + (w_5c - (w_5 - w_5_right) + ksl_product_rest(D->m22, c->m5, w_5d, w_5_right) + w_5c_lo);
  const double w_0_rounded = w_0 + w_0_lo, w_1_rounded = w_1 + w_1_lo, w_2_rounded = w_2 + w_2_lo;
  const double co_3_rounded = co_3
          + (co_3_lo2 + (co_3c_lo1 + (KSL_MUL(D->m13, w_2_lo) - KSL_MUL(D->m23, w_1_lo)))),
      co_4_rounded = co_4
          + (co_4_lo2 + (co_4c_lo1 + (KSL_MUL(D->m23, w_0_lo) - KSL_MUL(D->m03, w_2_lo)))),
      co_5_rounded = co_5
          + (co_5_lo2 + (co_5c_lo1 + (KSL_MUL(D->m03, w_1_lo) - KSL_MUL(D->m13, w_0_lo))));
  co->m0 = w_0_rounded;
  co->m1 = w_1_rounded;
  co->m2 = w_2_rounded;
  co->m3 = co_3_rounded;
  co->m4 = co_4_rounded;
  co->m5 = co_5_rounded;
}

/* co = H̄* c = [Ad]*(D) P c; P clears component 1 of c, given in the frame of a ty joint at D.
   D: displacement [R | t], R rotation, t in m; c, co: coscrew (f in N; τ in N m).
   27 mul, 90 add, 21 product rest.
   Error <= u |result| + (lin: 6, ang: 26) u^2 S, S the sum of the |terms| of the expanded
     formula; barring over- and underflow. */
static inline void ksl_constraint_cty_accurate(const ksl_SE3_t *D, const ksl_coscrew_t *c,
    ksl_coscrew_t *co) {
  const double w_0a = KSL_MUL(D->m00, c->m0), w_0b = KSL_MUL(D->m02, c->m2), w_0 = w_0a + w_0b,
      w_0_right = w_0 - w_0a,
      w_0_lo = ksl_product_rest(D->m00, c->m0, w_0a, w_0 - w_0_right)
          + ksl_product_rest(D->m02, c->m2, w_0b, w_0_right);
  const double w_1a = KSL_MUL(D->m10, c->m0), w_1b = KSL_MUL(D->m12, c->m2), w_1 = w_1a + w_1b,
      w_1_right = w_1 - w_1a,
      w_1_lo = ksl_product_rest(D->m10, c->m0, w_1a, w_1 - w_1_right)
          + ksl_product_rest(D->m12, c->m2, w_1b, w_1_right);
  const double w_2a = KSL_MUL(D->m20, c->m0), w_2b = KSL_MUL(D->m22, c->m2), w_2 = w_2a + w_2b,
      w_2_right = w_2 - w_2a,
      w_2_lo = ksl_product_rest(D->m20, c->m0, w_2a, w_2 - w_2_right)
          + ksl_product_rest(D->m22, c->m2, w_2b, w_2_right);
  const double w_3a = KSL_MUL(D->m00, c->m3), w_3b = KSL_MUL(D->m01, c->m4), w_3c = w_3a + w_3b,
      w_3c_right = w_3c - w_3a, w_3d = KSL_MUL(D->m02, c->m5), w_3 = w_3c + w_3d,
      w_3_right = w_3 - w_3c,
      w_3c_lo = ksl_product_rest(D->m00, c->m3, w_3a, w_3c - w_3c_right)
          + ksl_product_rest(D->m01, c->m4, w_3b, w_3c_right);
  const double w_4a = KSL_MUL(D->m10, c->m3), w_4b = KSL_MUL(D->m11, c->m4), w_4c = w_4a + w_4b,
      w_4c_right = w_4c - w_4a, w_4d = KSL_MUL(D->m12, c->m5), w_4 = w_4c + w_4d,
      w_4_right = w_4 - w_4c,
      w_4c_lo = ksl_product_rest(D->m10, c->m3, w_4a, w_4c - w_4c_right)
          + ksl_product_rest(D->m11, c->m4, w_4b, w_4c_right);
  const double w_5a = KSL_MUL(D->m20, c->m3), w_5b = KSL_MUL(D->m21, c->m4), w_5c = w_5a + w_5b,
      w_5c_right = w_5c - w_5a, w_5d = KSL_MUL(D->m22, c->m5), w_5 = w_5c + w_5d,
      w_5_right = w_5 - w_5c,
      w_5c_lo = ksl_product_rest(D->m20, c->m3, w_5a, w_5c - w_5c_right)
          + ksl_product_rest(D->m21, c->m4, w_5b, w_5c_right);
  const double co_3a = KSL_MUL(D->m13, w_2), co_3b = KSL_MUL(D->m23, w_1), co_3c = co_3a - co_3b,
      co_3c_right = co_3a - co_3c,
      co_3c_lo1 = ksl_product_rest(D->m13, w_2, co_3a, co_3c + co_3c_right)
          - ksl_product_rest(D->m23, w_1, co_3b, co_3c_right), co_3 = co_3c + w_3,
      co_3_right = co_3 - co_3c,
      co_3_lo2 = co_3c - (co_3 - co_3_right) + (w_3 - co_3_right)
          + (w_3c - (w_3 - w_3_right) + ksl_product_rest(D->m02, c->m5, w_3d, w_3_right) + w_3c_lo);
  const double co_4a = KSL_MUL(D->m23, w_0), co_4b = KSL_MUL(D->m03, w_2), co_4c = co_4a - co_4b,
      co_4c_right = co_4a - co_4c,
      co_4c_lo1 = ksl_product_rest(D->m23, w_0, co_4a, co_4c + co_4c_right)
          - ksl_product_rest(D->m03, w_2, co_4b, co_4c_right), co_4 = co_4c + w_4,
      co_4_right = co_4 - co_4c,
      co_4_lo2 = co_4c - (co_4 - co_4_right) + (w_4 - co_4_right)
          + (w_4c - (w_4 - w_4_right) + ksl_product_rest(D->m12, c->m5, w_4d, w_4_right) + w_4c_lo);
  const double co_5a = KSL_MUL(D->m03, w_1), co_5b = KSL_MUL(D->m13, w_0), co_5c = co_5a - co_5b,
      co_5c_right = co_5a - co_5c,
      co_5c_lo1 = ksl_product_rest(D->m03, w_1, co_5a, co_5c + co_5c_right)
          - ksl_product_rest(D->m13, w_0, co_5b, co_5c_right), co_5 = co_5c + w_5,
      co_5_right = co_5 - co_5c,
      co_5_lo2 = co_5c - (co_5 - co_5_right) + (w_5 - co_5_right)
          + (w_5c - (w_5 - w_5_right) + ksl_product_rest(D->m22, c->m5, w_5d, w_5_right) + w_5c_lo);
  const double w_0_rounded = w_0 + w_0_lo, w_1_rounded = w_1 + w_1_lo, w_2_rounded = w_2 + w_2_lo;
  const double co_3_rounded = co_3
          + (co_3_lo2 + (co_3c_lo1 + (KSL_MUL(D->m13, w_2_lo) - KSL_MUL(D->m23, w_1_lo)))),
      co_4_rounded = co_4
          + (co_4_lo2 + (co_4c_lo1 + (KSL_MUL(D->m23, w_0_lo) - KSL_MUL(D->m03, w_2_lo)))),
      co_5_rounded = co_5
          + (co_5_lo2 + (co_5c_lo1 + (KSL_MUL(D->m03, w_1_lo) - KSL_MUL(D->m13, w_0_lo))));
  co->m0 = w_0_rounded;
  co->m1 = w_1_rounded;
  co->m2 = w_2_rounded;
  co->m3 = co_3_rounded;
  co->m4 = co_4_rounded;
  co->m5 = co_5_rounded;
}

/* co = H̄* c = [Ad]*(D) P c; P clears component 2 of c, given in the frame of a tz joint at D.
   D: displacement [R | t], R rotation, t in m; c, co: coscrew (f in N; τ in N m).
   27 mul, 90 add, 21 product rest.
   Error <= u |result| + (lin: 6, ang: 26) u^2 S, S the sum of the |terms| of the expanded
     formula; barring over- and underflow. */
static inline void ksl_constraint_ctz_accurate(const ksl_SE3_t *D, const ksl_coscrew_t *c,
    ksl_coscrew_t *co) {
  const double w_0a = KSL_MUL(D->m00, c->m0), w_0b = KSL_MUL(D->m01, c->m1), w_0 = w_0a + w_0b,
      w_0_right = w_0 - w_0a,
      w_0_lo = ksl_product_rest(D->m00, c->m0, w_0a, w_0 - w_0_right)
          + ksl_product_rest(D->m01, c->m1, w_0b, w_0_right);
  const double w_1a = KSL_MUL(D->m10, c->m0), w_1b = KSL_MUL(D->m11, c->m1), w_1 = w_1a + w_1b,
      w_1_right = w_1 - w_1a,
      w_1_lo = ksl_product_rest(D->m10, c->m0, w_1a, w_1 - w_1_right)
          + ksl_product_rest(D->m11, c->m1, w_1b, w_1_right);
  const double w_2a = KSL_MUL(D->m20, c->m0), w_2b = KSL_MUL(D->m21, c->m1), w_2 = w_2a + w_2b,
      w_2_right = w_2 - w_2a,
      w_2_lo = ksl_product_rest(D->m20, c->m0, w_2a, w_2 - w_2_right)
          + ksl_product_rest(D->m21, c->m1, w_2b, w_2_right);
  const double w_3a = KSL_MUL(D->m00, c->m3), w_3b = KSL_MUL(D->m01, c->m4), w_3c = w_3a + w_3b,
      w_3c_right = w_3c - w_3a, w_3d = KSL_MUL(D->m02, c->m5), w_3 = w_3c + w_3d,
      w_3_right = w_3 - w_3c,
      w_3c_lo = ksl_product_rest(D->m00, c->m3, w_3a, w_3c - w_3c_right)
          + ksl_product_rest(D->m01, c->m4, w_3b, w_3c_right);
  const double w_4a = KSL_MUL(D->m10, c->m3), w_4b = KSL_MUL(D->m11, c->m4), w_4c = w_4a + w_4b,
      w_4c_right = w_4c - w_4a, w_4d = KSL_MUL(D->m12, c->m5), w_4 = w_4c + w_4d,
      w_4_right = w_4 - w_4c,
      w_4c_lo = ksl_product_rest(D->m10, c->m3, w_4a, w_4c - w_4c_right)
          + ksl_product_rest(D->m11, c->m4, w_4b, w_4c_right);
  const double w_5a = KSL_MUL(D->m20, c->m3), w_5b = KSL_MUL(D->m21, c->m4), w_5c = w_5a + w_5b,
      w_5c_right = w_5c - w_5a, w_5d = KSL_MUL(D->m22, c->m5), w_5 = w_5c + w_5d,
      w_5_right = w_5 - w_5c,
      w_5c_lo = ksl_product_rest(D->m20, c->m3, w_5a, w_5c - w_5c_right)
          + ksl_product_rest(D->m21, c->m4, w_5b, w_5c_right);
  const double co_3a = KSL_MUL(D->m13, w_2), co_3b = KSL_MUL(D->m23, w_1), co_3c = co_3a - co_3b,
      co_3c_right = co_3a - co_3c,
      co_3c_lo1 = ksl_product_rest(D->m13, w_2, co_3a, co_3c + co_3c_right)
          - ksl_product_rest(D->m23, w_1, co_3b, co_3c_right), co_3 = co_3c + w_3,
      co_3_right = co_3 - co_3c,
      co_3_lo2 = co_3c - (co_3 - co_3_right) + (w_3 - co_3_right)
          + (w_3c - (w_3 - w_3_right) + ksl_product_rest(D->m02, c->m5, w_3d, w_3_right) + w_3c_lo);
  const double co_4a = KSL_MUL(D->m23, w_0), co_4b = KSL_MUL(D->m03, w_2), co_4c = co_4a - co_4b,
      co_4c_right = co_4a - co_4c,
      co_4c_lo1 = ksl_product_rest(D->m23, w_0, co_4a, co_4c + co_4c_right)
          - ksl_product_rest(D->m03, w_2, co_4b, co_4c_right), co_4 = co_4c + w_4,
      co_4_right = co_4 - co_4c,
      co_4_lo2 = co_4c - (co_4 - co_4_right) + (w_4 - co_4_right)
          + (w_4c - (w_4 - w_4_right) + ksl_product_rest(D->m12, c->m5, w_4d, w_4_right) + w_4c_lo);
  const double co_5a = KSL_MUL(D->m03, w_1), co_5b = KSL_MUL(D->m13, w_0), co_5c = co_5a - co_5b,
      co_5c_right = co_5a - co_5c,
      co_5c_lo1 = ksl_product_rest(D->m03, w_1, co_5a, co_5c + co_5c_right)
          - ksl_product_rest(D->m13, w_0, co_5b, co_5c_right), co_5 = co_5c + w_5,
      co_5_right = co_5 - co_5c,
      co_5_lo2 = co_5c - (co_5 - co_5_right) + (w_5 - co_5_right)
          + (w_5c - (w_5 - w_5_right) + ksl_product_rest(D->m22, c->m5, w_5d, w_5_right) + w_5c_lo);
  const double w_0_rounded = w_0 + w_0_lo, w_1_rounded = w_1 + w_1_lo, w_2_rounded = w_2 + w_2_lo;
  const double co_3_rounded = co_3
          + (co_3_lo2 + (co_3c_lo1 + (KSL_MUL(D->m13, w_2_lo) - KSL_MUL(D->m23, w_1_lo)))),
      co_4_rounded = co_4
          + (co_4_lo2 + (co_4c_lo1 + (KSL_MUL(D->m23, w_0_lo) - KSL_MUL(D->m03, w_2_lo)))),
      co_5_rounded = co_5
          + (co_5_lo2 + (co_5c_lo1 + (KSL_MUL(D->m03, w_1_lo) - KSL_MUL(D->m13, w_0_lo))));
  co->m0 = w_0_rounded;
  co->m1 = w_1_rounded;
  co->m2 = w_2_rounded;
  co->m3 = co_3_rounded;
  co->m4 = co_4_rounded;
  co->m5 = co_5_rounded;
}

/* co = H̄* c = [Ad]*(D) P c; P clears component 3 of c, given in the frame of a rx joint at D.
   D: displacement [R | t], R rotation, t in m; c, co: coscrew (f in N; τ in N m).
   27 mul, 90 add, 21 product rest.
   Error <= u |result| + (lin: 11, ang: 35) u^2 S, S the sum of the |terms| of the expanded
     formula; barring over- and underflow. */
static inline void ksl_constraint_crx_accurate(const ksl_SE3_t *D, const ksl_coscrew_t *c,
    ksl_coscrew_t *co) {
  const double w_0a = KSL_MUL(D->m00, c->m0), w_0b = KSL_MUL(D->m01, c->m1), w_0c = w_0a + w_0b,
      w_0c_right = w_0c - w_0a, w_0d = KSL_MUL(D->m02, c->m2), w_0 = w_0c + w_0d,
      w_0_right = w_0 - w_0c,
      w_0c_lo = ksl_product_rest(D->m00, c->m0, w_0a, w_0c - w_0c_right)
          + ksl_product_rest(D->m01, c->m1, w_0b, w_0c_right),
      w_0_lo = w_0c - (w_0 - w_0_right) + ksl_product_rest(D->m02, c->m2, w_0d, w_0_right)
          + w_0c_lo;
  const double w_1a = KSL_MUL(D->m10, c->m0), w_1b = KSL_MUL(D->m11, c->m1), w_1c = w_1a + w_1b,
      w_1c_right = w_1c - w_1a, w_1d = KSL_MUL(D->m12, c->m2), w_1 = w_1c + w_1d,
      w_1_right = w_1 - w_1c,
      w_1c_lo = ksl_product_rest(D->m10, c->m0, w_1a, w_1c - w_1c_right)
          + ksl_product_rest(D->m11, c->m1, w_1b, w_1c_right),
      w_1_lo = w_1c - (w_1 - w_1_right) + ksl_product_rest(D->m12, c->m2, w_1d, w_1_right)
          + w_1c_lo;
  const double w_2a = KSL_MUL(D->m20, c->m0), w_2b = KSL_MUL(D->m21, c->m1), w_2c = w_2a + w_2b,
      w_2c_right = w_2c - w_2a, w_2d = KSL_MUL(D->m22, c->m2), w_2 = w_2c + w_2d,
      w_2_right = w_2 - w_2c,
      w_2c_lo = ksl_product_rest(D->m20, c->m0, w_2a, w_2c - w_2c_right)
          + ksl_product_rest(D->m21, c->m1, w_2b, w_2c_right),
      w_2_lo = w_2c - (w_2 - w_2_right) + ksl_product_rest(D->m22, c->m2, w_2d, w_2_right)
          + w_2c_lo;
  const double w_3a = KSL_MUL(D->m01, c->m4), w_3b = KSL_MUL(D->m02, c->m5), w_3 = w_3a + w_3b,
      w_3_right = w_3 - w_3a;
  const double w_4a = KSL_MUL(D->m11, c->m4), w_4b = KSL_MUL(D->m12, c->m5), w_4 = w_4a + w_4b,
      w_4_right = w_4 - w_4a;
  const double w_5a = KSL_MUL(D->m21, c->m4), w_5b = KSL_MUL(D->m22, c->m5), w_5 = w_5a + w_5b,
      w_5_right = w_5 - w_5a;
  const double co_3a = KSL_MUL(D->m13, w_2), co_3b = KSL_MUL(D->m23, w_1), co_3c = co_3a - co_3b,
      co_3c_right = co_3a - co_3c,
      co_3c_lo1 = ksl_product_rest(D->m13, w_2, co_3a, co_3c + co_3c_right)
          - ksl_product_rest(D->m23, w_1, co_3b, co_3c_right), co_3 = co_3c + w_3,
      co_3_right = co_3 - co_3c;
  const double w_3_lo = ksl_product_rest(D->m01, c->m4, w_3a, w_3 - w_3_right)
          + ksl_product_rest(D->m02, c->m5, w_3b, w_3_right);
  const double co_4a = KSL_MUL(D->m23, w_0), co_4b = KSL_MUL(D->m03, w_2), co_4c = co_4a - co_4b,
      co_4c_right = co_4a - co_4c,
      co_4c_lo1 = ksl_product_rest(D->m23, w_0, co_4a, co_4c + co_4c_right)
          - ksl_product_rest(D->m03, w_2, co_4b, co_4c_right), co_4 = co_4c + w_4,
      co_4_right = co_4 - co_4c;
  const double w_4_lo = ksl_product_rest(D->m11, c->m4, w_4a, w_4 - w_4_right)
          + ksl_product_rest(D->m12, c->m5, w_4b, w_4_right);
  const double co_5a = KSL_MUL(D->m03, w_1), co_5b = KSL_MUL(D->m13, w_0), co_5c = co_5a - co_5b,
      co_5c_right = co_5a - co_5c,
      co_5c_lo1 = ksl_product_rest(D->m03, w_1, co_5a, co_5c + co_5c_right)
          - ksl_product_rest(D->m13, w_0, co_5b, co_5c_right), co_5 = co_5c + w_5,
      co_5_right = co_5 - co_5c;
  const double w_5_lo = ksl_product_rest(D->m21, c->m4, w_5a, w_5 - w_5_right)
          + ksl_product_rest(D->m22, c->m5, w_5b, w_5_right);
  const double w_0_rounded = w_0 + w_0_lo, w_1_rounded = w_1 + w_1_lo, w_2_rounded = w_2 + w_2_lo;
  const double co_3_rounded = co_3
          + (co_3c - (co_3 - co_3_right) + (w_3 - co_3_right) + w_3_lo
          + (co_3c_lo1 + (KSL_MUL(D->m13, w_2_lo) - KSL_MUL(D->m23, w_1_lo)))),
      co_4_rounded = co_4
          + (co_4c - (co_4 - co_4_right) + (w_4 - co_4_right) + w_4_lo
          + (co_4c_lo1 + (KSL_MUL(D->m23, w_0_lo) - KSL_MUL(D->m03, w_2_lo)))),
      co_5_rounded = co_5
          + (co_5c - (co_5 - co_5_right) + (w_5 - co_5_right) + w_5_lo
          + (co_5c_lo1 + (KSL_MUL(D->m03, w_1_lo) - KSL_MUL(D->m13, w_0_lo))));
  co->m0 = w_0_rounded;
  co->m1 = w_1_rounded;
  co->m2 = w_2_rounded;
  co->m3 = co_3_rounded;
  co->m4 = co_4_rounded;
  co->m5 = co_5_rounded;
}

/* co = H̄* c = [Ad]*(D) P c; P clears component 4 of c, given in the frame of a ry joint at D.
   D: displacement [R | t], R rotation, t in m; c, co: coscrew (f in N; τ in N m).
   27 mul, 90 add, 21 product rest.
   Error <= u |result| + (lin: 11, ang: 35) u^2 S, S the sum of the |terms| of the expanded
     formula; barring over- and underflow. */
static inline void ksl_constraint_cry_accurate(const ksl_SE3_t *D, const ksl_coscrew_t *c,
    ksl_coscrew_t *co) {
  const double w_0a = KSL_MUL(D->m00, c->m0), w_0b = KSL_MUL(D->m01, c->m1), w_0c = w_0a + w_0b,
      w_0c_right = w_0c - w_0a, w_0d = KSL_MUL(D->m02, c->m2), w_0 = w_0c + w_0d,
      w_0_right = w_0 - w_0c,
      w_0c_lo = ksl_product_rest(D->m00, c->m0, w_0a, w_0c - w_0c_right)
          + ksl_product_rest(D->m01, c->m1, w_0b, w_0c_right),
      w_0_lo = w_0c - (w_0 - w_0_right) + ksl_product_rest(D->m02, c->m2, w_0d, w_0_right)
          + w_0c_lo;
  const double w_1a = KSL_MUL(D->m10, c->m0), w_1b = KSL_MUL(D->m11, c->m1), w_1c = w_1a + w_1b,
      w_1c_right = w_1c - w_1a, w_1d = KSL_MUL(D->m12, c->m2), w_1 = w_1c + w_1d,
      w_1_right = w_1 - w_1c,
      w_1c_lo = ksl_product_rest(D->m10, c->m0, w_1a, w_1c - w_1c_right)
          + ksl_product_rest(D->m11, c->m1, w_1b, w_1c_right),
      w_1_lo = w_1c - (w_1 - w_1_right) + ksl_product_rest(D->m12, c->m2, w_1d, w_1_right)
          + w_1c_lo;
  const double w_2a = KSL_MUL(D->m20, c->m0), w_2b = KSL_MUL(D->m21, c->m1), w_2c = w_2a + w_2b,
      w_2c_right = w_2c - w_2a, w_2d = KSL_MUL(D->m22, c->m2), w_2 = w_2c + w_2d,
      w_2_right = w_2 - w_2c,
      w_2c_lo = ksl_product_rest(D->m20, c->m0, w_2a, w_2c - w_2c_right)
          + ksl_product_rest(D->m21, c->m1, w_2b, w_2c_right),
      w_2_lo = w_2c - (w_2 - w_2_right) + ksl_product_rest(D->m22, c->m2, w_2d, w_2_right)
          + w_2c_lo;
  const double w_3a = KSL_MUL(D->m00, c->m3), w_3b = KSL_MUL(D->m02, c->m5), w_3 = w_3a + w_3b,
      w_3_right = w_3 - w_3a;
  const double w_4a = KSL_MUL(D->m10, c->m3), w_4b = KSL_MUL(D->m12, c->m5), w_4 = w_4a + w_4b,
      w_4_right = w_4 - w_4a;
  const double w_5a = KSL_MUL(D->m20, c->m3), w_5b = KSL_MUL(D->m22, c->m5), w_5 = w_5a + w_5b,
      w_5_right = w_5 - w_5a;
  const double co_3a = KSL_MUL(D->m13, w_2), co_3b = KSL_MUL(D->m23, w_1), co_3c = co_3a - co_3b,
      co_3c_right = co_3a - co_3c,
      co_3c_lo1 = ksl_product_rest(D->m13, w_2, co_3a, co_3c + co_3c_right)
          - ksl_product_rest(D->m23, w_1, co_3b, co_3c_right), co_3 = co_3c + w_3,
      co_3_right = co_3 - co_3c;
  const double w_3_lo = ksl_product_rest(D->m00, c->m3, w_3a, w_3 - w_3_right)
          + ksl_product_rest(D->m02, c->m5, w_3b, w_3_right);
  const double co_4a = KSL_MUL(D->m23, w_0), co_4b = KSL_MUL(D->m03, w_2), co_4c = co_4a - co_4b,
      co_4c_right = co_4a - co_4c,
      co_4c_lo1 = ksl_product_rest(D->m23, w_0, co_4a, co_4c + co_4c_right)
          - ksl_product_rest(D->m03, w_2, co_4b, co_4c_right), co_4 = co_4c + w_4,
      co_4_right = co_4 - co_4c;
  const double w_4_lo = ksl_product_rest(D->m10, c->m3, w_4a, w_4 - w_4_right)
          + ksl_product_rest(D->m12, c->m5, w_4b, w_4_right);
  const double co_5a = KSL_MUL(D->m03, w_1), co_5b = KSL_MUL(D->m13, w_0), co_5c = co_5a - co_5b,
      co_5c_right = co_5a - co_5c,
      co_5c_lo1 = ksl_product_rest(D->m03, w_1, co_5a, co_5c + co_5c_right)
          - ksl_product_rest(D->m13, w_0, co_5b, co_5c_right), co_5 = co_5c + w_5,
      co_5_right = co_5 - co_5c;
  const double w_5_lo = ksl_product_rest(D->m20, c->m3, w_5a, w_5 - w_5_right)
          + ksl_product_rest(D->m22, c->m5, w_5b, w_5_right);
  const double w_0_rounded = w_0 + w_0_lo, w_1_rounded = w_1 + w_1_lo, w_2_rounded = w_2 + w_2_lo;
  const double co_3_rounded = co_3
          + (co_3c - (co_3 - co_3_right) + (w_3 - co_3_right) + w_3_lo
          + (co_3c_lo1 + (KSL_MUL(D->m13, w_2_lo) - KSL_MUL(D->m23, w_1_lo)))),
      co_4_rounded = co_4
          + (co_4c - (co_4 - co_4_right) + (w_4 - co_4_right) + w_4_lo
          + (co_4c_lo1 + (KSL_MUL(D->m23, w_0_lo) - KSL_MUL(D->m03, w_2_lo)))),
      co_5_rounded = co_5
          + (co_5c - (co_5 - co_5_right) + (w_5 - co_5_right) + w_5_lo
          + (co_5c_lo1 + (KSL_MUL(D->m03, w_1_lo) - KSL_MUL(D->m13, w_0_lo))));
  co->m0 = w_0_rounded;
  co->m1 = w_1_rounded;
  co->m2 = w_2_rounded;
  co->m3 = co_3_rounded;
  co->m4 = co_4_rounded;
  co->m5 = co_5_rounded;
}

/* co = H̄* c = [Ad]*(D) P c; P clears component 5 of c, given in the frame of a rz joint at D.
   D: displacement [R | t], R rotation, t in m; c, co: coscrew (f in N; τ in N m).
   27 mul, 90 add, 21 product rest.
   Error <= u |result| + (lin: 11, ang: 35) u^2 S, S the sum of the |terms| of the expanded
     formula; barring over- and underflow. */
static inline void ksl_constraint_crz_accurate(const ksl_SE3_t *D, const ksl_coscrew_t *c,
    ksl_coscrew_t *co) {
  const double w_0a = KSL_MUL(D->m00, c->m0), w_0b = KSL_MUL(D->m01, c->m1), w_0c = w_0a + w_0b,
      w_0c_right = w_0c - w_0a, w_0d = KSL_MUL(D->m02, c->m2), w_0 = w_0c + w_0d,
      w_0_right = w_0 - w_0c,
      w_0c_lo = ksl_product_rest(D->m00, c->m0, w_0a, w_0c - w_0c_right)
          + ksl_product_rest(D->m01, c->m1, w_0b, w_0c_right),
      w_0_lo = w_0c - (w_0 - w_0_right) + ksl_product_rest(D->m02, c->m2, w_0d, w_0_right)
          + w_0c_lo;
  const double w_1a = KSL_MUL(D->m10, c->m0), w_1b = KSL_MUL(D->m11, c->m1), w_1c = w_1a + w_1b,
      w_1c_right = w_1c - w_1a, w_1d = KSL_MUL(D->m12, c->m2), w_1 = w_1c + w_1d,
      w_1_right = w_1 - w_1c,
      w_1c_lo = ksl_product_rest(D->m10, c->m0, w_1a, w_1c - w_1c_right)
          + ksl_product_rest(D->m11, c->m1, w_1b, w_1c_right),
      w_1_lo = w_1c - (w_1 - w_1_right) + ksl_product_rest(D->m12, c->m2, w_1d, w_1_right)
          + w_1c_lo;
  const double w_2a = KSL_MUL(D->m20, c->m0), w_2b = KSL_MUL(D->m21, c->m1), w_2c = w_2a + w_2b,
      w_2c_right = w_2c - w_2a, w_2d = KSL_MUL(D->m22, c->m2), w_2 = w_2c + w_2d,
      w_2_right = w_2 - w_2c,
      w_2c_lo = ksl_product_rest(D->m20, c->m0, w_2a, w_2c - w_2c_right)
          + ksl_product_rest(D->m21, c->m1, w_2b, w_2c_right),
      w_2_lo = w_2c - (w_2 - w_2_right) + ksl_product_rest(D->m22, c->m2, w_2d, w_2_right)
          + w_2c_lo;
  const double w_3a = KSL_MUL(D->m00, c->m3), w_3b = KSL_MUL(D->m01, c->m4), w_3 = w_3a + w_3b,
      w_3_right = w_3 - w_3a;
  const double w_4a = KSL_MUL(D->m10, c->m3), w_4b = KSL_MUL(D->m11, c->m4), w_4 = w_4a + w_4b,
      w_4_right = w_4 - w_4a;
  const double w_5a = KSL_MUL(D->m20, c->m3), w_5b = KSL_MUL(D->m21, c->m4), w_5 = w_5a + w_5b,
      w_5_right = w_5 - w_5a;
  const double co_3a = KSL_MUL(D->m13, w_2), co_3b = KSL_MUL(D->m23, w_1), co_3c = co_3a - co_3b,
      co_3c_right = co_3a - co_3c,
      co_3c_lo1 = ksl_product_rest(D->m13, w_2, co_3a, co_3c + co_3c_right)
          - ksl_product_rest(D->m23, w_1, co_3b, co_3c_right), co_3 = co_3c + w_3,
      co_3_right = co_3 - co_3c;
  const double w_3_lo = ksl_product_rest(D->m00, c->m3, w_3a, w_3 - w_3_right)
          + ksl_product_rest(D->m01, c->m4, w_3b, w_3_right);
  const double co_4a = KSL_MUL(D->m23, w_0), co_4b = KSL_MUL(D->m03, w_2), co_4c = co_4a - co_4b,
      co_4c_right = co_4a - co_4c,
      co_4c_lo1 = ksl_product_rest(D->m23, w_0, co_4a, co_4c + co_4c_right)
          - ksl_product_rest(D->m03, w_2, co_4b, co_4c_right), co_4 = co_4c + w_4,
      co_4_right = co_4 - co_4c;
  const double w_4_lo = ksl_product_rest(D->m10, c->m3, w_4a, w_4 - w_4_right)
          + ksl_product_rest(D->m11, c->m4, w_4b, w_4_right);
  const double co_5a = KSL_MUL(D->m03, w_1), co_5b = KSL_MUL(D->m13, w_0), co_5c = co_5a - co_5b,
      co_5c_right = co_5a - co_5c,
      co_5c_lo1 = ksl_product_rest(D->m03, w_1, co_5a, co_5c + co_5c_right)
          - ksl_product_rest(D->m13, w_0, co_5b, co_5c_right), co_5 = co_5c + w_5,
      co_5_right = co_5 - co_5c;
  const double w_5_lo = ksl_product_rest(D->m20, c->m3, w_5a, w_5 - w_5_right)
          + ksl_product_rest(D->m21, c->m4, w_5b, w_5_right);
  const double w_0_rounded = w_0 + w_0_lo, w_1_rounded = w_1 + w_1_lo, w_2_rounded = w_2 + w_2_lo;
  const double co_3_rounded = co_3
          + (co_3c - (co_3 - co_3_right) + (w_3 - co_3_right) + w_3_lo
          + (co_3c_lo1 + (KSL_MUL(D->m13, w_2_lo) - KSL_MUL(D->m23, w_1_lo)))),
      co_4_rounded = co_4
          + (co_4c - (co_4 - co_4_right) + (w_4 - co_4_right) + w_4_lo
          + (co_4c_lo1 + (KSL_MUL(D->m23, w_0_lo) - KSL_MUL(D->m03, w_2_lo)))),
      co_5_rounded = co_5
          + (co_5c - (co_5 - co_5_right) + (w_5 - co_5_right) + w_5_lo
          + (co_5c_lo1 + (KSL_MUL(D->m03, w_1_lo) - KSL_MUL(D->m13, w_0_lo))));
  co->m0 = w_0_rounded;
  co->m1 = w_1_rounded;
  co->m2 = w_2_rounded;
  co->m3 = co_3_rounded;
  co->m4 = co_4_rounded;
  co->m5 = co_5_rounded;
}

/* co = h̄* c = [Ad]*(D) P c; P keeps component 0 of c, given in the frame of a tx joint at D.
   D: displacement [R | t], R rotation, t in m; c, co: coscrew (f in N; τ in N m).
   15 mul, 24 add, 3 product error, 6 product rest.
   Error <= u |result| + (lin: 0, ang: 11) u^2 S, S the sum of the |terms| of the expanded
     formula; barring over- and underflow. */
static inline void ksl_working_ctx_accurate(const ksl_SE3_t *D, const ksl_coscrew_t *c,
    ksl_coscrew_t *co) {
  const double w_0 = KSL_MUL(D->m00, c->m0), w_1 = KSL_MUL(D->m10, c->m0),
      w_2 = KSL_MUL(D->m20, c->m0);
  const double w_2_lo = ksl_product_error(D->m20, c->m0, w_2), co_3a = KSL_MUL(D->m13, w_2),
      w_1_lo = ksl_product_error(D->m10, c->m0, w_1), co_3b = KSL_MUL(D->m23, w_1),
      co_3 = co_3a - co_3b, co_3_right = co_3a - co_3,
      co_3_lo1 = ksl_product_rest(D->m13, w_2, co_3a, co_3 + co_3_right)
          - ksl_product_rest(D->m23, w_1, co_3b, co_3_right);
  const double w_0_lo = ksl_product_error(D->m00, c->m0, w_0), co_4a = KSL_MUL(D->m23, w_0),
      co_4b = KSL_MUL(D->m03, w_2), co_4 = co_4a - co_4b, co_4_right = co_4a - co_4,
      co_4_lo1 = ksl_product_rest(D->m23, w_0, co_4a, co_4 + co_4_right)
          - ksl_product_rest(D->m03, w_2, co_4b, co_4_right);
  const double co_5a = KSL_MUL(D->m03, w_1), co_5b = KSL_MUL(D->m13, w_0), co_5 = co_5a - co_5b,
      co_5_right = co_5a - co_5,
      co_5_lo1 = ksl_product_rest(D->m03, w_1, co_5a, co_5 + co_5_right)
          - ksl_product_rest(D->m13, w_0, co_5b, co_5_right);
  const double w_0_rounded = w_0 + w_0_lo, w_1_rounded = w_1 + w_1_lo, w_2_rounded = w_2 + w_2_lo;
  const double co_3_rounded = co_3
          + (co_3_lo1 + (KSL_MUL(D->m13, w_2_lo) - KSL_MUL(D->m23, w_1_lo))),
      co_4_rounded = co_4 + (co_4_lo1 + (KSL_MUL(D->m23, w_0_lo) - KSL_MUL(D->m03, w_2_lo))),
      co_5_rounded = co_5 + (co_5_lo1 + (KSL_MUL(D->m03, w_1_lo) - KSL_MUL(D->m13, w_0_lo)));
  co->m0 = w_0_rounded;
  co->m1 = w_1_rounded;
  co->m2 = w_2_rounded;
  co->m3 = co_3_rounded;
  co->m4 = co_4_rounded;
  co->m5 = co_5_rounded;
}

/* co = h̄* c = [Ad]*(D) P c; P keeps component 1 of c, given in the frame of a ty joint at D.
   D: displacement [R | t], R rotation, t in m; c, co: coscrew (f in N; τ in N m).
   15 mul, 24 add, 3 product error, 6 product rest.
   Error <= u |result| + (lin: 0, ang: 11) u^2 S, S the sum of the |terms| of the expanded
     formula; barring over- and underflow. */
static inline void ksl_working_cty_accurate(const ksl_SE3_t *D, const ksl_coscrew_t *c,
    ksl_coscrew_t *co) {
  const double w_0 = KSL_MUL(D->m01, c->m1), w_1 = KSL_MUL(D->m11, c->m1),
      w_2 = KSL_MUL(D->m21, c->m1);
  const double w_2_lo = ksl_product_error(D->m21, c->m1, w_2), co_3a = KSL_MUL(D->m13, w_2),
      w_1_lo = ksl_product_error(D->m11, c->m1, w_1), co_3b = KSL_MUL(D->m23, w_1),
      co_3 = co_3a - co_3b, co_3_right = co_3a - co_3,
      co_3_lo1 = ksl_product_rest(D->m13, w_2, co_3a, co_3 + co_3_right)
          - ksl_product_rest(D->m23, w_1, co_3b, co_3_right);
  const double w_0_lo = ksl_product_error(D->m01, c->m1, w_0), co_4a = KSL_MUL(D->m23, w_0),
      co_4b = KSL_MUL(D->m03, w_2), co_4 = co_4a - co_4b, co_4_right = co_4a - co_4,
      co_4_lo1 = ksl_product_rest(D->m23, w_0, co_4a, co_4 + co_4_right)
          - ksl_product_rest(D->m03, w_2, co_4b, co_4_right);
  const double co_5a = KSL_MUL(D->m03, w_1), co_5b = KSL_MUL(D->m13, w_0), co_5 = co_5a - co_5b,
      co_5_right = co_5a - co_5,
      co_5_lo1 = ksl_product_rest(D->m03, w_1, co_5a, co_5 + co_5_right)
          - ksl_product_rest(D->m13, w_0, co_5b, co_5_right);
  const double w_0_rounded = w_0 + w_0_lo, w_1_rounded = w_1 + w_1_lo, w_2_rounded = w_2 + w_2_lo;
  const double co_3_rounded = co_3
          + (co_3_lo1 + (KSL_MUL(D->m13, w_2_lo) - KSL_MUL(D->m23, w_1_lo))),
      co_4_rounded = co_4 + (co_4_lo1 + (KSL_MUL(D->m23, w_0_lo) - KSL_MUL(D->m03, w_2_lo))),
      co_5_rounded = co_5 + (co_5_lo1 + (KSL_MUL(D->m03, w_1_lo) - KSL_MUL(D->m13, w_0_lo)));
  co->m0 = w_0_rounded;
  co->m1 = w_1_rounded;
  co->m2 = w_2_rounded;
  co->m3 = co_3_rounded;
  co->m4 = co_4_rounded;
  co->m5 = co_5_rounded;
}

/* co = h̄* c = [Ad]*(D) P c; P keeps component 2 of c, given in the frame of a tz joint at D.
   D: displacement [R | t], R rotation, t in m; c, co: coscrew (f in N; τ in N m).
   15 mul, 24 add, 3 product error, 6 product rest.
   Error <= u |result| + (lin: 0, ang: 11) u^2 S, S the sum of the |terms| of the expanded
     formula; barring over- and underflow. */
static inline void ksl_working_ctz_accurate(const ksl_SE3_t *D, const ksl_coscrew_t *c,
    ksl_coscrew_t *co) {
  const double w_0 = KSL_MUL(D->m02, c->m2), w_1 = KSL_MUL(D->m12, c->m2),
      w_2 = KSL_MUL(D->m22, c->m2);
  const double w_2_lo = ksl_product_error(D->m22, c->m2, w_2), co_3a = KSL_MUL(D->m13, w_2),
      w_1_lo = ksl_product_error(D->m12, c->m2, w_1), co_3b = KSL_MUL(D->m23, w_1),
      co_3 = co_3a - co_3b, co_3_right = co_3a - co_3,
      co_3_lo1 = ksl_product_rest(D->m13, w_2, co_3a, co_3 + co_3_right)
          - ksl_product_rest(D->m23, w_1, co_3b, co_3_right);
  const double w_0_lo = ksl_product_error(D->m02, c->m2, w_0), co_4a = KSL_MUL(D->m23, w_0),
      co_4b = KSL_MUL(D->m03, w_2), co_4 = co_4a - co_4b, co_4_right = co_4a - co_4,
      co_4_lo1 = ksl_product_rest(D->m23, w_0, co_4a, co_4 + co_4_right)
          - ksl_product_rest(D->m03, w_2, co_4b, co_4_right);
  const double co_5a = KSL_MUL(D->m03, w_1), co_5b = KSL_MUL(D->m13, w_0), co_5 = co_5a - co_5b,
      co_5_right = co_5a - co_5,
      co_5_lo1 = ksl_product_rest(D->m03, w_1, co_5a, co_5 + co_5_right)
          - ksl_product_rest(D->m13, w_0, co_5b, co_5_right);
  const double w_0_rounded = w_0 + w_0_lo, w_1_rounded = w_1 + w_1_lo, w_2_rounded = w_2 + w_2_lo;
  const double co_3_rounded = co_3
          + (co_3_lo1 + (KSL_MUL(D->m13, w_2_lo) - KSL_MUL(D->m23, w_1_lo))),
      co_4_rounded = co_4 + (co_4_lo1 + (KSL_MUL(D->m23, w_0_lo) - KSL_MUL(D->m03, w_2_lo))),
      co_5_rounded = co_5 + (co_5_lo1 + (KSL_MUL(D->m03, w_1_lo) - KSL_MUL(D->m13, w_0_lo)));
  co->m0 = w_0_rounded;
  co->m1 = w_1_rounded;
  co->m2 = w_2_rounded;
  co->m3 = co_3_rounded;
  co->m4 = co_4_rounded;
  co->m5 = co_5_rounded;
}

/* co = h̄* c = [Ad]*(D) P c; P keeps component 3 of c, given in the frame of a rx joint at D.
   D: displacement [R | t], R rotation, t in m; c, co: coscrew (f in N; τ in N m).
   3 mul, 3 add, 3 product error.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_working_crx_accurate(const ksl_SE3_t *D, const ksl_coscrew_t *c,
    ksl_coscrew_t *co) {
  const double w_3 = KSL_MUL(D->m00, c->m3), w_4 = KSL_MUL(D->m10, c->m3),
      w_5 = KSL_MUL(D->m20, c->m3);
  const double w_3_rounded = w_3 + ksl_product_error(D->m00, c->m3, w_3),
      w_4_rounded = w_4 + ksl_product_error(D->m10, c->m3, w_4),
      w_5_rounded = w_5 + ksl_product_error(D->m20, c->m3, w_5);
  co->m0 = 0.0;
  co->m1 = 0.0;
  co->m2 = 0.0;
  co->m3 = w_3_rounded;
  co->m4 = w_4_rounded;
  co->m5 = w_5_rounded;
}

/* co = h̄* c = [Ad]*(D) P c; P keeps component 4 of c, given in the frame of a ry joint at D.
   D: displacement [R | t], R rotation, t in m; c, co: coscrew (f in N; τ in N m).
   3 mul, 3 add, 3 product error.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_working_cry_accurate(const ksl_SE3_t *D, const ksl_coscrew_t *c,
    ksl_coscrew_t *co) {
  const double w_3 = KSL_MUL(D->m01, c->m4), w_4 = KSL_MUL(D->m11, c->m4),
      w_5 = KSL_MUL(D->m21, c->m4);
  const double w_3_rounded = w_3 + ksl_product_error(D->m01, c->m4, w_3),
      w_4_rounded = w_4 + ksl_product_error(D->m11, c->m4, w_4),
      w_5_rounded = w_5 + ksl_product_error(D->m21, c->m4, w_5);
  co->m0 = 0.0;
  co->m1 = 0.0;
  co->m2 = 0.0;
  co->m3 = w_3_rounded;
  co->m4 = w_4_rounded;
  co->m5 = w_5_rounded;
}

/* co = h̄* c = [Ad]*(D) P c; P keeps component 5 of c, given in the frame of a rz joint at D.
   D: displacement [R | t], R rotation, t in m; c, co: coscrew (f in N; τ in N m).
   3 mul, 3 add, 3 product error.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_working_crz_accurate(const ksl_SE3_t *D, const ksl_coscrew_t *c,
    ksl_coscrew_t *co) {
  const double w_3 = KSL_MUL(D->m02, c->m5), w_4 = KSL_MUL(D->m12, c->m5),
      w_5 = KSL_MUL(D->m22, c->m5);
  const double w_3_rounded = w_3 + ksl_product_error(D->m02, c->m5, w_3),
      w_4_rounded = w_4 + ksl_product_error(D->m12, c->m5, w_4),
      w_5_rounded = w_5 + ksl_product_error(D->m22, c->m5, w_5);
  co->m0 = 0.0;
  co->m1 = 0.0;
  co->m2 = 0.0;
  co->m3 = w_3_rounded;
  co->m4 = w_4_rounded;
  co->m5 = w_5_rounded;
}

/* self = a self.
   self: coscrew (f in N; τ in N m); a: number.
   6 mul.
   Error <= u |result| + 1/32 u^2 S, S the sum of the |terms| of the expanded formula; barring
     over- and underflow. */
static inline void ksl_coscrewf_scale_accurate(ksl_coscrewf_t *self, const float a) {
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
   a: number; x, y: coscrew (f in N; τ in N m).
   6 mul, 6 add.
   Error <= u |result| + 1/16 u^2 S, S the sum of the |terms| of the expanded formula; barring
     over- and underflow. */
static inline void ksl_axpy_ccf_accurate(const float a, const ksl_coscrewf_t *x,
    ksl_coscrewf_t *y) {
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
   x, y: coscrew (f in N; τ in N m).
   6 add.
   Error <= u |result| + 1/32 u^2 S, S the sum of the |terms| of the expanded formula; barring
     over- and underflow. */
static inline void ksl_xpy_ccf_accurate(const ksl_coscrewf_t *x, ksl_coscrewf_t *y) {
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
   x, y: coscrew (f in N; τ in N m).
   6 add.
   Error <= u |result| + 1/32 u^2 S, S the sum of the |terms| of the expanded formula; barring
     over- and underflow. */
static inline void ksl_nxpy_ccf_accurate(const ksl_coscrewf_t *x, ksl_coscrewf_t *y) {
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

/* co = a ci.
   a: number; ci, co: coscrew (f in N; τ in N m).
   6 mul.
   Error <= u |result| + 1/32 u^2 S, S the sum of the |terms| of the expanded formula; barring
     over- and underflow. */
static inline void ksl_product_acf_accurate(const float a, const ksl_coscrewf_t *ci,
    ksl_coscrewf_t *co) {
  const double co_0 = (double)a * (double)ci->m0, co_1 = (double)a * (double)ci->m1,
      co_2 = (double)a * (double)ci->m2, co_3 = (double)a * (double)ci->m3,
      co_4 = (double)a * (double)ci->m4, co_5 = (double)a * (double)ci->m5;
  co->m0 = (float)co_0;
  co->m1 = (float)co_1;
  co->m2 = (float)co_2;
  co->m3 = (float)co_3;
  co->m4 = (float)co_4;
  co->m5 = (float)co_5;
}

/* co = c1 + c2.
   c1, c2, co: coscrew (f in N; τ in N m).
   6 add.
   Error <= u |result| + 1/32 u^2 S, S the sum of the |terms| of the expanded formula; barring
     over- and underflow. */
static inline void ksl_add_ccf_accurate(const ksl_coscrewf_t *c1, const ksl_coscrewf_t *c2,
    ksl_coscrewf_t *co) {
  const double co_0 = (double)c1->m0 + (double)c2->m0, co_1 = (double)c1->m1 + (double)c2->m1,
      co_2 = (double)c1->m2 + (double)c2->m2, co_3 = (double)c1->m3 + (double)c2->m3,
      co_4 = (double)c1->m4 + (double)c2->m4, co_5 = (double)c1->m5 + (double)c2->m5;
  co->m0 = (float)co_0;
  co->m1 = (float)co_1;
  co->m2 = (float)co_2;
  co->m3 = (float)co_3;
  co->m4 = (float)co_4;
  co->m5 = (float)co_5;
}

/* co = c1 - c2.
   c1, c2, co: coscrew (f in N; τ in N m).
   6 add.
   Error <= u |result| + 1/32 u^2 S, S the sum of the |terms| of the expanded formula; barring
     over- and underflow. */
static inline void ksl_subtract_ccf_accurate(const ksl_coscrewf_t *c1, const ksl_coscrewf_t *c2,
    ksl_coscrewf_t *co) {
  const double co_0 = (double)c1->m0 - (double)c2->m0, co_1 = (double)c1->m1 - (double)c2->m1,
      co_2 = (double)c1->m2 - (double)c2->m2, co_3 = (double)c1->m3 - (double)c2->m3,
      co_4 = (double)c1->m4 - (double)c2->m4, co_5 = (double)c1->m5 - (double)c2->m5;
  co->m0 = (float)co_0;
  co->m1 = (float)co_1;
  co->m2 = (float)co_2;
  co->m3 = (float)co_3;
  co->m4 = (float)co_4;
  co->m5 = (float)co_5;
}

/* |ci|: |f|, or |τ| where every |f_i| is below 1e-9 (single: 1e-6).
   ci: coscrew (f in N; τ in N m).
   7 mul, 2 add, 1 sqrt, 6 abs, 11 less, 1 equal, 14 select. */
static inline float ksl_coscrewf_norm_accurate(const ksl_coscrewf_t *ci) {
  const double small_c = fabs((double)ci->m2) < 9.999999974752427e-07 ? 1.0 : 0.0,
      small_f = fabs((double)ci->m1) < 9.999999974752427e-07 ? small_c : 0.0,
      small = fabs((double)ci->m0) < 9.999999974752427e-07 ? small_f : 0.0;
  const double p_0 = small == 1.0 ? (double)ci->m3 : (double)ci->m0,
      p_1 = small == 1.0 ? (double)ci->m4 : (double)ci->m1,
      p_2 = small == 1.0 ? (double)ci->m5 : (double)ci->m2;
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

/* self = self / |self|, with coscrew_norm; the zero coscrew stays zero.
   self: coscrew (f in N; τ in N m).
   18 mul, 2 add, 6 div, 1 sqrt, 9 abs, 16 less, 2 equal, 26 select. */
static inline void ksl_coscrewf_normalize_accurate(ksl_coscrewf_t *self) {
  const double small_a = fabs((double)self->m2),
      small_c = small_a < 9.999999974752427e-07 ? 1.0 : 0.0, small_d = fabs((double)self->m1),
      small_f = small_d < 9.999999974752427e-07 ? small_c : 0.0, small_g = fabs((double)self->m0),
      small = small_g < 9.999999974752427e-07 ? small_f : 0.0;
  const double p_0 = small == 1.0 ? (double)self->m3 : (double)self->m0,
      p_1 = small == 1.0 ? (double)self->m4 : (double)self->m1,
      p_2 = small == 1.0 ? (double)self->m5 : (double)self->m2;
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
  const double size_3 = fabs((double)self->m3), size_4 = fabs((double)self->m4),
      size_5 = fabs((double)self->m5);
  const double before_0 = small_g < 256.0 ? up : down, before_1 = small_d < 256.0 ? up : down,
      before_2 = small_a < 256.0 ? up : down, before_3 = size_3 < 256.0 ? up : down,
      before_4 = size_4 < 256.0 ? up : down, before_5 = size_5 < 256.0 ? up : down;
  const double after_0 = small_g < 256.0 ? down : up, after_1 = small_d < 256.0 ? down : up,
      after_2 = small_a < 256.0 ? down : up, after_3 = size_3 < 256.0 ? down : up,
      after_4 = size_4 < 256.0 ? down : up, after_5 = size_5 < 256.0 ? down : up;
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

/* co = ci / |ci|, with coscrew_norm; the zero coscrew stays zero.
   ci, co: coscrew (f in N; τ in N m).
   18 mul, 2 add, 6 div, 1 sqrt, 9 abs, 16 less, 2 equal, 26 select. */
static inline void ksl_coscrewf_normalized_accurate(const ksl_coscrewf_t *ci, ksl_coscrewf_t *co) {
  const double small_a = fabs((double)ci->m2),
      small_c = small_a < 9.999999974752427e-07 ? 1.0 : 0.0, small_d = fabs((double)ci->m1),
      small_f = small_d < 9.999999974752427e-07 ? small_c : 0.0, small_g = fabs((double)ci->m0),
      small = small_g < 9.999999974752427e-07 ? small_f : 0.0;
  const double p_0 = small == 1.0 ? (double)ci->m3 : (double)ci->m0,
      p_1 = small == 1.0 ? (double)ci->m4 : (double)ci->m1,
      p_2 = small == 1.0 ? (double)ci->m5 : (double)ci->m2;
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
  const double size_3 = fabs((double)ci->m3), size_4 = fabs((double)ci->m4),
      size_5 = fabs((double)ci->m5);
  const double before_0 = small_g < 256.0 ? up : down, before_1 = small_d < 256.0 ? up : down,
      before_2 = small_a < 256.0 ? up : down, before_3 = size_3 < 256.0 ? up : down,
      before_4 = size_4 < 256.0 ? up : down, before_5 = size_5 < 256.0 ? up : down;
  const double after_0 = small_g < 256.0 ? down : up, after_1 = small_d < 256.0 ? down : up,
      after_2 = small_a < 256.0 ? down : up, after_3 = size_3 < 256.0 ? down : up,
      after_4 = size_4 < 256.0 ? down : up, after_5 = size_5 < 256.0 ? down : up;
  const double sized_0 = KSL_MUL((double)ci->m0, before_0),
      sized_1 = KSL_MUL((double)ci->m1, before_1), sized_2 = KSL_MUL((double)ci->m2, before_2),
      sized_3 = KSL_MUL((double)ci->m3, before_3), sized_4 = KSL_MUL((double)ci->m4, before_4),
      sized_5 = KSL_MUL((double)ci->m5, before_5);
  const double quotient_0 = sized_0 / divisor, quotient_1 = sized_1 / divisor,
      quotient_2 = sized_2 / divisor, quotient_3 = sized_3 / divisor,
      quotient_4 = sized_4 / divisor, quotient_5 = sized_5 / divisor;
  const double co_0 = KSL_MUL(quotient_0, after_0), co_1 = KSL_MUL(quotient_1, after_1),
      co_2 = KSL_MUL(quotient_2, after_2), co_3 = KSL_MUL(quotient_3, after_3),
      co_4 = KSL_MUL(quotient_4, after_4), co_5 = KSL_MUL(quotient_5, after_5);
  co->m0 = (float)co_0;
  co->m1 = (float)co_1;
  co->m2 = (float)co_2;
  co->m3 = (float)co_3;
  co->m4 = (float)co_4;
  co->m5 = (float)co_5;
}

/* co = (c1.lin + c2.lin ; c1.ang).
   c1, c2, co: coscrew (f in N; τ in N m).
   3 add.
   Error <= u |result| + (lin: 1/32, ang: 0) u^2 S, S the sum of the |terms| of the expanded
     formula; barring over- and underflow. */
static inline void ksl_add_cctf_accurate(const ksl_coscrewf_t *c1, const ksl_coscrewf_t *c2,
    ksl_coscrewf_t *co) {
  const double co_0 = (double)c1->m0 + (double)c2->m0, co_1 = (double)c1->m1 + (double)c2->m1,
      co_2 = (double)c1->m2 + (double)c2->m2;
  const float c1_m3 = c1->m3;
  const float c1_m4 = c1->m4;
  const float c1_m5 = c1->m5;
  co->m0 = (float)co_0;
  co->m1 = (float)co_1;
  co->m2 = (float)co_2;
  co->m3 = c1_m3;
  co->m4 = c1_m4;
  co->m5 = c1_m5;
}

/* co = [Ad]*(t) ci.
   t: vector; ci, co: coscrew (f in N; τ in N m).
   6 mul, 6 add.
   Error <= u |result| + (lin: 0, ang: 3/32) u^2 S, S the sum of the |terms| of the expanded
     formula; barring over- and underflow. */
static inline void ksl_product_CoAdtcf_accurate(const ksl_vec3f_t *t, const ksl_coscrewf_t *ci,
    ksl_coscrewf_t *co) {
  const double co_3 = ksl_product_sum(-(double)t->z, (double)ci->m1, (double)t->y * (double)ci->m2)
          + (double)ci->m3,
      co_4 = ksl_product_sum(-(double)t->x, (double)ci->m2, (double)t->z * (double)ci->m0)
          + (double)ci->m4,
      co_5 = ksl_product_sum(-(double)t->y, (double)ci->m0, (double)t->x * (double)ci->m1)
          + (double)ci->m5;
  const float ci_m0 = ci->m0;
  const float ci_m1 = ci->m1;
  const float ci_m2 = ci->m2;
  co->m0 = ci_m0;
  co->m1 = ci_m1;
  co->m2 = ci_m2;
  co->m3 = (float)co_3;
  co->m4 = (float)co_4;
  co->m5 = (float)co_5;
}

/* co = [Ad]*(t)^-1 ci.
   t: vector; ci, co: coscrew (f in N; τ in N m).
   6 mul, 6 add.
   Error <= u |result| + (lin: 0, ang: 3/32) u^2 S, S the sum of the |terms| of the expanded
     formula; barring over- and underflow. */
static inline void ksl_product_CoAdtinvcf_accurate(const ksl_vec3f_t *t, const ksl_coscrewf_t *ci,
    ksl_coscrewf_t *co) {
  const double co_3 = ksl_product_sum(-(double)t->y, (double)ci->m2, (double)t->z * (double)ci->m1)
          + (double)ci->m3,
      co_4 = ksl_product_sum(-(double)t->z, (double)ci->m0, (double)t->x * (double)ci->m2)
          + (double)ci->m4,
      co_5 = ksl_product_sum(-(double)t->x, (double)ci->m1, (double)t->y * (double)ci->m0)
          + (double)ci->m5;
  const float ci_m0 = ci->m0;
  const float ci_m1 = ci->m1;
  const float ci_m2 = ci->m2;
  co->m0 = ci_m0;
  co->m1 = ci_m1;
  co->m2 = ci_m2;
  co->m3 = (float)co_3;
  co->m4 = (float)co_4;
  co->m5 = (float)co_5;
}

/* co = [Ad]*(t) (-ci).
   t: vector; ci, co: coscrew (f in N; τ in N m).
   6 mul, 6 add, 3 neg.
   Error <= u |result| + (lin: 0, ang: 3/32) u^2 S, S the sum of the |terms| of the expanded
     formula; barring over- and underflow. */
static inline void ksl_product_CoAdtcinvf_accurate(const ksl_vec3f_t *t, const ksl_coscrewf_t *ci,
    ksl_coscrewf_t *co) {
  const double co_0 = -(double)ci->m0, co_1 = -(double)ci->m1, co_2 = -(double)ci->m2,
      co_3 = ksl_product_sum(-(double)t->y, (double)ci->m2, (double)t->z * (double)ci->m1)
          - (double)ci->m3,
      co_4 = ksl_product_sum(-(double)t->z, (double)ci->m0, (double)t->x * (double)ci->m2)
          - (double)ci->m4,
      co_5 = ksl_product_sum(-(double)t->x, (double)ci->m1, (double)t->y * (double)ci->m0)
          - (double)ci->m5;
  co->m0 = (float)co_0;
  co->m1 = (float)co_1;
  co->m2 = (float)co_2;
  co->m3 = (float)co_3;
  co->m4 = (float)co_4;
  co->m5 = (float)co_5;
}

/* co = [Ad]*(R) ci.
   R: rotation or other 3×3 matrix; ci, co: coscrew (f in N; τ in N m).
   18 mul, 12 add.
   Error <= u |result| + 3/32 u^2 S, S the sum of the |terms| of the expanded formula; barring
     over- and underflow. */
static inline void ksl_product_CoAdrcf_accurate(const ksl_mat3x3f_t *R, const ksl_coscrewf_t *ci,
    ksl_coscrewf_t *co) {
  const double co_0 = ksl_product_sum((double)R->m02, (double)ci->m2,
      ksl_product_sum((double)R->m01, (double)ci->m1, (double)R->m00 * (double)ci->m0)),
      co_1 = ksl_product_sum((double)R->m12, (double)ci->m2, ksl_product_sum((double)R->m11,
          (double)ci->m1, (double)R->m10 * (double)ci->m0)),
      co_2 = ksl_product_sum((double)R->m22, (double)ci->m2, ksl_product_sum((double)R->m21,
          (double)ci->m1, (double)R->m20 * (double)ci->m0)),
      co_3 = ksl_product_sum((double)R->m02, (double)ci->m5, ksl_product_sum((double)R->m01,
          (double)ci->m4, (double)R->m00 * (double)ci->m3)),
      co_4 = ksl_product_sum((double)R->m12, (double)ci->m5, ksl_product_sum((double)R->m11,
          (double)ci->m4, (double)R->m10 * (double)ci->m3)),
      co_5 = ksl_product_sum((double)R->m22, (double)ci->m5, ksl_product_sum((double)R->m21,
          (double)ci->m4, (double)R->m20 * (double)ci->m3));
  co->m0 = (float)co_0;
  co->m1 = (float)co_1;
  co->m2 = (float)co_2;
  co->m3 = (float)co_3;
  co->m4 = (float)co_4;
  co->m5 = (float)co_5;
}

/* co = [Ad]*(R)^-1 ci.
   R: rotation or other 3×3 matrix; ci, co: coscrew (f in N; τ in N m).
   18 mul, 12 add.
   Error <= u |result| + 3/32 u^2 S, S the sum of the |terms| of the expanded formula; barring
     over- and underflow. */
static inline void ksl_product_CoAdrinvcf_accurate(const ksl_mat3x3f_t *R,
    const ksl_coscrewf_t *ci, ksl_coscrewf_t *co) {
  const double co_0 = ksl_product_sum((double)R->m20, (double)ci->m2,
      ksl_product_sum((double)R->m10, (double)ci->m1, (double)R->m00 * (double)ci->m0)),
      co_1 = ksl_product_sum((double)R->m21, (double)ci->m2, ksl_product_sum((double)R->m11,
          (double)ci->m1, (double)R->m01 * (double)ci->m0)),
      co_2 = ksl_product_sum((double)R->m22, (double)ci->m2, ksl_product_sum((double)R->m12,
          (double)ci->m1, (double)R->m02 * (double)ci->m0)),
      co_3 = ksl_product_sum((double)R->m20, (double)ci->m5, ksl_product_sum((double)R->m10,
          (double)ci->m4, (double)R->m00 * (double)ci->m3)),
      co_4 = ksl_product_sum((double)R->m21, (double)ci->m5, ksl_product_sum((double)R->m11,
          (double)ci->m4, (double)R->m01 * (double)ci->m3)),
      co_5 = ksl_product_sum((double)R->m22, (double)ci->m5, ksl_product_sum((double)R->m12,
          (double)ci->m4, (double)R->m02 * (double)ci->m3));
  co->m0 = (float)co_0;
  co->m1 = (float)co_1;
  co->m2 = (float)co_2;
  co->m3 = (float)co_3;
  co->m4 = (float)co_4;
  co->m5 = (float)co_5;
}

/* co = [Ad]*(R) (-ci).
   R: rotation or other 3×3 matrix; ci, co: coscrew (f in N; τ in N m).
   18 mul, 12 add, 6 neg.
   Error <= u |result| + 3/32 u^2 S, S the sum of the |terms| of the expanded formula; barring
     over- and underflow. */
static inline void ksl_product_CoAdrcinvf_accurate(const ksl_mat3x3f_t *R,
    const ksl_coscrewf_t *ci, ksl_coscrewf_t *co) {
  const double co_0 = ksl_product_sum(-(double)R->m02, (double)ci->m2,
      ksl_product_sum(-(double)R->m01, (double)ci->m1, -((double)R->m00 * (double)ci->m0))),
      co_1 = ksl_product_sum(-(double)R->m12, (double)ci->m2, ksl_product_sum(-(double)R->m11,
          (double)ci->m1, -((double)R->m10 * (double)ci->m0))),
      co_2 = ksl_product_sum(-(double)R->m22, (double)ci->m2, ksl_product_sum(-(double)R->m21,
          (double)ci->m1, -((double)R->m20 * (double)ci->m0))),
      co_3 = ksl_product_sum(-(double)R->m02, (double)ci->m5, ksl_product_sum(-(double)R->m01,
          (double)ci->m4, -((double)R->m00 * (double)ci->m3))),
      co_4 = ksl_product_sum(-(double)R->m12, (double)ci->m5, ksl_product_sum(-(double)R->m11,
          (double)ci->m4, -((double)R->m10 * (double)ci->m3))),
      co_5 = ksl_product_sum(-(double)R->m22, (double)ci->m5, ksl_product_sum(-(double)R->m21,
          (double)ci->m4, -((double)R->m20 * (double)ci->m3)));
  co->m0 = (float)co_0;
  co->m1 = (float)co_1;
  co->m2 = (float)co_2;
  co->m3 = (float)co_3;
  co->m4 = (float)co_4;
  co->m5 = (float)co_5;
}

/* co = [Ad]*(D) ci = [Ad]*(t) [Ad]*(R) ci.
   D: displacement [R | t], R rotation, t in m; ci, co: coscrew (f in N; τ in N m).
   24 mul, 18 add.
   Error <= u |result| + (lin: 3/32, ang: 3/16) u^2 S, S the sum of the |terms| of the expanded
     formula; barring over- and underflow. */
static inline void ksl_product_CoAdcf_accurate(const ksl_SE3f_t *D, const ksl_coscrewf_t *ci,
    ksl_coscrewf_t *co) {
  const double w_0 = ksl_product_sum((double)D->m02, (double)ci->m2, ksl_product_sum((double)D->m01,
      (double)ci->m1, (double)D->m00 * (double)ci->m0)),
      w_1 = ksl_product_sum((double)D->m12, (double)ci->m2, ksl_product_sum((double)D->m11,
          (double)ci->m1, (double)D->m10 * (double)ci->m0)),
      w_2 = ksl_product_sum((double)D->m22, (double)ci->m2, ksl_product_sum((double)D->m21,
          (double)ci->m1, (double)D->m20 * (double)ci->m0)),
      w_3 = ksl_product_sum((double)D->m02, (double)ci->m5, ksl_product_sum((double)D->m01,
          (double)ci->m4, (double)D->m00 * (double)ci->m3)),
      w_4 = ksl_product_sum((double)D->m12, (double)ci->m5, ksl_product_sum((double)D->m11,
          (double)ci->m4, (double)D->m10 * (double)ci->m3)),
      w_5 = ksl_product_sum((double)D->m22, (double)ci->m5, ksl_product_sum((double)D->m21,
          (double)ci->m4, (double)D->m20 * (double)ci->m3));
  const double co_3 = KSL_MUL((double)D->m13, w_2) - KSL_MUL((double)D->m23, w_1) + w_3,
      co_4 = KSL_MUL((double)D->m23, w_0) - KSL_MUL((double)D->m03, w_2) + w_4,
      co_5 = KSL_MUL((double)D->m03, w_1) - KSL_MUL((double)D->m13, w_0) + w_5;
  co->m0 = (float)w_0;
  co->m1 = (float)w_1;
  co->m2 = (float)w_2;
  co->m3 = (float)co_3;
  co->m4 = (float)co_4;
  co->m5 = (float)co_5;
}

/* co = [Ad]*(D)^-1 ci = [Ad]*(R^T) [Ad]*(-t) ci.
   D: displacement [R | t], R rotation, t in m; ci, co: coscrew (f in N; τ in N m).
   24 mul, 18 add.
   Error <= u |result| + (lin: 3/32, ang: 3/16) u^2 S, S the sum of the |terms| of the expanded
     formula; barring over- and underflow. */
static inline void ksl_product_CoAdinvcf_accurate(const ksl_SE3f_t *D, const ksl_coscrewf_t *ci,
    ksl_coscrewf_t *co) {
  const double w_3 = ksl_product_sum(-(double)D->m13, (double)ci->m2, (double)D->m23
          * (double)ci->m1) + (double)ci->m3,
      w_4 = ksl_product_sum(-(double)D->m23, (double)ci->m0, (double)D->m03 * (double)ci->m2)
          + (double)ci->m4,
      w_5 = ksl_product_sum(-(double)D->m03, (double)ci->m1, (double)D->m13 * (double)ci->m0)
          + (double)ci->m5;
  const double co_0 = ksl_product_sum((double)D->m20, (double)ci->m2,
      ksl_product_sum((double)D->m10, (double)ci->m1, (double)D->m00 * (double)ci->m0)),
      co_1 = ksl_product_sum((double)D->m21, (double)ci->m2, ksl_product_sum((double)D->m11,
          (double)ci->m1, (double)D->m01 * (double)ci->m0)),
      co_2 = ksl_product_sum((double)D->m22, (double)ci->m2, ksl_product_sum((double)D->m12,
          (double)ci->m1, (double)D->m02 * (double)ci->m0)),
      co_3 = KSL_MUL((double)D->m00, w_3) + KSL_MUL((double)D->m10, w_4)
          + KSL_MUL((double)D->m20, w_5),
      co_4 = KSL_MUL((double)D->m01, w_3) + KSL_MUL((double)D->m11, w_4)
          + KSL_MUL((double)D->m21, w_5),
      co_5 = KSL_MUL((double)D->m02, w_3) + KSL_MUL((double)D->m12, w_4)
          + KSL_MUL((double)D->m22, w_5);
  co->m0 = (float)co_0;
  co->m1 = (float)co_1;
  co->m2 = (float)co_2;
  co->m3 = (float)co_3;
  co->m4 = (float)co_4;
  co->m5 = (float)co_5;
}

/* co = [Ad]*(D) (-ci).
   D: displacement [R | t], R rotation, t in m; ci, co: coscrew (f in N; τ in N m).
   24 mul, 18 add, 6 neg.
   Error <= u |result| + (lin: 3/32, ang: 3/16) u^2 S, S the sum of the |terms| of the expanded
     formula; barring over- and underflow. */
static inline void ksl_product_CoAdcinvf_accurate(const ksl_SE3f_t *D, const ksl_coscrewf_t *ci,
    ksl_coscrewf_t *co) {
  const double w_0 = ksl_product_sum(-(double)D->m02, (double)ci->m2,
      ksl_product_sum(-(double)D->m01, (double)ci->m1, -((double)D->m00 * (double)ci->m0))),
      w_1 = ksl_product_sum(-(double)D->m12, (double)ci->m2, ksl_product_sum(-(double)D->m11,
          (double)ci->m1, -((double)D->m10 * (double)ci->m0))),
      w_2 = ksl_product_sum(-(double)D->m22, (double)ci->m2, ksl_product_sum(-(double)D->m21,
          (double)ci->m1, -((double)D->m20 * (double)ci->m0))),
      w_3 = ksl_product_sum(-(double)D->m02, (double)ci->m5, ksl_product_sum(-(double)D->m01,
          (double)ci->m4, -((double)D->m00 * (double)ci->m3))),
      w_4 = ksl_product_sum(-(double)D->m12, (double)ci->m5, ksl_product_sum(-(double)D->m11,
          (double)ci->m4, -((double)D->m10 * (double)ci->m3))),
      w_5 = ksl_product_sum(-(double)D->m22, (double)ci->m5, ksl_product_sum(-(double)D->m21,
          (double)ci->m4, -((double)D->m20 * (double)ci->m3)));
  const double co_3 = KSL_MUL((double)D->m13, w_2) - KSL_MUL((double)D->m23, w_1) + w_3,
      co_4 = KSL_MUL((double)D->m23, w_0) - KSL_MUL((double)D->m03, w_2) + w_4,
      co_5 = KSL_MUL((double)D->m03, w_1) - KSL_MUL((double)D->m13, w_0) + w_5;
  co->m0 = (float)w_0;
  co->m1 = (float)w_1;
  co->m2 = (float)w_2;
  co->m3 = (float)co_3;
  co->m4 = (float)co_4;
  co->m5 = (float)co_5;
}

/* co = h_tx: column 0 of [Ad]*(D).
   D: displacement [R | t], R rotation, t in m; co: coscrew (f in N; τ in N m).
   6 mul, 3 add.
   Error <= u |result| + (lin: 0, ang: 1/16) u^2 S, S the sum of the |terms| of the expanded
     formula; barring over- and underflow. */
static inline void ksl_hctxf_accurate(const ksl_SE3f_t *D, ksl_coscrewf_t *co) {
  const double co_3 = ksl_product_sum(-(double)D->m10, (double)D->m23, (double)D->m20
          * (double)D->m13),
      co_4 = ksl_product_sum(-(double)D->m20, (double)D->m03, (double)D->m00 * (double)D->m23),
      co_5 = ksl_product_sum(-(double)D->m00, (double)D->m13, (double)D->m10 * (double)D->m03);
  const float D_m00 = D->m00;
  const float D_m10 = D->m10;
  const float D_m20 = D->m20;
  co->m0 = D_m00;
  co->m1 = D_m10;
  co->m2 = D_m20;
  co->m3 = (float)co_3;
  co->m4 = (float)co_4;
  co->m5 = (float)co_5;
}

/* co = h_ty: column 1 of [Ad]*(D).
   D: displacement [R | t], R rotation, t in m; co: coscrew (f in N; τ in N m).
   6 mul, 3 add.
   Error <= u |result| + (lin: 0, ang: 1/16) u^2 S, S the sum of the |terms| of the expanded
     formula; barring over- and underflow. */
static inline void ksl_hctyf_accurate(const ksl_SE3f_t *D, ksl_coscrewf_t *co) {
  const double co_3 = ksl_product_sum(-(double)D->m11, (double)D->m23, (double)D->m21
          * (double)D->m13),
      co_4 = ksl_product_sum(-(double)D->m21, (double)D->m03, (double)D->m01 * (double)D->m23),
      co_5 = ksl_product_sum(-(double)D->m01, (double)D->m13, (double)D->m11 * (double)D->m03);
  const float D_m01 = D->m01;
  const float D_m11 = D->m11;
  const float D_m21 = D->m21;
  co->m0 = D_m01;
  co->m1 = D_m11;
  co->m2 = D_m21;
  co->m3 = (float)co_3;
  co->m4 = (float)co_4;
  co->m5 = (float)co_5;
}

/* co = h_tz: column 2 of [Ad]*(D).
   D: displacement [R | t], R rotation, t in m; co: coscrew (f in N; τ in N m).
   6 mul, 3 add.
   Error <= u |result| + (lin: 0, ang: 1/16) u^2 S, S the sum of the |terms| of the expanded
     formula; barring over- and underflow. */
static inline void ksl_hctzf_accurate(const ksl_SE3f_t *D, ksl_coscrewf_t *co) {
  const double co_3 = ksl_product_sum(-(double)D->m12, (double)D->m23, (double)D->m22
          * (double)D->m13),
      co_4 = ksl_product_sum(-(double)D->m22, (double)D->m03, (double)D->m02 * (double)D->m23),
      co_5 = ksl_product_sum(-(double)D->m02, (double)D->m13, (double)D->m12 * (double)D->m03);
  const float D_m02 = D->m02;
  const float D_m12 = D->m12;
  const float D_m22 = D->m22;
  co->m0 = D_m02;
  co->m1 = D_m12;
  co->m2 = D_m22;
  co->m3 = (float)co_3;
  co->m4 = (float)co_4;
  co->m5 = (float)co_5;
}

/* co = -h_tx: -column 0 of [Ad]*(D).
   D: displacement [R | t], R rotation, t in m; co: coscrew (f in N; τ in N m).
   6 mul, 3 add, 3 neg.
   Error <= u |result| + (lin: 0, ang: 1/16) u^2 S, S the sum of the |terms| of the expanded
     formula; barring over- and underflow. */
static inline void ksl_hctxinvf_accurate(const ksl_SE3f_t *D, ksl_coscrewf_t *co) {
  const double co_0 = -(double)D->m00, co_1 = -(double)D->m10, co_2 = -(double)D->m20,
      co_3 = ksl_product_sum(-(double)D->m20, (double)D->m13, (double)D->m10 * (double)D->m23),
      co_4 = ksl_product_sum(-(double)D->m00, (double)D->m23, (double)D->m20 * (double)D->m03),
      co_5 = ksl_product_sum(-(double)D->m10, (double)D->m03, (double)D->m00 * (double)D->m13);
  co->m0 = (float)co_0;
  co->m1 = (float)co_1;
  co->m2 = (float)co_2;
  co->m3 = (float)co_3;
  co->m4 = (float)co_4;
  co->m5 = (float)co_5;
}

/* co = -h_ty: -column 1 of [Ad]*(D).
   D: displacement [R | t], R rotation, t in m; co: coscrew (f in N; τ in N m).
   6 mul, 3 add, 3 neg.
   Error <= u |result| + (lin: 0, ang: 1/16) u^2 S, S the sum of the |terms| of the expanded
     formula; barring over- and underflow. */
static inline void ksl_hctyinvf_accurate(const ksl_SE3f_t *D, ksl_coscrewf_t *co) {
  const double co_0 = -(double)D->m01, co_1 = -(double)D->m11, co_2 = -(double)D->m21,
      co_3 = ksl_product_sum(-(double)D->m21, (double)D->m13, (double)D->m11 * (double)D->m23),
      co_4 = ksl_product_sum(-(double)D->m01, (double)D->m23, (double)D->m21 * (double)D->m03),
      co_5 = ksl_product_sum(-(double)D->m11, (double)D->m03, (double)D->m01 * (double)D->m13);
  co->m0 = (float)co_0;
  co->m1 = (float)co_1;
  co->m2 = (float)co_2;
  co->m3 = (float)co_3;
  co->m4 = (float)co_4;
  co->m5 = (float)co_5;
}

/* co = -h_tz: -column 2 of [Ad]*(D).
   D: displacement [R | t], R rotation, t in m; co: coscrew (f in N; τ in N m).
   6 mul, 3 add, 3 neg.
   Error <= u |result| + (lin: 0, ang: 1/16) u^2 S, S the sum of the |terms| of the expanded
     formula; barring over- and underflow. */
static inline void ksl_hctzinvf_accurate(const ksl_SE3f_t *D, ksl_coscrewf_t *co) {
  const double co_0 = -(double)D->m02, co_1 = -(double)D->m12, co_2 = -(double)D->m22,
      co_3 = ksl_product_sum(-(double)D->m22, (double)D->m13, (double)D->m12 * (double)D->m23),
      co_4 = ksl_product_sum(-(double)D->m02, (double)D->m23, (double)D->m22 * (double)D->m03),
      co_5 = ksl_product_sum(-(double)D->m12, (double)D->m03, (double)D->m02 * (double)D->m13);
  co->m0 = (float)co_0;
  co->m1 = (float)co_1;
  co->m2 = (float)co_2;
  co->m3 = (float)co_3;
  co->m4 = (float)co_4;
  co->m5 = (float)co_5;
}

/* M = [Ad]*(D).
   D: displacement [R | t], R rotation, t in m; M: 6×6 operator.
   18 mul, 9 add.
   Error <= u |result| + 1/16 u^2 S, S the sum of the |terms| of the expanded formula; barring
     over- and underflow. */
static inline void ksl_CoAdf_accurate(const ksl_SE3f_t *D, ksl_mat6x6f_t *M) {
  const double M_30 = ksl_product_sum(-(double)D->m10, (double)D->m23, (double)D->m20
          * (double)D->m13),
      M_31 = ksl_product_sum(-(double)D->m11, (double)D->m23, (double)D->m21 * (double)D->m13),
      M_32 = ksl_product_sum(-(double)D->m12, (double)D->m23, (double)D->m22 * (double)D->m13),
      M_40 = ksl_product_sum(-(double)D->m20, (double)D->m03, (double)D->m00 * (double)D->m23),
      M_41 = ksl_product_sum(-(double)D->m21, (double)D->m03, (double)D->m01 * (double)D->m23),
      M_42 = ksl_product_sum(-(double)D->m22, (double)D->m03, (double)D->m02 * (double)D->m23),
      M_50 = ksl_product_sum(-(double)D->m00, (double)D->m13, (double)D->m10 * (double)D->m03),
      M_51 = ksl_product_sum(-(double)D->m01, (double)D->m13, (double)D->m11 * (double)D->m03),
      M_52 = ksl_product_sum(-(double)D->m02, (double)D->m13, (double)D->m12 * (double)D->m03);
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
  M->at[3][0] = (float)0.0;
  M->at[4][0] = (float)0.0;
  M->at[5][0] = (float)0.0;
  M->at[0][1] = D_m10;
  M->at[1][1] = D_m11;
  M->at[2][1] = D_m12;
  M->at[3][1] = (float)0.0;
  M->at[4][1] = (float)0.0;
  M->at[5][1] = (float)0.0;
  M->at[0][2] = D_m20;
  M->at[1][2] = D_m21;
  M->at[2][2] = D_m22;
  M->at[3][2] = (float)0.0;
  M->at[4][2] = (float)0.0;
  M->at[5][2] = (float)0.0;
  M->at[0][3] = (float)M_30;
  M->at[1][3] = (float)M_31;
  M->at[2][3] = (float)M_32;
  M->at[3][3] = D_m00;
  M->at[4][3] = D_m01;
  M->at[5][3] = D_m02;
  M->at[0][4] = (float)M_40;
  M->at[1][4] = (float)M_41;
  M->at[2][4] = (float)M_42;
  M->at[3][4] = D_m10;
  M->at[4][4] = D_m11;
  M->at[5][4] = D_m12;
  M->at[0][5] = (float)M_50;
  M->at[1][5] = (float)M_51;
  M->at[2][5] = (float)M_52;
  M->at[3][5] = D_m20;
  M->at[4][5] = D_m21;
  M->at[5][5] = D_m22;
}

/* power = W ⊙ $ = f·v + τ·ω, W = c = (f; τ), $ = x = (ω; v).
   c: coscrew (f in N; τ in N m); x: six components with the angular part on top.
   6 mul, 5 add.
   Error <= u |result| + 1/8 u^2 S, S the sum of the |terms| of the expanded formula; barring
     over- and underflow. */
static inline float ksl_reciprocal_productf_accurate(const ksl_coscrewf_t *c, const float x[6]) {
  const double power_e = ksl_product_sum((double)c->m2, (double)x[5], ksl_product_sum((double)c->m1,
      (double)x[4], (double)c->m0 * (double)x[3])),
      power = power_e
          + ksl_product_sum((double)c->m5, (double)x[2], ksl_product_sum((double)c->m4,
              (double)x[1], (double)c->m3 * (double)x[0]));
  return (float)power;
}

/* co = [ad]*(s) c = (ω×f ; v×f + ω×τ).
   s: screw (v in m/s; ω in rad/s); c, co: coscrew (f in N; τ in N m).
   18 mul, 12 add.
   Error <= u |result| + (lin: 1/16, ang: 3/32) u^2 S, S the sum of the |terms| of the expanded
     formula; barring over- and underflow. */
static inline void ksl_cross_scf_accurate(const ksl_screwf_t *s, const ksl_coscrewf_t *c,
    ksl_coscrewf_t *co) {
  const double co_0 = ksl_product_sum(-(double)s->m5, (double)c->m1, (double)s->m4 * (double)c->m2),
      co_1 = ksl_product_sum(-(double)s->m3, (double)c->m2, (double)s->m5 * (double)c->m0),
      co_2 = ksl_product_sum(-(double)s->m4, (double)c->m0, (double)s->m3 * (double)c->m1);
  const double co_3c = ksl_product_sum(-(double)s->m2, (double)c->m1, (double)s->m1
          * (double)c->m2),
      co_3 = co_3c + ksl_product_sum(-(double)s->m5, (double)c->m4, (double)s->m4 * (double)c->m5);
  const double co_4c = ksl_product_sum(-(double)s->m0, (double)c->m2, (double)s->m2
          * (double)c->m0),
      co_4 = co_4c + ksl_product_sum(-(double)s->m3, (double)c->m5, (double)s->m5 * (double)c->m3);
  const double co_5c = ksl_product_sum(-(double)s->m1, (double)c->m0, (double)s->m0
          * (double)c->m1),
      co_5 = co_5c + ksl_product_sum(-(double)s->m4, (double)c->m3, (double)s->m3 * (double)c->m4);
  co->m0 = (float)co_0;
  co->m1 = (float)co_1;
  co->m2 = (float)co_2;
  co->m3 = (float)co_3;
  co->m4 = (float)co_4;
  co->m5 = (float)co_5;
}

/* co = (0 ; ω×τ).
   s: screw (v in m/s; ω in rad/s); c, co: coscrew (f in N; τ in N m).
   6 mul, 3 add.
   Error <= u |result| + (lin: 0, ang: 1/16) u^2 S, S the sum of the |terms| of the expanded
     formula; barring over- and underflow. */
static inline void ksl_cross_scaf_accurate(const ksl_screwf_t *s, const ksl_coscrewf_t *c,
    ksl_coscrewf_t *co) {
  const double co_3 = ksl_product_sum(-(double)s->m5, (double)c->m4, (double)s->m4 * (double)c->m5),
      co_4 = ksl_product_sum(-(double)s->m3, (double)c->m5, (double)s->m5 * (double)c->m3),
      co_5 = ksl_product_sum(-(double)s->m4, (double)c->m3, (double)s->m3 * (double)c->m4);
  co->m0 = (float)0.0;
  co->m1 = (float)0.0;
  co->m2 = (float)0.0;
  co->m3 = (float)co_3;
  co->m4 = (float)co_4;
  co->m5 = (float)co_5;
}

/* co = H̄* c = [Ad]*(D) P c; P clears component 0 of c, given in the frame of a tx joint at D.
   D: displacement [R | t], R rotation, t in m; c, co: coscrew (f in N; τ in N m).
   21 mul, 15 add.
   Error <= u |result| + (lin: 1/16, ang: 5/32) u^2 S, S the sum of the |terms| of the expanded
     formula; barring over- and underflow. */
static inline void ksl_constraint_ctxf_accurate(const ksl_SE3f_t *D, const ksl_coscrewf_t *c,
    ksl_coscrewf_t *co) {
  const double w_0 = ksl_product_sum((double)D->m02, (double)c->m2, (double)D->m01 * (double)c->m1),
      w_1 = ksl_product_sum((double)D->m12, (double)c->m2, (double)D->m11 * (double)c->m1),
      w_2 = ksl_product_sum((double)D->m22, (double)c->m2, (double)D->m21 * (double)c->m1),
      w_3 = ksl_product_sum((double)D->m02, (double)c->m5, ksl_product_sum((double)D->m01,
          (double)c->m4, (double)D->m00 * (double)c->m3)),
      w_4 = ksl_product_sum((double)D->m12, (double)c->m5, ksl_product_sum((double)D->m11,
          (double)c->m4, (double)D->m10 * (double)c->m3)),
      w_5 = ksl_product_sum((double)D->m22, (double)c->m5, ksl_product_sum((double)D->m21,
          (double)c->m4, (double)D->m20 * (double)c->m3));
  const double co_3 = KSL_MUL((double)D->m13, w_2) - KSL_MUL((double)D->m23, w_1) + w_3,
      co_4 = KSL_MUL((double)D->m23, w_0) - KSL_MUL((double)D->m03, w_2) + w_4,
      co_5 = KSL_MUL((double)D->m03, w_1) - KSL_MUL((double)D->m13, w_0) + w_5;
  co->m0 = (float)w_0;
  co->m1 = (float)w_1;
  co->m2 = (float)w_2;
  co->m3 = (float)co_3;
  co->m4 = (float)co_4;
  co->m5 = (float)co_5;
}

/* co = H̄* c = [Ad]*(D) P c; P clears component 1 of c, given in the frame of a ty joint at D.
   D: displacement [R | t], R rotation, t in m; c, co: coscrew (f in N; τ in N m).
   21 mul, 15 add.
   Error <= u |result| + (lin: 1/16, ang: 5/32) u^2 S, S the sum of the |terms| of the expanded
     formula; barring over- and underflow. */
static inline void ksl_constraint_ctyf_accurate(const ksl_SE3f_t *D, const ksl_coscrewf_t *c,
    ksl_coscrewf_t *co) {
  const double w_0 = ksl_product_sum((double)D->m02, (double)c->m2, (double)D->m00 * (double)c->m0),
      w_1 = ksl_product_sum((double)D->m12, (double)c->m2, (double)D->m10 * (double)c->m0),
      w_2 = ksl_product_sum((double)D->m22, (double)c->m2, (double)D->m20 * (double)c->m0),
      w_3 = ksl_product_sum((double)D->m02, (double)c->m5, ksl_product_sum((double)D->m01,
          (double)c->m4, (double)D->m00 * (double)c->m3)),
      w_4 = ksl_product_sum((double)D->m12, (double)c->m5, ksl_product_sum((double)D->m11,
          (double)c->m4, (double)D->m10 * (double)c->m3)),
      w_5 = ksl_product_sum((double)D->m22, (double)c->m5, ksl_product_sum((double)D->m21,
          (double)c->m4, (double)D->m20 * (double)c->m3));
  const double co_3 = KSL_MUL((double)D->m13, w_2) - KSL_MUL((double)D->m23, w_1) + w_3,
      co_4 = KSL_MUL((double)D->m23, w_0) - KSL_MUL((double)D->m03, w_2) + w_4,
      co_5 = KSL_MUL((double)D->m03, w_1) - KSL_MUL((double)D->m13, w_0) + w_5;
  co->m0 = (float)w_0;
  co->m1 = (float)w_1;
  co->m2 = (float)w_2;
  co->m3 = (float)co_3;
  co->m4 = (float)co_4;
  co->m5 = (float)co_5;
}

/* co = H̄* c = [Ad]*(D) P c; P clears component 2 of c, given in the frame of a tz joint at D.
   D: displacement [R | t], R rotation, t in m; c, co: coscrew (f in N; τ in N m).
   21 mul, 15 add.
   Error <= u |result| + (lin: 1/16, ang: 5/32) u^2 S, S the sum of the |terms| of the expanded
     formula; barring over- and underflow. */
static inline void ksl_constraint_ctzf_accurate(const ksl_SE3f_t *D, const ksl_coscrewf_t *c,
    ksl_coscrewf_t *co) {
  const double w_0 = ksl_product_sum((double)D->m01, (double)c->m1, (double)D->m00 * (double)c->m0),
      w_1 = ksl_product_sum((double)D->m11, (double)c->m1, (double)D->m10 * (double)c->m0),
      w_2 = ksl_product_sum((double)D->m21, (double)c->m1, (double)D->m20 * (double)c->m0),
      w_3 = ksl_product_sum((double)D->m02, (double)c->m5, ksl_product_sum((double)D->m01,
          (double)c->m4, (double)D->m00 * (double)c->m3)),
      w_4 = ksl_product_sum((double)D->m12, (double)c->m5, ksl_product_sum((double)D->m11,
          (double)c->m4, (double)D->m10 * (double)c->m3)),
      w_5 = ksl_product_sum((double)D->m22, (double)c->m5, ksl_product_sum((double)D->m21,
          (double)c->m4, (double)D->m20 * (double)c->m3));
  const double co_3 = KSL_MUL((double)D->m13, w_2) - KSL_MUL((double)D->m23, w_1) + w_3,
      co_4 = KSL_MUL((double)D->m23, w_0) - KSL_MUL((double)D->m03, w_2) + w_4,
      co_5 = KSL_MUL((double)D->m03, w_1) - KSL_MUL((double)D->m13, w_0) + w_5;
  co->m0 = (float)w_0;
  co->m1 = (float)w_1;
  co->m2 = (float)w_2;
  co->m3 = (float)co_3;
  co->m4 = (float)co_4;
  co->m5 = (float)co_5;
}

/* co = H̄* c = [Ad]*(D) P c; P clears component 3 of c, given in the frame of a rx joint at D.
   D: displacement [R | t], R rotation, t in m; c, co: coscrew (f in N; τ in N m).
   21 mul, 15 add.
   Error <= u |result| + (lin: 3/32, ang: 3/16) u^2 S, S the sum of the |terms| of the expanded
     formula; barring over- and underflow. */
static inline void ksl_constraint_crxf_accurate(const ksl_SE3f_t *D, const ksl_coscrewf_t *c,
    ksl_coscrewf_t *co) {
  const double w_0 = ksl_product_sum((double)D->m02, (double)c->m2, ksl_product_sum((double)D->m01,
      (double)c->m1, (double)D->m00 * (double)c->m0)),
      w_1 = ksl_product_sum((double)D->m12, (double)c->m2, ksl_product_sum((double)D->m11,
          (double)c->m1, (double)D->m10 * (double)c->m0)),
      w_2 = ksl_product_sum((double)D->m22, (double)c->m2, ksl_product_sum((double)D->m21,
          (double)c->m1, (double)D->m20 * (double)c->m0)),
      w_3 = ksl_product_sum((double)D->m02, (double)c->m5, (double)D->m01 * (double)c->m4),
      w_4 = ksl_product_sum((double)D->m12, (double)c->m5, (double)D->m11 * (double)c->m4),
      w_5 = ksl_product_sum((double)D->m22, (double)c->m5, (double)D->m21 * (double)c->m4);
  const double co_3 = KSL_MUL((double)D->m13, w_2) - KSL_MUL((double)D->m23, w_1) + w_3,
      co_4 = KSL_MUL((double)D->m23, w_0) - KSL_MUL((double)D->m03, w_2) + w_4,
      co_5 = KSL_MUL((double)D->m03, w_1) - KSL_MUL((double)D->m13, w_0) + w_5;
  co->m0 = (float)w_0;
  co->m1 = (float)w_1;
  co->m2 = (float)w_2;
  co->m3 = (float)co_3;
  co->m4 = (float)co_4;
  co->m5 = (float)co_5;
}

/* co = H̄* c = [Ad]*(D) P c; P clears component 4 of c, given in the frame of a ry joint at D.
   D: displacement [R | t], R rotation, t in m; c, co: coscrew (f in N; τ in N m).
   21 mul, 15 add.
   Error <= u |result| + (lin: 3/32, ang: 3/16) u^2 S, S the sum of the |terms| of the expanded
     formula; barring over- and underflow. */
static inline void ksl_constraint_cryf_accurate(const ksl_SE3f_t *D, const ksl_coscrewf_t *c,
    ksl_coscrewf_t *co) {
  const double w_0 = ksl_product_sum((double)D->m02, (double)c->m2, ksl_product_sum((double)D->m01,
      (double)c->m1, (double)D->m00 * (double)c->m0)),
      w_1 = ksl_product_sum((double)D->m12, (double)c->m2, ksl_product_sum((double)D->m11,
          (double)c->m1, (double)D->m10 * (double)c->m0)),
      w_2 = ksl_product_sum((double)D->m22, (double)c->m2, ksl_product_sum((double)D->m21,
          (double)c->m1, (double)D->m20 * (double)c->m0)),
      w_3 = ksl_product_sum((double)D->m02, (double)c->m5, (double)D->m00 * (double)c->m3),
      w_4 = ksl_product_sum((double)D->m12, (double)c->m5, (double)D->m10 * (double)c->m3),
      w_5 = ksl_product_sum((double)D->m22, (double)c->m5, (double)D->m20 * (double)c->m3);
  const double co_3 = KSL_MUL((double)D->m13, w_2) - KSL_MUL((double)D->m23, w_1) + w_3,
      co_4 = KSL_MUL((double)D->m23, w_0) - KSL_MUL((double)D->m03, w_2) + w_4,
      co_5 = KSL_MUL((double)D->m03, w_1) - KSL_MUL((double)D->m13, w_0) + w_5;
  co->m0 = (float)w_0;
  co->m1 = (float)w_1;
  co->m2 = (float)w_2;
  co->m3 = (float)co_3;
  co->m4 = (float)co_4;
  co->m5 = (float)co_5;
}

/* co = H̄* c = [Ad]*(D) P c; P clears component 5 of c, given in the frame of a rz joint at D.
   D: displacement [R | t], R rotation, t in m; c, co: coscrew (f in N; τ in N m).
   21 mul, 15 add.
   Error <= u |result| + (lin: 3/32, ang: 3/16) u^2 S, S the sum of the |terms| of the expanded
     formula; barring over- and underflow. */
static inline void ksl_constraint_crzf_accurate(const ksl_SE3f_t *D, const ksl_coscrewf_t *c,
    ksl_coscrewf_t *co) {
  const double w_0 = ksl_product_sum((double)D->m02, (double)c->m2, ksl_product_sum((double)D->m01,
      (double)c->m1, (double)D->m00 * (double)c->m0)),
      w_1 = ksl_product_sum((double)D->m12, (double)c->m2, ksl_product_sum((double)D->m11,
          (double)c->m1, (double)D->m10 * (double)c->m0)),
      w_2 = ksl_product_sum((double)D->m22, (double)c->m2, ksl_product_sum((double)D->m21,
          (double)c->m1, (double)D->m20 * (double)c->m0)),
      w_3 = ksl_product_sum((double)D->m01, (double)c->m4, (double)D->m00 * (double)c->m3),
      w_4 = ksl_product_sum((double)D->m11, (double)c->m4, (double)D->m10 * (double)c->m3),
      w_5 = ksl_product_sum((double)D->m21, (double)c->m4, (double)D->m20 * (double)c->m3);
  const double co_3 = KSL_MUL((double)D->m13, w_2) - KSL_MUL((double)D->m23, w_1) + w_3,
      co_4 = KSL_MUL((double)D->m23, w_0) - KSL_MUL((double)D->m03, w_2) + w_4,
      co_5 = KSL_MUL((double)D->m03, w_1) - KSL_MUL((double)D->m13, w_0) + w_5;
  co->m0 = (float)w_0;
  co->m1 = (float)w_1;
  co->m2 = (float)w_2;
  co->m3 = (float)co_3;
  co->m4 = (float)co_4;
  co->m5 = (float)co_5;
}

/* co = h̄* c = [Ad]*(D) P c; P keeps component 0 of c, given in the frame of a tx joint at D.
   D: displacement [R | t], R rotation, t in m; c, co: coscrew (f in N; τ in N m).
   9 mul, 3 add.
   Error <= u |result| + (lin: 1/32, ang: 3/32) u^2 S, S the sum of the |terms| of the expanded
     formula; barring over- and underflow. */
static inline void ksl_working_ctxf_accurate(const ksl_SE3f_t *D, const ksl_coscrewf_t *c,
    ksl_coscrewf_t *co) {
  const double w_0 = (double)D->m00 * (double)c->m0, w_1 = (double)D->m10 * (double)c->m0,
      w_2 = (double)D->m20 * (double)c->m0;
  const double co_3 = KSL_MUL((double)D->m13, w_2) - KSL_MUL((double)D->m23, w_1),
      co_4 = KSL_MUL((double)D->m23, w_0) - KSL_MUL((double)D->m03, w_2),
      co_5 = KSL_MUL((double)D->m03, w_1) - KSL_MUL((double)D->m13, w_0);
  co->m0 = (float)w_0;
  co->m1 = (float)w_1;
  co->m2 = (float)w_2;
  co->m3 = (float)co_3;
  co->m4 = (float)co_4;
  co->m5 = (float)co_5;
}

/* co = h̄* c = [Ad]*(D) P c; P keeps component 1 of c, given in the frame of a ty joint at D.
   D: displacement [R | t], R rotation, t in m; c, co: coscrew (f in N; τ in N m).
   9 mul, 3 add.
   Error <= u |result| + (lin: 1/32, ang: 3/32) u^2 S, S the sum of the |terms| of the expanded
     formula; barring over- and underflow. */
static inline void ksl_working_ctyf_accurate(const ksl_SE3f_t *D, const ksl_coscrewf_t *c,
    ksl_coscrewf_t *co) {
  const double w_0 = (double)D->m01 * (double)c->m1, w_1 = (double)D->m11 * (double)c->m1,
      w_2 = (double)D->m21 * (double)c->m1;
  const double co_3 = KSL_MUL((double)D->m13, w_2) - KSL_MUL((double)D->m23, w_1),
      co_4 = KSL_MUL((double)D->m23, w_0) - KSL_MUL((double)D->m03, w_2),
      co_5 = KSL_MUL((double)D->m03, w_1) - KSL_MUL((double)D->m13, w_0);
  co->m0 = (float)w_0;
  co->m1 = (float)w_1;
  co->m2 = (float)w_2;
  co->m3 = (float)co_3;
  co->m4 = (float)co_4;
  co->m5 = (float)co_5;
}

/* co = h̄* c = [Ad]*(D) P c; P keeps component 2 of c, given in the frame of a tz joint at D.
   D: displacement [R | t], R rotation, t in m; c, co: coscrew (f in N; τ in N m).
   9 mul, 3 add.
   Error <= u |result| + (lin: 1/32, ang: 3/32) u^2 S, S the sum of the |terms| of the expanded
     formula; barring over- and underflow. */
static inline void ksl_working_ctzf_accurate(const ksl_SE3f_t *D, const ksl_coscrewf_t *c,
    ksl_coscrewf_t *co) {
  const double w_0 = (double)D->m02 * (double)c->m2, w_1 = (double)D->m12 * (double)c->m2,
      w_2 = (double)D->m22 * (double)c->m2;
  const double co_3 = KSL_MUL((double)D->m13, w_2) - KSL_MUL((double)D->m23, w_1),
      co_4 = KSL_MUL((double)D->m23, w_0) - KSL_MUL((double)D->m03, w_2),
      co_5 = KSL_MUL((double)D->m03, w_1) - KSL_MUL((double)D->m13, w_0);
  co->m0 = (float)w_0;
  co->m1 = (float)w_1;
  co->m2 = (float)w_2;
  co->m3 = (float)co_3;
  co->m4 = (float)co_4;
  co->m5 = (float)co_5;
}

/* co = h̄* c = [Ad]*(D) P c; P keeps component 3 of c, given in the frame of a rx joint at D.
   D: displacement [R | t], R rotation, t in m; c, co: coscrew (f in N; τ in N m).
   3 mul.
   Error <= u |result| + (lin: 0, ang: 1/32) u^2 S, S the sum of the |terms| of the expanded
     formula; barring over- and underflow. */
static inline void ksl_working_crxf_accurate(const ksl_SE3f_t *D, const ksl_coscrewf_t *c,
    ksl_coscrewf_t *co) {
  const double w_3 = (double)D->m00 * (double)c->m3, w_4 = (double)D->m10 * (double)c->m3,
      w_5 = (double)D->m20 * (double)c->m3;
  co->m0 = (float)0.0;
  co->m1 = (float)0.0;
  co->m2 = (float)0.0;
  co->m3 = (float)w_3;
  co->m4 = (float)w_4;
  co->m5 = (float)w_5;
}

/* co = h̄* c = [Ad]*(D) P c; P keeps component 4 of c, given in the frame of a ry joint at D.
   D: displacement [R | t], R rotation, t in m; c, co: coscrew (f in N; τ in N m).
   3 mul.
   Error <= u |result| + (lin: 0, ang: 1/32) u^2 S, S the sum of the |terms| of the expanded
     formula; barring over- and underflow. */
static inline void ksl_working_cryf_accurate(const ksl_SE3f_t *D, const ksl_coscrewf_t *c,
    ksl_coscrewf_t *co) {
  const double w_3 = (double)D->m01 * (double)c->m4, w_4 = (double)D->m11 * (double)c->m4,
      w_5 = (double)D->m21 * (double)c->m4;
  co->m0 = (float)0.0;
  co->m1 = (float)0.0;
  co->m2 = (float)0.0;
  co->m3 = (float)w_3;
  co->m4 = (float)w_4;
  co->m5 = (float)w_5;
}

/* co = h̄* c = [Ad]*(D) P c; P keeps component 5 of c, given in the frame of a rz joint at D.
   D: displacement [R | t], R rotation, t in m; c, co: coscrew (f in N; τ in N m).
   3 mul.
   Error <= u |result| + (lin: 0, ang: 1/32) u^2 S, S the sum of the |terms| of the expanded
     formula; barring over- and underflow. */
static inline void ksl_working_crzf_accurate(const ksl_SE3f_t *D, const ksl_coscrewf_t *c,
    ksl_coscrewf_t *co) {
  const double w_3 = (double)D->m02 * (double)c->m5, w_4 = (double)D->m12 * (double)c->m5,
      w_5 = (double)D->m22 * (double)c->m5;
  co->m0 = (float)0.0;
  co->m1 = (float)0.0;
  co->m2 = (float)0.0;
  co->m3 = (float)w_3;
  co->m4 = (float)w_4;
  co->m5 = (float)w_5;
}

#endif
