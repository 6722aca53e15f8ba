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
  const double self_0_new = KSL_MUL(self->x, a), self_1_new = KSL_MUL(self->y, a),
      self_2_new = KSL_MUL(self->z, a), self_3_new = KSL_MUL(self->w, a);
  const double self_0_new_rounded = self_0_new + ksl_product_error(self->x, a, self_0_new),
      self_1_new_rounded = self_1_new + ksl_product_error(self->y, a, self_1_new),
      self_2_new_rounded = self_2_new + ksl_product_error(self->z, a, self_2_new),
      self_3_new_rounded = self_3_new + ksl_product_error(self->w, a, self_3_new);
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
      y_0_new_right = y_0_new - y_0_new_a;
  const double y_1_new_a = KSL_MUL(a, x->y), y_1_new = y_1_new_a + y->y,
      y_1_new_right = y_1_new - y_1_new_a;
  const double y_2_new_a = KSL_MUL(a, x->z), y_2_new = y_2_new_a + y->z,
      y_2_new_right = y_2_new - y_2_new_a;
  const double y_3_new_a = KSL_MUL(a, x->w), y_3_new = y_3_new_a + y->w,
      y_3_new_right = y_3_new - y_3_new_a;
  const double y_0_new_rounded = y_0_new
          + (ksl_product_rest(a, x->x, y_0_new_a, y_0_new - y_0_new_right)
          + (y->x - y_0_new_right)),
      y_1_new_rounded = y_1_new
          + (ksl_product_rest(a, x->y, y_1_new_a, y_1_new - y_1_new_right)
          + (y->y - y_1_new_right)),
      y_2_new_rounded = y_2_new
          + (ksl_product_rest(a, x->z, y_2_new_a, y_2_new - y_2_new_right)
          + (y->z - y_2_new_right)),
      y_3_new_rounded = y_3_new
          + (ksl_product_rest(a, x->w, y_3_new_a, y_3_new - y_3_new_right)
          + (y->w - y_3_new_right));
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
  const double s_size_0 = fabs(q->x), s_size_1 = fabs(q->y), s_size_2 = fabs(q->z),
      s_size_3 = fabs(q->w);
  const double s_largest1 = s_size_0 < s_size_1 ? s_size_1 : s_size_0;
  const double s_largest2 = s_largest1 < s_size_2 ? s_size_2 : s_largest1;
  const double s_largest3 = s_largest2 < s_size_3 ? s_size_3 : s_largest2;
  const double s_b = 6.703903964971299e+153 < s_largest3 ? 3.7291703656001034e-155 : 1.0,
      s_d = s_largest3 < 256.0 ? 1.3093562431584567e+151 : s_b,
      s = s_largest3 < 1.955159272639747e-149 ? 1.0715086071862673e+301 : s_d;
  const double y_0 = KSL_MUL(q->x, s), y_1 = KSL_MUL(q->y, s), y_2 = KSL_MUL(q->z, s),
      y_3 = KSL_MUL(q->w, s);
  const double n_a = KSL_MUL(y_0, y_0), n_b = KSL_MUL(y_1, y_1), n_c = n_a + n_b,
      n_c_right = n_c - n_a, n_d = KSL_MUL(y_2, y_2), n_e = n_c + n_d, n_e_right = n_e - n_c,
      n_c_lo = ksl_product_rest(y_0, y_0, n_a, n_c - n_c_right)
          + ksl_product_rest(y_1, y_1, n_b, n_c_right), n_f = KSL_MUL(y_3, y_3), n_g = n_e + n_f,
      n_g_right = n_g - n_e,
      n_e_lo = n_c - (n_e - n_e_right) + ksl_product_rest(y_2, y_2, n_d, n_e_right) + n_c_lo,
      n_g_lo = n_e - (n_g - n_g_right) + ksl_product_rest(y_3, y_3, n_f, n_g_right) + n_e_lo,
      n_g_sum = n_g + n_g_lo, n_g_sum_right = n_g_sum - n_g, n = sqrt(n_g_sum),
      n_product = KSL_MUL(n, n), n_twice = n + n,
      n_residual = n_g_sum - n_product - ksl_product_error(n, n, n_product)
          + (n_g - (n_g_sum - n_g_sum_right) + (n_g_lo - n_g_sum_right)),
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

/* self = self / |self|; zero stays zero.
   self: quaternion (x, y, z, w), the scalar last.
   33 mul, 86 add, 5 product error, 4 product rest, 10 div, 1 sqrt, 4 abs, 8 less, 6 equal, 15
     select.
   Each component is within 1 ulp as long as its condition is below 1e13; in single precision it
     is the nearest number, except near ties, as long as that is below 1e5; searched, not proved. */
