/* Made by `coscrew generate`; changes are overwritten. */
/* Quaternions q = (w; v): products, rotations, conversions, interpolation.
   Accurate tier: double compensated, single computed in double. */
#ifndef KSL_QUATERNION_ACCURATE_H
#define KSL_QUATERNION_ACCURATE_H

#include "ksl_exact.h"

/* self = a self.
   self: quaternion (w; x, y, z), the scalar first; a: number.
   4 mul, 4 add, 4 product error.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_quaternion_scale_accurate(ksl_quaternion_t *self, const double a) {
  const double self_0_new = self->w * a, self_0_new_lo = ksl_product_error(self->w, a, self_0_new);
  const double self_1_new = self->x * a, self_1_new_lo = ksl_product_error(self->x, a, self_1_new);
  const double self_2_new = self->y * a, self_2_new_lo = ksl_product_error(self->y, a, self_2_new);
  const double self_3_new = self->z * a, self_3_new_lo = ksl_product_error(self->z, a, self_3_new);
  const double self_0_new_rounded = self_0_new + self_0_new_lo;
  const double self_1_new_rounded = self_1_new + self_1_new_lo;
  const double self_2_new_rounded = self_2_new + self_2_new_lo;
  const double self_3_new_rounded = self_3_new + self_3_new_lo;
  self->w = self_0_new_rounded;
  self->x = self_1_new_rounded;
  self->y = self_2_new_rounded;
  self->z = self_3_new_rounded;
}

/* |q| = sqrt(w^2 + v·v).
   q: quaternion (w; x, y, z), the scalar first.
   12 mul, 18 add, 5 product error, 5 sum error, 2 div, 1 sqrt, 4 abs, 7 less, 3 equal, 10
     select. */
static inline double ksl_quaternion_norm_accurate(const ksl_quaternion_t *q) {
  const double s_size_0 = fabs(q->w);
  const double s_size_1 = fabs(q->x);
  const double s_size_2 = fabs(q->y);
  const double s_size_3 = fabs(q->z);
  const double s_largest1 = s_size_0 < s_size_1 ? s_size_1 : s_size_0;
  const double s_largest2 = s_largest1 < s_size_2 ? s_size_2 : s_largest1;
  const double s_largest3 = s_largest2 < s_size_3 ? s_size_3 : s_largest2;
  const double s_b = 6.703903964971299e+153 < s_largest3 ? 3.7291703656001034e-155 : 1.0,
      s = s_largest3 < 3.4395525670743494e-136 ? 4.149515568880993e+180 : s_b;
  const double y_0 = q->w * s;
  const double y_1 = q->x * s;
  const double y_2 = q->y * s;
  const double y_3 = q->z * s;
  const double n_a = y_0 * y_0, n_a_lo = ksl_product_error(y_0, y_0, n_a), n_b = y_1 * y_1,
      n_b_lo = ksl_product_error(y_1, y_1, n_b), n_c = n_a + n_b,
      n_c_error = ksl_sum_error(n_a, n_b, n_c), n_c_lo1 = n_c_error + n_a_lo,
      n_c_lo = n_c_lo1 + n_b_lo, n_d = y_2 * y_2, n_d_lo = ksl_product_error(y_2, y_2, n_d),
      n_e = n_c + n_d, n_e_error = ksl_sum_error(n_c, n_d, n_e), n_e_lo1 = n_e_error + n_c_lo,
      n_e_lo = n_e_lo1 + n_d_lo, n_f = y_3 * y_3, n_f_lo = ksl_product_error(y_3, y_3, n_f),
      n_g = n_e + n_f, n_g_error = ksl_sum_error(n_e, n_f, n_g), n_g_lo1 = n_g_error + n_e_lo,
      n_g_lo = n_g_lo1 + n_f_lo, n_of_n_g = n_g + n_g_lo,
      n_of_n_g_lo = ksl_sum_error(n_g, n_g_lo, n_of_n_g), n = sqrt(n_of_n_g), n_product = n * n,
      n_product_error = ksl_product_error(n, n, n_product), n_rest = n_of_n_g - n_product,
      n_exact = n_rest - n_product_error, n_residual = n_exact + n_of_n_g_lo, n_twice = n + n,
      n_divisor = n == 0.0 ? 1.0 : n_twice, n_lo = n_residual / n_divisor;
  const double r_b = s < 1.0 ? 2.6815615859885194e+154 : 1.0,
      r = 1.0 < s ? 2.409919865102884e-181 : r_b;
  const double norm_of_n = n + n_lo, norm_of_n_lo = ksl_sum_error(n, n_lo, norm_of_n),
      norm = norm_of_n * r, norm_inverse = 1.0 / r, norm_back = norm * norm_inverse,
      norm_lost = norm_of_n - norm_back, norm_rest = norm_lost + norm_of_n_lo,
      norm_small = norm_rest * r, norm_lo = norm_lost == 0.0 ? 0.0 : norm_small;
  const double norm_total = norm + norm_lo,
      norm_rounded = norm_total == norm_total ? norm_total : norm;
  return norm_rounded;
}

/* self = self / |self|; zero stays zero.
   self: quaternion (w; x, y, z), the scalar first.
   33 mul, 43 add, 9 product error, 9 sum error, 10 div, 1 sqrt, 4 abs, 7 less, 10 equal, 18
     select. */
static inline void ksl_quaternion_normalize_accurate(ksl_quaternion_t *self) {
  const double s_size_0 = fabs(self->w);
  const double s_size_1 = fabs(self->x);
  const double s_size_2 = fabs(self->y);
  const double s_size_3 = fabs(self->z);
  const double s_largest1 = s_size_0 < s_size_1 ? s_size_1 : s_size_0;
  const double s_largest2 = s_largest1 < s_size_2 ? s_size_2 : s_largest1;
  const double s_largest3 = s_largest2 < s_size_3 ? s_size_3 : s_largest2;
  const double s_b = 6.703903964971299e+153 < s_largest3 ? 3.7291703656001034e-155 : 1.0,
      s = s_largest3 < 3.4395525670743494e-136 ? 4.149515568880993e+180 : s_b;
  const double y_0 = self->w * s;
  const double y_1 = self->x * s;
  const double y_2 = self->y * s;
  const double y_3 = self->z * s;
  const double n_a = y_0 * y_0, n_a_lo = ksl_product_error(y_0, y_0, n_a), n_b = y_1 * y_1,
      n_b_lo = ksl_product_error(y_1, y_1, n_b), n_c = n_a + n_b,
      n_c_error = ksl_sum_error(n_a, n_b, n_c), n_c_lo1 = n_c_error + n_a_lo,
      n_c_lo = n_c_lo1 + n_b_lo, n_d = y_2 * y_2, n_d_lo = ksl_product_error(y_2, y_2, n_d),
      n_e = n_c + n_d, n_e_error = ksl_sum_error(n_c, n_d, n_e), n_e_lo1 = n_e_error + n_c_lo,
      n_e_lo = n_e_lo1 + n_d_lo, n_f = y_3 * y_3, n_f_lo = ksl_product_error(y_3, y_3, n_f),
      n_g = n_e + n_f, n_g_error = ksl_sum_error(n_e, n_f, n_g), n_g_lo1 = n_g_error + n_e_lo,
      n_g_lo = n_g_lo1 + n_f_lo, n_of_n_g = n_g + n_g_lo,
      n_of_n_g_lo = ksl_sum_error(n_g, n_g_lo, n_of_n_g), n = sqrt(n_of_n_g), n_product = n * n,
      n_product_error = ksl_product_error(n, n, n_product), n_rest = n_of_n_g - n_product,
      n_exact = n_rest - n_product_error, n_residual = n_exact + n_of_n_g_lo, n_twice = n + n,
      n_divisor = n == 0.0 ? 1.0 : n_twice, n_lo = n_residual / n_divisor;
  const double divisor = n == 0.0 ? 1.0 : n, divisor_lo = n == 0.0 ? 0.0 : n_lo;
  const double up = 1.0 < s ? s : 1.0;
  const double down = s < 1.0 ? s : 1.0;
  const double enlarged_0 = self->w * up;
  const double enlarged_1 = self->x * up;
  const double enlarged_2 = self->y * up;
  const double enlarged_3 = self->z * up;
  const double quotient_0_of_divisor = divisor + divisor_lo,
      quotient_0_of_divisor_lo = ksl_sum_error(divisor, divisor_lo, quotient_0_of_divisor),
      quotient_0 = enlarged_0 / quotient_0_of_divisor,
      quotient_0_cross = quotient_0 * quotient_0_of_divisor_lo,
      quotient_0_product = quotient_0 * quotient_0_of_divisor,
      quotient_0_product_error = ksl_product_error(quotient_0, quotient_0_of_divisor, quotient_0_product),
      quotient_0_rest = enlarged_0 - quotient_0_product,
      quotient_0_exact = quotient_0_rest - quotient_0_product_error,
      quotient_0_residual = quotient_0_exact - quotient_0_cross,
      quotient_0_lo = quotient_0_residual / quotient_0_of_divisor;
  const double quotient_1 = enlarged_1 / quotient_0_of_divisor,
      quotient_1_cross = quotient_1 * quotient_0_of_divisor_lo,
      quotient_1_product = quotient_1 * quotient_0_of_divisor,
      quotient_1_product_error = ksl_product_error(quotient_1, quotient_0_of_divisor, quotient_1_product),
      quotient_1_rest = enlarged_1 - quotient_1_product,
      quotient_1_exact = quotient_1_rest - quotient_1_product_error,
      quotient_1_residual = quotient_1_exact - quotient_1_cross,
      quotient_1_lo = quotient_1_residual / quotient_0_of_divisor;
  const double quotient_2 = enlarged_2 / quotient_0_of_divisor,
      quotient_2_cross = quotient_2 * quotient_0_of_divisor_lo,
      quotient_2_product = quotient_2 * quotient_0_of_divisor,
      quotient_2_product_error = ksl_product_error(quotient_2, quotient_0_of_divisor, quotient_2_product),
      quotient_2_rest = enlarged_2 - quotient_2_product,
      quotient_2_exact = quotient_2_rest - quotient_2_product_error,
      quotient_2_residual = quotient_2_exact - quotient_2_cross,
      quotient_2_lo = quotient_2_residual / quotient_0_of_divisor;
  const double quotient_3 = enlarged_3 / quotient_0_of_divisor,
      quotient_3_cross = quotient_3 * quotient_0_of_divisor_lo,
      quotient_3_product = quotient_3 * quotient_0_of_divisor,
      quotient_3_product_error = ksl_product_error(quotient_3, quotient_0_of_divisor, quotient_3_product),
      quotient_3_rest = enlarged_3 - quotient_3_product,
      quotient_3_exact = quotient_3_rest - quotient_3_product_error,
      quotient_3_residual = quotient_3_exact - quotient_3_cross,
      quotient_3_lo = quotient_3_residual / quotient_0_of_divisor;
  const double self_0_new_of_quotient_0 = quotient_0 + quotient_0_lo,
      self_0_new_of_quotient_0_lo = ksl_sum_error(quotient_0, quotient_0_lo, self_0_new_of_quotient_0),
      self_0_new = self_0_new_of_quotient_0 * down, self_0_new_inverse = 1.0 / down,
      self_0_new_back = self_0_new * self_0_new_inverse,
      self_0_new_lost = self_0_new_of_quotient_0 - self_0_new_back,
      self_0_new_rest = self_0_new_lost + self_0_new_of_quotient_0_lo,
      self_0_new_small = self_0_new_rest * down,
      self_0_new_lo = self_0_new_lost == 0.0 ? 0.0 : self_0_new_small;
  const double self_1_new_of_quotient_1 = quotient_1 + quotient_1_lo,
      self_1_new_of_quotient_1_lo = ksl_sum_error(quotient_1, quotient_1_lo, self_1_new_of_quotient_1),
      self_1_new = self_1_new_of_quotient_1 * down,
      self_1_new_back = self_1_new * self_0_new_inverse,
      self_1_new_lost = self_1_new_of_quotient_1 - self_1_new_back,
      self_1_new_rest = self_1_new_lost + self_1_new_of_quotient_1_lo,
      self_1_new_small = self_1_new_rest * down,
      self_1_new_lo = self_1_new_lost == 0.0 ? 0.0 : self_1_new_small;
  const double self_2_new_of_quotient_2 = quotient_2 + quotient_2_lo,
      self_2_new_of_quotient_2_lo = ksl_sum_error(quotient_2, quotient_2_lo, self_2_new_of_quotient_2),
      self_2_new = self_2_new_of_quotient_2 * down,
      self_2_new_back = self_2_new * self_0_new_inverse,
      self_2_new_lost = self_2_new_of_quotient_2 - self_2_new_back,
      self_2_new_rest = self_2_new_lost + self_2_new_of_quotient_2_lo,
      self_2_new_small = self_2_new_rest * down,
      self_2_new_lo = self_2_new_lost == 0.0 ? 0.0 : self_2_new_small;
  const double self_3_new_of_quotient_3 = quotient_3 + quotient_3_lo,
      self_3_new_of_quotient_3_lo = ksl_sum_error(quotient_3, quotient_3_lo, self_3_new_of_quotient_3),
      self_3_new = self_3_new_of_quotient_3 * down,
      self_3_new_back = self_3_new * self_0_new_inverse,
      self_3_new_lost = self_3_new_of_quotient_3 - self_3_new_back,
      self_3_new_rest = self_3_new_lost + self_3_new_of_quotient_3_lo,
      self_3_new_small = self_3_new_rest * down,
      self_3_new_lo = self_3_new_lost == 0.0 ? 0.0 : self_3_new_small;
  const double self_0_new_total = self_0_new + self_0_new_lo,
      self_0_new_rounded = self_0_new_total == self_0_new_total ? self_0_new_total : self_0_new;
  const double self_1_new_total = self_1_new + self_1_new_lo,
      self_1_new_rounded = self_1_new_total == self_1_new_total ? self_1_new_total : self_1_new;
  const double self_2_new_total = self_2_new + self_2_new_lo,
      self_2_new_rounded = self_2_new_total == self_2_new_total ? self_2_new_total : self_2_new;
  const double self_3_new_total = self_3_new + self_3_new_lo,
      self_3_new_rounded = self_3_new_total == self_3_new_total ? self_3_new_total : self_3_new;
  self->w = self_0_new_rounded;
  self->x = self_1_new_rounded;
  self->y = self_2_new_rounded;
  self->z = self_3_new_rounded;
}

/* qo = q / |q|; zero stays zero.
   q, qo: quaternion (w; x, y, z), the scalar first.
   33 mul, 43 add, 9 product error, 9 sum error, 10 div, 1 sqrt, 4 abs, 7 less, 10 equal, 18
     select. */
