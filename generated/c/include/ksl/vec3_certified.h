/* Made by `coscrew generate`; changes are overwritten. */
/* SPDX-License-Identifier: MIT */
/* coscrew 0.2.0.  Copyright (c) 2026 The coscrew authors. */
/* Vectors of three components.
   Certified tier: plain results, and bounds on their errors that always hold. */
#ifndef KSL_VEC3_CERTIFIED_H
#define KSL_VEC3_CERTIFIED_H

#include "ksl_types.h"

/* self = a self; |error of self| <= self_bound unless inf or NaN.
   self, self_bound: vector; a: number.
   6 mul, 3 add, 3 abs. */
static inline void ksl_vec3_scale_certified(ksl_vec3_t *self, const double a,
    ksl_vec3_t *self_bound) {
  const double self_0_new = KSL_MUL(self->x, a);
  const double self_1_new = KSL_MUL(self->y, a);
  const double self_2_new = KSL_MUL(self->z, a);
  const double self_0_new_abs = fabs(self_0_new),
      self_0_new_padded = self_0_new_abs + 2.004168360008973e-292,
      self_0_new_error_bound = KSL_MUL(1.1102230246251568e-16, self_0_new_padded);
  const double self_1_new_abs = fabs(self_1_new),
      self_1_new_padded = self_1_new_abs + 2.004168360008973e-292,
      self_1_new_error_bound = KSL_MUL(1.1102230246251568e-16, self_1_new_padded);
  const double self_2_new_abs = fabs(self_2_new),
      self_2_new_padded = self_2_new_abs + 2.004168360008973e-292,
      self_2_new_error_bound = KSL_MUL(1.1102230246251568e-16, self_2_new_padded);
  self->x = self_0_new;
  self->y = self_1_new;
  self->z = self_2_new;
  self_bound->x = self_0_new_error_bound;
  self_bound->y = self_1_new_error_bound;
  self_bound->z = self_2_new_error_bound;
}

/* y = a x + y; |error of y| <= y_bound unless inf or NaN.
   a: number; x, y, y_bound: vector.
   6 mul, 9 add, 6 abs. */
static inline void ksl_axpy_vv_certified(const double a, const ksl_vec3_t *x, ksl_vec3_t *y,
    ksl_vec3_t *y_bound) {
  const double y_0_new_a = KSL_MUL(a, x->x), y_0_new = y_0_new_a + y->x;
  const double y_1_new_a = KSL_MUL(a, x->y), y_1_new = y_1_new_a + y->y;
  const double y_2_new_a = KSL_MUL(a, x->z), y_2_new = y_2_new_a + y->z;
  const double y_0_new_a_abs = fabs(y_0_new_a), y_0_abs = fabs(y->x),
      y_0_new_size = y_0_new_a_abs + y_0_abs;
  const double y_1_new_a_abs = fabs(y_1_new_a), y_1_abs = fabs(y->y),
      y_1_new_size = y_1_new_a_abs + y_1_abs;
  const double y_2_new_a_abs = fabs(y_2_new_a), y_2_abs = fabs(y->z),
      y_2_new_size = y_2_new_a_abs + y_2_abs;
  const double y_0_new_padded = y_0_new_size + 2.004168360008973e-292,
      y_0_new_error_bound = KSL_MUL(2.2204460492503136e-16, y_0_new_padded);
  const double y_1_new_padded = y_1_new_size + 2.004168360008973e-292,
      y_1_new_error_bound = KSL_MUL(2.2204460492503136e-16, y_1_new_padded);
  const double y_2_new_padded = y_2_new_size + 2.004168360008973e-292,
      y_2_new_error_bound = KSL_MUL(2.2204460492503136e-16, y_2_new_padded);
  y->x = y_0_new;
  y->y = y_1_new;
  y->z = y_2_new;
  y_bound->x = y_0_new_error_bound;
  y_bound->y = y_1_new_error_bound;
  y_bound->z = y_2_new_error_bound;
}

/* y = x + y; |error of y| <= y_bound unless inf or NaN.
   x, y, y_bound: vector.
   3 mul, 3 add, 3 abs. */
static inline void ksl_xpy_vv_certified(const ksl_vec3_t *x, ksl_vec3_t *y, ksl_vec3_t *y_bound) {
  const double y_0_new = x->x + y->x;
  const double y_1_new = x->y + y->y;
  const double y_2_new = x->z + y->z;
  const double y_0_new_abs = fabs(y_0_new),
      y_0_new_error_bound = KSL_MUL(1.1102230246251568e-16, y_0_new_abs);
  const double y_1_new_abs = fabs(y_1_new),
      y_1_new_error_bound = KSL_MUL(1.1102230246251568e-16, y_1_new_abs);
  const double y_2_new_abs = fabs(y_2_new),
      y_2_new_error_bound = KSL_MUL(1.1102230246251568e-16, y_2_new_abs);
  y->x = y_0_new;
  y->y = y_1_new;
  y->z = y_2_new;
  y_bound->x = y_0_new_error_bound;
  y_bound->y = y_1_new_error_bound;
  y_bound->z = y_2_new_error_bound;
}

/* y = -x + y; |error of y| <= y_bound unless inf or NaN.
   x, y, y_bound: vector.
   3 mul, 3 add, 3 abs. */
