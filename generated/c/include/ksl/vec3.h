/* Made by `coscrew generate`; changes are overwritten. */
/* SPDX-License-Identifier: MIT */
/* coscrew 0.2.0.  Copyright (c) 2026 The coscrew authors. */
/* Vectors of three components. */
#ifndef KSL_VEC3_H
#define KSL_VEC3_H

#include <stdbool.h>
#include "ksl_types.h"
#include "elementary.h"

/* The vec3 of these entries, in order. */
static inline ksl_vec3_t ksl_vec3(const double x, const double y, const double z) {
  ksl_vec3_t value;
  value.x = x;
  value.y = y;
  value.z = z;
  return value;
}

/* vo = vi.
   vi, vo: vector.
   No arithmetic.
   Exact. */
static inline void ksl_vec3_copy(const ksl_vec3_t *vi, ksl_vec3_t *vo) {
  const double vi_x = vi->x;
  const double vi_y = vi->y;
  const double vi_z = vi->z;
  vo->x = vi_x;
  vo->y = vi_y;
  vo->z = vi_z;
}

/* self = a self.
   self: vector; a: number.
   3 mul.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_vec3_scale(ksl_vec3_t *self, const double a) {
  const double self_0_new = KSL_MUL(self->x, a), self_1_new = KSL_MUL(self->y, a),
      self_2_new = KSL_MUL(self->z, a);
  self->x = self_0_new;
  self->y = self_1_new;
  self->z = self_2_new;
}

/* vo = -vi.
   vi, vo: vector.
   3 neg.
   Exact. */
static inline void ksl_vec3_inverted(const ksl_vec3_t *vi, ksl_vec3_t *vo) {
  const double vo_0 = -vi->x, vo_1 = -vi->y, vo_2 = -vi->z;
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
}

/* self = -self.
   self: vector.
   3 neg.
   Exact. */
static inline void ksl_vec3_invert(ksl_vec3_t *self) {
  const double self_0_new = -self->x, self_1_new = -self->y, self_2_new = -self->z;
  self->x = self_0_new;
  self->y = self_1_new;
  self->z = self_2_new;
}

/* y = a x + y.
   a: number; x, y: vector.
   3 mul, 3 add.
   Error <= u |result| + 1 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_axpy_vv(const double a, const ksl_vec3_t *x, ksl_vec3_t *y) {
  const double y_0_new = KSL_MUL(a, x->x) + y->x, y_1_new = KSL_MUL(a, x->y) + y->y,
      y_2_new = KSL_MUL(a, x->z) + y->z;
  y->x = y_0_new;
  y->y = y_1_new;
  y->z = y_2_new;
}

/* y = x + y.
   x, y: vector.
   3 add.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_xpy_vv(const ksl_vec3_t *x, ksl_vec3_t *y) {
  const double y_0_new = x->x + y->x, y_1_new = x->y + y->y, y_2_new = x->z + y->z;
  y->x = y_0_new;
  y->y = y_1_new;
  y->z = y_2_new;
}

/* y = -x + y.
   x, y: vector.
   3 add.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_nxpy_vv(const ksl_vec3_t *x, ksl_vec3_t *y) {
  const double y_0_new = y->x - x->x, y_1_new = y->y - x->y, y_2_new = y->z - x->z;
  y->x = y_0_new;
  y->y = y_1_new;
  y->z = y_2_new;
}

/* vo = a vi.
   a: number; vi, vo: vector.
   3 mul.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_product_av(const double a, const ksl_vec3_t *vi, ksl_vec3_t *vo) {
  const double vo_0 = KSL_MUL(a, vi->x), vo_1 = KSL_MUL(a, vi->y), vo_2 = KSL_MUL(a, vi->z);
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
}

/* vo = v1 + v2.
   v1, v2, vo: vector.
   3 add.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_add_vv(const ksl_vec3_t *v1, const ksl_vec3_t *v2, ksl_vec3_t *vo) {
  const double vo_0 = v1->x + v2->x, vo_1 = v1->y + v2->y, vo_2 = v1->z + v2->z;
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
}

/* vo = v1 - v2.
   v1, v2, vo: vector.
   3 add.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_subtract_vv(const ksl_vec3_t *v1, const ksl_vec3_t *v2, ksl_vec3_t *vo) {
  const double vo_0 = v1->x - v2->x, vo_1 = v1->y - v2->y, vo_2 = v1->z - v2->z;
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
}

/* vo = k v.
   v, vo: vector; k: number.
   3 mul.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_vec3_scaled(const ksl_vec3_t *v, const double k, ksl_vec3_t *vo) {
  const double vo_0 = KSL_MUL(v->x, k), vo_1 = KSL_MUL(v->y, k), vo_2 = KSL_MUL(v->z, k);
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
}

/* v1, v2 = v2, v1.
   v1, v2: vector.
   No arithmetic.
   Exact. */
