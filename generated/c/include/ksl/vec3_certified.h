/* Made by `coscrew generate`; changes are overwritten. */
/* SPDX-License-Identifier: MIT */
/* coscrew 0.2.0.  Copyright (c) 2026 The coscrew authors. */
/* Vectors of three components.
   Certified tier: plain results, and bounds on their errors that always hold. */
#ifndef KSL_VEC3_CERTIFIED_H
#define KSL_VEC3_CERTIFIED_H

#include "ksl_types.h"
#include "ksl_exact.h"
#include "ksl_exactf.h"
#include "elementary.h"
#include "ksl_elementary_error.h"

/* self = a self; |error of self| <= self_bound unless inf or NaN.
   self, self_bound: vector; a: number.
   6 mul, 3 add, 3 abs. */
static inline void ksl_vec3_scale_certified(ksl_vec3_t *self, const double a,
    ksl_vec3_t *self_bound) {
  const double self_0_new = KSL_MUL(self->x, a), self_1_new = KSL_MUL(self->y, a),
      self_2_new = KSL_MUL(self->z, a);
  const double self_0_new_bound = KSL_MUL(1.1102230246251568e-16, fabs(self_0_new)
          + 2.004168360008973e-292),
      self_1_new_bound = KSL_MUL(1.1102230246251568e-16, fabs(self_1_new) + 2.004168360008973e-292),
      self_2_new_bound = KSL_MUL(1.1102230246251568e-16, fabs(self_2_new) + 2.004168360008973e-292);
  self->x = self_0_new;
  self->y = self_1_new;
  self->z = self_2_new;
  self_bound->x = self_0_new_bound;
  self_bound->y = self_1_new_bound;
  self_bound->z = self_2_new_bound;
}

/* y = a x + y; |error of y| <= y_bound unless inf or NaN.
   a: number; x, y, y_bound: vector.
   6 mul, 9 add, 6 abs. */
static inline void ksl_axpy_vv_certified(const double a, const ksl_vec3_t *x, ksl_vec3_t *y,
    ksl_vec3_t *y_bound) {
  const double y_0_new_a = KSL_MUL(a, x->x), y_0_new = y_0_new_a + y->x;
  const double y_1_new_a = KSL_MUL(a, x->y), y_1_new = y_1_new_a + y->y;
  const double y_2_new_a = KSL_MUL(a, x->z), y_2_new = y_2_new_a + y->z;
  const double y_0_new_size = fabs(y_0_new_a) + fabs(y->x),
      y_1_new_size = fabs(y_1_new_a) + fabs(y->y), y_2_new_size = fabs(y_2_new_a) + fabs(y->z);
  const double y_0_new_bound = KSL_MUL(2.2204460492503136e-16, y_0_new_size
          + 2.004168360008973e-292),
      y_1_new_bound = KSL_MUL(2.2204460492503136e-16, y_1_new_size + 2.004168360008973e-292),
      y_2_new_bound = KSL_MUL(2.2204460492503136e-16, y_2_new_size + 2.004168360008973e-292);
  y->x = y_0_new;
  y->y = y_1_new;
  y->z = y_2_new;
  y_bound->x = y_0_new_bound;
  y_bound->y = y_1_new_bound;
  y_bound->z = y_2_new_bound;
}

/* y = x + y; |error of y| <= y_bound unless inf or NaN.
   x, y, y_bound: vector.
   3 mul, 3 add, 3 abs. */
static inline void ksl_xpy_vv_certified(const ksl_vec3_t *x, ksl_vec3_t *y, ksl_vec3_t *y_bound) {
  const double y_0_new = x->x + y->x, y_1_new = x->y + y->y, y_2_new = x->z + y->z;
  const double y_0_new_bound = KSL_MUL(1.1102230246251568e-16, fabs(y_0_new)),
      y_1_new_bound = KSL_MUL(1.1102230246251568e-16, fabs(y_1_new)),
      y_2_new_bound = KSL_MUL(1.1102230246251568e-16, fabs(y_2_new));
  y->x = y_0_new;
  y->y = y_1_new;
  y->z = y_2_new;
  y_bound->x = y_0_new_bound;
  y_bound->y = y_1_new_bound;
  y_bound->z = y_2_new_bound;
}

/* y = -x + y; |error of y| <= y_bound unless inf or NaN.
   x, y, y_bound: vector.
   3 mul, 3 add, 3 abs. */
static inline void ksl_nxpy_vv_certified(const ksl_vec3_t *x, ksl_vec3_t *y, ksl_vec3_t *y_bound) {
  const double y_0_new = y->x - x->x, y_1_new = y->y - x->y, y_2_new = y->z - x->z;
  const double y_0_new_bound = KSL_MUL(1.1102230246251568e-16, fabs(y_0_new)),
      y_1_new_bound = KSL_MUL(1.1102230246251568e-16, fabs(y_1_new)),
      y_2_new_bound = KSL_MUL(1.1102230246251568e-16, fabs(y_2_new));
  y->x = y_0_new;
  y->y = y_1_new;
  y->z = y_2_new;
  y_bound->x = y_0_new_bound;
  y_bound->y = y_1_new_bound;
  y_bound->z = y_2_new_bound;
}

/* vo = a vi; |error of vo| <= vo_bound unless inf or NaN.
   a: number; vi, vo, vo_bound: vector.
   6 mul, 3 add, 3 abs. */
static inline void ksl_product_av_certified(const double a, const ksl_vec3_t *vi, ksl_vec3_t *vo,
    ksl_vec3_t *vo_bound) {
  const double vo_0 = KSL_MUL(a, vi->x), vo_1 = KSL_MUL(a, vi->y), vo_2 = KSL_MUL(a, vi->z);
  const double vo_0_bound = KSL_MUL(1.1102230246251568e-16, fabs(vo_0) + 2.004168360008973e-292),
      vo_1_bound = KSL_MUL(1.1102230246251568e-16, fabs(vo_1) + 2.004168360008973e-292),
      vo_2_bound = KSL_MUL(1.1102230246251568e-16, fabs(vo_2) + 2.004168360008973e-292);
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
  vo_bound->x = vo_0_bound;
  vo_bound->y = vo_1_bound;
  vo_bound->z = vo_2_bound;
}

/* vo = v1 + v2; |error of vo| <= vo_bound unless inf or NaN.
   v1, v2, vo, vo_bound: vector.
   3 mul, 3 add, 3 abs. */
static inline void ksl_add_vv_certified(const ksl_vec3_t *v1, const ksl_vec3_t *v2,
    ksl_vec3_t *vo, ksl_vec3_t *vo_bound) {
  const double vo_0 = v1->x + v2->x, vo_1 = v1->y + v2->y, vo_2 = v1->z + v2->z;
  const double vo_0_bound = KSL_MUL(1.1102230246251568e-16, fabs(vo_0)),
      vo_1_bound = KSL_MUL(1.1102230246251568e-16, fabs(vo_1)),
      vo_2_bound = KSL_MUL(1.1102230246251568e-16, fabs(vo_2));
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
  vo_bound->x = vo_0_bound;
  vo_bound->y = vo_1_bound;
  vo_bound->z = vo_2_bound;
}

/* vo = v1 - v2; |error of vo| <= vo_bound unless inf or NaN.
   v1, v2, vo, vo_bound: vector.
   3 mul, 3 add, 3 abs. */
static inline void ksl_subtract_vv_certified(const ksl_vec3_t *v1, const ksl_vec3_t *v2,
    ksl_vec3_t *vo, ksl_vec3_t *vo_bound) {
  const double vo_0 = v1->x - v2->x, vo_1 = v1->y - v2->y, vo_2 = v1->z - v2->z;
  const double vo_0_bound = KSL_MUL(1.1102230246251568e-16, fabs(vo_0)),
      vo_1_bound = KSL_MUL(1.1102230246251568e-16, fabs(vo_1)),
      vo_2_bound = KSL_MUL(1.1102230246251568e-16, fabs(vo_2));
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
  vo_bound->x = vo_0_bound;
  vo_bound->y = vo_1_bound;
  vo_bound->z = vo_2_bound;
}

