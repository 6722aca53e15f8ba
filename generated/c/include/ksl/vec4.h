/* Made by `coscrew generate`; changes are overwritten. */
/* SPDX-License-Identifier: MIT */
/* coscrew 0.2.0.  Copyright (c) 2026 The coscrew authors. */
/* Vectors of four components: three dimensions and a homogeneous coordinate. */
#ifndef KSL_VEC4_H
#define KSL_VEC4_H

#include "ksl_types.h"

/* The vec4 of these entries, in order. */
static inline ksl_vec4_t ksl_vec4(const double x, const double y, const double z, const double w) {
  ksl_vec4_t value;
  value.x = x;
  value.y = y;
  value.z = z;
  value.w = w;
  return value;
}

/* vo = vi.
   vi, vo: vector (x, y, z) and a homogeneous coordinate w.
   No arithmetic.
   Exact. */
static inline void ksl_vec4_copy(const ksl_vec4_t *vi, ksl_vec4_t *vo) {
  const double vi_x = vi->x;
  const double vi_y = vi->y;
  const double vi_z = vi->z;
  const double vi_w = vi->w;
  vo->x = vi_x;
  vo->y = vi_y;
  vo->z = vi_z;
  vo->w = vi_w;
}

/* self = a self.
   self: vector (x, y, z) and a homogeneous coordinate w; a: number.
   4 mul.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_vec4_scale(ksl_vec4_t *self, const double a) {
  const double self_0_new = KSL_MUL(self->x, a), self_1_new = KSL_MUL(self->y, a),
      self_2_new = KSL_MUL(self->z, a), self_3_new = KSL_MUL(self->w, a);
  self->x = self_0_new;
  self->y = self_1_new;
  self->z = self_2_new;
  self->w = self_3_new;
}

/* vo = -vi.
   vi, vo: vector (x, y, z) and a homogeneous coordinate w.
   4 neg.
   Exact. */
static inline void ksl_vec4_inverted(const ksl_vec4_t *vi, ksl_vec4_t *vo) {
  const double vo_0 = -vi->x, vo_1 = -vi->y, vo_2 = -vi->z, vo_3 = -vi->w;
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
  vo->w = vo_3;
}

/* self = -self.
   self: vector (x, y, z) and a homogeneous coordinate w.
   4 neg.
   Exact. */
static inline void ksl_vec4_invert(ksl_vec4_t *self) {
  const double self_0_new = -self->x, self_1_new = -self->y, self_2_new = -self->z,
      self_3_new = -self->w;
  self->x = self_0_new;
  self->y = self_1_new;
  self->z = self_2_new;
  self->w = self_3_new;
}

/* vo = k v.
   v, vo: vector (x, y, z) and a homogeneous coordinate w; k: number.
   4 mul.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_vec4_scaled(const ksl_vec4_t *v, const double k, ksl_vec4_t *vo) {
  const double vo_0 = KSL_MUL(v->x, k), vo_1 = KSL_MUL(v->y, k), vo_2 = KSL_MUL(v->z, k),
      vo_3 = KSL_MUL(v->w, k);
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
  vo->w = vo_3;
}

/* v1, v2 = v2, v1.
   v1, v2: vector (x, y, z) and a homogeneous coordinate w.
   No arithmetic.
   Exact. */
static inline void ksl_vec4_swap(ksl_vec4_t *v1, ksl_vec4_t *v2) {
  const double v2_x = v2->x;
  const double v2_y = v2->y;
  const double v2_z = v2->z;
  const double v2_w = v2->w;
  const double v1_x = v1->x;
  const double v1_y = v1->y;
  const double v1_z = v1->z;
  const double v1_w = v1->w;
  v1->x = v2_x;
  v1->y = v2_y;
  v1->z = v2_z;
  v1->w = v2_w;
  v2->x = v1_x;
  v2->y = v1_y;
  v2->z = v1_z;
  v2->w = v1_w;
}

/* |v| = sqrt(v·v), all four components.
   v: vector (x, y, z) and a homogeneous coordinate w.
   9 mul, 3 add, 1 sqrt, 4 abs, 9 less, 9 select. */
static inline double ksl_vec4_l2norm(const ksl_vec4_t *v) {
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
  const double n = sqrt(KSL_MUL(y_0, y_0) + KSL_MUL(y_1, y_1) + KSL_MUL(y_2, y_2)
          + KSL_MUL(y_3, y_3));
  const double r_b = s < 1.0 ? 2.6815615859885194e+154 : 1.0,
      r_d = 1.0 < s ? 7.637340908749012e-152 : r_b,
      r = 1.3093562431584567e+151 < s ? 9.332636185032189e-302 : r_d;
  const double norm = KSL_MUL(n, r);
  return norm;
}