static inline void ksl_nxpy_vv_certified(const ksl_vec3_t *x, ksl_vec3_t *y, ksl_vec3_t *y_bound) {
  const double y_0_new = y->x - x->x;
  const double y_1_new = y->y - x->y;
  const double y_2_new = y->z - x->z;
  const double y_0_new_abs = fabs(y_0_new),
      y_0_new_error_bound = KSL_MUL(1.1102230246251568e-16, y_0_new_abs);
  const double y_1_new_abs = fabs(y_1_new),
      y_1_new_error_bound = KSL_MUL(1.1102230246251568e-16, y_1_new_abs);
  const double y_2_new_abs = fabs(y_2_new),
      y_2_new_error_bound = KSL_MUL(1.1102230246251568e-16, y_2_new_abs);
  y->x = y_0_new;
  y->y = y_1_new;
  y->z = y_2_new;
  y_bound->x = y_0_new_error_bound;
  y_bound->y = y_1_new_error_bound;
  y_bound->z = y_2_new_error_bound;
}

/* vo = a vi; |error of vo| <= vo_bound unless inf or NaN.
   a: number; vi, vo, vo_bound: vector.
   6 mul, 3 add, 3 abs. */
static inline void ksl_product_av_certified(const double a, const ksl_vec3_t *vi, ksl_vec3_t *vo,
    ksl_vec3_t *vo_bound) {
  const double vo_0 = KSL_MUL(a, vi->x);
  const double vo_1 = KSL_MUL(a, vi->y);
  const double vo_2 = KSL_MUL(a, vi->z);
  const double vo_0_abs = fabs(vo_0), vo_0_padded = vo_0_abs + 2.004168360008973e-292,
      vo_0_error_bound = KSL_MUL(1.1102230246251568e-16, vo_0_padded);
  const double vo_1_abs = fabs(vo_1), vo_1_padded = vo_1_abs + 2.004168360008973e-292,
      vo_1_error_bound = KSL_MUL(1.1102230246251568e-16, vo_1_padded);
  const double vo_2_abs = fabs(vo_2), vo_2_padded = vo_2_abs + 2.004168360008973e-292,
      vo_2_error_bound = KSL_MUL(1.1102230246251568e-16, vo_2_padded);
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
  vo_bound->x = vo_0_error_bound;
  vo_bound->y = vo_1_error_bound;
  vo_bound->z = vo_2_error_bound;
}

/* vo = v1 + v2; |error of vo| <= vo_bound unless inf or NaN.
   v1, v2, vo, vo_bound: vector.
   3 mul, 3 add, 3 abs. */
static inline void ksl_add_vv_certified(const ksl_vec3_t *v1, const ksl_vec3_t *v2,
    ksl_vec3_t *vo, ksl_vec3_t *vo_bound) {
  const double vo_0 = v1->x + v2->x;
  const double vo_1 = v1->y + v2->y;
  const double vo_2 = v1->z + v2->z;
  const double vo_0_abs = fabs(vo_0), vo_0_error_bound = KSL_MUL(1.1102230246251568e-16, vo_0_abs);
  const double vo_1_abs = fabs(vo_1), vo_1_error_bound = KSL_MUL(1.1102230246251568e-16, vo_1_abs);
  const double vo_2_abs = fabs(vo_2), vo_2_error_bound = KSL_MUL(1.1102230246251568e-16, vo_2_abs);
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
  vo_bound->x = vo_0_error_bound;
  vo_bound->y = vo_1_error_bound;
  vo_bound->z = vo_2_error_bound;
}

/* vo = v1 - v2; |error of vo| <= vo_bound unless inf or NaN.
   v1, v2, vo, vo_bound: vector.
   3 mul, 3 add, 3 abs. */
static inline void ksl_subtract_vv_certified(const ksl_vec3_t *v1, const ksl_vec3_t *v2,
    ksl_vec3_t *vo, ksl_vec3_t *vo_bound) {
  const double vo_0 = v1->x - v2->x;
  const double vo_1 = v1->y - v2->y;
  const double vo_2 = v1->z - v2->z;
  const double vo_0_abs = fabs(vo_0), vo_0_error_bound = KSL_MUL(1.1102230246251568e-16, vo_0_abs);
  const double vo_1_abs = fabs(vo_1), vo_1_error_bound = KSL_MUL(1.1102230246251568e-16, vo_1_abs);
  const double vo_2_abs = fabs(vo_2), vo_2_error_bound = KSL_MUL(1.1102230246251568e-16, vo_2_abs);
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
  vo_bound->x = vo_0_error_bound;
  vo_bound->y = vo_1_error_bound;
  vo_bound->z = vo_2_error_bound;
}

/* vo = k v; |error of vo| <= vo_bound unless inf or NaN.
   v, vo, vo_bound: vector; k: number.
   6 mul, 3 add, 3 abs. */