/* vo = k v; |error of vo| <= vo_bound unless inf or NaN.
   v, vo, vo_bound: vector; k: number.
   6 mul, 3 add, 3 abs. */
static inline void ksl_vec3_scaled_certified(const ksl_vec3_t *v, const double k, ksl_vec3_t *vo,
    ksl_vec3_t *vo_bound) {
  const double vo_0 = KSL_MUL(v->x, k), vo_1 = KSL_MUL(v->y, k), vo_2 = KSL_MUL(v->z, k);
  const double vo_0_bound = KSL_MUL(1.1102230246251568e-16, fabs(vo_0) + 2.004168360008973e-292),
      vo_1_bound = KSL_MUL(1.1102230246251568e-16, fabs(vo_1) + 2.004168360008973e-292),
      vo_2_bound = KSL_MUL(1.1102230246251568e-16, fabs(vo_2) + 2.004168360008973e-292);
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
  vo_bound->x = vo_0_bound;
  vo_bound->y = vo_1_bound;
  vo_bound->z = vo_2_bound;
}

/* angle = atan2(|v1 × v2|, v1·v2), in [0, π]; |error of angle| <= angle_bound unless inf or NaN.
   v1, v2: vector; angle_bound: number.
   196 mul, 311 add, 22 product error, 12 product rest, 12 div, 2 sqrt, 1 neg, 40 abs, 4
     copysign, 37 less, 5 equal, 56 select. */
static inline double ksl_angle_vv_certified(const ksl_vec3_t *v1, const ksl_vec3_t *v2,
    double *angle_bound) {
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
  const double c_0a = KSL_MUL(scaled_s1_1, scaled_s2_2),
      c_0a_padded_1 = 1.8051943758648296e-276 + fabs(scaled_s1_1),
      c_0a_padded_2 = 1.8051943758648296e-276 + fabs(scaled_s2_2),
      c_0b = KSL_MUL(scaled_s1_2, scaled_s2_1),
      c_0b_padded_1 = 1.8051943758648296e-276 + fabs(scaled_s1_2),
      c_0b_padded_2 = 1.8051943758648296e-276 + fabs(scaled_s2_1), c_0 = c_0a - c_0b,
      c_right_1 = c_0a - c_0;
  const double c_1a = KSL_MUL(scaled_s1_2, scaled_s2_0),
      c_1a_padded_1 = 1.8051943758648296e-276 + fabs(scaled_s2_0),
      c_1b = KSL_MUL(scaled_s1_0, scaled_s2_2),
      c_1b_padded_1 = 1.8051943758648296e-276 + fabs(scaled_s1_0), c_1 = c_1a - c_1b,
      c_right_2 = c_1a - c_1;
  const double c_2a = KSL_MUL(scaled_s1_0, scaled_s2_1), c_2b = KSL_MUL(scaled_s1_1, scaled_s2_0),
      c_2 = c_2a - c_2b, c_right_3 = c_2a - c_2;
  const double s_size_0 = fabs(c_0), s_size_1 = fabs(c_1), s_size_2 = fabs(c_2);
  const double s_largest1 = s_size_0 < s_size_1 ? s_size_1 : s_size_0;
  const double s_largest2 = s_largest1 < s_size_2 ? s_size_2 : s_largest1;
  const double s_b = 6.703903964971299e+153 < s_largest2 ? 3.7291703656001034e-155 : 1.0,
      s_b_size_1 = 6.703903964971299e+153 < s_largest2 ? 3.7291703656001034e-155 : 1.0,
      s_d = s_largest2 < 256.0 ? 1.3093562431584567e+151 : s_b,
      s_d_size_1 = s_largest2 < 256.0 ? 1.3093562431584567e+151 : s_b_size_1,
      s = s_largest2 < 1.955159272639747e-149 ? 1.0715086071862673e+301 : s_d,
      s_size_3 = s_largest2 < 1.955159272639747e-149 ? 1.0715086071862673e+301 : s_d_size_1;
  const double y_0 = KSL_MUL(c_0, s), y_inverse_1 = 1.0 / s;
  const double c_lo_1 = ksl_product_rest(scaled_s1_1, scaled_s2_2, c_0a, c_0 + c_right_1)
          - ksl_product_rest(scaled_s1_2, scaled_s2_1, c_0b, c_right_1);
  const double y_lo_1 = KSL_MUL(c_0 - KSL_MUL(y_0, y_inverse_1) + c_lo_1, s);
  const double y_1 = KSL_MUL(c_1, s);
  const double c_lo_2 = ksl_product_rest(scaled_s1_2, scaled_s2_0, c_1a, c_1 + c_right_2)
          - ksl_product_rest(scaled_s1_0, scaled_s2_2, c_1b, c_right_2);
  const double y_lo_2 = KSL_MUL(c_1 - KSL_MUL(y_1, y_inverse_1) + c_lo_2, s);
  const double y_2 = KSL_MUL(c_2, s);
  const double c_lo_3 = ksl_product_rest(scaled_s1_0, scaled_s2_1, c_2a, c_2 + c_right_3)
          - ksl_product_rest(scaled_s1_1, scaled_s2_0, c_2b, c_right_3);
  const double y_lo_3 = KSL_MUL(c_2 - KSL_MUL(y_2, y_inverse_1) + c_lo_3, s);
  const double n_a = KSL_MUL(y_0, y_0);
  const double y_size_1 = KSL_MUL(s_size_3, 1.8051943758648296e-276
          + (KSL_MUL(c_0a_padded_1, c_0a_padded_2) + KSL_MUL(c_0b_padded_1, c_0b_padded_2)));
  const double n_a_padded_1 = 1.8051943758648296e-276 + y_size_1,
      n_a_size_2 = KSL_MUL(n_a_padded_1, fabs(y_0)
          + KSL_MUL(140737488355328.0, fabs(y_lo_1)
          + KSL_MUL(1.6886556573573792e-30, n_a_padded_1))), n_b = KSL_MUL(y_1, y_1);
  const double y_size_2 = KSL_MUL(s_size_3, 1.8051943758648296e-276
          + (KSL_MUL(c_0b_padded_1, c_1a_padded_1) + KSL_MUL(c_0a_padded_2, c_1b_padded_1)));
  const double n_b_padded_1 = 1.8051943758648296e-276 + y_size_2,
      n_b_size_2 = KSL_MUL(n_b_padded_1, fabs(y_1)
          + KSL_MUL(140737488355328.0, fabs(y_lo_2)
          + KSL_MUL(1.6886556573573792e-30, n_b_padded_1))), n_c = n_a + n_b,
      n_c_right_1 = n_c - n_a,
      n_c_lo1_1 = ksl_product_rest(y_0, y_0, n_a, n_c - n_c_right_1)
          + ksl_product_rest(y_1, y_1, n_b, n_c_right_1), n_d = KSL_MUL(y_2, y_2);
  const double y_size_3 = KSL_MUL(s_size_3, 1.8051943758648296e-276
          + (KSL_MUL(c_0b_padded_2, c_1b_padded_1) + KSL_MUL(c_0a_padded_1, c_1a_padded_1)));
  const double n_d_padded_1 = 1.8051943758648296e-276 + y_size_3,
      n_d_size_2 = KSL_MUL(n_d_padded_1, fabs(y_2)
          + KSL_MUL(140737488355328.0, fabs(y_lo_3)
          + KSL_MUL(1.6886556573573792e-30, n_d_padded_1))), n_e = n_c + n_d,
      n_e_right_1 = n_e - n_c,
      n_e_lo2_1 = n_c - (n_e - n_e_right_1) + ksl_product_rest(y_2, y_2, n_d, n_e_right_1)
          + (KSL_MUL(y_lo_3, y_2) + KSL_MUL(y_2, y_lo_3)),
      n_e_lo = n_e_lo2_1
          + (n_c_lo1_1
          + (KSL_MUL(y_lo_1, y_0) + KSL_MUL(y_0, y_lo_1)
          + (KSL_MUL(y_lo_2, y_1) + KSL_MUL(y_1, y_lo_2)))), n = sqrt(n_e),
      n_product_1 = KSL_MUL(n, n), n_twice_1 = n + n,
      n_lo = (n_e - n_product_1 - ksl_product_error(n, n, n_product_1) + n_e_lo)
          / (n == 0.0 ? 1.0 : n_twice_1),
      n_padded_1 = 1.8051943758648296e-276
          + (n_a_size_2 + n_a_size_2 + (n_b_size_2 + n_b_size_2) + (n_d_size_2 + n_d_size_2)),
      n_bound_1 = fabs(n_e_lo) + KSL_MUL(8.430953463617394e-30, n_padded_1),
      n_size_4 = KSL_MUL(fabs(n_e) + KSL_MUL(140737488355328.0, n_bound_1), n_padded_1 / n / n_e),
      n_size_8 = KSL_MUL(1.2578234859437304e+29, sqrt(n_bound_1) + fabs(n_lo));
  const double r_b = s < 1.0 ? 2.6815615859885194e+154 : 1.0,
      r_b_size_1 = s < 1.0 ? 2.6815615859885194e+154 : 1.0,
      r_d = 1.0 < s ? 7.637340908749012e-152 : r_b,
      r_d_size_1 = 1.0 < s ? 7.637340908749012e-152 : r_b_size_1,
      r = 1.3093562431584567e+151 < s ? 9.332636185032189e-302 : r_d;
  const double cross = KSL_MUL(n, r), cross_lo = KSL_MUL(n - KSL_MUL(cross, 1.0 / r) + n_lo, r),
      cross_padded_1 = 1.8051943758648296e-276
          + (n + (KSL_MUL(4.0, n_bound_1) < n_e ? n_size_4 : n_size_8));
  const double dot__a = KSL_MUL(scaled_s1_0, scaled_s2_0),
      dot__b = KSL_MUL(scaled_s1_1, scaled_s2_1), dot__c = dot__a + dot__b,
      dot__c_right_1 = dot__c - dot__a,
      dot__c_left_rest_1 = ksl_product_rest(scaled_s1_0, scaled_s2_0, dot__a, dot__c
          - dot__c_right_1), dot__d = KSL_MUL(scaled_s1_2, scaled_s2_2), dot_ = dot__c + dot__d,
      dot__right_1 = dot_ - dot__c,
      dot__lo1_1 = dot__c - (dot_ - dot__right_1)
          + ksl_product_rest(scaled_s1_2, scaled_s2_2, dot__d, dot__right_1),
      dot__lo = dot__lo1_1
          + (dot__c_left_rest_1
          + ksl_product_rest(scaled_s1_1, scaled_s2_1, dot__b, dot__c_right_1));
  const double angle = ksl_atan2(cross, dot_), angle_size0_1 = fabs(cross),
      angle_size1_1 = fabs(dot_),
      angle_most_1 = angle_size0_1 < angle_size1_1 ? angle_size1_1 : angle_size0_1,
      angle_divisor_1 = angle_most_1 == 0.0 ? 1.0 : angle_most_1,
      angle_part0_1 = cross / angle_divisor_1, angle_part1_1 = dot_ / angle_divisor_1,
      angle_divisor2_1 = KSL_MUL(angle_divisor_1, KSL_MUL(angle_part1_1, angle_part1_1)
          + KSL_MUL(angle_part0_1, angle_part0_1)),
      angle_more_1 = (KSL_MUL(angle_part1_1, cross_lo) - KSL_MUL(angle_part0_1, dot__lo))
          / (angle_most_1 == 0.0 ? 1.0 : angle_divisor2_1),
      angle_padded_1 = 1.8051943758648296e-276
          + KSL_MUL(cross_padded_1, 1.3093562431584567e+151 < s ? 9.332636185032189e-302
          : r_d_size_1);
  const double dot__size_1 = KSL_MUL(c_1a_padded_1, c_1b_padded_1)
          + KSL_MUL(c_0a_padded_1, c_0b_padded_2) + KSL_MUL(c_0a_padded_2, c_0b_padded_1);
  const double angle_padded_2 = 1.8051943758648296e-276 + dot__size_1, angle_size_2 = fabs(cross),
      angle_size_3 = fabs(dot_),
      angle_size_5 = angle_size_2 < angle_size_3 ? angle_size_3 : angle_size_2,
      angle_bound_1 = fabs(cross_lo) + KSL_MUL(8.751429663976426e-30, angle_padded_1),
      angle_bound_2 = fabs(dot__lo) + KSL_MUL(2.477516562578394e-30, angle_padded_2),
      angle_size_11 = (angle_bound_2 + (1.8051943758648296e-276 + angle_bound_1)) / angle_size_5,
      angle_size_13 = KSL_MUL(angle_size_11, angle_size_11),
      angle_size_14 = fabs(ksl_atan2_error(cross, dot_, angle) + angle_more_1),
      angle_size_15 = 7.0 + angle_size_14,
      angle_size_18 = angle_bound_2 < dot_ ? angle_size_13 : angle_size_15,
      angle_size_19 = angle_bound_1 < angle_size_2 ? angle_size_13 : angle_size_18,
      angle_size_21 = KSL_MUL(3.9614069451219335e+28, angle_size_11 < 0.25 ? angle_size_19
          : angle_size_15);
  const double angle_padded_3 = 1.8051943758648296e-276
          + (fabs(angle) + (angle_padded_1 + angle_padded_2) / angle_size_5 + angle_size_21),
      angle_bound_3 = KSL_MUL(2.603241918220875e-29, angle_padded_3) + angle_size_14;
  *angle_bound = angle_bound_3;
  return angle;
}