static inline void ksl_vec3_swap(ksl_vec3_t *v1, ksl_vec3_t *v2) {
  const double v2_x = v2->x;
  const double v2_y = v2->y;
  const double v2_z = v2->z;
  const double v1_x = v1->x;
  const double v1_y = v1->y;
  const double v1_z = v1->z;
  v1->x = v2_x;
  v1->y = v2_y;
  v1->z = v2_z;
  v2->x = v1_x;
  v2->y = v1_y;
  v2->z = v1_z;
}

/* |v| = sqrt(v·v).
   v: vector.
   7 mul, 2 add, 1 sqrt, 3 abs, 8 less, 8 select. */
static inline double ksl_vec3_l2norm(const ksl_vec3_t *v) {
  const double s_size_0 = fabs(v->x), s_size_1 = fabs(v->y), s_size_2 = fabs(v->z);
  const double s_largest1 = s_size_0 < s_size_1 ? s_size_1 : s_size_0;
  const double s_largest2 = s_largest1 < s_size_2 ? s_size_2 : s_largest1;
  const double s_b = 6.703903964971299e+153 < s_largest2 ? 3.7291703656001034e-155 : 1.0,
      s_d = s_largest2 < 256.0 ? 1.3093562431584567e+151 : s_b,
      s = s_largest2 < 1.955159272639747e-149 ? 1.0715086071862673e+301 : s_d;
  const double y_0 = KSL_MUL(v->x, s), y_1 = KSL_MUL(v->y, s), y_2 = KSL_MUL(v->z, s);
  const double n = sqrt(KSL_MUL(y_0, y_0) + KSL_MUL(y_1, y_1) + KSL_MUL(y_2, y_2));
  const double r_b = s < 1.0 ? 2.6815615859885194e+154 : 1.0,
      r_d = 1.0 < s ? 7.637340908749012e-152 : r_b,
      r = 1.3093562431584567e+151 < s ? 9.332636185032189e-302 : r_d;
  const double norm = KSL_MUL(n, r);
  return norm;
}

/* self = self / |self|; the zero vector stays zero.
   self: vector.
   12 mul, 2 add, 3 div, 1 sqrt, 3 abs, 7 less, 1 equal, 8 select. */
static inline void ksl_vec3_normalize(ksl_vec3_t *self) {
  const double s_size_0 = fabs(self->x), s_size_1 = fabs(self->y), s_size_2 = fabs(self->z);
  const double s_largest1 = s_size_0 < s_size_1 ? s_size_1 : s_size_0;
  const double s_largest2 = s_largest1 < s_size_2 ? s_size_2 : s_largest1;
  const double s_b = 6.703903964971299e+153 < s_largest2 ? 3.7291703656001034e-155 : 1.0,
      s_d = s_largest2 < 256.0 ? 1.3093562431584567e+151 : s_b,
      s = s_largest2 < 1.955159272639747e-149 ? 1.0715086071862673e+301 : s_d;
  const double y_0 = KSL_MUL(self->x, s), y_1 = KSL_MUL(self->y, s), y_2 = KSL_MUL(self->z, s);
  const double up = 1.0 < s ? s : 1.0;
  const double down = s < 1.0 ? s : 1.0;
  const double n = sqrt(KSL_MUL(y_0, y_0) + KSL_MUL(y_1, y_1) + KSL_MUL(y_2, y_2));
  const double divisor = n == 0.0 ? up : n;
  const double sized_0 = KSL_MUL(self->x, up), sized_1 = KSL_MUL(self->y, up),
      sized_2 = KSL_MUL(self->z, up);
  const double quotient_0 = sized_0 / divisor, quotient_1 = sized_1 / divisor,
      quotient_2 = sized_2 / divisor;
  const double self_0_new = KSL_MUL(quotient_0, down), self_1_new = KSL_MUL(quotient_1, down),
      self_2_new = KSL_MUL(quotient_2, down);
  self->x = self_0_new;
  self->y = self_1_new;
  self->z = self_2_new;
}

/* vo = v / |v|; the zero vector stays zero.
   v, vo: vector.
   12 mul, 2 add, 3 div, 1 sqrt, 3 abs, 7 less, 1 equal, 8 select. */