static inline void ksl_vec3_scaled_certified(const ksl_vec3_t *v, const double k, ksl_vec3_t *vo,
    ksl_vec3_t *vo_bound) {
  const double vo_0 = KSL_MUL(v->x, k);
  const double vo_1 = KSL_MUL(v->y, k);
  const double vo_2 = KSL_MUL(v->z, k);
  const double vo_0_abs = fabs(vo_0), vo_0_padded = vo_0_abs + 2.004168360008973e-292,
      vo_0_error_bound = KSL_MUL(1.1102230246251568e-16, vo_0_padded);
  const double vo_1_abs = fabs(vo_1), vo_1_padded = vo_1_abs + 2.004168360008973e-292,
      vo_1_error_bound = KSL_MUL(1.1102230246251568e-16, vo_1_padded);
  const double vo_2_abs = fabs(vo_2), vo_2_padded = vo_2_abs + 2.004168360008973e-292,
      vo_2_error_bound = KSL_MUL(1.1102230246251568e-16, vo_2_padded);
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
  vo_bound->x = vo_0_error_bound;
  vo_bound->y = vo_1_error_bound;
  vo_bound->z = vo_2_error_bound;
}

/* v1·v2; |error of dot| <= dot_bound unless inf or NaN.
   v1, v2: vector; dot_bound: number.
   4 mul, 5 add, 3 abs. */
static inline double ksl_dot_vv_certified(const ksl_vec3_t *v1, const ksl_vec3_t *v2,
    double *dot_bound) {
  const double dot_a = KSL_MUL(v1->x, v2->x), dot_b = KSL_MUL(v1->y, v2->y), dot_c = dot_a + dot_b,
      dot_d = KSL_MUL(v1->z, v2->z), dot = dot_c + dot_d;
  const double dot_a_abs = fabs(dot_a), dot_b_abs = fabs(dot_b), dot_c_size = dot_a_abs + dot_b_abs,
      dot_d_abs = fabs(dot_d), dot_size = dot_c_size + dot_d_abs;
  const double dot_padded = dot_size + 2.004168360008973e-292,
      dot_error_bound = KSL_MUL(3.3306690738754706e-16, dot_padded);
  *dot_bound = dot_error_bound;
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
  const double vo_0a_abs = fabs(vo_0a), vo_0a_padded = vo_0a_abs + 2.004168360008973e-292,
      vo_0a_error_bound = KSL_MUL(1.1102230246251568e-16, vo_0a_padded);
  const double vo_1a_abs = fabs(vo_1a), vo_1a_padded = vo_1a_abs + 2.004168360008973e-292,
      vo_1a_error_bound = KSL_MUL(1.1102230246251568e-16, vo_1a_padded);
  const double vo_2a_abs = fabs(vo_2a), vo_2a_padded = vo_2a_abs + 2.004168360008973e-292,
      vo_2a_error_bound = KSL_MUL(1.1102230246251568e-16, vo_2a_padded);
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
  vo_bound->x = vo_0a_error_bound;
  vo_bound->y = vo_1a_error_bound;
  vo_bound->z = vo_2a_error_bound;
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
  const double vo_0a_abs = fabs(vo_0a), vo_0b_abs = fabs(vo_0b), vo_0_size = vo_0a_abs + vo_0b_abs;
  const double vo_1a_abs = fabs(vo_1a), vo_1b_abs = fabs(vo_1b), vo_1_size = vo_1a_abs + vo_1b_abs;
  const double vo_2a_abs = fabs(vo_2a), vo_2b_abs = fabs(vo_2b), vo_2_size = vo_2a_abs + vo_2b_abs;
  const double vo_0_padded = vo_0_size + 2.004168360008973e-292,
      vo_0_error_bound = KSL_MUL(2.2204460492503136e-16, vo_0_padded);
  const double vo_1_padded = vo_1_size + 2.004168360008973e-292,
      vo_1_error_bound = KSL_MUL(2.2204460492503136e-16, vo_1_padded);
  const double vo_2_padded = vo_2_size + 2.004168360008973e-292,
      vo_2_error_bound = KSL_MUL(2.2204460492503136e-16, vo_2_padded);
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
  vo_bound->x = vo_0_error_bound;
  vo_bound->y = vo_1_error_bound;
  vo_bound->z = vo_2_error_bound;
}

/* vo = v1 × (-v2); |error of vo| <= vo_bound unless inf or NaN.
   v1, v2, vo, vo_bound: vector.
   9 mul, 9 add, 6 abs. */
static inline void ksl_cross_vvinv_certified(const ksl_vec3_t *v1, const ksl_vec3_t *v2,
    ksl_vec3_t *vo, ksl_vec3_t *vo_bound) {
  const double vo_0a = KSL_MUL(v1->z, v2->y), vo_0b = KSL_MUL(v1->y, v2->z), vo_0 = vo_0a - vo_0b;
  const double vo_1a = KSL_MUL(v1->x, v2->z), vo_1b = KSL_MUL(v1->z, v2->x), vo_1 = vo_1a - vo_1b;
  const double vo_2a = KSL_MUL(v1->y, v2->x), vo_2b = KSL_MUL(v1->x, v2->y), vo_2 = vo_2a - vo_2b;
  const double vo_0a_abs = fabs(vo_0a), vo_0b_abs = fabs(vo_0b), vo_0_size = vo_0a_abs + vo_0b_abs;
  const double vo_1a_abs = fabs(vo_1a), vo_1b_abs = fabs(vo_1b), vo_1_size = vo_1a_abs + vo_1b_abs;
  const double vo_2a_abs = fabs(vo_2a), vo_2b_abs = fabs(vo_2b), vo_2_size = vo_2a_abs + vo_2b_abs;
  const double vo_0_padded = vo_0_size + 2.004168360008973e-292,
      vo_0_error_bound = KSL_MUL(2.2204460492503136e-16, vo_0_padded);
  const double vo_1_padded = vo_1_size + 2.004168360008973e-292,
      vo_1_error_bound = KSL_MUL(2.2204460492503136e-16, vo_1_padded);
  const double vo_2_padded = vo_2_size + 2.004168360008973e-292,
      vo_2_error_bound = KSL_MUL(2.2204460492503136e-16, vo_2_padded);
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
  vo_bound->x = vo_0_error_bound;
  vo_bound->y = vo_1_error_bound;
  vo_bound->z = vo_2_error_bound;
}