/* v1·v2; |error of dot| <= dot_bound unless inf or NaN.
   v1, v2: vector; dot_bound: number.
   4 mul, 5 add, 3 abs. */
static inline double ksl_dot_vv_certified(const ksl_vec3_t *v1, const ksl_vec3_t *v2,
    double *dot_bound) {
  const double dot_a = KSL_MUL(v1->x, v2->x), dot_b = KSL_MUL(v1->y, v2->y),
      dot_d = KSL_MUL(v1->z, v2->z), dot = dot_a + dot_b + dot_d;
  const double dot_size = fabs(dot_a) + fabs(dot_b) + fabs(dot_d);
  const double dot_bound_ = KSL_MUL(3.3306690738754706e-16, dot_size + 2.004168360008973e-292);
  *dot_bound = dot_bound_;
  return dot;
}

/* vo = k (-v); |error of vo| <= vo_bound unless inf or NaN.
   k: number; v, vo, vo_bound: vector.
   6 mul, 3 add, 3 neg, 3 abs. */
static inline void ksl_product_avinv_certified(const double k, const ksl_vec3_t *v,
    ksl_vec3_t *vo, ksl_vec3_t *vo_bound) {
  const double vo_0a = KSL_MUL(k, v->x), vo_0 = -vo_0a;
  const double vo_1a = KSL_MUL(k, v->y), vo_1 = -vo_1a;
  const double vo_2a = KSL_MUL(k, v->z), vo_2 = -vo_2a;
  const double vo_0a_bound = KSL_MUL(1.1102230246251568e-16, fabs(vo_0a) + 2.004168360008973e-292);
  const double vo_1a_bound = KSL_MUL(1.1102230246251568e-16, fabs(vo_1a) + 2.004168360008973e-292);
  const double vo_2a_bound = KSL_MUL(1.1102230246251568e-16, fabs(vo_2a) + 2.004168360008973e-292);
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
  vo_bound->x = vo_0a_bound;
  vo_bound->y = vo_1a_bound;
  vo_bound->z = vo_2a_bound;
}

/* vo = v1 × v2; |error of vo| <= vo_bound unless inf or NaN.  Exactly zero for v1 = v2, unless
     products overflow.
   v1, v2, vo, vo_bound: vector.
   9 mul, 9 add, 6 abs. */
