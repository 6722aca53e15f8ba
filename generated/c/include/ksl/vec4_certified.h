/* Made by `coscrew generate`; changes are overwritten. */
/* SPDX-License-Identifier: MIT */
/* coscrew 0.2.0.  Copyright (c) 2026 The coscrew authors. */
/* Vectors of four components: three dimensions and a homogeneous coordinate.
   Certified tier: plain results, and bounds on their errors that always hold. */
#ifndef KSL_VEC4_CERTIFIED_H
#define KSL_VEC4_CERTIFIED_H

#include "ksl_types.h"

/* self = a self; |error of self| <= self_bound unless inf or NaN.
   self, self_bound: vector (x, y, z) and a homogeneous coordinate w; a: number.
   8 mul, 4 add, 4 abs. */
static inline void ksl_vec4_scale_certified(ksl_vec4_t *self, const double a,
    ksl_vec4_t *self_bound) {
  const double self_0_new = KSL_MUL(self->x, a), self_1_new = KSL_MUL(self->y, a),
      self_2_new = KSL_MUL(self->z, a), self_3_new = KSL_MUL(self->w, a);
  const double self_0_new_bound = KSL_MUL(1.1102230246251568e-16, fabs(self_0_new)
          + 2.004168360008973e-292),
      self_1_new_bound = KSL_MUL(1.1102230246251568e-16, fabs(self_1_new) + 2.004168360008973e-292),
      self_2_new_bound = KSL_MUL(1.1102230246251568e-16, fabs(self_2_new) + 2.004168360008973e-292),
      self_3_new_bound = KSL_MUL(1.1102230246251568e-16, fabs(self_3_new) + 2.004168360008973e-292);
  self->x = self_0_new;
  self->y = self_1_new;
  self->z = self_2_new;
  self->w = self_3_new;
  self_bound->x = self_0_new_bound;
  self_bound->y = self_1_new_bound;
  self_bound->z = self_2_new_bound;
  self_bound->w = self_3_new_bound;
}

/* vo = k v; |error of vo| <= vo_bound unless inf or NaN.
   v, vo, vo_bound: vector (x, y, z) and a homogeneous coordinate w; k: number.
   8 mul, 4 add, 4 abs. */
static inline void ksl_vec4_scaled_certified(const ksl_vec4_t *v, const double k, ksl_vec4_t *vo,
    ksl_vec4_t *vo_bound) {
  const double vo_0 = KSL_MUL(v->x, k), vo_1 = KSL_MUL(v->y, k), vo_2 = KSL_MUL(v->z, k),
      vo_3 = KSL_MUL(v->w, k);
  const double vo_0_bound = KSL_MUL(1.1102230246251568e-16, fabs(vo_0) + 2.004168360008973e-292),
      vo_1_bound = KSL_MUL(1.1102230246251568e-16, fabs(vo_1) + 2.004168360008973e-292),
      vo_2_bound = KSL_MUL(1.1102230246251568e-16, fabs(vo_2) + 2.004168360008973e-292),
      vo_3_bound = KSL_MUL(1.1102230246251568e-16, fabs(vo_3) + 2.004168360008973e-292);
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
  vo->w = vo_3;
  vo_bound->x = vo_0_bound;
  vo_bound->y = vo_1_bound;
  vo_bound->z = vo_2_bound;
  vo_bound->w = vo_3_bound;
}

/* self = a self; |error of self| <= self_bound unless inf or NaN.
   self, self_bound: vector (x, y, z) and a homogeneous coordinate w; a: number.
   8 mul, 4 add, 4 abs. */
static inline void ksl_vec4f_scale_certified(ksl_vec4f_t *self, const float a,
    ksl_vec4f_t *self_bound) {
  const float self_0_new = KSL_MULF(self->x, a), self_1_new = KSL_MULF(self->y, a),
      self_2_new = KSL_MULF(self->z, a), self_3_new = KSL_MULF(self->w, a);
  const float self_0_new_bound = KSL_MULF(5.960465e-08f, fabsf(self_0_new) + 1.9721523e-31f),
      self_1_new_bound = KSL_MULF(5.960465e-08f, fabsf(self_1_new) + 1.9721523e-31f),
      self_2_new_bound = KSL_MULF(5.960465e-08f, fabsf(self_2_new) + 1.9721523e-31f),
      self_3_new_bound = KSL_MULF(5.960465e-08f, fabsf(self_3_new) + 1.9721523e-31f);
  self->x = self_0_new;
  self->y = self_1_new;
  self->z = self_2_new;
  self->w = self_3_new;
  self_bound->x = self_0_new_bound;
  self_bound->y = self_1_new_bound;
  self_bound->z = self_2_new_bound;
  self_bound->w = self_3_new_bound;
}

/* vo = k v; |error of vo| <= vo_bound unless inf or NaN.
   v, vo, vo_bound: vector (x, y, z) and a homogeneous coordinate w; k: number.
   8 mul, 4 add, 4 abs. */
static inline void ksl_vec4f_scaled_certified(const ksl_vec4f_t *v, const float k,
    ksl_vec4f_t *vo, ksl_vec4f_t *vo_bound) {
  const float vo_0 = KSL_MULF(v->x, k), vo_1 = KSL_MULF(v->y, k), vo_2 = KSL_MULF(v->z, k),
      vo_3 = KSL_MULF(v->w, k);
  const float vo_0_bound = KSL_MULF(5.960465e-08f, fabsf(vo_0) + 1.9721523e-31f),
      vo_1_bound = KSL_MULF(5.960465e-08f, fabsf(vo_1) + 1.9721523e-31f),
      vo_2_bound = KSL_MULF(5.960465e-08f, fabsf(vo_2) + 1.9721523e-31f),
      vo_3_bound = KSL_MULF(5.960465e-08f, fabsf(vo_3) + 1.9721523e-31f);
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
  vo->w = vo_3;
  vo_bound->x = vo_0_bound;
  vo_bound->y = vo_1_bound;
  vo_bound->z = vo_2_bound;
  vo_bound->w = vo_3_bound;
}

#endif