/* vo = v + k e_x; |error of vo| <= vo_bound unless inf or NaN.
   v, vo, vo_bound: vector; k: number.
   1 mul, 1 add, 1 abs. */
static inline void ksl_add_vvx_certified(const ksl_vec3_t *v, const double k, ksl_vec3_t *vo,
    ksl_vec3_t *vo_bound) {
  const double vo_0 = v->x + k;
  const double vo_0_abs = fabs(vo_0), vo_0_error_bound = KSL_MUL(1.1102230246251568e-16, vo_0_abs);
  const double v_y = v->y;
  const double v_z = v->z;
  vo->x = vo_0;
  vo->y = v_y;
  vo->z = v_z;
  vo_bound->x = vo_0_error_bound;
  vo_bound->y = 0.0;
  vo_bound->z = 0.0;
}

/* vo = v - k e_x; |error of vo| <= vo_bound unless inf or NaN.
   v, vo, vo_bound: vector; k: number.
   1 mul, 1 add, 1 abs. */
static inline void ksl_add_vvxinv_certified(const ksl_vec3_t *v, const double k, ksl_vec3_t *vo,
    ksl_vec3_t *vo_bound) {
  const double vo_0 = v->x - k;
  const double vo_0_abs = fabs(vo_0), vo_0_error_bound = KSL_MUL(1.1102230246251568e-16, vo_0_abs);
  const double v_y = v->y;
  const double v_z = v->z;
  vo->x = vo_0;
  vo->y = v_y;
  vo->z = v_z;
  vo_bound->x = vo_0_error_bound;
  vo_bound->y = 0.0;
  vo_bound->z = 0.0;
}

/* vo = v + k e_y; |error of vo| <= vo_bound unless inf or NaN.
   v, vo, vo_bound: vector; k: number.
   1 mul, 1 add, 1 abs. */
static inline void ksl_add_vvy_certified(const ksl_vec3_t *v, const double k, ksl_vec3_t *vo,
    ksl_vec3_t *vo_bound) {
  const double vo_1 = v->y + k;
  const double vo_1_abs = fabs(vo_1), vo_1_error_bound = KSL_MUL(1.1102230246251568e-16, vo_1_abs);
  const double v_x = v->x;
  const double v_z = v->z;
  vo->x = v_x;
  vo->y = vo_1;
  vo->z = v_z;
  vo_bound->x = 0.0;
  vo_bound->y = vo_1_error_bound;
  vo_bound->z = 0.0;
}

/* vo = v - k e_y; |error of vo| <= vo_bound unless inf or NaN.
   v, vo, vo_bound: vector; k: number.
   1 mul, 1 add, 1 abs. */
static inline void ksl_add_vvyinv_certified(const ksl_vec3_t *v, const double k, ksl_vec3_t *vo,
    ksl_vec3_t *vo_bound) {
  const double vo_1 = v->y - k;
  const double vo_1_abs = fabs(vo_1), vo_1_error_bound = KSL_MUL(1.1102230246251568e-16, vo_1_abs);
  const double v_x = v->x;
  const double v_z = v->z;
  vo->x = v_x;
  vo->y = vo_1;
  vo->z = v_z;
  vo_bound->x = 0.0;
  vo_bound->y = vo_1_error_bound;
  vo_bound->z = 0.0;
}

/* vo = v + k e_z; |error of vo| <= vo_bound unless inf or NaN.
   v, vo, vo_bound: vector; k: number.
   1 mul, 1 add, 1 abs. */
static inline void ksl_add_vvz_certified(const ksl_vec3_t *v, const double k, ksl_vec3_t *vo,
    ksl_vec3_t *vo_bound) {
  const double vo_2 = v->z + k;
  const double vo_2_abs = fabs(vo_2), vo_2_error_bound = KSL_MUL(1.1102230246251568e-16, vo_2_abs);
  const double v_x = v->x;
  const double v_y = v->y;
  vo->x = v_x;
  vo->y = v_y;
  vo->z = vo_2;
  vo_bound->x = 0.0;
  vo_bound->y = 0.0;
  vo_bound->z = vo_2_error_bound;
}

/* vo = v - k e_z; |error of vo| <= vo_bound unless inf or NaN.
   v, vo, vo_bound: vector; k: number.
   1 mul, 1 add, 1 abs. */
static inline void ksl_add_vvzinv_certified(const ksl_vec3_t *v, const double k, ksl_vec3_t *vo,
    ksl_vec3_t *vo_bound) {
  const double vo_2 = v->z - k;
  const double vo_2_abs = fabs(vo_2), vo_2_error_bound = KSL_MUL(1.1102230246251568e-16, vo_2_abs);
  const double v_x = v->x;
  const double v_y = v->y;
  vo->x = v_x;
  vo->y = v_y;
  vo->z = vo_2;
  vo_bound->x = 0.0;
  vo_bound->y = 0.0;
  vo_bound->z = vo_2_error_bound;
}