static inline void ksl_cross_vv_certified(const ksl_vec3_t *v1, const ksl_vec3_t *v2,
    ksl_vec3_t *vo, ksl_vec3_t *vo_bound) {
  const double vo_0a = KSL_MUL(v1->y, v2->z), vo_0b = KSL_MUL(v1->z, v2->y), vo_0 = vo_0a - vo_0b;
  const double vo_1a = KSL_MUL(v1->z, v2->x), vo_1b = KSL_MUL(v1->x, v2->z), vo_1 = vo_1a - vo_1b;
  const double vo_2a = KSL_MUL(v1->x, v2->y), vo_2b = KSL_MUL(v1->y, v2->x), vo_2 = vo_2a - vo_2b;
  const double vo_0_size = fabs(vo_0a) + fabs(vo_0b), vo_1_size = fabs(vo_1a) + fabs(vo_1b),
      vo_2_size = fabs(vo_2a) + fabs(vo_2b);
  const double vo_0_bound = KSL_MUL(2.2204460492503136e-16, vo_0_size + 2.004168360008973e-292),
      vo_1_bound = KSL_MUL(2.2204460492503136e-16, vo_1_size + 2.004168360008973e-292),
      vo_2_bound = KSL_MUL(2.2204460492503136e-16, vo_2_size + 2.004168360008973e-292);
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
  vo_bound->x = vo_0_bound;
  vo_bound->y = vo_1_bound;
  vo_bound->z = vo_2_bound;
}

/* vo = v1 × (-v2); |error of vo| <= vo_bound unless inf or NaN.
   v1, v2, vo, vo_bound: vector.
   9 mul, 9 add, 6 abs. */
static inline void ksl_cross_vvinv_certified(const ksl_vec3_t *v1, const ksl_vec3_t *v2,
    ksl_vec3_t *vo, ksl_vec3_t *vo_bound) {
  const double vo_0a = KSL_MUL(v1->z, v2->y), vo_0b = KSL_MUL(v1->y, v2->z), vo_0 = vo_0a - vo_0b;
  const double vo_1a = KSL_MUL(v1->x, v2->z), vo_1b = KSL_MUL(v1->z, v2->x), vo_1 = vo_1a - vo_1b;
  const double vo_2a = KSL_MUL(v1->y, v2->x), vo_2b = KSL_MUL(v1->x, v2->y), vo_2 = vo_2a - vo_2b;
  const double vo_0_size = fabs(vo_0a) + fabs(vo_0b), vo_1_size = fabs(vo_1a) + fabs(vo_1b),
      vo_2_size = fabs(vo_2a) + fabs(vo_2b);
  const double vo_0_bound = KSL_MUL(2.2204460492503136e-16, vo_0_size + 2.004168360008973e-292),
      vo_1_bound = KSL_MUL(2.2204460492503136e-16, vo_1_size + 2.004168360008973e-292),
      vo_2_bound = KSL_MUL(2.2204460492503136e-16, vo_2_size + 2.004168360008973e-292);
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
  vo_bound->x = vo_0_bound;
  vo_bound->y = vo_1_bound;
  vo_bound->z = vo_2_bound;
}

/* vo = v + k e_x; |error of vo| <= vo_bound unless inf or NaN.
   v, vo, vo_bound: vector; k: number.
   1 mul, 1 add, 1 abs. */
static inline void ksl_add_vvx_certified(const ksl_vec3_t *v, const double k, ksl_vec3_t *vo,
    ksl_vec3_t *vo_bound) {
  const double vo_0 = v->x + k;
  const double vo_0_bound = KSL_MUL(1.1102230246251568e-16, fabs(vo_0));
  const double v_y = v->y;
  const double v_z = v->z;
  vo->x = vo_0;
  vo->y = v_y;
  vo->z = v_z;
  vo_bound->x = vo_0_bound;
  vo_bound->y = 0.0;
  vo_bound->z = 0.0;
}

/* vo = v - k e_x; |error of vo| <= vo_bound unless inf or NaN.
   v, vo, vo_bound: vector; k: number.
   1 mul, 1 add, 1 abs. */
static inline void ksl_add_vvxinv_certified(const ksl_vec3_t *v, const double k, ksl_vec3_t *vo,
    ksl_vec3_t *vo_bound) {
  const double vo_0 = v->x - k;
  const double vo_0_bound = KSL_MUL(1.1102230246251568e-16, fabs(vo_0));
  const double v_y = v->y;
  const double v_z = v->z;
  vo->x = vo_0;
  vo->y = v_y;
  vo->z = v_z;
  vo_bound->x = vo_0_bound;
  vo_bound->y = 0.0;
  vo_bound->z = 0.0;
}

/* vo = v + k e_y; |error of vo| <= vo_bound unless inf or NaN.
   v, vo, vo_bound: vector; k: number.
   1 mul, 1 add, 1 abs. */
static inline void ksl_add_vvy_certified(const ksl_vec3_t *v, const double k, ksl_vec3_t *vo,
    ksl_vec3_t *vo_bound) {
  const double vo_1 = v->y + k;
  const double vo_1_bound = KSL_MUL(1.1102230246251568e-16, fabs(vo_1));
  const double v_x = v->x;
  const double v_z = v->z;
  vo->x = v_x;
  vo->y = vo_1;
  vo->z = v_z;
  vo_bound->x = 0.0;
  vo_bound->y = vo_1_bound;
  vo_bound->z = 0.0;
}

/* vo = v - k e_y; |error of vo| <= vo_bound unless inf or NaN.
   v, vo, vo_bound: vector; k: number.
   1 mul, 1 add, 1 abs. */
static inline void ksl_add_vvyinv_certified(const ksl_vec3_t *v, const double k, ksl_vec3_t *vo,
    ksl_vec3_t *vo_bound) {
  const double vo_1 = v->y - k;
  const double vo_1_bound = KSL_MUL(1.1102230246251568e-16, fabs(vo_1));
  const double v_x = v->x;
  const double v_z = v->z;
  vo->x = v_x;
  vo->y = vo_1;
  vo->z = v_z;
  vo_bound->x = 0.0;
  vo_bound->y = vo_1_bound;
  vo_bound->z = 0.0;
}

/* vo = v + k e_z; |error of vo| <= vo_bound unless inf or NaN.
   v, vo, vo_bound: vector; k: number.
   1 mul, 1 add, 1 abs. */
static inline void ksl_add_vvz_certified(const ksl_vec3_t *v, const double k, ksl_vec3_t *vo,
    ksl_vec3_t *vo_bound) {
  const double vo_2 = v->z + k;
  const double vo_2_bound = KSL_MUL(1.1102230246251568e-16, fabs(vo_2));
  const double v_x = v->x;
  const double v_y = v->y;
  vo->x = v_x;
  vo->y = v_y;
  vo->z = vo_2;
  vo_bound->x = 0.0;
  vo_bound->y = 0.0;
  vo_bound->z = vo_2_bound;
}

/* vo = v - k e_z; |error of vo| <= vo_bound unless inf or NaN.
   v, vo, vo_bound: vector; k: number.
   1 mul, 1 add, 1 abs. */
static inline void ksl_add_vvzinv_certified(const ksl_vec3_t *v, const double k, ksl_vec3_t *vo,
    ksl_vec3_t *vo_bound) {
  const double vo_2 = v->z - k;
  const double vo_2_bound = KSL_MUL(1.1102230246251568e-16, fabs(vo_2));
  const double v_x = v->x;
  const double v_y = v->y;
  vo->x = v_x;
  vo->y = v_y;
  vo->z = vo_2;
  vo_bound->x = 0.0;
  vo_bound->y = 0.0;
  vo_bound->z = vo_2_bound;
}

/* self = a self; |error of self| <= self_bound unless inf or NaN.
   self, self_bound: vector; a: number.
   6 mul, 3 add, 3 abs. */