static inline void ksl_vec3_normalized(const ksl_vec3_t *v, ksl_vec3_t *vo) {
  const double s_size_0 = fabs(v->x), s_size_1 = fabs(v->y), s_size_2 = fabs(v->z);
  const double s_largest1 = s_size_0 < s_size_1 ? s_size_1 : s_size_0;
  const double s_largest2 = s_largest1 < s_size_2 ? s_size_2 : s_largest1;
  const double s_b = 6.703903964971299e+153 < s_largest2 ? 3.7291703656001034e-155 : 1.0,
      s_d = s_largest2 < 256.0 ? 1.3093562431584567e+151 : s_b,
      s = s_largest2 < 1.955159272639747e-149 ? 1.0715086071862673e+301 : s_d;
  const double y_0 = KSL_MUL(v->x, s), y_1 = KSL_MUL(v->y, s), y_2 = KSL_MUL(v->z, s);
  const double up = 1.0 < s ? s : 1.0;
  const double down = s < 1.0 ? s : 1.0;
  const double n = sqrt(KSL_MUL(y_0, y_0) + KSL_MUL(y_1, y_1) + KSL_MUL(y_2, y_2));
  const double divisor = n == 0.0 ? up : n;
  const double sized_0 = KSL_MUL(v->x, up), sized_1 = KSL_MUL(v->y, up),
      sized_2 = KSL_MUL(v->z, up);
  const double quotient_0 = sized_0 / divisor, quotient_1 = sized_1 / divisor,
      quotient_2 = sized_2 / divisor;
  const double vo_0 = KSL_MUL(quotient_0, down), vo_1 = KSL_MUL(quotient_1, down),
      vo_2 = KSL_MUL(quotient_2, down);
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
}

/* angle = atan2(|v1 × v2|, v1·v2), in [0, π].
   v1, v2: vector.
   51 mul, 42 add, 1 div, 1 sqrt, 1 neg, 11 abs, 2 copysign, 24 less, 1 equal, 32 select. */
static inline double ksl_angle_vv(const ksl_vec3_t *v1, const ksl_vec3_t *v2) {
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
  const double c_0 = KSL_MUL(scaled_s1_1, scaled_s2_2) - KSL_MUL(scaled_s1_2, scaled_s2_1),
      c_1 = KSL_MUL(scaled_s1_2, scaled_s2_0) - KSL_MUL(scaled_s1_0, scaled_s2_2),
      c_2 = KSL_MUL(scaled_s1_0, scaled_s2_1) - KSL_MUL(scaled_s1_1, scaled_s2_0);
  const double s_size_0 = fabs(c_0), s_size_1 = fabs(c_1), s_size_2 = fabs(c_2);
  const double s_largest1 = s_size_0 < s_size_1 ? s_size_1 : s_size_0;
  const double s_largest2 = s_largest1 < s_size_2 ? s_size_2 : s_largest1;
  const double s_b = 6.703903964971299e+153 < s_largest2 ? 3.7291703656001034e-155 : 1.0,
      s_d = s_largest2 < 256.0 ? 1.3093562431584567e+151 : s_b,
      s = s_largest2 < 1.955159272639747e-149 ? 1.0715086071862673e+301 : s_d;
  const double y_0 = KSL_MUL(c_0, s), y_1 = KSL_MUL(c_1, s), y_2 = KSL_MUL(c_2, s);
  const double n = sqrt(KSL_MUL(y_0, y_0) + KSL_MUL(y_1, y_1) + KSL_MUL(y_2, y_2));
  const double r_b = s < 1.0 ? 2.6815615859885194e+154 : 1.0,
      r_d = 1.0 < s ? 7.637340908749012e-152 : r_b,
      r = 1.3093562431584567e+151 < s ? 9.332636185032189e-302 : r_d;
  const double cross = KSL_MUL(n, r);
  const double dot_ = KSL_MUL(scaled_s1_0, scaled_s2_0) + KSL_MUL(scaled_s1_1, scaled_s2_1)
          + KSL_MUL(scaled_s1_2, scaled_s2_2);
  const double angle = ksl_atan2(cross, dot_);
  return angle;
}

/* v1·v2.
   v1, v2: vector.
   3 mul, 2 add.
   Error <= u |result| + 2 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline double ksl_dot_vv(const ksl_vec3_t *v1, const ksl_vec3_t *v2) {
  const double dot = KSL_MUL(v1->x, v2->x) + KSL_MUL(v1->y, v2->y) + KSL_MUL(v1->z, v2->z);
  return dot;
}

/* vo = k (-v).
   k: number; v, vo: vector.
   3 mul, 3 neg.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_product_avinv(const double k, const ksl_vec3_t *v, ksl_vec3_t *vo) {
  const double vo_0 = -KSL_MUL(k, v->x), vo_1 = -KSL_MUL(k, v->y), vo_2 = -KSL_MUL(k, v->z);
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
}

/* vo = v / k.
   k: number; v, vo: vector.
   3 div. */