static inline void ksl_quaternion_normalized_accurate(const ksl_quaternion_t *q,
    ksl_quaternion_t *qo) {
  const double s_size_0 = fabs(q->w);
  const double s_size_1 = fabs(q->x);
  const double s_size_2 = fabs(q->y);
  const double s_size_3 = fabs(q->z);
  const double s_largest1 = s_size_0 < s_size_1 ? s_size_1 : s_size_0;
  const double s_largest2 = s_largest1 < s_size_2 ? s_size_2 : s_largest1;
  const double s_largest3 = s_largest2 < s_size_3 ? s_size_3 : s_largest2;
  const double s_b = 6.703903964971299e+153 < s_largest3 ? 3.7291703656001034e-155 : 1.0,
      s = s_largest3 < 3.4395525670743494e-136 ? 4.149515568880993e+180 : s_b;
  const double y_0 = q->w * s;
  const double y_1 = q->x * s;
  const double y_2 = q->y * s;
  const double y_3 = q->z * s;
  const double n_a = y_0 * y_0, n_a_lo = ksl_product_error(y_0, y_0, n_a), n_b = y_1 * y_1,
      n_b_lo = ksl_product_error(y_1, y_1, n_b), n_c = n_a + n_b,
      n_c_error = ksl_sum_error(n_a, n_b, n_c), n_c_lo1 = n_c_error + n_a_lo,
      n_c_lo = n_c_lo1 + n_b_lo, n_d = y_2 * y_2, n_d_lo = ksl_product_error(y_2, y_2, n_d),
      n_e = n_c + n_d, n_e_error = ksl_sum_error(n_c, n_d, n_e), n_e_lo1 = n_e_error + n_c_lo,
      n_e_lo = n_e_lo1 + n_d_lo, n_f = y_3 * y_3, n_f_lo = ksl_product_error(y_3, y_3, n_f),
      n_g = n_e + n_f, n_g_error = ksl_sum_error(n_e, n_f, n_g), n_g_lo1 = n_g_error + n_e_lo,
      n_g_lo = n_g_lo1 + n_f_lo, n_of_n_g = n_g + n_g_lo,
      n_of_n_g_lo = ksl_sum_error(n_g, n_g_lo, n_of_n_g), n = sqrt(n_of_n_g), n_product = n * n,
      n_product_error = ksl_product_error(n, n, n_product), n_rest = n_of_n_g - n_product,
      n_exact = n_rest - n_product_error, n_residual = n_exact + n_of_n_g_lo, n_twice = n + n,
      n_divisor = n == 0.0 ? 1.0 : n_twice, n_lo = n_residual / n_divisor;
  const double divisor = n == 0.0 ? 1.0 : n, divisor_lo = n == 0.0 ? 0.0 : n_lo;
  const double up = 1.0 < s ? s : 1.0;
  const double down = s < 1.0 ? s : 1.0;
  const double enlarged_0 = q->w * up;
  const double enlarged_1 = q->x * up;
  const double enlarged_2 = q->y * up;
  const double enlarged_3 = q->z * up;
  const double quotient_0_of_divisor = divisor + divisor_lo,
      quotient_0_of_divisor_lo = ksl_sum_error(divisor, divisor_lo, quotient_0_of_divisor),
      quotient_0 = enlarged_0 / quotient_0_of_divisor,
      quotient_0_cross = quotient_0 * quotient_0_of_divisor_lo,
      quotient_0_product = quotient_0 * quotient_0_of_divisor,
      quotient_0_product_error = ksl_product_error(quotient_0, quotient_0_of_divisor, quotient_0_product),
      quotient_0_rest = enlarged_0 - quotient_0_product,
      quotient_0_exact = quotient_0_rest - quotient_0_product_error,
      quotient_0_residual = quotient_0_exact - quotient_0_cross,
      quotient_0_lo = quotient_0_residual / quotient_0_of_divisor;
  const double quotient_1 = enlarged_1 / quotient_0_of_divisor,
      quotient_1_cross = quotient_1 * quotient_0_of_divisor_lo,
      quotient_1_product = quotient_1 * quotient_0_of_divisor,
      quotient_1_product_error = ksl_product_error(quotient_1, quotient_0_of_divisor, quotient_1_product),
      quotient_1_rest = enlarged_1 - quotient_1_product,
      quotient_1_exact = quotient_1_rest - quotient_1_product_error,
      quotient_1_residual = quotient_1_exact - quotient_1_cross,
      quotient_1_lo = quotient_1_residual / quotient_0_of_divisor;
  const double quotient_2 = enlarged_2 / quotient_0_of_divisor,
      quotient_2_cross = quotient_2 * quotient_0_of_divisor_lo,
      quotient_2_product = quotient_2 * quotient_0_of_divisor,
      quotient_2_product_error = ksl_product_error(quotient_2, quotient_0_of_divisor, quotient_2_product),
      quotient_2_rest = enlarged_2 - quotient_2_product,
      quotient_2_exact = quotient_2_rest - quotient_2_product_error,
      quotient_2_residual = quotient_2_exact - quotient_2_cross,
      quotient_2_lo = quotient_2_residual / quotient_0_of_divisor;
  const double quotient_3 = enlarged_3 / quotient_0_of_divisor,
      quotient_3_cross = quotient_3 * quotient_0_of_divisor_lo,
      quotient_3_product = quotient_3 * quotient_0_of_divisor,
      quotient_3_product_error = ksl_product_error(quotient_3, quotient_0_of_divisor, quotient_3_product),
      quotient_3_rest = enlarged_3 - quotient_3_product,
      quotient_3_exact = quotient_3_rest - quotient_3_product_error,
      quotient_3_residual = quotient_3_exact - quotient_3_cross,
      quotient_3_lo = quotient_3_residual / quotient_0_of_divisor;
  const double qo_0_of_quotient_0 = quotient_0 + quotient_0_lo,
      qo_0_of_quotient_0_lo = ksl_sum_error(quotient_0, quotient_0_lo, qo_0_of_quotient_0),
      qo_0 = qo_0_of_quotient_0 * down, qo_0_inverse = 1.0 / down, qo_0_back = qo_0 * qo_0_inverse,
      qo_0_lost = qo_0_of_quotient_0 - qo_0_back, qo_0_rest = qo_0_lost + qo_0_of_quotient_0_lo,
      qo_0_small = qo_0_rest * down, qo_0_lo = qo_0_lost == 0.0 ? 0.0 : qo_0_small;
  const double qo_1_of_quotient_1 = quotient_1 + quotient_1_lo,
      qo_1_of_quotient_1_lo = ksl_sum_error(quotient_1, quotient_1_lo, qo_1_of_quotient_1),
      qo_1 = qo_1_of_quotient_1 * down, qo_1_back = qo_1 * qo_0_inverse,
      qo_1_lost = qo_1_of_quotient_1 - qo_1_back, qo_1_rest = qo_1_lost + qo_1_of_quotient_1_lo,
      qo_1_small = qo_1_rest * down, qo_1_lo = qo_1_lost == 0.0 ? 0.0 : qo_1_small;
  const double qo_2_of_quotient_2 = quotient_2 + quotient_2_lo,
      qo_2_of_quotient_2_lo = ksl_sum_error(quotient_2, quotient_2_lo, qo_2_of_quotient_2),
      qo_2 = qo_2_of_quotient_2 * down, qo_2_back = qo_2 * qo_0_inverse,
      qo_2_lost = qo_2_of_quotient_2 - qo_2_back, qo_2_rest = qo_2_lost + qo_2_of_quotient_2_lo,
      qo_2_small = qo_2_rest * down, qo_2_lo = qo_2_lost == 0.0 ? 0.0 : qo_2_small;
  const double qo_3_of_quotient_3 = quotient_3 + quotient_3_lo,
      qo_3_of_quotient_3_lo = ksl_sum_error(quotient_3, quotient_3_lo, qo_3_of_quotient_3),
      qo_3 = qo_3_of_quotient_3 * down, qo_3_back = qo_3 * qo_0_inverse,
      qo_3_lost = qo_3_of_quotient_3 - qo_3_back, qo_3_rest = qo_3_lost + qo_3_of_quotient_3_lo,
      qo_3_small = qo_3_rest * down, qo_3_lo = qo_3_lost == 0.0 ? 0.0 : qo_3_small;
  const double qo_0_total = qo_0 + qo_0_lo,
      qo_0_rounded = qo_0_total == qo_0_total ? qo_0_total : qo_0;
  const double qo_1_total = qo_1 + qo_1_lo,
      qo_1_rounded = qo_1_total == qo_1_total ? qo_1_total : qo_1;
  const double qo_2_total = qo_2 + qo_2_lo,
      qo_2_rounded = qo_2_total == qo_2_total ? qo_2_total : qo_2;
  const double qo_3_total = qo_3 + qo_3_lo,
      qo_3_rounded = qo_3_total == qo_3_total ? qo_3_total : qo_3;
  qo->w = qo_0_rounded;
  qo->x = qo_1_rounded;
  qo->y = qo_2_rounded;
  qo->z = qo_3_rounded;
}