/* self = self / |self|; the zero vector stays zero.
   self: vector (x, y, z) and a homogeneous coordinate w.
   16 mul, 3 add, 4 div, 1 sqrt, 4 abs, 8 less, 1 equal, 9 select. */
static inline void ksl_vec4_normalize(ksl_vec4_t *self) {
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
  const double n = sqrt(KSL_MUL(y_0, y_0) + KSL_MUL(y_1, y_1) + KSL_MUL(y_2, y_2)
          + KSL_MUL(y_3, y_3));
  const double divisor = n == 0.0 ? up : n;
  const double sized_0 = KSL_MUL(self->x, up), sized_1 = KSL_MUL(self->y, up),
      sized_2 = KSL_MUL(self->z, up), sized_3 = KSL_MUL(self->w, up);
  const double quotient_0 = sized_0 / divisor, quotient_1 = sized_1 / divisor,
      quotient_2 = sized_2 / divisor, quotient_3 = sized_3 / divisor;
  const double self_0_new = KSL_MUL(quotient_0, down), self_1_new = KSL_MUL(quotient_1, down),
      self_2_new = KSL_MUL(quotient_2, down), self_3_new = KSL_MUL(quotient_3, down);
  self->x = self_0_new;
  self->y = self_1_new;
  self->z = self_2_new;
  self->w = self_3_new;
}

/* vo = v / |v|; the zero vector stays zero.
   v, vo: vector (x, y, z) and a homogeneous coordinate w.
   16 mul, 3 add, 4 div, 1 sqrt, 4 abs, 8 less, 1 equal, 9 select. */
static inline void ksl_vec4_normalized(const ksl_vec4_t *v, ksl_vec4_t *vo) {
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
  const double n = sqrt(KSL_MUL(y_0, y_0) + KSL_MUL(y_1, y_1) + KSL_MUL(y_2, y_2)
          + KSL_MUL(y_3, y_3));
  const double divisor = n == 0.0 ? up : n;
  const double sized_0 = KSL_MUL(v->x, up), sized_1 = KSL_MUL(v->y, up),
      sized_2 = KSL_MUL(v->z, up), sized_3 = KSL_MUL(v->w, up);
  const double quotient_0 = sized_0 / divisor, quotient_1 = sized_1 / divisor,
      quotient_2 = sized_2 / divisor, quotient_3 = sized_3 / divisor;
  const double vo_0 = KSL_MUL(quotient_0, down), vo_1 = KSL_MUL(quotient_1, down),
      vo_2 = KSL_MUL(quotient_2, down), vo_3 = KSL_MUL(quotient_3, down);
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
  vo->w = vo_3;
}

/* The vec4 of these entries, in order. */
static inline ksl_vec4f_t ksl_vec4f(const float x, const float y, const float z, const float w) {
  ksl_vec4f_t value;
  value.x = x;
  value.y = y;
  value.z = z;
  value.w = w;
  return value;
}

/* vo = vi.
   vi, vo: vector (x, y, z) and a homogeneous coordinate w.
   No arithmetic.
   Exact. */
static inline void ksl_vec4f_copy(const ksl_vec4f_t *vi, ksl_vec4f_t *vo) {
  const float vi_x = vi->x;
  const float vi_y = vi->y;
  const float vi_z = vi->z;
  const float vi_w = vi->w;
  vo->x = vi_x;
  vo->y = vi_y;
  vo->z = vi_z;
  vo->w = vi_w;
}

/* self = a self.
   self: vector (x, y, z) and a homogeneous coordinate w; a: number.
   4 mul.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_vec4f_scale(ksl_vec4f_t *self, const float a) {
  const float self_0_new = KSL_MULF(self->x, a), self_1_new = KSL_MULF(self->y, a),
      self_2_new = KSL_MULF(self->z, a), self_3_new = KSL_MULF(self->w, a);
  self->x = self_0_new;
  self->y = self_1_new;
  self->z = self_2_new;
  self->w = self_3_new;
}

/* vo = -vi.
   vi, vo: vector (x, y, z) and a homogeneous coordinate w.
   4 neg.
   Exact. */
static inline void ksl_vec4f_inverted(const ksl_vec4f_t *vi, ksl_vec4f_t *vo) {
  const float vo_0 = -vi->x, vo_1 = -vi->y, vo_2 = -vi->z, vo_3 = -vi->w;
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
  vo->w = vo_3;
}

/* self = -self.
   self: vector (x, y, z) and a homogeneous coordinate w.
   4 neg.
   Exact. */
static inline void ksl_vec4f_invert(ksl_vec4f_t *self) {
  const float self_0_new = -self->x, self_1_new = -self->y, self_2_new = -self->z,
      self_3_new = -self->w;
  self->x = self_0_new;
  self->y = self_1_new;
  self->z = self_2_new;
  self->w = self_3_new;
}