static inline void ksl_quaternion_normalize_accurate(ksl_quaternion_t *self) {
  const double s_size_0 = fabs(self->x), s_size_1 = fabs(self->y), s_size_2 = fabs(self->z),
      s_size_3 = fabs(self->w);
  const double s_largest1 = s_size_0 < s_size_1 ? s_size_1 : s_size_0;
  const double s_largest2 = s_largest1 < s_size_2 ? s_size_2 : s_largest1;
  const double s_largest3 = s_largest2 < s_size_3 ? s_size_3 : s_largest2;
  const double s_b = 6.703903964971299e+153 < s_largest3 ? 3.7291703656001034e-155 : 1.0,
      s_d = s_largest3 < 256.0 ? 1.3093562431584567e+151 : s_b,
      s = s_largest3 < 1.955159272639747e-149 ? 1.0715086071862673e+301 : s_d;
  const double y_0 = KSL_MUL(self->x, s), y_1 = KSL_MUL(self->y, s), y_2 = KSL_MUL(self->z, s),
      y_3 = KSL_MUL(self->w, s);
  const double up = 1.0 < s ? s : 1.0;
  const double down = s < 1.0 ? s : 1.0;
  const double n_a = KSL_MUL(y_0, y_0), n_b = KSL_MUL(y_1, y_1), n_c = n_a + n_b,
      n_c_right = n_c - n_a, n_d = KSL_MUL(y_2, y_2), n_e = n_c + n_d, n_e_right = n_e - n_c,
      n_c_lo = ksl_product_rest(y_0, y_0, n_a, n_c - n_c_right)
          + ksl_product_rest(y_1, y_1, n_b, n_c_right), n_f = KSL_MUL(y_3, y_3), n_g = n_e + n_f,
      n_g_right = n_g - n_e,
      n_e_lo = n_c - (n_e - n_e_right) + ksl_product_rest(y_2, y_2, n_d, n_e_right) + n_c_lo,
      n_g_lo = n_e - (n_g - n_g_right) + ksl_product_rest(y_3, y_3, n_f, n_g_right) + n_e_lo,
      n_g_sum = n_g + n_g_lo, n_g_sum_right = n_g_sum - n_g, n = sqrt(n_g_sum),
      n_product = KSL_MUL(n, n), n_twice = n + n,
      n_residual = n_g_sum - n_product - ksl_product_error(n, n, n_product)
          + (n_g - (n_g_sum - n_g_sum_right) + (n_g_lo - n_g_sum_right)),
      n_lo = n_residual / (n == 0.0 ? 1.0 : n_twice);
  const double n_sum = n + n_lo, n_sum_right = n_sum - n,
      n_sum_lo = n - (n_sum - n_sum_right) + (n_lo - n_sum_right),
      divisor = n_sum == 0.0 ? up : n_sum, divisor_lo = n_sum == 0.0 ? 0.0 : n_sum_lo;
  const double sized_0 = KSL_MUL(self->x, up), sized_1 = KSL_MUL(self->y, up),
      sized_2 = KSL_MUL(self->z, up), sized_3 = KSL_MUL(self->w, up);
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
  const double quotient_0_sum = quotient_0 + quotient_0_lo,
      quotient_0_sum_right = quotient_0_sum - quotient_0,
      self_0_new = KSL_MUL(quotient_0_sum, down), self_0_new_inverse = 1.0 / down,
      quotient_0_sum_lo = quotient_0 - (quotient_0_sum - quotient_0_sum_right)
          + (quotient_0_lo - quotient_0_sum_right);
  const double quotient_1_sum = quotient_1 + quotient_1_lo,
      quotient_1_sum_right = quotient_1_sum - quotient_1,
      self_1_new = KSL_MUL(quotient_1_sum, down),
      quotient_1_sum_lo = quotient_1 - (quotient_1_sum - quotient_1_sum_right)
          + (quotient_1_lo - quotient_1_sum_right);
  const double quotient_2_sum = quotient_2 + quotient_2_lo,
      quotient_2_sum_right = quotient_2_sum - quotient_2,
      self_2_new = KSL_MUL(quotient_2_sum, down),
      quotient_2_sum_lo = quotient_2 - (quotient_2_sum - quotient_2_sum_right)
          + (quotient_2_lo - quotient_2_sum_right);
  const double quotient_3_sum = quotient_3 + quotient_3_lo,
      quotient_3_sum_right = quotient_3_sum - quotient_3,
      self_3_new = KSL_MUL(quotient_3_sum, down),
      quotient_3_sum_lo = quotient_3 - (quotient_3_sum - quotient_3_sum_right)
          + (quotient_3_lo - quotient_3_sum_right);
  const double self_0_new_rounded = self_0_new
          + KSL_MUL(quotient_0_sum - KSL_MUL(self_0_new, self_0_new_inverse)
          + quotient_0_sum_lo, down);
  const double self_1_new_rounded = self_1_new
          + KSL_MUL(quotient_1_sum - KSL_MUL(self_1_new, self_0_new_inverse)
          + quotient_1_sum_lo, down);
  const double self_2_new_rounded = self_2_new
          + KSL_MUL(quotient_2_sum - KSL_MUL(self_2_new, self_0_new_inverse)
          + quotient_2_sum_lo, down);
  const double self_3_new_rounded = self_3_new
          + KSL_MUL(quotient_3_sum - KSL_MUL(self_3_new, self_0_new_inverse)
          + quotient_3_sum_lo, down);
  const double self_0_new_final = self_0_new_rounded == self_0_new_rounded ? self_0_new_rounded
          : self_0_new;
  const double self_1_new_final = self_1_new_rounded == self_1_new_rounded ? self_1_new_rounded
          : self_1_new;
  const double self_2_new_final = self_2_new_rounded == self_2_new_rounded ? self_2_new_rounded
          : self_2_new;
  const double self_3_new_final = self_3_new_rounded == self_3_new_rounded ? self_3_new_rounded
          : self_3_new;
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
  const double s_size_0 = fabs(q->x), s_size_1 = fabs(q->y), s_size_2 = fabs(q->z),
      s_size_3 = fabs(q->w);
  const double s_largest1 = s_size_0 < s_size_1 ? s_size_1 : s_size_0;
  const double s_largest2 = s_largest1 < s_size_2 ? s_size_2 : s_largest1;
  const double s_largest3 = s_largest2 < s_size_3 ? s_size_3 : s_largest2;
  const double s_b = 6.703903964971299e+153 < s_largest3 ? 3.7291703656001034e-155 : 1.0,
      s_d = s_largest3 < 256.0 ? 1.3093562431584567e+151 : s_b,
      s = s_largest3 < 1.955159272639747e-149 ? 1.0715086071862673e+301 : s_d;
  const double y_0 = KSL_MUL(q->x, s), y_1 = KSL_MUL(q->y, s), y_2 = KSL_MUL(q->z, s),
      y_3 = KSL_MUL(q->w, s);
  const double up = 1.0 < s ? s : 1.0;
  const double down = s < 1.0 ? s : 1.0;
  const double n_a = KSL_MUL(y_0, y_0), n_b = KSL_MUL(y_1, y_1), n_c = n_a + n_b,
      n_c_right = n_c - n_a, n_d = KSL_MUL(y_2, y_2), n_e = n_c + n_d, n_e_right = n_e - n_c,
      n_c_lo = ksl_product_rest(y_0, y_0, n_a, n_c - n_c_right)
          + ksl_product_rest(y_1, y_1, n_b, n_c_right), n_f = KSL_MUL(y_3, y_3), n_g = n_e + n_f,
      n_g_right = n_g - n_e,
      n_e_lo = n_c - (n_e - n_e_right) + ksl_product_rest(y_2, y_2, n_d, n_e_right) + n_c_lo,
      n_g_lo = n_e - (n_g - n_g_right) + ksl_product_rest(y_3, y_3, n_f, n_g_right) + n_e_lo,
      n_g_sum = n_g + n_g_lo, n_g_sum_right = n_g_sum - n_g, n = sqrt(n_g_sum),
      n_product = KSL_MUL(n, n), n_twice = n + n,
      n_residual = n_g_sum - n_product - ksl_product_error(n, n, n_product)
          + (n_g - (n_g_sum - n_g_sum_right) + (n_g_lo - n_g_sum_right)),
      n_lo = n_residual / (n == 0.0 ? 1.0 : n_twice);
  const double n_sum = n + n_lo, n_sum_right = n_sum - n,
      n_sum_lo = n - (n_sum - n_sum_right) + (n_lo - n_sum_right),
      divisor = n_sum == 0.0 ? up : n_sum, divisor_lo = n_sum == 0.0 ? 0.0 : n_sum_lo;
  const double sized_0 = KSL_MUL(q->x, up), sized_1 = KSL_MUL(q->y, up),
      sized_2 = KSL_MUL(q->z, up), sized_3 = KSL_MUL(q->w, up);
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
  const double quotient_0_sum = quotient_0 + quotient_0_lo,
      quotient_0_sum_right = quotient_0_sum - quotient_0, qo_0 = KSL_MUL(quotient_0_sum, down),
      qo_0_inverse = 1.0 / down,
      quotient_0_sum_lo = quotient_0 - (quotient_0_sum - quotient_0_sum_right)
          + (quotient_0_lo - quotient_0_sum_right);
  const double quotient_1_sum = quotient_1 + quotient_1_lo,
      quotient_1_sum_right = quotient_1_sum - quotient_1, qo_1 = KSL_MUL(quotient_1_sum, down),
      quotient_1_sum_lo = quotient_1 - (quotient_1_sum - quotient_1_sum_right)
          + (quotient_1_lo - quotient_1_sum_right);
  const double quotient_2_sum = quotient_2 + quotient_2_lo,
      quotient_2_sum_right = quotient_2_sum - quotient_2, qo_2 = KSL_MUL(quotient_2_sum, down),
      quotient_2_sum_lo = quotient_2 - (quotient_2_sum - quotient_2_sum_right)
          + (quotient_2_lo - quotient_2_sum_right);
  const double quotient_3_sum = quotient_3 + quotient_3_lo,
      quotient_3_sum_right = quotient_3_sum - quotient_3, qo_3 = KSL_MUL(quotient_3_sum, down),
      quotient_3_sum_lo = quotient_3 - (quotient_3_sum - quotient_3_sum_right)
          + (quotient_3_lo - quotient_3_sum_right);
  const double qo_0_rounded = qo_0
          + KSL_MUL(quotient_0_sum - KSL_MUL(qo_0, qo_0_inverse) + quotient_0_sum_lo, down);
  const double qo_1_rounded = qo_1
          + KSL_MUL(quotient_1_sum - KSL_MUL(qo_1, qo_0_inverse) + quotient_1_sum_lo, down);
  const double qo_2_rounded = qo_2
          + KSL_MUL(quotient_2_sum - KSL_MUL(qo_2, qo_0_inverse) + quotient_2_sum_lo, down);
  const double qo_3_rounded = qo_3
          + KSL_MUL(quotient_3_sum - KSL_MUL(qo_3, qo_0_inverse) + quotient_3_sum_lo, down);
  const double qo_0_final = qo_0_rounded == qo_0_rounded ? qo_0_rounded : qo_0;
  const double qo_1_final = qo_1_rounded == qo_1_rounded ? qo_1_rounded : qo_1;
  const double qo_2_final = qo_2_rounded == qo_2_rounded ? qo_2_rounded : qo_2;
  const double qo_3_final = qo_3_rounded == qo_3_rounded ? qo_3_rounded : qo_3;
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
  const double s_size_0 = fabs(q->x), s_size_1 = fabs(q->y), s_size_2 = fabs(q->z),
      s_size_3 = fabs(q->w);
  const double s_largest1 = s_size_0 < s_size_1 ? s_size_1 : s_size_0;
  const double s_largest2 = s_largest1 < s_size_2 ? s_size_2 : s_largest1;
  const double s_largest3 = s_largest2 < s_size_3 ? s_size_3 : s_largest2;
  const double s_b = 6.703903964971299e+153 < s_largest3 ? 3.7291703656001034e-155 : 1.0,
      s_d = s_largest3 < 256.0 ? 1.3093562431584567e+151 : s_b,
      s = s_largest3 < 1.955159272639747e-149 ? 1.0715086071862673e+301 : s_d;
  const double y_0 = KSL_MUL(q->x, s), y_1 = KSL_MUL(q->y, s), y_2 = KSL_MUL(q->z, s),
      y_3 = KSL_MUL(q->w, s);
  const double n_a = KSL_MUL(y_0, y_0), n_b = KSL_MUL(y_1, y_1), n_c = n_a + n_b,
      n_c_right = n_c - n_a, n_d = KSL_MUL(y_2, y_2), n_e = n_c + n_d, n_e_right = n_e - n_c,
      n_c_lo = ksl_product_rest(y_0, y_0, n_a, n_c - n_c_right)
          + ksl_product_rest(y_1, y_1, n_b, n_c_right), n_f = KSL_MUL(y_3, y_3), n_g = n_e + n_f,
      n_g_right = n_g - n_e,
      n_e_lo = n_c - (n_e - n_e_right) + ksl_product_rest(y_2, y_2, n_d, n_e_right) + n_c_lo,
      n_g_lo = n_e - (n_g - n_g_right) + ksl_product_rest(y_3, y_3, n_f, n_g_right) + n_e_lo,
      n_g_sum = n_g + n_g_lo, n_g_sum_right = n_g_sum - n_g, n = sqrt(n_g_sum),
      n_product = KSL_MUL(n, n), n_twice = n + n,
      n_residual = n_g_sum - n_product - ksl_product_error(n, n, n_product)
          + (n_g - (n_g_sum - n_g_sum_right) + (n_g_lo - n_g_sum_right)),
      n_lo = n_residual / (n == 0.0 ? 1.0 : n_twice);
  const double r_b = s < 1.0 ? 2.6815615859885194e+154 : 1.0,
      r_d = 1.0 < s ? 7.637340908749012e-152 : r_b,
      r = 1.3093562431584567e+151 < s ? 9.332636185032189e-302 : r_d;
  const double n_sum = n + n_lo, n_sum_right = n_sum - n, length = KSL_MUL(n_sum, r);
  const double defect = length - 1.0, defect_right = length - defect;
  const double length_lo = KSL_MUL(n_sum - KSL_MUL(length, 1.0 / r)
          + (n - (n_sum - n_sum_right) + (n_lo - n_sum_right)), r);
  const double defect_rounded = defect
          + (length - (defect + defect_right) - (1.0 - defect_right) + length_lo),
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
  const double s_size_0 = fabs(q->x), s_size_1 = fabs(q->y), s_size_2 = fabs(q->z),
      s_size_3 = fabs(q->w);
  const double s_largest1 = s_size_0 < s_size_1 ? s_size_1 : s_size_0;
  const double s_largest2 = s_largest1 < s_size_2 ? s_size_2 : s_largest1;
  const double s_largest3 = s_largest2 < s_size_3 ? s_size_3 : s_largest2;
  const double s_b = 6.703903964971299e+153 < s_largest3 ? 3.7291703656001034e-155 : 1.0,
      s_d = s_largest3 < 256.0 ? 1.3093562431584567e+151 : s_b,
      s = s_largest3 < 1.955159272639747e-149 ? 1.0715086071862673e+301 : s_d;
  const double scaled_s_0 = KSL_MUL(q->x, s), scaled_s_1 = KSL_MUL(q->y, s),
      scaled_s_2 = KSL_MUL(q->z, s), scaled_s_3 = KSL_MUL(q->w, s);
  const double n_a = KSL_MUL(scaled_s_0, scaled_s_0), n_b = KSL_MUL(scaled_s_1, scaled_s_1),
      n_c = n_a + n_b, n_c_right = n_c - n_a, n_d = KSL_MUL(scaled_s_2, scaled_s_2),
      n_e = n_c + n_d, n_e_right = n_e - n_c,
      n_c_lo = ksl_product_rest(scaled_s_0, scaled_s_0, n_a, n_c - n_c_right)
          + ksl_product_rest(scaled_s_1, scaled_s_1, n_b, n_c_right),
      n_f = KSL_MUL(scaled_s_3, scaled_s_3), n_g = n_e + n_f, n_g_right = n_g - n_e,
      n_e_lo = n_c - (n_e - n_e_right) + ksl_product_rest(scaled_s_2, scaled_s_2, n_d, n_e_right)
          + n_c_lo,
      n_g_lo = n_e - (n_g - n_g_right) + ksl_product_rest(scaled_s_3, scaled_s_3, n_f, n_g_right)
          + n_e_lo, n_g_sum = n_g + n_g_lo, n_g_sum_right = n_g_sum - n_g, n = sqrt(n_g_sum),
      n_product = KSL_MUL(n, n), n_twice = n + n,
      n_residual = n_g_sum - n_product - ksl_product_error(n, n, n_product)
          + (n_g - (n_g_sum - n_g_sum_right) + (n_g_lo - n_g_sum_right)),
      n_lo = n_residual / (n == 0.0 ? 1.0 : n_twice);
  const double n_sum = n + n_lo, n_sum_right = n_sum - n,
      n_sum_lo = n - (n_sum - n_sum_right) + (n_lo - n_sum_right),
      divisor = n_sum == 0.0 ? 1.0 : n_sum, divisor_lo = n_sum == 0.0 ? 0.0 : n_sum_lo;
  const double divisor_sum = divisor + divisor_lo, divisor_sum_right = divisor_sum - divisor,
      divisor_sum_lo = divisor - (divisor_sum - divisor_sum_right)
          + (divisor_lo - divisor_sum_right), unit_0 = scaled_s_0 / divisor_sum,
      unit_0_product = KSL_MUL(unit_0, divisor_sum),
      unit_0_lo = (scaled_s_0 - unit_0_product
          - ksl_product_error(unit_0, divisor_sum, unit_0_product)
          - KSL_MUL(unit_0, divisor_sum_lo)) / divisor_sum;
  const double unit_1 = scaled_s_1 / divisor_sum, unit_1_product = KSL_MUL(unit_1, divisor_sum),
      unit_1_lo = (scaled_s_1 - unit_1_product
          - ksl_product_error(unit_1, divisor_sum, unit_1_product)
          - KSL_MUL(unit_1, divisor_sum_lo)) / divisor_sum;
  const double unit_2 = scaled_s_2 / divisor_sum, unit_2_product = KSL_MUL(unit_2, divisor_sum),
      unit_2_lo = (scaled_s_2 - unit_2_product
          - ksl_product_error(unit_2, divisor_sum, unit_2_product)
          - KSL_MUL(unit_2, divisor_sum_lo)) / divisor_sum;
  const double unit_3 = scaled_s_3 / divisor_sum, unit_3_product = KSL_MUL(unit_3, divisor_sum),
      unit_3_lo = (scaled_s_3 - unit_3_product
          - ksl_product_error(unit_3, divisor_sum, unit_3_product)
          - KSL_MUL(unit_3, divisor_sum_lo)) / divisor_sum;
  const double qo_0 = n_sum == 0.0 ? (double)NAN : unit_0,
      qo_1 = n_sum == 0.0 ? (double)NAN : unit_1, qo_2 = n_sum == 0.0 ? (double)NAN : unit_2,
      qo_3 = n_sum == 0.0 ? (double)NAN : unit_3;
  const double qo_0_rounded = qo_0 + (n_sum == 0.0 ? 0.0 : unit_0_lo);
  const double qo_1_rounded = qo_1 + (n_sum == 0.0 ? 0.0 : unit_1_lo);
  const double qo_2_rounded = qo_2 + (n_sum == 0.0 ? 0.0 : unit_2_lo);
  const double qo_3_rounded = qo_3 + (n_sum == 0.0 ? 0.0 : unit_3_lo);
  const double qo_0_final = qo_0_rounded == qo_0_rounded ? qo_0_rounded : qo_0;
  const double qo_1_final = qo_1_rounded == qo_1_rounded ? qo_1_rounded : qo_1;
  const double qo_2_final = qo_2_rounded == qo_2_rounded ? qo_2_rounded : qo_2;
  const double qo_3_final = qo_3_rounded == qo_3_rounded ? qo_3_rounded : qo_3;
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
      c_0_right = c_0a - c_0;
  const double c_1a = KSL_MUL(q->z, v->x), c_1b = KSL_MUL(q->x, v->z), c_1 = c_1a - c_1b,
      c_1_right = c_1a - c_1;
  const double c_2a = KSL_MUL(q->x, v->y), c_2b = KSL_MUL(q->y, v->x), c_2 = c_2a - c_2b,
      c_2_right = c_2a - c_2;
  const double t_0 = KSL_MUL(2.0, c_0),
      t_0_cross2 = KSL_MUL(2.0, ksl_product_rest(q->y, v->z, c_0a, c_0 + c_0_right)
          - ksl_product_rest(q->z, v->y, c_0b, c_0_right));
  const double t_1 = KSL_MUL(2.0, c_1),
      t_1_cross2 = KSL_MUL(2.0, ksl_product_rest(q->z, v->x, c_1a, c_1 + c_1_right)
          - ksl_product_rest(q->x, v->z, c_1b, c_1_right));
  const double t_2 = KSL_MUL(2.0, c_2),
      t_2_cross2 = KSL_MUL(2.0, ksl_product_rest(q->x, v->y, c_2a, c_2 + c_2_right)
          - ksl_product_rest(q->y, v->x, c_2b, c_2_right));
  const double turn_0a = KSL_MUL(q->y, t_2), turn_0b = KSL_MUL(q->z, t_1),
      turn_0c = turn_0a - turn_0b, turn_0c_right = turn_0a - turn_0c,
      turn_0c_lo1 = ksl_product_rest(q->y, t_2, turn_0a, turn_0c + turn_0c_right)
          - ksl_product_rest(q->z, t_1, turn_0b, turn_0c_right), turn_0d = KSL_MUL(q->w, t_0),
      turn_0 = turn_0c + turn_0d, turn_0_right = turn_0 - turn_0c,
      turn_0_lo2 = turn_0c - (turn_0 - turn_0_right)
          + ksl_product_rest(q->w, t_0, turn_0d, turn_0_right) + KSL_MUL(q->w, t_0_cross2);
  const double turn_1a = KSL_MUL(q->z, t_0), turn_1b = KSL_MUL(q->x, t_2),
      turn_1c = turn_1a - turn_1b, turn_1c_right = turn_1a - turn_1c,
      turn_1c_lo1 = ksl_product_rest(q->z, t_0, turn_1a, turn_1c + turn_1c_right)
          - ksl_product_rest(q->x, t_2, turn_1b, turn_1c_right), turn_1d = KSL_MUL(q->w, t_1),
      turn_1 = turn_1c + turn_1d, turn_1_right = turn_1 - turn_1c,
      turn_1_lo2 = turn_1c - (turn_1 - turn_1_right)
          + ksl_product_rest(q->w, t_1, turn_1d, turn_1_right) + KSL_MUL(q->w, t_1_cross2);
  const double turn_2a = KSL_MUL(q->x, t_1), turn_2b = KSL_MUL(q->y, t_0),
      turn_2c = turn_2a - turn_2b, turn_2c_right = turn_2a - turn_2c,
      turn_2c_lo1 = ksl_product_rest(q->x, t_1, turn_2a, turn_2c + turn_2c_right)
          - ksl_product_rest(q->y, t_0, turn_2b, turn_2c_right), turn_2d = KSL_MUL(q->w, t_2),
      turn_2 = turn_2c + turn_2d, turn_2_right = turn_2 - turn_2c,
      turn_2_lo2 = turn_2c - (turn_2 - turn_2_right)
          + ksl_product_rest(q->w, t_2, turn_2d, turn_2_right) + KSL_MUL(q->w, t_2_cross2);
  const double vo_0 = v->x + turn_0, vo_0_right = vo_0 - v->x;
  const double vo_1 = v->y + turn_1, vo_1_right = vo_1 - v->y;
  const double vo_2 = v->z + turn_2, vo_2_right = vo_2 - v->z;
  const double vo_0_lo = v->x - (vo_0 - vo_0_right) + (turn_0 - vo_0_right)
          + (turn_0_lo2 + (turn_0c_lo1 + (KSL_MUL(q->y, t_2_cross2) - KSL_MUL(q->z, t_1_cross2))));
  const double vo_0_rounded = vo_0 + vo_0_lo;
  const double vo_1_lo = v->y - (vo_1 - vo_1_right) + (turn_1 - vo_1_right)
          + (turn_1_lo2 + (turn_1c_lo1 + (KSL_MUL(q->z, t_0_cross2) - KSL_MUL(q->x, t_2_cross2))));
  const double vo_1_rounded = vo_1 + vo_1_lo;
  const double vo_2_lo = v->z - (vo_2 - vo_2_right) + (turn_2 - vo_2_right)
          + (turn_2_lo2 + (turn_2c_lo1 + (KSL_MUL(q->x, t_1_cross2) - KSL_MUL(q->y, t_0_cross2))));
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
      c_0_right = c_0a - c_0;
  const double c_1a = KSL_MUL(q->x, v->z), c_1b = KSL_MUL(q->z, v->x), c_1 = c_1a - c_1b,
      c_1_right = c_1a - c_1;
  const double c_2a = KSL_MUL(q->y, v->x), c_2b = KSL_MUL(q->x, v->y), c_2 = c_2a - c_2b,
      c_2_right = c_2a - c_2;
  const double t_0 = KSL_MUL(2.0, c_0),
      t_0_cross2 = KSL_MUL(2.0, ksl_product_rest(q->z, v->y, c_0a, c_0 + c_0_right)
          - ksl_product_rest(q->y, v->z, c_0b, c_0_right));
  const double t_1 = KSL_MUL(2.0, c_1),
      t_1_cross2 = KSL_MUL(2.0, ksl_product_rest(q->x, v->z, c_1a, c_1 + c_1_right)
          - ksl_product_rest(q->z, v->x, c_1b, c_1_right));
  const double t_2 = KSL_MUL(2.0, c_2),
      t_2_cross2 = KSL_MUL(2.0, ksl_product_rest(q->y, v->x, c_2a, c_2 + c_2_right)
          - ksl_product_rest(q->x, v->y, c_2b, c_2_right));
  const double turn_0a = KSL_MUL(q->z, t_1), turn_0b = KSL_MUL(q->y, t_2),
      turn_0c = turn_0a - turn_0b, turn_0c_right = turn_0a - turn_0c,
      turn_0c_lo1 = ksl_product_rest(q->z, t_1, turn_0a, turn_0c + turn_0c_right)
          - ksl_product_rest(q->y, t_2, turn_0b, turn_0c_right), turn_0d = KSL_MUL(q->w, t_0),
      turn_0 = turn_0c + turn_0d, turn_0_right = turn_0 - turn_0c,
      turn_0_lo2 = turn_0c - (turn_0 - turn_0_right)
          + ksl_product_rest(q->w, t_0, turn_0d, turn_0_right) + KSL_MUL(q->w, t_0_cross2);
  const double turn_1a = KSL_MUL(q->x, t_2), turn_1b = KSL_MUL(q->z, t_0),
      turn_1c = turn_1a - turn_1b, turn_1c_right = turn_1a - turn_1c,
      turn_1c_lo1 = ksl_product_rest(q->x, t_2, turn_1a, turn_1c + turn_1c_right)
          - ksl_product_rest(q->z, t_0, turn_1b, turn_1c_right), turn_1d = KSL_MUL(q->w, t_1),
      turn_1 = turn_1c + turn_1d, turn_1_right = turn_1 - turn_1c,
      turn_1_lo2 = turn_1c - (turn_1 - turn_1_right)
          + ksl_product_rest(q->w, t_1, turn_1d, turn_1_right) + KSL_MUL(q->w, t_1_cross2);
  const double turn_2a = KSL_MUL(q->y, t_0), turn_2b = KSL_MUL(q->x, t_1),
      turn_2c = turn_2a - turn_2b, turn_2c_right = turn_2a - turn_2c,
      turn_2c_lo1 = ksl_product_rest(q->y, t_0, turn_2a, turn_2c + turn_2c_right)
          - ksl_product_rest(q->x, t_1, turn_2b, turn_2c_right), turn_2d = KSL_MUL(q->w, t_2),
      turn_2 = turn_2c + turn_2d, turn_2_right = turn_2 - turn_2c,
      turn_2_lo2 = turn_2c - (turn_2 - turn_2_right)
          + ksl_product_rest(q->w, t_2, turn_2d, turn_2_right) + KSL_MUL(q->w, t_2_cross2);
  const double vo_0 = v->x + turn_0, vo_0_right = vo_0 - v->x;
  const double vo_1 = v->y + turn_1, vo_1_right = vo_1 - v->y;
  const double vo_2 = v->z + turn_2, vo_2_right = vo_2 - v->z;
  const double vo_0_lo = v->x - (vo_0 - vo_0_right) + (turn_0 - vo_0_right)
          + (turn_0_lo2 + (turn_0c_lo1 + (KSL_MUL(q->z, t_1_cross2) - KSL_MUL(q->y, t_2_cross2))));
  const double vo_0_rounded = vo_0 + vo_0_lo;
  const double vo_1_lo = v->y - (vo_1 - vo_1_right) + (turn_1 - vo_1_right)
          + (turn_1_lo2 + (turn_1c_lo1 + (KSL_MUL(q->x, t_2_cross2) - KSL_MUL(q->z, t_0_cross2))));
  const double vo_1_rounded = vo_1 + vo_1_lo;
  const double vo_2_lo = v->z - (vo_2 - vo_2_right) + (turn_2 - vo_2_right)
          + (turn_2_lo2 + (turn_2c_lo1 + (KSL_MUL(q->y, t_0_cross2) - KSL_MUL(q->x, t_1_cross2))));
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
      qo_0e = qo_0a + qo_0d, qo_0e_right = qo_0e - qo_0a,
      qo_0d_lo = ksl_product_rest(q1i->y, q2i->z, qo_0b, qo_0d + qo_0d_right)
          - ksl_product_rest(q1i->z, q2i->y, qo_0c, qo_0d_right), qo_0f = KSL_MUL(q1i->w, q2i->x),
      qo_0 = qo_0e + qo_0f, qo_0_right = qo_0 - qo_0e,
      qo_0e_lo = ksl_product_rest(q1i->x, q2i->w, qo_0a, qo_0e - qo_0e_right)
          + (qo_0d - qo_0e_right) + qo_0d_lo;
  const double qo_1a = KSL_MUL(q1i->z, q2i->x), qo_1b = KSL_MUL(q1i->x, q2i->z),
      qo_1c = qo_1a - qo_1b, qo_1c_right = qo_1a - qo_1c, qo_1d = KSL_MUL(q1i->y, q2i->w),
      qo_1e = qo_1c + qo_1d, qo_1e_right = qo_1e - qo_1c,
      qo_1c_lo = ksl_product_rest(q1i->z, q2i->x, qo_1a, qo_1c + qo_1c_right)
          - ksl_product_rest(q1i->x, q2i->z, qo_1b, qo_1c_right), qo_1f = KSL_MUL(q1i->w, q2i->y),
      qo_1 = qo_1e + qo_1f, qo_1_right = qo_1 - qo_1e,
      qo_1e_lo = qo_1c - (qo_1e - qo_1e_right)
          + ksl_product_rest(q1i->y, q2i->w, qo_1d, qo_1e_right) + qo_1c_lo;
  const double qo_2a = KSL_MUL(q1i->x, q2i->y), qo_2b = KSL_MUL(q1i->y, q2i->x),
      qo_2c = qo_2a - qo_2b, qo_2c_right = qo_2a - qo_2c, qo_2d = KSL_MUL(q1i->z, q2i->w),
      qo_2e = qo_2c + qo_2d, qo_2e_right = qo_2e - qo_2c,
      qo_2c_lo = ksl_product_rest(q1i->x, q2i->y, qo_2a, qo_2c + qo_2c_right)
          - ksl_product_rest(q1i->y, q2i->x, qo_2b, qo_2c_right), qo_2f = KSL_MUL(q1i->w, q2i->z),
      qo_2 = qo_2e + qo_2f, qo_2_right = qo_2 - qo_2e,
      qo_2e_lo = qo_2c - (qo_2e - qo_2e_right)
          + ksl_product_rest(q1i->z, q2i->w, qo_2d, qo_2e_right) + qo_2c_lo;
  const double qo_3a = KSL_MUL(q1i->w, q2i->w), qo_3b = KSL_MUL(q1i->x, q2i->x),
      qo_3c = KSL_MUL(q1i->y, q2i->y), qo_3d = qo_3b + qo_3c, qo_3d_right = qo_3d - qo_3b,
      qo_3e = KSL_MUL(q1i->z, q2i->z), qo_3f = qo_3d + qo_3e, qo_3f_right = qo_3f - qo_3d,
      qo_3d_lo = ksl_product_rest(q1i->x, q2i->x, qo_3b, qo_3d - qo_3d_right)
          + ksl_product_rest(q1i->y, q2i->y, qo_3c, qo_3d_right), qo_3 = qo_3a - qo_3f,
      qo_3_right = qo_3a - qo_3,
      qo_3f_lo = qo_3d - (qo_3f - qo_3f_right)
          + ksl_product_rest(q1i->z, q2i->z, qo_3e, qo_3f_right) + qo_3d_lo;
  const double qo_0_rounded = qo_0
          + (qo_0e - (qo_0 - qo_0_right) + ksl_product_rest(q1i->w, q2i->x, qo_0f, qo_0_right)
          + qo_0e_lo),
      qo_1_rounded = qo_1
          + (qo_1e - (qo_1 - qo_1_right) + ksl_product_rest(q1i->w, q2i->y, qo_1f, qo_1_right)
          + qo_1e_lo),
      qo_2_rounded = qo_2
          + (qo_2e - (qo_2 - qo_2_right) + ksl_product_rest(q1i->w, q2i->z, qo_2f, qo_2_right)
          + qo_2e_lo),
      qo_3_rounded = qo_3
          + (ksl_product_rest(q1i->w, q2i->w, qo_3a, qo_3 + qo_3_right) - (qo_3f - qo_3_right)
          - qo_3f_lo);
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
      qo_0c = qo_0a - qo_0b, qo_0c_right = qo_0a - qo_0c, qo_0d = KSL_MUL(q1i->z, q2i->y),
      qo_0e = KSL_MUL(q1i->y, q2i->z), qo_0f = qo_0d - qo_0e, qo_0f_right = qo_0d - qo_0f,
      qo_0 = qo_0c + qo_0f, qo_0_right = qo_0 - qo_0c,
      qo_0f_lo = ksl_product_rest(q1i->z, q2i->y, qo_0d, qo_0f + qo_0f_right)
          - ksl_product_rest(q1i->y, q2i->z, qo_0e, qo_0f_right),
      qo_0c_lo = ksl_product_rest(q1i->x, q2i->w, qo_0a, qo_0c + qo_0c_right)
          - ksl_product_rest(q1i->w, q2i->x, qo_0b, qo_0c_right);
  const double qo_1a = KSL_MUL(q1i->x, q2i->z), qo_1b = KSL_MUL(q1i->z, q2i->x),
      qo_1c = qo_1a - qo_1b, qo_1c_right = qo_1a - qo_1c, qo_1d = KSL_MUL(q1i->y, q2i->w),
      qo_1e = KSL_MUL(q1i->w, q2i->y), qo_1f = qo_1d - qo_1e, qo_1f_right = qo_1d - qo_1f,
      qo_1 = qo_1c + qo_1f, qo_1_right = qo_1 - qo_1c,
      qo_1f_lo = ksl_product_rest(q1i->y, q2i->w, qo_1d, qo_1f + qo_1f_right)
          - ksl_product_rest(q1i->w, q2i->y, qo_1e, qo_1f_right),
      qo_1c_lo = ksl_product_rest(q1i->x, q2i->z, qo_1a, qo_1c + qo_1c_right)
          - ksl_product_rest(q1i->z, q2i->x, qo_1b, qo_1c_right);
  const double qo_2a = KSL_MUL(q1i->y, q2i->x), qo_2b = KSL_MUL(q1i->x, q2i->y),
      qo_2c = qo_2a - qo_2b, qo_2c_right = qo_2a - qo_2c, qo_2d = KSL_MUL(q1i->z, q2i->w),
      qo_2e = KSL_MUL(q1i->w, q2i->z), qo_2f = qo_2d - qo_2e, qo_2f_right = qo_2d - qo_2f,
      qo_2 = qo_2c + qo_2f, qo_2_right = qo_2 - qo_2c,
      qo_2f_lo = ksl_product_rest(q1i->z, q2i->w, qo_2d, qo_2f + qo_2f_right)
          - ksl_product_rest(q1i->w, q2i->z, qo_2e, qo_2f_right),
      qo_2c_lo = ksl_product_rest(q1i->y, q2i->x, qo_2a, qo_2c + qo_2c_right)
          - ksl_product_rest(q1i->x, q2i->y, qo_2b, qo_2c_right);
  const double qo_3a = KSL_MUL(q1i->x, q2i->x), qo_3b = KSL_MUL(q1i->y, q2i->y),
      qo_3c = qo_3a + qo_3b, qo_3c_right = qo_3c - qo_3a, qo_3d = KSL_MUL(q1i->z, q2i->z),
      qo_3e = qo_3c + qo_3d, qo_3e_right = qo_3e - qo_3c,
      qo_3c_lo = ksl_product_rest(q1i->x, q2i->x, qo_3a, qo_3c - qo_3c_right)
          + ksl_product_rest(q1i->y, q2i->y, qo_3b, qo_3c_right), qo_3f = KSL_MUL(q1i->w, q2i->w),
      qo_3 = qo_3e + qo_3f, qo_3_right = qo_3 - qo_3e,
      qo_3e_lo = qo_3c - (qo_3e - qo_3e_right)
          + ksl_product_rest(q1i->z, q2i->z, qo_3d, qo_3e_right) + qo_3c_lo;
  const double qo_0_rounded = qo_0
          + (qo_0c - (qo_0 - qo_0_right) + (qo_0f - qo_0_right) + qo_0f_lo + qo_0c_lo),
      qo_1_rounded = qo_1
          + (qo_1c - (qo_1 - qo_1_right) + (qo_1f - qo_1_right) + qo_1f_lo + qo_1c_lo),
      qo_2_rounded = qo_2
          + (qo_2c - (qo_2 - qo_2_right) + (qo_2f - qo_2_right) + qo_2f_lo + qo_2c_lo),
      qo_3_rounded = qo_3
          + (qo_3e - (qo_3 - qo_3_right) + ksl_product_rest(q1i->w, q2i->w, qo_3f, qo_3_right)
          + qo_3e_lo);
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
      qo_0c = qo_0a - qo_0b, qo_0c_right = qo_0a - qo_0c, qo_0d = KSL_MUL(q1i->z, q2i->y),
      qo_0e = KSL_MUL(q1i->y, q2i->z), qo_0f = qo_0d - qo_0e, qo_0f_right = qo_0d - qo_0f,
      qo_0 = qo_0c + qo_0f, qo_0_right = qo_0 - qo_0c,
      qo_0f_lo = ksl_product_rest(q1i->z, q2i->y, qo_0d, qo_0f + qo_0f_right)
          - ksl_product_rest(q1i->y, q2i->z, qo_0e, qo_0f_right),
      qo_0c_lo = ksl_product_rest(q1i->w, q2i->x, qo_0a, qo_0c + qo_0c_right)
          - ksl_product_rest(q1i->x, q2i->w, qo_0b, qo_0c_right);
  const double qo_1a = KSL_MUL(q1i->x, q2i->z), qo_1b = KSL_MUL(q1i->z, q2i->x),
      qo_1c = qo_1a - qo_1b, qo_1c_right = qo_1a - qo_1c, qo_1d = KSL_MUL(q1i->w, q2i->y),
      qo_1e = KSL_MUL(q1i->y, q2i->w), qo_1f = qo_1d - qo_1e, qo_1f_right = qo_1d - qo_1f,
      qo_1 = qo_1c + qo_1f, qo_1_right = qo_1 - qo_1c,
      qo_1f_lo = ksl_product_rest(q1i->w, q2i->y, qo_1d, qo_1f + qo_1f_right)
          - ksl_product_rest(q1i->y, q2i->w, qo_1e, qo_1f_right),
      qo_1c_lo = ksl_product_rest(q1i->x, q2i->z, qo_1a, qo_1c + qo_1c_right)
          - ksl_product_rest(q1i->z, q2i->x, qo_1b, qo_1c_right);
  const double qo_2a = KSL_MUL(q1i->y, q2i->x), qo_2b = KSL_MUL(q1i->x, q2i->y),
      qo_2c = qo_2a - qo_2b, qo_2c_right = qo_2a - qo_2c, qo_2d = KSL_MUL(q1i->w, q2i->z),
      qo_2e = KSL_MUL(q1i->z, q2i->w), qo_2f = qo_2d - qo_2e, qo_2f_right = qo_2d - qo_2f,
      qo_2 = qo_2c + qo_2f, qo_2_right = qo_2 - qo_2c,
      qo_2f_lo = ksl_product_rest(q1i->w, q2i->z, qo_2d, qo_2f + qo_2f_right)
          - ksl_product_rest(q1i->z, q2i->w, qo_2e, qo_2f_right),
      qo_2c_lo = ksl_product_rest(q1i->y, q2i->x, qo_2a, qo_2c + qo_2c_right)
          - ksl_product_rest(q1i->x, q2i->y, qo_2b, qo_2c_right);
  const double qo_3a = KSL_MUL(q1i->x, q2i->x), qo_3b = KSL_MUL(q1i->y, q2i->y),
      qo_3c = qo_3a + qo_3b, qo_3c_right = qo_3c - qo_3a, qo_3d = KSL_MUL(q1i->z, q2i->z),
      qo_3e = qo_3c + qo_3d, qo_3e_right = qo_3e - qo_3c,
      qo_3c_lo = ksl_product_rest(q1i->x, q2i->x, qo_3a, qo_3c - qo_3c_right)
          + ksl_product_rest(q1i->y, q2i->y, qo_3b, qo_3c_right), qo_3f = KSL_MUL(q1i->w, q2i->w),
      qo_3 = qo_3e + qo_3f, qo_3_right = qo_3 - qo_3e,
      qo_3e_lo = qo_3c - (qo_3e - qo_3e_right)
          + ksl_product_rest(q1i->z, q2i->z, qo_3d, qo_3e_right) + qo_3c_lo;
  const double qo_0_rounded = qo_0
          + (qo_0c - (qo_0 - qo_0_right) + (qo_0f - qo_0_right) + qo_0f_lo + qo_0c_lo),
      qo_1_rounded = qo_1
          + (qo_1c - (qo_1 - qo_1_right) + (qo_1f - qo_1_right) + qo_1f_lo + qo_1c_lo),
      qo_2_rounded = qo_2
          + (qo_2c - (qo_2 - qo_2_right) + (qo_2f - qo_2_right) + qo_2f_lo + qo_2c_lo),
      qo_3_rounded = qo_3
          + (qo_3e - (qo_3 - qo_3_right) + ksl_product_rest(q1i->w, q2i->w, qo_3f, qo_3_right)
          + qo_3e_lo);
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
      qo_0c = qo_0a - qo_0b, qo_0c_right = qo_0a - qo_0c, qo_0d = KSL_MUL(q1i->x, q2i->w),
      qo_0e = qo_0c - qo_0d, qo_0e_right = qo_0c - qo_0e,
      qo_0c_lo = ksl_product_rest(q1i->y, q2i->z, qo_0a, qo_0c + qo_0c_right)
          - ksl_product_rest(q1i->z, q2i->y, qo_0b, qo_0c_right), qo_0f = KSL_MUL(q1i->w, q2i->x),
      qo_0 = qo_0e - qo_0f, qo_0_right = qo_0e - qo_0,
      qo_0e_lo = qo_0c - (qo_0e + qo_0e_right)
          - ksl_product_rest(q1i->x, q2i->w, qo_0d, qo_0e_right) + qo_0c_lo;
  const double qo_1a = KSL_MUL(q1i->z, q2i->x), qo_1b = KSL_MUL(q1i->x, q2i->z),
      qo_1c = qo_1a - qo_1b, qo_1c_right = qo_1a - qo_1c, qo_1d = KSL_MUL(q1i->y, q2i->w),
      qo_1e = qo_1c - qo_1d, qo_1e_right = qo_1c - qo_1e,
      qo_1c_lo = ksl_product_rest(q1i->z, q2i->x, qo_1a, qo_1c + qo_1c_right)
          - ksl_product_rest(q1i->x, q2i->z, qo_1b, qo_1c_right), qo_1f = KSL_MUL(q1i->w, q2i->y),
      qo_1 = qo_1e - qo_1f, qo_1_right = qo_1e - qo_1,
      qo_1e_lo = qo_1c - (qo_1e + qo_1e_right)
          - ksl_product_rest(q1i->y, q2i->w, qo_1d, qo_1e_right) + qo_1c_lo;
  const double qo_2a = KSL_MUL(q1i->x, q2i->y), qo_2b = KSL_MUL(q1i->y, q2i->x),
      qo_2c = qo_2a - qo_2b, qo_2c_right = qo_2a - qo_2c, qo_2d = KSL_MUL(q1i->z, q2i->w),
      qo_2e = qo_2c - qo_2d, qo_2e_right = qo_2c - qo_2e,
      qo_2c_lo = ksl_product_rest(q1i->x, q2i->y, qo_2a, qo_2c + qo_2c_right)
          - ksl_product_rest(q1i->y, q2i->x, qo_2b, qo_2c_right), qo_2f = KSL_MUL(q1i->w, q2i->z),
      qo_2 = qo_2e - qo_2f, qo_2_right = qo_2e - qo_2,
      qo_2e_lo = qo_2c - (qo_2e + qo_2e_right)
          - ksl_product_rest(q1i->z, q2i->w, qo_2d, qo_2e_right) + qo_2c_lo;
  const double qo_3a = KSL_MUL(q1i->w, q2i->w), qo_3b = KSL_MUL(q1i->x, q2i->x),
      qo_3c = KSL_MUL(q1i->y, q2i->y), qo_3d = qo_3b + qo_3c, qo_3d_right = qo_3d - qo_3b,
      qo_3e = KSL_MUL(q1i->z, q2i->z), qo_3f = qo_3d + qo_3e, qo_3f_right = qo_3f - qo_3d,
      qo_3d_lo = ksl_product_rest(q1i->x, q2i->x, qo_3b, qo_3d - qo_3d_right)
          + ksl_product_rest(q1i->y, q2i->y, qo_3c, qo_3d_right), qo_3 = qo_3a - qo_3f,
      qo_3_right = qo_3a - qo_3,
      qo_3f_lo = qo_3d - (qo_3f - qo_3f_right)
          + ksl_product_rest(q1i->z, q2i->z, qo_3e, qo_3f_right) + qo_3d_lo;
  const double qo_0_rounded = qo_0
          + (qo_0e - (qo_0 + qo_0_right) - ksl_product_rest(q1i->w, q2i->x, qo_0f, qo_0_right)
          + qo_0e_lo),
      qo_1_rounded = qo_1
          + (qo_1e - (qo_1 + qo_1_right) - ksl_product_rest(q1i->w, q2i->y, qo_1f, qo_1_right)
          + qo_1e_lo),
      qo_2_rounded = qo_2
          + (qo_2e - (qo_2 + qo_2_right) - ksl_product_rest(q1i->w, q2i->z, qo_2f, qo_2_right)
          + qo_2e_lo),
      qo_3_rounded = qo_3
          + (ksl_product_rest(q1i->w, q2i->w, qo_3a, qo_3 + qo_3_right) - (qo_3f - qo_3_right)
          - qo_3f_lo);
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
      qo_0_right = qo_0 - qo_0a;
  const double qo_1a = KSL_MUL(dci[1], qi->y), qo_1b = KSL_MUL(dci[0], qi->z), qo_1 = qo_1a - qo_1b,
      qo_1_right = qo_1a - qo_1;
  const double qo_2a = KSL_MUL(dci[0], qi->y), qo_2b = KSL_MUL(dci[1], qi->z), qo_2 = qo_2a + qo_2b,
      qo_2_right = qo_2 - qo_2a;
  const double qo_3a = KSL_MUL(dci[1], qi->w), qo_3b = KSL_MUL(dci[0], qi->x), qo_3 = qo_3a - qo_3b,
      qo_3_right = qo_3a - qo_3;
  const double qo_0_rounded = qo_0
          + (ksl_product_rest(dci[0], qi->w, qo_0a, qo_0 - qo_0_right)
          + ksl_product_rest(dci[1], qi->x, qo_0b, qo_0_right)),
      qo_1_rounded = qo_1
          + (ksl_product_rest(dci[1], qi->y, qo_1a, qo_1 + qo_1_right)
          - ksl_product_rest(dci[0], qi->z, qo_1b, qo_1_right)),
      qo_2_rounded = qo_2
          + (ksl_product_rest(dci[0], qi->y, qo_2a, qo_2 - qo_2_right)
          + ksl_product_rest(dci[1], qi->z, qo_2b, qo_2_right)),
      qo_3_rounded = qo_3
          + (ksl_product_rest(dci[1], qi->w, qo_3a, qo_3 + qo_3_right)
          - ksl_product_rest(dci[0], qi->x, qo_3b, qo_3_right));
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
      qo_0_right = qo_0a - qo_0;
  const double qo_1a = KSL_MUL(dci[0], qi->z), qo_1b = KSL_MUL(dci[1], qi->y), qo_1 = qo_1a - qo_1b,
      qo_1_right = qo_1a - qo_1;
  const double qo_2a = KSL_MUL(dci[0], qi->y), qo_2b = KSL_MUL(dci[1], qi->z),
      qo_2c = qo_2a + qo_2b, qo_2c_right = qo_2c - qo_2a, qo_2 = -qo_2c;
  const double qo_3a = KSL_MUL(dci[0], qi->x), qo_3b = KSL_MUL(dci[1], qi->w), qo_3 = qo_3a + qo_3b,
      qo_3_right = qo_3 - qo_3a;
  const double qo_0_rounded = qo_0
          + (ksl_product_rest(dci[0], qi->w, qo_0a, qo_0 + qo_0_right)
          - ksl_product_rest(dci[1], qi->x, qo_0b, qo_0_right)),
      qo_1_rounded = qo_1
          + (ksl_product_rest(dci[0], qi->z, qo_1a, qo_1 + qo_1_right)
          - ksl_product_rest(dci[1], qi->y, qo_1b, qo_1_right)),
      qo_2_rounded = qo_2 +
          -(ksl_product_rest(dci[0], qi->y, qo_2a, qo_2c - qo_2c_right)
          + ksl_product_rest(dci[1], qi->z, qo_2b, qo_2c_right)),
      qo_3_rounded = qo_3
          + (ksl_product_rest(dci[0], qi->x, qo_3a, qo_3 - qo_3_right)
          + ksl_product_rest(dci[1], qi->w, qo_3b, qo_3_right));
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
      qo_0_right = qo_0a - qo_0;
  const double qo_1a = KSL_MUL(dci[0], qi->z), qo_1b = KSL_MUL(dci[1], qi->y), qo_1 = qo_1a + qo_1b,
      qo_1_right = qo_1 - qo_1a;
  const double qo_2a = KSL_MUL(dci[1], qi->z), qo_2b = KSL_MUL(dci[0], qi->y), qo_2 = qo_2a - qo_2b,
      qo_2_right = qo_2a - qo_2;
  const double qo_3a = KSL_MUL(dci[0], qi->x), qo_3b = KSL_MUL(dci[1], qi->w), qo_3 = qo_3a + qo_3b,
      qo_3_right = qo_3 - qo_3a;
  const double qo_0_rounded = qo_0
          + (ksl_product_rest(dci[1], qi->x, qo_0a, qo_0 + qo_0_right)
          - ksl_product_rest(dci[0], qi->w, qo_0b, qo_0_right)),
      qo_1_rounded = qo_1
          + (ksl_product_rest(dci[0], qi->z, qo_1a, qo_1 - qo_1_right)
          + ksl_product_rest(dci[1], qi->y, qo_1b, qo_1_right)),
      qo_2_rounded = qo_2
          + (ksl_product_rest(dci[1], qi->z, qo_2a, qo_2 + qo_2_right)
          - ksl_product_rest(dci[0], qi->y, qo_2b, qo_2_right)),
      qo_3_rounded = qo_3
          + (ksl_product_rest(dci[0], qi->x, qo_3a, qo_3 - qo_3_right)
          + ksl_product_rest(dci[1], qi->w, qo_3b, qo_3_right));
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
      qo_0c = qo_0a + qo_0b, qo_0c_right = qo_0c - qo_0a, qo_0 = -qo_0c;
  const double qo_1a = KSL_MUL(dci[0], qi->z), qo_1b = KSL_MUL(dci[1], qi->y),
      qo_1c = qo_1a + qo_1b, qo_1c_right = qo_1c - qo_1a, qo_1 = -qo_1c;
  const double qo_2a = KSL_MUL(dci[0], qi->y), qo_2b = KSL_MUL(dci[1], qi->z), qo_2 = qo_2a - qo_2b,
      qo_2_right = qo_2a - qo_2;
  const double qo_3a = KSL_MUL(dci[1], qi->w), qo_3b = KSL_MUL(dci[0], qi->x), qo_3 = qo_3a - qo_3b,
      qo_3_right = qo_3a - qo_3;
  const double qo_0_rounded = qo_0 +
          -(ksl_product_rest(dci[0], qi->w, qo_0a, qo_0c - qo_0c_right)
          + ksl_product_rest(dci[1], qi->x, qo_0b, qo_0c_right)),
      qo_1_rounded = qo_1 +
          -(ksl_product_rest(dci[0], qi->z, qo_1a, qo_1c - qo_1c_right)
          + ksl_product_rest(dci[1], qi->y, qo_1b, qo_1c_right)),
      qo_2_rounded = qo_2
          + (ksl_product_rest(dci[0], qi->y, qo_2a, qo_2 + qo_2_right)
          - ksl_product_rest(dci[1], qi->z, qo_2b, qo_2_right)),
      qo_3_rounded = qo_3
          + (ksl_product_rest(dci[1], qi->w, qo_3a, qo_3 + qo_3_right)
          - ksl_product_rest(dci[0], qi->x, qo_3b, qo_3_right));
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
      qo_0_right = qo_0 - qo_0a;
  const double qo_1a = KSL_MUL(qi->y, dci[1]), qo_1b = KSL_MUL(qi->z, dci[0]), qo_1 = qo_1a + qo_1b,
      qo_1_right = qo_1 - qo_1a;
  const double qo_2a = KSL_MUL(qi->z, dci[1]), qo_2b = KSL_MUL(qi->y, dci[0]), qo_2 = qo_2a - qo_2b,
      qo_2_right = qo_2a - qo_2;
  const double qo_3a = KSL_MUL(qi->w, dci[1]), qo_3b = KSL_MUL(qi->x, dci[0]), qo_3 = qo_3a - qo_3b,
      qo_3_right = qo_3a - qo_3;
  const double qo_0_rounded = qo_0
          + (ksl_product_rest(qi->x, dci[1], qo_0a, qo_0 - qo_0_right)
          + ksl_product_rest(qi->w, dci[0], qo_0b, qo_0_right)),
      qo_1_rounded = qo_1
          + (ksl_product_rest(qi->y, dci[1], qo_1a, qo_1 - qo_1_right)
          + ksl_product_rest(qi->z, dci[0], qo_1b, qo_1_right)),
      qo_2_rounded = qo_2
          + (ksl_product_rest(qi->z, dci[1], qo_2a, qo_2 + qo_2_right)
          - ksl_product_rest(qi->y, dci[0], qo_2b, qo_2_right)),
      qo_3_rounded = qo_3
          + (ksl_product_rest(qi->w, dci[1], qo_3a, qo_3 + qo_3_right)
          - ksl_product_rest(qi->x, dci[0], qo_3b, qo_3_right));
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
      qo_0_right = qo_0a - qo_0;
  const double qo_1a = KSL_MUL(qi->y, dci[1]), qo_1b = KSL_MUL(qi->z, dci[0]), qo_1 = qo_1a - qo_1b,
      qo_1_right = qo_1a - qo_1;
  const double qo_2a = KSL_MUL(qi->y, dci[0]), qo_2b = KSL_MUL(qi->z, dci[1]), qo_2 = qo_2a + qo_2b,
      qo_2_right = qo_2 - qo_2a;
  const double qo_3a = KSL_MUL(qi->x, dci[0]), qo_3b = KSL_MUL(qi->w, dci[1]), qo_3 = qo_3a + qo_3b,
      qo_3_right = qo_3 - qo_3a;
  const double qo_0_rounded = qo_0
          + (ksl_product_rest(qi->x, dci[1], qo_0a, qo_0 + qo_0_right)
          - ksl_product_rest(qi->w, dci[0], qo_0b, qo_0_right)),
      qo_1_rounded = qo_1
          + (ksl_product_rest(qi->y, dci[1], qo_1a, qo_1 + qo_1_right)
          - ksl_product_rest(qi->z, dci[0], qo_1b, qo_1_right)),
      qo_2_rounded = qo_2
          + (ksl_product_rest(qi->y, dci[0], qo_2a, qo_2 - qo_2_right)
          + ksl_product_rest(qi->z, dci[1], qo_2b, qo_2_right)),
      qo_3_rounded = qo_3
          + (ksl_product_rest(qi->x, dci[0], qo_3a, qo_3 - qo_3_right)
          + ksl_product_rest(qi->w, dci[1], qo_3b, qo_3_right));
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
      qo_0_right = qo_0a - qo_0;
  const double qo_1a = KSL_MUL(qi->y, dci[1]), qo_1b = KSL_MUL(qi->z, dci[0]),
      qo_1c = qo_1a + qo_1b, qo_1c_right = qo_1c - qo_1a, qo_1 = -qo_1c;
  const double qo_2a = KSL_MUL(qi->y, dci[0]), qo_2b = KSL_MUL(qi->z, dci[1]), qo_2 = qo_2a - qo_2b,
      qo_2_right = qo_2a - qo_2;
  const double qo_3a = KSL_MUL(qi->x, dci[0]), qo_3b = KSL_MUL(qi->w, dci[1]), qo_3 = qo_3a + qo_3b,
      qo_3_right = qo_3 - qo_3a;
  const double qo_0_rounded = qo_0
          + (ksl_product_rest(qi->w, dci[0], qo_0a, qo_0 + qo_0_right)
          - ksl_product_rest(qi->x, dci[1], qo_0b, qo_0_right)),
      qo_1_rounded = qo_1 +
          -(ksl_product_rest(qi->y, dci[1], qo_1a, qo_1c - qo_1c_right)
          + ksl_product_rest(qi->z, dci[0], qo_1b, qo_1c_right)),
      qo_2_rounded = qo_2
          + (ksl_product_rest(qi->y, dci[0], qo_2a, qo_2 + qo_2_right)
          - ksl_product_rest(qi->z, dci[1], qo_2b, qo_2_right)),
      qo_3_rounded = qo_3
          + (ksl_product_rest(qi->x, dci[0], qo_3a, qo_3 - qo_3_right)
          + ksl_product_rest(qi->w, dci[1], qo_3b, qo_3_right));
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
      qo_0c = qo_0a + qo_0b, qo_0c_right = qo_0c - qo_0a, qo_0 = -qo_0c;
  const double qo_1a = KSL_MUL(qi->z, dci[0]), qo_1b = KSL_MUL(qi->y, dci[1]), qo_1 = qo_1a - qo_1b,
      qo_1_right = qo_1a - qo_1;
  const double qo_2a = KSL_MUL(qi->y, dci[0]), qo_2b = KSL_MUL(qi->z, dci[1]),
      qo_2c = qo_2a + qo_2b, qo_2c_right = qo_2c - qo_2a, qo_2 = -qo_2c;
  const double qo_3a = KSL_MUL(qi->w, dci[1]), qo_3b = KSL_MUL(qi->x, dci[0]), qo_3 = qo_3a - qo_3b,
      qo_3_right = qo_3a - qo_3;
  const double qo_0_rounded = qo_0 +
          -(ksl_product_rest(qi->x, dci[1], qo_0a, qo_0c - qo_0c_right)
          + ksl_product_rest(qi->w, dci[0], qo_0b, qo_0c_right)),
      qo_1_rounded = qo_1
          + (ksl_product_rest(qi->z, dci[0], qo_1a, qo_1 + qo_1_right)
          - ksl_product_rest(qi->y, dci[1], qo_1b, qo_1_right)),
      qo_2_rounded = qo_2 +
          -(ksl_product_rest(qi->y, dci[0], qo_2a, qo_2c - qo_2c_right)
          + ksl_product_rest(qi->z, dci[1], qo_2b, qo_2c_right)),
      qo_3_rounded = qo_3
          + (ksl_product_rest(qi->w, dci[1], qo_3a, qo_3 + qo_3_right)
          - ksl_product_rest(qi->x, dci[0], qo_3b, qo_3_right));
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
      qo_0_right = qo_0 - qo_0a;
  const double qo_1a = KSL_MUL(dci[0], qi->w), qo_1b = KSL_MUL(dci[1], qi->y), qo_1 = qo_1a + qo_1b,
      qo_1_right = qo_1 - qo_1a;
  const double qo_2a = KSL_MUL(dci[1], qi->z), qo_2b = KSL_MUL(dci[0], qi->x), qo_2 = qo_2a - qo_2b,
      qo_2_right = qo_2a - qo_2;
  const double qo_3a = KSL_MUL(dci[1], qi->w), qo_3b = KSL_MUL(dci[0], qi->y), qo_3 = qo_3a - qo_3b,
      qo_3_right = qo_3a - qo_3;
  const double qo_0_rounded = qo_0
          + (ksl_product_rest(dci[0], qi->z, qo_0a, qo_0 - qo_0_right)
          + ksl_product_rest(dci[1], qi->x, qo_0b, qo_0_right)),
      qo_1_rounded = qo_1
          + (ksl_product_rest(dci[0], qi->w, qo_1a, qo_1 - qo_1_right)
          + ksl_product_rest(dci[1], qi->y, qo_1b, qo_1_right)),
      qo_2_rounded = qo_2
          + (ksl_product_rest(dci[1], qi->z, qo_2a, qo_2 + qo_2_right)
          - ksl_product_rest(dci[0], qi->x, qo_2b, qo_2_right)),
      qo_3_rounded = qo_3
          + (ksl_product_rest(dci[1], qi->w, qo_3a, qo_3 + qo_3_right)
          - ksl_product_rest(dci[0], qi->y, qo_3b, qo_3_right));
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
      qo_0c = qo_0a + qo_0b, qo_0c_right = qo_0c - qo_0a, qo_0 = -qo_0c;
  const double qo_1a = KSL_MUL(dci[0], qi->w), qo_1b = KSL_MUL(dci[1], qi->y), qo_1 = qo_1a - qo_1b,
      qo_1_right = qo_1a - qo_1;
  const double qo_2a = KSL_MUL(dci[0], qi->x), qo_2b = KSL_MUL(dci[1], qi->z), qo_2 = qo_2a - qo_2b,
      qo_2_right = qo_2a - qo_2;
  const double qo_3a = KSL_MUL(dci[0], qi->y), qo_3b = KSL_MUL(dci[1], qi->w), qo_3 = qo_3a + qo_3b,
      qo_3_right = qo_3 - qo_3a;
  const double qo_0_rounded = qo_0 +
          -(ksl_product_rest(dci[0], qi->z, qo_0a, qo_0c - qo_0c_right)
          + ksl_product_rest(dci[1], qi->x, qo_0b, qo_0c_right)),
      qo_1_rounded = qo_1
          + (ksl_product_rest(dci[0], qi->w, qo_1a, qo_1 + qo_1_right)
          - ksl_product_rest(dci[1], qi->y, qo_1b, qo_1_right)),
      qo_2_rounded = qo_2
          + (ksl_product_rest(dci[0], qi->x, qo_2a, qo_2 + qo_2_right)
          - ksl_product_rest(dci[1], qi->z, qo_2b, qo_2_right)),
      qo_3_rounded = qo_3
          + (ksl_product_rest(dci[0], qi->y, qo_3a, qo_3 - qo_3_right)
          + ksl_product_rest(dci[1], qi->w, qo_3b, qo_3_right));
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
      qo_0_right = qo_0a - qo_0;
  const double qo_1a = KSL_MUL(dci[1], qi->y), qo_1b = KSL_MUL(dci[0], qi->w), qo_1 = qo_1a - qo_1b,
      qo_1_right = qo_1a - qo_1;
  const double qo_2a = KSL_MUL(dci[0], qi->x), qo_2b = KSL_MUL(dci[1], qi->z), qo_2 = qo_2a + qo_2b,
      qo_2_right = qo_2 - qo_2a;
  const double qo_3a = KSL_MUL(dci[0], qi->y), qo_3b = KSL_MUL(dci[1], qi->w), qo_3 = qo_3a + qo_3b,
      qo_3_right = qo_3 - qo_3a;
  const double qo_0_rounded = qo_0
          + (ksl_product_rest(dci[1], qi->x, qo_0a, qo_0 + qo_0_right)
          - ksl_product_rest(dci[0], qi->z, qo_0b, qo_0_right)),
      qo_1_rounded = qo_1
          + (ksl_product_rest(dci[1], qi->y, qo_1a, qo_1 + qo_1_right)
          - ksl_product_rest(dci[0], qi->w, qo_1b, qo_1_right)),
      qo_2_rounded = qo_2
          + (ksl_product_rest(dci[0], qi->x, qo_2a, qo_2 - qo_2_right)
          + ksl_product_rest(dci[1], qi->z, qo_2b, qo_2_right)),
      qo_3_rounded = qo_3
          + (ksl_product_rest(dci[0], qi->y, qo_3a, qo_3 - qo_3_right)
          + ksl_product_rest(dci[1], qi->w, qo_3b, qo_3_right));
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
      qo_0_right = qo_0a - qo_0;
  const double qo_1a = KSL_MUL(dci[0], qi->w), qo_1b = KSL_MUL(dci[1], qi->y),
      qo_1c = qo_1a + qo_1b, qo_1c_right = qo_1c - qo_1a, qo_1 = -qo_1c;
  const double qo_2a = KSL_MUL(dci[0], qi->x), qo_2b = KSL_MUL(dci[1], qi->z),
      qo_2c = qo_2a + qo_2b, qo_2c_right = qo_2c - qo_2a, qo_2 = -qo_2c;
  const double qo_3a = KSL_MUL(dci[1], qi->w), qo_3b = KSL_MUL(dci[0], qi->y), qo_3 = qo_3a - qo_3b,
      qo_3_right = qo_3a - qo_3;
  const double qo_0_rounded = qo_0
          + (ksl_product_rest(dci[0], qi->z, qo_0a, qo_0 + qo_0_right)
          - ksl_product_rest(dci[1], qi->x, qo_0b, qo_0_right)),
      qo_1_rounded = qo_1 +
          -(ksl_product_rest(dci[0], qi->w, qo_1a, qo_1c - qo_1c_right)
          + ksl_product_rest(dci[1], qi->y, qo_1b, qo_1c_right)),
      qo_2_rounded = qo_2 +
          -(ksl_product_rest(dci[0], qi->x, qo_2a, qo_2c - qo_2c_right)
          + ksl_product_rest(dci[1], qi->z, qo_2b, qo_2c_right)),
      qo_3_rounded = qo_3
          + (ksl_product_rest(dci[1], qi->w, qo_3a, qo_3 + qo_3_right)
          - ksl_product_rest(dci[0], qi->y, qo_3b, qo_3_right));
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
      qo_0_right = qo_0a - qo_0;
  const double qo_1a = KSL_MUL(qi->y, dci[1]), qo_1b = KSL_MUL(qi->w, dci[0]), qo_1 = qo_1a + qo_1b,
      qo_1_right = qo_1 - qo_1a;
  const double qo_2a = KSL_MUL(qi->x, dci[0]), qo_2b = KSL_MUL(qi->z, dci[1]), qo_2 = qo_2a + qo_2b,
      qo_2_right = qo_2 - qo_2a;
  const double qo_3a = KSL_MUL(qi->w, dci[1]), qo_3b = KSL_MUL(qi->y, dci[0]), qo_3 = qo_3a - qo_3b,
      qo_3_right = qo_3a - qo_3;
  const double qo_0_rounded = qo_0
          + (ksl_product_rest(qi->x, dci[1], qo_0a, qo_0 + qo_0_right)
          - ksl_product_rest(qi->z, dci[0], qo_0b, qo_0_right)),
      qo_1_rounded = qo_1
          + (ksl_product_rest(qi->y, dci[1], qo_1a, qo_1 - qo_1_right)
          + ksl_product_rest(qi->w, dci[0], qo_1b, qo_1_right)),
      qo_2_rounded = qo_2
          + (ksl_product_rest(qi->x, dci[0], qo_2a, qo_2 - qo_2_right)
          + ksl_product_rest(qi->z, dci[1], qo_2b, qo_2_right)),
      qo_3_rounded = qo_3
          + (ksl_product_rest(qi->w, dci[1], qo_3a, qo_3 + qo_3_right)
          - ksl_product_rest(qi->y, dci[0], qo_3b, qo_3_right));
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
      qo_0_right = qo_0 - qo_0a;
  const double qo_1a = KSL_MUL(qi->y, dci[1]), qo_1b = KSL_MUL(qi->w, dci[0]), qo_1 = qo_1a - qo_1b,
      qo_1_right = qo_1a - qo_1;
  const double qo_2a = KSL_MUL(qi->z, dci[1]), qo_2b = KSL_MUL(qi->x, dci[0]), qo_2 = qo_2a - qo_2b,
      qo_2_right = qo_2a - qo_2;
  const double qo_3a = KSL_MUL(qi->y, dci[0]), qo_3b = KSL_MUL(qi->w, dci[1]), qo_3 = qo_3a + qo_3b,
      qo_3_right = qo_3 - qo_3a;
  const double qo_0_rounded = qo_0
          + (ksl_product_rest(qi->x, dci[1], qo_0a, qo_0 - qo_0_right)
          + ksl_product_rest(qi->z, dci[0], qo_0b, qo_0_right)),
      qo_1_rounded = qo_1
          + (ksl_product_rest(qi->y, dci[1], qo_1a, qo_1 + qo_1_right)
          - ksl_product_rest(qi->w, dci[0], qo_1b, qo_1_right)),
      qo_2_rounded = qo_2
          + (ksl_product_rest(qi->z, dci[1], qo_2a, qo_2 + qo_2_right)
          - ksl_product_rest(qi->x, dci[0], qo_2b, qo_2_right)),
      qo_3_rounded = qo_3
          + (ksl_product_rest(qi->y, dci[0], qo_3a, qo_3 - qo_3_right)
          + ksl_product_rest(qi->w, dci[1], qo_3b, qo_3_right));
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
      qo_0_right = qo_0a - qo_0;
  const double qo_1a = KSL_MUL(qi->w, dci[0]), qo_1b = KSL_MUL(qi->y, dci[1]), qo_1 = qo_1a - qo_1b,
      qo_1_right = qo_1a - qo_1;
  const double qo_2a = KSL_MUL(qi->x, dci[0]), qo_2b = KSL_MUL(qi->z, dci[1]),
      qo_2c = qo_2a + qo_2b, qo_2c_right = qo_2c - qo_2a, qo_2 = -qo_2c;
  const double qo_3a = KSL_MUL(qi->y, dci[0]), qo_3b = KSL_MUL(qi->w, dci[1]), qo_3 = qo_3a + qo_3b,
      qo_3_right = qo_3 - qo_3a;
  const double qo_0_rounded = qo_0
          + (ksl_product_rest(qi->z, dci[0], qo_0a, qo_0 + qo_0_right)
          - ksl_product_rest(qi->x, dci[1], qo_0b, qo_0_right)),
      qo_1_rounded = qo_1
          + (ksl_product_rest(qi->w, dci[0], qo_1a, qo_1 + qo_1_right)
          - ksl_product_rest(qi->y, dci[1], qo_1b, qo_1_right)),
      qo_2_rounded = qo_2 +
          -(ksl_product_rest(qi->x, dci[0], qo_2a, qo_2c - qo_2c_right)
          + ksl_product_rest(qi->z, dci[1], qo_2b, qo_2c_right)),
      qo_3_rounded = qo_3
          + (ksl_product_rest(qi->y, dci[0], qo_3a, qo_3 - qo_3_right)
          + ksl_product_rest(qi->w, dci[1], qo_3b, qo_3_right));
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
      qo_0c = qo_0a + qo_0b, qo_0c_right = qo_0c - qo_0a, qo_0 = -qo_0c;
  const double qo_1a = KSL_MUL(qi->y, dci[1]), qo_1b = KSL_MUL(qi->w, dci[0]),
      qo_1c = qo_1a + qo_1b, qo_1c_right = qo_1c - qo_1a, qo_1 = -qo_1c;
  const double qo_2a = KSL_MUL(qi->x, dci[0]), qo_2b = KSL_MUL(qi->z, dci[1]), qo_2 = qo_2a - qo_2b,
      qo_2_right = qo_2a - qo_2;
  const double qo_3a = KSL_MUL(qi->w, dci[1]), qo_3b = KSL_MUL(qi->y, dci[0]), qo_3 = qo_3a - qo_3b,
      qo_3_right = qo_3a - qo_3;
  const double qo_0_rounded = qo_0 +
          -(ksl_product_rest(qi->x, dci[1], qo_0a, qo_0c - qo_0c_right)
          + ksl_product_rest(qi->z, dci[0], qo_0b, qo_0c_right)),
      qo_1_rounded = qo_1 +
          -(ksl_product_rest(qi->y, dci[1], qo_1a, qo_1c - qo_1c_right)
          + ksl_product_rest(qi->w, dci[0], qo_1b, qo_1c_right)),
      qo_2_rounded = qo_2
          + (ksl_product_rest(qi->x, dci[0], qo_2a, qo_2 + qo_2_right)
          - ksl_product_rest(qi->z, dci[1], qo_2b, qo_2_right)),
      qo_3_rounded = qo_3
          + (ksl_product_rest(qi->w, dci[1], qo_3a, qo_3 + qo_3_right)
          - ksl_product_rest(qi->y, dci[0], qo_3b, qo_3_right));
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
      qo_0_right = qo_0a - qo_0;
  const double qo_1a = KSL_MUL(dci[0], qi->x), qo_1b = KSL_MUL(dci[1], qi->y), qo_1 = qo_1a + qo_1b,
      qo_1_right = qo_1 - qo_1a;
  const double qo_2a = KSL_MUL(dci[0], qi->w), qo_2b = KSL_MUL(dci[1], qi->z), qo_2 = qo_2a + qo_2b,
      qo_2_right = qo_2 - qo_2a;
  const double qo_3a = KSL_MUL(dci[1], qi->w), qo_3b = KSL_MUL(dci[0], qi->z), qo_3 = qo_3a - qo_3b,
      qo_3_right = qo_3a - qo_3;
  const double qo_0_rounded = qo_0
          + (ksl_product_rest(dci[1], qi->x, qo_0a, qo_0 + qo_0_right)
          - ksl_product_rest(dci[0], qi->y, qo_0b, qo_0_right)),
      qo_1_rounded = qo_1
          + (ksl_product_rest(dci[0], qi->x, qo_1a, qo_1 - qo_1_right)
          + ksl_product_rest(dci[1], qi->y, qo_1b, qo_1_right)),
      qo_2_rounded = qo_2
          + (ksl_product_rest(dci[0], qi->w, qo_2a, qo_2 - qo_2_right)
          + ksl_product_rest(dci[1], qi->z, qo_2b, qo_2_right)),
      qo_3_rounded = qo_3
          + (ksl_product_rest(dci[1], qi->w, qo_3a, qo_3 + qo_3_right)
          - ksl_product_rest(dci[0], qi->z, qo_3b, qo_3_right));
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
      qo_0_right = qo_0a - qo_0;
  const double qo_1a = KSL_MUL(dci[0], qi->x), qo_1b = KSL_MUL(dci[1], qi->y),
      qo_1c = qo_1a + qo_1b, qo_1c_right = qo_1c - qo_1a, qo_1 = -qo_1c;
  const double qo_2a = KSL_MUL(dci[0], qi->w), qo_2b = KSL_MUL(dci[1], qi->z), qo_2 = qo_2a - qo_2b,
      qo_2_right = qo_2a - qo_2;
  const double qo_3a = KSL_MUL(dci[0], qi->z), qo_3b = KSL_MUL(dci[1], qi->w), qo_3 = qo_3a + qo_3b,
      qo_3_right = qo_3 - qo_3a;
  const double qo_0_rounded = qo_0
          + (ksl_product_rest(dci[0], qi->y, qo_0a, qo_0 + qo_0_right)
          - ksl_product_rest(dci[1], qi->x, qo_0b, qo_0_right)),
      qo_1_rounded = qo_1 +
          -(ksl_product_rest(dci[0], qi->x, qo_1a, qo_1c - qo_1c_right)
          + ksl_product_rest(dci[1], qi->y, qo_1b, qo_1c_right)),
      qo_2_rounded = qo_2
          + (ksl_product_rest(dci[0], qi->w, qo_2a, qo_2 + qo_2_right)
          - ksl_product_rest(dci[1], qi->z, qo_2b, qo_2_right)),
      qo_3_rounded = qo_3
          + (ksl_product_rest(dci[0], qi->z, qo_3a, qo_3 - qo_3_right)
          + ksl_product_rest(dci[1], qi->w, qo_3b, qo_3_right));
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
      qo_0_right = qo_0 - qo_0a;
  const double qo_1a = KSL_MUL(dci[1], qi->y), qo_1b = KSL_MUL(dci[0], qi->x), qo_1 = qo_1a - qo_1b,
      qo_1_right = qo_1a - qo_1;
  const double qo_2a = KSL_MUL(dci[1], qi->z), qo_2b = KSL_MUL(dci[0], qi->w), qo_2 = qo_2a - qo_2b,
      qo_2_right = qo_2a - qo_2;
  const double qo_3a = KSL_MUL(dci[0], qi->z), qo_3b = KSL_MUL(dci[1], qi->w), qo_3 = qo_3a + qo_3b,
      qo_3_right = qo_3 - qo_3a;
  const double qo_0_rounded = qo_0
          + (ksl_product_rest(dci[0], qi->y, qo_0a, qo_0 - qo_0_right)
          + ksl_product_rest(dci[1], qi->x, qo_0b, qo_0_right)),
      qo_1_rounded = qo_1
          + (ksl_product_rest(dci[1], qi->y, qo_1a, qo_1 + qo_1_right)
          - ksl_product_rest(dci[0], qi->x, qo_1b, qo_1_right)),
      qo_2_rounded = qo_2
          + (ksl_product_rest(dci[1], qi->z, qo_2a, qo_2 + qo_2_right)
          - ksl_product_rest(dci[0], qi->w, qo_2b, qo_2_right)),
      qo_3_rounded = qo_3
          + (ksl_product_rest(dci[0], qi->z, qo_3a, qo_3 - qo_3_right)
          + ksl_product_rest(dci[1], qi->w, qo_3b, qo_3_right));
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
      qo_0c = qo_0a + qo_0b, qo_0c_right = qo_0c - qo_0a, qo_0 = -qo_0c;
  const double qo_1a = KSL_MUL(dci[0], qi->x), qo_1b = KSL_MUL(dci[1], qi->y), qo_1 = qo_1a - qo_1b,
      qo_1_right = qo_1a - qo_1;
  const double qo_2a = KSL_MUL(dci[0], qi->w), qo_2b = KSL_MUL(dci[1], qi->z),
      qo_2c = qo_2a + qo_2b, qo_2c_right = qo_2c - qo_2a, qo_2 = -qo_2c;
  const double qo_3a = KSL_MUL(dci[1], qi->w), qo_3b = KSL_MUL(dci[0], qi->z), qo_3 = qo_3a - qo_3b,
      qo_3_right = qo_3a - qo_3;
  const double qo_0_rounded = qo_0 +
          -(ksl_product_rest(dci[0], qi->y, qo_0a, qo_0c - qo_0c_right)
          + ksl_product_rest(dci[1], qi->x, qo_0b, qo_0c_right)),
      qo_1_rounded = qo_1
          + (ksl_product_rest(dci[0], qi->x, qo_1a, qo_1 + qo_1_right)
          - ksl_product_rest(dci[1], qi->y, qo_1b, qo_1_right)),
      qo_2_rounded = qo_2 +
          -(ksl_product_rest(dci[0], qi->w, qo_2a, qo_2c - qo_2c_right)
          + ksl_product_rest(dci[1], qi->z, qo_2b, qo_2c_right)),
      qo_3_rounded = qo_3
          + (ksl_product_rest(dci[1], qi->w, qo_3a, qo_3 + qo_3_right)
          - ksl_product_rest(dci[0], qi->z, qo_3b, qo_3_right));
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
      qo_0_right = qo_0 - qo_0a;
  const double qo_1a = KSL_MUL(qi->y, dci[1]), qo_1b = KSL_MUL(qi->x, dci[0]), qo_1 = qo_1a - qo_1b,
      qo_1_right = qo_1a - qo_1;
  const double qo_2a = KSL_MUL(qi->z, dci[1]), qo_2b = KSL_MUL(qi->w, dci[0]), qo_2 = qo_2a + qo_2b,
      qo_2_right = qo_2 - qo_2a;
  const double qo_3a = KSL_MUL(qi->w, dci[1]), qo_3b = KSL_MUL(qi->z, dci[0]), qo_3 = qo_3a - qo_3b,
      qo_3_right = qo_3a - qo_3;
  const double qo_0_rounded = qo_0
          + (ksl_product_rest(qi->x, dci[1], qo_0a, qo_0 - qo_0_right)
          + ksl_product_rest(qi->y, dci[0], qo_0b, qo_0_right)),
      qo_1_rounded = qo_1
          + (ksl_product_rest(qi->y, dci[1], qo_1a, qo_1 + qo_1_right)
          - ksl_product_rest(qi->x, dci[0], qo_1b, qo_1_right)),
      qo_2_rounded = qo_2
          + (ksl_product_rest(qi->z, dci[1], qo_2a, qo_2 - qo_2_right)
          + ksl_product_rest(qi->w, dci[0], qo_2b, qo_2_right)),
      qo_3_rounded = qo_3
          + (ksl_product_rest(qi->w, dci[1], qo_3a, qo_3 + qo_3_right)
          - ksl_product_rest(qi->z, dci[0], qo_3b, qo_3_right));
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
      qo_0_right = qo_0a - qo_0;
  const double qo_1a = KSL_MUL(qi->x, dci[0]), qo_1b = KSL_MUL(qi->y, dci[1]), qo_1 = qo_1a + qo_1b,
      qo_1_right = qo_1 - qo_1a;
  const double qo_2a = KSL_MUL(qi->z, dci[1]), qo_2b = KSL_MUL(qi->w, dci[0]), qo_2 = qo_2a - qo_2b,
      qo_2_right = qo_2a - qo_2;
  const double qo_3a = KSL_MUL(qi->z, dci[0]), qo_3b = KSL_MUL(qi->w, dci[1]), qo_3 = qo_3a + qo_3b,
      qo_3_right = qo_3 - qo_3a;
  const double qo_0_rounded = qo_0
          + (ksl_product_rest(qi->x, dci[1], qo_0a, qo_0 + qo_0_right)
          - ksl_product_rest(qi->y, dci[0], qo_0b, qo_0_right)),
      qo_1_rounded = qo_1
          + (ksl_product_rest(qi->x, dci[0], qo_1a, qo_1 - qo_1_right)
          + ksl_product_rest(qi->y, dci[1], qo_1b, qo_1_right)),
      qo_2_rounded = qo_2
          + (ksl_product_rest(qi->z, dci[1], qo_2a, qo_2 + qo_2_right)
          - ksl_product_rest(qi->w, dci[0], qo_2b, qo_2_right)),
      qo_3_rounded = qo_3
          + (ksl_product_rest(qi->z, dci[0], qo_3a, qo_3 - qo_3_right)
          + ksl_product_rest(qi->w, dci[1], qo_3b, qo_3_right));
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
      qo_0c = qo_0a + qo_0b, qo_0c_right = qo_0c - qo_0a, qo_0 = -qo_0c;
  const double qo_1a = KSL_MUL(qi->x, dci[0]), qo_1b = KSL_MUL(qi->y, dci[1]), qo_1 = qo_1a - qo_1b,
      qo_1_right = qo_1a - qo_1;
  const double qo_2a = KSL_MUL(qi->w, dci[0]), qo_2b = KSL_MUL(qi->z, dci[1]), qo_2 = qo_2a - qo_2b,
      qo_2_right = qo_2a - qo_2;
  const double qo_3a = KSL_MUL(qi->z, dci[0]), qo_3b = KSL_MUL(qi->w, dci[1]), qo_3 = qo_3a + qo_3b,
      qo_3_right = qo_3 - qo_3a;
  const double qo_0_rounded = qo_0 +
          -(ksl_product_rest(qi->x, dci[1], qo_0a, qo_0c - qo_0c_right)
          + ksl_product_rest(qi->y, dci[0], qo_0b, qo_0c_right)),
      qo_1_rounded = qo_1
          + (ksl_product_rest(qi->x, dci[0], qo_1a, qo_1 + qo_1_right)
          - ksl_product_rest(qi->y, dci[1], qo_1b, qo_1_right)),
      qo_2_rounded = qo_2
          + (ksl_product_rest(qi->w, dci[0], qo_2a, qo_2 + qo_2_right)
          - ksl_product_rest(qi->z, dci[1], qo_2b, qo_2_right)),
      qo_3_rounded = qo_3
          + (ksl_product_rest(qi->z, dci[0], qo_3a, qo_3 - qo_3_right)
          + ksl_product_rest(qi->w, dci[1], qo_3b, qo_3_right));
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
      qo_0_right = qo_0a - qo_0;
  const double qo_1a = KSL_MUL(qi->x, dci[0]), qo_1b = KSL_MUL(qi->y, dci[1]),
      qo_1c = qo_1a + qo_1b, qo_1c_right = qo_1c - qo_1a, qo_1 = -qo_1c;
  const double qo_2a = KSL_MUL(qi->z, dci[1]), qo_2b = KSL_MUL(qi->w, dci[0]),
      qo_2c = qo_2a + qo_2b, qo_2c_right = qo_2c - qo_2a, qo_2 = -qo_2c;
  const double qo_3a = KSL_MUL(qi->w, dci[1]), qo_3b = KSL_MUL(qi->z, dci[0]), qo_3 = qo_3a - qo_3b,
      qo_3_right = qo_3a - qo_3;
  const double qo_0_rounded = qo_0
          + (ksl_product_rest(qi->y, dci[0], qo_0a, qo_0 + qo_0_right)
          - ksl_product_rest(qi->x, dci[1], qo_0b, qo_0_right)),
      qo_1_rounded = qo_1 +
          -(ksl_product_rest(qi->x, dci[0], qo_1a, qo_1c - qo_1c_right)
          + ksl_product_rest(qi->y, dci[1], qo_1b, qo_1c_right)),
      qo_2_rounded = qo_2 +
          -(ksl_product_rest(qi->z, dci[1], qo_2a, qo_2c - qo_2c_right)
          + ksl_product_rest(qi->w, dci[0], qo_2b, qo_2c_right)),
      qo_3_rounded = qo_3
          + (ksl_product_rest(qi->w, dci[1], qo_3a, qo_3 + qo_3_right)
          - ksl_product_rest(qi->z, dci[0], qo_3b, qo_3_right));
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
      qo_0c_right = qo_0a - qo_0c, qo_0d = KSL_MUL(qi->w, vi->x), qo_0 = qo_0c + qo_0d,
      qo_0_right = qo_0 - qo_0c,
      qo_0c_lo = ksl_product_rest(qi->y, vi->z, qo_0a, qo_0c + qo_0c_right)
          - ksl_product_rest(qi->z, vi->y, qo_0b, qo_0c_right);
  const double qo_1a = KSL_MUL(qi->z, vi->x), qo_1b = KSL_MUL(qi->x, vi->z), qo_1c = qo_1a - qo_1b,
      qo_1c_right = qo_1a - qo_1c, qo_1d = KSL_MUL(qi->w, vi->y), qo_1 = qo_1c + qo_1d,
      qo_1_right = qo_1 - qo_1c,
      qo_1c_lo = ksl_product_rest(qi->z, vi->x, qo_1a, qo_1c + qo_1c_right)
          - ksl_product_rest(qi->x, vi->z, qo_1b, qo_1c_right);
  const double qo_2a = KSL_MUL(qi->x, vi->y), qo_2b = KSL_MUL(qi->y, vi->x), qo_2c = qo_2a - qo_2b,
      qo_2c_right = qo_2a - qo_2c, qo_2d = KSL_MUL(qi->w, vi->z), qo_2 = qo_2c + qo_2d,
      qo_2_right = qo_2 - qo_2c,
      qo_2c_lo = ksl_product_rest(qi->x, vi->y, qo_2a, qo_2c + qo_2c_right)
          - ksl_product_rest(qi->y, vi->x, qo_2b, qo_2c_right);
  const double qo_3a = KSL_MUL(qi->x, vi->x), qo_3b = KSL_MUL(qi->y, vi->y), qo_3c = qo_3a + qo_3b,
      qo_3c_right = qo_3c - qo_3a, qo_3d = KSL_MUL(qi->z, vi->z), qo_3e = qo_3c + qo_3d,
      qo_3e_right = qo_3e - qo_3c,
      qo_3c_lo = ksl_product_rest(qi->x, vi->x, qo_3a, qo_3c - qo_3c_right)
          + ksl_product_rest(qi->y, vi->y, qo_3b, qo_3c_right), qo_3 = -qo_3e;
  const double qo_0_rounded = qo_0
          + (qo_0c - (qo_0 - qo_0_right) + ksl_product_rest(qi->w, vi->x, qo_0d, qo_0_right)
          + qo_0c_lo),
      qo_1_rounded = qo_1
          + (qo_1c - (qo_1 - qo_1_right) + ksl_product_rest(qi->w, vi->y, qo_1d, qo_1_right)
          + qo_1c_lo),
      qo_2_rounded = qo_2
          + (qo_2c - (qo_2 - qo_2_right) + ksl_product_rest(qi->w, vi->z, qo_2d, qo_2_right)
          + qo_2c_lo),
      qo_3_rounded = qo_3 +
          -(qo_3c - (qo_3e - qo_3e_right) + ksl_product_rest(qi->z, vi->z, qo_3d, qo_3e_right)
          + qo_3c_lo);
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
      qo_0c_right = qo_0a - qo_0c, qo_0d = KSL_MUL(qi->w, vi->x), qo_0 = qo_0c + qo_0d,
      qo_0_right = qo_0 - qo_0c,
      qo_0c_lo = ksl_product_rest(qi->z, vi->y, qo_0a, qo_0c + qo_0c_right)
          - ksl_product_rest(qi->y, vi->z, qo_0b, qo_0c_right);
  const double qo_1a = KSL_MUL(qi->x, vi->z), qo_1b = KSL_MUL(qi->z, vi->x), qo_1c = qo_1a - qo_1b,
      qo_1c_right = qo_1a - qo_1c, qo_1d = KSL_MUL(qi->w, vi->y), qo_1 = qo_1c + qo_1d,
      qo_1_right = qo_1 - qo_1c,
      qo_1c_lo = ksl_product_rest(qi->x, vi->z, qo_1a, qo_1c + qo_1c_right)
          - ksl_product_rest(qi->z, vi->x, qo_1b, qo_1c_right);
  const double qo_2a = KSL_MUL(qi->y, vi->x), qo_2b = KSL_MUL(qi->x, vi->y), qo_2c = qo_2a - qo_2b,
      qo_2c_right = qo_2a - qo_2c, qo_2d = KSL_MUL(qi->w, vi->z), qo_2 = qo_2c + qo_2d,
      qo_2_right = qo_2 - qo_2c,
      qo_2c_lo = ksl_product_rest(qi->y, vi->x, qo_2a, qo_2c + qo_2c_right)
          - ksl_product_rest(qi->x, vi->y, qo_2b, qo_2c_right);
  const double qo_3a = KSL_MUL(qi->x, vi->x), qo_3b = KSL_MUL(qi->y, vi->y), qo_3c = qo_3a + qo_3b,
      qo_3c_right = qo_3c - qo_3a, qo_3d = KSL_MUL(qi->z, vi->z), qo_3 = qo_3c + qo_3d,
      qo_3_right = qo_3 - qo_3c,
      qo_3c_lo = ksl_product_rest(qi->x, vi->x, qo_3a, qo_3c - qo_3c_right)
          + ksl_product_rest(qi->y, vi->y, qo_3b, qo_3c_right);
  const double qo_0_rounded = qo_0
          + (qo_0c - (qo_0 - qo_0_right) + ksl_product_rest(qi->w, vi->x, qo_0d, qo_0_right)
          + qo_0c_lo),
      qo_1_rounded = qo_1
          + (qo_1c - (qo_1 - qo_1_right) + ksl_product_rest(qi->w, vi->y, qo_1d, qo_1_right)
          + qo_1c_lo),
      qo_2_rounded = qo_2
          + (qo_2c - (qo_2 - qo_2_right) + ksl_product_rest(qi->w, vi->z, qo_2d, qo_2_right)
          + qo_2c_lo),
      qo_3_rounded = qo_3
          + (qo_3c - (qo_3 - qo_3_right) + ksl_product_rest(qi->z, vi->z, qo_3d, qo_3_right)
          + qo_3c_lo);
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
      qo_0 = qo_0a + qo_0d, qo_0_right = qo_0 - qo_0a,
      qo_0d_lo = ksl_product_rest(vi->y, qi->z, qo_0b, qo_0d + qo_0d_right)
          - ksl_product_rest(vi->z, qi->y, qo_0c, qo_0d_right);
  const double qo_1a = KSL_MUL(vi->z, qi->x), qo_1b = KSL_MUL(vi->x, qi->z), qo_1c = qo_1a - qo_1b,
      qo_1c_right = qo_1a - qo_1c, qo_1d = KSL_MUL(vi->y, qi->w), qo_1 = qo_1c + qo_1d,
      qo_1_right = qo_1 - qo_1c,
      qo_1c_lo = ksl_product_rest(vi->z, qi->x, qo_1a, qo_1c + qo_1c_right)
          - ksl_product_rest(vi->x, qi->z, qo_1b, qo_1c_right);
  const double qo_2a = KSL_MUL(vi->x, qi->y), qo_2b = KSL_MUL(vi->y, qi->x), qo_2c = qo_2a - qo_2b,
      qo_2c_right = qo_2a - qo_2c, qo_2d = KSL_MUL(vi->z, qi->w), qo_2 = qo_2c + qo_2d,
      qo_2_right = qo_2 - qo_2c,
      qo_2c_lo = ksl_product_rest(vi->x, qi->y, qo_2a, qo_2c + qo_2c_right)
          - ksl_product_rest(vi->y, qi->x, qo_2b, qo_2c_right);
  const double qo_3a = KSL_MUL(vi->x, qi->x), qo_3b = KSL_MUL(vi->y, qi->y), qo_3c = qo_3a + qo_3b,
      qo_3c_right = qo_3c - qo_3a, qo_3d = KSL_MUL(vi->z, qi->z), qo_3e = qo_3c + qo_3d,
      qo_3e_right = qo_3e - qo_3c,
      qo_3c_lo = ksl_product_rest(vi->x, qi->x, qo_3a, qo_3c - qo_3c_right)
          + ksl_product_rest(vi->y, qi->y, qo_3b, qo_3c_right), qo_3 = -qo_3e;
  const double qo_0_rounded = qo_0
          + (ksl_product_rest(vi->x, qi->w, qo_0a, qo_0 - qo_0_right) + (qo_0d - qo_0_right)
          + qo_0d_lo),
      qo_1_rounded = qo_1
          + (qo_1c - (qo_1 - qo_1_right) + ksl_product_rest(vi->y, qi->w, qo_1d, qo_1_right)
          + qo_1c_lo),
      qo_2_rounded = qo_2
          + (qo_2c - (qo_2 - qo_2_right) + ksl_product_rest(vi->z, qi->w, qo_2d, qo_2_right)
          + qo_2c_lo),
      qo_3_rounded = qo_3 +
          -(qo_3c - (qo_3e - qo_3e_right) + ksl_product_rest(vi->z, qi->z, qo_3d, qo_3e_right)
          + qo_3c_lo);
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
      qo_0 = qo_0a + qo_0d, qo_0_right = qo_0 - qo_0a,
      qo_0d_lo = ksl_product_rest(vi->z, qi->y, qo_0b, qo_0d + qo_0d_right)
          - ksl_product_rest(vi->y, qi->z, qo_0c, qo_0d_right);
  const double qo_1a = KSL_MUL(vi->x, qi->z), qo_1b = KSL_MUL(vi->z, qi->x), qo_1c = qo_1a - qo_1b,
      qo_1c_right = qo_1a - qo_1c, qo_1d = KSL_MUL(vi->y, qi->w), qo_1 = qo_1c + qo_1d,
      qo_1_right = qo_1 - qo_1c,
      qo_1c_lo = ksl_product_rest(vi->x, qi->z, qo_1a, qo_1c + qo_1c_right)
          - ksl_product_rest(vi->z, qi->x, qo_1b, qo_1c_right);
  const double qo_2a = KSL_MUL(vi->y, qi->x), qo_2b = KSL_MUL(vi->x, qi->y), qo_2c = qo_2a - qo_2b,
      qo_2c_right = qo_2a - qo_2c, qo_2d = KSL_MUL(vi->z, qi->w), qo_2 = qo_2c + qo_2d,
      qo_2_right = qo_2 - qo_2c,
      qo_2c_lo = ksl_product_rest(vi->y, qi->x, qo_2a, qo_2c + qo_2c_right)
          - ksl_product_rest(vi->x, qi->y, qo_2b, qo_2c_right);
  const double qo_3a = KSL_MUL(vi->x, qi->x), qo_3b = KSL_MUL(vi->y, qi->y), qo_3c = qo_3a + qo_3b,
      qo_3c_right = qo_3c - qo_3a, qo_3d = KSL_MUL(vi->z, qi->z), qo_3 = qo_3c + qo_3d,
      qo_3_right = qo_3 - qo_3c,
      qo_3c_lo = ksl_product_rest(vi->x, qi->x, qo_3a, qo_3c - qo_3c_right)
          + ksl_product_rest(vi->y, qi->y, qo_3b, qo_3c_right);
  const double qo_0_rounded = qo_0
          + (ksl_product_rest(vi->x, qi->w, qo_0a, qo_0 - qo_0_right) + (qo_0d - qo_0_right)
          + qo_0d_lo),
      qo_1_rounded = qo_1
          + (qo_1c - (qo_1 - qo_1_right) + ksl_product_rest(vi->y, qi->w, qo_1d, qo_1_right)
          + qo_1c_lo),
      qo_2_rounded = qo_2
          + (qo_2c - (qo_2 - qo_2_right) + ksl_product_rest(vi->z, qi->w, qo_2d, qo_2_right)
          + qo_2c_lo),
      qo_3_rounded = qo_3
          + (qo_3c - (qo_3 - qo_3_right) + ksl_product_rest(vi->z, qi->z, qo_3d, qo_3_right)
          + qo_3c_lo);
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
      dot_c = dot_a + dot_b, dot_c_right = dot_c - dot_a, dot_d = KSL_MUL(q1i->z, q2i->z),
      dot_e = dot_c + dot_d, dot_e_right = dot_e - dot_c,
      dot_c_lo = ksl_product_rest(q1i->x, q2i->x, dot_a, dot_c - dot_c_right)
          + ksl_product_rest(q1i->y, q2i->y, dot_b, dot_c_right), dot_f = KSL_MUL(q1i->w, q2i->w),
      dot = dot_e + dot_f, dot_right = dot - dot_e,
      dot_e_lo = dot_c - (dot_e - dot_e_right)
          + ksl_product_rest(q1i->z, q2i->z, dot_d, dot_e_right) + dot_c_lo;
  const double dot_rounded = dot
          + (dot_e - (dot - dot_right) + ksl_product_rest(q1i->w, q2i->w, dot_f, dot_right)
          + dot_e_lo);
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
      qi_0_new_g_left_rest = ksl_product_rest(qi_0_new_c, qi->y, qi_0_new_d, qi_0_new_g
          + qi_0_new_g_right), qi_0_new_h = qi_0_new_b + qi_0_new_g,
      qi_0_new_h_right = qi_0_new_h - qi_0_new_b,
      qi_0_new_h_lo1 = ksl_product_rest(qi_0_new_a, qi->w, qi_0_new_b, qi_0_new_h
          - qi_0_new_h_right) + (qi_0_new_g - qi_0_new_h_right), qi_0_new = qi_0_new_h + qi->x,
      qi_0_new_right = qi_0_new - qi_0_new_h,
      qi_0_new_h_lo = qi_0_new_h_lo1
          + (qi_0_new_g_left_rest
          - ksl_product_rest(qi_0_new_e, qi->z, qi_0_new_f, qi_0_new_g_right));
  const double qi_1_new_a = KSL_MUL(qi_0_new_a, qi->z), qi_1_new_b = KSL_MUL(qi_0_new_c, qi->x),
      qi_1_new_c = qi_1_new_a - qi_1_new_b, qi_1_new_c_right = qi_1_new_a - qi_1_new_c,
      qi_1_new_c_left_rest = ksl_product_rest(qi_0_new_a, qi->z, qi_1_new_a, qi_1_new_c
          + qi_1_new_c_right), qi_1_new_d = KSL_MUL(qi_0_new_e, qi->w),
      qi_1_new_e = qi_1_new_c + qi_1_new_d, qi_1_new_e_right = qi_1_new_e - qi_1_new_c,
      qi_1_new_e_lo1 = qi_1_new_c - (qi_1_new_e - qi_1_new_e_right)
          + ksl_product_rest(qi_0_new_e, qi->w, qi_1_new_d, qi_1_new_e_right),
      qi_1_new = qi_1_new_e + qi->y, qi_1_new_right = qi_1_new - qi_1_new_e,
      qi_1_new_e_lo = qi_1_new_e_lo1
          + (qi_1_new_c_left_rest
          - ksl_product_rest(qi_0_new_c, qi->x, qi_1_new_b, qi_1_new_c_right));
  const double qi_2_new_a = KSL_MUL(qi_0_new_e, qi->x), qi_2_new_b = KSL_MUL(qi_0_new_a, qi->y),
      qi_2_new_c = qi_2_new_a - qi_2_new_b, qi_2_new_c_right = qi_2_new_a - qi_2_new_c,
      qi_2_new_c_left_rest = ksl_product_rest(qi_0_new_e, qi->x, qi_2_new_a, qi_2_new_c
          + qi_2_new_c_right), qi_2_new_d = KSL_MUL(qi_0_new_c, qi->w),
      qi_2_new_e = qi_2_new_c + qi_2_new_d, qi_2_new_e_right = qi_2_new_e - qi_2_new_c,
      qi_2_new_e_lo1 = qi_2_new_c - (qi_2_new_e - qi_2_new_e_right)
          + ksl_product_rest(qi_0_new_c, qi->w, qi_2_new_d, qi_2_new_e_right),
      qi_2_new = qi_2_new_e + qi->z, qi_2_new_right = qi_2_new - qi_2_new_e,
      qi_2_new_e_lo = qi_2_new_e_lo1
          + (qi_2_new_c_left_rest
          - ksl_product_rest(qi_0_new_a, qi->y, qi_2_new_b, qi_2_new_c_right));
  const double qi_3_new_a = KSL_MUL(qi_0_new_a, qi->x), qi_3_new_b = KSL_MUL(qi_0_new_e, qi->y),
      qi_3_new_c = qi_3_new_a + qi_3_new_b, qi_3_new_c_right = qi_3_new_c - qi_3_new_a,
      qi_3_new_c_left_rest = ksl_product_rest(qi_0_new_a, qi->x, qi_3_new_a, qi_3_new_c
          - qi_3_new_c_right), qi_3_new_d = KSL_MUL(qi_0_new_c, qi->z),
      qi_3_new_e = qi_3_new_c + qi_3_new_d, qi_3_new_e_right = qi_3_new_e - qi_3_new_c,
      qi_3_new_e_lo1 = qi_3_new_c - (qi_3_new_e - qi_3_new_e_right)
          + ksl_product_rest(qi_0_new_c, qi->z, qi_3_new_d, qi_3_new_e_right),
      qi_3_new = qi->w - qi_3_new_e, qi_3_new_right = qi->w - qi_3_new,
      qi_3_new_e_lo = qi_3_new_e_lo1
          + (qi_3_new_c_left_rest
          + ksl_product_rest(qi_0_new_e, qi->y, qi_3_new_b, qi_3_new_c_right));
  const double qi_0_new_rounded = qi_0_new
          + (qi_0_new_h - (qi_0_new - qi_0_new_right) + (qi->x - qi_0_new_right) + qi_0_new_h_lo),
      qi_1_new_rounded = qi_1_new
          + (qi_1_new_e - (qi_1_new - qi_1_new_right) + (qi->y - qi_1_new_right) + qi_1_new_e_lo),
      qi_2_new_rounded = qi_2_new
          + (qi_2_new_e - (qi_2_new - qi_2_new_right) + (qi->z - qi_2_new_right) + qi_2_new_e_lo),
      qi_3_new_rounded = qi_3_new
          + (qi->w - (qi_3_new + qi_3_new_right) - (qi_3_new_e - qi_3_new_right) - qi_3_new_e_lo);
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
      qi_0_new_e_left_rest = ksl_product_rest(qi_0_new_a, qi->z, qi_0_new_b, qi_0_new_e
          + qi_0_new_e_right), qi_0_new_f = KSL_MUL(0.5, dpi->x),
      qi_0_new_g = KSL_MUL(qi_0_new_f, qi->w), qi_0_new_h = qi_0_new_e - qi_0_new_g,
      qi_0_new_h_right = qi_0_new_e - qi_0_new_h,
      qi_0_new_h_lo1 = qi_0_new_e - (qi_0_new_h + qi_0_new_h_right)
          - ksl_product_rest(qi_0_new_f, qi->w, qi_0_new_g, qi_0_new_h_right),
      qi_0_new = qi_0_new_h + qi->x, qi_0_new_right = qi_0_new - qi_0_new_h,
      qi_0_new_h_lo = qi_0_new_h_lo1
          + (qi_0_new_e_left_rest
          - ksl_product_rest(qi_0_new_c, qi->y, qi_0_new_d, qi_0_new_e_right));
  const double qi_1_new_a = KSL_MUL(qi_0_new_c, qi->x), qi_1_new_b = KSL_MUL(qi_0_new_f, qi->z),
      qi_1_new_c = qi_1_new_a - qi_1_new_b, qi_1_new_c_right = qi_1_new_a - qi_1_new_c,
      qi_1_new_c_left_rest = ksl_product_rest(qi_0_new_c, qi->x, qi_1_new_a, qi_1_new_c
          + qi_1_new_c_right), qi_1_new_d = KSL_MUL(qi_0_new_a, qi->w),
      qi_1_new_e = qi_1_new_c - qi_1_new_d, qi_1_new_e_right = qi_1_new_c - qi_1_new_e,
      qi_1_new_e_lo1 = qi_1_new_c - (qi_1_new_e + qi_1_new_e_right)
          - ksl_product_rest(qi_0_new_a, qi->w, qi_1_new_d, qi_1_new_e_right),
      qi_1_new = qi_1_new_e + qi->y, qi_1_new_right = qi_1_new - qi_1_new_e,
      qi_1_new_e_lo = qi_1_new_e_lo1
          + (qi_1_new_c_left_rest
          - ksl_product_rest(qi_0_new_f, qi->z, qi_1_new_b, qi_1_new_c_right));
  const double qi_2_new_a = KSL_MUL(qi_0_new_f, qi->y), qi_2_new_b = KSL_MUL(qi_0_new_a, qi->x),
      qi_2_new_c = qi_2_new_a - qi_2_new_b, qi_2_new_c_right = qi_2_new_a - qi_2_new_c,
      qi_2_new_c_left_rest = ksl_product_rest(qi_0_new_f, qi->y, qi_2_new_a, qi_2_new_c
          + qi_2_new_c_right), qi_2_new_d = KSL_MUL(qi_0_new_c, qi->w),
      qi_2_new_e = qi_2_new_c - qi_2_new_d, qi_2_new_e_right = qi_2_new_c - qi_2_new_e,
      qi_2_new_e_lo1 = qi_2_new_c - (qi_2_new_e + qi_2_new_e_right)
          - ksl_product_rest(qi_0_new_c, qi->w, qi_2_new_d, qi_2_new_e_right),
      qi_2_new = qi_2_new_e + qi->z, qi_2_new_right = qi_2_new - qi_2_new_e,
      qi_2_new_e_lo = qi_2_new_e_lo1
          + (qi_2_new_c_left_rest
          - ksl_product_rest(qi_0_new_a, qi->x, qi_2_new_b, qi_2_new_c_right));
  const double qi_3_new_a = KSL_MUL(qi_0_new_f, qi->x), qi_3_new_b = KSL_MUL(qi_0_new_a, qi->y),
      qi_3_new_c = qi_3_new_a + qi_3_new_b, qi_3_new_c_right = qi_3_new_c - qi_3_new_a,
      qi_3_new_c_left_rest = ksl_product_rest(qi_0_new_f, qi->x, qi_3_new_a, qi_3_new_c
          - qi_3_new_c_right), qi_3_new_d = KSL_MUL(qi_0_new_c, qi->z),
      qi_3_new_e = qi_3_new_c + qi_3_new_d, qi_3_new_e_right = qi_3_new_e - qi_3_new_c,
      qi_3_new_e_lo1 = qi_3_new_c - (qi_3_new_e - qi_3_new_e_right)
          + ksl_product_rest(qi_0_new_c, qi->z, qi_3_new_d, qi_3_new_e_right),
      qi_3_new = qi_3_new_e + qi->w, qi_3_new_right = qi_3_new - qi_3_new_e,
      qi_3_new_e_lo = qi_3_new_e_lo1
          + (qi_3_new_c_left_rest
          + ksl_product_rest(qi_0_new_a, qi->y, qi_3_new_b, qi_3_new_c_right));
  const double qi_0_new_rounded = qi_0_new
          + (qi_0_new_h - (qi_0_new - qi_0_new_right) + (qi->x - qi_0_new_right) + qi_0_new_h_lo),
      qi_1_new_rounded = qi_1_new
          + (qi_1_new_e - (qi_1_new - qi_1_new_right) + (qi->y - qi_1_new_right) + qi_1_new_e_lo),
      qi_2_new_rounded = qi_2_new
          + (qi_2_new_e - (qi_2_new - qi_2_new_right) + (qi->z - qi_2_new_right) + qi_2_new_e_lo),
      qi_3_new_rounded = qi_3_new
          + (qi_3_new_e - (qi_3_new - qi_3_new_right) + (qi->w - qi_3_new_right) + qi_3_new_e_lo);
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
      dqo_0h = dqo_0b + dqo_0g, dqo_0h_right = dqo_0h - dqo_0b,
      dqo_0g_lo = ksl_product_rest(dqo_0c, qi->z, dqo_0d, dqo_0g + dqo_0g_right)
          - ksl_product_rest(dqo_0e, qi->y, dqo_0f, dqo_0g_right), dqo_0i = KSL_MUL(qi->x, qi->x),
      dqo_0j = 1.0 - dqo_0i, dqo_0j_right = 1.0 - dqo_0j, dqo_0k = KSL_MUL(qi->y, qi->y),
      dqo_0l = dqo_0j - dqo_0k, dqo_0l_right = dqo_0j - dqo_0l,
      dqo_0l_lo1 = dqo_0j - (dqo_0l + dqo_0l_right)
          - ksl_product_rest(qi->y, qi->y, dqo_0k, dqo_0l_right), dqo_0m = KSL_MUL(qi->z, qi->z),
      dqo_0n = dqo_0l - dqo_0m, dqo_0n_right = dqo_0l - dqo_0n,
      dqo_0l_lo = dqo_0l_lo1
          + (1.0 - (dqo_0j + dqo_0j_right) - ksl_product_rest(qi->x, qi->x, dqo_0i, dqo_0j_right)),
      dqo_0o = KSL_MUL(qi->w, qi->w), dqo_0p = dqo_0n - dqo_0o, dqo_0p_right = dqo_0n - dqo_0p,
      dqo_0n_lo = dqo_0l - (dqo_0n + dqo_0n_right)
          - ksl_product_rest(qi->z, qi->z, dqo_0m, dqo_0n_right) + dqo_0l_lo,
      dqo_0p_lo = dqo_0n - (dqo_0p + dqo_0p_right)
          - ksl_product_rest(qi->w, qi->w, dqo_0o, dqo_0p_right) + dqo_0n_lo,
      dqo_0p_sum = dqo_0p + dqo_0p_lo, dqo_0p_sum_right = dqo_0p_sum - dqo_0p,
      dqo_0p_sum_lo = dqo_0p - (dqo_0p_sum - dqo_0p_sum_right) + (dqo_0p_lo - dqo_0p_sum_right),
      dqo_0q = KSL_MUL(qi->x, dqo_0p_sum), dqo_0 = dqo_0h + dqo_0q, dqo_0_right = dqo_0 - dqo_0h,
      dqo_0_lo2 = dqo_0h - (dqo_0 - dqo_0_right)
          + ksl_product_rest(qi->x, dqo_0p_sum, dqo_0q, dqo_0_right)
          + KSL_MUL(qi->x, dqo_0p_sum_lo);
  const double dqo_1a = KSL_MUL(dqo_0e, qi->x), dqo_1b = KSL_MUL(dqo_0a, qi->z),
      dqo_1c = dqo_1a - dqo_1b, dqo_1c_right = dqo_1a - dqo_1c, dqo_1d = KSL_MUL(dqo_0c, qi->w),
      dqo_1e = dqo_1c + dqo_1d, dqo_1e_right = dqo_1e - dqo_1c,
      dqo_1c_lo = ksl_product_rest(dqo_0e, qi->x, dqo_1a, dqo_1c + dqo_1c_right)
          - ksl_product_rest(dqo_0a, qi->z, dqo_1b, dqo_1c_right),
      dqo_1f = KSL_MUL(qi->y, dqo_0p_sum), dqo_1 = dqo_1e + dqo_1f, dqo_1_right = dqo_1 - dqo_1e,
      dqo_1_lo2 = dqo_1e - (dqo_1 - dqo_1_right)
          + ksl_product_rest(qi->y, dqo_0p_sum, dqo_1f, dqo_1_right)
          + KSL_MUL(qi->y, dqo_0p_sum_lo);
  const double dqo_2a = KSL_MUL(dqo_0a, qi->y), dqo_2b = KSL_MUL(dqo_0c, qi->x),
      dqo_2c = dqo_2a - dqo_2b, dqo_2c_right = dqo_2a - dqo_2c, dqo_2d = KSL_MUL(dqo_0e, qi->w),
      dqo_2e = dqo_2c + dqo_2d, dqo_2e_right = dqo_2e - dqo_2c,
      dqo_2c_lo = ksl_product_rest(dqo_0a, qi->y, dqo_2a, dqo_2c + dqo_2c_right)
          - ksl_product_rest(dqo_0c, qi->x, dqo_2b, dqo_2c_right),
      dqo_2f = KSL_MUL(qi->z, dqo_0p_sum), dqo_2 = dqo_2e + dqo_2f, dqo_2_right = dqo_2 - dqo_2e,
      dqo_2_lo2 = dqo_2e - (dqo_2 - dqo_2_right)
          + ksl_product_rest(qi->z, dqo_0p_sum, dqo_2f, dqo_2_right)
          + KSL_MUL(qi->z, dqo_0p_sum_lo);
  const double dqo_3a = KSL_MUL(qi->w, dqo_0p_sum), dqo_3b = KSL_MUL(dqo_0a, qi->x),
      dqo_3c = KSL_MUL(dqo_0c, qi->y), dqo_3d = dqo_3b + dqo_3c, dqo_3d_right = dqo_3d - dqo_3b,
      dqo_3e = KSL_MUL(dqo_0e, qi->z), dqo_3f = dqo_3d + dqo_3e, dqo_3f_right = dqo_3f - dqo_3d,
      dqo_3d_lo = ksl_product_rest(dqo_0a, qi->x, dqo_3b, dqo_3d - dqo_3d_right)
          + ksl_product_rest(dqo_0c, qi->y, dqo_3c, dqo_3d_right), dqo_3 = dqo_3a - dqo_3f,
      dqo_3_right = dqo_3a - dqo_3,
      dqo_3f_lo = dqo_3d - (dqo_3f - dqo_3f_right)
          + ksl_product_rest(dqo_0e, qi->z, dqo_3e, dqo_3f_right) + dqo_3d_lo;
  const double dqo_0_rounded = dqo_0
          + (dqo_0_lo2
          + (ksl_product_rest(dqo_0a, qi->w, dqo_0b, dqo_0h - dqo_0h_right)
          + (dqo_0g - dqo_0h_right) + dqo_0g_lo)),
      dqo_1_rounded = dqo_1
          + (dqo_1_lo2
          + (dqo_1c - (dqo_1e - dqo_1e_right)
          + ksl_product_rest(dqo_0c, qi->w, dqo_1d, dqo_1e_right) + dqo_1c_lo)),
      dqo_2_rounded = dqo_2
          + (dqo_2_lo2
          + (dqo_2c - (dqo_2e - dqo_2e_right)
          + ksl_product_rest(dqo_0e, qi->w, dqo_2d, dqo_2e_right) + dqo_2c_lo));
  const double dqo_3_lo = ksl_product_rest(qi->w, dqo_0p_sum, dqo_3a, dqo_3 + dqo_3_right)
          - (dqo_3f - dqo_3_right) - dqo_3f_lo + KSL_MUL(qi->w, dqo_0p_sum_lo);
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
  const double squares_0 = KSL_MUL(q->w, q->w), squares_1 = KSL_MUL(q->x, q->x),
      squares_2 = KSL_MUL(q->y, q->y), squares_3 = KSL_MUL(q->z, q->z);
  const double pairs_0 = squares_0 + squares_1, pairs_0_right = pairs_0 - squares_0,
      pairs_0_lo = ksl_product_rest(q->w, q->w, squares_0, pairs_0 - pairs_0_right)
          + ksl_product_rest(q->x, q->x, squares_1, pairs_0_right);
  const double pairs_1 = squares_2 + squares_3, pairs_1_right = pairs_1 - squares_2,
      pairs_1_lo = ksl_product_rest(q->y, q->y, squares_2, pairs_1 - pairs_1_right)
          + ksl_product_rest(q->z, q->z, squares_3, pairs_1_right);
  const double pairs_2 = squares_0 + squares_2, pairs_2_right = pairs_2 - squares_0;
  const double pairs_3 = squares_1 + squares_3, pairs_3_right = pairs_3 - squares_1;
  const double pairs_4 = squares_0 + squares_3, pairs_4_right = pairs_4 - squares_0;
  const double pairs_5 = squares_1 + squares_2, pairs_5_right = pairs_5 - squares_1;
  const double square = pairs_0 + pairs_1, square_right = square - pairs_0,
      square_lo = pairs_0 - (square - square_right) + (pairs_1 - square_right) + pairs_1_lo
          + pairs_0_lo;
  const double square_sum = square + square_lo, square_sum_right = square_sum - square,
      factor = 1.0 / square_sum, factor_product = KSL_MUL(factor, square_sum),
      factor_cross = KSL_MUL(factor, square - (square_sum - square_sum_right)
          + (square_lo - square_sum_right)),
      factor_lo = (1.0 - factor_product - ksl_product_error(factor, square_sum, factor_product)
          - factor_cross) / square_sum;
  const double d0 = pairs_0 - pairs_1, d0_right = pairs_0 - d0;
  const double d1 = pairs_2 - pairs_3, d1_right = pairs_2 - d1;
  const double pairs_3_lo = ksl_product_rest(q->x, q->x, squares_1, pairs_3 - pairs_3_right)
          + ksl_product_rest(q->z, q->z, squares_3, pairs_3_right);
  const double pairs_2_lo = ksl_product_rest(q->w, q->w, squares_0, pairs_2 - pairs_2_right)
          + ksl_product_rest(q->y, q->y, squares_2, pairs_2_right);
  const double d2 = pairs_4 - pairs_5, d2_right = pairs_4 - d2;
  const double pairs_5_lo = ksl_product_rest(q->x, q->x, squares_1, pairs_5 - pairs_5_right)
          + ksl_product_rest(q->y, q->y, squares_2, pairs_5_right);
  const double pairs_4_lo = ksl_product_rest(q->w, q->w, squares_0, pairs_4 - pairs_4_right)
          + ksl_product_rest(q->z, q->z, squares_3, pairs_4_right);
  const double twice = KSL_MUL(2.0, factor), twice_cross2 = KSL_MUL(2.0, factor_lo);
  const double m_0a = KSL_MUL(q->x, q->y), m_0b = KSL_MUL(q->z, q->w), m_0 = m_0a - m_0b,
      m_0_right = m_0a - m_0;
  const double m_1a = KSL_MUL(q->x, q->z), m_1b = KSL_MUL(q->y, q->w), m_1 = m_1a + m_1b,
      m_1_right = m_1 - m_1a;
  const double m_2a = KSL_MUL(q->y, q->z), m_2b = KSL_MUL(q->x, q->w), m_2 = m_2a - m_2b,
      m_2_right = m_2a - m_2;
  const double m_3 = m_0a + m_0b, m_3_right = m_3 - m_0a;
  const double m_4 = m_1a - m_1b, m_4_right = m_1a - m_4;
  const double m_5 = m_2b + m_2a, m_5_right = m_5 - m_2b;
  const double R_00 = KSL_MUL(factor, d0);
  const double R_01 = KSL_MUL(twice, m_0),
      R_01_cross2 = KSL_MUL(twice, ksl_product_rest(q->x, q->y, m_0a, m_0 + m_0_right)
          - ksl_product_rest(q->z, q->w, m_0b, m_0_right));
  const double R_02 = KSL_MUL(twice, m_1),
      R_02_cross2 = KSL_MUL(twice, ksl_product_rest(q->x, q->z, m_1a, m_1 - m_1_right)
          + ksl_product_rest(q->y, q->w, m_1b, m_1_right));
  const double R_10 = KSL_MUL(twice, m_3),
      R_10_cross2 = KSL_MUL(twice, ksl_product_rest(q->x, q->y, m_0a, m_3 - m_3_right)
          + ksl_product_rest(q->z, q->w, m_0b, m_3_right));
  const double R_11 = KSL_MUL(factor, d1);
  const double R_12 = KSL_MUL(twice, m_2),
      R_12_cross2 = KSL_MUL(twice, ksl_product_rest(q->y, q->z, m_2a, m_2 + m_2_right)
          - ksl_product_rest(q->x, q->w, m_2b, m_2_right));
  const double R_20 = KSL_MUL(twice, m_4),
      R_20_cross2 = KSL_MUL(twice, ksl_product_rest(q->x, q->z, m_1a, m_4 + m_4_right)
          - ksl_product_rest(q->y, q->w, m_1b, m_4_right));
  const double R_21 = KSL_MUL(twice, m_5),
      R_21_cross2 = KSL_MUL(twice, ksl_product_rest(q->x, q->w, m_2b, m_5 - m_5_right)
          + ksl_product_rest(q->y, q->z, m_2a, m_5_right));
  const double R_22 = KSL_MUL(factor, d2);
  const double R_00_cross = KSL_MUL(factor_lo, d0)
          + KSL_MUL(factor, pairs_0 - (d0 + d0_right) - (pairs_1 - d0_right) - pairs_1_lo
          + pairs_0_lo);
  const double R_00_rounded = R_00 + (ksl_product_error(factor, d0, R_00) + R_00_cross);
  const double R_01_rounded = R_01
          + (ksl_product_error(twice, m_0, R_01) + (KSL_MUL(twice_cross2, m_0) + R_01_cross2));
  const double R_02_rounded = R_02
          + (ksl_product_error(twice, m_1, R_02) + (KSL_MUL(twice_cross2, m_1) + R_02_cross2));
  const double R_10_rounded = R_10
          + (ksl_product_error(twice, m_3, R_10) + (KSL_MUL(twice_cross2, m_3) + R_10_cross2));
  const double R_11_cross = KSL_MUL(factor_lo, d1)
          + KSL_MUL(factor, pairs_2 - (d1 + d1_right) - (pairs_3 - d1_right) - pairs_3_lo
          + pairs_2_lo);
  const double R_11_rounded = R_11 + (ksl_product_error(factor, d1, R_11) + R_11_cross);
  const double R_12_rounded = R_12
          + (ksl_product_error(twice, m_2, R_12) + (KSL_MUL(twice_cross2, m_2) + R_12_cross2));
  const double R_20_rounded = R_20
          + (ksl_product_error(twice, m_4, R_20) + (KSL_MUL(twice_cross2, m_4) + R_20_cross2));
  const double R_21_rounded = R_21
          + (ksl_product_error(twice, m_5, R_21) + (KSL_MUL(twice_cross2, m_5) + R_21_cross2));
  const double R_22_cross = KSL_MUL(factor_lo, d2)
          + KSL_MUL(factor, pairs_4 - (d2 + d2_right) - (pairs_5 - d2_right) - pairs_5_lo
          + pairs_4_lo);
  const double R_22_rounded = R_22 + (ksl_product_error(factor, d2, R_22) + R_22_cross);
  const double R_00_final = R_00_rounded == R_00_rounded ? R_00_rounded : R_00;
  const double R_01_final = R_01_rounded == R_01_rounded ? R_01_rounded : R_01;
  const double R_02_final = R_02_rounded == R_02_rounded ? R_02_rounded : R_02;
  const double R_10_final = R_10_rounded == R_10_rounded ? R_10_rounded : R_10;
  const double R_11_final = R_11_rounded == R_11_rounded ? R_11_rounded : R_11;
  const double R_12_final = R_12_rounded == R_12_rounded ? R_12_rounded : R_12;
  const double R_20_final = R_20_rounded == R_20_rounded ? R_20_rounded : R_20;
  const double R_21_final = R_21_rounded == R_21_rounded ? R_21_rounded : R_21;
  const double R_22_final = R_22_rounded == R_22_rounded ? R_22_rounded : R_22;
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
  const double p_0 = R->m21 - R->m12, p_0_right = R->m21 - p_0,
      p_0_lo = R->m21 - (p_0 + p_0_right) - (R->m12 - p_0_right);
  const double p_1 = R->m02 - R->m20, p_1_right = R->m02 - p_1,
      p_1_lo = R->m02 - (p_1 + p_1_right) - (R->m20 - p_1_right);
  const double p_2 = R->m10 - R->m01, p_2_right = R->m10 - p_2,
      p_2_lo = R->m10 - (p_2 + p_2_right) - (R->m01 - p_2_right);
  const double s_0 = R->m12 + R->m21, s_0_right = s_0 - R->m12,
      s_0_lo = R->m12 - (s_0 - s_0_right) + (R->m21 - s_0_right);
  const double s_1 = R->m02 + R->m20, s_1_right = s_1 - R->m02,
      s_1_lo = R->m02 - (s_1 - s_1_right) + (R->m20 - s_1_right);
  const double s_2 = R->m01 + R->m10, s_2_right = s_2 - R->m01,
      s_2_lo = R->m01 - (s_2 - s_2_right) + (R->m10 - s_2_right);
  const double first_0 = R->m00 + 1.0, first_0_right = first_0 - R->m00,
      first_0_lo = R->m00 - (first_0 - first_0_right) + (1.0 - first_0_right);
  const double first_1 = 1.0 - R->m00, first_1_right = 1.0 - first_1,
      first_1_lo = 1.0 - (first_1 + first_1_right) - (R->m00 - first_1_right);
  const double others_0 = R->m11 + R->m22, others_0_right = others_0 - R->m11,
      others_0_lo = R->m11 - (others_0 - others_0_right) + (R->m22 - others_0_right);
  const double others_1 = R->m11 - R->m22, others_1_right = R->m11 - others_1,
      others_1_lo = R->m11 - (others_1 + others_1_right) - (R->m22 - others_1_right);
  const double d_0 = first_0 + others_0, d_0_right = d_0 - first_0,
      d_0_lo = first_0 - (d_0 - d_0_right) + (others_0 - d_0_right) + others_0_lo + first_0_lo;
  const double d_1 = first_0 - others_0, d_1_right = first_0 - d_1,
      d_1_lo = first_0 - (d_1 + d_1_right) - (others_0 - d_1_right) - others_0_lo + first_0_lo;
  const double d_2 = first_1 + others_1, d_2_right = d_2 - first_1,
      d_2_lo = first_1 - (d_2 - d_2_right) + (others_1 - d_2_right) + others_1_lo + first_1_lo;
  const double d_3 = first_1 - others_1, d_3_right = first_1 - d_3,
      d_3_lo = first_1 - (d_3 + d_3_right) - (others_1 - d_3_right) - others_1_lo + first_1_lo;
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
      column_3_sum = column_3 + column_3_lo, column_3_sum_right = column_3_sum - column_3,
      column_3_sum_lo = column_3 - (column_3_sum - column_3_sum_right)
          + (column_3_lo - column_3_sum_right), upper_0 = column_3_sum < 0.0 ? upper_0a : column_0,
      upper_0_lo = column_3_sum < 0.0 ? upper_0a_lo : column_0_lo;
  const double upper_1a = -column_1, upper_1a_lo = -column_1_lo,
      upper_1 = column_3_sum < 0.0 ? upper_1a : column_1,
      upper_1_lo = column_3_sum < 0.0 ? upper_1a_lo : column_1_lo;
  const double upper_2a = -column_2, upper_2a_lo = -column_2_lo,
      upper_2 = column_3_sum < 0.0 ? upper_2a : column_2,
      upper_2_lo = column_3_sum < 0.0 ? upper_2a_lo : column_2_lo;
  const double upper_3a = -column_3_sum, upper_3a_lo = -column_3_sum_lo,
      upper_3 = column_3_sum < 0.0 ? upper_3a : column_3_sum,
      upper_3_lo = column_3_sum < 0.0 ? upper_3a_lo : column_3_sum_lo;
  const double length_a = KSL_MUL(upper_0, upper_0), length_b = KSL_MUL(upper_1, upper_1),
      length_c = length_a + length_b, length_c_right = length_c - length_a,
      length_c_lo1 = ksl_product_rest(upper_0, upper_0, length_a, length_c - length_c_right)
          + ksl_product_rest(upper_1, upper_1, length_b, length_c_right),
      length_c_cross = KSL_MUL(upper_0_lo, upper_0) + KSL_MUL(upper_0, upper_0_lo)
          + (KSL_MUL(upper_1_lo, upper_1) + KSL_MUL(upper_1, upper_1_lo)),
      length_d = KSL_MUL(upper_2, upper_2), length_e = length_c + length_d,
      length_e_right = length_e - length_c,
      length_e_lo1 = length_c - (length_e - length_e_right)
          + ksl_product_rest(upper_2, upper_2, length_d, length_e_right),
      length_f = KSL_MUL(upper_3, upper_3), length_g = length_e + length_f,
      length_g_right = length_g - length_e,
      length_g_lo1 = length_e - (length_g - length_g_right)
          + ksl_product_rest(upper_3, upper_3, length_f, length_g_right),
      length_e_lo = length_e_lo1 + (KSL_MUL(upper_2_lo, upper_2) + KSL_MUL(upper_2, upper_2_lo))
          + (length_c_lo1 + length_c_cross),
      length_g_lo = length_g_lo1 + (KSL_MUL(upper_3_lo, upper_3) + KSL_MUL(upper_3, upper_3_lo))
          + length_e_lo, length_g_sum = length_g + length_g_lo,
      length_g_sum_right = length_g_sum - length_g, length = sqrt(length_g_sum),
      length_product = KSL_MUL(length, length),
      length_g_sum_lo = length_g - (length_g_sum - length_g_sum_right)
          + (length_g_lo - length_g_sum_right), length_twice = length + length,
      length_residual = length_g_sum - length_product
          - ksl_product_error(length, length, length_product) + length_g_sum_lo,
      length_lo = length_residual / (length == 0.0 ? 1.0 : length_twice);
  const double upper_0_sum = upper_0 + upper_0_lo, upper_0_sum_right = upper_0_sum - upper_0,
      length_sum = length + length_lo, length_sum_right = length_sum - length,
      length_sum_lo = length - (length_sum - length_sum_right) + (length_lo - length_sum_right),
      qo_0 = upper_0_sum / length_sum, qo_0_product = KSL_MUL(qo_0, length_sum),
      qo_0_exact = upper_0_sum - qo_0_product - ksl_product_error(qo_0, length_sum, qo_0_product);
  const double upper_1_sum = upper_1 + upper_1_lo, upper_1_sum_right = upper_1_sum - upper_1,
      qo_1 = upper_1_sum / length_sum, qo_1_product = KSL_MUL(qo_1, length_sum),
      qo_1_exact = upper_1_sum - qo_1_product - ksl_product_error(qo_1, length_sum, qo_1_product);
  const double upper_2_sum = upper_2 + upper_2_lo, upper_2_sum_right = upper_2_sum - upper_2,
      qo_2 = upper_2_sum / length_sum, qo_2_product = KSL_MUL(qo_2, length_sum),
      qo_2_exact = upper_2_sum - qo_2_product - ksl_product_error(qo_2, length_sum, qo_2_product);
  const double upper_3_sum = upper_3 + upper_3_lo, upper_3_sum_right = upper_3_sum - upper_3,
      qo_3 = upper_3_sum / length_sum, qo_3_product = KSL_MUL(qo_3, length_sum),
      qo_3_exact = upper_3_sum - qo_3_product - ksl_product_error(qo_3, length_sum, qo_3_product);
  const double qo_0_lo = (qo_0_exact
          + (upper_0 - (upper_0_sum - upper_0_sum_right) + (upper_0_lo - upper_0_sum_right))
          - KSL_MUL(qo_0, length_sum_lo)) / length_sum;
  const double qo_0_rounded = qo_0 + qo_0_lo;
  const double qo_1_lo = (qo_1_exact
          + (upper_1 - (upper_1_sum - upper_1_sum_right) + (upper_1_lo - upper_1_sum_right))
          - KSL_MUL(qo_1, length_sum_lo)) / length_sum;
  const double qo_1_rounded = qo_1 + qo_1_lo;
  const double qo_2_lo = (qo_2_exact
          + (upper_2 - (upper_2_sum - upper_2_sum_right) + (upper_2_lo - upper_2_sum_right))
          - KSL_MUL(qo_2, length_sum_lo)) / length_sum;
  const double qo_2_rounded = qo_2 + qo_2_lo;
  const double qo_3_lo = (qo_3_exact
          + (upper_3 - (upper_3_sum - upper_3_sum_right) + (upper_3_lo - upper_3_sum_right))
          - KSL_MUL(qo_3, length_sum_lo)) / length_sum;
  const double qo_3_rounded = qo_3 + qo_3_lo;
  const double qo_0_final = qo_0_rounded == qo_0_rounded ? qo_0_rounded : qo_0;
  const double qo_1_final = qo_1_rounded == qo_1_rounded ? qo_1_rounded : qo_1;
  const double qo_2_final = qo_2_rounded == qo_2_rounded ? qo_2_rounded : qo_2;
  const double qo_3_final = qo_3_rounded == qo_3_rounded ? qo_3_rounded : qo_3;
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
  const double qo_0 = KSL_MUL(axis->x, sine), qo_1 = KSL_MUL(axis->y, sine),
      qo_2 = KSL_MUL(axis->z, sine);
  const double qo_0_rounded = qo_0
          + (ksl_product_error(axis->x, sine, qo_0) + KSL_MUL(axis->x, sine_own_error));
  const double qo_1_rounded = qo_1
          + (ksl_product_error(axis->y, sine, qo_1) + KSL_MUL(axis->y, sine_own_error));
  const double qo_2_rounded = qo_2
          + (ksl_product_error(axis->z, sine, qo_2) + KSL_MUL(axis->z, sine_own_error));
  const double qo_3_rounded = qo_3 + qo_3_own_error;
  const double qo_0_final = qo_0_rounded == qo_0_rounded ? qo_0_rounded : qo_0;
  const double qo_1_final = qo_1_rounded == qo_1_rounded ? qo_1_rounded : qo_1;
  const double qo_2_final = qo_2_rounded == qo_2_rounded ? qo_2_rounded : qo_2;
  const double qo_3_final = qo_3_rounded == qo_3_rounded ? qo_3_rounded : qo_3;
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
  const double s_size_0 = fabs(q->x), s_size_1 = fabs(q->y), s_size_2 = fabs(q->z),
      s_size_3 = fabs(q->w);
  const double s_largest1 = s_size_0 < s_size_1 ? s_size_1 : s_size_0;
  const double s_largest2 = s_largest1 < s_size_2 ? s_size_2 : s_largest1;
  const double s_largest3 = s_largest2 < s_size_3 ? s_size_3 : s_largest2;
  const double s_b = 6.703903964971299e+153 < s_largest3 ? 3.7291703656001034e-155 : 1.0,
      s_d = s_largest3 < 256.0 ? 1.3093562431584567e+151 : s_b,
      s = s_largest3 < 1.955159272639747e-149 ? 1.0715086071862673e+301 : s_d;
  const double scaled_s_0 = KSL_MUL(q->x, s), scaled_s_1 = KSL_MUL(q->y, s),
      scaled_s_2 = KSL_MUL(q->z, s), scaled_s_3 = KSL_MUL(q->w, s);
  const double upper_0a = -scaled_s_0, upper_0 = scaled_s_3 < 0.0 ? upper_0a : scaled_s_0;
  const double upper_1a = -scaled_s_1, upper_1 = scaled_s_3 < 0.0 ? upper_1a : scaled_s_1;
  const double upper_2a = -scaled_s_2, upper_2 = scaled_s_3 < 0.0 ? upper_2a : scaled_s_2;
  const double upper_3a = -scaled_s_3, upper_3 = scaled_s_3 < 0.0 ? upper_3a : scaled_s_3;
  const double v_s_size_0 = fabs(upper_0), v_s_size_1 = fabs(upper_1), v_s_size_2 = fabs(upper_2);
  const double v_s_largest1 = v_s_size_0 < v_s_size_1 ? v_s_size_1 : v_s_size_0;
  const double v_s_largest2 = v_s_largest1 < v_s_size_2 ? v_s_size_2 : v_s_largest1;
  const double v_s_b = v_s_largest2 < 256.0 ? 1.3093562431584567e+151 : 1.0,
      v_s = v_s_largest2 < 1.955159272639747e-149 ? 1.0715086071862673e+301 : v_s_b;
  const double v_y_0 = KSL_MUL(upper_0, v_s), v_y_1 = KSL_MUL(upper_1, v_s),
      v_y_2 = KSL_MUL(upper_2, v_s);
  const double v_n_a = KSL_MUL(v_y_0, v_y_0), v_n_b = KSL_MUL(v_y_1, v_y_1), v_n_c = v_n_a + v_n_b,
      v_n_c_right = v_n_c - v_n_a, v_n_d = KSL_MUL(v_y_2, v_y_2), v_n_e = v_n_c + v_n_d,
      v_n_e_right = v_n_e - v_n_c,
      v_n_c_lo = ksl_product_rest(v_y_0, v_y_0, v_n_a, v_n_c - v_n_c_right)
          + ksl_product_rest(v_y_1, v_y_1, v_n_b, v_n_c_right),
      v_n_e_lo = v_n_c - (v_n_e - v_n_e_right) + ksl_product_rest(v_y_2, v_y_2, v_n_d, v_n_e_right)
          + v_n_c_lo, v_n_e_sum = v_n_e + v_n_e_lo, v_n_e_sum_right = v_n_e_sum - v_n_e,
      v_n = sqrt(v_n_e_sum), v_n_product = KSL_MUL(v_n, v_n),
      v_n_e_sum_lo = v_n_e - (v_n_e_sum - v_n_e_sum_right) + (v_n_e_lo - v_n_e_sum_right),
      v_n_twice = v_n + v_n,
      v_n_lo = (v_n_e_sum - v_n_product - ksl_product_error(v_n, v_n, v_n_product) + v_n_e_sum_lo)
          / (v_n == 0.0 ? 1.0 : v_n_twice);
  const double v_r_b = 1.0 < v_s ? 7.637340908749012e-152 : 1.0,
      v_r = 1.3093562431584567e+151 < v_s ? 9.332636185032189e-302 : v_r_b;
  const double v_n_sum = v_n + v_n_lo, v_n_sum_right = v_n_sum - v_n,
      v_n_sum_lo = v_n - (v_n_sum - v_n_sum_right) + (v_n_lo - v_n_sum_right),
      n = KSL_MUL(v_n_sum, v_r), n_lo = KSL_MUL(v_n_sum - KSL_MUL(n, 1.0 / v_r) + v_n_sum_lo, v_r);
  const double n_sum = n + n_lo, n_sum_right = n_sum - n, half = ksl_atan2(n_sum, upper_3),
      half_size0 = fabs(n_sum), half_size1 = fabs(upper_3),
      half_most = half_size0 < half_size1 ? half_size1 : half_size0,
      half_divisor = half_most == 0.0 ? 1.0 : half_most, half_part0 = n_sum / half_divisor,
      half_part1 = upper_3 / half_divisor,
      half_divisor2 = KSL_MUL(half_divisor, KSL_MUL(half_part1, half_part1)
          + KSL_MUL(half_part0, half_part0)),
      half_cross = KSL_MUL(half_part1, n - (n_sum - n_sum_right) + (n_lo - n_sum_right))
          - KSL_MUL(half_part0, 0.0);
  const double divisor = v_n_sum == 0.0 ? 1.0 : v_n_sum,
      divisor_lo = v_n_sum == 0.0 ? 0.0 : v_n_sum_lo;
  const double divisor_sum = divisor + divisor_lo, divisor_sum_right = divisor_sum - divisor,
      divisor_sum_lo = divisor - (divisor_sum - divisor_sum_right)
          + (divisor_lo - divisor_sum_right), unit_0 = v_y_0 / divisor_sum,
      unit_0_product = KSL_MUL(unit_0, divisor_sum),
      unit_0_lo = (v_y_0 - unit_0_product - ksl_product_error(unit_0, divisor_sum, unit_0_product)
          - KSL_MUL(unit_0, divisor_sum_lo)) / divisor_sum;
  const double unit_1 = v_y_1 / divisor_sum, unit_1_product = KSL_MUL(unit_1, divisor_sum);
  const double unit_2 = v_y_2 / divisor_sum, unit_2_product = KSL_MUL(unit_2, divisor_sum);
  const double angle = KSL_MUL(2.0, half);
  const double axis_0 = v_n_sum == 0.0 ? 1.0 : unit_0;
  const double angle_rounded = angle
          + KSL_MUL(2.0, ksl_atan2_error(n_sum, upper_3, half) + half_cross
          / (half_most == 0.0 ? 1.0 : half_divisor2));
  const double axis_0_rounded = axis_0 + (v_n_sum == 0.0 ? 0.0 : unit_0_lo);
  const double unit_1_lo = (v_y_1 - unit_1_product
          - ksl_product_error(unit_1, divisor_sum, unit_1_product)
          - KSL_MUL(unit_1, divisor_sum_lo)) / divisor_sum;
  const double unit_1_rounded = unit_1 + unit_1_lo;
  const double unit_2_lo = (v_y_2 - unit_2_product
          - ksl_product_error(unit_2, divisor_sum, unit_2_product)
          - KSL_MUL(unit_2, divisor_sum_lo)) / divisor_sum;
  const double unit_2_rounded = unit_2 + unit_2_lo;
  const double angle_final = angle_rounded == angle_rounded ? angle_rounded : angle;
  const double axis_0_final = axis_0_rounded == axis_0_rounded ? axis_0_rounded : axis_0;
  const double unit_1_final = unit_1_rounded == unit_1_rounded ? unit_1_rounded : unit_1;
  const double unit_2_final = unit_2_rounded == unit_2_rounded ? unit_2_rounded : unit_2;
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
  const double h_0 = KSL_MUL(0.5, v->x), h_1 = KSL_MUL(0.5, v->y), h_2 = KSL_MUL(0.5, v->z);
  const double h_size_0 = fabs(h_0), h_size_1 = fabs(h_1), h_size_2 = fabs(h_2);
  const double h_largest1 = h_size_0 < h_size_1 ? h_size_1 : h_size_0;
  const double h_largest2 = h_largest1 < h_size_2 ? h_size_2 : h_largest1;
  const double s = 6.703903964971299e+153 < h_largest2 ? 3.7291703656001034e-155 : 1.0;
  const double reduced_0 = KSL_MUL(h_0, s), reduced_1 = KSL_MUL(h_1, s),
      reduced_2 = KSL_MUL(h_2, s);
  const double up = s < 1.0 ? 2.6815615859885194e+154 : 1.0;
  const double reduced_length_a = KSL_MUL(reduced_0, reduced_0),
      reduced_length_b = KSL_MUL(reduced_1, reduced_1),
      reduced_length_c = reduced_length_a + reduced_length_b,
      reduced_length_c_right = reduced_length_c - reduced_length_a,
      reduced_length_c_left_rest = ksl_product_rest(reduced_0, reduced_0, reduced_length_a,
          reduced_length_c - reduced_length_c_right),
      reduced_length_d = KSL_MUL(reduced_2, reduced_2),
      reduced_length_e = reduced_length_c + reduced_length_d,
      reduced_length_e_right = reduced_length_e - reduced_length_c,
      reduced_length_e_right_rest = ksl_product_rest(reduced_2, reduced_2, reduced_length_d,
          reduced_length_e_right),
      reduced_length_c_lo = reduced_length_c_left_rest
          + ksl_product_rest(reduced_1, reduced_1, reduced_length_b, reduced_length_c_right),
      reduced_length_e_lo = reduced_length_c - (reduced_length_e - reduced_length_e_right)
          + reduced_length_e_right_rest + reduced_length_c_lo,
      reduced_length_e_sum = reduced_length_e + reduced_length_e_lo,
      reduced_length_e_sum_right = reduced_length_e_sum - reduced_length_e,
      reduced_length = sqrt(reduced_length_e_sum),
      reduced_length_product = KSL_MUL(reduced_length, reduced_length),
      reduced_length_e_sum_lo = reduced_length_e
          - (reduced_length_e_sum - reduced_length_e_sum_right)
          + (reduced_length_e_lo - reduced_length_e_sum_right),
      reduced_length_exact = reduced_length_e_sum - reduced_length_product
          - ksl_product_error(reduced_length, reduced_length, reduced_length_product),
      reduced_length_twice = reduced_length + reduced_length,
      reduced_length_lo = (reduced_length_exact + reduced_length_e_sum_lo)
          / (reduced_length == 0.0 ? 1.0 : reduced_length_twice);
  const double reduced_length_sum = reduced_length + reduced_length_lo,
      reduced_length_sum_right = reduced_length_sum - reduced_length,
      half_angle = KSL_MUL(reduced_length_sum, up),
      reduced_length_sum_lo = reduced_length - (reduced_length_sum - reduced_length_sum_right)
          + (reduced_length_lo - reduced_length_sum_right),
      half_angle_lo = KSL_MUL(reduced_length_sum - KSL_MUL(half_angle, 1.0 / up)
          + reduced_length_sum_lo, up);
  const double y = KSL_MUL(half_angle, half_angle);
  const double half_angle_sum = half_angle + half_angle_lo,
      half_angle_sum_right = half_angle_sum - half_angle,
      half_angle_sum_lo = half_angle - (half_angle_sum - half_angle_sum_right)
          + (half_angle_lo - half_angle_sum_right);
  double c; const double sine = ksl_sincos(half_angle_sum, &c);
  double c_own_error; const double sine_own_error = ksl_sincos_error(half_angle_sum, sine, c,
      &c_own_error);
  const double sine_half = KSL_MUL(half_angle_sum_lo, 0.5);
  double sine_half_cos; const double sine_half_sin = ksl_sincos(sine_half, &sine_half_cos);
  const double sine_twice = sine_half_sin + sine_half_sin,
      sine_lo = sine_own_error
          + KSL_MUL(KSL_MUL(sine_half_cos, c) - KSL_MUL(sine_half_sin, sine), sine_twice);
  const double sinc_divisor = half_angle_sum < 1.4901161193847656e-08 ? 1.4901161193847656e-08
          : half_angle_sum,
      sinc_divisor_lo = half_angle_sum < 1.4901161193847656e-08 ? 0.0 : half_angle_sum_lo;
  const double sine_sum = sine + sine_lo, sine_sum_right = sine_sum - sine,
      sinc_divisor_sum = sinc_divisor + sinc_divisor_lo,
      sinc_divisor_sum_right = sinc_divisor_sum - sinc_divisor,
      sinc_quotient = sine_sum / sinc_divisor_sum,
      sinc_quotient_product = KSL_MUL(sinc_quotient, sinc_divisor_sum),
      sinc_quotient_exact = sine_sum - sinc_quotient_product
          - ksl_product_error(sinc_quotient, sinc_divisor_sum, sinc_quotient_product),
      sinc_quotient_cross = KSL_MUL(sinc_quotient, sinc_divisor
          - (sinc_divisor_sum - sinc_divisor_sum_right)
          + (sinc_divisor_lo - sinc_divisor_sum_right)),
      sinc_quotient_lo = (sinc_quotient_exact
          + (sine - (sine_sum - sine_sum_right) + (sine_lo - sine_sum_right))
          - sinc_quotient_cross) / sinc_divisor_sum;
  const double sinc_a = KSL_MUL(0.16666666666666666, y),
      y_lo = ksl_product_error(half_angle, half_angle, y)
          + (KSL_MUL(half_angle_lo, half_angle) + KSL_MUL(half_angle, half_angle_lo)),
      sinc_b = 1.0 - sinc_a, sinc_b_right = 1.0 - sinc_b,
      sinc_b_lo1 = 1.0 - (sinc_b + sinc_b_right)
          - ksl_product_rest(0.16666666666666666, y, sinc_a, sinc_b_right),
      sinc_b_lo = sinc_b_lo1
          - (KSL_MUL(9.25185853854297e-18, y) + KSL_MUL(0.16666666666666666, y_lo)),
      sinc = half_angle_sum < 1.4901161193847656e-08 ? sinc_b : sinc_quotient,
      sinc_lo = half_angle_sum < 1.4901161193847656e-08 ? sinc_b_lo : sinc_quotient_lo;
  const double qo_0 = KSL_MUL(h_0, sinc), qo_1 = KSL_MUL(h_1, sinc), qo_2 = KSL_MUL(h_2, sinc);
  const double qo_0_rounded = qo_0 + (ksl_product_error(h_0, sinc, qo_0) + KSL_MUL(h_0, sinc_lo));
  const double qo_1_rounded = qo_1 + (ksl_product_error(h_1, sinc, qo_1) + KSL_MUL(h_1, sinc_lo));
  const double qo_2_rounded = qo_2 + (ksl_product_error(h_2, sinc, qo_2) + KSL_MUL(h_2, sinc_lo));
  const double c_rounded = c
          + (c_own_error
          - KSL_MUL(KSL_MUL(sine_half_cos, sine) + KSL_MUL(sine_half_sin, c), sine_twice));
  const double qo_0_final = qo_0_rounded == qo_0_rounded ? qo_0_rounded : qo_0;
  const double qo_1_final = qo_1_rounded == qo_1_rounded ? qo_1_rounded : qo_1;
  const double qo_2_final = qo_2_rounded == qo_2_rounded ? qo_2_rounded : qo_2;
  const double c_final = c_rounded == c_rounded ? c_rounded : c;
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
  const double s_size_0 = fabs(q->x), s_size_1 = fabs(q->y), s_size_2 = fabs(q->z),
      s_size_3 = fabs(q->w);
  const double s_largest1 = s_size_0 < s_size_1 ? s_size_1 : s_size_0;
  const double s_largest2 = s_largest1 < s_size_2 ? s_size_2 : s_largest1;
  const double s_largest3 = s_largest2 < s_size_3 ? s_size_3 : s_largest2;
  const double s_b = 6.703903964971299e+153 < s_largest3 ? 3.7291703656001034e-155 : 1.0,
      s_d = s_largest3 < 256.0 ? 1.3093562431584567e+151 : s_b,
      s = s_largest3 < 1.955159272639747e-149 ? 1.0715086071862673e+301 : s_d;
  const double scaled_s_0 = KSL_MUL(q->x, s), scaled_s_1 = KSL_MUL(q->y, s),
      scaled_s_2 = KSL_MUL(q->z, s), scaled_s_3 = KSL_MUL(q->w, s);
  const double upper_0a = -scaled_s_0, upper_0 = scaled_s_3 < 0.0 ? upper_0a : scaled_s_0;
  const double upper_1a = -scaled_s_1, upper_1 = scaled_s_3 < 0.0 ? upper_1a : scaled_s_1;
  const double upper_2a = -scaled_s_2, upper_2 = scaled_s_3 < 0.0 ? upper_2a : scaled_s_2;
  const double upper_3a = -scaled_s_3, upper_3 = scaled_s_3 < 0.0 ? upper_3a : scaled_s_3;
  const double v_s_size_0 = fabs(upper_0), v_s_size_1 = fabs(upper_1), v_s_size_2 = fabs(upper_2);
  const double v_s_largest1 = v_s_size_0 < v_s_size_1 ? v_s_size_1 : v_s_size_0;
  const double v_s_largest2 = v_s_largest1 < v_s_size_2 ? v_s_size_2 : v_s_largest1;
  const double v_s_b = v_s_largest2 < 256.0 ? 1.3093562431584567e+151 : 1.0,
      v_s = v_s_largest2 < 1.955159272639747e-149 ? 1.0715086071862673e+301 : v_s_b;
  const double v_y_0 = KSL_MUL(upper_0, v_s), v_y_1 = KSL_MUL(upper_1, v_s),
      v_y_2 = KSL_MUL(upper_2, v_s);
  const double v_n_a = KSL_MUL(v_y_0, v_y_0), v_n_b = KSL_MUL(v_y_1, v_y_1), v_n_c = v_n_a + v_n_b,
      v_n_c_right = v_n_c - v_n_a, v_n_d = KSL_MUL(v_y_2, v_y_2), v_n_e = v_n_c + v_n_d,
      v_n_e_right = v_n_e - v_n_c,
      v_n_c_lo = ksl_product_rest(v_y_0, v_y_0, v_n_a, v_n_c - v_n_c_right)
          + ksl_product_rest(v_y_1, v_y_1, v_n_b, v_n_c_right),
      v_n_e_lo = v_n_c - (v_n_e - v_n_e_right) + ksl_product_rest(v_y_2, v_y_2, v_n_d, v_n_e_right)
          + v_n_c_lo, v_n_e_sum = v_n_e + v_n_e_lo, v_n_e_sum_right = v_n_e_sum - v_n_e,
      v_n = sqrt(v_n_e_sum), v_n_product = KSL_MUL(v_n, v_n),
      v_n_e_sum_lo = v_n_e - (v_n_e_sum - v_n_e_sum_right) + (v_n_e_lo - v_n_e_sum_right),
      v_n_twice = v_n + v_n,
      v_n_lo = (v_n_e_sum - v_n_product - ksl_product_error(v_n, v_n, v_n_product) + v_n_e_sum_lo)
          / (v_n == 0.0 ? 1.0 : v_n_twice);
  const double v_r_b = 1.0 < v_s ? 7.637340908749012e-152 : 1.0,
      v_r = 1.3093562431584567e+151 < v_s ? 9.332636185032189e-302 : v_r_b;
  const double v_n_sum = v_n + v_n_lo, v_n_sum_right = v_n_sum - v_n, n = KSL_MUL(v_n_sum, v_r),
      n_lo = KSL_MUL(v_n_sum - KSL_MUL(n, 1.0 / v_r)
          + (v_n - (v_n_sum - v_n_sum_right) + (v_n_lo - v_n_sum_right)), v_r);
  const double n_sum = n + n_lo, n_sum_right = n_sum - n,
      n_sum_lo = n - (n_sum - n_sum_right) + (n_lo - n_sum_right), half = ksl_atan2(n_sum, upper_3),
      half_size0 = fabs(n_sum), half_size1 = fabs(upper_3),
      half_most = half_size0 < half_size1 ? half_size1 : half_size0,
      half_divisor = half_most == 0.0 ? 1.0 : half_most, half_part0 = n_sum / half_divisor,
      half_part1 = upper_3 / half_divisor,
      half_divisor2 = KSL_MUL(half_divisor, KSL_MUL(half_part1, half_part1)
          + KSL_MUL(half_part0, half_part0)),
      half_more = (KSL_MUL(half_part1, n_sum_lo) - KSL_MUL(half_part0, 0.0))
          / (half_most == 0.0 ? 1.0 : half_divisor2);
  const double divisor = n_sum == 0.0 ? 1.0 : n_sum, divisor_lo = n_sum == 0.0 ? 0.0 : n_sum_lo;
  const double theta = KSL_MUL(2.0, half),
      theta_cross2 = KSL_MUL(2.0, ksl_atan2_error(n_sum, upper_3, half) + half_more);
  const double theta_sum = theta + theta_cross2, theta_sum_right = theta_sum - theta,
      divisor_sum = divisor + divisor_lo, divisor_sum_right = divisor_sum - divisor,
      k = theta_sum / divisor_sum, k_product = KSL_MUL(k, divisor_sum),
      theta_sum_lo = theta - (theta_sum - theta_sum_right) + (theta_cross2 - theta_sum_right),
      k_cross = KSL_MUL(k, divisor - (divisor_sum - divisor_sum_right)
          + (divisor_lo - divisor_sum_right)),
      k_lo = (theta_sum - k_product - ksl_product_error(k, divisor_sum, k_product) + theta_sum_lo
          - k_cross) / divisor_sum;
  const double vector_0 = KSL_MUL(upper_0, k), vector_1 = KSL_MUL(upper_1, k),
      vector_2 = KSL_MUL(upper_2, k);
  const double vector_0_rounded = vector_0
          + (ksl_product_error(upper_0, k, vector_0) + KSL_MUL(upper_0, k_lo));
  const double vector_1_rounded = vector_1
          + (ksl_product_error(upper_1, k, vector_1) + KSL_MUL(upper_1, k_lo));
  const double vector_2_rounded = vector_2
          + (ksl_product_error(upper_2, k, vector_2) + KSL_MUL(upper_2, k_lo));
  const double vector_0_final = vector_0_rounded == vector_0_rounded ? vector_0_rounded : vector_0;
  const double vector_1_final = vector_1_rounded == vector_1_rounded ? vector_1_rounded : vector_1;
  const double vector_2_final = vector_2_rounded == vector_2_rounded ? vector_2_rounded : vector_2;
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
      between_0c_left_rest = ksl_product_rest(q1->w, q2->x, between_0a, between_0c
          + between_0c_right), between_0d = KSL_MUL(q1->z, q2->y),
      between_0e = KSL_MUL(q1->y, q2->z), between_0f = between_0d - between_0e,
      between_0f_right = between_0d - between_0f,
      between_0f_left_rest = ksl_product_rest(q1->z, q2->y, between_0d, between_0f
          + between_0f_right), between_0 = between_0c + between_0f,
      between_0_right = between_0 - between_0c,
      between_0f_lo = between_0f_left_rest
          - ksl_product_rest(q1->y, q2->z, between_0e, between_0f_right),
      between_0_lo2 = between_0c - (between_0 - between_0_right) + (between_0f - between_0_right)
          + between_0f_lo,
      between_0_lo = between_0_lo2
          + (between_0c_left_rest - ksl_product_rest(q1->x, q2->w, between_0b, between_0c_right));
  const double between_1a = KSL_MUL(q1->x, q2->z), between_1b = KSL_MUL(q1->z, q2->x),
      between_1c = between_1a - between_1b, between_1c_right = between_1a - between_1c,
      between_1c_left_rest = ksl_product_rest(q1->x, q2->z, between_1a, between_1c
          + between_1c_right), between_1d = KSL_MUL(q1->w, q2->y),
      between_1e = KSL_MUL(q1->y, q2->w), between_1f = between_1d - between_1e,
      between_1f_right = between_1d - between_1f,
      between_1f_left_rest = ksl_product_rest(q1->w, q2->y, between_1d, between_1f
          + between_1f_right), between_1 = between_1c + between_1f,
      between_1_right = between_1 - between_1c,
      between_1f_lo = between_1f_left_rest
          - ksl_product_rest(q1->y, q2->w, between_1e, between_1f_right),
      between_1_lo2 = between_1c - (between_1 - between_1_right) + (between_1f - between_1_right)
          + between_1f_lo,
      between_1_lo = between_1_lo2
          + (between_1c_left_rest - ksl_product_rest(q1->z, q2->x, between_1b, between_1c_right));
  const double between_2a = KSL_MUL(q1->y, q2->x), between_2b = KSL_MUL(q1->x, q2->y),
      between_2c = between_2a - between_2b, between_2c_right = between_2a - between_2c,
      between_2c_left_rest = ksl_product_rest(q1->y, q2->x, between_2a, between_2c
          + between_2c_right), between_2d = KSL_MUL(q1->w, q2->z),
      between_2e = KSL_MUL(q1->z, q2->w), between_2f = between_2d - between_2e,
      between_2f_right = between_2d - between_2f,
      between_2f_left_rest = ksl_product_rest(q1->w, q2->z, between_2d, between_2f
          + between_2f_right), between_2 = between_2c + between_2f,
      between_2_right = between_2 - between_2c,
      between_2f_lo = between_2f_left_rest
          - ksl_product_rest(q1->z, q2->w, between_2e, between_2f_right),
      between_2_lo2 = between_2c - (between_2 - between_2_right) + (between_2f - between_2_right)
          + between_2f_lo,
      between_2_lo = between_2_lo2
          + (between_2c_left_rest - ksl_product_rest(q1->x, q2->y, between_2b, between_2c_right));
  const double between_3a = KSL_MUL(q1->x, q2->x), between_3b = KSL_MUL(q1->y, q2->y),
      between_3c = between_3a + between_3b, between_3c_right = between_3c - between_3a,
      between_3c_left_rest = ksl_product_rest(q1->x, q2->x, between_3a, between_3c
          - between_3c_right), between_3d = KSL_MUL(q1->z, q2->z),
      between_3e = between_3c + between_3d, between_3e_right = between_3e - between_3c,
      between_3e_lo1 = between_3c - (between_3e - between_3e_right)
          + ksl_product_rest(q1->z, q2->z, between_3d, between_3e_right),
      between_3f = KSL_MUL(q1->w, q2->w), between_3 = between_3e + between_3f,
      between_3_right = between_3 - between_3e,
      between_3_lo1 = between_3e - (between_3 - between_3_right)
          + ksl_product_rest(q1->w, q2->w, between_3f, between_3_right),
      between_3_lo = between_3_lo1
          + (between_3e_lo1
          + (between_3c_left_rest + ksl_product_rest(q1->y, q2->y, between_3b, between_3c_right)));
  const double upper_0a = -between_0, upper_0a_lo = -between_0_lo,
      between_3_sum = between_3 + between_3_lo, between_3_sum_right = between_3_sum - between_3,
      between_3_sum_lo = between_3 - (between_3_sum - between_3_sum_right)
          + (between_3_lo - between_3_sum_right),
      upper_0 = between_3_sum < 0.0 ? upper_0a : between_0,
      upper_0_lo = between_3_sum < 0.0 ? upper_0a_lo : between_0_lo;
  const double upper_1a = -between_1, upper_1a_lo = -between_1_lo,
      upper_1 = between_3_sum < 0.0 ? upper_1a : between_1,
      upper_1_lo = between_3_sum < 0.0 ? upper_1a_lo : between_1_lo;
  const double upper_2a = -between_2, upper_2a_lo = -between_2_lo,
      upper_2 = between_3_sum < 0.0 ? upper_2a : between_2,
      upper_2_lo = between_3_sum < 0.0 ? upper_2a_lo : between_2_lo;
  const double upper_3 = fabs(between_3_sum), upper_3_opposite = -between_3_sum_lo,
      upper_3_lo = between_3_sum < 0.0 ? upper_3_opposite : between_3_sum_lo;
  const double upper_0_sum = upper_0 + upper_0_lo, upper_0_sum_right = upper_0_sum - upper_0,
      upper_0_sum_lo = upper_0 - (upper_0_sum - upper_0_sum_right)
          + (upper_0_lo - upper_0_sum_right), v_s_size_0 = fabs(upper_0_sum),
      v_s_size_0_opposite = -upper_0_sum_lo,
      v_s_size_0_lo = upper_0_sum < 0.0 ? v_s_size_0_opposite : upper_0_sum_lo;
  const double upper_1_sum = upper_1 + upper_1_lo, upper_1_sum_right = upper_1_sum - upper_1,
      upper_1_sum_lo = upper_1 - (upper_1_sum - upper_1_sum_right)
          + (upper_1_lo - upper_1_sum_right), v_s_size_1 = fabs(upper_1_sum),
      v_s_size_1_opposite = -upper_1_sum_lo,
      v_s_size_1_lo = upper_1_sum < 0.0 ? v_s_size_1_opposite : upper_1_sum_lo;
  const double upper_2_sum = upper_2 + upper_2_lo, upper_2_sum_right = upper_2_sum - upper_2,
      upper_2_sum_lo = upper_2 - (upper_2_sum - upper_2_sum_right)
          + (upper_2_lo - upper_2_sum_right), v_s_size_2 = fabs(upper_2_sum),
      v_s_size_2_opposite = -upper_2_sum_lo,
      v_s_size_2_lo = upper_2_sum < 0.0 ? v_s_size_2_opposite : upper_2_sum_lo;
  const double v_s_size_0_sum = v_s_size_0 + v_s_size_0_lo,
      v_s_size_0_sum_right = v_s_size_0_sum - v_s_size_0,
      v_s_size_0_sum_lo = v_s_size_0 - (v_s_size_0_sum - v_s_size_0_sum_right)
          + (v_s_size_0_lo - v_s_size_0_sum_right), v_s_size_1_sum = v_s_size_1 + v_s_size_1_lo,
      v_s_size_1_sum_right = v_s_size_1_sum - v_s_size_1,
      v_s_size_1_sum_lo = v_s_size_1 - (v_s_size_1_sum - v_s_size_1_sum_right)
          + (v_s_size_1_lo - v_s_size_1_sum_right),
      v_s_largest1 = v_s_size_0_sum < v_s_size_1_sum ? v_s_size_1_sum : v_s_size_0_sum,
      v_s_largest1_lo = v_s_size_0_sum < v_s_size_1_sum ? v_s_size_1_sum_lo : v_s_size_0_sum_lo;
  const double v_s_largest1_sum = v_s_largest1 + v_s_largest1_lo,
      v_s_largest1_sum_right = v_s_largest1_sum - v_s_largest1,
      v_s_largest1_sum_lo = v_s_largest1 - (v_s_largest1_sum - v_s_largest1_sum_right)
          + (v_s_largest1_lo - v_s_largest1_sum_right), v_s_size_2_sum = v_s_size_2 + v_s_size_2_lo,
      v_s_size_2_sum_right = v_s_size_2_sum - v_s_size_2,
      v_s_size_2_sum_lo = v_s_size_2 - (v_s_size_2_sum - v_s_size_2_sum_right)
          + (v_s_size_2_lo - v_s_size_2_sum_right),
      v_s_largest2 = v_s_largest1_sum < v_s_size_2_sum ? v_s_size_2_sum : v_s_largest1_sum;
  const double v_s_largest2_sum = v_s_largest2
          + (v_s_largest1_sum < v_s_size_2_sum ? v_s_size_2_sum_lo : v_s_largest1_sum_lo),
      v_s_b = 6.703903964971299e+153 < v_s_largest2_sum ? 3.7291703656001034e-155 : 1.0,
      v_s_d = v_s_largest2_sum < 256.0 ? 1.3093562431584567e+151 : v_s_b,
      v_s = v_s_largest2_sum < 1.955159272639747e-149 ? 1.0715086071862673e+301 : v_s_d;
  const double v_y_0 = KSL_MUL(upper_0_sum, v_s), v_y_0_inverse = 1.0 / v_s,
      v_y_0_lo = KSL_MUL(upper_0_sum - KSL_MUL(v_y_0, v_y_0_inverse) + upper_0_sum_lo, v_s);
  const double v_y_1 = KSL_MUL(upper_1_sum, v_s),
      v_y_1_lo = KSL_MUL(upper_1_sum - KSL_MUL(v_y_1, v_y_0_inverse) + upper_1_sum_lo, v_s);
  const double v_y_2 = KSL_MUL(upper_2_sum, v_s),
      v_y_2_lo = KSL_MUL(upper_2_sum - KSL_MUL(v_y_2, v_y_0_inverse) + upper_2_sum_lo, v_s);
  const double v_n_a = KSL_MUL(v_y_0, v_y_0), v_n_b = KSL_MUL(v_y_1, v_y_1), v_n_c = v_n_a + v_n_b,
      v_n_c_right = v_n_c - v_n_a,
      v_n_c_lo1 = ksl_product_rest(v_y_0, v_y_0, v_n_a, v_n_c - v_n_c_right)
          + ksl_product_rest(v_y_1, v_y_1, v_n_b, v_n_c_right), v_n_d = KSL_MUL(v_y_2, v_y_2),
      v_n_e = v_n_c + v_n_d, v_n_e_right = v_n_e - v_n_c,
      v_n_e_lo2 = v_n_c - (v_n_e - v_n_e_right)
          + ksl_product_rest(v_y_2, v_y_2, v_n_d, v_n_e_right)
          + (KSL_MUL(v_y_2_lo, v_y_2) + KSL_MUL(v_y_2, v_y_2_lo)),
      v_n_e_lo = v_n_e_lo2
          + (v_n_c_lo1
          + (KSL_MUL(v_y_0_lo, v_y_0) + KSL_MUL(v_y_0, v_y_0_lo)
          + (KSL_MUL(v_y_1_lo, v_y_1) + KSL_MUL(v_y_1, v_y_1_lo)))), v_n_e_sum = v_n_e + v_n_e_lo,
      v_n_e_sum_right = v_n_e_sum - v_n_e, v_n = sqrt(v_n_e_sum), v_n_product = KSL_MUL(v_n, v_n),
      v_n_e_sum_lo = v_n_e - (v_n_e_sum - v_n_e_sum_right) + (v_n_e_lo - v_n_e_sum_right),
      v_n_twice = v_n + v_n,
      v_n_lo = (v_n_e_sum - v_n_product - ksl_product_error(v_n, v_n, v_n_product) + v_n_e_sum_lo)
          / (v_n == 0.0 ? 1.0 : v_n_twice);
  const double v_r_b = v_s < 1.0 ? 2.6815615859885194e+154 : 1.0,
      v_r_d = 1.0 < v_s ? 7.637340908749012e-152 : v_r_b,
      v_r = 1.3093562431584567e+151 < v_s ? 9.332636185032189e-302 : v_r_d;
  const double v_n_sum = v_n + v_n_lo, v_n_sum_right = v_n_sum - v_n, n = KSL_MUL(v_n_sum, v_r),
      n_lo = KSL_MUL(v_n_sum - KSL_MUL(n, 1.0 / v_r)
          + (v_n - (v_n_sum - v_n_sum_right) + (v_n_lo - v_n_sum_right)), v_r);
  const double n_sum = n + n_lo, n_sum_right = n_sum - n,
      n_sum_lo = n - (n_sum - n_sum_right) + (n_lo - n_sum_right),
      upper_3_sum = upper_3 + upper_3_lo, upper_3_sum_right = upper_3_sum - upper_3,
      half = ksl_atan2(n_sum, upper_3_sum), half_size0 = fabs(n_sum),
      half_size1 = fabs(upper_3_sum), half_most = half_size0 < half_size1 ? half_size1 : half_size0,
      half_divisor = half_most == 0.0 ? 1.0 : half_most, half_part0 = n_sum / half_divisor,
      half_part1 = upper_3_sum / half_divisor,
      half_divisor2 = KSL_MUL(half_divisor, KSL_MUL(half_part1, half_part1)
          + KSL_MUL(half_part0, half_part0)),
      half_cross = KSL_MUL(half_part1, n_sum_lo)
          - KSL_MUL(half_part0, upper_3 - (upper_3_sum - upper_3_sum_right)
          + (upper_3_lo - upper_3_sum_right)),
      half_lo = ksl_atan2_error(n_sum, upper_3_sum, half) + half_cross
          / (half_most == 0.0 ? 1.0 : half_divisor2);
  const double divisor = n_sum == 0.0 ? 1.0 : n_sum, divisor_lo = n_sum == 0.0 ? 0.0 : n_sum_lo;
  const double half_sum = half + half_lo, half_sum_right = half_sum - half,
      divisor_sum = divisor + divisor_lo, divisor_sum_right = divisor_sum - divisor,
      rate = half_sum / divisor_sum, rate_product = KSL_MUL(rate, divisor_sum),
      rate_exact = half_sum - rate_product - ksl_product_error(rate, divisor_sum, rate_product),
      rate_cross = KSL_MUL(rate, divisor - (divisor_sum - divisor_sum_right)
          + (divisor_lo - divisor_sum_right)),
      rate_lo = (rate_exact + (half - (half_sum - half_sum_right) + (half_lo - half_sum_right))
          - rate_cross) / divisor_sum;
  const double kv_0 = KSL_MUL(k, upper_0_sum), kv_1 = KSL_MUL(k, upper_1_sum),
      kv_2 = KSL_MUL(k, upper_2_sum);
  const double step_0 = KSL_MUL(rate, kv_0);
  const double step_1 = KSL_MUL(rate, kv_1);
  const double step_2 = KSL_MUL(rate, kv_2);
  const double step_0_cross = KSL_MUL(rate_lo, kv_0)
          + KSL_MUL(rate, ksl_product_error(k, upper_0_sum, kv_0) + KSL_MUL(k, upper_0_sum_lo));
  const double step_0_lo = ksl_product_error(rate, kv_0, step_0) + step_0_cross,
      step_0_sum = step_0 + step_0_lo, step_0_sum_right = step_0_sum - step_0,
      step_0_sum_lo = step_0 - (step_0_sum - step_0_sum_right) + (step_0_lo - step_0_sum_right),
      exp_h_size_0 = fabs(step_0_sum), exp_h_size_0_opposite = -step_0_sum_lo,
      exp_h_size_0_lo = step_0_sum < 0.0 ? exp_h_size_0_opposite : step_0_sum_lo;
  const double step_1_cross = KSL_MUL(rate_lo, kv_1)
          + KSL_MUL(rate, ksl_product_error(k, upper_1_sum, kv_1) + KSL_MUL(k, upper_1_sum_lo));
  const double step_1_lo = ksl_product_error(rate, kv_1, step_1) + step_1_cross,
      step_1_sum = step_1 + step_1_lo, step_1_sum_right = step_1_sum - step_1,
      step_1_sum_lo = step_1 - (step_1_sum - step_1_sum_right) + (step_1_lo - step_1_sum_right),
      exp_h_size_1 = fabs(step_1_sum), exp_h_size_1_opposite = -step_1_sum_lo,
      exp_h_size_1_lo = step_1_sum < 0.0 ? exp_h_size_1_opposite : step_1_sum_lo;
  const double step_2_cross = KSL_MUL(rate_lo, kv_2)
          + KSL_MUL(rate, ksl_product_error(k, upper_2_sum, kv_2) + KSL_MUL(k, upper_2_sum_lo));
  const double step_2_lo = ksl_product_error(rate, kv_2, step_2) + step_2_cross,
      step_2_sum = step_2 + step_2_lo, step_2_sum_right = step_2_sum - step_2,
      step_2_sum_lo = step_2 - (step_2_sum - step_2_sum_right) + (step_2_lo - step_2_sum_right),
      exp_h_size_2 = fabs(step_2_sum), exp_h_size_2_opposite = -step_2_sum_lo,
      exp_h_size_2_lo = step_2_sum < 0.0 ? exp_h_size_2_opposite : step_2_sum_lo;
  const double exp_h_size_0_sum = exp_h_size_0 + exp_h_size_0_lo,
      exp_h_size_0_sum_right = exp_h_size_0_sum - exp_h_size_0,
      exp_h_size_0_sum_lo = exp_h_size_0 - (exp_h_size_0_sum - exp_h_size_0_sum_right)
          + (exp_h_size_0_lo - exp_h_size_0_sum_right),
      exp_h_size_1_sum = exp_h_size_1 + exp_h_size_1_lo,
      exp_h_size_1_sum_right = exp_h_size_1_sum - exp_h_size_1,
      exp_h_size_1_sum_lo = exp_h_size_1 - (exp_h_size_1_sum - exp_h_size_1_sum_right)
          + (exp_h_size_1_lo - exp_h_size_1_sum_right),
      exp_h_largest1 = exp_h_size_0_sum < exp_h_size_1_sum ? exp_h_size_1_sum : exp_h_size_0_sum,
      exp_h_largest1_lo = exp_h_size_0_sum < exp_h_size_1_sum ? exp_h_size_1_sum_lo
          : exp_h_size_0_sum_lo;
  const double exp_h_largest1_sum = exp_h_largest1 + exp_h_largest1_lo,
      exp_h_largest1_sum_right = exp_h_largest1_sum - exp_h_largest1,
      exp_h_largest1_sum_lo = exp_h_largest1 - (exp_h_largest1_sum - exp_h_largest1_sum_right)
          + (exp_h_largest1_lo - exp_h_largest1_sum_right),
      exp_h_size_2_sum = exp_h_size_2 + exp_h_size_2_lo,
      exp_h_size_2_sum_right = exp_h_size_2_sum - exp_h_size_2,
      exp_h_size_2_sum_lo = exp_h_size_2 - (exp_h_size_2_sum - exp_h_size_2_sum_right)
          + (exp_h_size_2_lo - exp_h_size_2_sum_right),
      exp_h_largest2 = exp_h_largest1_sum < exp_h_size_2_sum ? exp_h_size_2_sum
          : exp_h_largest1_sum;
  const double exp_s = 6.703903964971299e+153 < exp_h_largest2
          + (exp_h_largest1_sum < exp_h_size_2_sum ? exp_h_size_2_sum_lo : exp_h_largest1_sum_lo)
          ? 3.7291703656001034e-155 : 1.0;
  const double exp_reduced_0 = KSL_MUL(step_0_sum, exp_s), exp_reduced_0_inverse = 1.0 / exp_s,
      exp_reduced_0_lo = KSL_MUL(step_0_sum - KSL_MUL(exp_reduced_0, exp_reduced_0_inverse)
          + step_0_sum_lo, exp_s);
  const double exp_reduced_1 = KSL_MUL(step_1_sum, exp_s),
      exp_reduced_1_lo = KSL_MUL(step_1_sum - KSL_MUL(exp_reduced_1, exp_reduced_0_inverse)
          + step_1_sum_lo, exp_s);
  const double exp_reduced_2 = KSL_MUL(step_2_sum, exp_s),
      exp_reduced_2_lo = KSL_MUL(step_2_sum - KSL_MUL(exp_reduced_2, exp_reduced_0_inverse)
          + step_2_sum_lo, exp_s);
  const double exp_up = exp_s < 1.0 ? 2.6815615859885194e+154 : 1.0;
  const double exp_reduced_length_a = KSL_MUL(exp_reduced_0, exp_reduced_0),
      exp_reduced_length_b = KSL_MUL(exp_reduced_1, exp_reduced_1),
      exp_reduced_length_c = exp_reduced_length_a + exp_reduced_length_b,
      exp_reduced_length_c_right = exp_reduced_length_c - exp_reduced_length_a,
      exp_reduced_length_c_left = exp_reduced_length_c - exp_reduced_length_c_right,
      exp_reduced_length_a_cross = KSL_MUL(exp_reduced_0_lo, exp_reduced_0)
          + KSL_MUL(exp_reduced_0, exp_reduced_0_lo),
      exp_reduced_length_c_right_rest = ksl_product_rest(exp_reduced_1, exp_reduced_1,
          exp_reduced_length_b, exp_reduced_length_c_right),
      exp_reduced_length_c_left_rest = ksl_product_rest(exp_reduced_0, exp_reduced_0,
          exp_reduced_length_a, exp_reduced_length_c_left),
      exp_reduced_length_c_cross = exp_reduced_length_a_cross
          + (KSL_MUL(exp_reduced_1_lo, exp_reduced_1) + KSL_MUL(exp_reduced_1, exp_reduced_1_lo)),
      exp_reduced_length_d = KSL_MUL(exp_reduced_2, exp_reduced_2),
      exp_reduced_length_e = exp_reduced_length_c + exp_reduced_length_d,
      exp_reduced_length_e_right = exp_reduced_length_e - exp_reduced_length_c,
      exp_reduced_length_e_right_rest = ksl_product_rest(exp_reduced_2, exp_reduced_2,
          exp_reduced_length_d, exp_reduced_length_e_right),
      exp_reduced_length_e_lo1 = exp_reduced_length_c
          - (exp_reduced_length_e - exp_reduced_length_e_right) + exp_reduced_length_e_right_rest,
      exp_reduced_length_e_lo2 = exp_reduced_length_e_lo1
          + (KSL_MUL(exp_reduced_2_lo, exp_reduced_2) + KSL_MUL(exp_reduced_2, exp_reduced_2_lo)),
      exp_reduced_length_e_lo = exp_reduced_length_e_lo2
          + (exp_reduced_length_c_left_rest + exp_reduced_length_c_right_rest
          + exp_reduced_length_c_cross),
      exp_reduced_length_e_sum = exp_reduced_length_e + exp_reduced_length_e_lo,
      exp_reduced_length_e_sum_right = exp_reduced_length_e_sum - exp_reduced_length_e,
      exp_reduced_length_e_sum_left_rest = exp_reduced_length_e
          - (exp_reduced_length_e_sum - exp_reduced_length_e_sum_right),
      exp_reduced_length = sqrt(exp_reduced_length_e_sum),
      exp_reduced_length_product = KSL_MUL(exp_reduced_length, exp_reduced_length),
      exp_reduced_length_product_error = ksl_product_error(exp_reduced_length, exp_reduced_length,
          exp_reduced_length_product),
      exp_reduced_length_e_sum_lo = exp_reduced_length_e_sum_left_rest
          + (exp_reduced_length_e_lo - exp_reduced_length_e_sum_right),
      exp_reduced_length_twice = exp_reduced_length + exp_reduced_length,
      exp_reduced_length_residual = exp_reduced_length_e_sum - exp_reduced_length_product
          - exp_reduced_length_product_error + exp_reduced_length_e_sum_lo,
      exp_reduced_length_lo = exp_reduced_length_residual
          / (exp_reduced_length == 0.0 ? 1.0 : exp_reduced_length_twice);
  const double exp_reduced_length_sum = exp_reduced_length + exp_reduced_length_lo,
      exp_reduced_length_sum_right = exp_reduced_length_sum - exp_reduced_length,
      exp_reduced_length_sum_left_rest = exp_reduced_length
          - (exp_reduced_length_sum - exp_reduced_length_sum_right),
      exp_half_angle = KSL_MUL(exp_reduced_length_sum, exp_up),
      exp_reduced_length_sum_lo = exp_reduced_length_sum_left_rest
          + (exp_reduced_length_lo - exp_reduced_length_sum_right),
      exp_half_angle_lo = KSL_MUL(exp_reduced_length_sum - KSL_MUL(exp_half_angle, 1.0 / exp_up)
          + exp_reduced_length_sum_lo, exp_up);
  const double exp_y = KSL_MUL(exp_half_angle, exp_half_angle);
  const double exp_half_angle_sum = exp_half_angle + exp_half_angle_lo,
      exp_half_angle_sum_right = exp_half_angle_sum - exp_half_angle,
      exp_half_angle_sum_lo = exp_half_angle - (exp_half_angle_sum - exp_half_angle_sum_right)
          + (exp_half_angle_lo - exp_half_angle_sum_right);
  double exp_c; const double exp_sine = ksl_sincos(exp_half_angle_sum, &exp_c);
  double exp_c_own_error; const double exp_sine_own_error = ksl_sincos_error(exp_half_angle_sum,
      exp_sine, exp_c, &exp_c_own_error);
  const double exp_sine_half = KSL_MUL(exp_half_angle_sum_lo, 0.5);
  double exp_sine_half_cos; const double exp_sine_half_sin = ksl_sincos(exp_sine_half,
      &exp_sine_half_cos);
  const double exp_sine_twice = exp_sine_half_sin + exp_sine_half_sin,
      exp_sine_lo = exp_sine_own_error
          + KSL_MUL(KSL_MUL(exp_sine_half_cos, exp_c)
          - KSL_MUL(exp_sine_half_sin, exp_sine), exp_sine_twice);
  const double exp_c_lo = exp_c_own_error
          - KSL_MUL(KSL_MUL(exp_sine_half_cos, exp_sine)
          + KSL_MUL(exp_sine_half_sin, exp_c), exp_sine_twice);
  const double exp_sinc_divisor = exp_half_angle_sum < 1.4901161193847656e-08
          ? 1.4901161193847656e-08 : exp_half_angle_sum,
      exp_sinc_divisor_lo = exp_half_angle_sum < 1.4901161193847656e-08 ? 0.0
          : exp_half_angle_sum_lo;
  const double exp_sine_sum = exp_sine + exp_sine_lo, exp_sine_sum_right = exp_sine_sum - exp_sine,
      exp_sinc_divisor_sum = exp_sinc_divisor + exp_sinc_divisor_lo,
      exp_sinc_divisor_sum_right = exp_sinc_divisor_sum - exp_sinc_divisor,
      exp_sinc_quotient = exp_sine_sum / exp_sinc_divisor_sum,
      exp_sinc_quotient_product = KSL_MUL(exp_sinc_quotient, exp_sinc_divisor_sum),
      exp_sinc_quotient_product_error = ksl_product_error(exp_sinc_quotient, exp_sinc_divisor_sum,
          exp_sinc_quotient_product),
      exp_sine_sum_lo = exp_sine - (exp_sine_sum - exp_sine_sum_right)
          + (exp_sine_lo - exp_sine_sum_right),
      exp_sinc_divisor_sum_lo = exp_sinc_divisor
          - (exp_sinc_divisor_sum - exp_sinc_divisor_sum_right)
          + (exp_sinc_divisor_lo - exp_sinc_divisor_sum_right),
      exp_sinc_quotient_numerator = exp_sine_sum - exp_sinc_quotient_product
          - exp_sinc_quotient_product_error + exp_sine_sum_lo,
      exp_sinc_quotient_lo = (exp_sinc_quotient_numerator
          - KSL_MUL(exp_sinc_quotient, exp_sinc_divisor_sum_lo)) / exp_sinc_divisor_sum;
  const double exp_y_cross = KSL_MUL(exp_half_angle_lo, exp_half_angle)
          + KSL_MUL(exp_half_angle, exp_half_angle_lo);
  const double exp_sinc_a = KSL_MUL(0.16666666666666666, exp_y),
      exp_sinc_a_cross2 = KSL_MUL(0.16666666666666666, ksl_product_error(exp_half_angle,
          exp_half_angle, exp_y) + exp_y_cross),
      exp_sinc_b = 1.0 - exp_sinc_a, exp_sinc_b_right = 1.0 - exp_sinc_b,
      exp_sinc_b_lo1 = 1.0 - (exp_sinc_b + exp_sinc_b_right)
          - ksl_product_rest(0.16666666666666666, exp_y, exp_sinc_a, exp_sinc_b_right),
      exp_sinc_b_lo = exp_sinc_b_lo1 - (KSL_MUL(9.25185853854297e-18, exp_y) + exp_sinc_a_cross2),
      exp_sinc = exp_half_angle_sum < 1.4901161193847656e-08 ? exp_sinc_b : exp_sinc_quotient,
      exp_sinc_lo = exp_half_angle_sum < 1.4901161193847656e-08 ? exp_sinc_b_lo
          : exp_sinc_quotient_lo;
  const double power_0 = KSL_MUL(step_0_sum, exp_sinc), power_1 = KSL_MUL(step_1_sum, exp_sinc),
      power_2 = KSL_MUL(step_2_sum, exp_sinc);
  const double qo_0a = KSL_MUL(q1->x, exp_c),
      power_2_lo = ksl_product_error(step_2_sum, exp_sinc, power_2)
          + (KSL_MUL(step_2_sum_lo, exp_sinc) + KSL_MUL(step_2_sum, exp_sinc_lo)),
      qo_0b = KSL_MUL(q1->y, power_2),
      power_1_lo = ksl_product_error(step_1_sum, exp_sinc, power_1)
          + (KSL_MUL(step_1_sum_lo, exp_sinc) + KSL_MUL(step_1_sum, exp_sinc_lo)),
      qo_0c = KSL_MUL(q1->z, power_1), qo_0d = qo_0b - qo_0c, qo_0d_right = qo_0b - qo_0d,
      qo_0d_lo1 = ksl_product_rest(q1->y, power_2, qo_0b, qo_0d + qo_0d_right)
          - ksl_product_rest(q1->z, power_1, qo_0c, qo_0d_right), qo_0e = qo_0a + qo_0d,
      qo_0e_right = qo_0e - qo_0a,
      qo_0e_lo1 = ksl_product_rest(q1->x, exp_c, qo_0a, qo_0e - qo_0e_right)
          + (qo_0d - qo_0e_right),
      power_0_lo = ksl_product_error(step_0_sum, exp_sinc, power_0)
          + (KSL_MUL(step_0_sum_lo, exp_sinc) + KSL_MUL(step_0_sum, exp_sinc_lo)),
      qo_0f = KSL_MUL(q1->w, power_0), qo_0 = qo_0e + qo_0f, qo_0_right = qo_0 - qo_0e,
      qo_0_lo2 = qo_0e - (qo_0 - qo_0_right) + ksl_product_rest(q1->w, power_0, qo_0f, qo_0_right)
          + KSL_MUL(q1->w, power_0_lo);
  const double qo_1a = KSL_MUL(q1->z, power_0), qo_1b = KSL_MUL(q1->x, power_2),
      qo_1c = qo_1a - qo_1b, qo_1c_right = qo_1a - qo_1c,
      qo_1c_lo1 = ksl_product_rest(q1->z, power_0, qo_1a, qo_1c + qo_1c_right)
          - ksl_product_rest(q1->x, power_2, qo_1b, qo_1c_right), qo_1d = KSL_MUL(q1->y, exp_c),
      qo_1e = qo_1c + qo_1d, qo_1e_right = qo_1e - qo_1c,
      qo_1e_lo2 = qo_1c - (qo_1e - qo_1e_right)
          + ksl_product_rest(q1->y, exp_c, qo_1d, qo_1e_right) + KSL_MUL(q1->y, exp_c_lo),
      qo_1f = KSL_MUL(q1->w, power_1), qo_1 = qo_1e + qo_1f, qo_1_right = qo_1 - qo_1e,
      qo_1_lo2 = qo_1e - (qo_1 - qo_1_right) + ksl_product_rest(q1->w, power_1, qo_1f, qo_1_right)
          + KSL_MUL(q1->w, power_1_lo);
  const double qo_2a = KSL_MUL(q1->x, power_1), qo_2b = KSL_MUL(q1->y, power_0),
      qo_2c = qo_2a - qo_2b, qo_2c_right = qo_2a - qo_2c,
      qo_2c_lo1 = ksl_product_rest(q1->x, power_1, qo_2a, qo_2c + qo_2c_right)
          - ksl_product_rest(q1->y, power_0, qo_2b, qo_2c_right), qo_2d = KSL_MUL(q1->z, exp_c),
      qo_2e = qo_2c + qo_2d, qo_2e_right = qo_2e - qo_2c,
      qo_2e_lo2 = qo_2c - (qo_2e - qo_2e_right)
          + ksl_product_rest(q1->z, exp_c, qo_2d, qo_2e_right) + KSL_MUL(q1->z, exp_c_lo),
      qo_2f = KSL_MUL(q1->w, power_2), qo_2 = qo_2e + qo_2f, qo_2_right = qo_2 - qo_2e,
      qo_2_lo2 = qo_2e - (qo_2 - qo_2_right) + ksl_product_rest(q1->w, power_2, qo_2f, qo_2_right)
          + KSL_MUL(q1->w, power_2_lo);
  const double qo_3a = KSL_MUL(q1->w, exp_c), qo_3b = KSL_MUL(q1->x, power_0),
      qo_3c = KSL_MUL(q1->y, power_1), qo_3d = qo_3b + qo_3c, qo_3d_right = qo_3d - qo_3b,
      qo_3d_lo1 = ksl_product_rest(q1->x, power_0, qo_3b, qo_3d - qo_3d_right)
          + ksl_product_rest(q1->y, power_1, qo_3c, qo_3d_right), qo_3e = KSL_MUL(q1->z, power_2),
      qo_3f = qo_3d + qo_3e, qo_3f_right = qo_3f - qo_3d,
      qo_3f_lo2 = qo_3d - (qo_3f - qo_3f_right)
          + ksl_product_rest(q1->z, power_2, qo_3e, qo_3f_right) + KSL_MUL(q1->z, power_2_lo),
      qo_3 = qo_3a - qo_3f, qo_3_right = qo_3a - qo_3,
      qo_3f_lo = qo_3f_lo2
          + (qo_3d_lo1 + (KSL_MUL(q1->x, power_0_lo) + KSL_MUL(q1->y, power_1_lo)));
  const double qo_0_rounded = qo_0
          + (qo_0_lo2
          + (qo_0e_lo1 + (qo_0d_lo1 + (KSL_MUL(q1->y, power_2_lo) - KSL_MUL(q1->z, power_1_lo)))
          + KSL_MUL(q1->x, exp_c_lo)));
  const double qo_1_rounded = qo_1
          + (qo_1_lo2
          + (qo_1e_lo2 + (qo_1c_lo1 + (KSL_MUL(q1->z, power_0_lo) - KSL_MUL(q1->x, power_2_lo)))));
  const double qo_2_rounded = qo_2
          + (qo_2_lo2
          + (qo_2e_lo2 + (qo_2c_lo1 + (KSL_MUL(q1->x, power_1_lo) - KSL_MUL(q1->y, power_0_lo)))));
  const double qo_3_rounded = qo_3
          + (ksl_product_rest(q1->w, exp_c, qo_3a, qo_3 + qo_3_right) - (qo_3f - qo_3_right)
          - qo_3f_lo + KSL_MUL(q1->w, exp_c_lo));
  const double qo_0_final = qo_0_rounded == qo_0_rounded ? qo_0_rounded : qo_0;
  const double qo_1_final = qo_1_rounded == qo_1_rounded ? qo_1_rounded : qo_1;
  const double qo_2_final = qo_2_rounded == qo_2_rounded ? qo_2_rounded : qo_2;
  const double qo_3_final = qo_3_rounded == qo_3_rounded ? qo_3_rounded : qo_3;
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
  const double self_0_new = (double)self->x * (double)a, self_1_new = (double)self->y * (double)a,
      self_2_new = (double)self->z * (double)a, self_3_new = (double)self->w * (double)a;
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
  const double y_0_new = ksl_product_sum((double)a, (double)x->x, (double)y->x),
      y_1_new = ksl_product_sum((double)a, (double)x->y, (double)y->y),
      y_2_new = ksl_product_sum((double)a, (double)x->z, (double)y->z),
      y_3_new = ksl_product_sum((double)a, (double)x->w, (double)y->w);
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
  const double s_size_0 = fabs((double)q->x), s_size_1 = fabs((double)q->y),
      s_size_2 = fabs((double)q->z), s_size_3 = fabs((double)q->w);
  const double s_largest1 = s_size_0 < s_size_1 ? s_size_1 : s_size_0;
  const double s_largest2 = s_largest1 < s_size_2 ? s_size_2 : s_largest1;
  const double s_largest3 = s_largest2 < s_size_3 ? s_size_3 : s_largest2;
  const double s_b = 4.611686018427388e+18 < s_largest3 ? 2.710505431213761e-20 : 1.0,
      s_d = s_largest3 < 256.0 ? 1.8014398509481984e+16 : s_b,
      s = s_largest3 < 1.4210854715202004e-14 ? 3.2451855365842673e+32 : s_d;
  const double y_0 = KSL_MUL((double)q->x, s), y_1 = KSL_MUL((double)q->y, s),
      y_2 = KSL_MUL((double)q->z, s), y_3 = KSL_MUL((double)q->w, s);
  const double n = sqrt(KSL_MUL(y_0, y_0) + KSL_MUL(y_1, y_1) + KSL_MUL(y_2, y_2)
          + KSL_MUL(y_3, y_3));
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
  const double s_size_0 = fabs((double)self->x), s_size_1 = fabs((double)self->y),
      s_size_2 = fabs((double)self->z), s_size_3 = fabs((double)self->w);
  const double s_largest1 = s_size_0 < s_size_1 ? s_size_1 : s_size_0;
  const double s_largest2 = s_largest1 < s_size_2 ? s_size_2 : s_largest1;
  const double s_largest3 = s_largest2 < s_size_3 ? s_size_3 : s_largest2;
  const double s_b = 4.611686018427388e+18 < s_largest3 ? 2.710505431213761e-20 : 1.0,
      s_d = s_largest3 < 256.0 ? 1.8014398509481984e+16 : s_b,
      s = s_largest3 < 1.4210854715202004e-14 ? 3.2451855365842673e+32 : s_d;
  const double y_0 = KSL_MUL((double)self->x, s), y_1 = KSL_MUL((double)self->y, s),
      y_2 = KSL_MUL((double)self->z, s), y_3 = KSL_MUL((double)self->w, s);
  const double up = 1.0 < s ? s : 1.0;
  const double down = s < 1.0 ? s : 1.0;
  const double n = sqrt(KSL_MUL(y_0, y_0) + KSL_MUL(y_1, y_1) + KSL_MUL(y_2, y_2)
          + KSL_MUL(y_3, y_3));
  const double divisor = n == 0.0 ? up : n;
  const double sized_0 = KSL_MUL((double)self->x, up), sized_1 = KSL_MUL((double)self->y, up),
      sized_2 = KSL_MUL((double)self->z, up), sized_3 = KSL_MUL((double)self->w, up);
  const double quotient_0 = sized_0 / divisor, quotient_1 = sized_1 / divisor,
      quotient_2 = sized_2 / divisor, quotient_3 = sized_3 / divisor;
  const double self_0_new = KSL_MUL(quotient_0, down), self_1_new = KSL_MUL(quotient_1, down),
      self_2_new = KSL_MUL(quotient_2, down), self_3_new = KSL_MUL(quotient_3, down);
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
  const double s_size_0 = fabs((double)q->x), s_size_1 = fabs((double)q->y),
      s_size_2 = fabs((double)q->z), s_size_3 = fabs((double)q->w);
  const double s_largest1 = s_size_0 < s_size_1 ? s_size_1 : s_size_0;
  const double s_largest2 = s_largest1 < s_size_2 ? s_size_2 : s_largest1;
  const double s_largest3 = s_largest2 < s_size_3 ? s_size_3 : s_largest2;
  const double s_b = 4.611686018427388e+18 < s_largest3 ? 2.710505431213761e-20 : 1.0,
      s_d = s_largest3 < 256.0 ? 1.8014398509481984e+16 : s_b,
      s = s_largest3 < 1.4210854715202004e-14 ? 3.2451855365842673e+32 : s_d;
  const double y_0 = KSL_MUL((double)q->x, s), y_1 = KSL_MUL((double)q->y, s),
      y_2 = KSL_MUL((double)q->z, s), y_3 = KSL_MUL((double)q->w, s);
  const double up = 1.0 < s ? s : 1.0;
  const double down = s < 1.0 ? s : 1.0;
  const double n = sqrt(KSL_MUL(y_0, y_0) + KSL_MUL(y_1, y_1) + KSL_MUL(y_2, y_2)
          + KSL_MUL(y_3, y_3));
  const double divisor = n == 0.0 ? up : n;
  const double sized_0 = KSL_MUL((double)q->x, up), sized_1 = KSL_MUL((double)q->y, up),
      sized_2 = KSL_MUL((double)q->z, up), sized_3 = KSL_MUL((double)q->w, up);
  const double quotient_0 = sized_0 / divisor, quotient_1 = sized_1 / divisor,
      quotient_2 = sized_2 / divisor, quotient_3 = sized_3 / divisor;
  const double qo_0 = KSL_MUL(quotient_0, down), qo_1 = KSL_MUL(quotient_1, down),
      qo_2 = KSL_MUL(quotient_2, down), qo_3 = KSL_MUL(quotient_3, down);
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
  const double s_size_0 = fabs((double)q->x), s_size_1 = fabs((double)q->y),
      s_size_2 = fabs((double)q->z), s_size_3 = fabs((double)q->w);
  const double s_largest1 = s_size_0 < s_size_1 ? s_size_1 : s_size_0;
  const double s_largest2 = s_largest1 < s_size_2 ? s_size_2 : s_largest1;
  const double s_largest3 = s_largest2 < s_size_3 ? s_size_3 : s_largest2;
  const double s_b = 4.611686018427388e+18 < s_largest3 ? 2.710505431213761e-20 : 1.0,
      s_d = s_largest3 < 256.0 ? 1.8014398509481984e+16 : s_b,
      s = s_largest3 < 1.4210854715202004e-14 ? 3.2451855365842673e+32 : s_d;
  const double y_0 = KSL_MUL((double)q->x, s), y_1 = KSL_MUL((double)q->y, s),
      y_2 = KSL_MUL((double)q->z, s), y_3 = KSL_MUL((double)q->w, s);
  const double n = sqrt(KSL_MUL(y_0, y_0) + KSL_MUL(y_1, y_1) + KSL_MUL(y_2, y_2)
          + KSL_MUL(y_3, y_3));
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
  const double s_size_0 = fabs((double)q->x), s_size_1 = fabs((double)q->y),
      s_size_2 = fabs((double)q->z), s_size_3 = fabs((double)q->w);
  const double s_largest1 = s_size_0 < s_size_1 ? s_size_1 : s_size_0;
  const double s_largest2 = s_largest1 < s_size_2 ? s_size_2 : s_largest1;
  const double s_largest3 = s_largest2 < s_size_3 ? s_size_3 : s_largest2;
  const double s_b = 4.611686018427388e+18 < s_largest3 ? 2.710505431213761e-20 : 1.0,
      s_d = s_largest3 < 256.0 ? 1.8014398509481984e+16 : s_b,
      s = s_largest3 < 1.4210854715202004e-14 ? 3.2451855365842673e+32 : s_d;
  const double scaled_s_0 = KSL_MUL((double)q->x, s), scaled_s_1 = KSL_MUL((double)q->y, s),
      scaled_s_2 = KSL_MUL((double)q->z, s), scaled_s_3 = KSL_MUL((double)q->w, s);
  const double n = sqrt(KSL_MUL(scaled_s_0, scaled_s_0) + KSL_MUL(scaled_s_1, scaled_s_1)
          + KSL_MUL(scaled_s_2, scaled_s_2) + KSL_MUL(scaled_s_3, scaled_s_3));
  const double divisor = n == 0.0 ? 1.0 : n;
  const double unit_0 = scaled_s_0 / divisor, unit_1 = scaled_s_1 / divisor,
      unit_2 = scaled_s_2 / divisor, unit_3 = scaled_s_3 / divisor;
  const double qo_0 = n == 0.0 ? (double)NAN : unit_0, qo_1 = n == 0.0 ? (double)NAN : unit_1,
      qo_2 = n == 0.0 ? (double)NAN : unit_2, qo_3 = n == 0.0 ? (double)NAN : unit_3;
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
  const double c_0 = ksl_product_sum(-(double)q->z, (double)v->y, (double)q->y * (double)v->z),
      c_1 = ksl_product_sum(-(double)q->x, (double)v->z, (double)q->z * (double)v->x),
      c_2 = ksl_product_sum(-(double)q->y, (double)v->x, (double)q->x * (double)v->y);
  const double t_0 = KSL_MUL(2.0, c_0), t_1 = KSL_MUL(2.0, c_1), t_2 = KSL_MUL(2.0, c_2);
  const double turn_0 = KSL_MUL((double)q->y, t_2) - KSL_MUL((double)q->z, t_1)
          + KSL_MUL((double)q->w, t_0),
      turn_1 = KSL_MUL((double)q->z, t_0) - KSL_MUL((double)q->x, t_2) + KSL_MUL((double)q->w, t_1),
      turn_2 = KSL_MUL((double)q->x, t_1) - KSL_MUL((double)q->y, t_0) + KSL_MUL((double)q->w, t_2);
  const double vo_0 = (double)v->x + turn_0, vo_1 = (double)v->y + turn_1,
      vo_2 = (double)v->z + turn_2;
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
  const double c_0 = ksl_product_sum(-(double)q->y, (double)v->z, (double)q->z * (double)v->y),
      c_1 = ksl_product_sum(-(double)q->z, (double)v->x, (double)q->x * (double)v->z),
      c_2 = ksl_product_sum(-(double)q->x, (double)v->y, (double)q->y * (double)v->x);
  const double t_0 = KSL_MUL(2.0, c_0), t_1 = KSL_MUL(2.0, c_1), t_2 = KSL_MUL(2.0, c_2);
  const double turn_0 = KSL_MUL((double)q->z, t_1) - KSL_MUL((double)q->y, t_2)
          + KSL_MUL((double)q->w, t_0),
      turn_1 = KSL_MUL((double)q->x, t_2) - KSL_MUL((double)q->z, t_0) + KSL_MUL((double)q->w, t_1),
      turn_2 = KSL_MUL((double)q->y, t_0) - KSL_MUL((double)q->x, t_1) + KSL_MUL((double)q->w, t_2);
  const double vo_0 = (double)v->x + turn_0, vo_1 = (double)v->y + turn_1,
      vo_2 = (double)v->z + turn_2;
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
  const double qo_0e = ksl_product_sum((double)q1i->x, (double)q2i->w,
      ksl_product_sum(-(double)q1i->z, (double)q2i->y, (double)q1i->y * (double)q2i->z)),
      qo_0 = ksl_product_sum((double)q1i->w, (double)q2i->x, qo_0e);
  const double qo_1e = ksl_product_sum((double)q1i->y, (double)q2i->w,
      ksl_product_sum(-(double)q1i->x, (double)q2i->z, (double)q1i->z * (double)q2i->x)),
      qo_1 = ksl_product_sum((double)q1i->w, (double)q2i->y, qo_1e);
  const double qo_2e = ksl_product_sum((double)q1i->z, (double)q2i->w,
      ksl_product_sum(-(double)q1i->y, (double)q2i->x, (double)q1i->x * (double)q2i->y)),
      qo_2 = ksl_product_sum((double)q1i->w, (double)q2i->z, qo_2e);
  const double qo_3f = ksl_product_sum(-(double)q1i->z, (double)q2i->z,
      ksl_product_sum(-(double)q1i->y, (double)q2i->y, -((double)q1i->x * (double)q2i->x))),
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
  const double qo_0c = ksl_product_sum(-(double)q1i->w, (double)q2i->x, (double)q1i->x
          * (double)q2i->w),
      qo_0 = qo_0c
          + ksl_product_sum(-(double)q1i->y, (double)q2i->z, (double)q1i->z * (double)q2i->y);
  const double qo_1c = ksl_product_sum(-(double)q1i->z, (double)q2i->x, (double)q1i->x
          * (double)q2i->z),
      qo_1 = qo_1c
          + ksl_product_sum(-(double)q1i->w, (double)q2i->y, (double)q1i->y * (double)q2i->w);
  const double qo_2c = ksl_product_sum(-(double)q1i->x, (double)q2i->y, (double)q1i->y
          * (double)q2i->x),
      qo_2 = qo_2c
          + ksl_product_sum(-(double)q1i->w, (double)q2i->z, (double)q1i->z * (double)q2i->w);
  const double qo_3e = ksl_product_sum((double)q1i->z, (double)q2i->z,
      ksl_product_sum((double)q1i->y, (double)q2i->y, (double)q1i->x * (double)q2i->x)),
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
  const double qo_0c = ksl_product_sum(-(double)q1i->x, (double)q2i->w, (double)q1i->w
          * (double)q2i->x),
      qo_0 = qo_0c
          + ksl_product_sum(-(double)q1i->y, (double)q2i->z, (double)q1i->z * (double)q2i->y);
  const double qo_1c = ksl_product_sum(-(double)q1i->z, (double)q2i->x, (double)q1i->x
          * (double)q2i->z),
      qo_1 = qo_1c
          + ksl_product_sum(-(double)q1i->y, (double)q2i->w, (double)q1i->w * (double)q2i->y);
  const double qo_2c = ksl_product_sum(-(double)q1i->x, (double)q2i->y, (double)q1i->y
          * (double)q2i->x),
      qo_2 = qo_2c
          + ksl_product_sum(-(double)q1i->z, (double)q2i->w, (double)q1i->w * (double)q2i->z);
  const double qo_3e = ksl_product_sum((double)q1i->z, (double)q2i->z,
      ksl_product_sum((double)q1i->y, (double)q2i->y, (double)q1i->x * (double)q2i->x)),
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
  const double qo_0e = ksl_product_sum(-(double)q1i->x, (double)q2i->w,
      ksl_product_sum(-(double)q1i->z, (double)q2i->y, (double)q1i->y * (double)q2i->z)),
      qo_0 = ksl_product_sum(-(double)q1i->w, (double)q2i->x, qo_0e);
  const double qo_1e = ksl_product_sum(-(double)q1i->y, (double)q2i->w,
      ksl_product_sum(-(double)q1i->x, (double)q2i->z, (double)q1i->z * (double)q2i->x)),
      qo_1 = ksl_product_sum(-(double)q1i->w, (double)q2i->y, qo_1e);
  const double qo_2e = ksl_product_sum(-(double)q1i->z, (double)q2i->w,
      ksl_product_sum(-(double)q1i->y, (double)q2i->x, (double)q1i->x * (double)q2i->y)),
      qo_2 = ksl_product_sum(-(double)q1i->w, (double)q2i->z, qo_2e);
  const double qo_3f = ksl_product_sum(-(double)q1i->z, (double)q2i->z,
      ksl_product_sum(-(double)q1i->y, (double)q2i->y, -((double)q1i->x * (double)q2i->x))),
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
  const double qo_0 = ksl_product_sum((double)dci[1], (double)qi->x, (double)dci[0]
          * (double)qi->w),
      qo_1 = ksl_product_sum(-(double)dci[0], (double)qi->z, (double)dci[1] * (double)qi->y),
      qo_2 = ksl_product_sum((double)dci[1], (double)qi->z, (double)dci[0] * (double)qi->y),
      qo_3 = ksl_product_sum(-(double)dci[0], (double)qi->x, (double)dci[1] * (double)qi->w);
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
  const double qo_0 = ksl_product_sum(-(double)dci[1], (double)qi->x, (double)dci[0]
          * (double)qi->w),
      qo_1 = ksl_product_sum(-(double)dci[1], (double)qi->y, (double)dci[0] * (double)qi->z),
      qo_2 = ksl_product_sum(-(double)dci[1], (double)qi->z, -((double)dci[0] * (double)qi->y)),
      qo_3 = ksl_product_sum((double)dci[1], (double)qi->w, (double)dci[0] * (double)qi->x);
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
  const double qo_0 = ksl_product_sum(-(double)dci[0], (double)qi->w, (double)dci[1]
          * (double)qi->x),
      qo_1 = ksl_product_sum((double)dci[1], (double)qi->y, (double)dci[0] * (double)qi->z),
      qo_2 = ksl_product_sum(-(double)dci[0], (double)qi->y, (double)dci[1] * (double)qi->z),
      qo_3 = ksl_product_sum((double)dci[1], (double)qi->w, (double)dci[0] * (double)qi->x);
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
  const double qo_0 = ksl_product_sum(-(double)dci[1], (double)qi->x,
          -((double)dci[0] * (double)qi->w)),
      qo_1 = ksl_product_sum(-(double)dci[1], (double)qi->y, -((double)dci[0] * (double)qi->z)),
      qo_2 = ksl_product_sum(-(double)dci[1], (double)qi->z, (double)dci[0] * (double)qi->y),
      qo_3 = ksl_product_sum(-(double)dci[0], (double)qi->x, (double)dci[1] * (double)qi->w);
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
  const double qo_0 = ksl_product_sum((double)qi->w, (double)dci[0], (double)qi->x
          * (double)dci[1]),
      qo_1 = ksl_product_sum((double)qi->z, (double)dci[0], (double)qi->y * (double)dci[1]),
      qo_2 = ksl_product_sum(-(double)qi->y, (double)dci[0], (double)qi->z * (double)dci[1]),
      qo_3 = ksl_product_sum(-(double)qi->x, (double)dci[0], (double)qi->w * (double)dci[1]);
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
  const double qo_0 = ksl_product_sum(-(double)qi->w, (double)dci[0], (double)qi->x
          * (double)dci[1]),
      qo_1 = ksl_product_sum(-(double)qi->z, (double)dci[0], (double)qi->y * (double)dci[1]),
      qo_2 = ksl_product_sum((double)qi->z, (double)dci[1], (double)qi->y * (double)dci[0]),
      qo_3 = ksl_product_sum((double)qi->w, (double)dci[1], (double)qi->x * (double)dci[0]);
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
  const double qo_0 = ksl_product_sum(-(double)qi->x, (double)dci[1], (double)qi->w
          * (double)dci[0]),
      qo_1 = ksl_product_sum(-(double)qi->z, (double)dci[0], -((double)qi->y * (double)dci[1])),
      qo_2 = ksl_product_sum(-(double)qi->z, (double)dci[1], (double)qi->y * (double)dci[0]),
      qo_3 = ksl_product_sum((double)qi->w, (double)dci[1], (double)qi->x * (double)dci[0]);
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
  const double qo_0 = ksl_product_sum(-(double)qi->w, (double)dci[0],
          -((double)qi->x * (double)dci[1])),
      qo_1 = ksl_product_sum(-(double)qi->y, (double)dci[1], (double)qi->z * (double)dci[0]),
      qo_2 = ksl_product_sum(-(double)qi->z, (double)dci[1], -((double)qi->y * (double)dci[0])),
      qo_3 = ksl_product_sum(-(double)qi->x, (double)dci[0], (double)qi->w * (double)dci[1]);
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
  const double qo_0 = ksl_product_sum((double)dci[1], (double)qi->x, (double)dci[0]
          * (double)qi->z),
      qo_1 = ksl_product_sum((double)dci[1], (double)qi->y, (double)dci[0] * (double)qi->w),
      qo_2 = ksl_product_sum(-(double)dci[0], (double)qi->x, (double)dci[1] * (double)qi->z),
      qo_3 = ksl_product_sum(-(double)dci[0], (double)qi->y, (double)dci[1] * (double)qi->w);
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
  const double qo_0 = ksl_product_sum(-(double)dci[1], (double)qi->x,
          -((double)dci[0] * (double)qi->z)),
      qo_1 = ksl_product_sum(-(double)dci[1], (double)qi->y, (double)dci[0] * (double)qi->w),
      qo_2 = ksl_product_sum(-(double)dci[1], (double)qi->z, (double)dci[0] * (double)qi->x),
      qo_3 = ksl_product_sum((double)dci[1], (double)qi->w, (double)dci[0] * (double)qi->y);
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
  const double qo_0 = ksl_product_sum(-(double)dci[0], (double)qi->z, (double)dci[1]
          * (double)qi->x),
      qo_1 = ksl_product_sum(-(double)dci[0], (double)qi->w, (double)dci[1] * (double)qi->y),
      qo_2 = ksl_product_sum((double)dci[1], (double)qi->z, (double)dci[0] * (double)qi->x),
      qo_3 = ksl_product_sum((double)dci[1], (double)qi->w, (double)dci[0] * (double)qi->y);
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
  const double qo_0 = ksl_product_sum(-(double)dci[1], (double)qi->x, (double)dci[0]
          * (double)qi->z),
      qo_1 = ksl_product_sum(-(double)dci[1], (double)qi->y, -((double)dci[0] * (double)qi->w)),
      qo_2 = ksl_product_sum(-(double)dci[1], (double)qi->z, -((double)dci[0] * (double)qi->x)),
      qo_3 = ksl_product_sum(-(double)dci[0], (double)qi->y, (double)dci[1] * (double)qi->w);
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
  const double qo_0 = ksl_product_sum(-(double)qi->z, (double)dci[0], (double)qi->x
          * (double)dci[1]),
      qo_1 = ksl_product_sum((double)qi->w, (double)dci[0], (double)qi->y * (double)dci[1]),
      qo_2 = ksl_product_sum((double)qi->z, (double)dci[1], (double)qi->x * (double)dci[0]),
      qo_3 = ksl_product_sum(-(double)qi->y, (double)dci[0], (double)qi->w * (double)dci[1]);
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
  const double qo_0 = ksl_product_sum((double)qi->z, (double)dci[0], (double)qi->x
          * (double)dci[1]),
      qo_1 = ksl_product_sum(-(double)qi->w, (double)dci[0], (double)qi->y * (double)dci[1]),
      qo_2 = ksl_product_sum(-(double)qi->x, (double)dci[0], (double)qi->z * (double)dci[1]),
      qo_3 = ksl_product_sum((double)qi->w, (double)dci[1], (double)qi->y * (double)dci[0]);
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
  const double qo_0 = ksl_product_sum(-(double)qi->x, (double)dci[1], (double)qi->z
          * (double)dci[0]),
      qo_1 = ksl_product_sum(-(double)qi->y, (double)dci[1], (double)qi->w * (double)dci[0]),
      qo_2 = ksl_product_sum(-(double)qi->z, (double)dci[1], -((double)qi->x * (double)dci[0])),
      qo_3 = ksl_product_sum((double)qi->w, (double)dci[1], (double)qi->y * (double)dci[0]);
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
  const double qo_0 = ksl_product_sum(-(double)qi->z, (double)dci[0],
          -((double)qi->x * (double)dci[1])),
      qo_1 = ksl_product_sum(-(double)qi->w, (double)dci[0], -((double)qi->y * (double)dci[1])),
      qo_2 = ksl_product_sum(-(double)qi->z, (double)dci[1], (double)qi->x * (double)dci[0]),
      qo_3 = ksl_product_sum(-(double)qi->y, (double)dci[0], (double)qi->w * (double)dci[1]);
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
  const double qo_0 = ksl_product_sum(-(double)dci[0], (double)qi->y, (double)dci[1]
          * (double)qi->x),
      qo_1 = ksl_product_sum((double)dci[1], (double)qi->y, (double)dci[0] * (double)qi->x),
      qo_2 = ksl_product_sum((double)dci[1], (double)qi->z, (double)dci[0] * (double)qi->w),
      qo_3 = ksl_product_sum(-(double)dci[0], (double)qi->z, (double)dci[1] * (double)qi->w);
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
  const double qo_0 = ksl_product_sum(-(double)dci[1], (double)qi->x, (double)dci[0]
          * (double)qi->y),
      qo_1 = ksl_product_sum(-(double)dci[1], (double)qi->y, -((double)dci[0] * (double)qi->x)),
      qo_2 = ksl_product_sum(-(double)dci[1], (double)qi->z, (double)dci[0] * (double)qi->w),
      qo_3 = ksl_product_sum((double)dci[1], (double)qi->w, (double)dci[0] * (double)qi->z);
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
  const double qo_0 = ksl_product_sum((double)dci[1], (double)qi->x, (double)dci[0]
          * (double)qi->y),
      qo_1 = ksl_product_sum(-(double)dci[0], (double)qi->x, (double)dci[1] * (double)qi->y),
      qo_2 = ksl_product_sum(-(double)dci[0], (double)qi->w, (double)dci[1] * (double)qi->z),
      qo_3 = ksl_product_sum((double)dci[1], (double)qi->w, (double)dci[0] * (double)qi->z);
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
  const double qo_0 = ksl_product_sum(-(double)dci[1], (double)qi->x,
          -((double)dci[0] * (double)qi->y)),
      qo_1 = ksl_product_sum(-(double)dci[1], (double)qi->y, (double)dci[0] * (double)qi->x),
      qo_2 = ksl_product_sum(-(double)dci[1], (double)qi->z, -((double)dci[0] * (double)qi->w)),
      qo_3 = ksl_product_sum(-(double)dci[0], (double)qi->z, (double)dci[1] * (double)qi->w);
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
  const double qo_0 = ksl_product_sum((double)qi->y, (double)dci[0], (double)qi->x
          * (double)dci[1]),
      qo_1 = ksl_product_sum(-(double)qi->x, (double)dci[0], (double)qi->y * (double)dci[1]),
      qo_2 = ksl_product_sum((double)qi->w, (double)dci[0], (double)qi->z * (double)dci[1]),
      qo_3 = ksl_product_sum(-(double)qi->z, (double)dci[0], (double)qi->w * (double)dci[1]);
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
  const double qo_0 = ksl_product_sum(-(double)qi->y, (double)dci[0], (double)qi->x
          * (double)dci[1]),
      qo_1 = ksl_product_sum((double)qi->y, (double)dci[1], (double)qi->x * (double)dci[0]),
      qo_2 = ksl_product_sum(-(double)qi->w, (double)dci[0], (double)qi->z * (double)dci[1]),
      qo_3 = ksl_product_sum((double)qi->w, (double)dci[1], (double)qi->z * (double)dci[0]);
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
  const double qo_0 = ksl_product_sum(-(double)qi->y, (double)dci[0],
          -((double)qi->x * (double)dci[1])),
      qo_1 = ksl_product_sum(-(double)qi->y, (double)dci[1], (double)qi->x * (double)dci[0]),
      qo_2 = ksl_product_sum(-(double)qi->z, (double)dci[1], (double)qi->w * (double)dci[0]),
      qo_3 = ksl_product_sum((double)qi->w, (double)dci[1], (double)qi->z * (double)dci[0]);
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
  const double qo_0 = ksl_product_sum(-(double)qi->x, (double)dci[1], (double)qi->y
          * (double)dci[0]),
      qo_1 = ksl_product_sum(-(double)qi->y, (double)dci[1], -((double)qi->x * (double)dci[0])),
      qo_2 = ksl_product_sum(-(double)qi->w, (double)dci[0], -((double)qi->z * (double)dci[1])),
      qo_3 = ksl_product_sum(-(double)qi->z, (double)dci[0], (double)qi->w * (double)dci[1]);
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
  const double qo_0 = ksl_product_sum((double)qi->w, (double)vi->x, ksl_product_sum(-(double)qi->z,
      (double)vi->y, (double)qi->y * (double)vi->z)),
      qo_1 = ksl_product_sum((double)qi->w, (double)vi->y, ksl_product_sum(-(double)qi->x,
          (double)vi->z, (double)qi->z * (double)vi->x)),
      qo_2 = ksl_product_sum((double)qi->w, (double)vi->z, ksl_product_sum(-(double)qi->y,
          (double)vi->x, (double)qi->x * (double)vi->y)),
      qo_3 = ksl_product_sum(-(double)qi->z, (double)vi->z, ksl_product_sum(-(double)qi->y,
          (double)vi->y, -((double)qi->x * (double)vi->x)));
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
  const double qo_0 = ksl_product_sum((double)qi->w, (double)vi->x, ksl_product_sum(-(double)qi->y,
      (double)vi->z, (double)qi->z * (double)vi->y)),
      qo_1 = ksl_product_sum((double)qi->w, (double)vi->y, ksl_product_sum(-(double)qi->z,
          (double)vi->x, (double)qi->x * (double)vi->z)),
      qo_2 = ksl_product_sum((double)qi->w, (double)vi->z, ksl_product_sum(-(double)qi->x,
          (double)vi->y, (double)qi->y * (double)vi->x)),
      qo_3 = ksl_product_sum((double)qi->z, (double)vi->z, ksl_product_sum((double)qi->y,
          (double)vi->y, (double)qi->x * (double)vi->x));
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
  const double qo_0 = ksl_product_sum((double)vi->x, (double)qi->w, ksl_product_sum(-(double)vi->z,
      (double)qi->y, (double)vi->y * (double)qi->z)),
      qo_1 = ksl_product_sum((double)vi->y, (double)qi->w, ksl_product_sum(-(double)vi->x,
          (double)qi->z, (double)vi->z * (double)qi->x)),
      qo_2 = ksl_product_sum((double)vi->z, (double)qi->w, ksl_product_sum(-(double)vi->y,
          (double)qi->x, (double)vi->x * (double)qi->y)),
      qo_3 = ksl_product_sum(-(double)vi->z, (double)qi->z, ksl_product_sum(-(double)vi->y,
          (double)qi->y, -((double)vi->x * (double)qi->x)));
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
  const double qo_0 = ksl_product_sum((double)vi->x, (double)qi->w, ksl_product_sum(-(double)vi->y,
      (double)qi->z, (double)vi->z * (double)qi->y)),
      qo_1 = ksl_product_sum((double)vi->y, (double)qi->w, ksl_product_sum(-(double)vi->z,
          (double)qi->x, (double)vi->x * (double)qi->z)),
      qo_2 = ksl_product_sum((double)vi->z, (double)qi->w, ksl_product_sum(-(double)vi->x,
          (double)qi->y, (double)vi->y * (double)qi->x)),
      qo_3 = ksl_product_sum((double)vi->z, (double)qi->z, ksl_product_sum((double)vi->y,
          (double)qi->y, (double)vi->x * (double)qi->x));
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
  const double dot_e = ksl_product_sum((double)q1i->z, (double)q2i->z,
      ksl_product_sum((double)q1i->y, (double)q2i->y, (double)q1i->x * (double)q2i->x)),
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
  const double qi_0_new_a = 0.5 * (double)dpi->x, qi_0_new_c = 0.5 * (double)dpi->z,
      qi_0_new_e = 0.5 * (double)dpi->y,
      qi_0_new = KSL_MUL(qi_0_new_a, (double)qi->w)
          + (KSL_MUL(qi_0_new_c, (double)qi->y) - KSL_MUL(qi_0_new_e, (double)qi->z))
          + (double)qi->x;
  const double qi_1_new = KSL_MUL(qi_0_new_a, (double)qi->z) - KSL_MUL(qi_0_new_c, (double)qi->x)
          + KSL_MUL(qi_0_new_e, (double)qi->w) + (double)qi->y,
      qi_2_new = KSL_MUL(qi_0_new_e, (double)qi->x) - KSL_MUL(qi_0_new_a, (double)qi->y)
          + KSL_MUL(qi_0_new_c, (double)qi->w) + (double)qi->z,
      qi_3_new = (double)qi->w
          - (KSL_MUL(qi_0_new_a, (double)qi->x) + KSL_MUL(qi_0_new_e, (double)qi->y)
          + KSL_MUL(qi_0_new_c, (double)qi->z));
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
  const double qi_0_new_a = 0.5 * (double)dpi->y, qi_0_new_c = 0.5 * (double)dpi->z,
      qi_0_new_f = 0.5 * (double)dpi->x,
      qi_0_new = KSL_MUL(qi_0_new_a, (double)qi->z) - KSL_MUL(qi_0_new_c, (double)qi->y)
          - KSL_MUL(qi_0_new_f, (double)qi->w) + (double)qi->x;
  const double qi_1_new = KSL_MUL(qi_0_new_c, (double)qi->x) - KSL_MUL(qi_0_new_f, (double)qi->z)
          - KSL_MUL(qi_0_new_a, (double)qi->w) + (double)qi->y,
      qi_2_new = KSL_MUL(qi_0_new_f, (double)qi->y) - KSL_MUL(qi_0_new_a, (double)qi->x)
          - KSL_MUL(qi_0_new_c, (double)qi->w) + (double)qi->z,
      qi_3_new = KSL_MUL(qi_0_new_f, (double)qi->x) + KSL_MUL(qi_0_new_a, (double)qi->y)
          + KSL_MUL(qi_0_new_c, (double)qi->z) + (double)qi->w;
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
  const double dqo_0a = 0.5 * (double)w->x, dqo_0c = 0.5 * (double)w->y,
      dqo_0e = 0.5 * (double)w->z,
      dqo_0l = ksl_product_sum(-(double)qi->y, (double)qi->y, ksl_product_sum(-(double)qi->x,
          (double)qi->x, 1.0)),
      dqo_0p = ksl_product_sum(-(double)qi->w, (double)qi->w, ksl_product_sum(-(double)qi->z,
          (double)qi->z, dqo_0l)),
      dqo_0 = KSL_MUL(dqo_0a, (double)qi->w)
          + (KSL_MUL(dqo_0c, (double)qi->z) - KSL_MUL(dqo_0e, (double)qi->y))
          + KSL_MUL((double)qi->x, dqo_0p);
  const double dqo_1 = KSL_MUL(dqo_0e, (double)qi->x) - KSL_MUL(dqo_0a, (double)qi->z)
          + KSL_MUL(dqo_0c, (double)qi->w) + KSL_MUL((double)qi->y, dqo_0p),
      dqo_2 = KSL_MUL(dqo_0a, (double)qi->y) - KSL_MUL(dqo_0c, (double)qi->x)
          + KSL_MUL(dqo_0e, (double)qi->w) + KSL_MUL((double)qi->z, dqo_0p),
      dqo_3 = -KSL_MUL(dqo_0a, (double)qi->x) - KSL_MUL(dqo_0c, (double)qi->y)
          - KSL_MUL(dqo_0e, (double)qi->z) + KSL_MUL((double)qi->w, dqo_0p);
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
  const double squares_0 = (double)q->w * (double)q->w, squares_1 = (double)q->x * (double)q->x,
      squares_2 = (double)q->y * (double)q->y, squares_3 = (double)q->z * (double)q->z;
  const double pairs_0 = squares_0 + squares_1, pairs_1 = squares_2 + squares_3,
      pairs_2 = squares_0 + squares_2, pairs_3 = squares_1 + squares_3,
      pairs_4 = squares_0 + squares_3, pairs_5 = squares_1 + squares_2;
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
  const double m_3 = m_0a + m_0b, m_4 = m_1a - m_1b, m_5 = m_2b + m_2a;
  const double R_00 = KSL_MUL(factor, d0), R_01 = KSL_MUL(twice, m_0), R_02 = KSL_MUL(twice, m_1),
      R_10 = KSL_MUL(twice, m_3), R_11 = KSL_MUL(factor, d1), R_12 = KSL_MUL(twice, m_2),
      R_20 = KSL_MUL(twice, m_4), R_21 = KSL_MUL(twice, m_5), R_22 = KSL_MUL(factor, d2);
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
  const double p_0 = (double)R->m21 - (double)R->m12, p_1 = (double)R->m02 - (double)R->m20,
      p_2 = (double)R->m10 - (double)R->m01;
  const double s_0 = (double)R->m12 + (double)R->m21, s_1 = (double)R->m02 + (double)R->m20,
      s_2 = (double)R->m01 + (double)R->m10;
  const double first_0 = (double)R->m00 + 1.0, first_1 = 1.0 - (double)R->m00;
  const double others_0 = (double)R->m11 + (double)R->m22,
      others_1 = (double)R->m11 - (double)R->m22;
  const double d_0 = first_0 + others_0, d_1 = first_0 - others_0, d_2 = first_1 + others_1,
      d_3 = first_1 - others_1;
  const double low_0 = (double)R->m11 < (double)R->m00 ? d_1 : s_2,
      low_1 = (double)R->m11 < (double)R->m00 ? s_2 : d_2,
      low_2 = (double)R->m11 < (double)R->m00 ? s_1 : s_0,
      low_3 = (double)R->m11 < (double)R->m00 ? p_0 : p_1;
  const double high_0a = -(double)R->m11, high_0 = (double)R->m00 < high_0a ? s_1 : p_0;
  const double high_1 = (double)R->m00 < high_0a ? s_0 : p_1,
      high_2 = (double)R->m00 < high_0a ? d_3 : p_2, high_3 = (double)R->m00 < high_0a ? p_2 : d_0;
  const double column_0 = (double)R->m22 < 0.0 ? low_0 : high_0,
      column_1 = (double)R->m22 < 0.0 ? low_1 : high_1,
      column_2 = (double)R->m22 < 0.0 ? low_2 : high_2,
      column_3 = (double)R->m22 < 0.0 ? low_3 : high_3;
  const double upper_0a = -column_0, upper_0 = column_3 < 0.0 ? upper_0a : column_0;
  const double upper_1a = -column_1, upper_1 = column_3 < 0.0 ? upper_1a : column_1;
  const double upper_2a = -column_2, upper_2 = column_3 < 0.0 ? upper_2a : column_2;
  const double upper_3a = -column_3, upper_3 = column_3 < 0.0 ? upper_3a : column_3;
  const double length = sqrt(KSL_MUL(upper_0, upper_0) + KSL_MUL(upper_1, upper_1)
          + KSL_MUL(upper_2, upper_2) + KSL_MUL(upper_3, upper_3));
  const double qo_0 = upper_0 / length, qo_1 = upper_1 / length, qo_2 = upper_2 / length,
      qo_3 = upper_3 / length;
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
  const double qo_0 = KSL_MUL((double)axis->x, sine), qo_1 = KSL_MUL((double)axis->y, sine),
      qo_2 = KSL_MUL((double)axis->z, sine);
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
  const double s_size_0 = fabs((double)q->x), s_size_1 = fabs((double)q->y),
      s_size_2 = fabs((double)q->z), s_size_3 = fabs((double)q->w);
  const double s_largest1 = s_size_0 < s_size_1 ? s_size_1 : s_size_0;
  const double s_largest2 = s_largest1 < s_size_2 ? s_size_2 : s_largest1;
  const double s_largest3 = s_largest2 < s_size_3 ? s_size_3 : s_largest2;
  const double s_b = 4.611686018427388e+18 < s_largest3 ? 2.710505431213761e-20 : 1.0,
      s_d = s_largest3 < 256.0 ? 1.8014398509481984e+16 : s_b,
      s = s_largest3 < 1.4210854715202004e-14 ? 3.2451855365842673e+32 : s_d;
  const double scaled_s_0 = KSL_MUL((double)q->x, s), scaled_s_1 = KSL_MUL((double)q->y, s),
      scaled_s_2 = KSL_MUL((double)q->z, s), scaled_s_3 = KSL_MUL((double)q->w, s);
  const double upper_0a = -scaled_s_0, upper_0 = scaled_s_3 < 0.0 ? upper_0a : scaled_s_0;
  const double upper_1a = -scaled_s_1, upper_1 = scaled_s_3 < 0.0 ? upper_1a : scaled_s_1;
  const double upper_2a = -scaled_s_2, upper_2 = scaled_s_3 < 0.0 ? upper_2a : scaled_s_2;
  const double upper_3a = -scaled_s_3, upper_3 = scaled_s_3 < 0.0 ? upper_3a : scaled_s_3;
  const double v_s_size_0 = fabs(upper_0), v_s_size_1 = fabs(upper_1), v_s_size_2 = fabs(upper_2);
  const double v_s_largest1 = v_s_size_0 < v_s_size_1 ? v_s_size_1 : v_s_size_0;
  const double v_s_largest2 = v_s_largest1 < v_s_size_2 ? v_s_size_2 : v_s_largest1;
  const double v_s_b = v_s_largest2 < 256.0 ? 1.8014398509481984e+16 : 1.0,
      v_s = v_s_largest2 < 1.4210854715202004e-14 ? 3.2451855365842673e+32 : v_s_b;
  const double v_y_0 = KSL_MUL(upper_0, v_s), v_y_1 = KSL_MUL(upper_1, v_s),
      v_y_2 = KSL_MUL(upper_2, v_s);
  const double v_n = sqrt(KSL_MUL(v_y_0, v_y_0) + KSL_MUL(v_y_1, v_y_1) + KSL_MUL(v_y_2, v_y_2));
  const double v_r_b = 1.0 < v_s ? 5.551115123125783e-17 : 1.0,
      v_r = 1.8014398509481984e+16 < v_s ? 3.0814879110195774e-33 : v_r_b;
  const double n = KSL_MUL(v_n, v_r);
  const double half = ksl_atan2(n, upper_3);
  const double divisor = v_n == 0.0 ? 1.0 : v_n;
  const double unit_0 = v_y_0 / divisor, unit_1 = v_y_1 / divisor, unit_2 = v_y_2 / divisor;
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
  const double h_0 = 0.5 * (double)v->x, h_1 = 0.5 * (double)v->y, h_2 = 0.5 * (double)v->z;
  const double h_size_0 = fabs(h_0), h_size_1 = fabs(h_1), h_size_2 = fabs(h_2);
  const double h_largest1 = h_size_0 < h_size_1 ? h_size_1 : h_size_0;
  const double h_largest2 = h_largest1 < h_size_2 ? h_size_2 : h_largest1;
  const double s = 4.611686018427388e+18 < h_largest2 ? 2.710505431213761e-20 : 1.0;
  const double reduced_0 = KSL_MUL(h_0, s), reduced_1 = KSL_MUL(h_1, s),
      reduced_2 = KSL_MUL(h_2, s);
  const double up = s < 1.0 ? 3.6893488147419103e+19 : 1.0;
  const double reduced_length = sqrt(KSL_MUL(reduced_0, reduced_0) + KSL_MUL(reduced_1, reduced_1)
          + KSL_MUL(reduced_2, reduced_2));
  const double half_angle = KSL_MUL(reduced_length, up);
  const double y = KSL_MUL(half_angle, half_angle);
  double c; const double sine = ksl_sincos(half_angle, &c);
  const double sinc_divisor = half_angle < 1.4901161193847656e-08 ? 1.4901161193847656e-08
          : half_angle;
  const double sinc_quotient = sine / sinc_divisor;
  const double sinc_b = 1.0 - KSL_MUL(0.16666666666666666, y),
      sinc = half_angle < 1.4901161193847656e-08 ? sinc_b : sinc_quotient;
  const double qo_0 = KSL_MUL(h_0, sinc), qo_1 = KSL_MUL(h_1, sinc), qo_2 = KSL_MUL(h_2, sinc);
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
  const double s_size_0 = fabs((double)q->x), s_size_1 = fabs((double)q->y),
      s_size_2 = fabs((double)q->z), s_size_3 = fabs((double)q->w);
  const double s_largest1 = s_size_0 < s_size_1 ? s_size_1 : s_size_0;
  const double s_largest2 = s_largest1 < s_size_2 ? s_size_2 : s_largest1;
  const double s_largest3 = s_largest2 < s_size_3 ? s_size_3 : s_largest2;
  const double s_b = 4.611686018427388e+18 < s_largest3 ? 2.710505431213761e-20 : 1.0,
      s_d = s_largest3 < 256.0 ? 1.8014398509481984e+16 : s_b,
      s = s_largest3 < 1.4210854715202004e-14 ? 3.2451855365842673e+32 : s_d;
  const double scaled_s_0 = KSL_MUL((double)q->x, s), scaled_s_1 = KSL_MUL((double)q->y, s),
      scaled_s_2 = KSL_MUL((double)q->z, s), scaled_s_3 = KSL_MUL((double)q->w, s);
  const double upper_0a = -scaled_s_0, upper_0 = scaled_s_3 < 0.0 ? upper_0a : scaled_s_0;
  const double upper_1a = -scaled_s_1, upper_1 = scaled_s_3 < 0.0 ? upper_1a : scaled_s_1;
  const double upper_2a = -scaled_s_2, upper_2 = scaled_s_3 < 0.0 ? upper_2a : scaled_s_2;
  const double upper_3a = -scaled_s_3, upper_3 = scaled_s_3 < 0.0 ? upper_3a : scaled_s_3;
  const double v_s_size_0 = fabs(upper_0), v_s_size_1 = fabs(upper_1), v_s_size_2 = fabs(upper_2);
  const double v_s_largest1 = v_s_size_0 < v_s_size_1 ? v_s_size_1 : v_s_size_0;
  const double v_s_largest2 = v_s_largest1 < v_s_size_2 ? v_s_size_2 : v_s_largest1;
  const double v_s_b = v_s_largest2 < 256.0 ? 1.8014398509481984e+16 : 1.0,
      v_s = v_s_largest2 < 1.4210854715202004e-14 ? 3.2451855365842673e+32 : v_s_b;
  const double v_y_0 = KSL_MUL(upper_0, v_s), v_y_1 = KSL_MUL(upper_1, v_s),
      v_y_2 = KSL_MUL(upper_2, v_s);
  const double v_n = sqrt(KSL_MUL(v_y_0, v_y_0) + KSL_MUL(v_y_1, v_y_1) + KSL_MUL(v_y_2, v_y_2));
  const double v_r_b = 1.0 < v_s ? 5.551115123125783e-17 : 1.0,
      v_r = 1.8014398509481984e+16 < v_s ? 3.0814879110195774e-33 : v_r_b;
  const double n = KSL_MUL(v_n, v_r);
  const double half = ksl_atan2(n, upper_3);
  const double divisor = n == 0.0 ? 1.0 : n;
  const double theta = KSL_MUL(2.0, half);
  const double k = theta / divisor;
  const double vector_0 = KSL_MUL(upper_0, k), vector_1 = KSL_MUL(upper_1, k),
      vector_2 = KSL_MUL(upper_2, k);
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
  const double between_0c = ksl_product_sum(-(double)q1->x, (double)q2->w, (double)q1->w
          * (double)q2->x),
      between_0 = between_0c
          + ksl_product_sum(-(double)q1->y, (double)q2->z, (double)q1->z * (double)q2->y);
  const double between_1c = ksl_product_sum(-(double)q1->z, (double)q2->x, (double)q1->x
          * (double)q2->z),
      between_1 = between_1c
          + ksl_product_sum(-(double)q1->y, (double)q2->w, (double)q1->w * (double)q2->y);
  const double between_2c = ksl_product_sum(-(double)q1->x, (double)q2->y, (double)q1->y
          * (double)q2->x),
      between_2 = between_2c
          + ksl_product_sum(-(double)q1->z, (double)q2->w, (double)q1->w * (double)q2->z);
  const double between_3e = ksl_product_sum((double)q1->z, (double)q2->z,
      ksl_product_sum((double)q1->y, (double)q2->y, (double)q1->x * (double)q2->x)),
      between_3 = ksl_product_sum((double)q1->w, (double)q2->w, between_3e);
  const double upper_0a = -between_0, upper_0 = between_3 < 0.0 ? upper_0a : between_0;
  const double upper_1a = -between_1, upper_1 = between_3 < 0.0 ? upper_1a : between_1;
  const double upper_2a = -between_2, upper_2 = between_3 < 0.0 ? upper_2a : between_2;
  const double upper_3 = fabs(between_3);
  const double v_s_size_0 = fabs(upper_0), v_s_size_1 = fabs(upper_1), v_s_size_2 = fabs(upper_2);
  const double v_s_largest1 = v_s_size_0 < v_s_size_1 ? v_s_size_1 : v_s_size_0;
  const double v_s_largest2 = v_s_largest1 < v_s_size_2 ? v_s_size_2 : v_s_largest1;
  const double v_s_b = 4.611686018427388e+18 < v_s_largest2 ? 2.710505431213761e-20 : 1.0,
      v_s_d = v_s_largest2 < 256.0 ? 1.8014398509481984e+16 : v_s_b,
      v_s = v_s_largest2 < 1.4210854715202004e-14 ? 3.2451855365842673e+32 : v_s_d;
  const double v_y_0 = KSL_MUL(upper_0, v_s), v_y_1 = KSL_MUL(upper_1, v_s),
      v_y_2 = KSL_MUL(upper_2, v_s);
  const double v_n = sqrt(KSL_MUL(v_y_0, v_y_0) + KSL_MUL(v_y_1, v_y_1) + KSL_MUL(v_y_2, v_y_2));
  const double v_r_b = v_s < 1.0 ? 3.6893488147419103e+19 : 1.0,
      v_r_d = 1.0 < v_s ? 5.551115123125783e-17 : v_r_b,
      v_r = 1.8014398509481984e+16 < v_s ? 3.0814879110195774e-33 : v_r_d;
  const double n = KSL_MUL(v_n, v_r);
  const double half = ksl_atan2(n, upper_3);
  const double divisor = n == 0.0 ? 1.0 : n;
  const double rate = half / divisor;
  const double kv_0 = KSL_MUL((double)k, upper_0), kv_1 = KSL_MUL((double)k, upper_1),
      kv_2 = KSL_MUL((double)k, upper_2);
  const double step_0 = KSL_MUL(rate, kv_0), step_1 = KSL_MUL(rate, kv_1),
      step_2 = KSL_MUL(rate, kv_2);
  const double exp_h_size_0 = fabs(step_0), exp_h_size_1 = fabs(step_1),
      exp_h_size_2 = fabs(step_2);
  const double exp_h_largest1 = exp_h_size_0 < exp_h_size_1 ? exp_h_size_1 : exp_h_size_0;
  const double exp_h_largest2 = exp_h_largest1 < exp_h_size_2 ? exp_h_size_2 : exp_h_largest1;
  const double exp_s = 4.611686018427388e+18 < exp_h_largest2 ? 2.710505431213761e-20 : 1.0;
  const double exp_reduced_0 = KSL_MUL(step_0, exp_s), exp_reduced_1 = KSL_MUL(step_1, exp_s),
      exp_reduced_2 = KSL_MUL(step_2, exp_s);
  const double exp_up = exp_s < 1.0 ? 3.6893488147419103e+19 : 1.0;
  const double exp_reduced_length = sqrt(KSL_MUL(exp_reduced_0, exp_reduced_0)
          + KSL_MUL(exp_reduced_1, exp_reduced_1) + KSL_MUL(exp_reduced_2, exp_reduced_2));
  const double exp_half_angle = KSL_MUL(exp_reduced_length, exp_up);
  const double exp_y = KSL_MUL(exp_half_angle, exp_half_angle);
  double exp_c; const double exp_sine = ksl_sincos(exp_half_angle, &exp_c);
  const double exp_sinc_divisor = exp_half_angle < 1.4901161193847656e-08 ? 1.4901161193847656e-08
          : exp_half_angle;
  const double exp_sinc_quotient = exp_sine / exp_sinc_divisor;
  const double exp_sinc_b = 1.0 - KSL_MUL(0.16666666666666666, exp_y),
      exp_sinc = exp_half_angle < 1.4901161193847656e-08 ? exp_sinc_b : exp_sinc_quotient;
  const double power_0 = KSL_MUL(step_0, exp_sinc), power_1 = KSL_MUL(step_1, exp_sinc),
      power_2 = KSL_MUL(step_2, exp_sinc);
  const double qo_0 = KSL_MUL((double)q1->x, exp_c)
          + (KSL_MUL((double)q1->y, power_2) - KSL_MUL((double)q1->z, power_1))
          + KSL_MUL((double)q1->w, power_0),
      qo_1 = KSL_MUL((double)q1->z, power_0) - KSL_MUL((double)q1->x, power_2)
          + KSL_MUL((double)q1->y, exp_c) + KSL_MUL((double)q1->w, power_1),
      qo_2 = KSL_MUL((double)q1->x, power_1) - KSL_MUL((double)q1->y, power_0)
          + KSL_MUL((double)q1->z, exp_c) + KSL_MUL((double)q1->w, power_2),
      qo_3 = -KSL_MUL((double)q1->x, power_0) - KSL_MUL((double)q1->y, power_1)
          - KSL_MUL((double)q1->z, power_2) + KSL_MUL((double)q1->w, exp_c);
  qo->x = (float)qo_0;
  qo->y = (float)qo_1;
  qo->z = (float)qo_2;
  qo->w = (float)qo_3;
}

#endif