/* qo = q1 q2 = (w1 w2 - v1·v2; w1 v2 + w2 v1 + v1 × v2).
   q1, q2, qo: quaternion (w; x, y, z), the scalar first.
   16 mul, 40 add, 16 product error, 12 sum error.
   Error <= u |result| + (w: 15, v: 16) u^2 S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_qq_accurate(const ksl_quaternion_t *q1, const ksl_quaternion_t *q2,
    ksl_quaternion_t *qo) {
  const double qo_0a = q1->w * q2->w, qo_0a_lo = ksl_product_error(q1->w, q2->w, qo_0a),
      qo_0b = q1->x * q2->x, qo_0b_lo = ksl_product_error(q1->x, q2->x, qo_0b),
      qo_0c = q1->y * q2->y, qo_0c_lo = ksl_product_error(q1->y, q2->y, qo_0c),
      qo_0d = qo_0b + qo_0c, qo_0d_error = ksl_sum_error(qo_0b, qo_0c, qo_0d),
      qo_0d_lo1 = qo_0d_error + qo_0b_lo, qo_0d_lo = qo_0d_lo1 + qo_0c_lo, qo_0e = q1->z * q2->z,
      qo_0e_lo = ksl_product_error(q1->z, q2->z, qo_0e), qo_0f = qo_0d + qo_0e,
      qo_0f_error = ksl_sum_error(qo_0d, qo_0e, qo_0f), qo_0f_lo1 = qo_0f_error + qo_0d_lo,
      qo_0f_lo = qo_0f_lo1 + qo_0e_lo, qo_0 = qo_0a - qo_0f,
      qo_0_error = ksl_difference_error(qo_0a, qo_0f, qo_0), qo_0_lo1 = qo_0_error + qo_0a_lo,
      qo_0_lo = qo_0_lo1 - qo_0f_lo;
  const double qo_1a = q1->w * q2->x, qo_1a_lo = ksl_product_error(q1->w, q2->x, qo_1a),
      qo_1b = q1->x * q2->w, qo_1b_lo = ksl_product_error(q1->x, q2->w, qo_1b),
      qo_1c = qo_1a + qo_1b, qo_1c_error = ksl_sum_error(qo_1a, qo_1b, qo_1c),
      qo_1c_lo1 = qo_1c_error + qo_1a_lo, qo_1c_lo = qo_1c_lo1 + qo_1b_lo, qo_1d = q1->y * q2->z,
      qo_1d_lo = ksl_product_error(q1->y, q2->z, qo_1d), qo_1e = q1->z * q2->y,
      qo_1e_lo = ksl_product_error(q1->z, q2->y, qo_1e), qo_1f = qo_1d - qo_1e,
      qo_1f_error = ksl_difference_error(qo_1d, qo_1e, qo_1f), qo_1f_lo1 = qo_1f_error + qo_1d_lo,
      qo_1f_lo = qo_1f_lo1 - qo_1e_lo, qo_1 = qo_1c + qo_1f,
      qo_1_error = ksl_sum_error(qo_1c, qo_1f, qo_1), qo_1_lo1 = qo_1_error + qo_1c_lo,
      qo_1_lo = qo_1_lo1 + qo_1f_lo;
  const double qo_2a = q1->w * q2->y, qo_2a_lo = ksl_product_error(q1->w, q2->y, qo_2a),
      qo_2b = q1->z * q2->x, qo_2b_lo = ksl_product_error(q1->z, q2->x, qo_2b),
      qo_2c = q1->x * q2->z, qo_2c_lo = ksl_product_error(q1->x, q2->z, qo_2c),
      qo_2d = qo_2b - qo_2c, qo_2d_error = ksl_difference_error(qo_2b, qo_2c, qo_2d),
      qo_2d_lo1 = qo_2d_error + qo_2b_lo, qo_2d_lo = qo_2d_lo1 - qo_2c_lo, qo_2e = qo_2a + qo_2d,
      qo_2e_error = ksl_sum_error(qo_2a, qo_2d, qo_2e), qo_2e_lo1 = qo_2e_error + qo_2a_lo,
      qo_2e_lo = qo_2e_lo1 + qo_2d_lo, qo_2f = q1->y * q2->w,
      qo_2f_lo = ksl_product_error(q1->y, q2->w, qo_2f), qo_2 = qo_2e + qo_2f,
      qo_2_error = ksl_sum_error(qo_2e, qo_2f, qo_2), qo_2_lo1 = qo_2_error + qo_2e_lo,
      qo_2_lo = qo_2_lo1 + qo_2f_lo;
  const double qo_3a = q1->w * q2->z, qo_3a_lo = ksl_product_error(q1->w, q2->z, qo_3a),
      qo_3b = q1->x * q2->y, qo_3b_lo = ksl_product_error(q1->x, q2->y, qo_3b),
      qo_3c = q1->y * q2->x, qo_3c_lo = ksl_product_error(q1->y, q2->x, qo_3c),
      qo_3d = qo_3b - qo_3c, qo_3d_error = ksl_difference_error(qo_3b, qo_3c, qo_3d),
      qo_3d_lo1 = qo_3d_error + qo_3b_lo, qo_3d_lo = qo_3d_lo1 - qo_3c_lo, qo_3e = qo_3a + qo_3d,
      qo_3e_error = ksl_sum_error(qo_3a, qo_3d, qo_3e), qo_3e_lo1 = qo_3e_error + qo_3a_lo,
      qo_3e_lo = qo_3e_lo1 + qo_3d_lo, qo_3f = q1->z * q2->w,
      qo_3f_lo = ksl_product_error(q1->z, q2->w, qo_3f), qo_3 = qo_3e + qo_3f,
      qo_3_error = ksl_sum_error(qo_3e, qo_3f, qo_3), qo_3_lo1 = qo_3_error + qo_3e_lo,
      qo_3_lo = qo_3_lo1 + qo_3f_lo;
  const double qo_0_rounded = qo_0 + qo_0_lo;
  const double qo_1_rounded = qo_1 + qo_1_lo;
  const double qo_2_rounded = qo_2 + qo_2_lo;
  const double qo_3_rounded = qo_3 + qo_3_lo;
  qo->w = qo_0_rounded;
  qo->x = qo_1_rounded;
  qo->y = qo_2_rounded;
  qo->z = qo_3_rounded;
}

/* qo = q1* q2, q1* the conjugate.
   q1, q2, qo: quaternion (w; x, y, z), the scalar first.
   16 mul, 40 add, 16 product error, 12 sum error.
   Error <= u |result| + (w: 15, v: 10) u^2 S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_qconjq_accurate(const ksl_quaternion_t *q1,
    const ksl_quaternion_t *q2, ksl_quaternion_t *qo) {
  const double qo_0a = q1->w * q2->w, qo_0a_lo = ksl_product_error(q1->w, q2->w, qo_0a),
      qo_0b = q1->x * q2->x, qo_0b_lo = ksl_product_error(q1->x, q2->x, qo_0b),
      qo_0c = q1->y * q2->y, qo_0c_lo = ksl_product_error(q1->y, q2->y, qo_0c),
      qo_0d = qo_0b + qo_0c, qo_0d_error = ksl_sum_error(qo_0b, qo_0c, qo_0d),
      qo_0d_lo1 = qo_0d_error + qo_0b_lo, qo_0d_lo = qo_0d_lo1 + qo_0c_lo, qo_0e = q1->z * q2->z,
      qo_0e_lo = ksl_product_error(q1->z, q2->z, qo_0e), qo_0f = qo_0d + qo_0e,
      qo_0f_error = ksl_sum_error(qo_0d, qo_0e, qo_0f), qo_0f_lo1 = qo_0f_error + qo_0d_lo,
      qo_0f_lo = qo_0f_lo1 + qo_0e_lo, qo_0 = qo_0a + qo_0f,
      qo_0_error = ksl_sum_error(qo_0a, qo_0f, qo_0), qo_0_lo1 = qo_0_error + qo_0a_lo,
      qo_0_lo = qo_0_lo1 + qo_0f_lo;
  const double qo_1a = q1->w * q2->x, qo_1a_lo = ksl_product_error(q1->w, q2->x, qo_1a),
      qo_1b = q1->x * q2->w, qo_1b_lo = ksl_product_error(q1->x, q2->w, qo_1b),
      qo_1c = qo_1a - qo_1b, qo_1c_error = ksl_difference_error(qo_1a, qo_1b, qo_1c),
      qo_1c_lo1 = qo_1c_error + qo_1a_lo, qo_1c_lo = qo_1c_lo1 - qo_1b_lo, qo_1d = q1->z * q2->y,
      qo_1d_lo = ksl_product_error(q1->z, q2->y, qo_1d), qo_1e = q1->y * q2->z,
      qo_1e_lo = ksl_product_error(q1->y, q2->z, qo_1e), qo_1f = qo_1d - qo_1e,
      qo_1f_error = ksl_difference_error(qo_1d, qo_1e, qo_1f), qo_1f_lo1 = qo_1f_error + qo_1d_lo,
      qo_1f_lo = qo_1f_lo1 - qo_1e_lo, qo_1 = qo_1c + qo_1f,
      qo_1_error = ksl_sum_error(qo_1c, qo_1f, qo_1), qo_1_lo1 = qo_1_error + qo_1c_lo,
      qo_1_lo = qo_1_lo1 + qo_1f_lo;
  const double qo_2a = q1->w * q2->y, qo_2a_lo = ksl_product_error(q1->w, q2->y, qo_2a),
      qo_2b = q1->y * q2->w, qo_2b_lo = ksl_product_error(q1->y, q2->w, qo_2b),
      qo_2c = qo_2a - qo_2b, qo_2c_error = ksl_difference_error(qo_2a, qo_2b, qo_2c),
      qo_2c_lo1 = qo_2c_error + qo_2a_lo, qo_2c_lo = qo_2c_lo1 - qo_2b_lo, qo_2d = q1->x * q2->z,
      qo_2d_lo = ksl_product_error(q1->x, q2->z, qo_2d), qo_2e = q1->z * q2->x,
      qo_2e_lo = ksl_product_error(q1->z, q2->x, qo_2e), qo_2f = qo_2d - qo_2e,
      qo_2f_error = ksl_difference_error(qo_2d, qo_2e, qo_2f), qo_2f_lo1 = qo_2f_error + qo_2d_lo,
      qo_2f_lo = qo_2f_lo1 - qo_2e_lo, qo_2 = qo_2c + qo_2f,
      qo_2_error = ksl_sum_error(qo_2c, qo_2f, qo_2), qo_2_lo1 = qo_2_error + qo_2c_lo,
      qo_2_lo = qo_2_lo1 + qo_2f_lo;
  const double qo_3a = q1->w * q2->z, qo_3a_lo = ksl_product_error(q1->w, q2->z, qo_3a),
      qo_3b = q1->z * q2->w, qo_3b_lo = ksl_product_error(q1->z, q2->w, qo_3b),
      qo_3c = qo_3a - qo_3b, qo_3c_error = ksl_difference_error(qo_3a, qo_3b, qo_3c),
      qo_3c_lo1 = qo_3c_error + qo_3a_lo, qo_3c_lo = qo_3c_lo1 - qo_3b_lo, qo_3d = q1->y * q2->x,
      qo_3d_lo = ksl_product_error(q1->y, q2->x, qo_3d), qo_3e = q1->x * q2->y,
      qo_3e_lo = ksl_product_error(q1->x, q2->y, qo_3e), qo_3f = qo_3d - qo_3e,
      qo_3f_error = ksl_difference_error(qo_3d, qo_3e, qo_3f), qo_3f_lo1 = qo_3f_error + qo_3d_lo,
      qo_3f_lo = qo_3f_lo1 - qo_3e_lo, qo_3 = qo_3c + qo_3f,
      qo_3_error = ksl_sum_error(qo_3c, qo_3f, qo_3), qo_3_lo1 = qo_3_error + qo_3c_lo,
      qo_3_lo = qo_3_lo1 + qo_3f_lo;
  const double qo_0_rounded = qo_0 + qo_0_lo;
  const double qo_1_rounded = qo_1 + qo_1_lo;
  const double qo_2_rounded = qo_2 + qo_2_lo;
  const double qo_3_rounded = qo_3 + qo_3_lo;
  qo->w = qo_0_rounded;
  qo->x = qo_1_rounded;
  qo->y = qo_2_rounded;
  qo->z = qo_3_rounded;
}

/* qo = q1 q2*, q2* the conjugate.
   q1, q2, qo: quaternion (w; x, y, z), the scalar first.
   16 mul, 40 add, 16 product error, 12 sum error.
   Error <= u |result| + (w: 15, v: 10) u^2 S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_qqconj_accurate(const ksl_quaternion_t *q1,
    const ksl_quaternion_t *q2, ksl_quaternion_t *qo) {
  const double qo_0a = q1->w * q2->w, qo_0a_lo = ksl_product_error(q1->w, q2->w, qo_0a),
      qo_0b = q1->x * q2->x, qo_0b_lo = ksl_product_error(q1->x, q2->x, qo_0b),
      qo_0c = q1->y * q2->y, qo_0c_lo = ksl_product_error(q1->y, q2->y, qo_0c),
      qo_0d = qo_0b + qo_0c, qo_0d_error = ksl_sum_error(qo_0b, qo_0c, qo_0d),
      qo_0d_lo1 = qo_0d_error + qo_0b_lo, qo_0d_lo = qo_0d_lo1 + qo_0c_lo, qo_0e = q1->z * q2->z,
      qo_0e_lo = ksl_product_error(q1->z, q2->z, qo_0e), qo_0f = qo_0d + qo_0e,
      qo_0f_error = ksl_sum_error(qo_0d, qo_0e, qo_0f), qo_0f_lo1 = qo_0f_error + qo_0d_lo,
      qo_0f_lo = qo_0f_lo1 + qo_0e_lo, qo_0 = qo_0a + qo_0f,
      qo_0_error = ksl_sum_error(qo_0a, qo_0f, qo_0), qo_0_lo1 = qo_0_error + qo_0a_lo,
      qo_0_lo = qo_0_lo1 + qo_0f_lo;
  const double qo_1a = q1->x * q2->w, qo_1a_lo = ksl_product_error(q1->x, q2->w, qo_1a),
      qo_1b = q1->w * q2->x, qo_1b_lo = ksl_product_error(q1->w, q2->x, qo_1b),
      qo_1c = qo_1a - qo_1b, qo_1c_error = ksl_difference_error(qo_1a, qo_1b, qo_1c),
      qo_1c_lo1 = qo_1c_error + qo_1a_lo, qo_1c_lo = qo_1c_lo1 - qo_1b_lo, qo_1d = q1->z * q2->y,
      qo_1d_lo = ksl_product_error(q1->z, q2->y, qo_1d), qo_1e = q1->y * q2->z,
      qo_1e_lo = ksl_product_error(q1->y, q2->z, qo_1e), qo_1f = qo_1d - qo_1e,
      qo_1f_error = ksl_difference_error(qo_1d, qo_1e, qo_1f), qo_1f_lo1 = qo_1f_error + qo_1d_lo,
      qo_1f_lo = qo_1f_lo1 - qo_1e_lo, qo_1 = qo_1c + qo_1f,
      qo_1_error = ksl_sum_error(qo_1c, qo_1f, qo_1), qo_1_lo1 = qo_1_error + qo_1c_lo,
      qo_1_lo = qo_1_lo1 + qo_1f_lo;
  const double qo_2a = q1->y * q2->w, qo_2a_lo = ksl_product_error(q1->y, q2->w, qo_2a),
      qo_2b = q1->w * q2->y, qo_2b_lo = ksl_product_error(q1->w, q2->y, qo_2b),
      qo_2c = qo_2a - qo_2b, qo_2c_error = ksl_difference_error(qo_2a, qo_2b, qo_2c),
      qo_2c_lo1 = qo_2c_error + qo_2a_lo, qo_2c_lo = qo_2c_lo1 - qo_2b_lo, qo_2d = q1->x * q2->z,
      qo_2d_lo = ksl_product_error(q1->x, q2->z, qo_2d), qo_2e = q1->z * q2->x,
      qo_2e_lo = ksl_product_error(q1->z, q2->x, qo_2e), qo_2f = qo_2d - qo_2e,
      qo_2f_error = ksl_difference_error(qo_2d, qo_2e, qo_2f), qo_2f_lo1 = qo_2f_error + qo_2d_lo,
      qo_2f_lo = qo_2f_lo1 - qo_2e_lo, qo_2 = qo_2c + qo_2f,
      qo_2_error = ksl_sum_error(qo_2c, qo_2f, qo_2), qo_2_lo1 = qo_2_error + qo_2c_lo,
      qo_2_lo = qo_2_lo1 + qo_2f_lo;
  const double qo_3a = q1->z * q2->w, qo_3a_lo = ksl_product_error(q1->z, q2->w, qo_3a),
      qo_3b = q1->w * q2->z, qo_3b_lo = ksl_product_error(q1->w, q2->z, qo_3b),
      qo_3c = qo_3a - qo_3b, qo_3c_error = ksl_difference_error(qo_3a, qo_3b, qo_3c),
      qo_3c_lo1 = qo_3c_error + qo_3a_lo, qo_3c_lo = qo_3c_lo1 - qo_3b_lo, qo_3d = q1->y * q2->x,
      qo_3d_lo = ksl_product_error(q1->y, q2->x, qo_3d), qo_3e = q1->x * q2->y,
      qo_3e_lo = ksl_product_error(q1->x, q2->y, qo_3e), qo_3f = qo_3d - qo_3e,
      qo_3f_error = ksl_difference_error(qo_3d, qo_3e, qo_3f), qo_3f_lo1 = qo_3f_error + qo_3d_lo,
      qo_3f_lo = qo_3f_lo1 - qo_3e_lo, qo_3 = qo_3c + qo_3f,
      qo_3_error = ksl_sum_error(qo_3c, qo_3f, qo_3), qo_3_lo1 = qo_3_error + qo_3c_lo,
      qo_3_lo = qo_3_lo1 + qo_3f_lo;
  const double qo_0_rounded = qo_0 + qo_0_lo;
  const double qo_1_rounded = qo_1 + qo_1_lo;
  const double qo_2_rounded = qo_2 + qo_2_lo;
  const double qo_3_rounded = qo_3 + qo_3_lo;
  qo->w = qo_0_rounded;
  qo->x = qo_1_rounded;
  qo->y = qo_2_rounded;
  qo->z = qo_3_rounded;
}

/* vo = R(q) v, |q| = 1.
   q: quaternion (w; x, y, z), the scalar first; v, vo: vector.
   30 mul, 48 add, 18 product error, 12 sum error.
   Error <= u |result| + 40 u^2 S, S the sum of the |terms| of the expanded formula; barring
     over- and underflow. */
static inline void ksl_product_qv_accurate(const ksl_quaternion_t *q, const ksl_vec3_t *v,
    ksl_vec3_t *vo) {
  const double c_0a = q->y * v->z, c_0a_lo = ksl_product_error(q->y, v->z, c_0a),
      c_0b = q->z * v->y, c_0b_lo = ksl_product_error(q->z, v->y, c_0b), c_0 = c_0a - c_0b,
      c_0_error = ksl_difference_error(c_0a, c_0b, c_0), c_0_lo1 = c_0_error + c_0a_lo,
      c_0_lo = c_0_lo1 - c_0b_lo;
  const double c_1a = q->z * v->x, c_1a_lo = ksl_product_error(q->z, v->x, c_1a),
      c_1b = q->x * v->z, c_1b_lo = ksl_product_error(q->x, v->z, c_1b), c_1 = c_1a - c_1b,
      c_1_error = ksl_difference_error(c_1a, c_1b, c_1), c_1_lo1 = c_1_error + c_1a_lo,
      c_1_lo = c_1_lo1 - c_1b_lo;
  const double c_2a = q->x * v->y, c_2a_lo = ksl_product_error(q->x, v->y, c_2a),
      c_2b = q->y * v->x, c_2b_lo = ksl_product_error(q->y, v->x, c_2b), c_2 = c_2a - c_2b,
      c_2_error = ksl_difference_error(c_2a, c_2b, c_2), c_2_lo1 = c_2_error + c_2a_lo,
      c_2_lo = c_2_lo1 - c_2b_lo;
  const double t_0 = 2.0 * c_0, t_0_cross1 = 2.0 * c_0_lo,
      t_0_error = ksl_product_error(2.0, c_0, t_0), t_0_lo = t_0_error + t_0_cross1;
  const double t_1 = 2.0 * c_1, t_1_cross1 = 2.0 * c_1_lo,
      t_1_error = ksl_product_error(2.0, c_1, t_1), t_1_lo = t_1_error + t_1_cross1;
  const double t_2 = 2.0 * c_2, t_2_cross1 = 2.0 * c_2_lo,
      t_2_error = ksl_product_error(2.0, c_2, t_2), t_2_lo = t_2_error + t_2_cross1;
  const double turn_0a = q->w * t_0, turn_0a_cross1 = q->w * t_0_lo,
      turn_0a_error = ksl_product_error(q->w, t_0, turn_0a),
      turn_0a_lo = turn_0a_error + turn_0a_cross1, turn_0b = q->y * t_2,
      turn_0b_cross1 = q->y * t_2_lo, turn_0b_error = ksl_product_error(q->y, t_2, turn_0b),
      turn_0b_lo = turn_0b_error + turn_0b_cross1, turn_0c = q->z * t_1,
      turn_0c_cross1 = q->z * t_1_lo, turn_0c_error = ksl_product_error(q->z, t_1, turn_0c),
      turn_0c_lo = turn_0c_error + turn_0c_cross1, turn_0d = turn_0b - turn_0c,
      turn_0d_error = ksl_difference_error(turn_0b, turn_0c, turn_0d),
      turn_0d_lo1 = turn_0d_error + turn_0b_lo, turn_0d_lo = turn_0d_lo1 - turn_0c_lo,
      turn_0 = turn_0a + turn_0d, turn_0_error = ksl_sum_error(turn_0a, turn_0d, turn_0),
      turn_0_lo1 = turn_0_error + turn_0a_lo, turn_0_lo = turn_0_lo1 + turn_0d_lo;
  const double turn_1a = q->w * t_1, turn_1a_cross1 = q->w * t_1_lo,
      turn_1a_error = ksl_product_error(q->w, t_1, turn_1a),
      turn_1a_lo = turn_1a_error + turn_1a_cross1, turn_1b = q->z * t_0,
      turn_1b_cross1 = q->z * t_0_lo, turn_1b_error = ksl_product_error(q->z, t_0, turn_1b),
      turn_1b_lo = turn_1b_error + turn_1b_cross1, turn_1c = q->x * t_2,
      turn_1c_cross1 = q->x * t_2_lo, turn_1c_error = ksl_product_error(q->x, t_2, turn_1c),
      turn_1c_lo = turn_1c_error + turn_1c_cross1, turn_1d = turn_1b - turn_1c,
      turn_1d_error = ksl_difference_error(turn_1b, turn_1c, turn_1d),
      turn_1d_lo1 = turn_1d_error + turn_1b_lo, turn_1d_lo = turn_1d_lo1 - turn_1c_lo,
      turn_1 = turn_1a + turn_1d, turn_1_error = ksl_sum_error(turn_1a, turn_1d, turn_1),
      turn_1_lo1 = turn_1_error + turn_1a_lo, turn_1_lo = turn_1_lo1 + turn_1d_lo;
  const double turn_2a = q->w * t_2, turn_2a_cross1 = q->w * t_2_lo,
      turn_2a_error = ksl_product_error(q->w, t_2, turn_2a),
      turn_2a_lo = turn_2a_error + turn_2a_cross1, turn_2b = q->x * t_1,
      turn_2b_cross1 = q->x * t_1_lo, turn_2b_error = ksl_product_error(q->x, t_1, turn_2b),
      turn_2b_lo = turn_2b_error + turn_2b_cross1, turn_2c = q->y * t_0,
      turn_2c_cross1 = q->y * t_0_lo, turn_2c_error = ksl_product_error(q->y, t_0, turn_2c),
      turn_2c_lo = turn_2c_error + turn_2c_cross1, turn_2d = turn_2b - turn_2c,
      turn_2d_error = ksl_difference_error(turn_2b, turn_2c, turn_2d),
      turn_2d_lo1 = turn_2d_error + turn_2b_lo, turn_2d_lo = turn_2d_lo1 - turn_2c_lo,
      turn_2 = turn_2a + turn_2d, turn_2_error = ksl_sum_error(turn_2a, turn_2d, turn_2),
      turn_2_lo1 = turn_2_error + turn_2a_lo, turn_2_lo = turn_2_lo1 + turn_2d_lo;
  const double vo_0 = v->x + turn_0, vo_0_error = ksl_sum_error(v->x, turn_0, vo_0),
      vo_0_lo = vo_0_error + turn_0_lo;
  const double vo_1 = v->y + turn_1, vo_1_error = ksl_sum_error(v->y, turn_1, vo_1),
      vo_1_lo = vo_1_error + turn_1_lo;
  const double vo_2 = v->z + turn_2, vo_2_error = ksl_sum_error(v->z, turn_2, vo_2),
      vo_2_lo = vo_2_error + turn_2_lo;
  const double vo_0_rounded = vo_0 + vo_0_lo;
  const double vo_1_rounded = vo_1 + vo_1_lo;
  const double vo_2_rounded = vo_2 + vo_2_lo;
  vo->x = vo_0_rounded;
  vo->y = vo_1_rounded;
  vo->z = vo_2_rounded;
}