/* self = a self; |error of self| <= self_bound unless inf or NaN.
   self, self_bound: vector; a: number.
   6 mul, 3 add, 3 abs. */
static inline void ksl_vec3f_scale_certified(ksl_vec3f_t *self, const float a,
    ksl_vec3f_t *self_bound) {
  const float self_0_new = KSL_MULF(self->x, a);
  const float self_1_new = KSL_MULF(self->y, a);
  const float self_2_new = KSL_MULF(self->z, a);
  const float self_0_new_abs = fabsf(self_0_new),
      self_0_new_padded = self_0_new_abs + 1.9721523e-31f,
      self_0_new_error_bound = KSL_MULF(5.960465e-08f, self_0_new_padded);
  const float self_1_new_abs = fabsf(self_1_new),
      self_1_new_padded = self_1_new_abs + 1.9721523e-31f,
      self_1_new_error_bound = KSL_MULF(5.960465e-08f, self_1_new_padded);
  const float self_2_new_abs = fabsf(self_2_new),
      self_2_new_padded = self_2_new_abs + 1.9721523e-31f,
      self_2_new_error_bound = KSL_MULF(5.960465e-08f, self_2_new_padded);
  self->x = self_0_new;
  self->y = self_1_new;
  self->z = self_2_new;
  self_bound->x = self_0_new_error_bound;
  self_bound->y = self_1_new_error_bound;
  self_bound->z = self_2_new_error_bound;
}

/* y = a x + y; |error of y| <= y_bound unless inf or NaN.
   a: number; x, y, y_bound: vector.
   6 mul, 9 add, 6 abs. */
static inline void ksl_axpy_vvf_certified(const float a, const ksl_vec3f_t *x, ksl_vec3f_t *y,
    ksl_vec3f_t *y_bound) {
  const float y_0_new_a = KSL_MULF(a, x->x), y_0_new = y_0_new_a + y->x;
  const float y_1_new_a = KSL_MULF(a, x->y), y_1_new = y_1_new_a + y->y;
  const float y_2_new_a = KSL_MULF(a, x->z), y_2_new = y_2_new_a + y->z;
  const float y_0_new_a_abs = fabsf(y_0_new_a), y_0_abs = fabsf(y->x),
      y_0_new_size = y_0_new_a_abs + y_0_abs;
  const float y_1_new_a_abs = fabsf(y_1_new_a), y_1_abs = fabsf(y->y),
      y_1_new_size = y_1_new_a_abs + y_1_abs;
  const float y_2_new_a_abs = fabsf(y_2_new_a), y_2_abs = fabsf(y->z),
      y_2_new_size = y_2_new_a_abs + y_2_abs;
  const float y_0_new_padded = y_0_new_size + 1.9721523e-31f,
      y_0_new_error_bound = KSL_MULF(1.192093e-07f, y_0_new_padded);
  const float y_1_new_padded = y_1_new_size + 1.9721523e-31f,
      y_1_new_error_bound = KSL_MULF(1.192093e-07f, y_1_new_padded);
  const float y_2_new_padded = y_2_new_size + 1.9721523e-31f,
      y_2_new_error_bound = KSL_MULF(1.192093e-07f, y_2_new_padded);
  y->x = y_0_new;
  y->y = y_1_new;
  y->z = y_2_new;
  y_bound->x = y_0_new_error_bound;
  y_bound->y = y_1_new_error_bound;
  y_bound->z = y_2_new_error_bound;
}

/* y = x + y; |error of y| <= y_bound unless inf or NaN.
   x, y, y_bound: vector.
   3 mul, 3 add, 3 abs. */
static inline void ksl_xpy_vvf_certified(const ksl_vec3f_t *x, ksl_vec3f_t *y,
    ksl_vec3f_t *y_bound) {
  const float y_0_new = x->x + y->x;
  const float y_1_new = x->y + y->y;
  const float y_2_new = x->z + y->z;
  const float y_0_new_abs = fabsf(y_0_new),
      y_0_new_error_bound = KSL_MULF(5.960465e-08f, y_0_new_abs);
  const float y_1_new_abs = fabsf(y_1_new),
      y_1_new_error_bound = KSL_MULF(5.960465e-08f, y_1_new_abs);
  const float y_2_new_abs = fabsf(y_2_new),
      y_2_new_error_bound = KSL_MULF(5.960465e-08f, y_2_new_abs);
  y->x = y_0_new;
  y->y = y_1_new;
  y->z = y_2_new;
  y_bound->x = y_0_new_error_bound;
  y_bound->y = y_1_new_error_bound;
  y_bound->z = y_2_new_error_bound;
}

/* y = -x + y; |error of y| <= y_bound unless inf or NaN.
   x, y, y_bound: vector.
   3 mul, 3 add, 3 abs. */
