/* Made by `coscrew generate`; changes are overwritten. */
/* SPDX-License-Identifier: MIT */
/* coscrew 0.2.0.  Copyright (c) 2026 The coscrew authors. */
/* Vectors of three components.
   Accurate tier: double compensated, single computed in double. */
#ifndef KSL_VEC3_ACCURATE_H
#define KSL_VEC3_ACCURATE_H

#include "ksl_exact.h"
#include "elementary.h"
#include "ksl_elementary_error.h"

/* self = a self.
   self: vector; a: number.
   3 mul, 3 add, 3 product error.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_vec3_scale_accurate(ksl_vec3_t *self, const double a) {
  const double self_0_new = KSL_MUL(self->x, a), self_1_new = KSL_MUL(self->y, a),
      self_2_new = KSL_MUL(self->z, a);
  const double self_0_new_rounded = self_0_new + ksl_product_error(self->x, a, self_0_new),
      self_1_new_rounded = self_1_new + ksl_product_error(self->y, a, self_1_new),
      self_2_new_rounded = self_2_new + ksl_product_error(self->z, a, self_2_new);
  self->x = self_0_new_rounded;
  self->y = self_1_new_rounded;
  self->z = self_2_new_rounded;
}

/* y = a x + y.
   a: number; x, y: vector.
   3 mul, 18 add, 3 product rest.
   Error <= u |result| + 3 u^2 S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_axpy_vv_accurate(const double a, const ksl_vec3_t *x, ksl_vec3_t *y) {
  const double y_0_new_a = KSL_MUL(a, x->x), y_0_new = y_0_new_a + y->x,
      y_0_new_right = y_0_new - y_0_new_a;
  const double y_1_new_a = KSL_MUL(a, x->y), y_1_new = y_1_new_a + y->y,
      y_1_new_right = y_1_new - y_1_new_a;
  const double y_2_new_a = KSL_MUL(a, x->z), y_2_new = y_2_new_a + y->z,
      y_2_new_right = y_2_new - y_2_new_a;
  const double y_0_new_rounded = y_0_new
          + (ksl_product_rest(a, x->x, y_0_new_a, y_0_new - y_0_new_right)
          + (y->x - y_0_new_right)),
      y_1_new_rounded = y_1_new
          + (ksl_product_rest(a, x->y, y_1_new_a, y_1_new - y_1_new_right)
          + (y->y - y_1_new_right)),
      y_2_new_rounded = y_2_new
          + (ksl_product_rest(a, x->z, y_2_new_a, y_2_new - y_2_new_right)
          + (y->z - y_2_new_right));
  y->x = y_0_new_rounded;
  y->y = y_1_new_rounded;
  y->z = y_2_new_rounded;
}

/* y = x + y.
   x, y: vector.
   21 add.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_xpy_vv_accurate(const ksl_vec3_t *x, ksl_vec3_t *y) {
  const double y_0_new = x->x + y->x, y_0_new_right = y_0_new - x->x;
  const double y_1_new = x->y + y->y, y_1_new_right = y_1_new - x->y;
  const double y_2_new = x->z + y->z, y_2_new_right = y_2_new - x->z;
  const double y_0_new_rounded = y_0_new
          + (x->x - (y_0_new - y_0_new_right) + (y->x - y_0_new_right)),
      y_1_new_rounded = y_1_new + (x->y - (y_1_new - y_1_new_right) + (y->y - y_1_new_right)),
      y_2_new_rounded = y_2_new + (x->z - (y_2_new - y_2_new_right) + (y->z - y_2_new_right));
  y->x = y_0_new_rounded;
  y->y = y_1_new_rounded;
  y->z = y_2_new_rounded;
}

/* y = -x + y.
   x, y: vector.
   21 add.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_nxpy_vv_accurate(const ksl_vec3_t *x, ksl_vec3_t *y) {
  const double y_0_new = y->x - x->x, y_0_new_right = y->x - y_0_new;
  const double y_1_new = y->y - x->y, y_1_new_right = y->y - y_1_new;
  const double y_2_new = y->z - x->z, y_2_new_right = y->z - y_2_new;
  const double y_0_new_rounded = y_0_new
          + (y->x - (y_0_new + y_0_new_right) - (x->x - y_0_new_right)),
      y_1_new_rounded = y_1_new + (y->y - (y_1_new + y_1_new_right) - (x->y - y_1_new_right)),
      y_2_new_rounded = y_2_new + (y->z - (y_2_new + y_2_new_right) - (x->z - y_2_new_right));
  y->x = y_0_new_rounded;
  y->y = y_1_new_rounded;
  y->z = y_2_new_rounded;
}

/* vo = a vi.
   a: number; vi, vo: vector.
   3 mul, 3 add, 3 product error.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_product_av_accurate(const double a, const ksl_vec3_t *vi, ksl_vec3_t *vo) {
  const double vo_0 = KSL_MUL(a, vi->x), vo_1 = KSL_MUL(a, vi->y), vo_2 = KSL_MUL(a, vi->z);
  const double vo_0_rounded = vo_0 + ksl_product_error(a, vi->x, vo_0),
      vo_1_rounded = vo_1 + ksl_product_error(a, vi->y, vo_1),
      vo_2_rounded = vo_2 + ksl_product_error(a, vi->z, vo_2);
  vo->x = vo_0_rounded;
  vo->y = vo_1_rounded;
  vo->z = vo_2_rounded;
}

/* vo = v1 + v2.
   v1, v2, vo: vector.
   21 add.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_add_vv_accurate(const ksl_vec3_t *v1, const ksl_vec3_t *v2, ksl_vec3_t *vo) {
  const double vo_0 = v1->x + v2->x, vo_0_right = vo_0 - v1->x;
  const double vo_1 = v1->y + v2->y, vo_1_right = vo_1 - v1->y;
  const double vo_2 = v1->z + v2->z, vo_2_right = vo_2 - v1->z;
  const double vo_0_rounded = vo_0 + (v1->x - (vo_0 - vo_0_right) + (v2->x - vo_0_right)),
      vo_1_rounded = vo_1 + (v1->y - (vo_1 - vo_1_right) + (v2->y - vo_1_right)),
      vo_2_rounded = vo_2 + (v1->z - (vo_2 - vo_2_right) + (v2->z - vo_2_right));
  vo->x = vo_0_rounded;
  vo->y = vo_1_rounded;
  vo->z = vo_2_rounded;
}

/* vo = v1 - v2.
   v1, v2, vo: vector.
   21 add.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_subtract_vv_accurate(const ksl_vec3_t *v1, const ksl_vec3_t *v2,
    ksl_vec3_t *vo) {
  const double vo_0 = v1->x - v2->x, vo_0_right = v1->x - vo_0;
  const double vo_1 = v1->y - v2->y, vo_1_right = v1->y - vo_1;
  const double vo_2 = v1->z - v2->z, vo_2_right = v1->z - vo_2;
  const double vo_0_rounded = vo_0 + (v1->x - (vo_0 + vo_0_right) - (v2->x - vo_0_right)),
      vo_1_rounded = vo_1 + (v1->y - (vo_1 + vo_1_right) - (v2->y - vo_1_right)),
      vo_2_rounded = vo_2 + (v1->z - (vo_2 + vo_2_right) - (v2->z - vo_2_right));
  vo->x = vo_0_rounded;
  vo->y = vo_1_rounded;
  vo->z = vo_2_rounded;
}

/* vo = k v.
   v, vo: vector; k: number.
   3 mul, 3 add, 3 product error.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_vec3_scaled_accurate(const ksl_vec3_t *v, const double k, ksl_vec3_t *vo) {
  const double vo_0 = KSL_MUL(v->x, k), vo_1 = KSL_MUL(v->y, k), vo_2 = KSL_MUL(v->z, k);
  const double vo_0_rounded = vo_0 + ksl_product_error(v->x, k, vo_0),
      vo_1_rounded = vo_1 + ksl_product_error(v->y, k, vo_1),
      vo_2_rounded = vo_2 + ksl_product_error(v->z, k, vo_2);
  vo->x = vo_0_rounded;
  vo->y = vo_1_rounded;
  vo->z = vo_2_rounded;
}

/* |v| = sqrt(v·v).
   v: vector.
   10 mul, 29 add, 1 product error, 3 product rest, 2 div, 1 sqrt, 3 abs, 8 less, 2 equal, 10
     select. */