/* vo = R(q)^T v, |q| = 1.
   q: quaternion (w; x, y, z), the scalar first; v, vo: vector.
   30 mul, 48 add, 18 product error, 12 sum error.
   Error <= u |result| + 40 u^2 S, S the sum of the |terms| of the expanded formula; barring
     over- and underflow. */
static inline void ksl_product_qconjv_accurate(const ksl_quaternion_t *q, const ksl_vec3_t *v,
    ksl_vec3_t *vo) {
  const double c_0a = q->z * v->y, c_0a_lo = ksl_product_error(q->z, v->y, c_0a),
      c_0b = q->y * v->z, c_0b_lo = ksl_product_error(q->y, v->z, c_0b), c_0 = c_0a - c_0b,
      c_0_error = ksl_difference_error(c_0a, c_0b, c_0), c_0_lo1 = c_0_error + c_0a_lo,
      c_0_lo = c_0_lo1 - c_0b_lo;
  const double c_1a = q->x * v->z, c_1a_lo = ksl_product_error(q->x, v->z, c_1a),
      c_1b = q->z * v->x, c_1b_lo = ksl_product_error(q->z, v->x, c_1b), c_1 = c_1a - c_1b,
      c_1_error = ksl_difference_error(c_1a, c_1b, c_1), c_1_lo1 = c_1_error + c_1a_lo,
      c_1_lo = c_1_lo1 - c_1b_lo;
  const double c_2a = q->y * v->x, c_2a_lo = ksl_product_error(q->y, v->x, c_2a),
      c_2b = q->x * v->y, c_2b_lo = ksl_product_error(q->x, v->y, c_2b), c_2 = c_2a - c_2b,
      c_2_error = ksl_difference_error(c_2a, c_2b, c_2), c_2_lo1 = c_2_error + c_2a_lo,
      c_2_lo = c_2_lo1 - c_2b_lo;
  const double t_0 = 2.0 * c_0, t_0_cross1 = 2.0 * c_0_lo,
      t_0_error = ksl_product_error(2.0, c_0, t_0), t_0_lo = t_0_error + t_0_cross1;
  const double t_1 = 2.0 * c_1, t_1_cross1 = 2.0 * c_1_lo,
      t_1_error = ksl_product_error(2.0, c_1, t_1), t_1_lo = t_1_error + t_1_cross1;
  const double t_2 = 2.0 * c_2, t_2_cross1 = 2.0 * c_2_lo,
      t_2_error = ksl_product_error(2.0, c_2, t_2), t_2_lo = t_2_error + t_2_cross1;
  const double turn_0a = q->w * t_0, turn_0a_cross1 = q->w * t_0_lo,
      turn_0a_error = ksl_product_error(q->w, t_0, turn_0a),
      turn_0a_lo = turn_0a_error + turn_0a_cross1, turn_0b = q->z * t_1,
      turn_0b_cross1 = q->z * t_1_lo, turn_0b_error = ksl_product_error(q->z, t_1, turn_0b),
      turn_0b_lo = turn_0b_error + turn_0b_cross1, turn_0c = q->y * t_2,
      turn_0c_cross1 = q->y * t_2_lo, turn_0c_error = ksl_product_error(q->y, t_2, turn_0c),
      turn_0c_lo = turn_0c_error + turn_0c_cross1, turn_0d = turn_0b - turn_0c,
      turn_0d_error = ksl_difference_error(turn_0b, turn_0c, turn_0d),
      turn_0d_lo1 = turn_0d_error + turn_0b_lo, turn_0d_lo = turn_0d_lo1 - turn_0c_lo,
      turn_0 = turn_0a + turn_0d, turn_0_error = ksl_sum_error(turn_0a, turn_0d, turn_0),
      turn_0_lo1 = turn_0_error + turn_0a_lo, turn_0_lo = turn_0_lo1 + turn_0d_lo;
  const double turn_1a = q->w * t_1, turn_1a_cross1 = q->w * t_1_lo,
      turn_1a_error = ksl_product_error(q->w, t_1, turn_1a),
      turn_1a_lo = turn_1a_error + turn_1a_cross1, turn_1b = q->x * t_2,
      turn_1b_cross1 = q->x * t_2_lo, turn_1b_error = ksl_product_error(q->x, t_2, turn_1b),
      turn_1b_lo = turn_1b_error + turn_1b_cross1, turn_1c = q->z * t_0,
      turn_1c_cross1 = q->z * t_0_lo, turn_1c_error = ksl_product_error(q->z, t_0, turn_1c),
      turn_1c_lo = turn_1c_error + turn_1c_cross1, turn_1d = turn_1b - turn_1c,
      turn_1d_error = ksl_difference_error(turn_1b, turn_1c, turn_1d),
      turn_1d_lo1 = turn_1d_error + turn_1b_lo, turn_1d_lo = turn_1d_lo1 - turn_1c_lo,
      turn_1 = turn_1a + turn_1d, turn_1_error = ksl_sum_error(turn_1a, turn_1d, turn_1),
      turn_1_lo1 = turn_1_error + turn_1a_lo, turn_1_lo = turn_1_lo1 + turn_1d_lo;
  const double turn_2a = q->w * t_2, turn_2a_cross1 = q->w * t_2_lo,
      turn_2a_error = ksl_product_error(q->w, t_2, turn_2a),
      turn_2a_lo = turn_2a_error + turn_2a_cross1, turn_2b = q->y * t_0,
      turn_2b_cross1 = q->y * t_0_lo, turn_2b_error = ksl_product_error(q->y, t_0, turn_2b),
      turn_2b_lo = turn_2b_error + turn_2b_cross1, turn_2c = q->x * t_1,
      turn_2c_cross1 = q->x * t_1_lo, turn_2c_error = ksl_product_error(q->x, t_1, turn_2c),
      turn_2c_lo = turn_2c_error + turn_2c_cross1, turn_2d = turn_2b - turn_2c,
      turn_2d_error = ksl_difference_error(turn_2b, turn_2c, turn_2d),
      turn_2d_lo1 = turn_2d_error + turn_2b_lo, turn_2d_lo = turn_2d_lo1 - turn_2c_lo,
      turn_2 = turn_2a + turn_2d, turn_2_error = ksl_sum_error(turn_2a, turn_2d, turn_2),
      turn_2_lo1 = turn_2_error + turn_2a_lo, turn_2_lo = turn_2_lo1 + turn_2d_lo;
  const double vo_0 = v->x + turn_0, vo_0_error = ksl_sum_error(v->x, turn_0, vo_0),
      vo_0_lo = vo_0_error + turn_0_lo;
  const double vo_1 = v->y + turn_1, vo_1_error = ksl_sum_error(v->y, turn_1, vo_1),
      vo_1_lo = vo_1_error + turn_1_lo;
  const double vo_2 = v->z + turn_2, vo_2_error = ksl_sum_error(v->z, turn_2, vo_2),
      vo_2_lo = vo_2_error + turn_2_lo;
  const double vo_0_rounded = vo_0 + vo_0_lo;
  const double vo_1_rounded = vo_1 + vo_1_lo;
  const double vo_2_rounded = vo_2 + vo_2_lo;
  vo->x = vo_0_rounded;
  vo->y = vo_1_rounded;
  vo->z = vo_2_rounded;
}

/* R = I + 2 (w v~ + v~^2) / q·q, for any q but zero whose square neither over- nor underflows.
   q: quaternion (w; x, y, z), the scalar first; R: rotation or other 3×3 matrix.
   41 mul, 80 add, 21 product error, 17 sum error, 2 div, 9 equal, 9 select. */
