/* Made by `coscrew generate`; changes are overwritten. */
/* SPDX-License-Identifier: MIT */
/* coscrew 0.2.0.  Copyright (c) 2026 The coscrew authors. */
/* Quaternions q = (v; w), the scalar last: products, rotations, conversions, interpolation. */
#ifndef KSL_QUATERNION_H
#define KSL_QUATERNION_H

#include <stdbool.h>
#include "ksl_types.h"
#include "elementary.h"
#include "mat3x3.h"

/* The quaternion of these entries, in order. */
static inline ksl_quaternion_t ksl_quaternion(const double x, const double y, const double z,
    const double w) {
  ksl_quaternion_t value;
  value.x = x;
  value.y = y;
  value.z = z;
  value.w = w;
  return value;
}

/* qo = qi.
   qi, qo: quaternion (x, y, z, w), the scalar last.
   No arithmetic.
   Exact. */
static inline void ksl_quaternion_copy(const ksl_quaternion_t *qi, ksl_quaternion_t *qo) {
  const double qi_x = qi->x;
  const double qi_y = qi->y;
  const double qi_z = qi->z;
  const double qi_w = qi->w;
  qo->x = qi_x;
  qo->y = qi_y;
  qo->z = qi_z;
  qo->w = qi_w;
}

/* self = a self.
   self: quaternion (x, y, z, w), the scalar last; a: number.
   4 mul.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_quaternion_scale(ksl_quaternion_t *self, const double a) {
  const double self_0_new = KSL_MUL(self->x, a), self_1_new = KSL_MUL(self->y, a),
      self_2_new = KSL_MUL(self->z, a), self_3_new = KSL_MUL(self->w, a);
  self->x = self_0_new;
  self->y = self_1_new;
  self->z = self_2_new;
  self->w = self_3_new;
}

/* y = a x + y.
   a: number; x, y: quaternion (x, y, z, w), the scalar last.
   4 mul, 4 add.
   Error <= u |result| + 1 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_axpy_qq(const double a, const ksl_quaternion_t *x, ksl_quaternion_t *y) {
  const double y_0_new = KSL_MUL(a, x->x) + y->x, y_1_new = KSL_MUL(a, x->y) + y->y,
      y_2_new = KSL_MUL(a, x->z) + y->z, y_3_new = KSL_MUL(a, x->w) + y->w;
  y->x = y_0_new;
  y->y = y_1_new;
  y->z = y_2_new;
  y->w = y_3_new;
}

/* self = (0; 1).
   self: quaternion (x, y, z, w), the scalar last.
   No arithmetic.
   Exact. */
static inline void ksl_quaternion_setIdentity(ksl_quaternion_t *self) {
  self->x = 0.0;
  self->y = 0.0;
  self->z = 0.0;
  self->w = 1.0;
}

/* qo = (-v; w), the inverse of q if |q| = 1.
   q, qo: quaternion (x, y, z, w), the scalar last.
   3 neg.
   Exact. */
static inline void ksl_quaternion_conjugated(const ksl_quaternion_t *q, ksl_quaternion_t *qo) {
  const double qo_0 = -q->x, qo_1 = -q->y, qo_2 = -q->z;
  const double q_w = q->w;
  qo->x = qo_0;
  qo->y = qo_1;
  qo->z = qo_2;
  qo->w = q_w;
}

/* |q| = sqrt(v·v + w^2).
   q: quaternion (x, y, z, w), the scalar last.
   9 mul, 3 add, 1 sqrt, 4 abs, 9 less, 9 select. */
static inline double ksl_quaternion_norm(const ksl_quaternion_t *q) {
  const double s_size_0 = fabs(q->x), s_size_1 = fabs(q->y), s_size_2 = fabs(q->z),
      s_size_3 = fabs(q->w);
  const double s_largest1 = s_size_0 < s_size_1 ? s_size_1 : s_size_0;
  const double s_largest2 = s_largest1 < s_size_2 ? s_size_2 : s_largest1;
  const double s_largest3 = s_largest2 < s_size_3 ? s_size_3 : s_largest2;
  const double s_b = 6.703903964971299e+153 < s_largest3 ? 3.7291703656001034e-155 : 1.0,
      s_d = s_largest3 < 256.0 ? 1.3093562431584567e+151 : s_b,
      s = s_largest3 < 1.955159272639747e-149 ? 1.0715086071862673e+301 : s_d;
  const double y_0 = KSL_MUL(q->x, s), y_1 = KSL_MUL(q->y, s), y_2 = KSL_MUL(q->z, s),
      y_3 = KSL_MUL(q->w, s);
  const double n = sqrt(KSL_MUL(y_0, y_0) + KSL_MUL(y_1, y_1) + KSL_MUL(y_2, y_2)
          + KSL_MUL(y_3, y_3));
  const double r_b = s < 1.0 ? 2.6815615859885194e+154 : 1.0,
      r_d = 1.0 < s ? 7.637340908749012e-152 : r_b,
      r = 1.3093562431584567e+151 < s ? 9.332636185032189e-302 : r_d;
  const double norm = KSL_MUL(n, r);
  return norm;
}

/* self = self / |self|; zero stays zero.
   self: quaternion (x, y, z, w), the scalar last.
   16 mul, 3 add, 4 div, 1 sqrt, 4 abs, 8 less, 1 equal, 9 select. */
