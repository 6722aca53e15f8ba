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
  const double self_0_new = KSL_MUL(self->x, a);
  const double self_1_new = KSL_MUL(self->y, a);
  const double self_2_new = KSL_MUL(self->z, a);
  const double self_0_new_lo = ksl_product_error(self->x, a, self_0_new),
      self_0_new_rounded = self_0_new + self_0_new_lo;
  const double self_1_new_lo = ksl_product_error(self->y, a, self_1_new),
      self_1_new_rounded = self_1_new + self_1_new_lo;
  const double self_2_new_lo = ksl_product_error(self->z, a, self_2_new),
      self_2_new_rounded = self_2_new + self_2_new_lo;
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
  const double y_0_new_rounded = y_0_new + y_0_new_lo;
  const double y_1_new_rounded = y_1_new + y_1_new_lo;
  const double y_2_new_rounded = y_2_new + y_2_new_lo;
  y->x = y_0_new_rounded;
  y->y = y_1_new_rounded;
  y->z = y_2_new_rounded;
}

/* y = x + y.
   x, y: vector.
   21 add.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_xpy_vv_accurate(const ksl_vec3_t *x, ksl_vec3_t *y) {
  const double y_0_new = x->x + y->x, y_0_new_right = y_0_new - x->x,
      y_0_new_left = y_0_new - y_0_new_right, y_0_new_left_rest = x->x - y_0_new_left,
      y_0_new_right_rest = y->x - y_0_new_right,
      y_0_new_lo = y_0_new_left_rest + y_0_new_right_rest;
  const double y_1_new = x->y + y->y, y_1_new_right = y_1_new - x->y,
      y_1_new_left = y_1_new - y_1_new_right, y_1_new_left_rest = x->y - y_1_new_left,
      y_1_new_right_rest = y->y - y_1_new_right,
      y_1_new_lo = y_1_new_left_rest + y_1_new_right_rest;
  const double y_2_new = x->z + y->z, y_2_new_right = y_2_new - x->z,
      y_2_new_left = y_2_new - y_2_new_right, y_2_new_left_rest = x->z - y_2_new_left,
      y_2_new_right_rest = y->z - y_2_new_right,
      y_2_new_lo = y_2_new_left_rest + y_2_new_right_rest;
  const double y_0_new_rounded = y_0_new + y_0_new_lo;
  const double y_1_new_rounded = y_1_new + y_1_new_lo;
  const double y_2_new_rounded = y_2_new + y_2_new_lo;
  y->x = y_0_new_rounded;
  y->y = y_1_new_rounded;
  y->z = y_2_new_rounded;
}

/* y = -x + y.
   x, y: vector.
   21 add.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_nxpy_vv_accurate(const ksl_vec3_t *x, ksl_vec3_t *y) {
  const double y_0_new = y->x - x->x, y_0_new_right = y->x - y_0_new,
      y_0_new_left = y_0_new + y_0_new_right, y_0_new_left_rest = y->x - y_0_new_left,
      y_0_new_right_rest = x->x - y_0_new_right,
      y_0_new_lo = y_0_new_left_rest - y_0_new_right_rest;
  const double y_1_new = y->y - x->y, y_1_new_right = y->y - y_1_new,
      y_1_new_left = y_1_new + y_1_new_right, y_1_new_left_rest = y->y - y_1_new_left,
      y_1_new_right_rest = x->y - y_1_new_right,
      y_1_new_lo = y_1_new_left_rest - y_1_new_right_rest;
  const double y_2_new = y->z - x->z, y_2_new_right = y->z - y_2_new,
      y_2_new_left = y_2_new + y_2_new_right, y_2_new_left_rest = y->z - y_2_new_left,
      y_2_new_right_rest = x->z - y_2_new_right,
      y_2_new_lo = y_2_new_left_rest - y_2_new_right_rest;
  const double y_0_new_rounded = y_0_new + y_0_new_lo;
  const double y_1_new_rounded = y_1_new + y_1_new_lo;
  const double y_2_new_rounded = y_2_new + y_2_new_lo;
  y->x = y_0_new_rounded;
  y->y = y_1_new_rounded;
  y->z = y_2_new_rounded;
}

/* vo = a vi.
   a: number; vi, vo: vector.
   3 mul, 3 add, 3 product error.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_product_av_accurate(const double a, const ksl_vec3_t *vi, ksl_vec3_t *vo) {
  const double vo_0 = KSL_MUL(a, vi->x);
  const double vo_1 = KSL_MUL(a, vi->y);
  const double vo_2 = KSL_MUL(a, vi->z);
  const double vo_0_lo = ksl_product_error(a, vi->x, vo_0), vo_0_rounded = vo_0 + vo_0_lo;
  const double vo_1_lo = ksl_product_error(a, vi->y, vo_1), vo_1_rounded = vo_1 + vo_1_lo;
  const double vo_2_lo = ksl_product_error(a, vi->z, vo_2), vo_2_rounded = vo_2 + vo_2_lo;
  vo->x = vo_0_rounded;
  vo->y = vo_1_rounded;
  vo->z = vo_2_rounded;
}

/* vo = v1 + v2.
   v1, v2, vo: vector.
   21 add.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_add_vv_accurate(const ksl_vec3_t *v1, const ksl_vec3_t *v2, ksl_vec3_t *vo) {
  const double vo_0 = v1->x + v2->x, vo_0_right = vo_0 - v1->x, vo_0_left = vo_0 - vo_0_right,
      vo_0_left_rest = v1->x - vo_0_left, vo_0_right_rest = v2->x - vo_0_right,
      vo_0_lo = vo_0_left_rest + vo_0_right_rest;
  const double vo_1 = v1->y + v2->y, vo_1_right = vo_1 - v1->y, vo_1_left = vo_1 - vo_1_right,
      vo_1_left_rest = v1->y - vo_1_left, vo_1_right_rest = v2->y - vo_1_right,
      vo_1_lo = vo_1_left_rest + vo_1_right_rest;
  const double vo_2 = v1->z + v2->z, vo_2_right = vo_2 - v1->z, vo_2_left = vo_2 - vo_2_right,
      vo_2_left_rest = v1->z - vo_2_left, vo_2_right_rest = v2->z - vo_2_right,
      vo_2_lo = vo_2_left_rest + vo_2_right_rest;
  const double vo_0_rounded = vo_0 + vo_0_lo;
  const double vo_1_rounded = vo_1 + vo_1_lo;
  const double vo_2_rounded = vo_2 + vo_2_lo;
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
  const double vo_0 = v1->x - v2->x, vo_0_right = v1->x - vo_0, vo_0_left = vo_0 + vo_0_right,
      vo_0_left_rest = v1->x - vo_0_left, vo_0_right_rest = v2->x - vo_0_right,
      vo_0_lo = vo_0_left_rest - vo_0_right_rest;
  const double vo_1 = v1->y - v2->y, vo_1_right = v1->y - vo_1, vo_1_left = vo_1 + vo_1_right,
      vo_1_left_rest = v1->y - vo_1_left, vo_1_right_rest = v2->y - vo_1_right,
      vo_1_lo = vo_1_left_rest - vo_1_right_rest;
  const double vo_2 = v1->z - v2->z, vo_2_right = v1->z - vo_2, vo_2_left = vo_2 + vo_2_right,
      vo_2_left_rest = v1->z - vo_2_left, vo_2_right_rest = v2->z - vo_2_right,
      vo_2_lo = vo_2_left_rest - vo_2_right_rest;
  const double vo_0_rounded = vo_0 + vo_0_lo;
  const double vo_1_rounded = vo_1 + vo_1_lo;
  const double vo_2_rounded = vo_2 + vo_2_lo;
  vo->x = vo_0_rounded;
  vo->y = vo_1_rounded;
  vo->z = vo_2_rounded;
}

/* vo = k v.
   v, vo: vector; k: number.
   3 mul, 3 add, 3 product error.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_vec3_scaled_accurate(const ksl_vec3_t *v, const double k, ksl_vec3_t *vo) {
  const double vo_0 = KSL_MUL(v->x, k);
  const double vo_1 = KSL_MUL(v->y, k);
  const double vo_2 = KSL_MUL(v->z, k);
  const double vo_0_lo = ksl_product_error(v->x, k, vo_0), vo_0_rounded = vo_0 + vo_0_lo;
  const double vo_1_lo = ksl_product_error(v->y, k, vo_1), vo_1_rounded = vo_1 + vo_1_lo;
  const double vo_2_lo = ksl_product_error(v->z, k, vo_2), vo_2_rounded = vo_2 + vo_2_lo;
  vo->x = vo_0_rounded;
  vo->y = vo_1_rounded;
  vo->z = vo_2_rounded;
}

/* |v| = sqrt(v·v).
   v: vector.
   10 mul, 29 add, 1 product error, 3 product rest, 2 div, 1 sqrt, 3 abs, 8 less, 2 equal, 10
     select. */