static inline void ksl_mat3x3_from_quaternion_accurate(const ksl_quaternion_t *q, ksl_mat3x3_t *R) {
  const double squares_0 = q->w * q->w, squares_0_lo = ksl_product_error(q->w, q->w, squares_0);
  const double squares_1 = q->x * q->x, squares_1_lo = ksl_product_error(q->x, q->x, squares_1);
  const double squares_2 = q->y * q->y, squares_2_lo = ksl_product_error(q->y, q->y, squares_2);
  const double squares_3 = q->z * q->z, squares_3_lo = ksl_product_error(q->z, q->z, squares_3);
  const double pairs_0 = squares_0 + squares_1,
      pairs_0_error = ksl_sum_error(squares_0, squares_1, pairs_0),
      pairs_0_lo1 = pairs_0_error + squares_0_lo, pairs_0_lo = pairs_0_lo1 + squares_1_lo;
  const double pairs_1 = squares_2 + squares_3,
      pairs_1_error = ksl_sum_error(squares_2, squares_3, pairs_1),
      pairs_1_lo1 = pairs_1_error + squares_2_lo, pairs_1_lo = pairs_1_lo1 + squares_3_lo;
  const double pairs_2 = squares_0 + squares_2,
      pairs_2_error = ksl_sum_error(squares_0, squares_2, pairs_2),
      pairs_2_lo1 = pairs_2_error + squares_0_lo, pairs_2_lo = pairs_2_lo1 + squares_2_lo;
  const double pairs_3 = squares_1 + squares_3,
      pairs_3_error = ksl_sum_error(squares_1, squares_3, pairs_3),
      pairs_3_lo1 = pairs_3_error + squares_1_lo, pairs_3_lo = pairs_3_lo1 + squares_3_lo;
  const double pairs_4 = squares_0 + squares_3,
      pairs_4_error = ksl_sum_error(squares_0, squares_3, pairs_4),
      pairs_4_lo1 = pairs_4_error + squares_0_lo, pairs_4_lo = pairs_4_lo1 + squares_3_lo;
  const double pairs_5 = squares_1 + squares_2,
      pairs_5_error = ksl_sum_error(squares_1, squares_2, pairs_5),
      pairs_5_lo1 = pairs_5_error + squares_1_lo, pairs_5_lo = pairs_5_lo1 + squares_2_lo;
  const double square = pairs_0 + pairs_1, square_error = ksl_sum_error(pairs_0, pairs_1, square),
      square_lo1 = square_error + pairs_0_lo, square_lo = square_lo1 + pairs_1_lo;
  const double factor_of_square = square + square_lo,
      factor_of_square_lo = ksl_sum_error(square, square_lo, factor_of_square),
      factor = 1.0 / factor_of_square, factor_cross = factor * factor_of_square_lo,
      factor_product = factor * factor_of_square,
      factor_product_error = ksl_product_error(factor, factor_of_square, factor_product),
      factor_rest = 1.0 - factor_product, factor_exact = factor_rest - factor_product_error,
      factor_residual = factor_exact - factor_cross, factor_lo = factor_residual / factor_of_square;
  const double d0 = pairs_0 - pairs_1, d0_error = ksl_difference_error(pairs_0, pairs_1, d0),
      d0_lo1 = d0_error + pairs_0_lo, d0_lo = d0_lo1 - pairs_1_lo;
  const double d1 = pairs_2 - pairs_3, d1_error = ksl_difference_error(pairs_2, pairs_3, d1),
      d1_lo1 = d1_error + pairs_2_lo, d1_lo = d1_lo1 - pairs_3_lo;
  const double d2 = pairs_4 - pairs_5, d2_error = ksl_difference_error(pairs_4, pairs_5, d2),
      d2_lo1 = d2_error + pairs_4_lo, d2_lo = d2_lo1 - pairs_5_lo;
  const double twice = 2.0 * factor, twice_cross1 = 2.0 * factor_lo,
      twice_error = ksl_product_error(2.0, factor, twice), twice_lo = twice_error + twice_cross1;
  const double m_0a = q->x * q->y, m_0a_lo = ksl_product_error(q->x, q->y, m_0a),
      m_0b = q->w * q->z, m_0b_lo = ksl_product_error(q->w, q->z, m_0b), m_0 = m_0a - m_0b,
      m_0_error = ksl_difference_error(m_0a, m_0b, m_0), m_0_lo1 = m_0_error + m_0a_lo,
      m_0_lo = m_0_lo1 - m_0b_lo;
  const double m_1a = q->w * q->y, m_1a_lo = ksl_product_error(q->w, q->y, m_1a),
      m_1b = q->x * q->z, m_1b_lo = ksl_product_error(q->x, q->z, m_1b), m_1 = m_1a + m_1b,
      m_1_error = ksl_sum_error(m_1a, m_1b, m_1), m_1_lo1 = m_1_error + m_1a_lo,
      m_1_lo = m_1_lo1 + m_1b_lo;
  const double m_2a = q->y * q->z, m_2a_lo = ksl_product_error(q->y, q->z, m_2a),
      m_2b = q->w * q->x, m_2b_lo = ksl_product_error(q->w, q->x, m_2b), m_2 = m_2a - m_2b,
      m_2_error = ksl_difference_error(m_2a, m_2b, m_2), m_2_lo1 = m_2_error + m_2a_lo,
      m_2_lo = m_2_lo1 - m_2b_lo;
  const double m_3 = m_0b + m_0a, m_3_error = ksl_sum_error(m_0b, m_0a, m_3),
      m_3_lo1 = m_3_error + m_0b_lo, m_3_lo = m_3_lo1 + m_0a_lo;
  const double m_4 = m_1b - m_1a, m_4_error = ksl_difference_error(m_1b, m_1a, m_4),
      m_4_lo1 = m_4_error + m_1b_lo, m_4_lo = m_4_lo1 - m_1a_lo;
  const double m_5 = m_2b + m_2a, m_5_error = ksl_sum_error(m_2b, m_2a, m_5),
      m_5_lo1 = m_5_error + m_2b_lo, m_5_lo = m_5_lo1 + m_2a_lo;
  const double R_00 = factor * d0, R_00_cross1 = factor_lo * d0, R_00_cross2 = factor * d0_lo,
      R_00_error = ksl_product_error(factor, d0, R_00), R_00_lo1 = R_00_error + R_00_cross1,
      R_00_lo = R_00_lo1 + R_00_cross2;
  const double R_01 = twice * m_0, R_01_cross1 = twice_lo * m_0, R_01_cross2 = twice * m_0_lo,
      R_01_error = ksl_product_error(twice, m_0, R_01), R_01_lo1 = R_01_error + R_01_cross1,
      R_01_lo = R_01_lo1 + R_01_cross2;
  const double R_02 = twice * m_1, R_02_cross1 = twice_lo * m_1, R_02_cross2 = twice * m_1_lo,
      R_02_error = ksl_product_error(twice, m_1, R_02), R_02_lo1 = R_02_error + R_02_cross1,
      R_02_lo = R_02_lo1 + R_02_cross2;
  const double R_10 = twice * m_3, R_10_cross1 = twice_lo * m_3, R_10_cross2 = twice * m_3_lo,
      R_10_error = ksl_product_error(twice, m_3, R_10), R_10_lo1 = R_10_error + R_10_cross1,
      R_10_lo = R_10_lo1 + R_10_cross2;
  const double R_11 = factor * d1, R_11_cross1 = factor_lo * d1, R_11_cross2 = factor * d1_lo,
      R_11_error = ksl_product_error(factor, d1, R_11), R_11_lo1 = R_11_error + R_11_cross1,
      R_11_lo = R_11_lo1 + R_11_cross2;
  const double R_12 = twice * m_2, R_12_cross1 = twice_lo * m_2, R_12_cross2 = twice * m_2_lo,
      R_12_error = ksl_product_error(twice, m_2, R_12), R_12_lo1 = R_12_error + R_12_cross1,
      R_12_lo = R_12_lo1 + R_12_cross2;
  const double R_20 = twice * m_4, R_20_cross1 = twice_lo * m_4, R_20_cross2 = twice * m_4_lo,
      R_20_error = ksl_product_error(twice, m_4, R_20), R_20_lo1 = R_20_error + R_20_cross1,
      R_20_lo = R_20_lo1 + R_20_cross2;
  const double R_21 = twice * m_5, R_21_cross1 = twice_lo * m_5, R_21_cross2 = twice * m_5_lo,
      R_21_error = ksl_product_error(twice, m_5, R_21), R_21_lo1 = R_21_error + R_21_cross1,
      R_21_lo = R_21_lo1 + R_21_cross2;
  const double R_22 = factor * d2, R_22_cross1 = factor_lo * d2, R_22_cross2 = factor * d2_lo,
      R_22_error = ksl_product_error(factor, d2, R_22), R_22_lo1 = R_22_error + R_22_cross1,
      R_22_lo = R_22_lo1 + R_22_cross2;
  const double R_00_total = R_00 + R_00_lo,
      R_00_rounded = R_00_total == R_00_total ? R_00_total : R_00;
  const double R_01_total = R_01 + R_01_lo,
      R_01_rounded = R_01_total == R_01_total ? R_01_total : R_01;
  const double R_02_total = R_02 + R_02_lo,
      R_02_rounded = R_02_total == R_02_total ? R_02_total : R_02;
  const double R_10_total = R_10 + R_10_lo,
      R_10_rounded = R_10_total == R_10_total ? R_10_total : R_10;
  const double R_11_total = R_11 + R_11_lo,
      R_11_rounded = R_11_total == R_11_total ? R_11_total : R_11;
  const double R_12_total = R_12 + R_12_lo,
      R_12_rounded = R_12_total == R_12_total ? R_12_total : R_12;
  const double R_20_total = R_20 + R_20_lo,
      R_20_rounded = R_20_total == R_20_total ? R_20_total : R_20;
  const double R_21_total = R_21 + R_21_lo,
      R_21_rounded = R_21_total == R_21_total ? R_21_total : R_21;
  const double R_22_total = R_22 + R_22_lo,
      R_22_rounded = R_22_total == R_22_total ? R_22_total : R_22;
  R->m00 = R_00_rounded;
  R->m01 = R_01_rounded;
  R->m02 = R_02_rounded;
  R->m10 = R_10_rounded;
  R->m11 = R_11_rounded;
  R->m12 = R_12_rounded;
  R->m20 = R_20_rounded;
  R->m21 = R_21_rounded;
  R->m22 = R_22_rounded;
}

/* qo with R(qo) = R and w >= 0; of an R that is not quite a rotation, off by as much as R.
   R: rotation or other 3×3 matrix; qo: quaternion (w; x, y, z), the scalar first.
   21 mul, 73 add, 9 product error, 27 sum error, 9 div, 1 sqrt, 9 neg, 4 less, 5 equal, 37
     select. */
static inline void ksl_quaternion_from_mat3x3_accurate(const ksl_mat3x3_t *R,
    ksl_quaternion_t *qo) {
  const double p_0 = R->m21 - R->m12, p_0_lo = ksl_difference_error(R->m21, R->m12, p_0);
  const double p_1 = R->m02 - R->m20, p_1_lo = ksl_difference_error(R->m02, R->m20, p_1);
  const double p_2 = R->m10 - R->m01, p_2_lo = ksl_difference_error(R->m10, R->m01, p_2);
  const double s_0 = R->m12 + R->m21, s_0_lo = ksl_sum_error(R->m12, R->m21, s_0);
  const double s_1 = R->m02 + R->m20, s_1_lo = ksl_sum_error(R->m02, R->m20, s_1);
  const double s_2 = R->m01 + R->m10, s_2_lo = ksl_sum_error(R->m01, R->m10, s_2);
  const double d_0a = R->m00 + R->m11, d_0a_lo = ksl_sum_error(R->m00, R->m11, d_0a),
      d_0b = d_0a + R->m22, d_0b_error = ksl_sum_error(d_0a, R->m22, d_0b),
      d_0b_lo = d_0b_error + d_0a_lo, d_0 = d_0b + 1.0, d_0_error = ksl_sum_error(d_0b, 1.0, d_0),
      d_0_lo = d_0_error + d_0b_lo;
  const double d_1a = R->m00 - R->m11, d_1a_lo = ksl_difference_error(R->m00, R->m11, d_1a),
      d_1b = d_1a - R->m22, d_1b_error = ksl_difference_error(d_1a, R->m22, d_1b),
      d_1b_lo = d_1b_error + d_1a_lo, d_1 = d_1b + 1.0, d_1_error = ksl_sum_error(d_1b, 1.0, d_1),
      d_1_lo = d_1_error + d_1b_lo;
  const double d_2a = R->m11 - R->m00, d_2a_lo = ksl_difference_error(R->m11, R->m00, d_2a),
      d_2b = d_2a - R->m22, d_2b_error = ksl_difference_error(d_2a, R->m22, d_2b),
      d_2b_lo = d_2b_error + d_2a_lo, d_2 = d_2b + 1.0, d_2_error = ksl_sum_error(d_2b, 1.0, d_2),
      d_2_lo = d_2_error + d_2b_lo;
  const double d_3a = R->m22 - R->m00, d_3a_lo = ksl_difference_error(R->m22, R->m00, d_3a),
      d_3b = d_3a - R->m11, d_3b_error = ksl_difference_error(d_3a, R->m11, d_3b),
      d_3b_lo = d_3b_error + d_3a_lo, d_3 = d_3b + 1.0, d_3_error = ksl_sum_error(d_3b, 1.0, d_3),
      d_3_lo = d_3_error + d_3b_lo;
  const double low_0 = R->m11 < R->m00 ? p_0 : p_1, low_0_lo = R->m11 < R->m00 ? p_0_lo : p_1_lo;
  const double low_1 = R->m11 < R->m00 ? d_1 : s_2, low_1_lo = R->m11 < R->m00 ? d_1_lo : s_2_lo;
  const double low_2 = R->m11 < R->m00 ? s_2 : d_2, low_2_lo = R->m11 < R->m00 ? s_2_lo : d_2_lo;
  const double low_3 = R->m11 < R->m00 ? s_1 : s_0, low_3_lo = R->m11 < R->m00 ? s_1_lo : s_0_lo;
  const double high_0a = -R->m11, high_0 = R->m00 < high_0a ? p_2 : d_0,
      high_0_lo = R->m00 < high_0a ? p_2_lo : d_0_lo;
  const double high_1 = R->m00 < high_0a ? s_1 : p_0,
      high_1_lo = R->m00 < high_0a ? s_1_lo : p_0_lo;
  const double high_2 = R->m00 < high_0a ? s_0 : p_1,
      high_2_lo = R->m00 < high_0a ? s_0_lo : p_1_lo;
  const double high_3 = R->m00 < high_0a ? d_3 : p_2,
      high_3_lo = R->m00 < high_0a ? d_3_lo : p_2_lo;
  const double column_0 = R->m22 < 0.0 ? low_0 : high_0,
      column_0_lo = R->m22 < 0.0 ? low_0_lo : high_0_lo;
  const double column_1 = R->m22 < 0.0 ? low_1 : high_1,
      column_1_lo = R->m22 < 0.0 ? low_1_lo : high_1_lo;
  const double column_2 = R->m22 < 0.0 ? low_2 : high_2,
      column_2_lo = R->m22 < 0.0 ? low_2_lo : high_2_lo;
  const double column_3 = R->m22 < 0.0 ? low_3 : high_3,
      column_3_lo = R->m22 < 0.0 ? low_3_lo : high_3_lo;
  const double upper_0a = -column_0, upper_0a_lo = -column_0_lo,
      upper_0 = column_0 < 0.0 ? upper_0a : column_0,
      upper_0_lo = column_0 < 0.0 ? upper_0a_lo : column_0_lo;
  const double upper_1a = -column_1, upper_1a_lo = -column_1_lo,
      upper_1 = column_0 < 0.0 ? upper_1a : column_1,
      upper_1_lo = column_0 < 0.0 ? upper_1a_lo : column_1_lo;
  const double upper_2a = -column_2, upper_2a_lo = -column_2_lo,
      upper_2 = column_0 < 0.0 ? upper_2a : column_2,
      upper_2_lo = column_0 < 0.0 ? upper_2a_lo : column_2_lo;
  const double upper_3a = -column_3, upper_3a_lo = -column_3_lo,
      upper_3 = column_0 < 0.0 ? upper_3a : column_3,
      upper_3_lo = column_0 < 0.0 ? upper_3a_lo : column_3_lo;
  const double length_a = upper_0 * upper_0, length_a_cross1 = upper_0_lo * upper_0,
      length_a_cross2 = upper_0 * upper_0_lo,
      length_a_error = ksl_product_error(upper_0, upper_0, length_a),
      length_a_lo1 = length_a_error + length_a_cross1, length_a_lo = length_a_lo1 + length_a_cross2,
      length_b = upper_1 * upper_1, length_b_cross1 = upper_1_lo * upper_1,
      length_b_cross2 = upper_1 * upper_1_lo,
      length_b_error = ksl_product_error(upper_1, upper_1, length_b),
      length_b_lo1 = length_b_error + length_b_cross1, length_b_lo = length_b_lo1 + length_b_cross2,
      length_c = length_a + length_b, length_c_error = ksl_sum_error(length_a, length_b, length_c),
      length_c_lo1 = length_c_error + length_a_lo, length_c_lo = length_c_lo1 + length_b_lo,
      length_d = upper_2 * upper_2, length_d_cross1 = upper_2_lo * upper_2,
      length_d_cross2 = upper_2 * upper_2_lo,
      length_d_error = ksl_product_error(upper_2, upper_2, length_d),
      length_d_lo1 = length_d_error + length_d_cross1, length_d_lo = length_d_lo1 + length_d_cross2,
      length_e = length_c + length_d, length_e_error = ksl_sum_error(length_c, length_d, length_e),
      length_e_lo1 = length_e_error + length_c_lo, length_e_lo = length_e_lo1 + length_d_lo,
      length_f = upper_3 * upper_3, length_f_cross1 = upper_3_lo * upper_3,
      length_f_cross2 = upper_3 * upper_3_lo,
      length_f_error = ksl_product_error(upper_3, upper_3, length_f),
      length_f_lo1 = length_f_error + length_f_cross1, length_f_lo = length_f_lo1 + length_f_cross2,
      length_g = length_e + length_f, length_g_error = ksl_sum_error(length_e, length_f, length_g),
      length_g_lo1 = length_g_error + length_e_lo, length_g_lo = length_g_lo1 + length_f_lo,
      length_of_length_g = length_g + length_g_lo,
      length_of_length_g_lo = ksl_sum_error(length_g, length_g_lo, length_of_length_g),
      length = sqrt(length_of_length_g), length_product = length * length,
      length_product_error = ksl_product_error(length, length, length_product),
      length_rest = length_of_length_g - length_product,
      length_exact = length_rest - length_product_error,
      length_residual = length_exact + length_of_length_g_lo, length_twice = length + length,
      length_divisor = length == 0.0 ? 1.0 : length_twice,
      length_lo = length_residual / length_divisor;
  const double qo_0_of_upper_0 = upper_0 + upper_0_lo,
      qo_0_of_upper_0_lo = ksl_sum_error(upper_0, upper_0_lo, qo_0_of_upper_0),
      qo_0_of_length = length + length_lo,
      qo_0_of_length_lo = ksl_sum_error(length, length_lo, qo_0_of_length),
      qo_0 = qo_0_of_upper_0 / qo_0_of_length, qo_0_cross = qo_0 * qo_0_of_length_lo,
      qo_0_product = qo_0 * qo_0_of_length,
      qo_0_product_error = ksl_product_error(qo_0, qo_0_of_length, qo_0_product),
      qo_0_rest = qo_0_of_upper_0 - qo_0_product, qo_0_exact = qo_0_rest - qo_0_product_error,
      qo_0_lo1 = qo_0_exact + qo_0_of_upper_0_lo, qo_0_residual = qo_0_lo1 - qo_0_cross,
      qo_0_lo = qo_0_residual / qo_0_of_length;
  const double qo_1_of_upper_1 = upper_1 + upper_1_lo,
      qo_1_of_upper_1_lo = ksl_sum_error(upper_1, upper_1_lo, qo_1_of_upper_1),
      qo_1 = qo_1_of_upper_1 / qo_0_of_length, qo_1_cross = qo_1 * qo_0_of_length_lo,
      qo_1_product = qo_1 * qo_0_of_length,
      qo_1_product_error = ksl_product_error(qo_1, qo_0_of_length, qo_1_product),
      qo_1_rest = qo_1_of_upper_1 - qo_1_product, qo_1_exact = qo_1_rest - qo_1_product_error,
      qo_1_lo1 = qo_1_exact + qo_1_of_upper_1_lo, qo_1_residual = qo_1_lo1 - qo_1_cross,
      qo_1_lo = qo_1_residual / qo_0_of_length;
  const double qo_2_of_upper_2 = upper_2 + upper_2_lo,
      qo_2_of_upper_2_lo = ksl_sum_error(upper_2, upper_2_lo, qo_2_of_upper_2),
      qo_2 = qo_2_of_upper_2 / qo_0_of_length, qo_2_cross = qo_2 * qo_0_of_length_lo,
      qo_2_product = qo_2 * qo_0_of_length,
      qo_2_product_error = ksl_product_error(qo_2, qo_0_of_length, qo_2_product),
      qo_2_rest = qo_2_of_upper_2 - qo_2_product, qo_2_exact = qo_2_rest - qo_2_product_error,
      qo_2_lo1 = qo_2_exact + qo_2_of_upper_2_lo, qo_2_residual = qo_2_lo1 - qo_2_cross,
      qo_2_lo = qo_2_residual / qo_0_of_length;
  const double qo_3_of_upper_3 = upper_3 + upper_3_lo,
      qo_3_of_upper_3_lo = ksl_sum_error(upper_3, upper_3_lo, qo_3_of_upper_3),
      qo_3 = qo_3_of_upper_3 / qo_0_of_length, qo_3_cross = qo_3 * qo_0_of_length_lo,
      qo_3_product = qo_3 * qo_0_of_length,
      qo_3_product_error = ksl_product_error(qo_3, qo_0_of_length, qo_3_product),
      qo_3_rest = qo_3_of_upper_3 - qo_3_product, qo_3_exact = qo_3_rest - qo_3_product_error,
      qo_3_lo1 = qo_3_exact + qo_3_of_upper_3_lo, qo_3_residual = qo_3_lo1 - qo_3_cross,
      qo_3_lo = qo_3_residual / qo_0_of_length;
  const double qo_0_total = qo_0 + qo_0_lo,
      qo_0_rounded = qo_0_total == qo_0_total ? qo_0_total : qo_0;
  const double qo_1_total = qo_1 + qo_1_lo,
      qo_1_rounded = qo_1_total == qo_1_total ? qo_1_total : qo_1;
  const double qo_2_total = qo_2 + qo_2_lo,
      qo_2_rounded = qo_2_total == qo_2_total ? qo_2_total : qo_2;
  const double qo_3_total = qo_3 + qo_3_lo,
      qo_3_rounded = qo_3_total == qo_3_total ? qo_3_total : qo_3;
  qo->w = qo_0_rounded;
  qo->x = qo_1_rounded;
  qo->y = qo_2_rounded;
  qo->z = qo_3_rounded;
}