static inline void ksl_vec3f_scale_certified(ksl_vec3f_t *self, const float a,
    ksl_vec3f_t *self_bound) {
  const float self_0_new = KSL_MULF(self->x, a), self_1_new = KSL_MULF(self->y, a),
      self_2_new = KSL_MULF(self->z, a);
  const float self_0_new_bound = KSL_MULF(5.960465e-08f, fabsf(self_0_new) + 1.9721523e-31f),
      self_1_new_bound = KSL_MULF(5.960465e-08f, fabsf(self_1_new) + 1.9721523e-31f),
      self_2_new_bound = KSL_MULF(5.960465e-08f, fabsf(self_2_new) + 1.9721523e-31f);
  self->x = self_0_new;
  self->y = self_1_new;
  self->z = self_2_new;
  self_bound->x = self_0_new_bound;
  self_bound->y = self_1_new_bound;
  self_bound->z = self_2_new_bound;
}

/* y = a x + y; |error of y| <= y_bound unless inf or NaN.
   a: number; x, y, y_bound: vector.
   6 mul, 9 add, 6 abs. */
static inline void ksl_axpy_vvf_certified(const float a, const ksl_vec3f_t *x, ksl_vec3f_t *y,
    ksl_vec3f_t *y_bound) {
  const float y_0_new_a = KSL_MULF(a, x->x), y_0_new = y_0_new_a + y->x;
  const float y_1_new_a = KSL_MULF(a, x->y), y_1_new = y_1_new_a + y->y;
  const float y_2_new_a = KSL_MULF(a, x->z), y_2_new = y_2_new_a + y->z;
  const float y_0_new_size = fabsf(y_0_new_a) + fabsf(y->x),
      y_1_new_size = fabsf(y_1_new_a) + fabsf(y->y), y_2_new_size = fabsf(y_2_new_a) + fabsf(y->z);
  const float y_0_new_bound = KSL_MULF(1.192093e-07f, y_0_new_size + 1.9721523e-31f),
      y_1_new_bound = KSL_MULF(1.192093e-07f, y_1_new_size + 1.9721523e-31f),
      y_2_new_bound = KSL_MULF(1.192093e-07f, y_2_new_size + 1.9721523e-31f);
  y->x = y_0_new;
  y->y = y_1_new;
  y->z = y_2_new;
  y_bound->x = y_0_new_bound;
  y_bound->y = y_1_new_bound;
  y_bound->z = y_2_new_bound;
}

/* y = x + y; |error of y| <= y_bound unless inf or NaN.
   x, y, y_bound: vector.
   3 mul, 3 add, 3 abs. */
static inline void ksl_xpy_vvf_certified(const ksl_vec3f_t *x, ksl_vec3f_t *y,
    ksl_vec3f_t *y_bound) {
  const float y_0_new = x->x + y->x, y_1_new = x->y + y->y, y_2_new = x->z + y->z;
  const float y_0_new_bound = KSL_MULF(5.960465e-08f, fabsf(y_0_new)),
      y_1_new_bound = KSL_MULF(5.960465e-08f, fabsf(y_1_new)),
      y_2_new_bound = KSL_MULF(5.960465e-08f, fabsf(y_2_new));
  y->x = y_0_new;
  y->y = y_1_new;
  y->z = y_2_new;
  y_bound->x = y_0_new_bound;
  y_bound->y = y_1_new_bound;
  y_bound->z = y_2_new_bound;
}

/* y = -x + y; |error of y| <= y_bound unless inf or NaN.
   x, y, y_bound: vector.
   3 mul, 3 add, 3 abs. */
static inline void ksl_nxpy_vvf_certified(const ksl_vec3f_t *x, ksl_vec3f_t *y,
    ksl_vec3f_t *y_bound) {
  const float y_0_new = y->x - x->x, y_1_new = y->y - x->y, y_2_new = y->z - x->z;
  const float y_0_new_bound = KSL_MULF(5.960465e-08f, fabsf(y_0_new)),
      y_1_new_bound = KSL_MULF(5.960465e-08f, fabsf(y_1_new)),
      y_2_new_bound = KSL_MULF(5.960465e-08f, fabsf(y_2_new));
  y->x = y_0_new;
  y->y = y_1_new;
  y->z = y_2_new;
  y_bound->x = y_0_new_bound;
  y_bound->y = y_1_new_bound;
  y_bound->z = y_2_new_bound;
}

/* vo = a vi; |error of vo| <= vo_bound unless inf or NaN.
   a: number; vi, vo, vo_bound: vector.
   6 mul, 3 add, 3 abs. */
static inline void ksl_product_avf_certified(const float a, const ksl_vec3f_t *vi,
    ksl_vec3f_t *vo, ksl_vec3f_t *vo_bound) {
  const float vo_0 = KSL_MULF(a, vi->x), vo_1 = KSL_MULF(a, vi->y), vo_2 = KSL_MULF(a, vi->z);
  const float vo_0_bound = KSL_MULF(5.960465e-08f, fabsf(vo_0) + 1.9721523e-31f),
      vo_1_bound = KSL_MULF(5.960465e-08f, fabsf(vo_1) + 1.9721523e-31f),
      vo_2_bound = KSL_MULF(5.960465e-08f, fabsf(vo_2) + 1.9721523e-31f);
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
  vo_bound->x = vo_0_bound;
  vo_bound->y = vo_1_bound;
  vo_bound->z = vo_2_bound;
}

/* vo = v1 + v2; |error of vo| <= vo_bound unless inf or NaN.
   v1, v2, vo, vo_bound: vector.
   3 mul, 3 add, 3 abs. */
static inline void ksl_add_vvf_certified(const ksl_vec3f_t *v1, const ksl_vec3f_t *v2,
    ksl_vec3f_t *vo, ksl_vec3f_t *vo_bound) {
  const float vo_0 = v1->x + v2->x, vo_1 = v1->y + v2->y, vo_2 = v1->z + v2->z;
  const float vo_0_bound = KSL_MULF(5.960465e-08f, fabsf(vo_0)),
      vo_1_bound = KSL_MULF(5.960465e-08f, fabsf(vo_1)),
      vo_2_bound = KSL_MULF(5.960465e-08f, fabsf(vo_2));
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
  vo_bound->x = vo_0_bound;
  vo_bound->y = vo_1_bound;
  vo_bound->z = vo_2_bound;
}

/* vo = v1 - v2; |error of vo| <= vo_bound unless inf or NaN.
   v1, v2, vo, vo_bound: vector.
   3 mul, 3 add, 3 abs. */
static inline void ksl_subtract_vvf_certified(const ksl_vec3f_t *v1, const ksl_vec3f_t *v2,
    ksl_vec3f_t *vo, ksl_vec3f_t *vo_bound) {
  const float vo_0 = v1->x - v2->x, vo_1 = v1->y - v2->y, vo_2 = v1->z - v2->z;
  const float vo_0_bound = KSL_MULF(5.960465e-08f, fabsf(vo_0)),
      vo_1_bound = KSL_MULF(5.960465e-08f, fabsf(vo_1)),
      vo_2_bound = KSL_MULF(5.960465e-08f, fabsf(vo_2));
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
  vo_bound->x = vo_0_bound;
  vo_bound->y = vo_1_bound;
  vo_bound->z = vo_2_bound;
}

/* vo = k v; |error of vo| <= vo_bound unless inf or NaN.
   v, vo, vo_bound: vector; k: number.
   6 mul, 3 add, 3 abs. */
static inline void ksl_vec3f_scaled_certified(const ksl_vec3f_t *v, const float k,
    ksl_vec3f_t *vo, ksl_vec3f_t *vo_bound) {
  const float vo_0 = KSL_MULF(v->x, k), vo_1 = KSL_MULF(v->y, k), vo_2 = KSL_MULF(v->z, k);
  const float vo_0_bound = KSL_MULF(5.960465e-08f, fabsf(vo_0) + 1.9721523e-31f),
      vo_1_bound = KSL_MULF(5.960465e-08f, fabsf(vo_1) + 1.9721523e-31f),
      vo_2_bound = KSL_MULF(5.960465e-08f, fabsf(vo_2) + 1.9721523e-31f);
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
  vo_bound->x = vo_0_bound;
  vo_bound->y = vo_1_bound;
  vo_bound->z = vo_2_bound;
}

