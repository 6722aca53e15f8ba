/* Made by `coscrew generate`; changes are overwritten. */
/* SPDX-License-Identifier: MIT */
/* coscrew 0.2.0.  Copyright (c) 2026 The coscrew authors. */
/* Quaternions q = (v; w), the scalar last: products, rotations, conversions, interpolation.
   Accurate tier: double compensated, single computed in double. */
#ifndef KSL_QUATERNION_ACCURATE_H
#define KSL_QUATERNION_ACCURATE_H

#include "ksl_exact.h"
#include "elementary.h"
#include "ksl_elementary_error.h"

/* self = a self.
   self: quaternion (x, y, z, w), the scalar last; a: number.
   4 mul, 4 add, 4 product error.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_quaternion_scale_accurate(ksl_quaternion_t *self, const double a) {
  const double self_0_new = KSL_MUL(self->x, a);
  const double self_1_new = KSL_MUL(self->y, a);
  const double self_2_new = KSL_MUL(self->z, a);
  const double self_3_new = KSL_MUL(self->w, a);
  const double self_0_new_lo = ksl_product_error(self->x, a, self_0_new),
      self_0_new_rounded = self_0_new + self_0_new_lo;
  const double self_1_new_lo = ksl_product_error(self->y, a, self_1_new),
      self_1_new_rounded = self_1_new + self_1_new_lo;
  const double self_2_new_lo = ksl_product_error(self->z, a, self_2_new),
      self_2_new_rounded = self_2_new + self_2_new_lo;
  const double self_3_new_lo = ksl_product_error(self->w, a, self_3_new),
      self_3_new_rounded = self_3_new + self_3_new_lo;
  self->x = self_0_new_rounded;
  self->y = self_1_new_rounded;
  self->z = self_2_new_rounded;
  self->w = self_3_new_rounded;
}

/* y = a x + y.
   a: number; x, y: quaternion (x, y, z, w), the scalar last.
   4 mul, 24 add, 4 product rest.
   Error <= u |result| + 3 u^2 S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_axpy_qq_accurate(const double a, const ksl_quaternion_t *x,
    ksl_quaternion_t *y) {
  const double y_0_new_a = KSL_MUL(a, x->x), y_0_new = y_0_new_a + y->x,
      y_0_new_right = y_0_new - y_0_new_a, y_0_new_left = y_0_new - y_0_new_right,
      y_0_new_left_rest = ksl_product_rest(a, x->x, y_0_new_a, y_0_new_left),
      y_0_new_right_rest = y->x - y_0_new_right,
      y_0_new_lo = y_0_new_left_rest + y_0_new_right_rest;
  const double y_1_new_a = KSL_MUL(a, x->y), y_1_new = y_1_new_a + y->y,
      y_1_new_right = y_1_new - y_1_new_a, y_1_new_left = y_1_new - y_1_new_right,
      y_1_new_left_rest = ksl_product_rest(a, x->y, y_1_new_a, y_1_new_left),
      y_1_new_right_rest = y->y - y_1_new_right,
      y_1_new_lo = y_1_new_left_rest + y_1_new_right_rest;
  const double y_2_new_a = KSL_MUL(a, x->z), y_2_new = y_2_new_a + y->z,
      y_2_new_right = y_2_new - y_2_new_a, y_2_new_left = y_2_new - y_2_new_right,
      y_2_new_left_rest = ksl_product_rest(a, x->z, y_2_new_a, y_2_new_left),
      y_2_new_right_rest = y->z - y_2_new_right,
      y_2_new_lo = y_2_new_left_rest + y_2_new_right_rest;
  const double y_3_new_a = KSL_MUL(a, x->w), y_3_new = y_3_new_a + y->w,
      y_3_new_right = y_3_new - y_3_new_a, y_3_new_left = y_3_new - y_3_new_right,
      y_3_new_left_rest = ksl_product_rest(a, x->w, y_3_new_a, y_3_new_left),
      y_3_new_right_rest = y->w - y_3_new_right,
      y_3_new_lo = y_3_new_left_rest + y_3_new_right_rest;
  const double y_0_new_rounded = y_0_new + y_0_new_lo;
  const double y_1_new_rounded = y_1_new + y_1_new_lo;
  const double y_2_new_rounded = y_2_new + y_2_new_lo;
  const double y_3_new_rounded = y_3_new + y_3_new_lo;
  y->x = y_0_new_rounded;
  y->y = y_1_new_rounded;
  y->z = y_2_new_rounded;
  y->w = y_3_new_rounded;
}

/* |q| = sqrt(v·v + w^2).
   q: quaternion (x, y, z, w), the scalar last.
   12 mul, 35 add, 1 product error, 4 product rest, 2 div, 1 sqrt, 4 abs, 9 less, 2 equal, 11
     select.
   Each component is within 1 ulp as long as its condition is below 1e13; in single precision it
     is the nearest number, except near ties, as long as that is below 1e5; searched, not proved. */
static inline double ksl_quaternion_norm_accurate(const ksl_quaternion_t *q) {
  const double s_size_0 = fabs(q->x);
  const double s_size_1 = fabs(q->y);
  const double s_size_2 = fabs(q->z);
  const double s_size_3 = fabs(q->w);
  const double s_largest1 = s_size_0 < s_size_1 ? s_size_1 : s_size_0;
  const double s_largest2 = s_largest1 < s_size_2 ? s_size_2 : s_largest1;
  const double s_largest3 = s_largest2 < s_size_3 ? s_size_3 : s_largest2;
  const double s_b = 6.703903964971299e+153 < s_largest3 ? 3.7291703656001034e-155 : 1.0,
      s_d = s_largest3 < 256.0 ? 1.3093562431584567e+151 : s_b,
      s = s_largest3 < 1.955159272639747e-149 ? 1.0715086071862673e+301 : s_d;
  const double y_0 = KSL_MUL(q->x, s);
  const double y_1 = KSL_MUL(q->y, s);
  const double y_2 = KSL_MUL(q->z, s);
  const double y_3 = KSL_MUL(q->w, s);
  const double n_a = KSL_MUL(y_0, y_0), n_b = KSL_MUL(y_1, y_1), n_c = n_a + n_b,
      n_c_right = n_c - n_a, n_c_left = n_c - n_c_right,
      n_c_left_rest = ksl_product_rest(y_0, y_0, n_a, n_c_left),
      n_c_right_rest = ksl_product_rest(y_1, y_1, n_b, n_c_right),
      n_c_lo = n_c_left_rest + n_c_right_rest, n_d = KSL_MUL(y_2, y_2), n_e = n_c + n_d,
      n_e_right = n_e - n_c, n_e_left = n_e - n_e_right, n_e_left_rest = n_c - n_e_left,
      n_e_right_rest = ksl_product_rest(y_2, y_2, n_d, n_e_right),
      n_e_lo1 = n_e_left_rest + n_e_right_rest, n_e_lo = n_e_lo1 + n_c_lo, n_f = KSL_MUL(y_3, y_3),
      n_g = n_e + n_f, n_g_right = n_g - n_e, n_g_left = n_g - n_g_right,
      n_g_left_rest = n_e - n_g_left, n_g_right_rest = ksl_product_rest(y_3, y_3, n_f, n_g_right),
      n_g_lo1 = n_g_left_rest + n_g_right_rest, n_g_lo = n_g_lo1 + n_e_lo, n_of_n_g = n_g + n_g_lo,
      n_of_n_g_right = n_of_n_g - n_g, n_of_n_g_left = n_of_n_g - n_of_n_g_right,
      n_of_n_g_left_rest = n_g - n_of_n_g_left, n_of_n_g_right_rest = n_g_lo - n_of_n_g_right,
      n_of_n_g_lo = n_of_n_g_left_rest + n_of_n_g_right_rest, n = sqrt(n_of_n_g),
      n_product = KSL_MUL(n, n), n_product_error = ksl_product_error(n, n, n_product),
      n_rest = n_of_n_g - n_product, n_exact = n_rest - n_product_error,
      n_residual = n_exact + n_of_n_g_lo, n_twice = n + n, n_divisor = n == 0.0 ? 1.0 : n_twice,
      n_lo = n_residual / n_divisor;
  const double r_b = s < 1.0 ? 2.6815615859885194e+154 : 1.0,
      r_d = 1.0 < s ? 7.637340908749012e-152 : r_b,
      r = 1.3093562431584567e+151 < s ? 9.332636185032189e-302 : r_d;
  const double norm_of_n = n + n_lo, norm_of_n_right = norm_of_n - n,
      norm_of_n_left = norm_of_n - norm_of_n_right, norm_of_n_left_rest = n - norm_of_n_left,
      norm_of_n_right_rest = n_lo - norm_of_n_right,
      norm_of_n_lo = norm_of_n_left_rest + norm_of_n_right_rest, norm = KSL_MUL(norm_of_n, r),
      norm_inverse = 1.0 / r, norm_back = KSL_MUL(norm, norm_inverse),
      norm_lost = norm_of_n - norm_back, norm_rest = norm_lost + norm_of_n_lo,
      norm_lo = KSL_MUL(norm_rest, r);
  const double norm_rounded = norm + norm_lo,
      norm_final = norm_rounded == norm_rounded ? norm_rounded : norm;
  return norm_final;
}

/* self = self / |self|; zero stays zero.
   self: quaternion (x, y, z, w), the scalar last.
   33 mul, 86 add, 5 product error, 4 product rest, 10 div, 1 sqrt, 4 abs, 8 less, 6 equal, 15
     select.
   Each component is within 1 ulp as long as its condition is below 1e13; in single precision it
     is the nearest number, except near ties, as long as that is below 1e5; searched, not proved. */
static inline void ksl_quaternion_normalize_accurate(ksl_quaternion_t *self) {
  const double s_size_0 = fabs(self->x);
  const double s_size_1 = fabs(self->y);
  const double s_size_2 = fabs(self->z);
  const double s_size_3 = fabs(self->w);
  const double s_largest1 = s_size_0 < s_size_1 ? s_size_1 : s_size_0;
  const double s_largest2 = s_largest1 < s_size_2 ? s_size_2 : s_largest1;
  const double s_largest3 = s_largest2 < s_size_3 ? s_size_3 : s_largest2;
  const double s_b = 6.703903964971299e+153 < s_largest3 ? 3.7291703656001034e-155 : 1.0,
      s_d = s_largest3 < 256.0 ? 1.3093562431584567e+151 : s_b,
      s = s_largest3 < 1.955159272639747e-149 ? 1.0715086071862673e+301 : s_d;
  const double y_0 = KSL_MUL(self->x, s);
  const double y_1 = KSL_MUL(self->y, s);
  const double y_2 = KSL_MUL(self->z, s);
  const double y_3 = KSL_MUL(self->w, s);
  const double up = 1.0 < s ? s : 1.0;
  const double down = s < 1.0 ? s : 1.0;
  const double n_a = KSL_MUL(y_0, y_0), n_b = KSL_MUL(y_1, y_1), n_c = n_a + n_b,
      n_c_right = n_c - n_a, n_c_left = n_c - n_c_right,
      n_c_left_rest = ksl_product_rest(y_0, y_0, n_a, n_c_left),
      n_c_right_rest = ksl_product_rest(y_1, y_1, n_b, n_c_right),
      n_c_lo = n_c_left_rest + n_c_right_rest, n_d = KSL_MUL(y_2, y_2), n_e = n_c + n_d,
      n_e_right = n_e - n_c, n_e_left = n_e - n_e_right, n_e_left_rest = n_c - n_e_left,
      n_e_right_rest = ksl_product_rest(y_2, y_2, n_d, n_e_right),
      n_e_lo1 = n_e_left_rest + n_e_right_rest, n_e_lo = n_e_lo1 + n_c_lo, n_f = KSL_MUL(y_3, y_3),
      n_g = n_e + n_f, n_g_right = n_g - n_e, n_g_left = n_g - n_g_right,
      n_g_left_rest = n_e - n_g_left, n_g_right_rest = ksl_product_rest(y_3, y_3, n_f, n_g_right),
      n_g_lo1 = n_g_left_rest + n_g_right_rest, n_g_lo = n_g_lo1 + n_e_lo, n_of_n_g = n_g + n_g_lo,
      n_of_n_g_right = n_of_n_g - n_g, n_of_n_g_left = n_of_n_g - n_of_n_g_right,
      n_of_n_g_left_rest = n_g - n_of_n_g_left, n_of_n_g_right_rest = n_g_lo - n_of_n_g_right,
      n_of_n_g_lo = n_of_n_g_left_rest + n_of_n_g_right_rest, n = sqrt(n_of_n_g),
      n_product = KSL_MUL(n, n), n_product_error = ksl_product_error(n, n, n_product),
      n_rest = n_of_n_g - n_product, n_exact = n_rest - n_product_error,
      n_residual = n_exact + n_of_n_g_lo, n_twice = n + n, n_divisor = n == 0.0 ? 1.0 : n_twice,
      n_lo = n_residual / n_divisor;
  const double divisor_a_of_n = n + n_lo, divisor_a_of_n_right = divisor_a_of_n - n,
      divisor_a_of_n_left = divisor_a_of_n - divisor_a_of_n_right,
      divisor_a_of_n_left_rest = n - divisor_a_of_n_left,
      divisor_a_of_n_right_rest = n_lo - divisor_a_of_n_right,
      divisor_a_of_n_lo = divisor_a_of_n_left_rest + divisor_a_of_n_right_rest,
      divisor = divisor_a_of_n == 0.0 ? up : divisor_a_of_n,
      divisor_lo = divisor_a_of_n == 0.0 ? 0.0 : divisor_a_of_n_lo;
  const double sized_0 = KSL_MUL(self->x, up);
  const double sized_1 = KSL_MUL(self->y, up);
  const double sized_2 = KSL_MUL(self->z, up);
  const double sized_3 = KSL_MUL(self->w, up);
  const double quotient_0_of_divisor = divisor + divisor_lo,
      quotient_0_of_divisor_right = quotient_0_of_divisor - divisor,
      quotient_0_of_divisor_left = quotient_0_of_divisor - quotient_0_of_divisor_right,
      quotient_0_of_divisor_left_rest = divisor - quotient_0_of_divisor_left,
      quotient_0_of_divisor_right_rest = divisor_lo - quotient_0_of_divisor_right,
      quotient_0_of_divisor_lo = quotient_0_of_divisor_left_rest + quotient_0_of_divisor_right_rest,
      quotient_0 = sized_0 / quotient_0_of_divisor,
      quotient_0_product = KSL_MUL(quotient_0, quotient_0_of_divisor),
      quotient_0_product_error = ksl_product_error(quotient_0, quotient_0_of_divisor,
          quotient_0_product),
      quotient_0_rest = sized_0 - quotient_0_product,
      quotient_0_exact = quotient_0_rest - quotient_0_product_error,
      quotient_0_cross = KSL_MUL(quotient_0, quotient_0_of_divisor_lo),
      quotient_0_residual = quotient_0_exact - quotient_0_cross,
      quotient_0_lo = quotient_0_residual / quotient_0_of_divisor;
  const double quotient_1 = sized_1 / quotient_0_of_divisor,
      quotient_1_product = KSL_MUL(quotient_1, quotient_0_of_divisor),
      quotient_1_product_error = ksl_product_error(quotient_1, quotient_0_of_divisor,
          quotient_1_product),
      quotient_1_rest = sized_1 - quotient_1_product,
      quotient_1_exact = quotient_1_rest - quotient_1_product_error,
      quotient_1_cross = KSL_MUL(quotient_1, quotient_0_of_divisor_lo),
      quotient_1_residual = quotient_1_exact - quotient_1_cross,
      quotient_1_lo = quotient_1_residual / quotient_0_of_divisor;
  const double quotient_2 = sized_2 / quotient_0_of_divisor,
      quotient_2_product = KSL_MUL(quotient_2, quotient_0_of_divisor),
      quotient_2_product_error = ksl_product_error(quotient_2, quotient_0_of_divisor,
          quotient_2_product),
      quotient_2_rest = sized_2 - quotient_2_product,
      quotient_2_exact = quotient_2_rest - quotient_2_product_error,
      quotient_2_cross = KSL_MUL(quotient_2, quotient_0_of_divisor_lo),
      quotient_2_residual = quotient_2_exact - quotient_2_cross,
      quotient_2_lo = quotient_2_residual / quotient_0_of_divisor;
  const double quotient_3 = sized_3 / quotient_0_of_divisor,
      quotient_3_product = KSL_MUL(quotient_3, quotient_0_of_divisor),
      quotient_3_product_error = ksl_product_error(quotient_3, quotient_0_of_divisor,
          quotient_3_product),
      quotient_3_rest = sized_3 - quotient_3_product,
      quotient_3_exact = quotient_3_rest - quotient_3_product_error,
      quotient_3_cross = KSL_MUL(quotient_3, quotient_0_of_divisor_lo),
      quotient_3_residual = quotient_3_exact - quotient_3_cross,
      quotient_3_lo = quotient_3_residual / quotient_0_of_divisor;
  const double self_0_new_of_quotient_0 = quotient_0 + quotient_0_lo,
      self_0_new_of_quotient_0_right = self_0_new_of_quotient_0 - quotient_0,
      self_0_new_of_quotient_0_left = self_0_new_of_quotient_0 - self_0_new_of_quotient_0_right,
      self_0_new_of_quotient_0_left_rest = quotient_0 - self_0_new_of_quotient_0_left,
      self_0_new_of_quotient_0_right_rest = quotient_0_lo - self_0_new_of_quotient_0_right,
      self_0_new_of_quotient_0_lo = self_0_new_of_quotient_0_left_rest +
          self_0_new_of_quotient_0_right_rest,
      self_0_new = KSL_MUL(self_0_new_of_quotient_0, down), self_0_new_inverse = 1.0 / down,
      self_0_new_back = KSL_MUL(self_0_new, self_0_new_inverse),
      self_0_new_lost = self_0_new_of_quotient_0 - self_0_new_back,
      self_0_new_rest = self_0_new_lost + self_0_new_of_quotient_0_lo,
      self_0_new_lo = KSL_MUL(self_0_new_rest, down);
  const double self_1_new_of_quotient_1 = quotient_1 + quotient_1_lo,
      self_1_new_of_quotient_1_right = self_1_new_of_quotient_1 - quotient_1,
      self_1_new_of_quotient_1_left = self_1_new_of_quotient_1 - self_1_new_of_quotient_1_right,
      self_1_new_of_quotient_1_left_rest = quotient_1 - self_1_new_of_quotient_1_left,
      self_1_new_of_quotient_1_right_rest = quotient_1_lo - self_1_new_of_quotient_1_right,
      self_1_new_of_quotient_1_lo = self_1_new_of_quotient_1_left_rest +
          self_1_new_of_quotient_1_right_rest,
      self_1_new = KSL_MUL(self_1_new_of_quotient_1, down),
      self_1_new_back = KSL_MUL(self_1_new, self_0_new_inverse),
      self_1_new_lost = self_1_new_of_quotient_1 - self_1_new_back,
      self_1_new_rest = self_1_new_lost + self_1_new_of_quotient_1_lo,
      self_1_new_lo = KSL_MUL(self_1_new_rest, down);
  const double self_2_new_of_quotient_2 = quotient_2 + quotient_2_lo,
      self_2_new_of_quotient_2_right = self_2_new_of_quotient_2 - quotient_2,
      self_2_new_of_quotient_2_left = self_2_new_of_quotient_2 - self_2_new_of_quotient_2_right,
      self_2_new_of_quotient_2_left_rest = quotient_2 - self_2_new_of_quotient_2_left,
      self_2_new_of_quotient_2_right_rest = quotient_2_lo - self_2_new_of_quotient_2_right,
      self_2_new_of_quotient_2_lo = self_2_new_of_quotient_2_left_rest +
          self_2_new_of_quotient_2_right_rest,
      self_2_new = KSL_MUL(self_2_new_of_quotient_2, down),
      self_2_new_back = KSL_MUL(self_2_new, self_0_new_inverse),
      self_2_new_lost = self_2_new_of_quotient_2 - self_2_new_back,
      self_2_new_rest = self_2_new_lost + self_2_new_of_quotient_2_lo,
      self_2_new_lo = KSL_MUL(self_2_new_rest, down);
  const double self_3_new_of_quotient_3 = quotient_3 + quotient_3_lo,
      self_3_new_of_quotient_3_right = self_3_new_of_quotient_3 - quotient_3,
      self_3_new_of_quotient_3_left = self_3_new_of_quotient_3 - self_3_new_of_quotient_3_right,
      self_3_new_of_quotient_3_left_rest = quotient_3 - self_3_new_of_quotient_3_left,
      self_3_new_of_quotient_3_right_rest = quotient_3_lo - self_3_new_of_quotient_3_right,
      self_3_new_of_quotient_3_lo = self_3_new_of_quotient_3_left_rest +
          self_3_new_of_quotient_3_right_rest,
      self_3_new = KSL_MUL(self_3_new_of_quotient_3, down),
      self_3_new_back = KSL_MUL(self_3_new, self_0_new_inverse),
      self_3_new_lost = self_3_new_of_quotient_3 - self_3_new_back,
      self_3_new_rest = self_3_new_lost + self_3_new_of_quotient_3_lo,
      self_3_new_lo = KSL_MUL(self_3_new_rest, down);
  const double self_0_new_rounded = self_0_new + self_0_new_lo,
      self_0_new_final = self_0_new_rounded == self_0_new_rounded ? self_0_new_rounded : self_0_new;
  const double self_1_new_rounded = self_1_new + self_1_new_lo,
      self_1_new_final = self_1_new_rounded == self_1_new_rounded ? self_1_new_rounded : self_1_new;
  const double self_2_new_rounded = self_2_new + self_2_new_lo,
      self_2_new_final = self_2_new_rounded == self_2_new_rounded ? self_2_new_rounded : self_2_new;
  const double self_3_new_rounded = self_3_new + self_3_new_lo,
      self_3_new_final = self_3_new_rounded == self_3_new_rounded ? self_3_new_rounded : self_3_new;
  self->x = self_0_new_final;
  self->y = self_1_new_final;
  self->z = self_2_new_final;
  self->w = self_3_new_final;
}

/* qo = q / |q|; zero stays zero.
   q, qo: quaternion (x, y, z, w), the scalar last.
   33 mul, 86 add, 5 product error, 4 product rest, 10 div, 1 sqrt, 4 abs, 8 less, 6 equal, 15
     select.
   Each component is within 1 ulp as long as its condition is below 1e13; in single precision it
     is the nearest number, except near ties, as long as that is below 1e5; searched, not proved. */
static inline void ksl_quaternion_normalized_accurate(const ksl_quaternion_t *q,
    ksl_quaternion_t *qo) {
  const double s_size_0 = fabs(q->x);
  const double s_size_1 = fabs(q->y);
  const double s_size_2 = fabs(q->z);
  const double s_size_3 = fabs(q->w);
  const double s_largest1 = s_size_0 < s_size_1 ? s_size_1 : s_size_0;
  const double s_largest2 = s_largest1 < s_size_2 ? s_size_2 : s_largest1;
  const double s_largest3 = s_largest2 < s_size_3 ? s_size_3 : s_largest2;
  const double s_b = 6.703903964971299e+153 < s_largest3 ? 3.7291703656001034e-155 : 1.0,
      s_d = s_largest3 < 256.0 ? 1.3093562431584567e+151 : s_b,
      s = s_largest3 < 1.955159272639747e-149 ? 1.0715086071862673e+301 : s_d;
  const double y_0 = KSL_MUL(q->x, s);
  const double y_1 = KSL_MUL(q->y, s);
  const double y_2 = KSL_MUL(q->z, s);
  const double y_3 = KSL_MUL(q->w, s);
  const double up = 1.0 < s ? s : 1.0;
  const double down = s < 1.0 ? s : 1.0;
  const double n_a = KSL_MUL(y_0, y_0), n_b = KSL_MUL(y_1, y_1), n_c = n_a + n_b,
      n_c_right = n_c - n_a, n_c_left = n_c - n_c_right,
      n_c_left_rest = ksl_product_rest(y_0, y_0, n_a, n_c_left),
      n_c_right_rest = ksl_product_rest(y_1, y_1, n_b, n_c_right),
      n_c_lo = n_c_left_rest + n_c_right_rest, n_d = KSL_MUL(y_2, y_2), n_e = n_c + n_d,
      n_e_right = n_e - n_c, n_e_left = n_e - n_e_right, n_e_left_rest = n_c - n_e_left,
      n_e_right_rest = ksl_product_rest(y_2, y_2, n_d, n_e_right),
      n_e_lo1 = n_e_left_rest + n_e_right_rest, n_e_lo = n_e_lo1 + n_c_lo, n_f = KSL_MUL(y_3, y_3),
      n_g = n_e + n_f, n_g_right = n_g - n_e, n_g_left = n_g - n_g_right,
      n_g_left_rest = n_e - n_g_left, n_g_right_rest = ksl_product_rest(y_3, y_3, n_f, n_g_right),
      n_g_lo1 = n_g_left_rest + n_g_right_rest, n_g_lo = n_g_lo1 + n_e_lo, n_of_n_g = n_g + n_g_lo,
      n_of_n_g_right = n_of_n_g - n_g, n_of_n_g_left = n_of_n_g - n_of_n_g_right,
      n_of_n_g_left_rest = n_g - n_of_n_g_left, n_of_n_g_right_rest = n_g_lo - n_of_n_g_right,
      n_of_n_g_lo = n_of_n_g_left_rest + n_of_n_g_right_rest, n = sqrt(n_of_n_g),
      n_product = KSL_MUL(n, n), n_product_error = ksl_product_error(n, n, n_product),
      n_rest = n_of_n_g - n_product, n_exact = n_rest - n_product_error,
      n_residual = n_exact + n_of_n_g_lo, n_twice = n + n, n_divisor = n == 0.0 ? 1.0 : n_twice,
      n_lo = n_residual / n_divisor;
  const double divisor_a_of_n = n + n_lo, divisor_a_of_n_right = divisor_a_of_n - n,
      divisor_a_of_n_left = divisor_a_of_n - divisor_a_of_n_right,
      divisor_a_of_n_left_rest = n - divisor_a_of_n_left,
      divisor_a_of_n_right_rest = n_lo - divisor_a_of_n_right,
      divisor_a_of_n_lo = divisor_a_of_n_left_rest + divisor_a_of_n_right_rest,
      divisor = divisor_a_of_n == 0.0 ? up : divisor_a_of_n,
      divisor_lo = divisor_a_of_n == 0.0 ? 0.0 : divisor_a_of_n_lo;
  const double sized_0 = KSL_MUL(q->x, up);
  const double sized_1 = KSL_MUL(q->y, up);
  const double sized_2 = KSL_MUL(q->z, up);
  const double sized_3 = KSL_MUL(q->w, up);
  const double quotient_0_of_divisor = divisor + divisor_lo,
      quotient_0_of_divisor_right = quotient_0_of_divisor - divisor,
      quotient_0_of_divisor_left = quotient_0_of_divisor - quotient_0_of_divisor_right,
      quotient_0_of_divisor_left_rest = divisor - quotient_0_of_divisor_left,
      quotient_0_of_divisor_right_rest = divisor_lo - quotient_0_of_divisor_right,
      quotient_0_of_divisor_lo = quotient_0_of_divisor_left_rest + quotient_0_of_divisor_right_rest,
      quotient_0 = sized_0 / quotient_0_of_divisor,
      quotient_0_product = KSL_MUL(quotient_0, quotient_0_of_divisor),
      quotient_0_product_error = ksl_product_error(quotient_0, quotient_0_of_divisor,
          quotient_0_product),
      quotient_0_rest = sized_0 - quotient_0_product,
      quotient_0_exact = quotient_0_rest - quotient_0_product_error,
      quotient_0_cross = KSL_MUL(quotient_0, quotient_0_of_divisor_lo),
      quotient_0_residual = quotient_0_exact - quotient_0_cross,
      quotient_0_lo = quotient_0_residual / quotient_0_of_divisor;
  const double quotient_1 = sized_1 / quotient_0_of_divisor,
      quotient_1_product = KSL_MUL(quotient_1, quotient_0_of_divisor),
      quotient_1_product_error = ksl_product_error(quotient_1, quotient_0_of_divisor,
          quotient_1_product),
      quotient_1_rest = sized_1 - quotient_1_product,
      quotient_1_exact = quotient_1_rest - quotient_1_product_error,
      quotient_1_cross = KSL_MUL(quotient_1, quotient_0_of_divisor_lo),
      quotient_1_residual = quotient_1_exact - quotient_1_cross,
      quotient_1_lo = quotient_1_residual / quotient_0_of_divisor;
  const double quotient_2 = sized_2 / quotient_0_of_divisor,
      quotient_2_product = KSL_MUL(quotient_2, quotient_0_of_divisor),
      quotient_2_product_error = ksl_product_error(quotient_2, quotient_0_of_divisor,
          quotient_2_product),
      quotient_2_rest = sized_2 - quotient_2_product,
      quotient_2_exact = quotient_2_rest - quotient_2_product_error,
      quotient_2_cross = KSL_MUL(quotient_2, quotient_0_of_divisor_lo),
      quotient_2_residual = quotient_2_exact - quotient_2_cross,
      quotient_2_lo = quotient_2_residual / quotient_0_of_divisor;
  const double quotient_3 = sized_3 / quotient_0_of_divisor,
      quotient_3_product = KSL_MUL(quotient_3, quotient_0_of_divisor),
      quotient_3_product_error = ksl_product_error(quotient_3, quotient_0_of_divisor,
          quotient_3_product),
      quotient_3_rest = sized_3 - quotient_3_product,
      quotient_3_exact = quotient_3_rest - quotient_3_product_error,
      quotient_3_cross = KSL_MUL(quotient_3, quotient_0_of_divisor_lo),
      quotient_3_residual = quotient_3_exact - quotient_3_cross,
      quotient_3_lo = quotient_3_residual / quotient_0_of_divisor;
  const double qo_0_of_quotient_0 = quotient_0 + quotient_0_lo,
      qo_0_of_quotient_0_right = qo_0_of_quotient_0 - quotient_0,
      qo_0_of_quotient_0_left = qo_0_of_quotient_0 - qo_0_of_quotient_0_right,
      qo_0_of_quotient_0_left_rest = quotient_0 - qo_0_of_quotient_0_left,
      qo_0_of_quotient_0_right_rest = quotient_0_lo - qo_0_of_quotient_0_right,
      qo_0_of_quotient_0_lo = qo_0_of_quotient_0_left_rest + qo_0_of_quotient_0_right_rest,
      qo_0 = KSL_MUL(qo_0_of_quotient_0, down), qo_0_inverse = 1.0 / down,
      qo_0_back = KSL_MUL(qo_0, qo_0_inverse), qo_0_lost = qo_0_of_quotient_0 - qo_0_back,
      qo_0_rest = qo_0_lost + qo_0_of_quotient_0_lo, qo_0_lo = KSL_MUL(qo_0_rest, down);
  const double qo_1_of_quotient_1 = quotient_1 + quotient_1_lo,
      qo_1_of_quotient_1_right = qo_1_of_quotient_1 - quotient_1,
      qo_1_of_quotient_1_left = qo_1_of_quotient_1 - qo_1_of_quotient_1_right,
      qo_1_of_quotient_1_left_rest = quotient_1 - qo_1_of_quotient_1_left,
      qo_1_of_quotient_1_right_rest = quotient_1_lo - qo_1_of_quotient_1_right,
      qo_1_of_quotient_1_lo = qo_1_of_quotient_1_left_rest + qo_1_of_quotient_1_right_rest,
      qo_1 = KSL_MUL(qo_1_of_quotient_1, down), qo_1_back = KSL_MUL(qo_1, qo_0_inverse),
      qo_1_lost = qo_1_of_quotient_1 - qo_1_back, qo_1_rest = qo_1_lost + qo_1_of_quotient_1_lo,
      qo_1_lo = KSL_MUL(qo_1_rest, down);
  const double qo_2_of_quotient_2 = quotient_2 + quotient_2_lo,
      qo_2_of_quotient_2_right = qo_2_of_quotient_2 - quotient_2,
      qo_2_of_quotient_2_left = qo_2_of_quotient_2 - qo_2_of_quotient_2_right,
      qo_2_of_quotient_2_left_rest = quotient_2 - qo_2_of_quotient_2_left,
      qo_2_of_quotient_2_right_rest = quotient_2_lo - qo_2_of_quotient_2_right,
      qo_2_of_quotient_2_lo = qo_2_of_quotient_2_left_rest + qo_2_of_quotient_2_right_rest,
      qo_2 = KSL_MUL(qo_2_of_quotient_2, down), qo_2_back = KSL_MUL(qo_2, qo_0_inverse),
      qo_2_lost = qo_2_of_quotient_2 - qo_2_back, qo_2_rest = qo_2_lost + qo_2_of_quotient_2_lo,
      qo_2_lo = KSL_MUL(qo_2_rest, down);
  const double qo_3_of_quotient_3 = quotient_3 + quotient_3_lo,
      qo_3_of_quotient_3_right = qo_3_of_quotient_3 - quotient_3,
      qo_3_of_quotient_3_left = qo_3_of_quotient_3 - qo_3_of_quotient_3_right,
      qo_3_of_quotient_3_left_rest = quotient_3 - qo_3_of_quotient_3_left,
      qo_3_of_quotient_3_right_rest = quotient_3_lo - qo_3_of_quotient_3_right,
      qo_3_of_quotient_3_lo = qo_3_of_quotient_3_left_rest + qo_3_of_quotient_3_right_rest,
      qo_3 = KSL_MUL(qo_3_of_quotient_3, down), qo_3_back = KSL_MUL(qo_3, qo_0_inverse),
      qo_3_lost = qo_3_of_quotient_3 - qo_3_back, qo_3_rest = qo_3_lost + qo_3_of_quotient_3_lo,
      qo_3_lo = KSL_MUL(qo_3_rest, down);
  const double qo_0_rounded = qo_0 + qo_0_lo,
      qo_0_final = qo_0_rounded == qo_0_rounded ? qo_0_rounded : qo_0;
  const double qo_1_rounded = qo_1 + qo_1_lo,
      qo_1_final = qo_1_rounded == qo_1_rounded ? qo_1_rounded : qo_1;
  const double qo_2_rounded = qo_2 + qo_2_lo,
      qo_2_final = qo_2_rounded == qo_2_rounded ? qo_2_rounded : qo_2;
  const double qo_3_rounded = qo_3 + qo_3_lo,
      qo_3_final = qo_3_rounded == qo_3_rounded ? qo_3_rounded : qo_3;
  qo->x = qo_0_final;
  qo->y = qo_1_final;
  qo->z = qo_2_final;
  qo->w = qo_3_final;
}

/* |q| - 1: 0 for a unit quaternion, negative for a shorter one.
   q: quaternion (x, y, z, w), the scalar last.
   12 mul, 42 add, 1 product error, 4 product rest, 2 div, 1 sqrt, 4 abs, 9 less, 2 equal, 11
     select.
   Each component is within 1 ulp as long as its condition is below 1e13; in single precision it
     is the nearest number, except near ties, as long as that is below 1e5; searched, not proved. */
static inline double ksl_quaternion_unit_defect_accurate(const ksl_quaternion_t *q) {
  const double s_size_0 = fabs(q->x);
  const double s_size_1 = fabs(q->y);
  const double s_size_2 = fabs(q->z);
  const double s_size_3 = fabs(q->w);
  const double s_largest1 = s_size_0 < s_size_1 ? s_size_1 : s_size_0;
  const double s_largest2 = s_largest1 < s_size_2 ? s_size_2 : s_largest1;
  const double s_largest3 = s_largest2 < s_size_3 ? s_size_3 : s_largest2;
  const double s_b = 6.703903964971299e+153 < s_largest3 ? 3.7291703656001034e-155 : 1.0,
      s_d = s_largest3 < 256.0 ? 1.3093562431584567e+151 : s_b,
      s = s_largest3 < 1.955159272639747e-149 ? 1.0715086071862673e+301 : s_d;
  const double y_0 = KSL_MUL(q->x, s);
  const double y_1 = KSL_MUL(q->y, s);
  const double y_2 = KSL_MUL(q->z, s);
  const double y_3 = KSL_MUL(q->w, s);
  const double n_a = KSL_MUL(y_0, y_0), n_b = KSL_MUL(y_1, y_1), n_c = n_a + n_b,
      n_c_right = n_c - n_a, n_c_left = n_c - n_c_right,
      n_c_left_rest = ksl_product_rest(y_0, y_0, n_a, n_c_left),
      n_c_right_rest = ksl_product_rest(y_1, y_1, n_b, n_c_right),
      n_c_lo = n_c_left_rest + n_c_right_rest, n_d = KSL_MUL(y_2, y_2), n_e = n_c + n_d,
      n_e_right = n_e - n_c, n_e_left = n_e - n_e_right, n_e_left_rest = n_c - n_e_left,
      n_e_right_rest = ksl_product_rest(y_2, y_2, n_d, n_e_right),
      n_e_lo1 = n_e_left_rest + n_e_right_rest, n_e_lo = n_e_lo1 + n_c_lo, n_f = KSL_MUL(y_3, y_3),
      n_g = n_e + n_f, n_g_right = n_g - n_e, n_g_left = n_g - n_g_right,
      n_g_left_rest = n_e - n_g_left, n_g_right_rest = ksl_product_rest(y_3, y_3, n_f, n_g_right),
      n_g_lo1 = n_g_left_rest + n_g_right_rest, n_g_lo = n_g_lo1 + n_e_lo, n_of_n_g = n_g + n_g_lo,
      n_of_n_g_right = n_of_n_g - n_g, n_of_n_g_left = n_of_n_g - n_of_n_g_right,
      n_of_n_g_left_rest = n_g - n_of_n_g_left, n_of_n_g_right_rest = n_g_lo - n_of_n_g_right,
      n_of_n_g_lo = n_of_n_g_left_rest + n_of_n_g_right_rest, n = sqrt(n_of_n_g),
      n_product = KSL_MUL(n, n), n_product_error = ksl_product_error(n, n, n_product),
      n_rest = n_of_n_g - n_product, n_exact = n_rest - n_product_error,
      n_residual = n_exact + n_of_n_g_lo, n_twice = n + n, n_divisor = n == 0.0 ? 1.0 : n_twice,
      n_lo = n_residual / n_divisor;
  const double r_b = s < 1.0 ? 2.6815615859885194e+154 : 1.0,
      r_d = 1.0 < s ? 7.637340908749012e-152 : r_b,
      r = 1.3093562431584567e+151 < s ? 9.332636185032189e-302 : r_d;
  const double length_of_n = n + n_lo, length_of_n_right = length_of_n - n,
      length_of_n_left = length_of_n - length_of_n_right,
      length_of_n_left_rest = n - length_of_n_left,
      length_of_n_right_rest = n_lo - length_of_n_right,
      length_of_n_lo = length_of_n_left_rest + length_of_n_right_rest,
      length = KSL_MUL(length_of_n, r), length_inverse = 1.0 / r,
      length_back = KSL_MUL(length, length_inverse), length_lost = length_of_n - length_back,
      length_rest = length_lost + length_of_n_lo, length_lo = KSL_MUL(length_rest, r);
  const double defect = length - 1.0, defect_right = length - defect,
      defect_left = defect + defect_right, defect_left_rest = length - defect_left,
      defect_right_rest = 1.0 - defect_right, defect_lo1 = defect_left_rest - defect_right_rest,
      defect_lo = defect_lo1 + length_lo;
  const double defect_rounded = defect + defect_lo,
      defect_final = defect_rounded == defect_rounded ? defect_rounded : defect;
  return defect_final;
}

/* qo = q / |q|, the unit quaternion nearest to q; NaN for zero, which has none.
   q, qo: quaternion (x, y, z, w), the scalar last.
   17 mul, 54 add, 5 product error, 4 product rest, 9 div, 1 sqrt, 4 abs, 6 less, 6 equal, 21
     select.
   Each component is within 1 ulp as long as its condition is below 1e13; in single precision it
     is the nearest number, except near ties, as long as that is below 1e5; searched, not proved. */
static inline void ksl_quaternion_nearest_unit_accurate(const ksl_quaternion_t *q,
    ksl_quaternion_t *qo) {
  const double s_size_0 = fabs(q->x);
  const double s_size_1 = fabs(q->y);
  const double s_size_2 = fabs(q->z);
  const double s_size_3 = fabs(q->w);
  const double s_largest1 = s_size_0 < s_size_1 ? s_size_1 : s_size_0;
  const double s_largest2 = s_largest1 < s_size_2 ? s_size_2 : s_largest1;
  const double s_largest3 = s_largest2 < s_size_3 ? s_size_3 : s_largest2;
  const double s_b = 6.703903964971299e+153 < s_largest3 ? 3.7291703656001034e-155 : 1.0,
      s_d = s_largest3 < 256.0 ? 1.3093562431584567e+151 : s_b,
      s = s_largest3 < 1.955159272639747e-149 ? 1.0715086071862673e+301 : s_d;
  const double scaled_s_0 = KSL_MUL(q->x, s);
  const double scaled_s_1 = KSL_MUL(q->y, s);
  const double scaled_s_2 = KSL_MUL(q->z, s);
  const double scaled_s_3 = KSL_MUL(q->w, s);
  const double n_a = KSL_MUL(scaled_s_0, scaled_s_0), n_b = KSL_MUL(scaled_s_1, scaled_s_1),
      n_c = n_a + n_b, n_c_right = n_c - n_a, n_c_left = n_c - n_c_right,
      n_c_left_rest = ksl_product_rest(scaled_s_0, scaled_s_0, n_a, n_c_left),
      n_c_right_rest = ksl_product_rest(scaled_s_1, scaled_s_1, n_b, n_c_right),
      n_c_lo = n_c_left_rest + n_c_right_rest, n_d = KSL_MUL(scaled_s_2, scaled_s_2),
      n_e = n_c + n_d, n_e_right = n_e - n_c, n_e_left = n_e - n_e_right,
      n_e_left_rest = n_c - n_e_left,
      n_e_right_rest = ksl_product_rest(scaled_s_2, scaled_s_2, n_d, n_e_right),
      n_e_lo1 = n_e_left_rest + n_e_right_rest, n_e_lo = n_e_lo1 + n_c_lo,
      n_f = KSL_MUL(scaled_s_3, scaled_s_3), n_g = n_e + n_f, n_g_right = n_g - n_e,
      n_g_left = n_g - n_g_right, n_g_left_rest = n_e - n_g_left,
      n_g_right_rest = ksl_product_rest(scaled_s_3, scaled_s_3, n_f, n_g_right),
      n_g_lo1 = n_g_left_rest + n_g_right_rest, n_g_lo = n_g_lo1 + n_e_lo, n_of_n_g = n_g + n_g_lo,
      n_of_n_g_right = n_of_n_g - n_g, n_of_n_g_left = n_of_n_g - n_of_n_g_right,
      n_of_n_g_left_rest = n_g - n_of_n_g_left, n_of_n_g_right_rest = n_g_lo - n_of_n_g_right,
      n_of_n_g_lo = n_of_n_g_left_rest + n_of_n_g_right_rest, n = sqrt(n_of_n_g),
      n_product = KSL_MUL(n, n), n_product_error = ksl_product_error(n, n, n_product),
      n_rest = n_of_n_g - n_product, n_exact = n_rest - n_product_error,
      n_residual = n_exact + n_of_n_g_lo, n_twice = n + n, n_divisor = n == 0.0 ? 1.0 : n_twice,
      n_lo = n_residual / n_divisor;
  const double divisor_a_of_n = n + n_lo, divisor_a_of_n_right = divisor_a_of_n - n,
      divisor_a_of_n_left = divisor_a_of_n - divisor_a_of_n_right,
      divisor_a_of_n_left_rest = n - divisor_a_of_n_left,
      divisor_a_of_n_right_rest = n_lo - divisor_a_of_n_right,
      divisor_a_of_n_lo = divisor_a_of_n_left_rest + divisor_a_of_n_right_rest,
      divisor = divisor_a_of_n == 0.0 ? 1.0 : divisor_a_of_n,
      divisor_lo = divisor_a_of_n == 0.0 ? 0.0 : divisor_a_of_n_lo;
  const double unit_0_of_divisor = divisor + divisor_lo,
      unit_0_of_divisor_right = unit_0_of_divisor - divisor,
      unit_0_of_divisor_left = unit_0_of_divisor - unit_0_of_divisor_right,
      unit_0_of_divisor_left_rest = divisor - unit_0_of_divisor_left,
      unit_0_of_divisor_right_rest = divisor_lo - unit_0_of_divisor_right,
      unit_0_of_divisor_lo = unit_0_of_divisor_left_rest + unit_0_of_divisor_right_rest,
      unit_0 = scaled_s_0 / unit_0_of_divisor, unit_0_product = KSL_MUL(unit_0, unit_0_of_divisor),
      unit_0_product_error = ksl_product_error(unit_0, unit_0_of_divisor, unit_0_product),
      unit_0_rest = scaled_s_0 - unit_0_product, unit_0_exact = unit_0_rest - unit_0_product_error,
      unit_0_cross = KSL_MUL(unit_0, unit_0_of_divisor_lo),
      unit_0_residual = unit_0_exact - unit_0_cross,
      unit_0_lo = unit_0_residual / unit_0_of_divisor;
  const double unit_1 = scaled_s_1 / unit_0_of_divisor,
      unit_1_product = KSL_MUL(unit_1, unit_0_of_divisor),
      unit_1_product_error = ksl_product_error(unit_1, unit_0_of_divisor, unit_1_product),
      unit_1_rest = scaled_s_1 - unit_1_product, unit_1_exact = unit_1_rest - unit_1_product_error,
      unit_1_cross = KSL_MUL(unit_1, unit_0_of_divisor_lo),
      unit_1_residual = unit_1_exact - unit_1_cross,
      unit_1_lo = unit_1_residual / unit_0_of_divisor;
  const double unit_2 = scaled_s_2 / unit_0_of_divisor,
      unit_2_product = KSL_MUL(unit_2, unit_0_of_divisor),
      unit_2_product_error = ksl_product_error(unit_2, unit_0_of_divisor, unit_2_product),
      unit_2_rest = scaled_s_2 - unit_2_product, unit_2_exact = unit_2_rest - unit_2_product_error,
      unit_2_cross = KSL_MUL(unit_2, unit_0_of_divisor_lo),
      unit_2_residual = unit_2_exact - unit_2_cross,
      unit_2_lo = unit_2_residual / unit_0_of_divisor;
  const double unit_3 = scaled_s_3 / unit_0_of_divisor,
      unit_3_product = KSL_MUL(unit_3, unit_0_of_divisor),
      unit_3_product_error = ksl_product_error(unit_3, unit_0_of_divisor, unit_3_product),
      unit_3_rest = scaled_s_3 - unit_3_product, unit_3_exact = unit_3_rest - unit_3_product_error,
      unit_3_cross = KSL_MUL(unit_3, unit_0_of_divisor_lo),
      unit_3_residual = unit_3_exact - unit_3_cross,
      unit_3_lo = unit_3_residual / unit_0_of_divisor;
  const double qo_0 = divisor_a_of_n == 0.0 ? (double)NAN : unit_0,
      qo_0_lo = divisor_a_of_n == 0.0 ? 0.0 : unit_0_lo;
  const double qo_1 = divisor_a_of_n == 0.0 ? (double)NAN : unit_1,
      qo_1_lo = divisor_a_of_n == 0.0 ? 0.0 : unit_1_lo;
  const double qo_2 = divisor_a_of_n == 0.0 ? (double)NAN : unit_2,
      qo_2_lo = divisor_a_of_n == 0.0 ? 0.0 : unit_2_lo;
  const double qo_3 = divisor_a_of_n == 0.0 ? (double)NAN : unit_3,
      qo_3_lo = divisor_a_of_n == 0.0 ? 0.0 : unit_3_lo;
  const double qo_0_rounded = qo_0 + qo_0_lo,
      qo_0_final = qo_0_rounded == qo_0_rounded ? qo_0_rounded : qo_0;
  const double qo_1_rounded = qo_1 + qo_1_lo,
      qo_1_final = qo_1_rounded == qo_1_rounded ? qo_1_rounded : qo_1;
  const double qo_2_rounded = qo_2 + qo_2_lo,
      qo_2_final = qo_2_rounded == qo_2_rounded ? qo_2_rounded : qo_2;
  const double qo_3_rounded = qo_3 + qo_3_lo,
      qo_3_final = qo_3_rounded == qo_3_rounded ? qo_3_rounded : qo_3;
  qo->x = qo_0_final;
  qo->y = qo_1_final;
  qo->z = qo_2_final;
  qo->w = qo_3_final;
}

/* vo = R(q) v, |q| = 1.
   q: quaternion (x, y, z, w), the scalar last; v, vo: vector.
   30 mul, 75 add, 15 product rest.
   Error <= u |result| + 34 u^2 S, S the sum of the |terms| of the expanded formula; barring
     over- and underflow. */
static inline void ksl_rotate_qv_accurate(const ksl_quaternion_t *q, const ksl_vec3_t *v,
    ksl_vec3_t *vo) {
  const double c_0a = KSL_MUL(q->y, v->z), c_0b = KSL_MUL(q->z, v->y), c_0 = c_0a - c_0b,
      c_0_right = c_0a - c_0, c_0_left = c_0 + c_0_right,
      c_0_left_rest = ksl_product_rest(q->y, v->z, c_0a, c_0_left),
      c_0_right_rest = ksl_product_rest(q->z, v->y, c_0b, c_0_right),
      c_0_lo = c_0_left_rest - c_0_right_rest;
  const double c_1a = KSL_MUL(q->z, v->x), c_1b = KSL_MUL(q->x, v->z), c_1 = c_1a - c_1b,
      c_1_right = c_1a - c_1, c_1_left = c_1 + c_1_right,
      c_1_left_rest = ksl_product_rest(q->z, v->x, c_1a, c_1_left),
      c_1_right_rest = ksl_product_rest(q->x, v->z, c_1b, c_1_right),
      c_1_lo = c_1_left_rest - c_1_right_rest;
  const double c_2a = KSL_MUL(q->x, v->y), c_2b = KSL_MUL(q->y, v->x), c_2 = c_2a - c_2b,
      c_2_right = c_2a - c_2, c_2_left = c_2 + c_2_right,
      c_2_left_rest = ksl_product_rest(q->x, v->y, c_2a, c_2_left),
      c_2_right_rest = ksl_product_rest(q->y, v->x, c_2b, c_2_right),
      c_2_lo = c_2_left_rest - c_2_right_rest;
  const double t_0 = KSL_MUL(2.0, c_0), t_0_cross2 = KSL_MUL(2.0, c_0_lo);
  const double t_1 = KSL_MUL(2.0, c_1), t_1_cross2 = KSL_MUL(2.0, c_1_lo);
  const double t_2 = KSL_MUL(2.0, c_2), t_2_cross2 = KSL_MUL(2.0, c_2_lo);
  const double turn_0a = KSL_MUL(q->y, t_2), turn_0a_cross2 = KSL_MUL(q->y, t_2_cross2),
      turn_0b = KSL_MUL(q->z, t_1), turn_0b_cross2 = KSL_MUL(q->z, t_1_cross2),
      turn_0c = turn_0a - turn_0b, turn_0c_right = turn_0a - turn_0c,
      turn_0c_left = turn_0c + turn_0c_right,
      turn_0c_left_rest = ksl_product_rest(q->y, t_2, turn_0a, turn_0c_left),
      turn_0c_right_rest = ksl_product_rest(q->z, t_1, turn_0b, turn_0c_right),
      turn_0c_cross = turn_0a_cross2 - turn_0b_cross2,
      turn_0c_lo1 = turn_0c_left_rest - turn_0c_right_rest,
      turn_0c_lo = turn_0c_lo1 + turn_0c_cross, turn_0d = KSL_MUL(q->w, t_0),
      turn_0d_cross2 = KSL_MUL(q->w, t_0_cross2), turn_0 = turn_0c + turn_0d,
      turn_0_right = turn_0 - turn_0c, turn_0_left = turn_0 - turn_0_right,
      turn_0_left_rest = turn_0c - turn_0_left,
      turn_0_right_rest = ksl_product_rest(q->w, t_0, turn_0d, turn_0_right),
      turn_0_lo1 = turn_0_left_rest + turn_0_right_rest, turn_0_lo2 = turn_0_lo1 + turn_0d_cross2,
      turn_0_lo = turn_0_lo2 + turn_0c_lo;
  const double turn_1a = KSL_MUL(q->z, t_0), turn_1a_cross2 = KSL_MUL(q->z, t_0_cross2),
      turn_1b = KSL_MUL(q->x, t_2), turn_1b_cross2 = KSL_MUL(q->x, t_2_cross2),
      turn_1c = turn_1a - turn_1b, turn_1c_right = turn_1a - turn_1c,
      turn_1c_left = turn_1c + turn_1c_right,
      turn_1c_left_rest = ksl_product_rest(q->z, t_0, turn_1a, turn_1c_left),
      turn_1c_right_rest = ksl_product_rest(q->x, t_2, turn_1b, turn_1c_right),
      turn_1c_cross = turn_1a_cross2 - turn_1b_cross2,
      turn_1c_lo1 = turn_1c_left_rest - turn_1c_right_rest,
      turn_1c_lo = turn_1c_lo1 + turn_1c_cross, turn_1d = KSL_MUL(q->w, t_1),
      turn_1d_cross2 = KSL_MUL(q->w, t_1_cross2), turn_1 = turn_1c + turn_1d,
      turn_1_right = turn_1 - turn_1c, turn_1_left = turn_1 - turn_1_right,
      turn_1_left_rest = turn_1c - turn_1_left,
      turn_1_right_rest = ksl_product_rest(q->w, t_1, turn_1d, turn_1_right),
      turn_1_lo1 = turn_1_left_rest + turn_1_right_rest, turn_1_lo2 = turn_1_lo1 + turn_1d_cross2,
      turn_1_lo = turn_1_lo2 + turn_1c_lo;
  const double turn_2a = KSL_MUL(q->x, t_1), turn_2a_cross2 = KSL_MUL(q->x, t_1_cross2),
      turn_2b = KSL_MUL(q->y, t_0), turn_2b_cross2 = KSL_MUL(q->y, t_0_cross2),
      turn_2c = turn_2a - turn_2b, turn_2c_right = turn_2a - turn_2c,
      turn_2c_left = turn_2c + turn_2c_right,
      turn_2c_left_rest = ksl_product_rest(q->x, t_1, turn_2a, turn_2c_left),
      turn_2c_right_rest = ksl_product_rest(q->y, t_0, turn_2b, turn_2c_right),
      turn_2c_cross = turn_2a_cross2 - turn_2b_cross2,
      turn_2c_lo1 = turn_2c_left_rest - turn_2c_right_rest,
      turn_2c_lo = turn_2c_lo1 + turn_2c_cross, turn_2d = KSL_MUL(q->w, t_2),
      turn_2d_cross2 = KSL_MUL(q->w, t_2_cross2), turn_2 = turn_2c + turn_2d,
      turn_2_right = turn_2 - turn_2c, turn_2_left = turn_2 - turn_2_right,
      turn_2_left_rest = turn_2c - turn_2_left,
      turn_2_right_rest = ksl_product_rest(q->w, t_2, turn_2d, turn_2_right),
      turn_2_lo1 = turn_2_left_rest + turn_2_right_rest, turn_2_lo2 = turn_2_lo1 + turn_2d_cross2,
      turn_2_lo = turn_2_lo2 + turn_2c_lo;
  const double vo_0 = v->x + turn_0, vo_0_right = vo_0 - v->x, vo_0_left = vo_0 - vo_0_right,
      vo_0_left_rest = v->x - vo_0_left, vo_0_right_rest = turn_0 - vo_0_right,
      vo_0_lo1 = vo_0_left_rest + vo_0_right_rest, vo_0_lo = vo_0_lo1 + turn_0_lo;
  const double vo_1 = v->y + turn_1, vo_1_right = vo_1 - v->y, vo_1_left = vo_1 - vo_1_right,
      vo_1_left_rest = v->y - vo_1_left, vo_1_right_rest = turn_1 - vo_1_right,
      vo_1_lo1 = vo_1_left_rest + vo_1_right_rest, vo_1_lo = vo_1_lo1 + turn_1_lo;
  const double vo_2 = v->z + turn_2, vo_2_right = vo_2 - v->z, vo_2_left = vo_2 - vo_2_right,
      vo_2_left_rest = v->z - vo_2_left, vo_2_right_rest = turn_2 - vo_2_right,
      vo_2_lo1 = vo_2_left_rest + vo_2_right_rest, vo_2_lo = vo_2_lo1 + turn_2_lo;
  const double vo_0_rounded = vo_0 + vo_0_lo;
  const double vo_1_rounded = vo_1 + vo_1_lo;
  const double vo_2_rounded = vo_2 + vo_2_lo;
  vo->x = vo_0_rounded;
  vo->y = vo_1_rounded;
  vo->z = vo_2_rounded;
}

/* vo = R(q)^T v, |q| = 1.
   q: quaternion (x, y, z, w), the scalar last; v, vo: vector.
   30 mul, 75 add, 15 product rest.
   Error <= u |result| + 34 u^2 S, S the sum of the |terms| of the expanded formula; barring
     over- and underflow. */
static inline void ksl_rotate_qconjv_accurate(const ksl_quaternion_t *q, const ksl_vec3_t *v,
    ksl_vec3_t *vo) {
  const double c_0a = KSL_MUL(q->z, v->y), c_0b = KSL_MUL(q->y, v->z), c_0 = c_0a - c_0b,
      c_0_right = c_0a - c_0, c_0_left = c_0 + c_0_right,
      c_0_left_rest = ksl_product_rest(q->z, v->y, c_0a, c_0_left),
      c_0_right_rest = ksl_product_rest(q->y, v->z, c_0b, c_0_right),
      c_0_lo = c_0_left_rest - c_0_right_rest;
  const double c_1a = KSL_MUL(q->x, v->z), c_1b = KSL_MUL(q->z, v->x), c_1 = c_1a - c_1b,
      c_1_right = c_1a - c_1, c_1_left = c_1 + c_1_right,
      c_1_left_rest = ksl_product_rest(q->x, v->z, c_1a, c_1_left),
      c_1_right_rest = ksl_product_rest(q->z, v->x, c_1b, c_1_right),
      c_1_lo = c_1_left_rest - c_1_right_rest;
  const double c_2a = KSL_MUL(q->y, v->x), c_2b = KSL_MUL(q->x, v->y), c_2 = c_2a - c_2b,
      c_2_right = c_2a - c_2, c_2_left = c_2 + c_2_right,
      c_2_left_rest = ksl_product_rest(q->y, v->x, c_2a, c_2_left),
      c_2_right_rest = ksl_product_rest(q->x, v->y, c_2b, c_2_right),
      c_2_lo = c_2_left_rest - c_2_right_rest;
  const double t_0 = KSL_MUL(2.0, c_0), t_0_cross2 = KSL_MUL(2.0, c_0_lo);
  const double t_1 = KSL_MUL(2.0, c_1), t_1_cross2 = KSL_MUL(2.0, c_1_lo);
  const double t_2 = KSL_MUL(2.0, c_2), t_2_cross2 = KSL_MUL(2.0, c_2_lo);
  const double turn_0a = KSL_MUL(q->z, t_1), turn_0a_cross2 = KSL_MUL(q->z, t_1_cross2),
      turn_0b = KSL_MUL(q->y, t_2), turn_0b_cross2 = KSL_MUL(q->y, t_2_cross2),
      turn_0c = turn_0a - turn_0b, turn_0c_right = turn_0a - turn_0c,
      turn_0c_left = turn_0c + turn_0c_right,
      turn_0c_left_rest = ksl_product_rest(q->z, t_1, turn_0a, turn_0c_left),
      turn_0c_right_rest = ksl_product_rest(q->y, t_2, turn_0b, turn_0c_right),
      turn_0c_cross = turn_0a_cross2 - turn_0b_cross2,
      turn_0c_lo1 = turn_0c_left_rest - turn_0c_right_rest,
      turn_0c_lo = turn_0c_lo1 + turn_0c_cross, turn_0d = KSL_MUL(q->w, t_0),
      turn_0d_cross2 = KSL_MUL(q->w, t_0_cross2), turn_0 = turn_0c + turn_0d,
      turn_0_right = turn_0 - turn_0c, turn_0_left = turn_0 - turn_0_right,
      turn_0_left_rest = turn_0c - turn_0_left,
      turn_0_right_rest = ksl_product_rest(q->w, t_0, turn_0d, turn_0_right),
      turn_0_lo1 = turn_0_left_rest + turn_0_right_rest, turn_0_lo2 = turn_0_lo1 + turn_0d_cross2,
      turn_0_lo = turn_0_lo2 + turn_0c_lo;
  const double turn_1a = KSL_MUL(q->x, t_2), turn_1a_cross2 = KSL_MUL(q->x, t_2_cross2),
      turn_1b = KSL_MUL(q->z, t_0), turn_1b_cross2 = KSL_MUL(q->z, t_0_cross2),
      turn_1c = turn_1a - turn_1b, turn_1c_right = turn_1a - turn_1c,
      turn_1c_left = turn_1c + turn_1c_right,
      turn_1c_left_rest = ksl_product_rest(q->x, t_2, turn_1a, turn_1c_left),
      turn_1c_right_rest = ksl_product_rest(q->z, t_0, turn_1b, turn_1c_right),
      turn_1c_cross = turn_1a_cross2 - turn_1b_cross2,
      turn_1c_lo1 = turn_1c_left_rest - turn_1c_right_rest,
      turn_1c_lo = turn_1c_lo1 + turn_1c_cross, turn_1d = KSL_MUL(q->w, t_1),
      turn_1d_cross2 = KSL_MUL(q->w, t_1_cross2), turn_1 = turn_1c + turn_1d,
      turn_1_right = turn_1 - turn_1c, turn_1_left = turn_1 - turn_1_right,
      turn_1_left_rest = turn_1c - turn_1_left,
      turn_1_right_rest = ksl_product_rest(q->w, t_1, turn_1d, turn_1_right),
      turn_1_lo1 = turn_1_left_rest + turn_1_right_rest, turn_1_lo2 = turn_1_lo1 + turn_1d_cross2,
      turn_1_lo = turn_1_lo2 + turn_1c_lo;
  const double turn_2a = KSL_MUL(q->y, t_0), turn_2a_cross2 = KSL_MUL(q->y, t_0_cross2),
      turn_2b = KSL_MUL(q->x, t_1), turn_2b_cross2 = KSL_MUL(q->x, t_1_cross2),
      turn_2c = turn_2a - turn_2b, turn_2c_right = turn_2a - turn_2c,
      turn_2c_left = turn_2c + turn_2c_right,
      turn_2c_left_rest = ksl_product_rest(q->y, t_0, turn_2a, turn_2c_left),
      turn_2c_right_rest = ksl_product_rest(q->x, t_1, turn_2b, turn_2c_right),
      turn_2c_cross = turn_2a_cross2 - turn_2b_cross2,
      turn_2c_lo1 = turn_2c_left_rest - turn_2c_right_rest,
      turn_2c_lo = turn_2c_lo1 + turn_2c_cross, turn_2d = KSL_MUL(q->w, t_2),
      turn_2d_cross2 = KSL_MUL(q->w, t_2_cross2), turn_2 = turn_2c + turn_2d,
      turn_2_right = turn_2 - turn_2c, turn_2_left = turn_2 - turn_2_right,
      turn_2_left_rest = turn_2c - turn_2_left,
      turn_2_right_rest = ksl_product_rest(q->w, t_2, turn_2d, turn_2_right),
      turn_2_lo1 = turn_2_left_rest + turn_2_right_rest, turn_2_lo2 = turn_2_lo1 + turn_2d_cross2,
      turn_2_lo = turn_2_lo2 + turn_2c_lo;
  const double vo_0 = v->x + turn_0, vo_0_right = vo_0 - v->x, vo_0_left = vo_0 - vo_0_right,
      vo_0_left_rest = v->x - vo_0_left, vo_0_right_rest = turn_0 - vo_0_right,
      vo_0_lo1 = vo_0_left_rest + vo_0_right_rest, vo_0_lo = vo_0_lo1 + turn_0_lo;
  const double vo_1 = v->y + turn_1, vo_1_right = vo_1 - v->y, vo_1_left = vo_1 - vo_1_right,
      vo_1_left_rest = v->y - vo_1_left, vo_1_right_rest = turn_1 - vo_1_right,
      vo_1_lo1 = vo_1_left_rest + vo_1_right_rest, vo_1_lo = vo_1_lo1 + turn_1_lo;
  const double vo_2 = v->z + turn_2, vo_2_right = vo_2 - v->z, vo_2_left = vo_2 - vo_2_right,
      vo_2_left_rest = v->z - vo_2_left, vo_2_right_rest = turn_2 - vo_2_right,
      vo_2_lo1 = vo_2_left_rest + vo_2_right_rest, vo_2_lo = vo_2_lo1 + turn_2_lo;
  const double vo_0_rounded = vo_0 + vo_0_lo;
  const double vo_1_rounded = vo_1 + vo_1_lo;
  const double vo_2_rounded = vo_2 + vo_2_lo;
  vo->x = vo_0_rounded;
  vo->y = vo_1_rounded;
  vo->z = vo_2_rounded;
}

/* qo = q1i q2i.
   q1i, q2i, qo: quaternion (x, y, z, w), the scalar last.
   16 mul, 68 add, 16 product rest.
   Error <= u |result| + 17 u^2 S, S the sum of the |terms| of the expanded formula; barring
     over- and underflow. */
static inline void ksl_quaternion_product_qq_accurate(const ksl_quaternion_t *q1i,
    const ksl_quaternion_t *q2i, ksl_quaternion_t *qo) {
  const double qo_0a = KSL_MUL(q1i->x, q2i->w), qo_0b = KSL_MUL(q1i->y, q2i->z),
      qo_0c = KSL_MUL(q1i->z, q2i->y), qo_0d = qo_0b - qo_0c, qo_0d_right = qo_0b - qo_0d,
      qo_0d_left = qo_0d + qo_0d_right,
      qo_0d_left_rest = ksl_product_rest(q1i->y, q2i->z, qo_0b, qo_0d_left),
      qo_0d_right_rest = ksl_product_rest(q1i->z, q2i->y, qo_0c, qo_0d_right),
      qo_0d_lo = qo_0d_left_rest - qo_0d_right_rest, qo_0e = qo_0a + qo_0d,
      qo_0e_right = qo_0e - qo_0a, qo_0e_left = qo_0e - qo_0e_right,
      qo_0e_left_rest = ksl_product_rest(q1i->x, q2i->w, qo_0a, qo_0e_left),
      qo_0e_right_rest = qo_0d - qo_0e_right, qo_0e_lo1 = qo_0e_left_rest + qo_0e_right_rest,
      qo_0e_lo = qo_0e_lo1 + qo_0d_lo, qo_0f = KSL_MUL(q1i->w, q2i->x), qo_0 = qo_0e + qo_0f,
      qo_0_right = qo_0 - qo_0e, qo_0_left = qo_0 - qo_0_right, qo_0_left_rest = qo_0e - qo_0_left,
      qo_0_right_rest = ksl_product_rest(q1i->w, q2i->x, qo_0f, qo_0_right),
      qo_0_lo1 = qo_0_left_rest + qo_0_right_rest, qo_0_lo = qo_0_lo1 + qo_0e_lo;
  const double qo_1a = KSL_MUL(q1i->z, q2i->x), qo_1b = KSL_MUL(q1i->x, q2i->z),
      qo_1c = qo_1a - qo_1b, qo_1c_right = qo_1a - qo_1c, qo_1c_left = qo_1c + qo_1c_right,
      qo_1c_left_rest = ksl_product_rest(q1i->z, q2i->x, qo_1a, qo_1c_left),
      qo_1c_right_rest = ksl_product_rest(q1i->x, q2i->z, qo_1b, qo_1c_right),
      qo_1c_lo = qo_1c_left_rest - qo_1c_right_rest, qo_1d = KSL_MUL(q1i->y, q2i->w),
      qo_1e = qo_1c + qo_1d, qo_1e_right = qo_1e - qo_1c, qo_1e_left = qo_1e - qo_1e_right,
      qo_1e_left_rest = qo_1c - qo_1e_left,
      qo_1e_right_rest = ksl_product_rest(q1i->y, q2i->w, qo_1d, qo_1e_right),
      qo_1e_lo1 = qo_1e_left_rest + qo_1e_right_rest, qo_1e_lo = qo_1e_lo1 + qo_1c_lo,
      qo_1f = KSL_MUL(q1i->w, q2i->y), qo_1 = qo_1e + qo_1f, qo_1_right = qo_1 - qo_1e,
      qo_1_left = qo_1 - qo_1_right, qo_1_left_rest = qo_1e - qo_1_left,
      qo_1_right_rest = ksl_product_rest(q1i->w, q2i->y, qo_1f, qo_1_right),
      qo_1_lo1 = qo_1_left_rest + qo_1_right_rest, qo_1_lo = qo_1_lo1 + qo_1e_lo;
  const double qo_2a = KSL_MUL(q1i->x, q2i->y), qo_2b = KSL_MUL(q1i->y, q2i->x),
      qo_2c = qo_2a - qo_2b, qo_2c_right = qo_2a - qo_2c, qo_2c_left = qo_2c + qo_2c_right,
      qo_2c_left_rest = ksl_product_rest(q1i->x, q2i->y, qo_2a, qo_2c_left),
      qo_2c_right_rest = ksl_product_rest(q1i->y, q2i->x, qo_2b, qo_2c_right),
      qo_2c_lo = qo_2c_left_rest - qo_2c_right_rest, qo_2d = KSL_MUL(q1i->z, q2i->w),
      qo_2e = qo_2c + qo_2d, qo_2e_right = qo_2e - qo_2c, qo_2e_left = qo_2e - qo_2e_right,
      qo_2e_left_rest = qo_2c - qo_2e_left,
      qo_2e_right_rest = ksl_product_rest(q1i->z, q2i->w, qo_2d, qo_2e_right),
      qo_2e_lo1 = qo_2e_left_rest + qo_2e_right_rest, qo_2e_lo = qo_2e_lo1 + qo_2c_lo,
      qo_2f = KSL_MUL(q1i->w, q2i->z), qo_2 = qo_2e + qo_2f, qo_2_right = qo_2 - qo_2e,
      qo_2_left = qo_2 - qo_2_right, qo_2_left_rest = qo_2e - qo_2_left,
      qo_2_right_rest = ksl_product_rest(q1i->w, q2i->z, qo_2f, qo_2_right),
      qo_2_lo1 = qo_2_left_rest + qo_2_right_rest, qo_2_lo = qo_2_lo1 + qo_2e_lo;
  const double qo_3a = KSL_MUL(q1i->w, q2i->w), qo_3b = KSL_MUL(q1i->x, q2i->x),
      qo_3c = KSL_MUL(q1i->y, q2i->y), qo_3d = qo_3b + qo_3c, qo_3d_right = qo_3d - qo_3b,
      qo_3d_left = qo_3d - qo_3d_right,
      qo_3d_left_rest = ksl_product_rest(q1i->x, q2i->x, qo_3b, qo_3d_left),
      qo_3d_right_rest = ksl_product_rest(q1i->y, q2i->y, qo_3c, qo_3d_right),
      qo_3d_lo = qo_3d_left_rest + qo_3d_right_rest, qo_3e = KSL_MUL(q1i->z, q2i->z),
      qo_3f = qo_3d + qo_3e, qo_3f_right = qo_3f - qo_3d, qo_3f_left = qo_3f - qo_3f_right,
      qo_3f_left_rest = qo_3d - qo_3f_left,
      qo_3f_right_rest = ksl_product_rest(q1i->z, q2i->z, qo_3e, qo_3f_right),
      qo_3f_lo1 = qo_3f_left_rest + qo_3f_right_rest, qo_3f_lo = qo_3f_lo1 + qo_3d_lo,
      qo_3 = qo_3a - qo_3f, qo_3_right = qo_3a - qo_3, qo_3_left = qo_3 + qo_3_right,
      qo_3_left_rest = ksl_product_rest(q1i->w, q2i->w, qo_3a, qo_3_left),
      qo_3_right_rest = qo_3f - qo_3_right, qo_3_lo1 = qo_3_left_rest - qo_3_right_rest,
      qo_3_lo = qo_3_lo1 - qo_3f_lo;
  const double qo_0_rounded = qo_0 + qo_0_lo;
  const double qo_1_rounded = qo_1 + qo_1_lo;
  const double qo_2_rounded = qo_2 + qo_2_lo;
  const double qo_3_rounded = qo_3 + qo_3_lo;
  qo->x = qo_0_rounded;
  qo->y = qo_1_rounded;
  qo->z = qo_2_rounded;
  qo->w = qo_3_rounded;
}

/* qo = q1i q2i*.
   q1i, q2i, qo: quaternion (x, y, z, w), the scalar last.
   16 mul, 68 add, 16 product rest.
   Error <= u |result| + (v: 12, w: 17) u^2 S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_quaternion_product_qqconj_accurate(const ksl_quaternion_t *q1i,
    const ksl_quaternion_t *q2i, ksl_quaternion_t *qo) {
  const double qo_0a = KSL_MUL(q1i->x, q2i->w), qo_0b = KSL_MUL(q1i->w, q2i->x),
      qo_0c = qo_0a - qo_0b, qo_0c_right = qo_0a - qo_0c, qo_0c_left = qo_0c + qo_0c_right,
      qo_0c_left_rest = ksl_product_rest(q1i->x, q2i->w, qo_0a, qo_0c_left),
      qo_0c_right_rest = ksl_product_rest(q1i->w, q2i->x, qo_0b, qo_0c_right),
      qo_0c_lo = qo_0c_left_rest - qo_0c_right_rest, qo_0d = KSL_MUL(q1i->z, q2i->y),
      qo_0e = KSL_MUL(q1i->y, q2i->z), qo_0f = qo_0d - qo_0e, qo_0f_right = qo_0d - qo_0f,
      qo_0f_left = qo_0f + qo_0f_right,
      qo_0f_left_rest = ksl_product_rest(q1i->z, q2i->y, qo_0d, qo_0f_left),
      qo_0f_right_rest = ksl_product_rest(q1i->y, q2i->z, qo_0e, qo_0f_right),
      qo_0f_lo = qo_0f_left_rest - qo_0f_right_rest, qo_0 = qo_0c + qo_0f,
      qo_0_right = qo_0 - qo_0c, qo_0_left = qo_0 - qo_0_right, qo_0_left_rest = qo_0c - qo_0_left,
      qo_0_right_rest = qo_0f - qo_0_right, qo_0_lo1 = qo_0_left_rest + qo_0_right_rest,
      qo_0_lo2 = qo_0_lo1 + qo_0f_lo, qo_0_lo = qo_0_lo2 + qo_0c_lo;
  const double qo_1a = KSL_MUL(q1i->x, q2i->z), qo_1b = KSL_MUL(q1i->z, q2i->x),
      qo_1c = qo_1a - qo_1b, qo_1c_right = qo_1a - qo_1c, qo_1c_left = qo_1c + qo_1c_right,
      qo_1c_left_rest = ksl_product_rest(q1i->x, q2i->z, qo_1a, qo_1c_left),
      qo_1c_right_rest = ksl_product_rest(q1i->z, q2i->x, qo_1b, qo_1c_right),
      qo_1c_lo = qo_1c_left_rest - qo_1c_right_rest, qo_1d = KSL_MUL(q1i->y, q2i->w),
      qo_1e = KSL_MUL(q1i->w, q2i->y), qo_1f = qo_1d - qo_1e, qo_1f_right = qo_1d - qo_1f,
      qo_1f_left = qo_1f + qo_1f_right,
      qo_1f_left_rest = ksl_product_rest(q1i->y, q2i->w, qo_1d, qo_1f_left),
      qo_1f_right_rest = ksl_product_rest(q1i->w, q2i->y, qo_1e, qo_1f_right),
      qo_1f_lo = qo_1f_left_rest - qo_1f_right_rest, qo_1 = qo_1c + qo_1f,
      qo_1_right = qo_1 - qo_1c, qo_1_left = qo_1 - qo_1_right, qo_1_left_rest = qo_1c - qo_1_left,
      qo_1_right_rest = qo_1f - qo_1_right, qo_1_lo1 = qo_1_left_rest + qo_1_right_rest,
      qo_1_lo2 = qo_1_lo1 + qo_1f_lo, qo_1_lo = qo_1_lo2 + qo_1c_lo;
  const double qo_2a = KSL_MUL(q1i->y, q2i->x), qo_2b = KSL_MUL(q1i->x, q2i->y),
      qo_2c = qo_2a - qo_2b, qo_2c_right = qo_2a - qo_2c, qo_2c_left = qo_2c + qo_2c_right,
      qo_2c_left_rest = ksl_product_rest(q1i->y, q2i->x, qo_2a, qo_2c_left),
      qo_2c_right_rest = ksl_product_rest(q1i->x, q2i->y, qo_2b, qo_2c_right),
      qo_2c_lo = qo_2c_left_rest - qo_2c_right_rest, qo_2d = KSL_MUL(q1i->z, q2i->w),
      qo_2e = KSL_MUL(q1i->w, q2i->z), qo_2f = qo_2d - qo_2e, qo_2f_right = qo_2d - qo_2f,
      qo_2f_left = qo_2f + qo_2f_right,
      qo_2f_left_rest = ksl_product_rest(q1i->z, q2i->w, qo_2d, qo_2f_left),
      qo_2f_right_rest = ksl_product_rest(q1i->w, q2i->z, qo_2e, qo_2f_right),
      qo_2f_lo = qo_2f_left_rest - qo_2f_right_rest, qo_2 = qo_2c + qo_2f,
      qo_2_right = qo_2 - qo_2c, qo_2_left = qo_2 - qo_2_right, qo_2_left_rest = qo_2c - qo_2_left,
      qo_2_right_rest = qo_2f - qo_2_right, qo_2_lo1 = qo_2_left_rest + qo_2_right_rest,
      qo_2_lo2 = qo_2_lo1 + qo_2f_lo, qo_2_lo = qo_2_lo2 + qo_2c_lo;
  const double qo_3a = KSL_MUL(q1i->x, q2i->x), qo_3b = KSL_MUL(q1i->y, q2i->y),
      qo_3c = qo_3a + qo_3b, qo_3c_right = qo_3c - qo_3a, qo_3c_left = qo_3c - qo_3c_right,
      qo_3c_left_rest = ksl_product_rest(q1i->x, q2i->x, qo_3a, qo_3c_left),
      qo_3c_right_rest = ksl_product_rest(q1i->y, q2i->y, qo_3b, qo_3c_right),
      qo_3c_lo = qo_3c_left_rest + qo_3c_right_rest, qo_3d = KSL_MUL(q1i->z, q2i->z),
      qo_3e = qo_3c + qo_3d, qo_3e_right = qo_3e - qo_3c, qo_3e_left = qo_3e - qo_3e_right,
      qo_3e_left_rest = qo_3c - qo_3e_left,
      qo_3e_right_rest = ksl_product_rest(q1i->z, q2i->z, qo_3d, qo_3e_right),
      qo_3e_lo1 = qo_3e_left_rest + qo_3e_right_rest, qo_3e_lo = qo_3e_lo1 + qo_3c_lo,
      qo_3f = KSL_MUL(q1i->w, q2i->w), qo_3 = qo_3e + qo_3f, qo_3_right = qo_3 - qo_3e,
      qo_3_left = qo_3 - qo_3_right, qo_3_left_rest = qo_3e - qo_3_left,
      qo_3_right_rest = ksl_product_rest(q1i->w, q2i->w, qo_3f, qo_3_right),
      qo_3_lo1 = qo_3_left_rest + qo_3_right_rest, qo_3_lo = qo_3_lo1 + qo_3e_lo;
  const double qo_0_rounded = qo_0 + qo_0_lo;
  const double qo_1_rounded = qo_1 + qo_1_lo;
  const double qo_2_rounded = qo_2 + qo_2_lo;
  const double qo_3_rounded = qo_3 + qo_3_lo;
  qo->x = qo_0_rounded;
  qo->y = qo_1_rounded;
  qo->z = qo_2_rounded;
  qo->w = qo_3_rounded;
}

/* qo = q1i* q2i.
   q1i, q2i, qo: quaternion (x, y, z, w), the scalar last.
   16 mul, 68 add, 16 product rest.
   Error <= u |result| + (v: 12, w: 17) u^2 S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_quaternion_product_qconjq_accurate(const ksl_quaternion_t *q1i,
    const ksl_quaternion_t *q2i, ksl_quaternion_t *qo) {
  const double qo_0a = KSL_MUL(q1i->w, q2i->x), qo_0b = KSL_MUL(q1i->x, q2i->w),
      qo_0c = qo_0a - qo_0b, qo_0c_right = qo_0a - qo_0c, qo_0c_left = qo_0c + qo_0c_right,
      qo_0c_left_rest = ksl_product_rest(q1i->w, q2i->x, qo_0a, qo_0c_left),
      qo_0c_right_rest = ksl_product_rest(q1i->x, q2i->w, qo_0b, qo_0c_right),
      qo_0c_lo = qo_0c_left_rest - qo_0c_right_rest, qo_0d = KSL_MUL(q1i->z, q2i->y),
      qo_0e = KSL_MUL(q1i->y, q2i->z), qo_0f = qo_0d - qo_0e, qo_0f_right = qo_0d - qo_0f,
      qo_0f_left = qo_0f + qo_0f_right,
      qo_0f_left_rest = ksl_product_rest(q1i->z, q2i->y, qo_0d, qo_0f_left),
      qo_0f_right_rest = ksl_product_rest(q1i->y, q2i->z, qo_0e, qo_0f_right),
      qo_0f_lo = qo_0f_left_rest - qo_0f_right_rest, qo_0 = qo_0c + qo_0f,
      qo_0_right = qo_0 - qo_0c, qo_0_left = qo_0 - qo_0_right, qo_0_left_rest = qo_0c - qo_0_left,
      qo_0_right_rest = qo_0f - qo_0_right, qo_0_lo1 = qo_0_left_rest + qo_0_right_rest,
      qo_0_lo2 = qo_0_lo1 + qo_0f_lo, qo_0_lo = qo_0_lo2 + qo_0c_lo;
  const double qo_1a = KSL_MUL(q1i->x, q2i->z), qo_1b = KSL_MUL(q1i->z, q2i->x),
      qo_1c = qo_1a - qo_1b, qo_1c_right = qo_1a - qo_1c, qo_1c_left = qo_1c + qo_1c_right,
      qo_1c_left_rest = ksl_product_rest(q1i->x, q2i->z, qo_1a, qo_1c_left),
      qo_1c_right_rest = ksl_product_rest(q1i->z, q2i->x, qo_1b, qo_1c_right),
      qo_1c_lo = qo_1c_left_rest - qo_1c_right_rest, qo_1d = KSL_MUL(q1i->w, q2i->y),
      qo_1e = KSL_MUL(q1i->y, q2i->w), qo_1f = qo_1d - qo_1e, qo_1f_right = qo_1d - qo_1f,
      qo_1f_left = qo_1f + qo_1f_right,
      qo_1f_left_rest = ksl_product_rest(q1i->w, q2i->y, qo_1d, qo_1f_left),
      qo_1f_right_rest = ksl_product_rest(q1i->y, q2i->w, qo_1e, qo_1f_right),
      qo_1f_lo = qo_1f_left_rest - qo_1f_right_rest, qo_1 = qo_1c + qo_1f,
      qo_1_right = qo_1 - qo_1c, qo_1_left = qo_1 - qo_1_right, qo_1_left_rest = qo_1c - qo_1_left,
      qo_1_right_rest = qo_1f - qo_1_right, qo_1_lo1 = qo_1_left_rest + qo_1_right_rest,
      qo_1_lo2 = qo_1_lo1 + qo_1f_lo, qo_1_lo = qo_1_lo2 + qo_1c_lo;
  const double qo_2a = KSL_MUL(q1i->y, q2i->x), qo_2b = KSL_MUL(q1i->x, q2i->y),
      qo_2c = qo_2a - qo_2b, qo_2c_right = qo_2a - qo_2c, qo_2c_left = qo_2c + qo_2c_right,
      qo_2c_left_rest = ksl_product_rest(q1i->y, q2i->x, qo_2a, qo_2c_left),
      qo_2c_right_rest = ksl_product_rest(q1i->x, q2i->y, qo_2b, qo_2c_right),
      qo_2c_lo = qo_2c_left_rest - qo_2c_right_rest, qo_2d = KSL_MUL(q1i->w, q2i->z),
      qo_2e = KSL_MUL(q1i->z, q2i->w), qo_2f = qo_2d - qo_2e, qo_2f_right = qo_2d - qo_2f,
      qo_2f_left = qo_2f + qo_2f_right,
      qo_2f_left_rest = ksl_product_rest(q1i->w, q2i->z, qo_2d, qo_2f_left),
      qo_2f_right_rest = ksl_product_rest(q1i->z, q2i->w, qo_2e, qo_2f_right),
      qo_2f_lo = qo_2f_left_rest - qo_2f_right_rest, qo_2 = qo_2c + qo_2f,
      qo_2_right = qo_2 - qo_2c, qo_2_left = qo_2 - qo_2_right, qo_2_left_rest = qo_2c - qo_2_left,
      qo_2_right_rest = qo_2f - qo_2_right, qo_2_lo1 = qo_2_left_rest + qo_2_right_rest,
      qo_2_lo2 = qo_2_lo1 + qo_2f_lo, qo_2_lo = qo_2_lo2 + qo_2c_lo;
  const double qo_3a = KSL_MUL(q1i->x, q2i->x), qo_3b = KSL_MUL(q1i->y, q2i->y),
      qo_3c = qo_3a + qo_3b, qo_3c_right = qo_3c - qo_3a, qo_3c_left = qo_3c - qo_3c_right,
      qo_3c_left_rest = ksl_product_rest(q1i->x, q2i->x, qo_3a, qo_3c_left),
      qo_3c_right_rest = ksl_product_rest(q1i->y, q2i->y, qo_3b, qo_3c_right),
      qo_3c_lo = qo_3c_left_rest + qo_3c_right_rest, qo_3d = KSL_MUL(q1i->z, q2i->z),
      qo_3e = qo_3c + qo_3d, qo_3e_right = qo_3e - qo_3c, qo_3e_left = qo_3e - qo_3e_right,
      qo_3e_left_rest = qo_3c - qo_3e_left,
      qo_3e_right_rest = ksl_product_rest(q1i->z, q2i->z, qo_3d, qo_3e_right),
      qo_3e_lo1 = qo_3e_left_rest + qo_3e_right_rest, qo_3e_lo = qo_3e_lo1 + qo_3c_lo,
      qo_3f = KSL_MUL(q1i->w, q2i->w), qo_3 = qo_3e + qo_3f, qo_3_right = qo_3 - qo_3e,
      qo_3_left = qo_3 - qo_3_right, qo_3_left_rest = qo_3e - qo_3_left,
      qo_3_right_rest = ksl_product_rest(q1i->w, q2i->w, qo_3f, qo_3_right),
      qo_3_lo1 = qo_3_left_rest + qo_3_right_rest, qo_3_lo = qo_3_lo1 + qo_3e_lo;
  const double qo_0_rounded = qo_0 + qo_0_lo;
  const double qo_1_rounded = qo_1 + qo_1_lo;
  const double qo_2_rounded = qo_2 + qo_2_lo;
  const double qo_3_rounded = qo_3 + qo_3_lo;
  qo->x = qo_0_rounded;
  qo->y = qo_1_rounded;
  qo->z = qo_2_rounded;
  qo->w = qo_3_rounded;
}

/* qo = q1i* q2i*.
   q1i, q2i, qo: quaternion (x, y, z, w), the scalar last.
   16 mul, 68 add, 16 product rest.
   Error <= u |result| + 17 u^2 S, S the sum of the |terms| of the expanded formula; barring
     over- and underflow. */
static inline void ksl_quaternion_product_qconjqconj_accurate(const ksl_quaternion_t *q1i,
    const ksl_quaternion_t *q2i, ksl_quaternion_t *qo) {
  const double qo_0a = KSL_MUL(q1i->y, q2i->z), qo_0b = KSL_MUL(q1i->z, q2i->y),
      qo_0c = qo_0a - qo_0b, qo_0c_right = qo_0a - qo_0c, qo_0c_left = qo_0c + qo_0c_right,
      qo_0c_left_rest = ksl_product_rest(q1i->y, q2i->z, qo_0a, qo_0c_left),
      qo_0c_right_rest = ksl_product_rest(q1i->z, q2i->y, qo_0b, qo_0c_right),
      qo_0c_lo = qo_0c_left_rest - qo_0c_right_rest, qo_0d = KSL_MUL(q1i->x, q2i->w),
      qo_0e = qo_0c - qo_0d, qo_0e_right = qo_0c - qo_0e, qo_0e_left = qo_0e + qo_0e_right,
      qo_0e_left_rest = qo_0c - qo_0e_left,
      qo_0e_right_rest = ksl_product_rest(q1i->x, q2i->w, qo_0d, qo_0e_right),
      qo_0e_lo1 = qo_0e_left_rest - qo_0e_right_rest, qo_0e_lo = qo_0e_lo1 + qo_0c_lo,
      qo_0f = KSL_MUL(q1i->w, q2i->x), qo_0 = qo_0e - qo_0f, qo_0_right = qo_0e - qo_0,
      qo_0_left = qo_0 + qo_0_right, qo_0_left_rest = qo_0e - qo_0_left,
      qo_0_right_rest = ksl_product_rest(q1i->w, q2i->x, qo_0f, qo_0_right),
      qo_0_lo1 = qo_0_left_rest - qo_0_right_rest, qo_0_lo = qo_0_lo1 + qo_0e_lo;
  const double qo_1a = KSL_MUL(q1i->z, q2i->x), qo_1b = KSL_MUL(q1i->x, q2i->z),
      qo_1c = qo_1a - qo_1b, qo_1c_right = qo_1a - qo_1c, qo_1c_left = qo_1c + qo_1c_right,
      qo_1c_left_rest = ksl_product_rest(q1i->z, q2i->x, qo_1a, qo_1c_left),
      qo_1c_right_rest = ksl_product_rest(q1i->x, q2i->z, qo_1b, qo_1c_right),
      qo_1c_lo = qo_1c_left_rest - qo_1c_right_rest, qo_1d = KSL_MUL(q1i->y, q2i->w),
      qo_1e = qo_1c - qo_1d, qo_1e_right = qo_1c - qo_1e, qo_1e_left = qo_1e + qo_1e_right,
      qo_1e_left_rest = qo_1c - qo_1e_left,
      qo_1e_right_rest = ksl_product_rest(q1i->y, q2i->w, qo_1d, qo_1e_right),
      qo_1e_lo1 = qo_1e_left_rest - qo_1e_right_rest, qo_1e_lo = qo_1e_lo1 + qo_1c_lo,
      qo_1f = KSL_MUL(q1i->w, q2i->y), qo_1 = qo_1e - qo_1f, qo_1_right = qo_1e - qo_1,
      qo_1_left = qo_1 + qo_1_right, qo_1_left_rest = qo_1e - qo_1_left,
      qo_1_right_rest = ksl_product_rest(q1i->w, q2i->y, qo_1f, qo_1_right),
      qo_1_lo1 = qo_1_left_rest - qo_1_right_rest, qo_1_lo = qo_1_lo1 + qo_1e_lo;
  const double qo_2a = KSL_MUL(q1i->x, q2i->y), qo_2b = KSL_MUL(q1i->y, q2i->x),
      qo_2c = qo_2a - qo_2b, qo_2c_right = qo_2a - qo_2c, qo_2c_left = qo_2c + qo_2c_right,
      qo_2c_left_rest = ksl_product_rest(q1i->x, q2i->y, qo_2a, qo_2c_left),
      qo_2c_right_rest = ksl_product_rest(q1i->y, q2i->x, qo_2b, qo_2c_right),
      qo_2c_lo = qo_2c_left_rest - qo_2c_right_rest, qo_2d = KSL_MUL(q1i->z, q2i->w),
      qo_2e = qo_2c - qo_2d, qo_2e_right = qo_2c - qo_2e, qo_2e_left = qo_2e + qo_2e_right,
      qo_2e_left_rest = qo_2c - qo_2e_left,
      qo_2e_right_rest = ksl_product_rest(q1i->z, q2i->w, qo_2d, qo_2e_right),
      qo_2e_lo1 = qo_2e_left_rest - qo_2e_right_rest, qo_2e_lo = qo_2e_lo1 + qo_2c_lo,
      qo_2f = KSL_MUL(q1i->w, q2i->z), qo_2 = qo_2e - qo_2f, qo_2_right = qo_2e - qo_2,
      qo_2_left = qo_2 + qo_2_right, qo_2_left_rest = qo_2e - qo_2_left,
      qo_2_right_rest = ksl_product_rest(q1i->w, q2i->z, qo_2f, qo_2_right),
      qo_2_lo1 = qo_2_left_rest - qo_2_right_rest, qo_2_lo = qo_2_lo1 + qo_2e_lo;
  const double qo_3a = KSL_MUL(q1i->w, q2i->w), qo_3b = KSL_MUL(q1i->x, q2i->x),
      qo_3c = KSL_MUL(q1i->y, q2i->y), qo_3d = qo_3b + qo_3c, qo_3d_right = qo_3d - qo_3b,
      qo_3d_left = qo_3d - qo_3d_right,
      qo_3d_left_rest = ksl_product_rest(q1i->x, q2i->x, qo_3b, qo_3d_left),
      qo_3d_right_rest = ksl_product_rest(q1i->y, q2i->y, qo_3c, qo_3d_right),
      qo_3d_lo = qo_3d_left_rest + qo_3d_right_rest, qo_3e = KSL_MUL(q1i->z, q2i->z),
      qo_3f = qo_3d + qo_3e, qo_3f_right = qo_3f - qo_3d, qo_3f_left = qo_3f - qo_3f_right,
      qo_3f_left_rest = qo_3d - qo_3f_left,
      qo_3f_right_rest = ksl_product_rest(q1i->z, q2i->z, qo_3e, qo_3f_right),
      qo_3f_lo1 = qo_3f_left_rest + qo_3f_right_rest, qo_3f_lo = qo_3f_lo1 + qo_3d_lo,
      qo_3 = qo_3a - qo_3f, qo_3_right = qo_3a - qo_3, qo_3_left = qo_3 + qo_3_right,
      qo_3_left_rest = ksl_product_rest(q1i->w, q2i->w, qo_3a, qo_3_left),
      qo_3_right_rest = qo_3f - qo_3_right, qo_3_lo1 = qo_3_left_rest - qo_3_right_rest,
      qo_3_lo = qo_3_lo1 - qo_3f_lo;
  const double qo_0_rounded = qo_0 + qo_0_lo;
  const double qo_1_rounded = qo_1 + qo_1_lo;
  const double qo_2_rounded = qo_2 + qo_2_lo;
  const double qo_3_rounded = qo_3 + qo_3_lo;
  qo->x = qo_0_rounded;
  qo->y = qo_1_rounded;
  qo->z = qo_2_rounded;
  qo->w = qo_3_rounded;
}

/* qo = (s e_x; c) qi, dci = (s, c), sine and cosine of half the angle.
   dci: (sin θ, cos θ); qi, qo: quaternion (x, y, z, w), the scalar last.
   8 mul, 20 add, 8 product rest.
   Error <= u |result| + 6 u^2 S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_quaternion_product_qxq_accurate(const double dci[2],
    const ksl_quaternion_t *qi, ksl_quaternion_t *qo) {
  const double qo_0a = KSL_MUL(dci[0], qi->w), qo_0b = KSL_MUL(dci[1], qi->x), qo_0 = qo_0a + qo_0b,
      qo_0_right = qo_0 - qo_0a, qo_0_left = qo_0 - qo_0_right,
      qo_0_left_rest = ksl_product_rest(dci[0], qi->w, qo_0a, qo_0_left),
      qo_0_right_rest = ksl_product_rest(dci[1], qi->x, qo_0b, qo_0_right),
      qo_0_lo = qo_0_left_rest + qo_0_right_rest;
  const double qo_1a = KSL_MUL(dci[1], qi->y), qo_1b = KSL_MUL(dci[0], qi->z), qo_1 = qo_1a - qo_1b,
      qo_1_right = qo_1a - qo_1, qo_1_left = qo_1 + qo_1_right,
      qo_1_left_rest = ksl_product_rest(dci[1], qi->y, qo_1a, qo_1_left),
      qo_1_right_rest = ksl_product_rest(dci[0], qi->z, qo_1b, qo_1_right),
      qo_1_lo = qo_1_left_rest - qo_1_right_rest;
  const double qo_2a = KSL_MUL(dci[0], qi->y), qo_2b = KSL_MUL(dci[1], qi->z), qo_2 = qo_2a + qo_2b,
      qo_2_right = qo_2 - qo_2a, qo_2_left = qo_2 - qo_2_right,
      qo_2_left_rest = ksl_product_rest(dci[0], qi->y, qo_2a, qo_2_left),
      qo_2_right_rest = ksl_product_rest(dci[1], qi->z, qo_2b, qo_2_right),
      qo_2_lo = qo_2_left_rest + qo_2_right_rest;
  const double qo_3a = KSL_MUL(dci[1], qi->w), qo_3b = KSL_MUL(dci[0], qi->x), qo_3 = qo_3a - qo_3b,
      qo_3_right = qo_3a - qo_3, qo_3_left = qo_3 + qo_3_right,
      qo_3_left_rest = ksl_product_rest(dci[1], qi->w, qo_3a, qo_3_left),
      qo_3_right_rest = ksl_product_rest(dci[0], qi->x, qo_3b, qo_3_right),
      qo_3_lo = qo_3_left_rest - qo_3_right_rest;
  const double qo_0_rounded = qo_0 + qo_0_lo;
  const double qo_1_rounded = qo_1 + qo_1_lo;
  const double qo_2_rounded = qo_2 + qo_2_lo;
  const double qo_3_rounded = qo_3 + qo_3_lo;
  qo->x = qo_0_rounded;
  qo->y = qo_1_rounded;
  qo->z = qo_2_rounded;
  qo->w = qo_3_rounded;
}

/* qo = (s e_x; c) qi*, dci = (s, c), sine and cosine of half the angle.
   dci: (sin θ, cos θ); qi, qo: quaternion (x, y, z, w), the scalar last.
   8 mul, 20 add, 8 product rest, 2 neg.
   Error <= u |result| + 6 u^2 S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_quaternion_product_qxqconj_accurate(const double dci[2],
    const ksl_quaternion_t *qi, ksl_quaternion_t *qo) {
  const double qo_0a = KSL_MUL(dci[0], qi->w), qo_0b = KSL_MUL(dci[1], qi->x), qo_0 = qo_0a - qo_0b,
      qo_0_right = qo_0a - qo_0, qo_0_left = qo_0 + qo_0_right,
      qo_0_left_rest = ksl_product_rest(dci[0], qi->w, qo_0a, qo_0_left),
      qo_0_right_rest = ksl_product_rest(dci[1], qi->x, qo_0b, qo_0_right),
      qo_0_lo = qo_0_left_rest - qo_0_right_rest;
  const double qo_1a = KSL_MUL(dci[0], qi->z), qo_1b = KSL_MUL(dci[1], qi->y), qo_1 = qo_1a - qo_1b,
      qo_1_right = qo_1a - qo_1, qo_1_left = qo_1 + qo_1_right,
      qo_1_left_rest = ksl_product_rest(dci[0], qi->z, qo_1a, qo_1_left),
      qo_1_right_rest = ksl_product_rest(dci[1], qi->y, qo_1b, qo_1_right),
      qo_1_lo = qo_1_left_rest - qo_1_right_rest;
  const double qo_2a = KSL_MUL(dci[0], qi->y), qo_2b = KSL_MUL(dci[1], qi->z),
      qo_2c = qo_2a + qo_2b, qo_2c_right = qo_2c - qo_2a, qo_2c_left = qo_2c - qo_2c_right,
      qo_2c_left_rest = ksl_product_rest(dci[0], qi->y, qo_2a, qo_2c_left),
      qo_2c_right_rest = ksl_product_rest(dci[1], qi->z, qo_2b, qo_2c_right),
      qo_2c_lo = qo_2c_left_rest + qo_2c_right_rest, qo_2 = -qo_2c, qo_2_lo = -qo_2c_lo;
  const double qo_3a = KSL_MUL(dci[0], qi->x), qo_3b = KSL_MUL(dci[1], qi->w), qo_3 = qo_3a + qo_3b,
      qo_3_right = qo_3 - qo_3a, qo_3_left = qo_3 - qo_3_right,
      qo_3_left_rest = ksl_product_rest(dci[0], qi->x, qo_3a, qo_3_left),
      qo_3_right_rest = ksl_product_rest(dci[1], qi->w, qo_3b, qo_3_right),
      qo_3_lo = qo_3_left_rest + qo_3_right_rest;
  const double qo_0_rounded = qo_0 + qo_0_lo;
  const double qo_1_rounded = qo_1 + qo_1_lo;
  const double qo_2_rounded = qo_2 + qo_2_lo;
  const double qo_3_rounded = qo_3 + qo_3_lo;
  qo->x = qo_0_rounded;
  qo->y = qo_1_rounded;
  qo->z = qo_2_rounded;
  qo->w = qo_3_rounded;
}

/* qo = (s e_x; c)* qi, dci = (s, c), sine and cosine of half the angle.
   dci: (sin θ, cos θ); qi, qo: quaternion (x, y, z, w), the scalar last.
   8 mul, 20 add, 8 product rest.
   Error <= u |result| + 6 u^2 S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_quaternion_product_qxconjq_accurate(const double dci[2],
    const ksl_quaternion_t *qi, ksl_quaternion_t *qo) {
  const double qo_0a = KSL_MUL(dci[1], qi->x), qo_0b = KSL_MUL(dci[0], qi->w), qo_0 = qo_0a - qo_0b,
      qo_0_right = qo_0a - qo_0, qo_0_left = qo_0 + qo_0_right,
      qo_0_left_rest = ksl_product_rest(dci[1], qi->x, qo_0a, qo_0_left),
      qo_0_right_rest = ksl_product_rest(dci[0], qi->w, qo_0b, qo_0_right),
      qo_0_lo = qo_0_left_rest - qo_0_right_rest;
  const double qo_1a = KSL_MUL(dci[0], qi->z), qo_1b = KSL_MUL(dci[1], qi->y), qo_1 = qo_1a + qo_1b,
      qo_1_right = qo_1 - qo_1a, qo_1_left = qo_1 - qo_1_right,
      qo_1_left_rest = ksl_product_rest(dci[0], qi->z, qo_1a, qo_1_left),
      qo_1_right_rest = ksl_product_rest(dci[1], qi->y, qo_1b, qo_1_right),
      qo_1_lo = qo_1_left_rest + qo_1_right_rest;
  const double qo_2a = KSL_MUL(dci[1], qi->z), qo_2b = KSL_MUL(dci[0], qi->y), qo_2 = qo_2a - qo_2b,
      qo_2_right = qo_2a - qo_2, qo_2_left = qo_2 + qo_2_right,
      qo_2_left_rest = ksl_product_rest(dci[1], qi->z, qo_2a, qo_2_left),
      qo_2_right_rest = ksl_product_rest(dci[0], qi->y, qo_2b, qo_2_right),
      qo_2_lo = qo_2_left_rest - qo_2_right_rest;
  const double qo_3a = KSL_MUL(dci[0], qi->x), qo_3b = KSL_MUL(dci[1], qi->w), qo_3 = qo_3a + qo_3b,
      qo_3_right = qo_3 - qo_3a, qo_3_left = qo_3 - qo_3_right,
      qo_3_left_rest = ksl_product_rest(dci[0], qi->x, qo_3a, qo_3_left),
      qo_3_right_rest = ksl_product_rest(dci[1], qi->w, qo_3b, qo_3_right),
      qo_3_lo = qo_3_left_rest + qo_3_right_rest;
  const double qo_0_rounded = qo_0 + qo_0_lo;
  const double qo_1_rounded = qo_1 + qo_1_lo;
  const double qo_2_rounded = qo_2 + qo_2_lo;
  const double qo_3_rounded = qo_3 + qo_3_lo;
  qo->x = qo_0_rounded;
  qo->y = qo_1_rounded;
  qo->z = qo_2_rounded;
  qo->w = qo_3_rounded;
}

/* qo = (s e_x; c)* qi*, dci = (s, c), sine and cosine of half the angle.
   dci: (sin θ, cos θ); qi, qo: quaternion (x, y, z, w), the scalar last.
   8 mul, 20 add, 8 product rest, 4 neg.
   Error <= u |result| + 6 u^2 S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_quaternion_product_qxconjqconj_accurate(const double dci[2],
    const ksl_quaternion_t *qi, ksl_quaternion_t *qo) {
  const double qo_0a = KSL_MUL(dci[0], qi->w), qo_0b = KSL_MUL(dci[1], qi->x),
      qo_0c = qo_0a + qo_0b, qo_0c_right = qo_0c - qo_0a, qo_0c_left = qo_0c - qo_0c_right,
      qo_0c_left_rest = ksl_product_rest(dci[0], qi->w, qo_0a, qo_0c_left),
      qo_0c_right_rest = ksl_product_rest(dci[1], qi->x, qo_0b, qo_0c_right),
      qo_0c_lo = qo_0c_left_rest + qo_0c_right_rest, qo_0 = -qo_0c, qo_0_lo = -qo_0c_lo;
  const double qo_1a = KSL_MUL(dci[0], qi->z), qo_1b = KSL_MUL(dci[1], qi->y),
      qo_1c = qo_1a + qo_1b, qo_1c_right = qo_1c - qo_1a, qo_1c_left = qo_1c - qo_1c_right,
      qo_1c_left_rest = ksl_product_rest(dci[0], qi->z, qo_1a, qo_1c_left),
      qo_1c_right_rest = ksl_product_rest(dci[1], qi->y, qo_1b, qo_1c_right),
      qo_1c_lo = qo_1c_left_rest + qo_1c_right_rest, qo_1 = -qo_1c, qo_1_lo = -qo_1c_lo;
  const double qo_2a = KSL_MUL(dci[0], qi->y), qo_2b = KSL_MUL(dci[1], qi->z), qo_2 = qo_2a - qo_2b,
      qo_2_right = qo_2a - qo_2, qo_2_left = qo_2 + qo_2_right,
      qo_2_left_rest = ksl_product_rest(dci[0], qi->y, qo_2a, qo_2_left),
      qo_2_right_rest = ksl_product_rest(dci[1], qi->z, qo_2b, qo_2_right),
      qo_2_lo = qo_2_left_rest - qo_2_right_rest;
  const double qo_3a = KSL_MUL(dci[1], qi->w), qo_3b = KSL_MUL(dci[0], qi->x), qo_3 = qo_3a - qo_3b,
      qo_3_right = qo_3a - qo_3, qo_3_left = qo_3 + qo_3_right,
      qo_3_left_rest = ksl_product_rest(dci[1], qi->w, qo_3a, qo_3_left),
      qo_3_right_rest = ksl_product_rest(dci[0], qi->x, qo_3b, qo_3_right),
      qo_3_lo = qo_3_left_rest - qo_3_right_rest;
  const double qo_0_rounded = qo_0 + qo_0_lo;
  const double qo_1_rounded = qo_1 + qo_1_lo;
  const double qo_2_rounded = qo_2 + qo_2_lo;
  const double qo_3_rounded = qo_3 + qo_3_lo;
  qo->x = qo_0_rounded;
  qo->y = qo_1_rounded;
  qo->z = qo_2_rounded;
  qo->w = qo_3_rounded;
}

/* qo = qi (s e_x; c), dci = (s, c), sine and cosine of half the angle.
   qi, qo: quaternion (x, y, z, w), the scalar last; dci: (sin θ, cos θ).
   8 mul, 20 add, 8 product rest.
   Error <= u |result| + 6 u^2 S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_quaternion_product_qqx_accurate(const ksl_quaternion_t *qi,
    const double dci[2], ksl_quaternion_t *qo) {
  const double qo_0a = KSL_MUL(qi->x, dci[1]), qo_0b = KSL_MUL(qi->w, dci[0]), qo_0 = qo_0a + qo_0b,
      qo_0_right = qo_0 - qo_0a, qo_0_left = qo_0 - qo_0_right,
      qo_0_left_rest = ksl_product_rest(qi->x, dci[1], qo_0a, qo_0_left),
      qo_0_right_rest = ksl_product_rest(qi->w, dci[0], qo_0b, qo_0_right),
      qo_0_lo = qo_0_left_rest + qo_0_right_rest;
  const double qo_1a = KSL_MUL(qi->y, dci[1]), qo_1b = KSL_MUL(qi->z, dci[0]), qo_1 = qo_1a + qo_1b,
      qo_1_right = qo_1 - qo_1a, qo_1_left = qo_1 - qo_1_right,
      qo_1_left_rest = ksl_product_rest(qi->y, dci[1], qo_1a, qo_1_left),
      qo_1_right_rest = ksl_product_rest(qi->z, dci[0], qo_1b, qo_1_right),
      qo_1_lo = qo_1_left_rest + qo_1_right_rest;
  const double qo_2a = KSL_MUL(qi->z, dci[1]), qo_2b = KSL_MUL(qi->y, dci[0]), qo_2 = qo_2a - qo_2b,
      qo_2_right = qo_2a - qo_2, qo_2_left = qo_2 + qo_2_right,
      qo_2_left_rest = ksl_product_rest(qi->z, dci[1], qo_2a, qo_2_left),
      qo_2_right_rest = ksl_product_rest(qi->y, dci[0], qo_2b, qo_2_right),
      qo_2_lo = qo_2_left_rest - qo_2_right_rest;
  const double qo_3a = KSL_MUL(qi->w, dci[1]), qo_3b = KSL_MUL(qi->x, dci[0]), qo_3 = qo_3a - qo_3b,
      qo_3_right = qo_3a - qo_3, qo_3_left = qo_3 + qo_3_right,
      qo_3_left_rest = ksl_product_rest(qi->w, dci[1], qo_3a, qo_3_left),
      qo_3_right_rest = ksl_product_rest(qi->x, dci[0], qo_3b, qo_3_right),
      qo_3_lo = qo_3_left_rest - qo_3_right_rest;
  const double qo_0_rounded = qo_0 + qo_0_lo;
  const double qo_1_rounded = qo_1 + qo_1_lo;
  const double qo_2_rounded = qo_2 + qo_2_lo;
  const double qo_3_rounded = qo_3 + qo_3_lo;
  qo->x = qo_0_rounded;
  qo->y = qo_1_rounded;
  qo->z = qo_2_rounded;
  qo->w = qo_3_rounded;
}

/* qo = qi (s e_x; c)*, dci = (s, c), sine and cosine of half the angle.
   qi, qo: quaternion (x, y, z, w), the scalar last; dci: (sin θ, cos θ).
   8 mul, 20 add, 8 product rest.
   Error <= u |result| + 6 u^2 S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_quaternion_product_qqxconj_accurate(const ksl_quaternion_t *qi,
    const double dci[2], ksl_quaternion_t *qo) {
  const double qo_0a = KSL_MUL(qi->x, dci[1]), qo_0b = KSL_MUL(qi->w, dci[0]), qo_0 = qo_0a - qo_0b,
      qo_0_right = qo_0a - qo_0, qo_0_left = qo_0 + qo_0_right,
      qo_0_left_rest = ksl_product_rest(qi->x, dci[1], qo_0a, qo_0_left),
      qo_0_right_rest = ksl_product_rest(qi->w, dci[0], qo_0b, qo_0_right),
      qo_0_lo = qo_0_left_rest - qo_0_right_rest;
  const double qo_1a = KSL_MUL(qi->y, dci[1]), qo_1b = KSL_MUL(qi->z, dci[0]), qo_1 = qo_1a - qo_1b,
      qo_1_right = qo_1a - qo_1, qo_1_left = qo_1 + qo_1_right,
      qo_1_left_rest = ksl_product_rest(qi->y, dci[1], qo_1a, qo_1_left),
      qo_1_right_rest = ksl_product_rest(qi->z, dci[0], qo_1b, qo_1_right),
      qo_1_lo = qo_1_left_rest - qo_1_right_rest;
  const double qo_2a = KSL_MUL(qi->y, dci[0]), qo_2b = KSL_MUL(qi->z, dci[1]), qo_2 = qo_2a + qo_2b,
      qo_2_right = qo_2 - qo_2a, qo_2_left = qo_2 - qo_2_right,
      qo_2_left_rest = ksl_product_rest(qi->y, dci[0], qo_2a, qo_2_left),
      qo_2_right_rest = ksl_product_rest(qi->z, dci[1], qo_2b, qo_2_right),
      qo_2_lo = qo_2_left_rest + qo_2_right_rest;
  const double qo_3a = KSL_MUL(qi->x, dci[0]), qo_3b = KSL_MUL(qi->w, dci[1]), qo_3 = qo_3a + qo_3b,
      qo_3_right = qo_3 - qo_3a, qo_3_left = qo_3 - qo_3_right,
      qo_3_left_rest = ksl_product_rest(qi->x, dci[0], qo_3a, qo_3_left),
      qo_3_right_rest = ksl_product_rest(qi->w, dci[1], qo_3b, qo_3_right),
      qo_3_lo = qo_3_left_rest + qo_3_right_rest;
  const double qo_0_rounded = qo_0 + qo_0_lo;
  const double qo_1_rounded = qo_1 + qo_1_lo;
  const double qo_2_rounded = qo_2 + qo_2_lo;
  const double qo_3_rounded = qo_3 + qo_3_lo;
  qo->x = qo_0_rounded;
  qo->y = qo_1_rounded;
  qo->z = qo_2_rounded;
  qo->w = qo_3_rounded;
}

/* qo = qi* (s e_x; c), dci = (s, c), sine and cosine of half the angle.
   qi, qo: quaternion (x, y, z, w), the scalar last; dci: (sin θ, cos θ).
   8 mul, 20 add, 8 product rest, 2 neg.
   Error <= u |result| + 6 u^2 S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_quaternion_product_qconjqx_accurate(const ksl_quaternion_t *qi,
    const double dci[2], ksl_quaternion_t *qo) {
  const double qo_0a = KSL_MUL(qi->w, dci[0]), qo_0b = KSL_MUL(qi->x, dci[1]), qo_0 = qo_0a - qo_0b,
      qo_0_right = qo_0a - qo_0, qo_0_left = qo_0 + qo_0_right,
      qo_0_left_rest = ksl_product_rest(qi->w, dci[0], qo_0a, qo_0_left),
      qo_0_right_rest = ksl_product_rest(qi->x, dci[1], qo_0b, qo_0_right),
      qo_0_lo = qo_0_left_rest - qo_0_right_rest;
  const double qo_1a = KSL_MUL(qi->y, dci[1]), qo_1b = KSL_MUL(qi->z, dci[0]),
      qo_1c = qo_1a + qo_1b, qo_1c_right = qo_1c - qo_1a, qo_1c_left = qo_1c - qo_1c_right,
      qo_1c_left_rest = ksl_product_rest(qi->y, dci[1], qo_1a, qo_1c_left),
      qo_1c_right_rest = ksl_product_rest(qi->z, dci[0], qo_1b, qo_1c_right),
      qo_1c_lo = qo_1c_left_rest + qo_1c_right_rest, qo_1 = -qo_1c, qo_1_lo = -qo_1c_lo;
  const double qo_2a = KSL_MUL(qi->y, dci[0]), qo_2b = KSL_MUL(qi->z, dci[1]), qo_2 = qo_2a - qo_2b,
      qo_2_right = qo_2a - qo_2, qo_2_left = qo_2 + qo_2_right,
      qo_2_left_rest = ksl_product_rest(qi->y, dci[0], qo_2a, qo_2_left),
      qo_2_right_rest = ksl_product_rest(qi->z, dci[1], qo_2b, qo_2_right),
      qo_2_lo = qo_2_left_rest - qo_2_right_rest;
  const double qo_3a = KSL_MUL(qi->x, dci[0]), qo_3b = KSL_MUL(qi->w, dci[1]), qo_3 = qo_3a + qo_3b,
      qo_3_right = qo_3 - qo_3a, qo_3_left = qo_3 - qo_3_right,
      qo_3_left_rest = ksl_product_rest(qi->x, dci[0], qo_3a, qo_3_left),
      qo_3_right_rest = ksl_product_rest(qi->w, dci[1], qo_3b, qo_3_right),
      qo_3_lo = qo_3_left_rest + qo_3_right_rest;
  const double qo_0_rounded = qo_0 + qo_0_lo;
  const double qo_1_rounded = qo_1 + qo_1_lo;
  const double qo_2_rounded = qo_2 + qo_2_lo;
  const double qo_3_rounded = qo_3 + qo_3_lo;
  qo->x = qo_0_rounded;
  qo->y = qo_1_rounded;
  qo->z = qo_2_rounded;
  qo->w = qo_3_rounded;
}

/* qo = qi* (s e_x; c)*, dci = (s, c), sine and cosine of half the angle.
   qi, qo: quaternion (x, y, z, w), the scalar last; dci: (sin θ, cos θ).
   8 mul, 20 add, 8 product rest, 4 neg.
   Error <= u |result| + 6 u^2 S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_quaternion_product_qconjqxconj_accurate(const ksl_quaternion_t *qi,
    const double dci[2], ksl_quaternion_t *qo) {
  const double qo_0a = KSL_MUL(qi->x, dci[1]), qo_0b = KSL_MUL(qi->w, dci[0]),
      qo_0c = qo_0a + qo_0b, qo_0c_right = qo_0c - qo_0a, qo_0c_left = qo_0c - qo_0c_right,
      qo_0c_left_rest = ksl_product_rest(qi->x, dci[1], qo_0a, qo_0c_left),
      qo_0c_right_rest = ksl_product_rest(qi->w, dci[0], qo_0b, qo_0c_right),
      qo_0c_lo = qo_0c_left_rest + qo_0c_right_rest, qo_0 = -qo_0c, qo_0_lo = -qo_0c_lo;
  const double qo_1a = KSL_MUL(qi->z, dci[0]), qo_1b = KSL_MUL(qi->y, dci[1]), qo_1 = qo_1a - qo_1b,
      qo_1_right = qo_1a - qo_1, qo_1_left = qo_1 + qo_1_right,
      qo_1_left_rest = ksl_product_rest(qi->z, dci[0], qo_1a, qo_1_left),
      qo_1_right_rest = ksl_product_rest(qi->y, dci[1], qo_1b, qo_1_right),
      qo_1_lo = qo_1_left_rest - qo_1_right_rest;
  const double qo_2a = KSL_MUL(qi->y, dci[0]), qo_2b = KSL_MUL(qi->z, dci[1]),
      qo_2c = qo_2a + qo_2b, qo_2c_right = qo_2c - qo_2a, qo_2c_left = qo_2c - qo_2c_right,
      qo_2c_left_rest = ksl_product_rest(qi->y, dci[0], qo_2a, qo_2c_left),
      qo_2c_right_rest = ksl_product_rest(qi->z, dci[1], qo_2b, qo_2c_right),
      qo_2c_lo = qo_2c_left_rest + qo_2c_right_rest, qo_2 = -qo_2c, qo_2_lo = -qo_2c_lo;
  const double qo_3a = KSL_MUL(qi->w, dci[1]), qo_3b = KSL_MUL(qi->x, dci[0]), qo_3 = qo_3a - qo_3b,
      qo_3_right = qo_3a - qo_3, qo_3_left = qo_3 + qo_3_right,
      qo_3_left_rest = ksl_product_rest(qi->w, dci[1], qo_3a, qo_3_left),
      qo_3_right_rest = ksl_product_rest(qi->x, dci[0], qo_3b, qo_3_right),
      qo_3_lo = qo_3_left_rest - qo_3_right_rest;
  const double qo_0_rounded = qo_0 + qo_0_lo;
  const double qo_1_rounded = qo_1 + qo_1_lo;
  const double qo_2_rounded = qo_2 + qo_2_lo;
  const double qo_3_rounded = qo_3 + qo_3_lo;
  qo->x = qo_0_rounded;
  qo->y = qo_1_rounded;
  qo->z = qo_2_rounded;
  qo->w = qo_3_rounded;
}

/* qo = (s e_y; c) qi, dci = (s, c), sine and cosine of half the angle.
   dci: (sin θ, cos θ); qi, qo: quaternion (x, y, z, w), the scalar last.
   8 mul, 20 add, 8 product rest.
   Error <= u |result| + 6 u^2 S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_quaternion_product_qyq_accurate(const double dci[2],
    const ksl_quaternion_t *qi, ksl_quaternion_t *qo) {
  const double qo_0a = KSL_MUL(dci[0], qi->z), qo_0b = KSL_MUL(dci[1], qi->x), qo_0 = qo_0a + qo_0b,
      qo_0_right = qo_0 - qo_0a, qo_0_left = qo_0 - qo_0_right,
      qo_0_left_rest = ksl_product_rest(dci[0], qi->z, qo_0a, qo_0_left),
      qo_0_right_rest = ksl_product_rest(dci[1], qi->x, qo_0b, qo_0_right),
      qo_0_lo = qo_0_left_rest + qo_0_right_rest;
  const double qo_1a = KSL_MUL(dci[0], qi->w), qo_1b = KSL_MUL(dci[1], qi->y), qo_1 = qo_1a + qo_1b,
      qo_1_right = qo_1 - qo_1a, qo_1_left = qo_1 - qo_1_right,
      qo_1_left_rest = ksl_product_rest(dci[0], qi->w, qo_1a, qo_1_left),
      qo_1_right_rest = ksl_product_rest(dci[1], qi->y, qo_1b, qo_1_right),
      qo_1_lo = qo_1_left_rest + qo_1_right_rest;
  const double qo_2a = KSL_MUL(dci[1], qi->z), qo_2b = KSL_MUL(dci[0], qi->x), qo_2 = qo_2a - qo_2b,
      qo_2_right = qo_2a - qo_2, qo_2_left = qo_2 + qo_2_right,
      qo_2_left_rest = ksl_product_rest(dci[1], qi->z, qo_2a, qo_2_left),
      qo_2_right_rest = ksl_product_rest(dci[0], qi->x, qo_2b, qo_2_right),
      qo_2_lo = qo_2_left_rest - qo_2_right_rest;
  const double qo_3a = KSL_MUL(dci[1], qi->w), qo_3b = KSL_MUL(dci[0], qi->y), qo_3 = qo_3a - qo_3b,
      qo_3_right = qo_3a - qo_3, qo_3_left = qo_3 + qo_3_right,
      qo_3_left_rest = ksl_product_rest(dci[1], qi->w, qo_3a, qo_3_left),
      qo_3_right_rest = ksl_product_rest(dci[0], qi->y, qo_3b, qo_3_right),
      qo_3_lo = qo_3_left_rest - qo_3_right_rest;
  const double qo_0_rounded = qo_0 + qo_0_lo;
  const double qo_1_rounded = qo_1 + qo_1_lo;
  const double qo_2_rounded = qo_2 + qo_2_lo;
  const double qo_3_rounded = qo_3 + qo_3_lo;
  qo->x = qo_0_rounded;
  qo->y = qo_1_rounded;
  qo->z = qo_2_rounded;
  qo->w = qo_3_rounded;
}

/* qo = (s e_y; c) qi*, dci = (s, c), sine and cosine of half the angle.
   dci: (sin θ, cos θ); qi, qo: quaternion (x, y, z, w), the scalar last.
   8 mul, 20 add, 8 product rest, 2 neg.
   Error <= u |result| + 6 u^2 S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_quaternion_product_qyqconj_accurate(const double dci[2],
    const ksl_quaternion_t *qi, ksl_quaternion_t *qo) {
  const double qo_0a = KSL_MUL(dci[0], qi->z), qo_0b = KSL_MUL(dci[1], qi->x),
      qo_0c = qo_0a + qo_0b, qo_0c_right = qo_0c - qo_0a, qo_0c_left = qo_0c - qo_0c_right,
      qo_0c_left_rest = ksl_product_rest(dci[0], qi->z, qo_0a, qo_0c_left),
      qo_0c_right_rest = ksl_product_rest(dci[1], qi->x, qo_0b, qo_0c_right),
      qo_0c_lo = qo_0c_left_rest + qo_0c_right_rest, qo_0 = -qo_0c, qo_0_lo = -qo_0c_lo;
  const double qo_1a = KSL_MUL(dci[0], qi->w), qo_1b = KSL_MUL(dci[1], qi->y), qo_1 = qo_1a - qo_1b,
      qo_1_right = qo_1a - qo_1, qo_1_left = qo_1 + qo_1_right,
      qo_1_left_rest = ksl_product_rest(dci[0], qi->w, qo_1a, qo_1_left),
      qo_1_right_rest = ksl_product_rest(dci[1], qi->y, qo_1b, qo_1_right),
      qo_1_lo = qo_1_left_rest - qo_1_right_rest;
  const double qo_2a = KSL_MUL(dci[0], qi->x), qo_2b = KSL_MUL(dci[1], qi->z), qo_2 = qo_2a - qo_2b,
      qo_2_right = qo_2a - qo_2, qo_2_left = qo_2 + qo_2_right,
      qo_2_left_rest = ksl_product_rest(dci[0], qi->x, qo_2a, qo_2_left),
      qo_2_right_rest = ksl_product_rest(dci[1], qi->z, qo_2b, qo_2_right),
      qo_2_lo = qo_2_left_rest - qo_2_right_rest;
  const double qo_3a = KSL_MUL(dci[0], qi->y), qo_3b = KSL_MUL(dci[1], qi->w), qo_3 = qo_3a + qo_3b,
      qo_3_right = qo_3 - qo_3a, qo_3_left = qo_3 - qo_3_right,
      qo_3_left_rest = ksl_product_rest(dci[0], qi->y, qo_3a, qo_3_left),
      qo_3_right_rest = ksl_product_rest(dci[1], qi->w, qo_3b, qo_3_right),
      qo_3_lo = qo_3_left_rest + qo_3_right_rest;
  const double qo_0_rounded = qo_0 + qo_0_lo;
  const double qo_1_rounded = qo_1 + qo_1_lo;
  const double qo_2_rounded = qo_2 + qo_2_lo;
  const double qo_3_rounded = qo_3 + qo_3_lo;
  qo->x = qo_0_rounded;
  qo->y = qo_1_rounded;
  qo->z = qo_2_rounded;
  qo->w = qo_3_rounded;
}

/* qo = (s e_y; c)* qi, dci = (s, c), sine and cosine of half the angle.
   dci: (sin θ, cos θ); qi, qo: quaternion (x, y, z, w), the scalar last.
   8 mul, 20 add, 8 product rest.
   Error <= u |result| + 6 u^2 S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_quaternion_product_qyconjq_accurate(const double dci[2],
    const ksl_quaternion_t *qi, ksl_quaternion_t *qo) {
  const double qo_0a = KSL_MUL(dci[1], qi->x), qo_0b = KSL_MUL(dci[0], qi->z), qo_0 = qo_0a - qo_0b,
      qo_0_right = qo_0a - qo_0, qo_0_left = qo_0 + qo_0_right,
      qo_0_left_rest = ksl_product_rest(dci[1], qi->x, qo_0a, qo_0_left),
      qo_0_right_rest = ksl_product_rest(dci[0], qi->z, qo_0b, qo_0_right),
      qo_0_lo = qo_0_left_rest - qo_0_right_rest;
  const double qo_1a = KSL_MUL(dci[1], qi->y), qo_1b = KSL_MUL(dci[0], qi->w), qo_1 = qo_1a - qo_1b,
      qo_1_right = qo_1a - qo_1, qo_1_left = qo_1 + qo_1_right,
      qo_1_left_rest = ksl_product_rest(dci[1], qi->y, qo_1a, qo_1_left),
      qo_1_right_rest = ksl_product_rest(dci[0], qi->w, qo_1b, qo_1_right),
      qo_1_lo = qo_1_left_rest - qo_1_right_rest;
  const double qo_2a = KSL_MUL(dci[0], qi->x), qo_2b = KSL_MUL(dci[1], qi->z), qo_2 = qo_2a + qo_2b,
      qo_2_right = qo_2 - qo_2a, qo_2_left = qo_2 - qo_2_right,
      qo_2_left_rest = ksl_product_rest(dci[0], qi->x, qo_2a, qo_2_left),
      qo_2_right_rest = ksl_product_rest(dci[1], qi->z, qo_2b, qo_2_right),
      qo_2_lo = qo_2_left_rest + qo_2_right_rest;
  const double qo_3a = KSL_MUL(dci[0], qi->y), qo_3b = KSL_MUL(dci[1], qi->w), qo_3 = qo_3a + qo_3b,
      qo_3_right = qo_3 - qo_3a, qo_3_left = qo_3 - qo_3_right,
      qo_3_left_rest = ksl_product_rest(dci[0], qi->y, qo_3a, qo_3_left),
      qo_3_right_rest = ksl_product_rest(dci[1], qi->w, qo_3b, qo_3_right),
      qo_3_lo = qo_3_left_rest + qo_3_right_rest;
  const double qo_0_rounded = qo_0 + qo_0_lo;
  const double qo_1_rounded = qo_1 + qo_1_lo;
  const double qo_2_rounded = qo_2 + qo_2_lo;
  const double qo_3_rounded = qo_3 + qo_3_lo;
  qo->x = qo_0_rounded;
  qo->y = qo_1_rounded;
  qo->z = qo_2_rounded;
  qo->w = qo_3_rounded;
}

/* qo = (s e_y; c)* qi*, dci = (s, c), sine and cosine of half the angle.
   dci: (sin θ, cos θ); qi, qo: quaternion (x, y, z, w), the scalar last.
   8 mul, 20 add, 8 product rest, 4 neg.
   Error <= u |result| + 6 u^2 S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_quaternion_product_qyconjqconj_accurate(const double dci[2],
    const ksl_quaternion_t *qi, ksl_quaternion_t *qo) {
  const double qo_0a = KSL_MUL(dci[0], qi->z), qo_0b = KSL_MUL(dci[1], qi->x), qo_0 = qo_0a - qo_0b,
      qo_0_right = qo_0a - qo_0, qo_0_left = qo_0 + qo_0_right,
      qo_0_left_rest = ksl_product_rest(dci[0], qi->z, qo_0a, qo_0_left),
      qo_0_right_rest = ksl_product_rest(dci[1], qi->x, qo_0b, qo_0_right),
      qo_0_lo = qo_0_left_rest - qo_0_right_rest;
  const double qo_1a = KSL_MUL(dci[0], qi->w), qo_1b = KSL_MUL(dci[1], qi->y),
      qo_1c = qo_1a + qo_1b, qo_1c_right = qo_1c - qo_1a, qo_1c_left = qo_1c - qo_1c_right,
      qo_1c_left_rest = ksl_product_rest(dci[0], qi->w, qo_1a, qo_1c_left),
      qo_1c_right_rest = ksl_product_rest(dci[1], qi->y, qo_1b, qo_1c_right),
      qo_1c_lo = qo_1c_left_rest + qo_1c_right_rest, qo_1 = -qo_1c, qo_1_lo = -qo_1c_lo;
  const double qo_2a = KSL_MUL(dci[0], qi->x), qo_2b = KSL_MUL(dci[1], qi->z),
      qo_2c = qo_2a + qo_2b, qo_2c_right = qo_2c - qo_2a, qo_2c_left = qo_2c - qo_2c_right,
      qo_2c_left_rest = ksl_product_rest(dci[0], qi->x, qo_2a, qo_2c_left),
      qo_2c_right_rest = ksl_product_rest(dci[1], qi->z, qo_2b, qo_2c_right),
      qo_2c_lo = qo_2c_left_rest + qo_2c_right_rest, qo_2 = -qo_2c, qo_2_lo = -qo_2c_lo;
  const double qo_3a = KSL_MUL(dci[1], qi->w), qo_3b = KSL_MUL(dci[0], qi->y), qo_3 = qo_3a - qo_3b,
      qo_3_right = qo_3a - qo_3, qo_3_left = qo_3 + qo_3_right,
      qo_3_left_rest = ksl_product_rest(dci[1], qi->w, qo_3a, qo_3_left),
      qo_3_right_rest = ksl_product_rest(dci[0], qi->y, qo_3b, qo_3_right),
      qo_3_lo = qo_3_left_rest - qo_3_right_rest;
  const double qo_0_rounded = qo_0 + qo_0_lo;
  const double qo_1_rounded = qo_1 + qo_1_lo;
  const double qo_2_rounded = qo_2 + qo_2_lo;
  const double qo_3_rounded = qo_3 + qo_3_lo;
  qo->x = qo_0_rounded;
  qo->y = qo_1_rounded;
  qo->z = qo_2_rounded;
  qo->w = qo_3_rounded;
}

/* qo = qi (s e_y; c), dci = (s, c), sine and cosine of half the angle.
   qi, qo: quaternion (x, y, z, w), the scalar last; dci: (sin θ, cos θ).
   8 mul, 20 add, 8 product rest.
   Error <= u |result| + 6 u^2 S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_quaternion_product_qqy_accurate(const ksl_quaternion_t *qi,
    const double dci[2], ksl_quaternion_t *qo) {
  const double qo_0a = KSL_MUL(qi->x, dci[1]), qo_0b = KSL_MUL(qi->z, dci[0]), qo_0 = qo_0a - qo_0b,
      qo_0_right = qo_0a - qo_0, qo_0_left = qo_0 + qo_0_right,
      qo_0_left_rest = ksl_product_rest(qi->x, dci[1], qo_0a, qo_0_left),
      qo_0_right_rest = ksl_product_rest(qi->z, dci[0], qo_0b, qo_0_right),
      qo_0_lo = qo_0_left_rest - qo_0_right_rest;
  const double qo_1a = KSL_MUL(qi->y, dci[1]), qo_1b = KSL_MUL(qi->w, dci[0]), qo_1 = qo_1a + qo_1b,
      qo_1_right = qo_1 - qo_1a, qo_1_left = qo_1 - qo_1_right,
      qo_1_left_rest = ksl_product_rest(qi->y, dci[1], qo_1a, qo_1_left),
      qo_1_right_rest = ksl_product_rest(qi->w, dci[0], qo_1b, qo_1_right),
      qo_1_lo = qo_1_left_rest + qo_1_right_rest;
  const double qo_2a = KSL_MUL(qi->x, dci[0]), qo_2b = KSL_MUL(qi->z, dci[1]), qo_2 = qo_2a + qo_2b,
      qo_2_right = qo_2 - qo_2a, qo_2_left = qo_2 - qo_2_right,
      qo_2_left_rest = ksl_product_rest(qi->x, dci[0], qo_2a, qo_2_left),
      qo_2_right_rest = ksl_product_rest(qi->z, dci[1], qo_2b, qo_2_right),
      qo_2_lo = qo_2_left_rest + qo_2_right_rest;
  const double qo_3a = KSL_MUL(qi->w, dci[1]), qo_3b = KSL_MUL(qi->y, dci[0]), qo_3 = qo_3a - qo_3b,
      qo_3_right = qo_3a - qo_3, qo_3_left = qo_3 + qo_3_right,
      qo_3_left_rest = ksl_product_rest(qi->w, dci[1], qo_3a, qo_3_left),
      qo_3_right_rest = ksl_product_rest(qi->y, dci[0], qo_3b, qo_3_right),
      qo_3_lo = qo_3_left_rest - qo_3_right_rest;
  const double qo_0_rounded = qo_0 + qo_0_lo;
  const double qo_1_rounded = qo_1 + qo_1_lo;
  const double qo_2_rounded = qo_2 + qo_2_lo;
  const double qo_3_rounded = qo_3 + qo_3_lo;
  qo->x = qo_0_rounded;
  qo->y = qo_1_rounded;
  qo->z = qo_2_rounded;
  qo->w = qo_3_rounded;
}

/* qo = qi (s e_y; c)*, dci = (s, c), sine and cosine of half the angle.
   qi, qo: quaternion (x, y, z, w), the scalar last; dci: (sin θ, cos θ).
   8 mul, 20 add, 8 product rest.
   Error <= u |result| + 6 u^2 S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_quaternion_product_qqyconj_accurate(const ksl_quaternion_t *qi,
    const double dci[2], ksl_quaternion_t *qo) {
  const double qo_0a = KSL_MUL(qi->x, dci[1]), qo_0b = KSL_MUL(qi->z, dci[0]), qo_0 = qo_0a + qo_0b,
      qo_0_right = qo_0 - qo_0a, qo_0_left = qo_0 - qo_0_right,
      qo_0_left_rest = ksl_product_rest(qi->x, dci[1], qo_0a, qo_0_left),
      qo_0_right_rest = ksl_product_rest(qi->z, dci[0], qo_0b, qo_0_right),
      qo_0_lo = qo_0_left_rest + qo_0_right_rest;
  const double qo_1a = KSL_MUL(qi->y, dci[1]), qo_1b = KSL_MUL(qi->w, dci[0]), qo_1 = qo_1a - qo_1b,
      qo_1_right = qo_1a - qo_1, qo_1_left = qo_1 + qo_1_right,
      qo_1_left_rest = ksl_product_rest(qi->y, dci[1], qo_1a, qo_1_left),
      qo_1_right_rest = ksl_product_rest(qi->w, dci[0], qo_1b, qo_1_right),
      qo_1_lo = qo_1_left_rest - qo_1_right_rest;
  const double qo_2a = KSL_MUL(qi->z, dci[1]), qo_2b = KSL_MUL(qi->x, dci[0]), qo_2 = qo_2a - qo_2b,
      qo_2_right = qo_2a - qo_2, qo_2_left = qo_2 + qo_2_right,
      qo_2_left_rest = ksl_product_rest(qi->z, dci[1], qo_2a, qo_2_left),
      qo_2_right_rest = ksl_product_rest(qi->x, dci[0], qo_2b, qo_2_right),
      qo_2_lo = qo_2_left_rest - qo_2_right_rest;
  const double qo_3a = KSL_MUL(qi->y, dci[0]), qo_3b = KSL_MUL(qi->w, dci[1]), qo_3 = qo_3a + qo_3b,
      qo_3_right = qo_3 - qo_3a, qo_3_left = qo_3 - qo_3_right,
      qo_3_left_rest = ksl_product_rest(qi->y, dci[0], qo_3a, qo_3_left),
      qo_3_right_rest = ksl_product_rest(qi->w, dci[1], qo_3b, qo_3_right),
      qo_3_lo = qo_3_left_rest + qo_3_right_rest;
  const double qo_0_rounded = qo_0 + qo_0_lo;
  const double qo_1_rounded = qo_1 + qo_1_lo;
  const double qo_2_rounded = qo_2 + qo_2_lo;
  const double qo_3_rounded = qo_3 + qo_3_lo;
  qo->x = qo_0_rounded;
  qo->y = qo_1_rounded;
  qo->z = qo_2_rounded;
  qo->w = qo_3_rounded;
}

/* qo = qi* (s e_y; c), dci = (s, c), sine and cosine of half the angle.
   qi, qo: quaternion (x, y, z, w), the scalar last; dci: (sin θ, cos θ).
   8 mul, 20 add, 8 product rest, 2 neg.
   Error <= u |result| + 6 u^2 S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_quaternion_product_qconjqy_accurate(const ksl_quaternion_t *qi,
    const double dci[2], ksl_quaternion_t *qo) {
  const double qo_0a = KSL_MUL(qi->z, dci[0]), qo_0b = KSL_MUL(qi->x, dci[1]), qo_0 = qo_0a - qo_0b,
      qo_0_right = qo_0a - qo_0, qo_0_left = qo_0 + qo_0_right,
      qo_0_left_rest = ksl_product_rest(qi->z, dci[0], qo_0a, qo_0_left),
      qo_0_right_rest = ksl_product_rest(qi->x, dci[1], qo_0b, qo_0_right),
      qo_0_lo = qo_0_left_rest - qo_0_right_rest;
  const double qo_1a = KSL_MUL(qi->w, dci[0]), qo_1b = KSL_MUL(qi->y, dci[1]), qo_1 = qo_1a - qo_1b,
      qo_1_right = qo_1a - qo_1, qo_1_left = qo_1 + qo_1_right,
      qo_1_left_rest = ksl_product_rest(qi->w, dci[0], qo_1a, qo_1_left),
      qo_1_right_rest = ksl_product_rest(qi->y, dci[1], qo_1b, qo_1_right),
      qo_1_lo = qo_1_left_rest - qo_1_right_rest;
  const double qo_2a = KSL_MUL(qi->x, dci[0]), qo_2b = KSL_MUL(qi->z, dci[1]),
      qo_2c = qo_2a + qo_2b, qo_2c_right = qo_2c - qo_2a, qo_2c_left = qo_2c - qo_2c_right,
      qo_2c_left_rest = ksl_product_rest(qi->x, dci[0], qo_2a, qo_2c_left),
      qo_2c_right_rest = ksl_product_rest(qi->z, dci[1], qo_2b, qo_2c_right),
      qo_2c_lo = qo_2c_left_rest + qo_2c_right_rest, qo_2 = -qo_2c, qo_2_lo = -qo_2c_lo;
  const double qo_3a = KSL_MUL(qi->y, dci[0]), qo_3b = KSL_MUL(qi->w, dci[1]), qo_3 = qo_3a + qo_3b,
      qo_3_right = qo_3 - qo_3a, qo_3_left = qo_3 - qo_3_right,
      qo_3_left_rest = ksl_product_rest(qi->y, dci[0], qo_3a, qo_3_left),
      qo_3_right_rest = ksl_product_rest(qi->w, dci[1], qo_3b, qo_3_right),
      qo_3_lo = qo_3_left_rest + qo_3_right_rest;
  const double qo_0_rounded = qo_0 + qo_0_lo;
  const double qo_1_rounded = qo_1 + qo_1_lo;
  const double qo_2_rounded = qo_2 + qo_2_lo;
  const double qo_3_rounded = qo_3 + qo_3_lo;
  qo->x = qo_0_rounded;
  qo->y = qo_1_rounded;
  qo->z = qo_2_rounded;
  qo->w = qo_3_rounded;
}

/* qo = qi* (s e_y; c)*, dci = (s, c), sine and cosine of half the angle.
   qi, qo: quaternion (x, y, z, w), the scalar last; dci: (sin θ, cos θ).
   8 mul, 20 add, 8 product rest, 4 neg.
   Error <= u |result| + 6 u^2 S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_quaternion_product_qconjqyconj_accurate(const ksl_quaternion_t *qi,
    const double dci[2], ksl_quaternion_t *qo) {
  const double qo_0a = KSL_MUL(qi->x, dci[1]), qo_0b = KSL_MUL(qi->z, dci[0]),
      qo_0c = qo_0a + qo_0b, qo_0c_right = qo_0c - qo_0a, qo_0c_left = qo_0c - qo_0c_right,
      qo_0c_left_rest = ksl_product_rest(qi->x, dci[1], qo_0a, qo_0c_left),
      qo_0c_right_rest = ksl_product_rest(qi->z, dci[0], qo_0b, qo_0c_right),
      qo_0c_lo = qo_0c_left_rest + qo_0c_right_rest, qo_0 = -qo_0c, qo_0_lo = -qo_0c_lo;
  const double qo_1a = KSL_MUL(qi->y, dci[1]), qo_1b = KSL_MUL(qi->w, dci[0]),
      qo_1c = qo_1a + qo_1b, qo_1c_right = qo_1c - qo_1a, qo_1c_left = qo_1c - qo_1c_right,
      qo_1c_left_rest = ksl_product_rest(qi->y, dci[1], qo_1a, qo_1c_left),
      qo_1c_right_rest = ksl_product_rest(qi->w, dci[0], qo_1b, qo_1c_right),
      qo_1c_lo = qo_1c_left_rest + qo_1c_right_rest, qo_1 = -qo_1c, qo_1_lo = -qo_1c_lo;
  const double qo_2a = KSL_MUL(qi->x, dci[0]), qo_2b = KSL_MUL(qi->z, dci[1]), qo_2 = qo_2a - qo_2b,
      qo_2_right = qo_2a - qo_2, qo_2_left = qo_2 + qo_2_right,
      qo_2_left_rest = ksl_product_rest(qi->x, dci[0], qo_2a, qo_2_left),
      qo_2_right_rest = ksl_product_rest(qi->z, dci[1], qo_2b, qo_2_right),
      qo_2_lo = qo_2_left_rest - qo_2_right_rest;
  const double qo_3a = KSL_MUL(qi->w, dci[1]), qo_3b = KSL_MUL(qi->y, dci[0]), qo_3 = qo_3a - qo_3b,
      qo_3_right = qo_3a - qo_3, qo_3_left = qo_3 + qo_3_right,
      qo_3_left_rest = ksl_product_rest(qi->w, dci[1], qo_3a, qo_3_left),
      qo_3_right_rest = ksl_product_rest(qi->y, dci[0], qo_3b, qo_3_right),
      qo_3_lo = qo_3_left_rest - qo_3_right_rest;
  const double qo_0_rounded = qo_0 + qo_0_lo;
  const double qo_1_rounded = qo_1 + qo_1_lo;
  const double qo_2_rounded = qo_2 + qo_2_lo;
  const double qo_3_rounded = qo_3 + qo_3_lo;
  qo->x = qo_0_rounded;
  qo->y = qo_1_rounded;
  qo->z = qo_2_rounded;
  qo->w = qo_3_rounded;
}

/* qo = (s e_z; c) qi, dci = (s, c), sine and cosine of half the angle.
   dci: (sin θ, cos θ); qi, qo: quaternion (x, y, z, w), the scalar last.
   8 mul, 20 add, 8 product rest.
   Error <= u |result| + 6 u^2 S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_quaternion_product_qzq_accurate(const double dci[2],
    const ksl_quaternion_t *qi, ksl_quaternion_t *qo) {
  const double qo_0a = KSL_MUL(dci[1], qi->x), qo_0b = KSL_MUL(dci[0], qi->y), qo_0 = qo_0a - qo_0b,
      qo_0_right = qo_0a - qo_0, qo_0_left = qo_0 + qo_0_right,
      qo_0_left_rest = ksl_product_rest(dci[1], qi->x, qo_0a, qo_0_left),
      qo_0_right_rest = ksl_product_rest(dci[0], qi->y, qo_0b, qo_0_right),
      qo_0_lo = qo_0_left_rest - qo_0_right_rest;
  const double qo_1a = KSL_MUL(dci[0], qi->x), qo_1b = KSL_MUL(dci[1], qi->y), qo_1 = qo_1a + qo_1b,
      qo_1_right = qo_1 - qo_1a, qo_1_left = qo_1 - qo_1_right,
      qo_1_left_rest = ksl_product_rest(dci[0], qi->x, qo_1a, qo_1_left),
      qo_1_right_rest = ksl_product_rest(dci[1], qi->y, qo_1b, qo_1_right),
      qo_1_lo = qo_1_left_rest + qo_1_right_rest;
  const double qo_2a = KSL_MUL(dci[0], qi->w), qo_2b = KSL_MUL(dci[1], qi->z), qo_2 = qo_2a + qo_2b,
      qo_2_right = qo_2 - qo_2a, qo_2_left = qo_2 - qo_2_right,
      qo_2_left_rest = ksl_product_rest(dci[0], qi->w, qo_2a, qo_2_left),
      qo_2_right_rest = ksl_product_rest(dci[1], qi->z, qo_2b, qo_2_right),
      qo_2_lo = qo_2_left_rest + qo_2_right_rest;
  const double qo_3a = KSL_MUL(dci[1], qi->w), qo_3b = KSL_MUL(dci[0], qi->z), qo_3 = qo_3a - qo_3b,
      qo_3_right = qo_3a - qo_3, qo_3_left = qo_3 + qo_3_right,
      qo_3_left_rest = ksl_product_rest(dci[1], qi->w, qo_3a, qo_3_left),
      qo_3_right_rest = ksl_product_rest(dci[0], qi->z, qo_3b, qo_3_right),
      qo_3_lo = qo_3_left_rest - qo_3_right_rest;
  const double qo_0_rounded = qo_0 + qo_0_lo;
  const double qo_1_rounded = qo_1 + qo_1_lo;
  const double qo_2_rounded = qo_2 + qo_2_lo;
  const double qo_3_rounded = qo_3 + qo_3_lo;
  qo->x = qo_0_rounded;
  qo->y = qo_1_rounded;
  qo->z = qo_2_rounded;
  qo->w = qo_3_rounded;
}

/* qo = (s e_z; c) qi*, dci = (s, c), sine and cosine of half the angle.
   dci: (sin θ, cos θ); qi, qo: quaternion (x, y, z, w), the scalar last.
   8 mul, 20 add, 8 product rest, 2 neg.
   Error <= u |result| + 6 u^2 S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_quaternion_product_qzqconj_accurate(const double dci[2],
    const ksl_quaternion_t *qi, ksl_quaternion_t *qo) {
  const double qo_0a = KSL_MUL(dci[0], qi->y), qo_0b = KSL_MUL(dci[1], qi->x), qo_0 = qo_0a - qo_0b,
      qo_0_right = qo_0a - qo_0, qo_0_left = qo_0 + qo_0_right,
      qo_0_left_rest = ksl_product_rest(dci[0], qi->y, qo_0a, qo_0_left),
      qo_0_right_rest = ksl_product_rest(dci[1], qi->x, qo_0b, qo_0_right),
      qo_0_lo = qo_0_left_rest - qo_0_right_rest;
  const double qo_1a = KSL_MUL(dci[0], qi->x), qo_1b = KSL_MUL(dci[1], qi->y),
      qo_1c = qo_1a + qo_1b, qo_1c_right = qo_1c - qo_1a, qo_1c_left = qo_1c - qo_1c_right,
      qo_1c_left_rest = ksl_product_rest(dci[0], qi->x, qo_1a, qo_1c_left),
      qo_1c_right_rest = ksl_product_rest(dci[1], qi->y, qo_1b, qo_1c_right),
      qo_1c_lo = qo_1c_left_rest + qo_1c_right_rest, qo_1 = -qo_1c, qo_1_lo = -qo_1c_lo;
  const double qo_2a = KSL_MUL(dci[0], qi->w), qo_2b = KSL_MUL(dci[1], qi->z), qo_2 = qo_2a - qo_2b,
      qo_2_right = qo_2a - qo_2, qo_2_left = qo_2 + qo_2_right,
      qo_2_left_rest = ksl_product_rest(dci[0], qi->w, qo_2a, qo_2_left),
      qo_2_right_rest = ksl_product_rest(dci[1], qi->z, qo_2b, qo_2_right),
      qo_2_lo = qo_2_left_rest - qo_2_right_rest;
  const double qo_3a = KSL_MUL(dci[0], qi->z), qo_3b = KSL_MUL(dci[1], qi->w), qo_3 = qo_3a + qo_3b,
      qo_3_right = qo_3 - qo_3a, qo_3_left = qo_3 - qo_3_right,
      qo_3_left_rest = ksl_product_rest(dci[0], qi->z, qo_3a, qo_3_left),
      qo_3_right_rest = ksl_product_rest(dci[1], qi->w, qo_3b, qo_3_right),
      qo_3_lo = qo_3_left_rest + qo_3_right_rest;
  const double qo_0_rounded = qo_0 + qo_0_lo;
  const double qo_1_rounded = qo_1 + qo_1_lo;
  const double qo_2_rounded = qo_2 + qo_2_lo;
  const double qo_3_rounded = qo_3 + qo_3_lo;
  qo->x = qo_0_rounded;
  qo->y = qo_1_rounded;
  qo->z = qo_2_rounded;
  qo->w = qo_3_rounded;
}

/* qo = (s e_z; c)* qi, dci = (s, c), sine and cosine of half the angle.
   dci: (sin θ, cos θ); qi, qo: quaternion (x, y, z, w), the scalar last.
   8 mul, 20 add, 8 product rest.
   Error <= u |result| + 6 u^2 S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_quaternion_product_qzconjq_accurate(const double dci[2],
    const ksl_quaternion_t *qi, ksl_quaternion_t *qo) {
  const double qo_0a = KSL_MUL(dci[0], qi->y), qo_0b = KSL_MUL(dci[1], qi->x), qo_0 = qo_0a + qo_0b,
      qo_0_right = qo_0 - qo_0a, qo_0_left = qo_0 - qo_0_right,
      qo_0_left_rest = ksl_product_rest(dci[0], qi->y, qo_0a, qo_0_left),
      qo_0_right_rest = ksl_product_rest(dci[1], qi->x, qo_0b, qo_0_right),
      qo_0_lo = qo_0_left_rest + qo_0_right_rest;
  const double qo_1a = KSL_MUL(dci[1], qi->y), qo_1b = KSL_MUL(dci[0], qi->x), qo_1 = qo_1a - qo_1b,
      qo_1_right = qo_1a - qo_1, qo_1_left = qo_1 + qo_1_right,
      qo_1_left_rest = ksl_product_rest(dci[1], qi->y, qo_1a, qo_1_left),
      qo_1_right_rest = ksl_product_rest(dci[0], qi->x, qo_1b, qo_1_right),
      qo_1_lo = qo_1_left_rest - qo_1_right_rest;
  const double qo_2a = KSL_MUL(dci[1], qi->z), qo_2b = KSL_MUL(dci[0], qi->w), qo_2 = qo_2a - qo_2b,
      qo_2_right = qo_2a - qo_2, qo_2_left = qo_2 + qo_2_right,
      qo_2_left_rest = ksl_product_rest(dci[1], qi->z, qo_2a, qo_2_left),
      qo_2_right_rest = ksl_product_rest(dci[0], qi->w, qo_2b, qo_2_right),
      qo_2_lo = qo_2_left_rest - qo_2_right_rest;
  const double qo_3a = KSL_MUL(dci[0], qi->z), qo_3b = KSL_MUL(dci[1], qi->w), qo_3 = qo_3a + qo_3b,
      qo_3_right = qo_3 - qo_3a, qo_3_left = qo_3 - qo_3_right,
      qo_3_left_rest = ksl_product_rest(dci[0], qi->z, qo_3a, qo_3_left),
      qo_3_right_rest = ksl_product_rest(dci[1], qi->w, qo_3b, qo_3_right),
      qo_3_lo = qo_3_left_rest + qo_3_right_rest;
  const double qo_0_rounded = qo_0 + qo_0_lo;
  const double qo_1_rounded = qo_1 + qo_1_lo;
  const double qo_2_rounded = qo_2 + qo_2_lo;
  const double qo_3_rounded = qo_3 + qo_3_lo;
  qo->x = qo_0_rounded;
  qo->y = qo_1_rounded;
  qo->z = qo_2_rounded;
  qo->w = qo_3_rounded;
}

/* qo = (s e_z; c)* qi*, dci = (s, c), sine and cosine of half the angle.
   dci: (sin θ, cos θ); qi, qo: quaternion (x, y, z, w), the scalar last.
   8 mul, 20 add, 8 product rest, 4 neg.
   Error <= u |result| + 6 u^2 S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_quaternion_product_qzconjqconj_accurate(const double dci[2],
    const ksl_quaternion_t *qi, ksl_quaternion_t *qo) {
  const double qo_0a = KSL_MUL(dci[0], qi->y), qo_0b = KSL_MUL(dci[1], qi->x),
      qo_0c = qo_0a + qo_0b, qo_0c_right = qo_0c - qo_0a, qo_0c_left = qo_0c - qo_0c_right,
      qo_0c_left_rest = ksl_product_rest(dci[0], qi->y, qo_0a, qo_0c_left),
      qo_0c_right_rest = ksl_product_rest(dci[1], qi->x, qo_0b, qo_0c_right),
      qo_0c_lo = qo_0c_left_rest + qo_0c_right_rest, qo_0 = -qo_0c, qo_0_lo = -qo_0c_lo;
  const double qo_1a = KSL_MUL(dci[0], qi->x), qo_1b = KSL_MUL(dci[1], qi->y), qo_1 = qo_1a - qo_1b,
      qo_1_right = qo_1a - qo_1, qo_1_left = qo_1 + qo_1_right,
      qo_1_left_rest = ksl_product_rest(dci[0], qi->x, qo_1a, qo_1_left),
      qo_1_right_rest = ksl_product_rest(dci[1], qi->y, qo_1b, qo_1_right),
      qo_1_lo = qo_1_left_rest - qo_1_right_rest;
  const double qo_2a = KSL_MUL(dci[0], qi->w), qo_2b = KSL_MUL(dci[1], qi->z),
      qo_2c = qo_2a + qo_2b, qo_2c_right = qo_2c - qo_2a, qo_2c_left = qo_2c - qo_2c_right,
      qo_2c_left_rest = ksl_product_rest(dci[0], qi->w, qo_2a, qo_2c_left),
      qo_2c_right_rest = ksl_product_rest(dci[1], qi->z, qo_2b, qo_2c_right),
      qo_2c_lo = qo_2c_left_rest + qo_2c_right_rest, qo_2 = -qo_2c, qo_2_lo = -qo_2c_lo;
  const double qo_3a = KSL_MUL(dci[1], qi->w), qo_3b = KSL_MUL(dci[0], qi->z), qo_3 = qo_3a - qo_3b,
      qo_3_right = qo_3a - qo_3, qo_3_left = qo_3 + qo_3_right,
      qo_3_left_rest = ksl_product_rest(dci[1], qi->w, qo_3a, qo_3_left),
      qo_3_right_rest = ksl_product_rest(dci[0], qi->z, qo_3b, qo_3_right),
      qo_3_lo = qo_3_left_rest - qo_3_right_rest;
  const double qo_0_rounded = qo_0 + qo_0_lo;
  const double qo_1_rounded = qo_1 + qo_1_lo;
  const double qo_2_rounded = qo_2 + qo_2_lo;
  const double qo_3_rounded = qo_3 + qo_3_lo;
  qo->x = qo_0_rounded;
  qo->y = qo_1_rounded;
  qo->z = qo_2_rounded;
  qo->w = qo_3_rounded;
}

/* qo = qi (s e_z; c), dci = (s, c), sine and cosine of half the angle.
   qi, qo: quaternion (x, y, z, w), the scalar last; dci: (sin θ, cos θ).
   8 mul, 20 add, 8 product rest.
   Error <= u |result| + 6 u^2 S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_quaternion_product_qqz_accurate(const ksl_quaternion_t *qi,
    const double dci[2], ksl_quaternion_t *qo) {
  const double qo_0a = KSL_MUL(qi->x, dci[1]), qo_0b = KSL_MUL(qi->y, dci[0]), qo_0 = qo_0a + qo_0b,
      qo_0_right = qo_0 - qo_0a, qo_0_left = qo_0 - qo_0_right,
      qo_0_left_rest = ksl_product_rest(qi->x, dci[1], qo_0a, qo_0_left),
      qo_0_right_rest = ksl_product_rest(qi->y, dci[0], qo_0b, qo_0_right),
      qo_0_lo = qo_0_left_rest + qo_0_right_rest;
  const double qo_1a = KSL_MUL(qi->y, dci[1]), qo_1b = KSL_MUL(qi->x, dci[0]), qo_1 = qo_1a - qo_1b,
      qo_1_right = qo_1a - qo_1, qo_1_left = qo_1 + qo_1_right,
      qo_1_left_rest = ksl_product_rest(qi->y, dci[1], qo_1a, qo_1_left),
      qo_1_right_rest = ksl_product_rest(qi->x, dci[0], qo_1b, qo_1_right),
      qo_1_lo = qo_1_left_rest - qo_1_right_rest;
  const double qo_2a = KSL_MUL(qi->z, dci[1]), qo_2b = KSL_MUL(qi->w, dci[0]), qo_2 = qo_2a + qo_2b,
      qo_2_right = qo_2 - qo_2a, qo_2_left = qo_2 - qo_2_right,
      qo_2_left_rest = ksl_product_rest(qi->z, dci[1], qo_2a, qo_2_left),
      qo_2_right_rest = ksl_product_rest(qi->w, dci[0], qo_2b, qo_2_right),
      qo_2_lo = qo_2_left_rest + qo_2_right_rest;
  const double qo_3a = KSL_MUL(qi->w, dci[1]), qo_3b = KSL_MUL(qi->z, dci[0]), qo_3 = qo_3a - qo_3b,
      qo_3_right = qo_3a - qo_3, qo_3_left = qo_3 + qo_3_right,
      qo_3_left_rest = ksl_product_rest(qi->w, dci[1], qo_3a, qo_3_left),
      qo_3_right_rest = ksl_product_rest(qi->z, dci[0], qo_3b, qo_3_right),
      qo_3_lo = qo_3_left_rest - qo_3_right_rest;
  const double qo_0_rounded = qo_0 + qo_0_lo;
  const double qo_1_rounded = qo_1 + qo_1_lo;
  const double qo_2_rounded = qo_2 + qo_2_lo;
  const double qo_3_rounded = qo_3 + qo_3_lo;
  qo->x = qo_0_rounded;
  qo->y = qo_1_rounded;
  qo->z = qo_2_rounded;
  qo->w = qo_3_rounded;
}

/* qo = qi (s e_z; c)*, dci = (s, c), sine and cosine of half the angle.
   qi, qo: quaternion (x, y, z, w), the scalar last; dci: (sin θ, cos θ).
   8 mul, 20 add, 8 product rest.
   Error <= u |result| + 6 u^2 S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_quaternion_product_qqzconj_accurate(const ksl_quaternion_t *qi,
    const double dci[2], ksl_quaternion_t *qo) {
  const double qo_0a = KSL_MUL(qi->x, dci[1]), qo_0b = KSL_MUL(qi->y, dci[0]), qo_0 = qo_0a - qo_0b,
      qo_0_right = qo_0a - qo_0, qo_0_left = qo_0 + qo_0_right,
      qo_0_left_rest = ksl_product_rest(qi->x, dci[1], qo_0a, qo_0_left),
      qo_0_right_rest = ksl_product_rest(qi->y, dci[0], qo_0b, qo_0_right),
      qo_0_lo = qo_0_left_rest - qo_0_right_rest;
  const double qo_1a = KSL_MUL(qi->x, dci[0]), qo_1b = KSL_MUL(qi->y, dci[1]), qo_1 = qo_1a + qo_1b,
      qo_1_right = qo_1 - qo_1a, qo_1_left = qo_1 - qo_1_right,
      qo_1_left_rest = ksl_product_rest(qi->x, dci[0], qo_1a, qo_1_left),
      qo_1_right_rest = ksl_product_rest(qi->y, dci[1], qo_1b, qo_1_right),
      qo_1_lo = qo_1_left_rest + qo_1_right_rest;
  const double qo_2a = KSL_MUL(qi->z, dci[1]), qo_2b = KSL_MUL(qi->w, dci[0]), qo_2 = qo_2a - qo_2b,
      qo_2_right = qo_2a - qo_2, qo_2_left = qo_2 + qo_2_right,
      qo_2_left_rest = ksl_product_rest(qi->z, dci[1], qo_2a, qo_2_left),
      qo_2_right_rest = ksl_product_rest(qi->w, dci[0], qo_2b, qo_2_right),
      qo_2_lo = qo_2_left_rest - qo_2_right_rest;
  const double qo_3a = KSL_MUL(qi->z, dci[0]), qo_3b = KSL_MUL(qi->w, dci[1]), qo_3 = qo_3a + qo_3b,
      qo_3_right = qo_3 - qo_3a, qo_3_left = qo_3 - qo_3_right,
      qo_3_left_rest = ksl_product_rest(qi->z, dci[0], qo_3a, qo_3_left),
      qo_3_right_rest = ksl_product_rest(qi->w, dci[1], qo_3b, qo_3_right),
      qo_3_lo = qo_3_left_rest + qo_3_right_rest;
  const double qo_0_rounded = qo_0 + qo_0_lo;
  const double qo_1_rounded = qo_1 + qo_1_lo;
  const double qo_2_rounded = qo_2 + qo_2_lo;
  const double qo_3_rounded = qo_3 + qo_3_lo;
  qo->x = qo_0_rounded;
  qo->y = qo_1_rounded;
  qo->z = qo_2_rounded;
  qo->w = qo_3_rounded;
}

/* qo = qi* (s e_z; c), dci = (s, c), sine and cosine of half the angle.
   qi, qo: quaternion (x, y, z, w), the scalar last; dci: (sin θ, cos θ).
   8 mul, 20 add, 8 product rest, 2 neg.
   Error <= u |result| + 6 u^2 S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_quaternion_product_qconjqz_accurate(const ksl_quaternion_t *qi,
    const double dci[2], ksl_quaternion_t *qo) {
  const double qo_0a = KSL_MUL(qi->x, dci[1]), qo_0b = KSL_MUL(qi->y, dci[0]),
      qo_0c = qo_0a + qo_0b, qo_0c_right = qo_0c - qo_0a, qo_0c_left = qo_0c - qo_0c_right,
      qo_0c_left_rest = ksl_product_rest(qi->x, dci[1], qo_0a, qo_0c_left),
      qo_0c_right_rest = ksl_product_rest(qi->y, dci[0], qo_0b, qo_0c_right),
      qo_0c_lo = qo_0c_left_rest + qo_0c_right_rest, qo_0 = -qo_0c, qo_0_lo = -qo_0c_lo;
  const double qo_1a = KSL_MUL(qi->x, dci[0]), qo_1b = KSL_MUL(qi->y, dci[1]), qo_1 = qo_1a - qo_1b,
      qo_1_right = qo_1a - qo_1, qo_1_left = qo_1 + qo_1_right,
      qo_1_left_rest = ksl_product_rest(qi->x, dci[0], qo_1a, qo_1_left),
      qo_1_right_rest = ksl_product_rest(qi->y, dci[1], qo_1b, qo_1_right),
      qo_1_lo = qo_1_left_rest - qo_1_right_rest;
  const double qo_2a = KSL_MUL(qi->w, dci[0]), qo_2b = KSL_MUL(qi->z, dci[1]), qo_2 = qo_2a - qo_2b,
      qo_2_right = qo_2a - qo_2, qo_2_left = qo_2 + qo_2_right,
      qo_2_left_rest = ksl_product_rest(qi->w, dci[0], qo_2a, qo_2_left),
      qo_2_right_rest = ksl_product_rest(qi->z, dci[1], qo_2b, qo_2_right),
      qo_2_lo = qo_2_left_rest - qo_2_right_rest;
  const double qo_3a = KSL_MUL(qi->z, dci[0]), qo_3b = KSL_MUL(qi->w, dci[1]), qo_3 = qo_3a + qo_3b,
      qo_3_right = qo_3 - qo_3a, qo_3_left = qo_3 - qo_3_right,
      qo_3_left_rest = ksl_product_rest(qi->z, dci[0], qo_3a, qo_3_left),
      qo_3_right_rest = ksl_product_rest(qi->w, dci[1], qo_3b, qo_3_right),
      qo_3_lo = qo_3_left_rest + qo_3_right_rest;
  const double qo_0_rounded = qo_0 + qo_0_lo;
  const double qo_1_rounded = qo_1 + qo_1_lo;
  const double qo_2_rounded = qo_2 + qo_2_lo;
  const double qo_3_rounded = qo_3 + qo_3_lo;
  qo->x = qo_0_rounded;
  qo->y = qo_1_rounded;
  qo->z = qo_2_rounded;
  qo->w = qo_3_rounded;
}

/* qo = qi* (s e_z; c)*, dci = (s, c), sine and cosine of half the angle.
   qi, qo: quaternion (x, y, z, w), the scalar last; dci: (sin θ, cos θ).
   8 mul, 20 add, 8 product rest, 4 neg.
   Error <= u |result| + 6 u^2 S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_quaternion_product_qconjqzconj_accurate(const ksl_quaternion_t *qi,
    const double dci[2], ksl_quaternion_t *qo) {
  const double qo_0a = KSL_MUL(qi->y, dci[0]), qo_0b = KSL_MUL(qi->x, dci[1]), qo_0 = qo_0a - qo_0b,
      qo_0_right = qo_0a - qo_0, qo_0_left = qo_0 + qo_0_right,
      qo_0_left_rest = ksl_product_rest(qi->y, dci[0], qo_0a, qo_0_left),
      qo_0_right_rest = ksl_product_rest(qi->x, dci[1], qo_0b, qo_0_right),
      qo_0_lo = qo_0_left_rest - qo_0_right_rest;
  const double qo_1a = KSL_MUL(qi->x, dci[0]), qo_1b = KSL_MUL(qi->y, dci[1]),
      qo_1c = qo_1a + qo_1b, qo_1c_right = qo_1c - qo_1a, qo_1c_left = qo_1c - qo_1c_right,
      qo_1c_left_rest = ksl_product_rest(qi->x, dci[0], qo_1a, qo_1c_left),
      qo_1c_right_rest = ksl_product_rest(qi->y, dci[1], qo_1b, qo_1c_right),
      qo_1c_lo = qo_1c_left_rest + qo_1c_right_rest, qo_1 = -qo_1c, qo_1_lo = -qo_1c_lo;
  const double qo_2a = KSL_MUL(qi->z, dci[1]), qo_2b = KSL_MUL(qi->w, dci[0]),
      qo_2c = qo_2a + qo_2b, qo_2c_right = qo_2c - qo_2a, qo_2c_left = qo_2c - qo_2c_right,
      qo_2c_left_rest = ksl_product_rest(qi->z, dci[1], qo_2a, qo_2c_left),
      qo_2c_right_rest = ksl_product_rest(qi->w, dci[0], qo_2b, qo_2c_right),
      qo_2c_lo = qo_2c_left_rest + qo_2c_right_rest, qo_2 = -qo_2c, qo_2_lo = -qo_2c_lo;
  const double qo_3a = KSL_MUL(qi->w, dci[1]), qo_3b = KSL_MUL(qi->z, dci[0]), qo_3 = qo_3a - qo_3b,
      qo_3_right = qo_3a - qo_3, qo_3_left = qo_3 + qo_3_right,
      qo_3_left_rest = ksl_product_rest(qi->w, dci[1], qo_3a, qo_3_left),
      qo_3_right_rest = ksl_product_rest(qi->z, dci[0], qo_3b, qo_3_right),
      qo_3_lo = qo_3_left_rest - qo_3_right_rest;
  const double qo_0_rounded = qo_0 + qo_0_lo;
  const double qo_1_rounded = qo_1 + qo_1_lo;
  const double qo_2_rounded = qo_2 + qo_2_lo;
  const double qo_3_rounded = qo_3 + qo_3_lo;
  qo->x = qo_0_rounded;
  qo->y = qo_1_rounded;
  qo->z = qo_2_rounded;
  qo->w = qo_3_rounded;
}

/* qo = qi (vi; 0).
   qi, qo: quaternion (x, y, z, w), the scalar last; vi: vector.
   12 mul, 44 add, 12 product rest, 2 neg.
   Error <= u |result| + 11 u^2 S, S the sum of the |terms| of the expanded formula; barring
     over- and underflow. */
static inline void ksl_quaternion_product_qv_accurate(const ksl_quaternion_t *qi,
    const ksl_vec3_t *vi, ksl_quaternion_t *qo) {
  const double qo_0a = KSL_MUL(qi->y, vi->z), qo_0b = KSL_MUL(qi->z, vi->y), qo_0c = qo_0a - qo_0b,
      qo_0c_right = qo_0a - qo_0c, qo_0c_left = qo_0c + qo_0c_right,
      qo_0c_left_rest = ksl_product_rest(qi->y, vi->z, qo_0a, qo_0c_left),
      qo_0c_right_rest = ksl_product_rest(qi->z, vi->y, qo_0b, qo_0c_right),
      qo_0c_lo = qo_0c_left_rest - qo_0c_right_rest, qo_0d = KSL_MUL(qi->w, vi->x),
      qo_0 = qo_0c + qo_0d, qo_0_right = qo_0 - qo_0c, qo_0_left = qo_0 - qo_0_right,
      qo_0_left_rest = qo_0c - qo_0_left,
      qo_0_right_rest = ksl_product_rest(qi->w, vi->x, qo_0d, qo_0_right),
      qo_0_lo1 = qo_0_left_rest + qo_0_right_rest, qo_0_lo = qo_0_lo1 + qo_0c_lo;
  const double qo_1a = KSL_MUL(qi->z, vi->x), qo_1b = KSL_MUL(qi->x, vi->z), qo_1c = qo_1a - qo_1b,
      qo_1c_right = qo_1a - qo_1c, qo_1c_left = qo_1c + qo_1c_right,
      qo_1c_left_rest = ksl_product_rest(qi->z, vi->x, qo_1a, qo_1c_left),
      qo_1c_right_rest = ksl_product_rest(qi->x, vi->z, qo_1b, qo_1c_right),
      qo_1c_lo = qo_1c_left_rest - qo_1c_right_rest, qo_1d = KSL_MUL(qi->w, vi->y),
      qo_1 = qo_1c + qo_1d, qo_1_right = qo_1 - qo_1c, qo_1_left = qo_1 - qo_1_right,
      qo_1_left_rest = qo_1c - qo_1_left,
      qo_1_right_rest = ksl_product_rest(qi->w, vi->y, qo_1d, qo_1_right),
      qo_1_lo1 = qo_1_left_rest + qo_1_right_rest, qo_1_lo = qo_1_lo1 + qo_1c_lo;
  const double qo_2a = KSL_MUL(qi->x, vi->y), qo_2b = KSL_MUL(qi->y, vi->x), qo_2c = qo_2a - qo_2b,
      qo_2c_right = qo_2a - qo_2c, qo_2c_left = qo_2c + qo_2c_right,
      qo_2c_left_rest = ksl_product_rest(qi->x, vi->y, qo_2a, qo_2c_left),
      qo_2c_right_rest = ksl_product_rest(qi->y, vi->x, qo_2b, qo_2c_right),
      qo_2c_lo = qo_2c_left_rest - qo_2c_right_rest, qo_2d = KSL_MUL(qi->w, vi->z),
      qo_2 = qo_2c + qo_2d, qo_2_right = qo_2 - qo_2c, qo_2_left = qo_2 - qo_2_right,
      qo_2_left_rest = qo_2c - qo_2_left,
      qo_2_right_rest = ksl_product_rest(qi->w, vi->z, qo_2d, qo_2_right),
      qo_2_lo1 = qo_2_left_rest + qo_2_right_rest, qo_2_lo = qo_2_lo1 + qo_2c_lo;
  const double qo_3a = KSL_MUL(qi->x, vi->x), qo_3b = KSL_MUL(qi->y, vi->y), qo_3c = qo_3a + qo_3b,
      qo_3c_right = qo_3c - qo_3a, qo_3c_left = qo_3c - qo_3c_right,
      qo_3c_left_rest = ksl_product_rest(qi->x, vi->x, qo_3a, qo_3c_left),
      qo_3c_right_rest = ksl_product_rest(qi->y, vi->y, qo_3b, qo_3c_right),
      qo_3c_lo = qo_3c_left_rest + qo_3c_right_rest, qo_3d = KSL_MUL(qi->z, vi->z),
      qo_3e = qo_3c + qo_3d, qo_3e_right = qo_3e - qo_3c, qo_3e_left = qo_3e - qo_3e_right,
      qo_3e_left_rest = qo_3c - qo_3e_left,
      qo_3e_right_rest = ksl_product_rest(qi->z, vi->z, qo_3d, qo_3e_right),
      qo_3e_lo1 = qo_3e_left_rest + qo_3e_right_rest, qo_3e_lo = qo_3e_lo1 + qo_3c_lo,
      qo_3 = -qo_3e, qo_3_lo = -qo_3e_lo;
  const double qo_0_rounded = qo_0 + qo_0_lo;
  const double qo_1_rounded = qo_1 + qo_1_lo;
  const double qo_2_rounded = qo_2 + qo_2_lo;
  const double qo_3_rounded = qo_3 + qo_3_lo;
  qo->x = qo_0_rounded;
  qo->y = qo_1_rounded;
  qo->z = qo_2_rounded;
  qo->w = qo_3_rounded;
}

/* qo = qi* (vi; 0).
   qi, qo: quaternion (x, y, z, w), the scalar last; vi: vector.
   12 mul, 44 add, 12 product rest.
   Error <= u |result| + 11 u^2 S, S the sum of the |terms| of the expanded formula; barring
     over- and underflow. */
static inline void ksl_quaternion_product_qconjv_accurate(const ksl_quaternion_t *qi,
    const ksl_vec3_t *vi, ksl_quaternion_t *qo) {
  const double qo_0a = KSL_MUL(qi->z, vi->y), qo_0b = KSL_MUL(qi->y, vi->z), qo_0c = qo_0a - qo_0b,
      qo_0c_right = qo_0a - qo_0c, qo_0c_left = qo_0c + qo_0c_right,
      qo_0c_left_rest = ksl_product_rest(qi->z, vi->y, qo_0a, qo_0c_left),
      qo_0c_right_rest = ksl_product_rest(qi->y, vi->z, qo_0b, qo_0c_right),
      qo_0c_lo = qo_0c_left_rest - qo_0c_right_rest, qo_0d = KSL_MUL(qi->w, vi->x),
      qo_0 = qo_0c + qo_0d, qo_0_right = qo_0 - qo_0c, qo_0_left = qo_0 - qo_0_right,
      qo_0_left_rest = qo_0c - qo_0_left,
      qo_0_right_rest = ksl_product_rest(qi->w, vi->x, qo_0d, qo_0_right),
      qo_0_lo1 = qo_0_left_rest + qo_0_right_rest, qo_0_lo = qo_0_lo1 + qo_0c_lo;
  const double qo_1a = KSL_MUL(qi->x, vi->z), qo_1b = KSL_MUL(qi->z, vi->x), qo_1c = qo_1a - qo_1b,
      qo_1c_right = qo_1a - qo_1c, qo_1c_left = qo_1c + qo_1c_right,
      qo_1c_left_rest = ksl_product_rest(qi->x, vi->z, qo_1a, qo_1c_left),
      qo_1c_right_rest = ksl_product_rest(qi->z, vi->x, qo_1b, qo_1c_right),
      qo_1c_lo = qo_1c_left_rest - qo_1c_right_rest, qo_1d = KSL_MUL(qi->w, vi->y),
      qo_1 = qo_1c + qo_1d, qo_1_right = qo_1 - qo_1c, qo_1_left = qo_1 - qo_1_right,
      qo_1_left_rest = qo_1c - qo_1_left,
      qo_1_right_rest = ksl_product_rest(qi->w, vi->y, qo_1d, qo_1_right),
      qo_1_lo1 = qo_1_left_rest + qo_1_right_rest, qo_1_lo = qo_1_lo1 + qo_1c_lo;
  const double qo_2a = KSL_MUL(qi->y, vi->x), qo_2b = KSL_MUL(qi->x, vi->y), qo_2c = qo_2a - qo_2b,
      qo_2c_right = qo_2a - qo_2c, qo_2c_left = qo_2c + qo_2c_right,
      qo_2c_left_rest = ksl_product_rest(qi->y, vi->x, qo_2a, qo_2c_left),
      qo_2c_right_rest = ksl_product_rest(qi->x, vi->y, qo_2b, qo_2c_right),
      qo_2c_lo = qo_2c_left_rest - qo_2c_right_rest, qo_2d = KSL_MUL(qi->w, vi->z),
      qo_2 = qo_2c + qo_2d, qo_2_right = qo_2 - qo_2c, qo_2_left = qo_2 - qo_2_right,
      qo_2_left_rest = qo_2c - qo_2_left,
      qo_2_right_rest = ksl_product_rest(qi->w, vi->z, qo_2d, qo_2_right),
      qo_2_lo1 = qo_2_left_rest + qo_2_right_rest, qo_2_lo = qo_2_lo1 + qo_2c_lo;
  const double qo_3a = KSL_MUL(qi->x, vi->x), qo_3b = KSL_MUL(qi->y, vi->y), qo_3c = qo_3a + qo_3b,
      qo_3c_right = qo_3c - qo_3a, qo_3c_left = qo_3c - qo_3c_right,
      qo_3c_left_rest = ksl_product_rest(qi->x, vi->x, qo_3a, qo_3c_left),
      qo_3c_right_rest = ksl_product_rest(qi->y, vi->y, qo_3b, qo_3c_right),
      qo_3c_lo = qo_3c_left_rest + qo_3c_right_rest, qo_3d = KSL_MUL(qi->z, vi->z),
      qo_3 = qo_3c + qo_3d, qo_3_right = qo_3 - qo_3c, qo_3_left = qo_3 - qo_3_right,
      qo_3_left_rest = qo_3c - qo_3_left,
      qo_3_right_rest = ksl_product_rest(qi->z, vi->z, qo_3d, qo_3_right),
      qo_3_lo1 = qo_3_left_rest + qo_3_right_rest, qo_3_lo = qo_3_lo1 + qo_3c_lo;
  const double qo_0_rounded = qo_0 + qo_0_lo;
  const double qo_1_rounded = qo_1 + qo_1_lo;
  const double qo_2_rounded = qo_2 + qo_2_lo;
  const double qo_3_rounded = qo_3 + qo_3_lo;
  qo->x = qo_0_rounded;
  qo->y = qo_1_rounded;
  qo->z = qo_2_rounded;
  qo->w = qo_3_rounded;
}

/* qo = (vi; 0) qi.
   vi: vector; qi, qo: quaternion (x, y, z, w), the scalar last.
   12 mul, 44 add, 12 product rest, 2 neg.
   Error <= u |result| + 11 u^2 S, S the sum of the |terms| of the expanded formula; barring
     over- and underflow. */
static inline void ksl_quaternion_product_vq_accurate(const ksl_vec3_t *vi,
    const ksl_quaternion_t *qi, ksl_quaternion_t *qo) {
  const double qo_0a = KSL_MUL(vi->x, qi->w), qo_0b = KSL_MUL(vi->y, qi->z),
      qo_0c = KSL_MUL(vi->z, qi->y), qo_0d = qo_0b - qo_0c, qo_0d_right = qo_0b - qo_0d,
      qo_0d_left = qo_0d + qo_0d_right,
      qo_0d_left_rest = ksl_product_rest(vi->y, qi->z, qo_0b, qo_0d_left),
      qo_0d_right_rest = ksl_product_rest(vi->z, qi->y, qo_0c, qo_0d_right),
      qo_0d_lo = qo_0d_left_rest - qo_0d_right_rest, qo_0 = qo_0a + qo_0d,
      qo_0_right = qo_0 - qo_0a, qo_0_left = qo_0 - qo_0_right,
      qo_0_left_rest = ksl_product_rest(vi->x, qi->w, qo_0a, qo_0_left),
      qo_0_right_rest = qo_0d - qo_0_right, qo_0_lo1 = qo_0_left_rest + qo_0_right_rest,
      qo_0_lo = qo_0_lo1 + qo_0d_lo;
  const double qo_1a = KSL_MUL(vi->z, qi->x), qo_1b = KSL_MUL(vi->x, qi->z), qo_1c = qo_1a - qo_1b,
      qo_1c_right = qo_1a - qo_1c, qo_1c_left = qo_1c + qo_1c_right,
      qo_1c_left_rest = ksl_product_rest(vi->z, qi->x, qo_1a, qo_1c_left),
      qo_1c_right_rest = ksl_product_rest(vi->x, qi->z, qo_1b, qo_1c_right),
      qo_1c_lo = qo_1c_left_rest - qo_1c_right_rest, qo_1d = KSL_MUL(vi->y, qi->w),
      qo_1 = qo_1c + qo_1d, qo_1_right = qo_1 - qo_1c, qo_1_left = qo_1 - qo_1_right,
      qo_1_left_rest = qo_1c - qo_1_left,
      qo_1_right_rest = ksl_product_rest(vi->y, qi->w, qo_1d, qo_1_right),
      qo_1_lo1 = qo_1_left_rest + qo_1_right_rest, qo_1_lo = qo_1_lo1 + qo_1c_lo;
  const double qo_2a = KSL_MUL(vi->x, qi->y), qo_2b = KSL_MUL(vi->y, qi->x), qo_2c = qo_2a - qo_2b,
      qo_2c_right = qo_2a - qo_2c, qo_2c_left = qo_2c + qo_2c_right,
      qo_2c_left_rest = ksl_product_rest(vi->x, qi->y, qo_2a, qo_2c_left),
      qo_2c_right_rest = ksl_product_rest(vi->y, qi->x, qo_2b, qo_2c_right),
      qo_2c_lo = qo_2c_left_rest - qo_2c_right_rest, qo_2d = KSL_MUL(vi->z, qi->w),
      qo_2 = qo_2c + qo_2d, qo_2_right = qo_2 - qo_2c, qo_2_left = qo_2 - qo_2_right,
      qo_2_left_rest = qo_2c - qo_2_left,
      qo_2_right_rest = ksl_product_rest(vi->z, qi->w, qo_2d, qo_2_right),
      qo_2_lo1 = qo_2_left_rest + qo_2_right_rest, qo_2_lo = qo_2_lo1 + qo_2c_lo;
  const double qo_3a = KSL_MUL(vi->x, qi->x), qo_3b = KSL_MUL(vi->y, qi->y), qo_3c = qo_3a + qo_3b,
      qo_3c_right = qo_3c - qo_3a, qo_3c_left = qo_3c - qo_3c_right,
      qo_3c_left_rest = ksl_product_rest(vi->x, qi->x, qo_3a, qo_3c_left),
      qo_3c_right_rest = ksl_product_rest(vi->y, qi->y, qo_3b, qo_3c_right),
      qo_3c_lo = qo_3c_left_rest + qo_3c_right_rest, qo_3d = KSL_MUL(vi->z, qi->z),
      qo_3e = qo_3c + qo_3d, qo_3e_right = qo_3e - qo_3c, qo_3e_left = qo_3e - qo_3e_right,
      qo_3e_left_rest = qo_3c - qo_3e_left,
      qo_3e_right_rest = ksl_product_rest(vi->z, qi->z, qo_3d, qo_3e_right),
      qo_3e_lo1 = qo_3e_left_rest + qo_3e_right_rest, qo_3e_lo = qo_3e_lo1 + qo_3c_lo,
      qo_3 = -qo_3e, qo_3_lo = -qo_3e_lo;
  const double qo_0_rounded = qo_0 + qo_0_lo;
  const double qo_1_rounded = qo_1 + qo_1_lo;
  const double qo_2_rounded = qo_2 + qo_2_lo;
  const double qo_3_rounded = qo_3 + qo_3_lo;
  qo->x = qo_0_rounded;
  qo->y = qo_1_rounded;
  qo->z = qo_2_rounded;
  qo->w = qo_3_rounded;
}

/* qo = (vi; 0) qi*.
   vi: vector; qi, qo: quaternion (x, y, z, w), the scalar last.
   12 mul, 44 add, 12 product rest.
   Error <= u |result| + 11 u^2 S, S the sum of the |terms| of the expanded formula; barring
     over- and underflow. */
static inline void ksl_quaternion_product_vqconj_accurate(const ksl_vec3_t *vi,
    const ksl_quaternion_t *qi, ksl_quaternion_t *qo) {
  const double qo_0a = KSL_MUL(vi->x, qi->w), qo_0b = KSL_MUL(vi->z, qi->y),
      qo_0c = KSL_MUL(vi->y, qi->z), qo_0d = qo_0b - qo_0c, qo_0d_right = qo_0b - qo_0d,
      qo_0d_left = qo_0d + qo_0d_right,
      qo_0d_left_rest = ksl_product_rest(vi->z, qi->y, qo_0b, qo_0d_left),
      qo_0d_right_rest = ksl_product_rest(vi->y, qi->z, qo_0c, qo_0d_right),
      qo_0d_lo = qo_0d_left_rest - qo_0d_right_rest, qo_0 = qo_0a + qo_0d,
      qo_0_right = qo_0 - qo_0a, qo_0_left = qo_0 - qo_0_right,
      qo_0_left_rest = ksl_product_rest(vi->x, qi->w, qo_0a, qo_0_left),
      qo_0_right_rest = qo_0d - qo_0_right, qo_0_lo1 = qo_0_left_rest + qo_0_right_rest,
      qo_0_lo = qo_0_lo1 + qo_0d_lo;
  const double qo_1a = KSL_MUL(vi->x, qi->z), qo_1b = KSL_MUL(vi->z, qi->x), qo_1c = qo_1a - qo_1b,
      qo_1c_right = qo_1a - qo_1c, qo_1c_left = qo_1c + qo_1c_right,
      qo_1c_left_rest = ksl_product_rest(vi->x, qi->z, qo_1a, qo_1c_left),
      qo_1c_right_rest = ksl_product_rest(vi->z, qi->x, qo_1b, qo_1c_right),
      qo_1c_lo = qo_1c_left_rest - qo_1c_right_rest, qo_1d = KSL_MUL(vi->y, qi->w),
      qo_1 = qo_1c + qo_1d, qo_1_right = qo_1 - qo_1c, qo_1_left = qo_1 - qo_1_right,
      qo_1_left_rest = qo_1c - qo_1_left,
      qo_1_right_rest = ksl_product_rest(vi->y, qi->w, qo_1d, qo_1_right),
      qo_1_lo1 = qo_1_left_rest + qo_1_right_rest, qo_1_lo = qo_1_lo1 + qo_1c_lo;
  const double qo_2a = KSL_MUL(vi->y, qi->x), qo_2b = KSL_MUL(vi->x, qi->y), qo_2c = qo_2a - qo_2b,
      qo_2c_right = qo_2a - qo_2c, qo_2c_left = qo_2c + qo_2c_right,
      qo_2c_left_rest = ksl_product_rest(vi->y, qi->x, qo_2a, qo_2c_left),
      qo_2c_right_rest = ksl_product_rest(vi->x, qi->y, qo_2b, qo_2c_right),
      qo_2c_lo = qo_2c_left_rest - qo_2c_right_rest, qo_2d = KSL_MUL(vi->z, qi->w),
      qo_2 = qo_2c + qo_2d, qo_2_right = qo_2 - qo_2c, qo_2_left = qo_2 - qo_2_right,
      qo_2_left_rest = qo_2c - qo_2_left,
      qo_2_right_rest = ksl_product_rest(vi->z, qi->w, qo_2d, qo_2_right),
      qo_2_lo1 = qo_2_left_rest + qo_2_right_rest, qo_2_lo = qo_2_lo1 + qo_2c_lo;
  const double qo_3a = KSL_MUL(vi->x, qi->x), qo_3b = KSL_MUL(vi->y, qi->y), qo_3c = qo_3a + qo_3b,
      qo_3c_right = qo_3c - qo_3a, qo_3c_left = qo_3c - qo_3c_right,
      qo_3c_left_rest = ksl_product_rest(vi->x, qi->x, qo_3a, qo_3c_left),
      qo_3c_right_rest = ksl_product_rest(vi->y, qi->y, qo_3b, qo_3c_right),
      qo_3c_lo = qo_3c_left_rest + qo_3c_right_rest, qo_3d = KSL_MUL(vi->z, qi->z),
      qo_3 = qo_3c + qo_3d, qo_3_right = qo_3 - qo_3c, qo_3_left = qo_3 - qo_3_right,
      qo_3_left_rest = qo_3c - qo_3_left,
      qo_3_right_rest = ksl_product_rest(vi->z, qi->z, qo_3d, qo_3_right),
      qo_3_lo1 = qo_3_left_rest + qo_3_right_rest, qo_3_lo = qo_3_lo1 + qo_3c_lo;
  const double qo_0_rounded = qo_0 + qo_0_lo;
  const double qo_1_rounded = qo_1 + qo_1_lo;
  const double qo_2_rounded = qo_2 + qo_2_lo;
  const double qo_3_rounded = qo_3 + qo_3_lo;
  qo->x = qo_0_rounded;
  qo->y = qo_1_rounded;
  qo->z = qo_2_rounded;
  qo->w = qo_3_rounded;
}

/* q1i·q2i.
   q1i, q2i: quaternion (x, y, z, w), the scalar last.
   4 mul, 17 add, 4 product rest.
   Error <= u |result| + 17 u^2 S, S the sum of the |terms| of the expanded formula; barring
     over- and underflow. */
static inline double ksl_dot_qq_accurate(const ksl_quaternion_t *q1i, const ksl_quaternion_t *q2i) {
  const double dot_a = KSL_MUL(q1i->x, q2i->x), dot_b = KSL_MUL(q1i->y, q2i->y),
      dot_c = dot_a + dot_b, dot_c_right = dot_c - dot_a, dot_c_left = dot_c - dot_c_right,
      dot_c_left_rest = ksl_product_rest(q1i->x, q2i->x, dot_a, dot_c_left),
      dot_c_right_rest = ksl_product_rest(q1i->y, q2i->y, dot_b, dot_c_right),
      dot_c_lo = dot_c_left_rest + dot_c_right_rest, dot_d = KSL_MUL(q1i->z, q2i->z),
      dot_e = dot_c + dot_d, dot_e_right = dot_e - dot_c, dot_e_left = dot_e - dot_e_right,
      dot_e_left_rest = dot_c - dot_e_left,
      dot_e_right_rest = ksl_product_rest(q1i->z, q2i->z, dot_d, dot_e_right),
      dot_e_lo1 = dot_e_left_rest + dot_e_right_rest, dot_e_lo = dot_e_lo1 + dot_c_lo,
      dot_f = KSL_MUL(q1i->w, q2i->w), dot = dot_e + dot_f, dot_right = dot - dot_e,
      dot_left = dot - dot_right, dot_left_rest = dot_e - dot_left,
      dot_right_rest = ksl_product_rest(q1i->w, q2i->w, dot_f, dot_right),
      dot_lo1 = dot_left_rest + dot_right_rest, dot_lo = dot_lo1 + dot_e_lo;
  const double dot_rounded = dot + dot_lo;
  return dot_rounded;
}

/* qi = qi + qi (dpi; 0) / 2: rotated by the small rotation vector dpi in the rotated frame, to
     first order; not normalized.
   dpi: vector; qi: quaternion (x, y, z, w), the scalar last.
   15 mul, 72 add, 12 product rest.
   Error <= u |result| + 15 u^2 S, S the sum of the |terms| of the expanded formula; barring
     over- and underflow. */
static inline void ksl_add_dpiToq_accurate(const ksl_vec3_t *dpi, ksl_quaternion_t *qi) {
  const double qi_0_new_a = KSL_MUL(0.5, dpi->x), qi_0_new_b = KSL_MUL(qi_0_new_a, qi->w),
      qi_0_new_c = KSL_MUL(0.5, dpi->z), qi_0_new_d = KSL_MUL(qi_0_new_c, qi->y),
      qi_0_new_e = KSL_MUL(0.5, dpi->y), qi_0_new_f = KSL_MUL(qi_0_new_e, qi->z),
      qi_0_new_g = qi_0_new_d - qi_0_new_f, qi_0_new_g_right = qi_0_new_d - qi_0_new_g,
      qi_0_new_g_left = qi_0_new_g + qi_0_new_g_right,
      qi_0_new_g_left_rest = ksl_product_rest(qi_0_new_c, qi->y, qi_0_new_d, qi_0_new_g_left),
      qi_0_new_g_right_rest = ksl_product_rest(qi_0_new_e, qi->z, qi_0_new_f, qi_0_new_g_right),
      qi_0_new_g_lo = qi_0_new_g_left_rest - qi_0_new_g_right_rest,
      qi_0_new_h = qi_0_new_b + qi_0_new_g, qi_0_new_h_right = qi_0_new_h - qi_0_new_b,
      qi_0_new_h_left = qi_0_new_h - qi_0_new_h_right,
      qi_0_new_h_left_rest = ksl_product_rest(qi_0_new_a, qi->w, qi_0_new_b, qi_0_new_h_left),
      qi_0_new_h_right_rest = qi_0_new_g - qi_0_new_h_right,
      qi_0_new_h_lo1 = qi_0_new_h_left_rest + qi_0_new_h_right_rest,
      qi_0_new_h_lo = qi_0_new_h_lo1 + qi_0_new_g_lo, qi_0_new = qi_0_new_h + qi->x,
      qi_0_new_right = qi_0_new - qi_0_new_h, qi_0_new_left = qi_0_new - qi_0_new_right,
      qi_0_new_left_rest = qi_0_new_h - qi_0_new_left, qi_0_new_right_rest = qi->x - qi_0_new_right,
      qi_0_new_lo1 = qi_0_new_left_rest + qi_0_new_right_rest,
      qi_0_new_lo = qi_0_new_lo1 + qi_0_new_h_lo;
  const double qi_1_new_a = KSL_MUL(qi_0_new_a, qi->z), qi_1_new_b = KSL_MUL(qi_0_new_c, qi->x),
      qi_1_new_c = qi_1_new_a - qi_1_new_b, qi_1_new_c_right = qi_1_new_a - qi_1_new_c,
      qi_1_new_c_left = qi_1_new_c + qi_1_new_c_right,
      qi_1_new_c_left_rest = ksl_product_rest(qi_0_new_a, qi->z, qi_1_new_a, qi_1_new_c_left),
      qi_1_new_c_right_rest = ksl_product_rest(qi_0_new_c, qi->x, qi_1_new_b, qi_1_new_c_right),
      qi_1_new_c_lo = qi_1_new_c_left_rest - qi_1_new_c_right_rest,
      qi_1_new_d = KSL_MUL(qi_0_new_e, qi->w), qi_1_new_e = qi_1_new_c + qi_1_new_d,
      qi_1_new_e_right = qi_1_new_e - qi_1_new_c, qi_1_new_e_left = qi_1_new_e - qi_1_new_e_right,
      qi_1_new_e_left_rest = qi_1_new_c - qi_1_new_e_left,
      qi_1_new_e_right_rest = ksl_product_rest(qi_0_new_e, qi->w, qi_1_new_d, qi_1_new_e_right),
      qi_1_new_e_lo1 = qi_1_new_e_left_rest + qi_1_new_e_right_rest,
      qi_1_new_e_lo = qi_1_new_e_lo1 + qi_1_new_c_lo, qi_1_new = qi_1_new_e + qi->y,
      qi_1_new_right = qi_1_new - qi_1_new_e, qi_1_new_left = qi_1_new - qi_1_new_right,
      qi_1_new_left_rest = qi_1_new_e - qi_1_new_left, qi_1_new_right_rest = qi->y - qi_1_new_right,
      qi_1_new_lo1 = qi_1_new_left_rest + qi_1_new_right_rest,
      qi_1_new_lo = qi_1_new_lo1 + qi_1_new_e_lo;
  const double qi_2_new_a = KSL_MUL(qi_0_new_e, qi->x), qi_2_new_b = KSL_MUL(qi_0_new_a, qi->y),
      qi_2_new_c = qi_2_new_a - qi_2_new_b, qi_2_new_c_right = qi_2_new_a - qi_2_new_c,
      qi_2_new_c_left = qi_2_new_c + qi_2_new_c_right,
      qi_2_new_c_left_rest = ksl_product_rest(qi_0_new_e, qi->x, qi_2_new_a, qi_2_new_c_left),
      qi_2_new_c_right_rest = ksl_product_rest(qi_0_new_a, qi->y, qi_2_new_b, qi_2_new_c_right),
      qi_2_new_c_lo = qi_2_new_c_left_rest - qi_2_new_c_right_rest,
      qi_2_new_d = KSL_MUL(qi_0_new_c, qi->w), qi_2_new_e = qi_2_new_c + qi_2_new_d,
      qi_2_new_e_right = qi_2_new_e - qi_2_new_c, qi_2_new_e_left = qi_2_new_e - qi_2_new_e_right,
      qi_2_new_e_left_rest = qi_2_new_c - qi_2_new_e_left,
      qi_2_new_e_right_rest = ksl_product_rest(qi_0_new_c, qi->w, qi_2_new_d, qi_2_new_e_right),
      qi_2_new_e_lo1 = qi_2_new_e_left_rest + qi_2_new_e_right_rest,
      qi_2_new_e_lo = qi_2_new_e_lo1 + qi_2_new_c_lo, qi_2_new = qi_2_new_e + qi->z,
      qi_2_new_right = qi_2_new - qi_2_new_e, qi_2_new_left = qi_2_new - qi_2_new_right,
      qi_2_new_left_rest = qi_2_new_e - qi_2_new_left, qi_2_new_right_rest = qi->z - qi_2_new_right,
      qi_2_new_lo1 = qi_2_new_left_rest + qi_2_new_right_rest,
      qi_2_new_lo = qi_2_new_lo1 + qi_2_new_e_lo;
  const double qi_3_new_a = KSL_MUL(qi_0_new_a, qi->x), qi_3_new_b = KSL_MUL(qi_0_new_e, qi->y),
      qi_3_new_c = qi_3_new_a + qi_3_new_b, qi_3_new_c_right = qi_3_new_c - qi_3_new_a,
      qi_3_new_c_left = qi_3_new_c - qi_3_new_c_right,
      qi_3_new_c_left_rest = ksl_product_rest(qi_0_new_a, qi->x, qi_3_new_a, qi_3_new_c_left),
      qi_3_new_c_right_rest = ksl_product_rest(qi_0_new_e, qi->y, qi_3_new_b, qi_3_new_c_right),
      qi_3_new_c_lo = qi_3_new_c_left_rest + qi_3_new_c_right_rest,
      qi_3_new_d = KSL_MUL(qi_0_new_c, qi->z), qi_3_new_e = qi_3_new_c + qi_3_new_d,
      qi_3_new_e_right = qi_3_new_e - qi_3_new_c, qi_3_new_e_left = qi_3_new_e - qi_3_new_e_right,
      qi_3_new_e_left_rest = qi_3_new_c - qi_3_new_e_left,
      qi_3_new_e_right_rest = ksl_product_rest(qi_0_new_c, qi->z, qi_3_new_d, qi_3_new_e_right),
      qi_3_new_e_lo1 = qi_3_new_e_left_rest + qi_3_new_e_right_rest,
      qi_3_new_e_lo = qi_3_new_e_lo1 + qi_3_new_c_lo, qi_3_new = qi->w - qi_3_new_e,
      qi_3_new_right = qi->w - qi_3_new, qi_3_new_left = qi_3_new + qi_3_new_right,
      qi_3_new_left_rest = qi->w - qi_3_new_left, qi_3_new_right_rest = qi_3_new_e - qi_3_new_right,
      qi_3_new_lo1 = qi_3_new_left_rest - qi_3_new_right_rest,
      qi_3_new_lo = qi_3_new_lo1 - qi_3_new_e_lo;
  const double qi_0_new_rounded = qi_0_new + qi_0_new_lo;
  const double qi_1_new_rounded = qi_1_new + qi_1_new_lo;
  const double qi_2_new_rounded = qi_2_new + qi_2_new_lo;
  const double qi_3_new_rounded = qi_3_new + qi_3_new_lo;
  qi->x = qi_0_new_rounded;
  qi->y = qi_1_new_rounded;
  qi->z = qi_2_new_rounded;
  qi->w = qi_3_new_rounded;
}

/* qi = qi - qi (dpi; 0) / 2, the opposite of add_dpiToq to first order.
   dpi: vector; qi: quaternion (x, y, z, w), the scalar last.
   15 mul, 72 add, 12 product rest.
   Error <= u |result| + 15 u^2 S, S the sum of the |terms| of the expanded formula; barring
     over- and underflow. */
static inline void ksl_subtract_dpiFromq_accurate(const ksl_vec3_t *dpi, ksl_quaternion_t *qi) {
  const double qi_0_new_a = KSL_MUL(0.5, dpi->y), qi_0_new_b = KSL_MUL(qi_0_new_a, qi->z),
      qi_0_new_c = KSL_MUL(0.5, dpi->z), qi_0_new_d = KSL_MUL(qi_0_new_c, qi->y),
      qi_0_new_e = qi_0_new_b - qi_0_new_d, qi_0_new_e_right = qi_0_new_b - qi_0_new_e,
      qi_0_new_e_left = qi_0_new_e + qi_0_new_e_right,
      qi_0_new_e_left_rest = ksl_product_rest(qi_0_new_a, qi->z, qi_0_new_b, qi_0_new_e_left),
      qi_0_new_e_right_rest = ksl_product_rest(qi_0_new_c, qi->y, qi_0_new_d, qi_0_new_e_right),
      qi_0_new_e_lo = qi_0_new_e_left_rest - qi_0_new_e_right_rest,
      qi_0_new_f = KSL_MUL(0.5, dpi->x), qi_0_new_g = KSL_MUL(qi_0_new_f, qi->w),
      qi_0_new_h = qi_0_new_e - qi_0_new_g, qi_0_new_h_right = qi_0_new_e - qi_0_new_h,
      qi_0_new_h_left = qi_0_new_h + qi_0_new_h_right,
      qi_0_new_h_left_rest = qi_0_new_e - qi_0_new_h_left,
      qi_0_new_h_right_rest = ksl_product_rest(qi_0_new_f, qi->w, qi_0_new_g, qi_0_new_h_right),
      qi_0_new_h_lo1 = qi_0_new_h_left_rest - qi_0_new_h_right_rest,
      qi_0_new_h_lo = qi_0_new_h_lo1 + qi_0_new_e_lo, qi_0_new = qi_0_new_h + qi->x,
      qi_0_new_right = qi_0_new - qi_0_new_h, qi_0_new_left = qi_0_new - qi_0_new_right,
      qi_0_new_left_rest = qi_0_new_h - qi_0_new_left, qi_0_new_right_rest = qi->x - qi_0_new_right,
      qi_0_new_lo1 = qi_0_new_left_rest + qi_0_new_right_rest,
      qi_0_new_lo = qi_0_new_lo1 + qi_0_new_h_lo;
  const double qi_1_new_a = KSL_MUL(qi_0_new_c, qi->x), qi_1_new_b = KSL_MUL(qi_0_new_f, qi->z),
      qi_1_new_c = qi_1_new_a - qi_1_new_b, qi_1_new_c_right = qi_1_new_a - qi_1_new_c,
      qi_1_new_c_left = qi_1_new_c + qi_1_new_c_right,
      qi_1_new_c_left_rest = ksl_product_rest(qi_0_new_c, qi->x, qi_1_new_a, qi_1_new_c_left),
      qi_1_new_c_right_rest = ksl_product_rest(qi_0_new_f, qi->z, qi_1_new_b, qi_1_new_c_right),
      qi_1_new_c_lo = qi_1_new_c_left_rest - qi_1_new_c_right_rest,
      qi_1_new_d = KSL_MUL(qi_0_new_a, qi->w), qi_1_new_e = qi_1_new_c - qi_1_new_d,
      qi_1_new_e_right = qi_1_new_c - qi_1_new_e, qi_1_new_e_left = qi_1_new_e + qi_1_new_e_right,
      qi_1_new_e_left_rest = qi_1_new_c - qi_1_new_e_left,
      qi_1_new_e_right_rest = ksl_product_rest(qi_0_new_a, qi->w, qi_1_new_d, qi_1_new_e_right),
      qi_1_new_e_lo1 = qi_1_new_e_left_rest - qi_1_new_e_right_rest,
      qi_1_new_e_lo = qi_1_new_e_lo1 + qi_1_new_c_lo, qi_1_new = qi_1_new_e + qi->y,
      qi_1_new_right = qi_1_new - qi_1_new_e, qi_1_new_left = qi_1_new - qi_1_new_right,
      qi_1_new_left_rest = qi_1_new_e - qi_1_new_left, qi_1_new_right_rest = qi->y - qi_1_new_right,
      qi_1_new_lo1 = qi_1_new_left_rest + qi_1_new_right_rest,
      qi_1_new_lo = qi_1_new_lo1 + qi_1_new_e_lo;
  const double qi_2_new_a = KSL_MUL(qi_0_new_f, qi->y), qi_2_new_b = KSL_MUL(qi_0_new_a, qi->x),
      qi_2_new_c = qi_2_new_a - qi_2_new_b, qi_2_new_c_right = qi_2_new_a - qi_2_new_c,
      qi_2_new_c_left = qi_2_new_c + qi_2_new_c_right,
      qi_2_new_c_left_rest = ksl_product_rest(qi_0_new_f, qi->y, qi_2_new_a, qi_2_new_c_left),
      qi_2_new_c_right_rest = ksl_product_rest(qi_0_new_a, qi->x, qi_2_new_b, qi_2_new_c_right),
      qi_2_new_c_lo = qi_2_new_c_left_rest - qi_2_new_c_right_rest,
      qi_2_new_d = KSL_MUL(qi_0_new_c, qi->w), qi_2_new_e = qi_2_new_c - qi_2_new_d,
      qi_2_new_e_right = qi_2_new_c - qi_2_new_e, qi_2_new_e_left = qi_2_new_e + qi_2_new_e_right,
      qi_2_new_e_left_rest = qi_2_new_c - qi_2_new_e_left,
      qi_2_new_e_right_rest = ksl_product_rest(qi_0_new_c, qi->w, qi_2_new_d, qi_2_new_e_right),
      qi_2_new_e_lo1 = qi_2_new_e_left_rest - qi_2_new_e_right_rest,
      qi_2_new_e_lo = qi_2_new_e_lo1 + qi_2_new_c_lo, qi_2_new = qi_2_new_e + qi->z,
      qi_2_new_right = qi_2_new - qi_2_new_e, qi_2_new_left = qi_2_new - qi_2_new_right,
      qi_2_new_left_rest = qi_2_new_e - qi_2_new_left, qi_2_new_right_rest = qi->z - qi_2_new_right,
      qi_2_new_lo1 = qi_2_new_left_rest + qi_2_new_right_rest,
      qi_2_new_lo = qi_2_new_lo1 + qi_2_new_e_lo;
  const double qi_3_new_a = KSL_MUL(qi_0_new_f, qi->x), qi_3_new_b = KSL_MUL(qi_0_new_a, qi->y),
      qi_3_new_c = qi_3_new_a + qi_3_new_b, qi_3_new_c_right = qi_3_new_c - qi_3_new_a,
      qi_3_new_c_left = qi_3_new_c - qi_3_new_c_right,
      qi_3_new_c_left_rest = ksl_product_rest(qi_0_new_f, qi->x, qi_3_new_a, qi_3_new_c_left),
      qi_3_new_c_right_rest = ksl_product_rest(qi_0_new_a, qi->y, qi_3_new_b, qi_3_new_c_right),
      qi_3_new_c_lo = qi_3_new_c_left_rest + qi_3_new_c_right_rest,
      qi_3_new_d = KSL_MUL(qi_0_new_c, qi->z), qi_3_new_e = qi_3_new_c + qi_3_new_d,
      qi_3_new_e_right = qi_3_new_e - qi_3_new_c, qi_3_new_e_left = qi_3_new_e - qi_3_new_e_right,
      qi_3_new_e_left_rest = qi_3_new_c - qi_3_new_e_left,
      qi_3_new_e_right_rest = ksl_product_rest(qi_0_new_c, qi->z, qi_3_new_d, qi_3_new_e_right),
      qi_3_new_e_lo1 = qi_3_new_e_left_rest + qi_3_new_e_right_rest,
      qi_3_new_e_lo = qi_3_new_e_lo1 + qi_3_new_c_lo, qi_3_new = qi_3_new_e + qi->w,
      qi_3_new_right = qi_3_new - qi_3_new_e, qi_3_new_left = qi_3_new - qi_3_new_right,
      qi_3_new_left_rest = qi_3_new_e - qi_3_new_left, qi_3_new_right_rest = qi->w - qi_3_new_right,
      qi_3_new_lo1 = qi_3_new_left_rest + qi_3_new_right_rest,
      qi_3_new_lo = qi_3_new_lo1 + qi_3_new_e_lo;
  const double qi_0_new_rounded = qi_0_new + qi_0_new_lo;
  const double qi_1_new_rounded = qi_1_new + qi_1_new_lo;
  const double qi_2_new_rounded = qi_2_new + qi_2_new_lo;
  const double qi_3_new_rounded = qi_3_new + qi_3_new_lo;
  qi->x = qi_0_new_rounded;
  qi->y = qi_1_new_rounded;
  qi->z = qi_2_new_rounded;
  qi->w = qi_3_new_rounded;
}

/* dqo = (w; 0) qi / 2 + (1 - qi·qi) qi: the rate of qi for the angular velocity w in the
     reference frame, rad/s, and a term that draws its norm to 1.
   w: vector; qi, dqo: quaternion (x, y, z, w), the scalar last.
   27 mul, 101 add, 20 product rest.
   Error <= u |result| + (v: 35, w: 32) u^2 S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_omega_to_dquaternion_accurate(const ksl_vec3_t *w,
    const ksl_quaternion_t *qi, ksl_quaternion_t *dqo) {
  const double dqo_0a = KSL_MUL(0.5, w->x), dqo_0b = KSL_MUL(dqo_0a, qi->w),
      dqo_0c = KSL_MUL(0.5, w->y), dqo_0d = KSL_MUL(dqo_0c, qi->z), dqo_0e = KSL_MUL(0.5, w->z),
      dqo_0f = KSL_MUL(dqo_0e, qi->y), dqo_0g = dqo_0d - dqo_0f, dqo_0g_right = dqo_0d - dqo_0g,
      dqo_0g_left = dqo_0g + dqo_0g_right,
      dqo_0g_left_rest = ksl_product_rest(dqo_0c, qi->z, dqo_0d, dqo_0g_left),
      dqo_0g_right_rest = ksl_product_rest(dqo_0e, qi->y, dqo_0f, dqo_0g_right),
      dqo_0g_lo = dqo_0g_left_rest - dqo_0g_right_rest, dqo_0h = dqo_0b + dqo_0g,
      dqo_0h_right = dqo_0h - dqo_0b, dqo_0h_left = dqo_0h - dqo_0h_right,
      dqo_0h_left_rest = ksl_product_rest(dqo_0a, qi->w, dqo_0b, dqo_0h_left),
      dqo_0h_right_rest = dqo_0g - dqo_0h_right, dqo_0h_lo1 = dqo_0h_left_rest + dqo_0h_right_rest,
      dqo_0h_lo = dqo_0h_lo1 + dqo_0g_lo, dqo_0i = KSL_MUL(qi->x, qi->x), dqo_0j = 1.0 - dqo_0i,
      dqo_0j_right = 1.0 - dqo_0j, dqo_0j_left = dqo_0j + dqo_0j_right,
      dqo_0j_left_rest = 1.0 - dqo_0j_left,
      dqo_0j_right_rest = ksl_product_rest(qi->x, qi->x, dqo_0i, dqo_0j_right),
      dqo_0j_lo = dqo_0j_left_rest - dqo_0j_right_rest, dqo_0k = KSL_MUL(qi->y, qi->y),
      dqo_0l = dqo_0j - dqo_0k, dqo_0l_right = dqo_0j - dqo_0l, dqo_0l_left = dqo_0l + dqo_0l_right,
      dqo_0l_left_rest = dqo_0j - dqo_0l_left,
      dqo_0l_right_rest = ksl_product_rest(qi->y, qi->y, dqo_0k, dqo_0l_right),
      dqo_0l_lo1 = dqo_0l_left_rest - dqo_0l_right_rest, dqo_0l_lo = dqo_0l_lo1 + dqo_0j_lo,
      dqo_0m = KSL_MUL(qi->z, qi->z), dqo_0n = dqo_0l - dqo_0m, dqo_0n_right = dqo_0l - dqo_0n,
      dqo_0n_left = dqo_0n + dqo_0n_right, dqo_0n_left_rest = dqo_0l - dqo_0n_left,
      dqo_0n_right_rest = ksl_product_rest(qi->z, qi->z, dqo_0m, dqo_0n_right),
      dqo_0n_lo1 = dqo_0n_left_rest - dqo_0n_right_rest, dqo_0n_lo = dqo_0n_lo1 + dqo_0l_lo,
      dqo_0o = KSL_MUL(qi->w, qi->w), dqo_0p = dqo_0n - dqo_0o, dqo_0p_right = dqo_0n - dqo_0p,
      dqo_0p_left = dqo_0p + dqo_0p_right, dqo_0p_left_rest = dqo_0n - dqo_0p_left,
      dqo_0p_right_rest = ksl_product_rest(qi->w, qi->w, dqo_0o, dqo_0p_right),
      dqo_0p_lo1 = dqo_0p_left_rest - dqo_0p_right_rest, dqo_0p_lo = dqo_0p_lo1 + dqo_0n_lo,
      dqo_0q_of_dqo_0p = dqo_0p + dqo_0p_lo, dqo_0q_of_dqo_0p_right = dqo_0q_of_dqo_0p - dqo_0p,
      dqo_0q_of_dqo_0p_left = dqo_0q_of_dqo_0p - dqo_0q_of_dqo_0p_right,
      dqo_0q_of_dqo_0p_left_rest = dqo_0p - dqo_0q_of_dqo_0p_left,
      dqo_0q_of_dqo_0p_right_rest = dqo_0p_lo - dqo_0q_of_dqo_0p_right,
      dqo_0q_of_dqo_0p_lo = dqo_0q_of_dqo_0p_left_rest + dqo_0q_of_dqo_0p_right_rest,
      dqo_0q = KSL_MUL(qi->x, dqo_0q_of_dqo_0p),
      dqo_0q_cross2 = KSL_MUL(qi->x, dqo_0q_of_dqo_0p_lo), dqo_0 = dqo_0h + dqo_0q,
      dqo_0_right = dqo_0 - dqo_0h, dqo_0_left = dqo_0 - dqo_0_right,
      dqo_0_left_rest = dqo_0h - dqo_0_left,
      dqo_0_right_rest = ksl_product_rest(qi->x, dqo_0q_of_dqo_0p, dqo_0q, dqo_0_right),
      dqo_0_lo1 = dqo_0_left_rest + dqo_0_right_rest, dqo_0_lo2 = dqo_0_lo1 + dqo_0q_cross2,
      dqo_0_lo = dqo_0_lo2 + dqo_0h_lo;
  const double dqo_1a = KSL_MUL(dqo_0e, qi->x), dqo_1b = KSL_MUL(dqo_0a, qi->z),
      dqo_1c = dqo_1a - dqo_1b, dqo_1c_right = dqo_1a - dqo_1c, dqo_1c_left = dqo_1c + dqo_1c_right,
      dqo_1c_left_rest = ksl_product_rest(dqo_0e, qi->x, dqo_1a, dqo_1c_left),
      dqo_1c_right_rest = ksl_product_rest(dqo_0a, qi->z, dqo_1b, dqo_1c_right),
      dqo_1c_lo = dqo_1c_left_rest - dqo_1c_right_rest, dqo_1d = KSL_MUL(dqo_0c, qi->w),
      dqo_1e = dqo_1c + dqo_1d, dqo_1e_right = dqo_1e - dqo_1c, dqo_1e_left = dqo_1e - dqo_1e_right,
      dqo_1e_left_rest = dqo_1c - dqo_1e_left,
      dqo_1e_right_rest = ksl_product_rest(dqo_0c, qi->w, dqo_1d, dqo_1e_right),
      dqo_1e_lo1 = dqo_1e_left_rest + dqo_1e_right_rest, dqo_1e_lo = dqo_1e_lo1 + dqo_1c_lo,
      dqo_1f = KSL_MUL(qi->y, dqo_0q_of_dqo_0p),
      dqo_1f_cross2 = KSL_MUL(qi->y, dqo_0q_of_dqo_0p_lo), dqo_1 = dqo_1e + dqo_1f,
      dqo_1_right = dqo_1 - dqo_1e, dqo_1_left = dqo_1 - dqo_1_right,
      dqo_1_left_rest = dqo_1e - dqo_1_left,
      dqo_1_right_rest = ksl_product_rest(qi->y, dqo_0q_of_dqo_0p, dqo_1f, dqo_1_right),
      dqo_1_lo1 = dqo_1_left_rest + dqo_1_right_rest, dqo_1_lo2 = dqo_1_lo1 + dqo_1f_cross2,
      dqo_1_lo = dqo_1_lo2 + dqo_1e_lo;
  const double dqo_2a = KSL_MUL(dqo_0a, qi->y), dqo_2b = KSL_MUL(dqo_0c, qi->x),
      dqo_2c = dqo_2a - dqo_2b, dqo_2c_right = dqo_2a - dqo_2c, dqo_2c_left = dqo_2c + dqo_2c_right,
      dqo_2c_left_rest = ksl_product_rest(dqo_0a, qi->y, dqo_2a, dqo_2c_left),
      dqo_2c_right_rest = ksl_product_rest(dqo_0c, qi->x, dqo_2b, dqo_2c_right),
      dqo_2c_lo = dqo_2c_left_rest - dqo_2c_right_rest, dqo_2d = KSL_MUL(dqo_0e, qi->w),
      dqo_2e = dqo_2c + dqo_2d, dqo_2e_right = dqo_2e - dqo_2c, dqo_2e_left = dqo_2e - dqo_2e_right,
      dqo_2e_left_rest = dqo_2c - dqo_2e_left,
      dqo_2e_right_rest = ksl_product_rest(dqo_0e, qi->w, dqo_2d, dqo_2e_right),
      dqo_2e_lo1 = dqo_2e_left_rest + dqo_2e_right_rest, dqo_2e_lo = dqo_2e_lo1 + dqo_2c_lo,
      dqo_2f = KSL_MUL(qi->z, dqo_0q_of_dqo_0p),
      dqo_2f_cross2 = KSL_MUL(qi->z, dqo_0q_of_dqo_0p_lo), dqo_2 = dqo_2e + dqo_2f,
      dqo_2_right = dqo_2 - dqo_2e, dqo_2_left = dqo_2 - dqo_2_right,
      dqo_2_left_rest = dqo_2e - dqo_2_left,
      dqo_2_right_rest = ksl_product_rest(qi->z, dqo_0q_of_dqo_0p, dqo_2f, dqo_2_right),
      dqo_2_lo1 = dqo_2_left_rest + dqo_2_right_rest, dqo_2_lo2 = dqo_2_lo1 + dqo_2f_cross2,
      dqo_2_lo = dqo_2_lo2 + dqo_2e_lo;
  const double dqo_3a = KSL_MUL(qi->w, dqo_0q_of_dqo_0p),
      dqo_3a_cross2 = KSL_MUL(qi->w, dqo_0q_of_dqo_0p_lo), dqo_3b = KSL_MUL(dqo_0a, qi->x),
      dqo_3c = KSL_MUL(dqo_0c, qi->y), dqo_3d = dqo_3b + dqo_3c, dqo_3d_right = dqo_3d - dqo_3b,
      dqo_3d_left = dqo_3d - dqo_3d_right,
      dqo_3d_left_rest = ksl_product_rest(dqo_0a, qi->x, dqo_3b, dqo_3d_left),
      dqo_3d_right_rest = ksl_product_rest(dqo_0c, qi->y, dqo_3c, dqo_3d_right),
      dqo_3d_lo = dqo_3d_left_rest + dqo_3d_right_rest, dqo_3e = KSL_MUL(dqo_0e, qi->z),
      dqo_3f = dqo_3d + dqo_3e, dqo_3f_right = dqo_3f - dqo_3d, dqo_3f_left = dqo_3f - dqo_3f_right,
      dqo_3f_left_rest = dqo_3d - dqo_3f_left,
      dqo_3f_right_rest = ksl_product_rest(dqo_0e, qi->z, dqo_3e, dqo_3f_right),
      dqo_3f_lo1 = dqo_3f_left_rest + dqo_3f_right_rest, dqo_3f_lo = dqo_3f_lo1 + dqo_3d_lo,
      dqo_3 = dqo_3a - dqo_3f, dqo_3_right = dqo_3a - dqo_3, dqo_3_left = dqo_3 + dqo_3_right,
      dqo_3_left_rest = ksl_product_rest(qi->w, dqo_0q_of_dqo_0p, dqo_3a, dqo_3_left),
      dqo_3_right_rest = dqo_3f - dqo_3_right, dqo_3_lo1 = dqo_3_left_rest - dqo_3_right_rest,
      dqo_3_lo2 = dqo_3_lo1 - dqo_3f_lo, dqo_3_lo = dqo_3_lo2 + dqo_3a_cross2;
  const double dqo_0_rounded = dqo_0 + dqo_0_lo;
  const double dqo_1_rounded = dqo_1 + dqo_1_lo;
  const double dqo_2_rounded = dqo_2 + dqo_2_lo;
  const double dqo_3_rounded = dqo_3 + dqo_3_lo;
  dqo->x = dqo_0_rounded;
  dqo->y = dqo_1_rounded;
  dqo->z = dqo_2_rounded;
  dqo->w = dqo_3_rounded;
}

/* R = I + 2 (w v~ + v~^2) / q·q, for any nonzero q whose square neither over- nor underflows.
   q: quaternion (x, y, z, w), the scalar last; R: rotation or other 3×3 matrix.
   41 mul, 116 add, 10 product error, 24 product rest, 2 div, 9 equal, 9 select.
   Error <= R: 1 u of its largest component for 2^-450 < |q| < 2^511, in single precision 2^-45 <
     |q| < 2^63; searched, not proved.  Each component is within 1 ulp as long as its condition
     is below 1e13; in single precision it is the nearest number, except near ties, as long as
     that is below 1e5; searched, not proved. */
static inline void ksl_mat3x3_from_quaternion_accurate(const ksl_quaternion_t *q, ksl_mat3x3_t *R) {
  const double squares_0 = KSL_MUL(q->w, q->w);
  const double squares_1 = KSL_MUL(q->x, q->x);
  const double squares_2 = KSL_MUL(q->y, q->y);
  const double squares_3 = KSL_MUL(q->z, q->z);
  const double pairs_0 = squares_0 + squares_1, pairs_0_right = pairs_0 - squares_0,
      pairs_0_left = pairs_0 - pairs_0_right,
      pairs_0_left_rest = ksl_product_rest(q->w, q->w, squares_0, pairs_0_left),
      pairs_0_right_rest = ksl_product_rest(q->x, q->x, squares_1, pairs_0_right),
      pairs_0_lo = pairs_0_left_rest + pairs_0_right_rest;
  const double pairs_1 = squares_2 + squares_3, pairs_1_right = pairs_1 - squares_2,
      pairs_1_left = pairs_1 - pairs_1_right,
      pairs_1_left_rest = ksl_product_rest(q->y, q->y, squares_2, pairs_1_left),
      pairs_1_right_rest = ksl_product_rest(q->z, q->z, squares_3, pairs_1_right),
      pairs_1_lo = pairs_1_left_rest + pairs_1_right_rest;
  const double pairs_2 = squares_0 + squares_2, pairs_2_right = pairs_2 - squares_0,
      pairs_2_left = pairs_2 - pairs_2_right,
      pairs_2_left_rest = ksl_product_rest(q->w, q->w, squares_0, pairs_2_left),
      pairs_2_right_rest = ksl_product_rest(q->y, q->y, squares_2, pairs_2_right),
      pairs_2_lo = pairs_2_left_rest + pairs_2_right_rest;
  const double pairs_3 = squares_1 + squares_3, pairs_3_right = pairs_3 - squares_1,
      pairs_3_left = pairs_3 - pairs_3_right,
      pairs_3_left_rest = ksl_product_rest(q->x, q->x, squares_1, pairs_3_left),
      pairs_3_right_rest = ksl_product_rest(q->z, q->z, squares_3, pairs_3_right),
      pairs_3_lo = pairs_3_left_rest + pairs_3_right_rest;
  const double pairs_4 = squares_0 + squares_3, pairs_4_right = pairs_4 - squares_0,
      pairs_4_left = pairs_4 - pairs_4_right,
      pairs_4_left_rest = ksl_product_rest(q->w, q->w, squares_0, pairs_4_left),
      pairs_4_right_rest = ksl_product_rest(q->z, q->z, squares_3, pairs_4_right),
      pairs_4_lo = pairs_4_left_rest + pairs_4_right_rest;
  const double pairs_5 = squares_1 + squares_2, pairs_5_right = pairs_5 - squares_1,
      pairs_5_left = pairs_5 - pairs_5_right,
      pairs_5_left_rest = ksl_product_rest(q->x, q->x, squares_1, pairs_5_left),
      pairs_5_right_rest = ksl_product_rest(q->y, q->y, squares_2, pairs_5_right),
      pairs_5_lo = pairs_5_left_rest + pairs_5_right_rest;
  const double square = pairs_0 + pairs_1, square_right = square - pairs_0,
      square_left = square - square_right, square_left_rest = pairs_0 - square_left,
      square_right_rest = pairs_1 - square_right, square_lo1 = square_left_rest + square_right_rest,
      square_lo2 = square_lo1 + pairs_1_lo, square_lo = square_lo2 + pairs_0_lo;
  const double factor_of_square = square + square_lo,
      factor_of_square_right = factor_of_square - square,
      factor_of_square_left = factor_of_square - factor_of_square_right,
      factor_of_square_left_rest = square - factor_of_square_left,
      factor_of_square_right_rest = square_lo - factor_of_square_right,
      factor_of_square_lo = factor_of_square_left_rest + factor_of_square_right_rest,
      factor = 1.0 / factor_of_square, factor_product = KSL_MUL(factor, factor_of_square),
      factor_product_error = ksl_product_error(factor, factor_of_square, factor_product),
      factor_rest = 1.0 - factor_product, factor_exact = factor_rest - factor_product_error,
      factor_cross = KSL_MUL(factor, factor_of_square_lo),
      factor_residual = factor_exact - factor_cross, factor_lo = factor_residual / factor_of_square;
  const double d0 = pairs_0 - pairs_1, d0_right = pairs_0 - d0, d0_left = d0 + d0_right,
      d0_left_rest = pairs_0 - d0_left, d0_right_rest = pairs_1 - d0_right,
      d0_lo1 = d0_left_rest - d0_right_rest, d0_lo2 = d0_lo1 - pairs_1_lo,
      d0_lo = d0_lo2 + pairs_0_lo;
  const double d1 = pairs_2 - pairs_3, d1_right = pairs_2 - d1, d1_left = d1 + d1_right,
      d1_left_rest = pairs_2 - d1_left, d1_right_rest = pairs_3 - d1_right,
      d1_lo1 = d1_left_rest - d1_right_rest, d1_lo2 = d1_lo1 - pairs_3_lo,
      d1_lo = d1_lo2 + pairs_2_lo;
  const double d2 = pairs_4 - pairs_5, d2_right = pairs_4 - d2, d2_left = d2 + d2_right,
      d2_left_rest = pairs_4 - d2_left, d2_right_rest = pairs_5 - d2_right,
      d2_lo1 = d2_left_rest - d2_right_rest, d2_lo2 = d2_lo1 - pairs_5_lo,
      d2_lo = d2_lo2 + pairs_4_lo;
  const double twice = KSL_MUL(2.0, factor), twice_cross2 = KSL_MUL(2.0, factor_lo);
  const double m_0a = KSL_MUL(q->x, q->y), m_0b = KSL_MUL(q->z, q->w), m_0 = m_0a - m_0b,
      m_0_right = m_0a - m_0, m_0_left = m_0 + m_0_right,
      m_0_left_rest = ksl_product_rest(q->x, q->y, m_0a, m_0_left),
      m_0_right_rest = ksl_product_rest(q->z, q->w, m_0b, m_0_right),
      m_0_lo = m_0_left_rest - m_0_right_rest;
  const double m_1a = KSL_MUL(q->x, q->z), m_1b = KSL_MUL(q->y, q->w), m_1 = m_1a + m_1b,
      m_1_right = m_1 - m_1a, m_1_left = m_1 - m_1_right,
      m_1_left_rest = ksl_product_rest(q->x, q->z, m_1a, m_1_left),
      m_1_right_rest = ksl_product_rest(q->y, q->w, m_1b, m_1_right),
      m_1_lo = m_1_left_rest + m_1_right_rest;
  const double m_2a = KSL_MUL(q->y, q->z), m_2b = KSL_MUL(q->x, q->w), m_2 = m_2a - m_2b,
      m_2_right = m_2a - m_2, m_2_left = m_2 + m_2_right,
      m_2_left_rest = ksl_product_rest(q->y, q->z, m_2a, m_2_left),
      m_2_right_rest = ksl_product_rest(q->x, q->w, m_2b, m_2_right),
      m_2_lo = m_2_left_rest - m_2_right_rest;
  const double m_3 = m_0a + m_0b, m_3_right = m_3 - m_0a, m_3_left = m_3 - m_3_right,
      m_3_left_rest = ksl_product_rest(q->x, q->y, m_0a, m_3_left),
      m_3_right_rest = ksl_product_rest(q->z, q->w, m_0b, m_3_right),
      m_3_lo = m_3_left_rest + m_3_right_rest;
  const double m_4 = m_1a - m_1b, m_4_right = m_1a - m_4, m_4_left = m_4 + m_4_right,
      m_4_left_rest = ksl_product_rest(q->x, q->z, m_1a, m_4_left),
      m_4_right_rest = ksl_product_rest(q->y, q->w, m_1b, m_4_right),
      m_4_lo = m_4_left_rest - m_4_right_rest;
  const double m_5 = m_2b + m_2a, m_5_right = m_5 - m_2b, m_5_left = m_5 - m_5_right,
      m_5_left_rest = ksl_product_rest(q->x, q->w, m_2b, m_5_left),
      m_5_right_rest = ksl_product_rest(q->y, q->z, m_2a, m_5_right),
      m_5_lo = m_5_left_rest + m_5_right_rest;
  const double R_00 = KSL_MUL(factor, d0), R_00_cross1 = KSL_MUL(factor_lo, d0),
      R_00_cross2 = KSL_MUL(factor, d0_lo), R_00_cross = R_00_cross1 + R_00_cross2;
  const double R_01 = KSL_MUL(twice, m_0), R_01_cross1 = KSL_MUL(twice_cross2, m_0),
      R_01_cross2 = KSL_MUL(twice, m_0_lo), R_01_cross = R_01_cross1 + R_01_cross2;
  const double R_02 = KSL_MUL(twice, m_1), R_02_cross1 = KSL_MUL(twice_cross2, m_1),
      R_02_cross2 = KSL_MUL(twice, m_1_lo), R_02_cross = R_02_cross1 + R_02_cross2;
  const double R_10 = KSL_MUL(twice, m_3), R_10_cross1 = KSL_MUL(twice_cross2, m_3),
      R_10_cross2 = KSL_MUL(twice, m_3_lo), R_10_cross = R_10_cross1 + R_10_cross2;
  const double R_11 = KSL_MUL(factor, d1), R_11_cross1 = KSL_MUL(factor_lo, d1),
      R_11_cross2 = KSL_MUL(factor, d1_lo), R_11_cross = R_11_cross1 + R_11_cross2;
  const double R_12 = KSL_MUL(twice, m_2), R_12_cross1 = KSL_MUL(twice_cross2, m_2),
      R_12_cross2 = KSL_MUL(twice, m_2_lo), R_12_cross = R_12_cross1 + R_12_cross2;
  const double R_20 = KSL_MUL(twice, m_4), R_20_cross1 = KSL_MUL(twice_cross2, m_4),
      R_20_cross2 = KSL_MUL(twice, m_4_lo), R_20_cross = R_20_cross1 + R_20_cross2;
  const double R_21 = KSL_MUL(twice, m_5), R_21_cross1 = KSL_MUL(twice_cross2, m_5),
      R_21_cross2 = KSL_MUL(twice, m_5_lo), R_21_cross = R_21_cross1 + R_21_cross2;
  const double R_22 = KSL_MUL(factor, d2), R_22_cross1 = KSL_MUL(factor_lo, d2),
      R_22_cross2 = KSL_MUL(factor, d2_lo), R_22_cross = R_22_cross1 + R_22_cross2;
  const double R_00_error = ksl_product_error(factor, d0, R_00), R_00_lo = R_00_error + R_00_cross,
      R_00_rounded = R_00 + R_00_lo,
      R_00_final = R_00_rounded == R_00_rounded ? R_00_rounded : R_00;
  const double R_01_error = ksl_product_error(twice, m_0, R_01), R_01_lo = R_01_error + R_01_cross,
      R_01_rounded = R_01 + R_01_lo,
      R_01_final = R_01_rounded == R_01_rounded ? R_01_rounded : R_01;
  const double R_02_error = ksl_product_error(twice, m_1, R_02), R_02_lo = R_02_error + R_02_cross,
      R_02_rounded = R_02 + R_02_lo,
      R_02_final = R_02_rounded == R_02_rounded ? R_02_rounded : R_02;
  const double R_10_error = ksl_product_error(twice, m_3, R_10), R_10_lo = R_10_error + R_10_cross,
      R_10_rounded = R_10 + R_10_lo,
      R_10_final = R_10_rounded == R_10_rounded ? R_10_rounded : R_10;
  const double R_11_error = ksl_product_error(factor, d1, R_11), R_11_lo = R_11_error + R_11_cross,
      R_11_rounded = R_11 + R_11_lo,
      R_11_final = R_11_rounded == R_11_rounded ? R_11_rounded : R_11;
  const double R_12_error = ksl_product_error(twice, m_2, R_12), R_12_lo = R_12_error + R_12_cross,
      R_12_rounded = R_12 + R_12_lo,
      R_12_final = R_12_rounded == R_12_rounded ? R_12_rounded : R_12;
  const double R_20_error = ksl_product_error(twice, m_4, R_20), R_20_lo = R_20_error + R_20_cross,
      R_20_rounded = R_20 + R_20_lo,
      R_20_final = R_20_rounded == R_20_rounded ? R_20_rounded : R_20;
  const double R_21_error = ksl_product_error(twice, m_5, R_21), R_21_lo = R_21_error + R_21_cross,
      R_21_rounded = R_21 + R_21_lo,
      R_21_final = R_21_rounded == R_21_rounded ? R_21_rounded : R_21;
  const double R_22_error = ksl_product_error(factor, d2, R_22), R_22_lo = R_22_error + R_22_cross,
      R_22_rounded = R_22 + R_22_lo,
      R_22_final = R_22_rounded == R_22_rounded ? R_22_rounded : R_22;
  R->m00 = R_00_final;
  R->m01 = R_01_final;
  R->m02 = R_02_final;
  R->m10 = R_10_final;
  R->m11 = R_11_final;
  R->m12 = R_12_final;
  R->m20 = R_20_final;
  R->m21 = R_21_final;
  R->m22 = R_22_final;
}

/* qo with R(qo) = R and w >= 0; if R is not quite a rotation, its defect carries over to qo.
   R: rotation or other 3×3 matrix; qo: quaternion (x, y, z, w), the scalar last.
   21 mul, 182 add, 5 product error, 4 product rest, 9 div, 1 sqrt, 9 neg, 4 less, 5 equal, 37
     select.
   Error <= qo: 1 u of its largest component for R a rotation; searched, not proved.  Each
     component is within 1 ulp as long as its condition is below 1e13; in single precision it is
     the nearest number, except near ties, as long as that is below 1e5; searched, not proved. */
static inline void ksl_quaternion_from_mat3x3_accurate(const ksl_mat3x3_t *R,
    ksl_quaternion_t *qo) {
  const double p_0 = R->m21 - R->m12, p_0_right = R->m21 - p_0, p_0_left = p_0 + p_0_right,
      p_0_left_rest = R->m21 - p_0_left, p_0_right_rest = R->m12 - p_0_right,
      p_0_lo = p_0_left_rest - p_0_right_rest;
  const double p_1 = R->m02 - R->m20, p_1_right = R->m02 - p_1, p_1_left = p_1 + p_1_right,
      p_1_left_rest = R->m02 - p_1_left, p_1_right_rest = R->m20 - p_1_right,
      p_1_lo = p_1_left_rest - p_1_right_rest;
  const double p_2 = R->m10 - R->m01, p_2_right = R->m10 - p_2, p_2_left = p_2 + p_2_right,
      p_2_left_rest = R->m10 - p_2_left, p_2_right_rest = R->m01 - p_2_right,
      p_2_lo = p_2_left_rest - p_2_right_rest;
  const double s_0 = R->m12 + R->m21, s_0_right = s_0 - R->m12, s_0_left = s_0 - s_0_right,
      s_0_left_rest = R->m12 - s_0_left, s_0_right_rest = R->m21 - s_0_right,
      s_0_lo = s_0_left_rest + s_0_right_rest;
  const double s_1 = R->m02 + R->m20, s_1_right = s_1 - R->m02, s_1_left = s_1 - s_1_right,
      s_1_left_rest = R->m02 - s_1_left, s_1_right_rest = R->m20 - s_1_right,
      s_1_lo = s_1_left_rest + s_1_right_rest;
  const double s_2 = R->m01 + R->m10, s_2_right = s_2 - R->m01, s_2_left = s_2 - s_2_right,
      s_2_left_rest = R->m01 - s_2_left, s_2_right_rest = R->m10 - s_2_right,
      s_2_lo = s_2_left_rest + s_2_right_rest;
  const double first_0 = R->m00 + 1.0, first_0_right = first_0 - R->m00,
      first_0_left = first_0 - first_0_right, first_0_left_rest = R->m00 - first_0_left,
      first_0_right_rest = 1.0 - first_0_right, first_0_lo = first_0_left_rest + first_0_right_rest;
  const double first_1 = 1.0 - R->m00, first_1_right = 1.0 - first_1,
      first_1_left = first_1 + first_1_right, first_1_left_rest = 1.0 - first_1_left,
      first_1_right_rest = R->m00 - first_1_right,
      first_1_lo = first_1_left_rest - first_1_right_rest;
  const double others_0 = R->m11 + R->m22, others_0_right = others_0 - R->m11,
      others_0_left = others_0 - others_0_right, others_0_left_rest = R->m11 - others_0_left,
      others_0_right_rest = R->m22 - others_0_right,
      others_0_lo = others_0_left_rest + others_0_right_rest;
  const double others_1 = R->m11 - R->m22, others_1_right = R->m11 - others_1,
      others_1_left = others_1 + others_1_right, others_1_left_rest = R->m11 - others_1_left,
      others_1_right_rest = R->m22 - others_1_right,
      others_1_lo = others_1_left_rest - others_1_right_rest;
  const double d_0 = first_0 + others_0, d_0_right = d_0 - first_0, d_0_left = d_0 - d_0_right,
      d_0_left_rest = first_0 - d_0_left, d_0_right_rest = others_0 - d_0_right,
      d_0_lo1 = d_0_left_rest + d_0_right_rest, d_0_lo2 = d_0_lo1 + others_0_lo,
      d_0_lo = d_0_lo2 + first_0_lo;
  const double d_1 = first_0 - others_0, d_1_right = first_0 - d_1, d_1_left = d_1 + d_1_right,
      d_1_left_rest = first_0 - d_1_left, d_1_right_rest = others_0 - d_1_right,
      d_1_lo1 = d_1_left_rest - d_1_right_rest, d_1_lo2 = d_1_lo1 - others_0_lo,
      d_1_lo = d_1_lo2 + first_0_lo;
  const double d_2 = first_1 + others_1, d_2_right = d_2 - first_1, d_2_left = d_2 - d_2_right,
      d_2_left_rest = first_1 - d_2_left, d_2_right_rest = others_1 - d_2_right,
      d_2_lo1 = d_2_left_rest + d_2_right_rest, d_2_lo2 = d_2_lo1 + others_1_lo,
      d_2_lo = d_2_lo2 + first_1_lo;
  const double d_3 = first_1 - others_1, d_3_right = first_1 - d_3, d_3_left = d_3 + d_3_right,
      d_3_left_rest = first_1 - d_3_left, d_3_right_rest = others_1 - d_3_right,
      d_3_lo1 = d_3_left_rest - d_3_right_rest, d_3_lo2 = d_3_lo1 - others_1_lo,
      d_3_lo = d_3_lo2 + first_1_lo;
  const double low_0 = R->m11 < R->m00 ? d_1 : s_2, low_0_lo = R->m11 < R->m00 ? d_1_lo : s_2_lo;
  const double low_1 = R->m11 < R->m00 ? s_2 : d_2, low_1_lo = R->m11 < R->m00 ? s_2_lo : d_2_lo;
  const double low_2 = R->m11 < R->m00 ? s_1 : s_0, low_2_lo = R->m11 < R->m00 ? s_1_lo : s_0_lo;
  const double low_3 = R->m11 < R->m00 ? p_0 : p_1, low_3_lo = R->m11 < R->m00 ? p_0_lo : p_1_lo;
  const double high_0a = -R->m11, high_0 = R->m00 < high_0a ? s_1 : p_0,
      high_0_lo = R->m00 < high_0a ? s_1_lo : p_0_lo;
  const double high_1 = R->m00 < high_0a ? s_0 : p_1,
      high_1_lo = R->m00 < high_0a ? s_0_lo : p_1_lo;
  const double high_2 = R->m00 < high_0a ? d_3 : p_2,
      high_2_lo = R->m00 < high_0a ? d_3_lo : p_2_lo;
  const double high_3 = R->m00 < high_0a ? p_2 : d_0,
      high_3_lo = R->m00 < high_0a ? p_2_lo : d_0_lo;
  const double column_0 = R->m22 < 0.0 ? low_0 : high_0,
      column_0_lo = R->m22 < 0.0 ? low_0_lo : high_0_lo;
  const double column_1 = R->m22 < 0.0 ? low_1 : high_1,
      column_1_lo = R->m22 < 0.0 ? low_1_lo : high_1_lo;
  const double column_2 = R->m22 < 0.0 ? low_2 : high_2,
      column_2_lo = R->m22 < 0.0 ? low_2_lo : high_2_lo;
  const double column_3 = R->m22 < 0.0 ? low_3 : high_3,
      column_3_lo = R->m22 < 0.0 ? low_3_lo : high_3_lo;
  const double upper_0a = -column_0, upper_0a_lo = -column_0_lo,
      upper_0b_of_column_3 = column_3 + column_3_lo,
      upper_0b_of_column_3_right = upper_0b_of_column_3 - column_3,
      upper_0b_of_column_3_left = upper_0b_of_column_3 - upper_0b_of_column_3_right,
      upper_0b_of_column_3_left_rest = column_3 - upper_0b_of_column_3_left,
      upper_0b_of_column_3_right_rest = column_3_lo - upper_0b_of_column_3_right,
      upper_0b_of_column_3_lo = upper_0b_of_column_3_left_rest + upper_0b_of_column_3_right_rest,
      upper_0 = upper_0b_of_column_3 < 0.0 ? upper_0a : column_0,
      upper_0_lo = upper_0b_of_column_3 < 0.0 ? upper_0a_lo : column_0_lo;
  const double upper_1a = -column_1, upper_1a_lo = -column_1_lo,
      upper_1 = upper_0b_of_column_3 < 0.0 ? upper_1a : column_1,
      upper_1_lo = upper_0b_of_column_3 < 0.0 ? upper_1a_lo : column_1_lo;
  const double upper_2a = -column_2, upper_2a_lo = -column_2_lo,
      upper_2 = upper_0b_of_column_3 < 0.0 ? upper_2a : column_2,
      upper_2_lo = upper_0b_of_column_3 < 0.0 ? upper_2a_lo : column_2_lo;
  const double upper_3a = -upper_0b_of_column_3, upper_3a_lo = -upper_0b_of_column_3_lo,
      upper_3 = upper_0b_of_column_3 < 0.0 ? upper_3a : upper_0b_of_column_3,
      upper_3_lo = upper_0b_of_column_3 < 0.0 ? upper_3a_lo : upper_0b_of_column_3_lo;
  const double length_a = KSL_MUL(upper_0, upper_0), length_a_cross1 = KSL_MUL(upper_0_lo, upper_0),
      length_a_cross2 = KSL_MUL(upper_0, upper_0_lo),
      length_a_cross = length_a_cross1 + length_a_cross2, length_b = KSL_MUL(upper_1, upper_1),
      length_b_cross1 = KSL_MUL(upper_1_lo, upper_1),
      length_b_cross2 = KSL_MUL(upper_1, upper_1_lo),
      length_b_cross = length_b_cross1 + length_b_cross2, length_c = length_a + length_b,
      length_c_right = length_c - length_a, length_c_left = length_c - length_c_right,
      length_c_left_rest = ksl_product_rest(upper_0, upper_0, length_a, length_c_left),
      length_c_right_rest = ksl_product_rest(upper_1, upper_1, length_b, length_c_right),
      length_c_cross = length_a_cross + length_b_cross,
      length_c_lo1 = length_c_left_rest + length_c_right_rest,
      length_c_lo = length_c_lo1 + length_c_cross, length_d = KSL_MUL(upper_2, upper_2),
      length_d_cross1 = KSL_MUL(upper_2_lo, upper_2),
      length_d_cross2 = KSL_MUL(upper_2, upper_2_lo),
      length_d_cross = length_d_cross1 + length_d_cross2, length_e = length_c + length_d,
      length_e_right = length_e - length_c, length_e_left = length_e - length_e_right,
      length_e_left_rest = length_c - length_e_left,
      length_e_right_rest = ksl_product_rest(upper_2, upper_2, length_d, length_e_right),
      length_e_lo1 = length_e_left_rest + length_e_right_rest,
      length_e_lo2 = length_e_lo1 + length_d_cross, length_e_lo = length_e_lo2 + length_c_lo,
      length_f = KSL_MUL(upper_3, upper_3), length_f_cross1 = KSL_MUL(upper_3_lo, upper_3),
      length_f_cross2 = KSL_MUL(upper_3, upper_3_lo),
      length_f_cross = length_f_cross1 + length_f_cross2, length_g = length_e + length_f,
      length_g_right = length_g - length_e, length_g_left = length_g - length_g_right,
      length_g_left_rest = length_e - length_g_left,
      length_g_right_rest = ksl_product_rest(upper_3, upper_3, length_f, length_g_right),
      length_g_lo1 = length_g_left_rest + length_g_right_rest,
      length_g_lo2 = length_g_lo1 + length_f_cross, length_g_lo = length_g_lo2 + length_e_lo,
      length_of_length_g = length_g + length_g_lo,
      length_of_length_g_right = length_of_length_g - length_g,
      length_of_length_g_left = length_of_length_g - length_of_length_g_right,
      length_of_length_g_left_rest = length_g - length_of_length_g_left,
      length_of_length_g_right_rest = length_g_lo - length_of_length_g_right,
      length_of_length_g_lo = length_of_length_g_left_rest + length_of_length_g_right_rest,
      length = sqrt(length_of_length_g), length_product = KSL_MUL(length, length),
      length_product_error = ksl_product_error(length, length, length_product),
      length_rest = length_of_length_g - length_product,
      length_exact = length_rest - length_product_error,
      length_residual = length_exact + length_of_length_g_lo, length_twice = length + length,
      length_divisor = length == 0.0 ? 1.0 : length_twice,
      length_lo = length_residual / length_divisor;
  const double qo_0_of_upper_0 = upper_0 + upper_0_lo,
      qo_0_of_upper_0_right = qo_0_of_upper_0 - upper_0,
      qo_0_of_upper_0_left = qo_0_of_upper_0 - qo_0_of_upper_0_right,
      qo_0_of_upper_0_left_rest = upper_0 - qo_0_of_upper_0_left,
      qo_0_of_upper_0_right_rest = upper_0_lo - qo_0_of_upper_0_right,
      qo_0_of_upper_0_lo = qo_0_of_upper_0_left_rest + qo_0_of_upper_0_right_rest,
      qo_0_of_length = length + length_lo, qo_0_of_length_right = qo_0_of_length - length,
      qo_0_of_length_left = qo_0_of_length - qo_0_of_length_right,
      qo_0_of_length_left_rest = length - qo_0_of_length_left,
      qo_0_of_length_right_rest = length_lo - qo_0_of_length_right,
      qo_0_of_length_lo = qo_0_of_length_left_rest + qo_0_of_length_right_rest,
      qo_0 = qo_0_of_upper_0 / qo_0_of_length, qo_0_product = KSL_MUL(qo_0, qo_0_of_length),
      qo_0_product_error = ksl_product_error(qo_0, qo_0_of_length, qo_0_product),
      qo_0_rest = qo_0_of_upper_0 - qo_0_product, qo_0_exact = qo_0_rest - qo_0_product_error,
      qo_0_numerator = qo_0_exact + qo_0_of_upper_0_lo,
      qo_0_cross = KSL_MUL(qo_0, qo_0_of_length_lo), qo_0_residual = qo_0_numerator - qo_0_cross,
      qo_0_lo = qo_0_residual / qo_0_of_length;
  const double qo_1_of_upper_1 = upper_1 + upper_1_lo,
      qo_1_of_upper_1_right = qo_1_of_upper_1 - upper_1,
      qo_1_of_upper_1_left = qo_1_of_upper_1 - qo_1_of_upper_1_right,
      qo_1_of_upper_1_left_rest = upper_1 - qo_1_of_upper_1_left,
      qo_1_of_upper_1_right_rest = upper_1_lo - qo_1_of_upper_1_right,
      qo_1_of_upper_1_lo = qo_1_of_upper_1_left_rest + qo_1_of_upper_1_right_rest,
      qo_1 = qo_1_of_upper_1 / qo_0_of_length, qo_1_product = KSL_MUL(qo_1, qo_0_of_length),
      qo_1_product_error = ksl_product_error(qo_1, qo_0_of_length, qo_1_product),
      qo_1_rest = qo_1_of_upper_1 - qo_1_product, qo_1_exact = qo_1_rest - qo_1_product_error,
      qo_1_numerator = qo_1_exact + qo_1_of_upper_1_lo,
      qo_1_cross = KSL_MUL(qo_1, qo_0_of_length_lo), qo_1_residual = qo_1_numerator - qo_1_cross,
      qo_1_lo = qo_1_residual / qo_0_of_length;
  const double qo_2_of_upper_2 = upper_2 + upper_2_lo,
      qo_2_of_upper_2_right = qo_2_of_upper_2 - upper_2,
      qo_2_of_upper_2_left = qo_2_of_upper_2 - qo_2_of_upper_2_right,
      qo_2_of_upper_2_left_rest = upper_2 - qo_2_of_upper_2_left,
      qo_2_of_upper_2_right_rest = upper_2_lo - qo_2_of_upper_2_right,
      qo_2_of_upper_2_lo = qo_2_of_upper_2_left_rest + qo_2_of_upper_2_right_rest,
      qo_2 = qo_2_of_upper_2 / qo_0_of_length, qo_2_product = KSL_MUL(qo_2, qo_0_of_length),
      qo_2_product_error = ksl_product_error(qo_2, qo_0_of_length, qo_2_product),
      qo_2_rest = qo_2_of_upper_2 - qo_2_product, qo_2_exact = qo_2_rest - qo_2_product_error,
      qo_2_numerator = qo_2_exact + qo_2_of_upper_2_lo,
      qo_2_cross = KSL_MUL(qo_2, qo_0_of_length_lo), qo_2_residual = qo_2_numerator - qo_2_cross,
      qo_2_lo = qo_2_residual / qo_0_of_length;
  const double qo_3_of_upper_3 = upper_3 + upper_3_lo,
      qo_3_of_upper_3_right = qo_3_of_upper_3 - upper_3,
      qo_3_of_upper_3_left = qo_3_of_upper_3 - qo_3_of_upper_3_right,
      qo_3_of_upper_3_left_rest = upper_3 - qo_3_of_upper_3_left,
      qo_3_of_upper_3_right_rest = upper_3_lo - qo_3_of_upper_3_right,
      qo_3_of_upper_3_lo = qo_3_of_upper_3_left_rest + qo_3_of_upper_3_right_rest,
      qo_3 = qo_3_of_upper_3 / qo_0_of_length, qo_3_product = KSL_MUL(qo_3, qo_0_of_length),
      qo_3_product_error = ksl_product_error(qo_3, qo_0_of_length, qo_3_product),
      qo_3_rest = qo_3_of_upper_3 - qo_3_product, qo_3_exact = qo_3_rest - qo_3_product_error,
      qo_3_numerator = qo_3_exact + qo_3_of_upper_3_lo,
      qo_3_cross = KSL_MUL(qo_3, qo_0_of_length_lo), qo_3_residual = qo_3_numerator - qo_3_cross,
      qo_3_lo = qo_3_residual / qo_0_of_length;
  const double qo_0_rounded = qo_0 + qo_0_lo,
      qo_0_final = qo_0_rounded == qo_0_rounded ? qo_0_rounded : qo_0;
  const double qo_1_rounded = qo_1 + qo_1_lo,
      qo_1_final = qo_1_rounded == qo_1_rounded ? qo_1_rounded : qo_1;
  const double qo_2_rounded = qo_2 + qo_2_lo,
      qo_2_final = qo_2_rounded == qo_2_rounded ? qo_2_rounded : qo_2;
  const double qo_3_rounded = qo_3 + qo_3_lo,
      qo_3_final = qo_3_rounded == qo_3_rounded ? qo_3_rounded : qo_3;
  qo->x = qo_0_final;
  qo->y = qo_1_final;
  qo->z = qo_2_final;
  qo->w = qo_3_final;
}

/* qo = (axis sin angle/2; cos angle/2); axis of length 1: with another |qo| is not 1, and its
     rotation is by another angle.
   axis: vector; angle: number; qo: quaternion (x, y, z, w), the scalar last.
   90 mul, 134 add, 14 product error, 1 div, 3 abs, 1 less, 4 equal, 5 select.
   Error <= qo: 1 u of its largest component for |axis| = 1; searched, not proved.  Each
     component is within 1 ulp as long as its condition is below 1e13; in single precision it is
     the nearest number, except near ties, as long as that is below 1e5; searched, not proved. */
static inline void ksl_quaternion_from_axis_angle_accurate(const ksl_vec3_t *axis,
    const double angle, ksl_quaternion_t *qo) {
  const double half = KSL_MUL(0.5, angle);
  double qo_3; const double sine = ksl_sincos(half, &qo_3);
  double qo_3_own_error; const double sine_own_error = ksl_sincos_error(half, sine, qo_3,
      &qo_3_own_error);
  const double qo_0 = KSL_MUL(axis->x, sine), qo_0_cross2 = KSL_MUL(axis->x, sine_own_error);
  const double qo_1 = KSL_MUL(axis->y, sine), qo_1_cross2 = KSL_MUL(axis->y, sine_own_error);
  const double qo_2 = KSL_MUL(axis->z, sine), qo_2_cross2 = KSL_MUL(axis->z, sine_own_error);
  const double qo_0_error = ksl_product_error(axis->x, sine, qo_0),
      qo_0_lo = qo_0_error + qo_0_cross2, qo_0_rounded = qo_0 + qo_0_lo,
      qo_0_final = qo_0_rounded == qo_0_rounded ? qo_0_rounded : qo_0;
  const double qo_1_error = ksl_product_error(axis->y, sine, qo_1),
      qo_1_lo = qo_1_error + qo_1_cross2, qo_1_rounded = qo_1 + qo_1_lo,
      qo_1_final = qo_1_rounded == qo_1_rounded ? qo_1_rounded : qo_1;
  const double qo_2_error = ksl_product_error(axis->z, sine, qo_2),
      qo_2_lo = qo_2_error + qo_2_cross2, qo_2_rounded = qo_2 + qo_2_lo,
      qo_2_final = qo_2_rounded == qo_2_rounded ? qo_2_rounded : qo_2;
  const double qo_3_rounded = qo_3 + qo_3_own_error,
      qo_3_final = qo_3_rounded == qo_3_rounded ? qo_3_rounded : qo_3;
  qo->x = qo_0_final;
  qo->y = qo_1_final;
  qo->z = qo_2_final;
  qo->w = qo_3_final;
}

/* angle = 2 atan2(|v|, |w|), axis = ±v / |v|; 0 <= angle <= π; the axis is (1, 0, 0) if the
     angle is 0; any multiple of a quaternion.
   q: quaternion (x, y, z, w), the scalar last; axis: vector.
   149 mul, 268 add, 25 product error, 3 product rest, 13 div, 1 sqrt, 5 neg, 17 abs, 4 copysign,
     27 less, 10 equal, 51 select.
   Error <= angle: 1 u, axis: 1 u of its largest component; searched, not proved.  Each component
     is within 1 ulp as long as its condition is below 1e13; in single precision it is the
     nearest number, except near ties, as long as that is below 1e5; searched, not proved. */
static inline double ksl_axis_angle_from_quaternion_accurate(const ksl_quaternion_t *q,
    ksl_vec3_t *axis) {
  const double s_size_0 = fabs(q->x);
  const double s_size_1 = fabs(q->y);
  const double s_size_2 = fabs(q->z);
  const double s_size_3 = fabs(q->w);
  const double s_largest1 = s_size_0 < s_size_1 ? s_size_1 : s_size_0;
  const double s_largest2 = s_largest1 < s_size_2 ? s_size_2 : s_largest1;
  const double s_largest3 = s_largest2 < s_size_3 ? s_size_3 : s_largest2;
  const double s_b = 6.703903964971299e+153 < s_largest3 ? 3.7291703656001034e-155 : 1.0,
      s_d = s_largest3 < 256.0 ? 1.3093562431584567e+151 : s_b,
      s = s_largest3 < 1.955159272639747e-149 ? 1.0715086071862673e+301 : s_d;
  const double scaled_s_0 = KSL_MUL(q->x, s);
  const double scaled_s_1 = KSL_MUL(q->y, s);
  const double scaled_s_2 = KSL_MUL(q->z, s);
  const double scaled_s_3 = KSL_MUL(q->w, s);
  const double upper_0a = -scaled_s_0, upper_0 = scaled_s_3 < 0.0 ? upper_0a : scaled_s_0;
  const double upper_1a = -scaled_s_1, upper_1 = scaled_s_3 < 0.0 ? upper_1a : scaled_s_1;
  const double upper_2a = -scaled_s_2, upper_2 = scaled_s_3 < 0.0 ? upper_2a : scaled_s_2;
  const double upper_3a = -scaled_s_3, upper_3 = scaled_s_3 < 0.0 ? upper_3a : scaled_s_3;
  const double v_s_size_0 = fabs(upper_0);
  const double v_s_size_1 = fabs(upper_1);
  const double v_s_size_2 = fabs(upper_2);
  const double v_s_largest1 = v_s_size_0 < v_s_size_1 ? v_s_size_1 : v_s_size_0;
  const double v_s_largest2 = v_s_largest1 < v_s_size_2 ? v_s_size_2 : v_s_largest1;
  const double v_s_b = v_s_largest2 < 256.0 ? 1.3093562431584567e+151 : 1.0,
      v_s = v_s_largest2 < 1.955159272639747e-149 ? 1.0715086071862673e+301 : v_s_b;
  const double v_y_0 = KSL_MUL(upper_0, v_s);
  const double v_y_1 = KSL_MUL(upper_1, v_s);
  const double v_y_2 = KSL_MUL(upper_2, v_s);
  const double v_n_a = KSL_MUL(v_y_0, v_y_0), v_n_b = KSL_MUL(v_y_1, v_y_1), v_n_c = v_n_a + v_n_b,
      v_n_c_right = v_n_c - v_n_a, v_n_c_left = v_n_c - v_n_c_right,
      v_n_c_left_rest = ksl_product_rest(v_y_0, v_y_0, v_n_a, v_n_c_left),
      v_n_c_right_rest = ksl_product_rest(v_y_1, v_y_1, v_n_b, v_n_c_right),
      v_n_c_lo = v_n_c_left_rest + v_n_c_right_rest, v_n_d = KSL_MUL(v_y_2, v_y_2),
      v_n_e = v_n_c + v_n_d, v_n_e_right = v_n_e - v_n_c, v_n_e_left = v_n_e - v_n_e_right,
      v_n_e_left_rest = v_n_c - v_n_e_left,
      v_n_e_right_rest = ksl_product_rest(v_y_2, v_y_2, v_n_d, v_n_e_right),
      v_n_e_lo1 = v_n_e_left_rest + v_n_e_right_rest, v_n_e_lo = v_n_e_lo1 + v_n_c_lo,
      v_n_of_v_n_e = v_n_e + v_n_e_lo, v_n_of_v_n_e_right = v_n_of_v_n_e - v_n_e,
      v_n_of_v_n_e_left = v_n_of_v_n_e - v_n_of_v_n_e_right,
      v_n_of_v_n_e_left_rest = v_n_e - v_n_of_v_n_e_left,
      v_n_of_v_n_e_right_rest = v_n_e_lo - v_n_of_v_n_e_right,
      v_n_of_v_n_e_lo = v_n_of_v_n_e_left_rest + v_n_of_v_n_e_right_rest, v_n = sqrt(v_n_of_v_n_e),
      v_n_product = KSL_MUL(v_n, v_n), v_n_product_error = ksl_product_error(v_n, v_n, v_n_product),
      v_n_rest = v_n_of_v_n_e - v_n_product, v_n_exact = v_n_rest - v_n_product_error,
      v_n_residual = v_n_exact + v_n_of_v_n_e_lo, v_n_twice = v_n + v_n,
      v_n_divisor = v_n == 0.0 ? 1.0 : v_n_twice, v_n_lo = v_n_residual / v_n_divisor;
  const double v_r_b = 1.0 < v_s ? 7.637340908749012e-152 : 1.0,
      v_r = 1.3093562431584567e+151 < v_s ? 9.332636185032189e-302 : v_r_b;
  const double n_of_v_n = v_n + v_n_lo, n_of_v_n_right = n_of_v_n - v_n,
      n_of_v_n_left = n_of_v_n - n_of_v_n_right, n_of_v_n_left_rest = v_n - n_of_v_n_left,
      n_of_v_n_right_rest = v_n_lo - n_of_v_n_right,
      n_of_v_n_lo = n_of_v_n_left_rest + n_of_v_n_right_rest, n = KSL_MUL(n_of_v_n, v_r),
      n_inverse = 1.0 / v_r, n_back = KSL_MUL(n, n_inverse), n_lost = n_of_v_n - n_back,
      n_rest = n_lost + n_of_v_n_lo, n_lo = KSL_MUL(n_rest, v_r);
  const double half_of_n = n + n_lo, half_of_n_right = half_of_n - n,
      half_of_n_left = half_of_n - half_of_n_right, half_of_n_left_rest = n - half_of_n_left,
      half_of_n_right_rest = n_lo - half_of_n_right,
      half_of_n_lo = half_of_n_left_rest + half_of_n_right_rest,
      half = ksl_atan2(half_of_n, upper_3),
      half_own_error = ksl_atan2_error(half_of_n, upper_3, half), half_size0 = fabs(half_of_n),
      half_size1 = fabs(upper_3), half_most = half_size0 < half_size1 ? half_size1 : half_size0,
      half_divisor = half_most == 0.0 ? 1.0 : half_most, half_part0 = half_of_n / half_divisor,
      half_part1 = upper_3 / half_divisor, half_cross1 = KSL_MUL(half_part1, half_of_n_lo),
      half_cross2 = KSL_MUL(half_part0, 0.0), half_square1 = KSL_MUL(half_part1, half_part1),
      half_square2 = KSL_MUL(half_part0, half_part0), half_cross = half_cross1 - half_cross2,
      half_square = half_square1 + half_square2, half_divisor2 = KSL_MUL(half_divisor, half_square),
      half_safe = half_most == 0.0 ? 1.0 : half_divisor2, half_more = half_cross / half_safe,
      half_lo = half_own_error + half_more;
  const double divisor = n_of_v_n == 0.0 ? 1.0 : n_of_v_n,
      divisor_lo = n_of_v_n == 0.0 ? 0.0 : n_of_v_n_lo;
  const double unit_0_of_divisor = divisor + divisor_lo,
      unit_0_of_divisor_right = unit_0_of_divisor - divisor,
      unit_0_of_divisor_left = unit_0_of_divisor - unit_0_of_divisor_right,
      unit_0_of_divisor_left_rest = divisor - unit_0_of_divisor_left,
      unit_0_of_divisor_right_rest = divisor_lo - unit_0_of_divisor_right,
      unit_0_of_divisor_lo = unit_0_of_divisor_left_rest + unit_0_of_divisor_right_rest,
      unit_0 = v_y_0 / unit_0_of_divisor, unit_0_product = KSL_MUL(unit_0, unit_0_of_divisor),
      unit_0_product_error = ksl_product_error(unit_0, unit_0_of_divisor, unit_0_product),
      unit_0_rest = v_y_0 - unit_0_product, unit_0_exact = unit_0_rest - unit_0_product_error,
      unit_0_cross = KSL_MUL(unit_0, unit_0_of_divisor_lo),
      unit_0_residual = unit_0_exact - unit_0_cross,
      unit_0_lo = unit_0_residual / unit_0_of_divisor;
  const double unit_1 = v_y_1 / unit_0_of_divisor,
      unit_1_product = KSL_MUL(unit_1, unit_0_of_divisor),
      unit_1_product_error = ksl_product_error(unit_1, unit_0_of_divisor, unit_1_product),
      unit_1_rest = v_y_1 - unit_1_product, unit_1_exact = unit_1_rest - unit_1_product_error,
      unit_1_cross = KSL_MUL(unit_1, unit_0_of_divisor_lo),
      unit_1_residual = unit_1_exact - unit_1_cross,
      unit_1_lo = unit_1_residual / unit_0_of_divisor;
  const double unit_2 = v_y_2 / unit_0_of_divisor,
      unit_2_product = KSL_MUL(unit_2, unit_0_of_divisor),
      unit_2_product_error = ksl_product_error(unit_2, unit_0_of_divisor, unit_2_product),
      unit_2_rest = v_y_2 - unit_2_product, unit_2_exact = unit_2_rest - unit_2_product_error,
      unit_2_cross = KSL_MUL(unit_2, unit_0_of_divisor_lo),
      unit_2_residual = unit_2_exact - unit_2_cross,
      unit_2_lo = unit_2_residual / unit_0_of_divisor;
  const double angle = KSL_MUL(2.0, half), angle_cross2 = KSL_MUL(2.0, half_lo);
  const double axis_0 = n_of_v_n == 0.0 ? 1.0 : unit_0,
      axis_0_lo = n_of_v_n == 0.0 ? 0.0 : unit_0_lo;
  const double angle_rounded = angle + angle_cross2,
      angle_final = angle_rounded == angle_rounded ? angle_rounded : angle;
  const double axis_0_rounded = axis_0 + axis_0_lo,
      axis_0_final = axis_0_rounded == axis_0_rounded ? axis_0_rounded : axis_0;
  const double unit_1_rounded = unit_1 + unit_1_lo,
      unit_1_final = unit_1_rounded == unit_1_rounded ? unit_1_rounded : unit_1;
  const double unit_2_rounded = unit_2 + unit_2_lo,
      unit_2_final = unit_2_rounded == unit_2_rounded ? unit_2_rounded : unit_2;
  axis->x = axis_0_final;
  axis->y = unit_1_final;
  axis->z = unit_2_final;
  return angle_final;
}

/* qo = exp (v/2; 0) = (v/θ sin θ/2; cos θ/2), θ = |v|: turns by the rotation vector v.
   v: vector; qo: quaternion (x, y, z, w), the scalar last.
   145 mul, 231 add, 17 product error, 4 product rest, 5 div, 1 sqrt, 7 abs, 6 less, 5 equal, 14
     select.
   Error <= qo: 1 u of its largest component for |v| <= 1e13, in single precision 1e5; searched,
     not proved.  Each component is within 1 ulp as long as its condition is below 1e13; in
     single precision it is the nearest number, except near ties, as long as that is below 1e5;
     searched, not proved. */
static inline void ksl_quaternion_exp_accurate(const ksl_vec3_t *v, ksl_quaternion_t *qo) {
  const double h_0 = KSL_MUL(0.5, v->x);
  const double h_1 = KSL_MUL(0.5, v->y);
  const double h_2 = KSL_MUL(0.5, v->z);
  const double h_size_0 = fabs(h_0);
  const double h_size_1 = fabs(h_1);
  const double h_size_2 = fabs(h_2);
  const double h_largest1 = h_size_0 < h_size_1 ? h_size_1 : h_size_0;
  const double h_largest2 = h_largest1 < h_size_2 ? h_size_2 : h_largest1;
  const double s = 6.703903964971299e+153 < h_largest2 ? 3.7291703656001034e-155 : 1.0;
  const double reduced_0 = KSL_MUL(h_0, s);
  const double reduced_1 = KSL_MUL(h_1, s);
  const double reduced_2 = KSL_MUL(h_2, s);
  const double up = s < 1.0 ? 2.6815615859885194e+154 : 1.0;
  const double reduced_length_a = KSL_MUL(reduced_0, reduced_0),
      reduced_length_b = KSL_MUL(reduced_1, reduced_1),
      reduced_length_c = reduced_length_a + reduced_length_b,
      reduced_length_c_right = reduced_length_c - reduced_length_a,
      reduced_length_c_left = reduced_length_c - reduced_length_c_right,
      reduced_length_c_left_rest = ksl_product_rest(reduced_0, reduced_0, reduced_length_a,
          reduced_length_c_left),
      reduced_length_c_right_rest = ksl_product_rest(reduced_1, reduced_1, reduced_length_b,
          reduced_length_c_right),
      reduced_length_c_lo = reduced_length_c_left_rest + reduced_length_c_right_rest,
      reduced_length_d = KSL_MUL(reduced_2, reduced_2),
      reduced_length_e = reduced_length_c + reduced_length_d,
      reduced_length_e_right = reduced_length_e - reduced_length_c,
      reduced_length_e_left = reduced_length_e - reduced_length_e_right,
      reduced_length_e_left_rest = reduced_length_c - reduced_length_e_left,
      reduced_length_e_right_rest = ksl_product_rest(reduced_2, reduced_2, reduced_length_d,
          reduced_length_e_right),
      reduced_length_e_lo1 = reduced_length_e_left_rest + reduced_length_e_right_rest,
      reduced_length_e_lo = reduced_length_e_lo1 + reduced_length_c_lo,
      reduced_length_of_reduced_length_e = reduced_length_e + reduced_length_e_lo,
      reduced_length_of_reduced_length_e_right = reduced_length_of_reduced_length_e -
          reduced_length_e,
      reduced_length_of_reduced_length_e_left = reduced_length_of_reduced_length_e -
          reduced_length_of_reduced_length_e_right,
      reduced_length_of_reduced_length_e_left_rest = reduced_length_e -
          reduced_length_of_reduced_length_e_left,
      reduced_length_of_reduced_length_e_right_rest = reduced_length_e_lo -
          reduced_length_of_reduced_length_e_right,
      reduced_length_of_reduced_length_e_lo = reduced_length_of_reduced_length_e_left_rest +
          reduced_length_of_reduced_length_e_right_rest,
      reduced_length = sqrt(reduced_length_of_reduced_length_e),
      reduced_length_product = KSL_MUL(reduced_length, reduced_length),
      reduced_length_product_error = ksl_product_error(reduced_length, reduced_length,
          reduced_length_product),
      reduced_length_rest = reduced_length_of_reduced_length_e - reduced_length_product,
      reduced_length_exact = reduced_length_rest - reduced_length_product_error,
      reduced_length_residual = reduced_length_exact + reduced_length_of_reduced_length_e_lo,
      reduced_length_twice = reduced_length + reduced_length,
      reduced_length_divisor = reduced_length == 0.0 ? 1.0 : reduced_length_twice,
      reduced_length_lo = reduced_length_residual / reduced_length_divisor;
  const double half_angle_of_reduced_length = reduced_length + reduced_length_lo,
      half_angle_of_reduced_length_right = half_angle_of_reduced_length - reduced_length,
      half_angle_of_reduced_length_left = half_angle_of_reduced_length -
          half_angle_of_reduced_length_right,
      half_angle_of_reduced_length_left_rest = reduced_length - half_angle_of_reduced_length_left,
      half_angle_of_reduced_length_right_rest = reduced_length_lo -
          half_angle_of_reduced_length_right,
      half_angle_of_reduced_length_lo = half_angle_of_reduced_length_left_rest +
          half_angle_of_reduced_length_right_rest,
      half_angle = KSL_MUL(half_angle_of_reduced_length, up), half_angle_inverse = 1.0 / up,
      half_angle_back = KSL_MUL(half_angle, half_angle_inverse),
      half_angle_lost = half_angle_of_reduced_length - half_angle_back,
      half_angle_rest = half_angle_lost + half_angle_of_reduced_length_lo,
      half_angle_lo = KSL_MUL(half_angle_rest, up);
  const double y = KSL_MUL(half_angle, half_angle), y_cross1 = KSL_MUL(half_angle_lo, half_angle),
      y_cross2 = KSL_MUL(half_angle, half_angle_lo), y_cross = y_cross1 + y_cross2;
  const double sine_of_half_angle = half_angle + half_angle_lo,
      sine_of_half_angle_right = sine_of_half_angle - half_angle,
      sine_of_half_angle_left = sine_of_half_angle - sine_of_half_angle_right,
      sine_of_half_angle_left_rest = half_angle - sine_of_half_angle_left,
      sine_of_half_angle_right_rest = half_angle_lo - sine_of_half_angle_right,
      sine_of_half_angle_lo = sine_of_half_angle_left_rest + sine_of_half_angle_right_rest;
  double c; const double sine = ksl_sincos(sine_of_half_angle, &c);
  double c_own_error; const double sine_own_error = ksl_sincos_error(sine_of_half_angle, sine, c,
      &c_own_error);
  const double sine_half = KSL_MUL(sine_of_half_angle_lo, 0.5);
  double sine_half_cos; const double sine_half_sin = ksl_sincos(sine_half, &sine_half_cos);
  const double sine_twice = sine_half_sin + sine_half_sin, sine_slope1 = KSL_MUL(sine_half_cos, c),
      sine_slope2 = KSL_MUL(sine_half_sin, sine), sine_slope = sine_slope1 - sine_slope2,
      sine_more = KSL_MUL(sine_slope, sine_twice), sine_lo = sine_own_error + sine_more;
  const double c_slope1 = KSL_MUL(sine_half_cos, sine), c_slope2 = KSL_MUL(sine_half_sin, c),
      c_slope = c_slope1 + c_slope2, c_more = KSL_MUL(c_slope, sine_twice),
      c_lo = c_own_error - c_more;
  const double sinc_divisor = sine_of_half_angle < 1.4901161193847656e-08 ? 1.4901161193847656e-08 :
      sine_of_half_angle,
      sinc_divisor_lo = sine_of_half_angle < 1.4901161193847656e-08 ? 0.0 : sine_of_half_angle_lo;
  const double sinc_quotient_of_sine = sine + sine_lo,
      sinc_quotient_of_sine_right = sinc_quotient_of_sine - sine,
      sinc_quotient_of_sine_left = sinc_quotient_of_sine - sinc_quotient_of_sine_right,
      sinc_quotient_of_sine_left_rest = sine - sinc_quotient_of_sine_left,
      sinc_quotient_of_sine_right_rest = sine_lo - sinc_quotient_of_sine_right,
      sinc_quotient_of_sine_lo = sinc_quotient_of_sine_left_rest + sinc_quotient_of_sine_right_rest,
      sinc_quotient_of_sinc_divisor = sinc_divisor + sinc_divisor_lo,
      sinc_quotient_of_sinc_divisor_right = sinc_quotient_of_sinc_divisor - sinc_divisor,
      sinc_quotient_of_sinc_divisor_left = sinc_quotient_of_sinc_divisor -
          sinc_quotient_of_sinc_divisor_right,
      sinc_quotient_of_sinc_divisor_left_rest = sinc_divisor - sinc_quotient_of_sinc_divisor_left,
      sinc_quotient_of_sinc_divisor_right_rest = sinc_divisor_lo -
          sinc_quotient_of_sinc_divisor_right,
      sinc_quotient_of_sinc_divisor_lo = sinc_quotient_of_sinc_divisor_left_rest +
          sinc_quotient_of_sinc_divisor_right_rest,
      sinc_quotient = sinc_quotient_of_sine / sinc_quotient_of_sinc_divisor,
      sinc_quotient_product = KSL_MUL(sinc_quotient, sinc_quotient_of_sinc_divisor),
      sinc_quotient_product_error = ksl_product_error(sinc_quotient, sinc_quotient_of_sinc_divisor,
          sinc_quotient_product),
      sinc_quotient_rest = sinc_quotient_of_sine - sinc_quotient_product,
      sinc_quotient_exact = sinc_quotient_rest - sinc_quotient_product_error,
      sinc_quotient_numerator = sinc_quotient_exact + sinc_quotient_of_sine_lo,
      sinc_quotient_cross = KSL_MUL(sinc_quotient, sinc_quotient_of_sinc_divisor_lo),
      sinc_quotient_residual = sinc_quotient_numerator - sinc_quotient_cross,
      sinc_quotient_lo = sinc_quotient_residual / sinc_quotient_of_sinc_divisor;
  const double y_error = ksl_product_error(half_angle, half_angle, y), y_lo = y_error + y_cross,
      sinc_a = KSL_MUL(0.16666666666666666, y), sinc_a_cross1 = KSL_MUL(9.25185853854297e-18, y),
      sinc_a_cross2 = KSL_MUL(0.16666666666666666, y_lo),
      sinc_a_cross = sinc_a_cross1 + sinc_a_cross2, sinc_b = 1.0 - sinc_a,
      sinc_b_right = 1.0 - sinc_b, sinc_b_left = sinc_b + sinc_b_right,
      sinc_b_left_rest = 1.0 - sinc_b_left,
      sinc_b_right_rest = ksl_product_rest(0.16666666666666666, y, sinc_a, sinc_b_right),
      sinc_b_lo1 = sinc_b_left_rest - sinc_b_right_rest, sinc_b_lo = sinc_b_lo1 - sinc_a_cross,
      sinc = sine_of_half_angle < 1.4901161193847656e-08 ? sinc_b : sinc_quotient,
      sinc_lo = sine_of_half_angle < 1.4901161193847656e-08 ? sinc_b_lo : sinc_quotient_lo;
  const double qo_0 = KSL_MUL(h_0, sinc), qo_0_cross2 = KSL_MUL(h_0, sinc_lo);
  const double qo_1 = KSL_MUL(h_1, sinc), qo_1_cross2 = KSL_MUL(h_1, sinc_lo);
  const double qo_2 = KSL_MUL(h_2, sinc), qo_2_cross2 = KSL_MUL(h_2, sinc_lo);
  const double qo_0_error = ksl_product_error(h_0, sinc, qo_0), qo_0_lo = qo_0_error + qo_0_cross2,
      qo_0_rounded = qo_0 + qo_0_lo,
      qo_0_final = qo_0_rounded == qo_0_rounded ? qo_0_rounded : qo_0;
  const double qo_1_error = ksl_product_error(h_1, sinc, qo_1), qo_1_lo = qo_1_error + qo_1_cross2,
      qo_1_rounded = qo_1 + qo_1_lo,
      qo_1_final = qo_1_rounded == qo_1_rounded ? qo_1_rounded : qo_1;
  const double qo_2_error = ksl_product_error(h_2, sinc, qo_2), qo_2_lo = qo_2_error + qo_2_cross2,
      qo_2_rounded = qo_2 + qo_2_lo,
      qo_2_final = qo_2_rounded == qo_2_rounded ? qo_2_rounded : qo_2;
  const double c_rounded = c + c_lo, c_final = c_rounded == c_rounded ? c_rounded : c;
  qo->x = qo_0_final;
  qo->y = qo_1_final;
  qo->z = qo_2_final;
  qo->w = c_final;
}

/* vo = θ v/|v|, θ = 2 atan2(|v|, |w|) <= π: the rotation vector of q, or of any multiple of it.
   q: quaternion (x, y, z, w), the scalar last; vo: vector.
   151 mul, 271 add, 26 product error, 3 product rest, 9 div, 1 sqrt, 5 neg, 17 abs, 4 copysign,
     27 less, 9 equal, 48 select.
   Error <= vo: 1 u of its largest component; searched, not proved.  Each component is within 1
     ulp as long as its condition is below 1e13; in single precision it is the nearest number,
     except near ties, as long as that is below 1e5; searched, not proved. */
static inline void ksl_quaternion_log_accurate(const ksl_quaternion_t *q, ksl_vec3_t *vo) {
  const double s_size_0 = fabs(q->x);
  const double s_size_1 = fabs(q->y);
  const double s_size_2 = fabs(q->z);
  const double s_size_3 = fabs(q->w);
  const double s_largest1 = s_size_0 < s_size_1 ? s_size_1 : s_size_0;
  const double s_largest2 = s_largest1 < s_size_2 ? s_size_2 : s_largest1;
  const double s_largest3 = s_largest2 < s_size_3 ? s_size_3 : s_largest2;
  const double s_b = 6.703903964971299e+153 < s_largest3 ? 3.7291703656001034e-155 : 1.0,
      s_d = s_largest3 < 256.0 ? 1.3093562431584567e+151 : s_b,
      s = s_largest3 < 1.955159272639747e-149 ? 1.0715086071862673e+301 : s_d;
  const double scaled_s_0 = KSL_MUL(q->x, s);
  const double scaled_s_1 = KSL_MUL(q->y, s);
  const double scaled_s_2 = KSL_MUL(q->z, s);
  const double scaled_s_3 = KSL_MUL(q->w, s);
  const double upper_0a = -scaled_s_0, upper_0 = scaled_s_3 < 0.0 ? upper_0a : scaled_s_0;
  const double upper_1a = -scaled_s_1, upper_1 = scaled_s_3 < 0.0 ? upper_1a : scaled_s_1;
  const double upper_2a = -scaled_s_2, upper_2 = scaled_s_3 < 0.0 ? upper_2a : scaled_s_2;
  const double upper_3a = -scaled_s_3, upper_3 = scaled_s_3 < 0.0 ? upper_3a : scaled_s_3;
  const double v_s_size_0 = fabs(upper_0);
  const double v_s_size_1 = fabs(upper_1);
  const double v_s_size_2 = fabs(upper_2);
  const double v_s_largest1 = v_s_size_0 < v_s_size_1 ? v_s_size_1 : v_s_size_0;
  const double v_s_largest2 = v_s_largest1 < v_s_size_2 ? v_s_size_2 : v_s_largest1;
  const double v_s_b = v_s_largest2 < 256.0 ? 1.3093562431584567e+151 : 1.0,
      v_s = v_s_largest2 < 1.955159272639747e-149 ? 1.0715086071862673e+301 : v_s_b;
  const double v_y_0 = KSL_MUL(upper_0, v_s);
  const double v_y_1 = KSL_MUL(upper_1, v_s);
  const double v_y_2 = KSL_MUL(upper_2, v_s);
  const double v_n_a = KSL_MUL(v_y_0, v_y_0), v_n_b = KSL_MUL(v_y_1, v_y_1), v_n_c = v_n_a + v_n_b,
      v_n_c_right = v_n_c - v_n_a, v_n_c_left = v_n_c - v_n_c_right,
      v_n_c_left_rest = ksl_product_rest(v_y_0, v_y_0, v_n_a, v_n_c_left),
      v_n_c_right_rest = ksl_product_rest(v_y_1, v_y_1, v_n_b, v_n_c_right),
      v_n_c_lo = v_n_c_left_rest + v_n_c_right_rest, v_n_d = KSL_MUL(v_y_2, v_y_2),
      v_n_e = v_n_c + v_n_d, v_n_e_right = v_n_e - v_n_c, v_n_e_left = v_n_e - v_n_e_right,
      v_n_e_left_rest = v_n_c - v_n_e_left,
      v_n_e_right_rest = ksl_product_rest(v_y_2, v_y_2, v_n_d, v_n_e_right),
      v_n_e_lo1 = v_n_e_left_rest + v_n_e_right_rest, v_n_e_lo = v_n_e_lo1 + v_n_c_lo,
      v_n_of_v_n_e = v_n_e + v_n_e_lo, v_n_of_v_n_e_right = v_n_of_v_n_e - v_n_e,
      v_n_of_v_n_e_left = v_n_of_v_n_e - v_n_of_v_n_e_right,
      v_n_of_v_n_e_left_rest = v_n_e - v_n_of_v_n_e_left,
      v_n_of_v_n_e_right_rest = v_n_e_lo - v_n_of_v_n_e_right,
      v_n_of_v_n_e_lo = v_n_of_v_n_e_left_rest + v_n_of_v_n_e_right_rest, v_n = sqrt(v_n_of_v_n_e),
      v_n_product = KSL_MUL(v_n, v_n), v_n_product_error = ksl_product_error(v_n, v_n, v_n_product),
      v_n_rest = v_n_of_v_n_e - v_n_product, v_n_exact = v_n_rest - v_n_product_error,
      v_n_residual = v_n_exact + v_n_of_v_n_e_lo, v_n_twice = v_n + v_n,
      v_n_divisor = v_n == 0.0 ? 1.0 : v_n_twice, v_n_lo = v_n_residual / v_n_divisor;
  const double v_r_b = 1.0 < v_s ? 7.637340908749012e-152 : 1.0,
      v_r = 1.3093562431584567e+151 < v_s ? 9.332636185032189e-302 : v_r_b;
  const double n_of_v_n = v_n + v_n_lo, n_of_v_n_right = n_of_v_n - v_n,
      n_of_v_n_left = n_of_v_n - n_of_v_n_right, n_of_v_n_left_rest = v_n - n_of_v_n_left,
      n_of_v_n_right_rest = v_n_lo - n_of_v_n_right,
      n_of_v_n_lo = n_of_v_n_left_rest + n_of_v_n_right_rest, n = KSL_MUL(n_of_v_n, v_r),
      n_inverse = 1.0 / v_r, n_back = KSL_MUL(n, n_inverse), n_lost = n_of_v_n - n_back,
      n_rest = n_lost + n_of_v_n_lo, n_lo = KSL_MUL(n_rest, v_r);
  const double half_of_n = n + n_lo, half_of_n_right = half_of_n - n,
      half_of_n_left = half_of_n - half_of_n_right, half_of_n_left_rest = n - half_of_n_left,
      half_of_n_right_rest = n_lo - half_of_n_right,
      half_of_n_lo = half_of_n_left_rest + half_of_n_right_rest,
      half = ksl_atan2(half_of_n, upper_3),
      half_own_error = ksl_atan2_error(half_of_n, upper_3, half), half_size0 = fabs(half_of_n),
      half_size1 = fabs(upper_3), half_most = half_size0 < half_size1 ? half_size1 : half_size0,
      half_divisor = half_most == 0.0 ? 1.0 : half_most, half_part0 = half_of_n / half_divisor,
      half_part1 = upper_3 / half_divisor, half_cross1 = KSL_MUL(half_part1, half_of_n_lo),
      half_cross2 = KSL_MUL(half_part0, 0.0), half_square1 = KSL_MUL(half_part1, half_part1),
      half_square2 = KSL_MUL(half_part0, half_part0), half_cross = half_cross1 - half_cross2,
      half_square = half_square1 + half_square2, half_divisor2 = KSL_MUL(half_divisor, half_square),
      half_safe = half_most == 0.0 ? 1.0 : half_divisor2, half_more = half_cross / half_safe,
      half_lo = half_own_error + half_more;
  const double divisor = half_of_n == 0.0 ? 1.0 : half_of_n,
      divisor_lo = half_of_n == 0.0 ? 0.0 : half_of_n_lo;
  const double theta = KSL_MUL(2.0, half), theta_cross2 = KSL_MUL(2.0, half_lo);
  const double k_of_theta = theta + theta_cross2, k_of_theta_right = k_of_theta - theta,
      k_of_theta_left = k_of_theta - k_of_theta_right,
      k_of_theta_left_rest = theta - k_of_theta_left,
      k_of_theta_right_rest = theta_cross2 - k_of_theta_right,
      k_of_theta_lo = k_of_theta_left_rest + k_of_theta_right_rest,
      k_of_divisor = divisor + divisor_lo, k_of_divisor_right = k_of_divisor - divisor,
      k_of_divisor_left = k_of_divisor - k_of_divisor_right,
      k_of_divisor_left_rest = divisor - k_of_divisor_left,
      k_of_divisor_right_rest = divisor_lo - k_of_divisor_right,
      k_of_divisor_lo = k_of_divisor_left_rest + k_of_divisor_right_rest,
      k = k_of_theta / k_of_divisor, k_product = KSL_MUL(k, k_of_divisor),
      k_product_error = ksl_product_error(k, k_of_divisor, k_product),
      k_rest = k_of_theta - k_product, k_exact = k_rest - k_product_error,
      k_numerator = k_exact + k_of_theta_lo, k_cross = KSL_MUL(k, k_of_divisor_lo),
      k_residual = k_numerator - k_cross, k_lo = k_residual / k_of_divisor;
  const double vector_0 = KSL_MUL(upper_0, k), vector_0_cross2 = KSL_MUL(upper_0, k_lo);
  const double vector_1 = KSL_MUL(upper_1, k), vector_1_cross2 = KSL_MUL(upper_1, k_lo);
  const double vector_2 = KSL_MUL(upper_2, k), vector_2_cross2 = KSL_MUL(upper_2, k_lo);
  const double vector_0_error = ksl_product_error(upper_0, k, vector_0),
      vector_0_lo = vector_0_error + vector_0_cross2, vector_0_rounded = vector_0 + vector_0_lo,
      vector_0_final = vector_0_rounded == vector_0_rounded ? vector_0_rounded : vector_0;
  const double vector_1_error = ksl_product_error(upper_1, k, vector_1),
      vector_1_lo = vector_1_error + vector_1_cross2, vector_1_rounded = vector_1 + vector_1_lo,
      vector_1_final = vector_1_rounded == vector_1_rounded ? vector_1_rounded : vector_1;
  const double vector_2_error = ksl_product_error(upper_2, k, vector_2),
      vector_2_lo = vector_2_error + vector_2_cross2, vector_2_rounded = vector_2 + vector_2_lo,
      vector_2_final = vector_2_rounded == vector_2_rounded ? vector_2_rounded : vector_2;
  vo->x = vector_0_final;
  vo->y = vector_1_final;
  vo->z = vector_2_final;
}

/* qo = q1 (q1* q2)^k along the shorter arc: q1 at k = 0, ±q2 at k = 1; |q1| = |q2| = 1.
   q1, q2, qo: quaternion (x, y, z, w), the scalar last; k: number.
   371 mul, 774 add, 46 product error, 39 product rest, 16 div, 2 sqrt, 14 neg, 21 abs, 4
     copysign, 36 less, 11 equal, 68 select.
   Error <= qo: 1 u of its largest component for |q1| = 1 and |q2| = 1 and 0 <= k <= 1; searched,
     not proved.  Each component is within 1 ulp as long as its condition is below 1e13; in
     single precision it is the nearest number, except near ties, as long as that is below 1e5;
     searched, not proved. */
static inline void ksl_quaternion_interpolated_accurate(const ksl_quaternion_t *q1,
    const ksl_quaternion_t *q2, const double k, ksl_quaternion_t *qo) {
  const double between_0a = KSL_MUL(q1->w, q2->x), between_0b = KSL_MUL(q1->x, q2->w),
      between_0c = between_0a - between_0b, between_0c_right = between_0a - between_0c,
      between_0c_left = between_0c + between_0c_right,
      between_0c_left_rest = ksl_product_rest(q1->w, q2->x, between_0a, between_0c_left),
      between_0c_right_rest = ksl_product_rest(q1->x, q2->w, between_0b, between_0c_right),
      between_0c_lo = between_0c_left_rest - between_0c_right_rest,
      between_0d = KSL_MUL(q1->z, q2->y), between_0e = KSL_MUL(q1->y, q2->z),
      between_0f = between_0d - between_0e, between_0f_right = between_0d - between_0f,
      between_0f_left = between_0f + between_0f_right,
      between_0f_left_rest = ksl_product_rest(q1->z, q2->y, between_0d, between_0f_left),
      between_0f_right_rest = ksl_product_rest(q1->y, q2->z, between_0e, between_0f_right),
      between_0f_lo = between_0f_left_rest - between_0f_right_rest,
      between_0 = between_0c + between_0f, between_0_right = between_0 - between_0c,
      between_0_left = between_0 - between_0_right,
      between_0_left_rest = between_0c - between_0_left,
      between_0_right_rest = between_0f - between_0_right,
      between_0_lo1 = between_0_left_rest + between_0_right_rest,
      between_0_lo2 = between_0_lo1 + between_0f_lo, between_0_lo = between_0_lo2 + between_0c_lo;
  const double between_1a = KSL_MUL(q1->x, q2->z), between_1b = KSL_MUL(q1->z, q2->x),
      between_1c = between_1a - between_1b, between_1c_right = between_1a - between_1c,
      between_1c_left = between_1c + between_1c_right,
      between_1c_left_rest = ksl_product_rest(q1->x, q2->z, between_1a, between_1c_left),
      between_1c_right_rest = ksl_product_rest(q1->z, q2->x, between_1b, between_1c_right),
      between_1c_lo = between_1c_left_rest - between_1c_right_rest,
      between_1d = KSL_MUL(q1->w, q2->y), between_1e = KSL_MUL(q1->y, q2->w),
      between_1f = between_1d - between_1e, between_1f_right = between_1d - between_1f,
      between_1f_left = between_1f + between_1f_right,
      between_1f_left_rest = ksl_product_rest(q1->w, q2->y, between_1d, between_1f_left),
      between_1f_right_rest = ksl_product_rest(q1->y, q2->w, between_1e, between_1f_right),
      between_1f_lo = between_1f_left_rest - between_1f_right_rest,
      between_1 = between_1c + between_1f, between_1_right = between_1 - between_1c,
      between_1_left = between_1 - between_1_right,
      between_1_left_rest = between_1c - between_1_left,
      between_1_right_rest = between_1f - between_1_right,
      between_1_lo1 = between_1_left_rest + between_1_right_rest,
      between_1_lo2 = between_1_lo1 + between_1f_lo, between_1_lo = between_1_lo2 + between_1c_lo;
  const double between_2a = KSL_MUL(q1->y, q2->x), between_2b = KSL_MUL(q1->x, q2->y),
      between_2c = between_2a - between_2b, between_2c_right = between_2a - between_2c,
      between_2c_left = between_2c + between_2c_right,
      between_2c_left_rest = ksl_product_rest(q1->y, q2->x, between_2a, between_2c_left),
      between_2c_right_rest = ksl_product_rest(q1->x, q2->y, between_2b, between_2c_right),
      between_2c_lo = between_2c_left_rest - between_2c_right_rest,
      between_2d = KSL_MUL(q1->w, q2->z), between_2e = KSL_MUL(q1->z, q2->w),
      between_2f = between_2d - between_2e, between_2f_right = between_2d - between_2f,
      between_2f_left = between_2f + between_2f_right,
      between_2f_left_rest = ksl_product_rest(q1->w, q2->z, between_2d, between_2f_left),
      between_2f_right_rest = ksl_product_rest(q1->z, q2->w, between_2e, between_2f_right),
      between_2f_lo = between_2f_left_rest - between_2f_right_rest,
      between_2 = between_2c + between_2f, between_2_right = between_2 - between_2c,
      between_2_left = between_2 - between_2_right,
      between_2_left_rest = between_2c - between_2_left,
      between_2_right_rest = between_2f - between_2_right,
      between_2_lo1 = between_2_left_rest + between_2_right_rest,
      between_2_lo2 = between_2_lo1 + between_2f_lo, between_2_lo = between_2_lo2 + between_2c_lo;
  const double between_3a = KSL_MUL(q1->x, q2->x), between_3b = KSL_MUL(q1->y, q2->y),
      between_3c = between_3a + between_3b, between_3c_right = between_3c - between_3a,
      between_3c_left = between_3c - between_3c_right,
      between_3c_left_rest = ksl_product_rest(q1->x, q2->x, between_3a, between_3c_left),
      between_3c_right_rest = ksl_product_rest(q1->y, q2->y, between_3b, between_3c_right),
      between_3c_lo = between_3c_left_rest + between_3c_right_rest,
      between_3d = KSL_MUL(q1->z, q2->z), between_3e = between_3c + between_3d,
      between_3e_right = between_3e - between_3c, between_3e_left = between_3e - between_3e_right,
      between_3e_left_rest = between_3c - between_3e_left,
      between_3e_right_rest = ksl_product_rest(q1->z, q2->z, between_3d, between_3e_right),
      between_3e_lo1 = between_3e_left_rest + between_3e_right_rest,
      between_3e_lo = between_3e_lo1 + between_3c_lo, between_3f = KSL_MUL(q1->w, q2->w),
      between_3 = between_3e + between_3f, between_3_right = between_3 - between_3e,
      between_3_left = between_3 - between_3_right,
      between_3_left_rest = between_3e - between_3_left,
      between_3_right_rest = ksl_product_rest(q1->w, q2->w, between_3f, between_3_right),
      between_3_lo1 = between_3_left_rest + between_3_right_rest,
      between_3_lo = between_3_lo1 + between_3e_lo;
  const double upper_0a = -between_0, upper_0a_lo = -between_0_lo,
      upper_0b_of_between_3 = between_3 + between_3_lo,
      upper_0b_of_between_3_right = upper_0b_of_between_3 - between_3,
      upper_0b_of_between_3_left = upper_0b_of_between_3 - upper_0b_of_between_3_right,
      upper_0b_of_between_3_left_rest = between_3 - upper_0b_of_between_3_left,
      upper_0b_of_between_3_right_rest = between_3_lo - upper_0b_of_between_3_right,
      upper_0b_of_between_3_lo = upper_0b_of_between_3_left_rest + upper_0b_of_between_3_right_rest,
      upper_0 = upper_0b_of_between_3 < 0.0 ? upper_0a : between_0,
      upper_0_lo = upper_0b_of_between_3 < 0.0 ? upper_0a_lo : between_0_lo;
  const double upper_1a = -between_1, upper_1a_lo = -between_1_lo,
      upper_1 = upper_0b_of_between_3 < 0.0 ? upper_1a : between_1,
      upper_1_lo = upper_0b_of_between_3 < 0.0 ? upper_1a_lo : between_1_lo;
  const double upper_2a = -between_2, upper_2a_lo = -between_2_lo,
      upper_2 = upper_0b_of_between_3 < 0.0 ? upper_2a : between_2,
      upper_2_lo = upper_0b_of_between_3 < 0.0 ? upper_2a_lo : between_2_lo;
  const double upper_3 = fabs(upper_0b_of_between_3), upper_3_opposite = -upper_0b_of_between_3_lo,
      upper_3_lo = upper_0b_of_between_3 < 0.0 ? upper_3_opposite : upper_0b_of_between_3_lo;
  const double v_s_size_0_of_upper_0 = upper_0 + upper_0_lo,
      v_s_size_0_of_upper_0_right = v_s_size_0_of_upper_0 - upper_0,
      v_s_size_0_of_upper_0_left = v_s_size_0_of_upper_0 - v_s_size_0_of_upper_0_right,
      v_s_size_0_of_upper_0_left_rest = upper_0 - v_s_size_0_of_upper_0_left,
      v_s_size_0_of_upper_0_right_rest = upper_0_lo - v_s_size_0_of_upper_0_right,
      v_s_size_0_of_upper_0_lo = v_s_size_0_of_upper_0_left_rest + v_s_size_0_of_upper_0_right_rest,
      v_s_size_0 = fabs(v_s_size_0_of_upper_0), v_s_size_0_opposite = -v_s_size_0_of_upper_0_lo,
      v_s_size_0_lo = v_s_size_0_of_upper_0 < 0.0 ? v_s_size_0_opposite : v_s_size_0_of_upper_0_lo;
  const double v_s_size_1_of_upper_1 = upper_1 + upper_1_lo,
      v_s_size_1_of_upper_1_right = v_s_size_1_of_upper_1 - upper_1,
      v_s_size_1_of_upper_1_left = v_s_size_1_of_upper_1 - v_s_size_1_of_upper_1_right,
      v_s_size_1_of_upper_1_left_rest = upper_1 - v_s_size_1_of_upper_1_left,
      v_s_size_1_of_upper_1_right_rest = upper_1_lo - v_s_size_1_of_upper_1_right,
      v_s_size_1_of_upper_1_lo = v_s_size_1_of_upper_1_left_rest + v_s_size_1_of_upper_1_right_rest,
      v_s_size_1 = fabs(v_s_size_1_of_upper_1), v_s_size_1_opposite = -v_s_size_1_of_upper_1_lo,
      v_s_size_1_lo = v_s_size_1_of_upper_1 < 0.0 ? v_s_size_1_opposite : v_s_size_1_of_upper_1_lo;
  const double v_s_size_2_of_upper_2 = upper_2 + upper_2_lo,
      v_s_size_2_of_upper_2_right = v_s_size_2_of_upper_2 - upper_2,
      v_s_size_2_of_upper_2_left = v_s_size_2_of_upper_2 - v_s_size_2_of_upper_2_right,
      v_s_size_2_of_upper_2_left_rest = upper_2 - v_s_size_2_of_upper_2_left,
      v_s_size_2_of_upper_2_right_rest = upper_2_lo - v_s_size_2_of_upper_2_right,
      v_s_size_2_of_upper_2_lo = v_s_size_2_of_upper_2_left_rest + v_s_size_2_of_upper_2_right_rest,
      v_s_size_2 = fabs(v_s_size_2_of_upper_2), v_s_size_2_opposite = -v_s_size_2_of_upper_2_lo,
      v_s_size_2_lo = v_s_size_2_of_upper_2 < 0.0 ? v_s_size_2_opposite : v_s_size_2_of_upper_2_lo;
  const double v_s_largest1a_of_v_s_size_0 = v_s_size_0 + v_s_size_0_lo,
      v_s_largest1a_of_v_s_size_0_right = v_s_largest1a_of_v_s_size_0 - v_s_size_0,
      v_s_largest1a_of_v_s_size_0_left = v_s_largest1a_of_v_s_size_0 -
          v_s_largest1a_of_v_s_size_0_right,
      v_s_largest1a_of_v_s_size_0_left_rest = v_s_size_0 - v_s_largest1a_of_v_s_size_0_left,
      v_s_largest1a_of_v_s_size_0_right_rest = v_s_size_0_lo - v_s_largest1a_of_v_s_size_0_right,
      v_s_largest1a_of_v_s_size_0_lo = v_s_largest1a_of_v_s_size_0_left_rest +
          v_s_largest1a_of_v_s_size_0_right_rest,
      v_s_largest1a_of_v_s_size_1 = v_s_size_1 + v_s_size_1_lo,
      v_s_largest1a_of_v_s_size_1_right = v_s_largest1a_of_v_s_size_1 - v_s_size_1,
      v_s_largest1a_of_v_s_size_1_left = v_s_largest1a_of_v_s_size_1 -
          v_s_largest1a_of_v_s_size_1_right,
      v_s_largest1a_of_v_s_size_1_left_rest = v_s_size_1 - v_s_largest1a_of_v_s_size_1_left,
      v_s_largest1a_of_v_s_size_1_right_rest = v_s_size_1_lo - v_s_largest1a_of_v_s_size_1_right,
      v_s_largest1a_of_v_s_size_1_lo = v_s_largest1a_of_v_s_size_1_left_rest +
          v_s_largest1a_of_v_s_size_1_right_rest,
      v_s_largest1 = v_s_largest1a_of_v_s_size_0 < v_s_largest1a_of_v_s_size_1 ?
          v_s_largest1a_of_v_s_size_1 : v_s_largest1a_of_v_s_size_0,
      v_s_largest1_lo = v_s_largest1a_of_v_s_size_0 < v_s_largest1a_of_v_s_size_1 ?
          v_s_largest1a_of_v_s_size_1_lo : v_s_largest1a_of_v_s_size_0_lo;
  const double v_s_largest2a_of_v_s_largest1 = v_s_largest1 + v_s_largest1_lo,
      v_s_largest2a_of_v_s_largest1_right = v_s_largest2a_of_v_s_largest1 - v_s_largest1,
      v_s_largest2a_of_v_s_largest1_left = v_s_largest2a_of_v_s_largest1 -
          v_s_largest2a_of_v_s_largest1_right,
      v_s_largest2a_of_v_s_largest1_left_rest = v_s_largest1 - v_s_largest2a_of_v_s_largest1_left,
      v_s_largest2a_of_v_s_largest1_right_rest = v_s_largest1_lo -
          v_s_largest2a_of_v_s_largest1_right,
      v_s_largest2a_of_v_s_largest1_lo = v_s_largest2a_of_v_s_largest1_left_rest +
          v_s_largest2a_of_v_s_largest1_right_rest,
      v_s_largest2a_of_v_s_size_2 = v_s_size_2 + v_s_size_2_lo,
      v_s_largest2a_of_v_s_size_2_right = v_s_largest2a_of_v_s_size_2 - v_s_size_2,
      v_s_largest2a_of_v_s_size_2_left = v_s_largest2a_of_v_s_size_2 -
          v_s_largest2a_of_v_s_size_2_right,
      v_s_largest2a_of_v_s_size_2_left_rest = v_s_size_2 - v_s_largest2a_of_v_s_size_2_left,
      v_s_largest2a_of_v_s_size_2_right_rest = v_s_size_2_lo - v_s_largest2a_of_v_s_size_2_right,
      v_s_largest2a_of_v_s_size_2_lo = v_s_largest2a_of_v_s_size_2_left_rest +
          v_s_largest2a_of_v_s_size_2_right_rest,
      v_s_largest2 = v_s_largest2a_of_v_s_largest1 < v_s_largest2a_of_v_s_size_2 ?
          v_s_largest2a_of_v_s_size_2 : v_s_largest2a_of_v_s_largest1,
      v_s_largest2_lo = v_s_largest2a_of_v_s_largest1 < v_s_largest2a_of_v_s_size_2 ?
          v_s_largest2a_of_v_s_size_2_lo : v_s_largest2a_of_v_s_largest1_lo;
  const double v_s_a_of_v_s_largest2 = v_s_largest2 + v_s_largest2_lo,
      v_s_b = 6.703903964971299e+153 < v_s_a_of_v_s_largest2 ? 3.7291703656001034e-155 : 1.0,
      v_s_d = v_s_a_of_v_s_largest2 < 256.0 ? 1.3093562431584567e+151 : v_s_b,
      v_s = v_s_a_of_v_s_largest2 < 1.955159272639747e-149 ? 1.0715086071862673e+301 : v_s_d;
  const double v_y_0 = KSL_MUL(v_s_size_0_of_upper_0, v_s), v_y_0_inverse = 1.0 / v_s,
      v_y_0_back = KSL_MUL(v_y_0, v_y_0_inverse), v_y_0_lost = v_s_size_0_of_upper_0 - v_y_0_back,
      v_y_0_rest = v_y_0_lost + v_s_size_0_of_upper_0_lo, v_y_0_lo = KSL_MUL(v_y_0_rest, v_s);
  const double v_y_1 = KSL_MUL(v_s_size_1_of_upper_1, v_s),
      v_y_1_back = KSL_MUL(v_y_1, v_y_0_inverse), v_y_1_lost = v_s_size_1_of_upper_1 - v_y_1_back,
      v_y_1_rest = v_y_1_lost + v_s_size_1_of_upper_1_lo, v_y_1_lo = KSL_MUL(v_y_1_rest, v_s);
  const double v_y_2 = KSL_MUL(v_s_size_2_of_upper_2, v_s),
      v_y_2_back = KSL_MUL(v_y_2, v_y_0_inverse), v_y_2_lost = v_s_size_2_of_upper_2 - v_y_2_back,
      v_y_2_rest = v_y_2_lost + v_s_size_2_of_upper_2_lo, v_y_2_lo = KSL_MUL(v_y_2_rest, v_s);
  const double v_n_a = KSL_MUL(v_y_0, v_y_0), v_n_a_cross1 = KSL_MUL(v_y_0_lo, v_y_0),
      v_n_a_cross2 = KSL_MUL(v_y_0, v_y_0_lo), v_n_a_cross = v_n_a_cross1 + v_n_a_cross2,
      v_n_b = KSL_MUL(v_y_1, v_y_1), v_n_b_cross1 = KSL_MUL(v_y_1_lo, v_y_1),
      v_n_b_cross2 = KSL_MUL(v_y_1, v_y_1_lo), v_n_b_cross = v_n_b_cross1 + v_n_b_cross2,
      v_n_c = v_n_a + v_n_b, v_n_c_right = v_n_c - v_n_a, v_n_c_left = v_n_c - v_n_c_right,
      v_n_c_left_rest = ksl_product_rest(v_y_0, v_y_0, v_n_a, v_n_c_left),
      v_n_c_right_rest = ksl_product_rest(v_y_1, v_y_1, v_n_b, v_n_c_right),
      v_n_c_cross = v_n_a_cross + v_n_b_cross, v_n_c_lo1 = v_n_c_left_rest + v_n_c_right_rest,
      v_n_c_lo = v_n_c_lo1 + v_n_c_cross, v_n_d = KSL_MUL(v_y_2, v_y_2),
      v_n_d_cross1 = KSL_MUL(v_y_2_lo, v_y_2), v_n_d_cross2 = KSL_MUL(v_y_2, v_y_2_lo),
      v_n_d_cross = v_n_d_cross1 + v_n_d_cross2, v_n_e = v_n_c + v_n_d, v_n_e_right = v_n_e - v_n_c,
      v_n_e_left = v_n_e - v_n_e_right, v_n_e_left_rest = v_n_c - v_n_e_left,
      v_n_e_right_rest = ksl_product_rest(v_y_2, v_y_2, v_n_d, v_n_e_right),
      v_n_e_lo1 = v_n_e_left_rest + v_n_e_right_rest, v_n_e_lo2 = v_n_e_lo1 + v_n_d_cross,
      v_n_e_lo = v_n_e_lo2 + v_n_c_lo, v_n_of_v_n_e = v_n_e + v_n_e_lo,
      v_n_of_v_n_e_right = v_n_of_v_n_e - v_n_e,
      v_n_of_v_n_e_left = v_n_of_v_n_e - v_n_of_v_n_e_right,
      v_n_of_v_n_e_left_rest = v_n_e - v_n_of_v_n_e_left,
      v_n_of_v_n_e_right_rest = v_n_e_lo - v_n_of_v_n_e_right,
      v_n_of_v_n_e_lo = v_n_of_v_n_e_left_rest + v_n_of_v_n_e_right_rest, v_n = sqrt(v_n_of_v_n_e),
      v_n_product = KSL_MUL(v_n, v_n), v_n_product_error = ksl_product_error(v_n, v_n, v_n_product),
      v_n_rest = v_n_of_v_n_e - v_n_product, v_n_exact = v_n_rest - v_n_product_error,
      v_n_residual = v_n_exact + v_n_of_v_n_e_lo, v_n_twice = v_n + v_n,
      v_n_divisor = v_n == 0.0 ? 1.0 : v_n_twice, v_n_lo = v_n_residual / v_n_divisor;
  const double v_r_b = v_s < 1.0 ? 2.6815615859885194e+154 : 1.0,
      v_r_d = 1.0 < v_s ? 7.637340908749012e-152 : v_r_b,
      v_r = 1.3093562431584567e+151 < v_s ? 9.332636185032189e-302 : v_r_d;
  const double n_of_v_n = v_n + v_n_lo, n_of_v_n_right = n_of_v_n - v_n,
      n_of_v_n_left = n_of_v_n - n_of_v_n_right, n_of_v_n_left_rest = v_n - n_of_v_n_left,
      n_of_v_n_right_rest = v_n_lo - n_of_v_n_right,
      n_of_v_n_lo = n_of_v_n_left_rest + n_of_v_n_right_rest, n = KSL_MUL(n_of_v_n, v_r),
      n_inverse = 1.0 / v_r, n_back = KSL_MUL(n, n_inverse), n_lost = n_of_v_n - n_back,
      n_rest = n_lost + n_of_v_n_lo, n_lo = KSL_MUL(n_rest, v_r);
  const double half_of_n = n + n_lo, half_of_n_right = half_of_n - n,
      half_of_n_left = half_of_n - half_of_n_right, half_of_n_left_rest = n - half_of_n_left,
      half_of_n_right_rest = n_lo - half_of_n_right,
      half_of_n_lo = half_of_n_left_rest + half_of_n_right_rest,
      half_of_upper_3 = upper_3 + upper_3_lo, half_of_upper_3_right = half_of_upper_3 - upper_3,
      half_of_upper_3_left = half_of_upper_3 - half_of_upper_3_right,
      half_of_upper_3_left_rest = upper_3 - half_of_upper_3_left,
      half_of_upper_3_right_rest = upper_3_lo - half_of_upper_3_right,
      half_of_upper_3_lo = half_of_upper_3_left_rest + half_of_upper_3_right_rest,
      half = ksl_atan2(half_of_n, half_of_upper_3),
      half_own_error = ksl_atan2_error(half_of_n, half_of_upper_3, half),
      half_size0 = fabs(half_of_n), half_size1 = fabs(half_of_upper_3),
      half_most = half_size0 < half_size1 ? half_size1 : half_size0,
      half_divisor = half_most == 0.0 ? 1.0 : half_most, half_part0 = half_of_n / half_divisor,
      half_part1 = half_of_upper_3 / half_divisor, half_cross1 = KSL_MUL(half_part1, half_of_n_lo),
      half_cross2 = KSL_MUL(half_part0, half_of_upper_3_lo),
      half_square1 = KSL_MUL(half_part1, half_part1),
      half_square2 = KSL_MUL(half_part0, half_part0), half_cross = half_cross1 - half_cross2,
      half_square = half_square1 + half_square2, half_divisor2 = KSL_MUL(half_divisor, half_square),
      half_safe = half_most == 0.0 ? 1.0 : half_divisor2, half_more = half_cross / half_safe,
      half_lo = half_own_error + half_more;
  const double divisor = half_of_n == 0.0 ? 1.0 : half_of_n,
      divisor_lo = half_of_n == 0.0 ? 0.0 : half_of_n_lo;
  const double rate_of_half = half + half_lo, rate_of_half_right = rate_of_half - half,
      rate_of_half_left = rate_of_half - rate_of_half_right,
      rate_of_half_left_rest = half - rate_of_half_left,
      rate_of_half_right_rest = half_lo - rate_of_half_right,
      rate_of_half_lo = rate_of_half_left_rest + rate_of_half_right_rest,
      rate_of_divisor = divisor + divisor_lo, rate_of_divisor_right = rate_of_divisor - divisor,
      rate_of_divisor_left = rate_of_divisor - rate_of_divisor_right,
      rate_of_divisor_left_rest = divisor - rate_of_divisor_left,
      rate_of_divisor_right_rest = divisor_lo - rate_of_divisor_right,
      rate_of_divisor_lo = rate_of_divisor_left_rest + rate_of_divisor_right_rest,
      rate = rate_of_half / rate_of_divisor, rate_product = KSL_MUL(rate, rate_of_divisor),
      rate_product_error = ksl_product_error(rate, rate_of_divisor, rate_product),
      rate_rest = rate_of_half - rate_product, rate_exact = rate_rest - rate_product_error,
      rate_numerator = rate_exact + rate_of_half_lo, rate_cross = KSL_MUL(rate, rate_of_divisor_lo),
      rate_residual = rate_numerator - rate_cross, rate_lo = rate_residual / rate_of_divisor;
  const double kv_0 = KSL_MUL(k, v_s_size_0_of_upper_0),
      kv_0_cross2 = KSL_MUL(k, v_s_size_0_of_upper_0_lo);
  const double kv_1 = KSL_MUL(k, v_s_size_1_of_upper_1),
      kv_1_cross2 = KSL_MUL(k, v_s_size_1_of_upper_1_lo);
  const double kv_2 = KSL_MUL(k, v_s_size_2_of_upper_2),
      kv_2_cross2 = KSL_MUL(k, v_s_size_2_of_upper_2_lo);
  const double kv_0_error = ksl_product_error(k, v_s_size_0_of_upper_0, kv_0),
      kv_0_lo = kv_0_error + kv_0_cross2, step_0 = KSL_MUL(rate, kv_0),
      step_0_cross1 = KSL_MUL(rate_lo, kv_0), step_0_cross2 = KSL_MUL(rate, kv_0_lo),
      step_0_cross = step_0_cross1 + step_0_cross2;
  const double kv_1_error = ksl_product_error(k, v_s_size_1_of_upper_1, kv_1),
      kv_1_lo = kv_1_error + kv_1_cross2, step_1 = KSL_MUL(rate, kv_1),
      step_1_cross1 = KSL_MUL(rate_lo, kv_1), step_1_cross2 = KSL_MUL(rate, kv_1_lo),
      step_1_cross = step_1_cross1 + step_1_cross2;
  const double kv_2_error = ksl_product_error(k, v_s_size_2_of_upper_2, kv_2),
      kv_2_lo = kv_2_error + kv_2_cross2, step_2 = KSL_MUL(rate, kv_2),
      step_2_cross1 = KSL_MUL(rate_lo, kv_2), step_2_cross2 = KSL_MUL(rate, kv_2_lo),
      step_2_cross = step_2_cross1 + step_2_cross2;
  const double step_0_error = ksl_product_error(rate, kv_0, step_0),
      step_0_lo = step_0_error + step_0_cross, exp_h_size_0_of_step_0 = step_0 + step_0_lo,
      exp_h_size_0_of_step_0_right = exp_h_size_0_of_step_0 - step_0,
      exp_h_size_0_of_step_0_left = exp_h_size_0_of_step_0 - exp_h_size_0_of_step_0_right,
      exp_h_size_0_of_step_0_left_rest = step_0 - exp_h_size_0_of_step_0_left,
      exp_h_size_0_of_step_0_right_rest = step_0_lo - exp_h_size_0_of_step_0_right,
      exp_h_size_0_of_step_0_lo = exp_h_size_0_of_step_0_left_rest +
          exp_h_size_0_of_step_0_right_rest,
      exp_h_size_0 = fabs(exp_h_size_0_of_step_0),
      exp_h_size_0_opposite = -exp_h_size_0_of_step_0_lo,
      exp_h_size_0_lo = exp_h_size_0_of_step_0 < 0.0 ? exp_h_size_0_opposite :
          exp_h_size_0_of_step_0_lo;
  const double step_1_error = ksl_product_error(rate, kv_1, step_1),
      step_1_lo = step_1_error + step_1_cross, exp_h_size_1_of_step_1 = step_1 + step_1_lo,
      exp_h_size_1_of_step_1_right = exp_h_size_1_of_step_1 - step_1,
      exp_h_size_1_of_step_1_left = exp_h_size_1_of_step_1 - exp_h_size_1_of_step_1_right,
      exp_h_size_1_of_step_1_left_rest = step_1 - exp_h_size_1_of_step_1_left,
      exp_h_size_1_of_step_1_right_rest = step_1_lo - exp_h_size_1_of_step_1_right,
      exp_h_size_1_of_step_1_lo = exp_h_size_1_of_step_1_left_rest +
          exp_h_size_1_of_step_1_right_rest,
      exp_h_size_1 = fabs(exp_h_size_1_of_step_1),
      exp_h_size_1_opposite = -exp_h_size_1_of_step_1_lo,
      exp_h_size_1_lo = exp_h_size_1_of_step_1 < 0.0 ? exp_h_size_1_opposite :
          exp_h_size_1_of_step_1_lo;
  const double step_2_error = ksl_product_error(rate, kv_2, step_2),
      step_2_lo = step_2_error + step_2_cross, exp_h_size_2_of_step_2 = step_2 + step_2_lo,
      exp_h_size_2_of_step_2_right = exp_h_size_2_of_step_2 - step_2,
      exp_h_size_2_of_step_2_left = exp_h_size_2_of_step_2 - exp_h_size_2_of_step_2_right,
      exp_h_size_2_of_step_2_left_rest = step_2 - exp_h_size_2_of_step_2_left,
      exp_h_size_2_of_step_2_right_rest = step_2_lo - exp_h_size_2_of_step_2_right,
      exp_h_size_2_of_step_2_lo = exp_h_size_2_of_step_2_left_rest +
          exp_h_size_2_of_step_2_right_rest,
      exp_h_size_2 = fabs(exp_h_size_2_of_step_2),
      exp_h_size_2_opposite = -exp_h_size_2_of_step_2_lo,
      exp_h_size_2_lo = exp_h_size_2_of_step_2 < 0.0 ? exp_h_size_2_opposite :
          exp_h_size_2_of_step_2_lo;
  const double exp_h_largest1a_of_exp_h_size_0 = exp_h_size_0 + exp_h_size_0_lo,
      exp_h_largest1a_of_exp_h_size_0_right = exp_h_largest1a_of_exp_h_size_0 - exp_h_size_0,
      exp_h_largest1a_of_exp_h_size_0_left = exp_h_largest1a_of_exp_h_size_0 -
          exp_h_largest1a_of_exp_h_size_0_right,
      exp_h_largest1a_of_exp_h_size_0_left_rest = exp_h_size_0 -
          exp_h_largest1a_of_exp_h_size_0_left,
      exp_h_largest1a_of_exp_h_size_0_right_rest = exp_h_size_0_lo -
          exp_h_largest1a_of_exp_h_size_0_right,
      exp_h_largest1a_of_exp_h_size_0_lo = exp_h_largest1a_of_exp_h_size_0_left_rest +
          exp_h_largest1a_of_exp_h_size_0_right_rest,
      exp_h_largest1a_of_exp_h_size_1 = exp_h_size_1 + exp_h_size_1_lo,
      exp_h_largest1a_of_exp_h_size_1_right = exp_h_largest1a_of_exp_h_size_1 - exp_h_size_1,
      exp_h_largest1a_of_exp_h_size_1_left = exp_h_largest1a_of_exp_h_size_1 -
          exp_h_largest1a_of_exp_h_size_1_right,
      exp_h_largest1a_of_exp_h_size_1_left_rest = exp_h_size_1 -
          exp_h_largest1a_of_exp_h_size_1_left,
      exp_h_largest1a_of_exp_h_size_1_right_rest = exp_h_size_1_lo -
          exp_h_largest1a_of_exp_h_size_1_right,
      exp_h_largest1a_of_exp_h_size_1_lo = exp_h_largest1a_of_exp_h_size_1_left_rest +
          exp_h_largest1a_of_exp_h_size_1_right_rest,
      exp_h_largest1 = exp_h_largest1a_of_exp_h_size_0 < exp_h_largest1a_of_exp_h_size_1 ?
          exp_h_largest1a_of_exp_h_size_1 : exp_h_largest1a_of_exp_h_size_0,
      exp_h_largest1_lo = exp_h_largest1a_of_exp_h_size_0 < exp_h_largest1a_of_exp_h_size_1 ?
          exp_h_largest1a_of_exp_h_size_1_lo : exp_h_largest1a_of_exp_h_size_0_lo;
  const double exp_h_largest2a_of_exp_h_largest1 = exp_h_largest1 + exp_h_largest1_lo,
      exp_h_largest2a_of_exp_h_largest1_right = exp_h_largest2a_of_exp_h_largest1 - exp_h_largest1,
      exp_h_largest2a_of_exp_h_largest1_left = exp_h_largest2a_of_exp_h_largest1 -
          exp_h_largest2a_of_exp_h_largest1_right,
      exp_h_largest2a_of_exp_h_largest1_left_rest = exp_h_largest1 -
          exp_h_largest2a_of_exp_h_largest1_left,
      exp_h_largest2a_of_exp_h_largest1_right_rest = exp_h_largest1_lo -
          exp_h_largest2a_of_exp_h_largest1_right,
      exp_h_largest2a_of_exp_h_largest1_lo = exp_h_largest2a_of_exp_h_largest1_left_rest +
          exp_h_largest2a_of_exp_h_largest1_right_rest,
      exp_h_largest2a_of_exp_h_size_2 = exp_h_size_2 + exp_h_size_2_lo,
      exp_h_largest2a_of_exp_h_size_2_right = exp_h_largest2a_of_exp_h_size_2 - exp_h_size_2,
      exp_h_largest2a_of_exp_h_size_2_left = exp_h_largest2a_of_exp_h_size_2 -
          exp_h_largest2a_of_exp_h_size_2_right,
      exp_h_largest2a_of_exp_h_size_2_left_rest = exp_h_size_2 -
          exp_h_largest2a_of_exp_h_size_2_left,
      exp_h_largest2a_of_exp_h_size_2_right_rest = exp_h_size_2_lo -
          exp_h_largest2a_of_exp_h_size_2_right,
      exp_h_largest2a_of_exp_h_size_2_lo = exp_h_largest2a_of_exp_h_size_2_left_rest +
          exp_h_largest2a_of_exp_h_size_2_right_rest,
      exp_h_largest2 = exp_h_largest2a_of_exp_h_largest1 < exp_h_largest2a_of_exp_h_size_2 ?
          exp_h_largest2a_of_exp_h_size_2 : exp_h_largest2a_of_exp_h_largest1,
      exp_h_largest2_lo = exp_h_largest2a_of_exp_h_largest1 < exp_h_largest2a_of_exp_h_size_2 ?
          exp_h_largest2a_of_exp_h_size_2_lo : exp_h_largest2a_of_exp_h_largest1_lo;
  const double exp_s_a_of_exp_h_largest2 = exp_h_largest2 + exp_h_largest2_lo,
      exp_s = 6.703903964971299e+153 < exp_s_a_of_exp_h_largest2 ? 3.7291703656001034e-155 : 1.0;
  const double exp_reduced_0 = KSL_MUL(exp_h_size_0_of_step_0, exp_s),
      exp_reduced_0_inverse = 1.0 / exp_s,
      exp_reduced_0_back = KSL_MUL(exp_reduced_0, exp_reduced_0_inverse),
      exp_reduced_0_lost = exp_h_size_0_of_step_0 - exp_reduced_0_back,
      exp_reduced_0_rest = exp_reduced_0_lost + exp_h_size_0_of_step_0_lo,
      exp_reduced_0_lo = KSL_MUL(exp_reduced_0_rest, exp_s);
  const double exp_reduced_1 = KSL_MUL(exp_h_size_1_of_step_1, exp_s),
      exp_reduced_1_back = KSL_MUL(exp_reduced_1, exp_reduced_0_inverse),
      exp_reduced_1_lost = exp_h_size_1_of_step_1 - exp_reduced_1_back,
      exp_reduced_1_rest = exp_reduced_1_lost + exp_h_size_1_of_step_1_lo,
      exp_reduced_1_lo = KSL_MUL(exp_reduced_1_rest, exp_s);
  const double exp_reduced_2 = KSL_MUL(exp_h_size_2_of_step_2, exp_s),
      exp_reduced_2_back = KSL_MUL(exp_reduced_2, exp_reduced_0_inverse),
      exp_reduced_2_lost = exp_h_size_2_of_step_2 - exp_reduced_2_back,
      exp_reduced_2_rest = exp_reduced_2_lost + exp_h_size_2_of_step_2_lo,
      exp_reduced_2_lo = KSL_MUL(exp_reduced_2_rest, exp_s);
  const double exp_up = exp_s < 1.0 ? 2.6815615859885194e+154 : 1.0;
  const double exp_reduced_length_a = KSL_MUL(exp_reduced_0, exp_reduced_0),
      exp_reduced_length_a_cross1 = KSL_MUL(exp_reduced_0_lo, exp_reduced_0),
      exp_reduced_length_a_cross2 = KSL_MUL(exp_reduced_0, exp_reduced_0_lo),
      exp_reduced_length_a_cross = exp_reduced_length_a_cross1 + exp_reduced_length_a_cross2,
      exp_reduced_length_b = KSL_MUL(exp_reduced_1, exp_reduced_1),
      exp_reduced_length_b_cross1 = KSL_MUL(exp_reduced_1_lo, exp_reduced_1),
      exp_reduced_length_b_cross2 = KSL_MUL(exp_reduced_1, exp_reduced_1_lo),
      exp_reduced_length_b_cross = exp_reduced_length_b_cross1 + exp_reduced_length_b_cross2,
      exp_reduced_length_c = exp_reduced_length_a + exp_reduced_length_b,
      exp_reduced_length_c_right = exp_reduced_length_c - exp_reduced_length_a,
      exp_reduced_length_c_left = exp_reduced_length_c - exp_reduced_length_c_right,
      exp_reduced_length_c_left_rest = ksl_product_rest(exp_reduced_0, exp_reduced_0,
          exp_reduced_length_a, exp_reduced_length_c_left),
      exp_reduced_length_c_right_rest = ksl_product_rest(exp_reduced_1, exp_reduced_1,
          exp_reduced_length_b, exp_reduced_length_c_right),
      exp_reduced_length_c_cross = exp_reduced_length_a_cross + exp_reduced_length_b_cross,
      exp_reduced_length_c_lo1 = exp_reduced_length_c_left_rest + exp_reduced_length_c_right_rest,
      exp_reduced_length_c_lo = exp_reduced_length_c_lo1 + exp_reduced_length_c_cross,
      exp_reduced_length_d = KSL_MUL(exp_reduced_2, exp_reduced_2),
      exp_reduced_length_d_cross1 = KSL_MUL(exp_reduced_2_lo, exp_reduced_2),
      exp_reduced_length_d_cross2 = KSL_MUL(exp_reduced_2, exp_reduced_2_lo),
      exp_reduced_length_d_cross = exp_reduced_length_d_cross1 + exp_reduced_length_d_cross2,
      exp_reduced_length_e = exp_reduced_length_c + exp_reduced_length_d,
      exp_reduced_length_e_right = exp_reduced_length_e - exp_reduced_length_c,
      exp_reduced_length_e_left = exp_reduced_length_e - exp_reduced_length_e_right,
      exp_reduced_length_e_left_rest = exp_reduced_length_c - exp_reduced_length_e_left,
      exp_reduced_length_e_right_rest = ksl_product_rest(exp_reduced_2, exp_reduced_2,
          exp_reduced_length_d, exp_reduced_length_e_right),
      exp_reduced_length_e_lo1 = exp_reduced_length_e_left_rest + exp_reduced_length_e_right_rest,
      exp_reduced_length_e_lo2 = exp_reduced_length_e_lo1 + exp_reduced_length_d_cross,
      exp_reduced_length_e_lo = exp_reduced_length_e_lo2 + exp_reduced_length_c_lo,
      exp_reduced_length_of_exp_reduced_length_e = exp_reduced_length_e + exp_reduced_length_e_lo,
      exp_reduced_length_of_exp_reduced_length_e_right = exp_reduced_length_of_exp_reduced_length_e
          - exp_reduced_length_e,
      exp_reduced_length_of_exp_reduced_length_e_left = exp_reduced_length_of_exp_reduced_length_e -
          exp_reduced_length_of_exp_reduced_length_e_right,
      exp_reduced_length_of_exp_reduced_length_e_left_rest = exp_reduced_length_e -
          exp_reduced_length_of_exp_reduced_length_e_left,
      exp_reduced_length_of_exp_reduced_length_e_right_rest = exp_reduced_length_e_lo -
          exp_reduced_length_of_exp_reduced_length_e_right,
      exp_reduced_length_of_exp_reduced_length_e_lo =
          exp_reduced_length_of_exp_reduced_length_e_left_rest +
          exp_reduced_length_of_exp_reduced_length_e_right_rest,
      exp_reduced_length = sqrt(exp_reduced_length_of_exp_reduced_length_e),
      exp_reduced_length_product = KSL_MUL(exp_reduced_length, exp_reduced_length),
      exp_reduced_length_product_error = ksl_product_error(exp_reduced_length, exp_reduced_length,
          exp_reduced_length_product),
      exp_reduced_length_rest = exp_reduced_length_of_exp_reduced_length_e -
          exp_reduced_length_product,
      exp_reduced_length_exact = exp_reduced_length_rest - exp_reduced_length_product_error,
      exp_reduced_length_residual = exp_reduced_length_exact +
          exp_reduced_length_of_exp_reduced_length_e_lo,
      exp_reduced_length_twice = exp_reduced_length + exp_reduced_length,
      exp_reduced_length_divisor = exp_reduced_length == 0.0 ? 1.0 : exp_reduced_length_twice,
      exp_reduced_length_lo = exp_reduced_length_residual / exp_reduced_length_divisor;
  const double exp_half_angle_of_exp_reduced_length = exp_reduced_length + exp_reduced_length_lo,
      exp_half_angle_of_exp_reduced_length_right = exp_half_angle_of_exp_reduced_length -
          exp_reduced_length,
      exp_half_angle_of_exp_reduced_length_left = exp_half_angle_of_exp_reduced_length -
          exp_half_angle_of_exp_reduced_length_right,
      exp_half_angle_of_exp_reduced_length_left_rest = exp_reduced_length -
          exp_half_angle_of_exp_reduced_length_left,
      exp_half_angle_of_exp_reduced_length_right_rest = exp_reduced_length_lo -
          exp_half_angle_of_exp_reduced_length_right,
      exp_half_angle_of_exp_reduced_length_lo = exp_half_angle_of_exp_reduced_length_left_rest +
          exp_half_angle_of_exp_reduced_length_right_rest,
      exp_half_angle = KSL_MUL(exp_half_angle_of_exp_reduced_length, exp_up),
      exp_half_angle_inverse = 1.0 / exp_up,
      exp_half_angle_back = KSL_MUL(exp_half_angle, exp_half_angle_inverse),
      exp_half_angle_lost = exp_half_angle_of_exp_reduced_length - exp_half_angle_back,
      exp_half_angle_rest = exp_half_angle_lost + exp_half_angle_of_exp_reduced_length_lo,
      exp_half_angle_lo = KSL_MUL(exp_half_angle_rest, exp_up);
  const double exp_y = KSL_MUL(exp_half_angle, exp_half_angle),
      exp_y_cross1 = KSL_MUL(exp_half_angle_lo, exp_half_angle),
      exp_y_cross2 = KSL_MUL(exp_half_angle, exp_half_angle_lo),
      exp_y_cross = exp_y_cross1 + exp_y_cross2;
  const double exp_sine_of_exp_half_angle = exp_half_angle + exp_half_angle_lo,
      exp_sine_of_exp_half_angle_right = exp_sine_of_exp_half_angle - exp_half_angle,
      exp_sine_of_exp_half_angle_left = exp_sine_of_exp_half_angle -
          exp_sine_of_exp_half_angle_right,
      exp_sine_of_exp_half_angle_left_rest = exp_half_angle - exp_sine_of_exp_half_angle_left,
      exp_sine_of_exp_half_angle_right_rest = exp_half_angle_lo - exp_sine_of_exp_half_angle_right,
      exp_sine_of_exp_half_angle_lo = exp_sine_of_exp_half_angle_left_rest +
          exp_sine_of_exp_half_angle_right_rest;
  double exp_c; const double exp_sine = ksl_sincos(exp_sine_of_exp_half_angle, &exp_c);
  double exp_c_own_error; const double exp_sine_own_error =
      ksl_sincos_error(exp_sine_of_exp_half_angle, exp_sine, exp_c, &exp_c_own_error);
  const double exp_sine_half = KSL_MUL(exp_sine_of_exp_half_angle_lo, 0.5);
  double exp_sine_half_cos; const double exp_sine_half_sin = ksl_sincos(exp_sine_half,
      &exp_sine_half_cos);
  const double exp_sine_twice = exp_sine_half_sin + exp_sine_half_sin,
      exp_sine_slope1 = KSL_MUL(exp_sine_half_cos, exp_c),
      exp_sine_slope2 = KSL_MUL(exp_sine_half_sin, exp_sine),
      exp_sine_slope = exp_sine_slope1 - exp_sine_slope2,
      exp_sine_more = KSL_MUL(exp_sine_slope, exp_sine_twice),
      exp_sine_lo = exp_sine_own_error + exp_sine_more;
  const double exp_c_slope1 = KSL_MUL(exp_sine_half_cos, exp_sine),
      exp_c_slope2 = KSL_MUL(exp_sine_half_sin, exp_c), exp_c_slope = exp_c_slope1 + exp_c_slope2,
      exp_c_more = KSL_MUL(exp_c_slope, exp_sine_twice), exp_c_lo = exp_c_own_error - exp_c_more;
  const double exp_sinc_divisor = exp_sine_of_exp_half_angle < 1.4901161193847656e-08 ?
      1.4901161193847656e-08 : exp_sine_of_exp_half_angle,
      exp_sinc_divisor_lo = exp_sine_of_exp_half_angle < 1.4901161193847656e-08 ? 0.0 :
          exp_sine_of_exp_half_angle_lo;
  const double exp_sinc_quotient_of_exp_sine = exp_sine + exp_sine_lo,
      exp_sinc_quotient_of_exp_sine_right = exp_sinc_quotient_of_exp_sine - exp_sine,
      exp_sinc_quotient_of_exp_sine_left = exp_sinc_quotient_of_exp_sine -
          exp_sinc_quotient_of_exp_sine_right,
      exp_sinc_quotient_of_exp_sine_left_rest = exp_sine - exp_sinc_quotient_of_exp_sine_left,
      exp_sinc_quotient_of_exp_sine_right_rest = exp_sine_lo - exp_sinc_quotient_of_exp_sine_right,
      exp_sinc_quotient_of_exp_sine_lo = exp_sinc_quotient_of_exp_sine_left_rest +
          exp_sinc_quotient_of_exp_sine_right_rest,
      exp_sinc_quotient_of_exp_sinc_divisor = exp_sinc_divisor + exp_sinc_divisor_lo,
      exp_sinc_quotient_of_exp_sinc_divisor_right = exp_sinc_quotient_of_exp_sinc_divisor -
          exp_sinc_divisor,
      exp_sinc_quotient_of_exp_sinc_divisor_left = exp_sinc_quotient_of_exp_sinc_divisor -
          exp_sinc_quotient_of_exp_sinc_divisor_right,
      exp_sinc_quotient_of_exp_sinc_divisor_left_rest = exp_sinc_divisor -
          exp_sinc_quotient_of_exp_sinc_divisor_left,
      exp_sinc_quotient_of_exp_sinc_divisor_right_rest = exp_sinc_divisor_lo -
          exp_sinc_quotient_of_exp_sinc_divisor_right,
      exp_sinc_quotient_of_exp_sinc_divisor_lo = exp_sinc_quotient_of_exp_sinc_divisor_left_rest +
          exp_sinc_quotient_of_exp_sinc_divisor_right_rest,
      exp_sinc_quotient = exp_sinc_quotient_of_exp_sine / exp_sinc_quotient_of_exp_sinc_divisor,
      exp_sinc_quotient_product = KSL_MUL(exp_sinc_quotient, exp_sinc_quotient_of_exp_sinc_divisor),
      exp_sinc_quotient_product_error = ksl_product_error(exp_sinc_quotient,
          exp_sinc_quotient_of_exp_sinc_divisor, exp_sinc_quotient_product),
      exp_sinc_quotient_rest = exp_sinc_quotient_of_exp_sine - exp_sinc_quotient_product,
      exp_sinc_quotient_exact = exp_sinc_quotient_rest - exp_sinc_quotient_product_error,
      exp_sinc_quotient_numerator = exp_sinc_quotient_exact + exp_sinc_quotient_of_exp_sine_lo,
      exp_sinc_quotient_cross = KSL_MUL(exp_sinc_quotient,
          exp_sinc_quotient_of_exp_sinc_divisor_lo),
      exp_sinc_quotient_residual = exp_sinc_quotient_numerator - exp_sinc_quotient_cross,
      exp_sinc_quotient_lo = exp_sinc_quotient_residual / exp_sinc_quotient_of_exp_sinc_divisor;
  const double exp_y_error = ksl_product_error(exp_half_angle, exp_half_angle, exp_y),
      exp_y_lo = exp_y_error + exp_y_cross, exp_sinc_a = KSL_MUL(0.16666666666666666, exp_y),
      exp_sinc_a_cross1 = KSL_MUL(9.25185853854297e-18, exp_y),
      exp_sinc_a_cross2 = KSL_MUL(0.16666666666666666, exp_y_lo),
      exp_sinc_a_cross = exp_sinc_a_cross1 + exp_sinc_a_cross2, exp_sinc_b = 1.0 - exp_sinc_a,
      exp_sinc_b_right = 1.0 - exp_sinc_b, exp_sinc_b_left = exp_sinc_b + exp_sinc_b_right,
      exp_sinc_b_left_rest = 1.0 - exp_sinc_b_left,
      exp_sinc_b_right_rest = ksl_product_rest(0.16666666666666666, exp_y, exp_sinc_a,
          exp_sinc_b_right),
      exp_sinc_b_lo1 = exp_sinc_b_left_rest - exp_sinc_b_right_rest,
      exp_sinc_b_lo = exp_sinc_b_lo1 - exp_sinc_a_cross,
      exp_sinc = exp_sine_of_exp_half_angle < 1.4901161193847656e-08 ? exp_sinc_b :
          exp_sinc_quotient,
      exp_sinc_lo = exp_sine_of_exp_half_angle < 1.4901161193847656e-08 ? exp_sinc_b_lo :
          exp_sinc_quotient_lo;
  const double power_0 = KSL_MUL(exp_h_size_0_of_step_0, exp_sinc),
      power_0_cross1 = KSL_MUL(exp_h_size_0_of_step_0_lo, exp_sinc),
      power_0_cross2 = KSL_MUL(exp_h_size_0_of_step_0, exp_sinc_lo),
      power_0_cross = power_0_cross1 + power_0_cross2;
  const double power_1 = KSL_MUL(exp_h_size_1_of_step_1, exp_sinc),
      power_1_cross1 = KSL_MUL(exp_h_size_1_of_step_1_lo, exp_sinc),
      power_1_cross2 = KSL_MUL(exp_h_size_1_of_step_1, exp_sinc_lo),
      power_1_cross = power_1_cross1 + power_1_cross2;
  const double power_2 = KSL_MUL(exp_h_size_2_of_step_2, exp_sinc),
      power_2_cross1 = KSL_MUL(exp_h_size_2_of_step_2_lo, exp_sinc),
      power_2_cross2 = KSL_MUL(exp_h_size_2_of_step_2, exp_sinc_lo),
      power_2_cross = power_2_cross1 + power_2_cross2;
  const double qo_0a = KSL_MUL(q1->x, exp_c), qo_0a_cross2 = KSL_MUL(q1->x, exp_c_lo),
      power_2_error = ksl_product_error(exp_h_size_2_of_step_2, exp_sinc, power_2),
      power_2_lo = power_2_error + power_2_cross, qo_0b = KSL_MUL(q1->y, power_2),
      qo_0b_cross2 = KSL_MUL(q1->y, power_2_lo),
      power_1_error = ksl_product_error(exp_h_size_1_of_step_1, exp_sinc, power_1),
      power_1_lo = power_1_error + power_1_cross, qo_0c = KSL_MUL(q1->z, power_1),
      qo_0c_cross2 = KSL_MUL(q1->z, power_1_lo), qo_0d = qo_0b - qo_0c, qo_0d_right = qo_0b - qo_0d,
      qo_0d_left = qo_0d + qo_0d_right,
      qo_0d_left_rest = ksl_product_rest(q1->y, power_2, qo_0b, qo_0d_left),
      qo_0d_right_rest = ksl_product_rest(q1->z, power_1, qo_0c, qo_0d_right),
      qo_0d_cross = qo_0b_cross2 - qo_0c_cross2, qo_0d_lo1 = qo_0d_left_rest - qo_0d_right_rest,
      qo_0d_lo = qo_0d_lo1 + qo_0d_cross, qo_0e = qo_0a + qo_0d, qo_0e_right = qo_0e - qo_0a,
      qo_0e_left = qo_0e - qo_0e_right,
      qo_0e_left_rest = ksl_product_rest(q1->x, exp_c, qo_0a, qo_0e_left),
      qo_0e_right_rest = qo_0d - qo_0e_right, qo_0e_lo1 = qo_0e_left_rest + qo_0e_right_rest,
      qo_0e_lo2 = qo_0e_lo1 + qo_0d_lo, qo_0e_lo = qo_0e_lo2 + qo_0a_cross2,
      power_0_error = ksl_product_error(exp_h_size_0_of_step_0, exp_sinc, power_0),
      power_0_lo = power_0_error + power_0_cross, qo_0f = KSL_MUL(q1->w, power_0),
      qo_0f_cross2 = KSL_MUL(q1->w, power_0_lo), qo_0 = qo_0e + qo_0f, qo_0_right = qo_0 - qo_0e,
      qo_0_left = qo_0 - qo_0_right, qo_0_left_rest = qo_0e - qo_0_left,
      qo_0_right_rest = ksl_product_rest(q1->w, power_0, qo_0f, qo_0_right),
      qo_0_lo1 = qo_0_left_rest + qo_0_right_rest, qo_0_lo2 = qo_0_lo1 + qo_0f_cross2,
      qo_0_lo = qo_0_lo2 + qo_0e_lo;
  const double qo_1a = KSL_MUL(q1->z, power_0), qo_1a_cross2 = KSL_MUL(q1->z, power_0_lo),
      qo_1b = KSL_MUL(q1->x, power_2), qo_1b_cross2 = KSL_MUL(q1->x, power_2_lo),
      qo_1c = qo_1a - qo_1b, qo_1c_right = qo_1a - qo_1c, qo_1c_left = qo_1c + qo_1c_right,
      qo_1c_left_rest = ksl_product_rest(q1->z, power_0, qo_1a, qo_1c_left),
      qo_1c_right_rest = ksl_product_rest(q1->x, power_2, qo_1b, qo_1c_right),
      qo_1c_cross = qo_1a_cross2 - qo_1b_cross2, qo_1c_lo1 = qo_1c_left_rest - qo_1c_right_rest,
      qo_1c_lo = qo_1c_lo1 + qo_1c_cross, qo_1d = KSL_MUL(q1->y, exp_c),
      qo_1d_cross2 = KSL_MUL(q1->y, exp_c_lo), qo_1e = qo_1c + qo_1d, qo_1e_right = qo_1e - qo_1c,
      qo_1e_left = qo_1e - qo_1e_right, qo_1e_left_rest = qo_1c - qo_1e_left,
      qo_1e_right_rest = ksl_product_rest(q1->y, exp_c, qo_1d, qo_1e_right),
      qo_1e_lo1 = qo_1e_left_rest + qo_1e_right_rest, qo_1e_lo2 = qo_1e_lo1 + qo_1d_cross2,
      qo_1e_lo = qo_1e_lo2 + qo_1c_lo, qo_1f = KSL_MUL(q1->w, power_1),
      qo_1f_cross2 = KSL_MUL(q1->w, power_1_lo), qo_1 = qo_1e + qo_1f, qo_1_right = qo_1 - qo_1e,
      qo_1_left = qo_1 - qo_1_right, qo_1_left_rest = qo_1e - qo_1_left,
      qo_1_right_rest = ksl_product_rest(q1->w, power_1, qo_1f, qo_1_right),
      qo_1_lo1 = qo_1_left_rest + qo_1_right_rest, qo_1_lo2 = qo_1_lo1 + qo_1f_cross2,
      qo_1_lo = qo_1_lo2 + qo_1e_lo;
  const double qo_2a = KSL_MUL(q1->x, power_1), qo_2a_cross2 = KSL_MUL(q1->x, power_1_lo),
      qo_2b = KSL_MUL(q1->y, power_0), qo_2b_cross2 = KSL_MUL(q1->y, power_0_lo),
      qo_2c = qo_2a - qo_2b, qo_2c_right = qo_2a - qo_2c, qo_2c_left = qo_2c + qo_2c_right,
      qo_2c_left_rest = ksl_product_rest(q1->x, power_1, qo_2a, qo_2c_left),
      qo_2c_right_rest = ksl_product_rest(q1->y, power_0, qo_2b, qo_2c_right),
      qo_2c_cross = qo_2a_cross2 - qo_2b_cross2, qo_2c_lo1 = qo_2c_left_rest - qo_2c_right_rest,
      qo_2c_lo = qo_2c_lo1 + qo_2c_cross, qo_2d = KSL_MUL(q1->z, exp_c),
      qo_2d_cross2 = KSL_MUL(q1->z, exp_c_lo), qo_2e = qo_2c + qo_2d, qo_2e_right = qo_2e - qo_2c,
      qo_2e_left = qo_2e - qo_2e_right, qo_2e_left_rest = qo_2c - qo_2e_left,
      qo_2e_right_rest = ksl_product_rest(q1->z, exp_c, qo_2d, qo_2e_right),
      qo_2e_lo1 = qo_2e_left_rest + qo_2e_right_rest, qo_2e_lo2 = qo_2e_lo1 + qo_2d_cross2,
      qo_2e_lo = qo_2e_lo2 + qo_2c_lo, qo_2f = KSL_MUL(q1->w, power_2),
      qo_2f_cross2 = KSL_MUL(q1->w, power_2_lo), qo_2 = qo_2e + qo_2f, qo_2_right = qo_2 - qo_2e,
      qo_2_left = qo_2 - qo_2_right, qo_2_left_rest = qo_2e - qo_2_left,
      qo_2_right_rest = ksl_product_rest(q1->w, power_2, qo_2f, qo_2_right),
      qo_2_lo1 = qo_2_left_rest + qo_2_right_rest, qo_2_lo2 = qo_2_lo1 + qo_2f_cross2,
      qo_2_lo = qo_2_lo2 + qo_2e_lo;
  const double qo_3a = KSL_MUL(q1->w, exp_c), qo_3a_cross2 = KSL_MUL(q1->w, exp_c_lo),
      qo_3b = KSL_MUL(q1->x, power_0), qo_3b_cross2 = KSL_MUL(q1->x, power_0_lo),
      qo_3c = KSL_MUL(q1->y, power_1), qo_3c_cross2 = KSL_MUL(q1->y, power_1_lo),
      qo_3d = qo_3b + qo_3c, qo_3d_right = qo_3d - qo_3b, qo_3d_left = qo_3d - qo_3d_right,
      qo_3d_left_rest = ksl_product_rest(q1->x, power_0, qo_3b, qo_3d_left),
      qo_3d_right_rest = ksl_product_rest(q1->y, power_1, qo_3c, qo_3d_right),
      qo_3d_cross = qo_3b_cross2 + qo_3c_cross2, qo_3d_lo1 = qo_3d_left_rest + qo_3d_right_rest,
      qo_3d_lo = qo_3d_lo1 + qo_3d_cross, qo_3e = KSL_MUL(q1->z, power_2),
      qo_3e_cross2 = KSL_MUL(q1->z, power_2_lo), qo_3f = qo_3d + qo_3e, qo_3f_right = qo_3f - qo_3d,
      qo_3f_left = qo_3f - qo_3f_right, qo_3f_left_rest = qo_3d - qo_3f_left,
      qo_3f_right_rest = ksl_product_rest(q1->z, power_2, qo_3e, qo_3f_right),
      qo_3f_lo1 = qo_3f_left_rest + qo_3f_right_rest, qo_3f_lo2 = qo_3f_lo1 + qo_3e_cross2,
      qo_3f_lo = qo_3f_lo2 + qo_3d_lo, qo_3 = qo_3a - qo_3f, qo_3_right = qo_3a - qo_3,
      qo_3_left = qo_3 + qo_3_right,
      qo_3_left_rest = ksl_product_rest(q1->w, exp_c, qo_3a, qo_3_left),
      qo_3_right_rest = qo_3f - qo_3_right, qo_3_lo1 = qo_3_left_rest - qo_3_right_rest,
      qo_3_lo2 = qo_3_lo1 - qo_3f_lo, qo_3_lo = qo_3_lo2 + qo_3a_cross2;
  const double qo_0_rounded = qo_0 + qo_0_lo,
      qo_0_final = qo_0_rounded == qo_0_rounded ? qo_0_rounded : qo_0;
  const double qo_1_rounded = qo_1 + qo_1_lo,
      qo_1_final = qo_1_rounded == qo_1_rounded ? qo_1_rounded : qo_1;
  const double qo_2_rounded = qo_2 + qo_2_lo,
      qo_2_final = qo_2_rounded == qo_2_rounded ? qo_2_rounded : qo_2;
  const double qo_3_rounded = qo_3 + qo_3_lo,
      qo_3_final = qo_3_rounded == qo_3_rounded ? qo_3_rounded : qo_3;
  qo->x = qo_0_final;
  qo->y = qo_1_final;
  qo->z = qo_2_final;
  qo->w = qo_3_final;
}

/* self = a self.
   self: quaternion (x, y, z, w), the scalar last; a: number.
   4 mul.
   Error <= u |result| + 1/32 u^2 S, S the sum of the |terms| of the expanded formula; barring
     over- and underflow. */
static inline void ksl_quaternionf_scale_accurate(ksl_quaternionf_t *self, const float a) {
  const double self_0_new = (double)self->x * (double)a;
  const double self_1_new = (double)self->y * (double)a;
  const double self_2_new = (double)self->z * (double)a;
  const double self_3_new = (double)self->w * (double)a;
  self->x = (float)self_0_new;
  self->y = (float)self_1_new;
  self->z = (float)self_2_new;
  self->w = (float)self_3_new;
}

/* y = a x + y.
   a: number; x, y: quaternion (x, y, z, w), the scalar last.
   4 mul, 4 add.
   Error <= u |result| + 1/16 u^2 S, S the sum of the |terms| of the expanded formula; barring
     over- and underflow. */
static inline void ksl_axpy_qqf_accurate(const float a, const ksl_quaternionf_t *x,
    ksl_quaternionf_t *y) {
  const double y_0_new = ksl_product_sum((double)a, (double)x->x, (double)y->x);
  const double y_1_new = ksl_product_sum((double)a, (double)x->y, (double)y->y);
  const double y_2_new = ksl_product_sum((double)a, (double)x->z, (double)y->z);
  const double y_3_new = ksl_product_sum((double)a, (double)x->w, (double)y->w);
  y->x = (float)y_0_new;
  y->y = (float)y_1_new;
  y->z = (float)y_2_new;
  y->w = (float)y_3_new;
}

/* |q| = sqrt(v·v + w^2).
   q: quaternion (x, y, z, w), the scalar last.
   9 mul, 3 add, 1 sqrt, 4 abs, 9 less, 9 select.
   Each component is within 1 ulp as long as its condition is below 1e13; in single precision it
     is the nearest number, except near ties, as long as that is below 1e5; searched, not proved. */
static inline float ksl_quaternionf_norm_accurate(const ksl_quaternionf_t *q) {
  const double s_size_0 = fabs((double)q->x);
  const double s_size_1 = fabs((double)q->y);
  const double s_size_2 = fabs((double)q->z);
  const double s_size_3 = fabs((double)q->w);
  const double s_largest1 = s_size_0 < s_size_1 ? s_size_1 : s_size_0;
  const double s_largest2 = s_largest1 < s_size_2 ? s_size_2 : s_largest1;
  const double s_largest3 = s_largest2 < s_size_3 ? s_size_3 : s_largest2;
  const double s_b = 4.611686018427388e+18 < s_largest3 ? 2.710505431213761e-20 : 1.0,
      s_d = s_largest3 < 256.0 ? 1.8014398509481984e+16 : s_b,
      s = s_largest3 < 1.4210854715202004e-14 ? 3.2451855365842673e+32 : s_d;
  const double y_0 = KSL_MUL((double)q->x, s);
  const double y_1 = KSL_MUL((double)q->y, s);
  const double y_2 = KSL_MUL((double)q->z, s);
  const double y_3 = KSL_MUL((double)q->w, s);
  const double n_a = KSL_MUL(y_0, y_0), n_b = KSL_MUL(y_1, y_1), n_c = n_a + n_b,
      n_d = KSL_MUL(y_2, y_2), n_e = n_c + n_d, n_f = KSL_MUL(y_3, y_3), n_g = n_e + n_f,
      n = sqrt(n_g);
  const double r_b = s < 1.0 ? 3.6893488147419103e+19 : 1.0,
      r_d = 1.0 < s ? 5.551115123125783e-17 : r_b,
      r = 1.8014398509481984e+16 < s ? 3.0814879110195774e-33 : r_d;
  const double norm = KSL_MUL(n, r);
  return (float)norm;
}

/* self = self / |self|; zero stays zero.
   self: quaternion (x, y, z, w), the scalar last.
   16 mul, 3 add, 4 div, 1 sqrt, 4 abs, 8 less, 1 equal, 9 select.
   Each component is within 1 ulp as long as its condition is below 1e13; in single precision it
     is the nearest number, except near ties, as long as that is below 1e5; searched, not proved. */
static inline void ksl_quaternionf_normalize_accurate(ksl_quaternionf_t *self) {
  const double s_size_0 = fabs((double)self->x);
  const double s_size_1 = fabs((double)self->y);
  const double s_size_2 = fabs((double)self->z);
  const double s_size_3 = fabs((double)self->w);
  const double s_largest1 = s_size_0 < s_size_1 ? s_size_1 : s_size_0;
  const double s_largest2 = s_largest1 < s_size_2 ? s_size_2 : s_largest1;
  const double s_largest3 = s_largest2 < s_size_3 ? s_size_3 : s_largest2;
  const double s_b = 4.611686018427388e+18 < s_largest3 ? 2.710505431213761e-20 : 1.0,
      s_d = s_largest3 < 256.0 ? 1.8014398509481984e+16 : s_b,
      s = s_largest3 < 1.4210854715202004e-14 ? 3.2451855365842673e+32 : s_d;
  const double y_0 = KSL_MUL((double)self->x, s);
  const double y_1 = KSL_MUL((double)self->y, s);
  const double y_2 = KSL_MUL((double)self->z, s);
  const double y_3 = KSL_MUL((double)self->w, s);
  const double up = 1.0 < s ? s : 1.0;
  const double down = s < 1.0 ? s : 1.0;
  const double n_a = KSL_MUL(y_0, y_0), n_b = KSL_MUL(y_1, y_1), n_c = n_a + n_b,
      n_d = KSL_MUL(y_2, y_2), n_e = n_c + n_d, n_f = KSL_MUL(y_3, y_3), n_g = n_e + n_f,
      n = sqrt(n_g);
  const double divisor = n == 0.0 ? up : n;
  const double sized_0 = KSL_MUL((double)self->x, up);
  const double sized_1 = KSL_MUL((double)self->y, up);
  const double sized_2 = KSL_MUL((double)self->z, up);
  const double sized_3 = KSL_MUL((double)self->w, up);
  const double quotient_0 = sized_0 / divisor;
  const double quotient_1 = sized_1 / divisor;
  const double quotient_2 = sized_2 / divisor;
  const double quotient_3 = sized_3 / divisor;
  const double self_0_new = KSL_MUL(quotient_0, down);
  const double self_1_new = KSL_MUL(quotient_1, down);
  const double self_2_new = KSL_MUL(quotient_2, down);
  const double self_3_new = KSL_MUL(quotient_3, down);
  self->x = (float)self_0_new;
  self->y = (float)self_1_new;
  self->z = (float)self_2_new;
  self->w = (float)self_3_new;
}

/* qo = q / |q|; zero stays zero.
   q, qo: quaternion (x, y, z, w), the scalar last.
   16 mul, 3 add, 4 div, 1 sqrt, 4 abs, 8 less, 1 equal, 9 select.
   Each component is within 1 ulp as long as its condition is below 1e13; in single precision it
     is the nearest number, except near ties, as long as that is below 1e5; searched, not proved. */
static inline void ksl_quaternionf_normalized_accurate(const ksl_quaternionf_t *q,
    ksl_quaternionf_t *qo) {
  const double s_size_0 = fabs((double)q->x);
  const double s_size_1 = fabs((double)q->y);
  const double s_size_2 = fabs((double)q->z);
  const double s_size_3 = fabs((double)q->w);
  const double s_largest1 = s_size_0 < s_size_1 ? s_size_1 : s_size_0;
  const double s_largest2 = s_largest1 < s_size_2 ? s_size_2 : s_largest1;
  const double s_largest3 = s_largest2 < s_size_3 ? s_size_3 : s_largest2;
  const double s_b = 4.611686018427388e+18 < s_largest3 ? 2.710505431213761e-20 : 1.0,
      s_d = s_largest3 < 256.0 ? 1.8014398509481984e+16 : s_b,
      s = s_largest3 < 1.4210854715202004e-14 ? 3.2451855365842673e+32 : s_d;
  const double y_0 = KSL_MUL((double)q->x, s);
  const double y_1 = KSL_MUL((double)q->y, s);
  const double y_2 = KSL_MUL((double)q->z, s);
  const double y_3 = KSL_MUL((double)q->w, s);
  const double up = 1.0 < s ? s : 1.0;
  const double down = s < 1.0 ? s : 1.0;
  const double n_a = KSL_MUL(y_0, y_0), n_b = KSL_MUL(y_1, y_1), n_c = n_a + n_b,
      n_d = KSL_MUL(y_2, y_2), n_e = n_c + n_d, n_f = KSL_MUL(y_3, y_3), n_g = n_e + n_f,
      n = sqrt(n_g);
  const double divisor = n == 0.0 ? up : n;
  const double sized_0 = KSL_MUL((double)q->x, up);
  const double sized_1 = KSL_MUL((double)q->y, up);
  const double sized_2 = KSL_MUL((double)q->z, up);
  const double sized_3 = KSL_MUL((double)q->w, up);
  const double quotient_0 = sized_0 / divisor;
  const double quotient_1 = sized_1 / divisor;
  const double quotient_2 = sized_2 / divisor;
  const double quotient_3 = sized_3 / divisor;
  const double qo_0 = KSL_MUL(quotient_0, down);
  const double qo_1 = KSL_MUL(quotient_1, down);
  const double qo_2 = KSL_MUL(quotient_2, down);
  const double qo_3 = KSL_MUL(quotient_3, down);
  qo->x = (float)qo_0;
  qo->y = (float)qo_1;
  qo->z = (float)qo_2;
  qo->w = (float)qo_3;
}

/* |q| - 1: 0 for a unit quaternion, negative for a shorter one.
   q: quaternion (x, y, z, w), the scalar last.
   9 mul, 4 add, 1 sqrt, 4 abs, 9 less, 9 select.
   Each component is within 1 ulp as long as its condition is below 1e13; in single precision it
     is the nearest number, except near ties, as long as that is below 1e5; searched, not proved. */
static inline float ksl_quaternionf_unit_defect_accurate(const ksl_quaternionf_t *q) {
  const double s_size_0 = fabs((double)q->x);
  const double s_size_1 = fabs((double)q->y);
  const double s_size_2 = fabs((double)q->z);
  const double s_size_3 = fabs((double)q->w);
  const double s_largest1 = s_size_0 < s_size_1 ? s_size_1 : s_size_0;
  const double s_largest2 = s_largest1 < s_size_2 ? s_size_2 : s_largest1;
  const double s_largest3 = s_largest2 < s_size_3 ? s_size_3 : s_largest2;
  const double s_b = 4.611686018427388e+18 < s_largest3 ? 2.710505431213761e-20 : 1.0,
      s_d = s_largest3 < 256.0 ? 1.8014398509481984e+16 : s_b,
      s = s_largest3 < 1.4210854715202004e-14 ? 3.2451855365842673e+32 : s_d;
  const double y_0 = KSL_MUL((double)q->x, s);
  const double y_1 = KSL_MUL((double)q->y, s);
  const double y_2 = KSL_MUL((double)q->z, s);
  const double y_3 = KSL_MUL((double)q->w, s);
  const double n_a = KSL_MUL(y_0, y_0), n_b = KSL_MUL(y_1, y_1), n_c = n_a + n_b,
      n_d = KSL_MUL(y_2, y_2), n_e = n_c + n_d, n_f = KSL_MUL(y_3, y_3), n_g = n_e + n_f,
      n = sqrt(n_g);
  const double r_b = s < 1.0 ? 3.6893488147419103e+19 : 1.0,
      r_d = 1.0 < s ? 5.551115123125783e-17 : r_b,
      r = 1.8014398509481984e+16 < s ? 3.0814879110195774e-33 : r_d;
  const double length = KSL_MUL(n, r);
  const double defect = length - 1.0;
  return (float)defect;
}

/* qo = q / |q|, the unit quaternion nearest to q; NaN for zero, which has none.
   q, qo: quaternion (x, y, z, w), the scalar last.
   8 mul, 3 add, 4 div, 1 sqrt, 4 abs, 6 less, 1 equal, 11 select.
   Each component is within 1 ulp as long as its condition is below 1e13; in single precision it
     is the nearest number, except near ties, as long as that is below 1e5; searched, not proved. */
static inline void ksl_quaternionf_nearest_unit_accurate(const ksl_quaternionf_t *q,
    ksl_quaternionf_t *qo) {
  const double s_size_0 = fabs((double)q->x);
  const double s_size_1 = fabs((double)q->y);
  const double s_size_2 = fabs((double)q->z);
  const double s_size_3 = fabs((double)q->w);
  const double s_largest1 = s_size_0 < s_size_1 ? s_size_1 : s_size_0;
  const double s_largest2 = s_largest1 < s_size_2 ? s_size_2 : s_largest1;
  const double s_largest3 = s_largest2 < s_size_3 ? s_size_3 : s_largest2;
  const double s_b = 4.611686018427388e+18 < s_largest3 ? 2.710505431213761e-20 : 1.0,
      s_d = s_largest3 < 256.0 ? 1.8014398509481984e+16 : s_b,
      s = s_largest3 < 1.4210854715202004e-14 ? 3.2451855365842673e+32 : s_d;
  const double scaled_s_0 = KSL_MUL((double)q->x, s);
  const double scaled_s_1 = KSL_MUL((double)q->y, s);
  const double scaled_s_2 = KSL_MUL((double)q->z, s);
  const double scaled_s_3 = KSL_MUL((double)q->w, s);
  const double n_a = KSL_MUL(scaled_s_0, scaled_s_0), n_b = KSL_MUL(scaled_s_1, scaled_s_1),
      n_c = n_a + n_b, n_d = KSL_MUL(scaled_s_2, scaled_s_2), n_e = n_c + n_d,
      n_f = KSL_MUL(scaled_s_3, scaled_s_3), n_g = n_e + n_f, n = sqrt(n_g);
  const double divisor = n == 0.0 ? 1.0 : n;
  const double unit_0 = scaled_s_0 / divisor;
  const double unit_1 = scaled_s_1 / divisor;
  const double unit_2 = scaled_s_2 / divisor;
  const double unit_3 = scaled_s_3 / divisor;
  const double qo_0 = n == 0.0 ? (double)NAN : unit_0;
  const double qo_1 = n == 0.0 ? (double)NAN : unit_1;
  const double qo_2 = n == 0.0 ? (double)NAN : unit_2;
  const double qo_3 = n == 0.0 ? (double)NAN : unit_3;
  qo->x = (float)qo_0;
  qo->y = (float)qo_1;
  qo->z = (float)qo_2;
  qo->w = (float)qo_3;
}

/* vo = R(q) v, |q| = 1.
   q: quaternion (x, y, z, w), the scalar last; v, vo: vector.
   18 mul, 12 add.
   Error <= u |result| + 3/16 u^2 S, S the sum of the |terms| of the expanded formula; barring
     over- and underflow. */
static inline void ksl_rotate_qvf_accurate(const ksl_quaternionf_t *q, const ksl_vec3f_t *v,
    ksl_vec3f_t *vo) {
  const double c_0a = (double)q->y * (double)v->z,
      c_0 = ksl_product_sum(-(double)q->z, (double)v->y, c_0a);
  const double c_1a = (double)q->z * (double)v->x,
      c_1 = ksl_product_sum(-(double)q->x, (double)v->z, c_1a);
  const double c_2a = (double)q->x * (double)v->y,
      c_2 = ksl_product_sum(-(double)q->y, (double)v->x, c_2a);
  const double t_0 = KSL_MUL(2.0, c_0);
  const double t_1 = KSL_MUL(2.0, c_1);
  const double t_2 = KSL_MUL(2.0, c_2);
  const double turn_0a = KSL_MUL((double)q->y, t_2), turn_0b = KSL_MUL((double)q->z, t_1),
      turn_0c = turn_0a - turn_0b, turn_0d = KSL_MUL((double)q->w, t_0), turn_0 = turn_0c + turn_0d;
  const double turn_1a = KSL_MUL((double)q->z, t_0), turn_1b = KSL_MUL((double)q->x, t_2),
      turn_1c = turn_1a - turn_1b, turn_1d = KSL_MUL((double)q->w, t_1), turn_1 = turn_1c + turn_1d;
  const double turn_2a = KSL_MUL((double)q->x, t_1), turn_2b = KSL_MUL((double)q->y, t_0),
      turn_2c = turn_2a - turn_2b, turn_2d = KSL_MUL((double)q->w, t_2), turn_2 = turn_2c + turn_2d;
  const double vo_0 = (double)v->x + turn_0;
  const double vo_1 = (double)v->y + turn_1;
  const double vo_2 = (double)v->z + turn_2;
  vo->x = (float)vo_0;
  vo->y = (float)vo_1;
  vo->z = (float)vo_2;
}

/* vo = R(q)^T v, |q| = 1.
   q: quaternion (x, y, z, w), the scalar last; v, vo: vector.
   18 mul, 12 add.
   Error <= u |result| + 3/16 u^2 S, S the sum of the |terms| of the expanded formula; barring
     over- and underflow. */
static inline void ksl_rotate_qconjvf_accurate(const ksl_quaternionf_t *q, const ksl_vec3f_t *v,
    ksl_vec3f_t *vo) {
  const double c_0a = (double)q->z * (double)v->y,
      c_0 = ksl_product_sum(-(double)q->y, (double)v->z, c_0a);
  const double c_1a = (double)q->x * (double)v->z,
      c_1 = ksl_product_sum(-(double)q->z, (double)v->x, c_1a);
  const double c_2a = (double)q->y * (double)v->x,
      c_2 = ksl_product_sum(-(double)q->x, (double)v->y, c_2a);
  const double t_0 = KSL_MUL(2.0, c_0);
  const double t_1 = KSL_MUL(2.0, c_1);
  const double t_2 = KSL_MUL(2.0, c_2);
  const double turn_0a = KSL_MUL((double)q->z, t_1), turn_0b = KSL_MUL((double)q->y, t_2),
      turn_0c = turn_0a - turn_0b, turn_0d = KSL_MUL((double)q->w, t_0), turn_0 = turn_0c + turn_0d;
  const double turn_1a = KSL_MUL((double)q->x, t_2), turn_1b = KSL_MUL((double)q->z, t_0),
      turn_1c = turn_1a - turn_1b, turn_1d = KSL_MUL((double)q->w, t_1), turn_1 = turn_1c + turn_1d;
  const double turn_2a = KSL_MUL((double)q->y, t_0), turn_2b = KSL_MUL((double)q->x, t_1),
      turn_2c = turn_2a - turn_2b, turn_2d = KSL_MUL((double)q->w, t_2), turn_2 = turn_2c + turn_2d;
  const double vo_0 = (double)v->x + turn_0;
  const double vo_1 = (double)v->y + turn_1;
  const double vo_2 = (double)v->z + turn_2;
  vo->x = (float)vo_0;
  vo->y = (float)vo_1;
  vo->z = (float)vo_2;
}

/* qo = q1i q2i.
   q1i, q2i, qo: quaternion (x, y, z, w), the scalar last.
   16 mul, 12 add, 1 neg.
   Error <= u |result| + 1/8 u^2 S, S the sum of the |terms| of the expanded formula; barring
     over- and underflow. */
static inline void ksl_product_qqf_accurate(const ksl_quaternionf_t *q1i,
    const ksl_quaternionf_t *q2i, ksl_quaternionf_t *qo) {
  const double qo_0b = (double)q1i->y * (double)q2i->z,
      qo_0d = ksl_product_sum(-(double)q1i->z, (double)q2i->y, qo_0b),
      qo_0e = ksl_product_sum((double)q1i->x, (double)q2i->w, qo_0d),
      qo_0 = ksl_product_sum((double)q1i->w, (double)q2i->x, qo_0e);
  const double qo_1a = (double)q1i->z * (double)q2i->x,
      qo_1c = ksl_product_sum(-(double)q1i->x, (double)q2i->z, qo_1a),
      qo_1e = ksl_product_sum((double)q1i->y, (double)q2i->w, qo_1c),
      qo_1 = ksl_product_sum((double)q1i->w, (double)q2i->y, qo_1e);
  const double qo_2a = (double)q1i->x * (double)q2i->y,
      qo_2c = ksl_product_sum(-(double)q1i->y, (double)q2i->x, qo_2a),
      qo_2e = ksl_product_sum((double)q1i->z, (double)q2i->w, qo_2c),
      qo_2 = ksl_product_sum((double)q1i->w, (double)q2i->z, qo_2e);
  const double qo_3b = (double)q1i->x * (double)q2i->x, qo_3d_lead = -qo_3b,
      qo_3d = ksl_product_sum(-(double)q1i->y, (double)q2i->y, qo_3d_lead),
      qo_3f = ksl_product_sum(-(double)q1i->z, (double)q2i->z, qo_3d),
      qo_3 = ksl_product_sum((double)q1i->w, (double)q2i->w, qo_3f);
  qo->x = (float)qo_0;
  qo->y = (float)qo_1;
  qo->z = (float)qo_2;
  qo->w = (float)qo_3;
}

/* qo = q1i q2i*.
   q1i, q2i, qo: quaternion (x, y, z, w), the scalar last.
   16 mul, 12 add.
   Error <= u |result| + (v: 3/32, w: 1/8) u^2 S, S the sum of the |terms| of the expanded
     formula; barring over- and underflow. */
static inline void ksl_product_qqconjf_accurate(const ksl_quaternionf_t *q1i,
    const ksl_quaternionf_t *q2i, ksl_quaternionf_t *qo) {
  const double qo_0a = (double)q1i->x * (double)q2i->w,
      qo_0c = ksl_product_sum(-(double)q1i->w, (double)q2i->x, qo_0a),
      qo_0d = (double)q1i->z * (double)q2i->y,
      qo_0f = ksl_product_sum(-(double)q1i->y, (double)q2i->z, qo_0d), qo_0 = qo_0c + qo_0f;
  const double qo_1a = (double)q1i->x * (double)q2i->z,
      qo_1c = ksl_product_sum(-(double)q1i->z, (double)q2i->x, qo_1a),
      qo_1d = (double)q1i->y * (double)q2i->w,
      qo_1f = ksl_product_sum(-(double)q1i->w, (double)q2i->y, qo_1d), qo_1 = qo_1c + qo_1f;
  const double qo_2a = (double)q1i->y * (double)q2i->x,
      qo_2c = ksl_product_sum(-(double)q1i->x, (double)q2i->y, qo_2a),
      qo_2d = (double)q1i->z * (double)q2i->w,
      qo_2f = ksl_product_sum(-(double)q1i->w, (double)q2i->z, qo_2d), qo_2 = qo_2c + qo_2f;
  const double qo_3a = (double)q1i->x * (double)q2i->x,
      qo_3c = ksl_product_sum((double)q1i->y, (double)q2i->y, qo_3a),
      qo_3e = ksl_product_sum((double)q1i->z, (double)q2i->z, qo_3c),
      qo_3 = ksl_product_sum((double)q1i->w, (double)q2i->w, qo_3e);
  qo->x = (float)qo_0;
  qo->y = (float)qo_1;
  qo->z = (float)qo_2;
  qo->w = (float)qo_3;
}

/* qo = q1i* q2i.
   q1i, q2i, qo: quaternion (x, y, z, w), the scalar last.
   16 mul, 12 add.
   Error <= u |result| + (v: 3/32, w: 1/8) u^2 S, S the sum of the |terms| of the expanded
     formula; barring over- and underflow. */
static inline void ksl_product_qconjqf_accurate(const ksl_quaternionf_t *q1i,
    const ksl_quaternionf_t *q2i, ksl_quaternionf_t *qo) {
  const double qo_0a = (double)q1i->w * (double)q2i->x,
      qo_0c = ksl_product_sum(-(double)q1i->x, (double)q2i->w, qo_0a),
      qo_0d = (double)q1i->z * (double)q2i->y,
      qo_0f = ksl_product_sum(-(double)q1i->y, (double)q2i->z, qo_0d), qo_0 = qo_0c + qo_0f;
  const double qo_1a = (double)q1i->x * (double)q2i->z,
      qo_1c = ksl_product_sum(-(double)q1i->z, (double)q2i->x, qo_1a),
      qo_1d = (double)q1i->w * (double)q2i->y,
      qo_1f = ksl_product_sum(-(double)q1i->y, (double)q2i->w, qo_1d), qo_1 = qo_1c + qo_1f;
  const double qo_2a = (double)q1i->y * (double)q2i->x,
      qo_2c = ksl_product_sum(-(double)q1i->x, (double)q2i->y, qo_2a),
      qo_2d = (double)q1i->w * (double)q2i->z,
      qo_2f = ksl_product_sum(-(double)q1i->z, (double)q2i->w, qo_2d), qo_2 = qo_2c + qo_2f;
  const double qo_3a = (double)q1i->x * (double)q2i->x,
      qo_3c = ksl_product_sum((double)q1i->y, (double)q2i->y, qo_3a),
      qo_3e = ksl_product_sum((double)q1i->z, (double)q2i->z, qo_3c),
      qo_3 = ksl_product_sum((double)q1i->w, (double)q2i->w, qo_3e);
  qo->x = (float)qo_0;
  qo->y = (float)qo_1;
  qo->z = (float)qo_2;
  qo->w = (float)qo_3;
}

/* qo = q1i* q2i*.
   q1i, q2i, qo: quaternion (x, y, z, w), the scalar last.
   16 mul, 12 add, 1 neg.
   Error <= u |result| + 1/8 u^2 S, S the sum of the |terms| of the expanded formula; barring
     over- and underflow. */
static inline void ksl_product_qconjqconjf_accurate(const ksl_quaternionf_t *q1i,
    const ksl_quaternionf_t *q2i, ksl_quaternionf_t *qo) {
  const double qo_0a = (double)q1i->y * (double)q2i->z,
      qo_0c = ksl_product_sum(-(double)q1i->z, (double)q2i->y, qo_0a),
      qo_0e = ksl_product_sum(-(double)q1i->x, (double)q2i->w, qo_0c),
      qo_0 = ksl_product_sum(-(double)q1i->w, (double)q2i->x, qo_0e);
  const double qo_1a = (double)q1i->z * (double)q2i->x,
      qo_1c = ksl_product_sum(-(double)q1i->x, (double)q2i->z, qo_1a),
      qo_1e = ksl_product_sum(-(double)q1i->y, (double)q2i->w, qo_1c),
      qo_1 = ksl_product_sum(-(double)q1i->w, (double)q2i->y, qo_1e);
  const double qo_2a = (double)q1i->x * (double)q2i->y,
      qo_2c = ksl_product_sum(-(double)q1i->y, (double)q2i->x, qo_2a),
      qo_2e = ksl_product_sum(-(double)q1i->z, (double)q2i->w, qo_2c),
      qo_2 = ksl_product_sum(-(double)q1i->w, (double)q2i->z, qo_2e);
  const double qo_3b = (double)q1i->x * (double)q2i->x, qo_3d_lead = -qo_3b,
      qo_3d = ksl_product_sum(-(double)q1i->y, (double)q2i->y, qo_3d_lead),
      qo_3f = ksl_product_sum(-(double)q1i->z, (double)q2i->z, qo_3d),
      qo_3 = ksl_product_sum((double)q1i->w, (double)q2i->w, qo_3f);
  qo->x = (float)qo_0;
  qo->y = (float)qo_1;
  qo->z = (float)qo_2;
  qo->w = (float)qo_3;
}

/* qo = (s e_x; c) qi, dci = (s, c), sine and cosine of half the angle.
   dci: (sin θ, cos θ); qi, qo: quaternion (x, y, z, w), the scalar last.
   8 mul, 4 add.
   Error <= u |result| + 1/16 u^2 S, S the sum of the |terms| of the expanded formula; barring
     over- and underflow. */
static inline void ksl_product_qxqf_accurate(const float dci[2], const ksl_quaternionf_t *qi,
    ksl_quaternionf_t *qo) {
  const double qo_0a = (double)dci[0] * (double)qi->w,
      qo_0 = ksl_product_sum((double)dci[1], (double)qi->x, qo_0a);
  const double qo_1a = (double)dci[1] * (double)qi->y,
      qo_1 = ksl_product_sum(-(double)dci[0], (double)qi->z, qo_1a);
  const double qo_2a = (double)dci[0] * (double)qi->y,
      qo_2 = ksl_product_sum((double)dci[1], (double)qi->z, qo_2a);
  const double qo_3a = (double)dci[1] * (double)qi->w,
      qo_3 = ksl_product_sum(-(double)dci[0], (double)qi->x, qo_3a);
  qo->x = (float)qo_0;
  qo->y = (float)qo_1;
  qo->z = (float)qo_2;
  qo->w = (float)qo_3;
}

/* qo = (s e_x; c) qi*, dci = (s, c), sine and cosine of half the angle.
   dci: (sin θ, cos θ); qi, qo: quaternion (x, y, z, w), the scalar last.
   8 mul, 4 add, 1 neg.
   Error <= u |result| + 1/16 u^2 S, S the sum of the |terms| of the expanded formula; barring
     over- and underflow. */
static inline void ksl_product_qxqconjf_accurate(const float dci[2], const ksl_quaternionf_t *qi,
    ksl_quaternionf_t *qo) {
  const double qo_0a = (double)dci[0] * (double)qi->w,
      qo_0 = ksl_product_sum(-(double)dci[1], (double)qi->x, qo_0a);
  const double qo_1a = (double)dci[0] * (double)qi->z,
      qo_1 = ksl_product_sum(-(double)dci[1], (double)qi->y, qo_1a);
  const double qo_2a = (double)dci[0] * (double)qi->y, qo_2c_lead = -qo_2a,
      qo_2 = ksl_product_sum(-(double)dci[1], (double)qi->z, qo_2c_lead);
  const double qo_3a = (double)dci[0] * (double)qi->x,
      qo_3 = ksl_product_sum((double)dci[1], (double)qi->w, qo_3a);
  qo->x = (float)qo_0;
  qo->y = (float)qo_1;
  qo->z = (float)qo_2;
  qo->w = (float)qo_3;
}

/* qo = (s e_x; c)* qi, dci = (s, c), sine and cosine of half the angle.
   dci: (sin θ, cos θ); qi, qo: quaternion (x, y, z, w), the scalar last.
   8 mul, 4 add.
   Error <= u |result| + 1/16 u^2 S, S the sum of the |terms| of the expanded formula; barring
     over- and underflow. */
static inline void ksl_product_qxconjqf_accurate(const float dci[2], const ksl_quaternionf_t *qi,
    ksl_quaternionf_t *qo) {
  const double qo_0a = (double)dci[1] * (double)qi->x,
      qo_0 = ksl_product_sum(-(double)dci[0], (double)qi->w, qo_0a);
  const double qo_1a = (double)dci[0] * (double)qi->z,
      qo_1 = ksl_product_sum((double)dci[1], (double)qi->y, qo_1a);
  const double qo_2a = (double)dci[1] * (double)qi->z,
      qo_2 = ksl_product_sum(-(double)dci[0], (double)qi->y, qo_2a);
  const double qo_3a = (double)dci[0] * (double)qi->x,
      qo_3 = ksl_product_sum((double)dci[1], (double)qi->w, qo_3a);
  qo->x = (float)qo_0;
  qo->y = (float)qo_1;
  qo->z = (float)qo_2;
  qo->w = (float)qo_3;
}

/* qo = (s e_x; c)* qi*, dci = (s, c), sine and cosine of half the angle.
   dci: (sin θ, cos θ); qi, qo: quaternion (x, y, z, w), the scalar last.
   8 mul, 4 add, 2 neg.
   Error <= u |result| + 1/16 u^2 S, S the sum of the |terms| of the expanded formula; barring
     over- and underflow. */
static inline void ksl_product_qxconjqconjf_accurate(const float dci[2],
    const ksl_quaternionf_t *qi, ksl_quaternionf_t *qo) {
  const double qo_0a = (double)dci[0] * (double)qi->w, qo_0c_lead = -qo_0a,
      qo_0 = ksl_product_sum(-(double)dci[1], (double)qi->x, qo_0c_lead);
  const double qo_1a = (double)dci[0] * (double)qi->z, qo_1c_lead = -qo_1a,
      qo_1 = ksl_product_sum(-(double)dci[1], (double)qi->y, qo_1c_lead);
  const double qo_2a = (double)dci[0] * (double)qi->y,
      qo_2 = ksl_product_sum(-(double)dci[1], (double)qi->z, qo_2a);
  const double qo_3a = (double)dci[1] * (double)qi->w,
      qo_3 = ksl_product_sum(-(double)dci[0], (double)qi->x, qo_3a);
  qo->x = (float)qo_0;
  qo->y = (float)qo_1;
  qo->z = (float)qo_2;
  qo->w = (float)qo_3;
}

/* qo = qi (s e_x; c), dci = (s, c), sine and cosine of half the angle.
   qi, qo: quaternion (x, y, z, w), the scalar last; dci: (sin θ, cos θ).
   8 mul, 4 add.
   Error <= u |result| + 1/16 u^2 S, S the sum of the |terms| of the expanded formula; barring
     over- and underflow. */
static inline void ksl_product_qqxf_accurate(const ksl_quaternionf_t *qi, const float dci[2],
    ksl_quaternionf_t *qo) {
  const double qo_0a = (double)qi->x * (double)dci[1],
      qo_0 = ksl_product_sum((double)qi->w, (double)dci[0], qo_0a);
  const double qo_1a = (double)qi->y * (double)dci[1],
      qo_1 = ksl_product_sum((double)qi->z, (double)dci[0], qo_1a);
  const double qo_2a = (double)qi->z * (double)dci[1],
      qo_2 = ksl_product_sum(-(double)qi->y, (double)dci[0], qo_2a);
  const double qo_3a = (double)qi->w * (double)dci[1],
      qo_3 = ksl_product_sum(-(double)qi->x, (double)dci[0], qo_3a);
  qo->x = (float)qo_0;
  qo->y = (float)qo_1;
  qo->z = (float)qo_2;
  qo->w = (float)qo_3;
}

/* qo = qi (s e_x; c)*, dci = (s, c), sine and cosine of half the angle.
   qi, qo: quaternion (x, y, z, w), the scalar last; dci: (sin θ, cos θ).
   8 mul, 4 add.
   Error <= u |result| + 1/16 u^2 S, S the sum of the |terms| of the expanded formula; barring
     over- and underflow. */
static inline void ksl_product_qqxconjf_accurate(const ksl_quaternionf_t *qi, const float dci[2],
    ksl_quaternionf_t *qo) {
  const double qo_0a = (double)qi->x * (double)dci[1],
      qo_0 = ksl_product_sum(-(double)qi->w, (double)dci[0], qo_0a);
  const double qo_1a = (double)qi->y * (double)dci[1],
      qo_1 = ksl_product_sum(-(double)qi->z, (double)dci[0], qo_1a);
  const double qo_2a = (double)qi->y * (double)dci[0],
      qo_2 = ksl_product_sum((double)qi->z, (double)dci[1], qo_2a);
  const double qo_3a = (double)qi->x * (double)dci[0],
      qo_3 = ksl_product_sum((double)qi->w, (double)dci[1], qo_3a);
  qo->x = (float)qo_0;
  qo->y = (float)qo_1;
  qo->z = (float)qo_2;
  qo->w = (float)qo_3;
}

/* qo = qi* (s e_x; c), dci = (s, c), sine and cosine of half the angle.
   qi, qo: quaternion (x, y, z, w), the scalar last; dci: (sin θ, cos θ).
   8 mul, 4 add, 1 neg.
   Error <= u |result| + 1/16 u^2 S, S the sum of the |terms| of the expanded formula; barring
     over- and underflow. */
static inline void ksl_product_qconjqxf_accurate(const ksl_quaternionf_t *qi, const float dci[2],
    ksl_quaternionf_t *qo) {
  const double qo_0a = (double)qi->w * (double)dci[0],
      qo_0 = ksl_product_sum(-(double)qi->x, (double)dci[1], qo_0a);
  const double qo_1a = (double)qi->y * (double)dci[1], qo_1c_lead = -qo_1a,
      qo_1 = ksl_product_sum(-(double)qi->z, (double)dci[0], qo_1c_lead);
  const double qo_2a = (double)qi->y * (double)dci[0],
      qo_2 = ksl_product_sum(-(double)qi->z, (double)dci[1], qo_2a);
  const double qo_3a = (double)qi->x * (double)dci[0],
      qo_3 = ksl_product_sum((double)qi->w, (double)dci[1], qo_3a);
  qo->x = (float)qo_0;
  qo->y = (float)qo_1;
  qo->z = (float)qo_2;
  qo->w = (float)qo_3;
}

/* qo = qi* (s e_x; c)*, dci = (s, c), sine and cosine of half the angle.
   qi, qo: quaternion (x, y, z, w), the scalar last; dci: (sin θ, cos θ).
   8 mul, 4 add, 2 neg.
   Error <= u |result| + 1/16 u^2 S, S the sum of the |terms| of the expanded formula; barring
     over- and underflow. */
static inline void ksl_product_qconjqxconjf_accurate(const ksl_quaternionf_t *qi,
    const float dci[2], ksl_quaternionf_t *qo) {
  const double qo_0a = (double)qi->x * (double)dci[1], qo_0c_lead = -qo_0a,
      qo_0 = ksl_product_sum(-(double)qi->w, (double)dci[0], qo_0c_lead);
  const double qo_1a = (double)qi->z * (double)dci[0],
      qo_1 = ksl_product_sum(-(double)qi->y, (double)dci[1], qo_1a);
  const double qo_2a = (double)qi->y * (double)dci[0], qo_2c_lead = -qo_2a,
      qo_2 = ksl_product_sum(-(double)qi->z, (double)dci[1], qo_2c_lead);
  const double qo_3a = (double)qi->w * (double)dci[1],
      qo_3 = ksl_product_sum(-(double)qi->x, (double)dci[0], qo_3a);
  qo->x = (float)qo_0;
  qo->y = (float)qo_1;
  qo->z = (float)qo_2;
  qo->w = (float)qo_3;
}

/* qo = (s e_y; c) qi, dci = (s, c), sine and cosine of half the angle.
   dci: (sin θ, cos θ); qi, qo: quaternion (x, y, z, w), the scalar last.
   8 mul, 4 add.
   Error <= u |result| + 1/16 u^2 S, S the sum of the |terms| of the expanded formula; barring
     over- and underflow. */
static inline void ksl_product_qyqf_accurate(const float dci[2], const ksl_quaternionf_t *qi,
    ksl_quaternionf_t *qo) {
  const double qo_0a = (double)dci[0] * (double)qi->z,
      qo_0 = ksl_product_sum((double)dci[1], (double)qi->x, qo_0a);
  const double qo_1a = (double)dci[0] * (double)qi->w,
      qo_1 = ksl_product_sum((double)dci[1], (double)qi->y, qo_1a);
  const double qo_2a = (double)dci[1] * (double)qi->z,
      qo_2 = ksl_product_sum(-(double)dci[0], (double)qi->x, qo_2a);
  const double qo_3a = (double)dci[1] * (double)qi->w,
      qo_3 = ksl_product_sum(-(double)dci[0], (double)qi->y, qo_3a);
  qo->x = (float)qo_0;
  qo->y = (float)qo_1;
  qo->z = (float)qo_2;
  qo->w = (float)qo_3;
}

/* qo = (s e_y; c) qi*, dci = (s, c), sine and cosine of half the angle.
   dci: (sin θ, cos θ); qi, qo: quaternion (x, y, z, w), the scalar last.
   8 mul, 4 add, 1 neg.
   Error <= u |result| + 1/16 u^2 S, S the sum of the |terms| of the expanded formula; barring
     over- and underflow. */
static inline void ksl_product_qyqconjf_accurate(const float dci[2], const ksl_quaternionf_t *qi,
    ksl_quaternionf_t *qo) {
  const double qo_0a = (double)dci[0] * (double)qi->z, qo_0c_lead = -qo_0a,
      qo_0 = ksl_product_sum(-(double)dci[1], (double)qi->x, qo_0c_lead);
  const double qo_1a = (double)dci[0] * (double)qi->w,
      qo_1 = ksl_product_sum(-(double)dci[1], (double)qi->y, qo_1a);
  const double qo_2a = (double)dci[0] * (double)qi->x,
      qo_2 = ksl_product_sum(-(double)dci[1], (double)qi->z, qo_2a);
  const double qo_3a = (double)dci[0] * (double)qi->y,
      qo_3 = ksl_product_sum((double)dci[1], (double)qi->w, qo_3a);
  qo->x = (float)qo_0;
  qo->y = (float)qo_1;
  qo->z = (float)qo_2;
  qo->w = (float)qo_3;
}

/* qo = (s e_y; c)* qi, dci = (s, c), sine and cosine of half the angle.
   dci: (sin θ, cos θ); qi, qo: quaternion (x, y, z, w), the scalar last.
   8 mul, 4 add.
   Error <= u |result| + 1/16 u^2 S, S the sum of the |terms| of the expanded formula; barring
     over- and underflow. */
static inline void ksl_product_qyconjqf_accurate(const float dci[2], const ksl_quaternionf_t *qi,
    ksl_quaternionf_t *qo) {
  const double qo_0a = (double)dci[1] * (double)qi->x,
      qo_0 = ksl_product_sum(-(double)dci[0], (double)qi->z, qo_0a);
  const double qo_1a = (double)dci[1] * (double)qi->y,
      qo_1 = ksl_product_sum(-(double)dci[0], (double)qi->w, qo_1a);
  const double qo_2a = (double)dci[0] * (double)qi->x,
      qo_2 = ksl_product_sum((double)dci[1], (double)qi->z, qo_2a);
  const double qo_3a = (double)dci[0] * (double)qi->y,
      qo_3 = ksl_product_sum((double)dci[1], (double)qi->w, qo_3a);
  qo->x = (float)qo_0;
  qo->y = (float)qo_1;
  qo->z = (float)qo_2;
  qo->w = (float)qo_3;
}

/* qo = (s e_y; c)* qi*, dci = (s, c), sine and cosine of half the angle.
   dci: (sin θ, cos θ); qi, qo: quaternion (x, y, z, w), the scalar last.
   8 mul, 4 add, 2 neg.
   Error <= u |result| + 1/16 u^2 S, S the sum of the |terms| of the expanded formula; barring
     over- and underflow. */
static inline void ksl_product_qyconjqconjf_accurate(const float dci[2],
    const ksl_quaternionf_t *qi, ksl_quaternionf_t *qo) {
  const double qo_0a = (double)dci[0] * (double)qi->z,
      qo_0 = ksl_product_sum(-(double)dci[1], (double)qi->x, qo_0a);
  const double qo_1a = (double)dci[0] * (double)qi->w, qo_1c_lead = -qo_1a,
      qo_1 = ksl_product_sum(-(double)dci[1], (double)qi->y, qo_1c_lead);
  const double qo_2a = (double)dci[0] * (double)qi->x, qo_2c_lead = -qo_2a,
      qo_2 = ksl_product_sum(-(double)dci[1], (double)qi->z, qo_2c_lead);
  const double qo_3a = (double)dci[1] * (double)qi->w,
      qo_3 = ksl_product_sum(-(double)dci[0], (double)qi->y, qo_3a);
  qo->x = (float)qo_0;
  qo->y = (float)qo_1;
  qo->z = (float)qo_2;
  qo->w = (float)qo_3;
}

/* qo = qi (s e_y; c), dci = (s, c), sine and cosine of half the angle.
   qi, qo: quaternion (x, y, z, w), the scalar last; dci: (sin θ, cos θ).
   8 mul, 4 add.
   Error <= u |result| + 1/16 u^2 S, S the sum of the |terms| of the expanded formula; barring
     over- and underflow. */
static inline void ksl_product_qqyf_accurate(const ksl_quaternionf_t *qi, const float dci[2],
    ksl_quaternionf_t *qo) {
  const double qo_0a = (double)qi->x * (double)dci[1],
      qo_0 = ksl_product_sum(-(double)qi->z, (double)dci[0], qo_0a);
  const double qo_1a = (double)qi->y * (double)dci[1],
      qo_1 = ksl_product_sum((double)qi->w, (double)dci[0], qo_1a);
  const double qo_2a = (double)qi->x * (double)dci[0],
      qo_2 = ksl_product_sum((double)qi->z, (double)dci[1], qo_2a);
  const double qo_3a = (double)qi->w * (double)dci[1],
      qo_3 = ksl_product_sum(-(double)qi->y, (double)dci[0], qo_3a);
  qo->x = (float)qo_0;
  qo->y = (float)qo_1;
  qo->z = (float)qo_2;
  qo->w = (float)qo_3;
}

/* qo = qi (s e_y; c)*, dci = (s, c), sine and cosine of half the angle.
   qi, qo: quaternion (x, y, z, w), the scalar last; dci: (sin θ, cos θ).
   8 mul, 4 add.
   Error <= u |result| + 1/16 u^2 S, S the sum of the |terms| of the expanded formula; barring
     over- and underflow. */
static inline void ksl_product_qqyconjf_accurate(const ksl_quaternionf_t *qi, const float dci[2],
    ksl_quaternionf_t *qo) {
  const double qo_0a = (double)qi->x * (double)dci[1],
      qo_0 = ksl_product_sum((double)qi->z, (double)dci[0], qo_0a);
  const double qo_1a = (double)qi->y * (double)dci[1],
      qo_1 = ksl_product_sum(-(double)qi->w, (double)dci[0], qo_1a);
  const double qo_2a = (double)qi->z * (double)dci[1],
      qo_2 = ksl_product_sum(-(double)qi->x, (double)dci[0], qo_2a);
  const double qo_3a = (double)qi->y * (double)dci[0],
      qo_3 = ksl_product_sum((double)qi->w, (double)dci[1], qo_3a);
  qo->x = (float)qo_0;
  qo->y = (float)qo_1;
  qo->z = (float)qo_2;
  qo->w = (float)qo_3;
}

/* qo = qi* (s e_y; c), dci = (s, c), sine and cosine of half the angle.
   qi, qo: quaternion (x, y, z, w), the scalar last; dci: (sin θ, cos θ).
   8 mul, 4 add, 1 neg.
   Error <= u |result| + 1/16 u^2 S, S the sum of the |terms| of the expanded formula; barring
     over- and underflow. */
static inline void ksl_product_qconjqyf_accurate(const ksl_quaternionf_t *qi, const float dci[2],
    ksl_quaternionf_t *qo) {
  const double qo_0a = (double)qi->z * (double)dci[0],
      qo_0 = ksl_product_sum(-(double)qi->x, (double)dci[1], qo_0a);
  const double qo_1a = (double)qi->w * (double)dci[0],
      qo_1 = ksl_product_sum(-(double)qi->y, (double)dci[1], qo_1a);
  const double qo_2a = (double)qi->x * (double)dci[0], qo_2c_lead = -qo_2a,
      qo_2 = ksl_product_sum(-(double)qi->z, (double)dci[1], qo_2c_lead);
  const double qo_3a = (double)qi->y * (double)dci[0],
      qo_3 = ksl_product_sum((double)qi->w, (double)dci[1], qo_3a);
  qo->x = (float)qo_0;
  qo->y = (float)qo_1;
  qo->z = (float)qo_2;
  qo->w = (float)qo_3;
}

/* qo = qi* (s e_y; c)*, dci = (s, c), sine and cosine of half the angle.
   qi, qo: quaternion (x, y, z, w), the scalar last; dci: (sin θ, cos θ).
   8 mul, 4 add, 2 neg.
   Error <= u |result| + 1/16 u^2 S, S the sum of the |terms| of the expanded formula; barring
     over- and underflow. */
static inline void ksl_product_qconjqyconjf_accurate(const ksl_quaternionf_t *qi,
    const float dci[2], ksl_quaternionf_t *qo) {
  const double qo_0a = (double)qi->x * (double)dci[1], qo_0c_lead = -qo_0a,
      qo_0 = ksl_product_sum(-(double)qi->z, (double)dci[0], qo_0c_lead);
  const double qo_1a = (double)qi->y * (double)dci[1], qo_1c_lead = -qo_1a,
      qo_1 = ksl_product_sum(-(double)qi->w, (double)dci[0], qo_1c_lead);
  const double qo_2a = (double)qi->x * (double)dci[0],
      qo_2 = ksl_product_sum(-(double)qi->z, (double)dci[1], qo_2a);
  const double qo_3a = (double)qi->w * (double)dci[1],
      qo_3 = ksl_product_sum(-(double)qi->y, (double)dci[0], qo_3a);
  qo->x = (float)qo_0;
  qo->y = (float)qo_1;
  qo->z = (float)qo_2;
  qo->w = (float)qo_3;
}

/* qo = (s e_z; c) qi, dci = (s, c), sine and cosine of half the angle.
   dci: (sin θ, cos θ); qi, qo: quaternion (x, y, z, w), the scalar last.
   8 mul, 4 add.
   Error <= u |result| + 1/16 u^2 S, S the sum of the |terms| of the expanded formula; barring
     over- and underflow. */
static inline void ksl_product_qzqf_accurate(const float dci[2], const ksl_quaternionf_t *qi,
    ksl_quaternionf_t *qo) {
  const double qo_0a = (double)dci[1] * (double)qi->x,
      qo_0 = ksl_product_sum(-(double)dci[0], (double)qi->y, qo_0a);
  const double qo_1a = (double)dci[0] * (double)qi->x,
      qo_1 = ksl_product_sum((double)dci[1], (double)qi->y, qo_1a);
  const double qo_2a = (double)dci[0] * (double)qi->w,
      qo_2 = ksl_product_sum((double)dci[1], (double)qi->z, qo_2a);
  const double qo_3a = (double)dci[1] * (double)qi->w,
      qo_3 = ksl_product_sum(-(double)dci[0], (double)qi->z, qo_3a);
  qo->x = (float)qo_0;
  qo->y = (float)qo_1;
  qo->z = (float)qo_2;
  qo->w = (float)qo_3;
}

/* qo = (s e_z; c) qi*, dci = (s, c), sine and cosine of half the angle.
   dci: (sin θ, cos θ); qi, qo: quaternion (x, y, z, w), the scalar last.
   8 mul, 4 add, 1 neg.
   Error <= u |result| + 1/16 u^2 S, S the sum of the |terms| of the expanded formula; barring
     over- and underflow. */
static inline void ksl_product_qzqconjf_accurate(const float dci[2], const ksl_quaternionf_t *qi,
    ksl_quaternionf_t *qo) {
  const double qo_0a = (double)dci[0] * (double)qi->y,
      qo_0 = ksl_product_sum(-(double)dci[1], (double)qi->x, qo_0a);
  const double qo_1a = (double)dci[0] * (double)qi->x, qo_1c_lead = -qo_1a,
      qo_1 = ksl_product_sum(-(double)dci[1], (double)qi->y, qo_1c_lead);
  const double qo_2a = (double)dci[0] * (double)qi->w,
      qo_2 = ksl_product_sum(-(double)dci[1], (double)qi->z, qo_2a);
  const double qo_3a = (double)dci[0] * (double)qi->z,
      qo_3 = ksl_product_sum((double)dci[1], (double)qi->w, qo_3a);
  qo->x = (float)qo_0;
  qo->y = (float)qo_1;
  qo->z = (float)qo_2;
  qo->w = (float)qo_3;
}

/* qo = (s e_z; c)* qi, dci = (s, c), sine and cosine of half the angle.
   dci: (sin θ, cos θ); qi, qo: quaternion (x, y, z, w), the scalar last.
   8 mul, 4 add.
   Error <= u |result| + 1/16 u^2 S, S the sum of the |terms| of the expanded formula; barring
     over- and underflow. */
static inline void ksl_product_qzconjqf_accurate(const float dci[2], const ksl_quaternionf_t *qi,
    ksl_quaternionf_t *qo) {
  const double qo_0a = (double)dci[0] * (double)qi->y,
      qo_0 = ksl_product_sum((double)dci[1], (double)qi->x, qo_0a);
  const double qo_1a = (double)dci[1] * (double)qi->y,
      qo_1 = ksl_product_sum(-(double)dci[0], (double)qi->x, qo_1a);
  const double qo_2a = (double)dci[1] * (double)qi->z,
      qo_2 = ksl_product_sum(-(double)dci[0], (double)qi->w, qo_2a);
  const double qo_3a = (double)dci[0] * (double)qi->z,
      qo_3 = ksl_product_sum((double)dci[1], (double)qi->w, qo_3a);
  qo->x = (float)qo_0;
  qo->y = (float)qo_1;
  qo->z = (float)qo_2;
  qo->w = (float)qo_3;
}

/* qo = (s e_z; c)* qi*, dci = (s, c), sine and cosine of half the angle.
   dci: (sin θ, cos θ); qi, qo: quaternion (x, y, z, w), the scalar last.
   8 mul, 4 add, 2 neg.
   Error <= u |result| + 1/16 u^2 S, S the sum of the |terms| of the expanded formula; barring
     over- and underflow. */
static inline void ksl_product_qzconjqconjf_accurate(const float dci[2],
    const ksl_quaternionf_t *qi, ksl_quaternionf_t *qo) {
  const double qo_0a = (double)dci[0] * (double)qi->y, qo_0c_lead = -qo_0a,
      qo_0 = ksl_product_sum(-(double)dci[1], (double)qi->x, qo_0c_lead);
  const double qo_1a = (double)dci[0] * (double)qi->x,
      qo_1 = ksl_product_sum(-(double)dci[1], (double)qi->y, qo_1a);
  const double qo_2a = (double)dci[0] * (double)qi->w, qo_2c_lead = -qo_2a,
      qo_2 = ksl_product_sum(-(double)dci[1], (double)qi->z, qo_2c_lead);
  const double qo_3a = (double)dci[1] * (double)qi->w,
      qo_3 = ksl_product_sum(-(double)dci[0], (double)qi->z, qo_3a);
  qo->x = (float)qo_0;
  qo->y = (float)qo_1;
  qo->z = (float)qo_2;
  qo->w = (float)qo_3;
}

/* qo = qi (s e_z; c), dci = (s, c), sine and cosine of half the angle.
   qi, qo: quaternion (x, y, z, w), the scalar last; dci: (sin θ, cos θ).
   8 mul, 4 add.
   Error <= u |result| + 1/16 u^2 S, S the sum of the |terms| of the expanded formula; barring
     over- and underflow. */
static inline void ksl_product_qqzf_accurate(const ksl_quaternionf_t *qi, const float dci[2],
    ksl_quaternionf_t *qo) {
  const double qo_0a = (double)qi->x * (double)dci[1],
      qo_0 = ksl_product_sum((double)qi->y, (double)dci[0], qo_0a);
  const double qo_1a = (double)qi->y * (double)dci[1],
      qo_1 = ksl_product_sum(-(double)qi->x, (double)dci[0], qo_1a);
  const double qo_2a = (double)qi->z * (double)dci[1],
      qo_2 = ksl_product_sum((double)qi->w, (double)dci[0], qo_2a);
  const double qo_3a = (double)qi->w * (double)dci[1],
      qo_3 = ksl_product_sum(-(double)qi->z, (double)dci[0], qo_3a);
  qo->x = (float)qo_0;
  qo->y = (float)qo_1;
  qo->z = (float)qo_2;
  qo->w = (float)qo_3;
}

/* qo = qi (s e_z; c)*, dci = (s, c), sine and cosine of half the angle.
   qi, qo: quaternion (x, y, z, w), the scalar last; dci: (sin θ, cos θ).
   8 mul, 4 add.
   Error <= u |result| + 1/16 u^2 S, S the sum of the |terms| of the expanded formula; barring
     over- and underflow. */
static inline void ksl_product_qqzconjf_accurate(const ksl_quaternionf_t *qi, const float dci[2],
    ksl_quaternionf_t *qo) {
  const double qo_0a = (double)qi->x * (double)dci[1],
      qo_0 = ksl_product_sum(-(double)qi->y, (double)dci[0], qo_0a);
  const double qo_1a = (double)qi->x * (double)dci[0],
      qo_1 = ksl_product_sum((double)qi->y, (double)dci[1], qo_1a);
  const double qo_2a = (double)qi->z * (double)dci[1],
      qo_2 = ksl_product_sum(-(double)qi->w, (double)dci[0], qo_2a);
  const double qo_3a = (double)qi->z * (double)dci[0],
      qo_3 = ksl_product_sum((double)qi->w, (double)dci[1], qo_3a);
  qo->x = (float)qo_0;
  qo->y = (float)qo_1;
  qo->z = (float)qo_2;
  qo->w = (float)qo_3;
}

/* qo = qi* (s e_z; c), dci = (s, c), sine and cosine of half the angle.
   qi, qo: quaternion (x, y, z, w), the scalar last; dci: (sin θ, cos θ).
   8 mul, 4 add, 1 neg.
   Error <= u |result| + 1/16 u^2 S, S the sum of the |terms| of the expanded formula; barring
     over- and underflow. */
static inline void ksl_product_qconjqzf_accurate(const ksl_quaternionf_t *qi, const float dci[2],
    ksl_quaternionf_t *qo) {
  const double qo_0a = (double)qi->x * (double)dci[1], qo_0c_lead = -qo_0a,
      qo_0 = ksl_product_sum(-(double)qi->y, (double)dci[0], qo_0c_lead);
  const double qo_1a = (double)qi->x * (double)dci[0],
      qo_1 = ksl_product_sum(-(double)qi->y, (double)dci[1], qo_1a);
  const double qo_2a = (double)qi->w * (double)dci[0],
      qo_2 = ksl_product_sum(-(double)qi->z, (double)dci[1], qo_2a);
  const double qo_3a = (double)qi->z * (double)dci[0],
      qo_3 = ksl_product_sum((double)qi->w, (double)dci[1], qo_3a);
  qo->x = (float)qo_0;
  qo->y = (float)qo_1;
  qo->z = (float)qo_2;
  qo->w = (float)qo_3;
}

/* qo = qi* (s e_z; c)*, dci = (s, c), sine and cosine of half the angle.
   qi, qo: quaternion (x, y, z, w), the scalar last; dci: (sin θ, cos θ).
   8 mul, 4 add, 2 neg.
   Error <= u |result| + 1/16 u^2 S, S the sum of the |terms| of the expanded formula; barring
     over- and underflow. */
static inline void ksl_product_qconjqzconjf_accurate(const ksl_quaternionf_t *qi,
    const float dci[2], ksl_quaternionf_t *qo) {
  const double qo_0a = (double)qi->y * (double)dci[0],
      qo_0 = ksl_product_sum(-(double)qi->x, (double)dci[1], qo_0a);
  const double qo_1a = (double)qi->x * (double)dci[0], qo_1c_lead = -qo_1a,
      qo_1 = ksl_product_sum(-(double)qi->y, (double)dci[1], qo_1c_lead);
  const double qo_2a = (double)qi->z * (double)dci[1], qo_2c_lead = -qo_2a,
      qo_2 = ksl_product_sum(-(double)qi->w, (double)dci[0], qo_2c_lead);
  const double qo_3a = (double)qi->w * (double)dci[1],
      qo_3 = ksl_product_sum(-(double)qi->z, (double)dci[0], qo_3a);
  qo->x = (float)qo_0;
  qo->y = (float)qo_1;
  qo->z = (float)qo_2;
  qo->w = (float)qo_3;
}

/* qo = qi (vi; 0).
   qi, qo: quaternion (x, y, z, w), the scalar last; vi: vector.
   12 mul, 8 add, 1 neg.
   Error <= u |result| + 3/32 u^2 S, S the sum of the |terms| of the expanded formula; barring
     over- and underflow. */
static inline void ksl_product_qvf_accurate(const ksl_quaternionf_t *qi, const ksl_vec3f_t *vi,
    ksl_quaternionf_t *qo) {
  const double qo_0a = (double)qi->y * (double)vi->z,
      qo_0c = ksl_product_sum(-(double)qi->z, (double)vi->y, qo_0a),
      qo_0 = ksl_product_sum((double)qi->w, (double)vi->x, qo_0c);
  const double qo_1a = (double)qi->z * (double)vi->x,
      qo_1c = ksl_product_sum(-(double)qi->x, (double)vi->z, qo_1a),
      qo_1 = ksl_product_sum((double)qi->w, (double)vi->y, qo_1c);
  const double qo_2a = (double)qi->x * (double)vi->y,
      qo_2c = ksl_product_sum(-(double)qi->y, (double)vi->x, qo_2a),
      qo_2 = ksl_product_sum((double)qi->w, (double)vi->z, qo_2c);
  const double qo_3a = (double)qi->x * (double)vi->x, qo_3c_lead = -qo_3a,
      qo_3c = ksl_product_sum(-(double)qi->y, (double)vi->y, qo_3c_lead),
      qo_3 = ksl_product_sum(-(double)qi->z, (double)vi->z, qo_3c);
  qo->x = (float)qo_0;
  qo->y = (float)qo_1;
  qo->z = (float)qo_2;
  qo->w = (float)qo_3;
}

/* qo = qi* (vi; 0).
   qi, qo: quaternion (x, y, z, w), the scalar last; vi: vector.
   12 mul, 8 add.
   Error <= u |result| + 3/32 u^2 S, S the sum of the |terms| of the expanded formula; barring
     over- and underflow. */
static inline void ksl_product_qconjvf_accurate(const ksl_quaternionf_t *qi,
    const ksl_vec3f_t *vi, ksl_quaternionf_t *qo) {
  const double qo_0a = (double)qi->z * (double)vi->y,
      qo_0c = ksl_product_sum(-(double)qi->y, (double)vi->z, qo_0a),
      qo_0 = ksl_product_sum((double)qi->w, (double)vi->x, qo_0c);
  const double qo_1a = (double)qi->x * (double)vi->z,
      qo_1c = ksl_product_sum(-(double)qi->z, (double)vi->x, qo_1a),
      qo_1 = ksl_product_sum((double)qi->w, (double)vi->y, qo_1c);
  const double qo_2a = (double)qi->y * (double)vi->x,
      qo_2c = ksl_product_sum(-(double)qi->x, (double)vi->y, qo_2a),
      qo_2 = ksl_product_sum((double)qi->w, (double)vi->z, qo_2c);
  const double qo_3a = (double)qi->x * (double)vi->x,
      qo_3c = ksl_product_sum((double)qi->y, (double)vi->y, qo_3a),
      qo_3 = ksl_product_sum((double)qi->z, (double)vi->z, qo_3c);
  qo->x = (float)qo_0;
  qo->y = (float)qo_1;
  qo->z = (float)qo_2;
  qo->w = (float)qo_3;
}

/* qo = (vi; 0) qi.
   vi: vector; qi, qo: quaternion (x, y, z, w), the scalar last.
   12 mul, 8 add, 1 neg.
   Error <= u |result| + 3/32 u^2 S, S the sum of the |terms| of the expanded formula; barring
     over- and underflow. */
static inline void ksl_product_vqf_accurate(const ksl_vec3f_t *vi, const ksl_quaternionf_t *qi,
    ksl_quaternionf_t *qo) {
  const double qo_0b = (double)vi->y * (double)qi->z,
      qo_0d = ksl_product_sum(-(double)vi->z, (double)qi->y, qo_0b),
      qo_0 = ksl_product_sum((double)vi->x, (double)qi->w, qo_0d);
  const double qo_1a = (double)vi->z * (double)qi->x,
      qo_1c = ksl_product_sum(-(double)vi->x, (double)qi->z, qo_1a),
      qo_1 = ksl_product_sum((double)vi->y, (double)qi->w, qo_1c);
  const double qo_2a = (double)vi->x * (double)qi->y,
      qo_2c = ksl_product_sum(-(double)vi->y, (double)qi->x, qo_2a),
      qo_2 = ksl_product_sum((double)vi->z, (double)qi->w, qo_2c);
  const double qo_3a = (double)vi->x * (double)qi->x, qo_3c_lead = -qo_3a,
      qo_3c = ksl_product_sum(-(double)vi->y, (double)qi->y, qo_3c_lead),
      qo_3 = ksl_product_sum(-(double)vi->z, (double)qi->z, qo_3c);
  qo->x = (float)qo_0;
  qo->y = (float)qo_1;
  qo->z = (float)qo_2;
  qo->w = (float)qo_3;
}

/* qo = (vi; 0) qi*.
   vi: vector; qi, qo: quaternion (x, y, z, w), the scalar last.
   12 mul, 8 add.
   Error <= u |result| + 3/32 u^2 S, S the sum of the |terms| of the expanded formula; barring
     over- and underflow. */
static inline void ksl_product_vqconjf_accurate(const ksl_vec3f_t *vi,
    const ksl_quaternionf_t *qi, ksl_quaternionf_t *qo) {
  const double qo_0b = (double)vi->z * (double)qi->y,
      qo_0d = ksl_product_sum(-(double)vi->y, (double)qi->z, qo_0b),
      qo_0 = ksl_product_sum((double)vi->x, (double)qi->w, qo_0d);
  const double qo_1a = (double)vi->x * (double)qi->z,
      qo_1c = ksl_product_sum(-(double)vi->z, (double)qi->x, qo_1a),
      qo_1 = ksl_product_sum((double)vi->y, (double)qi->w, qo_1c);
  const double qo_2a = (double)vi->y * (double)qi->x,
      qo_2c = ksl_product_sum(-(double)vi->x, (double)qi->y, qo_2a),
      qo_2 = ksl_product_sum((double)vi->z, (double)qi->w, qo_2c);
  const double qo_3a = (double)vi->x * (double)qi->x,
      qo_3c = ksl_product_sum((double)vi->y, (double)qi->y, qo_3a),
      qo_3 = ksl_product_sum((double)vi->z, (double)qi->z, qo_3c);
  qo->x = (float)qo_0;
  qo->y = (float)qo_1;
  qo->z = (float)qo_2;
  qo->w = (float)qo_3;
}

/* q1i·q2i.
   q1i, q2i: quaternion (x, y, z, w), the scalar last.
   4 mul, 3 add.
   Error <= u |result| + 1/8 u^2 S, S the sum of the |terms| of the expanded formula; barring
     over- and underflow. */
static inline float ksl_dot_qqf_accurate(const ksl_quaternionf_t *q1i,
    const ksl_quaternionf_t *q2i) {
  const double dot_a = (double)q1i->x * (double)q2i->x,
      dot_c = ksl_product_sum((double)q1i->y, (double)q2i->y, dot_a),
      dot_e = ksl_product_sum((double)q1i->z, (double)q2i->z, dot_c),
      dot = ksl_product_sum((double)q1i->w, (double)q2i->w, dot_e);
  return (float)dot;
}

/* qi = qi + qi (dpi; 0) / 2: rotated by the small rotation vector dpi in the rotated frame, to
     first order; not normalized.
   dpi: vector; qi: quaternion (x, y, z, w), the scalar last.
   15 mul, 12 add.
   Error <= u |result| + 1/8 u^2 S, S the sum of the |terms| of the expanded formula; barring
     over- and underflow. */
static inline void ksl_add_dpiToqf_accurate(const ksl_vec3f_t *dpi, ksl_quaternionf_t *qi) {
  const double qi_0_new_a = 0.5 * (double)dpi->x, qi_0_new_b = KSL_MUL(qi_0_new_a, (double)qi->w),
      qi_0_new_c = 0.5 * (double)dpi->z, qi_0_new_d = KSL_MUL(qi_0_new_c, (double)qi->y),
      qi_0_new_e = 0.5 * (double)dpi->y, qi_0_new_f = KSL_MUL(qi_0_new_e, (double)qi->z),
      qi_0_new_g = qi_0_new_d - qi_0_new_f, qi_0_new_h = qi_0_new_b + qi_0_new_g,
      qi_0_new = qi_0_new_h + (double)qi->x;
  const double qi_1_new_a = KSL_MUL(qi_0_new_a, (double)qi->z),
      qi_1_new_b = KSL_MUL(qi_0_new_c, (double)qi->x), qi_1_new_c = qi_1_new_a - qi_1_new_b,
      qi_1_new_d = KSL_MUL(qi_0_new_e, (double)qi->w), qi_1_new_e = qi_1_new_c + qi_1_new_d,
      qi_1_new = qi_1_new_e + (double)qi->y;
  const double qi_2_new_a = KSL_MUL(qi_0_new_e, (double)qi->x),
      qi_2_new_b = KSL_MUL(qi_0_new_a, (double)qi->y), qi_2_new_c = qi_2_new_a - qi_2_new_b,
      qi_2_new_d = KSL_MUL(qi_0_new_c, (double)qi->w), qi_2_new_e = qi_2_new_c + qi_2_new_d,
      qi_2_new = qi_2_new_e + (double)qi->z;
  const double qi_3_new_a = KSL_MUL(qi_0_new_a, (double)qi->x),
      qi_3_new_b = KSL_MUL(qi_0_new_e, (double)qi->y), qi_3_new_c = qi_3_new_a + qi_3_new_b,
      qi_3_new_d = KSL_MUL(qi_0_new_c, (double)qi->z), qi_3_new_e = qi_3_new_c + qi_3_new_d,
      qi_3_new = (double)qi->w - qi_3_new_e;
  qi->x = (float)qi_0_new;
  qi->y = (float)qi_1_new;
  qi->z = (float)qi_2_new;
  qi->w = (float)qi_3_new;
}

/* qi = qi - qi (dpi; 0) / 2, the opposite of add_dpiToq to first order.
   dpi: vector; qi: quaternion (x, y, z, w), the scalar last.
   15 mul, 12 add.
   Error <= u |result| + 1/8 u^2 S, S the sum of the |terms| of the expanded formula; barring
     over- and underflow. */
static inline void ksl_subtract_dpiFromqf_accurate(const ksl_vec3f_t *dpi, ksl_quaternionf_t *qi) {
  const double qi_0_new_a = 0.5 * (double)dpi->y, qi_0_new_b = KSL_MUL(qi_0_new_a, (double)qi->z),
      qi_0_new_c = 0.5 * (double)dpi->z, qi_0_new_d = KSL_MUL(qi_0_new_c, (double)qi->y),
      qi_0_new_e = qi_0_new_b - qi_0_new_d, qi_0_new_f = 0.5 * (double)dpi->x,
      qi_0_new_g = KSL_MUL(qi_0_new_f, (double)qi->w), qi_0_new_h = qi_0_new_e - qi_0_new_g,
      qi_0_new = qi_0_new_h + (double)qi->x;
  const double qi_1_new_a = KSL_MUL(qi_0_new_c, (double)qi->x),
      qi_1_new_b = KSL_MUL(qi_0_new_f, (double)qi->z), qi_1_new_c = qi_1_new_a - qi_1_new_b,
      qi_1_new_d = KSL_MUL(qi_0_new_a, (double)qi->w), qi_1_new_e = qi_1_new_c - qi_1_new_d,
      qi_1_new = qi_1_new_e + (double)qi->y;
  const double qi_2_new_a = KSL_MUL(qi_0_new_f, (double)qi->y),
      qi_2_new_b = KSL_MUL(qi_0_new_a, (double)qi->x), qi_2_new_c = qi_2_new_a - qi_2_new_b,
      qi_2_new_d = KSL_MUL(qi_0_new_c, (double)qi->w), qi_2_new_e = qi_2_new_c - qi_2_new_d,
      qi_2_new = qi_2_new_e + (double)qi->z;
  const double qi_3_new_a = KSL_MUL(qi_0_new_f, (double)qi->x),
      qi_3_new_b = KSL_MUL(qi_0_new_a, (double)qi->y), qi_3_new_c = qi_3_new_a + qi_3_new_b,
      qi_3_new_d = KSL_MUL(qi_0_new_c, (double)qi->z), qi_3_new_e = qi_3_new_c + qi_3_new_d,
      qi_3_new = qi_3_new_e + (double)qi->w;
  qi->x = (float)qi_0_new;
  qi->y = (float)qi_1_new;
  qi->z = (float)qi_2_new;
  qi->w = (float)qi_3_new;
}

/* dqo = (w; 0) qi / 2 + (1 - qi·qi) qi: the rate of qi for the angular velocity w in the
     reference frame, rad/s, and a term that draws its norm to 1.
   w: vector; qi, dqo: quaternion (x, y, z, w), the scalar last.
   23 mul, 16 add, 1 neg.
   Error <= u |result| + 7/32 u^2 S, S the sum of the |terms| of the expanded formula; barring
     over- and underflow. */
static inline void ksl_omega_to_dquaternionf_accurate(const ksl_vec3f_t *w,
    const ksl_quaternionf_t *qi, ksl_quaternionf_t *dqo) {
  const double dqo_0a = 0.5 * (double)w->x, dqo_0b = KSL_MUL(dqo_0a, (double)qi->w),
      dqo_0c = 0.5 * (double)w->y, dqo_0d = KSL_MUL(dqo_0c, (double)qi->z),
      dqo_0e = 0.5 * (double)w->z, dqo_0f = KSL_MUL(dqo_0e, (double)qi->y),
      dqo_0g = dqo_0d - dqo_0f, dqo_0h = dqo_0b + dqo_0g,
      dqo_0j = ksl_product_sum(-(double)qi->x, (double)qi->x, 1.0),
      dqo_0l = ksl_product_sum(-(double)qi->y, (double)qi->y, dqo_0j),
      dqo_0n = ksl_product_sum(-(double)qi->z, (double)qi->z, dqo_0l),
      dqo_0p = ksl_product_sum(-(double)qi->w, (double)qi->w, dqo_0n),
      dqo_0q = KSL_MUL((double)qi->x, dqo_0p), dqo_0 = dqo_0h + dqo_0q;
  const double dqo_1a = KSL_MUL(dqo_0e, (double)qi->x), dqo_1b = KSL_MUL(dqo_0a, (double)qi->z),
      dqo_1c = dqo_1a - dqo_1b, dqo_1d = KSL_MUL(dqo_0c, (double)qi->w), dqo_1e = dqo_1c + dqo_1d,
      dqo_1f = KSL_MUL((double)qi->y, dqo_0p), dqo_1 = dqo_1e + dqo_1f;
  const double dqo_2a = KSL_MUL(dqo_0a, (double)qi->y), dqo_2b = KSL_MUL(dqo_0c, (double)qi->x),
      dqo_2c = dqo_2a - dqo_2b, dqo_2d = KSL_MUL(dqo_0e, (double)qi->w), dqo_2e = dqo_2c + dqo_2d,
      dqo_2f = KSL_MUL((double)qi->z, dqo_0p), dqo_2 = dqo_2e + dqo_2f;
  const double dqo_3a = KSL_MUL((double)qi->w, dqo_0p), dqo_3b = KSL_MUL(dqo_0a, (double)qi->x),
      dqo_3c = KSL_MUL(dqo_0c, (double)qi->y), dqo_3d_lead = -dqo_3b, dqo_3d = dqo_3d_lead - dqo_3c,
      dqo_3e = KSL_MUL(dqo_0e, (double)qi->z), dqo_3f = dqo_3d - dqo_3e, dqo_3 = dqo_3f + dqo_3a;
  dqo->x = (float)dqo_0;
  dqo->y = (float)dqo_1;
  dqo->z = (float)dqo_2;
  dqo->w = (float)dqo_3;
}

/* R = I + 2 (w v~ + v~^2) / q·q, for any nonzero q whose square neither over- nor underflows.
   q: quaternion (x, y, z, w), the scalar last; R: rotation or other 3×3 matrix.
   20 mul, 16 add, 1 div.
   Error <= R: 1 u of its largest component for 2^-450 < |q| < 2^511, in single precision 2^-45 <
     |q| < 2^63; searched, not proved.  Each component is within 1 ulp as long as its condition
     is below 1e13; in single precision it is the nearest number, except near ties, as long as
     that is below 1e5; searched, not proved. */
static inline void ksl_mat3x3f_from_quaternion_accurate(const ksl_quaternionf_t *q,
    ksl_mat3x3f_t *R) {
  const double squares_0 = (double)q->w * (double)q->w;
  const double squares_1 = (double)q->x * (double)q->x;
  const double squares_2 = (double)q->y * (double)q->y;
  const double squares_3 = (double)q->z * (double)q->z;
  const double pairs_0 = squares_0 + squares_1;
  const double pairs_1 = squares_2 + squares_3;
  const double pairs_2 = squares_0 + squares_2;
  const double pairs_3 = squares_1 + squares_3;
  const double pairs_4 = squares_0 + squares_3;
  const double pairs_5 = squares_1 + squares_2;
  const double square = pairs_0 + pairs_1;
  const double factor = 1.0 / square;
  const double d0 = pairs_0 - pairs_1;
  const double d1 = pairs_2 - pairs_3;
  const double d2 = pairs_4 - pairs_5;
  const double twice = KSL_MUL(2.0, factor);
  const double m_0a = (double)q->x * (double)q->y, m_0b = (double)q->z * (double)q->w,
      m_0 = m_0a - m_0b;
  const double m_1a = (double)q->x * (double)q->z, m_1b = (double)q->y * (double)q->w,
      m_1 = m_1a + m_1b;
  const double m_2a = (double)q->y * (double)q->z, m_2b = (double)q->x * (double)q->w,
      m_2 = m_2a - m_2b;
  const double m_3 = m_0a + m_0b;
  const double m_4 = m_1a - m_1b;
  const double m_5 = m_2b + m_2a;
  const double R_00 = KSL_MUL(factor, d0);
  const double R_01 = KSL_MUL(twice, m_0);
  const double R_02 = KSL_MUL(twice, m_1);
  const double R_10 = KSL_MUL(twice, m_3);
  const double R_11 = KSL_MUL(factor, d1);
  const double R_12 = KSL_MUL(twice, m_2);
  const double R_20 = KSL_MUL(twice, m_4);
  const double R_21 = KSL_MUL(twice, m_5);
  const double R_22 = KSL_MUL(factor, d2);
  R->m00 = (float)R_00;
  R->m01 = (float)R_01;
  R->m02 = (float)R_02;
  R->m10 = (float)R_10;
  R->m11 = (float)R_11;
  R->m12 = (float)R_12;
  R->m20 = (float)R_20;
  R->m21 = (float)R_21;
  R->m22 = (float)R_22;
}

/* qo with R(qo) = R and w >= 0; if R is not quite a rotation, its defect carries over to qo.
   R: rotation or other 3×3 matrix; qo: quaternion (x, y, z, w), the scalar last.
   4 mul, 17 add, 4 div, 1 sqrt, 5 neg, 4 less, 16 select.
   Error <= qo: 1 u of its largest component for R a rotation; searched, not proved.  Each
     component is within 1 ulp as long as its condition is below 1e13; in single precision it is
     the nearest number, except near ties, as long as that is below 1e5; searched, not proved. */
static inline void ksl_quaternionf_from_mat3x3_accurate(const ksl_mat3x3f_t *R,
    ksl_quaternionf_t *qo) {
  const double p_0 = (double)R->m21 - (double)R->m12;
  const double p_1 = (double)R->m02 - (double)R->m20;
  const double p_2 = (double)R->m10 - (double)R->m01;
  const double s_0 = (double)R->m12 + (double)R->m21;
  const double s_1 = (double)R->m02 + (double)R->m20;
  const double s_2 = (double)R->m01 + (double)R->m10;
  const double first_0 = (double)R->m00 + 1.0;
  const double first_1 = 1.0 - (double)R->m00;
  const double others_0 = (double)R->m11 + (double)R->m22;
  const double others_1 = (double)R->m11 - (double)R->m22;
  const double d_0 = first_0 + others_0;
  const double d_1 = first_0 - others_0;
  const double d_2 = first_1 + others_1;
  const double d_3 = first_1 - others_1;
  const double low_0 = (double)R->m11 < (double)R->m00 ? d_1 : s_2;
  const double low_1 = (double)R->m11 < (double)R->m00 ? s_2 : d_2;
  const double low_2 = (double)R->m11 < (double)R->m00 ? s_1 : s_0;
  const double low_3 = (double)R->m11 < (double)R->m00 ? p_0 : p_1;
  const double high_0a = -(double)R->m11, high_0 = (double)R->m00 < high_0a ? s_1 : p_0;
  const double high_1 = (double)R->m00 < high_0a ? s_0 : p_1;
  const double high_2 = (double)R->m00 < high_0a ? d_3 : p_2;
  const double high_3 = (double)R->m00 < high_0a ? p_2 : d_0;
  const double column_0 = (double)R->m22 < 0.0 ? low_0 : high_0;
  const double column_1 = (double)R->m22 < 0.0 ? low_1 : high_1;
  const double column_2 = (double)R->m22 < 0.0 ? low_2 : high_2;
  const double column_3 = (double)R->m22 < 0.0 ? low_3 : high_3;
  const double upper_0a = -column_0, upper_0 = column_3 < 0.0 ? upper_0a : column_0;
  const double upper_1a = -column_1, upper_1 = column_3 < 0.0 ? upper_1a : column_1;
  const double upper_2a = -column_2, upper_2 = column_3 < 0.0 ? upper_2a : column_2;
  const double upper_3a = -column_3, upper_3 = column_3 < 0.0 ? upper_3a : column_3;
  const double length_a = KSL_MUL(upper_0, upper_0), length_b = KSL_MUL(upper_1, upper_1),
      length_c = length_a + length_b, length_d = KSL_MUL(upper_2, upper_2),
      length_e = length_c + length_d, length_f = KSL_MUL(upper_3, upper_3),
      length_g = length_e + length_f, length = sqrt(length_g);
  const double qo_0 = upper_0 / length;
  const double qo_1 = upper_1 / length;
  const double qo_2 = upper_2 / length;
  const double qo_3 = upper_3 / length;
  qo->x = (float)qo_0;
  qo->y = (float)qo_1;
  qo->z = (float)qo_2;
  qo->w = (float)qo_3;
}

/* qo = (axis sin angle/2; cos angle/2); axis of length 1: with another |qo| is not 1, and its
     rotation is by another angle.
   axis: vector; angle: number; qo: quaternion (x, y, z, w), the scalar last.
   32 mul, 33 add, 1 abs.
   Error <= qo: 1 u of its largest component for |axis| = 1; searched, not proved.  Each
     component is within 1 ulp as long as its condition is below 1e13; in single precision it is
     the nearest number, except near ties, as long as that is below 1e5; searched, not proved. */
static inline void ksl_quaternionf_from_axis_angle_accurate(const ksl_vec3f_t *axis,
    const float angle, ksl_quaternionf_t *qo) {
  const double half = 0.5 * (double)angle;
  double qo_3; const double sine = ksl_sincos(half, &qo_3);
  const double qo_0 = KSL_MUL((double)axis->x, sine);
  const double qo_1 = KSL_MUL((double)axis->y, sine);
  const double qo_2 = KSL_MUL((double)axis->z, sine);
  qo->x = (float)qo_0;
  qo->y = (float)qo_1;
  qo->z = (float)qo_2;
  qo->w = (float)qo_3;
}

/* angle = 2 atan2(|v|, |w|), axis = ±v / |v|; 0 <= angle <= π; the axis is (1, 0, 0) if the
     angle is 0; any multiple of a quaternion.
   q: quaternion (x, y, z, w), the scalar last; axis: vector.
   41 mul, 37 add, 4 div, 1 sqrt, 5 neg, 9 abs, 2 copysign, 19 less, 2 equal, 32 select.
   Error <= angle: 1 u, axis: 1 u of its largest component; searched, not proved.  Each component
     is within 1 ulp as long as its condition is below 1e13; in single precision it is the
     nearest number, except near ties, as long as that is below 1e5; searched, not proved. */
static inline float ksl_axis_angle_from_quaternionf_accurate(const ksl_quaternionf_t *q,
    ksl_vec3f_t *axis) {
  const double s_size_0 = fabs((double)q->x);
  const double s_size_1 = fabs((double)q->y);
  const double s_size_2 = fabs((double)q->z);
  const double s_size_3 = fabs((double)q->w);
  const double s_largest1 = s_size_0 < s_size_1 ? s_size_1 : s_size_0;
  const double s_largest2 = s_largest1 < s_size_2 ? s_size_2 : s_largest1;
  const double s_largest3 = s_largest2 < s_size_3 ? s_size_3 : s_largest2;
  const double s_b = 4.611686018427388e+18 < s_largest3 ? 2.710505431213761e-20 : 1.0,
      s_d = s_largest3 < 256.0 ? 1.8014398509481984e+16 : s_b,
      s = s_largest3 < 1.4210854715202004e-14 ? 3.2451855365842673e+32 : s_d;
  const double scaled_s_0 = KSL_MUL((double)q->x, s);
  const double scaled_s_1 = KSL_MUL((double)q->y, s);
  const double scaled_s_2 = KSL_MUL((double)q->z, s);
  const double scaled_s_3 = KSL_MUL((double)q->w, s);
  const double upper_0a = -scaled_s_0, upper_0 = scaled_s_3 < 0.0 ? upper_0a : scaled_s_0;
  const double upper_1a = -scaled_s_1, upper_1 = scaled_s_3 < 0.0 ? upper_1a : scaled_s_1;
  const double upper_2a = -scaled_s_2, upper_2 = scaled_s_3 < 0.0 ? upper_2a : scaled_s_2;
  const double upper_3a = -scaled_s_3, upper_3 = scaled_s_3 < 0.0 ? upper_3a : scaled_s_3;
  const double v_s_size_0 = fabs(upper_0);
  const double v_s_size_1 = fabs(upper_1);
  const double v_s_size_2 = fabs(upper_2);
  const double v_s_largest1 = v_s_size_0 < v_s_size_1 ? v_s_size_1 : v_s_size_0;
  const double v_s_largest2 = v_s_largest1 < v_s_size_2 ? v_s_size_2 : v_s_largest1;
  const double v_s_b = v_s_largest2 < 256.0 ? 1.8014398509481984e+16 : 1.0,
      v_s = v_s_largest2 < 1.4210854715202004e-14 ? 3.2451855365842673e+32 : v_s_b;
  const double v_y_0 = KSL_MUL(upper_0, v_s);
  const double v_y_1 = KSL_MUL(upper_1, v_s);
  const double v_y_2 = KSL_MUL(upper_2, v_s);
  const double v_n_a = KSL_MUL(v_y_0, v_y_0), v_n_b = KSL_MUL(v_y_1, v_y_1), v_n_c = v_n_a + v_n_b,
      v_n_d = KSL_MUL(v_y_2, v_y_2), v_n_e = v_n_c + v_n_d, v_n = sqrt(v_n_e);
  const double v_r_b = 1.0 < v_s ? 5.551115123125783e-17 : 1.0,
      v_r = 1.8014398509481984e+16 < v_s ? 3.0814879110195774e-33 : v_r_b;
  const double n = KSL_MUL(v_n, v_r);
  const double half = ksl_atan2(n, upper_3);
  const double divisor = v_n == 0.0 ? 1.0 : v_n;
  const double unit_0 = v_y_0 / divisor;
  const double unit_1 = v_y_1 / divisor;
  const double unit_2 = v_y_2 / divisor;
  const double angle = KSL_MUL(2.0, half);
  const double axis_0 = v_n == 0.0 ? 1.0 : unit_0;
  axis->x = (float)axis_0;
  axis->y = (float)unit_1;
  axis->z = (float)unit_2;
  return (float)angle;
}

/* qo = exp (v/2; 0) = (v/θ sin θ/2; cos θ/2), θ = |v|: turns by the rotation vector v.
   v: vector; qo: quaternion (x, y, z, w), the scalar last.
   43 mul, 36 add, 1 div, 1 sqrt, 4 abs, 5 less, 6 select.
   Error <= qo: 1 u of its largest component for |v| <= 1e13, in single precision 1e5; searched,
     not proved.  Each component is within 1 ulp as long as its condition is below 1e13; in
     single precision it is the nearest number, except near ties, as long as that is below 1e5;
     searched, not proved. */
static inline void ksl_quaternionf_exp_accurate(const ksl_vec3f_t *v, ksl_quaternionf_t *qo) {
  const double h_0 = 0.5 * (double)v->x;
  const double h_1 = 0.5 * (double)v->y;
  const double h_2 = 0.5 * (double)v->z;
  const double h_size_0 = fabs(h_0);
  const double h_size_1 = fabs(h_1);
  const double h_size_2 = fabs(h_2);
  const double h_largest1 = h_size_0 < h_size_1 ? h_size_1 : h_size_0;
  const double h_largest2 = h_largest1 < h_size_2 ? h_size_2 : h_largest1;
  const double s = 4.611686018427388e+18 < h_largest2 ? 2.710505431213761e-20 : 1.0;
  const double reduced_0 = KSL_MUL(h_0, s);
  const double reduced_1 = KSL_MUL(h_1, s);
  const double reduced_2 = KSL_MUL(h_2, s);
  const double up = s < 1.0 ? 3.6893488147419103e+19 : 1.0;
  const double reduced_length_a = KSL_MUL(reduced_0, reduced_0),
      reduced_length_b = KSL_MUL(reduced_1, reduced_1),
      reduced_length_c = reduced_length_a + reduced_length_b,
      reduced_length_d = KSL_MUL(reduced_2, reduced_2),
      reduced_length_e = reduced_length_c + reduced_length_d,
      reduced_length = sqrt(reduced_length_e);
  const double half_angle = KSL_MUL(reduced_length, up);
  const double y = KSL_MUL(half_angle, half_angle);
  double c; const double sine = ksl_sincos(half_angle, &c);
  const double sinc_divisor = half_angle < 1.4901161193847656e-08 ? 1.4901161193847656e-08 :
      half_angle;
  const double sinc_quotient = sine / sinc_divisor;
  const double sinc_a = KSL_MUL(0.16666666666666666, y), sinc_b = 1.0 - sinc_a,
      sinc = half_angle < 1.4901161193847656e-08 ? sinc_b : sinc_quotient;
  const double qo_0 = KSL_MUL(h_0, sinc);
  const double qo_1 = KSL_MUL(h_1, sinc);
  const double qo_2 = KSL_MUL(h_2, sinc);
  qo->x = (float)qo_0;
  qo->y = (float)qo_1;
  qo->z = (float)qo_2;
  qo->w = (float)c;
}

/* vo = θ v/|v|, θ = 2 atan2(|v|, |w|) <= π: the rotation vector of q, or of any multiple of it.
   q: quaternion (x, y, z, w), the scalar last; vo: vector.
   44 mul, 37 add, 2 div, 1 sqrt, 5 neg, 9 abs, 2 copysign, 19 less, 2 equal, 31 select.
   Error <= vo: 1 u of its largest component; searched, not proved.  Each component is within 1
     ulp as long as its condition is below 1e13; in single precision it is the nearest number,
     except near ties, as long as that is below 1e5; searched, not proved. */
static inline void ksl_quaternionf_log_accurate(const ksl_quaternionf_t *q, ksl_vec3f_t *vo) {
  const double s_size_0 = fabs((double)q->x);
  const double s_size_1 = fabs((double)q->y);
  const double s_size_2 = fabs((double)q->z);
  const double s_size_3 = fabs((double)q->w);
  const double s_largest1 = s_size_0 < s_size_1 ? s_size_1 : s_size_0;
  const double s_largest2 = s_largest1 < s_size_2 ? s_size_2 : s_largest1;
  const double s_largest3 = s_largest2 < s_size_3 ? s_size_3 : s_largest2;
  const double s_b = 4.611686018427388e+18 < s_largest3 ? 2.710505431213761e-20 : 1.0,
      s_d = s_largest3 < 256.0 ? 1.8014398509481984e+16 : s_b,
      s = s_largest3 < 1.4210854715202004e-14 ? 3.2451855365842673e+32 : s_d;
  const double scaled_s_0 = KSL_MUL((double)q->x, s);
  const double scaled_s_1 = KSL_MUL((double)q->y, s);
  const double scaled_s_2 = KSL_MUL((double)q->z, s);
  const double scaled_s_3 = KSL_MUL((double)q->w, s);
  const double upper_0a = -scaled_s_0, upper_0 = scaled_s_3 < 0.0 ? upper_0a : scaled_s_0;
  const double upper_1a = -scaled_s_1, upper_1 = scaled_s_3 < 0.0 ? upper_1a : scaled_s_1;
  const double upper_2a = -scaled_s_2, upper_2 = scaled_s_3 < 0.0 ? upper_2a : scaled_s_2;
  const double upper_3a = -scaled_s_3, upper_3 = scaled_s_3 < 0.0 ? upper_3a : scaled_s_3;
  const double v_s_size_0 = fabs(upper_0);
  const double v_s_size_1 = fabs(upper_1);
  const double v_s_size_2 = fabs(upper_2);
  const double v_s_largest1 = v_s_size_0 < v_s_size_1 ? v_s_size_1 : v_s_size_0;
  const double v_s_largest2 = v_s_largest1 < v_s_size_2 ? v_s_size_2 : v_s_largest1;
  const double v_s_b = v_s_largest2 < 256.0 ? 1.8014398509481984e+16 : 1.0,
      v_s = v_s_largest2 < 1.4210854715202004e-14 ? 3.2451855365842673e+32 : v_s_b;
  const double v_y_0 = KSL_MUL(upper_0, v_s);
  const double v_y_1 = KSL_MUL(upper_1, v_s);
  const double v_y_2 = KSL_MUL(upper_2, v_s);
  const double v_n_a = KSL_MUL(v_y_0, v_y_0), v_n_b = KSL_MUL(v_y_1, v_y_1), v_n_c = v_n_a + v_n_b,
      v_n_d = KSL_MUL(v_y_2, v_y_2), v_n_e = v_n_c + v_n_d, v_n = sqrt(v_n_e);
  const double v_r_b = 1.0 < v_s ? 5.551115123125783e-17 : 1.0,
      v_r = 1.8014398509481984e+16 < v_s ? 3.0814879110195774e-33 : v_r_b;
  const double n = KSL_MUL(v_n, v_r);
  const double half = ksl_atan2(n, upper_3);
  const double divisor = n == 0.0 ? 1.0 : n;
  const double theta = KSL_MUL(2.0, half);
  const double k = theta / divisor;
  const double vector_0 = KSL_MUL(upper_0, k);
  const double vector_1 = KSL_MUL(upper_1, k);
  const double vector_2 = KSL_MUL(upper_2, k);
  vo->x = (float)vector_0;
  vo->y = (float)vector_1;
  vo->z = (float)vector_2;
}

/* qo = q1 (q1* q2)^k along the shorter arc: q1 at k = 0, ±q2 at k = 1; |q1| = |q2| = 1.
   q1, q2, qo: quaternion (x, y, z, w), the scalar last; k: number.
   114 mul, 97 add, 3 div, 2 sqrt, 5 neg, 10 abs, 2 copysign, 20 less, 2 equal, 32 select.
   Error <= qo: 1 u of its largest component for |q1| = 1 and |q2| = 1 and 0 <= k <= 1; searched,
     not proved.  Each component is within 1 ulp as long as its condition is below 1e13; in
     single precision it is the nearest number, except near ties, as long as that is below 1e5;
     searched, not proved. */
static inline void ksl_quaternionf_interpolated_accurate(const ksl_quaternionf_t *q1,
    const ksl_quaternionf_t *q2, const float k, ksl_quaternionf_t *qo) {
  const double between_0a = (double)q1->w * (double)q2->x,
      between_0c = ksl_product_sum(-(double)q1->x, (double)q2->w, between_0a),
      between_0d = (double)q1->z * (double)q2->y,
      between_0f = ksl_product_sum(-(double)q1->y, (double)q2->z, between_0d),
      between_0 = between_0c + between_0f;
  const double between_1a = (double)q1->x * (double)q2->z,
      between_1c = ksl_product_sum(-(double)q1->z, (double)q2->x, between_1a),
      between_1d = (double)q1->w * (double)q2->y,
      between_1f = ksl_product_sum(-(double)q1->y, (double)q2->w, between_1d),
      between_1 = between_1c + between_1f;
  const double between_2a = (double)q1->y * (double)q2->x,
      between_2c = ksl_product_sum(-(double)q1->x, (double)q2->y, between_2a),
      between_2d = (double)q1->w * (double)q2->z,
      between_2f = ksl_product_sum(-(double)q1->z, (double)q2->w, between_2d),
      between_2 = between_2c + between_2f;
  const double between_3a = (double)q1->x * (double)q2->x,
      between_3c = ksl_product_sum((double)q1->y, (double)q2->y, between_3a),
      between_3e = ksl_product_sum((double)q1->z, (double)q2->z, between_3c),
      between_3 = ksl_product_sum((double)q1->w, (double)q2->w, between_3e);
  const double upper_0a = -between_0, upper_0 = between_3 < 0.0 ? upper_0a : between_0;
  const double upper_1a = -between_1, upper_1 = between_3 < 0.0 ? upper_1a : between_1;
  const double upper_2a = -between_2, upper_2 = between_3 < 0.0 ? upper_2a : between_2;
  const double upper_3 = fabs(between_3);
  const double v_s_size_0 = fabs(upper_0);
  const double v_s_size_1 = fabs(upper_1);
  const double v_s_size_2 = fabs(upper_2);
  const double v_s_largest1 = v_s_size_0 < v_s_size_1 ? v_s_size_1 : v_s_size_0;
  const double v_s_largest2 = v_s_largest1 < v_s_size_2 ? v_s_size_2 : v_s_largest1;
  const double v_s_b = 4.611686018427388e+18 < v_s_largest2 ? 2.710505431213761e-20 : 1.0,
      v_s_d = v_s_largest2 < 256.0 ? 1.8014398509481984e+16 : v_s_b,
      v_s = v_s_largest2 < 1.4210854715202004e-14 ? 3.2451855365842673e+32 : v_s_d;
  const double v_y_0 = KSL_MUL(upper_0, v_s);
  const double v_y_1 = KSL_MUL(upper_1, v_s);
  const double v_y_2 = KSL_MUL(upper_2, v_s);
  const double v_n_a = KSL_MUL(v_y_0, v_y_0), v_n_b = KSL_MUL(v_y_1, v_y_1), v_n_c = v_n_a + v_n_b,
      v_n_d = KSL_MUL(v_y_2, v_y_2), v_n_e = v_n_c + v_n_d, v_n = sqrt(v_n_e);
  const double v_r_b = v_s < 1.0 ? 3.6893488147419103e+19 : 1.0,
      v_r_d = 1.0 < v_s ? 5.551115123125783e-17 : v_r_b,
      v_r = 1.8014398509481984e+16 < v_s ? 3.0814879110195774e-33 : v_r_d;
  const double n = KSL_MUL(v_n, v_r);
  const double half = ksl_atan2(n, upper_3);
  const double divisor = n == 0.0 ? 1.0 : n;
  const double rate = half / divisor;
  const double kv_0 = KSL_MUL((double)k, upper_0);
  const double kv_1 = KSL_MUL((double)k, upper_1);
  const double kv_2 = KSL_MUL((double)k, upper_2);
  const double step_0 = KSL_MUL(rate, kv_0);
  const double step_1 = KSL_MUL(rate, kv_1);
  const double step_2 = KSL_MUL(rate, kv_2);
  const double exp_h_size_0 = fabs(step_0);
  const double exp_h_size_1 = fabs(step_1);
  const double exp_h_size_2 = fabs(step_2);
  const double exp_h_largest1 = exp_h_size_0 < exp_h_size_1 ? exp_h_size_1 : exp_h_size_0;
  const double exp_h_largest2 = exp_h_largest1 < exp_h_size_2 ? exp_h_size_2 : exp_h_largest1;
  const double exp_s = 4.611686018427388e+18 < exp_h_largest2 ? 2.710505431213761e-20 : 1.0;
  const double exp_reduced_0 = KSL_MUL(step_0, exp_s);
  const double exp_reduced_1 = KSL_MUL(step_1, exp_s);
  const double exp_reduced_2 = KSL_MUL(step_2, exp_s);
  const double exp_up = exp_s < 1.0 ? 3.6893488147419103e+19 : 1.0;
  const double exp_reduced_length_a = KSL_MUL(exp_reduced_0, exp_reduced_0),
      exp_reduced_length_b = KSL_MUL(exp_reduced_1, exp_reduced_1),
      exp_reduced_length_c = exp_reduced_length_a + exp_reduced_length_b,
      exp_reduced_length_d = KSL_MUL(exp_reduced_2, exp_reduced_2),
      exp_reduced_length_e = exp_reduced_length_c + exp_reduced_length_d,
      exp_reduced_length = sqrt(exp_reduced_length_e);
  const double exp_half_angle = KSL_MUL(exp_reduced_length, exp_up);
  const double exp_y = KSL_MUL(exp_half_angle, exp_half_angle);
  double exp_c; const double exp_sine = ksl_sincos(exp_half_angle, &exp_c);
  const double exp_sinc_divisor = exp_half_angle < 1.4901161193847656e-08 ? 1.4901161193847656e-08 :
      exp_half_angle;
  const double exp_sinc_quotient = exp_sine / exp_sinc_divisor;
  const double exp_sinc_a = KSL_MUL(0.16666666666666666, exp_y), exp_sinc_b = 1.0 - exp_sinc_a,
      exp_sinc = exp_half_angle < 1.4901161193847656e-08 ? exp_sinc_b : exp_sinc_quotient;
  const double power_0 = KSL_MUL(step_0, exp_sinc);
  const double power_1 = KSL_MUL(step_1, exp_sinc);
  const double power_2 = KSL_MUL(step_2, exp_sinc);
  const double qo_0a = KSL_MUL((double)q1->x, exp_c), qo_0b = KSL_MUL((double)q1->y, power_2),
      qo_0c = KSL_MUL((double)q1->z, power_1), qo_0d = qo_0b - qo_0c, qo_0e = qo_0a + qo_0d,
      qo_0f = KSL_MUL((double)q1->w, power_0), qo_0 = qo_0e + qo_0f;
  const double qo_1a = KSL_MUL((double)q1->z, power_0), qo_1b = KSL_MUL((double)q1->x, power_2),
      qo_1c = qo_1a - qo_1b, qo_1d = KSL_MUL((double)q1->y, exp_c), qo_1e = qo_1c + qo_1d,
      qo_1f = KSL_MUL((double)q1->w, power_1), qo_1 = qo_1e + qo_1f;
  const double qo_2a = KSL_MUL((double)q1->x, power_1), qo_2b = KSL_MUL((double)q1->y, power_0),
      qo_2c = qo_2a - qo_2b, qo_2d = KSL_MUL((double)q1->z, exp_c), qo_2e = qo_2c + qo_2d,
      qo_2f = KSL_MUL((double)q1->w, power_2), qo_2 = qo_2e + qo_2f;
  const double qo_3a = KSL_MUL((double)q1->w, exp_c), qo_3b = KSL_MUL((double)q1->x, power_0),
      qo_3c = KSL_MUL((double)q1->y, power_1), qo_3d_lead = -qo_3b, qo_3d = qo_3d_lead - qo_3c,
      qo_3e = KSL_MUL((double)q1->z, power_2), qo_3f = qo_3d - qo_3e, qo_3 = qo_3f + qo_3a;
  qo->x = (float)qo_0;
  qo->y = (float)qo_1;
  qo->z = (float)qo_2;
  qo->w = (float)qo_3;
}

#endif