/* angle = 2 atan2(|v|, |w|), axis = ±v / |v|; 0 <= angle <= π; the axis is (1, 0, 0) where angle
     = 0; any multiple of a quaternion.
   q: quaternion (w; x, y, z), the scalar first; axis: vector.
   21 mul, 31 add, 8 product error, 6 sum error, 9 div, 1 sqrt, 1 atan2, 4 neg, 3 abs, 7 less, 7
     equal, 20 select. */
static inline double ksl_axis_angle_from_quaternion_accurate(const ksl_quaternion_t *q,
    ksl_vec3_t *axis) {
  const double upper_0a = -q->w, upper_0 = q->w < 0.0 ? upper_0a : q->w;
  const double upper_1a = -q->x, upper_1 = q->w < 0.0 ? upper_1a : q->x;
  const double upper_2a = -q->y, upper_2 = q->w < 0.0 ? upper_2a : q->y;
  const double upper_3a = -q->z, upper_3 = q->w < 0.0 ? upper_3a : q->z;
  const double v_s_size_0 = fabs(upper_1);
  const double v_s_size_1 = fabs(upper_2);
  const double v_s_size_2 = fabs(upper_3);
  const double v_s_largest1 = v_s_size_0 < v_s_size_1 ? v_s_size_1 : v_s_size_0;
  const double v_s_largest2 = v_s_largest1 < v_s_size_2 ? v_s_size_2 : v_s_largest1;
  const double v_s_b = 6.703903964971299e+153 < v_s_largest2 ? 3.7291703656001034e-155 : 1.0,
      v_s = v_s_largest2 < 3.4395525670743494e-136 ? 4.149515568880993e+180 : v_s_b;
  const double v_y_0 = upper_1 * v_s;
  const double v_y_1 = upper_2 * v_s;
  const double v_y_2 = upper_3 * v_s;
  const double v_n_a = v_y_0 * v_y_0, v_n_a_lo = ksl_product_error(v_y_0, v_y_0, v_n_a),
      v_n_b = v_y_1 * v_y_1, v_n_b_lo = ksl_product_error(v_y_1, v_y_1, v_n_b),
      v_n_c = v_n_a + v_n_b, v_n_c_error = ksl_sum_error(v_n_a, v_n_b, v_n_c),
      v_n_c_lo1 = v_n_c_error + v_n_a_lo, v_n_c_lo = v_n_c_lo1 + v_n_b_lo, v_n_d = v_y_2 * v_y_2,
      v_n_d_lo = ksl_product_error(v_y_2, v_y_2, v_n_d), v_n_e = v_n_c + v_n_d,
      v_n_e_error = ksl_sum_error(v_n_c, v_n_d, v_n_e), v_n_e_lo1 = v_n_e_error + v_n_c_lo,
      v_n_e_lo = v_n_e_lo1 + v_n_d_lo, v_n_of_v_n_e = v_n_e + v_n_e_lo,
      v_n_of_v_n_e_lo = ksl_sum_error(v_n_e, v_n_e_lo, v_n_of_v_n_e), v_n = sqrt(v_n_of_v_n_e),
      v_n_product = v_n * v_n, v_n_product_error = ksl_product_error(v_n, v_n, v_n_product),
      v_n_rest = v_n_of_v_n_e - v_n_product, v_n_exact = v_n_rest - v_n_product_error,
      v_n_residual = v_n_exact + v_n_of_v_n_e_lo, v_n_twice = v_n + v_n,
      v_n_divisor = v_n == 0.0 ? 1.0 : v_n_twice, v_n_lo = v_n_residual / v_n_divisor;
  const double v_r_b = v_s < 1.0 ? 2.6815615859885194e+154 : 1.0,
      v_r = 1.0 < v_s ? 2.409919865102884e-181 : v_r_b;
  const double n_of_v_n = v_n + v_n_lo, n_of_v_n_lo = ksl_sum_error(v_n, v_n_lo, n_of_v_n),
      n = n_of_v_n * v_r, n_inverse = 1.0 / v_r, n_back = n * n_inverse, n_lost = n_of_v_n - n_back,
      n_rest = n_lost + n_of_v_n_lo, n_small = n_rest * v_r, n_lo = n_lost == 0.0 ? 0.0 : n_small;
  const double half_of_n = n + n_lo, half_of_n_lo = ksl_sum_error(n, n_lo, half_of_n),
      half = atan2(half_of_n, upper_0), half_cross0 = upper_0 * half_of_n_lo,
      half_square0 = upper_0 * upper_0, half_square1 = half_of_n * half_of_n,
      half_square = half_square0 + half_square1, half_lo = half_cross0 / half_square;
  const double divisor = half_of_n == 0.0 ? 1.0 : half_of_n,
      divisor_lo = half_of_n == 0.0 ? 0.0 : half_of_n_lo;
  const double unit_0_of_divisor = divisor + divisor_lo,
      unit_0_of_divisor_lo = ksl_sum_error(divisor, divisor_lo, unit_0_of_divisor),
      unit_0 = upper_1 / unit_0_of_divisor, unit_0_cross = unit_0 * unit_0_of_divisor_lo,
      unit_0_product = unit_0 * unit_0_of_divisor,
      unit_0_product_error = ksl_product_error(unit_0, unit_0_of_divisor, unit_0_product),
      unit_0_rest = upper_1 - unit_0_product, unit_0_exact = unit_0_rest - unit_0_product_error,
      unit_0_residual = unit_0_exact - unit_0_cross,
      unit_0_lo = unit_0_residual / unit_0_of_divisor;
  const double unit_1 = upper_2 / unit_0_of_divisor, unit_1_cross = unit_1 * unit_0_of_divisor_lo,
      unit_1_product = unit_1 * unit_0_of_divisor,
      unit_1_product_error = ksl_product_error(unit_1, unit_0_of_divisor, unit_1_product),
      unit_1_rest = upper_2 - unit_1_product, unit_1_exact = unit_1_rest - unit_1_product_error,
      unit_1_residual = unit_1_exact - unit_1_cross,
      unit_1_lo = unit_1_residual / unit_0_of_divisor;
  const double unit_2 = upper_3 / unit_0_of_divisor, unit_2_cross = unit_2 * unit_0_of_divisor_lo,
      unit_2_product = unit_2 * unit_0_of_divisor,
      unit_2_product_error = ksl_product_error(unit_2, unit_0_of_divisor, unit_2_product),
      unit_2_rest = upper_3 - unit_2_product, unit_2_exact = unit_2_rest - unit_2_product_error,
      unit_2_residual = unit_2_exact - unit_2_cross,
      unit_2_lo = unit_2_residual / unit_0_of_divisor;
  const double angle = 2.0 * half, angle_cross1 = 2.0 * half_lo,
      angle_error = ksl_product_error(2.0, half, angle), angle_lo = angle_error + angle_cross1;
  const double axis_0 = half_of_n == 0.0 ? 1.0 : unit_0,
      axis_0_lo = half_of_n == 0.0 ? 0.0 : unit_0_lo;
  const double angle_total = angle + angle_lo,
      angle_rounded = angle_total == angle_total ? angle_total : angle;
  const double axis_0_total = axis_0 + axis_0_lo,
      axis_0_rounded = axis_0_total == axis_0_total ? axis_0_total : axis_0;
  const double unit_1_total = unit_1 + unit_1_lo,
      unit_1_rounded = unit_1_total == unit_1_total ? unit_1_total : unit_1;
  const double unit_2_total = unit_2 + unit_2_lo,
      unit_2_rounded = unit_2_total == unit_2_total ? unit_2_total : unit_2;
  axis->x = axis_0_rounded;
  axis->y = unit_1_rounded;
  axis->z = unit_2_rounded;
  return angle_rounded;
}

/* vo = θ v/|v|, θ = 2 atan2(|v|, |w|) <= π: the rotation vector of q, or of any multiple of it.
   q: quaternion (w; x, y, z), the scalar first; vo: vector.
   23 mul, 29 add, 9 product error, 7 sum error, 5 div, 1 sqrt, 1 atan2, 4 neg, 3 abs, 7 less, 6
     equal, 17 select. */
static inline void ksl_quaternion_log_accurate(const ksl_quaternion_t *q, ksl_vec3_t *vo) {
  const double upper_0a = -q->w, upper_0 = q->w < 0.0 ? upper_0a : q->w;
  const double upper_1a = -q->x, upper_1 = q->w < 0.0 ? upper_1a : q->x;
  const double upper_2a = -q->y, upper_2 = q->w < 0.0 ? upper_2a : q->y;
  const double upper_3a = -q->z, upper_3 = q->w < 0.0 ? upper_3a : q->z;
  const double v_s_size_0 = fabs(upper_1);
  const double v_s_size_1 = fabs(upper_2);
  const double v_s_size_2 = fabs(upper_3);
  const double v_s_largest1 = v_s_size_0 < v_s_size_1 ? v_s_size_1 : v_s_size_0;
  const double v_s_largest2 = v_s_largest1 < v_s_size_2 ? v_s_size_2 : v_s_largest1;
  const double v_s_b = 6.703903964971299e+153 < v_s_largest2 ? 3.7291703656001034e-155 : 1.0,
      v_s = v_s_largest2 < 3.4395525670743494e-136 ? 4.149515568880993e+180 : v_s_b;
  const double v_y_0 = upper_1 * v_s;
  const double v_y_1 = upper_2 * v_s;
  const double v_y_2 = upper_3 * v_s;
  const double v_n_a = v_y_0 * v_y_0, v_n_a_lo = ksl_product_error(v_y_0, v_y_0, v_n_a),
      v_n_b = v_y_1 * v_y_1, v_n_b_lo = ksl_product_error(v_y_1, v_y_1, v_n_b),
      v_n_c = v_n_a + v_n_b, v_n_c_error = ksl_sum_error(v_n_a, v_n_b, v_n_c),
      v_n_c_lo1 = v_n_c_error + v_n_a_lo, v_n_c_lo = v_n_c_lo1 + v_n_b_lo, v_n_d = v_y_2 * v_y_2,
      v_n_d_lo = ksl_product_error(v_y_2, v_y_2, v_n_d), v_n_e = v_n_c + v_n_d,
      v_n_e_error = ksl_sum_error(v_n_c, v_n_d, v_n_e), v_n_e_lo1 = v_n_e_error + v_n_c_lo,
      v_n_e_lo = v_n_e_lo1 + v_n_d_lo, v_n_of_v_n_e = v_n_e + v_n_e_lo,
      v_n_of_v_n_e_lo = ksl_sum_error(v_n_e, v_n_e_lo, v_n_of_v_n_e), v_n = sqrt(v_n_of_v_n_e),
      v_n_product = v_n * v_n, v_n_product_error = ksl_product_error(v_n, v_n, v_n_product),
      v_n_rest = v_n_of_v_n_e - v_n_product, v_n_exact = v_n_rest - v_n_product_error,
      v_n_residual = v_n_exact + v_n_of_v_n_e_lo, v_n_twice = v_n + v_n,
      v_n_divisor = v_n == 0.0 ? 1.0 : v_n_twice, v_n_lo = v_n_residual / v_n_divisor;
  const double v_r_b = v_s < 1.0 ? 2.6815615859885194e+154 : 1.0,
      v_r = 1.0 < v_s ? 2.409919865102884e-181 : v_r_b;
  const double n_of_v_n = v_n + v_n_lo, n_of_v_n_lo = ksl_sum_error(v_n, v_n_lo, n_of_v_n),
      n = n_of_v_n * v_r, n_inverse = 1.0 / v_r, n_back = n * n_inverse, n_lost = n_of_v_n - n_back,
      n_rest = n_lost + n_of_v_n_lo, n_small = n_rest * v_r, n_lo = n_lost == 0.0 ? 0.0 : n_small;
  const double half_of_n = n + n_lo, half_of_n_lo = ksl_sum_error(n, n_lo, half_of_n),
      half = atan2(half_of_n, upper_0), half_cross0 = upper_0 * half_of_n_lo,
      half_square0 = upper_0 * upper_0, half_square1 = half_of_n * half_of_n,
      half_square = half_square0 + half_square1, half_lo = half_cross0 / half_square;
  const double divisor = half_of_n == 0.0 ? 1.0 : half_of_n,
      divisor_lo = half_of_n == 0.0 ? 0.0 : half_of_n_lo;
  const double theta = 2.0 * half, theta_cross1 = 2.0 * half_lo,
      theta_error = ksl_product_error(2.0, half, theta), theta_lo = theta_error + theta_cross1;
  const double k_of_theta = theta + theta_lo,
      k_of_theta_lo = ksl_sum_error(theta, theta_lo, k_of_theta),
      k_of_divisor = divisor + divisor_lo,
      k_of_divisor_lo = ksl_sum_error(divisor, divisor_lo, k_of_divisor),
      k = k_of_theta / k_of_divisor, k_cross = k * k_of_divisor_lo, k_product = k * k_of_divisor,
      k_product_error = ksl_product_error(k, k_of_divisor, k_product),
      k_rest = k_of_theta - k_product, k_exact = k_rest - k_product_error,
      k_lo1 = k_exact + k_of_theta_lo, k_residual = k_lo1 - k_cross,
      k_lo = k_residual / k_of_divisor;
  const double vector_0 = upper_1 * k, vector_0_cross1 = upper_1 * k_lo,
      vector_0_error = ksl_product_error(upper_1, k, vector_0),
      vector_0_lo = vector_0_error + vector_0_cross1;
  const double vector_1 = upper_2 * k, vector_1_cross1 = upper_2 * k_lo,
      vector_1_error = ksl_product_error(upper_2, k, vector_1),
      vector_1_lo = vector_1_error + vector_1_cross1;
  const double vector_2 = upper_3 * k, vector_2_cross1 = upper_3 * k_lo,
      vector_2_error = ksl_product_error(upper_3, k, vector_2),
      vector_2_lo = vector_2_error + vector_2_cross1;
  const double vector_0_total = vector_0 + vector_0_lo,
      vector_0_rounded = vector_0_total == vector_0_total ? vector_0_total : vector_0;
  const double vector_1_total = vector_1 + vector_1_lo,
      vector_1_rounded = vector_1_total == vector_1_total ? vector_1_total : vector_1;
  const double vector_2_total = vector_2 + vector_2_lo,
      vector_2_rounded = vector_2_total == vector_2_total ? vector_2_total : vector_2;
  vo->x = vector_0_rounded;
  vo->y = vector_1_rounded;
  vo->z = vector_2_rounded;
}