/* vo = k v.
   v, vo: vector (x, y, z) and a homogeneous coordinate w; k: number.
   4 mul.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_vec4f_scaled(const ksl_vec4f_t *v, const float k, ksl_vec4f_t *vo) {
  const float vo_0 = KSL_MULF(v->x, k), vo_1 = KSL_MULF(v->y, k), vo_2 = KSL_MULF(v->z, k),
      vo_3 = KSL_MULF(v->w, k);
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
  vo->w = vo_3;
}

/* v1, v2 = v2, v1.
   v1, v2: vector (x, y, z) and a homogeneous coordinate w.
   No arithmetic.
   Exact. */
static inline void ksl_vec4f_swap(ksl_vec4f_t *v1, ksl_vec4f_t *v2) {
  const float v2_x = v2->x;
  const float v2_y = v2->y;
  const float v2_z = v2->z;
  const float v2_w = v2->w;
  const float v1_x = v1->x;
  const float v1_y = v1->y;
  const float v1_z = v1->z;
  const float v1_w = v1->w;
  v1->x = v2_x;
  v1->y = v2_y;
  v1->z = v2_z;
  v1->w = v2_w;
  v2->x = v1_x;
  v2->y = v1_y;
  v2->z = v1_z;
  v2->w = v1_w;
}

/* |v| = sqrt(v·v), all four components.
   v: vector (x, y, z) and a homogeneous coordinate w.
   9 mul, 3 add, 1 sqrt, 4 abs, 9 less, 9 select. */
static inline float ksl_vec4f_l2norm(const ksl_vec4f_t *v) {
  const float s_size_0 = fabsf(v->x), s_size_1 = fabsf(v->y), s_size_2 = fabsf(v->z),
      s_size_3 = fabsf(v->w);
  const float s_largest1 = s_size_0 < s_size_1 ? s_size_1 : s_size_0;
  const float s_largest2 = s_largest1 < s_size_2 ? s_size_2 : s_largest1;
  const float s_largest3 = s_largest2 < s_size_3 ? s_size_3 : s_largest2;
  const float s_b = 4.611686e+18f < s_largest3 ? 2.7105054e-20f : 1.0f,
      s_d = s_largest3 < 256.0f ? 1.8014399e+16f : s_b,
      s = s_largest3 < 1.4210855e-14f ? 3.2451855e+32f : s_d;
  const float y_0 = KSL_MULF(v->x, s), y_1 = KSL_MULF(v->y, s), y_2 = KSL_MULF(v->z, s),
      y_3 = KSL_MULF(v->w, s);
  const float n = sqrtf(KSL_MULF(y_0, y_0) + KSL_MULF(y_1, y_1) + KSL_MULF(y_2, y_2)
          + KSL_MULF(y_3, y_3));
  const float r_b = s < 1.0f ? 3.689349e+19f : 1.0f, r_d = 1.0f < s ? 5.551115e-17f : r_b,
      r = 1.8014399e+16f < s ? 3.081488e-33f : r_d;
  const float norm = KSL_MULF(n, r);
  return norm;
}

/* self = self / |self|; the zero vector stays zero.
   self: vector (x, y, z) and a homogeneous coordinate w.
   16 mul, 3 add, 4 div, 1 sqrt, 4 abs, 8 less, 1 equal, 9 select. */
static inline void ksl_vec4f_normalize(ksl_vec4f_t *self) {
  const float s_size_0 = fabsf(self->x), s_size_1 = fabsf(self->y), s_size_2 = fabsf(self->z),
      s_size_3 = fabsf(self->w);
  const float s_largest1 = s_size_0 < s_size_1 ? s_size_1 : s_size_0;
  const float s_largest2 = s_largest1 < s_size_2 ? s_size_2 : s_largest1;
  const float s_largest3 = s_largest2 < s_size_3 ? s_size_3 : s_largest2;
  const float s_b = 4.611686e+18f < s_largest3 ? 2.7105054e-20f : 1.0f,
      s_d = s_largest3 < 256.0f ? 1.8014399e+16f : s_b,
      s = s_largest3 < 1.4210855e-14f ? 3.2451855e+32f : s_d;
  const float y_0 = KSL_MULF(self->x, s), y_1 = KSL_MULF(self->y, s), y_2 = KSL_MULF(self->z, s),
      y_3 = KSL_MULF(self->w, s);
  const float up = 1.0f < s ? s : 1.0f;
  const float down = s < 1.0f ? s : 1.0f;
  const float n = sqrtf(KSL_MULF(y_0, y_0) + KSL_MULF(y_1, y_1) + KSL_MULF(y_2, y_2)
          + KSL_MULF(y_3, y_3));
  const float divisor = n == 0.0f ? up : n;
  const float sized_0 = KSL_MULF(self->x, up), sized_1 = KSL_MULF(self->y, up),
      sized_2 = KSL_MULF(self->z, up), sized_3 = KSL_MULF(self->w, up);
  const float quotient_0 = sized_0 / divisor, quotient_1 = sized_1 / divisor,
      quotient_2 = sized_2 / divisor, quotient_3 = sized_3 / divisor;
  const float self_0_new = KSL_MULF(quotient_0, down), self_1_new = KSL_MULF(quotient_1, down),
      self_2_new = KSL_MULF(quotient_2, down), self_3_new = KSL_MULF(quotient_3, down);
  self->x = self_0_new;
  self->y = self_1_new;
  self->z = self_2_new;
  self->w = self_3_new;
}