static inline void ksl_nxpy_vvf_certified(const ksl_vec3f_t *x, ksl_vec3f_t *y,
    ksl_vec3f_t *y_bound) {
  const float y_0_new = y->x - x->x;
  const float y_1_new = y->y - x->y;
  const float y_2_new = y->z - x->z;
  const float y_0_new_abs = fabsf(y_0_new),
      y_0_new_error_bound = KSL_MULF(5.960465e-08f, y_0_new_abs);
  const float y_1_new_abs = fabsf(y_1_new),
      y_1_new_error_bound = KSL_MULF(5.960465e-08f, y_1_new_abs);
  const float y_2_new_abs = fabsf(y_2_new),
      y_2_new_error_bound = KSL_MULF(5.960465e-08f, y_2_new_abs);
  y->x = y_0_new;
  y->y = y_1_new;
  y->z = y_2_new;
  y_bound->x = y_0_new_error_bound;
  y_bound->y = y_1_new_error_bound;
  y_bound->z = y_2_new_error_bound;
}

/* vo = a vi; |error of vo| <= vo_bound unless inf or NaN.
   a: number; vi, vo, vo_bound: vector.
   6 mul, 3 add, 3 abs. */
static inline void ksl_product_avf_certified(const float a, const ksl_vec3f_t *vi,
    ksl_vec3f_t *vo, ksl_vec3f_t *vo_bound) {
  const float vo_0 = KSL_MULF(a, vi->x);
  const float vo_1 = KSL_MULF(a, vi->y);
  const float vo_2 = KSL_MULF(a, vi->z);
  const float vo_0_abs = fabsf(vo_0), vo_0_padded = vo_0_abs + 1.9721523e-31f,
      vo_0_error_bound = KSL_MULF(5.960465e-08f, vo_0_padded);
  const float vo_1_abs = fabsf(vo_1), vo_1_padded = vo_1_abs + 1.9721523e-31f,
      vo_1_error_bound = KSL_MULF(5.960465e-08f, vo_1_padded);
  const float vo_2_abs = fabsf(vo_2), vo_2_padded = vo_2_abs + 1.9721523e-31f,
      vo_2_error_bound = KSL_MULF(5.960465e-08f, vo_2_padded);
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
  vo_bound->x = vo_0_error_bound;
  vo_bound->y = vo_1_error_bound;
  vo_bound->z = vo_2_error_bound;
}

/* vo = v1 + v2; |error of vo| <= vo_bound unless inf or NaN.
   v1, v2, vo, vo_bound: vector.
   3 mul, 3 add, 3 abs. */
static inline void ksl_add_vvf_certified(const ksl_vec3f_t *v1, const ksl_vec3f_t *v2,
    ksl_vec3f_t *vo, ksl_vec3f_t *vo_bound) {
  const float vo_0 = v1->x + v2->x;
  const float vo_1 = v1->y + v2->y;
  const float vo_2 = v1->z + v2->z;
  const float vo_0_abs = fabsf(vo_0), vo_0_error_bound = KSL_MULF(5.960465e-08f, vo_0_abs);
  const float vo_1_abs = fabsf(vo_1), vo_1_error_bound = KSL_MULF(5.960465e-08f, vo_1_abs);
  const float vo_2_abs = fabsf(vo_2), vo_2_error_bound = KSL_MULF(5.960465e-08f, vo_2_abs);
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
  vo_bound->x = vo_0_error_bound;
  vo_bound->y = vo_1_error_bound;
  vo_bound->z = vo_2_error_bound;
}

/* vo = v1 - v2; |error of vo| <= vo_bound unless inf or NaN.
   v1, v2, vo, vo_bound: vector.
   3 mul, 3 add, 3 abs. */
static inline void ksl_subtract_vvf_certified(const ksl_vec3f_t *v1, const ksl_vec3f_t *v2,
    ksl_vec3f_t *vo, ksl_vec3f_t *vo_bound) {
  const float vo_0 = v1->x - v2->x;
  const float vo_1 = v1->y - v2->y;
  const float vo_2 = v1->z - v2->z;
  const float vo_0_abs = fabsf(vo_0), vo_0_error_bound = KSL_MULF(5.960465e-08f, vo_0_abs);
  const float vo_1_abs = fabsf(vo_1), vo_1_error_bound = KSL_MULF(5.960465e-08f, vo_1_abs);
  const float vo_2_abs = fabsf(vo_2), vo_2_error_bound = KSL_MULF(5.960465e-08f, vo_2_abs);
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
  vo_bound->x = vo_0_error_bound;
  vo_bound->y = vo_1_error_bound;
  vo_bound->z = vo_2_error_bound;
}

/* vo = k v; |error of vo| <= vo_bound unless inf or NaN.
   v, vo, vo_bound: vector; k: number.
   6 mul, 3 add, 3 abs. */
static inline void ksl_vec3f_scaled_certified(const ksl_vec3f_t *v, const float k,
    ksl_vec3f_t *vo, ksl_vec3f_t *vo_bound) {
  const float vo_0 = KSL_MULF(v->x, k);
  const float vo_1 = KSL_MULF(v->y, k);
  const float vo_2 = KSL_MULF(v->z, k);
  const float vo_0_abs = fabsf(vo_0), vo_0_padded = vo_0_abs + 1.9721523e-31f,
      vo_0_error_bound = KSL_MULF(5.960465e-08f, vo_0_padded);
  const float vo_1_abs = fabsf(vo_1), vo_1_padded = vo_1_abs + 1.9721523e-31f,
      vo_1_error_bound = KSL_MULF(5.960465e-08f, vo_1_padded);
  const float vo_2_abs = fabsf(vo_2), vo_2_padded = vo_2_abs + 1.9721523e-31f,
      vo_2_error_bound = KSL_MULF(5.960465e-08f, vo_2_padded);
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
  vo_bound->x = vo_0_error_bound;
  vo_bound->y = vo_1_error_bound;
  vo_bound->z = vo_2_error_bound;
}