/* angle = atan2(|v1 × v2|, v1·v2), in [0, π]; |error of angle| <= angle_bound unless inf or NaN.
   v1, v2: vector; angle_bound: number.
   162 mul, 252 add, 15 product error, 12 product rest, 12 div, 2 sqrt, 1 neg, 40 abs, 4
     copysign, 37 less, 5 equal, 56 select. */
static inline float ksl_angle_vvf_certified(const ksl_vec3f_t *v1, const ksl_vec3f_t *v2,
    float *angle_bound) {
  const float s1_size_0 = fabsf(v1->x), s1_size_1 = fabsf(v1->y), s1_size_2 = fabsf(v1->z);
  const float s1_largest1 = s1_size_0 < s1_size_1 ? s1_size_1 : s1_size_0;
  const float s1_largest2 = s1_largest1 < s1_size_2 ? s1_size_2 : s1_largest1;
  const float s1b = 4.611686e+18f < s1_largest2 ? 2.7105054e-20f : 1.0f,
      s1d = s1_largest2 < 256.0f ? 1.8014399e+16f : s1b,
      s1 = s1_largest2 < 1.4210855e-14f ? 3.2451855e+32f : s1d;
  const float scaled_s1_0 = KSL_MULF(v1->x, s1), scaled_s1_1 = KSL_MULF(v1->y, s1),
      scaled_s1_2 = KSL_MULF(v1->z, s1);
  const float s2_size_0 = fabsf(v2->x), s2_size_1 = fabsf(v2->y), s2_size_2 = fabsf(v2->z);
  const float s2_largest1 = s2_size_0 < s2_size_1 ? s2_size_1 : s2_size_0;
  const float s2_largest2 = s2_largest1 < s2_size_2 ? s2_size_2 : s2_largest1;
  const float s2b = 4.611686e+18f < s2_largest2 ? 2.7105054e-20f : 1.0f,
      s2d = s2_largest2 < 256.0f ? 1.8014399e+16f : s2b,
      s2 = s2_largest2 < 1.4210855e-14f ? 3.2451855e+32f : s2d;
  const float scaled_s2_0 = KSL_MULF(v2->x, s2), scaled_s2_1 = KSL_MULF(v2->y, s2),
      scaled_s2_2 = KSL_MULF(v2->z, s2);
  const float c_0a = KSL_MULF(scaled_s1_1, scaled_s2_2),
      c_0a_padded_1 = 3.3087225e-24f + fabsf(scaled_s1_1),
      c_0a_padded_2 = 3.3087225e-24f + fabsf(scaled_s2_2),
      c_0b = KSL_MULF(scaled_s1_2, scaled_s2_1),
      c_0b_padded_1 = 3.3087225e-24f + fabsf(scaled_s1_2),
      c_0b_padded_2 = 3.3087225e-24f + fabsf(scaled_s2_1), c_0 = c_0a - c_0b,
      c_right_1 = c_0a - c_0;
  const float c_1a = KSL_MULF(scaled_s1_2, scaled_s2_0),
      c_1a_padded_1 = 3.3087225e-24f + fabsf(scaled_s2_0),
      c_1b = KSL_MULF(scaled_s1_0, scaled_s2_2),
      c_1b_padded_1 = 3.3087225e-24f + fabsf(scaled_s1_0), c_1 = c_1a - c_1b,
      c_right_2 = c_1a - c_1;
  const float c_2a = KSL_MULF(scaled_s1_0, scaled_s2_1), c_2b = KSL_MULF(scaled_s1_1, scaled_s2_0),
      c_2 = c_2a - c_2b, c_right_3 = c_2a - c_2;
  const float s_size_0 = fabsf(c_0), s_size_1 = fabsf(c_1), s_size_2 = fabsf(c_2);
  const float s_largest1 = s_size_0 < s_size_1 ? s_size_1 : s_size_0;
  const float s_largest2 = s_largest1 < s_size_2 ? s_size_2 : s_largest1;
  const float s_b = 4.611686e+18f < s_largest2 ? 2.7105054e-20f : 1.0f,
      s_b_size_1 = 4.611686e+18f < s_largest2 ? 2.7105054e-20f : 1.0f,
      s_d = s_largest2 < 256.0f ? 1.8014399e+16f : s_b,
      s_d_size_1 = s_largest2 < 256.0f ? 1.8014399e+16f : s_b_size_1,
      s = s_largest2 < 1.4210855e-14f ? 3.2451855e+32f : s_d,
      s_size_3 = s_largest2 < 1.4210855e-14f ? 3.2451855e+32f : s_d_size_1;
  const float y_0 = KSL_MULF(c_0, s), y_inverse_1 = 1.0f / s;
  const float c_lo_1 = ksl_product_restf(scaled_s1_1, scaled_s2_2, c_0a, c_0 + c_right_1)
          - ksl_product_restf(scaled_s1_2, scaled_s2_1, c_0b, c_right_1);
  const float y_lo_1 = KSL_MULF(c_0 - KSL_MULF(y_0, y_inverse_1) + c_lo_1, s);
  const float y_1 = KSL_MULF(c_1, s);
  const float c_lo_2 = ksl_product_restf(scaled_s1_2, scaled_s2_0, c_1a, c_1 + c_right_2)
          - ksl_product_restf(scaled_s1_0, scaled_s2_2, c_1b, c_right_2);
  const float y_lo_2 = KSL_MULF(c_1 - KSL_MULF(y_1, y_inverse_1) + c_lo_2, s);
  const float y_2 = KSL_MULF(c_2, s);
  const float c_lo_3 = ksl_product_restf(scaled_s1_0, scaled_s2_1, c_2a, c_2 + c_right_3)
          - ksl_product_restf(scaled_s1_1, scaled_s2_0, c_2b, c_right_3);
  const float y_lo_3 = KSL_MULF(c_2 - KSL_MULF(y_2, y_inverse_1) + c_lo_3, s);
  const float n_a = KSL_MULF(y_0, y_0),
      n_a_padded_1 = 3.3087225e-24f
          + KSL_MULF(s_size_3, 3.3087225e-24f
          + (KSL_MULF(c_0a_padded_1, c_0a_padded_2) + KSL_MULF(c_0b_padded_1, c_0b_padded_2))),
      n_a_size_2 = KSL_MULF(n_a_padded_1, fabsf(y_0)
          + KSL_MULF(262144.0f, fabsf(y_lo_1) + KSL_MULF(4.8672736e-13f, n_a_padded_1))),
      n_b = KSL_MULF(y_1, y_1),
      n_b_padded_1 = 3.3087225e-24f
          + KSL_MULF(s_size_3, 3.3087225e-24f
          + (KSL_MULF(c_0b_padded_1, c_1a_padded_1) + KSL_MULF(c_0a_padded_2, c_1b_padded_1))),
      n_b_size_2 = KSL_MULF(n_b_padded_1, fabsf(y_1)
          + KSL_MULF(262144.0f, fabsf(y_lo_2) + KSL_MULF(4.8672736e-13f, n_b_padded_1))),
      n_c = n_a + n_b, n_c_right_1 = n_c - n_a,
      n_c_lo1_1 = ksl_product_restf(y_0, y_0, n_a, n_c - n_c_right_1)
          + ksl_product_restf(y_1, y_1, n_b, n_c_right_1), n_d = KSL_MULF(y_2, y_2),
      n_d_padded_1 = 3.3087225e-24f
          + KSL_MULF(s_size_3, 3.3087225e-24f
          + (KSL_MULF(c_0b_padded_2, c_1b_padded_1) + KSL_MULF(c_0a_padded_1, c_1a_padded_1))),
      n_d_size_2 = KSL_MULF(n_d_padded_1, fabsf(y_2)
          + KSL_MULF(262144.0f, fabsf(y_lo_3) + KSL_MULF(4.8672736e-13f, n_d_padded_1))),
      n_e = n_c + n_d, n_e_right_1 = n_e - n_c,
      n_e_lo2_1 = n_c - (n_e - n_e_right_1) + ksl_product_restf(y_2, y_2, n_d, n_e_right_1)
          + (KSL_MULF(y_lo_3, y_2) + KSL_MULF(y_2, y_lo_3)),
      n_e_lo = n_e_lo2_1
          + (n_c_lo1_1
          + (KSL_MULF(y_lo_1, y_0) + KSL_MULF(y_0, y_lo_1)
          + (KSL_MULF(y_lo_2, y_1) + KSL_MULF(y_1, y_lo_2)))), n = sqrtf(n_e),
      n_product_1 = KSL_MULF(n, n), n_twice_1 = n + n,
      n_lo = (n_e - n_product_1 - ksl_product_errorf(n, n, n_product_1) + n_e_lo)
          / (n == 0.0f ? 1.0f : n_twice_1),
      n_padded_1 = 3.3087225e-24f
          + (n_a_size_2 + n_a_size_2 + (n_b_size_2 + n_b_size_2) + (n_d_size_2 + n_d_size_2)),
      n_bound_1 = fabsf(n_e_lo) + KSL_MULF(2.4301075e-12f, n_padded_1),
      n_size_4 = KSL_MULF(fabsf(n_e) + KSL_MULF(262144.0f, n_bound_1), n_padded_1 / n / n_e),
      n_size_8 = KSL_MULF(4.3638574e+11f, sqrtf(n_bound_1) + fabsf(n_lo));
  const float r_b = s < 1.0f ? 3.689349e+19f : 1.0f, r_b_size_1 = s < 1.0f ? 3.689349e+19f : 1.0f,
      r_d = 1.0f < s ? 5.551115e-17f : r_b, r_d_size_1 = 1.0f < s ? 5.551115e-17f : r_b_size_1,
      r = 1.8014399e+16f < s ? 3.081488e-33f : r_d;
  const float cross = KSL_MULF(n, r), cross_lo = KSL_MULF(n - KSL_MULF(cross, 1.0f / r) + n_lo, r),
      cross_padded_1 = 3.3087225e-24f
          + (n + (KSL_MULF(4.0f, n_bound_1) < n_e ? n_size_4 : n_size_8));
  const float dot__a = KSL_MULF(scaled_s1_0, scaled_s2_0),
      dot__b = KSL_MULF(scaled_s1_1, scaled_s2_1), dot__c = dot__a + dot__b,
      dot__c_right_1 = dot__c - dot__a,
      dot__c_left_rest_1 = ksl_product_restf(scaled_s1_0, scaled_s2_0, dot__a, dot__c
          - dot__c_right_1), dot__d = KSL_MULF(scaled_s1_2, scaled_s2_2), dot_ = dot__c + dot__d,
      dot__right_1 = dot_ - dot__c,
      dot__lo1_1 = dot__c - (dot_ - dot__right_1)
          + ksl_product_restf(scaled_s1_2, scaled_s2_2, dot__d, dot__right_1),
      dot__lo = dot__lo1_1
          + (dot__c_left_rest_1
          + ksl_product_restf(scaled_s1_1, scaled_s2_1, dot__b, dot__c_right_1));
  const float angle = ksl_atan2f(cross, dot_), angle_size0_1 = fabsf(cross),
      angle_size1_1 = fabsf(dot_),
      angle_most_1 = angle_size0_1 < angle_size1_1 ? angle_size1_1 : angle_size0_1,
      angle_divisor_1 = angle_most_1 == 0.0f ? 1.0f : angle_most_1,
      angle_part0_1 = cross / angle_divisor_1, angle_part1_1 = dot_ / angle_divisor_1,
      angle_divisor2_1 = KSL_MULF(angle_divisor_1, KSL_MULF(angle_part1_1, angle_part1_1)
          + KSL_MULF(angle_part0_1, angle_part0_1)),
      angle_more_1 = (KSL_MULF(angle_part1_1, cross_lo) - KSL_MULF(angle_part0_1, dot__lo))
          / (angle_most_1 == 0.0f ? 1.0f : angle_divisor2_1),
      angle_padded_1 = 3.3087225e-24f
          + KSL_MULF(cross_padded_1, 1.8014399e+16f < s ? 3.081488e-33f : r_d_size_1);
  const float dot__size_1 = KSL_MULF(c_1a_padded_1, c_1b_padded_1)
          + KSL_MULF(c_0a_padded_1, c_0b_padded_2) + KSL_MULF(c_0a_padded_2, c_0b_padded_1);
  const float angle_padded_2 = 3.3087225e-24f + dot__size_1, angle_size_2 = fabsf(cross),
      angle_size_3 = fabsf(dot_),
      angle_size_5 = angle_size_2 < angle_size_3 ? angle_size_3 : angle_size_2,
      angle_bound_1 = fabsf(cross_lo) + KSL_MULF(2.5225009e-12f, angle_padded_1),
      angle_bound_2 = fabsf(dot__lo) + KSL_MULF(7.141026e-13f, angle_padded_2),
      angle_size_11 = (angle_bound_2 + (3.3087225e-24f + angle_bound_1)) / angle_size_5,
      angle_size_13 = KSL_MULF(angle_size_11, angle_size_11),
      angle_size_14 = fabsf(ksl_atan2_errorf(cross, dot_, angle) + angle_more_1),
      angle_size_15 = 7.0f + angle_size_14,
      angle_size_18 = angle_bound_2 < dot_ ? angle_size_13 : angle_size_15,
      angle_size_19 = angle_bound_1 < angle_size_2 ? angle_size_13 : angle_size_18,
      angle_size_21 = KSL_MULF(1.374365e+11f, angle_size_11 < 0.25f ? angle_size_19
          : angle_size_15);
  const float angle_rest_3 = KSL_MULF(7.503497e-12f, 3.3087225e-24f
          + (fabsf(angle) + (angle_padded_1 + angle_padded_2) / angle_size_5 + angle_size_21)),
      angle_bound_3 = angle_rest_3 + angle_size_14;
  *angle_bound = angle_bound_3;
  return angle;
}