static inline void ksl_product_ainvv(const double k, const ksl_vec3_t *v, ksl_vec3_t *vo) {
  const double vo_0 = v->x / k, vo_1 = v->y / k, vo_2 = v->z / k;
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
}

/* vo = v1 × v2.  Exactly zero for v1 = v2, unless products overflow.
   v1, v2, vo: vector.
   6 mul, 3 add.
   Error <= u |result| + 1 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_cross_vv(const ksl_vec3_t *v1, const ksl_vec3_t *v2, ksl_vec3_t *vo) {
  const double vo_0 = KSL_MUL(v1->y, v2->z) - KSL_MUL(v1->z, v2->y),
      vo_1 = KSL_MUL(v1->z, v2->x) - KSL_MUL(v1->x, v2->z),
      vo_2 = KSL_MUL(v1->x, v2->y) - KSL_MUL(v1->y, v2->x);
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
}

/* vo = v1 × (-v2).
   v1, v2, vo: vector.
   6 mul, 3 add.
   Error <= u |result| + 1 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_cross_vvinv(const ksl_vec3_t *v1, const ksl_vec3_t *v2, ksl_vec3_t *vo) {
  const double vo_0 = KSL_MUL(v1->z, v2->y) - KSL_MUL(v1->y, v2->z),
      vo_1 = KSL_MUL(v1->x, v2->z) - KSL_MUL(v1->z, v2->x),
      vo_2 = KSL_MUL(v1->y, v2->x) - KSL_MUL(v1->x, v2->y);
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
}

/* vo = v + k e_x.
   v, vo: vector; k: number.
   1 add.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_add_vvx(const ksl_vec3_t *v, const double k, ksl_vec3_t *vo) {
  const double vo_0 = v->x + k;
  const double v_y = v->y;
  const double v_z = v->z;
  vo->x = vo_0;
  vo->y = v_y;
  vo->z = v_z;
}

/* vo = v - k e_x.
   v, vo: vector; k: number.
   1 add.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_add_vvxinv(const ksl_vec3_t *v, const double k, ksl_vec3_t *vo) {
  const double vo_0 = v->x - k;
  const double v_y = v->y;
  const double v_z = v->z;
  vo->x = vo_0;
  vo->y = v_y;
  vo->z = v_z;
}

/* vo = v + k e_y.
   v, vo: vector; k: number.
   1 add.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_add_vvy(const ksl_vec3_t *v, const double k, ksl_vec3_t *vo) {
  const double vo_1 = v->y + k;
  const double v_x = v->x;
  const double v_z = v->z;
  vo->x = v_x;
  vo->y = vo_1;
  vo->z = v_z;
}

/* vo = v - k e_y.
   v, vo: vector; k: number.
   1 add.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_add_vvyinv(const ksl_vec3_t *v, const double k, ksl_vec3_t *vo) {
  const double vo_1 = v->y - k;
  const double v_x = v->x;
  const double v_z = v->z;
  vo->x = v_x;
  vo->y = vo_1;
  vo->z = v_z;
}

/* vo = v + k e_z.
   v, vo: vector; k: number.
   1 add.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_add_vvz(const ksl_vec3_t *v, const double k, ksl_vec3_t *vo) {
  const double vo_2 = v->z + k;
  const double v_x = v->x;
  const double v_y = v->y;
  vo->x = v_x;
  vo->y = v_y;
  vo->z = vo_2;
}

/* vo = v - k e_z.
   v, vo: vector; k: number.
   1 add.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_add_vvzinv(const ksl_vec3_t *v, const double k, ksl_vec3_t *vo) {
  const double vo_2 = v->z - k;
  const double v_x = v->x;
  const double v_y = v->y;
  vo->x = v_x;
  vo->y = v_y;
  vo->z = vo_2;
}

/* The vec3 of these entries, in order. */
static inline ksl_vec3f_t ksl_vec3f(const float x, const float y, const float z) {
  ksl_vec3f_t value;
  value.x = x;
  value.y = y;
  value.z = z;
  return value;
}

/* vo = vi.
   vi, vo: vector.
   No arithmetic.
   Exact. */
static inline void ksl_vec3f_copy(const ksl_vec3f_t *vi, ksl_vec3f_t *vo) {
  const float vi_x = vi->x;
  const float vi_y = vi->y;
  const float vi_z = vi->z;
  vo->x = vi_x;
  vo->y = vi_y;
  vo->z = vi_z;
}