/* v1·v2; |error of dot| <= dot_bound unless inf or NaN.
   v1, v2: vector; dot_bound: number.
   4 mul, 5 add, 3 abs. */
static inline float ksl_dot_vvf_certified(const ksl_vec3f_t *v1, const ksl_vec3f_t *v2,
    float *dot_bound) {
  const float dot_a = KSL_MULF(v1->x, v2->x), dot_b = KSL_MULF(v1->y, v2->y), dot_c = dot_a + dot_b,
      dot_d = KSL_MULF(v1->z, v2->z), dot = dot_c + dot_d;
  const float dot_a_abs = fabsf(dot_a), dot_b_abs = fabsf(dot_b),
      dot_c_size = dot_a_abs + dot_b_abs, dot_d_abs = fabsf(dot_d),
      dot_size = dot_c_size + dot_d_abs;
  const float dot_padded = dot_size + 1.9721523e-31f,
      dot_error_bound = KSL_MULF(1.7881396e-07f, dot_padded);
  *dot_bound = dot_error_bound;
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
  const float vo_0a_abs = fabsf(vo_0a), vo_0a_padded = vo_0a_abs + 1.9721523e-31f,
      vo_0a_error_bound = KSL_MULF(5.960465e-08f, vo_0a_padded);
  const float vo_1a_abs = fabsf(vo_1a), vo_1a_padded = vo_1a_abs + 1.9721523e-31f,
      vo_1a_error_bound = KSL_MULF(5.960465e-08f, vo_1a_padded);
  const float vo_2a_abs = fabsf(vo_2a), vo_2a_padded = vo_2a_abs + 1.9721523e-31f,
      vo_2a_error_bound = KSL_MULF(5.960465e-08f, vo_2a_padded);
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
  vo_bound->x = vo_0a_error_bound;
  vo_bound->y = vo_1a_error_bound;
  vo_bound->z = vo_2a_error_bound;
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
  const float vo_0a_abs = fabsf(vo_0a), vo_0b_abs = fabsf(vo_0b), vo_0_size = vo_0a_abs + vo_0b_abs;
  const float vo_1a_abs = fabsf(vo_1a), vo_1b_abs = fabsf(vo_1b), vo_1_size = vo_1a_abs + vo_1b_abs;
  const float vo_2a_abs = fabsf(vo_2a), vo_2b_abs = fabsf(vo_2b), vo_2_size = vo_2a_abs + vo_2b_abs;
  const float vo_0_padded = vo_0_size + 1.9721523e-31f,
      vo_0_error_bound = KSL_MULF(1.192093e-07f, vo_0_padded);
  const float vo_1_padded = vo_1_size + 1.9721523e-31f,
      vo_1_error_bound = KSL_MULF(1.192093e-07f, vo_1_padded);
  const float vo_2_padded = vo_2_size + 1.9721523e-31f,
      vo_2_error_bound = KSL_MULF(1.192093e-07f, vo_2_padded);
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
  vo_bound->x = vo_0_error_bound;
  vo_bound->y = vo_1_error_bound;
  vo_bound->z = vo_2_error_bound;
}

/* vo = v1 × (-v2); |error of vo| <= vo_bound unless inf or NaN.
   v1, v2, vo, vo_bound: vector.
   9 mul, 9 add, 6 abs. */
static inline void ksl_cross_vvinvf_certified(const ksl_vec3f_t *v1, const ksl_vec3f_t *v2,
    ksl_vec3f_t *vo, ksl_vec3f_t *vo_bound) {
  const float vo_0a = KSL_MULF(v1->z, v2->y), vo_0b = KSL_MULF(v1->y, v2->z), vo_0 = vo_0a - vo_0b;
  const float vo_1a = KSL_MULF(v1->x, v2->z), vo_1b = KSL_MULF(v1->z, v2->x), vo_1 = vo_1a - vo_1b;
  const float vo_2a = KSL_MULF(v1->y, v2->x), vo_2b = KSL_MULF(v1->x, v2->y), vo_2 = vo_2a - vo_2b;
  const float vo_0a_abs = fabsf(vo_0a), vo_0b_abs = fabsf(vo_0b), vo_0_size = vo_0a_abs + vo_0b_abs;
  const float vo_1a_abs = fabsf(vo_1a), vo_1b_abs = fabsf(vo_1b), vo_1_size = vo_1a_abs + vo_1b_abs;
  const float vo_2a_abs = fabsf(vo_2a), vo_2b_abs = fabsf(vo_2b), vo_2_size = vo_2a_abs + vo_2b_abs;
  const float vo_0_padded = vo_0_size + 1.9721523e-31f,
      vo_0_error_bound = KSL_MULF(1.192093e-07f, vo_0_padded);
  const float vo_1_padded = vo_1_size + 1.9721523e-31f,
      vo_1_error_bound = KSL_MULF(1.192093e-07f, vo_1_padded);
  const float vo_2_padded = vo_2_size + 1.9721523e-31f,
      vo_2_error_bound = KSL_MULF(1.192093e-07f, vo_2_padded);
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
  vo_bound->x = vo_0_error_bound;
  vo_bound->y = vo_1_error_bound;
  vo_bound->z = vo_2_error_bound;
}