/* v1·v2; |error of dot| <= dot_bound unless inf or NaN.
   v1, v2: vector; dot_bound: number.
   4 mul, 5 add, 3 abs. */
static inline float ksl_dot_vvf_certified(const ksl_vec3f_t *v1, const ksl_vec3f_t *v2,
    float *dot_bound) {
  const float dot_a = KSL_MULF(v1->x, v2->x), dot_b = KSL_MULF(v1->y, v2->y),
      dot_d = KSL_MULF(v1->z, v2->z), dot = dot_a + dot_b + dot_d;
  const float dot_size = fabsf(dot_a) + fabsf(dot_b) + fabsf(dot_d);
  const float dot_bound_ = KSL_MULF(1.7881396e-07f, dot_size + 1.9721523e-31f);
  *dot_bound = dot_bound_;
  return dot;
}

/* vo = k (-v); |error of vo| <= vo_bound unless inf or NaN.
   k: number; v, vo, vo_bound: vector.
   6 mul, 3 add, 3 neg, 3 abs. */
static inline void ksl_product_avinvf_certified(const float k, const ksl_vec3f_t *v,
    ksl_vec3f_t *vo, ksl_vec3f_t *vo_bound) {
  const float vo_0a = KSL_MULF(k, v->x), vo_0 = -vo_0a;
  const float vo_1a = KSL_MULF(k, v->y), vo_1 = -vo_1a;
  const float vo_2a = KSL_MULF(k, v->z), vo_2 = -vo_2a;
  const float vo_0a_bound = KSL_MULF(5.960465e-08f, fabsf(vo_0a) + 1.9721523e-31f);
  const float vo_1a_bound = KSL_MULF(5.960465e-08f, fabsf(vo_1a) + 1.9721523e-31f);
  const float vo_2a_bound = KSL_MULF(5.960465e-08f, fabsf(vo_2a) + 1.9721523e-31f);
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
  vo_bound->x = vo_0a_bound;
  vo_bound->y = vo_1a_bound;
  vo_bound->z = vo_2a_bound;
}