/* self = a self.
   self: vector; a: number.
   3 mul.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_vec3f_scale(ksl_vec3f_t *self, const float a) {
  const float self_0_new = KSL_MULF(self->x, a), self_1_new = KSL_MULF(self->y, a),
      self_2_new = KSL_MULF(self->z, a);
  self->x = self_0_new;
  self->y = self_1_new;
  self->z = self_2_new;
}

/* vo = -vi.
   vi, vo: vector.
   3 neg.
   Exact. */
static inline void ksl_vec3f_inverted(const ksl_vec3f_t *vi, ksl_vec3f_t *vo) {
  const float vo_0 = -vi->x, vo_1 = -vi->y, vo_2 = -vi->z;
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
}

/* self = -self.
   self: vector.
   3 neg.
   Exact. */
static inline void ksl_vec3f_invert(ksl_vec3f_t *self) {
  const float self_0_new = -self->x, self_1_new = -self->y, self_2_new = -self->z;
  self->x = self_0_new;
  self->y = self_1_new;
  self->z = self_2_new;
}

/* y = a x + y.
   a: number; x, y: vector.
   3 mul, 3 add.
   Error <= u |result| + 1 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_axpy_vvf(const float a, const ksl_vec3f_t *x, ksl_vec3f_t *y) {
  const float y_0_new = KSL_MULF(a, x->x) + y->x, y_1_new = KSL_MULF(a, x->y) + y->y,
      y_2_new = KSL_MULF(a, x->z) + y->z;
  y->x = y_0_new;
  y->y = y_1_new;
  y->z = y_2_new;
}

/* y = x + y.
   x, y: vector.
   3 add.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_xpy_vvf(const ksl_vec3f_t *x, ksl_vec3f_t *y) {
  const float y_0_new = x->x + y->x, y_1_new = x->y + y->y, y_2_new = x->z + y->z;
  y->x = y_0_new;
  y->y = y_1_new;
  y->z = y_2_new;
}

/* y = -x + y.
   x, y: vector.
   3 add.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_nxpy_vvf(const ksl_vec3f_t *x, ksl_vec3f_t *y) {
  const float y_0_new = y->x - x->x, y_1_new = y->y - x->y, y_2_new = y->z - x->z;
  y->x = y_0_new;
  y->y = y_1_new;
  y->z = y_2_new;
}

/* vo = a vi.
   a: number; vi, vo: vector.
   3 mul.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_product_avf(const float a, const ksl_vec3f_t *vi, ksl_vec3f_t *vo) {
  const float vo_0 = KSL_MULF(a, vi->x), vo_1 = KSL_MULF(a, vi->y), vo_2 = KSL_MULF(a, vi->z);
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
}

/* vo = v1 + v2.
   v1, v2, vo: vector.
   3 add.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_add_vvf(const ksl_vec3f_t *v1, const ksl_vec3f_t *v2, ksl_vec3f_t *vo) {
  const float vo_0 = v1->x + v2->x, vo_1 = v1->y + v2->y, vo_2 = v1->z + v2->z;
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
}

/* vo = v1 - v2.
   v1, v2, vo: vector.
   3 add.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_subtract_vvf(const ksl_vec3f_t *v1, const ksl_vec3f_t *v2, ksl_vec3f_t *vo) {
  const float vo_0 = v1->x - v2->x, vo_1 = v1->y - v2->y, vo_2 = v1->z - v2->z;
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
}

/* vo = k v.
   v, vo: vector; k: number.
   3 mul.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_vec3f_scaled(const ksl_vec3f_t *v, const float k, ksl_vec3f_t *vo) {
  const float vo_0 = KSL_MULF(v->x, k), vo_1 = KSL_MULF(v->y, k), vo_2 = KSL_MULF(v->z, k);
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
}

/* v1, v2 = v2, v1.
   v1, v2: vector.
   No arithmetic.
   Exact. */
static inline void ksl_vec3f_swap(ksl_vec3f_t *v1, ksl_vec3f_t *v2) {
  const float v2_x = v2->x;
  const float v2_y = v2->y;
  const float v2_z = v2->z;
  const float v1_x = v1->x;
  const float v1_y = v1->y;
  const float v1_z = v1->z;
  v1->x = v2_x;
  v1->y = v2_y;
  v1->z = v2_z;
  v2->x = v1_x;
  v2->y = v1_y;
  v2->z = v1_z;
}

/* |v| = sqrt(v·v).
   v: vector.
   7 mul, 2 add, 1 sqrt, 3 abs, 8 less, 8 select. */