static inline void ksl_quaternion_normalize(ksl_quaternion_t *self) {
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

/* qo = q / |q|; zero stays zero.
   q, qo: quaternion (x, y, z, w), the scalar last.
   16 mul, 3 add, 4 div, 1 sqrt, 4 abs, 8 less, 1 equal, 9 select. */
static inline void ksl_quaternion_normalized(const ksl_quaternion_t *q, ksl_quaternion_t *qo) {
  const double s_size_0 = fabs(q->x), s_size_1 = fabs(q->y), s_size_2 = fabs(q->z),
      s_size_3 = fabs(q->w);
  const double s_largest1 = s_size_0 < s_size_1 ? s_size_1 : s_size_0;
  const double s_largest2 = s_largest1 < s_size_2 ? s_size_2 : s_largest1;
  const double s_largest3 = s_largest2 < s_size_3 ? s_size_3 : s_largest2;
  const double s_b = 6.703903964971299e+153 < s_largest3 ? 3.7291703656001034e-155 : 1.0,
      s_d = s_largest3 < 256.0 ? 1.3093562431584567e+151 : s_b,
      s = s_largest3 < 1.955159272639747e-149 ? 1.0715086071862673e+301 : s_d;
  const double y_0 = KSL_MUL(q->x, s), y_1 = KSL_MUL(q->y, s), y_2 = KSL_MUL(q->z, s),
      y_3 = KSL_MUL(q->w, s);
  const double up = 1.0 < s ? s : 1.0;
  const double down = s < 1.0 ? s : 1.0;
  const double n = sqrt(KSL_MUL(y_0, y_0) + KSL_MUL(y_1, y_1) + KSL_MUL(y_2, y_2)
          + KSL_MUL(y_3, y_3));
  const double divisor = n == 0.0 ? up : n;
  const double sized_0 = KSL_MUL(q->x, up), sized_1 = KSL_MUL(q->y, up),
      sized_2 = KSL_MUL(q->z, up), sized_3 = KSL_MUL(q->w, up);
  const double quotient_0 = sized_0 / divisor, quotient_1 = sized_1 / divisor,
      quotient_2 = sized_2 / divisor, quotient_3 = sized_3 / divisor;
  const double qo_0 = KSL_MUL(quotient_0, down), qo_1 = KSL_MUL(quotient_1, down),
      qo_2 = KSL_MUL(quotient_2, down), qo_3 = KSL_MUL(quotient_3, down);
  qo->x = qo_0;
  qo->y = qo_1;
  qo->z = qo_2;
  qo->w = qo_3;
}

/* |q| - 1: 0 for a unit quaternion, negative for a shorter one.
   q: quaternion (x, y, z, w), the scalar last.
   9 mul, 4 add, 1 sqrt, 4 abs, 9 less, 9 select. */
static inline double ksl_quaternion_unit_defect(const ksl_quaternion_t *q) {
  const double s_size_0 = fabs(q->x), s_size_1 = fabs(q->y), s_size_2 = fabs(q->z),
      s_size_3 = fabs(q->w);
  const double s_largest1 = s_size_0 < s_size_1 ? s_size_1 : s_size_0;
  const double s_largest2 = s_largest1 < s_size_2 ? s_size_2 : s_largest1;
  const double s_largest3 = s_largest2 < s_size_3 ? s_size_3 : s_largest2;
  const double s_b = 6.703903964971299e+153 < s_largest3 ? 3.7291703656001034e-155 : 1.0,
      s_d = s_largest3 < 256.0 ? 1.3093562431584567e+151 : s_b,
      s = s_largest3 < 1.955159272639747e-149 ? 1.0715086071862673e+301 : s_d;
  const double y_0 = KSL_MUL(q->x, s), y_1 = KSL_MUL(q->y, s), y_2 = KSL_MUL(q->z, s),
      y_3 = KSL_MUL(q->w, s);
  const double n = sqrt(KSL_MUL(y_0, y_0) + KSL_MUL(y_1, y_1) + KSL_MUL(y_2, y_2)
          + KSL_MUL(y_3, y_3));
  const double r_b = s < 1.0 ? 2.6815615859885194e+154 : 1.0,
      r_d = 1.0 < s ? 7.637340908749012e-152 : r_b,
      r = 1.3093562431584567e+151 < s ? 9.332636185032189e-302 : r_d;
  const double length = KSL_MUL(n, r);
  const double defect = length - 1.0;
  return defect;
}

/* qo = q / |q|, the unit quaternion nearest to q; NaN for zero, which has none.
   q, qo: quaternion (x, y, z, w), the scalar last.
   8 mul, 3 add, 4 div, 1 sqrt, 4 abs, 6 less, 1 equal, 11 select. */
static inline void ksl_quaternion_nearest_unit(const ksl_quaternion_t *q, ksl_quaternion_t *qo) {
  const double s_size_0 = fabs(q->x), s_size_1 = fabs(q->y), s_size_2 = fabs(q->z),
      s_size_3 = fabs(q->w);
  const double s_largest1 = s_size_0 < s_size_1 ? s_size_1 : s_size_0;
  const double s_largest2 = s_largest1 < s_size_2 ? s_size_2 : s_largest1;
  const double s_largest3 = s_largest2 < s_size_3 ? s_size_3 : s_largest2;
  const double s_b = 6.703903964971299e+153 < s_largest3 ? 3.7291703656001034e-155 : 1.0,
      s_d = s_largest3 < 256.0 ? 1.3093562431584567e+151 : s_b,
      s = s_largest3 < 1.955159272639747e-149 ? 1.0715086071862673e+301 : s_d;
  const double scaled_s_0 = KSL_MUL(q->x, s), scaled_s_1 = KSL_MUL(q->y, s),
      scaled_s_2 = KSL_MUL(q->z, s), scaled_s_3 = KSL_MUL(q->w, s);
  const double n = sqrt(KSL_MUL(scaled_s_0, scaled_s_0) + KSL_MUL(scaled_s_1, scaled_s_1)
          + KSL_MUL(scaled_s_2, scaled_s_2) + KSL_MUL(scaled_s_3, scaled_s_3));
  const double divisor = n == 0.0 ? 1.0 : n;
  const double unit_0 = scaled_s_0 / divisor, unit_1 = scaled_s_1 / divisor,
      unit_2 = scaled_s_2 / divisor, unit_3 = scaled_s_3 / divisor;
  const double qo_0 = n == 0.0 ? (double)NAN : unit_0, qo_1 = n == 0.0 ? (double)NAN : unit_1,
      qo_2 = n == 0.0 ? (double)NAN : unit_2, qo_3 = n == 0.0 ? (double)NAN : unit_3;
  qo->x = qo_0;
  qo->y = qo_1;
  qo->z = qo_2;
  qo->w = qo_3;
}

/* vo = R(q) v, |q| = 1.
   q: quaternion (x, y, z, w), the scalar last; v, vo: vector.
   18 mul, 12 add.
   Error <= u |result| + 5 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_rotate_qv(const ksl_quaternion_t *q, const ksl_vec3_t *v, ksl_vec3_t *vo) {
  const double c_0 = KSL_MUL(q->y, v->z) - KSL_MUL(q->z, v->y),
      c_1 = KSL_MUL(q->z, v->x) - KSL_MUL(q->x, v->z),
      c_2 = KSL_MUL(q->x, v->y) - KSL_MUL(q->y, v->x);
  const double t_0 = KSL_MUL(2.0, c_0), t_1 = KSL_MUL(2.0, c_1), t_2 = KSL_MUL(2.0, c_2);
  const double turn_0 = KSL_MUL(q->y, t_2) - KSL_MUL(q->z, t_1) + KSL_MUL(q->w, t_0),
      turn_1 = KSL_MUL(q->z, t_0) - KSL_MUL(q->x, t_2) + KSL_MUL(q->w, t_1),
      turn_2 = KSL_MUL(q->x, t_1) - KSL_MUL(q->y, t_0) + KSL_MUL(q->w, t_2);
  const double vo_0 = v->x + turn_0, vo_1 = v->y + turn_1, vo_2 = v->z + turn_2;
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
}

/* vo = R(q)^T v, |q| = 1.
   q: quaternion (x, y, z, w), the scalar last; v, vo: vector.
   18 mul, 12 add.
   Error <= u |result| + 5 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_rotate_qconjv(const ksl_quaternion_t *q, const ksl_vec3_t *v,
    ksl_vec3_t *vo) {
  const double c_0 = KSL_MUL(q->z, v->y) - KSL_MUL(q->y, v->z),
      c_1 = KSL_MUL(q->x, v->z) - KSL_MUL(q->z, v->x),
      c_2 = KSL_MUL(q->y, v->x) - KSL_MUL(q->x, v->y);
  const double t_0 = KSL_MUL(2.0, c_0), t_1 = KSL_MUL(2.0, c_1), t_2 = KSL_MUL(2.0, c_2);
  const double turn_0 = KSL_MUL(q->z, t_1) - KSL_MUL(q->y, t_2) + KSL_MUL(q->w, t_0),
      turn_1 = KSL_MUL(q->x, t_2) - KSL_MUL(q->z, t_0) + KSL_MUL(q->w, t_1),
      turn_2 = KSL_MUL(q->y, t_0) - KSL_MUL(q->x, t_1) + KSL_MUL(q->w, t_2);
  const double vo_0 = v->x + turn_0, vo_1 = v->y + turn_1, vo_2 = v->z + turn_2;
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
}

/* qo = q1i q2i.
   q1i, q2i, qo: quaternion (x, y, z, w), the scalar last.
   16 mul, 12 add.
   Error <= u |result| + 3 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_quaternion_product_qq(const ksl_quaternion_t *q1i,
    const ksl_quaternion_t *q2i, ksl_quaternion_t *qo) {
  const double qo_0 = KSL_MUL(q1i->x, q2i->w) + (KSL_MUL(q1i->y, q2i->z) - KSL_MUL(q1i->z, q2i->y))
          + KSL_MUL(q1i->w, q2i->x),
      qo_1 = KSL_MUL(q1i->z, q2i->x) - KSL_MUL(q1i->x, q2i->z) + KSL_MUL(q1i->y, q2i->w)
          + KSL_MUL(q1i->w, q2i->y),
      qo_2 = KSL_MUL(q1i->x, q2i->y) - KSL_MUL(q1i->y, q2i->x) + KSL_MUL(q1i->z, q2i->w)
          + KSL_MUL(q1i->w, q2i->z),
      qo_3 = KSL_MUL(q1i->w, q2i->w)
          - (KSL_MUL(q1i->x, q2i->x) + KSL_MUL(q1i->y, q2i->y) + KSL_MUL(q1i->z, q2i->z));
  qo->x = qo_0;
  qo->y = qo_1;
  qo->z = qo_2;
  qo->w = qo_3;
}

/* qo = q1i q2i*.
   q1i, q2i, qo: quaternion (x, y, z, w), the scalar last.
   16 mul, 12 add.
   Error <= u |result| + (v: 2, w: 3) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_quaternion_product_qqconj(const ksl_quaternion_t *q1i,
    const ksl_quaternion_t *q2i, ksl_quaternion_t *qo) {
  const double qo_0 = KSL_MUL(q1i->x, q2i->w) - KSL_MUL(q1i->w, q2i->x)
          + (KSL_MUL(q1i->z, q2i->y) - KSL_MUL(q1i->y, q2i->z)),
      qo_1 = KSL_MUL(q1i->x, q2i->z) - KSL_MUL(q1i->z, q2i->x)
          + (KSL_MUL(q1i->y, q2i->w) - KSL_MUL(q1i->w, q2i->y)),
      qo_2 = KSL_MUL(q1i->y, q2i->x) - KSL_MUL(q1i->x, q2i->y)
          + (KSL_MUL(q1i->z, q2i->w) - KSL_MUL(q1i->w, q2i->z)),
      qo_3 = KSL_MUL(q1i->x, q2i->x) + KSL_MUL(q1i->y, q2i->y) + KSL_MUL(q1i->z, q2i->z)
          + KSL_MUL(q1i->w, q2i->w);
  qo->x = qo_0;
  qo->y = qo_1;
  qo->z = qo_2;
  qo->w = qo_3;
}

/* qo = q1i* q2i.
   q1i, q2i, qo: quaternion (x, y, z, w), the scalar last.
   16 mul, 12 add.
   Error <= u |result| + (v: 2, w: 3) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_quaternion_product_qconjq(const ksl_quaternion_t *q1i,
    const ksl_quaternion_t *q2i, ksl_quaternion_t *qo) {
  const double qo_0 = KSL_MUL(q1i->w, q2i->x) - KSL_MUL(q1i->x, q2i->w)
          + (KSL_MUL(q1i->z, q2i->y) - KSL_MUL(q1i->y, q2i->z)),
      qo_1 = KSL_MUL(q1i->x, q2i->z) - KSL_MUL(q1i->z, q2i->x)
          + (KSL_MUL(q1i->w, q2i->y) - KSL_MUL(q1i->y, q2i->w)),
      qo_2 = KSL_MUL(q1i->y, q2i->x) - KSL_MUL(q1i->x, q2i->y)
          + (KSL_MUL(q1i->w, q2i->z) - KSL_MUL(q1i->z, q2i->w)),
      qo_3 = KSL_MUL(q1i->x, q2i->x) + KSL_MUL(q1i->y, q2i->y) + KSL_MUL(q1i->z, q2i->z)
          + KSL_MUL(q1i->w, q2i->w);
  qo->x = qo_0;
  qo->y = qo_1;
  qo->z = qo_2;
  qo->w = qo_3;
}

/* qo = q1i* q2i*.
   q1i, q2i, qo: quaternion (x, y, z, w), the scalar last.
   16 mul, 12 add.
   Error <= u |result| + 3 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_quaternion_product_qconjqconj(const ksl_quaternion_t *q1i,
    const ksl_quaternion_t *q2i, ksl_quaternion_t *qo) {
  const double qo_0 = KSL_MUL(q1i->y, q2i->z) - KSL_MUL(q1i->z, q2i->y) - KSL_MUL(q1i->x, q2i->w)
          - KSL_MUL(q1i->w, q2i->x),
      qo_1 = KSL_MUL(q1i->z, q2i->x) - KSL_MUL(q1i->x, q2i->z) - KSL_MUL(q1i->y, q2i->w)
          - KSL_MUL(q1i->w, q2i->y),
      qo_2 = KSL_MUL(q1i->x, q2i->y) - KSL_MUL(q1i->y, q2i->x) - KSL_MUL(q1i->z, q2i->w)
          - KSL_MUL(q1i->w, q2i->z),
      qo_3 = KSL_MUL(q1i->w, q2i->w)
          - (KSL_MUL(q1i->x, q2i->x) + KSL_MUL(q1i->y, q2i->y) + KSL_MUL(q1i->z, q2i->z));
  qo->x = qo_0;
  qo->y = qo_1;
  qo->z = qo_2;
  qo->w = qo_3;
}

/* qo = (s e_x; c) qi, dci = (s, c), sine and cosine of half the angle.
   dci: (sin θ, cos θ); qi, qo: quaternion (x, y, z, w), the scalar last.
   8 mul, 4 add.
   Error <= u |result| + 1 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_quaternion_product_qxq(const double dci[2], const ksl_quaternion_t *qi,
    ksl_quaternion_t *qo) {
  const double qo_0 = KSL_MUL(dci[0], qi->w) + KSL_MUL(dci[1], qi->x),
      qo_1 = KSL_MUL(dci[1], qi->y) - KSL_MUL(dci[0], qi->z),
      qo_2 = KSL_MUL(dci[0], qi->y) + KSL_MUL(dci[1], qi->z),
      qo_3 = KSL_MUL(dci[1], qi->w) - KSL_MUL(dci[0], qi->x);
  qo->x = qo_0;
  qo->y = qo_1;
  qo->z = qo_2;
  qo->w = qo_3;
}

/* qo = (s e_x; c) qi*, dci = (s, c), sine and cosine of half the angle.
   dci: (sin θ, cos θ); qi, qo: quaternion (x, y, z, w), the scalar last.
   8 mul, 4 add, 1 neg.
   Error <= u |result| + 1 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_quaternion_product_qxqconj(const double dci[2], const ksl_quaternion_t *qi,
    ksl_quaternion_t *qo) {
  const double qo_0 = KSL_MUL(dci[0], qi->w) - KSL_MUL(dci[1], qi->x),
      qo_1 = KSL_MUL(dci[0], qi->z) - KSL_MUL(dci[1], qi->y),
      qo_2 = -(KSL_MUL(dci[0], qi->y) + KSL_MUL(dci[1], qi->z)),
      qo_3 = KSL_MUL(dci[0], qi->x) + KSL_MUL(dci[1], qi->w);
  qo->x = qo_0;
  qo->y = qo_1;
  qo->z = qo_2;
  qo->w = qo_3;
}

/* qo = (s e_x; c)* qi, dci = (s, c), sine and cosine of half the angle.
   dci: (sin θ, cos θ); qi, qo: quaternion (x, y, z, w), the scalar last.
   8 mul, 4 add.
   Error <= u |result| + 1 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_quaternion_product_qxconjq(const double dci[2], const ksl_quaternion_t *qi,
    ksl_quaternion_t *qo) {
  const double qo_0 = KSL_MUL(dci[1], qi->x) - KSL_MUL(dci[0], qi->w),
      qo_1 = KSL_MUL(dci[0], qi->z) + KSL_MUL(dci[1], qi->y),
      qo_2 = KSL_MUL(dci[1], qi->z) - KSL_MUL(dci[0], qi->y),
      qo_3 = KSL_MUL(dci[0], qi->x) + KSL_MUL(dci[1], qi->w);
  qo->x = qo_0;
  qo->y = qo_1;
  qo->z = qo_2;
  qo->w = qo_3;
}

/* qo = (s e_x; c)* qi*, dci = (s, c), sine and cosine of half the angle.
   dci: (sin θ, cos θ); qi, qo: quaternion (x, y, z, w), the scalar last.
   8 mul, 4 add, 2 neg.
   Error <= u |result| + 1 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_quaternion_product_qxconjqconj(const double dci[2],
    const ksl_quaternion_t *qi, ksl_quaternion_t *qo) {
  const double qo_0 = -(KSL_MUL(dci[0], qi->w) + KSL_MUL(dci[1], qi->x)),
      qo_1 = -(KSL_MUL(dci[0], qi->z) + KSL_MUL(dci[1], qi->y)),
      qo_2 = KSL_MUL(dci[0], qi->y) - KSL_MUL(dci[1], qi->z),
      qo_3 = KSL_MUL(dci[1], qi->w) - KSL_MUL(dci[0], qi->x);
  qo->x = qo_0;
  qo->y = qo_1;
  qo->z = qo_2;
  qo->w = qo_3;
}

/* qo = qi (s e_x; c), dci = (s, c), sine and cosine of half the angle.
   qi, qo: quaternion (x, y, z, w), the scalar last; dci: (sin θ, cos θ).
   8 mul, 4 add.
   Error <= u |result| + 1 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_quaternion_product_qqx(const ksl_quaternion_t *qi, const double dci[2],
    ksl_quaternion_t *qo) {
  const double qo_0 = KSL_MUL(qi->x, dci[1]) + KSL_MUL(qi->w, dci[0]),
      qo_1 = KSL_MUL(qi->y, dci[1]) + KSL_MUL(qi->z, dci[0]),
      qo_2 = KSL_MUL(qi->z, dci[1]) - KSL_MUL(qi->y, dci[0]),
      qo_3 = KSL_MUL(qi->w, dci[1]) - KSL_MUL(qi->x, dci[0]);
  qo->x = qo_0;
  qo->y = qo_1;
  qo->z = qo_2;
  qo->w = qo_3;
}

/* qo = qi (s e_x; c)*, dci = (s, c), sine and cosine of half the angle.
   qi, qo: quaternion (x, y, z, w), the scalar last; dci: (sin θ, cos θ).
   8 mul, 4 add.
   Error <= u |result| + 1 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_quaternion_product_qqxconj(const ksl_quaternion_t *qi, const double dci[2],
    ksl_quaternion_t *qo) {
  const double qo_0 = KSL_MUL(qi->x, dci[1]) - KSL_MUL(qi->w, dci[0]),
      qo_1 = KSL_MUL(qi->y, dci[1]) - KSL_MUL(qi->z, dci[0]),
      qo_2 = KSL_MUL(qi->y, dci[0]) + KSL_MUL(qi->z, dci[1]),
      qo_3 = KSL_MUL(qi->x, dci[0]) + KSL_MUL(qi->w, dci[1]);
  qo->x = qo_0;
  qo->y = qo_1;
  qo->z = qo_2;
  qo->w = qo_3;
}

/* qo = qi* (s e_x; c), dci = (s, c), sine and cosine of half the angle.
   qi, qo: quaternion (x, y, z, w), the scalar last; dci: (sin θ, cos θ).
   8 mul, 4 add, 1 neg.
   Error <= u |result| + 1 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_quaternion_product_qconjqx(const ksl_quaternion_t *qi, const double dci[2],
    ksl_quaternion_t *qo) {
  const double qo_0 = KSL_MUL(qi->w, dci[0]) - KSL_MUL(qi->x, dci[1]),
      qo_1 = -(KSL_MUL(qi->y, dci[1]) + KSL_MUL(qi->z, dci[0])),
      qo_2 = KSL_MUL(qi->y, dci[0]) - KSL_MUL(qi->z, dci[1]),
      qo_3 = KSL_MUL(qi->x, dci[0]) + KSL_MUL(qi->w, dci[1]);
  qo->x = qo_0;
  qo->y = qo_1;
  qo->z = qo_2;
  qo->w = qo_3;
}

/* qo = qi* (s e_x; c)*, dci = (s, c), sine and cosine of half the angle.
   qi, qo: quaternion (x, y, z, w), the scalar last; dci: (sin θ, cos θ).
   8 mul, 4 add, 2 neg.
   Error <= u |result| + 1 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_quaternion_product_qconjqxconj(const ksl_quaternion_t *qi,
    const double dci[2], ksl_quaternion_t *qo) {
  const double qo_0 = -(KSL_MUL(qi->x, dci[1]) + KSL_MUL(qi->w, dci[0])),
      qo_1 = KSL_MUL(qi->z, dci[0]) - KSL_MUL(qi->y, dci[1]),
      qo_2 = -(KSL_MUL(qi->y, dci[0]) + KSL_MUL(qi->z, dci[1])),
      qo_3 = KSL_MUL(qi->w, dci[1]) - KSL_MUL(qi->x, dci[0]);
  qo->x = qo_0;
  qo->y = qo_1;
  qo->z = qo_2;
  qo->w = qo_3;
}

/* qo = (s e_y; c) qi, dci = (s, c), sine and cosine of half the angle.
   dci: (sin θ, cos θ); qi, qo: quaternion (x, y, z, w), the scalar last.
   8 mul, 4 add.
   Error <= u |result| + 1 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_quaternion_product_qyq(const double dci[2], const ksl_quaternion_t *qi,
    ksl_quaternion_t *qo) {
  const double qo_0 = KSL_MUL(dci[0], qi->z) + KSL_MUL(dci[1], qi->x),
      qo_1 = KSL_MUL(dci[0], qi->w) + KSL_MUL(dci[1], qi->y),
      qo_2 = KSL_MUL(dci[1], qi->z) - KSL_MUL(dci[0], qi->x),
      qo_3 = KSL_MUL(dci[1], qi->w) - KSL_MUL(dci[0], qi->y);
  qo->x = qo_0;
  qo->y = qo_1;
  qo->z = qo_2;
  qo->w = qo_3;
}

/* qo = (s e_y; c) qi*, dci = (s, c), sine and cosine of half the angle.
   dci: (sin θ, cos θ); qi, qo: quaternion (x, y, z, w), the scalar last.
   8 mul, 4 add, 1 neg.
   Error <= u |result| + 1 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_quaternion_product_qyqconj(const double dci[2], const ksl_quaternion_t *qi,
    ksl_quaternion_t *qo) {
  const double qo_0 = -(KSL_MUL(dci[0], qi->z) + KSL_MUL(dci[1], qi->x)),
      qo_1 = KSL_MUL(dci[0], qi->w) - KSL_MUL(dci[1], qi->y),
      qo_2 = KSL_MUL(dci[0], qi->x) - KSL_MUL(dci[1], qi->z),
      qo_3 = KSL_MUL(dci[0], qi->y) + KSL_MUL(dci[1], qi->w);
  qo->x = qo_0;
  qo->y = qo_1;
  qo->z = qo_2;
  qo->w = qo_3;
}

/* qo = (s e_y; c)* qi, dci = (s, c), sine and cosine of half the angle.
   dci: (sin θ, cos θ); qi, qo: quaternion (x, y, z, w), the scalar last.
   8 mul, 4 add.
   Error <= u |result| + 1 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_quaternion_product_qyconjq(const double dci[2], const ksl_quaternion_t *qi,
    ksl_quaternion_t *qo) {
  const double qo_0 = KSL_MUL(dci[1], qi->x) - KSL_MUL(dci[0], qi->z),
      qo_1 = KSL_MUL(dci[1], qi->y) - KSL_MUL(dci[0], qi->w),
      qo_2 = KSL_MUL(dci[0], qi->x) + KSL_MUL(dci[1], qi->z),
      qo_3 = KSL_MUL(dci[0], qi->y) + KSL_MUL(dci[1], qi->w);
  qo->x = qo_0;
  qo->y = qo_1;
  qo->z = qo_2;
  qo->w = qo_3;
}

/* qo = (s e_y; c)* qi*, dci = (s, c), sine and cosine of half the angle.
   dci: (sin θ, cos θ); qi, qo: quaternion (x, y, z, w), the scalar last.
   8 mul, 4 add, 2 neg.
   Error <= u |result| + 1 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_quaternion_product_qyconjqconj(const double dci[2],
    const ksl_quaternion_t *qi, ksl_quaternion_t *qo) {
  const double qo_0 = KSL_MUL(dci[0], qi->z) - KSL_MUL(dci[1], qi->x),
      qo_1 = -(KSL_MUL(dci[0], qi->w) + KSL_MUL(dci[1], qi->y)),
      qo_2 = -(KSL_MUL(dci[0], qi->x) + KSL_MUL(dci[1], qi->z)),
      qo_3 = KSL_MUL(dci[1], qi->w) - KSL_MUL(dci[0], qi->y);
  qo->x = qo_0;
  qo->y = qo_1;
  qo->z = qo_2;
  qo->w = qo_3;
}

/* qo = qi (s e_y; c), dci = (s, c), sine and cosine of half the angle.
   qi, qo: quaternion (x, y, z, w), the scalar last; dci: (sin θ, cos θ).
   8 mul, 4 add.
   Error <= u |result| + 1 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_quaternion_product_qqy(const ksl_quaternion_t *qi, const double dci[2],
    ksl_quaternion_t *qo) {
  const double qo_0 = KSL_MUL(qi->x, dci[1]) - KSL_MUL(qi->z, dci[0]),
      qo_1 = KSL_MUL(qi->y, dci[1]) + KSL_MUL(qi->w, dci[0]),
      qo_2 = KSL_MUL(qi->x, dci[0]) + KSL_MUL(qi->z, dci[1]),
      qo_3 = KSL_MUL(qi->w, dci[1]) - KSL_MUL(qi->y, dci[0]);
  qo->x = qo_0;
  qo->y = qo_1;
  qo->z = qo_2;
  qo->w = qo_3;
}

/* qo = qi (s e_y; c)*, dci = (s, c), sine and cosine of half the angle.
   qi, qo: quaternion (x, y, z, w), the scalar last; dci: (sin θ, cos θ).
   8 mul, 4 add.
   Error <= u |result| + 1 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_quaternion_product_qqyconj(const ksl_quaternion_t *qi, const double dci[2],
    ksl_quaternion_t *qo) {
  const double qo_0 = KSL_MUL(qi->x, dci[1]) + KSL_MUL(qi->z, dci[0]),
      qo_1 = KSL_MUL(qi->y, dci[1]) - KSL_MUL(qi->w, dci[0]),
      qo_2 = KSL_MUL(qi->z, dci[1]) - KSL_MUL(qi->x, dci[0]),
      qo_3 = KSL_MUL(qi->y, dci[0]) + KSL_MUL(qi->w, dci[1]);
  qo->x = qo_0;
  qo->y = qo_1;
  qo->z = qo_2;
  qo->w = qo_3;
}

/* qo = qi* (s e_y; c), dci = (s, c), sine and cosine of half the angle.
   qi, qo: quaternion (x, y, z, w), the scalar last; dci: (sin θ, cos θ).
   8 mul, 4 add, 1 neg.
   Error <= u |result| + 1 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_quaternion_product_qconjqy(const ksl_quaternion_t *qi, const double dci[2],
    ksl_quaternion_t *qo) {
  const double qo_0 = KSL_MUL(qi->z, dci[0]) - KSL_MUL(qi->x, dci[1]),
      qo_1 = KSL_MUL(qi->w, dci[0]) - KSL_MUL(qi->y, dci[1]),
      qo_2 = -(KSL_MUL(qi->x, dci[0]) + KSL_MUL(qi->z, dci[1])),
      qo_3 = KSL_MUL(qi->y, dci[0]) + KSL_MUL(qi->w, dci[1]);
  qo->x = qo_0;
  qo->y = qo_1;
  qo->z = qo_2;
  qo->w = qo_3;
}

/* qo = qi* (s e_y; c)*, dci = (s, c), sine and cosine of half the angle.
   qi, qo: quaternion (x, y, z, w), the scalar last; dci: (sin θ, cos θ).
   8 mul, 4 add, 2 neg.
   Error <= u |result| + 1 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_quaternion_product_qconjqyconj(const ksl_quaternion_t *qi,
    const double dci[2], ksl_quaternion_t *qo) {
  const double qo_0 = -(KSL_MUL(qi->x, dci[1]) + KSL_MUL(qi->z, dci[0])),
      qo_1 = -(KSL_MUL(qi->y, dci[1]) + KSL_MUL(qi->w, dci[0])),
      qo_2 = KSL_MUL(qi->x, dci[0]) - KSL_MUL(qi->z, dci[1]),
      qo_3 = KSL_MUL(qi->w, dci[1]) - KSL_MUL(qi->y, dci[0]);
  qo->x = qo_0;
  qo->y = qo_1;
  qo->z = qo_2;
  qo->w = qo_3;
}

/* qo = (s e_z; c) qi, dci = (s, c), sine and cosine of half the angle.
   dci: (sin θ, cos θ); qi, qo: quaternion (x, y, z, w), the scalar last.
   8 mul, 4 add.
   Error <= u |result| + 1 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_quaternion_product_qzq(const double dci[2], const ksl_quaternion_t *qi,
    ksl_quaternion_t *qo) {
  const double qo_0 = KSL_MUL(dci[1], qi->x) - KSL_MUL(dci[0], qi->y),
      qo_1 = KSL_MUL(dci[0], qi->x) + KSL_MUL(dci[1], qi->y),
      qo_2 = KSL_MUL(dci[0], qi->w) + KSL_MUL(dci[1], qi->z),
      qo_3 = KSL_MUL(dci[1], qi->w) - KSL_MUL(dci[0], qi->z);
  qo->x = qo_0;
  qo->y = qo_1;
  qo->z = qo_2;
  qo->w = qo_3;
}

/* qo = (s e_z; c) qi*, dci = (s, c), sine and cosine of half the angle.
   dci: (sin θ, cos θ); qi, qo: quaternion (x, y, z, w), the scalar last.
   8 mul, 4 add, 1 neg.
   Error <= u |result| + 1 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_quaternion_product_qzqconj(const double dci[2], const ksl_quaternion_t *qi,
    ksl_quaternion_t *qo) {
  const double qo_0 = KSL_MUL(dci[0], qi->y) - KSL_MUL(dci[1], qi->x),
      qo_1 = -(KSL_MUL(dci[0], qi->x) + KSL_MUL(dci[1], qi->y)),
      qo_2 = KSL_MUL(dci[0], qi->w) - KSL_MUL(dci[1], qi->z),
      qo_3 = KSL_MUL(dci[0], qi->z) + KSL_MUL(dci[1], qi->w);
  qo->x = qo_0;
  qo->y = qo_1;
  qo->z = qo_2;
  qo->w = qo_3;
}

/* qo = (s e_z; c)* qi, dci = (s, c), sine and cosine of half the angle.
   dci: (sin θ, cos θ); qi, qo: quaternion (x, y, z, w), the scalar last.
   8 mul, 4 add.
   Error <= u |result| + 1 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_quaternion_product_qzconjq(const double dci[2], const ksl_quaternion_t *qi,
    ksl_quaternion_t *qo) {
  const double qo_0 = KSL_MUL(dci[0], qi->y) + KSL_MUL(dci[1], qi->x),
      qo_1 = KSL_MUL(dci[1], qi->y) - KSL_MUL(dci[0], qi->x),
      qo_2 = KSL_MUL(dci[1], qi->z) - KSL_MUL(dci[0], qi->w),
      qo_3 = KSL_MUL(dci[0], qi->z) + KSL_MUL(dci[1], qi->w);
  qo->x = qo_0;
  qo->y = qo_1;
  qo->z = qo_2;
  qo->w = qo_3;
}

/* qo = (s e_z; c)* qi*, dci = (s, c), sine and cosine of half the angle.
   dci: (sin θ, cos θ); qi, qo: quaternion (x, y, z, w), the scalar last.
   8 mul, 4 add, 2 neg.
   Error <= u |result| + 1 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_quaternion_product_qzconjqconj(const double dci[2],
    const ksl_quaternion_t *qi, ksl_quaternion_t *qo) {
  const double qo_0 = -(KSL_MUL(dci[0], qi->y) + KSL_MUL(dci[1], qi->x)),
      qo_1 = KSL_MUL(dci[0], qi->x) - KSL_MUL(dci[1], qi->y),
      qo_2 = -(KSL_MUL(dci[0], qi->w) + KSL_MUL(dci[1], qi->z)),
      qo_3 = KSL_MUL(dci[1], qi->w) - KSL_MUL(dci[0], qi->z);
  qo->x = qo_0;
  qo->y = qo_1;
  qo->z = qo_2;
  qo->w = qo_3;
}

/* qo = qi (s e_z; c), dci = (s, c), sine and cosine of half the angle.
   qi, qo: quaternion (x, y, z, w), the scalar last; dci: (sin θ, cos θ).
   8 mul, 4 add.
   Error <= u |result| + 1 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_quaternion_product_qqz(const ksl_quaternion_t *qi, const double dci[2],
    ksl_quaternion_t *qo) {
  const double qo_0 = KSL_MUL(qi->x, dci[1]) + KSL_MUL(qi->y, dci[0]),
      qo_1 = KSL_MUL(qi->y, dci[1]) - KSL_MUL(qi->x, dci[0]),
      qo_2 = KSL_MUL(qi->z, dci[1]) + KSL_MUL(qi->w, dci[0]),
      qo_3 = KSL_MUL(qi->w, dci[1]) - KSL_MUL(qi->z, dci[0]);
  qo->x = qo_0;
  qo->y = qo_1;
  qo->z = qo_2;
  qo->w = qo_3;
}

/* qo = qi (s e_z; c)*, dci = (s, c), sine and cosine of half the angle.
   qi, qo: quaternion (x, y, z, w), the scalar last; dci: (sin θ, cos θ).
   8 mul, 4 add.
   Error <= u |result| + 1 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_quaternion_product_qqzconj(const ksl_quaternion_t *qi, const double dci[2],
    ksl_quaternion_t *qo) {
  const double qo_0 = KSL_MUL(qi->x, dci[1]) - KSL_MUL(qi->y, dci[0]),
      qo_1 = KSL_MUL(qi->x, dci[0]) + KSL_MUL(qi->y, dci[1]),
      qo_2 = KSL_MUL(qi->z, dci[1]) - KSL_MUL(qi->w, dci[0]),
      qo_3 = KSL_MUL(qi->z, dci[0]) + KSL_MUL(qi->w, dci[1]);
  qo->x = qo_0;
  qo->y = qo_1;
  qo->z = qo_2;
  qo->w = qo_3;
}

/* qo = qi* (s e_z; c), dci = (s, c), sine and cosine of half the angle.
   qi, qo: quaternion (x, y, z, w), the scalar last; dci: (sin θ, cos θ).
   8 mul, 4 add, 1 neg.
   Error <= u |result| + 1 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_quaternion_product_qconjqz(const ksl_quaternion_t *qi, const double dci[2],
    ksl_quaternion_t *qo) {
  const double qo_0 = -(KSL_MUL(qi->x, dci[1]) + KSL_MUL(qi->y, dci[0])),
      qo_1 = KSL_MUL(qi->x, dci[0]) - KSL_MUL(qi->y, dci[1]),
      qo_2 = KSL_MUL(qi->w, dci[0]) - KSL_MUL(qi->z, dci[1]),
      qo_3 = KSL_MUL(qi->z, dci[0]) + KSL_MUL(qi->w, dci[1]);
  qo->x = qo_0;
  qo->y = qo_1;
  qo->z = qo_2;
  qo->w = qo_3;
}

/* qo = qi* (s e_z; c)*, dci = (s, c), sine and cosine of half the angle.
   qi, qo: quaternion (x, y, z, w), the scalar last; dci: (sin θ, cos θ).
   8 mul, 4 add, 2 neg.
   Error <= u |result| + 1 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_quaternion_product_qconjqzconj(const ksl_quaternion_t *qi,
    const double dci[2], ksl_quaternion_t *qo) {
  const double qo_0 = KSL_MUL(qi->y, dci[0]) - KSL_MUL(qi->x, dci[1]),
      qo_1 = -(KSL_MUL(qi->x, dci[0]) + KSL_MUL(qi->y, dci[1])),
      qo_2 = -(KSL_MUL(qi->z, dci[1]) + KSL_MUL(qi->w, dci[0])),
      qo_3 = KSL_MUL(qi->w, dci[1]) - KSL_MUL(qi->z, dci[0]);
  qo->x = qo_0;
  qo->y = qo_1;
  qo->z = qo_2;
  qo->w = qo_3;
}

/* qo = qi (vi; 0).
   qi, qo: quaternion (x, y, z, w), the scalar last; vi: vector.
   12 mul, 8 add, 1 neg.
   Error <= u |result| + 2 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_quaternion_product_qv(const ksl_quaternion_t *qi, const ksl_vec3_t *vi,
    ksl_quaternion_t *qo) {
  const double qo_0 = KSL_MUL(qi->y, vi->z) - KSL_MUL(qi->z, vi->y) + KSL_MUL(qi->w, vi->x),
      qo_1 = KSL_MUL(qi->z, vi->x) - KSL_MUL(qi->x, vi->z) + KSL_MUL(qi->w, vi->y),
      qo_2 = KSL_MUL(qi->x, vi->y) - KSL_MUL(qi->y, vi->x) + KSL_MUL(qi->w, vi->z),
      qo_3 = -(KSL_MUL(qi->x, vi->x) + KSL_MUL(qi->y, vi->y) + KSL_MUL(qi->z, vi->z));
  qo->x = qo_0;
  qo->y = qo_1;
  qo->z = qo_2;
  qo->w = qo_3;
}

/* qo = qi* (vi; 0).
   qi, qo: quaternion (x, y, z, w), the scalar last; vi: vector.
   12 mul, 8 add.
   Error <= u |result| + 2 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_quaternion_product_qconjv(const ksl_quaternion_t *qi, const ksl_vec3_t *vi,
    ksl_quaternion_t *qo) {
  const double qo_0 = KSL_MUL(qi->z, vi->y) - KSL_MUL(qi->y, vi->z) + KSL_MUL(qi->w, vi->x),
      qo_1 = KSL_MUL(qi->x, vi->z) - KSL_MUL(qi->z, vi->x) + KSL_MUL(qi->w, vi->y),
      qo_2 = KSL_MUL(qi->y, vi->x) - KSL_MUL(qi->x, vi->y) + KSL_MUL(qi->w, vi->z),
      qo_3 = KSL_MUL(qi->x, vi->x) + KSL_MUL(qi->y, vi->y) + KSL_MUL(qi->z, vi->z);
  qo->x = qo_0;
  qo->y = qo_1;
  qo->z = qo_2;
  qo->w = qo_3;
}

/* qo = (vi; 0) qi.
   vi: vector; qi, qo: quaternion (x, y, z, w), the scalar last.
   12 mul, 8 add, 1 neg.
   Error <= u |result| + 2 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_quaternion_product_vq(const ksl_vec3_t *vi, const ksl_quaternion_t *qi,
    ksl_quaternion_t *qo) {
  const double qo_0 = KSL_MUL(vi->x, qi->w) + (KSL_MUL(vi->y, qi->z) - KSL_MUL(vi->z, qi->y)),
      qo_1 = KSL_MUL(vi->z, qi->x) - KSL_MUL(vi->x, qi->z) + KSL_MUL(vi->y, qi->w),
      qo_2 = KSL_MUL(vi->x, qi->y) - KSL_MUL(vi->y, qi->x) + KSL_MUL(vi->z, qi->w),
      qo_3 = -(KSL_MUL(vi->x, qi->x) + KSL_MUL(vi->y, qi->y) + KSL_MUL(vi->z, qi->z));
  qo->x = qo_0;
  qo->y = qo_1;
  qo->z = qo_2;
  qo->w = qo_3;
}

/* qo = (vi; 0) qi*.
   vi: vector; qi, qo: quaternion (x, y, z, w), the scalar last.
   12 mul, 8 add.
   Error <= u |result| + 2 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_quaternion_product_vqconj(const ksl_vec3_t *vi, const ksl_quaternion_t *qi,
    ksl_quaternion_t *qo) {
  const double qo_0 = KSL_MUL(vi->x, qi->w) + (KSL_MUL(vi->z, qi->y) - KSL_MUL(vi->y, qi->z)),
      qo_1 = KSL_MUL(vi->x, qi->z) - KSL_MUL(vi->z, qi->x) + KSL_MUL(vi->y, qi->w),
      qo_2 = KSL_MUL(vi->y, qi->x) - KSL_MUL(vi->x, qi->y) + KSL_MUL(vi->z, qi->w),
      qo_3 = KSL_MUL(vi->x, qi->x) + KSL_MUL(vi->y, qi->y) + KSL_MUL(vi->z, qi->z);
  qo->x = qo_0;
  qo->y = qo_1;
  qo->z = qo_2;
  qo->w = qo_3;
}

/* q1i·q2i.
   q1i, q2i: quaternion (x, y, z, w), the scalar last.
   4 mul, 3 add.
   Error <= u |result| + 3 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline double ksl_dot_qq(const ksl_quaternion_t *q1i, const ksl_quaternion_t *q2i) {
  const double dot = KSL_MUL(q1i->x, q2i->x) + KSL_MUL(q1i->y, q2i->y) + KSL_MUL(q1i->z, q2i->z)
          + KSL_MUL(q1i->w, q2i->w);
  return dot;
}

/* qi = qi + qi (dpi; 0) / 2: rotated by the small rotation vector dpi in the rotated frame, to
     first order; not normalized.
   dpi: vector; qi: quaternion (x, y, z, w), the scalar last.
   15 mul, 12 add.
   Error <= u |result| + 3 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_add_dpiToq(const ksl_vec3_t *dpi, ksl_quaternion_t *qi) {
  const double qi_0_new_a = KSL_MUL(0.5, dpi->x), qi_0_new_c = KSL_MUL(0.5, dpi->z),
      qi_0_new_e = KSL_MUL(0.5, dpi->y),
      qi_0_new = KSL_MUL(qi_0_new_a, qi->w)
          + (KSL_MUL(qi_0_new_c, qi->y) - KSL_MUL(qi_0_new_e, qi->z)) + qi->x;
  const double qi_1_new = KSL_MUL(qi_0_new_a, qi->z) - KSL_MUL(qi_0_new_c, qi->x)
          + KSL_MUL(qi_0_new_e, qi->w) + qi->y,
      qi_2_new = KSL_MUL(qi_0_new_e, qi->x) - KSL_MUL(qi_0_new_a, qi->y)
          + KSL_MUL(qi_0_new_c, qi->w) + qi->z,
      qi_3_new = qi->w
          - (KSL_MUL(qi_0_new_a, qi->x) + KSL_MUL(qi_0_new_e, qi->y) + KSL_MUL(qi_0_new_c, qi->z));
  qi->x = qi_0_new;
  qi->y = qi_1_new;
  qi->z = qi_2_new;
  qi->w = qi_3_new;
}

/* qi = qi - qi (dpi; 0) / 2, the opposite of add_dpiToq to first order.
   dpi: vector; qi: quaternion (x, y, z, w), the scalar last.
   15 mul, 12 add.
   Error <= u |result| + 3 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_subtract_dpiFromq(const ksl_vec3_t *dpi, ksl_quaternion_t *qi) {
  const double qi_0_new_a = KSL_MUL(0.5, dpi->y), qi_0_new_c = KSL_MUL(0.5, dpi->z),
      qi_0_new_f = KSL_MUL(0.5, dpi->x),
      qi_0_new = KSL_MUL(qi_0_new_a, qi->z) - KSL_MUL(qi_0_new_c, qi->y)
          - KSL_MUL(qi_0_new_f, qi->w) + qi->x;
  const double qi_1_new = KSL_MUL(qi_0_new_c, qi->x) - KSL_MUL(qi_0_new_f, qi->z)
          - KSL_MUL(qi_0_new_a, qi->w) + qi->y,
      qi_2_new = KSL_MUL(qi_0_new_f, qi->y) - KSL_MUL(qi_0_new_a, qi->x)
          - KSL_MUL(qi_0_new_c, qi->w) + qi->z,
      qi_3_new = KSL_MUL(qi_0_new_f, qi->x) + KSL_MUL(qi_0_new_a, qi->y)
          + KSL_MUL(qi_0_new_c, qi->z) + qi->w;
  qi->x = qi_0_new;
  qi->y = qi_1_new;
  qi->z = qi_2_new;
  qi->w = qi_3_new;
}

/* dqo = (w; 0) qi / 2 + (1 - qi·qi) qi: the rate of qi for the angular velocity w in the
     reference frame, rad/s, and a term that draws its norm to 1.
   w: vector; qi, dqo: quaternion (x, y, z, w), the scalar last.
   23 mul, 16 add.
   Error <= u |result| + 6 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_omega_to_dquaternion(const ksl_vec3_t *w, const ksl_quaternion_t *qi,
    ksl_quaternion_t *dqo) {
  const double dqo_0a = KSL_MUL(0.5, w->x), dqo_0c = KSL_MUL(0.5, w->y),
      dqo_0e = KSL_MUL(0.5, w->z),
      dqo_0p = 1.0 - KSL_MUL(qi->x, qi->x) - KSL_MUL(qi->y, qi->y) - KSL_MUL(qi->z, qi->z)
          - KSL_MUL(qi->w, qi->w),
      dqo_0 = KSL_MUL(dqo_0a, qi->w) + (KSL_MUL(dqo_0c, qi->z) - KSL_MUL(dqo_0e, qi->y))
          + KSL_MUL(qi->x, dqo_0p);
  const double dqo_1 = KSL_MUL(dqo_0e, qi->x) - KSL_MUL(dqo_0a, qi->z) + KSL_MUL(dqo_0c, qi->w)
          + KSL_MUL(qi->y, dqo_0p),
      dqo_2 = KSL_MUL(dqo_0a, qi->y) - KSL_MUL(dqo_0c, qi->x) + KSL_MUL(dqo_0e, qi->w)
          + KSL_MUL(qi->z, dqo_0p),
      dqo_3 = KSL_MUL(qi->w, dqo_0p)
          - (KSL_MUL(dqo_0a, qi->x) + KSL_MUL(dqo_0c, qi->y) + KSL_MUL(dqo_0e, qi->z));
  dqo->x = dqo_0;
  dqo->y = dqo_1;
  dqo->z = dqo_2;
  dqo->w = dqo_3;
}

/* R = I + 2 (w v~ + v~^2) / q·q, for any nonzero q whose square neither over- nor underflows.
   q: quaternion (x, y, z, w), the scalar last; R: rotation or other 3×3 matrix.
   20 mul, 16 add, 1 div.
   Error <= R: 8 u of its largest component for 2^-450 < |q| < 2^511, in single precision 2^-45 <
     |q| < 2^63; searched, not proved. */
static inline void ksl_mat3x3_from_quaternion(const ksl_quaternion_t *q, ksl_mat3x3_t *R) {
  const double squares_0 = KSL_MUL(q->w, q->w), squares_1 = KSL_MUL(q->x, q->x),
      squares_2 = KSL_MUL(q->y, q->y), squares_3 = KSL_MUL(q->z, q->z);
  const double pairs_0 = squares_0 + squares_1, pairs_1 = squares_2 + squares_3,
      pairs_2 = squares_0 + squares_2, pairs_3 = squares_1 + squares_3,
      pairs_4 = squares_0 + squares_3, pairs_5 = squares_1 + squares_2;
  const double square = pairs_0 + pairs_1;
  const double factor = 1.0 / square;
  const double d0 = pairs_0 - pairs_1;
  const double d1 = pairs_2 - pairs_3;
  const double d2 = pairs_4 - pairs_5;
  const double twice = KSL_MUL(2.0, factor);
  const double m_0a = KSL_MUL(q->x, q->y), m_0b = KSL_MUL(q->z, q->w), m_0 = m_0a - m_0b;
  const double m_1a = KSL_MUL(q->x, q->z), m_1b = KSL_MUL(q->y, q->w), m_1 = m_1a + m_1b;
  const double m_2a = KSL_MUL(q->y, q->z), m_2b = KSL_MUL(q->x, q->w), m_2 = m_2a - m_2b;
  const double m_3 = m_0a + m_0b, m_4 = m_1a - m_1b, m_5 = m_2b + m_2a;
  const double R_00 = KSL_MUL(factor, d0), R_01 = KSL_MUL(twice, m_0), R_02 = KSL_MUL(twice, m_1),
      R_10 = KSL_MUL(twice, m_3), R_11 = KSL_MUL(factor, d1), R_12 = KSL_MUL(twice, m_2),
      R_20 = KSL_MUL(twice, m_4), R_21 = KSL_MUL(twice, m_5), R_22 = KSL_MUL(factor, d2);
  R->m00 = R_00;
  R->m01 = R_01;
  R->m02 = R_02;
  R->m10 = R_10;
  R->m11 = R_11;
  R->m12 = R_12;
  R->m20 = R_20;
  R->m21 = R_21;
  R->m22 = R_22;
}

/* qo with R(qo) = R and w >= 0; if R is not quite a rotation, its defect carries over to qo.
   R: rotation or other 3×3 matrix; qo: quaternion (x, y, z, w), the scalar last.
   4 mul, 17 add, 4 div, 1 sqrt, 5 neg, 4 less, 16 select.
   Error <= qo: 6 u of its largest component for R a rotation; searched, not proved. */
static inline void ksl_quaternion_from_mat3x3(const ksl_mat3x3_t *R, ksl_quaternion_t *qo) {
  const double p_0 = R->m21 - R->m12, p_1 = R->m02 - R->m20, p_2 = R->m10 - R->m01;
  const double s_0 = R->m12 + R->m21, s_1 = R->m02 + R->m20, s_2 = R->m01 + R->m10;
  const double first_0 = R->m00 + 1.0, first_1 = 1.0 - R->m00;
  const double others_0 = R->m11 + R->m22, others_1 = R->m11 - R->m22;
  const double d_0 = first_0 + others_0, d_1 = first_0 - others_0, d_2 = first_1 + others_1,
      d_3 = first_1 - others_1;
  const double low_0 = R->m11 < R->m00 ? d_1 : s_2, low_1 = R->m11 < R->m00 ? s_2 : d_2,
      low_2 = R->m11 < R->m00 ? s_1 : s_0, low_3 = R->m11 < R->m00 ? p_0 : p_1;
  const double high_0a = -R->m11, high_0 = R->m00 < high_0a ? s_1 : p_0;
  const double high_1 = R->m00 < high_0a ? s_0 : p_1, high_2 = R->m00 < high_0a ? d_3 : p_2,
      high_3 = R->m00 < high_0a ? p_2 : d_0;
  const double column_0 = R->m22 < 0.0 ? low_0 : high_0, column_1 = R->m22 < 0.0 ? low_1 : high_1,
      column_2 = R->m22 < 0.0 ? low_2 : high_2, column_3 = R->m22 < 0.0 ? low_3 : high_3;
  const double upper_0a = -column_0, upper_0 = column_3 < 0.0 ? upper_0a : column_0;
  const double upper_1a = -column_1, upper_1 = column_3 < 0.0 ? upper_1a : column_1;
  const double upper_2a = -column_2, upper_2 = column_3 < 0.0 ? upper_2a : column_2;
  const double upper_3a = -column_3, upper_3 = column_3 < 0.0 ? upper_3a : column_3;
  const double length = sqrt(KSL_MUL(upper_0, upper_0) + KSL_MUL(upper_1, upper_1)
          + KSL_MUL(upper_2, upper_2) + KSL_MUL(upper_3, upper_3));
  const double qo_0 = upper_0 / length, qo_1 = upper_1 / length, qo_2 = upper_2 / length,
      qo_3 = upper_3 / length;
  qo->x = qo_0;
  qo->y = qo_1;
  qo->z = qo_2;
  qo->w = qo_3;
}

/* qo = (axis sin angle/2; cos angle/2); axis of length 1: with another |qo| is not 1, and its
     rotation is by another angle.
   axis: vector; angle: number; qo: quaternion (x, y, z, w), the scalar last.
   32 mul, 33 add, 1 abs.
   Error <= qo: 3 u of its largest component for |axis| = 1; searched, not proved. */
static inline void ksl_quaternion_from_axis_angle(const ksl_vec3_t *axis, const double angle,
    ksl_quaternion_t *qo) {
  const double half = KSL_MUL(0.5, angle);
  double qo_3; const double sine = ksl_sincos(half, &qo_3);
  const double qo_0 = KSL_MUL(axis->x, sine), qo_1 = KSL_MUL(axis->y, sine),
      qo_2 = KSL_MUL(axis->z, sine);
  qo->x = qo_0;
  qo->y = qo_1;
  qo->z = qo_2;
  qo->w = qo_3;
}

/* angle = 2 atan2(|v|, |w|), axis = ±v / |v|; 0 <= angle <= π; the axis is (1, 0, 0) if the
     angle is 0; any multiple of a quaternion.
   q: quaternion (x, y, z, w), the scalar last; axis: vector.
   41 mul, 37 add, 4 div, 1 sqrt, 5 neg, 9 abs, 2 copysign, 19 less, 2 equal, 32 select.
   Error <= angle: 6 u, axis: 4 u of its largest component; searched, not proved. */
static inline double ksl_axis_angle_from_quaternion(const ksl_quaternion_t *q, ksl_vec3_t *axis) {
  const double s_size_0 = fabs(q->x), s_size_1 = fabs(q->y), s_size_2 = fabs(q->z),
      s_size_3 = fabs(q->w);
  const double s_largest1 = s_size_0 < s_size_1 ? s_size_1 : s_size_0;
  const double s_largest2 = s_largest1 < s_size_2 ? s_size_2 : s_largest1;
  const double s_largest3 = s_largest2 < s_size_3 ? s_size_3 : s_largest2;
  const double s_b = 6.703903964971299e+153 < s_largest3 ? 3.7291703656001034e-155 : 1.0,
      s_d = s_largest3 < 256.0 ? 1.3093562431584567e+151 : s_b,
      s = s_largest3 < 1.955159272639747e-149 ? 1.0715086071862673e+301 : s_d;
  const double scaled_s_0 = KSL_MUL(q->x, s), scaled_s_1 = KSL_MUL(q->y, s),
      scaled_s_2 = KSL_MUL(q->z, s), scaled_s_3 = KSL_MUL(q->w, s);
  const double upper_0a = -scaled_s_0, upper_0 = scaled_s_3 < 0.0 ? upper_0a : scaled_s_0;
  const double upper_1a = -scaled_s_1, upper_1 = scaled_s_3 < 0.0 ? upper_1a : scaled_s_1;
  const double upper_2a = -scaled_s_2, upper_2 = scaled_s_3 < 0.0 ? upper_2a : scaled_s_2;
  const double upper_3a = -scaled_s_3, upper_3 = scaled_s_3 < 0.0 ? upper_3a : scaled_s_3;
  const double v_s_size_0 = fabs(upper_0), v_s_size_1 = fabs(upper_1), v_s_size_2 = fabs(upper_2);
  const double v_s_largest1 = v_s_size_0 < v_s_size_1 ? v_s_size_1 : v_s_size_0;
  const double v_s_largest2 = v_s_largest1 < v_s_size_2 ? v_s_size_2 : v_s_largest1;
  const double v_s_b = v_s_largest2 < 256.0 ? 1.3093562431584567e+151 : 1.0,
      v_s = v_s_largest2 < 1.955159272639747e-149 ? 1.0715086071862673e+301 : v_s_b;
  const double v_y_0 = KSL_MUL(upper_0, v_s), v_y_1 = KSL_MUL(upper_1, v_s),
      v_y_2 = KSL_MUL(upper_2, v_s);
  const double v_n = sqrt(KSL_MUL(v_y_0, v_y_0) + KSL_MUL(v_y_1, v_y_1) + KSL_MUL(v_y_2, v_y_2));
  const double v_r_b = 1.0 < v_s ? 7.637340908749012e-152 : 1.0,
      v_r = 1.3093562431584567e+151 < v_s ? 9.332636185032189e-302 : v_r_b;
  const double n = KSL_MUL(v_n, v_r);
  const double half = ksl_atan2(n, upper_3);
  const double divisor = v_n == 0.0 ? 1.0 : v_n;
  const double unit_0 = v_y_0 / divisor, unit_1 = v_y_1 / divisor, unit_2 = v_y_2 / divisor;
  const double angle = KSL_MUL(2.0, half);
  const double axis_0 = v_n == 0.0 ? 1.0 : unit_0;
  axis->x = axis_0;
  axis->y = unit_1;
  axis->z = unit_2;
  return angle;
}

/* qo = exp (v/2; 0) = (v/θ sin θ/2; cos θ/2), θ = |v|: turns by the rotation vector v.
   v: vector; qo: quaternion (x, y, z, w), the scalar last.
   71 mul, 86 add, 2 div, 1 sqrt, 5 abs, 2 less, 6 select.
   Error <= qo: (7 + θ/200) u of its largest component for |v| <= 1e13, in single precision 1e5;
     searched, not proved. */
static inline void ksl_quaternion_exp(const ksl_vec3_t *v, ksl_quaternion_t *qo) {
  const double h_0 = KSL_MUL(0.5, v->x), h_1 = KSL_MUL(0.5, v->y), h_2 = KSL_MUL(0.5, v->z);
  const double size_0 = fabs(h_0), size_1 = fabs(h_1), size_2 = fabs(h_2);
  const double sizes = size_0 + size_1 + size_2;
  const double grid = KSL_MUL(sizes, 268435456.0);
  const double shifted_0 = h_0 + grid, shifted_1 = h_1 + grid, shifted_2 = h_2 + grid;
  const double high_0 = shifted_0 - grid, high_1 = shifted_1 - grid, high_2 = shifted_2 - grid;
  const double low_0 = h_0 - high_0, low_1 = h_1 - high_1, low_2 = h_2 - high_2;
  const double sum_0 = h_0 + high_0, sum_1 = h_1 + high_1, sum_2 = h_2 + high_2;
  const double squares = KSL_MUL(high_0, high_0) + KSL_MUL(high_1, high_1)
          + KSL_MUL(high_2, high_2);
  const double cross = KSL_MUL(low_0, sum_0) + KSL_MUL(low_1, sum_1) + KSL_MUL(low_2, sum_2);
  const double x = squares + cross;
  const double theta_a = sqrt(x), theta = x < 1.0 ? 1.0 : theta_a;
  const double theta_shifted = grid + theta;
  const double theta_high = theta_shifted - grid;
  const double theta_low = theta - theta_high;
  const double theta_sum = theta + theta_high;
  const double cross_rest = cross - KSL_MUL(theta_low, theta_sum);
  const double exact = squares - KSL_MUL(theta_high, theta_high);
  const double residual = cross_rest + exact;
  const double small = KSL_MUL(0.5, residual) / theta;
  const double delta = fabs(small) < 0.0078125 ? small : 0.0;
  double far_cosine_a; const double far_sine_a = ksl_sincos(theta, &far_cosine_a);
  const double far_sine = x < 1.0 ? 1.0 : far_sine_a;
  const double far_cosine = x < 1.0 ? 0.0 : far_cosine_a;
  const double sine = KSL_MUL(delta, far_cosine) + far_sine;
  const double cosine = far_cosine - KSL_MUL(delta, far_sine);
  const double far_k = sine / theta;
  const double k_g = KSL_MUL(x, KSL_MUL(x, KSL_MUL(x, KSL_MUL(6.446950284384474e-26, x)
          - 3.868170170630684e-23) + 1.9572941063391263e-20) - 8.22063524662433e-18),
      k_n = KSL_MUL(x, KSL_MUL(x, KSL_MUL(x, k_g + 2.8114572543455206e-15) - 7.647163731819816e-13)
          + 1.6059043836821613e-10) - 2.505210838544172e-08,
      k_u = KSL_MUL(x, KSL_MUL(x, KSL_MUL(x, KSL_MUL(x, k_n) + 2.7557319223985893e-06)
          - 0.0001984126984126984) + 0.008333333333333333),
      k_x = KSL_MUL(x, k_u - 0.16666666666666666) + 1.0, k = x < 1.0 ? k_x : far_k;
  const double g2g = KSL_MUL(x, KSL_MUL(x, KSL_MUL(x, KSL_MUL(2.4795962632247976e-27, x)
          - 1.6117375710961184e-24) + 8.896791392450574e-22) - 4.110317623312165e-19),
      g2n = KSL_MUL(x, KSL_MUL(x, KSL_MUL(x, g2g + 1.5619206968586225e-16) - 4.779477332387385e-14)
          + 1.1470745597729725e-11) - 2.08767569878681e-09,
      g2v = KSL_MUL(x, KSL_MUL(x, KSL_MUL(x, KSL_MUL(x, g2n) + 2.755731922398589e-07)
          - 2.48015873015873e-05) + 0.001388888888888889) - 0.041666666666666664,
      g2 = KSL_MUL(x, g2v) + 0.5;
  const double near = 1.0 - KSL_MUL(x, g2);
  const double qo_0 = KSL_MUL(h_0, k), qo_1 = KSL_MUL(h_1, k), qo_2 = KSL_MUL(h_2, k),
      qo_3 = x < 1.0 ? near : cosine;
  qo->x = qo_0;
  qo->y = qo_1;
  qo->z = qo_2;
  qo->w = qo_3;
}

/* vo = θ v/|v|, θ = 2 atan2(|v|, |w|) <= π: the rotation vector of q, or of any multiple of it.
   q: quaternion (x, y, z, w), the scalar last; vo: vector.
   44 mul, 37 add, 2 div, 1 sqrt, 5 neg, 9 abs, 2 copysign, 19 less, 2 equal, 31 select.
   Error <= vo: 6 u of its largest component; searched, not proved. */
static inline void ksl_quaternion_log(const ksl_quaternion_t *q, ksl_vec3_t *vo) {
  const double s_size_0 = fabs(q->x), s_size_1 = fabs(q->y), s_size_2 = fabs(q->z),
      s_size_3 = fabs(q->w);
  const double s_largest1 = s_size_0 < s_size_1 ? s_size_1 : s_size_0;
  const double s_largest2 = s_largest1 < s_size_2 ? s_size_2 : s_largest1;
  const double s_largest3 = s_largest2 < s_size_3 ? s_size_3 : s_largest2;
  const double s_b = 6.703903964971299e+153 < s_largest3 ? 3.7291703656001034e-155 : 1.0,
      s_d = s_largest3 < 256.0 ? 1.3093562431584567e+151 : s_b,
      s = s_largest3 < 1.955159272639747e-149 ? 1.0715086071862673e+301 : s_d;
  const double scaled_s_0 = KSL_MUL(q->x, s), scaled_s_1 = KSL_MUL(q->y, s),
      scaled_s_2 = KSL_MUL(q->z, s), scaled_s_3 = KSL_MUL(q->w, s);
  const double upper_0a = -scaled_s_0, upper_0 = scaled_s_3 < 0.0 ? upper_0a : scaled_s_0;
  const double upper_1a = -scaled_s_1, upper_1 = scaled_s_3 < 0.0 ? upper_1a : scaled_s_1;
  const double upper_2a = -scaled_s_2, upper_2 = scaled_s_3 < 0.0 ? upper_2a : scaled_s_2;
  const double upper_3a = -scaled_s_3, upper_3 = scaled_s_3 < 0.0 ? upper_3a : scaled_s_3;
  const double v_s_size_0 = fabs(upper_0), v_s_size_1 = fabs(upper_1), v_s_size_2 = fabs(upper_2);
  const double v_s_largest1 = v_s_size_0 < v_s_size_1 ? v_s_size_1 : v_s_size_0;
  const double v_s_largest2 = v_s_largest1 < v_s_size_2 ? v_s_size_2 : v_s_largest1;
  const double v_s_b = v_s_largest2 < 256.0 ? 1.3093562431584567e+151 : 1.0,
      v_s = v_s_largest2 < 1.955159272639747e-149 ? 1.0715086071862673e+301 : v_s_b;
  const double v_y_0 = KSL_MUL(upper_0, v_s), v_y_1 = KSL_MUL(upper_1, v_s),
      v_y_2 = KSL_MUL(upper_2, v_s);
  const double v_n = sqrt(KSL_MUL(v_y_0, v_y_0) + KSL_MUL(v_y_1, v_y_1) + KSL_MUL(v_y_2, v_y_2));
  const double v_r_b = 1.0 < v_s ? 7.637340908749012e-152 : 1.0,
      v_r = 1.3093562431584567e+151 < v_s ? 9.332636185032189e-302 : v_r_b;
  const double n = KSL_MUL(v_n, v_r);
  const double half = ksl_atan2(n, upper_3);
  const double divisor = n == 0.0 ? 1.0 : n;
  const double theta = KSL_MUL(2.0, half);
  const double k = theta / divisor;
  const double vector_0 = KSL_MUL(upper_0, k), vector_1 = KSL_MUL(upper_1, k),
      vector_2 = KSL_MUL(upper_2, k);
  vo->x = vector_0;
  vo->y = vector_1;
  vo->z = vector_2;
}

/* qo = q1 (q1* q2)^k along the shorter arc: q1 at k = 0, ±q2 at k = 1; |q1| = |q2| = 1.
   q1, q2, qo: quaternion (x, y, z, w), the scalar last; k: number.
   142 mul, 147 add, 4 div, 2 sqrt, 5 neg, 10 abs, 2 copysign, 17 less, 2 equal, 33 select.
   Error <= qo: 16 u of its largest component for |q1| = 1 and |q2| = 1 and 0 <= k <= 1;
     searched, not proved. */
static inline void ksl_quaternion_interpolated(const ksl_quaternion_t *q1,
    const ksl_quaternion_t *q2, const double k, ksl_quaternion_t *qo) {
  const double between_0 = KSL_MUL(q1->w, q2->x) - KSL_MUL(q1->x, q2->w)
          + (KSL_MUL(q1->z, q2->y) - KSL_MUL(q1->y, q2->z)),
      between_1 = KSL_MUL(q1->x, q2->z) - KSL_MUL(q1->z, q2->x)
          + (KSL_MUL(q1->w, q2->y) - KSL_MUL(q1->y, q2->w)),
      between_2 = KSL_MUL(q1->y, q2->x) - KSL_MUL(q1->x, q2->y)
          + (KSL_MUL(q1->w, q2->z) - KSL_MUL(q1->z, q2->w)),
      between_3 = KSL_MUL(q1->x, q2->x) + KSL_MUL(q1->y, q2->y) + KSL_MUL(q1->z, q2->z)
          + KSL_MUL(q1->w, q2->w);
  const double upper_0a = -between_0, upper_0 = between_3 < 0.0 ? upper_0a : between_0;
  const double upper_1a = -between_1, upper_1 = between_3 < 0.0 ? upper_1a : between_1;
  const double upper_2a = -between_2, upper_2 = between_3 < 0.0 ? upper_2a : between_2;
  const double upper_3a = -between_3, upper_3 = between_3 < 0.0 ? upper_3a : between_3;
  const double v_s_size_0 = fabs(upper_0), v_s_size_1 = fabs(upper_1), v_s_size_2 = fabs(upper_2);
  const double v_s_largest1 = v_s_size_0 < v_s_size_1 ? v_s_size_1 : v_s_size_0;
  const double v_s_largest2 = v_s_largest1 < v_s_size_2 ? v_s_size_2 : v_s_largest1;
  const double v_s_b = 6.703903964971299e+153 < v_s_largest2 ? 3.7291703656001034e-155 : 1.0,
      v_s_d = v_s_largest2 < 256.0 ? 1.3093562431584567e+151 : v_s_b,
      v_s = v_s_largest2 < 1.955159272639747e-149 ? 1.0715086071862673e+301 : v_s_d;
  const double v_y_0 = KSL_MUL(upper_0, v_s), v_y_1 = KSL_MUL(upper_1, v_s),
      v_y_2 = KSL_MUL(upper_2, v_s);
  const double v_n = sqrt(KSL_MUL(v_y_0, v_y_0) + KSL_MUL(v_y_1, v_y_1) + KSL_MUL(v_y_2, v_y_2));
  const double v_r_b = v_s < 1.0 ? 2.6815615859885194e+154 : 1.0,
      v_r_d = 1.0 < v_s ? 7.637340908749012e-152 : v_r_b,
      v_r = 1.3093562431584567e+151 < v_s ? 9.332636185032189e-302 : v_r_d;
  const double n = KSL_MUL(v_n, v_r);
  const double half = ksl_atan2(n, upper_3);
  const double divisor = n == 0.0 ? 1.0 : n;
  const double rate = half / divisor;
  const double kv_0 = KSL_MUL(k, upper_0), kv_1 = KSL_MUL(k, upper_1), kv_2 = KSL_MUL(k, upper_2);
  const double step_0 = KSL_MUL(rate, kv_0), step_1 = KSL_MUL(rate, kv_1),
      step_2 = KSL_MUL(rate, kv_2);
  const double exp_size_0 = fabs(step_0), exp_size_1 = fabs(step_1), exp_size_2 = fabs(step_2);
  const double exp_sizes = exp_size_0 + exp_size_1 + exp_size_2;
  const double exp_grid = KSL_MUL(exp_sizes, 268435456.0);
  const double exp_shifted_0 = step_0 + exp_grid, exp_shifted_1 = step_1 + exp_grid,
      exp_shifted_2 = step_2 + exp_grid;
  const double exp_high_0 = exp_shifted_0 - exp_grid, exp_high_1 = exp_shifted_1 - exp_grid,
      exp_high_2 = exp_shifted_2 - exp_grid;
  const double exp_low_0 = step_0 - exp_high_0, exp_low_1 = step_1 - exp_high_1,
      exp_low_2 = step_2 - exp_high_2;
  const double exp_sum_0 = step_0 + exp_high_0, exp_sum_1 = step_1 + exp_high_1,
      exp_sum_2 = step_2 + exp_high_2;
  const double exp_squares = KSL_MUL(exp_high_0, exp_high_0) + KSL_MUL(exp_high_1, exp_high_1)
          + KSL_MUL(exp_high_2, exp_high_2);
  const double exp_cross = KSL_MUL(exp_low_0, exp_sum_0) + KSL_MUL(exp_low_1, exp_sum_1)
          + KSL_MUL(exp_low_2, exp_sum_2);
  const double exp_x = exp_squares + exp_cross;
  const double exp_theta_a = sqrt(exp_x), exp_theta = exp_x < 1.0 ? 1.0 : exp_theta_a;
  const double exp_theta_shifted = exp_grid + exp_theta;
  const double exp_theta_high = exp_theta_shifted - exp_grid;
  const double exp_theta_low = exp_theta - exp_theta_high;
  const double exp_theta_sum = exp_theta + exp_theta_high;
  const double exp_cross_rest = exp_cross - KSL_MUL(exp_theta_low, exp_theta_sum);
  const double exp_exact = exp_squares - KSL_MUL(exp_theta_high, exp_theta_high);
  const double exp_residual = exp_cross_rest + exp_exact;
  const double exp_small = KSL_MUL(0.5, exp_residual) / exp_theta;
  const double exp_delta = fabs(exp_small) < 0.0078125 ? exp_small : 0.0;
  double exp_far_cosine_a; const double exp_far_sine_a = ksl_sincos(exp_theta, &exp_far_cosine_a);
  const double exp_far_sine = exp_x < 1.0 ? 1.0 : exp_far_sine_a;
  const double exp_far_cosine = exp_x < 1.0 ? 0.0 : exp_far_cosine_a;
  const double exp_sine = KSL_MUL(exp_delta, exp_far_cosine) + exp_far_sine;
  const double exp_cosine = exp_far_cosine - KSL_MUL(exp_delta, exp_far_sine);
  const double exp_far_k = exp_sine / exp_theta;
  const double exp_k_e = KSL_MUL(exp_x, KSL_MUL(exp_x, KSL_MUL(6.446950284384474e-26, exp_x)
          - 3.868170170630684e-23) + 1.9572941063391263e-20),
      exp_k_k = KSL_MUL(exp_x, KSL_MUL(exp_x, KSL_MUL(exp_x, exp_k_e - 8.22063524662433e-18)
          + 2.8114572543455206e-15) - 7.647163731819816e-13),
      exp_k_q = KSL_MUL(exp_x, KSL_MUL(exp_x, KSL_MUL(exp_x, exp_k_k + 1.6059043836821613e-10)
          - 2.505210838544172e-08) + 2.7557319223985893e-06),
      exp_k_x = KSL_MUL(exp_x, KSL_MUL(exp_x, KSL_MUL(exp_x, exp_k_q - 0.0001984126984126984)
          + 0.008333333333333333) - 0.16666666666666666) + 1.0,
      exp_k = exp_x < 1.0 ? exp_k_x : exp_far_k;
  const double exp_g2e = KSL_MUL(exp_x, KSL_MUL(exp_x, KSL_MUL(2.4795962632247976e-27, exp_x)
          - 1.6117375710961184e-24) + 8.896791392450574e-22),
      exp_g2k = KSL_MUL(exp_x, KSL_MUL(exp_x, KSL_MUL(exp_x, exp_g2e - 4.110317623312165e-19)
          + 1.5619206968586225e-16) - 4.779477332387385e-14),
      exp_g2q = KSL_MUL(exp_x, KSL_MUL(exp_x, KSL_MUL(exp_x, exp_g2k + 1.1470745597729725e-11)
          - 2.08767569878681e-09) + 2.755731922398589e-07),
      exp_g2 = KSL_MUL(exp_x, KSL_MUL(exp_x, KSL_MUL(exp_x, exp_g2q - 2.48015873015873e-05)
          + 0.001388888888888889) - 0.041666666666666664) + 0.5;
  const double exp_near = 1.0 - KSL_MUL(exp_x, exp_g2);
  const double power_0 = KSL_MUL(step_0, exp_k), power_1 = KSL_MUL(step_1, exp_k),
      power_2 = KSL_MUL(step_2, exp_k), power_3 = exp_x < 1.0 ? exp_near : exp_cosine;
  const double qo_0 = KSL_MUL(q1->x, power_3) + (KSL_MUL(q1->y, power_2) - KSL_MUL(q1->z, power_1))
          + KSL_MUL(q1->w, power_0),
      qo_1 = KSL_MUL(q1->z, power_0) - KSL_MUL(q1->x, power_2) + KSL_MUL(q1->y, power_3)
          + KSL_MUL(q1->w, power_1),
      qo_2 = KSL_MUL(q1->x, power_1) - KSL_MUL(q1->y, power_0) + KSL_MUL(q1->z, power_3)
          + KSL_MUL(q1->w, power_2),
      qo_3 = KSL_MUL(q1->w, power_3)
          - (KSL_MUL(q1->x, power_0) + KSL_MUL(q1->y, power_1) + KSL_MUL(q1->z, power_2));
  qo->x = qo_0;
  qo->y = qo_1;
  qo->z = qo_2;
  qo->w = qo_3;
}

/* The quaternion of these entries, in order. */
static inline ksl_quaternionf_t ksl_quaternionf(const float x, const float y, const float z,
    const float w) {
  ksl_quaternionf_t value;
  value.x = x;
  value.y = y;
  value.z = z;
  value.w = w;
  return value;
}

/* qo = qi.
   qi, qo: quaternion (x, y, z, w), the scalar last.
   No arithmetic.
   Exact. */
static inline void ksl_quaternionf_copy(const ksl_quaternionf_t *qi, ksl_quaternionf_t *qo) {
  const float qi_x = qi->x;
  const float qi_y = qi->y;
  const float qi_z = qi->z;
  const float qi_w = qi->w;
  qo->x = qi_x;
  qo->y = qi_y;
  qo->z = qi_z;
  qo->w = qi_w;
}

/* self = a self.
   self: quaternion (x, y, z, w), the scalar last; a: number.
   4 mul.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_quaternionf_scale(ksl_quaternionf_t *self, const float a) {
  const float self_0_new = KSL_MULF(self->x, a), self_1_new = KSL_MULF(self->y, a),
      self_2_new = KSL_MULF(self->z, a), self_3_new = KSL_MULF(self->w, a);
  self->x = self_0_new;
  self->y = self_1_new;
  self->z = self_2_new;
  self->w = self_3_new;
}

/* y = a x + y.
   a: number; x, y: quaternion (x, y, z, w), the scalar last.
   4 mul, 4 add.
   Error <= u |result| + 1 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_axpy_qqf(const float a, const ksl_quaternionf_t *x, ksl_quaternionf_t *y) {
  const float y_0_new = KSL_MULF(a, x->x) + y->x, y_1_new = KSL_MULF(a, x->y) + y->y,
      y_2_new = KSL_MULF(a, x->z) + y->z, y_3_new = KSL_MULF(a, x->w) + y->w;
  y->x = y_0_new;
  y->y = y_1_new;
  y->z = y_2_new;
  y->w = y_3_new;
}

/* self = (0; 1).
   self: quaternion (x, y, z, w), the scalar last.
   No arithmetic.
   Exact. */
static inline void ksl_quaternionf_setIdentity(ksl_quaternionf_t *self) {
  self->x = 0.0f;
  self->y = 0.0f;
  self->z = 0.0f;
  self->w = 1.0f;
}

/* qo = (-v; w), the inverse of q if |q| = 1.
   q, qo: quaternion (x, y, z, w), the scalar last.
   3 neg.
   Exact. */
static inline void ksl_quaternionf_conjugated(const ksl_quaternionf_t *q, ksl_quaternionf_t *qo) {
  const float qo_0 = -q->x, qo_1 = -q->y, qo_2 = -q->z;
  const float q_w = q->w;
  qo->x = qo_0;
  qo->y = qo_1;
  qo->z = qo_2;
  qo->w = q_w;
}

/* |q| = sqrt(v·v + w^2).
   q: quaternion (x, y, z, w), the scalar last.
   9 mul, 3 add, 1 sqrt, 4 abs, 9 less, 9 select. */
static inline float ksl_quaternionf_norm(const ksl_quaternionf_t *q) {
  const float s_size_0 = fabsf(q->x), s_size_1 = fabsf(q->y), s_size_2 = fabsf(q->z),
      s_size_3 = fabsf(q->w);
  const float s_largest1 = s_size_0 < s_size_1 ? s_size_1 : s_size_0;
  const float s_largest2 = s_largest1 < s_size_2 ? s_size_2 : s_largest1;
  const float s_largest3 = s_largest2 < s_size_3 ? s_size_3 : s_largest2;
  const float s_b = 4.611686e+18f < s_largest3 ? 2.7105054e-20f : 1.0f,
      s_d = s_largest3 < 256.0f ? 1.8014399e+16f : s_b,
      s = s_largest3 < 1.4210855e-14f ? 3.2451855e+32f : s_d;
  const float y_0 = KSL_MULF(q->x, s), y_1 = KSL_MULF(q->y, s), y_2 = KSL_MULF(q->z, s),
      y_3 = KSL_MULF(q->w, s);
  const float n = sqrtf(KSL_MULF(y_0, y_0) + KSL_MULF(y_1, y_1) + KSL_MULF(y_2, y_2)
          + KSL_MULF(y_3, y_3));
  const float r_b = s < 1.0f ? 3.689349e+19f : 1.0f, r_d = 1.0f < s ? 5.551115e-17f : r_b,
      r = 1.8014399e+16f < s ? 3.081488e-33f : r_d;
  const float norm = KSL_MULF(n, r);
  return norm;
}

/* self = self / |self|; zero stays zero.
   self: quaternion (x, y, z, w), the scalar last.
   16 mul, 3 add, 4 div, 1 sqrt, 4 abs, 8 less, 1 equal, 9 select. */
static inline void ksl_quaternionf_normalize(ksl_quaternionf_t *self) {
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

/* qo = q / |q|; zero stays zero.
   q, qo: quaternion (x, y, z, w), the scalar last.
   16 mul, 3 add, 4 div, 1 sqrt, 4 abs, 8 less, 1 equal, 9 select. */
static inline void ksl_quaternionf_normalized(const ksl_quaternionf_t *q, ksl_quaternionf_t *qo) {
  const float s_size_0 = fabsf(q->x), s_size_1 = fabsf(q->y), s_size_2 = fabsf(q->z),
      s_size_3 = fabsf(q->w);
  const float s_largest1 = s_size_0 < s_size_1 ? s_size_1 : s_size_0;
  const float s_largest2 = s_largest1 < s_size_2 ? s_size_2 : s_largest1;
  const float s_largest3 = s_largest2 < s_size_3 ? s_size_3 : s_largest2;
  const float s_b = 4.611686e+18f < s_largest3 ? 2.7105054e-20f : 1.0f,
      s_d = s_largest3 < 256.0f ? 1.8014399e+16f : s_b,
      s = s_largest3 < 1.4210855e-14f ? 3.2451855e+32f : s_d;
  const float y_0 = KSL_MULF(q->x, s), y_1 = KSL_MULF(q->y, s), y_2 = KSL_MULF(q->z, s),
      y_3 = KSL_MULF(q->w, s);
  const float up = 1.0f < s ? s : 1.0f;
  const float down = s < 1.0f ? s : 1.0f;
  const float n = sqrtf(KSL_MULF(y_0, y_0) + KSL_MULF(y_1, y_1) + KSL_MULF(y_2, y_2)
          + KSL_MULF(y_3, y_3));
  const float divisor = n == 0.0f ? up : n;
  const float sized_0 = KSL_MULF(q->x, up), sized_1 = KSL_MULF(q->y, up),
      sized_2 = KSL_MULF(q->z, up), sized_3 = KSL_MULF(q->w, up);
  const float quotient_0 = sized_0 / divisor, quotient_1 = sized_1 / divisor,
      quotient_2 = sized_2 / divisor, quotient_3 = sized_3 / divisor;
  const float qo_0 = KSL_MULF(quotient_0, down), qo_1 = KSL_MULF(quotient_1, down),
      qo_2 = KSL_MULF(quotient_2, down), qo_3 = KSL_MULF(quotient_3, down);
  qo->x = qo_0;
  qo->y = qo_1;
  qo->z = qo_2;
  qo->w = qo_3;
}

/* |q| - 1: 0 for a unit quaternion, negative for a shorter one.
   q: quaternion (x, y, z, w), the scalar last.
   9 mul, 4 add, 1 sqrt, 4 abs, 9 less, 9 select. */
static inline float ksl_quaternionf_unit_defect(const ksl_quaternionf_t *q) {
  const float s_size_0 = fabsf(q->x), s_size_1 = fabsf(q->y), s_size_2 = fabsf(q->z),
      s_size_3 = fabsf(q->w);
  const float s_largest1 = s_size_0 < s_size_1 ? s_size_1 : s_size_0;
  const float s_largest2 = s_largest1 < s_size_2 ? s_size_2 : s_largest1;
  const float s_largest3 = s_largest2 < s_size_3 ? s_size_3 : s_largest2;
  const float s_b = 4.611686e+18f < s_largest3 ? 2.7105054e-20f : 1.0f,
      s_d = s_largest3 < 256.0f ? 1.8014399e+16f : s_b,
      s = s_largest3 < 1.4210855e-14f ? 3.2451855e+32f : s_d;
  const float y_0 = KSL_MULF(q->x, s), y_1 = KSL_MULF(q->y, s), y_2 = KSL_MULF(q->z, s),
      y_3 = KSL_MULF(q->w, s);
  const float n = sqrtf(KSL_MULF(y_0, y_0) + KSL_MULF(y_1, y_1) + KSL_MULF(y_2, y_2)
          + KSL_MULF(y_3, y_3));
  const float r_b = s < 1.0f ? 3.689349e+19f : 1.0f, r_d = 1.0f < s ? 5.551115e-17f : r_b,
      r = 1.8014399e+16f < s ? 3.081488e-33f : r_d;
  const float length = KSL_MULF(n, r);
  const float defect = length - 1.0f;
  return defect;
}

/* qo = q / |q|, the unit quaternion nearest to q; NaN for zero, which has none.
   q, qo: quaternion (x, y, z, w), the scalar last.
   8 mul, 3 add, 4 div, 1 sqrt, 4 abs, 6 less, 1 equal, 11 select. */
static inline void ksl_quaternionf_nearest_unit(const ksl_quaternionf_t *q, ksl_quaternionf_t *qo) {
  const float s_size_0 = fabsf(q->x), s_size_1 = fabsf(q->y), s_size_2 = fabsf(q->z),
      s_size_3 = fabsf(q->w);
  const float s_largest1 = s_size_0 < s_size_1 ? s_size_1 : s_size_0;
  const float s_largest2 = s_largest1 < s_size_2 ? s_size_2 : s_largest1;
  const float s_largest3 = s_largest2 < s_size_3 ? s_size_3 : s_largest2;
  const float s_b = 4.611686e+18f < s_largest3 ? 2.7105054e-20f : 1.0f,
      s_d = s_largest3 < 256.0f ? 1.8014399e+16f : s_b,
      s = s_largest3 < 1.4210855e-14f ? 3.2451855e+32f : s_d;
  const float scaled_s_0 = KSL_MULF(q->x, s), scaled_s_1 = KSL_MULF(q->y, s),
      scaled_s_2 = KSL_MULF(q->z, s), scaled_s_3 = KSL_MULF(q->w, s);
  const float n = sqrtf(KSL_MULF(scaled_s_0, scaled_s_0) + KSL_MULF(scaled_s_1, scaled_s_1)
          + KSL_MULF(scaled_s_2, scaled_s_2) + KSL_MULF(scaled_s_3, scaled_s_3));
  const float divisor = n == 0.0f ? 1.0f : n;
  const float unit_0 = scaled_s_0 / divisor, unit_1 = scaled_s_1 / divisor,
      unit_2 = scaled_s_2 / divisor, unit_3 = scaled_s_3 / divisor;
  const float qo_0 = n == 0.0f ? (float)NAN : unit_0, qo_1 = n == 0.0f ? (float)NAN : unit_1,
      qo_2 = n == 0.0f ? (float)NAN : unit_2, qo_3 = n == 0.0f ? (float)NAN : unit_3;
  qo->x = qo_0;
  qo->y = qo_1;
  qo->z = qo_2;
  qo->w = qo_3;
}

/* vo = R(q) v, |q| = 1.
   q: quaternion (x, y, z, w), the scalar last; v, vo: vector.
   18 mul, 12 add.
   Error <= u |result| + 5 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_rotate_qvf(const ksl_quaternionf_t *q, const ksl_vec3f_t *v,
    ksl_vec3f_t *vo) {
  const float c_0 = KSL_MULF(q->y, v->z) - KSL_MULF(q->z, v->y),
      c_1 = KSL_MULF(q->z, v->x) - KSL_MULF(q->x, v->z),
      c_2 = KSL_MULF(q->x, v->y) - KSL_MULF(q->y, v->x);
  const float t_0 = KSL_MULF(2.0f, c_0), t_1 = KSL_MULF(2.0f, c_1), t_2 = KSL_MULF(2.0f, c_2);
  const float turn_0 = KSL_MULF(q->y, t_2) - KSL_MULF(q->z, t_1) + KSL_MULF(q->w, t_0),
      turn_1 = KSL_MULF(q->z, t_0) - KSL_MULF(q->x, t_2) + KSL_MULF(q->w, t_1),
      turn_2 = KSL_MULF(q->x, t_1) - KSL_MULF(q->y, t_0) + KSL_MULF(q->w, t_2);
  const float vo_0 = v->x + turn_0, vo_1 = v->y + turn_1, vo_2 = v->z + turn_2;
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
}

/* vo = R(q)^T v, |q| = 1.
   q: quaternion (x, y, z, w), the scalar last; v, vo: vector.
   18 mul, 12 add.
   Error <= u |result| + 5 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_rotate_qconjvf(const ksl_quaternionf_t *q, const ksl_vec3f_t *v,
    ksl_vec3f_t *vo) {
  const float c_0 = KSL_MULF(q->z, v->y) - KSL_MULF(q->y, v->z),
      c_1 = KSL_MULF(q->x, v->z) - KSL_MULF(q->z, v->x),
      c_2 = KSL_MULF(q->y, v->x) - KSL_MULF(q->x, v->y);
  const float t_0 = KSL_MULF(2.0f, c_0), t_1 = KSL_MULF(2.0f, c_1), t_2 = KSL_MULF(2.0f, c_2);
  const float turn_0 = KSL_MULF(q->z, t_1) - KSL_MULF(q->y, t_2) + KSL_MULF(q->w, t_0),
      turn_1 = KSL_MULF(q->x, t_2) - KSL_MULF(q->z, t_0) + KSL_MULF(q->w, t_1),
      turn_2 = KSL_MULF(q->y, t_0) - KSL_MULF(q->x, t_1) + KSL_MULF(q->w, t_2);
  const float vo_0 = v->x + turn_0, vo_1 = v->y + turn_1, vo_2 = v->z + turn_2;
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
}

/* qo = q1i q2i.
   q1i, q2i, qo: quaternion (x, y, z, w), the scalar last.
   16 mul, 12 add.
   Error <= u |result| + 3 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_product_qqf(const ksl_quaternionf_t *q1i, const ksl_quaternionf_t *q2i,
    ksl_quaternionf_t *qo) {
  const float qo_0 = KSL_MULF(q1i->x, q2i->w)
          + (KSL_MULF(q1i->y, q2i->z) - KSL_MULF(q1i->z, q2i->y)) + KSL_MULF(q1i->w, q2i->x),
      qo_1 = KSL_MULF(q1i->z, q2i->x) - KSL_MULF(q1i->x, q2i->z) + KSL_MULF(q1i->y, q2i->w)
          + KSL_MULF(q1i->w, q2i->y),
      qo_2 = KSL_MULF(q1i->x, q2i->y) - KSL_MULF(q1i->y, q2i->x) + KSL_MULF(q1i->z, q2i->w)
          + KSL_MULF(q1i->w, q2i->z),
      qo_3 = KSL_MULF(q1i->w, q2i->w)
          - (KSL_MULF(q1i->x, q2i->x) + KSL_MULF(q1i->y, q2i->y) + KSL_MULF(q1i->z, q2i->z));
  qo->x = qo_0;
  qo->y = qo_1;
  qo->z = qo_2;
  qo->w = qo_3;
}

/* qo = q1i q2i*.
   q1i, q2i, qo: quaternion (x, y, z, w), the scalar last.
   16 mul, 12 add.
   Error <= u |result| + (v: 2, w: 3) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_qqconjf(const ksl_quaternionf_t *q1i, const ksl_quaternionf_t *q2i,
    ksl_quaternionf_t *qo) {
  const float qo_0 = KSL_MULF(q1i->x, q2i->w) - KSL_MULF(q1i->w, q2i->x)
          + (KSL_MULF(q1i->z, q2i->y) - KSL_MULF(q1i->y, q2i->z)),
      qo_1 = KSL_MULF(q1i->x, q2i->z) - KSL_MULF(q1i->z, q2i->x)
          + (KSL_MULF(q1i->y, q2i->w) - KSL_MULF(q1i->w, q2i->y)),
      qo_2 = KSL_MULF(q1i->y, q2i->x) - KSL_MULF(q1i->x, q2i->y)
          + (KSL_MULF(q1i->z, q2i->w) - KSL_MULF(q1i->w, q2i->z)),
      qo_3 = KSL_MULF(q1i->x, q2i->x) + KSL_MULF(q1i->y, q2i->y) + KSL_MULF(q1i->z, q2i->z)
          + KSL_MULF(q1i->w, q2i->w);
  qo->x = qo_0;
  qo->y = qo_1;
  qo->z = qo_2;
  qo->w = qo_3;
}

/* qo = q1i* q2i.
   q1i, q2i, qo: quaternion (x, y, z, w), the scalar last.
   16 mul, 12 add.
   Error <= u |result| + (v: 2, w: 3) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_qconjqf(const ksl_quaternionf_t *q1i, const ksl_quaternionf_t *q2i,
    ksl_quaternionf_t *qo) {
  const float qo_0 = KSL_MULF(q1i->w, q2i->x) - KSL_MULF(q1i->x, q2i->w)
          + (KSL_MULF(q1i->z, q2i->y) - KSL_MULF(q1i->y, q2i->z)),
      qo_1 = KSL_MULF(q1i->x, q2i->z) - KSL_MULF(q1i->z, q2i->x)
          + (KSL_MULF(q1i->w, q2i->y) - KSL_MULF(q1i->y, q2i->w)),
      qo_2 = KSL_MULF(q1i->y, q2i->x) - KSL_MULF(q1i->x, q2i->y)
          + (KSL_MULF(q1i->w, q2i->z) - KSL_MULF(q1i->z, q2i->w)),
      qo_3 = KSL_MULF(q1i->x, q2i->x) + KSL_MULF(q1i->y, q2i->y) + KSL_MULF(q1i->z, q2i->z)
          + KSL_MULF(q1i->w, q2i->w);
  qo->x = qo_0;
  qo->y = qo_1;
  qo->z = qo_2;
  qo->w = qo_3;
}

/* qo = q1i* q2i*.
   q1i, q2i, qo: quaternion (x, y, z, w), the scalar last.
   16 mul, 12 add.
   Error <= u |result| + 3 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_product_qconjqconjf(const ksl_quaternionf_t *q1i,
    const ksl_quaternionf_t *q2i, ksl_quaternionf_t *qo) {
  const float qo_0 = KSL_MULF(q1i->y, q2i->z) - KSL_MULF(q1i->z, q2i->y) - KSL_MULF(q1i->x, q2i->w)
          - KSL_MULF(q1i->w, q2i->x),
      qo_1 = KSL_MULF(q1i->z, q2i->x) - KSL_MULF(q1i->x, q2i->z) - KSL_MULF(q1i->y, q2i->w)
          - KSL_MULF(q1i->w, q2i->y),
      qo_2 = KSL_MULF(q1i->x, q2i->y) - KSL_MULF(q1i->y, q2i->x) - KSL_MULF(q1i->z, q2i->w)
          - KSL_MULF(q1i->w, q2i->z),
      qo_3 = KSL_MULF(q1i->w, q2i->w)
          - (KSL_MULF(q1i->x, q2i->x) + KSL_MULF(q1i->y, q2i->y) + KSL_MULF(q1i->z, q2i->z));
  qo->x = qo_0;
  qo->y = qo_1;
  qo->z = qo_2;
  qo->w = qo_3;
}

/* qo = (s e_x; c) qi, dci = (s, c), sine and cosine of half the angle.
   dci: (sin θ, cos θ); qi, qo: quaternion (x, y, z, w), the scalar last.
   8 mul, 4 add.
   Error <= u |result| + 1 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_product_qxqf(const float dci[2], const ksl_quaternionf_t *qi,
    ksl_quaternionf_t *qo) {
  const float qo_0 = KSL_MULF(dci[0], qi->w) + KSL_MULF(dci[1], qi->x),
      qo_1 = KSL_MULF(dci[1], qi->y) - KSL_MULF(dci[0], qi->z),
      qo_2 = KSL_MULF(dci[0], qi->y) + KSL_MULF(dci[1], qi->z),
      qo_3 = KSL_MULF(dci[1], qi->w) - KSL_MULF(dci[0], qi->x);
  qo->x = qo_0;
  qo->y = qo_1;
  qo->z = qo_2;
  qo->w = qo_3;
}

/* qo = (s e_x; c) qi*, dci = (s, c), sine and cosine of half the angle.
   dci: (sin θ, cos θ); qi, qo: quaternion (x, y, z, w), the scalar last.
   8 mul, 4 add, 1 neg.
   Error <= u |result| + 1 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_product_qxqconjf(const float dci[2], const ksl_quaternionf_t *qi,
    ksl_quaternionf_t *qo) {
  const float qo_0 = KSL_MULF(dci[0], qi->w) - KSL_MULF(dci[1], qi->x),
      qo_1 = KSL_MULF(dci[0], qi->z) - KSL_MULF(dci[1], qi->y),
      qo_2 = -(KSL_MULF(dci[0], qi->y) + KSL_MULF(dci[1], qi->z)),
      qo_3 = KSL_MULF(dci[0], qi->x) + KSL_MULF(dci[1], qi->w);
  qo->x = qo_0;
  qo->y = qo_1;
  qo->z = qo_2;
  qo->w = qo_3;
}

/* qo = (s e_x; c)* qi, dci = (s, c), sine and cosine of half the angle.
   dci: (sin θ, cos θ); qi, qo: quaternion (x, y, z, w), the scalar last.
   8 mul, 4 add.
   Error <= u |result| + 1 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_product_qxconjqf(const float dci[2], const ksl_quaternionf_t *qi,
    ksl_quaternionf_t *qo) {
  const float qo_0 = KSL_MULF(dci[1], qi->x) - KSL_MULF(dci[0], qi->w),
      qo_1 = KSL_MULF(dci[0], qi->z) + KSL_MULF(dci[1], qi->y),
      qo_2 = KSL_MULF(dci[1], qi->z) - KSL_MULF(dci[0], qi->y),
      qo_3 = KSL_MULF(dci[0], qi->x) + KSL_MULF(dci[1], qi->w);
  qo->x = qo_0;
  qo->y = qo_1;
  qo->z = qo_2;
  qo->w = qo_3;
}

/* qo = (s e_x; c)* qi*, dci = (s, c), sine and cosine of half the angle.
   dci: (sin θ, cos θ); qi, qo: quaternion (x, y, z, w), the scalar last.
   8 mul, 4 add, 2 neg.
   Error <= u |result| + 1 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_product_qxconjqconjf(const float dci[2], const ksl_quaternionf_t *qi,
    ksl_quaternionf_t *qo) {
  const float qo_0 = -(KSL_MULF(dci[0], qi->w) + KSL_MULF(dci[1], qi->x)),
      qo_1 = -(KSL_MULF(dci[0], qi->z) + KSL_MULF(dci[1], qi->y)),
      qo_2 = KSL_MULF(dci[0], qi->y) - KSL_MULF(dci[1], qi->z),
      qo_3 = KSL_MULF(dci[1], qi->w) - KSL_MULF(dci[0], qi->x);
  qo->x = qo_0;
  qo->y = qo_1;
  qo->z = qo_2;
  qo->w = qo_3;
}

/* qo = qi (s e_x; c), dci = (s, c), sine and cosine of half the angle.
   qi, qo: quaternion (x, y, z, w), the scalar last; dci: (sin θ, cos θ).
   8 mul, 4 add.
   Error <= u |result| + 1 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_product_qqxf(const ksl_quaternionf_t *qi, const float dci[2],
    ksl_quaternionf_t *qo) {
  const float qo_0 = KSL_MULF(qi->x, dci[1]) + KSL_MULF(qi->w, dci[0]),
      qo_1 = KSL_MULF(qi->y, dci[1]) + KSL_MULF(qi->z, dci[0]),
      qo_2 = KSL_MULF(qi->z, dci[1]) - KSL_MULF(qi->y, dci[0]),
      qo_3 = KSL_MULF(qi->w, dci[1]) - KSL_MULF(qi->x, dci[0]);
  qo->x = qo_0;
  qo->y = qo_1;
  qo->z = qo_2;
  qo->w = qo_3;
}

/* qo = qi (s e_x; c)*, dci = (s, c), sine and cosine of half the angle.
   qi, qo: quaternion (x, y, z, w), the scalar last; dci: (sin θ, cos θ).
   8 mul, 4 add.
   Error <= u |result| + 1 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_product_qqxconjf(const ksl_quaternionf_t *qi, const float dci[2],
    ksl_quaternionf_t *qo) {
  const float qo_0 = KSL_MULF(qi->x, dci[1]) - KSL_MULF(qi->w, dci[0]),
      qo_1 = KSL_MULF(qi->y, dci[1]) - KSL_MULF(qi->z, dci[0]),
      qo_2 = KSL_MULF(qi->y, dci[0]) + KSL_MULF(qi->z, dci[1]),
      qo_3 = KSL_MULF(qi->x, dci[0]) + KSL_MULF(qi->w, dci[1]);
  qo->x = qo_0;
  qo->y = qo_1;
  qo->z = qo_2;
  qo->w = qo_3;
}

/* qo = qi* (s e_x; c), dci = (s, c), sine and cosine of half the angle.
   qi, qo: quaternion (x, y, z, w), the scalar last; dci: (sin θ, cos θ).
   8 mul, 4 add, 1 neg.
   Error <= u |result| + 1 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_product_qconjqxf(const ksl_quaternionf_t *qi, const float dci[2],
    ksl_quaternionf_t *qo) {
  const float qo_0 = KSL_MULF(qi->w, dci[0]) - KSL_MULF(qi->x, dci[1]),
      qo_1 = -(KSL_MULF(qi->y, dci[1]) + KSL_MULF(qi->z, dci[0])),
      qo_2 = KSL_MULF(qi->y, dci[0]) - KSL_MULF(qi->z, dci[1]),
      qo_3 = KSL_MULF(qi->x, dci[0]) + KSL_MULF(qi->w, dci[1]);
  qo->x = qo_0;
  qo->y = qo_1;
  qo->z = qo_2;
  qo->w = qo_3;
}

/* qo = qi* (s e_x; c)*, dci = (s, c), sine and cosine of half the angle.
   qi, qo: quaternion (x, y, z, w), the scalar last; dci: (sin θ, cos θ).
   8 mul, 4 add, 2 neg.
   Error <= u |result| + 1 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_product_qconjqxconjf(const ksl_quaternionf_t *qi, const float dci[2],
    ksl_quaternionf_t *qo) {
  const float qo_0 = -(KSL_MULF(qi->x, dci[1]) + KSL_MULF(qi->w, dci[0])),
      qo_1 = KSL_MULF(qi->z, dci[0]) - KSL_MULF(qi->y, dci[1]),
      qo_2 = -(KSL_MULF(qi->y, dci[0]) + KSL_MULF(qi->z, dci[1])),
      qo_3 = KSL_MULF(qi->w, dci[1]) - KSL_MULF(qi->x, dci[0]);
  qo->x = qo_0;
  qo->y = qo_1;
  qo->z = qo_2;
  qo->w = qo_3;
}

/* qo = (s e_y; c) qi, dci = (s, c), sine and cosine of half the angle.
   dci: (sin θ, cos θ); qi, qo: quaternion (x, y, z, w), the scalar last.
   8 mul, 4 add.
   Error <= u |result| + 1 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_product_qyqf(const float dci[2], const ksl_quaternionf_t *qi,
    ksl_quaternionf_t *qo) {
  const float qo_0 = KSL_MULF(dci[0], qi->z) + KSL_MULF(dci[1], qi->x),
      qo_1 = KSL_MULF(dci[0], qi->w) + KSL_MULF(dci[1], qi->y),
      qo_2 = KSL_MULF(dci[1], qi->z) - KSL_MULF(dci[0], qi->x),
      qo_3 = KSL_MULF(dci[1], qi->w) - KSL_MULF(dci[0], qi->y);
  qo->x = qo_0;
  qo->y = qo_1;
  qo->z = qo_2;
  qo->w = qo_3;
}

/* qo = (s e_y; c) qi*, dci = (s, c), sine and cosine of half the angle.
   dci: (sin θ, cos θ); qi, qo: quaternion (x, y, z, w), the scalar last.
   8 mul, 4 add, 1 neg.
   Error <= u |result| + 1 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_product_qyqconjf(const float dci[2], const ksl_quaternionf_t *qi,
    ksl_quaternionf_t *qo) {
  const float qo_0 = -(KSL_MULF(dci[0], qi->z) + KSL_MULF(dci[1], qi->x)),
      qo_1 = KSL_MULF(dci[0], qi->w) - KSL_MULF(dci[1], qi->y),
      qo_2 = KSL_MULF(dci[0], qi->x) - KSL_MULF(dci[1], qi->z),
      qo_3 = KSL_MULF(dci[0], qi->y) + KSL_MULF(dci[1], qi->w);
  qo->x = qo_0;
  qo->y = qo_1;
  qo->z = qo_2;
  qo->w = qo_3;
}

/* qo = (s e_y; c)* qi, dci = (s, c), sine and cosine of half the angle.
   dci: (sin θ, cos θ); qi, qo: quaternion (x, y, z, w), the scalar last.
   8 mul, 4 add.
   Error <= u |result| + 1 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_product_qyconjqf(const float dci[2], const ksl_quaternionf_t *qi,
    ksl_quaternionf_t *qo) {
  const float qo_0 = KSL_MULF(dci[1], qi->x) - KSL_MULF(dci[0], qi->z),
      qo_1 = KSL_MULF(dci[1], qi->y) - KSL_MULF(dci[0], qi->w),
      qo_2 = KSL_MULF(dci[0], qi->x) + KSL_MULF(dci[1], qi->z),
      qo_3 = KSL_MULF(dci[0], qi->y) + KSL_MULF(dci[1], qi->w);
  qo->x = qo_0;
  qo->y = qo_1;
  qo->z = qo_2;
  qo->w = qo_3;
}

/* qo = (s e_y; c)* qi*, dci = (s, c), sine and cosine of half the angle.
   dci: (sin θ, cos θ); qi, qo: quaternion (x, y, z, w), the scalar last.
   8 mul, 4 add, 2 neg.
   Error <= u |result| + 1 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_product_qyconjqconjf(const float dci[2], const ksl_quaternionf_t *qi,
    ksl_quaternionf_t *qo) {
  const float qo_0 = KSL_MULF(dci[0], qi->z) - KSL_MULF(dci[1], qi->x),
      qo_1 = -(KSL_MULF(dci[0], qi->w) + KSL_MULF(dci[1], qi->y)),
      qo_2 = -(KSL_MULF(dci[0], qi->x) + KSL_MULF(dci[1], qi->z)),
      qo_3 = KSL_MULF(dci[1], qi->w) - KSL_MULF(dci[0], qi->y);
  qo->x = qo_0;
  qo->y = qo_1;
  qo->z = qo_2;
  qo->w = qo_3;
}

/* qo = qi (s e_y; c), dci = (s, c), sine and cosine of half the angle.
   qi, qo: quaternion (x, y, z, w), the scalar last; dci: (sin θ, cos θ).
   8 mul, 4 add.
   Error <= u |result| + 1 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_product_qqyf(const ksl_quaternionf_t *qi, const float dci[2],
    ksl_quaternionf_t *qo) {
  const float qo_0 = KSL_MULF(qi->x, dci[1]) - KSL_MULF(qi->z, dci[0]),
      qo_1 = KSL_MULF(qi->y, dci[1]) + KSL_MULF(qi->w, dci[0]),
      qo_2 = KSL_MULF(qi->x, dci[0]) + KSL_MULF(qi->z, dci[1]),
      qo_3 = KSL_MULF(qi->w, dci[1]) - KSL_MULF(qi->y, dci[0]);
  qo->x = qo_0;
  qo->y = qo_1;
  qo->z = qo_2;
  qo->w = qo_3;
}

/* qo = qi (s e_y; c)*, dci = (s, c), sine and cosine of half the angle.
   qi, qo: quaternion (x, y, z, w), the scalar last; dci: (sin θ, cos θ).
   8 mul, 4 add.
   Error <= u |result| + 1 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_product_qqyconjf(const ksl_quaternionf_t *qi, const float dci[2],
    ksl_quaternionf_t *qo) {
  const float qo_0 = KSL_MULF(qi->x, dci[1]) + KSL_MULF(qi->z, dci[0]),
      qo_1 = KSL_MULF(qi->y, dci[1]) - KSL_MULF(qi->w, dci[0]),
      qo_2 = KSL_MULF(qi->z, dci[1]) - KSL_MULF(qi->x, dci[0]),
      qo_3 = KSL_MULF(qi->y, dci[0]) + KSL_MULF(qi->w, dci[1]);
  qo->x = qo_0;
  qo->y = qo_1;
  qo->z = qo_2;
  qo->w = qo_3;
}

/* qo = qi* (s e_y; c), dci = (s, c), sine and cosine of half the angle.
   qi, qo: quaternion (x, y, z, w), the scalar last; dci: (sin θ, cos θ).
   8 mul, 4 add, 1 neg.
   Error <= u |result| + 1 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_product_qconjqyf(const ksl_quaternionf_t *qi, const float dci[2],
    ksl_quaternionf_t *qo) {
  const float qo_0 = KSL_MULF(qi->z, dci[0]) - KSL_MULF(qi->x, dci[1]),
      qo_1 = KSL_MULF(qi->w, dci[0]) - KSL_MULF(qi->y, dci[1]),
      qo_2 = -(KSL_MULF(qi->x, dci[0]) + KSL_MULF(qi->z, dci[1])),
      qo_3 = KSL_MULF(qi->y, dci[0]) + KSL_MULF(qi->w, dci[1]);
  qo->x = qo_0;
  qo->y = qo_1;
  qo->z = qo_2;
  qo->w = qo_3;
}

/* qo = qi* (s e_y; c)*, dci = (s, c), sine and cosine of half the angle.
   qi, qo: quaternion (x, y, z, w), the scalar last; dci: (sin θ, cos θ).
   8 mul, 4 add, 2 neg.
   Error <= u |result| + 1 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_product_qconjqyconjf(const ksl_quaternionf_t *qi, const float dci[2],
    ksl_quaternionf_t *qo) {
  const float qo_0 = -(KSL_MULF(qi->x, dci[1]) + KSL_MULF(qi->z, dci[0])),
      qo_1 = -(KSL_MULF(qi->y, dci[1]) + KSL_MULF(qi->w, dci[0])),
      qo_2 = KSL_MULF(qi->x, dci[0]) - KSL_MULF(qi->z, dci[1]),
      qo_3 = KSL_MULF(qi->w, dci[1]) - KSL_MULF(qi->y, dci[0]);
  qo->x = qo_0;
  qo->y = qo_1;
  qo->z = qo_2;
  qo->w = qo_3;
}

/* qo = (s e_z; c) qi, dci = (s, c), sine and cosine of half the angle.
   dci: (sin θ, cos θ); qi, qo: quaternion (x, y, z, w), the scalar last.
   8 mul, 4 add.
   Error <= u |result| + 1 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_product_qzqf(const float dci[2], const ksl_quaternionf_t *qi,
    ksl_quaternionf_t *qo) {
  const float qo_0 = KSL_MULF(dci[1], qi->x) - KSL_MULF(dci[0], qi->y),
      qo_1 = KSL_MULF(dci[0], qi->x) + KSL_MULF(dci[1], qi->y),
      qo_2 = KSL_MULF(dci[0], qi->w) + KSL_MULF(dci[1], qi->z),
      qo_3 = KSL_MULF(dci[1], qi->w) - KSL_MULF(dci[0], qi->z);
  qo->x = qo_0;
  qo->y = qo_1;
  qo->z = qo_2;
  qo->w = qo_3;
}

/* qo = (s e_z; c) qi*, dci = (s, c), sine and cosine of half the angle.
   dci: (sin θ, cos θ); qi, qo: quaternion (x, y, z, w), the scalar last.
   8 mul, 4 add, 1 neg.
   Error <= u |result| + 1 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_product_qzqconjf(const float dci[2], const ksl_quaternionf_t *qi,
    ksl_quaternionf_t *qo) {
  const float qo_0 = KSL_MULF(dci[0], qi->y) - KSL_MULF(dci[1], qi->x),
      qo_1 = -(KSL_MULF(dci[0], qi->x) + KSL_MULF(dci[1], qi->y)),
      qo_2 = KSL_MULF(dci[0], qi->w) - KSL_MULF(dci[1], qi->z),
      qo_3 = KSL_MULF(dci[0], qi->z) + KSL_MULF(dci[1], qi->w);
  qo->x = qo_0;
  qo->y = qo_1;
  qo->z = qo_2;
  qo->w = qo_3;
}

/* qo = (s e_z; c)* qi, dci = (s, c), sine and cosine of half the angle.
   dci: (sin θ, cos θ); qi, qo: quaternion (x, y, z, w), the scalar last.
   8 mul, 4 add.
   Error <= u |result| + 1 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_product_qzconjqf(const float dci[2], const ksl_quaternionf_t *qi,
    ksl_quaternionf_t *qo) {
  const float qo_0 = KSL_MULF(dci[0], qi->y) + KSL_MULF(dci[1], qi->x),
      qo_1 = KSL_MULF(dci[1], qi->y) - KSL_MULF(dci[0], qi->x),
      qo_2 = KSL_MULF(dci[1], qi->z) - KSL_MULF(dci[0], qi->w),
      qo_3 = KSL_MULF(dci[0], qi->z) + KSL_MULF(dci[1], qi->w);
  qo->x = qo_0;
  qo->y = qo_1;
  qo->z = qo_2;
  qo->w = qo_3;
}

/* qo = (s e_z; c)* qi*, dci = (s, c), sine and cosine of half the angle.
   dci: (sin θ, cos θ); qi, qo: quaternion (x, y, z, w), the scalar last.
   8 mul, 4 add, 2 neg.
   Error <= u |result| + 1 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_product_qzconjqconjf(const float dci[2], const ksl_quaternionf_t *qi,
    ksl_quaternionf_t *qo) {
  const float qo_0 = -(KSL_MULF(dci[0], qi->y) + KSL_MULF(dci[1], qi->x)),
      qo_1 = KSL_MULF(dci[0], qi->x) - KSL_MULF(dci[1], qi->y),
      qo_2 = -(KSL_MULF(dci[0], qi->w) + KSL_MULF(dci[1], qi->z)),
      qo_3 = KSL_MULF(dci[1], qi->w) - KSL_MULF(dci[0], qi->z);
  qo->x = qo_0;
  qo->y = qo_1;
  qo->z = qo_2;
  qo->w = qo_3;
}

/* qo = qi (s e_z; c), dci = (s, c), sine and cosine of half the angle.
   qi, qo: quaternion (x, y, z, w), the scalar last; dci: (sin θ, cos θ).
   8 mul, 4 add.
   Error <= u |result| + 1 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_product_qqzf(const ksl_quaternionf_t *qi, const float dci[2],
    ksl_quaternionf_t *qo) {
  const float qo_0 = KSL_MULF(qi->x, dci[1]) + KSL_MULF(qi->y, dci[0]),
      qo_1 = KSL_MULF(qi->y, dci[1]) - KSL_MULF(qi->x, dci[0]),
      qo_2 = KSL_MULF(qi->z, dci[1]) + KSL_MULF(qi->w, dci[0]),
      qo_3 = KSL_MULF(qi->w, dci[1]) - KSL_MULF(qi->z, dci[0]);
  qo->x = qo_0;
  qo->y = qo_1;
  qo->z = qo_2;
  qo->w = qo_3;
}

/* qo = qi (s e_z; c)*, dci = (s, c), sine and cosine of half the angle.
   qi, qo: quaternion (x, y, z, w), the scalar last; dci: (sin θ, cos θ).
   8 mul, 4 add.
   Error <= u |result| + 1 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_product_qqzconjf(const ksl_quaternionf_t *qi, const float dci[2],
    ksl_quaternionf_t *qo) {
  const float qo_0 = KSL_MULF(qi->x, dci[1]) - KSL_MULF(qi->y, dci[0]),
      qo_1 = KSL_MULF(qi->x, dci[0]) + KSL_MULF(qi->y, dci[1]),
      qo_2 = KSL_MULF(qi->z, dci[1]) - KSL_MULF(qi->w, dci[0]),
      qo_3 = KSL_MULF(qi->z, dci[0]) + KSL_MULF(qi->w, dci[1]);
  qo->x = qo_0;
  qo->y = qo_1;
  qo->z = qo_2;
  qo->w = qo_3;
}

/* qo = qi* (s e_z; c), dci = (s, c), sine and cosine of half the angle.
   qi, qo: quaternion (x, y, z, w), the scalar last; dci: (sin θ, cos θ).
   8 mul, 4 add, 1 neg.
   Error <= u |result| + 1 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_product_qconjqzf(const ksl_quaternionf_t *qi, const float dci[2],
    ksl_quaternionf_t *qo) {
  const float qo_0 = -(KSL_MULF(qi->x, dci[1]) + KSL_MULF(qi->y, dci[0])),
      qo_1 = KSL_MULF(qi->x, dci[0]) - KSL_MULF(qi->y, dci[1]),
      qo_2 = KSL_MULF(qi->w, dci[0]) - KSL_MULF(qi->z, dci[1]),
      qo_3 = KSL_MULF(qi->z, dci[0]) + KSL_MULF(qi->w, dci[1]);
  qo->x = qo_0;
  qo->y = qo_1;
  qo->z = qo_2;
  qo->w = qo_3;
}

/* qo = qi* (s e_z; c)*, dci = (s, c), sine and cosine of half the angle.
   qi, qo: quaternion (x, y, z, w), the scalar last; dci: (sin θ, cos θ).
   8 mul, 4 add, 2 neg.
   Error <= u |result| + 1 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_product_qconjqzconjf(const ksl_quaternionf_t *qi, const float dci[2],
    ksl_quaternionf_t *qo) {
  const float qo_0 = KSL_MULF(qi->y, dci[0]) - KSL_MULF(qi->x, dci[1]),
      qo_1 = -(KSL_MULF(qi->x, dci[0]) + KSL_MULF(qi->y, dci[1])),
      qo_2 = -(KSL_MULF(qi->z, dci[1]) + KSL_MULF(qi->w, dci[0])),
      qo_3 = KSL_MULF(qi->w, dci[1]) - KSL_MULF(qi->z, dci[0]);
  qo->x = qo_0;
  qo->y = qo_1;
  qo->z = qo_2;
  qo->w = qo_3;
}

/* qo = qi (vi; 0).
   qi, qo: quaternion (x, y, z, w), the scalar last; vi: vector.
   12 mul, 8 add, 1 neg.
   Error <= u |result| + 2 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_product_qvf(const ksl_quaternionf_t *qi, const ksl_vec3f_t *vi,
    ksl_quaternionf_t *qo) {
  const float qo_0 = KSL_MULF(qi->y, vi->z) - KSL_MULF(qi->z, vi->y) + KSL_MULF(qi->w, vi->x),
      qo_1 = KSL_MULF(qi->z, vi->x) - KSL_MULF(qi->x, vi->z) + KSL_MULF(qi->w, vi->y),
      qo_2 = KSL_MULF(qi->x, vi->y) - KSL_MULF(qi->y, vi->x) + KSL_MULF(qi->w, vi->z),
      qo_3 = -(KSL_MULF(qi->x, vi->x) + KSL_MULF(qi->y, vi->y) + KSL_MULF(qi->z, vi->z));
  qo->x = qo_0;
  qo->y = qo_1;
  qo->z = qo_2;
  qo->w = qo_3;
}

/* qo = qi* (vi; 0).
   qi, qo: quaternion (x, y, z, w), the scalar last; vi: vector.
   12 mul, 8 add.
   Error <= u |result| + 2 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_product_qconjvf(const ksl_quaternionf_t *qi, const ksl_vec3f_t *vi,
    ksl_quaternionf_t *qo) {
  const float qo_0 = KSL_MULF(qi->z, vi->y) - KSL_MULF(qi->y, vi->z) + KSL_MULF(qi->w, vi->x),
      qo_1 = KSL_MULF(qi->x, vi->z) - KSL_MULF(qi->z, vi->x) + KSL_MULF(qi->w, vi->y),
      qo_2 = KSL_MULF(qi->y, vi->x) - KSL_MULF(qi->x, vi->y) + KSL_MULF(qi->w, vi->z),
      qo_3 = KSL_MULF(qi->x, vi->x) + KSL_MULF(qi->y, vi->y) + KSL_MULF(qi->z, vi->z);
  qo->x = qo_0;
  qo->y = qo_1;
  qo->z = qo_2;
  qo->w = qo_3;
}

/* qo = (vi; 0) qi.
   vi: vector; qi, qo: quaternion (x, y, z, w), the scalar last.
   12 mul, 8 add, 1 neg.
   Error <= u |result| + 2 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_product_vqf(const ksl_vec3f_t *vi, const ksl_quaternionf_t *qi,
    ksl_quaternionf_t *qo) {
  const float qo_0 = KSL_MULF(vi->x, qi->w) + (KSL_MULF(vi->y, qi->z) - KSL_MULF(vi->z, qi->y)),
      qo_1 = KSL_MULF(vi->z, qi->x) - KSL_MULF(vi->x, qi->z) + KSL_MULF(vi->y, qi->w),
      qo_2 = KSL_MULF(vi->x, qi->y) - KSL_MULF(vi->y, qi->x) + KSL_MULF(vi->z, qi->w),
      qo_3 = -(KSL_MULF(vi->x, qi->x) + KSL_MULF(vi->y, qi->y) + KSL_MULF(vi->z, qi->z));
  qo->x = qo_0;
  qo->y = qo_1;
  qo->z = qo_2;
  qo->w = qo_3;
}

/* qo = (vi; 0) qi*.
   vi: vector; qi, qo: quaternion (x, y, z, w), the scalar last.
   12 mul, 8 add.
   Error <= u |result| + 2 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_product_vqconjf(const ksl_vec3f_t *vi, const ksl_quaternionf_t *qi,
    ksl_quaternionf_t *qo) {
  const float qo_0 = KSL_MULF(vi->x, qi->w) + (KSL_MULF(vi->z, qi->y) - KSL_MULF(vi->y, qi->z)),
      qo_1 = KSL_MULF(vi->x, qi->z) - KSL_MULF(vi->z, qi->x) + KSL_MULF(vi->y, qi->w),
      qo_2 = KSL_MULF(vi->y, qi->x) - KSL_MULF(vi->x, qi->y) + KSL_MULF(vi->z, qi->w),
      qo_3 = KSL_MULF(vi->x, qi->x) + KSL_MULF(vi->y, qi->y) + KSL_MULF(vi->z, qi->z);
  qo->x = qo_0;
  qo->y = qo_1;
  qo->z = qo_2;
  qo->w = qo_3;
}

/* q1i·q2i.
   q1i, q2i: quaternion (x, y, z, w), the scalar last.
   4 mul, 3 add.
   Error <= u |result| + 3 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline float ksl_dot_qqf(const ksl_quaternionf_t *q1i, const ksl_quaternionf_t *q2i) {
  const float dot = KSL_MULF(q1i->x, q2i->x) + KSL_MULF(q1i->y, q2i->y) + KSL_MULF(q1i->z, q2i->z)
          + KSL_MULF(q1i->w, q2i->w);
  return dot;
}

/* qi = qi + qi (dpi; 0) / 2: rotated by the small rotation vector dpi in the rotated frame, to
     first order; not normalized.
   dpi: vector; qi: quaternion (x, y, z, w), the scalar last.
   15 mul, 12 add.
   Error <= u |result| + 3 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_add_dpiToqf(const ksl_vec3f_t *dpi, ksl_quaternionf_t *qi) {
  const float qi_0_new_a = KSL_MULF(0.5f, dpi->x), qi_0_new_c = KSL_MULF(0.5f, dpi->z),
      qi_0_new_e = KSL_MULF(0.5f, dpi->y),
      qi_0_new = KSL_MULF(qi_0_new_a, qi->w)
          + (KSL_MULF(qi_0_new_c, qi->y) - KSL_MULF(qi_0_new_e, qi->z)) + qi->x;
  const float qi_1_new = KSL_MULF(qi_0_new_a, qi->z) - KSL_MULF(qi_0_new_c, qi->x)
          + KSL_MULF(qi_0_new_e, qi->w) + qi->y,
      qi_2_new = KSL_MULF(qi_0_new_e, qi->x) - KSL_MULF(qi_0_new_a, qi->y)
          + KSL_MULF(qi_0_new_c, qi->w) + qi->z,
      qi_3_new = qi->w
          - (KSL_MULF(qi_0_new_a, qi->x) + KSL_MULF(qi_0_new_e, qi->y)
          + KSL_MULF(qi_0_new_c, qi->z));
  qi->x = qi_0_new;
  qi->y = qi_1_new;
  qi->z = qi_2_new;
  qi->w = qi_3_new;
}

/* qi = qi - qi (dpi; 0) / 2, the opposite of add_dpiToq to first order.
   dpi: vector; qi: quaternion (x, y, z, w), the scalar last.
   15 mul, 12 add.
   Error <= u |result| + 3 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_subtract_dpiFromqf(const ksl_vec3f_t *dpi, ksl_quaternionf_t *qi) {
  const float qi_0_new_a = KSL_MULF(0.5f, dpi->y), qi_0_new_c = KSL_MULF(0.5f, dpi->z),
      qi_0_new_f = KSL_MULF(0.5f, dpi->x),
      qi_0_new = KSL_MULF(qi_0_new_a, qi->z) - KSL_MULF(qi_0_new_c, qi->y)
          - KSL_MULF(qi_0_new_f, qi->w) + qi->x;
  const float qi_1_new = KSL_MULF(qi_0_new_c, qi->x) - KSL_MULF(qi_0_new_f, qi->z)
          - KSL_MULF(qi_0_new_a, qi->w) + qi->y,
      qi_2_new = KSL_MULF(qi_0_new_f, qi->y) - KSL_MULF(qi_0_new_a, qi->x)
          - KSL_MULF(qi_0_new_c, qi->w) + qi->z,
      qi_3_new = KSL_MULF(qi_0_new_f, qi->x) + KSL_MULF(qi_0_new_a, qi->y)
          + KSL_MULF(qi_0_new_c, qi->z) + qi->w;
  qi->x = qi_0_new;
  qi->y = qi_1_new;
  qi->z = qi_2_new;
  qi->w = qi_3_new;
}

/* dqo = (w; 0) qi / 2 + (1 - qi·qi) qi: the rate of qi for the angular velocity w in the
     reference frame, rad/s, and a term that draws its norm to 1.
   w: vector; qi, dqo: quaternion (x, y, z, w), the scalar last.
   23 mul, 16 add.
   Error <= u |result| + 6 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_omega_to_dquaternionf(const ksl_vec3f_t *w, const ksl_quaternionf_t *qi,
    ksl_quaternionf_t *dqo) {
  const float dqo_0a = KSL_MULF(0.5f, w->x), dqo_0c = KSL_MULF(0.5f, w->y),
      dqo_0e = KSL_MULF(0.5f, w->z),
      dqo_0p = 1.0f - KSL_MULF(qi->x, qi->x) - KSL_MULF(qi->y, qi->y) - KSL_MULF(qi->z, qi->z)
          - KSL_MULF(qi->w, qi->w),
      dqo_0 = KSL_MULF(dqo_0a, qi->w) + (KSL_MULF(dqo_0c, qi->z) - KSL_MULF(dqo_0e, qi->y))
          + KSL_MULF(qi->x, dqo_0p);
  const float dqo_1 = KSL_MULF(dqo_0e, qi->x) - KSL_MULF(dqo_0a, qi->z) + KSL_MULF(dqo_0c, qi->w)
          + KSL_MULF(qi->y, dqo_0p),
      dqo_2 = KSL_MULF(dqo_0a, qi->y) - KSL_MULF(dqo_0c, qi->x) + KSL_MULF(dqo_0e, qi->w)
          + KSL_MULF(qi->z, dqo_0p),
      dqo_3 = KSL_MULF(qi->w, dqo_0p)
          - (KSL_MULF(dqo_0a, qi->x) + KSL_MULF(dqo_0c, qi->y) + KSL_MULF(dqo_0e, qi->z));
  dqo->x = dqo_0;
  dqo->y = dqo_1;
  dqo->z = dqo_2;
  dqo->w = dqo_3;
}

/* R = I + 2 (w v~ + v~^2) / q·q, for any nonzero q whose square neither over- nor underflows.
   q: quaternion (x, y, z, w), the scalar last; R: rotation or other 3×3 matrix.
   20 mul, 16 add, 1 div.
   Error <= R: 8 u of its largest component for 2^-450 < |q| < 2^511, in single precision 2^-45 <
     |q| < 2^63; searched, not proved. */
static inline void ksl_mat3x3f_from_quaternion(const ksl_quaternionf_t *q, ksl_mat3x3f_t *R) {
  const float squares_0 = KSL_MULF(q->w, q->w), squares_1 = KSL_MULF(q->x, q->x),
      squares_2 = KSL_MULF(q->y, q->y), squares_3 = KSL_MULF(q->z, q->z);
  const float pairs_0 = squares_0 + squares_1, pairs_1 = squares_2 + squares_3,
      pairs_2 = squares_0 + squares_2, pairs_3 = squares_1 + squares_3,
      pairs_4 = squares_0 + squares_3, pairs_5 = squares_1 + squares_2;
  const float square = pairs_0 + pairs_1;
  const float factor = 1.0f / square;
  const float d0 = pairs_0 - pairs_1;
  const float d1 = pairs_2 - pairs_3;
  const float d2 = pairs_4 - pairs_5;
  const float twice = KSL_MULF(2.0f, factor);
  const float m_0a = KSL_MULF(q->x, q->y), m_0b = KSL_MULF(q->z, q->w), m_0 = m_0a - m_0b;
  const float m_1a = KSL_MULF(q->x, q->z), m_1b = KSL_MULF(q->y, q->w), m_1 = m_1a + m_1b;
  const float m_2a = KSL_MULF(q->y, q->z), m_2b = KSL_MULF(q->x, q->w), m_2 = m_2a - m_2b;
  const float m_3 = m_0a + m_0b, m_4 = m_1a - m_1b, m_5 = m_2b + m_2a;
  const float R_00 = KSL_MULF(factor, d0), R_01 = KSL_MULF(twice, m_0), R_02 = KSL_MULF(twice, m_1),
      R_10 = KSL_MULF(twice, m_3), R_11 = KSL_MULF(factor, d1), R_12 = KSL_MULF(twice, m_2),
      R_20 = KSL_MULF(twice, m_4), R_21 = KSL_MULF(twice, m_5), R_22 = KSL_MULF(factor, d2);
  R->m00 = R_00;
  R->m01 = R_01;
  R->m02 = R_02;
  R->m10 = R_10;
  R->m11 = R_11;
  R->m12 = R_12;
  R->m20 = R_20;
  R->m21 = R_21;
  R->m22 = R_22;
}

/* qo with R(qo) = R and w >= 0; if R is not quite a rotation, its defect carries over to qo.
   R: rotation or other 3×3 matrix; qo: quaternion (x, y, z, w), the scalar last.
   4 mul, 17 add, 4 div, 1 sqrt, 5 neg, 4 less, 16 select.
   Error <= qo: 6 u of its largest component for R a rotation; searched, not proved. */
static inline void ksl_quaternionf_from_mat3x3(const ksl_mat3x3f_t *R, ksl_quaternionf_t *qo) {
  const float p_0 = R->m21 - R->m12, p_1 = R->m02 - R->m20, p_2 = R->m10 - R->m01;
  const float s_0 = R->m12 + R->m21, s_1 = R->m02 + R->m20, s_2 = R->m01 + R->m10;
  const float first_0 = R->m00 + 1.0f, first_1 = 1.0f - R->m00;
  const float others_0 = R->m11 + R->m22, others_1 = R->m11 - R->m22;
  const float d_0 = first_0 + others_0, d_1 = first_0 - others_0, d_2 = first_1 + others_1,
      d_3 = first_1 - others_1;
  const float low_0 = R->m11 < R->m00 ? d_1 : s_2, low_1 = R->m11 < R->m00 ? s_2 : d_2,
      low_2 = R->m11 < R->m00 ? s_1 : s_0, low_3 = R->m11 < R->m00 ? p_0 : p_1;
  const float high_0a = -R->m11, high_0 = R->m00 < high_0a ? s_1 : p_0;
  const float high_1 = R->m00 < high_0a ? s_0 : p_1, high_2 = R->m00 < high_0a ? d_3 : p_2,
      high_3 = R->m00 < high_0a ? p_2 : d_0;
  const float column_0 = R->m22 < 0.0f ? low_0 : high_0, column_1 = R->m22 < 0.0f ? low_1 : high_1,
      column_2 = R->m22 < 0.0f ? low_2 : high_2, column_3 = R->m22 < 0.0f ? low_3 : high_3;
  const float upper_0a = -column_0, upper_0 = column_3 < 0.0f ? upper_0a : column_0;
  const float upper_1a = -column_1, upper_1 = column_3 < 0.0f ? upper_1a : column_1;
  const float upper_2a = -column_2, upper_2 = column_3 < 0.0f ? upper_2a : column_2;
  const float upper_3a = -column_3, upper_3 = column_3 < 0.0f ? upper_3a : column_3;
  const float length = sqrtf(KSL_MULF(upper_0, upper_0) + KSL_MULF(upper_1, upper_1)
          + KSL_MULF(upper_2, upper_2) + KSL_MULF(upper_3, upper_3));
  const float qo_0 = upper_0 / length, qo_1 = upper_1 / length, qo_2 = upper_2 / length,
      qo_3 = upper_3 / length;
  qo->x = qo_0;
  qo->y = qo_1;
  qo->z = qo_2;
  qo->w = qo_3;
}

/* qo = (axis sin angle/2; cos angle/2); axis of length 1: with another |qo| is not 1, and its
     rotation is by another angle.
   axis: vector; angle: number; qo: quaternion (x, y, z, w), the scalar last.
   26 mul, 27 add, 1 abs.
   Error <= qo: 3 u of its largest component for |axis| = 1; searched, not proved. */
static inline void ksl_quaternionf_from_axis_angle(const ksl_vec3f_t *axis, const float angle,
    ksl_quaternionf_t *qo) {
  const float half = KSL_MULF(0.5f, angle);
  float qo_3; const float sine = ksl_sincosf(half, &qo_3);
  const float qo_0 = KSL_MULF(axis->x, sine), qo_1 = KSL_MULF(axis->y, sine),
      qo_2 = KSL_MULF(axis->z, sine);
  qo->x = qo_0;
  qo->y = qo_1;
  qo->z = qo_2;
  qo->w = qo_3;
}

/* angle = 2 atan2(|v|, |w|), axis = ±v / |v|; 0 <= angle <= π; the axis is (1, 0, 0) if the
     angle is 0; any multiple of a quaternion.
   q: quaternion (x, y, z, w), the scalar last; axis: vector.
   34 mul, 31 add, 4 div, 1 sqrt, 5 neg, 9 abs, 2 copysign, 19 less, 2 equal, 32 select.
   Error <= angle: 6 u, axis: 4 u of its largest component; searched, not proved. */
static inline float ksl_axis_angle_from_quaternionf(const ksl_quaternionf_t *q, ksl_vec3f_t *axis) {
  const float s_size_0 = fabsf(q->x), s_size_1 = fabsf(q->y), s_size_2 = fabsf(q->z),
      s_size_3 = fabsf(q->w);
  const float s_largest1 = s_size_0 < s_size_1 ? s_size_1 : s_size_0;
  const float s_largest2 = s_largest1 < s_size_2 ? s_size_2 : s_largest1;
  const float s_largest3 = s_largest2 < s_size_3 ? s_size_3 : s_largest2;
  const float s_b = 4.611686e+18f < s_largest3 ? 2.7105054e-20f : 1.0f,
      s_d = s_largest3 < 256.0f ? 1.8014399e+16f : s_b,
      s = s_largest3 < 1.4210855e-14f ? 3.2451855e+32f : s_d;
  const float scaled_s_0 = KSL_MULF(q->x, s), scaled_s_1 = KSL_MULF(q->y, s),
      scaled_s_2 = KSL_MULF(q->z, s), scaled_s_3 = KSL_MULF(q->w, s);
  const float upper_0a = -scaled_s_0, upper_0 = scaled_s_3 < 0.0f ? upper_0a : scaled_s_0;
  const float upper_1a = -scaled_s_1, upper_1 = scaled_s_3 < 0.0f ? upper_1a : scaled_s_1;
  const float upper_2a = -scaled_s_2, upper_2 = scaled_s_3 < 0.0f ? upper_2a : scaled_s_2;
  const float upper_3a = -scaled_s_3, upper_3 = scaled_s_3 < 0.0f ? upper_3a : scaled_s_3;
  const float v_s_size_0 = fabsf(upper_0), v_s_size_1 = fabsf(upper_1), v_s_size_2 = fabsf(upper_2);
  const float v_s_largest1 = v_s_size_0 < v_s_size_1 ? v_s_size_1 : v_s_size_0;
  const float v_s_largest2 = v_s_largest1 < v_s_size_2 ? v_s_size_2 : v_s_largest1;
  const float v_s_b = v_s_largest2 < 256.0f ? 1.8014399e+16f : 1.0f,
      v_s = v_s_largest2 < 1.4210855e-14f ? 3.2451855e+32f : v_s_b;
  const float v_y_0 = KSL_MULF(upper_0, v_s), v_y_1 = KSL_MULF(upper_1, v_s),
      v_y_2 = KSL_MULF(upper_2, v_s);
  const float v_n = sqrtf(KSL_MULF(v_y_0, v_y_0) + KSL_MULF(v_y_1, v_y_1) + KSL_MULF(v_y_2, v_y_2));
  const float v_r_b = 1.0f < v_s ? 5.551115e-17f : 1.0f,
      v_r = 1.8014399e+16f < v_s ? 3.081488e-33f : v_r_b;
  const float n = KSL_MULF(v_n, v_r);
  const float half = ksl_atan2f(n, upper_3);
  const float divisor = v_n == 0.0f ? 1.0f : v_n;
  const float unit_0 = v_y_0 / divisor, unit_1 = v_y_1 / divisor, unit_2 = v_y_2 / divisor;
  const float angle = KSL_MULF(2.0f, half);
  const float axis_0 = v_n == 0.0f ? 1.0f : unit_0;
  axis->x = axis_0;
  axis->y = unit_1;
  axis->z = unit_2;
  return angle;
}

/* qo = exp (v/2; 0) = (v/θ sin θ/2; cos θ/2), θ = |v|: turns by the rotation vector v.
   v: vector; qo: quaternion (x, y, z, w), the scalar last.
   65 mul, 80 add, 2 div, 1 sqrt, 5 abs, 2 less, 6 select.
   Error <= qo: (7 + θ/200) u of its largest component for |v| <= 1e13, in single precision 1e5;
     searched, not proved. */
static inline void ksl_quaternionf_exp(const ksl_vec3f_t *v, ksl_quaternionf_t *qo) {
  const float h_0 = KSL_MULF(0.5f, v->x), h_1 = KSL_MULF(0.5f, v->y), h_2 = KSL_MULF(0.5f, v->z);
  const float size_0 = fabsf(h_0), size_1 = fabsf(h_1), size_2 = fabsf(h_2);
  const float sizes = size_0 + size_1 + size_2;
  const float grid = KSL_MULF(sizes, 8192.0f);
  const float shifted_0 = h_0 + grid, shifted_1 = h_1 + grid, shifted_2 = h_2 + grid;
  const float high_0 = shifted_0 - grid, high_1 = shifted_1 - grid, high_2 = shifted_2 - grid;
  const float low_0 = h_0 - high_0, low_1 = h_1 - high_1, low_2 = h_2 - high_2;
  const float sum_0 = h_0 + high_0, sum_1 = h_1 + high_1, sum_2 = h_2 + high_2;
  const float squares = KSL_MULF(high_0, high_0) + KSL_MULF(high_1, high_1)
          + KSL_MULF(high_2, high_2);
  const float cross = KSL_MULF(low_0, sum_0) + KSL_MULF(low_1, sum_1) + KSL_MULF(low_2, sum_2);
  const float x = squares + cross;
  const float theta_a = sqrtf(x), theta = x < 1.0f ? 1.0f : theta_a;
  const float theta_shifted = grid + theta;
  const float theta_high = theta_shifted - grid;
  const float theta_low = theta - theta_high;
  const float theta_sum = theta + theta_high;
  const float cross_rest = cross - KSL_MULF(theta_low, theta_sum);
  const float exact = squares - KSL_MULF(theta_high, theta_high);
  const float residual = cross_rest + exact;
  const float small = KSL_MULF(0.5f, residual) / theta;
  const float delta = fabsf(small) < 0.0078125f ? small : 0.0f;
  float far_cosine_a; const float far_sine_a = ksl_sincosf(theta, &far_cosine_a);
  const float far_sine = x < 1.0f ? 1.0f : far_sine_a;
  const float far_cosine = x < 1.0f ? 0.0f : far_cosine_a;
  const float sine = KSL_MULF(delta, far_cosine) + far_sine;
  const float cosine = far_cosine - KSL_MULF(delta, far_sine);
  const float far_k = sine / theta;
  const float k_h = KSL_MULF(x, KSL_MULF(x, KSL_MULF(x, KSL_MULF(6.4469503e-26f, x)
          - 3.8681703e-23f) + 1.9572942e-20f) - 8.220635e-18f) + 2.8114574e-15f,
      k_q = KSL_MULF(x, KSL_MULF(x, KSL_MULF(x, KSL_MULF(x, KSL_MULF(x, k_h) - 7.6471636e-13f)
          + 1.6059044e-10f) - 2.5052108e-08f) + 2.7557319e-06f),
      k_x = KSL_MULF(x, KSL_MULF(x, KSL_MULF(x, k_q - 0.0001984127f) + 0.008333334f) - 0.16666667f)
          + 1.0f, k = x < 1.0f ? k_x : far_k;
  const float g2h = KSL_MULF(x, KSL_MULF(x, KSL_MULF(x, KSL_MULF(2.4795963e-27f, x)
          - 1.6117376e-24f) + 8.896791e-22f) - 4.1103176e-19f) + 1.5619207e-16f,
      g2q = KSL_MULF(x, KSL_MULF(x, KSL_MULF(x, KSL_MULF(x, KSL_MULF(x, g2h) - 4.7794773e-14f)
          + 1.1470745e-11f) - 2.0876756e-09f) + 2.755732e-07f),
      g2 = KSL_MULF(x, KSL_MULF(x, KSL_MULF(x, g2q - 2.4801588e-05f) + 0.0013888889f)
          - 0.041666668f) + 0.5f;
  const float near = 1.0f - KSL_MULF(x, g2);
  const float qo_0 = KSL_MULF(h_0, k), qo_1 = KSL_MULF(h_1, k), qo_2 = KSL_MULF(h_2, k),
      qo_3 = x < 1.0f ? near : cosine;
  qo->x = qo_0;
  qo->y = qo_1;
  qo->z = qo_2;
  qo->w = qo_3;
}

/* vo = θ v/|v|, θ = 2 atan2(|v|, |w|) <= π: the rotation vector of q, or of any multiple of it.
   q: quaternion (x, y, z, w), the scalar last; vo: vector.
   37 mul, 31 add, 2 div, 1 sqrt, 5 neg, 9 abs, 2 copysign, 19 less, 2 equal, 31 select.
   Error <= vo: 6 u of its largest component; searched, not proved. */
static inline void ksl_quaternionf_log(const ksl_quaternionf_t *q, ksl_vec3f_t *vo) {
  const float s_size_0 = fabsf(q->x), s_size_1 = fabsf(q->y), s_size_2 = fabsf(q->z),
      s_size_3 = fabsf(q->w);
  const float s_largest1 = s_size_0 < s_size_1 ? s_size_1 : s_size_0;
  const float s_largest2 = s_largest1 < s_size_2 ? s_size_2 : s_largest1;
  const float s_largest3 = s_largest2 < s_size_3 ? s_size_3 : s_largest2;
  const float s_b = 4.611686e+18f < s_largest3 ? 2.7105054e-20f : 1.0f,
      s_d = s_largest3 < 256.0f ? 1.8014399e+16f : s_b,
      s = s_largest3 < 1.4210855e-14f ? 3.2451855e+32f : s_d;
  const float scaled_s_0 = KSL_MULF(q->x, s), scaled_s_1 = KSL_MULF(q->y, s),
      scaled_s_2 = KSL_MULF(q->z, s), scaled_s_3 = KSL_MULF(q->w, s);
  const float upper_0a = -scaled_s_0, upper_0 = scaled_s_3 < 0.0f ? upper_0a : scaled_s_0;
  const float upper_1a = -scaled_s_1, upper_1 = scaled_s_3 < 0.0f ? upper_1a : scaled_s_1;
  const float upper_2a = -scaled_s_2, upper_2 = scaled_s_3 < 0.0f ? upper_2a : scaled_s_2;
  const float upper_3a = -scaled_s_3, upper_3 = scaled_s_3 < 0.0f ? upper_3a : scaled_s_3;
  const float v_s_size_0 = fabsf(upper_0), v_s_size_1 = fabsf(upper_1), v_s_size_2 = fabsf(upper_2);
  const float v_s_largest1 = v_s_size_0 < v_s_size_1 ? v_s_size_1 : v_s_size_0;
  const float v_s_largest2 = v_s_largest1 < v_s_size_2 ? v_s_size_2 : v_s_largest1;
  const float v_s_b = v_s_largest2 < 256.0f ? 1.8014399e+16f : 1.0f,
      v_s = v_s_largest2 < 1.4210855e-14f ? 3.2451855e+32f : v_s_b;
  const float v_y_0 = KSL_MULF(upper_0, v_s), v_y_1 = KSL_MULF(upper_1, v_s),
      v_y_2 = KSL_MULF(upper_2, v_s);
  const float v_n = sqrtf(KSL_MULF(v_y_0, v_y_0) + KSL_MULF(v_y_1, v_y_1) + KSL_MULF(v_y_2, v_y_2));
  const float v_r_b = 1.0f < v_s ? 5.551115e-17f : 1.0f,
      v_r = 1.8014399e+16f < v_s ? 3.081488e-33f : v_r_b;
  const float n = KSL_MULF(v_n, v_r);
  const float half = ksl_atan2f(n, upper_3);
  const float divisor = n == 0.0f ? 1.0f : n;
  const float theta = KSL_MULF(2.0f, half);
  const float k = theta / divisor;
  const float vector_0 = KSL_MULF(upper_0, k), vector_1 = KSL_MULF(upper_1, k),
      vector_2 = KSL_MULF(upper_2, k);
  vo->x = vector_0;
  vo->y = vector_1;
  vo->z = vector_2;
}

/* qo = q1 (q1* q2)^k along the shorter arc: q1 at k = 0, ±q2 at k = 1; |q1| = |q2| = 1.
   q1, q2, qo: quaternion (x, y, z, w), the scalar last; k: number.
   129 mul, 135 add, 4 div, 2 sqrt, 5 neg, 10 abs, 2 copysign, 17 less, 2 equal, 33 select.
   Error <= qo: 16 u of its largest component for |q1| = 1 and |q2| = 1 and 0 <= k <= 1;
     searched, not proved. */
static inline void ksl_quaternionf_interpolated(const ksl_quaternionf_t *q1,
    const ksl_quaternionf_t *q2, const float k, ksl_quaternionf_t *qo) {
  const float between_0 = KSL_MULF(q1->w, q2->x) - KSL_MULF(q1->x, q2->w)
          + (KSL_MULF(q1->z, q2->y) - KSL_MULF(q1->y, q2->z)),
      between_1 = KSL_MULF(q1->x, q2->z) - KSL_MULF(q1->z, q2->x)
          + (KSL_MULF(q1->w, q2->y) - KSL_MULF(q1->y, q2->w)),
      between_2 = KSL_MULF(q1->y, q2->x) - KSL_MULF(q1->x, q2->y)
          + (KSL_MULF(q1->w, q2->z) - KSL_MULF(q1->z, q2->w)),
      between_3 = KSL_MULF(q1->x, q2->x) + KSL_MULF(q1->y, q2->y) + KSL_MULF(q1->z, q2->z)
          + KSL_MULF(q1->w, q2->w);
  const float upper_0a = -between_0, upper_0 = between_3 < 0.0f ? upper_0a : between_0;
  const float upper_1a = -between_1, upper_1 = between_3 < 0.0f ? upper_1a : between_1;
  const float upper_2a = -between_2, upper_2 = between_3 < 0.0f ? upper_2a : between_2;
  const float upper_3a = -between_3, upper_3 = between_3 < 0.0f ? upper_3a : between_3;
  const float v_s_size_0 = fabsf(upper_0), v_s_size_1 = fabsf(upper_1), v_s_size_2 = fabsf(upper_2);
  const float v_s_largest1 = v_s_size_0 < v_s_size_1 ? v_s_size_1 : v_s_size_0;
  const float v_s_largest2 = v_s_largest1 < v_s_size_2 ? v_s_size_2 : v_s_largest1;
  const float v_s_b = 4.611686e+18f < v_s_largest2 ? 2.7105054e-20f : 1.0f,
      v_s_d = v_s_largest2 < 256.0f ? 1.8014399e+16f : v_s_b,
      v_s = v_s_largest2 < 1.4210855e-14f ? 3.2451855e+32f : v_s_d;
  const float v_y_0 = KSL_MULF(upper_0, v_s), v_y_1 = KSL_MULF(upper_1, v_s),
      v_y_2 = KSL_MULF(upper_2, v_s);
  const float v_n = sqrtf(KSL_MULF(v_y_0, v_y_0) + KSL_MULF(v_y_1, v_y_1) + KSL_MULF(v_y_2, v_y_2));
  const float v_r_b = v_s < 1.0f ? 3.689349e+19f : 1.0f, v_r_d = 1.0f < v_s ? 5.551115e-17f : v_r_b,
      v_r = 1.8014399e+16f < v_s ? 3.081488e-33f : v_r_d;
  const float n = KSL_MULF(v_n, v_r);
  const float half = ksl_atan2f(n, upper_3);
  const float divisor = n == 0.0f ? 1.0f : n;
  const float rate = half / divisor;
  const float kv_0 = KSL_MULF(k, upper_0), kv_1 = KSL_MULF(k, upper_1), kv_2 = KSL_MULF(k, upper_2);
  const float step_0 = KSL_MULF(rate, kv_0), step_1 = KSL_MULF(rate, kv_1),
      step_2 = KSL_MULF(rate, kv_2);
  const float exp_size_0 = fabsf(step_0), exp_size_1 = fabsf(step_1), exp_size_2 = fabsf(step_2);
  const float exp_sizes = exp_size_0 + exp_size_1 + exp_size_2;
  const float exp_grid = KSL_MULF(exp_sizes, 8192.0f);
  const float exp_shifted_0 = step_0 + exp_grid, exp_shifted_1 = step_1 + exp_grid,
      exp_shifted_2 = step_2 + exp_grid;
  const float exp_high_0 = exp_shifted_0 - exp_grid, exp_high_1 = exp_shifted_1 - exp_grid,
      exp_high_2 = exp_shifted_2 - exp_grid;
  const float exp_low_0 = step_0 - exp_high_0, exp_low_1 = step_1 - exp_high_1,
      exp_low_2 = step_2 - exp_high_2;
  const float exp_sum_0 = step_0 + exp_high_0, exp_sum_1 = step_1 + exp_high_1,
      exp_sum_2 = step_2 + exp_high_2;
  const float exp_squares = KSL_MULF(exp_high_0, exp_high_0) + KSL_MULF(exp_high_1, exp_high_1)
          + KSL_MULF(exp_high_2, exp_high_2);
  const float exp_cross = KSL_MULF(exp_low_0, exp_sum_0) + KSL_MULF(exp_low_1, exp_sum_1)
          + KSL_MULF(exp_low_2, exp_sum_2);
  const float exp_x = exp_squares + exp_cross;
  const float exp_theta_a = sqrtf(exp_x), exp_theta = exp_x < 1.0f ? 1.0f : exp_theta_a;
  const float exp_theta_shifted = exp_grid + exp_theta;
  const float exp_theta_high = exp_theta_shifted - exp_grid;
  const float exp_theta_low = exp_theta - exp_theta_high;
  const float exp_theta_sum = exp_theta + exp_theta_high;
  const float exp_cross_rest = exp_cross - KSL_MULF(exp_theta_low, exp_theta_sum);
  const float exp_exact = exp_squares - KSL_MULF(exp_theta_high, exp_theta_high);
  const float exp_residual = exp_cross_rest + exp_exact;
  const float exp_small = KSL_MULF(0.5f, exp_residual) / exp_theta;
  const float exp_delta = fabsf(exp_small) < 0.0078125f ? exp_small : 0.0f;
  float exp_far_cosine_a; const float exp_far_sine_a = ksl_sincosf(exp_theta, &exp_far_cosine_a);
  const float exp_far_sine = exp_x < 1.0f ? 1.0f : exp_far_sine_a;
  const float exp_far_cosine = exp_x < 1.0f ? 0.0f : exp_far_cosine_a;
  const float exp_sine = KSL_MULF(exp_delta, exp_far_cosine) + exp_far_sine;
  const float exp_cosine = exp_far_cosine - KSL_MULF(exp_delta, exp_far_sine);
  const float exp_far_k = exp_sine / exp_theta;
  const float exp_k_g = KSL_MULF(exp_x, KSL_MULF(exp_x, KSL_MULF(exp_x, KSL_MULF(6.4469503e-26f,
      exp_x) - 3.8681703e-23f) + 1.9572942e-20f) - 8.220635e-18f),
      exp_k_n = KSL_MULF(exp_x, KSL_MULF(exp_x, KSL_MULF(exp_x, exp_k_g + 2.8114574e-15f)
          - 7.6471636e-13f) + 1.6059044e-10f) - 2.5052108e-08f,
      exp_k_v = KSL_MULF(exp_x, KSL_MULF(exp_x, KSL_MULF(exp_x, KSL_MULF(exp_x, exp_k_n)
          + 2.7557319e-06f) - 0.0001984127f) + 0.008333334f) - 0.16666667f,
      exp_k_x = KSL_MULF(exp_x, exp_k_v) + 1.0f, exp_k = exp_x < 1.0f ? exp_k_x : exp_far_k;
  const float exp_g2g = KSL_MULF(exp_x, KSL_MULF(exp_x, KSL_MULF(exp_x, KSL_MULF(2.4795963e-27f,
      exp_x) - 1.6117376e-24f) + 8.896791e-22f) - 4.1103176e-19f),
      exp_g2n = KSL_MULF(exp_x, KSL_MULF(exp_x, KSL_MULF(exp_x, exp_g2g + 1.5619207e-16f)
          - 4.7794773e-14f) + 1.1470745e-11f) - 2.0876756e-09f,
      exp_g2v = KSL_MULF(exp_x, KSL_MULF(exp_x, KSL_MULF(exp_x, KSL_MULF(exp_x, exp_g2n)
          + 2.755732e-07f) - 2.4801588e-05f) + 0.0013888889f) - 0.041666668f,
      exp_g2 = KSL_MULF(exp_x, exp_g2v) + 0.5f;
  const float exp_near = 1.0f - KSL_MULF(exp_x, exp_g2);
  const float power_0 = KSL_MULF(step_0, exp_k), power_1 = KSL_MULF(step_1, exp_k),
      power_2 = KSL_MULF(step_2, exp_k), power_3 = exp_x < 1.0f ? exp_near : exp_cosine;
  const float qo_0 = KSL_MULF(q1->x, power_3)
          + (KSL_MULF(q1->y, power_2) - KSL_MULF(q1->z, power_1)) + KSL_MULF(q1->w, power_0),
      qo_1 = KSL_MULF(q1->z, power_0) - KSL_MULF(q1->x, power_2) + KSL_MULF(q1->y, power_3)
          + KSL_MULF(q1->w, power_1),
      qo_2 = KSL_MULF(q1->x, power_1) - KSL_MULF(q1->y, power_0) + KSL_MULF(q1->z, power_3)
          + KSL_MULF(q1->w, power_2),
      qo_3 = KSL_MULF(q1->w, power_3)
          - (KSL_MULF(q1->x, power_0) + KSL_MULF(q1->y, power_1) + KSL_MULF(q1->z, power_2));
  qo->x = qo_0;
  qo->y = qo_1;
  qo->z = qo_2;
  qo->w = qo_3;
}

#ifndef KSL_NO_ALLOC
#include <stdlib.h>

/* n ksl_quaternion_t on the heap, identities, to be freed by the caller; NULL for n <= 0 or when
     there is no memory. */
static inline ksl_quaternion_t *ksl_quaternion_alloc(int n) {
  ksl_quaternion_t *const all =
      n > 0 ? (ksl_quaternion_t *)calloc((size_t)n, sizeof(ksl_quaternion_t)) : NULL;
  for (int i = 0; all && i < n; i++) {
    all[i].w = 1.0;
  }
  return all;
}

/* n ksl_quaternionf_t on the heap, identities, to be freed by the caller; NULL for n <= 0 or
     when there is no memory. */
static inline ksl_quaternionf_t *ksl_quaternionf_alloc(int n) {
  ksl_quaternionf_t *const all =
      n > 0 ? (ksl_quaternionf_t *)calloc((size_t)n, sizeof(ksl_quaternionf_t)) : NULL;
  for (int i = 0; all && i < n; i++) {
    all[i].w = 1.0f;
  }
  return all;
}

#endif

/* What KSL declares beside formulas. */


/* Whether |q| = 1: the size of its ksl_quaternion_unit_defect is at most 0.001. */
static inline bool ksl_quaternion_is_unit(const ksl_quaternion_t *q) {
  const double defect = ksl_quaternion_unit_defect(q);
  return -0.001 <= defect && defect <= 0.001;
}

/* The same as ksl_quaternion_from_mat3x3. */
static inline void ksl_mat3x3_toQuaternion(const ksl_mat3x3_t *ri,
    ksl_quaternion_t *qo) {
  ksl_quaternion_from_mat3x3(ri, qo);
}

/* Normalizes qi, and sets ro to its rotation: qi = qi / |qi|, ro = R(qi). */
static inline void ksl_quaternion_toMat3x3(ksl_quaternion_t *qi,
    ksl_mat3x3_t *ro) {
  ksl_quaternion_normalize(qi);
  ksl_mat3x3_from_quaternion(qi, ro);
}

/* qo = q1i (q1i* q2i)^t along the arc from q1i to q2i, which is the longer one where q1i·q2i < 0: q1i
     at t = 0, q2i at t = 1.  |q1i| = |q2i| = 1; undefined for q2i = -q1i.
     ksl_quaternion_interpolated takes the shorter arc. */
static inline void ksl_quaternion_slerp(const ksl_quaternion_t *q1i,
    const ksl_quaternion_t *q2i, double *t, ksl_quaternion_t *qo) {
  const double k = *t, twice = KSL_MUL(2, k);
  if (ksl_dot_qq(q1i, q2i) >= 0) {
    ksl_quaternion_interpolated(q1i, q2i, k, qo);
  } else { /* through the middle: either half is the shorter arc */
    ksl_quaternion_t middle = *q2i;
    ksl_axpy_qq(1.0, q1i, &middle);
    ksl_quaternion_normalize(&middle);
    { /* near -q1i the rounding of the middle could make a half the longer arc.  A margin of 16 u
         suffices: two dot products have errors of 4 u each, the sum of 2 u. */
      const ksl_quaternion_t *end = twice <= 1 ? q1i : q2i;
      const double short_of = 1.7763568394002505e-15 - ksl_dot_qq(end, &middle);
      if (short_of > 0) {
        ksl_axpy_qq(short_of, end, &middle);
      }
    }
    if (twice <= 1) {
      ksl_quaternion_interpolated(q1i, &middle, twice, qo);
    } else {
      ksl_quaternion_interpolated(&middle, q2i, twice - 1, qo);
    }
  }
}

/* qo = slerp(slerp(qi[0], qi[3], t), slerp(qi[1], qi[2], t), 2 t (1 - t)): Shoemake's curve from qi[0]
     to qi[3] with the inner control points qi[1], qi[2]; all of norm 1. */
static inline void ksl_quaternion_squad(
    ksl_quaternion_t qi[4], double *t, ksl_quaternion_t *qo) {
  ksl_quaternion_t ends, inner;
  const double rest = 1 - *t, twice = KSL_MUL(2, *t);
  double k = KSL_MUL(twice, rest);
  ksl_quaternion_slerp(&qi[0], &qi[3], t, &ends);
  ksl_quaternion_slerp(&qi[1], &qi[2], t, &inner);
  ksl_quaternion_slerp(&ends, &inner, &k, qo);
}

/* qo = (1 - t) q1i ± t q2i along the shorter arc, normalized; q1i where t < 1e-9, q2i where t >= 1. */
static inline void ksl_quaternion_nlerp(
    const ksl_quaternion_t *q1i, const ksl_quaternion_t *q2i, const double *t,
    ksl_quaternion_t *qo) {
  const double k = *t, towards = ksl_dot_qq(q1i, q2i) < 0 ? -k : k;
  ksl_quaternion_t o = k >= 1 ? *q2i : *q1i;
  if (k >= 1e-9 && k < 1) {
    ksl_quaternion_scale(&o, 1 - k);
    ksl_axpy_qq(towards, q2i, &o);
    ksl_quaternion_normalize(&o);
  }
  *qo = o;
}

/* qo = q1i^-1 q2i, q1i^-1 = q1i* / q1i·q1i, for any nonzero q1i whose square neither overflows nor
     underflows. */
static inline void ksl_quaternion_product_uqinverseq(
    ksl_quaternion_t *q1i, ksl_quaternion_t *q2i, ksl_quaternion_t *qo) {
  const double square = ksl_dot_qq(q1i, q1i);
  ksl_quaternion_product_qconjq(q1i, q2i, qo);
  ksl_quaternion_scale(qo, 1 / square);
}

/* Whether |q| = 1: the size of its ksl_quaternionf_unit_defect is at most 0.001f. */
static inline bool ksl_quaternionf_is_unit(const ksl_quaternionf_t *q) {
  const float defect = ksl_quaternionf_unit_defect(q);
  return -0.001f <= defect && defect <= 0.001f;
}

/* The same as ksl_quaternionf_from_mat3x3. */
static inline void ksl_mat3x3f_toQuaternion(const ksl_mat3x3f_t *ri,
    ksl_quaternionf_t *qo) {
  ksl_quaternionf_from_mat3x3(ri, qo);
}

/* Normalizes qi, and sets ro to its rotation: qi = qi / |qi|, ro = R(qi). */
static inline void ksl_quaternionf_toMat3x3f(ksl_quaternionf_t *qi,
    ksl_mat3x3f_t *ro) {
  ksl_quaternionf_normalize(qi);
  ksl_mat3x3f_from_quaternion(qi, ro);
}

/* qo = q1i (q1i* q2i)^t along the arc from q1i to q2i, which is the longer one where q1i·q2i < 0: q1i
     at t = 0, q2i at t = 1.  |q1i| = |q2i| = 1; undefined for q2i = -q1i.
     ksl_quaternionf_interpolated takes the shorter arc. */
static inline void ksl_slerpf(const ksl_quaternionf_t *q1i,
    const ksl_quaternionf_t *q2i, float *t, ksl_quaternionf_t *qo) {
  const float k = *t, twice = KSL_MULF(2, k);
  if (ksl_dot_qqf(q1i, q2i) >= 0) {
    ksl_quaternionf_interpolated(q1i, q2i, k, qo);
  } else { /* through the middle: either half is the shorter arc */
    ksl_quaternionf_t middle = *q2i;
    ksl_axpy_qqf(1.0f, q1i, &middle);
    ksl_quaternionf_normalize(&middle);
    { /* near -q1i the rounding of the middle could make a half the longer arc.  A margin of 16 u
         suffices: two dot products have errors of 4 u each, the sum of 2 u. */
      const ksl_quaternionf_t *end = twice <= 1 ? q1i : q2i;
      const float short_of = 9.536743e-07f - ksl_dot_qqf(end, &middle);
      if (short_of > 0) {
        ksl_axpy_qqf(short_of, end, &middle);
      }
    }
    if (twice <= 1) {
      ksl_quaternionf_interpolated(q1i, &middle, twice, qo);
    } else {
      ksl_quaternionf_interpolated(&middle, q2i, twice - 1, qo);
    }
  }
}

/* qo = slerp(slerp(qi[0], qi[3], t), slerp(qi[1], qi[2], t), 2 t (1 - t)): Shoemake's curve from qi[0]
     to qi[3] with the inner control points qi[1], qi[2]; all of norm 1. */
static inline void ksl_squadf(
    ksl_quaternionf_t qi[4], float *t, ksl_quaternionf_t *qo) {
  ksl_quaternionf_t ends, inner;
  const float rest = 1 - *t, twice = KSL_MULF(2, *t);
  float k = KSL_MULF(twice, rest);
  ksl_slerpf(&qi[0], &qi[3], t, &ends);
  ksl_slerpf(&qi[1], &qi[2], t, &inner);
  ksl_slerpf(&ends, &inner, &k, qo);
}

/* qo = (1 - t) q1i ± t q2i along the shorter arc, normalized; q1i where t < 1e-9, q2i where t >= 1. */
static inline void ksl_nlerpf(
    const ksl_quaternionf_t *q1i, const ksl_quaternionf_t *q2i, const float *t,
    ksl_quaternionf_t *qo) {
  const float k = *t, towards = ksl_dot_qqf(q1i, q2i) < 0 ? -k : k;
  ksl_quaternionf_t o = k >= 1 ? *q2i : *q1i;
  if (k >= 1e-9f && k < 1) {
    ksl_quaternionf_scale(&o, 1 - k);
    ksl_axpy_qqf(towards, q2i, &o);
    ksl_quaternionf_normalize(&o);
  }
  *qo = o;
}

/* qo = q1i^-1 q2i, q1i^-1 = q1i* / q1i·q1i, for any nonzero q1i whose square neither overflows nor
     underflows. */
static inline void ksl_product_uqinverseqf(
    ksl_quaternionf_t *q1i, ksl_quaternionf_t *q2i, ksl_quaternionf_t *qo) {
  const float square = ksl_dot_qqf(q1i, q1i);
  ksl_product_qconjqf(q1i, q2i, qo);
  ksl_quaternionf_scale(qo, 1 / square);
}

#endif
