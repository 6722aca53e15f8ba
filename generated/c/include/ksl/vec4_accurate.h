/* Made by `coscrew generate`; changes are overwritten. */
/* SPDX-License-Identifier: MIT */
/* coscrew 0.2.0.  Copyright (c) 2026 The coscrew authors. */
/* Vectors of four components: three dimensions and a homogeneous coordinate.
   Accurate tier: double compensated, single computed in double. */
#ifndef KSL_VEC4_ACCURATE_H
#define KSL_VEC4_ACCURATE_H

#include "ksl_exact.h"

/* self = a self.
   self: vector (x, y, z) and a homogeneous coordinate w; a: number.
   4 mul, 4 add, 4 product error.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_vec4_scale_accurate(ksl_vec4_t *self, const double a) {
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

/* vo = k v.
   v, vo: vector (x, y, z) and a homogeneous coordinate w; k: number.
   4 mul, 4 add, 4 product error.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_vec4_scaled_accurate(const ksl_vec4_t *v, const double k, ksl_vec4_t *vo) {
  const double vo_0 = KSL_MUL(v->x, k), vo_1 = KSL_MUL(v->y, k), vo_2 = KSL_MUL(v->z, k),
      vo_3 = KSL_MUL(v->w, k);
  const double vo_0_rounded = vo_0 + ksl_product_error(v->x, k, vo_0),
      vo_1_rounded = vo_1 + ksl_product_error(v->y, k, vo_1),
      vo_2_rounded = vo_2 + ksl_product_error(v->z, k, vo_2),
      vo_3_rounded = vo_3 + ksl_product_error(v->w, k, vo_3);
  vo->x = vo_0_rounded;
  vo->y = vo_1_rounded;
  vo->z = vo_2_rounded;
  vo->w = vo_3_rounded;
}

/* |v| = sqrt(v·v), all four components.
   v: vector (x, y, z) and a homogeneous coordinate w.
   12 mul, 35 add, 1 product error, 4 product rest, 2 div, 1 sqrt, 4 abs, 9 less, 2 equal, 11
     select. */