static inline float ksl_vec3f_l2norm(const ksl_vec3f_t *v) {
  const float s_size_0 = fabsf(v->x), s_size_1 = fabsf(v->y), s_size_2 = fabsf(v->z);
  const float s_largest1 = s_size_0 < s_size_1 ? s_size_1 : s_size_0;
  const float s_largest2 = s_largest1 < s_size_2 ? s_size_2 : s_largest1;
  const float s_b = 4.611686e+18f < s_largest2 ? 2.7105054e-20f : 1.0f,
      s_d = s_largest2 < 256.0f ? 1.8014399e+16f : s_b,
      s = s_largest2 < 1.4210855e-14f ? 3.2451855e+32f : s_d;
  const float y_0 = KSL_MULF(v->x, s), y_1 = KSL_MULF(v->y, s), y_2 = KSL_MULF(v->z, s);
  const float n = sqrtf(KSL_MULF(y_0, y_0) + KSL_MULF(y_1, y_1) + KSL_MULF(y_2, y_2));
  const float r_b = s < 1.0f ? 3.689349e+19f : 1.0f, r_d = 1.0f < s ? 5.551115e-17f : r_b,
      r = 1.8014399e+16f < s ? 3.081488e-33f : r_d;
  const float norm = KSL_MULF(n, r);
  return norm;
}

/* self = self / |self|; the zero vector stays zero.
   self: vector.
   12 mul, 2 add, 3 div, 1 sqrt, 3 abs, 7 less, 1 equal, 8 select. */
static inline void ksl_vec3f_normalize(ksl_vec3f_t *self) {
  const float s_size_0 = fabsf(self->x), s_size_1 = fabsf(self->y), s_size_2 = fabsf(self->z);
  const float s_largest1 = s_size_0 < s_size_1 ? s_size_1 : s_size_0;
  const float s_largest2 = s_largest1 < s_size_2 ? s_size_2 : s_largest1;
  const float s_b = 4.611686e+18f < s_largest2 ? 2.7105054e-20f : 1.0f,
      s_d = s_largest2 < 256.0f ? 1.8014399e+16f : s_b,
      s = s_largest2 < 1.4210855e-14f ? 3.2451855e+32f : s_d;
  const float y_0 = KSL_MULF(self->x, s), y_1 = KSL_MULF(self->y, s), y_2 = KSL_MULF(self->z, s);
  const float up = 1.0f < s ? s : 1.0f;
  const float down = s < 1.0f ? s : 1.0f;
  const float n = sqrtf(KSL_MULF(y_0, y_0) + KSL_MULF(y_1, y_1) + KSL_MULF(y_2, y_2));
  const float divisor = n == 0.0f ? up : n;
  const float sized_0 = KSL_MULF(self->x, up), sized_1 = KSL_MULF(self->y, up),
      sized_2 = KSL_MULF(self->z, up);
  const float quotient_0 = sized_0 / divisor, quotient_1 = sized_1 / divisor,
      quotient_2 = sized_2 / divisor;
  const float self_0_new = KSL_MULF(quotient_0, down), self_1_new = KSL_MULF(quotient_1, down),
      self_2_new = KSL_MULF(quotient_2, down);
  self->x = self_0_new;
  self->y = self_1_new;
  self->z = self_2_new;
}

/* vo = v / |v|; the zero vector stays zero.
   v, vo: vector.
   12 mul, 2 add, 3 div, 1 sqrt, 3 abs, 7 less, 1 equal, 8 select. */
static inline void ksl_vec3f_normalized(const ksl_vec3f_t *v, ksl_vec3f_t *vo) {
  const float s_size_0 = fabsf(v->x), s_size_1 = fabsf(v->y), s_size_2 = fabsf(v->z);
  const float s_largest1 = s_size_0 < s_size_1 ? s_size_1 : s_size_0;
  const float s_largest2 = s_largest1 < s_size_2 ? s_size_2 : s_largest1;
  const float s_b = 4.611686e+18f < s_largest2 ? 2.7105054e-20f : 1.0f,
      s_d = s_largest2 < 256.0f ? 1.8014399e+16f : s_b,
      s = s_largest2 < 1.4210855e-14f ? 3.2451855e+32f : s_d;
  const float y_0 = KSL_MULF(v->x, s), y_1 = KSL_MULF(v->y, s), y_2 = KSL_MULF(v->z, s);
  const float up = 1.0f < s ? s : 1.0f;
  const float down = s < 1.0f ? s : 1.0f;
  const float n = sqrtf(KSL_MULF(y_0, y_0) + KSL_MULF(y_1, y_1) + KSL_MULF(y_2, y_2));
  const float divisor = n == 0.0f ? up : n;
  const float sized_0 = KSL_MULF(v->x, up), sized_1 = KSL_MULF(v->y, up),
      sized_2 = KSL_MULF(v->z, up);
  const float quotient_0 = sized_0 / divisor, quotient_1 = sized_1 / divisor,
      quotient_2 = sized_2 / divisor;
  const float vo_0 = KSL_MULF(quotient_0, down), vo_1 = KSL_MULF(quotient_1, down),
      vo_2 = KSL_MULF(quotient_2, down);
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
}