/* vo = v + k e_x; |error of vo| <= vo_bound unless inf or NaN.
   v, vo, vo_bound: vector; k: number.
   1 mul, 1 add, 1 abs. */
static inline void ksl_add_vvxf_certified(const ksl_vec3f_t *v, const float k, ksl_vec3f_t *vo,
    ksl_vec3f_t *vo_bound) {
  const float vo_0 = v->x + k;
  const float vo_0_abs = fabsf(vo_0), vo_0_error_bound = KSL_MULF(5.960465e-08f, vo_0_abs);
  const float v_y = v->y;
  const float v_z = v->z;
  vo->x = vo_0;
  vo->y = v_y;
  vo->z = v_z;
  vo_bound->x = vo_0_error_bound;
  vo_bound->y = 0.0f;
  vo_bound->z = 0.0f;
}

/* vo = v - k e_x; |error of vo| <= vo_bound unless inf or NaN.
   v, vo, vo_bound: vector; k: number.
   1 mul, 1 add, 1 abs. */
static inline void ksl_add_vvxinvf_certified(const ksl_vec3f_t *v, const float k, ksl_vec3f_t *vo,
    ksl_vec3f_t *vo_bound) {
  const float vo_0 = v->x - k;
  const float vo_0_abs = fabsf(vo_0), vo_0_error_bound = KSL_MULF(5.960465e-08f, vo_0_abs);
  const float v_y = v->y;
  const float v_z = v->z;
  vo->x = vo_0;
  vo->y = v_y;
  vo->z = v_z;
  vo_bound->x = vo_0_error_bound;
  vo_bound->y = 0.0f;
  vo_bound->z = 0.0f;
}

/* vo = v + k e_y; |error of vo| <= vo_bound unless inf or NaN.
   v, vo, vo_bound: vector; k: number.
   1 mul, 1 add, 1 abs. */
static inline void ksl_add_vvyf_certified(const ksl_vec3f_t *v, const float k, ksl_vec3f_t *vo,
    ksl_vec3f_t *vo_bound) {
  const float vo_1 = v->y + k;
  const float vo_1_abs = fabsf(vo_1), vo_1_error_bound = KSL_MULF(5.960465e-08f, vo_1_abs);
  const float v_x = v->x;
  const float v_z = v->z;
  vo->x = v_x;
  vo->y = vo_1;
  vo->z = v_z;
  vo_bound->x = 0.0f;
  vo_bound->y = vo_1_error_bound;
  vo_bound->z = 0.0f;
}

/* vo = v - k e_y; |error of vo| <= vo_bound unless inf or NaN.
   v, vo, vo_bound: vector; k: number.
   1 mul, 1 add, 1 abs. */
static inline void ksl_add_vvyinvf_certified(const ksl_vec3f_t *v, const float k, ksl_vec3f_t *vo,
    ksl_vec3f_t *vo_bound) {
  const float vo_1 = v->y - k;
  const float vo_1_abs = fabsf(vo_1), vo_1_error_bound = KSL_MULF(5.960465e-08f, vo_1_abs);
  const float v_x = v->x;
  const float v_z = v->z;
  vo->x = v_x;
  vo->y = vo_1;
  vo->z = v_z;
  vo_bound->x = 0.0f;
  vo_bound->y = vo_1_error_bound;
  vo_bound->z = 0.0f;
}

/* vo = v + k e_z; |error of vo| <= vo_bound unless inf or NaN.
   v, vo, vo_bound: vector; k: number.
   1 mul, 1 add, 1 abs. */
static inline void ksl_add_vvzf_certified(const ksl_vec3f_t *v, const float k, ksl_vec3f_t *vo,
    ksl_vec3f_t *vo_bound) {
  const float vo_2 = v->z + k;
  const float vo_2_abs = fabsf(vo_2), vo_2_error_bound = KSL_MULF(5.960465e-08f, vo_2_abs);
  const float v_x = v->x;
  const float v_y = v->y;
  vo->x = v_x;
  vo->y = v_y;
  vo->z = vo_2;
  vo_bound->x = 0.0f;
  vo_bound->y = 0.0f;
  vo_bound->z = vo_2_error_bound;
}

/* vo = v - k e_z; |error of vo| <= vo_bound unless inf or NaN.
   v, vo, vo_bound: vector; k: number.
   1 mul, 1 add, 1 abs. */
static inline void ksl_add_vvzinvf_certified(const ksl_vec3f_t *v, const float k, ksl_vec3f_t *vo,
    ksl_vec3f_t *vo_bound) {
  const float vo_2 = v->z - k;
  const float vo_2_abs = fabsf(vo_2), vo_2_error_bound = KSL_MULF(5.960465e-08f, vo_2_abs);
  const float v_x = v->x;
  const float v_y = v->y;
  vo->x = v_x;
  vo->y = v_y;
  vo->z = vo_2;
  vo_bound->x = 0.0f;
  vo_bound->y = 0.0f;
  vo_bound->z = vo_2_error_bound;
}

#endif