/* self = a self.
   self: quaternion (w; x, y, z), the scalar first; a: number.
   4 mul.
   Error <= u |result| + 1/32 u^2 S, S the sum of the |terms| of the expanded formula; barring
     over- and underflow. */
static inline void ksl_quaternionf_scale_accurate(ksl_quaternionf_t *self, const float a) {
  const double self_0_new = (double)self->w * (double)a;
  const double self_1_new = (double)self->x * (double)a;
  const double self_2_new = (double)self->y * (double)a;
  const double self_3_new = (double)self->z * (double)a;
  self->w = (float)self_0_new;
  self->x = (float)self_1_new;
  self->y = (float)self_2_new;
  self->z = (float)self_3_new;
}

/* |q| = sqrt(w^2 + v·v).
   q: quaternion (w; x, y, z), the scalar first.
   9 mul, 3 add, 1 sqrt, 4 abs, 7 less, 7 select. */
static inline float ksl_quaternionf_norm_accurate(const ksl_quaternionf_t *q) {
  const double s_size_0 = fabs((double)q->w);
  const double s_size_1 = fabs((double)q->x);
  const double s_size_2 = fabs((double)q->y);
  const double s_size_3 = fabs((double)q->z);
  const double s_largest1 = s_size_0 < s_size_1 ? s_size_1 : s_size_0;
  const double s_largest2 = s_largest1 < s_size_2 ? s_size_2 : s_largest1;
  const double s_largest3 = s_largest2 < s_size_3 ? s_size_3 : s_largest2;
  const double s_b = 4.611686018427388e+18 < s_largest3 ? 2.710505431213761e-20 : 1.0,
      s = s_largest3 < 8.881784197001252e-16 ? 1.2676506002282294e+30 : s_b;
  const double y_0 = (double)q->w * s;
  const double y_1 = (double)q->x * s;
  const double y_2 = (double)q->y * s;
  const double y_3 = (double)q->z * s;
  const double n_a = y_0 * y_0, n_b = y_1 * y_1, n_c = n_a + n_b, n_d = y_2 * y_2, n_e = n_c + n_d,
      n_f = y_3 * y_3, n_g = n_e + n_f, n = sqrt(n_g);
  const double r_b = s < 1.0 ? 3.6893488147419103e+19 : 1.0,
      r = 1.0 < s ? 7.888609052210118e-31 : r_b;
  const double norm = n * r;
  return (float)norm;
}

/* self = self / |self|; zero stays zero.
   self: quaternion (w; x, y, z), the scalar first.
   16 mul, 3 add, 4 div, 1 sqrt, 4 abs, 7 less, 1 equal, 8 select. */
static inline void ksl_quaternionf_normalize_accurate(ksl_quaternionf_t *self) {
  const double s_size_0 = fabs((double)self->w);
  const double s_size_1 = fabs((double)self->x);
  const double s_size_2 = fabs((double)self->y);
  const double s_size_3 = fabs((double)self->z);
  const double s_largest1 = s_size_0 < s_size_1 ? s_size_1 : s_size_0;
  const double s_largest2 = s_largest1 < s_size_2 ? s_size_2 : s_largest1;
  const double s_largest3 = s_largest2 < s_size_3 ? s_size_3 : s_largest2;
  const double s_b = 4.611686018427388e+18 < s_largest3 ? 2.710505431213761e-20 : 1.0,
      s = s_largest3 < 8.881784197001252e-16 ? 1.2676506002282294e+30 : s_b;
  const double y_0 = (double)self->w * s;
  const double y_1 = (double)self->x * s;
  const double y_2 = (double)self->y * s;
  const double y_3 = (double)self->z * s;
  const double n_a = y_0 * y_0, n_b = y_1 * y_1, n_c = n_a + n_b, n_d = y_2 * y_2, n_e = n_c + n_d,
      n_f = y_3 * y_3, n_g = n_e + n_f, n = sqrt(n_g);
  const double divisor = n == 0.0 ? 1.0 : n;
  const double up = 1.0 < s ? s : 1.0;
  const double down = s < 1.0 ? s : 1.0;
  const double enlarged_0 = (double)self->w * up;
  const double enlarged_1 = (double)self->x * up;
  const double enlarged_2 = (double)self->y * up;
  const double enlarged_3 = (double)self->z * up;
  const double quotient_0 = enlarged_0 / divisor;
  const double quotient_1 = enlarged_1 / divisor;
  const double quotient_2 = enlarged_2 / divisor;
  const double quotient_3 = enlarged_3 / divisor;
  const double self_0_new = quotient_0 * down;
  const double self_1_new = quotient_1 * down;
  const double self_2_new = quotient_2 * down;
  const double self_3_new = quotient_3 * down;
  self->w = (float)self_0_new;
  self->x = (float)self_1_new;
  self->y = (float)self_2_new;
  self->z = (float)self_3_new;
}

/* qo = q / |q|; zero stays zero.
   q, qo: quaternion (w; x, y, z), the scalar first.
   16 mul, 3 add, 4 div, 1 sqrt, 4 abs, 7 less, 1 equal, 8 select. */
static inline void ksl_quaternionf_normalized_accurate(const ksl_quaternionf_t *q,
    ksl_quaternionf_t *qo) {
  const double s_size_0 = fabs((double)q->w);
  const double s_size_1 = fabs((double)q->x);
  const double s_size_2 = fabs((double)q->y);
  const double s_size_3 = fabs((double)q->z);
  const double s_largest1 = s_size_0 < s_size_1 ? s_size_1 : s_size_0;
  const double s_largest2 = s_largest1 < s_size_2 ? s_size_2 : s_largest1;
  const double s_largest3 = s_largest2 < s_size_3 ? s_size_3 : s_largest2;
  const double s_b = 4.611686018427388e+18 < s_largest3 ? 2.710505431213761e-20 : 1.0,
      s = s_largest3 < 8.881784197001252e-16 ? 1.2676506002282294e+30 : s_b;
  const double y_0 = (double)q->w * s;
  const double y_1 = (double)q->x * s;
  const double y_2 = (double)q->y * s;
  const double y_3 = (double)q->z * s;
  const double n_a = y_0 * y_0, n_b = y_1 * y_1, n_c = n_a + n_b, n_d = y_2 * y_2, n_e = n_c + n_d,
      n_f = y_3 * y_3, n_g = n_e + n_f, n = sqrt(n_g);
  const double divisor = n == 0.0 ? 1.0 : n;
  const double up = 1.0 < s ? s : 1.0;
  const double down = s < 1.0 ? s : 1.0;
  const double enlarged_0 = (double)q->w * up;
  const double enlarged_1 = (double)q->x * up;
  const double enlarged_2 = (double)q->y * up;
  const double enlarged_3 = (double)q->z * up;
  const double quotient_0 = enlarged_0 / divisor;
  const double quotient_1 = enlarged_1 / divisor;
  const double quotient_2 = enlarged_2 / divisor;
  const double quotient_3 = enlarged_3 / divisor;
  const double qo_0 = quotient_0 * down;
  const double qo_1 = quotient_1 * down;
  const double qo_2 = quotient_2 * down;
  const double qo_3 = quotient_3 * down;
  qo->w = (float)qo_0;
  qo->x = (float)qo_1;
  qo->y = (float)qo_2;
  qo->z = (float)qo_3;
}

/* qo = q1 q2 = (w1 w2 - v1·v2; w1 v2 + w2 v1 + v1 × v2).
   q1, q2, qo: quaternion (w; x, y, z), the scalar first.
   16 mul, 12 add.
   Error <= u |result| + 1/8 u^2 S, S the sum of the |terms| of the expanded formula; barring
     over- and underflow. */
static inline void ksl_product_qqf_accurate(const ksl_quaternionf_t *q1,
    const ksl_quaternionf_t *q2, ksl_quaternionf_t *qo) {
  const double qo_0a = (double)q1->w * (double)q2->w, qo_0b = (double)q1->x * (double)q2->x,
      qo_0c = (double)q1->y * (double)q2->y, qo_0d = qo_0b + qo_0c,
      qo_0e = (double)q1->z * (double)q2->z, qo_0f = qo_0d + qo_0e, qo_0 = qo_0a - qo_0f;
  const double qo_1a = (double)q1->w * (double)q2->x, qo_1b = (double)q1->x * (double)q2->w,
      qo_1c = qo_1a + qo_1b, qo_1d = (double)q1->y * (double)q2->z,
      qo_1e = (double)q1->z * (double)q2->y, qo_1f = qo_1d - qo_1e, qo_1 = qo_1c + qo_1f;
  const double qo_2a = (double)q1->w * (double)q2->y, qo_2b = (double)q1->z * (double)q2->x,
      qo_2c = (double)q1->x * (double)q2->z, qo_2d = qo_2b - qo_2c, qo_2e = qo_2a + qo_2d,
      qo_2f = (double)q1->y * (double)q2->w, qo_2 = qo_2e + qo_2f;
  const double qo_3a = (double)q1->w * (double)q2->z, qo_3b = (double)q1->x * (double)q2->y,
      qo_3c = (double)q1->y * (double)q2->x, qo_3d = qo_3b - qo_3c, qo_3e = qo_3a + qo_3d,
      qo_3f = (double)q1->z * (double)q2->w, qo_3 = qo_3e + qo_3f;
  qo->w = (float)qo_0;
  qo->x = (float)qo_1;
  qo->y = (float)qo_2;
  qo->z = (float)qo_3;
}

/* qo = q1* q2, q1* the conjugate.
   q1, q2, qo: quaternion (w; x, y, z), the scalar first.
   16 mul, 12 add.
   Error <= u |result| + (w: 1/8, v: 3/32) u^2 S, S the sum of the |terms| of the expanded
     formula; barring over- and underflow. */
static inline void ksl_product_qconjqf_accurate(const ksl_quaternionf_t *q1,
    const ksl_quaternionf_t *q2, ksl_quaternionf_t *qo) {
  const double qo_0a = (double)q1->w * (double)q2->w, qo_0b = (double)q1->x * (double)q2->x,
      qo_0c = (double)q1->y * (double)q2->y, qo_0d = qo_0b + qo_0c,
      qo_0e = (double)q1->z * (double)q2->z, qo_0f = qo_0d + qo_0e, qo_0 = qo_0a + qo_0f;
  const double qo_1a = (double)q1->w * (double)q2->x, qo_1b = (double)q1->x * (double)q2->w,
      qo_1c = qo_1a - qo_1b, qo_1d = (double)q1->z * (double)q2->y,
      qo_1e = (double)q1->y * (double)q2->z, qo_1f = qo_1d - qo_1e, qo_1 = qo_1c + qo_1f;
  const double qo_2a = (double)q1->w * (double)q2->y, qo_2b = (double)q1->y * (double)q2->w,
      qo_2c = qo_2a - qo_2b, qo_2d = (double)q1->x * (double)q2->z,
      qo_2e = (double)q1->z * (double)q2->x, qo_2f = qo_2d - qo_2e, qo_2 = qo_2c + qo_2f;
  const double qo_3a = (double)q1->w * (double)q2->z, qo_3b = (double)q1->z * (double)q2->w,
      qo_3c = qo_3a - qo_3b, qo_3d = (double)q1->y * (double)q2->x,
      qo_3e = (double)q1->x * (double)q2->y, qo_3f = qo_3d - qo_3e, qo_3 = qo_3c + qo_3f;
  qo->w = (float)qo_0;
  qo->x = (float)qo_1;
  qo->y = (float)qo_2;
  qo->z = (float)qo_3;
}

/* qo = q1 q2*, q2* the conjugate.
   q1, q2, qo: quaternion (w; x, y, z), the scalar first.
   16 mul, 12 add.
   Error <= u |result| + (w: 1/8, v: 3/32) u^2 S, S the sum of the |terms| of the expanded
     formula; barring over- and underflow. */