/* vo = v / |v|; the zero vector stays zero.
   v, vo: vector (x, y, z) and a homogeneous coordinate w.
   16 mul, 3 add, 4 div, 1 sqrt, 4 abs, 8 less, 1 equal, 9 select. */
static inline void ksl_vec4f_normalized(const ksl_vec4f_t *v, ksl_vec4f_t *vo) {
  const float s_size_0 = fabsf(v->x), s_size_1 = fabsf(v->y), s_size_2 = fabsf(v->z),
      s_size_3 = fabsf(v->w);
  const float s_largest1 = s_size_0 < s_size_1 ? s_size_1 : s_size_0;
  const float s_largest2 = s_largest1 < s_size_2 ? s_size_2 : s_largest1;
  const float s_largest3 = s_largest2 < s_size_3 ? s_size_3 : s_largest2;
  const float s_b = 4.611686e+18f < s_largest3 ? 2.7105054e-20f : 1.0f,
      s_d = s_largest3 < 256.0f ? 1.8014399e+16f : s_b,
      s = s_largest3 < 1.4210855e-14f ? 3.2451855e+32f : s_d;
  const float y_0 = KSL_MULF(v->x, s), y_1 = KSL_MULF(v->y, s), y_2 = KSL_MULF(v->z, s),
      y_3 = KSL_MULF(v->w, s);
  const float up = 1.0f < s ? s : 1.0f;
  const float down = s < 1.0f ? s : 1.0f;
  const float n = sqrtf(KSL_MULF(y_0, y_0) + KSL_MULF(y_1, y_1) + KSL_MULF(y_2, y_2)
          + KSL_MULF(y_3, y_3));
  const float divisor = n == 0.0f ? up : n;
  const float sized_0 = KSL_MULF(v->x, up), sized_1 = KSL_MULF(v->y, up),
      sized_2 = KSL_MULF(v->z, up), sized_3 = KSL_MULF(v->w, up);
  const float quotient_0 = sized_0 / divisor, quotient_1 = sized_1 / divisor,
      quotient_2 = sized_2 / divisor, quotient_3 = sized_3 / divisor;
  const float vo_0 = KSL_MULF(quotient_0, down), vo_1 = KSL_MULF(quotient_1, down),
      vo_2 = KSL_MULF(quotient_2, down), vo_3 = KSL_MULF(quotient_3, down);
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
  vo->w = vo_3;
}

#ifndef KSL_NO_ALLOC
#include <stdlib.h>

/* n ksl_vec4_t on the heap, zeros, to be freed by the caller; NULL for n <= 0 or when there is
     no memory. */
static inline ksl_vec4_t *ksl_vec4_alloc(int n) {
  return n > 0 ? (ksl_vec4_t *)calloc((size_t)n, sizeof(ksl_vec4_t)) : NULL;
}

/* n ksl_vec4f_t on the heap, zeros, to be freed by the caller; NULL for n <= 0 or when there is
     no memory. */
static inline ksl_vec4f_t *ksl_vec4f_alloc(int n) {
  return n > 0 ? (ksl_vec4f_t *)calloc((size_t)n, sizeof(ksl_vec4f_t)) : NULL;
}

#endif

/* What KSL declares beside formulas. */


/* The vec4 of these entries, in order. */
static inline ksl_vec4i_t ksl_vec4i(const int x, const int y, const int z, const int w) {
  ksl_vec4i_t value;
  value.x = x;
  value.y = y;
  value.z = z;
  value.w = w;
  return value;
}

#ifndef KSL_NO_ALLOC
#include <stdlib.h>

/* n ksl_vec4i_t on the heap, zeros, to be freed by the caller; NULL for n <= 0 or when there is
     no memory. */
static inline ksl_vec4i_t *ksl_vec4i_alloc(int n) {
  return n > 0 ? (ksl_vec4i_t *)calloc((size_t)n, sizeof(ksl_vec4i_t)) : NULL;
}

#endif

#endif