/* vo = v1 × v2; |error of vo| <= vo_bound unless inf or NaN.  Exactly zero for v1 = v2, unless
     products overflow.
   v1, v2, vo, vo_bound: vector.
   9 mul, 9 add, 6 abs. */
static inline void ksl_cross_vvf_certified(const ksl_vec3f_t *v1, const ksl_vec3f_t *v2,
    ksl_vec3f_t *vo, ksl_vec3f_t *vo_bound) {
  const float vo_0a = KSL_MULF(v1->y, v2->z), vo_0b = KSL_MULF(v1->z, v2->y), vo_0 = vo_0a - vo_0b;
  const float vo_1a = KSL_MULF(v1->z, v2->x), vo_1b = KSL_MULF(v1->x, v2->z), vo_1 = vo_1a - vo_1b;
  const float vo_2a = KSL_MULF(v1->x, v2->y), vo_2b = KSL_MULF(v1->y, v2->x), vo_2 = vo_2a - vo_2b;
  const float vo_0_size = fabsf(vo_0a) + fabsf(vo_0b), vo_1_size = fabsf(vo_1a) + fabsf(vo_1b),
      vo_2_size = fabsf(vo_2a) + fabsf(vo_2b);
  const float vo_0_bound = KSL_MULF(1.192093e-07f, vo_0_size + 1.9721523e-31f),
      vo_1_bound = KSL_MULF(1.192093e-07f, vo_1_size + 1.9721523e-31f),
      vo_2_bound = KSL_MULF(1.192093e-07f, vo_2_size + 1.9721523e-31f);
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
  vo_bound->x = vo_0_bound;
  vo_bound->y = vo_1_bound;
  vo_bound->z = vo_2_bound;
}

/* vo = v1 × (-v2); |error of vo| <= vo_bound unless inf or NaN.
   v1, v2, vo, vo_bound: vector.
   9 mul, 9 add, 6 abs. */
static inline void ksl_cross_vvinvf_certified(const ksl_vec3f_t *v1, const ksl_vec3f_t *v2,
    ksl_vec3f_t *vo, ksl_vec3f_t *vo_bound) {
  const float vo_0a = KSL_MULF(v1->z, v2->y), vo_0b = KSL_MULF(v1->y, v2->z), vo_0 = vo_0a - vo_0b;
  const float vo_1a = KSL_MULF(v1->x, v2->z), vo_1b = KSL_MULF(v1->z, v2->x), vo_1 = vo_1a - vo_1b;
  const float vo_2a = KSL_MULF(v1->y, v2->x), vo_2b = KSL_MULF(v1->x, v2->y), vo_2 = vo_2a - vo_2b;
  const float vo_0_size = fabsf(vo_0a) + fabsf(vo_0b), vo_1_size = fabsf(vo_1a) + fabsf(vo_1b),
      vo_2_size = fabsf(vo_2a) + fabsf(vo_2b);
  const float vo_0_bound = KSL_MULF(1.192093e-07f, vo_0_size + 1.9721523e-31f),
      vo_1_bound = KSL_MULF(1.192093e-07f, vo_1_size + 1.9721523e-31f),
      vo_2_bound = KSL_MULF(1.192093e-07f, vo_2_size + 1.9721523e-31f);
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
  vo_bound->x = vo_0_bound;
  vo_bound->y = vo_1_bound;
  vo_bound->z = vo_2_bound;
}

/* vo = v + k e_x; |error of vo| <= vo_bound unless inf or NaN.
   v, vo, vo_bound: vector; k: number.
   1 mul, 1 add, 1 abs. */
static inline void ksl_add_vvxf_certified(const ksl_vec3f_t *v, const float k, ksl_vec3f_t *vo,
    ksl_vec3f_t *vo_bound) {
  const float vo_0 = v->x + k;
  const float vo_0_bound = KSL_MULF(5.960465e-08f, fabsf(vo_0));
  const float v_y = v->y;
  const float v_z = v->z;
  vo->x = vo_0;
  vo->y = v_y;
  vo->z = v_z;
  vo_bound->x = vo_0_bound;
  vo_bound->y = 0.0f;
  vo_bound->z = 0.0f;
}

/* vo = v - k e_x; |error of vo| <= vo_bound unless inf or NaN.
   v, vo, vo_bound: vector; k: number.
   1 mul, 1 add, 1 abs. */
static inline void ksl_add_vvxinvf_certified(const ksl_vec3f_t *v, const float k, ksl_vec3f_t *vo,
    ksl_vec3f_t *vo_bound) {
  const float vo_0 = v->x - k;
  const float vo_0_bound = KSL_MULF(5.960465e-08f, fabsf(vo_0));
  const float v_y = v->y;
  const float v_z = v->z;
  vo->x = vo_0;
  vo->y = v_y;
  vo->z = v_z;
  vo_bound->x = vo_0_bound;
  vo_bound->y = 0.0f;
  vo_bound->z = 0.0f;
}

/* vo = v + k e_y; |error of vo| <= vo_bound unless inf or NaN.
   v, vo, vo_bound: vector; k: number.
   1 mul, 1 add, 1 abs. */
static inline void ksl_add_vvyf_certified(const ksl_vec3f_t *v, const float k, ksl_vec3f_t *vo,
    ksl_vec3f_t *vo_bound) {
  const float vo_1 = v->y + k;
  const float vo_1_bound = KSL_MULF(5.960465e-08f, fabsf(vo_1));
  const float v_x = v->x;
  const float v_z = v->z;
  vo->x = v_x;
  vo->y = vo_1;
  vo->z = v_z;
  vo_bound->x = 0.0f;
  vo_bound->y = vo_1_bound;
  vo_bound->z = 0.0f;
}

/* vo = v - k e_y; |error of vo| <= vo_bound unless inf or NaN.
   v, vo, vo_bound: vector; k: number.
   1 mul, 1 add, 1 abs. */
static inline void ksl_add_vvyinvf_certified(const ksl_vec3f_t *v, const float k, ksl_vec3f_t *vo,
    ksl_vec3f_t *vo_bound) {
  const float vo_1 = v->y - k;
  const float vo_1_bound = KSL_MULF(5.960465e-08f, fabsf(vo_1));
  const float v_x = v->x;
  const float v_z = v->z;
  vo->x = v_x;
  vo->y = vo_1;
  vo->z = v_z;
  vo_bound->x = 0.0f;
  vo_bound->y = vo_1_bound;
  vo_bound->z = 0.0f;
}

/* vo = v + k e_z; |error of vo| <= vo_bound unless inf or NaN.
   v, vo, vo_bound: vector; k: number.
   1 mul, 1 add, 1 abs. */
static inline void ksl_add_vvzf_certified(const ksl_vec3f_t *v, const float k, ksl_vec3f_t *vo,
    ksl_vec3f_t *vo_bound) {
  const float vo_2 = v->z + k;
  const float vo_2_bound = KSL_MULF(5.960465e-08f, fabsf(vo_2));
  const float v_x = v->x;
  const float v_y = v->y;
  vo->x = v_x;
  vo->y = v_y;
  vo->z = vo_2;
  vo_bound->x = 0.0f;
  vo_bound->y = 0.0f;
  vo_bound->z = vo_2_bound;
}

/* vo = v - k e_z; |error of vo| <= vo_bound unless inf or NaN.
   v, vo, vo_bound: vector; k: number.
   1 mul, 1 add, 1 abs. */
static inline void ksl_add_vvzinvf_certified(const ksl_vec3f_t *v, const float k, ksl_vec3f_t *vo,
    ksl_vec3f_t *vo_bound) {
  const float vo_2 = v->z - k;
  const float vo_2_bound = KSL_MULF(5.960465e-08f, fabsf(vo_2));
  const float v_x = v->x;
  const float v_y = v->y;
  vo->x = v_x;
  vo->y = v_y;
  vo->z = vo_2;
  vo_bound->x = 0.0f;
  vo_bound->y = 0.0f;
  vo_bound->z = vo_2_bound;
}

#endif
