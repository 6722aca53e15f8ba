/* Made by `coscrew generate`; changes are overwritten. */
/* SPDX-License-Identifier: MIT */
/* coscrew 0.2.0.  Copyright (c) 2026 The coscrew authors. */
/* Vectors of four components: three dimensions and a homogeneous coordinate.
   Fused tier: products fused into sums. */
#ifndef KSL_VEC4_FUSED_H
#define KSL_VEC4_FUSED_H

#include "ksl_types.h"

/* self = a self.
   self: vector (x, y, z) and a homogeneous coordinate w; a: number.
   4 mul.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_vec4_scale_fused(ksl_vec4_t *self, const double a) {
  const double self_0_new = KSL_MUL(self->x, a);
  const double self_1_new = KSL_MUL(self->y, a);
  const double self_2_new = KSL_MUL(self->z, a);
  const double self_3_new = KSL_MUL(self->w, a);
  self->x = self_0_new;
  self->y = self_1_new;
  self->z = self_2_new;
  self->w = self_3_new;
}

/* vo = k v.
   v, vo: vector (x, y, z) and a homogeneous coordinate w; k: number.
   4 mul.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_vec4_scaled_fused(const ksl_vec4_t *v, const double k, ksl_vec4_t *vo) {
  const double vo_0 = KSL_MUL(v->x, k);
  const double vo_1 = KSL_MUL(v->y, k);
  const double vo_2 = KSL_MUL(v->z, k);
  const double vo_3 = KSL_MUL(v->w, k);
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
  vo->w = vo_3;
}

/* self = a self.
   self: vector (x, y, z) and a homogeneous coordinate w; a: number.
   4 mul.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_vec4f_scale_fused(ksl_vec4f_t *self, const float a) {
  const float self_0_new = KSL_MULF(self->x, a);
  const float self_1_new = KSL_MULF(self->y, a);
  const float self_2_new = KSL_MULF(self->z, a);
  const float self_3_new = KSL_MULF(self->w, a);
  self->x = self_0_new;
  self->y = self_1_new;
  self->z = self_2_new;
  self->w = self_3_new;
}

/* vo = k v.
   v, vo: vector (x, y, z) and a homogeneous coordinate w; k: number.
   4 mul.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_vec4f_scaled_fused(const ksl_vec4f_t *v, const float k, ksl_vec4f_t *vo) {
  const float vo_0 = KSL_MULF(v->x, k);
  const float vo_1 = KSL_MULF(v->y, k);
  const float vo_2 = KSL_MULF(v->z, k);
  const float vo_3 = KSL_MULF(v->w, k);
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
  vo->w = vo_3;
}

#endif