/* angle = atan2(|v1 × v2|, v1·v2), in [0, π].
   v1, v2: vector.
   44 mul, 36 add, 1 div, 1 sqrt, 1 neg, 11 abs, 2 copysign, 24 less, 1 equal, 32 select. */
static inline float ksl_angle_vvf(const ksl_vec3f_t *v1, const ksl_vec3f_t *v2) {
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
  const float c_0 = KSL_MULF(scaled_s1_1, scaled_s2_2) - KSL_MULF(scaled_s1_2, scaled_s2_1),
      c_1 = KSL_MULF(scaled_s1_2, scaled_s2_0) - KSL_MULF(scaled_s1_0, scaled_s2_2),
      c_2 = KSL_MULF(scaled_s1_0, scaled_s2_1) - KSL_MULF(scaled_s1_1, scaled_s2_0);
  const float s_size_0 = fabsf(c_0), s_size_1 = fabsf(c_1), s_size_2 = fabsf(c_2);
  const float s_largest1 = s_size_0 < s_size_1 ? s_size_1 : s_size_0;
  const float s_largest2 = s_largest1 < s_size_2 ? s_size_2 : s_largest1;
  const float s_b = 4.611686e+18f < s_largest2 ? 2.7105054e-20f : 1.0f,
      s_d = s_largest2 < 256.0f ? 1.8014399e+16f : s_b,
      s = s_largest2 < 1.4210855e-14f ? 3.2451855e+32f : s_d;
  const float y_0 = KSL_MULF(c_0, s), y_1 = KSL_MULF(c_1, s), y_2 = KSL_MULF(c_2, s);
  const float n = sqrtf(KSL_MULF(y_0, y_0) + KSL_MULF(y_1, y_1) + KSL_MULF(y_2, y_2));
  const float r_b = s < 1.0f ? 3.689349e+19f : 1.0f, r_d = 1.0f < s ? 5.551115e-17f : r_b,
      r = 1.8014399e+16f < s ? 3.081488e-33f : r_d;
  const float cross = KSL_MULF(n, r);
  const float dot_ = KSL_MULF(scaled_s1_0, scaled_s2_0) + KSL_MULF(scaled_s1_1, scaled_s2_1)
          + KSL_MULF(scaled_s1_2, scaled_s2_2);
  const float angle = ksl_atan2f(cross, dot_);
  return angle;
}

/* v1·v2.
   v1, v2: vector.
   3 mul, 2 add.
   Error <= u |result| + 2 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline float ksl_dot_vvf(const ksl_vec3f_t *v1, const ksl_vec3f_t *v2) {
  const float dot = KSL_MULF(v1->x, v2->x) + KSL_MULF(v1->y, v2->y) + KSL_MULF(v1->z, v2->z);
  return dot;
}

/* vo = k (-v).
   k: number; v, vo: vector.
   3 mul, 3 neg.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_product_avinvf(const float k, const ksl_vec3f_t *v, ksl_vec3f_t *vo) {
  const float vo_0 = -KSL_MULF(k, v->x), vo_1 = -KSL_MULF(k, v->y), vo_2 = -KSL_MULF(k, v->z);
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
}

/* vo = v / k.
   k: number; v, vo: vector.
   3 div. */
static inline void ksl_product_ainvvf(const float k, const ksl_vec3f_t *v, ksl_vec3f_t *vo) {
  const float vo_0 = v->x / k, vo_1 = v->y / k, vo_2 = v->z / k;
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
}