static inline double ksl_vec3_l2norm_accurate(const ksl_vec3_t *v) {
  const double s_size_0 = fabs(v->x), s_size_1 = fabs(v->y), s_size_2 = fabs(v->z);
  const double s_largest1 = s_size_0 < s_size_1 ? s_size_1 : s_size_0;
  const double s_largest2 = s_largest1 < s_size_2 ? s_size_2 : s_largest1;
  const double s_b = 6.703903964971299e+153 < s_largest2 ? 3.7291703656001034e-155 : 1.0,
      s_d = s_largest2 < 256.0 ? 1.3093562431584567e+151 : s_b,
      s = s_largest2 < 1.955159272639747e-149 ? 1.0715086071862673e+301 : s_d;
  const double y_0 = KSL_MUL(v->x, s), y_1 = KSL_MUL(v->y, s), y_2 = KSL_MUL(v->z, s);
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

/* self = self / |self|; the zero vector stays zero.
   self: vector.
   25 mul, 68 add, 4 product error, 3 product rest, 8 div, 1 sqrt, 3 abs, 7 less, 5 equal, 13
     select. */
static inline void ksl_vec3_normalize_accurate(ksl_vec3_t *self) {
  const double s_size_0 = fabs(self->x), s_size_1 = fabs(self->y), s_size_2 = fabs(self->z);
  const double s_largest1 = s_size_0 < s_size_1 ? s_size_1 : s_size_0;
  const double s_largest2 = s_largest1 < s_size_2 ? s_size_2 : s_largest1;
  const double s_b = 6.703903964971299e+153 < s_largest2 ? 3.7291703656001034e-155 : 1.0,
      s_d = s_largest2 < 256.0 ? 1.3093562431584567e+151 : s_b,
      s = s_largest2 < 1.955159272639747e-149 ? 1.0715086071862673e+301 : s_d;
  const double y_0 = KSL_MUL(self->x, s), y_1 = KSL_MUL(self->y, s), y_2 = KSL_MUL(self->z, s);
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
  const double sized_0 = KSL_MUL(self->x, up), sized_1 = KSL_MUL(self->y, up),
      sized_2 = KSL_MUL(self->z, up);
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
  const double self_0_new_rounded = self_0_new
          + KSL_MUL(quotient_0_sum - KSL_MUL(self_0_new, self_0_new_inverse)
          + quotient_0_sum_lo, down);
  const double self_1_new_rounded = self_1_new
          + KSL_MUL(quotient_1_sum - KSL_MUL(self_1_new, self_0_new_inverse)
          + quotient_1_sum_lo, down);
  const double self_2_new_rounded = self_2_new
          + KSL_MUL(quotient_2_sum - KSL_MUL(self_2_new, self_0_new_inverse)
          + quotient_2_sum_lo, down);
  const double self_0_new_final = self_0_new_rounded == self_0_new_rounded ? self_0_new_rounded
          : self_0_new;
  const double self_1_new_final = self_1_new_rounded == self_1_new_rounded ? self_1_new_rounded
          : self_1_new;
  const double self_2_new_final = self_2_new_rounded == self_2_new_rounded ? self_2_new_rounded
          : self_2_new;
  self->x = self_0_new_final;
  self->y = self_1_new_final;
  self->z = self_2_new_final;
}

/* vo = v / |v|; the zero vector stays zero.
   v, vo: vector.
   25 mul, 68 add, 4 product error, 3 product rest, 8 div, 1 sqrt, 3 abs, 7 less, 5 equal, 13
     select. */
static inline void ksl_vec3_normalized_accurate(const ksl_vec3_t *v, ksl_vec3_t *vo) {
  const double s_size_0 = fabs(v->x), s_size_1 = fabs(v->y), s_size_2 = fabs(v->z);
  const double s_largest1 = s_size_0 < s_size_1 ? s_size_1 : s_size_0;
  const double s_largest2 = s_largest1 < s_size_2 ? s_size_2 : s_largest1;
  const double s_b = 6.703903964971299e+153 < s_largest2 ? 3.7291703656001034e-155 : 1.0,
      s_d = s_largest2 < 256.0 ? 1.3093562431584567e+151 : s_b,
      s = s_largest2 < 1.955159272639747e-149 ? 1.0715086071862673e+301 : s_d;
  const double y_0 = KSL_MUL(v->x, s), y_1 = KSL_MUL(v->y, s), y_2 = KSL_MUL(v->z, s);
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
  const double sized_0 = KSL_MUL(v->x, up), sized_1 = KSL_MUL(v->y, up),
      sized_2 = KSL_MUL(v->z, up);
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
  const double quotient_0_sum = quotient_0 + quotient_0_lo,
      quotient_0_sum_right = quotient_0_sum - quotient_0, vo_0 = KSL_MUL(quotient_0_sum, down),
      vo_0_inverse = 1.0 / down,
      quotient_0_sum_lo = quotient_0 - (quotient_0_sum - quotient_0_sum_right)
          + (quotient_0_lo - quotient_0_sum_right);
  const double quotient_1_sum = quotient_1 + quotient_1_lo,
      quotient_1_sum_right = quotient_1_sum - quotient_1, vo_1 = KSL_MUL(quotient_1_sum, down),
      quotient_1_sum_lo = quotient_1 - (quotient_1_sum - quotient_1_sum_right)
          + (quotient_1_lo - quotient_1_sum_right);
  const double quotient_2_sum = quotient_2 + quotient_2_lo,
      quotient_2_sum_right = quotient_2_sum - quotient_2, vo_2 = KSL_MUL(quotient_2_sum, down),
      quotient_2_sum_lo = quotient_2 - (quotient_2_sum - quotient_2_sum_right)
          + (quotient_2_lo - quotient_2_sum_right);
  const double vo_0_rounded = vo_0
          + KSL_MUL(quotient_0_sum - KSL_MUL(vo_0, vo_0_inverse) + quotient_0_sum_lo, down);
  const double vo_1_rounded = vo_1
          + KSL_MUL(quotient_1_sum - KSL_MUL(vo_1, vo_0_inverse) + quotient_1_sum_lo, down);
  const double vo_2_rounded = vo_2
          + KSL_MUL(quotient_2_sum - KSL_MUL(vo_2, vo_0_inverse) + quotient_2_sum_lo, down);
  const double vo_0_final = vo_0_rounded == vo_0_rounded ? vo_0_rounded : vo_0;
  const double vo_1_final = vo_1_rounded == vo_1_rounded ? vo_1_rounded : vo_1;
  const double vo_2_final = vo_2_rounded == vo_2_rounded ? vo_2_rounded : vo_2;
  vo->x = vo_0_final;
  vo->y = vo_1_final;
  vo->z = vo_2_final;
}

/* angle = atan2(|v1 × v2|, v1·v2), in [0, π].
   v1, v2: vector.
   164 mul, 333 add, 22 product error, 12 product rest, 8 div, 1 sqrt, 4 neg, 19 abs, 4 copysign,
     35 less, 6 equal, 51 select.
   Each component is within 1 ulp as long as its condition is below 1e13; in single precision it
     is the nearest number, except near ties, as long as that is below 1e5; searched, not proved. */
static inline double ksl_angle_vv_accurate(const ksl_vec3_t *v1, const ksl_vec3_t *v2) {
  const double s1_size_0 = fabs(v1->x), s1_size_1 = fabs(v1->y), s1_size_2 = fabs(v1->z);
  const double s1_largest1 = s1_size_0 < s1_size_1 ? s1_size_1 : s1_size_0;
  const double s1_largest2 = s1_largest1 < s1_size_2 ? s1_size_2 : s1_largest1;
  const double s1b = 6.703903964971299e+153 < s1_largest2 ? 3.7291703656001034e-155 : 1.0,
      s1d = s1_largest2 < 256.0 ? 1.3093562431584567e+151 : s1b,
      s1 = s1_largest2 < 1.955159272639747e-149 ? 1.0715086071862673e+301 : s1d;
  const double scaled_s1_0 = KSL_MUL(v1->x, s1), scaled_s1_1 = KSL_MUL(v1->y, s1),
      scaled_s1_2 = KSL_MUL(v1->z, s1);
  const double s2_size_0 = fabs(v2->x), s2_size_1 = fabs(v2->y), s2_size_2 = fabs(v2->z);
  const double s2_largest1 = s2_size_0 < s2_size_1 ? s2_size_1 : s2_size_0;
  const double s2_largest2 = s2_largest1 < s2_size_2 ? s2_size_2 : s2_largest1;
  const double s2b = 6.703903964971299e+153 < s2_largest2 ? 3.7291703656001034e-155 : 1.0,
      s2d = s2_largest2 < 256.0 ? 1.3093562431584567e+151 : s2b,
      s2 = s2_largest2 < 1.955159272639747e-149 ? 1.0715086071862673e+301 : s2d;
  const double scaled_s2_0 = KSL_MUL(v2->x, s2), scaled_s2_1 = KSL_MUL(v2->y, s2),
      scaled_s2_2 = KSL_MUL(v2->z, s2);
  const double c_0a = KSL_MUL(scaled_s1_1, scaled_s2_2), c_0b = KSL_MUL(scaled_s1_2, scaled_s2_1),
      c_0 = c_0a - c_0b, c_0_right = c_0a - c_0,
      c_0_lo = ksl_product_rest(scaled_s1_1, scaled_s2_2, c_0a, c_0 + c_0_right)
          - ksl_product_rest(scaled_s1_2, scaled_s2_1, c_0b, c_0_right);
  const double c_1a = KSL_MUL(scaled_s1_2, scaled_s2_0), c_1b = KSL_MUL(scaled_s1_0, scaled_s2_2),
      c_1 = c_1a - c_1b, c_1_right = c_1a - c_1,
      c_1_lo = ksl_product_rest(scaled_s1_2, scaled_s2_0, c_1a, c_1 + c_1_right)
          - ksl_product_rest(scaled_s1_0, scaled_s2_2, c_1b, c_1_right);
  const double c_2a = KSL_MUL(scaled_s1_0, scaled_s2_1), c_2b = KSL_MUL(scaled_s1_1, scaled_s2_0),
      c_2 = c_2a - c_2b, c_2_right = c_2a - c_2,
      c_2_lo = ksl_product_rest(scaled_s1_0, scaled_s2_1, c_2a, c_2 + c_2_right)
          - ksl_product_rest(scaled_s1_1, scaled_s2_0, c_2b, c_2_right);
  const double c_0_sum = c_0 + c_0_lo, c_0_sum_right = c_0_sum - c_0,
      c_0_sum_lo = c_0 - (c_0_sum - c_0_sum_right) + (c_0_lo - c_0_sum_right),
      s_size_0 = fabs(c_0_sum), s_size_0_opposite = -c_0_sum_lo,
      s_size_0_lo = c_0_sum < 0.0 ? s_size_0_opposite : c_0_sum_lo;
  const double c_1_sum = c_1 + c_1_lo, c_1_sum_right = c_1_sum - c_1,
      c_1_sum_lo = c_1 - (c_1_sum - c_1_sum_right) + (c_1_lo - c_1_sum_right),
      s_size_1 = fabs(c_1_sum), s_size_1_opposite = -c_1_sum_lo,
      s_size_1_lo = c_1_sum < 0.0 ? s_size_1_opposite : c_1_sum_lo;
  const double c_2_sum = c_2 + c_2_lo, c_2_sum_right = c_2_sum - c_2,
      c_2_sum_lo = c_2 - (c_2_sum - c_2_sum_right) + (c_2_lo - c_2_sum_right),
      s_size_2 = fabs(c_2_sum), s_size_2_opposite = -c_2_sum_lo,
      s_size_2_lo = c_2_sum < 0.0 ? s_size_2_opposite : c_2_sum_lo;
  const double s_size_0_sum = s_size_0 + s_size_0_lo, s_size_0_sum_right = s_size_0_sum - s_size_0,
      s_size_0_sum_lo = s_size_0 - (s_size_0_sum - s_size_0_sum_right)
          + (s_size_0_lo - s_size_0_sum_right), s_size_1_sum = s_size_1 + s_size_1_lo,
      s_size_1_sum_right = s_size_1_sum - s_size_1,
      s_size_1_sum_lo = s_size_1 - (s_size_1_sum - s_size_1_sum_right)
          + (s_size_1_lo - s_size_1_sum_right),
      s_largest1 = s_size_0_sum < s_size_1_sum ? s_size_1_sum : s_size_0_sum,
      s_largest1_lo = s_size_0_sum < s_size_1_sum ? s_size_1_sum_lo : s_size_0_sum_lo;
  const double s_largest1_sum = s_largest1 + s_largest1_lo,
      s_largest1_sum_right = s_largest1_sum - s_largest1,
      s_largest1_sum_lo = s_largest1 - (s_largest1_sum - s_largest1_sum_right)
          + (s_largest1_lo - s_largest1_sum_right), s_size_2_sum = s_size_2 + s_size_2_lo,
      s_size_2_sum_right = s_size_2_sum - s_size_2,
      s_size_2_sum_lo = s_size_2 - (s_size_2_sum - s_size_2_sum_right)
          + (s_size_2_lo - s_size_2_sum_right),
      s_largest2 = s_largest1_sum < s_size_2_sum ? s_size_2_sum : s_largest1_sum;
  const double s_largest2_sum = s_largest2
          + (s_largest1_sum < s_size_2_sum ? s_size_2_sum_lo : s_largest1_sum_lo),
      s_b = 6.703903964971299e+153 < s_largest2_sum ? 3.7291703656001034e-155 : 1.0,
      s_d = s_largest2_sum < 256.0 ? 1.3093562431584567e+151 : s_b,
      s = s_largest2_sum < 1.955159272639747e-149 ? 1.0715086071862673e+301 : s_d;
  const double y_0 = KSL_MUL(c_0_sum, s), y_0_inverse = 1.0 / s,
      y_0_lo = KSL_MUL(c_0_sum - KSL_MUL(y_0, y_0_inverse) + c_0_sum_lo, s);
  const double y_1 = KSL_MUL(c_1_sum, s),
      y_1_lo = KSL_MUL(c_1_sum - KSL_MUL(y_1, y_0_inverse) + c_1_sum_lo, s);
  const double y_2 = KSL_MUL(c_2_sum, s),
      y_2_lo = KSL_MUL(c_2_sum - KSL_MUL(y_2, y_0_inverse) + c_2_sum_lo, s);
  const double n_a = KSL_MUL(y_0, y_0), n_b = KSL_MUL(y_1, y_1), n_c = n_a + n_b,
      n_c_right = n_c - n_a,
      n_c_lo1 = ksl_product_rest(y_0, y_0, n_a, n_c - n_c_right)
          + ksl_product_rest(y_1, y_1, n_b, n_c_right), n_d = KSL_MUL(y_2, y_2), n_e = n_c + n_d,
      n_e_right = n_e - n_c,
      n_e_lo2 = n_c - (n_e - n_e_right) + ksl_product_rest(y_2, y_2, n_d, n_e_right)
          + (KSL_MUL(y_2_lo, y_2) + KSL_MUL(y_2, y_2_lo)),
      n_e_lo = n_e_lo2
          + (n_c_lo1
          + (KSL_MUL(y_0_lo, y_0) + KSL_MUL(y_0, y_0_lo)
          + (KSL_MUL(y_1_lo, y_1) + KSL_MUL(y_1, y_1_lo)))), n_e_sum = n_e + n_e_lo,
      n_e_sum_right = n_e_sum - n_e, n = sqrt(n_e_sum), n_product = KSL_MUL(n, n), n_twice = n + n,
      n_residual = n_e_sum - n_product - ksl_product_error(n, n, n_product)
          + (n_e - (n_e_sum - n_e_sum_right) + (n_e_lo - n_e_sum_right)),
      n_lo = n_residual / (n == 0.0 ? 1.0 : n_twice);
  const double r_b = s < 1.0 ? 2.6815615859885194e+154 : 1.0,
      r_d = 1.0 < s ? 7.637340908749012e-152 : r_b,
      r = 1.3093562431584567e+151 < s ? 9.332636185032189e-302 : r_d;
  const double n_sum = n + n_lo, n_sum_right = n_sum - n, cross = KSL_MUL(n_sum, r),
      cross_lo = KSL_MUL(n_sum - KSL_MUL(cross, 1.0 / r)
          + (n - (n_sum - n_sum_right) + (n_lo - n_sum_right)), r);
  const double dot__a = KSL_MUL(scaled_s1_0, scaled_s2_0),
      dot__b = KSL_MUL(scaled_s1_1, scaled_s2_1), dot__c = dot__a + dot__b,
      dot__c_right = dot__c - dot__a,
      dot__c_left_rest = ksl_product_rest(scaled_s1_0, scaled_s2_0, dot__a, dot__c - dot__c_right),
      dot__d = KSL_MUL(scaled_s1_2, scaled_s2_2), dot_ = dot__c + dot__d,
      dot__right = dot_ - dot__c,
      dot__lo1 = dot__c - (dot_ - dot__right)
          + ksl_product_rest(scaled_s1_2, scaled_s2_2, dot__d, dot__right),
      dot__lo = dot__lo1
          + (dot__c_left_rest + ksl_product_rest(scaled_s1_1, scaled_s2_1, dot__b, dot__c_right));
  const double cross_sum = cross + cross_lo, cross_sum_right = cross_sum - cross,
      dot__sum = dot_ + dot__lo, dot__sum_right = dot__sum - dot_,
      angle = ksl_atan2(cross_sum, dot__sum), angle_size0 = fabs(cross_sum),
      angle_size1 = fabs(dot__sum),
      angle_most = angle_size0 < angle_size1 ? angle_size1 : angle_size0,
      angle_divisor = angle_most == 0.0 ? 1.0 : angle_most, angle_part0 = cross_sum / angle_divisor,
      angle_part1 = dot__sum / angle_divisor,
      angle_cross1 = KSL_MUL(angle_part1, cross - (cross_sum - cross_sum_right)
          + (cross_lo - cross_sum_right)),
      angle_divisor2 = KSL_MUL(angle_divisor, KSL_MUL(angle_part1, angle_part1)
          + KSL_MUL(angle_part0, angle_part0)),
      angle_cross = angle_cross1
          - KSL_MUL(angle_part0, dot_ - (dot__sum - dot__sum_right) + (dot__lo - dot__sum_right));
  const double angle_rounded = angle
          + (ksl_atan2_error(cross_sum, dot__sum, angle) + angle_cross
          / (angle_most == 0.0 ? 1.0 : angle_divisor2)),
      angle_final = angle_rounded == angle_rounded ? angle_rounded : angle;
  return angle_final;
}

/* v1·v2.
   v1, v2: vector.
   3 mul, 11 add, 3 product rest.
   Error <= u |result| + 11 u^2 S, S the sum of the |terms| of the expanded formula; barring
     over- and underflow. */
static inline double ksl_dot_vv_accurate(const ksl_vec3_t *v1, const ksl_vec3_t *v2) {
  const double dot_a = KSL_MUL(v1->x, v2->x), dot_b = KSL_MUL(v1->y, v2->y), dot_c = dot_a + dot_b,
      dot_c_right = dot_c - dot_a, dot_d = KSL_MUL(v1->z, v2->z), dot = dot_c + dot_d,
      dot_right = dot - dot_c,
      dot_c_lo = ksl_product_rest(v1->x, v2->x, dot_a, dot_c - dot_c_right)
          + ksl_product_rest(v1->y, v2->y, dot_b, dot_c_right);
  const double dot_rounded = dot
          + (dot_c - (dot - dot_right) + ksl_product_rest(v1->z, v2->z, dot_d, dot_right)
          + dot_c_lo);
  return dot_rounded;
}

/* vo = k (-v).
   k: number; v, vo: vector.
   3 mul, 3 add, 3 product error, 6 neg.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_product_avinv_accurate(const double k, const ksl_vec3_t *v, ksl_vec3_t *vo) {
  const double vo_0 = -KSL_MUL(k, v->x), vo_1 = -KSL_MUL(k, v->y), vo_2 = -KSL_MUL(k, v->z);
  const double vo_0_rounded = vo_0 + ksl_product_error(-k, v->x, vo_0),
      vo_1_rounded = vo_1 + ksl_product_error(-k, v->y, vo_1),
      vo_2_rounded = vo_2 + ksl_product_error(-k, v->z, vo_2);
  vo->x = vo_0_rounded;
  vo->y = vo_1_rounded;
  vo->z = vo_2_rounded;
}

/* vo = v / k.
   k: number; v, vo: vector.
   3 mul, 9 add, 3 product error, 6 div, 3 equal, 3 select. */
static inline void ksl_product_ainvv_accurate(const double k, const ksl_vec3_t *v, ksl_vec3_t *vo) {
  const double vo_0 = v->x / k, vo_0_product = KSL_MUL(vo_0, k);
  const double vo_1 = v->y / k, vo_1_product = KSL_MUL(vo_1, k);
  const double vo_2 = v->z / k, vo_2_product = KSL_MUL(vo_2, k);
  const double vo_0_rounded = vo_0
          + (v->x - vo_0_product - ksl_product_error(vo_0, k, vo_0_product)) / k;
  const double vo_1_rounded = vo_1
          + (v->y - vo_1_product - ksl_product_error(vo_1, k, vo_1_product)) / k;
  const double vo_2_rounded = vo_2
          + (v->z - vo_2_product - ksl_product_error(vo_2, k, vo_2_product)) / k;
  const double vo_0_final = vo_0_rounded == vo_0_rounded ? vo_0_rounded : vo_0;
  const double vo_1_final = vo_1_rounded == vo_1_rounded ? vo_1_rounded : vo_1;
  const double vo_2_final = vo_2_rounded == vo_2_rounded ? vo_2_rounded : vo_2;
  vo->x = vo_0_final;
  vo->y = vo_1_final;
  vo->z = vo_2_final;
}

/* vo = v1 × v2.  Exactly zero for v1 = v2, unless products overflow.
   v1, v2, vo: vector.
   6 mul, 15 add, 6 product rest.
   Error <= u |result| + 6 u^2 S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_cross_vv_accurate(const ksl_vec3_t *v1, const ksl_vec3_t *v2,
    ksl_vec3_t *vo) {
  const double vo_0a = KSL_MUL(v1->y, v2->z), vo_0b = KSL_MUL(v1->z, v2->y), vo_0 = vo_0a - vo_0b,
      vo_0_right = vo_0a - vo_0;
  const double vo_1a = KSL_MUL(v1->z, v2->x), vo_1b = KSL_MUL(v1->x, v2->z), vo_1 = vo_1a - vo_1b,
      vo_1_right = vo_1a - vo_1;
  const double vo_2a = KSL_MUL(v1->x, v2->y), vo_2b = KSL_MUL(v1->y, v2->x), vo_2 = vo_2a - vo_2b,
      vo_2_right = vo_2a - vo_2;
  const double vo_0_rounded = vo_0
          + (ksl_product_rest(v1->y, v2->z, vo_0a, vo_0 + vo_0_right)
          - ksl_product_rest(v1->z, v2->y, vo_0b, vo_0_right)),
      vo_1_rounded = vo_1
          + (ksl_product_rest(v1->z, v2->x, vo_1a, vo_1 + vo_1_right)
          - ksl_product_rest(v1->x, v2->z, vo_1b, vo_1_right)),
      vo_2_rounded = vo_2
          + (ksl_product_rest(v1->x, v2->y, vo_2a, vo_2 + vo_2_right)
          - ksl_product_rest(v1->y, v2->x, vo_2b, vo_2_right));
  vo->x = vo_0_rounded;
  vo->y = vo_1_rounded;
  vo->z = vo_2_rounded;
}

/* vo = v1 × (-v2).
   v1, v2, vo: vector.
   6 mul, 15 add, 6 product rest.
   Error <= u |result| + 6 u^2 S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_cross_vvinv_accurate(const ksl_vec3_t *v1, const ksl_vec3_t *v2,
    ksl_vec3_t *vo) {
  const double vo_0a = KSL_MUL(v1->z, v2->y), vo_0b = KSL_MUL(v1->y, v2->z), vo_0 = vo_0a - vo_0b,
      vo_0_right = vo_0a - vo_0;
  const double vo_1a = KSL_MUL(v1->x, v2->z), vo_1b = KSL_MUL(v1->z, v2->x), vo_1 = vo_1a - vo_1b,
      vo_1_right = vo_1a - vo_1;
  const double vo_2a = KSL_MUL(v1->y, v2->x), vo_2b = KSL_MUL(v1->x, v2->y), vo_2 = vo_2a - vo_2b,
      vo_2_right = vo_2a - vo_2;
  const double vo_0_rounded = vo_0
          + (ksl_product_rest(v1->z, v2->y, vo_0a, vo_0 + vo_0_right)
          - ksl_product_rest(v1->y, v2->z, vo_0b, vo_0_right)),
      vo_1_rounded = vo_1
          + (ksl_product_rest(v1->x, v2->z, vo_1a, vo_1 + vo_1_right)
          - ksl_product_rest(v1->z, v2->x, vo_1b, vo_1_right)),
      vo_2_rounded = vo_2
          + (ksl_product_rest(v1->y, v2->x, vo_2a, vo_2 + vo_2_right)
          - ksl_product_rest(v1->x, v2->y, vo_2b, vo_2_right));
  vo->x = vo_0_rounded;
  vo->y = vo_1_rounded;
  vo->z = vo_2_rounded;
}

/* vo = v + k e_x.
   v, vo: vector; k: number.
   7 add.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_add_vvx_accurate(const ksl_vec3_t *v, const double k, ksl_vec3_t *vo) {
  const double vo_0 = v->x + k, vo_0_right = vo_0 - v->x;
  const double vo_0_rounded = vo_0 + (v->x - (vo_0 - vo_0_right) + (k - vo_0_right));
  const double v_y = v->y;
  const double v_z = v->z;
  vo->x = vo_0_rounded;
  vo->y = v_y;
  vo->z = v_z;
}

/* vo = v - k e_x.
   v, vo: vector; k: number.
   7 add.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_add_vvxinv_accurate(const ksl_vec3_t *v, const double k, ksl_vec3_t *vo) {
  const double vo_0 = v->x - k, vo_0_right = v->x - vo_0;
  const double vo_0_rounded = vo_0 + (v->x - (vo_0 + vo_0_right) - (k - vo_0_right));
  const double v_y = v->y;
  const double v_z = v->z;
  vo->x = vo_0_rounded;
  vo->y = v_y;
  vo->z = v_z;
}

/* vo = v + k e_y.
   v, vo: vector; k: number.
   7 add.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_add_vvy_accurate(const ksl_vec3_t *v, const double k, ksl_vec3_t *vo) {
  const double vo_1 = v->y + k, vo_1_right = vo_1 - v->y;
  const double vo_1_rounded = vo_1 + (v->y - (vo_1 - vo_1_right) + (k - vo_1_right));
  const double v_x = v->x;
  const double v_z = v->z;
  vo->x = v_x;
  vo->y = vo_1_rounded;
  vo->z = v_z;
}

/* vo = v - k e_y.
   v, vo: vector; k: number.
   7 add.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_add_vvyinv_accurate(const ksl_vec3_t *v, const double k, ksl_vec3_t *vo) {
  const double vo_1 = v->y - k, vo_1_right = v->y - vo_1;
  const double vo_1_rounded = vo_1 + (v->y - (vo_1 + vo_1_right) - (k - vo_1_right));
  const double v_x = v->x;
  const double v_z = v->z;
  vo->x = v_x;
  vo->y = vo_1_rounded;
  vo->z = v_z;
}

/* vo = v + k e_z.
   v, vo: vector; k: number.
   7 add.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_add_vvz_accurate(const ksl_vec3_t *v, const double k, ksl_vec3_t *vo) {
  const double vo_2 = v->z + k, vo_2_right = vo_2 - v->z;
  const double vo_2_rounded = vo_2 + (v->z - (vo_2 - vo_2_right) + (k - vo_2_right));
  const double v_x = v->x;
  const double v_y = v->y;
  vo->x = v_x;
  vo->y = v_y;
  vo->z = vo_2_rounded;
}

/* vo = v - k e_z.
   v, vo: vector; k: number.
   7 add.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_add_vvzinv_accurate(const ksl_vec3_t *v, const double k, ksl_vec3_t *vo) {
  const double vo_2 = v->z - k, vo_2_right = v->z - vo_2;
  const double vo_2_rounded = vo_2 + (v->z - (vo_2 + vo_2_right) - (k - vo_2_right));
  const double v_x = v->x;
  const double v_y = v->y;
  vo->x = v_x;
  vo->y = v_y;
  vo->z = vo_2_rounded;
}

/* self = a self.
   self: vector; a: number.
   3 mul.
   Error <= u |result| + 1/32 u^2 S, S the sum of the |terms| of the expanded formula; barring
     over- and underflow. */
static inline void ksl_vec3f_scale_accurate(ksl_vec3f_t *self, const float a) {
  const double self_0_new = (double)self->x * (double)a, self_1_new = (double)self->y * (double)a,
      self_2_new = (double)self->z * (double)a;
  self->x = (float)self_0_new;
  self->y = (float)self_1_new;
  self->z = (float)self_2_new;
}

/* y = a x + y.
   a: number; x, y: vector.
   3 mul, 3 add.
   Error <= u |result| + 1/16 u^2 S, S the sum of the |terms| of the expanded formula; barring
     over- and underflow. */
static inline void ksl_axpy_vvf_accurate(const float a, const ksl_vec3f_t *x, ksl_vec3f_t *y) {
  const double y_0_new = ksl_product_sum((double)a, (double)x->x, (double)y->x),
      y_1_new = ksl_product_sum((double)a, (double)x->y, (double)y->y),
      y_2_new = ksl_product_sum((double)a, (double)x->z, (double)y->z);
  y->x = (float)y_0_new;
  y->y = (float)y_1_new;
  y->z = (float)y_2_new;
}

/* y = x + y.
   x, y: vector.
   3 add.
   Error <= u |result| + 1/32 u^2 S, S the sum of the |terms| of the expanded formula; barring
     over- and underflow. */
static inline void ksl_xpy_vvf_accurate(const ksl_vec3f_t *x, ksl_vec3f_t *y) {
  const double y_0_new = (double)x->x + (double)y->x, y_1_new = (double)x->y + (double)y->y,
      y_2_new = (double)x->z + (double)y->z;
  y->x = (float)y_0_new;
  y->y = (float)y_1_new;
  y->z = (float)y_2_new;
}

/* y = -x + y.
   x, y: vector.
   3 add.
   Error <= u |result| + 1/32 u^2 S, S the sum of the |terms| of the expanded formula; barring
     over- and underflow. */
static inline void ksl_nxpy_vvf_accurate(const ksl_vec3f_t *x, ksl_vec3f_t *y) {
  const double y_0_new = (double)y->x - (double)x->x, y_1_new = (double)y->y - (double)x->y,
      y_2_new = (double)y->z - (double)x->z;
  y->x = (float)y_0_new;
  y->y = (float)y_1_new;
  y->z = (float)y_2_new;
}

/* vo = a vi.
   a: number; vi, vo: vector.
   3 mul.
   Error <= u |result| + 1/32 u^2 S, S the sum of the |terms| of the expanded formula; barring
     over- and underflow. */
static inline void ksl_product_avf_accurate(const float a, const ksl_vec3f_t *vi, ksl_vec3f_t *vo) {
  const double vo_0 = (double)a * (double)vi->x, vo_1 = (double)a * (double)vi->y,
      vo_2 = (double)a * (double)vi->z;
  vo->x = (float)vo_0;
  vo->y = (float)vo_1;
  vo->z = (float)vo_2;
}

/* vo = v1 + v2.
   v1, v2, vo: vector.
   3 add.
   Error <= u |result| + 1/32 u^2 S, S the sum of the |terms| of the expanded formula; barring
     over- and underflow. */
static inline void ksl_add_vvf_accurate(const ksl_vec3f_t *v1, const ksl_vec3f_t *v2,
    ksl_vec3f_t *vo) {
  const double vo_0 = (double)v1->x + (double)v2->x, vo_1 = (double)v1->y + (double)v2->y,
      vo_2 = (double)v1->z + (double)v2->z;
  vo->x = (float)vo_0;
  vo->y = (float)vo_1;
  vo->z = (float)vo_2;
}

/* vo = v1 - v2.
   v1, v2, vo: vector.
   3 add.
   Error <= u |result| + 1/32 u^2 S, S the sum of the |terms| of the expanded formula; barring
     over- and underflow. */
static inline void ksl_subtract_vvf_accurate(const ksl_vec3f_t *v1, const ksl_vec3f_t *v2,
    ksl_vec3f_t *vo) {
  const double vo_0 = (double)v1->x - (double)v2->x, vo_1 = (double)v1->y - (double)v2->y,
      vo_2 = (double)v1->z - (double)v2->z;
  vo->x = (float)vo_0;
  vo->y = (float)vo_1;
  vo->z = (float)vo_2;
}

/* vo = k v.
   v, vo: vector; k: number.
   3 mul.
   Error <= u |result| + 1/32 u^2 S, S the sum of the |terms| of the expanded formula; barring
     over- and underflow. */
static inline void ksl_vec3f_scaled_accurate(const ksl_vec3f_t *v, const float k, ksl_vec3f_t *vo) {
  const double vo_0 = (double)v->x * (double)k, vo_1 = (double)v->y * (double)k,
      vo_2 = (double)v->z * (double)k;
  vo->x = (float)vo_0;
  vo->y = (float)vo_1;
  vo->z = (float)vo_2;
}

/* |v| = sqrt(v·v).
   v: vector.
   7 mul, 2 add, 1 sqrt, 3 abs, 8 less, 8 select. */
static inline float ksl_vec3f_l2norm_accurate(const ksl_vec3f_t *v) {
  const double s_size_0 = fabs((double)v->x), s_size_1 = fabs((double)v->y),
      s_size_2 = fabs((double)v->z);
  const double s_largest1 = s_size_0 < s_size_1 ? s_size_1 : s_size_0;
  const double s_largest2 = s_largest1 < s_size_2 ? s_size_2 : s_largest1;
  const double s_b = 4.611686018427388e+18 < s_largest2 ? 2.710505431213761e-20 : 1.0,
      s_d = s_largest2 < 256.0 ? 1.8014398509481984e+16 : s_b,
      s = s_largest2 < 1.4210854715202004e-14 ? 3.2451855365842673e+32 : s_d;
  const double y_0 = KSL_MUL((double)v->x, s), y_1 = KSL_MUL((double)v->y, s),
      y_2 = KSL_MUL((double)v->z, s);
  const double n = sqrt(KSL_MUL(y_0, y_0) + KSL_MUL(y_1, y_1) + KSL_MUL(y_2, y_2));
  const double r_b = s < 1.0 ? 3.6893488147419103e+19 : 1.0,
      r_d = 1.0 < s ? 5.551115123125783e-17 : r_b,
      r = 1.8014398509481984e+16 < s ? 3.0814879110195774e-33 : r_d;
  const double norm = KSL_MUL(n, r);
  return (float)norm;
}

/* self = self / |self|; the zero vector stays zero.
   self: vector.
   12 mul, 2 add, 3 div, 1 sqrt, 3 abs, 7 less, 1 equal, 8 select. */
static inline void ksl_vec3f_normalize_accurate(ksl_vec3f_t *self) {
  const double s_size_0 = fabs((double)self->x), s_size_1 = fabs((double)self->y),
      s_size_2 = fabs((double)self->z);
  const double s_largest1 = s_size_0 < s_size_1 ? s_size_1 : s_size_0;
  const double s_largest2 = s_largest1 < s_size_2 ? s_size_2 : s_largest1;
  const double s_b = 4.611686018427388e+18 < s_largest2 ? 2.710505431213761e-20 : 1.0,
      s_d = s_largest2 < 256.0 ? 1.8014398509481984e+16 : s_b,
      s = s_largest2 < 1.4210854715202004e-14 ? 3.2451855365842673e+32 : s_d;
  const double y_0 = KSL_MUL((double)self->x, s), y_1 = KSL_MUL((double)self->y, s),
      y_2 = KSL_MUL((double)self->z, s);
  const double up = 1.0 < s ? s : 1.0;
  const double down = s < 1.0 ? s : 1.0;
  const double n = sqrt(KSL_MUL(y_0, y_0) + KSL_MUL(y_1, y_1) + KSL_MUL(y_2, y_2));
  const double divisor = n == 0.0 ? up : n;
  const double sized_0 = KSL_MUL((double)self->x, up), sized_1 = KSL_MUL((double)self->y, up),
      sized_2 = KSL_MUL((double)self->z, up);
  const double quotient_0 = sized_0 / divisor, quotient_1 = sized_1 / divisor,
      quotient_2 = sized_2 / divisor;
  const double self_0_new = KSL_MUL(quotient_0, down), self_1_new = KSL_MUL(quotient_1, down),
      self_2_new = KSL_MUL(quotient_2, down);
  self->x = (float)self_0_new;
  self->y = (float)self_1_new;
  self->z = (float)self_2_new;
}

/* vo = v / |v|; the zero vector stays zero.
   v, vo: vector.
   12 mul, 2 add, 3 div, 1 sqrt, 3 abs, 7 less, 1 equal, 8 select. */
static inline void ksl_vec3f_normalized_accurate(const ksl_vec3f_t *v, ksl_vec3f_t *vo) {
  const double s_size_0 = fabs((double)v->x), s_size_1 = fabs((double)v->y),
      s_size_2 = fabs((double)v->z);
  const double s_largest1 = s_size_0 < s_size_1 ? s_size_1 : s_size_0;
  const double s_largest2 = s_largest1 < s_size_2 ? s_size_2 : s_largest1;
  const double s_b = 4.611686018427388e+18 < s_largest2 ? 2.710505431213761e-20 : 1.0,
      s_d = s_largest2 < 256.0 ? 1.8014398509481984e+16 : s_b,
      s = s_largest2 < 1.4210854715202004e-14 ? 3.2451855365842673e+32 : s_d;
  const double y_0 = KSL_MUL((double)v->x, s), y_1 = KSL_MUL((double)v->y, s),
      y_2 = KSL_MUL((double)v->z, s);
  const double up = 1.0 < s ? s : 1.0;
  const double down = s < 1.0 ? s : 1.0;
  const double n = sqrt(KSL_MUL(y_0, y_0) + KSL_MUL(y_1, y_1) + KSL_MUL(y_2, y_2));
  const double divisor = n == 0.0 ? up : n;
  const double sized_0 = KSL_MUL((double)v->x, up), sized_1 = KSL_MUL((double)v->y, up),
      sized_2 = KSL_MUL((double)v->z, up);
  const double quotient_0 = sized_0 / divisor, quotient_1 = sized_1 / divisor,
      quotient_2 = sized_2 / divisor;
  const double vo_0 = KSL_MUL(quotient_0, down), vo_1 = KSL_MUL(quotient_1, down),
      vo_2 = KSL_MUL(quotient_2, down);
  vo->x = (float)vo_0;
  vo->y = (float)vo_1;
  vo->z = (float)vo_2;
}

/* angle = atan2(|v1 × v2|, v1·v2), in [0, π].
   v1, v2: vector.
   51 mul, 42 add, 1 div, 1 sqrt, 1 neg, 11 abs, 2 copysign, 24 less, 1 equal, 32 select.
   Each component is within 1 ulp as long as its condition is below 1e13; in single precision it
     is the nearest number, except near ties, as long as that is below 1e5; searched, not proved. */
static inline float ksl_angle_vvf_accurate(const ksl_vec3f_t *v1, const ksl_vec3f_t *v2) {
  const double s1_size_0 = fabs((double)v1->x), s1_size_1 = fabs((double)v1->y),
      s1_size_2 = fabs((double)v1->z);
  const double s1_largest1 = s1_size_0 < s1_size_1 ? s1_size_1 : s1_size_0;
  const double s1_largest2 = s1_largest1 < s1_size_2 ? s1_size_2 : s1_largest1;
  const double s1b = 4.611686018427388e+18 < s1_largest2 ? 2.710505431213761e-20 : 1.0,
      s1d = s1_largest2 < 256.0 ? 1.8014398509481984e+16 : s1b,
      s1 = s1_largest2 < 1.4210854715202004e-14 ? 3.2451855365842673e+32 : s1d;
  const double scaled_s1_0 = KSL_MUL((double)v1->x, s1), scaled_s1_1 = KSL_MUL((double)v1->y, s1),
      scaled_s1_2 = KSL_MUL((double)v1->z, s1);
  const double s2_size_0 = fabs((double)v2->x), s2_size_1 = fabs((double)v2->y),
      s2_size_2 = fabs((double)v2->z);
  const double s2_largest1 = s2_size_0 < s2_size_1 ? s2_size_1 : s2_size_0;
  const double s2_largest2 = s2_largest1 < s2_size_2 ? s2_size_2 : s2_largest1;
  const double s2b = 4.611686018427388e+18 < s2_largest2 ? 2.710505431213761e-20 : 1.0,
      s2d = s2_largest2 < 256.0 ? 1.8014398509481984e+16 : s2b,
      s2 = s2_largest2 < 1.4210854715202004e-14 ? 3.2451855365842673e+32 : s2d;
  const double scaled_s2_0 = KSL_MUL((double)v2->x, s2), scaled_s2_1 = KSL_MUL((double)v2->y, s2),
      scaled_s2_2 = KSL_MUL((double)v2->z, s2);
  const double c_0 = KSL_MUL(scaled_s1_1, scaled_s2_2) - KSL_MUL(scaled_s1_2, scaled_s2_1),
      c_1 = KSL_MUL(scaled_s1_2, scaled_s2_0) - KSL_MUL(scaled_s1_0, scaled_s2_2),
      c_2 = KSL_MUL(scaled_s1_0, scaled_s2_1) - KSL_MUL(scaled_s1_1, scaled_s2_0);
  const double s_size_0 = fabs(c_0), s_size_1 = fabs(c_1), s_size_2 = fabs(c_2);
  const double s_largest1 = s_size_0 < s_size_1 ? s_size_1 : s_size_0;
  const double s_largest2 = s_largest1 < s_size_2 ? s_size_2 : s_largest1;
  const double s_b = 4.611686018427388e+18 < s_largest2 ? 2.710505431213761e-20 : 1.0,
      s_d = s_largest2 < 256.0 ? 1.8014398509481984e+16 : s_b,
      s = s_largest2 < 1.4210854715202004e-14 ? 3.2451855365842673e+32 : s_d;
  const double y_0 = KSL_MUL(c_0, s), y_1 = KSL_MUL(c_1, s), y_2 = KSL_MUL(c_2, s);
  const double n = sqrt(KSL_MUL(y_0, y_0) + KSL_MUL(y_1, y_1) + KSL_MUL(y_2, y_2));
  const double r_b = s < 1.0 ? 3.6893488147419103e+19 : 1.0,
      r_d = 1.0 < s ? 5.551115123125783e-17 : r_b,
      r = 1.8014398509481984e+16 < s ? 3.0814879110195774e-33 : r_d;
  const double cross = KSL_MUL(n, r);
  const double dot_ = KSL_MUL(scaled_s1_0, scaled_s2_0) + KSL_MUL(scaled_s1_1, scaled_s2_1)
          + KSL_MUL(scaled_s1_2, scaled_s2_2);
  const double angle = ksl_atan2(cross, dot_);
  return (float)angle;
}

/* v1·v2.
   v1, v2: vector.
   3 mul, 2 add.
   Error <= u |result| + 3/32 u^2 S, S the sum of the |terms| of the expanded formula; barring
     over- and underflow. */
static inline float ksl_dot_vvf_accurate(const ksl_vec3f_t *v1, const ksl_vec3f_t *v2) {
  const double dot = ksl_product_sum((double)v1->z, (double)v2->z, ksl_product_sum((double)v1->y,
      (double)v2->y, (double)v1->x * (double)v2->x));
  return (float)dot;
}

/* vo = k (-v).
   k: number; v, vo: vector.
   3 mul, 3 neg.
   Error <= u |result| + 1/32 u^2 S, S the sum of the |terms| of the expanded formula; barring
     over- and underflow. */
static inline void ksl_product_avinvf_accurate(const float k, const ksl_vec3f_t *v,
    ksl_vec3f_t *vo) {
  const double vo_0 = -((double)k * (double)v->x), vo_1 = -((double)k * (double)v->y),
      vo_2 = -((double)k * (double)v->z);
  vo->x = (float)vo_0;
  vo->y = (float)vo_1;
  vo->z = (float)vo_2;
}

/* vo = v / k.
   k: number; v, vo: vector.
   3 div. */
static inline void ksl_product_ainvvf_accurate(const float k, const ksl_vec3f_t *v,
    ksl_vec3f_t *vo) {
  const double vo_0 = (double)v->x / (double)k, vo_1 = (double)v->y / (double)k,
      vo_2 = (double)v->z / (double)k;
  vo->x = (float)vo_0;
  vo->y = (float)vo_1;
  vo->z = (float)vo_2;
}

/* vo = v1 × v2.  Exactly zero for v1 = v2, unless products overflow.
   v1, v2, vo: vector.
   6 mul, 3 add.
   Error <= u |result| + 1/16 u^2 S, S the sum of the |terms| of the expanded formula; barring
     over- and underflow. */
static inline void ksl_cross_vvf_accurate(const ksl_vec3f_t *v1, const ksl_vec3f_t *v2,
    ksl_vec3f_t *vo) {
  const double vo_0 = ksl_product_sum(-(double)v1->z, (double)v2->y, (double)v1->y * (double)v2->z),
      vo_1 = ksl_product_sum(-(double)v1->x, (double)v2->z, (double)v1->z * (double)v2->x),
      vo_2 = ksl_product_sum(-(double)v1->y, (double)v2->x, (double)v1->x * (double)v2->y);
  vo->x = (float)vo_0;
  vo->y = (float)vo_1;
  vo->z = (float)vo_2;
}

/* vo = v1 × (-v2).
   v1, v2, vo: vector.
   6 mul, 3 add.
   Error <= u |result| + 1/16 u^2 S, S the sum of the |terms| of the expanded formula; barring
     over- and underflow. */
static inline void ksl_cross_vvinvf_accurate(const ksl_vec3f_t *v1, const ksl_vec3f_t *v2,
    ksl_vec3f_t *vo) {
  const double vo_0 = ksl_product_sum(-(double)v1->y, (double)v2->z, (double)v1->z * (double)v2->y),
      vo_1 = ksl_product_sum(-(double)v1->z, (double)v2->x, (double)v1->x * (double)v2->z),
      vo_2 = ksl_product_sum(-(double)v1->x, (double)v2->y, (double)v1->y * (double)v2->x);
  vo->x = (float)vo_0;
  vo->y = (float)vo_1;
  vo->z = (float)vo_2;
}

/* vo = v + k e_x.
   v, vo: vector; k: number.
   1 add.
   Error <= u |result| + 1/32 u^2 S, S the sum of the |terms| of the expanded formula; barring
     over- and underflow. */
static inline void ksl_add_vvxf_accurate(const ksl_vec3f_t *v, const float k, ksl_vec3f_t *vo) {
  const double vo_0 = (double)v->x + (double)k;
  const float v_y = v->y;
  const float v_z = v->z;
  vo->x = (float)vo_0;
  vo->y = v_y;
  vo->z = v_z;
}

/* vo = v - k e_x.
   v, vo: vector; k: number.
   1 add.
   Error <= u |result| + 1/32 u^2 S, S the sum of the |terms| of the expanded formula; barring
     over- and underflow. */
static inline void ksl_add_vvxinvf_accurate(const ksl_vec3f_t *v, const float k, ksl_vec3f_t *vo) {
  const double vo_0 = (double)v->x - (double)k;
  const float v_y = v->y;
  const float v_z = v->z;
  vo->x = (float)vo_0;
  vo->y = v_y;
  vo->z = v_z;
}

/* vo = v + k e_y.
   v, vo: vector; k: number.
   1 add.
   Error <= u |result| + 1/32 u^2 S, S the sum of the |terms| of the expanded formula; barring
     over- and underflow. */
static inline void ksl_add_vvyf_accurate(const ksl_vec3f_t *v, const float k, ksl_vec3f_t *vo) {
  const double vo_1 = (double)v->y + (double)k;
  const float v_x = v->x;
  const float v_z = v->z;
  vo->x = v_x;
  vo->y = (float)vo_1;
  vo->z = v_z;
}

/* vo = v - k e_y.
   v, vo: vector; k: number.
   1 add.
   Error <= u |result| + 1/32 u^2 S, S the sum of the |terms| of the expanded formula; barring
     over- and underflow. */
static inline void ksl_add_vvyinvf_accurate(const ksl_vec3f_t *v, const float k, ksl_vec3f_t *vo) {
  const double vo_1 = (double)v->y - (double)k;
  const float v_x = v->x;
  const float v_z = v->z;
  vo->x = v_x;
  vo->y = (float)vo_1;
  vo->z = v_z;
}

/* vo = v + k e_z.
   v, vo: vector; k: number.
   1 add.
   Error <= u |result| + 1/32 u^2 S, S the sum of the |terms| of the expanded formula; barring
     over- and underflow. */
static inline void ksl_add_vvzf_accurate(const ksl_vec3f_t *v, const float k, ksl_vec3f_t *vo) {
  const double vo_2 = (double)v->z + (double)k;
  const float v_x = v->x;
  const float v_y = v->y;
  vo->x = v_x;
  vo->y = v_y;
  vo->z = (float)vo_2;
}

/* vo = v - k e_z.
   v, vo: vector; k: number.
   1 add.
   Error <= u |result| + 1/32 u^2 S, S the sum of the |terms| of the expanded formula; barring
     over- and underflow. */
static inline void ksl_add_vvzinvf_accurate(const ksl_vec3f_t *v, const float k, ksl_vec3f_t *vo) {
  const double vo_2 = (double)v->z - (double)k;
  const float v_x = v->x;
  const float v_y = v->y;
  vo->x = v_x;
  vo->y = v_y;
  vo->z = (float)vo_2;
}

#endif