static inline double ksl_vec4_l2norm_accurate(const ksl_vec4_t *v) {
  const double s_size_0 = fabs(v->x), s_size_1 = fabs(v->y), s_size_2 = fabs(v->z),
      s_size_3 = fabs(v->w);
  const double s_largest1 = s_size_0 < s_size_1 ? s_size_1 : s_size_0;
  const double s_largest2 = s_largest1 < s_size_2 ? s_size_2 : s_largest1;
  const double s_largest3 = s_largest2 < s_size_3 ? s_size_3 : s_largest2;
  const double s_b = 6.703903964971299e+153 < s_largest3 ? 3.7291703656001034e-155 : 1.0,
      s_d = s_largest3 < 256.0 ? 1.3093562431584567e+151 : s_b,
      s = s_largest3 < 1.955159272639747e-149 ? 1.0715086071862673e+301 : s_d;
  const double y_0 = KSL_MUL(v->x, s), y_1 = KSL_MUL(v->y, s), y_2 = KSL_MUL(v->z, s),
      y_3 = KSL_MUL(v->w, s);
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

/* self = self / |self|; the zero vector stays zero.
   self: vector (x, y, z) and a homogeneous coordinate w.
   33 mul, 86 add, 5 product error, 4 product rest, 10 div, 1 sqrt, 4 abs, 8 less, 6 equal, 15
     select. */
static inline void ksl_vec4_normalize_accurate(ksl_vec4_t *self) {
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

/* vo = v / |v|; the zero vector stays zero.
   v, vo: vector (x, y, z) and a homogeneous coordinate w.
   33 mul, 86 add, 5 product error, 4 product rest, 10 div, 1 sqrt, 4 abs, 8 less, 6 equal, 15
     select. */
static inline void ksl_vec4_normalized_accurate(const ksl_vec4_t *v, ksl_vec4_t *vo) {
  const double s_size_0 = fabs(v->x), s_size_1 = fabs(v->y), s_size_2 = fabs(v->z),
      s_size_3 = fabs(v->w);
  const double s_largest1 = s_size_0 < s_size_1 ? s_size_1 : s_size_0;
  const double s_largest2 = s_largest1 < s_size_2 ? s_size_2 : s_largest1;
  const double s_largest3 = s_largest2 < s_size_3 ? s_size_3 : s_largest2;
  const double s_b = 6.703903964971299e+153 < s_largest3 ? 3.7291703656001034e-155 : 1.0,
      s_d = s_largest3 < 256.0 ? 1.3093562431584567e+151 : s_b,
      s = s_largest3 < 1.955159272639747e-149 ? 1.0715086071862673e+301 : s_d;
  const double y_0 = KSL_MUL(v->x, s), y_1 = KSL_MUL(v->y, s), y_2 = KSL_MUL(v->z, s),
      y_3 = KSL_MUL(v->w, s);
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
  const double sized_0 = KSL_MUL(v->x, up), sized_1 = KSL_MUL(v->y, up),
      sized_2 = KSL_MUL(v->z, up), sized_3 = KSL_MUL(v->w, up);
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
  const double quotient_3_sum = quotient_3 + quotient_3_lo,
      quotient_3_sum_right = quotient_3_sum - quotient_3, vo_3 = KSL_MUL(quotient_3_sum, down),
      quotient_3_sum_lo = quotient_3 - (quotient_3_sum - quotient_3_sum_right)
          + (quotient_3_lo - quotient_3_sum_right);
  const double vo_0_rounded = vo_0
          + KSL_MUL(quotient_0_sum - KSL_MUL(vo_0, vo_0_inverse) + quotient_0_sum_lo, down);
  const double vo_1_rounded = vo_1
          + KSL_MUL(quotient_1_sum - KSL_MUL(vo_1, vo_0_inverse) + quotient_1_sum_lo, down);
  const double vo_2_rounded = vo_2
          + KSL_MUL(quotient_2_sum - KSL_MUL(vo_2, vo_0_inverse) + quotient_2_sum_lo, down);
  const double vo_3_rounded = vo_3
          + KSL_MUL(quotient_3_sum - KSL_MUL(vo_3, vo_0_inverse) + quotient_3_sum_lo, down);
  const double vo_0_final = vo_0_rounded == vo_0_rounded ? vo_0_rounded : vo_0;
  const double vo_1_final = vo_1_rounded == vo_1_rounded ? vo_1_rounded : vo_1;
  const double vo_2_final = vo_2_rounded == vo_2_rounded ? vo_2_rounded : vo_2;
  const double vo_3_final = vo_3_rounded == vo_3_rounded ? vo_3_rounded : vo_3;
  vo->x = vo_0_final;
  vo->y = vo_1_final;
  vo->z = vo_2_final;
  vo->w = vo_3_final;
}

/* self = a self.
   self: vector (x, y, z) and a homogeneous coordinate w; a: number.
   4 mul.
   Error <= u |result| + 1/32 u^2 S, S the sum of the |terms| of the expanded formula; barring
     over- and underflow. */
static inline void ksl_vec4f_scale_accurate(ksl_vec4f_t *self, const float a) {
  const double self_0_new = (double)self->x * (double)a, self_1_new = (double)self->y * (double)a,
      self_2_new = (double)self->z * (double)a, self_3_new = (double)self->w * (double)a;
  self->x = (float)self_0_new;
  self->y = (float)self_1_new;
  self->z = (float)self_2_new;
  self->w = (float)self_3_new;
}

/* vo = k v.
   v, vo: vector (x, y, z) and a homogeneous coordinate w; k: number.
   4 mul.
   Error <= u |result| + 1/32 u^2 S, S the sum of the |terms| of the expanded formula; barring
     over- and underflow. */
static inline void ksl_vec4f_scaled_accurate(const ksl_vec4f_t *v, const float k, ksl_vec4f_t *vo) {
  const double vo_0 = (double)v->x * (double)k, vo_1 = (double)v->y * (double)k,
      vo_2 = (double)v->z * (double)k, vo_3 = (double)v->w * (double)k;
  vo->x = (float)vo_0;
  vo->y = (float)vo_1;
  vo->z = (float)vo_2;
  vo->w = (float)vo_3;
}

/* |v| = sqrt(v·v), all four components.
   v: vector (x, y, z) and a homogeneous coordinate w.
   9 mul, 3 add, 1 sqrt, 4 abs, 9 less, 9 select. */
static inline float ksl_vec4f_l2norm_accurate(const ksl_vec4f_t *v) {
  const double s_size_0 = fabs((double)v->x), s_size_1 = fabs((double)v->y),
      s_size_2 = fabs((double)v->z), s_size_3 = fabs((double)v->w);
  const double s_largest1 = s_size_0 < s_size_1 ? s_size_1 : s_size_0;
  const double s_largest2 = s_largest1 < s_size_2 ? s_size_2 : s_largest1;
  const double s_largest3 = s_largest2 < s_size_3 ? s_size_3 : s_largest2;
  const double s_b = 4.611686018427388e+18 < s_largest3 ? 2.710505431213761e-20 : 1.0,
      s_d = s_largest3 < 256.0 ? 1.8014398509481984e+16 : s_b,
      s = s_largest3 < 1.4210854715202004e-14 ? 3.2451855365842673e+32 : s_d;
  const double y_0 = KSL_MUL((double)v->x, s), y_1 = KSL_MUL((double)v->y, s),
      y_2 = KSL_MUL((double)v->z, s), y_3 = KSL_MUL((double)v->w, s);
  const double n = sqrt(KSL_MUL(y_0, y_0) + KSL_MUL(y_1, y_1) + KSL_MUL(y_2, y_2)
          + KSL_MUL(y_3, y_3));
  const double r_b = s < 1.0 ? 3.6893488147419103e+19 : 1.0,
      r_d = 1.0 < s ? 5.551115123125783e-17 : r_b,
      r = 1.8014398509481984e+16 < s ? 3.0814879110195774e-33 : r_d;
  const double norm = KSL_MUL(n, r);
  return (float)norm;
}

/* self = self / |self|; the zero vector stays zero.
   self: vector (x, y, z) and a homogeneous coordinate w.
   16 mul, 3 add, 4 div, 1 sqrt, 4 abs, 8 less, 1 equal, 9 select. */
static inline void ksl_vec4f_normalize_accurate(ksl_vec4f_t *self) {
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

/* vo = v / |v|; the zero vector stays zero.
   v, vo: vector (x, y, z) and a homogeneous coordinate w.
   16 mul, 3 add, 4 div, 1 sqrt, 4 abs, 8 less, 1 equal, 9 select. */
static inline void ksl_vec4f_normalized_accurate(const ksl_vec4f_t *v, ksl_vec4f_t *vo) {
  const double s_size_0 = fabs((double)v->x), s_size_1 = fabs((double)v->y),
      s_size_2 = fabs((double)v->z), s_size_3 = fabs((double)v->w);
  const double s_largest1 = s_size_0 < s_size_1 ? s_size_1 : s_size_0;
  const double s_largest2 = s_largest1 < s_size_2 ? s_size_2 : s_largest1;
  const double s_largest3 = s_largest2 < s_size_3 ? s_size_3 : s_largest2;
  const double s_b = 4.611686018427388e+18 < s_largest3 ? 2.710505431213761e-20 : 1.0,
      s_d = s_largest3 < 256.0 ? 1.8014398509481984e+16 : s_b,
      s = s_largest3 < 1.4210854715202004e-14 ? 3.2451855365842673e+32 : s_d;
  const double y_0 = KSL_MUL((double)v->x, s), y_1 = KSL_MUL((double)v->y, s),
      y_2 = KSL_MUL((double)v->z, s), y_3 = KSL_MUL((double)v->w, s);
  const double up = 1.0 < s ? s : 1.0;
  const double down = s < 1.0 ? s : 1.0;
  const double n = sqrt(KSL_MUL(y_0, y_0) + KSL_MUL(y_1, y_1) + KSL_MUL(y_2, y_2)
          + KSL_MUL(y_3, y_3));
  const double divisor = n == 0.0 ? up : n;
  const double sized_0 = KSL_MUL((double)v->x, up), sized_1 = KSL_MUL((double)v->y, up),
      sized_2 = KSL_MUL((double)v->z, up), sized_3 = KSL_MUL((double)v->w, up);
  const double quotient_0 = sized_0 / divisor, quotient_1 = sized_1 / divisor,
      quotient_2 = sized_2 / divisor, quotient_3 = sized_3 / divisor;
  const double vo_0 = KSL_MUL(quotient_0, down), vo_1 = KSL_MUL(quotient_1, down),
      vo_2 = KSL_MUL(quotient_2, down), vo_3 = KSL_MUL(quotient_3, down);
  vo->x = (float)vo_0;
  vo->y = (float)vo_1;
  vo->z = (float)vo_2;
  vo->w = (float)vo_3;
}

#endif