/* vo = v1 × v2.  Exactly zero for v1 = v2, unless products overflow.
   v1, v2, vo: vector.
   6 mul, 3 add.
   Error <= u |result| + 1 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_cross_vvf(const ksl_vec3f_t *v1, const ksl_vec3f_t *v2, ksl_vec3f_t *vo) {
  const float vo_0 = KSL_MULF(v1->y, v2->z) - KSL_MULF(v1->z, v2->y),
      vo_1 = KSL_MULF(v1->z, v2->x) - KSL_MULF(v1->x, v2->z),
      vo_2 = KSL_MULF(v1->x, v2->y) - KSL_MULF(v1->y, v2->x);
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
}

/* vo = v1 × (-v2).
   v1, v2, vo: vector.
   6 mul, 3 add.
   Error <= u |result| + 1 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_cross_vvinvf(const ksl_vec3f_t *v1, const ksl_vec3f_t *v2, ksl_vec3f_t *vo) {
  const float vo_0 = KSL_MULF(v1->z, v2->y) - KSL_MULF(v1->y, v2->z),
      vo_1 = KSL_MULF(v1->x, v2->z) - KSL_MULF(v1->z, v2->x),
      vo_2 = KSL_MULF(v1->y, v2->x) - KSL_MULF(v1->x, v2->y);
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
}

/* vo = v + k e_x.
   v, vo: vector; k: number.
   1 add.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_add_vvxf(const ksl_vec3f_t *v, const float k, ksl_vec3f_t *vo) {
  const float vo_0 = v->x + k;
  const float v_y = v->y;
  const float v_z = v->z;
  vo->x = vo_0;
  vo->y = v_y;
  vo->z = v_z;
}

/* vo = v - k e_x.
   v, vo: vector; k: number.
   1 add.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_add_vvxinvf(const ksl_vec3f_t *v, const float k, ksl_vec3f_t *vo) {
  const float vo_0 = v->x - k;
  const float v_y = v->y;
  const float v_z = v->z;
  vo->x = vo_0;
  vo->y = v_y;
  vo->z = v_z;
}

/* vo = v + k e_y.
   v, vo: vector; k: number.
   1 add.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_add_vvyf(const ksl_vec3f_t *v, const float k, ksl_vec3f_t *vo) {
  const float vo_1 = v->y + k;
  const float v_x = v->x;
  const float v_z = v->z;
  vo->x = v_x;
  vo->y = vo_1;
  vo->z = v_z;
}

/* vo = v - k e_y.
   v, vo: vector; k: number.
   1 add.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_add_vvyinvf(const ksl_vec3f_t *v, const float k, ksl_vec3f_t *vo) {
  const float vo_1 = v->y - k;
  const float v_x = v->x;
  const float v_z = v->z;
  vo->x = v_x;
  vo->y = vo_1;
  vo->z = v_z;
}

/* vo = v + k e_z.
   v, vo: vector; k: number.
   1 add.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_add_vvzf(const ksl_vec3f_t *v, const float k, ksl_vec3f_t *vo) {
  const float vo_2 = v->z + k;
  const float v_x = v->x;
  const float v_y = v->y;
  vo->x = v_x;
  vo->y = v_y;
  vo->z = vo_2;
}

/* vo = v - k e_z.
   v, vo: vector; k: number.
   1 add.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_add_vvzinvf(const ksl_vec3f_t *v, const float k, ksl_vec3f_t *vo) {
  const float vo_2 = v->z - k;
  const float v_x = v->x;
  const float v_y = v->y;
  vo->x = v_x;
  vo->y = v_y;
  vo->z = vo_2;
}

#ifndef KSL_NO_ALLOC
#include <stdlib.h>

/* n ksl_vec3_t on the heap, zeros, to be freed by the caller; NULL for n <= 0 or when there is
     no memory. */
static inline ksl_vec3_t *ksl_vec3_alloc(int n) {
  return n > 0 ? (ksl_vec3_t *)calloc((size_t)n, sizeof(ksl_vec3_t)) : NULL;
}

/* n ksl_vec3f_t on the heap, zeros, to be freed by the caller; NULL for n <= 0 or when there is
     no memory. */
static inline ksl_vec3f_t *ksl_vec3f_alloc(int n) {
  return n > 0 ? (ksl_vec3f_t *)calloc((size_t)n, sizeof(ksl_vec3f_t)) : NULL;
}

#endif

/* What KSL declares beside formulas. */


/* The vec3 of these entries, in order. */
static inline ksl_vec3i_t ksl_vec3i(const int x, const int y, const int z) {
  ksl_vec3i_t value;
  value.x = x;
  value.y = y;
  value.z = z;
  return value;
}

/* Whether all components are equal. */
static inline bool ksl_vec3i_isEqual(const ksl_vec3i_t *v1, const ksl_vec3i_t *v2) {
  return v1->x == v2->x && v1->y == v2->y && v1->z == v2->z;
}

#ifndef KSL_NO_ALLOC
#include <stdlib.h>

/* n ksl_vec3i_t on the heap, zeros, to be freed by the caller; NULL for n <= 0 or when there is
     no memory. */
static inline ksl_vec3i_t *ksl_vec3i_alloc(int n) {
  return n > 0 ? (ksl_vec3i_t *)calloc((size_t)n, sizeof(ksl_vec3i_t)) : NULL;
}

#endif

#endif