static inline void ksl_product_qqconjf_accurate(const ksl_quaternionf_t *q1,
    const ksl_quaternionf_t *q2, ksl_quaternionf_t *qo) {
  const double qo_0a = (double)q1->w * (double)q2->w, qo_0b = (double)q1->x * (double)q2->x,
      qo_0c = (double)q1->y * (double)q2->y, qo_0d = qo_0b + qo_0c,
      qo_0e = (double)q1->z * (double)q2->z, qo_0f = qo_0d + qo_0e, qo_0 = qo_0a + qo_0f;
  const double qo_1a = (double)q1->x * (double)q2->w, qo_1b = (double)q1->w * (double)q2->x,
      qo_1c = qo_1a - qo_1b, qo_1d = (double)q1->z * (double)q2->y,
      qo_1e = (double)q1->y * (double)q2->z, qo_1f = qo_1d - qo_1e, qo_1 = qo_1c + qo_1f;
  const double qo_2a = (double)q1->y * (double)q2->w, qo_2b = (double)q1->w * (double)q2->y,
      qo_2c = qo_2a - qo_2b, qo_2d = (double)q1->x * (double)q2->z,
      qo_2e = (double)q1->z * (double)q2->x, qo_2f = qo_2d - qo_2e, qo_2 = qo_2c + qo_2f;
  const double qo_3a = (double)q1->z * (double)q2->w, qo_3b = (double)q1->w * (double)q2->z,
      qo_3c = qo_3a - qo_3b, qo_3d = (double)q1->y * (double)q2->x,
      qo_3e = (double)q1->x * (double)q2->y, qo_3f = qo_3d - qo_3e, qo_3 = qo_3c + qo_3f;
  qo->w = (float)qo_0;
  qo->x = (float)qo_1;
  qo->y = (float)qo_2;
  qo->z = (float)qo_3;
}

/* vo = R(q) v, |q| = 1.
   q: quaternion (w; x, y, z), the scalar first; v, vo: vector.
   18 mul, 12 add.
   Error <= u |result| + 7/32 u^2 S, S the sum of the |terms| of the expanded formula; barring
     over- and underflow. */
static inline void ksl_product_qvf_accurate(const ksl_quaternionf_t *q, const ksl_vec3f_t *v,
    ksl_vec3f_t *vo) {
  const double c_0a = (double)q->y * (double)v->z, c_0b = (double)q->z * (double)v->y,
      c_0 = c_0a - c_0b;
  const double c_1a = (double)q->z * (double)v->x, c_1b = (double)q->x * (double)v->z,
      c_1 = c_1a - c_1b;
  const double c_2a = (double)q->x * (double)v->y, c_2b = (double)q->y * (double)v->x,
      c_2 = c_2a - c_2b;
  const double t_0 = 2.0 * c_0;
  const double t_1 = 2.0 * c_1;
  const double t_2 = 2.0 * c_2;
  const double turn_0a = (double)q->w * t_0, turn_0b = (double)q->y * t_2,
      turn_0c = (double)q->z * t_1, turn_0d = turn_0b - turn_0c, turn_0 = turn_0a + turn_0d;
  const double turn_1a = (double)q->w * t_1, turn_1b = (double)q->z * t_0,
      turn_1c = (double)q->x * t_2, turn_1d = turn_1b - turn_1c, turn_1 = turn_1a + turn_1d;
  const double turn_2a = (double)q->w * t_2, turn_2b = (double)q->x * t_1,
      turn_2c = (double)q->y * t_0, turn_2d = turn_2b - turn_2c, turn_2 = turn_2a + turn_2d;
  const double vo_0 = (double)v->x + turn_0;
  const double vo_1 = (double)v->y + turn_1;
  const double vo_2 = (double)v->z + turn_2;
  vo->x = (float)vo_0;
  vo->y = (float)vo_1;
  vo->z = (float)vo_2;
}

/* vo = R(q)^T v, |q| = 1.
   q: quaternion (w; x, y, z), the scalar first; v, vo: vector.
   18 mul, 12 add.
   Error <= u |result| + 7/32 u^2 S, S the sum of the |terms| of the expanded formula; barring
     over- and underflow. */
static inline void ksl_product_qconjvf_accurate(const ksl_quaternionf_t *q, const ksl_vec3f_t *v,
    ksl_vec3f_t *vo) {
  const double c_0a = (double)q->z * (double)v->y, c_0b = (double)q->y * (double)v->z,
      c_0 = c_0a - c_0b;
  const double c_1a = (double)q->x * (double)v->z, c_1b = (double)q->z * (double)v->x,
      c_1 = c_1a - c_1b;
  const double c_2a = (double)q->y * (double)v->x, c_2b = (double)q->x * (double)v->y,
      c_2 = c_2a - c_2b;
  const double t_0 = 2.0 * c_0;
  const double t_1 = 2.0 * c_1;
  const double t_2 = 2.0 * c_2;
  const double turn_0a = (double)q->w * t_0, turn_0b = (double)q->z * t_1,
      turn_0c = (double)q->y * t_2, turn_0d = turn_0b - turn_0c, turn_0 = turn_0a + turn_0d;
  const double turn_1a = (double)q->w * t_1, turn_1b = (double)q->x * t_2,
      turn_1c = (double)q->z * t_0, turn_1d = turn_1b - turn_1c, turn_1 = turn_1a + turn_1d;
  const double turn_2a = (double)q->w * t_2, turn_2b = (double)q->y * t_0,
      turn_2c = (double)q->x * t_1, turn_2d = turn_2b - turn_2c, turn_2 = turn_2a + turn_2d;
  const double vo_0 = (double)v->x + turn_0;
  const double vo_1 = (double)v->y + turn_1;
  const double vo_2 = (double)v->z + turn_2;
  vo->x = (float)vo_0;
  vo->y = (float)vo_1;
  vo->z = (float)vo_2;
}

/* R = I + 2 (w v~ + v~^2) / q·q, for any q but zero whose square neither over- nor underflows.
   q: quaternion (w; x, y, z), the scalar first; R: rotation or other 3×3 matrix.
   20 mul, 16 add, 1 div. */
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
  const double twice = 2.0 * factor;
  const double m_0a = (double)q->x * (double)q->y, m_0b = (double)q->w * (double)q->z,
      m_0 = m_0a - m_0b;
  const double m_1a = (double)q->w * (double)q->y, m_1b = (double)q->x * (double)q->z,
      m_1 = m_1a + m_1b;
  const double m_2a = (double)q->y * (double)q->z, m_2b = (double)q->w * (double)q->x,
      m_2 = m_2a - m_2b;
  const double m_3 = m_0b + m_0a;
  const double m_4 = m_1b - m_1a;
  const double m_5 = m_2b + m_2a;
  const double R_00 = factor * d0;
  const double R_01 = twice * m_0;
  const double R_02 = twice * m_1;
  const double R_10 = twice * m_3;
  const double R_11 = factor * d1;
  const double R_12 = twice * m_2;
  const double R_20 = twice * m_4;
  const double R_21 = twice * m_5;
  const double R_22 = factor * d2;
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

/* qo with R(qo) = R and w >= 0; of an R that is not quite a rotation, off by as much as R.
   R: rotation or other 3×3 matrix; qo: quaternion (w; x, y, z), the scalar first.
   4 mul, 21 add, 4 div, 1 sqrt, 5 neg, 4 less, 16 select. */
static inline void ksl_quaternionf_from_mat3x3_accurate(const ksl_mat3x3f_t *R,
    ksl_quaternionf_t *qo) {
  const double p_0 = (double)R->m21 - (double)R->m12;
  const double p_1 = (double)R->m02 - (double)R->m20;
  const double p_2 = (double)R->m10 - (double)R->m01;
  const double s_0 = (double)R->m12 + (double)R->m21;
  const double s_1 = (double)R->m02 + (double)R->m20;
  const double s_2 = (double)R->m01 + (double)R->m10;
  const double d_0a = (double)R->m00 + (double)R->m11, d_0b = d_0a + (double)R->m22,
      d_0 = d_0b + 1.0;
  const double d_1a = (double)R->m00 - (double)R->m11, d_1b = d_1a - (double)R->m22,
      d_1 = d_1b + 1.0;
  const double d_2a = (double)R->m11 - (double)R->m00, d_2b = d_2a - (double)R->m22,
      d_2 = d_2b + 1.0;
  const double d_3a = (double)R->m22 - (double)R->m00, d_3b = d_3a - (double)R->m11,
      d_3 = d_3b + 1.0;
  const double low_0 = (double)R->m11 < (double)R->m00 ? p_0 : p_1;
  const double low_1 = (double)R->m11 < (double)R->m00 ? d_1 : s_2;
  const double low_2 = (double)R->m11 < (double)R->m00 ? s_2 : d_2;
  const double low_3 = (double)R->m11 < (double)R->m00 ? s_1 : s_0;
  const double high_0a = -(double)R->m11, high_0 = (double)R->m00 < high_0a ? p_2 : d_0;
  const double high_1 = (double)R->m00 < high_0a ? s_1 : p_0;
  const double high_2 = (double)R->m00 < high_0a ? s_0 : p_1;
  const double high_3 = (double)R->m00 < high_0a ? d_3 : p_2;
  const double column_0 = (double)R->m22 < 0.0 ? low_0 : high_0;
  const double column_1 = (double)R->m22 < 0.0 ? low_1 : high_1;
  const double column_2 = (double)R->m22 < 0.0 ? low_2 : high_2;
  const double column_3 = (double)R->m22 < 0.0 ? low_3 : high_3;
  const double upper_0a = -column_0, upper_0 = column_0 < 0.0 ? upper_0a : column_0;
  const double upper_1a = -column_1, upper_1 = column_0 < 0.0 ? upper_1a : column_1;
  const double upper_2a = -column_2, upper_2 = column_0 < 0.0 ? upper_2a : column_2;
  const double upper_3a = -column_3, upper_3 = column_0 < 0.0 ? upper_3a : column_3;
  const double length_a = upper_0 * upper_0, length_b = upper_1 * upper_1,
      length_c = length_a + length_b, length_d = upper_2 * upper_2, length_e = length_c + length_d,
      length_f = upper_3 * upper_3, length_g = length_e + length_f, length = sqrt(length_g);
  const double qo_0 = upper_0 / length;
  const double qo_1 = upper_1 / length;
  const double qo_2 = upper_2 / length;
  const double qo_3 = upper_3 / length;
  qo->w = (float)qo_0;
  qo->x = (float)qo_1;
  qo->y = (float)qo_2;
  qo->z = (float)qo_3;
}

/* angle = 2 atan2(|v|, |w|), axis = ±v / |v|; 0 <= angle <= π; the axis is (1, 0, 0) where angle
     = 0; any multiple of a quaternion.
   q: quaternion (w; x, y, z), the scalar first; axis: vector.
   8 mul, 2 add, 3 div, 1 sqrt, 1 atan2, 4 neg, 3 abs, 7 less, 1 equal, 12 select. */
static inline float ksl_axis_angle_from_quaternionf_accurate(const ksl_quaternionf_t *q,
    ksl_vec3f_t *axis) {
  const double upper_0a = -(double)q->w, upper_0 = (double)q->w < 0.0 ? upper_0a : (double)q->w;
  const double upper_1a = -(double)q->x, upper_1 = (double)q->w < 0.0 ? upper_1a : (double)q->x;
  const double upper_2a = -(double)q->y, upper_2 = (double)q->w < 0.0 ? upper_2a : (double)q->y;
  const double upper_3a = -(double)q->z, upper_3 = (double)q->w < 0.0 ? upper_3a : (double)q->z;
  const double v_s_size_0 = fabs(upper_1);
  const double v_s_size_1 = fabs(upper_2);
  const double v_s_size_2 = fabs(upper_3);
  const double v_s_largest1 = v_s_size_0 < v_s_size_1 ? v_s_size_1 : v_s_size_0;
  const double v_s_largest2 = v_s_largest1 < v_s_size_2 ? v_s_size_2 : v_s_largest1;
  const double v_s_b = 4.611686018427388e+18 < v_s_largest2 ? 2.710505431213761e-20 : 1.0,
      v_s = v_s_largest2 < 8.881784197001252e-16 ? 1.2676506002282294e+30 : v_s_b;
  const double v_y_0 = upper_1 * v_s;
  const double v_y_1 = upper_2 * v_s;
  const double v_y_2 = upper_3 * v_s;
  const double v_n_a = v_y_0 * v_y_0, v_n_b = v_y_1 * v_y_1, v_n_c = v_n_a + v_n_b,
      v_n_d = v_y_2 * v_y_2, v_n_e = v_n_c + v_n_d, v_n = sqrt(v_n_e);
  const double v_r_b = v_s < 1.0 ? 3.6893488147419103e+19 : 1.0,
      v_r = 1.0 < v_s ? 7.888609052210118e-31 : v_r_b;
  const double n = v_n * v_r;
  const double half = atan2(n, upper_0);
  const double divisor = n == 0.0 ? 1.0 : n;
  const double unit_0 = upper_1 / divisor;
  const double unit_1 = upper_2 / divisor;
  const double unit_2 = upper_3 / divisor;
  const double angle = 2.0 * half;
  const double axis_0 = n == 0.0 ? 1.0 : unit_0;
  axis->x = (float)axis_0;
  axis->y = (float)unit_1;
  axis->z = (float)unit_2;
  return (float)angle;
}

/* vo = θ v/|v|, θ = 2 atan2(|v|, |w|) <= π: the rotation vector of q, or of any multiple of it.
   q: quaternion (w; x, y, z), the scalar first; vo: vector.
   11 mul, 2 add, 1 div, 1 sqrt, 1 atan2, 4 neg, 3 abs, 7 less, 1 equal, 11 select. */
static inline void ksl_quaternionf_log_accurate(const ksl_quaternionf_t *q, ksl_vec3f_t *vo) {
  const double upper_0a = -(double)q->w, upper_0 = (double)q->w < 0.0 ? upper_0a : (double)q->w;
  const double upper_1a = -(double)q->x, upper_1 = (double)q->w < 0.0 ? upper_1a : (double)q->x;
  const double upper_2a = -(double)q->y, upper_2 = (double)q->w < 0.0 ? upper_2a : (double)q->y;
  const double upper_3a = -(double)q->z, upper_3 = (double)q->w < 0.0 ? upper_3a : (double)q->z;
  const double v_s_size_0 = fabs(upper_1);
  const double v_s_size_1 = fabs(upper_2);
  const double v_s_size_2 = fabs(upper_3);
  const double v_s_largest1 = v_s_size_0 < v_s_size_1 ? v_s_size_1 : v_s_size_0;
  const double v_s_largest2 = v_s_largest1 < v_s_size_2 ? v_s_size_2 : v_s_largest1;
  const double v_s_b = 4.611686018427388e+18 < v_s_largest2 ? 2.710505431213761e-20 : 1.0,
      v_s = v_s_largest2 < 8.881784197001252e-16 ? 1.2676506002282294e+30 : v_s_b;
  const double v_y_0 = upper_1 * v_s;
  const double v_y_1 = upper_2 * v_s;
  const double v_y_2 = upper_3 * v_s;
  const double v_n_a = v_y_0 * v_y_0, v_n_b = v_y_1 * v_y_1, v_n_c = v_n_a + v_n_b,
      v_n_d = v_y_2 * v_y_2, v_n_e = v_n_c + v_n_d, v_n = sqrt(v_n_e);
  const double v_r_b = v_s < 1.0 ? 3.6893488147419103e+19 : 1.0,
      v_r = 1.0 < v_s ? 7.888609052210118e-31 : v_r_b;
  const double n = v_n * v_r;
  const double half = atan2(n, upper_0);
  const double divisor = n == 0.0 ? 1.0 : n;
  const double theta = 2.0 * half;
  const double k = theta / divisor;
  const double vector_0 = upper_1 * k;
  const double vector_1 = upper_2 * k;
  const double vector_2 = upper_3 * k;
  vo->x = (float)vector_0;
  vo->y = (float)vector_1;
  vo->z = (float)vector_2;
}

#endif