static inline double ksl_vec3_l2norm_accurate(const ksl_vec3_t *v) {
  const double s_size_0 = fabs(v->x);
  const double s_size_1 = fabs(v->y);
  const double s_size_2 = fabs(v->z);
  const double s_largest1 = s_size_0 < s_size_1 ? s_size_1 : s_size_0;
  const double s_largest2 = s_largest1 < s_size_2 ? s_size_2 : s_largest1;
  const double s_b = 6.703903964971299e+153 < s_largest2 ? 3.7291703656001034e-155 : 1.0,
      s_d = s_largest2 < 256.0 ? 1.3093562431584567e+151 : s_b,
      s = s_largest2 < 1.955159272639747e-149 ? 1.0715086071862673e+301 : s_d;
  const double y_0 = KSL_MUL(v->x, s);
  const double y_1 = KSL_MUL(v->y, s);
  const double y_2 = KSL_MUL(v->z, s);
  const double n_a = KSL_MUL(y_0, y_0), n_b = KSL_MUL(y_1, y_1), n_c = n_a + n_b,
      n_c_right = n_c - n_a, n_c_left = n_c - n_c_right,
      n_c_left_rest = ksl_product_rest(y_0, y_0, n_a, n_c_left),
      n_c_right_rest = ksl_product_rest(y_1, y_1, n_b, n_c_right),
      n_c_lo = n_c_left_rest + n_c_right_rest, n_d = KSL_MUL(y_2, y_2), n_e = n_c + n_d,
      n_e_right = n_e - n_c, n_e_left = n_e - n_e_right, n_e_left_rest = n_c - n_e_left,
      n_e_right_rest = ksl_product_rest(y_2, y_2, n_d, n_e_right),
      n_e_lo1 = n_e_left_rest + n_e_right_rest, n_e_lo = n_e_lo1 + n_c_lo, n_of_n_e = n_e + n_e_lo,
      n_of_n_e_right = n_of_n_e - n_e, n_of_n_e_left = n_of_n_e - n_of_n_e_right,
      n_of_n_e_left_rest = n_e - n_of_n_e_left, n_of_n_e_right_rest = n_e_lo - n_of_n_e_right,
      n_of_n_e_lo = n_of_n_e_left_rest + n_of_n_e_right_rest, n = sqrt(n_of_n_e),
      n_product = KSL_MUL(n, n), n_product_error = ksl_product_error(n, n, n_product),
      n_rest = n_of_n_e - n_product, n_exact = n_rest - n_product_error,
      n_residual = n_exact + n_of_n_e_lo, n_twice = n + n, n_divisor = n == 0.0 ? 1.0 : n_twice,
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

/* self = self / |self|; the zero vector stays zero.
   self: vector.
   25 mul, 68 add, 4 product error, 3 product rest, 8 div, 1 sqrt, 3 abs, 7 less, 5 equal, 13
     select. */
static inline void ksl_vec3_normalize_accurate(ksl_vec3_t *self) {
  const double s_size_0 = fabs(self->x);
  const double s_size_1 = fabs(self->y);
  const double s_size_2 = fabs(self->z);
  const double s_largest1 = s_size_0 < s_size_1 ? s_size_1 : s_size_0;
  const double s_largest2 = s_largest1 < s_size_2 ? s_size_2 : s_largest1;
  const double s_b = 6.703903964971299e+153 < s_largest2 ? 3.7291703656001034e-155 : 1.0,
      s_d = s_largest2 < 256.0 ? 1.3093562431584567e+151 : s_b,
      s = s_largest2 < 1.955159272639747e-149 ? 1.0715086071862673e+301 : s_d;
  const double y_0 = KSL_MUL(self->x, s);
  const double y_1 = KSL_MUL(self->y, s);
  const double y_2 = KSL_MUL(self->z, s);
  const double up = 1.0 < s ? s : 1.0;
  const double down = s < 1.0 ? s : 1.0;
  const double n_a = KSL_MUL(y_0, y_0), n_b = KSL_MUL(y_1, y_1), n_c = n_a + n_b,
      n_c_right = n_c - n_a, n_c_left = n_c - n_c_right,
      n_c_left_rest = ksl_product_rest(y_0, y_0, n_a, n_c_left),
      n_c_right_rest = ksl_product_rest(y_1, y_1, n_b, n_c_right),
      n_c_lo = n_c_left_rest + n_c_right_rest, n_d = KSL_MUL(y_2, y_2), n_e = n_c + n_d,
      n_e_right = n_e - n_c, n_e_left = n_e - n_e_right, n_e_left_rest = n_c - n_e_left,
      n_e_right_rest = ksl_product_rest(y_2, y_2, n_d, n_e_right),
      n_e_lo1 = n_e_left_rest + n_e_right_rest, n_e_lo = n_e_lo1 + n_c_lo, n_of_n_e = n_e + n_e_lo,
      n_of_n_e_right = n_of_n_e - n_e, n_of_n_e_left = n_of_n_e - n_of_n_e_right,
      n_of_n_e_left_rest = n_e - n_of_n_e_left, n_of_n_e_right_rest = n_e_lo - n_of_n_e_right,
      n_of_n_e_lo = n_of_n_e_left_rest + n_of_n_e_right_rest, n = sqrt(n_of_n_e),
      n_product = KSL_MUL(n, n), n_product_error = ksl_product_error(n, n, n_product),
      n_rest = n_of_n_e - n_product, n_exact = n_rest - n_product_error,
      n_residual = n_exact + n_of_n_e_lo, n_twice = n + n, n_divisor = n == 0.0 ? 1.0 : n_twice,
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
  const double self_0_new_rounded = self_0_new + self_0_new_lo,
      self_0_new_final = self_0_new_rounded == self_0_new_rounded ? self_0_new_rounded : self_0_new;
  const double self_1_new_rounded = self_1_new + self_1_new_lo,
      self_1_new_final = self_1_new_rounded == self_1_new_rounded ? self_1_new_rounded : self_1_new;
  const double self_2_new_rounded = self_2_new + self_2_new_lo,
      self_2_new_final = self_2_new_rounded == self_2_new_rounded ? self_2_new_rounded : self_2_new;
  self->x = self_0_new_final;
  self->y = self_1_new_final;
  self->z = self_2_new_final;
}

/* vo = v / |v|; the zero vector stays zero.
   v, vo: vector.
   25 mul, 68 add, 4 product error, 3 product rest, 8 div, 1 sqrt, 3 abs, 7 less, 5 equal, 13
     select. */
static inline void ksl_vec3_normalized_accurate(const ksl_vec3_t *v, ksl_vec3_t *vo) {
  const double s_size_0 = fabs(v->x);
  const double s_size_1 = fabs(v->y);
  const double s_size_2 = fabs(v->z);
  const double s_largest1 = s_size_0 < s_size_1 ? s_size_1 : s_size_0;
  const double s_largest2 = s_largest1 < s_size_2 ? s_size_2 : s_largest1;
  const double s_b = 6.703903964971299e+153 < s_largest2 ? 3.7291703656001034e-155 : 1.0,
      s_d = s_largest2 < 256.0 ? 1.3093562431584567e+151 : s_b,
      s = s_largest2 < 1.955159272639747e-149 ? 1.0715086071862673e+301 : s_d;
  const double y_0 = KSL_MUL(v->x, s);
  const double y_1 = KSL_MUL(v->y, s);
  const double y_2 = KSL_MUL(v->z, s);
  const double up = 1.0 < s ? s : 1.0;
  const double down = s < 1.0 ? s : 1.0;
  const double n_a = KSL_MUL(y_0, y_0), n_b = KSL_MUL(y_1, y_1), n_c = n_a + n_b,
      n_c_right = n_c - n_a, n_c_left = n_c - n_c_right,
      n_c_left_rest = ksl_product_rest(y_0, y_0, n_a, n_c_left),
      n_c_right_rest = ksl_product_rest(y_1, y_1, n_b, n_c_right),
      n_c_lo = n_c_left_rest + n_c_right_rest, n_d = KSL_MUL(y_2, y_2), n_e = n_c + n_d,
      n_e_right = n_e - n_c, n_e_left = n_e - n_e_right, n_e_left_rest = n_c - n_e_left,
      n_e_right_rest = ksl_product_rest(y_2, y_2, n_d, n_e_right),
      n_e_lo1 = n_e_left_rest + n_e_right_rest, n_e_lo = n_e_lo1 + n_c_lo, n_of_n_e = n_e + n_e_lo,
      n_of_n_e_right = n_of_n_e - n_e, n_of_n_e_left = n_of_n_e - n_of_n_e_right,
      n_of_n_e_left_rest = n_e - n_of_n_e_left, n_of_n_e_right_rest = n_e_lo - n_of_n_e_right,
      n_of_n_e_lo = n_of_n_e_left_rest + n_of_n_e_right_rest, n = sqrt(n_of_n_e),
      n_product = KSL_MUL(n, n), n_product_error = ksl_product_error(n, n, n_product),
      n_rest = n_of_n_e - n_product, n_exact = n_rest - n_product_error,
      n_residual = n_exact + n_of_n_e_lo, n_twice = n + n, n_divisor = n == 0.0 ? 1.0 : n_twice,
      n_lo = n_residual / n_divisor;
  const double divisor_a_of_n = n + n_lo, divisor_a_of_n_right = divisor_a_of_n - n,
      divisor_a_of_n_left = divisor_a_of_n - divisor_a_of_n_right,
      divisor_a_of_n_left_rest = n - divisor_a_of_n_left,
      divisor_a_of_n_right_rest = n_lo - divisor_a_of_n_right,
      divisor_a_of_n_lo = divisor_a_of_n_left_rest + divisor_a_of_n_right_rest,
      divisor = divisor_a_of_n == 0.0 ? up : divisor_a_of_n,
      divisor_lo = divisor_a_of_n == 0.0 ? 0.0 : divisor_a_of_n_lo;
  const double sized_0 = KSL_MUL(v->x, up);
  const double sized_1 = KSL_MUL(v->y, up);
  const double sized_2 = KSL_MUL(v->z, up);
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
  const double vo_0_of_quotient_0 = quotient_0 + quotient_0_lo,
      vo_0_of_quotient_0_right = vo_0_of_quotient_0 - quotient_0,
      vo_0_of_quotient_0_left = vo_0_of_quotient_0 - vo_0_of_quotient_0_right,
      vo_0_of_quotient_0_left_rest = quotient_0 - vo_0_of_quotient_0_left,
      vo_0_of_quotient_0_right_rest = quotient_0_lo - vo_0_of_quotient_0_right,
      vo_0_of_quotient_0_lo = vo_0_of_quotient_0_left_rest + vo_0_of_quotient_0_right_rest,
      vo_0 = KSL_MUL(vo_0_of_quotient_0, down), vo_0_inverse = 1.0 / down,
      vo_0_back = KSL_MUL(vo_0, vo_0_inverse), vo_0_lost = vo_0_of_quotient_0 - vo_0_back,
      vo_0_rest = vo_0_lost + vo_0_of_quotient_0_lo, vo_0_lo = KSL_MUL(vo_0_rest, down);
  const double vo_1_of_quotient_1 = quotient_1 + quotient_1_lo,
      vo_1_of_quotient_1_right = vo_1_of_quotient_1 - quotient_1,
      vo_1_of_quotient_1_left = vo_1_of_quotient_1 - vo_1_of_quotient_1_right,
      vo_1_of_quotient_1_left_rest = quotient_1 - vo_1_of_quotient_1_left,
      vo_1_of_quotient_1_right_rest = quotient_1_lo - vo_1_of_quotient_1_right,
      vo_1_of_quotient_1_lo = vo_1_of_quotient_1_left_rest + vo_1_of_quotient_1_right_rest,
      vo_1 = KSL_MUL(vo_1_of_quotient_1, down), vo_1_back = KSL_MUL(vo_1, vo_0_inverse),
      vo_1_lost = vo_1_of_quotient_1 - vo_1_back, vo_1_rest = vo_1_lost + vo_1_of_quotient_1_lo,
      vo_1_lo = KSL_MUL(vo_1_rest, down);
  const double vo_2_of_quotient_2 = quotient_2 + quotient_2_lo,
      vo_2_of_quotient_2_right = vo_2_of_quotient_2 - quotient_2,
      vo_2_of_quotient_2_left = vo_2_of_quotient_2 - vo_2_of_quotient_2_right,
      vo_2_of_quotient_2_left_rest = quotient_2 - vo_2_of_quotient_2_left,
      vo_2_of_quotient_2_right_rest = quotient_2_lo - vo_2_of_quotient_2_right,
      vo_2_of_quotient_2_lo = vo_2_of_quotient_2_left_rest + vo_2_of_quotient_2_right_rest,
      vo_2 = KSL_MUL(vo_2_of_quotient_2, down), vo_2_back = KSL_MUL(vo_2, vo_0_inverse),
      vo_2_lost = vo_2_of_quotient_2 - vo_2_back, vo_2_rest = vo_2_lost + vo_2_of_quotient_2_lo,
      vo_2_lo = KSL_MUL(vo_2_rest, down);
  const double vo_0_rounded = vo_0 + vo_0_lo,
      vo_0_final = vo_0_rounded == vo_0_rounded ? vo_0_rounded : vo_0;
  const double vo_1_rounded = vo_1 + vo_1_lo,
      vo_1_final = vo_1_rounded == vo_1_rounded ? vo_1_rounded : vo_1;
  const double vo_2_rounded = vo_2 + vo_2_lo,
      vo_2_final = vo_2_rounded == vo_2_rounded ? vo_2_rounded : vo_2;
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
  const double s1_size_0 = fabs(v1->x);
  const double s1_size_1 = fabs(v1->y);
  const double s1_size_2 = fabs(v1->z);
  const double s1_largest1 = s1_size_0 < s1_size_1 ? s1_size_1 : s1_size_0;
  const double s1_largest2 = s1_largest1 < s1_size_2 ? s1_size_2 : s1_largest1;
  const double s1b = 6.703903964971299e+153 < s1_largest2 ? 3.7291703656001034e-155 : 1.0,
      s1d = s1_largest2 < 256.0 ? 1.3093562431584567e+151 : s1b,
      s1 = s1_largest2 < 1.955159272639747e-149 ? 1.0715086071862673e+301 : s1d;
  const double scaled_s1_0 = KSL_MUL(v1->x, s1);
  const double scaled_s1_1 = KSL_MUL(v1->y, s1);
  const double scaled_s1_2 = KSL_MUL(v1->z, s1);
  const double s2_size_0 = fabs(v2->x);
  const double s2_size_1 = fabs(v2->y);
  const double s2_size_2 = fabs(v2->z);
  const double s2_largest1 = s2_size_0 < s2_size_1 ? s2_size_1 : s2_size_0;
  const double s2_largest2 = s2_largest1 < s2_size_2 ? s2_size_2 : s2_largest1;
  const double s2b = 6.703903964971299e+153 < s2_largest2 ? 3.7291703656001034e-155 : 1.0,
      s2d = s2_largest2 < 256.0 ? 1.3093562431584567e+151 : s2b,
      s2 = s2_largest2 < 1.955159272639747e-149 ? 1.0715086071862673e+301 : s2d;
  const double scaled_s2_0 = KSL_MUL(v2->x, s2);
  const double scaled_s2_1 = KSL_MUL(v2->y, s2);
  const double scaled_s2_2 = KSL_MUL(v2->z, s2);
  const double c_0a = KSL_MUL(scaled_s1_1, scaled_s2_2), c_0b = KSL_MUL(scaled_s1_2, scaled_s2_1),
      c_0 = c_0a - c_0b, c_0_right = c_0a - c_0, c_0_left = c_0 + c_0_right,
      c_0_left_rest = ksl_product_rest(scaled_s1_1, scaled_s2_2, c_0a, c_0_left),
      c_0_right_rest = ksl_product_rest(scaled_s1_2, scaled_s2_1, c_0b, c_0_right),
      c_0_lo = c_0_left_rest - c_0_right_rest;
  const double c_1a = KSL_MUL(scaled_s1_2, scaled_s2_0), c_1b = KSL_MUL(scaled_s1_0, scaled_s2_2),
      c_1 = c_1a - c_1b, c_1_right = c_1a - c_1, c_1_left = c_1 + c_1_right,
      c_1_left_rest = ksl_product_rest(scaled_s1_2, scaled_s2_0, c_1a, c_1_left),
      c_1_right_rest = ksl_product_rest(scaled_s1_0, scaled_s2_2, c_1b, c_1_right),
      c_1_lo = c_1_left_rest - c_1_right_rest;
  const double c_2a = KSL_MUL(scaled_s1_0, scaled_s2_1), c_2b = KSL_MUL(scaled_s1_1, scaled_s2_0),
      c_2 = c_2a - c_2b, c_2_right = c_2a - c_2, c_2_left = c_2 + c_2_right,
      c_2_left_rest = ksl_product_rest(scaled_s1_0, scaled_s2_1, c_2a, c_2_left),
      c_2_right_rest = ksl_product_rest(scaled_s1_1, scaled_s2_0, c_2b, c_2_right),
      c_2_lo = c_2_left_rest - c_2_right_rest;
  const double s_size_0_of_c_0 = c_0 + c_0_lo, s_size_0_of_c_0_right = s_size_0_of_c_0 - c_0,
      s_size_0_of_c_0_left = s_size_0_of_c_0 - s_size_0_of_c_0_right,
      s_size_0_of_c_0_left_rest = c_0 - s_size_0_of_c_0_left,
      s_size_0_of_c_0_right_rest = c_0_lo - s_size_0_of_c_0_right,
      s_size_0_of_c_0_lo = s_size_0_of_c_0_left_rest + s_size_0_of_c_0_right_rest,
      s_size_0 = fabs(s_size_0_of_c_0), s_size_0_opposite = -s_size_0_of_c_0_lo,
      s_size_0_lo = s_size_0_of_c_0 < 0.0 ? s_size_0_opposite : s_size_0_of_c_0_lo;
  const double s_size_1_of_c_1 = c_1 + c_1_lo, s_size_1_of_c_1_right = s_size_1_of_c_1 - c_1,
      s_size_1_of_c_1_left = s_size_1_of_c_1 - s_size_1_of_c_1_right,
      s_size_1_of_c_1_left_rest = c_1 - s_size_1_of_c_1_left,
      s_size_1_of_c_1_right_rest = c_1_lo - s_size_1_of_c_1_right,
      s_size_1_of_c_1_lo = s_size_1_of_c_1_left_rest + s_size_1_of_c_1_right_rest,
      s_size_1 = fabs(s_size_1_of_c_1), s_size_1_opposite = -s_size_1_of_c_1_lo,
      s_size_1_lo = s_size_1_of_c_1 < 0.0 ? s_size_1_opposite : s_size_1_of_c_1_lo;
  const double s_size_2_of_c_2 = c_2 + c_2_lo, s_size_2_of_c_2_right = s_size_2_of_c_2 - c_2,
      s_size_2_of_c_2_left = s_size_2_of_c_2 - s_size_2_of_c_2_right,
      s_size_2_of_c_2_left_rest = c_2 - s_size_2_of_c_2_left,
      s_size_2_of_c_2_right_rest = c_2_lo - s_size_2_of_c_2_right,
      s_size_2_of_c_2_lo = s_size_2_of_c_2_left_rest + s_size_2_of_c_2_right_rest,
      s_size_2 = fabs(s_size_2_of_c_2), s_size_2_opposite = -s_size_2_of_c_2_lo,
      s_size_2_lo = s_size_2_of_c_2 < 0.0 ? s_size_2_opposite : s_size_2_of_c_2_lo;
  const double s_largest1a_of_s_size_0 = s_size_0 + s_size_0_lo,
      s_largest1a_of_s_size_0_right = s_largest1a_of_s_size_0 - s_size_0,
      s_largest1a_of_s_size_0_left = s_largest1a_of_s_size_0 - s_largest1a_of_s_size_0_right,
      s_largest1a_of_s_size_0_left_rest = s_size_0 - s_largest1a_of_s_size_0_left,
      s_largest1a_of_s_size_0_right_rest = s_size_0_lo - s_largest1a_of_s_size_0_right,
      s_largest1a_of_s_size_0_lo = s_largest1a_of_s_size_0_left_rest +
          s_largest1a_of_s_size_0_right_rest,
      s_largest1a_of_s_size_1 = s_size_1 + s_size_1_lo,
      s_largest1a_of_s_size_1_right = s_largest1a_of_s_size_1 - s_size_1,
      s_largest1a_of_s_size_1_left = s_largest1a_of_s_size_1 - s_largest1a_of_s_size_1_right,
      s_largest1a_of_s_size_1_left_rest = s_size_1 - s_largest1a_of_s_size_1_left,
      s_largest1a_of_s_size_1_right_rest = s_size_1_lo - s_largest1a_of_s_size_1_right,
      s_largest1a_of_s_size_1_lo = s_largest1a_of_s_size_1_left_rest +
          s_largest1a_of_s_size_1_right_rest,
      s_largest1 = s_largest1a_of_s_size_0 < s_largest1a_of_s_size_1 ? s_largest1a_of_s_size_1 :
          s_largest1a_of_s_size_0,
      s_largest1_lo = s_largest1a_of_s_size_0 < s_largest1a_of_s_size_1 ? s_largest1a_of_s_size_1_lo
          : s_largest1a_of_s_size_0_lo;
  const double s_largest2a_of_s_largest1 = s_largest1 + s_largest1_lo,
      s_largest2a_of_s_largest1_right = s_largest2a_of_s_largest1 - s_largest1,
      s_largest2a_of_s_largest1_left = s_largest2a_of_s_largest1 - s_largest2a_of_s_largest1_right,
      s_largest2a_of_s_largest1_left_rest = s_largest1 - s_largest2a_of_s_largest1_left,
      s_largest2a_of_s_largest1_right_rest = s_largest1_lo - s_largest2a_of_s_largest1_right,
      s_largest2a_of_s_largest1_lo = s_largest2a_of_s_largest1_left_rest +
          s_largest2a_of_s_largest1_right_rest,
      s_largest2a_of_s_size_2 = s_size_2 + s_size_2_lo,
      s_largest2a_of_s_size_2_right = s_largest2a_of_s_size_2 - s_size_2,
      s_largest2a_of_s_size_2_left = s_largest2a_of_s_size_2 - s_largest2a_of_s_size_2_right,
      s_largest2a_of_s_size_2_left_rest = s_size_2 - s_largest2a_of_s_size_2_left,
      s_largest2a_of_s_size_2_right_rest = s_size_2_lo - s_largest2a_of_s_size_2_right,
      s_largest2a_of_s_size_2_lo = s_largest2a_of_s_size_2_left_rest +
          s_largest2a_of_s_size_2_right_rest,
      s_largest2 = s_largest2a_of_s_largest1 < s_largest2a_of_s_size_2 ? s_largest2a_of_s_size_2 :
          s_largest2a_of_s_largest1,
      s_largest2_lo = s_largest2a_of_s_largest1 < s_largest2a_of_s_size_2 ?
          s_largest2a_of_s_size_2_lo : s_largest2a_of_s_largest1_lo;
  const double s_a_of_s_largest2 = s_largest2 + s_largest2_lo,
      s_b = 6.703903964971299e+153 < s_a_of_s_largest2 ? 3.7291703656001034e-155 : 1.0,
      s_d = s_a_of_s_largest2 < 256.0 ? 1.3093562431584567e+151 : s_b,
      s = s_a_of_s_largest2 < 1.955159272639747e-149 ? 1.0715086071862673e+301 : s_d;
  const double y_0 = KSL_MUL(s_size_0_of_c_0, s), y_0_inverse = 1.0 / s,
      y_0_back = KSL_MUL(y_0, y_0_inverse), y_0_lost = s_size_0_of_c_0 - y_0_back,
      y_0_rest = y_0_lost + s_size_0_of_c_0_lo, y_0_lo = KSL_MUL(y_0_rest, s);
  const double y_1 = KSL_MUL(s_size_1_of_c_1, s), y_1_back = KSL_MUL(y_1, y_0_inverse),
      y_1_lost = s_size_1_of_c_1 - y_1_back, y_1_rest = y_1_lost + s_size_1_of_c_1_lo,
      y_1_lo = KSL_MUL(y_1_rest, s);
  const double y_2 = KSL_MUL(s_size_2_of_c_2, s), y_2_back = KSL_MUL(y_2, y_0_inverse),
      y_2_lost = s_size_2_of_c_2 - y_2_back, y_2_rest = y_2_lost + s_size_2_of_c_2_lo,
      y_2_lo = KSL_MUL(y_2_rest, s);
  const double n_a = KSL_MUL(y_0, y_0), n_a_cross1 = KSL_MUL(y_0_lo, y_0),
      n_a_cross2 = KSL_MUL(y_0, y_0_lo), n_a_cross = n_a_cross1 + n_a_cross2,
      n_b = KSL_MUL(y_1, y_1), n_b_cross1 = KSL_MUL(y_1_lo, y_1), n_b_cross2 = KSL_MUL(y_1, y_1_lo),
      n_b_cross = n_b_cross1 + n_b_cross2, n_c = n_a + n_b, n_c_right = n_c - n_a,
      n_c_left = n_c - n_c_right, n_c_left_rest = ksl_product_rest(y_0, y_0, n_a, n_c_left),
      n_c_right_rest = ksl_product_rest(y_1, y_1, n_b, n_c_right),
      n_c_cross = n_a_cross + n_b_cross, n_c_lo1 = n_c_left_rest + n_c_right_rest,
      n_c_lo = n_c_lo1 + n_c_cross, n_d = KSL_MUL(y_2, y_2), n_d_cross1 = KSL_MUL(y_2_lo, y_2),
      n_d_cross2 = KSL_MUL(y_2, y_2_lo), n_d_cross = n_d_cross1 + n_d_cross2, n_e = n_c + n_d,
      n_e_right = n_e - n_c, n_e_left = n_e - n_e_right, n_e_left_rest = n_c - n_e_left,
      n_e_right_rest = ksl_product_rest(y_2, y_2, n_d, n_e_right),
      n_e_lo1 = n_e_left_rest + n_e_right_rest, n_e_lo2 = n_e_lo1 + n_d_cross,
      n_e_lo = n_e_lo2 + n_c_lo, n_of_n_e = n_e + n_e_lo, n_of_n_e_right = n_of_n_e - n_e,
      n_of_n_e_left = n_of_n_e - n_of_n_e_right, n_of_n_e_left_rest = n_e - n_of_n_e_left,
      n_of_n_e_right_rest = n_e_lo - n_of_n_e_right,
      n_of_n_e_lo = n_of_n_e_left_rest + n_of_n_e_right_rest, n = sqrt(n_of_n_e),
      n_product = KSL_MUL(n, n), n_product_error = ksl_product_error(n, n, n_product),
      n_rest = n_of_n_e - n_product, n_exact = n_rest - n_product_error,
      n_residual = n_exact + n_of_n_e_lo, n_twice = n + n, n_divisor = n == 0.0 ? 1.0 : n_twice,
      n_lo = n_residual / n_divisor;
  const double r_b = s < 1.0 ? 2.6815615859885194e+154 : 1.0,
      r_d = 1.0 < s ? 7.637340908749012e-152 : r_b,
      r = 1.3093562431584567e+151 < s ? 9.332636185032189e-302 : r_d;
  const double cross_of_n = n + n_lo, cross_of_n_right = cross_of_n - n,
      cross_of_n_left = cross_of_n - cross_of_n_right, cross_of_n_left_rest = n - cross_of_n_left,
      cross_of_n_right_rest = n_lo - cross_of_n_right,
      cross_of_n_lo = cross_of_n_left_rest + cross_of_n_right_rest, cross = KSL_MUL(cross_of_n, r),
      cross_inverse = 1.0 / r, cross_back = KSL_MUL(cross, cross_inverse),
      cross_lost = cross_of_n - cross_back, cross_rest = cross_lost + cross_of_n_lo,
      cross_lo = KSL_MUL(cross_rest, r);
  const double dot__a = KSL_MUL(scaled_s1_0, scaled_s2_0),
      dot__b = KSL_MUL(scaled_s1_1, scaled_s2_1), dot__c = dot__a + dot__b,
      dot__c_right = dot__c - dot__a, dot__c_left = dot__c - dot__c_right,
      dot__c_left_rest = ksl_product_rest(scaled_s1_0, scaled_s2_0, dot__a, dot__c_left),
      dot__c_right_rest = ksl_product_rest(scaled_s1_1, scaled_s2_1, dot__b, dot__c_right),
      dot__c_lo = dot__c_left_rest + dot__c_right_rest, dot__d = KSL_MUL(scaled_s1_2, scaled_s2_2),
      dot_ = dot__c + dot__d, dot__right = dot_ - dot__c, dot__left = dot_ - dot__right,
      dot__left_rest = dot__c - dot__left,
      dot__right_rest = ksl_product_rest(scaled_s1_2, scaled_s2_2, dot__d, dot__right),
      dot__lo1 = dot__left_rest + dot__right_rest, dot__lo = dot__lo1 + dot__c_lo;
  const double angle_of_cross = cross + cross_lo, angle_of_cross_right = angle_of_cross - cross,
      angle_of_cross_left = angle_of_cross - angle_of_cross_right,
      angle_of_cross_left_rest = cross - angle_of_cross_left,
      angle_of_cross_right_rest = cross_lo - angle_of_cross_right,
      angle_of_cross_lo = angle_of_cross_left_rest + angle_of_cross_right_rest,
      angle_of_dot_ = dot_ + dot__lo, angle_of_dot__right = angle_of_dot_ - dot_,
      angle_of_dot__left = angle_of_dot_ - angle_of_dot__right,
      angle_of_dot__left_rest = dot_ - angle_of_dot__left,
      angle_of_dot__right_rest = dot__lo - angle_of_dot__right,
      angle_of_dot__lo = angle_of_dot__left_rest + angle_of_dot__right_rest,
      angle = ksl_atan2(angle_of_cross, angle_of_dot_),
      angle_own_error = ksl_atan2_error(angle_of_cross, angle_of_dot_, angle),
      angle_size0 = fabs(angle_of_cross), angle_size1 = fabs(angle_of_dot_),
      angle_most = angle_size0 < angle_size1 ? angle_size1 : angle_size0,
      angle_divisor = angle_most == 0.0 ? 1.0 : angle_most,
      angle_part0 = angle_of_cross / angle_divisor, angle_part1 = angle_of_dot_ / angle_divisor,
      angle_cross1 = KSL_MUL(angle_part1, angle_of_cross_lo),
      angle_cross2 = KSL_MUL(angle_part0, angle_of_dot__lo),
      angle_square1 = KSL_MUL(angle_part1, angle_part1),
      angle_square2 = KSL_MUL(angle_part0, angle_part0), angle_cross = angle_cross1 - angle_cross2,
      angle_square = angle_square1 + angle_square2,
      angle_divisor2 = KSL_MUL(angle_divisor, angle_square),
      angle_safe = angle_most == 0.0 ? 1.0 : angle_divisor2, angle_more = angle_cross / angle_safe,
      angle_lo = angle_own_error + angle_more;
  const double angle_rounded = angle + angle_lo,
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
      dot_c_right = dot_c - dot_a, dot_c_left = dot_c - dot_c_right,
      dot_c_left_rest = ksl_product_rest(v1->x, v2->x, dot_a, dot_c_left),
      dot_c_right_rest = ksl_product_rest(v1->y, v2->y, dot_b, dot_c_right),
      dot_c_lo = dot_c_left_rest + dot_c_right_rest, dot_d = KSL_MUL(v1->z, v2->z),
      dot = dot_c + dot_d, dot_right = dot - dot_c, dot_left = dot - dot_right,
      dot_left_rest = dot_c - dot_left,
      dot_right_rest = ksl_product_rest(v1->z, v2->z, dot_d, dot_right),
      dot_lo1 = dot_left_rest + dot_right_rest, dot_lo = dot_lo1 + dot_c_lo;
  const double dot_rounded = dot + dot_lo;
  return dot_rounded;
}

/* vo = k (-v).
   k: number; v, vo: vector.
   3 mul, 3 add, 3 product error, 6 neg.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_product_avinv_accurate(const double k, const ksl_vec3_t *v, ksl_vec3_t *vo) {
  const double vo_0a = KSL_MUL(k, v->x), vo_0 = -vo_0a, vo_0_factor = -k;
  const double vo_1a = KSL_MUL(k, v->y), vo_1 = -vo_1a, vo_1_factor = -k;
  const double vo_2a = KSL_MUL(k, v->z), vo_2 = -vo_2a, vo_2_factor = -k;
  const double vo_0_lo = ksl_product_error(vo_0_factor, v->x, vo_0), vo_0_rounded = vo_0 + vo_0_lo;
  const double vo_1_lo = ksl_product_error(vo_1_factor, v->y, vo_1), vo_1_rounded = vo_1 + vo_1_lo;
  const double vo_2_lo = ksl_product_error(vo_2_factor, v->z, vo_2), vo_2_rounded = vo_2 + vo_2_lo;
  vo->x = vo_0_rounded;
  vo->y = vo_1_rounded;
  vo->z = vo_2_rounded;
}

/* vo = v / k.
   k: number; v, vo: vector.
   3 mul, 9 add, 3 product error, 6 div, 3 equal, 3 select. */
static inline void ksl_product_ainvv_accurate(const double k, const ksl_vec3_t *v, ksl_vec3_t *vo) {
  const double vo_0 = v->x / k, vo_0_product = KSL_MUL(vo_0, k),
      vo_0_product_error = ksl_product_error(vo_0, k, vo_0_product),
      vo_0_rest = v->x - vo_0_product, vo_0_exact = vo_0_rest - vo_0_product_error,
      vo_0_lo = vo_0_exact / k;
  const double vo_1 = v->y / k, vo_1_product = KSL_MUL(vo_1, k),
      vo_1_product_error = ksl_product_error(vo_1, k, vo_1_product),
      vo_1_rest = v->y - vo_1_product, vo_1_exact = vo_1_rest - vo_1_product_error,
      vo_1_lo = vo_1_exact / k;
  const double vo_2 = v->z / k, vo_2_product = KSL_MUL(vo_2, k),
      vo_2_product_error = ksl_product_error(vo_2, k, vo_2_product),
      vo_2_rest = v->z - vo_2_product, vo_2_exact = vo_2_rest - vo_2_product_error,
      vo_2_lo = vo_2_exact / k;
  const double vo_0_rounded = vo_0 + vo_0_lo,
      vo_0_final = vo_0_rounded == vo_0_rounded ? vo_0_rounded : vo_0;
  const double vo_1_rounded = vo_1 + vo_1_lo,
      vo_1_final = vo_1_rounded == vo_1_rounded ? vo_1_rounded : vo_1;
  const double vo_2_rounded = vo_2 + vo_2_lo,
      vo_2_final = vo_2_rounded == vo_2_rounded ? vo_2_rounded : vo_2;
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
      vo_0_right = vo_0a - vo_0, vo_0_left = vo_0 + vo_0_right,
      vo_0_left_rest = ksl_product_rest(v1->y, v2->z, vo_0a, vo_0_left),
      vo_0_right_rest = ksl_product_rest(v1->z, v2->y, vo_0b, vo_0_right),
      vo_0_lo = vo_0_left_rest - vo_0_right_rest;
  const double vo_1a = KSL_MUL(v1->z, v2->x), vo_1b = KSL_MUL(v1->x, v2->z), vo_1 = vo_1a - vo_1b,
      vo_1_right = vo_1a - vo_1, vo_1_left = vo_1 + vo_1_right,
      vo_1_left_rest = ksl_product_rest(v1->z, v2->x, vo_1a, vo_1_left),
      vo_1_right_rest = ksl_product_rest(v1->x, v2->z, vo_1b, vo_1_right),
      vo_1_lo = vo_1_left_rest - vo_1_right_rest;
  const double vo_2a = KSL_MUL(v1->x, v2->y), vo_2b = KSL_MUL(v1->y, v2->x), vo_2 = vo_2a - vo_2b,
      vo_2_right = vo_2a - vo_2, vo_2_left = vo_2 + vo_2_right,
      vo_2_left_rest = ksl_product_rest(v1->x, v2->y, vo_2a, vo_2_left),
      vo_2_right_rest = ksl_product_rest(v1->y, v2->x, vo_2b, vo_2_right),
      vo_2_lo = vo_2_left_rest - vo_2_right_rest;
  const double vo_0_rounded = vo_0 + vo_0_lo;
  const double vo_1_rounded = vo_1 + vo_1_lo;
  const double vo_2_rounded = vo_2 + vo_2_lo;
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
      vo_0_right = vo_0a - vo_0, vo_0_left = vo_0 + vo_0_right,
      vo_0_left_rest = ksl_product_rest(v1->z, v2->y, vo_0a, vo_0_left),
      vo_0_right_rest = ksl_product_rest(v1->y, v2->z, vo_0b, vo_0_right),
      vo_0_lo = vo_0_left_rest - vo_0_right_rest;
  const double vo_1a = KSL_MUL(v1->x, v2->z), vo_1b = KSL_MUL(v1->z, v2->x), vo_1 = vo_1a - vo_1b,
      vo_1_right = vo_1a - vo_1, vo_1_left = vo_1 + vo_1_right,
      vo_1_left_rest = ksl_product_rest(v1->x, v2->z, vo_1a, vo_1_left),
      vo_1_right_rest = ksl_product_rest(v1->z, v2->x, vo_1b, vo_1_right),
      vo_1_lo = vo_1_left_rest - vo_1_right_rest;
  const double vo_2a = KSL_MUL(v1->y, v2->x), vo_2b = KSL_MUL(v1->x, v2->y), vo_2 = vo_2a - vo_2b,
      vo_2_right = vo_2a - vo_2, vo_2_left = vo_2 + vo_2_right,
      vo_2_left_rest = ksl_product_rest(v1->y, v2->x, vo_2a, vo_2_left),
      vo_2_right_rest = ksl_product_rest(v1->x, v2->y, vo_2b, vo_2_right),
      vo_2_lo = vo_2_left_rest - vo_2_right_rest;
  const double vo_0_rounded = vo_0 + vo_0_lo;
  const double vo_1_rounded = vo_1 + vo_1_lo;
  const double vo_2_rounded = vo_2 + vo_2_lo;
  vo->x = vo_0_rounded;
  vo->y = vo_1_rounded;
  vo->z = vo_2_rounded;
}

/* vo = v + k e_x.
   v, vo: vector; k: number.
   7 add.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_add_vvx_accurate(const ksl_vec3_t *v, const double k, ksl_vec3_t *vo) {
  const double vo_0 = v->x + k, vo_0_right = vo_0 - v->x, vo_0_left = vo_0 - vo_0_right,
      vo_0_left_rest = v->x - vo_0_left, vo_0_right_rest = k - vo_0_right,
      vo_0_lo = vo_0_left_rest + vo_0_right_rest;
  const double vo_0_rounded = vo_0 + vo_0_lo;
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
  const double vo_0 = v->x - k, vo_0_right = v->x - vo_0, vo_0_left = vo_0 + vo_0_right,
      vo_0_left_rest = v->x - vo_0_left, vo_0_right_rest = k - vo_0_right,
      vo_0_lo = vo_0_left_rest - vo_0_right_rest;
  const double vo_0_rounded = vo_0 + vo_0_lo;
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
  const double vo_1 = v->y + k, vo_1_right = vo_1 - v->y, vo_1_left = vo_1 - vo_1_right,
      vo_1_left_rest = v->y - vo_1_left, vo_1_right_rest = k - vo_1_right,
      vo_1_lo = vo_1_left_rest + vo_1_right_rest;
  const double vo_1_rounded = vo_1 + vo_1_lo;
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
  const double vo_1 = v->y - k, vo_1_right = v->y - vo_1, vo_1_left = vo_1 + vo_1_right,
      vo_1_left_rest = v->y - vo_1_left, vo_1_right_rest = k - vo_1_right,
      vo_1_lo = vo_1_left_rest - vo_1_right_rest;
  const double vo_1_rounded = vo_1 + vo_1_lo;
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
  const double vo_2 = v->z + k, vo_2_right = vo_2 - v->z, vo_2_left = vo_2 - vo_2_right,
      vo_2_left_rest = v->z - vo_2_left, vo_2_right_rest = k - vo_2_right,
      vo_2_lo = vo_2_left_rest + vo_2_right_rest;
  const double vo_2_rounded = vo_2 + vo_2_lo;
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
  const double vo_2 = v->z - k, vo_2_right = v->z - vo_2, vo_2_left = vo_2 + vo_2_right,
      vo_2_left_rest = v->z - vo_2_left, vo_2_right_rest = k - vo_2_right,
      vo_2_lo = vo_2_left_rest - vo_2_right_rest;
  const double vo_2_rounded = vo_2 + vo_2_lo;
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
  const double self_0_new = (double)self->x * (double)a;
  const double self_1_new = (double)self->y * (double)a;
  const double self_2_new = (double)self->z * (double)a;
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
  const double y_0_new = ksl_product_sum((double)a, (double)x->x, (double)y->x);
  const double y_1_new = ksl_product_sum((double)a, (double)x->y, (double)y->y);
  const double y_2_new = ksl_product_sum((double)a, (double)x->z, (double)y->z);
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
  const double y_0_new = (double)x->x + (double)y->x;
  const double y_1_new = (double)x->y + (double)y->y;
  const double y_2_new = (double)x->z + (double)y->z;
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
  const double y_0_new = (double)y->x - (double)x->x;
  const double y_1_new = (double)y->y - (double)x->y;
  const double y_2_new = (double)y->z - (double)x->z;
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
  const double vo_0 = (double)a * (double)vi->x;
  const double vo_1 = (double)a * (double)vi->y;
  const double vo_2 = (double)a * (double)vi->z;
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
  const double vo_0 = (double)v1->x + (double)v2->x;
  const double vo_1 = (double)v1->y + (double)v2->y;
  const double vo_2 = (double)v1->z + (double)v2->z;
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
  const double vo_0 = (double)v1->x - (double)v2->x;
  const double vo_1 = (double)v1->y - (double)v2->y;
  const double vo_2 = (double)v1->z - (double)v2->z;
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
  const double vo_0 = (double)v->x * (double)k;
  const double vo_1 = (double)v->y * (double)k;
  const double vo_2 = (double)v->z * (double)k;
  vo->x = (float)vo_0;
  vo->y = (float)vo_1;
  vo->z = (float)vo_2;
}

/* |v| = sqrt(v·v).
   v: vector.
   7 mul, 2 add, 1 sqrt, 3 abs, 8 less, 8 select. */
static inline float ksl_vec3f_l2norm_accurate(const ksl_vec3f_t *v) {
  const double s_size_0 = fabs((double)v->x);
  const double s_size_1 = fabs((double)v->y);
  const double s_size_2 = fabs((double)v->z);
  const double s_largest1 = s_size_0 < s_size_1 ? s_size_1 : s_size_0;
  const double s_largest2 = s_largest1 < s_size_2 ? s_size_2 : s_largest1;
  const double s_b = 4.611686018427388e+18 < s_largest2 ? 2.710505431213761e-20 : 1.0,
      s_d = s_largest2 < 256.0 ? 1.8014398509481984e+16 : s_b,
      s = s_largest2 < 1.4210854715202004e-14 ? 3.2451855365842673e+32 : s_d;
  const double y_0 = KSL_MUL((double)v->x, s);
  const double y_1 = KSL_MUL((double)v->y, s);
  const double y_2 = KSL_MUL((double)v->z, s);
  const double n_a = KSL_MUL(y_0, y_0), n_b = KSL_MUL(y_1, y_1), n_c = n_a + n_b,
      n_d = KSL_MUL(y_2, y_2), n_e = n_c + n_d, n = sqrt(n_e);
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
  const double s_size_0 = fabs((double)self->x);
  const double s_size_1 = fabs((double)self->y);
  const double s_size_2 = fabs((double)self->z);
  const double s_largest1 = s_size_0 < s_size_1 ? s_size_1 : s_size_0;
  const double s_largest2 = s_largest1 < s_size_2 ? s_size_2 : s_largest1;
  const double s_b = 4.611686018427388e+18 < s_largest2 ? 2.710505431213761e-20 : 1.0,
      s_d = s_largest2 < 256.0 ? 1.8014398509481984e+16 : s_b,
      s = s_largest2 < 1.4210854715202004e-14 ? 3.2451855365842673e+32 : s_d;
  const double y_0 = KSL_MUL((double)self->x, s);
  const double y_1 = KSL_MUL((double)self->y, s);
  const double y_2 = KSL_MUL((double)self->z, s);
  const double up = 1.0 < s ? s : 1.0;
  const double down = s < 1.0 ? s : 1.0;
  const double n_a = KSL_MUL(y_0, y_0), n_b = KSL_MUL(y_1, y_1), n_c = n_a + n_b,
      n_d = KSL_MUL(y_2, y_2), n_e = n_c + n_d, n = sqrt(n_e);
  const double divisor = n == 0.0 ? up : n;
  const double sized_0 = KSL_MUL((double)self->x, up);
  const double sized_1 = KSL_MUL((double)self->y, up);
  const double sized_2 = KSL_MUL((double)self->z, up);
  const double quotient_0 = sized_0 / divisor;
  const double quotient_1 = sized_1 / divisor;
  const double quotient_2 = sized_2 / divisor;
  const double self_0_new = KSL_MUL(quotient_0, down);
  const double self_1_new = KSL_MUL(quotient_1, down);
  const double self_2_new = KSL_MUL(quotient_2, down);
  self->x = (float)self_0_new;
  self->y = (float)self_1_new;
  self->z = (float)self_2_new;
}

/* vo = v / |v|; the zero vector stays zero.
   v, vo: vector.
   12 mul, 2 add, 3 div, 1 sqrt, 3 abs, 7 less, 1 equal, 8 select. */
static inline void ksl_vec3f_normalized_accurate(const ksl_vec3f_t *v, ksl_vec3f_t *vo) {
  const double s_size_0 = fabs((double)v->x);
  const double s_size_1 = fabs((double)v->y);
  const double s_size_2 = fabs((double)v->z);
  const double s_largest1 = s_size_0 < s_size_1 ? s_size_1 : s_size_0;
  const double s_largest2 = s_largest1 < s_size_2 ? s_size_2 : s_largest1;
  const double s_b = 4.611686018427388e+18 < s_largest2 ? 2.710505431213761e-20 : 1.0,
      s_d = s_largest2 < 256.0 ? 1.8014398509481984e+16 : s_b,
      s = s_largest2 < 1.4210854715202004e-14 ? 3.2451855365842673e+32 : s_d;
  const double y_0 = KSL_MUL((double)v->x, s);
  const double y_1 = KSL_MUL((double)v->y, s);
  const double y_2 = KSL_MUL((double)v->z, s);
  const double up = 1.0 < s ? s : 1.0;
  const double down = s < 1.0 ? s : 1.0;
  const double n_a = KSL_MUL(y_0, y_0), n_b = KSL_MUL(y_1, y_1), n_c = n_a + n_b,
      n_d = KSL_MUL(y_2, y_2), n_e = n_c + n_d, n = sqrt(n_e);
  const double divisor = n == 0.0 ? up : n;
  const double sized_0 = KSL_MUL((double)v->x, up);
  const double sized_1 = KSL_MUL((double)v->y, up);
  const double sized_2 = KSL_MUL((double)v->z, up);
  const double quotient_0 = sized_0 / divisor;
  const double quotient_1 = sized_1 / divisor;
  const double quotient_2 = sized_2 / divisor;
  const double vo_0 = KSL_MUL(quotient_0, down);
  const double vo_1 = KSL_MUL(quotient_1, down);
  const double vo_2 = KSL_MUL(quotient_2, down);
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
  const double s1_size_0 = fabs((double)v1->x);
  const double s1_size_1 = fabs((double)v1->y);
  const double s1_size_2 = fabs((double)v1->z);
  const double s1_largest1 = s1_size_0 < s1_size_1 ? s1_size_1 : s1_size_0;
  const double s1_largest2 = s1_largest1 < s1_size_2 ? s1_size_2 : s1_largest1;
  const double s1b = 4.611686018427388e+18 < s1_largest2 ? 2.710505431213761e-20 : 1.0,
      s1d = s1_largest2 < 256.0 ? 1.8014398509481984e+16 : s1b,
      s1 = s1_largest2 < 1.4210854715202004e-14 ? 3.2451855365842673e+32 : s1d;
  const double scaled_s1_0 = KSL_MUL((double)v1->x, s1);
  const double scaled_s1_1 = KSL_MUL((double)v1->y, s1);
  const double scaled_s1_2 = KSL_MUL((double)v1->z, s1);
  const double s2_size_0 = fabs((double)v2->x);
  const double s2_size_1 = fabs((double)v2->y);
  const double s2_size_2 = fabs((double)v2->z);
  const double s2_largest1 = s2_size_0 < s2_size_1 ? s2_size_1 : s2_size_0;
  const double s2_largest2 = s2_largest1 < s2_size_2 ? s2_size_2 : s2_largest1;
  const double s2b = 4.611686018427388e+18 < s2_largest2 ? 2.710505431213761e-20 : 1.0,
      s2d = s2_largest2 < 256.0 ? 1.8014398509481984e+16 : s2b,
      s2 = s2_largest2 < 1.4210854715202004e-14 ? 3.2451855365842673e+32 : s2d;
  const double scaled_s2_0 = KSL_MUL((double)v2->x, s2);
  const double scaled_s2_1 = KSL_MUL((double)v2->y, s2);
  const double scaled_s2_2 = KSL_MUL((double)v2->z, s2);
  const double c_0a = KSL_MUL(scaled_s1_1, scaled_s2_2), c_0b = KSL_MUL(scaled_s1_2, scaled_s2_1),
      c_0 = c_0a - c_0b;
  const double c_1a = KSL_MUL(scaled_s1_2, scaled_s2_0), c_1b = KSL_MUL(scaled_s1_0, scaled_s2_2),
      c_1 = c_1a - c_1b;
  const double c_2a = KSL_MUL(scaled_s1_0, scaled_s2_1), c_2b = KSL_MUL(scaled_s1_1, scaled_s2_0),
      c_2 = c_2a - c_2b;
  const double s_size_0 = fabs(c_0);
  const double s_size_1 = fabs(c_1);
  const double s_size_2 = fabs(c_2);
  const double s_largest1 = s_size_0 < s_size_1 ? s_size_1 : s_size_0;
  const double s_largest2 = s_largest1 < s_size_2 ? s_size_2 : s_largest1;
  const double s_b = 4.611686018427388e+18 < s_largest2 ? 2.710505431213761e-20 : 1.0,
      s_d = s_largest2 < 256.0 ? 1.8014398509481984e+16 : s_b,
      s = s_largest2 < 1.4210854715202004e-14 ? 3.2451855365842673e+32 : s_d;
  const double y_0 = KSL_MUL(c_0, s);
  const double y_1 = KSL_MUL(c_1, s);
  const double y_2 = KSL_MUL(c_2, s);
  const double n_a = KSL_MUL(y_0, y_0), n_b = KSL_MUL(y_1, y_1), n_c = n_a + n_b,
      n_d = KSL_MUL(y_2, y_2), n_e = n_c + n_d, n = sqrt(n_e);
  const double r_b = s < 1.0 ? 3.6893488147419103e+19 : 1.0,
      r_d = 1.0 < s ? 5.551115123125783e-17 : r_b,
      r = 1.8014398509481984e+16 < s ? 3.0814879110195774e-33 : r_d;
  const double cross = KSL_MUL(n, r);
  const double dot__a = KSL_MUL(scaled_s1_0, scaled_s2_0),
      dot__b = KSL_MUL(scaled_s1_1, scaled_s2_1), dot__c = dot__a + dot__b,
      dot__d = KSL_MUL(scaled_s1_2, scaled_s2_2), dot_ = dot__c + dot__d;
  const double angle = ksl_atan2(cross, dot_);
  return (float)angle;
}

/* v1·v2.
   v1, v2: vector.
   3 mul, 2 add.
   Error <= u |result| + 3/32 u^2 S, S the sum of the |terms| of the expanded formula; barring
     over- and underflow. */
static inline float ksl_dot_vvf_accurate(const ksl_vec3f_t *v1, const ksl_vec3f_t *v2) {
  const double dot_a = (double)v1->x * (double)v2->x,
      dot_c = ksl_product_sum((double)v1->y, (double)v2->y, dot_a),
      dot = ksl_product_sum((double)v1->z, (double)v2->z, dot_c);
  return (float)dot;
}

/* vo = k (-v).
   k: number; v, vo: vector.
   3 mul, 3 neg.
   Error <= u |result| + 1/32 u^2 S, S the sum of the |terms| of the expanded formula; barring
     over- and underflow. */
static inline void ksl_product_avinvf_accurate(const float k, const ksl_vec3f_t *v,
    ksl_vec3f_t *vo) {
  const double vo_0a = (double)k * (double)v->x, vo_0 = -vo_0a;
  const double vo_1a = (double)k * (double)v->y, vo_1 = -vo_1a;
  const double vo_2a = (double)k * (double)v->z, vo_2 = -vo_2a;
  vo->x = (float)vo_0;
  vo->y = (float)vo_1;
  vo->z = (float)vo_2;
}

/* vo = v / k.
   k: number; v, vo: vector.
   3 div. */
static inline void ksl_product_ainvvf_accurate(const float k, const ksl_vec3f_t *v,
    ksl_vec3f_t *vo) {
  const double vo_0 = (double)v->x / (double)k;
  const double vo_1 = (double)v->y / (double)k;
  const double vo_2 = (double)v->z / (double)k;
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
  const double vo_0a = (double)v1->y * (double)v2->z,
      vo_0 = ksl_product_sum(-(double)v1->z, (double)v2->y, vo_0a);
  const double vo_1a = (double)v1->z * (double)v2->x,
      vo_1 = ksl_product_sum(-(double)v1->x, (double)v2->z, vo_1a);
  const double vo_2a = (double)v1->x * (double)v2->y,
      vo_2 = ksl_product_sum(-(double)v1->y, (double)v2->x, vo_2a);
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
  const double vo_0a = (double)v1->z * (double)v2->y,
      vo_0 = ksl_product_sum(-(double)v1->y, (double)v2->z, vo_0a);
  const double vo_1a = (double)v1->x * (double)v2->z,
      vo_1 = ksl_product_sum(-(double)v1->z, (double)v2->x, vo_1a);
  const double vo_2a = (double)v1->y * (double)v2->x,
      vo_2 = ksl_product_sum(-(double)v1->x, (double)v2->y, vo_2a);
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
